// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "straightedge/host/line_map_builder.hpp"

#include <algorithm>
#include <cstddef>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "map/bridge.hpp"
#include "map/candidates.hpp"
#include "map/corners.hpp"
#include "map/edge_follower.hpp"
#include "map/edge_planes.hpp"
#include "map/export.hpp"
#include "map/extent.hpp"
#include "map/furniture.hpp"
#include "map/merge.hpp"
#include "map/picture.hpp"
#include "map/strokes.hpp"
#include "map/support.hpp"
#include "map/walls.hpp"
#include "straightedge/hough_grid.hpp"

namespace straightedge {
namespace {

constexpr double corner_reach = 3.5;     // pixels
constexpr double lone_edge_share = 1.5;  // of the shortest length asked for; without refinement
constexpr double shortest_edge = 8;      // pixels, where no shorter ones are asked for
constexpr double shortest_in_map = 6;    // without noise; ragged walls come in such short ones
constexpr double longest_hole = 8;       // pixels, of an edge; walls are bridged later
constexpr std::size_t few_places = 24;   // of an edge, without refinement

bool valid(const LineMapOptions& o) {
  return o.min_length >= 3 && o.min_length <= 1e6 && o.max_gap >= 0 && o.max_gap <= 1e6 &&
         o.max_wall_width >= 0 && o.max_wall_width <= 50 && o.furniture_size >= 0 && o.furniture_size <= 1e6;
}

bool valid(const RosMeaning& m) {
  return m.free_thresh >= 0 && m.free_thresh <= m.occupied_thresh && m.occupied_thresh <= 1;
}

Failure failure_of(const char* stage, Status status) {
  const bool option = status == Status::invalid_option || status == Status::too_large;
  return {option ? Problem::bad_option : Problem::internal, std::string(stage) + ": " + to_string(status)};
}

std::optional<Failure> refuse(GrayView gray, const LineMapOptions& options) {
  constexpr std::int32_t longest_side = 32767;  // pixels, however straight edges are found
  if (!gray.valid()) return Failure{Problem::bad_content, "the picture has no pixels"};
  if (!valid(options) || (options.meaning && !valid(*options.meaning)))
    return failure_of("the line map's options", Status::invalid_option);
  if (gray.width > longest_side || gray.height > longest_side)
    return failure_of("the line map", Status::too_large);
  if (!options.hough) return {};
  if (!options.refine)
    return Failure{Problem::bad_option, "without refinement there is no Hough transform; leave hough out"};
  const Status may = hough_grid(gray.size(), first_round(options)).status;
  if (may != Status::ok) return failure_of("the Hough transform", may);
  return {};
}

struct Edges {
  EdgePlanes planes;     ///< of the stretched picture
  EdgePlanes given;      ///< of the one as given, where that is another
  bool as_given = true;  ///< it is the same

