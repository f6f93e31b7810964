// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
// Same results as ../point_kernels.cpp; read that first.
#include "ransac/fast/lanes.hpp"
#include "ransac/kernels.hpp"

namespace straightedge::STRAIGHTEDGE_KERNEL_SET {
namespace {

constexpr std::int32_t lanes = ransac_lanes;
constexpr std::int32_t width = Floats::count;

/// Some neighbouring points.
struct Look {
  Floats kx, ky, kz, kw, ox, oy, oz, gate;

  explicit Look(const RansacPoints& p) noexcept
      : kx(Floats::all(p.plane.x)),
        ky(Floats::all(p.plane.y)),
        kz(Floats::all(p.plane.z)),
        kw(Floats::all(p.plane.w)),
        ox(Floats::all(p.origin_x)),
        oy(Floats::all(p.origin_y)),
        oz(Floats::all(p.origin_z)),
        gate(Floats::all(p.gate)) {}
};

struct Group {
  Floats px, py, pz;
  const std::uint16_t* labels;
  Floats x, y, r;
  Floats::Mask inside;

  Group(const Look& k, Floats of_x, Floats of_y, Floats of_z, const std::uint16_t* with) noexcept
      : px(of_x),
        py(of_y),
        pz(of_z),
        labels(with),
        x(px - k.ox),
        y(py - k.oy),
        r((k.kx * x + k.ky * y) + (k.kz * (pz - k.oz) + k.kw)) {
    // Where a coordinate is no finite number, neither is the residual, and that is in no gate.
    inside = r.magnitude() < k.gate;
    if (labels != nullptr) inside = both(inside, unlabelled(labels));
  }

  /// Finite points without a label. A finite residual has finite coordinates, which spares nearly all tests.
  std::uint32_t count_readings() const noexcept {
    Floats::Mask finite = r.magnitude() < Floats::all(__builtin_inff());
    if (all_of(finite) && labels == nullptr) return width;
    finite = ((px - px) + (py - py)) + (pz - pz) == Floats::all(0);
    return count_of(labels == nullptr ? finite : both(finite, unlabelled(labels)));
  }
};

/// Sums of some neighbouring lanes.
struct Sums {
  static constexpr int count = 9;
  Floats x, y, xx, xy, yy, r, xr, yr, rr;

  Sums() noexcept { x = y = xx = xy = yy = r = xr = yr = rr = Floats::all(0); }
  void add(const Group& g) noexcept {
    const Floats::Mask in = g.inside;
    x = x.plus(g.x, in);
    y = y.plus(g.y, in);
    xx = xx.plus(g.x * g.x, in);
    xy = xy.plus(g.x * g.y, in);
    yy = yy.plus(g.y * g.y, in);
    r = r.plus(g.r, in);
    xr = xr.plus(g.x * g.r, in);
    yr = yr.plus(g.y * g.r, in);
    rr = rr.plus(g.r * g.r, in);
  }
  void store(float (*sums)[lanes], std::int32_t first) const noexcept {
    const Floats* const all[] = {&x, &y, &xx, &xy, &yy, &r, &xr, &yr, &rr};
    for (int k = 0; k < count; ++k) all[k]->store(sums[k] + first);
  }
};

/// The last points, with what is no point behind them.
struct Tail {
  float x[lanes], y[lanes], z[lanes];
  std::uint16_t labels[lanes] = {};

  Tail(const RansacPoints& p, std::int32_t first) noexcept {
    for (std::int32_t l = 0; l < lanes; ++l) {
      const bool is = first + l < p.count;
      const std::ptrdiff_t at = (first + l) * p.step;
      x[l] = is ? p.x[at] : __builtin_nanf("");
      y[l] = is ? p.y[at] : 0;
      z[l] = is ? p.z[at] : 0;
      if (is && p.labels != nullptr) labels[l] = p.labels[first + l];
    }
  }
};

/// Asks for what lies some hundred points further on, be it of this cloud or not: clouds are larger than the
/// near caches.
void prefetch(const float* axis) noexcept {
  constexpr std::uintptr_t ahead = 512 * sizeof(float);
  __builtin_prefetch(reinterpret_cast<const void*>(reinterpret_cast<std::uintptr_t>(axis) + ahead));
}

/// Points `first` on of each sixteen.
template <bool Labelled, class Visit>
void for_groups(const RansacPoints& p, std::int32_t first, Visit visit) noexcept {
  const Look look(p);
  const std::int32_t whole = p.count / lanes * lanes;
  if (p.step == 1) {
    const float* const axes[] = {p.x, p.y, p.z};
    for (std::int32_t i = first; i < whole; i += lanes) {
      for (const float* const axis : axes) prefetch(axis + i);
      visit(Group(look, Floats::load(p.x + i), Floats::load(p.y + i), Floats::load(p.z + i),
                  Labelled ? p.labels + i : nullptr));
    }
  } else {
    for (std::int32_t i = first; i < whole; i += lanes) {
      const std::ptrdiff_t at = i * p.step;
      visit(Group(look, Floats::load(p.x + at, p.step), Floats::load(p.y + at, p.step),
                  Floats::load(p.z + at, p.step), Labelled ? p.labels + i : nullptr));
    }
  }
  if (whole == p.count) return;
  const Tail t(p, whole);
  visit(Group(look, Floats::load(t.x + first), Floats::load(t.y + first), Floats::load(t.z + first),
              Labelled ? t.labels + first : nullptr));
}

template <class Visit>
void for_groups(const RansacPoints& p, std::int32_t first, Visit visit) noexcept {
  p.labels == nullptr ? for_groups<false>(p, first, visit) : for_groups<true>(p, first, visit);
}

}  // namespace

RansacPointSums sum_points(const RansacPoints& points) noexcept {
  alignas(64) float lane[Sums::count][lanes];
  RansacPointSums out;
  for (std::int32_t first = 0; first < lanes; first += width) {
    Sums sums;
    for_groups(points, first, [&](const Group& group) noexcept {
      out.readings += group.count_readings();
      if (!group.inside) return;
      out.n += count_of(group.inside);
      sums.add(group);
    });
    sums.store(lane, first);
  }
  float* const to[] = {&out.x, &out.y, &out.xx, &out.xy, &out.yy, &out.r, &out.xr, &out.yr, &out.rr};
  for (int k = 0; k < Sums::count; ++k) *to[k] = fold(lane[k]);
  return out;
}

std::uint32_t count_points(const RansacPoints& points) noexcept {
  std::uint32_t n = 0;
  for (std::int32_t first = 0; first < lanes; first += width)
    for_groups(points, first, [&](const Group& group) noexcept { n += count_of(group.inside); });
  return n;
}

}  // namespace straightedge::STRAIGHTEDGE_KERNEL_SET
