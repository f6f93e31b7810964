// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <memory>
#include <utility>

#include "depth_scene.hpp"
#include "speed_kernels.hpp"
#include "speed_rows.hpp"
#include "straightedge/host/plane_detector.hpp"
#include "straightedge/host/plane_map_builder.hpp"
#include "straightedge/inverse_depth.hpp"
#include "straightedge/ransac_planes.hpp"

namespace bench::speed {
namespace {

using namespace straightedge;

Call prepare_first_plane(Size size) {
  struct Work {
    DepthFrame frame;
    Image<float> inverse_depth;
    std::vector<std::byte> memory;
    RansacPlanes ransac;
    std::vector<FoundPlane> plane = std::vector<FoundPlane>(1);
  };
  auto w = std::make_shared<Work>(Work{make_depth_frame(size), Image<float>(size), {}, {}});
  const auto readings = static_cast<std::size_t>(pixels_of(size));
  w->memory.resize(RansacPlanes::workspace_bytes(readings, {}));
  need(RansacPlanes::prepare(w->ransac, readings, {}, w->memory) == Status::ok, "no RANSAC");
  return [w] {
    need(inverse_depth_image(w->frame.depth(), w->inverse_depth.view()) == Status::ok, "a broken frame");
    need(w->ransac.run(w->inverse_depth.view(), w->frame.camera, w->plane, {}).found.planes == 1, "no plane");
  };
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

std::shared_ptr<Detection> detection(Size size, PlaneMethod method) {
  PlaneDetectorOptions options;
  options.method = method;
  auto made = PlaneDetector::create(size, options);
  need(static_cast<bool>(made), "no detector");
  return std::make_shared<Detection>(Detection{make_depth_frame(size), std::move(*made)});
}

Job planes_job(const char* name, Size size, PlaneMethod method) {
  return {name, text_of(size), pixels_of(size), "pixel", [=](const KernelSet&) -> Call {
            auto w = detection(size, method);
            return [w] { w->detect(); };
          }};
}

}  // namespace

Job first_plane_job(Size size) {
  return {"first plane of a frame", text_of(size), pixels_of(size), "pixel",
          [size](const KernelSet&) { return prepare_first_plane(size); }};
}

Job ransac_planes_job(Size size) {
  return planes_job("planes and labels, RANSAC", size, PlaneMethod::ransac);
}

Job hough_planes_job(Size size) {
  return planes_job("planes and labels, Hough", size, PlaneMethod::hough);
}

Job register_job(Size size) {
  return {"frame into plane map", text_of(size), pixels_of(size), "pixel", [size](const KernelSet&) -> Call {
            auto w = detection(size, PlaneMethod::ransac);
            auto found = std::make_shared<DetectedPlanes>(w->detect());
            return [w, found] {
              PlaneMapBuilder builder;
              need(static_cast<bool>(builder.add(w->frame.depth(), found->labels, found->planes, {})),
                   "no map");
            };
          }};
}

}  // namespace bench::speed
