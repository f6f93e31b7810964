// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <algorithm>

#include "map/edge_points.hpp"
#include "map/strip_moments.hpp"

namespace straightedge {
namespace {

constexpr std::int32_t most_steps = 16;

struct Place {
  std::int32_t x, y;
};

/// Some steps along a corridor: their pixels, those of step j from first[j] to first[j + 1].
struct Steps {
  std::int32_t count = 0;
  bool ended = false;  ///< the next one is outside the picture
  std::int32_t first[most_steps + 1] = {};
  Place places[StripBatch::room];
};

/// Adds the pixels of a step to the sums.
class Sums {
 public:
  explicit Sums(refitting::Collected& found) : found_(found), sums_(found.halves[0]) {}
  void finish() { found_.halves[half_] = sums_; }

  void add(const StripBatch& batch, std::int32_t i, Place place) {
    const double s = batch.along[i];
    if (found_.pixels == 0) found_.begin = found_.end = s;
    found_.begin = s < found_.begin ? s : found_.begin;
    found_.end = s > found_.end ? s : found_.end;
    ++found_.pixels;
    found_.places += refitting::number_of(place.x, place.y);
    turn_to(s < 0 ? 0 : 1);
    straightedge::add(batch, i, sums_);
  }

 private:
  void turn_to(int half) {
    if (half == half_) return;
    found_.halves[half_] = sums_;
    sums_ = found_.halves[half];
    half_ = half;
  }

  refitting::Collected& found_;
  LineMoments sums_;
  int half_ = 0;
};

}  // namespace

/// collect_each of refit_recipe.hpp, some steps together; read that first. What lies behind the end of the
/// walk is looked at in vain.
void EdgePoints::collect(const refitting::Corridor& strip, const RefitOptions& options, std::int32_t start,
                         std::int32_t direction, refitting::Collected& result) const noexcept {
  const refitting::Corridor wide = refitting::widened(strip);
  const refitting::CorridorSteps corridor(*this, wide);
  const double step_length = strip.step_length();
  const StripRule rule{strip.px, strip.py, strip.nx, strip.ny, strip.half_width, strip.cos_max_angle};
  const std::int32_t together = std::min(most_steps, StripBatch::room / corridor.most_in_step());
  refitting::Collected found = result;
  Sums sums(found);
  Steps steps;
  StripBatch batch;
  double hole = 0;
  std::int32_t k = start;
  while (hole <= options.max_gap && !steps.ended) {
    std::int32_t pixels = 0;
    for (steps.count = 0; steps.count < together; ++steps.count, k += direction) {
      steps.first[steps.count] = pixels;
      const bool inside = corridor.visit(k, [&](std::int32_t x, std::int32_t y) noexcept {
        steps.places[pixels++] = {x, y};
      });
      steps.ended = !inside;
      if (!inside) break;
    }
    steps.first[steps.count] = pixels;
    batch.count = pixels;
    for (std::int32_t i = 0; i < pixels; ++i) {
      const EdgePoint& edge = point(steps.places[i].x, steps.places[i].y);
      batch.x[i] = edge.x;
      batch.y[i] = edge.y;
      batch.weight[i] = edge.weight;
      batch.dx[i] = edge.dx;
      batch.dy[i] = edge.dy;
    }
    kernels_->find_inside(rule, batch);
    for (std::int32_t j = 0; j < steps.count && hole <= options.max_gap; ++j) {
      hole += step_length;
      for (std::int32_t i = steps.first[j]; i < steps.first[j + 1]; ++i) {
        if (batch.inside[i] == 0) continue;
        sums.add(batch, i, steps.places[i]);
        hole = 0;
      }
    }
  }
  sums.finish();
  result = found;
}

}  // namespace straightedge
