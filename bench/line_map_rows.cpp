// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <memory>

#include "rows.hpp"
#include "straightedge/host/line_map_builder.hpp"

namespace bench {
namespace {

auto prepare_line_map(const Job& job) {
  auto gray = std::make_shared<straightedge::Image<std::uint8_t>>(make_picture(job));
  auto builder = std::make_shared<straightedge::LineMapBuilder>();
  return [gray, builder] {
    const auto result = builder->build(*gray);
    if (!result) {
      std::fprintf(stderr, "line_map: %s\n", result.failure().sentence.c_str());
      std::exit(70);
    }
    require_some(result->map.lines.size(), "lines");
  };
}

}  // namespace

void add_line_map_rows(const Job& job) {
  add_row("line_map", job, prepare_line_map);
}

}  // namespace bench
