// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "ransac/frame_noise.hpp"
#include "ransac/lattice.hpp"
#include "ransac/support.hpp"
#include "ransac/window.hpp"
#include "straightedge/ransac_search.hpp"

namespace straightedge {
namespace {

using ransac::Lattice;
using ransac::Window;
using ransac::window_half;

/// Cells from one window to the next: a plane of six by six cells is whole in one of them.
constexpr std::int32_t window_step = 8;

/// Least of a plane on a coarser level.
constexpr std::int32_t few_coarse_cells = 24;

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

struct Search {
  const RansacSearchOptions& options;
  std::span<const Lattice> lattices;  ///< the finest cells first
  RansacSearchResult& result;
  const detail::RansacSearchMemory& memory;
  double max_rms = 1;  ///< gates
  bool rough = false;
  std::uint32_t rough_planes = 0;  ///< that wait in memory.rough
};

/// Where a plane is looked for.
struct Place {
  const Lattice& lattice;
  std::int32_t column, row;   ///< middle of the window
  std::uint32_t least_cells;  ///< of a plane
};

/// Fewer than six readings carry no statistics, however small the plane may be; what has few of the coarser
/// cells has enough of the finest.
std::uint32_t least_cells(const RansacSearchOptions& o, const Lattice& lattice) noexcept {
  const std::int32_t cells = o.min_pixels / (lattice.cell * lattice.cell);
  const std::int32_t few = lattice.cell == o.cell ? 6 : few_coarse_cells;
  return static_cast<std::uint32_t>(cells < few ? few : cells);
}

enum class Growth : std::uint8_t { grown, too_small, too_rough };

/// Step 2.
std::uint32_t take_lattices(std::span<const Lattice> lattices, const DepthCells& cells,
                            const SearchGate& gate, ImageView<const std::uint16_t> mask) noexcept {
  for (const Lattice& lattice : lattices) ransac::take_lattice(lattice, cells, gate);
  if (mask.data != nullptr) {
    ransac::mask_lattice(lattices.front(), mask);
    for (std::size_t i = 1; i < lattices.size(); ++i) ransac::mask_coarser(lattices[i - 1], lattices[i]);
  }
  return ransac::count_readings(lattices.front());
}

/// One round of step 4.
Growth grow_to(const Search& s, const Lattice& lattice, const ransac::CellBox& box, std::uint32_t least,
               InverseDepthFit& fit, ransac::Core& core) noexcept {
  core = ransac::mark_core(lattice, fit.plane, box);
  if (core.cells < least) return Growth::too_small;
  // A thousand readings fix a plane better than the lattice of cells can tell.
  const auto row_step =
      static_cast<std::int32_t>(core.cells < 2 * enough_cells ? 1 : core.cells / enough_cells);
  double rms_gates = 0;
  if (!ransac::refit_core(lattice, core.bounds, row_step, s.options.gate.inverse_sigma, fit, rms_gates))
    return Growth::too_small;
  core.rms_gates = rms_gates;
  return rms_gates <= s.max_rms ? Growth::grown : Growth::too_rough;
}

/// The plane waits for step 5. Windows round the marked cells need not be searched again on this level: they
/// would end the same way.
void set_aside(Search& s, const Place& place, const InverseDepthPlane& plane,
               const ransac::CellBox& box) noexcept {
  const Lattice& l = place.lattice;
  if (s.rough_planes < s.memory.rough.size()) {
    const SearchPlane p = ransac::in_floats(plane);
    s.memory.rough[s.rough_planes++] = {p.a,
                                        p.b,
                                        p.c,
                                        static_cast<std::int16_t>(place.column),
                                        static_cast<std::int16_t>(place.row),
                                        static_cast<std::int16_t>(&l - s.lattices.data())};
  }
  // Of the cells that are middles of windows.
  const auto first = [&](std::int32_t from, std::int32_t at) noexcept {
    const std::int32_t middle = at - (at - from) / window_step * window_step;
    return middle < from ? middle + window_step : middle;
  };
  for (std::int32_t y = first(box.y0, place.row); y < box.y1; y += window_step)
    for (std::int32_t x = first(box.x0, place.column); x < box.x1; x += window_step) {
      const std::size_t i = l.at(x, y);
      l.cells.aside[i] = static_cast<std::uint8_t>(l.cells.aside[i] | l.cells.core[i]);
    }
}

bool inside(const ransac::CellBox& a, const ransac::CellBox& b, const Lattice& l) noexcept {
  return (a.x0 > b.x0 || b.x0 == 0) && (a.y0 > b.y0 || b.y0 == 0) && (a.x1 < b.x1 || b.x1 == l.columns) &&
         (a.y1 < b.y1 || b.y1 == l.rows);
}

/// Step 4. True: the marked cells are the plane's.
bool grow(Search& s, const Place& place, InverseDepthFit& fit, ransac::Core& core) noexcept {
  const Lattice& l = place.lattice;
  const std::int32_t longest = l.columns > l.rows ? l.columns : l.rows;
  for (std::int32_t half = window_half;; half *= growing) {
    // Twice half of the picture's longer side is nearly all of it.
    const bool last = half > window_half && 2 * half >= longest;
    const ransac::CellBox box = last ? ransac::whole(l) : ransac::box_round(l, place.column, place.row, half);
    const std::uint32_t before = core.cells;
    const Growth growth = grow_to(s, l, box, last ? place.least_cells : place.least_cells / 2, fit, core);
    if (growth == Growth::too_rough && !s.rough) set_aside(s, place, fit.plane, core.bounds);
    if (growth != Growth::grown) return false;
    if (last && core.cells < much * before) return true;
    if (!last && half > window_half && inside(core.bounds, box, l)) return core.cells >= place.least_cells;
  }
}

/// The marked cells of a lattice are no longer free.
void empty_marked(const Lattice& l, const ransac::CellBox& box) noexcept {
  const std::size_t first = l.at(box.x0, box.y0);
  l.kernels.empty_marked(&l.cells.core[first], {box.x1 - box.x0, box.y1 - box.y0, l.stride},
                         ransac::no_reading, &l.cells.q[first]);
}

/// The plane's readings of all levels become its own. False: the finest cells know of no such plane.
bool take(Search& s, const Place& place, const InverseDepthFit& fit, const ransac::Core& grown) noexcept {
  const Lattice& finest = s.lattices.front();
  const ransac::Core core = ransac::mark_core(
      finest, fit.plane, ransac::box_over(finest, place.lattice, grown.bounds), 1 / ransac::mean_gate);
  if (core.cells < least_cells(s.options, finest)) return false;
  const double rms = grown.rms_gates * static_cast<double>(ransac::mean_gate);
  s.memory.candidates[s.result.candidates++] = {.fit = fit,
                                                .score = core.cells * (1 - rms * rms),
                                                .readings = core.cells,
                                                .rough = s.rough,
                                                .column0 = core.bounds.x0 * finest.cell,
                                                .row0 = core.bounds.y0 * finest.cell,
                                                .column1 = core.bounds.x1 * finest.cell,
                                                .row1 = core.bounds.y1 * finest.cell};
  s.result.explained += core.cells;
  empty_marked(finest, core.bounds);
  for (const Lattice& coarser : s.lattices.subspan(1))
    empty_marked(coarser,
                 ransac::mark_core(coarser, fit.plane, ransac::box_over(coarser, finest, core.bounds),
                                   1 / ransac::mean_gate)
                     .bounds);
  return true;
}

/// Steps 3 and 4 round one cell, until the window has no more planes.
void search_window(Search& s, const Place& place) noexcept {
  const Lattice& l = place.lattice;
  Window& window = s.memory.window.front();
  const std::uint32_t half = place.least_cells / 2, least = half < 6 ? 6 : half;
  while (s.result.candidates < s.memory.candidates.size()) {
    if (ransac::count_free(l, place.column, place.row) < least) return;
    ransac::gather(l, place.column, place.row, window);
    if (window.count < least) return;
    const ransac::WindowPlane found = ransac::best_of_window(l, window, s.options, s.result.windows++);
    s.result.draws += found.draws;
    if (found.inliers < least) return;
    InverseDepthFit fit;
    fit.plane = found.plane;
    ransac::Core core;
    if (found.rms > window_slack * s.max_rms) {
      const ransac::CellBox box = ransac::box_round(l, place.column, place.row, window_half);
      set_aside(s, place, fit.plane, ransac::mark_core(l, fit.plane, box).bounds);
      return;
    }
    if (!grow(s, place, fit, core) || !take(s, place, fit, core)) return;
  }
}

/// Of the windows along so many cells, in steps from here to the border: the last window may be half beyond.
constexpr std::int32_t first_middle(std::int32_t cells) noexcept {
  return cells > window_step ? window_step / 2 : cells / 2;
}

/// Steps 3 and 4 on one level.
void search_windows(Search& s, const Lattice& l) noexcept {
  constexpr auto cells = static_cast<std::uint32_t>((2 * window_half + 1) * (2 * window_half + 1));
  const std::uint32_t least = least_cells(s.options, l);
  // Windows smaller than the smallest plane find nothing that larger ones do not.
  if (cells < least) return;
  for (std::uint8_t& aside : l.cells.aside) aside = 0;
  for (std::int32_t row = first_middle(l.rows); row <= l.rows; row += window_step)
    for (std::int32_t column = first_middle(l.columns); column <= l.columns; column += window_step)
      if (l.cells.aside[l.at(column, row)] == 0) search_window(s, {l, column, row, least});
}

/// Step 5.
void grow_rough(Search& s) noexcept {
  s.rough = true;
  s.max_rms = s.options.rough_rms;
  for (const detail::RansacRoughPlane& r : s.memory.rough.first(s.rough_planes)) {
    if (s.result.candidates == s.memory.candidates.size()) return;
    const Lattice& l = s.lattices[static_cast<std::size_t>(r.level)];
    const Place place{l, r.column, r.row, least_cells(s.options, l)};
    InverseDepthFit fit;
    fit.plane = {static_cast<double>(r.a), static_cast<double>(r.b), static_cast<double>(r.c)};
    ransac::Core core;
    if (grow(s, place, fit, core)) (void)take(s, place, fit, core);
  }
}

/// Step 6. Candidates of equal score stay in the order in which they were found.
void sort_by_score(std::span<ProposedPlane> candidates) noexcept {
  for (std::size_t i = 1; i < candidates.size(); ++i) {
    const ProposedPlane moved = candidates[i];
    std::size_t at = i;
    for (; at > 0 && candidates[at - 1].score < moved.score; --at) candidates[at] = candidates[at - 1];
    candidates[at] = moved;
  }
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
  for (int level = detail::finest_level(options); level <= detail::coarsest_level(options); ++level)
    ransac::clear_lattice(Lattice(size, level, search.options_, search.memory_));
  search.prepared_ = true;
  return Status::ok;
}

RansacSearchResult RansacSearch::run(const DepthCells& cells, ImageView<const std::uint16_t> mask,
                                     std::span<ProposedPlane> out) noexcept {
  RansacSearchResult result;
  result.seed = options_.seed;
  if (!prepared_) return result;
  const int finest = detail::finest_level(options_), coarsest = detail::coarsest_level(options_);
  const bool masked = mask.data != nullptr;
  result.status = masked && !mask.valid() ? Status::invalid_image
                  : cells.finest() > finest || cells.size(finest) != DepthCells::size_of(size_, finest) ||
                          (masked && mask.size() != size_)
                      ? Status::size_mismatch
                      : Status::ok;
  if (result.status != Status::ok) return result;
  const std::array<Lattice, 3> all{Lattice(size_, finest, options_, memory_),
                                   Lattice(size_, finest + 1, options_, memory_),
                                   Lattice(size_, coarsest, options_, memory_)};
  const std::span<const Lattice> lattices(all.data(), static_cast<std::size_t>(coarsest - finest + 1));
  // Step 1.
  result.noise = ransac::frame_noise(lattices.back(), cells, options_);
  // Step 2.
  result.readings = take_lattices(lattices, cells, ransac::search_gate(options_.gate, result.noise), mask);
  // Steps 3 to 5.
  Search search{options_, lattices, result, memory_, options_.max_rms};
  for (std::size_t i = lattices.size(); i-- > 0;) search_windows(search, lattices[i]);
  if (options_.rough_rms > options_.max_rms) grow_rough(search);
  // Step 6.
  sort_by_score(memory_.candidates.first(result.candidates));
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

}  // namespace straightedge
