// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <optional>

#include "straightedge/host/depth_file.hpp"

namespace straightedge {
namespace {

/// A point of the plane one focal length before the camera.
struct Point {
  double x = 0, y = 0;
};

/// Brown's model: where the lens shows the point that a camera without distortion shows at `p`.
Point shown(const Point& p, const LensDistortion& lens) {
  const double s = p.x * p.x + p.y * p.y;
  const double radial = 1 + s * (lens.k1 + s * (lens.k2 + s * lens.k3));
  return {p.x * radial + 2 * lens.p1 * p.x * p.y + lens.p2 * (s + 2 * p.x * p.x),
          p.y * radial + lens.p1 * (s + 2 * p.y * p.y) + 2 * lens.p2 * p.x * p.y};
}

/// Where the polynomial turns back, points of the corners would be shown in the middle again; the model
/// says nothing from there on. The first such squared radius, at most `largest`.
double turning_point(const LensDistortion& lens, double largest) {
  constexpr int steps = 4096;
  for (int i = 1; i <= steps; ++i) {
    const double s = largest * i / steps;
    if (!(1 + s * (3 * lens.k1 + s * (5 * lens.k2 + s * 7 * lens.k3)) > 0)) return largest * (i - 1) / steps;
  }
  return largest;
}

/// Newton's method on `shown`, a fixed number of steps; none where it does not arrive.
std::optional<Point> unshown(const Point& target, const LensDistortion& lens, double limit) {
  Point p = target;
  for (int step = 0; step < 20; ++step) {
    const double s = p.x * p.x + p.y * p.y;
    const double radial = 1 + s * (lens.k1 + s * (lens.k2 + s * lens.k3));
    const double slope = 2 * (lens.k1 + s * (2 * lens.k2 + s * 3 * lens.k3));  // of radial, by s, twice
    const double xx = radial + slope * p.x * p.x + 2 * lens.p1 * p.y + 6 * lens.p2 * p.x;
    const double xy = slope * p.x * p.y + 2 * lens.p1 * p.x + 2 * lens.p2 * p.y;
    const double yy = radial + slope * p.y * p.y + 6 * lens.p1 * p.y + 2 * lens.p2 * p.x;
    const Point at = shown(p, lens);
    const double ex = target.x - at.x, ey = target.y - at.y;
    const double determinant = xx * yy - xy * xy;
    p = {p.x + (yy * ex - xy * ey) / determinant, p.y + (xx * ey - xy * ex) / determinant};
  }
  const Point at = shown(p, lens);
  const double ex = target.x - at.x, ey = target.y - at.y;
  const bool arrived = ex * ex + ey * ey < 1e-16 && p.x * p.x + p.y * p.y <= limit;
  return arrived ? std::optional(p) : std::nullopt;
}

Point on_plane(double u, double v, const PinholeCamera& camera) {
  return {(u - camera.cx) / camera.fx, (v - camera.cy) / camera.fy};
}

/// The pixel nearest to where the camera shows the point, 0 outside. NaN is outside too.
std::uint16_t value_at(ImageView<const std::uint16_t> image, const Point& p, const PinholeCamera& camera) {
  const double u = p.x * camera.fx + camera.cx + 0.5;
  const double v = p.y * camera.fy + camera.cy + 0.5;
  if (!(u >= 0 && u < image.width && v >= 0 && v < image.height)) return 0;
  return image.at(static_cast<std::int32_t>(u), static_cast<std::int32_t>(v));
}

/// The squared radius of the farthest corner, and much beyond it: a wide lens shows points there that the
/// same camera without distortion would not.
double largest_of_interest(Size size, const PinholeCamera& camera) {
  double largest = 0;
  for (const std::int32_t u : {0, size.width - 1}) {
    for (const std::int32_t v : {0, size.height - 1}) {
      const Point p = on_plane(u, v, camera);
      const double s = p.x * p.x + p.y * p.y;
      if (s > largest) largest = s;
    }
  }
  return 16 * largest;
}

template <class Source>
Image<std::uint16_t> remapped(ImageView<const std::uint16_t> image, const PinholeCamera& camera,
                              const Source& source) {
  if (!image.valid() || !camera.valid()) return {};
  Image<std::uint16_t> result(image.size());
  for (std::int32_t v = 0; v < image.height; ++v) {
    for (std::int32_t u = 0; u < image.width; ++u) {
      const std::optional<Point> p = source(on_plane(u, v, camera));
      if (p) result.at(u, v) = value_at(image, *p, camera);
    }
  }
  return result;
}

}  // namespace

Image<std::uint16_t> undistorted(ImageView<const std::uint16_t> raw, const DepthCamera& camera) {
  const double limit = turning_point(camera.distortion, largest_of_interest(raw.size(), camera.pinhole));
  return remapped(raw, camera.pinhole, [&](const Point& p) {
    const bool known = p.x * p.x + p.y * p.y <= limit;
    return known ? std::optional(shown(p, camera.distortion)) : std::nullopt;
  });
}

Image<std::uint16_t> distorted(ImageView<const std::uint16_t> labels, const DepthCamera& camera) {
  const double limit = turning_point(camera.distortion, largest_of_interest(labels.size(), camera.pinhole));
  return remapped(labels, camera.pinhole,
                  [&](const Point& p) { return unshown(p, camera.distortion, limit); });
}

}  // namespace straightedge
