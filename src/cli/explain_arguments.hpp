// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "cli/command.hpp"
#include "cli/detection_arguments.hpp"
#include "straightedge/host/plane_detector.hpp"

namespace straightedge::cli {

/// What `explain` is told. The object must stay where it is until the arguments are parsed.
struct ExplainArguments {
  CommonArguments common;
  std::string input;
  std::string folder;
  std::string camera;  ///< empty: not given

  void add_to(CLI::App& command);

  /// Of a picture. Fails with `bad_option` where an option is for depth frames, or options contradict.
  Result<LineMapOptions> line_options() const;
  /// Of a depth frame. Fails with `bad_option` where an option is for pictures.
  Result<PlaneDetectorOptions> plane_options() const;
  std::optional<double> units_per_metre() const;
  /// --picture says that the input is a picture, also with 16 bits.
  bool wants_picture() const;

 private:
  enum class Method : std::uint8_t { automatic, standard, progressive, randomized, ransac, hough };

  Method method_ = Method::automatic;
  double depth_scale_ = 0;
  DetectionArguments detection_;
  CLI::Option* picture_option_ = nullptr;
  CLI::Option* depth_scale_option_ = nullptr;
  std::vector<CLI::Option*> for_pictures_, for_depth_;
};

}  // namespace straightedge::cli
