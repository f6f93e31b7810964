// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>

#include "straightedge/depth_view.hpp"
#include "straightedge/host/result.hpp"

namespace straightedge {

/// Brown's lens distortion with OpenCV's names and order. All zero: none.
struct LensDistortion {
  double k1 = 0, k2 = 0, p1 = 0, p2 = 0, k3 = 0;

  constexpr bool none() const noexcept { return k1 == 0 && k2 == 0 && p1 == 0 && p2 == 0 && k3 == 0; }
  constexpr bool operator==(const LensDistortion&) const noexcept = default;
};

/// What `camera.json` says about a depth camera.
struct DepthCamera {
  PinholeCamera pinhole;
  LensDistortion distortion;
  double units_per_metre = 1000;  ///< `depth_scale`: 5000 in TUM's sets, 1000 for millimetres
  std::optional<Size> size;       ///< when given, frames of another size are refused

  constexpr double metres_per_unit() const noexcept { return 1 / units_per_metre; }
  constexpr bool operator==(const DepthCamera&) const noexcept = default;
};

/// A JSON object `{"fx","fy","cx","cy","depth_scale","width","height"}`, the last three and `k1 k2 p1 p2 k3`
/// optional (width and height only together); Open3D's, with K column by column as `intrinsic_matrix`, in
/// place of the first four; or a text file with the 3x3 matrix K row by row. Other keys are passed over.
/// bad_content: none of these, a missing or wrong number, fx or fy zero, skew, depth_scale <= 0, a picture
/// without pixels or of more than 2^28.
Result<DepthCamera> read_camera(const std::filesystem::path& file);

}  // namespace straightedge
