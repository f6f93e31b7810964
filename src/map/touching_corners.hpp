// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include "map/border_chain.hpp"

namespace straightedge {

/// Takes borders apart where several corners lie in one place: every way into the place is followed by
/// the way out that comes first clockwise, so that no border runs through the angle of another. Two pieces
/// that hung together in a corner become two borders; a hole that touches its outer border becomes a bay of
/// it. `outer` and `holes` are found anew, by the sense of rotation.
void separate_touching(Borders& borders);

}  // namespace straightedge
