// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "straightedge/frame_planes.hpp"
#include "straightedge/hough_plane_patches.hpp"
#include "straightedge/hough_planes.hpp"
#include "straightedge/ransac_planes.hpp"
#include "straightedge/ransac_search.hpp"
#include "support/catch.hpp"
#include "support/depth_scene.hpp"
#include "support/depth_score.hpp"
#include "support/guarded_image.hpp"

using namespace straightedge;

namespace {

/// What docs/planes-from-depth.md says for a board.
constexpr Size size{160, 120};
constexpr FramePlanesOptions frame_options{.max_planes = 32};
constexpr RansacSearchOptions ransac_options =
    for_frame(RansacSearchOptions{.max_candidates = 32}, size, frame_options);
constexpr HoughPatchOptions hough_options = for_frame(
    HoughPatchOptions{.accumulator = {HoughCells::ball, 20, 48}, .max_candidates = 32}, size, frame_options);
constexpr RansacOptions first_plane{.subset = 512};

constexpr std::size_t pixels = std::size_t{160} * 120;
constexpr std::size_t picture_bytes = pixels * sizeof(std::uint16_t);
constexpr std::size_t frame_bytes = FramePlanes::workspace_bytes(size, frame_options);
constexpr std::size_t ransac_bytes = RansacSearch::workspace_bytes(size, ransac_options);
constexpr std::size_t hough_bytes = HoughPatchSearch::workspace_bytes(size, hough_options);
constexpr std::size_t first_bytes = RansacPlanes::workspace_bytes(pixels, first_plane);
static_assert(ransac_options.min_pixels == 64 && hough_options.min_pixels == 64);
static_assert(frame_bytes + ransac_bytes + 2 * picture_bytes < 400 * 1024);
static_assert(frame_bytes + hough_bytes + picture_bytes < 512 * 1024);
static_assert(first_bytes + pixels * sizeof(float) + 2 * picture_bytes < 256 * 1024);
static_assert(FramePlanes::workspace_bytes(size, {.max_planes = 257}) == 0);
static_assert(FramePlanes::workspace_bytes({0, 120}, frame_options) == 0);

/// Exactly so many bytes at an address that wastes most, between guards.
class Guarded {
 public:
  explicit Guarded(std::size_t bytes) : bytes_(bytes + 64 + 2 * guard, pattern), size_(bytes) {
    const auto address = reinterpret_cast<std::uintptr_t>(bytes_.data() + guard);
    first_ = guard + (65 - address % 64) % 64;
  }
  std::span<std::byte> bytes() { return std::span(bytes_).subspan(first_, size_); }
  std::span<std::byte> one_less() { return bytes().first(size_ - 1); }
  bool intact() const {
    const auto is_guard = [](std::byte b) { return b == pattern; };
    return std::all_of(bytes_.begin(), bytes_.begin() + static_cast<std::ptrdiff_t>(first_), is_guard) &&
           std::all_of(bytes_.begin() + static_cast<std::ptrdiff_t>(first_ + size_), bytes_.end(), is_guard);
  }

 private:
  static constexpr std::size_t guard = 256;
  static constexpr std::byte pattern{0xA5};
  std::vector<std::byte> bytes_;
  std::size_t size_, first_ = 0;
};

struct Room {
  std::vector<Plane> planes = support::box_planes();
  support::DepthFrame frame = support::frame_of(support::box_room(size, planes), {}, 3);
  Image<float> inverse_depth = Image<float>(size);

  Room() { REQUIRE(inverse_depth_image(frame.view(), inverse_depth.view()) == Status::ok); }
};

struct Result {
  Status status = Status::not_prepared;
  PlanesFound found;
  std::array<FoundPlane, 32> planes{};
};

Result run(const DepthView& depth, const PlaneSearch& search, ImageView<std::uint16_t> labels,
           Guarded& memory) {
  FramePlanes frame;
  REQUIRE(frame.prepare(size, frame_options, memory.bytes()) == Status::ok);
  Result result;
  result.status = frame.run(depth, search, labels, result.planes, result.found);
  return result;
}

/// Both ways through the core, each with its memory.
struct Searches {
  Guarded ransac_memory{ransac_bytes}, hough_memory{hough_bytes};
  RansacSearch ransac;
  HoughPatchSearch hough;

