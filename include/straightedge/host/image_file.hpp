// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>

#include "straightedge/host/image.hpp"
#include "straightedge/host/result.hpp"

namespace straightedge {

/// The largest image that is read: 2^28 pixels. Sizes are checked in the header, before decoding.
inline constexpr std::int64_t max_image_pixels = std::int64_t{1} << 28;

/// Any PNG, JPEG, BMP, TGA, PGM or PPM as 8-bit gray. Colour becomes gray by the core's integer weights
/// (never by the decoder's), alpha is ignored, 16-bit values keep their upper byte.
Result<Image<std::uint8_t>> read_gray_image(const std::filesystem::path& file);

Result<Done> write_png(const std::filesystem::path& file, GrayView image);
Result<Done> write_png(const std::filesystem::path& file, ImageView<const Rgb> image);

}  // namespace straightedge
