// From a state of the page to its answers. Runs in a Worker, or where there is none on the page itself.
import { COLOURS, DIRECTED } from "./fields.js";
import { Depths } from "./depths.js";
import { counted } from "./noise.js";
import { changed, DEFAULTS } from "./state.js";
import {
  centroidOf, clearOf, cutoff, fineReach, focused, largestStep, lengthOf, linesOf, pixelOf, pythonOf, rayReach, slopes, spreadReach, stepOf, termsOf, vanesOf, waves,
} from "./optics.js";
import { lightOutside } from "./window.js";

// While something is dragged, what takes long is asked for less exactly. Tolerances are over the peak.
const QUALITY = {
  drag: { tol: 1e-4, side: 256, seen: 128, error: 1e-6, radii: 97, nodes: 2, across: 128, grids: [[32, 1, 100], [32, 1, 30]], price: 1e6 },
  settled: { tol: 1e-6, side: Infinity, seen: Infinity, error: 1e-10, radii: 193, nodes: 10, across: 1024, grids: [[64, 0.5, 600], [48, 0.5, 150]], price: 4e7 },
};
const DEAREST = 1.3e8; // nodes of all transfer functions of a state: about a second
const DEAREST_CUT = 7e7; // where the light on circles has them, too
const SUMMED = 1e-6; // of all light, about what sums of it over a window are off by
const MISSING = 0.01; // error that an MTF from the light on circles may have
const LONGEST = 1.2; // seconds that quadrature along rows may take for an image

const STOPS = [1, 1.4, 2, 2.8, 4, 5.6, 8, 11, 16, 22, 32, 45, 64, 90];
const SHARES = [0.9, 0.8, 0.7, 0.6, 0.5, 0.4, 0.3, 0.2, 0.1];
const RINGS = 10; // of rays

export class Engine {
  constructor(core) {
    this.core = core;
    this.seen = null; // of the last PSF: its question, and sums that measures take
    this.depths = new Depths(core);
  }

  openDepth(...given) {
    return this.depths.open(...given);
  }

  depth(...given) {
    return this.depths.pair(...given);
  }

  sharpen(...given) {
    return this.depths.sharpen(...given);
  }

  psf(given, quality = "settled") {
    const begin = performance.now();
    const stated = changed(DEFAULTS, given);
    const state = focused(stated);
    this.refuse(stated, quality);
    const { side, pixel, tol } = asked(state, quality);
    const values = new Float32Array(side * side);
    const [proven, peak, sum, area] = this.image(state, side, pixel, state.view === "averaged", tol, values);
    const bound = Number.isNaN(proven) ? null : proven; // none is proven of quadrature along rows
    this.seen = { key: keyOf(state, side, pixel, tol), bound, peak, sum };
    const made = { values, side, pixel, bound, peak, sum, area, python: pythonOf(stated, side, pixel) };
    if (state.light === "white") made.colour = this.colour(side * side);
    // Photons are counted by pixels of the sensor, which those of the fine view are not.
    if (state.noise === "on" && state.view !== "fine") {
      const expected = values.map((share) => share * state.photons);
      made.counts = counted(expected, state, seedOf(state, this.seen.key));
    }
    return { ...made, ms: performance.now() - begin };
  }

  measures(given, quality = "settled") {
    const state = focused(changed(DEFAULTS, given));
    const { side, pixel, tol } = asked(state, quality);
    if (this.seen?.key !== keyOf(state, side, pixel, tol)) this.psf(given, quality);
    return completed({ ...this.curves(given, quality), ...this.extents(given, quality) }, this.seen);
  }

  // The measures that take images of their own: the FWHM and the light in the window.
  extents(given, quality = "settled") {
    const stated = changed(DEFAULTS, given);
    const state = focused(stated);
    this.refuse(stated, quality);
    const fwhm = this.fwhm(state, quality);
    const { share: inside, error: inside_error } = this.inside(state, quality);
    return { fwhm, inside, inside_error };
  }

