// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT

// What Catch2 needs and the reset handler does not give: the C library's heap and files, and constructors of
// globals.
#define CATCH_CONFIG_RUNNER
#include <catch2/catch.hpp>

#include <cstdint>
#include <cstdio>

extern "C" {
extern void (*__init_array_start[])();
extern void (*__init_array_end[])();
extern char __stack_guard;
extern void* __heap_limit;
void initialise_monitor_handles();
}

int main() {
  __heap_limit = &__stack_guard;
  initialise_monitor_handles();
  for (auto* start = __init_array_start; start != __init_array_end; ++start) (*start)();
  const char* const arguments[] = {"tests"};
  const int failed = Catch::Session().run(1, arguments);
  std::fflush(nullptr);
  return failed;
}
