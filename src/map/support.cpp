// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "map/support.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "map/sample.hpp"

namespace straightedge {
namespace {

constexpr double step = 0.5;
constexpr double nearby = 2.0;
constexpr double end_tolerance = 4;
// ROS's usual threshold, where the map has none of its own.
constexpr double usual_wall_below = 89.25;

struct Run {
  double begin = 0, end = 0;
  double length() const { return end - begin; }
};

double darkest_across(GrayView gray, const WallLine& line, double s) {
  double darkest = 255;
  for (double u = line.axis ? -1 : -2.5; u <= (line.axis ? 1 : -1); u += step) {
    darkest = std::min(darkest, sample(gray, line.x_at(s) + u * line.nx, line.y_at(s) + u * line.ny));
  }
  return darkest;
}

/// Step 1.
double dark_below(const std::vector<WallLine>& lines, const Picture& picture) {
  const double given = picture.wall_below <= 255 ? picture.wall_below : usual_wall_below;
  std::vector<double> cores;
  for (const WallLine& line : lines) {
    for (double s = line.begin + 1; s < line.end; s += 2)
      cores.push_back(darkest_across(picture.gray, line, s));
  }
  if (cores.empty()) return given;
  const auto middle = cores.begin() + static_cast<std::ptrdiff_t>(cores.size() / 2);
  std::nth_element(cores.begin(), middle, cores.end());
  return std::max(given, *middle + 0.3 * (picture.ground - *middle));
}

/// Step 2: 255 on dark areas that are no crumbs.
Image<std::uint8_t> solid_areas(GrayView gray, double below, double min_piece) {
  Image<std::uint8_t> solid(gray.size());
  const ImageView<std::uint8_t> mark = solid.view();
  struct Pixel {
    std::int32_t x, y;
  };
  std::vector<Pixel> area;
  for (std::int32_t y = 0; y < gray.height; ++y) {
    for (std::int32_t x = 0; x < gray.width; ++x) {
      if (mark.at(x, y) != 0 || gray.at(x, y) >= below) continue;
      area.assign(1, {x, y});
      mark.at(x, y) = 255;
      std::int32_t left = x, right = x, top = y, bottom = y;
      for (std::size_t next = 0; next < area.size(); ++next) {
        const Pixel at = area[next];
        left = std::min(left, at.x);
        right = std::max(right, at.x);
        top = std::min(top, at.y);
        bottom = std::max(bottom, at.y);
        for (std::int32_t k = 0; k < 9; ++k) {
          const Pixel to{at.x + k % 3 - 1, at.y + k / 3 - 1};
          if (!gray.contains(to.x, to.y) || mark.at(to.x, to.y) != 0 || gray.at(to.x, to.y) >= below)
            continue;
          mark.at(to.x, to.y) = 255;
          area.push_back(to);
        }
      }
      if (std::max(right - left, bottom - top) + 1 >= min_piece) continue;
      for (const Pixel p : area) mark.at(p.x, p.y) = 1;  // seen, but a crumb
    }
  }
  return solid;
}

bool wall_near(GrayView solid, const WallLine& line, double s) {
  const double from = line.axis ? -nearby : -nearby - 0.5;
  for (double u = from; u <= nearby; u += step) {
    const auto x = static_cast<std::int32_t>(line.x_at(s) + u * line.nx + 0.5);
    const auto y = static_cast<std::int32_t>(line.y_at(s) + u * line.ny + 0.5);
    if (solid.contains(x, y) && solid.at(x, y) == 255) return true;
  }
  return false;
}

/// Step 3.
std::vector<Run> runs_of(GrayView solid, const WallLine& line) {
  std::vector<Run> runs;
  for (double s = line.begin + 0.5 * step; s < line.end; s += step) {
    if (!wall_near(solid, line, s)) continue;
    if (!runs.empty() && s - 0.5 * step - runs.back().end < 0.25 * step) {
      runs.back().end = s + 0.5 * step;
    } else {
      runs.push_back({s - 0.5 * step, s + 0.5 * step});
    }
  }
  return runs;
}

}  // namespace

std::vector<WallLine> keep_supported(const std::vector<WallLine>& lines, const Picture& picture,
                                     const SupportOptions& options) {
  std::vector<WallLine> out;
  const Image<std::uint8_t> solid = solid_areas(picture.gray, dark_below(lines, picture), options.min_piece);
  for (const WallLine& line : lines) {
    const std::vector<Run> runs = runs_of(solid, line);
    for (std::size_t i = 0; i < runs.size();) {
      double covered = runs[i].length();
      std::size_t last = i;
      while (last + 1 < runs.size() && runs[last + 1].begin - runs[last].end <= options.max_gap) {
        covered += runs[++last].length();
      }
      WallLine part = line;
      if (runs[i].begin - line.begin > end_tolerance) part.begin = runs[i].begin;
      if (line.end - runs[last].end > end_tolerance) part.end = runs[last].end;
      i = last + 1;
      if (covered < options.min_share * part.length()) continue;
      part.pixels = static_cast<std::uint32_t>(line.pixels * part.length() / line.length() + 0.5);
      out.push_back(part);
    }
  }
  return out;
}

}  // namespace straightedge
