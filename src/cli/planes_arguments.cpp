// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "cli/planes_arguments.hpp"

#include <algorithm>
#include <filesystem>

#include "cli/number_option.hpp"
#include "cli/outputs.hpp"
#include "cli/threads_option.hpp"
#include "io/number_text.hpp"
#include "straightedge/host/parallel.hpp"

namespace straightedge::cli {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t most_pixels = std::uint64_t{1} << 28U;
constexpr double least_threshold_m = 0.001, most_threshold_m = 0.1;
constexpr double threshold_noises = 5;  // the noise is that of the flattest half of a cloud
// How far apart points of one hypothesis are: less than the smallest planes, and enough that their noise does
// not tilt it.
constexpr double near_spacings = 7, near_noises = 100;
constexpr std::uint64_t most_points = std::uint64_t{1} << 31U;

Failure refusal(const std::string& input, const std::string& sentence) {
  return {Problem::bad_option, input + ": " + sentence};
}

}  // namespace

std::string name_of(PlaneMethod method) {
  return method == PlaneMethod::ransac ? "ransac" : "hough";
}

void PlanesArguments::add_to(CLI::App& command) {
  add_input(command);
  add_outputs(command);
  add_detection(command);
  add_map(command);
}

void PlanesArguments::add_input(CLI::App& command) {
  command
      .add_option("INPUT", input,
                  "a folder of depth frames with poses, a 16-bit depth PNG or PGM, or a PCD or PLY cloud; "
                  "- is standard input (a depth picture)")
      ->required();
  command
      .add_option("--camera", camera,
                  "intrinsics of the depth camera; without it camera.json in the input's folder or above it")
      ->type_name("CAMERA.json");
  depth_scale_option_ = add_real(command, "--depth-scale", depth_scale_, {0, 1e9, false}, "UNITS",
                                 "depth units a metre, in place of the camera's");
  depth_scale_option_->default_str("the camera's");
  command
      .add_option("--trajectory", trajectory,
                  "poses of a folder's frames, camera to world; without it the folder's own")
      ->type_name("POSES");
  add_threads(command, threads_);
  command.add_flag("--strict", strict, "the first bad frame is a failure; without it bad frames are skipped");
}

void PlanesArguments::add_outputs(CLI::App& command) {
  command.add_option("-o,--output", xml, "where the plane map goes; - is standard output")
      ->type_name("MAP.xml");
  command
      .add_option("--labels", labels,
                  "a 16-bit PNG for each frame, named like it: 0 no plane, else the id of the map's plane; "
                  "the folder is made when there is none")
      ->type_name("DIR");
  command
      .add_option("--ply", ply,
                  "the readings in the world, coloured by plane; of a cloud all points with their label; the "
                  "planes' extents if the name ends in .polygons.ply")
      ->type_name("OUT.ply");
  add_whole(command, "--ply-points", ply_points, {1, most_points}, "N",
            "of more readings of frames every n-th is kept");
  command.add_option("--ply-polygons", ply_polygons, "the extents of the planes as coloured triangles")
      ->type_name("OUT.ply");
  command.add_option("--html", html, "a page on which the map can be turned")->type_name("VIEW.html");
  command.add_option("--svg", svg, "the map from above and from a corner")->type_name("OUT.svg");
  command.add_option("--leaves", leaves, "the sums behind the map, for merging without loss")
      ->type_name("FILE");
}

