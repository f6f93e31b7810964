// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <cmath>
#include <string>
#include <vector>

#include "catch.hpp"
#include "cloud_maker.hpp"
#include "straightedge/host/cloud.hpp"
#include "support/replaced.hpp"

using namespace straightedge;
using cloud_maker::scalar;
using io::ByteOrder;
using io::ScalarType;

namespace {

Cloud cloud_of(const std::string& bytes) {
  const auto cloud = cloud_from_bytes(bytes, "c.ply");
  if (!cloud) FAIL(cloud.failure().sentence);
  return *cloud;
}

std::string refusal_of(const std::string& bytes) {
  const auto cloud = cloud_from_bytes(bytes, "c.ply");
  REQUIRE_FALSE(cloud);
  CHECK(cloud.failure().problem == Problem::bad_content);
  return cloud.failure().sentence;
}

const std::string two_points =
    "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\nproperty float z\n"
    "end_header\n1 2 3\n4 5 6\n";

struct TypeName {
  const char* name;
  ScalarType type;
};
constexpr TypeName types[] = {
    {"char", ScalarType::int8},      {"uchar", ScalarType::uint8},    {"short", ScalarType::int16},
    {"ushort", ScalarType::uint16},  {"int", ScalarType::int32},      {"uint", ScalarType::uint32},
    {"float", ScalarType::float32},  {"double", ScalarType::float64}, {"int8", ScalarType::int8},
    {"uint8", ScalarType::uint8},    {"int16", ScalarType::int16},    {"uint16", ScalarType::uint16},
    {"int32", ScalarType::int32},    {"uint32", ScalarType::uint32},  {"float32", ScalarType::float32},
    {"float64", ScalarType::float64}};

struct Encoding {
  const char* name;
  bool ascii;
  ByteOrder order;
};
constexpr Encoding encodings[] = {{"ascii", true, ByteOrder::little},
                                  {"binary_little_endian", false, ByteOrder::little},
                                  {"binary_big_endian", false, ByteOrder::big}};

/// Numbers one after the other in one of the encodings.
class Body {
 public:
  explicit Body(const Encoding& encoding, std::string line_end = "\n")
      : encoding_(encoding), line_end_(std::move(line_end)) {}
  Body& add(double value, ScalarType type) {
    if (encoding_.ascii) {
      text_ += std::to_string(static_cast<int>(value)) + " ";
    } else {
      text_ += scalar(value, type, encoding_.order);
    }
    return *this;
  }
  void end_line() {
    if (encoding_.ascii) text_ += line_end_;
  }
  const std::string& text() const { return text_; }

 private:
  const Encoding& encoding_;
  std::string line_end_;
  std::string text_;
};

/// Two vertices with lists and other values among the coordinates; faces and an empty element before them.
std::string crowded_file(const Encoding& encoding, const std::string& line_end) {
  std::string text;
  for (const char* line : {"ply",
                           "format %",
                           "comment made by hand",
                           "obj_info num_cols 2",
                           "element face 2",
                           "property list uchar int vertex_indices",
                           "property uchar flags",
                           "element nothing 1000000000000",
                           "element camera 1",
                           "property float fov",
                           "element vertex 2",
                           "property list ushort double weights",
                           "property double z",
                           "property uchar red",
                           "property short x",
                           "property list char uchar tags",
                           "property float y",
                           "element edge 5",
                           "property int v",
                           "end_header"}) {
    text += line + line_end;
  }
  text = replaced(text, "%", std::string(encoding.name) + " 1.0");
  Body body(encoding, line_end);
  for (const int corners : {3, 4}) {
    body.add(corners, ScalarType::uint8);
    for (int i = 0; i < corners; ++i) body.add(i, ScalarType::int32);
    body.add(9, ScalarType::uint8);
    body.end_line();
  }
  body.add(60, ScalarType::float32);
  body.end_line();
  for (const int i : {0, 1}) {
    body.add(i + 1, ScalarType::uint16);
    for (int k = 0; k <= i; ++k) body.add(77, ScalarType::float64);
    body.add(30 + i, ScalarType::float64).add(255, ScalarType::uint8).add(-10 - i, ScalarType::int16);
    body.add(2 * i, ScalarType::int8);
    for (int k = 0; k < 2 * i; ++k) body.add(5, ScalarType::uint8);
    body.add(20 + i, ScalarType::float32);
    body.end_line();
  }
  return text + body.text();
}

}  // namespace

TEST_CASE("PLY: every encoding, and every type by both of its names") {
  for (const Encoding& encoding : encodings) {
    for (const TypeName& type : types) {
      INFO(encoding.name << " " << type.name);
      std::string text = std::string("ply\nformat ") + encoding.name + " 1.0\nelement vertex 50\n";
      for (const char* axis : {"x", "y", "z"})
        text += std::string("property ") + type.name + " " + axis + "\n";
      text += "end_header\n";
      const char letter = type.name[0] == 'u' ? 'U' : 'I';
      Body body(encoding);
      for (std::size_t i = 0; i < 50; ++i) {
        for (std::size_t k = 0; k < 3; ++k) body.add(cloud_maker::value_at(i, k, letter), type.type);
        body.end_line();
      }
      const Cloud cloud = cloud_of(text + body.text());
      REQUIRE(cloud.x.size() == 50);
      CHECK(cloud.width == 0);
      for (std::size_t i = 0; i < 50; ++i) {
        REQUIRE(static_cast<double>(cloud.x[i]) == cloud_maker::value_at(i, 0, letter));
        REQUIRE(static_cast<double>(cloud.y[i]) == cloud_maker::value_at(i, 1, letter));
        REQUIRE(static_cast<double>(cloud.z[i]) == cloud_maker::value_at(i, 2, letter));
      }
    }
  }
}

