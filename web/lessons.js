// Lessons for class: each sets a state of the page, names what to try in it, and has a question with its answer.

import { el, menu } from "./dom.js";
import { PRESETS } from "./presets.js";
import { changed, DEFAULTS } from "./state.js";

const MATHML = "http://www.w3.org/1998/Math/MathML";
const BORN_WOLF = "M. Born and E. Wolf, Principles of Optics, 7th ed. (1999), doi:10.1017/CBO9781139644181";

function math(name, ...parts) {
  const node = document.createElementNS(MATHML, name);
  const children = (part) => (typeof part !== "string" ? part : name === "mrow" ? tokens(part) : math("mrow", part));
  node.append(...parts.flatMap(children));
  return node;
}

// Numbers, names and operators of a formula, each an element of its own.
function tokens(text) {
  return text.match(/[\d.]+|\p{L}+|\S/gu).map((token) => {
    const node = document.createElementNS(MATHML, /\d/.test(token) ? "mn" : /^(?!sin|exp)\p{L}/u.test(token) ? "mi" : "mo");
    node.textContent = token;
    return node;
  });
}

const row = (...parts) => math("mrow", ...parts);
const over = (a, b) => math("mfrac", a, b);
const sub = (a, b) => math("msub", a, b);
const power = (a, b) => math("msup", a, b);
const W020 = () => sub("W", "020");
const W040 = () => sub("W", "040");

const near = (value, wanted, by) => Math.abs(value - wanted) <= by;

