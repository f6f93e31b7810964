// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "cli/planes_cloud.hpp"

#include <algorithm>
#include <chrono>
#include <memory>
#include <utility>

#include "cli/picture_input.hpp"
#include "io/number_text.hpp"
#include "straightedge/host/kernels.hpp"
#include "straightedge/hough_planes.hpp"
#include "straightedge/ransac_planes.hpp"

namespace straightedge::cli {
namespace {

namespace fs = std::filesystem;

Failure refused(const fs::path& file, Status status) {
  const bool option = status == Status::invalid_option || status == Status::too_large;
  return {option ? Problem::bad_option : Problem::bad_content, file.string() + ": " + to_string(status)};
}

Failure in_file(const fs::path& file, const Failure& failure) {
  return {failure.problem, file.string() + ": " + failure.sentence};
}

struct CloudPlanes {
  std::vector<std::uint16_t> labels;
  std::vector<FoundPlane> planes;
  PlanesFound found;
};

using Clock = std::chrono::steady_clock;

double milliseconds_since(Clock::time_point before) {
  return std::chrono::duration<double, std::milli>(Clock::now() - before).count();
}

/// Prepares the search in memory of its own, then runs it: `run(search)`.
template <class Search, class Options, class Run>
Result<Done> search(const fs::path& file, std::size_t points, const Options& options, Run run) {
  const std::size_t bytes = Search::workspace_bytes(points, options);
  if (bytes == 0) return refused(file, Status::invalid_option);
  if (auto fits = check_memory(file, bytes); !fits) return fits;
  const auto memory = std::make_unique_for_overwrite<std::byte[]>(bytes);
  Search prepared;
  Status status = Search::prepare(prepared, points, options, {memory.get(), bytes});
  if (status == Status::ok) status = run(prepared);
  return status == Status::ok || status == Status::output_full ? Result<Done>(Done{}) : refused(file, status);
}

Result<CloudPlanes> find_planes(const PlanesArguments& arguments, PlaneMethod method, const fs::path& file,
                                const PointsView& points, const CloudScale& scale, std::uint32_t max_planes) {
  CloudPlanes seen;
  if (points.count == 0) return seen;
  seen.labels.resize(points.count);
  const auto ransac = [&](RansacPlanes& planes) {
    const RansacPlanesResult result = planes.run(points, seen.planes, seen.labels);
    seen.found = result.found;
    return result.status;
  };
  const auto hough = [&](HoughPlanes& planes) {
    return planes.run(points, seen.labels, seen.planes, seen.found);
  };
  const auto kernels = kernels_from_environment();
  if (!kernels) return kernels.failure();
  CloudOptions options = arguments.cloud_options(points.count, scale);
  options.ransac.kernels = kernels->ransac;
  options.ransac.max_planes = options.hough.max_planes = max_planes;
  seen.planes.resize(max_planes);
  const auto done = method == PlaneMethod::ransac
                        ? search<RansacPlanes>(file, points.count, options.ransac, ransac)
                        : search<HoughPlanes>(file, points.count, options.hough, hough);
  if (!done) return done.failure();
  seen.planes.resize(seen.found.planes);
  return seen;
}

Result<MethodRun> run_method(const PlanesArguments& arguments, PlaneMethod method, const fs::path& file,
                             const PointsView& points, const CloudScale& scale) {
  MethodRun made{method, PlaneMapBuilder(arguments.cloud_map_options(points.count, scale)), {}, {}};
  MethodFrame& frame = made.frames.emplace_back();
  auto before = Clock::now();
  auto seen = find_planes(arguments, method, file, points, scale, arguments.max_planes());
  if (!seen) return seen.failure();
  frame.detection_ms = milliseconds_since(before);
  if (arguments.method_list().size() > 1) {
    before = Clock::now();
    if (auto first = find_planes(arguments, method, file, points, scale, 1); !first) return first.failure();
    frame.first_ms = milliseconds_since(before);
  }
  if (points.count > 0) {
    auto registered = made.builder.add(points, seen->labels, seen->planes, Pose{});
    if (!registered) return in_file(file, registered.failure());
    frame.registered = std::move(*registered);
  }
  frame.labels = runs_of(seen->labels);
  frame.planes = std::move(seen->planes);
  frame.found = seen->found;
  if (auto map = read_map(made); !map) return in_file(file, map.failure());
  return made;
}

}  // namespace

Result<PlanesRun> run_cloud(const PlanesArguments& arguments, const fs::path& file) {
  auto read = read_cloud(file);
  if (!read) return read.failure();
  PlanesRun run;
  run.cloud = std::make_shared<const Cloud>(std::move(*read));
  SequenceFrame frame;
  frame.file = file;
  frame.name = file.filename().string();
  frame.pose = Pose{};
  run.frames.push_back(frame);
  const PointsView points = run.cloud->view();
  const auto scale = points.count > 0 ? measure_cloud(points) : CloudScale{};
  if (!scale) return in_file(file, scale.failure());
  run.scale = *scale;
  for (const PlaneMethod method : arguments.method_list()) {
    auto made = run_method(arguments, method, file, points, *scale);
    if (!made) return made.failure();
    run.readings = made->frames.front().found.readings;
    run.methods.push_back(std::move(*made));
  }
  return run;
}

}  // namespace straightedge::cli
