// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "localize/fit_points.hpp"
#include "straightedge/host/scan_lines.hpp"

namespace straightedge::localize {

/// Pieces of a scan on their way to lines: lists of point indices, one behind the other.
class Pieces {
 public:
  void clear() {
    members_.clear();
    ends_.clear();
  }
  std::size_t size() const { return ends_.size(); }
  std::span<const std::uint32_t> operator[](std::size_t i) const {
    const std::size_t begin = i == 0 ? 0 : ends_[i - 1];
    return {members_.data() + begin, ends_[i] - begin};
  }
  void add(std::uint32_t member) { members_.push_back(member); }
  void close() { ends_.push_back(members_.size()); }
  /// Drops what was added since the last `close`.
  void forget() { members_.resize(ends_.empty() ? 0 : ends_.back()); }
  std::span<const std::uint32_t> open() const {
    const std::size_t begin = ends_.empty() ? 0 : ends_.back();
    return {members_.data() + begin, members_.size() - begin};
  }

 private:
  std::vector<std::uint32_t> members_;
  std::vector<std::size_t> ends_;
};

/// What all methods of finding lines are given.
struct PointRow {
  std::span<const ScanPoint> points;
  double angle_step_rad = 0;
  Laser laser;
  const ScanLineOptions& options;
};

/// A stretch of the row of points: [begin, end).
struct Stretch {
  std::uint32_t begin = 0, end = 0;
  std::uint32_t run = 0;  ///< which run of step 2 it is of
};

/// Scratch that is kept from scan to scan.
struct StretchMemory {
  std::vector<Stretch> todo, done;
  std::vector<std::uint32_t> numbers;  ///< 0, 1, 2, ...
};

/// Steps 2 to 4 of scan_lines.hpp.
void split_and_merge(const PointRow& row, StretchMemory& memory, Pieces& pieces, ScanLineCounts& counts);

/// Lines by random pairs of points; instead of steps 2 to 4:
///  a. Draw a point that no line has, and a second at most `reach` points from it in the row.
///  b. Their line's piece: points within split_distance_m, cut at gaps, the part round the pair.
///  c. The piece with most points wins, after as many draws as 99 % confidence asks for a piece of that size;
///     it is refitted to its points and read out once more. Its points leave. Until fewer than min_points
///     are found.
/// Draw i of the scan is from stream i.
void ransac_pieces(const PointRow& row, Pieces& pieces);

/// Lines by the Hough transform; instead of steps 2 to 4: the points are painted into a picture with pixels
/// of half of split_distance_m (larger, where the scan would take more than 1500 of them), progressive Hough
/// lines are found in it, and each takes the points near it that no longer one has, cut at gaps.
void hough_pieces(const PointRow& row, Pieces& pieces);

/// Adds the members of the line `fit` between the two numbers of `row` that are free and within the distance;
/// each stretch without a gap is a piece. `owned`: not 0 for points that have a line.
void take_along(const PointRow& row, const LineFit& fit, double begin, double end, std::vector<char>& owned,
                Pieces& pieces);

}  // namespace straightedge::localize
