// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "straightedge/host/svg.hpp"

#include <tinyxml2.h>

#include <cstdlib>
#include <string>
#include <vector>

#include "catch.hpp"
#include "random_line_map.hpp"
#include "straightedge/host/image.hpp"
#include "straightedge/host/map_file.hpp"
#include "temporary_folder.hpp"

using namespace straightedge;

namespace {

/// A drawing as its viewers read it.
class Parsed {
 public:
  explicit Parsed(const Result<std::string>& svg) {
    if (!svg) FAIL(svg.failure().sentence);
    REQUIRE(document_.Parse(svg->c_str()) == tinyxml2::XML_SUCCESS);
    collect(*document_.RootElement());
  }

  std::vector<const tinyxml2::XMLElement*> of_class(const std::string& kind) const {
    std::vector<const tinyxml2::XMLElement*> found;
    for (const auto* element : elements_) {
      if (element->Attribute("class", kind.c_str()) != nullptr) found.push_back(element);
    }
    return found;
  }
  const tinyxml2::XMLElement& root() const { return *document_.RootElement(); }

 private:
  void collect(const tinyxml2::XMLElement& element) {
    elements_.push_back(&element);
    for (const auto* child = element.FirstChildElement(); child != nullptr;
         child = child->NextSiblingElement()) {
      collect(*child);
    }
  }

  tinyxml2::XMLDocument document_;
  std::vector<const tinyxml2::XMLElement*> elements_;
};

SvgOptions bare() {
  SvgOptions options;
  options.ids = options.free_sides = options.legend = false;
  return options;
}

}  // namespace

TEST_CASE("segments lie over the picture's pixels, y downwards, magnified by a whole number") {
  const Parsed svg(line_map_to_svg(small_line_map(), bare()));
  CHECK(svg.root().DoubleAttribute("width") == 1280);
  CHECK(svg.root().DoubleAttribute("height") == 800);
  const auto faces = svg.of_class("face");
  REQUIRE(faces.size() == 1);
  CHECK(faces[0]->DoubleAttribute("x1") == 2 * (320 + 20));
  CHECK(faces[0]->DoubleAttribute("y1") == 2 * (200 + 60));
  CHECK(faces[0]->DoubleAttribute("y2") == 2 * (200 - 80));
  CHECK(svg.of_class("axis").size() == 2);
  const auto bands = svg.of_class("band");
  REQUIRE(bands.size() == 2);
  CHECK(std::string(bands[0]->Attribute("style")) == "stroke-width:4.20");
}

TEST_CASE("ticks stand on the free side, ids on the other one") {
  SvgOptions options;
  options.legend = false;
  const Parsed svg(line_map_to_svg(small_line_map(), options));
  int on_face = 0;
  for (const auto* tick : svg.of_class("free")) {
    if (tick->DoubleAttribute("y1") != tick->DoubleAttribute("y2")) continue;
    ++on_face;
    CHECK(tick->DoubleAttribute("x1") == 680);
    CHECK(tick->DoubleAttribute("x2") == 674);  // minus: smaller x
  }
  CHECK(on_face == 7);  // 280 units long
  const auto ids = svg.of_class("id");
  REQUIRE(ids.size() == 3);
  CHECK(std::string(ids[2]->GetText()) == "12");
  CHECK(ids[2]->DoubleAttribute("x") > 680);
}

TEST_CASE("the same map gives the same bytes, texts are escaped, nothing is an empty drawing") {
  LineMap map = small_line_map();
  map.meta.name = "<floor> & \"4\"";
  CHECK(*line_map_to_svg(map) == *line_map_to_svg(map));
  const Parsed svg(line_map_to_svg(map));
  CHECK(std::string(svg.root().FirstChildElement("title")->GetText()) == map.meta.name);
  const Parsed empty(line_map_to_svg({}));
  CHECK(empty.root().DoubleAttribute("width") == 900);
}

TEST_CASE("metre maps fill the drawing, and their picture is turned with them") {
  LineMap map = small_line_map();
  map.image->placement = {0.05, -12, -25, 0.3};
  const Image<std::uint8_t> picture(map.image->size, 200);
  SvgOptions options = bare();
  options.picture = picture;
  const LineMap metres = *to_metres(map);
  const Parsed svg(line_map_to_svg(metres, options));
  CHECK(svg.of_class("picture").size() == 1);
  for (const auto* line : svg.of_class("axis")) {
    CHECK(line->DoubleAttribute("x1") > 0);
    CHECK(line->DoubleAttribute("x1") < svg.root().DoubleAttribute("width"));
    CHECK(line->DoubleAttribute("y2") < svg.root().DoubleAttribute("height"));
  }
  // The picture's own matrix sends the face's first end to where the segment begins.
  double m[6] = {};
  const std::string matrix = svg.of_class("picture")[0]->Attribute("transform");
  REQUIRE(std::sscanf(matrix.c_str(), "matrix(%lf %lf %lf %lf %lf %lf)", m, m + 1, m + 2, m + 3, m + 4,
                      m + 5) == 6);
  const Point2 uv = image_from_centre({20, -60}, map.image->size);
  const auto* face = svg.of_class("face")[0];
  const bool turned = metres.lines[1].segments[0].y0 != Approx(metres.lines[1].segments[0].y1) &&
                      metres.lines[1].free == FreeSide::plus;
  CHECK(face->DoubleAttribute(turned ? "x2" : "x1") == Approx(m[0] * uv.x + m[2] * uv.y + m[4]).margin(0.01));
  CHECK(face->DoubleAttribute(turned ? "y2" : "y1") == Approx(m[1] * uv.x + m[3] * uv.y + m[5]).margin(0.01));
}

TEST_CASE("bad maps, other pictures and unwritable files are sentences") {
  const TemporaryFolder folder;
  LineMap map = small_line_map();
  const Image<std::uint8_t> picture({64, 40});
  SvgOptions options;
  options.picture = picture;
  CHECK_FALSE(line_map_to_svg(map, options));
  map.lines[0].rho = -1;
  CHECK_FALSE(line_map_to_svg(map));
  const auto nowhere = write_svg(folder / "missing/m.svg", small_line_map());
  REQUIRE_FALSE(nowhere);
  CHECK(nowhere.failure().problem == Problem::cannot_write);
  REQUIRE(write_svg(folder / "m.svg", small_line_map()));
  CHECK(bytes_of(folder / "m.svg") == *line_map_to_svg(small_line_map()));
}

TEST_CASE("random maps of any size are drawn without a number that is none") {
  RandomLineMaps maps(24);
  for (int i = 0; i < 100; ++i) {
    const auto svg = line_map_to_svg(maps.next());
    REQUIRE(svg);
    CHECK(svg->find("nan") == std::string::npos);
    CHECK(svg->find("inf") == std::string::npos);
  }
}
