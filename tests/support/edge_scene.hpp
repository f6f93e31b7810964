// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>

#include "straightedge/canny.hpp"
#include "straightedge/edge_position.hpp"
#include "straightedge/host/image.hpp"
#include "support/catch.hpp"

namespace support {

/// A picture's edge pixels and the gradient that Canny found them by.
class EdgeScene {
 public:
  explicit EdgeScene(straightedge::GrayView picture, const straightedge::CannyOptions& options = {})
      : mask(picture.size()) {
    const std::size_t bytes = straightedge::Canny::workspace_bytes(picture.size(), options);
    workspace_ = std::make_unique<std::byte[]>(bytes);
    REQUIRE(straightedge::Canny::prepare(canny_, picture.size(), options, {workspace_.get(), bytes}) ==
            straightedge::Status::ok);
    REQUIRE(canny_.run(picture, mask.view()).status == straightedge::Status::ok);
  }

  straightedge::GradientField field() const {
    return {canny_.gradient_x(), canny_.gradient_y(), canny_.magnitude()};
  }

  straightedge::GrayView blurred() const { return canny_.blurred(); }

  straightedge::Image<std::uint8_t> mask;

 private:
  std::unique_ptr<std::byte[]> workspace_;
  straightedge::Canny canny_;
};

}  // namespace support
