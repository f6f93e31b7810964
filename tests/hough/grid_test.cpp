// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <array>

#include "hough/compact_rows.hpp"
#include "hough_testing.hpp"

using namespace straightedge;

TEST_CASE("numbers of angles and distances") {
  HoughOptions options;
  const HoughGrid usual = hough_grid({640, 480}, options);
  CHECK(usual.angles == 180);
  CHECK(usual.distances == 2241);
  options.rho_step = 2;
  options.theta_step = 0.013;
  CHECK(hough_grid({640, 480}, options).distances == 1120);  // 1120.5, halves to even
  CHECK(hough_grid({640, 480}, options).angles == 242);
  options.method = HoughMethod::standard;
  options.min_theta = 0.5;
  options.max_theta = 1.5;
  CHECK(hough_grid({640, 480}, options).angles == 77);
  CHECK(hough_grid({640, 480}, options).half_turn == 242);
  options.method = HoughMethod::randomized;
  CHECK(hough_grid({640, 480}, options).angles == 242);
  CHECK(hough_grid({640, 480}, options).distances % 2 == 1);
  static_assert(hough_grid({100, 100}, {}).status == Status::ok);
}

TEST_CASE("every pixel at every angle falls into a cell or a guard cell") {
  Pcg32 random(20);
  for (int round = 0; round < 3000; ++round) {
    const int longest = round % 10 == 0 ? 32767 : 60;
    const auto side = [&] { return 1 + static_cast<int>(random.below(static_cast<std::uint32_t>(longest))); };
    const Size size{round % 3 == 0 ? 1 : side(), round % 3 == 1 ? 1 : side()};
    HoughOptions options;
    options.rho_step = 0.05 + random.below(1'000'000) * (longest > 60 ? 3e-5 : 1e-4);
    options.theta_step = 0.0174532925 * (1 + round % 7);
    const HoughGrid grid = hough_grid(size, options);
    REQUIRE(grid.status == Status::ok);
    std::vector<float> cosines(static_cast<std::size_t>(grid.angles));
    std::vector<float> sines(cosines.size());
    std::vector<std::uint32_t> offsets(cosines.size());
    HoughJob job;
    job.edges = {nullptr, size};
    job.options = options;
    job.grid = grid;
    job.memory.cosines = cosines;
    job.memory.sines = sines;
    job.memory.offsets = offsets;
    hough::fill_angles_by_multiplying(job);
    hough::lay_out_rows(job);
    INFO(size.width << "x" << size.height << " rho_step " << options.rho_step);
    const auto right = static_cast<float>(size.width - 1);
    const auto bottom = static_cast<float>(size.height - 1);
    const std::array<std::array<float, 2>, 4> corners{{{0, 0}, {right, 0}, {0, bottom}, {right, bottom}}};
    std::size_t next = 0;
    for (std::size_t n = 0; n < cosines.size(); ++n) {
      const hough::Reach reach = hough::reach(size, cosines[n], sines[n]);
      // Rows follow one another without gaps.
      REQUIRE(hough::cell_index(offsets[n], reach.first) == next);
      next = hough::cell_index(offsets[n], reach.last) + 1;
      for (const auto& corner : corners) {
        const std::int32_t cell =
            hough::distance_cell(job.memory, n, corner[0], corner[1]) + (grid.distances - 1) / 2;
        REQUIRE(cell >= -hough_guard);
        REQUIRE(cell < grid.distances + hough_guard);
        const std::size_t index = hough::cell_index(job.memory, n, corner[0], corner[1]);
        REQUIRE(index >= hough::cell_index(offsets[n], reach.first));
        REQUIRE(index < next);
      }
    }
    REQUIRE(next <= hough_row_cells(size, grid));
  }
}
