// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "map/extent.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <utility>

#include "map/line_sampler.hpp"
#include "map/median.hpp"

namespace straightedge {
namespace {

constexpr double pace = 2;          // pixels along the line; where it ends, half of that
constexpr double step = 0.5;        // across it
constexpr double search = 12;       // how far beyond its edge pixels an end is looked for
constexpr double face_depth = 2.0;  // where a face's two sides are sampled
constexpr double axis_clearance = 2.5;
constexpr double most_of = 0.8;    // of a line that its piece of wall has to cover
constexpr double beyond_bend = 2;  // pixels that a piece of a bent wall may be longer than its edge
constexpr double short_block = 3;  // a face goes on behind a block no longer than this

enum class State : unsigned char { wall, hole, blocked };

struct Track {
  std::vector<double> places;       // along the line
  std::vector<double> dark, light;  // gray of the wall's side and of the floor's
  double half = 0, scale = 0;       // between the two, and 1 / their difference
  std::vector<State> state;
  double at(std::size_t i) const { return places[i]; }
};

/// Places along the line, `way` from one to the next.
std::vector<double> places_on(const WallLine& line, double way) {
  std::vector<double> places;
  for (double s = line.begin; s <= line.end; s += way) places.push_back(s);
  return places;
}

/// Step 1.
void read_sides(const WallLine& line, const LineSampler& blurred, std::span<const double> places,
                std::span<double> dark, std::span<double> light) {
  if (!line.axis) {
    blurred.along(line, places, -face_depth, dark.data());
    blurred.along(line, places, face_depth, light.data());
    return;
  }
  const double aside = 0.5 * line.width + axis_clearance;
  blurred.along(line, places, aside, dark.data());
  blurred.along(line, places, -aside, light.data());
  for (std::size_t i = 0; i < places.size(); ++i) light[i] = std::max(light[i], dark[i]);
  blurred.along(line, places, 0, dark.data());
}

void sample_track(const WallLine& line, const LineSampler& blurred, Track& track) {
  const auto count = static_cast<std::int32_t>((line.length() + 2 * search) / pace) + 1;
  track.places.resize(static_cast<std::size_t>(count));
  double* const places = track.places.data();
  for (std::int32_t i = 0; i < count; ++i) places[i] = line.begin - search + pace * i;
  track.dark.resize(track.places.size());
  track.light.resize(track.places.size());
  read_sides(line, blurred, track.places, track.dark, track.light);
}

/// That of at most so many values, evenly spaced.
double median_of_some(std::span<const double> values) {
  constexpr std::size_t most = 32;
  const std::size_t every = (values.size() + most - 1) / most;
  std::array<double, most> some;
  std::size_t count = 0;
  for (std::size_t i = every / 2; i < values.size(); i += every) some[count++] = values[i];
  return median(std::span(some).first(count));
}

/// Step 2. Beside the line itself both sides are what they usually are.
void judge(Track& track) {
  const auto from = static_cast<std::size_t>(search / pace), count = track.dark.size() - 2 * from;
  const double dark = median_of_some(std::span(track.dark).subspan(from, count));
  const double light = median_of_some(std::span(track.light).subspan(from, count));
  track.half = 0.5 * (dark + light);
  track.scale = light > dark ? 1 / (light - dark) : 0;
  track.state.resize(track.dark.size());
  for (std::size_t i = 0; i < track.dark.size(); ++i) {
    const bool is_dark = (track.half - track.dark[i]) * track.scale > 0;
    const bool is_light = (track.light[i] - track.half) * track.scale > 0;
    track.state[i] = !is_dark ? State::hole : is_light ? State::wall : State::blocked;
  }
}

/// > 0 where there is wall.
double presence(const WallLine& line, const Track& track, double dark, double light) {
  const double is_dark = (track.half - dark) * track.scale;
  return line.axis ? is_dark : std::min(is_dark, (light - track.half) * track.scale);
}

struct Piece {
  std::size_t first, last;  // samples, both inside
};

/// Step 3.
std::vector<Piece> pieces_of(const WallLine& line, const Track& track, const ExtentOptions& options) {
  const double through = line.axis ? options.max_wall_width + 4 : short_block;
  std::vector<Piece> pieces;
  std::size_t holes = 0, blocks = 0;
  for (std::size_t i = 0; i < track.state.size(); ++i) {
    if (track.state[i] == State::hole) {
      ++holes;
    } else if (track.state[i] == State::blocked) {
      ++blocks;
    } else {
      const bool near = holes + blocks == 0 || (pace * static_cast<double>(holes) <= options.max_gap &&
                                                pace * static_cast<double>(blocks) <= through);
      if (!pieces.empty() && near) {
        pieces.back().last = i;
      } else {
        pieces.push_back({i, i});
      }
      holes = blocks = 0;
    }
  }
  if (!line.axis) return pieces;
  // An axis ends where its core turns light: through the wall that it meets, if that is thin.
  for (Piece& piece : pieces) {
    const auto most = static_cast<std::size_t>(through / pace);
    std::size_t i = piece.last;
    while (i + 1 < track.state.size() && track.state[i + 1] == State::blocked && i - piece.last <= most) ++i;
    if (i - piece.last <= most) piece.last = i;
    i = piece.first;
    while (i > 0 && track.state[i - 1] == State::blocked && piece.first - i <= most) --i;
    if (piece.first - i <= most) piece.first = i;
  }
  return pieces;
}

/// Step 4: where presence crosses zero between a sample inside and its neighbour outside. A sample between
/// them tells in which half.
double crossing(const WallLine& line, const LineSampler& blurred, const Track& track, std::size_t inside,
                std::ptrdiff_t direction) {
  const auto next = static_cast<std::size_t>(static_cast<std::ptrdiff_t>(inside) + direction);
  if (next >= track.dark.size()) return track.at(inside);
  const double half_way = 0.5 * pace * static_cast<double>(direction);
  const double middle = track.at(inside) + half_way;
  double dark = 0, light = 0;
  read_sides(line, blurred, {&middle, 1}, {&dark, 1}, {&light, 1});
  const double near = presence(line, track, track.dark[inside], track.light[inside]);
  const double between = presence(line, track, dark, light);
  const double far = presence(line, track, track.dark[next], track.light[next]);
  const double here = between > 0 ? between : near, there = between > 0 ? far : between;
  const double share = here > 0 && there < 0 ? here / (here - there) : 0;
  return (between > 0 ? middle : track.at(inside)) + half_way * share;
}

/// Cuts off what lies outside the picture, whose square reaches half a pixel beyond the outer pixels'
/// centres.
void clip(Size picture, WallLine& line) {
  const auto cut = [&](double start, double slope, double most) {
    if (slope == 0) return;
    const double s0 = (-0.5 - start) / slope;
    const double s1 = (most - 0.5 - start) / slope;
    line.begin = std::max(line.begin, std::min(s0, s1));
    line.end = std::min(line.end, std::max(s0, s1));
  };
  cut(line.fit.centroid_x, line.tx(), picture.width);
  cut(line.fit.centroid_y, line.ty(), picture.height);
}

double darkest_across(const LineSampler& gray, const WallLine& line, double s) {
  const double from = line.axis ? -2.5 : -face_depth - 0.5;
  const double to = line.axis ? 2.5 : -1;
  std::array<double, 11> sides, grays;
  std::size_t count = 0;
  for (double u = from; u <= to; u += step) sides[count++] = u;
  gray.across(line, s, std::span(sides).first(count), grays.data());
  return std::min(255.0,
                  *std::min_element(grays.begin(), grays.begin() + static_cast<std::ptrdiff_t>(count)));
}

/// Occupancy across an axis, in pixels of full black: blur and antialiasing spread it but keep the sum.
double black_across(const LineSampler& gray, const WallLine& line, double s) {
  const double aside = 0.5 * line.width + axis_clearance;
  std::vector<double> sides{aside, -aside};
  for (double u = -aside + 0.5 * step; u < aside; u += step) sides.push_back(u);
  std::vector<double> grays(sides.size());
  gray.across(line, s, sides, grays.data());
  double sum = 0;
  for (std::size_t i = 2; i < sides.size(); ++i) sum += (sides[i] > 0 ? grays[0] : grays[1]) - grays[i];
  return sum * step / 255;
}

/// By the map's threshold: some pixel across is dark enough; in a soft picture, or a thin wall's darkness
/// together is, for blur has spread it.
bool is_wall(const Picture& picture, const LineSampler& gray, const WallLine& line) {
  if (picture.wall_below > 255) return true;
  std::vector<double> cores, blacks;
  for (const double s : places_on(line, place_step(line.length()))) {
    cores.push_back(darkest_across(gray, line, s));
    if (line.axis) blacks.push_back(black_across(gray, line, s));
  }
  if (median(cores) < picture.wall_below) return true;
  return picture.soft && median(blacks) > 1 - picture.wall_below / 255;
}

void find_free_sides(const Picture& picture, const LineSampler& gray, WallLine& line) {
  const double aside = line.axis ? 0.5 * line.width + axis_clearance : face_depth + 1;
  line.free_plus = true;
  line.free_minus = line.axis;
  if (picture.free_above < 0) return;  // every gray is
  const std::vector<double> places = places_on(line, place_step(line.length()));
  const auto is_free = [&](double u) {
    std::vector<double> grays(places.size());
    gray.along(line, places, u, grays.data());
    return median(grays) > picture.free_above;
  };
  line.free_plus = is_free(aside);
  line.free_minus = line.axis && is_free(-aside);
}

}  // namespace

std::vector<WallLine> measure_extents(const std::vector<WallLine>& lines, const Picture& picture,
                                      GrayView blurred, const ExtentOptions& options,
                                      const PictureRowKernels& kernels) {
  const LineSampler soft(blurred, kernels), gray(picture.gray, kernels);
  std::vector<WallLine> out;
  Track track;
  for (const WallLine& line : lines) {
    sample_track(line, soft, track);
    judge(track);
    for (const Piece& piece : pieces_of(line, track, options)) {
      WallLine part = line;
      part.begin = crossing(line, soft, track, piece.first, -1);
      part.end = crossing(line, soft, track, piece.last, 1);
      clip(blurred.size(), part);
      const double common = std::min(part.end, line.end) - std::max(part.begin, line.begin);
      if (!(part.length() > 0)) continue;
      if (common < 0.5 * part.length()) {
        // The wall goes on along another line, unless this is but the end of it.
        if (common < most_of * line.length()) continue;
        part.begin = std::max(part.begin, line.begin - beyond_bend);
        part.end = std::min(part.end, line.end + beyond_bend);
      }
      part.pixels = static_cast<std::uint32_t>(line.pixels * std::min(1.0, common / line.length()) + 0.5);
      if (!is_wall(picture, gray, part)) continue;
      find_free_sides(picture, gray, part);
      out.push_back(part);
    }
  }
  return out;
}

}  // namespace straightedge
