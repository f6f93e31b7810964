// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "ransac/verify.hpp"

#include <bit>

#include "ransac/cloud_blocks.hpp"
#include "ransac/frame_rows.hpp"

namespace straightedge::ransac {
namespace {

/// Moments of residuals r with the plane q = r − (x u + y v + w) put back.
InverseDepthMoments with_plane(const InverseDepthMoments& m, const LinearPlane& plane) noexcept {
  const double a = -plane.x, b = -plane.y, c = -plane.w;
  InverseDepthMoments with = m;
  with.q = m.q + a * m.u + b * m.v + c * m.n;
  with.uq = m.uq + a * m.uu + b * m.uv + c * m.u;
  with.vq = m.vq + a * m.uv + b * m.vv + c * m.v;
  with.qq = m.qq + (a * (m.uq + with.uq) + b * (m.vq + with.vq)) + c * (m.q + with.q);
  return with;
}

/// A row's sums, moved to column 0 of the frame.
void add_row(InverseDepthMoments& m, const RansacPixelSums& s, double u0, double v) noexcept {
  const double n = s.n, r = static_cast<double>(s.r), from = s.u;
  const double u = from + u0 * n;
  m.n += n;
  m.u += u;
  m.v += v * n;
  m.uu += s.uu + u0 * (from + u);
  m.uv += v * u;
  m.vv += v * v * n;
  m.q += r;
  m.uq += static_cast<double>(s.ur) + u0 * r;
  m.vq += v * r;
  m.qq += static_cast<double>(s.rr);
}

/// Sums over points in the block's order of axes, with r in place of the third coordinate.
struct SpaceSums {
  double n = 0, x = 0, y = 0, xx = 0, xy = 0, yy = 0, r = 0, xr = 0, yr = 0, rr = 0;

