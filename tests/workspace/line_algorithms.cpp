// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <cstdint>

#include "algorithms.hpp"
#include "inputs.hpp"
#include "straightedge/edge_position.hpp"
#include "straightedge/end_points.hpp"
#include "straightedge/hough_lines.hpp"
#include "straightedge/segment_refit.hpp"

namespace workspace {
namespace {

Size size() {
  return gray_picture().size();
}

GradientField field(CallerMemory& memory) {
  return {memory.input(edges().dx), memory.input(edges().dy), memory.input(edges().magnitude)};
}

GradientView gradient(CallerMemory& memory) {
  return {memory.input(edges().dx), memory.input(edges().dy)};
}

void say(CallerMemory& memory, std::span<const HoughSegment> segments) {
  memory.say({static_cast<double>(segments.size())});
  for (const HoughSegment& s : segments) {
    memory.say({s.x0 * 1.0, s.y0 * 1.0, s.x1 * 1.0, s.y1 * 1.0, s.votes * 1.0, s.pixels * 1.0});
  }
}

/// The upper side of the bar.
constexpr HoughSegment upper_side{10, 46, 70, 12, 0, 0};

template <HoughMethod method>
Status run_hough(CallerMemory& memory) {
  HoughOptions options;
  options.method = method;
  options.threshold = 20;
  options.min_length = 20;
  options.gradient_window = 0.3;
  HoughLines lines;
  const Status prepared = HoughLines::prepare(lines, size(), options,
                                              memory.workspace(HoughLines::workspace_bytes(size(), options)));
  const auto peaks = memory.list<HoughPeak>(100);
  const auto segments = memory.list<HoughSegment>(100);
  const auto result = lines.run(memory.input(edges().mask), gradient(memory), peaks, segments);
  say(memory, segments.first(result.segments));
  memory.say({result.edge_pixels * 1.0, static_cast<double>(result.draws)});
  for (const HoughPeak& peak : peaks.first(result.peaks)) {
    memory.say({static_cast<double>(peak.rho), static_cast<double>(peak.theta), peak.votes * 1.0});
  }
  return whole(prepared, result.status);
}

Status run_end_points(CallerMemory& memory) {
  const auto segments = memory.list<HoughSegment>(20);
  // Row 8, the upper side of the box.
  const auto found = end_points(memory.input(edges().mask), gradient(memory), {8, 1.5707964F, 0},
                                {.min_length = 10, .gradient_window = 0.3}, segments);
  say(memory, segments.first(found.segments));
  return found.status;
}

Status run_edge_position(CallerMemory& memory) {
  const GradientField there = field(memory);
  for (int y = 0; y < size().height; ++y) {
    for (int x = 0; x < size().width; ++x) {
      if (edges().mask.at(x, y) == 0) continue;
      const EdgePosition position = edge_position(there, x, y);
      memory.say({position.x, position.y, position.variance});
    }
  }
  return Status::ok;
}

Status run_refit(CallerMemory& memory) {
  RefinedSegment refined;
  const Status status = refit_segment(memory.input(edges().mask), field(memory), upper_side, {}, refined);
  memory.say({refined.pixels * 1.0, refined.fit.theta, refined.fit.centroid_x, refined.fit.centroid_y,
              refined.fit.var_theta, refined.fit.var_offset, refined.begin, refined.end});
  return status;
}

Status run_claim(CallerMemory& memory) {
  RefinedSegment refined;
  const auto& e = edges();
  const GradientField packed{e.dx.view(), e.dy.view(), e.magnitude.view()};
  REQUIRE(refit_segment(e.mask.view(), packed, upper_side, {}, refined) == Status::ok);
  memory.say({claim_pixels(memory.changed(e.mask), field(memory), refined, 2, 0.5, 3) * 1.0});
  return Status::ok;
}

constexpr Algorithm algorithms[] = {
    {"hough standard", run_hough<HoughMethod::standard>},
    {"hough progressive", run_hough<HoughMethod::progressive>},
    {"hough randomized", run_hough<HoughMethod::randomized>},
    {"end points", run_end_points},
    {"edge position", run_edge_position},
    {"segment refit", run_refit},
    {"claim pixels", run_claim},
};

}  // namespace

std::span<const Algorithm> line_algorithms() {
  return algorithms;
}

}  // namespace workspace
