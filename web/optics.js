// Physics of a state: from the settings to the arguments of the core. Lengths in micrometres. White light is lines of equal energy
// with the same optical paths.

import { DIRECTED, WHITE } from "./fields.js";
import { furtherTerms } from "./state.js";

const TURN = 2 * Math.PI;

// The state with defocus in waves and the working f-number: as lm.Lens(...).pupil(object_distance) has them.
export function focused(state) {
  if (state.focus !== "distances") return state;
  const { focal_length, focus_distance, object_distance, wavelength } = state;
  const focal = focal_length * 1e-3;
  if (focus_distance <= focal) {
    const [length, distance] = [focal_length, focus_distance].map((value) => Number(value.toPrecision(6)));
    throw new RangeError(`the focus distance must exceed the focal length of ${length} mm, and is ${distance} m`);
  }
  const sensor = 1 / (1 / focal - 1 / focus_distance);
  const diameter = focal / state.f_number;
  const defocus = ((1 / sensor - 1 / focal + 1 / object_distance) * (0.5 * diameter) ** 2) / (2e-9 * wavelength);
  return { ...state, focus: "waves", defocus, f_number: sensor / diameter };
}

// One lambda*N of the reference.
export function unitOfLength(state) {
  return state.wavelength * 1e-3 * focused(state).f_number;
}

// What a length is in v.
export function stepOf(state, length) {
  return (Math.PI * length) / unitOfLength(state);
}

export function lengthOf(state, v) {
  return (v * unitOfLength(state)) / Math.PI;
}

// Frequency from which no contrast passes, cycles per millimetre.
export function cutoff(state) {
  return 1e3 / unitOfLength(state);
}

// Each line as [reference over its own wavelength, share of the light].
export function linesOf(state) {
  return state.light === "white" ? WHITE.map((w) => [state.wavelength / w, 1 / WHITE.length]) : [[1, 1]];
}

// Zernike terms besides defocus and spherical: {n, m, along, across}, waves at the edge of the cosine and the sine.
export function further(state) {
  const turned = directed(state).map(({ n, m, size, angle }) => {
    const turn = (m * angle * Math.PI) / 180;
    return { n, m, along: size * Math.cos(turn), across: size * Math.sin(turn) };
  });
  const listed = furtherTerms(state.zernike).map(([n, m, rms]) => {
    const edge = rms * Math.sqrt((m === 0 ? 1 : 2) * (n + 1));
    return { n, m: Math.abs(m), along: m < 0 ? 0 : edge, across: m < 0 ? edge : 0 };
  });
  return [...turned, ...listed].filter(({ along, across }) => along !== 0 || across !== 0);
}

// Those of the sliders, {n, m, size, angle}, waves at the edge and degrees.
function directed(state) {
  return DIRECTED.map((term) => ({ ...term, size: state[term.name], angle: state[`${term.name}_angle`] })).filter(
    (term) => term.size !== 0,
  );
}

// Directions of the vanes, radians.
export function vanesOf({ vanes, vane_angle }) {
  return Array.from({ length: vanes }, (_, k) => (vane_angle * Math.PI) / 180 + (TURN * k) / vanes);
}

// Whether light passes at a point of the pupil.
export function clearOf(state) {
  const vanes = vanesOf(state);
  const behind = (rho, turn) => rho * Math.cos(turn) > 0 && Math.abs(rho * Math.sin(turn)) < 0.5 * state.vane_width;
  return (rho, theta) => rho <= 1 && rho >= state.obscuration && !vanes.some((angle) => behind(rho, theta - angle));
}

// The radial part of a term at rho without its constant, over rho, and its derivative.
function radialOf({ n, m }, rho) {
  const [p, q] = [(n + m) / 2, (n - m) / 2];
  let factor = 1;
  for (let k = 1; k <= q; k++) factor *= (p + k) / k;
  let over = 0;
  let slope = 0;
  for (let k = 0, power = n; power > 0 && k <= q; k++, power -= 2) {
    const part = factor * rho ** (power - 1);
    over += part;
    slope += power * part;
    factor *= -((p - k) * (q - k)) / ((k + 1) * (n - k));
  }
  return { over, slope };
}

