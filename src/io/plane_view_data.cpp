// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "io/plane_view_data.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <map>
#include <utility>

#include "io/hex_colour.hpp"
#include "io/number_text.hpp"
#include "io/xml_text.hpp"

namespace straightedge::io {
namespace {

constexpr double coarsest_step = 1e-3, finest_step = 1e-9;  // metres
constexpr double steps_across = 5000;                       // at least, in maps that are large enough

/// The integers on which the coordinates of the page are rounded.
class Grid {
 public:
  explicit Grid(const PlaneScene& scene) : step_(coarsest_step) {
    const Vector3 size = scene.high - scene.low;
    const double extent = std::max({size.x, size.y, size.z});
    while (extent > 0 && extent < steps_across * step_ && step_ > finest_step) step_ /= 10;
    const Vector3 middle = 0.5 * scene.low + 0.5 * scene.high;
    const auto whole = [](double metres) { return finite({metres, 0, 0}) ? std::round(metres) : 0.0; };
    if (extent > 1) origin_ = {whole(middle.x), whole(middle.y), whole(middle.z)};
  }

  const Vector3& origin() const noexcept { return origin_; }
  double step() const noexcept { return step_; }

  void append(std::string& text, const Vector3& p) const {
    const Vector3 from_origin = p - origin_;
    for (const double value : {from_origin.x, from_origin.y, from_origin.z}) {
      const double steps = std::round(value / step_);
      text += steps == 0 ? "0" : to_text(steps);  // never "-0"
      text += ',';
    }
  }

