// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>

#include "canny/edge_words.hpp"
#include "map/edge_bits.hpp"
#include "map/pixel_gradient.hpp"
#include "straightedge/canny.hpp"
#include "straightedge/host/image.hpp"
#include "straightedge/host/kernels.hpp"

namespace straightedge {

/// What of the stages before the edges is kept for all pixels.
enum class Kept : std::uint8_t {
  gradient,  ///< and the blurred picture
  blurred,   ///< this alone, where single gradients can be made from it anew; else as `gradient`
};

/// Whether edges are asked for, or only what is kept.
enum class Wanted : std::uint8_t { edges, no_edges };

/// What Canny leaves behind: edges, and of the stages before them those that a line map reads again.
class EdgePlanes {
 public:
  GrayView blurred;
  ImageView<const std::int16_t> dx, dy;  ///< none where they can be made anew
  CannyResult result;

  /// The results of canny.hpp, bit for bit. Row by row with the kernels given, with automatic thresholds
  /// stage by stage.
  Status detect(GrayView gray, const CannyOptions& options, const KernelSet& kernels,
                Kept kept = Kept::gradient, Wanted wanted = Wanted::edges);

  GradientSource gradients() const;

  /// The edges, where they were wanted: as bits, or 255 in a picture.
  void to_bits(EdgeBits& bits) const;
  GrayView to_pixels();

 private:
  void reserve(std::size_t bytes);
  Status by_rows(GrayView gray, const CannyOptions& options, const CannyRowKernels& kernels, Kept kept,
                 Wanted wanted);
  Status by_stages(GrayView gray, const CannyOptions& options);

  std::unique_ptr<std::byte[]> memory_;
  std::size_t bytes_ = 0;
  EdgeWords words_;             ///< the edges; none where Canny went stage by stage
  Image<std::uint8_t> pixels_;  ///< then they are here
  const CannyRowKernels* kernels_ = nullptr;
};

}  // namespace straightedge
