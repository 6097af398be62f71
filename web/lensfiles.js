// Lens files and Zernike tables that are opened on the page: the terms of the wavefront, the aperture and the distances, or all
// errors of the file with their lines. Sections, keys and meanings are those of lommel.load_instrument.

import { DIRECTED, FIELDS } from "./fields.js";
import { focused } from "./optics.js";
import { parseToml } from "./toml.js";
import { checkedWavelength, codeVTable, csvTable, listingTable, metresOf, sectionTable, wavesOf } from "./zernikefiles.js";

export const MOST_BYTES = 1e6;
const MOST_FAULTS = 4;

const inWords = (value) => String(JSON.stringify(value) ?? value).slice(0, 60);
const refuse = (wanted, value) => {
  throw new Error(`must be ${wanted}, got ${inWords(value)}`);
};
const real = (value) => (typeof value === "number" && Number.isFinite(value) ? value : refuse("a number", value));
const bounded = (from, to, open = false) => (value) =>
  real(value) >= from && value <= to && !(open && value === to) ? value : refuse(`from ${from} ${open ? "to below" : "to"} ${to}`, value);
const positive = (value) => (real(value) > 0 ? value : refuse("a positive number", value));
const signed = (value) => (Number.isFinite(metresOf(value)) ? metresOf(value) : refuse("a finite length", value));
const distance = (value) => (metresOf(value) > 0 ? metresOf(value) : refuse("a positive length", value));
const extent = (value) => (distance(value) < Infinity ? metresOf(value) : refuse("a finite length", value));
const whole = (from, to) => (value) =>
  Number.isInteger(value) && value >= from && value <= to ? value : refuse(`a whole number from ${from} to ${to}`, value);
const list = (each, least, most) => (value) =>
  Array.isArray(value) && value.length >= least && value.length <= most ? value.map(each) : refuse(`a list of ${least} to ${most}`, value);
const word = (...choices) => (value) => (choices.includes(value) ? value : refuse(`one of ${choices.join(", ")}`, value));
const words = (value) => (typeof value === "string" ? value : refuse("a text in quotes", value));
const truth = (value) => (typeof value === "boolean" ? value : refuse("true or false", value));
const anything = (value) => value;
const ANGLES = { rad: 1, mrad: 1e-3, deg: Math.PI / 180, arcmin: Math.PI / 10800, arcsec: Math.PI / 648000, mas: Math.PI / 648e6 };
const ANGLE = /^\s*([+-]?[\d.]+(?:[eE][+-]?\d+)?)\s*(rad|mrad|deg|arcmin|arcsec|mas)\s*$/;
const TWO_TURNS = 4 * Math.PI + 1e-9; // larger numbers are probably degrees
function angle(value) {
  const found = typeof value === "number" ? [value, value, "rad"] : ANGLE.exec(value);
  if (!found) return refuse('an angle, a number of radians or a text such as "45 deg"', value);
  const radians = real(Number(found[1]) * ANGLES[found[2]]);
  return Math.abs(radians) <= TWO_TURNS ? radians : refuse('within two turns, in radians or a text such as "45 deg"', value);
}
const pitch = (value) => {
  const sides = Array.isArray(value) ? list(extent, 2, 2)(value) : [extent(value)];
  if (sides[0] > 0.1) refuse("at most 0.1 m", value);
  return sides.every((side) => side === sides[0]) ? sides[0] : refuse("one length on this page, whose pixels are square", value);
};
const plainFill = (value) => (inWords(value) === "1" || inWords(value) === "[1,1]" ? 1 : refuse("1 on this page, whose pixels are active all over", value));
// Keys of sections that the page leaves out: their names are checked, not their contents.
const named = (text) => Object.fromEntries(text.split(" ").map((key) => [key, anything]));

