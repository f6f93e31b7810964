// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

#include "straightedge/host/image.hpp"

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

/// Labels for axes and marks: digits and the few letters that those need, in dots. What has no letter is left
/// blank; what lies outside of the picture is cut.
void draw_text(ImageView<Rgb> image, std::string_view text, const TextPlace& place);

}  // namespace straightedge::cli
