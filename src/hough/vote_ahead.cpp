// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "hough/vote_ahead.hpp"

#include "hough/drawing.hpp"
#include "hough/follow_line.hpp"
#include "straightedge/hough_kernels.hpp"

namespace straightedge::hough {
namespace {

constexpr auto room = static_cast<std::int32_t>(hough_batch_room);

HoughRows rows_of(const HoughMemory& memory) noexcept {
  return {memory.cosines.data(), memory.sines.data(), memory.offsets.data(),
          static_cast<std::int32_t>(memory.cosines.size()), 0};
}

void add(HoughBatch& batch, PixelPlace pixel) noexcept {
  batch.x[batch.count] = static_cast<float>(pixel.x);
  batch.y[batch.count] = static_cast<float>(pixel.y);
  ++batch.count;
}

template <class Cell>
class VotingAhead {
 public:
  VotingAhead(HoughJob& job, Cell* cells, const HoughCellKernels<Cell>& kernels) noexcept
      : job_(job),
        ahead_(job.memory.ahead.front()),
        cells_(cells),
        kernels_(kernels),
        rows_(rows_of(job.memory)),
        drawing_(job) {
    ahead_.voting = {};
    ahead_.leaving = {};
  }

  bool run() noexcept {
    while (drawing_.left() > 0) {
      draw();
      take_off();                                                                        // e
      kernels_.cast(cells_, rows_, ahead_.voting, job_.options.threshold, ahead_.seen);  // a
      for (std::int32_t i = 0; i < ahead_.voting.count; ++i) {
        job_.result.draws = ahead_.draws[i];
        if (turn(i)) continue;
        for (std::int32_t later = i + 1; later < ahead_.voting.count; ++later) leave(ahead_.places[later]);
        take_off();
        return false;
      }
    }
    take_off();
    job_.result.draws = job_.result.edge_pixels;
    return true;
  }

 private:
  /// Step 2.
  void draw() noexcept {
    const PixelStates all = states(job_);
    HoughBatch& batch = ahead_.voting;
    batch.count = 0;
    while (drawing_.left() > 0 && batch.count < room) {
      const PixelPlace pixel = drawing_.next();
      if (all.at(pixel.x, pixel.y) == PixelState::gone) continue;
      ahead_.places[batch.count] = pixel;
      ahead_.draws[batch.count] = job_.result.edge_pixels - drawing_.left();
      add(batch, pixel);
    }
  }

  /// Steps 3 to 6 for one of the batch. False: output full.
  bool turn(std::int32_t i) noexcept {
    const PixelStates all = states(job_);
    const PixelPlace pixel = ahead_.places[i];
    if (all.at(pixel.x, pixel.y) == PixelState::gone) {  // d
      leave(pixel);
      return true;
    }
    all.set(pixel.x, pixel.y, PixelState::voted);
    const std::int32_t threshold = job_.options.threshold;
    const HoughCandidate seen{ahead_.seen.votes[i], ahead_.seen.angles[i]};
    if (seen.votes < threshold) return true;  // b
    const HoughCandidate candidate =
        kernels_.find(cells_, rows_, {&ahead_.voting, i, &ahead_.leaving}, seen, threshold);  // c
    if (candidate.angle < 0) return true;
    return follow_line(job_, pixel, candidate, [this](PixelPlace taken) { leave(taken); });
  }

  void leave(PixelPlace pixel) noexcept {
    ahead_.left_behind[ahead_.leaving.count] = pixel;
    add(ahead_.leaving, pixel);
    if (ahead_.leaving.count == room) take_off();
  }

  void take_off() noexcept {
    // Neighbours on a line share cells at many angles, and who decrements a cell waits for the one before:
    // so neighbours are kept apart.
    constexpr std::int32_t apart = 8;
    HoughBatch& leaving = ahead_.leaving;
    const std::int32_t count = leaving.count;
    leaving.count = 0;
    for (std::int32_t first = 0; first < apart; ++first)
      for (std::int32_t i = first; i < count; i += apart) add(leaving, ahead_.left_behind[i]);
    if (count > 0) kernels_.take_off(cells_, rows_, leaving);
    leaving.count = 0;
  }

  HoughJob& job_;
  HoughAhead& ahead_;
  Cell* cells_;
  const HoughCellKernels<Cell>& kernels_;
  HoughRows rows_;
  Drawing drawing_;
};

template <class Cell>
bool run(HoughJob& job, std::span<Cell> cells, const HoughCellKernels<Cell>& kernels) noexcept {
  return VotingAhead<Cell>(job, cells.data(), kernels).run();
}

}  // namespace

bool may_vote_ahead(const HoughJob& job) noexcept {
  if (job.options.kernels == nullptr || job.trace.event != nullptr || job.windowed()) return false;
  if (job.grid.angles > UINT16_MAX) return false;
  // Following OpenCV, a cell's bound is the number of pixels that can vote for it; else it is the threshold.
  if (job.options.generator == HoughGenerator::opencv) return !job.memory.cells16.empty();
  const std::int32_t most = !job.memory.cells8.empty() ? UINT8_MAX : INT16_MAX;
  return job.memory.cells.empty() && job.options.threshold <= most - room;
}

bool vote_ahead(HoughJob& job) noexcept {
  const HoughKernels& kernels = *job.options.kernels;
  return job.memory.cells8.empty() ? run(job, job.memory.cells16, kernels.words)
                                   : run(job, job.memory.cells8, kernels.bytes);
}

}  // namespace straightedge::hough
