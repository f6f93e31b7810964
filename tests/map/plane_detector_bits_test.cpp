// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <bit>
#include <cstdint>
#include <filesystem>
#include <string>

#include "detector_testing.hpp"
#include "straightedge/host/camera_file.hpp"
#include "straightedge/host/depth_file.hpp"
#include "straightedge/host/kernels.hpp"

using namespace detector;

namespace {

/// FNV-1a.
class Hash {
 public:
  void add(std::uint64_t bits) {
    for (unsigned shift = 0; shift < 64; shift += 8) {
      state_ = (state_ ^ ((bits >> shift) & 255U)) * 1099511628211U;
    }
  }
  void add(double value) { add(std::bit_cast<std::uint64_t>(value)); }
  void add(const PlaneFit& fit) {
    for (const Vector3& v : {fit.plane.normal, fit.tangent_u, fit.tangent_v, fit.centroid}) {
      add(v.x);
      add(v.y);
      add(v.z);
    }
    for (const double entry : fit.covariance) add(entry);
    for (const double value : {fit.plane.distance, fit.weight, fit.count, fit.rms}) add(value);
  }
  void add(const DetectedPlanes& result) {
    for (int y = 0; y < result.labels.height(); ++y) {
      for (int x = 0; x < result.labels.width(); ++x) add(std::uint64_t{result.labels.at(x, y)});
    }
    for (const FoundPlane& plane : result.planes) {
      add(plane.fit);
      add(plane.score);
      add(std::uint64_t{plane.iterations});
    }
  }
  std::uint64_t value() const { return state_; }

 private:
  std::uint64_t state_ = 14695981039346656037U;
};

std::uint64_t hash_of(PlaneMethod method, const KernelSet& kernels) {
  const std::filesystem::path folder = std::filesystem::path(STRAIGHTEDGE_FIXTURES) / "depth" / "room";
  const auto camera = read_camera(folder / "camera.json");
  const auto raw = read_depth_image(folder / "depth" / "03.png");
  REQUIRE(camera);
  REQUIRE(raw);
  Hash hash;
  const DepthView depth{raw->view(), camera->metres_per_unit(), camera->pinhole};
  const auto found = detect_planes(depth, by(method), kernels);
  REQUIRE(found);
  hash.add(*found);
  return hash.value();
}

}  // namespace

TEST_CASE("planes of a depth frame have the same bits with every compiler, set of kernels and machine") {
  for (const KernelSet& kernels : kernel_sets()) {
    CAPTURE(std::string(kernels.name));
    CHECK(hash_of(PlaneMethod::ransac, kernels) == 5046685073606313102U);
    CHECK(hash_of(PlaneMethod::hough, kernels) == 8333402803085334809U);
  }
}
