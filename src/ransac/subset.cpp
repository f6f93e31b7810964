// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "ransac/subset.hpp"

#include "ransac/frame_rows.hpp"
#include "straightedge/random.hpp"

namespace straightedge::ransac {
namespace {

/// Parts are taken in so many turns, neighbours in different ones.
constexpr std::uint32_t turns = 8;
/// Pixels of a square that are tried, unless readings are few.
constexpr std::int32_t tries = 8;

struct Floats3 {
  float x, y, z;
};

Floats3 floats_of(const Vector3& v) noexcept {
  return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}

void put(const detail::RansacPlanesMemory& m, std::uint32_t i, std::uint32_t number,
         const Floats3& at) noexcept {
  m.first[i] = at.x;
  m.second[i] = at.y;
  m.third[i] = at.z;
  m.reading[i] = number;
}

/// Multiplies by what each reading counts.
void weigh(const Subset& subset) noexcept {
  const detail::RansacPlanesMemory& m = subset.memory;
  const float* __restrict w = m.w.data();
  const auto times_w = [w, &subset](const float* __restrict from, float* __restrict to) {
    for (std::uint32_t i = 0; i < subset.count; ++i) to[i] = from[i] * w[i];
  };
  times_w(m.first.data(), m.x.data());
  times_w(m.second.data(), m.y.data());
  times_w(m.third.data(), m.z.data());
}

/// The least side of squares of which the frame has no more than `most`.
std::int32_t square_side(Size size, std::uint32_t most) noexcept {
  std::int32_t side = 1;
  const auto squares = [&] {
    return static_cast<std::uint64_t>((size.width + side - 1) / side) *
           static_cast<std::uint64_t>((size.height + side - 1) / side);
  };
  while (squares() > most) ++side;
  return side;
}

/// Squares of a frame, its pixels being floats or std::uint16_t.
template <class Q>
struct Squares {
  Subset& subset;
  const Labels& labels;
  const ImageView<const Q>& frame;
  std::int32_t side;
  float scale, constant, metres;

  Squares(Subset& to, const Labels& with, std::uint32_t most) noexcept
      : subset(to),
        labels(with),
        frame(frame_of<Q>(to.readings)),
        side(square_side(frame.size(), most)),
        scale(to.readings.scale),
        constant(to.readings.constant()),
        metres(to.readings.metres()) {}

  /// False: no reading, or one with a label.
  bool take(std::int32_t u, std::int32_t v) noexcept {
    const float q = inverse_of(frame.at(u, v), scale);
    const float wide = wide_of(q, constant, metres);
    if (is_above(q, wide) == 0 || !labels.free(static_cast<std::size_t>(u), static_cast<std::size_t>(v)))
      return false;
    const auto number = static_cast<std::uint32_t>(v) * static_cast<std::uint32_t>(frame.width) +
                        static_cast<std::uint32_t>(u);
    put(subset.memory, subset.count++, number, {static_cast<float>(u), static_cast<float>(v), q});
    return true;
  }
  /// When all have been taken.
  void finish() const noexcept {
    const detail::RansacPlanesMemory& m = subset.memory;
    const float* __restrict q = m.third.data();
    float* __restrict w = m.w.data();
    for (std::uint32_t i = 0; i < subset.count; ++i) w[i] = 1 / wide_of(q[i], constant, metres);
    weigh(subset);
    if (m.place_x.empty()) return;
    for (std::uint32_t i = 0; i < subset.count; ++i) {
      m.place_x[i] = m.first[i];
      m.place_y[i] = m.second[i];
      m.place_z[i] = 0;
    }
  }

  struct Drawn {
    std::int32_t u0, v0, u, v;  ///< the square's corner, and a pixel from there
  };

  std::int32_t width_at(std::int32_t u0) const noexcept {
    return frame.width - u0 < side ? frame.width - u0 : side;
  }
  std::int32_t height_at(std::int32_t v0) const noexcept {
    return frame.height - v0 < side ? frame.height - v0 : side;
  }

  Drawn draw(std::int32_t u0, std::int32_t v0, Pcg32& random) const noexcept {
    const std::int32_t width = width_at(u0);
    const auto at =
        static_cast<std::int32_t>(random.below(static_cast<std::uint32_t>(width * height_at(v0))));
    // Pixels drawn lie far apart: all of a turn are on their way before the first is looked at.
    const std::int32_t v = at / width, u = at - v * width;
    __builtin_prefetch(frame.row(v0 + v) + u0 + u);
    return {u0, v0, u, v};
  }

  /// From a pixel drawn on, one by one and round again, the first of `most` that is free.
  void take(const Drawn& drawn, std::int32_t most) noexcept {
    const std::int32_t width = width_at(drawn.u0), height = height_at(drawn.v0);
    std::int32_t u = drawn.u, v = drawn.v;
    for (std::int32_t tried = 0; tried < width * height && tried < most; ++tried) {
      if (take(drawn.u0 + u, drawn.v0 + v)) return;
      if (++u < width) continue;
      u = 0;
      v = v + 1 < height ? v + 1 : 0;
    }
  }

