// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "ransac/labels.hpp"
#include "ransac/plane_model.hpp"
#include "ransac/rows.hpp"
#include "straightedge/ransac_planes.hpp"

namespace straightedge::ransac {

/// The readings on which hypotheses are made and scored.
struct Subset {
  const Readings& readings;
  const detail::RansacPlanesMemory& memory;
  std::uint32_t count = 0;

  Rows rows() const noexcept {
    return {memory.x.data(), memory.y.data(), memory.z.data(), memory.w.data(), padded(count)};
  }
  Reading coordinates(std::uint32_t i) const noexcept {
    Reading r;
    r.x = static_cast<double>(memory.first[i]);
    r.y = static_cast<double>(memory.second[i]);
    r.z = static_cast<double>(memory.third[i]);
    return r;
  }
};

/// Step 1, of a cloud with so many readings left. One by chance of each of at most options.subset equal parts
/// of the readings with label 0: squares of a frame's pixels, runs of a cloud's readings. Every eighth part
/// comes first, then every eighth beside these, and so on: the first readings are spread over everything, as
/// all of them are. False: the cloud has fewer readings than that.
[[nodiscard]] bool draw_subset(Subset& subset, const Labels& labels, const RansacOptions& options,
                               std::uint32_t left, std::uint64_t stream) noexcept;

/// Numbers of the subset's members within the radius of number i, itself left out, into memory.near.
std::uint32_t find_near(const Subset& subset, std::uint32_t i, double radius) noexcept;

Coefficients coefficients(const LinearPlane& plane) noexcept;

}  // namespace straightedge::ransac
