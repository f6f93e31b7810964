// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "straightedge/canny.hpp"

namespace straightedge {

Status Canny::prepare(Canny& canny, Size size, const CannyOptions& options,
                      std::span<std::byte> workspace) noexcept {
  canny = Canny();
  const Status status = check(size, options);
  if (status != Status::ok) return status;
  if (workspace.data() == nullptr || workspace.size() < workspace_bytes(size, options)) {
    return Status::workspace_too_small;
  }
  Arena arena(workspace);
  canny.memory_ = detail::CannyWorkspace::take(arena, size, gaussian_size(options.sigma), options.aperture);
  if (arena.failed()) return Status::workspace_too_small;
  canny.size_ = size;
  canny.options_ = options;
  canny.prepared_ = true;
  return make_gaussian_kernel(options.sigma, canny.memory_.taps);
}

CannyResult Canny::run(GrayView gray, ImageView<std::uint8_t> edges, HysteresisTrace trace) noexcept {
  if (!prepared_) return {};
  if (!gray.valid() || !edges.valid()) return {Status::invalid_image};
  if (gray.size() != size_ || edges.size() != size_) return {Status::size_mismatch};
  const ImageView<std::uint8_t> blurred(memory_.blurred.data(), size_);
  const ImageView<std::int16_t> dx(memory_.dx.data(), size_);
  const ImageView<std::int16_t> dy(memory_.dy.data(), size_);
  const ImageView<std::int32_t> magnitude(memory_.magnitude.data(), size_);
  const ImageView<std::uint8_t> classes(memory_.classes.data(), size_);
  const int aperture = options_.aperture;
  CannyResult result;

  // Step 1.
  result.status = gaussian_blur(gray, memory_.taps, Border::reflect_101, memory_.gaussian_scratch, blurred);
  if (result.status != Status::ok) return result;

  // Step 2.
  const GradientScale scale = aperture == 7 ? GradientScale::sixteenth : GradientScale::clamp;
  result.status = sobel(blurred, aperture, Border::replicate, scale, memory_.sobel_scratch, dx, dy);
  if (result.status != Status::ok) return result;

  // Step 3.
  result.status = gradient_magnitude(dx, dy, options_.norm, magnitude);
  if (result.status != Status::ok) return result;

  // Step 4.
  Thresholds thresholds{options_.low, options_.high};
  if (options_.thresholds == CannyThresholds::automatic) {
    const AutomaticThresholds chosen = automatic_thresholds(magnitude, options_.norm, aperture);
    if (chosen.status != Status::ok) return {chosen.status};
    thresholds = chosen.thresholds;
  }
  const MagnitudeThresholds limits = to_magnitude(thresholds, options_.norm, aperture);

  // Step 5.
  result.status = suppress_non_maxima(dx, dy, magnitude, limits.low, limits.high, classes);
  if (result.status != Status::ok) return result;

  // Step 6.
  const HysteresisResult traced = hysteresis(classes, memory_.stack, edges, trace);
  return {traced.status, thresholds.low, thresholds.high, traced.strong, traced.edges};
}

}  // namespace straightedge
