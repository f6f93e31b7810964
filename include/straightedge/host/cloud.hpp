// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
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

/// A longer file is refused before it is read.
inline constexpr std::size_t max_cloud_file_bytes = std::size_t{1} << 35;

/// PCD up to 0.7 (ascii, binary, binary_compressed) or PLY 1.0 (ascii, both byte orders), told apart by their
/// first lines. Coordinates may be any number type; other fields, lists and elements are passed over, and so
/// is what follows the points.
/// bad_content: a header that promises more than 2^31 points or more than the file holds, truncated data, a
/// line of text with too few or too many values, no x y z, a VIEWPOINT that is no rotation. Sizes are checked
/// before memory is taken. A file of no points gives none.
Result<Cloud> read_cloud(const std::filesystem::path& file);

/// The same from a file's bytes; `name` is what the sentences of failures call them.
Result<Cloud> cloud_from_bytes(std::string_view bytes, const std::string& name);

}  // namespace straightedge
