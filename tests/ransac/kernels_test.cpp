// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT

// Every set of kernels gives the bits of the plain one.
#include <bit>
#include <limits>
#include <vector>

#include "run_planes.hpp"
#include "straightedge/host/kernels.hpp"

using namespace straightedge;

namespace {

const RansacKernels& plain = plain_ransac_kernels;

float one_of(Pcg32& random, const std::vector<float>& extremes) {
  const std::uint32_t drawn = random.below(12 + static_cast<std::uint32_t>(extremes.size()));
  if (drawn >= 12) return extremes[drawn - 12];
  return static_cast<float>(random.below(2'000'001)) / 1e6F - 1;
}

const std::vector<float> no_extremes;
const std::vector<float> extremes{0.0F,
                                  -0.0F,
                                  1e-30F,
                                  1e38F,
                                  -1e38F,
                                  std::numeric_limits<float>::infinity(),
                                  -std::numeric_limits<float>::infinity(),
                                  std::numeric_limits<float>::quiet_NaN()};

bool same(float a, float b) {
  return std::bit_cast<std::uint32_t>(a) == std::bit_cast<std::uint32_t>(b) || (a != a && b != b);
}

std::vector<std::uint16_t> labels_by_chance(std::size_t count, Pcg32& random) {
  std::vector<std::uint16_t> labels(count);
  for (auto& label : labels)
    label = random.below(3) == 0 ? static_cast<std::uint16_t>(random.below(65536)) : 0;
  return labels;
}

struct Rows {
  std::vector<float> column[4];

  Rows(std::uint32_t count, const std::vector<float>& with, Pcg32& random) {
    for (auto& c : column)
      for (std::uint32_t i = 0; i < count; ++i) c.push_back(one_of(random, with));
  }
  RansacRows view() const {
    return {column[0].data(), column[1].data(), column[2].data(), column[3].data(),
            static_cast<std::uint32_t>(column[0].size())};
  }
};

RansacCoefficients plane_by_chance(const std::vector<float>& with, Pcg32& random) {
  return {one_of(random, with), one_of(random, with), one_of(random, with), one_of(random, with)};
}

void check_rows(const RansacKernels& kernels, const std::vector<float>& with, std::uint32_t count,
                Pcg32& random) {
  const Rows rows(count, with, random);
  RansacBatch batch;
  for (std::uint32_t h = 0; h < ransac_lanes; ++h) {
    const RansacCoefficients k = plane_by_chance(with, random);
    batch.x[h] = k.x, batch.y[h] = k.y, batch.z[h] = k.z, batch.w[h] = k.w;
    REQUIRE(same(kernels.row_cost(rows.view(), k), plain.row_cost(rows.view(), k)));
    REQUIRE(kernels.count_rows(rows.view(), k) == plain.count_rows(rows.view(), k));
  }
  float costs[2][ransac_lanes];
  plain.batch_costs(rows.view(), batch, costs[0]);
  kernels.batch_costs(rows.view(), batch, costs[1]);
  for (std::uint32_t h = 0; h < ransac_lanes; ++h) REQUIRE(same(costs[0][h], costs[1][h]));
  const RansacCoefficients k = plane_by_chance(with, random);
  const float* const s = rows.column[random.below(2)].data();
  const float* const t = rows.column[2].data();
  const RansacChangeSums a = plain.sum_changes(rows.view(), k, s, t, 0.5F);
  const RansacChangeSums b = kernels.sum_changes(rows.view(), k, s, t, 0.5F);
  for (const auto member : {&RansacChangeSums::ss, &RansacChangeSums::st, &RansacChangeSums::sw,
                            &RansacChangeSums::tt, &RansacChangeSums::tw, &RansacChangeSums::ww,
                            &RansacChangeSums::se, &RansacChangeSums::te, &RansacChangeSums::we})
    REQUIRE(same(a.*member, b.*member));
}

template <class Q>
void check_pixels(const RansacKernels::Pixels<Q>& kernels, const RansacKernels::Pixels<Q>& oracle,
                  const std::vector<Q>& pixels, Pcg32& random) {
  const auto labels = labels_by_chance(pixels.size(), random);
  RansacPixels<Q> row;
  row.pixels = pixels.data();
  row.labels = random.below(2) == 0 ? labels.data() : nullptr;
  row.count = static_cast<std::int32_t>(pixels.size());
  row.scale = random.below(4) == 0 ? 1e9F : 1000;  // some depths have 1/z beyond what is a reading
  row.a = static_cast<float>(random.below(100)) * 1e-5F;
  row.c = static_cast<float>(random.below(1000)) * 1e-3F;
  row.constant = random.below(4) == 0 ? 0 : static_cast<float>(random.below(1000)) * 1e-3F;
  row.metres = random.below(4) == 0 ? 0 : static_cast<float>(random.below(1000)) * 1e-4F;
  const RansacPixelSums a = oracle.sum(row), b = kernels.sum(row);
  REQUIRE(a.readings == b.readings);
  REQUIRE(a.n == b.n);
  REQUIRE(a.u == b.u);
  REQUIRE(a.uu == b.uu);
  REQUIRE(same(a.r, b.r));
  REQUIRE(same(a.ur, b.ur));
  REQUIRE(same(a.rr, b.rr));
  REQUIRE(kernels.count(row) == a.n);
  REQUIRE(oracle.count(row) == a.n);
}

void check_points(const RansacKernels& kernels, const std::vector<float>& with, std::size_t count,
                  Pcg32& random) {
  const std::size_t step = random.below(2) == 0 ? 1 : 2 + random.below(6);
  std::vector<float> axis[3];
  for (auto& a : axis)
    for (std::size_t i = 0; i < count * step; ++i) a.push_back(one_of(random, with));
  const auto labels = labels_by_chance(count, random);
  RansacPoints p;
  p.x = axis[0].data();
  p.y = axis[1].data();
  p.z = axis[2].data();
  p.labels = random.below(2) == 0 ? labels.data() : nullptr;
  p.count = static_cast<std::int32_t>(count);
  p.step = static_cast<std::ptrdiff_t>(step);
  p.origin_x = one_of(random, no_extremes);
  p.origin_y = one_of(random, no_extremes);
  p.origin_z = one_of(random, no_extremes);
  p.plane = plane_by_chance(no_extremes, random);
  p.gate = static_cast<float>(random.below(1000)) * 1e-3F;
  const RansacPointSums a = plain.sum_points(p), b = kernels.sum_points(p);
  REQUIRE(a.readings == b.readings);
  REQUIRE(a.n == b.n);
  for (const auto member : {&RansacPointSums::x, &RansacPointSums::y, &RansacPointSums::xx,
                            &RansacPointSums::xy, &RansacPointSums::yy, &RansacPointSums::r,
                            &RansacPointSums::xr, &RansacPointSums::yr, &RansacPointSums::rr})
    REQUIRE(same(a.*member, b.*member));
  REQUIRE(kernels.count_points(p) == a.n);
  REQUIRE(plain.count_points(p) == a.n);
}

}  // namespace

