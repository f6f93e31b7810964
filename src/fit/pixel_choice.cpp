// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "pixel_choice.hpp"

#include <algorithm>
#include <array>

namespace straightedge::detail {
namespace {

constexpr std::int32_t side = DepthChoice::side;
constexpr std::size_t pixels = side * side;

struct Alike {
  std::int32_t chosen = 0;  ///< what all readings chose that chose anything, 0: not the same
  double count = 0;         ///< of them
};

Alike alike(const std::int32_t* chosen) noexcept {
  Alike found;
  bool same = true;
  for (std::size_t i = 0; i < pixels; ++i) {
    if (chosen[i] == 0) continue;
    same = same && (found.chosen == 0 || chosen[i] == found.chosen);
    found.chosen = chosen[i];
    found.count += 1;
  }
  return same ? found : Alike{};
}

}  // namespace

PixelChoice::PixelChoice(const PixelLabeller& work, ImageView<std::uint16_t> labels,
                         std::span<InverseDepthMoments> moments) noexcept
    : work_(work), labels_(labels), moments_(moments), choice_{} {
  const PlaneGate& gate = work.gate;
  // As in PlaneGate::inverse_noise.
  const bool fixed = gate.fixed_m > 0;
  choice_.noise = fixed ? 0.0F : static_cast<float>(gate.inverse_sigma);
  choice_.noise_of_square = static_cast<float>(fixed ? gate.fixed_m / gate.sigmas : gate.floor_m);
  choice_.sigmas = static_cast<float>(gate.sigmas);
}

void PixelChoice::label_cell(std::int32_t x, std::int32_t y) noexcept {
  const int finest = work_.cells.finest();
  const Size size = work_.cells.size(finest);
  const LabelsAround around(size, work_.cell_labels, x, y);
  const std::int32_t cell = DepthCells::side_of(finest), left = x * cell, top = y * cell;
  const auto place =
      static_cast<std::size_t>(y) * static_cast<std::size_t>(size.width) + static_cast<std::size_t>(x);
  const std::size_t* own = cell == side ? &place : nullptr;
  const std::int32_t right = std::min(left + cell, labels_.width),
                     bottom = std::min(top + cell, labels_.height);
  for (std::int32_t j = top; j < bottom; j += side) {
    for (std::int32_t i = left; i < right; i += side) label_square(i, j, around, own);
  }
}

void PixelChoice::look(std::int32_t left, std::int32_t top) noexcept {
  const ImageView<const float>& q = work_.inverse_depth;
  float* out = choice_.around;
  const bool inside = left > 0 && top > 0 && left + side < q.width && top + side < q.height;
  for (std::int32_t y = top - 1; y <= top + side; ++y, out += DepthChoice::stride) {
    if (inside) {
      const float* row = q.row(y) + left - 1;
      for (std::int32_t i = 0; i < side + 2; ++i) out[i] = row[i];
      continue;
    }
    for (std::int32_t i = 0; i < side + 2; ++i) {
      out[i] = q.contains(left - 1 + i, y) ? q.at(left - 1 + i, y) : 0.0F;
    }
  }
}

void PixelChoice::label_square(std::int32_t left, std::int32_t top, const LabelsAround& around,
                               const std::size_t* cell) noexcept {
  look(left, top);
  choice_.planes = static_cast<std::int32_t>(around.count);
  for (std::size_t k = 0; k < around.count; ++k) {
    // Flat over the square.
    const InverseDepthPlane flat =
        work_.planes[around.labels[k] - 1U].tangent(left + side / 2, top + side / 2);
    choice_.at[k] = static_cast<float>(flat.at(left, top));
    choice_.along[k] = static_cast<float>(flat.a);
    choice_.down[k] = static_cast<float>(flat.b);
  }
  std::array<std::int32_t, pixels> chosen;
  work_.kernels.choose(choice_, chosen.data());
  write(left, top, around, chosen.data());
  const Alike all = cell != nullptr ? alike(chosen.data()) : Alike{};
  if (all.chosen != 0 && all.count == static_cast<double>(work_.cells.rows(0, *cell).first[0])) {
    moments_[around.labels[static_cast<std::size_t>(all.chosen) - 1] - 1U].add(work_.cells.moments(0, *cell));
  } else {
    add(left, top, around, chosen.data());
  }
}

void PixelChoice::write(std::int32_t left, std::int32_t top, const LabelsAround& around,
                        const std::int32_t* chosen) const noexcept {
  std::array<std::uint16_t, LabelsAround::most + 1> label{};
  std::copy(around.labels.begin(), around.labels.end(), label.begin() + 1);
  const std::int32_t width = std::min(side, labels_.width - left);
  for (std::int32_t y = 0; y < std::min(side, labels_.height - top); ++y, chosen += side) {
    std::uint16_t* row = labels_.row(top + y) + left;
    for (std::int32_t x = 0; x < width; ++x) row[x] = label[static_cast<std::size_t>(chosen[x])];
  }
}

void PixelChoice::add(std::int32_t left, std::int32_t top, const LabelsAround& around,
                      const std::int32_t* chosen) const noexcept {
  for (std::int32_t y = 0; y < side; ++y) {
    const float* row = choice_.around + (y + 1) * DepthChoice::stride + 1;
    for (std::int32_t x = 0; x < side; ++x) {
      const std::int32_t k = chosen[y * side + x];
      if (k == 0) continue;
      const std::uint16_t label = around.labels[static_cast<std::size_t>(k) - 1];
      moments_[label - 1U].add(left + x, top + y, static_cast<double>(row[x]));
    }
  }
}

}  // namespace straightedge::detail
