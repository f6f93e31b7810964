// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "straightedge/frame_planes.hpp"

#include <algorithm>
#include <utility>

#include "cell_labels.hpp"
#include "cell_tables.hpp"
#include "free_cells.hpp"
#include "pixel_labels.hpp"
#include "plane_shape.hpp"
#include "plane_surfaces.hpp"
#include "rename_labels.hpp"
#include "straightedge/square_root.hpp"

namespace straightedge {
namespace {

/// Indices of the planes, the one with most pixels first, then in their order.
void sort_by_pixels(std::span<const InverseDepthMoments> moments, std::span<std::uint16_t> order) noexcept {
  for (std::size_t i = 0; i < order.size(); ++i) {
    std::size_t place = i;
    while (place > 0 && moments[order[place - 1]].n < moments[i].n) {
      order[place] = order[place - 1];
      --place;
    }
    order[place] = static_cast<std::uint16_t>(i);
  }
}

}  // namespace

Status FramePlanes::prepare(Size size, const FramePlanesOptions& options,
                            std::span<std::byte> workspace) noexcept {
  prepared_ = false;
  if (!detail::valid(options)) return Status::invalid_option;
  if (const Status status = check(size); status != Status::ok) return status;
  Arena arena(workspace);
  take(arena, size, options);
  if (arena.failed()) return Status::workspace_too_small;
  options_ = options;
  options_.gate = widened(options);
  min_pixels_ = least_pixels(size, options);
  prepared_ = true;
  return Status::ok;
}

void FramePlanes::assign_cells() noexcept {
  // Step 3.
  detail::CellLabeller{cells_, surfaces_.first(count_), options_.gate, *options_.kernels, float_surfaces_,
                       rough_}
      .label(cell_labels_);
}

void FramePlanes::refit(const PinholeCamera& camera) noexcept {
  // Step 4.
  const detail::PlaneSurfaces fitting(size_, camera, options_);
  fitting.add_fresh(cells_, small_cell_labels(), sums_.first(count_));
  for (std::uint16_t k = 0; k < count_; ++k) {
    const bool stays = sums_[k].n >= min_pixels_ / 2.0 && fitting.fit(sums_[k], surfaces_[k], squares_[k]);
    becomes_[k] = stays ? k : detail::gone;
  }
  join(fitting);
  keep();
}

void FramePlanes::join(const detail::PlaneSurfaces& fitting) noexcept {
  detail::Contacts contacts{cells_.size(cells_.finest()), small_cell_labels(), contacts_};
  detail::QuadraticFit fit;
  for (std::uint16_t i = 0; i < count_; ++i) {
    if (becomes_[i] != i) continue;
    if (i + 1U == count_ || !fitting.solve(sums_[i], fit)) continue;
    for (std::uint32_t j = i + 1U; j < count_; ++j) {
      if (becomes_[j] != j || fitting.are_far(sums_[i], fit, sums_[j])) continue;
      contacts.i = i;
      contacts.j = j;
      if (!fitting.are_one(sums_[i], sums_[j], squares_[i] + squares_[j], contacts, surfaces_[i],
                           squares_[i])) {
        continue;
      }
      sums_[i].add(sums_[j]);
      for (std::size_t k = 0; k < count_; ++k) {
        if (k != i && k != j) detail::of_pair(contacts_, i, k) += detail::of_pair(contacts_, j, k);
      }
      candidates_[i].score += candidates_[j].score;
      candidates_[i].confidence = std::max(candidates_[i].confidence, candidates_[j].confidence);
      becomes_[j] = i;
      (void)fitting.solve(sums_[i], fit);
      j = i;  // the joined plane has moved: those that were refused may fit now
    }
  }
}

void FramePlanes::keep() noexcept {
  const std::span<std::uint16_t> label = new_label_;
  label[0] = 0;
  const std::uint32_t before = count_;
  std::uint32_t kept = 0;
  for (std::uint32_t k = 0; k < count_; ++k) {
    if (becomes_[k] == k) {
      candidates_[kept] = candidates_[k];
      surfaces_[kept] = surfaces_[k];
      squares_[kept] = squares_[k];
      sums_[kept] = sums_[k];
      label[k + 1] = static_cast<std::uint16_t>(++kept);
    } else if (becomes_[k] < count_) {
      label[k + 1] = label[becomes_[k] + 1U];  // joined into an earlier plane
    } else {
      label[k + 1] = 0;
    }
  }
  count_ = kept;
  const auto used = label.first(before + 1U);
  rename_cells(used);
}

void FramePlanes::rename_cells(std::span<const std::uint16_t> by) noexcept {
  if (detail::changes_nothing(by)) return;
  for (int level = cells_.finest(); level < DepthCells::levels; ++level) {
    detail::rename(cell_labels_[static_cast<std::size_t>(level)], by, *options_.kernels);
  }
}

void FramePlanes::sort_by_cells() noexcept {
  // So that the order of the pixels, which is not known before the last step, hardly ever differs.
  const std::span<std::uint16_t> before = becomes_.first(count_);
  for (std::uint16_t i = 0; i < count_; ++i) {
    before[i] = i;
    for (std::size_t k = i; k > 0 && sums_[k - 1].n < sums_[k].n; --k) {
      std::swap(sums_[k - 1], sums_[k]);
      std::swap(surfaces_[k - 1], surfaces_[k]);
      std::swap(candidates_[k - 1], candidates_[k]);
      std::swap(before[k - 1], before[k]);
    }
  }
  new_label_[0] = 0;
  for (std::uint16_t i = 0; i < count_; ++i) new_label_[before[i] + 1U] = static_cast<std::uint16_t>(i + 1);
  rename_cells(new_label_.first(count_ + 1U));
}

Status FramePlanes::read_depth(const DepthView& depth) noexcept {
  // Step 1. In bands of rows that the cells find in the processor's nearest memory.
  const std::int32_t rows = options_.cell;
  for (std::int32_t y = 0; y < size_.height; y += rows) {
    const Size band{size_.width, std::min(rows, size_.height - y)};
    DepthView part = depth;
    part.raw.data = depth.raw.row(y);
    part.raw.height = band.height;
    ImageView<float> out = inverse_depth_;
    out.data = inverse_depth_.row(y);
    out.height = band.height;
    const Status status = inverse_depth_image(part, out, *options_.kernels);
    if (status != Status::ok) return status;
    cells_.build_row(out, y / rows, *options_.kernels);
  }
  return Status::ok;
}

Status FramePlanes::search_round(const DepthView& depth, const PlaneSearch& search,
                                 ImageView<const std::uint16_t> labels, PlanesFound& found) noexcept {
  // Step 2.
  const std::span<ProposedPlane> room = candidates_.subspan(count_);
  std::uint32_t proposed = 0;
  const Status status = search.run(search.user, inverse_depth_, cells_, labels, depth.camera, room, proposed);
  if (status != Status::ok && status != Status::output_full) return status;
  const auto added = std::min(proposed, static_cast<std::uint32_t>(room.size()));
  for (std::uint32_t k = 0; k < added; ++k) {
    found.iterations = std::max(found.iterations, room[k].iterations);
    surfaces_[count_ + k] = {.plane = room[k].fit.plane};
    sums_[count_ + k] = {};
  }
  count_ += added;
  assign_cells();
  refit(depth.camera);
  judge(depth.camera);
  return Status::ok;
}

Status FramePlanes::run(const DepthView& depth, const PlaneSearch& search, ImageView<std::uint16_t> labels,
                        std::span<FoundPlane> planes, PlanesFound& found) noexcept {
  if (!prepared_) return Status::not_prepared;
  if (!depth.valid() || !labels.valid() || search.run == nullptr) return Status::invalid_image;
  if (depth.raw.size() != size_ || labels.size() != size_) return Status::size_mismatch;
  found = {};
  count_ = 0;
  for (const std::span<std::uint16_t> level : cell_labels_)
    std::fill(level.begin(), level.end(), std::uint16_t{0});
  std::fill(rough_.begin(), rough_.end(), std::uint16_t{0});
  if (const Status read = read_depth(depth); read != Status::ok) return read;
  double readings = 0;
  const int coarsest = DepthCells::levels - 1;
  const float* of_cells = cells_.rows(coarsest, 0).first;
  for (std::size_t i = 0; i < DepthCells::cell_count(cells_.size(coarsest)); ++i) {
    readings += static_cast<double>(of_cells[i]);
  }
  found.readings = static_cast<std::uint32_t>(readings);
  // Steps 2 to 6.
  const std::uint32_t rounds = options_.rounds > 0 ? options_.rounds : search.rounds;
  Status status = search_round(depth, search, {}, found);
  for (std::uint32_t round = 1; status == Status::ok && round < rounds; ++round) {
    // The labels' memory is free until the last step.
    const std::uint32_t middles =
        detail::free_cells(cells_, small_cell_labels(), detail::marks_in(labels, cells_));
    const std::int32_t side = options_.cell;
    if (middles * static_cast<std::uint32_t>(side * side) < min_pixels_) break;
    detail::spread_marks(side, labels);
    status = search_round(depth, search, labels, found);
  }
  return status != Status::ok ? status : finish(depth, labels, planes, found);
}

Status FramePlanes::finish(const DepthView& depth, ImageView<std::uint16_t> labels,
                           std::span<FoundPlane> planes, PlanesFound& found) noexcept {
  // Step 7.
  drop_crumbs();
  sort_by_cells();
  const std::span<std::uint16_t> labels_of_cells = small_cell_labels();
  detail::PixelLabeller{inverse_depth_,          cells_,        labels_of_cells,
                        surfaces_.first(count_), options_.gate, *options_.kernels,
                        float_surfaces_}
      .label(labels, moments_.first(count_), visited_);
  // Step 8.
  const std::span<std::uint16_t> order = becomes_;
  sort_by_pixels(moments_.first(count_), order.first(count_));
  // A label that no pixel has stays.
  new_label_[0] = 0;
  for (std::uint32_t k = 0; k < count_; ++k) {
    new_label_[k + 1] = static_cast<std::uint16_t>(moments_[k].n > 0 ? 0U : k + 1);
  }
  Status status = Status::ok;
  PlaneGate noise = options_.gate;
  noise.inverse_sigma /= options_.slack;  // as the caller gave it
  for (std::uint32_t i = 0; i < count_; ++i) {
    const InverseDepthMoments& m = moments_[order[i]];
    const ProposedPlane& candidate = candidates_[order[i]];
    InverseDepthFit fit;
    FoundPlane plane;
    const double sigma = m.n > 0 ? noise.inverse_noise(m.q / m.n) * square_root(options_.noise_pixels) : 0;
    if (m.n < min_pixels_ || fit_inverse_depth(m, sigma, fit) != Status::ok ||
        to_plane_fit(fit, sigma, depth.camera, plane.fit) != Status::ok) {
      continue;
    }
    if (found.planes == planes.size()) {
      status = Status::output_full;
      break;
    }
    plane.inliers = static_cast<std::uint32_t>(m.n);
    plane.iterations = candidate.iterations;
    plane.confidence = candidate.confidence;
    plane.score = candidate.score;
    planes[found.planes++] = plane;
    new_label_[order[i] + 1U] = static_cast<std::uint16_t>(found.planes);
    found.labelled += plane.inliers;
  }
  detail::rename(labels, {cells_.size(cells_.finest()), options_.cell, labels_of_cells},
                 new_label_.first(count_ + 1U), *options_.kernels);
  return status;
}

}  // namespace straightedge
