// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "straightedge/host/floor_svg.hpp"

#include <tinyxml2.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "io/floor_legend.hpp"
#include "io/floor_style.hpp"
#include "io/number_text.hpp"
#include "io/svg_canvas.hpp"
#include "io/symmetric_ellipse.hpp"
#include "io/xml_text.hpp"

namespace straightedge {
namespace {

constexpr double wanted_size = 1000;
constexpr double head_height = 30, legend_top = 44, foot_margin = 18;
constexpr double arrow = 9;  ///< half of an arrow head's length
constexpr double around_m = 1.5;

bool usable_point(Point2 p) {
  return usable(Pose2{p.x, p.y, 0});
}

io::SvgCanvas canvas_for(const LineMap& map, const FloorDrawing& drawing) {
  io::Bounds bounds;
  const auto include = [&](Point2 p) {
    if (usable_point(p)) bounds.include(p);
  };
  for (const Point2 p : drawing.view) {
    include({p.x - around_m, p.y - around_m});
    include({p.x + around_m, p.y + around_m});
  }
  if (!bounds.empty()) return io::canvas_of_bounds(bounds, wanted_size);
  for (const MapLine& line : map.lines) {
    for (const MapSegment& segment : line.segments) include(first_end(segment)), include(second_end(segment));
  }
  if (bounds.empty()) std::for_each(drawing.readings.begin(), drawing.readings.end(), include);
  return io::canvas_of_bounds(bounds, wanted_size);
}

class Drawing {
 public:
  Drawing(const LineMap& map, const FloorDrawing& drawing)
      : map_(map),
        drawing_(drawing),
        canvas_(canvas_for(map, drawing)),
        legend_(io::floor_legend(map, drawing, canvas_.width)),
        printer_(nullptr, true) {}

  std::string run() {
    open();
    draw_walls();
    draw_readings();
    for (const FloorPath kind : {FloorPath::odometry, FloorPath::truth, FloorPath::robot}) draw_ways(kind);
    for (const FloorSegment& segment : drawing_.segments) draw_segment(segment);
    for (const FloorMark& mark : drawing_.marks) draw_mark(mark);
    printer_.CloseElement();
    draw_scale();
    draw_legend();
    printer_.CloseElement();
    return {printer_.CStr(), static_cast<std::size_t>(printer_.CStrSize() - 1)};
  }

 private:
  void open() {
    const std::string width = io::to_text(canvas_.width, 2);
    const double foot = legend_top + (legend_.empty() ? 0 : legend_.back().y) + foot_margin;
    const std::string height = io::to_text(canvas_.height + head_height + foot, 2);
    printer_.OpenElement("svg");
    attribute("xmlns", "http://www.w3.org/2000/svg");
    attribute("width", width);
    attribute("height", height);
    attribute("viewBox", io::joined("0 0 ", width, " ", height));
    const std::string title = io::text_for_xml(drawing_.title);
    element("title", title);
    if (!drawing_.description.empty()) element("desc", io::text_for_xml(drawing_.description));
    element("style", io::floor_style);
    printer_.OpenElement("rect");
    attribute("width", "100%");
    attribute("height", "100%");
    attribute("fill", "#fff");
    printer_.CloseElement();
    text("title", {10, 21}, title);
    // What lies outside of the floor shall not run into title and legend.
    printer_.OpenElement("svg");
    attribute("y", io::to_text(head_height, 0));
    attribute("width", width);
    attribute("height", io::to_text(canvas_.height, 2));
  }

  void draw_walls() {
    const auto& bold = drawing_.bold_walls;
    std::string thin, thick;
    for_each_wall([&](const MapLine&, const MapSegment& wall) {
      const bool stands_out = std::find(bold.begin(), bold.end(), wall.id) != bold.end();
      add_line(stands_out ? thick : thin, first_end(wall), second_end(wall));
    });
    path("wall", thin);
    path("bold", thick);
    for_each_wall([&](const MapLine& line, const MapSegment& wall) {
      if (std::find(bold.begin(), bold.end(), wall.id) == bold.end()) return;
      label("wall-id", first_end(wall), second_end(wall), io::to_text(wall.id),
            line.free == FreeSide::minus ? 12 : -12);  // behind the wall
    });
  }

  void draw_readings() {
    std::set<std::pair<int, int>> spots;
    std::string dots;
    for (const Point2 p : drawing_.readings) {
      if (!usable_point(p)) continue;
      const Point2 at = canvas_(p);
      if (!(at.x >= 0 && at.x < canvas_.width && at.y >= 0 && at.y < canvas_.height)) continue;
      if (!spots.emplace(static_cast<int>(at.x), static_cast<int>(at.y)).second) continue;
      dots += io::joined("M", numbers(at), "h0");
    }
    path(io::reading_class(drawing_), dots);
  }

  void draw_ways(FloorPath kind) {
    std::string d;
    for (const FloorWay& way : drawing_.ways) {
      if (way.kind == kind) d += io::way_on_canvas(way.points, canvas_);
    }
    path(io::class_of(kind), d);
  }

