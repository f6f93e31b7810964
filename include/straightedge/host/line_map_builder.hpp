// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "straightedge/canny.hpp"
#include "straightedge/host/kernels.hpp"
#include "straightedge/host/line_map.hpp"
#include "straightedge/host/result.hpp"
#include "straightedge/hough_lines.hpp"

namespace straightedge {

/// What the picture is of, which decides what may become a line.
enum class PictureKind : std::uint8_t {
  automatic,  ///< a map when most of it is light, even ground; else a photo
  map,        ///< dark walls on lighter ground; only what is dark is wall
  photo,      ///< every edge is a line
};

/// For LineMapOptions::hough. Coarse segments are all that is asked of the Hough transform here: refinement
/// does the rest.
inline constexpr HoughOptions line_map_hough{
    .threshold = 14, .min_length = 10, .max_gap = 4, .gradient_window = 0.3};

struct LineMapOptions {
  PictureKind picture = PictureKind::automatic;
  CannyOptions canny{.low = 40, .high = 110};
  std::optional<HoughOptions> hough = {};  ///< none: straight edges are followed; else they are voted for
  double min_length = 9;                   ///< pixels, 3..1e6; shorter segments are dropped
  double max_gap = 10;                     ///< pixels, 0..1e6; a hole in a wall up to this long is bridged
  double max_wall_width = 3.6;  ///< pixels, 0..50; thinner walls become one axis, thicker keep both faces
  double furniture_size = 26;   ///< pixels, 0..1e6; solid things that stand alone and fit in are dropped
  bool refine = true;           ///< false: edges are followed, thin walls joined, and no more
  std::optional<RosMeaning> meaning = {};  ///< a ROS map's thresholds decide what is wall
};

/// What the first round of the Hough transform is asked for, if there is one: `hough`, but short segments can
/// only come out when short ones are looked for.
constexpr HoughOptions first_round(const LineMapOptions& options) noexcept {
  HoughOptions hough = options.hough.value_or(line_map_hough);
  if (options.min_length < hough.min_length) hough.min_length = options.min_length;
  return hough;
}

/// What happened on the way, stage by stage.
struct LineMapReport {
  PictureKind picture = PictureKind::photo;  ///< what it was taken for; without `refine` nobody asks
  CannyResult canny;
  HoughResult hough;             ///< of the first round, if there was one
  std::uint32_t rounds = 0;      ///< of the Hough transform, each on the pixels that the one before left;
                                 ///< none where edges are followed
  std::uint32_t candidates = 0;  ///< segments of the Hough transform, all rounds; without it edges
  std::uint32_t edges = 0;       ///< of them held as straight edges with pixels of their own
  std::uint32_t walls = 0;       ///< pairs of edges joined into the axis of a thin wall
  std::uint32_t no_wall = 0;     ///< dropped: too pale, too little support, or wall on both sides
  std::uint32_t merged = 0;      ///< became part of another segment
  std::uint32_t furniture = 0;   ///< dropped: faces of small things that stand alone
  std::uint32_t too_short = 0;   ///< dropped for their length
  std::uint32_t segments = 0;    ///< in the map
  std::uint32_t lines = 0;       ///< in the map
};

struct LineMapResult {
  LineMap map;
  LineMapReport report;
};

/// The whole way from gray picture to line map; each step's manual is in src/map (docs/line-map.md).
///
///  1. What the picture shows: map or photo, ground levels, noise.
///  2. Edges by Canny; positions from the picture as given, directions from the stretched one.
///  3. Straight edges: each is followed from pixel to pixel, and fit between the pixels. With `hough`: rounds
///     of the Hough transform, each segment refit between the pixels.
///  4. The two edges of a thin wall become its axis; so does one, when the other was too ragged to be found.
///  5. Ends are read from the gray along each line, between the pixels.
///  6. What the picture does not show as wall goes.
///  7. Segments that lie on one another become one; small things that stand alone go.
///  8. Segments of one infinite line share its fit; in noise, gaps that show the wall's contrast are bridged.
///  9. Corners are closed; what is too short goes.
/// 10. The map's frame, normal form and covariance.
/// Steps 4 to 6 and the furniture of step 7 are for maps alone.
///
/// Without `refine`, in half the time: edges by Canny of the picture as given; each is followed from
/// pixel to pixel; thin walls become axes as in step 4, unless the picture is said to be a photo; pieces of
/// one edge are joined; lone edges shorter than 1.5 min_length go. Ends are those of the pixels, about two
/// pixels off, and each segment is a line.
///
/// Failures: bad_content (no pixels), bad_option (out of range; `hough` without `refine`; sides above 32767
/// pixels, or a picture too large for the Hough transform). Time proportional to the pixels plus the lines;
/// memory about 15 bytes a pixel. Nothing depends on the kernels but the time.
Result<LineMapResult> build_line_map(GrayView gray, const LineMapOptions& options = {},
                                     const KernelSet& kernels = best_kernels());

/// The same for one picture after the other. Memory is kept: for pictures of one size that saves a good part
/// of the time.
class LineMapBuilder {
 public:
  explicit LineMapBuilder(const LineMapOptions& options = {}, const KernelSet& kernels = best_kernels());
  ~LineMapBuilder();
  LineMapBuilder(LineMapBuilder&&) noexcept;
  LineMapBuilder& operator=(LineMapBuilder&&) noexcept;

  Result<LineMapResult> build(GrayView gray);

 private:
  struct Room;
  Result<LineMapResult> build_coarse(GrayView gray);

  LineMapOptions options_;
  KernelSet kernels_;
  std::unique_ptr<Room> room_;
};

}  // namespace straightedge