  // The measures that no image is needed for; completed() adds the others.
  curves(given, quality = "settled") {
    const stated = changed(DEFAULTS, given);
    const state = focused(stated);
    this.refuse(stated, quality);
    const { pixel } = asked(state, quality);
    const { error, radii } = QUALITY[quality];
    this.light(state);
    const window = stepOf(state, fineReach(state));
    const cut = state.vanes || beyondCircles(state);
    const reach = cut ? this.core.call("cut_reach", window) : window;
    const dear = this.contrastAt(state, quality, QUALITY[quality].price).cost > DEAREST_CUT;
    const circles = cut ? this.cutCircles(state, reach, radii, dear) : this.wholeCircles(state, reach, radii, error);
    const { v, mean, reference, share, flat, area, radius } = circles;
    const r = v.map((at) => lengthOf(state, at));
    const made = {
      strehl: mean[0],
      strehl_error: circles.error,
      unaberrated: (area * brightness(state) * stepOf(state, pixel) ** 2) / (4 * Math.PI), // value of a pixel at the peak
      d80_axis: radius < 0 ? null : 2 * lengthOf(state, radius),
      profile: { r, mean, reference },
      energy: { r, share, reference: flat },
      mtf: withPixel(state, this.contrast(stated, quality, cut)),
    };
    const centroid = centroidOf(state);
    if (Math.hypot(...centroid) < 1e-6) return { ...made, d80: made.d80_axis };
    if (cut && quality === "drag") return { ...made, d80: NaN }; // as long again
    // About the centroid, as far as the circle about the axis moves at most: the same circles of an image that is moved onto the axis.
    this.light(state, centroid.map((at) => -at));
    const far = radius < 0 ? reach : Math.min(reach, 1.02 * (radius + Math.hypot(...centroid)));
    if (!cut) this.core.call("set_circles", far, Math.max(error, 1e-7));
    const near = cut && evenly(Math.max(33, Math.ceil((radii * far) / reach)), far);
    const about = cut ? sharesOf(state, near, this.cutLight(near, 1)).radius : this.core.call("radius_of", 0.8, far);
    return { ...made, d80: about < 0 ? null : 2 * lengthOf(state, about) };
  }

  // Full width at half maximum of the optics, the mean of x and y: extents of what is brighter than half of the maximum, in an image
  // that just holds it. NaN where it would take long, or the samples are too far apart.
  fwhm(state, quality) {
    const plain = !state.vanes && !unevenSlope(state);
    const unit = lengthOf(state, Math.PI);
    let [middle, width] = [[0, 0], 2 * fineReach(state)];
    if (quality === "drag" && !plain) return NaN;
    for (const [least, most] of [[2.5, Infinity], [6, 1024]]) {
      const side = Math.min(most, Math.max(256, 2 ** Math.ceil(Math.log2((least * width) / unit))));
      const pixel = width / side;
      if (side > 1024 || this.tooLong(state, side, pixel, false)) return NaN;
      const values = new Float32Array(side * side);
      const [error, peak, , area] = this.image(state, side, pixel, false, 1e-6, values, middle.map((at) => -stepOf(state, at)));
      if (error * area * brightness(state) * stepOf(state, pixel) ** 2 > 0.04 * Math.PI * peak) return NaN;
      const lines = [new Float32Array(side), new Float32Array(side)]; // the brightest of each column and row
      values.forEach((value, i) => [i % side, Math.floor(i / side)].forEach((at, k) => (lines[k][at] = Math.max(lines[k][at], value))));
      const half = 0.5 * peak;
      const ends = lines.map((rows) => {
        const first = rows.findIndex((most) => most >= half);
        const last = rows.findLastIndex((most) => most >= half);
        const past = (inside, outside) => (rows[inside] - half) / (rows[inside] - (rows[outside] ?? 0));
        return [first - past(first, first - 1), last + past(last, last + 1)].map((at) => (at - side / 2) * pixel);
      });
      middle = middle.map((at, k) => (plain ? 0 : at + 0.5 * (ends[k][0] + ends[k][1])));
      const extents = ends.map(([low, high]) => high - low);
      if (width < 2 * fineReach(state)) return 0.5 * (extents[0] + extents[1]);
      width = Math.min(1.2 * Math.max(...extents) + 4 * pixel, 0.99 * width);
    }
  }

