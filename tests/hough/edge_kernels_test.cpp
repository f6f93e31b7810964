// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "hough_testing.hpp"
#include "kernel_tables.hpp"
#include "straightedge/pixel_states.hpp"

using namespace straightedge;
using test::EdgeImage;

namespace {

/// Rows of all widths, from bare to full.
std::vector<EdgeImage> rows_of_edges() {
  std::vector<EdgeImage> rows;
  for (std::int32_t width = 1; width <= 600; width += width < 200 ? 1 : 57) {
    for (const double share : {0.0, 0.01, 0.1, 0.5, 1.0})
      rows.push_back(test::noise({width, 1}, share, static_cast<std::uint64_t>(width)));
    EdgeImage faint({width, 1});  // any value but 0 is an edge
    for (std::int32_t x = 0; x < width; ++x) faint.at(x, 0) = static_cast<std::uint8_t>(1 << (x % 8));
    faint.at(width / 2, 0) = 0;
    rows.push_back(faint);
  }
  return rows;
}

std::vector<std::uint16_t> columns_of(const EdgeImage& row) {
  std::vector<std::uint16_t> columns;
  for (std::int32_t x = 0; x < row.width(); ++x)
    if (row.at(x, 0) != 0) columns.push_back(static_cast<std::uint16_t>(x));
  return columns;
}

std::vector<std::uint8_t> states_of(const EdgeImage& row) {
  std::vector<std::uint8_t> bytes(PixelStates::row_bytes(row.width()));
  const PixelStates states(bytes.data(), row.width());
  for (const std::uint16_t x : columns_of(row)) states.set(x, 0, PixelState::waiting);
  return bytes;
}

}  // namespace

TEST_CASE("every table of kernels lists the edge pixels of a row") {
  for (const HoughKernels* kernels : test::kernel_tables()) {
    for (const EdgeImage& row : rows_of_edges()) {
      std::vector<std::uint16_t> columns(static_cast<std::size_t>(row.width()) + 8);
      const std::int32_t count = kernels->edge_columns(row.view().row(0), row.width(), columns.data());
      columns.resize(static_cast<std::size_t>(count));
      REQUIRE(columns == columns_of(row));
    }
  }
}

TEST_CASE("every table of kernels marks the edge pixels of a row and finds the marks") {
  for (const HoughKernels* kernels : test::kernel_tables()) {
    for (const EdgeImage& row : rows_of_edges()) {
      const std::size_t bytes = PixelStates::row_bytes(row.width());
      constexpr std::uint8_t untouched = 0xA5;
      std::vector<std::uint8_t> states(bytes + 1, untouched);
      kernels->mark_edges(row.view().row(0), row.width(), states.data());
      REQUIRE(states.back() == untouched);
      states.resize(bytes);
      REQUIRE(states == states_of(row));
      std::vector<std::uint16_t> columns(static_cast<std::size_t>(row.width()) + 8);
      const std::int32_t count = kernels->marked_columns(states.data(), row.width(), columns.data());
      columns.resize(static_cast<std::size_t>(count));
      REQUIRE(columns == columns_of(row));
    }
  }
}
