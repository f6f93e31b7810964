// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
// Same result as ../row_gradient.cpp, side 3; read that first.
#ifdef STRAIGHTEDGE_KERNEL_SET
#include "canny/fast/lanes.hpp"
#include "canny/fast/row_kernels.hpp"

namespace straightedge::STRAIGHTEDGE_KERNEL_SET {
namespace {

void store_magnitude(Lanes16 dx, Lanes16 dy, std::uint16_t* magnitude) noexcept {
  (dx.magnitude() + dy.magnitude()).store(magnitude);
}

void store_magnitude(Lanes16 dx, Lanes16 dy, std::uint32_t* magnitude) noexcept {
  store_squares(dx, dy, magnitude);
}

template <class M>
void gradient_of_3(const std::uint8_t* const* rows, std::int16_t* dx, std::int16_t* dy, M* magnitude,
                   std::int32_t width) noexcept {
  const std::uint8_t* const above = rows[0];
  const std::uint8_t* const here = rows[1];
  const std::uint8_t* const below = rows[2];
  const auto load = Lanes16::load_bytes;
  for (std::int32_t x = 0; x < width; x += Lanes16::count) {
    const Lanes16 falling = load(below + x + 1) - load(above + x - 1);
    const Lanes16 rising = load(above + x + 1) - load(below + x - 1);
    const Lanes16 level = load(here + x + 1) - load(here + x - 1);
    const Lanes16 upright = load(below + x) - load(above + x);
    const Lanes16 across = falling + rising + (level + level);
    const Lanes16 down = falling - rising + (upright + upright);
    across.store(dx + x);
    down.store(dy + x);
    store_magnitude(across, down, magnitude + x);
  }
}

}  // namespace

void gradient_l1_of_3(const std::uint8_t* const* rows, std::int16_t*, std::int16_t* dx, std::int16_t* dy,
                      std::uint16_t* magnitude, std::int32_t width) noexcept {
  gradient_of_3(rows, dx, dy, magnitude, width);
}

void gradient_l2_of_3(const std::uint8_t* const* rows, std::int16_t*, std::int16_t* dx, std::int16_t* dy,
                      std::uint32_t* magnitude, std::int32_t width) noexcept {
  gradient_of_3(rows, dx, dy, magnitude, width);
}

}  // namespace straightedge::STRAIGHTEDGE_KERNEL_SET
#endif
