// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <memory>
#include <opencv2/rgbd.hpp>

#include "peers.hpp"

namespace compare {
namespace {

struct Frame {
  cv::Mat points, mask;
  cv::Mat camera;
  int least = 0;
};

std::shared_ptr<Frame> frame_of(const Scene& scene) {
  const Points& p = scene.picture;
  auto frame = std::make_shared<Frame>();
  frame->points.create(static_cast<int>(p.size()) / p.width, p.width, CV_32FC3);
  for (std::size_t i = 0; i < p.size(); ++i) frame->points.ptr<cv::Vec3f>()[i] = {p.x[i], p.y[i], p.z[i]};
  const straightedge::PinholeCamera& c = scene.frame.camera;
  frame->camera = (cv::Mat_<float>(3, 3) << c.fx, 0, c.cx, 0, c.fy, c.cy, 0, 0, 1);
  frame->least = static_cast<int>(least_share * static_cast<double>(scene.cloud.size()));
  return frame;
}

cv::rgbd::RgbdPlane search_for(int least) {
  constexpr int block = 40;
  return cv::rgbd::RgbdPlane(cv::rgbd::RgbdPlane::RGBD_PLANE_METHOD_DEFAULT, block, least, gate_m);
}

Planes planes_of(const std::vector<cv::Vec4f>& coefficients) {
  Planes planes;
  for (const cv::Vec4f& c : coefficients) planes.push_back({{c[0], c[1], c[2]}, -static_cast<double>(c[3])});
  return planes;
}

}  // namespace

FindPlanes rgbd_planes(const Scene& scene) {
  return [frame = frame_of(scene)] {
    std::vector<cv::Vec4f> coefficients;
    search_for(frame->least)(frame->points, frame->mask, coefficients);
    constexpr int no_plane = 255;
    const auto pixels = static_cast<int>(frame->mask.total());
    return PlanesOfScene{planes_of(coefficients),
                         static_cast<std::size_t>(pixels - cv::countNonZero(frame->mask == no_plane))};
  };
}

}  // namespace compare
