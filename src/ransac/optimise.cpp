// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "ransac/optimise.hpp"

#include "straightedge/square_root.hpp"

namespace straightedge::ransac {
namespace {

/// Two coefficients that change beside the constant one. The third stays: in inverse depth it is 1, in space
/// the greatest.
struct Free {
  const float* s;
  const float* t;
  double LinearPlane::*of_s;
  double LinearPlane::*of_t;
};

double squared(double x) noexcept {
  return x * x;
}

Free free_of(const Subset& subset, const LinearPlane& p) noexcept {
  const Rows rows = subset.rows();
  const double x = squared(p.x), y = squared(p.y), z = squared(p.z);
  if (!subset.readings.in_space() || (z >= x && z >= y))
    return {rows.x, rows.y, &LinearPlane::x, &LinearPlane::y};
  if (y >= x) return {rows.x, rows.z, &LinearPlane::x, &LinearPlane::z};
  return {rows.y, rows.z, &LinearPlane::y, &LinearPlane::z};
}

/// Solves the normal equations of the change; `w` is taken out first. False: no plane.
bool change(const RansacChangeSums& sums, const Free& free, LinearPlane& plane) noexcept {
  const double ww = static_cast<double>(sums.ww);
  if (!(ww > 0)) return false;
  const double s = static_cast<double>(sums.sw) / ww, t = static_cast<double>(sums.tw) / ww,
               e = static_cast<double>(sums.we) / ww;
  const double ss = static_cast<double>(sums.ss) - s * s * ww, tt = static_cast<double>(sums.tt) - t * t * ww;
  const double st = static_cast<double>(sums.st) - s * t * ww;
  const double se = static_cast<double>(sums.se) - s * e * ww, te = static_cast<double>(sums.te) - t * e * ww;
  const double determinant = ss * tt - st * st;
  if (!(ss > 0) || !(determinant > 0)) return false;
  const double ds = (te * st - se * tt) / determinant, dt = (se * st - te * ss) / determinant;
  plane.*free.of_s += ds;
  plane.*free.of_t += dt;
  plane.w -= e + ds * s + dt * t;
  return true;
}

void normalise(LinearPlane& p) noexcept {
  const double scale = 1 / square_root(squared(p.x) + squared(p.y) + squared(p.z));
  p = {p.x * scale, p.y * scale, p.z * scale, p.w * scale};
}

}  // namespace

float optimise(const Subset& subset, const RansacKernels& kernels, float cost, LinearPlane& plane) noexcept {
  const Rows rows = subset.rows();
  for (const float gates : {2.0F, 1.5F, 1.0F}) {
    LinearPlane refitted = plane;
    const Free free = free_of(subset, plane);
    const RansacChangeSums sums =
        kernels.sum_changes(rows, coefficients(plane), free.s, free.t, gates * gates);
    if (!change(sums, free, refitted)) continue;
    if (subset.readings.in_space()) normalise(refitted);
    const float refitted_cost = kernels.row_cost(rows, coefficients(refitted));
    if (!(refitted_cost < cost)) continue;
    cost = refitted_cost;
    plane = refitted;
  }
  return cost;
}

}  // namespace straightedge::ransac
