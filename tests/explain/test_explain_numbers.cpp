// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <cstddef>
#include <vector>

#include "explained.hpp"
#include "straightedge/gaussian.hpp"
#include "straightedge/host/canny.hpp"

using namespace straightedge;

namespace {

struct Explained {
  explained::Page page;
  LineMapResult lines;
};

Explained explain(const Image<std::uint8_t>& image, const cli::ExplainOptions& options) {
  const TemporaryFolder folder;
  REQUIRE(cli::explain_image(image, options, folder / "out"));
  auto lines = build_line_map(image, options.lines);
  REQUIRE(lines);
  return {explained::read_page(folder / "out" / "index.html"), std::move(*lines)};
}

void check_fact(const explained::Page& page, const char* id, std::uint64_t value) {
  INFO(id);
  REQUIRE(page.facts.contains(id));
  CHECK(explained::digits(page.facts.at(id)) == std::to_string(value));
}

}  // namespace

TEST_CASE("the page's numbers are those of the line map's own run") {
  const auto name = GENERATE("images/blox.jpg", "images/pic5.png", "maps/mrpt/basic_map.png");
  cli::ExplainOptions options;
  options.lines.hough->method =
      GENERATE(HoughMethod::standard, HoughMethod::progressive, HoughMethod::randomized);
  INFO(name << ", method " << static_cast<int>(options.lines.hough->method));
  const auto [page, lines] = explain(explained::fixture(name), options);
  const LineMapReport& report = lines.report;
  check_fact(page, "strong", report.canny.strong);
  check_fact(page, "edges-count", report.canny.edges);
  check_fact(page, "segments-count", report.hough.segments);
  check_fact(page, "seed", report.hough.seed);
  check_fact(page, "candidates", report.candidates);
  check_fact(page, "straight", report.edges);
  check_fact(page, "merged", report.merged);
  check_fact(page, "too-short", report.too_short);
  check_fact(page, "map-segments", report.segments);
  check_fact(page, "map-lines", report.lines);
  CHECK(page.facts.contains("walls") == (report.picture == PictureKind::map));
  if (report.picture == PictureKind::map) {
    check_fact(page, "walls", report.walls);
    check_fact(page, "no-wall", report.no_wall);
    check_fact(page, "furniture", report.furniture);
  }
  if (options.lines.hough->method != HoughMethod::standard) check_fact(page, "draws", report.hough.draws);
}

TEST_CASE("the numbers of a photo's edges are those of canny") {
  const auto image = explained::fixture("images/blox.jpg");
  cli::ExplainOptions options;
  options.lines.canny = {.sigma = GENERATE(0.0, 1.4, 2.5),
                         .aperture = GENERATE(3, 5),
                         .norm = GENERATE(GradientNorm::l1, GradientNorm::l2),
                         .low = 100,
                         .high = 250.5};
  const auto page = explain(image, options).page;
  const CannyEdges expected = canny(image, options.lines.canny);
  REQUIRE(expected.result.status == Status::ok);
  check_fact(page, "edges-count", expected.result.edges);
  check_fact(page, "strong", expected.result.strong);
  CHECK(page.facts.at("low") == "100");
  CHECK(page.facts.at("high") == "250.5");

  std::vector<std::uint16_t> taps(static_cast<std::size_t>(gaussian_size(options.lines.canny.sigma)));
  REQUIRE(make_gaussian_kernel(options.lines.canny.sigma, taps) == Status::ok);
  std::string text;
  for (const std::uint16_t tap : taps) text.append(text.empty() ? "" : " ").append(std::to_string(tap));
  CHECK(page.facts.at("taps") == text);
}

TEST_CASE("automatic thresholds are told as such") {
  const auto image = explained::fixture("images/blox.jpg");
  cli::ExplainOptions options;
  options.lines.canny.thresholds = CannyThresholds::automatic;
  const auto page = explain(image, options).page;
  const CannyEdges expected = canny(image, options.lines.canny);
  CHECK(page.facts.at("thresholds-from") == "from the noise in the picture");
  CHECK(std::stod(page.facts.at("low")) == Approx(expected.result.low).margin(0.005));
  CHECK(std::stod(page.facts.at("high")) == Approx(expected.result.high).margin(0.005));
}
