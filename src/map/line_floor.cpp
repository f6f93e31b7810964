// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "map/line_floor.hpp"

#include <algorithm>
#include <cmath>

namespace straightedge {
namespace {

constexpr double rounded_offset = 0.29;
constexpr double two_grounds_offset = 0.2;
constexpr double usual_offset = 0.05;
constexpr double noisy_offset = 0.082;
constexpr double usual_angle_length = 0.068;
constexpr double noisy_angle_length = 0.18;

/// Fewer steps from row to row (or column to column) than average the rounding out.
bool lies_on_grid(const WallLine& line) {
  return std::min(std::fabs(line.nx), std::fabs(line.ny)) * line.length() < 3;
}

}  // namespace

LineFloor line_floor(const PictureFacts& picture, const WallLine& line) {
  LineFloor floor;
  floor.angle_length = picture.noisy ? noisy_angle_length : usual_angle_length;
  floor.offset = picture.noisy ? noisy_offset : usual_offset;
  if (picture.crisp && lies_on_grid(line)) floor.offset = rounded_offset;
  if (!picture.crisp && line.axis) floor.offset = two_grounds_offset;
  return floor;
}

}  // namespace straightedge
