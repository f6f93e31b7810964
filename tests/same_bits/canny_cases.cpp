// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "canny_names.hpp"
#include "cases.hpp"
#include "hash_results.hpp"
#include "inputs.hpp"
#include "memory.hpp"
#include "straightedge/canny.hpp"

namespace same_bits {
namespace {

using namespace straightedge;

constexpr std::ptrdiff_t edge_stride = picture_size.width + 6;
static_assert(Canny::workspace_bytes(picture_size, {.sigma = 50, .aperture = 7}) +
                  edge_stride * picture_size.height + Arena::alignment <=
              most_workspace);

/// Result and edges of one run; the picture's upper left part of this size.
Hash run(GrayView gray, Size size, const CannyOptions& options) noexcept {
  const std::span<std::byte> memory = workspace();
  const ImageView<std::uint8_t> edges(reinterpret_cast<std::uint8_t*>(memory.data()), size, edge_stride);
  Hash hash;
  Canny canny;
  hash.add(Canny::prepare(canny, size, options, memory.subspan(edge_stride * picture_size.height)));
  hash.add(canny.run({gray.data, size, gray.stride}, edges), edges);
  return hash;
}

CannyOptions options_of(double sigma, int aperture, GradientNorm norm, CannyThresholds thresholds) noexcept {
  // The sum of the smoothing weights times that of the positive differences, over side 3's.
  const double scale = aperture == 3 ? 1 : aperture == 5 ? 12 : 160;
  return {.sigma = sigma,
          .aperture = aperture,
          .norm = norm,
          .thresholds = thresholds,
          .low = 20.5 * scale,
          .high = 160.25 * scale};
}

}  // namespace

void canny_cases(const Report& report) noexcept {
  for (const auto& [aperture, aperture_name] : apertures) {
    for (const auto& [norm, norm_name] : norms) {
      for (const auto& [sigma, sigma_name] : std::span(sigmas).first<4>()) {
        const auto given = options_of(sigma, aperture, norm, CannyThresholds::given);
        const auto automatic = options_of(sigma, aperture, norm, CannyThresholds::automatic);
        report.row({"canny.whole", norm_name, aperture_name, sigma_name, ".given"},
                   run(picture(), picture_size, given));
        report.row({"canny.whole", norm_name, aperture_name, sigma_name, ".automatic"},
                   run(picture(), picture_size, automatic));
      }
      const auto sharp = options_of(0, aperture, norm, CannyThresholds::given);
      report.row({"canny.whole", norm_name, aperture_name, ".noise"},
                 run(noise_picture(), picture_size, sharp));
    }
  }
  report.row({"canny.whole.blank"}, run(blank_picture(), picture_size, {}));
  for (const GrayView& gray : {picture(), noise_picture()}) {
    Hash hash;
    for (const Size size : {Size{1, 1}, Size{1, 7}, Size{9, 1}, Size{2, 2}, Size{5, 3}, Size{33, 17}}) {
      hash.add(run(gray, size, {.sigma = 1.4, .low = 10, .high = 30}).value());
    }
    report.row({gray.data == picture().data ? "canny.whole.small" : "canny.whole.small_noise"}, hash);
  }
}

}  // namespace same_bits
