// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "straightedge/host/plane_leaves_file.hpp"
#include "io/temporary_folder.hpp"
#include "plane_scene.hpp"

using namespace straightedge;

namespace {

std::string room_bytes() {
  PlaneMapBuilder builder(scene::options());
  for (const scene::Frame& frame : scene::tour(scene::room(), 3, 21)) scene::add(builder, frame);
  return plane_leaves_to_bytes(builder.leaves());
}

bool refused(const std::string& bytes) {
  const auto result = plane_leaves_from_bytes(bytes, "some.leaves");
  if (result) return false;
  CHECK(result.failure().problem == Problem::bad_content);
  CHECK(result.failure().sentence.find("some.leaves") == 0);
  return true;
}

}  // namespace

TEST_CASE("leaves come back from a file as they were, and so does the map") {
  PlaneMapBuilder builder(scene::options());
  for (const scene::Frame& frame : scene::tour(scene::room(), 4, 20)) scene::add(builder, frame);
  const TemporaryFolder folder;
  REQUIRE(write_plane_leaves(folder / "room.leaves", builder.leaves()));
  const auto leaves = read_plane_leaves(folder / "room.leaves");
  REQUIRE(leaves);
  CHECK(leaves->frames == 4);
  CHECK(leaves->sorted() == builder.leaves().sorted());
  CHECK(plane_leaves_to_bytes(*leaves) == plane_leaves_to_bytes(builder.leaves()));
  PlaneMapBuilder again(scene::options());
  REQUIRE(again.merge(*leaves));
  CHECK(scene::read(again).map == scene::read(builder).map);
  CHECK(plane_leaves_to_bytes(builder.leaves()).size() < 80 * builder.leaves().size());
}

TEST_CASE("an empty map has leaves too: none") {
  const auto leaves = plane_leaves_from_bytes(plane_leaves_to_bytes(PlaneLeaves{}), "empty");
  REQUIRE(leaves);
  CHECK(leaves->size() == 0);
}

TEST_CASE("a file that is missing, foreign, cut off or too long is refused") {
  const std::string bytes = room_bytes();
  const TemporaryFolder folder;
  CHECK(read_plane_leaves(folder / "none").failure().problem == Problem::cannot_read);
  CHECK(refused(""));
  CHECK(refused("P5 640 480 65535"));
  for (std::size_t length = 0; length < 200; ++length) CHECK(refused(bytes.substr(0, length)));
  CHECK(refused(bytes.substr(0, bytes.size() - 1)));
  CHECK(refused(bytes + '\0'));
  std::string other = bytes;
  other[8] = 2;
  CHECK(refused(other));
  other = bytes;
  other[9] = 1;
  CHECK(refused(other));
}

TEST_CASE("a promise of many leaves takes no memory") {
  std::string bytes = plane_leaves_to_bytes(PlaneLeaves{});
  bytes.pop_back();
  bytes += "\xFE\xFF\xFF\xFF\x0F";
  CHECK(refused(bytes));
}

TEST_CASE("leaves with impossible sums or twice the same key are refused") {
  PlaneLeaves leaves;
  PlaneLeafSums sums;
  sums.readings = 10;
  sums.weight = 1000;
  sums.nx = 1000 << 14;
  sums.xx = 100;
  const PlaneLeafSums good = sums;
  const int fault = GENERATE(range(0, 9));
  CAPTURE(fault);
  if (fault == 1) sums.readings = 0;
  if (fault == 2) sums.weight = 5;
  if (fault == 3) sums.x = std::int64_t{1} << 62;
  if (fault == 4) sums.xx = -1;
  if (fault == 5) sums.nx = 0;
  if (fault == 6) sums.residual = -5;
  if (fault == 7) sums.tilt = std::int64_t{1} << 60;
  if (fault == 8) sums.ny = -(std::int64_t{1} << 62) - (std::int64_t{1} << 62);
  leaves.at(leaves.place({77, 3})) = sums;
  leaves.at(leaves.place({78, 3})) = good;
  const std::string bytes = plane_leaves_to_bytes(leaves);
  CHECK(refused(bytes) == (fault > 0));
  if (fault > 0) return;
  // Both leaves have equal bytes but for the step to them: make the second step 0.
  const std::size_t one = (bytes.size() - 14) / 2;
  std::string twice = bytes;
  REQUIRE(twice[bytes.size() - one] == 1);
  twice[bytes.size() - one] = 0;
  CHECK(refused(twice));
}

TEST_CASE("changed bytes are refused or read, and what is read can be built") {
  const std::string bytes = room_bytes();
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    CAPTURE(seed);
    Pcg32 random(seed);
    std::string changed = bytes;
    for (int i = 0; i < 3; ++i)
      changed[8 + random.below(static_cast<std::uint32_t>(bytes.size() - 8))] =
          static_cast<char>(random.next());
    const auto leaves = plane_leaves_from_bytes(changed, "changed");
    if (!leaves) continue;
    PlaneMapBuilder builder(scene::options());
    REQUIRE(builder.merge(*leaves));
    CHECK(builder.build());
  }
}