void PlanesArguments::add_detection(CLI::App& command) {
  add_choice(
      command, "--method", methods,
      {{"ransac", Methods::ransac}, {"hough", Methods::hough}, {"both", Methods::both}},
      "how planes are found; both compares the two, and puts -ransac and -hough into the outputs' names");
  sigma_option_ = add_real(command, "--sigma", gate_.inverse_sigma, {0, 1, false}, "PER_METRE",
                           "standard deviation of 1/depth");
  sigmas_option_ = add_real(command, "--sigmas", gate_.sigmas, {0, 100, false}, "SIGMAS",
                            "how far from a plane its readings may lie");
  threshold_option_ = add_real(command, "--threshold", gate_.fixed_m, {0, 1000}, "METRES",
                               "the same in metres, whatever the depth; 0 takes --sigma and --sigmas");
  large_option_ = add_real(command, "--large", large_share_, {0.001, 1}, "SHARE",
                           "planes of a frame that fill at least this share of it and no others, in less "
                           "time, in place of --min-pixels; 0.05 is a twentieth");
  large_option_->default_str("all planes");
  add_whole(command, "--min-pixels", min_pixels_, {0, most_pixels}, "PIXELS",
            "smaller planes of a frame or cloud are dropped; 0 is a thousandth of it, at least 64");
  add_whole(command, "--max-planes", max_planes_, {1, 256}, "N", "planes of a frame or cloud");
}

void PlanesArguments::add_map(CLI::App& command) {
  add_whole(command, "--min-points", min_points_, {0, most_points}, "READINGS",
            "planes of the map with fewer are dropped; 0 is " + io::to_text(PlaneMapOptions{}.min_points) +
                ", and for a cloud what --min-pixels is");
  add_choice(command, "--up", up,
             {{"auto", UpAxis::automatic}, {"z", UpAxis::z}, {"y", UpAxis::y}, {"-y", UpAxis::minus_y}},
             "which axis points up in pictures; auto: as the cameras say");
  command
      .add_option("--name", name, "of the map, in the file; without it the input's name without its ending")
      ->type_name("TEXT");
  command.add_option("--description", description, "of the map, in the file")->type_name("TEXT");
  command.add_option("--created", created, "time in the file; NOW is the present, without it there is none")
      ->type_name("TEXT");
}

std::vector<PlaneMethod> PlanesArguments::method_list() const {
  if (methods == Methods::ransac) return {PlaneMethod::ransac};
  if (methods == Methods::hough) return {PlaneMethod::hough};
  return {PlaneMethod::ransac, PlaneMethod::hough};
}

PlaneDetectorOptions PlanesArguments::detector_options(PlaneMethod method, Size size) const {
  PlaneDetectorOptions options;
  options.method = method;
  options.frame.gate = gate_;
  options.frame.min_pixels = static_cast<std::uint32_t>(min_pixels_);
  options.frame.max_planes = static_cast<std::uint32_t>(max_planes_);
  options.ransac.seed = common.seed;
  if (min_pixels_ > 0) {
    options.ransac.min_pixels = std::min(options.ransac.min_pixels, min_pixels_);
    options.hough.min_pixels = std::min(options.hough.min_pixels, options.frame.min_pixels);
  }
  return large_option_->count() > 0 ? for_large_planes(options, size, large_share_) : options;
}

unsigned PlanesArguments::thread_count(std::size_t frames) const {
  const std::size_t wanted = threads_ > 0 ? static_cast<std::size_t>(threads_) : processors();
  return static_cast<unsigned>(std::clamp<std::size_t>(frames, 1, wanted));
}

std::uint32_t PlanesArguments::least_points(std::size_t points) const {
  if (min_pixels_ > 0) return std::max(3U, static_cast<std::uint32_t>(min_pixels_));
  return std::max(64U, static_cast<std::uint32_t>(points / 1000));
}

CloudOptions PlanesArguments::cloud_options(std::size_t points, const CloudScale& scale) const {
  CloudOptions options;
  options.ransac.gate = options.hough.gate = gate_of_cloud(scale);
  options.ransac.min_inliers = options.hough.min_points = least_points(points);
  options.ransac.max_planes = options.hough.max_planes = max_planes();
  options.ransac.min_share = 0;
  options.ransac.near_radius = options.hough.triple_max_m =
      std::max(near_spacings * scale.spacing_m, near_noises * scale.noise_m);
  options.hough.triple_min_m = options.hough.triple_max_m / 4;
  options.ransac.seed = options.hough.seed = common.seed;
  return options;
}

