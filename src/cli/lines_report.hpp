// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "straightedge/host/line_map_builder.hpp"

namespace straightedge::cli {

/// What happened on the way, stage by stage, for people; several lines.
std::string words_of(const LineMapReport& report, Size size);

/// The name of what a picture was taken for; "not asked" without refinement.
std::string kind_of(const LineMapReport& report);

}  // namespace straightedge::cli
