// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <memory>

#include "depth_scene.hpp"
#include "pictures.hpp"
#include "speed_rows.hpp"
#include "straightedge/canny.hpp"
#include "straightedge/gaussian.hpp"
#include "straightedge/host/frame_cells.hpp"
#include "straightedge/host/line_map_builder.hpp"
#include "straightedge/hough_plane_patches.hpp"
#include "straightedge/hysteresis.hpp"
#include "straightedge/inverse_depth.hpp"
#include "straightedge/magnitude.hpp"
#include "straightedge/ransac_search.hpp"
#include "straightedge/sobel.hpp"
#include "straightedge/suppress.hpp"
#include "with_kernels.hpp"

namespace bench::speed {
namespace {

using namespace straightedge;

constexpr Size size{640, 480};
constexpr CannyOptions canny_options;

/// A picture after all of Canny, so that each stage finds its input in place.
struct Edges {
  Image<std::uint8_t> gray{make_picture({Picture::photo, size})}, bytes{size, 0}, edges{size, 0};
  Image<std::int16_t> dx{size, 0}, dy{size, 0};
  Image<std::int32_t> magnitude{size, 0};
  std::vector<std::byte> memory = std::vector<std::byte>(Canny::workspace_bytes(size, canny_options));
  std::vector<std::byte> scratch = std::vector<std::byte>(std::size_t{1} << 20U);
  std::vector<std::uint32_t> stack = std::vector<std::uint32_t>(hysteresis_stack_size(size));
  std::vector<std::uint16_t> taps =
      std::vector<std::uint16_t>(static_cast<std::size_t>(gaussian_size(canny_options.sigma)));
  Canny canny;

  Edges() {
    need(Canny::prepare(canny, size, canny_options, memory) == Status::ok, "no Canny");
    need(make_gaussian_kernel(canny_options.sigma, taps) == Status::ok, "no kernel");
    run();
  }
  void run() { need(canny.run(gray, edges.view()).status == Status::ok, "no edges"); }
};

/// A stage of Canny as one call, which says how it went.
template <class Stage>
Job canny_stage(const char* name, Stage stage) {
  return {name, text_of(size), pixels_of(size), "pixel", [=](const KernelSet&) -> Call {
            auto e = std::make_shared<Edges>();
            return [=] { need(stage(*e) == Status::ok, name); };
          }};
}

Stages canny_stages() {
  return {"Canny as whole pictures, plain",
          canny_stage("all", [](Edges& e) { return e.run(), Status::ok; }),
          {canny_stage("blur",
                       [](Edges& e) {
                         Arena arena(e.scratch);
                         const auto scratch = GaussianScratch::take(arena, size.width,
                                                                    static_cast<std::int32_t>(e.taps.size()));
                         return gaussian_blur(e.gray, e.taps, Border::reflect_101, scratch, e.bytes.view());
                       }),
           canny_stage("gradient",
                       [](Edges& e) {
                         Arena arena(e.scratch);
                         const auto scratch = SobelScratch::take(arena, size.width, canny_options.aperture);
                         return sobel(e.canny.blurred(), canny_options.aperture, Border::replicate,
                                      GradientScale::clamp, scratch, e.dx.view(), e.dy.view());
                       }),
           canny_stage("magnitude",
                       [](Edges& e) {
                         return gradient_magnitude(e.canny.gradient_x(), e.canny.gradient_y(),
                                                   canny_options.norm, e.magnitude.view());
                       }),
           canny_stage("suppression",
                       [](Edges& e) {
                         return suppress_non_maxima(
                             e.canny.gradient_x(), e.canny.gradient_y(), e.canny.magnitude(),
                             static_cast<std::int32_t>(canny_options.low),
                             static_cast<std::int32_t>(canny_options.high), e.bytes.view());
                       }),
           canny_stage("hysteresis", [](Edges& e) {
             return hysteresis(e.canny.suppressed(), e.stack, e.edges.view()).status;
           })}};
}

Job inverse_depth_job() {
  return {"inverse depth", text_of(size), pixels_of(size), "pixel", [](const KernelSet&) -> Call {
            struct Work {
              DepthFrame frame = make_depth_frame(size);
              Image<float> inverse_depth{size};
            };
            auto w = std::make_shared<Work>();
            return [w] {
              need(inverse_depth_image(w->frame.depth(), w->inverse_depth.view()) == Status::ok,
                   "a broken frame");
            };
          }};
}

template <class Search, class Options>
struct SearchWork {
  Options options = with_kernels(Options(), best_kernels());
  DepthScene scene = make_depth_scene(size);
  std::vector<std::byte> memory = std::vector<std::byte>(Search::workspace_bytes(size, options));
  std::vector<ProposedPlane> candidates = std::vector<ProposedPlane>(64);
  Search search;
  FrameCells cells{scene.inverse_depth, 0, *best_kernels().depth};

  SearchWork() { need(Search::prepare(search, size, options, memory) == Status::ok, "no search"); }
};

Job ransac_search_job() {
  return {"search for planes", text_of(size), pixels_of(size), "pixel", [](const KernelSet&) -> Call {
            auto w = std::make_shared<SearchWork<RansacSearch, RansacSearchOptions>>();
            return [w] {
              need(w->search.run(w->cells.view(), {}, w->candidates).status == Status::ok, "no search");
            };
          }};
}

Job hough_search_job() {
  return {"search for planes", text_of(size), pixels_of(size), "pixel", [](const KernelSet&) -> Call {
            auto w = std::make_shared<SearchWork<HoughPatchSearch, HoughPatchOptions>>();
            return [w] {
              need(w->search.run(w->scene.inverse_depth.view(), w->scene.camera, {}, w->candidates).status ==
                       Status::ok,
                   "no search");
            };
          }};
}

}  // namespace

std::vector<Stages> stages() {
  return {canny_stages(),
          {"picture to line map", line_map_job(size), {canny_job(size)}},
          {"planes and labels, RANSAC", ransac_planes_job(size), {inverse_depth_job(), ransac_search_job()}},
          {"planes and labels, Hough", hough_planes_job(size), {inverse_depth_job(), hough_search_job()}}};
}

}  // namespace bench::speed
