// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "straightedge/hough_standard.hpp"

#include <algorithm>

#include "hough/angle_table.hpp"
#include "hough/gradient_window.hpp"
#include "hough/take_segments.hpp"
#include "straightedge/trigonometry.hpp"

namespace straightedge {
namespace {

/// The cell of angle n and the distance in the middle.
std::int32_t* middle_cell(const HoughJob& job, std::int32_t n) noexcept {
  const std::ptrdiff_t row = job.grid.distances + 2 * hough_guard;
  return job.memory.cells.data() + (n + hough_guard) * row + hough_guard + (job.grid.distances - 1) / 2;
}

std::size_t list_row(HoughJob& job, std::int32_t y) noexcept {
  std::size_t count = 0;
  const auto width = static_cast<std::size_t>(job.edges.width);
  std::uint8_t* mask = job.memory.mask.data() + static_cast<std::size_t>(y) * width;
  const std::uint8_t* row = job.edges.row(y);
  for (std::size_t x = 0; x < width; ++x) {
    mask[x] = row[x] != 0 ? 1 : 0;
    if (row[x] != 0)
      job.memory.points[count++] = {static_cast<std::uint16_t>(x), static_cast<std::uint16_t>(y)};
  }
  return count;
}

/// One angle after the other: the votes of a row of pixels fall near one another.
void vote_all_angles(HoughJob& job, std::span<const PixelPlace> row, float y) noexcept {
  for (std::int32_t n = 0; n < job.grid.angles; ++n) {
    std::int32_t* cells = middle_cell(job, n);
    const auto angle = static_cast<std::size_t>(n);
    const float cosine = job.memory.cosines[angle];
    const float part = y * job.memory.sines[angle];
    for (const PixelPlace pixel : row)
      ++cells[hough::round_even(static_cast<float>(pixel.x) * cosine + part)];
  }
}

void vote_angles(HoughJob& job, PixelPlace pixel, std::int32_t first, std::int32_t end) noexcept {
  const auto x = static_cast<float>(pixel.x);
  const auto y = static_cast<float>(pixel.y);
  for (std::int32_t n = first; n < end; ++n)
    ++middle_cell(job, n)[hough::distance_cell(job.memory, static_cast<std::size_t>(n), x, y)];
}

/// More votes first, then the smaller index. While peaks are gathered, theta and rho hold the numbers
/// of the angle and the distance, which floats hold exactly.
bool better(const HoughPeak& a, const HoughPeak& b) noexcept {
  if (a.votes != b.votes) return a.votes > b.votes;
  if (a.theta != b.theta) return a.theta < b.theta;
  return a.rho < b.rho;
}

/// Keeps the best in a heap whose top is the worst of them.
void gather(HoughJob& job, const HoughPeak& peak) noexcept {
  HoughPeak* const begin = job.peaks.data();
  if (job.result.peaks < job.peaks.size()) {
    begin[job.result.peaks++] = peak;
    std::push_heap(begin, begin + job.result.peaks, better);
    return;
  }
  job.result.status = Status::output_full;
  if (!better(peak, *begin)) return;
  std::pop_heap(begin, begin + job.result.peaks, better);
  begin[job.result.peaks - 1] = peak;
  std::push_heap(begin, begin + job.result.peaks, better);
}

}  // namespace

bool vote_standard(HoughJob& job) noexcept {
  // Step 1.
  hough::fill_angles_by_adding(job);
  for (std::int32_t& cell : job.memory.cells) cell = 0;
  // Step 2.
  for (std::int32_t y = 0; y < job.edges.height; ++y) {
    const auto row = job.memory.points.first(list_row(job, y));
    job.result.edge_pixels += static_cast<std::uint32_t>(row.size());
    if (!job.windowed()) vote_all_angles(job, row, static_cast<float>(y));
    for (const PixelPlace pixel : row) {
      if (job.windowed()) {
        const hough::AngleWindow window = hough::angle_window(job, pixel.x, pixel.y);
        vote_angles(job, pixel, window.first, window.end);
        vote_angles(job, pixel, 0, window.wrapped);
      }
      if (!job.tell({.step = HoughStep::vote, .x0 = pixel.x, .y0 = pixel.y})) return false;
    }
  }
  job.result.draws = job.result.edge_pixels;
  return true;
}

bool find_standard_peaks(HoughJob& job) noexcept {
  // Step 3.
  const std::ptrdiff_t row = job.grid.distances + 2 * hough_guard;
  const std::int32_t middle = (job.grid.distances - 1) / 2;
  const bool wanted = !job.peaks.empty() || !job.segments.empty();
  for (std::int32_t n = 0; n < job.grid.angles && wanted; ++n) {
    const std::int32_t* cell = middle_cell(job, n) - middle;
    for (std::int32_t r = 0; r < job.grid.distances; ++r, ++cell) {
      if (*cell <= job.options.threshold || *cell <= cell[-1] || *cell < cell[1] || *cell <= cell[-row] ||
          *cell < cell[row])
        continue;
      if (job.peaks.empty()) return job.stop(Status::output_full);
      gather(job, {static_cast<float>(r), static_cast<float>(n), *cell});
    }
  }
  const auto peaks = job.peaks.first(job.result.peaks);
  std::sort_heap(peaks.begin(), peaks.end(), better);
  for (HoughPeak& peak : peaks) {
    peak.rho = (peak.rho - static_cast<float>(job.grid.distances - 1) * 0.5F) * job.grid.rho_step;
    peak.theta = static_cast<float>(job.options.min_theta) + peak.theta * job.grid.theta_step;
    if (!job.tell({.step = HoughStep::line, .rho = peak.rho, .theta = peak.theta, .votes = peak.votes}))
      return false;
  }
  return true;
}

bool read_peak_segments(HoughJob& job) noexcept {
  // Step 4.
  std::uint32_t taken = 0;
  for (std::uint32_t i = 0; i < job.result.peaks && !job.segments.empty(); ++i) {
    const HoughPeak& peak = job.peaks[i];
    const SineCosine normal = sine_cosine(static_cast<double>(peak.theta));
    if (!hough::take_segments(job, {normal.cosine, normal.sine, static_cast<double>(peak.rho)}, peak.votes,
                              taken))
      return false;
  }
  return true;
}

}  // namespace straightedge
