// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "cli/created_time.hpp"

#include <ctime>

namespace straightedge::cli {

std::string created_time(const std::string& text) {
  if (text != "NOW") return text;
  const std::time_t now = std::time(nullptr);
  std::tm utc{};
  char written[32] = "";
  if (::gmtime_r(&now, &utc) != nullptr)
    (void)std::strftime(written, sizeof written, "%Y-%m-%dT%H:%M:%SZ", &utc);
  return written;
}

}  // namespace straightedge::cli
