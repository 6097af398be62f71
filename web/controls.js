// The controls: each a label, a number box and a slider, all native inputs. What they hold is the state alone.

import { el, menu, unique } from "./dom.js";
import { english, inLanguage } from "./language.js";
import { short } from "./plots.js";
import { DIRECTED, FIELDS } from "./fields.js";
import { furtherTerms, INFINITE } from "./state.js";
import { LENGTH_UNITS, WAVES_UNITS, wavesUnit, withUnit } from "./units.js";

// [title, rows or pairs of a size and its direction], in the order of FIELDS. lommel.page.state lists the contents of rows.
const GROUPS = [];
for (const [key, { row }] of Object.entries(FIELDS)) {
  if (!row || (key.endsWith("_angle") && Object.hasOwn(FIELDS, key.slice(0, -6)))) continue;
  if (GROUPS.at(-1)?.[0] !== row.group) GROUPS.push([row.group, []]);
  GROUPS.at(-1)[1].push(Object.hasOwn(FIELDS, `${key}_angle`) ? [key, `${key}_angle`] : key);
}

const LIGHTS = { mono: "one wavelength", white: "white light" };
// Rows of a menu, before or after the sliders of their group.
const FOCUS = { waves: "defocus in waves", distances: "by distances" };
const ABOVE = { Wavefront: [["focus", "Focus", FOCUS]] };
const BELOW = {
  Wavefront: [["rays", "Rays", { off: "not shown", on: "over the image" }]],
  Sensor: [["noise", "Noise", { off: "none", on: "photons and read noise" }]],
};

const SAID = 3; // terms without sliders, of which all are said in words that are clicked
const TERM_NAMES = {
  "1,1": "tilt x", "1,-1": "tilt y", "2,0": "defocus", "2,2": "astigmatism 0°", "2,-2": "astigmatism 45°", "3,1": "coma x", "3,-1": "coma y",
  "3,3": "trefoil 0°", "3,-3": "trefoil 30°", "4,0": "spherical", "4,4": "tetrafoil 0°", "4,-4": "tetrafoil 22.5°", "6,0": "second spherical",
};

// "tilt y (Z1^-1) 0.3", the largest first.
const termsSaid = ({ zernike }) =>
  furtherTerms(zernike)
    .sort(([, , a], [, , b]) => Math.abs(b) - Math.abs(a))
    .map(([n, m, c]) => `${TERM_NAMES[`${n},${m}`] ? `${TERM_NAMES[`${n},${m}`]} (Z${n}^${m})` : `Z${n}^${m}`} ${short(c, 3)}`);

const SIDEWAYS = 6; // px that a finger moves before a slider follows it
const PAUSE = 700; // ms without a change that end a gesture of the keyboard

export class Controls {
  // set(change, moving, gesture) takes every change; `only` lists the keys to show, or is empty for all. touched(key) is called with
  // the slider that is used.
  constructor({ state, set, touched, only = [], level = 2 }) {
    Object.assign(this, { set, touched });
    this.rows = new Map();
    this.menus = {};
    this.gesture = { count: 0, key: "", time: 0 };
    const shows = (key) => !only.length || only.includes(key);
    const groups = GROUPS.map(([title, entries]) => {
      const choices = (list = []) => list.filter(([key]) => shows(key)).map((choice) => this.choice(...choice, state));
      const sliders = entries.map((entry) => this.entry(entry, state, shows)).filter(Boolean);
      const further = title === "Wavefront" && shows("zernike") ? [this.further()] : [];
      const rows = [...choices(ABOVE[title]), ...sliders, ...further, ...choices(BELOW[title])];
      const extra = this.extra(title, state, shows);
      if (!rows.length && !extra.length) return null;
      const head = el("div", { class: "head" }, el(`h${level + 1}`, { class: "title" }, title), ...extra);
      return el("div", { class: "section", role: "group", "aria-label": title }, head, ...rows);
    });
    const onsubmit = (event) => event.preventDefault();
    this.node = el("form", { class: "controls", "aria-label": "Settings", onsubmit }, ...groups);
    this.update(state);
  }

  entry(entry, state, shows) {
    if (!Array.isArray(entry)) return shows(entry) ? this.row(entry, state) : null;
    const [size, angle] = entry;
    return shows(size) || shows(angle) ? el("div", { class: "pair" }, this.row(size, state), this.row(angle, state)) : null;
  }

  extra(title, state, shows) {
    const inline = (key, word, label, choices) => {
      if (!shows(key)) return [];
      this.menus[key] = menu(label, choices, state[key], (value) => this.set({ [key]: value }), { "data-key": key });
      const text = word ? [el("span", { "data-word": title === "Wavefront" ? "edge" : key }, word)] : [];
      return [el("div", { class: "inline" }, ...text, this.menus[key])];
    };
    if (title === "Wavefront") return inline("waves_unit", "at the edge, in", "Unit of the wavefront", WAVES_UNITS);
    if (title === "Lens and light") return inline("light", "", "Light", LIGHTS);
    if (title === "Sensor") return inline("length_unit", "lengths in", "Unit of lengths", LENGTH_UNITS);
    return [];
  }

