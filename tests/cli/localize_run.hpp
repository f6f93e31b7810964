// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "run_program.hpp"
#include "straightedge/host/laser_log.hpp"
#include "straightedge/host/line_map.hpp"
#include "straightedge/host/planar_trajectory.hpp"

/// Runs of `localize` on the shipped logs, and what a user could find out from its files.
namespace localize_run {

inline const std::string simulated = fixture("laser2d/mrpt_simul/scans.txt.gz");
inline const std::string truth = fixture("laser2d/mrpt_simul/groundtruth.txt");
inline const std::string corridor = fixture("laser2d/mrpt_corridor/scans.txt.gz");

/// A folder with the line map of a shipped picture in it, as map.xml.
struct MapFolder : TemporaryFolder {
  explicit MapFolder(const std::string& picture = "mrpt");
  std::string file(const std::string& name) const { return (*this / name).string(); }
  std::string map() const { return file("map.xml"); }
};

/// `localize MAP SCANS -o t.txt` and more in that folder; must end well. With --json: its numbers.
Run localize(const MapFolder& folder, const std::string& scans, const std::vector<std::string>& more = {});
nlohmann::json numbers_of(const MapFolder& folder, const std::string& scans,
                          std::vector<std::string> more = {});

/// The poses in t.txt; none of an empty trajectory.
std::vector<straightedge::TimedPose2> poses_in(const std::string& file);

/// Root mean squares against the truth of the nearest time, metres and degrees.
struct Errors {
  double position_m = 0, heading_degrees = 0;
};
Errors errors_of(const std::vector<straightedge::TimedPose2>& poses);

/// Scans `first` to `last` − 1 of a log as text in the plain format.
std::string text_of(const straightedge::LaserLog& log, std::size_t first, std::size_t last);
straightedge::LaserLog log_in(const std::string& file);

}  // namespace localize_run
