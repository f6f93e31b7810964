// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <string>

#include "base/bordered_row.hpp"
#include "straightedge/border.hpp"
#include "support/catch.hpp"

using namespace straightedge;

namespace {

std::string with_margins(const std::string& row, int margin, Border border) {
  std::string out(static_cast<std::size_t>(margin), '?');
  out += row + out;
  fill_margins(out.data(), static_cast<int>(row.size()), margin, border);
  for (char& c : out) c = c == '\0' ? '0' : c;
  return out;
}

}  // namespace

TEST_CASE("borders look as they are drawn") {
  CHECK(with_margins("abcd", 3, Border::constant) == "000abcd000");
  CHECK(with_margins("abcd", 3, Border::replicate) == "aaaabcdddd");
  CHECK(with_margins("abcd", 3, Border::reflect) == "cbaabcddcb");
  CHECK(with_margins("abcd", 3, Border::reflect_101) == "dcbabcdcba");
}

TEST_CASE("reflections repeat when the margin is wider than the image") {
  CHECK(with_margins("ab", 5, Border::reflect) == "aabbaabbaabb");
  CHECK(with_margins("ab", 5, Border::reflect_101) == "babababababa");
  CHECK(with_margins("abc", 7, Border::reflect_101) == "bcbabcbabcbabcbab");
  CHECK(with_margins("a", 3, Border::reflect) == "aaaaaaa");
  CHECK(with_margins("a", 3, Border::reflect_101) == "aaaaaaa");
  CHECK(with_margins("a", 2, Border::constant) == "00a00");
}

TEST_CASE("indices inside stay as they are") {
  for (const Border border : {Border::constant, Border::replicate, Border::reflect, Border::reflect_101}) {
    for (int i = 0; i < 6; ++i) CHECK(border_index(i, 6, border) == i);
  }
}
