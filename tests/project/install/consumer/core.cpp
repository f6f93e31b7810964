// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdio>

#include <straightedge/canny.hpp>

// A white square on black has an outline; anything else is a failure.
int main() {
  constexpr straightedge::Size size{32, 24};
  constexpr straightedge::CannyOptions options{.sigma = 0};
  static std::array<std::byte, straightedge::Canny::workspace_bytes(size, options)> workspace;
  static std::array<std::uint8_t, 32 * 24> gray{};
  static std::array<std::uint8_t, 32 * 24> edges{};
  for (std::size_t y = 8; y < 16; ++y) {
    for (std::size_t x = 8; x < 24; ++x) gray[y * 32 + x] = 255;
  }
  straightedge::Canny canny;
  const auto status = straightedge::Canny::prepare(canny, size, options, workspace);
  if (status != straightedge::Status::ok) return 1;
  const auto result = canny.run({gray.data(), size}, {edges.data(), size});
  std::printf("%s, %u edge pixels\n", straightedge::to_string(result.status), result.edges);
  return result.status == straightedge::Status::ok && result.edges >= 40 ? 0 : 1;
}
