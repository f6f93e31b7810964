// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "straightedge/host/image.hpp"

namespace straightedge {

/// The colour of a plane or of a label in all pictures: the same for an id whatever else there is, far from
/// those of its neighbours in number, neither near white nor near black. 0, no plane, is a middle gray.
Rgb plane_colour(std::uint32_t id) noexcept;

/// A label image in colours: plane_colour where there is a label, and elsewhere black, or with the depth that
/// the labels belong to (raw units, 0 = no reading) a dim gray that is darker farther away; its range is that
/// of the picture. Depth under a label shades its colour a little, so that one sees the shape in it.
/// Labels that are no valid view give an empty picture; a depth of another size counts as none.
Image<Rgb> label_picture(ImageView<const std::uint16_t> labels, ImageView<const std::uint16_t> depth = {});

}  // namespace straightedge
