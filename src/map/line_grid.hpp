// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "map/wall_line.hpp"

namespace straightedge {

/// Which lines come near one another, without comparing each with each: squares of `cell` pixels, and in each
/// the lines that pass through it.
class LineGrid {
 public:
  /// `reach`: lines that come no nearer to one another than this need not be found.
  LineGrid(const std::vector<WallLine>& lines, double reach);

  /// Indices of all lines that may come within reach of this one, itself included if it was put in;
  /// ascending, each once.
  std::vector<std::size_t> near(const WallLine& line) const;

 private:
  double reach_;
  std::size_t lines_;
  std::unordered_map<std::int64_t, std::vector<std::size_t>> cells_;
};

}  // namespace straightedge
