// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <memory>

#include "pictures.hpp"
#include "speed_kernels.hpp"
#include "speed_rows.hpp"
#include "straightedge/canny_fused.hpp"
#include "straightedge/host/canny.hpp"
#include "straightedge/host/hough_lines.hpp"
#include "straightedge/host/line_map_builder.hpp"

namespace bench::speed {
namespace {

using namespace straightedge;

struct CannyWork {
  CannyWork(Size size, const KernelSet& set)
      : gray(make_picture({Picture::photo, size})),
        edges(size, 0),
        memory(FusedCanny::workspace_bytes(size, {}, canny_rows_of(set))) {
    need(FusedCanny::prepare(canny, size, {}, memory, canny_rows_of(set)) == Status::ok, "no Canny");
  }

  Image<std::uint8_t> gray, edges;
  std::vector<std::byte> memory;
  FusedCanny canny;
};

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
        return [edges] { need(!hough_lines(edges->view(), {.threshold = 50}).segments.empty(), "no lines"); };
      }};
}

Job line_map_job(Size size) {
  return {"picture to line map", text_of(size), pixels_of(size), "pixel", [size](const KernelSet&) -> Call {
            auto gray = std::make_shared<Image<std::uint8_t>>(make_picture({Picture::floor_plan, size}));
            return [gray] {
              const auto made = build_line_map(gray->view());
              need(made && !made->map.lines.empty(), "no line map");
            };
          }};
}

}  // namespace bench::speed
