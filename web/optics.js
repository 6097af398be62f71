// From what the controls say to what the core is asked: the only place with physics. Lengths in micrometres. White light is lines
// of equal energy, whose paths of light are the same.

import { DIRECTED, WHITE } from "./fields.js";

const TURN = 2 * Math.PI;

// One lambda*N of the reference.
export function unitOfLength(state) {
  return state.wavelength * 1e-3 * state.f_number;
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

// Terms that depend on the direction, {n, m, powers, size, angle}, waves at the edge and degrees; powers of rho with factors.
export function directed(state) {
  return DIRECTED.map((term) => ({ ...term, size: state[term.name], angle: state[`${term.name}_angle`] })).filter(
    (term) => term.size !== 0,
  );
}

// The radial part of a term at rho, over rho, and its derivative.
function radialOf({ powers }, rho) {
  let over = 0;
  let slope = 0;
  for (const [power, factor] of powers) {
    const part = factor * rho ** (power - 1);
    over += part;
    slope += power * part;
  }
  return { over, slope };
}

// Zernike terms [n, m, radians at the edge].
export function termsOf(state) {
  const { defocus, spherical } = state;
  const terms = [
    [2, 0, TURN * 0.5 * (defocus + spherical)],
    [4, 0, (TURN * spherical) / 6],
  ];
  for (const { n, m, size, angle } of directed(state)) {
    const turn = (m * angle * Math.PI) / 180;
    terms.push([n, m, TURN * size * Math.cos(turn)], [n, -m, TURN * size * Math.sin(turn)]);
  }
  return terms.filter(([, , c]) => c !== 0);
}

// Waves at points of the pupil, rho and theta; 0 in the middle.
export function waves(state) {
  const others = directed(state).map((term) => ({ ...term, turn: (term.angle * Math.PI) / 180 }));
  return (rho, theta) => {
    const t = rho * rho;
    let sum = (state.defocus + state.spherical * t) * t;
    for (const term of others) sum += term.size * radialOf(term, rho).over * rho * Math.cos(term.m * (theta - term.turn));
    return sum;
  };
}

// How far from the axis rays arrive at most, in v: the longest gradient of the phase, by samples, a little too small.
export function rayReach(state) {
  let most = 0;
  const terms = directed(state).map((term) => ({ ...term, turn: (term.angle * Math.PI) / 180 }));
  const angles = terms.length ? 48 : 1;
  for (let i = 0; i <= 24; i++) {
    const rho = state.obscuration + ((1 - state.obscuration) * i) / 24;
    const t = rho * rho;
    const others = terms.map((term) => ({ ...term, ...radialOf(term, rho) }));
    for (let k = 0; k < angles; k++) {
      const theta = (TURN * k) / angles;
      let outward = (2 * state.defocus + 4 * state.spherical * t) * rho;
      let around = 0;
      for (const { m, size, turn, over, slope } of others) {
        outward += size * slope * Math.cos(m * (theta - turn));
        around -= size * over * m * Math.sin(m * (theta - turn));
      }
      most = Math.max(most, outward * outward + around * around);
    }
  }
  return TURN * Math.sqrt(most);
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
  const seidel = [];
  if (state.defocus) seidel.push(`W020=${state.defocus}`);
  if (state.spherical) seidel.push(`W040=${state.spherical}`);
  lines.push(seidel.length ? `wavefront = lm.Wavefront.from_seidel(${seidel.join(", ")})` : "wavefront = lm.Wavefront()");
  for (const { n, m, size, angle } of directed(state)) {
    const term = `lm.Wavefront.zernike({(${n}, ${m}): ${size}}, unit="waves", normalization="edge")`;
    lines.push(`wavefront += ${term}${angle ? `.rotated(${(angle * Math.PI) / 180})` : ""}`);
  }
  const pupil = ["wavefront"];
  if (state.obscuration) pupil.push(`obscuration=${state.obscuration}`);
  pupil.push(`wavelength=${metres(state.wavelength, -9)}`, `f_number=${state.f_number}`);
  lines.push(`pupil = lm.Pupil(${pupil.join(", ")})`);
  const asked = ["pupil", String(side), `pixel=${metres(pixel, -6)}`];
  if (state.light === "white") {
    const list = WHITE.map((w) => metres(w, -9)).join(", ");
    lines.push(`white = lm.Polychromatic([${list}], [1.0] * ${WHITE.length})`);
    asked.push("method=white");
  }
  if (state.view !== "averaged") asked.push("integrate=False");
  lines.push(`psf = lm.psf(${asked.join(", ")})`);
  return lines.join("\n") + "\n";
}

// A number of another unit as Python writes it in metres, to the last digit.
function metres(value, exponent) {
  const [digits, power] = value.toExponential().split("e");
  return `${digits}e${Number(power) + exponent}`;
}
