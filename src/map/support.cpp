// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "map/support.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "map/area.hpp"
#include "map/median.hpp"

namespace straightedge {
namespace {

constexpr double step = 0.5;
constexpr double nearby = 2.0;
constexpr double unlimited = 1e9;
constexpr double end_tolerance = 4;
// A wall pixel has this share of the darkness that walls of the picture usually have, and need not have more
// than `usual_dark` of full black.
constexpr double dark_share = 0.7;
constexpr double usual_dark = 0.57;
// Two neighbours, neither of them dark, are a wall between two pixels when they have this much together.
constexpr double pair_dark = 0.8;
// In a noisy picture thin walls fall to pieces that are no crumbs.
constexpr double noisy_dark_share = 0.45;
constexpr double noisy_min_piece = 4;
// Lines as noise makes them: pixels, and edge pixels a pixel of length. A wall's axis has two edges.
constexpr double chance_length = 40;
constexpr double chance_axis_density = 1.2;
constexpr double chance_face_density = 0.5;

struct Run {
  double begin = 0, end = 0;
  double length() const { return end - begin; }
};

/// How dark each pixel is, 0 to 255.
Image<std::uint8_t> darkness_of(GrayView stretched) {
  Image<std::uint8_t> out(stretched.size());
  for (std::int32_t y = 0; y < stretched.height; ++y) {
    const std::uint8_t* const row = stretched.row(y);
    std::uint8_t* const dark = out.view().row(y);
    for (std::int32_t x = 0; x < stretched.width; ++x) dark[x] = static_cast<std::uint8_t>(255 - row[x]);
  }
  return out;
}

/// The first column from x on that is as dark as `least`, or the width: most pixels of a map are not.
std::int32_t next_dark(const std::uint8_t* darkness, std::int32_t x, std::int32_t width, int least) {
  constexpr std::int32_t many = 32;
  while (x + many <= width) {
    unsigned any = 0;
    for (std::int32_t k = 0; k < many; ++k) any |= darkness[x + k] >= least ? 1U : 0U;
    if (any != 0) break;
    x += many;
  }
  while (x < width && darkness[x] < least) ++x;
  return x;
}

/// A thin wall that runs between two pixels darkens both by half: makes them as dark as `from`.
void join_pairs(ImageView<std::uint8_t> darkness, int from) {
  const int enough = static_cast<int>(255 * pair_dark);
  const int least = (enough + 3) / 4;
  for (std::int32_t y = 0; y < darkness.height; ++y) {
    const std::uint8_t* const row = darkness.row(y);
    for (std::int32_t x = next_dark(row, 0, darkness.width, least); x < darkness.width;
         x = next_dark(row, x + 1, darkness.width, least)) {
      const int here = row[x];
      if (here >= from) continue;
      for (const auto& [nx, ny] : {std::pair{x + 1, y}, std::pair{x, y + 1}}) {
        if (!darkness.contains(nx, ny)) continue;
        const int next = darkness.at(nx, ny);
        if (next < from && here + next >= enough) darkness.at(x, y) = static_cast<std::uint8_t>(from);
      }
    }
  }
}

/// Step 1.
int dark_from(const std::vector<WallLine>& lines, const Picture& picture, GrayView darkness, double share) {
  std::vector<double> cores;
  for (const WallLine& line : lines) {
    for (double s = line.begin + 1; s < line.end; s += 2) {
      double darkest = 0;
      for (double u = line.axis ? -1 : -2.5; u <= (line.axis ? 1 : -1); u += step) {
        const auto x = static_cast<std::int32_t>(line.x_at(s) + u * line.nx + 0.5);
        const auto y = static_cast<std::int32_t>(line.y_at(s) + u * line.ny + 0.5);
        if (darkness.contains(x, y)) darkest = std::max<double>(darkest, darkness.at(x, y));
      }
      cores.push_back(darkest);
    }
  }
  if (cores.empty()) return 1;
  const double dark = picture.wall_below <= 255 ? 1 - picture.wall_below / picture.ground : usual_dark;
  return static_cast<int>(std::min(255 * dark, share * median(cores))) + 1;
}

/// Step 2: 255 on dark areas that are no crumbs.
Image<std::uint8_t> solid_areas(GrayView darkness, int from, double min_piece) {
  constexpr std::uint8_t crumb = 1;
  Image<std::uint8_t> solid(darkness.size());
  const auto is_dark = [&](Pixel p) { return darkness.at(p.x, p.y) >= from; };
  std::vector<Pixel> area;
  for (std::int32_t y = 0; y < darkness.height; ++y) {
    const std::uint8_t* const row = darkness.row(y);
    for (std::int32_t x = next_dark(row, 0, darkness.width, from); x < darkness.width;
         x = next_dark(row, x + 1, darkness.width, from)) {
      if (solid.at(x, y) != 0 || !is_dark({x, y})) continue;
      const Square square = grow_area({x, y}, solid.view(), unlimited, area, is_dark);
      if (square.side() >= min_piece) continue;
      for (const Pixel p : area) solid.at(p.x, p.y) = crumb;
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

/// Step 4: in noise, edge pixels line up by chance, but not many of them and not far.
bool is_chance(const WallLine& line) {
  const double least = line.axis ? chance_axis_density : chance_face_density;
  return line.length() < chance_length && line.pixels < least * line.length();
}

}  // namespace

std::vector<WallLine> keep_supported(const std::vector<WallLine>& lines, const Picture& picture,
                                     const SupportOptions& options) {
  std::vector<WallLine> out;
  Image<std::uint8_t> darkness = darkness_of(picture.stretched);
  const int from = dark_from(lines, picture, darkness, picture.noisy ? noisy_dark_share : dark_share);
  join_pairs(darkness.view(), from);
  const Image<std::uint8_t> solid =
      solid_areas(darkness, from, picture.noisy ? noisy_min_piece : options.min_piece);
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
      if (picture.noisy && is_chance(part)) continue;
      out.push_back(part);
    }
  }
  return out;
}

}  // namespace straightedge
