// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <random>
#include <string>

/// Changes, takes out, doubles or inserts a few bytes.
inline std::string mutated(std::string bytes, std::mt19937& generator) {
  const auto whole = [&](std::size_t high) {
    return std::uniform_int_distribution<std::size_t>(0, high)(generator);
  };
  const std::string tokens[] = {"nan",  "-1",   "1e308", "<", "/>",   "\"",      "0",
                                "&#0;", "<!--", "[",     "{", "\xFF", "id=\"3\""};
  const std::size_t changes = 1 + whole(3);
  for (std::size_t i = 0; i < changes && !bytes.empty(); ++i) {
    const std::size_t at = whole(bytes.size() - 1);
    switch (whole(4)) {
      case 0:
        bytes[at] = static_cast<char>(whole(255));
        break;
      case 1:
        bytes.erase(at, 1 + whole(8));
        break;
      case 2:
        bytes.insert(at, tokens[whole(12)]);
        break;
      case 3:
        bytes.insert(at, bytes.substr(whole(bytes.size() - 1), whole(40)));
        break;
      default:
        bytes.resize(at);
        break;
    }
  }
  return bytes;
}
