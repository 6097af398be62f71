// Curves over two axes, as SVG that the style of the page colours. One frame changes paths; axes only when their ranges do.

import { powerOfTen } from "./draw.js";
import { unitAfter } from "./units.js";

const SVG = "http://www.w3.org/2000/svg";
const SNAP = 4; // pixels
const LEAST = 1e-6; // below which curves are not read
const MARGIN = { left: 40, right: 10, top: 8, bottom: 34 };

export function svg(name, attributes = {}, ...children) {
  const node = document.createElementNS(SVG, name);
  for (const [key, value] of Object.entries(attributes)) node.setAttribute(key, value);
  node.append(...children);
  return node;
}

// 1, 2 or 5 times a power of ten: the least such step that divides a length into no more than `most` parts.
export function niceStep(length, most) {
  const rough = length / most;
  const power = 10 ** Math.floor(Math.log10(rough));
  return power * ([1, 2, 5, 10].find((step) => step * power >= rough * (1 - 1e-9)) ?? 10);
}

export function niceTop(value) {
  if (!(value > 0)) return 1;
  const power = 10 ** Math.floor(Math.log10(value));
  return power * [1, 2, 5, 10].find((step) => step * power >= value * (1 - 1e-9));
}

export function short(value, digits = 4) {
  if (!Number.isFinite(value)) return "–";
  const rounded = Number(value.toPrecision(digits));
  return rounded && Math.abs(rounded) < 1e-3 ? rounded.toExponential() : String(rounded);
}

// A value of a curve to the decimals that an error leaves, or that it is less than the error.
export function curveSaid(value, error) {
  if (value < (error || LEAST)) return `< ${error ? Math.ceil(1e3 * error) / 1e3 : "1e-6"}`;
  return short(error > 0 && Number.isFinite(value) ? Number(value.toFixed(Math.max(0, Math.floor(-Math.log10(error))))) : value, 3);
}

export class Plot {
  constructor(title) {
    this.axes = svg("g", { class: "axes" });
    this.clip = `clip-${Math.random().toString(36).slice(2)}`;
    this.window = svg("rect", { x: MARGIN.left, y: MARGIN.top - 2 });
    this.curves = svg("g", { "clip-path": `url(#${this.clip})` });
    this.cursor = svg("line", { class: "cursor", visibility: "hidden" });
    this.mark = svg("g", { class: "mark", visibility: "hidden" }, svg("line"), svg("text"));
    const inside = svg("clipPath", { id: this.clip }, this.window);
    const said = { class: "plot", role: "img", "aria-label": title, tabindex: 0, "data-lm-suppress-shortcuts": "true" };
    this.node = svg("svg", said, inside, this.axes, this.mark, this.curves, this.cursor);
    this.readout = document.createElement("output");
    this.readout.className = "readout";
    this.readout.setAttribute("aria-hidden", "true");
    this.paths = [];
    this.width = 320;
    this.height = 190;
    this.shown = null;
    this.watch = new ResizeObserver(() => this.measure());
    this.watch.observe(this.node);
    for (const name of ["pointermove", "pointerdown"]) this.node.addEventListener(name, (event) => this.point(event));
    for (const name of ["pointerleave", "blur"]) this.node.addEventListener(name, () => this.leave());
    this.node.addEventListener("keydown", (event) => this.step(event));
  }

  destroy() {
    this.watch.disconnect();
  }

  measure() {
    const { width, height } = this.node.getBoundingClientRect();
    if (width < 40 || height < 40 || (width === this.width && height === this.height)) return;
    [this.width, this.height, this.drawn] = [width, height, ""];
    if (this.shown) this.draw(this.shown);
  }

  clear() {
    while (this.paths.length) this.paths.pop().remove();
    this.shown = null;
    this.mark.setAttribute("visibility", "hidden");
    this.leave();
  }

  // {x: {top, label}, y: {top, bottom, log, label}, curves: [{kind, name, x, y}], mark: a place on x that is always read,
  // {at, name, said}}
  draw(shown) {
    this.shown = shown;
    const { x, y, curves } = shown;
    const inner = { width: this.width - MARGIN.left - MARGIN.right, height: this.height - MARGIN.top - MARGIN.bottom };
    const across = (value) => MARGIN.left + (value / x.top) * inner.width;
    const span = y.log ? Math.log10(y.top / y.bottom) : y.top;
    const share = y.log ? (value) => Math.log10(Math.max(value, y.bottom / 10) / y.bottom) / span : (value) => value / span;
    const up = (value) => MARGIN.top + (1 - share(value)) * inner.height;
    const drawn = JSON.stringify([x, y, this.width, this.height]);
    if (drawn !== this.drawn) this.frame(x, y, inner, across, up);
    this.drawn = drawn;
    this.across = across;
    while (this.paths.length > curves.length) this.paths.pop().remove();
    curves.forEach((curve, index) => {
      if (!this.paths[index]) this.curves.append((this.paths[index] = svg("path")));
      this.paths[index].setAttribute("class", `curve ${curve.kind}`);
      this.paths[index].setAttribute("d", path(curve, across, up, x.top));
    });
    this.showMark(shown, inner);
    if (this.pointed === undefined) this.leave();
    else this.tell(this.pointed);
  }

  showMark({ x, mark }, inner) {
    const there = mark && mark.at <= x.top;
    this.mark.setAttribute("visibility", there ? "visible" : "hidden");
    if (!there) return;
    const [line, text] = this.mark.children;
    const place = this.across(mark.at);
    for (const [name, value] of [["x1", place], ["x2", place], ["y1", MARGIN.top], ["y2", MARGIN.top + inner.height]]) line.setAttribute(name, value);
    const left = place > MARGIN.left + 0.7 * inner.width;
    for (const [name, value] of [["x", place + (left ? -4 : 4)], ["y", MARGIN.top + 10], ["text-anchor", left ? "end" : "start"]]) text.setAttribute(name, value);
    text.textContent = mark.name;
  }

