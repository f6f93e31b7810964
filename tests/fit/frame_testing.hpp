// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "straightedge/frame_planes.hpp"
#include "support/catch.hpp"
#include "support/depth_scene.hpp"
#include "support/depth_score.hpp"

namespace frame {

using namespace straightedge;
using support::DepthFrame;
using support::DepthScene;
using support::SensorNoise;

/// Proposes the planes that a test wants proposed.
struct FakeSearch {
  std::vector<InverseDepthPlane> planes;
  std::uint32_t calls = 0;
  std::size_t room = 0;  ///< of the last call
};

inline PlaneSearch as_search(FakeSearch& fake) {
  const auto run = [](void* user, ImageView<const float>, const DepthCells&, ImageView<const std::uint16_t>,
                      const PinholeCamera&, std::span<ProposedPlane> out, std::uint32_t& count) noexcept {
    auto& search = *static_cast<FakeSearch*>(user);
    ++search.calls;
    search.room = out.size();
    count = static_cast<std::uint32_t>(std::min(search.planes.size(), out.size()));
    for (std::size_t k = 0; k < count; ++k) {
      out[k] = {.fit = {.plane = search.planes[k]}, .score = 1.0 + static_cast<double>(k), .iterations = 7};
    }
    return count < search.planes.size() ? Status::output_full : Status::ok;
  };
  return {&fake, run};
}

inline std::vector<InverseDepthPlane> seen_by(const PinholeCamera& camera, const std::vector<Plane>& planes) {
  std::vector<InverseDepthPlane> out;
  for (const Plane& plane : planes) out.push_back(to_inverse_depth(plane, camera));
  return out;
}

struct FoundFrame {
  Status status = Status::ok;
  Image<std::uint16_t> labels;
  std::vector<FoundPlane> planes;
  PlanesFound found;
  std::uint32_t calls = 0;
};

/// A prepared object with its memory.
struct Finder {
  Finder(Size size, const FramePlanesOptions& options) : bytes(FramePlanes::workspace_bytes(size, options)) {
    REQUIRE(planes.prepare(size, options, bytes) == Status::ok);
  }
  FoundFrame run(const DepthView& depth, const std::vector<InverseDepthPlane>& proposed,
                 std::size_t room = 64) {
    FakeSearch fake{proposed};
    FoundFrame out;
    out.labels = Image<std::uint16_t>(depth.raw.size(), std::uint16_t{4711});
    out.planes.resize(room);
    out.status = planes.run(depth, as_search(fake), out.labels.view(), out.planes, out.found);
    out.planes.resize(out.found.planes);
    out.calls = fake.calls;
    return out;
  }
  std::vector<std::byte> bytes;
  FramePlanes planes;
};

inline FoundFrame find(const DepthFrame& frame, const std::vector<InverseDepthPlane>& proposed,
                       const FramePlanesOptions& options = {}, std::size_t room = 64) {
  return Finder(frame.raw.size(), options).run(frame.view(), proposed, room);
}

using support::count_of;

inline double agreement(const FoundFrame& result, const DepthFrame& frame,
                        const Image<std::uint16_t>& truth) {
  return support::agreement(result.labels, frame.raw, truth);
}

/// The numbers of a result are those of its own label image.
inline void check_counts(const FoundFrame& result, const DepthFrame& frame) {
  std::vector<std::uint32_t> counts(result.planes.size() + 1);
  std::uint32_t readings = 0, labelled = 0;
  for (int y = 0; y < frame.raw.height(); ++y) {
    for (int x = 0; x < frame.raw.width(); ++x) {
      const std::uint16_t label = result.labels.at(x, y);
      readings += frame.raw.at(x, y) != 0 ? 1U : 0U;
      labelled += label != 0 ? 1U : 0U;
      REQUIRE(label <= result.planes.size());
      REQUIRE((label == 0 || frame.raw.at(x, y) != 0));
      ++counts[label];
    }
  }
  CHECK(result.found.readings == readings);
  CHECK(result.found.labelled == labelled);
  CHECK(result.found.planes == result.planes.size());
  for (std::size_t k = 0; k < result.planes.size(); ++k) {
    CHECK(result.planes[k].inliers == counts[k + 1]);
    if (k > 0) CHECK(result.planes[k].inliers <= result.planes[k - 1].inliers);
  }
}

}  // namespace frame
