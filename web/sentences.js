// What is said in words: numbers beside the pictures, read-outs, and sentences for those who do not see these.

import { short } from "./plots.js";
import { lengthUnit, unitAfter, wavesUnit, withUnit } from "./units.js";

// A value in at most four digits, none of them below its proven error: "0.1234", "1.2e-4", "< 3e-7".
export function stated(value, error = 0, digits = 4) {
  if (!Number.isFinite(value)) return "–";
  const size = Math.abs(value);
  if (error > 0 && size < error) return `< ${upwards(error)}`;
  if (size === 0) return "0";
  const justified = error > 0 ? Math.floor(Math.log10(size)) - Math.ceil(Math.log10(error) - 1e-9) + 1 : digits;
  const rounded = Number(value.toPrecision(Math.max(1, Math.min(digits, justified))));
  return Math.abs(rounded) < 1e-3 || Math.abs(rounded) >= 1e7 ? rounded.toExponential().replace("e+", "e") : String(rounded);
}

export const withMinus = (text) => text.replace(/^-/, "−");

// One digit that is not below a bound: 2.1e-7 -> "3e-7".
function upwards(bound) {
  const power = 10 ** Math.floor(Math.log10(bound) + 1e-9);
  return stated(Number((Math.ceil(bound / power - 1e-9) * power).toPrecision(1)));
}

// A ratio that is not negative, with four decimals as long as these are above its error.
export function ratioSaid(value, error = 0) {
  const size = Math.max(0, value);
  return size < 1e-3 || error > 1e-4 ? stated(size, error, 2) : size.toFixed(4);
}

// A share in percent, with one decimal, or as many as what is missing of all takes, if these are above its error: never "100 %" of less.
export function percentSaid(share, error = 0) {
  const value = Math.max(0, 100 * share);
  if (!(error < 1)) return "–"; // nothing is known of it
  if (100 * error > value) return `< ${upwards(100 * error)} %`;
  const missing = 100 - value;
  const least = missing >= 0.05 ? 1 : missing > 0 ? Math.ceil(-Math.log10(missing)) + 1 : 6;
  const digits = Math.max(0, Math.min(6, least, Math.floor(-Math.log10(100 * error || 1e-9))));
  const said = value.toFixed(digits);
  if (Number(said) < 100 || share === 1) return `${said} %`;
  return `> ${(Math.floor((value - 100 * error) * 10 ** digits - 1e-9) / 10 ** digits).toFixed(digits)} %`;
}

const ASSUMED = 1e-6; // error where none is proven

// Errors of the numbers: bounds on those over the unaberrated peak, and about that of the light in the window.
export function errorsOf(psf, measures) {
  return { strehl: measures.strehl_error ?? ASSUMED, largest: psf.bound ?? ASSUMED, inside: measures.inside_error };
}

// {key: {text, value, error}} of what the numbers show; value in the unit that is shown, NaN where there is none to compare.
export function numbersSaid(state, psf, measures) {
  const said = {};
  if (psf && measures) {
    const { factor, name } = lengthUnit(state);
    const { strehl, largest, inside } = errorsOf(psf, measures);
    const wide = measures.d80 === null ? NaN : measures.d80 * factor;
    said.strehl = { text: ratioSaid(measures.strehl, strehl), value: measures.strehl, error: strehl };
    said.largest = { text: ratioSaid(measures.peak_strehl, largest), value: measures.peak_strehl, error: largest };
    const least = 2 * measures.energy.r.at(-1) * factor; // where the curve ends
    if (!Number.isNaN(measures.d80)) said.d80 = { text: `${measures.d80 === null ? `more than ${short(least, 2)}` : short(wide)}${unitAfter(name)}`, value: wide, error: 0, unit: name };
    const { fwhm } = measures;
    if (fwhm) said.fwhm = { text: `${short(fwhm * factor, 3)}${unitAfter(name)}`, value: fwhm * factor, error: 2e-3 * fwhm * factor, unit: name };
    said.inside = { text: percentSaid(measures.inside, inside), value: 100 * measures.inside, error: 100 * inside, unit: "points" };
  }
  if (psf) {
    said.bound = { text: psf.bound === null ? "none" : `≤ ${stated(psf.bound, 0, 2)}`, value: NaN };
    said.time = { text: `${psf.ms < 10 ? psf.ms.toFixed(1) : Math.round(psf.ms)} ms`, value: NaN };
  }
  return said;
}

