// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "ransac/frame_labels.hpp"

#include <array>

#include "ransac/frame_block.hpp"
#include "ransac/plane_model.hpp"

namespace straightedge::ransac {
namespace {

constexpr std::size_t planes_in_a_pass = 16;

/// The nearest plane so far of each pixel of a block.
struct Nearest {
  float squared[FrameBlock::capacity];
  std::uint32_t label[FrameBlock::capacity];

  explicit Nearest(const FrameBlock& block) noexcept {
    block.limits(squared);
    for (std::int32_t i = 0; i < block.count; ++i) label[i] = 0;
  }
  void offer(const FrameBlock& block, float a, float c, std::uint32_t plane_label) noexcept {
    for (std::int32_t i = 0; i < block.count; ++i) {
      const float r = block.q[i] - (a * static_cast<float>(i) + c);
      const bool nearer = r * r < squared[i];
      squared[i] = nearer ? r * r : squared[i];
      label[i] = nearer ? plane_label : label[i];
    }
  }
};

}  // namespace

std::uint32_t label_nearest_pixels(const Readings& readings, std::span<const FoundPlane> planes,
                                   std::span<std::uint16_t> labels) noexcept {
  std::uint32_t labelled = 0;
  std::size_t first = 0;
  for (std::int32_t v = 0; v < readings.size().height; ++v) {
    for (std::int32_t u = 0; u < readings.size().width; u += FrameBlock::capacity) {
      const FrameBlock block(readings, u, v);
      Nearest nearest(block);
      for (std::size_t j = 0; j < planes.size(); ++j) {
        const LinearPlane p = to_linear(planes[j].fit.plane, readings);
        nearest.offer(block, static_cast<float>(-p.x), static_cast<float>(-(p.x * u + p.y * v + p.w)),
                      static_cast<std::uint32_t>(j + 1));
      }
      for (std::int32_t i = 0; i < block.count; ++i) {
        labels[first++] = static_cast<std::uint16_t>(nearest.label[i]);
        labelled += nearest.label[i] != 0 ? 1U : 0U;
      }
    }
  }
  return labelled;
}

void refit_labelled_pixels(const Readings& readings, std::span<const std::uint16_t> labels,
                           std::span<FoundPlane> planes) noexcept {
  for (std::size_t first = 0; first < planes.size(); first += planes_in_a_pass) {
    std::array<InverseDepthMoments, planes_in_a_pass> sums{};
    const std::uint16_t* label = labels.data();
    Reading r;
    for (std::int32_t v = 0; v < readings.size().height; ++v) {
      for (std::int32_t u = 0; u < readings.size().width; ++u, ++label) {
        const std::size_t index = *label - std::size_t{1} - first;
        if (index < planes_in_a_pass && readings.read_pixel(u, v, r)) sums[index].add(r.x, r.y, r.z);
      }
    }
    for (std::size_t j = 0; j < planes_in_a_pass && first + j < planes.size(); ++j) {
      FoundPlane& plane = planes[first + j];
      plane.inliers = static_cast<std::uint32_t>(sums[j].n);
      (void)fit_rays(sums[j], readings, plane.fit);
    }
  }
}

}  // namespace straightedge::ransac
