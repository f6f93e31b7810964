// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <algorithm>

#include "hough_testing.hpp"

using namespace straightedge;
using test::EdgeImage;

namespace {

constexpr HoughMethod methods[] = {HoughMethod::standard, HoughMethod::progressive, HoughMethod::randomized};

struct Ends {
  int x0, y0, x1, y1;
};

constexpr Ends drawing[] = {{10, 20, 90, 20}, {30, 30, 30, 100}, {50, 40, 100, 90}, {110, 112, 155, 67}};

EdgeImage draw_all(Size size, int dx, int dy) {
  EdgeImage image(size);
  for (const Ends& e : drawing) test::draw(image, e.x0 + dx, e.y0 + dy, e.x1 + dx, e.y1 + dy);
  return image;
}

HoughOptions options_for(HoughMethod method) {
  HoughOptions options;
  options.method = method;
  options.threshold = 35;
  options.max_gap = 3;
  return options;
}

}  // namespace

TEST_CASE("the votes are those of a count cell by cell") {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const EdgeImage image = test::noise({37, 53}, 0.1, seed);
    HoughOptions options;
    options.method = HoughMethod::standard;
    options.rho_step = seed == 1 ? 1 : 0.7;
    std::vector<std::byte> memory(HoughLines::workspace_bytes(image.size(), options));
    HoughLines lines;
    REQUIRE(HoughLines::prepare(lines, image.size(), options, memory) == Status::ok);
    REQUIRE(lines.run(image, {}, {}).status == Status::ok);
    const auto cells = lines.accumulator();
    const auto step = static_cast<double>(lines.grid().rho_step);
    // A pixel less than 1e-4 of a cell from a border may be counted on either side of it.
    float angle = 0;
    for (int n = 0; n < cells.height; ++n, angle += lines.grid().theta_step) {
      const auto theta = static_cast<double>(angle);
      for (int r = 0; r < cells.width; ++r) {
        int sure = 0;
        int possible = 0;
        for (int y = 0; y < 53; ++y) {
          for (int x = 0; x < 37; ++x) {
            if (image.at(x, y) == 0) continue;
            const double rho = (x * std::cos(theta) + y * std::sin(theta)) / step;
            const double off = std::fabs(rho + (cells.width - 1) / 2 - r);
            sure += off < 0.4999 ? 1 : 0;
            possible += off < 0.5001 ? 1 : 0;
          }
        }
        INFO("seed " << seed << " angle " << n << " distance " << r);
        REQUIRE(cells.at(r, n) >= sure);
        REQUIRE(cells.at(r, n) <= possible);
      }
    }
  }
}

TEST_CASE("a peak is a cell above its neighbours, and the peaks are in order") {
  const EdgeImage image = test::noise({60, 40}, 0.15, 9);
  HoughOptions options;
  options.method = HoughMethod::standard;
  options.threshold = 12;
  std::vector<std::byte> memory(HoughLines::workspace_bytes(image.size(), options));
  HoughLines lines;
  REQUIRE(HoughLines::prepare(lines, image.size(), options, memory) == Status::ok);
  std::vector<HoughPeak> peaks(5000);
  const HoughResult result = lines.run(image, peaks, {});
  REQUIRE(result.status == Status::ok);
  peaks.resize(result.peaks);

  const auto cells = lines.accumulator();
  const auto at = [&](int r, int n) { return cells.contains(r, n) ? cells.at(r, n) : 0; };
  std::vector<HoughPeak> expected;
  for (int n = 0; n < cells.height; ++n) {
    for (int r = 0; r < cells.width; ++r) {
      const int votes = at(r, n);
      if (votes > 12 && votes > at(r - 1, n) && votes >= at(r + 1, n) && votes > at(r, n - 1) &&
          votes >= at(r, n + 1))
        expected.push_back({static_cast<float>(r - (cells.width - 1) / 2),
                            static_cast<float>(n) * lines.grid().theta_step, votes});
    }
  }
  std::stable_sort(expected.begin(), expected.end(),
                   [](const HoughPeak& a, const HoughPeak& b) { return a.votes > b.votes; });
  REQUIRE(expected.size() > 20);
  CHECK(peaks == expected);

  // The best few of a full output are the first few of all.
  std::vector<HoughPeak> few(7);
  CHECK(lines.run(image, few, {}).status == Status::output_full);
  CHECK(std::equal(few.begin(), few.end(), expected.begin()));
}

TEST_CASE("shifting the image shifts the lines") {
  const int shifts[][2] = {{0, 0}, {1, 0}, {0, 1}, {17, 5}, {40, 33}};
  for (const HoughMethod method : methods) {
    for (const auto& shift : shifts) {
      const EdgeImage image = draw_all({200, 170}, shift[0], shift[1]);
      const HoughFound found = hough_lines(image, options_for(method));
      INFO(static_cast<int>(method) << " shifted by " << shift[0] << ", " << shift[1]);
      CHECK(found.segments.size() == std::size(drawing));
      for (const Ends& e : drawing) {
        const bool there = std::any_of(found.segments.begin(), found.segments.end(), [&](const auto& s) {
          return test::same_ends(s, e.x0 + shift[0], e.y0 + shift[1], e.x1 + shift[0], e.y1 + shift[1], 2);
        });
        CHECK(there);
      }
    }
  }
}

TEST_CASE("nearly vertical lines are found on both sides of the seam at pi") {
  for (const HoughMethod method : methods) {
    for (int lean = -4; lean <= 4; ++lean) {
      for (const int x : {20, 60, 100}) {
        EdgeImage image({121, 161});
        test::draw(image, x - lean, 10, x + lean, 150);
        HoughOptions options = options_for(method);
        // The progressive walk is one pixel wide and leaves a leaning line early: it finds pieces.
        if (method == HoughMethod::progressive) options.min_length = 10;
        const HoughFound found = hough_lines(image, options);
        INFO(static_cast<int>(method) << " x " << x << " lean " << lean);
        double together = 0;
        for (const HoughSegment& s : found.segments) together += test::length(s);
        CHECK(together > (method == HoughMethod::progressive ? 60 : 100));
        if (method == HoughMethod::randomized) {
          CHECK(found.segments.size() == 1);
          CHECK(test::same_ends(found.segments[0], x - lean, 10, x + lean, 150, 1.5));
        }
      }
    }
  }
}

TEST_CASE("one seed gives one result, whatever the memory held before") {
  EdgeImage image = test::noise({160, 120}, 0.04, 3);
  test::draw(image, 5, 5, 150, 100);
  test::draw(image, 150, 10, 20, 115);
  for (const HoughMethod method : methods) {
    HoughOptions options = options_for(method);
    options.seed = 12345;
    const HoughFound first = hough_lines(image, options);
    std::vector<std::byte> memory(HoughLines::workspace_bytes(image.size(), options), std::byte{0xA5});
    HoughLines lines;
    REQUIRE(HoughLines::prepare(lines, image.size(), options, memory) == Status::ok);
    for (int run = 0; run < 3; ++run) {
      std::vector<HoughPeak> peaks(5000);
      std::vector<HoughSegment> segments(5000);
      const HoughResult result = lines.run(image, peaks, segments);
      peaks.resize(result.peaks);
      segments.resize(result.segments);
      CHECK(peaks == first.peaks);
      CHECK(segments == first.segments);
      CHECK(result.draws == first.result.draws);
    }
  }
}
