// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <cstdlib>
#include <string>

#include "catch.hpp"
#include "io/plane_view_controls.hpp"
#include "io/plane_view_geometry.hpp"
#include "io/plane_view_painter.hpp"
#include "io/plane_view_pointers.hpp"
#include "room_plane_map.hpp"
#include "straightedge/host/plane_view.hpp"
#include "temporary_folder.hpp"

using namespace straightedge;

namespace {

const std::string node = STRAIGHTEDGE_NODE;

/// Whether node runs the words without complaint; its own words go to the test's output.
bool runs(const std::string& words) {
  return std::system((node + " " + words + " 1>&2").c_str()) == 0;
}

std::string page_part(const std::string& page, const std::string& open) {
  const std::size_t begin = page.find(open) + open.size();
  return page.substr(begin, page.find("</script>", begin) - begin);
}

}  // namespace

TEST_CASE("the viewer's script is JavaScript") {
  if (node.empty()) return;  // a machine without node checks the rest
  const TemporaryFolder folder;
  int part = 0;
  for (const char* script :
       {io::plane_view_geometry, io::plane_view_painter, io::plane_view_pointers, io::plane_view_controls}) {
    CHECK(runs("--check " + folder.put("part" + std::to_string(part++) + ".js", script).string()));
  }
  CHECK_FALSE(runs("--check " + folder.put("broken.js", "const = 1;").string() + " 2>" +
                   (folder / "words").string()));
}

TEST_CASE("the viewer projects, sorts and hits as rays of sight do") {
  if (node.empty()) return;
  const TemporaryFolder folder;
  PlaneViewOptions options;
  for (const UpAxis up : {UpAxis::z, UpAxis::minus_y}) {
    options.up = up;
    const std::string page = plane_map_html(room_plane_map(), options);
    const std::string data = page_part(page, "id=\"map\">");
    const auto script =
        folder.put("geometry.js", std::string(io::plane_view_geometry) + "module.exports = Geometry;");
    const auto map = folder.put("map.json", data);
    CHECK(runs(std::string(STRAIGHTEDGE_SCRIPT_CHECKS) + " " + script.string() + " " + map.string()));
  }
}