  choice(key, label, choices, state) {
    this.menus[key] = menu(label, choices, state[key], (value) => this.set({ [key]: value }), { "data-key": key });
    return el("div", { class: "row choice", "data-row": key }, el("span", { "data-word": key }, label), this.menus[key]);
  }

  // Zernike terms of a lens file or listing, which have no sliders.
  further() {
    const remove = el("button", { type: "button", onclick: () => this.set({ zernike: "" }) }, "Remove");
    this.terms = el("span", { "data-word": "zernike" });
    this.termsRow = el("div", { class: "row choice", "data-row": "zernike" }, this.terms, remove);
    return this.termsRow;
  }

  // The name of the gesture that a change belongs to: a drag from touch to release, keys or typing without a pause.
  gestureOf(key, dragging) {
    const { gesture } = this;
    const now = performance.now();
    if (gesture.key !== key || (!dragging && now - gesture.time > PAUSE)) gesture.count++;
    Object.assign(gesture, { key, time: now });
    return `${key} ${gesture.count}`;
  }

  row(key, state) {
    const spec = FIELDS[key].row;
    const id = unique(key);
    const name = spec.name ?? spec.label;
    const hint = `${FIELDS[key].about ?? name}\nDouble click, or Delete, for the default`;
    const slider = el("input", { type: "range", "aria-label": name, "data-key": key, title: hint });
    // Not of the type "number": this drops a decimal comma without a word, where the browser's language has a point, and "inf".
    const box = el("input", { type: "text", id, "data-key": key, inputmode: "decimal", autocomplete: "off", "aria-errormessage": `${id}-fault` });
    const unit = el("span", { class: "unit" }, spec.unit ?? "");
    const fault = el("p", { class: "fault", id: `${id}-fault`, role: "alert", hidden: true });
    const row = { key, spec, slider, box, unit, fault, name, dragging: false };
    const reset = () => {
      this.allow(row);
      this.set({ [key]: FIELDS[key].initial });
    };
    this.slide(row);
    slider.addEventListener("dblclick", reset);
    slider.addEventListener("keydown", (event) => {
      if (event.key === "Delete" || event.key === "Backspace") reset();
    });
    this.type(row);
    const label = el("label", { for: id, title: hint, "data-word": key, ondblclick: reset }, spec.label);
    this.rows.set(key, row);
    return el("div", { class: "row", "data-row": key }, el("div", { class: "line" }, label, box, unit), fault, slider);
  }

  // A mouse moves a slider at once. A finger does after some way sideways, or as a tap; what scrolls the page leaves it as it was.
  slide(row) {
    const { key, slider } = row;
    let touch = null;
    const take = (at) => this.set({ [key]: valueAt(row, at) }, true, this.gestureOf(key, true));
    const restore = () => {
      row.shown = undefined;
      this.update(this.state);
    };
    slider.addEventListener("pointerdown", (event) => {
      this.gesture.key = "";
      this.touched(key);
      row.dragging = true;
      touch = event.pointerType === "touch" ? { id: event.pointerId, x: event.clientX, before: this.state[key], at: null, moves: false } : null;
    });
    slider.addEventListener("pointermove", (event) => {
      if (touch?.id !== event.pointerId || touch.moves || Math.abs(event.clientX - touch.x) < SIDEWAYS) return;
      touch.moves = true;
      if (touch.at !== null) take(touch.at);
    });
    slider.addEventListener("input", () => {
      if (touch) touch.at = slider.valueAsNumber;
      if (touch && !touch.moves) return restore();
      this.touched(key);
      if (!row.dragging) return this.set({ [key]: valueAt(row, slider.valueAsNumber) }, true, this.gestureOf(key, false));
      return take(slider.valueAsNumber);
    });
    const end = (event) => {
      if (touch && event.type === "pointercancel") {
        if (touch.moves) this.set({ [key]: touch.before }, false, this.gestureOf(key, true));
        else restore();
      } else if (touch && event.type === "pointerup" && !touch.moves && touch.at !== null) take(touch.at);
      if (event.type === "pointercancel" || event.type === "pointerup") touch = null;
      row.dragging = false;
    };
    for (const name of ["pointerup", "pointercancel", "blur", "lostpointercapture"]) slider.addEventListener(name, end);
  }

