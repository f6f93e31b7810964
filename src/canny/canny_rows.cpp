// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "straightedge/canny_rows.hpp"

#include <cstring>

#include "canny/bounded_fill.hpp"
#include "canny/class_bits.hpp"
#include "canny/four_pixels.hpp"

namespace straightedge {
namespace {

// Four classes into eight bits: each byte's two bits move down next to those of the byte before.
std::uint32_t pack_four(const std::uint8_t* classes) noexcept {
  const std::uint32_t word = load_four_bytes(classes);
  const std::uint32_t pairs = word | (word >> 6U);
  return (pairs | (pairs >> 12U)) & 0xFFU;
}

// The bytes beyond the width are none.
void pack_row(std::span<const std::uint8_t> classes, std::uint32_t* words) noexcept {
  const std::uint8_t* const end = classes.data() + classes.size();
  for (const std::uint8_t* next = classes.data(); next != end; next += 16) {
    const std::uint32_t left = pack_four(next) | (pack_four(next + 4) << 8U);
    const std::uint32_t right = pack_four(next + 8) | (pack_four(next + 12) << 8U);
    *words++ = left | (right << 16U);
  }
}

}  // namespace

Status CannyRows::prepare(CannyRows& canny, Size size, const CannyOptions& options,
                          std::span<std::byte> workspace, const CannyRowOptions& rows) noexcept {
  canny.phase_ = Phase::unprepared;
  const Status status = detail::CannyRowRecipe::check(size, options, rows);
  if (status != Status::ok) return status;
  if (rows.kernels == nullptr) return Status::invalid_option;
  if (workspace.data() == nullptr || workspace.size() < workspace_bytes(size, options, rows)) {
    return Status::workspace_too_small;
  }
  Arena arena(workspace);
  canny.memory_ = Memory::take(arena, size, options, rows);
  if (arena.failed()) return Status::workspace_too_small;
  canny.size_ = size;
  canny.options_ = options;
  canny.phase_ = Phase::prepared;
  std::memset(canny.memory_.class_row.data(), no_edge, canny.memory_.class_row.size());
  std::memset(canny.memory_.class_words.data(), no_edge, canny.memory_.class_words.size_bytes());
  detail::CannyRowRecipe::prepare(canny.recipe_, size, options, *rows.kernels, canny.memory_.rows);
  return make_gaussian_kernel(options.sigma, canny.memory_.rows.taps);
}

Status CannyRows::begin() noexcept {
  if (phase_ == Phase::unprepared) return Status::not_prepared;
  recipe_.begin();
  phase_ = Phase::receiving;
  return Status::ok;
}

Status CannyRows::push_row(std::span<const std::uint8_t> gray) noexcept {
  if (phase_ != Phase::receiving) return Status::not_prepared;
  if (gray.data() == nullptr) return Status::invalid_image;
  if (gray.size() != static_cast<std::size_t>(size_.width)) return Status::size_mismatch;
  if (recipe_.rows_in() == size_.height) return Status::size_mismatch;
  const ClassBits classes{memory_.class_words.data(), size_.width};

  // Steps 1 to 5.
  recipe_.push(gray.data());
  const auto whole_words = memory_.class_row.first(16 * detail::class_words_in_row(size_.width));
  while (recipe_.next(memory_.class_row.data())) pack_row(whole_words, classes.row(recipe_.rows_out() - 1));
  return Status::ok;
}

CannyResult CannyRows::finish() noexcept {
  if (phase_ != Phase::receiving) return {Status::not_prepared};
  if (recipe_.rows_in() != size_.height) return {Status::size_mismatch};

  // Step 6.
  const ClassBits classes{memory_.class_words.data(), size_.width};
  const std::uint32_t reached = BoundedFill<ClassBits>::run(classes, size_, memory_.worklist);
  phase_ = Phase::finished;
  return {Status::ok, options_.low, options_.high, recipe_.strong(), recipe_.strong() + reached};
}

Status CannyRows::read_row(std::int32_t y, std::span<std::uint8_t> edges) const noexcept {
  if (phase_ != Phase::finished) return Status::not_prepared;
  if (edges.data() == nullptr) return Status::invalid_image;
  if (edges.size() != static_cast<std::size_t>(size_.width)) return Status::size_mismatch;
  if (y < 0 || y >= size_.height) return Status::size_mismatch;
  const std::uint32_t* const row = ClassBits{memory_.class_words.data(), size_.width}.row(y);
  for (std::int32_t x = 0; x < size_.width; ++x) {
    edges[static_cast<std::size_t>(x)] = ClassBits::get(row, x) == traced_edge ? 255 : 0;
  }
  return Status::ok;
}

bool CannyRows::is_edge(std::int32_t x, std::int32_t y) const noexcept {
  if (phase_ != Phase::finished || x < 0 || y < 0 || x >= size_.width || y >= size_.height) return false;
  return ClassBits::get(ClassBits{memory_.class_words.data(), size_.width}.row(y), x) == traced_edge;
}

}  // namespace straightedge
