// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "straightedge/detail/plane_run.hpp"

namespace straightedge {

/// The memory of a table of runs, which frames take one after another.
class PlaneRuns {
 public:
  PlaneRuns(std::vector<detail::PlaneRun>& runs, std::vector<std::uint32_t>& slots);

  /// The table, with room for `more` runs.
  detail::PlaneRunTable& with_room_for(std::size_t more) {
    if (table_.used + more > room_) grow(more);
    return table_;
  }
  std::span<const detail::PlaneRun> all() const noexcept { return {table_.runs, table_.used}; }

 private:
  void grow(std::size_t more);

  std::vector<detail::PlaneRun>& runs_;
  std::vector<std::uint32_t>& slots_;
  detail::PlaneRunTable table_;
  std::size_t room_ = 0;
};

}  // namespace straightedge
