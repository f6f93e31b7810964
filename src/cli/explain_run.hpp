// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "map/picture.hpp"
#include "straightedge/canny.hpp"
#include "straightedge/host/line_map_builder.hpp"
#include "straightedge/hough_lines.hpp"

namespace straightedge::cli {

/// What every stage left behind.
struct ExplainRun {
  Picture picture;

  std::vector<std::uint16_t> taps;  ///< of the Gaussian
  std::unique_ptr<std::byte[]> canny_memory;
  Canny canny;
  CannyResult canny_result;
  MagnitudeThresholds limits;  ///< the thresholds in the magnitude's own units
  Image<std::uint8_t> edges;
  Image<std::uint8_t> crests;  ///< what suppression alone keeps, without thresholds
  std::uint32_t crest_count = 0;
  std::uint32_t weak_count = 0;  ///< after suppression, before hysteresis

  std::unique_ptr<std::byte[]> votes_memory;
  HoughLines votes;              ///< every edge pixel voting for every angle, whatever the method
  std::vector<HoughPeak> peaks;  ///< the highest of them that are lines of their own

  std::vector<HoughSegment> segments;  ///< by the method asked for, as it found them
  HoughResult hough;

  LineMapResult lines;
};

/// How many peaks are shown.
inline constexpr std::size_t shown_peaks = 10;

/// Runs all stages. Fails as build_line_map does, and with `bad_option` without `hough`.
Result<ExplainRun> run_stages(GrayView gray, const LineMapOptions& options);

}  // namespace straightedge::cli
