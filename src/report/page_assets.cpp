#include "report/page_assets.h"

namespace ink::report {

std::string_view page_style() {
    return R"css(
:root { --ink: #20242a; --soft: #5b6470; --line: #e2e4e8; --wash: #f6f6f3; --blue: #0072b2;
  --vermilion: #d55e00; }
* { box-sizing: border-box; }
html { scroll-behavior: smooth; -webkit-text-size-adjust: 100%; }
body { margin: 0; color: var(--ink); background: #fff; line-height: 1.55; font-size: 16px;
  font-family: system-ui, -apple-system, "Segoe UI", Roboto, "Noto Sans", "DejaVu Sans", sans-serif; }
.wrap { max-width: 1240px; margin: 0 auto; padding: 0 28px; }
header { background: var(--wash); border-bottom: 1px solid var(--line); padding: 34px 0 30px; }
.brand { display: flex; align-items: center; gap: 12px; color: var(--soft); font-size: 15px; }
.brand strong { color: var(--ink); }
.brand svg { width: 34px; height: 34px; }
h1 { font-size: clamp(1.7rem, 3.4vw, 2.5rem); line-height: 1.15; letter-spacing: -.018em;
  margin: 20px 0 12px; font-weight: 700; overflow-wrap: anywhere; }
h2 { font-size: 1.42rem; letter-spacing: -.01em; margin: 0 0 6px; line-height: 1.25; }
h3 { font-size: 1.05rem; margin: 0; overflow-wrap: anywhere; }
p { margin: 0 0 12px; max-width: 74ch; }
.lead { font-size: 1.12rem; max-width: 68ch; overflow-wrap: anywhere; }
.soft, figcaption, .note { color: var(--soft); }
.note { font-size: .92rem; }
a { color: var(--blue); text-underline-offset: 2px; }
code { font: .9em/1.4 ui-monospace, "SF Mono", Menlo, Consolas, "DejaVu Sans Mono", monospace;
  overflow-wrap: anywhere; }
main section { padding: 40px 0 6px; }
.facts { display: flex; flex-wrap: wrap; gap: 8px 44px; margin: 22px 0 0; }
.facts div { min-width: 96px; }
.facts dt { color: var(--soft); font-size: .85rem; }
.facts dd { margin: 0; font-size: 1.55rem; font-weight: 650; letter-spacing: -.01em;
  font-variant-numeric: tabular-nums; }
.facts small { font-size: .9rem; font-weight: 400; color: var(--soft); }
nav { position: sticky; top: 0; z-index: 5; background: #fffffff2; border-bottom: 1px solid var(--line); }
nav .wrap { display: flex; gap: 4px 22px; overflow-x: auto; padding-top: 9px; padding-bottom: 9px;
  white-space: nowrap; font-size: .93rem; }
nav a { color: var(--soft); text-decoration: none; }
nav a:hover { color: var(--ink); text-decoration: underline; }
section[id], article[id] { scroll-margin-top: 44px; }
.warning { border-left: 4px solid var(--vermilion); background: #fdf3ec; padding: 12px 16px;
  margin: 24px 0 0; overflow-wrap: anywhere; }
.warning ul { margin: 4px 0 0; padding-left: 20px; }
.scroll { overflow-x: auto; margin: 14px 0 12px; }
.chart svg { display: block; width: 100%; height: auto; min-width: 820px; }
table { border-collapse: collapse; font-size: .9rem; font-variant-numeric: tabular-nums; }
th, td { padding: 6px 9px; text-align: right; white-space: nowrap; }
th { font-weight: 600; }
thead th, thead td { color: var(--soft); font-weight: 500; vertical-align: bottom;
  border-bottom: 1px solid #b9bfc8; }
thead tr.groups > * { border-bottom: 1px solid var(--line); text-align: center; font-size: .85rem;
  padding-bottom: 3px; }
tbody td, tbody th { border-bottom: 1px solid var(--line); }
th:first-child, td.name { text-align: left; }
tbody th { position: sticky; left: 0; background: #fff; }
tr.best th, tr.best td { background: #eef6fb; }
tr.baseline th, tr.baseline td { color: var(--soft); font-weight: 400; }
tr.first-baseline th, tr.first-baseline td { border-top: 1px solid #b9bfc8; }
.verdict { font-size: .86rem; }
.verdict th, .verdict td { padding: 6px 5.5px; }
.group { border-left: 1px solid var(--line); }
td b { font-weight: 700; }
.range { color: var(--soft); font-size: .85em; }
.wide.fronts td.text { max-width: 620px; min-width: 0; white-space: normal; }
.leads td { min-width: 96px; }
.many thead th:not(:first-child) { writing-mode: vertical-rl; transform: rotate(180deg);
  text-align: left; padding: 5px 3px; }
.leads.many { font-size: .78rem; line-height: 1.25; }
.leads.many td { min-width: 0; padding: 4px 3px; vertical-align: top; }
.leads.many .range { display: block; white-space: normal; width: min-content; margin-left: auto; }
.terms { display: grid; grid-template-columns: repeat(auto-fill, minmax(300px, 1fr)); gap: 3px 26px;
  margin: 4px 0 12px; font-size: .88rem; color: var(--soft); }
.terms dt { display: inline; font-weight: 600; color: var(--ink); }
.terms dd { display: inline; margin: 0 0 0 .5em; }
.heat td { min-width: 74px; text-align: center; }
.heat.many { font-size: .82rem; }
.heat.many td { min-width: 0; padding: 5px 4px; }
.heat th[scope=row] { max-width: 340px; overflow: hidden; text-overflow: ellipsis; }
.tag { display: inline-block; font-size: .78rem; color: var(--soft); border: 1px solid var(--line);
  border-radius: 9px; padding: 0 8px; font-weight: 400; }
.legend { display: flex; flex-wrap: wrap; gap: 4px 20px; padding: 0; margin: 10px 0 4px;
  list-style: none; font-size: .92rem; }
.legend i { display: inline-block; width: 13px; height: 13px; border-radius: 3px; margin-right: 7px;
  vertical-align: -1px; }
.cause-legend { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(100%, 420px), 1fr));
  gap: 6px 40px; margin: 10px 0 4px; }
.causes { list-style: none; padding: 0; margin: 0; font-size: .92rem; }
.causes li { padding-left: 20px; text-indent: -20px; margin: 2px 0; }
.causes li:first-child { padding: 0; text-indent: 0; }
.causes b { font-weight: 600; }
.causes i, .cause-table i { display: inline-block; width: 13px; height: 13px; border-radius: 3px;
  margin-right: 7px; vertical-align: -1px; text-indent: 0; }
.cause-table { font-size: .84rem; }
.cause-table th, .cause-table td { padding: 5px 6px; }
.cause-table thead th { white-space: normal; min-width: 3.6em; line-height: 1.25; }
.cause-table thead i { margin: 0 0 3px; }
.cause-table small { display: block; color: var(--soft); font-size: .86em; }
.counts { margin-top: 8px; font-size: .93rem; }
.counts summary { color: var(--soft); cursor: pointer; width: max-content; max-width: 100%; }
.tools { display: flex; flex-wrap: wrap; gap: 10px 26px; align-items: center; margin: 14px 0 4px;
  font-size: .93rem; }
.tools label { color: var(--soft); }
select, input[type=search], .tools button { font: inherit; color: var(--ink); padding: 4px 8px;
  border: 1px solid #b9bfc8; border-radius: 6px; background: #fff; }
.scene { padding: 26px 0 14px; border-top: 1px solid var(--line); margin-top: 18px; }
.scene > div:first-child { display: flex; flex-wrap: wrap; gap: 4px 14px; align-items: baseline;
  margin-bottom: 10px; }
.stage { display: grid; grid-template-columns: minmax(0, 1fr) 300px; gap: 22px; align-items: start; }
figure { margin: 0; }
.view { overflow: hidden; box-shadow: 0 0 0 1px var(--line); background: #fff; }
.view:has(.zoomed) { overflow: auto; }
.view:has(.pair) { aspect-ratio: auto !important; }
.frame { --cut: 50%; --zoom: 1; position: relative; width: calc(100% * var(--zoom)); cursor: ew-resize;
  touch-action: pan-y; user-select: none; }
.frame img { display: block; width: 100%; height: auto; pointer-events: none; }
.frame .pred { display: none; position: absolute; inset: 0; clip-path: inset(0 0 0 var(--cut)); }
.frame .pred.on { display: block; }
.frame.zoomed img { image-rendering: pixelated; }
.frame::after { content: ""; position: absolute; top: 0; bottom: 0; left: var(--cut); width: 2px;
  margin-left: -1px; background: #e69f00; pointer-events: none; }
.grip { position: absolute; top: 50%; left: var(--cut); width: 26px; height: 26px; margin: -13px;
  border-radius: 50%; background: #fff; border: 2px solid #e69f00; z-index: 2; pointer-events: none; }
.grip::before { content: "\2039\00a0\203a"; position: absolute; inset: 0; text-align: center;
  font-size: 15px; line-height: 19px; color: var(--soft); }
.side { display: flex; justify-content: space-between; gap: 12px; font-size: .88rem;
  color: var(--soft); margin-top: 4px; }
.frame.pair { display: grid; grid-template-columns: 1fr 1fr; gap: 8px; cursor: default; }
.frame.pair .pred.on { position: static; clip-path: none; }
.frame.pair::after, .frame.pair .grip { display: none; }
input[type=range] { width: 100%; margin: 8px 0 0; accent-color: var(--blue); display: block; }
.picker { border: 0; margin: 0; padding: 0; display: grid; gap: 2px; min-width: 0; }
.picker legend { padding: 0; margin-bottom: 4px; color: var(--soft); font-size: .88rem; }
.picker label { display: grid; grid-template-columns: 104px minmax(0, 1fr); gap: 11px;
  align-items: center; padding: 5px 6px; border-radius: 6px; cursor: pointer; line-height: 1.3; }
.picker label:hover { background: var(--wash); }
.picker label:has(:checked) { background: #eef6fb; box-shadow: inset 3px 0 0 var(--blue); }
.picker label:focus-within { outline: 2px solid var(--blue); outline-offset: -2px; }
.picker input { position: absolute; opacity: 0; pointer-events: none; }
.picker img { width: 104px; height: auto; display: block; border: 1px solid var(--line);
  background: #fff; }
.picker b { display: block; font-size: .95rem; overflow-wrap: anywhere; }
.picker span span { display: block; color: var(--soft); font-size: .82rem;
  font-variant-numeric: tabular-nums; }
.rows { max-height: 620px; overflow: auto; border: 1px solid var(--line); }
.rows table { font-size: .84rem; width: 100%; }
.rows thead th { position: sticky; top: 0; background: #fff; z-index: 1; padding: 0; }
.rows th button { font: inherit; color: inherit; background: none; border: 0; padding: 7px 9px;
  cursor: pointer; width: 100%; text-align: inherit; white-space: nowrap; }
.rows th button:hover { color: var(--ink); background: var(--wash); }
.rows th[aria-sort=ascending] button::after { content: " \2191"; }
.rows th[aria-sort=descending] button::after { content: " \2193"; }
.rows td { max-width: 320px; overflow: hidden; text-overflow: ellipsis; }
td.text, .rows th.text { text-align: left; }
.wide td.text:last-child { white-space: normal; overflow-wrap: anywhere; min-width: 300px; }
.wide td.text { max-width: 260px; overflow: hidden; text-overflow: ellipsis; }
.provenance { display: grid; grid-template-columns: max-content minmax(0, 1fr); gap: 3px 22px;
  font-size: .92rem; margin: 12px 0; }
.provenance dt { color: var(--soft); }
.provenance dd { margin: 0; overflow-wrap: anywhere; }
footer { color: var(--soft); font-size: .88rem; padding: 30px 0 50px; }
:focus-visible { outline: 2px solid var(--blue); outline-offset: 2px; }
@media (max-width: 900px) {
  .wrap { padding: 0 18px; }
  .stage { grid-template-columns: 1fr; gap: 12px; }
  .picker { grid-template-columns: repeat(auto-fill, minmax(262px, 1fr)); }
  .picker legend { grid-column: 1 / -1; }
}
@media print {
  nav, .tools, input[type=range], .grip, .picker input { display: none !important; }
  body { font-size: 11pt; }
  header { background: none; }
  .frame { display: grid; grid-template-columns: 1fr 1fr; gap: 8px; width: 100%; }
  .frame .pred.on { position: static; clip-path: none; }
  .frame::after { display: none; }
  .view { aspect-ratio: auto !important; }
  .rows { max-height: none; overflow: visible; }
  .scene, .chart, tr { break-inside: avoid; }
  .scroll { overflow: visible; }
}
)css";
}

std::string_view page_script() {
    return R"js(
"use strict";
const all = (root, selector) => Array.from(root.querySelectorAll(selector));

function setUpScene(scene) {
  const frame = scene.querySelector(".frame");
  const range = scene.querySelector("input[type=range]");
  const right = scene.querySelector(".right");
  if (!range) return;
  const cut = percent => {
    const value = Math.min(100, Math.max(0, percent));
    frame.style.setProperty("--cut", value + "%");
    range.value = value;
    range.setAttribute("aria-valuetext", Math.round(value) + " % truth");
  };
  const show = method => {
    all(frame, ".pred").forEach(img => img.classList.toggle("on", img.dataset.method === method));
    right.textContent = method + ", errors in colour";
  };
  range.addEventListener("input", () => cut(+range.value));
  const drag = event => {
    if (frame.classList.contains("pair")) return;
    const box = frame.getBoundingClientRect();
    cut(100 * (event.clientX - box.left) / box.width);
  };
  frame.addEventListener("pointerdown", event => {
    if (event.button) return;
    drag(event);
    frame.setPointerCapture(event.pointerId);
  });
  frame.addEventListener("pointermove", event => { if (event.buttons & 1) drag(event); });
  all(scene, ".picker input").forEach(input => {
    input.addEventListener("change", () => show(input.value));
    if (input.checked) show(input.value);
  });
  cut(50);
}

function setUpTools() {
  const scenes = all(document, ".scene");
  const by = id => document.getElementById(id);
  if (!by("pick-method")) return;
  by("pick-method").addEventListener("change", event => {
    all(document, ".picker input").forEach(input => {
      if (input.value !== event.target.value) return;
      input.checked = true;
      input.dispatchEvent(new Event("change"));
    });
  });
  by("pick-layout").addEventListener("change", event => {
    scenes.forEach(scene => {
      scene.querySelector(".frame").classList.toggle("pair", event.target.value === "pair");
      const range = scene.querySelector("input[type=range]");
      if (range) range.hidden = event.target.value === "pair";
    });
  });
  by("pick-zoom").addEventListener("change", event => {
    scenes.forEach(scene => {
      const frame = scene.querySelector(".frame");
      frame.style.setProperty("--zoom", event.target.value);
      frame.classList.toggle("zoomed", event.target.value !== "1");
    });
  });
}

function setUpRows() {
  const table = document.querySelector(".rows table");
  if (!table) return;
  const body = table.tBodies[0];
  const number = text => text === "-" || text === "" ? -Infinity : parseFloat(text);
  all(table, "thead th").forEach((head, column) => {
    head.querySelector("button").addEventListener("click", () => {
      const isText = head.classList.contains("text");
      const sign = head.getAttribute("aria-sort") === "ascending" ? -1 : 1;
      const key = row => row.cells[column].textContent;
      const order = isText ? (a, b) => key(a).localeCompare(key(b))
                           : (a, b) => number(key(a)) - number(key(b));
      const rows = Array.from(body.rows).sort((a, b) => sign * order(a, b));
      all(table, "thead th").forEach(other => other.removeAttribute("aria-sort"));
      head.setAttribute("aria-sort", sign > 0 ? "ascending" : "descending");
      body.append(...rows);
    });
  });
  const filter = document.getElementById("filter-rows");
  filter.addEventListener("input", () => {
    const words = filter.value.toLowerCase().split(/\s+/).filter(word => word);
    Array.from(body.rows).forEach(row => {
      const text = row.textContent.toLowerCase();
      row.hidden = !words.every(word => text.includes(word));
    });
  });
}

all(document, ".scene").forEach(setUpScene);
setUpTools();
setUpRows();
)js";
}

std::string_view page_mark() {
    return R"svg(<svg viewBox="0 0 32 32" width="34" height="34" aria-hidden="true"><path d="M16 3 27.5 9.5v13L16 29 4.5 22.5v-13Z" fill="#fff" stroke="#20242a" stroke-width="2.6" stroke-linejoin="round"/><path d="M4.5 9.5 16 16 27.5 9.5M16 16v13" fill="none" stroke="#009e73" stroke-width="1.8"/></svg>)svg";
}

}  // namespace ink::report
