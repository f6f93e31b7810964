// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string_view>

#include "straightedge/host/image.hpp"
#include "straightedge/host/result.hpp"

namespace straightedge::cli {

/// A picture as 8-bit gray, fit for the work that follows: `bad_content` when a side is longer than the
/// library's 32767 pixels.
Result<Image<std::uint8_t>> read_picture(const std::filesystem::path& file);

/// The same from bytes in memory.
Result<Image<std::uint8_t>> decode_picture(std::string_view bytes, const std::filesystem::path& file);

/// Refuses, before the system ends the program, work that needs more memory than the machine has.
Result<Done> check_memory(const std::filesystem::path& file, std::size_t bytes);

}  // namespace straightedge::cli
