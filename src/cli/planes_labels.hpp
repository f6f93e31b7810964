// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace straightedge::cli {

/// Neighbours with one label.
struct LabelRun {
  std::uint32_t length = 0;
  std::uint16_t label = 0;
};

/// Labels of frames wait in this form until the whole map is known, which gives planes their ids.
std::vector<LabelRun> runs_of(std::span<const std::uint16_t> labels);

/// One entry a pixel or point: ids[label − 1], or 0 where there is no label.
std::vector<std::uint32_t> ids_of(std::span<const LabelRun> runs, std::span<const std::uint32_t> ids);

}  // namespace straightedge::cli
