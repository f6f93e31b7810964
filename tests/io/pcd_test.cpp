// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <cmath>
#include <limits>
#include <string>

#include "catch.hpp"
#include "cloud_maker.hpp"
#include "straightedge/host/cloud.hpp"
#include "support/replaced.hpp"
#include "temporary_folder.hpp"

using namespace straightedge;
using cloud_maker::Pcd;

namespace {

Cloud cloud_of(const std::string& bytes) {
  const auto cloud = cloud_from_bytes(bytes, "c.pcd");
  if (!cloud) FAIL(cloud.failure().sentence);
  return *cloud;
}

std::string refusal_of(const std::string& bytes) {
  const auto cloud = cloud_from_bytes(bytes, "c.pcd");
  REQUIRE_FALSE(cloud);
  CHECK(cloud.failure().problem == Problem::bad_content);
  return cloud.failure().sentence;
}

/// The cloud is what the maker says, x y z being values `first` and on of each point.
void check_values(const Cloud& cloud, const Pcd& file, std::size_t first, char letter) {
  REQUIRE(cloud.x.size() == file.points());
  REQUIRE(cloud.y.size() == file.points());
  REQUIRE(cloud.z.size() == file.points());
  for (std::size_t i = 0; i < file.points(); ++i) {
    REQUIRE(static_cast<double>(cloud.x[i]) == cloud_maker::value_at(i, first, letter));
    REQUIRE(static_cast<double>(cloud.y[i]) == cloud_maker::value_at(i, first + 1, letter));
    REQUIRE(static_cast<double>(cloud.z[i]) == cloud_maker::value_at(i, first + 2, letter));
  }
}

const std::string three_points =
    "VERSION .7\nFIELDS x y z\nWIDTH 3\nHEIGHT 1\nPOINTS 3\nDATA ascii\n1 2 3\n4 5 6\n7 8 9\n";

}  // namespace

TEST_CASE("PCD: every encoding and every type of coordinates gives the same points") {
  for (const char* encoding : {"ascii", "binary", "binary_compressed"}) {
    for (const auto& [letter, size] : {std::pair{'F', 4},
                                       {'F', 8},
                                       {'I', 1},
                                       {'I', 2},
                                       {'I', 4},
                                       {'I', 8},
                                       {'U', 1},
                                       {'U', 2},
                                       {'U', 4},
                                       {'U', 8}}) {
      INFO(encoding << " " << letter << size);
      Pcd file;
      file.encoding = encoding;
      file.fields.clear();
      for (const char* name : {"x", "y", "z"}) {
        file.fields.push_back({name, letter, static_cast<std::size_t>(size)});
      }
      const Cloud cloud = cloud_of(file.bytes());
      check_values(cloud, file, 0, letter);
      CHECK(cloud.width == 6);
      CHECK(cloud.view().valid());
    }
  }
}

TEST_CASE("PCD: other fields of any size and count are passed over") {
  for (const char* encoding : {"ascii", "binary", "binary_compressed"}) {
    INFO(encoding);
    Pcd file;
    file.encoding = encoding;
    file.height = 1;
    file.fields = {{"_", 'U', 1, 3}, {"histogram", 'F', 8, 33}, {"x"}, {"y"}, {"z"}, {"none", 'F', 4, 0},
                   {"rgb", 'U', 4},  {"label", 'I', 2, 2}};
    const Cloud cloud = cloud_of(file.bytes());
    check_values(cloud, file, 36, 'F');
    CHECK(cloud.width == 0);
  }
}

TEST_CASE("PCD: line ends of other systems, comments and empty lines") {
  for (const char* encoding : {"ascii", "binary", "binary_compressed"}) {
    Pcd file;
    file.encoding = encoding;
    file.line_end = "\r\n";
    INFO(encoding);
    check_values(cloud_of(file.bytes()), file, 0, 'F');
    const std::string more = "# made by hand\r\n\r\n#\r\nVERSION";
    check_values(cloud_of(replaced(file.bytes(), "VERSION", more)), file, 0, 'F');
  }
  const Cloud cloud = cloud_of(replaced(three_points, "4 5 6", "\n# half\n  4\t5   6 "));
  CHECK(cloud.y == std::vector<float>{2, 5, 8});
  CHECK(cloud_of(three_points.substr(0, three_points.size() - 1)).z == std::vector<float>{3, 6, 9});
}

