// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "straightedge/plane.hpp"

namespace straightedge {

/// What a trace of a plane search is told about.
enum class HoughPlaneStep : std::uint8_t {
  vote,   ///< `voter` has voted; `plane` is its own (standard: none, a point is on many)
  peak,   ///< a cell that stands out, `plane` at its centre, its `votes`
  plane,  ///< a plane was found, `plane` as fitted; `voter` is its number, from 1
};

struct HoughPlaneEvent {
  HoughPlaneStep step = HoughPlaneStep::vote;
  Plane plane;
  std::uint32_t voter = 0;  ///< standard: the point; randomized: the triple; patch: the patch
  std::uint32_t votes = 0;
};

/// Watches a run. `event` returns false to stop it, which gives `cancelled`.
struct HoughPlaneTrace {
  bool (*event)(void* user, const HoughPlaneEvent&) = nullptr;
  void* user = nullptr;

  bool operator()(const HoughPlaneEvent& e) const noexcept { return event == nullptr || event(user, e); }
};

}  // namespace straightedge
