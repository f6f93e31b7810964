// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "map/edge_planes.hpp"

#include <cstddef>
#include <memory>
#include <vector>

#include "map/edge_reading.hpp"
#include "straightedge/host/line_map_builder.hpp"
#include "straightedge/random.hpp"
#include "support/catch.hpp"

using namespace straightedge;

namespace {

Image<std::uint8_t> boxes(Size size, std::uint64_t seed) {
  Pcg32 random(seed);
  Image<std::uint8_t> image(size);
  for (std::int32_t y = 0; y < size.height; ++y)
    for (std::int32_t x = 0; x < size.width; ++x)
      image.at(x, y) =
          static_cast<std::uint8_t>(random.below(30) + (((x / 9) + (y / 7)) % 2 == 0 ? 20 : 190));
  return image;
}

template <class T>
bool same(ImageView<const T> a, ImageView<const T> b) {
  bool equal = a.size() == b.size();
  for (std::int32_t y = 0; y < a.height && equal; ++y)
    for (std::int32_t x = 0; x < a.width; ++x) equal = equal && a.at(x, y) == b.at(x, y);
  return equal;
}

/// Of every pixel, and of those across it.
bool same_gradients(const GradientSource& source, const GradientField& stored) {
  const Size size = stored.x.size();
  const auto a = std::make_unique<EdgeBatch>(), b = std::make_unique<EdgeBatch>();
  bool same = source.size() == size;
  for (std::int32_t y = 0; y < size.height && same; ++y) {
    for (std::int32_t x = 0; x < size.width && same; ++x) {
      const PixelGradient gradient = source.at(x, y);
      same = gradient.dx == stored.x.at(x, y) && gradient.dy == stored.y.at(x, y);
      a->count = b->count = 0;
      read_edge({source, source}, x, y, *a);
      read_edge(EdgeSources(stored), x, y, *b);
      same = same && a->dx[0] == b->dx[0] && a->dy[0] == b->dy[0];
      for (std::size_t k = 0; k < EdgeBatch::around; ++k)
        same = same && a->near_dx[k][0] == b->near_dx[k][0] && a->near_dy[k][0] == b->near_dy[k][0];
    }
  }
  return same;
}

}  // namespace

TEST_CASE("the planes are Canny's with every set of kernels") {
  for (const KernelSet& kernels : kernel_sets()) {
    EdgePlanes planes;  // used again and again, for pictures of all sizes
    for (std::uint64_t seed = 1; seed <= 60; ++seed) {
      Pcg32 random(seed);
      const Size size{1 + static_cast<int>(random.below(140)), 1 + static_cast<int>(random.below(60))};
      CannyOptions options{.low = 40, .high = 110};
      options.sigma = seed % 5 == 0 ? 0 : 1.4;
      options.aperture = 3 + 2 * static_cast<int>(random.below(3));
      options.norm = random.below(2) == 0 ? GradientNorm::l1 : GradientNorm::l2;
      if (seed % 7 == 0) options.thresholds = CannyThresholds::automatic;
      INFO(kernels.name << ", seed " << seed << ": " << size.width << "x" << size.height);
      const Image<std::uint8_t> gray = boxes(size, seed);
      std::vector<std::byte> memory(Canny::workspace_bytes(size, options));
      Canny canny;
      REQUIRE(Canny::prepare(canny, size, options, memory) == Status::ok);
      Image<std::uint8_t> edges(size);
      const CannyResult expected = canny.run(gray, edges.view());
      REQUIRE(planes.detect(gray, options, kernels) == expected.status);
      CHECK(same<std::uint8_t>(planes.to_pixels(), edges));
      EdgeBits bits;
      planes.to_bits(bits);
      for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) CHECK(bits.contains(x, y) == (edges.at(x, y) != 0));
      CHECK(same<std::uint8_t>(planes.blurred, canny.blurred()));
      CHECK(same<std::int16_t>(planes.dx, canny.gradient_x()));
      CHECK(same<std::int16_t>(planes.dy, canny.gradient_y()));
      CHECK(planes.result.edges == expected.edges);
      CHECK(planes.result.strong == expected.strong);
      CHECK(planes.result.low == expected.low);
      CHECK(planes.result.high == expected.high);
      const GradientField stored{canny.gradient_x(), canny.gradient_y(), {}};
      for (const Wanted wanted : {Wanted::edges, Wanted::no_edges}) {
        REQUIRE(planes.detect(gray, options, kernels, Kept::blurred, wanted) == expected.status);
        if (wanted == Wanted::edges) CHECK(same<std::uint8_t>(planes.to_pixels(), edges));
        CHECK(same<std::uint8_t>(planes.blurred, canny.blurred()));
        const bool by_stages = options.thresholds == CannyThresholds::automatic;
        CHECK(planes.gradients().is_stored() == (by_stages || options.aperture != 3));
        CHECK(same_gradients(planes.gradients(), stored));
      }
    }
  }
}

TEST_CASE("every set of kernels gives the same line map") {
  Image<std::uint8_t> plan({320, 240}, 254);
  for (std::int32_t y = 20; y < 220; ++y) {
    for (std::int32_t x = 20; x < 300; ++x) {
      const bool wall = x < 24 || x >= 296 || y < 25 || y >= 216 || (x > 150 && x < 153 && y != 90);
      if (wall || (x + 2 * y) / 3 == 130) plan.at(x, y) = static_cast<std::uint8_t>((x * 7 + y * 3) % 30);
    }
  }
  const auto first = build_line_map(plan, {}, kernel_sets().front());
  REQUIRE(first);
  CHECK(first->map.lines.size() > 4);
  for (const KernelSet& kernels : kernel_sets()) {
    INFO(kernels.name);
    const auto map = build_line_map(plan, {}, kernels);
    REQUIRE(map);
    CHECK(map->report.candidates == first->report.candidates);
    REQUIRE(map->map.lines.size() == first->map.lines.size());
    for (std::size_t i = 0; i < map->map.lines.size(); ++i) {
      const MapLine& a = map->map.lines[i];
      const MapLine& b = first->map.lines[i];
      CHECK((a.rho == b.rho && a.theta == b.theta));
      REQUIRE(a.segments.size() == b.segments.size());
      for (std::size_t k = 0; k < a.segments.size(); ++k)
        CHECK((a.segments[k].x0 == b.segments[k].x0 && a.segments[k].y1 == b.segments[k].y1));
    }
  }
}
