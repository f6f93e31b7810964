// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace project {

/// A place where the source tree does not keep a rule of its own.
struct Breach {
  std::string file;  ///< relative to the root
  std::size_t line = 0;
  std::string sentence;
};

/// Who may include whom: modules, standard headers of the core, and other people's libraries.
std::vector<Breach> include_breaches(const std::filesystem::path& root);

/// Licence lines, lengths of files and functions, marks of unfinished work.
std::vector<Breach> shape_breaches(const std::filesystem::path& root);

/// What both need: the files of one ending below root/folder, sorted, and the lines of one.
std::vector<std::filesystem::path> files_below(const std::filesystem::path& folder,
                                               const std::vector<std::string>& endings);
std::vector<std::string> lines_of(const std::filesystem::path& file);

}  // namespace project
