// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "run_program.hpp"
#include "straightedge/host/canny.hpp"
#include "straightedge/host/image_file.hpp"
#include "straightedge/host/map_file.hpp"
#include "straightedge/host/ros_map.hpp"
#include "straightedge/hough_lines.hpp"
#include "support/catch.hpp"

using namespace straightedge;

namespace {

/// With all outputs, into the folder; the bytes of the outputs, one behind the other.
std::string all_outputs(const std::string& input, const TemporaryFolder& folder) {
  const auto at = [&](const char* name) { return (folder / name).string(); };
  const Run run = run_program({"lines", input, "-o", at("m.xml"), "--svg", at("m.svg"), "--png", at("m.png"),
                               "--csv", at("m.csv"), "--seed", "7"});
  INFO(run.err);
  REQUIRE(run.code == 0);
  return bytes_of(at("m.xml")) + bytes_of(at("m.svg")) + bytes_of(at("m.png")) + bytes_of(at("m.csv"));
}

std::size_t rows_of(const std::string& csv) {
  return static_cast<std::size_t>(std::count(csv.begin(), csv.end(), '\n')) - 1;
}

}  // namespace

TEST_CASE("the same picture gives the same bytes, wherever they go") {
  const TemporaryFolder one, two;
  for (const char* input : {"maps/mrpt/map.yaml", "images/board.jpg"}) {
    CHECK(all_outputs(fixture(input), one) == all_outputs(fixture(input), two));
  }
  CHECK(names_in(one) == std::vector<std::string>{"m.csv", "m.png", "m.svg", "m.xml"});
}

TEST_CASE("edges are the library's") {
  const std::string picture = fixture("images/coins.png");
  const auto gray = read_gray_image(picture);
  REQUIRE(gray);
  const Run run = run_program({"edges", picture, "-o", "-", "--sigma", "2", "--low", "31.5", "--high",
                               "80.25", "--l2", "--aperture", "5"});
  const auto printed = decode_gray_image(run.out, "edges");
  REQUIRE(printed);
  const CannyEdges edges =
      canny(*gray, {.sigma = 2, .aperture = 5, .norm = GradientNorm::l2, .low = 31.5, .high = 80.25});
  CHECK(*printed == edges.edges);
  CHECK(run.err.find(std::to_string(edges.result.edges) + " of them edges") != std::string::npos);
  const Run automatic = run_program({"edges", picture, "-o", "-", "--auto-thresholds"});
  CannyOptions options;
  options.thresholds = CannyThresholds::automatic;
  CHECK(*decode_gray_image(automatic.out, "edges") == canny(*gray, options).edges);
}

TEST_CASE("files say what made them") {
  const TemporaryFolder folder;
  const std::string all = all_outputs(fixture("maps/mrpt/map.yaml"), folder);
  const auto map = read_line_map(folder / "m.xml");
  REQUIRE(map);
  CHECK(map->meta.tool == "straightedge " STRAIGHTEDGE_VERSION);
  CHECK(map->meta.options.starts_with("method follow, picture auto, min-length 9, "));
  CHECK(map->meta.created.empty());
  CHECK(map->image->file == "basic_map.png");
  for (const char* name : {"m.svg", "m.png"}) {
    CHECK(bytes_of(folder / name).find("straightedge " STRAIGHTEDGE_VERSION) != std::string::npos);
  }
  CHECK(all.find(std::filesystem::path(STRAIGHTEDGE_FIXTURES).parent_path().string()) == std::string::npos);
  const Run edges = run_program({"edges", fixture("images/coins.png"), "-o", "-"});
  CHECK(edges.out.find("straightedge " STRAIGHTEDGE_VERSION " edges; sigma 1.4") != std::string::npos);
}

TEST_CASE("a map says what can change it: the seed of votes, none where edges are followed") {
  const TemporaryFolder folder;
  const std::string picture = folder.put("room.pgm", room_pgm()).string();
  const auto written = [&](std::vector<std::string> more) {
    more.insert(more.begin(), {"lines", picture, "-o", "-", "--quiet"});
    const Run run = run_program(more);
    INFO(run.err);
    REQUIRE(run.code == 0);
    return run.out;
  };
  const std::string followed = written({});
  CHECK(followed == written({"--method", "follow"}));
  CHECK(followed == written({"--seed", "7"}));
  CHECK(followed.find("seed") == std::string::npos);
  const std::string voted = written({"--method", "progressive", "--threshold", "20", "--seed", "7"});
  CHECK(voted.find("method progressive, seed 7, ") != std::string::npos);
  CHECK(voted.find("threshold 20, ") != std::string::npos);
}

