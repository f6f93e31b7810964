// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "straightedge/ransac_search.hpp"

namespace straightedge {

PlaneSearch plane_search(RansacSearch& search) noexcept {
  const auto run = [](void* user, ImageView<const float> /*inverse_depth*/, const DepthCells& cells,
                      ImageView<const std::uint16_t> labels, const PinholeCamera& /*camera*/,
                      std::span<ProposedPlane> out, std::uint32_t& count) noexcept {
    const RansacSearchResult result = static_cast<RansacSearch*>(user)->run(cells, labels, out);
    count = result.candidates;
    return result.status;
  };
  // Every window was searched until no plane was left in it: a second search hardly finds more.
  return {&search, run, 1};
}

}  // namespace straightedge