  Searches() {
    CHECK(RansacSearch::prepare(ransac, size, ransac_options, ransac_memory.one_less()) ==
          Status::workspace_too_small);
    CHECK(HoughPatchSearch::prepare(hough, size, hough_options, hough_memory.one_less()) ==
          Status::workspace_too_small);
    REQUIRE(RansacSearch::prepare(ransac, size, ransac_options, ransac_memory.bytes()) == Status::ok);
    REQUIRE(HoughPatchSearch::prepare(hough, size, hough_options, hough_memory.bytes()) == Status::ok);
  }
  std::array<PlaneSearch, 2> both() { return {plane_search(ransac), plane_search(hough)}; }
  bool intact() const { return ransac_memory.intact() && hough_memory.intact(); }
};

}  // namespace

TEST_CASE("a board finds the walls of a room by both methods, in exactly the memory it was told") {
  const Room room;
  Searches searches;
  Guarded memory(frame_bytes);
  FramePlanes frame;
  CHECK(frame.prepare(size, frame_options, memory.one_less()) == Status::workspace_too_small);
  for (const PlaneSearch& search : searches.both()) {
    Image<std::uint16_t> labels(size);
    const Result result = run(room.frame.view(), search, labels.view(), memory);
    REQUIRE(result.status == Status::ok);
    REQUIRE(result.found.planes == room.planes.size());
    const std::vector<FoundPlane> found(result.planes.begin(), result.planes.begin() + result.found.planes);
    for (const Plane& plane : room.planes) CHECK(support::count_of(found, plane) == 1);
    CHECK(memory.intact());
    CHECK(searches.intact());
  }
}

TEST_CASE("strides of the depth and of the labels change no bit, nor do labels over the depth") {
  Room room;
  Searches searches;
  Guarded memory(frame_bytes);
  support::GuardedImage<std::uint16_t> raw(size, 3), labels(size, 7);
  for (const PlaneSearch& search : searches.both()) {
    Image<std::uint16_t> plain(size);
    const Result expected = run(room.frame.view(), search, plain.view(), memory);
    for (int y = 0; y < size.height; ++y)
      for (int x = 0; x < size.width; ++x) raw.at(x, y) = room.frame.raw.at(x, y);
    DepthView depth = room.frame.view();
    depth.raw = raw.view();
    const auto check = [&](const Result& result, ImageView<const std::uint16_t> image) {
      REQUIRE(result.status == Status::ok);
      REQUIRE(result.found.planes == expected.found.planes);
      for (std::size_t k = 0; k < result.found.planes; ++k) {
        CHECK(result.planes[k].fit.plane == expected.planes[k].fit.plane);
        CHECK(result.planes[k].fit.covariance == expected.planes[k].fit.covariance);
      }
      bool same = true;
      for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) same = same && image.at(x, y) == plain.at(x, y);
      CHECK(same);
    };
    check(run(depth, search, labels.view(), memory), labels.view());
    check(run(depth, search, raw.view(), memory), raw.view());
    CHECK(raw.guards_intact());
    CHECK(labels.guards_intact());
  }
}

TEST_CASE("a search that was not prepared, or for another size, is told") {
  const Room room;
  Guarded memory(frame_bytes);
  Image<std::uint16_t> labels(size);
  RansacSearch ransac;
  HoughPatchSearch hough;
  CHECK(run(room.frame.view(), plane_search(ransac), labels.view(), memory).status == Status::not_prepared);
  CHECK(run(room.frame.view(), plane_search(hough), labels.view(), memory).status == Status::not_prepared);
  const Size other{120, 160};
  std::vector<std::byte> bytes(RansacSearch::workspace_bytes(other, ransac_options));
  REQUIRE(RansacSearch::prepare(ransac, other, ransac_options, bytes) == Status::ok);
  CHECK(run(room.frame.view(), plane_search(ransac), labels.view(), memory).status == Status::size_mismatch);
}

