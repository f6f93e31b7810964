// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "straightedge/host/label_picture.hpp"

#include <algorithm>
#include <array>

namespace straightedge {
namespace {

/// Dim, so that it is never taken for a label's colour.
constexpr int nearest_gray = 120, farthest_gray = 44;

/// Raw depth of the nearest and the farthest reading.
struct DepthRange {
  std::uint16_t nearest = 0, farthest = 0;

  /// 0 at the nearest reading, 256 at the farthest; by inverse depth, which spends the shades where a
  /// sensor sees detail.
  int share(std::uint16_t depth) const noexcept {
    if (farthest == nearest) return 0;
    const double near_inverse = 1.0 / nearest;
    return static_cast<int>(256 * (near_inverse - 1.0 / depth) / (near_inverse - 1.0 / farthest));
  }
};

DepthRange range_of(ImageView<const std::uint16_t> depth) {
  DepthRange range;
  for (std::int32_t y = 0; y < depth.height; ++y) {
    for (std::int32_t x = 0; x < depth.width; ++x) {
      const std::uint16_t value = depth.at(x, y);
      if (value == 0) continue;
      if (range.nearest == 0 || value < range.nearest) range.nearest = value;
      range.farthest = std::max(range.farthest, value);
    }
  }
  return range;
}

unsigned char gray_of(int share) {
  return static_cast<unsigned char>(nearest_gray - (nearest_gray - farthest_gray) * share / 256);
}

/// Down to three quarters of the colour.
Rgb shaded(Rgb colour, int share) {
  const auto one = [share](unsigned char value) {
    return static_cast<unsigned char>(value * (1024 - share) / 1024);
  };
  return {one(colour.red), one(colour.green), one(colour.blue)};
}

}  // namespace

Rgb plane_colour(std::uint32_t id) noexcept {
  if (id == 0) return {128, 128, 128};
  // Steps of the golden section come back near no earlier hue for long; three strengths in turn
  // tell apart those that do.
  constexpr std::uint32_t golden_section = 2654435769u;  // of 2^32
  struct Strength {
    int low, high;
  };
  constexpr std::array<Strength, 3> strengths{{{70, 225}, {105, 205}, {45, 185}}};
  const std::uint32_t hue = id * golden_section;
  const auto sector = static_cast<std::uint32_t>((std::uint64_t{hue} * 6) >> 32);
  const auto within = static_cast<int>(((std::uint64_t{hue} * 6) >> 24) & 255);
  const Strength s = strengths[id % 3];
  const auto value = [&](int share) {
    return static_cast<unsigned char>(s.low + (s.high - s.low) * share / 255);
  };
  const unsigned char top = value(255), rising = value(within), falling = value(255 - within),
                      base = value(0);
  switch (sector) {
    case 0:
      return {top, rising, base};
    case 1:
      return {falling, top, base};
    case 2:
      return {base, top, rising};
    case 3:
      return {base, falling, top};
    case 4:
      return {rising, base, top};
    default:
      return {top, base, falling};
  }
}

Image<Rgb> label_picture(ImageView<const std::uint16_t> labels, ImageView<const std::uint16_t> depth) {
  if (!labels.valid()) return {};
  const bool with_depth = depth.valid() && depth.size() == labels.size();
  const DepthRange range = with_depth ? range_of(depth) : DepthRange{};
  Image<Rgb> picture(labels.size());
  for (std::int32_t y = 0; y < labels.height; ++y) {
    for (std::int32_t x = 0; x < labels.width; ++x) {
      const std::uint16_t label = labels.at(x, y);
      const std::uint16_t reading = with_depth ? depth.at(x, y) : std::uint16_t{0};
      const int share = reading != 0 ? range.share(reading) : 0;
      const unsigned char gray = reading != 0 ? gray_of(share) : static_cast<unsigned char>(0);
      picture.at(x, y) = label != 0 ? shaded(plane_colour(label), share) : Rgb{gray, gray, gray};
    }
  }
  return picture;
}

}  // namespace straightedge
