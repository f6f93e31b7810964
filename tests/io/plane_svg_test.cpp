// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <tinyxml2.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <map>
#include <string>
#include <vector>

#include "catch.hpp"
#include "room_plane_map.hpp"
#include "straightedge/host/plane_view.hpp"

using namespace straightedge;
using tinyxml2::XMLElement;

namespace {

/// The elements of one view, or of the whole drawing, in the order of painting.
class Drawing {
 public:
  explicit Drawing(const std::string& svg) { REQUIRE(document_.Parse(svg.c_str()) == tinyxml2::XML_SUCCESS); }

  const XMLElement& root() const { return *document_.RootElement(); }
  std::vector<const XMLElement*> of(const char* view, const char* kind) const {
    std::vector<const XMLElement*> found;
    for (const XMLElement* group = root().FirstChildElement("g"); group != nullptr;
         group = group->NextSiblingElement("g")) {
      if (group->Attribute("class", view) != nullptr) collect(*group, kind, found);
    }
    return found;
  }

 private:
  static void collect(const XMLElement& element, const char* kind, std::vector<const XMLElement*>& found) {
    if (element.Attribute("class", kind) != nullptr) found.push_back(&element);
    for (const XMLElement* child = element.FirstChildElement(); child != nullptr;
         child = child->NextSiblingElement()) {
      collect(*child, kind, found);
    }
  }

  tinyxml2::XMLDocument document_;
};

std::map<int, int> rank_of_planes(const std::vector<const XMLElement*>& shapes) {
  std::map<int, int> ranks;
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    ranks[shapes[i]->IntAttribute("data-plane")] = static_cast<int>(i);
  }
  return ranks;
}

}  // namespace

TEST_CASE("both views have every plane with a border; walls are thick lines in the plan alone") {
  const Drawing svg(plane_map_svg(room_plane_map()));
  CHECK(svg.of("plan", "plane").size() == 7);  // floor, ceiling, table, tops of three boxes, board
  CHECK(svg.of("plan", "wall").size() == 16);
  CHECK(svg.of("oblique", "plane").size() == 23);
  CHECK(svg.of("oblique", "wall").empty());
}

TEST_CASE("what stands on something is painted after it, and the ceiling is pale from above") {
  const Drawing svg(plane_map_svg(room_plane_map()));
  for (const char* view : {"plan", "oblique"}) {
    const auto shapes = svg.of(view, "plane");
    auto ranks = rank_of_planes(shapes);
    CHECK(ranks[1] < ranks[7]);  // floor, table
    CHECK(ranks[7] < ranks[8]);  // table, top of the box on it
    CHECK(ranks[1] < ranks[2]);  // floor, ceiling
    for (const XMLElement* shape : shapes) {
      const int id = shape->IntAttribute("data-plane");
      if (id == 1 || id == 7) CHECK(shape->DoubleAttribute("fill-opacity") > 0.8);
      if (id == 2) CHECK(shape->DoubleAttribute("fill-opacity") < 0.1);
    }
  }
}

TEST_CASE("a window is a second outline of its wall") {
  const Drawing svg(plane_map_svg(room_plane_map()));
  for (const XMLElement* shape : svg.of("oblique", "plane")) {
    const std::string d = shape->Attribute("d");
    const auto outlines = std::count(d.begin(), d.end(), 'Z');
    CHECK(outlines == (shape->IntAttribute("data-plane") == 4 ? 2 : 1));
  }
}

TEST_CASE("ids do not overlap and stay on the paper; a displaced one is led to its plane") {
  RoomMaker maker;
  for (int i = 0; i < 40; ++i) {  // a pile of small shelves in a large room
    const double z = 0.02 * i;
    maker.add({{1, 1, z}, {1.2, 1, z}, {1.2, 1.2, z}, {1, 1.2, z}}, {1, 1, 9});
  }
  maker.add({{0, 0, -1}, {6, 0, -1}, {6, 6, -1}, {0, 6, -1}}, {1, 1, 9});
  const Drawing svg(plane_map_svg(maker.take()));
  for (const char* view : {"plan", "oblique"}) {
    const auto ids = svg.of(view, "id");
    CHECK(ids.size() > 30);
    CHECK(svg.of(view, "leader").size() > 20);
    for (std::size_t i = 0; i < ids.size(); ++i) {
      CHECK(ids[i]->DoubleAttribute("x") > 5);
      CHECK(ids[i]->DoubleAttribute("x") < 615);
      for (std::size_t k = 0; k < i; ++k) {
        const double dx = std::abs(ids[i]->DoubleAttribute("x") - ids[k]->DoubleAttribute("x"));
        const double dy = std::abs(ids[i]->DoubleAttribute("y") - ids[k]->DoubleAttribute("y"));
        const auto letters =
            static_cast<double>(std::strlen(ids[i]->GetText()) + std::strlen(ids[k]->GetText()));
        CHECK((dx >= 3.1 * letters || dy >= 11.9));
      }
    }
  }
}

TEST_CASE("the scale bar is as long as its words say") {
  PlaneMap map = room_plane_map();
  const Drawing svg(plane_map_svg(map));
  double left = 1e9, right = -1e9;
  for (const XMLElement* shape : svg.of("plan", "plane")) {
    if (shape->IntAttribute("data-plane") != 1) continue;
    for (const char* at = shape->Attribute("d"); (at = std::strpbrk(at, "ML")) != nullptr; ++at) {
      left = std::min(left, std::atof(at + 1));
      right = std::max(right, std::atof(at + 1));
    }
  }
  const std::string bar = svg.of("plan", "scale")[0]->Attribute("d");
  CHECK(std::string(svg.of("plan", "note")[0]->GetText()) == "1 m");
  CHECK(std::atof(bar.c_str() + bar.find('h') + 1) == Approx((right - left) / 5.2).epsilon(0.001));
}

TEST_CASE("the camera path, titles and ids are drawn as asked for, and hostile text is text") {
  PlaneMap map = room_plane_map();
  map.meta.name = "</svg><script>alert('1')</script> \xff";
  PlaneSvgOptions options;
  CHECK(Drawing(plane_map_svg(map, options)).of("plan", "path").empty());
  const auto path = room_camera_path(9);
  options.camera_path = path;
  options.ids = false;
  const std::string text = plane_map_svg(map, options);
  CHECK(text == plane_map_svg(map, options));
  const Drawing svg(text);
  CHECK(svg.of("plan", "path").size() == 2);
  CHECK(svg.of("oblique", "id").empty());
  CHECK(text.find("<script") == std::string::npos);
  CHECK(std::string(svg.root().FirstChildElement("title")->GetText()).starts_with("</svg><script>"));
}

TEST_CASE("empty maps and numbers that no picture can show give a drawing without nonsense") {
  PlaneMap bad = room_plane_map();
  bad.planes[0].plane.normal = {0, 0, 0};
  bad.planes[1].polygons[0].points[1].x = std::numeric_limits<double>::infinity();
  bad.planes[2].polygons[0].points[0].y = 1e300;
  std::vector<Pose> path(2);
  path[1].translation.x = std::numeric_limits<double>::quiet_NaN();
  PlaneSvgOptions options;
  options.camera_path = path;
  for (const PlaneMap& map : {bad, PlaneMap{}}) {
    const std::string text = plane_map_svg(map, options);
    const Drawing svg(text);
    CHECK(svg.of("oblique", "plane").size() == (map.planes.empty() ? 0 : 20));
    for (const char* nonsense : {"nan", "inf"}) CHECK(text.find(nonsense) == std::string::npos);
  }
}
