// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "straightedge/canny_fused.hpp"

#include <cstddef>
#include <cstring>

#include "canny/edge_words.hpp"
#include "canny/word_fill.hpp"
#include "straightedge/suppress.hpp"

namespace straightedge {

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
  canny.kernels_ = rows.kernels;
  canny.memory_ = memory;
  canny.prepared_ = true;
  std::memset(memory.class_row.data(), no_edge, memory.class_row.size());
  detail::CannyRowRecipe::prepare(canny.recipe_, size, options, *rows.kernels, memory.rows);
  return make_gaussian_kernel(options.sigma, memory.rows.taps);
}

CannyResult FusedCanny::run(GrayView gray, ImageView<std::uint8_t> edges) noexcept {
  if (!prepared_) return {};
  if (!gray.valid() || !edges.valid()) return {Status::invalid_image};
  if (gray.size() != size_ || edges.size() != size_) return {Status::size_mismatch};

  // Row y of the picture has been read when row y of the edges is written, so the two may be one.
  const std::span<std::uint8_t> own = memory_.narrow_words;
  const bool narrow = !own.empty();
  const EdgeWords words{narrow ? own.data() : edges.row(0),
                        narrow ? static_cast<std::ptrdiff_t>(EdgeWord::bytes) : edges.stride,
                        (size_.width + 63) / 64, size_.height};

  // Steps 1 to 5, and 6 for each row whose neighbours are there.
  WordFill fill(words, memory_.worklist);
  recipe_.begin();
  for (std::int32_t y = 0; y < size_.height; ++y) {
    recipe_.push(gray.row(y));
    while (recipe_.next(memory_.class_row.data())) {
      const std::int32_t row = recipe_.rows_out() - 1;
      kernels_->pack_classes(memory_.class_row.data(), words.row(row), size_.width);
      if (row > 0) fill.flow_down(row - 1);
    }
  }
  fill.flow_down(size_.height - 1);
  fill.finish();
  std::uint32_t count = 0;
  for (std::int32_t y = 0; y < size_.height; ++y) {
    count += kernels_->spread_edges(words.row(y), edges.row(y), size_.width);
  }
  return {Status::ok, options_.low, options_.high, recipe_.strong(), count};
}

}  // namespace straightedge
