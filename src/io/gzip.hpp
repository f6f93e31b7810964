// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "straightedge/host/result.hpp"

namespace straightedge::io {

bool is_gzip(std::string_view bytes) noexcept;

/// What is packed in `bytes`, all members one after another; zeros may follow them. `name` is what the
/// sentences call it. bad_content: cut short, damaged, or more than `max_bytes` when unpacked, which is
/// noticed before so much memory is taken.
Result<std::string> gunzip(std::string_view bytes, std::size_t max_bytes, const std::string& name);

}  // namespace straightedge::io
