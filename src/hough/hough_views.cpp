// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "straightedge/hough_views.hpp"

#include "hough/cells.hpp"
#include "hough/compact_rows.hpp"

namespace straightedge {
namespace {

std::int32_t votes_at(const HoughMemory& memory, std::size_t index) noexcept {
  return hough::with_cells(memory, [=](const auto* cells) noexcept { return std::int32_t{cells[index]}; });
}

std::int32_t votes_in_compact_rows(const HoughMemory& memory, Size picture, std::int32_t distance,
                                   std::int32_t angle) noexcept {
  const auto n = static_cast<std::size_t>(angle);
  const hough::Reach reach = hough::reach(picture, memory.cosines[n], memory.sines[n]);
  if (distance < reach.first || distance > reach.last) return 0;
  return votes_at(memory, hough::cell_index(memory.offsets[n], distance));
}

}  // namespace

std::int32_t HoughVotesView::at(std::int32_t r, std::int32_t n) const noexcept {
  if (method_ == HoughMethod::progressive)
    return votes_in_compact_rows(memory_, picture_, r - (width - 1) / 2, n);
  const bool standard = method_ == HoughMethod::standard;
  const std::ptrdiff_t row = standard ? width + 2 * hough_guard : width;
  const std::ptrdiff_t above = standard ? n + hough_guard : n;
  return votes_at(memory_, static_cast<std::size_t>(above * row + hough_guard + r));
}

bool HoughRemainingView::at(std::int32_t x, std::int32_t y) const noexcept {
  if (method_ == HoughMethod::progressive)
    return PixelStates(memory_.mask.data(), picture_.width).at(x, y) != PixelState::gone;
  return GrayView(memory_.mask.data(), picture_).at(x, y) != 0;
}

}  // namespace straightedge
