// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "map/picture.hpp"

#include <algorithm>
#include <optional>
#include <string>

#include "straightedge/host/image_file.hpp"
#include "support/catch.hpp"
#include "support/drawing.hpp"

using namespace straightedge;

namespace {

constexpr Size size{160, 120};

/// Floor in unknown space with walls round it, as a robot's map has it.
support::Canvas grid_map() {
  support::Canvas canvas(size, 205);
  canvas.paint_box(30, 20, 130, 100, 254);
  canvas.paint_bar({30, 20}, {130, 20}, 2);
  canvas.paint_bar({30, 100}, {130, 100}, 2);
  canvas.paint_bar({30, 20}, {30, 100}, 2);
  return canvas;
}

Picture understood(const Image<std::uint8_t>& image, std::optional<RosMeaning> meaning = {}) {
  return understand_picture(image, PictureKind::automatic, meaning);
}

Image<std::uint8_t> fixture(const std::string& name) {
  auto image = read_gray_image(std::string(STRAIGHTEDGE_FIXTURES) + "/" + name);
  REQUIRE(static_cast<bool>(image));
  return *image;
}

bool same_pixels(GrayView a, GrayView b) {
  if (a.size() != b.size()) return false;
  for (int y = 0; y < a.height; ++y)
    if (!std::equal(a.row(y), a.row(y) + a.width, b.row(y))) return false;
  return true;
}

}  // namespace

TEST_CASE("a picture that is understood in the memory of another shows its own pixels") {
  Picture picture;
  for (const double ground : {255.0, 200.0, 255.0}) {
    support::Canvas canvas(size, ground);
    canvas.paint_bar({20, 30}, {140, 30}, 3);
    const Image<std::uint8_t> image = canvas.picture();
    for (const bool negate : {false, true}) {
      RosMeaning meaning;
      meaning.negate = negate;
      understand_picture(image, PictureKind::map, meaning, plain_picture_row_kernels, picture);
      CAPTURE(ground, negate);
      REQUIRE(picture.gray.size() == size);
      CHECK(picture.gray.at(80, 100) == (negate ? 255 - image.at(80, 100) : image.at(80, 100)));
      CHECK(picture.gray.at(80, 30) == (negate ? 255 - image.at(80, 30) : image.at(80, 30)));
      CHECK(same_pixels(picture.stretched, understand_picture(image, PictureKind::map, meaning).stretched));
    }
  }
}

TEST_CASE("a picture that is nearly as black and as white as can be is not stretched") {
  for (const int ground : {249, 250, 254, 255}) {
    CAPTURE(ground);
    support::Canvas canvas(size, ground);
    canvas.paint_bar({20, 30}, {140, 30}, 3);
    const Picture picture = understood(canvas.picture());
    CHECK(picture.ground == ground);
    CHECK(picture.stretched.at(80, 60) == (ground < 250 ? 255 : ground));
    CHECK(picture.stretched.at(80, 30) == 0);
    CHECK_FALSE(picture.clipped);
  }
}

TEST_CASE("of a large picture half of the rows tell what it shows") {
  for (const std::int32_t height : {250, 256, 400, 401, 407}) {
    CAPTURE(height);
    support::Canvas canvas({160, height}, 205);
    canvas.paint_box(30, 20, 130, height - 20, 254);
    canvas.paint_bar({30, 20}, {30, static_cast<double>(height - 20)}, 3);
    const Picture picture = understood(canvas.picture());
    CHECK(picture.kind == PictureKind::map);
    CHECK(picture.ground == 205);
    CHECK(picture.clipped);
    CHECK(picture.free_above == 0.5 * (205 + 254));
  }
}

TEST_CASE("a grid of wall, floor and unknown is a map whose grounds turn white") {
  const Picture picture = understood(grid_map().picture());
  CHECK(picture.kind == PictureKind::map);
  CHECK(picture.ground == 205);
  CHECK(picture.stretched.at(5, 5) == 255);
  CHECK(picture.stretched.at(80, 60) == 255);
  CHECK(picture.stretched.at(80, 20) == 0);
  CHECK(picture.stretched.at(30, 60) == 0);
  CHECK(picture.free_above > 205);
  CHECK(picture.free_above < 254);
  CHECK(same_pixels(picture.gray, grid_map().picture()));
}

TEST_CASE("a drawing on one even ground is a map, whatever its ground") {
  for (const double ground : {255.0, 240.0, 200.0}) {
    CAPTURE(ground);
    support::Canvas canvas(size, ground);
    canvas.paint_bar({20, 30}, {140, 30}, 3);
    canvas.paint_bar({20, 30}, {50, 110}, 6);
    const Picture picture = understood(canvas.picture());
    CHECK(picture.kind == PictureKind::map);
    CHECK(picture.ground == ground);
    CHECK(picture.stretched.at(100, 80) == 255);
    CHECK(picture.stretched.at(80, 30) == 0);
  }
}

TEST_CASE("a noisy map is a map") {
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    CAPTURE(seed);
    Pcg32 random(seed, 71);
    support::Canvas canvas = grid_map();
    canvas.add_noise(14, random);
    const Picture picture = understood(canvas.picture());
    CHECK(picture.kind == PictureKind::map);
    CHECK(picture.noisy);
    CHECK(picture.ground > 190);
    CHECK(picture.ground < 220);
  }
}

