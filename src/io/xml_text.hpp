// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace straightedge::io {

/// The text as XML can hold it: control characters become blanks, and bytes that are not UTF-8, or
/// stand for characters outside of XML 1.0, become U+FFFD. Escaping is left to the XML library.
std::string text_for_xml(std::string_view text);

}  // namespace straightedge::io
