// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

#include "map/picture_rows.hpp"
#include "straightedge/line_fit.hpp"

namespace straightedge {

/// Places one after the other on one line.
struct StraightPart {
  std::int32_t first = 0, end = 0;  ///< of the batch; `end` is the one behind the last
  LineMoments moments;              ///< of those inside, about the strip's own point
  LineFit fit;                      ///< about that point, too
};

/// The part of a followed edge that is straight. `places` are in their order along it, and find_inside has
/// told with this `strip` which of them count.
///
/// 1. Lay a line through the places (line_fit.hpp). When it leaves little over, they are straight.
/// 2. Else try every place k as a bend. Let r be the distance of a place from the line and t where it lies
///    along it, from the centroid. With a bend the line's course is a + b t, and c h more, h = max(0, t −
///    t_k). By least squares c = S / N, with S = sum(w r h) and N = sum(w h²) − sum(w h)² / sum(w) − sum(w h
///    t)² / sum(w t²), and that takes S² / N off sum(w r²). All sums over h come from sums over the places
///    beyond k, so that a pass from the end to the beginning tries every k.
/// 3. The k that takes off most is a bend if it takes off most of what there was; grain and staircases leave
///    too much. Go on with the longer side from step 1.
///
/// Nothing: too few places for a line. Time linear in the places for each bend.
std::optional<StraightPart> find_straight_part(const StripBatch& places, const StripRule& strip) noexcept;

}  // namespace straightedge
