// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "ransac/kernels/lane_sums.hpp"
#include "ransac/kernels/search_kernels.hpp"

namespace straightedge::STRAIGHTEDGE_KERNEL_SET {

SearchInliers find_inliers(const SearchReadings& readings, std::uint32_t padded, const SearchPlane& plane,
                           float most) noexcept {
  const Lanes a = all(plane.a), b = all(plane.b), c = all(plane.c), limit = all(most), none = all(0),
              one = all(1);
  float squares[search_lanes], counts[search_lanes];
  for (std::int32_t l = 0; l < search_lanes; l += lanes) {
    Lanes sum = none, count = none;
    for (std::uint32_t i = static_cast<std::uint32_t>(l); i < padded; i += search_lanes) {
      const Lanes p = (a * load(readings.u + i) + b * load(readings.v + i)) + c;
      const Lanes e = (load(readings.q + i) - p) * load(readings.w + i);
      const Lanes squared = e * e;
      sum += squared < limit ? squared : none;
      count += squared < limit ? one : none;
    }
    store(squares + l, sum);
    store(counts + l, count);
  }
  return {fold(squares), static_cast<std::uint32_t>(fold(counts))};
}

void sum_inliers(const SearchReadings& readings, std::uint32_t padded, const SearchPlane& plane, float most,
                 SearchSums& sums) noexcept {
  PartialSums partial;
  for (std::int32_t l = 0; l < search_lanes; l += lanes) {
    const Lanes a = all(plane.a), b = all(plane.b), c = all(plane.c), limit = all(most), none = all(0),
                one = all(1);
    LaneSums s;
    for (std::uint32_t i = static_cast<std::uint32_t>(l); i < padded; i += search_lanes) {
      const Lanes x = load(readings.u + i), y = load(readings.v + i), w = load(readings.w + i);
      const Lanes r = load(readings.q + i) - ((a * x + b * y) + c);
      const Lanes e = r * w;
      s.add(e * e < limit ? one : none, x, y, r, w);
    }
    s.store_to(partial, l);
  }
  sums = partial.folded();
}

}  // namespace straightedge::STRAIGHTEDGE_KERNEL_SET
