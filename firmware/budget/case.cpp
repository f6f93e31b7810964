// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "budget/case.hpp"

#include "kit/semihosting.hpp"

extern "C" {
[[gnu::noinline]] void count_begin() noexcept {
  asm volatile("" ::: "memory");
}
[[gnu::noinline]] void count_end() noexcept {
  asm volatile("" ::: "memory");
}
}

namespace firmware {

void print_row(const char* algorithm, straightedge::Size size, std::size_t workspace_bytes) noexcept {
  write(algorithm);
  for (const std::size_t number :
       {static_cast<std::size_t>(size.width), static_cast<std::size_t>(size.height), workspace_bytes}) {
    write(" ");
    write(static_cast<std::uint32_t>(number));
  }
  write("\n");
}

}  // namespace firmware
