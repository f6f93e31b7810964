// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "kit/memory_guard.hpp"

#include <cstdint>

#include "kit/semihosting.hpp"

extern "C" {
extern std::uint32_t __stack_top, __stack_limit, __flash_start;
}

namespace firmware {
namespace {

constexpr std::uint32_t paint = 0xC0FFEE11;

volatile std::uint32_t& protection(std::uint32_t offset) noexcept {
  return *reinterpret_cast<volatile std::uint32_t*>(0xE000ED90U + offset);
}

std::uint32_t address_of(const std::uint32_t& symbol) noexcept {
  return reinterpret_cast<std::uint32_t>(&symbol);
}

#if __ARM_ARCH >= 8

// Armv8-M has a register for the stack's end, and regions given by their first and last address.
void set_regions() noexcept {
  asm volatile("msr msplim, %0" ::"r"(address_of(__stack_limit)));
  protection(0x30) = 0xAA;  // attribute 0: ordinary memory, cached
  protection(0x08) = 0;
  protection(0x0C) = address_of(__flash_start) | 3U << 1U;  // read only
  protection(0x10) = ((address_of(__flash_start) + (512U << 10U) - 1) & ~31U) | 1U;
}

#else

// Earlier ones have regions of a power of two.
void set_region(std::uint32_t number, std::uint32_t start, std::uint32_t log2_bytes,
                std::uint32_t attributes) noexcept {
  protection(0x08) = number;
  protection(0x0C) = start;
  protection(0x10) = attributes | (log2_bytes - 1) << 1U | 1U;
}

void set_regions() noexcept {
  constexpr std::uint32_t read_only = 6U << 24U | 1U << 17U;
  constexpr std::uint32_t no_access = 1U << 28U;
  constexpr std::uint32_t log2_4m = 22, log2_4k = 12;
  set_region(0, 0, log2_4m, read_only);
  set_region(1, address_of(__flash_start), log2_4m, read_only);
  set_region(2, address_of(__stack_limit) - 4096, log2_4k, no_access);
}

#endif

}  // namespace

void guard_memory() noexcept {
  std::uint32_t here = 0;
  asm volatile("mov %0, sp" : "=r"(here));
  auto* word = reinterpret_cast<volatile std::uint32_t*>(&__stack_limit);
  for (; reinterpret_cast<std::uint32_t>(word) < here; ++word) *word = paint;
  set_regions();
  protection(0x04) = 5;  // on, with the default map behind
  asm volatile("dsb\n isb" ::: "memory");
}

std::uint32_t stack_used() noexcept {
  const volatile std::uint32_t* word = &__stack_limit;
  while (*word == paint) ++word;
  return address_of(__stack_top) - reinterpret_cast<std::uint32_t>(word);
}

}  // namespace firmware