const SECTIONS = {
  name: words,
  source: words,
  lens: {
    focal_length: extent,
    f_number: (value) => (real(value) >= 0.5 ? value : refuse("at least 0.5, the limit in air", value)),
    aperture_diameter: extent,
    focus_distance: distance,
    sensor_distance: extent,
    wavelength: (value) => checkedWavelength(metresOf(value)),
    obscuration: bounded(0, 1, true),
    model: word("paraxial", "aplanatic"),
    corrected_for: word("object", "focus"),
    apodization: (value) => (value === "aplanatic" || Array.isArray(value) ? value : bounded(0, 100)(value)),
  },
  aperture: {
    spider: { width: extent, vanes: whole(1, 64), first: angle, angles: list(angle, 1, 64) },
    ellipse: named("a b angle"),
    cat_eye: named("shift radius"),
    mask: named("holds file"),
    telescope: words,
    segments: named("rings gap middle angle piston tip tilt file"),
    clear: anything,
    blocked: anything,
  },
  aberrations: {
    ...Object.fromEntries("defocus spherical W020 W040 W060 W080 W131 W222 W220 W311".split(" ").map((key) => [key, real])),
    spherical_rms: signed,
    field: list(real, 2, 2),
    zernike: anything,
  },
  object: { distance },
  sensor: { pixel: pitch, shape: anything, integrate: truth, fill: plainFill },
  field: {
    ...named("sensor edge order unit normalization direction columns rows file W131 W222 W220 W311"),
    vignetting: named("height shift radius"),
    shading: named("distance height light"),
  },
  colour: named("wavelengths focus_shift lateral heights"),
  channels: named("wavelengths weights filters illuminant tol paths file"),
  report: named("encircled_energy"),
};
const REQUIRED = ["lens.focal_length", "lens.wavelength", "sensor.pixel"];

// The values of a section, checked; faults are added, each with its key and line.
function checkedSection(raw, schema, path, where, faults) {
  const found = {};
  for (const [key, value] of Object.entries(raw)) {
    const name = path ? `${path}.${key}` : key;
    const check = Object.hasOwn(schema, key) ? schema[key] : null;
    const home = Object.keys(SECTIONS).find((section) => typeof SECTIONS[section] === "object" && Object.hasOwn(SECTIONS[section], key));
    try {
      if (!check) throw new Error(`unknown key; ${home ? `it is in [${home}]` : `there are ${Object.keys(schema).join(", ")}`}`);
      if (typeof check === "function") found[key] = check(value);
      else if (value === null || typeof value !== "object" || Array.isArray(value)) throw new Error(`must be a section, [${name}]`);
      else found[key] = checkedSection(value, check, name, where, faults);
    } catch (error) {
      faults.push(`${where(name)}: ${error.message}`);
    }
  }
  return found;
}

// Waves at the edge by term, "n,m", that parts add to.
class Terms extends Map {
  plus(n, m, value) {
    this.set(`${n},${m}`, (this.get(`${n},${m}`) ?? 0) + value);
  }

  // rho^(2k), less its mean: t^k in Legendre polynomials of 2t - 1.
  power(k, value) {
    for (let j = 1, share = (3 * k) / ((k + 1) * (k + 2)); j <= k; j++) {
      this.plus(2 * j, 0, value * share);
      share *= ((2 * j + 3) / (2 * j + 1)) * ((k - j) / (k + j + 2));
    }
  }

  seidel({ W020 = 0, W040 = 0, W060 = 0, W080 = 0, W131 = 0, W222 = 0, W220 = 0, W311 = 0, field: [x, y] = [1, 0] }) {
    const square = x * x + y * y;
    [W020 + (W220 + 0.5 * W222) * square, W040, W060, W080].forEach((w, index) => this.power(index + 1, w));
    const tilt = (2 / 3) * W131 + W311 * square;
    for (const [n, a, b, c] of [[1, tilt * x, tilt * y, 1], [3, (W131 / 3) * x, (W131 / 3) * y, 1], [2, 0.5 * W222 * (x * x - y * y), W222 * x * y, 2]]) {
      this.plus(n, c, a);
      this.plus(n, -c, b);
    }
  }
}

// The path difference of a lens that obeys the sine condition, in radial terms: lommel.optics.wavefront.wavefront.
function addAplanatic(terms, radius, sphere, vergence, wavelength) {
  if (!(radius * Math.abs(sphere) < 1 && radius ** 2 * 2 * Math.abs((sphere + vergence) * vergence) < 1))
    throw new Error("lens.model: aplanatic is not possible with this aperture and these distances");
  const path = (t) => {
    const p = (radius ** 2 * t) / (1 + Math.sqrt(1 - sphere ** 2 * radius ** 2 * t));
    return (2 * p * vergence) / (1 + Math.sqrt(1 + 2 * p * (sphere + vergence) * vergence)) / wavelength;
  };
  // Chebyshev's nodes: the integral of W P_j by the rule of Fejer, exact for polynomials of this degree.
  const count = 96;
  const sums = new Float64Array(31);
  for (let i = 0; i < count; i++) {
    const theta = (Math.PI * (i + 0.5)) / count;
    let weight = 1;
    for (let k = 1; k < count / 2; k++) weight -= (2 * Math.cos(2 * k * theta)) / (4 * k * k - 1);
    const x = Math.cos(theta);
    const value = (weight / count) * path(0.5 + 0.5 * x);
    let [before, here] = [0, 1];
    for (let j = 0; j <= 30; j++) {
      sums[j] += (2 * j + 1) * value * here;
      [before, here] = [here, ((2 * j + 1) * x * here - j * before) / (j + 1)];
    }
  }
  const size = sums.reduce((all, c) => all + Math.abs(c), 0);
  for (let j = 1; j <= 30; j++) if (Math.abs(sums[j]) > 1e-13 * size) terms.plus(2 * j, 0, sums[j]);
}

