// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <limits>
#include <new>

#include "io/ply_bytes.hpp"
#include "straightedge/host/atomic_file.hpp"
#include "straightedge/host/ply.hpp"

namespace straightedge {

PointsPly::PointsPly(const std::vector<std::string>& comments, InvalidPoints invalid) : invalid_(invalid) {
  for (const std::string& comment : comments) comments_ += io::ply_comment(comment);
  room_ = header(std::numeric_limits<std::size_t>::max()).size();
  bytes_.assign(room_, ' ');
}

std::string PointsPly::header(std::size_t count) const {
  return std::string(io::ply_head)
      .append(comments_)
      .append("element vertex ")
      .append(std::to_string(count))
      .append("\n")
      .append(io::ply_vertex_properties)
      .append("end_header\n");
}

void PointsPly::add(const Vector3& world_point, std::uint32_t label) {
  if (invalid_ == InvalidPoints::leave_out && !finite(world_point)) return;
  io::append_vertex(bytes_, world_point, label);
  ++count_;
}

Result<Done> PointsPly::add(const PointsView& points, std::span<const std::uint32_t> labels,
                            const Pose& world_from_points) {
  if (points.count != 0 && !points.valid())
    return Failure{Problem::bad_option, "the view of points makes no sense"};
  if (!labels.empty() && labels.size() != points.count) {
    return Failure{Problem::bad_option, "there are " + std::to_string(labels.size()) + " labels for " +
                                            std::to_string(points.count) + " points"};
  }
  const std::size_t count = count_, size = bytes_.size();
  try {
    for (std::size_t i = 0; i < points.count; ++i) {
      add(world_from_points.apply(points.at(i)), labels.empty() ? 0 : labels[i]);
    }
  } catch (const std::bad_alloc&) {
    bytes_.resize(size);
    count_ = count;
    return Failure{Problem::cannot_write, "the points do not fit into memory"};
  }
  return Done{};
}

Result<Done> PointsPly::write(const std::filesystem::path& file) {
  const std::string head = header(count_);
  const std::size_t start = room_ - head.size();
  bytes_.replace(start, head.size(), head);
  return write_file_atomically(file, std::string_view(bytes_).substr(start));
}

Result<Done> write_points_ply(const std::filesystem::path& file, const PointsView& points,
                              std::span<const std::uint32_t> labels, const std::vector<std::string>& comments,
                              InvalidPoints invalid) {
  PointsPly ply(comments, invalid);
  if (const auto added = ply.add(points, labels); !added) {
    return Failure{added.failure().problem, file.string() + ": " + added.failure().sentence};
  }
  return ply.write(file);
}

}  // namespace straightedge
