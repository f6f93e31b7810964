// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "cli/explain_legend.hpp"

#include <algorithm>
#include <cmath>

#include "cli/explain_colours.hpp"
#include "cli/explain_text.hpp"
#include "io/number_text.hpp"

namespace straightedge::cli {
namespace {

constexpr std::int32_t least_width = 420, margin = 16, bar_top = 10, bar_height = 14, strip = 50;

}  // namespace

std::vector<Tick> ticks_between(double low, double high, int wanted) {
  std::vector<Tick> ticks;
  if (!(high > low)) return ticks;
  const double rough = (high - low) / wanted;
  const double power = std::pow(10.0, std::floor(std::log10(rough)));
  const double factor = rough <= power ? 1 : rough <= 2 * power ? 2 : rough <= 5 * power ? 5 : 10;
  const double step = factor * power;
  const int decimals = std::max(0, static_cast<int>(-std::floor(std::log10(step) + 1e-9)));
  const auto last = static_cast<std::int64_t>(std::floor(high / step + 1e-9));
  for (auto k = static_cast<std::int64_t>(std::ceil(low / step - 1e-9)); k <= last; ++k) {
    const double value = static_cast<double>(k) * step;
    ticks.push_back({(value - low) / (high - low), io::to_text(value, decimals)});
  }
  return ticks;
}

Image<Rgb> with_legend(const Image<Rgb>& picture, const Legend& legend) {
  const std::int32_t width = std::max(picture.width(), least_width);
  Image<Rgb> out(Size{width, picture.height() + strip}, paper);
  for (std::int32_t y = 0; y < picture.height(); ++y)
    std::copy_n(picture.view().row(y), picture.width(), out.view().row(y));
  const std::int32_t unit_width = legend.unit.empty() ? 0 : text_size(legend.unit, 2).width + 12;
  const std::int32_t bar_width = width - 2 * margin - unit_width, top = picture.height() + bar_top;
  for (std::int32_t x = 0; x < bar_width; ++x) {
    const Rgb colour = legend.colour((x + 0.5) / bar_width);
    for (std::int32_t y = 0; y < bar_height; ++y) out.at(margin + x, top + y) = colour;
  }
  for (const Tick& tick : legend.ticks) {
    const auto x = static_cast<std::int32_t>(margin + tick.place * (bar_width - 1));
    for (std::int32_t y = bar_height - 4; y < bar_height + 4; ++y) out.at(x, top + y) = ink;
    const std::int32_t text_width = text_size(tick.text, 2).width;
    const std::int32_t left = std::clamp(x - text_width / 2, 2, std::max(2, width - text_width - 2));
    draw_text(out.view(), tick.text, {.x = left, .y = top + bar_height + 7, .scale = 2, .colour = ink});
  }
  draw_text(out.view(), legend.unit, {.x = margin + bar_width + 12, .y = top, .scale = 2, .colour = ink});
  return out;
}

}  // namespace straightedge::cli
