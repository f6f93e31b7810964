// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <initializer_list>
#include <limits>

#include "hough_testing.hpp"

using namespace straightedge;
using test::EdgeImage;

namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr HoughMethod methods[] = {HoughMethod::standard, HoughMethod::progressive, HoughMethod::randomized};

Status status_with(const HoughOptions& options) {
  const EdgeImage image({20, 20}, 255);
  const Status status = hough_lines(image, options).result.status;
  CHECK((status == Status::ok) == (HoughLines::workspace_bytes({20, 20}, options) > 0));
  return status;
}

template <class T>
Status status_with(T HoughOptions::*member, T value) {
  HoughOptions options;
  options.*member = value;
  return status_with(options);
}

}  // namespace

TEST_CASE("options that are no numbers or out of range are refused") {
  using O = HoughOptions;
  for (const double bad : {not_a_number, infinite, -infinite, -1.0}) {
    INFO(bad);
    for (auto member : {&O::rho_step, &O::theta_step, &O::min_length, &O::max_gap, &O::half_width,
                        &O::min_support, &O::gradient_window, &O::min_theta, &O::max_theta, &O::pair_radius,
                        &O::pair_min_distance, &O::confidence})
      CHECK(status_with(member, bad) == Status::invalid_option);
  }
  for (const std::int32_t bad : std::initializer_list<std::int32_t>{0, -1, INT32_MIN}) {
    CHECK(status_with(&O::threshold, bad) == Status::invalid_option);
    CHECK(status_with(&O::pair_threshold, bad) == Status::invalid_option);
  }
  CHECK(status_with(&O::rho_step, 0.0) == Status::invalid_option);
  CHECK(status_with(&O::rho_step, 1e-300) == Status::invalid_option);
  CHECK(status_with(&O::rho_step, 1e300) == Status::invalid_option);
  CHECK(status_with(&O::theta_step, 0.0) == Status::invalid_option);
  CHECK(status_with(&O::theta_step, 4.0) == Status::invalid_option);
  CHECK(status_with(&O::confidence, 1.0) == Status::invalid_option);
  CHECK(status_with(&O::pair_min_distance, 30.0) == Status::invalid_option);
  CHECK(status_with(&O::method, static_cast<HoughMethod>(7)) == Status::invalid_option);
  CHECK(status_with(&O::generator, static_cast<HoughGenerator>(7)) == Status::invalid_option);
}

TEST_CASE("a range of angles needs room for one") {
  HoughOptions options;
  options.method = HoughMethod::standard;
  options.min_theta = 2;
  options.max_theta = 1;
  CHECK(status_with(options) == Status::invalid_option);
  options.max_theta = 2.001;
  CHECK(status_with(options) == Status::invalid_option);
}

TEST_CASE("accumulators and images beyond the limits are too large") {
  HoughOptions options;
  options.rho_step = 1e-3;
  options.theta_step = 1e-4;
  CHECK(hough_grid({1000, 1000}, options).status == Status::too_large);
  CHECK(HoughLines::workspace_bytes({1000, 1000}, options) == 0);
  CHECK(hough_grid({32767, 32767}, {}).status == Status::ok);
  CHECK(hough_grid({32768, 1}, {}).status == Status::too_large);
  CHECK(hough_grid({1, 2147483647}, {}).status == Status::too_large);
  CHECK(hough_grid({0, 5}, {}).status == Status::invalid_image);
  CHECK(hough_grid({5, -5}, {}).status == Status::invalid_image);
}

TEST_CASE("one byte too few is told") {
  for (const HoughMethod method : methods) {
    HoughOptions options;
    options.method = method;
    const std::size_t bytes = HoughLines::workspace_bytes({40, 30}, options);
    std::vector<std::byte> memory(bytes + 64);
    const auto start = reinterpret_cast<std::uintptr_t>(memory.data());
    std::byte* worst = memory.data() + (65 - start % 64) % 64;  // an address that wastes most
    HoughLines lines;
    CHECK(HoughLines::prepare(lines, {40, 30}, options, {worst, bytes}) == Status::ok);
    CHECK(HoughLines::prepare(lines, {40, 30}, options, {worst, bytes - 1}) == Status::workspace_too_small);
    const EdgeImage image({40, 30});
    CHECK(lines.run(image, {}, {}).status == Status::not_prepared);
  }
  static_assert(HoughLines::workspace_bytes({640, 480}, HoughOptions{}) > 640 * 480);
}

TEST_CASE("run without prepare, and views that do not fit") {
  HoughLines lines;
  const EdgeImage image({40, 30});
  CHECK(lines.run(image, {}, {}).status == Status::not_prepared);
  CHECK_FALSE(lines.accumulator().valid());

  HoughOptions options;
  options.gradient_window = 0.3;
  std::vector<std::byte> memory(HoughLines::workspace_bytes({40, 30}, options));
  REQUIRE(HoughLines::prepare(lines, {40, 30}, options, memory) == Status::ok);
  CHECK(lines.run(GrayView{}, {}, {}).status == Status::invalid_image);
  CHECK(lines.run(EdgeImage({30, 40}), {}, {}).status == Status::size_mismatch);
  CHECK(lines.run(image, {}, {}).status == Status::invalid_image);
  const test::ConstantGradient small({40, 29}, 0);
  const test::ConstantGradient right({40, 30}, 0);
  CHECK(lines.run(image, small.view(), {}, {}).status == Status::size_mismatch);
  CHECK(lines.run(image, right.view(), {}, {}).status == Status::ok);
  CHECK(hough_lines(GrayView{}).result.status == Status::invalid_image);
}

