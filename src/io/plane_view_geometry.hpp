// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

namespace straightedge::io {

/// The half of the viewer's script that needs no page: projection, order of painting, hits. Lengths are metres from
/// the origin of the data; the scene has x right, y back, z up.
inline constexpr const char* plane_view_geometry = R"js('use strict';
const Geometry = (() => {
  const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  const along = (p, t, v) => [p[0] + t * v[0], p[1] + t * v[1], p[2] + t * v[2]];
  const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
  const unit = a => along([0, 0, 0], 1 / Math.hypot(a[0], a[1], a[2]), a);

  const upright = (v, up) =>
    up === 'y' ? [v[0], -v[2], v[1]] : up === '-y' ? [v[0], v[2], -v[1]] : [v[0], v[1], v[2]];

  // Coordinates in a row, from steps of the data to metres of the scene.
  function ringFrom(steps, step, up) {
    const ring = new Float64Array(steps.length);
    for (let i = 0; i < steps.length; i += 3) {
      ring.set(upright([step * steps[i], step * steps[i + 1], step * steps[i + 2]], up), i);
    }
    return ring;
  }

  // Vertices that are farthest in 16 directions on the plane: they stand for the whole border.
  function extremes(ring, normal) {
    const u = unit(Math.abs(normal[2]) < 0.9 ? cross([0, 0, 1], normal) : cross([0, 1, 0], normal));
    const v = cross(normal, u);
    const found = new Set();
    for (let k = 0; k < 16; ++k) {
      const a = k * Math.PI / 8;
      const way = along(along([0, 0, 0], Math.cos(a), u), Math.sin(a), v);
      let best = 0, most = -Infinity;
      for (let i = 0; i < ring.length; i += 3) {
        const reach = ring[i] * way[0] + ring[i + 1] * way[1] + ring[i + 2] * way[2];
        if (reach > most) { most = reach; best = i; }
      }
      found.add(best);
    }
    return [...found].map(i => [ring[i], ring[i + 1], ring[i + 2]]);
  }

  function load(data) {
    const pieces = [];
    data.planes.forEach((plane, index) => {
      const normal = upright(plane.n, data.up);
      const distance = plane.d - dot(plane.n, data.origin);
      for (const piece of plane.pieces) {
        const rings = piece.rings.map(ring => ringFrom(ring, data.step, data.up));
        const at = Array.from(ringFrom(piece.at, data.step, data.up));
        pieces.push({ plane: index, normal, distance, front: plane.front, rings, at,
          corners: extremes(rings[0], normal) });
      }
    });
    return pieces;
  }

  // On which side of a plane the corners lie: 2 that of the normal, -2 the other one, 0 both; 1 and -1 when only
  // a little sticks out, as at a noisy corner of a room.
  function sideOf(corners, normal, distance) {
    let low = Infinity, high = -Infinity;
    for (const corner of corners) {
      const s = dot(normal, corner) - distance;
      low = Math.min(low, s);
      high = Math.max(high, s);
    }
    if (low >= 0 && high > 0) return 2;
    if (high <= 0 && low < 0) return -2;
    const slack = Math.max(0.03, 0.04 * (high - low));
    if (-low <= slack && high > slack) return 1;
    if (high <= slack && -low > slack) return -1;
    return 0;
  }

  // sides[i * n + j]: where piece i lies of the plane of piece j. It does not depend on the view.
  function allSides(pieces) {
    const n = pieces.length;
    const sides = new Int8Array(n * n);
    for (let i = 0; i < n; ++i) {
      for (let j = 0; j < n; ++j) {
        if (pieces[i].plane === pieces[j].plane) continue;
        sides[i * n + j] = sideOf(pieces[i].corners, pieces[j].normal, pieces[j].distance);
      }
    }
    return sides;
  }

  // view: turn and tilt of the eye in degrees (turn -90: from the front), target, scale in pixels a metre,
  // distance of the eye from the target (Infinity: parallel), width and height of the picture.
  function cameraOf(view) {
    const a = view.turn * Math.PI / 180, b = view.tilt * Math.PI / 180;
    const toEye = [Math.cos(b) * Math.cos(a), Math.cos(b) * Math.sin(a), Math.sin(b)];
    const right = [-Math.sin(a), Math.cos(a), 0];
    return { ...view, toEye, right, up: cross(toEye, right) };
  }

  // Pixels, and how far towards the eye from the target.
  function project(camera, p) {
    const from = along(p, -1, camera.target);
    const depth = dot(from, camera.toEye);
    const k = camera.distance === Infinity ? camera.scale
      : camera.scale * camera.distance / Math.max(camera.distance - depth, 1e-3 * camera.distance);
    return [camera.width / 2 + k * dot(from, camera.right), camera.height / 2 - k * dot(from, camera.up), depth];
  }

  function projectRing(camera, ring, pixels) {
    const [tx, ty, tz] = camera.target, [ex, ey, ez] = camera.toEye;
    const [rx, ry, rz] = camera.right, [ux, uy, uz] = camera.up;
    const far = camera.distance === Infinity ? 0 : 1 / camera.distance;
    for (let i = 0, k = 0; i < ring.length; i += 3, k += 2) {
      const x = ring[i] - tx, y = ring[i + 1] - ty, z = ring[i + 2] - tz;
      const s = camera.scale / Math.max(1 - far * (x * ex + y * ey + z * ez), 1e-3);
      pixels[k] = camera.width / 2 + s * (x * rx + y * ry + z * rz);
      pixels[k + 1] = camera.height / 2 - s * (x * ux + y * uy + z * uz);
    }
    return pixels;
  }

  // 1: the eye is on the side of the normal; 0: the plane is seen from its edge.
  function eyeSide(camera, normal, distance) {
    const s = camera.distance === Infinity ? dot(normal, camera.toEye)
      : (dot(normal, along(camera.target, camera.distance, camera.toEye)) - distance) / camera.distance;
    return s > 1e-9 ? 1 : s < -1e-9 ? -1 : 0;
  }

  const apart = (a, b) => a[2] <= b[0] || b[2] <= a[0] || a[3] <= b[1] || b[3] <= a[1];

  // The order from back to front. Piece i hides behind piece j when i lies beyond the plane of j or j lies on this
  // side of the plane of i. items: piece index, eye (eyeSide), depth, box on the screen; of the pieces that nothing
  // waiting lies behind, the farthest is next, and where pieces hide one another in a circle the farthest of all.
  function paintOrder(items, sides, n) {
    const m = items.length;
    const behind = new Uint8Array(m * m), waits = new Int32Array(m);
    // How surely a hides behind b: 0 not at all, 2 with nothing sticking out.
    const hides = (a, b) =>
      Math.max(-sides[a.piece * n + b.piece] * b.eye, sides[b.piece * n + a.piece] * a.eye, 0);
    for (let i = 0; i < m; ++i) {
      for (let j = i + 1; j < m; ++j) {
        if (apart(items[i].box, items[j].box)) continue;
        const ij = hides(items[i], items[j]), ji = hides(items[j], items[i]);
        if (ij > ji) { behind[i * m + j] = 1; ++waits[j]; }
        if (ji > ij) { behind[j * m + i] = 1; ++waits[i]; }
      }
    }
    const byDepth = items.map((item, i) => i).sort((a, b) => items[a].depth - items[b].depth || a - b);
    const order = [];
    while (byDepth.length > 0) {
      const at = Math.max(byDepth.findIndex(i => waits[i] === 0), 0);
      const [next] = byDepth.splice(at, 1);
      order.push(next);
      for (const j of byDepth) waits[j] -= behind[next * m + j];
    }
    return order;
  }

  // Whether (x, y) is within the borders, by crossings; borders are x y in a row.
  function within(x, y, rings) {
    let odd = false;
    for (const r of rings) {
      for (let i = 0, j = r.length - 2; i < r.length; j = i, i += 2) {
        if ((r[i + 1] > y) === (r[j + 1] > y)) continue;
        if (x < r[j] + (y - r[j + 1]) / (r[i + 1] - r[j + 1]) * (r[i] - r[j])) odd = !odd;
      }
    }
    return odd;
  }

  // The view that shows all points, which are given as a ring; turn, tilt and distance stay.
  function fitted(view, ring, margin) {
    let result = { ...view };
    const pixels = new Float64Array(ring.length / 3 * 2);
    for (let round = 0; round < 5 && ring.length > 0; ++round) {
      const camera = cameraOf(result);
      projectRing(camera, ring, pixels);
      const box = boxOf([pixels]);
      const share = Math.max((box[2] - box[0]) / Math.max(view.width - 2 * margin, 40),
        (box[3] - box[1]) / Math.max(view.height - 2 * margin, 40), 0.1 * result.scale / view.width);
      const x = ((box[0] + box[2]) / 2 - view.width / 2) / result.scale;
      const y = (view.height / 2 - (box[1] + box[3]) / 2) / result.scale;
      result = { ...result, scale: result.scale / share,
        target: along(along(result.target, x, camera.right), y, camera.up) };
    }
    return result;
  }

  function boxOf(rings) {
    const box = [Infinity, Infinity, -Infinity, -Infinity];
    for (const r of rings) {
      for (let i = 0; i < r.length; i += 2) {
        if (r[i] < box[0]) box[0] = r[i];
        if (r[i] > box[2]) box[2] = r[i];
        if (r[i + 1] < box[1]) box[1] = r[i + 1];
        if (r[i + 1] > box[3]) box[3] = r[i + 1];
      }
    }
    return box;
  }

  return { dot, along, cross, unit, upright, ringFrom, load, sideOf, allSides, cameraOf, project, projectRing, eyeSide,
    paintOrder, within, fitted, boxOf };
})();
)js";

}  // namespace straightedge::io
