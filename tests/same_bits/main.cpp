// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <cstdio>

#include "cases.hpp"

/// Prints the rows of this build.
int main() {
  same_bits::run_cases([](const char* text) { std::fputs(text, stdout); });
  return 0;
}
