// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <memory>

#include "pictures.hpp"
#include "speed_rows.hpp"
#include "straightedge/canny_fused.hpp"
#include "straightedge/host/canny.hpp"
#include "straightedge/host/hough_lines.hpp"
#include "straightedge/host/line_map_builder.hpp"
#include "with_kernels.hpp"

namespace bench::speed {
namespace {

using namespace straightedge;

struct CannyWork {
  CannyWork(Size size, const KernelSet& set)
      : gray(make_picture({Picture::photo, size})),
        edges(size, 0),
        memory(FusedCanny::workspace_bytes(size, {}, with_kernels(CannyRowOptions(), set))) {
    need(FusedCanny::prepare(canny, size, {}, memory, with_kernels(CannyRowOptions(), set)) == Status::ok,
         "no Canny");
  }

  Image<std::uint8_t> gray, edges;
  std::vector<std::byte> memory;
  FusedCanny canny;
};

Job map_job(const char* name, Size size, const LineMapOptions& options) {
  return {name, text_of(size), pixels_of(size), "pixel", [=](const KernelSet& set) -> Call {
            auto gray = std::make_shared<Image<std::uint8_t>>(make_picture({Picture::floor_plan, size}));
            auto builder = std::make_shared<LineMapBuilder>(options, set);
            return [gray, builder] {
              const auto made = builder->build(gray->view());
              need(made && !made->map.lines.empty(), "no line map");
            };
          }};
}

}  // namespace

Job canny_job(Size size) {
  return {"blur and Canny", text_of(size), pixels_of(size), "pixel", [size](const KernelSet& set) -> Call {
            auto w = std::make_shared<CannyWork>(size, set);
            return [w] { need(w->canny.run(w->gray, w->edges.view()).status == Status::ok, "no edges"); };
          }};
}

Job hough_job(Size size) {
  return {
      "progressive Hough", text_of(size), pixels_of(size), "pixel", [size](const KernelSet& set) -> Call {
        auto edges =
            std::make_shared<Image<std::uint8_t>>(canny(make_picture({Picture::photo, size}), {}, set).edges);
        const HoughOptions options = with_kernels(HoughOptions{.threshold = 50}, set);
        return [edges, options] { need(!hough_lines(edges->view(), options).segments.empty(), "no lines"); };
      }};
}

Job line_map_job(Size size) {
  return map_job("picture to line map", size, {});
}

Job fast_line_map_job(Size size) {
  return map_job("picture to line map, --fast", size, {.refine = false});
}

}  // namespace bench::speed
