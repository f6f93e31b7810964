// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT

// A row for building an octree, adding to it, and each query, on the view of a depth camera into a room, in
// the order of its pixels and in none:
//   bench_octree --benchmark_filter=/640x480
// per_item: the time for a point of build and insert, or for a query.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "straightedge/octree.hpp"
#include "straightedge/random.hpp"

namespace {

using namespace straightedge;

void require(bool good, const char* what) {
  if (good) return;
  std::fprintf(stderr, "%s failed\n", what);
  std::exit(70);
}

struct Cloud {
  std::vector<float> x, y, z;

  void add(const Vector3& p) {
    x.push_back(static_cast<float>(p.x));
    y.push_back(static_cast<float>(p.y));
    z.push_back(static_cast<float>(p.z));
  }
  PointsView view(std::size_t begin, std::size_t end) const {
    PointsView points;
    points.x = x.data() + begin;
    points.y = y.data() + begin;
    points.z = z.data() + begin;
    points.count = end - begin;
    return points;
  }
  PointsView view() const { return view(0, x.size()); }
  Vector3 at(std::size_t i) const { return view().at(i); }
};

double unit(Pcg32& random) {
  return static_cast<double>(random.below(2'000'001)) / 1e6 - 1;
}

/// How far along z a ray from the origin meets a closed box from outside, or leaves the room from inside.
double depth_of(const Vector3& ray) {
  constexpr double walls[][2] = {{-2.43, 2.12}, {-1.52, 1.13}, {-1, 4.22}};
  constexpr double table[][2] = {{-0.63, 0.92}, {0.32, 1.13}, {1.62, 2.43}};
  const double direction[] = {ray.x, ray.y, ray.z};
  double wall = 1e9, enter = 0, exit = 1e9;
  for (int axis = 0; axis < 3; ++axis) {
    if (direction[axis] == 0) continue;
    const bool up = direction[axis] > 0;
    wall = std::min(wall, walls[axis][up] / direction[axis]);
    enter = std::max(enter, table[axis][!up] / direction[axis]);
    exit = std::min(exit, table[axis][up] / direction[axis]);
  }
  return enter < exit ? enter : wall;
}

Cloud room(int width, int height) {
  Cloud cloud;
  Pcg32 random(1);
  const double focal = 0.82 * width;
  for (int v = 0; v < height; ++v) {
    for (int u = 0; u < width; ++u) {
      const Vector3 ray{(u + 0.5 - width / 2.0) / focal, (v + 0.5 - height / 2.0) / focal, 1};
      const double z = depth_of(ray);
      cloud.add((z + 1.4e-3 * z * z * unit(random)) * ray);
    }
  }
  return cloud;
}

Cloud shuffled(const Cloud& cloud) {
  std::vector<std::uint32_t> order(cloud.x.size());
  for (std::uint32_t i = 0; i < order.size(); ++i) order[i] = i;
  Pcg32 random(2);
  for (auto i = static_cast<std::uint32_t>(order.size()); i > 1; --i)
    std::swap(order[i - 1], order[random.below(i)]);
  Cloud mixed;
  for (const std::uint32_t i : order) mixed.add(cloud.at(i));
  return mixed;
}

struct Scene {
  explicit Scene(Cloud points) : cloud(std::move(points)) {
    const auto capacity = static_cast<std::uint32_t>(cloud.x.size());
    workspace.resize(Octree::workspace_bytes(capacity, {}));
    require(Octree::prepare(octree, capacity, {}, workspace) == Status::ok, "prepare");
    require(octree.build(cloud.view()).status == Status::ok, "build");
    Pcg32 random(3);
    for (int i = 0; i < 4096; ++i) {
      const Vector3 moved{0.1 * unit(random), 0.1 * unit(random), 0.1 * unit(random)};
      queries.push_back(cloud.at(random.below(capacity)) + moved);
    }
  }
  Cloud cloud;
  std::vector<std::byte> workspace;
  Octree octree;
  std::vector<Vector3> queries;
  std::vector<OctreeNeighbour> neighbours{100'000};
  std::vector<std::uint32_t> indices = std::vector<std::uint32_t>(100'000);
  std::vector<OctreeCrossing> crossings{4096};
};

using Shared = std::shared_ptr<Scene>;

template <class Run>
void add_row(const std::string& name, const Shared& scene, std::size_t items, Run run) {
  benchmark::RegisterBenchmark(("octree_" + name).c_str(), [scene, items, run](benchmark::State& state) {
    for (auto _ : state) {
      run(*scene);
      benchmark::ClobberMemory();
    }
    state.counters["per_item"] =
        benchmark::Counter(static_cast<double>(items),
                           benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
  })->Unit(benchmark::kMillisecond);
}

/// All queries one after another; `ask` says how much it found.
template <class Ask>
void add_query_row(const std::string& name, const Shared& scene, Ask ask) {
  add_row(name, scene, scene->queries.size(), [ask](Scene& s) {
    std::size_t found = 0;
    for (const Vector3& at : s.queries) found += ask(s, at).found;
    require(found > 0, "query");
  });
}

void add_rows(const std::string& cloud_name, const Shared& scene) {
  const std::size_t points = scene->cloud.x.size();
  add_row("build" + cloud_name, scene, points,
          [](Scene& s) { require(s.octree.build(s.cloud.view()).status == Status::ok, "build"); });
  add_row("insert_last_tenth" + cloud_name, scene, points / 10, [points](Scene& s) {
    require(s.octree.build(s.cloud.view(0, points - points / 10)).status == Status::ok, "build");
    require(s.octree.insert(s.cloud.view(points - points / 10, points)).status == Status::ok, "insert");
  });
  add_query_row("nearest" + cloud_name, scene,
                [](Scene& s, const Vector3& at) { return s.octree.nearest(at, s.neighbours[0]); });
  add_query_row("nearest_8" + cloud_name, scene, [](Scene& s, const Vector3& at) {
    return s.octree.k_nearest(at, std::span(s.neighbours).first(8));
  });
  add_query_row("radius_5cm" + cloud_name, scene,
                [](Scene& s, const Vector3& at) { return s.octree.radius(at, 0.05, s.neighbours); });
  add_query_row("box_10cm" + cloud_name, scene, [](Scene& s, const Vector3& at) {
    const Vector3 half{0.05, 0.05, 0.05};
    return s.octree.box({at - half, at + half}, s.indices);
  });
  add_query_row("first_hit" + cloud_name, scene, [](Scene& s, const Vector3& at) {
    return s.octree.first_hit({.direction = at}, s.crossings[0]);
  });
  add_query_row("ray" + cloud_name, scene,
                [](Scene& s, const Vector3& at) { return s.octree.ray({.direction = at}, s.crossings); });
}

}  // namespace

int main(int argc, char** argv) {
  for (const auto& [width, height] : {std::pair{320, 240}, std::pair{640, 480}, std::pair{1920, 1080}}) {
    const std::string size = std::to_string(width) + "x" + std::to_string(height);
    const Cloud cloud = room(width, height);
    add_rows("/room/" + size, std::make_shared<Scene>(cloud));
    add_rows("/shuffled/" + size, std::make_shared<Scene>(shuffled(cloud)));
  }
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
}
