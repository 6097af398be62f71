// The controls: each a label, a number box and a slider, all native inputs. What they hold is the state alone.

import { el, menu, unique } from "./dom.js";
import { short } from "./plots.js";
import { FIELDS } from "./fields.js";
import { LENGTH_UNITS, WAVES_UNITS, wavesUnit } from "./units.js";

// [title, rows or pairs of a size and its direction], in the order of FIELDS. lommel.page.state lists the contents of rows.
const GROUPS = [];
for (const [key, { row }] of Object.entries(FIELDS)) {
  if (!row || (key.endsWith("_angle") && Object.hasOwn(FIELDS, key.slice(0, -6)))) continue;
  if (GROUPS.at(-1)?.[0] !== row.group) GROUPS.push([row.group, []]);
  GROUPS.at(-1)[1].push(Object.hasOwn(FIELDS, `${key}_angle`) ? [key, `${key}_angle`] : key);
}

const LIGHTS = { mono: "one wavelength", white: "white light" };

export class Controls {
  // set(change, moving) is told of every change; `only` lists the keys to show, or is empty for all.
  constructor({ state, set, only = [], level = 2 }) {
    this.set = set;
    this.rows = new Map();
    const shows = (key) => !only.length || only.includes(key);
    const groups = GROUPS.map(([title, entries]) => {
      const rows = entries.map((entry) => this.entry(entry, state, shows)).filter(Boolean);
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
    if (title === "Wavefront" && shows("waves_unit")) {
      this.waves = menu("Unit of the wavefront", WAVES_UNITS, state.waves_unit, (waves_unit) => this.set({ waves_unit }), { "data-key": "waves_unit" });
      return [el("div", { class: "inline" }, el("span", { "data-word": "edge" }, "at the edge, in"), this.waves)];
    }
    if (title === "Lens and light" && shows("light")) {
      this.light = menu("Light", LIGHTS, state.light, (light) => this.set({ light }), { "data-key": "light" });
      return [el("div", { class: "inline" }, this.light)];
    }
    if (title === "Sensor" && shows("length_unit")) {
      this.length = menu("Unit of lengths", LENGTH_UNITS, state.length_unit, (length_unit) => this.set({ length_unit }), { "data-key": "length_unit" });
      return [el("div", { class: "inline" }, el("span", {}, "lengths in"), this.length)];
    }
    return [];
  }

  row(key, state) {
    const spec = FIELDS[key].row;
    const id = unique(key);
    const name = spec.name ?? spec.label;
    const hint = "Double click, or Delete, for the default";
    const slider = el("input", { type: "range", "aria-label": name, "data-key": key, title: hint });
    const box = el("input", { type: "number", id, "data-key": key, inputmode: "decimal", autocomplete: "off", step: "any" });
    const unit = el("span", { class: "unit" }, spec.unit ?? "");
    const row = { key, spec, slider, box, unit, name, dragging: false };
    const reset = () => this.set({ [key]: FIELDS[key].initial });
    slider.addEventListener("pointerdown", () => (row.dragging = true));
    for (const end of ["pointerup", "pointercancel", "blur", "lostpointercapture"])
      slider.addEventListener(end, () => (row.dragging = false));
    slider.addEventListener("input", () => {
      const at = slider.valueAsNumber;
      this.set({ [key]: spec.step === null ? Number((10 ** at).toPrecision(3)) : at }, true);
    });
    slider.addEventListener("dblclick", reset);
    slider.addEventListener("keydown", (event) => {
      if (event.key === "Delete" || event.key === "Backspace") reset();
    });
    box.addEventListener("input", () => {
      this.edited = box;
      if (Number.isFinite(box.valueAsNumber)) this.set({ [key]: box.valueAsNumber / row.factor }, true);
    });
    const written = () => {
      this.edited = row.shown = undefined;
      this.update(this.state);
    };
    for (const end of ["change", "blur"]) box.addEventListener(end, written);
    const label = el("label", { for: id, title: hint, ondblclick: reset }, spec.label);
    this.rows.set(key, row);
    return el("div", { class: "row", "data-row": key }, el("div", { class: "line" }, label, box, unit), slider);
  }

  // Whether a box holds what is not taken yet.
  typing() {
    return Boolean(this.edited);
  }

  update(state) {
    this.state = state;
    const waves = wavesUnit(state);
    for (const row of this.rows.values()) this.show(row, state, row.spec.waves ? waves : { factor: 1, name: row.spec.unit });
    const menus = { waves_unit: this.waves, light: this.light, length_unit: this.length };
    for (const [key, node] of Object.entries(menus)) if (node) node.value = state[key];
    for (const { spec, box } of this.rows.values())
      box.closest("[data-row]").hidden = spec.when.length > 0 && !spec.when.some(([key, ...values]) => values.includes(state[key]));
  }

  show(row, state, { factor, name }) {
    const value = state[row.key];
    const print = `${value} ${factor}`;
    if (print === row.shown) return;
    row.shown = print;
    row.factor = factor;
    const { slider, box, spec } = row;
    if (!row.dragging) this.range(row, value);
    slider.value = spec.step === null ? Math.log10(value) : value;
    const text = short(value * factor, 6);
    if (this.edited !== box) box.value = text; // else when the typing is over
    row.unit.textContent = name;
    slider.setAttribute("aria-valuetext", `${text} ${spec.waves ? name : spec.said}`.trim());
    const said = spec.waves ? `${row.name}, ${name}` : [row.name, spec.said].filter(Boolean).join(", ");
    if (box.getAttribute("aria-label") !== said) box.setAttribute("aria-label", said);
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
