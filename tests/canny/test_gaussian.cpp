// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <limits>
#include <numeric>

#include "canny/stages.hpp"
#include "support/catch.hpp"

using namespace stages;

TEST_CASE("kernels that are known") {
  CHECK(kernel(5, 1.4) == std::vector<std::uint16_t>{28, 61, 78, 61, 28});
  CHECK(kernel(5, 1.0) == std::vector<std::uint16_t>{14, 62, 104, 62, 14});
  CHECK(kernel(3, 0.8) == std::vector<std::uint16_t>{61, 134, 61});
  CHECK(kernel(3, 1.4) == std::vector<std::uint16_t>{78, 100, 78});
  CHECK(kernel(7, 1.4) == std::vector<std::uint16_t>{7, 27, 57, 74, 57, 27, 7});
  CHECK(kernel(1, 0) == std::vector<std::uint16_t>{256});
  CHECK(kernel(1, 3) == std::vector<std::uint16_t>{256});
  CHECK(kernel(3, 0) == std::vector<std::uint16_t>{64, 128, 64});
  CHECK(kernel(5, 0) == std::vector<std::uint16_t>{16, 64, 96, 64, 16});
  CHECK(kernel(9, 0) == std::vector<std::uint16_t>{4, 13, 30, 51, 60, 51, 30, 13, 4});
}

TEST_CASE("every kernel adds up to 256, is even and falls to the sides") {
  for (int size = 1; size <= max_gaussian_size; size += size < 41 ? 2 : 20) {
    for (double sigma = 0.05; sigma <= max_gaussian_sigma; sigma *= 1.19) {
      const std::vector<std::uint16_t> taps = kernel(size, sigma);
      CAPTURE(size, sigma);
      REQUIRE(taps.size() == static_cast<std::size_t>(size));
      REQUIRE(std::accumulate(taps.begin(), taps.end(), 0) == 256);
      REQUIRE(std::vector<std::uint16_t>(taps.rbegin(), taps.rend()) == taps);
    }
  }
}

TEST_CASE("the size that a sigma asks for") {
  CHECK(gaussian_size(0) == 1);
  CHECK(gaussian_size(0.05) == 1);
  CHECK(gaussian_size(1.4) == 9);
  CHECK(gaussian_size(1) == 7);
  CHECK(gaussian_size(2.25) == 15);  // 14.5 goes to the even 14, which is made odd
  CHECK(gaussian_size(50) == max_gaussian_size);
  CHECK(gaussian_size(-0.1) == 0);
  CHECK(gaussian_size(51) == 0);
  CHECK(gaussian_size(std::numeric_limits<double>::quiet_NaN()) == 0);
}

TEST_CASE("kernels that cannot be made") {
  std::vector<std::uint16_t> taps(303);
  const auto make = [&](double sigma, std::size_t size) {
    return make_gaussian_kernel(sigma, std::span(taps).first(size));
  };
  CHECK(make(1, 301) == Status::ok);
  CHECK(make(1, 0) == Status::invalid_option);
  CHECK(make(1, 4) == Status::invalid_option);
  CHECK(make(1, 303) == Status::invalid_option);
  CHECK(make(-1, 5) == Status::invalid_option);
  CHECK(make(50.1, 5) == Status::invalid_option);
  CHECK(make(std::numeric_limits<double>::quiet_NaN(), 5) == Status::invalid_option);
}

TEST_CASE("an even area keeps its gray value") {
  for (const int level : {0, 1, 127, 255}) {
    const GrayImage gray({7, 5}, 4, static_cast<std::uint8_t>(level));
    for (const double sigma : {0.5, 1.4, 8.0}) {
      for (const Border border : {Border::replicate, Border::reflect, Border::reflect_101}) {
        GrayImage out({7, 5}, 1);
        REQUIRE(blur(gray.view(), kernel(gaussian_size(sigma), sigma), border, out.view()) == Status::ok);
        CHECK(out == gray);
        CHECK(out.guards_intact());
      }
    }
  }
}

TEST_CASE("bad input to the blur") {
  const GrayImage gray({7, 5});
  GrayImage out({7, 5}), other({5, 7});
  const std::vector<std::uint16_t> taps = kernel(5, 1);
  CHECK(blur(gray.view(), taps, Border::reflect, other.view()) == Status::size_mismatch);
  CHECK(blur(GrayView(), taps, Border::reflect, out.view()) == Status::invalid_image);
  CHECK(blur(gray.view(), taps, Border::reflect, {}) == Status::invalid_image);
  CHECK(blur(gray.view(), taps, static_cast<Border>(7), out.view()) == Status::invalid_option);
  CHECK(blur(gray.view(), {}, Border::reflect, out.view()) == Status::invalid_option);
  CHECK(blur(gray.view(), {64, 64, 64, 64}, Border::reflect, out.view()) == Status::invalid_option);
  CHECK(blur(gray.view(), {64, 127, 64}, Border::reflect, out.view()) == Status::invalid_option);
  std::vector<std::uint16_t> columns(11);
  std::vector<std::uint32_t> sums(7);
  const auto with = [&](std::size_t n, std::size_t m) {
    return gaussian_blur(gray.view(), taps, Border::reflect,
                         {std::span(columns).first(n), std::span(sums).first(m)}, out.view());
  };
  CHECK(with(11, 7) == Status::ok);
  CHECK(with(10, 7) == Status::workspace_too_small);
  CHECK(with(11, 6) == Status::workspace_too_small);
}
