// What numbers are shown in: factors from the units of the state, and their names.

import { unitOfLength } from "./optics.js";

export const WAVES_UNITS = { waves: "waves", rad: "radians", nm: "nanometres" };
export const LENGTH_UNITS = { um: "micrometres", arcsec: "arcseconds", lambdaN: "λN" };

export function wavesUnit({ waves_unit, wavelength }) {
  return {
    waves: { factor: 1, name: "waves" },
    rad: { factor: 2 * Math.PI, name: "rad" },
    nm: { factor: wavelength, name: "nm" },
  }[waves_unit];
}

// A number and its unit: "1 wave", "2 waves".
export const withUnit = (text, name) => `${text} ${name === "waves" && /^[-−]?1$/.test(text) ? "wave" : name}`;

// After a number; seconds of arc follow without a space.
export const unitAfter = (name) => (name === "″" ? name : ` ${name}`);

// From micrometres on the sensor.
export function lengthUnit(state) {
  return {
    um: { factor: 1, name: "µm", said: "micrometres" },
    arcsec: { factor: 206.264806247 / state.focal_length, name: "″", said: "arcseconds" },
    lambdaN: { factor: 1 / unitOfLength(state), name: "λN", said: "lambda N" },
  }[state.length_unit];
}

// From cycles per millimetre on the sensor.
export function frequencyUnit(state) {
  const { factor, name } = lengthUnit(state);
  return state.length_unit === "um" ? { factor: 1, name: "cycles/mm" } : { factor: 0.001 / factor, name: `cycles/${name}` };
}
