// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "straightedge/host/depth_file.hpp"

#include <string>
#include <vector>

#include "catch.hpp"
#include "png_maker.hpp"
#include "straightedge/host/image_file.hpp"
#include "temporary_folder.hpp"

using namespace straightedge;
using png_maker::Colour;

namespace {

const std::string fixtures = STRAIGHTEDGE_FIXTURES "/depth/";
const std::string zero(1, '\0');

/// FNV-1a over the values, rows from the top, upper byte first.
std::uint64_t hash_of(const Image<std::uint16_t>& image) {
  std::uint64_t hash = 0xcbf29ce484222325u;
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      for (const int byte : {image.at(x, y) >> 8, image.at(x, y) & 255})
        hash = (hash ^ static_cast<std::uint64_t>(byte)) * 0x100000001b3u;
    }
  }
  return hash;
}

std::vector<int> values_of(const std::string& bytes) {
  const auto image = decode_depth_image(bytes, "d");
  if (!image) FAIL(image.failure().sentence);
  std::vector<int> values;
  for (int y = 0; y < image->height(); ++y) {
    for (int x = 0; x < image->width(); ++x) values.push_back(image->at(x, y));
  }
  return values;
}

std::string refusal_of(const std::string& bytes) {
  const auto image = decode_depth_image(bytes, "d");
  INFO(bytes.substr(0, 60));
  REQUIRE_FALSE(image);
  CHECK(image.failure().problem == Problem::bad_content);
  CHECK(image.failure().sentence.starts_with("d: "));
  return image.failure().sentence.substr(3);
}

/// Pixel (x, y) of the pictures that are made here.
int value_at(int x, int y) {
  return 1000 * y + 7 * x + 256;
}

/// The rows of a pass: every `step` pixels from the offset, led by the filter byte 0.
std::string pass(int width, int height, int x0, int y0, int dx, int dy) {
  std::string rows;
  for (int y = y0; y < height; y += dy) {
    if (x0 < width) rows += zero;
    for (int x = x0; x < width; x += dx) {
      rows += static_cast<char>(value_at(x, y) >> 8);
      rows += static_cast<char>(value_at(x, y) & 255);
    }
  }
  return rows;
}

Image<std::uint16_t> picture(int width, int height) {
  Image<std::uint16_t> image({width, height});
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) image.at(x, y) = static_cast<std::uint16_t>(value_at(x, y));
  }
  return image;
}

}  // namespace

TEST_CASE("depth PNG reads as OpenCV 4.6.0 reads it") {
  const auto office = read_depth_image(fixtures + "mrpt_office/depth.png");
  REQUIRE(office);
  CHECK(office->size() == Size{640, 480});
  CHECK(office->at(320, 240) == 1833);
  CHECK(hash_of(*office) == 0x6161cb567d1e2de0u);
  CHECK(hash_of(*read_depth_image(fixtures + "room/depth/00.png")) == 0x67910f833d7ae272u);
  CHECK(hash_of(*read_depth_image(fixtures + "room/labels/05.png")) == 0x68a231c6ccc8fd97u);
}

TEST_CASE("PNG made by hand, plain and interlaced") {
  const std::string plain = pass(5, 6, 0, 0, 1, 1);
  const auto read = decode_depth_image(png_maker::png(5, 6, 16, Colour::gray, plain), "d");
  REQUIRE(read);
  CHECK(*read == picture(5, 6));
  // Adam7: seven passes of ever finer grids.
  const std::string passes = pass(5, 6, 0, 0, 8, 8) + pass(5, 6, 4, 0, 8, 8) + pass(5, 6, 0, 4, 4, 8) +
                             pass(5, 6, 2, 0, 4, 4) + pass(5, 6, 0, 2, 2, 4) + pass(5, 6, 1, 0, 2, 2) +
                             pass(5, 6, 0, 1, 1, 2);
  const auto interlaced = decode_depth_image(png_maker::png(5, 6, 16, Colour::gray, passes, "", 1), "d");
  REQUIRE(interlaced);
  CHECK(*interlaced == picture(5, 6));
}

