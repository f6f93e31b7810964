// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "cli/planes_report.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "cli/planes_compare.hpp"
#include "cli/program.hpp"
#include "io/number_text.hpp"

namespace straightedge::cli {
namespace {

using Json = nlohmann::ordered_json;

std::string count(std::uint64_t number, const std::string& what) {
  return io::to_text(number) + " " + what + (number == 1 ? "" : "s");
}

std::uint64_t frame_planes(const MethodRun& method) {
  std::uint64_t planes = 0;
  for (const MethodFrame& frame : method.frames) planes += frame.planes.size();
  return planes;
}

std::uint64_t labelled(const MethodRun& method) {
  std::uint64_t readings = 0;
  for (const MethodFrame& frame : method.frames) readings += frame.found.labelled;
  return readings;
}

std::uint64_t out_of_range(const MethodRun& method) {
  std::uint64_t readings = 0;
  for (const MethodFrame& frame : method.frames) readings += frame.registered.out_of_range;
  return readings;
}

std::string words_of(const MethodRun& method, std::uint64_t readings) {
  const PlaneMapReport& report = method.reading.report;
  const double share =
      readings == 0 ? 0 : 100 * static_cast<double>(labelled(method)) / static_cast<double>(readings);
  std::string words = "\n  " + name_of(method.method) + ": " + count(frame_planes(method), "plane") +
                      " in the frames, on " + io::to_text(share, 1) + " % of the readings";
  if (const std::uint64_t far = out_of_range(method); far > 0)
    words += "\n    " + count(far, "reading") + " beyond the 131 km that a map covers left out";
  words += "\n    map: " + count(report.planes, "plane") + " (dropped: " + io::to_text(report.too_few) +
           " with few readings, " + count(report.fragments, "fragment") + ", " +
           io::to_text(report.too_vague) + " of vague tilt, " + io::to_text(report.too_rough) +
           " of wide scatter, " + io::to_text(report.too_small) + " small)";
  return words;
}

Json json_of(const Vector3& v) {
  return Json::array({v.x, v.y, v.z});
}

Json json_of(const FoundPlane& plane, std::uint32_t id) {
  return {{"id", id},
          {"inliers", plane.inliers},
          {"residual", plane.fit.rms},
          {"normal", json_of(plane.fit.plane.normal)},
          {"distance", plane.fit.plane.distance},
          {"iterations", plane.iterations},
          {"confidence", plane.confidence},
          {"score", plane.score}};
}

Json json_of(const MethodRun& method, const PlanesRun& run) {
  Json frames = Json::array();
  for (std::size_t i = 0; i < run.frames.size(); ++i) {
    const MethodFrame& frame = method.frames[i];
    Json planes = Json::array();
    for (std::size_t k = 0; k < frame.planes.size(); ++k)
      planes.push_back(json_of(frame.planes[k], frame.ids[k]));
    frames.push_back({{"name", run.frames[i].name},
                      {"readings", frame.found.readings},
                      {"labelled", frame.found.labelled},
                      {"out_of_range", frame.registered.out_of_range},
                      {"planes", std::move(planes)}});
  }
  const PlaneMapReport& report = method.reading.report;
  Json planes = Json::array();
  for (const MapPlane& plane : method.reading.map.planes) {
    planes.push_back({{"id", plane.id},
                      {"normal", json_of(plane.plane.normal)},
                      {"distance", plane.plane.distance},
                      {"points", plane.points.value_or(0)},
                      {"count", plane.count.value_or(0)}});
  }
  return {{"method", name_of(method.method)},
          {"options", method.reading.map.meta.options},
          {"labelled", labelled(method)},
          {"frames", std::move(frames)},
          {"map",
           {{"leaves", report.leaves},
            {"readings", report.readings},
            {"dropped_too_few", report.too_few},
            {"dropped_fragments", report.fragments},
            {"dropped_too_vague", report.too_vague},
            {"dropped_too_rough", report.too_rough},
            {"dropped_too_small", report.too_small},
            {"planes", std::move(planes)}}}};
}

}  // namespace

std::string words_of(const PlanesRun& run, const PlanesArguments& arguments, const std::string& written) {
  std::string words = arguments.input + "\n  ";
  if (run.cloud) {
    words += count(run.cloud->x.size(), "point") + ", " + count(run.readings, "reading");
  } else {
    words += count(run.frames.size(), "frame") + " of " + io::to_text(run.size.width) + " x " +
             io::to_text(run.size.height) + " pixels, " + count(run.readings, "reading");
  }
  if (!run.skipped.empty()) words += "; " + count(run.skipped.size(), "bad frame") + " skipped";
  for (const MethodRun& method : run.methods) words += words_of(method, run.readings);
  if (run.methods.size() > 1) words += "\n" + table_of(compare_methods(run));
  return written.empty() ? words : words + "\n  written: " + written;
}

std::string json_of(const PlanesRun& run, const PlanesArguments& arguments) {
  Json skipped = Json::array();
  for (const SkippedFrame& frame : run.skipped)
    skipped.push_back({{"name", frame.name}, {"reason", frame.reason}});
  Json methods = Json::array();
  for (const MethodRun& method : run.methods) methods.push_back(json_of(method, run));
  Json numbers = {{"program", version_text()},       {"command", "planes"},
                  {"input", arguments.input_name()}, {"noise", run.scale ? Json(run.scale->noise_m) : Json()},
                  {"width", run.size.width},         {"height", run.size.height},
                  {"seed", arguments.common.seed},   {"frames", run.frames.size()},
                  {"readings", run.readings},        {"skipped", std::move(skipped)},
                  {"methods", std::move(methods)}};
  if (run.methods.size() > 1) numbers["comparison"] = json_of(compare_methods(run));
  return numbers.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace straightedge::cli
