// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "straightedge/depth_view.hpp"
#include "straightedge/frame_planes.hpp"
#include "straightedge/host/image.hpp"
#include "straightedge/host/kernels.hpp"
#include "straightedge/host/result.hpp"
#include "straightedge/hough_plane_patches.hpp"
#include "straightedge/ransac_search.hpp"

namespace straightedge {

enum class PlaneMethod : std::uint8_t { ransac, hough };

struct PlaneDetectorOptions {
  PlaneMethod method = PlaneMethod::ransac;
  FramePlanesOptions frame;  ///< its gate is the search's too, and bounds the search's min_pixels
  RansacSearchOptions ransac;
  HoughPatchOptions hough;
};

/// The options for planes that fill at least this share of the picture, (0, 1], in the shortest time: the
/// search looks at fewer readings, the labels are made from larger cells, there is one round, and the slack is
/// 2 at least. How coarse that may be follows from how many pixels the smallest of the planes has. Method,
/// gate, seed and limits stay as they are; a share that is out of range gives the smallest planes.
PlaneDetectorOptions for_large_planes(PlaneDetectorOptions options, Size size, double share = 0.05) noexcept;

/// The planes of one depth frame, in the camera's frame.
struct DetectedPlanes {
  Image<std::uint16_t> labels;     ///< 0: no plane; k: planes[k − 1]
  std::vector<FoundPlane> planes;  ///< the one with most pixels first
  PlanesFound found;
};

/// Finds the planes of depth frames of one size, by either method; owns the memory that the core's objects
/// work in, so that a sequence takes it once.
class PlaneDetector {
 public:
  /// bad_option: an option out of its range, a size without pixels or above 2^28 pixels or 2^15 a side.
  /// The kernels take the place of those in the options.
  static Result<PlaneDetector> create(Size size, const PlaneDetectorOptions& options,
                                      const KernelSet& kernels = best_kernels());

  /// bad_content: a frame of another size, a camera or a depth scale that makes no sense.
  Result<DetectedPlanes> detect(const DepthView& depth);
  /// The same into a result whose memory is used again; after a failure there is nothing in it that counts.
  Result<Done> detect(const DepthView& depth, DetectedPlanes& result);

  /// Bytes that the algorithms work in.
  std::size_t workspace_bytes() const noexcept { return memory_.size(); }
  const FramePlanes& frame() const noexcept { return *frame_; }

 private:
  PlaneDetector() = default;

  PlaneDetectorOptions options_;
  std::vector<std::byte> memory_;
  std::unique_ptr<FramePlanes> frame_;
  std::unique_ptr<RansacSearch> ransac_;
  std::unique_ptr<HoughPatchSearch> hough_;
};

/// The same in one call.
Result<DetectedPlanes> detect_planes(const DepthView& depth, const PlaneDetectorOptions& options = {},
                                     const KernelSet& kernels = best_kernels());

}  // namespace straightedge
