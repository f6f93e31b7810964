// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

namespace straightedge::io {

// Neither text holds a character that XML escapes, so that both read the same in HTML and in XML.

inline constexpr const char* html_style = R"(
:root { color-scheme: light; --ink: #22262b; --soft: #5b6470; --rule: #d9dde2; --link: #0b5fc4; }
* { box-sizing: border-box; }
body { margin: 0 auto; max-width: 52rem; padding: 2rem 1.25rem 4rem; background: #fff; color: var(--ink);
  font: 1.0625rem/1.6 Charter, 'Bitstream Charter', 'Iowan Old Style', Georgia, 'DejaVu Serif', serif; }
h1, h2, th, dt, nav, figcaption, .facts, .sources, footer, button {
  font-family: system-ui, -apple-system, 'Segoe UI', Roboto, 'Noto Sans', 'Liberation Sans', sans-serif; }
h1 { font-size: 1.9rem; line-height: 1.2; margin: 0 0 1rem; overflow-wrap: anywhere; }
h2 { font-size: 1.3rem; line-height: 1.25; margin: 3.25rem 0 .6rem; padding-top: .9rem;
  border-top: 1px solid var(--rule); }
p { margin: .6rem 0; max-width: 42rem; }
a { color: var(--link); }
nav { margin: 1.5rem 0 0; font-size: .95rem; }
nav ol { margin: 0; padding-left: 1.6rem; columns: 17rem; }
nav li { margin: .15rem 0; break-inside: avoid; }
.figures { display: flex; flex-wrap: wrap; gap: 1rem; align-items: flex-start; margin: 1.1rem 0; }
figure { margin: 0; flex: 1 1 20rem; min-width: 0; max-width: 100%; }
figure.small { flex: 0 0 auto; }
figure a { display: block; line-height: 0; }
figure img { max-width: 100%; max-height: 85vh; height: auto; width: auto; border: 1px solid var(--rule);
  cursor: zoom-in; }
figcaption { margin-top: .35rem; font-size: .875rem; line-height: 1.4; color: var(--soft); }
table { border-collapse: collapse; margin: 1rem 0; font-size: .95rem; }
caption { text-align: left; font-size: .875rem; color: var(--soft); padding-bottom: .3rem; }
th, td { padding: .25rem .9rem .25rem 0; text-align: left; vertical-align: top;
  border-bottom: 1px solid var(--rule); }
th { font-weight: 600; font-size: .875rem; }
td { font-variant-numeric: tabular-nums; overflow-wrap: anywhere; }
.facts th { font-weight: 400; color: var(--soft); }
.numbers { min-width: min(100%, 26rem); }
.numbers td, .numbers th { text-align: right; padding: .25rem 0 .25rem 1.4rem; overflow-wrap: break-word; }
.numbers td:first-child, .numbers th:first-child { padding-left: 0; }
.sources { font-size: .875rem; color: var(--soft); }
code { font: .9em/1.4 ui-monospace, 'SF Mono', 'DejaVu Sans Mono', monospace; overflow-wrap: anywhere; }
footer { margin-top: 4rem; padding-top: .9rem; border-top: 1px solid var(--rule); font-size: .875rem;
  color: var(--soft); }
dialog { width: 96vw; height: 94vh; max-width: none; max-height: none; padding: 0; border: 0;
  background: #17191c; }
dialog::backdrop { background: rgba(0, 0, 0, .7); }
dialog .view { position: absolute; inset: 3rem 0 0 0; overflow: auto; }
dialog img { display: block; margin: 0 auto; max-width: none; image-rendering: pixelated; }
dialog .bar { position: absolute; inset: 0 0 auto 0; height: 3rem; padding: .5rem .75rem; color: #fff;
  font: .95rem system-ui, sans-serif; }
dialog button { font-size: 1rem; min-width: 2.5rem; height: 2rem; margin-right: .5rem; }
@media (max-width: 36rem) {
  body { padding: 1.25rem .9rem 3rem; font-size: 1rem; }
  h1 { font-size: 1.5rem; }
}
@media print {
  body { max-width: none; padding: 0; font-size: 10.5pt; }
  h2 { break-after: avoid; margin-top: 1.6rem; }
  figure, table, .sources { break-inside: avoid; }
  figure img { max-height: 9cm; }
  section p, .figures { break-after: avoid; }
  section p.sources { break-after: auto; }
  nav, dialog { display: none; }
}
)";

inline constexpr const char* html_script = R"(
(function () {
  var dialog = document.getElementById('viewer');
  if (!dialog.showModal) return;
  var picture = dialog.querySelector('img');
  var view = dialog.querySelector('.view');
  var text = dialog.querySelector('span');
  var factor = 1;
  function show(next, u, v) {
    factor = Math.min(32, Math.max(1, next));
    picture.style.width = picture.naturalWidth * factor + 'px';
    text.textContent = factor + ' x';
    view.scrollLeft = u * view.scrollWidth - view.clientWidth / 2;
    view.scrollTop = v * view.scrollHeight - view.clientHeight / 2;
  }
  function middle(next) {
    show(next, (view.scrollLeft + view.clientWidth / 2) / view.scrollWidth,
      (view.scrollTop + view.clientHeight / 2) / view.scrollHeight);
  }
  document.querySelectorAll('figure a').forEach(function (link) {
    link.addEventListener('click', function (event) {
      var box = link.querySelector('img').getBoundingClientRect();
      var u = event.clientX ? (event.clientX - box.left) / box.width : 0.5;
      var v = event.clientY ? (event.clientY - box.top) / box.height : 0.5;
      event.preventDefault();
      picture.onload = function () { show(4, u, v); };
      picture.src = link.getAttribute('href');
      picture.alt = link.querySelector('img').alt;
      dialog.showModal();
    });
  });
  picture.addEventListener('click', function (event) {
    var box = picture.getBoundingClientRect();
    show(factor * 2, (event.clientX - box.left) / box.width, (event.clientY - box.top) / box.height);
  });
  document.getElementById('larger').addEventListener('click', function () { middle(factor * 2); });
  document.getElementById('smaller').addEventListener('click', function () { middle(factor / 2); });
  document.getElementById('close').addEventListener('click', function () { dialog.close(); });
})();
)";

}  // namespace straightedge::io
