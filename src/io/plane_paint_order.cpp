// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "io/plane_paint_order.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

#include "io/plane_rings.hpp"
#include "io/svg_canvas.hpp"
#include "straightedge/trigonometry.hpp"

namespace straightedge::io {
namespace {

constexpr double least_slack_m = 0.03, slack_share = 0.04;

/// What the order asks of a piece.
struct Item {
  Plane plane;  // upright
  std::size_t owner = 0;
  std::vector<Vector3> corners;
  Bounds box;
  double depth = 0;
  int eye = 0;  // the side of the plane on which the eye is
};

std::vector<Vector3> extreme_vertices(const std::vector<Vector3>& ring, const Vector3& normal) {
  const PlaneBasis basis(normal);
  std::vector<std::size_t> found;
  for (int k = 0; k < 16; ++k) {
    const SineCosine turn = sine_cosine(k * pi / 8);
    const Vector3 way = turn.cosine * basis.u + turn.sine * basis.v;
    const auto reach = [&](const Vector3& p) { return dot(way, p); };
    found.push_back(static_cast<std::size_t>(std::ranges::max_element(ring, {}, reach) - ring.begin()));
  }
  std::ranges::sort(found);
  found.erase(std::unique(found.begin(), found.end()), found.end());
  std::vector<Vector3> corners;
  for (const std::size_t i : found) corners.push_back(ring[i]);
  return corners;
}

/// 2 that of the normal, −2 the other one, 0 both; 1 and −1 when only a little sticks out.
int side_of(const std::vector<Vector3>& corners, const Plane& plane) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const Vector3& corner : corners) {
    low = std::min(low, plane.signed_distance(corner));
    high = std::max(high, plane.signed_distance(corner));
  }
  if (low >= 0 && high > 0) return 2;
  if (high <= 0 && low < 0) return -2;
  const double slack = std::max(least_slack_m, slack_share * (high - low));
  if (-low <= slack && high > slack) return 1;
  if (high <= slack && -low > slack) return -1;
  return 0;
}

Item item_of(const PlaneScene& scene, const ScenePiece& piece, const ParallelView& view) {
  const Plane& plane = scene.planes[piece.plane].plane->plane;
  Item item;
  item.plane = {upright(plane.normal, scene.up), plane.distance};
  item.owner = piece.plane;
  std::vector<Vector3> ring;
  for (const Vector3& p : piece.rings.front()) {
    ring.push_back(upright(p, scene.up));
    item.box.include(view.on_paper(ring.back()));
  }
  item.corners = extreme_vertices(ring, item.plane.normal);
  item.depth = dot(view.to_eye, upright(piece.anchor, scene.up));
  const double facing = dot(item.plane.normal, view.to_eye);
  item.eye = facing > 1e-9 ? 1 : facing < -1e-9 ? -1 : 0;
  return item;
}

bool apart(const Bounds& a, const Bounds& b) {
  return a.right <= b.left || b.right <= a.left || a.top <= b.bottom || b.top <= a.bottom;
}

/// How surely a hides behind b: 0 not at all, 2 with nothing sticking out.
int hides_behind(const Item& a, const Item& b) {
  return std::max({-side_of(a.corners, b.plane) * b.eye, side_of(b.corners, a.plane) * a.eye, 0});
}

}  // namespace

ParallelView ParallelView::from(double turn_rad, double tilt_rad) noexcept {
  const SineCosine turn = sine_cosine(turn_rad), tilt = sine_cosine(tilt_rad);
  ParallelView view;
  view.to_eye = {tilt.cosine * turn.cosine, tilt.cosine * turn.sine, tilt.sine};
  view.right = {-turn.sine, turn.cosine, 0};
  view.up = cross(view.to_eye, view.right);
  return view;
}

std::vector<std::size_t> paint_order(const PlaneScene& scene, const ParallelView& view) {
  const std::size_t n = scene.pieces.size();
  std::vector<Item> items;
  for (const ScenePiece& piece : scene.pieces) items.push_back(item_of(scene, piece, view));

  std::vector<std::vector<std::size_t>> before(n);  // of each piece, what has to wait for it
  std::vector<std::size_t> waits(n, 0);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = i + 1; j < n; ++j) {
      if (items[i].owner == items[j].owner || apart(items[i].box, items[j].box)) continue;
      const int ij = hides_behind(items[i], items[j]), ji = hides_behind(items[j], items[i]);
      if (ij == ji) continue;
      before[ij > ji ? i : j].push_back(ij > ji ? j : i);
      ++waits[ij > ji ? j : i];
    }
  }

  std::vector<std::size_t> waiting(n), order;
  std::iota(waiting.begin(), waiting.end(), std::size_t{0});
  std::ranges::stable_sort(waiting, {}, [&](std::size_t i) { return items[i].depth; });
  while (!waiting.empty()) {
    auto next = std::ranges::find_if(waiting, [&](std::size_t i) { return waits[i] == 0; });
    if (next == waiting.end()) next = waiting.begin();
    order.push_back(*next);
    for (const std::size_t j : before[*next]) --waits[j];
    waiting.erase(next);
  }
  return order;
}

}  // namespace straightedge::io
