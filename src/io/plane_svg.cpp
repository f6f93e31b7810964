// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <tinyxml2.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "io/hex_colour.hpp"
#include "io/label_layout.hpp"
#include "io/map_colours.hpp"
#include "io/number_text.hpp"
#include "io/plane_paint_order.hpp"
#include "io/plane_scene.hpp"
#include "io/svg_canvas.hpp"
#include "io/xml_text.hpp"
#include "straightedge/host/plane_view.hpp"
#include "straightedge/trigonometry.hpp"

namespace straightedge {
namespace {

using tinyxml2::XMLElement;

constexpr double view_size = 620;  // the longer side of what a view shows, and its width
constexpr double head_height = 34, foot_height = 40, gap = 20;
constexpr double wall_tilt = 0.35;  // a plane that rises more steeply than 70° is a wall
constexpr double label_height = 12, digit_width = 6.3;
constexpr std::size_t crowd = 150;                // so many pieces are a crowd:
constexpr int crowded_rings = 1, free_rings = 6;  // ids stay near their pieces in it (LabelLayout)

constexpr const char* style_sheet =
    "text{font:11px sans-serif;fill:#1d2125}.title{font-size:15px;font-weight:bold}.note{fill:#66707b}"
    ".id{font-weight:bold;text-anchor:middle;stroke:#fff;stroke-width:2.6;stroke-linejoin:round;"
    "paint-order:stroke}.plane{stroke-width:1;stroke-linejoin:round;fill-rule:evenodd}"
    ".wall{stroke-width:3.4;stroke-linejoin:round}.leader{stroke:#1d2125;stroke-width:.6}"
    ".scale{fill:none;stroke:#1d2125;stroke-width:1.2}.path{fill:none;stroke-width:1.3}";

XMLElement& add(XMLElement& parent, const char* name, const char* kind = nullptr) {
  XMLElement& element = *parent.InsertNewChildElement(name);
  if (kind != nullptr) element.SetAttribute("class", kind);
  return element;
}

void set(XMLElement& element, const char* name, double value) {
  element.SetAttribute(name, io::to_text(value, 2).c_str());
}

void text(XMLElement& group, const char* kind, Point2 at, const std::string& words) {
  XMLElement& element = add(group, "text", kind);
  set(element, "x", at.x);
  set(element, "y", at.y);
  element.SetText(words.c_str());
}

/// Between two colours; share 0 is the first.
Rgb mixed(Rgb a, Rgb b, double share) {
  const auto one = [share](unsigned char from, unsigned char to) {
    return static_cast<unsigned char>(from + (to - from) * share + 0.5);
  };
  return {one(a.red, b.red), one(a.green, b.green), one(a.blue, b.blue)};
}

/// One view of the scene.
class ViewDrawing {
 public:
  ViewDrawing(const io::PlaneScene& scene, const io::ParallelView& view, const PlaneSvgOptions& options,
              bool plan)
      : scene_(scene), view_(view), options_(options), plan_(plan) {
    io::Bounds bounds;
    const auto include = [&](const Vector3& p) { bounds.include(view_.on_paper(io::upright(p, scene_.up))); };
    for (const io::ScenePiece& piece : scene_.pieces) std::ranges::for_each(piece.rings.front(), include);
    for (const Pose& pose : options_.camera_path) {
      if (io::drawable(pose.translation)) include(pose.translation);
    }
    canvas_ = io::canvas_of_bounds(bounds, view_size);
  }

  double height() const noexcept { return canvas_.height; }

  /// In the middle of the part of the drawing that begins at `left` and is `height` high.
  void run(XMLElement& root, double left, double height) {
    height_ = height;
    shift_ = {0.5 * (view_size - canvas_.width), 0.5 * (height - canvas_.height)};
    group_ = &add(root, "g", plan_ ? "plan" : "oblique");
    const std::string move = "translate(" + io::to_text(left, 2) + " " + io::to_text(head_height, 2) + ")";
    group_->SetAttribute("transform", move.c_str());
    const std::vector<std::size_t> order = io::paint_order(scene_, view_);
    for (const std::size_t i : order) draw_piece(scene_.pieces[i]);
    draw_path();
    if (options_.ids) draw_ids(order);
    draw_scale();
  }

