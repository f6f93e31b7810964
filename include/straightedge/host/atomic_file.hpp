// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string_view>

#include "straightedge/host/result.hpp"

namespace straightedge {

/// Writes a whole file or nothing. The bytes go to a hidden file in the same folder, which is then renamed
/// to `file`; on failure it is removed and an older `file` stays as it was. SIGINT, SIGTERM and SIGHUP
/// wait, in the calling thread, until this is over.
///
/// A symbolic link is followed. What is not a regular file (/dev/stdout, a pipe) is written directly.
///
/// Fails with `Problem::cannot_write` and one sentence: the file's name and the system's reason.
Result<Done> write_file_atomically(const std::filesystem::path& file, std::string_view bytes);

}  // namespace straightedge