  // The share of all light that the window holds, and about what it is off by; NaN where it would take long.
  inside(state, quality) {
    const width = state.side * pixelOf(state, state.side);
    const low = -(Math.floor(state.side / 2) + 0.5) * pixelOf(state, state.side);
    const past = lightOutside(state, stepOf(state, low), stepOf(state, low + width));
    const found = { share: 1 - past.share, error: past.error };
    if (found.error < 1e-5) return found;
    const middle = stepOf(state, low + 0.5 * width);
    if (!state.vanes && !unevenSlope(state)) return this.roundInside(state, stepOf(state, 0.5 * width), middle);
    // The sum of averages over pixels of about 0.9 in v, of which the window is made.
    const across = 2 * Math.ceil(largestStep(state, width) / 1.8) + 1;
    if (across > QUALITY[quality].across || this.tooLong(state, across, width / across, true)) return found.error < 0.01 ? found : { share: NaN, error: NaN };
    const sum = this.image(state, across, width / across, true, QUALITY.settled.tol, null, [-middle, -middle])[2];
    return { share: sum, error: SUMMED };
  }

  // Where the image is round, by the light within circles: of a window `half` wide on either side of `middle`, in v.
  roundInside(state, half, middle) {
    const ends = [half + middle, half - middle];
    this.light(state);
    this.core.call("set_circles", Math.SQRT2 * Math.max(...ends), 1e-7);
    let share = 0;
    // To each side of the window from the axis, on either hand, a triangle: by Simpson's rule in the angle.
    for (const away of ends) {
      for (const along of ends) {
        const count = 64 + 2 * Math.ceil(away);
        const step = Math.atan2(along, away) / count;
        const within = this.circles(Float64Array.from({ length: count + 1 }, (_, i) => away / Math.cos(i * step)), true)[0];
        within.forEach((light, i) => (share += (light * step * (i % count ? (i % 2 ? 4 : 2) : 1)) / (3 * Math.PI)));
      }
    }
    return { share, error: SUMMED };
  }

  // Mean intensities and encircled energies up to a radius in v, of a pupil without vanes.
  wholeCircles(state, reach, radii, allowed) {
    this.core.call("set_circles", reach, allowed);
    const error = this.core.call("circle_error");
    const v = evenly(4 * radii - 3, reach);
    this.toZeros(v);
    const [mean, reference] = this.circles(v, false);
    const [share, flat] = this.circles(v, true);
    const radius = this.core.call("radius_of", 0.8, reach);
    return { v, mean, reference, share, flat, error, radius, area: 1 - state.obscuration ** 2 };
  }

  // Moves radii next to a least mean there, but not every fourth, so that dark rings are dark.
  toZeros(v) {
    this.circles(v, false).forEach((mean, curve) => {
      const least = [];
      for (let i = 1; i < v.length - 1; i++) if (mean[i] <= mean[i - 1] && mean[i] < mean[i + 1] && mean[i] < 0.01) least.push(i);
      const low = Float64Array.from(least, (i) => v[i - 1]);
      const high = Float64Array.from(least, (i) => v[i + 1]);
      for (let step = 0; least.length && step < 24; step++) {
        const third = low.map((at, k) => (high[k] - at) / 3);
        const [left, right] = [low.map((at, k) => at + third[k]), high.map((at, k) => at - third[k])];
        const [a, b] = [left, right].map((at) => this.circles(at, false)[curve]);
        for (let k = 0; k < low.length; k++) {
          if (a[k] < b[k]) high[k] = right[k];
          else low[k] = left[k];
        }
      }
      least.forEach((i, k) => {
        const at = 0.5 * (low[k] + high[k]);
        const moved = i % 4 ? i : at < v[i] ? i - 1 : i + 1;
        v[moved] = at;
      });
    });
  }

  // The same of one with vanes, for which no error is proven.
  cutCircles(state, reach, radii, keep) {
    const v = evenly(radii, reach);
    const [lit, plain] = [1, 0].map((aberrated) => this.cutLight(v, aberrated, aberrated && keep ? 1 : 0));
    return { v, mean: lit.mean, reference: plain.mean, share: lit.share, flat: plain.share, error: null, ...sharesOf(state, v, lit), area: lit.area };
  }

  cutLight(v, aberrated, keep = 0) {
    const { core } = this;
    const out = core.room("numbers", Float64Array, 2 * v.length);
    const area = core.call("on_cut_circles", core.put("points", v), v.length, aberrated, keep, out, out + 8 * v.length);
    const both = core.view(out, Float64Array, 2 * v.length);
    return { mean: both.slice(0, v.length), share: both.slice(v.length), area };
  }

