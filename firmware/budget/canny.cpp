// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT

// Edges of a whole picture; DETECTOR is Canny or FusedCanny.
#include "straightedge/canny.hpp"
#include "budget/case.hpp"
#include "budget/edge_input.hpp"
#include "straightedge/canny_fused.hpp"

namespace {

using namespace straightedge;

constexpr CannyOptions options{};
[[gnu::section(".big.workspace")]] alignas(
    64) std::array<std::byte, DETECTOR::workspace_bytes({640, 480}, options)> workspace;

bool measure(Size size) noexcept {
  const std::size_t bytes = DETECTOR::workspace_bytes(size, options);
  const ImageView<std::uint8_t> picture = firmware::plan_picture(size);
  DETECTOR canny;
  if (DETECTOR::prepare(canny, size, options, std::span(workspace).first(bytes)) != Status::ok) return false;
  return firmware::count(NAME_OF(DETECTOR), size, bytes,
                         [&] { return canny.run(picture, picture).status == Status::ok; });
}

}  // namespace

int main() {
  for (const Size size : firmware::budget_sizes) {
    if (!measure(size)) return 1;
  }
}
