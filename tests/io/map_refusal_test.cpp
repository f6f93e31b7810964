// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <string>

#include "catch.hpp"
#include "random_line_map.hpp"
#include "straightedge/host/map_file.hpp"
#include "support/replaced.hpp"
#include "temporary_folder.hpp"

using namespace straightedge;

namespace {

std::string good() {
  return *line_map_to_xml(small_line_map());
}

std::string replaced(const std::string& what, const std::string& by) {
  return ::replaced(good(), what, by);
}

std::string refusal_of(const std::string& xml) {
  const auto map = line_map_from_xml(xml, "m.xml");
  INFO(xml.substr(0, 500));
  REQUIRE_FALSE(map);
  CHECK(map.failure().problem == Problem::bad_content);
  return map.failure().sentence;
}

const std::string head = "<map format=\"straightedge-map\" version=\"1\" kind=\"lines\">";

}  // namespace

TEST_CASE("the text that the refusals start from is good") {
  REQUIRE(line_map_from_xml(good(), "m.xml"));
}

TEST_CASE("what is not well-formed") {
  CHECK(refusal_of("") == "m.xml:0: is not well-formed XML: it is empty");
  CHECK(refusal_of("no xml").starts_with("m.xml:"));
  CHECK(refusal_of(replaced("</map>", "")) ==
        "m.xml:2: is not well-formed XML: it is broken or ends too early");
  CHECK(refusal_of(replaced("</line>", "</lime>")).find("closed by another's name") != std::string::npos);
  CHECK(refusal_of(replaced("id=\"3\"", "id=\"3\" id=\"4\"")) ==
        "m.xml:6: is not well-formed XML: an attribute is broken or given twice");
  CHECK(refusal_of(replaced("id=\"3\"", "id=3")).starts_with("m.xml:6: is not well-formed XML"));
  CHECK(refusal_of(good() + "<map/>").find("outside of the root") != std::string::npos);
  CHECK(refusal_of(good() + "more") == "m.xml:15: is not well-formed XML: a text has no end");
  CHECK(refusal_of(std::string("<map>\n\0</map>", 13)) == "m.xml:2: is not XML: it holds a zero byte");
  for (std::size_t length = 0; length + 2 < good().size(); length += 7) {
    CHECK_FALSE(line_map_from_xml(good().substr(0, length), "m.xml"));
  }
}

TEST_CASE("document types and entities are not read") {
  const std::string laughs =
      "<?xml version=\"1.0\"?>\n<!-- ha -->\n<!DOCTYPE map [<!ENTITY a \"ha\"><!ENTITY b "
      "\"&a;&a;&a;&a;\">]>\n" +
      head + "<meta name=\"&b;\"/></map>";
  CHECK(refusal_of(laughs) == "m.xml:3: has a document type, which is not read");
  CHECK(refusal_of("<!DOCTYPE map SYSTEM \"file:///etc/passwd\">" + head + "</map>") ==
        "m.xml:1: has a document type, which is not read");
  // An entity that nobody declared stays the text that it is.
  const auto map = line_map_from_xml(head + "<meta name=\"&b;\"/><frame unit=\"pixel\"/></map>", "m.xml");
  REQUIRE(map);
  CHECK(map->meta.name == "&b;");
}

TEST_CASE("deep nesting is refused, not followed") {
  std::string deep = head;
  for (int i = 0; i < 200000; ++i) deep += "<x>";
  CHECK(refusal_of(deep) == "m.xml:1: is not well-formed XML: its elements are nested too deeply");
}

TEST_CASE("other documents, versions and kinds") {
  CHECK(refusal_of("<svg/>") == "m.xml:1: is not a straightedge-map");
  CHECK(refusal_of("<map format=\"other\" version=\"1\" kind=\"lines\"/>") ==
        "m.xml:1: is not a straightedge-map");
  CHECK(refusal_of(replaced("version=\"1\" kind", "version=\"2\" kind")) ==
        "m.xml:2: was written by a newer version (format version 2, and up to 1 is read here)");
  CHECK(refusal_of(replaced("version=\"1\" kind", "version=\"0\" kind")) ==
        "m.xml:2: map: the format's version is below 1");
  CHECK(refusal_of(replaced("version=\"1\" kind", "version=\"new\" kind")) ==
        "m.xml:2: map: `version` is not a number of its range (\"new\")");
  CHECK(refusal_of(replaced("version=\"1\" kind", "kind")) == "m.xml:2: map: has no `version`");
  CHECK(refusal_of(replaced("kind=\"lines\"", "kind=\"planes\"")) ==
        "m.xml:2: is a map of planes where a map of lines is wanted");
  CHECK(refusal_of(replaced("kind=\"lines\"", "kind=\"dots\"")) ==
        "m.xml:2: map: `kind` is neither \"lines\" nor \"planes\"");
}

