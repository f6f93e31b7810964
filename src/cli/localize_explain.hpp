// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "cli/explain_files.hpp"
#include "cli/localize_report.hpp"

namespace straightedge::cli {

/// The page and the pictures of the scan that was asked for: its readings, its lines, which walls they are,
/// the corrected pose, and the search before it where there was one.
std::vector<NamedFile> explain_scan(const LocalizeStory& story);

}  // namespace straightedge::cli
