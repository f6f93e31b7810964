// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

#include "straightedge/arena.hpp"
#include "straightedge/canny.hpp"
#include "straightedge/canny_row_kernels.hpp"
#include "straightedge/detail/canny_class_plane.hpp"
#include "straightedge/detail/canny_row_memory.hpp"
#include "straightedge/detail/canny_row_recipe.hpp"
#include "straightedge/image.hpp"
#include "straightedge/status.hpp"

/// Canny for a picture that comes row by row, as from a camera, and is never there as a whole: the same edges
/// as `Canny` (canny.hpp), bit for bit.
///
/// Steps, with the numbers that they have in canny.hpp
///   1 to 5. `push_row`: each stage keeps only the rows that the next one still needs. The classes, none,
///      weak or strong, are kept at two bits a pixel.
///   6. `finish`: hysteresis in place. Strong pixels are seeds of a flood fill whose worklist is short. A
///      pixel that is reached while the worklist is full is left marked as a seed, and a further sweep takes
///      it up.
///
/// The result does not depend on the length of the worklist. Papers: canny.hpp.
///
/// Options: `CannyOptions` and `CannyRowOptions`. Automatic thresholds are `invalid_option`: they need the
/// whole picture before its first row can be divided into weak and strong.
///
/// Time: `push_row` is linear in the width, but the last row of a picture brings out as many rows as the blur
/// and the Sobel operator look ahead. `finish` is linear in pixels while the worklist suffices; each time it
/// overflows, some rows are swept once more: at most 1 + edges / worklist sweeps in all, whatever the
/// picture, and each reads the pixels once, four at a time where there is none.
/// Memory: a quarter of a byte a pixel, the rows (10 KB for 320x240 with the default options), 4 bytes for
/// each entry of the worklist: 0.41 bytes a pixel in all at 320x240.
namespace straightedge {

/// `prepare` once for a size and options; then for each picture `begin`, `push_row` for every row, `finish`.
/// The workspace is the caller's and must outlive the object; copies of the object share it.
class CannyRows {
 public:
  /// Bytes that `prepare` needs; 0 when size or options are invalid. Usable in constant expressions.
  static constexpr std::size_t workspace_bytes(Size size, const CannyOptions& options,
                                               const CannyRowOptions& rows = {}) noexcept {
    if (detail::CannyRowRecipe::check(size, options, rows) != Status::ok) return 0;
    Arena arena = Arena::measure();
    Memory::take(arena, size, options, rows);
    return arena.used();
  }

  /// `invalid_image` (size), `invalid_option`, `too_large` (more than 2^30 pixels; on 32-bit machines 2^26)
  /// or `workspace_too_small` leave `canny` unprepared.
  static Status prepare(CannyRows& canny, Size size, const CannyOptions& options,
                        std::span<std::byte> workspace, const CannyRowOptions& rows = {}) noexcept;

  /// A new picture; whatever was there before is given up. `not_prepared` before `prepare`.
  Status begin() noexcept;

  /// The next row from the top, as many pixels as the width. `not_prepared` before `begin` and after
  /// `finish`; `invalid_image` when it is null; `size_mismatch` when it has another width or is one row too
  /// many. After an error the picture goes on as if the call had not been made.
  Status push_row(std::span<const std::uint8_t> gray) noexcept;

  /// All rows are there. `not_prepared` before `begin` and when called twice; `size_mismatch` when rows are
  /// missing: they can still be pushed.
  CannyResult finish() noexcept;

  /// Row y of the edges, 255 and 0; `edges` has as many elements as the width. Between `finish` and the next
  /// `begin`, else `not_prepared`; `invalid_image` when it is null, `size_mismatch` for another length or
  /// when there is no row y. `edges` is untouched after an error.
  Status read_row(std::int32_t y, std::span<std::uint8_t> edges) const noexcept;

  /// Whether pixel (x, y) is an edge. False outside the picture and before `finish`.
  bool is_edge(std::int32_t x, std::int32_t y) const noexcept;

 private:
  enum class Phase : std::uint8_t { unprepared, prepared, receiving, finished };

  struct Memory {
    detail::CannyRowMemory rows;
    std::span<std::uint32_t> worklist;
    std::span<std::uint8_t> class_row;  ///< one byte a pixel, before it is packed
    std::span<std::uint32_t> class_words;

    static constexpr Memory take(Arena& arena, Size size, const CannyOptions& options,
                                 const CannyRowOptions& rows) noexcept {
      const auto width = static_cast<std::size_t>(size.width), height = static_cast<std::size_t>(size.height);
      Memory memory;
      memory.rows = detail::CannyRowMemory::take(arena, size, options);
      memory.worklist = arena.take<std::uint32_t>(std::min<std::size_t>(rows.worklist, width * height));
      memory.class_row = arena.take<std::uint8_t>(
          std::max(16 * detail::class_words_in_row(size.width), detail::in_row_steps(width)));
      memory.class_words = arena.take<std::uint32_t>(detail::class_words_in_all(size));
      return memory;
    }
  };

  Phase phase_ = Phase::unprepared;
  Size size_;
  CannyOptions options_;
  detail::CannyRowRecipe recipe_;
  Memory memory_;
};

}  // namespace straightedge
