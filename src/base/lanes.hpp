// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <cstring>

#include "base/kernel_set.hpp"

// For loops that keep sixteen partial sums: compilers take these apart into single floats. So many of them
// are worked on at once as the set's registers hold; what one lane does no other sees, so all sets give the
// same bits.
#if defined(__AVX512F__)
#define STRAIGHTEDGE_LANES 16
#elif defined(__AVX2__)
#define STRAIGHTEDGE_LANES 8
#elif defined(__SSE2__) || defined(__ARM_NEON)
#define STRAIGHTEDGE_LANES 4
#else
#define STRAIGHTEDGE_LANES 1
#endif

namespace straightedge::STRAIGHTEDGE_KERNEL_SET {
namespace {

constexpr std::int32_t lanes = STRAIGHTEDGE_LANES;

#if STRAIGHTEDGE_LANES > 1
using Lanes [[gnu::vector_size(STRAIGHTEDGE_LANES * 4)]] = float;
/// What comparing lanes gives.
using Marks [[gnu::vector_size(STRAIGHTEDGE_LANES * 4)]] = std::int32_t;
using Wholes = Marks;

[[maybe_unused]] inline Lanes in_floats(const Wholes& x) noexcept {
  return __builtin_convertvector(x, Lanes);
}
[[maybe_unused]] inline Wholes in_wholes(const Lanes& x) noexcept {
  return __builtin_convertvector(x, Wholes);
}

[[maybe_unused]] inline bool any(const Marks& marks) noexcept {
  std::uint64_t words[STRAIGHTEDGE_LANES / 2], all = 0;
  std::memcpy(words, &marks, sizeof words);
  for (const std::uint64_t word : words) all |= word;
  return all != 0;
}
#else
using Lanes = float;
using Marks = bool;
using Wholes = std::int32_t;

[[maybe_unused]] inline Lanes in_floats(Wholes x) noexcept {
  return static_cast<float>(x);
}
[[maybe_unused]] inline Wholes in_wholes(Lanes x) noexcept {
  return static_cast<Wholes>(x);
}

[[maybe_unused]] inline bool any(Marks mark) noexcept {
  return mark;
}
#endif

[[maybe_unused]] inline Lanes load(const float* from) noexcept {
  Lanes x;
  std::memcpy(&x, from, sizeof x);
  return x;
}

[[maybe_unused]] inline void store(float* to, const Lanes& x) noexcept {
  std::memcpy(to, &x, sizeof x);
}

[[maybe_unused]] inline Lanes all(float x) noexcept {
  return x - Lanes{};
}

/// The next multiple of a power of two.
[[maybe_unused]] inline std::int32_t rounded_up(std::int32_t count, std::int32_t step) noexcept {
  return (count + step - 1) & -step;
}

}  // namespace
}  // namespace straightedge::STRAIGHTEDGE_KERNEL_SET
