// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
// What the viewer's geometry has to do, asked of the room of room_plane_map.hpp.
// node plane_view_checks.js GEOMETRY.js MAP.json
'use strict';
const assert = require('assert');
const Geometry = require(require('path').resolve(process.argv[2]));
const data = JSON.parse(require('fs').readFileSync(process.argv[3], 'utf8'));
const { dot, along } = Geometry;
const near = (a, b, margin) => assert.ok(Math.abs(a - b) <= margin, a + ' is not ' + b);

// A small generator of its own, so that a failure comes again.
let seed = 12345;
const random = () => (seed = (seed * 1103515245 + 12345) % 2147483648) / 2147483648;

const pieces = Geometry.load(data);
assert.strictEqual(pieces.length, 23);
const inScene = p => Geometry.upright(p.map((v, i) => v - data.origin[i]), data.up);

// Vertices lie on the planes of their pieces.
for (const piece of pieces) {
  for (const corner of piece.corners) near(dot(piece.normal, corner), piece.distance, 2e-3);
}

// Parallel views: known places on the screen.
const flat = { turn: -90, tilt: 90, target: [0, 0, 0], scale: 100, distance: Infinity, width: 800, height: 600 };
const top = Geometry.project(Geometry.cameraOf(flat), [1, 2, 3]);
near(top[0], 500, 1e-9);
near(top[1], 100, 1e-9);
near(top[2], 3, 1e-9);
const front = Geometry.project(Geometry.cameraOf({ ...flat, tilt: 0 }), [1, 2, 3]);
near(front[0], 500, 1e-9);
near(front[1], 0, 1e-9);
near(front[2], -2, 1e-9);
const side = Geometry.project(Geometry.cameraOf({ ...flat, turn: 0, tilt: 0 }), [1, 2, 3]);
near(side[0], 600, 1e-9);

// Perspective: what is nearer is larger; a ring is projected as its points are.
const deep = Geometry.cameraOf({ ...flat, tilt: 20, distance: 10 });
assert.ok(Geometry.project(deep, [1, -3, 0])[0] > Geometry.project(deep, [1, 3, 0])[0]);
const pixels = Geometry.projectRing(deep, new Float64Array([1, -3, 0.5]), new Float64Array(2));
const point = Geometry.project(deep, [1, -3, 0.5]);
near(pixels[0], point[0], 1e-9);
near(pixels[1], point[1], 1e-9);

// A fitted view shows everything, and fills one direction.
for (const distance of [Infinity, 20]) {
  const ring = new Float64Array([].concat(...pieces.flatMap(piece => piece.corners)));
  const view = Geometry.fitted({ ...flat, turn: 25, tilt: 35, distance }, ring, 40);
  const box = Geometry.boxOf([Geometry.projectRing(Geometry.cameraOf(view), ring, new Float64Array(ring.length / 3 * 2))]);
  for (const [low, high, size] of [[box[0], box[2], 800], [box[1], box[3], 600]]) {
    assert.ok(low > 39 && high < size - 39, 'fit');
  }
  near(Math.max((box[2] - box[0]) / 720, (box[3] - box[1]) / 520), 1, 0.01);
}

// A ray of sight meets the pieces in the order in which they are painted, in both kinds of views.
const sides = Geometry.allSides(pieces);
const on = new Float64Array(2);
let compared = 0;
for (let round = 0; round < 120; ++round) {
  const distance = round % 2 ? Infinity : 9 + 20 * random();
  const middle = inScene([2.6, 2, 1.3]);
  const camera = Geometry.cameraOf({ turn: 360 * random(), tilt: 180 * random() - 90, target: middle, scale: 100,
    distance, width: 800, height: 600 });
  const items = pieces.map((piece, i) => {
    piece.pixels = piece.rings.map(ring => Geometry.projectRing(camera, ring, new Float64Array(ring.length / 3 * 2)));
    return { piece: i, eye: Geometry.eyeSide(camera, piece.normal, piece.distance),
      depth: Geometry.project(camera, piece.at)[2], box: Geometry.boxOf(piece.pixels) };
  });
  const order = Geometry.paintOrder(items, sides, pieces.length);
  assert.deepStrictEqual([...order].sort((a, b) => a - b), pieces.map((piece, i) => i));
  const rank = [];
  order.forEach((i, at) => { rank[i] = at; });
  for (let ray = 0; ray < 60; ++ray) {
    const through = inScene([5.2 * random(), 4.1 * random(), 2.6 * random()]);
    const eye = along(camera.target, camera.distance, camera.toEye);
    const way = distance === Infinity ? camera.toEye : Geometry.unit(along(eye, -1, through));
    const [x, y] = Geometry.projectRing(camera, new Float64Array(through), on);
    const met = [];
    pieces.forEach((piece, i) => {
      const slope = dot(piece.normal, way);
      if (Math.abs(slope) < 1e-2 || !Geometry.within(x, y, piece.pixels)) return;
      met.push({ i, t: (piece.distance - dot(piece.normal, through)) / slope });
    });
    met.sort((a, b) => a.t - b.t);
    for (let k = 1; k < met.length; ++k) {
      if (met[k].t - met[k - 1].t < 5e-3) continue;
      assert.ok(rank[met[k - 1].i] < rank[met[k].i], 'round ' + round + ': piece ' + met[k].i + ' before ' + met[k - 1].i);
      ++compared;
    }
  }
}
assert.ok(compared > 4000, String(compared));

// Holes are not hit.
const square = [0, 0, 9, 0, 9, 9, 0, 9], hole = [3, 3, 6, 3, 6, 6, 3, 6];
assert.ok(Geometry.within(1, 1, [square, hole]));
assert.ok(!Geometry.within(4, 4, [square, hole]));
assert.ok(!Geometry.within(10, 4, [square, hole]));

// What sticks out a little counts for the side of the rest.
assert.strictEqual(Geometry.sideOf([[0, 0, 0], [0, 0, 3]], [0, 0, 1], 0), 2);
assert.strictEqual(Geometry.sideOf([[0, 0, -0.02], [0, 0, 3]], [0, 0, 1], 0), 1);
assert.strictEqual(Geometry.sideOf([[0, 0, -3], [0, 0, 0.02]], [0, 0, 1], 0), -1);
assert.strictEqual(Geometry.sideOf([[0, 0, -3], [0, 0, 3]], [0, 0, 1], 0), 0);
