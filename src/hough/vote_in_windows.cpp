// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "hough/vote_in_windows.hpp"

#include "hough/drawing.hpp"
#include "hough/follow_line.hpp"
#include "straightedge/hough_kernels.hpp"

namespace straightedge::hough {
namespace {

constexpr std::int32_t room = 64;
static_assert(room <= hough_batch_room && room % hough_some_directions == 0);

class VotingInWindows {
 public:
  explicit VotingInWindows(HoughJob& job) noexcept
      : job_(job),
        states_(states(job)),
        ahead_(job.memory.ahead.front()),
        kernels_(*job.options.kernels),
        rows_{job.memory.cosines.data(), job.memory.sines.data(), job.memory.offsets.data(), job.grid.angles,
              hough_window_angles(job.grid, job.options)},
        rule_{job.options.gradient_window, static_cast<double>(job.grid.theta_step), job.grid.half_turn},
        drawing_(job) {}

  bool run() noexcept {
    while (drawing_.left() > 0) {
      draw();
      if (!vote()) return false;
    }
    job_.result.draws = job_.result.edge_pixels;
    return true;
  }

 private:
  /// Step 2.
  void draw() noexcept {
    std::int32_t count = 0;
    while (drawing_.left() > 0 && count < room) {
      const PixelPlace pixel = drawing_.next();
      ahead_.places[count] = pixel;
      ahead_.draws[count] = job_.result.edge_pixels - drawing_.left();
      count += states_.at(pixel.x, pixel.y) != PixelState::gone ? 1 : 0;
    }
    find_windows(ahead_.places, count, ahead_.voting, ahead_.voting_firsts);  // a
  }

  /// Steps 3 to 6 for the batch. False: output full.
  bool vote() noexcept {
    std::int32_t next = 0;
    while (next < ahead_.voting.count) {
      HoughCandidate candidate;
      const std::int32_t hit = cast(next, candidate);  // b
      const std::int32_t end = hit < ahead_.voting.count ? hit + 1 : hit;
      for (; next < end; ++next) states_.set(ahead_.places[next].x, ahead_.places[next].y, PixelState::voted);
      if (hit == ahead_.voting.count) return true;
      job_.result.draws = ahead_.draws[hit];
      // c
      const bool going_on =
          follow_line(job_, ahead_.places[hit], candidate, [this](PixelPlace taken) { leave(taken); });
      take_off();  // d
      if (!going_on) return false;
      drop_gone(next);
    }
    return true;
  }

  /// Lets the batch vote from number `from` on. The number of the first that has a candidate, or the batch's
  /// count.
  std::int32_t cast(std::int32_t from, HoughCandidate& seen) noexcept {
    const HoughMemory& memory = job_.memory;
    const HoughBatch& batch = ahead_.voting;
    const std::uint16_t* const firsts = ahead_.voting_firsts;
    const std::int32_t threshold = job_.options.threshold;
    return memory.cells8.empty() ? kernels_.words.cast_in_windows(memory.cells16.data(), rows_, batch, firsts,
                                                                  from, threshold, seen)
                                 : kernels_.bytes.cast_in_windows(memory.cells8.data(), rows_, batch, firsts,
                                                                  from, threshold, seen);
  }

  /// Moves those of the batch that are still there up, from number `next` on.
  void drop_gone(std::int32_t next) noexcept {
    std::int32_t count = next;
    for (std::int32_t i = next; i < ahead_.voting.count; ++i) {
      const PixelPlace pixel = ahead_.places[i];
      ahead_.places[count] = pixel;
      ahead_.draws[count] = ahead_.draws[i];
      ahead_.voting.x[count] = ahead_.voting.x[i];
      ahead_.voting.y[count] = ahead_.voting.y[i];
      ahead_.voting_firsts[count] = ahead_.voting_firsts[i];
      count += states_.at(pixel.x, pixel.y) != PixelState::gone ? 1 : 0;
    }
    ahead_.voting.count = count;
  }

  void leave(PixelPlace pixel) noexcept {
    ahead_.left_behind[leaving_++] = pixel;
    if (leaving_ == room) take_off();
  }

  void take_off() noexcept {
    find_windows(ahead_.left_behind, leaving_, ahead_.leaving, ahead_.leaving_firsts);
    const HoughMemory& memory = job_.memory;
    const std::uint16_t* const firsts = ahead_.leaving_firsts;
    if (memory.cells8.empty()) {
      kernels_.words.take_off_in_windows(memory.cells16.data(), rows_, ahead_.leaving, firsts);
    } else {
      kernels_.bytes.take_off_in_windows(memory.cells8.data(), rows_, ahead_.leaving, firsts);
    }
    leaving_ = 0;
  }

  void find_windows(const PixelPlace* pixels, std::int32_t count, HoughBatch& batch,
                    std::uint16_t* firsts) noexcept {
    std::int16_t dx[room] = {};
    std::int16_t dy[room] = {};
    for (std::int32_t i = 0; i < count; ++i) {
      const PixelPlace pixel = pixels[i];
      dx[i] = job_.gradients.dx.at(pixel.x, pixel.y);
      dy[i] = job_.gradients.dy.at(pixel.x, pixel.y);
      batch.x[i] = static_cast<float>(pixel.x);
      batch.y[i] = static_cast<float>(pixel.y);
    }
    batch.count = count;
    kernels_.first_angles(dx, dy, count, rule_, firsts);
  }

  HoughJob& job_;
  PixelStates states_;
  HoughAhead& ahead_;
  const HoughKernels& kernels_;
  HoughRows rows_;
  HoughWindowRule rule_;
  Drawing drawing_;
  std::int32_t leaving_ = 0;
};

}  // namespace

bool may_vote_in_windows(const HoughJob& job) noexcept {
  if (job.options.kernels == nullptr || job.trace.event != nullptr || !job.windowed()) return false;
  return job.memory.cells.empty() && hough_window_angles(job.grid, job.options) < job.grid.half_turn &&
         job.grid.half_turn < hough_no_direction;
}

bool vote_in_windows(HoughJob& job) noexcept {
  return VotingInWindows(job).run();
}

}  // namespace straightedge::hough
