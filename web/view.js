// One page, or one of several on a page: it holds the state, asks the engine as frames go by, and draws what comes.

import { acceptDrops, actions } from "./actions.js";
import { Client } from "./client.js";
import { Compare } from "./compare.js";
import { Controls } from "./controls.js";
import { el } from "./dom.js";
import { drawBar, drawFringes, drawPicture, drawPsf, drawWavefront } from "./draw.js";
import { layout } from "./layout.js";
import { askedLesson, Lessons, lessonState, nameLesson } from "./lessons.js";
import { testPicture } from "./pictures.js";
import { niceStep, niceTop, short } from "./plots.js";
import { PRESETS } from "./presets.js";
import { differenceSaid, numbersSaid, plotSaid, psfSaid, wavefrontSaid } from "./sentences.js";
import { FIELDS } from "./fields.js";
import { changed, DEFAULTS, fromText, toText } from "./state.js";
import { styleText } from "./style.js";
import { followTheme } from "./theme.js";
import { frequencyUnit, lengthUnit } from "./units.js";

const SETTLE = 150; // ms after the last change
const LINK = 250;
const PATIENCE = 3000; // ms that an answer may keep a newer question waiting
const LATE = "a newer setting was asked for";
const MAP_SIDE = 160;
const SEEN = 128;
// Keys that change how answers are shown, not the answers.
const LOOKS = new Set(["stretch", "map", "waves_unit", "length_unit", "focal_length", "picture"]);
// Those that no wavefront depends on, by distances and in waves.
const LOOKS_OF_PUPIL = new Set(["stretch", "map", "waves_unit", "length_unit", "picture", "light", "pixel", "view", "side"]);
const BESIDE_PUPIL = new Set([...LOOKS_OF_PUPIL, "focal_length", "f_number", "wavelength"]);

export class View {
  constructor(element, { state, onchange, url = false, controls = [], theme = "auto", lesson = "" } = {}) {
    this.onchange = onchange;
    this.url = url;
    const asked = (url && askedLesson()) || lesson;
    this.start = lessonState(asked) ?? changed(DEFAULTS, state);
    this.state = url ? changed(this.start, fromText(location.hash)) : this.start;
    this.told = this.state;
    const only = typeof controls === "string" ? controls.split(",").filter(Boolean) : controls ?? [];
    this.client = new Client();
    const set = (change, moving) => this.set(change, moving);
    this.controls = new Controls({ state: this.state, set, only });
    const does = actions(this);
    this.lessons = new Lessons((name, state) => this.learn(name, state));
    const { lessons } = this;
    this.page = layout({ state: this.state, set, controls: this.controls.node, lessons, presets: PRESETS, actions: does, only });
    lessons.show(asked);
    this.compare = new Compare(this.page);
    this.host = el("div", { class: "lommel-live-host", "data-lm-suppress-shortcuts": "true", "data-busy": true });
    if (url && new URLSearchParams(location.search).has("large")) this.host.dataset.large = ""; // for a projector
    const root = this.host.attachShadow({ mode: "open" });
    root.append(el("style", {}, styleText), this.page.node);
    // Shortcuts of the page around are not meant for what is typed here.
    root.addEventListener("keydown", (event) => event.stopPropagation());
    acceptDrops(this.page.recorded.closest("figure"), does.own);
    element.append(this.host);
    this.unfollow = followTheme(this.page.node, theme);
    this.fromLink = () => {
      const change = fromText(location.hash);
      if (Object.keys(change).length) this.set({ ...this.start, ...change }); // else it leads to a heading of the page
    };
    if (url) addEventListener("hashchange", this.fromLink);
    // Back to the lesson before, or to none.
    this.fromHistory = () => {
      const name = askedLesson();
      if (name === this.lessons.name) return;
      this.lessons.show(name);
      this.start = lessonState(name) ?? this.start;
      this.set({ ...this.start, ...fromText(location.hash) });
    };
    if (url) addEventListener("popstate", this.fromHistory);
    this.wanted = "settled";
    this.redraw = true;
    this.schedule();
  }

