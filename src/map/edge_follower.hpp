// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "hough/corridor.hpp"
#include "map/edge_bits.hpp"
#include "map/edge_reading.hpp"
#include "map/picture_rows.hpp"
#include "map/wall_line.hpp"
#include "straightedge/edge_position.hpp"
#include "straightedge/magnitude.hpp"

namespace straightedge {

struct FollowOptions {
  double min_length = 9;                 ///< pixels; shorter edges are none
  double max_gap = 8;                    ///< pixels; a longer hole ends an edge
  std::size_t places = 48;               ///< of an edge that are found between the pixels, at most; up to 128
  GradientNorm norm = GradientNorm::l1;  ///< of the gradient, where positions have no magnitude
};

/// Straight edges without a vote: each is followed from one of its pixels to both ends. Every pixel is
/// looked at about twice, and belongs to one edge.
///
/// 1. Seeds are edge pixels on a lattice, one pixel of five. Twice over the picture: the first time for long
///    edges, the second time for short ones among what is left, and with the mirrored lattice, so that
///    whatever way an edge runs, it has some seeds.
/// 2. At the seed the line to begin with is at right angles to the gradient. Walk along it to both sides,
///    a column (steep: a row) a step, and take the pixels of a corridor whose gradient points to the same
///    side, until a hole is longer than max_gap.
/// 3. Every some steps, more each time, lay a line through the pixels so far: least squares over whole
///    pixels, in integers. The corridor goes on along it.
/// 4. Few pixels for its length, or too short: no edge, all stays as it was. Else find where some of its
///    pixels lie between the pixels (edge_position.hpp). The line is that of the longest part of these places
///    that is straight (straight_part.hpp); what lies beyond a bend is left for another.
/// 5. The pixels taken are gone, and so are those beside them that face the same way.
///
/// R. Grompone von Gioi, J. Jakubowicz, J.-M. Morel, G. Randall, "LSD: a fast line segment detector with a
/// false detection control", TPAMI 32(4), 2010, doi:10.1109/TPAMI.2008.300, grows regions of one direction;
/// C. Akinlar, C. Topal, "EDLines", Pattern Recognition Letters 32(13), 2011,
/// doi:10.1016/j.patrec.2011.06.001, fits while it follows.
class EdgeFollower {
 public:
  /// The edges in the order in which they were found. Of `edges` those stay that no line took. Where
  /// directions are stored, the rows of both gradients have to be equally far apart.
  std::vector<WallLine> run(EdgeBits& edges, const EdgeSources& sources, const FollowOptions& options,
                            const PictureRowKernels& kernels);

 private:
  /// A pixel on the way: the step that it belongs to, and where across.
  struct Pixel {
    std::int32_t step, across;
    bool inside;  ///< the corridor, else beside it
  };
  /// One of the two ways from the seed.
  struct Way {
    std::int32_t direction = 1;
    std::int32_t step = 0;  ///< the next one
    std::int64_t hole = 0;
    bool going = true;
    Pixel last;               ///< inside
    std::size_t visited = 0;  ///< pixels
    std::size_t up_to_last = 0;
    std::vector<Pixel> pixels;
  };
  /// Over the pixels inside, from the seed.
  struct Sums {
    std::int64_t count = 0, step = 0, across = 0, step_step = 0, step_across = 0;
  };

  bool follow(std::int32_t x, std::int32_t y, double min_length, WallLine& line);
  void start(std::int32_t x, std::int32_t y);
  void go_on(Way& way, std::int32_t steps);
  template <bool steep, class Gradients>
  void walk(Way& way, std::int32_t steps, const Gradients& gradients);
  bool lay_line();
  bool is_edge(double min_length) const;
  bool fit(WallLine& line);
  StripRule read_places();
  std::uint32_t take_pixels();

  std::int32_t column(const Pixel& p) const { return steep_ ? p.across : p.step; }
  std::int32_t row(const Pixel& p) const { return steep_ ? p.step : p.across; }

  EdgeBits* edges_ = nullptr;
  EdgeSources sources_;
  FollowOptions options_;
  const PictureRowKernels* kernels_ = nullptr;
  // The edge that is being followed.
  bool steep_ = false;
  Pixel seed_{};
  refitting::Corridor strip_;
  Sums sums_;
  std::array<Way, 2> ways_;
  Pixel first_{}, last_{};  ///< of the part that is straight
  std::unique_ptr<EdgeBatch> places_ = std::make_unique<EdgeBatch>();
  std::unique_ptr<StripBatch> strip_places_ = std::make_unique<StripBatch>();
};

}  // namespace straightedge
