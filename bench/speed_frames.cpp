// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <memory>
#include <utility>

#include "depth_scene.hpp"
#include "speed_rows.hpp"
#include "straightedge/host/plane_detector.hpp"
#include "straightedge/host/plane_map_builder.hpp"
#include "with_kernels.hpp"

namespace bench::speed {
namespace {

using namespace straightedge;

Call prepare_first_plane(Size size, const KernelSet& set) {
  struct Work {
    DepthFrame frame;
    FirstPlane first;
  };
  auto w = std::make_shared<Work>(
      Work{make_depth_frame(size), FirstPlane(static_cast<std::size_t>(pixels_of(size)), {}, set)});
  need(w->first.prepared(), "no RANSAC");
  return [w] { need(w->first.run(w->frame.depth()).found.planes == 1, "no plane"); };
}

struct Detection {
  DepthFrame frame;
  PlaneDetector detector;

  DetectedPlanes detect() {
    auto found = detector.detect(frame.depth());
    need(found && !found->planes.empty(), "no planes");
    return std::move(*found);
  }
};

std::shared_ptr<Detection> detection(Size size, PlaneMethod method, const KernelSet& set) {
  PlaneDetectorOptions options;
  options.method = method;
  const auto create = [](auto&&... a) requires requires {
    PlaneDetector::create(a...);
  }
  { return PlaneDetector::create(a...); };
  auto made = call_with(set, create, size, options);
  need(static_cast<bool>(made), "no detector");
  return std::make_shared<Detection>(Detection{make_depth_frame(size), std::move(*made)});
}

Job planes_job(const char* name, Size size, PlaneMethod method) {
  return {name, text_of(size), pixels_of(size), "pixel", [=](const KernelSet& set) -> Call {
            auto w = detection(size, method, set);
            return [w] { w->detect(); };
          }};
}

}  // namespace

Job first_plane_job(Size size) {
  return {"first plane of a frame", text_of(size), pixels_of(size), "pixel",
          [size](const KernelSet& set) { return prepare_first_plane(size, set); }};
}

Job ransac_planes_job(Size size) {
  return planes_job("planes and labels, RANSAC", size, PlaneMethod::ransac);
}

Job hough_planes_job(Size size) {
  return planes_job("planes and labels, Hough", size, PlaneMethod::hough);
}

Job register_job(Size size) {
  return {
      "frame into plane map", text_of(size), pixels_of(size), "pixel", [size](const KernelSet& set) -> Call {
        auto w = detection(size, PlaneMethod::ransac, set);
        auto found = std::make_shared<DetectedPlanes>(w->detect());
        return [w, found, set] {
          const auto make = [](auto&&... a) requires requires {
            PlaneMapBuilder(a...);
          }
          { return PlaneMapBuilder(a...); };
          PlaneMapBuilder builder = call_with(set, make, PlaneMapOptions());
          need(static_cast<bool>(builder.add(w->frame.depth(), found->labels, found->planes, {})), "no map");
        };
      }};
}

}  // namespace bench::speed
