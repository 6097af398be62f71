// The state of a page: one flat object of numbers and short words. What differs from the defaults goes into links.

const real = (initial, low, high) => ({ initial, low, high });
const word = (...choices) => ({ initial: choices[0], choices });

export const FIELDS = {
  defocus: real(0.6, -50, 50),
  spherical: real(0, -25, 25),
  coma: real(0, 0, 10),
  coma_angle: real(0, -180, 180),
  astigmatism: real(0, 0, 10),
  astigmatism_angle: real(0, -90, 90),
  trefoil: real(0, 0, 10),
  trefoil_angle: real(0, -60, 60),
  f_number: real(4, 0.7, 100),
  obscuration: real(0, 0, 0.9),
  wavelength: real(550, 200, 2000),
  light: word("mono", "white"),
  pixel: real(2, 0.05, 50),
  view: word("fine", "sampled", "averaged"),
  side: real(512, 16, 1024),
  focal_length: real(50, 0.1, 1e6),
  stretch: word("sqrt", "linear", "log"),
  map: word("inferno", "viridis", "cividis", "gray"),
  waves_unit: word("waves", "rad", "nm"),
  length_unit: word("um", "arcsec", "lambdaN"),
  picture: word("star", "bars", "text", "points", "own"),
};

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