  maps(given, side) {
    const state = changed(DEFAULTS, given);
    const [wave, clear] = [waves(state), clearOf(state)];
    const wavefront = new Float32Array(side * side).fill(NaN);
    for (let i = 0; i < wavefront.length; i++) {
      const x = (2 * (i % side) + 1) / side - 1;
      const y = (2 * Math.floor(i / side) + 1) / side - 1;
      const [rho, theta] = [Math.hypot(x, y), Math.atan2(y, x)];
      if (clear(rho, theta)) wavefront[i] = wave(rho, theta);
    }
    return { wavefront, ...extremes(wave, clear, state.obscuration) };
  }

  // Where rays from rings of the clear aperture meet the sensor, as lommel.show.plot has them.
  rays(given) {
    const state = focused(changed(DEFAULTS, given));
    const [slope, clear] = [slopes(state), clearOf(state)];
    const found = [];
    const rings = Array.from({ length: RINGS + 1 }, (_, k) => [(k / RINGS) * (1 - 1e-12), 6 * k]);
    const edge = state.obscuration;
    if (edge > 0) rings.push([edge * (1 + 1e-12), 6 * Math.ceil(RINGS * edge)]);
    for (const [rho, count] of rings) {
      for (let k = 0; k < Math.max(1, count); k++) {
        const theta = (2 * Math.PI * k) / Math.max(1, count);
        if (!clear(rho, theta)) continue;
        const [outward, around] = slope(Math.max(rho, 1e-9), theta).map((v) => lengthOf(state, v));
        const [c, s] = [Math.cos(theta), Math.sin(theta)];
        found.push([outward * c - around * s, outward * s + around * c]);
      }
    }
    return { x: Float32Array.from(found, ([x]) => x), y: Float32Array.from(found, ([, y]) => y) };
  }

  // Planes of linear light, one after the other, as the sensor's pixels record them.
  blur(given, picture, width, height, quality = "drag") {
    const stated = changed(DEFAULTS, given);
    const state = focused(stated);
    const size = width * height;
    const count = Math.floor(picture.length / size);
    const side = 2 * spreadReach(state, Math.min(width, height)) + 1;
    const { core } = this;
    // Averages would take hundreds of samples across each pixel, or all of a very large spot.
    const coarse = largestStep(state, state.pixel) > 200 || (beyondSeries(state, true) && !state.vanes) || this.tooLong(state, side, state.pixel, true);
    if (coarse) this.refuse({ ...stated, view: "fine" }, "drag");
    if (coarse) core.put("values", this.binned(state, side));
    else this.image(state, side, state.pixel, true, QUALITY[quality].tol);
    const noisy = (light) => (state.noise === "on" ? this.noisy(light, state) : light);
    if (!coarse && state.light === "white") return noisy(this.blurColours(picture, count, side, width, height));
    const spread = core.room("values", Float32Array, side * side);
    const planes = core.put("planes", picture);
    const out = core.room("blurred", Float32Array, size * count);
    core.call("blur", spread, side, planes, count, height, width, out);
    return noisy(core.view(out, Float32Array, size * count).slice());
  }

  // Light of which 1 is white, as counted: what falls below black is black.
  noisy(light, state) {
    const expected = light.map((value) => Math.max(0, value) * state.photons);
    return counted(expected, state, seedOf(state, `picture ${termsOf(state)}`)).map((count) => Math.max(0, count / state.photons));
  }

  // Three planes, each spread as its colour is in the last image.
  blurColours(picture, count, side, width, height) {
    const { core } = this;
    const size = width * height;
    const colours = this.colour(side * side);
    const blurred = new Float32Array(3 * size);
    for (let c = 0; c < 3; c++) {
      const spread = core.put("values", colours.subarray(c * side * side, (c + 1) * side * side));
      const first = size * Math.min(c, count - 1);
      const plane = core.put("planes", picture.subarray(first, first + size));
      const out = core.room("blurred", Float32Array, size);
      core.call("blur", spread, side, plane, 1, height, width, out);
      blurred.set(core.view(out, Float32Array, size), c * size);
    }
    return blurred;
  }

  // Planes of linear sRGB of the last image in white light, whose brightest component is 1; colours beyond sRGB are clipped.
  colour(pixels) {
    const planes = this.core.view(this.core.room("colours", Float32Array, 3 * pixels), Float32Array, 3 * pixels);
    let most = 0;
    for (const value of planes) if (value > most) most = value;
    const scale = most > 0 ? 1 / most : 0;
    return planes.map((value) => Math.max(0, value * scale));
  }