// How B differs from A, where both are numbers; shares of light in percentage points.
export function differenceSaid(now, held) {
  if (!Number.isFinite(now.value) || !Number.isFinite(held?.value)) return "";
  const by = now.value - held.value;
  if (Math.abs(by) <= now.error + held.error || Math.abs(by) < 1e-12) return "as A";
  const size = now.unit === "points" ? Number(Math.abs(by).toFixed(Math.abs(by) < 0.1 ? 2 : 1)) : stated(Math.abs(by), now.error + held.error, 2);
  return `${by < 0 ? "−" : "+"}${size}${now.unit ? unitAfter(now.unit) : ""} from A`;
}

// What of the window is computed, where that is less than is set.
export function computedSaid(state, { side }) {
  if (side >= state.side) return "";
  const size = (count) => `${count} × ${count}`;
  return state.view === "fine" ? `while it moves ${size(side)} samples` : `computed: ${size(side)} of ${size(state.side)} pixels`;
}

// Why there is no bound, where there is none.
export function unprovenSaid({ vanes }, psf) {
  if (!psf || psf.bound !== null) return "";
  const what = vanes ? "with vanes" : "with aberrations this large";
  return `No bound is proven ${what}: the page integrates along rows of the aperture. The call “As Python” states one.`;
}

export function psfSaid(state, psf, measures) {
  const unit = lengthUnit(state);
  const field = short(psf.side * psf.pixel * unit.factor, 3);
  const [most, wide] = measures.d80 === null ? ["less than ", 2 * measures.energy.r.at(-1)] : ["", measures.d80];
  const spot = `${most}80 % of the light within ${short(wide * unit.factor, 3)} ${unit.said} across`;
  const { strehl, largest } = numbersSaid(state, psf, measures);
  const bright = `Strehl ratio on the axis ${strehl.text}, brightest point ${largest.text}`;
  return `Point spread function over ${field} ${unit.said}: ${spot}; ${bright}.`;
}

// The value of the PSF at a place (in its pixels from the middle), over the brightest point and over the unaberrated peak.
export function valueSaid(state, psf, measures, column, row) {
  const { side, pixel, values, counts, bound } = psf;
  const middle = Math.floor(side / 2);
  const at = (middle + row) * side + middle + column;
  const { factor, name } = lengthUnit(state);
  const place = [column, row].map((steps) => withMinus(short(steps * pixel * factor, 3))).join(", ");
  const said = [];
  if (counts) said.push(`${Math.round(counts[at])} electrons`);
  const unaberrated = measures && psf.peak / measures.peak_strehl;
  const error = bound ?? 0;
  const over = unaberrated ? values[at] / unaberrated : NaN;
  if (psf.peak > 0) said.push(`${stated(Math.max(0, values[at] / psf.peak), unaberrated ? (error * unaberrated) / psf.peak : 0, 3)} of the brightest`);
  if (unaberrated) said.push(`${stated(Math.max(0, over), error, 3)} of the unaberrated peak`);
  const by = bound && unaberrated ? ` ± ${upwards(bound)}` : "";
  return `x, y = ${place}${unitAfter(name)}: ${said.join(", ")}${by}`;
}

export function wavefrontSaid(state, seen) {
  const { factor, name } = wavesUnit(state);
  return `${withUnit(short((seen.high - seen.low) * factor, 3), name)} P–V, ${short(seen.rms * factor, 3)} rms`;
}

export function waveSaid(state, wavefront, side, column, row) {
  const waves = wavefront[row * side + column];
  const place = [column, row].map((at) => withMinus(short((2 * at + 1) / side - 1, 2))).join(", ");
  const { factor, name } = wavesUnit(state);
  return `x, y = ${place} of the radius: ${waves === waves ? withUnit(withMinus(stated(waves * factor, 0, 3)), name) : "no light"}`;
}

export function plotSaid(title, x, curves) {
  const ends = curves.filter((curve) => curve.name && curve.y.length).map((curve) => {
    const { x: at, y } = curve;
    const level = title === "Encircled energy" ? 0.5 : 0.5 * y[0];
    const k = y.findIndex((value) => (title === "Encircled energy" ? value >= level : value <= level));
    const half = at[k - 1] + ((at[k] - at[k - 1]) * (level - y[k - 1])) / (y[k] - y[k - 1]);
    return k > 0 ? `${curve.name} passes ${title === "Profile" ? "half its value on the axis" : "one half"} at ${short(half, 3)} ${x.unit}` : curve.name;
  });
  return `${title}: ${ends.join("; ")}.`;
}
