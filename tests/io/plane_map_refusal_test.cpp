// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <string>

#include "catch.hpp"
#include "random_line_map.hpp"
#include "random_plane_map.hpp"
#include "straightedge/host/map_file.hpp"
#include "straightedge/host/plane_map_file.hpp"
#include "support/replaced.hpp"
#include "temporary_folder.hpp"

using namespace straightedge;

namespace {

std::string good() {
  return *plane_map_to_xml(small_plane_map());
}

std::string replaced(const std::string& what, const std::string& by) {
  return ::replaced(good(), what, by);
}

std::string refusal_of(const std::string& xml) {
  const auto map = plane_map_from_xml(xml, "m.xml");
  INFO(xml.substr(0, 500));
  REQUIRE_FALSE(map);
  CHECK(map.failure().problem == Problem::bad_content);
  return map.failure().sentence;
}

const std::string head = "<map format=\"straightedge-map\" version=\"1\" kind=\"planes\">";

}  // namespace

TEST_CASE("the text that the refusals of planes start from is good") {
  REQUIRE(plane_map_from_xml(good(), "m.xml"));
}

TEST_CASE("planes: documents, versions, kinds, frames") {
  CHECK(refusal_of("") == "m.xml:0: is not well-formed XML: it is empty");
  CHECK(refusal_of("<svg/>") == "m.xml:1: is not a straightedge-map");
  CHECK(refusal_of("<!DOCTYPE map>" + head + "</map>") == "m.xml:1: has a document type, which is not read");
  CHECK(refusal_of(replaced("version=\"1\" kind", "version=\"2\" kind")) ==
        "m.xml:2: was written by a newer version (format version 2, and up to 1 is read here)");
  CHECK(refusal_of(*line_map_to_xml(small_line_map())) ==
        "m.xml:2: is a map of lines where a map of planes is wanted");
  CHECK(refusal_of(replaced("unit=\"metre\"", "unit=\"pixel\"")) ==
        "m.xml:4: frame: `unit` is not \"metre\"");
  CHECK(refusal_of(replaced("origin=\"world\"", "origin=\"camera\"")) ==
        "m.xml:4: frame: `origin` is not \"world\"");
  CHECK(refusal_of(replaced(" unit=\"metre\"", "")) == "m.xml:4: frame: has no `unit`");
  CHECK(refusal_of(head + "</map>") == "m.xml:1: has no `frame`, so its unit is unknown");
  CHECK(refusal_of(head + "<frame unit=\"metre\"/><frame unit=\"metre\"/></map>") ==
        "m.xml:1: frame: stands there twice");
  CHECK(refusal_of(head + "<meta/><meta/><frame unit=\"metre\"/></map>") ==
        "m.xml:1: meta: stands there twice");
  for (std::size_t length = 0; length + 2 < good().size(); length += 7) {
    CHECK_FALSE(plane_map_from_xml(good().substr(0, length), "m.xml"));
  }
}

TEST_CASE("planes that break a rule are named by id and line") {
  CHECK(refusal_of(replaced("nz=\"1\"", "nz=\"nan\"")) ==
        "m.xml:5: plane 3: nx, ny, nz or d is not a finite number");
  CHECK(refusal_of(replaced("nz=\"1\"", "nz=\"0.9\"")) ==
        "m.xml:5: plane 3: the length of its normal is not 1 (0.9)");
  CHECK(refusal_of(replaced("d=\"0.75\"", "d=\"-0.75\"")) == "m.xml:5: plane 3: d is negative (-0.75)");
  CHECK(refusal_of(replaced(" d=\"0.75\"", "")) == "m.xml:5: plane 3: has no `d`");
  CHECK(refusal_of(replaced("nx=\"0\" ", "nx=\"0,5\" ")) ==
        "m.xml:5: plane 3: `nx` is not a number of its range (\"0,5\")");
  CHECK(refusal_of(replaced("<plane id=\"3\"", "<plane")) == "m.xml:5: plane: has no `id`");
  CHECK(refusal_of(replaced("<plane id=\"3\"", "<plane id=\"4294967296\"")) ==
        "m.xml:5: plane 4294967296: `id` is not a number of its range (\"4294967296\")");
  CHECK(refusal_of(replaced("<plane id=\"5\"", "<plane id=\"3\"")) ==
        "m.xml:20: plane 3: another plane has the same id");
  CHECK(refusal_of(replaced("points=\"18231\"", "points=\"-1\"")) ==
        "m.xml:5: plane 3: `points` is not a number of its range (\"-1\")");
  CHECK(refusal_of(replaced("seen=\"+\"", "seen=\"up\"")) ==
        "m.xml:5: plane 3: `seen` is none of +, - and both");
}

