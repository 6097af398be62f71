// What the words of the page mean: a list that unfolds, and one sentence beside the word that is clicked.

import { el } from "./dom.js";
import { FIELDS } from "./fields.js";

export const NUMBERS = {
  strehl: ["Strehl on the axis", "Strehl ratio: the intensity on the axis over that of the same aperture without aberrations."],
  largest: [
    "Largest value",
    "The brightest value of the image over the unaberrated peak. Averages over pixels are lower than the intensity at a point, so " +
      "with “averaged by pixels” it can be below the Strehl ratio.",
  ],
  d80: [
    "80 % diameter",
    "Diameter of the circle around the centroid of the light that contains 80 % of it, as `lommel info` has it. The curve of encircled " +
      "energy is about the axis.",
  ],
  fwhm: [
    "FWHM",
    "Full width at half maximum of the optics, without the pixel: the extent of what is brighter than half of the brightest point, " +
      "the mean of x and y, as `lommel info` has it.",
  ],
  inside: ["Light in the window", "Share of all light that falls into the window, however it is sampled; off by less than its last digit."],
  bound: ["Proven error", "Upper bound on the error of every value shown, over the unaberrated peak: mathematically proven, not estimated."],
  time: ["Time", "Computing time of the last point spread function on this machine."],
};

const PICTURES_AND_CURVES = {
  psf: ["Point spread function", "Image of a point of light on the sensor. Its brightest value has the last colour of the bar."],
  profile: ["Profile", "Intensity over the distance from the axis, averaged over all directions, of the unaberrated peak."],
  energy: ["Encircled energy", "Share of the light within a circle around the axis, over its radius."],
  mtf: ["MTF", "Modulation transfer function: contrast of a sine pattern in the image, over its frequency, along x and along y."],
  picture: ["On the sensor", "A picture as the pixels of the sensor record it through this lens."],
  wavefront: ["Wavefront", "Optical path difference over the pupil, red above and blue below zero: P–V from lowest to highest, rms about the mean."],
  fringes: ["Pupil, one fringe per wave", "Interferogram of the pupil: from one bright fringe to the next the wavefront changes by one wavelength."],
};

const NOTES = {
  edge: [
    "At the edge",
    "Coefficients are given at the edge of the pupil (radius 1), in waves. Defocus and spherical are the Seidel coefficients W020 and " +
      "W040, of ρ² and ρ⁴. Coma, astigmatism and trefoil are Zernike terms (3, 1), (2, 2) and (3, 3) that are 1 at the edge. The " +
      "Zernike term (4, 0), 6ρ⁴ − 6ρ² + 1, contains defocus: one wave of it is W040 = 6 and W020 = −6.",
  ],
  signs: [
    "Signs",
    "Positive defocus: the sensor lies between the lens and the focus. The picture is seen as on the sensor, x to the right, y down.",
  ],
};

const CHOICES = {
  focus: "Focus",
  light: "Light",
  view: "Sampling",
  noise: "Noise",
  rays: "Rays",
  stretch: "Stretch",
  map: "Colours",
  waves_unit: "Unit of the wavefront",
  length_unit: "Unit of lengths",
  picture: "Picture",
  zernike: "Further Zernike terms",
};

function sections() {
  const controls = {};
  for (const [key, { row, about }] of Object.entries(FIELDS))
    if (about) ((controls[row?.group ?? "Choices"] ??= {})[key] = [row?.name ?? row?.label ?? CHOICES[key] ?? key, about]);
  const { Choices, ...sliders } = controls;
  return { ...sliders, "Notes on wavefronts": NOTES, Numbers: NUMBERS, "Pictures and curves": PICTURES_AND_CURVES, Choices };
}

const ALL = Object.assign({}, ...Object.values(sections()));

export const meaning = (key) => ALL[key]?.[1] ?? "";

export function help(level) {
  const entry = ([name, about]) => el("div", {}, el("dt", {}, name), el("dd", {}, about));
  const parts = Object.entries(sections()).map(([title, words]) =>
    el("details", { open: title === "Numbers" }, el("summary", {}, el(`h${level + 1}`, {}, title)), el("dl", {}, ...Object.values(words).map(entry))),
  );
  return el("div", { class: "help", role: "region", "aria-label": "Help", hidden: true }, ...parts);
}

// A word that is clicked or tapped shows its sentence until the next click or key.
export function explainOnClick(node) {
  const tip = el("div", { class: "tip", role: "status" });
  tip.hidden = true;
  node.append(tip);
  node.addEventListener("pointerdown", () => (tip.hidden = true));
  node.addEventListener("keydown", () => (tip.hidden = true));
  node.addEventListener("click", (event) => {
    const word = event.target.closest("[data-word]");
    const about = word && meaning(word.dataset.word);
    if (!about) return;
    event.preventDefault(); // a label would move the focus
    sayBeside(node, tip, word, [word.dataset.also, about].filter(Boolean).join(" "));
  });
  return tip;
}

// A sentence just below an element, within the page.
export function sayBeside(node, tip, beside, text) {
  tip.textContent = text;
  tip.hidden = false;
  const [page, place] = [node.getBoundingClientRect(), beside.getBoundingClientRect()];
  const left = Math.min(place.left - page.left, page.width - tip.offsetWidth - 8);
  tip.style.left = `${Math.max(8, left)}px`;
  const below = place.bottom + tip.offsetHeight + 8 < innerHeight;
  tip.style.top = `${below ? place.bottom - page.top + 4 : place.top - page.top - tip.offsetHeight - 4}px`;
}
