// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <array>
#include <bit>
#include <cstdint>
#include <string>
#include <vector>

#include "scene.hpp"
#include "straightedge/host/frame_cells.hpp"
#include "straightedge/host/kernels.hpp"
#include "straightedge/ransac_search.hpp"
#include "support/catch.hpp"

using namespace straightedge;

namespace {

constexpr float none = -1e30F;
constexpr std::size_t margin = 2 * search_overrun;

/// Cells in rows, some without a reading, some with numbers as large as readings can be.
struct Cells {
  Cells(std::int32_t columns, std::int32_t rows, Pcg32& random)
      : stride((columns + 15) / 16 * 16 + 16), height(rows) {
    const std::size_t count =
        static_cast<std::size_t>(stride) * static_cast<std::size_t>(rows + 2) + 2 * margin;
    for (std::vector<float>* array : {&u, &v, &q, &w}) array->assign(count, 0);
    q.assign(count, none);
    w.assign(count, 1);
    for (std::int32_t y = 0; y < rows; ++y)
      for (std::int32_t x = 0; x < columns; ++x) fill(place(x, y), x, y, random);
  }
  void fill(std::size_t i, std::int32_t x, std::int32_t y, Pcg32& random) {
    u[i] = static_cast<float>(4 * x) + static_cast<float>(random.below(4));
    v[i] = static_cast<float>(4 * y) + static_cast<float>(random.below(4));
    const std::uint32_t kind = random.below(20);
    const float noise = 0.01F * static_cast<float>(random.below(1000)) / 1000;
    q[i] = kind == 0 ? none : kind == 1 ? 1e6F : kind == 2 ? 1e-30F : 0.001F * u[i] + 0.3F + noise;
    w[i] = kind == 3 ? 1e12F : 1 / 0.004F;
  }
  std::size_t place(std::int32_t x, std::int32_t y) const {
    return margin + static_cast<std::size_t>(y + 1) * static_cast<std::size_t>(stride) +
           static_cast<std::size_t>(x);
  }
  SearchReadings at(std::size_t i) const { return {&u[i], &v[i], &q[i], &w[i]}; }

  std::int32_t stride, height;
  std::vector<float> u, v, q, w;
};

std::uint32_t bits(float x) {
  return std::bit_cast<std::uint32_t>(x);
}

void check_same(const SearchSums& a, const SearchSums& b) {
  CHECK(std::bit_cast<std::array<std::uint32_t, 11>>(a) == std::bit_cast<std::array<std::uint32_t, 11>>(b));
}

bool same_bits(const std::vector<float>& a, const std::vector<float>& b) {
  for (std::size_t i = 0; i < a.size(); ++i)
    if (bits(a[i]) != bits(b[i])) return false;
  return a.size() == b.size();
}

/// Of the squared residuals that are hits.
constexpr float most = 1.5F;

/// What the kernels for cells make of a box: marks, sums and what is left.
struct Made {
  std::vector<std::uint8_t> hit, core;
  SearchMarks marks;
  std::vector<std::uint8_t> columns;
  std::uint32_t readings = 0;
  SearchSums sums;
  std::vector<float> left;
};

Made make(const PlaneSearchKernels& kernels, const Cells& cells, std::int32_t columns,
          const SearchPlane& plane) {
  const std::size_t all = cells.q.size(), first = cells.place(0, 0);
  const SearchBox box{columns, cells.height, cells.stride};
  std::vector<float> rows(5 * (static_cast<std::size_t>(columns) + 16 + search_overrun));
  std::vector<std::uint8_t> counts(rows.size());
  Made m{std::vector<std::uint8_t>(all),
         std::vector<std::uint8_t>(all),
         {},
         std::vector<std::uint8_t>(rows.size()),
         0,
         {},
         cells.q};
  kernels.mark_hits(cells.at(first), box, plane, most, &m.hit[first]);
  m.marks = kernels.keep_dense(&m.hit[first], box, &m.core[first], counts.data(), m.columns.data());
  m.readings = kernels.count_readings(&cells.q[first], box);
  kernels.sum_marked(cells.at(first), &m.core[first], box, plane, 100, 50, rows.data(), m.sums);
  kernels.empty_marked(&m.core[first], box, none, &m.left[first]);
  return m;
}

}  // namespace

