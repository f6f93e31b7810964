// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "canny_names.hpp"
#include "cases.hpp"
#include "inputs.hpp"
#include "memory.hpp"
#include "straightedge/gaussian.hpp"
#include "straightedge/hysteresis.hpp"
#include "straightedge/random.hpp"
#include "straightedge/sobel.hpp"
#include "straightedge/suppress.hpp"
#include "straightedge/thresholds.hpp"

namespace same_bits {
namespace {

using namespace straightedge;

struct NamedBorder {
  Border border;
  const char* name;
};
constexpr NamedBorder borders[] = {{Border::constant, ".constant"},
                                   {Border::replicate, ".replicate"},
                                   {Border::reflect, ".reflect"},
                                   {Border::reflect_101, ".reflect_101"}};

/// The planes that the stages hand on.
struct Planes {
  ImageView<std::uint8_t> gray, classes, edges;
  ImageView<std::int16_t> dx, dy;
  ImageView<std::int32_t> magnitude;
  std::span<std::uint32_t> stack;
  GaussianScratch gaussian;
  SobelScratch sobel;

  static constexpr Planes take(Arena& arena) noexcept {
    constexpr std::size_t pixels = hysteresis_stack_size(picture_size);
    Planes p;
    for (auto* plane : {&p.gray, &p.classes, &p.edges}) {
      *plane = {arena.take<std::uint8_t>(pixels).data(), picture_size};
    }
    for (auto* plane : {&p.dx, &p.dy}) *plane = {arena.take<std::int16_t>(pixels).data(), picture_size};
    p.magnitude = {arena.take<std::int32_t>(pixels).data(), picture_size};
    p.stack = arena.take<std::uint32_t>(pixels);
    p.gaussian = GaussianScratch::take(arena, picture_size.width, max_gaussian_size);
    p.sobel = SobelScratch::take(arena, picture_size.width, 7);
    return p;
  }
  static constexpr std::size_t bytes() noexcept {
    Arena arena = Arena::measure();
    (void)take(arena);
    return arena.used();
  }
};
static_assert(Planes::bytes() <= most_workspace);

void gray_rows(const Report& report) noexcept {
  constexpr struct {
    PixelFormat format;
    const char* name;
  } formats[] = {{PixelFormat::gray, "gray"},
                 {PixelFormat::rgb, "rgb"},
                 {PixelFormat::bgr, "bgr"},
                 {PixelFormat::rgba, "rgba"},
                 {PixelFormat::bgra, "bgra"}};
  for (const auto& [format, name] : formats) {
    const ImageView<std::uint8_t> gray(reinterpret_cast<std::uint8_t*>(workspace().data()), color_size, 67);
    Hash hash;
    hash.add(gray_from_color(color_picture(format), gray), gray);
    report.row({"canny.gray.", name}, hash);
  }
}

void blur_rows(const Report& report, const Planes& p) noexcept {
  for (const auto& [sigma, name] : sigmas) {
    std::array<std::uint16_t, max_gaussian_size> taps{};
    const auto kernel = std::span(taps).first(static_cast<std::size_t>(gaussian_size(sigma)));
    Hash taps_hash;
    taps_hash.add(make_gaussian_kernel(sigma, kernel), kernel);
    report.row({"canny.gaussian_kernel", name}, taps_hash);
    for (const auto& [border, border_name] : borders) {
      Hash hash;
      hash.add(gaussian_blur(picture(), kernel, border, p.gaussian, p.gray), p.gray);
      report.row({"canny.blur", name, border_name}, hash);
    }
  }
  Hash sized;
  for (std::size_t size = 1; size <= 31; size += 2) {
    std::array<std::uint16_t, 31> taps{};
    sized.add(make_gaussian_kernel(0, std::span(taps).first(size)), taps);
  }
  report.row({"canny.gaussian_kernel.by_size"}, sized);
}

void sobel_rows(const Report& report, const Planes& p, int aperture, const char* name) noexcept {
  for (const auto& [border, border_name] : borders) {
    Hash hash;
    hash.add(sobel(noise_picture(), aperture, border, GradientScale::clamp, p.sobel, p.dx, p.dy), p.dx, p.dy);
    report.row({"canny.sobel", name, border_name}, hash);
  }
  const GradientScale scale = aperture == 7 ? GradientScale::sixteenth : GradientScale::clamp;
  Hash hash;
  hash.add(sobel(picture(), aperture, Border::replicate, scale, p.sobel, p.dx, p.dy), p.dx, p.dy);
  report.row({"canny.sobel", name, ".picture"}, hash);
}

/// From the gradient to the edges.
void later_rows(const Report& report, const Planes& p, int aperture, const char* name) noexcept {
  for (const auto& [norm, norm_name] : norms) {
    Hash magnitudes, limits, classes, edges;
    magnitudes.add(gradient_magnitude(p.dx, p.dy, norm, p.magnitude), p.magnitude);
    const AutomaticThresholds automatic = automatic_thresholds(p.magnitude, norm, aperture);
    limits.add(automatic.status, automatic.thresholds.low, automatic.thresholds.high, automatic.median);
    const MagnitudeThresholds used = to_magnitude(automatic.thresholds, norm, aperture);
    limits.add(used.low, used.high);
    classes.add(suppress_non_maxima(p.dx, p.dy, p.magnitude, used.low, used.high, p.classes), p.classes);
    const HysteresisResult result = hysteresis(p.classes, p.stack, p.edges);
    edges.add(result.status, result.strong, result.edges, p.edges);
    report.row({"canny.magnitude", norm_name, name}, magnitudes);
    report.row({"canny.thresholds", norm_name, name}, limits);
    report.row({"canny.suppress", norm_name, name}, classes);
    report.row({"canny.hysteresis", norm_name, name}, edges);
  }
}

void random_hysteresis_row(const Report& report, const Planes& p) noexcept {
  Pcg32 random(31);
  for (int y = 0; y < picture_size.height; ++y) {
    for (int x = 0; x < picture_size.width; ++x) {
      const std::uint32_t chance = random.below(100);
      p.classes.at(x, y) = chance < 2 ? strong_edge : chance < 40 ? weak_edge : no_edge;
    }
  }
  Hash hash;
  const HysteresisResult result = hysteresis(p.classes, p.stack, p.edges);
  hash.add(result.status, result.strong, result.edges, p.edges);
  report.row({"canny.hysteresis.random"}, hash);
}

}  // namespace

void canny_stage_cases(const Report& report) noexcept {
  gray_rows(report);
  Arena arena(workspace());
  const Planes planes = Planes::take(arena);
  blur_rows(report, planes);
  for (const auto& [aperture, name] : apertures) {
    sobel_rows(report, planes, aperture, name);
    later_rows(report, planes, aperture, name);
  }
  random_hysteresis_row(report, planes);
}

}  // namespace same_bits
