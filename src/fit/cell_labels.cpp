// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "cell_labels.hpp"

#include <algorithm>

#include "depth_surfaces.hpp"
#include "four_labels.hpp"
#include "labels_around.hpp"
#include "planes_around.hpp"
#include "undecided_cells.hpp"

namespace straightedge::detail {
namespace {

// A cell is a plane's when the mean square of its residuals is below so many variances of the noise.
// One for pure noise; a small cell's readings share their noise, so that its mean square strays further.
constexpr float pure = 2;
constexpr std::array<float, DepthCells::levels> pure_of_neighbour{4, 3, 2, 2};

// Cells with fewer readings than this share of their pixels are left to the next finer level.
constexpr double least_share = 0.2;

// A cell below this leaves no doubt about the smaller ones in it; one below the other not even about those in
// these.
constexpr float beyond_doubt = 1;
constexpr float settled_below = 0.75F;
// A plane that all of a cell is further from than this is nowhere near it.
constexpr float far_away = 16;

// What is known of a cell beside its label while the finer ones in it are labelled.
enum class Trust : std::uint8_t { little, much, settles, settled };
constexpr unsigned trust_shift = 14;
static_assert((3U << trust_shift) == LabelsAround::mark);

constexpr std::uint16_t with_trust(std::uint16_t label, Trust trust) noexcept {
  return static_cast<std::uint16_t>(label | static_cast<unsigned>(trust) << trust_shift);
}
constexpr std::uint16_t label_of(std::uint16_t marked) noexcept {
  return static_cast<std::uint16_t>(marked & ~LabelsAround::mark);
}
/// How far a cell's label is trusted, from its mean squared residual.
constexpr Trust trust_in(float mean) noexcept {
  return static_cast<Trust>(static_cast<int>(mean < beyond_doubt) + static_cast<int>(mean < settled_below));
}

constexpr std::int32_t at_once = DepthCellTask::cells, parents_at_once = at_once / 2;

/// A bit for each of eight parents becomes two: for the cells in them.
constexpr std::uint32_t cells_of(std::uint32_t parents) noexcept {
  std::uint32_t x = parents;
  x = (x | x << 4U) & 0x0F0FU;
  x = (x | x << 2U) & 0x3333U;
  x = (x | x << 1U) & 0x5555U;
  return x | x << 1U;
}

/// Eight parents: their labels, and how far these are trusted.
struct Parents {
  std::array<std::uint16_t, parents_at_once> label{};
  std::uint32_t much = 0, settles = 0, settled = 0;

  Parents(const std::uint16_t* marked, std::int32_t count) noexcept {
    std::copy(marked, marked + count, label.begin());
    for (std::size_t i = 0; i < label.size(); i += 4) {
      // Little is 0, much 1, settles 2, settled 3.
      const std::uint64_t low = four(&label[i]) >> trust_shift, high = low >> 1U;
      much |= lowest_of(low | high) << i;
      settles |= lowest_of(high) << i;
      settled |= lowest_of(low & high) << i;
    }
    for (std::uint16_t& each : label) each = label_of(each);
  }
};

/// Sixteen cells beside one another, in two rows, with the parents that they lie in.
struct Group {
  DepthCellTask task;
  std::uint32_t settled = 0;  ///< cells whose label is known
  std::uint32_t open = 0;     ///< those that choose
  std::array<std::uint16_t, at_once> label;
};

/// The labels of one level.
struct Level {
  const CellLabeller& work;
  const DepthSurfaces& surfaces;  ///< of the planes
  const CellLabels& labels;
  int level;
  Undecided& undecided;

