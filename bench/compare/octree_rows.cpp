// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <limits>

#include "alternation.hpp"
#include "peers.hpp"
#include "rows.hpp"
#include "straightedge/host/kernels.hpp"
#include "straightedge/octree.hpp"
#include "straightedge/random.hpp"

namespace compare {
namespace {

using namespace straightedge;

constexpr double leaf_m = 0.05;
constexpr std::uint32_t asked_positions = 20'000;
/// So many of them are also compared with every point there is.
constexpr std::size_t by_brute_force = 200;

/// Our octree, with memory for a quarter more leaves than the cloud has: what is over holds their boxes.
class OurOctree {
 public:
  explicit OurOctree(const Points& cloud) : cloud_(cloud) {
    const auto count = static_cast<std::uint32_t>(cloud.size());
    prepare(count, {.grid = {.leaf_m = leaf_m}, .kernels = best_kernels().octree});
    build();
    prepare(count, {.grid = {.leaf_m = leaf_m},
                    .max_leaves = octree_.nodes().leaves() * 5 / 4,
                    .kernels = best_kernels().octree});
    build();
  }
  void build() {
    if (octree_.build(cloud_.view()).status != Status::ok || octree_.size() != cloud_.size()) fail();
  }
  void nearest(const Points& positions, std::vector<double>& squared) const {
    for (std::size_t i = 0; i < positions.size(); ++i) {
      OctreeNeighbour found;
      if (octree_.nearest(positions.at(i), found).found != 1) fail();
      squared[i] = found.squared_distance;
    }
  }
  std::size_t leaves() const { return octree_.nodes().leaves(); }
  double bytes_a_point() const {
    return static_cast<double>(memory_.size()) / static_cast<double>(cloud_.size());
  }

 private:
  [[noreturn]] static void fail() {
    std::fprintf(stderr, "an octree failed\n");
    std::exit(70);
  }
  void prepare(std::uint32_t count, const OctreeOptions& options) {
    memory_.resize(Octree::workspace_bytes(count, options));
    if (Octree::prepare(octree_, count, options, memory_) != Status::ok) fail();
  }

  const Points& cloud_;
  std::vector<std::byte> memory_;
  Octree octree_;
};

/// Points of the cloud, moved by up to 10 cm along each axis.
Points moved_points(const Points& cloud) {
  Points moved;
  Pcg32 random(3);
  const auto shift = [&random] { return 0.1 * (random.below(2'000'001) / 1e6 - 1); };
  for (std::uint32_t i = 0; i < asked_positions; ++i) {
    const Vector3 p = cloud.at(random.below(static_cast<std::uint32_t>(cloud.size())));
    const double dx = shift(), dy = shift(), dz = shift();
    moved.add(p + Vector3{dx, dy, dz});
  }
  return moved;
}

/// As far as a distance in floats can be.
bool nearly(double a, double b) {
  return std::abs(a - b) <= 1e-5 * std::max(a, b) + 1e-9;
}

bool exact(const Points& cloud, const Points& positions, const std::vector<double>& squared) {
  for (std::size_t i = 0; i < by_brute_force; ++i) {
    const Vector3 at = positions.at(i);
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < cloud.size(); ++k) least = std::min(least, squared_length(cloud.at(k) - at));
    if (squared[i] != least) return false;
  }
  return true;
}

void print_rows_of(const Scene& scene, const PointIndex& peer, OurOctree& octree, int rounds) {
  const auto agree = [&] { return !peer.leaves || peer.leaves() == octree.leaves(); };
  const auto answers = [&] {
    char text[60];
    std::snprintf(text, sizeof(text), "%s%.1f bytes a point", peer.leaves ? "equal leaves; ours " : "ours ",
                  octree.bytes_a_point());
    return std::string(text);
  };
  print_row(
      {"octree, build, 5 cm", std::to_string(scene.cloud.size()) + " points, " + scene.name,
       std::string(best_kernels().name), [&] { octree.build(); }, peer.build, agree, peer.name, answers},
      rounds);
  if (!peer.nearest) return;
  const Points positions = moved_points(scene.cloud);
  std::vector<double> ours(positions.size()), theirs(positions.size());
  std::size_t alike = 0;
  print_row({"nearest point of 20 000", std::to_string(scene.cloud.size()) + " points, " + scene.name,
             std::string(best_kernels().name), [&] { octree.nearest(positions, ours); },
             [&] { peer.nearest(positions, theirs); },
             [&] {
               for (std::size_t i = 0; i < ours.size(); ++i) alike += nearly(ours[i], theirs[i]);
               return exact(scene.cloud, positions, ours) && alike == ours.size();
             },
             peer.name, [&] { return std::string("equal, exact"); }},
            rounds);
}

}  // namespace

void print_octree_rows(int rounds) {
  for (const Scene& scene : scenes()) {
    OurOctree octree(scene.cloud);
    for (const PointIndex& peer : point_indices(scene.cloud, leaf_m))
      print_rows_of(scene, peer, octree, rounds);
  }
}

}  // namespace compare
