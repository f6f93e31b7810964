// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "straightedge/host/image.hpp"
#include "straightedge/host/result.hpp"

namespace straightedge::io {

/// Begins like a PGM or PPM file (P2, P3, P5, P6).
bool is_netpbm(std::string_view bytes) noexcept;

/// A PGM or PPM file as 8-bit gray. Read here and not by stb, which swaps the bytes of 16-bit values.
/// Values are scaled from the file's maximum to 255, rounded; of 16-bit values with the maximum 65535
/// the upper byte is kept.
Result<Image<std::uint8_t>> decode_netpbm(std::string_view bytes, const std::string& name);

/// A 16-bit PGM file (a maximum above 255) with its values as they are. Colour and 8 bits are refused.
Result<Image<std::uint16_t>> decode_netpbm16(std::string_view bytes, const std::string& name);

}  // namespace straightedge::io
