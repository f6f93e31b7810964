// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "straightedge/host/plane_map_merge.hpp"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "map/plane_export.hpp"
#include "map/plane_options.hpp"
#include "map/plane_order.hpp"
#include "map/plane_outline.hpp"

namespace straightedge {
namespace {

constexpr double corner_weight = 1e4;  // 1/m²; a deviation of 1 cm

struct KnownPlane {
  const MapPlane* plane = nullptr;
  Surface surface;
  SurfaceEstimate estimate;
  bool joined = false;
};

bool good_numbers(const MapPlane& p) {
  const double size = squared_length(p.plane.normal);
  bool good = size > 1 - 1e-6 && size < 1 + 1e-6 && p.plane.distance >= 0 && p.plane.distance < 1e9;
  if (p.moments) {
    good = good && p.moments->weight > 0 && p.moments->weight < 1e300 && finite(p.moments->mean);
    for (const double s : p.moments->scatter) good = good && s - s == 0;
  }
  for (const MapPolygon& polygon : p.polygons) {
    for (const Vector3& v : polygon.points) good = good && finite(v);
  }
  return good;
}

void add_corners(const MapPlane& plane, Surface& surface) {
  for (const MapPolygon& polygon : plane.polygons) {
    for (const Vector3& v : polygon.points) surface.moments.add(v - surface.origin, corner_weight);
  }
  if (!(surface.moments.weight > 0)) surface.moments.add({}, corner_weight);
}

/// Step 2, for one plane.
Surface surface_of(const MapPlane& plane) {
  Surface s;
  s.origin = plane.plane.distance * plane.plane.normal;
  if (plane.moments) {
    const auto& [xx, xy, xz, yy, yz, zz] = plane.moments->scatter;
    s.origin = plane.moments->mean;
    s.moments.weight = plane.moments->weight;
    s.moments.xx = xx;
    s.moments.xy = xy;
    s.moments.xz = xz;
    s.moments.yy = yy;
    s.moments.yz = yz;
    s.moments.zz = zz;
    s.moments.count = static_cast<double>(plane.points.value_or(3));
  } else {
    if (!plane.polygons.empty() && !plane.polygons[0].points.empty()) s.origin = plane.polygons[0].points[0];
    add_corners(plane, s);
  }
  const double weight = s.moments.weight;
  s.towards_camera = weight * plane.plane.normal;
  s.tilt = weight;  // of one radian²: nothing is known but the places
  if (plane.seen == SeenSide::plus || plane.seen == SeenSide::both) s.seen_front = weight;
  if (plane.seen == SeenSide::minus || plane.seen == SeenSide::both) s.seen_back = weight;
  s.sightings = plane.count.value_or(0);
  return s;
}

/// The tilts come from the places; the plane itself is what the map says.
KnownPlane known(const MapPlane& plane, const PlaneMapOptions& options) {
  KnownPlane k{&plane, surface_of(plane), {}, false};
  k.estimate = estimate(k.surface, options);
  const Vector3& n = plane.plane.normal;
  k.estimate.normal = n;
  k.estimate.u = normalized(k.estimate.u - dot(n, k.estimate.u) * n);
  k.estimate.v = cross(n, k.estimate.u);
  return k;
}

std::vector<ExtentLoop> loops_of(const MapPlane& plane, const PlaneChart& chart) {
  std::vector<ExtentLoop> loops;
  for (const MapPolygon& polygon : plane.polygons) {
    ExtentLoop loop;
    for (const Vector3& v : polygon.points) loop.points.push_back(chart.on(v));
    loops.push_back(std::move(loop));
  }
  return loops;
}

template <class T>
std::optional<T> sum(const std::optional<T>& a, const std::optional<T>& b) {
  if (!a && !b) return std::nullopt;
  return static_cast<T>(a.value_or(0) + b.value_or(0));
}

/// Steps 2 and 3 for partners; `a` comes first in the order of planes.
MapPlane joined(const KnownPlane& a, const KnownPlane& b, const PlaneMapOptions& options) {
  PlaneGroup group;
  group.surface = a.surface;
  group.surface.add(b.surface);
  MapPlane plane = exported(group, options);
  plane.points = sum(a.plane->points, b.plane->points);
  plane.count = sum(a.plane->count, b.plane->count);
  if (a.plane->source == b.plane->source) plane.source = a.plane->source;
  if (a.plane->seen == SeenSide::unknown && b.plane->seen == SeenSide::unknown)
    plane.seen = SeenSide::unknown;
  const PlaneChart chart(plane.plane, plane.moments->mean);
  const std::array<std::vector<ExtentLoop>, 2> things{loops_of(*a.plane, chart), loops_of(*b.plane, chart)};
  plane.polygons = polygons_of(chart, united_loops(things, extent_options(options)));
  return plane;
}

struct Pair {
  std::size_t a = 0, b = 0;
  double miss = 0;
};

/// Step 1.
std::vector<Pair> pairs_of(const std::vector<KnownPlane>& a, const std::vector<KnownPlane>& b,
                           const PlaneMapOptions& options) {
  std::vector<Pair> pairs;
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t j = 0; j < b.size(); ++j) {
      const bool a_first = comes_first(*a[i].plane, *b[j].plane);
      const Agreement found = a_first ? agree(a[i].estimate, b[j].estimate, options)
                                      : agree(b[j].estimate, a[i].estimate, options);
      if (found.possible) pairs.push_back({i, j, found.miss});
    }
  }
  std::stable_sort(pairs.begin(), pairs.end(), [](const Pair& p, const Pair& q) { return p.miss < q.miss; });
  return pairs;
}

std::vector<KnownPlane> known_planes(const PlaneMap& map, const PlaneMapOptions& options) {
  std::vector<KnownPlane> planes;
  for (const MapPlane& plane : map.planes) planes.push_back(known(plane, options));
  std::stable_sort(planes.begin(), planes.end(),
                   [](const KnownPlane& p, const KnownPlane& q) { return comes_first(*p.plane, *q.plane); });
  return planes;
}

}  // namespace

Result<PlaneMap> merge_plane_maps(const PlaneMap& a, const PlaneMap& b, const PlaneMapOptions& options) {
  if (const auto good = check_options(options); !good) return good.failure();
  for (const PlaneMap* map : {&a, &b}) {
    for (const MapPlane& plane : map->planes) {
      if (!good_numbers(plane))
        return Failure{Problem::bad_content, "plane " + std::to_string(plane.id) + " is no plane"};
    }
  }
  std::vector<KnownPlane> of_a = known_planes(a, options), of_b = known_planes(b, options);
  PlaneMap merged;
  if (a.meta == b.meta) merged.meta = a.meta;
  // Steps 1 to 3.
  for (const Pair& pair : pairs_of(of_a, of_b, options)) {
    KnownPlane& p = of_a[pair.a];
    KnownPlane& q = of_b[pair.b];
    if (p.joined || q.joined) continue;
    p.joined = q.joined = true;
    merged.planes.push_back(comes_first(*p.plane, *q.plane) ? joined(p, q, options) : joined(q, p, options));
  }
  for (const auto* planes : {&of_a, &of_b}) {
    for (const KnownPlane& k : *planes) {
      if (!k.joined) merged.planes.push_back(*k.plane);
    }
  }
  // Step 4.
  std::stable_sort(merged.planes.begin(), merged.planes.end(), comes_first);
  for (std::size_t i = 0; i < merged.planes.size(); ++i)
    merged.planes[i].id = static_cast<std::uint32_t>(i + 1);
  return merged;
}

}  // namespace straightedge