TEST_CASE("Every set of kernels: rows equal the plain ones", "[ransac]") {
  for (const KernelSet& set : kernel_sets()) {
    Pcg32 random(1);
    for (std::uint32_t count = 0; count <= 400; count += 16) {
      CAPTURE(set.name, count);
      check_rows(*set.ransac, no_extremes, count, random);
      check_rows(*set.ransac, extremes, count, random);
    }
  }
}

TEST_CASE("Every set of kernels: pixels equal the plain ones", "[ransac]") {
  for (const KernelSet& set : kernel_sets()) {
    Pcg32 random(2);
    for (std::size_t count = 1; count <= 768; count += count < 200 ? 1 : 71) {
      CAPTURE(set.name, count);
      std::vector<std::uint16_t> raw(count);
      std::vector<float> near(count), wild(count);
      for (std::size_t i = 0; i < count; ++i) {
        const std::uint32_t kind = random.below(5);
        raw[i] = static_cast<std::uint16_t>(kind == 0   ? 0
                                            : kind == 1 ? random.below(65536)
                                                        : 900 + random.below(300));
        near[i] = one_of(random, no_extremes);
        wild[i] = one_of(random, extremes);
      }
      check_pixels(set.ransac->raw, plain.raw, raw, random);
      check_pixels(set.ransac->inverse, plain.inverse, near, random);
      check_pixels(set.ransac->inverse, plain.inverse, wild, random);
    }
  }
}

TEST_CASE("Every set of kernels: a row in its plane has the sums of all columns", "[ransac]") {
  for (const KernelSet& set : kernel_sets()) {
    for (std::uint32_t count = 1; count <= ransac_most_pixels; ++count) {
      CAPTURE(set.name, count);
      const std::vector<std::uint16_t> raw(count, 1000);
      RansacPixels<std::uint16_t> row;
      row.pixels = raw.data();
      row.count = static_cast<std::int32_t>(count);
      row.scale = 1000;
      row.c = 1;
      row.constant = 0.01F;
      const RansacPixelSums sums = set.ransac->raw.sum(row);
      REQUIRE(sums.readings == count);
      REQUIRE(sums.n == count);
      REQUIRE(sums.u == count * (count - 1) / 2);
      REQUIRE(sums.uu == count * (count - 1) / 2 * (2 * count - 1) / 3);
      REQUIRE(sums.rr == 0);
    }
  }
}

TEST_CASE("Every set of kernels: points equal the plain ones", "[ransac]") {
  for (const KernelSet& set : kernel_sets()) {
    Pcg32 random(3);
    for (std::size_t count = 1; count <= 1024; count += count < 200 ? 1 : 103) {
      CAPTURE(set.name, count);
      check_points(*set.ransac, no_extremes, count, random);
      check_points(*set.ransac, extremes, count, random);
    }
  }
}

TEST_CASE("Every set of kernels: whole searches equal the plain ones", "[ransac]") {
  for (const KernelSet& set : kernel_sets()) {
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
      CAPTURE(set.name, seed);
      Pcg32 random(seed);
      const scene::Frame frame = scene::render(scene::room_by_chance(random), scene::sigma, 0.2, random);
      const scene::Cloud cloud = scene::to_cloud(frame);
      RansacOptions options{.max_planes = 1 + static_cast<std::uint32_t>(seed % 3), .seed = seed};
      for (const double fixed_m : {0.0, 0.02}) {
        options.gate.fixed_m = fixed_m;
        options.kernels = &plain;
        const scene::FoundPlanes a = scene::find(frame, options), c = scene::find(cloud.view(), options);
        options.kernels = set.ransac;
        const scene::FoundPlanes b = scene::find(frame, options), d = scene::find(cloud.view(), options);
        REQUIRE(a.planes.size() == b.planes.size());
        REQUIRE(c.planes.size() == d.planes.size());
        CHECK(a.labels == b.labels);
        CHECK(c.labels == d.labels);
        for (std::size_t i = 0; i < a.planes.size(); ++i)
          CHECK(a.planes[i].fit.covariance == b.planes[i].fit.covariance);
        for (std::size_t i = 0; i < c.planes.size(); ++i)
          CHECK(c.planes[i].fit.covariance == d.planes[i].fit.covariance);
      }
    }
  }
}
