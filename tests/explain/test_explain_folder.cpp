// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <unistd.h>

#include <cmath>
#include <limits>

#include "explained.hpp"

using namespace straightedge;
namespace fs = std::filesystem;

namespace {

std::set<std::string> names_in(const fs::path& folder) {
  std::set<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder)) names.insert(entry.path().filename().string());
  return names;
}

/// Explains and checks what must hold for every picture: the files are those that the page shows, each
/// decodes and has the size that the page states, and nothing points out of the folder.
explained::Page explain_and_check(GrayView gray, const cli::ExplainOptions& options, const fs::path& folder) {
  const auto done = cli::explain_image(gray, options, folder);
  INFO((done ? "" : done.failure().sentence));
  REQUIRE(done);
  const explained::Page page = explained::read_page(folder / "index.html");
  std::set<std::string> files = page.pictures;
  files.insert("index.html");
  CHECK(names_in(folder) == files);
  for (const std::string& picture : page.pictures) {
    INFO(picture);
    const auto image = read_gray_image(folder / picture);
    REQUIRE(image);
    const std::string size = "src=\"" + picture + "\" width=\"" + std::to_string(image->width()) +
                             "\" height=\"" + std::to_string(image->height()) + "\"";
    CHECK(page.text.find(size) != std::string::npos);
  }
  for (const std::string& link : page.links) {
    const bool known =
        link.starts_with("#") ? page.facts.contains(link.substr(1)) : page.pictures.contains(link);
    CHECK(known);
  }
  CHECK(page.text.find("http") == std::string::npos);
  CHECK(page.text.starts_with("<!DOCTYPE html>"));
  return page;
}

}  // namespace

TEST_CASE("a photo gives a page with every stage") {
  const TemporaryFolder folder;
  const auto page = explain_and_check(explained::fixture("images/blox.jpg"),
                                      {.input = "blox.jpg", .version = "9.8"}, folder / "out");
  auto expected = explained::photo_pictures;
  expected.insert(explained::progress_pictures.begin(), explained::progress_pictures.end());
  CHECK(page.pictures == expected);
  CHECK(page.facts.at("kind") == "a photo");
  CHECK(page.text.find("straightedge 9.8") != std::string::npos);
}

TEST_CASE("a map shows its ground, too") {
  const TemporaryFolder folder;
  const auto page = explain_and_check(explained::fixture("maps/mrpt/basic_map.png"),
                                      {.input = "basic_map.png"}, folder / "out");
  auto expected = explained::photo_pictures;
  expected.insert("ground.png");
  expected.insert(explained::progress_pictures.begin(), explained::progress_pictures.end());
  CHECK(page.pictures == expected);
  CHECK(page.facts.at("kind") == "a map");
}

TEST_CASE("every method can be explained") {
  const TemporaryFolder folder;
  const auto method = GENERATE(HoughMethod::standard, HoughMethod::progressive, HoughMethod::randomized);
  cli::ExplainOptions options;
  options.lines.hough->method = method;
  const auto page = explain_and_check(explained::fixture("images/pic5.png"), options, folder / "out");
  const char* names[] = {"standard", "progressive", "randomized"};
  CHECK(page.facts.at("method") == names[static_cast<int>(method)]);
  CHECK(page.facts.at("threshold") == (method == HoughMethod::randomized ? "3 pairs" : "14 votes"));
}

TEST_CASE("pictures without any content are explained") {
  const TemporaryFolder folder;
  const Size size = GENERATE(Size{1, 1}, Size{1, 40}, Size{40, 1}, Size{3, 2}, Size{64, 48});
  const auto value = GENERATE(std::uint8_t{0}, std::uint8_t{128}, std::uint8_t{255});
  const Image<std::uint8_t> blank(size, value);
  const auto page = explain_and_check(blank, {}, folder / "out");
  CHECK(page.facts.at("edges-count") == "0");
  CHECK(page.facts.at("segments-count") == "0");
  CHECK(page.facts.at("map-lines") == "0");
  CHECK(page.text.find("there is no line in this picture") != std::string::npos);
}

