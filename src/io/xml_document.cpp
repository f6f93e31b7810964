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

/// Where the root element begins, or the end. Only before the root can there be a document type, and with it
/// entities to expand: it is refused.
std::size_t skip_prolog(std::string_view xml) {
  std::size_t at = xml.starts_with("\xEF\xBB\xBF") ? 3 : 0;
  while (true) {
    at = xml.find_first_not_of(blanks, at);
    if (at == std::string_view::npos) return xml.size();
    const std::string_view rest = xml.substr(at);
    const bool comment = rest.starts_with("<!--");
    if (!comment && rest.starts_with("<!"))
      throw XmlBreach{line_at(xml, at), "has a document type, which is not read"};
    if (!comment && !rest.starts_with("<?")) return at;
    const std::string_view end = comment ? "-->" : "?>";
    at = xml.find(end, at + 2);
    if (at == std::string_view::npos) return xml.size();
    at += end.size();
  }
}

/// The position of the > that ends the tag at `at`, quoted ones passed over; the end when there is none.
std::size_t end_of_tag(std::string_view xml, std::size_t at) {
  char quote = 0;
  for (; at < xml.size(); ++at) {
    const char c = xml[at];
    if (quote != 0) {
      if (c == quote) quote = 0;
    } else if (c == '"' || c == '\'') {
      quote = c;
    } else if (c == '>') {
      return at;
    }
  }
  return xml.size();
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
  (void)skip_prolog(xml);
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

const tinyxml2::XMLElement& parse_root_tag(tinyxml2::XMLDocument& document, const std::string& xml) {
  std::string head = xml.substr(0, end_of_tag(xml, skip_prolog(xml)));
  if (head.size() < xml.size()) head += head.ends_with('/') ? ">" : "/>";
  return parse_document(document, head);
}

}  // namespace straightedge::io
