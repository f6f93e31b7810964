// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstring>
#include <vector>

#include "map/plane_row.hpp"
#include "map/plane_runs.hpp"
#include "straightedge/host/kernels.hpp"
#include "straightedge/random.hpp"
#include "support/catch.hpp"

namespace {

using namespace straightedge;

double between(Pcg32& random, double low, double high) {
  return low + (high - low) * random.below(1U << 20U) / (1U << 20U);
}

/// Four rows of pixels on random planes, seen by a random camera. Some of it is nonsense.
struct Pixels {
  std::vector<std::uint16_t> raw[PlaneRow::side], labels[PlaneRow::side];
  std::vector<PixelPlane> planes;
  PlaneRow row;

  Pixels(Pcg32& random, std::int32_t width) : planes(4) {
    for (PixelPlane& plane : planes) fill(plane, random);
    row.columns = (width + PlaneRow::at_once - 1) / PlaneRow::at_once * PlaneRow::at_once;
    for (std::int32_t y = 0; y < PlaneRow::side; ++y) {
      std::uint16_t label = 0;
      for (std::int32_t x = 0; x < row.columns; ++x) {
        if (random.below(9) == 0) label = static_cast<std::uint16_t>(random.below(5));
        labels[y].push_back(x < width ? label : std::uint16_t{0});
        const std::uint32_t kind = random.below(12);
        const std::uint32_t any = kind == 0 ? 0 : kind == 1 ? 65535 : 800 + random.below(3000);
        raw[y].push_back(static_cast<std::uint16_t>(any));
      }
      row.raw[y] = row.next[y] = raw[y].data();
      row.labels[y] = row.next[PlaneRow::side + y] = labels[y].data();
    }
    row.planes = planes.data();
    row.plane_count = 4;
    row.u = static_cast<std::int32_t>(random.below(600));
    row.v = static_cast<std::int32_t>(random.below(600));
    row.metres_per_unit = 0.001;
    for (int axis = 0; axis < 3; ++axis) {
      row.grid.along_u[axis] = between(random, -4, 4);
      row.grid.along_v[axis] = between(random, -4, 4);
      row.grid.corner[axis] = between(random, -2000, 2000);
      row.grid.origin[axis] = random.below(8) == 0 ? 1e3 : between(random, 2.6e8, 2.8e8);
    }
  }

  static void fill(PixelPlane& plane, Pcg32& random) {
    const double distance = random.below(6) == 0 ? 1e-9 : between(random, 0.1, 5);
    const double by_distance = 1 / (distance > 1e-6 ? distance : 1e-6);
    plane.by_u = between(random, -0.001, 0.001) * by_distance;
    plane.by_v = between(random, -0.001, 0.001) * by_distance;
    plane.constant = between(random, 0.5, 1.5) * by_distance;
    plane.distance = distance * 2048;
    plane.far_off = static_cast<std::int32_t>(plane.distance / 2);
  }
  bool is_near(std::int32_t x, std::int32_t y) const {
    if (labels[y][static_cast<std::size_t>(x)] == 0) return false;
    const PixelPlane& p = planes[labels[y][static_cast<std::size_t>(x)] - 1U];
    const double inverse = p.by_u * (row.u + x) + p.by_v * (row.v + y) + p.constant;
    const double beyond = (raw[y][static_cast<std::size_t>(x)] * 0.001 * inverse - 1) * p.distance;
    return beyond <= p.far_off && beyond >= -p.far_off;
  }
};

struct Outcome {
  PlaneRowCounts counts;
  std::vector<detail::PlaneRun> runs;
};

/// The row twice, so that runs go on.
Outcome outcome_of(const Pixels& pixels, const PlaneRowKernels& kernels, int times = 2) {
  Outcome outcome;
  std::vector<detail::PlaneRun> memory;
  std::vector<std::uint32_t> slots;
  PlaneRuns runs(memory, slots);
  PlaneColumns columns;
  for (int time = 0; time < times; ++time)
    kernels.add(pixels.row, columns, runs.with_room_for(PlaneRow::most_runs), outcome.counts);
  outcome.runs.assign(runs.all().begin(), runs.all().end());
  return outcome;
}

bool same(const Outcome& a, const Outcome& b) {
  return a.counts.labelled == b.counts.labelled && a.counts.near_plane == b.counts.near_plane &&
         a.counts.out_of_range == b.counts.out_of_range && a.counts.largest_label == b.counts.largest_label &&
         a.runs.size() == b.runs.size() &&
         (a.runs.empty() ||
          std::memcmp(a.runs.data(), b.runs.data(), a.runs.size() * sizeof(detail::PlaneRun)) == 0);
}

std::uint64_t readings_in(const Outcome& outcome) {
  std::uint64_t readings = 0;
  for (const detail::PlaneRun& run : outcome.runs) readings += static_cast<std::uint64_t>(run.readings);
  return readings;
}

/// The sum of all readings' places along the grid's first axis, quanta.
double sum_of(const Outcome& outcome) {
  double sum = 0;
  for (const detail::PlaneRun& run : outcome.runs) {
    const double centre = static_cast<double>(run.leaf & 0x1FFFFFU) * 256 + 128;
    sum += run.readings * centre + run.sum[detail::PlaneRun::x];
  }
  return sum;
}

}  // namespace

