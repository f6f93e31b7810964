// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "straightedge/host/plane_view.hpp"

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "catch.hpp"
#include "room_plane_map.hpp"

using namespace straightedge;
using nlohmann::json;

namespace {

/// What stands between two marks, of which the second one is the next after the first.
std::string between(const std::string& page, const std::string& open, const std::string& close) {
  const std::size_t begin = page.find(open);
  REQUIRE(begin != std::string::npos);
  const std::size_t end = page.find(close, begin + open.size());
  REQUIRE(end != std::string::npos);
  return page.substr(begin + open.size(), end - begin - open.size());
}

json data_of(const std::string& page) {
  return json::parse(between(page, "<script type=\"application/json\" id=\"map\">", "</script>"));
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

std::vector<PlaneViewPoint> some_points(std::size_t many) {
  std::vector<PlaneViewPoint> points;
  for (std::size_t i = 0; i < many; ++i) {
    points.push_back({{0.01 * static_cast<double>(i), 1, 0}, static_cast<std::uint32_t>(i % 3)});
  }
  return points;
}

}  // namespace

TEST_CASE("the page asks for nothing outside of it, and may not") {
  const auto path = room_camera_path(5);
  const auto points = some_points(50);
  PlaneViewOptions options;
  options.camera_path = path;
  options.points = points;
  const std::string page = plane_map_html(room_plane_map(), options);
  for (const char* outside :
       {"http:", "https:", "src=", "url(", "@import", "fetch(", "XMLHttp", "import(", "\"//"}) {
    INFO(outside);
    CHECK(page.find(outside) == std::string::npos);
  }
  CHECK(count(page, "href=") == 1);
  CHECK(page.find("href=\"data:,\"") != std::string::npos);
  CHECK(page.find("default-src 'none'") != std::string::npos);
  CHECK(page.starts_with("<!DOCTYPE html>"));
  CHECK(page == plane_map_html(room_plane_map(), options));
}

TEST_CASE("every plane is embedded with its numbers, also one without a border") {
  const PlaneMap map = room_plane_map();
  const json data = data_of(plane_map_html(map));
  REQUIRE(data["planes"].size() == map.planes.size());
  for (std::size_t i = 0; i < map.planes.size(); ++i) {
    const json& shown = data["planes"][i];
    const MapPlane& plane = map.planes[i];
    CHECK(shown["id"] == plane.id);
    CHECK(shown["n"][0].get<double>() == Approx(plane.plane.normal.x).margin(1e-5));
    CHECK(shown["d"].get<double>() == Approx(plane.plane.distance).margin(1e-5));
    CHECK(shown.contains("points") == plane.points.has_value());
    CHECK(shown["pieces"].size() == (plane.polygons.empty() ? 0 : 1));
  }
  CHECK(data["up"] == "z");
  CHECK(data["path"].empty());
  CHECK(data["cloud"].empty());
}

TEST_CASE("coordinates come back within half a millimetre, also a kilometre away") {
  for (const double away : {0.0, 1000.3, -52345.6}) {
    PlaneMap map = room_plane_map();
    for (MapPlane& plane : map.planes) {
      for (MapPolygon& polygon : plane.polygons) {
        for (Vector3& p : polygon.points) p = p + Vector3{away, 0, 0};
      }
      plane.plane.distance += away * plane.plane.normal.x;
    }
    const json data = data_of(plane_map_html(map));
    const double step = data["step"], origin = data["origin"][0];
    CHECK(step == 1e-3);
    for (std::size_t i = 0; i + 1 < map.planes.size(); ++i) {
      const auto& border = map.planes[i].polygons[0].points;
      const json& ring = data["planes"][i]["pieces"][0]["rings"][0];
      REQUIRE(ring.size() == 3 * border.size());
      for (std::size_t k = 0; k < border.size(); ++k) {
        CHECK(std::abs(origin + step * ring[3 * k].get<double>() - border[k].x) < 0.5001e-3);
      }
    }
  }
}

TEST_CASE("a map of a few centimetres has finer steps") {
  RoomMaker maker;
  maker.add({{0, 0, 0}, {0.04, 0, 0}, {0.04, 0.03, 0}}, {0, 0, 1});
  CHECK(data_of(plane_map_html(maker.take()))["step"].get<double>() < 1.1e-5);
}

TEST_CASE("text of the map cannot leave its place") {
  PlaneMap map = room_plane_map();
  const std::string hostile = "</title></script><script>alert(1)</script><!-- \" \\ \x01 \xff & </h1>";
  map.meta = {hostile, hostile, hostile, hostile, hostile};
  map.planes[0].source = hostile;
  const std::string page = plane_map_html(map);
  const std::string tame = plane_map_html(room_plane_map());
  for (const char* mark : {"<script", "</script", "</title", "</h1", "<!--"}) {
    INFO(mark);
    CHECK(count(page, mark) == count(tame, mark));
  }
  const std::string source = data_of(page)["planes"][0]["source"];
  CHECK(source.starts_with("</title></script><script>alert(1)</script><!-- \" \\ "));
  CHECK(page.find("&lt;/title&gt;&lt;/script&gt;") != std::string::npos);
  CHECK(page.find('\xff') == std::string::npos);
}

TEST_CASE("the title is the caller's, else the map's, else plain") {
  PlaneMap map = room_plane_map();
  CHECK(between(plane_map_html(map), "<title>", "</title>") == "A room");
  PlaneViewOptions options;
  options.title = "Mine & yours";
  CHECK(between(plane_map_html(map, options), "<h1>", "</h1>") == "Mine &amp; yours");
  CHECK(between(plane_map_html({}), "<title>", "</title>") == "Plane map");
}

TEST_CASE("points are thinned evenly and sorted by plane; those of no plane are kept apart") {
  PlaneViewOptions options;
  const auto points = some_points(1000);
  options.points = points;
  const auto kept = [&](std::size_t most) {
    options.max_points = most;
    const json data = data_of(plane_map_html(room_plane_map(), options));
    std::size_t sum = 0;
    for (const json& cloud : data["cloud"]) sum += cloud["xyz"].size() / 3;
    CHECK(data["left_out"] == 1000 - sum);
    return sum;
  };
  CHECK(kept(2000) == 1000);
  CHECK(kept(1000) == 1000);
  CHECK(kept(999) == 500);
  CHECK(kept(100) == 100);
  CHECK(kept(1) == 1);
  CHECK(kept(0) == 0);
  options.max_points = 1000;
  const json data = data_of(plane_map_html(room_plane_map(), options));
  REQUIRE(data["cloud"].size() == 3);
  CHECK(data["cloud"][0]["plane"] == 0);
  CHECK(data["cloud"][2]["plane"] == -1);
}

TEST_CASE("poses tell where the camera is and where it looks") {
  const std::vector<Pose> path(2);
  PlaneViewOptions options;
  options.camera_path = path;
  const json data = data_of(plane_map_html(room_plane_map(), options));
  CHECK(data["path"][1] == json::parse("[[0,0,0],[0,0,1],[0,1,0]]"));
  CHECK(data["up"] == "-y");
}

TEST_CASE("numbers that no picture can show spoil nothing") {
  PlaneMap map = room_plane_map();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  map.planes[0].plane.normal.x = nan;
  map.planes[1].plane.distance = std::numeric_limits<double>::infinity();
  map.planes[2].polygons[0].points[0].z = 1e300;
  std::vector<Pose> path(1);
  path[0].translation.x = nan;
  const std::vector<PlaneViewPoint> points{{{nan, 0, 0}, 1}, {{1e30, 0, 0}, 1}};
  PlaneViewOptions options;
  options.camera_path = path;
  options.points = points;
  const json data = data_of(plane_map_html(map, options));
  CHECK(data["planes"][0]["pieces"].empty());
  CHECK(data["planes"][0]["n"][0].is_null());
  CHECK(data["planes"][2]["pieces"].empty());
  CHECK(data["planes"][3]["pieces"].size() == 1);
  CHECK(data["path"].empty());
  CHECK(data["left_out"] == 2);
}
