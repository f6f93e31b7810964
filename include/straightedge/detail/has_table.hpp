// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <type_traits>

namespace straightedge::detail {

/// Whether a table of kernels is there. In constant expressions it is taken to be: GCC's sanitizers make the
/// address of a table elsewhere no constant to compare, and `prepare` looks again when the program runs.
template <class Table>
constexpr bool has_table(const Table* table) noexcept {
  return std::is_constant_evaluated() || table != nullptr;
}

}  // namespace straightedge::detail
