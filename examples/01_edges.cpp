// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT

// Edges with the core alone: all memory is static, as on a microcontroller. Draws a dark box on light
// ground, finds its outline and prints it as text.
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdio>

#include "straightedge/canny.hpp"

namespace {

constexpr straightedge::Size size{48, 16};
constexpr straightedge::CannyOptions options{.sigma = 0, .low = 50, .high = 150};

// The size of the workspace is known when this is compiled.
std::array<std::byte, straightedge::Canny::workspace_bytes(size, options)> workspace;
std::array<std::uint8_t, std::size_t{48} * 16> gray;
std::array<std::uint8_t, std::size_t{48} * 16> edges;

}  // namespace

int main() {
  const straightedge::ImageView<std::uint8_t> gray_view(gray.data(), size);
  const straightedge::ImageView<std::uint8_t> edges_view(edges.data(), size);
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      const bool inside = x >= 8 && x < 40 && y >= 4 && y < 12;
      gray_view.at(x, y) = inside ? 30 : 220;
    }
  }

  straightedge::Canny canny;
  const straightedge::Status prepared = straightedge::Canny::prepare(canny, size, options, workspace);
  if (prepared != straightedge::Status::ok) {
    std::puts(straightedge::to_string(prepared));
    return 1;
  }
  const straightedge::CannyResult result = canny.run(gray_view, edges_view);
  if (result.status != straightedge::Status::ok) {
    std::puts(straightedge::to_string(result.status));
    return 1;
  }

  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) std::putchar(edges_view.at(x, y) != 0 ? '#' : '.');
    std::putchar('\n');
  }
  std::printf("%u edge pixels in %zu bytes of workspace\n", result.edges, workspace.size());
}
