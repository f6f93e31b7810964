// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include "io/plane_scene.hpp"
#include "straightedge/host/plane_view.hpp"

namespace straightedge::io {

/// The text as a JSON string, quotes included, in which an HTML page cannot find the end of the
/// script: < > & are escaped, too. Bytes that are not UTF-8 become U+FFFD.
std::string json_text(std::string_view text);

/// What the script of the page draws, as one JSON object:
///  up         "z", "y" or "-y";
///  turn       degrees: where the eye stands in the oblique view (oblique_turn);
///  origin, step   metres: a coordinate c below stands for origin + step · c;
///  planes     id, n, d, length, width, area, front, colour, and points, frames, seen, source where the map
///  has them;
///             pieces: at (place of the id), rings (x y z of each vertex in a row; the outer border first);
///  path       x y z of the camera, then its forward and its down direction, for each pose;
///  cloud      points by plane: plane (place in planes, −1: none), xyz in a row;
///  left_out   points that were not kept.
std::string plane_view_data(const PlaneMap& map, const PlaneScene& scene, const PlaneViewOptions& options);

}  // namespace straightedge::io
