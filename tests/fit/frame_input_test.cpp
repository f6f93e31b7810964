// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <vector>

#include "frame_testing.hpp"
#include "support/guarded_image.hpp"

using namespace frame;

namespace {

constexpr Size size{160, 120};

struct Room {
  std::vector<Plane> planes = support::box_planes();
  DepthScene scene = support::box_room(size, planes);
  DepthFrame frame = support::frame_of(scene, {}, 3);
  std::vector<InverseDepthPlane> truth = seen_by(scene.camera(), planes);
};

Status prepared_with(const FramePlanesOptions& options, Size s = size) {
  std::vector<std::byte> bytes(FramePlanes::workspace_bytes(size, {}));
  FramePlanes planes;
  return planes.prepare(s, options, bytes);
}

bool same_bits(const PlaneFit& a, const PlaneFit& b) {
  return std::memcmp(&a, &b, sizeof a) == 0;  // doubles alone, without gaps
}

void check_same(const FoundFrame& a, const FoundFrame& b) {
  CHECK(a.labels == b.labels);
  REQUIRE(a.planes.size() == b.planes.size());
  for (std::size_t k = 0; k < a.planes.size(); ++k) CHECK(same_bits(a.planes[k].fit, b.planes[k].fit));
  CHECK(a.found.labelled == b.found.labelled);
  CHECK(a.found.readings == b.found.readings);
}

}  // namespace

TEST_CASE("options out of their range are refused") {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const auto refused = [](auto&& change) {
    FramePlanesOptions options;
    change(options);
    return prepared_with(options) == Status::invalid_option;
  };
  for (const double v : {nan, infinity, -infinity, 0.0, 0.99, 10.01}) {
    INFO(v);
    CHECK(refused([&](auto& o) { o.slack = v; }));
  }
  for (const double v : {nan, infinity, 0.0, 0.99, 1000.5}) {
    INFO(v);
    CHECK(refused([&](auto& o) { o.noise_pixels = v; }));
  }
  for (const std::uint32_t v : {0U, 257U, 100000U, 0xFFFFFFFFU}) {
    CHECK(refused([&](auto& o) { o.max_planes = v; }));
  }
  for (const std::uint32_t v : {9U, 0xFFFFFFFFU}) CHECK(refused([&](auto& o) { o.rounds = v; }));
  for (const double v : {nan, infinity, 0.0, -1.0}) {
    INFO(v);
    CHECK(refused([&](auto& o) { o.gate.inverse_sigma = v; }));
    CHECK(refused([&](auto& o) { o.gate.sigmas = v; }));
  }
  for (const double v : {nan, infinity, -1.0}) {
    INFO(v);
    CHECK(refused([&](auto& o) { o.gate.floor_m = v; }));
    CHECK(refused([&](auto& o) { o.gate.fixed_m = v; }));
  }
  FramePlanesOptions bounds;
  bounds.slack = 10;
  bounds.noise_pixels = 1000;
  bounds.rounds = 8;
  bounds.max_planes = 1;
  CHECK(prepared_with(bounds) == Status::ok);
}

TEST_CASE("sizes without pixels, or with too many, are refused") {
  for (const Size s : {Size{0, 10}, Size{10, 0}, Size{-5, 10}, Size{10, -5}, Size{0, 0}}) {
    CHECK(prepared_with({}, s) == Status::invalid_image);
  }
  const std::int32_t most = std::numeric_limits<std::int32_t>::max();
  CHECK(prepared_with({}, {1 << 14, (1 << 14) + 1}) == Status::too_large);
  CHECK(prepared_with({}, {most, most}) == Status::too_large);
  CHECK(prepared_with({}, {1 << 14, 1 << 14}) == Status::workspace_too_small);
}

TEST_CASE("the workspace that is asked for suffices, whatever its start; a byte less does not") {
  const Room room;
  constexpr std::size_t bytes = FramePlanes::workspace_bytes(size, {});
  constexpr std::size_t guard = 256;
  constexpr auto pattern = std::byte{0xC3};
  for (const std::size_t shift : {0U, 1U, 17U, 63U}) {
    std::vector<std::byte> memory(bytes + 2 * guard + shift, pattern);
    const std::span<std::byte> workspace = std::span(memory).subspan(guard + shift, bytes);
    FramePlanes planes;
    REQUIRE(planes.prepare(size, {}, workspace) == Status::ok);
    FakeSearch fake{room.truth};
    Image<std::uint16_t> labels(size);
    std::vector<FoundPlane> out(8);
    PlanesFound found;
    REQUIRE(planes.run(room.frame.view(), as_search(fake), labels.view(), out, found) == Status::ok);
    CHECK(found.planes == 5);
    for (std::size_t i = 0; i < memory.size(); ++i) {
      if (i < guard + shift || i >= guard + shift + bytes) REQUIRE(memory[i] == pattern);
    }
  }
  // One byte after a multiple of 64, so that no room is left over.
  std::vector<std::byte> memory(bytes + 128);
  const auto address = std::bit_cast<std::uintptr_t>(memory.data());
  const std::size_t skip = (64 - address % 64) % 64 + 1;
  FramePlanes planes;
  CHECK(planes.prepare(size, {}, std::span(memory).subspan(skip, bytes)) == Status::ok);
  CHECK(planes.prepare(size, {}, std::span(memory).subspan(skip, bytes - 1)) == Status::workspace_too_small);
  CHECK(planes.prepare(size, {}, {}) == Status::workspace_too_small);
}

