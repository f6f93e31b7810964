// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

#include "straightedge/host/result.hpp"

namespace straightedge::io {

/// The whole file. One longer than `max_bytes` is refused as `bad_content`, what cannot be opened or
/// read as `cannot_read` with the system's reason.
Result<std::string> read_bytes(const std::filesystem::path& file, std::size_t max_bytes);

}  // namespace straightedge::io
