// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "straightedge/host/ros_map.hpp"

#include <yaml-cpp/yaml.h>

#include <array>
#include <cmath>
#include <string>

#include "io/number_text.hpp"
#include "io/read_bytes.hpp"
#include "io/ros_mode_text.hpp"

namespace straightedge {
namespace {

/// A map's YAML has six short lines; far longer files are something else.
constexpr std::size_t max_yaml_bytes = std::size_t{1} << 16;

/// Thrown inside this file alone, so that the list of keys below reads as a list.
struct BadKey {
  std::string sentence;
};

YAML::Node required(const YAML::Node& root, const char* key) {
  const YAML::Node node = root[key];
  if (!node.IsDefined() || node.IsNull()) throw BadKey{std::string("has no `") + key + "`"};
  return node;
}

std::string scalar(const YAML::Node& node, const char* key) {
  if (!node.IsScalar() || node.Scalar().empty())
    throw BadKey{std::string("`") + key + "` is not a single value"};
  return node.Scalar();
}

double number(const YAML::Node& node, const char* key) {
  const std::string text = scalar(node, key);
  const auto value = io::number_from_text<double>(text);
  if (!value || !std::isfinite(*value)) {
    throw BadKey{std::string("`") + key + "` is not a finite number (" + text.substr(0, 40) + ")"};
  }
  return *value;
}

double fraction(const YAML::Node& root, const char* key) {
  const double value = number(required(root, key), key);
  if (value < 0 || value > 1) throw BadKey{std::string("`") + key + "` is outside of 0 to 1"};
  return value;
}

bool yes_or_no(const YAML::Node& root, const char* key) {
  const std::string text = scalar(required(root, key), key);
  if (text == "0" || text == "false" || text == "False") return false;
  if (text == "1" || text == "true" || text == "True") return true;
  throw BadKey{std::string("`") + key + "` is neither 0 nor 1"};
}

MapPlacement placement_of(const YAML::Node& root) {
  MapPlacement placement;
  placement.resolution = number(required(root, "resolution"), "resolution");
  if (placement.resolution <= 0) throw BadKey{"`resolution` is not above zero"};
  const YAML::Node origin = required(root, "origin");
  if (!origin.IsSequence() || origin.size() != 3) throw BadKey{"`origin` is not a list of x, y and yaw"};
  placement.origin_x = number(origin[0], "origin");
  placement.origin_y = number(origin[1], "origin");
  placement.origin_yaw = number(origin[2], "origin");
  if (std::abs(placement.origin_yaw) > max_origin_yaw)
    throw BadKey{"the yaw of `origin` is outside of ±1000 radians"};
  return placement;
}

RosMeaning meaning_of(const YAML::Node& root) {
  RosMeaning meaning;
  meaning.negate = yes_or_no(root, "negate");
  meaning.occupied_thresh = fraction(root, "occupied_thresh");
  meaning.free_thresh = fraction(root, "free_thresh");
  if (meaning.free_thresh > meaning.occupied_thresh) throw BadKey{"`free_thresh` is above `occupied_thresh`"};
  if (const YAML::Node mode = root["mode"]; mode.IsDefined() && !mode.IsNull()) {
    const auto known = io::ros_mode_from_text(scalar(mode, "mode"));
    if (!known) throw BadKey{"`mode` is none of trinary, scale and raw"};
    meaning.mode = *known;
  }
  return meaning;
}

Failure bad(const std::filesystem::path& file, const std::string& what) {
  return {Problem::bad_content, file.string() + ": " + what};
}

}  // namespace

Result<RosMap> read_ros_map(const std::filesystem::path& file) try {
  const auto text = io::read_bytes(file, max_yaml_bytes);
  if (!text) return text.failure();
  const YAML::Node root = YAML::Load(*text);
  if (!root.IsMap()) return bad(file, "is not the YAML of a map: it has no keys");
  RosMap map;
  map.image = file.parent_path() / scalar(required(root, "image"), "image");
  map.placement = placement_of(root);
  map.meaning = meaning_of(root);
  return map;
} catch (const BadKey& key) {
  return bad(file, key.sentence);
} catch (const YAML::Exception& error) {
  return bad(file, "is not YAML (line " + std::to_string(error.mark.line + 1) + ": " + error.msg + ")");
}

}  // namespace straightedge