TEST_CASE("the first plane of a frame, in exactly its memory, whatever the labels' stride") {
  const Room room;
  RansacPlanes ransac;
  Guarded memory(first_bytes);
  std::array<FoundPlane, 1> planes;
  CHECK(RansacPlanes::prepare(ransac, pixels, first_plane, memory.one_less()) == Status::workspace_too_small);
  REQUIRE(RansacPlanes::prepare(ransac, pixels, first_plane, memory.bytes()) == Status::ok);
  Image<std::uint16_t> plain(size);
  REQUIRE(ransac.run(room.inverse_depth, room.frame.camera, planes, plain.view()).found.planes == 1);
  const PlaneFit fit = planes[0].fit;
  support::GuardedImage<std::uint16_t> labels(size, 7);
  support::GuardedImage<float> inverse_depth(size, 5);
  for (int y = 0; y < size.height; ++y)
    for (int x = 0; x < size.width; ++x) inverse_depth.at(x, y) = room.inverse_depth.at(x, y);
  REQUIRE(ransac.run(inverse_depth.view(), room.frame.camera, planes, labels.view()).found.planes == 1);
  CHECK(planes[0].fit.plane == fit.plane);
  std::uint32_t labelled = 0;
  bool same = true;
  for (int y = 0; y < size.height; ++y)
    for (int x = 0; x < size.width; ++x) {
      labelled += labels.at(x, y) == 1 ? 1U : 0U;
      same = same && labels.at(x, y) == plain.at(x, y);
    }
  CHECK(same);
  CHECK(labelled == planes[0].inliers);
  CHECK(labels.guards_intact());
  CHECK(memory.intact());
}

TEST_CASE("clouds: all the memory of RANSAC with pieces and near triples, and of both votings") {
  std::vector<float> xyz;
  for (int i = 0; i < 3000; ++i) {
    const auto u = static_cast<float>(i % 60), v = static_cast<float>(i / 60);
    xyz.insert(xyz.end(), {u / 30 - 1, v / 25 - 1, i % 2 == 0 ? 2.0F : 2.0F + u / 60});
  }
  const PointsView points{xyz.data(), xyz.data() + 1, xyz.data() + 2, 3000, 3 * sizeof(float)};
  std::vector<std::uint16_t> labels(3000);
  std::array<FoundPlane, 8> planes;
  const RansacOptions options{
      .gate = {.fixed_m = 0.02}, .near_radius = 0.5, .max_planes = 4, .split = true, .seed = 5};
  RansacPlanes ransac;
  Guarded memory(RansacPlanes::workspace_bytes(3000, options));
  CHECK(RansacPlanes::prepare(ransac, 3000, options, memory.one_less()) == Status::workspace_too_small);
  REQUIRE(RansacPlanes::prepare(ransac, 3000, options, memory.bytes()) == Status::ok);
  CHECK(ransac.run(points, planes, labels).found.planes >= 2);
  CHECK(memory.intact());
  for (const HoughPlaneVoting voting : {HoughPlaneVoting::standard, HoughPlaneVoting::randomized}) {
    const HoughPlaneOptions votes{.voting = voting, .accumulator = {HoughCells::ball, 16, 32}};
    HoughPlanes hough;
    Guarded cells(HoughPlanes::workspace_bytes(3000, votes));
    CHECK(HoughPlanes::prepare(hough, 3000, votes, cells.one_less()) == Status::workspace_too_small);
    REQUIRE(HoughPlanes::prepare(hough, 3000, votes, cells.bytes()) == Status::ok);
    PlanesFound found;
    REQUIRE(hough.run(points, labels, planes, found) == Status::ok);
    CHECK(found.planes >= 1);
    CHECK(cells.intact());
  }
}
