// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "straightedge/host/image.hpp"
#include "straightedge/hough_options.hpp"

namespace straightedge::test {

struct GoldenImage {
  std::string name;
  Image<std::uint8_t> edges;
};

struct GoldenLines {
  std::size_t image = 0;
  HoughOptions options;
  std::vector<HoughPeak> peaks;        ///< standard
  std::vector<HoughSegment> segments;  ///< progressive; end points alone
};

struct GoldenHough {
  bool good = false;  ///< the whole file was read
  std::vector<GoldenImage> images;
  std::vector<GoldenLines> cases;
};

/// fixtures/golden/hough/hough.golden; its SOURCE.md describes the layout.
GoldenHough read_golden_hough(const char* file);

}  // namespace straightedge::test
