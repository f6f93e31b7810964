// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

/// Words and an exit code out of the emulator (Arm's semihosting: a breakpoint that the emulator answers).
namespace firmware {

void write(const char* text) noexcept;
void write(std::uint32_t number) noexcept;
void write_hex(std::uint32_t number) noexcept;
[[noreturn]] void exit_with(int code) noexcept;

/// What a fault exits with.
inline constexpr int fault_code = 125;

/// Bytes of stack that have been used since reset.
std::uint32_t stack_used() noexcept;

}  // namespace firmware
