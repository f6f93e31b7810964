// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "hough/part_kernels.hpp"
#include "straightedge/detail/arc_tangents_of_eighths.hpp"

namespace straightedge {
namespace STRAIGHTEDGE_KERNEL_SET {
namespace {

constexpr float rounding = 12582912.0F;  // 1.5 * 2^23
constexpr std::int32_t some_angles = hough_rows_more;
constexpr std::int32_t some_directions = hough_some_directions;

/// Angles [first, end) of the table.
struct Window {
  std::int32_t first;
  std::int32_t end;
};

inline Window window_of(const HoughRows& rows, std::uint16_t first) noexcept {
  return first == hough_no_direction ? Window{0, rows.angles} : Window{first, first + rows.window};
}

/// Where pixel (x, y) votes at some angles from n on.
inline void find_cells(const HoughRows& rows, std::int32_t n, float x, float y,
                       std::uint32_t* __restrict index) noexcept {
  for (std::int32_t k = 0; k < some_angles; ++k) {
    const float sum = x * rows.cosines[n + k] + y * rows.sines[n + k] + rounding;
    index[k] = __builtin_bit_cast(std::uint32_t, sum) + rows.offsets[n + k];
  }
}

/// The first angle with the most votes.
template <class Cell>
HoughCandidate find_most(const Cell* cells, const HoughRows& rows, Window window, float x, float y) noexcept {
  HoughCandidate most{INT16_MIN, -1};
  for (std::int32_t n = window.first; n < window.end; ++n) {
    const float sum = x * rows.cosines[n] + y * rows.sines[n] + rounding;
    const std::int32_t votes = cells[__builtin_bit_cast(std::uint32_t, sum) + rows.offsets[n]];
    if (votes > most.votes) most = {votes, n};
  }
  if (most.angle >= rows.angles) most.angle -= rows.angles;
  return most;
}

/// Gradients on their way to their directions, by the steps of arc_tangent (trigonometry.hpp). Where that
/// chooses between two sums, here a sign and a number to begin with are chosen: compilers keep branches round
/// sums, which might trap, and with branches there is no vector code.
struct Directions {
  double dx[some_directions];
  double dy[some_directions];
  double ratio[some_directions];
  std::int32_t eighth[some_directions];
  double nearby[some_directions];  ///< the arc tangent of the nearest eighth
  std::int32_t first[some_directions];
};

inline void find_ratios(Directions& d) noexcept {
  for (std::int32_t i = 0; i < some_directions; ++i) {
    const double ax = __builtin_fabs(d.dx[i]);
    const double ay = __builtin_fabs(d.dy[i]);
    const double longer = ay > ax ? ay : ax;
    const double shorter = ay > ax ? ax : ay;
    d.ratio[i] = shorter / (longer + (longer > 0 ? 0.0 : 1.0));
    d.eighth[i] = static_cast<std::int32_t>(d.ratio[i] * 8 + 0.5);
  }
}

/// The direction, and the window's first angle.
inline void find_first(Directions& d, const HoughWindowRule& rule) noexcept {
  constexpr double half_pi = 3.141592653589793 / 2;
  constexpr double to_integer = 6755399441055744.0;  // 1.5 * 2^52
  const double half_window = rule.half_window;
  const double theta_step = rule.theta_step;
  const std::int32_t half_turn = rule.half_turn;
  for (std::int32_t i = 0; i < some_directions; ++i) {
    const bool steep = __builtin_fabs(d.dy[i]) > __builtin_fabs(d.dx[i]);
    const double c = d.eighth[i] / 8.0;
    const double u = (d.ratio[i] - c) / (1 + d.ratio[i] * c);
    const double s = u * u;
    double sum = 1.0 / 13.0;
    sum = 1.0 / 11.0 - s * sum;
    sum = 1.0 / 9.0 - s * sum;
    sum = 1.0 / 7.0 - s * sum;
    sum = 1.0 / 5.0 - s * sum;
    sum = 1.0 / 3.0 - s * sum;
    const double flat_angle = d.nearby[i] + (u - u * s * sum);
    const double right_angle = (steep ? half_pi : 0.0) + (steep ? -1.0 : 1.0) * flat_angle;
    const double down_angle = (d.dx[i] < 0 ? 2 * half_pi : 0.0) + (d.dx[i] < 0 ? -1.0 : 1.0) * right_angle;
    const double angle = (d.dy[i] < 0 ? -1.0 : 1.0) * down_angle;
    const double steps = (angle - half_window) / theta_step;
    auto n = static_cast<std::int32_t>((steps + to_integer) - to_integer);
    // At least -2 half turns, at most one, and a little for rounding.
    n += n < 0 ? half_turn : 0;
    n += n < 0 ? half_turn : 0;
    n += n < 0 ? half_turn : 0;
    n -= n >= half_turn ? half_turn : 0;
    n -= n >= half_turn ? half_turn : 0;
    d.first[i] = n;
  }
}

template <class Cell>
std::int32_t cast(Cell* cells, const HoughRows& rows, const HoughBatch& batch, const std::uint16_t* firsts,
                  std::int32_t from, std::int32_t threshold, HoughCandidate& seen) noexcept {
  std::uint32_t index[some_angles];
  for (std::int32_t i = from; i < batch.count; ++i) {
    const Window window = window_of(rows, firsts[i]);
    std::int32_t missing = 0;  // negative when some cell has enough
    for (std::int32_t n = window.first; n < window.end; n += some_angles) {
      find_cells(rows, n, batch.x[i], batch.y[i], index);
      const std::int32_t count = window.end - n < some_angles ? window.end - n : some_angles;
      for (std::int32_t k = 0; k < count; ++k) {
        const std::int32_t votes = cells[index[k]] + 1;
        cells[index[k]] = static_cast<Cell>(votes);
        missing |= threshold - 1 - votes;
      }
    }
    if (missing >= 0) continue;
    seen = find_most(cells, rows, window, batch.x[i], batch.y[i]);
    return i;
  }
  return batch.count;
}

template <class Cell>
void take_off(Cell* cells, const HoughRows& rows, const HoughBatch& batch,
              const std::uint16_t* firsts) noexcept {
  std::uint32_t index[some_angles];
  for (std::int32_t i = 0; i < batch.count; ++i) {
    const Window window = window_of(rows, firsts[i]);
    for (std::int32_t n = window.first; n < window.end; n += some_angles) {
      find_cells(rows, n, batch.x[i], batch.y[i], index);
      const std::int32_t count = window.end - n < some_angles ? window.end - n : some_angles;
      for (std::int32_t k = 0; k < count; ++k) cells[index[k]] = static_cast<Cell>(cells[index[k]] - 1);
    }
  }
}

}  // namespace

std::int32_t cast_in_windows(std::uint8_t* cells, const HoughRows& rows, const HoughBatch& batch,
                             const std::uint16_t* firsts, std::int32_t from, std::int32_t threshold,
                             HoughCandidate& seen) noexcept {
  return cast(cells, rows, batch, firsts, from, threshold, seen);
}

std::int32_t cast_in_windows(std::int16_t* cells, const HoughRows& rows, const HoughBatch& batch,
                             const std::uint16_t* firsts, std::int32_t from, std::int32_t threshold,
                             HoughCandidate& seen) noexcept {
  return cast(cells, rows, batch, firsts, from, threshold, seen);
}

void take_off_in_windows(std::uint8_t* cells, const HoughRows& rows, const HoughBatch& batch,
                         const std::uint16_t* firsts) noexcept {
  take_off(cells, rows, batch, firsts);
}

void take_off_in_windows(std::int16_t* cells, const HoughRows& rows, const HoughBatch& batch,
                         const std::uint16_t* firsts) noexcept {
  take_off(cells, rows, batch, firsts);
}

void first_angles(const std::int16_t* dx, const std::int16_t* dy, std::int32_t count,
                  const HoughWindowRule& rule, std::uint16_t* first) noexcept {
  Directions d;
  for (std::int32_t start = 0; start < count; start += some_directions) {
    for (std::int32_t i = 0; i < some_directions; ++i) d.dx[i] = dx[start + i];
    for (std::int32_t i = 0; i < some_directions; ++i) d.dy[i] = dy[start + i];
    find_ratios(d);
    for (std::int32_t i = 0; i < some_directions; ++i)
      d.nearby[i] = detail::arc_tangents_of_eighths[d.eighth[i]];
    find_first(d, rule);
    for (std::int32_t i = 0; i < some_directions; ++i) {
      const bool null = (dx[start + i] | dy[start + i]) == 0;
      first[start + i] = static_cast<std::uint16_t>(null ? hough_no_direction : d.first[i]);
    }
  }
}

}  // namespace STRAIGHTEDGE_KERNEL_SET
}  // namespace straightedge
