// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

#include "straightedge/host/cloud.hpp"

namespace straightedge::io {

/// The first line that is not a comment begins with a keyword of PCD.
bool is_pcd(std::string_view bytes) noexcept;

/// Throws CloudBreach (cloud_text.hpp).
Cloud decode_pcd(std::string_view bytes);

}  // namespace straightedge::io
