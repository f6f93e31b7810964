// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "straightedge/canny.hpp"
#include "support/guarded_image.hpp"
#include "support/random_image.hpp"

// The stages with memory of their own, for tests.
namespace stages {

using namespace straightedge;
using support::GrayImage;
using support::GuardedImage;
using GradientImage = GuardedImage<std::int16_t>;
using MagnitudeImage = GuardedImage<std::int32_t>;

inline std::vector<std::uint16_t> kernel(int size, double sigma) {
  std::vector<std::uint16_t> taps(static_cast<std::size_t>(size));
  if (make_gaussian_kernel(sigma, taps) != Status::ok) taps.clear();
  return taps;
}

inline Status blur(GrayView gray, const std::vector<std::uint16_t>& taps, Border border,
                   ImageView<std::uint8_t> out) {
  std::vector<std::uint16_t> columns(static_cast<std::size_t>(gray.width) + taps.size());
  std::vector<std::uint32_t> sums(static_cast<std::size_t>(gray.width));
  return gaussian_blur(gray, taps, border, {columns, sums}, out);
}

inline Status gradient(GrayView gray, int aperture, Border border, GradientScale scale,
                       ImageView<std::int16_t> dx, ImageView<std::int16_t> dy) {
  const std::size_t length = static_cast<std::size_t>(gray.width) + 6;
  std::vector<std::int16_t> smoothed(length), difference(length);
  return sobel(gray, aperture, border, scale, {smoothed, difference}, dx, dy);
}

/// A prepared detector with the memory it needs.
struct Detector {
  Detector(Size size, const CannyOptions& options)
      : workspace(Canny::workspace_bytes(size, options), std::byte{0xCD}),
        status(Canny::prepare(canny, size, options, workspace)) {}

  std::vector<std::byte> workspace;
  Canny canny;
  Status status;
};

inline GrayImage edges_of(const GrayImage& gray, const CannyOptions& options) {
  Detector detector(gray.size(), options);
  GrayImage edges(gray.size());
  if (detector.canny.run(gray.view(), edges.view()).status != Status::ok) edges.at(0, 0) = 77;
  return edges;
}

}  // namespace stages