TEST_CASE("gamma and a transparent value do not change readings") {
  const std::string extra =
      png_maker::chunk("gAMA", png_maker::big_endian(22000)) + png_maker::chunk("tRNS", "\1" + zero);
  const auto read =
      decode_depth_image(png_maker::png(5, 6, 16, Colour::gray, pass(5, 6, 0, 0, 1, 1), extra), "d");
  REQUIRE(read);
  CHECK(*read == picture(5, 6));
}

TEST_CASE("16-bit PGM in both notations, big-endian, values as they are") {
  CHECK(values_of("P5 2 1 65535\n\x12\x34\xFF" + zero) == std::vector<int>{0x1234, 0xFF00});
  CHECK(values_of("P5\n# Kinect\n2 1\n# mm\n4096\n\x10" + zero + "\1\2") == std::vector<int>{4096, 258});
  CHECK(values_of("P2\n3 1 # three\n1000\n0 999\n1000\n") == std::vector<int>{0, 999, 1000});
}

TEST_CASE("pictures that are no depth are refused by kind") {
  const std::string need = "; depth is one 16-bit gray value a pixel";
  const std::string rows(200, '\0');
  CHECK(refusal_of(png_maker::png(4, 4, 8, Colour::gray, rows)) == "is an 8-bit gray picture" + need);
  CHECK(refusal_of(png_maker::png(4, 4, 1, Colour::gray, rows)) == "is a 1-bit gray picture" + need);
  CHECK(refusal_of(png_maker::png(4, 4, 16, Colour::rgb, rows)) == "is a 16-bit colour picture" + need);
  CHECK(refusal_of(png_maker::png(4, 4, 8, Colour::rgb_alpha, rows)) == "is an 8-bit colour picture" + need);
  CHECK(refusal_of(png_maker::png(4, 4, 8, Colour::palette, rows)) ==
        "is an 8-bit picture with a palette" + need);
  CHECK(refusal_of(png_maker::png(4, 4, 16, Colour::gray_alpha, rows)) ==
        "is a 16-bit gray picture with transparency" + need);
  CHECK(refusal_of("P5 2 1 255\nab") == "is an 8-bit gray picture" + need);
  CHECK(refusal_of("P6 1 1 65535\nabcdef") == "is a colour picture" + need);
  CHECK(refusal_of("") == "is empty");
  CHECK(refusal_of("\xFF\xD8\xFF\xE0 JPEG") == "is neither a 16-bit gray PNG nor a 16-bit PGM");
}

TEST_CASE("headers that promise what no file holds") {
  const std::string rows(40, '\0');
  CHECK(refusal_of(png_maker::png(0x80000000u, 0x80000000u, 16, Colour::gray, rows)) ==
        "is too large: 2147483648x2147483648 pixels, and at most 2^28 are read");
  CHECK(refusal_of(png_maker::png(16385, 16384, 16, Colour::gray, rows)).starts_with("is too large"));
  CHECK(refusal_of(png_maker::png(16384, 16384, 16, Colour::gray, rows)) == "is truncated");
  CHECK(refusal_of(png_maker::png(0, 4, 16, Colour::gray, rows)) == "has no pixels (0x4)");
  CHECK(refusal_of("P5 100000 100000 65535\nab").starts_with("is too large"));
  CHECK(refusal_of("P5 16384 16384 65535\nab") == "is truncated");
}

TEST_CASE("broken PGM is refused") {
  CHECK(refusal_of("P5 2 2 65535\nabcdefg") == "is truncated");
  CHECK(refusal_of("P2 2 2 65535\n1 2 3   ") == "is truncated");
  CHECK(refusal_of("P2 2 1 65535\n1 x") == "has something between its values that is no number");
  CHECK(refusal_of("P2 2 1 1000\n1 1001") == "has a value above its stated maximum");
  CHECK(refusal_of("P5 1 1 65536\nab") == "has a maximum value outside of 1 to 65535");
  CHECK(refusal_of("P5 -2 2 65535\nabcdefgh") == "has a broken PGM or PPM header");
  CHECK(refusal_of("P5 0 2 65535\nabcdefgh") == "has no pixels (0x2)");
}