TEST_CASE("run before a successful prepare is refused") {
  const Room room;
  FakeSearch fake{room.truth};
  Image<std::uint16_t> labels(size);
  std::vector<FoundPlane> out(8);
  PlanesFound found;
  FramePlanes planes;
  const auto run = [&] { return planes.run(room.frame.view(), as_search(fake), labels.view(), out, found); };
  CHECK(run() == Status::not_prepared);
  std::vector<std::byte> bytes(FramePlanes::workspace_bytes(size, {}));
  REQUIRE(planes.prepare(size, {}, bytes) == Status::ok);
  CHECK(run() == Status::ok);
  FramePlanesOptions bad;
  bad.rounds = 9;
  REQUIRE(planes.prepare(size, bad, bytes) == Status::invalid_option);
  CHECK(run() == Status::not_prepared);
}

TEST_CASE("views that make no sense are refused") {
  const Room room;
  Finder finder(size, {});
  FakeSearch fake{room.truth};
  std::vector<FoundPlane> out(8);
  PlanesFound found;
  const auto run = [&](const DepthView& depth, Size label_size) {
    Image<std::uint16_t> labels(label_size);
    return finder.planes.run(depth, as_search(fake), labels.view(), out, found);
  };
  CHECK(run(room.frame.view(), size) == Status::ok);
  CHECK(run(room.frame.view(), {size.width, size.height - 1}) == Status::size_mismatch);
  const Image<std::uint16_t> other({size.width + 1, size.height}, std::uint16_t{1000});
  CHECK(run({other, 0.001, room.frame.camera}, other.size()) == Status::size_mismatch);
  CHECK(run({{}, 0.001, room.frame.camera}, size) == Status::invalid_image);
  for (const double scale : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN()}) {
    CHECK(run({room.frame.raw, scale, room.frame.camera}, size) == Status::invalid_image);
  }
  CHECK(run({room.frame.raw, 1e-300, room.frame.camera}, size) == Status::invalid_option);
  CHECK(run({room.frame.raw, 0.001, {0, 500, 80, 60}}, size) == Status::invalid_image);
  CHECK(finder.planes.run(room.frame.view(), as_search(fake), {}, out, found) == Status::invalid_image);
  Image<std::uint16_t> labels(size);
  CHECK(finder.planes.run(room.frame.view(), {}, labels.view(), out, found) == Status::invalid_image);
}

TEST_CASE("views with gaps between rows give the same, and the gaps stay as they are") {
  const Room room;
  const FoundFrame plain = find(room.frame, room.truth);
  support::GuardedImage<std::uint16_t> raw(size, 7), labels(size, 3, std::uint16_t{9});
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) raw.at(x, y) = room.frame.raw.at(x, y);
  }
  FoundFrame strided;
  strided.planes.resize(8);
  FakeSearch fake{room.truth};
  Finder finder(size, {});
  strided.status = finder.planes.run({raw.view(), 0.001, room.frame.camera}, as_search(fake), labels.view(),
                                     strided.planes, strided.found);
  REQUIRE(strided.status == Status::ok);
  strided.planes.resize(strided.found.planes);
  strided.labels = Image<std::uint16_t>(size);
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) strided.labels.at(x, y) = labels.at(x, y);
  }
  check_same(plain, strided);
  CHECK(raw.guards_intact());
  CHECK(labels.guards_intact());
}

TEST_CASE("the same frame gives the same bits, whatever came before it") {
  const Room room;
  Finder finder(size, {});
  const FoundFrame first = finder.run(room.frame.view(), room.truth);
  REQUIRE(first.planes.size() == 5);
  check_same(first, finder.run(room.frame.view(), room.truth));
  DepthScene ball(size);
  ball.draw_round(1, {0, 0, 1.2}, {}, 0.4);
  const DepthFrame between = support::frame_of(ball, {}, 8);
  CHECK(finder.run(between.view(), room.truth).status == Status::ok);
  check_same(first, finder.run(room.frame.view(), room.truth));
  check_same(first, Finder(size, {}).run(room.frame.view(), room.truth));
}
