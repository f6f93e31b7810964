// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace project {

/// Reads what `nm --format=sysv` prints of a library and says, one sentence each, what firmware could not
/// live with: a function that somebody else would have to provide, work before main, a guarded local
/// static, memory that is written to outside the caller's, a weak symbol of somebody else's.
std::vector<std::string> symbol_breaches(const std::string& nm_output);

}  // namespace project
