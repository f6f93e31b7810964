// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT

// Planes of a cloud by votes; the voting is VOTING: standard or randomized.
#include "straightedge/hough_planes.hpp"
#include "budget/cloud_input.hpp"

namespace {

using namespace straightedge;

constexpr HoughPlaneOptions options{.voting = HoughPlaneVoting::VOTING,
                                    .accumulator = {HoughCells::ball, 20, 64},
                                    .gate = {.fixed_m = 0.03},
                                    .min_points = 30,
                                    .max_planes = 16,
                                    .max_draws = 20'000};
[[gnu::section(".big.workspace")]] alignas(
    64) std::array<std::byte, HoughPlanes::workspace_bytes(firmware::most_points, options)> workspace;
std::array<std::uint16_t, firmware::most_points> labels;
std::array<FoundPlane, 16> planes;

bool measure(Size size) noexcept {
  const std::uint32_t count = firmware::points_of(size);
  const std::size_t bytes = HoughPlanes::workspace_bytes(count, options);
  const PointsView points = firmware::room_points(size);
  HoughPlanes hough;
  if (HoughPlanes::prepare(hough, count, options, std::span(workspace).first(bytes)) != Status::ok)
    return false;
  PlanesFound found;
  return firmware::count("HoughPlanes/" NAME_OF(VOTING), size, bytes, [&] {
    return hough.run(points, std::span(labels).first(count), planes, found) == Status::ok &&
           found.planes >= 3;
  });
}

}  // namespace

int main() {
  for (const Size size : firmware::budget_sizes) {
    if (!measure(size)) return 1;
  }
}
