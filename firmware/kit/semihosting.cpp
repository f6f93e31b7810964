// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "kit/semihosting.hpp"

namespace firmware {
namespace {

constexpr int write_text = 0x04;
constexpr int exit_extended = 0x20;

int call(int operation, const void* argument) noexcept {
  register int r0 asm("r0") = operation;
  register const void* r1 asm("r1") = argument;
  asm volatile("bkpt 0xab" : "+r"(r0) : "r"(r1) : "memory");
  return r0;
}

}  // namespace

void write(const char* text) noexcept {
  call(write_text, text);
}

void write(std::uint32_t number) noexcept {
  char digits[11];
  char* first = digits + 10;
  *first = 0;
  do {
    *--first = static_cast<char>('0' + number % 10);
    number /= 10;
  } while (number > 0);
  write(first);
}

void write_hex(std::uint32_t number) noexcept {
  char digits[9];
  for (unsigned i = 0; i < 8; ++i) digits[i] = "0123456789abcdef"[(number >> (28 - 4 * i)) & 15U];
  digits[8] = 0;
  write(digits);
}

void exit_with(int code) noexcept {
  constexpr std::uint32_t application_exit = 0x20026;
  const std::uint32_t block[2] = {application_exit, static_cast<std::uint32_t>(code)};
  call(exit_extended, block);
  for (;;) {
  }
}

}  // namespace firmware
