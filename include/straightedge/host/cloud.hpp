// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "straightedge/host/pose.hpp"
#include "straightedge/host/result.hpp"
#include "straightedge/points_view.hpp"

namespace straightedge {

/// Points as a PCD or PLY file holds them, in the file's order, readings that are not finite included.
struct Cloud {
  std::vector<float> x, y, z;
  std::int32_t width = 0;  ///< columns of an organised cloud; 0: no order
  Pose viewpoint;          ///< PCD's VIEWPOINT; identity elsewhere

  PointsView view() const noexcept {
    PointsView points;
    points.x = x.data();
    points.y = y.data();
    points.z = z.data();
    points.count = x.size();
    points.width = width;
    return points;
  }
};

/// PCD 0.6/0.7 (ascii, binary, binary_compressed) or PLY 1.0 (ascii, both byte orders), told apart by their
/// first bytes. Coordinates may be any number type; other fields, lists and elements are passed over.
/// bad_content: a header that promises more than 2^31 points or more than the file holds, truncated data, no
/// x y z. Sizes are checked before memory is taken.
Result<Cloud> read_cloud(const std::filesystem::path& file);

}  // namespace straightedge
