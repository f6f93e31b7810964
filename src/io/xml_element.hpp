// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <tinyxml2.h>

#include <array>
#include <optional>
#include <string>
#include <string_view>

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

  std::string_view name() const { return element_.Name(); }
  int line() const { return element_.GetLineNum(); }

  /// "line 12"; without an id of its own "line 12, covariance" or, where nothing around it has one, "image".
  std::string title() const {
    std::string title = element_.Name();
    if (const char* id = element_.Attribute("id")) return title + " " + id;
    for (const auto* above = element_.Parent()->ToElement(); above != nullptr;
         above = above->Parent()->ToElement()) {
      if (const char* id = above->Attribute("id"))
        return std::string(above->Name()) + " " + id + ", " + title;
    }
    return title;
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
    if (!number) refuse_number(name, *value);
    return number;
  }

  /// As many numbers as `Count`, blanks between them.
  template <std::size_t Count>
  std::array<double, Count> required_numbers(const char* name) const {
    const std::string value = required_text(name);
    std::string_view rest = value;
    std::array<double, Count> numbers{};
    std::size_t count = 0;
    for (std::string_view word = take_word(rest); !word.empty(); word = take_word(rest), ++count) {
      const auto number = number_from_text<double>(word);
      if (!number) refuse_number(name, word);
      if (count < Count) numbers[count] = *number;
    }
    if (count != Count) {
      refuse(std::string("`") + name + "` holds " + std::to_string(count) + " numbers where " +
             std::to_string(Count) + " are wanted");
    }
    return numbers;
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
  [[noreturn]] void refuse_number(const char* name, std::string_view value) const {
    refuse(std::string("`") + name + "` is not a number of its range (\"" + std::string(value.substr(0, 40)) +
           "\")");
  }

  template <class Value>
  Value required(std::optional<Value> value, const char* name) const {
    if (!value) refuse(std::string("has no `") + name + "`");
    return *std::move(value);
  }

  const tinyxml2::XMLElement& element_;
};

}  // namespace straightedge::io
