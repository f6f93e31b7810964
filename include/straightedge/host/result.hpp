// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <utility>
#include <variant>

namespace straightedge {

/// What kind of trouble a host function ran into; the program's exit codes are made from it.
enum class Problem {
  bad_option = 2,    ///< the caller asked for something out of range
  cannot_read = 3,   ///< a file cannot be opened or read
  cannot_write = 4,  ///< a file cannot be written
  bad_content = 5,   ///< a file was read, but what is in it is not what it should be
  internal = 70,     ///< a fault of this library
};

/// One clear sentence, with the file's name where a file is concerned.
struct Failure {
  Problem problem = Problem::internal;
  std::string sentence;
};

/// A value, or the sentence that says why there is none.
template <class T>
class [[nodiscard]] Result {
 public:
  Result(T value) : content_(std::move(value)) {}
  Result(Failure failure) : content_(std::move(failure)) {}

  explicit operator bool() const noexcept { return std::holds_alternative<T>(content_); }
  T& value() { return std::get<T>(content_); }
  const T& value() const { return std::get<T>(content_); }
  T& operator*() { return value(); }
  const T& operator*() const { return value(); }
  T* operator->() { return &value(); }
  const T* operator->() const { return &value(); }
  const Failure& failure() const { return std::get<Failure>(content_); }

 private:
  std::variant<T, Failure> content_;
};

/// The result of work that gives nothing back but its success.
struct Done {};

}  // namespace straightedge
