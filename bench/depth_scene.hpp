// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include "straightedge/depth_view.hpp"
#include "straightedge/host/image.hpp"

namespace bench {

/// A corner of a room with a table and four boxes, drawn here, as a depth camera of this size would read it:
/// 1/z with the noise of a Kinect, and holes.
struct DepthScene {
  straightedge::Image<float> inverse_depth;
  straightedge::PinholeCamera camera;
};

DepthScene make_depth_scene(straightedge::Size size);

/// The same as the camera gives it.
struct DepthFrame {
  static constexpr double metres_per_unit = 0.0002;

  straightedge::Image<std::uint16_t> raw;
  straightedge::PinholeCamera camera;

  straightedge::DepthView depth() const { return {raw.view(), metres_per_unit, camera}; }
};

DepthFrame make_depth_frame(straightedge::Size size);

}  // namespace bench
