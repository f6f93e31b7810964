// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "cli/explain_run.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "cli/explain_geometry.hpp"
#include "straightedge/host/hough_lines.hpp"

namespace straightedge::cli {
namespace {

Failure failure_of(const char* stage, Status status) {
  const bool option = status == Status::invalid_option || status == Status::too_large;
  return {option ? Problem::bad_option : Problem::internal, std::string(stage) + ": " + to_string(status)};
}

std::uint32_t count(GrayView image, std::uint8_t value) {
  std::uint32_t found = 0;
  for (std::int32_t y = 0; y < image.height; ++y) {
    for (std::int32_t x = 0; x < image.width; ++x) found += image.at(x, y) == value;
  }
  return found;
}

Status run_canny(GrayView picture, const CannyOptions& options, ExplainRun& run) {
  run.taps.resize(static_cast<std::size_t>(gaussian_size(options.sigma)));
  Status status = make_gaussian_kernel(options.sigma, run.taps);
  if (status != Status::ok) return status;
  const std::size_t bytes = Canny::workspace_bytes(picture.size(), options);
  run.canny_memory = std::make_unique_for_overwrite<std::byte[]>(bytes);
  status = Canny::prepare(run.canny, picture.size(), options, {run.canny_memory.get(), bytes});
  if (status != Status::ok) return status;
  run.edges = Image<std::uint8_t>(picture.size());
  run.canny_result = run.canny.run(picture, run.edges.view());
  if (run.canny_result.status != Status::ok) return run.canny_result.status;
  run.limits = to_magnitude({run.canny_result.low, run.canny_result.high}, options.norm, options.aperture);
  run.weak_count = count(run.canny.suppressed(), weak_edge);
  run.crests = Image<std::uint8_t>(picture.size());
  status = suppress_non_maxima(run.canny.gradient_x(), run.canny.gradient_y(), run.canny.magnitude(), 0, 0,
                               run.crests.view());
  run.crest_count = count(run.crests, strong_edge);
  return status;
}

/// Two lines that stay close to one another all through the picture are one to the eye.
bool same_line(const HoughPeak& a, const HoughPeak& b, Size size) {
  const auto chord = chord_of(a, size);
  const double near = std::max(3.0, 0.05 * std::hypot(size.width, size.height));
  return chord && distance_to(b, chord->from) < near && distance_to(b, chord->to) < near;
}

std::vector<HoughPeak> highest_apart(const std::vector<HoughPeak>& peaks, Size size) {
  std::vector<HoughPeak> kept;
  for (const HoughPeak& peak : peaks) {
    if (kept.size() == shown_peaks) break;
    const bool known =
        std::any_of(kept.begin(), kept.end(), [&](const HoughPeak& k) { return same_line(peak, k, size); });
    if (!known) kept.push_back(peak);
  }
  return kept;
}

Status count_votes(HoughOptions options, ExplainRun& run) {
  options.method = HoughMethod::standard;
  options.gradient_window = 0;
  options.min_theta = 0;
  options.max_theta = pi;
  const Size size = run.edges.size();
  const std::size_t bytes = HoughLines::workspace_bytes(size, options);
  run.votes_memory = std::make_unique_for_overwrite<std::byte[]>(bytes);
  const Status prepared = HoughLines::prepare(run.votes, size, options, {run.votes_memory.get(), bytes});
  if (prepared != Status::ok) return prepared;
  std::vector<HoughPeak> peaks(4096);
  const HoughResult result = run.votes.run(run.edges, peaks, {});
  if (result.status != Status::ok && result.status != Status::output_full) return result.status;
  peaks.resize(result.peaks);
  run.peaks = highest_apart(peaks, size);
  return Status::ok;
}

}  // namespace

Result<ExplainRun> run_stages(GrayView gray, const LineMapOptions& options) {
  if (!options.hough) return Failure{Problem::bad_option, "only the Hough transform can be explained"};
  // The line map first: it checks the picture and every option.
  auto lines = build_line_map(gray, options);
  if (!lines) return lines.failure();
  ExplainRun run;
  run.lines = std::move(*lines);
  run.picture = understand_picture(gray, options.picture, options.meaning);
  if (const Status status = run_canny(run.picture.stretched, options.canny, run); status != Status::ok)
    return failure_of("the edge detector", status);
  if (const Status status = count_votes(first_round(options), run); status != Status::ok)
    return failure_of("the accumulator", status);
  HoughFound found =
      hough_lines(run.edges, first_round(options), {run.canny.gradient_x(), run.canny.gradient_y()});
  if (found.result.status != Status::ok) return failure_of("the Hough transform", found.result.status);
  run.segments = std::move(found.segments);
  run.hough = found.result;
  return run;
}

}  // namespace straightedge::cli
