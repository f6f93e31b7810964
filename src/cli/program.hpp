// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace straightedge::cli {

inline constexpr const char* exit_codes_text =
    "Exit codes: 0 done (an empty result too), 2 usage or an option out of range, 3 an input cannot\n"
    "be opened or read, 4 an output cannot be written, 5 the content of an input is not what it\n"
    "should be, 70 internal.";

/// "straightedge 0.1.0", as --version prints it and files carry it.
std::string version_text();

/// Reads the arguments, does the work, prints the sentence of a failure. Returns the exit code.
int run_program(int argument_count, char** arguments);

}  // namespace straightedge::cli
