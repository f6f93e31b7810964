// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include "straightedge/vector3.hpp"

namespace straightedge {

/// Points in somebody else's memory, metres. One stride serves arrays of structs (x, y, z point into
/// the first struct, stride its size) and three arrays (stride sizeof(float)). A point with a
/// coordinate that is not finite is no reading. Organised clouds say their width: point i is column i % width
/// of row i / width, as in the sensor's picture.
struct PointsView {
  const float* x = nullptr;
  const float* y = nullptr;
  const float* z = nullptr;
  std::size_t count = 0;
  std::ptrdiff_t stride = sizeof(float);  ///< bytes from one point to the next
  std::int32_t width = 0;                 ///< columns of an organised cloud; 0: no order

  Vector3 at(std::size_t i) const noexcept {
    const auto offset = static_cast<std::ptrdiff_t>(i) * stride;
    return {coordinate(x, offset), coordinate(y, offset), coordinate(z, offset)};
  }
  /// Has points, at most 2^31, and a stride that keeps floats aligned.
  constexpr bool valid() const noexcept {
    return x != nullptr && y != nullptr && z != nullptr && count > 0 && count <= (std::size_t{1} << 31U) &&
           stride >= static_cast<std::ptrdiff_t>(sizeof(float)) &&
           stride % static_cast<std::ptrdiff_t>(alignof(float)) == 0 && width >= 0 &&
           (width == 0 || count % static_cast<std::size_t>(width) == 0);
  }

 private:
  static double coordinate(const float* first, std::ptrdiff_t offset) noexcept {
    return static_cast<double>(
        *reinterpret_cast<const float*>(reinterpret_cast<const unsigned char*>(first) + offset));
  }
};

}  // namespace straightedge
