// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "catch.hpp"
#include "temporary_folder.hpp"

/// What a reader of files says of a text that it must refuse, without the file's name in front.
template <class Read>
std::string refusal_by(Read read, const std::string& text) {
  const TemporaryFolder folder;
  const auto file = folder.put("t.txt", text);
  const auto got = read(file);
  INFO(text);
  REQUIRE_FALSE(got);
  CHECK(got.failure().problem == straightedge::Problem::bad_content);
  const std::string name = file.string() + ": ";
  REQUIRE(got.failure().sentence.starts_with(name));
  return got.failure().sentence.substr(name.size());
}
