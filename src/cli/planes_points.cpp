// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "cli/planes_points.hpp"

#include <numeric>

#include "straightedge/host/depth_file.hpp"

namespace straightedge::cli {
namespace {

/// `number`: of the frame's first reading. Returns that of the next frame's.
std::uint64_t send_frame(const PlanesRun& run, const Image<std::uint16_t>& depth, const Pose& pose,
                         const std::vector<std::uint32_t>& ids, std::uint64_t number, const PointSink& sink) {
  for (std::int32_t v = 0; v < depth.height(); ++v) {
    for (std::int32_t u = 0; u < depth.width(); ++u) {
      if (depth.at(u, v) == 0 || number++ % sink.step != 0) continue;
      const double z = depth.at(u, v) * run.camera.metres_per_unit();
      const std::size_t pixel =
          static_cast<std::size_t>(v) * static_cast<std::size_t>(depth.width()) + static_cast<std::size_t>(u);
      sink.take(pose.apply(z * run.camera.pinhole.ray(u, v)), ids[pixel]);
    }
  }
  return number;
}

void send_cloud(const PointsView& points, const std::vector<std::uint32_t>& ids, const PointSink& sink) {
  std::uint64_t number = 0;
  for (std::size_t i = 0; i < points.count; ++i) {
    const Vector3 at = points.at(i);
    if (finite(at) && number++ % sink.step == 0) sink.take(at, ids[i]);
  }
}

}  // namespace

std::uint64_t thinning_step(const PlanesRun& run, std::uint64_t most) {
  std::uint64_t step = (run.readings + most - 1) / most;
  if (step <= 1) return 1;
  const auto width = static_cast<std::uint64_t>(run.cloud ? run.cloud->width : run.size.width);
  while (width > 0 && std::gcd(step, width) > 1) ++step;
  return step;
}

Result<Done> send_points(const PlanesRun& run, std::vector<PointSink>& sinks) {
  if (sinks.empty()) return Done{};
  if (run.cloud) {
    for (const PointSink& sink : sinks) {
      const MethodFrame& frame = sink.method->frames.front();
      send_cloud(run.cloud->view(), ids_of(frame.labels, frame.ids), sink);
    }
    return Done{};
  }
  std::uint64_t number = 0;
  for (std::size_t i = 0; i < run.frames.size(); ++i) {
    const auto depth = read_depth_frame(run.frames[i].file, run.camera);
    if (!depth) return depth.failure();
    if (depth->size() != run.size)
      return Failure{Problem::cannot_read, run.frames[i].file.string() + ": changed while it was read"};
    std::uint64_t next = number;
    for (const PointSink& sink : sinks) {
      const MethodFrame& frame = sink.method->frames[i];
      next = send_frame(run, *depth, *run.frames[i].pose, ids_of(frame.labels, frame.ids), number, sink);
    }
    number = next;
  }
  return Done{};
}

}  // namespace straightedge::cli
