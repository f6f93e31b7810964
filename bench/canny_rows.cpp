// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <array>
#include <memory>
#include <vector>

#include "rows.hpp"
#include "straightedge/canny.hpp"
#include "straightedge/canny_fused.hpp"
#include "straightedge/canny_rows.hpp"
#include "straightedge/gaussian.hpp"
#include "straightedge/gray.hpp"
#include "straightedge/host/kernels.hpp"
#include "straightedge/hysteresis.hpp"
#include "straightedge/magnitude.hpp"
#include "straightedge/sobel.hpp"
#include "straightedge/suppress.hpp"

namespace bench {
namespace {

using namespace straightedge;

constexpr CannyOptions options;

/// A picture with the whole of Canny run on it, so that each stage finds its input in place.
struct Stages {
  explicit Stages(const Job& job)
      : size(job.size),
        gray(make_picture(job)),
        bytes(size, 0),
        edges(size, 0),
        dx(size, 0),
        dy(size, 0),
        magnitude(size, 0),
        stack(hysteresis_stack_size(size)),
        workspace(Canny::workspace_bytes(size, options)),
        scratch(1 << 20) {
    require(Canny::prepare(canny, size, options, workspace), "prepare");
    require(canny.run(gray, edges.view()).status, "canny");
  }

  Size size;
  Image<std::uint8_t> gray, bytes, edges;
  Image<std::int16_t> dx, dy;
  Image<std::int32_t> magnitude;
  std::vector<std::uint32_t> stack;
  std::vector<std::byte> workspace, scratch;
  Canny canny;
};

auto prepare_gray(const Job& job) {
  auto s = std::make_shared<Stages>(job);
  auto color = std::make_shared<std::vector<std::uint8_t>>();
  for (std::int32_t y = 0; y < s->size.height; ++y) {
    for (std::int32_t x = 0; x < s->size.width; ++x) color->insert(color->end(), 3, s->gray.at(x, y));
  }
  return [s, color] {
    const ColorView view{color->data(), s->size.width, s->size.height, std::ptrdiff_t{3} * s->size.width,
                         PixelFormat::rgb};
    require(gray_from_color(view, s->bytes.view()), "gray");
  };
}

auto prepare_blur(const Job& job) {
  auto s = std::make_shared<Stages>(job);
  auto taps =
      std::make_shared<std::vector<std::uint16_t>>(static_cast<std::size_t>(gaussian_size(options.sigma)));
  require(make_gaussian_kernel(options.sigma, *taps), "kernel");
  Arena arena(s->scratch);
  const auto scratch = GaussianScratch::take(arena, s->size.width, static_cast<std::int32_t>(taps->size()));
  return [s, taps, scratch] {
    require(gaussian_blur(s->gray, *taps, Border::reflect_101, scratch, s->bytes.view()), "blur");
  };
}

auto prepare_sobel(const Job& job) {
  auto s = std::make_shared<Stages>(job);
  Arena arena(s->scratch);
  const auto scratch = SobelScratch::take(arena, s->size.width, options.aperture);
  return [s, scratch] {
    require(sobel(s->canny.blurred(), options.aperture, Border::replicate, GradientScale::clamp, scratch,
                  s->dx.view(), s->dy.view()),
            "sobel");
  };
}

auto prepare_magnitude(const Job& job) {
  auto s = std::make_shared<Stages>(job);
  return [s] {
    require(
        gradient_magnitude(s->canny.gradient_x(), s->canny.gradient_y(), options.norm, s->magnitude.view()),
        "magnitude");
  };
}

auto prepare_suppress(const Job& job) {
  auto s = std::make_shared<Stages>(job);
  return [s] {
    require(suppress_non_maxima(s->canny.gradient_x(), s->canny.gradient_y(), s->canny.magnitude(),
                                static_cast<std::int32_t>(options.low),
                                static_cast<std::int32_t>(options.high), s->bytes.view()),
            "suppress");
  };
}

auto prepare_hysteresis(const Job& job) {
  auto s = std::make_shared<Stages>(job);
  return [s] { require(hysteresis(s->canny.suppressed(), s->stack, s->edges.view()).status, "hysteresis"); };
}

auto prepare_canny(const Job& job) {
  auto s = std::make_shared<Stages>(job);
  return [s] { require(s->canny.run(s->gray, s->edges.view()).status, "canny"); };
}

auto prepare_fused(const Job& job, const KernelSet& kernels) {
  auto s = std::make_shared<Stages>(job);
  auto workspace = std::make_shared<std::vector<std::byte>>(FusedCanny::workspace_bytes(s->size, options));
  auto canny = std::make_shared<FusedCanny>();
  require(FusedCanny::prepare(*canny, s->size, options, *workspace, {.kernels = kernels.canny_rows}),
          "prepare");
  return [s, workspace, canny] { require(canny->run(s->gray, s->edges.view()).status, "fused canny"); };
}

auto prepare_canny_fused(const Job& job) {
  return prepare_fused(job, kernel_sets().front());
}

auto prepare_canny_fused_fast(const Job& job) {
  return prepare_fused(job, best_kernels());
}

auto prepare_canny_by_rows(const Job& job) {
  auto s = std::make_shared<Stages>(job);
  auto workspace = std::make_shared<std::vector<std::byte>>(CannyRows::workspace_bytes(s->size, options));
  auto canny = std::make_shared<CannyRows>();
  require(CannyRows::prepare(*canny, s->size, options, *workspace), "prepare");
  return [s, workspace, canny] {
    require(canny->begin(), "begin");
    for (std::int32_t y = 0; y < s->size.height; ++y) {
      require(canny->push_row({&s->gray.at(0, y), static_cast<std::size_t>(s->size.width)}), "row");
    }
    require(canny->finish().status, "canny by rows");
  };
}

}  // namespace

void add_canny_rows(const Job& job) {
  add_row("gray", job, prepare_gray);
  add_row("blur", job, prepare_blur);
  add_row("sobel", job, prepare_sobel);
  add_row("magnitude", job, prepare_magnitude);
  add_row("suppress", job, prepare_suppress);
  add_row("hysteresis", job, prepare_hysteresis);
  add_row("canny", job, prepare_canny);
  add_row("canny_fused", job, prepare_canny_fused);
  add_row("canny_fused_fast", job, prepare_canny_fused_fast);
  add_row("canny_by_rows", job, prepare_canny_by_rows);
}

}  // namespace bench
