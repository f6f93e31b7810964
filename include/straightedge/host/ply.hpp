// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "straightedge/host/plane_map.hpp"
#include "straightedge/host/pose.hpp"
#include "straightedge/host/result.hpp"
#include "straightedge/points_view.hpp"

/// PLY 1.0, binary, little endian, for CloudCompare, MeshLab and their like. The same input gives the same
/// bytes; a file is written whole or not at all.
namespace straightedge {

/// What becomes of points with a coordinate that is not finite. Some programs show nothing of a file that has
/// one; without them, though, point i of the file is no longer point i of the input.
enum class InvalidPoints : std::uint8_t { leave_out, keep };

/// Points collected over many frames: vertices `float x y z`, `uchar red green blue` (plane_colour of the
/// label) and `uint label` (0: of no plane), 19 bytes each. All of them are in memory until they are
/// written; who has more thins them out before.
class PointsPly {
 public:
  /// `comments` become lines of the header: program and version, options, seed, the input's name.
  explicit PointsPly(const std::vector<std::string>& comments = {},
                     InvalidPoints invalid = InvalidPoints::leave_out);

  /// Throws std::bad_alloc when memory ends.
  void add(const Vector3& world_point, std::uint32_t label);

  /// All points of a frame, one label each, moved into the world by the frame's pose. Nothing is added on
  /// failure.
  Result<Done> add(const PointsView& points, std::span<const std::uint32_t> labels,
                   const Pose& world_from_points = {});

  std::size_t count() const noexcept { return count_; }

  /// May be called again after more points have come.
  Result<Done> write(const std::filesystem::path& file);

 private:
  std::string header(std::size_t count) const;

  std::string comments_;
  std::string bytes_;  ///< begins with room for the header, so that nothing is moved when it is known
  std::size_t room_ = 0;
  std::size_t count_ = 0;
  InvalidPoints invalid_ = InvalidPoints::leave_out;
};

/// One cloud. bad_option: as many labels as points are needed, or none at all (all are 0 then).
Result<Done> write_points_ply(const std::filesystem::path& file, const PointsView& points,
                              std::span<const std::uint32_t> labels,
                              const std::vector<std::string>& comments = {},
                              InvalidPoints invalid = InvalidPoints::leave_out);

/// The extents of a map's planes as triangles (holes left open), each plane's vertices with its colour and
/// with its id as `label`. Planes without polygons give none. The map's `tool` and `options` become comments.
Result<Done> write_polygons_ply(const std::filesystem::path& file, const PlaneMap& map);

}  // namespace straightedge
