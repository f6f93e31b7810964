// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "map/picture_rows.hpp"
#include "map/sample.hpp"
#include "map/wall_line.hpp"
#include "straightedge/image.hpp"

namespace straightedge {

/// Gray between the pixels along a line or across it, many places at once; each as `sample` gives it.
class LineSampler {
 public:
  explicit LineSampler(GrayView image, const PictureRowKernels& kernels = plain_picture_row_kernels)
      : image_(image), kernels_(kernels) {}

  Size size() const { return image_.size(); }

  /// At the place s along the line, each u to the side of it.
  void across(const WallLine& line, double s, std::span<const double> u, double* gray) const {
    read({.x = line.x_at(s), .y = line.y_at(s), .step_x = line.nx, .step_y = line.ny}, u, gray);
  }

  /// At the places s along the line, u to the side of it.
  void along(const WallLine& line, std::span<const double> s, double u, double* gray) const {
    read({.x = line.fit.centroid_x,
          .y = line.fit.centroid_y,
          .step_x = line.tx(),
          .step_y = line.ty(),
          .aside_x = u * line.nx,
          .aside_y = u * line.ny},
         s, gray);
  }

 private:
  void read(SampleWay way, std::span<const double> steps, double* gray) const {
    if (image_.width < 2 || image_.height < 2) {
      for (std::size_t i = 0; i < steps.size(); ++i)
        gray[i] = sample(image_, way.x + steps[i] * way.step_x + way.aside_x,
                         way.y + steps[i] * way.step_y + way.aside_y);
      return;
    }
    way.pixels = image_.data;
    way.stride = image_.stride;
    way.width = image_.width;
    way.height = image_.height;
    kernels_.sample(way, steps.data(), static_cast<std::int32_t>(steps.size()), gray);
  }

  GrayView image_;
  const PictureRowKernels& kernels_;
};

}  // namespace straightedge
