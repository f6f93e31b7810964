// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "cli/localize_truth.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace straightedge::cli {
namespace {

constexpr double widest_gap_s = 1;

struct Spread {
  double rms = 0, median = 0, worst = 0;
};

Spread spread_of(std::vector<double> errors) {
  if (errors.empty()) return {};
  double sum = 0;
  for (const double e : errors) sum += e * e;
  std::sort(errors.begin(), errors.end());
  const std::size_t half = errors.size() / 2;
  const double median = errors.size() % 2 == 1 ? errors[half] : 0.5 * (errors[half - 1] + errors[half]);
  return {std::sqrt(sum / static_cast<double>(errors.size())), median, errors.back()};
}

/// eᵀ P⁻¹ e by Cholesky's factors; none when P is not positive.
std::optional<double> squared_in_sigmas(const std::array<double, 9>& p, const std::array<double, 3>& e) {
  std::array<double, 9> l{};
  std::array<double, 3> y{};
  double sum = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    double rest = e[i];
    for (std::size_t j = 0; j <= i; ++j) {
      double entry = p[3 * i + j];
      for (std::size_t k = 0; k < j; ++k) entry -= l[3 * i + k] * l[3 * j + k];
      if (i == j && !(entry > 0)) return {};
      l[3 * i + j] = i == j ? std::sqrt(entry) : entry / l[3 * j + j];
      if (j < i) rest -= l[3 * i + j] * y[j];
    }
    y[i] = rest / l[3 * i + i];
    sum += y[i] * y[i];
  }
  return sum;
}

}  // namespace

std::optional<Pose2> truth_at(std::span<const TimedPose2> truth, double time_s) {
  const auto after = std::lower_bound(truth.begin(), truth.end(), time_s,
                                      [](const TimedPose2& pose, double time) { return pose.time_s < time; });
  if (after == truth.end()) return {};
  if (after->time_s == time_s) return after->pose;
  if (after == truth.begin()) return {};
  const TimedPose2& a = *(after - 1);
  const double gap = after->time_s - a.time_s;
  if (!(gap < widest_gap_s)) return {};
  const double part = (time_s - a.time_s) / gap;
  return Pose2{
      a.pose.x_m + part * (after->pose.x_m - a.pose.x_m), a.pose.y_m + part * (after->pose.y_m - a.pose.y_m),
      wrap_angle(a.pose.heading_rad + part * wrap_angle(after->pose.heading_rad - a.pose.heading_rad))};
}

PoseErrors compare_poses(std::span<const TimedPose2> poses, std::span<const TimedPose2> truth,
                         bool covariances) {
  PoseErrors errors;
  std::vector<double> metres, radians;
  double nees = 0;
  bool good = covariances;
  for (const TimedPose2& timed : poses) {
    const auto real = truth_at(truth, timed.time_s);
    if (!real) {
      ++errors.without_truth;
      continue;
    }
    const std::array e{timed.pose.x_m - real->x_m, timed.pose.y_m - real->y_m,
                       wrap_angle(timed.pose.heading_rad - real->heading_rad)};
    metres.push_back(std::sqrt(e[0] * e[0] + e[1] * e[1]));
    radians.push_back(std::abs(e[2]));
    const auto squared = covariances ? squared_in_sigmas(timed.covariance, e) : std::nullopt;
    good = good && squared;
    nees += squared.value_or(0);
  }
  errors.compared = metres.size();
  if (good && errors.compared > 0) errors.nees = nees / static_cast<double>(errors.compared);
  const Spread way = spread_of(std::move(metres)), turn = spread_of(std::move(radians));
  errors.rms_m = way.rms, errors.median_m = way.median, errors.worst_m = way.worst;
  errors.rms_rad = turn.rms, errors.median_rad = turn.median, errors.worst_rad = turn.worst;
  return errors;
}

std::vector<TimedPose2> odometry_alone(const LocalizeRun& run, const LaserLog& log) {
  std::vector<TimedPose2> poses;
  std::optional<Pose2> world_from_odometry;
  for (std::size_t i = 0; i < run.poses.size(); ++i) {
    const auto& odometry = log.scans[run.scan_of[i]].odometry;
    if (!odometry) continue;
    if (!world_from_odometry) world_from_odometry = compose(run.poses[i].pose, inverse(*odometry));
    poses.push_back({run.poses[i].time_s, compose(*world_from_odometry, *odometry), {}});
  }
  return poses;
}

}  // namespace straightedge::cli
