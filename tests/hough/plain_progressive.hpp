// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <utility>
#include <vector>

#include "hough/angle_table.hpp"
#include "hough/fixed_walk.hpp"
#include "hough/gradient_window.hpp"
#include "hough/opencv_generator.hpp"
#include "hough_testing.hpp"

namespace straightedge::test {

/// The progressive method with no thought of memory: 32-bit cells for every distance of every angle, a number
/// for each pixel. An oracle for the one that saves bytes.
class PlainProgressive {
 public:
  std::vector<HoughSegment> segments;
  std::vector<std::vector<std::int32_t>> cells;  ///< [angle][distance], as the accumulator shows them
  std::vector<std::vector<int>> state;           ///< [y][x]: 0 gone, 1 waiting, 2 voted
  std::uint32_t edge_pixels = 0;

  PlainProgressive(GrayView edges, const HoughOptions& options, GradientView gradients = {})
      : opencv_(options.generator == HoughGenerator::opencv) {
    job_.edges = edges;
    job_.gradients = gradients;
    job_.options = options;
    job_.grid = hough_grid(edges.size(), options);
    cosines_.resize(static_cast<std::size_t>(job_.grid.angles));
    sines_.resize(cosines_.size());
    job_.memory.cosines = cosines_;
    job_.memory.sines = sines_;
    hough::fill_angles_by_multiplying(job_);
    cells.assign(cosines_.size(), std::vector<std::int32_t>(static_cast<std::size_t>(job_.grid.distances)));
    state.assign(static_cast<std::size_t>(edges.height),
                 std::vector<int>(static_cast<std::size_t>(edges.width)));
    run();
  }

 private:
  using Pixel = std::pair<std::int32_t, std::int32_t>;

  int& at(Pixel p) { return state[static_cast<std::size_t>(p.second)][static_cast<std::size_t>(p.first)]; }
  std::int32_t& cell(std::int32_t n, Pixel p) {
    const auto angle = static_cast<std::size_t>(n);
    const std::int32_t r =
        hough::distance_cell(job_.memory, angle, static_cast<float>(p.first), static_cast<float>(p.second));
    return cells[angle].at(static_cast<std::size_t>(r + (job_.grid.distances - 1) / 2));
  }
  std::vector<std::int32_t> angles_of(Pixel p) {
    const hough::AngleWindow window = hough::angle_window(job_, p.first, p.second);
    std::vector<std::int32_t> angles;
    for (std::int32_t n = window.first; n < window.end; ++n) angles.push_back(n);
    for (std::int32_t n = 0; n < window.wrapped; ++n) angles.push_back(n);
    return angles;
  }

  void run() {
    std::vector<PixelPlace> list;
    for (std::int32_t y = 0; y < job_.edges.height; ++y) {
      for (std::int32_t x = 0; x < job_.edges.width; ++x) {
        at({x, y}) = job_.edges.at(x, y) != 0 ? 1 : 0;
        if (at({x, y}) != 0) list.push_back({static_cast<std::uint16_t>(x), static_cast<std::uint16_t>(y)});
      }
    }
    edge_pixels = static_cast<std::uint32_t>(list.size());
    Pcg32 pcg(job_.options.seed);
    hough::OpencvGenerator numbers;
    while (!list.empty()) {
      const auto left = static_cast<std::uint32_t>(list.size());
      const std::uint32_t index = opencv_ ? numbers.next() % left : pcg.below(left);
      const Pixel pixel{list[index].x, list[index].y};
      list[index] = list.back();
      list.pop_back();
      if (at(pixel) != 0) vote(pixel);
    }
  }

  void vote(Pixel pixel) {
    std::int32_t best = job_.options.threshold - 1, angle = -1;
    for (const std::int32_t n : angles_of(pixel)) {
      const std::int32_t votes = ++cell(n, pixel);
      if (votes <= best) continue;
      best = votes;
      angle = n;
    }
    at(pixel) = 2;
    if (angle >= 0) follow(pixel, best, static_cast<std::size_t>(angle));
  }

  Pixel end_of(hough::FixedWalk walk, Pixel end) {
    const double most = opencv_ ? std::nearbyint(job_.options.max_gap) : job_.options.max_gap;
    int gap = 0;
    for (; job_.edges.contains(walk.x(), walk.y()); walk.advance()) {
      gap = at({walk.x(), walk.y()}) != 0 ? 0 : gap + 1;
      if (gap == 0) end = {walk.x(), walk.y()};
      if (gap > most) break;
    }
    return end;
  }

  void follow(Pixel pixel, std::int32_t votes, std::size_t n) {
    const PixelPlace place{static_cast<std::uint16_t>(pixel.first), static_cast<std::uint16_t>(pixel.second)};
    const hough::FixedWalk ahead(place, -sines_[n], cosines_[n]);
    const Pixel a = end_of(ahead, pixel), b = end_of(ahead.turned(), pixel);
    const double dx = std::abs(a.first - b.first), dy = std::abs(a.second - b.second);
    const bool keep = opencv_ ? std::max(dx, dy) >= std::nearbyint(job_.options.min_length)
                              : std::hypot(dx, dy) >= job_.options.min_length;
    const int pixels = take(ahead, a, keep) + take(ahead.turned(), b, keep);
    if (keep) segments.push_back({a.first, a.second, b.first, b.second, votes, pixels});
  }

  int take(hough::FixedWalk walk, Pixel end, bool keep) {
    int taken = 0;
    for (;; walk.advance()) {
      const Pixel p{walk.x(), walk.y()};
      if (at(p) != 0) {
        if (opencv_ ? keep : at(p) == 2)
          for (const std::int32_t n : angles_of(p)) --cell(n, p);
        at(p) = 0;
        ++taken;
      }
      if (p == end) return taken;
    }
  }

  HoughJob job_;
  bool opencv_;
  std::vector<float> cosines_, sines_;
};

}  // namespace straightedge::test
