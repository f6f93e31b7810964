// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "straightedge/host/image_file.hpp"

#include <string>

#include "catch.hpp"
#include "png_maker.hpp"
#include "temporary_folder.hpp"

using namespace straightedge;

namespace {

const std::string images = std::string(STRAIGHTEDGE_FIXTURES) + "/images/";
const std::string zero(1, '\0');

int luma(int r, int g, int b) {
  return (9798 * r + 19235 * g + 3735 * b + 16384) >> 15;
}

Image<std::uint8_t> decoded(const std::string& bytes) {
  const auto image = decode_gray_image(bytes, "x.png");
  if (!image) FAIL(image.failure().sentence);
  return *image;
}

void refused(const std::string& bytes, const std::string& part) {
  const auto image = decode_gray_image(bytes, "x.png");
  REQUIRE_FALSE(image);
  CHECK(image.failure().problem == Problem::bad_content);
  INFO(image.failure().sentence);
  CHECK(image.failure().sentence.starts_with("x.png: "));
  CHECK(image.failure().sentence.find(part) != std::string::npos);
}

}  // namespace

TEST_CASE("PNG in every kind of pixel becomes 8-bit gray") {
  using namespace png_maker;
  SECTION("8-bit gray, as it is") {
    const auto image = decoded(png(2, 1, 8, gray, zero + "\x05\xFA"));
    CHECK(image.at(0, 0) == 5);
    CHECK(image.at(1, 0) == 250);
  }
  SECTION("one bit is black or white") {
    const auto image = decoded(png(3, 1, 1, gray, zero + "\xA0"));
    CHECK(image.at(0, 0) == 255);
    CHECK(image.at(1, 0) == 0);
    CHECK(image.at(2, 0) == 255);
  }
  SECTION("16-bit gray keeps the upper byte") {
    const auto image = decoded(png(3, 1, 16, gray, zero + "\x12\x34" + "\xFF\xFF" + zero + "\xFF"));
    CHECK(image.at(0, 0) == 0x12);
    CHECK(image.at(1, 0) == 0xFF);
    CHECK(image.at(2, 0) == 0);
  }
  SECTION("16-bit colour: upper bytes first, then the weights") {
    const auto image = decoded(png(1, 1, 16, rgb, zero + "\x0A\xFF" + "\xC8\xFF" + "\x64\xFF"));
    CHECK(image.at(0, 0) == luma(10, 200, 100));
  }
  SECTION("alpha is ignored") {
    CHECK(decoded(png(1, 1, 8, gray_alpha, zero + "\x2A" + zero)).at(0, 0) == 42);
    CHECK(decoded(png(1, 1, 8, rgb_alpha, zero + "\x0A\xC8\x64" + zero)).at(0, 0) == luma(10, 200, 100));
  }
  SECTION("a palette is looked up") {
    const std::string colours = chunk("PLTE", std::string("\x01\x02\x03\xC8\x64\x32"));
    const auto image = decoded(png(2, 1, 8, palette, zero + "\x01" + zero, colours));
    CHECK(image.at(0, 0) == luma(200, 100, 50));
    CHECK(image.at(1, 0) == luma(1, 2, 3));
  }
}

TEST_CASE("shipped pictures have their sizes") {
  const auto size_of = [](const char* name) {
    const auto image = read_gray_image(images + name);
    if (!image) FAIL(image.failure().sentence);
    return image->size();
  };
  CHECK(size_of("building.jpg") == Size{868, 600});
  CHECK(size_of("left01.jpg") == Size{640, 480});
  CHECK(size_of("sudoku.png") == Size{558, 563});
  CHECK(size_of("../maps/mrpt_corridor/map.png") == Size{1500, 620});
}

TEST_CASE("files that cannot be opened are named with the system's reason") {
  const TemporaryFolder folder;
  const auto missing = read_gray_image("maps/no-such-floor.png");
  REQUIRE_FALSE(missing);
  CHECK(missing.failure().problem == Problem::cannot_read);
  CHECK(missing.failure().sentence == "maps/no-such-floor.png: cannot be opened (No such file or directory)");
  const auto directory = read_gray_image(folder.path());
  REQUIRE_FALSE(directory);
  CHECK(directory.failure().problem == Problem::cannot_read);
  CHECK(directory.failure().sentence == folder.path().string() + ": cannot be read (Is a directory)");
}

TEST_CASE("what is no image is refused") {
  refused("", "is empty");
  refused("This is a text, not an image.\n", "is not an image that can be read");
  refused("<?xml version=\"1.0\"?><map/>", "is not an image that can be read");
  refused(std::string(1000, '\0'), "is not an image that can be read");
  refused("P7\nWIDTH 2\n", "is not an image that can be read");
}

