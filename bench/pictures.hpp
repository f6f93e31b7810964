// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>

#include "straightedge/host/image.hpp"

namespace bench {

enum class Picture { photo, floor_plan };

struct Job {
  Picture picture = Picture::photo;
  straightedge::Size size;

  /// "photo/640x480"
  std::string name() const;
};

/// A shipped photo, laid side by side with its mirror images until the size is filled; or a floor plan
/// drawn here: rooms with walls three pixels thick, doors, a slanted wing. Ends the program with a
/// sentence when the photo cannot be read.
straightedge::Image<std::uint8_t> make_picture(const Job& job);

}  // namespace bench
