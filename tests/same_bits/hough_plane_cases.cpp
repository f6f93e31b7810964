// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <array>

#include "cases.hpp"
#include "hash_results.hpp"
#include "inputs.hpp"
#include "memory.hpp"
#include "straightedge/hough_plane_peaks.hpp"
#include "straightedge/hough_planes.hpp"
#include "straightedge/random.hpp"

namespace same_bits {
namespace {

using namespace straightedge;

struct NamedCells {
  HoughCells cells;
  const char* name;
};
constexpr NamedCells kinds[] = {{HoughCells::array, ".array"}, {HoughCells::ball, ".ball"}};

constexpr std::int32_t rows = 18, distances = 40;

Vector3 direction(Pcg32& random) noexcept {
  const auto part = [&] { return static_cast<double>(random.below(2001)) - 1000; };
  const double x = part(), y = part(), z = part();
  return normalized({x, y, z});
}

void direction_row(const Report& report, const HoughDirections& cells, const char* name) noexcept {
  Pcg32 random(61);
  Hash hash, lookups;
  hash.add(cells.cell_size());
  for (const HoughRow& row : cells.rows()) hash.add(row.top, row.bottom, row.first, row.count, row.reach);
  for (std::int32_t i = 0; i < cells.size(); ++i) {
    hash.add(cells.centre(i), cells.antipode(i), cells.area(i));
    cells.for_neighbours(i, [&](std::int32_t neighbour) { hash.add(neighbour); });
  }
  for (int i = 0; i < 200; ++i) {
    const Vector3 d = direction(random);
    lookups.add(cells.cell(d));
    cells.for_near(d, 0.01 * (i % 40), [&](std::int32_t near) { lookups.add(near); });
  }
  report.row({"hough_planes.directions", name}, hash);
  report.row({"hough_planes.directions.lookup", name}, lookups);
}

struct Votes {
  HoughAccumulator accumulator;
  std::span<std::uint32_t> smooth;

  static constexpr Votes take(Arena& arena, const HoughAccumulatorOptions& options) noexcept {
    Votes v;
    v.accumulator.take(arena, options);
    v.smooth = arena.take<std::uint32_t>(HoughAccumulator::cell_count(options));
    return v;
  }
  static constexpr std::size_t bytes(HoughCells kind) noexcept {
    Arena arena = Arena::measure();
    (void)take(arena, {kind, rows, distances});
    return arena.used();
  }
};
static_assert(Votes::bytes(HoughCells::array) <= most_workspace);
static_assert(Votes::bytes(HoughCells::ball) <= most_workspace);

void peak_rows(const Report& report, Votes& v, const char* name) noexcept {
  Pcg32 random(62);
  Hash votes, smooth, found;
  v.accumulator.clear(0.13);
  for (int i = 0; i < 700; ++i) {
    const Vector3 d = direction(random);
    const double distance = random.below(6000) / 1000.0 - 1;
    v.accumulator.vote(v.accumulator.directions().cell(d), distance, random.below(500));
  }
  votes.add(v.accumulator.votes());
  std::array<HoughPlanePeak, 50> peaks;
  std::uint32_t count = 0;
  found.add(find_plane_peaks(v.accumulator, v.accumulator.votes(), 300, peaks, count), count, peaks);
  smooth.add(low_pass_votes(v.accumulator, v.smooth), std::span<const std::uint32_t>(v.smooth));
  found.add(find_plane_peaks(v.accumulator, v.smooth, 900, peaks, count), count, peaks);
  report.row({"hough_planes.votes", name}, votes);
  report.row({"hough_planes.low_pass", name}, smooth);
  report.row({"hough_planes.peaks", name}, found);
}

constexpr HoughPlaneOptions options_of(HoughPlaneVoting voting, HoughCells kind) noexcept {
  HoughPlaneOptions options;
  options.voting = voting;
  options.accumulator = {kind, rows, distances};
  options.min_points = 90;
  options.every = 5;
  options.max_draws = 6000;
  options.seed = 5;
  return options;
}
static_assert(HoughPlanes::workspace_bytes(room_points, options_of(HoughPlaneVoting::standard,
                                                                   HoughCells::array)) <= most_workspace);

SAME_BITS_LARGE std::array<std::uint16_t, room_points> labels;

void search_rows(const Report& report, const PointsView& points, const HoughPlaneOptions& options,
                 std::initializer_list<const char*> name) noexcept {
  HoughPlanes search;
  std::array<FoundPlane, 16> planes;
  PlanesFound found;
  const auto labels_here = std::span(labels).first(points.count);
  Hash hash;
  hash.add(HoughPlanes::prepare(search, points.count, options, workspace()));
  hash.add(search.run(points, labels_here, planes, found), found);
  hash.add(search.confident(), search.origin());
  hash.add(std::span<const FoundPlane>(planes).first(found.planes), labels_here);
  report.row(name, hash);
}

}  // namespace

void hough_direction_cases(const Report& report) noexcept {
  for (const auto& [kind, name] : kinds) {
    Arena arena(workspace());
    Votes votes = Votes::take(arena, {kind, rows, distances});
    votes.accumulator.fill(kind);
    direction_row(report, votes.accumulator.directions(), name);
    peak_rows(report, votes, name);
  }
  Hash needed;
  for (std::size_t points = 100; points < 200'000; points += points / 3) {
    needed.add(triples_needed(points, options_of(HoughPlaneVoting::randomized, HoughCells::ball)));
  }
  report.row({"hough_planes.triples_needed"}, needed);
}

void hough_plane_cases(const Report& report) noexcept {
  for (const auto& [kind, name] : kinds) {
    const auto standard = options_of(HoughPlaneVoting::standard, kind);
    const auto randomized = options_of(HoughPlaneVoting::randomized, kind);
    search_rows(report, room_cloud(), standard, {"hough_planes.standard", name, ".room"});
    search_rows(report, room_cloud(), randomized, {"hough_planes.randomized", name, ".room"});
    HoughPlaneOptions sensor = randomized;
    sensor.gate = {};
    search_rows(report, seen_cloud(), sensor, {"hough_planes.randomized", name, ".seen"});
  }
}

}  // namespace same_bits
