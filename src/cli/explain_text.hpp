// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

#include "straightedge/host/image.hpp"
#include "straightedge/host/line_geometry.hpp"

namespace straightedge::cli {

/// Where and how a text stands in a picture.
struct TextPlace {
  std::int32_t x = 0;  ///< column of its left edge
  std::int32_t y = 0;  ///< row of its top
  int scale = 2;       ///< pixels for each dot of the letters
  Rgb colour;
};

/// Size of a text: letters are five dots wide and seven high (nine with their tails), a dot lies between two.
Size text_size(std::string_view text, int scale);

/// Labels for axes and marks: digits and small letters, in dots. What has no letter is left
/// blank; what lies outside of the picture is cut.
void draw_text(ImageView<Rgb> image, std::string_view text, const TextPlace& place);

/// A text on a white plate with its middle at a point, moved so that it lies within the picture. Size and
/// colour are those of `look`.
void draw_tag(Image<Rgb>& picture, std::string_view text, Point2 middle, const TextPlace& look);

}  // namespace straightedge::cli
