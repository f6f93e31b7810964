// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <string>

#include "io/number_text.hpp"
#include "io/svg_canvas.hpp"
#include "straightedge/host/floor_svg.hpp"

/// Colours, words and strokes of drawings of a floor.
namespace straightedge::io {

inline constexpr const char* floor_style =
    "path{fill:none;stroke-linecap:round;stroke-linejoin:round}.wall{stroke:#8d8d8d;stroke-width:3;stroke-"
    "linecap:butt}"
    ".bold{stroke:#222;stroke-width:3.5;stroke-linecap:butt}.reading{stroke:#0b5fc4;stroke-width:1.5}.few{"
    "stroke:#0b5fc4;stroke-width:3}"
    ".way{stroke:#d62828;stroke-width:1.8}.truth{stroke:#1f8a3b;stroke-width:4;opacity:.45}"
    ".odometry{stroke:#b26a00;stroke-width:1.2;stroke-dasharray:6 4}"
    ".seen{stroke:#7b2cbf;stroke-width:3}.matched{stroke:#1f8a3b;stroke-width:3}.refused{stroke:#e0531f;"
    "stroke-width:3}"
    ".sigma{fill:#d62828;fill-opacity:.15;stroke:#d62828;stroke-width:1}"
    ".start{fill:#1f8a3b;stroke:#fff;stroke-width:1}.end{fill:#222;stroke:#fff;stroke-width:1}"
    ".pose{fill:#d62828;stroke:#fff;stroke-width:1}.expected{fill:#fff;stroke:#222;stroke-width:1.4}"
    ".candidate{fill:#f3c300;stroke:#222;stroke-width:1}.lost{fill:#ff00c8;stroke:#222;stroke-width:1}"
    ".scale{stroke:#222;stroke-width:1.4}text{font:12px sans-serif;fill:#222}.title{font-size:15px}"
    ".wall-id,.on-seen,.on-matched,.on-refused{text-anchor:middle;stroke:#fff;stroke-width:3;paint-order:"
    "stroke}"
    ".wall-id{font-weight:bold}.on-seen{fill:#7b2cbf}.on-matched{fill:#1f8a3b}.on-refused{fill:#e0531f}";

/// A kind, its class in the style sheet and its entry in the legend.
template <class Kind>
struct FloorWord {
  Kind kind;
  const char* style;
  const char* words;
};

inline constexpr std::array<FloorWord<FloorPath>, 3> path_words = {
    {{FloorPath::robot, "way", "way of the robot"},
     {FloorPath::truth, "truth", "its true way"},
     {FloorPath::odometry, "odometry", "odometry alone"}}};
inline constexpr std::array<FloorWord<FloorLine>, 3> line_words = {
    {{FloorLine::seen, "seen", "line of the scan"},
     {FloorLine::matched, "matched", "matched line"},
     {FloorLine::refused, "refused", "refused line"}}};
inline constexpr std::array<FloorWord<FloorRobot>, 7> robot_words = {
    {{FloorRobot::robot, "pose", "the robot"},
     {FloorRobot::start, "start", "first pose"},
     {FloorRobot::end, "end", "last pose"},
     {FloorRobot::pose, "pose", "pose, 3 sigma"},
     {FloorRobot::expected, "expected", "expected here"},
     {FloorRobot::candidate, "candidate", "candidate"},
     {FloorRobot::lost, "lost", "lost here"}}};

template <class Kind, std::size_t count>
constexpr const char* style_among(const std::array<FloorWord<Kind>, count>& words, Kind kind) {
  for (const FloorWord<Kind>& word : words) {
    if (word.kind == kind) return word.style;
  }
  return "none";
}
constexpr const char* class_of(FloorPath kind) {
  return style_among(path_words, kind);
}
constexpr const char* class_of(FloorLine kind) {
  return style_among(line_words, kind);
}
/// Of a text beside such a line.
constexpr const char* label_class_of(FloorLine kind) {
  if (kind == FloorLine::matched) return "on-matched";
  return kind == FloorLine::refused ? "on-refused" : "on-seen";
}
constexpr const char* class_of(FloorRobot kind) {
  return style_among(robot_words, kind);
}

template <class... Parts>
std::string joined(const Parts&... parts) {
  std::string text;
  (text.append(parts), ...);
  return text;
}

inline std::string point_text(Point2 at) {
  return joined(to_text(at.x, 1), " ", to_text(at.y, 1));
}

/// A way as a path; steps that cannot be seen are left out.
inline std::string way_on_canvas(const std::vector<Point2>& points, const SvgCanvas& canvas) {
  constexpr double least_step = 1.5;
  std::string d;
  Point2 last;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!usable(Pose2{points[i].x, points[i].y, 0})) continue;
    const Point2 at = canvas(points[i]);
    const Point2 step{at.x - last.x, at.y - last.y};
    if (!d.empty() && i + 1 < points.size() && dot(step, step) < least_step * least_step) continue;
    d += joined(d.empty() ? "M" : "L", point_text(at));
    last = at;
  }
  return d;
}

}  // namespace straightedge::io
