// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include "cli/explain_run.hpp"
#include "straightedge/host/image.hpp"

namespace straightedge::cli {

/// How numbers become brightness and size, for the whole page.
struct PictureScale {
  int zoom = 1;  ///< a pixel's side in the pictures; small ones are enlarged
  double full_length =
      1;  ///< the gradient that is shown at full brightness, units of the magnitude (L2: its root)
};

/// full_length: what one pixel of a hundred exceeds, but at least the high threshold, so that noise stays
/// dark.
PictureScale scale_of(const ExplainRun& run, GradientNorm norm);

/// Every pixel as a square of `zoom` pixels.
Image<Rgb> enlarged(ImageView<const Rgb> image, int zoom);
/// The pixels as they are, each enlarged to a square.
Image<Rgb> show_gray(GrayView gray, const PictureScale& scale);
/// 0 is middle gray, positive lighter, negative darker.
Image<Rgb> show_signed(ImageView<const std::int16_t> gradient, const PictureScale& scale);
Image<Rgb> show_magnitude(const ExplainRun& run, GradientNorm norm, const PictureScale& scale);
/// Hue: which way is lighter. Brightness: how much.
Image<Rgb> show_direction(const ExplainRun& run, GradientNorm norm, const PictureScale& scale);
/// The hues of all directions, the way they point.
Image<Rgb> direction_wheel();
/// The magnitude where suppression leaves it.
Image<Rgb> show_crests(const ExplainRun& run, GradientNorm norm, const PictureScale& scale);
Image<Rgb> show_classes(const ExplainRun& run, const PictureScale& scale);
/// The highest peaks as lines through the whole picture, numbered.
Image<Rgb> show_peaks(const ExplainRun& run, const PictureScale& scale);
/// The segments as the Hough transform found them, neighbours in the list in different colours.
Image<Rgb> show_segments(const ExplainRun& run, const PictureScale& scale);
/// Faces of walls and axes of thin walls, in the colours of the SVG drawing.
Image<Rgb> show_lines(const ExplainRun& run, const PictureScale& scale);

}  // namespace straightedge::cli
