// The state of a page: one flat object of numbers and short words. What differs from the defaults goes into links. What there is,
// {initial, low, high} or {initial, choices}, lommel.page.state lists.

import { FIELDS } from "./fields.js";

export const DEFAULTS = Object.freeze(Object.fromEntries(Object.entries(FIELDS).map(([key, field]) => [key, field.initial])));

// What a key takes: its value where it is of the kind, clamped; undefined where it is not.
export function accepted(key, value) {
  if (typeof key !== "string" || !Object.hasOwn(FIELDS, key)) return undefined;
  const field = FIELDS[key];
  if (field.choices) return field.choices.includes(value) ? value : undefined;
  if (typeof value === "string" && (value.length > 40 || !/^\s*[-+.\d]/.test(value))) return undefined;
  const number = typeof value === "string" ? Number(value) : value;
  if (typeof number !== "number" || Number.isNaN(number)) return undefined;
  const inside = Math.min(field.high, Math.max(field.low, number));
  return key === "side" ? Math.round(inside) : inside === 0 ? 0 : inside; // no -0
}

export function changed(state, change) {
  const next = { ...state };
  for (const key of Object.keys(change ?? {})) {
    const value = accepted(key, change[key]);
    if (value !== undefined) next[key] = value;
  }
  return next;
}

// "defocus=1&coma=.5" -> change. Of repeated keys the last counts.
export function fromText(text) {
  const change = Object.create(null);
  for (const part of String(text).slice(0, 4000).replace(/^[#?]/, "").split("&")) {
    const [key, value] = part.split("=", 2);
    if (Object.hasOwn(FIELDS, key) && value !== undefined) change[key] = decoded(value);
  }
  return change;
}

function decoded(text) {
  try {
    return decodeURIComponent(text);
  } catch {
    return text;
  }
}

export function toText(state) {
  return Object.keys(FIELDS)
    .filter((key) => state[key] !== FIELDS[key].initial)
    .map((key) => `${key}=${encodeURIComponent(state[key])}`)
    .join("&");
}
