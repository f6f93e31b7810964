// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "cli/planes_labels.hpp"

namespace straightedge::cli {

std::vector<LabelRun> runs_of(std::span<const std::uint16_t> labels) {
  std::vector<LabelRun> runs;
  for (const std::uint16_t label : labels) {
    if (runs.empty() || runs.back().label != label) runs.push_back({0, label});
    ++runs.back().length;
  }
  runs.shrink_to_fit();
  return runs;
}

std::vector<std::uint32_t> ids_of(std::span<const LabelRun> runs, std::span<const std::uint32_t> ids) {
  std::vector<std::uint32_t> all;
  for (const LabelRun& run : runs)
    all.insert(all.end(), run.length, run.label == 0 ? 0 : ids[run.label - 1U]);
  return all;
}

}  // namespace straightedge::cli
