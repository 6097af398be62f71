// The light that misses a window: far from the axis all of it comes from the edges of the aperture.
import { linesOf, rayReach, slopes, vanesOf } from "./optics.js";

const POINTS = 720; // of each circular edge
const ALONG = 40; // of each vane
const NODES = 400; // of the clear area

// The share of all light that falls outside a window from `low` to `high` in v along x and y, and about how much it is off by:
// Infinity where rays leave the window, of which nothing is known here.
//
// By the geometrical theory of diffraction (Keller, J. Opt. Soc. Am. 52, 116, 1962) a point of an edge sends light along the edge's
// normal, on either side of where its own ray arrives: 1 / (2 pi^2 s^2) of it at the distance s in v, a unit of length of the edge, of
// s and of the clear area over pi. Edges interfere, and the sums of their waves alternate so quickly along the sides of a window that
// about 0.2 / s^2 is left; of the two edges of a vane, a slit of width w, the light is (2 - 2 cos w s) times as large.
export function lightOutside(state, low, high) {
  const beyond = Math.min(-low, high) - rayReach(state);
  if (!(beyond > 0)) return { share: NaN, error: Infinity };
  const slope = slopes(state);
  const [eps, half] = [state.obscuration, 0.5 * state.vane_width];
  const angles = vanesOf(state);
  const count = angles.length;
  const hidden = (rho) => (count ? Math.min(Math.PI / count, Math.asin(Math.min(1, half / rho))) : 0);
  // Where the ray of a point arrives, and how far it is from there to the end of the window in a direction.
  const ends = (rho, theta, [cx, cy]) => {
    const [outward, around] = slope(rho, theta);
    const [c, s] = [Math.cos(theta), Math.sin(theta)];
    const away = (at, by) => (Math.abs(by) < 1e-12 ? Infinity : ((by > 0 ? high : low) - at) / by);
    return Math.min(away(outward * c - around * s, cx), away(outward * s + around * c, cy));
  };
  let clear = 0;
  for (let i = 0; i < NODES; i++) clear += (1 - (hidden(Math.sqrt(eps ** 2 + ((1 - eps ** 2) * (i + 0.5)) / NODES)) * count) / Math.PI) / NODES;
  clear *= 1 - eps ** 2;
  let sum = 0;
  const both = (rho, theta, [c, s], weight, of) => {
    for (const sign of [1, -1]) sum += weight * of(ends(rho, theta, [sign * c, sign * s]));
  };
  const arcs = Math.max(1, count);
  const each = Math.ceil(POINTS / arcs);
  for (const rho of eps > 0 ? [1, eps] : [1]) {
    const [start, wide] = [(angles[0] ?? 0) + hidden(rho), (2 * Math.PI) / arcs - 2 * hidden(rho)];
    for (let k = 0; k < arcs * each; k++) {
      const theta = start + (2 * Math.PI * Math.floor(k / each)) / arcs + (wide * ((k % each) + 0.5)) / each;
      both(rho, theta, [Math.cos(theta), Math.sin(theta)], (rho * wide) / each, (s) => 1 / s);
    }
  }
  // Vanes begin where their neighbours end.
  const first = count > 1 ? half / Math.sin(Math.PI / count) : half;
  const [from, to] = [Math.max(first, eps), 1].map((rho) => Math.sqrt(Math.max(0, rho ** 2 - half ** 2)));
  for (const angle of angles) {
    const normal = [-Math.sin(angle), Math.cos(angle)];
    for (let k = 0; k < ALONG; k++) both(from + ((to - from) * (k + 0.5)) / ALONG, angle, normal, (to - from) / ALONG, (s) => slit(2 * half, s));
  }
  // One alone has an end on the axis, too.
  if (count === 1 && eps < half) both(1e-9, angles[0], [Math.cos(angles[0]), Math.sin(angles[0])], 2 * (half - eps), (s) => 1 / s);
  const lines = linesOf(state).reduce((all, [stretch, part]) => all + part / stretch, 0);
  const rings = (1 + (2 * Math.sqrt(eps)) / (1 - eps) + 2 * count) / clear;
  return { share: (lines * sum) / (2 * Math.PI ** 2 * clear), error: (0.2 * rings) / beyond ** 2 };
}

// The integral of (2 - 2 cos(w t)) / t^2 from s on.
function slit(w, s) {
  const x = w * s;
  return 2 * w * ((1 - Math.cos(x)) / x + sineRest(x));
}

// The integral of sin(t) / t from x on: its series, or the asymptotic one.
function sineRest(x) {
  if (x > 12) {
    const y = 1 / (x * x);
    return (Math.cos(x) * (1 - y * (2 - 24 * y))) / x + Math.sin(x) * y * (1 - y * (6 - 120 * y));
  }
  let rest = Math.PI / 2;
  for (let n = 1, term = x; Math.abs(term) > 1e-16; n += 2, term *= (-x * x) / ((n - 1) * n)) rest -= term / n;
  return rest;
}