// {name, source, state, left_out, pending} of a lens file; with the table of Zernike coefficients that it names, if that is open.
function lensOf(raw, where, faults, opened) {
  const { name, source = "", lens = {}, aperture = {}, aberrations = {}, object = {}, sensor = {}, ...others } = checkedSection(raw, SECTIONS, "", where, faults);
  for (const key of REQUIRED) {
    const [section, entry] = key.split(".");
    if (raw[section]?.[entry] === undefined) faults.push(`${where(key)}: is missing`);
  }
  const { spider } = aperture;
  if (spider && raw.aperture.spider.width === undefined) faults.push(`${where("aperture.spider")}: width is missing`);
  if (spider && !(Boolean(spider.vanes) !== Boolean(spider.angles))) faults.push(`${where("aperture.spider")}: needs vanes or angles: one of the two`);
  for (const [one, other, least] of [["f_number", "aperture_diameter", 1], ["focus_distance", "sensor_distance", 0]]) {
    const got = (raw.lens?.[one] !== undefined) + (raw.lens?.[other] !== undefined);
    if (got > 1 || got < least) faults.push(`${where("lens")}: ${least ? "give exactly" : "give at most"} one of ${one} and ${other}`);
  }
  const { focal_length: f, wavelength, obscuration = 0, focus_distance: focus = Infinity } = lens;
  if (focus <= f) faults.push(`${where("lens.focus_distance")}: must exceed the focal length`);
  const { zernike } = aberrations;
  let table = null;
  if (zernike !== undefined) {
    const at = (key) => where(`aberrations.zernike.${key}`);
    if (zernike === null || typeof zernike !== "object" || Array.isArray(zernike)) faults.push(`${where("aberrations.zernike")}: must be a section`);
    else table = zernike.file === undefined ? sectionTable(zernike, at, faults) : opened;
  }
  if (faults.length) return null;

  const diameter = lens.aperture_diameter ?? f / lens.f_number;
  const sensorAt = lens.sensor_distance ?? 1 / (1 / f - 1 / focus);
  const inFocus = 1 / f - 1 / sensorAt; // of the object in focus, 1/m
  const near = Math.abs(inFocus) < 1e-15 / f ? 0 : inFocus;
  if (near < 0 && object.distance === undefined) throw new Error(`${where("object.distance")}: is missing: the sensor lies inside the focal plane, and no object is in focus`);
  const objectAt = object.distance ?? 1 / near;
  const vergence = 1 / sensorAt - 1 / f + 1 / objectAt;
  const terms = new Terms();
  const radius = 0.5 * diameter;
  const aplanatic = lens.model === "aplanatic";
  if (aplanatic) addAplanatic(terms, radius, lens.corrected_for === "focus" ? inFocus : -1 / sensorAt, vergence, wavelength);
  else terms.power(1, (vergence * radius ** 2) / (2 * wavelength));
  const { defocus = 0, spherical = 0, spherical_rms: rms = 0 } = aberrations;
  const balanced = ((6 * Math.sqrt(5) * rms) / wavelength) / (1 - obscuration ** 2) ** 2;
  const own = new Terms(); // of the lens itself, at every distance
  own.seidel(aberrations);
  own.power(1, defocus / Math.PI - (1 + obscuration ** 2) * balanced);
  own.power(2, spherical / (2 * Math.PI) + balanced);
  if (table) for (const [n, m, value] of wavesOf({ ...table, wavelength: table.wavelength ?? wavelength }, wavelength)) own.plus(n, m, value);
  for (const [key, value] of own) terms.plus(...key.split(",").map(Number), value);
  const leftOut = [];
  const vanes = equalVanes(spider, radius);
  const pending = typeof zernike?.file === "string" && !table;
  if (pending) leftOut.push(`the Zernike table ${zernike.file}, which can be opened after this file`);
  if (spider && !vanes) leftOut.push("the spider");
  const parts = { vignetting: ["ellipse", "cat_eye"], stop: ["telescope", "segments", "clear", "blocked"], mask: ["mask"] };
  for (const [part, keys] of Object.entries(parts)) if (keys.some((key) => Object.hasOwn(aperture, key))) leftOut.push(`the ${part}`);
  if (lens.apodization && inWords(lens.apodization) !== "[]") leftOut.push("the apodization");
  if (others.colour) leftOut.push("colour aberrations");
  if (others.field) leftOut.push("aberrations of the field");
  // With distances nearer than infinity the page has sliders; the aberrations are then those of the lens itself.
  const focusAt = lens.sensor_distance === undefined ? focus : near === 0 ? Infinity : 1 / near;
  const placed = Math.min(focusAt, objectAt) < FARTHEST_OBJECT && focusAt > 0 && !aplanatic;
  const state = {
    ...(placed
      ? { focus: "distances", focus_distance: Math.min(focusAt, FARTHEST_OBJECT), object_distance: Math.min(objectAt, FARTHEST_OBJECT) }
      : { focus: "waves" }),
    f_number: (placed ? f : sensorAt) / diameter,
    focal_length: f * 1e3,
    obscuration,
    wavelength: wavelength * 1e9,
    pixel: sensor.pixel * 1e6,
    ...vanes,
  };
  return { name, source, pending, ...withWavefront(state, placed ? own : terms, leftOut) };
}