// `controls` are the rows that matter, `shows` the pictures and curves beside the PSF. A step is done, in any order, when its
// condition holds of the state, the measures, the range of defocus since another was done last, and where a curve is pointed at, by its
// name. Formulas are made when they are shown: scripts that use the engine alone have no document.
const LESSONS = {
  airy: {
    title: "Airy pattern",
    text: `A lens without aberration images a star not to a point but to a bright disk with dark rings: light from all parts of
      its round aperture interferes. Lengths are in λN, the wavelength times the f-number.`,
    state: { defocus: 0, length_unit: "lambdaN" },
    controls: ["f_number", "obscuration", "length_unit"],
    shows: ["profile", "energy"],
    steps: [
      ["Above the picture, set “square root” to “logarithm” and count the rings. Point at the profile: where is the first zero?",
        (now, _, went, read) => now.stretch === "log" && read.profile > 0],
      [`Set lengths to micrometres and drag the f-number beyond 8. The window follows the pattern: watch the scale bar, not the
        size of the disk.`, (now) => now.length_unit === "um" && now.f_number >= 8],
      ["Drag the obscuration to 0.33, as in a mirror telescope. What happens to disk and rings?",
        (now) => near(now.obscuration, 0.33, 0.04)],
    ],
    question: "How wide is the first dark ring at f/4 and 550 nm? Does the share of light outside of it depend on the f-number?",
    formula: () => [
      row("I =", power(row("(", over(row("2", sub("J", "1"), "( v )"), "v"), ")"), "2"), ", v =", over("π r", "λ N"), ","),
      row(sub("r", "1"), "= 1.22 λ N"),
    ],
    answer: `The diameter is 2.44 λN, here 5.4 µm. The ring encloses 83.8 % of the light; 16.2 % is outside, at every f-number and
      wavelength, since these change only the scale of the pattern. With an obscuration of 0.33 the first dark ring is smaller, at
      1.10 λN, but encloses only 65.4 %: a narrower disk, brighter rings, less contrast.`,
    source: `G. B. Airy, Trans. Camb. Phil. Soc. 5, 283 (1835); ${BORN_WOLF}, sections 8.5.2 and 8.6.2`,
  },
  quarter: {
    title: "Rayleigh’s quarter wave",
    text: `How good is good enough? The Strehl ratio is the intensity on the axis over that of a perfect lens. Rayleigh’s rule: a
      wavefront within a quarter wave of a sphere gives an image hardly worse than a perfect one.`,
    state: { defocus: 0 },
    controls: ["defocus", "spherical"],
    shows: ["wavefront", "profile"],
    steps: [
      ["Drag defocus (arrow keys for fine steps) until the Strehl ratio is 0.8. How many waves is that?",
        (now, { strehl }) => near(strehl, 0.8, 0.04) && near(now.spherical, 0, 0.05)],
      ["Set defocus to 0, and drag spherical until the Strehl ratio is 0.8 again.",
        (now, { strehl }) => near(strehl, 0.8, 0.04) && near(now.defocus, 0, 0.05) && now.spherical > 0.1],
      ["Set spherical to 1 wave. Now drag defocus to where the Strehl ratio is largest.",
        (now, { strehl }) => near(now.spherical, 1, 0.05) && strehl > 0.75],
    ],
    question: "Read P–V below the wavefront: why does four times the spherical aberration leave the same Strehl ratio?",
    formula: () => [
      row("S =", power(row("(", over(row("sin π", W020()), row("π", W020())), ")"), "2"), ","),
      row("S ≈ exp", "( −", power("( 2 π σ )", "2"), ")"),
    ],
    answer: `With −1 wave of defocus the wavefront is ρ⁴ − ρ²: it stays within a quarter wave again, and its rms σ is 0.075 waves, or
      1/13.4 wave; Maréchal’s approximation gives S = 0.803, the exact value is 0.800. A quarter wave of defocus leaves 0.811, one
      of spherical alone 0.800. On the sensor a quarter wave of defocus is a shift of 2 λN², so that the depth of focus is
      ±18 µm here, to each side of the focus.`,
    source: `Lord Rayleigh, Phil. Mag. 8, 403 (1879); V. N. Mahajan, doi:10.1364/JOSA.73.000860; ${BORN_WOLF}, section 9.3`,
  },
  axis: {
    title: "The zero on the axis",
    text: "Out of focus, rays fill a disk evenly, its centre too. Yet with one wave of defocus the axis is dark.",
    state: { defocus: 0, rays: "on" },
    controls: ["defocus", "obscuration"],
    shows: ["wavefront", "profile"],
    steps: [
      ["Drag defocus from 0 to 1 wave. Watch the centre of the picture and the Strehl ratio.",
        (now, { strehl }) => near(Math.abs(now.defocus), 1, 0.03) && strehl < 0.002],
      ["Go on to 2 waves: the centre brightens, then is dark again.",
        (now, { strehl }) => near(Math.abs(now.defocus), 2, 0.03) && strehl < 0.002],
      ["Go back to 1 wave and drag the obscuration to 0.5: the centre is bright. At which defocus is it dark now?",
        (now, { strehl }) => near(now.obscuration, 0.5, 0.02) && strehl < 0.002 && Math.abs(now.defocus) > 0.5],
    ],
    question: "No ray is missing on the axis. Why is it dark, and why does a central obscuration shift the zeros?",
    formula: () => [row("S =", power(row("(", over("sin a", "a"), ")"), "2"), ", a = π", W020(), "( 1 −", power("ε", "2"), ")")],
    answer: `Defocus is W₀₂₀ρ², and rings of equal width in ρ² have equal area: over one wave every phase occurs in the same amount,
      and all contributions cancel. (The pupil holds two Fresnel zones.) The same happens at 2, 3, … waves; between, at 1.5 waves,
      the Strehl ratio is 0.045. Behind an obscuration ε = 0.5 the phase covers 1 − ε² = 0.75 of the defocus, so that the first
      zero is at 1/0.75 = 1.33 waves; at 1 wave the Strehl ratio is 0.090. The light is not lost: it is in the rings.`,
    source: `${BORN_WOLF}, section 8.8.2`,
  },
  contrast: {
    title: "Contrast reversal",
    text: `In focus, a Siemens star is grey only near its middle, where the spokes are too fine. Out of focus it has grey rings, and
      farther in the spokes appear again with black and white exchanged. The MTF shows how much contrast is left, not its sign.`,
    state: { defocus: 0, picture: "star", pixel: 2 },
    controls: ["defocus", "length_unit"],
    shows: ["picture", "mtf"],
    steps: [
      ["Drag defocus to 2 waves and follow one white spoke of the star inwards, through the first grey ring.",
        (now) => near(Math.abs(now.defocus), 2, 0.1)],
      ["Set lengths to λN and point at the MTF: where are its first minima? They are zeros: grey rings. Marks on the star give the frequency, which rises inwards.", (now, _, went, read) => now.length_unit === "lambdaN" && read.mtf > 0],
      ["Drag defocus to 3 waves. Where do the grey rings go?", (now) => near(Math.abs(now.defocus), 3, 0.1)],
    ],
    question: "Between the first two grey rings the spokes can be counted. Has the lens resolved them?",
    formula: () => [row("OTF ≈", over(row("2", sub("J", "1"), "( a )"), "a"), ", a = 8 π", W020(), "ν λ N")],
    answer: `Not truly: the transfer function (OTF) is negative there, and white spokes are printed black: spurious resolution. With 2
      waves the signs change at ν = 0.084 and 0.167 cycles/λN, here 38 and 76 cycles/mm. The formula, that of rays, is zero where
      a = 3.83: it gives 0.076 for 2 waves and 0.051 for 3, where waves give 0.054. Between the first two zeros at 2 waves the
      reversed contrast reaches 11 %. No sharpening that ignores the sign restores such a picture.`,
    source: "H. H. Hopkins, Proc. R. Soc. A 231, 91 (1955), doi:10.1098/rspa.1955.0158",
  },
  hubble: {
    title: "Hubble, 1990",
    text: `The mirror of the Hubble Space Telescope was polished to a wrong shape: 8 waves of spherical aberration. Only its focus could
      be changed from the ground. Here it starts at the focus that puts the most light within a radius of 0.1″.`,
    state: { ...PRESETS.find(({ name }) => name.startsWith("Hubble")).state, pixel: 15, length_unit: "arcsec", picture: "points" },
    controls: ["defocus", "spherical"],
    shows: ["picture", "energy"],
    steps: [
      ["Point at the curve of encircled energy: which share of the light is within a radius of 0.1″?", (now, _, went, read) => now.length_unit === "arcsec" && near(read.energy, 0.1, 0.03)],
      ["Drag defocus from −1 to −10. Can you get more light into that radius, or a Strehl ratio of 0.2?",
        (now, _, went) => went.low < -9 && went.high > -2],
      ["Set spherical and defocus to 0: the mirror as designed, and the effect of the corrective optics of 1993.",
        (now) => near(now.defocus, 0, 0.1) && near(now.spherical, 0, 0.1)],
    ],
    question: "Why could no focus repair the image?",
    formula: () => [
      row("W =", W040(), power("ρ", "4"), "+", W020(), power("ρ", "2"), ","),
      row("σ ≥", over(row(W040(), power(row("( 1 −", power("ε", "2"), ")"), "2")), row("6", math("msqrt", "5")))),
    ],
    answer: `A term in ρ² cannot cancel one in ρ⁴. The least rms wavefront error, at −9.0 waves of defocus, is still σ = 0.48 waves;
      a Strehl ratio of 0.8 takes 0.075. Focus only trades: at best 16 % of the light is within a radius of 0.1″, as designed 89 %. Some light
      always forms a sharp core, which is why bright stars could still be measured and images be deconvolved. In 1993 mirrors with the
      opposite error were built in.`,
    source: "C. J. Burrows et al., Astrophys. J. 369, L21 (1991), doi:10.1086/185950",
  },
  coma: {
    title: "Coma against astigmatism",
    text: "Off the axis, stars become comets or short lines. One picture can deceive; going through focus separates the two.",
    state: { defocus: 0, coma: 0.6, picture: "points" },
    controls: ["defocus", "coma", "coma_angle", "astigmatism", "astigmatism_angle"],
    shows: ["picture", "mtf"],
    steps: [
      ["Drag defocus from −1 to 1: how do the two sides of focus differ?",
        (now, _, went) => now.coma > 0.4 && went.low < -0.7 && went.high > 0.7],
      ["Set coma to 0, astigmatism to 0.6, and drag defocus from −1 to 1 again. Where is the star a line?",
        (now, _, went) => now.coma < 0.05 && now.astigmatism > 0.4 && went.low < -0.5 && went.high > 0.5],
      ["Mix them: coma 0.4, astigmatism 0.4. Drag defocus: which of the two do you see where?",
        (now) => near(now.coma, 0.4, 0.1) && near(now.astigmatism, 0.4, 0.1)],
    ],
    question: "A star in your telescope is elongated. How do you find out whether by coma or by astigmatism?",
    formula: () => [row("coma: W ( ρ , θ + 180° ) = − W ,"), row("astigmatism: W ( ρ , θ + 90° ) = − W")],
    answer: `Focus in and out. With coma the two sides are the same, and the tail points one way at every focus: a wavefront that is odd
      under a turn by 180° has the same PSF for +d and −d waves of defocus. With astigmatism the line turns by 90°; the lines are
      sharpest at a defocus of plus and minus the coefficient. In the middle rays fill a disk, the circle of least confusion; waves
      of so small an aberration form a cross there. A Strehl ratio of
      0.8 is left by 0.21 waves of coma or 0.18 waves of astigmatism (Zernike terms, at the edge of the pupil).`,
    source: `${BORN_WOLF}, section 9.4; V. N. Mahajan, doi:10.1364/JOSA.73.000860`,
  },
  depth: {
    title: "Depth from two pictures",
    text: `A lens blurs what is out of focus, by an amount that depends on its distance. One blurred picture does not give the distance,
      for the thing itself may be smooth. Two pictures of different focus do: the ratio of their contrasts depends on the distance,
      not on the texture. Here a wall with a picture, a book, a ball and a card, which moves, are seen through a 35 mm lens, with the noise of light.`,
    state: {},
    controls: [],
    shows: [],
    depth: true,
    steps: [
      ["Point at the card in the map of depth, or move there by the arrow keys. Is the true distance within the standard error, the number after ±? It should be two times out of three.",
        (now, _, went, { depth }) => depth.pointed],
      ["Set the f-number to 5.6, then to 16. What happens to the standard error?", (now, _, went, { depth }) => depth.seen.has(5.6) && depth.seen.has(16)],
      ["Reduce the light to 300 electrons per pixel. Where is depth lost first?", (now, _, went, { depth }) => depth.light <= 300],
      ["Exchange the two pictures. Depth is wrong now: does the misfit tell?", (now, _, went, { depth }) => depth.swapped],
    ],
    question: "At which distances is depth most exact, and what can no pair of pictures tell?",
    formula: () => [
      row("E =", sub("h", "2"), sub("Y", "1"), "−", sub("h", "1"), sub("Y", "2"), "= noise ,"),
      row(sub("Y", "i"), "=", sub("h", "i"), "X +", sub("n", "i")),
    ],
    answer: `Between the two foci, where one picture becomes sharper as the other blurs. At a focus contrast hardly changes with distance, so
      that only the other picture tells, and beyond both foci both blur alike: at f/8 and 3000 electrons the standard error is 5 mm
      at 1.5 m, but 13 mm at 1.8 m and 17 mm at 1.9 m. It grows with noise, and where texture drowns in it depth is not known.
      No pair can tell which picture is focused nearer: exchanged ones fit as well, a misfit of about 1, with distances mirrored
      about 1.54 m. Nor does it tell the scale, which follows from f-number, focal length and pixels as they are stated. A plane at a known
      distance tests both.`,
    source: "M. Subbarao and G. Surya, Int. J. Comput. Vis. 13, 271 (1994), doi:10.1007/BF02028349",
  },
};

