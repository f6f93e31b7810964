// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "straightedge/host/planar_trajectory.hpp"

#include "io/number_lines.hpp"
#include "io/number_text.hpp"
#include "io/read_bytes.hpp"
#include "io/rotation.hpp"
#include "io/text_lines.hpp"

namespace straightedge {
namespace {

constexpr std::size_t max_trajectory_bytes = std::size_t{1} << 28;

std::string commented(const std::string& comment) {
  std::string text;
  for (io::TextLines lines(comment); !lines.at_end();) text.append("# ").append(lines.take()).append("\n");
  return text;
}

/// The numbers of one line, a blank between them.
void add_line(std::string& text, std::span<const double> numbers) {
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (i > 0) text += ' ';
    text += io::to_text(numbers[i]);
  }
  text += '\n';
}

Failure at_line(const std::string& name, std::size_t line, const std::string& sentence) {
  return {Problem::bad_content, name + ": line " + io::to_text(line) + ": " + sentence};
}

Result<TimedPose2> pose_of(const io::NumberLine& line, const std::string& name) {
  const std::vector<double>& v = line.numbers;
  TimedPose2 timed{v[0], {}, {}};
  if (v.size() == 4) {
    timed.pose = {v[1], v[2], v[3]};
  } else if (v.size() == 8) {
    Pose pose;
    if (const char* why = io::take_rotation(std::array{v[4], v[5], v[6], v[7]}, pose); why != nullptr)
      return at_line(name, line.line, why);
    timed.pose = {v[1], v[2], arc_tangent(pose.rotation[3], pose.rotation[0])};
  } else {
    return at_line(name, line.line,
                   "has " + io::to_text(v.size()) + (v.size() == 1 ? " number" : " numbers") +
                       "; poses are lines of 4 (time x y theta) or of 8 as TUM has them");
  }
  if (!usable(timed.pose)) return at_line(name, line.line, "lies too far out");
  return timed;
}

}  // namespace

std::string planar_trajectory_to_text(std::span<const TimedPose2> poses, const std::string& comment) {
  std::string text = commented(comment);
  for (const TimedPose2& timed : poses) {
    const SineCosine half = sine_cosine(0.5 * timed.pose.heading_rad);
    add_line(text,
             std::array{timed.time_s, timed.pose.x_m, timed.pose.y_m, 0.0, 0.0, 0.0, half.sine, half.cosine});
  }
  return text;
}

std::string covariances_to_text(std::span<const TimedPose2> poses, const std::string& comment) {
  std::string text = commented(comment) + "# time xx xy xh yy yh hh\n";
  for (const TimedPose2& timed : poses) {
    const auto& c = timed.covariance;
    add_line(text, std::array{timed.time_s, c[0], c[1], c[2], c[4], c[5], c[8]});
  }
  return text;
}

Result<std::vector<TimedPose2>> read_planar_trajectory(const std::filesystem::path& file) {
  const std::string name = file.string();
  const auto text = io::read_bytes(file, max_trajectory_bytes);
  if (!text) return text.failure();
  const auto lines = io::number_lines(*text, name);
  if (!lines) return lines.failure();
  if (lines->empty()) return Failure{Problem::bad_content, name + ": holds no pose"};
  std::vector<TimedPose2> poses;
  for (const io::NumberLine& line : *lines) {
    const auto timed = pose_of(line, name);
    if (!timed) return timed.failure();
    if (!poses.empty() && timed->time_s < poses.back().time_s)
      return at_line(name, line.line,
                     "time " + io::to_text(timed->time_s) + " comes after " +
                         io::to_text(poses.back().time_s) + ": times must not run backwards");
    poses.push_back(*timed);
  }
  return poses;
}

}  // namespace straightedge
