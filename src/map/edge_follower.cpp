// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "map/edge_follower.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <optional>
#include <span>

#include "map/edge_walk.hpp"
#include "map/straight_part.hpp"
#include "straightedge/square_root.hpp"

namespace straightedge {
namespace {

using walking::fixed;

constexpr double long_edge = 20;  // pixels
constexpr double half =
    1.6;  // of the corridor's width; a line known by few of a staircase's pixels needs so much
constexpr std::int64_t tangent_inside = 119, tangent_beside = 215;  // of 25 and 40 degrees, times 256
constexpr double cos_inside = 0.906307787036650;                    // 25 degrees
// Steps to each side before the first fit. Later ones go on for a share of the pixels that the line is known
// by: where it has just moved over by a pixel, it is not known better.
constexpr std::int32_t first_steps = 5, trust = 3;
constexpr std::int64_t few_on_one_side = 3;  // of the first pixels: most seeds beside edges go no further
constexpr std::int32_t most_in_step = 12;    // pixels beside a line that is not too steep
constexpr double min_density = 0.6;          // edge pixels a pixel of length: a diagonal has 0.7
constexpr double max_residual = 0.4;         // pixels
constexpr double max_slope = 1.7;  // from step to step; steeper ones have turned too far from the seed

/// The pixels of a word of row y where x + 2 y (mirrored: x - 2 y) is a multiple of five: no row, column or
/// diagonal has more than four others between two of them. An edge that climbs by two in one, or by one in
/// two, may miss one lattice altogether, but not its mirror image.
std::uint64_t on_lattice(std::int32_t y, std::int32_t word, bool mirrored) {
  constexpr std::uint64_t every_fifth = 0x1084210842108421;
  const std::int32_t first = ((mirrored ? 2 : 3) * y + word) % 5;  // -2 = 3 and -64 = 1
  return every_fifth << first;
}

}  // namespace

void EdgeFollower::start(std::int32_t x, std::int32_t y) {
  const PixelGradient gradient = sources_.directions.at(x, y);
  const double dx = gradient.dx, dy = gradient.dy;
  const double size = square_root(dx * dx + dy * dy);
  steep_ = std::fabs(dx) > std::fabs(dy);
  strip_ = {.px = static_cast<double>(x),
            .py = static_cast<double>(y),
            .nx = dx / size,
            .ny = dy / size,
            .half_width = half,
            .cos_max_angle = cos_inside};
  sums_ = {};
  seed_ = {steep_ ? y : x, steep_ ? x : y, true};
  for (Way& way : ways_) {
    way.direction = &way == &ways_[0] ? 1 : -1;
    way.step = way.direction > 0 ? seed_.step : seed_.step - 1;
    way.hole = 0;
    way.going = true;
    way.last = seed_;
    way.visited = way.up_to_last = 0;
  }
}

/// Step 2.
template <bool steep, class Gradients>
void EdgeFollower::walk(Way& way, std::int32_t steps, const Gradients& gradients) {
  const Pixel seed = seed_;
  const auto room = way.visited + static_cast<std::size_t>(steps * most_in_step);
  if (way.pixels.size() < room) way.pixels.resize(2 * room);
  const walking::Course course = walking::course_of(strip_, steep, way.step, way.direction);
  const std::int32_t left = way.direction > 0 ? edges_->steps(steep) - way.step : way.step + 1;
  const std::int32_t in_picture = course.steps_in(edges_->places(steep), std::min(steps, left));
  const std::int64_t nx = fixed(strip_.nx), ny = fixed(strip_.ny), gap = fixed(options_.max_gap);
  walking::EdgesAlong<steep, Gradients> along(edges_->lines(steep), gradients, in_picture > 0 ? way.step : 0,
                                              way.direction);
  Pixel* pixel = way.pixels.data() + way.visited;
  const Pixel* up_to_last = way.pixels.data() + way.up_to_last;
  std::int64_t from = course.from, hole = way.hole;
  std::int64_t count = 0, sum = 0, sum_across = 0, sum_squares = 0, sum_products = 0;
  std::int32_t step = way.step;
  for (std::int32_t k = 0; k < in_picture && hole <= gap; ++k) {
    hole += course.step_length;
    const auto first = static_cast<std::int32_t>(from >> walking::fraction_bits);
    if (steep && k + gradient_rows_ahead < left) along.fetch(gradient_rows_ahead, std::max(first, 0));
    for (std::uint64_t bits = along.edges(first, course.width); bits != 0; bits &= bits - 1) {
      const std::int32_t across = first + std::countr_zero(bits);
      const PixelGradient gradient = along.gradient(across);
      const std::int64_t dx = gradient.dx, dy = gradient.dy;
      const std::int64_t toward = dx * nx + dy * ny, aside = dx * ny - dy * nx;
      const std::int64_t turned = (aside < 0 ? -aside : aside) * 256;
      if (turned >= toward * tangent_beside) continue;
      const auto off = static_cast<std::uint64_t>(across * walking::one - from - course.inside);
      const bool inside = turned < toward * tangent_inside && off <= course.inside_width;
      *pixel++ = {step, across, inside};
      if (!inside) continue;
      const std::int64_t s = step - seed.step, a = across - seed.across;
      ++count;
      sum += s;
      sum_across += a;
      sum_squares += s * s;
      sum_products += s * a;
      hole = 0;
      up_to_last = pixel;
    }
    step += way.direction;
    from += course.next;
    along.go_on();
  }
  sums_.count += count;
  sums_.step += sum;
  sums_.across += sum_across;
  sums_.step_step += sum_squares;
  sums_.step_across += sum_products;
  way.going = in_picture == steps && hole <= gap;
  way.step = step;
  way.hole = hole;
  way.visited = static_cast<std::size_t>(pixel - way.pixels.data());
  way.up_to_last = static_cast<std::size_t>(up_to_last - way.pixels.data());
  if (way.up_to_last > 0) way.last = way.pixels[way.up_to_last - 1];
}

void EdgeFollower::go_on(Way& way, std::int32_t steps) {
  const GradientSource& source = sources_.directions;
  if (source.is_stored()) {
    const StoredGradients stored(source.stored);
    steep_ ? walk<true>(way, steps, stored) : walk<false>(way, steps, stored);
  } else {
    const MadeGradients made(source.blurred);
    steep_ ? walk<true>(way, steps, made) : walk<false>(way, steps, made);
  }
}

/// Step 3.
bool EdgeFollower::lay_line() {
  const auto n = static_cast<double>(sums_.count);
  const auto step = static_cast<double>(sums_.step), across = static_cast<double>(sums_.across);
  const double spread = n * static_cast<double>(sums_.step_step) - step * step;
  if (!(spread > 0)) return false;
  const double slope = (n * static_cast<double>(sums_.step_across) - step * across) / spread;
  if (std::fabs(slope) > max_slope) return false;
  const double size = 1 / square_root(1 + slope * slope);
  const double nx = steep_ ? size : -slope * size, ny = steep_ ? -slope * size : size;
  const double side = nx * strip_.nx + ny * strip_.ny < 0 ? -1 : 1;
  strip_.nx = side * nx;
  strip_.ny = side * ny;
  const double middle = step / n + seed_.step, middle_across = across / n + seed_.across;
  strip_.px = steep_ ? middle_across : middle;
  strip_.py = steep_ ? middle : middle_across;
  return true;
}

bool EdgeFollower::is_edge(double min_length) const {
  const double steps = ways_[0].last.step - ways_[1].last.step;
  const double across = ways_[0].last.across - ways_[1].last.across;
  const double length = square_root(steps * steps + across * across);
  return length >= min_length && static_cast<double>(sums_.count) >= min_density * length;
}

/// Finds where some of the pixels inside lie between the pixels, in their order along the edge.
StripRule EdgeFollower::read_places() {
  EdgeBatch& batch = *places_;
  const auto count = static_cast<std::size_t>(sums_.count);
  const std::size_t every = (count + options_.places - 1) / options_.places;
  std::size_t left_out = every / 2;
  const auto read = [&](const Pixel& pixel) {
    if (!pixel.inside || ++left_out < every) return;
    left_out = 0;
    read_edge(sources_, column(pixel), row(pixel), batch);
  };
  batch.count = 0;
  for (std::size_t i = ways_[1].up_to_last; i > 0; --i) read(ways_[1].pixels[i - 1]);
  for (std::size_t i = 0; i < ways_[0].up_to_last; ++i) read(ways_[0].pixels[i]);
  if (!sources_.have_magnitude()) kernels_->edge_magnitudes(batch, options_.norm == GradientNorm::l2);
  kernels_->edge_places(batch);
  StripBatch& places = *strip_places_;
  places.count = batch.count;
  for (std::int32_t i = 0; i < batch.count; ++i) {
    places.x[i] = batch.place_x[i];
    places.y[i] = batch.place_y[i];
    places.weight[i] = batch.weight[i];
    places.dx[i] = batch.dx[i];
    places.dy[i] = batch.dy[i];
  }
  const StripRule strip{strip_.px, strip_.py, strip_.nx, strip_.ny, half, cos_inside};
  kernels_->find_inside(strip, places);
  return strip;
}

/// Step 4.
bool EdgeFollower::fit(WallLine& line) {
  const StripRule strip = read_places();
  const std::optional<StraightPart> part = find_straight_part(*strip_places_, strip);
  if (!part || part->fit.residual > max_residual) return false;
  const auto pixel_of = [&](std::int32_t i) {
    const std::int32_t x = places_->x[i], y = places_->y[i];
    return Pixel{steep_ ? y : x, steep_ ? x : y, true};
  };
  first_ = part->first == 0 ? ways_[1].last : pixel_of(part->first);
  last_ = part->end == places_->count ? ways_[0].last : pixel_of(part->end);
  line = WallLine{};
  line.origin_x = strip_.px;
  line.origin_y = strip_.py;
  line.moments = part->moments;
  line.fit = part->fit;
  const double side = line.fit.normal_x * strip_.nx + line.fit.normal_y * strip_.ny < 0 ? -1 : 1;
  line.nx = side * line.fit.normal_x;
  line.ny = side * line.fit.normal_y;
  line.fit.centroid_x += strip_.px;
  line.fit.centroid_y += strip_.py;
  const double a = line.along(column(first_), row(first_)), b = line.along(column(last_), row(last_));
  line.begin = std::min(a, b);
  line.end = std::max(a, b);
  return true;
}

/// Step 5. How many of the pixels inside there were.
std::uint32_t EdgeFollower::take_pixels() {
  const BitLinesView of_steps = edges_->lines(steep_), of_places = edges_->lines(!steep_);
  const std::int32_t first = first_.step, last = last_.step;
  std::uint32_t taken = 0;
  for (const Way& way : ways_) {
    for (const Pixel& pixel : std::span(way.pixels).first(way.up_to_last)) {
      if (pixel.step < first || pixel.step > last) continue;
      of_steps.clear(pixel.step, pixel.across);
      of_places.clear(pixel.across, pixel.step);
      taken += pixel.inside ? 1U : 0U;
    }
  }
  return taken;
}

bool EdgeFollower::follow(std::int32_t x, std::int32_t y, double min_length, WallLine& line) {
  if (const PixelGradient gradient = sources_.directions.at(x, y); gradient.dx == 0 && gradient.dy == 0)
    return false;
  start(x, y);
  std::int32_t steps = first_steps;
  const double few = 2 * min_density * first_steps;
  while (ways_[0].going || ways_[1].going) {
    for (Way& way : ways_) {
      if (way.going) go_on(way, steps);
      if (sums_.count < few_on_one_side) return false;
    }
    if (static_cast<double>(sums_.count) < few || !lay_line()) return false;
    steps = std::max(2 * first_steps, static_cast<std::int32_t>(sums_.count / trust));
  }
  if (!is_edge(min_length) || !fit(line) || line.length() < min_length) return false;
  line.pixels = line.votes = take_pixels();
  return true;
}

std::vector<WallLine> EdgeFollower::run(EdgeBits& edges, const EdgeSources& sources,
                                        const FollowOptions& options, const PictureRowKernels& kernels) {
  edges_ = &edges;
  sources_ = sources;
  options_ = options;
  kernels_ = &kernels;
  std::vector<WallLine> lines;
  WallLine line;
  const std::int32_t words = (edges.size().width + 63) / 64;
  for (const double least : {std::max(long_edge, options.min_length), options.min_length}) {  // Step 1
    const bool second = least == options.min_length;
    for (std::int32_t y = 0; y < edges.size().height; ++y) {
      for (std::int32_t word = 0; word < words; ++word) {
        std::uint64_t seeds = edges.word(word, y);
        if (seeds == 0) continue;
        for (seeds &= on_lattice(y, word, second); seeds != 0; seeds &= seeds - 1) {
          const std::int32_t x = word * 64 + std::countr_zero(seeds);
          if (edges.contains(x, y) && follow(x, y, least, line)) lines.push_back(line);
        }
      }
    }
  }
  return lines;
}

}  // namespace straightedge