TEST_CASE("truncated files are refused, wherever they end") {
  for (const char* name : {"camera.png", "pic1.png", "home.jpg", "left01.jpg"}) {
    const std::string bytes = bytes_of(images + name);
    REQUIRE(bytes.size() > 1000);
    INFO(name);
    for (const double share : {0.0005, 0.01, 0.3, 0.6, 0.9, 0.99}) {
      INFO(share);
      refused(bytes.substr(0, static_cast<std::size_t>(share * static_cast<double>(bytes.size()))),
              "x.png: ");
    }
  }
}

TEST_CASE("BMP and TGA are read, and refused when they are truncated") {
  const std::string rows = std::string("\x0A\xC8\x64") + "\x64\xC8\x0A" + zero + zero;  // blue, green, red
  std::string bmp = "BM" + std::string(52, '\0') + rows;
  bmp[10] = 54;
  bmp[14] = 40;
  bmp[18] = 2;
  bmp[22] = 1;
  bmp[26] = 1;
  bmp[28] = 24;
  CHECK(decoded(bmp).size() == Size{2, 1});
  CHECK(decoded(bmp).at(0, 0) == luma(0x64, 0xC8, 0x0A));
  refused(bmp.substr(0, bmp.size() - 3), "it is truncated");

  std::string tga(18, '\0');
  tga[2] = 3;
  tga[12] = 3;
  tga[14] = 1;
  tga[16] = 8;
  tga += "\x05\x06\x07";
  CHECK(decoded(tga).at(2, 0) == 7);
  refused(tga.substr(0, tga.size() - 1), "it is truncated");
  tga[13] = 0x10;  // 4099 pixels wide
  refused(tga, "it is truncated");
}

TEST_CASE("a JPEG whose Huffman table overflows stb's is refused before stb sees it") {
  std::string jpeg = bytes_of(images + "blox.jpg");
  const std::size_t table = jpeg.find("\xFF\xC4");
  REQUIRE(table != std::string::npos);
  jpeg[table + 5 + 15] = '\xFF';
  jpeg[table + 5 + 14] = '\xFF';
  refused(jpeg, "a Huffman table has too many codes");
}

TEST_CASE("a size above the limit is refused by the header alone") {
  refused(png_maker::png(20000, 20000, 8, png_maker::gray, zero),
          "is too large: 20000x20000 pixels, and at most 2^28 are read");
  refused(png_maker::png(0x7FFFFFFF, 0x7FFFFFFF, 8, png_maker::gray, zero), "x.png: ");
  refused(png_maker::png(16384, 16384, 8, png_maker::gray, zero), "is not an image that can be read");
}

TEST_CASE("what is written reads back, and the same picture gives the same bytes") {
  const TemporaryFolder folder;
  Image<std::uint8_t> gray({37, 23});
  Image<Rgb> colour({37, 23});
  for (int y = 0; y < 23; ++y) {
    for (int x = 0; x < 37; ++x) {
      gray.at(x, y) = static_cast<std::uint8_t>(x * 7 + y * 31);
      colour.at(x, y) = {static_cast<unsigned char>(x * 5), static_cast<unsigned char>(y * 9), 77};
    }
  }
  REQUIRE(write_png(folder / "gray.png", gray));
  REQUIRE(write_png(folder / "again.png", gray));
  CHECK(bytes_of(folder / "gray.png") == bytes_of(folder / "again.png"));
  const auto gray_read = read_gray_image(folder / "gray.png");
  REQUIRE(gray_read);
  CHECK(*gray_read == gray);

  REQUIRE(write_png(folder / "colour.png", colour.view()));
  const auto colour_read = read_gray_image(folder / "colour.png");
  REQUIRE(colour_read);
  CHECK(colour_read->at(30, 20) == luma(150, 180, 77));
}

TEST_CASE("a view with a stride and a single pixel can be written") {
  const std::uint8_t pixels[] = {1, 2, 99, 3, 4, 99};
  const auto png = encode_png(GrayView(pixels, {2, 2}, 3));
  REQUIRE(png);
  const auto image = decoded(*png);
  CHECK(image.at(1, 0) == 2);
  CHECK(image.at(0, 1) == 3);
  const auto one = encode_png(GrayView(pixels, {1, 1}));
  REQUIRE(one);
  CHECK(decoded(*one).size() == Size{1, 1});
}

TEST_CASE("no image and no folder are sentences") {
  const TemporaryFolder folder;
  const auto nothing = write_png(folder / "x.png", GrayView{});
  REQUIRE_FALSE(nothing);
  CHECK(nothing.failure().problem == Problem::bad_option);
  const Image<std::uint8_t> image({2, 2});
  const auto nowhere = write_png(folder / "missing/x.png", image);
  REQUIRE_FALSE(nowhere);
  CHECK(nowhere.failure().problem == Problem::cannot_write);
  CHECK(folder.count() == 0);
}