const FARTHEST_OBJECT = 1e12; // metres, which stands for infinity

// The vanes of a spider at equal angles; null where there are none, and for others.
function equalVanes(spider, radius) {
  if (!spider) return null;
  const width = spider.width / radius;
  if (!(width < 2)) throw new Error("aperture.spider.width: must be below the diameter of the aperture");
  const turn = 2 * Math.PI;
  const angles = spider.angles ?? Array.from({ length: spider.vanes }, (_, k) => (spider.first ?? 0) + (turn * k) / spider.vanes);
  const first = angles.reduce((least, at) => (Math.abs(at) < Math.abs(least) ? at : least));
  const steps = angles.map((at) => ((at - first) * angles.length) / turn);
  const places = new Set(steps.map((step) => ((Math.round(step) % angles.length) + angles.length) % angles.length));
  if (angles.length > FIELDS.vanes.high || steps.some((step) => Math.abs(step - Math.round(step)) > 1e-9) || places.size < angles.length) return null;
  const degrees = (first * 360) / turn;
  return { vanes: angles.length, vane_width: width, vane_angle: degrees - 360 * Math.round(degrees / 360) };
}

// {state, left_out} of a state and its terms by "n,m", waves at the edge: as lommel.page.state.state_of has them.
function withWavefront(given, terms, leftOut = []) {
  const left = new Map(terms);
  const take = (key) => {
    const value = left.get(key) ?? 0;
    left.delete(key);
    return value;
  };
  left.delete("0,0");
  const spherical = 6 * take("4,0");
  const state = { ...given, spherical };
  // W020 of the Zernike terms; with distances the page has no slider for it.
  if (state.focus === "distances") left.set("2,0", (left.get("2,0") ?? 0) - 0.5 * spherical);
  else state.defocus = 2 * take("2,0") - spherical;
  for (const { name, n, m } of DIRECTED) {
    const [along, across] = [take(`${n},${m}`), take(`${n},${-m}`)];
    state[name] = Math.hypot(along, across);
    state[`${name}_angle`] = (Math.atan2(across, along) * 180) / Math.PI / m;
  }
  for (const [key, value] of Object.entries(state)) {
    if (typeof value !== "number") continue;
    const { low, high, row } = FIELDS[key];
    const unit = row.waves ? "waves" : row.said;
    if (!(value >= low && value <= high))
      throw new Error(`${key} must be ${[`from ${low} to ${high}`, unit].filter(Boolean).join(" ")} on this page, got ${Number(value.toPrecision(4))}`);
    state[key] = nine(value);
  }
  const { terms: most, degree, waves } = FIELDS.zernike;
  const all = [...left].map(([key, value]) => {
    const [n, m] = key.split(",").map(Number);
    return { n, m, rms: value / Math.sqrt((n + 1) * (m ? 2 : 1)) };
  });
  const fits = ({ n, rms }) => Math.abs(rms) > 1e-10 && Math.abs(rms) <= waves && n <= degree;
  const kept = all.filter(fits).sort((a, b) => Math.abs(b.rms) - Math.abs(a.rms)).slice(0, most);
  const lost = Math.hypot(...all.filter((term) => !kept.includes(term)).map(({ rms }) => rms));
  if (lost > 1e-9) leftOut.unshift(`further Zernike terms, ${lost.toPrecision(1)} waves rms`);
  state.zernike = kept.sort((a, b) => a.n - b.n || a.m - b.m).map(({ n, m, rms }) => `${n},${m}:${nine(rms)}`).join(";");
  return { state, left_out: leftOut.join("; ") };
}

