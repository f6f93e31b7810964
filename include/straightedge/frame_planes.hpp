// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "straightedge/arena.hpp"
#include "straightedge/depth_cells.hpp"
#include "straightedge/depth_view.hpp"
#include "straightedge/detail/quadratic_surface.hpp"
#include "straightedge/found_planes.hpp"
#include "straightedge/frame_planes_options.hpp"
#include "straightedge/frame_planes_search.hpp"
#include "straightedge/inverse_depth.hpp"

namespace straightedge {
namespace detail {
class PlaneSurfaces;
}

/// All planes of a depth frame, with a label for each pixel, from the candidates of any search.
///
///  1. Inverse depth of every pixel; its sums over cells of options.cell to 32 pixels (depth_cells.hpp).
///  2. The search proposes planes.
///  3. Every cell that has no plane takes one, coarse to fine: a cell of 32 pixels the plane that fits it,
///     if one does; a smaller cell one of the planes around it, if one fits; else the best of all. So a
///     plane that cuts through the wall behind it gets no stripe there: the wall's cells have their wall
///     already. Cells that fit their plane well, and no other around, pass it on to all cells in them.
///  4. Planes are fitted anew to their cells; those that are one (chi-square in inverse depth, with a floor)
///     are joined, wherever in the picture they lie.
///  5. A plane without solid pieces (cells that touch) is a stripe along a crease and leaves. One whose solid
///     pieces are bent (a quadratic surface fits them better by more than chance, radius below 0.6 m)
///     is a strip of something round: it leaves with its cells.
///  6. Steps 2 to 5 again on what is left over, as often as the search asks for, if a plane may be in it; cells
///     keep the planes they have.
///  7. Crumbs (pieces of a few cells) lose their plane. Pixels: a full cell that fits well is its plane's as
///     a whole where all around agree, or none near crosses its own in it; else a pixel within the gate is
///     its plane's, or if cells around differ, the nearest one's by the mean over its surface's 3x3 pixels.
///  8. Last fit to the cells of each label; planes with too few pixels leave; largest first.
///
/// Comparison of range image segmentation: A. Hoover et al., IEEE PAMI 18(7), 1996, doi:10.1109/34.506791.
/// Moments in cells: P. Proença, Y. Gao, "Fast cylinder and plane extraction from depth cameras for visual
/// odometry", IROS 2018, doi:10.1109/IROS.2018.8593683.
///
/// Linear in pixels, and in cells times planes for cells that no plane around fits. Memory: about 8 bytes a
/// pixel. A frame without readings has no planes.
class FramePlanes {
 public:
  /// 0 for a size or options that `prepare` refuses.
  static constexpr std::size_t workspace_bytes(Size size, const FramePlanesOptions& options) noexcept {
    if (!detail::valid(options) || check(size) != Status::ok) return 0;
    Arena arena = Arena::measure();
    FramePlanes counted;
    counted.take(arena, size, options);
    return arena.used();
  }

  /// invalid_option: an option out of its range; too_large: more than 2^28 pixels.
  Status prepare(Size size, const FramePlanesOptions& options, std::span<std::byte> workspace) noexcept;

  /// `labels` has the frame's size, and may be the very memory of depth.raw, which is read first and once;
  /// `planes` as many entries as planes are wanted (output_full when more were found; the smaller ones then
  /// are unlabelled). Label k is planes[k − 1]. What the search refuses, such as a frame of another size than
  /// it was prepared for, comes back as its status.
  Status run(const DepthView& depth, const PlaneSearch& search, ImageView<std::uint16_t> labels,
             std::span<FoundPlane> planes, PlanesFound& found) noexcept;

  /// 1/z of the last frame; 0 where there is no reading, and on what was found to be round.
  ImageView<const float> inverse_depth() const noexcept { return inverse_depth_; }
  const DepthCells& cells() const noexcept { return cells_; }
  /// After the last assignment, before planes were sorted; none of cells smaller than options.cell.
  std::span<const std::uint16_t> cell_labels(int level) const noexcept {
    return cell_labels_[static_cast<std::size_t>(level)];
  }

