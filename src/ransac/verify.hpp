// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "ransac/labels.hpp"
#include "ransac/plane_model.hpp"
#include "straightedge/ransac_kernels.hpp"

namespace straightedge::ransac {

/// All readings with label 0, by the kernels of a set.
struct Verify {
  const Readings& readings;
  const Labels& labels;
  const RansacKernels& kernels;
  double gates = 1;  ///< how many gates are within

  // `part`: looks at every so-manieth row of a frame, block of a cloud.

  /// Sums over those within the gate of the plane; `seen` is how many there are, within or not.
  ModelSums sum_inliers(const LinearPlane& plane, std::uint32_t part, std::uint32_t& seen) const noexcept;

  /// How many are within the gate.
  std::uint32_t count_inliers(const LinearPlane& plane, std::uint32_t part) const noexcept;

  /// Gives them the label.
  void label_inliers(const LinearPlane& plane, std::uint16_t label) const noexcept;

  /// How many there are.
  std::uint32_t count_free() const noexcept;

 private:
  template <class Q>
  ModelSums sum_frame(const LinearPlane& plane, std::uint32_t part, std::uint32_t& seen) const noexcept;
  ModelSums sum_space(const LinearPlane& plane, std::uint32_t part, std::uint32_t& seen) const noexcept;
  ModelSums sum_rays(const LinearPlane& plane, std::uint32_t part, std::uint32_t& seen) const noexcept;
};

}  // namespace straightedge::ransac
