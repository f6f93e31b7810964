// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "photos.hpp"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <opencv2/imgproc.hpp>

#include "straightedge/host/image_file.hpp"

namespace compare {

namespace {

cv::Mat read_photo(const std::string& name) {
  const auto image = straightedge::read_gray_image(STRAIGHTEDGE_FIXTURES "/images/" + name);
  if (!image) {
    std::fprintf(stderr, "%s\n", image.failure().sentence.c_str());
    std::exit(70);
  }
  const straightedge::GrayView view = image->view();
  return cv::Mat(view.height, view.width, CV_8UC1, const_cast<std::uint8_t*>(view.data),
                 static_cast<std::size_t>(view.stride))
      .clone();
}

}  // namespace

std::vector<cv::Mat> photos(straightedge::Size size) {
  std::vector<cv::Mat> pictures;
  for (const char* name : {"building.jpg", "home.jpg", "board.jpg", "blox.jpg", "left01.jpg", "camera.png"}) {
    const cv::Mat photo = read_photo(name);
    const cv::Mat part = photo({0, 0, std::min(photo.cols, size.width), std::min(photo.rows, size.height)});
    pictures.emplace_back();
    cv::copyMakeBorder(part, pictures.back(), 0, size.height - part.rows, 0, size.width - part.cols,
                       cv::BORDER_REFLECT);
  }
  return pictures;
}

}  // namespace compare
