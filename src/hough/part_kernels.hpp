// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "base/kernel_set.hpp"
#include "straightedge/hough_kernels.hpp"

/// What batch_kernels.cpp takes into its table from window_kernels.cpp and edge_kernels.cpp.
namespace straightedge::STRAIGHTEDGE_KERNEL_SET {

std::int32_t cast_in_windows(std::uint8_t* cells, const HoughRows& rows, const HoughBatch& batch,
                             const std::uint16_t* firsts, std::int32_t from, std::int32_t threshold,
                             HoughCandidate& seen) noexcept;
void take_off_in_windows(std::uint8_t* cells, const HoughRows& rows, const HoughBatch& batch,
                         const std::uint16_t* firsts) noexcept;
std::int32_t cast_in_windows(std::int16_t* cells, const HoughRows& rows, const HoughBatch& batch,
                             const std::uint16_t* firsts, std::int32_t from, std::int32_t threshold,
                             HoughCandidate& seen) noexcept;
void take_off_in_windows(std::int16_t* cells, const HoughRows& rows, const HoughBatch& batch,
                         const std::uint16_t* firsts) noexcept;

void first_angles(const std::int16_t* dx, const std::int16_t* dy, std::int32_t count,
                  const HoughWindowRule& rule, std::uint16_t* first) noexcept;

void mark_edges(const std::uint8_t* row, std::int32_t width, std::uint8_t* __restrict states) noexcept;

std::int32_t marked_columns(const std::uint8_t* states, std::int32_t width, std::uint16_t* columns) noexcept;

std::int32_t edge_columns(const std::uint8_t* row, std::int32_t width, std::uint16_t* columns) noexcept;

}  // namespace straightedge::STRAIGHTEDGE_KERNEL_SET