const NAMES = Object.keys(LESSONS);

// The state that a lesson sets, or null of a name that none has.
export const lessonState = (name) => (Object.hasOwn(LESSONS, name) ? changed(DEFAULTS, LESSONS[name].state) : null);

// The address names the lesson that is open.
export const askedLesson = () => new URLSearchParams(location.search).get("lesson") ?? "";

export function nameLesson(name) {
  const address = new URL(location.href);
  if (name) {
    address.searchParams.set("lesson", name);
    address.hash = "";
  } else address.searchParams.delete("lesson");
  if (address.search !== location.search) goTo(address, { begun: true, further: true });
}

// In the history, whether an address is what the page or a lesson began with, from which the first change goes further.
const BEGUN = "lommelBegun";
export const begun = (state) => state?.[BEGUN];

export function goTo(address, { begun, further = false } = {}) {
  const state = begun === undefined ? history.state : { ...history.state, [BEGUN]: begun };
  try {
    history[further ? "pushState" : "replaceState"](state, "", address);
  } catch {
    // A page that has no address of its own, as within a frame.
  }
}

// A menu of the lessons, and the panel of one. set(name, state) is called when the reader opens one, with "" and null when closed.
export class Lessons {
  // turn(depth) is called when the view of depth is to be shown, or no longer.
  constructor(set, level = 2, turn = () => {}) {
    Object.assign(this, { set, turn });
    const titles = NAMES.map((name, index) => [name, `${index + 1}: ${LESSONS[name].title}`]);
    this.menu = menu("Lessons", { "": "Lessons …", ...Object.fromEntries(titles) }, "", (name) => this.open(name), { class: "lessons" });
    const button = (text, label, onclick) => el("button", { type: "button", "aria-label": label, title: label, onclick }, text);
    const by = (step) => this.open(NAMES[NAMES.indexOf(this.name) + step]);
    this.title = el(`h${level + 1}`, { class: "title", "aria-live": "polite" });
    this.before = button("←", "Previous lesson", () => by(-1));
    this.after = button("→", "Next lesson", () => by(1));
    const reduce = () => this.reduce(!this.reduced);
    this.all = el("button", { type: "button", onclick: reduce }, "Show everything");
    const close = button("×", "Close the lesson", () => this.open(""));
    this.body = el("div", { class: "body" });
    this.node = el(
      "section",
      { class: "lesson", "aria-label": "Lesson", hidden: true },
      el("div", { class: "head" }, this.title, el("span", { class: "inline" }, this.before, this.after, close)),
      this.body,
    );
  }

