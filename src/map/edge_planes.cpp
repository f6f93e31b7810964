// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "map/edge_planes.hpp"

#include <algorithm>
#include <vector>

#include "canny/fetch_row.hpp"
#include "canny/word_fill.hpp"
#include "straightedge/arena.hpp"
#include "straightedge/detail/canny_row_memory.hpp"
#include "straightedge/detail/canny_row_recipe.hpp"
#include "straightedge/suppress.hpp"

namespace straightedge {
namespace {

constexpr std::uint32_t worklist = 1U << 14U;
constexpr std::int32_t word = 64;

struct RowMemory {
  detail::CannyRowMemory rows;
  std::span<std::uint32_t> worklist;
  std::span<std::uint8_t> classes;  ///< of one row
  std::span<std::uint8_t> words;

  /// Rings as long as the picture is high keep every row.
  static RowMemory take(Arena& arena, Size size, const CannyOptions& options, Kept kept) {
    const auto words = static_cast<std::size_t>((size.width + word - 1) / word);
    RowMemory memory;
    memory.rows = detail::CannyRowMemory::take(arena, size, options);
    detail::RowRing<std::uint8_t>& blurred = memory.rows.blurred;
    blurred = detail::RowRing<std::uint8_t>::take(arena, size.height + 2, size.width, options.aperture / 2);
    // The rim's upper row lies before the first one, the lower one behind the last.
    blurred.elements = blurred.elements.subspan(std::min(blurred.stride, blurred.elements.size()));
    blurred.slots = size.height;
    if (kept == Kept::gradient) {
      memory.rows.dx = detail::RowRing<std::int16_t>::take(arena, size.height, size.width, 0);
      memory.rows.dy = detail::RowRing<std::int16_t>::take(arena, size.height, size.width, 0);
    }
    memory.worklist = arena.take<std::uint32_t>(straightedge::worklist);
    memory.classes = arena.take<std::uint8_t>(words * word);
    memory.words = arena.take<std::uint8_t>(words * EdgeWord::bytes * static_cast<std::size_t>(size.height));
    return memory;
  }
};

template <class T>
void fetch_row(const detail::RowRing<T>& ring, std::int32_t y) {
  fetch_to_write(reinterpret_cast<std::uint8_t*>(ring.row(y)),
                 static_cast<std::int32_t>(ring.stride * sizeof(T)));
}

void fetch_kept(const detail::CannyRowMemory& rows, Kept kept, std::int32_t y) {
  fetch_row(rows.blurred, y);
  if (kept == Kept::blurred) return;
  fetch_row(rows.dx, y);
  fetch_row(rows.dy, y);
}

template <class T>
ImageView<const T> all_rows(const detail::RowRing<T>& ring, Size size) {
  return {ring.row(0), size, static_cast<std::ptrdiff_t>(ring.stride * sizeof(T))};
}

/// What Sobel's operator takes for the rows beyond the picture; columns have theirs.
void copy_rim(const detail::RowRing<std::uint8_t>& blurred, Size size) {
  std::uint8_t *first = blurred.row(0) - blurred.margin,
               *last = blurred.row(size.height - 1) - blurred.margin;
  const std::size_t bytes = static_cast<std::size_t>(size.width) + 2 * blurred.margin;
  std::copy_n(first, bytes, first - blurred.stride);
  std::copy_n(last, bytes, last + blurred.stride);
}

/// std::popcount calls a function where a processor may lack the instruction.
std::uint32_t bits_in(std::uint64_t x) {
  x -= x >> 1U & 0x5555555555555555U;
  x = (x & 0x3333333333333333U) + (x >> 2U & 0x3333333333333333U);
  x = (x + (x >> 4U)) & 0x0F0F0F0F0F0F0F0FU;
  return static_cast<std::uint32_t>(x * 0x0101010101010101U >> 56U);
}

std::uint32_t count_edges(const EdgeWords& words) {
  std::uint32_t count = 0;
  for (std::int32_t y = 0; y < words.height; ++y)
    for (std::int32_t i = 0; i < words.words; ++i)
      if (const std::uint64_t edges = EdgeWord::load(words.at(i, y)).edges; edges != 0)
        count += bits_in(edges);
  return count;
}

}  // namespace

Status EdgePlanes::detect(GrayView gray, const CannyOptions& options, const KernelSet& kernels, Kept kept,
                          Wanted wanted) {
  const Status valid = Canny::check(gray.size(), options);
  if (valid != Status::ok) return valid;
  const CannyRowOptions rows{.kernels = kernels.canny_rows};
  const bool may = detail::CannyRowRecipe::check(gray.size(), options, rows) == Status::ok;
  if (!may) return by_stages(gray, options);
  if (options.aperture != 3) kept = Kept::gradient;  // single ones are made with side 3 alone
  return by_rows(gray, options, *kernels.canny_rows, kept, wanted);
}

void EdgePlanes::reserve(std::size_t bytes) {
  if (bytes <= bytes_) return;
  memory_ = std::make_unique_for_overwrite<std::byte[]>(bytes);
  bytes_ = bytes;
}

Status EdgePlanes::by_rows(GrayView gray, const CannyOptions& options, const CannyRowKernels& kernels,
                           Kept kept, Wanted wanted) {
  const Size size = gray.size();
  Arena measure = Arena::measure();
  RowMemory::take(measure, size, options, kept);
  reserve(measure.used());
  Arena arena({memory_.get(), bytes_});
  const RowMemory memory = RowMemory::take(arena, size, options, kept);
  const Status made = make_gaussian_kernel(options.sigma, memory.rows.taps);
  if (made != Status::ok) return made;
  detail::CannyRowRecipe recipe;
  detail::CannyRowRecipe::prepare(recipe, size, options, kernels, memory.rows);
  std::fill(memory.classes.begin(), memory.classes.end(), no_edge);

  const std::int32_t words_in_row = (size.width + word - 1) / word;
  const EdgeWords words{memory.words.data(), words_in_row * static_cast<std::ptrdiff_t>(EdgeWord::bytes),
                        words_in_row, size.height};
  WordFill fill(words, memory.worklist);
  recipe.begin();
  for (std::int32_t y = 0; y < size.height; ++y) {
    if (const std::int32_t soon = y + fetched_rows_ahead; soon < size.height) {
      fetch_to_read(gray.row(soon), size.width);
      fetch_kept(memory.rows, kept, soon);
    }
    recipe.push(gray.row(y));
    if (wanted == Wanted::no_edges) {
      while (kept == Kept::gradient ? recipe.next_gradient() : recipe.next_blurred()) {
      }
      continue;
    }
    while (recipe.next(memory.classes.data())) {
      const std::int32_t row = recipe.rows_out() - 1;
      kernels.pack_classes(memory.classes.data(), words.row(row), size.width);
      if (row > 0) fill.flow_down(row - 1);
    }
  }
  words_ = {};
  if (wanted == Wanted::edges) {
    fill.flow_down(size.height - 1);
    fill.sweep_up(0, size.height);
    words_ = words;
  }
  kernels_ = &kernels;
  blurred = all_rows(memory.rows.blurred, size);
  dx = dy = {};
  if (kept == Kept::gradient) {
    dx = all_rows(memory.rows.dx, size);
    dy = all_rows(memory.rows.dy, size);
  } else {
    copy_rim(memory.rows.blurred, size);
  }
  result = {Status::ok, options.low, options.high, recipe.strong(), count_edges(words_)};
  return Status::ok;
}

Status EdgePlanes::by_stages(GrayView gray, const CannyOptions& options) {
  words_ = {};
  const std::size_t bytes = Canny::workspace_bytes(gray.size(), options);
  reserve(bytes);
  Canny canny;
  const Status prepared = Canny::prepare(canny, gray.size(), options, {memory_.get(), bytes_});
  if (prepared != Status::ok) return prepared;
  if (pixels_.size() != gray.size()) pixels_ = Image<std::uint8_t>(gray.size());
  result = canny.run(gray, pixels_.view());
  blurred = canny.blurred();
  dx = canny.gradient_x();
  dy = canny.gradient_y();
  return result.status;
}

GradientSource EdgePlanes::gradients() const {
  return dx.data != nullptr ? GradientSource(GradientField{dx, dy, {}}) : GradientSource(blurred);
}

void EdgePlanes::to_bits(EdgeBits& bits) const {
  bits.reset(blurred.size());
  for (std::int32_t y = 0; y < words_.height; ++y) {
    for (std::int32_t i = 0; i < words_.words; ++i) {
      const std::uint64_t edges = EdgeWord::load(words_.at(i, y)).edges;
      if (edges != 0) bits.set_word(i, y, edges);
    }
  }
  if (words_.first != nullptr) return;
  for (std::int32_t y = 0; y < pixels_.height(); ++y)
    for (std::int32_t x = 0; x < pixels_.width(); ++x)
      if (pixels_.at(x, y) != 0) bits.set(x, y);
}

GrayView EdgePlanes::to_pixels() {
  if (words_.first == nullptr) return pixels_;
  if (pixels_.size() != blurred.size()) pixels_ = Image<std::uint8_t>::for_overwrite(blurred.size());
  for (std::int32_t y = 0; y < blurred.height; ++y)
    kernels_->spread_edges(words_.row(y), pixels_.view().row(y), blurred.width);
  return pixels_;
}

}  // namespace straightedge
