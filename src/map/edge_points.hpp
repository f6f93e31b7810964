// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "hough/refit_recipe.hpp"
#include "map/edge_bits.hpp"
#include "map/edge_reading.hpp"
#include "map/picture_rows.hpp"
#include "straightedge/edge_position.hpp"
#include "straightedge/host/image.hpp"
#include "straightedge/host/kernels.hpp"
#include "straightedge/magnitude.hpp"

namespace straightedge {

/// The edge points of a picture, each found once: every pixel is looked at by several candidates, and by each
/// more than once. They are the `Edges` of refit_recipe.hpp, and give what the mask and the field would.
///
/// The pixels that may be used are kept three times: as a mask, and as bits along rows and along columns, so
/// that those across a line, flat or steep, are in one word. A point's number is that of the edges in the
/// rows before, before its eight columns, and before it in these.
class EdgePoints {
 public:
  /// All points of `edges`, whose pixels are not 0. Without a magnitude: that of the gradient of positions.
  void find(GrayView edges, const EdgeSources& sources, GradientNorm norm, const KernelSet& kernels);

  /// 255 where there is an edge pixel that may be used.
  GrayView mask() const { return mask_; }

  Size size() const noexcept { return mask_.size(); }

  template <class Visit>
  void for_each(bool steep, std::int32_t k, std::int32_t from, std::int32_t to,
                const Visit& visit) const noexcept {
    bits_.for_each(steep, k, from, to - from + 1,
                   [&](std::int32_t m) { visit(steep ? m : k, steep ? k : m); });
  }

  refitting::EdgeGradient gradient(std::int32_t x, std::int32_t y) const noexcept {
    const EdgePoint& edge = point(x, y);
    return {static_cast<double>(edge.dx), static_cast<double>(edge.dy)};
  }

  const EdgePoint& point(std::int32_t x, std::int32_t y) const noexcept {
    const auto column = static_cast<unsigned>(x);
    const std::size_t group = static_cast<std::size_t>(y) * groups_in_row_ + column / 8;
    const unsigned before = all_[group] & ((1U << column % 8) - 1);
    return points_[first_of_row_[static_cast<std::size_t>(y)] + first_of_group_[group] + ones_in[before]];
  }

  void collect(const refitting::Corridor& strip, const RefitOptions& options, std::int32_t start,
               std::int32_t direction, refitting::Collected& found) const noexcept;

  void clear(std::int32_t x, std::int32_t y) noexcept {
    mask_.at(x, y) = 0;
    bits_.clear(x, y);
  }

 private:
  static constexpr std::array<std::uint8_t, 256> ones_in = [] {
    std::array<std::uint8_t, 256> ones{};
    for (unsigned v = 0; v < ones.size(); ++v) ones[v] = static_cast<std::uint8_t>(std::popcount(v));
    return ones;
  }();

  void reset(GrayView edges);
  void add_row(std::int32_t y, const std::uint16_t* columns, std::int32_t count);
  void flush();

  Image<std::uint8_t> mask_;
  EdgeBits bits_;
  std::size_t groups_in_row_ = 0;
  std::vector<std::uint8_t> all_;  ///< eight pixels each: a bit for each edge, which stays
  std::vector<std::uint16_t> first_of_group_;
  std::vector<std::uint32_t> first_of_row_;
  std::vector<EdgePoint> points_;
  std::size_t count_ = 0;
  bool own_magnitude_ = false;  ///< that of the field's gradient, by this norm
  GradientNorm norm_ = GradientNorm::l1;
  const PictureRowKernels* kernels_ = &plain_picture_row_kernels;
  std::unique_ptr<EdgeBatch> batch_ = std::make_unique<EdgeBatch>();
};

}  // namespace straightedge
