// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "map/support.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "map/area.hpp"

namespace straightedge {
namespace {

constexpr double pace = 1;       // along a segment
constexpr double core_pace = 8;  // the same, where the usual darkness is all that is asked
constexpr double step = 0.5;     // across it
constexpr double nearby = 2.0;
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

/// Of the darknesses counted, the upper one of the two in the middle when their number is even.
double middle_of(const std::array<std::uint32_t, 256>& counts) {
  std::uint32_t total = 0, below = 0;
  for (const std::uint32_t count : counts) total += count;
  for (std::size_t v = 0; v < counts.size(); ++v) {
    below += counts[v];
    if (below > total / 2) return static_cast<double>(v);
  }
  return -1;
}

/// The pixels along a line, u to the side of it, at s and every `apart` from there on.
class PixelReader {
 public:
  PixelReader(GrayView gray, const PictureRowKernels& kernels) : gray_(gray), kernels_(kernels) {}

  const std::vector<std::uint8_t>& read(const WallLine& line, double s, double apart, double u) {
    const SampleWay way{.pixels = gray_.data,
                        .stride = gray_.stride,
                        .width = gray_.width,
                        .height = gray_.height,
                        .x = line.x_at(s) + 0.5,
                        .y = line.y_at(s) + 0.5,
                        .step_x = apart * line.tx(),
                        .step_y = apart * line.ty(),
                        .aside_x = u * line.nx,
                        .aside_y = u * line.ny};
    const double steps = (line.end - s) / apart;
    pixels_.resize(steps > 0 ? static_cast<std::size_t>(std::ceil(steps)) : 0);
    kernels_.read_nearest(way, static_cast<std::int32_t>(pixels_.size()), pixels_.data());
    return pixels_;
  }

 private:
  GrayView gray_;
  const PictureRowKernels& kernels_;
  std::vector<std::uint8_t> pixels_;
};

/// Step 1.
int dark_from(const std::vector<WallLine>& lines, const Picture& picture, double share, PixelReader& pixels) {
  std::array<std::uint32_t, 256> cores{};
  std::vector<std::uint8_t> lightest;
  for (const WallLine& line : lines) {
    lightest.clear();
    for (double u = line.axis ? -1 : -2.5; u <= (line.axis ? 1 : -1); u += step) {
      const std::vector<std::uint8_t>& aside = pixels.read(line, line.begin + 1, core_pace, u);
      lightest.resize(aside.size(), 255);
      for (std::size_t i = 0; i < aside.size(); ++i) lightest[i] = std::min(lightest[i], aside[i]);
    }
    for (const std::uint8_t gray : lightest) ++cores[std::size_t{255} - gray];
  }
  const double usual = middle_of(cores);
  if (usual < 0) return 1;
  const double dark = picture.wall_below <= 255 ? 1 - picture.wall_below / picture.ground : usual_dark;
  return static_cast<int>(std::min(255 * dark, share * usual)) + 1;
}

/// Step 2, for those pixels alone that somebody asks for.
class SolidAreas {
 public:
  SolidAreas(GrayView stretched, int from, double min_piece, Image<std::uint8_t>& marks)
      : gray_(stretched), from_(from), min_piece_(min_piece), known_(marks_of(marks, stretched.size())) {}
  SolidAreas(const SolidAreas&) = delete;
  SolidAreas& operator=(const SolidAreas&) = delete;
  ~SolidAreas() {
    for (const Pixel p : marked_) known_.at(p.x, p.y) = unknown;
  }

  /// Whether the pixel lies in the picture, on a dark area that is no crumb.
  bool contain(std::int32_t x, std::int32_t y) {
    if (!gray_.contains(x, y)) return false;
    // Mostly somebody asks for one pixel after the other.
    if (x == last_.x && y == last_.y) return true;
    const bool is_solid = is_beside_last(x, y) ? is_dark(x, y) : is_known_solid(x, y);
    if (is_solid) last_ = {x, y};
    return is_solid;
  }

 private:
  static constexpr std::uint8_t unknown = 0, growing = 1, crumb = 2, solid = 3;

  bool is_beside_last(std::int32_t x, std::int32_t y) const {
    return x >= last_.x - 1 && x <= last_.x + 1 && y >= last_.y - 1 && y <= last_.y + 1;
  }

  bool is_known_solid(std::int32_t x, std::int32_t y) {
    const std::uint8_t& known = known_.at(x, y);
    if (known == unknown && is_dark(x, y)) grow({x, y});
    return known == solid;
  }

  int darkness(std::int32_t x, std::int32_t y) const { return 255 - gray_.at(x, y); }

  /// A thin wall that runs between two pixels darkens both by half; it is one pixel, then.
  bool is_dark(std::int32_t x, std::int32_t y) const {
    constexpr int enough = static_cast<int>(255 * pair_dark);
    const int here = darkness(x, y);
    if (here >= from_) return true;
    const auto makes_pair = [&](int next) { return next < from_ && here + next >= enough; };
    return (x + 1 < gray_.width && makes_pair(darkness(x + 1, y))) ||
           (y + 1 < gray_.height && makes_pair(darkness(x, y + 1)));
  }

  /// How many dark pixels hang together from here on, in one direction; as many as are asked for will do.
  double dark_run(Pixel at, std::int32_t dx, std::int32_t dy, double enough) const {
    double run = 0;
    while (run < enough && gray_.contains(at.x, at.y) && darkness(at.x, at.y) >= from_) {
      ++run;
      at = {at.x + dx, at.y + dy};
    }
    return run;
  }

