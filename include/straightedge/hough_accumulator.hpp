// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "straightedge/arena.hpp"
#include "straightedge/hough_accumulator_directions.hpp"
#include "straightedge/plane.hpp"
#include "straightedge/status.hpp"

namespace straightedge {

struct HoughAccumulatorOptions {
  HoughCells cells = HoughCells::ball;
  std::int32_t rows = 45;        ///< of direction cells from pole to pole, [4, 1024]; 45: 4 degrees
  std::int32_t distances = 128;  ///< cells between distance 0 and the greatest, [1, 65536]
};

/// The accumulator of planes n·x = d with |n| = 1, d >= 0: direction cells (all normals n, the whole
/// sphere) times distance cells (cell k holds k * step <= d < (k + 1) * step; the last also what is beyond).
///
/// A plane near the origin may come out as (n, d) or, the normal turned round, as (−n, d'): cell 0 of a
/// direction and cell 0 of its antipode are neighbours. `votes_beside` knows.
///
/// Memory: 4 bytes a cell, 25 for each direction, 40 for each row: 1.3 MB by default.
class HoughAccumulator {
 public:
  /// Direction cells times distance cells; 0 when an option is out of range or there are more than 2^28.
  static constexpr std::size_t cell_count(const HoughAccumulatorOptions& options) noexcept {
    if (options.distances < 1 || options.distances > 65536) return 0;
    // In 64 bits, which a microcontroller's size_t does not have.
    const auto cells =
        std::int64_t{HoughDirections::cell_count(options.cells, options.rows)} * options.distances;
    return cells > (1 << 28) ? 0 : static_cast<std::size_t>(cells);
  }
  constexpr void take(Arena& arena, const HoughAccumulatorOptions& options) noexcept {
    directions_.take(arena, options.cells, options.rows);
    votes_ = arena.take<std::uint32_t>(cell_count(options));
    used_ =
        arena.take<bool>(static_cast<std::size_t>(HoughDirections::cell_count(options.cells, options.rows)));
    distances_ = options.distances;
  }
  /// After `take` on a real arena. No votes, step 1.
  void fill(HoughCells kind) noexcept;
  /// No votes; the distance cells get this step, metres. Only what was used is cleared.
  void clear(double step_m) noexcept;

  const HoughDirections& directions() const noexcept { return directions_; }
  std::int32_t distances() const noexcept { return distances_; }
  double step_m() const noexcept { return step_m_; }
  /// One direction after another, each with all its distances.
  std::span<const std::uint32_t> votes() const noexcept { return votes_; }

  std::int32_t distance_cell(double d) const noexcept {
    const double k = d * per_step_;
    return k < distances_ ? static_cast<std::int32_t>(k) : distances_ - 1;
  }
  double distance_of(std::int32_t k) const noexcept { return (k + 0.5) * step_m_; }
  Plane plane(std::int32_t direction, std::int32_t k) const noexcept {
    return {directions_.centre(direction), distance_of(k)};
  }

  std::uint32_t& votes(std::int32_t direction, std::int32_t k) noexcept {
    used_[static_cast<std::size_t>(direction)] = true;
    return votes_[index(direction, k)];
  }
  /// False: none of the direction's cells has a vote.
  bool used(std::int32_t direction) const noexcept { return used_[static_cast<std::size_t>(direction)]; }
  std::uint32_t votes(std::int32_t direction, std::int32_t k) const noexcept {
    return votes_[index(direction, k)];
  }
  /// Votes of the cell beside: k = −1 is the antipode's cell 0, k = distances() nobody's.
  std::uint32_t votes_beside(std::int32_t direction, std::int32_t k) const noexcept {
    if (k < 0) return votes(directions_.antipode(direction), -1 - k);
    return k < distances_ ? votes(direction, k) : 0;
  }

  /// A vote for the plane with this centre of a direction cell as its normal and this distance, which may
  /// be negative, shared by the two distance cells whose middles it lies between.
  void vote(std::int32_t direction, double d, std::uint32_t weight) noexcept {
    if (d < 0) {
      direction = directions_.antipode(direction);
      d = -d;
    }
    const double place = d * per_step_ - 0.5;
    if (place < 0) {
      const auto own = static_cast<std::uint32_t>((1 + place) * weight);
      votes(direction, 0) += own;
      votes(directions_.antipode(direction), 0) += weight - own;
    } else if (place < distances_ - 1) {
      const auto k = static_cast<std::int32_t>(place);
      const auto above = static_cast<std::uint32_t>((place - k) * weight);
      votes(direction, k) += weight - above;
      votes(direction, k + 1) += above;
    } else {
      votes(direction, distances_ - 1) += weight;
    }
  }

 private:
  std::size_t index(std::int32_t direction, std::int32_t k) const noexcept {
    return static_cast<std::size_t>(direction) * static_cast<std::size_t>(distances_) +
           static_cast<std::size_t>(k);
  }

  HoughDirections directions_;
  std::span<std::uint32_t> votes_;
  std::span<bool> used_;  ///< directions that got a vote
  std::int32_t distances_ = 0;
  double step_m_ = 1, per_step_ = 1;
};

}  // namespace straightedge
