// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "cli/program.hpp"

int main(int argument_count, char** arguments) {
  return straightedge::cli::run_program(argument_count, arguments);
}
