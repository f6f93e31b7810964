// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "base/kernel_set.hpp"
#include "straightedge/hough_kernels.hpp"

/// What batch_kernels.cpp takes into its table from window_kernels.cpp.
namespace straightedge::STRAIGHTEDGE_KERNEL_SET {

template <class Cell>
std::int32_t cast_in_windows(Cell* cells, const HoughRows& rows, const HoughBatch& batch,
                             const std::uint16_t* firsts, std::int32_t from, std::int32_t threshold,
                             HoughCandidate& seen) noexcept;

template <class Cell>
void take_off_in_windows(Cell* cells, const HoughRows& rows, const HoughBatch& batch,
                         const std::uint16_t* firsts) noexcept;

void first_angles(const std::int16_t* dx, const std::int16_t* dy, std::int32_t count,
                  const HoughWindowRule& rule, std::uint16_t* first) noexcept;

}  // namespace straightedge::STRAIGHTEDGE_KERNEL_SET
