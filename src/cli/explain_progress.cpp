// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "cli/explain_progress.hpp"

#include <algorithm>
#include <cstddef>
#include <set>
#include <utility>

#include "cli/explain_colours.hpp"

namespace straightedge::cli {
namespace {

constexpr std::int32_t dot_room = 1000;  // pixels of the longer side for each pixel of a dot's radius

/// Follows the trace of a run and takes pictures.
class Watcher {
 public:
  Watcher(const ExplainRun& run, const HoughOptions& options, int zoom)
      : zoom_(zoom), pairs_(options.method == HoughMethod::randomized), pixels_(run.edges.size()) {
    for (std::int32_t y = 0; y < pixels_.height(); ++y) {
      for (std::int32_t x = 0; x < pixels_.width(); ++x) {
        if (run.edges.at(x, y) != 0) pixels_.at(x, y) = waiting_colour;
      }
    }
    now_.left = run.hough.edge_pixels;
    const std::uint32_t all = pairs_ ? run.hough.peaks : run.hough.segments;
    moments_ = {1, all / 16, all / 4};
    moments_.erase(0);
  }

  void take(const HoughEvent& event) {
    if (event.step == HoughStep::line) ++now_.lines;
    if (event.step == HoughStep::removal) {
      pixels_.at(event.x0, event.y0) = taken_colour;
      --now_.left;
    }
    if (event.step != HoughStep::vote) return;
    // A line takes its pixels before or after it is told, so its picture is due with the next vote.
    if (moments_.erase(now_.lines) > 0) paint();
    ++now_.votes;
    pixels_.at(event.x0, event.y0) = strong_colour;
    if (pairs_) pixels_.at(event.x1, event.y1) = strong_colour;
  }

  /// The last picture shows the end of the run.
  std::vector<ProgressPicture> finish() {
    if (now_.lines == 0) return {};
    paint();
    return std::move(pictures_);
  }

 private:
  void paint() {
    ProgressPicture shown = now_;
    shown.picture = zoom_ > 1 ? enlarged(pixels_, zoom_) : with_dots();
    pictures_.push_back(std::move(shown));
  }

  /// Two of these pictures share the page's width: in a large one a pixel must be a dot to be seen.
  Image<Rgb> with_dots() const {
    const Size size = pixels_.size();
    const std::int32_t reach = std::max(size.width, size.height) / dot_room;
    if (reach == 0) return pixels_;
    Image<Rgb> picture(size);
    for (std::int32_t y = 0; y < size.height; ++y) {
      for (std::int32_t x = 0; x < size.width; ++x) {
        if (pixels_.at(x, y) != Rgb{}) put_dot(picture.view(), x, y, reach);
      }
    }
    return picture;
  }

  void put_dot(ImageView<Rgb> picture, std::int32_t x, std::int32_t y, std::int32_t reach) const {
    for (std::int32_t v = std::max(0, y - reach); v <= std::min(picture.height - 1, y + reach); ++v) {
      for (std::int32_t u = std::max(0, x - reach); u <= std::min(picture.width - 1, x + reach); ++u)
        picture.at(u, v) = pixels_.at(x, y);
    }
  }

  int zoom_;
  bool pairs_;
  Image<Rgb> pixels_;
  ProgressPicture now_;
  std::set<std::uint32_t> moments_;  ///< numbers of lines after which a picture is taken
  std::vector<ProgressPicture> pictures_;
};

bool follow(void* watcher, const HoughEvent& event) {
  static_cast<Watcher*>(watcher)->take(event);
  return true;
}

}  // namespace

std::vector<ProgressPicture> show_progress(const ExplainRun& run, const HoughOptions& options,
                                           const PictureScale& scale) {
  if (options.method == HoughMethod::standard) return {};
  const Size size = run.edges.size();
  std::vector<std::byte> memory(HoughLines::workspace_bytes(size, options));
  HoughLines hough;
  if (HoughLines::prepare(hough, size, options, memory) != Status::ok) return {};
  Watcher watcher(run, options, scale.zoom);
  std::vector<HoughPeak> peaks(run.hough.peaks);
  std::vector<HoughSegment> segments(run.segments.size());
  const HoughResult again = hough.run(run.edges, {run.canny.gradient_x(), run.canny.gradient_y()}, peaks,
                                      segments, {.event = follow, .user = &watcher});
  if (again.status != Status::ok) return {};
  return watcher.finish();
}

}  // namespace straightedge::cli
