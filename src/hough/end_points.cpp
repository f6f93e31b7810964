// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "straightedge/end_points.hpp"

#include "hough/strip_walk.hpp"
#include "straightedge/hough_grid.hpp"
#include "straightedge/trigonometry.hpp"

namespace straightedge {
namespace {

Status check(GrayView edges, GradientView gradients, const HoughPeak& line,
             const EndPointOptions& options) noexcept {
  using detail::within;
  if (!edges.valid()) return Status::invalid_image;
  if (edges.width > 32767 || edges.height > 32767) return Status::too_large;
  if (!within(options.min_length, 0, 1e9) || !within(options.max_gap, 0, 1e9) ||
      !within(options.half_width, 0.5, 100) || !within(options.min_support, 0, 1) ||
      !within(options.gradient_window, 0, pi))
    return Status::invalid_option;
  if (!within(static_cast<double>(line.rho), -1e9, 1e9)) return Status::invalid_option;
  if (!within(static_cast<double>(line.theta), -100, 100)) return Status::invalid_option;
  if (options.gradient_window == 0) return Status::ok;
  if (!gradients.valid()) return Status::invalid_image;
  const bool same = gradients.dx.size() == edges.size() && gradients.dy.size() == edges.size();
  return same ? Status::ok : Status::size_mismatch;
}

}  // namespace

EndPointResult end_points(GrayView edges, GradientView gradients, const HoughPeak& line,
                          const EndPointOptions& options, std::span<HoughSegment> segments) noexcept {
  EndPointResult result;
  result.status = check(edges, gradients, line, options);
  if (result.status != Status::ok) return result;

  const SineCosine normal = sine_cosine(static_cast<double>(line.theta));
  const hough::StripWalk walk(edges.size(), {normal.cosine, normal.sine, static_cast<double>(line.rho)},
                              options.half_width);
  const hough::DirectionTest fits(gradients, options.gradient_window, normal.cosine, normal.sine);
  // Steps 1 and 2.
  const bool all = hough::for_each_piece(edges, walk, fits, options.max_gap, [&](const hough::Piece& piece) {
    // Step 3.
    if (!hough::worth_keeping(piece, options.min_length, options.min_support)) return true;
    if (result.segments == segments.size()) return false;
    segments[result.segments++] = hough::segment_of(walk, piece, line.votes);
    return true;
  });
  if (!all) result.status = Status::output_full;
  return result;
}

}  // namespace straightedge
