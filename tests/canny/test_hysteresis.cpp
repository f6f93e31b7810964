// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "canny/stages.hpp"
#include "support/catch.hpp"

using namespace stages;

namespace {

// Classes from a drawing: '.' none, 'w' weak, 's' strong.
GrayImage drawn(const std::vector<std::string>& rows) {
  GrayImage image({static_cast<int>(rows[0].size()), static_cast<int>(rows.size())});
  for (int y = 0; y < image.size().height; ++y) {
    for (int x = 0; x < image.size().width; ++x) {
      const char c = rows[static_cast<std::size_t>(y)][static_cast<std::size_t>(x)];
      image.at(x, y) = c == 's' ? strong_edge : c == 'w' ? weak_edge : no_edge;
    }
  }
  return image;
}

HysteresisResult fill(const GrayImage& classes, GrayImage& edges, HysteresisTrace trace = {}) {
  std::vector<std::uint32_t> stack(hysteresis_stack_size(classes.size()));
  return hysteresis(classes.view(), stack, edges.view(), trace);
}

struct Diary {
  std::vector<HysteresisStep> steps;
  std::size_t stop_after = SIZE_MAX;

  static bool write(void* user, const HysteresisStep& step) {
    auto& diary = *static_cast<Diary*>(user);
    diary.steps.push_back(step);
    return diary.steps.size() < diary.stop_after;
  }
};

}  // namespace

TEST_CASE("weak pixels stay where they hang together with a strong one") {
  const GrayImage classes = drawn({"sww..ww",  //
                                   "...w..w",  //
                                   "w....w.",  //
                                   "ww.s..."});
  GrayImage edges(classes.size(), 5, std::uint8_t{9});
  const HysteresisResult result = fill(classes, edges);
  REQUIRE(result.status == Status::ok);
  CHECK(result.strong == 2);
  CHECK(result.edges == 5);
  for (const auto& [x, y] : {std::pair{0, 0}, {1, 0}, {2, 0}, {3, 1}, {3, 3}}) CHECK(edges.at(x, y) == 255);
  CHECK(edges.at(5, 0) == 0);
  CHECK(edges.at(0, 3) == 0);
  CHECK(edges.guards_intact());
}

TEST_CASE("the stack holds the worst case: everything weak, one strong") {
  for (const Size size : {Size{1, 1}, Size{200, 1}, Size{1, 200}, Size{41, 37}}) {
    for (const auto& [x, y] :
         {std::pair{0, 0}, {size.width - 1, size.height - 1}, {size.width / 2, size.height / 2}}) {
      GrayImage classes(size, 5, std::uint8_t{weak_edge});
      classes.at(x, y) = strong_edge;
      GrayImage edges(size);
      const HysteresisResult result = fill(classes, edges);
      CHECK(result.edges == static_cast<std::uint32_t>(size.width * size.height));
      CHECK(result.strong == 1);
    }
  }
}

TEST_CASE("the trace sees every pixel once, reached from a neighbour") {
  const GrayImage classes = drawn({"swwww", "....w", "swwww"});
  GrayImage edges(classes.size()), seen(classes.size());
  Diary diary;
  const HysteresisResult result = fill(classes, edges, {Diary::write, &diary});
  REQUIRE(result.status == Status::ok);
  CHECK(diary.steps.size() == result.edges);
  for (const HysteresisStep& step : diary.steps) {
    const bool seed = step.x == step.from_x && step.y == step.from_y;
    CHECK(seen.at(step.x, step.y) == 0);
    CHECK((seed ? classes.at(step.x, step.y) == strong_edge : seen.at(step.from_x, step.from_y) == 255));
    CHECK(std::abs(step.x - step.from_x) <= 1);
    CHECK(std::abs(step.y - step.from_y) <= 1);
    CHECK(step.waiting >= 1);
    CHECK(step.waiting <= hysteresis_stack_size(classes.size()));
    seen.at(step.x, step.y) = 255;
  }
  CHECK(seen == edges);
}

TEST_CASE("the trace can stop the fill, through Canny as well") {
  const GrayImage classes = drawn({"swwww", "....w", "s.s.s"});
  GrayImage edges(classes.size());
  Diary diary;
  diary.stop_after = 3;
  const HysteresisResult result = fill(classes, edges, {Diary::write, &diary});
  CHECK(result.status == Status::cancelled);
  CHECK(diary.steps.size() == 3);
  CHECK(result.edges == 3);
  CHECK(result.strong == 4);

  Pcg32 random(31);
  const GrayImage gray = support::random_scene({60, 40}, random);
  Detector detector(gray.size(), {});
  GrayImage found(gray.size());
  Diary second;
  const CannyResult whole = detector.canny.run(gray.view(), found.view(), {Diary::write, &second});
  CHECK(whole.status == Status::ok);
  CHECK(second.steps.size() == whole.edges);
  second.stop_after = second.steps.size() + 1;
  CHECK(detector.canny.run(gray.view(), found.view(), {Diary::write, &second}).status == Status::cancelled);
}

TEST_CASE("bad input to hysteresis") {
  const GrayImage classes({5, 4});
  GrayImage edges({5, 4}, 5, std::uint8_t{9}), other({4, 5});
  std::vector<std::uint32_t> stack(20);
  CHECK(hysteresis(classes.view(), std::span(stack).first(19), edges.view()).status ==
        Status::workspace_too_small);
  CHECK(hysteresis(classes.view(), stack, other.view()).status == Status::size_mismatch);
  CHECK(hysteresis({}, stack, edges.view()).status == Status::invalid_image);
  CHECK(hysteresis(classes.view(), stack, {}).status == Status::invalid_image);
  CHECK(edges.at(2, 2) == 9);
}
