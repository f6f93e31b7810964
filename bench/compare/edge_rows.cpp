// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <cstddef>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "alternation.hpp"
#include "photos.hpp"
#include "rows.hpp"
#include "straightedge/canny_fused.hpp"
#include "straightedge/host/kernels.hpp"

namespace compare {
namespace {

using namespace straightedge;

struct Kind {
  const char* name;
  CannyOptions options;
};
constexpr Kind kinds[] = {
    {"Canny L1", {.sigma = 0, .norm = GradientNorm::l1, .low = 50, .high = 150}},
    {"Canny L2", {.sigma = 0, .norm = GradientNorm::l2, .low = 50, .high = 150}},
    {"blur 5x5, Canny L1", {.sigma = 0.7, .norm = GradientNorm::l1, .low = 50, .high = 150}},
};

/// All photos, one after the other, by both libraries.
class EdgeJob {
 public:
  EdgeJob(const std::vector<cv::Mat>& pictures, const CannyOptions& options, const KernelSet& kernels)
      : pictures_(pictures), options_(options) {
    const Size size = view_of(pictures[0]).size();
    const CannyRowOptions rows{.kernels = kernels.canny_rows};
    memory_.resize(FusedCanny::workspace_bytes(size, options, rows));
    prepared_ = FusedCanny::prepare(canny_, size, options, memory_, rows);
    for (const cv::Mat& picture : pictures) {
      ours_.emplace_back(picture.size(), CV_8UC1);
      theirs_.emplace_back(picture.size(), CV_8UC1);
    }
  }

  void run_ours() {
    for (std::size_t i = 0; i < pictures_.size(); ++i) {
      const GrayView gray = view_of(pictures_[i]);
      done_ = canny_.run(gray, {ours_[i].ptr<std::uint8_t>(), gray.size()}).status;
    }
  }
  void run_theirs() {
    const bool l2 = options_.norm == GradientNorm::l2;
    for (std::size_t i = 0; i < pictures_.size(); ++i) {
      const cv::Mat* input = &pictures_[i];
      if (options_.sigma > 0) {
        const int side = gaussian_size(options_.sigma);
        cv::GaussianBlur(pictures_[i], blurred_, {side, side}, options_.sigma, 0, cv::BORDER_REFLECT_101);
        input = &blurred_;
      }
      cv::Canny(*input, theirs_[i], options_.low, options_.high, options_.aperture, l2);
    }
  }
  bool agree() const {
    bool same = prepared_ == Status::ok && done_ == Status::ok;
    for (std::size_t i = 0; i < ours_.size(); ++i)
      same = same && cv::norm(ours_[i], theirs_[i], cv::NORM_INF) == 0;
    return same;
  }

 private:
  const std::vector<cv::Mat>& pictures_;
  CannyOptions options_;
  std::vector<std::byte> memory_;
  FusedCanny canny_;
  Status prepared_ = Status::not_prepared, done_ = Status::not_prepared;
  std::vector<cv::Mat> ours_, theirs_;
  cv::Mat blurred_;
};

}  // namespace

void print_edge_rows(Size size, int rounds) {
  const std::vector<cv::Mat> pictures = photos(size);
  for (const Kind& kind : kinds) {
    for (const KernelSet& kernels : kernel_sets()) {
      EdgeJob job(pictures, kind.options, kernels);
      print_row({kind.name, text_of(size), std::string(kernels.name), [&] { job.run_ours(); },
                 [&] { job.run_theirs(); }, [&] { return job.agree(); }},
                rounds);
    }
  }
}

}  // namespace compare