  // What is typed counts as it is typed where it is in range. What is not stays in the box, with the range below, and changes nothing.
  type(row) {
    const { key, box } = row;
    // All digits, selected as a whole: what is typed replaces them. A click would put a caret between them.
    let fresh = false;
    box.addEventListener("focus", () => {
      row.before = this.state[key];
      if (row.kept === undefined) box.value = inLanguage(textOf(row, row.before, 12));
      box.select();
      fresh = true;
    });
    box.addEventListener("click", () => {
      if (fresh) box.select();
      fresh = false;
    });
    box.addEventListener("input", () => {
      this.edited = box;
      if (faultOf(row)) return;
      this.allow(row);
      this.set({ [key]: typedIn(row) }, true, this.gestureOf(key, false));
    });
    box.addEventListener("keydown", (event) => event.key === "Escape" && this.allow(row));
    const written = () => {
      if (this.edited !== box) return row.kept === undefined && this.allow(row);
      this.edited = undefined;
      const wrong = box.value && faultOf(row);
      if (!wrong) {
        if (box.value) row.before = typedIn(row);
        return this.allow(row);
      }
      row.kept = row.before;
      row.fault.textContent = wrong;
      this.mark(row);
      this.set({ [key]: row.before }, false, this.gestureOf(key, false)); // of what was typed the beginning may have been a number
    };
    for (const end of ["change", "blur"]) box.addEventListener(end, written);
  }

  // The box shows the state again.
  allow(row) {
    row.kept = row.shown = undefined;
    this.mark(row);
    this.update(this.state);
  }

  mark({ box, fault, kept }) {
    fault.hidden = kept === undefined;
    box.setAttribute("aria-invalid", String(kept !== undefined));
  }

  // As allow, in every box.
  forget() {
    this.edited = undefined;
    for (const row of this.rows.values()) this.allow(row);
  }

  // Whether a box holds what is not taken yet.
  typing() {
    return Boolean(this.edited);
  }

  update(state) {
    this.state = state;
    const waves = wavesUnit(state);
    for (const row of this.rows.values()) this.show(row, state, row.spec.waves ? waves : { factor: 1, name: row.spec.unit });
    for (const [key, node] of Object.entries(this.menus)) node.value = state[key];
    if (this.terms) {
      const said = termsSaid(state);
      const rest = said.length - SAID;
      this.termsRow.hidden = !said.length;
      this.terms.textContent = `Further Zernike terms: ${said.slice(0, SAID).join(", ")} waves rms${rest > 0 ? `, and ${rest} smaller` : ""}`;
      this.terms.title = this.terms.dataset.also = said.length ? `${said.join(", ")} waves rms.` : "";
    }
    for (const { spec, box } of this.rows.values())
      box.closest("[data-row]").hidden = spec.when.length > 0 && !spec.when.some(([key, ...values]) => values.includes(state[key]));
  }

  show(row, state, { factor, name }) {
    const value = state[row.key];
    const print = `${value} ${factor}`;
    if (print === row.shown) return;
    row.shown = print;
    row.factor = factor;
    if (row.kept !== undefined && row.kept !== value) row.kept = undefined;
    this.mark(row);
    const { slider, box, spec } = row;
    if (!row.dragging) this.range(row, value);
    slider.value = placeOf(row, value);
    this.fill(row);
    const text = textOf(row, value, Math.abs(value * factor) < 0.1 ? 3 : 4); // what the box has room for
    // What is typed stays until the typing is over.
    if (this.edited !== box && row.kept === undefined) box.value = inLanguage(box.matches(":focus") ? textOf(row, value, 12) : text);
    row.unit.textContent = name;
    slider.setAttribute("aria-valuetext", withUnit(text, spec.waves ? name : spec.said).trim());
    const said = spec.waves ? `${row.name}, ${name}` : [row.name, spec.said].filter(Boolean).join(", ");
    if (box.getAttribute("aria-label") !== said) box.setAttribute("aria-label", said);
  }

  // From zero, where the slider has it, else from its least.
  fill({ slider, spec }) {
    const [least, most] = [Number(slider.min), Number(slider.max)];
    const share = (at) => Math.min(1, Math.max(0, (at - least) / (most - least)));
    const [zero, now] = [spec.step === null ? 0 : share(0), share(slider.valueAsNumber)];
    slider.style.setProperty("--from", Math.min(zero, now).toFixed(4));
    slider.style.setProperty("--to", Math.max(zero, now).toFixed(4));
  }

  range({ slider, spec, key }, value) {
    const { low, high } = FIELDS[key];
    const [from, to] = value < spec.reach[0] || value > spec.reach[1] ? [low, high] : spec.reach;
    const [least, most] = spec.step === null ? [Math.log10(from), Math.log10(to)] : [from, to];
    const wanted = { min: least, max: most, step: spec.step === null ? (most - least) / 400 : spec.step };
    // The step counts from the least: a value between two steps would be moved to one of them, on the screen only.
    for (const [name, number] of Object.entries(wanted)) if (slider[name] !== String(number)) slider[name] = number;
  }
}

