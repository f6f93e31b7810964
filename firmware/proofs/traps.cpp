// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT

// Mistakes that must not go unseen in a test; TRAP says which one this program makes. It exits with the
// fault's code, or with 0 if nobody minded.
#include <cstdint>

namespace {

volatile int zero = 0;
volatile std::uint32_t sink = 0;

[[maybe_unused]] void write_through_null() noexcept {
  volatile std::uint32_t* null = nullptr;
  asm volatile("" : "+r"(null));
  *null = 1;
}

[[maybe_unused]] void divide_by_zero() noexcept {
  sink = static_cast<std::uint32_t>(7 / zero);
}

[[maybe_unused]] void overflow_stack() noexcept {
  volatile std::uint32_t frame[64] = {};
  sink = frame[sink % 64];
  overflow_stack();
  sink = frame[sink % 64];
}

}  // namespace

int main() {
  TRAP();
  return 0;
}
