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

/// Lists the edge pixels of the rows [top, bottom) in row-major order, and copies the rows to the mask.
std::size_t list_band(HoughJob& job, std::int32_t top, std::int32_t bottom) noexcept {
  std::size_t count = 0;
  const auto width = static_cast<std::size_t>(job.edges.width);
  for (std::int32_t y = top; y < bottom; ++y) {
    std::uint8_t* mask = job.memory.mask.data() + static_cast<std::size_t>(y) * width;
    const std::uint8_t* row = job.edges.row(y);
    for (std::size_t x = 0; x < width; ++x) {
      mask[x] = row[x] != 0 ? 1 : 0;
      if (row[x] == 0) continue;
      job.memory.points[count++] = {static_cast<std::uint16_t>(x), static_cast<std::uint16_t>(y)};
    }
  }
  return count;
}

/// One angle after the other: at one angle the votes of a band of rows fall near one another, so that
/// the cells stay in the cache while the whole accumulator does not.
void vote_all_angles(HoughJob& job, std::span<const PixelPlace> band) noexcept {
  for (std::int32_t n = 0; n < job.grid.angles; ++n) {
    std::int32_t* cells = middle_cell(job, n);
    const float cosine = job.memory.cosines[static_cast<std::size_t>(n)];
    const float sine = job.memory.sines[static_cast<std::size_t>(n)];
    for (const PixelPlace pixel : band)
      ++cells[hough::round_even(static_cast<float>(pixel.x) * cosine + static_cast<float>(pixel.y) * sine)];
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
  for (std::int32_t top = 0; top < job.edges.height; top += hough_band_rows) {
    const std::int32_t bottom = std::min(top + hough_band_rows, job.edges.height);
    const auto band = job.memory.points.first(list_band(job, top, bottom));
    job.result.edge_pixels += static_cast<std::uint32_t>(band.size());
    if (!job.windowed()) vote_all_angles(job, band);
    for (const PixelPlace pixel : band) {
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
