// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/localize_arguments.hpp"
#include "cli/localize_run.hpp"
#include "cli/localize_truth.hpp"
#include "straightedge/host/line_map.hpp"

namespace straightedge::cli {

/// All that files, words and numbers of a run are made from.
struct LocalizeStory {
  const LocalizeArguments& arguments;
  const LineMap& map;  ///< in metres
  const LaserLog& log;
  const LocalizeRun& run;
  std::vector<TimedPose2> truth;
  std::vector<TimedPose2> odometry;  ///< alone
  std::optional<PoseErrors> errors;
  std::optional<PoseErrors> odometry_errors;
};

/// What happened, for people; several lines. Times of the machine are here and nowhere else.
std::string words_of(const LocalizeStory& story, const std::string& written);

/// The same numbers as one object.
std::string json_of(const LocalizeStory& story);

}  // namespace straightedge::cli