  // Fractions of all light per pixel, left in the block of values, and copied into an array; returns the bound on their error over
  // the peak, the largest, the sum, and the clear area over that of the disk.
  image(state, side, pixel, integrate, tol, copy = null, moved = [0, 0]) {
    const { core } = this;
    for (let asked = tol; ; asked *= 10) {
      this.light(state, moved);
      const out = core.room("values", Float32Array, side * side);
      const numbers = core.room("numbers", Float64Array, 4);
      try {
        const white = state.light === "white";
        const weights = white ? core.put("weights", Float64Array.from(COLOURS.flat())) : 0;
        const colours = white ? core.room("colours", Float32Array, 3 * side * side) : 0;
        core.call("psf", side, stepOf(state, pixel), integrate ? 1 : 0, asked, out, numbers, weights, colours, alongRows(state, integrate) ? 1 : 0);
      } catch (error) {
        // Large aberrations leave rounding errors above the tolerance; the bound says by how much.
        if (asked < 1e-3 && error.message === "tolerance not met") continue;
        throw error;
      }
      copy?.set(core.view(out, Float32Array, side * side));
      return core.view(numbers, Float64Array, 4).slice();
    }
  }

  // Whether an image would take longer than the page waits.
  tooLong(state, side, pixel, integrate) {
    if (unevenSlope(state) > (state.light === "white" ? 1250 : 3100) || slopeOf(state) > 3100) return true;
    if (!alongRows(state, integrate)) return false;
    this.light(state);
    return this.core.call("cut_seconds", side, stepOf(state, pixel), integrate ? 1 : 0) > LONGEST;
  }

  refuse(stated, quality) {
    const late = (given, of) => {
      const state = focused(given);
      const { side, pixel } = asked(state, of);
      return this.tooLong(state, side, pixel, state.view === "averaged");
    };
    if (late(stated, quality)) throw new RangeError(`it would take too long: ${advice(stated, (given) => !late(given, "settled"))}`);
  }

  // Averages over pixels that are much larger than a fine view's: each of its pixels is within one of them, or two in a row.
  binned(state, side) {
    const pitch = pixelOf({ ...state, view: "fine" }, 256);
    const values = new Float32Array(256 * 256);
    this.image(state, 256, pitch, false, QUALITY.drag.tol, values);
    const parts = Array.from({ length: 256 }, (_, i) => {
      const low = ((i - 128.5) * pitch) / state.pixel + 0.5 * side;
      const [first, last] = [Math.floor(low), Math.floor(low + pitch / state.pixel)];
      const share = first === last ? 1 : ((last - low) * state.pixel) / pitch;
      return [[first, share], [last, 1 - share]].filter(([at]) => at >= 0 && at < side);
    });
    const out = new Float32Array(side * side);
    parts.forEach((rows, y) =>
      parts.forEach((columns, x) => {
        for (const [row, down] of rows) for (const [column, across] of columns) out[row * side + column] += down * across * values[256 * y + x];
      }),
    );
    return out;
  }

  // At radii in v, with aberrations and without.
  circles(v, energy) {
    const { core } = this;
    const at = core.put("points", v);
    const out = core.room("numbers", Float64Array, 2 * v.length);
    core.call("on_circles", at, v.length, energy ? 1 : 0, out, out + 8 * v.length);
    const both = core.view(out, Float64Array, 2 * v.length).map((value) => Math.max(0, value));
    return [both.slice(0, v.length), both.slice(v.length)];
  }

  // The MTF, by samples of the transfer function so dense that between them polynomials have it. `kept`: where it would take too long,
  // from the light on circles, with a bound on the error.
  contrast(stated, quality, kept = false) {
    const { core } = this;
    const { nodes, price } = QUALITY[quality];
    const state = focused(stated);
    const end = Math.max(...linesOf(state).map(([stretch]) => stretch));
    const { samples, at, cost } = this.contrastAt(state, quality, price);
    const count = samples.length;
    const out = core.room("numbers", Float64Array, 5 * count);
    let near = kept && cost > DEAREST_CUT;
    let error = near ? core.call("near_contrast", at, count, out, out + 16 * count, out + 32 * count) : 0;
    if (near && !(error < MISSING) && cost < DEAREST) [near, error] = [false, 0];
    if (near ? !(error < MISSING) : cost > DEAREST) {
      const none = Float64Array.of(NaN, NaN);
      const cheap = (given) => this.contrastAt(focused(given), "settled", DEAREST).cost <= DEAREST_CUT;
      const refused = `No MTF: it would take too long: ${advice(stated, cheap, 1)}`;
      return { f: Float64Array.of(0, end * cutoff(state)), x: none, y: none, limit: none, refused };
    }
    if (!near) core.call("contrast", at, count, nodes, out, out + 16 * count, out + 32 * count);
    const [x, y] = [0, 1].map((k) => core.view(out + 16 * count * k, Float64Array, 2 * count).slice());
    const limit = core.view(out + 32 * count, Float64Array, count).slice();
    const made = interpolated(samples, x, y, limit);
    return { ...made, error, f: made.f.map((over) => over * cutoff(state)) };
  }

