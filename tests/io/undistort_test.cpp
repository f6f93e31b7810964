// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <cmath>
#include <limits>

#include "catch.hpp"
#include "straightedge/host/depth_file.hpp"

using namespace straightedge;

namespace {

DepthCamera camera_with(LensDistortion lens) {
  DepthCamera camera;
  camera.pinhole = {300, -310, 158.3, 121.7};
  camera.distortion = lens;
  return camera;
}

/// Unlike its neighbours in both directions.
std::uint16_t mark(int x, int y) {
  return static_cast<std::uint16_t>(1 + x + 320 * (y % 200));
}

Image<std::uint16_t> marked() {
  Image<std::uint16_t> image({320, 240});
  for (int y = 0; y < 240; ++y) {
    for (int x = 0; x < 320; ++x) image.at(x, y) = mark(x, y);
  }
  return image;
}

struct Shift {
  int known = 0, same = 0, off_by_more_than_one = 0;
};

/// How far the marks have moved.
Shift shift_of(const Image<std::uint16_t>& image) {
  Shift shift;
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      const int value = image.at(x, y);
      if (value == 0) continue;
      ++shift.known;
      if (value == mark(x, y)) ++shift.same;
      bool near = false;
      for (int dy = -1; dy <= 1; ++dy) {
        for (int dx = -1; dx <= 1; ++dx) near = near || value == mark(x + dx, y + dy);
      }
      if (!near) ++shift.off_by_more_than_one;
    }
  }
  return shift;
}

}  // namespace

TEST_CASE("without distortion nothing moves") {
  const auto image = marked();
  CHECK(undistorted(image, camera_with({})) == image);
  CHECK(distorted(image, camera_with({})) == image);
}

TEST_CASE("a pixel moves to where Brown's model, written out, says") {
  const LensDistortion lens{-0.12, 0.05, 0.003, -0.002, -0.01};
  const DepthCamera camera = camera_with(lens);
  const auto moved = undistorted(marked(), camera);
  for (const auto [u, v] :
       {std::array{20, 30}, std::array{300, 10}, std::array{160, 120}, std::array{7, 222}}) {
    const double x = (u - 158.3) / 300, y = (v - 121.7) / -310, r2 = x * x + y * y;
    const double radial = 1 + lens.k1 * r2 + lens.k2 * r2 * r2 + lens.k3 * r2 * r2 * r2;
    const double xd = x * radial + 2 * lens.p1 * x * y + lens.p2 * (r2 + 2 * x * x);
    const double yd = y * radial + lens.p1 * (r2 + 2 * y * y) + 2 * lens.p2 * x * y;
    const int ud = static_cast<int>(std::lround(300 * xd + 158.3));
    const int vd = static_cast<int>(std::lround(-310 * yd + 121.7));
    CHECK(moved.at(u, v) == mark(ud, vd));
  }
}

TEST_CASE("undistorting and distorting again leaves every reading within a pixel") {
  for (const LensDistortion& lens : {LensDistortion{-0.3, 0.12, 0.001, -0.001, -0.02},  // barrel
                                     LensDistortion{0.2, -0.05, -0.002, 0.003, 0.04},   // pincushion
                                     LensDistortion{-0.045, 0.24, -0.0096, -0.003, -1.01}}) {
    const DepthCamera camera = camera_with(lens);
    const Shift there_and_back = shift_of(distorted(undistorted(marked(), camera), camera));
    CHECK(there_and_back.known > 320 * 240 * 8 / 10);
    CHECK(there_and_back.off_by_more_than_one == 0);
    CHECK(there_and_back.same > there_and_back.known / 2);
    const Shift back_and_there = shift_of(undistorted(distorted(marked(), camera), camera));
    CHECK(back_and_there.known > 320 * 240 * 8 / 10);
    CHECK(back_and_there.off_by_more_than_one == 0);
  }
}

TEST_CASE("where the model folds back there is nothing, and never a reading twice as far in") {
  // 1 - 3 · 1.5 r² is negative beyond r = 0.47, well within the picture.
  const DepthCamera camera = camera_with({-1.5, 0, 0, 0, 0});
  const auto image = undistorted(marked(), camera);
  int known = 0;
  for (int y = 0; y < 240; ++y) {
    for (int x = 0; x < 320; ++x) {
      const double r = std::hypot((x - 158.3) / 300, (y - 121.7) / 310);
      if (r > 0.48) CHECK(image.at(x, y) == 0);
      if (image.at(x, y) != 0) ++known;
    }
  }
  CHECK(known > 10000);
}

TEST_CASE("wild numbers give a picture, too") {
  const double huge = std::numeric_limits<double>::max(), nan = std::numeric_limits<double>::quiet_NaN();
  for (const double wild : {huge, -huge, nan, 1e10, -1e10}) {
    CHECK(undistorted(marked(), camera_with({wild, 0, 0, 0, 0})).size() == Size{320, 240});
    CHECK(distorted(marked(), camera_with({0, wild, wild, 0, 0})).size() == Size{320, 240});
  }
  DepthCamera flat;
  flat.pinhole.fx = 0;
  CHECK(undistorted(marked(), flat).empty());
  CHECK(distorted(ImageView<const std::uint16_t>{}, DepthCamera{}).empty());
  Image<std::uint16_t> one({1, 1}, 7);
  DepthCamera centred = camera_with({0.1, 0, 0, 0, 0});
  centred.pinhole = {1, 1, 0, 0};
  CHECK(undistorted(one, centred) == one);
  CHECK(distorted(one, centred) == one);
}
