// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "cli/explain_octree.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>

#include "cli/explain_chart.hpp"
#include "cli/explain_colours.hpp"
#include "cli/explain_paint.hpp"
#include "straightedge/host/draw.hpp"

namespace straightedge::cli {
namespace {

constexpr double leaf_m = 0.05;
constexpr std::int32_t longest_side = 640, shortest_side = 120;  // pixels of the body
constexpr Rgb passed_colour{0xD6, 0xE4, 0xF2}, passed_border{0x8F, 0xAF, 0xCE};
constexpr Rgb leaf_colour{0xF2, 0xA6, 0x3C}, leaf_border{0xB8, 0x6E, 0x10};
constexpr Rgb point_colour{0xB0, 0x18, 0x20};

struct Coordinates {
  std::vector<float> xyz;
  PointsView view() const {
    return {xyz.data(), xyz.data() + 1, xyz.data() + 2, xyz.size() / 3, 3 * sizeof(float)};
  }
};

Coordinates points_of(const DepthView& depth) {
  Coordinates all;
  for (std::int32_t y = 0; y < depth.raw.height; ++y) {
    for (std::int32_t x = 0; x < depth.raw.width; ++x) {
      if (depth.raw.at(x, y) == 0) continue;
      const Vector3 point = depth.raw.at(x, y) * depth.metres_per_unit * depth.camera.ray(x, y);
      for (const double c : {point.x, point.y, point.z}) all.xyz.push_back(static_cast<float>(c));
    }
  }
  return all;
}

/// A chart of the box from above, the camera in it.
Chart plan_of(const OctreeBox& box) {
  const double left = std::min(box.min.x, 0.0), right = std::max(box.max.x, 0.0), ahead = box.max.z;
  const double margin = 0.04 * std::max(right - left, ahead);
  const double width = right - left + 2 * margin, height = ahead + 2 * margin;
  const double scale = longest_side / std::max(width, height);
  const auto pixels = [&](double metres) {
    return std::max(shortest_side, static_cast<std::int32_t>(metres * scale));
  };
  return {{pixels(width), pixels(height)},
          {left - margin, right + margin, "metres to the right"},
          {-margin, ahead + margin, "metres ahead"}};
}

/// The square of a node. Small ones have no border; the smallest are one pixel.
void draw_square(Chart& plan, const OctreeBox& box, Rgb colour, Rgb border) {
  const Point2 a = plan.place(box.min.x, box.max.z), b = plan.place(box.max.x, box.min.z);
  const auto column = [&](double x) {
    return std::clamp(static_cast<std::int32_t>(x), Chart::left + 1, Chart::left + plan.body().width - 1);
  };
  const auto row = [&](double y) {
    return std::clamp(static_cast<std::int32_t>(y), Chart::top, Chart::top + plan.body().height - 2);
  };
  const std::int32_t left = column(a.x), right = std::max(left, column(b.x) - 1);
  const std::int32_t top = row(a.y), bottom = std::max(top, row(b.y) - 1);
  const bool bordered = right - left >= 3 && bottom - top >= 3;
  for (std::int32_t y = top; y <= bottom; ++y) {
    for (std::int32_t x = left; x <= right; ++x) {
      const bool rim = x == left || x == right || y == top || y == bottom;
      plan.picture().at(x, y) = bordered && rim ? border : colour;
    }
  }
}

void draw_camera(Chart& plan) {
  const Point2 at = plan.place(0, 0);
  draw_circle(plan.picture(), at, 5, {ink, 2, 1});
}

double squared_distance(const OctreeBox& box, const Vector3& from) {
  const auto gap = [](double low, double high, double at) { return std::max({low - at, at - high, 0.0}); };
  const double x = gap(box.min.x, box.max.x, from.x), y = gap(box.min.y, box.max.y, from.y),
               z = gap(box.min.z, box.max.z, from.z);
  return x * x + y * y + z * z;
}

/// Where the look towards the middle of the points ends: at the first leaf with a reading, or nearest to it.
Vector3 place_to_ask(const OctreeStage& stage) {
  const Vector3 middle = 0.5 * (stage.box.min + stage.box.max);
  OctreeCrossing hit;
  const OctreeFound seen = stage.octree.first_hit({.origin = {}, .direction = middle}, hit);
  const Vector3 ahead = seen.found > 0 ? (hit.enter_m / length(middle)) * middle : middle;
  OctreeNeighbour nearest;
  if (stage.octree.nearest(ahead, nearest).found == 0) return ahead;
  for (std::uint32_t i = 0; i < stage.octree.size(); ++i) {
    const OctreePoint point = stage.octree.point(i);
    if (point.index == nearest.index) return point.position();
  }
  return ahead;
}

}  // namespace

OctreeStage build_octree(const DepthView& depth) {
  OctreeStage stage;
  const Coordinates all = points_of(depth);
  if (all.xyz.empty()) return stage;
  const OctreeFit fit = fit_octree_grid(all.view(), leaf_m);
  if (fit.status != Status::ok) return stage;
  const auto count = static_cast<std::uint32_t>(all.view().count);
  const OctreeOptions options{.grid = fit.grid};
  const std::size_t bytes = Octree::workspace_bytes(count, options);
  stage.memory = std::make_unique<std::byte[]>(bytes);
  if (Octree::prepare(stage.octree, count, options, {stage.memory.get(), bytes}) != Status::ok) return stage;
  stage.points = stage.octree.build(all.view()).points;
  stage.box = fit.box;
  return stage;
}

OctreeLevelPicture show_octree_level(const OctreeStage& stage, int level) {
  OctreeLevelPicture out;
  const OctreeGrid& grid = stage.octree.grid();
  std::map<std::pair<double, double>, std::pair<OctreeBox, std::uint32_t>> columns;  // by x and depth
  std::uint32_t most = 1;
  for (const OctreeCell& cell : stage.octree.nodes().level(level)) {
    ++out.nodes;
    const OctreeBox box = grid.box_of(cell.code, level);
    auto& column = columns[{box.min.x, box.min.z}];
    column.first = box;
    column.second += cell.count;
    most = std::max(most, column.second);
  }
  Chart plan = plan_of(stage.box);
  const double whole = std::log1p(most);
  for (const auto& [place, column] : columns) {
    const Rgb colour = heat(0.15 + 0.75 * std::log1p(column.second) / whole);
    draw_square(plan, column.first, colour, mix(colour, ink, 0.5));
  }
  draw_camera(plan);
  out.picture = std::move(plan.picture());
  out.side_m = grid.leaf_m * std::exp2(level);
  return out;
}

OctreeQuestionPicture show_octree_question(const OctreeStage& stage) {
  OctreeQuestionPicture out;
  out.place = place_to_ask(stage);
  out.radius_m = 0.1 * std::max(stage.box.max.x - stage.box.min.x, stage.box.max.z - stage.box.min.z);
  const OctreeNodes& nodes = stage.octree.nodes();
  Chart plan = plan_of(stage.box);
  for (std::uint32_t i = 0; i < nodes.size();) {
    const OctreeBox box = stage.octree.grid().box_of(nodes[i].code(), nodes[i].level());
    const bool far = squared_distance(box, out.place) > out.radius_m * out.radius_m;
    const bool in_slice = box.min.y <= out.place.y && out.place.y < box.max.y;
    if (far) {
      ++out.passed_nodes;
      out.passed_points += nodes.count_of(i);
      if (in_slice) draw_square(plan, box, passed_colour, passed_border);
    } else if (nodes.is_leaf(i)) {
      ++out.leaves;
      out.leaf_points += nodes.count_of(i);
      if (in_slice) draw_square(plan, box, leaf_colour, leaf_border);
    }
    i = far ? nodes[i].next : i + 1;
  }
  std::vector<OctreeNeighbour> found(stage.points);
  out.found = static_cast<std::uint32_t>(stage.octree.radius(out.place, out.radius_m, found).found);
  const Point2 middle = plan.place(out.place.x, out.place.z);
  const double radius = plan.place(out.place.x + out.radius_m, out.place.z).x - middle.x;
  draw_circle(plan.picture(), middle, radius, {point_colour, 2, 1});
  draw_circle(plan.picture(), middle, 3, {point_colour, 3, 1});
  draw_camera(plan);
  out.picture = std::move(plan.picture());
  return out;
}

}  // namespace straightedge::cli
