// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "ransac/contest.hpp"
#include "ransac/lattice.hpp"
#include "ransac/support.hpp"
#include "ransac/window.hpp"
#include "straightedge/ransac_search.hpp"

namespace straightedge {
namespace {

using ransac::Lattice;
using ransac::Window;
using ransac::WindowShape;

/// Windows of 49, 21 and 11 cells: about 200 readings each.
constexpr WindowShape window_shapes[] = {{24, 3}, {10, 2}, {5, 1}};

/// Streams of windows begin above those of the rows of cells.
constexpr std::uint64_t first_window_stream = std::uint64_t{1} << 32U;

struct Search {
  const RansacSearchOptions& options;
  const Lattice& lattice;
  RansacSearchResult& result;
  std::uint32_t least_cells = 0;
  Window window;
};

/// Fewer than six readings carry no statistics, however small the plane may be.
std::uint32_t least_cells(const RansacSearchOptions& o) noexcept {
  const std::int32_t cells = o.min_pixels / (o.cell * o.cell);
  return cells < 6 ? 6 : static_cast<std::uint32_t>(cells);
}

/// One round of step 3. False: refused.
bool grow_to(Search& s, const ransac::CellBox& box, std::uint32_t least, InverseDepthFit& fit) noexcept {
  const std::span<const float> q = s.lattice.memory.free_q;
  if (ransac::mark_core(s.lattice, q, fit.plane, box) < least) return false;
  double rms_gates = 0;
  return ransac::refit_core(s.lattice, q, box, s.options.gate.inverse_sigma, fit, rms_gates) &&
         rms_gates <= s.options.max_rms;
}

/// Step 3.
bool grow(Search& s, std::int32_t column, std::int32_t row, std::int32_t half,
          InverseDepthFit& fit) noexcept {
  const std::int32_t longest = s.lattice.columns > s.lattice.rows ? s.lattice.columns : s.lattice.rows;
  for (std::int32_t h = half; h < longest; h *= 2)
    if (!grow_to(s, ransac::box_round(s.lattice, column, row, h), s.least_cells / 2, fit)) return false;
  return grow_to(s, ransac::whole(s.lattice), s.least_cells, fit);
}

/// The readings of the fit become its own. False: it has too few after all.
bool take(Search& s, const InverseDepthFit& fit) noexcept {
  const detail::RansacSearchMemory& m = s.lattice.memory;
  if (ransac::mark_core(s.lattice, m.free_q, fit.plane, ransac::whole(s.lattice)) < s.least_cells)
    return false;
  m.candidates[s.result.candidates++].fit = fit;
  for (std::size_t i = 0; i < m.free_q.size(); ++i)
    m.free_q[i] = m.core[i] != 0 ? ransac::no_reading : m.free_q[i];
  return true;
}

/// Steps 2 and 3 round one cell, until the window has no more planes.
void search_window(Search& s, std::int32_t column, std::int32_t row, const WindowShape& shape) noexcept {
  const auto share = static_cast<std::uint32_t>(shape.step > 1 ? shape.step * shape.step : 2);
  const std::uint32_t few = s.least_cells / share;
  const std::uint32_t least = few < 6 ? 6 : few;
  while (s.result.candidates < s.lattice.memory.candidates.size()) {
    ransac::gather(s.lattice, column, row, shape, s.window);
    if (s.window.count < least) return;
    const ransac::WindowPlane found =
        ransac::best_of_window(s.window, s.options, first_window_stream + s.result.windows++);
    s.result.draws += found.draws;
    if (found.inliers < least) return;
    InverseDepthFit fit;
    fit.plane = found.plane;
    if (!grow(s, column, row, shape.half, fit) || !take(s, fit)) return;
  }
}

/// Step 4.
void contest(Search& s) noexcept {
  const std::span<PlaneCandidate> candidates = s.lattice.memory.candidates.first(s.result.candidates);
  ransac::contest_cells(s.lattice, candidates);
  ransac::refit_owners(s.lattice, candidates, s.least_cells, s.options.gate.inverse_sigma);
  std::uint32_t kept = 0;
  for (const PlaneCandidate& candidate : candidates) {
    if (candidate.cells == 0) continue;
    s.result.explained += candidate.cells;
    // Insertion keeps candidates of equal score in the order in which they were found.
    std::uint32_t at = kept++;
    const PlaneCandidate moved = candidate;
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
  search.prepared_ = true;
  return Status::ok;
}

RansacSearchResult RansacSearch::run(ImageView<const float> inverse_depth,
                                     ImageView<const std::uint16_t> mask,
                                     std::span<PlaneCandidate> out) noexcept {
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
  // Steps 2 and 3.
  Search search{options_, lattice, result, least_cells(options_), {}};
  for (const WindowShape& shape : window_shapes)
    for (std::int32_t row = shape.half / 2; row < lattice.rows + shape.half / 2; row += shape.half)
      for (std::int32_t column = shape.half / 2; column < lattice.columns + shape.half / 2;
           column += shape.half)
        search_window(search, column, row, shape);
  // Step 4.
  contest(search);
  if (result.candidates > out.size()) {
    result.candidates = static_cast<std::uint32_t>(out.size());
    result.status = Status::output_full;
  }
  for (std::uint32_t i = 0; i < result.candidates; ++i) out[i] = memory_.candidates[i];
  return result;
}

}  // namespace straightedge
