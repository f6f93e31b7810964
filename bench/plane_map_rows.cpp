// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <memory>
#include <utility>
#include <vector>

#include "depth_scene.hpp"
#include "plane_rows.hpp"
#include "rows.hpp"
#include "straightedge/depth_cells.hpp"
#include "straightedge/host/plane_detector.hpp"
#include "straightedge/host/plane_map_builder.hpp"
#include "straightedge/inverse_depth.hpp"

namespace bench {
namespace {

using namespace straightedge;

PlaneDetector make_detector(Size size, PlaneMethod method) {
  PlaneDetectorOptions options;
  options.method = method;
  auto made = PlaneDetector::create(size, options);
  require(made ? Status::ok : Status::invalid_option, "make a detector");
  return std::move(*made);
}

auto prepare_inverse_depth(Size size) {
  struct Work {
    DepthFrame frame;
    Image<float> inverse_depth;
  };
  auto w = std::make_shared<Work>(Work{make_depth_frame(size), Image<float>(size)});
  return [w] { require(inverse_depth_image(w->frame.depth(), w->inverse_depth.view()), "inverse depth"); };
}

auto prepare_cells(Size size) {
  struct Work {
    DepthScene scene;
    std::vector<std::byte> memory;
    DepthCells cells;
  };
  auto w = std::make_shared<Work>(Work{make_depth_scene(size), {}, {}});
  Arena measured = Arena::measure();
  w->cells.take(measured, size);
  w->memory.resize(measured.used());
  Arena arena(w->memory);
  w->cells.take(arena, size);
  return [w] { w->cells.build(w->scene.inverse_depth.view()); };
}

auto prepare_hough_search(Size size) {
  struct Work {
    DepthScene scene;
    std::vector<std::byte> workspace;
    std::vector<ProposedPlane> candidates;
    HoughPatchSearch search;
  };
  auto w = std::make_shared<Work>(Work{make_depth_scene(size), {}, std::vector<ProposedPlane>(64), {}});
  w->workspace.resize(HoughPatchSearch::workspace_bytes(size, {}));
  require(HoughPatchSearch::prepare(w->search, size, {}, w->workspace), "prepare search");
  return [w] {
    const auto result = w->search.run(w->scene.inverse_depth.view(), w->scene.camera, {}, w->candidates);
    require(result.status, "search");
    require_some(result.candidates, "candidates");
  };
}

auto prepare_frame_planes(PlaneMethod method) {
  return [method](Size size) {
    struct Work {
      DepthFrame frame;
      PlaneDetector detector;
    };
    auto w = std::make_shared<Work>(Work{make_depth_frame(size), make_detector(size, method)});
    return [w] {
      const auto found = w->detector.detect(w->frame.depth());
      require(found ? Status::ok : Status::invalid_image, "detect");
      require_some(found->planes.size(), "planes");
    };
  };
}

struct MapWork {
  DepthFrame frame;
  DetectedPlanes found;
  PlaneMapBuilder builder;

  void add() {
    const auto added = builder.add(frame.depth(), found.labels, found.planes, {});
    require(added ? Status::ok : Status::invalid_image, "register");
  }
};

std::shared_ptr<MapWork> make_map_work(Size size) {
  DepthFrame frame = make_depth_frame(size);
  auto found = make_detector(size, PlaneMethod::ransac).detect(frame.depth());
  require(found ? Status::ok : Status::invalid_image, "detect");
  auto work = std::make_shared<MapWork>(MapWork{std::move(frame), std::move(*found), PlaneMapBuilder()});
  work->add();
  return work;
}

auto prepare_known_place(Size size) {
  auto w = make_map_work(size);
  return [w] { w->add(); };
}

auto prepare_new_place(Size size) {
  auto w = make_map_work(size);
  return [w] {
    w->builder = PlaneMapBuilder();
    w->add();
  };
}

auto prepare_build(Size size) {
  auto w = make_map_work(size);
  return [w] {
    const auto reading = w->builder.build();
    require(reading ? Status::ok : Status::invalid_option, "build");
    require_some(reading->map.planes.size(), "planes in the map");
  };
}

}  // namespace

void add_plane_map_rows(Size size) {
  add_plane_row("inverse_depth", size, prepare_inverse_depth);
  add_plane_row("depth_cells", size, prepare_cells);
  add_plane_row("hough_candidates", size, prepare_hough_search);
  add_plane_row("frame_planes_ransac", size, prepare_frame_planes(PlaneMethod::ransac));
  add_plane_row("frame_planes_hough", size, prepare_frame_planes(PlaneMethod::hough));
  add_plane_row("register_new_place", size, prepare_new_place);
  add_plane_row("register_known_place", size, prepare_known_place);
  add_plane_row("build_plane_map", size, prepare_build);
}

}  // namespace bench
