// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "cli/explain_pictures.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "cli/explain_colours.hpp"
#include "cli/explain_paint.hpp"

namespace straightedge::cli {
namespace {

constexpr std::int32_t wheel_side = 160;

double length_of(std::int32_t magnitude, GradientNorm norm) {
  return norm == GradientNorm::l2 ? std::sqrt(magnitude) : magnitude;
}

Rgb gray_level(double share) {
  const unsigned char value = level(share);
  return {value, value, value};
}

double turns_of(double x, double y) {
  return std::atan2(y, x) / (2 * pi);
}

}  // namespace

PictureScale scale_of(const ExplainRun& run, GradientNorm norm) {
  PictureScale scale;
  const Size size = run.edges.size();
  scale.zoom = zoom_of(size);
  const ImageView<const std::int32_t> view = run.canny.magnitude();
  std::vector<std::int32_t> magnitudes(view.data, view.data + std::ptrdiff_t{size.width} * size.height);
  const auto place = magnitudes.begin() + static_cast<std::ptrdiff_t>((magnitudes.size() - 1) * 99 / 100);
  std::nth_element(magnitudes.begin(), place, magnitudes.end());
  // Thresholds may be beyond every gradient; then the largest one is white.
  const std::int32_t largest = *std::max_element(place, magnitudes.end());
  const std::int32_t full = std::max({*place, std::min(run.limits.high, largest), 1});
  scale.full_length = length_of(full, norm);
  return scale;
}

Image<Rgb> enlarged(ImageView<const Rgb> image, int zoom) {
  return paint(image.size(), zoom, [&](std::int32_t x, std::int32_t y) { return image.at(x, y); });
}

Image<Rgb> show_gray(GrayView gray, const PictureScale& scale) {
  return paint(gray.size(), scale.zoom, [&](std::int32_t x, std::int32_t y) {
    const std::uint8_t value = gray.at(x, y);
    return Rgb{value, value, value};
  });
}

Image<Rgb> show_signed(ImageView<const std::int16_t> gradient, const PictureScale& scale) {
  return paint(gradient.size(), scale.zoom, [&](std::int32_t x, std::int32_t y) {
    return gray_level(0.5 + 0.5 * gradient.at(x, y) / scale.full_length);
  });
}

Image<Rgb> show_magnitude(const ExplainRun& run, GradientNorm norm, const PictureScale& scale) {
  const auto magnitude = run.canny.magnitude();
  return paint(magnitude.size(), scale.zoom, [&](std::int32_t x, std::int32_t y) {
    return gray_level(length_of(magnitude.at(x, y), norm) / scale.full_length);
  });
}

Image<Rgb> show_direction(const ExplainRun& run, GradientNorm norm, const PictureScale& scale) {
  const auto dx = run.canny.gradient_x(), dy = run.canny.gradient_y();
  const auto magnitude = run.canny.magnitude();
  return paint(magnitude.size(), scale.zoom, [&](std::int32_t x, std::int32_t y) {
    const double brightness = std::min(length_of(magnitude.at(x, y), norm) / scale.full_length, 1.0);
    return hue(turns_of(dx.at(x, y), dy.at(x, y)), brightness);
  });
}

Image<Rgb> direction_wheel() {
  constexpr double middle = wheel_side / 2.0, outer = middle - 4, inner = outer * 0.45;
  return paint({wheel_side, wheel_side}, 1, [](std::int32_t x, std::int32_t y) {
    const double u = x + 0.5 - middle, v = y + 0.5 - middle;
    const double radius = std::hypot(u, v);
    const double cover = std::clamp(std::min(outer - radius, radius - inner) + 0.5, 0.0, 1.0);
    return mix(paper, hue(turns_of(u, v), 1), cover);
  });
}

Image<Rgb> show_crests(const ExplainRun& run, GradientNorm norm, const PictureScale& scale) {
  const auto magnitude = run.canny.magnitude();
  return paint(magnitude.size(), scale.zoom, [&](std::int32_t x, std::int32_t y) {
    if (run.crests.at(x, y) == no_edge) return Rgb{};
    return gray_level(length_of(magnitude.at(x, y), norm) / scale.full_length);
  });
}

Image<Rgb> show_classes(const ExplainRun& run, const PictureScale& scale) {
  const GrayView classes = run.canny.suppressed();
  return paint(classes.size(), scale.zoom, [&](std::int32_t x, std::int32_t y) {
    if (classes.at(x, y) == no_edge) return Rgb{};
    return classes.at(x, y) == strong_edge ? strong_colour : weak_colour;
  });
}

}  // namespace straightedge::cli
