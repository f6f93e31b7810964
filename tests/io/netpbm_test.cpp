// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <string>
#include <vector>

#include "catch.hpp"
#include "straightedge/host/image_file.hpp"

using straightedge::decode_gray_image;
using straightedge::Problem;

namespace {

std::vector<int> values_of(const std::string& bytes) {
  const auto image = decode_gray_image(bytes, "x.pgm");
  INFO(bytes.substr(0, 40));
  if (!image) FAIL(image.failure().sentence);
  std::vector<int> values;
  for (int y = 0; y < image->height(); ++y) {
    for (int x = 0; x < image->width(); ++x) values.push_back(image->at(x, y));
  }
  return values;
}

std::string refusal_of(const std::string& bytes) {
  const auto image = decode_gray_image(bytes, "x.pgm");
  INFO(bytes.substr(0, 40));
  REQUIRE_FALSE(image);
  CHECK(image.failure().problem == Problem::bad_content);
  return image.failure().sentence;
}

const std::string zero(1, '\0');

}  // namespace

TEST_CASE("PGM in its four notations") {
  CHECK(values_of("P5\n3 1\n255\n" + zero + "\x7F\xFF") == std::vector<int>{0, 127, 255});
  CHECK(values_of("P2 3 1 255 0 127 255") == std::vector<int>{0, 127, 255});
  // The upper byte, not the lower one: big-endian.
  CHECK(values_of("P5 2 1 65535\n\x12\x34\xFF" + zero) == std::vector<int>{0x12, 0xFF});
  CHECK(values_of("P2\n2 1\n65535\n4660 65280\n") == std::vector<int>{0x12, 0xFF});
}

TEST_CASE("PPM becomes gray by the integer weights") {
  const auto luma = [](int r, int g, int b) { return (9798 * r + 19235 * g + 3735 * b + 16384) >> 15; };
  CHECK(values_of("P6 2 1 255\n" + std::string("\xFF") + zero + zero + "\x0A\xC8\x64") ==
        std::vector<int>{luma(255, 0, 0), luma(10, 200, 100)});
  CHECK(values_of("P3 1 1 255 1 2 3") == std::vector<int>{luma(1, 2, 3)});
}

TEST_CASE("comments stand anywhere before the last blank of the header") {
  CHECK(values_of("P5 # made\n#by hand 9 9\n2 #width\n1\n# maximum\n255\n\x05\x06") ==
        std::vector<int>{5, 6});
  CHECK(values_of("P2\n#c\n1 1 255 # the value\n 9\n") == std::vector<int>{9});
}

TEST_CASE("values are scaled from the stated maximum, rounded") {
  CHECK(values_of("P2 5 1 4 0 1 2 3 4") == std::vector<int>{0, 64, 128, 191, 255});
  CHECK(values_of("P5 2 1 100\n\x64\x32") == std::vector<int>{255, 128});
  CHECK(values_of("P5 2 1 1000\n\x03\xE8\x01\xF4") == std::vector<int>{255, 128});
  CHECK(values_of("P2 2 1 1 0 1") == std::vector<int>{0, 255});
}

TEST_CASE("broken PGM is refused with a sentence") {
  CHECK(refusal_of("P5\n") == "x.pgm: has a broken PGM or PPM header");
  CHECK(refusal_of("P5 2 x 255 ab") == "x.pgm: has a broken PGM or PPM header");
  CHECK(refusal_of("P5 -2 2 255 ab") == "x.pgm: has a broken PGM or PPM header");
  CHECK(refusal_of("P5 2 2 255") == "x.pgm: is truncated: it ends after its header");
  CHECK(refusal_of("P5 2 2 255\nabc") == "x.pgm: is truncated");
  CHECK(refusal_of("P5 2 2 256\nabcd") == "x.pgm: is truncated");
  CHECK(refusal_of("P6 2 2 255\nabcd") == "x.pgm: is truncated");
  CHECK(refusal_of("P2 2 2 255\n1 2 3    ") == "x.pgm: is truncated");
  CHECK(refusal_of("P2 2 2 255\n1 2 3 four") == "x.pgm: has something between its values that is no number");
  CHECK(refusal_of("P2 1 1 255\n256") == "x.pgm: has a value above its stated maximum");
  CHECK(refusal_of("P5 1 1 100\n\x65") == "x.pgm: has a value above its stated maximum");
  CHECK(refusal_of("P5 1 1 0\na") == "x.pgm: has a maximum value outside of 1 to 65535");
  CHECK(refusal_of("P5 1 1 65536\nab") == "x.pgm: has a maximum value outside of 1 to 65535");
  CHECK(refusal_of("P5 0 5 255\n") == "x.pgm: has no pixels (0x5)");
}

TEST_CASE("sizes that no file can hold are refused by the header") {
  CHECK(refusal_of("P5 20000 20000 255\nabcd") ==
        "x.pgm: is too large: 20000x20000 pixels, and at most 2^28 are read");
  CHECK(refusal_of("P5 4294967295 4294967295 255\nabcd") ==
        "x.pgm: is too large: 4294967295x4294967295 pixels, and at most 2^28 are read");
  CHECK(refusal_of("P5 4294967296 1 255\nabcd") == "x.pgm: has a broken PGM or PPM header");
  CHECK(refusal_of("P5 99999999999999999999 1 255\nabcd") == "x.pgm: has a broken PGM or PPM header");
  // Within the limit, but not in the file: refused before memory is taken.
  CHECK(refusal_of("P5 16384 16384 255\nabcd") == "x.pgm: is truncated");
}
