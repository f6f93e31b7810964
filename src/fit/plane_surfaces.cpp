// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "plane_surfaces.hpp"

#include <algorithm>
#include <array>

#include "cell_labels.hpp"
#include "four_labels.hpp"

namespace straightedge::detail {
namespace {

// One true pair in a hundred lies further apart (chi-square, 3 degrees of freedom).
constexpr double chi_square_gate = 11.34;
// Nor are planes told apart that lie nearer than this in deviations of the noise, root mean square over the
// smaller one: two planes that share the cells of one surface part them by the sign of their noise. Where
// their cells alternate all over (so many contacts a cell of the smaller one) it takes more; planes that do
// not touch part no surface.
constexpr double floor_when_apart = 0.5;
constexpr double floor_when_touching = 1.5;
constexpr double floor_when_mixed = 2.5;
constexpr double contacts_of_mixed = 0.25;
// So many times the cost that would be allowed leaves no doubt, though bends are held back.
constexpr double surely = 2;
// Standard deviation of the bend: the radius of a wall in the picture of a common sensor. Half a Kinect's
// picture sags by some three deviations of its noise then.
constexpr double usual_radius_m = 40;

constexpr std::uint16_t fresh = CellLabeller::fresh;

/// Cells [x, right) x [y, bottom).
struct CellBox {
  std::int32_t x, y;
  Size end;
};

template <class Visit>
void for_cells(const CellBox& box, const Visit& visit) noexcept {
  for (std::int32_t y = box.y; y < box.end.height; ++y) {
    for (std::int32_t x = box.x; x < box.end.width; ++x) visit(x, y);
  }
}

/// The cells that a cell `doublings` levels above is made of.
CellBox part(std::int32_t x, std::int32_t y, int doublings, Size size) noexcept {
  const std::int32_t side = 1 << doublings;
  return {x * side, y * side, {std::min((x + 1) * side, size.width), std::min((y + 1) * side, size.height)}};
}

struct FreshCells {
  Size size;
  std::span<std::uint16_t> labels;
  enum Kind : std::uint8_t { none, same, mixed };

  std::uint16_t* at(std::int32_t x, std::int32_t y) const noexcept {
    return labels.data() + static_cast<std::ptrdiff_t>(y) * size.width + x;
  }
  /// Whether some of the cells are fresh, and then, whether all are and have one label.
  Kind kind(const CellBox& box) const noexcept {
    const std::uint16_t* row = at(box.x, box.y);
    const std::uint16_t first = *row;
    std::uint64_t differ = 0, some = 0;
    for (std::int32_t j = box.y; j < box.end.height; ++j, row += size.width) {
      const std::uint64_t labels_of_row = up_to_four(row, box.end.width - box.x);
      differ |= labels_of_row ^ (first * four_ones);
      some |= labels_of_row;
    }
    return (some & (fresh * four_ones)) == 0 ? none : differ == 0 ? same : mixed;
  }
  /// Their label; they are fresh no more.
  std::uint16_t take(const CellBox& box) const noexcept {
    const auto label = static_cast<std::uint16_t>(*at(box.x, box.y) & ~fresh);
    for (std::int32_t y = box.y; y < box.end.height; ++y)
      set_up_to_four(at(box.x, y), box.end.width - box.x, label);
    return label;
  }
  /// Calls add(cell, label) for those that are fresh; two beside one another of one plane count as one. (What
  /// counts as one has to touch: as one piece it may be taken off the sums again.)
  template <class Add>
  void take_pairs(const DepthCells& cells, const CellBox& box, const Add& add) const noexcept {
    for (std::int32_t y = box.y; y < box.end.height; ++y) {
      for (std::int32_t x = box.x; x < box.end.width; ++x) {
        const std::uint16_t marked = *at(x, y);
        if ((marked & fresh) == 0) continue;
        const auto label = static_cast<std::uint16_t>(marked & ~fresh);
        const auto place = static_cast<std::size_t>(at(x, y) - labels.data());
        *at(x, y) = label;
        DepthCell cell = cells.at(cells.finest(), place);
        if (x + 1 < box.end.width && *at(x + 1, y) == marked) {
          *at(++x, y) = label;
          cell = mean_of(cell, cells.at(cells.finest(), place + 1));
        }
        add(cell, label);
      }
    }
  }

