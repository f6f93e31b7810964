// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Point_with_normal_3.h>
#include <CGAL/Random.h>
#include <CGAL/Shape_detection/Efficient_RANSAC.h>
#include <CGAL/property_map.h>

#include <memory>
#include <utility>

#include "peers.hpp"

namespace compare {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using OrientedPoint = std::pair<Kernel::Point_3, Kernel::Vector_3>;
using OrientedPoints = std::vector<OrientedPoint>;
using Traits =
    CGAL::Shape_detection::Efficient_RANSAC_traits<Kernel, OrientedPoints,
                                                   CGAL::First_of_pair_property_map<OrientedPoint>,
                                                   CGAL::Second_of_pair_property_map<OrientedPoint>>;
using Search = CGAL::Shape_detection::Efficient_RANSAC<Traits>;
using CgalPlane = CGAL::Shape_detection::Plane<Traits>;

OrientedPoints oriented(const Points& cloud) {
  const Points normals = normals_of(cloud);
  OrientedPoints points;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const straightedge::Vector3 p = cloud.at(i), n = normals.at(i);
    points.push_back({Kernel::Point_3(p.x, p.y, p.z), Kernel::Vector_3(n.x, n.y, n.z)});
  }
  return points;
}

PlanesOfScene found_in(const Search& search) {
  PlanesOfScene found;
  for (const auto& shape : search.shapes()) {
    const auto plane = dynamic_cast<const CgalPlane*>(shape.get());
    if (plane == nullptr) continue;
    const auto n = plane->plane_normal();
    const Kernel::Plane_3 equation = static_cast<Kernel::Plane_3>(*plane);
    const double size = std::sqrt(CGAL::to_double(n.squared_length()));
    found.labelled += plane->indices_of_assigned_points().size();
    found.planes.push_back({{n.x() / size, n.y() / size, n.z() / size}, -equation.d() / size});
  }
  return found;
}

FindPlanes make(const Scene& scene, double share) {
  auto points = std::make_shared<OrientedPoints>(oriented(scene.cloud));
  Search::Parameters options;
  options.probability = 0.05;
  options.min_points = static_cast<std::size_t>(share * static_cast<double>(points->size()));
  options.epsilon = gate_m;
  options.cluster_epsilon = 0.1;
  options.normal_threshold = 0.9;
  return [points, options] {
    CGAL::get_default_random() = CGAL::Random(1);
    // The search reorders its input.
    OrientedPoints copy = *points;
    Search search;
    search.set_input(copy);
    search.add_shape_factory<CgalPlane>();
    search.detect(options);
    return found_in(search);
  };
}

}  // namespace

// The library has no first plane: the largest there may be is all that is asked for.
FindPlanes cgal_first_plane(const Scene& scene) {
  return make(scene, 0.2);
}
FindPlanes cgal_all_planes(const Scene& scene) {
  return make(scene, least_share);
}

}  // namespace compare
