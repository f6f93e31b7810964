// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "straightedge/canny.hpp"
#include "straightedge/inverse_depth.hpp"
#include "support/catch.hpp"
#include "support/depth_scene.hpp"
#include "support/drawing.hpp"
#include "support/edge_scene.hpp"

/// What the algorithms are given, the same in every layout. Sides are odd where nothing asks for more.
namespace workspace {

inline const straightedge::Image<std::uint8_t>& gray_picture() {
  static const auto picture = [] {
    support::Canvas canvas({83, 61});
    canvas.paint_bar({8, 50}, {75, 12}, 6);
    canvas.paint_box(20, 8, 50, 20, 90);
    straightedge::Pcg32 random(3);
    canvas.add_noise(2, random);
    return canvas.picture();
  }();
  return picture;
}

template <class T>
straightedge::Image<T> owned(const straightedge::ImageView<const T>& view) {
  straightedge::Image<T> image(view.size());
  for (int y = 0; y < view.height; ++y) {
    for (int x = 0; x < view.width; ++x) image.at(x, y) = view.at(x, y);
  }
  return image;
}

/// The picture's edges and gradient.
struct Edges {
  straightedge::Image<std::uint8_t> mask;
  straightedge::Image<std::int16_t> dx, dy;
  straightedge::Image<std::int32_t> magnitude;
};

inline const Edges& edges() {
  static const auto found = [] {
    const support::EdgeScene scene(gray_picture());
    const straightedge::GradientField field = scene.field();
    return Edges{scene.mask, owned(field.x), owned(field.y), owned(field.magnitude)};
  }();
  return found;
}

/// The inside of a box, with noise and holes.
inline const support::DepthFrame& depth_frame() {
  static const auto frame =
      support::frame_of(support::box_room({161, 121}, support::box_planes()), {.holes = 0.02}, 5);
  return frame;
}

inline const straightedge::Image<float>& inverse_depth() {
  static const auto picture = [] {
    straightedge::Image<float> out(depth_frame().raw.size());
    REQUIRE(straightedge::inverse_depth_image(depth_frame().view(), out.view()) == straightedge::Status::ok);
    return out;
  }();
  return picture;
}

/// Every third reading of the frame as a point: x, y, z, x, ...
inline const std::vector<float>& cloud() {
  static const auto points = [] {
    std::vector<float> xyz;
    const auto& q = inverse_depth();
    for (int i = 0; i < q.width() * q.height(); i += 3) {
      const int x = i % q.width(), y = i / q.width();
      if (!(q.at(x, y) > 0)) continue;
      const auto p = (1 / static_cast<double>(q.at(x, y))) * depth_frame().camera.ray(x, y);
      for (const double c : {p.x, p.y, p.z}) xyz.push_back(static_cast<float>(c));
    }
    return xyz;
  }();
  return points;
}

}  // namespace workspace
