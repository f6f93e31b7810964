// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "io/gzip.hpp"

#include <string>

#include "catch.hpp"
#include "gzip_maker.hpp"
#include "straightedge/host/laser_log.hpp"

using namespace straightedge;

namespace {

std::string refusal_of(const std::string& packed, std::size_t most = 1 << 20) {
  const auto text = io::gunzip(packed, most, "x.gz");
  REQUIRE_FALSE(text);
  CHECK(text.failure().problem == Problem::bad_content);
  REQUIRE(text.failure().sentence.starts_with("x.gz: "));
  return text.failure().sentence.substr(6);
}

const std::string some_text = "SCAN 1 0 0 0 2 1 80 3 1 2 3\n";

}  // namespace

TEST_CASE("what was packed comes out, in one member or in several") {
  std::string large;
  for (int i = 0; i < 200000; ++i) large += std::to_string(i * 7919);
  for (const std::string& text : {std::string(), std::string("a"), some_text, large}) {
    const auto unpacked = io::gunzip(gzip_maker::packed(text), large.size(), "x.gz");
    REQUIRE(unpacked);
    CHECK(*unpacked == text);
  }
  const std::string two = gzip_maker::packed(some_text) + gzip_maker::packed("more");
  REQUIRE(io::gunzip(two + std::string(512, '\0'), 1000, "x.gz"));
  CHECK(*io::gunzip(two + std::string(512, '\0'), 1000, "x.gz") == some_text + "more");
}

TEST_CASE("every way to cut or damage gzip data is refused") {
  const std::string packed = gzip_maker::packed(some_text);
  for (std::size_t length = 2; length < packed.size(); ++length)
    CHECK(refusal_of(packed.substr(0, length)) == "is cut short: its gzip data ends too early");
  std::string damaged = packed;
  damaged[packed.size() - 6] ^= 1;  // of the check sum
  CHECK(refusal_of(damaged) == "its gzip data is damaged");
  CHECK(refusal_of(packed + "x") == "has other bytes behind its gzip data");
  CHECK(refusal_of("\x1F\x8B junk") == "its gzip data is damaged");
}

TEST_CASE("a small file that unpacks to a large one is refused at the limit") {
  const std::string bomb = gzip_maker::packed(std::string(std::size_t{64} << 20, '0'));
  REQUIRE(bomb.size() < 100000);
  CHECK(refusal_of(bomb, 1 << 20) == "unpacks to more than the 1048576 bytes that are read of such a file");
  const std::string exact = gzip_maker::packed(std::string(1000, 'x'));
  CHECK(io::gunzip(exact, 1000, "x.gz"));
  CHECK_FALSE(io::gunzip(exact, 999, "x.gz"));
}

TEST_CASE("a packed log is read, a broken one is refused by name") {
  const auto log = laser_log_from_bytes(gzip_maker::packed(some_text), "x.gz");
  REQUIRE(log);
  CHECK(log->scans.size() == 1);
  const std::string packed = gzip_maker::packed(some_text);
  const auto cut = laser_log_from_bytes(packed.substr(0, packed.size() - 3), "x.gz");
  REQUIRE_FALSE(cut);
  CHECK(cut.failure().sentence == "x.gz: is cut short: its gzip data ends too early");
}
