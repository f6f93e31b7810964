// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <cstdint>

#include "algorithms.hpp"
#include "inputs.hpp"
#include "straightedge/canny_fused.hpp"
#include "straightedge/canny_rows.hpp"
#include "straightedge/gray.hpp"

namespace workspace {
namespace {

Size size() {
  return gray_picture().size();
}

Status run_gray(CallerMemory& memory) {
  // Three bytes a pixel.
  const auto bytes = memory.input(gray_picture());
  const Size third{bytes.width / 3, bytes.height};
  return gray_from_color({bytes.data, third.width, third.height, bytes.stride, PixelFormat::bgr},
                         memory.output<std::uint8_t>(third));
}

Status run_gaussian(CallerMemory& memory) {
  std::uint16_t taps[7] = {};
  if (make_gaussian_kernel(1.2, taps) != Status::ok) return Status::invalid_option;
  Arena needed = Arena::measure();
  GaussianScratch::take(needed, size().width, 7);
  Arena arena(memory.workspace(needed.used()));
  const GaussianScratch scratch = GaussianScratch::take(arena, size().width, 7);
  return gaussian_blur(memory.input(gray_picture()), taps, Border::reflect_101, scratch,
                       memory.output<std::uint8_t>(size()));
}

Status run_sobel(CallerMemory& memory) {
  Arena needed = Arena::measure();
  SobelScratch::take(needed, size().width, 5);
  Arena arena(memory.workspace(needed.used()));
  const SobelScratch scratch = SobelScratch::take(arena, size().width, 5);
  return sobel(memory.input(gray_picture()), 5, Border::replicate, GradientScale::clamp, scratch,
               memory.output<std::int16_t>(size()), memory.output<std::int16_t>(size()));
}

Status run_magnitude(CallerMemory& memory) {
  return gradient_magnitude(memory.input(edges().dx), memory.input(edges().dy), GradientNorm::l2,
                            memory.output<std::int32_t>(size()));
}

Status run_thresholds(CallerMemory& memory) {
  const auto found = automatic_thresholds(memory.input(edges().magnitude), GradientNorm::l1, 3);
  memory.say({found.thresholds.high, found.thresholds.low, found.median * 1.0});
  return found.status;
}

Status run_suppress(CallerMemory& memory) {
  return suppress_non_maxima(memory.input(edges().dx), memory.input(edges().dy),
                             memory.input(edges().magnitude), 50, 150, memory.output<std::uint8_t>(size()));
}

Status run_hysteresis(CallerMemory& memory) {
  Image<std::uint8_t> classes(size());
  REQUIRE(suppress_non_maxima(edges().dx.view(), edges().dy.view(), edges().magnitude.view(), 50, 150,
                              classes.view()) == Status::ok);
  Arena needed = Arena::measure();
  needed.take<std::uint32_t>(hysteresis_stack_size(size()));
  Arena arena(memory.workspace(needed.used()));
  const auto result =
      hysteresis(memory.input(classes), arena.take<std::uint32_t>(hysteresis_stack_size(size())),
                 memory.output<std::uint8_t>(size()));
  memory.say({result.edges * 1.0, result.strong * 1.0});
  return result.status;
}

Status run_canny(CallerMemory& memory) {
  const CannyOptions options{.thresholds = CannyThresholds::automatic};
  Canny canny;
  const Status prepared =
      Canny::prepare(canny, size(), options, memory.workspace(Canny::workspace_bytes(size(), options)));
  const auto result = canny.run(memory.input(gray_picture()), memory.output<std::uint8_t>(size()));
  memory.say({result.edges * 1.0, result.strong * 1.0, result.low, result.high});
  return whole(prepared, result.status);
}

/// So short that the flood fill must sweep again.
constexpr CannyRowOptions short_worklist{.worklist = 3};

Status run_fused_canny(CallerMemory& memory) {
  FusedCanny canny;
  const std::size_t bytes = FusedCanny::workspace_bytes(size(), {}, short_worklist);
  const Status prepared = FusedCanny::prepare(canny, size(), {}, memory.workspace(bytes), short_worklist);
  const auto result = canny.run(memory.input(gray_picture()), memory.output<std::uint8_t>(size()));
  memory.say({result.edges * 1.0, result.strong * 1.0});
  return whole(prepared, result.status);
}

Status run_canny_rows(CallerMemory& memory) {
  CannyRows canny;
  const std::size_t bytes = CannyRows::workspace_bytes(size(), {}, short_worklist);
  const Status prepared = CannyRows::prepare(canny, size(), {}, memory.workspace(bytes), short_worklist);
  const GrayView gray = memory.input(gray_picture());
  const auto found = memory.output<std::uint8_t>(size());
  const auto width = static_cast<std::size_t>(size().width);
  Status status = canny.begin();
  for (int y = 0; y < size().height && status == Status::ok; ++y)
    status = canny.push_row({gray.row(y), width});
  if (status == Status::ok) status = canny.finish().status;
  for (int y = 0; y < size().height && status == Status::ok; ++y) {
    status = canny.read_row(y, {found.row(y), width});
  }
  return whole(prepared, status);
}

constexpr Algorithm algorithms[] = {
    {"gray", run_gray},
    {"gaussian", run_gaussian},
    {"sobel", run_sobel},
    {"magnitude", run_magnitude},
    {"thresholds", run_thresholds},
    {"suppress", run_suppress},
    {"hysteresis", run_hysteresis},
    {"canny", run_canny},
    {"fused canny", run_fused_canny},
    {"canny rows", run_canny_rows},
};

}  // namespace

std::span<const Algorithm> edge_algorithms() {
  return algorithms;
}

}  // namespace workspace
