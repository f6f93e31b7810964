// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "map/strokes.hpp"

#include <cstddef>

namespace straightedge {
namespace {

constexpr double step = 0.5;
constexpr double before = 2;    // pixels on the light side that blur darkens
constexpr double behind = 2.5;  // pixels behind the thickest thin wall
constexpr double half_dark = 0.5;
constexpr double min_width = 0.3;
constexpr double most = 0.75;  // of the face's length

struct Stroke {
  double width = 0;
  double centre = 0;  ///< along the normal
  bool thin = false;
};

/// Steps 1 and 2 at one place: the grays at these distances from the face.
Stroke stroke_of(const std::vector<double>& distances, const std::vector<double>& grays, double max_width) {
  Stroke stroke;
  double dark = 0, moment = 0, last = 0;
  for (std::size_t i = 0; i < grays.size(); ++i) {
    last = 1 - grays[i] / 255;
    dark += last;
    moment += distances[i] * last;
  }
  stroke.width = dark * step;
  stroke.centre = dark > 0 ? moment / dark : 0;
  stroke.thin = stroke.width >= min_width && stroke.width <= max_width && last < half_dark;
  return stroke;
}

}  // namespace

std::uint32_t turn_strokes_to_axes(std::vector<WallLine>& lines, const LineSampler& picture,
                                   double max_width) {
  std::uint32_t turned = 0;
  std::vector<double> distances;
  for (double u = before; u >= -max_width - behind; u -= step) distances.push_back(u);
  std::vector<double> grays(distances.size()), places;
  for (WallLine& line : lines) {
    if (line.axis) continue;
    places.clear();
    for (double s = line.begin + 0.5; s < line.end; s += place_step(line.length())) places.push_back(s);
    double width = 0, centre = 0;
    const double least = most * static_cast<double>(places.size());
    auto thin = static_cast<int>(places.size());
    for (const double s : places) {
      picture.across(line, s, distances, grays.data());
      const Stroke stroke = stroke_of(distances, grays, max_width);
      width += stroke.thin ? stroke.width : 0;
      centre += stroke.thin ? stroke.centre : 0;
      if (!stroke.thin && --thin < least) break;  // the other places cannot change it
    }
    if (thin == 0 || thin < least) continue;
    const double move = centre / thin;  // Step 3
    line.origin_x += move * line.nx;
    line.origin_y += move * line.ny;
    line.fit.centroid_x += move * line.nx;
    line.fit.centroid_y += move * line.ny;
    line.axis = true;
    line.width = width / thin;
    ++turned;
  }
  return turned;
}

}  // namespace straightedge
