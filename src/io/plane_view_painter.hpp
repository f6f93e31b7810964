// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

namespace straightedge::io {

/// The part of the viewer's script that paints the canvas. It reads `state` and writes what is on the screen.
inline constexpr const char* plane_view_painter = R"js('use strict';
const Painter = (() => {
  const movingPoints = 12000;  // in one picture while it moves
  const rgbOf = hex => [1, 3, 5].map(i => parseInt(hex.slice(i, i + 2), 16));
  const blend = (a, b, share) => a.map((v, i) => Math.round(v + (b[i] - v) * share));
  const css = (rgb, alpha) => 'rgba(' + rgb.join(',') + ',' + alpha + ')';

  // data: as embedded; colours: of the page, by name; state: what the controls set.
  return function painter(data, canvas, colours, state) {
    const ctx = canvas.getContext('2d');
    const pieces = Geometry.load(data);
    const sides = Geometry.allSides(pieces);
    const up = data.up;
    const inScene = p => Geometry.upright(p.map((v, i) => v - data.origin[i]), up);
    const path = data.path.map(([at, forward, down]) => ({ at: inScene(at),
      forward: Geometry.upright(forward, up), down: Geometry.upright(down, up) }));
    const clouds = new Map(data.cloud.map(c => [c.plane, Geometry.ringFrom(c.xyz, data.step, up)]));
    const pointCount = data.cloud.reduce((sum, c) => sum + c.xyz.length / 3, 0);
    const planeColour = data.planes.map(plane => rgbOf(plane.colour));
    const lastPiece = new Map(pieces.map((piece, i) => [piece.plane, i]));
    for (const piece of pieces) piece.pixels = piece.rings.map(ring => new Float64Array(ring.length / 3 * 2));

    // Everything that a view has to show, as one ring.
    function extent() {
      const all = [];
      pieces.forEach(piece => { if (!state.hidden.has(piece.plane)) piece.corners.forEach(c => all.push(...c)); });
      if (all.length === 0) pieces.forEach(piece => piece.corners.forEach(c => all.push(...c)));
      if (pieces.length === 0) clouds.forEach(ring => all.push(...ring.subarray(0, 3000)));
      path.forEach(pose => all.push(...pose.at));
      return new Float64Array(all);
    }

    // Light comes over the left shoulder of one who looks from the front, and reaches every side a little.
    const light = Geometry.unit([-0.35, -0.55, 1]);
    function faceColour(piece, strong) {
      const bright = 0.62 + 0.38 * Math.abs(Geometry.dot(piece.normal, light));
      const base = blend(planeColour[piece.plane], colours.paper, strong ? 0 : colours.dark ? 0.2 : 0.32);
      return base.map(v => Math.round(v * bright));
    }

    function trace(rings) {
      ctx.beginPath();
      for (const ring of rings) {
        let x = ring[0], y = ring[1];
        ctx.moveTo(x, y);
        for (let i = 2; i < ring.length; i += 2) {
          if (Math.abs(ring[i] - x) + Math.abs(ring[i + 1] - y) < 0.8) continue;
          x = ring[i];
          y = ring[i + 1];
          ctx.lineTo(x, y);
        }
        ctx.closePath();
      }
    }

    function paintPiece(item) {
      const piece = pieces[item.piece];
      const chosen = piece.plane === state.hover || piece.plane === state.selected;
      const face = faceColour(piece, chosen);
      trace(piece.pixels);
      ctx.fillStyle = css(face, item.pale ? (chosen ? 0.3 : 0.05) : chosen ? 0.97 : state.opacity);
      ctx.fill('evenodd');
      ctx.strokeStyle = chosen ? css(colours.ink, 1) : css(blend(face, colours.ink, 0.45), item.pale ? 0.45 : 0.95);
      ctx.lineWidth = chosen ? 2.5 : item.pale ? 1 : 1.3;
      ctx.stroke();
    }

    function paintPoints(camera, plane, every, size) {
      const ring = clouds.get(plane);
      if (!ring) return;
      const p = [0, 0, 0];
      ctx.fillStyle = plane < 0 ? css(colours.soft, 0.8) : css(blend(planeColour[plane], colours.ink, 0.3), 0.9);
      for (let i = 0; i < ring.length; i += 3 * every) {
        p[0] = ring[i]; p[1] = ring[i + 1]; p[2] = ring[i + 2];
        const [x, y] = Geometry.project(camera, p);
        ctx.fillRect(x, y, size, size);
      }
    }

    // The nearest first claims its place.
    function claimIds(order, camera) {
      const taken = [], claims = new Map();
      for (const item of [...order].reverse()) {
        const piece = pieces[item.piece];
        const chosen = piece.plane === state.hover || piece.plane === state.selected;
        if (!chosen && (item.pale || !state.ids)) continue;
        const text = String(data.planes[piece.plane].id);
        const width = ctx.measureText(text).width, [x, y] = Geometry.project(camera, piece.at);
        const small = item.box[2] - item.box[0] < width || item.box[3] - item.box[1] < 10;
        const box = [x - width / 2 - 3, y - 8, x + width / 2 + 3, y + 8];
        const clash = taken.some(t => t[0] < box[2] && box[0] < t[2] && t[1] < box[3] && box[1] < t[3]);
        if (!chosen && (small || clash)) continue;
        taken.push(box);
        claims.set(item.piece, { text, x, y, chosen });
      }
      return claims;
    }

    function paintId(claim) {
      ctx.lineWidth = 3.5;
      ctx.strokeStyle = css(colours.paper, 0.85);
      ctx.strokeText(claim.text, claim.x, claim.y);
      ctx.fillStyle = css(colours.ink, 1);
      ctx.fillText(claim.text, claim.x, claim.y);
    }

    function segments(points, colour, width) {
      ctx.beginPath();
      points.forEach(([x, y], i) => (i === 0 ? ctx.moveTo(x, y) : ctx.lineTo(x, y)));
      ctx.strokeStyle = colour;
      ctx.lineWidth = width;
      ctx.stroke();
    }

    function paintPath(camera) {
      if (path.length === 0) return;
      const on = p => Geometry.project(camera, p);
      const colour = css(colours.path, 1);
      segments(path.map(pose => on(pose.at)), css(colours.paper, 0.8), 4);
      segments(path.map(pose => on(pose.at)), colour, 2);
      const every = Math.ceil(path.length / 40);
      const size = 0.03 * state.radius;
      for (let i = 0; i < path.length; i += every) {
        const { at, forward, down } = path[i];
        const right = Geometry.cross(down, forward), middle = Geometry.along(at, size, forward);
        const corner = (u, v) => on(Geometry.along(Geometry.along(middle, 0.6 * u * size, right), 0.45 * v * size, down));
        const corners = [corner(-1, -1), corner(1, -1), corner(1, 1), corner(-1, 1)];
        segments([...corners, corners[0]], colour, 1.1);
        corners.forEach(c => segments([on(at), c], colour, 0.9));
      }
      const [x, y] = on(path[0].at);
      ctx.beginPath();
      ctx.arc(x, y, 4, 0, 2 * Math.PI);
      ctx.fillStyle = colour;
      ctx.fill();
    }

    function paintAxes(camera) {
      const x0 = 46, y0 = camera.height - 46;
      const names = [['x', [1, 0, 0], '#d03a2f'], ['y', [0, 1, 0], '#2a9140'], ['z', [0, 0, 1], '#2f6fd6']]
        .map(([name, axis, colour]) => ({ name, colour, axis: Geometry.upright(axis, up) }))
        .sort((a, b) => Geometry.dot(a.axis, camera.toEye) - Geometry.dot(b.axis, camera.toEye));
      for (const { name, colour, axis } of names) {
        const x = x0 + 28 * Geometry.dot(axis, camera.right), y = y0 - 28 * Geometry.dot(axis, camera.up);
        segments([[x0, y0], [x, y]], colour, 2.2);
        ctx.fillStyle = colour;
        ctx.fillText(name, x0 + 1.33 * (x - x0), y0 + 1.33 * (y - y0));
      }
    }

    function paintScale(camera) {
      let metres = Math.pow(10, Math.floor(Math.log10(150 / camera.scale)));
      for (const factor of [5, 2]) {
        if (factor * metres * camera.scale <= 150) { metres *= factor; break; }
      }
      const x = 100, y = camera.height - 22, length = metres * camera.scale;
      segments([[x, y - 5], [x, y], [x + length, y], [x + length, y - 5]], css(colours.ink, 1), 1.5);
      const text = metres >= 1000 ? metres / 1000 + ' km' : metres >= 1 ? metres + ' m'
        : metres >= 0.01 ? Math.round(metres * 100) + ' cm' : Number((metres * 1000).toPrecision(1)) + ' mm';
      ctx.fillStyle = css(colours.ink, 1);
      ctx.fillText(text, x + length / 2, y - 11);
    }

    let shown = [];

    function paint(view, moving) {
      const ratio = window.devicePixelRatio || 1;
      const camera = Geometry.cameraOf(view);
      ctx.setTransform(ratio, 0, 0, ratio, 0, 0);
      ctx.clearRect(0, 0, view.width, view.height);
      ctx.lineJoin = ctx.lineCap = 'round';
      ctx.textAlign = 'center';
      ctx.textBaseline = 'middle';
      ctx.font = '600 12px system-ui, sans-serif';
      const items = [];
      pieces.forEach((piece, i) => {
        if (state.hidden.has(piece.plane)) return;
        piece.rings.forEach((ring, k) => Geometry.projectRing(camera, ring, piece.pixels[k]));
        const eye = Geometry.eyeSide(camera, piece.normal, piece.distance);
        items.push({ piece: i, eye, pale: state.inside && piece.front * eye < 0,
          depth: Geometry.project(camera, piece.at)[2], box: Geometry.boxOf(piece.pixels.slice(0, 1)) });
      });
      shown = Geometry.paintOrder(items, sides, pieces.length).map(i => items[i]);
      const every = moving ? Math.max(1, Math.ceil(pointCount / movingPoints)) : 1;
      const size = pointCount > 50000 ? 1 : 1.6;
      const claims = claimIds(shown, camera);
      if (state.points) paintPoints(camera, -1, every, size);
      for (const item of shown) {
        const plane = pieces[item.piece].plane;
        paintPiece(item);
        if (state.points && !item.pale && lastPiece.get(plane) === item.piece) paintPoints(camera, plane, every, size);
        if (claims.has(item.piece)) paintId(claims.get(item.piece));
      }
      if (state.path) paintPath(camera);
      paintAxes(camera);
      paintScale(camera);
    }

    // The plane at a place of the screen, -1: none. What is pale is only hit where nothing else is.
    function planeAt(x, y) {
      for (const pale of [false, true]) {
        for (let k = shown.length - 1; k >= 0; --k) {
          const { piece, box } = shown[k];
          if (shown[k].pale !== pale || x < box[0] || x > box[2] || y < box[1] || y > box[3]) continue;
          if (Geometry.within(x, y, pieces[piece].pixels)) return pieces[piece].plane;
        }
      }
      return -1;
    }

    return { paint, planeAt, extent, pointCount, pathLength: path.length };
  };
})();
)js";

}  // namespace straightedge::io
