// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "fixture_frames.hpp"

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <utility>

#include "straightedge/host/camera_file.hpp"
#include "straightedge/host/depth_file.hpp"
#include "straightedge/host/depth_sequence.hpp"

namespace bench {
namespace {

using namespace straightedge;

const std::filesystem::path folder = std::filesystem::path(STRAIGHTEDGE_FIXTURES) / "depth";

template <class T>
T need(Result<T> result) {
  if (result) return std::move(*result);
  std::fprintf(stderr, "%s\n", result.failure().sentence.c_str());
  std::exit(3);
}

FixtureFrame read_frame(const std::filesystem::path& file, const DepthCamera& camera, const Pose& pose) {
  return {need(read_depth_frame(file, camera)), camera.metres_per_unit(), camera.pinhole, pose};
}

}  // namespace

std::vector<FixtureFrame> room_frames() {
  const DepthSequence sequence = need(open_depth_sequence(folder / "room", {}));
  std::vector<FixtureFrame> frames;
  for (const SequenceFrame& frame : sequence.frames)
    frames.push_back(read_frame(frame.file, sequence.camera, frame.pose.value()));
  return frames;
}

std::vector<FixtureFrame> office_frames() {
  const DepthCamera camera = need(read_camera(folder / "mrpt_office" / "camera.json"));
  std::vector<FixtureFrame> frames;
  frames.push_back(read_frame(folder / "mrpt_office" / "depth.png", camera, {}));
  return frames;
}

}  // namespace bench