TEST_CASE("a ROS map's place goes into the file, and metres follow it") {
  const TemporaryFolder folder;
  const std::string yaml = fixture("maps/mrpt/map.yaml");
  const auto at = [&](const char* name) { return (folder / name).string(); };
  REQUIRE(run_program({"lines", yaml, "-o", at("px.xml"), "--name", "hall", "--description", "north wing",
                       "--created", "1999-12-31"})
              .code == 0);
  const auto map = read_line_map(at("px.xml"));
  const auto ros = read_ros_map(yaml);
  REQUIRE(map);
  REQUIRE(ros);
  CHECK(map->unit == MapUnit::pixel);
  CHECK(map->image->placement == ros->placement);
  CHECK(map->image->meaning == ros->meaning);
  CHECK(map->meta.name == "hall");
  CHECK(map->meta.description == "north wing");
  CHECK(map->meta.created == "1999-12-31");
  CHECK_FALSE(map->lines.empty());
  REQUIRE(
      run_program({"lines", yaml, "-o", at("m.xml"), "--svg", at("m.svg"), "--png", at("m.png"), "--metres"})
          .code == 0);
  const auto metres = read_line_map(at("m.xml"));
  REQUIRE(metres);
  CHECK(metres->unit == MapUnit::metre);
  CHECK(metres->lines == to_metres(*map)->lines);
}

TEST_CASE("resolution and origin by hand: metres, and degrees") {
  const TemporaryFolder folder;
  const std::string picture = folder.put("room.pgm", room_pgm()).string();
  const Run run =
      run_program({"lines", picture, "-o", "-", "--resolution", "0.05", "--origin", "-12.5,3,90"});
  const auto map = line_map_from_xml(run.out, "map");
  REQUIRE(map);
  REQUIRE(map->image->placement);
  CHECK(map->image->placement->resolution == 0.05);
  CHECK(map->image->placement->origin_x == -12.5);
  CHECK(map->image->placement->origin_y == 3);
  CHECK(map->image->placement->origin_yaw == Approx(1.5707963267948966).epsilon(1e-15));
}

TEST_CASE("--negate reads the negative picture like the picture") {
  const TemporaryFolder folder;
  std::string bytes = room_pgm();
  const std::size_t head = pgm_header(200, 160).size();
  const std::string picture = folder.put("room.pgm", bytes).string();
  for (std::size_t i = head; i < bytes.size(); ++i)
    bytes[i] = static_cast<char>(255 - static_cast<unsigned char>(bytes[i]));
  const std::string negative = folder.put("negative.pgm", bytes).string();
  const Run plain = run_program({"lines", picture, "-o", "-", "--quiet"});
  const Run turned = run_program({"lines", negative, "-o", "-", "--quiet", "--negate"});
  const auto a = line_map_from_xml(plain.out, "a"), b = line_map_from_xml(turned.out, "b");
  REQUIRE(a);
  REQUIRE(b);
  CHECK(a->lines.size() == 8);
  CHECK(a->lines == b->lines);
  CHECK(b->meta.options.find("negate") != std::string::npos);
}

TEST_CASE("the raw transform has a row for each line, in all three methods") {
  const TemporaryFolder folder;
  const std::string picture = folder.put("room.pgm", room_pgm()).string();
  const std::string edges = (folder / "e.png").string();
  REQUIRE(run_program({"edges", picture, "-o", edges}).code == 0);
  for (const std::string method : {"standard", "progressive", "randomized"}) {
    const Run run = run_program({"hough", edges, "--method", method});
    INFO(method << ": " << run.err);
    CHECK(run.code == 0);
    CHECK(run.out.starts_with(method == "standard" ? "rho,theta,votes\n" : "x0,y0,x1,y1,votes\n"));
    CHECK(rows_of(run.out) >= 8);
    const std::string csv = (folder / "h.csv").string();
    const Run json = run_program({"hough", edges, "--method", method, "--csv", csv, "--json"});
    CHECK(bytes_of(csv) == run.out);
    const auto numbers = nlohmann::json::parse(json.out);
    CHECK(numbers.at(method == "standard" ? "lines" : "segments") == rows_of(run.out));
    CHECK(numbers.at("method") == method);
    CHECK(run_program({"hough", edges, "--method", method, "--seed", "1"}).out == run.out);
  }
}

TEST_CASE("more lines than fit at first are all there") {
  const TemporaryFolder folder;
  const std::string white = folder.put("white.pgm", pgm(300, 300, 255)).string();
  const Run run = run_program(
      {"hough", white, "--method", "standard", "--threshold", "1", "--rho", "0.25", "--theta", "0.004"});
  CHECK(run.code == 0);
  CHECK(rows_of(run.out) > 4096);
}

