// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "ransac/verify.hpp"

#include "ransac/frame_block.hpp"

namespace straightedge::ransac {
namespace {

/// Calls visit(block, a, c, labels) for all blocks of the frame, the plane being 1/z = a u + c in the block
/// with u counted from its first column.
template <class Labels, class Visit>
void for_each_block(const Readings& readings, Labels labels, const LinearPlane& plane, Visit visit) noexcept {
  std::size_t first = 0;
  for (std::int32_t v = 0; v < readings.frame.height; ++v) {
    for (std::int32_t u = 0; u < readings.frame.width; u += FrameBlock::capacity) {
      const FrameBlock block(readings, u, v);
      const double c = -(plane.x * u + plane.y * v + plane.w);
      visit(block, static_cast<float>(-plane.x), static_cast<float>(c), &labels[first]);
      first += static_cast<std::size_t>(block.count);
    }
  }
}

/// Residual moments over one block, moved to pixel (0, 0), with v and the plane put back.
InverseDepthMoments whole_moments(InverseDepthMoments m, const FrameBlock& block,
                                  const LinearPlane& plane) noexcept {
  const double v = block.v;
  m.v = v * m.n;
  m.uv = v * m.u;
  m.vv = v * m.v;
  m.vq = v * m.q;
  m = m.seen_from(-block.u0, 0);
  const double a = -plane.x, b = -plane.y, c = -plane.w;
  InverseDepthMoments with = m;
  with.q = m.q + a * m.u + b * m.v + c * m.n;
  with.uq = m.uq + a * m.uu + b * m.uv + c * m.u;
  with.vq = m.vq + a * m.uv + b * m.vv + c * m.v;
  with.qq = m.qq + (a * (m.uq + with.uq) + b * (m.vq + with.vq)) + c * (m.q + with.q);
  return with;
}

ModelSums sum_frame(const Readings& readings, std::span<const std::uint16_t> labels,
                    const LinearPlane& plane) noexcept {
  ModelSums sums;
  for_each_block(readings, labels, plane,
                 [&](const FrameBlock& block, float a, float c, const std::uint16_t* here) {
                   InverseDepthMoments m;
                   block.add_inliers(a, c, here, m);
                   if (m.n > 0) sums.inverse.add(whole_moments(m, block, plane));
                 });
  return sums;
}

bool within(const LinearPlane& plane, const Reading& r) noexcept {
  const double e = plane.at(r) * r.w;
  return e * e < 1;
}

}  // namespace

ModelSums sum_inliers(const Readings& readings, std::span<const std::uint16_t> labels,
                      const LinearPlane& plane) noexcept {
  if (readings.is_frame()) return sum_frame(readings, labels, plane);
  const bool in_space = readings.in_space();
  ModelSums sums;
  Reading r;
  for (std::uint32_t i = 0; i < readings.count(); ++i)
    if (labels[i] == 0 && readings.read(i, r) && within(plane, r)) sums.add(r, in_space);
  return sums;
}

std::uint32_t label_inliers(const Readings& readings, const LinearPlane& plane, std::uint16_t label,
                            std::span<std::uint16_t> labels) noexcept {
  std::uint32_t found = 0;
  if (readings.is_frame()) {
    for_each_block(readings, labels, plane,
                   [&](const FrameBlock& block, float a, float c, std::uint16_t* here) {
                     found += block.label_inliers(a, c, label, here);
                   });
    return found;
  }
  Reading r;
  for (std::uint32_t i = 0; i < readings.count(); ++i) {
    if (labels[i] != 0 || !readings.read(i, r) || !within(plane, r)) continue;
    labels[i] = label;
    ++found;
  }
  return found;
}

std::uint32_t count_readings(const Readings& readings, std::span<const std::uint16_t> labels) noexcept {
  std::uint32_t found = 0;
  if (readings.is_frame()) {
    for_each_block(readings, labels, {},
                   [&](const FrameBlock& block, float, float, const std::uint16_t* here) {
                     found += block.readings(here);
                   });
    return found;
  }
  Reading r;
  for (std::uint32_t i = 0; i < readings.count(); ++i)
    found += labels[i] == 0 && readings.read(i, r) ? 1U : 0U;
  return found;
}

}  // namespace straightedge::ransac