TEST_CASE("PLY: lists, other properties and other elements are passed over") {
  for (const Encoding& encoding : encodings) {
    for (const char* line_end : {"\n", "\r\n", "\r"}) {
      INFO(encoding.name << " line end of " << std::string(line_end).size());
      const Cloud cloud = cloud_of(crowded_file(encoding, line_end));
      CHECK(cloud.x == std::vector<float>{-10, -11});
      CHECK(cloud.y == std::vector<float>{20, 21});
      CHECK(cloud.z == std::vector<float>{30, 31});
    }
  }
}

TEST_CASE("PLY: a file that ends anywhere in its points or before is refused") {
  for (const Encoding& encoding : encodings) {
    const std::string good = crowded_file(encoding, "\n");
    for (std::size_t length = 3; length + 4 < good.size(); ++length) {
      INFO(encoding.name << " " << length << " of " << good.size());
      REQUIRE_FALSE(cloud_from_bytes(good.substr(0, length), "c.ply"));
    }
  }
}

TEST_CASE("PLY: values that are no readings, empty lines, no points") {
  const Cloud cloud = cloud_of(replaced(two_points, "1 2 3", "\n nan  -inf 1e-3 \n"));
  CHECK(std::isnan(cloud.x[0]));
  CHECK(std::isinf(cloud.y[0]));
  CHECK(cloud.z[0] == 1e-3f);
  CHECK(cloud.x[1] == 4);
  CHECK(cloud_of(replaced(two_points, "vertex 2", "vertex 0")).x.empty());
}

TEST_CASE("PLY: headers that promise too much") {
  const auto with = [](const std::string& what, const std::string& by) {
    return refusal_of(replaced(two_points, what, by));
  };
  CHECK(with("vertex 2", "vertex 1000000000000") ==
        "c.ply: its header promises 1000000000000 points, and at most 2^31 are read");
  CHECK(with("vertex 2", "vertex 2000000000") ==
        "c.ply: is truncated: its header promises 2000000000 of the element 'vertex', and it holds fewer");
  CHECK(with("vertex 2", "vertex 3").find("is truncated") != std::string::npos);
  CHECK(with("vertex 2", "vertex 99999999999999999999") ==
        "c.ply: line 3: '99999999999999999999' is no whole number from 0 up");
  for (const char* format : {"binary_little_endian", "binary_big_endian", "ascii"}) {
    std::string text = replaced(two_points, "ascii", format);
    text = replaced(text, "element vertex",
                    "element face 1000000000000\nproperty list uchar int i\nelement vertex");
    CHECK(refusal_of(text) ==
          "c.ply: is truncated: its header promises 1000000000000 of the element 'face', and it holds fewer");
  }
}

TEST_CASE("PLY: headers that make no sense") {
  const auto with = [](const std::string& what, const std::string& by) {
    return refusal_of(replaced(two_points, what, by));
  };
  CHECK(with("format ascii 1.0\n", "") == "c.ply: its header has no line `format`");
  CHECK(with("ascii 1.0", "ascii 2.0") ==
        "c.ply: line 2: the PLY format's version is '2.0', and 1.0 is read");
  CHECK(with("ascii 1.0", "text 1.0") ==
        "c.ply: line 2: 'text' is none of ascii, binary_little_endian and binary_big_endian");
  CHECK(with("end_header\n", "") == "c.ply: line 7: '1' is no keyword of a PLY header");
  CHECK(with("end_header\n1 2 3\n4 5 6\n", "") == "c.ply: its header ends without end_header");
  CHECK(with("element vertex 2\n", "") == "c.ply: line 3: a property comes before the first element");
  CHECK(with("vertex 2", "point 2") == "c.ply: its header has no element `vertex`");
  CHECK(with("vertex 2", "vertex") == "c.ply: line 3: '' is no whole number from 0 up");
  CHECK(with("float z", "float w") == "c.ply: its vertices have no properties x, y and z");
  CHECK(with("float z", "list uchar float z") == "c.ply: its vertices have no properties x, y and z");
  CHECK(with("float z", "real z") == "c.ply: line 6: 'real' is no type of a PLY property");
  CHECK(with("float z", "float") == "c.ply: line 6: a property has no name");
  CHECK(with("float z", "float z\nproperty list float int i") ==
        "c.ply: line 7: the length of a list is of no whole type");
}

TEST_CASE("PLY: data that is broken") {
  const auto with = [](const std::string& what, const std::string& by) {
    return refusal_of(replaced(two_points, what, by));
  };
  CHECK(with("4 5 6", "444 5") == "c.ply: line 9: has fewer values than a vertex has");
  CHECK(with("4 5 6", "4 5 6 7") == "c.ply: line 9: has more values than a vertex has");
  CHECK(with("4 5 6", "4 five 6") == "c.ply: line 9: 'five' is no number");
  std::string text = replaced(two_points, "ascii", "binary_little_endian");
  text = replaced(text, "element vertex", "element face 1\nproperty list char int i\nelement vertex");
  text = text.substr(0, text.find("end_header") + 11);
  CHECK(refusal_of(text + "\xFF" + std::string(24, '\0')) == "c.ply: the length of a list is negative");
}
