// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include "straightedge/host/result.hpp"

namespace straightedge::cli {

/// Data for another program. Fails with `cannot_write`.
Result<Done> write_stdout(std::string_view bytes);

/// A line for a person, on stderr.
void print_words(const std::string& line);

/// Names of files may hold anything; a sentence stays on its line.
std::string one_line(std::string text);

}  // namespace straightedge::cli
