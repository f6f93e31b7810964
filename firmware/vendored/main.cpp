// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT

// Edges of a picture on a microcontroller: all memory is static, its size a constant expression.
#include <array>
#include <cstddef>
#include <cstdint>

#include "kit/semihosting.hpp"
#include "straightedge/canny_fused.hpp"

namespace {

constexpr straightedge::Size size{80, 60};
constexpr straightedge::CannyOptions options{.sigma = 1, .low = 40, .high = 100};
alignas(64) std::array<std::byte, straightedge::FusedCanny::workspace_bytes(size, options)> workspace;
std::array<std::uint8_t, std::size_t{80} * 60> picture;

}  // namespace

int main() {
  for (std::size_t i = 0; i < picture.size(); ++i) picture[i] = i % 80 < 40 ? 20 : 200;
  straightedge::FusedCanny canny;
  if (straightedge::FusedCanny::prepare(canny, size, options, workspace) != straightedge::Status::ok) return 1;
  const straightedge::ImageView<std::uint8_t> view(picture.data(), size);
  const auto result = canny.run(view, view);
  firmware::write(result.edges);
  firmware::write(" edge pixels\n");
  return result.status == straightedge::Status::ok && result.edges == 60 ? 0 : 2;
}