 private:
  Point2 place(const Vector3& world) const {
    const Point2 p = canvas_(view_.on_paper(io::upright(world, scene_.up)));
    return {p.x + shift_.x, p.y + shift_.y};
  }

  Vector3 normal_of(const io::ScenePiece& piece) const {
    return io::upright(scene_.planes[piece.plane].plane->plane.normal, scene_.up);
  }
  bool is_wall(const io::ScenePiece& piece) const {
    return plan_ && std::abs(normal_of(piece).z) < wall_tilt;
  }
  bool seen_from_behind(const io::ScenePiece& piece) const {
    return scene_.planes[piece.plane].front * dot(normal_of(piece), view_.to_eye) < 0;
  }

  /// Lighter where light from the left, the front and above falls on it.
  Rgb face_colour(const io::ScenePiece& piece) const {
    constexpr double paper_share = 0.35, darkest = 0.62;
    const Vector3 light = normalized({-0.35, -0.55, 1});
    const Rgb base = mixed(plane_colour(scene_.planes[piece.plane].plane->id), {255, 255, 255}, paper_share);
    return mixed({0, 0, 0}, base, darkest + (1 - darkest) * std::abs(dot(normal_of(piece), light)));
  }

  void draw_piece(const io::ScenePiece& piece) {
    const bool wall = is_wall(piece);
    const bool pale = !wall && seen_from_behind(piece);
    const Rgb face = wall ? plane_colour(scene_.planes[piece.plane].plane->id) : face_colour(piece);
    XMLElement& shape = add(*group_, "path", wall ? "wall" : "plane");
    shape.SetAttribute("data-plane", scene_.planes[piece.plane].plane->id);
    shape.SetAttribute("d", outline(piece).c_str());
    shape.SetAttribute("fill", io::hex(face).c_str());
    shape.SetAttribute("fill-opacity", pale ? "0.05" : "0.88");
    shape.SetAttribute("stroke", io::hex(wall ? face : mixed(face, {0x1d, 0x21, 0x25}, 0.45)).c_str());
    if (pale) shape.SetAttribute("stroke-opacity", "0.35");
  }

  /// Vertices nearer to the last one than can be seen are left out.
  std::string outline(const io::ScenePiece& piece) const {
    constexpr double visible = 0.3;
    std::string d;
    for (const std::vector<Vector3>& ring : piece.rings) {
      Point2 last;
      bool first = true;
      for (const Vector3& vertex : ring) {
        const Point2 p = place(vertex);
        if (!first && std::abs(p.x - last.x) + std::abs(p.y - last.y) < visible) continue;
        d += first ? "M" : "L";
        d += io::to_text(p.x, 1);
        d += ' ';
        d += io::to_text(p.y, 1);
        first = false;
        last = p;
      }
      d += 'Z';
    }
    return d;
  }

  void draw_path() {
    constexpr double look = 9;
    const std::span<const Pose> camera_path = options_.camera_path;
    if (camera_path.empty()) return;
    std::string line, looks;
    const auto point = [](std::string& d, char command, Point2 p) {
      d += command;
      d += io::to_text(p.x, 1);
      d += ' ';
      d += io::to_text(p.y, 1);
    };
    const std::size_t every = 1 + camera_path.size() / 60;
    for (std::size_t i = 0; i < camera_path.size(); ++i) {
      const Pose& pose = camera_path[i];
      const Vector3 forward = io::upright(pose.turned({0, 0, 1}), scene_.up);
      if (!io::drawable(pose.translation) || !finite(forward)) continue;
      const Point2 at = place(pose.translation);
      point(line, line.empty() ? 'M' : 'L', at);
      if (i % every != 0) continue;
      const Point2 way = view_.on_paper(forward);
      point(looks, 'M', at);
      point(looks, 'L', {at.x + look * way.x, at.y - look * way.y});
    }
    for (const std::string& d : {line, looks}) {
      XMLElement& shape = add(*group_, "path", "path");
      shape.SetAttribute("d", d.c_str());
      shape.SetAttribute("stroke", io::hex(io::camera_colour).c_str());
    }
  }

