// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include "cli/explain_run.hpp"
#include "straightedge/host/image.hpp"

namespace straightedge::cli {

struct AccumulatorPicture {
  Image<Rgb> picture;
  std::int32_t most_votes = 0;  ///< of one cell, which is white
};

/// The votes of every edge pixel for every angle as a heat map: theta to the right, rho upwards. Brightness
/// is the square root of the votes, so that faint curves are seen beside the peaks; a dot of the picture
/// shows the best of the cells that fall on it. The peaks of the run are ringed and numbered, the best is 1.
AccumulatorPicture show_accumulator(const ExplainRun& run);

}  // namespace straightedge::cli
