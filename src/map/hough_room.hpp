// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "straightedge/hough_lines.hpp"

namespace straightedge {

/// The Hough transform of lines in memory that is kept from one run to the next.
class HoughRoom {
 public:
  HoughResult result;  ///< of the last run

  /// The segments stay until the next run. When there is too little room for them it is doubled and the run,
  /// which is deterministic, repeated.
  std::span<const HoughSegment> run(GrayView edges, GradientView gradients, const HoughOptions& options);

 private:
  std::unique_ptr<std::byte[]> memory_;
  std::size_t bytes_ = 0;
  std::vector<HoughSegment> segments_;
  std::vector<HoughPeak> peaks_;
};

}  // namespace straightedge
