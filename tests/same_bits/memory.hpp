// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>

/// Boards have a large memory apart, which is not cleared at reset.
#if defined(__ARM_ARCH_PROFILE) && __ARM_ARCH_PROFILE == 'M'
#define SAME_BITS_LARGE [[gnu::section(".big")]]
#else
#define SAME_BITS_LARGE
#endif

namespace same_bits {

/// The memory that all cases work in, one after another; each states by static_assert that it suffices.
inline constexpr std::size_t most_workspace = std::size_t{5} << 19U;

/// All of it, full of bytes that are others on a machine of 32 bits than on one of 64: a result that depends
/// on what nobody wrote differs.
std::span<std::byte> workspace() noexcept;

}  // namespace same_bits
