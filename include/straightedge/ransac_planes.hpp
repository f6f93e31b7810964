// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "straightedge/arena.hpp"
#include "straightedge/found_planes.hpp"
#include "straightedge/inverse_depth.hpp"
#include "straightedge/ransac_options.hpp"

namespace straightedge {

namespace ransac {
struct Readings;
}

struct RansacPlanesResult {
  Status status = Status::not_prepared;
  PlanesFound found;
};

namespace detail {

/// Readings of a cloud without what lies between them.
struct CloudBlock {
  static constexpr std::size_t capacity = 1024;
  float x[capacity], y[capacity], z[capacity];
  std::uint32_t number[capacity];
  std::uint16_t label[capacity];
};

struct RansacPlanesMemory {
  std::span<float> x, y, z, w;                 ///< rows of the subset: coordinates over the gate
  std::span<float> first, second, third;       ///< coordinates
  std::span<float> place_x, place_y, place_z;  ///< with near_radius, where the readings are: pixels or metres
  std::span<std::uint32_t> reading, near;
  std::span<std::uint16_t> label;  ///< of every reading while a search for several planes lasts
  std::span<CloudBlock> block;     ///< with a gate in metres
  std::span<std::uint64_t> cell;   ///< of every reading of a plane that is split
  std::span<std::uint32_t> member, parent, extent;

  static constexpr RansacPlanesMemory take(Arena& arena, std::size_t readings,
                                           const RansacOptions& options) noexcept {
    const std::size_t drawn = options.subset < readings ? options.subset : readings;
    const std::size_t subset = (drawn + 15) / 16 * 16;
    RansacPlanesMemory m;
    for (std::span<float>* column : {&m.x, &m.y, &m.z, &m.w, &m.first, &m.second, &m.third})
      *column = arena.take<float>(subset);
    m.reading = arena.take<std::uint32_t>(subset);
    if (options.near_radius > 0) {
      for (std::span<float>* column : {&m.place_x, &m.place_y, &m.place_z})
        *column = arena.take<float>(subset);
      m.near = arena.take<std::uint32_t>(subset);
    }
    if (options.max_planes > 1 || options.split) m.label = arena.take<std::uint16_t>(readings);
    if (options.gate.fixed_m > 0) m.block = arena.take<CloudBlock>(1);
    if (options.split) {
      m.cell = arena.take<std::uint64_t>(readings);
      m.member = arena.take<std::uint32_t>(readings);
      m.parent = arena.take<std::uint32_t>(readings);
      m.extent = arena.take<std::uint32_t>(readings);
    }
    return m;
  }
};

}  // namespace detail

/// Planes by RANSAC, one after another, in a depth frame or a cloud. The same text for both: a reading has
/// three coordinates, and a plane is linear in them.
///
///   frame: pixel u, v and q = 1/z;  cloud with the gate of a depth sensor: x/z, y/z and 1/z;
///   cloud with a gate in metres: x, y, z.
///
///   1. Draw a subset: the readings that are left, cut into equal parts, one from each by chance.
///   2. Hypothesis i: the plane through three readings of the subset, from stream i of the seed. With
///      near_radius the second and the third lie near the first. Equal readings and readings on a line make
///      no plane and are drawn again.
///   3. Its MSAC cost in the subset: sum of min(e², 1), e the residual over the gate. First in an eighth of
///      the subset, sixteen hypotheses at once; in all of it if it may have 70 % of the best score.
///   4. What is good enough is optimised locally: least squares of e over its inliers, the gate from twice as
///      wide to the very one. The four cheapest planes stay, no two of them alike.
///   5. Stop when draws_needed says so for the inliers of the best, or at max_iterations. With near_radius
///      the probability of a good triple is the mean over first readings of k_i (k_i−1) / (m_i (m_i−1)),
///      m_i the readings near number i and k_i the inliers among them, taken over 64 of the inliers.
///   6. Contest: planes that the subset cannot tell from the best are refitted to an eighth of all readings,
///      those of twice the gate; the one with most inliers there wins.
///   7. Verify: all readings within the winner's gate are its inliers, and the plane is refitted to them. Below
///      min_inliers or min_share the search is over; else they leave, and back to 1 until there are max_planes.
///   8. Label: each reading goes to the nearest plane within the gate, and each plane is refitted to its own.
///   9. With `split`, into connected pieces, each a plane of its own.
///
/// M. A. Fischler, R. C. Bolles, 1981, doi:10.1145/358669.358692. P. H. S. Torr, A. Zisserman, "MLESAC", CVIU
/// 78(1), 2000, doi:10.1006/cviu.1999.0832. O. Chum, J. Matas, J. Kittler, "Locally Optimized RANSAC", DAGM
/// 2003, doi:10.1007/978-3-540-45243-0_31.
///
/// Results depend on the seed alone, and no more on the kernels. In a cloud, points that are no readings
/// change nothing but the places of the others' labels. Time: for each plane hypotheses times a part of the
/// subset, and a pass over all readings, with labels two; a cloud of which few points are no readings may
/// take its first plane twice, because their number is known only then. Memory: 32 bytes a reading of the
/// subset; with near_radius 16 more of these; 2 bytes a reading for several planes, or pieces; with `split`
/// 20 bytes a reading more; with gate.fixed_m 18 KB.
class RansacPlanes {
 public:
  /// 0 for options that `prepare` refuses.
  static constexpr std::size_t workspace_bytes(std::size_t readings, const RansacOptions& options) noexcept {
    if (!detail::valid(options) || readings < 1 || readings > (std::size_t{1} << 31U)) return 0;
    Arena arena = Arena::measure();
    (void)detail::RansacPlanesMemory::take(arena, readings, options);
    return arena.used();
  }

  /// For inputs of at most so many points or pixels. invalid_option; too_large: none, or more than 2^31;
  /// workspace_too_small.
  static Status prepare(RansacPlanes& planes, std::size_t readings, const RansacOptions& options,
                        std::span<std::byte> workspace) noexcept;

  /// A cloud. `labels` is empty or has one entry a point. Points that are not finite are no readings; without
  /// gate.fixed_m neither are those with z <= 0 or so far away that the gate reaches infinity. No planes in
  /// empty, collinear, or planeless input. output_full: `out` holds the first.
  RansacPlanesResult run(const PointsView& points, std::span<FoundPlane> out,
                         std::span<std::uint16_t> labels) noexcept;

  /// A frame of 1/z, 0 where there is no reading. `labels` has no data or the frame's size.
  RansacPlanesResult run(ImageView<const float> inverse_depth, const PinholeCamera& camera,
                         std::span<FoundPlane> out, ImageView<std::uint16_t> labels) noexcept;

  /// The same frame as the sensor gives it, without a picture of 1/z: the same bits as from
  /// inverse_depth_image. invalid_option: metres_per_unit outside 1e-38 to 1e30.
  RansacPlanesResult run(const DepthView& depth, std::span<FoundPlane> out,
                         ImageView<std::uint16_t> labels) noexcept;

 private:
  RansacPlanesResult find(ransac::Readings& readings, std::span<FoundPlane> out,
                          ImageView<std::uint16_t> labels) noexcept;
  RansacPlanesResult refused(Status status) const noexcept;

  RansacOptions options_;
  detail::RansacPlanesMemory memory_;
  std::size_t readings_ = 0;
};

}  // namespace straightedge