TEST_CASE("a PNG cut off anywhere is refused") {
  const TemporaryFolder folder;
  REQUIRE(write_png16(folder / "d.png", picture(40, 30)));
  const std::string whole = bytes_of(folder / "d.png");
  REQUIRE(decode_depth_image(whole, "d"));
  for (std::size_t length = 0; length < whole.size(); ++length) {
    INFO(length << " of " << whole.size() << " bytes");
    const auto read = decode_depth_image(whole.substr(0, length), "d");
    REQUIRE_FALSE(read);
    REQUIRE(read.failure().problem == Problem::bad_content);
    REQUIRE(read.failure().sentence.size() > 10);
  }
}

TEST_CASE("a PNG with one wrong byte is refused or keeps its pixels") {
  // Every chunk that counts has a check sum.
  const std::string whole = png_maker::png(5, 6, 16, Colour::gray, pass(5, 6, 0, 0, 1, 1));
  for (std::size_t at = 0; at < whole.size(); ++at) {
    std::string broken = whole;
    broken[at] = static_cast<char>(broken[at] ^ 0x10);
    const auto read = decode_depth_image(broken, "d");
    INFO("byte " << at);
    if (read) CHECK(*read == picture(5, 6));
  }
  std::string wrong_sum = whole;
  wrong_sum[whole.find("IEND") - 6] ^= 1;
  CHECK(refusal_of(wrong_sum).find("CRC") != std::string::npos);
}

TEST_CASE("rows missing from the pixel data are noticed") {
  const std::string rows = pass(5, 5, 0, 0, 1, 1);
  CHECK(
      refusal_of(png_maker::png(5, 6, 16, Colour::gray, rows)).starts_with("is not a PNG that can be read"));
}

TEST_CASE("what is written reads back; the same pixels give the same bytes") {
  const TemporaryFolder folder;
  Image<std::uint16_t> image = picture(37, 23);
  image.at(0, 0) = 0;
  image.at(36, 22) = 65535;
  REQUIRE(write_png16(folder / "a.png", image));
  CHECK(*read_depth_image(folder / "a.png") == image);
  // A view with gaps between its rows.
  Image<std::uint16_t> wide({50, 23}, 9);
  for (int y = 0; y < 23; ++y) {
    for (int x = 0; x < 37; ++x) wide.at(x, y) = image.at(x, y);
  }
  const ImageView<const std::uint16_t> part(wide.view().data, {37, 23}, 100);
  REQUIRE(write_png16(folder / "b.png", part));
  CHECK(bytes_of(folder / "a.png") == bytes_of(folder / "b.png"));
  CHECK(folder.count() == 2);
}

TEST_CASE("what cannot be written or read says so") {
  const TemporaryFolder folder;
  const auto nothing = write_png16(folder / "a.png", ImageView<const std::uint16_t>{});
  REQUIRE_FALSE(nothing);
  CHECK(nothing.failure().problem == Problem::bad_option);
  const auto nowhere = write_png16(folder / "no/a.png", picture(2, 2));
  REQUIRE_FALSE(nowhere);
  CHECK(nowhere.failure().problem == Problem::cannot_write);
  const auto missing = read_depth_image(folder / "none.png");
  REQUIRE_FALSE(missing);
  CHECK(missing.failure().problem == Problem::cannot_read);
  CHECK(missing.failure().sentence.find("none.png") != std::string::npos);
  CHECK(folder.count() == 0);
}

TEST_CASE("a frame must have the camera's size") {
  DepthCamera camera;
  camera.size = Size{640, 480};
  CHECK(read_depth_frame(fixtures + "mrpt_office/depth.png", camera));
  camera.size = Size{320, 240};
  const auto frame = read_depth_frame(fixtures + "mrpt_office/depth.png", camera);
  REQUIRE_FALSE(frame);
  CHECK(frame.failure().problem == Problem::bad_content);
  CHECK(frame.failure().sentence.ends_with("depth.png: has 640x480 pixels, and the camera has 320x240"));
}