  void draw_all(std::int32_t most, Pcg32& random) noexcept {
    constexpr auto all = static_cast<std::int32_t>(turns);
    constexpr std::size_t ahead = 64;
    Drawn waiting[ahead];
    std::size_t count = 0;
    const auto take_waiting = [&] {
      for (std::size_t i = 0; i < count; ++i) take(waiting[i], most);
      count = 0;
    };
    for (std::int32_t turn = 0; turn < all; ++turn) {
      std::int32_t first = turn;
      for (std::int32_t v = 0; v < frame.height; v += side, first = (first + 3) % all) {
        for (std::int32_t u = first * side; u < frame.width; u += all * side) {
          waiting[count++] = draw(u, v, random);
          if (count == ahead) take_waiting();
        }
      }
    }
    take_waiting();
  }
};

template <class Q>
void draw_from_frame(Subset& subset, const Labels& labels, std::uint32_t most, Pcg32& random) noexcept {
  Squares<Q> squares(subset, labels, most);
  squares.draw_all(tries, random);
  if (subset.count < most / 4) {
    subset.count = 0;
    squares.draw_all(squares.side * squares.side, random);
  }
  squares.finish();
}

/// The runs of readings one after another, whatever lies between these: what is no reading has no influence.
struct Runs {
  std::uint32_t left, parts;
  std::uint32_t part = 0, begin = 0, rest = 0;  ///< begin = floor(left * part / parts), rest what that leaves

  /// A reading of this run; then the next run's turn comes.
  std::uint32_t draw(Pcg32& random) noexcept {
    const std::uint32_t first = begin;
    begin += left / parts;
    rest += left % parts;
    if (rest >= parts) {
      rest -= parts;
      ++begin;
    }
    ++part;
    return first + random.below(begin - first);
  }
  /// Where a run's reading comes among those of all turns.
  std::uint32_t place_of(std::uint32_t run) const noexcept {
    const std::uint32_t turn = run % turns, whole = parts / turns, more = parts % turns;
    return turn * whole + (turn < more ? turn : more) + run / turns;
  }
};

void prefetch(const PointsView& points, std::uint32_t number) noexcept {
  const std::ptrdiff_t at = number * (points.stride / static_cast<std::ptrdiff_t>(sizeof(float)));
  __builtin_prefetch(points.x + at);
  __builtin_prefetch(points.y + at);
  __builtin_prefetch(points.z + at);
}

void put_point(Subset& subset, const Runs& runs, std::uint32_t run, std::uint32_t number,
               const Reading& r) noexcept {
  const detail::RansacPlanesMemory& m = subset.memory;
  const std::uint32_t i = runs.place_of(run);
  put(m, i, number, floats_of({r.x, r.y, r.z}));
  m.w[i] = static_cast<float>(r.w);
  if (m.place_x.empty()) return;
  const Floats3 place = floats_of(r.place);
  m.place_x[i] = place.x;
  m.place_y[i] = place.y;
  m.place_z[i] = place.z;
}

/// Of a cloud in which every point is a reading and none has a label yet. False: one that was drawn is none.
bool draw_from_all(Subset& subset, Runs runs, Pcg32& random) noexcept {
  constexpr std::uint32_t ahead = 32;
  std::uint32_t waiting[ahead];
  Reading r;
  while (runs.part < runs.parts) {
    // Points drawn lie far apart: some are on their way before the first of them is looked at.
    const std::uint32_t first = runs.part;
    std::uint32_t count = 0;
    for (; count < ahead && runs.part < runs.parts; ++count) {
      waiting[count] = runs.draw(random);
      prefetch(subset.readings.points, waiting[count]);
    }
    for (std::uint32_t i = 0; i < count; ++i) {
      if (!subset.readings.read(waiting[i], r)) return false;
      put_point(subset, runs, first + i, waiting[i], r);
    }
  }
  return true;
}

void draw_from_left(Subset& subset, const Labels& labels, Runs runs, Pcg32& random) noexcept {
  Reading r;
  std::uint32_t passed = 0, i = 0;
  while (runs.part < runs.parts) {
    const std::uint32_t run = runs.part, wanted = runs.draw(random);
    while (!labels.free(i, 0) || !subset.readings.read(i, r) || passed++ != wanted) ++i;
    put_point(subset, runs, run, i++, r);
  }
}

bool draw_from_cloud(Subset& subset, const Labels& labels, std::uint32_t left, std::uint32_t most,
                     Pcg32& random) noexcept {
  const Runs runs{left, left < most ? left : most};
  subset.count = runs.parts;
  bool drawn = true;
  if (left == subset.readings.count()) {
    drawn = draw_from_all(subset, runs, random);
  } else {
    draw_from_left(subset, labels, runs, random);
  }
  if (drawn) weigh(subset);
  return drawn;
}

}  // namespace

bool draw_subset(Subset& subset, const Labels& labels, const RansacOptions& options, std::uint32_t left,
                 std::uint64_t stream) noexcept {
  const detail::RansacPlanesMemory& m = subset.memory;
  Pcg32 random(options.seed, stream);
  subset.count = 0;
  bool drawn = true;
  if (subset.readings.is_raw()) {
    draw_from_frame<std::uint16_t>(subset, labels, options.subset, random);
  } else if (subset.readings.is_frame()) {
    draw_from_frame<float>(subset, labels, options.subset, random);
  } else {
    drawn = draw_from_cloud(subset, labels, left, options.subset, random);
  }
  for (std::uint32_t i = subset.count; i < padded(subset.count); ++i) m.x[i] = m.y[i] = m.z[i] = m.w[i] = 0;
  return drawn;
}

std::uint32_t find_near(const Subset& subset, std::uint32_t i, double radius) noexcept {
  const detail::RansacPlanesMemory& m = subset.memory;
  const auto most = static_cast<float>(radius * radius);
  std::uint32_t found = 0;
  for (std::uint32_t j = 0; j < subset.count; ++j) {
    const float dx = m.place_x[j] - m.place_x[i];
    const float dy = m.place_y[j] - m.place_y[i];
    const float dz = m.place_z[j] - m.place_z[i];
    m.near[found] = j;
    found += (dx * dx + dy * dy) + dz * dz <= most && j != i ? 1U : 0U;
  }
  return found;
}

Coefficients coefficients(const LinearPlane& p) noexcept {
  return {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z), static_cast<float>(p.w)};
}

}  // namespace straightedge::ransac
