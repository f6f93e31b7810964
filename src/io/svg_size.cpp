// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "io/svg_size.hpp"

#include <tinyxml2.h>

namespace straightedge::io {

Size svg_size(const std::string& svg) {
  tinyxml2::XMLDocument document;
  if (document.Parse(svg.data(), svg.size()) != tinyxml2::XML_SUCCESS) return {};
  const tinyxml2::XMLElement* root = document.RootElement();
  if (root == nullptr) return {};
  return {static_cast<std::int32_t>(root->FloatAttribute("width")),
          static_cast<std::int32_t>(root->FloatAttribute("height"))};
}

}  // namespace straightedge::io
