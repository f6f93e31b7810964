// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "straightedge/host/svg.hpp"

#include <tinyxml2.h>

#include <cmath>
#include <new>

#include "io/base64.hpp"
#include "io/hex_colour.hpp"
#include "io/image_placement.hpp"
#include "io/map_colours.hpp"
#include "io/number_text.hpp"
#include "io/svg_canvas.hpp"
#include "io/xml_text.hpp"
#include "straightedge/host/atomic_file.hpp"
#include "straightedge/host/image_file.hpp"
#include "straightedge/host/map_file.hpp"

namespace straightedge {
namespace {

using tinyxml2::XMLElement;

constexpr double wanted_size = 900;
constexpr double legend_height = 34;

std::string style_sheet() {
  const std::string face = io::hex(io::face_colour);
  const std::string axis = io::hex(io::axis_colour);
  const std::string free = io::hex(io::free_colour);
  return "line{stroke-width:1.6;stroke-linecap:round}.face{stroke:" + face + "}.axis{stroke:" + axis +
         "}.band{stroke:" + axis + ";stroke-opacity:" + io::to_text(io::band_opacity) +
         ";stroke-linecap:butt}.free{stroke:" + free +
         ";stroke-width:1.2}text{font:10px sans-serif;fill:#222}.id{text-anchor:middle;stroke:#fff;"
         "stroke-width:2.4;paint-order:stroke}.legend{font-size:12px}.picture{opacity:.5;"
         "image-rendering:pixelated}";
}

void set(XMLElement& element, const char* name, double value) {
  element.SetAttribute(name, io::to_text(value, 2).c_str());
}

/// Draws in the coordinates of the canvas.
class Drawing {
 public:
  Drawing(const LineMap& map, const SvgOptions& options, const io::SvgCanvas& canvas)
      : map_(map), options_(options), canvas_(canvas), root_(*document_.NewElement("svg")) {
    document_.InsertEndChild(&root_);
  }

  Result<std::string> run() {
    open();
    if (options_.picture.valid()) {
      if (const auto embedded = embed_picture(); !embedded) return embedded.failure();
    }
    draw_bands();
    draw_lines();
    if (options_.free_sides) draw_free_sides();
    if (options_.ids) draw_ids();
    if (options_.legend) draw_legend();
    tinyxml2::XMLPrinter printer;
    document_.Print(&printer);
    return std::string(printer.CStr(), static_cast<std::size_t>(printer.CStrSize() - 1));
  }

 private:
  void open() {
    const double height = canvas_.height + (options_.legend ? legend_height : 0);
    root_.SetAttribute("xmlns", "http://www.w3.org/2000/svg");
    set(root_, "width", canvas_.width);
    set(root_, "height", height);
    const std::string box = "0 0 " + io::to_text(canvas_.width, 2) + " " + io::to_text(height, 2);
    root_.SetAttribute("viewBox", box.c_str());
    const std::string& name = map_.meta.name.empty() && map_.image ? map_.image->file : map_.meta.name;
    if (!name.empty()) add(root_, "title").SetText(io::text_for_xml(name).c_str());
    const std::string& tool = map_.meta.tool;
    if (!tool.empty()) add(root_, "desc").SetText(io::text_for_xml(tool + " " + map_.meta.options).c_str());
    add(root_, "style").SetText(style_sheet().c_str());
    XMLElement& ground = add(root_, "rect");
    ground.SetAttribute("width", "100%");
    ground.SetAttribute("height", "100%");
    ground.SetAttribute("fill", "#fff");
  }

