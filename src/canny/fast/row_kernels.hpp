// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include "straightedge/canny_row_kernels.hpp"

// The row functions of one instruction set; canny_row_kernels.hpp says what each does. Not the plain ones'
// header under another name: those have gradients of all three sides, as templates.
namespace straightedge::STRAIGHTEDGE_KERNEL_SET {

void blur_down(const std::uint8_t* const* rows, const std::uint16_t* taps, std::int32_t tap_count,
               std::uint16_t* sums, std::int32_t width) noexcept;
void blur_along(const std::uint16_t* sums, const std::uint16_t* taps, std::int32_t tap_count,
                std::uint8_t* blurred, std::int32_t width) noexcept;
void gradient_l1_of_3(const std::uint8_t* const* rows, std::int16_t* scratch, std::int16_t* dx,
                      std::int16_t* dy, std::uint16_t* magnitude, std::int32_t width) noexcept;
void gradient_l2_of_3(const std::uint8_t* const* rows, std::int16_t* scratch, std::int16_t* dx,
                      std::int16_t* dy, std::uint32_t* magnitude, std::int32_t width) noexcept;
std::uint32_t suppress_l1(const MagnitudeRows<std::uint16_t>& rows, MagnitudeThresholds limits,
                          std::uint8_t* classes, std::int32_t width) noexcept;
std::uint32_t suppress_l2(const MagnitudeRows<std::uint32_t>& rows, MagnitudeThresholds limits,
                          std::uint8_t* classes, std::int32_t width) noexcept;
void pack_classes(const std::uint8_t* classes, std::uint8_t* words, std::int32_t width) noexcept;
std::uint32_t spread_edges(const std::uint8_t* words, std::uint8_t* edges, std::int32_t width) noexcept;

}  // namespace straightedge::STRAIGHTEDGE_KERNEL_SET