  open(name) {
    this.show(name);
    this.set(this.name, lessonState(name));
  }

  show(name) {
    const lesson = lessonState(name) && LESSONS[name];
    this.name = this.menu.value = lesson ? name : "";
    this.node.hidden = !lesson;
    this.turn(Boolean(lesson?.depth));
    this.all.hidden = Boolean(lesson?.depth);
    this.reduce(Boolean(lesson));
    if (!lesson) return;
    const index = NAMES.indexOf(name);
    this.title.textContent = `${index + 1} of ${NAMES.length}: ${lesson.title}`;
    this.before.disabled = index === 0;
    this.after.disabled = index === NAMES.length - 1;
    this.went = null;
    this.steps = lesson.steps.map(([text]) => el("li", {}, text));
    const formulas = lesson.formula().map((formula) => {
      const node = math("math", formula);
      node.setAttribute("display", "block");
      return node;
    });
    const answer = [el("summary", {}, "Answer"), el("p", {}, ...formulas), el("p", {}, lesson.answer)];
    this.body.replaceChildren(
      el("p", {}, lesson.text),
      el("ol", {}, ...this.steps),
      el("p", { class: "question" }, lesson.question),
      el("details", { ontoggle: ({ target }) => target.open && target.scrollIntoView({ block: "nearest" }) }, ...answer, el("p", { class: "note" }, `Source: ${lesson.source}`)),
      this.all,
    );
  }

