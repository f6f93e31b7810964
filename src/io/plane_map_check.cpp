// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>

#include "io/map_rules.hpp"
#include "io/number_text.hpp"
#include "straightedge/host/plane_map_file.hpp"

namespace straightedge {
namespace {

constexpr double unit_length_tolerance = 1e-9;

double largest_coordinate(const std::vector<Vector3>& points) {
  double largest = 0;
  for (const Vector3& p : points) largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  return largest;
}

/// Its sign tells the sense of rotation about the normal; a multiple of the area, so that it stays finite.
double turning(const std::vector<Vector3>& points, const Vector3& normal, double size) {
  Vector3 sum;
  const auto arm = [&](std::size_t i) {
    const Vector3& p = points[i];
    const Vector3& o = points[0];
    return Vector3{p.x / size - o.x / size, p.y / size - o.y / size, p.z / size - o.z / size};
  };
  for (std::size_t i = 2; i < points.size(); ++i) sum = sum + cross(arm(i - 1), arm(i));
  return dot(sum, normal);
}

/// Collects breaches, and knows which element is being looked at.
class Checker {
 public:
  explicit Checker(const PlaneMap& map) : map_(map) {}

  std::vector<PlaneMapBreach> run() {
    for (plane_ = 0; plane_ < map_.planes.size(); ++plane_) check_plane(map_.planes[plane_]);
    check_unique_ids();
    return std::move(breaches_);
  }

 private:
  std::string title() const { return "plane " + std::to_string(map_.planes[plane_].id); }
  void report(const std::string& what) { breaches_.push_back({plane_, {}, title() + ": " + what}); }
  void report_polygon(const std::string& what) {
    breaches_.push_back(
        {plane_, polygon_, title() + ", polygon " + std::to_string(polygon_ + 1) + ": " + what});
  }

  // Rules 1 and 3; the others in functions of their own.
  void check_plane(const MapPlane& plane) {
    const Vector3& n = plane.plane.normal;
    const double distance = plane.plane.distance;
    if (!finite(n) || !std::isfinite(distance)) return report("nx, ny, nz or d is not a finite number");
    if (!(std::abs(length(n) - 1) <= unit_length_tolerance)) {
      return report("the length of its normal is not 1 (" + io::to_short_text(length(n)) + ")");
    }
    if (distance < 0) return report("d is negative (" + io::to_text(distance) + ")");
    if (canonical(plane.plane).normal != n) {
      return report("d is 0 and the first number of the normal that is not 0 is negative");
    }
    if (plane.covariance) check_covariance(*plane.covariance);
    if (plane.moments) check_moments(*plane.moments);
    for (polygon_ = 0; polygon_ < plane.polygons.size(); ++polygon_) {
      check_polygon(plane.plane, plane.polygons[polygon_]);
    }
  }

  // Rule 4. The normal's numbers have no unit, the distance's is the metre: each its own scale.
  void check_covariance(const std::array<double, 10>& upper) {
    if (!io::all_finite(upper)) return report("the covariance holds what is not a finite number");
    const double normal = std::sqrt(std::max({upper[0], upper[4], upper[7], 0.0}));
    const double distance = std::sqrt(std::max(upper[9], 0.0));
    if (!io::is_semidefinite(upper, std::array{normal, normal, normal, distance})) {
      report("the covariance is not positive semidefinite");
    }
  }

  void check_moments(const MapMoments& moments) {
    if (!std::isfinite(moments.weight) || !finite(moments.mean) || !io::all_finite(moments.scatter)) {
      return report("the moments hold what is not a finite number");
    }
    if (moments.weight < 0) report("the weight of its moments is negative");
    const std::array<double, 6>& scatter = moments.scatter;
    const double scale = std::sqrt(std::max({scatter[0], scatter[3], scatter[5], 0.0}));
    if (!io::is_semidefinite(scatter, std::array{scale, scale, scale})) {
      report("the scatter of its moments is not positive semidefinite");
    }
  }

  // Rule 5.
  void check_polygon(const Plane& plane, const MapPolygon& polygon) {
    const std::vector<Vector3>& points = polygon.points;
    if (points.size() < 3) return report_polygon("has fewer than three points");
    if (!std::all_of(points.begin(), points.end(), finite)) return report_polygon("a point is not finite");
    const double size = largest_coordinate(points);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double off = std::abs(plane.signed_distance(points[i]));
      if (!(off <= io::off_feature_tolerance * std::max(1.0, size))) {
        return report_polygon("point " + std::to_string(i + 1) + " lies " + io::to_short_text(off) +
                              " off the plane");
      }
    }
    const double sense = turning(points, plane.normal, size > 0 ? size : 1);
    if (sense == 0) return report_polygon("its area is zero");
    if ((sense < 0) == polygon.hole) return;
    report_polygon(polygon.hole ? "is a hole and runs counter-clockwise seen from where the normal points"
                                : "runs clockwise seen from where the normal points");
  }

  // Rule 2. The later one of two is reported.
  void check_unique_ids() {
    struct Place {
      std::uint32_t id;
      std::size_t plane;
      auto operator<=>(const Place&) const = default;
    };
    std::vector<Place> planes;
    for (std::size_t i = 0; i < map_.planes.size(); ++i) planes.push_back({map_.planes[i].id, i});
    io::for_each_repeated(std::move(planes), [&](const Place& place) {
      plane_ = place.plane;
      report("another plane has the same id");
    });
  }

  const PlaneMap& map_;
  std::size_t plane_ = 0;
  std::size_t polygon_ = 0;
  std::vector<PlaneMapBreach> breaches_;
};

}  // namespace

std::vector<PlaneMapBreach> check_plane_map(const PlaneMap& map) {
  return Checker(map).run();
}

}  // namespace straightedge
