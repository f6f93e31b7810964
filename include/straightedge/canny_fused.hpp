// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "straightedge/arena.hpp"
#include "straightedge/canny.hpp"
#include "straightedge/canny_row_kernels.hpp"
#include "straightedge/detail/canny_row_recipe.hpp"
#include "straightedge/detail/canny_stripe.hpp"
#include "straightedge/image.hpp"
#include "straightedge/status.hpp"

/// Canny for a whole picture in little memory: the same edges as `Canny` (canny.hpp), bit for bit, without
/// its intermediate pictures.
///
/// Steps, with the numbers that they have in canny.hpp
///   1 to 5. Row by row: each stage keeps only the rows that the next one still needs. The classes, none,
///      weak or strong, are written into `edges`, as bits: 64 pixels in 16 bytes.
///   6. Hysteresis in place, 64 pixels at a time. Edges grow along weak pixels down the picture while its
///      rows are made, then in a sweep up, and from where that has passed already with a short worklist. What
///      can grow while the list is full is found again by a further sweep. Last, the bits become 255 and 0.
/// In stripes, each is worked on as a picture of its own with some rows more on both sides; then edges grow
/// across the seams.
///
/// The result does not depend on the length of the worklist. Papers: canny.hpp.
///
/// Options: `CannyOptions` and `CannyRowOptions`. Automatic thresholds are `invalid_option`: they need the
/// magnitudes of the whole picture before the first pixel can be divided into weak and strong.
///
/// Time linear in pixels while the worklist suffices. Each time it overflows, some rows are swept once more:
/// at most 1 + 8 edges / worklist sweeps in all, whatever the picture, and each reads every pixel's bits
/// once. Memory: the rows (10 KB for 320x240 with the default options), 4 bytes for each entry of the
/// worklist, nothing that grows with the pixels. (Where 16 bytes do not fit into a row of `edges`, in
/// pictures less than 16 wide, the bits take 16 bytes a row besides.)
namespace straightedge {

/// `prepare` once for a size and options, `run` many times. The workspace is the caller's and must outlive
/// the object; copies of the object share it, so only one of them may run at a time.
class FusedCanny {
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
  static Status prepare(FusedCanny& canny, Size size, const CannyOptions& options,
                        std::span<std::byte> workspace, const CannyRowOptions& rows = {}) noexcept;

  /// `edges`: 255 on edges, 0 elsewhere; it may be the very view of `gray`. Both views have the prepared
  /// size. Errors, with `edges` untouched: `not_prepared`, `invalid_image`, `size_mismatch`.
  CannyResult run(GrayView gray, ImageView<std::uint8_t> edges) noexcept {
    return run_with(gray, edges, [](std::int32_t count, auto work) {
      for (std::int32_t i = 0; i < count; ++i) work(i);
    });
  }

  /// The same with stripes at the same time: `for_each(count, work)` calls work(i) for every i below count,
  /// in any order, on any threads, and comes back when all calls have. With more than one stripe `edges` must
  /// not overlap `gray`: `invalid_image`.
  template <class ForEach>
  CannyResult run_with(GrayView gray, ImageView<std::uint8_t> edges, ForEach for_each) noexcept {
    const Status status = check(gray, edges);
    if (status != Status::ok) return {status};
    const auto count = static_cast<std::int32_t>(memory_.stripes.size());
    for_each(count, [&](std::int32_t i) { mark(i, gray, edges); });
    join(edges);
    for_each(count, [&](std::int32_t i) { spread(i, edges); });
    return result();
  }

 private:
  struct Memory {
    std::span<detail::CannyStripe> stripes;
    std::span<std::uint8_t> narrow_words;  ///< for rows too narrow to hold their bits

    static constexpr Memory take(Arena& arena, Size size, const CannyOptions& options,
                                 const CannyRowOptions& rows) noexcept {
      Memory memory;
      const std::int32_t count = detail::CannyStripe::count(size, rows);
      memory.stripes = arena.take<detail::CannyStripe>(static_cast<std::size_t>(count));
      for (std::int32_t i = 0; i < count; ++i) {
        const detail::CannyStripe stripe = detail::CannyStripe::take(arena, size, options, rows, i);
        if (!memory.stripes.empty()) memory.stripes[static_cast<std::size_t>(i)] = stripe;
      }
      if (size.width < 16)
        memory.narrow_words = arena.take<std::uint8_t>(16 * static_cast<std::size_t>(size.height));
      return memory;
    }
  };

  Status check(GrayView gray, ImageView<std::uint8_t> edges) const noexcept;
  /// Steps 1 to 5 of a stripe, and step 6 inside of it.
  void mark(std::int32_t index, GrayView gray, ImageView<std::uint8_t> edges) noexcept;
  /// Step 6 across the seams.
  void join(ImageView<std::uint8_t> edges) noexcept;
  /// The end of step 6.
  void spread(std::int32_t index, ImageView<std::uint8_t> edges) noexcept;
  CannyResult result() const noexcept;

  bool prepared_ = false;
  Size size_;
  CannyOptions options_;
  const CannyRowKernels* kernels_ = nullptr;
  Memory memory_;
};

}  // namespace straightedge