  /// The picture's pixels are put where the map has them: turned and scaled for a metre map.
  Result<Done> embed_picture() {
    const auto png = encode_png(options_.picture);
    if (!png) return png.failure();
    const Size size = options_.picture.size();
    const io::Similarity map_from_centre =
        map_.unit == MapUnit::pixel ? io::Similarity{} : io::world_from_centre(*map_.image->placement, size);
    const auto place = [&](Point2 uv) { return canvas_(map_from_centre(centre_from_image(uv, size))); };
    const Point2 zero = place({0, 0});
    const Point2 u = place({1, 0});
    const Point2 v = place({0, 1});
    std::string matrix = "matrix(";
    for (const double value : {u.x - zero.x, u.y - zero.y, v.x - zero.x, v.y - zero.y, zero.x}) {
      matrix += io::to_text(value) + " ";
    }
    matrix += io::to_text(zero.y) + ")";
    XMLElement& image = add(root_, "image");
    image.SetAttribute("class", "picture");
    image.SetAttribute("width", size.width);
    image.SetAttribute("height", size.height);
    image.SetAttribute("transform", matrix.c_str());
    image.SetAttribute("href", ("data:image/png;base64," + io::base64(*png)).c_str());
    return Done{};
  }

  void draw_bands() {
    XMLElement& group = add(root_, "g");
    for_each_segment([&](const MapLine& line, const MapSegment& segment) {
      if (!line.width) return;
      XMLElement& band = stroke(group, "band", canvas_(first_end(segment)), canvas_(second_end(segment)));
      const std::string width = "stroke-width:" + io::to_text(*line.width * canvas_.scale, 2);
      band.SetAttribute("style", width.c_str());
    });
  }

  void draw_lines() {
    XMLElement& group = add(root_, "g");
    for_each_segment([&](const MapLine& line, const MapSegment& segment) {
      stroke(group, line.width ? "axis" : "face", canvas_(first_end(segment)), canvas_(second_end(segment)));
    });
  }

  /// Short strokes across the segment, about every 40 units, at least one.
  void draw_free_sides() {
    XMLElement& group = add(root_, "g");
    for_each_segment([&](const MapLine& line, const MapSegment& segment) {
      const Point2 a = canvas_(first_end(segment));
      const Point2 b = canvas_(second_end(segment));
      const Point2 along{b.x - a.x, b.y - a.y};
      const int ticks = static_cast<int>(std::clamp(std::sqrt(dot(along, along)) / 40, 1.0, 200.0));
      const double start = line.width ? 0.5 * *line.width * canvas_.scale : 0;
      for (int i = 0; i < ticks; ++i) {
        const double at = (i + 0.5) / ticks;
        const Point2 on{a.x + at * (b.x - a.x), a.y + at * (b.y - a.y)};
        if (line.free == FreeSide::plus || line.free == FreeSide::both) tick(group, on, line.theta, start, 1);
        if (line.free == FreeSide::minus || line.free == FreeSide::both)
          tick(group, on, line.theta, start, -1);
      }
    });
  }

  void tick(XMLElement& group, Point2 on, double theta, double start, double side) {
    const Point2 normal = line_normal(theta);
    const auto away = [&](double distance) {
      return Point2{on.x + side * distance * normal.x, on.y - side * distance * normal.y};
    };
    stroke(group, "free", away(start), away(start + 6));
  }

  /// Beside the middle, away from the open floor, so that ticks and ids do not meet.
  void draw_ids() {
    XMLElement& group = add(root_, "g");
    for_each_segment([&](const MapLine& line, const MapSegment& segment) {
      const Point2 normal = line_normal(line.theta);
      const double half_width = line.width ? 0.5 * *line.width * canvas_.scale : 0;
      const double away = (half_width + 9) * (line.free == FreeSide::plus ? -1 : 1);
      const Point2 middle =
          canvas_({0.5 * segment.x0 + 0.5 * segment.x1, 0.5 * segment.y0 + 0.5 * segment.y1});
      text(group, "id", {middle.x + away * normal.x, middle.y - away * normal.y + 3.5},
           io::to_text(segment.id));
    });
  }

