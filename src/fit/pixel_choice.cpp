// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "pixel_choice.hpp"

#include <algorithm>
#include <array>

#include "four_labels.hpp"

namespace straightedge::detail {
namespace {

/// How many of the pixels have a label.
std::int32_t count_of(std::uint16_t label,
                      const std::array<std::uint16_t, DepthChoice::pixels>& chosen) noexcept {
  std::uint64_t others = 0;  // four counts
  for (std::size_t i = 0; i < chosen.size(); i += 4) {
    others += not_zero(four(&chosen[i]) ^ label * four_ones) >> 15U;
  }
  return DepthChoice::pixels - static_cast<std::int32_t>(others * four_ones >> 48U);
}

}  // namespace

PixelChoice::PixelChoice(const PixelLabeller& work, ImageView<std::uint16_t> labels,
                         std::span<InverseDepthMoments> moments) noexcept
    : work_(work), labels_(labels), moments_(moments), choice_{}, flat_{}, at_border_{} {
  const PlaneGate& gate = work.gate;
  // As in PlaneGate::inverse_noise.
  const bool fixed = gate.fixed_m > 0;
  choice_.noise = fixed ? 0.0F : static_cast<float>(gate.inverse_sigma);
  choice_.noise_of_square = static_cast<float>(fixed ? gate.fixed_m / gate.sigmas : gate.floor_m);
  choice_.sigmas = static_cast<float>(gate.sigmas);
}

void PixelChoice::label_cell(std::int32_t x, std::int32_t y, const LabelsAround& around) noexcept {
  const std::int32_t cell = DepthCells::side_of(work_.cells.finest()), left = x * cell, top = y * cell;
  const std::int32_t right = std::min(left + cell, labels_.width),
                     bottom = std::min(top + cell, labels_.height);
  choice_.planes = static_cast<std::int32_t>(around.count);
  for (std::size_t k = 0; k < around.count; ++k) {
    // Flat over the cell.
    flat_[k] = work_.planes[around.labels[k] - 1U].tangent(left + cell / 2, top + cell / 2);
    choice_.along[k] = static_cast<float>(flat_[k].a);
    choice_.down[k] = static_cast<float>(flat_[k].b);
    choice_.label[k] = around.labels[k];
  }
  for (std::int32_t j = top; j < bottom; j += side) {
    for (std::int32_t i = left; i < right; i += side) label_square(i, j);
  }
}

DepthRows PixelChoice::look(std::int32_t left, std::int32_t top) noexcept {
  const ImageView<const float>& q = work_.inverse_depth;
  if (left > 0 && top > 0 && left + side < q.width && top + side < q.height) {
    return {q.row(top - 1) + left - 1, elements_apart(q)};
  }
  float* out = at_border_.data();
  for (std::int32_t y = top - 1; y <= top + side; ++y) {
    for (std::int32_t x = left - 1; x <= left + side; ++x) *out++ = q.contains(x, y) ? q.at(x, y) : 0.0F;
  }
  return {at_border_.data(), side_around};
}

void PixelChoice::label_square(std::int32_t left, std::int32_t top) noexcept {
  choice_.around = look(left, top);
  const auto planes = static_cast<std::size_t>(choice_.planes);
  for (std::size_t k = 0; k < planes; ++k) choice_.at[k] = static_cast<float>(flat_[k].at(left, top));
  std::array<std::uint16_t, DepthChoice::pixels> chosen;
  work_.kernels.choose(choice_, chosen.data());
  write(left, top, chosen.data());
  for (std::size_t k = 0; k < planes; ++k) {
    const std::uint16_t label = choice_.label[k];
    moments_[label - 1U].n += count_of(label, chosen);
  }
}

void PixelChoice::write(std::int32_t left, std::int32_t top, const std::uint16_t* chosen) const noexcept {
  if (left + side <= labels_.width && top + side <= labels_.height) {
    for (std::int32_t y = 0; y < side; ++y, chosen += side)
      std::copy(chosen, chosen + side, labels_.row(top + y) + left);
    return;
  }
  const std::int32_t width = std::min(side, labels_.width - left);
  for (std::int32_t y = 0; y < std::min(side, labels_.height - top); ++y, chosen += side) {
    std::copy(chosen, chosen + width, labels_.row(top + y) + left);
  }
}

}  // namespace straightedge::detail