  /// The nearest pieces choose first; those that are pale say nothing.
  void draw_ids(const std::vector<std::size_t>& order) {
    io::LabelLayout layout({0, 0, view_size, height_});
    const int rings = order.size() > crowd ? crowded_rings : free_rings;
    XMLElement& group = add(*group_, "g");
    for (auto i = order.rbegin(); i != order.rend(); ++i) {
      const io::ScenePiece& piece = scene_.pieces[*i];
      if (!is_wall(piece) && seen_from_behind(piece)) continue;
      const std::string words = io::to_text(scene_.planes[piece.plane].plane->id);
      const Point2 wanted = place(piece.anchor);
      const double width = digit_width * static_cast<double>(words.size()) + 4;
      const auto at = layout.place(wanted, width, label_height, rings);
      if (!at) continue;
      if (std::abs(at->x - wanted.x) + std::abs(at->y - wanted.y) > label_height) {
        XMLElement& leader = add(group, "line", "leader");
        set(leader, "x1", wanted.x);
        set(leader, "y1", wanted.y);
        set(leader, "x2", at->x);
        set(leader, "y2", at->y);
      }
      text(group, "id", {at->x, at->y + 4}, words);
    }
  }

  /// A round length that is between a tenth and a fourth of the view.
  void draw_scale() {
    double metres = 1;
    while (metres * canvas_.scale > 0.25 * view_size) metres /= 10;
    while (10 * metres * canvas_.scale <= 0.25 * view_size) metres *= 10;
    for (const double factor : {5.0, 2.0}) {
      if (factor * metres * canvas_.scale <= 0.25 * view_size) {
        metres *= factor;
        break;
      }
    }
    const double length = metres * canvas_.scale;
    const double y = height_ + 20;
    std::string d = "M10 " + io::to_text(y - 4, 1);
    d += "v4h" + io::to_text(length, 2);
    d += "v-4";
    add(*group_, "path", "scale").SetAttribute("d", d.c_str());
    std::string words = io::to_short_text(metres) + " m";
    if (!plan_) {
      words += " across, ";
      words += io::to_short_text(metres / view_.up.z);
      words += " m upwards";
    }
    text(*group_, "note", {18 + length, y + 1}, words);
  }

  const io::PlaneScene& scene_;
  const io::ParallelView view_;
  const PlaneSvgOptions& options_;
  const bool plan_;
  io::SvgCanvas canvas_;
  double height_ = 0;
  XMLElement* group_ = nullptr;
  Point2 shift_;
};

void open(XMLElement& root, const MapMeta& meta, const std::string& wanted_title, double width,
          double height) {
  root.SetAttribute("xmlns", "http://www.w3.org/2000/svg");
  set(root, "width", width);
  set(root, "height", height);
  const std::string box = "0 0 " + io::to_text(width, 2) + " " + io::to_text(height, 2);
  root.SetAttribute("viewBox", box.c_str());
  const std::string& named = !wanted_title.empty() ? wanted_title : meta.name;
  const std::string title = io::text_for_xml(named.empty() ? "Plane map" : named);
  add(root, "title").SetText(title.c_str());
  if (!meta.tool.empty()) add(root, "desc").SetText(io::text_for_xml(meta.tool + " " + meta.options).c_str());
  add(root, "style").SetText(style_sheet);
  XMLElement& ground = add(root, "rect");
  ground.SetAttribute("width", "100%");
  ground.SetAttribute("height", "100%");
  ground.SetAttribute("fill", "#fff");
  text(root, "title", {gap, 22}, title);
}

}  // namespace

std::string plane_map_svg(const PlaneMap& map, const PlaneSvgOptions& options) {
  const io::PlaneScene scene = io::plane_scene(map, options.up, options.camera_path);
  ViewDrawing plan(scene, io::ParallelView::from(-90 * degree, 90 * degree), options, true);
  ViewDrawing oblique(scene, io::ParallelView::from(io::oblique_turn(scene) * degree, 32 * degree), options,
                      false);
  const double height = std::max(plan.height(), oblique.height());

  tinyxml2::XMLDocument document;
  XMLElement& root = *document.NewElement("svg");
  document.InsertEndChild(&root);
  open(root, map.meta, options.title, 2 * view_size + 3 * gap, head_height + height + foot_height);
  plan.run(root, gap, height);
  oblique.run(root, view_size + 2 * gap, height);
  tinyxml2::XMLPrinter printer;
  document.Print(&printer);
  return std::string(printer.CStr(), static_cast<std::size_t>(printer.CStrSize() - 1));
}

}  // namespace straightedge
