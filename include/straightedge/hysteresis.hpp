// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "straightedge/image.hpp"
#include "straightedge/status.hpp"

namespace straightedge {

/// One event of the flood fill: a pixel becomes an edge.
struct HysteresisStep {
  std::int32_t x = 0, y = 0;            ///< the pixel
  std::int32_t from_x = 0, from_y = 0;  ///< the edge pixel it was reached from; itself for a seed
  std::size_t waiting = 0;              ///< pixels on the stack, this one included
};

/// Looks at the flood fill while it runs. Return false to stop it. Costs one comparison an edge pixel
/// when null.
struct HysteresisTrace {
  bool (*step)(void* user, const HysteresisStep& step) = nullptr;
  void* user = nullptr;
};

struct HysteresisResult {
  Status status = Status::ok;
  std::uint32_t strong = 0;  ///< strong pixels, the seeds of the flood fill
  std::uint32_t edges = 0;   ///< pixels set in the output
};

/// Entries that the stack must have: one for each pixel. A pixel is marked when it is pushed and a marked
/// pixel is never pushed again, so no more than all pixels can ever wait.
constexpr std::size_t hysteresis_stack_size(Size size) noexcept {
  return static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height);
}

/// Edge tracking by hysteresis: weak pixels count where they hang together with strong ones.
///
/// Steps
///   1. Clear the output, then go through the classes (0 none, 1 weak, else strong) row by row.
///   2. A strong pixel that is not yet an edge is a seed: mark it and push it.
///   3. Pop a pixel; each of its eight neighbours that is weak or strong and not yet marked is marked and
///      pushed. Until the stack is empty. The border of the image is a wall.
///
/// The result is the same for any order of visits: it is the set of all pixels that can be reached.
/// J. Canny 1986, doi:10.1109/TPAMI.1986.4767851, section VIII.
///
/// `edges`: 255 on edges, 0 elsewhere. Errors, with `edges` untouched: `invalid_image`, `size_mismatch`,
/// `too_large` (2^32 pixels or more), `workspace_too_small`; `cancelled` when the trace asked to stop.
/// Time linear in pixels: each pixel is pushed at most once and looks at eight neighbours.
HysteresisResult hysteresis(GrayView classes, std::span<std::uint32_t> stack, ImageView<std::uint8_t> edges,
                            HysteresisTrace trace = {}) noexcept;

}  // namespace straightedge
