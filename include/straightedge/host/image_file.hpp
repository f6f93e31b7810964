// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include "straightedge/host/image.hpp"
#include "straightedge/host/result.hpp"

namespace straightedge {

/// The largest image that is read: 2^28 pixels. Sizes are checked in the header, before decoding.
inline constexpr std::int64_t max_image_pixels = std::int64_t{1} << 28;

/// Any PNG, JPEG, BMP, TGA, PGM or PPM as 8-bit gray. Colour becomes gray by the core's integer weights
/// (never by the decoder's), alpha is ignored, 16-bit values keep their upper byte.
///
/// Fails with `cannot_read` when the file cannot be opened or read, with `bad_content` when it is empty,
/// truncated, too large or no image of these kinds.
Result<Image<std::uint8_t>> read_gray_image(const std::filesystem::path& file);

/// The same from bytes in memory; `name` is what the sentences of failures call them.
Result<Image<std::uint8_t>> decode_gray_image(std::string_view bytes, const std::string& name);

/// PNG, 8 bits a channel, written whole or not at all (atomic_file.hpp). The same image gives the same bytes.
Result<Done> write_png(const std::filesystem::path& file, GrayView image);
Result<Done> write_png(const std::filesystem::path& file, ImageView<const Rgb> image);

/// The bytes of such a file.
Result<std::string> encode_png(GrayView image);
Result<std::string> encode_png(ImageView<const Rgb> image);

}  // namespace straightedge