  void draw_segment(const FloorSegment& segment) {
    if (!usable_point(segment.from) || !usable_point(segment.to)) return;
    std::string d;
    add_line(d, segment.from, segment.to);
    path(io::class_of(segment.kind), d);
    if (!segment.label.empty())
      label(io::label_class_of(segment.kind), segment.from, segment.to, segment.label, 13);
  }

  void draw_mark(const FloorMark& mark) {
    if (!usable(mark.pose)) return;
    if (mark.covariance) {
      if (const auto ellipse = io::ellipse_of(*mark.covariance)) draw_ellipse(mark.pose, *ellipse);
    }
    const SineCosine turn = sine_cosine(mark.pose.heading_rad);
    arrow_head(mark.kind, canvas_({mark.pose.x_m, mark.pose.y_m}), turn);
  }

  void draw_ellipse(const Pose2& pose, const io::Ellipse& ellipse) {
    const Point2 at = canvas_({pose.x_m, pose.y_m});
    printer_.OpenElement("ellipse");
    attribute("class", "sigma");
    attribute("rx", io::to_text(3 * ellipse.long_sigma * canvas_.scale, 2));
    attribute("ry", io::to_text(3 * ellipse.short_sigma * canvas_.scale, 2));
    attribute("transform", io::joined("translate(", numbers(at), ")rotate(",
                                      io::to_text(-ellipse.angle / degree, 1), ")"));
    printer_.CloseElement();
  }

  void arrow_head(FloorRobot kind, Point2 at, SineCosine turn) {
    const auto corner = [&](double along, double across) {
      return numbers(
          {at.x + along * turn.cosine - across * turn.sine, at.y - along * turn.sine - across * turn.cosine});
    };
    path(io::class_of(kind), io::joined("M", corner(arrow, 0), "L", corner(-arrow, 0.75 * arrow), "L",
                                        corner(-0.5 * arrow, 0), "L", corner(-arrow, -0.75 * arrow), "Z"));
  }

  void draw_scale() {
    const double most = 0.25 * canvas_.width / canvas_.scale;
    double metres = 1e-3;
    while (10 * metres <= most) metres *= 10;
    for (const double factor : {5.0, 2.0}) {
      if (factor * metres > most) continue;
      metres *= factor;
      break;
    }
    const double y = head_height + canvas_.height + 18;
    path("scale",
         io::joined("M12 ", io::to_text(y - 4, 1), "v4h", io::to_text(metres * canvas_.scale, 1), "v-4"));
    text("note", {20 + metres * canvas_.scale, y + 1}, io::joined(io::to_short_text(metres), " m"));
  }

  void draw_legend() {
    for (const io::LegendEntry& entry : legend_) {
      const Point2 at{entry.x, head_height + canvas_.height + legend_top + entry.y};
      if (entry.robot) {
        arrow_head(*entry.robot, {at.x + 10, at.y}, {});
      } else if (entry.dots) {
        path(entry.style, io::joined("M", numbers({at.x + 4, at.y}), "h0m6 2h0m6 -3h0"));
      } else {
        path(entry.style, io::joined("M", numbers(at), "h20"));
      }
      text("note", {at.x + 26, at.y + 4}, entry.words);
    }
  }

  template <class Action>
  void for_each_wall(Action&& action) {
    for (const MapLine& line : map_.lines) {
      for (const MapSegment& segment : line.segments) action(line, segment);
    }
  }

  static std::string numbers(Point2 at) { return io::point_text(at); }

  void add_line(std::string& d, Point2 from, Point2 to) {
    d += io::joined("M", numbers(canvas_(from)), "L", numbers(canvas_(to)));
  }

  /// Beside the middle of a line, on the right of the way (below 0: on the left).
  void label(const char* kind, Point2 from, Point2 to, const std::string& words, double away) {
    const Point2 a = canvas_(from), b = canvas_(to);
    const double length = std::max(1e-9, std::sqrt(dot({b.x - a.x, b.y - a.y}, {b.x - a.x, b.y - a.y})));
    text(kind,
         {0.5 * (a.x + b.x) - away * (b.y - a.y) / length,
          0.5 * (a.y + b.y) + away * (b.x - a.x) / length + 4},
         words);
  }

  void attribute(const char* name, const std::string& value) { printer_.PushAttribute(name, value.c_str()); }

  void element(const char* name, const std::string& words) {
    printer_.OpenElement(name);
    printer_.PushText(words.c_str());
    printer_.CloseElement();
  }

  void path(const char* kind, const std::string& d) {
    if (d.empty()) return;
    printer_.OpenElement("path");
    attribute("class", kind);
    attribute("d", d);
    printer_.CloseElement();
  }

  void text(const char* kind, Point2 at, const std::string& words) {
    printer_.OpenElement("text");
    attribute("class", kind);
    attribute("x", io::to_text(at.x, 1));
    attribute("y", io::to_text(at.y, 1));
    printer_.PushText(words.c_str());
    printer_.CloseElement();
  }

  const LineMap& map_;
  const FloorDrawing& drawing_;
  const io::SvgCanvas canvas_;
  const std::vector<io::LegendEntry> legend_;
  tinyxml2::XMLPrinter printer_;
};

}  // namespace

std::string floor_to_svg(const LineMap& metre_map, const FloorDrawing& drawing) {
  return Drawing(metre_map, drawing).run();
}

}  // namespace straightedge
