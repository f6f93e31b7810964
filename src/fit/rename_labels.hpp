// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>

#include "straightedge/image.hpp"

/// Label k becomes by[k].
namespace straightedge::detail {

void rename(std::span<std::uint16_t> cells, std::span<const std::uint16_t> by) noexcept;

/// The same for pixels, where it pays to look only for what changes: little, as a rule.
void rename(ImageView<std::uint16_t> labels, std::span<const std::uint16_t> by) noexcept;

bool changes_nothing(std::span<const std::uint16_t> by) noexcept;

}  // namespace straightedge::detail
