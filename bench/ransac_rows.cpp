// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <memory>
#include <vector>

#include "depth_scene.hpp"
#include "plane_rows.hpp"
#include "rows.hpp"
#include "straightedge/ransac_planes.hpp"
#include "straightedge/ransac_search.hpp"

namespace bench {
namespace {

using namespace straightedge;

auto prepare_planes(const RansacOptions& options) {
  return [options](Size size) {
    struct Work {
      DepthScene scene;
      std::vector<std::byte> workspace;
      std::vector<FoundPlane> planes;
      RansacPlanes ransac;
    };
    auto w = std::make_shared<Work>(Work{make_depth_scene(size), {}, std::vector<FoundPlane>(16), {}});
    const auto pixels = static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height);
    w->workspace.resize(RansacPlanes::workspace_bytes(pixels, options));
    require(RansacPlanes::prepare(w->ransac, pixels, options, w->workspace), "prepare ransac");
    return [w] {
      const RansacPlanesResult result =
          w->ransac.run(w->scene.inverse_depth.view(), w->scene.camera, w->planes, {});
      require(result.status, "ransac");
      require_some(result.found.planes, "planes");
    };
  };
}

auto prepare_search(Size size) {
  struct Work {
    DepthScene scene;
    std::vector<std::byte> workspace;
    std::vector<ProposedPlane> candidates;
    RansacSearch search;
  };
  auto w = std::make_shared<Work>(Work{make_depth_scene(size), {}, std::vector<ProposedPlane>(64), {}});
  w->workspace.resize(RansacSearch::workspace_bytes(size, {}));
  require(RansacSearch::prepare(w->search, size, {}, w->workspace), "prepare search");
  return [w] {
    const RansacSearchResult result = w->search.run(w->scene.inverse_depth.view(), {}, w->candidates);
    require(result.status, "search");
    require_some(result.candidates, "candidates");
  };
}

}  // namespace

void add_ransac_rows(Size size) {
  add_plane_row("ransac_first_plane", size, prepare_planes({}));
  add_plane_row("ransac_planes", size, prepare_planes({.max_planes = 8}));
  add_plane_row("ransac_candidates", size, prepare_search);
}

}  // namespace bench