  /// A shortcut: most walls are as long as that in some direction.
  bool is_long(Pixel seed) const {
    constexpr std::array<Pixel, 4> directions{{{1, 0}, {0, 1}, {1, 1}, {1, -1}}};
    return std::any_of(directions.begin(), directions.end(), [&](Pixel d) {
      const double run = dark_run(seed, d.x, d.y, min_piece_);
      return run > 0 && run + dark_run(seed, -d.x, -d.y, min_piece_) - 1 >= min_piece_;
    });
  }

  /// Flood fill with a list in place of recursion, until the area is too large for a crumb.
  void grow(Pixel seed) {
    if (is_long(seed)) {
      known_.at(seed.x, seed.y) = solid;
      marked_.push_back(seed);
      return;
    }
    Square square{seed.x, seed.x, seed.y, seed.y};
    bool large = min_piece_ <= 1;
    area_.assign(1, seed);
    known_.at(seed.x, seed.y) = growing;
    for (std::size_t next = 0; next < area_.size() && !large; ++next) {
      const Pixel at = area_[next];
      square = {std::min(square.left, at.x), std::max(square.right, at.x), std::min(square.top, at.y),
                std::max(square.bottom, at.y)};
      large = square.side() >= min_piece_ || !take_neighbours(at);
    }
    for (const Pixel p : area_) known_.at(p.x, p.y) = large ? solid : crumb;
    marked_.insert(marked_.end(), area_.begin(), area_.end());
  }

  /// False when one of them is known to lie on a large area.
  bool take_neighbours(Pixel at) {
    for (std::int32_t k = 0; k < 9; ++k) {
      const Pixel to{at.x + k % 3 - 1, at.y + k / 3 - 1};
      if (!gray_.contains(to.x, to.y)) continue;
      std::uint8_t& known = known_.at(to.x, to.y);
      if (known == solid) return false;
      if (known != unknown || !is_dark(to.x, to.y)) continue;
      known = growing;
      area_.push_back(to);
    }
    return true;
  }

  GrayView gray_;
  int from_;
  double min_piece_;
  ImageView<std::uint8_t> known_;
  std::vector<Pixel> area_;
  std::vector<Pixel> marked_;
  Pixel last_{-2, -2};  ///< that was solid
};

bool is_wall(SolidAreas& solid, const WallLine& line, double s, double u) {
  const double x = line.x_at(s) + 0.5 + u * line.nx, y = line.y_at(s) + 0.5 + u * line.ny;
  return solid.contain(static_cast<std::int32_t>(std::floor(x)), static_cast<std::int32_t>(std::floor(y)));
}

/// Outwards from the middle.
bool wall_near(SolidAreas& solid, const WallLine& line, double s, double middle) {
  const double back = line.axis ? -nearby : -nearby - 0.5;
  for (double u = middle; u >= back; u -= step)
    if (is_wall(solid, line, s, u)) return true;
  for (double u = middle + step; u <= nearby; u += step)
    if (is_wall(solid, line, s, u)) return true;
  return false;
}

/// Step 3. Where the pixel in the middle is dark and the one before it was wall, it is wall, too: it is the
/// same or touches it.
std::vector<Run> runs_of(SolidAreas& solid, int from, const WallLine& line, PixelReader& pixels) {
  std::vector<Run> runs;
  const double middle = line.axis ? 0 : -1, first = line.begin + 0.5 * pace;
  const std::vector<std::uint8_t>& grays = pixels.read(line, first, pace, middle);
  bool was_wall = false, was_core = false;
  std::size_t last = 0;  // that was wall
  const auto place = [&](std::size_t i) { return first + pace * static_cast<double>(i); };
  const auto end_run = [&] {
    if (was_wall) runs.back().end = place(last) + 0.5 * pace;
  };
  for (std::size_t i = 0; i < grays.size(); ++i) {
    const bool dark = 255 - grays[i] >= from;
    if (dark && was_core) {
      last = i;
      continue;
    }
    const double s = place(i);
    const bool core = dark && is_wall(solid, line, s, middle);
    const bool wall = core || wall_near(solid, line, s, middle);
    if (!wall) {
      end_run();
    } else {
      last = i;
      if (!was_wall) runs.push_back({s - 0.5 * pace, s + 0.5 * pace});
    }
    was_core = core;
    was_wall = wall;
  }
  end_run();
  return runs;
}

/// Step 4: in noise, edge pixels line up by chance, but not many of them and not far.
bool is_chance(const WallLine& line) {
  const double least = line.axis ? chance_axis_density : chance_face_density;
  return line.length() < chance_length && line.pixels < least * line.length();
}

}  // namespace

std::vector<WallLine> keep_supported(const std::vector<WallLine>& lines, const Picture& picture,
                                     const SupportOptions& options, Image<std::uint8_t>& marks,
                                     const PictureRowKernels& kernels) {
  std::vector<WallLine> out;
  PixelReader pixels(picture.stretched, kernels);
  const int from = dark_from(lines, picture, picture.noisy ? noisy_dark_share : dark_share, pixels);
  SolidAreas solid(picture.stretched, from, picture.noisy ? noisy_min_piece : options.min_piece, marks);
  for (const WallLine& line : lines) {
    const std::vector<Run> runs = runs_of(solid, from, line, pixels);
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
