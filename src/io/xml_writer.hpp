// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <tinyxml2.h>

#include <concepts>
#include <optional>
#include <span>
#include <string>

#include "io/number_text.hpp"
#include "io/xml_text.hpp"

namespace straightedge::io {

/// One element after the other; numbers as this library spells them, texts as the XML library escapes them.
class XmlWriter {
 public:
  void open(const char* element) { printer_.OpenElement(element); }
  void close() { printer_.CloseElement(); }

  void attribute(const char* name, const std::string& text) {
    printer_.PushAttribute(name, text_for_xml(text).c_str());
  }
  void attribute(const char* name, const char* text) { printer_.PushAttribute(name, text); }
  void attribute(const char* name, double value) { printer_.PushAttribute(name, to_text(value).c_str()); }
  void attribute(const char* name, std::integral auto value) {
    printer_.PushAttribute(name, to_text(value).c_str());
  }
  void attribute(const char* name, std::span<const double> values) {
    std::string text;
    for (const double value : values) {
      if (!text.empty()) text += ' ';
      text += to_text(value);
    }
    printer_.PushAttribute(name, text.c_str());
  }
  template <class Value>
  void attribute(const char* name, const std::optional<Value>& value) {
    if (value) attribute(name, *value);
  }
  void attribute_unless_empty(const char* name, const std::string& text) {
    if (!text.empty()) attribute(name, text);
  }

  void declaration() { printer_.PushDeclaration("xml version=\"1.0\" encoding=\"UTF-8\""); }
  std::string text() const { return {printer_.CStr(), static_cast<std::size_t>(printer_.CStrSize() - 1)}; }

 private:
  tinyxml2::XMLPrinter printer_;
};

}  // namespace straightedge::io
