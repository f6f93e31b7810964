// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <vector>

#include "straightedge/gray.hpp"
#include "support/catch.hpp"
#include "support/guarded_image.hpp"

using namespace straightedge;

TEST_CASE("white stays white, black stays black, colours get their weight") {
  const std::uint8_t pixels[] = {255, 255, 255, 0, 0, 0, 255, 0, 0, 0, 255, 0, 0, 0, 255};
  support::GuardedImage<std::uint8_t> gray({5, 1});
  REQUIRE(gray_from_color({pixels, 5, 1, 15, PixelFormat::rgb}, gray.view()) == Status::ok);
  const int expected[] = {255, 0, 76, 150, 29};
  for (int x = 0; x < 5; ++x) CHECK(gray.at(x, 0) == expected[x]);
}

TEST_CASE("the order of channels and alpha") {
  const std::uint8_t pixels[] = {10, 100, 200, 7, 200, 100, 10, 250};
  support::GuardedImage<std::uint8_t> rgba({2, 1}), bgra({2, 1});
  REQUIRE(gray_from_color({pixels, 2, 1, 8, PixelFormat::rgba}, rgba.view()) == Status::ok);
  REQUIRE(gray_from_color({pixels, 2, 1, 8, PixelFormat::bgra}, bgra.view()) == Status::ok);
  CHECK(rgba.at(0, 0) == bgra.at(1, 0));
  CHECK(rgba.at(1, 0) == bgra.at(0, 0));
  CHECK(rgba.at(0, 0) == (9798 * 10 + 19235 * 100 + 3735 * 200 + 16384) / 32768);
}

TEST_CASE("even gray keeps its value in any format") {
  for (int level = 0; level < 256; ++level) {
    const std::vector<std::uint8_t> pixels(4, static_cast<std::uint8_t>(level));
    for (const PixelFormat format :
         {PixelFormat::gray, PixelFormat::rgb, PixelFormat::bgr, PixelFormat::rgba}) {
      support::GuardedImage<std::uint8_t> gray({1, 1});
      REQUIRE(gray_from_color({pixels.data(), 1, 1, 4, format}, gray.view()) == Status::ok);
      CHECK(gray.at(0, 0) == level);
    }
  }
}

TEST_CASE("rows with gaps") {
  std::vector<std::uint8_t> pixels(2 * 10, 99);
  for (std::size_t i = 0; i < 6; ++i) pixels[i] = pixels[10 + i] = static_cast<std::uint8_t>(i < 3 ? 50 : 60);
  support::GuardedImage<std::uint8_t> gray({2, 2}, 3);
  REQUIRE(gray_from_color({pixels.data(), 2, 2, 10, PixelFormat::bgr}, gray.view()) == Status::ok);
  CHECK(gray.at(0, 1) == 50);
  CHECK(gray.at(1, 1) == 60);
  CHECK(gray.guards_intact());
}

TEST_CASE("views that make no sense are refused") {
  const std::uint8_t pixels[12] = {};
  support::GuardedImage<std::uint8_t> gray({2, 2});
  CHECK(gray_from_color({nullptr, 2, 2, 6, PixelFormat::rgb}, gray.view()) == Status::invalid_image);
  CHECK(gray_from_color({pixels, 2, 2, 5, PixelFormat::rgb}, gray.view()) == Status::invalid_image);
  CHECK(gray_from_color({pixels, 0, 2, 6, PixelFormat::rgb}, gray.view()) == Status::invalid_image);
  CHECK(gray_from_color({pixels, 2, 2, 6, static_cast<PixelFormat>(9)}, gray.view()) ==
        Status::invalid_image);
  CHECK(gray_from_color({pixels, 2, 2, 6, PixelFormat::rgb}, {}) == Status::invalid_image);
  CHECK(gray_from_color({pixels, 1, 2, 6, PixelFormat::rgb}, gray.view()) == Status::size_mismatch);
}
