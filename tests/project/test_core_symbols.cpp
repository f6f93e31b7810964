// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cstdio>

#include "core_symbols.hpp"
#include "support/catch.hpp"

namespace {

std::string nm(const std::string& archive) {
  const std::string command = "'" STRAIGHTEDGE_NM "' --format=sysv '" + archive + "'";
  std::FILE* pipe = popen(command.c_str(), "r");
  REQUIRE(pipe != nullptr);
  std::string output;
  std::array<char, 4096> part{};
  while (std::fgets(part.data(), static_cast<int>(part.size()), pipe) != nullptr) output += part.data();
  REQUIRE(pclose(pipe) == 0);
  return output;
}

bool found(const std::vector<std::string>& breaches, const std::string& start) {
  return std::any_of(breaches.begin(), breaches.end(),
                     [&](const std::string& breach) { return breach.starts_with(start); });
}

}  // namespace

TEST_CASE("the core needs nothing at run time and has no memory of its own") {
  CHECK(project::symbol_breaches(nm(STRAIGHTEDGE_CORE_ARCHIVE)) == std::vector<std::string>{});
}

TEST_CASE("a core that breaks the rules is found out") {
  const auto breaches = project::symbol_breaches(nm(STRAIGHTEDGE_BAD_ARCHIVE));
  CHECK(found(breaches, "needs from outside: sin"));
  CHECK(found(breaches, "needs from outside: _Znwm"));
  CHECK(found(breaches, "needs from outside: __cxa_throw"));
  CHECK(found(breaches, "runs before main: "));
  CHECK(found(breaches, "guards a local static: "));
  CHECK(found(breaches, "global memory that can be written: _ZN16straightedge_bad7counterE"));
  CHECK(found(breaches, "a weak symbol that is not ours: "));
}

TEST_CASE("an empty listing is a breach, not a pass") {
  CHECK(project::symbol_breaches("") == std::vector<std::string>{"no symbol at all"});
}
