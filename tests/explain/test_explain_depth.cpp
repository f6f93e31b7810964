// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <cmath>

#include "cli/explain_depth.hpp"
#include "cli/explain_depth_run.hpp"
#include "explained.hpp"
#include "straightedge/host/camera_file.hpp"
#include "straightedge/host/depth_file.hpp"
#include "straightedge/random.hpp"

using namespace straightedge;
namespace fs = std::filesystem;

namespace {

constexpr Size frame_size{160, 120};
constexpr PinholeCamera camera{130, 130, 79.5, 59.5};

/// A floor 1 m below the camera that meets a wall 3 m ahead, a box that stands out of it, a plant, a hole;
/// with the noise that the gate supposes.
Image<std::uint16_t> corner_of_room() {
  Image<std::uint16_t> depth(frame_size);
  Pcg32 random(7, 1);
  for (std::int32_t y = 0; y < frame_size.height; ++y) {
    for (std::int32_t x = 0; x < frame_size.width; ++x) {
      const Vector3 ray = camera.ray(x, y);
      double inverse = std::max(1 / 3.0, ray.y);
      if (x >= 20 && x < 60 && y >= 30 && y < 80) inverse = 1 / 2.0;
      const double chance = random.next() / 4294967296.0 + random.next() / 4294967296.0 - 1;
      inverse += 1e-3 * chance;
      if (x >= 100 && x < 125 && y >= 25 && y < 50) inverse = 0.4 + 0.3 * chance;  // leaves of a plant
      const bool hole = x > 130 && y < 20;
      depth.at(x, y) = hole ? std::uint16_t{0} : static_cast<std::uint16_t>(std::lround(5000 / inverse));
    }
  }
  return depth;
}

DepthView view_of(const Image<std::uint16_t>& depth) {
  return {depth, 1.0 / 5000, camera};
}

cli::ExplainDepthOptions options_of(PlaneMethod method) {
  cli::ExplainDepthOptions options;
  options.detector.method = method;
  options.input = "corner.png";
  options.version = "9.8";
  return options;
}

std::set<std::string> names_in(const fs::path& folder) {
  std::set<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder)) names.insert(entry.path().filename().string());
  return names;
}

/// What must hold for every frame: the files are those that the page shows, each picture has the size
/// that the page states and a caption, and no link leads out of the folder.
explained::Page explain_and_check(const DepthView& depth, const cli::ExplainDepthOptions& options,
                                  const fs::path& folder) {
  const auto done = cli::explain_depth(depth, options, folder);
  INFO((done ? "" : done.failure().sentence));
  REQUIRE(done);
  explained::Page page = explained::read_page(folder / "index.html");
  std::set<std::string> files = page.pictures;
  files.insert("index.html");
  CHECK(names_in(folder) == files);
  for (const std::string& picture : page.pictures) {
    if (picture.ends_with(".svg")) {
      CHECK(page.text.find("src=\"map.svg\" width=\"1300\"") != std::string::npos);
      CHECK(bytes_of(folder / picture).find("width=\"1300") != std::string::npos);
      continue;
    }
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
  CHECK(page.elements["figure"] == page.elements["figcaption"]);
  CHECK(page.text.find("http") == std::string::npos);
  CHECK(page.text.find("nan") == std::string::npos);
  return page;
}

void check_fact(const explained::Page& page, const char* id, std::uint64_t value) {
  INFO(id);
  REQUIRE(page.facts.contains(id));
  CHECK(explained::digits(page.facts.at(id)) == std::to_string(value));
}

const std::set<std::string> common_pictures = {"depth.png",          "inverse-depth.png",
                                               "cells-32.png",       "cells-16.png",
                                               "cells-8.png",        "cells-4.png",
                                               "candidates.png",     "cell-labels-32.png",
                                               "cell-labels-16.png", "cell-labels-8.png",
                                               "cell-labels-4.png",  "labels.png",
                                               "residuals.png",      "map.svg",
                                               "octree-4.png",       "octree-2.png",
                                               "octree-0.png",       "octree-question.png"};

std::set<std::string> with(std::set<std::string> names, const std::set<std::string>& more) {
  names.insert(more.begin(), more.end());
  return names;
}

}  // namespace

