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

PlaneDetectorOptions by_hough() {
  PlaneDetectorOptions options;
  options.method = PlaneMethod::hough;
  return options;
}

struct Detection {
  DepthFrame frame;
  PlaneDetector detector;
  DetectedPlanes found;

  void detect() {
    need(static_cast<bool>(detector.detect(frame.depth(), found)) && !found.planes.empty(), "no planes");
  }
};

std::shared_ptr<Detection> detection(Size size, const PlaneDetectorOptions& options, const KernelSet& set) {
  auto made = PlaneDetector::create(size, options, set);
  need(static_cast<bool>(made), "no detector");
  return std::make_shared<Detection>(Detection{make_depth_frame(size), std::move(*made), {}});
}

Job planes_job(const char* name, Size size, const PlaneDetectorOptions& options) {
  return {name, text_of(size), pixels_of(size), "pixel", [=](const KernelSet& set) -> Call {
            auto w = detection(size, options, set);
            return [w] { w->detect(); };
          }};
}

}  // namespace

Job first_plane_job(Size size) {
  return {"first plane of a frame", text_of(size), pixels_of(size), "pixel",
          [size](const KernelSet& set) { return prepare_first_plane(size, set); }};
}

Job ransac_planes_job(Size size) {
  return planes_job("planes and labels, RANSAC", size, {});
}

Job hough_planes_job(Size size) {
  return planes_job("planes and labels, Hough", size, by_hough());
}

Job large_ransac_planes_job(Size size) {
  return planes_job("planes of 5 %, RANSAC", size, for_large_planes({}, size));
}

Job large_hough_planes_job(Size size) {
  return planes_job("planes of 5 %, Hough", size, for_large_planes(by_hough(), size));
}

Job register_job(Size size) {
  return {"frame into plane map", text_of(size), pixels_of(size), "pixel",
          [size](const KernelSet& set) -> Call {
            auto w = detection(size, {}, set);
            w->detect();
            return [w, set] {
              PlaneMapBuilder builder({}, set);
              need(static_cast<bool>(builder.add(w->frame.depth(), w->found.labels, w->found.planes, {})),
                   "no map");
            };
          }};
}

}  // namespace bench::speed