TEST_CASE("every set of kernels marks, sums and compares cells as the plain one", "[ransac]") {
  for (const KernelSet& set : kernel_sets()) {
    for (std::int32_t columns = 1; columns <= 200; ++columns) {
      Pcg32 random(static_cast<std::uint64_t>(columns));
      const Cells cells(columns, 1 + static_cast<std::int32_t>(random.below(columns % 50 == 0 ? 600 : 20)),
                        random);
      const SearchPlane plane{0.001F, 0, columns % 7 == 0 ? 9.0F : 0.305F};
      CAPTURE(std::string(set.name), columns, cells.height);
      const Made expected = make(plain_plane_search_kernels, cells, columns, plane);
      const Made made = make(*set.plane_search, cells, columns, plane);
      bool same_marks = true, same_columns = true;
      for (std::int32_t x = 0; x < columns; ++x) {
        same_columns = same_columns && (made.columns[static_cast<std::size_t>(x)] != 0) ==
                                           (expected.columns[static_cast<std::size_t>(x)] != 0);
        for (std::int32_t y = 0; y < cells.height; ++y) {
          const std::size_t i = cells.place(x, y);
          same_marks = same_marks && made.hit[i] == expected.hit[i] && made.core[i] == expected.core[i];
        }
      }
      CHECK(same_marks);
      CHECK(same_columns);
      CHECK(made.marks.cells == expected.marks.cells);
      CHECK(made.marks.first_row == expected.marks.first_row);
      CHECK(made.marks.end_row == expected.marks.end_row);
      CHECK(made.readings == expected.readings);
      check_same(made.sums, expected.sums);
      CHECK(same_bits(made.left, expected.left));
    }
  }
}

TEST_CASE("the plain kernels mark and sum cells as their definitions say", "[ransac]") {
  for (std::int32_t columns = 1; columns <= 70; ++columns) {
    Pcg32 random(static_cast<std::uint64_t>(columns), 1);
    const Cells cells(columns, 1 + static_cast<std::int32_t>(random.below(9)), random);
    const SearchPlane plane{0.001F, 0, 0.305F};
    CAPTURE(columns, cells.height);
    const Made made = make(plain_plane_search_kernels, cells, columns, plane);
    const auto hit = [&](std::int32_t x, std::int32_t y) {
      if (x < 0 || y < 0 || x >= columns || y >= cells.height) return 0;
      const std::size_t i = cells.place(x, y);
      const float e = (cells.q[i] - ((plane.a * cells.u[i] + plane.b * cells.v[i]) + plane.c)) * cells.w[i];
      return e * e < most ? 1 : 0;
    };
    std::uint32_t marked = 0, readings = 0;
    double residuals = 0;
    for (std::int32_t y = 0; y < cells.height; ++y) {
      for (std::int32_t x = 0; x < columns; ++x) {
        const std::size_t i = cells.place(x, y);
        int near = -hit(x, y);
        for (std::int32_t j = -1; j <= 1; ++j)
          for (std::int32_t k = -1; k <= 1; ++k) near += hit(x + j, y + k);
        const bool core = hit(x, y) == 1 && near >= 3;
        CHECK((made.core[i] == 1) == core);
        marked += core ? 1U : 0U;
        readings += cells.q[i] > 0 ? 1U : 0U;
        CHECK(made.left[i] == (core ? none : cells.q[i]));
        if (core)
          residuals += static_cast<double>(cells.q[i]) - 0.001 * static_cast<double>(cells.u[i]) - 0.305;
      }
    }
    CHECK(made.marks.cells == marked);
    CHECK(made.readings == readings);
    CHECK(static_cast<double>(made.sums.n) == marked);
    CHECK(static_cast<double>(made.sums.r) == Approx(residuals).margin(1e-4));
  }
}

