// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "map/edge_points.hpp"

#include <algorithm>
#include <cstring>

namespace straightedge {
namespace {

constexpr std::int32_t rows_ahead = 8;

std::int32_t size_of(std::int32_t value) {
  return value < 0 ? -value : value;
}

/// Elements from one row to the next.
template <class T>
std::ptrdiff_t step_down(const ImageView<T>& image) {
  return image.stride / static_cast<std::ptrdiff_t>(sizeof(T));
}

constexpr std::int32_t middle = EdgeBatch::around / 2;

/// The magnitudes at the batch's pixel `at` and to both sides of it.
void read_magnitudes(const ImageView<const std::int32_t>& magnitude, std::int32_t x, std::int32_t y,
                     bool across_columns, EdgeBatch& batch, std::int32_t at) {
  const std::int32_t* const here = magnitude.row(y) + x;
  const std::ptrdiff_t step = across_columns ? 1 : step_down(magnitude);
  for (std::int32_t k = 0; k < EdgeBatch::around; ++k) batch.magnitude[k][at] = here[(k - middle) * step];
}

void read_gradients(const GradientField& field, std::int32_t x, std::int32_t y, bool across_columns,
                    EdgeBatch& batch, std::int32_t at) {
  const std::int16_t* const dx = field.x.row(y) + x;
  const std::int16_t* const dy = field.y.row(y) + x;
  const std::ptrdiff_t step_dx = across_columns ? 1 : step_down(field.x);
  const std::ptrdiff_t step_dy = across_columns ? 1 : step_down(field.y);
  for (std::int32_t k = 0; k < EdgeBatch::around; ++k) {
    batch.near_dx[k][at] = dx[(k - middle) * step_dx];
    batch.near_dy[k][at] = dy[(k - middle) * step_dy];
  }
}

/// One more pixel of the batch.
void read_pixel(const GradientField& field, std::int32_t x, std::int32_t y, EdgeBatch& batch) {
  const std::int32_t at = batch.count++;
  batch.x[at] = x;
  batch.y[at] = y;
  batch.dx[at] = field.x.at(x, y);
  batch.dy[at] = field.y.at(x, y);
  const bool across_columns = size_of(batch.dx[at]) >= size_of(batch.dy[at]);
  const std::int32_t place = across_columns ? x : y;
  const std::int32_t places = across_columns ? field.x.width : field.x.height;
  if (place < middle || place + middle >= places) {
    for (std::int32_t k = 0; k < EdgeBatch::around; ++k)
      batch.magnitude[k][at] = batch.near_dx[k][at] = batch.near_dy[k][at] = 0;
  } else if (field.magnitude.data != nullptr) {
    read_magnitudes(field.magnitude, x, y, across_columns, batch, at);
  } else {
    read_gradients(field, x, y, across_columns, batch, at);
  }
}

}  // namespace

void EdgePoints::Bits::reset(std::int32_t lines, std::int32_t length) {
  words_in_line_ = static_cast<std::size_t>(length) / 64 + 2;
  words_.assign(static_cast<std::size_t>(lines) * words_in_line_, 0);
}

void EdgePoints::reset(GrayView edges) {
  const auto width = static_cast<std::size_t>(edges.width), height = static_cast<std::size_t>(edges.height);
  if (mask_.size() != edges.size()) mask_ = Image<std::uint8_t>::for_overwrite(edges.size());
  for (std::int32_t y = 0; y < edges.height; ++y) std::memcpy(mask_.view().row(y), edges.row(y), width);
  rows_.reset(edges.height, edges.width);
  columns_.reset(edges.width, edges.height);
  groups_in_row_ = width / 8 + 1;
  all_.assign(groups_in_row_ * height, 0);
  first_of_group_.resize(groups_in_row_ * height);
  first_of_row_.resize(height);
  count_ = 0;
  batch_->count = 0;
}

/// Notes where the edge pixels of a row are.
void EdgePoints::add_row(std::int32_t y, const std::uint16_t* columns, std::int32_t count) {
  const std::size_t first_group = static_cast<std::size_t>(y) * groups_in_row_;
  for (std::int32_t i = 0; i < count; ++i) {
    const std::int32_t x = columns[i];
    rows_.set(y, x);
    columns_.set(x, y);
    std::uint8_t& group = all_[first_group + static_cast<std::size_t>(x) / 8];
    group = static_cast<std::uint8_t>(group | 1 << x % 8);
  }
  std::uint16_t before = 0;
  for (std::size_t g = first_group; g < first_group + groups_in_row_; ++g) {
    first_of_group_[g] = before;
    before = static_cast<std::uint16_t>(before + ones_in[all_[g]]);
  }
}

/// The points of the batch.
void EdgePoints::flush() {
  EdgeBatch& batch = *batch_;
  if (own_magnitude_) kernels_->edge_magnitudes(batch, norm_ == GradientNorm::l2);
  kernels_->edge_places(batch);
  const auto more = static_cast<std::size_t>(batch.count);
  if (points_.size() < count_ + more) points_.resize(std::max(2 * points_.size(), count_ + more));
  EdgePoint* const points = points_.data() + count_;
  for (std::int32_t i = 0; i < batch.count; ++i)
    points[i] = {batch.place_x[i], batch.place_y[i], batch.weight[i], batch.dx[i], batch.dy[i]};
  count_ += more;
  batch.count = 0;
}

void EdgePoints::find(GrayView edges, const GradientField& field, GradientNorm norm,
                      const KernelSet& kernels) {
  constexpr std::size_t beyond = 8;  // that the kernel may write behind the row's last column
  kernels_ = kernels.picture_rows;
  reset(edges);
  own_magnitude_ = field.magnitude.data == nullptr;
  norm_ = norm;
  std::vector<std::uint16_t> columns(static_cast<std::size_t>(edges.width) + beyond);
  for (std::int32_t y = 0; y < edges.height; ++y) {
    const std::int32_t count = kernels.hough->edge_columns(edges.row(y), edges.width, columns.data());
    first_of_row_[static_cast<std::size_t>(y)] =
        static_cast<std::uint32_t>(count_) + static_cast<std::uint32_t>(batch_->count);
    add_row(y, columns.data(), count);
    // Most edges go on in the rows below.
    const std::int32_t soon = std::min(y + rows_ahead, edges.height - 1);
    for (std::int32_t i = 0; i < count; ++i) {
      const std::int32_t x = columns[static_cast<std::size_t>(i)];
      __builtin_prefetch(field.x.row(soon) + x);
      __builtin_prefetch(field.y.row(soon) + x);
      read_pixel(field, x, y, *batch_);
      if (batch_->count == EdgeBatch::room) flush();
    }
  }
  flush();
}

}  // namespace straightedge
