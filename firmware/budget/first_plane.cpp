// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT

// The largest plane of a depth frame by RANSAC, from the raw frame to the fit to all of its pixels.
#include "budget/case.hpp"
#include "budget/depth_input.hpp"
#include "straightedge/ransac_planes.hpp"

namespace {

using namespace straightedge;

// Fewer readings than the default to score hypotheses on: as sure, for less.
constexpr RansacOptions options{.subset = 512};
[[gnu::section(".big.workspace")]] alignas(
    64) std::array<std::byte, RansacPlanes::workspace_bytes(firmware::most_pixels, options)> workspace;
std::array<FoundPlane, 1> planes;

bool measure(Size size) noexcept {
  const std::size_t bytes = RansacPlanes::workspace_bytes(firmware::pixels_of(size), options);
  const DepthView depth = firmware::room_depth(size);
  RansacPlanes ransac;
  const auto part = std::span(workspace).first(bytes);
  if (RansacPlanes::prepare(ransac, firmware::pixels_of(size), options, part) != Status::ok) return false;
  return firmware::count("RansacPlanes/first", size, bytes,
                         [&] { return ransac.run(depth, planes, {}).found.planes == 1; });
}

}  // namespace

int main() {
  for (const Size size : firmware::budget_sizes) {
    if (!measure(size)) return 1;
  }
}
