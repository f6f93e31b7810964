// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>

#include "straightedge/host/camera_file.hpp"
#include "straightedge/host/image.hpp"
#include "straightedge/host/result.hpp"

namespace straightedge {

/// A 16-bit gray PNG, or a PGM (P2 or P5) whose maximum is above 255. An 8-bit picture, colour, a palette or
/// a truncated file is `bad_content`. The size is checked before anything is decoded.
Result<Image<std::uint16_t>> read_depth_image(const std::filesystem::path& file);

/// A 16-bit gray PNG; the same pixels give the same bytes. Written aside, then renamed.
Result<Done> write_png16(const std::filesystem::path& file, ImageView<const std::uint16_t> image);

/// The picture that the same camera without distortion would have given: every pixel takes the reading of
/// the nearest pixel of `raw` on its ray, or 0 outside.
Image<std::uint16_t> undistorted(ImageView<const std::uint16_t> raw, const DepthCamera& camera);

/// The way back, for labels: every pixel of the distorted picture takes the label of its ray.
Image<std::uint16_t> distorted(ImageView<const std::uint16_t> labels, const DepthCamera& camera);

}  // namespace straightedge
