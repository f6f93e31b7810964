// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "straightedge/edge_position.hpp"
#include "straightedge/host/image.hpp"
#include "straightedge/host/kernels.hpp"

namespace straightedge {

/// The edge points of a picture, each found once: every pixel is looked at by several candidates, and by each
/// more than once.
class EdgePoints {
 public:
  /// All points of `edges`, whose pixels are not 0.
  void find(GrayView edges, const GradientField& field, const KernelSet& kernels);

  const EdgeTable& table() const { return table_; }

 private:
  Image<std::uint32_t> numbers_;
  std::vector<EdgePoint> points_;
  EdgeTable table_;
};

}  // namespace straightedge
