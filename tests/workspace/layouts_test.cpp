// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT

// Every algorithm, whatever the caller's memory looks like.
#include <algorithm>
#include <set>
#include <string>

#include "algorithms.hpp"
#include "support/catch.hpp"

using namespace workspace;

namespace {

template <class Check>
void for_all(Check&& check) {
  for (const auto algorithms :
       {edge_algorithms(), line_algorithms(), plane_algorithms(), octree_algorithms()}) {
    for (const Algorithm& algorithm : algorithms) {
      INFO(algorithm.name);
      check(algorithm);
    }
  }
}

void check_nothing_beside(const CallerMemory& memory) {
  CHECK(memory.guards_intact());
  CHECK(memory.inputs_untouched());
}

void check_same(const Algorithm& algorithm, const Layout& layout) {
  CallerMemory packed({}), own(layout);
  REQUIRE(algorithm.run(packed) == Status::ok);
  REQUIRE(algorithm.run(own) == Status::ok);
  CHECK(own.said() == packed.said());
  CHECK(own.pictures() == packed.pictures());
  check_nothing_beside(own);
}

}  // namespace

namespace workspace {

Status whole(Status prepared, Status ran) {
  if (prepared == Status::ok) return ran;
  CHECK(ran == Status::not_prepared);
  return prepared;
}

}  // namespace workspace

TEST_CASE("every algorithm finds something in what it is given") {
  for_all([](const Algorithm& algorithm) {
    CallerMemory memory({});
    REQUIRE(algorithm.run(memory) == Status::ok);
    const auto pictures = memory.pictures();
    const std::set<unsigned char> values(pictures.begin(), pictures.end());
    REQUIRE((!pictures.empty() || !memory.said().empty()));
    if (!pictures.empty()) CHECK(values.size() > 1);
    if (!memory.said().empty()) CHECK(memory.said()[0] > 0);
    check_nothing_beside(memory);
  });
}

TEST_CASE("rows with gaps, odd addresses and points of many strides give what packed ones give") {
  const Layout layouts[] = {{.gap = 3, .ahead = 1, .point_floats = 3},
                            {.gap = 1, .ahead = 3, .point_floats = 4},
                            {.gap = 17, .ahead = 2, .point_floats = 5}};
  for (const Layout& layout : layouts) {
    INFO("gap " << layout.gap);
    for_all([&](const Algorithm& algorithm) { check_same(algorithm, layout); });
  }
}

TEST_CASE("a workspace may lie anywhere and be full of anything") {
  for (const std::size_t offset : {1U, 8U, 63U}) {
    INFO("offset " << offset);
    const Layout layout{.offset = offset, .dirt = static_cast<unsigned char>(offset == 8 ? 0x7F : 0xFF)};
    for_all([&](const Algorithm& algorithm) { check_same(algorithm, layout); });
  }
}

TEST_CASE("a workspace that is one byte too small is refused, and nothing is written") {
  // One byte behind an aligned address the room for alignment is used up.
  for (const std::size_t missing : {std::size_t{1}, std::size_t{64}, SIZE_MAX}) {
    INFO("missing " << missing);
    int refused = 0;
    for_all([&](const Algorithm& algorithm) {
      CallerMemory memory({.gap = 3, .offset = 1, .missing = missing});
      const Status status = algorithm.run(memory);
      CHECK(status == (memory.has_workspace() ? Status::workspace_too_small : Status::ok));
      check_nothing_beside(memory);
      if (!memory.has_workspace()) return;
      ++refused;
      CHECK(memory.outputs_untouched());
    });
    CHECK(refused > 0);
  }
}
