// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include "hash.hpp"
#include "straightedge/canny.hpp"
#include "straightedge/edge_position.hpp"
#include "straightedge/found_planes.hpp"
#include "straightedge/frame_planes_search.hpp"
#include "straightedge/hough_lines.hpp"
#include "straightedge/hough_plane_patch.hpp"
#include "straightedge/hough_plane_peaks.hpp"
#include "straightedge/inverse_depth.hpp"
#include "straightedge/octree.hpp"
#include "straightedge/plane_fit.hpp"
#include "straightedge/ransac_search.hpp"
#include "straightedge/segment_refit.hpp"

/// Every member of what the core's functions give back.
namespace same_bits {

inline void add_to(Hash& hash, const straightedge::Vector3& v) noexcept {
  hash.add(v.x, v.y, v.z);
}
inline void add_to(Hash& hash, const straightedge::Plane& p) noexcept {
  hash.add(p.normal, p.distance);
}

// Edges and lines.

inline void add_to(Hash& hash, const straightedge::CannyResult& r) noexcept {
  hash.add(r.status, r.low, r.high, r.strong, r.edges);
}
inline void add_to(Hash& hash, const straightedge::HoughPeak& p) noexcept {
  hash.add(p.rho, p.theta, p.votes);
}
inline void add_to(Hash& hash, const straightedge::HoughSegment& s) noexcept {
  hash.add(s.x0, s.y0, s.x1, s.y1, s.votes, s.pixels);
}
inline void add_to(Hash& hash, const straightedge::HoughResult& r) noexcept {
  hash.add(r.status, r.peaks, r.segments, r.edge_pixels, r.draws, r.seed, r.confident);
}
inline void add_to(Hash& hash, const straightedge::EdgePosition& p) noexcept {
  hash.add(p.x, p.y, p.variance);
}
inline void add_to(Hash& hash, const straightedge::LineMoments& m) noexcept {
  hash.add(m.weight, m.x, m.y, m.xx, m.xy, m.yy, m.count);
}
inline void add_to(Hash& hash, const straightedge::LineFit& f) noexcept {
  hash.add(f.theta, f.normal_x, f.normal_y, f.centroid_x, f.centroid_y, f.var_theta, f.var_offset,
           f.residual);
}
inline void add_to(Hash& hash, const straightedge::RefinedSegment& s) noexcept {
  hash.add(s.moments, s.origin_x, s.origin_y, s.fit, s.light_x, s.light_y, s.begin, s.end, s.pixels);
}

// Planes.

inline void add_to(Hash& hash, const straightedge::PlaneMoments& m) noexcept {
  hash.add(m.weight, m.x, m.y, m.z, m.xx, m.xy, m.xz, m.yy, m.yz, m.zz, m.count);
}
inline void add_to(Hash& hash, const straightedge::PlaneFit& f) noexcept {
  hash.add(f.plane, f.tangent_u, f.tangent_v, f.centroid, f.covariance, f.weight, f.count, f.rms);
}
inline void add_to(Hash& hash, const straightedge::InverseDepthPlane& p) noexcept {
  hash.add(p.a, p.b, p.c);
}
inline void add_to(Hash& hash, const straightedge::InverseDepthMoments& m) noexcept {
  hash.add(m.n, m.u, m.v, m.uu, m.uv, m.vv, m.q, m.uq, m.vq, m.qq);
}
inline void add_to(Hash& hash, const straightedge::InverseDepthFit& f) noexcept {
  hash.add(f.plane, f.covariance, f.mean_u, f.mean_v, f.n, f.rms);
}
inline void add_to(Hash& hash, const straightedge::FoundPlane& p) noexcept {
  hash.add(p.fit, p.inliers, p.iterations, p.confidence, p.score);
}
inline void add_to(Hash& hash, const straightedge::PlanesFound& f) noexcept {
  hash.add(f.planes, f.readings, f.labelled, f.iterations, f.seed);
}
inline void add_to(Hash& hash, const straightedge::HoughPlanePeak& p) noexcept {
  hash.add(p.direction, p.distance, p.votes);
}
inline void add_to(Hash& hash, const straightedge::DepthCell& c) noexcept {
  hash.add(c.n, c.u, c.v, c.q, c.uu, c.uv, c.vv, c.uq, c.vq, c.qq);
}
inline void add_to(Hash& hash, const straightedge::HoughPatch& p) noexcept {
  hash.add(p.x, p.y, p.side, p.candidate, p.votes, p.cell, p.plane, p.mean_u, p.mean_v, p.mean_q);
  hash.add(p.gate, p.noise, p.slope_covariance, p.space, p.point, p.tangent_u, p.tangent_v, p.precision,
           p.reach_rad);
}
inline void add_to(Hash& hash, const straightedge::HoughPatchResult& r) noexcept {
  hash.add(r.status, r.candidates, r.readings, r.patches, r.votes);
}
inline void add_to(Hash& hash, const straightedge::ProposedPlane& p) noexcept {
  hash.add(p.fit, p.score, p.confidence, p.iterations, p.readings, p.patches, p.rough);
  hash.add(p.column0, p.row0, p.column1, p.row1);
}
inline void add_to(Hash& hash, const straightedge::RansacSearchResult& r) noexcept {
  hash.add(r.status, r.candidates, r.readings, r.explained, r.noise, r.windows, r.draws, r.seed);
}

// The octree.

inline void add_to(Hash& hash, const straightedge::OctreeBuildResult& r) noexcept {
  hash.add(r.status, r.points, r.left_out, r.leaves);
}
inline void add_to(Hash& hash, const straightedge::OctreeFound& f) noexcept {
  hash.add(f.status, f.found, f.written);
}
inline void add_to(Hash& hash, const straightedge::OctreeNeighbour& n) noexcept {
  hash.add(n.index, n.squared_distance);
}
inline void add_to(Hash& hash, const straightedge::OctreeCrossing& c) noexcept {
  hash.add(c.leaf, c.enter_m, c.exit_m);
}
inline void add_to(Hash& hash, const straightedge::OctreePoint& p) noexcept {
  hash.add(p.x, p.y, p.z, p.index);
}

}  // namespace same_bits
