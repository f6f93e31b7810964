// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <array>

#include "canny_names.hpp"
#include "cases.hpp"
#include "hash_results.hpp"
#include "inputs.hpp"
#include "memory.hpp"
#include "straightedge/canny_fused.hpp"
#include "straightedge/canny_rows.hpp"

namespace same_bits {
namespace {

using namespace straightedge;

constexpr std::ptrdiff_t edge_stride = picture_size.width + 6;
constexpr std::size_t edge_bytes = std::size_t{edge_stride} * picture_size.height;
constexpr CannyOptions largest{.sigma = 50, .aperture = 7};
static_assert(edge_bytes + FusedCanny::workspace_bytes(picture_size, largest) <= most_workspace);
static_assert(CannyRows::workspace_bytes(picture_size, largest) <= most_workspace);

Hash run_fused(GrayView gray, const CannyOptions& options, const CannyRowOptions& rows) noexcept {
  const std::span<std::byte> memory = workspace();
  const ImageView<std::uint8_t> edges(reinterpret_cast<std::uint8_t*>(memory.data()), picture_size,
                                      edge_stride);
  FusedCanny canny;
  Hash hash;
  hash.add(FusedCanny::prepare(canny, picture_size, options, memory.subspan(edge_bytes), rows));
  hash.add(canny.run(gray, edges), edges);
  return hash;
}

Hash run_rows(GrayView gray, const CannyOptions& options, const CannyRowOptions& rows) noexcept {
  CannyRows canny;
  Hash hash;
  hash.add(CannyRows::prepare(canny, picture_size, options, workspace(), rows));
  hash.add(canny.begin());
  for (int y = 0; y < picture_size.height; ++y) {
    hash.add(canny.push_row({gray.row(y), static_cast<std::size_t>(picture_size.width)}));
  }
  hash.add(canny.finish());
  std::array<std::uint8_t, picture_size.width> edges{};
  for (int y = 0; y < picture_size.height; ++y) {
    hash.add(canny.read_row(y, edges));
    hash.add(edges);
  }
  return hash;
}

}  // namespace

void canny_row_cases(const Report& report, const CannyRowKernels& kernels) noexcept {
  for (const auto& [aperture, aperture_name] : apertures) {
    for (const auto& [norm, norm_name] : norms) {
      CannyRowOptions rows{.worklist = 512, .kernels = &kernels};
      const double scale = aperture == 3 ? 1 : aperture == 5 ? 12 : 160;
      CannyOptions options{.aperture = aperture, .norm = norm, .low = 20.5 * scale, .high = 160.25 * scale};
      for (const auto& [sigma, sigma_name] : std::span(sigmas).first<4>()) {
        options.sigma = sigma;
        report.row({"canny.fused", norm_name, aperture_name, sigma_name},
                   run_fused(picture(), options, rows));
      }
      report.row({"canny.rows", norm_name, aperture_name}, run_rows(picture(), options, rows));
      // A worklist that overflows, on edges that branch everywhere.
      rows.worklist = 5;
      options.sigma = 0;
      report.row({"canny.fused", norm_name, aperture_name, ".noise"},
                 run_fused(noise_picture(), options, rows));
      report.row({"canny.rows", norm_name, aperture_name, ".noise"},
                 run_rows(noise_picture(), options, rows));
    }
  }
}

}  // namespace same_bits
