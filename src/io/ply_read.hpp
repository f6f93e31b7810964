// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

#include "straightedge/host/cloud.hpp"

namespace straightedge::io {

bool is_ply(std::string_view bytes) noexcept;

/// The element `vertex`; what stands before it is passed over, what follows is not looked at. Throws
/// CloudBreach (cloud_text.hpp).
Cloud decode_ply(std::string_view bytes);

}  // namespace straightedge::io
