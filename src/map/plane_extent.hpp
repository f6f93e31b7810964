// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <span>
#include <vector>

namespace straightedge {

/// A place on a plane, metres along its two axes.
struct PlanePoint {
  double a = 0, b = 0;

  constexpr bool operator==(const PlanePoint&) const noexcept = default;
};

/// |a − lean · b| <= half, counted from the middle of the piece.
struct ExtentStrip {
  double lean = 0, half = 0;
};

/// A rectangle of a plane in which there are readings; if oblique, only where both strips are.
struct ExtentPiece {
  double a0 = 0, a1 = 0, b0 = 0, b1 = 0;
  bool oblique = false;
  std::array<ExtentStrip, 2> strips{};
};

/// A closed border: outer ones run counter-clockwise, holes clockwise.
struct ExtentLoop {
  std::vector<PlanePoint> points;
  double area = 0;  ///< m²; negative: a hole
};

struct ExtentOptions {
  double cell = 1.0 / 64;  ///< metres, above 0
  double max_gap = 0.15;   ///< metres, 0..10
  double max_hole = 0.1;   ///< m²
  double min_area = 0.01;  ///< m²
};

/// Borders of what the pieces cover.
///
/// 1. Pieces that are far from one another are treated apart, each lot on a grid of its own: memory goes with
///    what is covered, not with how far apart the parts of a plane lie. A lot too large for 2^24 cells
///    gets larger ones.
/// 2. The pieces are painted.
/// 3. Closing: grown by max_gap/2 and shrunk again, with a square, which leaves corners as they are.
/// 4. Holes below max_hole are filled; islands below min_area go, unless nothing else is left of the plane.
/// 5. Borders are followed along the cells' sides.
/// 6. Douglas, Peucker: points that lie within 2.5 cells of the line between others are left out. D. H.
///    Douglas, T. K. Peucker, "Algorithms for the reduction of the number of points required to represent a
///    digitized line or its caricature", Cartographica 10(2), 1973, doi:10.3138/FM57-6770-U75U-7727.
///
/// Largest border first, holes last, largest at the end. Pieces that are not finite or empty are passed over.
std::vector<ExtentLoop> extent_loops(std::span<const ExtentPiece> pieces, const ExtentOptions& options);

/// The borders of several things together, each given by its borders: painted on one grid by rows (a cell is
/// covered when its middle is inside), then steps 3 to 6.
std::vector<ExtentLoop> united_loops(std::span<const std::vector<ExtentLoop>> things,
                                     const ExtentOptions& options);

double signed_area(std::span<const PlanePoint> loop);

}  // namespace straightedge
