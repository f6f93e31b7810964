// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "straightedge/host/plane_view.hpp"

#include <initializer_list>
#include <string_view>

#include "io/number_text.hpp"
#include "io/plane_scene.hpp"
#include "io/plane_view_controls.hpp"
#include "io/plane_view_data.hpp"
#include "io/plane_view_geometry.hpp"
#include "io/plane_view_painter.hpp"
#include "io/plane_view_pointers.hpp"
#include "io/plane_view_style.hpp"
#include "io/xml_text.hpp"

namespace straightedge {
namespace {

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : io::text_for_xml(text)) {
    if (c == '<') {
      result += "&lt;";
    } else if (c == '>') {
      result += "&gt;";
    } else if (c == '&') {
      result += "&amp;";
    } else {
      result += c;
    }
  }
  return result;
}

// The policy forbids the page to load anything, whatever is in it.
constexpr const char* head = R"(<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta http-equiv="Content-Security-Policy"
  content="default-src 'none'; style-src 'unsafe-inline'; script-src 'unsafe-inline'; img-src data:">
<link rel="icon" href="data:,">
)";

constexpr const char* stage = R"(<main>
<canvas id="canvas" tabindex="0" role="application"
  aria-label="The map. Arrow keys turn it, with shift they move it, plus and minus magnify."></canvas>
<div class="tools">
<div><button id="iso" title="obliquely from above; key i">Iso</button><button id="top"
  title="from above; key t">Top</button><button id="front" title="key f">Front</button><button id="side"
  title="from the right; key s">Side</button><button id="reset"
  title="all planes, seen obliquely from above; key 0">Reset</button></div>
<div><button id="points" title="readings; key p">Points</button><button id="ids"
  title="key n">Ids</button><button id="path" title="cameras; key c">Path</button><button id="inside"
  title="planes seen from behind are pale; key w">See inside</button><button id="perspective"
  title="key e">Perspective</button></div>
</div>
<p class="help">drag: turn · shift or right drag: move · wheel: zoom</p>
</main>
<aside>
<section id="detail" aria-live="polite"></section>
<div class="list"><table>
<thead><tr><th><input type="checkbox" id="all" checked aria-label="show all planes"></th>
<th><button value="1">id</button></th><th><button value="2">normal</button></th><th><button
  value="3">size, m</button></th><th><button value="4">points</button></th><th><button
  value="5">sightings</button></th></tr></thead>
<tbody id="rows"></tbody>
</table></div>
)";

std::string counted(std::size_t count, const char* one, const char* many) {
  return io::to_text(count) + " " + (count == 1 ? one : many);
}

std::string summary(const io::PlaneScene& scene, const PlaneViewOptions& options) {
  double area = 0;
  for (const io::ScenePlane& plane : scene.planes) area += plane.area;
  std::string text = counted(scene.planes.size(), "plane", "planes");
  if (area > 0 && finite({area, 0, 0})) {
    text += ", ";
    text += io::to_text(area, area < 10 ? 2 : 1);
    text += " m²";
  }
  if (!options.camera_path.empty()) {
    text += ", ";
    text += counted(options.camera_path.size(), "frame", "frames");
  }
  return text;
}

std::string footer(const MapMeta& meta) {
  std::string text;
  for (const std::string& part : {meta.description, meta.tool, meta.options, meta.created}) {
    if (part.empty()) continue;
    if (!text.empty()) text += " · ";
    text += part;
  }
  return text;
}

}  // namespace

std::string plane_map_html(const PlaneMap& map, const PlaneViewOptions& options) {
  const io::PlaneScene scene = io::plane_scene(map, options.up, options.camera_path);
  const std::string title = escaped(!options.title.empty()   ? options.title
                                    : !map.meta.name.empty() ? map.meta.name
                                                             : "Plane map");
  std::string page = head;
  const auto add = [&page](std::initializer_list<std::string_view> parts) {
    for (const std::string_view part : parts) page += part;
  };
  add({"<title>", title, "</title>\n<style>", io::plane_view_style, "</style>\n</head>\n<body>\n"});
  add({"<header><h1>", title, "</h1><p>", summary(scene, options), "</p></header>\n", stage});
  add({"<footer>", escaped(footer(map.meta)), "</footer>\n</aside>\n"});
  add({"<noscript>The map is drawn by a script of this page, which the browser does not run.</noscript>\n"});
  add({"<script type=\"application/json\" id=\"map\">", io::plane_view_data(map, scene, options),
       "</script>\n"});
  for (const char* script :
       {io::plane_view_geometry, io::plane_view_painter, io::plane_view_pointers, io::plane_view_controls}) {
    add({"<script>", script, "</script>\n"});
  }
  add({"</body>\n</html>\n"});
  return page;
}

}  // namespace straightedge
