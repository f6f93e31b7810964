// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cli/planes_arguments.hpp"
#include "cli/planes_labels.hpp"
#include "cli/progress.hpp"
#include "straightedge/host/cloud.hpp"

namespace straightedge::cli {

/// What one method saw in one frame.
struct MethodFrame {
  std::vector<LabelRun> labels;
  std::vector<FoundPlane> planes;
  PlanesFound found;
  RegisteredFrame registered;
  std::vector<std::uint32_t> ids;  ///< the map's id of each plane; 0: the map dropped it
  double first_ms = 0;             ///< time to the first plane; only where both methods are compared
  double detection_ms = 0;         ///< time to all planes
};

/// One method, all frames, its map.
struct MethodRun {
  PlaneMethod method = PlaneMethod::ransac;
  PlaneMapBuilder builder;
  PlaneMapReading reading;
  std::vector<MethodFrame> frames;  ///< one for each of PlanesRun::frames
};

struct SkippedFrame {
  std::string name;
  std::string reason;  ///< a sentence with the file's name
};

struct PlanesRun {
  std::shared_ptr<const Cloud> cloud;  ///< the input, if it is one; it then has one frame, without pixels
  std::optional<CloudScale> scale;     ///< of the cloud
  DepthCamera camera;
  Size size;
  std::vector<SequenceFrame> frames;  ///< the good ones
  std::vector<SkippedFrame> skipped;
  std::uint64_t readings = 0;  ///< of all frames
  std::vector<MethodRun> methods;
};

/// Reads the planes out of all that was registered, and gives the frames' planes their ids.
Result<Done> read_map(MethodRun& method);

/// Every frame through every method, into one map a method. Bad frames get a line on stderr and are left
/// out; with --strict the first one is the failure. bad_content: no good frame.
Result<PlanesRun> run_planes(const PlanesArguments& arguments, const DepthSequence& sequence,
                             Progress& progress);

}  // namespace straightedge::cli
