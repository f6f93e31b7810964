// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <cmath>

#include "score_plan.hpp"
#include "straightedge/trigonometry.hpp"

using namespace straightedge;
using plan::Score;
using plan::Wall;

namespace {

constexpr Size size{320, 280};

/// A building with its truth: an outer ring of walls, inner walls that stand on it, doors, columns of thick
/// wall.
class Building {
 public:
  explicit Building(std::uint64_t seed) : random_(seed, 61), canvas_(size, 254) {
    angle_ = seed % 4 == 0 ? 0.0 : support::uniform(random_, -0.8, 0.8);
    const double half_x = support::uniform(random_, 95, 105), half_y = support::uniform(random_, 72, 80);
    const bool thick = seed % 2 == 0;
    const double ring = thick ? support::uniform(random_, 6.5, 9) : support::uniform(random_, 1.6, 3);
    draw_ring(half_x, half_y, ring, thick);
    const double post_1 = support::uniform(random_, -45, -30), post_2 = support::uniform(random_, 25, 40);
    const double in_x = half_x - (thick ? ring / 2 : 0), in_y = half_y - (thick ? ring / 2 : 0);
    const double beam = support::uniform(random_, -10, 15);
    const double door = support::uniform(random_, 20, 26);
    thin({post_1, -in_y}, {post_1, beam});
    thin({-in_x, beam}, {post_2 - door, beam});
    thin({post_2, -in_y}, {post_2, -in_y / 2 - door / 2});
    thin({post_2, -in_y / 2 + door / 2}, {post_2, in_y});
    solid({post_2 + 20, -20}, {post_2 + 20, 25}, support::uniform(random_, 7, 10));
    canvas_.add_noise(support::uniform(random_, 0, 6), random_);
  }

  const std::vector<Wall>& truth() const { return truth_; }
  Image<std::uint8_t> picture() const { return canvas_.picture(); }

 private:
  Point2 at(Point2 p) const {
    return {size.width / 2.0 + 0.37 + p.x * std::cos(angle_) - p.y * std::sin(angle_),
            size.height / 2.0 - 0.21 + p.x * std::sin(angle_) + p.y * std::cos(angle_)};
  }
  void line(Point2 a, Point2 b) { truth_.push_back({at(a), at(b)}); }

  void thin(Point2 a, Point2 b) {
    canvas_.paint_bar(at(a), at(b), support::uniform(random_, 1.6, 3), 0);
    line(a, b);
  }
  /// A thick wall that stands alone: its two long faces. The short ones are no longer than min_length.
  void solid(Point2 a, Point2 b, double width) {
    canvas_.paint_bar(at(a), at(b), width, 0);
    for (const double side : {-width / 2, width / 2}) line({a.x + side, a.y}, {b.x + side, b.y});
  }
  void draw_ring(double x, double y, double width, bool thick) {
    const double reach = width / 2;
    canvas_.paint_bar(at({-x - reach, -y}), at({x + reach, -y}), width, 0);
    canvas_.paint_bar(at({-x - reach, y}), at({x + reach, y}), width, 0);
    canvas_.paint_bar(at({-x, -y}), at({-x, y}), width, 0);
    canvas_.paint_bar(at({x, -y}), at({x, y}), width, 0);
    if (thick) {
      rectangle(x - reach, y - reach);
      rectangle(x + reach, y + reach);
    } else {
      rectangle(x, y);
    }
  }
  void rectangle(double x, double y) {
    line({-x, -y}, {x, -y});
    line({-x, y}, {x, y});
    line({-x, -y}, {-x, y});
    line({x, -y}, {x, y});
  }

  Pcg32 random_;
  support::Canvas canvas_;
  double angle_ = 0;
  std::vector<Wall> truth_;
};

}  // namespace

TEST_CASE("buildings with known walls are found whole, once and nearly nothing else") {
  Score all;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    CAPTURE(seed);
    const Building building(seed);
    const Score one = plan::score(building.truth(), plan::found_in(plan::build(building.picture()).map));
    CAPTURE(one.recall(), one.precision());
    CHECK(one.recall() >= 0.85);
    CHECK(one.precision() >= 0.8);
    all.add(one);
  }
  CAPTURE(all.recall(), all.precision(), all.redundancy(), plan::median(all.offsets),
          plan::median(all.angles));
  CHECK(all.recall() >= 0.95);
  CHECK(all.precision() >= 0.95);
  CHECK(all.redundancy() <= 1.03);
  CHECK(plan::median(all.offsets) <= 0.04);
  CHECK(plan::median(all.angles) <= 0.04 * degree);
}
