// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <random>
#include <string>
#include <vector>

#include "catch.hpp"
#include "cloud_maker.hpp"
#include "io/lzf.hpp"

using straightedge::io::lzf_decompress;

namespace {

/// What the input gives when the output has `size` bytes; "broken" when it does not.
std::string unpacked(const std::string& packed, std::size_t size) {
  // Kept to its length on the heap, where a sanitizer sees a step too far.
  std::vector<char> input(packed.begin(), packed.end());
  std::vector<char> output(size);
  if (!lzf_decompress({input.data(), input.size()}, output)) return "broken";
  return {output.begin(), output.end()};
}

}  // namespace

TEST_CASE("LZF: literals, repeats that overlap themselves, long repeats") {
  using namespace std::string_literals;
  CHECK(unpacked("\x02"
                 "abc"s,
                 3) == "abc");
  CHECK(unpacked("\x02"
                 "abc\x20\x02"s,
                 6) == "abcabc");
  CHECK(unpacked("\x00"
                 "a\xE0\x05\x00"s,
                 15) == std::string(15, 'a'));
  CHECK(unpacked("\x01"
                 "ab\x60\x01"s,
                 7) == "abababa");
  CHECK(unpacked("", 0).empty());
}

TEST_CASE("LZF: steps that leave the input or the output are refused") {
  using namespace std::string_literals;
  CHECK(unpacked("\x02"
                 "ab"s,
                 3) == "broken");
  CHECK(unpacked("\x02"
                 "abc"s,
                 2) == "broken");
  CHECK(unpacked("\x02"
                 "abc"s,
                 4) == "broken");
  CHECK(unpacked("\x02"
                 "abc\x20"s,
                 6) == "broken");
  CHECK(unpacked("\x02"
                 "abc\xE0\x01"s,
                 13) == "broken");
  CHECK(unpacked("\x02"
                 "abc\x20\x03"s,
                 6) == "broken");
  CHECK(unpacked("\x20\x00"s, 3) == "broken");
  CHECK(unpacked("\x02"
                 "abc\x20\x02"s,
                 5) == "broken");
}

TEST_CASE("LZF: what is compressed comes back") {
  const std::uint32_t seed = 40;
  std::mt19937 generator(seed);
  for (int round = 0; round < 500; ++round) {
    std::string bytes;
    const auto length = generator() % 2000;
    while (bytes.size() < length) {
      bytes.append(1 + (generator() % 4 == 0 ? generator() % 600 : generator() % 3),
                   static_cast<char>(generator() % 4));
    }
    INFO("seed " << seed << ", round " << round);
    REQUIRE(unpacked(cloud_maker::lzf_compress(bytes), bytes.size()) == bytes);
  }
}

TEST_CASE("LZF: random input stays within its bounds") {
  const std::uint32_t seed = 41;
  std::mt19937 generator(seed);
  for (int round = 0; round < 5000; ++round) {
    std::string bytes(generator() % 40, '\0');
    for (char& byte : bytes) byte = static_cast<char>(generator());
    (void)unpacked(bytes, generator() % 300);
  }
}