  // Frequencies of samples, of as dense a grid as costs less than `price`, and where they are in memory.
  contrastAt(state, quality, price) {
    const { core } = this;
    const wide = 2 * rayReach(state); // radians of the transfer function over the cutoff, at most
    const end = Math.max(...linesOf(state).map(([stretch]) => stretch));
    this.light(state);
    let found;
    for (const grid of QUALITY[quality].grids) {
      const samples = frequencies(end, wide, ...grid);
      const at = core.put("points", samples);
      found = { samples, at, cost: core.call("contrast_price", at, samples.length) };
      if (found.cost < price) break;
    }
    return found;
  }

  light(state, moved) {
    const terms = termsOf(state, moved);
    const lines = linesOf(state);
    const { core } = this;
    core.call(
      "set_light",
      core.put("terms", Int32Array.from(terms.flatMap(([n, m]) => [n, m]))),
      core.put("edge", Float64Array.from(terms, ([, , c]) => c)),
      terms.length,
      state.obscuration,
      core.put("lines", Float64Array.from(lines.flat())),
      lines.length,
    );
    core.call("set_vanes", core.put("points", Float64Array.from(vanesOf(state))), state.vanes, state.vane_width);
  }
}

// With what the image says: its brightest pixel.
export function completed({ unaberrated, ...curves }, { peak }) {
  return { ...curves, peak_strehl: peak / unaberrated };
}

// How large an image is made, of a window of state.side: the page says where it is smaller. A fine view has fewer pixels of the same
// field while something is dragged; where the pupil is radial and the light of one wavelength nothing is won by it. Of the sensor's
// pixels those in the middle are seen.
function asked(state, quality) {
  const slow = state.light === "white" || termsOf(state).some(([, m]) => m !== 0);
  const { tol, side: most } = QUALITY[slow ? quality : "settled"];
  let side = Math.min(state.side, state.view === "fine" ? most : QUALITY[quality].seen);
  // Images without symmetry are paid for by the window: of the sensor's pixels those in the fine window, or near the axis. Averages
  // far from it are not computed where aberrations are large.
  const averaged = state.view === "averaged";
  const rows = alongRows(state, averaged);
  const v = largestStep(state, state.pixel);
  const white = state.light === "white";
  if ((rows && state.view !== "fine") || (state.view === "sampled" ? unevenSlope(state) > 0 : averaged && unevenSlope(state) > 170)) {
    const near = rows ? 0 : averaged ? (white ? 1000 : 2700) / Math.ceil(v) : 2 * Math.floor((white ? 800 : 2400) / v);
    side = Math.min(side, Math.max(v > 40 ? 16 : 64, 2 * Math.floor(near / 2), 2 * Math.ceil(fineReach(state) / state.pixel)));
  }
  // Round images, too, where light is far within a window that is very wide.
  if (state.view !== "fine" && side * v > 6e4 && rayReach(state) > 20) side = Math.max(64, 2 * Math.floor(3e4 / v));
  return { side, pixel: pixelOf(state, side), tol };
}

function keyOf(state, side, pixel, tol) {
  return JSON.stringify([termsOf(state), linesOf(state), state.obscuration, vanesOf(state), state.vane_width, state.view === "averaged", stepOf(state, pixel), side, tol]);
}

// Radians of the phase over the radius, in the line where they are most; of a pupil without symmetry alone.
function slopeOf(state) {
  return rayReach(state) * Math.max(...linesOf(state).map(([stretch]) => stretch));
}

function unevenSlope(state) {
  return termsOf(state).some(([, m]) => m !== 0) ? slopeOf(state) : 0;
}

// Whether the series of the image would take seconds, or more terms than there are.
function beyondSeries(state, integrate) {
  return unevenSlope(state) > (state.light === "white" ? 500 : integrate ? 800 : 1500);
}

