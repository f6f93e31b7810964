// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <filesystem>

#include "detector_testing.hpp"
#include "straightedge/host/camera_file.hpp"
#include "straightedge/host/depth_file.hpp"
#include "straightedge/host/plane_map_builder.hpp"

using namespace detector;

TEST_CASE("the map of one real frame has the wall, although the camera bends it") {
  const std::filesystem::path office = std::filesystem::path(STRAIGHTEDGE_FIXTURES) / "depth" / "mrpt_office";
  const auto camera = read_camera(office / "camera.json");
  const auto raw = read_depth_image(office / "depth.png");
  REQUIRE(camera);
  REQUIRE(raw);
  const DepthView depth{*raw, camera->metres_per_unit(), camera->pinhole};
  for (const PlaneMethod method : both_methods) {
    for (const bool large : {false, true}) {
      INFO(name_of(method) << (large ? ", large planes" : ", all planes"));
      const auto found =
          detect_planes(depth, large ? for_large_planes(by(method), raw->size(), 0.05) : by(method));
      REQUIRE(found);
      PlaneMapBuilder builder;
      REQUIRE(builder.add(depth, found->labels.view(), found->planes, {}));
      const auto read = builder.build();
      REQUIRE(read);
      std::uint64_t most = 0;
      for (const MapPlane& plane : read->map.planes) most = std::max(most, plane.points.value_or(0));
      CHECK(most > 100'000);
    }
  }
}