TEST_CASE("covariances, moments and polygons that break a rule are named by id and line") {
  CHECK(refusal_of(replaced("upper=\"1e-06 ", "upper=\"-1e-05 ")) ==
        "m.xml:5: plane 3: the covariance is not positive semidefinite");
  CHECK(refusal_of(replaced(" 0.00025\"", "\"")) ==
        "m.xml:6: plane 3, covariance: `upper` holds 9 numbers where 10 are wanted");
  CHECK(refusal_of(replaced(" 0.00025\"", " 0.00025 0\"")) ==
        "m.xml:6: plane 3, covariance: `upper` holds 11 numbers where 10 are wanted");
  CHECK(refusal_of(replaced(" 0.00025\"", " much\"")) ==
        "m.xml:6: plane 3, covariance: `upper` is not a number of its range (\"much\")");
  CHECK(refusal_of(replaced("<moments", "<covariance upper=\"0 0 0 0 0 0 0 0 0 0\"/><moments")) ==
        "m.xml:5: plane 3: has two covariances");
  CHECK(refusal_of(replaced("mean=\"0.1 -0.2 0.75\"", "")) == "m.xml:7: plane 3, moments: has no `mean`");
  CHECK(refusal_of(replaced("scatter=\"1 ", "scatter=\"inf ")) ==
        "m.xml:5: plane 3: the moments hold what is not a finite number");
  CHECK(refusal_of(
            replaced("<moments", "<moments weight=\"0\" mean=\"0 0 0\" scatter=\"0 0 0 0 0 0\"/><moments")) ==
        "m.xml:5: plane 3: has moments twice");
  CHECK(refusal_of(replaced("hole=\"true\"", "hole=\"yes\"")) ==
        "m.xml:14: plane 3, polygon: `hole` is neither \"true\" nor \"false\"");
  CHECK(refusal_of(replaced("hole=\"true\"", "hole=\"0\"")) ==
        "m.xml:14: plane 3, polygon 2: runs clockwise seen from where the normal points");
  CHECK(refusal_of(replaced("<v x=\"1\" y=\"0\" z=\"0.75\"", "<v x=\"1\" y=\"0\" z=\"0.85\"")) ==
        "m.xml:8: plane 3, polygon 1: point 2 lies 0.1 off the plane");
  CHECK(refusal_of(replaced("<v x=\"1\" y=\"0\" z=\"0.75\"", "<v x=\"1\" y=\"0\"")) ==
        "m.xml:10: plane 3, v: has no `z`");
}

TEST_CASE("files of planes: missing, too long, all breaches") {
  const TemporaryFolder folder;
  const auto missing = read_plane_map(folder / "no.xml");
  REQUIRE_FALSE(missing);
  CHECK(missing.failure().problem == Problem::cannot_read);
  const auto huge = folder.put("huge.xml", "");
  std::filesystem::resize_file(huge, max_map_file_bytes + 1);  // takes no room: a hole
  const auto too_long = read_plane_map(huge);
  REQUIRE_FALSE(too_long);
  CHECK(too_long.failure().problem == Problem::bad_content);

  std::string text = replaced("d=\"0.75\"", "d=\"0.5\"");
  text.replace(text.find("ny=\"0.6\""), 8, "ny=\"0.7\"");
  const auto bad = folder.put("bad.xml", text);
  const auto sentences = validate_plane_map(bad);
  REQUIRE(sentences);
  REQUIRE(sentences->size() == 3);
  CHECK((*sentences)[0] == bad.string() + ":8: plane 3, polygon 1: point 1 lies 0.25 off the plane");
  CHECK((*sentences)[1] == bad.string() + ":14: plane 3, polygon 2: point 1 lies 0.25 off the plane");
  CHECK((*sentences)[2].starts_with(bad.string() + ":20: plane 5: the length of its normal is not 1"));
  const auto fine = validate_plane_map(folder.put("good.xml", good()));
  REQUIRE(fine);
  CHECK(fine->empty());
}

TEST_CASE("the kind of a map is told by its root alone") {
  const TemporaryFolder folder;
  const auto kind_of = [&](const std::string& xml) { return map_kind(folder.put("m.xml", xml)); };
  REQUIRE(kind_of(good()));
  CHECK(*kind_of(good()) == MapKind::planes);
  CHECK(*kind_of(*line_map_to_xml(small_line_map())) == MapKind::lines);
  CHECK(*kind_of(head + "<broken") == MapKind::planes);
  CHECK(*kind_of("<!-- <map kind='lines'> -->\n<map note='>' format='straightedge-map' version='1' "
                 "kind='planes'/>") == MapKind::planes);
  for (const std::string xml :
       {"", "text", "<svg/>", "<map", "<map format='straightedge-map' kind='lines'>",
        "<map format='straightedge-map' version='2' kind='lines'>", "<!DOCTYPE map><map/>",
        "<map format='straightedge-map' version='1' kind='cubes'/>", "<!--", "<map a='"}) {
    INFO(xml);
    const auto kind = kind_of(xml);
    REQUIRE_FALSE(kind);
    CHECK(kind.failure().problem == Problem::bad_content);
  }
  CHECK(map_kind(folder / "no.xml").failure().problem == Problem::cannot_read);
}
