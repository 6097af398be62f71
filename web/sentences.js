// What is said in words: numbers in the line below the pictures, and sentences for those who do not see these.

import { powerOfTen } from "./draw.js";
import { short } from "./plots.js";
import { lengthUnit, wavesUnit } from "./units.js";

export function plain(value, digits = 3) {
  if (!Number.isFinite(value)) return "–";
  if (value !== 0 && Math.abs(value) < 1e-4) {
    const [mantissa, power] = value.toExponential(1).split("e");
    return `${mantissa} · ${powerOfTen(Number(power))}`;
  }
  return short(value, digits);
}

const fixed = (value) => (Math.abs(value) >= 1e-4 || value === 0 ? value.toFixed(4) : plain(value));
const percent = (share) => `${(100 * share).toFixed(share > 0.9995 ? 2 : 1)} %`;

// {key: [text, number]} of what the line of numbers shows.
export function numbersSaid(state, psf, measures) {
  const said = {};
  if (measures) {
    const { factor, name } = lengthUnit(state);
    const wide = measures.d80 === null ? NaN : measures.d80 * factor;
    said.strehl = [fixed(measures.strehl), measures.strehl];
    said.largest = [fixed(measures.peak_strehl), measures.peak_strehl];
    said.d80 = [measures.d80 === null ? "beyond the window" : `${short(wide)} ${name}`, wide];
    said.inside = [percent(measures.inside), measures.inside];
  }
  if (psf) {
    said.bound = [`≤ ${plain(psf.bound, 2)}`, NaN];
    said.time = [`${psf.ms < 10 ? psf.ms.toFixed(1) : Math.round(psf.ms)} ms`, NaN];
  }
  return said;
}

// How B differs from A, where both are numbers.
export function differenceSaid(now, held) {
  if (!Number.isFinite(now) || !Number.isFinite(held)) return "";
  const by = now - held;
  if (by === 0) return "as A";
  return `${by < 0 ? "−" : "+"}${plain(Math.abs(by))} from A`;
}

export function psfSaid(state, psf, measures) {
  const unit = lengthUnit(state);
  const field = short(psf.side * psf.pixel * unit.factor, 3);
  const wide = measures.d80 === null ? "" : short(measures.d80 * unit.factor, 3);
  const spot = wide ? `80 % of the light within ${wide} ${unit.said} across` : "a spot wider than the window";
  const bright = `Strehl on the axis ${fixed(measures.strehl)}, brightest point ${fixed(measures.peak_strehl)}`;
  return `Point spread function over ${field} ${unit.said}: ${spot}; ${bright}.`;
}

export function wavefrontSaid(state, seen) {
  const { factor, name } = wavesUnit(state);
  return `${short((seen.high - seen.low) * factor, 3)} ${name} P–V, ${short(seen.rms * factor, 3)} rms`;
}

export function plotSaid(title, x, curves) {
  const ends = curves.filter((curve) => curve.name && curve.y.length).map((curve) => {
    const half = curve.y.findIndex((value) => (title === "Encircled energy" ? value >= 0.5 : value <= 0.5 * curve.y[0]));
    return half > 0 ? `${curve.name} passes one half at ${short(curve.x[half], 3)} ${x.unit}` : curve.name;
  });
  return `${title}: ${ends.join("; ")}.`;
}
