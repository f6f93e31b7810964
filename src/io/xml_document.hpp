// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <tinyxml2.h>

#include <string>

namespace straightedge::io {

/// Parses the text and gives the one root element. Throws XmlBreach (xml_element.hpp) for what is not
/// well-formed, for a document type, for zero bytes and for content after the root.
const tinyxml2::XMLElement& parse_document(tinyxml2::XMLDocument& document, const std::string& xml);

/// Reads no further than the root's own tag, whose attributes it gives; what follows may be anything.
const tinyxml2::XMLElement& parse_root_tag(tinyxml2::XMLDocument& document, const std::string& xml);

}  // namespace straightedge::io
