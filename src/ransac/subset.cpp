// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "ransac/subset.hpp"

#include "straightedge/random.hpp"

namespace straightedge::ransac {
namespace {

void append(Subset& subset, std::uint32_t number, const Reading& r) noexcept {
  const detail::RansacPlanesMemory& m = subset.memory;
  const std::uint32_t i = subset.count++;
  m.x[i] = static_cast<float>(r.x * r.w);
  m.y[i] = static_cast<float>(r.y * r.w);
  m.z[i] = static_cast<float>(r.z * r.w);
  m.w[i] = static_cast<float>(r.w);
  m.place_x[i] = static_cast<float>(r.place.x);
  m.place_y[i] = static_cast<float>(r.place.y);
  m.place_z[i] = static_cast<float>(r.place.z);
  m.reading[i] = number;
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

/// From a pixel drawn by chance on, row by row and round again, the first reading that is free.
void draw_pixel(Subset& subset, std::span<const std::uint16_t> labels, std::int32_t u0, std::int32_t v0,
                std::int32_t side, Pcg32& random) noexcept {
  const ImageView<const float>& frame = subset.readings.frame;
  const std::int32_t width = frame.width - u0 < side ? frame.width - u0 : side;
  const std::int32_t height = frame.height - v0 < side ? frame.height - v0 : side;
  const std::int32_t pixels = width * height;
  auto at = static_cast<std::int32_t>(random.below(static_cast<std::uint32_t>(pixels)));
  for (std::int32_t tried = 0; tried < pixels; ++tried, at = at + 1 < pixels ? at + 1 : 0) {
    const std::int32_t u = u0 + at % width;
    const std::int32_t v = v0 + at / width;
    const auto number = static_cast<std::uint32_t>(v) * static_cast<std::uint32_t>(frame.width) +
                        static_cast<std::uint32_t>(u);
    Reading r;
    if (labels[number] != 0 || !subset.readings.read_pixel(u, v, r)) continue;
    append(subset, number, r);
    return;
  }
}

void draw_from_frame(Subset& subset, std::span<const std::uint16_t> labels, std::uint32_t most,
                     Pcg32& random) noexcept {
  const ImageView<const float>& frame = subset.readings.frame;
  const std::int32_t side = square_side(frame.size(), most);
  for (std::int32_t v = 0; v < frame.height; v += side)
    for (std::int32_t u = 0; u < frame.width; u += side) draw_pixel(subset, labels, u, v, side, random);
}

/// Runs of readings, whatever lies between them: what is no reading has no influence.
void draw_from_cloud(Subset& subset, std::span<const std::uint16_t> labels, std::uint32_t most,
                     Pcg32& random) noexcept {
  const std::uint32_t count = subset.readings.count();
  Reading r;
  std::uint32_t left = 0;
  for (std::uint32_t i = 0; i < count; ++i) left += labels[i] == 0 && subset.readings.read(i, r) ? 1U : 0U;
  const std::uint32_t parts = left < most ? left : most;
  if (parts == 0) return;
  const auto begin_of = [&](std::uint32_t part) {
    return static_cast<std::uint32_t>(std::uint64_t{left} * part / parts);
  };
  std::uint32_t part = 0;
  std::uint32_t wanted = random.below(begin_of(1));
  std::uint32_t passed = 0;
  for (std::uint32_t i = 0; i < count && part < parts; ++i) {
    if (labels[i] != 0 || !subset.readings.read(i, r) || passed++ != wanted) continue;
    append(subset, i, r);
    if (++part < parts) wanted = begin_of(part) + random.below(begin_of(part + 1) - begin_of(part));
  }
}

}  // namespace

void draw_subset(Subset& subset, std::span<const std::uint16_t> labels, std::uint32_t most,
                 std::uint64_t seed, std::uint64_t stream) noexcept {
  const detail::RansacPlanesMemory& m = subset.memory;
  Pcg32 random(seed, stream);
  subset.count = 0;
  if (subset.readings.is_frame()) {
    draw_from_frame(subset, labels, most, random);
  } else {
    draw_from_cloud(subset, labels, most, random);
  }
  for (std::uint32_t i = subset.count; i < padded(subset.count); ++i) m.x[i] = m.y[i] = m.z[i] = m.w[i] = 0;
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
