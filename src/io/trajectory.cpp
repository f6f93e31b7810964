// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "straightedge/host/trajectory.hpp"

#include <cmath>
#include <span>
#include <string>

#include "io/number_lines.hpp"
#include "io/number_text.hpp"
#include "io/read_bytes.hpp"
#include "io/rotation.hpp"

namespace straightedge {
namespace {

constexpr std::size_t max_trajectory_bytes = std::size_t{1} << 28;

using Poses = std::vector<TimedPose>;
using Lines = std::span<const io::NumberLine>;

/// Thrown inside this file alone, so that the formats below read as they are written.
struct BadLine {
  std::size_t line;
  std::string sentence;
};

std::string counted(std::size_t numbers) {
  return std::to_string(numbers) + (numbers == 1 ? " number" : " numbers");
}

void expect_count(const io::NumberLine& line, std::size_t count) {
  if (line.numbers.size() != count)
    throw BadLine{line.line, "has " + counted(line.numbers.size()) + " where " + std::to_string(count) +
                                 " are expected"};
}

Pose pose_from_quaternion(std::size_t line, std::span<const double, 7> v) {
  Pose pose;
  pose.translation = {v[0], v[1], v[2]};
  if (const char* why = io::take_rotation(std::array{v[3], v[4], v[5], v[6]}, pose); why != nullptr)
    throw BadLine{line, why};
  return pose;
}

Pose pose_from_rows(std::size_t line, std::span<const double, 12> v) {
  Pose pose;
  pose.translation = {v[3], v[7], v[11]};
  const std::array rotation{v[0], v[1], v[2], v[4], v[5], v[6], v[8], v[9], v[10]};
  if (const char* why = io::take_rotation(rotation, pose); why != nullptr) throw BadLine{line, why};
  return pose;
}

bool begins_with_zeros(std::span<const double> row) {
  return row[0] == 0 && row[1] == 0 && row[2] == 0;
}

void expect_last_row(std::size_t line, std::span<const double> row) {
  if (!begins_with_zeros(row) || std::abs(row[3] - 1) > io::rotation_tolerance)
    throw BadLine{line, "the last row of a 4x4 matrix is 0 0 0 1"};
}

Poses timed_quaternions(Lines lines) {
  Poses poses;
  for (const io::NumberLine& line : lines) {
    expect_count(line, 8);
    const double time = line.numbers[0];
    if (!poses.empty() && time < *poses.back().time) {
      throw BadLine{line.line, "time " + io::to_text(time) + " comes after " +
                                   io::to_text(*poses.back().time) + ": times must not run backwards"};
    }
    poses.push_back({time, pose_from_quaternion(line.line, std::span(line.numbers).subspan<1, 7>())});
  }
  return poses;
}

Poses quaternions(Lines lines) {
  Poses poses;
  for (const io::NumberLine& line : lines) {
    expect_count(line, 7);
    poses.push_back({{}, pose_from_quaternion(line.line, std::span(line.numbers).subspan<0, 7>())});
  }
  return poses;
}

/// The first three rows of a matrix, a row a line.
Pose pose_from_lines(Lines lines) {
  std::array<double, 12> rows{};
  for (std::size_t r = 0; r < 3; ++r) {
    if (r >= lines.size()) throw BadLine{lines.back().line, "the file ends within a matrix"};
    expect_count(lines[r], 4);
    for (std::size_t c = 0; c < 4; ++c) rows[4 * r + c] = lines[r].numbers[c];
  }
  return pose_from_rows(lines[0].line, rows);
}

Poses redwood(Lines lines) {
  Poses poses;
  for (; !lines.empty(); lines = lines.subspan(5)) {
    expect_count(lines[0], 3);
    for (const double number : lines[0].numbers) {
      if (number != std::floor(number)) throw BadLine{lines[0].line, "three whole numbers are expected"};
    }
    if (lines.size() < 5) throw BadLine{lines.back().line, "the file ends within a matrix"};
    poses.push_back({{}, pose_from_lines(lines.subspan(1, 3))});
    expect_count(lines[4], 4);
    expect_last_row(lines[4].line, lines[4].numbers);
  }
  return poses;
}

/// Three rows or four: no row of a rotation begins with three zeros.
Poses matrices(Lines lines) {
  Poses poses;
  while (!lines.empty()) {
    poses.push_back({{}, pose_from_lines(lines)});
    const bool fourth =
        lines.size() > 3 && lines[3].numbers.size() == 4 && begins_with_zeros(lines[3].numbers);
    if (fourth) expect_last_row(lines[3].line, lines[3].numbers);
    lines = lines.subspan(fourth ? 4 : 3);
  }
  return poses;
}

Poses matrix_lines(Lines lines) {
  Poses poses;
  const std::size_t count = lines[0].numbers.size();
  for (const io::NumberLine& line : lines) {
    expect_count(line, count);
    poses.push_back({{}, pose_from_rows(line.line, std::span(line.numbers).subspan<0, 12>())});
    if (count == 16) expect_last_row(line.line, std::span(line.numbers).subspan(12));
  }
  return poses;
}

Poses poses_from(Lines lines) {
  switch (lines[0].numbers.size()) {
    case 8:
      return timed_quaternions(lines);
    case 7:
      return quaternions(lines);
    case 3:
      return redwood(lines);
    case 4:
      return matrices(lines);
    case 12:
    case 16:
      return matrix_lines(lines);
    default:
      throw BadLine{lines[0].line, "has " + counted(lines[0].numbers.size()) +
                                       "; poses are TUM lines of 8, Redwood logs or 4x4 matrices"};
  }
}

}  // namespace

Result<std::vector<TimedPose>> read_trajectory(const std::filesystem::path& file) try {
  const auto text = io::read_bytes(file, max_trajectory_bytes);
  if (!text) return text.failure();
  const auto lines = io::number_lines(*text, file.string());
  if (!lines) return lines.failure();
  if (lines->empty()) return Failure{Problem::bad_content, file.string() + ": holds no pose"};
  return poses_from(*lines);
} catch (const BadLine& bad) {
  return Failure{Problem::bad_content,
                 file.string() + ": line " + std::to_string(bad.line) + ": " + bad.sentence};
}

}  // namespace straightedge