TEST_CASE("every set of kernels registers rows alike", "[plane_row]") {
  Pcg32 random(20261122, 5);
  std::uint64_t off_plane = 0, out_of_range = 0, placed = 0;
  for (std::int32_t round = 0; round < 500; ++round) {
    const std::int32_t width = round < 200 ? round + 1 : round % 2 == 0 ? PlaneRow::most_columns : 400;
    const Pixels pixels(random, width);
    const Outcome expected = outcome_of(pixels, plain_plane_row_kernels);
    off_plane += expected.counts.labelled - expected.counts.near_plane;
    out_of_range += expected.counts.out_of_range;
    placed += readings_in(expected);
    for (const KernelSet& set : kernel_sets()) {
      INFO(set.name << ", width " << width << ", round " << round);
      CHECK(same(outcome_of(pixels, *set.plane_rows), expected));
    }
  }
  CHECK(off_plane > 1000);
  CHECK(out_of_range > 1000);
  CHECK(placed > 50000);
}

TEST_CASE("every reading goes somewhere, once", "[plane_row]") {
  Pcg32 random(7, 5);
  for (std::int32_t round = 0; round < 100; ++round) {
    CAPTURE(round);
    const Pixels pixels(random, 1 + round * 3);
    const Outcome outcome = outcome_of(pixels, *best_kernels().plane_rows, 1);
    std::uint64_t labelled = 0, near = 0, borderline = 0;
    for (std::int32_t y = 0; y < PlaneRow::side; ++y) {
      for (std::int32_t x = 0; x < pixels.row.columns; ++x) {
        const auto at = static_cast<std::size_t>(x);
        labelled += pixels.labels[y][at] != 0 && pixels.raw[y][at] != 0 ? 1 : 0;
        near += pixels.is_near(x, y) ? 1 : 0;
        const auto label = pixels.labels[y][at];
        borderline += label != 0 && pixels.planes[label - 1U].distance < 1e-3 ? 1 : 0;
      }
    }
    CHECK(outcome.counts.labelled == labelled);
    CHECK(outcome.counts.near_plane <= near + borderline);
    CHECK(outcome.counts.near_plane + borderline >= near);
    CHECK(readings_in(outcome) + outcome.counts.out_of_range == outcome.counts.near_plane);
  }
}

