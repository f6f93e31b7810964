// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "straightedge/canny_rows.hpp"
#include "budget/case.hpp"
#include "budget/edge_input.hpp"

namespace {

using namespace straightedge;

constexpr CannyOptions options{};
[[gnu::section(".big.workspace")]] alignas(
    64) std::array<std::byte, CannyRows::workspace_bytes({640, 480}, options)> workspace;

bool all_rows(CannyRows& canny, GrayView picture) noexcept {
  bool good = canny.begin() == Status::ok;
  const auto width = static_cast<std::size_t>(picture.width);
  for (std::int32_t y = 0; y < picture.height; ++y)
    good &= canny.push_row({picture.row(y), width}) == Status::ok;
  return good && canny.finish().status == Status::ok;
}

bool measure(Size size) noexcept {
  const std::size_t bytes = CannyRows::workspace_bytes(size, options);
  const GrayView picture = firmware::plan_picture(size);
  CannyRows canny;
  if (CannyRows::prepare(canny, size, options, std::span(workspace).first(bytes)) != Status::ok) return false;
  return firmware::count("CannyRows", size, bytes, [&] { return all_rows(canny, picture); });
}

}  // namespace

int main() {
  for (const Size size : firmware::budget_sizes) {
    if (!measure(size)) return 1;
  }
}
