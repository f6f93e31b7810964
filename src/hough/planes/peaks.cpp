// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "straightedge/hough_plane_peaks.hpp"

#include <array>

namespace straightedge {
namespace {

/// The values of one accumulator, looked up across distance 0.
struct Field {
  const HoughAccumulator& accumulator;
  std::span<const std::uint32_t> values;

  std::size_t index(std::int32_t direction, std::int32_t k) const noexcept {
    if (k < 0) {
      direction = accumulator.directions().antipode(direction);
      k = -1 - k;
    }
    return static_cast<std::size_t>(direction) * static_cast<std::size_t>(accumulator.distances()) +
           static_cast<std::size_t>(k);
  }
  std::uint64_t along_distance(std::int32_t direction, std::int32_t k) const noexcept {
    const std::uint64_t above = k + 1 < accumulator.distances() ? values[index(direction, k + 1)] : 0;
    return values[index(direction, k - 1)] + 2 * std::uint64_t{values[index(direction, k)]} + above;
  }
};

constexpr std::int32_t piece = 128;
using Piece = std::array<std::uint64_t, piece>;

/// Step 1 of the low-pass for distances from k0 up to k1, added to the sums.
void add_along(const Field& field, std::int32_t direction, std::int32_t k0, std::int32_t k1,
               Piece& sums) noexcept {
  const std::uint32_t* const row = field.values.data() + field.index(direction, 0);
  const std::int32_t first = k0 == 0 ? 1 : k0;
  const std::int32_t end = k1 == field.accumulator.distances() ? k1 - 1 : k1;
  if (k0 == 0) sums[0] += field.along_distance(direction, 0);
  for (std::int32_t k = first; k < end; ++k) {
    sums[static_cast<std::size_t>(k - k0)] +=
        std::uint64_t{row[k - 1]} + row[k + 1] + 2 * std::uint64_t{row[k]};
  }
  if (end < k1 && end > 0) sums[static_cast<std::size_t>(end - k0)] += field.along_distance(direction, end);
}

/// Few sums need more than 32 bits, and small machines divide those alone in hardware.
void to_mean(std::uint64_t& sum, std::uint32_t count) noexcept {
  sum = sum <= UINT32_MAX ? static_cast<std::uint32_t>(sum) / count : sum / count;
}

/// Is it the highest of its direction's distances? Cheap, and enough to pass most cells by.
bool tops_beside(std::span<const std::uint32_t> row, std::int32_t k, std::uint32_t votes) noexcept {
  const auto place = static_cast<std::size_t>(k);
  const bool below = k > 0 && row[place - 1] >= votes;
  const bool above = place + 1 < row.size() && row[place + 1] > votes;
  return !below && !above;
}

bool is_peak(const Field& field, std::int32_t direction, std::int32_t k) noexcept {
  const std::size_t own = field.index(direction, k);
  const std::uint32_t votes = field.values[own];
  bool highest = true;
  field.accumulator.directions().for_neighbours(direction, [&](std::int32_t other) noexcept {
    if (!highest) return;
    for (std::int32_t beside = k - 1; beside <= k + 1; ++beside) {
      if (beside >= field.accumulator.distances()) continue;
      const std::size_t at = field.index(other, beside);
      const std::uint32_t value = field.values[at];
      highest = highest && (value < votes || (value == votes && at >= own));
    }
  });
  return highest;
}

/// Most directions hold nothing worth a look: the OR of numbers is below none of them, and quickly made.
bool all_below(std::span<const std::uint32_t> values, std::uint32_t least) noexcept {
  std::uint32_t bits = 0;
  for (const std::uint32_t value : values) bits |= value;
  return bits < least;
}

/// Puts a peak in its place among those that are sorted already. False: the worst one had to go.
bool insert(const HoughPlanePeak& peak, std::span<HoughPlanePeak> peaks, std::uint32_t& count) noexcept {
  const bool full = count == peaks.size();
  if (full && (count == 0 || peaks[count - 1].votes >= peak.votes)) return false;
  std::uint32_t place = full ? count - 1 : count;
  for (; place > 0 && peaks[place - 1].votes < peak.votes; --place) peaks[place] = peaks[place - 1];
  peaks[place] = peak;
  if (!full) ++count;
  return !full;
}

}  // namespace

Status low_pass_votes(const HoughAccumulator& accumulator, std::span<std::uint32_t> smooth) noexcept {
  if (smooth.size() != accumulator.votes().size()) return Status::size_mismatch;
  const Field field{accumulator, accumulator.votes()};
  const HoughDirections& directions = accumulator.directions();
  for (std::int32_t direction = 0; direction < directions.size(); ++direction) {
    for (std::int32_t k0 = 0; k0 < accumulator.distances(); k0 += piece) {
      const std::int32_t left = accumulator.distances() - k0;
      const std::int32_t k1 = k0 + (left < piece ? left : piece);
      // Step 1 for the neighbours, and their mean.
      Piece sum{};
      std::uint32_t neighbours = 0;
      directions.for_neighbours(direction, [&](std::int32_t other) noexcept {
        if (other == direction) return;
        add_along(field, other, k0, k1, sum);
        ++neighbours;
      });
      for (std::int32_t k = k0; k < k1; ++k) to_mean(sum[static_cast<std::size_t>(k - k0)], neighbours);
      // Step 1 for the cells themselves, and step 2.
      add_along(field, direction, k0, k1, sum);
      for (std::int32_t k = k0; k < k1; ++k) {
        const std::uint64_t value = sum[static_cast<std::size_t>(k - k0)];
        smooth[field.index(direction, k)] =
            value < UINT32_MAX ? static_cast<std::uint32_t>(value) : UINT32_MAX;
      }
    }
  }
  return Status::ok;
}

Status find_plane_peaks(const HoughAccumulator& accumulator, std::span<const std::uint32_t> values,
                        std::uint32_t least, std::span<HoughPlanePeak> peaks, std::uint32_t& count) noexcept {
  count = 0;
  if (values.size() != accumulator.votes().size()) return Status::size_mismatch;
  const Field field{accumulator, values};
  Status status = Status::ok;
  if (least == 0) least = 1;
  const auto distances = static_cast<std::size_t>(accumulator.distances());
  const bool own = values.data() == accumulator.votes().data();
  for (std::int32_t direction = 0; direction < accumulator.directions().size(); ++direction) {
    if (own && !accumulator.used(direction)) continue;
    const auto row = values.subspan(static_cast<std::size_t>(direction) * distances, distances);
    if (all_below(row, least)) continue;
    for (std::int32_t k = 0; k < accumulator.distances(); ++k) {
      const std::uint32_t votes = row[static_cast<std::size_t>(k)];
      if (votes < least || !tops_beside(row, k, votes) || !is_peak(field, direction, k)) continue;
      if (!insert({direction, k, votes}, peaks, count)) status = Status::output_full;
    }
  }
  return status;
}

}  // namespace straightedge
