// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "map/plane_runs.hpp"

#include <algorithm>
#include <bit>

#include "map/plane_run_search.hpp"

namespace straightedge {
namespace {

constexpr std::size_t first_runs = 4096;

}  // namespace

PlaneRuns::PlaneRuns(std::vector<detail::PlaneRun>& runs, std::vector<std::uint32_t>& slots)
    : runs_(runs), slots_(slots) {
  std::fill(slots_.begin(), slots_.end(), 0U);
  if (runs_.empty()) grow(first_runs);
  table_.runs = runs_.data();
  table_.slots = slots_.data();
  table_.shift = static_cast<std::uint32_t>(64 - std::countr_zero(slots_.size()));
  room_ = runs_.size();
}

// Twice as many slots as runs keep searches short. Of runs of one leaf the last one, which has room, is the
// one to be found.
void PlaneRuns::grow(std::size_t more) {
  room_ = std::bit_ceil(std::max(table_.used + more, first_runs));
  runs_.resize(room_);
  slots_.assign(2 * room_, 0U);
  table_.runs = runs_.data();
  table_.slots = slots_.data();
  table_.shift = static_cast<std::uint32_t>(64 - std::countr_zero(slots_.size()));
  const std::uint32_t last = static_cast<std::uint32_t>(slots_.size()) - 1;
  for (std::uint32_t index = 0; index < table_.used; ++index) {
    const detail::PlaneRun& run = runs_[index];
    std::uint32_t slot = plain::run_slot(run.leaf, run.label, table_.shift);
    while (slots_[slot] != 0) {
      const detail::PlaneRun& other = runs_[slots_[slot] - 1];
      if (other.leaf == run.leaf && other.label == run.label) break;
      slot = (slot + 1) & last;
    }
    slots_[slot] = index + 1;
  }
}

}  // namespace straightedge
