// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "hough/pixel_buckets.hpp"

namespace straightedge::hough {
namespace {

/// Calls `take(x, y)` for each edge pixel.
template <class Take>
void for_each_pixel(GrayView edges, Take take) noexcept {
  for (std::int32_t y = 0; y < edges.height; ++y) {
    const std::uint8_t* row = edges.row(y);
    for (std::int32_t x = 0; x < edges.width; ++x)
      if (row[x] != 0) take(static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y));
  }
}

}  // namespace

PixelBuckets::PixelBuckets(HoughJob& job) noexcept
    : side_(static_cast<std::uint32_t>(hough_bucket_side(job.edges.size(), job.options))),
      columns_((static_cast<std::uint32_t>(job.edges.width) + side_ - 1) / side_),
      rows_((static_cast<std::uint32_t>(job.edges.height) + side_ - 1) / side_),
      points_(job.memory.points),
      starts_(job.memory.buckets) {
  // A counting sort: sizes, then ends, then each pixel before the end of its square, which so
  // becomes the square's start. From the last pixel to the first would keep the order; it is not needed.
  for (std::uint32_t& start : starts_) start = 0;
  for (std::uint8_t& pixel : job.memory.mask) pixel = 0;
  const auto width = static_cast<std::size_t>(job.edges.width);
  for_each_pixel(job.edges, [&](std::uint32_t x, std::uint32_t y) {
    job.memory.mask[y * width + x] = 1;
    ++starts_[bucket_of(x, y)];
  });
  for (std::size_t i = 1; i < starts_.size(); ++i) starts_[i] += starts_[i - 1];
  if (size() > points_.size()) return;
  for_each_pixel(job.edges, [&](std::uint32_t x, std::uint32_t y) {
    points_[--starts_[bucket_of(x, y)]] = {static_cast<std::uint16_t>(x), static_cast<std::uint16_t>(y)};
  });
  find_most_nearby();
}

void PixelBuckets::compact(HoughJob& job) noexcept {
  const auto width = static_cast<std::size_t>(job.edges.width);
  std::uint32_t kept = 0;
  std::uint32_t read = 0;
  for (std::uint32_t bucket = 0; bucket < columns_ * rows_; ++bucket) {
    const std::uint32_t end = starts_[bucket + 1];
    starts_[bucket] = kept;
    for (; read < end; ++read)
      if (job.memory.mask[points_[read].y * width + points_[read].x] != 0) points_[kept++] = points_[read];
  }
  starts_[columns_ * rows_] = kept;
  find_most_nearby();
}

PixelBuckets::Run PixelBuckets::run(std::uint32_t column, std::uint32_t row) const noexcept {
  const std::uint32_t first = row * columns_ + (column == 0 ? 0 : column - 1);
  const std::uint32_t last = row * columns_ + (column + 1 == columns_ ? column : column + 1);
  return {starts_[first], starts_[last + 1] - starts_[first]};
}

void PixelBuckets::find_most_nearby() noexcept {
  most_nearby_ = 0;
  for (std::uint32_t row = 0; row < rows_; ++row) {
    for (std::uint32_t column = 0; column < columns_; ++column) {
      std::uint32_t count = run(column, row).count;
      if (row > 0) count += run(column, row - 1).count;
      if (row + 1 < rows_) count += run(column, row + 1).count;
      if (count > most_nearby_) most_nearby_ = count;
    }
  }
}

PixelPlace PixelBuckets::draw_near(PixelPlace centre, Pcg32& random) const noexcept {
  const std::uint32_t column = centre.x / side_;
  const std::uint32_t row = centre.y / side_;
  const Run above = row > 0 ? run(column, row - 1) : Run{};
  const Run here = run(column, row);
  const Run below = row + 1 < rows_ ? run(column, row + 1) : Run{};
  std::uint32_t index = random.below(above.count + here.count + below.count);
  if (index < above.count) return points_[above.first + index];
  index -= above.count;
  if (index < here.count) return points_[here.first + index];
  return points_[below.first + (index - here.count)];
}

}  // namespace straightedge::hough
