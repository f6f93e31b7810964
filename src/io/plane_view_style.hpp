// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

namespace straightedge::io {

/// The script reads --paper, --ink, --soft and --path, which must be of the form #rrggbb.
inline constexpr const char* plane_view_style = R"(
:root { color-scheme: light dark; --paper: #fbfbf9; --panel: #ffffff; --ink: #1d2125; --soft: #66707b;
  --rule: #dde1e5; --path: #c2410c; --mark: #e8f0fb; --accent: #0b5fc4; }
@media (prefers-color-scheme: dark) {
  :root { --paper: #15181b; --panel: #1d2125; --ink: #eceff2; --soft: #9aa4ae; --rule: #353b42; --path: #fb923c;
    --mark: #2b3644; --accent: #7db4f5; }
}
* { box-sizing: border-box; }
html, body { height: 100%; margin: 0; }
body { display: grid; grid-template: auto minmax(0, 1fr) / minmax(0, 1fr) 26.5rem; background: var(--panel);
  color: var(--ink); font: 14px/1.4 system-ui, -apple-system, 'Segoe UI', Roboto, 'Noto Sans', 'Liberation Sans', sans-serif; }
header { grid-column: 1 / -1; display: flex; flex-wrap: wrap; gap: 0 1.25rem; align-items: baseline; padding: .6rem 1rem;
  border-bottom: 1px solid var(--rule); }
h1 { margin: 0; font-size: 1.15rem; overflow-wrap: anywhere; }
header p { margin: 0; color: var(--soft); }
main { position: relative; min-width: 0; background: var(--paper); }
canvas { position: absolute; inset: 0; width: 100%; height: 100%; touch-action: none; cursor: grab; }
canvas:active { cursor: grabbing; }
canvas:focus-visible { outline: 2px solid var(--accent); outline-offset: -2px; }
.tools { position: absolute; top: .6rem; left: .6rem; right: .6rem; display: flex; flex-wrap: wrap; gap: .4rem .8rem;
  pointer-events: none; }
.tools div { display: flex; pointer-events: auto; border: 1px solid var(--rule); border-radius: 6px; overflow: hidden; }
.tools button { border: 0; border-right: 1px solid var(--rule); padding: .35rem .7rem; background: var(--panel); color: inherit;
  font: inherit; cursor: pointer; min-height: 2rem; }
.tools button:last-child { border-right: 0; }
.tools button[aria-pressed=true] { background: var(--mark); color: var(--accent); }
.tools button[aria-pressed=false] { color: var(--soft); }
.tools button[hidden] { display: none; }
button:hover { background: var(--mark); }
.help { position: absolute; right: .8rem; bottom: .5rem; margin: 0; color: var(--soft); font-size: 12px; pointer-events: none; }
aside { display: flex; flex-direction: column; min-height: 0; border-left: 1px solid var(--rule); }
#detail { min-height: 11.5rem; padding: .7rem 1rem; border-bottom: 1px solid var(--rule); }
#detail h2 { margin: 0 0 .35rem; font-size: 1rem; }
.hint { color: var(--soft); margin: 0; }
dl { display: grid; grid-template-columns: 5.5rem 1fr; margin: 0; gap: .05rem .5rem; }
dt { color: var(--soft); }
dd { margin: 0; overflow-wrap: anywhere; white-space: pre-wrap; }
dd, td { font-variant-numeric: tabular-nums; }
.list { overflow: auto; flex: 1; min-height: 0; }
table { border-collapse: collapse; width: 100%; font-size: 12.5px; }
th { position: sticky; top: 0; background: var(--panel); box-shadow: 0 1px 0 var(--rule); font-weight: 600; }
th, td { padding: .2rem .3rem; text-align: right; white-space: nowrap; }
th:first-child, td:first-child { padding-left: .9rem; }
th:last-child, td:last-child { padding-right: .9rem; }
td:nth-child(2), th:nth-child(2) { text-align: left; }
th button, td button { border: 0; padding: 0; background: none; color: inherit; font: inherit; cursor: pointer; }
tbody tr { border-bottom: 1px solid var(--rule); cursor: pointer; }
tr.hover, tr.selected { background: var(--mark); }
tr.selected td:first-child { box-shadow: inset 3px 0 0 var(--accent); }
input { margin: 0; vertical-align: -2px; }
.swatch { display: inline-block; width: .8em; height: .8em; margin-right: .4em; border-radius: 2px; }
footer { padding: .5rem 1rem; border-top: 1px solid var(--rule); color: var(--soft); font-size: 12px; overflow-wrap: anywhere; }
footer:empty { display: none; }
@media (max-width: 800px) {
  html, body { height: auto; }
  body { grid-template: auto min(68vh, 68svh) auto / minmax(0, 1fr); }
  aside { border-left: 0; border-top: 1px solid var(--rule); }
  #detail { min-height: 8rem; }
  .help { display: none; }
  .tools button { min-height: 2.4rem; }
}
)";

}  // namespace straightedge::io
