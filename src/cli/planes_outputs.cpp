// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "cli/planes_outputs.hpp"

#include <algorithm>
#include <string_view>

#include "cli/program.hpp"
#include "io/png16.hpp"
#include "straightedge/host/depth_file.hpp"
#include "straightedge/host/plane_leaves_file.hpp"
#include "straightedge/host/plane_map_file.hpp"
#include "straightedge/host/plane_view.hpp"

namespace straightedge::cli {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_ids = 65535;         // what a 16-bit picture can hold
constexpr std::uint64_t view_points = 200'000;  // dots of an HTML page

constexpr std::string_view polygons_ending = ".polygons.ply";

bool wants_polygons(const std::string& ply) {
  return lower_case(ply).ends_with(polygons_ending);
}

std::string with_method(const std::string& path, PlaneMethod method) {
  if (path == "-") return path;
  const fs::path whole = path;
  const std::string name = whole.filename().string();
  const std::size_t ending =
      wants_polygons(name) ? polygons_ending.size() : whole.extension().string().size();
  const std::size_t stem = name.size() - ending;
  return (whole.parent_path() / (name.substr(0, stem) + "-" + name_of(method) + name.substr(stem))).string();
}

std::vector<Pose> camera_path(const PlanesRun& run) {
  std::vector<Pose> path;
  if (run.cloud) return path;
  for (const SequenceFrame& frame : run.frames) path.push_back(*frame.pose);
  return path;
}

Image<std::uint16_t> label_image(const PlanesRun& run, const MethodFrame& frame) {
  Image<std::uint16_t> labels(run.size);
  const std::vector<std::uint32_t> ids = ids_of(frame.labels, frame.ids);
  std::transform(ids.begin(), ids.end(), labels.view().data,
                 [](std::uint32_t id) { return static_cast<std::uint16_t>(id); });
  return run.camera.distortion.none() ? labels : distorted(labels, run.camera);
}

}  // namespace

PlanesOutputs::PlanesOutputs(const PlanesArguments& arguments)
    : arguments_(arguments), methods_(arguments.method_list()) {
  for (const PlaneMethod method : methods_) {
    const auto add = [&](const std::string& option, const std::string& path, const std::string& extension) {
      if (path.empty()) return;
      outputs_.push_back({option, methods_.size() > 1 ? with_method(path, method) : path, extension, {}});
    };
    add("--output", arguments.xml, ".xml");
    add("--ply", arguments.ply, ".ply");
    add("--ply-polygons", arguments.ply_polygons, ".ply");
    add("--html", arguments.html, ".html");
    add("--svg", arguments.svg, ".svg");
    add("--leaves", arguments.leaves, "");
  }
}

Result<Done> PlanesOutputs::check(const std::vector<fs::path>& inputs,
                                  const std::vector<SequenceFrame>& frames) const {
  if (auto fine = check_outputs(outputs_, inputs, arguments_.common.json); !fine) return fine;
  if (arguments_.labels.empty()) return Done{};
  return check_label_folder(arguments_.labels, frames);
}

Result<Done> PlanesOutputs::fill(const PlanesRun& run) {
  const auto points = collect_points(run);
  if (!points) return points.failure();
  for (std::size_t i = 0; i < outputs_.size(); ++i) {
    const std::size_t method = i * methods_.size() / outputs_.size();
    if (auto filled = fill_output(outputs_[i], run, run.methods[method], (*points)[method]); !filled)
      return Failure{filled.failure().problem, arguments_.input + ": " + filled.failure().sentence};
  }
  return arguments_.labels.empty() ? Done{} : fill_labels(run);
}

Result<std::vector<PlanesOutputs::Points>> PlanesOutputs::collect_points(const PlanesRun& run) const {
  std::vector<Points> all(run.methods.size());
  std::vector<PointSink> sinks;
  for (std::size_t m = 0; m < all.size(); ++m) {
    const MethodRun* const method = &run.methods[m];
    if (!arguments_.ply.empty() && !wants_polygons(arguments_.ply)) {
      const MapMeta& meta = method->reading.map.meta;
      const std::vector<std::string> comments = {meta.tool + " planes", meta.options};
      if (run.cloud) {
        // Point i of the file is point i of the input.
        all[m].ply = std::make_shared<PointsPly>(comments, InvalidPoints::keep);
        const MethodFrame& frame = method->frames.front();
        if (auto added = all[m].ply->add(run.cloud->view(), ids_of(frame.labels, frame.ids)); !added)
          return added.failure();
      } else {
        all[m].ply = std::make_shared<PointsPly>(comments);
        sinks.push_back({method, thinning_step(run, arguments_.ply_points),
                         [&ply = *all[m].ply](const Vector3& at, std::uint32_t id) { ply.add(at, id); }});
      }
    }
    if (arguments_.html.empty()) continue;
    sinks.push_back(
        {method, thinning_step(run, view_points), [&view = all[m].view](const Vector3& at, std::uint32_t id) {
           view.push_back({at, id});
         }});
  }
  if (auto sent = send_points(run, sinks); !sent) return sent.failure();
  return all;
}

Result<Done> PlanesOutputs::fill_output(Output& output, const PlanesRun& run, const MethodRun& method,
                                        const Points& points) const {
  const PlaneMap& map = method.reading.map;
  if (output.option == "--output") {
    auto xml = plane_map_to_xml(map);
    if (!xml) return xml.failure();
    output.bytes = std::move(*xml);
  } else if (output.option == "--ply" && points.ply) {
    output.write = [ply = points.ply](const fs::path& file) { return ply->write(file); };
  } else if (output.option == "--ply" || output.option == "--ply-polygons") {
    output.write = [&map](const fs::path& file) { return write_polygons_ply(file, map); };
  } else if (output.option == "--html") {
    const std::vector<Pose> path = camera_path(run);
    output.bytes =
        plane_map_html(map, {.title = {}, .up = arguments_.up, .camera_path = path, .points = points.view});
  } else if (output.option == "--svg") {
    const std::vector<Pose> path = camera_path(run);
    output.bytes = plane_map_svg(map, {.title = {}, .up = arguments_.up, .camera_path = path});
  } else {
    output.bytes = plane_leaves_to_bytes(method.builder.leaves());
  }
  return Done{};
}

Result<Done> PlanesOutputs::fill_labels(const PlanesRun& run) {
  for (const MethodRun& method : run.methods) {
    if (method.reading.map.planes.size() > most_ids)
      return Failure{Problem::bad_content, arguments_.input +
                                               ": its map has more planes than the 65535 that label "
                                               "pictures can tell apart"};
    const fs::path folder = run.methods.size() > 1 ? name_of(method.method) : "";
    for (std::size_t i = 0; i < run.frames.size(); ++i) {
      auto png = io::encode_png16(label_image(run, method.frames[i]));
      if (!png) return Failure{png.failure().problem, arguments_.labels + ": " + png.failure().sentence};
      labels_.push_back({folder / label_name(run.frames[i]), std::move(*png)});
    }
  }
  return Done{};
}

Result<Done> PlanesOutputs::write() const {
  if (auto written = write_outputs(outputs_); !written) return written;
  if (labels_.empty()) return Done{};
  auto written = write_folder(arguments_.labels, labels_);
  if (written || outputs_.empty()) return written;
  return Failure{written.failure().problem,
                 written.failure().sentence + "; written before: " + names_of(outputs_)};
}

std::string PlanesOutputs::names() const {
  std::string names = names_of(outputs_);
  if (!labels_.empty()) names += (names.empty() ? "" : ", ") + arguments_.labels;
  return names;
}

}  // namespace straightedge::cli
