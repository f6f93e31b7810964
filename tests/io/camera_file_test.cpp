// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "straightedge/host/camera_file.hpp"

#include <string>

#include "catch.hpp"
#include "temporary_folder.hpp"

using namespace straightedge;

namespace {

DepthCamera camera_of(const std::string& text) {
  const TemporaryFolder folder;
  const auto camera = read_camera(folder.put("camera.json", text));
  INFO(text);
  if (!camera) FAIL(camera.failure().sentence);
  return *camera;
}

std::string refusal_of(const std::string& text) {
  const TemporaryFolder folder;
  const auto file = folder.put("camera.json", text);
  const auto camera = read_camera(file);
  INFO(text);
  REQUIRE_FALSE(camera);
  CHECK(camera.failure().problem == Problem::bad_content);
  const std::string name = file.string() + ": ";
  REQUIRE(camera.failure().sentence.starts_with(name));
  return camera.failure().sentence.substr(name.size());
}

const std::string four = R"("fx": 500, "fy": -501.5, "cx": 319.5, "cy": 2.4e2)";

std::string with(const std::string& more) {
  return "{" + four + ", " + more + "}";
}

}  // namespace

TEST_CASE("a camera with all its keys, and with the four that must be there") {
  const DepthCamera all = camera_of(with(R"("depth_scale": 5000, "width": 640, "height": 480, "k1": 0.1,
    "k2": -0.2, "p1": 0.003, "p2": 4e-4, "k3": 5, "model": "Xtion")"));
  CHECK(all.pinhole == PinholeCamera{500, -501.5, 319.5, 240});
  CHECK(all.distortion == LensDistortion{0.1, -0.2, 0.003, 4e-4, 5});
  CHECK(all.units_per_metre == 5000);
  CHECK(all.metres_per_unit() == 1.0 / 5000);
  CHECK(all.size == Size{640, 480});
  const DepthCamera few = camera_of("{" + four + "}");
  CHECK(few.units_per_metre == 1000);
  CHECK(few.distortion.none());
  CHECK_FALSE(few.size);
}

TEST_CASE("a matrix K as text, and Open3D's") {
  CHECK(camera_of("615.2 0 298.4\n0 615.3 247.5\n0 0 1\n").pinhole ==
        PinholeCamera{615.2, 615.3, 298.4, 247.5});
  CHECK(camera_of("# K\r\n5.354e+02 0. 3.201e+02\r\n0. -5.392e+02 2.476e+02\r\n0. 0. 1.").pinhole ==
        PinholeCamera{535.4, -539.2, 320.1, 247.6});
  const DepthCamera open3d = camera_of(
      R"({"width": 640, "height": 480, "intrinsic_matrix": [525.0, 0, 0, 0, 524, 0, 319.5, 239.5, 1]})");
  CHECK(open3d.pinhole == PinholeCamera{525, 524, 319.5, 239.5});
  CHECK(open3d.size == Size{640, 480});
}

TEST_CASE("wrong cameras are refused with the key") {
  CHECK(refusal_of("") == "is empty");
  CHECK(refusal_of("{") == "is not JSON");
  CHECK(refusal_of("[1, 2]") == "is not a JSON object");
  CHECK(refusal_of("{}") == "has no `fx`");
  CHECK(refusal_of(R"({"fx": 500, "fy": 500, "cy": 240})") == "has no `cx`");
  CHECK(refusal_of(R"({"fx": "500", "fy": 500, "cx": 1, "cy": 240})") == "`fx` is not a number");
  CHECK(refusal_of(R"({"fx": null, "fy": 500, "cx": 1, "cy": 240})") == "`fx` is not a number");
  CHECK(refusal_of(R"({"fx": 0, "fy": 500, "cx": 1, "cy": 240})") == "has a focal length of zero");
  CHECK(refusal_of(R"({"fx": 500, "fy": -0.0, "cx": 1, "cy": 240})") == "has a focal length of zero");
  CHECK(refusal_of(R"({"fx": NaN, "fy": 500, "cx": 1, "cy": 240})") == "is not JSON");
  CHECK(refusal_of(R"({"fx": 1e999, "fy": 500, "cx": 1, "cy": 240})") == "is not JSON");
  CHECK(refusal_of(with(R"("depth_scale": 0)")) == "`depth_scale` (units per metre) is not above zero");
  CHECK(refusal_of(with(R"("depth_scale": -1000)")) == "`depth_scale` (units per metre) is not above zero");
  CHECK(refusal_of(with(R"("depth_scale": "mm")")) == "`depth_scale` is not a number");
  CHECK(refusal_of(with(R"("k1": [0.1])")) == "`k1` is not a number");
}

TEST_CASE("wrong sizes and matrices are refused") {
  CHECK(refusal_of(with(R"("width": 640)")) == "has no `height`");
  CHECK(refusal_of(with(R"("width": 640.5, "height": 480)")) == "`width` is not a whole number above zero");
  CHECK(refusal_of(with(R"("width": -640, "height": 480)")) == "`width` is not a whole number above zero");
  CHECK(refusal_of(with(R"("width": 1e300, "height": 480)")) == "`width` is not a whole number above zero");
  CHECK(refusal_of(with(R"("width": 65536, "height": 65536)")).find("too large") != std::string::npos);
  CHECK(refusal_of("500 0 320\n0 500 240\n") == "is neither JSON nor a 3x3 matrix");
  CHECK(refusal_of("500 1 320\n0 500 240\n0 0 1") ==
        "is not the matrix of a camera: fx 0 cx, 0 fy cy, 0 0 1");
  CHECK(refusal_of("0 0 320\n0 500 240\n0 0 1") == "has a focal length of zero");
  CHECK(refusal_of("500 0 nan\n0 500 240\n0 0 1") == "line 1: 'nan' is not finite");
  CHECK(refusal_of("fx = 500") == "line 1: 'fx' is no number");
  CHECK(refusal_of(R"({"intrinsic_matrix": [1, 2, 3]})") ==
        "`intrinsic_matrix` is not a list of nine numbers");
  CHECK(refusal_of(R"({"intrinsic_matrix": [525, 0, 319.5, 0, 525, 239.5, 0, 0, 1]})") ==
        "`intrinsic_matrix` is not fx 0 0  0 fy 0  cx cy 1");
}

TEST_CASE("deep nesting and long files do no harm") {
  CHECK(refusal_of(std::string(60000, '[')) == "is not JSON");
  CHECK(refusal_of(std::string(30000, '[') + std::string(30000, ']')) == "is not a JSON object");
  CHECK(refusal_of("{" + std::string(100000, ' ')).find("longer than") != std::string::npos);
  const auto missing = read_camera("/nonexistent/camera.json");
  REQUIRE_FALSE(missing);
  CHECK(missing.failure().problem == Problem::cannot_read);
}

TEST_CASE("the shipped cameras are read") {
  for (const char* name : {"mrpt_office", "room"}) {
    const auto camera = read_camera(std::string(STRAIGHTEDGE_FIXTURES "/depth/") + name + "/camera.json");
    REQUIRE(camera);
    CHECK(camera->size == Size{640, 480});
  }
}
