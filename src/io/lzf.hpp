// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <string_view>

namespace straightedge::io {

/// The most bytes that one compressed byte can stand for: three of them give at most 264.
inline constexpr std::size_t lzf_largest_ratio = 88;

/// Undoes LZF, the compression of PCD files. A control byte c below 32 is followed by c + 1 bytes to
/// take as they are. From 32 on, its upper three bits tell how many bytes are repeated (+ 2; with 7, one more
/// byte is added), its lower five and another byte from how far back (+ 1).
/// False when the input does not give exactly `output.size()` bytes or points before the output's start.
bool lzf_decompress(std::string_view input, std::span<char> output);

}  // namespace straightedge::io
