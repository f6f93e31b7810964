// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "straightedge/image.hpp"

/// The value of a macro as a text.
#define TEXT_OF(name) #name
#define NAME_OF(name) TEXT_OF(name)

/// What a program of the budget is made of: one algorithm, run at three sizes between two marks.
namespace firmware {

inline constexpr std::array<straightedge::Size, 3> budget_sizes = {{{160, 120}, {320, 240}, {640, 480}}};
inline constexpr std::size_t most_pixels = std::size_t{640} * 480;

constexpr std::size_t pixels_of(straightedge::Size size) noexcept {
  return static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height);
}

/// Marks that the emulator's plugin looks for.
extern "C" void count_begin() noexcept;
extern "C" void count_end() noexcept;
/// Prints `algorithm width height workspace_bytes`.
void print_row(const char* algorithm, straightedge::Size size, std::size_t workspace_bytes) noexcept;

/// One row of the table: `measured` is called between the marks, and says whether all went well.
template <class Measured>
bool count(const char* algorithm, straightedge::Size size, std::size_t workspace_bytes,
           Measured measured) noexcept {
  count_begin();
  const bool good = measured();
  count_end();
  print_row(algorithm, size, workspace_bytes);
  return good;
}

}  // namespace firmware
