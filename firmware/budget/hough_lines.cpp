// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT

// The method is METHOD: standard, progressive or randomized.
#include "straightedge/hough_lines.hpp"
#include "budget/case.hpp"
#include "budget/edge_input.hpp"

namespace {

using namespace straightedge;

/// Steps of one pixel and two degrees; room for 8000 edge pixels at 320x240.
constexpr HoughOptions options_for(Size size) noexcept {
  return {.method = HoughMethod::METHOD,
          .theta_step = pi / 90,
          .threshold = size.width / 10,
          .min_length = size.width / 20.0,
          .max_gap = 4,
          .max_edge_pixels = static_cast<std::uint32_t>(firmware::pixels_of(size) * 5 / 48),
          .max_draws = firmware::pixels_of(size) / 8};
}

[[gnu::section(".big.workspace")]] alignas(
    64) std::array<std::byte, HoughLines::workspace_bytes({640, 480}, options_for({640, 480}))> workspace;
std::array<HoughSegment, 500> segments;
std::array<HoughPeak, 100> peaks;

bool measure(Size size) noexcept {
  const HoughOptions options = options_for(size);
  const std::size_t bytes = HoughLines::workspace_bytes(size, options);
  const GrayView edges = firmware::plan_edges(size);
  HoughLines hough;
  if (HoughLines::prepare(hough, size, options, std::span(workspace).first(bytes)) != Status::ok)
    return false;
  return firmware::count("HoughLines/" NAME_OF(METHOD), size, bytes,
                         [&] { return hough.run(edges, peaks, segments).segments > 0; });
}

}  // namespace

int main() {
  for (const Size size : firmware::budget_sizes) {
    if (!measure(size)) return 1;
  }
}