  destroy() {
    this.gone = true;
    cancelAnimationFrame(this.raf);
    for (const timer of [this.settling, this.linking, this.telling, this.warming]) clearTimeout(timer);
    removeEventListener("hashchange", this.fromLink);
    removeEventListener("popstate", this.fromHistory);
    this.unfollow();
    this.compare.destroy();
    for (const plot of Object.values(this.page.plots)) plot.destroy();
    this.client.destroy();
    this.host.remove();
  }

  set(change, moving = false) {
    const next = changed(this.state, change);
    const keys = Object.keys(FIELDS).filter((key) => next[key] !== this.state[key]);
    if (!keys.length) return;
    this.state = next;
    this.redraw = true;
    if (keys.includes("picture")) this.wanted ??= "picture";
    if (keys.some((key) => !LOOKS.has(key) || (key === "focal_length" && next.focus === "distances"))) {
      this.wanted = moving ? "drag" : "settled";
      clearTimeout(this.settling);
      this.settling = moving ? setTimeout(() => this.settle(), SETTLE) : 0;
    }
    this.schedule();
    if (!this.url) return;
    clearTimeout(this.linking);
    this.linking = setTimeout(() => this.writeLink(), LINK);
  }

  settle() {
    this.settling = 0;
    this.wanted = "settled";
    this.schedule();
  }

  schedule() {
    this.host.dataset.busy = "";
    this.raf ||= requestAnimationFrame(() => this.frame());
  }

  frame() {
    this.raf = 0;
    this.controls.update(this.state);
    for (const [key, select] of Object.entries(this.page.selects)) select.value = this.state[key];
    if (this.told !== this.state) {
      const preset = PRESETS[this.page.preset.value]?.state ?? {};
      if (Object.keys(preset).some((key) => preset[key] !== this.state[key])) this.page.preset.value = "";
      this.told = this.state;
      this.onchange?.({ ...this.state });
    }
    if (this.redraw) this.attempt(() => this.draw());
    if (this.wanted && !this.asking) this.ask();
    this.lessons.check(this.state);
    this.idle();
  }

  // What fails is told on the page, which lives on.
  attempt(run) {
    try {
      run();
    } catch (error) {
      this.tell(`This cannot be drawn: ${error.message}`);
    }
  }

  idle() {
    if (this.wanted || this.asking || this.settling || this.gone) return;
    delete this.host.dataset.busy;
    this.lessons.check(this.state, this.settled?.measures);
    this.say();
    // The first wavefront without symmetry makes tables, which take longest: before anybody waits for them.
    const other = { ...this.state, coma: 0.1, astigmatism: 0.1 };
    const warm = () => ["psf", "measures"].forEach((method) => this.client.call(method, other, "drag").catch(() => {}));
    this.warming ??= setTimeout(warm, 400);
  }

  // The state of a lesson, or none, which leaves what is there.
  learn(name, state) {
    if (state) this.set((this.start = { ...state, map: this.state.map }));
    if (this.url) nameLesson(name);
  }