 private:
  double step_;
  Vector3 origin_;
};

void close(std::string& text, char bracket) {
  if (text.back() == ',') text.pop_back();
  text += bracket;
}

/// JSON has no infinities.
std::string number(double value) {
  return finite({value, 0, 0}) ? to_text(value) : "null";
}

std::string rounded(double value) {
  constexpr double kept = 1e5;
  return std::abs(value) < 1e9 ? to_text(std::round(value * kept) / kept + 0.0) : number(value);
}

std::string triple(const Vector3& v) {
  std::string text = "[";
  for (const double value : {v.x, v.y, v.z}) {
    text += rounded(value);
    text += ',';
  }
  text.back() = ']';
  return text;
}

std::string named(const char* name, const std::string& value) {
  std::string text = "\"";
  text += name;
  text += "\":";
  text += value;
  return text += ',';
}

const char* name_of(UpAxis up) {
  return up == UpAxis::y ? "y" : up == UpAxis::minus_y ? "-y" : "z";
}

const char* name_of(SeenSide seen) {
  return seen == SeenSide::plus ? "+" : seen == SeenSide::minus ? "-" : "both";
}

void append_piece(std::string& text, const ScenePiece& piece, const Grid& grid) {
  text += "{\"at\":[";
  grid.append(text, piece.anchor);
  close(text, ']');
  text += ",\"rings\":[";
  for (const std::vector<Vector3>& ring : piece.rings) {
    text += '[';
    for (const Vector3& p : ring) grid.append(text, p);
    close(text, ']');
    text += ',';
  }
  close(text, ']');
  text += "},";
}

std::string numbers_of(const ScenePlane& plane) {
  const MapPlane& map_plane = *plane.plane;
  std::string text = named("id", to_text(map_plane.id));
  text += named("n", triple(map_plane.plane.normal)) + named("d", rounded(map_plane.plane.distance));
  text += named("length", rounded(plane.length)) + named("width", rounded(plane.width));
  text += named("area", rounded(plane.area)) + named("front", to_text(plane.front));
  text += named("colour", json_text(hex(plane_colour(map_plane.id))));
  if (map_plane.points) text += named("points", to_text(*map_plane.points));
  if (map_plane.count) text += named("frames", to_text(*map_plane.count));
  if (map_plane.seen != SeenSide::unknown) text += named("seen", json_text(name_of(map_plane.seen)));
  if (map_plane.source) text += named("source", json_text(*map_plane.source));
  return text;
}

std::string planes_of(const PlaneScene& scene, const Grid& grid) {
  std::string text = "[";
  auto piece = scene.pieces.begin();
  for (std::size_t i = 0; i < scene.planes.size(); ++i) {
    text += "\n{";
    text += numbers_of(scene.planes[i]);
    text += "\"pieces\":[";
    for (; piece != scene.pieces.end() && piece->plane == i; ++piece) append_piece(text, *piece, grid);
    close(text, ']');
    text += "},";
  }
  close(text, ']');
  return text;
}

std::string path_of(std::span<const Pose> path) {
  std::string text = "[";
  for (const Pose& pose : path) {
    const Vector3 forward = pose.turned({0, 0, 1});
    const Vector3 down = pose.turned({0, 1, 0});
    if (!drawable(pose.translation) || !finite(forward + down)) continue;
    text += '[';
    for (const Vector3& v : {pose.translation, forward, down}) {
      text += triple(v);
      text += ',';
    }
    close(text, ']');
    text += ',';
  }
  close(text, ']');
  return text;
}

/// The kept points, those of a plane together.
std::string cloud_of(const PlaneMap& map, const PlaneViewOptions& options, const Grid& grid,
                     std::size_t& left_out) {
  std::map<std::uint32_t, std::size_t> plane_of_id;
  for (std::size_t i = 0; i < map.planes.size(); ++i) plane_of_id.emplace(map.planes[i].id, i);
  const std::size_t count = options.points.size();
  const std::size_t most = std::max<std::size_t>(options.max_points, 1);
  const std::size_t every = count / most + (count % most != 0 ? 1 : 0);
  std::vector<std::string> of_plane(map.planes.size() + 1);
  std::size_t kept = 0;
  for (std::size_t i = 0; i < count && options.max_points > 0; i += every) {
    const PlaneViewPoint& point = options.points[i];
    if (!drawable(point.at)) continue;
    const auto found = plane_of_id.find(point.plane);
    grid.append(of_plane[found == plane_of_id.end() ? map.planes.size() : found->second], point.at);
    ++kept;
  }
  left_out = count - kept;
  std::string text = "[";
  for (std::size_t i = 0; i < of_plane.size(); ++i) {
    if (of_plane[i].empty()) continue;
    const std::string plane = i < map.planes.size() ? to_text(i) : "-1";
    text += "\n{";
    text += named("plane", plane);
    text += "\"xyz\":[";
    text += of_plane[i];
    close(text, ']');
    text += "},";
  }
  close(text, ']');
  return text;
}

}  // namespace

std::string json_text(std::string_view text) {
  constexpr const char* digits = "0123456789abcdef";
  std::string result = "\"";
  for (const char c : text_for_xml(text)) {
    if (c == '"' || c == '\\') {
      result += '\\';
      result += c;
    } else if (c == '<' || c == '>' || c == '&') {
      const auto code = static_cast<unsigned char>(c);
      result += "\\u00";
      result += digits[code >> 4];
      result += digits[code & 15];
    } else {
      result += c;
    }
  }
  return result + '"';
}

std::string plane_view_data(const PlaneMap& map, const PlaneScene& scene, const PlaneViewOptions& options) {
  const Grid grid(scene);
  std::size_t left_out = 0;
  const std::string cloud = cloud_of(map, options, grid, left_out);
  std::string text = "{";
  for (const auto& [name, value] : std::initializer_list<std::pair<const char*, std::string>>{
           {"up", json_text(name_of(scene.up))},
           {"turn", to_text(oblique_turn(scene))},
           {"origin", triple(grid.origin())},
           {"step", to_text(grid.step())},
           {"planes", planes_of(scene, grid)},
           {"path", path_of(options.camera_path)},
           {"cloud", cloud},
           {"left_out", to_text(left_out)},
       }) {
    text += named(name, value);
  }
  text.back() = '}';
  return text;
}

}  // namespace straightedge::io