 private:
  /// Readings and means of both.
  static DepthCell mean_of(const DepthCell& a, const DepthCell& b) noexcept {
    const float n = a.n + b.n, share = b.n / n;
    return {n, a.u + share * (b.u - a.u), a.v + share * (b.v - a.v), a.q + share * (b.q - a.q)};
  }
};

}  // namespace

PlaneSurfaces::PlaneSurfaces(Size picture, const PinholeCamera& camera,
                             const FramePlanesOptions& options) noexcept
    : u0_(picture.width / 2.0),
      v0_(picture.height / 2.0),
      scale_(scale_of(picture)),
      inverse_scale_(1 / scale_),
      focal_square_(camera.fx * camera.fx),
      options_(options) {}

void PlaneSurfaces::add(const DepthCell& cell, QuadraticSums& sums) const noexcept {
  sums.add(static_cast<double>(cell.u) * inverse_scale_, static_cast<double>(cell.v) * inverse_scale_,
           static_cast<double>(cell.q), static_cast<double>(cell.n));
}

void PlaneSurfaces::add_fresh(const DepthCells& cells, std::span<std::uint16_t> cell_labels,
                              std::span<QuadraticSums> sums) const noexcept {
  const int finest = cells.finest(), coarsest = std::min(finest + 2, DepthCells::levels - 1);
  const FreshCells all{cells.size(finest), cell_labels};
  /// False where cells differ.
  const auto add_cell = [&](int level, std::int32_t x, std::int32_t y) noexcept {
    const CellBox box = part(x, y, level - finest, all.size);
    const FreshCells::Kind kind = all.kind(box);
    if (kind != FreshCells::same) return kind == FreshCells::none;
    const auto width = static_cast<std::size_t>(cells.size(level).width);
    add(cells.at(level, static_cast<std::size_t>(y) * width + static_cast<std::size_t>(x)),
        sums[all.take(box) - 1U]);
    return true;
  };
  // The cells of a larger one that are all of one plane count as one: there are far fewer of those.
  for_cells({0, 0, cells.size(coarsest)}, [&](std::int32_t X, std::int32_t Y) noexcept {
    if (add_cell(coarsest, X, Y)) return;
    for_cells(part(X, Y, coarsest - finest - 1, cells.size(finest + 1)), [&](std::int32_t x,
                                                                             std::int32_t y) noexcept {
      if (add_cell(finest + 1, x, y)) return;
      all.take_pairs(cells, part(x, y, 1, all.size),
                     [&](const DepthCell& cell, std::uint16_t of) noexcept { add(cell, sums[of - 1U]); });
    });
  });
}

bool PlaneSurfaces::solve(const QuadraticSums& sums, QuadraticFit& found) const noexcept {
  if (!(sums.n > 0)) return false;
  const double noise = options_.gate.inverse_noise(sums.right[0] / sums.n);
  // A radius r is a second derivative 1/(r f²) per pixel², twice the coefficient per scaled unit².
  const double usual = scale_ * scale_ / (2 * usual_radius_m * focal_square_);
  return fit_quadratic(sums, noise * noise * options_.noise_pixels / (usual * usual), found);
}

bool PlaneSurfaces::fit(const QuadraticSums& sums, BentPlane& surface, double& squares) const noexcept {
  QuadraticFit found;
  if (!solve(sums, found)) return false;
  const auto& c = found.coefficients;
  const double a = c[1] / scale_, b = c[2] / scale_, square = scale_ * scale_;
  surface = {{a, b, c[0] - a * u0_ - b * v0_}, c[3] / square, c[4] / square, c[5] / square, u0_, v0_};
  squares = found.squares;
  return true;
}

double PlaneSurfaces::allowed(const QuadraticSums& a, const QuadraticSums& b, double floor) const noexcept {
  const double n = a.n + b.n, noise = options_.gate.inverse_noise((a.right[0] + b.right[0]) / n);
  return noise * noise * (chi_square_gate * options_.noise_pixels + floor * floor * a.n * b.n / n);
}

bool PlaneSurfaces::are_far(const QuadraticSums& a, const QuadraticFit& fit_of_a,
                            const QuadraticSums& b) const noexcept {
  return least_cost(fit_of_a, b) > surely * allowed(a, b, floor_when_mixed);
}

bool PlaneSurfaces::are_one(const QuadraticSums& a, const QuadraticSums& b, double squares_apart,
                            Contacts& contacts, BentPlane& surface, double& squares) const noexcept {
  QuadraticSums both = a;
  both.add(b);
  BentPlane common;
  double squares_of_both = 0;
  if (!fit(both, common, squares_of_both)) return false;
  const double cost = squares_of_both - squares_apart;
  if (!(cost < allowed(a, b, floor_when_mixed))) return false;
  const double cells = std::min(a.n, b.n) / (options_.cell * options_.cell);
  const std::uint32_t touching = contacts.of(contacts.i, contacts.j);
  const bool mixed_up = touching >= contacts_of_mixed * cells;
  const double floor = mixed_up ? floor_when_mixed : touching > 0 ? floor_when_touching : floor_when_apart;
  if (!(cost < allowed(a, b, floor))) return false;
  surface = common;
  squares = squares_of_both;
  return true;
}

}  // namespace straightedge::detail
