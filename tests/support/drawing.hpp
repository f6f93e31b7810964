// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "straightedge/host/image.hpp"
#include "straightedge/host/line_geometry.hpp"
#include "straightedge/random.hpp"

/// A small renderer whose edges are exact: each pixel gets the share of its square that the shape covers.
/// Points are of the image plane: u right, v down, pixel (c, r) covers [c, c+1] x [r, r+1].
namespace support {

using straightedge::Image;
using straightedge::Pcg32;
using straightedge::Point2;
using straightedge::Size;

using Polygon = std::vector<Point2>;

/// The part of a polygon where (p − on) · inward >= 0.
inline Polygon clipped(const Polygon& polygon, Point2 on, Point2 inward) {
  Polygon out;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point2 a = polygon[i], b = polygon[(i + 1) % polygon.size()];
    const double da = (a.x - on.x) * inward.x + (a.y - on.y) * inward.y;
    const double db = (b.x - on.x) * inward.x + (b.y - on.y) * inward.y;
    if (da >= 0) out.push_back(a);
    if ((da >= 0) != (db >= 0)) {
      const double t = da / (da - db);
      out.push_back({a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)});
    }
  }
  return out;
}

inline double area(const Polygon& polygon) {
  double twice = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point2 a = polygon[i], b = polygon[(i + 1) % polygon.size()];
    twice += a.x * b.y - a.y * b.x;
  }
  return std::fabs(twice) / 2;
}

/// A straight bar from a to b; `width` across.
inline Polygon bar(Point2 a, Point2 b, double width) {
  const double length = std::hypot(b.x - a.x, b.y - a.y);
  const Point2 n{-(b.y - a.y) / length * width / 2, (b.x - a.x) / length * width / 2};
  return {{a.x + n.x, a.y + n.y}, {b.x + n.x, b.y + n.y}, {b.x - n.x, b.y - n.y}, {a.x - n.x, a.y - n.y}};
}

/// A number in [from, to).
inline double uniform(Pcg32& random, double from, double to) {
  return from + (to - from) * (random.next() / 4294967296.0);
}

/// Mean 0, standard deviation 1: the sum of twelve even numbers, the same on every machine.
inline double normal(Pcg32& random) {
  double sum = -6;
  for (int i = 0; i < 12; ++i) sum += uniform(random, 0, 1);
  return sum;
}

class Canvas {
 public:
  explicit Canvas(Size size, double ground = 255) : values_(size, ground) {}

  Size size() const { return values_.size(); }

  /// Paints a convex polygon over what is there.
  void paint(const Polygon& shape, double ink) {
    double left = 1e9, right = -1e9, top = 1e9, bottom = -1e9;
    for (const Point2 p : shape) {
      left = std::min(left, p.x);
      right = std::max(right, p.x);
      top = std::min(top, p.y);
      bottom = std::max(bottom, p.y);
    }
    const auto clamp = [](double v, int last) {
      return static_cast<int>(std::clamp(std::floor(v), 0.0, last * 1.0));
    };
    for (int y = clamp(top, size().height); y < clamp(bottom + 1, size().height); ++y) {
      for (int x = clamp(left, size().width); x < clamp(right + 1, size().width); ++x) {
        const double share = covered(shape, x, y);
        values_.at(x, y) += share * (ink - values_.at(x, y));
      }
    }
  }
  void paint_bar(Point2 a, Point2 b, double width, double ink = 0) { paint(bar(a, b, width), ink); }
  void paint_box(double left, double top, double right, double bottom, double ink = 0) {
    paint({{left, top}, {right, top}, {right, bottom}, {left, bottom}}, ink);
  }

  /// Adds noise of this standard deviation to every pixel.
  void add_noise(double sigma, Pcg32& random) {
    for (int y = 0; y < size().height; ++y) {
      for (int x = 0; x < size().width; ++x) values_.at(x, y) += sigma * normal(random);
    }
  }

  Image<std::uint8_t> picture() const {
    Image<std::uint8_t> out(size());
    for (int y = 0; y < size().height; ++y) {
      for (int x = 0; x < size().width; ++x) {
        out.at(x, y) = static_cast<std::uint8_t>(std::clamp(values_.at(x, y), 0.0, 255.0) + 0.5);
      }
    }
    return out;
  }

 private:
  static double covered(const Polygon& shape, int x, int y) {
    Polygon part = shape;
    part = clipped(part, {x * 1.0, y * 1.0}, {1, 0});
    part = clipped(part, {x * 1.0, y * 1.0}, {0, 1});
    part = clipped(part, {x + 1.0, y + 1.0}, {-1, 0});
    part = clipped(part, {x + 1.0, y + 1.0}, {0, -1});
    return part.size() < 3 ? 0 : std::min(area(part), 1.0);
  }

  Image<double> values_;
};

template <class T>
Image<T> turned_clockwise(const Image<T>& image) {
  Image<T> out({image.height(), image.width()});
  for (int y = 0; y < out.height(); ++y) {
    for (int x = 0; x < out.width(); ++x) out.at(x, y) = image.at(y, image.height() - 1 - x);
  }
  return out;
}

template <class T>
Image<T> mirrored(const Image<T>& image) {
  Image<T> out(image.size());
  for (int y = 0; y < out.height(); ++y) {
    for (int x = 0; x < out.width(); ++x) out.at(x, y) = image.at(out.width() - 1 - x, y);
  }
  return out;
}

/// The image on an even ground, its corner at (left, top).
inline Image<std::uint8_t> placed(const Image<std::uint8_t>& image, Size ground, int left, int top,
                                  std::uint8_t level) {
  Image<std::uint8_t> out(ground, level);
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) out.at(left + x, top + y) = image.at(x, y);
  }
  return out;
}

}  // namespace support
