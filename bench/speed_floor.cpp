// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <cstring>
#include <memory>

#include "speed_loops.hpp"
#include "speed_rows.hpp"

namespace bench::speed {
namespace {

using straightedge::Size;

constexpr Size frame{640, 480};
constexpr std::size_t pixels = 640 * 480;

/// As memory moves them: the fastest way to have read and written all there is.
Call copy(std::size_t bytes) {
  struct Work {
    std::vector<unsigned char> from, to;
  };
  auto w = std::make_shared<Work>();
  w->from.assign(bytes, 1);
  w->to.assign(bytes, 0);
  return [w, bytes] {
    std::memcpy(w->to.data(), w->from.data(), bytes);
    need(w->to[bytes - 1] == 1, "not copied");
    w->to[bytes - 1] = 0;
  };
}

#ifdef SPEED_HAS_LOOPS
struct Coordinates {
  std::vector<float> x = std::vector<float>(pixels, 1.0F), y = x, z = x;
};

template <class Loop>
Call over_points(Loop loop) {
  auto points = std::make_shared<Coordinates>();
  return [points, loop] { need(loop(points->x.data(), points->y.data(), points->z.data()) > 0, "no sum"); };
}

constexpr float plane[] = {0.1F, 0.2F, 0.3F, 0.1F};

template <class Score>
Call scoring(Score score) {
  return over_points(
      [score](const float* x, const float* y, const float* z) { return score(x, y, z, pixels, plane); });
}
template <class Sum>
Call summing(Sum sum) {
  return over_points([sum](const float* x, const float* y, const float* z) {
    float products[6];
    sum(x, y, z, pixels, products);
    return products[0];
  });
}
#endif

}  // namespace

std::vector<Floor> floors() {
  std::vector<Floor> all;
  all.push_back({"read the picture, write the edges: a copy of 0.3 MB", copy(pixels), canny_job(frame)});
  all.push_back({"read the depth: a copy of 0.6 MB", copy(2 * pixels), first_plane_job(frame)});
#ifdef SPEED_HAS_LOOPS
  if (__builtin_cpu_supports("avx2"))
    all.push_back(
        {"one plane scored on every reading", scoring(separate::score_plane), first_plane_job(frame)});
#endif
  all.push_back(
      {"read the depth, write the labels: a copy of 0.6 MB", copy(2 * pixels), ransac_planes_job(frame)});
  all.push_back({"the same", copy(2 * pixels), hough_planes_job(frame)});
  constexpr int power = 6, bytes_a_point = 16;
  all.push_back({"write 10^6 points with their indices: a copy of 16 MB",
                 copy(std::size_t{1'000'000} * bytes_a_point), octree_job(power)});
  return all;
}

std::vector<Fused> fused_loops() {
#ifdef SPEED_HAS_LOOPS
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"))
    return {
        {"one plane scored on 307 200 points", scoring(separate::score_plane), scoring(fused::score_plane)},
        {"six products summed over 307 200 points", summing(separate::sum_products),
         summing(fused::sum_products)}};
#endif
  return {};
}

}  // namespace bench::speed
