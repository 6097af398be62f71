// The stage of the PSF: its pixels, a setting held as A beside it, rays over it, the bar below, and the value under the cursor.

import { el } from "./dom.js";
import { axisOf, difference, drawAtScale, drawBar, drawPsf, drawSigned, drawSignedBar, colour, largest, mapOf, placesOfRays, RAYS, TRUE_COLOUR } from "./draw.js";
import { lengthUnit, unitAfter } from "./units.js";
import { niceStep, short, svg } from "./plots.js";
import { valueSaid, waveSaid } from "./sentences.js";

export const RAYS_SAID = "rays (geometrical optics)";

// Of the sensor's pixels, the middle that holds most light, in steps so that it does not breathe.
function cropOf({ view }, { psf: { side, pixel }, measures }) {
  if (view === "fine" || !measures?.d80_axis) return side;
  const wanted = 2 ** (Math.ceil(2 * Math.log2((4 * measures.d80_axis) / pixel)) / 2);
  return Math.min(side, Math.max(16, 2 * Math.round(wanted / 2)));
}

// Width of the field that holds nearly all light, micrometres.
function fieldOf(held) {
  const { energy } = held.measures;
  return Math.min(cropOf(held.state, held) * held.psf.pixel, 2.2 * (energy.r[energy.share.findIndex((share) => share > 0.98)] ?? Infinity));
}

// What is drawn of an answer: electrons where there is noise, else fractions of the light.
const imageOf = ({ psf }) => (psf.counts ? { ...psf, values: psf.counts, colour: null } : psf);
const density = (image) => largest(image.values) / image.pixel ** 2;

// Draw the PSF of a state, and that of a held one, on canvases {now, held, bar}; return what they are of:
// {field, crop, ticks, label, panels}. mode: "one", "beside", "flicker" or "difference"; shared: one scale for both.
export function compose(canvases, { state, shown, held = null, mode = "one", shared = true }) {
  const { psf } = shown;
  const one = !held || mode === "difference";
  // Both are drawn over a field that holds what is to be seen of either.
  const least = cropOf(state, shown);
  const crop = one ? least : Math.max(least, 2 * Math.ceil(fieldOf(held) / (2 * psf.pixel)));
  const field = crop * psf.pixel;
  const map = mapOf(state);
  const middle = axisOf(crop);
  const found = { field, crop, middle, panels: [{ name: held ? "B" : "", canvas: canvases.now, state, shown }] };
  if (held && one) {
    const top = Math.max(density(psf), density(held.psf));
    const values = difference(psf, held.psf, crop, top);
    const reach = values.reduce((most, value) => Math.max(most, Math.abs(value)), 0);
    drawSigned(canvases.now, values, crop, reach, state.stretch);
    found.panels[0].name = "B − A";
    return { ...found, ticks: drawSignedBar(canvases.bar, state.stretch, reach), label: "B minus A, of the brightest point of both", signed: true };
  }
  const image = imageOf(shown);
  const old = held && imageOf(held);
  const both = old && shared && Boolean(psf.counts) === Boolean(held.psf.counts);
  const top = both ? Math.max(density(image), density(old)) * image.pixel ** 2 : largest(image.values);
  const draw = (canvas, of, answer, shownImage, brightest) => {
    // Of the same pixels both show as many.
    const own = shownImage.pixel === psf.pixel ? Math.min(crop, shownImage.side) : cropOf(of, answer);
    const colours = map === TRUE_COLOUR && !shownImage.colour ? "gray" : map;
    const look = { map: colours, stretch: state.stretch, crop: own, top: brightest };
    if (own === crop && answer === shown) return drawPsf(canvas, shownImage, look);
    const plain = (canvases.scratch ??= document.createElement("canvas"));
    drawPsf(plain, shownImage, look);
    const ground = `rgb(${colour(colours === TRUE_COLOUR ? "gray" : colours, 0).join()})`;
    const ratio = (own * shownImage.pixel) / field;
    return drawAtScale(canvas, plain, { ratio, side: Math.max(512, own), from: axisOf(own), to: middle, ground, smooth: of.view === "fine" });
  };
  draw(canvases.now, state, shown, image, top);
  if (old) {
    draw(canvases.held, held.state, held, old, both ? (top * old.pixel ** 2) / image.pixel ** 2 : largest(old.values));
    found.panels.unshift({ name: "A", canvas: canvases.held, state: held.state, shown: held });
  }
  const point = both ? "the brightest point of A and B, for equal light; the numbers are of each its own peak" : old ? "the brightest point of each" : "the brightest point";
  const label = `${map === TRUE_COLOUR && image.colour ? "true colour, " : ""}${psf.counts ? "electrons per pixel" : `of ${point}`}${state.noise === "on" && !psf.counts ? ", without noise: that is of the sensor's pixels" : ""}`;
  return { ...found, ticks: drawBar(canvases.bar, { map, stretch: state.stretch }, psf.counts ? Math.max(1, top) : 1), label };
}