TEST_CASE("thresholds above every gradient are explained") {
  const TemporaryFolder folder;
  cli::ExplainOptions options;
  options.lines.canny.low = options.lines.canny.high = std::numeric_limits<double>::infinity();
  const auto page = explain_and_check(explained::fixture("images/pic5.png"), options, folder / "out");
  CHECK(page.facts.at("high") == "infinite");
  CHECK(page.facts.at("edges-count") == "0");
}

TEST_CASE("names are escaped") {
  const TemporaryFolder folder;
  const std::string name = "<script>alert('&')</script>\xff\".png";
  const auto page = explain_and_check(Image<std::uint8_t>(Size{8, 8}), {.input = name}, folder / "out");
  CHECK(page.text.find("<script>alert") == std::string::npos);
  CHECK(page.facts.at("input") == "<script>alert('&')</script>\uFFFD\".png");
  CHECK(page.elements.at("script") == 1);
}

TEST_CASE("the same picture gives the same bytes, and an old folder is replaced") {
  const TemporaryFolder folder;
  const auto image = explained::fixture("images/pic5.png");
  fs::create_directories(folder / "b");
  folder.put("b/index.html", "old");
  explain_and_check(image, {}, folder / "a");
  explain_and_check(image, {}, folder / "b");
  for (const std::string& name : names_in(folder / "a")) {
    INFO(name);
    CHECK(bytes_of(folder / "a" / name) == bytes_of(folder / "b" / name));
  }
}

TEST_CASE("pictures of an older run do not stay") {
  const TemporaryFolder folder;
  explain_and_check(explained::fixture("maps/mrpt/basic_map.png"), {}, folder / "out");
  cli::ExplainOptions options;
  options.lines.hough->method = HoughMethod::standard;
  const auto page = explain_and_check(explained::fixture("images/pic5.png"), options, folder / "out");
  CHECK(page.pictures == explained::photo_pictures);
}

TEST_CASE("options that are wrong leave no trace") {
  const TemporaryFolder folder;
  const auto image = explained::fixture("images/pic5.png");
  cli::ExplainOptions options;
  SECTION("low above high") {
    options.lines.canny.low = 1000;
  }
  SECTION("NaN") {
    options.lines.canny.high = std::nan("");
  }
  SECTION("threshold 0") {
    options.lines.hough->threshold = 0;
  }
  SECTION("no votes") {
    options.lines.hough.reset();
  }
  SECTION("sigma") {
    options.lines.canny.sigma = -1;
  }
  SECTION("length") {
    options.lines.min_length = 0;
  }
  const auto done = cli::explain_image(image, options, folder / "out");
  REQUIRE_FALSE(done);
  CHECK(done.failure().problem == Problem::bad_option);
  CHECK(folder.count() == 0);
}

TEST_CASE("a folder that cannot be written is one sentence and no trace") {
  const TemporaryFolder folder;
  const auto image = explained::fixture("images/pic5.png");
  fs::path target;
  SECTION("a file is in the way") {
    target = folder.put("file", "text");
  }
  SECTION("a file is in the way above") {
    target = folder.put("file", "text") / "out";
  }
  SECTION("a name is too long") {
    target = folder / std::string(300, 'x');
  }
  SECTION("no name") {
    target = "";
  }
  const auto before = folder.count();
  const auto done = cli::explain_image(image, {}, target);
  REQUIRE_FALSE(done);
  CHECK(done.failure().problem == Problem::cannot_write);
  CHECK(done.failure().sentence.find(target.string()) != std::string::npos);
  CHECK(folder.count() == before);
}

TEST_CASE("a picture that cannot be replaced keeps the old page away from new pictures") {
  const TemporaryFolder folder;
  fs::create_directories(folder / "out" / "lines.png");  // a folder where a file should go
  folder.put("out/index.html", "old");
  const auto done = cli::explain_image(explained::fixture("images/pic5.png"), {}, folder / "out");
  REQUIRE_FALSE(done);
  CHECK(done.failure().problem == Problem::cannot_write);
  CHECK_FALSE(fs::exists(folder / "out" / "index.html"));
  CHECK(fs::is_directory(folder / "out" / "lines.png"));
}
