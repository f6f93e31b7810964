// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <memory>
#include <vector>

#include "depth_scene.hpp"
#include "plane_rows.hpp"
#include "rows.hpp"
#include "straightedge/host/frame_cells.hpp"
#include "straightedge/host/kernels.hpp"
#include "straightedge/ransac_planes.hpp"
#include "straightedge/ransac_search.hpp"

namespace bench {
namespace {

using namespace straightedge;

constexpr double metres_per_unit = 0.0002;

/// The scene as a sensor gives it.
Image<std::uint16_t> raw_depth(const DepthScene& scene) {
  const ImageView<const float> inverse = scene.inverse_depth.view();
  Image<std::uint16_t> raw(inverse.size());
  for (std::int32_t v = 0; v < inverse.height; ++v)
    for (std::int32_t u = 0; u < inverse.width; ++u) {
      const double q = static_cast<double>(inverse.at(u, v));
      const double units = q > 0 ? 1 / (q * metres_per_unit) + 0.5 : 0;
      raw.view().at(u, v) = static_cast<std::uint16_t>(units < 65535 ? units : 65535);
    }
  return raw;
}

auto prepare_planes(const RansacOptions& options) {
  return [options](Size size) {
    struct Work {
      Image<std::uint16_t> raw;
      PinholeCamera camera;
      std::vector<std::byte> workspace;
      std::vector<FoundPlane> planes;
      RansacPlanes ransac;

      DepthView depth() const { return {raw.view(), metres_per_unit, camera}; }
    };
    const DepthScene scene = make_depth_scene(size);
    auto w =
        std::make_shared<Work>(Work{raw_depth(scene), scene.camera, {}, std::vector<FoundPlane>(16), {}});
    const auto pixels = static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height);
    w->workspace.resize(RansacPlanes::workspace_bytes(pixels, options));
    require(RansacPlanes::prepare(w->ransac, pixels, options, w->workspace), "prepare ransac");
    return [w] {
      const RansacPlanesResult result = w->ransac.run(w->depth(), w->planes, {});
      require(result.status, "ransac");
      require_some(result.found.planes, "planes");
    };
  };
}

auto prepare_search(Size size) {
  struct Work {
    DepthScene scene;
    FrameCells cells;
    std::vector<std::byte> workspace;
    std::vector<ProposedPlane> candidates;
    RansacSearch search;
  };
  DepthScene scene = make_depth_scene(size);
  FrameCells cells(scene.inverse_depth);
  auto w = std::make_shared<Work>(
      Work{std::move(scene), std::move(cells), {}, std::vector<ProposedPlane>(64), {}});
  w->workspace.resize(RansacSearch::workspace_bytes(size, {}));
  require(RansacSearch::prepare(w->search, size, {}, w->workspace), "prepare search");
  return [w] {
    const RansacSearchResult result = w->search.run(w->cells.view(), {}, w->candidates);
    require(result.status, "search");
    require_some(result.candidates, "candidates");
  };
}

}  // namespace

void add_ransac_rows(Size size) {
  add_plane_row("ransac_first_plane", size, prepare_planes({.kernels = best_kernels().ransac}));
  add_plane_row("ransac_planes", size, prepare_planes({.max_planes = 8, .kernels = best_kernels().ransac}));
  add_plane_row("ransac_candidates", size, prepare_search);
}

}  // namespace bench
