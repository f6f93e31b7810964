// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <memory>
#include <vector>

#include "rows.hpp"
#include "straightedge/canny.hpp"
#include "straightedge/hough_lines.hpp"

namespace bench {
namespace {

using namespace straightedge;

/// The edges of a picture with their gradients, and a transform prepared for them.
struct Transform {
  Transform(const Job& job, const HoughOptions& options)
      : edges(job.size, 0),
        canny_workspace(Canny::workspace_bytes(job.size, {})),
        workspace(HoughLines::workspace_bytes(job.size, options)),
        peaks(1 << 16),
        segments(1 << 18) {
    require(Canny::prepare(canny, job.size, {}, canny_workspace), "prepare canny");
    require(canny.run(make_picture(job), edges.view()).status, "canny");
    require(HoughLines::prepare(lines, job.size, options, workspace), "prepare hough");
  }

  Image<std::uint8_t> edges;
  std::vector<std::byte> canny_workspace, workspace;
  std::vector<HoughPeak> peaks;
  std::vector<HoughSegment> segments;
  Canny canny;
  HoughLines lines;
};

auto prepare_hough(const HoughOptions& options) {
  return [options](const Job& job) {
    auto t = std::make_shared<Transform>(job, options);
    return [t] {
      const GradientView gradients{t->canny.gradient_x(), t->canny.gradient_y()};
      const HoughResult result = t->lines.run(t->edges, gradients, t->peaks, t->segments);
      require(result.status, "hough");
      require_some(result.segments, "segments");
    };
  };
}

}  // namespace

void add_hough_rows(const Job& job) {
  add_row("hough_standard", job, prepare_hough({.method = HoughMethod::standard}));
  add_row("hough_progressive", job, prepare_hough({.method = HoughMethod::progressive}));
  add_row("hough_progressive_window", job,
          prepare_hough({.method = HoughMethod::progressive, .gradient_window = 0.2}));
  add_row("hough_randomized", job, prepare_hough({.method = HoughMethod::randomized}));
}

}  // namespace bench
