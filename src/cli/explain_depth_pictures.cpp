// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "cli/explain_depth_pictures.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>

#include "cli/explain_colours.hpp"
#include "cli/explain_legend.hpp"
#include "cli/explain_paint.hpp"
#include "cli/explain_text.hpp"
#include "straightedge/host/label_picture.hpp"

namespace straightedge::cli {
namespace {

constexpr double residual_range = 3;  // sigma

struct Middle {
  double u = 0, v = 0, count = 0;
};

std::vector<Middle> middles_of(ImageView<const std::uint16_t> labels) {
  std::vector<Middle> middles;
  for (std::int32_t y = 0; y < labels.height; ++y) {
    for (std::int32_t x = 0; x < labels.width; ++x) {
      const std::uint16_t label = labels.at(x, y);
      if (label == 0) continue;
      if (label > middles.size()) middles.resize(label);
      Middle& m = middles[label - 1U];
      m.u += x;
      m.v += y;
      m.count += 1;
    }
  }
  return middles;
}

/// The label's pixel that is nearest to the middle of all: a frame around a door has its middle in the door.
std::vector<Point2> own_pixels(ImageView<const std::uint16_t> labels, const std::vector<Middle>& middles) {
  std::vector<Point2> places(middles.size());
  std::vector<double> nearest(middles.size(), 1e300);
  for (std::int32_t y = 0; y < labels.height; ++y) {
    for (std::int32_t x = 0; x < labels.width; ++x) {
      if (labels.at(x, y) == 0) continue;
      const std::size_t k = labels.at(x, y) - 1U;
      const double du = x - middles[k].u / middles[k].count, dv = y - middles[k].v / middles[k].count;
      if (du * du + dv * dv >= nearest[k]) continue;
      nearest[k] = du * du + dv * dv;
      places[k] = {static_cast<double>(x), static_cast<double>(y)};
    }
  }
  return places;
}

double share_between(double value, double low, double high) {
  return high > low ? (value - low) / (high - low) : 0;
}

}  // namespace

DepthRange depth_range(const ExplainDepthRun& run) {
  std::vector<std::uint16_t> raw;
  const auto& view = run.depth.raw;
  for (std::int32_t y = 0; y < view.height; ++y)
    std::copy_if(view.row(y), view.row(y) + view.width, std::back_inserter(raw),
                 [](auto d) { return d != 0; });
  if (raw.empty()) return {};
  std::sort(raw.begin(), raw.end());
  const std::size_t last = raw.size() - 1;
  return {raw[last / 100] * run.depth.metres_per_unit, raw[last - last / 100] * run.depth.metres_per_unit};
}

Rgb depth_colour(double share) {
  constexpr Rgb stops[] = {{252, 232, 104}, {160, 204, 92}, {70, 164, 122},
                           {50, 112, 148},  {62, 62, 132},  {56, 22, 78}};
  constexpr int last = static_cast<int>(std::size(stops)) - 1;
  const double place = last * std::clamp(share, 0.0, 1.0);
  const int i = std::min(static_cast<int>(place), last - 1);
  return mix(stops[i], stops[i + 1], place - i);
}

Rgb signed_colour(double share) {
  constexpr Rgb below{0x1B, 0x4F, 0xB0}, above{0xC2, 0x1F, 0x2C};
  return share < 0.5 ? mix(below, paper, 2 * share) : mix(paper, above, 2 * share - 1);
}

Image<Rgb> show_depth(const ExplainDepthRun& run, const DepthRange& range) {
  const Size size = run.depth.raw.size();
  const auto picture = paint(size, zoom_of(size), [&](std::int32_t x, std::int32_t y) {
    const std::uint16_t raw = run.depth.raw.at(x, y);
    if (raw == 0) return hole_colour;
    return depth_colour(share_between(raw * run.depth.metres_per_unit, range.nearest, range.farthest));
  });
  return with_legend(picture, {depth_colour, ticks_between(range.nearest, range.farthest), "m"});
}

Image<Rgb> show_inverse_depth(const ExplainDepthRun& run, const DepthRange& range) {
  const Size size = run.depth.raw.size();
  const double low = range.farthest > 0 ? 1 / range.farthest : 0;
  const double high = range.nearest > 0 ? 1 / range.nearest : 0;
  const auto colour = [](double share) { return depth_colour(1 - share); };
  const auto picture = paint(size, zoom_of(size), [&](std::int32_t x, std::int32_t y) {
    const auto q = static_cast<double>(run.inverse_depth.at(x, y));
    return q > 0 ? colour(share_between(q, low, high)) : hole_colour;
  });
  return with_legend(picture, {colour, ticks_between(low, high), "1 per m"});
}

Image<Rgb> show_candidates(const ExplainDepthRun& run) {
  const Size size = run.nearest.size();
  auto picture = paint(size, zoom_of(size), [&](std::int32_t x, std::int32_t y) {
    const std::uint16_t candidate = run.nearest.at(x, y);
    if (candidate != 0) return plane_colour(candidate);
    return run.inverse_depth.at(x, y) > 0 ? free_colour_of_readings : hole_colour;
  });
  draw_numbers(picture, run.nearest, zoom_of(size), numbered_candidates);
  return picture;
}

Image<Rgb> show_labels(const ExplainDepthRun& run) {
  const Image<Rgb> plain = label_picture(run.found.labels, run.depth.raw);
  const int zoom = zoom_of(plain.size());
  auto picture = paint(plain.size(), zoom, [&](std::int32_t x, std::int32_t y) { return plain.at(x, y); });
  draw_numbers(picture, run.found.labels, zoom, run.found.planes.size());
  return picture;
}

Residuals show_residuals(const ExplainDepthRun& run) {
  const Size size = run.depth.raw.size();
  const PlaneGate& gate = run.options.frame.gate;
  std::vector<InverseDepthPlane> planes;
  for (const FoundPlane& plane : run.found.planes)
    planes.push_back(to_inverse_depth(plane.fit.plane, run.depth.camera));
  Residuals out;
  double squares = 0, inside = 0, count = 0;
  const auto picture = paint(size, zoom_of(size), [&](std::int32_t x, std::int32_t y) {
    const auto q = static_cast<double>(run.inverse_depth.at(x, y));
    if (!(q > 0)) return hole_colour;
    const std::uint16_t label = run.found.labels.at(x, y);
    if (label == 0) return free_colour_of_readings;
    const double residual = (q - planes[label - 1U].at(x, y)) / gate.inverse_noise(q);
    squares += residual * residual;
    inside += std::abs(residual) <= 1 ? 1 : 0;
    count += 1;
    return signed_colour(0.5 + 0.5 * residual / residual_range);
  });
  out.picture =
      with_legend(picture, {signed_colour, ticks_between(-residual_range, residual_range), "sigma"});
  out.rms = count > 0 ? std::sqrt(squares / count) : 0;
  out.within = count > 0 ? inside / count : 0;
  return out;
}

void draw_numbers(Image<Rgb>& picture, ImageView<const std::uint16_t> labels, int zoom, std::size_t most) {
  const std::vector<Middle> middles = middles_of(labels);
  const std::vector<Point2> places = own_pixels(labels, middles);
  for (std::size_t k = 0; k < places.size() && k < most; ++k) {
    if (middles[k].count == 0) continue;
    draw_tag(picture, std::to_string(k + 1), {(places[k].x + 0.5) * zoom, (places[k].y + 0.5) * zoom},
             {.scale = 2, .colour = ink});
  }
}

}  // namespace straightedge::cli
