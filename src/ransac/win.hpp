// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include "ransac/consensus.hpp"
#include "ransac/verify.hpp"

namespace straightedge::ransac {

/// Step 6 of ransac_planes.hpp. Of the candidates that may be the best the one with the most readings,
/// counted on an eighth of the rows of a frame or the blocks of a cloud.
LinearPlane win(const Verify& all, const Subset& subset, const Consensus& found) noexcept;

}  // namespace straightedge::ransac
