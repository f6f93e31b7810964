// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "straightedge/host/depth_sequence.hpp"
#include "straightedge/host/result.hpp"

namespace straightedge::cli {

/// A file of a folder: its name, which may have a subfolder in it, and its content.
struct FolderFile {
  std::filesystem::path name;
  std::string bytes;
};

/// The name of a frame's label picture.
std::string label_name(const SequenceFrame& frame);

/// Before any work: `bad_option` when labels would replace frames or each other, `cannot_write` when the
/// folder is none or closed.
Result<Done> check_label_folder(const std::filesystem::path& folder,
                                const std::vector<SequenceFrame>& frames);

/// A folder that was not there before appears with all of its files at once; into one that was there each
/// file is written whole, and other files in it stay.
Result<Done> write_folder(const std::filesystem::path& folder, const std::vector<FolderFile>& files);

}  // namespace straightedge::cli
