// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include "straightedge/host/localize_options.hpp"

namespace straightedge::localize {

/// The sentence about the first option that is out of its range; null when all are sound.
const char* objection_to(const LocalizeOptions& options) noexcept;

}  // namespace straightedge::localize