  void draw_legend() {
    XMLElement& group = add(root_, "g");
    const double y = canvas_.height + legend_height / 2;
    double x = 14;
    const auto entry = [&](const char* kind, const char* words, double room) {
      stroke(group, kind, {x, y}, {x + 22, y});
      text(group, "legend", {x + 28, y + 4}, words);
      x += room;
    };
    entry("face", "face of a wall", 130);
    stroke(group, "band", {x, y}, {x + 22, y}).SetAttribute("style", "stroke-width:7");
    entry("axis", "axis and width of a thin wall", 215);
    if (options_.free_sides) entry("free", "open floor on this side", 180);
    if (options_.ids) text(group, "legend", {x, y + 4}, "numbers: ids of segments");
  }

  template <class Action>
  void for_each_segment(Action&& action) {
    for (const MapLine& line : map_.lines) {
      for (const MapSegment& segment : line.segments) action(line, segment);
    }
  }

  XMLElement& add(XMLElement& parent, const char* name) { return *parent.InsertNewChildElement(name); }

  XMLElement& stroke(XMLElement& group, const char* kind, Point2 a, Point2 b) {
    XMLElement& line = add(group, "line");
    line.SetAttribute("class", kind);
    set(line, "x1", a.x);
    set(line, "y1", a.y);
    set(line, "x2", b.x);
    set(line, "y2", b.y);
    return line;
  }

  void text(XMLElement& group, const char* kind, Point2 at, const std::string& words) {
    XMLElement& element = add(group, "text");
    element.SetAttribute("class", kind);
    set(element, "x", at.x);
    set(element, "y", at.y);
    element.SetText(words.c_str());
  }

  const LineMap& map_;
  const SvgOptions& options_;
  const io::SvgCanvas& canvas_;
  tinyxml2::XMLDocument document_;
  XMLElement& root_;
};

Failure refused(const std::string& sentence) {
  return {Problem::bad_option, sentence};
}

io::SvgCanvas canvas_for(const LineMap& map, bool with_picture) {
  if (map.unit == MapUnit::pixel && map.image) return io::canvas_of_picture(map.image->size, wanted_size);
  io::Bounds bounds;
  for (const MapLine& line : map.lines) {
    for (const MapSegment& segment : line.segments) {
      bounds.include(first_end(segment));
      bounds.include(second_end(segment));
    }
  }
  if (with_picture) {
    const io::Similarity world = io::world_from_centre(*map.image->placement, map.image->size);
    const double x = 0.5 * map.image->size.width;
    const double y = 0.5 * map.image->size.height;
    for (const Point2 corner : {Point2{-x, -y}, Point2{x, -y}, Point2{x, y}, Point2{-x, y}})
      bounds.include(world(corner));
  }
  return io::canvas_of_bounds(bounds, wanted_size);
}

}  // namespace

Result<std::string> line_map_to_svg(const LineMap& map, const SvgOptions& options) try {
  if (const auto breaches = check_line_map(map); !breaches.empty()) {
    return refused("the map breaks a rule of its format: " + breaches.front().sentence);
  }
  const bool with_picture = options.picture.valid();
  if (with_picture && (!map.image || map.image->size != options.picture.size())) {
    return refused("the picture is not of the size that the map states");
  }
  if (with_picture && map.unit == MapUnit::metre && !map.image->placement) {
    return refused("the map is in metres and does not say where its picture lies");
  }
  const io::SvgCanvas canvas = canvas_for(map, with_picture);
  if (!std::isfinite(canvas.width + canvas.height) || !(canvas.scale > 0)) {
    return refused("the map is spread too widely to be drawn");
  }
  return Drawing(map, options, canvas).run();
} catch (const std::bad_alloc&) {
  return Failure{Problem::cannot_write, "the drawing does not fit into memory"};
}

Result<Done> write_svg(const std::filesystem::path& file, const LineMap& map, const SvgOptions& options) {
  const auto svg = line_map_to_svg(map, options);
  if (!svg) return Failure{svg.failure().problem, file.string() + ": " + svg.failure().sentence};
  return write_file_atomically(file, *svg);
}

}  // namespace straightedge