TEST_CASE("a depth frame gives a page with every stage of ransac") {
  const TemporaryFolder folder;
  const auto depth = corner_of_room();
  const auto page = explain_and_check(view_of(depth), options_of(PlaneMethod::ransac), folder / "out");
  auto pictures =
      with(common_pictures, {"window.png", "best-triple.png", "refitted.png", "hypotheses.png", "boxes.png"});
  if (page.facts.at("window-best") != "1") pictures.insert("first-triple.png");
  CHECK(page.pictures == pictures);
  CHECK(page.facts.at("method") == "ransac");
  CHECK(page.facts.at("input") == "corner.png");
  CHECK(page.text.find("straightedge 9.8") != std::string::npos);
}

TEST_CASE("a depth frame gives a page with every stage of the Hough transform") {
  const TemporaryFolder folder;
  const auto depth = corner_of_room();
  const auto page = explain_and_check(view_of(depth), options_of(PlaneMethod::hough), folder / "out");
  CHECK(page.pictures == with(common_pictures, {"patches.png", "accumulator.png", "distances.png"}));
  CHECK(page.facts.at("method") == "hough");
}

TEST_CASE("the depth page's numbers are those of the detector") {
  const auto method = GENERATE(PlaneMethod::ransac, PlaneMethod::hough);
  const auto depth = corner_of_room();
  const auto options = options_of(method);
  const TemporaryFolder folder;
  const auto page = explain_and_check(view_of(depth), options, folder / "out");
  const auto found = detect_planes(view_of(depth), options.detector);
  REQUIRE(found);
  REQUIRE(found->found.planes >= 3);
  REQUIRE(found->found.labelled < found->found.readings);
  check_fact(page, "planes", found->found.planes);
  check_fact(page, "labelled", found->found.labelled);
  check_fact(page, "free", found->found.readings - found->found.labelled);
  CHECK(
      explained::digits(page.facts.at("readings")).starts_with(std::to_string(found->found.readings) + " ("));
  for (const FoundPlane& plane : found->planes) {
    const std::string cell = "<td>" + std::to_string(plane.inliers) + "</td>";
    CHECK(explained::digits(page.text).find(cell) != std::string::npos);
  }
  if (method == PlaneMethod::ransac) check_fact(page, "seed", options.detector.ransac.seed);
}

TEST_CASE("the stages of a depth frame are those of the detector's own search") {
  const auto depth = corner_of_room();
  PlaneDetectorOptions options;
  SECTION("ransac") {
    const auto run = cli::run_depth_stages(view_of(depth), options);
    REQUIRE(run);
    CHECK(run->ransac.candidates.size() == run->candidates.size());
    CHECK(run->ransac.result.status == Status::ok);
    REQUIRE(run->ransac.window);
    CHECK(run->ransac.window->events.front().best);
  }
  SECTION("hough") {
    options.method = PlaneMethod::hough;
    const auto run = cli::run_depth_stages(view_of(depth), options);
    REQUIRE(run);
    CHECK(run->hough.candidates.size() == run->candidates.size());
    std::set<int> numbers;
    for (const auto& grown : run->hough.planes) {
      if (grown.number != 0) CHECK(numbers.insert(grown.number).second);
    }
    CHECK(numbers.size() == run->candidates.size());
    for (const HoughPatch& patch : run->hough.search.patches())
      CHECK(patch.candidate <= run->hough.planes.size());
  }
}

