// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "straightedge/segment_refit.hpp"

#include "hough/refit_recipe.hpp"

namespace straightedge {
namespace {

/// The pixels of a mask that are not 0. `Byte` is const where none is cleared.
template <class Byte>
class MaskEdges {
 public:
  MaskEdges(ImageView<Byte> mask, const GradientField& field) noexcept : mask_(mask), field_(field) {}

  Size size() const noexcept { return mask_.size(); }

  template <class Visit>
  void for_each(bool steep, std::int32_t k, std::int32_t from, std::int32_t to,
                const Visit& visit) const noexcept {
    const std::ptrdiff_t stride = steep ? 1 : mask_.stride;
    const std::uint8_t* pixel = steep ? mask_.row(k) + from : mask_.row(from) + k;
    for (std::int32_t m = from; m <= to; ++m, pixel += stride)
      if (*pixel != 0) visit(steep ? m : k, steep ? k : m);
  }

  refitting::EdgeGradient gradient(std::int32_t x, std::int32_t y) const noexcept {
    return {static_cast<double>(field_.x.at(x, y)), static_cast<double>(field_.y.at(x, y))};
  }
  EdgePoint point(std::int32_t x, std::int32_t y) const noexcept { return edge_point(field_, x, y); }
  void collect(const refitting::Corridor& strip, const RefitOptions& options, std::int32_t start,
               std::int32_t direction, refitting::Collected& found) const noexcept {
    refitting::collect_each(*this, strip, options, start, direction, found);
  }
  void clear(std::int32_t x, std::int32_t y) noexcept { mask_.at(x, y) = 0; }

 private:
  ImageView<Byte> mask_;
  const GradientField& field_;
};

}  // namespace

Status refit_segment(GrayView mask, const GradientField& field, const HoughSegment& rough,
                     const RefitOptions& options, RefinedSegment& refined) noexcept {
  refined = {};
  if (!refitting::valid(options)) return Status::invalid_option;
  if (!mask.valid() || !field.valid()) return Status::invalid_image;
  if (mask.size() != field.x.size()) return Status::size_mismatch;
  return refitting::refit(MaskEdges(mask, field), rough, options, refined);
}

std::uint32_t claim_pixels(ImageView<std::uint8_t> mask, const GradientField& field,
                           const RefinedSegment& segment, double corridor, double max_angle,
                           double margin) noexcept {
  if (!mask.valid() || !field.valid() || mask.size() != field.x.size()) return 0;
  MaskEdges edges(mask, field);
  return refitting::claim(edges, segment, corridor, max_angle, margin);
}

}  // namespace straightedge
