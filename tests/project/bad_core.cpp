// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT

// Everything that the core must not do, so that the check of its symbols can be seen to fail.
#include <cmath>
#include <cstdlib>
#include <vector>

namespace straightedge_bad {

int counter = 1;

[[gnu::noinline]] inline int shared_by_name(int x) {
  return x * counter;
}

int weak(int x) {
  return shared_by_name(x) + 1;
}

double heap(std::size_t count) {
  std::vector<double> values(count, 2.0);
  values.push_back(1.0);
  return values.back();
}

double libm(double x) {
  return std::sin(x);
}

int before_main = std::atoi("7");

int guarded(int x) {
  static const int first = std::atoi("3") + x;
  return first;
}

[[noreturn]] void thrown() {
  throw 1;
}

}  // namespace straightedge_bad
