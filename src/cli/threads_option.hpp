// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>

namespace straightedge::cli {

/// --threads, for commands whose work can be shared out. The library's own meaning: 0 is one a processor.
void add_threads(CLI::App& command, std::int32_t& threads);

}  // namespace straightedge::cli
