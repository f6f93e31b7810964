// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

// Rows of a large picture are not in the cache. The rows of all stages are read and written in turns, in
// which a processor hardly sees which row of the picture is next, so it is told some rows before. Changes
// nothing but the time.
namespace straightedge {

inline constexpr std::int32_t cache_line_bytes = 64;

/// Even the shortest work on a row of a large picture, times this, takes longer than memory.
inline constexpr std::int32_t fetched_rows_ahead = 4;

inline void fetch_to_read(const std::uint8_t* row, std::int32_t bytes) noexcept {
  for (std::int32_t i = 0; i < bytes; i += cache_line_bytes) __builtin_prefetch(row + i);
}

inline void fetch_to_write(std::uint8_t* row, std::int32_t bytes) noexcept {
  for (std::int32_t i = 0; i < bytes; i += cache_line_bytes) __builtin_prefetch(row + i, 1);
}

}  // namespace straightedge
