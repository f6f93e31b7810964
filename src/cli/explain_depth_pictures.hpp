// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include "cli/explain_depth_run.hpp"
#include "straightedge/host/image.hpp"

namespace straightedge::cli {

/// What one reading in a hundred is nearer or farther than, metres; both 0 without readings.
struct DepthRange {
  double nearest = 0, farthest = 0;
};
DepthRange depth_range(const ExplainDepthRun& run);

/// From near (yellow) by green and blue to far (violet), 0 to 1.
Rgb depth_colour(double share);
/// Blue by white to red; 0 to 1, white in the middle.
Rgb signed_colour(double share);

/// No reading, in every picture.
inline constexpr Rgb hole_colour{0x16, 0x17, 0x1A};
/// A reading that no plane has.
inline constexpr Rgb free_colour_of_readings{0x6E, 0x73, 0x7A};

// Small frames are enlarged by zoom_of; a scale of colours is below the picture.

Image<Rgb> show_depth(const ExplainDepthRun& run, const DepthRange& range);
Image<Rgb> show_inverse_depth(const ExplainDepthRun& run, const DepthRange& range);

/// How well the readings of each cell lie on the cell's own best plane: root of the mean square residual in
/// units of the noise. Flat: below flat_cell.
inline constexpr double flat_cell = 1.4142135623730951;
struct FlatCells {
  Image<Rgb> picture;
  std::uint32_t cells = 0;  ///< with readings on a fifth of their pixels at least
  std::uint32_t flat = 0;
};
FlatCells show_flat_cells(const ExplainDepthRun& run, int level);

/// The nearest candidate of each pixel, in colours of the candidates' numbers; the strongest are numbered.
inline constexpr std::size_t numbered_candidates = 12;
Image<Rgb> show_candidates(const ExplainDepthRun& run);

struct LabelledCells {
  Image<Rgb> picture;
  std::uint32_t labelled = 0;
};
/// Labels of the cells after the last assignment, in the colours of the planes that they became.
LabelledCells show_cell_labels(const ExplainDepthRun& run, int level);

/// The colours of label_picture.hpp with the planes' numbers.
Image<Rgb> show_labels(const ExplainDepthRun& run);

struct Residuals {
  Image<Rgb> picture;
  double rms = 0;     ///< of all labelled readings, sigma
  double within = 0;  ///< share within one sigma
};
/// Inverse depth minus that of the reading's plane over the noise: red is nearer than the plane.
Residuals show_residuals(const ExplainDepthRun& run);

/// Draws the numbers of the first labels, at most so many, where their pixels are.
void draw_numbers(Image<Rgb>& picture, ImageView<const std::uint16_t> labels, int zoom, std::size_t most);

}  // namespace straightedge::cli