TEST_CASE("small, thin, blank and full images give a result") {
  const double steps[] = {0.5, 1, 7, 1000};
  for (const HoughMethod method : methods) {
    for (const Size size : {Size{1, 1}, Size{1, 2}, Size{1, 100}, Size{100, 1}, Size{9, 9}, Size{64, 48}}) {
      for (const double rho_step : steps) {
        HoughOptions options;
        options.method = method;
        options.rho_step = rho_step;
        options.threshold = 1;
        options.max_draws = 20'000;
        INFO(static_cast<int>(method) << " " << size.width << "x" << size.height << " " << rho_step);
        const HoughFound blank = hough_lines(EdgeImage(size), options);
        CHECK(blank.result.status == Status::ok);
        CHECK(blank.peaks.empty());
        CHECK(blank.segments.empty());
        CHECK(blank.result.edge_pixels == 0);
        const HoughFound full = hough_lines(EdgeImage(size, 1), options);
        CHECK(full.result.status == Status::ok);
        CHECK(full.result.edge_pixels == static_cast<std::uint32_t>(size.width * size.height));
      }
    }
  }
}

TEST_CASE("a minimum length beyond the image gives nothing") {
  EdgeImage image({64, 64});
  test::draw(image, 0, 0, 63, 63);
  for (const HoughMethod method : methods) {
    for (const HoughGenerator generator : {HoughGenerator::pcg32, HoughGenerator::opencv}) {
      HoughOptions options;
      options.method = method;
      options.generator = generator;
      options.threshold = 20;
      options.min_length = 1e9;
      options.max_draws = 20'000;
      const HoughFound found = hough_lines(image, options);
      CHECK(found.result.status == Status::ok);
      CHECK(found.segments.empty());
    }
  }
}

TEST_CASE("rows with a stride are read as such and bytes beside them stay untouched") {
  const EdgeImage image = [] {
    EdgeImage made = test::noise({37, 29}, 0.05, 5);
    test::draw(made, 2, 3, 34, 20);
    return made;
  }();
  for (const HoughMethod method : methods) {
    HoughOptions options;
    options.method = method;
    options.threshold = 12;
    options.min_length = 12;
    constexpr std::ptrdiff_t stride = 53;
    std::vector<std::uint8_t> wide(stride * 29, 0xAB);
    for (int y = 0; y < 29; ++y)
      for (int x = 0; x < 37; ++x) wide[static_cast<std::size_t>(y * stride + x)] = image.at(x, y);
    const HoughFound tight = hough_lines(image, options);

    std::vector<std::byte> memory(HoughLines::workspace_bytes({37, 29}, options) + 128, std::byte{0xCD});
    HoughLines lines;
    REQUIRE(HoughLines::prepare(lines, {37, 29}, options, {memory.data() + 64, memory.size() - 128}) ==
            Status::ok);
    std::vector<HoughPeak> peaks(100);
    std::vector<HoughSegment> segments(100);
    const HoughResult result = lines.run(GrayView(wide.data(), {37, 29}, stride), peaks, segments);
    REQUIRE(result.segments == tight.segments.size());
    REQUIRE(result.segments > 0);
    segments.resize(result.segments);
    CHECK(segments == tight.segments);
    for (std::size_t i = 0; i < 64; ++i) {
      REQUIRE(memory[i] == std::byte{0xCD});
      REQUIRE(memory[memory.size() - 1 - i] == std::byte{0xCD});
    }
  }
}

TEST_CASE("a full output keeps what came first, or the best peaks") {
  const EdgeImage image = [] {
    EdgeImage made({80, 80});
    for (int i = 0; i < 6; ++i) test::draw(made, 5, 5 + 12 * i, 40 + 6 * i, 5 + 12 * i);
    return made;
  }();
  for (const HoughMethod method : methods) {
    HoughOptions options;
    options.method = method;
    options.threshold = 25;
    const HoughFound all = hough_lines(image, options);
    REQUIRE(all.segments.size() >= 6);
    std::vector<std::byte> memory(HoughLines::workspace_bytes({80, 80}, options));
    HoughLines lines;
    REQUIRE(HoughLines::prepare(lines, {80, 80}, options, memory) == Status::ok);
    std::vector<HoughPeak> peaks(method == HoughMethod::randomized ? 100 : 3);
    std::vector<HoughSegment> segments(2);
    const HoughResult result = lines.run(image, peaks, segments);
    CHECK(result.status == Status::output_full);
    REQUIRE(result.segments == 2);
    CHECK(segments[0] == all.segments[0]);
    CHECK(segments[1] == all.segments[1]);
    for (std::size_t i = 0; i < result.peaks; ++i) CHECK(peaks[i] == all.peaks[i]);
  }
}
