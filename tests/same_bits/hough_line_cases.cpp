// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <array>

#include "cases.hpp"
#include "edge_scene.hpp"
#include "hash_results.hpp"
#include "straightedge/end_points.hpp"
#include "straightedge/hough_lines.hpp"
#include "straightedge/hough_randomized.hpp"

namespace same_bits {
namespace {

using namespace straightedge;

struct Case {
  const char* name;
  HoughOptions options;
};

constexpr HoughOptions options_of(HoughMethod method, std::int32_t threshold) noexcept {
  HoughOptions options;
  options.method = method;
  options.threshold = threshold;
  options.min_length = 14;
  options.max_gap = 3;
  return options;
}

template <class Change>
constexpr HoughOptions changed(HoughOptions options, Change change) noexcept {
  change(options);
  return options;
}

constexpr HoughOptions standard = options_of(HoughMethod::standard, 24);
constexpr HoughOptions progressive = options_of(HoughMethod::progressive, 18);
constexpr HoughOptions randomized =
    changed(options_of(HoughMethod::randomized, 20), [](HoughOptions& o) { o.max_draws = 20'000; });

constexpr Case cases[] = {
    {"hough.standard", standard},
    {"hough.standard.coarse",
     changed(standard, [](HoughOptions& o) { o.rho_step = 1.5, o.theta_step = 0.04; })},
    {"hough.standard.window", changed(standard, [](HoughOptions& o) { o.gradient_window = 0.3; })},
    {"hough.standard.part", changed(standard, [](HoughOptions& o) { o.min_theta = 0.5, o.max_theta = 2; })},
    {"hough.progressive", progressive},
    {"hough.progressive.seed", changed(progressive, [](HoughOptions& o) { o.seed = 987'654'321'012; })},
    {"hough.progressive.coarse", changed(progressive, [](HoughOptions& o) { o.theta_step *= 2; })},
    {"hough.progressive.fine",
     changed(progressive, [](HoughOptions& o) { o.rho_step = 0.5, o.theta_step = 0.01; })},
    {"hough.progressive.window", changed(progressive, [](HoughOptions& o) { o.gradient_window = 0.4; })},
    {"hough.progressive.room", changed(progressive, [](HoughOptions& o) { o.max_edge_pixels = 1300; })},
    {"hough.progressive.no_room", changed(progressive, [](HoughOptions& o) { o.max_edge_pixels = 1200; })},
    {"hough.progressive.opencv",
     changed(progressive, [](HoughOptions& o) { o.generator = HoughGenerator::opencv; })},
    {"hough.randomized", randomized},
    {"hough.randomized.window", changed(randomized, [](HoughOptions& o) { o.gradient_window = 0.4; })},
    {"hough.randomized.anywhere", changed(randomized, [](HoughOptions& o) { o.pair_radius = 0; })},
};

constexpr std::size_t most_bytes() noexcept {
  std::size_t most = 0;
  for (const Case& c : cases) {
    const std::size_t bytes = HoughLines::workspace_bytes(picture_size, c.options);
    if (bytes > most) most = bytes;
  }
  return most;
}
static_assert(EdgeScene::bytes + most_bytes() <= most_workspace);

/// Room for results; a run's come first.
SAME_BITS_LARGE std::array<HoughPeak, 300> peaks;
SAME_BITS_LARGE std::array<HoughSegment, 300> segments;

void rows_of(const Report& report, const Case& c, GrayView edges, const EdgeScene& scene,
             const HoughKernels* kernels) noexcept {
  HoughOptions options = c.options;
  options.kernels = kernels;
  HoughLines lines;
  Hash result_hash, peaks_hash, segments_hash, rest, votes;
  result_hash.add(HoughLines::prepare(lines, picture_size, options, scene.rest));
  const HoughResult result = lines.run(edges, scene.gradients(), peaks, segments);
  result_hash.add(result);
  peaks_hash.add(std::span<const HoughPeak>(peaks).first(result.peaks));
  segments_hash.add(std::span<const HoughSegment>(segments).first(result.segments));
  report.row({c.name, ".result"}, result_hash);
  if (c.options.method != HoughMethod::progressive) report.row({c.name, ".peaks"}, peaks_hash);
  report.row({c.name, ".segments"}, segments_hash);
  if (result.status != Status::ok) return;  // nothing else was written
  for (int y = 0; y < picture_size.height; ++y) {
    for (int x = 0; x < picture_size.width; ++x) rest.add(lines.remaining().at(x, y));
  }
  report.row({c.name, ".remaining"}, rest);
  const HoughVotesView cells = lines.accumulator();
  votes.add(cells.width, cells.height);
  for (std::int32_t n = 0; n < cells.height; ++n) {
    for (std::int32_t r = 0; r < cells.width; ++r) votes.add(cells.at(r, n));
  }
  report.row({c.name, ".accumulator"}, votes);
}

/// What a caller finds who has lines from elsewhere.
void end_point_row(const Report& report, const EdgeScene& scene) noexcept {
  Hash hash;
  for (int i = 0; i < 60; ++i) {
    const HoughPeak line{static_cast<float>(3 * i - 40), static_cast<float>(i) / 20, i};
    const EndPointOptions options{.min_length = 8, .max_gap = 2, .gradient_window = i % 3 == 0 ? 0.5 : 0.0};
    const EndPointResult found = end_points(scene.edges, scene.gradients(), line, options, segments);
    hash.add(found.status, std::span<const HoughSegment>(segments).first(found.segments));
  }
  report.row({"hough.end_points"}, hash);
}

void draw_bound_row(const Report& report) noexcept {
  Hash hash;
  for (int i = 1; i < 60; ++i) {
    const PairDrawing drawing{37.0 * i, 11.0 * i, 9.0 + i};
    hash.add(pair_hit_probability(drawing, randomized), pair_vote_spread({i * 31, i * 17}, randomized),
             draws_needed(drawing, picture_size, randomized));
  }
  report.row({"hough.randomized.draws_needed"}, hash);
}

}  // namespace

void hough_line_cases(const Report& report, const Kernels& kernels) noexcept {
  EdgeScene scene;
  Hash made;
  made.add(scene.make(), scene.edges);
  report.row({"hough.input"}, made);
  for (const Case& c : cases) rows_of(report, c, scene.edges, scene, kernels.hough);
  rows_of(report, {"hough.progressive.noise", progressive}, noise_picture(), scene, kernels.hough);
  end_point_row(report, scene);
  draw_bound_row(report);
}

}  // namespace same_bits