// A ruler for a field in micrometres: its text, and its share of the field.
export function rulerOf(state, field) {
  const { factor, name } = lengthUnit(state);
  const step = niceStep(field * factor, 4);
  return [`${short(step)}${unitAfter(name)}`, step / (field * factor)];
}

// A label that follows the pointer or, by arrow keys, a cross: said(column, row) has the text for a pixel of the canvas, which has
// cells(), of a square, or columns and rows.
export class Readout {
  constructor(canvas, cells, said) {
    this.text = el("output", { class: "place", hidden: true });
    this.cross = el("i", { class: "cross", "aria-hidden": "true", hidden: true });
    Object.assign(this, { canvas, cells: () => [cells()].flat(), said, at: null });
    canvas.tabIndex = 0;
    canvas.dataset.lmSuppressShortcuts = "true";
    const frame = canvas.closest(".frame") ?? el("div", { class: "spot" });
    if (!frame.contains(canvas)) {
      canvas.replaceWith(frame);
      frame.append(canvas);
    }
    canvas.after(this.text, this.cross);
    for (const name of ["pointermove", "pointerdown"]) canvas.addEventListener(name, (event) => this.follow(event));
    // A finger leaves what it touches; what it read stays until something else is touched.
    canvas.addEventListener("pointerleave", (event) => event.pointerType !== "touch" && this.put(null));
    canvas.addEventListener("blur", () => this.put(null));
    canvas.addEventListener("keydown", (event) => this.step(event));
  }

  follow(event) {
    const box = this.canvas.getBoundingClientRect();
    const share = (at, from, length, count) => Math.min(count - 1, Math.max(0, Math.floor(((at - from) / length) * count)));
    this.text.setAttribute("aria-live", "off");
    const [across, down = across] = this.cells();
    this.put([share(event.clientX, box.left, box.width, across), share(event.clientY, box.top, box.height, down)]);
  }

  step(event) {
    const by = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] }[event.key];
    if (event.key === "Escape") return this.put(null);
    if (!by) return;
    event.preventDefault();
    const [across, down = across] = this.cells();
    const length = event.shiftKey ? Math.ceil(across / 16) : 1;
    const from = this.at ?? [across, down].map((count, k) => Math.floor(count / 2) - by[k] * length);
    this.text.setAttribute("aria-live", "polite");
    this.put(from.map((at, k) => Math.min([across, down][k] - 1, Math.max(0, at + by[k] * length))));
  }

  put(at) {
    this.at = at;
    this.update();
  }

  // Anew, for what is drawn now.
  update() {
    const [across, down = across] = this.cells();
    const said = this.at && this.at[0] < across && this.at[1] < down ? this.said(...this.at) : "";
    this.text.hidden = this.cross.hidden = !said;
    if (!said) return;
    const [x, y] = this.at.map((at, k) => (100 * (at + 0.5)) / [across, down][k]);
    this.text.textContent = said;
    this.text.classList.toggle("below", y < 40); // away from the place itself
    this.cross.style.left = `${x}%`;
    this.cross.style.top = `${y}%`;
  }
}

