// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "straightedge/host/image.hpp"

namespace straightedge::cli {

/// A number on a scale and its place, 0 (left) to 1.
struct Tick {
  double place = 0;
  std::string text;
};

/// Round numbers (1, 2 or 5 times a power of ten) between low and high, about `wanted` of them.
std::vector<Tick> ticks_between(double low, double high, int wanted = 6);

struct Legend {
  std::function<Rgb(double place)> colour;  ///< of a place from 0 to 1
  std::vector<Tick> ticks;
  std::string unit;  ///< in small letters, see explain_text.hpp
};

/// The picture with a bar of colours and its numbers below; narrow pictures get white space at their right.
Image<Rgb> with_legend(const Image<Rgb>& picture, const Legend& legend);

}  // namespace straightedge::cli