  std::span<std::uint16_t> labels_of(int which) const noexcept {
    return labels[static_cast<std::size_t>(which)];
  }
  bool is_finest() const noexcept { return level == work.cells.finest(); }
  void begin(DepthCellTask& task) const noexcept {
    const PlaneGate& gate = work.gate;
    const std::int32_t side = DepthCells::side_of(level);
    // As in PlaneGate::inverse_noise.
    const bool fixed = gate.fixed_m > 0;
    task.noise = fixed ? 0.0F : static_cast<float>(gate.inverse_sigma);
    task.noise_of_square = static_cast<float>(fixed ? gate.fixed_m / gate.sigmas : gate.floor_m);
    task.least = static_cast<float>(least_share * side * side);
    task.pure_of_asked = pure_of_neighbour[static_cast<std::size_t>(level)];
    task.pure = pure;
  }
  /// Whether all other planes around a parent are so far from it that no part of it can be theirs.
  bool others_are_far(std::size_t parent, std::uint16_t own, const PlanesAround& around,
                      std::uint32_t bit) const noexcept {
    const DepthCell cell = work.cells.at(level + 1, parent);
    const auto noise = static_cast<float>(work.gate.inverse_noise(static_cast<double>(cell.q)));
    const float limit = far_away * (cell.n * (noise * noise));
    for (std::size_t k = 0; k < around.count; ++k) {
      if ((around.near[k] & bit) == 0 || around.label[k] == own) continue;
      if (!(squared_residuals(cell, surface_of(surfaces, around.label[k] - 1U)) > limit)) return false;
    }
    return true;
  }
  /// Of the parents that would settle their cells, those without another plane near.
  std::uint32_t alone(std::uint32_t parents, std::size_t first, const Parents& own,
                      const PlanesAround& around) const noexcept {
    std::uint32_t found = 0;
    for (std::uint32_t i = 0; parents >> i != 0; ++i) {
      if ((parents >> i & 1U) != 0 && others_are_far(first + i, own.label[i], around, 1U << i))
        found |= 1U << i;
    }
    return found;
  }
  /// What the cells in the parents may take, from what these and those around them have.
  void open(std::int32_t X, std::int32_t Y, Group& group) const noexcept {
    const Size size = work.cells.size(level + 1);
    const std::int32_t count = std::min(parents_at_once, size.width - X);
    const std::uint32_t all = (1U << static_cast<std::uint32_t>(count)) - 1U;
    const auto first =
        static_cast<std::size_t>(Y) * static_cast<std::size_t>(size.width) + static_cast<std::size_t>(X);
    const Parents own(labels_of(level + 1).data() + first, count);
    std::uint32_t settled = own.settled, given = 0, newly_settled = 0;
    if (settled != all) {
      const PlanesAround around(size, labels_of(level + 1), X, Y);
      const std::uint32_t only = around.some & ~around.several;
      const std::uint32_t sure =
          (only & own.much) | alone(around.several & own.settles & ~settled, first, own, around);
      if (is_finest()) {
        settled |= sure;
      } else {
        newly_settled = level == work.cells.finest() + 1 ? sure & own.settles : 0U;
        given = sure & ~newly_settled;
      }
      ask(own, around, given, all & ~(settled | newly_settled), group);
    }
    group.settled = cells_of(settled | newly_settled);
    group.task.given = cells_of(given);
    group.open = cells_of(all & ~(settled | newly_settled));
    for (std::uint32_t i = 0; group.settled != 0 && i < parents_at_once; ++i) {
      const bool marked = !is_finest() && ((settled | newly_settled) >> i & 1U) != 0;
      const std::uint16_t label = marked ? with_trust(own.label[i], Trust::settled) : own.label[i];
      group.label[2 * i] = group.label[2 * i + 1] = label;
    }
  }
  /// The given parents' cells ask for their plane alone, the other open ones for all around.
  static void ask(const Parents& own, const PlanesAround& around, std::uint32_t given, std::uint32_t open,
                  Group& group) noexcept {
    for (std::size_t k = 0; k < around.count; ++k) {
      std::uint32_t parents = around.near[k] & open;
      for (std::uint32_t i = 0; (parents & given) >> i != 0; ++i) {
        if ((given >> i & 1U) != 0 && own.label[i] != around.label[k]) parents &= ~(1U << i);
      }
      if (parents == 0) continue;
      group.task.plane[group.task.asked] = static_cast<std::uint16_t>(around.label[k] - 1);
      group.task.of[group.task.asked++] = static_cast<std::uint16_t>(cells_of(parents));
    }
  }
  std::uint16_t* row(std::int32_t x, std::int32_t y) const noexcept {
    return labels_of(level).data() + static_cast<std::ptrdiff_t>(y) * work.cells.size(level).width + x;
  }
  std::uint32_t free_in_row(std::int32_t x, std::int32_t y) const noexcept {
    const std::uint32_t free = bits_of_free(row(x, y), std::min(at_once, work.cells.size(level).width - x));
    return is_finest() ? free & ~std::uint32_t{rough(x, y)} : free;
  }
  std::uint16_t& rough(std::int32_t x, std::int32_t y) const noexcept {
    const std::int32_t groups = (work.cells.size(level).width + at_once - 1) / at_once;
    return work.rough[static_cast<std::size_t>(y * groups + x / at_once)];
  }
  /// The labels that were found, with what is known of them.
  void mark(DepthCellPlanes& found) const noexcept {
    if (is_finest()) {
      make_fresh(found.label);
      return;
    }
    for (std::size_t i = 0; i < at_once; ++i) {
      const std::uint16_t label = found.label[i];
      found.label[i] = label == 0 ? label : with_trust(label, trust_in(found.mean[i]));
    }
  }
  static void make_fresh(std::uint16_t* sixteen) noexcept {
    static_assert(CellLabeller::fresh == 0x4000, "one below the top bit, which says that there is a label");
    for (std::int32_t i = 0; i < at_once; i += 4) {
      std::uint64_t labels = four(sixteen + i);
      labels |= not_zero(labels & 0x7FFF * four_ones) >> 1U;
      std::memcpy(sixteen + i, &labels, sizeof labels);
    }
  }
  static std::uint16_t fresh(std::uint16_t label) noexcept {
    return static_cast<std::uint16_t>(label | CellLabeller::fresh);
  }
  void decide() const noexcept {
    DepthCellTask task;
    begin(task);
    task.at = {undecided.numbers.data(), at_once};
    task.open = (1U << undecided.count) - 1U;
    task.planes = static_cast<std::int32_t>(work.planes.size());
    DepthCellPlanes found;
    work.kernels.choose_planes(task, surfaces, found);
    mark(found);
    for (std::size_t i = 0; i < undecided.count; ++i) *undecided.label[i] = found.label[i];
    undecided.count = 0;
  }
  /// `free`: as free_in_row.
  void write_row(Group& group, std::int32_t x, std::int32_t y, std::uint32_t free) const noexcept {
    if (free == 0) return;
    std::uint16_t* out = row(x, y);
    const auto place = static_cast<std::size_t>(out - labels_of(level).data());
    DepthCellTask& task = group.task;
    task.at = work.cells.rows(level, place);
    const std::int32_t count = work.cells.size(level).width - x;
    if ((group.settled & free) != 0) {
      // Those without readings enough stay 0.
      std::array<std::uint16_t, at_once> settled;
      for (std::size_t i = 0; i < at_once; ++i) {
        const std::uint16_t label = is_finest() ? fresh(group.label[i]) : group.label[i];
        settled[i] = task.at.first[i] >= task.least ? label : std::uint16_t{0};
      }
      write_some(settled.data(), group.settled & free, count, out);
    }
    task.open = group.open & free;
    if (task.open == 0) return;
    DepthCellPlanes found;
    work.kernels.choose_planes(task, surfaces, found);
    const std::uint32_t later = task.open & bits_of_undecided(found);
    mark(found);
    write_some(found.label, task.open & ~later, count, out);
    for_bits(later, [&](std::uint32_t i) noexcept {
      undecided.add(work.cells.rows(level, place + i), out + i);
      if (undecided.is_full()) decide();
    });
    if (!is_finest()) return;
    const std::uint32_t none = bits_of_free(out, std::min(at_once, count));
    rough(x, y) = static_cast<std::uint16_t>(rough(x, y) | (none & task.open & ~later));
  }
  void label_below(std::int32_t X, std::int32_t Y) const noexcept {
    const std::int32_t x = 2 * X, y = 2 * Y;
    const std::uint32_t upper = free_in_row(x, y);
    const std::uint32_t lower = y + 1 < work.cells.size(level).height ? free_in_row(x, y + 1) : 0;
    if ((upper | lower) == 0) return;
    Group group;
    begin(group.task);
    open(X, Y, group);
    write_row(group, x, y, upper);
    write_row(group, x, y + 1, lower);
  }
  void label_coarsest() const noexcept {
    const Size size = work.cells.size(level);
    Group group;
    begin(group.task);
    group.open = 0xFFFF;
    for (std::int32_t y = 0; y < size.height; ++y) {
      for (std::int32_t x = 0; x < size.width; x += at_once) write_row(group, x, y, free_in_row(x, y));
    }
  }
  void label_finer() const noexcept {
    const Size coarse = work.cells.size(level + 1);
    for (std::int32_t Y = 0; Y < coarse.height; ++Y) {
      for (std::int32_t X = 0; X < coarse.width; X += parents_at_once) label_below(X, Y);
    }
    clear_bits(labels_of(level + 1), LabelsAround::mark);
  }
  void label() const noexcept {
    if (level + 1 == DepthCells::levels) {
      label_coarsest();
    } else {
      label_finer();
    }
    if (undecided.count > 0) decide();
  }
};

}  // namespace

void CellLabeller::label(const CellLabels& labels) const noexcept {
  if (planes.empty()) return;
  fill_surfaces(planes, cells, surfaces);
  Undecided undecided;
  for (int level = DepthCells::levels - 1; level >= cells.finest(); --level) {
    Level{*this, surfaces, labels, level, undecided}.label();
  }
}

}  // namespace straightedge::detail
