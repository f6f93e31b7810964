// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "straightedge/host/image.hpp"
#include "straightedge/host/result.hpp"

namespace straightedge::cli {

inline constexpr const char* page_name = "index.html";

struct NamedFile {
  std::string name;
  std::string bytes;
};

/// Encodes one picture after another; the first failure stays.
class PictureFiles {
 public:
  void add(const std::string& name, const Image<Rgb>& picture);
  Result<std::vector<NamedFile>> take();

 private:
  std::vector<NamedFile> files_;
  Failure trouble_;
};

/// Makes the folder if there is none, and writes each file whole or not at all, in order: the page comes
/// last. Pages and pictures that an older run of whatever kind left there go first. A folder that was made
/// here goes again when a file cannot be written. Fails with `cannot_write`.
Result<Done> write_folder(const std::vector<NamedFile>& files, const std::filesystem::path& directory);

}  // namespace straightedge::cli
