// From a state of the page to its answers. Runs in a Worker, or where there is none on the page itself.
import { changed, DEFAULTS } from "./state.js";
import { linesOf, pixelOf, pythonOf, stepOf, termsOf } from "./optics.js";

export class Engine {
  constructor(core) {
    this.core = core;
  }

  psf(given, quality = "settled") {
    const state = changed(DEFAULTS, given);
    const begin = performance.now();
    const { side, pixel, tol } = asked(state, quality);
    const [values, [bound, peak, sum]] = this.image(state, side, pixel, state.view === "averaged", tol);
    return { values, side, pixel, bound, peak, sum, python: pythonOf(state, side, pixel), ms: performance.now() - begin };
  }

  // Fractions of all light per pixel, and what is known of them.
  image(state, side, pixel, integrate, tol) {
    const { core } = this;
    this.light(state);
    const out = core.room("values", Float32Array, side * side);
    const numbers = core.room("numbers", Float64Array, 3);
    core.call("psf", side, stepOf(state, pixel), integrate ? 1 : 0, tol, out, numbers);
    return [core.view(out, Float32Array, side * side).slice(), core.view(numbers, Float64Array, 3).slice()];
  }

  light(state) {
    const terms = termsOf(state);
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
  }
}

// While something is dragged, a fine view has fewer pixels of the same field, and all is less exact; where the pupil is radial
// and the light of one wavelength nothing is won by it.
function asked(state, quality) {
  const fast = quality === "drag" && (state.light === "white" || state.coma !== 0 || state.astigmatism !== 0 || state.trefoil !== 0);
  const side = fast && state.view === "fine" ? Math.min(256, state.side) : state.side;
  return { side, pixel: pixelOf(state, side), tol: fast ? 1e-4 : 1e-6 };
}
