// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <initializer_list>

#include "hash.hpp"

namespace same_bits {

/// Where text goes: standard output on a PC, the emulator's on a board.
using Write = void (*)(const char* text);

/// Prints one row a result: its name, a blank, the hash in 16 hexadecimal digits.
class Report {
 public:
  explicit Report(Write write) noexcept : write_(write) {}

  /// The name in pieces. A hash with a NaN in it prints as such, which no table has.
  void row(std::initializer_list<const char*> name, const Hash& hash) const noexcept;

 private:
  Write write_;
};

}  // namespace same_bits