  void add(const RansacPointSums& s) noexcept {
    n += s.n;
    x += static_cast<double>(s.x);
    y += static_cast<double>(s.y);
    xx += static_cast<double>(s.xx);
    xy += static_cast<double>(s.xy);
    yy += static_cast<double>(s.yy);
    r += static_cast<double>(s.r);
    xr += static_cast<double>(s.xr);
    yr += static_cast<double>(s.yr);
    rr += static_cast<double>(s.rr);
  }
};

/// The third coordinate put back, z = (r − x kx − y ky − kw) / kz, and the axes in their own order.
PlaneMoments in_axes(const SpaceSums& s, const RansacCoefficients& plane, const AxisOrder& order,
                     double weight) noexcept {
  const double kz = static_cast<double>(plane.z);
  const double a = -static_cast<double>(plane.x) / kz, b = -static_cast<double>(plane.y) / kz;
  const double c = -static_cast<double>(plane.w) / kz, e = 1 / kz;
  const double z = (a * s.x + b * s.y) + (c * s.n + e * s.r);
  const double xz = (a * s.xx + b * s.xy) + (c * s.x + e * s.xr);
  const double yz = (a * s.xy + b * s.yy) + (c * s.y + e * s.yr);
  const double rz = (a * s.xr + b * s.yr) + (c * s.r + e * s.rr);
  const double zz = (a * xz + b * yz) + (c * z + e * rz);
  const double first[3] = {s.x, s.y, z};
  const double second[3][3] = {{s.xx, s.xy, xz}, {s.xy, s.yy, yz}, {xz, yz, zz}};
  int at[3];  // where an axis is in the block's order
  at[order.x] = 0;
  at[order.y] = 1;
  at[order.z] = 2;
  const auto product = [&](int i, int j) { return weight * second[at[i]][at[j]]; };
  PlaneMoments m;
  m.weight = weight * s.n;
  m.x = weight * first[at[0]];
  m.y = weight * first[at[1]];
  m.z = weight * first[at[2]];
  m.xx = product(0, 0);
  m.xy = product(0, 1);
  m.xz = product(0, 2);
  m.yy = product(1, 1);
  m.yz = product(1, 2);
  m.zz = product(2, 2);
  m.count = s.n;
  return m;
}

bool within(const LinearPlane& plane, const Reading& r, double gates) noexcept {
  const double e = plane.at(r) * r.w;
  return e * e < gates * gates;
}

float away(float residual) noexcept {
  return std::bit_cast<float>(std::bit_cast<std::int32_t>(residual) & 0x7FFFFFFF);
}

/// Labels what the kernels count as inliers.
template <class Q>
void label_pixels(const RansacPixels<Q>& row, std::uint16_t label, std::uint16_t* labels) noexcept {
  const float scale = row.scale, a = row.a, c = row.c, constant = row.constant, metres = row.metres;
  for (std::int32_t i = 0; i < row.count; ++i) {
    const float q = inverse_of(row.pixels[i], scale);
    const float wide = wide_of(q, constant, metres);
    const std::int32_t near = away(q - (a * static_cast<float>(i) + c)) < wide ? 1 : 0;
    const std::int32_t inside = near & (labels[i] == 0 ? 1 : 0) & is_above(q, wide);
    labels[i] = inside != 0 ? label : labels[i];
  }
}

void label_points(const RansacPoints& p, std::uint16_t label, std::uint16_t* labels) noexcept {
  const RansacCoefficients k = p.plane;
  for (std::int32_t i = 0; i < p.count; ++i) {
    const std::ptrdiff_t at = i * p.step;
    const float x = p.x[at] - p.origin_x, y = p.y[at] - p.origin_y, z = p.z[at] - p.origin_z;
    const float e = (k.x * x + k.y * y) + (k.z * z + k.w);
    const bool finite = ((x - x) + (y - y)) + (z - z) == 0;
    if (labels[i] == 0 && finite && away(e) < p.gate) labels[i] = label;
  }
}

}  // namespace

template <class Q>
ModelSums Verify::sum_frame(const LinearPlane& plane, std::uint32_t part,
                            std::uint32_t& seen) const noexcept {
  InverseDepthMoments m;
  const auto rows = static_cast<std::int32_t>(part);
  for_pixels<Q>(readings, labels, plane, gates, rows,
                [&](const RansacPixels<Q>& row, std::int32_t u, std::int32_t v) {
                  RansacPixelSums s;
                  if constexpr (sizeof(Q) == sizeof(float)) {
                    s = kernels.inverse.sum(row);
                  } else {
                    s = kernels.raw.sum(row);
                  }
                  seen += s.readings;
                  if (s.n > 0) add_row(m, s, u, v);
                });
  ModelSums sums;
  sums.inverse = with_plane(m, plane);
  return sums;
}

ModelSums Verify::sum_space(const LinearPlane& plane, std::uint32_t part,
                            std::uint32_t& seen) const noexcept {
  const AxisOrder order = axis_order(plane);
  CloudBlocks blocks(readings, labels, plane, order, gates);
  SpaceSums s;
  blocks.for_each(part, [&](const RansacPoints& block) {
    const RansacPointSums some = blocks.kernels(kernels).sum_points(block);
    seen += some.readings;
    s.add(some);
  });
  ModelSums sums;
  sums.space = in_axes(s, blocks.block.plane, order, 9 / (readings.gate.fixed_m * readings.gate.fixed_m));
  return sums;
}

ModelSums Verify::sum_rays(const LinearPlane& plane, std::uint32_t part, std::uint32_t& seen) const noexcept {
  ModelSums sums;
  Reading r;
  for (std::uint32_t i = 0; i < readings.count(); ++i) {
    if (!labels.free(i, 0) || !readings.read(i, r) || seen++ % part != 0) continue;
    if (within(plane, r, gates)) sums.add(r, false);
  }
  return sums;
}

ModelSums Verify::sum_inliers(const LinearPlane& plane, std::uint32_t part,
                              std::uint32_t& seen) const noexcept {
  seen = 0;
  if (readings.is_raw()) return sum_frame<std::uint16_t>(plane, part, seen);
  if (readings.is_frame()) return sum_frame<float>(plane, part, seen);
  return readings.in_space() ? sum_space(plane, part, seen) : sum_rays(plane, part, seen);
}

std::uint32_t Verify::count_inliers(const LinearPlane& plane, std::uint32_t part) const noexcept {
  std::uint32_t found = 0;
  const auto rows = static_cast<std::int32_t>(part);
  if (readings.is_raw()) {
    for_pixels<std::uint16_t>(readings, labels, plane, gates, rows,
                              [&](const auto& row, auto, auto) { found += kernels.raw.count(row); });
  } else if (readings.is_frame()) {
    for_pixels<float>(readings, labels, plane, gates, rows,
                      [&](const auto& row, auto, auto) { found += kernels.inverse.count(row); });
  } else if (readings.in_space()) {
    CloudBlocks blocks(readings, labels, plane, axis_order(plane), gates);
    blocks.for_each(part, [&](const auto& block) { found += blocks.kernels(kernels).count_points(block); });
  } else {
    Reading r;
    std::uint32_t seen = 0;
    for (std::uint32_t i = 0; i < readings.count(); ++i)
      found +=
          labels.free(i, 0) && readings.read(i, r) && seen++ % part == 0 && within(plane, r, gates) ? 1U : 0U;
  }
  return found;
}

void Verify::label_inliers(const LinearPlane& plane, std::uint16_t label) const noexcept {
  const auto in_row = [&](const auto& row, std::int32_t u, std::int32_t v) {
    label_pixels(row, label, labels.row(static_cast<std::size_t>(v)) + u);
  };
  if (readings.is_raw()) {
    for_pixels<std::uint16_t>(readings, labels, plane, gates, 1, in_row);
  } else if (readings.is_frame()) {
    for_pixels<float>(readings, labels, plane, gates, 1, in_row);
  } else if (readings.in_space()) {
    CloudBlocks blocks(readings, labels, plane, axis_order(plane), gates);
    blocks.for_each(1, [&](const RansacPoints& block) {
      label_points(block, label, const_cast<std::uint16_t*>(block.labels));
      const detail::CloudBlock* const from = readings.block;
      for (std::int32_t i = 0; from != nullptr && i < block.count; ++i)
        labels.data[from->number[i]] = from->label[i];
    });
  } else {
    Reading r;
    for (std::uint32_t i = 0; i < readings.count(); ++i) {
      if (labels.free(i, 0) && readings.read(i, r) && within(plane, r, gates)) labels.data[i] = label;
    }
  }
}

std::uint32_t Verify::count_free() const noexcept {
  std::uint32_t seen = 0;
  if (readings.is_frame()) {
    (void)sum_inliers({}, 1, seen);
  } else if (readings.in_space()) {
    CloudBlocks blocks(readings, labels, {}, {}, 0);
    // From the plane of zeros every finite point is 0 away, and none that is not finite.
    blocks.block.origin_x = blocks.block.origin_y = blocks.block.origin_z = 0;
    blocks.block.gate = 1;
    blocks.for_each(1,
                    [&](const RansacPoints& block) { seen += blocks.kernels(kernels).count_points(block); });
  } else {
    Reading r;
    for (std::uint32_t i = 0; i < readings.count(); ++i)
      seen += labels.free(i, 0) && readings.read(i, r) ? 1U : 0U;
  }
  return seen;
}

}  // namespace straightedge::ransac