TEST_CASE("--json is one object whose numbers are the map's") {
  const TemporaryFolder folder;
  const std::string xml = (folder / "m.xml").string();
  const Run run = run_program({"lines", fixture("maps/mrpt/map.yaml"), "-o", xml, "--json"});
  REQUIRE(run.code == 0);
  const auto numbers = nlohmann::json::parse(run.out);
  const auto map = read_line_map(xml);
  REQUIRE(map);
  std::size_t segments = 0;
  for (const MapLine& line : map->lines) segments += line.segments.size();
  CHECK(numbers.at("lines") == map->lines.size());
  CHECK(numbers.at("segments") == segments);
  CHECK(numbers.at("input") == "map.yaml");
  CHECK(numbers.at("picture") == "map");
  CHECK(numbers.at("seed") == 1);
  const auto edges = nlohmann::json::parse(
      run_program({"edges", fixture("images/coins.png"), "-o", (folder / "e.png").string(), "--json"}).out);
  CHECK(edges.at("edges") > edges.at("strong"));
  const auto valid = nlohmann::json::parse(run_program({"validate", xml, "--json"}).out);
  CHECK(valid.at("valid") == true);
  CHECK(valid.at("segments") == segments);
  const auto shown =
      nlohmann::json::parse(run_program({"show", xml, "-o", (folder / "m.svg").string(), "--json"}).out);
  CHECK(shown.at("lines") == map->lines.size());
}

TEST_CASE("--fast writes a valid map of the edges that can be followed") {
  const TemporaryFolder folder;
  const std::string xml = (folder / "m.xml").string();
  const Run run = run_program({"lines", fixture("maps/mrpt/map.yaml"), "-o", xml, "--fast"});
  REQUIRE(run.code == 0);
  CHECK(run.err.find("640 x 400 pixels\n") != std::string::npos);
  CHECK(run.err.find("Hough") == std::string::npos);
  CHECK(run_program({"validate", xml}).code == 0);
  const auto map = read_line_map(xml);
  REQUIRE(map);
  CHECK(map->meta.options.ends_with(", fast"));
  // With refinement there are 96 lines. Here short lone edges go, and each segment is a line of its own.
  CHECK(map->lines.size() >= 70);
  CHECK(map->lines.size() <= 140);
  for (const MapLine& line : map->lines) CHECK(line.segments.size() == 1);
  const auto numbers = nlohmann::json::parse(
      run_program({"lines", fixture("maps/mrpt/map.yaml"), "-o", xml, "--fast", "--json"}).out);
  CHECK(numbers.at("picture") == "not asked");
  CHECK(numbers.at("lines") == map->lines.size());
}

TEST_CASE("followed edges make the walls that votes make") {
  const TemporaryFolder folder;
  const auto map_by = [&](const std::string& method) {
    const std::string xml = (folder / "m.xml").string();
    std::vector<std::string> words = {"lines", fixture("maps/mrpt_malaga/map.yaml"), "-o", xml};
    if (!method.empty()) words.insert(words.end(), {"--method", method});
    const Run run = run_program(words);
    INFO(run.err);
    REQUIRE(run.code == 0);
    CHECK((run.err.find("followed") != std::string::npos) == method.empty());
    CHECK(run_program({"validate", xml}).code == 0);
    auto map = read_line_map(xml);
    REQUIRE(map);
    return *map;
  };
  const LineMap voted = map_by("progressive"), followed = map_by("");
  int walls = 0, found = 0;
  for (const MapLine& line : voted.lines) {
    for (const MapSegment& wall : line.segments) {
      const double x = (wall.x0 + wall.x1) / 2, y = (wall.y0 + wall.y1) / 2;
      if (std::hypot(wall.x1 - wall.x0, wall.y1 - wall.y0) < 40) continue;
      ++walls;
      found += std::any_of(followed.lines.begin(), followed.lines.end(), [&](const MapLine& other) {
        const double off = x * std::cos(other.theta) + y * std::sin(other.theta) - other.rho;
        return std::abs(std::sin(other.theta - line.theta)) < 0.03 && std::abs(off) < 1;
      });
    }
  }
  CHECK(walls >= 5);
  CHECK(found >= walls - 1);
}

TEST_CASE("what lines writes keeps schema and rules") {
  const TemporaryFolder folder;
  const bool xmllint = std::system("xmllint --version >/dev/null 2>&1") == 0;
  const auto at = [&](const char* name) { return (folder / name).string(); };
  for (const char* input : {"maps/mrpt/map.yaml", "maps/mrpt_corridor/map.yaml", "images/building.jpg"}) {
    REQUIRE(run_program({"lines", fixture(input), "-o", at("m.xml")}).code == 0);
    CHECK(run_program({"validate", at("m.xml")}).code == 0);
    CHECK(run_program({"show", at("m.xml"), "-o", at("m.svg")}).code == 0);
    const std::string check =
        "xmllint --noout --schema " STRAIGHTEDGE_SCHEMA " '" + at("m.xml") + "' >/dev/null 2>&1";
    if (xmllint) CHECK(std::system(check.c_str()) == 0);
  }
}
