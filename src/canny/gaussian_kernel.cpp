// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <cstddef>

#include "base/exponential.hpp"
#include "straightedge/gaussian.hpp"

namespace straightedge {
namespace {

// Kernels for sigma 0, in 1/256, from the outermost tap to the centre.
constexpr std::uint16_t table_1[] = {256};
constexpr std::uint16_t table_3[] = {64, 128};
constexpr std::uint16_t table_5[] = {16, 64, 96};
constexpr std::uint16_t table_7[] = {8, 28, 56, 72};
constexpr std::uint16_t table_9[] = {4, 13, 30, 51, 60};
constexpr const std::uint16_t* tables[] = {table_1, table_3, table_5, table_7, table_9};

void set_pair(std::span<std::uint16_t> taps, std::size_t i, std::int64_t value) noexcept {
  taps[i] = static_cast<std::uint16_t>(value);
  taps[taps.size() - 1 - i] = taps[i];
}

// Step 1, before scaling: tap i, counted from the outside, lies (n − 1)/2 − i from the centre.
double gaussian_at(std::size_t i, std::size_t n, double sigma) noexcept {
  const double twice_distance = 2 * static_cast<double>(i) - static_cast<double>(n - 1);
  return exponential(twice_distance * twice_distance * (-0.125 / (sigma * sigma)));
}

}  // namespace

Status make_gaussian_kernel(double sigma, std::span<std::uint16_t> taps) noexcept {
  const std::size_t n = taps.size();
  if (n % 2 == 0 || n > static_cast<std::size_t>(max_gaussian_size)) return Status::invalid_option;
  if (!(sigma >= 0 && sigma <= max_gaussian_sigma)) return Status::invalid_option;
  const std::size_t centre = n / 2;
  if (sigma == 0 && n <= 9) {
    for (std::size_t i = 0; i <= centre; ++i) set_pair(taps, i, tables[centre][i]);
    return Status::ok;
  }
  if (sigma == 0) sigma = 0.15 * static_cast<double>(n) + 0.35;

  // Step 1. Both halves and the centre, which is 1.
  double half = 0;
  for (std::size_t i = 0; i < centre; ++i) half += gaussian_at(i, n, sigma);
  const double scale = 1 / (2 * half + 1);

  // Step 2.
  double carried = 0;
  std::int64_t rest = 256;
  for (std::size_t i = 0; i < centre; ++i) {
    const double wanted = 256 * (gaussian_at(i, n, sigma) * scale) + carried;
    const std::int64_t tap = round_half_even(wanted);
    carried = wanted - static_cast<double>(tap);
    set_pair(taps, i, tap);
    rest -= 2 * tap;
  }
  taps[centre] = static_cast<std::uint16_t>(rest);
  return Status::ok;
}

}  // namespace straightedge
