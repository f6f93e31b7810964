// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include "straightedge/host/camera_file.hpp"
#include "straightedge/host/image.hpp"
#include "straightedge/host/result.hpp"

namespace straightedge {

/// A 16-bit gray PNG (interlaced or not), or a PGM (P2 or P5) whose maximum is above 255; values as they
/// are. Sizes are checked in the header, before anything is decoded.
/// cannot_read: cannot be opened or does not fit into memory. bad_content: an 8-bit picture, colour, a
/// palette, transparency, more than 2^28 pixels, a truncated or otherwise broken file.
Result<Image<std::uint16_t>> read_depth_image(const std::filesystem::path& file);

/// The same from bytes in memory; `name` is what the sentences of failures call them.
Result<Image<std::uint16_t>> decode_depth_image(std::string_view bytes, const std::string& name);

/// The picture of a known camera, without distortion. bad_content also: not of the camera's size.
Result<Image<std::uint16_t>> read_depth_frame(const std::filesystem::path& file, const DepthCamera& camera);

/// A 16-bit gray PNG; the same pixels give the same bytes. Written aside, then renamed.
Result<Done> write_png16(const std::filesystem::path& file, ImageView<const std::uint16_t> image);

/// The picture that the same camera without distortion would have given: every pixel takes the reading of
/// the nearest pixel of `raw` on its ray, or 0 outside, and where the lens model folds back. Empty for an
/// empty picture or a camera that is not valid.
Image<std::uint16_t> undistorted(ImageView<const std::uint16_t> raw, const DepthCamera& camera);

/// The way back, for labels: every pixel of the distorted picture takes the label of its ray. Brown's model
/// is inverted by Newton's method, 20 steps for every pixel.
Image<std::uint16_t> distorted(ImageView<const std::uint16_t> labels, const DepthCamera& camera);

}  // namespace straightedge
