// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <cmath>
#include <memory>

#include "depth_scene.hpp"
#include "speed_rows.hpp"
#include "straightedge/octree.hpp"
#include "straightedge/random.hpp"
#include "with_kernels.hpp"

namespace bench::speed {
namespace {

using namespace straightedge;

constexpr std::uint32_t queries = 10'000;

struct Cloud {
  std::vector<float> x, y, z;

  PointsView view() const {
    PointsView points;
    points.x = x.data();
    points.y = y.data();
    points.z = z.data();
    points.count = x.size();
    return points;
  }
};

/// The readings of a frame that has at least so many, thinned to them.
Cloud make_cloud(std::size_t count) {
  const auto height = static_cast<std::int32_t>(std::ceil(std::sqrt(static_cast<double>(count))));
  const Size size{(height * 4 + 2) / 3, height};
  const DepthScene scene = make_depth_scene(size);
  Cloud cloud;
  for (std::int32_t v = 0; v < size.height; ++v) {
    for (std::int32_t u = 0; u < size.width && cloud.x.size() < count; ++u) {
      const float q = scene.inverse_depth.at(u, v);
      if (!(q > 0)) continue;
      const Vector3 p = 1 / static_cast<double>(q) * scene.camera.ray(u, v);
      cloud.x.push_back(static_cast<float>(p.x));
      cloud.y.push_back(static_cast<float>(p.y));
      cloud.z.push_back(static_cast<float>(p.z));
    }
  }
  need(cloud.x.size() == count, "too few points");
  return cloud;
}

struct Tree {
  Cloud cloud;
  std::vector<std::byte> memory;
  Octree octree;

  explicit Tree(std::size_t count) : cloud(make_cloud(count)) {
    const auto capacity = static_cast<std::uint32_t>(count);
    memory.resize(Octree::workspace_bytes(capacity, {}));
    need(Octree::prepare(octree, capacity, {}, memory) == Status::ok, "no octree");
    build();
  }
  void build() { need(octree.build(cloud.view()).status == Status::ok, "no octree"); }
};

std::size_t count_of(int power) {
  return static_cast<std::size_t>(std::pow(10.0, power));
}
std::string text_of_power(int power) {
  return "10^" + std::to_string(power) + " points";
}

Call prepare_cloud_plane(std::size_t count, const KernelSet& set) {
  struct Work {
    Cloud cloud;
    FirstPlane first;
  };
  auto w =
      std::make_shared<Work>(Work{make_cloud(count), FirstPlane(count, {.gate = {.fixed_m = 0.02}}, set)});
  need(w->first.prepared(), "no RANSAC");
  return [w] { need(w->first.run(w->cloud.view()).found.planes == 1, "no plane"); };
}

Call prepare_nearest(std::size_t count) {
  auto tree = std::make_shared<Tree>(count);
  auto positions = std::make_shared<std::vector<Vector3>>();
  Pcg32 random(3);
  const auto shift = [&random] { return 0.1 * (random.below(2'000'001) / 1e6 - 1); };
  for (std::uint32_t i = 0; i < queries; ++i) {
    const double dx = shift(), dy = shift(), dz = shift();
    positions->push_back(tree->cloud.view().at(random.below(static_cast<std::uint32_t>(count))) +
                         Vector3{dx, dy, dz});
  }
  return [tree, positions] {
    OctreeNeighbour neighbour;
    for (const Vector3& at : *positions) need(tree->octree.nearest(at, neighbour).found == 1, "no neighbour");
  };
}

}  // namespace

Job cloud_plane_job(int power) {
  return {"first plane of a cloud", text_of_power(power), static_cast<double>(count_of(power)), "point",
          [power](const KernelSet& set) { return prepare_cloud_plane(count_of(power), set); }};
}

Job octree_job(int power) {
  return {"octree", text_of_power(power), static_cast<double>(count_of(power)), "point",
          [power](const KernelSet&) -> Call {
            auto tree = std::make_shared<Tree>(count_of(power));
            return [tree] { tree->build(); };
          }};
}

Job nearest_job(int power) {
  return {"10 000 nearest points", text_of_power(power), queries, "question",
          [power](const KernelSet&) { return prepare_nearest(count_of(power)); }};
}

}  // namespace bench::speed
