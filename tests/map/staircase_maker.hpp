// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <map>
#include <random>
#include <utility>
#include <vector>

#include "straightedge/host/plane_map.hpp"

/// Areas made of the cells of a grid, and their borders: what a map of leaves gives.
class Staircase {
 public:
  Staircase(int width, int height)
      : width_(width), height_(height), cells_(static_cast<std::size_t>(width * height)) {}

  static Staircase random(int width, int height, double share, std::mt19937& generator) {
    Staircase area(width, height);
    std::bernoulli_distribution taken(share);
    for (std::size_t i = 0; i < area.cells_.size(); ++i) area.cells_[i] = taken(generator) ? 1 : 0;
    return area;
  }

  void set(int x, int y, bool value = true) {
    cells_[static_cast<std::size_t>(y * width_ + x)] = value ? 1 : 0;
  }
  bool has(int x, int y) const {
    return x >= 0 && y >= 0 && x < width_ && y < height_ &&
           cells_[static_cast<std::size_t>(y * width_ + x)] != 0;
  }
  int size() const { return std::max(width_, height_); }
  int count() const {
    int sum = 0;
    for (const char cell : cells_) sum += cell;
    return sum;
  }

  using Place = std::pair<int, int>;

  /// Closed borders with the area to the left, by corners of cells. Where two cells touch in a corner, the
  /// border turns left, so that they are apart, or right, so that they hang together. `all`: points on
  /// straight pieces too.
  std::vector<std::vector<Place>> borders(bool turn_left, bool all) const {
    std::map<std::pair<Place, int>, bool>
        edges;  // start and direction (0 east, 1 north, 2 west, 3 south); used
    for (int y = 0; y < height_; ++y) {
      for (int x = 0; x < width_; ++x) {
        if (!has(x, y)) continue;
        if (!has(x, y - 1)) edges[{{x, y}, 0}] = false;
        if (!has(x + 1, y)) edges[{{x + 1, y}, 1}] = false;
        if (!has(x, y + 1)) edges[{{x + 1, y + 1}, 2}] = false;
        if (!has(x - 1, y)) edges[{{x, y + 1}, 3}] = false;
      }
    }
    std::vector<std::vector<Place>> borders;
    for (auto& [start, used] : edges) {
      if (used) continue;
      std::vector<Place> border;
      auto edge = start;
      do {
        edges[edge] = true;
        const int direction = edge.second;
        constexpr int dx[] = {1, 0, -1, 0}, dy[] = {0, 1, 0, -1};
        const Place end{edge.first.first + dx[direction], edge.first.second + dy[direction]};
        int next = direction;
        for (const int turn : turn_left ? std::vector<int>{1, 0, 3} : std::vector<int>{3, 0, 1}) {
          next = (direction + turn) % 4;
          if (edges.contains({end, next})) break;
        }
        if (all || next != direction) border.push_back(end);
        edge = {end, next};
      } while (edge != start);
      borders.push_back(border);
    }
    return borders;
  }

 private:
  int width_, height_;
  std::vector<char> cells_;
};

inline double signed_area(const std::vector<Staircase::Place>& border) {
  double twice = 0;
  for (std::size_t i = 0; i < border.size(); ++i) {
    const auto& a = border[i];
    const auto& b = border[(i + 1) % border.size()];
    twice += static_cast<double>(a.first) * b.second - static_cast<double>(a.second) * b.first;
  }
  return twice / 2;
}
