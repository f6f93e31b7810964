// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "cli/planes_compare.hpp"

#include <algorithm>
#include <cmath>

#include "io/number_text.hpp"
#include "straightedge/trigonometry.hpp"

namespace straightedge::cli {
namespace {

constexpr double most_angle_deg = 2;
constexpr double most_offset_m = 0.03;

double median(std::vector<double> values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

MethodFigures figures_of(const MethodRun& method) {
  MethodFigures figures;
  figures.method = method.method;
  figures.map_planes = method.reading.map.planes.size();
  std::vector<double> first, all;
  double labelled = 0, readings = 0, squares = 0;
  for (const MethodFrame& frame : method.frames) {
    first.push_back(frame.first_ms);
    all.push_back(frame.detection_ms);
    figures.planes += static_cast<double>(frame.planes.size()) / static_cast<double>(method.frames.size());
    readings += frame.found.readings;
    for (const FoundPlane& plane : frame.planes) {
      labelled += plane.inliers;
      squares += plane.inliers * plane.fit.rms * plane.fit.rms;
    }
  }
  figures.first_ms = median(std::move(first));
  figures.all_ms = median(std::move(all));
  figures.inliers = readings > 0 ? labelled / readings : 0;
  figures.residual_m = labelled > 0 ? std::sqrt(squares / labelled) : 0;
  return figures;
}

struct Partner {
  std::uint32_t id = 0;  ///< 0: none
  double angle_deg = 0;
  double offset_m = 0;

  double far() const { return angle_deg / most_angle_deg + offset_m / most_offset_m; }
};

Partner partner_of(const MapPlane& plane, const PlaneMap& other) {
  Partner nearest;
  for (const MapPlane& candidate : other.planes) {
    // Normals may point to opposite sides where a plane nearly passes through the origin.
    const double sine = length(cross(plane.plane.normal, candidate.plane.normal));
    const Vector3 centroid = plane.moments ? plane.moments->mean : plane.plane.distance * plane.plane.normal;
    const Partner partner{candidate.id, std::asin(std::min(1.0, sine)) * 180 / pi,
                          std::abs(candidate.plane.signed_distance(centroid))};
    if (!(partner.angle_deg < most_angle_deg && partner.offset_m < most_offset_m)) continue;
    if (nearest.id == 0 || partner.far() < nearest.far()) nearest = partner;
  }
  return nearest;
}

std::vector<Partner> partners_of(const PlaneMap& map, const PlaneMap& other) {
  std::vector<Partner> partners;
  for (const MapPlane& plane : map.planes) partners.push_back(partner_of(plane, other));
  return partners;
}

/// Ids count from 1 in the order of the map's planes.
bool together(const std::vector<Partner>& partners, std::uint32_t id, std::uint32_t other) {
  return id != 0 && other != 0 && partners[id - 1].id == other;
}

double share_of_same_labels(const PlanesRun& run, const std::vector<Partner>& first,
                            const std::vector<Partner>& second) {
  std::uint64_t same = 0, all = 0;
  for (std::size_t i = 0; i < run.frames.size(); ++i) {
    const MethodFrame& a = run.methods[0].frames[i];
    const MethodFrame& b = run.methods[1].frames[i];
    const std::vector<std::uint32_t> ids = ids_of(a.labels, a.ids), others = ids_of(b.labels, b.ids);
    for (std::size_t k = 0; k < ids.size(); ++k) {
      all += ids[k] != 0 || others[k] != 0;
      same += together(first, ids[k], others[k]) || together(second, others[k], ids[k]);
    }
  }
  return all == 0 ? 1 : static_cast<double>(same) / static_cast<double>(all);
}

std::string row(const std::string& what, const std::string& first, const std::string& second) {
  const auto padded = [](const std::string& text, std::size_t width) {
    return std::string(width - std::min(width, text.size()), ' ') + text;
  };
  return "  " + what + std::string(34 - std::min<std::size_t>(34, what.size()), ' ') + padded(first, 10) +
         padded(second, 10);
}

}  // namespace

Comparison compare_methods(const PlanesRun& run) {
  Comparison comparison;
  const PlaneMap& a = run.methods[0].reading.map;
  const PlaneMap& b = run.methods[1].reading.map;
  const std::array<std::vector<Partner>, 2> partners = {partners_of(a, b), partners_of(b, a)};
  std::vector<double> angles, offsets;
  for (std::size_t m = 0; m < 2; ++m) {
    comparison.methods[m] = figures_of(run.methods[m]);
    for (const Partner& partner : partners[m]) {
      if (partner.id == 0) continue;
      ++comparison.methods[m].partnered;
      angles.push_back(partner.angle_deg);
      offsets.push_back(partner.offset_m);
    }
  }
  comparison.angle_deg = median(std::move(angles));
  comparison.offset_m = median(std::move(offsets));
  comparison.same_label = share_of_same_labels(run, partners[0], partners[1]);
  return comparison;
}

std::string table_of(const Comparison& comparison) {
  const auto line = [&](const std::string& what, auto value) {
    return "\n" + row(what, value(comparison.methods[0]), value(comparison.methods[1]));
  };
  using Figures = const MethodFigures&;
  std::string table = row("", name_of(comparison.methods[0].method), name_of(comparison.methods[1].method));
  table += line("first plane of a frame, ms", [](Figures f) { return io::to_text(f.first_ms, 2); });
  table += line("all planes of a frame, ms", [](Figures f) { return io::to_text(f.all_ms, 2); });
  table += line("planes of a frame", [](Figures f) { return io::to_text(f.planes, 1); });
  table += line("readings on planes, %", [](Figures f) { return io::to_text(100 * f.inliers, 1); });
  table += line("residual, mm", [](Figures f) { return io::to_text(1000 * f.residual_m, 1); });
  table += line("planes of the map", [](Figures f) { return io::to_text(f.map_planes); });
  table += line("  with a partner in the other", [](Figures f) { return io::to_text(f.partnered); });
  table += "\n  partners differ by " + io::to_text(comparison.angle_deg, 3) + " degrees and " +
           io::to_text(1000 * comparison.offset_m, 2) + " mm (medians); " +
           io::to_text(100 * comparison.same_label, 1) + " % of the labelled readings agree";
  return table;
}

nlohmann::ordered_json json_of(const Comparison& comparison) {
  nlohmann::ordered_json numbers;
  for (const MethodFigures& figures : comparison.methods) {
    numbers[name_of(figures.method)] = {
        {"first_plane_ms", figures.first_ms}, {"all_planes_ms", figures.all_ms},
        {"planes_per_frame", figures.planes}, {"labelled_share", figures.inliers},
        {"residual", figures.residual_m},     {"map_planes", figures.map_planes},
        {"partnered", figures.partnered}};
  }
  numbers["median_angle_degrees"] = comparison.angle_deg;
  numbers["median_offset"] = comparison.offset_m;
  numbers["same_label_share"] = comparison.same_label;
  return numbers;
}

}  // namespace straightedge::cli
