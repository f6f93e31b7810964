// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "cli/explain_chart.hpp"

#include <algorithm>
#include <utility>

#include "cli/explain_colours.hpp"
#include "cli/explain_text.hpp"
#include "straightedge/host/draw.hpp"

namespace straightedge::cli {

Chart::Chart(Size body, ChartAxis across, ChartAxis upwards)
    : body_(body),
      across_(std::move(across)),
      upwards_(std::move(upwards)),
      picture_(Size{left + body.width + right, top + body.height + bottom}, paper) {
  draw_axes();
}

Point2 Chart::place(double x, double y) const {
  return {left + body_.width * (x - across_.low) / (across_.high - across_.low),
          top + body_.height * (upwards_.high - y) / (upwards_.high - upwards_.low)};
}

void Chart::draw_axes() {
  const Stroke line{ink, 1.5, 1};
  const Point2 corner{1.0 * left, 1.0 * (top + body_.height)};
  draw_line(picture_.view(), corner, {1.0 * (left + body_.width), corner.y}, line);
  draw_line(picture_.view(), corner, {corner.x, 1.0 * top}, line);
  const auto write = [this](const std::string& text, std::int32_t x, std::int32_t y) {
    draw_text(picture_.view(), text, {.x = x, .y = y, .scale = 2, .colour = ink});
  };
  for (const Tick& tick : ticks_between(across_.low, across_.high, 8)) {
    const double x = left + tick.place * body_.width;
    draw_line(picture_.view(), {x, corner.y}, {x, corner.y + 6}, line);
    write(tick.text, static_cast<std::int32_t>(x) - text_size(tick.text, 2).width / 2,
          top + body_.height + 11);
  }
  for (const Tick& tick : ticks_between(upwards_.low, upwards_.high, 5)) {
    const double y = corner.y - tick.place * body_.height;
    draw_line(picture_.view(), {corner.x - 6, y}, {corner.x, y}, line);
    write(tick.text, left - 11 - text_size(tick.text, 2).width, static_cast<std::int32_t>(y) - 6);
  }
  write(across_.name, left + (body_.width - text_size(across_.name, 2).width) / 2, top + body_.height + 36);
  write(upwards_.name, 8, 12);
}

}  // namespace straightedge::cli