// Zernike terms [n, m, radians at the edge], with a tilt by which the image moves: x and y in v.
export function termsOf(given, [x, y] = [0, 0]) {
  const state = focused(given);
  const { defocus, spherical } = state;
  const terms = new Map();
  const add = (n, m, c) => terms.set(`${n},${m}`, [n, m, (terms.get(`${n},${m}`)?.[2] ?? 0) + TURN * c]);
  add(2, 0, 0.5 * (defocus + spherical));
  add(4, 0, spherical / 6);
  for (const { n, m, along, across } of further(state)) {
    add(n, m, along);
    if (m) add(n, -m, across);
  }
  add(1, 1, x / TURN);
  add(1, -1, y / TURN);
  return [...terms.values()].filter(([, , c]) => c !== 0);
}

const RADII = 64;
const PARTS_OF_ARC = 32;

// The centroid of the light, x and y in v: the mean gradient of the phase over the clear aperture, by Gauss's rule in the
// area, and Simpson's between vanes.
export function centroidOf(given) {
  const state = focused(given);
  if (!further(state).some(({ m }) => m) && !state.vanes) return [0, 0];
  const slope = slopes(state);
  const arcs = Math.max(1, state.vanes);
  const inner = state.obscuration ** 2;
  let [area, x, y] = [0, 0, 0];
  for (let i = 0; i < RADII; i++) {
    const share = (2 * Math.floor(i / 2) + 1 + (i % 2 ? 1 : -1) / Math.sqrt(3)) / RADII;
    const rho = Math.sqrt(inner + (1 - inner) * share);
    const hidden = state.vanes ? Math.asin(Math.min(1, (0.5 * state.vane_width) / rho)) : 0;
    const step = (TURN / arcs - 2 * hidden) / PARTS_OF_ARC;
    for (let k = 0; step > 0 && k < arcs * (PARTS_OF_ARC + 1); k++) {
      const part = k % (PARTS_OF_ARC + 1);
      const theta = (state.vanes ? (state.vane_angle * Math.PI) / 180 : 0) + (TURN * Math.floor(k / (PARTS_OF_ARC + 1))) / arcs + hidden + part * step;
      const weight = step * (part % PARTS_OF_ARC ? (part % 2 ? 4 : 2) : 1);
      const [outward, around] = slope(rho, theta);
      const [c, s] = [Math.cos(theta), Math.sin(theta)];
      area += weight;
      x += weight * (outward * c - around * s);
      y += weight * (outward * s + around * c);
    }
  }
  return [x / area, y / area];
}

// Waves at points of the pupil, rho and theta; 0 in the middle.
export function waves(given) {
  const state = focused(given);
  const others = further(state);
  return (rho, theta) => {
    const t = rho * rho;
    let sum = (state.defocus + state.spherical * t) * t;
    for (const term of others) sum += radialOf(term, rho).over * rho * around(term, theta)[0];
    return sum;
  };
}

// The angular part of a term, and its derivative.
function around({ m, along, across }, theta) {
  const [c, s] = [Math.cos(m * theta), Math.sin(m * theta)];
  return [along * c + across * s, m * (across * c - along * s)];
}

// The gradient of the phase at points of the pupil, in v: outward and around.
export function slopes(given) {
  const state = focused(given);
  const others = further(state);
  return (rho, theta) => {
    let outward = (2 * state.defocus + 4 * state.spherical * rho * rho) * rho;
    let across = 0;
    for (const term of others) {
      const { over, slope } = radialOf(term, rho);
      const [value, turning] = around(term, theta);
      outward += slope * value;
      across += over * turning;
    }
    return [TURN * outward, TURN * across];
  };
}

// How far from the axis rays arrive at most, in v: the longest gradient of the phase, by samples, a little too small.
export function rayReach(state) {
  const slope = slopes(state);
  const angles = further(state).some(({ m }) => m) ? 48 : 1;
  let most = 0;
  for (let i = 0; i <= 24; i++) {
    const rho = state.obscuration + ((1 - state.obscuration) * i) / 24;
    for (let k = 0; k < angles; k++) most = Math.max(most, Math.hypot(...slope(rho, (TURN * k) / angles)));
  }
  return most;
}

// Half the width of a window that holds what is to be seen, in steps of sqrt(2) so that it does not breathe.
export function fineReach(state) {
  const wanted = lengthOf(state, 1.15 * rayReach(state) + 14);
  return 2 ** (Math.ceil(2 * Math.log2(wanted)) / 2);
}

// How many of the sensor's pixels on each side a spread is known for, and divided by what light it has there, in a picture of such
// a size.
export function spreadReach(state, size) {
  const wanted = (lengthOf(state, 1.15 * rayReach(state) + 30) - 0.5 * state.pixel) / state.pixel;
  return Math.max(1, Math.min(Math.ceil(wanted), 128, size));
}

