// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "alternation.hpp"
#include "peers.hpp"
#include "rows.hpp"
#include "straightedge/host/kernels.hpp"
#include "straightedge/host/plane_detector.hpp"
#include "straightedge/trigonometry.hpp"
#include "with_kernels.hpp"

namespace compare {
namespace {

using namespace straightedge;

[[noreturn]] void fail(const std::string& what) {
  std::fprintf(stderr, "%s\n", what.c_str());
  std::exit(70);
}

/// Of the readings, those within the gate of any of the planes.
double coverage(const Scene& scene, const Planes& planes) {
  std::size_t covered = 0;
  for (std::size_t i = 0; i < scene.cloud.size(); ++i) {
    const Vector3 p = scene.cloud.at(i);
    covered += std::any_of(planes.begin(), planes.end(), [&p](const Plane& plane) {
      const double d = plane.signed_distance(p);
      return d <= gate_m && d >= -gate_m;
    });
  }
  return static_cast<double>(covered) / static_cast<double>(scene.cloud.size());
}

/// The largest angle between a plane found and the true one that is nearest to it; 0 where no truth is known.
double degrees_off(const Scene& scene, const Planes& planes) {
  double worst = 0;
  for (const Plane& plane : planes) {
    double least = scene.truth.empty() ? 0 : 90;
    for (const Plane& truth : scene.truth) {
      const double cosine = dot(plane.normal, truth.normal);
      if (std::abs(plane.distance - (cosine < 0 ? -1 : 1) * truth.distance) > 0.1) continue;
      least = std::min(least, std::acos(std::min(std::abs(cosine), 1.0)) * 180 / pi);
    }
    worst = std::max(worst, least);
  }
  return worst;
}

/// "3 planes, 64.8 % near, 60.3 % labelled, 0.12° off"
std::string said(const Scene& scene, const PlanesOfScene& found, double share) {
  const Planes& planes = found.planes;
  char text[120];
  int used = std::snprintf(text, sizeof(text), "%zu plane%s, %.1f %% near", planes.size(),
                           planes.size() == 1 ? "" : "s", 100 * share);
  const auto add = [&](const char* format, double number) {
    used += std::snprintf(text + used, sizeof(text) - static_cast<std::size_t>(used), format, number);
  };
  add(", %.1f %% labelled",
      100 * static_cast<double>(found.labelled) / static_cast<double>(scene.cloud.size()));
  if (!scene.truth.empty()) add(", %.2f° off", degrees_off(scene, planes));
  return text;
}

Planes planes_of(const std::vector<FoundPlane>& found) {
  Planes planes;
  for (const FoundPlane& each : found) planes.push_back(each.fit.plane);
  return planes;
}

/// RANSAC to the first plane, of the frame as the camera gives it or of the cloud.
FindPlanes our_first_plane(const Scene& scene, bool from_cloud) {
  // A cloud says nothing about its sensor; of a frame's readings it is known how noisy they are.
  const RansacOptions options{.gate = {.fixed_m = from_cloud ? gate_m : 0}};
  auto first = std::make_shared<bench::FirstPlane>(scene.picture.size(), options, best_kernels());
  if (!first->prepared()) fail("RANSAC cannot be prepared");
  return [first, &scene, from_cloud] {
    const RansacPlanesResult result =
        from_cloud ? first->run(scene.cloud.view()) : first->run(scene.frame.depth());
    if (result.found.planes != 1) return PlanesOfScene();
    return PlanesOfScene{{first->plane()}, result.found.labelled};
  };
}

FindPlanes our_planes(const Scene& scene, PlaneMethod method) {
  PlaneDetectorOptions options;
  options.method = method;
  const Size size = scene.frame.raw.size();
  const double readings = static_cast<double>(scene.cloud.size()) / (1.0 * size.width * size.height);
  auto made = PlaneDetector::create(size, for_large_planes(options, size, least_share * readings));
  if (!made) fail(made.failure().sentence);
  auto detector = std::make_shared<PlaneDetector>(std::move(*made));
  auto found = std::make_shared<DetectedPlanes>();
  return [detector, found, &scene] {
    if (const auto done = detector->detect(scene.frame.depth(), *found); !done) fail(done.failure().sentence);
    return PlanesOfScene{planes_of(found->planes), found->found.labelled};
  };
}

/// A plane that is tilted into its neighbours covers some more, so a little less is no worse.
constexpr double same_plane = 0.94;
/// Jobs of different kinds: some count planes through the whole room, some connected surfaces. The table
/// shows both coverages.
constexpr double any_planes = 0;

struct Contest {
  std::string name;
  FindPlanes ours;
  double least_of_theirs;  ///< ours has to cover at least this share of what the peer's answer covers
  bool one_call_a_turn = false;
};

void print_plane_row(const Scene& scene, const Contest& contest, const PlanePeer& peer, int rounds,
                     Clock clock) {
  PlanesOfScene ours, theirs;
  double our_share = 0, their_share = 0;
  const FindPlanes find_theirs = peer.make(scene);
  print_row(
      {contest.name, scene.name, std::string(best_kernels().name), [&] { ours = contest.ours(); },
       [&] { theirs = find_theirs(); },
       [&] {
         our_share = coverage(scene, ours.planes);
         their_share = coverage(scene, theirs.planes);
         if (peer.same_job && ours.labelled < theirs.labelled) return false;
         return our_share >= contest.least_of_theirs * their_share;
       },
       peer.name, [&] { return said(scene, ours, our_share) + "; peer " + said(scene, theirs, their_share); },
       contest.one_call_a_turn},
      rounds, clock);
}

}  // namespace

void print_first_plane_rows(int rounds) {
  for (const Scene& scene : scenes()) {
    const FindPlanes from_frame = our_first_plane(scene, false);
    const Contest contests[] = {{"first plane, frame", from_frame, same_plane},
                                {"first plane, frame, caches cold", from_frame, same_plane, true},
                                {"first plane, cloud", our_first_plane(scene, true), same_plane}};
    for (const Contest& contest : contests) {
      for (const PlanePeer& peer : first_plane_peers())
        print_plane_row(scene, contest, peer, rounds, Clock::thread);
    }
  }
}

void print_all_planes_rows(int rounds) {
  for (const Scene& scene : scenes()) {
    const Contest ransac{"all planes, RANSAC", our_planes(scene, PlaneMethod::ransac), any_planes};
    const Contest hough{"all planes, Hough", our_planes(scene, PlaneMethod::hough), any_planes};
    for (const PlanePeer& peer : all_planes_peers())
      print_plane_row(scene, ransac, peer, rounds, Clock::thread);
    for (const PlanePeer& peer : all_planes_peers())
      print_plane_row(scene, hough, peer, rounds, Clock::thread);
  }
}

void print_threaded_plane_rows(int rounds) {
  for (const Scene& scene : scenes()) {
    const Contest contest{"first plane, cloud", our_first_plane(scene, true), same_plane};
    for (const PlanePeer& peer : threaded_plane_peers())
      print_plane_row(scene, contest, peer, rounds, Clock::wall);
  }
}

}  // namespace compare
