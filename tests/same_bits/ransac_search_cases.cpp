// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <array>

#include "cases.hpp"
#include "hash_results.hpp"
#include "inputs.hpp"
#include "memory.hpp"
#include "straightedge/ransac_search.hpp"

namespace same_bits {
namespace {

using namespace straightedge;

constexpr std::size_t pixels = std::size_t{depth_size.width} * depth_size.height;
constexpr RansacSearchOptions options{.min_pixels = 64};
constexpr RansacSearchOptions fine{.gate = {.floor_m = 0.01}, .cell = 3, .min_pixels = 100, .rough_rms = 0};
static_assert(RansacSearch::workspace_bytes(depth_size, fine) + pixels * (sizeof(float) + 2) <=
              most_workspace);

SAME_BITS_LARGE std::array<ProposedPlane, 64> candidates;

void row_of(const Report& report, const DepthView& depth, const RansacSearchOptions& chosen, bool masked,
            const char* name) noexcept {
  const std::span<std::byte> memory = workspace();
  const ImageView<float> inverse(reinterpret_cast<float*>(memory.data()), depth_size);
  const ImageView<std::uint16_t> mask(
      reinterpret_cast<std::uint16_t*>(memory.subspan(pixels * sizeof(float)).data()), depth_size);
  for (int y = 0; y < depth_size.height; ++y) {
    for (int x = 0; x < depth_size.width; ++x) mask.at(x, y) = x / 20 % 2 == 1 ? 1 : 0;
  }
  RansacSearch search;
  Hash hash;
  hash.add(inverse_depth_image(depth, inverse));
  hash.add(RansacSearch::prepare(search, depth_size, chosen, memory.subspan(pixels * (sizeof(float) + 2))));
  const ImageView<const std::uint16_t> taken = masked ? mask : ImageView<std::uint16_t>{};
  const RansacSearchResult result = search.run(inverse, taken, candidates);
  hash.add(result, std::span<const ProposedPlane>(candidates).first(result.candidates));
  report.row({"ransac_search.", name}, hash);
}

}  // namespace

void ransac_search_cases(const Report& report, const Kernels& kernels) noexcept {
  const auto with_kernels = [&](RansacSearchOptions chosen) {
    chosen.kernels = kernels.plane_search;
    return chosen;
  };
  row_of(report, depth_picture(), with_kernels(options), false, "default");
  row_of(report, depth_picture(), with_kernels(fine), false, "fine");
  row_of(report, depth_picture(), with_kernels(options), true, "masked");
  row_of(report, blank_depth(), with_kernels(options), false, "blank");
}

}  // namespace same_bits
