// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "report.hpp"

namespace same_bits {

void Report::row(std::initializer_list<const char*> name, const Hash& hash) const noexcept {
  for (const char* piece : name) write_(piece);
  char digits[] = " 0123456789abcdef\n";
  for (unsigned i = 0; i < 16; ++i) {
    digits[i + 1] = "0123456789abcdef"[(hash.value() >> (60 - 4 * i)) & 15U];
  }
  write_(hash.has_nan() ? " NaN\n" : digits);
}

}  // namespace same_bits
