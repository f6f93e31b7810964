// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "straightedge/host/image.hpp"
#include "straightedge/host/result.hpp"

namespace straightedge::io {

/// PNG, JPEG, BMP and TGA as 8-bit gray, by stb_image.
Result<Image<std::uint8_t>> decode_by_stb(std::string_view bytes, const std::string& name);

}  // namespace straightedge::io
