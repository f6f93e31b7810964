// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT

// The planes of one depth frame with the host library, as a list and as two pictures: the labels of the
// pixels, and the cells that they come from:
//   03_planes ransac|hough DEPTH.png CAMERA.json LABELS.png CELLS.png
#include <cstdio>
#include <string>
#include <vector>

#include "straightedge/host/camera_file.hpp"
#include "straightedge/host/depth_file.hpp"
#include "straightedge/host/image_file.hpp"
#include "straightedge/host/label_picture.hpp"
#include "straightedge/host/plane_detector.hpp"

namespace {

using namespace straightedge;

int fail(const Failure& failure) {
  std::fprintf(stderr, "%s\n", failure.sentence.c_str());
  return static_cast<int>(failure.problem);
}

/// Cells of 4 pixels have the labels that planes had before they were sorted: a cell's colour is the label
/// that most of its plane's pixels have.
std::vector<std::uint16_t> final_labels(const FramePlanes& frame, const DetectedPlanes& found) {
  const Size size = frame.cells().size(0);
  const std::size_t labels = found.planes.size() + 1;
  std::vector<std::uint32_t> pixels(257 * labels);
  for (std::int32_t y = 0; y < found.labels.height(); ++y) {
    for (std::int32_t x = 0; x < found.labels.width(); ++x) {
      const auto cell = static_cast<std::size_t>(y / DepthCells::side * size.width + x / DepthCells::side);
      if (const std::uint16_t label = found.labels.at(x, y); label != 0)
        ++pixels[frame.cell_labels(0)[cell] * labels + label];
    }
  }
  std::vector<std::uint16_t> of_cell_label(257);
  for (std::size_t cell = 1; cell < of_cell_label.size(); ++cell) {
    std::size_t best = 0;
    for (std::size_t k = 1; k < labels; ++k) {
      if (pixels[cell * labels + k] > pixels[cell * labels + best]) best = k;
    }
    of_cell_label[cell] = static_cast<std::uint16_t>(best);
  }
  return of_cell_label;
}

/// Side of the largest cell around a pixel, all of one label.
std::int32_t cell_side(const Image<std::uint16_t>& labels, std::int32_t x, std::int32_t y) {
  std::int32_t side = DepthCells::side << (DepthCells::levels - 1);
  for (; side > DepthCells::side; side /= 2) {
    const std::int32_t left = x / side * side, top = y / side * side;
    bool one = left + side <= labels.width() && top + side <= labels.height();
    for (std::int32_t v = top; one && v < top + side; v += DepthCells::side) {
      for (std::int32_t u = left; one && u < left + side; u += DepthCells::side)
        one = labels.at(u, v) == labels.at(x, y);
    }
    if (one) break;
  }
  return side;
}

Image<Rgb> cell_picture(const FramePlanes& frame, const DetectedPlanes& found) {
  const std::vector<std::uint16_t> label_of = final_labels(frame, found);
  Image<std::uint16_t> labels(found.labels.size());
  const std::int32_t columns = frame.cells().size(0).width;
  for (std::int32_t y = 0; y < labels.height(); ++y) {
    for (std::int32_t x = 0; x < labels.width(); ++x) {
      const auto cell = static_cast<std::size_t>(y / DepthCells::side * columns + x / DepthCells::side);
      labels.at(x, y) = label_of[frame.cell_labels(0)[cell]];
    }
  }
  Image<Rgb> picture = label_picture(labels);
  for (std::int32_t y = 0; y < labels.height(); ++y) {
    for (std::int32_t x = 0; x < labels.width(); ++x) {
      const std::int32_t side = cell_side(labels, x, y);
      if (x % side == 0 || y % side == 0) picture.at(x, y) = {};
    }
  }
  return picture;
}

}  // namespace

int main(int argc, char** argv) {
  const std::string method = argc == 6 ? argv[1] : "";
  if (method != "ransac" && method != "hough")
    return fail(
        {Problem::bad_option, "usage: 03_planes ransac|hough DEPTH.png CAMERA.json LABELS.png CELLS.png"});
  const auto camera = read_camera(argv[3]);
  if (!camera) return fail(camera.failure());
  const auto raw = read_depth_frame(argv[2], *camera);
  if (!raw) return fail(raw.failure());

  PlaneDetectorOptions options;
  options.method = method == "hough" ? PlaneMethod::hough : PlaneMethod::ransac;
  auto detector = PlaneDetector::create(raw->size(), options);
  if (!detector) return fail(detector.failure());
  const auto found = detector->detect({raw->view(), camera->metres_per_unit(), camera->pinhole});
  if (!found) return fail(found.failure());
  for (std::size_t k = 0; k < found->planes.size(); ++k) {
    const auto& [fit, inliers, iterations, confidence, score] = found->planes[k];
    std::printf("plane %zu: normal %6.3f %6.3f %6.3f, distance %.3f m, %u pixels\n", k + 1,
                fit.plane.normal.x, fit.plane.normal.y, fit.plane.normal.z, fit.plane.distance, inliers);
  }
  if (const auto done = write_png(argv[4], label_picture(found->labels, *raw).view()); !done)
    return fail(done.failure());
  if (const auto done = write_png(argv[5], cell_picture(detector->frame(), *found).view()); !done)
    return fail(done.failure());
  std::printf("%zu planes in %s and %s\n", found->planes.size(), argv[4], argv[5]);
}
