// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "straightedge/canny_fused.hpp"

#include <cstddef>
#include <cstring>

#include "canny/edge_words.hpp"
#include "canny/fetch_row.hpp"
#include "canny/word_fill.hpp"
#include "straightedge/suppress.hpp"

namespace straightedge {
namespace {

/// The bits of all rows: in the rows of `edges`, unless those are too narrow.
EdgeWords words_in(ImageView<std::uint8_t> edges, std::span<std::uint8_t> narrow_words) noexcept {
  const bool narrow = !narrow_words.empty();
  return {narrow ? narrow_words.data() : edges.row(0),
          narrow ? static_cast<std::ptrdiff_t>(EdgeWord::bytes) : edges.stride, (edges.width + 63) / 64,
          edges.height};
}

/// Of the memory between the first pixel and the last.
template <class A, class B>
bool overlap(const ImageView<A>& a, const ImageView<B>& b) noexcept {
  const auto first_a = reinterpret_cast<std::uintptr_t>(a.row(0)),
             first_b = reinterpret_cast<std::uintptr_t>(b.row(0));
  const auto end_a = reinterpret_cast<std::uintptr_t>(a.row(a.height - 1) + a.width);
  const auto end_b = reinterpret_cast<std::uintptr_t>(b.row(b.height - 1) + b.width);
  return first_a < end_b && first_b < end_a;
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
  canny.kernels_ = rows.kernels;
  canny.memory_ = memory;
  canny.prepared_ = true;
  for (detail::CannyStripe& stripe : memory.stripes) {
    std::memset(stripe.class_row.data(), no_edge, stripe.class_row.size());
    const Size own{size.width, stripe.end_read - stripe.first_read};
    detail::CannyRowRecipe::prepare(stripe.recipe, own, options, *rows.kernels, stripe.rows);
    const Status made = make_gaussian_kernel(options.sigma, stripe.rows.taps);
    if (made != Status::ok) return made;
  }
  return Status::ok;
}

Status FusedCanny::check(GrayView gray, ImageView<std::uint8_t> edges) const noexcept {
  if (!prepared_) return Status::not_prepared;
  if (!gray.valid() || !edges.valid()) return Status::invalid_image;
  if (gray.size() != size_ || edges.size() != size_) return Status::size_mismatch;
  return memory_.stripes.size() > 1 && overlap(gray, edges) ? Status::invalid_image : Status::ok;
}

// Row y of the picture has been read when row y of the edges is written, so the two may be one.
void FusedCanny::mark(std::int32_t index, GrayView gray, ImageView<std::uint8_t> edges) noexcept {
  detail::CannyStripe& stripe = memory_.stripes[static_cast<std::size_t>(index)];
  const EdgeWords words = words_in(edges, memory_.narrow_words).rows(stripe.begin, stripe.end);
  WordFill fill(words, stripe.worklist);
  stripe.strong = 0;
  stripe.recipe.begin();
  for (std::int32_t y = stripe.first_read; y < stripe.end_read; ++y) {
    if (y + fetched_rows_ahead < stripe.end_read) fetch_to_read(gray.row(y + fetched_rows_ahead), gray.width);
    stripe.recipe.push(gray.row(y));
    for (std::uint32_t before = stripe.recipe.strong(); stripe.recipe.next(stripe.class_row.data());
         before = stripe.recipe.strong()) {
      const std::int32_t row = stripe.first_read + stripe.recipe.rows_out() - 1 - stripe.begin;
      if (row < 0 || row >= words.height) continue;
      stripe.strong += stripe.recipe.strong() - before;
      if (row + fetched_rows_ahead < words.height)
        fetch_to_write(words.row(row + fetched_rows_ahead), words.row_bytes());
      kernels_->pack_classes(stripe.class_row.data(), words.row(row), size_.width);
      if (row > 0) fill.flow_down(row - 1);
    }
  }
  fill.flow_down(words.height - 1);
  fill.sweep_up(0, words.height);
}

void FusedCanny::join(ImageView<std::uint8_t> edges) noexcept {
  WordFill fill(words_in(edges, memory_.narrow_words), memory_.stripes[0].worklist);
  for (const detail::CannyStripe& stripe : memory_.stripes.subspan(1))
    fill.sweep_up(stripe.begin - 1, stripe.begin + 1);
}

void FusedCanny::spread(std::int32_t index, ImageView<std::uint8_t> edges) noexcept {
  detail::CannyStripe& stripe = memory_.stripes[static_cast<std::size_t>(index)];
  const EdgeWords words = words_in(edges, memory_.narrow_words);
  stripe.edges = 0;
  for (std::int32_t y = stripe.begin; y < stripe.end; ++y) {
    if (y + fetched_rows_ahead < stripe.end) fetch_to_write(edges.row(y + fetched_rows_ahead), edges.width);
    stripe.edges += kernels_->spread_edges(words.row(y), edges.row(y), size_.width);
  }
}

CannyResult FusedCanny::result() const noexcept {
  CannyResult result{Status::ok, options_.low, options_.high, 0, 0};
  for (const detail::CannyStripe& stripe : memory_.stripes) {
    result.strong += stripe.strong;
    result.edges += stripe.edges;
  }
  return result;
}

}  // namespace straightedge
