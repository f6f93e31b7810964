// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "straightedge/found_planes.hpp"

#include <array>
#include <limits>

#include "straightedge/inverse_depth.hpp"

namespace straightedge {
namespace {

constexpr std::size_t block = 64;
constexpr double nowhere = std::numeric_limits<double>::infinity();
constexpr std::size_t planes_in_a_pass = 16;

/// Some points in doubles; what is no reading is NaN and therefore near to no plane.
struct Block {
  std::array<double, block> x, y, z, limit, residual, label;

  void load(const PointsView& points, std::size_t first, std::size_t size, const PlaneGate& gate) noexcept {
    const bool fixed = gate.fixed_m > 0;
    for (std::size_t i = 0; i < size; ++i) {
      const Vector3 p = points.at(first + i);
      const bool reading = finite(p) && (fixed || p.z > 0);
      x[i] = reading ? p.x : std::numeric_limits<double>::quiet_NaN();
      y[i] = p.y;
      z[i] = p.z;
      const double kinect = reading && p.z > 0 ? gate.sigmas * gate.inverse_noise(1 / p.z) * p.z : 0;
      limit[i] = fixed ? gate.fixed_m : kinect;
      residual[i] = nowhere;
      label[i] = 0;
    }
  }

  /// The plane m·p = offset. Selections without branches: two points go at a time.
  void offer(Vector3 m, double offset, double plane_label) noexcept {
    for (std::size_t i = 0; i < block; ++i) {
      const double signed_residual = m.x * x[i] + m.y * y[i] + m.z * z[i] - offset;
      const double size = __builtin_fabs(signed_residual);
      const double within = size <= limit[i] ? size : nowhere;
      label[i] = within < residual[i] ? plane_label : label[i];
      residual[i] = within < residual[i] ? within : residual[i];
    }
  }
};

/// A plane's points, counted from the first one.
struct PointSums {
  Vector3 origin;
  PlaneMoments moments;
  std::uint32_t count = 0;

  void add(const Vector3& p, const PlaneGate& gate) noexcept {
    if (!finite(p)) return;
    if (count++ == 0) origin = p;
    moments.add(p - origin, 9 / (gate.fixed_m * gate.fixed_m));
  }
  Status fit(const PlaneGate& /*gate*/, PlaneFit& fit) const noexcept {
    const Status status = fit_plane(moments, fit);
    if (status == Status::ok) fit = moved(fit, {1, 0, 0, 0, 1, 0, 0, 0, 1}, origin);
    return status;
  }
};

/// 1/z of a plane's points over their rays.
struct RaySums {
  InverseDepthMoments moments;
  std::uint32_t count = 0;

  void add(const Vector3& p, const PlaneGate& /*gate*/) noexcept {
    if (!finite(p) || !(p.z > 0)) return;
    ++count;
    moments.add(p.x / p.z, p.y / p.z, 1 / p.z);
  }
  Status fit(const PlaneGate& gate, PlaneFit& fit) const noexcept {
    constexpr PinholeCamera rays{1, 1, 0, 0};
    InverseDepthFit inverse;
    const Status status = fit_inverse_depth(moments, gate.inverse_sigma, inverse);
    return status == Status::ok ? to_plane_fit(inverse, gate.inverse_sigma, rays, fit) : status;
  }
};

/// Some planes in one pass over the points, so that their sums fit a small stack.
template <class Sums>
void refit_by(const PointsView& points, std::span<const std::uint16_t> labels, const PlaneGate& gate,
              std::span<FoundPlane> planes) noexcept {
  for (std::size_t first = 0; first < planes.size(); first += planes_in_a_pass) {
    std::array<Sums, planes_in_a_pass> sums{};
    for (std::size_t i = 0; i < points.count; ++i) {
      const std::size_t index = labels[i] - std::size_t{1} - first;
      if (index < planes_in_a_pass) sums[index].add(points.at(i), gate);
    }
    for (std::size_t i = 0; i < planes_in_a_pass && first + i < planes.size(); ++i) {
      FoundPlane& plane = planes[first + i];
      plane.inliers = sums[i].count;
      PlaneFit fit;
      if (sums[i].fit(gate, fit) == Status::ok) plane.fit = fit;
    }
  }
}

}  // namespace

Status label_nearest(const PointsView& points, std::span<const FoundPlane> planes, const PlaneGate& gate,
                     std::span<std::uint16_t> labels, std::uint32_t& labelled) noexcept {
  labelled = 0;
  if (!points.valid()) return Status::invalid_image;
  if (!gate.valid()) return Status::invalid_option;
  if (labels.size() != points.count) return Status::size_mismatch;
  if (planes.size() > std::numeric_limits<std::uint16_t>::max()) return Status::too_large;
  Block points_here{};
  for (std::size_t first = 0; first < points.count; first += block) {
    const std::size_t size = points.count - first < block ? points.count - first : block;
    points_here.load(points, first, size, gate);
    for (std::size_t i = 0; i < planes.size(); ++i) {
      const Plane& plane = planes[i].fit.plane;
      // Without a fixed threshold: divided by the distance, (m·p − 1)/z is the residual of 1/z.
      const double scale = gate.fixed_m > 0 ? 1 : 1 / plane.distance;
      points_here.offer(scale * plane.normal, scale * plane.distance, static_cast<double>(i + 1));
    }
    for (std::size_t i = 0; i < size; ++i) {
      labels[first + i] = static_cast<std::uint16_t>(points_here.label[i]);
      labelled += labels[first + i] != 0 ? 1U : 0U;
    }
  }
  return Status::ok;
}

Status refit_labelled(const PointsView& points, std::span<const std::uint16_t> labels, const PlaneGate& gate,
                      std::span<FoundPlane> planes) noexcept {
  if (!points.valid()) return Status::invalid_image;
  if (!gate.valid()) return Status::invalid_option;
  if (labels.size() != points.count) return Status::size_mismatch;
  if (gate.fixed_m > 0) {
    refit_by<PointSums>(points, labels, gate, planes);
  } else {
    refit_by<RaySums>(points, labels, gate, planes);
  }
  return Status::ok;
}

}  // namespace straightedge
