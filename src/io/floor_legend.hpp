// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "io/floor_style.hpp"
#include "straightedge/host/floor_svg.hpp"

namespace straightedge::io {

struct LegendEntry {
  const char* style = "";
  const char* words = "";
  bool dots = false;
  std::optional<FloorRobot> robot = {};
  double x = 0, y = 0;  ///< of its left end; y from the first row on
};

/// The few readings of one scan are drawn larger than the many of a run.
inline const char* reading_class(const FloorDrawing& drawing) {
  constexpr std::size_t many = 3000;
  return drawing.readings.size() > many ? "reading" : "few";
}

/// One entry for each kind of thing that is in the drawing, in rows of the width.
inline std::vector<LegendEntry> floor_legend(const LineMap& map, const FloorDrawing& drawing, double width) {
  std::vector<LegendEntry> entries;
  entries.reserve(16);
  if (!map.lines.empty()) entries.push_back({"wall", "wall of the map"});
  if (!drawing.bold_walls.empty()) entries.push_back({"bold", "matched wall, id"});
  if (!drawing.readings.empty()) entries.push_back({reading_class(drawing), "laser reading", true});
  const auto add = [&entries](const auto& words, const auto& things, auto there) {
    for (const auto& word : words) {
      if (std::any_of(things.begin(), things.end(),
                      [&](const auto& thing) { return there(thing, word.kind); }))
        entries.push_back({word.style, word.words});
    }
  };
  add(path_words, drawing.ways,
      [](const FloorWay& w, FloorPath kind) { return w.kind == kind && !w.points.empty(); });
  add(line_words, drawing.segments, [](const FloorSegment& s, FloorLine kind) { return s.kind == kind; });
  for (const FloorWord<FloorRobot>& word : robot_words) {
    const auto is = [&](const FloorMark& mark) { return mark.kind == word.kind; };
    if (std::any_of(drawing.marks.begin(), drawing.marks.end(), is))
      entries.push_back({word.style, word.words, false, word.kind});
  }
  constexpr double left = 12, row = 20, letter = 6.2, around = 40;
  double x = left, y = 0;
  for (LegendEntry& entry : entries) {
    const double length = around + letter * static_cast<double>(std::string_view(entry.words).size());
    if (x > left && x + length > width) x = left, y += row;
    entry.x = x, entry.y = y;
    x += length;
  }
  return entries;
}

}  // namespace straightedge::io
