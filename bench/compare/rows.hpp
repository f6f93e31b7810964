// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include "straightedge/image.hpp"

namespace compare {

/// Canny with both norms, and blur with Canny, once for each set of kernels.
void print_edge_rows(straightedge::Size size, int rounds);
/// The progressive Hough transform on the photos' edges; the same with a gradient window, and the whole way
/// to a line map, on a floor plan; once for each set of kernels.
void print_line_rows(straightedge::Size size, int rounds);

/// Planes: ours from the depth frame, the peers' from the cloud that they want, made outside the time.
void print_first_plane_rows(int rounds);
void print_all_planes_rows(int rounds);
/// Building an octree of the readings of a frame, and nearest points in it.
void print_octree_rows(int rounds);

/// By the clock, each library with the threads that it takes by itself; and ours beside ours with one.
void print_threaded_edge_rows(straightedge::Size size, int rounds);
void print_threaded_sequence_rows(int rounds);
void print_threaded_plane_rows(int rounds);

}  // namespace compare
