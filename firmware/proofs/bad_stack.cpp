// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT

// Everything that the check of stacks refuses, so that it can be seen to.
#include <cstddef>

namespace straightedge {

struct Hook {
  int (*look)(int) = nullptr;
};

int large_frame(int x) noexcept {
  volatile char buffer[25000];
  buffer[x] = 1;
  return buffer[x / 2];
}

int unknown_frame(std::size_t count) noexcept {
  auto* buffer = static_cast<volatile char*>(__builtin_alloca(count));
  buffer[0] = 1;
  return buffer[count / 2];
}

int through_pointer(const Hook& hook) noexcept {
  return hook.look(3) + 1;
}

int odd(int x) noexcept;
[[gnu::noinline]] int even(int x) noexcept {
  volatile int below = x == 0 ? 1 : odd(x - 1);
  return below + 1;
}
[[gnu::noinline]] int odd(int x) noexcept {
  volatile int below = x == 0 ? 0 : even(x - 1);
  return below + 2;
}

}  // namespace straightedge
