// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <bit>
#include <cstdint>
#include <random>
#include <string>

#include "catch.hpp"
#include "io/base64.hpp"
#include "io/number_text.hpp"
#include "io/xml_text.hpp"

using namespace straightedge::io;

TEST_CASE("every double survives its text, bit by bit") {
  std::mt19937_64 generator(7);
  for (int i = 0; i < 20000; ++i) {
    const auto value = std::bit_cast<double>(generator());
    if (!(value - value == 0)) continue;
    const auto back = number_from_text<double>(to_text(value));
    REQUIRE(back);
    REQUIRE(std::bit_cast<std::uint64_t>(*back) == std::bit_cast<std::uint64_t>(value));
  }
  CHECK(to_text(0.05) == "0.05");
  CHECK(to_text(-0.0) == "-0");
  CHECK(to_text(5e-324) == "5e-324");
  CHECK(to_text(1e300) == "1e+300");
  CHECK(to_text(2.5, 2) == "2.50");
}

TEST_CASE("a number is the whole text or none") {
  CHECK(number_from_text<double>(" +1.5\n") == 1.5);
  CHECK(number_from_text<double>(".5") == 0.5);
  CHECK(number_from_text<int>("12") == 12);
  for (const char* text : {"", " ", "1,5", "1.5x", "+-1", "++1", "0x10", "1 2", "1e400", "-"}) {
    INFO(text);
    CHECK_FALSE(number_from_text<double>(text));
  }
  CHECK_FALSE(number_from_text<std::uint32_t>("-1"));
  CHECK_FALSE(number_from_text<std::uint32_t>("4294967296"));
  CHECK_FALSE(number_from_text<std::uint32_t>("1.0"));
}

TEST_CASE("texts become what XML can hold") {
  CHECK(text_for_xml("Stra\xC3\x9F"
                     "e \xE2\x82\xAC \xF0\x9F\x98\x80") ==
        "Stra\xC3\x9F"
        "e \xE2\x82\xAC \xF0\x9F\x98\x80");
  CHECK(text_for_xml("a\tb\nc\rd\x01"
                     "e") == "a b c d e");
  CHECK(text_for_xml("gr\xFC"
                     "n") == "gr\xEF\xBF\xBDn");
  CHECK(text_for_xml("\xC3") == "\xEF\xBF\xBD");
  CHECK(text_for_xml("\xED\xA0\x80") == "\xEF\xBF\xBD\xEF\xBF\xBD\xEF\xBF\xBD");  // a lone surrogate
  CHECK(text_for_xml("\xC0\x80") == "\xEF\xBF\xBD\xEF\xBF\xBD");                  // a longer form than needed
  const std::string once = text_for_xml("\xFF\x00\x80z");
  CHECK(text_for_xml(once) == once);
}

TEST_CASE("base64 as RFC 4648 gives it") {
  CHECK(base64("") == "");
  CHECK(base64("f") == "Zg==");
  CHECK(base64("fo") == "Zm8=");
  CHECK(base64("foo") == "Zm9v");
  CHECK(base64("foobar") == "Zm9vYmFy");
  CHECK(base64("\xFB\xFF\xFE") == "+//+");
}
