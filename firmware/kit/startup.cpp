// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT

// From reset to main, and what happens when something goes wrong. Mistakes that an emulator forgives (a write
// through null, an overflowing stack, a division by zero) are made to fault.
#include <cstdint>

#include "kit/memory_guard.hpp"
#include "kit/semihosting.hpp"

// C++ does not let a program call its own main; this is the same function by its linker's name.
int program() asm("main");

extern "C" {
extern std::uint32_t __data_load, __data_start, __data_end, __bss_start, __bss_end, __stack_top;

namespace {

volatile std::uint32_t& device(std::uint32_t address) noexcept {
  return *reinterpret_cast<volatile std::uint32_t*>(address);
}

constexpr std::uint32_t configuration_control = 0xE000ED14;
constexpr std::uint32_t fault_status = 0xE000ED28;
constexpr std::uint32_t coprocessor_access = 0xE000ED88;

}  // namespace

[[noreturn]] void fault_handler() {
  std::uint32_t number = 0;
  asm volatile("mrs %0, ipsr" : "=r"(number));
  firmware::write("FAULT ");
  firmware::write_hex(number);
  firmware::write(" status ");
  firmware::write_hex(device(fault_status));
  firmware::write("\n");
  firmware::exit_with(firmware::fault_code);
}

[[noreturn]] void reset_handler() {
  device(coprocessor_access) = 0xFU << 20U;   // floating point and vector instructions on
  device(configuration_control) |= 1U << 4U;  // division by zero faults
  asm volatile("dsb\n isb" ::: "memory");
  const std::uint32_t* from = &__data_load;
  for (std::uint32_t* to = &__data_start; to < &__data_end; ++to) *to = *from++;
  for (std::uint32_t* to = &__bss_start; to < &__bss_end; ++to) *to = 0;
  firmware::guard_memory();
  firmware::exit_with(program());
}

union Vector {
  const void* pointer;
  void (*handler)();
};

__attribute__((section(".isr_vector"), used)) extern const Vector vectors[16] = {{.pointer = &__stack_top},
                                                                                 {.handler = reset_handler},
                                                                                 {.handler = fault_handler},
                                                                                 {.handler = fault_handler},
                                                                                 {.handler = fault_handler},
                                                                                 {.handler = fault_handler},
                                                                                 {.handler = fault_handler},
                                                                                 {.handler = fault_handler},
                                                                                 {},
                                                                                 {},
                                                                                 {},
                                                                                 {.handler = fault_handler},
                                                                                 {.handler = fault_handler},
                                                                                 {},
                                                                                 {.handler = fault_handler},
                                                                                 {.handler = fault_handler}};
}
