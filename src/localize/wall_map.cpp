// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "localize/wall_map.hpp"

#include <algorithm>
#include <cmath>

#include "straightedge/trigonometry.hpp"

namespace straightedge::localize {
namespace {

constexpr double smallest_cell_m = 1;
constexpr double most_cells = 1e6;
constexpr double open_end_m = 0.1;
constexpr double no_covariance_offset = 0.5;  // of a pixel, for lines that carry none
constexpr double no_covariance_floor_m = 0.02;

Wall wall_of(const MapLine& line, const MapSegment& segment, std::uint32_t index) {
  Wall wall;
  const SineCosine normal = sine_cosine(line.theta);
  wall.theta = line.theta;
  wall.nx = normal.cosine;
  wall.ny = normal.sine;
  wall.x = line.covariance ? line.covariance->at_x : 0.5 * (segment.x0 + segment.x1);
  wall.y = line.covariance ? line.covariance->at_y : 0.5 * (segment.y0 + segment.y1);
  // The covariance's point may lie a rounding beside the line.
  const double off = wall.x * wall.nx + wall.y * wall.ny - line.rho;
  wall.x -= off * wall.nx;
  wall.y -= off * wall.ny;
  const double s0 = wall.along(segment.x0, segment.y0), s1 = wall.along(segment.x1, segment.y1);
  wall.begin = std::min(s0, s1);
  wall.end = std::max(s0, s1);
  wall.free = line.free;
  wall.line = index;
  wall.line_id = line.id;
  wall.segment_id = segment.id;
  return wall;
}

void set_variances(Wall& wall, const MapLine& line, double pixel_m, const MatchOptions& options) {
  const double offset = std::max(no_covariance_floor_m, no_covariance_offset * pixel_m);
  const double angle = offset / std::max(offset, wall.length());
  wall.var_theta = line.covariance ? line.covariance->var_theta : angle * angle;
  wall.var_offset = line.covariance ? line.covariance->var_offset : offset * offset;
  wall.var_theta += options.wall_angle_floor_rad * options.wall_angle_floor_rad;
  wall.var_offset += options.wall_offset_floor_m * options.wall_offset_floor_m;
}

double squared_distance(const Wall& wall, double x, double y) {
  const double s = wall.along(x, y);
  const double past = s < wall.begin ? wall.begin - s : s > wall.end ? s - wall.end : 0;
  const double d = wall.across(x, y);
  return d * d + past * past;
}

}  // namespace

WallMap::WallMap(const LineMap& map, const MatchOptions& options)
    : lines_(static_cast<std::uint32_t>(map.lines.size())) {
  const double pixel_m = map.image && map.image->placement ? map.image->placement->resolution : 0;
  roughness_m_ = options.wall_roughness_pixels * pixel_m;
  for (std::uint32_t i = 0; i < lines_; ++i) {
    for (const MapSegment& segment : map.lines[i].segments) {
      Wall wall = wall_of(map.lines[i], segment, i);
      set_variances(wall, map.lines[i], pixel_m, options);
      walls_.push_back(wall);
    }
  }
  build_grid();
}

void WallMap::build_grid() {
  double right = -1e300, top = -1e300;
  left_ = bottom_ = 1e300;
  for (const Wall& wall : walls_) {
    for (const double s : {wall.begin, wall.end}) {
      left_ = std::min(left_, wall.x - s * wall.ny);
      right = std::max(right, wall.x - s * wall.ny);
      bottom_ = std::min(bottom_, wall.y + s * wall.nx);
      top = std::max(top, wall.y + s * wall.nx);
    }
  }
  left_ -= reach_m;
  bottom_ -= reach_m;
  const double width = right + reach_m - left_, height = top + reach_m - bottom_;
  cell_ = std::max(smallest_cell_m, std::sqrt(width * height / most_cells));
  columns_ = static_cast<int>(width / cell_) + 1;
  rows_ = static_cast<int>(height / cell_) + 1;
  std::vector<std::vector<std::uint32_t>> cells(static_cast<std::size_t>(columns_) *
                                                static_cast<std::size_t>(rows_));
  rasterise(cells);
  starts_.assign(1, 0);
  for (const auto& here : cells) {
    items_.insert(items_.end(), here.begin(), here.end());
    starts_.push_back(static_cast<std::uint32_t>(items_.size()));
  }
}

void WallMap::rasterise(std::vector<std::vector<std::uint32_t>>& cells) const {
  const double near = reach_m + 0.71 * cell_;
  for (std::uint32_t i = 0; i < walls_.size(); ++i) {
    const Wall& wall = walls_[i];
    const double x0 = wall.x - wall.begin * wall.ny, x1 = wall.x - wall.end * wall.ny;
    const double y0 = wall.y + wall.begin * wall.nx, y1 = wall.y + wall.end * wall.nx;
    const auto column = [&](double x) {
      return std::clamp(static_cast<int>((x - left_) / cell_), 0, columns_ - 1);
    };
    const auto row = [&](double y) {
      return std::clamp(static_cast<int>((y - bottom_) / cell_), 0, rows_ - 1);
    };
    const int c0 = column(std::min(x0, x1) - reach_m), c1 = column(std::max(x0, x1) + reach_m);
    const int r0 = row(std::min(y0, y1) - reach_m), r1 = row(std::max(y0, y1) + reach_m);
    for (int r = r0; r <= r1; ++r) {
      for (int c = c0; c <= c1; ++c) {
        const double x = left_ + (c + 0.5) * cell_, y = bottom_ + (r + 0.5) * cell_;
        if (squared_distance(wall, x, y) > near * near) continue;
        cells[static_cast<std::size_t>(r) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(c)]
            .push_back(i);
      }
    }
  }
}

double WallMap::distance(double x, double y, double limit) const {
  const double u = (x - left_) / cell_, v = (y - bottom_) / cell_;
  if (!(u >= 0 && v >= 0 && u < columns_ && v < rows_)) return limit;
  const std::size_t cell =
      static_cast<std::size_t>(v) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(u);
  double best = limit * limit;
  for (std::uint32_t i = starts_[cell]; i < starts_[cell + 1]; ++i)
    best = std::min(best, squared_distance(walls_[items_[i]], x, y));
  return std::sqrt(best);
}

std::optional<Crossing> WallMap::first_crossing(double x, double y, double dx, double dy,
                                                double limit) const {
  // The part of the ray that is inside the grid.
  double from = 0, to = limit;
  const auto clip = [&](double at, double way, double low, double high) {
    if (std::fabs(way) < 1e-12) {
      if (at < low || at > high) to = -1;
      return;
    }
    const double a = (low - at) / way, b = (high - at) / way;
    from = std::max(from, std::min(a, b));
    to = std::min(to, std::max(a, b));
  };
  clip(x, dx, left_, left_ + columns_ * cell_);
  clip(y, dy, bottom_, bottom_ + rows_ * cell_);
  if (!(from <= to)) return std::nullopt;
  // Cell by cell (J. Amanatides, A. Woo, Eurographics 1987, doi:10.2312/egtp.19871000).
  int c = std::clamp(static_cast<int>((x + from * dx - left_) / cell_), 0, columns_ - 1);
  int r = std::clamp(static_cast<int>((y + from * dy - bottom_) / cell_), 0, rows_ - 1);
  const auto exit = [&](double at, double way, int index, double low) {
    if (std::fabs(way) < 1e-12) return 1e300;
    return (low + (index + (way > 0 ? 1 : 0)) * cell_ - at) / way;
  };
  std::optional<Crossing> found;
  double best = to;
  while (c >= 0 && r >= 0 && c < columns_ && r < rows_) {
    const std::size_t cell =
        static_cast<std::size_t>(r) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(c);
    for (std::uint32_t i = starts_[cell]; i < starts_[cell + 1]; ++i) {
      const Wall& wall = walls_[items_[i]];
      const double way = wall.nx * dx + wall.ny * dy;
      if (std::fabs(way) < 1e-9) continue;
      const double s = -wall.across(x, y) / way;
      if (!(s > 0 && s < best)) continue;
      const double at = wall.along(x + s * dx, y + s * dy);
      if (at < wall.begin + open_end_m || at > wall.end - open_end_m) continue;
      best = s;
      found = Crossing{s, std::fabs(way)};
    }
    const double out_x = exit(x, dx, c, left_), out_y = exit(y, dy, r, bottom_);
    if (std::min(out_x, out_y) >= best) break;
    if (out_x < out_y) {
      c += dx > 0 ? 1 : -1;
    } else {
      r += dy > 0 ? 1 : -1;
    }
  }
  return found;
}

}  // namespace straightedge::localize