  // Everything anew for the state as it is now; what changes meanwhile is asked next.
  async ask() {
    const quality = this.wanted;
    const { state, client } = this;
    this.wanted = null;
    this.asking = true;
    const jobs = [];
    if (quality !== "picture") {
      // Of the sensor's pixels no more than are seen, while something moves.
      const side = quality === "drag" && state.view !== "fine" ? Math.min(state.side, SEEN) : state.side;
      jobs.push(client.call("psf", { ...state, side }, quality).then((psf) => this.got({ psf })));
      jobs.push(client.call("measures", { ...state, side }, quality).then((measures) => this.got({ measures })));
      const beside = state.focus === "distances" ? LOOKS_OF_PUPIL : BESIDE_PUPIL;
      const pupil = Object.keys(state).map((key) => !beside.has(key) && state[key]).join();
      if (pupil !== this.pupil) jobs.push(client.call("maps", state, MAP_SIDE).then(({ wavefront }) => this.got({ wavefront })));
      this.pupil = pupil;
    }
    if (!this.page.panels.sensor.hidden) jobs.push(this.record(state, quality));
    const patience = setInterval(() => this.wanted && client.worker && client.renew({ message: LATE }), PATIENCE);
    const ends = await Promise.allSettled(jobs);
    clearInterval(patience);
    if (this.gone) return;
    this.asking = false;
    const fault = ends.find((end) => end.status === "rejected" && end.reason.message !== LATE);
    this.tell(fault ? `This setting cannot be computed: ${fault.reason.message}` : "");
    if (ends.some((end) => end.status === "rejected")) this.pupil = "";
    else if (quality === "settled") this.settled = { state, psf: this.shown.psf, measures: this.shown.measures };
    if (this.wanted) this.schedule();
    else this.idle();
  }

  async record(state, quality) {
    const picture = (state.picture === "own" && this.own) || testPicture(state.picture);
    const { planes, width, height } = picture;
    const fast = quality === "drag" ? "drag" : "settled";
    const recorded = await this.client.call("blur", state, planes, width, height, fast);
    const count = recorded.length / (width * height); // three of one, in white light
    this.got({ recorded: { ...picture, planes: recorded, count }, picture });
  }

  got(part) {
    if (this.gone) return;
    this.shown = { ...this.shown, ...part };
    this.draw(part);
  }

  draw(part = this.shown ?? {}) {
    this.redraw = false;
    const { page, state } = this;
    // How much of a sensor is worth a look is known by the measures, which come after.
    if (state.view === "fine" ? part.psf : part.measures) this.drawPsf();
    if (part.measures) this.drawPlots();
    if (part.wavefront) {
      this.seen = drawWavefront(page.wavefront, part.wavefront, MAP_SIDE);
      drawFringes(page.fringes, part.wavefront, MAP_SIDE);
      page.wavefrontSaid.textContent = wavefrontSaid(state, this.seen);
      const dark = short(state.obscuration, 3);
      page.fringesSaid.textContent = state.obscuration ? `the inner ${dark} of the radius obscured` : "clear to the middle";
    }
    if (part.recorded) drawPicture(page.recorded, page.before.checked ? this.shown.picture : this.shown.recorded);
    if (part.psf || part.measures) this.drawNumbers();
  }

  drawPsf() {
    const { page, state, shown, compare } = this;
    const { psf } = shown;
    const crop = state.view === "fine" ? psf.side : this.crop(psf);
    drawPsf(page.psf, psf, { map: state.map, stretch: state.stretch, crop });
    page.stage.dataset.view = state.view;
    const field = crop * psf.pixel;
    this.field = field;
    const { factor, name } = lengthUnit(state);
    const step = niceStep(field * factor, 4);
    const [text, bar] = page.ruler.children;
    text.textContent = `${short(step)} ${name}`;
    bar.style.width = `${(100 * step) / (field * factor)}%`;
    compare.draw(field, state.map);
    const looks = `${state.map} ${state.stretch}`;
    if (looks === this.looks) return;
    this.looks = looks;
    const ticks = drawBar(page.bar, state).map(([at, label]) => el("span", { style: `left:${100 * at}%` }, label));
    page.ticks.replaceChildren(...ticks);
  }

  // Of the sensor's pixels, the middle that holds most light, in steps so that it does not breathe.
  crop({ side, pixel }) {
    const d80 = this.shown.measures?.d80;
    if (!d80) return side;
    const wanted = 2 ** (Math.ceil(2 * Math.log2((4 * d80) / pixel)) / 2);
    return Math.min(side, Math.max(16, 2 * Math.round(wanted / 2)));
  }

