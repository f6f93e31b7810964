// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

#include "straightedge/image.hpp"

// What stb_image, 2.27 at least, does not notice in a file that it is given.
namespace straightedge::io {

/// False for a JPEG file with a Huffman table of more than 256 codes, which stb would write past the end of
/// its own. True for all other files.
bool jpeg_tables_fit(std::string_view file) noexcept;

/// False for a BMP or TGA file that has fewer bytes than an image of this size needs: stb reads zeros there,
/// and takes its time. True for PNG and JPEG, where stb finds the end itself.
bool is_whole(std::string_view file, Size size) noexcept;

}  // namespace straightedge::io
