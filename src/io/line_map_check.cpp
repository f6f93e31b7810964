// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <initializer_list>

#include "io/map_rules.hpp"
#include "io/number_text.hpp"
#include "straightedge/host/line_geometry.hpp"
#include "straightedge/host/map_file.hpp"
#include "straightedge/host/ros_map.hpp"

namespace straightedge {
namespace {

bool finite(std::initializer_list<double> values) {
  return io::all_finite({values.begin(), values.size()});
}

/// Collects breaches, and knows which element is being looked at.
class Checker {
 public:
  explicit Checker(const LineMap& map) : map_(map) {}

  std::vector<MapBreach> run() {
    if (map_.image) check_image(*map_.image);
    for (line_ = 0; line_ < map_.lines.size(); ++line_) check_line(map_.lines[line_]);
    check_unique_ids();
    return std::move(breaches_);
  }

 private:
  void report_image(const char* what) { breaches_.push_back({{}, {}, std::string("image: ") + what}); }
  void report_line(const std::string& what) {
    breaches_.push_back({line_, {}, "line " + std::to_string(map_.lines[line_].id) + ": " + what});
  }
  void report_segment(const MapSegment& segment, const std::string& what) {
    breaches_.push_back({line_, segment_,
                         "line " + std::to_string(map_.lines[line_].id) + ", segment " +
                             std::to_string(segment.id) + ": " + what});
  }

  // Rule 1.
  void check_image(const MapImage& image) {
    if (image.size.width < 1 || image.size.height < 1) report_image("width and height are not above zero");
    if (image.placement) {
      const MapPlacement& at = *image.placement;
      if (!finite({at.resolution, at.origin_x, at.origin_y, at.origin_yaw})) {
        report_image("resolution or origin is not a finite number");
      } else {
        if (at.resolution <= 0) report_image("the resolution is not above zero");
        if (std::abs(at.origin_yaw) > max_origin_yaw)
          report_image("the origin's yaw is outside of ±1000 radians");
      }
    }
    if (image.meaning) {
      const RosMeaning& meaning = *image.meaning;
      if (!(meaning.free_thresh >= 0 && meaning.occupied_thresh <= 1)) {
        report_image("a threshold is outside of 0 to 1");
      }
      if (!(meaning.free_thresh <= meaning.occupied_thresh))
        report_image("free-thresh is above occupied-thresh");
    }
  }

  // Rules 1, 3 and 4; rule 5 by check_segment.
  void check_line(const MapLine& line) {
    if (!finite({line.rho, line.theta})) return report_line("rho or theta is not a finite number");
    if (line.rho < 0) return report_line("rho is negative (" + io::to_text(line.rho) + ")");
    if (!is_normal_form(line.rho, line.theta)) {
      return report_line("theta is outside of its range (" + io::to_text(line.theta) + ")");
    }
    if (line.width && !(finite({*line.width}) && *line.width >= 0)) {
      report_line("the width is negative or not a finite number");
    }
    if (line.covariance) check_covariance(*line.covariance);
    for (segment_ = 0; segment_ < line.segments.size(); ++segment_) {
      check_segment(line, line.segments[segment_]);
    }
  }

  void check_covariance(const LineCovariance& covariance) {
    if (!finite({covariance.at_x, covariance.at_y, covariance.var_theta, covariance.var_offset})) {
      report_line("the covariance has something that is not a finite number");
    } else if (covariance.var_theta < 0 || covariance.var_offset < 0) {
      report_line("the covariance is not positive semi-definite: a variance is negative");
    }
  }

  // Rule 5.
  void check_segment(const MapLine& line, const MapSegment& segment) {
    const Point2 ends[] = {first_end(segment), second_end(segment)};
    if (!finite({segment.x0, segment.y0, segment.x1, segment.y1})) {
      return report_segment(segment, "an end is not finite");
    }
    if (ends[0] == ends[1]) return report_segment(segment, "its length is zero");
    const double tolerance = io::off_feature_tolerance * std::max(1.0, size_of(segment));
    for (const Point2 end : ends) {
      const double distance = std::abs(signed_distance(end, line.rho, line.theta));
      if (!(distance <= tolerance)) {
        return report_segment(segment, "an end lies " + io::to_short_text(distance) + " off its line");
      }
    }
    if (!(length_along(segment, line.theta) > 0)) {
      report_segment(segment, "the ends are in the wrong order along (-sin theta, cos theta)");
    }
  }

  double size_of(const MapSegment& segment) const {
    double size = 0;
    for (const double value : {segment.x0, segment.y0, segment.x1, segment.y1})
      size = std::max(size, std::abs(value));
    if (map_.unit == MapUnit::pixel && map_.image) {
      size = std::max({size, 1.0 * map_.image->size.width, 1.0 * map_.image->size.height});
    }
    return size;
  }

  // Rule 2. The later one of two is reported.
  void check_unique_ids() {
    struct Place {
      std::uint32_t id;
      std::size_t line, segment;
      auto operator<=>(const Place&) const = default;
    };
    std::vector<Place> lines;
    std::vector<Place> segments;
    for (std::size_t i = 0; i < map_.lines.size(); ++i) {
      lines.push_back({map_.lines[i].id, i, 0});
      for (std::size_t k = 0; k < map_.lines[i].segments.size(); ++k) {
        segments.push_back({map_.lines[i].segments[k].id, i, k});
      }
    }
    io::for_each_repeated(std::move(lines), [&](const Place& place) {
      line_ = place.line;
      report_line("another line has the same id");
    });
    io::for_each_repeated(std::move(segments), [&](const Place& place) {
      line_ = place.line;
      segment_ = place.segment;
      report_segment(map_.lines[line_].segments[segment_], "another segment has the same id");
    });
  }

  const LineMap& map_;
  std::size_t line_ = 0;
  std::size_t segment_ = 0;
  std::vector<MapBreach> breaches_;
};

}  // namespace

std::vector<MapBreach> check_line_map(const LineMap& map) {
  return Checker(map).run();
}

}  // namespace straightedge
