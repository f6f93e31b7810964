// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT

// Sizes whose numbers of pixels or cells do not fit in 32 bits must not look small on a machine of 32 bits.
#include <array>
#include <cstdint>

#include "straightedge/canny.hpp"
#include "straightedge/canny_fused.hpp"
#include "straightedge/canny_rows.hpp"
#include "straightedge/frame_planes.hpp"
#include "straightedge/hough_lines.hpp"
#include "straightedge/hough_plane_patches.hpp"
#include "straightedge/octree.hpp"
#include "straightedge/ransac_search.hpp"
#include "support/catch.hpp"

using namespace straightedge;

namespace {

std::array<std::byte, 4096> workspace;

/// Pictures of 0, 1 and 65536 pixels modulo 2^32, and the largest that the algorithms' own limits let pass.
constexpr Size large[] = {{65536, 65536}, {2147483647, 2147483647}, {65536, 65537},
                          {32768, 32768}, {32767, 32767},           {46340, 46340}};

}  // namespace

TEST_CASE("pictures of more pixels than a workspace can be for are refused") {
  for (const Size size : large) {
    INFO(size.width << " x " << size.height);
    Canny canny;
    CHECK(Canny::prepare(canny, size, {}, workspace) != Status::ok);
    FusedCanny fused;
    CHECK(FusedCanny::prepare(fused, size, {}, workspace) != Status::ok);
    CannyRows rows;
    CHECK(CannyRows::prepare(rows, size, {}, workspace) != Status::ok);
    FramePlanes frame;
    CHECK(frame.prepare(size, {}, workspace) != Status::ok);
    RansacSearch search;
    CHECK(RansacSearch::prepare(search, size, {}, workspace) != Status::ok);
    HoughPatchSearch patches;
    CHECK(HoughPatchSearch::prepare(patches, size, {}, workspace) != Status::ok);
    for (const HoughMethod method :
         {HoughMethod::standard, HoughMethod::progressive, HoughMethod::randomized}) {
      HoughLines lines;
      HoughOptions options;
      options.method = method;
      CHECK(HoughLines::prepare(lines, size, options, workspace) != Status::ok);
    }
  }
}

TEST_CASE("accumulators of more than 2^28 cells are refused") {
  for (const HoughCells kind : {HoughCells::array, HoughCells::ball}) {
    for (std::int32_t rows = 4; rows <= 1024; rows += 12) {
      const std::int64_t directions = HoughDirections::cell_count(kind, rows);
      for (const std::int32_t distances : {1, 100, 4097, 8193, 32769, 65536}) {
        const std::int64_t cells = directions * distances;
        INFO(rows << " rows, " << distances << " distances");
        CHECK(HoughAccumulator::cell_count({kind, rows, distances}) ==
              static_cast<std::size_t>(cells > (1 << 28) ? 0 : cells));
      }
    }
  }
}

TEST_CASE("octrees of more points than memory can hold are refused") {
  for (const std::uint32_t capacity : {std::uint32_t{1} << 28U, std::uint32_t{1} << 30U, UINT32_MAX}) {
    Octree octree;
    CHECK(Octree::prepare(octree, capacity, {}, workspace) != Status::ok);
  }
}
