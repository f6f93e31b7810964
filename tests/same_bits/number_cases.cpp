// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "base/exponential.hpp"
#include "cases.hpp"
#include "straightedge/border.hpp"
#include "straightedge/random.hpp"
#include "straightedge/rounding.hpp"
#include "straightedge/square_root.hpp"
#include "straightedge/trigonometry.hpp"

namespace same_bits {
namespace {

using straightedge::Pcg32;

/// Of either sign, below 2^whole_bits, with steps of 2^(whole_bits − 31).
double number(Pcg32& random, unsigned whole_bits) noexcept {
  const double part = static_cast<double>(static_cast<std::int32_t>(random.next()));
  return part / 2147483648.0 * static_cast<double>(1U << whole_bits);
}

void random_rows(const Report& report) noexcept {
  Hash raw, bounded;
  for (std::uint64_t stream = 0; stream < 5; ++stream) {
    Pcg32 random(stream * 0x123456789ABCDU, stream);
    for (int i = 0; i < 100; ++i) raw.add(random.next());
    for (std::uint32_t bound = 0; bound < 100; ++bound) bounded.add(random.below(bound * bound * 400'001));
  }
  report.row({"base.random.next"}, raw);
  report.row({"base.random.below"}, bounded);
}

void trigonometry_rows(const Report& report) noexcept {
  Pcg32 random(21);
  Hash sines, tangents, wrapped;
  for (unsigned i = 0; i < 1500; ++i) {
    const double x = number(random, i % 25), y = number(random, i % 7), z = number(random, i % 11);
    const auto both = straightedge::sine_cosine(x);
    sines.add(both.sine, both.cosine, straightedge::sine(y), straightedge::cosine(z));
    tangents.add(straightedge::arc_tangent(y, z), straightedge::arc_tangent(x, y));
    wrapped.add(straightedge::wrap_angle(z / 16));
  }
  for (int i = -16; i <= 16; ++i) {
    const auto both = straightedge::sine_cosine(i * (straightedge::pi / 4));
    sines.add(both.sine, both.cosine);
    tangents.add(straightedge::arc_tangent(i, 4), straightedge::arc_tangent(4, i));
  }
  tangents.add(straightedge::arc_tangent(0, 0), straightedge::arc_tangent(0, -1));
  report.row({"base.trigonometry.sine_cosine"}, sines);
  report.row({"base.trigonometry.arc_tangent"}, tangents);
  report.row({"base.trigonometry.wrap_angle"}, wrapped);
}

void rounding_rows(const Report& report) noexcept {
  Pcg32 random(22);
  Hash rounded, powers;
  for (unsigned i = 0; i < 1000; ++i) {
    const double x = number(random, i % 31);
    const double half = static_cast<double>(static_cast<std::int32_t>(random.next()) / 4096) / 2;
    rounded.add(straightedge::floor_to_integer(x), straightedge::round_half_even(x));
    rounded.add(straightedge::floor_to_integer(half), straightedge::round_half_even(half));
    const double y = number(random, i % 11);
    powers.add(straightedge::exponential(y < 0 ? y : -y));
  }
  report.row({"base.rounding"}, rounded);
  report.row({"base.exponential"}, powers);
}

void square_root_row(const Report& report) noexcept {
  Pcg32 random(23);
  Hash hash;
  for (unsigned i = 0; i < 500; ++i) {
    const double x = number(random, i % 31), positive = x < 0 ? -x : x;
    const double scaled = positive * (i % 3 == 0 ? 1e-300 : i % 3 == 1 ? 1e280 : 1);
    hash.add(straightedge::square_root(scaled), straightedge::detail::square_root_by_digits(scaled));
  }
  report.row({"base.square_root"}, hash);
}

void border_row(const Report& report) noexcept {
  using straightedge::Border;
  Hash hash;
  for (const Border border : {Border::constant, Border::replicate, Border::reflect, Border::reflect_101}) {
    for (std::int32_t n = 1; n < 6; ++n) {
      for (std::int32_t i = -13; i < 19; ++i) hash.add(straightedge::border_index(i, n, border));
    }
  }
  report.row({"base.border_index"}, hash);
}

}  // namespace

void number_cases(const Report& report) noexcept {
  random_rows(report);
  trigonometry_rows(report);
  rounding_rows(report);
  square_root_row(report);
  border_row(report);
}

}  // namespace same_bits