  frame(x, y, inner, across, up) {
    const { left, top } = MARGIN;
    const [right, bottom] = [left + inner.width, top + inner.height];
    for (const [name, value] of [["width", inner.width + 2], ["height", inner.height + 3]]) this.window.setAttribute(name, value);
    this.node.setAttribute("viewBox", `0 0 ${this.width} ${this.height}`);
    const lines = [];
    const words = [];
    const step = niceStep(x.top, inner.width > 240 ? 6 : 4);
    for (let k = 0; k * step <= x.top * (1 + 1e-9); k++) {
      lines.push(svg("line", { x1: across(k * step), x2: across(k * step), y1: top, y2: bottom }));
      words.push(svg("text", { x: across(k * step), y: bottom + 14, "text-anchor": "middle" }, short(k * step)));
    }
    const count = Math.round(y.log ? Math.log10(y.top / y.bottom) : y.top / niceStep(y.top, inner.height > 90 ? 5 : 2));
    for (let k = 0; k <= count; k++) {
      const mark = y.log ? y.bottom * 10 ** k : (y.top * k) / count;
      const word = y.log ? powerOfTen(Math.round(Math.log10(mark))) : short(mark, 3);
      lines.push(svg("line", { x1: left, x2: right, y1: up(mark), y2: up(mark) }));
      words.push(svg("text", { x: left - 6, y: up(mark) + 4, "text-anchor": "end" }, word));
    }
    words.push(svg("text", { x: (left + right) / 2, y: this.height - 4, "text-anchor": "middle", class: "name" }, x.label));
    this.axes.replaceChildren(...lines, ...words);
    for (const [name, value] of [["y1", top], ["y2", bottom]]) this.cursor.setAttribute(name, value);
  }

  point(event) {
    if (!this.shown) return;
    const box = this.node.getBoundingClientRect();
    const { x } = this.shown;
    const at = ((event.clientX - box.left - MARGIN.left) / (box.width - MARGIN.left - MARGIN.right)) * x.top;
    if (at < 0 || at > x.top) return this.leave();
    return this.tell(this.snapped(at));
  }

  // By arrow keys.
  step(event) {
    const by = { ArrowLeft: -1, ArrowRight: 1 }[event.key];
    if (event.key === "Escape") this.leave();
    if (!by || !this.shown) return;
    event.preventDefault();
    const { top } = this.shown.x;
    const unit = 0.1 * niceStep(top, 6); // so that round numbers are met
    const at = (Math.round((this.pointed ?? 0.5 * top) / unit) + by * (event.shiftKey ? 5 : 1)) * unit;
    this.tell(this.snapped(Math.min(top, Math.max(0, at))));
  }

  // A least value of a curve within a few pixels, so that zeros can be read, or else the place itself.
  snapped(at) {
    let reach = (SNAP / (this.width - MARGIN.left - MARGIN.right)) * this.shown.x.top;
    let found = at;
    for (const { x, y } of this.shown.curves) {
      for (let i = 1; i < x.length - 1; i++) {
        if (!(y[i] < y[i - 1] && y[i] <= y[i + 1] && Math.abs(x[i] - at) < reach)) continue;
        [found, reach] = [x[i], Math.abs(x[i] - at)];
      }
    }
    return found;
  }

  tell(at) {
    this.pointed = at;
    for (const name of ["x1", "x2"]) this.cursor.setAttribute(name, this.across(at));
    this.cursor.setAttribute("visibility", "visible");
    this.readout.textContent = `${short(at, 3)}${unitAfter(this.shown.x.unit)}: ${this.values(at)}`;
    this.told?.();
  }

  // Curves of one value are named together: "x, y 0.5; limit 0.61; x, y with pixel 0.4".
  values(at) {
    const said = new Map();
    for (const { name, ...curve } of this.shown.curves) {
      const text = curveSaid(read(curve, at), this.shown.error);
      const [, first, end = ""] = /^(.*?)( with pixel)?$/.exec(name);
      said.set(end + text, { text: `${end} ${text}`, names: [...(said.get(end + text)?.names ?? []), first] });
    }
    return [...said.values()].map(({ text, names }) => names.join(", ") + text).join("; ");
  }

  leave() {
    this.pointed = undefined;
    this.cursor.setAttribute("visibility", "hidden");
    this.readout.textContent = this.readout.title = this.shown?.mark?.said ?? "";
  }
}

function path({ x, y }, across, up, end) {
  let text = "";
  let last = -1;
  for (let i = 0; i < x.length; i++) {
    // As near as half a pixel only least values are drawn.
    const near = across(x[i]) - last < 0.5 && i < x.length - 1;
    if (!Number.isFinite(y[i]) || (near && !(y[i] < y[i - 1] && y[i] <= y[i + 1]))) continue;
    last = across(x[i]);
    text += `${text ? "L" : "M"}${Math.round(across(x[i]) * 10) / 10} ${Math.round(up(y[i]) * 10) / 10}`;
    if (x[i] > end) break;
  }
  return text;
}

// The value of a curve at a place, on straight lines between its points.
export function read({ x, y }, at) {
  if (!(at >= x[0]) || at > x[x.length - 1]) return NaN;
  let high = 1;
  while (high < x.length - 1 && x[high] < at) high++;
  return y[high - 1] + ((y[high] - y[high - 1]) * (at - x[high - 1])) / (x[high] - x[high - 1] || 1);
}
