// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "straightedge/canny.hpp"
#include "straightedge/canny_row_kernels.hpp"
#include "straightedge/detail/canny_row_memory.hpp"
#include "straightedge/image.hpp"
#include "straightedge/status.hpp"

namespace straightedge::detail {

/// Canny up to suppression, row by row: gray rows go in, rows of classes come out a few rows later.
///
/// Each row is made from rows of the stage before, as soon as the last of them is there:
///   class row y  ◄  magnitude rows y − 1, y, y + 1   (0 outside)
///   gradient row y  ◄  blurred rows y − r ... y + r, r = aperture / 2   (border replicate)
///   blurred row y  ◄  gray rows y − m ... y + m, m = taps / 2   (border reflect-101)
/// So class row y needs gray rows up to y + m + r + 1, and each stage keeps only the rows that the next one
/// still needs.
class CannyRowRecipe {
 public:
  /// What `prepare` says about size and options, in both forms, which look at the table of kernels too. (Here
  /// it would be no constant expression to compilers that do not trust addresses to be other than null.)
  static constexpr Status check(Size size, const CannyOptions& options,
                                const CannyRowOptions& rows) noexcept {
    const Status status = Canny::check(size, options);
    if (status != Status::ok) return status;
    if (options.thresholds == CannyThresholds::automatic) return Status::invalid_option;
    if (rows.worklist == 0 || rows.stripes < 1) return Status::invalid_option;
    const auto pixels = static_cast<std::uint64_t>(size.width) * static_cast<std::uint64_t>(size.height);
    return pixels > max_row_canny_pixels ? Status::too_large : Status::ok;
  }

  /// `check` has said ok, and `memory` is there.
  static void prepare(CannyRowRecipe& recipe, Size size, const CannyOptions& options,
                      const CannyRowKernels& kernels, const CannyRowMemory& memory) noexcept;

  /// A new picture.
  void begin() noexcept;

  /// The next row of the picture; `next` has been called until it gave nothing.
  void push(const std::uint8_t* gray) noexcept;

  /// Writes the next row of classes; false when it needs further rows of the picture, or all were given.
  bool next(std::uint8_t* classes) noexcept;

  /// Makes the next row of the gradient, where nobody wants classes: in place of `next`, for a whole picture.
  bool next_gradient() noexcept { return gradient_rows_ < size_.height && make_gradient_row(); }

  /// The same where nobody wants more than the blurred picture.
  bool next_blurred() noexcept { return blurred_rows_ < size_.height && make_blurred_row(); }

  std::int32_t rows_in() const noexcept { return gray_rows_; }
  std::int32_t rows_out() const noexcept { return class_rows_; }
  std::uint32_t strong() const noexcept { return strong_; }

 private:
  void finish_blurred_row(std::uint8_t* row) noexcept;
  bool make_blurred_row() noexcept;
  bool make_gradient_row() noexcept;
  void clear_magnitude(std::int32_t y) noexcept;

  Size size_;
  CannyOptions options_;
  MagnitudeThresholds limits_;
  const CannyRowKernels* kernels_ = nullptr;
  CannyRowMemory memory_;
  // How many rows of each kind there were: also the index of the next one.
  std::int32_t gray_rows_ = 0;
  std::int32_t blurred_rows_ = 0;
  std::int32_t gradient_rows_ = 0;
  std::int32_t class_rows_ = 0;
  std::uint32_t strong_ = 0;
};

}  // namespace straightedge::detail
