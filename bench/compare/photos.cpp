// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "photos.hpp"

#include <cstdio>
#include <cstdlib>
#include <opencv2/imgproc.hpp>

#include "straightedge/host/image_file.hpp"

namespace compare {

std::vector<cv::Mat> photos(straightedge::Size size) {
  std::vector<cv::Mat> scaled;
  for (const char* name : {"building.jpg", "home.jpg", "board.jpg", "blox.jpg", "left01.jpg", "camera.png"}) {
    const auto image = straightedge::read_gray_image(std::string(STRAIGHTEDGE_FIXTURES "/images/") + name);
    if (!image) {
      std::fprintf(stderr, "%s\n", image.failure().sentence.c_str());
      std::exit(70);
    }
    const straightedge::GrayView view = image->view();
    const cv::Mat whole(view.height, view.width, CV_8UC1, const_cast<std::uint8_t*>(view.data),
                        static_cast<std::size_t>(view.stride));
    cv::Mat picture;
    cv::resize(whole, picture, {size.width, size.height}, 0, 0, cv::INTER_LINEAR);
    scaled.push_back(picture);
  }
  return scaled;
}

}  // namespace compare
