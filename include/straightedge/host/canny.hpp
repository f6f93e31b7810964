// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string_view>

#include "straightedge/canny.hpp"
#include "straightedge/host/image.hpp"
#include "straightedge/host/kernels.hpp"
#include "straightedge/host/parallel.hpp"

namespace straightedge {

struct CannyEdges {
  Image<std::uint8_t> edges;  ///< 255 on edges, 0 elsewhere; empty unless `result.status` is ok
  CannyResult result;
  std::string_view kernels;  ///< the set that did the work
};

/// Canny's edge detector in one line: takes its memory, runs once, gives everything back but the edges. Row
/// by row in little memory (canny_fused.hpp) with the kernels given; automatic thresholds need the stages as
/// whole pictures (canny.hpp), which are plain.
/// `threads`: how many may work at once on stripes of the picture, 0 for one on each processor. The edges are
/// the same for any number.
/// For a stream of images of one size, keep a `FusedCanny` and its workspace instead.
CannyEdges canny(GrayView gray, const CannyOptions& options = {}, const KernelSet& kernels = best_kernels(),
                 unsigned threads = 1);

/// The same with threads that are there already: to start one takes as long as the edges of a small picture.
CannyEdges canny(GrayView gray, const CannyOptions& options, const KernelSet& kernels, ThreadPool& pool);

}  // namespace straightedge
