// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "core_symbols.hpp"

#include <set>
#include <sstream>

namespace project {
namespace {

struct Symbol {
  std::string name;
  char kind = '?';  ///< as nm's letters: U undefined, W and V weak, T, D, B ...
  std::string section;
};

// What a compiler may call without being asked. Every C library has these, and so has every firmware.
const std::set<std::string> compiler_calls = {"memcpy",       "memmove",          "memset",
                                              "memcmp",       "__memcpy_chk",     "__memmove_chk",
                                              "__memset_chk", "__stack_chk_fail", "_GLOBAL_OFFSET_TABLE_"};

std::string trimmed(const std::string& text) {
  const auto first = text.find_first_not_of(" \t");
  if (first == std::string::npos) return "";
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

// One row: name | value | class | type | size | line | section.
std::vector<Symbol> symbols_of(const std::string& nm_output) {
  std::vector<Symbol> symbols;
  std::istringstream stream(nm_output);
  for (std::string line; std::getline(stream, line);) {
    std::vector<std::string> cells;
    std::istringstream row(line);
    for (std::string cell; std::getline(row, cell, '|');) cells.push_back(trimmed(cell));
    if (cells.size() < 6 || cells[2].size() != 1) continue;
    symbols.push_back({cells[0], cells[2][0], cells.size() > 6 ? cells[6] : ""});
  }
  return symbols;
}

bool is_ours(const std::string& name) {
  return name.find("12straightedge") != std::string::npos;
}

std::string objection_to(const Symbol& symbol, const std::set<std::string>& defined) {
  if (symbol.kind == 'U') {
    const bool known = defined.contains(symbol.name) || compiler_calls.contains(symbol.name);
    return known ? "" : "needs from outside: ";
  }
  if (symbol.name.starts_with("_GLOBAL__sub_I") || symbol.name.find("__cxx_global_var_init") == 0 ||
      symbol.section.starts_with(".init_array")) {
    return "runs before main: ";
  }
  if (symbol.name.starts_with("_ZGV")) return "guards a local static: ";
  const bool constant = symbol.section.starts_with(".data.rel.ro");
  const bool written = symbol.section.starts_with(".data") || symbol.section.starts_with(".bss") ||
                       symbol.section.starts_with(".tbss") || symbol.section.starts_with(".tdata");
  if (written && !constant) return "global memory that can be written: ";
  const bool weak = symbol.kind == 'W' || symbol.kind == 'w' || symbol.kind == 'V' || symbol.kind == 'v';
  if (weak && !is_ours(symbol.name)) return "a weak symbol that is not ours: ";
  return "";
}

}  // namespace

std::vector<std::string> symbol_breaches(const std::string& nm_output) {
  const std::vector<Symbol> symbols = symbols_of(nm_output);
  std::set<std::string> defined;
  for (const Symbol& symbol : symbols) {
    if (symbol.kind != 'U') defined.insert(symbol.name);
  }
  std::vector<std::string> breaches;
  for (const Symbol& symbol : symbols) {
    const std::string objection = objection_to(symbol, defined);
    if (!objection.empty()) breaches.push_back(objection + symbol.name);
  }
  if (symbols.empty()) breaches.push_back("no symbol at all");
  return breaches;
}

}  // namespace project
