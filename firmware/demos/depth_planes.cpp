// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT

// From a depth frame of 160x120 to its planes, with a label for every pixel. SEARCH proposes the planes:
// RansacSearch or HoughPatchSearch. Exit code 0: all planes of the room are found, and no others.
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "kit/semihosting.hpp"
#include "scenes/room.hpp"
#include "straightedge/frame_planes.hpp"
#include "straightedge/hough_plane_patches.hpp"
#include "straightedge/ransac_search.hpp"

namespace {

using straightedge::FoundPlane;
using straightedge::FramePlanes;
using straightedge::FramePlanesOptions;
using straightedge::HoughPatchOptions;
using straightedge::HoughPatchSearch;
using straightedge::ImageView;
using straightedge::PlanesFound;
using straightedge::RansacSearch;
using straightedge::RansacSearchOptions;
using straightedge::Size;
using straightedge::Status;

constexpr RansacSearchOptions options_of(const RansacSearch* /*search*/) noexcept {
  return {};
}
// A coarser accumulator than the default: a fifth of its memory.
constexpr HoughPatchOptions options_of(const HoughPatchSearch* /*search*/) noexcept {
  return {.accumulator = {straightedge::HoughCells::ball, 20, 64}};
}

constexpr Size size{160, 120};
constexpr std::size_t pixels = 160 * 120;
constexpr FramePlanesOptions frame_options{.max_planes = 16};
constexpr auto search_options =
    for_frame(options_of(static_cast<const SEARCH*>(nullptr)), size, frame_options);

// Sizes are constant expressions: memory that a board does not have is a link error. The larger workspace
// lies in the board's slower memory, as it would behind a camera.
[[gnu::section(".big.frame")]] alignas(
    64) std::array<std::byte, FramePlanes::workspace_bytes(size, frame_options)> frame_memory;
alignas(64) std::array<std::byte, SEARCH::workspace_bytes(size, search_options)> search_memory;
std::array<std::uint16_t, pixels> depth;
std::array<std::uint16_t, pixels> labels;
std::array<FoundPlane, frame_options.max_planes> planes;

void say(const char* words, std::uint32_t number) noexcept {
  firmware::write(words);
  firmware::write(number);
}

}  // namespace

int main() {
  const ImageView<std::uint16_t> raw(depth.data(), size);
  firmware::draw_room(raw);

  FramePlanes frame;
  if (frame.prepare(size, frame_options, frame_memory) != Status::ok) return 1;
  SEARCH search;
  if (SEARCH::prepare(search, size, search_options, search_memory) != Status::ok) return 2;
  PlanesFound found;
  const Status status = frame.run({.raw = raw, .metres_per_unit = 0.001, .camera = firmware::kinect(size)},
                                  plane_search(search), {labels.data(), size}, planes, found);
  if (status != Status::ok) return 3;

  const auto score = firmware::score_room(std::span(planes).first(found.planes));
  say("planes of the room ", score.planes);
  say(", found ", score.found);
  say(", found but not there ", score.wrong);
  say(", pixels labelled ", found.labelled);
  say(" of ", found.readings);
  say("; workspaces ", static_cast<std::uint32_t>(frame_memory.size()));
  say(" and ", static_cast<std::uint32_t>(search_memory.size()));
  say(" bytes, stack ", firmware::stack_used());
  firmware::write(" bytes\n");
  return score.found == score.planes && score.wrong == 0 ? 0 : 4;
}