PlaneGate PlanesArguments::gate_of_cloud(const CloudScale& scale) const {
  PlaneGate gate = gate_;
  const bool given = sigma_option_->count() + sigmas_option_->count() + threshold_option_->count() > 0;
  if (!given && !scale.picture)
    gate.fixed_m = std::clamp(threshold_noises * scale.noise_m, least_threshold_m, most_threshold_m);
  return gate;
}

bool PlanesArguments::is_cloud() const {
  std::error_code error;
  const std::string ending = lower_case(fs::path(input).extension().string());
  return (ending == ".pcd" || ending == ".ply") && !fs::is_directory(input, error);
}

PlaneMapOptions PlanesArguments::map_options() const {
  PlaneMapOptions options;
  options.gate = gate_;
  if (min_points_ > 0) options.min_points = min_points_;
  return options;
}

PlaneMapOptions PlanesArguments::cloud_map_options(std::size_t points, const CloudScale& scale) const {
  PlaneMapOptions options;
  options.gate = gate_of_cloud(scale);
  options.min_points = min_points_ > 0 ? min_points_ : least_points(points);
  return options;
}

std::optional<double> PlanesArguments::units_per_metre() const {
  if (depth_scale_option_->count() == 0) return {};
  return depth_scale_;
}

SequenceOptions PlanesArguments::sequence_options() const {
  SequenceOptions options;
  if (!camera.empty()) options.camera = camera;
  if (!trajectory.empty()) options.trajectory = trajectory;
  options.units_per_metre = units_per_metre();
  return options;
}

std::string PlanesArguments::words(PlaneMethod method, const std::optional<CloudScale>& scale) const {
  std::string text = name_of(method) + ", ";
  const PlaneGate gate = scale ? gate_of_cloud(*scale) : gate_;
  text += gate.fixed_m > 0
              ? "threshold " + io::to_text(gate.fixed_m)
              : "sigma " + io::to_text(gate.inverse_sigma) + ", sigmas " + io::to_text(gate.sigmas);
  text += large_option_->count() > 0 ? ", large " + io::to_text(large_share_)
                                     : ", min-pixels " + io::to_text(min_pixels_);
  text += ", max-planes " + io::to_text(max_planes_);
  text += ", min-points " + io::to_text(min_points_);
  if (const auto units = units_per_metre()) text += ", depth-scale " + io::to_text(*units);
  return text + ", seed " + io::to_text(common.seed) + "; of " + input_name();
}

std::string PlanesArguments::input_name() const {
  const fs::path whole = fs::absolute(input_path(input)).lexically_normal();
  return base_name(whole.has_filename() ? whole : whole.parent_path());
}

Result<Done> PlanesArguments::check() const {
  std::error_code error;
  const bool folder = fs::is_directory(input, error);
  if (is_cloud()) {
    if (!camera.empty()) return refusal(input, "a cloud has no camera; leave --camera out");
    if (units_per_metre()) return refusal(input, "a cloud has no depth scale; leave --depth-scale out");
    if (large_option_->count() > 0)
      return refusal(input, "a cloud has no frames for --large; --min-pixels says how small its planes are");
    if (!labels.empty()) return refusal(input, "a cloud has no frames for --labels; --ply has its labels");
  }
  if (large_option_->count() > 0 && min_pixels_ > 0)
    return refusal(input, "--large says how small planes are; leave --min-pixels out");
  if (!folder && !trajectory.empty())
    return refusal(input, "--trajectory is for a folder of frames; leave it out");
  for (const std::string& output : {xml, ply, ply_polygons, html, svg, leaves}) {
    if (methods == Methods::both && output == "-")
      return refusal(input, "--method both makes two of each output; give them a name in place of -");
  }
  return Done{};
}

}  // namespace straightedge::cli
