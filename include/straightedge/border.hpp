// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace straightedge {

/// What a filter sees outside the image. The picture shows the row `abcd`.
enum class Border : std::uint8_t {
  constant,     ///< 0000|abcd|0000
  replicate,    ///< aaaa|abcd|dddd
  reflect,      ///< dcba|abcd|dcba
  reflect_101,  ///< .dcb|abcd|cba.  (the outermost pixel is the mirror)
};

/// Stands for a pixel outside that is 0.
inline constexpr std::int32_t border_zero = -1;

/// The index inside [0, n) whose value stands at index i, or `border_zero`. Reflections repeat as often
/// as needed, so a filter may be larger than the image. n >= 1.
constexpr std::int32_t border_index(std::int32_t i, std::int32_t n, Border border) noexcept {
  if (i >= 0 && i < n) return i;
  switch (border) {
    case Border::replicate:
      return i < 0 ? 0 : n - 1;
    case Border::reflect: {
      const std::int64_t period = 2 * std::int64_t{n};
      const std::int64_t phase = (i % period + period) % period;
      return static_cast<std::int32_t>(phase < n ? phase : period - 1 - phase);
    }
    case Border::reflect_101: {
      if (n == 1) return 0;
      // Most are one reflection away, and 64-bit remainders are slow on small processors.
      if (i < 0 && i > -n) return -i;
      if (i >= n && i - n < n - 1) return n - 2 - (i - n);
      const std::int64_t period = 2 * std::int64_t{n} - 2;
      const std::int64_t phase = (i % period + period) % period;
      return static_cast<std::int32_t>(phase < n ? phase : period - phase);
    }
    case Border::constant:
      break;
  }
  return border_zero;
}

constexpr bool is_border(Border border) noexcept {
  return border <= Border::reflect_101;
}

}  // namespace straightedge
