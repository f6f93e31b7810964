// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "localize/pieces.hpp"
#include "straightedge/host/hough_lines.hpp"
#include "straightedge/host/image.hpp"

namespace straightedge::localize {
namespace {

constexpr double most_pixels = 1500;  // of a side

struct Raster {
  double left = 0, bottom = 0;
  double pixel = 0.05;  // metres
};

Raster raster_round(const PointRow& row, Size& size) {
  double right = -1e300, top = -1e300;
  Raster raster{1e300, 1e300, 0.5 * row.options.split_distance_m};
  for (const ScanPoint& p : row.points) {
    raster.left = std::min(raster.left, p.x_m);
    right = std::max(right, p.x_m);
    raster.bottom = std::min(raster.bottom, p.y_m);
    top = std::max(top, p.y_m);
  }
  const double side = std::max(right - raster.left, top - raster.bottom);
  raster.pixel = std::max(raster.pixel, side / most_pixels);
  size = {static_cast<int>((right - raster.left) / raster.pixel) + 1,
          static_cast<int>((top - raster.bottom) / raster.pixel) + 1};
  return raster;
}

HoughOptions hough_options(const PointRow& row, const Raster& raster) {
  HoughOptions hough;
  hough.threshold = static_cast<std::int32_t>(row.options.min_points);
  hough.min_length = row.options.min_length_m / raster.pixel;
  // Points of a far wall are sparse; the gap test on the points themselves comes later.
  double farthest = 0;
  for (const ScanPoint& p : row.points) farthest = std::max(farthest, p.range_m);
  hough.max_gap = (row.options.max_gap_m + 3 * farthest * std::fabs(row.angle_step_rad)) / raster.pixel;
  hough.seed = row.options.seed;
  return hough;
}

/// The segment in metres, as a line and a stretch along it.
bool line_of_segment(const HoughSegment& segment, const Raster& raster, LineFit& fit, double& half) {
  const auto metres = [&](std::int32_t pixel) { return (pixel + 0.5) * raster.pixel; };
  LineMoments moments;
  moments.add(metres(segment.x0), metres(segment.y0));
  moments.add(metres(segment.x1), metres(segment.y1));
  if (fit_line(moments, fit) != Status::ok) return false;
  fit.centroid_x += raster.left;
  fit.centroid_y += raster.bottom;
  const double dx = metres(segment.x1) - metres(segment.x0);
  const double dy = metres(segment.y1) - metres(segment.y0);
  half = 0.5 * std::sqrt(dx * dx + dy * dy) + raster.pixel;
  return true;
}

}  // namespace

void hough_pieces(const PointRow& row, Pieces& pieces) {
  if (row.points.size() < row.options.min_points) return;
  Size size;
  const Raster raster = raster_round(row, size);
  Image<std::uint8_t> picture(size);
  for (const ScanPoint& p : row.points) {
    picture.at(static_cast<int>((p.x_m - raster.left) / raster.pixel),
               static_cast<int>((p.y_m - raster.bottom) / raster.pixel)) = 255;
  }
  HoughFound found = hough_lines(picture.view(), hough_options(row, raster));
  std::stable_sort(found.segments.begin(), found.segments.end(),
                   [](const HoughSegment& a, const HoughSegment& b) { return a.pixels > b.pixels; });
  std::vector<char> owned(row.points.size());
  for (const HoughSegment& segment : found.segments) {
    LineFit fit;
    double half = 0;
    if (line_of_segment(segment, raster, fit, half)) take_along(row, fit, -half, half, owned, pieces);
  }
}

}  // namespace straightedge::localize
