// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "map/picture_rows.hpp"
#include "straightedge/host/image.hpp"
#include "straightedge/host/line_map_builder.hpp"

namespace straightedge {

/// What was found out about a picture.
struct PictureFacts {
  PictureKind kind = PictureKind::photo;  ///< map or photo
  bool clipped = false;  ///< stretching cut off what is lighter than the darkest ground or darker than black
  bool noisy = false;    ///< grain or specks all over it
  bool crisp = false;    ///< no gray between wall and ground
  bool soft = false;     ///< many grays between wall and ground: edges are blurred or antialiased
  double ground = 255;   ///< the darkest level of ground in `gray`
  double wall_below = 256;  ///< a wall's core is darker than this in `gray`; 256: no such rule
  double free_above = -1;   ///< open floor is lighter than this in `gray`
};

/// The picture as the line map sees it.
///
/// A map has ground (free floor, unknown space) and walls that are darker than any ground. Everything at
/// least as light as the darkest ground is made white, the darkest level black: then neither the border
/// of unknown space nor a laser ray drawn into it is an edge, and walls have the same contrast in every map.
/// Where ground and walls are 250 levels apart, that is so already.
struct Picture : PictureFacts {
  GrayView gray;                                ///< as given, inverted where the map says `negate`
  GrayView stretched;                           ///< black = wall, white = ground; a photo as it is
  Image<std::uint8_t> own_gray, own_stretched;  ///< memory for what differs from what was given

  Picture() = default;
  Picture(const Picture&) = delete;
  Picture& operator=(const Picture&) = delete;
  Picture(Picture&&) = default;
  Picture& operator=(Picture&&) = default;
  ~Picture() = default;

  PictureFacts& facts() { return *this; }
};

/// A copy, negated or not, in the memory of `out` if it fits.
void copy_gray(GrayView gray, bool negate, Image<std::uint8_t>& out);

/// Owns all that it shows.
Picture understand_picture(GrayView gray, PictureKind asked, const std::optional<RosMeaning>& meaning);

/// May show pixels of `gray`, which has to live on. Memory that `picture` has is used again.
void understand_picture(GrayView gray, PictureKind asked, const std::optional<RosMeaning>& meaning,
                        const PictureRowKernels& kernels, Picture& picture);

}  // namespace straightedge
