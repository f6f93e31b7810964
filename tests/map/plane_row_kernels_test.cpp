// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <cstring>
#include <vector>

#include "map/plane_row.hpp"
#include "map/plane_runs.hpp"
#include "straightedge/host/kernels.hpp"
#include "straightedge/random.hpp"
#include "support/catch.hpp"

namespace {

using namespace straightedge;

/// A row of pixels on random planes, seen by a random camera. Some of it is nonsense.
struct Row {
  std::vector<std::uint16_t> raw, labels;
  std::vector<PixelPlane> planes;
  PlaneRowPart part;

  Row(Pcg32& random, std::int32_t width) : planes(4) {
    for (PixelPlane& plane : planes) fill(plane, random);
    std::uint16_t label = 0;
    for (std::int32_t n = 0; n < width; ++n) {
      if (random.below(9) == 0) label = static_cast<std::uint16_t>(random.below(5));
      labels.push_back(label);
      const std::uint32_t kind = random.below(12);
      raw.push_back(static_cast<std::uint16_t>(kind == 0 ? 0 : kind == 1 ? 65535 : 800 + random.below(3000)));
    }
    part.raw = raw.data();
    part.labels = labels.data();
    part.planes = planes.data();
    part.first = static_cast<std::int32_t>(random.below(600));
    part.count = part.to_row_end = width;
    part.metres_per_unit = 0.001;
    for (int axis = 0; axis < 3; ++axis) {
      part.ray[axis] = axis == 2 ? 1 : between(random, -0.5, 0.5);
      part.along_u[axis] = between(random, -8, 8);
      part.row[axis] = between(random, -4000, 4000);
      part.origin[axis] = random.below(8) == 0 ? 1e3 : between(random, 2.6e8, 2.8e8);
    }
  }

  static double between(Pcg32& random, double low, double high) {
    return low + (high - low) * random.below(1U << 20U) / (1U << 20U);
  }
  static void fill(PixelPlane& plane, Pcg32& random) {
    for (double& n : plane.normal) n = between(random, -1, 1);
    plane.normal[2] = 1;
    const double distance = random.below(6) == 0 ? 1e-9 : between(random, 0.1, 5);
    plane.by_distance = 1 / (distance > 1e-6 ? distance : 1e-6);
    plane.by_u = between(random, -0.001, 0.001) * plane.by_distance;
    plane.distance = distance * 4096;
    plane.far_off = static_cast<std::int32_t>(plane.distance / 2);
  }
};

struct Outcome {
  std::uint16_t largest = 0;
  LeftOut out;
  std::vector<detail::PlaneRun> runs;
};

/// Two rows' worth, so that runs go on.
Outcome outcome_of(const Row& row, const PlaneRowKernels& kernels) {
  Outcome outcome;
  std::vector<detail::PlaneRun> memory;
  std::vector<std::uint32_t> slots;
  PlaneRuns runs(memory, slots);
  PlaneRowPlaces places;
  outcome.largest = kernels.largest_label(row.labels.data(), row.part.count);
  for (int time = 0; time < 2; ++time)
    kernels.add(row.part, places, runs.with_room_for(row.labels.size()), outcome.out);
  outcome.runs.assign(runs.all().begin(), runs.all().end());
  return outcome;
}

bool same(const Outcome& a, const Outcome& b) {
  return a.largest == b.largest && a.out.off_plane == b.out.off_plane &&
         a.out.out_of_range == b.out.out_of_range && a.runs.size() == b.runs.size() &&
         (a.runs.empty() ||
          std::memcmp(a.runs.data(), b.runs.data(), a.runs.size() * sizeof(detail::PlaneRun)) == 0);
}

}  // namespace

TEST_CASE("every set of kernels registers rows alike", "[plane_row]") {
  Pcg32 random(20261122, 5);
  std::uint64_t off_plane = 0, out_of_range = 0, placed = 0;
  for (std::int32_t round = 0; round < 600; ++round) {
    const std::int32_t width = round < 200 ? round + 1 : round % 100 == 0 ? PlaneRowPart::most : 640;
    const Row row(random, width);
    const Outcome expected = outcome_of(row, plain_plane_row_kernels);
    off_plane += expected.out.off_plane;
    out_of_range += expected.out.out_of_range;
    for (const detail::PlaneRun& run : expected.runs) placed += static_cast<std::uint64_t>(run.readings);
    for (const KernelSet& set : kernel_sets()) {
      INFO(set.name << ", width " << width << ", round " << round);
      CHECK(same(outcome_of(row, *set.plane_rows), expected));
    }
  }
  CHECK(off_plane > 1000);
  CHECK(out_of_range > 1000);
  CHECK(placed > 50000);
}

TEST_CASE("every pixel goes somewhere, once", "[plane_row]") {
  Pcg32 random(7, 5);
  for (std::int32_t round = 0; round < 100; ++round) {
    const Row row(random, 1 + round * 3);
    const Outcome outcome = outcome_of(row, *best_kernels().plane_rows);
    std::uint64_t readings = outcome.out.off_plane + outcome.out.out_of_range, labelled = 0;
    for (const detail::PlaneRun& run : outcome.runs) readings += static_cast<std::uint64_t>(run.readings);
    std::uint64_t empty = 0;
    for (std::size_t n = 0; n < row.labels.size(); ++n) {
      labelled += row.labels[n] != 0 ? 2 : 0;
      empty += row.labels[n] != 0 && row.raw[n] == 0 ? 2 : 0;
    }
    CHECK(readings <= labelled);
    CHECK(readings + empty >= labelled);
  }
}

TEST_CASE("a full run is followed by another one of the same leaf", "[plane_row]") {
  std::vector<detail::PlaneRun> memory;
  std::vector<std::uint32_t> slots;
  PlaneRuns runs(memory, slots);
  PixelPlane plane;
  plane.normal[2] = 1;
  plane.by_distance = 0.5;
  plane.distance = 8192;
  plane.far_off = 4096;
  const std::vector<std::uint16_t> raw(640, 2001), labels(640, 1);
  PlaneRowPart part;
  part.raw = raw.data();
  part.labels = labels.data();
  part.planes = &plane;
  part.count = part.to_row_end = 640;
  part.metres_per_unit = 0.001;
  part.ray[2] = 1;
  for (double& o : part.origin) o = 268435456.0 + 10;
  PlaneRowPlaces places;
  LeftOut out;
  for (int y = 0; y < 120; ++y) best_kernels().plane_rows->add(part, places, runs.with_room_for(640), out);
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
    CHECK(run.residual == run.readings * 16);
  }
  CHECK(readings() == 640 * 120);
  CHECK(runs.with_room_for(100000).used == 3);  // grown, and still found
  best_kernels().plane_rows->add(part, places, runs.with_room_for(640), out);
  CHECK(runs.all().size() == 3);
  CHECK(readings() == 640 * 121);
}
