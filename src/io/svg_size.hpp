// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "straightedge/image.hpp"

namespace straightedge::io {

/// Width and height that a drawing states, in whole pixels; 0 x 0 for a text that is none.
Size svg_size(const std::string& svg);

}  // namespace straightedge::io
