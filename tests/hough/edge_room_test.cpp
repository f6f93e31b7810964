// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <algorithm>

#include "hough_testing.hpp"

using namespace straightedge;
using test::EdgeImage;

namespace {

constexpr Size size{61, 47};  // no multiple of anything
constexpr std::ptrdiff_t stride = 83;
constexpr std::size_t guard = 64;

/// The methods that list the edge pixels.
std::vector<HoughOptions> listing_options() {
  HoughOptions progressive{.threshold = 12, .min_length = 12};
  HoughOptions as_opencv = progressive;
  as_opencv.generator = HoughGenerator::opencv;
  HoughOptions randomized = progressive;
  randomized.method = HoughMethod::randomized;
  randomized.max_draws = 50'000;
  return {progressive, as_opencv, randomized};
}

EdgeImage two_lines() {
  EdgeImage image(size);
  test::draw(image, 3, 5, 57, 20);
  test::draw(image, 8, 44, 50, 10);
  return image;
}

std::uint32_t edge_pixels(const EdgeImage& image) {
  return hough_lines(image).result.edge_pixels;
}

/// The picture's rows with bytes that are edges between them.
std::vector<std::uint8_t> with_stride(const EdgeImage& image) {
  std::vector<std::uint8_t> wide(static_cast<std::size_t>(stride * size.height), 0xFF);
  for (int y = 0; y < size.height; ++y)
    std::copy_n(image.view().row(y), size.width, wide.begin() + y * stride);
  return wide;
}

}  // namespace

TEST_CASE("more edge pixels than there is room for is told, and nothing is written") {
  const EdgeImage image = two_lines();
  const std::uint32_t count = edge_pixels(image);
  for (HoughOptions options : listing_options()) {
    INFO(static_cast<int>(options.method));
    const HoughFound all = hough_lines(image, options);
    REQUIRE(!all.segments.empty());
    for (const std::uint32_t room : {std::uint32_t{1}, count / 2, count - 1}) {
      options.max_edge_pixels = room;
      std::vector<std::byte> memory(HoughLines::workspace_bytes(size, options));
      HoughLines lines;
      REQUIRE(HoughLines::prepare(lines, size, options, memory) == Status::ok);
      const HoughPeak peak{-1, -2, -3};
      const HoughSegment segment{-1, -2, -3, -4, -5, -6};
      std::vector<HoughPeak> peaks(20, peak);
      std::vector<HoughSegment> segments(20, segment);
      const HoughResult result = lines.run(image, peaks, segments);
      CHECK(result.status == Status::too_large);
      CHECK(result.edge_pixels == count);
      CHECK(result.segments == 0);
      CHECK(result.peaks == 0);
      CHECK(std::count(peaks.begin(), peaks.end(), peak) == 20);
      CHECK(std::count(segments.begin(), segments.end(), segment) == 20);
      // The next picture may be a sparser one.
      CHECK(lines.run(EdgeImage(size), peaks, segments).status == Status::ok);
    }
    options.max_edge_pixels = count;
    CHECK(hough_lines(image, options).segments == all.segments);
    options.max_edge_pixels = 0xFFFFFFFF;
    CHECK(hough_lines(image, options).segments == all.segments);
  }
}

TEST_CASE("room for fewer edge pixels takes fewer bytes, and for more than there are pixels no more") {
  for (HoughOptions options : listing_options()) {
    const std::size_t all = HoughLines::workspace_bytes(size, options);
    options.max_edge_pixels = 61 * 47;
    CHECK(HoughLines::workspace_bytes(size, options) == all);
    options.max_edge_pixels = 0xFFFFFFFF;
    CHECK(HoughLines::workspace_bytes(size, options) == all);
    options.max_edge_pixels = 200;
    CHECK(HoughLines::workspace_bytes(size, options) < all - 4 * (61 * 47 - 200 - 64));
  }
}

TEST_CASE("a run stays within its workspace, whatever the rows' stride") {
  const EdgeImage image = two_lines();
  const std::vector<std::uint8_t> wide = with_stride(image);
  for (HoughOptions options : listing_options()) {
    INFO(static_cast<int>(options.method));
    options.max_edge_pixels = edge_pixels(image);
    const HoughFound tight = hough_lines(image, options);
    REQUIRE(!tight.segments.empty());
    const std::size_t bytes = HoughLines::workspace_bytes(size, options);
    for (std::size_t shift = 0; shift < 64; shift += 9) {
      std::vector<std::byte> memory(bytes + 2 * guard + shift, std::byte{0xCD});
      const std::span<std::byte> own(memory.data() + guard + shift, bytes);
      HoughLines lines;
      REQUIRE(HoughLines::prepare(lines, size, options, own) == Status::ok);
      std::vector<HoughPeak> peaks(50);
      std::vector<HoughSegment> segments(50);
      const HoughResult result = lines.run(GrayView(wide.data(), size, stride), peaks, segments);
      CHECK(result.status == Status::ok);
      segments.resize(result.segments);
      CHECK(segments == tight.segments);
      const auto untouched = [](std::byte b) { return b == std::byte{0xCD}; };
      CHECK(std::all_of(memory.data(), own.data(), untouched));
      CHECK(std::all_of(own.data() + bytes, memory.data() + memory.size(), untouched));
    }
  }
}

TEST_CASE("one byte less than room for the edge pixels is too small") {
  for (HoughOptions options : listing_options()) {
    options.max_edge_pixels = 100;
    const std::size_t bytes = HoughLines::workspace_bytes(size, options);
    std::vector<std::byte> memory(bytes + 64);
    const auto start = reinterpret_cast<std::uintptr_t>(memory.data());
    std::byte* worst = memory.data() + (65 - start % 64) % 64;  // an address that wastes most
    HoughLines lines;
    CHECK(HoughLines::prepare(lines, size, options, {worst, bytes}) == Status::ok);
    CHECK(HoughLines::prepare(lines, size, options, {worst, bytes - 1}) == Status::workspace_too_small);
    CHECK(lines.run(EdgeImage(size), {}, {}).status == Status::not_prepared);
  }
}