// Whether the image is made by quadrature along rows.
function alongRows(state, integrate) {
  return state.vanes > 0 || beyondSeries(state, integrate);
}

// The first of a list that fits, where all after it do.
function least(list, fits) {
  let [low, high] = [0, list.length];
  while (low < high) {
    const middle = (low + high) >> 1;
    if (fits(list[middle])) high = middle;
    else low = middle + 1;
  }
  return list[low];
}

// Up to `most` changes of a state, in words, after which it fits the time.
function advice(state, fits, most = 4) {
  const scaled = (keys) => SHARES.map((share) => [`to ${100 * share} %`, Object.fromEntries(keys.map((key) => [key, state[key] * share]))]);
  const aberrations = ["spherical", ...DIRECTED.map(({ name }) => name)].filter((key) => state[key]);
  const lists = [];
  if (state.light === "white") lists.push(["choose one wavelength", [["", { light: "mono" }]]]);
  if (state.vanes) lists.push(["remove the vanes", [["", { vanes: 0 }]]]);
  if (state.view === "averaged") lists.push(["choose “finely sampled”", [["", { view: "fine" }]]]);
  const choices = lists.length;
  if (state.view !== "fine") lists.push(["reduce the pixel", scaled(["pixel"])]);
  if (state.focus === "distances") lists.push(["stop down", STOPS.filter((stop) => stop > state.f_number).map((stop) => [`to f/${stop}`, { f_number: stop }])]);
  if (state.focus === "distances") lists.push(["set the object distance to the focus distance", [["", { object_distance: state.focus_distance }]]]);
  else if (state.defocus) lists.push(["reduce the defocus", scaled(["defocus"])]);
  if (aberrations.length) lists.push(["reduce the aberrations", scaled(aberrations)]);
  if (aberrations.length && state.focus === "waves") lists.push(["reduce defocus and aberrations", scaled(["defocus", ...aberrations])]);
  if (state.zernike) lists.push(["remove the further Zernike terms", [["", { zernike: "" }]]]);
  // One of them; otherwise a choice and one of the others.
  const found = [];
  for (let k = -1; k < choices && !found.length; k++) {
    const [first, [[, base]]] = k < 0 ? ["", [["", {}]]] : lists[k];
    for (const [name, changes] of lists) {
      if (name === first || found.length === (k < 0 ? most : 1)) continue;
      const helps = least(changes, ([, change]) => fits({ ...state, ...base, ...change }));
      if (helps) found.push([first && `${first} and`, name, helps[0]].filter(Boolean).join(" "));
    }
  }
  return found.join(", or ") || "reduce the aberrations";
}

function beyondCircles(state) {
  return slopeOf(state) > 2750 || (state.light === "white" && unevenSlope(state) > 700);
}

// Of settings that change the expected numbers, not of those of the display.
function seedOf({ photons, read_noise }, key) {
  return `${key} ${photons} ${read_noise}`;
}

// Contrast times that of the sensor's square pixels.
function withPixel({ pixel }, mtf) {
  const turn = (f) => Math.PI * f * pixel * 1e-3;
  const of = (curve) => curve.map((contrast, i) => (i ? Math.abs((contrast * Math.sin(turn(mtf.f[i]))) / turn(mtf.f[i])) : contrast));
  return { ...mtf, pixel_x: of(mtf.x), pixel_y: of(mtf.y) };
}

// The light within a radius in v, and the radius of 80 % of it, or -1: between radii shares are cubics, whose slopes the means are.
function sharesOf(state, v, { mean, share, area }) {
  const last = v.length - 1;
  const slope = (i) => 0.5 * area * brightness(state) * mean[i] * v[i] * v[1];
  const within = (at) => {
    const i = Math.max(0, Math.min(last - 1, Math.floor(at / v[1])));
    const t = at / v[1] - i;
    const [low, high, first, end] = [share[i], share[i + 1], slope(i), slope(i + 1)];
    return low + t * (first + t * (3 * (high - low) - 2 * first - end + t * (2 * (low - high) + first + end)));
  };
  let [low, radius] = [0, share[last] < 0.8 ? -1 : v[last]];
  for (let i = 0; radius > 0 && i < 40; i++) {
    const middle = 0.5 * (low + radius);
    if (within(middle) < 0.8) low = middle;
    else radius = middle;
  }
  return { radius };
}

// Of all lines, over that of the reference.
function brightness(state) {
  return linesOf(state).reduce((all, [stretch, part]) => all + part * stretch ** 2, 0);
}

