// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <cstddef>
#include <cstdint>
#include <vector>

#include "straightedge/arena.hpp"
#include "support/catch.hpp"

using straightedge::Arena;

namespace {

struct Pieces {
  std::span<std::uint8_t> bytes;
  std::span<double> doubles;
  std::span<std::int16_t> shorts;
};

constexpr Pieces take_all(Arena& arena) {
  return {arena.take<std::uint8_t>(13), arena.take<double>(7), arena.take<std::int16_t>(100)};
}

constexpr std::size_t measured() {
  Arena arena = Arena::measure();
  take_all(arena);
  return arena.used();
}

}  // namespace

TEST_CASE("measuring says what taking needs, wherever the memory begins") {
  constexpr std::size_t needed = measured();
  alignas(64) std::byte memory[needed + 64];
  for (std::size_t start = 0; start < 64; ++start) {
    Arena arena(std::span(memory + start, needed));
    const Pieces pieces = take_all(arena);
    CAPTURE(start);
    REQUIRE_FALSE(arena.failed());
    CHECK(arena.used() <= needed);
    CHECK(pieces.bytes.size() == 13);
    CHECK(pieces.doubles.size() == 7);
    CHECK(pieces.shorts.size() == 100);
    CHECK(reinterpret_cast<std::uintptr_t>(pieces.bytes.data()) % 64 == 0);
    CHECK(reinterpret_cast<std::uintptr_t>(pieces.doubles.data()) % 64 == 0);
    CHECK(reinterpret_cast<std::uintptr_t>(pieces.shorts.data()) % 64 == 0);
    const auto* const end = reinterpret_cast<const std::byte*>(pieces.shorts.data() + pieces.shorts.size());
    CHECK(end <= memory + start + needed);
    CHECK(reinterpret_cast<std::byte*>(pieces.doubles.data()) >=
          reinterpret_cast<std::byte*>(pieces.bytes.data()) + 13);
  }
}

TEST_CASE("an arena that is too small says so and hands out nothing") {
  alignas(64) std::byte memory[128];
  Arena arena{std::span<std::byte>(memory)};
  CHECK(arena.take<std::uint8_t>(64).size() == 64);
  CHECK(arena.take<std::uint8_t>(65).empty());
  CHECK(arena.failed());
}

TEST_CASE("a count that no memory can hold fails") {
  alignas(64) std::byte memory[128];
  Arena arena{std::span<std::byte>(memory)};
  CHECK(arena.take<double>(SIZE_MAX / 4).empty());
  CHECK(arena.failed());
  Arena counting = Arena::measure();
  counting.take<double>(SIZE_MAX / 4);
  CHECK(counting.failed());
}

TEST_CASE("an arena without memory fails at the first piece") {
  Arena arena{std::span<std::byte>()};
  CHECK(arena.take<int>(1).empty());
  CHECK(arena.failed());
}
