// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <tinyxml2.h>

#include <optional>
#include <string>

#include "io/number_text.hpp"
#include "straightedge/host/result.hpp"

namespace straightedge::io {

/// Thrown while a document is read, caught where the reading began: the list of attributes of an
/// element then reads as a list.
struct XmlBreach {
  int line = 0;
  std::string sentence;
};

/// An element whose attributes are read by name and type; what is missing or not of its type throws an
/// XmlBreach that names the element and its id.
class XmlElement {
 public:
  explicit XmlElement(const tinyxml2::XMLElement& element) : element_(element) {}

  int line() const { return element_.GetLineNum(); }

  /// "line 12" or, without an id, "image".
  std::string title() const {
    const char* id = element_.Attribute("id");
    return std::string(element_.Name()) + (id != nullptr ? std::string(" ") + id : std::string());
  }

  [[noreturn]] void refuse(const std::string& what) const { throw XmlBreach{line(), title() + ": " + what}; }

  std::optional<std::string> text(const char* name) const {
    const char* value = element_.Attribute(name);
    if (value == nullptr) return {};
    return value;
  }

  template <class Number>
  std::optional<Number> number(const char* name) const {
    const auto value = text(name);
    if (!value) return {};
    const auto number = number_from_text<Number>(*value);
    if (!number) {
      refuse(std::string("`") + name + "` is not a number of its range (\"" + value->substr(0, 40) + "\")");
    }
    return number;
  }

  std::string required_text(const char* name) const { return required(text(name), name); }

  template <class Number>
  Number required_number(const char* name) const {
    return required(number<Number>(name), name);
  }

  /// The attribute has this value, or is left out.
  void expect(const char* name, const char* wanted) const {
    const auto value = text(name);
    if (value && *value != wanted) refuse(std::string("`") + name + "` is not \"" + wanted + "\"");
  }

 private:
  template <class Value>
  Value required(std::optional<Value> value, const char* name) const {
    if (!value) refuse(std::string("has no `") + name + "`");
    return *std::move(value);
  }

  const tinyxml2::XMLElement& element_;
};

}  // namespace straightedge::io
