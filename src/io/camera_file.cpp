// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "straightedge/host/camera_file.hpp"

#include <array>
#include <nlohmann/json.hpp>
#include <string>

#include "io/image_size.hpp"
#include "io/number_lines.hpp"
#include "io/read_bytes.hpp"

namespace straightedge {
namespace {

using Json = nlohmann::json;

/// A camera has a dozen numbers; far longer files are something else.
constexpr std::size_t max_camera_bytes = std::size_t{1} << 16;

/// Thrown inside this file alone, so that the list of keys below reads as a list.
struct BadCamera {
  std::string sentence;
};

double number(const Json& value, const std::string& key) {
  if (!value.is_number()) throw BadCamera{"`" + key + "` is not a number"};
  return value.get<double>();  // finite: JSON has no other
}

double required(const Json& root, const char* key) {
  if (!root.contains(key)) throw BadCamera{std::string("has no `") + key + "`"};
  return number(root[key], key);
}

double optional(const Json& root, const char* key, double otherwise) {
  return root.contains(key) ? number(root[key], key) : otherwise;
}

std::int64_t whole(const Json& root, const char* key) {
  const double value = required(root, key);
  if (!(value >= 1 && value <= 1e9) || value != static_cast<double>(static_cast<std::int64_t>(value)))
    throw BadCamera{std::string("`") + key + "` is not a whole number above zero"};
  return static_cast<std::int64_t>(value);
}

/// Open3D keeps K column by column.
PinholeCamera from_column_matrix(const Json& values) {
  if (!values.is_array() || values.size() != 9)
    throw BadCamera{"`intrinsic_matrix` is not a list of nine numbers"};
  std::array<double, 9> k{};
  for (std::size_t i = 0; i < 9; ++i) k[i] = number(values[i], "intrinsic_matrix");
  if (k[3] != 0 || k[1] != 0 || k[2] != 0 || k[5] != 0 || k[8] != 1)
    throw BadCamera{"`intrinsic_matrix` is not fx 0 0  0 fy 0  cx cy 1"};
  return {k[0], k[4], k[6], k[7]};
}

DepthCamera from_json(const Json& root) {
  if (!root.is_object()) throw BadCamera{"is not a JSON object"};
  DepthCamera camera;
  if (root.contains("intrinsic_matrix") && !root.contains("fx")) {
    camera.pinhole = from_column_matrix(root["intrinsic_matrix"]);
  } else {
    camera.pinhole = {required(root, "fx"), required(root, "fy"), required(root, "cx"), required(root, "cy")};
  }
  camera.distortion = {optional(root, "k1", 0), optional(root, "k2", 0), optional(root, "p1", 0),
                       optional(root, "p2", 0), optional(root, "k3", 0)};
  camera.units_per_metre = optional(root, "depth_scale", camera.units_per_metre);
  if (root.contains("width") || root.contains("height")) {
    const auto size = io::checked_size(whole(root, "width"), whole(root, "height"), "its picture");
    if (!size) throw BadCamera{size.failure().sentence};
    camera.size = *size;
  }
  return camera;
}

DepthCamera from_matrix(const std::vector<io::NumberLine>& lines) {
  const bool square = lines.size() == 3 && lines[0].numbers.size() == 3 && lines[1].numbers.size() == 3 &&
                      lines[2].numbers.size() == 3;
  if (!square) throw BadCamera{"is neither JSON nor a 3x3 matrix"};
  const auto &x = lines[0].numbers, &y = lines[1].numbers, &z = lines[2].numbers;
  if (x[1] != 0 || y[0] != 0 || z[0] != 0 || z[1] != 0 || z[2] != 1)
    throw BadCamera{"is not the matrix of a camera: fx 0 cx, 0 fy cy, 0 0 1"};
  DepthCamera camera;
  camera.pinhole = {x[0], y[1], x[2], y[2]};
  return camera;
}

void check(const DepthCamera& camera) {
  if (camera.pinhole.fx == 0 || camera.pinhole.fy == 0) throw BadCamera{"has a focal length of zero"};
  if (!camera.pinhole.valid()) throw BadCamera{"has a number that is not finite"};
  if (!(camera.units_per_metre > 0)) throw BadCamera{"`depth_scale` (units per metre) is not above zero"};
}

}  // namespace

Result<DepthCamera> read_camera(const std::filesystem::path& file) try {
  const auto text = io::read_bytes(file, max_camera_bytes);
  if (!text) return text.failure();
  const std::size_t first = text->find_first_not_of(" \t\r\n");
  if (first == std::string::npos) throw BadCamera{"is empty"};

  DepthCamera camera;
  if ((*text)[first] == '{' || (*text)[first] == '[') {
    const Json root = Json::parse(*text, nullptr, false);
    if (root.is_discarded()) throw BadCamera{"is not JSON"};
    camera = from_json(root);
  } else {
    const auto lines = io::number_lines(*text, file.string());
    if (!lines) return lines.failure();
    camera = from_matrix(*lines);
  }
  check(camera);
  return camera;
} catch (const BadCamera& bad) {
  return Failure{Problem::bad_content, file.string() + ": " + bad.sentence};
}

}  // namespace straightedge
