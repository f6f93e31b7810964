// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <cstddef>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "alternation.hpp"
#include "line_cover.hpp"
#include "photos.hpp"
#include "pictures.hpp"
#include "rows.hpp"
#include "straightedge/canny.hpp"
#include "straightedge/host/hough_lines.hpp"
#include "straightedge/host/kernels.hpp"
#include "straightedge/host/line_map_builder.hpp"

namespace compare {
namespace {

using namespace straightedge;

/// OpenCV's numbers and habits, so that both find the same segments in the same order.
constexpr HoughOptions as_opencv{
    .threshold = 50, .min_length = 30, .max_gap = 10, .generator = HoughGenerator::opencv};

/// What finds the walls of floor plans, short ones too; a window leaves chance fewer votes, so that it can
/// ask for more.
constexpr HoughOptions wall_options{.threshold = 20, .min_length = 12, .max_gap = 6};
constexpr HoughOptions window_options{
    .threshold = 25, .min_length = 12, .max_gap = 6, .gradient_window = 0.1};

void opencv_lines(const cv::Mat& edges, const HoughOptions& options, std::vector<cv::Vec4i>& lines) {
  cv::HoughLinesP(edges, lines, options.rho_step, options.theta_step, options.threshold, options.min_length,
                  options.max_gap);
}

bool same(const std::vector<HoughSegment>& ours, const std::vector<cv::Vec4i>& theirs) {
  if (ours.size() != theirs.size()) return false;
  for (std::size_t i = 0; i < ours.size(); ++i) {
    const HoughSegment& s = ours[i];
    if (theirs[i] != cv::Vec4i(s.x0, s.y0, s.x1, s.y1)) return false;
  }
  return true;
}

void print_equal_rows(Size size, int rounds) {
  std::vector<cv::Mat> edges = photos(size);
  for (cv::Mat& picture : edges) cv::Canny(picture.clone(), picture, 50, 150);
  std::vector<std::vector<HoughSegment>> ours(edges.size());
  std::vector<std::vector<cv::Vec4i>> theirs(edges.size());
  for (const KernelSet& kernels : kernel_sets()) {
    HoughOptions options = as_opencv;
    options.kernels = kernels.hough;
    const auto run_ours = [&] {
      for (std::size_t i = 0; i < edges.size(); ++i)
        ours[i] = hough_lines(view_of(edges[i]), options).segments;
    };
    const auto run_theirs = [&] {
      for (std::size_t i = 0; i < edges.size(); ++i) opencv_lines(edges[i], options, theirs[i]);
    };
    const auto agree = [&] {
      bool equal = true;
      for (std::size_t i = 0; i < edges.size(); ++i) equal = equal && same(ours[i], theirs[i]);
      return equal;
    };
    print_row({"progressive Hough", text_of(size), std::string(kernels.name), run_ours, run_theirs, agree},
              rounds);
  }
}

/// A drawn floor plan with its edges by Canny: what both transforms get, and the gradients.
struct PlanEdges {
  explicit PlanEdges(Size size)
      : plan(bench::make_picture({bench::Picture::floor_plan, size})),
        edges(size),
        memory(Canny::workspace_bytes(size, canny_options)) {
    Status status = Canny::prepare(canny, size, canny_options, memory);
    if (status == Status::ok) status = canny.run(plan, edges.view()).status;
    ready = status == Status::ok;
  }
  static constexpr CannyOptions canny_options{.low = 50, .high = 150};
  Image<std::uint8_t> plan, edges;
  std::vector<std::byte> memory;
  Canny canny;
  bool ready = false;
};

/// Agrees when our segments lie on edges and cover edges as well as theirs do, within a hundredth.
void print_window_rows(Size size, int rounds) {
  PlanEdges scene(size);
  const cv::Mat edges = mat_of(scene.edges);
  std::vector<HoughSegment> ours(1 << 16);
  std::vector<cv::Vec4i> theirs;
  for (const KernelSet& kernels : kernel_sets()) {
    HoughOptions options = window_options;
    options.kernels = kernels.hough;
    std::vector<std::byte> memory(HoughLines::workspace_bytes(size, options));
    HoughLines lines;
    HoughResult found;
    const Status prepared = HoughLines::prepare(lines, size, options, memory);
    const auto run_ours = [&] {
      found = lines.run(scene.edges, {scene.canny.gradient_x(), scene.canny.gradient_y()}, {}, ours);
    };
    const auto run_theirs = [&] { opencv_lines(edges, wall_options, theirs); };
    Cover our_cover, their_cover;
    const auto agree = [&] {
      our_cover = cover_of(edges, ours_as_lines(ours, found.segments));
      their_cover = cover_of(edges, theirs);
      const bool fine = scene.ready && prepared == Status::ok && found.status == Status::ok;
      return fine && our_cover.as_good_as(their_cover);
    };
    print_row({.name = "progressive Hough, gradient window, floor plan",
               .size = text_of(size),
               .kernels = std::string(kernels.name),
               .ours = run_ours,
               .theirs = run_theirs,
               .agree = agree,
               .answers = [&] { return in_words(our_cover, their_cover, "edges"); }},
              rounds);
  }
}

/// Agrees when the map's lines cover the dark pixels as well as the edge segments do.
void print_map_rows(const char* name, const LineMapOptions& options, Size size, int rounds) {
  const auto plan = bench::make_picture({bench::Picture::floor_plan, size});
  const cv::Mat gray = mat_of(plan);
  const cv::Mat walls = gray < 128;
  std::vector<cv::Vec4i> theirs;
  cv::Mat blurred, edges;
  for (const KernelSet& kernels : kernel_sets()) {
    std::vector<cv::Vec4i> ours;
    LineMapBuilder builder(options, kernels);
    const auto run_ours = [&] {
      const auto built = builder.build(plan);
      ours.clear();
      if (built) ours = map_as_lines(built->map, size);
    };
    const auto run_theirs = [&] {
      cv::GaussianBlur(gray, blurred, {5, 5}, 1.4);
      cv::Canny(blurred, edges, 50, 150);
      opencv_lines(edges, wall_options, theirs);
    };
    Cover our_cover, their_cover;
    const auto agree = [&] {
      our_cover = cover_of(walls, ours);
      their_cover = cover_of(walls, theirs);
      return our_cover.as_good_as(their_cover);
    };
    print_row({.name = name,
               .size = text_of(size),
               .kernels = std::string(kernels.name),
               .ours = run_ours,
               .theirs = run_theirs,
               .agree = agree,
               .answers = [&] { return in_words(our_cover, their_cover, "walls"); }},
              rounds);
  }
}

}  // namespace

void print_line_rows(Size size, int rounds) {
  print_equal_rows(size, rounds);
  print_window_rows(size, rounds);
  print_map_rows("picture to line map, floor plan", {}, size, rounds);
  print_map_rows("picture to line map, by the Hough transform, floor plan", {.hough = line_map_hough}, size,
                 rounds);
  print_map_rows("picture to line map without refinement, floor plan", {.refine = false}, size, rounds);
}

}  // namespace compare
