// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

namespace straightedge::io {

/// The part of the viewer's script that makes turns, moves and magnifying of what mouse, pen and fingers do.
inline constexpr const char* plane_view_pointers = R"js('use strict';
// actions: turn(dx, dy), move(dx, dy), zoom(factor, x, y), hover(x, y) or hover(null), tap(x, y).
function listenToPointers(canvas, actions) {
  const pointers = new Map();
  let pressed = null;
  const place = event => {
    const box = canvas.getBoundingClientRect();
    return [event.clientX - box.left, event.clientY - box.top];
  };

  canvas.addEventListener('pointerdown', event => {
    canvas.setPointerCapture(event.pointerId);
    pointers.set(event.pointerId, place(event));
    pressed = pointers.size === 1 ? place(event) : null;
  });

  canvas.addEventListener('pointermove', event => {
    const [x, y] = place(event), before = pointers.get(event.pointerId);
    if (!before) {
      if (event.pointerType === 'mouse') actions.hover(x, y);
      return;
    }
    // A tap is no drag, though the finger trembles.
    if (pressed && Math.hypot(x - pressed[0], y - pressed[1]) < 5) return;
    pressed = null;
    const dx = x - before[0], dy = y - before[1];
    if (pointers.size === 2) {
      const [other] = [...pointers].filter(([id]) => id !== event.pointerId).map(([, at]) => at);
      const span = at => Math.max(Math.hypot(at[0] - other[0], at[1] - other[1]), 1);
      actions.move(dx / 2, dy / 2);
      actions.zoom(span([x, y]) / span(before), (x + other[0]) / 2, (y + other[1]) / 2);
    } else if (event.shiftKey || (event.buttons & 6) !== 0) {
      actions.move(dx, dy);
    } else {
      actions.turn(0.4 * dx, 0.4 * dy);
    }
    pointers.set(event.pointerId, [x, y]);
  });

  const released = event => {
    if (pressed && event.type === 'pointerup') actions.tap(...pressed);
    pointers.delete(event.pointerId);
    pressed = null;
  };
  canvas.addEventListener('pointerup', released);
  canvas.addEventListener('pointercancel', released);
  canvas.addEventListener('pointerleave', () => actions.hover(null));
  canvas.addEventListener('contextmenu', event => event.preventDefault());

  canvas.addEventListener('wheel', event => {
    event.preventDefault();
    const pixels = event.deltaY * (event.deltaMode === 1 ? 30 : event.deltaMode === 2 ? 400 : 1);
    actions.zoom(Math.pow(1.0015, -Math.max(-400, Math.min(400, pixels))), ...place(event));
  }, { passive: false });
}
)js";

}  // namespace straightedge::io
