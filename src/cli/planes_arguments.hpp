// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "cli/command.hpp"
#include "straightedge/host/depth_sequence.hpp"
#include "straightedge/host/measure_cloud.hpp"
#include "straightedge/host/plane_detector.hpp"
#include "straightedge/host/plane_map_builder.hpp"
#include "straightedge/host/plane_view.hpp"
#include "straightedge/hough_plane_options.hpp"
#include "straightedge/ransac_options.hpp"

namespace straightedge::cli {

/// `ransac` or `hough`, as options and files say it.
std::string name_of(PlaneMethod method);

/// How planes of a cloud are found.
struct CloudOptions {
  RansacOptions ransac;
  HoughPlaneOptions hough;
};

/// What `planes` is told. The object must stay where it is until the arguments are parsed.
struct PlanesArguments {
  enum class Methods : std::uint8_t { ransac, hough, both };

  CommonArguments common;
  std::string input;
  Methods methods = Methods::ransac;
  bool strict = false;
  UpAxis up = UpAxis::automatic;
  std::uint64_t ply_points = 2'000'000;
  std::string xml, labels, ply, ply_polygons, html, svg, leaves;  ///< empty: not wanted
  std::string camera, trajectory;                                 ///< empty: not given
  std::string name, description, created;

  void add_to(CLI::App& command);

  std::vector<PlaneMethod> method_list() const;
  /// For frames of this size.
  PlaneDetectorOptions detector_options(PlaneMethod method, Size size) const;
  /// For so many frames, at least 1.
  unsigned thread_count(std::size_t frames) const;
  std::uint32_t max_planes() const { return static_cast<std::uint32_t>(max_planes_); }
  /// For a cloud of so many points.
  CloudOptions cloud_options(std::size_t points, const CloudScale& scale) const;
  PlaneMapOptions map_options() const;
  PlaneMapOptions cloud_map_options(std::size_t points, const CloudScale& scale) const;
  SequenceOptions sequence_options() const;
  std::optional<double> units_per_metre() const;
  /// The options of one method in words, seed and the input's name included, as files hold them.
  /// `scale`: of a cloud.
  std::string words(PlaneMethod method, const std::optional<CloudScale>& scale) const;
  /// By its ending, .pcd or .ply.
  bool is_cloud() const;
  /// Without folders, and without a slash at the end.
  std::string input_name() const;
  /// Fails with `bad_option` where options contradict the kind of input, or lack a name.
  Result<Done> check() const;

 private:
  void add_input(CLI::App& command);
  void add_outputs(CLI::App& command);
  void add_detection(CLI::App& command);
  void add_map(CLI::App& command);

  /// In metres by the cloud's noise, unless the options say otherwise.
  PlaneGate gate_of_cloud(const CloudScale& scale) const;

  std::uint32_t least_points(std::size_t points) const;

  PlaneGate gate_;
  double large_share_ = 0.05;
  std::int32_t min_pixels_ = 0;
  std::int32_t max_planes_ = 64;
  std::uint64_t min_points_ = 0;
  std::int32_t threads_ = 0;
  double depth_scale_ = 0;
  CLI::Option* large_option_ = nullptr;
  CLI::Option* depth_scale_option_ = nullptr;
  CLI::Option* sigma_option_ = nullptr;
  CLI::Option* sigmas_option_ = nullptr;
  CLI::Option* threshold_option_ = nullptr;
};

}  // namespace straightedge::cli
