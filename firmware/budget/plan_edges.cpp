// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "budget/case.hpp"
#include "budget/edge_input.hpp"
#include "straightedge/canny_fused.hpp"

namespace firmware {
namespace {

constexpr straightedge::CannyOptions options{};
[[gnu::section(".big.edges")]] alignas(
    64) std::array<std::byte, straightedge::FusedCanny::workspace_bytes({640, 480}, options)> workspace;

}  // namespace

straightedge::ImageView<std::uint8_t> plan_edges(straightedge::Size size) noexcept {
  const straightedge::ImageView<std::uint8_t> view = plan_picture(size);
  straightedge::FusedCanny canny;
  if (straightedge::FusedCanny::prepare(canny, size, options, workspace) != straightedge::Status::ok)
    return {};
  if (canny.run(view, view).status != straightedge::Status::ok) return {};
  return view;
}

}  // namespace firmware