// The step of pixels in v of the line where it is largest.
export function largestStep(state, pixel) {
  return stepOf(state, pixel) * Math.max(...linesOf(state).map(([stretch]) => stretch));
}

// The pixel of a view of so many pixels a side.
export function pixelOf(state, side) {
  return state.view === "fine" ? (2 * fineReach(state)) / side : state.pixel;
}

// The call of the package that makes the same array.
export function pythonOf(state, side, pixel) {
  const lines = ["import lommel as lm", ""];
  const distances = state.focus === "distances";
  const seidel = [];
  if (state.defocus && !distances) seidel.push(`W020=${state.defocus}`);
  if (state.spherical) seidel.push(`W040=${state.spherical}`);
  lines.push(seidel.length ? `wavefront = lm.Wavefront.from_seidel(${seidel.join(", ")})` : "wavefront = lm.Wavefront()");
  for (const { n, m, size, angle } of directed(state)) {
    const term = `lm.Wavefront.zernike({(${n}, ${m}): ${size}}, unit="waves", normalization="edge")`;
    lines.push(`wavefront += ${term}${angle ? `.rotated(${(angle * Math.PI) / 180})` : ""}`);
  }
  const listed = furtherTerms(state.zernike).map(([n, m, rms]) => `(${n}, ${m}): ${rms}`);
  if (listed.length) lines.push(`wavefront += lm.Wavefront.zernike({${listed.join(", ")}}, unit="waves")`);
  const light = [`wavelength=${metres(state.wavelength, -9)}`];
  if (state.obscuration) light.push(`obscuration=${state.obscuration}`);
  if (state.vanes) {
    const [first] = vanesOf(state);
    light.push(`spider=lm.Spider.equal(${state.vanes}, width=${state.vane_width}${first ? `, first=${first}` : ""})`);
  }
  if (distances) {
    // Of a focal length above 1 m the package takes the diameter for granted, and warns of an f-number.
    const { focal_length, f_number } = state;
    const stop = focal_length > 1000 ? `aperture_diameter=${metres(focal_length / f_number, -3)}` : `f_number=${f_number}`;
    const lens = [`focal_length=${metres(focal_length, -3)}`, stop, `focus_distance=${state.focus_distance}`, ...light];
    if (lines.length > 3 || seidel.length) lens.push("aberrations=wavefront");
    else lines.pop();
    lines.push(`lens = lm.Lens(${lens.join(", ")})`, `pupil = lens.pupil(object_distance=${state.object_distance})`);
  } else lines.push(`pupil = lm.Pupil(${["wavefront", ...light, `f_number=${state.f_number}`].join(", ")})`);
  if (state.view !== "fine" && side < state.side) lines.push(`# The middle of the window of ${state.side} x ${state.side} pixels, whose light the page states.`);
  const asked = ["pupil", String(side), `pixel=${metres(pixel, -6)}`];
  if (state.light === "white") {
    const list = WHITE.map((w) => metres(w, -9)).join(", ");
    lines.push(`white = lm.methods.Polychromatic([${list}], [1.0] * ${WHITE.length})`);
    asked.push("method=white");
  }
  if (state.view !== "averaged") asked.push("integrate=False");
  lines.push(`psf = lm.psf(${asked.join(", ")})`);
  const of = state.view === "averaged" ? 'of="optics"' : ""; // FWHM and diameters of the page are without the pixel
  lines.push(`# As the page states them, in metres: psf.energy_diameter(0.8, ${['about="centroid"', of].filter(Boolean).join(", ")}), psf.fwhm(${of})`);
  return lines.join("\n") + "\n";
}

// A number of another unit as Python writes it in metres, to the last digit.
function metres(value, exponent) {
  const [digits, power] = value.toExponential().split("e");
  return pythonFloat(Number(`${digits}e${Number(power) + exponent}`));
}

// A float of Python: never without a dot or an exponent, whose sign and two digits it always has.
export function pythonFloat(value) {
  const [digits, power] = value.toExponential().split("e").map((part, index) => (index ? Number(part) : part));
  const sign = power < 0 ? "-" : "+";
  if (value !== 0 && (power < -4 || power >= 16)) return `${digits}e${sign}${String(Math.abs(power)).padStart(2, "0")}`;
  if (Number.isInteger(value)) return `${value}.0`;
  return power < 0 ? value.toFixed(Math.min(100, digits.replace(/[-.]/g, "").length - 1 - power)) : String(value);
}
