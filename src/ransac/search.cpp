// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "ransac/contest.hpp"
#include "ransac/frame_noise.hpp"
#include "ransac/lattice.hpp"
#include "ransac/support.hpp"
#include "ransac/window.hpp"
#include "straightedge/ransac_search.hpp"

namespace straightedge {
namespace {

using ransac::Lattice;
using ransac::Window;
using ransac::WindowShape;

/// Windows of 49, 21 and 13 cells: about 150 readings each.
constexpr WindowShape window_shapes[] = {{24, 4}, {10, 2}, {6, 1}};

/// Streams of windows begin above those of the rows of cells.
constexpr std::uint64_t first_window_stream = std::uint64_t{1} << 32U;

/// Boxes grow by this.
constexpr std::int32_t growing = 4;
/// A plane that became so many times as large in the frame is worth another round there: bent surfaces are
/// larger for the plane of the whole than for that of a part.
constexpr std::uint32_t much = 2;

/// So many readings are enough for a round of growing.
constexpr std::uint32_t enough_cells = 1000;

/// Windows hold samples of what grows: their residuals may be so many times as large before growing is in
/// vain.
constexpr double window_slack = 1.1;

/// What memory.owner says of a cell during the search: a rough plane has it.
constexpr float rough_cell = 1;

struct Search {
  const RansacSearchOptions& options;
  const Lattice& lattice;
  RansacSearchResult& result;
  std::uint32_t least_cells = 0;
  double max_rms = 1;  ///< gates
  bool rough = false;
  Window& window;
  std::uint32_t rough_planes = 0;  ///< that wait in memory.rough
};

/// Fewer than six readings carry no statistics, however small the plane may be.
std::uint32_t least_cells(const RansacSearchOptions& o) noexcept {
  const std::int32_t cells = o.min_pixels / (o.cell * o.cell);
  return cells < 6 ? 6 : static_cast<std::uint32_t>(cells);
}

enum class Growth : std::uint8_t { grown, too_small, too_rough };

/// One round of step 4.
Growth grow_to(Search& s, const ransac::CellBox& box, std::uint32_t least, InverseDepthFit& fit,
               ransac::Core& core) noexcept {
  const std::span<const float> q = s.lattice.memory.free_q;
  core = ransac::mark_core(s.lattice, q, fit.plane, box);
  if (core.cells < least) return Growth::too_small;
  // A thousand readings fix a plane better than the lattice of cells can tell.
  const auto row_step =
      static_cast<std::int32_t>(core.cells < 2 * enough_cells ? 1 : core.cells / enough_cells);
  double rms_gates = 0;
  if (!ransac::refit_core(s.lattice, q, core.bounds, row_step, s.options.gate.inverse_sigma, fit, rms_gates))
    return Growth::too_small;
  return rms_gates <= s.max_rms ? Growth::grown : Growth::too_rough;
}

/// The plane waits for step 5. Windows round the marked cells need not be searched again with this shape:
/// they would end the same way.
void set_aside(Search& s, std::int32_t column, std::int32_t row, std::int32_t half,
               const InverseDepthPlane& plane, const ransac::CellBox& box) noexcept {
  const detail::RansacSearchMemory& m = s.lattice.memory;
  if (s.rough_planes < m.rough.size()) {
    const SearchPlane p = ransac::in_floats(plane);
    m.rough[s.rough_planes++] = {p.a,
                                 p.b,
                                 p.c,
                                 static_cast<std::int16_t>(column),
                                 static_cast<std::int16_t>(row),
                                 static_cast<std::int16_t>(half)};
  }
  // Of the cells that are middles of windows.
  const auto first = [&](std::int32_t from, std::int32_t at) noexcept {
    const std::int32_t place = at - (at - from) / half * half;
    return place < from ? place + half : place;
  };
  for (std::int32_t y = first(box.y0, row); y < box.y1; y += half)
    for (std::int32_t x = first(box.x0, column); x < box.x1; x += half) {
      const std::size_t i = s.lattice.at(x, y);
      m.owner[i] = m.core[i] != 0 ? rough_cell : m.owner[i];
    }
}

bool inside(const ransac::CellBox& a, const ransac::CellBox& b, const Lattice& l) noexcept {
  return (a.x0 > b.x0 || b.x0 == 0) && (a.y0 > b.y0 || b.y0 == 0) && (a.x1 < b.x1 || b.x1 == l.columns) &&
         (a.y1 < b.y1 || b.y1 == l.rows);
}

/// Step 4. True: the marked cells are the plane's.
bool grow(Search& s, std::int32_t column, std::int32_t row, std::int32_t half, InverseDepthFit& fit,
          ransac::Core& core) noexcept {
  const std::int32_t longest = s.lattice.columns > s.lattice.rows ? s.lattice.columns : s.lattice.rows;
  for (std::int32_t h = half;; h *= growing) {
    // Twice half of the picture's longer side is nearly all of it.
    const bool last = h > half && 2 * h >= longest;
    const ransac::CellBox box =
        last ? ransac::whole(s.lattice) : ransac::box_round(s.lattice, column, row, h);
    const std::uint32_t before = core.cells;
    const Growth growth = grow_to(s, box, last ? s.least_cells : s.least_cells / 2, fit, core);
    if (growth == Growth::too_rough && !s.rough) set_aside(s, column, row, half, fit.plane, core.bounds);
    if (growth != Growth::grown) return false;
    if (last && core.cells < much * before) return true;
    if (!last && h > half && inside(core.bounds, box, s.lattice)) return core.cells >= s.least_cells;
  }
}

/// The marked readings become the plane's own.
void take(Search& s, const InverseDepthFit& fit, const ransac::Core& core) noexcept {
  const detail::RansacSearchMemory& m = s.lattice.memory;
  ProposedPlane& candidate = m.candidates[s.result.candidates++];
  const std::int32_t cell = s.lattice.cell;
  candidate = {.fit = fit,
               .rough = s.rough,
               .column0 = core.bounds.x0 * cell,
               .row0 = core.bounds.y0 * cell,
               .column1 = core.bounds.x1 * cell,
               .row1 = core.bounds.y1 * cell};
  for (std::int32_t row = core.bounds.y0; row < core.bounds.y1; ++row)
    for (std::int32_t column = core.bounds.x0; column < core.bounds.x1; ++column) {
      const std::size_t i = s.lattice.at(column, row);
      m.free_q[i] = m.core[i] != 0 ? ransac::no_reading : m.free_q[i];
    }
}

/// Steps 3 and 4 round one cell, until the window has no more planes.
void search_window(Search& s, std::int32_t column, std::int32_t row, const WindowShape& shape) noexcept {
  const auto share = static_cast<std::uint32_t>(shape.step > 1 ? shape.step * shape.step : 2);
  const std::uint32_t few = s.least_cells / share;
  const std::uint32_t least = few < 6 ? 6 : few;
  while (s.result.candidates < s.lattice.memory.candidates.size()) {
    if (ransac::count_free(s.lattice, column, row, shape.half) < least) return;
    ransac::gather(s.lattice, column, row, shape, s.window);
    if (s.window.count < least) return;
    const ransac::WindowPlane found =
        ransac::best_of_window(s.lattice, s.window, s.options, first_window_stream + s.result.windows++);
    s.result.draws += found.draws;
    if (found.inliers < least) return;
    InverseDepthFit fit;
    fit.plane = found.plane;
    ransac::Core core;
    if (found.rms > window_slack * s.max_rms) {
      const ransac::CellBox box = ransac::box_round(s.lattice, column, row, shape.half);
      set_aside(s, column, row, shape.half, fit.plane,
                ransac::mark_core(s.lattice, s.lattice.memory.free_q, fit.plane, box).bounds);
      return;
    }
    if (!grow(s, column, row, shape.half, fit, core)) return;
    take(s, fit, core);
  }
}

/// Steps 3 and 4 with windows of one shape.
void search_windows(Search& s, const WindowShape& shape) noexcept {
  const Lattice& l = s.lattice;
  // Windows smaller than the smallest plane find nothing that larger ones do not.
  if (static_cast<std::uint32_t>((2 * shape.half + 1) * (2 * shape.half + 1)) < s.least_cells) return;
  for (float& owner : l.memory.owner) owner = 0;
  const std::int32_t first = shape.half / 2;
  for (std::int32_t row = first; row < l.rows; row += shape.half)
    for (std::int32_t column = first; column < l.columns; column += shape.half)
      if (l.memory.owner[l.at(column, row)] != rough_cell) search_window(s, column, row, shape);
}

/// Step 5.
void grow_rough(Search& s) noexcept {
  s.rough = true;
  s.max_rms = s.options.rough_rms;
  for (const detail::RansacRoughPlane& r : s.lattice.memory.rough.first(s.rough_planes)) {
    if (s.result.candidates == s.lattice.memory.candidates.size()) return;
    InverseDepthFit fit;
    fit.plane = {static_cast<double>(r.a), static_cast<double>(r.b), static_cast<double>(r.c)};
    ransac::Core core;
    if (grow(s, r.column, r.row, r.half, fit, core)) take(s, fit, core);
  }
}

/// Step 6.
void contest(Search& s) noexcept {
  const std::span<ProposedPlane> candidates = s.lattice.memory.candidates.first(s.result.candidates);
  ransac::contest_cells(s.lattice, candidates);
  ransac::refit_owners(s.lattice, candidates, s.least_cells, s.options.gate.inverse_sigma);
  std::uint32_t kept = 0;
  for (const ProposedPlane& candidate : candidates) {
    if (candidate.readings == 0) continue;
    s.result.explained += candidate.readings;
    // Insertion keeps candidates of equal score in the order in which they were found.
    std::uint32_t at = kept++;
    const ProposedPlane moved = candidate;
    for (; at > 0 && candidates[at - 1].score < moved.score; --at) candidates[at] = candidates[at - 1];
    candidates[at] = moved;
  }
  s.result.candidates = kept;
}

}  // namespace

Status RansacSearch::prepare(RansacSearch& search, Size size, const RansacSearchOptions& options,
                             std::span<std::byte> workspace) noexcept {
  search.prepared_ = false;
  if (!fits(size)) return Status::invalid_image;
  if (!detail::valid(options)) return Status::invalid_option;
  Arena arena(workspace);
  search.memory_ = detail::RansacSearchMemory::take(arena, size, options);
  if (arena.failed()) return Status::workspace_too_small;
  search.size_ = size;
  search.options_ = options;
  ransac::clear_lattice(Lattice(size, search.options_, search.memory_));
  search.prepared_ = true;
  return Status::ok;
}

RansacSearchResult RansacSearch::run(ImageView<const float> inverse_depth,
                                     ImageView<const std::uint16_t> mask,
                                     std::span<ProposedPlane> out) noexcept {
  RansacSearchResult result;
  result.seed = options_.seed;
  if (!prepared_) return result;
  const bool masked = mask.data != nullptr;
  result.status = !inverse_depth.valid() || (masked && !mask.valid())                 ? Status::invalid_image
                  : inverse_depth.size() != size_ || (masked && mask.size() != size_) ? Status::size_mismatch
                                                                                      : Status::ok;
  if (result.status != Status::ok) return result;
  // Step 1.
  const Lattice lattice(size_, options_, memory_);
  result.readings = ransac::draw_lattice(lattice, inverse_depth, mask, options_);
  // Step 2.
  result.noise = ransac::frame_noise(lattice, options_);
  ransac::widen_gates(lattice, result.noise);
  // Steps 3 to 5.
  Search search{
      options_, lattice, result, least_cells(options_), options_.max_rms, false, memory_.window.front()};
  for (const WindowShape& shape : window_shapes) search_windows(search, shape);
  if (options_.rough_rms > options_.max_rms) grow_rough(search);
  // Step 6.
  contest(search);
  if (result.candidates > out.size()) {
    result.candidates = static_cast<std::uint32_t>(out.size());
    result.status = Status::output_full;
  }
  for (std::uint32_t i = 0; i < result.candidates; ++i) {
    out[i] = memory_.candidates[i];
    out[i].iterations = result.draws;
  }
  return result;
}

PlaneSearch plane_search(RansacSearch& search) noexcept {
  return {&search, [](void* user, ImageView<const float> inverse_depth, const DepthCells& /*cells*/,
                      ImageView<const std::uint16_t> labels, const PinholeCamera& /*camera*/,
                      std::span<ProposedPlane> out, std::uint32_t& count) noexcept {
            const RansacSearchResult result =
                static_cast<RansacSearch*>(user)->run(inverse_depth, labels, out);
            count = result.candidates;
            return result.status;
          }};
}

}  // namespace straightedge
