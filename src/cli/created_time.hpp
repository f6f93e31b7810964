// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace straightedge::cli {

/// What --created puts into a file: NOW becomes the present in UTC, other text stays.
std::string created_time(const std::string& text);

}  // namespace straightedge::cli