const nine = (value) => Number(value.toPrecision(9));

// The state with the wavefront of a table instead of its own; waves are those of the table's wavelength, if it states one.
function withTable(state, table) {
  const at = table.wavelength ?? state.wavelength * 1e-9;
  const terms = wavesOf({ ...table, wavelength: at }, at).map(([n, m, value]) => [`${n},${m}`, value]);
  return withWavefront({ ...focused(state), wavelength: at * 1e9 }, terms);
}

// The text of a file: UTF-8 or UTF-16 by its mark, else Latin-1.
export function decodedText(bytes) {
  const mark = bytes[0] === 0xff && bytes[1] === 0xfe ? "utf-16le" : bytes[0] === 0xfe && bytes[1] === 0xff ? "utf-16be" : "utf-8";
  let text = "";
  try {
    text = new TextDecoder(mark, { fatal: true }).decode(bytes);
  } catch {
    text = new TextDecoder("latin1").decode(bytes);
  }
  return text.replace(/\r\n?/g, "\n");
}

// {name, source, state, left_out} of a file by its name and text; all errors in one message. A table of Zernike coefficients is the
// wavefront of the lens in the given state, or of the lens file that names one, {name, text}.
export function readFile(name, text, given, waiting = null) {
  const suffix = /\.([a-z]+)$/i.exec(name)?.[1].toLowerCase() ?? "";
  const faults = [];
  let found = null;
  try {
    if (text.length > MOST_BYTES) throw new Error(`has ${text.length} characters; the limit is ${MOST_BYTES}`);
    if (!Object.hasOwn(READERS, suffix)) throw new Error(`must end in .${Object.keys(READERS).join(", .")}: a lens file or a Zernike table`);
    found = READERS[suffix](text, faults);
    if (found?.terms && !faults.length) {
      if (waiting) found = { name: waiting.name, ...structured(waiting.text, faults, found) };
      else found = { name: name.slice(0, 80), source: "", ...withTable(given, found) };
    }
  } catch (error) {
    faults.push(error.message);
  }
  if (faults.length) {
    const more = faults.length > MOST_FAULTS ? `; and ${faults.length - MOST_FAULTS} more` : "";
    throw new Error(`${(name || "The file").slice(0, 60)}: ${faults.slice(0, MOST_FAULTS).join("; ")}${more}.`);
  }
  return { ...found, name: found.name || name.replace(/\.toml$/i, ""), waiting: found.pending ? { name, text } : null };
}

const READERS = {
  toml: structured,
  json: (text, faults) => sectionTable(parsedJson(text), (key) => key, faults),
  csv: csvTable,
  txt: (text, faults) => (/^\s*(Listing of|Using)\b/im.test(text) ? listingTable : csvTable)(text, faults),
  int: codeVTable,
  zfr: codeVTable,
};
export const SUFFIXES = Object.keys(READERS).map((suffix) => `.${suffix}`);

function structured(text, faults, opened = null) {
  const { root, lines } = parseToml(text);
  const where = (path) => {
    for (let at = path; at; at = at.slice(0, Math.max(0, at.lastIndexOf(".")))) if (lines.has(at)) return `${path} (line ${lines.get(at)})`;
    return path;
  };
  if (!root.lens && ["focal_length", "wavelength", "pixel"].some((key) => Object.hasOwn(root, key)))
    throw new Error("has no sections; expected are [lens] and [sensor], each on a line of its own before its keys, such as [lens] above focal_length = \"50 mm\"");
  if (root.objective && !root.lens) throw new Error("describes a microscope, [objective]; this page takes lenses, [lens]");
  return root.terms && !root.lens ? sectionTable(root, where, faults) : lensOf(root, where, faults, opened);
}

function parsedJson(text) {
  const root = JSON.parse(text);
  if (root === null || typeof root !== "object" || Array.isArray(root)) throw new Error("must hold an object");
  return root;
}