TEST_CASE("PCD: old and short headers") {
  CHECK(cloud_of(three_points).x == std::vector<float>{1, 4, 7});
  CHECK(cloud_of(replaced(three_points, "FIELDS", "COLUMNS")).x.size() == 3);
  CHECK(cloud_of(replaced(three_points, "VERSION .7\n", "")).x.size() == 3);
  CHECK(cloud_of(replaced(three_points, "POINTS 3\n", "")).x.size() == 3);
  CHECK(cloud_of(replaced(three_points, "WIDTH 3\nHEIGHT 1\n", "")).x.size() == 3);
  CHECK(cloud_of(replaced(three_points, "VERSION .7", "VERSION 0.5")).x.size() == 3);
}

TEST_CASE("PCD: values that are no readings stay in their places") {
  const Cloud cloud = cloud_of(replaced(three_points, "4 5 6", "nan NaN -nan"));
  REQUIRE(cloud.x.size() == 3);
  CHECK(std::isnan(cloud.x[1]));
  CHECK(std::isnan(cloud.y[1]));
  CHECK(std::isnan(cloud.z[1]));
  CHECK(cloud.x[2] == 7);
  const Cloud far = cloud_of(replaced(three_points, "4 5 6", "inf -inf 1e300"));
  CHECK(far.x[1] == std::numeric_limits<float>::infinity());
  CHECK(far.y[1] == -std::numeric_limits<float>::infinity());
  CHECK(far.z[1] == std::numeric_limits<float>::infinity());
}

TEST_CASE("PCD: the viewpoint") {
  Pcd file;
  file.viewpoint = "1 -2 3.5 0 1 0 0";
  const Cloud cloud = cloud_of(file.bytes());
  CHECK(cloud.viewpoint.translation == Vector3{1, -2, 3.5});
  CHECK(cloud.viewpoint.turned({1, 2, 3}) == Vector3{1, -2, -3});
  CHECK(cloud_of(three_points).viewpoint == Pose{});
  const auto refusal = [&](const std::string& viewpoint) {
    file.viewpoint = viewpoint;
    return refusal_of(file.bytes());
  };
  CHECK(refusal("0 0 0 0 0 0 0") == "c.pcd: line 9: VIEWPOINT: the quaternion is zero");
  CHECK(refusal("0 0 0 2 0 0 0") == "c.pcd: line 9: VIEWPOINT: the quaternion's length is not 1");
  CHECK(refusal("0 0 0 1 0 0") == "c.pcd: line 9: VIEWPOINT has not the 7 numbers tx ty tz qw qx qy qz");
  CHECK(refusal("0 nan 0 1 0 0 0") == "c.pcd: line 9: 'nan' is no finite number");
}

TEST_CASE("PCD: no points are an empty cloud") {
  for (const char* encoding : {"ascii", "binary", "binary_compressed"}) {
    Pcd file;
    file.width = 0;
    file.encoding = encoding;
    const Cloud cloud = cloud_of(file.bytes());
    CHECK(cloud.x.empty());
    CHECK(cloud.width == 0);
  }
}

TEST_CASE("PCD: headers that promise too much") {
  const auto with = [](const std::string& what, const std::string& by) {
    return refusal_of(replaced(three_points, what, by));
  };
  CHECK(with("WIDTH 3\nHEIGHT 1\nPOINTS 3", "WIDTH 1000000000000\nHEIGHT 1\nPOINTS 1000000000000") ==
        "c.pcd: its header promises 1000000000000 points, and at most 2^31 are read");
  CHECK(with("WIDTH 3\nHEIGHT 1\nPOINTS 3", "WIDTH 1000000\nHEIGHT 1000000") ==
        "c.pcd: its header promises 1000000000000 points, and at most 2^31 are read");
  CHECK(with("WIDTH 3\nHEIGHT 1\nPOINTS 3", "WIDTH 18446744073709551615\nHEIGHT 18446744073709551615") ==
        "c.pcd: its header promises 18446744073709551615 points, and at most 2^31 are read");
  CHECK(with("WIDTH 3\nHEIGHT 1\nPOINTS 3", "WIDTH 2000000000") ==
        "c.pcd: is truncated: its header promises 2000000000 points, and it holds fewer");
  CHECK(with("WIDTH 3\nHEIGHT 1\nPOINTS 3", "WIDTH 4\nPOINTS 4") ==
        "c.pcd: is truncated: its header promises 4 points, and it holds fewer");
  CHECK(with("POINTS 3", "POINTS 4") == "c.pcd: its header promises 4 points, but WIDTH times HEIGHT is 3");
  CHECK(with("DATA ascii", "COUNT 1 1 300000000\nDATA ascii") ==
        "c.pcd: the field 'z' has a COUNT above 2^28");
  Pcd file;
  for (const char* encoding : {"binary", "binary_compressed"}) {
    INFO(encoding);
    file.encoding = encoding;
    std::string promise = replaced(file.bytes(), "WIDTH 6", "WIDTH 6000000");
    promise = replaced(promise, "POINTS 12", "POINTS 12000000");
    CHECK(refusal_of(promise).starts_with("c.pcd: "));
    for (std::size_t missing = 1; missing <= 40; ++missing) {
      CHECK(refusal_of(file.bytes().substr(0, file.bytes().size() - missing)).find("truncated") !=
            std::string::npos);
    }
  }
}

