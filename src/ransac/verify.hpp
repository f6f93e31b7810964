// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>

#include "ransac/plane_model.hpp"

namespace straightedge::ransac {

/// Sums over all readings with label 0 within the gate of the plane.
ModelSums sum_inliers(const Readings& readings, std::span<const std::uint16_t> labels,
                      const LinearPlane& plane) noexcept;

/// Gives the label to all readings with label 0 within the gate of the plane. Returns how many.
std::uint32_t label_inliers(const Readings& readings, const LinearPlane& plane, std::uint16_t label,
                            std::span<std::uint16_t> labels) noexcept;

/// Readings with label 0.
std::uint32_t count_readings(const Readings& readings, std::span<const std::uint16_t> labels) noexcept;

}  // namespace straightedge::ransac