TEST_CASE("readings lie where their pixels see the plane", "[plane_row]") {
  // One by one instead of in bundles: sums of places differ by what a plane bends in four pixels.
  Pcg32 random(11, 5);
  for (std::int32_t round = 0; round < 100; ++round) {
    CAPTURE(round);
    Pixels pixels(random, 320);
    const double distance = 1 + 0.03 * round;
    for (PixelPlane& plane : pixels.planes) {
      plane = {between(random, -2e-4, 2e-4) / distance, between(random, -2e-4, 2e-4) / distance, 1 / distance,
               distance * 2048, static_cast<std::int32_t>(distance * 1024)};
    }
    for (double& origin : pixels.row.grid.origin) origin = 268435456.0;
    double sum = 0;
    std::uint64_t near = 0;
    for (std::int32_t y = 0; y < PlaneRow::side; ++y) {
      for (std::int32_t x = 0; x < pixels.row.columns; ++x) {
        if (!pixels.is_near(x, y)) continue;
        const PlaneRow& row = pixels.row;
        const PixelPlane& p = pixels.planes[pixels.labels[y][static_cast<std::size_t>(x)] - 1U];
        const double u = row.u + x, v = row.v + y;
        sum += (u * row.grid.along_u[0] + v * row.grid.along_v[0] + row.grid.corner[0]) /
                   (p.by_u * u + p.by_v * v + p.constant) +
               row.grid.origin[0] - 0.5;
        ++near;
      }
    }
    const Outcome outcome = outcome_of(pixels, *best_kernels().plane_rows, 1);
    REQUIRE(near > 100);
    REQUIRE(readings_in(outcome) == near);
    CHECK(std::abs(sum_of(outcome) - sum) / static_cast<double>(near) < 0.1);
  }
}

TEST_CASE("a row with a label that has no plane is passed over, and said", "[plane_row]") {
  Pcg32 random(5, 5);
  Pixels pixels(random, 64);
  pixels.labels[2][40] = 5;
  for (const KernelSet& set : kernel_sets()) {
    const Outcome outcome = outcome_of(pixels, *set.plane_rows);
    CHECK(outcome.counts.largest_label == 5);
    CHECK(outcome.runs.empty());
  }
  pixels.labels[2][40] = 65535;
  CHECK(outcome_of(pixels, plain_plane_row_kernels).counts.largest_label == 65535);
}

TEST_CASE("a full run is followed by another one of the same leaf", "[plane_row]") {
  std::vector<detail::PlaneRun> memory;
  std::vector<std::uint32_t> slots;
  PlaneRuns runs(memory, slots);
  const PixelPlane plane{0, 0, 0.5, 4096, 2048};
  const std::vector<std::uint16_t> raw(640, 2001), labels(640, 1);
  PlaneRow row;
  std::fill_n(row.raw, PlaneRow::side, raw.data());
  std::fill_n(row.labels, PlaneRow::side, labels.data());
  std::fill_n(row.next, 2 * PlaneRow::side, labels.data());
  row.columns = 640;
  row.metres_per_unit = 0.001;
  row.planes = &plane;
  row.plane_count = 1;
  for (double& o : row.grid.origin) o = 268435456.0 + 10;
  PlaneRowCounts counts;
  PlaneColumns columns;
  const auto& kernels = *best_kernels().plane_rows;
  for (int y = 0; y < 30; ++y) kernels.add(row, columns, runs.with_room_for(PlaneRow::most_runs), counts);
  REQUIRE(runs.all().size() == 3);
  const auto readings = [&runs] {
    std::int32_t all = 0;
    for (const detail::PlaneRun& run : runs.all()) all += run.readings;
    return all;
  };
  for (const detail::PlaneRun& run : runs.all()) {
    CHECK(run.readings <= detail::PlaneRun::most_readings);
    CHECK(run.leaf == runs.all()[0].leaf);
    CHECK(run.sum[detail::PlaneRun::xx] == run.readings * 118 * 118);
    CHECK(run.residual == run.readings / 16 * 67);  // of 16 readings that miss by 2.048 quanta, whole
  }
  CHECK(readings() == 640 * 4 * 30);
  CHECK(runs.with_room_for(100000).used == 3);  // grown, and still found
  kernels.add(row, columns, runs.with_room_for(PlaneRow::most_runs), counts);
  CHECK(runs.all().size() == 3);
  CHECK(readings() == 640 * 4 * 31);
}
