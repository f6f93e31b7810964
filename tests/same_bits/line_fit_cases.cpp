// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <array>

#include "cases.hpp"
#include "edge_scene.hpp"
#include "hash_results.hpp"
#include "straightedge/hough_lines.hpp"
#include "straightedge/line_fit.hpp"
#include "straightedge/random.hpp"
#include "straightedge/segment_refit.hpp"

namespace same_bits {
namespace {

using namespace straightedge;

constexpr HoughOptions rough{.threshold = 18, .min_length = 14, .max_gap = 3};
static_assert(EdgeScene::bytes + HoughLines::workspace_bytes(picture_size, rough) <= most_workspace);

constexpr std::size_t most_segments = 64;
SAME_BITS_LARGE std::array<HoughSegment, most_segments> segments;
SAME_BITS_LARGE std::array<LineFit, most_segments> fits;

void position_row(const Report& report, const EdgeScene& scene) noexcept {
  Hash hash;
  for (int y = 0; y < picture_size.height; ++y) {
    for (int x = 0; x < picture_size.width; ++x) {
      if (scene.edges.at(x, y) != 0) hash.add(edge_position(scene.field(), x, y));
    }
  }
  report.row({"fit.edge_position"}, hash);
}

/// Refits rough segments, and takes their pixels as the line map does. Returns how many fits there are.
std::size_t refit_rows(const Report& report, const EdgeScene& scene) noexcept {
  HoughLines lines;
  Hash refits, claims;
  refits.add(HoughLines::prepare(lines, picture_size, rough, scene.rest));
  const HoughResult found = lines.run(scene.edges, {}, segments);
  std::size_t count = 0;
  for (const HoughSegment& segment : std::span<const HoughSegment>(segments).first(found.segments)) {
    RefinedSegment refined;
    refits.add(refit_segment(scene.edges, scene.field(), segment, {}, refined), refined);
    if (refined.pixels == 0) continue;
    fits[count++] = refined.fit;
    claims.add(claim_pixels(scene.edges, scene.field(), refined, 1.5, 0.5, 2));
  }
  claims.add(scene.edges);
  report.row({"fit.refit_segment"}, refits);
  report.row({"fit.claim_pixels"}, claims);
  return count;
}

void pair_rows(const Report& report, std::size_t count) noexcept {
  Hash floors, distances;
  for (std::size_t i = 0; i < count; ++i) {
    add_floor(fits[i], 10.0 + static_cast<double>(i), {});
    floors.add(fits[i]);
    for (std::size_t j = 0; j < i; ++j) distances.add(line_chi_square(fits[i], fits[j]));
  }
  report.row({"fit.line_floor"}, floors);
  report.row({"fit.line_chi_square"}, distances);
}

void line_row(const Report& report) noexcept {
  Pcg32 random(41);
  Hash hash;
  for (int i = 0; i < 60; ++i) {
    LineMoments moments, others;
    const auto number = [&](std::uint32_t bound) { return random.below(bound) / 64.0; };
    const double slope = number(400) - 3, start = number(6400);
    for (int k = 0; k < 12; ++k) {
      const double x = number(5000), y = start + slope * x + number(90);
      (k % 2 == 0 ? moments : others).add(x, y, 0.25 + number(64));
    }
    LineFit fit;
    hash.add(moments, others.seen_from(3, 7));
    moments.add(others);
    hash.add(fit_line(moments, fit), fit);
  }
  report.row({"fit.line"}, hash);
}

}  // namespace

void line_fit_cases(const Report& report) noexcept {
  line_row(report);
  EdgeScene scene;
  Hash made;
  made.add(scene.make());
  report.row({"fit.input"}, made);
  position_row(report, scene);
  pair_rows(report, refit_rows(report, scene));
}

}  // namespace same_bits
