// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "straightedge/image.hpp"

namespace compare {

/// The shipped photos as parts of a size, at their own scale: what is smaller is mirrored until it fills it.
std::vector<cv::Mat> photos(straightedge::Size size);

/// One picture's view for both libraries.
inline straightedge::GrayView view_of(const cv::Mat& picture) {
  return {picture.ptr<std::uint8_t>(),
          {picture.cols, picture.rows},
          static_cast<std::ptrdiff_t>(picture.step[0])};
}

inline std::string text_of(straightedge::Size size) {
  return std::to_string(size.width) + "x" + std::to_string(size.height);
}

}  // namespace compare