  /// Directions from the stretched picture, positions from the one as given: stretching cuts off the light
  /// end of each edge and would move it towards the dark.
  EdgeSources sources() const {
    return {planes.gradients(), as_given ? planes.gradients() : given.gradients()};
  }
};

/// The gradient is kept where it votes, and in pictures so small that it stays in a processor's cache: there
/// it takes longer to make it anew.
Kept kept_of(Size size, const LineMapOptions& options) {
  constexpr std::int64_t small_picture = std::int64_t{1} << 19U;  // pixels
  const bool is_small = std::int64_t{size.width} * size.height <= small_picture;
  return options.hough || is_small ? Kept::gradient : Kept::blurred;
}

Status detect_edges(const Picture& picture, const LineMapOptions& options, const KernelSet& kernels,
                    Edges& edges) {
  const Kept kept = kept_of(picture.gray.size(), options);
  // Where stretching has cut nothing off, the stretched picture has its edges where the given one has them.
  edges.as_given = !picture.clipped;
  if (picture.clipped) {
    const Status status = edges.given.detect(picture.gray, options.canny, kernels, kept, Wanted::no_edges);
    if (status != Status::ok) return status;
  }
  return edges.planes.detect(picture.stretched, options.canny, kernels, kept);
}

FollowOptions follow_options(const LineMapOptions& options, const Picture& picture) {
  const bool short_ones = picture.kind == PictureKind::map && !picture.noisy;
  FollowOptions follow;
  follow.min_length = std::min(short_ones ? shortest_in_map : shortest_edge, options.min_length);
  follow.max_gap = std::min(options.max_gap, longest_hole);
  follow.norm = options.canny.norm;
  if (!options.refine) follow.places = few_places;
  return follow;
}

/// Steps 4 to 6: what only a map can tell, for only there dark means wall.
void read_walls(const Picture& picture, GrayView blurred, const LineMapOptions& options,
                const PictureRowKernels& kernels, Image<std::uint8_t>& marks, std::vector<WallLine>& lines,
                LineMapReport& report) {
  const LineSampler stretched(picture.stretched, kernels);
  report.walls = join_thin_walls(lines, stretched, options.max_wall_width);
  report.walls += turn_strokes_to_axes(lines, stretched, options.max_wall_width);
  const std::size_t before = lines.size();
  lines = measure_extents(lines, picture, blurred, {options.max_gap, options.max_wall_width}, kernels);
  lines = keep_supported(lines, picture, {}, marks, kernels);
  report.no_wall = static_cast<std::uint32_t>(before > lines.size() ? before - lines.size() : 0);
}

/// Takes the short lines out; corners may still lie on them.
std::vector<WallLine> split_off_short(std::vector<WallLine>& lines, double min_length) {
  std::vector<WallLine> kept, helpers;
  for (const WallLine& line : lines) (line.length() >= min_length ? kept : helpers).push_back(line);
  lines = std::move(kept);
  return helpers;
}

std::vector<std::vector<std::size_t>> long_enough(const std::vector<WallLine>& lines,
                                                  const std::vector<std::vector<std::size_t>>& groups,
                                                  double min_length) {
  std::vector<std::vector<std::size_t>> out;
  for (std::vector<std::size_t> group : groups) {
    std::erase_if(group, [&](std::size_t i) { return lines[i].length() < min_length; });
    if (!group.empty()) out.push_back(std::move(group));
  }
  return out;
}

/// The map's frame, and the report's last numbers.
void finish(const std::vector<WallLine>& lines, const std::vector<std::vector<std::size_t>>& groups,
            const PictureFacts& picture, Size size, const std::optional<RosMeaning>& meaning,
            LineMapResult& out) {
  out.map.lines = to_map_lines(lines, groups, picture, size);
  out.map.image = MapImage{.file = {}, .size = size, .placement = {}, .meaning = meaning};
  for (const MapLine& line : out.map.lines)
    out.report.segments += static_cast<std::uint32_t>(line.segments.size());
  out.report.lines = static_cast<std::uint32_t>(out.map.lines.size());
}

}  // namespace

struct LineMapBuilder::Room {
  Picture picture;
  Edges edges;
  EdgeRoom candidates;
  EdgeFollower follower;
  EdgeBits bits;
  Image<std::uint8_t> marks;
};

LineMapBuilder::LineMapBuilder(const LineMapOptions& options, const KernelSet& kernels)
    : options_(options), kernels_(kernels), room_(std::make_unique<Room>()) {}

LineMapBuilder::~LineMapBuilder() = default;
LineMapBuilder::LineMapBuilder(LineMapBuilder&&) noexcept = default;
LineMapBuilder& LineMapBuilder::operator=(LineMapBuilder&&) noexcept = default;

Result<LineMapResult> LineMapBuilder::build_coarse(GrayView gray) {
  const LineMapOptions& options = options_;
  LineMapResult out;
  GrayView seen = gray;
  if (options.meaning && options.meaning->negate) {
    copy_gray(gray, true, room_->picture.own_gray);
    seen = room_->picture.own_gray;
  }
  // Step 2.
  EdgePlanes& planes = room_->edges.planes;
  const Status status = planes.detect(seen, options.canny, kernels_, kept_of(seen.size(), options));
  if (status != Status::ok) return failure_of("the edge detector", status);
  out.report.picture = PictureKind::automatic;
  out.report.canny = planes.result;
  // Step 3.
  planes.to_bits(room_->bits);
  std::vector<WallLine> lines = room_->follower.run(room_->bits, {planes.gradients(), planes.gradients()},
                                                    follow_options(options, {}), *kernels_.picture_rows);
  out.report.candidates = out.report.edges = static_cast<std::uint32_t>(lines.size());
  // Step 4.
  const LineSampler sampler(seen, *kernels_.picture_rows);
  if (options.picture != PictureKind::photo)
    out.report.walls = join_thin_walls(lines, sampler, options.max_wall_width);
  // Step 7.
  out.report.merged = merge_fragments(lines, {}, {});
  // Step 9: nobody has looked whether a lone edge is a wall's, and most short ones are not.
  const std::size_t before = lines.size();
  std::erase_if(lines, [&](const WallLine& line) {
    return line.length() < (line.axis ? 1 : lone_edge_share) * options.min_length;
  });
  out.report.too_short = static_cast<std::uint32_t>(before - lines.size());
  // Step 10.
  std::vector<std::vector<std::size_t>> groups(lines.size());
  for (std::size_t i = 0; i < lines.size(); ++i) groups[i] = {i};
  finish(lines, groups, {}, gray.size(), options.meaning, out);
  return out;
}

Result<LineMapResult> LineMapBuilder::build(GrayView gray) {
  const LineMapOptions& options = options_;
  if (auto failure = refuse(gray, options)) return *failure;
  if (!options.refine) return build_coarse(gray);
  LineMapResult out;
  LineMapReport& report = out.report;
  // Step 1: what the picture shows.
  Picture& picture = room_->picture;
  understand_picture(gray, options.picture, options.meaning, *kernels_.picture_rows, picture);
  report.picture = picture.kind;
  // Step 2: edges.
  Edges& edges = room_->edges;
  Status status = detect_edges(picture, options, kernels_, edges);
  if (status != Status::ok) return failure_of("the edge detector", status);
  report.canny = edges.planes.result;
  // Step 3: straight edges, each with pixels of its own.
  std::vector<WallLine> lines;
  if (options.hough) {
    status = find_edges(edges.planes.to_pixels(), edges.sources(), options, kernels_, room_->candidates,
                        lines, report);
    if (status != Status::ok) return failure_of("the Hough transform", status);
  } else {
    edges.planes.to_bits(room_->bits);
    lines = room_->follower.run(room_->bits, edges.sources(), follow_options(options, picture),
                                *kernels_.picture_rows);
    report.candidates = report.edges = static_cast<std::uint32_t>(lines.size());
  }
  // Steps 4 to 6: thin walls become axes, ends are measured, what is no wall goes.
  const bool map = picture.kind == PictureKind::map;
  if (map)
    read_walls(picture, edges.planes.blurred, options, *kernels_.picture_rows, room_->marks, lines, report);
  // Step 7: one segment where several lie on one another; small things that stand alone go.
  const MergeOptions merge;
  report.merged = merge_fragments(lines, picture, merge);
  const std::vector<WallLine> helpers = split_off_short(lines, options.min_length - corner_reach);
  if (map) {
    report.furniture = drop_furniture(lines, picture.stretched, options.furniture_size,
                                      options.max_wall_width, room_->marks);
  }
  // Step 8: segments of one infinite line share its fit.
  const auto groups = group_collinear(lines, picture, merge);
  const std::uint32_t bridged = picture.noisy ? bridge_pale_gaps(lines, groups, edges.planes.blurred) : 0;
  report.merged += bridged;
  // Step 9: corners are closed; what is too short goes.
  if (map) close_corners(lines, helpers, corner_reach);
  const auto kept = long_enough(lines, groups, options.min_length);
  // Step 10: the map's frame.
  finish(lines, kept, picture, gray.size(), options.meaning, out);
  report.too_short = static_cast<std::uint32_t>(helpers.size() + lines.size() - bridged - report.segments);
  return out;
}

Result<LineMapResult> build_line_map(GrayView gray, const LineMapOptions& options, const KernelSet& kernels) {
  return LineMapBuilder(options, kernels).build(gray);
}

}  // namespace straightedge
