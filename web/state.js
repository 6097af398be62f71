// The state of a page: one flat object of numbers and texts. What differs from the defaults goes into links. lommel.page.state lists
// the fields: {initial, low, high}, {initial, choices}, or {initial, terms} of a text of Zernike terms.

import { FIELDS } from "./fields.js";

export const DEFAULTS = Object.freeze(Object.fromEntries(Object.entries(FIELDS).map(([key, field]) => [key, field.initial])));

export const INFINITE = /^\s*\+?(inf(inity)?|∞)\s*$/i;

// What a key takes: its value where it is of the kind, clamped; undefined where it is not.
export function accepted(key, value) {
  if (typeof key !== "string" || !Object.hasOwn(FIELDS, key)) return undefined;
  const field = FIELDS[key];
  if (field.choices) return field.choices.includes(value) ? value : undefined;
  if (field.terms) return furtherTerms(value, field) && value;
  if (field.infinite && INFINITE.test(value)) return field.high;
  if (typeof value === "string" && (value.length > 40 || !/^\s*[-+.\d]/.test(value))) return undefined;
  const number = typeof value === "string" ? Number(value) : value;
  if (typeof number !== "number" || Number.isNaN(number)) return undefined;
  const inside = Math.min(field.high, Math.max(field.low, number));
  return field.whole ? Math.round(inside) : inside === 0 ? 0 : inside; // no -0
}

// "4,2:0.05;6,0:-0.01" -> terms [n, m, waves rms]; undefined where one is invalid or occurs twice.
export function furtherTerms(text, { terms, degree, waves } = FIELDS.zernike) {
  if (typeof text !== "string" || text.length > 40 * terms) return undefined;
  const parts = text.split(";").filter(Boolean);
  const found = parts.flatMap((part) => {
    const match = /^(\d{1,2}),(-?\d{1,2}):([-+]?(?:\d+\.?\d*|\.\d+)(?:e[-+]?\d{1,3})?)$/.exec(part);
    const [n, m, c] = (match ?? []).slice(1).map(Number);
    return n >= 1 && n <= degree && Math.abs(m) <= n && (n - m) % 2 === 0 && Math.abs(c) <= waves ? [[n, m, c]] : [];
  });
  const different = new Set(found.map(([n, m]) => `${n},${m}`)).size;
  return parts.length <= terms && different === parts.length ? found : undefined;
}

export function changed(state, change) {
  const next = { ...state };
  for (const key of Object.keys(change ?? {})) {
    const value = accepted(key, change[key]);
    if (value !== undefined) next[key] = value;
  }
  return next;
}

// Spikes of vanes are as faint as 1e-3 of the brightest point: vanes that come without a scale get a logarithmic one.
export function withSpikes(change, before = DEFAULTS) {
  return Number(change?.vanes) > 0 && !before.vanes && !("stretch" in change) ? { ...change, stretch: "log" } : change;
}

const LONGEST_TEXT = 8000; // that is read

// "#defocus=1&coma=.5" -> [["defocus", "1"], ["coma", ".5"]].
const pairsIn = (text) => String(text).slice(0, LONGEST_TEXT).replace(/^[#?]/, "").split("&").map((part) => part.split("=", 2)).filter((pair) => pair.length === 2);

// "defocus=1&coma=.5" -> change. Of repeated keys the last counts.
export function fromText(text) {
  const change = Object.create(null);
  for (const [key, value] of pairsIn(text)) if (Object.hasOwn(FIELDS, key)) change[key] = decoded(value);
  return change;
}

const OTHER_KEYS = ["name", "without"]; // of links, beside those of states

// What of a change from an address is not taken as it is there, in words.
export function refused(change, address = "", lesson = "") {
  const unknown = pairsIn(address).map(([key]) => key).filter((key) => !Object.hasOwn(FIELDS, key) && !OTHER_KEYS.includes(key));
  const values = Object.keys(change).flatMap((key) => {
    const text = String(change[key]);
    const value = accepted(key, text);
    const { low, high, row } = FIELDS[key];
    if (value === undefined) return [`${key}=${text.slice(0, 40)} is not understood`];
    if (typeof value !== "number" || INFINITE.test(text) || Math.abs(value - text) <= 1e-9 * Math.abs(value)) return [];
    return [`${key} is ${low} to ${high}${row.said ? ` ${row.said}` : row.waves ? " waves" : ""}, so ${value} is shown instead of ${text.slice(0, 40)}`];
  });
  const said = [...(lesson ? [`lesson=${lesson.slice(0, 40)} is unknown`] : []), ...unknown.map((key) => `${key.slice(0, 40)} is unknown`), ...values];
  if (address.length > LONGEST_TEXT) said.push(`of its ${address.length} characters the first ${LONGEST_TEXT} are read`);
  const more = said.length > 3 ? `; and ${said.length - 3} more` : "";
  return said.length ? `Not as in the address: ${said.slice(0, 3).join("; ")}${more}.` : "";
}

// The name of a lens in the fragment of a link, or what is left out of it.
export const wordsIn = (text, key) => decoded(new RegExp(`[#&]${key}=([^&]*)`).exec(text)?.[1] ?? "").slice(0, 200);

function decoded(text) {
  try {
    return decodeURIComponent(text);
  } catch {
    return text;
  }
}

// What differs from the defaults, or from the state that the page starts in without a fragment.
export function toText(state, start = DEFAULTS) {
  return Object.keys(FIELDS)
    .filter((key) => state[key] !== FIELDS[key].initial || state[key] !== start[key] || (key === "stretch" && state.vanes))
    .map((key) => `${key}=${encodeURIComponent(state[key]).replace(/%2C|%3A|%3B/g, decodeURIComponent)}`)
    .join("&");
}

const STEPS_BACK = 200;

// States to go back and forth to. Changes of one gesture are one step.
export class History {
  constructor() {
    this.back = [];
    this.forth = [];
    this.gesture = "";
  }

  note(before, gesture) {
    if (!gesture || gesture !== this.gesture || !this.back.length) {
      this.back.push(before);
      if (this.back.length > STEPS_BACK) this.back.shift();
    }
    this.gesture = gesture;
    this.forth = [];
  }

  undo(now) {
    return this.travel(now, this.back, this.forth);
  }

  redo(now) {
    return this.travel(now, this.forth, this.back);
  }

  travel(now, from, to) {
    if (!from.length) return undefined;
    to.push(now);
    this.gesture = "";
    return from.pop();
  }
}
