// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "io/xml_document.hpp"

#include <algorithm>
#include <string_view>

#include "io/xml_element.hpp"

namespace straightedge::io {
namespace {

int line_at(std::string_view xml, std::size_t at) {
  return 1 + static_cast<int>(std::count(xml.begin(), xml.begin() + static_cast<std::ptrdiff_t>(at), '\n'));
}

/// Only before the root element can there be a document type, and with it entities to expand.
void refuse_document_type(std::string_view xml) {
  std::size_t at = xml.starts_with("\xEF\xBB\xBF") ? 3 : 0;
  while (true) {
    at = xml.find_first_not_of(" \t\r\n", at);
    if (at == std::string_view::npos) return;
    const std::string_view rest = xml.substr(at);
    const bool comment = rest.starts_with("<!--");
    if (!comment && rest.starts_with("<!"))
      throw XmlBreach{line_at(xml, at), "has a document type, which is not read"};
    if (!comment && !rest.starts_with("<?")) return;
    const std::string_view end = comment ? "-->" : "?>";
    at = xml.find(end, at + 2);
    if (at == std::string_view::npos) return;
    at += end.size();
  }
}

std::string reason_of(tinyxml2::XMLError error) {
  switch (error) {
    case tinyxml2::XML_ELEMENT_DEPTH_EXCEEDED:
      return "its elements are nested too deeply";
    case tinyxml2::XML_ERROR_EMPTY_DOCUMENT:
      return "it is empty";
    case tinyxml2::XML_ERROR_MISMATCHED_ELEMENT:
      return "an element is not closed, or closed by another's name";
    case tinyxml2::XML_ERROR_PARSING_ATTRIBUTE:
      return "an attribute is broken or given twice";
    case tinyxml2::XML_ERROR_PARSING_ELEMENT:
      return "an element is broken";
    case tinyxml2::XML_ERROR_PARSING_TEXT:
      return "a text has no end";
    case tinyxml2::XML_ERROR_PARSING_COMMENT:
      return "a comment has no end";
    default:
      return "it is broken or ends too early";
  }
}

}  // namespace

const tinyxml2::XMLElement& parse_document(tinyxml2::XMLDocument& document, const std::string& xml) {
  if (const std::size_t zero = xml.find('\0'); zero != std::string::npos) {
    throw XmlBreach{line_at(xml, zero), "is not XML: it holds a zero byte"};
  }
  refuse_document_type(xml);
  if (document.Parse(xml.data(), xml.size()) != tinyxml2::XML_SUCCESS) {
    throw XmlBreach{document.ErrorLineNum(), "is not well-formed XML: " + reason_of(document.ErrorID())};
  }
  const tinyxml2::XMLElement* root = document.RootElement();
  if (root == nullptr) throw XmlBreach{1, "is not well-formed XML: it has no element"};
  for (const tinyxml2::XMLNode* node = document.FirstChild(); node != nullptr; node = node->NextSibling()) {
    const bool harmless = node->ToDeclaration() != nullptr || node->ToComment() != nullptr;
    if (node != root && !harmless) {
      throw XmlBreach{node->GetLineNum(),
                      "is not well-formed XML: something stands outside of the root element"};
    }
  }
  return *root;
}

}  // namespace straightedge::io