  drawPlots() {
    const { page, state, shown, compare } = this;
    const { profile, energy, mtf } = shown.measures;
    const held = compare.held?.measures;
    const unit = lengthUnit(state);
    const scaled = (x, factor) => x.map((value) => value * factor);
    const curves = (table, factor, list, old) => {
      const x = scaled(table[Object.keys(table)[0]], factor);
      const now = list.map(([kind, name, key]) => ({ kind, name, x, y: table[key] }));
      const [first] = list;
      const before = old ? [{ kind: "held", name: "A", x: scaled(old[Object.keys(old)[0]], factor), y: old[first[2]] }] : [];
      return [...before, ...now];
    };
    const end = (table, factor) => (table.r ?? table.f).at(-1) * factor;
    const radius = { unit: unit.name, label: `radius (${unit.name})` };
    const log = state.stretch === "log";
    const top = niceTop(Math.max(...profile.mean, ...(held?.profile.mean ?? [])));
    page.plots.profile.draw({
      x: { ...radius, top: end(profile, unit.factor) },
      y: log ? { log, bottom: 1e-5, top: 1 } : { top },
      curves: curves(profile, unit.factor, [["main", "mean", "mean"], ["limit", "unaberrated", "reference"]], held?.profile),
    });
    page.plots.energy.draw({
      x: { ...radius, top: end(energy, unit.factor) },
      y: { top: 1 },
      curves: curves(energy, unit.factor, [["main", "light", "share"], ["limit", "unaberrated", "reference"]], held?.energy),
    });
    const frequency = frequencyUnit(state);
    page.plots.mtf.draw({
      x: { unit: frequency.name, label: frequency.name, top: end(mtf, frequency.factor) },
      y: { top: 1 },
      curves: curves(mtf, frequency.factor, [["main", "x", "x"], ["second", "y", "y"], ["limit", "limit", "limit"]], held?.mtf),
    });
  }

  drawNumbers() {
    const { page, state, shown, compare } = this;
    const now = numbersSaid(state, shown.psf, shown.measures);
    const held = compare.held && numbersSaid(state, compare.held.psf, compare.held.measures);
    for (const [key, [text, value]] of Object.entries(now)) {
      const by = held ? differenceSaid(value, held[key][1]) : "";
      page.numbers[key].replaceChildren(text, ...(by ? [el("small", {}, by)] : []));
    }
  }

  // Sentences about the pictures are renewed when nothing moves.
  say() {
    const { page, state, shown } = this;
    if (!shown?.psf || !shown.measures) return;
    const said = psfSaid(state, shown.psf, shown.measures);
    page.code.textContent = shown.psf.python;
    page.psf.setAttribute("aria-label", said);
    if (this.seen) page.wavefront.setAttribute("aria-label", `Wavefront over the pupil: ${wavefrontSaid(state, this.seen)}.`);
    const name = page.selects.picture.selectedOptions[0]?.text ?? "Picture";
    const pitch = `a sensor with pixels of ${short(state.pixel)} micrometres`;
    page.recorded.setAttribute("aria-label", `${name}, blurred as ${pitch} records it.`);
    const titles = { profile: "Profile", energy: "Encircled energy", mtf: "MTF" };
    for (const [key, { node, shown: curves }] of Object.entries(page.plots))
      if (curves) node.setAttribute("aria-label", plotSaid(titles[key], curves.x, curves.curves));
    clearTimeout(this.telling);
    this.telling = setTimeout(() => (page.said.textContent = said), 700);
  }

  tell(text) {
    this.page.notice.hidden = !text;
    if (this.page.notice.textContent !== text) this.page.notice.textContent = text;
  }

  writeLink() {
    const text = toText(this.state);
    try {
      history.replaceState(history.state, "", text ? `#${text}` : location.pathname + location.search);
    } catch {
      // A page that has no address of its own, as within a frame.
    }
  }
}