TEST_CASE("PCD: headers that make no sense") {
  const auto with = [](const std::string& what, const std::string& by) {
    return refusal_of(replaced(three_points, what, by));
  };
  CHECK(with("FIELDS x y z", "FIELDS x y w") == "c.pcd: its header has no fields x, y and z");
  CHECK(with("FIELDS x y z\n", "") == "c.pcd: its header has no FIELDS");
  CHECK(with("WIDTH", "SIZE 4 4\nWIDTH") ==
        "c.pcd: its header's FIELDS, SIZE, TYPE and COUNT differ in number");
  CHECK(with("WIDTH", "SIZE 4 4 3\nWIDTH") == "c.pcd: the field 'z' has a SIZE of none of 1, 2, 4, 8");
  CHECK(with("WIDTH", "SIZE 4 4 2\nWIDTH") == "c.pcd: the field 'z' is of a TYPE and SIZE that is no number");
  CHECK(with("WIDTH", "TYPE F F Q\nWIDTH") == "c.pcd: the field 'z' is of a TYPE and SIZE that is no number");
  CHECK(with("WIDTH 3", "WIDTH -3") == "c.pcd: line 3: '-3' is no whole number from 0 up");
  CHECK(with("WIDTH 3\nHEIGHT 1\nPOINTS 3\n", "") == "c.pcd: its header has neither WIDTH nor POINTS");
  CHECK(with("WIDTH 3", "BREADTH 3") == "c.pcd: line 3: 'BREADTH' is no keyword of a PCD header");
  CHECK(with("VERSION .7", "VERSION 2") ==
        "c.pcd: line 1: the version of the PCD format is '2', and up to 0.7 is read");
  CHECK(with("DATA ascii", "DATA zip") ==
        "c.pcd: line 6: DATA is 'zip', none of ascii, binary and binary_compressed");
  CHECK(refusal_of(three_points.substr(0, three_points.find("DATA"))) ==
        "c.pcd: its header ends without DATA");
}

TEST_CASE("PCD: data that is broken") {
  CHECK(refusal_of(replaced(three_points, "4 5 6", "444 5")) ==
        "c.pcd: line 8: has 2 values where a point has 3");
  CHECK(refusal_of(replaced(three_points, "4 5 6", "4 5 6 7")) ==
        "c.pcd: line 8: has 4 values where a point has 3");
  CHECK(refusal_of(replaced(three_points, "4 5 6", "4,5 5 6")) == "c.pcd: line 8: '4,5' is no number");
  Pcd file;
  file.encoding = "binary_compressed";
  const std::string good = file.bytes();
  std::string bad = good;
  bad[file.header().size() + 8] = '\x20';  // looks back before the start
  CHECK(refusal_of(bad) == "c.pcd: its compressed data is broken");
  bad = good;
  bad[file.header().size() + 4] = '\x7f';
  CHECK(refusal_of(bad) ==
        "c.pcd: its compressed data is said to hold 127 bytes, which is not what its header promises");
}

TEST_CASE("clouds: files that are none, and missing ones") {
  CHECK(refusal_of("") == "c.pcd: is neither a PCD nor a PLY file");
  CHECK(refusal_of("# only a comment") == "c.pcd: is neither a PCD nor a PLY file");
  CHECK(refusal_of("\x89PNG\r\n\x1a\n") == "c.pcd: is neither a PCD nor a PLY file");
  const TemporaryFolder folder;
  REQUIRE(read_cloud(folder.put("c.pcd", three_points)));
  const auto missing = read_cloud(folder / "no.pcd");
  REQUIRE_FALSE(missing);
  CHECK(missing.failure().problem == Problem::cannot_read);
  const auto bad = read_cloud(folder.put("bad.pcd", "VERSION 0.7\n"));
  REQUIRE_FALSE(bad);
  CHECK(bad.failure().sentence == (folder / "bad.pcd").string() + ": its header ends without DATA");
}