// Frequencies from 0 to `end`, no farther apart than end / count; and than `turn` radians of a function that turns through `wide`
// of them a unit, until it has turned through `far`, where little is left of it.
function frequencies(end, wide, count, turn, far) {
  const found = [0];
  const most = end / count;
  let step = Math.min(most, turn / wide);
  for (let f = step; f < end; f += step) {
    found.push(f);
    if (wide * f > far) step = Math.min(most, 1.3 * step);
  }
  if (found.at(-1) > end - 0.3 * step) found.pop();
  return Float64Array.from([...found, end]);
}

const PARTS = 4; // of each interval between samples

// Moduli of two complex functions, and a real one, by polynomials of degree 5 between samples; points next to a least value are moved
// there, so that zeros are zeros.
function interpolated(samples, x, y, limit) {
  const last = samples.length - 1;
  const f = Float64Array.from({ length: PARTS * last + 1 }, (_, i) => {
    const k = Math.min(last - 1, Math.floor(i / PARTS));
    return samples[k] + ((i - PARTS * k) / PARTS) * (samples[k + 1] - samples[k]);
  });
  // Lagrange's weights of six samples about an interval.
  const weightsAt = (at, k) => {
    const first = Math.max(0, Math.min(last - 5, k - 2));
    return Array.from({ length: 6 }, (_, i) => {
      let weight = 1;
      for (let j = 0; j < 6; j++) if (j !== i) weight *= (at - samples[first + j]) / (samples[first + i] - samples[first + j]);
      return [first + i, weight];
    });
  };
  const modulus = (values, weights) => {
    let [re, im] = [0, 0];
    for (const [j, weight] of weights) {
      re += weight * values[2 * j];
      im += weight * values[2 * j + 1];
    }
    return Math.hypot(re, im);
  };
  const interval = (i) => Math.min(last - 1, Math.floor(i / PARTS));
  const curve = (values) => f.map((at, i) => modulus(values, weightsAt(at, interval(i))));
  for (const values of new Set([x, y])) {
    const size = curve(values);
    for (let i = 1; i < size.length - 1; i++) {
      if (!(size[i] <= size[i - 1] && size[i] < size[i + 1] && size[i] < 0.1)) continue;
      let [low, high] = [f[i - 1], f[i + 1]];
      const of = (at) => modulus(values, weightsAt(at, at < f[i] ? interval(i - 1) : interval(i)));
      for (let k = 0; k < 40; k++) {
        const [a, b] = [low + (high - low) / 3, high - (high - low) / 3];
        if (of(a) < of(b)) high = b;
        else low = a;
      }
      const least = 0.5 * (low + high);
      // Samples themselves stay.
      const moved = i % PARTS ? i : least < f[i] ? i - 1 : i + 1;
      if (moved % PARTS) f[moved] = least;
    }
  }
  const real = f.map((at, i) => Math.max(0, weightsAt(at, interval(i)).reduce((sum, [j, weight]) => sum + weight * limit[j], 0)));
  return { f, x: curve(x), y: curve(y), limit: real };
}

// The least and the greatest of the waves over the closed aperture: the best of a grid, then of ever smaller steps from there.
function extremes(wave, clear, edge) {
  const inside = (rho) => Math.min(1, Math.max(edge, rho));
  const [low, high] = [1, -1].map((sign) => {
    let [best, at] = [Infinity, [inside(0), 0]];
    const take = (rho, theta) => {
      const value = clear(rho, theta) ? sign * wave(rho, theta) : Infinity;
      if (value < best) [best, at] = [value, [rho, theta]];
    };
    for (let i = 0; i <= 24; i++) for (let k = 0; k < 48; k++) take(edge + ((1 - edge) * i) / 24, (Math.PI * k) / 24);
    for (let step = 0.03; step > 1e-6; step *= 0.5) {
      for (const [a, b] of [[1, 0], [-1, 0], [0, 1], [0, -1]]) {
        for (let k = 0; k < 4; k++) {
          const before = best;
          take(inside(at[0] + a * step), at[1] + 2 * b * step);
          if (best === before) break;
        }
      }
    }
    return sign * best;
  });
  return Number.isFinite(low) ? { low, high } : {};
}

// From 0 to the last.
function evenly(count, last) {
  return Float64Array.from({ length: count }, (_, i) => (last * i) / (count - 1));
}
