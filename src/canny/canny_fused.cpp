// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "straightedge/canny_fused.hpp"

#include <cstring>

#include "canny/bounded_fill.hpp"
#include "canny/class_bytes.hpp"

namespace straightedge {
namespace {

// Step 6, the end: 255 where both bits of the state are set. Four pixels at a time, then the rest.
void keep_traced(std::uint8_t* row, std::int32_t width) noexcept {
  static_assert(traced_edge == 3 && pending_edge < 3 && weak_edge < 3);
  std::int32_t x = 0;
  for (; x + 4 <= width; x += 4) {
    std::uint32_t states = 0;
    std::memcpy(&states, row + x, sizeof states);
    states = (states & (states >> 1U) & 0x01010101U) * 255U;
    std::memcpy(row + x, &states, sizeof states);
  }
  for (; x < width; ++x) row[x] = row[x] == traced_edge ? 255 : 0;
}

}  // namespace

Status FusedCanny::prepare(FusedCanny& canny, Size size, const CannyOptions& options,
                           std::span<std::byte> workspace, const CannyRowOptions& rows) noexcept {
  canny.prepared_ = false;
  const Status status = detail::CannyRowRecipe::check(size, options, rows);
  if (status != Status::ok) return status;
  if (rows.kernels == nullptr) return Status::invalid_option;
  if (workspace.data() == nullptr || workspace.size() < workspace_bytes(size, options, rows)) {
    return Status::workspace_too_small;
  }
  Arena arena(workspace);
  const Memory memory = Memory::take(arena, size, options, rows);
  if (arena.failed()) return Status::workspace_too_small;
  canny.size_ = size;
  canny.options_ = options;
  canny.worklist_ = memory.worklist;
  canny.class_row_ = memory.class_row;
  canny.prepared_ = true;
  detail::CannyRowRecipe::prepare(canny.recipe_, size, options, *rows.kernels, memory.rows);
  return make_gaussian_kernel(options.sigma, memory.rows.taps);
}

CannyResult FusedCanny::run(GrayView gray, ImageView<std::uint8_t> edges) noexcept {
  if (!prepared_) return {};
  if (!gray.valid() || !edges.valid()) return {Status::invalid_image};
  if (gray.size() != size_ || edges.size() != size_) return {Status::size_mismatch};

  // Steps 1 to 5.
  recipe_.begin();
  for (std::int32_t y = 0; y < size_.height; ++y) {
    recipe_.push(gray.row(y));
    while (recipe_.next(class_row_.data())) {
      std::memcpy(edges.row(recipe_.rows_out() - 1), class_row_.data(), static_cast<std::size_t>(size_.width));
    }
  }

  // Step 6.
  const std::uint32_t reached = BoundedFill<ClassBytes>::run({edges}, size_, worklist_);
  for (std::int32_t y = 0; y < size_.height; ++y) keep_traced(edges.row(y), size_.width);
  return {Status::ok, options_.low, options_.high, recipe_.strong(), recipe_.strong() + reached};
}

}  // namespace straightedge