  // Hides what the lesson does without, or shows it again.
  reduce(reduced) {
    this.reduced = reduced;
    this.all.setAttribute("aria-pressed", String(!reduced));
    const page = this.node.closest(".lommel-live");
    if (!page) return;
    if (reduced) page.dataset.lesson = this.name;
    else delete page.dataset.lesson;
    const { controls, shows } = LESSONS[this.name] ?? {};
    const hide = (names, nodes, keys) => {
      for (const node of page.querySelectorAll(nodes)) node.classList.toggle("idle", reduced && !keys(node).some((key) => names.includes(key)));
    };
    const within = (node) => [node, ...node.querySelectorAll("[data-row], [data-key]")].map(({ dataset }) => dataset.row ?? dataset.key);
    hide(controls, ".controls [data-row], .pair, .section", within);
    hide(shows, ".picture, .pupils, figure.curve", (node) => [...node.querySelectorAll("[data-word]")].map(({ dataset }) => dataset.word));
  }

  get heading() {
    return LESSONS[this.name]?.title ?? "";
  }

  // Marks a step as done once a settled state, which has measures, meets its condition; others are passed through.
  check(state, measures, read) {
    if (!this.name) return;
    const { low, high } = (this.went ??= { low: state.defocus, high: state.defocus });
    this.went = { low: Math.min(low, state.defocus), high: Math.max(high, state.defocus) };
    if (!measures) return;
    const done = this.steps.filter((step, k) => step.className !== "done" && LESSONS[this.name].steps[k][1](state, measures, this.went, read));
    for (const step of done) {
      step.className = "done";
      step.append(el("span", { class: "unseen" }, " (done)"));
    }
    if (done.length) this.went = { low: state.defocus, high: state.defocus };
  }
}
