// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

#include "straightedge/canny.hpp"
#include "straightedge/host/image.hpp"

namespace straightedge {

struct CannyEdges {
  Image<std::uint8_t> edges;  ///< 255 on edges, 0 elsewhere; empty unless `result.status` is ok
  CannyResult result;
};

/// Canny's edge detector in one line: takes its memory, runs once, gives everything back but the edges.
/// For a stream of images of one size, keep a `Canny` and its workspace instead.
inline CannyEdges canny(GrayView gray, const CannyOptions& options = {}) {
  CannyEdges found;
  if (!gray.valid()) {
    found.result.status = Status::invalid_image;
    return found;
  }
  found.result.status = Canny::check(gray.size(), options);
  if (found.result.status != Status::ok) return found;
  const std::size_t bytes = Canny::workspace_bytes(gray.size(), options);
  const auto workspace = std::make_unique_for_overwrite<std::byte[]>(bytes);
  Canny detector;
  found.result.status = Canny::prepare(detector, gray.size(), options, {workspace.get(), bytes});
  if (found.result.status != Status::ok) return found;
  found.edges = Image<std::uint8_t>(gray.size());
  found.result = detector.run(gray, found.edges.view());
  return found;
}

}  // namespace straightedge
