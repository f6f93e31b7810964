// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

namespace straightedge::io {

/// The part of the viewer's script that makes the list, moves the view, and listens to keys, buttons and the page's
/// address.
inline constexpr const char* plane_view_controls = R"js('use strict';
(() => {
  const byId = id => document.getElementById(id);
  const data = JSON.parse(byId('map').textContent);
  const canvas = byId('canvas');
  const switches = ['points', 'ids', 'path', 'inside', 'perspective'];
  const views = { iso: [data.turn, 30], top: [-90, 90], front: [-90, 0], side: [0, 0] };
  const state = { hidden: new Set(), hover: -1, selected: -1, opacity: 0.88, radius: 1 };
  const colours = {};
  const view = { turn: 0, tilt: 0, target: [0, 0, 0], scale: 100, distance: Infinity, width: 100, height: 100 };
  let untouched = true, movedAt = 0, waiting = 0, settle = 0;

  function readColours() {
    const style = getComputedStyle(document.documentElement);
    for (const name of ['paper', 'ink', 'soft', 'path']) {
      const hex = style.getPropertyValue('--' + name).trim();
      colours[name] = [1, 3, 5].map(i => parseInt(hex.slice(i, i + 2), 16));
    }
    colours.dark = colours.paper[0] < 128;
  }
  readColours();
  const painter = Painter(data, canvas, colours, state);

  // One picture for all that happens between two frames of the screen, and a last one with every point.
  function redraw(moving) {
    if (moving) {
      movedAt = performance.now();
      clearTimeout(settle);
      settle = setTimeout(() => redraw(false), 160);
    }
    if (waiting) return;
    waiting = requestAnimationFrame(() => {
      waiting = 0;
      painter.paint(view, performance.now() - movedAt < 150);
    });
  }

  function fit() {
    const extent = painter.extent();
    let squared = 0.01;
    const middle = [0, 1, 2].map(axis => {
      let low = Infinity, high = -Infinity;
      for (let i = axis; i < extent.length; i += 3) { low = Math.min(low, extent[i]); high = Math.max(high, extent[i]); }
      if (!(low <= high)) return 0;
      squared += (high - low) * (high - low) / 4;
      return (low + high) / 2;
    });
    state.radius = Math.sqrt(squared);
    view.target = middle;
    // Far enough that the eye is outside wherever the target is moved to.
    view.distance = state.perspective ? 4 * state.radius : Infinity;
    Object.assign(view, Geometry.fitted(view, extent, Math.min(46, view.width / 20)));
  }

  function look(name) {
    [view.turn, view.tilt] = views[name];
    untouched = true;
    fit();
    redraw(true);
  }

  function turn(right, up) {
    view.turn -= right;
    view.tilt = Math.max(-90, Math.min(90, view.tilt + up));
    redraw(true);
  }

  function move(x, y) {
    const camera = Geometry.cameraOf(view);
    view.target = Geometry.along(Geometry.along(view.target, -x / view.scale, camera.right), y / view.scale, camera.up);
    untouched = false;
    redraw(true);
  }

  function reset() {
    data.planes.forEach((plane, i) => show(i, true));
    select(-1, false);
    look('iso');
  }

  // What is under (x, y) stays there.
  function zoom(factor, x, y) {
    const scale = Math.max(1e-3, Math.min(1e6, view.scale * factor));
    const share = 1 - view.scale / scale;
    move((view.width / 2 - x) * share, (view.height / 2 - y) * share);
    view.scale = scale;
  }

  function set(name, on) {
    state[name] = on;
    byId(name).setAttribute('aria-pressed', on);
    if (name === 'perspective') fit();
    redraw(false);
  }

  function resize() {
    const box = canvas.getBoundingClientRect(), ratio = window.devicePixelRatio || 1;
    if (box.width < 2 || box.height < 2) return;
    canvas.width = Math.round(box.width * ratio);
    canvas.height = Math.round(box.height * ratio);
    view.width = box.width;
    view.height = box.height;
    if (untouched) fit();
    painter.paint(view, false);
  }

  // Numbers of a plane as text.
  const short = n => n === undefined ? '' : n >= 1e6 ? (n / 1e6).toFixed(1) + ' M'
    : n >= 1e4 ? Math.round(n / 1e3) + ' k' : String(n);
  const fixed = (v, digits) => v === null ? '?' : v.toFixed(digits).replace(/^-(0\.?0*)$/, '$1').replace('-', '\u2212');
  const sizeOf = plane => plane.pieces.length === 0 ? '' : fixed(plane.length, 2) + ' \u00d7 ' + fixed(plane.width, 2);

  function element(parent, name, text, kind) {
    const made = document.createElement(name);
    if (text !== undefined) made.textContent = text;
    if (kind) made.className = kind;
    parent.appendChild(made);
    return made;
  }

  function detail() {
    const shown = state.hover >= 0 ? state.hover : state.selected;
    const box = byId('detail');
    box.textContent = '';
    if (shown < 0) {
      element(box, 'p', 'Point at a plane, or tap it, to see its numbers.', 'hint');
      return;
    }
    const plane = data.planes[shown];
    const head = element(box, 'h2');
    element(head, 'i', '', 'swatch').style.background = plane.colour;
    head.append('Plane ' + plane.id);
    const facts = element(box, 'dl');
    const fact = (name, value) => {
      if (value === undefined || value === '') return;
      element(facts, 'dt', name);
      element(facts, 'dd', value);
    };
    fact('normal', plane.n.map(v => fixed(v, 4)).join('  '));
    fact('distance', fixed(plane.d, 4) + ' m');
    fact('size', plane.pieces.length === 0 ? 'without a border' : sizeOf(plane) + ' m, ' + fixed(plane.area, 2) + ' m\u00b2'
      + (plane.pieces.length > 1 ? ' in ' + plane.pieces.length + ' pieces' : ''));
    fact('points', plane.points === undefined ? '' : plane.points.toLocaleString('en'));
    fact('sightings', plane.frames === undefined ? '' : String(plane.frames));
    fact('seen from', plane.seen && (plane.seen === 'both' ? 'both sides' : 'its ' + plane.seen + ' side'));
    fact('source', plane.source);
  }

  const rows = [];
  function mark(name, plane) {
    if (state[name] === plane) return;
    if (state[name] >= 0) rows[state[name]].classList.remove(name);
    state[name] = plane;
    if (plane >= 0) rows[plane].classList.add(name);
    detail();
    redraw(false);
  }

  function select(plane, scroll) {
    mark('selected', plane);
    if (plane >= 0 && scroll) rows[plane].scrollIntoView({ block: 'nearest' });
  }

  function show(plane, on) {
    if (on) state.hidden.delete(plane); else state.hidden.add(plane);
    rows[plane].querySelector('input').checked = on;
    byId('all').checked = state.hidden.size === 0;
    redraw(false);
  }

  function makeRow(plane, index) {
    const row = element(byId('rows'), 'tr');
    const box = element(element(row, 'td'), 'input');
    box.type = 'checkbox';
    box.checked = true;
    box.setAttribute('aria-label', 'show plane ' + plane.id);
    box.addEventListener('change', () => show(index, box.checked));
    const id = element(row, 'td');
    element(id, 'i', '', 'swatch').style.background = plane.colour;
    element(id, 'button', String(plane.id)).addEventListener('click', () => select(index, false));
    element(row, 'td', plane.n.map(v => fixed(v, 2)).join(' '));
    element(row, 'td', sizeOf(plane));
    element(row, 'td', short(plane.points));
    element(row, 'td', short(plane.frames));
    row.addEventListener('pointerenter', () => mark('hover', index));
    row.addEventListener('pointerleave', () => mark('hover', -1));
    row.addEventListener('click', event => { if (event.target === row || event.target.tagName === 'TD') select(index, false); });
    rows.push(row);
  }

  // The heads of the list order it; once more, and it is the other way round.
  const keys = [null, p => p.id, p => Math.abs(p.n[2]), p => -p.area, p => -(p.points || 0), p => -(p.frames || 0)];
  let order = [1, 1];
  function sortBy(column) {
    order = [column, order[0] === column ? -order[1] : 1];
    const key = i => keys[column](data.planes[i]);
    const sorted = rows.map((row, i) => i).sort((a, b) => order[1] * (key(a) - key(b)) || a - b);
    byId('rows').append(...sorted.map(i => rows[i]));
  }

  listenToPointers(canvas, { turn, move, zoom,
    hover: (x, y) => mark('hover', x === null ? -1 : painter.planeAt(x, y)),
    tap: (x, y) => select(painter.planeAt(x, y), true) });

  const turns = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };
  const letters = { i: 'iso', t: 'top', f: 'front', s: 'side' };
  const toggles = { p: 'points', n: 'ids', c: 'path', w: 'inside', e: 'perspective' };
  document.addEventListener('keydown', event => {
    if (event.ctrlKey || event.metaKey || event.altKey || (event.target.tagName === 'INPUT' && event.key === ' ')) return;
    const arrow = event.target === canvas && turns[event.key];
    if (arrow && event.shiftKey) move(-30 * arrow[0], -30 * arrow[1]);
    else if (arrow) turn(5 * arrow[0], 5 * arrow[1]);
    else if (event.key === '+' || event.key === '=') zoom(1.2, view.width / 2, view.height / 2);
    else if (event.key === '-') zoom(1 / 1.2, view.width / 2, view.height / 2);
    else if (event.key === '0') reset();
    else if (event.key === 'Escape') select(-1, false);
    else if (letters[event.key]) look(letters[event.key]);
    else if (toggles[event.key] && !byId(toggles[event.key]).hidden) set(toggles[event.key], !state[toggles[event.key]]);
    else return;
    event.preventDefault();
  });

  function start() {
    const asked = new URLSearchParams(location.hash.slice(1));
    const number = (name, fallback) => asked.has(name) && isFinite(asked.get(name)) ? Number(asked.get(name)) : fallback;
    byId('points').hidden = painter.pointCount === 0;
    byId('path').hidden = painter.pathLength === 0;
    for (const name of switches) {
      state[name] = number(name, name === 'points' ? 0 : 1) !== 0 && !byId(name).hidden;
      byId(name).setAttribute('aria-pressed', state[name]);
    }
    [view.turn, view.tilt] = views[asked.get('view')] || views.iso;
    view.turn = number('turn', view.turn);
    view.tilt = Math.max(-90, Math.min(90, number('tilt', view.tilt)));
    untouched = true;
    resize();
    if (asked.has('zoom')) zoom(Math.max(number('zoom', 1), 1e-3), view.width / 2, view.height / 2);
    select(data.planes.findIndex(plane => plane.id === number('select', -1)), true);
  }

  data.planes.forEach(makeRow);
  detail();
  for (const name of Object.keys(views)) byId(name).addEventListener('click', () => look(name));
  byId('reset').addEventListener('click', reset);
  for (const name of switches) byId(name).addEventListener('click', () => set(name, !state[name]));
  byId('all').addEventListener('change', () => data.planes.forEach((plane, i) => show(i, byId('all').checked)));
  document.querySelectorAll('th button').forEach(head => head.addEventListener('click', () => sortBy(Number(head.value))));
  window.matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => { readColours(); redraw(false); });
  new ResizeObserver(resize).observe(canvas);
  window.addEventListener('hashchange', start);
  start();
})();
)js";

}  // namespace straightedge::io
