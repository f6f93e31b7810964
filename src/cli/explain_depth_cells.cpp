// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "cli/explain_colours.hpp"
#include "cli/explain_depth_pictures.hpp"
#include "cli/explain_legend.hpp"
#include "cli/explain_paint.hpp"
#include "straightedge/host/label_picture.hpp"

namespace straightedge::cli {
namespace {

constexpr double least_share = 0.2;  // of a cell's pixels; with fewer readings nothing is said about it
constexpr double roughest = 8;       // sigma at the end of the scale
constexpr Rgb flat_from{0xD9, 0xEE, 0xE3}, flat_to{0x55, 0xA8, 0x8A};
constexpr Rgb rough_from{0xF2, 0xC1, 0x4E}, rough_to{0xA8, 0x1E, 0x22};

/// Green where a cell counts as flat, yellow to red where it does not. Place: rms by the square root.
Rgb roughness_colour(double rms) {
  if (rms <= flat_cell) return mix(flat_from, flat_to, rms / flat_cell);
  return mix(rough_from, rough_to, std::log(rms / flat_cell) / std::log(roughest / flat_cell));
}

double rms_at(double place) {
  return roughest * place * place;
}

/// Root of the mean square residual over the noise; negative for too few readings.
double roughness(const InverseDepthMoments& cell, double least, const PlaneGate& gate) {
  InverseDepthFit fit;
  if (cell.n < least || fit_inverse_depth(cell, gate.inverse_sigma, fit) != Status::ok) return -1;
  return fit.rms / gate.inverse_noise(cell.q / cell.n);
}

template <class Colour>
Image<Rgb> paint_cells(const ExplainDepthRun& run, int level, Colour colour) {
  const Size frame = run.depth.raw.size(), cells = DepthCells::size_of(frame, level);
  const std::int32_t side = DepthCells::side << level;
  std::vector<Rgb> colours(DepthCells::cell_count(cells));
  for (std::size_t i = 0; i < colours.size(); ++i) colours[i] = colour(i);
  return paint(frame, zoom_of(frame), [&](std::int32_t x, std::int32_t y) {
    return colours[static_cast<std::size_t>(y / side) * static_cast<std::size_t>(cells.width) +
                   static_cast<std::size_t>(x / side)];
  });
}

/// Which of the frame's planes each label of a level became: the one with most pixels in common, 0 for none.
std::vector<std::uint16_t> final_labels(const ExplainDepthRun& run, int level) {
  const auto labels = run.detector->frame().cell_labels(level);
  const Size frame = run.depth.raw.size();
  const auto width = static_cast<std::size_t>(DepthCells::size_of(frame, level).width);
  const auto side = static_cast<std::uint32_t>(DepthCells::side << level);
  const std::size_t most = labels.empty() ? 0 : *std::max_element(labels.begin(), labels.end());
  const std::size_t planes = run.found.planes.size() + 1;
  std::vector<std::uint32_t> common((most + 1) * planes);
  for (std::int32_t y = 0; y < frame.height; ++y) {
    for (std::int32_t x = 0; x < frame.width; ++x) {
      const std::size_t cell =
          static_cast<std::uint32_t>(y) / side * width + static_cast<std::uint32_t>(x) / side;
      ++common[labels[cell] * planes + run.found.labels.at(x, y)];
    }
  }
  std::vector<std::uint16_t> becomes(most + 1);
  for (std::size_t label = 1; label <= most; ++label) {
    const auto row = common.begin() + static_cast<std::ptrdiff_t>(label * planes);
    const auto best = std::max_element(row + 1, row + static_cast<std::ptrdiff_t>(planes));
    const bool any = planes > 1 && *best > 0;
    becomes[label] = any ? static_cast<std::uint16_t>(best - row) : std::uint16_t{0};
  }
  return becomes;
}

}  // namespace

FlatCells show_flat_cells(const ExplainDepthRun& run, int level) {
  const PlaneGate gate = widened(run.options.frame);
  const double side = DepthCells::side << level;
  FlatCells out;
  const auto picture = paint_cells(run, level, [&](std::size_t i) {
    const double rms = roughness(run.cells->view().moments(level, i), least_share * side * side, gate);
    if (rms < 0) return hole_colour;
    ++out.cells;
    out.flat += rms <= flat_cell ? 1U : 0U;
    return roughness_colour(rms);
  });
  std::vector<Tick> ticks;
  for (const int value : {0, 1, 2, 4, 8})
    ticks.push_back({std::sqrt(value / roughest), std::to_string(value)});
  out.picture =
      with_legend(picture, {[](double place) { return roughness_colour(rms_at(place)); }, ticks, "sigma"});
  return out;
}

LabelledCells show_cell_labels(const ExplainDepthRun& run, int level) {
  const auto labels = run.detector->frame().cell_labels(level);
  const std::vector<std::uint16_t> becomes = final_labels(run, level);
  LabelledCells out;
  out.picture = paint_cells(run, level, [&](std::size_t i) {
    if (run.cells->view().at(level, i).n == 0) return hole_colour;
    if (labels[i] == 0) return free_colour_of_readings;
    ++out.labelled;
    const std::uint16_t plane = becomes[labels[i]];
    return plane != 0 ? plane_colour(plane) : paper;
  });
  return out;
}

}  // namespace straightedge::cli
