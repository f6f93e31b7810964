// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "straightedge/host/image.hpp"
#include "straightedge/host/result.hpp"

namespace straightedge::io {

/// Begins like a PNG file.
bool is_png(std::string_view bytes) noexcept;

/// A 16-bit gray PNG, interlaced or not, by libpng: its values as they are, no gamma, no scaling.
Result<Image<std::uint16_t>> decode_png16(std::string_view bytes, const std::string& name);

/// The bytes of such a file; the failure's sentence names no file.
Result<std::string> encode_png16(ImageView<const std::uint16_t> image);

}  // namespace straightedge::io
