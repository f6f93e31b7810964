// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "straightedge/depth_view.hpp"
#include "straightedge/host/image.hpp"
#include "straightedge/host/pose.hpp"

namespace bench {

struct FixtureFrame {
  straightedge::Image<std::uint16_t> raw;
  double metres_per_unit = 0;
  straightedge::PinholeCamera camera;
  straightedge::Pose world_from_camera;

  straightedge::DepthView depth() const { return {raw.view(), metres_per_unit, camera}; }
};

/// The frames of fixtures/depth/room, which have poses, and the one of fixtures/depth/mrpt_office, whose
/// camera stands at the origin. Ends the program when they cannot be read.
std::vector<FixtureFrame> room_frames();
std::vector<FixtureFrame> office_frames();

}  // namespace bench
