// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT

// All planes of a depth frame with a label for each pixel; SEARCH is RansacSearch or HoughPatchSearch.
#include "straightedge/frame_planes.hpp"
#include "budget/case.hpp"
#include "budget/depth_input.hpp"
#include "straightedge/hough_plane_patches.hpp"
#include "straightedge/ransac_search.hpp"

namespace {

using namespace straightedge;

constexpr RansacSearchOptions options_of(const RansacSearch* /*search*/) noexcept {
  return {};
}
constexpr HoughPatchOptions options_of(const HoughPatchSearch* /*search*/) noexcept {
  return {.accumulator = {HoughCells::ball, 20, 64}};
}

constexpr FramePlanesOptions options{.max_planes = 16};
constexpr auto search_options(Size size) noexcept {
  return for_frame(options_of(static_cast<const SEARCH*>(nullptr)), size, options);
}

constexpr Size most{640, 480};
[[gnu::section(".big.frame")]] alignas(
    64) std::array<std::byte, FramePlanes::workspace_bytes(most, options)> workspace;
[[gnu::section(".big.search")]] alignas(
    64) std::array<std::byte, SEARCH::workspace_bytes(most, search_options(most))> search_workspace;
[[gnu::section(".big.labels")]] std::array<std::uint16_t, firmware::most_pixels> labels;
std::array<FoundPlane, 16> planes;

bool measure(Size size) noexcept {
  const std::size_t bytes = FramePlanes::workspace_bytes(size, options);
  const std::size_t more = SEARCH::workspace_bytes(size, search_options(size));
  const DepthView depth = firmware::room_depth(size);
  FramePlanes frame;
  SEARCH search;
  const auto part = std::span(search_workspace).first(more);
  if (frame.prepare(size, options, std::span(workspace).first(bytes)) != Status::ok) return false;
  if (SEARCH::prepare(search, size, search_options(size), part) != Status::ok) return false;
  PlanesFound found;
  return firmware::count("FramePlanes/" NAME_OF(SEARCH), size, bytes + more, [&] {
    return frame.run(depth, plane_search(search), {labels.data(), size}, planes, found) == Status::ok &&
           found.planes == 5;
  });
}

}  // namespace

int main() {
  for (const Size size : firmware::budget_sizes) {
    if (!measure(size)) return 1;
  }
}
