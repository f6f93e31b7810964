// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <opencv2/imgproc.hpp>
#include <span>

#include "alternation.hpp"
#include "photos.hpp"
#include "rows.hpp"
#include "straightedge/canny_fused.hpp"
#include "straightedge/host/canny.hpp"
#include "straightedge/host/parallel.hpp"

namespace compare {
namespace {

using namespace straightedge;

constexpr CannyOptions options{.sigma = 0, .norm = GradientNorm::l1, .low = 50, .high = 150};

/// All photos, one after the other, in memory that is there already, each in a stripe a thread.
class StripedEdges {
 public:
  StripedEdges(const std::vector<cv::Mat>& pictures, unsigned threads) : pictures_(pictures), pool_(threads) {
    const Size size = view_of(pictures[0]).size();
    const CannyRowOptions rows{.kernels = best_kernels().canny_rows,
                               .stripes = static_cast<std::int32_t>(pool_.threads())};
    memory_.resize(FusedCanny::workspace_bytes(size, options, rows));
    status_ = FusedCanny::prepare(canny_, size, options, memory_, rows);
    for (const cv::Mat& picture : pictures) edges_.emplace_back(picture.size(), CV_8UC1);
  }
  void run() {
    const auto for_each = [this](std::int32_t count, auto work) {
      pool_.for_each_index(static_cast<std::size_t>(count),
                           [&](std::size_t i, unsigned) { work(static_cast<std::int32_t>(i)); });
    };
    for (std::size_t i = 0; i < pictures_.size() && status_ == Status::ok; ++i) {
      const GrayView gray = view_of(pictures_[i]);
      status_ = canny_.run_with(gray, {edges_[i].ptr<std::uint8_t>(), gray.size()}, for_each).status;
    }
  }
  bool equal(std::span<const cv::Mat> others) const {
    bool same = status_ == Status::ok;
    for (std::size_t i = 0; i < edges_.size(); ++i)
      same = same && cv::norm(edges_[i], others[i], cv::NORM_INF) == 0;
    return same;
  }
  std::span<const cv::Mat> edges() const { return edges_; }

 private:
  const std::vector<cv::Mat>& pictures_;
  ThreadPool pool_;
  std::vector<std::byte> memory_;
  FusedCanny canny_;
  Status status_ = Status::not_prepared;
  std::vector<cv::Mat> edges_;
};

}  // namespace

void print_threaded_edge_rows(Size size, int rounds) {
  const std::vector<cv::Mat> pictures = photos(size);
  StripedEdges all(pictures, 0), one(pictures, 1);
  std::vector<cv::Mat> theirs(pictures.size());
  const std::string kernels(best_kernels().name);
  print_row({"Canny L1", text_of(size), kernels, [&] { all.run(); },
             [&] {
               for (std::size_t i = 0; i < pictures.size(); ++i)
                 cv::Canny(pictures[i], theirs[i], options.low, options.high, options.aperture, false);
             },
             [&] { return all.equal(theirs); }},
            rounds, Clock::wall);
  print_row({"Canny L1", text_of(size), kernels, [&] { all.run(); }, [&] { one.run(); },
             [&] { return all.equal(one.edges()); }, "ours, one thread"},
            rounds, Clock::wall);
}

}  // namespace compare
