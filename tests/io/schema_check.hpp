// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdlib>
#include <string>

inline bool xmllint_is_there() {
  return std::system("xmllint --version >/dev/null 2>&1") == 0;
}

inline bool keeps_the_schema(const std::string& files) {
  const std::string command =
      "xmllint --noout --schema " STRAIGHTEDGE_SCHEMA " " + files + " >/dev/null 2>&1";
  return std::system(command.c_str()) == 0;
}
