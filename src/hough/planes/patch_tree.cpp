// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "hough/planes/patch_tree.hpp"

#include "straightedge/square_root.hpp"

namespace straightedge::hough {
namespace {

// A square with a smaller share of readings is cut, one of the smallest kind dropped.
constexpr double least_share = 0.25;
// With fewer it is passed by at once.
constexpr float least_readings = 16;
// Standard deviations by which the residual may exceed the noise.
constexpr double residual_sigmas = 3;
// The same for the mean residuals of a square's parts, which a crease or a curve moves together.
constexpr double parts_sigmas = 3;

/// A square's readings in doubles.
struct Centred {
  double n = 0, u = 0, v = 0, q = 0;
  double uu = 0, uv = 0, vv = 0, uq = 0, vq = 0, qq = 0;

  Centred(const DepthCell& c, const PatchLevels& levels) noexcept
      : n(number(c.n)),
        u(number(c.u) + levels.middle_u),
        v(number(c.v) + levels.middle_v),
        q(number(c.q)),
        uu(number(c.uu)),
        uv(number(c.uv)),
        vv(number(c.vv)),
        uq(number(c.uq)),
        vq(number(c.vq)),
        qq(number(c.qq)) {}

  static double number(float x) noexcept { return static_cast<double>(x); }
};

struct Square {
  std::int32_t level = 0, column = 0, row = 0;
};

class Tree {
 public:
  Tree(const PatchScene& scene, const PatchLevels& levels, std::int32_t bottom,
       std::span<HoughPatch> patches) noexcept
      : scene_(scene), levels_(levels), bottom_(bottom), patches_(patches) {}

  /// A walk in order of position, without recursion: after a square its next brother, after the last of four
  /// the father's next one.
  void cut(std::int32_t column, std::int32_t row, std::int32_t top) noexcept;
  std::size_t size() const noexcept { return size_; }

 private:
  /// False: beyond the picture.
  bool find(const Square& s, std::size_t& place) const noexcept {
    const Size squares = levels_.squares(s.level);
    place = static_cast<std::size_t>(s.row) * static_cast<std::size_t>(squares.width) +
            static_cast<std::size_t>(s.column);
    return s.column < squares.width && s.row < squares.height;
  }
  bool planar(const Square& s, const DepthCell& cell) noexcept;
  bool parts_agree(const Square& s, const InverseDepthPlane& plane, double noise) const noexcept;

  const PatchScene& scene_;
  const PatchLevels& levels_;
  std::int32_t bottom_;
  std::span<HoughPatch> patches_;
  std::size_t size_ = 0;
};

void Tree::cut(std::int32_t column, std::int32_t row, std::int32_t top) noexcept {
  Square s{top, column, row};
  for (;;) {
    std::size_t place = 0;
    const bool some = find(s, place) && levels_.readings(s.level)[place] >= least_readings;
    if (some && !planar(s, levels_.at(s.level, place)) && s.level > bottom_) {
      s = {s.level - 1, 2 * s.column, 2 * s.row};
      continue;
    }
    // The last of four is at odd column and odd row.
    while (s.level < top && s.column % 2 == 1 && s.row % 2 == 1) {
      s = {s.level + 1, s.column / 2, s.row / 2};
    }
    if (s.level == top) return;
    if (s.column % 2 == 0) {
      ++s.column;
    } else {
      --s.column;
      ++s.row;
    }
  }
}

bool Tree::planar(const Square& s, const DepthCell& cell) noexcept {
  const std::int32_t side = hough_patch_side << s.level;
  const Centred c(cell, levels_);
  if (c.n < least_share * side * side) return false;
  const double determinant = c.uu * c.vv - c.uv * c.uv;
  // Readings along a line say nothing across it.
  if (!(determinant > 0.02 * c.uu * c.vv) || !(c.uu > c.n) || !(c.vv > c.n)) return false;
  const double a = (c.uq * c.vv - c.vq * c.uv) / determinant;
  const double b = (c.vq * c.uu - c.uq * c.uv) / determinant;
  const double sigma = scene_.gate.inverse_noise(c.q);
  const double variance = (c.qq - a * c.uq - b * c.vq) / c.n;
  const double shared = scene_.options.shared_noise_pixels;
  const double slack = residual_sigmas * square_root(shared / c.n);
  if (!(variance <= sigma * sigma * (1 + slack))) return false;
  const InverseDepthPlane plane{a, b, c.q - a * c.u - b * c.v};
  const double noise = sigma * sigma * shared;
  if (s.level > 0 && !parts_agree(s, plane, noise)) return false;

  HoughPatch& patch = patches_[size_++];
  patch = {};
  patch.x = s.column * side;
  patch.y = s.row * side;
  patch.side = side;
  patch.cell = cell;
  patch.plane = plane;
  patch.mean_u = c.u;
  patch.mean_v = c.v;
  patch.mean_q = c.q;
  patch.gate = scene_.gate.sigmas * sigma;
  patch.noise = noise;
  const double scale = noise / determinant;
  patch.slope_covariance = {scale * c.vv, -scale * c.uv, scale * c.uu};
  return true;
}

bool Tree::parts_agree(const Square& s, const InverseDepthPlane& plane, double noise) const noexcept {
  const std::int32_t deeper = s.level > 1 ? 2 : 1;
  const std::int32_t across = 1 << deeper;
  double sum = 0, parts = 0;
  for (std::int32_t i = 0; i < across * across; ++i) {
    const Square part{s.level - deeper, across * s.column + i % across, across * s.row + i / across};
    std::size_t place = 0;
    if (!find(part, place) || levels_.readings(part.level)[place] < least_readings) continue;
    const Centred c(levels_.at(part.level, place), levels_);
    const double residual = c.q - plane.at(c.u, c.v);
    sum += c.n * (residual * residual);
    ++parts;
  }
  sum /= noise;  // each residual² against noise / n
  const double freedom = parts > 4 ? parts - 3 : 1;
  return sum <= freedom + parts_sigmas * square_root(2 * freedom);
}

}  // namespace

std::size_t make_patches(const PatchScene& scene, const PatchLevels& levels,
                         std::span<HoughPatch> patches) noexcept {
  std::int32_t top = 0, bottom = 0;
  while ((hough_patch_side << top) < scene.options.largest_patch) ++top;
  while ((hough_patch_side << bottom) < scene.options.smallest_patch) ++bottom;
  Tree tree(scene, levels, bottom, patches);
  const std::int32_t side = hough_patch_side << top;
  for (std::int32_t row = 0; row * side < scene.size.height; ++row) {
    for (std::int32_t column = 0; column * side < scene.size.width; ++column) tree.cut(column, row, top);
  }
  return tree.size();
}

}  // namespace straightedge::hough
