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
          static_cast<std::int32_t>(memory.cosines.size())};
}

void add(HoughBatch& batch, PixelPlace pixel) noexcept {
  batch.x[batch.count] = static_cast<float>(pixel.x);
  batch.y[batch.count] = static_cast<float>(pixel.y);
  ++batch.count;
}

/// Pixels whose votes shall come off, in the order of a walk along a line.
template <class Cell>
class TakingOff {
 public:
  TakingOff(Cell* cells, const HoughRows& rows, const HoughCellKernels<Cell>& kernels) noexcept
      : cells_(cells), rows_(rows), kernels_(kernels) {}

  void add(PixelPlace pixel) noexcept {
    waiting_[count_++] = pixel;
    if (count_ == room) finish();
  }

  void finish() noexcept {
    // Neighbours on a line share cells at many angles, and who decrements a cell waits for the one before:
    // so neighbours are kept apart.
    constexpr std::int32_t apart = 8;
    batch_.count = 0;
    for (std::int32_t first = 0; first < apart; ++first)
      for (std::int32_t i = first; i < count_; i += apart) hough::add(batch_, waiting_[i]);
    if (count_ > 0) kernels_.take_off(cells_, rows_, batch_);
    count_ = 0;
  }

 private:
  Cell* cells_;
  const HoughRows& rows_;
  const HoughCellKernels<Cell>& kernels_;
  HoughBatch batch_;
  PixelPlace waiting_[room];
  std::int32_t count_ = 0;
};

/// Draws some pixels before they are asked for, so that their states are in the cache by then.
class DrawingAhead {
 public:
  explicit DrawingAhead(HoughJob& job) noexcept : job_(job), drawing_(job) {}

  bool any() const noexcept { return next_ < count_ || drawing_.left() > 0; }
  std::uint32_t drawn() const noexcept {
    return job_.result.edge_pixels - drawing_.left() - static_cast<std::uint32_t>(count_ - next_);
  }

  PixelPlace next() noexcept {
    if (next_ == count_) refill();
    return pixels_[next_++];
  }

 private:
  void refill() noexcept {
    const PixelStates all = states(job_);
    next_ = 0;
    for (count_ = 0; count_ < room && drawing_.left() > 0; ++count_) {
      pixels_[count_] = drawing_.next();
      all.expect(pixels_[count_].x, pixels_[count_].y);
    }
  }

  const HoughJob& job_;
  Drawing drawing_;
  PixelPlace pixels_[room];
  std::int32_t next_ = 0;
  std::int32_t count_ = 0;
};

template <class Cell>
class Ahead {
 public:
  Ahead(HoughJob& job, Cell* cells, const HoughCellKernels<Cell>& kernels) noexcept
      : job_(job),
        cells_(cells),
        kernels_(kernels),
        rows_(rows_of(job.memory)),
        drawing_(job),
        off_(cells, rows_, kernels) {}

  bool run() noexcept {
    while (drawing_.any()) {
      draw();
      kernels_.cast(cells_, rows_, batch_, most_);  // a
      for (std::int32_t i = 0; i < batch_.count; ++i) {
        job_.result.draws = draws_[i];
        if (turn(i)) continue;
        for (std::int32_t later = i + 1; later < batch_.count; ++later) take_off(later);
        return false;
      }
    }
    job_.result.draws = job_.result.edge_pixels;
    return true;
  }

 private:
  /// Step 2.
  void draw() noexcept {
    const PixelStates all = states(job_);
    batch_.count = 0;
    while (drawing_.any() && batch_.count < room) {
      const PixelPlace pixel = drawing_.next();
      if (all.at(pixel.x, pixel.y) == PixelState::gone) continue;
      places_[batch_.count] = pixel;
      draws_[batch_.count] = drawing_.drawn();
      add(batch_, pixel);
    }
  }

  /// Steps 3 to 6 for one of the batch. False: output full.
  bool turn(std::int32_t i) noexcept {
    const PixelStates all = states(job_);
    const PixelPlace pixel = places_[i];
    if (all.at(pixel.x, pixel.y) == PixelState::gone) {  // d
      take_off(i);
      return true;
    }
    all.set(pixel.x, pixel.y, PixelState::voted);
    if (most_[i] < job_.options.threshold) return true;  // b
    const HoughCandidate none{job_.options.threshold - 1, -1};
    const HoughCandidate candidate = kernels_.find(cells_, rows_, batch_, i, none);  // c
    if (candidate.angle < 0) return true;
    const bool going_on = follow_line(job_, pixel, candidate, [this](PixelPlace taken) { off_.add(taken); });
    off_.finish();
    return going_on;
  }

  void take_off(std::int32_t i) noexcept {
    off_.add(places_[i]);
    off_.finish();
  }

  HoughJob& job_;
  Cell* cells_;
  const HoughCellKernels<Cell>& kernels_;
  HoughRows rows_;
  DrawingAhead drawing_;
  TakingOff<Cell> off_;
  HoughBatch batch_;
  PixelPlace places_[room];
  std::uint32_t draws_[room];  ///< how many were drawn when this one was
  Cell most_[room];
};

template <class Cell>
bool run(HoughJob& job, std::span<Cell> cells, const HoughCellKernels<Cell>& kernels) noexcept {
  return Ahead<Cell>(job, cells.data(), kernels).run();
}

}  // namespace

bool may_vote_ahead(const HoughJob& job) noexcept {
  if (job.options.kernels == nullptr || job.trace.event != nullptr || job.windowed()) return false;
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