// The digits of a value; the most of a distance stands for infinity.
const textOf = ({ key, factor }, value, digits) => (FIELDS[key].infinite && value >= FIELDS[key].high ? "∞" : short(value * factor, digits));

// The value that is typed, NaN where it is none.
function typedIn({ key, box, factor }) {
  if (FIELDS[key].infinite && INFINITE.test(box.value)) return FIELDS[key].high;
  return box.value.trim() ? Number(box.value.replace(",", ".")) / factor : NaN;
}

// Why what is typed is not taken, or nothing.
function faultOf(row) {
  const { key, name, spec, factor, unit } = row;
  const { low, high, whole, infinite } = FIELDS[key];
  const value = typedIn(row);
  const inside = value >= low - 1e-12 * Math.abs(low) && value <= high + 1e-12 * Math.abs(high);
  if (inside && !(whole && value % 1)) return "";
  const [least, most] = [low, high].map((limit) => short(limit * factor));
  const range = `${whole ? "a whole number, " : ""}${least} to ${infinite ? "∞ (or inf)" : most} ${spec.waves ? english(unit) : spec.said}`.trim();
  const turned = value < 0 && DIRECTED.find((term) => term.name === key);
  return `${name} is ${range}${turned ? `; for the other sign turn its angle by ${180 / turned.m}°` : ""}. Still ${textOf(row, row.before, 4)}.`;
}

// Between a value and its place on the slider, which is logarithmic where it has no step.
const placeOf = ({ spec }, value) => (spec.step === null ? Math.log10(value) : value);
const valueAt = ({ spec }, place) => (spec.step === null ? Number((10 ** place).toPrecision(3)) : place);

const ONE_WAY = 8000; // ms that a slider takes through its reach
const STEPS_OF_REACH = 20;

// Runs a slider to and fro through its reach, until anything is touched. Where motion is to be reduced, one step at a time.
export class Play {
  constructor({ controls, button, set, state }) {
    Object.assign(this, { controls, button, set, state });
    this.still = matchMedia("(prefers-reduced-motion: reduce)");
    this.count = 0;
    this.choose([...controls.rows.keys()][0]);
  }

  // The first slider that is shown, where that used last is not.
  follow() {
    const there = (key) => !this.controls.rows.get(key).box.closest("[data-row]:is([hidden], .idle)");
    if (!this.key || there(this.key)) return;
    const key = [...this.controls.rows.keys()].find(there);
    if (key) this.choose(key);
  }

  choose(key) {
    this.stop();
    this.key = key;
    this.button.hidden = !key;
    this.show();
  }

  show() {
    if (!this.key) return;
    const { name } = this.controls.rows.get(this.key);
    const does = this.running ? "Pause" : this.still.matches ? "Step" : "Move";
    this.button.textContent = `${this.running ? "❚❚" : "▶"} ${does}${does === "Step" ? ":" : ""} ${name}`;
    this.button.setAttribute("aria-label", `${does} ${name}`);
    const steps = "one step each time, since your system asks for reduced motion";
    this.button.title = does === "Step" ? `Step: ${steps}` : `${does} ${name} (Escape stops): run the slider used last through its range`;
  }

  press() {
    if (this.running) return this.stop();
    const row = this.controls.rows.get(this.key);
    const [least, most] = row.spec.reach.map((value) => placeOf(row, value));
    const reach = most - least;
    const from = Math.min(most, Math.max(least, placeOf(row, this.state()[this.key])));
    const step = row.spec.step ?? reach / 400;
    const gesture = `play ${++this.count}`;
    // Up to the end, and back: the way gone counts from the least of the slider.
    const go = (way) => {
      const along = way % (2 * reach);
      const place = least + Math.min(along, 2 * reach - along);
      const value = row.spec.step === null ? place : least + Math.round((place - least) / step) * step;
      this.set({ [this.key]: Number(valueAt(row, value).toPrecision(12)) }, true, gesture);
    };
    if (this.still.matches) {
      this.way = this.stepped === this.key ? this.way + reach / STEPS_OF_REACH : from - least + reach / STEPS_OF_REACH;
      this.stepped = this.key;
      return go(this.way);
    }
    this.running = true;
    this.show();
    const begin = performance.now();
    const turn = (now) => {
      if (!this.running) return;
      go(from - least + (Math.max(0, now - begin) / ONE_WAY) * reach);
      this.raf = requestAnimationFrame(turn);
    };
    this.raf = requestAnimationFrame(turn);
    return undefined;
  }

  stop() {
    cancelAnimationFrame(this.raf);
    if (!this.running) return;
    this.running = false;
    this.show();
  }
}