TEST_CASE("planes of the map of one frame keep the frame's numbers") {
  // A cluttered frame, whose map has planes in another order.
  const fs::path folder = fs::path(STRAIGHTEDGE_FIXTURES) / "depth" / "mrpt_office";
  const auto known = read_camera(folder / "camera.json");
  REQUIRE(known);
  const auto depth = read_depth_frame(folder / "depth.png", *known);
  REQUIRE(depth);
  PlaneDetectorOptions options;
  options.method = GENERATE(PlaneMethod::ransac, PlaneMethod::hough);
  const auto run = cli::run_depth_stages({*depth, known->metres_per_unit(), known->pinhole}, options);
  REQUIRE(run);
  REQUIRE_FALSE(run->map.planes.empty());
  std::set<std::uint32_t> ids;
  for (const MapPlane& plane : run->map.planes) {
    INFO(plane.id);
    CHECK(ids.insert(plane.id).second);
    REQUIRE(plane.id >= 1);
    if (plane.id > run->found.planes.size()) continue;  // of none of the frame's
    const Plane& own = run->found.planes[plane.id - 1].fit.plane;
    CHECK(std::abs(dot(plane.plane.normal, own.normal)) > 0.95);
  }
}

TEST_CASE("the watched window has a plane and room for others") {
  const auto depth = corner_of_room();
  const auto run = cli::run_depth_stages(view_of(depth), {});
  REQUIRE(run);
  REQUIRE(run->ransac.window);
  const cli::WatchedWindow& window = *run->ransac.window;
  CHECK(window.share > 0.2);
  CHECK(window.share < 0.9);
  // The plane in the end is one of the frame's.
  double nearest = 1;
  for (const FoundPlane& plane : run->found.planes) {
    const InverseDepthPlane p = to_inverse_depth(plane.fit.plane, camera);
    nearest = std::min(nearest, std::abs(p.at(80, 60) - window.refitted.at(80, 60)) +
                                    std::abs(p.at(20, 100) - window.refitted.at(20, 100)));
  }
  CHECK(nearest < 0.02);
}

TEST_CASE("depth frames without planes are explained") {
  const TemporaryFolder folder;
  const auto method = GENERATE(PlaneMethod::ransac, PlaneMethod::hough);
  const Size size = GENERATE(Size{1, 1}, Size{1, 40}, Size{5, 3}, Size{64, 48});
  const auto value = GENERATE(std::uint16_t{0}, std::uint16_t{65535});
  if (size == Size{64, 48} && value != 0) return;  // that is a wall
  const Image<std::uint16_t> blank(size, value);
  const auto page = explain_and_check(view_of(blank), options_of(method), folder / "out");
  CHECK(page.facts.at("planes") == "0");
  CHECK(page.facts.at("labelled") == "0");
  CHECK(page.facts.at("candidates-count") == "0");
}

TEST_CASE("the same depth frame gives the same bytes, and nothing of an older run stays") {
  const auto method = GENERATE(PlaneMethod::ransac, PlaneMethod::hough);
  const TemporaryFolder folder;
  const auto depth = corner_of_room();
  const auto options = options_of(method);
  REQUIRE(cli::explain_depth(view_of(depth), options, folder / "a"));
  REQUIRE(cli::explain_image(explained::fixture("images/pic5.png"), {}, folder / "b"));
  REQUIRE(cli::explain_depth(
      view_of(depth), options_of(method == PlaneMethod::ransac ? PlaneMethod::hough : PlaneMethod::ransac),
      folder / "b"));
  REQUIRE(cli::explain_depth(view_of(depth), options, folder / "b"));
  CHECK(names_in(folder / "a") == names_in(folder / "b"));
  for (const std::string& name : names_in(folder / "a")) {
    INFO(name);
    CHECK(bytes_of(folder / "a" / name) == bytes_of(folder / "b" / name));
  }
}

TEST_CASE("a depth frame that is refused leaves no trace") {
  const TemporaryFolder folder;
  const auto depth = corner_of_room();
  DepthView view = view_of(depth);
  cli::ExplainDepthOptions options = options_of(PlaneMethod::ransac);
  Problem expected = Problem::bad_content;
  SECTION("no scale") {
    view.metres_per_unit = 0;
  }
  SECTION("no camera") {
    view.camera.fx = 0;
  }
  SECTION("options") {
    options.detector.frame.gate.inverse_sigma = std::nan("");
    expected = Problem::bad_option;
  }
  const auto done = cli::explain_depth(view, options, folder / "out");
  REQUIRE_FALSE(done);
  CHECK(done.failure().problem == expected);
  CHECK(folder.count() == 0);
}