TEST_CASE("every set of kernels puts the readings of a row one after another", "[ransac]") {
  constexpr std::size_t room = 2 * search_lanes;
  constexpr float untouched = -7;
  for (const KernelSet& set : kernel_sets()) {
    for (std::int32_t columns = 0; columns <= 50; ++columns) {
      Pcg32 random(static_cast<std::uint64_t>(columns), 3);
      Cells cells(64, 1, random);
      const std::size_t first = cells.place(0, 0);
      for (std::size_t i = first; i < first + 64; ++i) {
        const bool is_none = columns % 5 == 1 || (columns % 5 > 1 && random.below(3) == 0);
        if (is_none) cells.q[i] = random.below(2) == 0 ? 0 : none;
      }
      const auto width = static_cast<std::size_t>(columns);
      std::vector<float> u(width + room, untouched), v = u, q = u, w = u;
      const std::uint32_t count = set.plane_search->gather_row(cells.at(first), columns, 5, 3,
                                                               {u.data(), v.data(), q.data(), w.data()});
      CAPTURE(std::string(set.name), columns);
      std::uint32_t expected = 0;
      bool same = true;
      for (std::size_t i = first; i < first + width; ++i) {
        if (!(cells.q[i] > 0)) continue;
        const std::size_t k = expected++;
        same = same && u[k] == cells.u[i] - 5 && v[k] == cells.v[i] - 3 && q[k] == cells.q[i] &&
               w[k] == cells.w[i];
      }
      CHECK(same);
      REQUIRE(count == expected);
      for (std::size_t k = count + search_lanes; k < u.size(); ++k) same = same && u[k] == untouched;
      CHECK(same);
    }
  }
}

TEST_CASE("every set of kernels scores windows as the plain one", "[ransac]") {
  for (const KernelSet& set : kernel_sets()) {
    for (std::uint32_t count = 3; count <= 200; ++count) {
      Pcg32 random(count, 2);
      Cells cells(208, 1, random);
      const std::size_t first = cells.place(0, 0);
      for (std::size_t i = first + count; i < first + 208; ++i) cells.q[i] = none;
      SearchTriples triples;
      for (int corner = 0; corner < 3; ++corner)
        for (std::int32_t l = 0; l < search_lanes; ++l) {
          const std::size_t i = first + random.below(count);
          triples.u[corner][l] = cells.u[i];
          triples.v[corner][l] = l % 5 == 0 ? 0 : static_cast<float>(random.below(300));
          triples.q[corner][l] = cells.q[i];
        }
      CAPTURE(std::string(set.name), count);
      SearchPlanes expected, planes;
      plain_plane_search_kernels.try_triples(cells.at(first), count, triples, expected);
      set.plane_search->try_triples(cells.at(first), count, triples, planes);
      using Bits = std::array<std::uint32_t, 4 * search_lanes>;
      CHECK(std::bit_cast<Bits>(planes) == std::bit_cast<Bits>(expected));
      const SearchPlane plane{0.001F, 0, 0.305F};
      const SearchInliers a = plain_plane_search_kernels.find_inliers(cells.at(first), 208, plane, 1);
      const SearchInliers b = set.plane_search->find_inliers(cells.at(first), 208, plane, 1);
      CHECK(a.count == b.count);
      CHECK(bits(a.squares) == bits(b.squares));
      SearchSums sums, expected_sums;
      plain_plane_search_kernels.sum_inliers(cells.at(first), 208, plane, 2.25F, expected_sums);
      set.plane_search->sum_inliers(cells.at(first), 208, plane, 2.25F, sums);
      check_same(sums, expected_sums);
    }
  }
}

TEST_CASE("every set of kernels finds the same candidates, and the one asked for runs", "[ransac]") {
  Pcg32 random(21);
  const scene::Frame frame = scene::render(scene::room_by_chance(random), scene::sigma, 0.2, random);
  const auto search = [&](const PlaneSearchKernels* kernels) {
    const RansacSearchOptions options{.kernels = kernels};
    std::vector<std::byte> workspace(RansacSearch::workspace_bytes(scene::size, options));
    RansacSearch object;
    REQUIRE(RansacSearch::prepare(object, scene::size, options, workspace) == Status::ok);
    std::vector<ProposedPlane> candidates(64);
    candidates.resize(object.run(FrameCells(frame.view()).view(), {}, candidates).candidates);
    return candidates;
  };
  const std::vector<ProposedPlane> expected = search(&plain_plane_search_kernels);
  REQUIRE(expected.size() >= 4);
  for (const KernelSet& set : kernel_sets()) {
    CAPTURE(std::string(set.name));
    const std::vector<ProposedPlane> found = search(set.plane_search);
    REQUIRE(found.size() == expected.size());
    for (std::size_t i = 0; i < found.size(); ++i) {
      CHECK(found[i].fit.plane == expected[i].fit.plane);
      CHECK(found[i].fit.covariance == expected[i].fit.covariance);
      CHECK(found[i].score == expected[i].score);
    }
  }
  PlaneSearchKernels blind = plain_plane_search_kernels;
  blind.count_readings = [](const float*, const SearchBox&) noexcept { return 0U; };
  CHECK(search(&blind).empty());
}
