// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "cli/threads_option.hpp"

#include "cli/number_option.hpp"

namespace straightedge::cli {

void add_threads(CLI::App& command, std::int32_t& threads) {
  add_whole(command, "--threads", threads, {0, 1024}, "N",
            "how many threads may work at once, 0 for one on each processor; results are the same for any "
            "number");
}

}  // namespace straightedge::cli
