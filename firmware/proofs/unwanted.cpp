// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT

// A program that does what the core must not do; UNWANTED says what. The linker script refuses each.
#include <array>
#include <cstddef>
#include <cstdint>

namespace {

volatile int number = 3;

#if UNWANTED == 1
int* heap() {
  return new int[static_cast<std::size_t>(number)];
}
int use() {
  return heap()[0];
}
#elif UNWANTED == 2
int use() {
  if (number > 2) throw 1;
  return 0;
}
#elif UNWANTED == 3
struct Counted {
  Counted() { number = number + 1; }
  int value = 4;
};
int use() {
  static const Counted counted;
  return counted.value;
}
#elif UNWANTED == 4
const int before_main = number;
int use() {
  return before_main;
}
#elif UNWANTED == 5
// One whole 640x480 picture of 32-bit numbers.
std::array<std::uint32_t, std::size_t{640} * 480> plane;
int use() {
  plane[static_cast<std::size_t>(number)] = 1;
  return static_cast<int>(plane[7]);
}
#else
int use() {
  return 0;
}
#endif

}  // namespace

int main() {
  return use();
}
