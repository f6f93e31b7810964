// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "ransac/pieces.hpp"

namespace straightedge::ransac {
namespace {

/// Cell numbers are offset so that neighbours differ by one without wrapping round.
constexpr std::int64_t middle = std::int64_t{1} << 30;

std::uint64_t key_of(std::int64_t x, std::int64_t y) noexcept {
  return (static_cast<std::uint64_t>(y + middle) << 32U) | static_cast<std::uint64_t>(x + middle);
}

std::int64_t cell_number(double x) noexcept {
  const double most = static_cast<double>(middle) - 2;
  const double bounded = x < -most ? -most : (x > most ? most : x);
  const auto whole = static_cast<std::int64_t>(bounded);
  return bounded < static_cast<double>(whole) ? whole - 1 : whole;
}

/// The readings of one plane with their cells, sorted by cell and number.
struct Members {
  std::span<std::uint64_t> cell;
  std::span<std::uint32_t> member;
  std::size_t count = 0;

  bool less(std::size_t i, std::size_t j) const noexcept {
    return cell[i] != cell[j] ? cell[i] < cell[j] : member[i] < member[j];
  }
  void swap(std::size_t i, std::size_t j) noexcept {
    const std::uint64_t c = cell[i];
    const std::uint32_t m = member[i];
    cell[i] = cell[j];
    member[i] = member[j];
    cell[j] = c;
    member[j] = m;
  }
  void sink(std::size_t root, std::size_t end) noexcept {
    for (std::size_t child = 2 * root + 1; child < end; child = 2 * root + 1) {
      if (child + 1 < end && less(child, child + 1)) ++child;
      if (!less(root, child)) return;
      swap(root, child);
      root = child;
    }
  }
  /// Heapsort: in place, and no input is a bad one. Pixels come sorted.
  void sort() noexcept {
    std::size_t i = 1;
    while (i < count && less(i - 1, i)) ++i;
    if (i >= count) return;
    for (std::size_t root = count / 2; root-- > 0;) sink(root, count);
    for (std::size_t end = count; end-- > 1;) {
      swap(0, end);
      sink(0, end);
    }
  }
};

void gather(const Readings& readings, std::span<const std::uint16_t> labels, std::uint16_t label,
            const PlaneFit& fit, double cell_m, Members& members) noexcept {
  members.count = 0;
  const std::uint32_t count = readings.count();
  for (std::uint32_t i = 0; i < count; ++i) {
    if (labels[i] != label) continue;
    const std::size_t k = members.count++;
    members.member[k] = i;
    if (readings.is_frame()) {
      const auto width = static_cast<std::uint32_t>(readings.size().width);
      members.cell[k] = key_of(i % width, i / width);
    } else {
      const Vector3 p = readings.points.at(i) - fit.centroid;
      members.cell[k] =
          key_of(cell_number(dot(p, fit.tangent_u) / cell_m), cell_number(dot(p, fit.tangent_v) / cell_m));
    }
  }
  members.sort();
}

/// Pieces of one plane as a forest over the places of the first member of each cell.
struct Forest {
  std::span<std::uint32_t> parent;

  std::uint32_t root(std::uint32_t i) noexcept {
    while (parent[i] != i) {
      parent[i] = parent[parent[i]];
      i = parent[i];
    }
    return i;
  }
  /// The lower place becomes the root: pieces are numbered the same whatever the order of joining.
  void join(std::uint32_t a, std::uint32_t b) noexcept {
    const std::uint32_t x = root(a), y = root(b);
    if (x < y) {
      parent[y] = x;
    } else {
      parent[x] = y;
    }
  }
};

/// Where a cell begins among the members, or count if it is empty.
std::size_t find_cell(const Members& members, std::uint64_t cell) noexcept {
  std::size_t low = 0, high = members.count;
  while (low < high) {
    const std::size_t half = (low + high) / 2;
    if (members.cell[half] < cell) {
      low = half + 1;
    } else {
      high = half;
    }
  }
  return low < members.count && members.cell[low] == cell ? low : members.count;
}

void join_cells(const Members& members, Forest& forest) noexcept {
  constexpr std::uint64_t row = std::uint64_t{1} << 32U;
  for (std::uint32_t i = 0; i < members.count; ++i) {
    forest.parent[i] = i;
    const std::uint64_t cell = members.cell[i];
    if (i > 0 && members.cell[i - 1] == cell) {
      forest.join(i, i - 1);
      continue;
    }
    for (const std::uint64_t before : {cell - 1, cell - row - 1, cell - row, cell - row + 1}) {
      const std::size_t at = find_cell(members, before);
      if (at < i) forest.join(i, static_cast<std::uint32_t>(at));
    }
  }
}

}  // namespace

std::uint32_t split_pieces(const Readings& readings, const detail::RansacPlanesMemory& memory, double cell_m,
                           std::uint32_t least, std::uint32_t planes, std::span<FoundPlane> out,
                           bool& full) noexcept {
  std::uint32_t all = planes;
  for (std::uint32_t plane = 0; plane < planes; ++plane) {
    Members members{memory.cell, memory.member, 0};
    gather(readings, memory.label, static_cast<std::uint16_t>(plane + 1), out[plane].fit, cell_m, members);
    Forest forest{memory.parent};
    join_cells(members, forest);
    const std::span<std::uint32_t> extent = memory.extent.first(members.count);
    for (std::uint32_t& e : extent) e = 0;
    for (std::uint32_t i = 0; i < members.count; ++i) ++extent[forest.root(i)];
    std::uint32_t largest = 0;
    for (std::uint32_t i = 0; i < members.count; ++i) largest = extent[i] > extent[largest] ? i : largest;
    // From here on the extent of a root is its label: roots come before their members.
    for (std::uint32_t i = 0; i < members.count; ++i) {
      if (forest.root(i) == i) {
        const bool enough = extent[i] >= least;
        const bool room = i == largest || (all < out.size() && all < 65535);
        full = full || (enough && !room);
        if (enough && room && i != largest) out[all] = out[plane];
        extent[i] = !enough || !room ? 0 : (i == largest ? plane + 1 : ++all);
      }
      memory.label[members.member[i]] = static_cast<std::uint16_t>(extent[forest.root(i)]);
    }
  }
  return all;
}

}  // namespace straightedge::ransac
