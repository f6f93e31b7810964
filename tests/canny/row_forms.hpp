// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "canny/stages.hpp"
#include "straightedge/canny_fused.hpp"
#include "straightedge/canny_rows.hpp"

// The two forms of Canny that keep rows, run on exactly the memory they ask for, with guards on both sides.
namespace row_forms {

using namespace stages;

/// Edges and what was counted. `result.status` is `cancelled` when bytes outside the workspace were written.
struct Found {
  GrayImage edges;
  CannyResult result;
};

/// Memory that begins at an odd address, between guards.
class GuardedWorkspace {
 public:
  explicit GuardedWorkspace(std::size_t size) : bytes_(size + 2 * guard, pattern), size_(size) {}

  std::span<std::byte> bytes() { return std::span(bytes_).subspan(guard, size_); }
  bool guards_intact() const {
    for (std::size_t i = 0; i < bytes_.size(); ++i) {
      if ((i < guard || i >= guard + size_) && bytes_[i] != pattern) return false;
    }
    return true;
  }

 private:
  static constexpr std::size_t guard = 101;
  static constexpr std::byte pattern{0x5A};
  std::vector<std::byte> bytes_;
  std::size_t size_;
};

inline Found by_planes(const GrayImage& gray, const CannyOptions& options) {
  Detector detector(gray.size(), options);
  Found found{GrayImage(gray.size()), {}};
  found.result = detector.canny.run(gray.view(), found.edges.view());
  return found;
}

inline Found fused(const GrayImage& gray, const CannyOptions& options, const CannyRowOptions& rows = {}) {
  GuardedWorkspace workspace(FusedCanny::workspace_bytes(gray.size(), options, rows));
  FusedCanny canny;
  Found found{GrayImage(gray.size(), 3, std::uint8_t{77}), {}};
  found.result.status = FusedCanny::prepare(canny, gray.size(), options, workspace.bytes(), rows);
  if (found.result.status != Status::ok) return found;
  found.result = canny.run(gray.view(), found.edges.view());
  if (!workspace.guards_intact() || !found.edges.guards_intact()) found.result.status = Status::cancelled;
  return found;
}

/// One row, pushed from memory of its own, so that reading beyond it is seen by a sanitizer.
inline Status push(CannyRows& canny, const GrayImage& gray, int y) {
  const std::uint8_t* const row = gray.view().row(y);
  const std::vector<std::uint8_t> pixels(row, row + gray.size().width);
  return canny.push_row(pixels);
}

inline Status read(const CannyRows& canny, GrayImage& edges) {
  for (int y = 0; y < edges.size().height; ++y) {
    const auto width = static_cast<std::size_t>(edges.size().width);
    const Status status = canny.read_row(y, {edges.view().row(y), width});
    if (status != Status::ok) return status;
  }
  return Status::ok;
}

inline Found by_rows(const GrayImage& gray, const CannyOptions& options, const CannyRowOptions& rows = {}) {
  GuardedWorkspace workspace(CannyRows::workspace_bytes(gray.size(), options, rows));
  CannyRows canny;
  Found found{GrayImage(gray.size(), 3, std::uint8_t{77}), {}};
  Status status = CannyRows::prepare(canny, gray.size(), options, workspace.bytes(), rows);
  if (status == Status::ok) status = canny.begin();
  for (int y = 0; y < gray.size().height && status == Status::ok; ++y) status = push(canny, gray, y);
  if (status == Status::ok) found.result = canny.finish();
  if (status == Status::ok) status = read(canny, found.edges);
  if (status != Status::ok) found.result.status = status;
  if (!workspace.guards_intact() || !found.edges.guards_intact()) found.result.status = Status::cancelled;
  return found;
}

inline bool same(const Found& a, const Found& b) {
  return a.result.status == b.result.status && a.result.strong == b.result.strong &&
         a.result.edges == b.result.edges && a.result.low == b.result.low && a.result.high == b.result.high &&
         a.edges == b.edges;
}

}  // namespace row_forms
