// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <array>

#include "cases.hpp"
#include "hash_results.hpp"
#include "inputs.hpp"
#include "memory.hpp"
#include "straightedge/depth_cells.hpp"
#include "straightedge/detail/quadratic_surface.hpp"
#include "straightedge/random.hpp"
#include "straightedge/symmetric_eigen.hpp"
#include "straightedge/trigonometry.hpp"

namespace same_bits {
namespace {

using namespace straightedge;

/// In [−8, 8), a multiple of 2^-12.
double number(Pcg32& random) noexcept {
  return static_cast<double>(static_cast<std::int32_t>(random.below(65536)) - 32768) / 4096;
}

void eigen_row(const Report& report) noexcept {
  Pcg32 random(51);
  Hash hash;
  const auto add = [&](const std::array<double, 6>& upper) {
    const SymmetricEigen e = symmetric_eigen(upper);
    hash.add(e.values, e.vectors);
  };
  for (int i = 0; i < 150; ++i) {
    std::array<double, 6> upper{};
    const double scale = i % 7 == 0 ? 1e-9 : i % 5 == 0 ? 3e12 : 1;
    for (double& entry : upper) entry = scale * number(random);
    if (i % 3 == 0) upper[0] = upper[3] = upper[5];
    add(upper);
  }
  add({0, 0, 0, 0, 0, 0});
  add({1, 0, 0, 1, 0, 1});
  add({2, 0, 0, 1, 0, 3});
  add({1, 1, 1, 1, 1, 1});
  report.row({"fit.symmetric_eigen"}, hash);
}

constexpr std::size_t planes = 24;
SAME_BITS_LARGE std::array<PlaneFit, planes> fits;

void plane_row(const Report& report) noexcept {
  Pcg32 random(52);
  Hash hash;
  for (PlaneFit& fit : fits) {
    PlaneMoments moments, others;
    const double a = number(random) / 4, b = number(random) / 4, c = number(random);
    for (int k = 0; k < 20; ++k) {
      const double x = number(random), y = number(random), noise = number(random) / 512;
      (k % 2 == 0 ? moments : others).add({x, y, a * x + b * y + c + noise}, 0.5 + (k % 5) / 8.0);
    }
    moments.add(others);
    hash.add(moments, others.seen_from({1, -2, 0.3}));
    fit = {};
    hash.add(fit_plane(moments, fit), fit);
  }
  report.row({"fit.plane"}, hash);
}

void plane_use_rows(const Report& report) noexcept {
  Hash floors, distances, fused_hash, matrices, moved_hash;
  const double s = sine(0.3), c = cosine(0.3);
  for (std::size_t i = 0; i < planes; ++i) {
    add_floor(fits[i], {});
    floors.add(fits[i]);
    matrices.add(covariance_4x4(fits[i]));
    moved_hash.add(moved(fits[i], {c, -s, 0, s, c, 0, 0, 0, 1}, {0.5, -1.25, 2}));
    for (std::size_t j = 0; j < i; ++j) {
      PlaneFit fused;
      distances.add(plane_chi_square(fits[i], fits[j]));
      fused_hash.add(fuse_planes(fits[i], fits[j], fused), fused);
    }
  }
  report.row({"fit.plane_floor"}, floors);
  report.row({"fit.plane_chi_square"}, distances);
  report.row({"fit.fuse_planes"}, fused_hash);
  report.row({"fit.covariance_4x4"}, matrices);
  report.row({"fit.moved"}, moved_hash);
}

constexpr std::size_t depth_pixels = std::size_t{depth_size.width} * depth_size.height;

struct Depths {
  ImageView<float> inverse;
  DepthCells cells;

  static constexpr Depths take(Arena& arena) noexcept {
    Depths d;
    d.inverse = {arena.take<float>(depth_pixels).data(), depth_size};
    d.cells.take(arena, depth_size);
    return d;
  }
  static constexpr std::size_t bytes() noexcept {
    Arena arena = Arena::measure();
    (void)take(arena);
    return arena.used();
  }
};
static_assert(Depths::bytes() <= most_workspace);

void inverse_depth_rows(const Report& report) noexcept {
  Arena arena(workspace());
  Depths depths = Depths::take(arena);
  const DepthView depth = depth_picture();
  Hash pixels, sums, least_squares, in_space;
  pixels.add(inverse_depth_image(depth, depths.inverse), depths.inverse);
  depths.cells.build(depths.inverse);
  for (int level = 0; level < DepthCells::levels; ++level) {
    for (std::size_t i = 0; i < DepthCells::cell_count(depths.cells.size(level)); ++i) {
      const InverseDepthMoments moments = depths.cells.moments(level, i);
      sums.add(std::span<const InverseDepthMoments>(&moments, 1));
      if (level == 0) continue;
      InverseDepthFit fit;
      PlaneFit plane;
      least_squares.add(fit_inverse_depth(moments, 1.425e-3, fit), fit);
      least_squares.add(static_cast<double>(squared_residuals(
          depths.cells.at(level, i), {static_cast<float>(fit.plane.c), static_cast<float>(fit.plane.a),
                                      static_cast<float>(fit.plane.b)})));
      in_space.add(to_plane_fit(fit, 1.425e-3, depth.camera, plane), plane);
      in_space.add(to_inverse_depth(plane.plane, depth.camera));
    }
  }
  report.row({"fit.inverse_depth_image"}, pixels);
  report.row({"fit.depth_cells"}, sums);
  report.row({"fit.inverse_depth"}, least_squares);
  report.row({"fit.to_plane_fit"}, in_space);
}

void quadratic_row(const Report& report) noexcept {
  Pcg32 random(53);
  Hash hash;
  for (int i = 0; i < 25; ++i) {
    detail::QuadraticSums sums;
    for (int k = 0; k < 30; ++k) {
      const double x = number(random), y = number(random);
      sums.add(x, y, 0.3 * x - 0.1 * y + 0.02 * x * y + number(random) / 64, 1 + k % 3);
    }
    detail::QuadraticFit fit;
    hash.add(sums.moments, sums.right, sums.qq, sums.n);
    hash.add(detail::fit_quadratic(sums, 0.25 * (i % 4), fit), fit.coefficients, fit.squares,
             fit.bend_squares);
  }
  report.row({"fit.quadratic_surface"}, hash);
}

}  // namespace

void plane_fit_cases(const Report& report) noexcept {
  eigen_row(report);
  plane_row(report);
  plane_use_rows(report);
  inverse_depth_rows(report);
  quadratic_row(report);
}

}  // namespace same_bits