TEST_CASE("specks all over make a picture noisy, specks in a part of it do not, whichever part") {
  // Of 64 cells six may be without specks: 20 by 15 pixels each.
  const auto specked = [](int clean_cells, bool turned) {
    support::Canvas canvas(size);
    canvas.paint_box(20, 8, 140, 11);
    for (int cell = clean_cells; cell < 64; ++cell) {
      const int left = cell % 8 * 20, top = cell / 8 * 15;
      for (const int x : {4, 9, 14}) canvas.paint_box(left + x, top + 12, left + x + 1, top + 13);
    }
    Image<std::uint8_t> picture = canvas.picture();
    if (turned) std::reverse(picture.view().row(0), picture.view().row(0) + size.width * size.height);
    return picture;
  };
  for (const bool turned : {false, true}) {
    CAPTURE(turned);
    CHECK(understood(specked(0, turned)).noisy);
    CHECK(understood(specked(6, turned)).noisy);
    CHECK_FALSE(understood(specked(7, turned)).noisy);
    CHECK_FALSE(understood(specked(32, turned)).noisy);
  }
}

TEST_CASE("grain makes a picture noisy, whichever rows it is in") {
  for (const int first : {0, size.height / 2}) {
    CAPTURE(first);
    Image<std::uint8_t> picture(size);
    std::fill_n(picture.view().row(0), size.width * size.height, std::uint8_t{255});
    for (int y = first; y < first + size.height / 2; ++y)
      for (int x = 0; x < size.width; ++x)
        picture.at(x, y) = static_cast<std::uint8_t>(x % 2 == 0 ? 215 : 220);
    CHECK(understand_picture(picture, PictureKind::map, {}).noisy);
    for (int y = 0; y < size.height; ++y)
      for (int x = 0; x < size.width; ++x) picture.at(x, y) = picture.at(x, y) < 255 ? 215 : 255;
    CHECK_FALSE(understand_picture(picture, PictureKind::map, {}).noisy);
  }
}

TEST_CASE("clean and crisp pictures are told from noisy and soft ones") {
  support::Canvas crisp(size);
  crisp.paint_box(20, 20, 140, 23);
  CHECK(understood(crisp.picture()).crisp);
  CHECK_FALSE(understood(crisp.picture()).noisy);
  support::Canvas soft(size);
  soft.paint_bar({20, 20}, {140, 70}, 2.5);
  CHECK_FALSE(understood(soft.picture()).crisp);
  CHECK_FALSE(understood(soft.picture()).noisy);
}

TEST_CASE("white laser rays in unknown space are gone after stretching") {
  support::Canvas canvas = grid_map();
  for (int i = 0; i < 8; ++i) canvas.paint_bar({125, 60}, {158, 4.0 + 14 * i}, 1, 254);
  const Image<std::uint8_t> image = canvas.picture();
  int rays = 0;
  for (int y = 0; y < size.height; ++y) rays += image.at(150, y) > 205 ? 1 : 0;
  REQUIRE(rays >= 8);
  const Picture picture = understood(image);
  REQUIRE(picture.kind == PictureKind::map);
  for (int y = 0; y < size.height; ++y) {
    for (int x = 132; x < size.width; ++x) REQUIRE(picture.stretched.at(x, y) == 255);
  }
}

TEST_CASE("photos are no maps") {
  for (const char* name :
       {"camera.png", "coins.png", "building.jpg", "home.jpg", "left01.jpg", "brick.png"}) {
    CAPTURE(name);
    const Image<std::uint8_t> image = fixture(std::string("images/") + name);
    const Picture picture = understood(image);
    CHECK(picture.kind == PictureKind::photo);
    CHECK(same_pixels(picture.stretched, image));
    CHECK(same_pixels(picture.gray, image));
  }
}

TEST_CASE("maps that robots made are maps, also without their thresholds") {
  for (const char* name : {"mrpt/basic_map.png", "mrpt_corridor/map.png", "mrpt_malaga/map.png"}) {
    CAPTURE(name);
    CHECK(understood(fixture(std::string("maps/") + name)).kind == PictureKind::map);
  }
}

TEST_CASE("who says what the picture is, is believed") {
  const Image<std::uint8_t> map = grid_map().picture();
  CHECK(understand_picture(map, PictureKind::photo, {}).kind == PictureKind::photo);
  CHECK(same_pixels(understand_picture(map, PictureKind::photo, {}).stretched, map));
  const Image<std::uint8_t> photo = fixture("images/camera.png");
  CHECK(understand_picture(photo, PictureKind::map, {}).kind == PictureKind::map);
  CHECK(understood(photo, RosMeaning{}).kind == PictureKind::map);
}

TEST_CASE("a map's thresholds say what is wall and what is free") {
  RosMeaning meaning;
  meaning.occupied_thresh = 0.6;
  meaning.free_thresh = 0.2;
  const Picture picture = understood(grid_map().picture(), meaning);
  CHECK(picture.wall_below == Approx(255 * 0.4));
  CHECK(picture.free_above == Approx(255 * 0.8));
  CHECK(picture.ground == 205);
}

TEST_CASE("negate turns light into dark before anything else") {
  const Image<std::uint8_t> image = grid_map().picture();
  Image<std::uint8_t> inverted(size);
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) inverted.at(x, y) = static_cast<std::uint8_t>(255 - image.at(x, y));
  }
  const Picture plain = understood(image, RosMeaning{});
  const Picture negated = understood(inverted, RosMeaning{.negate = true});
  CHECK(same_pixels(negated.gray, image));
  CHECK(same_pixels(negated.stretched, plain.stretched));
  CHECK(negated.ground == plain.ground);
  CHECK(negated.wall_below == plain.wall_below);
  CHECK(negated.free_above == plain.free_above);
}
