// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <cmath>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "catch.hpp"
#include "straightedge/host/depth_file.hpp"
#include "straightedge/host/depth_sequence.hpp"
#include "straightedge/plane.hpp"

using namespace straightedge;

namespace {

const std::filesystem::path room = STRAIGHTEDGE_FIXTURES "/depth/room";

std::map<int, Plane> true_planes() {
  std::ifstream stream(room / "truth.json");
  const auto truth = nlohmann::json::parse(stream);
  std::map<int, Plane> planes;
  for (const auto& plane : truth.at("planes")) {
    const auto n = plane.at("normal").get<std::array<double, 3>>();
    planes[plane.at("id").get<int>()] = {{n[0], n[1], n[2]}, plane.at("distance").get<double>()};
  }
  return planes;
}

/// Sums over the readings of labelled pixels: read depth against where the pixel's ray meets the true plane.
struct Residuals {
  double count = 0, sum = 0, squares = 0, far_off = 0, unread = 0;
};

void add_frame(Residuals& all, const DepthSequence& sequence, std::size_t index,
               const std::map<int, Plane>& planes) {
  const SequenceFrame& frame = sequence.frames[index];
  const auto raw = read_depth_frame(frame.file, sequence.camera);
  const auto labels = read_depth_image(room / "labels" / frame.name);
  REQUIRE(raw);
  REQUIRE(labels);
  REQUIRE(labels->size() == raw->size());
  for (int v = 0; v < raw->height(); ++v) {
    for (int u = 0; u < raw->width(); ++u) {
      if (labels->at(u, v) == 0) continue;
      if (raw->at(u, v) == 0) {
        ++all.unread;
        continue;
      }
      const Plane& plane = planes.at(labels->at(u, v));
      const double slope = dot(plane.normal, frame.pose->turned(sequence.camera.pinhole.ray(u, v)));
      const double inverse_depth = slope / (plane.distance - dot(plane.normal, frame.pose->translation));
      const double error = 1 / (raw->at(u, v) * sequence.camera.metres_per_unit()) - inverse_depth;
      ++all.count;
      all.sum += error;
      all.squares += error * error;
      if (std::abs(error) > 6e-3) ++all.far_off;
    }
  }
}

}  // namespace

// Readers, conventions and data at once: a wrong sign, axis, half pixel or pose order would show here.
TEST_CASE("readings of the shipped room lie on the true planes, within the sensor's noise") {
  const auto sequence = open_depth_sequence(room, {});
  REQUIRE(sequence);
  const auto planes = true_planes();
  Residuals all;
  for (std::size_t i = 0; i < sequence->frames.size(); ++i) add_frame(all, *sequence, i, planes);
  CHECK(all.count > 3e6);
  CHECK(std::abs(all.sum / all.count) < 2e-5);
  CHECK(std::sqrt(all.squares / all.count) == Approx(1.425e-3).epsilon(0.01));
  CHECK(all.far_off / all.count < 1e-4);
}

TEST_CASE("about half of the readings are missing in the room's dark corner") {
  const auto sequence = open_depth_sequence(room, {});
  REQUIRE(sequence);
  // The slanting wall across the corner, the picture before it and the chest: x - y = -3.8 and nearer.
  const auto planes = true_planes();
  Residuals dark;
  std::map<int, Plane> slanting;
  for (const auto& [id, plane] : planes) {
    if (dot(plane.normal, {-std::sqrt(0.5), std::sqrt(0.5), 0}) > 0.98) slanting[id] = plane;
  }
  REQUIRE(slanting.size() >= 3);
  for (const std::size_t index : {9u, 10u, 11u}) {
    const auto raw = read_depth_image(sequence->frames[index].file);
    const auto labels = read_depth_image(room / "labels" / sequence->frames[index].name);
    REQUIRE(raw);
    REQUIRE(labels);
    for (int v = 0; v < raw->height(); ++v) {
      for (int u = 0; u < raw->width(); ++u) {
        if (!slanting.contains(labels->at(u, v))) continue;
        ++(raw->at(u, v) == 0 ? dark.unread : dark.count);
      }
    }
  }
  CHECK(dark.count + dark.unread > 1e5);
  CHECK(dark.unread / (dark.count + dark.unread) == Approx(0.5).margin(0.08));
}
