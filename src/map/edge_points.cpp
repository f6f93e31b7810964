// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "map/edge_points.hpp"

#include <algorithm>
#include <cstring>

#include "map/edge_reading.hpp"

namespace straightedge {
void EdgePoints::reset(GrayView edges) {
  const auto width = static_cast<std::size_t>(edges.width), height = static_cast<std::size_t>(edges.height);
  if (mask_.size() != edges.size()) mask_ = Image<std::uint8_t>::for_overwrite(edges.size());
  for (std::int32_t y = 0; y < edges.height; ++y) std::memcpy(mask_.view().row(y), edges.row(y), width);
  bits_.reset(edges.size());
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
    bits_.set(x, y);
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

void EdgePoints::find(GrayView edges, const EdgeSources& sources, GradientNorm norm,
                      const KernelSet& kernels) {
  constexpr std::size_t beyond = 8;  // that the kernel may write behind the row's last column
  kernels_ = kernels.picture_rows;
  reset(edges);
  own_magnitude_ = !sources.have_magnitude();
  norm_ = norm;
  std::vector<std::uint16_t> columns(static_cast<std::size_t>(edges.width) + beyond);
  for (std::int32_t y = 0; y < edges.height; ++y) {
    const std::int32_t count = kernels.hough->edge_columns(edges.row(y), edges.width, columns.data());
    first_of_row_[static_cast<std::size_t>(y)] =
        static_cast<std::uint32_t>(count_) + static_cast<std::uint32_t>(batch_->count);
    add_row(y, columns.data(), count);
    const std::int32_t soon = std::min(y + gradient_rows_ahead, edges.height - 1);
    for (std::int32_t i = 0; i < count; ++i) {
      const std::int32_t x = columns[static_cast<std::size_t>(i)];
      __builtin_prefetch(sources.directions.stored.x.row(soon) + x);
      __builtin_prefetch(sources.directions.stored.y.row(soon) + x);
      read_edge(sources, x, y, *batch_);
      if (batch_->count == EdgeBatch::room) flush();
    }
  }
  flush();
}

}  // namespace straightedge
