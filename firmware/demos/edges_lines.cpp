// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT

// From a camera's rows to line segments: Canny row by row, then the progressive Hough transform. The
// picture's size is WIDTH x HEIGHT. Exit code 0: the segments lie on the walls of the plan, and the walls are
// found.
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "kit/semihosting.hpp"
#include "scenes/plan.hpp"
#include "straightedge/canny_rows.hpp"
#include "straightedge/hough_lines.hpp"

namespace {

using straightedge::CannyOptions;
using straightedge::CannyRows;
using straightedge::HoughLines;
using straightedge::HoughOptions;
using straightedge::HoughSegment;
using straightedge::ImageView;
using straightedge::Size;
using straightedge::Status;

constexpr Size size{WIDTH, HEIGHT};
constexpr std::size_t pixels = std::size_t{WIDTH} * HEIGHT;
constexpr CannyOptions canny_options{};
constexpr HoughOptions hough_options{.theta_step = straightedge::pi / 90,
                                     .threshold = 15,
                                     .min_length = WIDTH / 20.0,
                                     .max_gap = 4,
                                     .max_edge_pixels = WIDTH * HEIGHT / 10};

// Sizes are constant expressions: memory that a board does not have is a link error.
alignas(64) std::array<std::byte, CannyRows::workspace_bytes(size, canny_options)> canny_memory;
alignas(64) std::array<std::byte, HoughLines::workspace_bytes(size, hough_options)> hough_memory;
std::array<std::uint8_t, pixels> picture;  // gray, then edges in its place
std::array<HoughSegment, 100> segments;

Status find_edges(ImageView<std::uint8_t> image) noexcept {
  CannyRows canny;
  Status status = CannyRows::prepare(canny, size, canny_options, canny_memory);
  if (status == Status::ok) status = canny.begin();
  for (std::int32_t y = 0; y < image.height && status == Status::ok; ++y) {
    status = canny.push_row({image.row(y), std::size_t{WIDTH}});
  }
  if (status == Status::ok) status = canny.finish().status;
  for (std::int32_t y = 0; y < image.height && status == Status::ok; ++y) {
    status = canny.read_row(y, {image.row(y), std::size_t{WIDTH}});
  }
  return status;
}

void say(const char* words, std::uint32_t number) noexcept {
  firmware::write(words);
  firmware::write(number);
}

}  // namespace

int main() {
  const ImageView<std::uint8_t> image(picture.data(), size);
  firmware::draw_plan(image);
  if (find_edges(image) != Status::ok) return 1;

  HoughLines hough;
  if (HoughLines::prepare(hough, size, hough_options, hough_memory) != Status::ok) return 2;
  const auto result = hough.run(image, {}, segments);
  if (result.status != Status::ok) return 3;

  const auto score = firmware::score_plan(size, std::span(segments).first(result.segments));
  say("edge pixels ", result.edge_pixels);
  say(", segments ", result.segments);
  say(", % of the walls' faces found ", score.recall_percent);
  say(", % of the segments on a face ", score.precision_percent);
  say("; workspaces ", static_cast<std::uint32_t>(canny_memory.size()));
  say(" and ", static_cast<std::uint32_t>(hough_memory.size()));
  say(" bytes, stack ", firmware::stack_used());
  firmware::write(" bytes\n");
  return score.recall_percent >= 90 && score.precision_percent >= 95 ? 0 : 4;
}
