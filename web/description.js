// How a PSF was made, as the package writes it into files: its own reader takes it, checksum and all.

import { crc32 } from "./checksum.js";
import { WHITE } from "./fields.js";
import { focused, linesOf, pythonFloat, termsOf, unitOfLength, vanesOf } from "./optics.js";

// JSON as Python writes it, with keys in order and the digits of its floats, so that checksums agree.
export function pythonJson(value, sorted) {
  if (Array.isArray(value)) return `[${value.map((part) => pythonJson(part, sorted)).join(", ")}]`;
  if (value instanceof Float) return value.text;
  if (value !== null && typeof value === "object") {
    const keys = sorted ? Object.keys(value).sort() : Object.keys(value);
    return `{${keys.map((key) => `${JSON.stringify(key)}: ${pythonJson(value[key], sorted)}`).join(", ")}}`;
  }
  return JSON.stringify(value);
}

class Float {
  constructor(value) {
    this.text = pythonFloat(value);
  }
}

export function describedPsf(given, psf) {
  const state = focused(given);
  const float = (value) => new Float(value);
  const { side, pixel, bound, area, values } = psf;
  const terms = termsOf(state).map(([n, m, c]) => [n, m, float(c)]);
  const lengthOf = unitOfLength(state);
  const shape = [side, side];
  const said = {
    software: "lommel live",
    pupil: {
      wavefront: { terms },
      obscuration: float(state.obscuration),
      wavelength: float(state.wavelength * 1e-9),
      f_number: float(state.f_number),
      apodization: float(0),
      geometry: null,
      ...(state.vanes ? { spider: { name: "Spider", width: float(state.vane_width), angles: vanesOf(state).map(float) } } : {}),
    },
    method: methodOf(state, float),
    sampling: state.view === "averaged" ? "pixel" : "center",
    normalize: "energy",
    pixel: float(pixel * 1e-6),
    center: [float(side >> 1), float(side >> 1)],
    integrate: state.view === "averaged",
    unit: "m",
    error_bound: bound === null ? null : float(bound),
    derivative_bounds: {},
    scale: float(((pixel / lengthOf) ** 2 * Math.PI) / 4 / area),
    shape,
    dtype: "float32",
  };
  const plain = new Uint8Array(values.buffer, values.byteOffset, values.byteLength);
  const text = (value) => new TextEncoder().encode(value);
  const sum = crc32(plain, crc32(text("values"), crc32(text(pythonJson(said, true)))));
  return pythonJson({ ...said, checksum: `crc32 ${sum.toString(16).padStart(8, "0")}` }, false);
}

function methodOf(state, float) {
  if (state.light !== "white") return { name: state.vanes ? "NonuniformFFT" : "NijboerZernike", tol: float(1e-6) };
  const wavelengths = WHITE.map((line) => float(line * 1e-9));
  const weights = linesOf(state).map(([, share]) => float(share));
  return { name: "Polychromatic", wavelengths, weights, method: null, tol: float(1e-6) };
}