TEST_CASE("frames and images that are unknown or incomplete") {
  CHECK(refusal_of(replaced("unit=\"pixel\"", "unit=\"inch\"")) ==
        "m.xml:4: frame: `unit` is neither \"pixel\" nor \"metre\"");
  CHECK(refusal_of(replaced("unit=\"pixel\"", "unit=\"metre\"")) ==
        "m.xml:4: frame: `origin` is not \"world\"");
  CHECK(refusal_of(replaced("angle=\"radian\"", "angle=\"degree\"")) ==
        "m.xml:4: frame: `angle` is not \"radian\"");
  CHECK(refusal_of(replaced("y=\"up\"", "y=\"down\"")) == "m.xml:4: frame: `y` is not \"up\"");
  CHECK(refusal_of(replaced("unit=\"pixel\" ", "")) == "m.xml:4: frame: has no `unit`");
  CHECK(refusal_of(head + "</map>") == "m.xml:1: has no `frame`, so its unit is unknown");
  CHECK(refusal_of(head + "<frame unit=\"pixel\"/><frame unit=\"pixel\"/></map>") ==
        "m.xml:1: frame: stands there twice");
  CHECK(refusal_of(replaced("width=\"640\"", "")) == "m.xml:5: image: has no `width`");
  CHECK(refusal_of(replaced("width=\"640\"", "width=\"-640\"")) ==
        "m.xml:5: image: width and height are not above zero");
  CHECK(refusal_of(replaced("width=\"640\"", "width=\"1e9\"")) ==
        "m.xml:5: image: `width` is not a number of its range (\"1e9\")");
  CHECK(refusal_of(replaced("resolution=\"0.05\"", "resolution=\"0\"")) ==
        "m.xml:5: image: the resolution is not above zero");
  CHECK(refusal_of(replaced("resolution=\"0.05\"", "")) ==
        "m.xml:5: image: has an origin but no `resolution`");
  CHECK(refusal_of(replaced("mode=\"trinary\"", "mode=\"3\"")) ==
        "m.xml:5: image: `mode` is none of trinary, scale and raw");
  CHECK(refusal_of(replaced("negate=\"0\"", "negate=\"no\"")) ==
        "m.xml:5: image: `negate` is neither 0 nor 1");
}

TEST_CASE("lines and segments that break a rule are named by id and line") {
  CHECK(refusal_of(replaced("rho=\"101.25\"", "rho=\"nan\"")) ==
        "m.xml:6: line 3: rho or theta is not a finite number");
  CHECK(refusal_of(replaced("rho=\"101.25\"", "rho=\"inf\"")) ==
        "m.xml:6: line 3: rho or theta is not a finite number");
  CHECK(refusal_of(replaced("rho=\"101.25\"", "rho=\"-101.25\"")) ==
        "m.xml:6: line 3: rho is negative (-101.25)");
  CHECK(refusal_of(replaced("rho=\"101.25\"", "rho=\"101,25\"")) ==
        "m.xml:6: line 3: `rho` is not a number of its range (\"101,25\")");
  CHECK(refusal_of(replaced("rho=\"101.25\"", "rho=\"1e999\"")) ==
        "m.xml:6: line 3: `rho` is not a number of its range (\"1e999\")");
  CHECK(refusal_of(replaced("rho=\"101.25\"", "")) == "m.xml:6: line 3: has no `rho`");
  CHECK(refusal_of(replaced("<line id=\"3\"", "<line")) == "m.xml:6: line: has no `id`");
  CHECK(refusal_of(replaced("<line id=\"3\"", "<line id=\"-3\"")) ==
        "m.xml:6: line -3: `id` is not a number of its range (\"-3\")");
  CHECK(refusal_of(replaced("<line id=\"5\"", "<line id=\"3\"")) ==
        "m.xml:11: line 3: another line has the same id");
  CHECK(refusal_of(replaced("free=\"both\"", "free=\"left\"")) ==
        "m.xml:6: line 3: `free` is none of +, - and both");
  CHECK(refusal_of(replaced("var-theta=\"2.9e-06\"", "var-theta=\"-1\"")) ==
        "m.xml:6: line 3: the covariance is not positive semi-definite: a variance is negative");
  CHECK(refusal_of(replaced("var-theta=\"2.9e-06\" ", "")) ==
        "m.xml:7: line 3, covariance: has no `var-theta`");
  CHECK(refusal_of(replaced("y1=\"101.25\" pixels=\"30\"", "y1=\"101.5\"")) ==
        "m.xml:9: line 3, segment 11: an end lies 0.25 off its line");
  CHECK(refusal_of(replaced("x0=\"120.5\"", "x0=\"-120.5\"")) ==
        "m.xml:8: line 3, segment 10: the ends are in the wrong order along (-sin theta, cos theta)");
  CHECK(refusal_of(replaced("x0=\"120.5\"", "x0=\"-113.5\"")) ==
        "m.xml:8: line 3, segment 10: its length is zero");
  CHECK(refusal_of(replaced("x0=\"120.5\" ", "")) == "m.xml:8: segment 10: has no `x0`");
  CHECK(refusal_of(replaced("segment id=\"12\"", "segment id=\"10\"")) ==
        "m.xml:12: line 5, segment 10: another segment has the same id");
}

TEST_CASE("files: missing, a folder, too long, all breaches") {
  const TemporaryFolder folder;
  const auto missing = read_line_map(folder / "no.xml");
  REQUIRE_FALSE(missing);
  CHECK(missing.failure().problem == Problem::cannot_read);
  CHECK(missing.failure().sentence ==
        (folder / "no.xml").string() + ": cannot be opened (No such file or directory)");
  CHECK_FALSE(read_line_map(folder.path()));

  const auto huge = folder.put("huge.xml", "");
  std::filesystem::resize_file(huge, max_map_file_bytes + 1);  // takes no room: a hole
  const auto too_long = read_line_map(huge);
  REQUIRE_FALSE(too_long);
  CHECK(too_long.failure().problem == Problem::bad_content);

  std::string text = replaced("rho=\"101.25\"", "rho=\"-101.25\"");
  text.replace(text.find("x0=\"20\""), 7, "x0=\"21\"");
  const auto bad = folder.put("bad.xml", text);
  const auto sentences = validate_line_map(bad);
  REQUIRE(sentences);
  REQUIRE(sentences->size() == 2);
  CHECK((*sentences)[0] == bad.string() + ":6: line 3: rho is negative (-101.25)");
  CHECK((*sentences)[1] == bad.string() + ":12: line 5, segment 12: an end lies 1 off its line");
  const auto fine = validate_line_map(folder.put("good.xml", good()));
  REQUIRE(fine);
  CHECK(fine->empty());
}
