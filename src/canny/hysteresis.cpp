// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "straightedge/hysteresis.hpp"

#include <cstring>

#include "straightedge/suppress.hpp"

namespace straightedge {
namespace {

constexpr std::uint8_t edge = 255;

// The flood fill's state: marked pixels in `edges`, those whose neighbours are still to be seen on `stack`.
struct Flood {
  GrayView classes;
  ImageView<std::uint8_t> edges;
  std::uint32_t* stack;
  HysteresisTrace trace;
  std::size_t waiting = 0;
  std::uint32_t marked = 0;
};

// False when the trace asks to stop.
bool mark_and_push(Flood& flood, HysteresisStep step) noexcept {
  flood.edges.at(step.x, step.y) = edge;
  const auto row_start = static_cast<std::size_t>(step.y) * static_cast<std::size_t>(flood.edges.width);
  flood.stack[flood.waiting++] = static_cast<std::uint32_t>(row_start + static_cast<std::size_t>(step.x));
  ++flood.marked;
  if (flood.trace.step == nullptr) return true;
  step.waiting = flood.waiting;
  return flood.trace.step(flood.trace.user, step);
}

bool push_neighbours(Flood& flood, std::int32_t x, std::int32_t y) noexcept {
  for (std::int32_t ny = y - 1; ny <= y + 1; ++ny) {
    for (std::int32_t nx = x - 1; nx <= x + 1; ++nx) {
      if (!flood.classes.contains(nx, ny)) continue;
      if (flood.classes.at(nx, ny) == no_edge || flood.edges.at(nx, ny) == edge) continue;
      if (!mark_and_push(flood, {nx, ny, x, y})) return false;
    }
  }
  return true;
}

// Step 3.
bool empty_stack(Flood& flood) noexcept {
  const auto width = static_cast<std::uint32_t>(flood.edges.width);
  while (flood.waiting > 0) {
    const std::uint32_t index = flood.stack[--flood.waiting];
    const auto x = static_cast<std::int32_t>(index % width);
    const auto y = static_cast<std::int32_t>(index / width);
    if (!push_neighbours(flood, x, y)) return false;
  }
  return true;
}

}  // namespace

HysteresisResult hysteresis(GrayView classes, std::span<std::uint32_t> stack, ImageView<std::uint8_t> edges,
                            HysteresisTrace trace) noexcept {
  if (!classes.valid() || !edges.valid()) return {Status::invalid_image};
  if (classes.size() != edges.size()) return {Status::size_mismatch};
  const auto pixels = static_cast<std::uint64_t>(classes.width) * static_cast<std::uint64_t>(classes.height);
  if (pixels > UINT32_MAX) return {Status::too_large};
  if (stack.size() < pixels) return {Status::workspace_too_small};

  // Step 1.
  HysteresisResult result;
  Flood flood{classes, edges, stack.data(), trace};
  for (std::int32_t y = 0; y < edges.height; ++y) {
    std::memset(edges.row(y), 0, static_cast<std::size_t>(edges.width));
  }
  for (std::int32_t y = 0; y < edges.height; ++y) {
    for (std::int32_t x = 0; x < edges.width; ++x) {
      if (classes.at(x, y) < strong_edge) continue;
      ++result.strong;
      if (result.status == Status::cancelled || edges.at(x, y) == edge) continue;
      // Step 2.
      if (!mark_and_push(flood, {x, y, x, y}) || !empty_stack(flood)) result.status = Status::cancelled;
    }
  }
  result.edges = flood.marked;
  return result;
}

}  // namespace straightedge
