// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT

// The rows of hashes of a board.
#include "cases.hpp"
#include "kit/semihosting.hpp"

int main() {
  same_bits::run_cases(firmware::write);
  return 0;
}
