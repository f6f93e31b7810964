// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace straightedge::cli {

/// A PNG file with a text in it (chunk iTXt, keyword "Software") that image viewers show among the
/// properties. `png` is a whole PNG file; the pixels stay as they are.
std::string with_png_text(const std::string& png, const std::string& text);

}  // namespace straightedge::cli
