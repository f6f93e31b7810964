// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "plane_scene.hpp"
#include "straightedge/hough_plane_patches.hpp"

namespace test {

using namespace straightedge;

inline PinholeCamera camera_for(Size size) {
  return {260, 260, (size.width - 1) / 2.0, (size.height - 1) / 2.0};
}

/// Faces seen by a camera of 320 x 240 pixels, with a Kinect's noise unless said.
inline Image<float> room(const std::vector<Face>& faces, double noise = 1.425e-3, std::uint64_t seed = 3) {
  return depth_scene({320, 240}, camera_for({320, 240}), faces, noise, seed);
}

/// A search with its memory, and what it found.
struct Found {
  std::vector<std::byte> memory;
  std::unique_ptr<HoughPatchSearch> search;
  std::vector<ProposedPlane> candidates;
  HoughPatchResult result;
};

inline Found find_with(const PinholeCamera& camera, ImageView<const float> picture,
                       const HoughPatchOptions& options = {}, ImageView<const std::uint16_t> mask = {},
                       std::size_t room = 64, HoughPlaneTrace trace = {}) {
  Found found;
  found.memory.resize(HoughPatchSearch::workspace_bytes(picture.size(), options));
  found.search = std::make_unique<HoughPatchSearch>();
  found.result.status = HoughPatchSearch::prepare(*found.search, picture.size(), options, found.memory);
  if (found.result.status != Status::ok) return found;
  found.candidates.resize(room);
  found.result = found.search->run(picture, camera, mask, found.candidates, trace);
  found.candidates.resize(found.result.candidates);
  return found;
}

inline Found find(const Image<float>& picture, const HoughPatchOptions& options = {},
                  ImageView<const std::uint16_t> mask = {}, std::size_t room = 64,
                  HoughPlaneTrace trace = {}) {
  return find_with(camera_for(picture.size()), picture, options, mask, room, trace);
}

inline Plane plane_of(const ProposedPlane& candidate, const PinholeCamera& camera) {
  PlaneFit fit;
  if (to_plane_fit(candidate.fit, 1e-3, camera, fit) != Status::ok) return {};
  return fit.plane;
}

/// A candidate within these of the plane?
inline bool has(const Found& found, const Plane& plane, double angle_rad, double distance_m,
                const PinholeCamera& camera = camera_for({320, 240})) {
  for (const ProposedPlane& candidate : found.candidates) {
    const Plane own = plane_of(candidate, camera);
    const double off = own.distance - plane.distance;
    if (angle_between(own.normal, plane.normal) < angle_rad && off < distance_m && off > -distance_m)
      return true;
  }
  return false;
}

}  // namespace test