 private:
  static constexpr Status check(Size size) noexcept {
    if (size.width < 1 || size.height < 1) return Status::invalid_image;
    // In 64 bits, which a microcontroller's size_t does not have.
    return std::int64_t{size.width} * size.height > (1 << 28) ? Status::too_large : Status::ok;
  }
  constexpr void take(Arena& arena, Size size, const FramePlanesOptions& options) noexcept {
    size_ = size;
    const std::size_t pixels = DepthCells::cell_count(size);
    inverse_depth_ = {arena.take<float>(pixels).data(), size};
    const int finest = detail::finest_level(options);
    cells_.take(arena, size, finest);
    for (int level = finest; level < DepthCells::levels; ++level) {
      cell_labels_[static_cast<std::size_t>(level)] =
          arena.take<std::uint16_t>(DepthCells::cell_count(DepthCells::size_of(size, level)));
    }
    const std::size_t small_cells = DepthCells::cell_count(DepthCells::size_of(size, finest));
    visited_ = arena.take<std::uint16_t>(small_cells);
    rough_ = arena.take<std::uint16_t>(detail::cell_groups(DepthCells::size_of(size, finest)));
    runs_ = arena.take<std::int32_t>(small_cells);
    candidates_ = arena.take<ProposedPlane>(options.max_planes);
    surfaces_ = arena.take<detail::BentPlane>(options.max_planes);
    squares_ = arena.take<double>(options.max_planes);
    for (auto* sums : {&loose_, &sums_}) *sums = arena.take<detail::QuadraticSums>(options.max_planes);
    float_surfaces_ = detail::take_surfaces(arena, options.max_planes);
    contacts_ = arena.take<std::uint32_t>(std::size_t{options.max_planes} * (options.max_planes - 1U) / 2);
    for (auto* counts : {&solid_, &cells_of_}) *counts = arena.take<std::uint32_t>(options.max_planes);
    moments_ = arena.take<InverseDepthMoments>(options.max_planes);
    becomes_ = arena.take<std::uint16_t>(options.max_planes);
    new_label_ = arena.take<std::uint16_t>(std::size_t{options.max_planes} + 1);
  }
  Status search_round(const DepthView& depth, const PlaneSearch& search,
                      ImageView<const std::uint16_t> labels, PlanesFound& found) noexcept;
  Status read_depth(const DepthView& depth) noexcept;
  void assign_cells() noexcept;
  std::span<std::uint16_t> small_cell_labels() const noexcept {
    return cell_labels_[static_cast<std::size_t>(cells_.finest())];
  }
  void refit(const PinholeCamera& camera) noexcept;
  void join(const detail::PlaneSurfaces& fitting) noexcept;
  void keep() noexcept;
  void rename_cells(std::span<const std::uint16_t> by) noexcept;
  void sort_by_cells() noexcept;
  void judge(const PinholeCamera& camera) noexcept;
  void count_solid(const PinholeCamera& camera) noexcept;
  void clear_round() noexcept;
  void clear_cells(std::int32_t begin, std::int32_t end) noexcept;
  void drop_crumbs() noexcept;
  Status finish(const DepthView& depth, ImageView<std::uint16_t> labels, std::span<FoundPlane> planes,
                PlanesFound& found) noexcept;

  Size size_{};
  FramePlanesOptions options_{};
  std::uint32_t min_pixels_ = 0, count_ = 0;
  ImageView<float> inverse_depth_;
  DepthCells cells_;
  std::array<std::span<std::uint16_t>, DepthCells::levels> cell_labels_{};
  std::span<std::uint16_t> visited_, rough_;  // bits of cells that no plane can fit
  std::span<std::int32_t> runs_;
  std::span<ProposedPlane> candidates_;
  std::span<detail::BentPlane> surfaces_;
  std::span<double> squares_;  // residuals of each plane's cells from its surface
  DepthSurfaces float_surfaces_;
  std::span<detail::QuadraticSums> sums_, loose_;  // of each plane's cells; of those not in solid pieces
  std::span<std::uint32_t> contacts_;              // touching cells of each pair of planes
  std::span<std::uint32_t> solid_, cells_of_;      // of each plane's cells those in solid pieces, and all
  std::span<InverseDepthMoments> moments_;
  std::span<std::uint16_t> becomes_, new_label_;  // each plane (an index, or gone), and each label
  bool prepared_ = false;
};

}  // namespace straightedge
