// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>

#include "straightedge/host/image_file.hpp"

namespace straightedge::io {

/// The size a header states, refused when it is empty or above `max_image_pixels`.
inline Result<Size> checked_size(std::int64_t width, std::int64_t height, const std::string& name) {
  const std::string stated = std::to_string(width) + "x" + std::to_string(height);
  if (width < 1 || height < 1)
    return Failure{Problem::bad_content, name + ": has no pixels (" + stated + ")"};
  if (width > max_image_pixels / height) {
    return Failure{Problem::bad_content,
                   name + ": is too large: " + stated + " pixels, and at most 2^28 are read"};
  }
  return Size{static_cast<std::int32_t>(width), static_cast<std::int32_t>(height)};
}

}  // namespace straightedge::io