export class Stage {
  constructor(page, mapSide) {
    this.page = page;
    this.overlays = ["held", "psf"].map((name) => {
      const overlay = svg("svg", { class: "rays", viewBox: "0 0 1000 1000", "aria-hidden": "true" }, svg("path"), svg("path"));
      page[name].after(overlay);
      return overlay;
    });
    this.label = el("span", { class: "of" });
    this.legend = el("span", { class: "dots", hidden: true }, RAYS_SAID);
    this.legend.style.setProperty("--rays", RAYS);
    page.bar.parentNode.append(this.label);
    page.psf.after(this.legend);
    this.place = new Readout(page.psf, () => this.drawn?.crop ?? 0, (column, row) => this.value(column, row));
    this.wave = new Readout(page.wavefront, () => mapSide, (column, row) =>
      this.wavefront ? waveSaid(this.given.state, this.wavefront, mapSide, column, row) : "",
    );
  }

  // given: what compose takes.
  draw(given) {
    const { page } = this;
    this.given = given;
    const canvases = (this.canvases ??= { now: page.psf, held: page.held, bar: page.bar });
    const drawn = (this.drawn = compose(canvases, given));
    const { state, shown, held } = given;
    page.stage.dataset.view = state.view;
    const [text, share] = rulerOf(state, drawn.field);
    const [word, bar] = page.ruler.children;
    word.textContent = text;
    bar.style.width = `${100 * share}%`;
    this.label.textContent = drawn.label;
    page.selects.map.options[0].text = state.light === "white" ? "true colour" : "automatic";
    const print = JSON.stringify(drawn.ticks);
    if (print !== this.print) page.ticks.replaceChildren(...drawn.ticks.map(([at, word]) => el("span", { style: `left:${100 * at}%;transform:translateX(${-100 * at}%)` }, word)));
    this.print = print;
    const now = page.psf.parentNode.querySelector(".tag");
    if (now) now.textContent = given.mode === "difference" ? "B − A" : "B";
    [held?.rays, shown.rays].forEach((rays, k) => {
      const there = state.rays === "on" && rays && !drawn.signed;
      const path = there ? placesOfRays(rays, drawn).map(([x, y]) => `M${(1000 * x).toFixed(1)} ${(1000 * y).toFixed(1)}h0`).join("") : "";
      this.overlays[k].toggleAttribute("hidden", !there);
      for (const node of this.overlays[k].children) node.setAttribute("d", path);
      if (k) this.legend.hidden = !there;
    });
    this.place.update();
  }

  // Nothing is drawn, and nothing can be read.
  clear() {
    this.drawn = this.given = this.wavefront = undefined;
    this.page.ruler.firstChild.textContent = "";
    this.legend.hidden = true;
    for (const overlay of this.overlays) overlay.toggleAttribute("hidden", true);
    for (const readout of [this.place, this.wave]) readout.update();
  }

  // Numbers that came after what is drawn.
  renew(shown) {
    if (this.given?.shown.psf !== shown.psf) return;
    this.given.shown = shown;
    this.place.update();
  }

  showWavefront(wavefront) {
    this.wavefront = wavefront;
    this.wave.update();
  }

  value(column, row) {
    const { state, shown, held, mode } = this.given;
    const middle = Math.floor(this.drawn.crop / 2);
    const [across, down] = [column - middle, row - middle];
    const half = shown.psf.side / 2;
    if (Math.min(across, down) < -half || Math.max(across, down) >= half) return "beyond the window of B";
    const said = valueSaid(state, shown.psf, shown.measures, across, down);
    if (!held || mode !== "difference") return said;
    return `B: ${said}`;
  }
}
