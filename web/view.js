// One page, or one of several on a page: it holds the state, asks the engine as frames go by, and draws what comes.

import { acceptDrops, actions } from "./actions.js";
import { Client } from "./client.js";
import { Compare } from "./compare.js";
import { Controls, Play } from "./controls.js";
import { Depth } from "./depth.js";
import { el } from "./dom.js";
import { drawFringes, drawPicture, drawWavefront } from "./draw.js";
import { english, follow, isGerman, speak, tell } from "./language.js";
import { layout, UNNAMED } from "./layout.js";
import { askedLesson, begun, goTo, Lessons, lessonState, nameLesson } from "./lessons.js";
import { STAR, testPicture } from "./pictures.js";
import { curveSaid, niceTop, read, short, svg } from "./plots.js";
import { PRESETS } from "./presets.js";
import { computedSaid, differenceSaid, numbersSaid, plotSaid, psfSaid, unprovenSaid, wavefrontSaid } from "./sentences.js";
import { FIELDS } from "./fields.js";
import { Stage } from "./stage.js";
import { changed, DEFAULTS, fromText, History, refused, toText, withSpikes, wordsIn } from "./state.js";
import { styleText } from "./style.js";
import { followTheme } from "./theme.js";
import { frequencyUnit, lengthUnit, unitAfter } from "./units.js";

const SETTLE = 150; // ms after the last change
const LINK = 250;
const PATIENCE = 3000; // ms that an answer may keep a newer question waiting
const LATE = "a newer setting was asked for";
const GREY = 200; // ms after which an answer to an older setting is greyed
const WORDS = 2000; // ms after which the page says what it computes
const MAP_SIDE = 160;
const MTF_CURVES = [
  ["main", "x", "x"],
  ["second", "y", "y"],
  ["limit", "limit", "limit"],
  ["main pixel", "x with pixel", "pixel_x"],
  ["second pixel", "y with pixel", "pixel_y"],
];
// Keys that change how answers are shown, not the answers.
const LOOKS = new Set(["stretch", "map", "waves_unit", "length_unit", "focal_length", "picture"]);
// Those that no wavefront depends on, by distances and in waves.
const LOOKS_OF_PUPIL = new Set(["stretch", "map", "waves_unit", "length_unit", "picture", "light", "pixel", "view", "side"]);
const BESIDE_PUPIL = new Set([...LOOKS_OF_PUPIL, "focal_length", "f_number", "wavelength"]);

// Those by which a lens is not known.
const BESIDE_LENS = new Set([...LOOKS, "view", "side"]);
const sameLens = (a, b) => Object.keys(FIELDS).every((key) => BESIDE_LENS.has(key) || key === "pixel" || a[key] === b[key]);

// By which pictures are compared: A takes them from B.
const SAMPLING = ["view", "side", "pixel"];
const sampledAs = (state, { view, side, pixel }) => ({ ...state, view, side, pixel });

const FINISHED = ["hold", "python", "png", "csv", "tiff"]; // buttons that act on settled answers
const CANVASES = { psf: ["psf"], wavefront: ["wavefront", "fringes"], recorded: ["recorded"] };

// The nodes in which each part of an answer is shown.
function partsOf(page) {
  const { sensor, pupil, numbers, curves, code } = page.panels;
  const frame = page.psf.parentNode;
  return { psf: [frame, numbers], rays: [frame], measures: [numbers, curves], wavefront: [pupil], recorded: [sensor], code: [code] };
}

// Whether a part of an answer depends on a setting.
function matters(part, key, { focus }) {
  if (part === "wavefront") return !(focus === "distances" ? LOOKS_OF_PUPIL : BESIDE_PUPIL).has(key);
  return !LOOKS.has(key) || (focus === "distances" && key === "focal_length") || (part === "recorded" && key === "picture");
}

// The state with the pixels of a picture that was reduced.
const sensorOf = (state, { reduced = 1 }) => ({ ...state, pixel: state.pixel * reduced });

// What takes long in a state.
function longSaid({ view, light }) {
  if (view === "averaged") return "averages over pixels";
  return light === "white" ? "white light, seven wavelengths" : "large aberrations";
}

export class View {
  // name: of the lens in the initial state, and what of it is left out; heading: level of the page's heading; docs: address of the documentation.
  constructor(element, { state, onchange, url = false, controls = [], theme = "auto", lesson = "", name = "", left_out = "", heading = 2, docs = "", language = "" } = {}) {
    this.onchange = onchange;
    this.url = url;
    this.title = document.title;
    const asked = (url && askedLesson()) || lesson;
    this.given = changed(DEFAULTS, withSpikes(state));
    this.start = lessonState(asked) ?? this.given;
    this.state = url ? changed(this.start, withSpikes(fromText(location.hash), this.start)) : this.start;
    this.told = this.state;
    const only = typeof controls === "string" ? controls.split(",").filter(Boolean) : controls ?? [];
    this.client = new Client();
    this.history = new History();
    this.lenses = PRESETS.map((preset) => ({ ...preset, state: changed(DEFAULTS, preset.state) }));
    if (name) this.lenses.unshift({ name, source: "", left_out, state: this.given });
    if (url) this.nameFromLink();
    const set = (change, moving, gesture) => this.set(change, moving, gesture);
    const level = Math.min(5, Math.max(1, Number(heading) || 2));
    const spokenAs = (url && new URLSearchParams(location.search).get("lang")) || language;
    if (spokenAs) speak(spokenAs);
    const touched = (key) => key !== this.play.key && this.play.choose(key);
    this.controls = new Controls({ state: this.state, set, touched, only, level });
    const does = {
      ...actions(this),
      undo: () => this.travel(this.history.undo(this.state)),
      redo: () => this.travel(this.history.redo(this.state)),
      stop: () => (this.stopped ? this.settle() : this.stop()),
      play: () => this.play.press(),
      language: () => this.speak(isGerman() ? "en" : "de"),
    };
    this.lessons = new Lessons((name, state) => this.learn(name, state), level, (shown) => this.showDepth(shown, level));
    const { lessons } = this;
    const parts = { controls: this.controls.node, lessons, presets: PRESETS, actions: does, only, level, docs };
    this.page = layout({ state: this.state, set, ...parts });
    this.parts = partsOf(this.page);
    this.play = new Play({ controls: this.controls, button: this.page.play, set, state: () => this.state });
    lessons.show(asked);
    for (const plot of Object.values(this.page.plots)) plot.told = () => "busy" in this.host.dataset || this.checkLesson();
    this.compare = new Compare(this.page);
    this.stage = new Stage(this.page, MAP_SIDE);
    this.host = el("div", { class: "lommel-live-host", "data-lm-suppress-shortcuts": "true", "data-busy": true });
    if (url && new URLSearchParams(location.search).has("large")) this.host.dataset.large = ""; // for a projector
    const root = this.host.attachShadow({ mode: "open" });
    root.append(el("style", {}, styleText), this.page.node);
    // Shortcuts of the page around are not meant for what is typed here.
    root.addEventListener("keydown", (event) => this.key(event));
    root.addEventListener("click", (event) => this.guard(event), true);
    acceptDrops(this.page.node, does.file);
    root.addEventListener("pointerdown", (event) => event.target !== this.page.play && this.play.stop());
    this.hide = () => document.hidden && this.play.stop();
    document.addEventListener("visibilitychange", this.hide);
    // Keys while nothing has the focus are for the page that has the address.
    this.keys = (event) => {
      if (event.key === "Escape") {
        this.page.tip.hidden = true;
        this.play.stop();
      }
      if (url && event.target === document.body) this.key(event);
    };
    document.addEventListener("keydown", this.keys);
    element.append(this.host);
    const { node, language: button } = this.page;
    const unfollow = [followTheme(node, theme)];
    // What is shown by other means than texts is shown anew.
    const spoken = () => {
      node.lang = isGerman() ? "de" : "en";
      button.textContent = isGerman() ? "EN" : "DE";
      this.controls.forget();
    };
    unfollow.push(follow(node, spoken));
    spoken();
    this.unfollow = () => unfollow.forEach((stop) => stop());
    this.fromLink = () => {
      const change = fromText(location.hash), said = refused(change, location.hash);
      if (!Object.keys(change).length && !said) return; // it leads to a heading of the page
      this.set({ ...this.start, ...withSpikes(change, this.start) });
      this.remark(said);
      this.nameFromLink();
    };
    if (url) addEventListener("hashchange", this.fromLink);
    // Back to the setting that the page or a lesson began with, to the lesson before, or to none.
    this.fromHistory = ({ state }) => {
      const name = askedLesson();
      if (name === this.lessons.name && begun(state) === undefined) return;
      if (name !== this.lessons.name) this.lessons.show(name);
      this.start = lessonState(name) ?? this.given;
      this.set({ ...this.start, ...withSpikes(fromText(location.hash), this.start) });
      clearTimeout(this.linking); // the address stays as it was
    };
    if (url) addEventListener("popstate", this.fromHistory);
    if (url && begun(history.state) === undefined) goTo(location.href, { begun: true });
    this.wanted = "settled";
    this.redraw = true;
    if (url) this.remark(refused(fromText(location.hash), location.hash, this.lessons.name ? "" : askedLesson()));
    this.born = performance.now();
    this.shown = {};
    this.of = {}; // the question that each part shown answers, {state, left: {part: when its setting was left}}
    this.schedule();
  }

  destroy() {
    this.gone = true;
    cancelAnimationFrame(this.raf);
    clearInterval(this.watch);
    this.play.stop();
    document.removeEventListener("visibilitychange", this.hide);
    document.removeEventListener("keydown", this.keys);
    for (const timer of [this.settling, this.linking, this.telling, this.warming]) clearTimeout(timer);
    removeEventListener("hashchange", this.fromLink);
    removeEventListener("popstate", this.fromHistory);
    this.unfollow();
    this.compare.destroy();
    for (const plot of Object.values(this.page.plots)) plot.destroy();
    this.depth?.destroy();
    this.client.destroy();
    this.host.remove();
  }

  // Changes of one gesture, such as a drag, are one step back.
  set(change, moving = false, gesture = "") {
    const before = this.state;
    change = withSpikes(change, before);
    // Photons are counted by pixels of the sensor.
    if (change.noise === "on" && before.noise === "off" && before.view === "fine" && !("view" in change)) change = { ...change, view: "averaged" };
    if (this.apply(changed(before, change), moving)) this.history.note(before, gesture);
  }

  travel(state) {
    if (state) this.apply(state);
  }

  apply(next, moving = false) {
    const keys = Object.keys(FIELDS).filter((key) => next[key] !== this.state[key]);
    if (!keys.length) return false;
    this.state = next;
    this.remark("");
    this.redraw = true;
    this.leave(keys);
    if (keys.includes("picture")) this.wanted ??= "picture";
    if (keys.some((key) => matters("psf", key, next))) {
      this.wanted = moving ? "drag" : "settled";
      clearTimeout(this.settling);
      this.settling = moving ? setTimeout(() => this.settle(), SETTLE) : 0;
    }
    this.schedule();
    if (!this.url) return true;
    clearTimeout(this.linking);
    this.linking = setTimeout(() => this.writeLink(), LINK);
    return true;
  }

  // What is shown, or asked for, answers an older setting from now on.
  leave(keys) {
    const now = performance.now();
    for (const question of new Set([this.asked, ...Object.values(this.of)]))
      for (const part of Object.keys(this.parts)) if (question && keys.some((key) => matters(part, key, this.state))) question.left[part] ??= now;
  }

  current(part) {
    return this.of[part] !== undefined && this.of[part].left[part] === undefined;
  }

  // Grey is what answers an older setting; what takes long is said, and can be stopped.
  look() {
    const { page } = this;
    const now = performance.now();
    const late = new Map();
    let most = 0;
    for (const [part, nodes] of Object.entries(this.parts)) {
      if (part === "rays" && !this.of.rays) continue;
      const since = this.of[part] ? this.of[part].left[part] : this.born;
      const age = since === undefined ? 0 : now - since;
      if (nodes.some((node) => !node.hidden) && part !== "code") most = Math.max(most, age);
      for (const node of nodes) late.set(node, late.get(node) || age > GREY);
    }
    for (const [node, old] of late) node.classList.toggle("late", old);
    const { held } = this.compare;
    page.held.parentNode.classList.toggle("late", Boolean(held) && SAMPLING.some((key) => held.state[key] !== this.state[key]));
    const busy = "busy" in this.host.dataset;
    page.node.classList.toggle("working", busy && most > GREY);
    const said = this.stopped ? "Stopped: nothing is computed for this setting." : busy && most > WORDS ? `Computing: ${longSaid(this.state)} …` : "";
    tell(page.working, said);
    page.work.classList.toggle("shown", Boolean(said));
    tell(page.stop, this.stopped ? "Compute" : "Stop");
    const kept = { undo: this.history.back.length, redo: this.history.forth.length };
    for (const name of FINISHED) kept[name] = this.current("code");
    for (const [name, there] of Object.entries(kept)) page[name].setAttribute("aria-disabled", String(!there));
  }

  stop() {
    this.stopped = true;
    this.wanted = null;
    clearTimeout(this.settling);
    this.settling = 0;
    this.client.stop();
    this.blank(Object.keys(this.parts).filter((part) => !this.current(part)));
    this.idle();
  }

  // Nothing instead of answers to an older setting.
  blank(parts) {
    for (const part of parts) {
      delete this.shown[part];
      delete this.of[part];
      if (part === "measures") for (const plot of Object.values(this.page.plots)) plot.clear();
      if (part === "code") this.page.code.textContent = "–";
      if (part === "wavefront") this.page.wavefrontSaid.textContent = this.page.fringesSaid.textContent = "–";
      for (const canvas of CANVASES[part] ?? []) this.page[canvas].getContext("2d").clearRect(0, 0, 1e5, 1e5);
    }
    if (parts.includes("code")) this.settled = undefined;
    if (parts.includes("psf")) this.stage.clear();
    this.drawNumbers();
    this.say();
  }

  // Shortcuts of the page around are not meant for what is typed here.
  key(event) {
    event.stopPropagation();
    if (event.target !== this.page.play || event.key === "Escape") this.play.stop();
    if (!(event.ctrlKey || event.metaKey) || event.altKey || !/^[zy]$/i.test(event.key)) return;
    if (this.controls.typing()) return; // the box undoes what is typed
    event.preventDefault();
    const forth = event.shiftKey || /y/i.test(event.key);
    this.travel(forth ? this.history.redo(this.state) : this.history.undo(this.state));
  }

  // Buttons that have nothing to act on yet say so, and keep the focus.
  guard(event) {
    const button = event.target.closest?.("button[data-action]");
    if (!button) return;
    this.look();
    if (button.getAttribute("aria-disabled") !== "true") return;
    event.stopImmediatePropagation();
    if (FINISHED.includes(button.dataset.action)) this.page.said.textContent = "Still computing: possible when it is done.";
  }

  settle() {
    this.settling = 0;
    this.wanted = "settled";
    this.schedule();
  }

  schedule() {
    this.host.dataset.busy = "";
    this.stopped = false;
    this.watch ??= setInterval(() => this.look(), 50);
    this.raf ||= requestAnimationFrame(() => this.frame());
  }

  frame() {
    this.raf = 0;
    this.controls.update(this.state);
    for (const [key, select] of Object.entries(this.page.selects)) select.value = this.state[key];
    if (this.told !== this.state) {
      this.told = this.state;
      this.onchange?.({ ...this.state });
    }
    if (this.named !== this.state) this.nameLens();
    if (this.redraw) this.attempt(() => this.draw());
    if (this.wanted && !this.asking) this.ask();
    this.lessons.check(this.state);
    this.idle();
  }

  // The heading: the lens while nothing of it is changed, with its source; the lens that was changed; or what the page is.
  nameLens() {
    const { page, state } = this;
    this.named = state;
    const exact = this.lenses.find((lens) => sameLens(lens.state, state));
    if (exact || sameLens(this.start, state)) this.lens = exact;
    this.exact = exact;
    // A lens without aberration that is changed is any lens.
    const from = this.lens && this.lens.name !== PRESETS[0].name ? `Changed from: ${this.lens.name.replace(/^Changed from: /, "")}` : "";
    const { heading } = this.lessons;
    if (this.url) document.title = heading || this.title;
    const plain = this.depth || exact?.name === PRESETS[0].name; // where a lesson starts: its title says more
    page.name.textContent = plain && heading ? heading : exact ? exact.name : from || heading || UNNAMED;
    page.name.title = english(page.name); // the heading is cut where there is no room
    page.preset.value = String(PRESETS.findIndex(({ name }) => name === exact?.name)).replace("-1", "");
    page.preset.title = english(page.preset.selectedOptions[0]);
    // What was left out stays so however the lens is changed.
    const without = (exact ?? this.lens)?.left_out;
    const said = [without && `Left out here: ${without}. All that is shown is of the rest.`, exact?.source].filter(Boolean).join(" ");
    page.source.hidden = !said;
    page.source.classList.toggle("warns", Boolean(without));
    page.source.firstChild.textContent = said;
  }

  // A lens by its name, source and state, such as a preset: how answers look stays as it is.
  take(lens) {
    const state = { ...changed(DEFAULTS, lens.state) };
    for (const key of BESIDE_LENS) if (key !== "focal_length") state[key] = this.state[key];
    this.lenses = [{ source: "", left_out: "", ...lens, state }, ...this.lenses.filter(({ name }) => name !== lens.name)];
    this.lens = this.named = undefined; // other notes, even of the same numbers
    this.set(state);
    this.schedule();
  }

  // The lens file, unchanged since, whose table of Zernike coefficients is not open.
  get waiting() {
    return this.lenses.find((lens) => sameLens(lens.state, this.state))?.waiting;
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
    clearInterval(this.watch);
    this.watch = undefined;
    this.look();
    if (this.stopped) return;
    this.checkLesson();
    this.play.follow();
    this.say();
    // The first wavefront without symmetry makes tables, which take longest: before anybody waits for them.
    const other = { ...DEFAULTS, coma: 0.1, astigmatism: 0.1 };
    const warm = () => ["psf", "measures"].forEach((method) => this.client.call(method, other, "drag").catch(() => {}));
    this.warming ??= setTimeout(warm, 400);
  }

  checkLesson() {
    const read = Object.entries(this.page.plots).map(([key, { pointed }]) => [key, pointed]);
    this.lessons.check(this.state, this.settled?.measures, { ...Object.fromEntries(read), depth: this.depth?.read });
  }

  // Depth from pairs of pictures in place of all else, or no longer.
  showDepth(shown, level) {
    if (shown === Boolean(this.depth)) return;
    this.page.node.toggleAttribute("data-depth", shown);
    if (!shown) return (this.depth = this.depth.destroy());
    this.depth = new Depth({ client: this.client, level, told: () => "busy" in this.host.dataset || this.checkLesson() });
    this.page.side.after(this.depth.node);
  }

  // The state of a lesson, or none, which leaves what is there.
  learn(name, state) {
    this.start = state ? { ...state, map: this.state.map } : this.given;
    if (state) this.set(this.start);
    this.nameLens(); // also where no value changes, as when a lesson is closed
    if (this.url) nameLesson(name);
  }

  // Everything anew for the state as it is now; what changes meanwhile is asked next.
  async ask() {
    const quality = this.wanted;
    const { state, client } = this;
    this.wanted = null;
    this.asking = true;
    const asked = (this.asked = { state, left: {} });
    const got = (part) => this.got(part, asked);
    const jobs = [];
    if (quality !== "picture") {
      jobs.push(client.call("psf", state, quality).then((psf) => got({ psf })));
      jobs.push(client.call("measures", state, quality).then((measures) => got({ measures })));
      const pupil = Object.keys(state).map((key) => matters("wavefront", key, state) && state[key]).join();
      if (pupil !== this.pupil) jobs.push(client.call("maps", state, MAP_SIDE).then(({ wavefront, low, high }) => got({ wavefront: Object.assign(wavefront, { low, high }) })));
      this.pupil = pupil;
      this.renewHeld(state, quality, jobs);
    }
    if (state.rays !== "on") {
      this.shown = { ...this.shown, rays: null };
      delete this.of.rays;
    } else if (quality !== "picture") jobs.push(client.call("rays", state).then((rays) => got({ rays })));
    if (!this.page.panels.sensor.hidden) jobs.push(this.record(state, quality, got));
    const patience = setInterval(() => this.wanted && client.worker && client.stop(LATE), PATIENCE);
    const ends = await Promise.allSettled(jobs);
    clearInterval(patience);
    if (this.gone) return;
    this.asking = false;
    const fault = ends.find((end) => end.status === "rejected" && end.reason.message !== LATE);
    const ended = this.stopped || !fault ? "" : `This setting cannot be computed: ${fault.reason.message}`;
    this.tell(ended);
    if (ended && !this.wanted) this.blank(Object.keys(this.parts).filter((part) => !this.current(part)));
    if (ends.some((end) => end.status === "rejected")) this.pupil = "";
    else if (quality === "settled") {
      const { psf, measures, rays } = this.shown;
      this.settled = { state, psf, measures, rays };
      this.of.code = asked;
    }
    if (this.wanted) this.schedule();
    else this.idle();
  }

  // A anew where B has another sampling, window or pixel, so that both are of the same ones.
  renewHeld(state, quality, jobs) {
    const { client, compare } = this;
    const { held } = compare;
    if (!held) return;
    const same = SAMPLING.every((key) => held.state[key] === state[key]);
    if (same && (held.quality !== "drag" || quality === "drag")) return;
    const asked = sampledAs(held.state, state);
    const made = ["psf", "measures"].map((method) => client.call(method, asked, quality));
    const renewed = Promise.all(made).then(([psf, measures]) => {
      if (this.gone || this.stopped || compare.held !== held) return;
      compare.renew({ state: asked, psf, measures, quality, picture: undefined, sentence: psfSaid(asked, psf, measures) });
      this.draw({ psf: this.shown.psf, measures: this.shown.measures, recorded: this.shown.recorded });
    });
    jobs.push(renewed.catch((error) => {
      if (error.message === LATE || this.stopped || compare.held !== held) throw error;
      compare.release();
      this.remark(`A was let go, for with this sampling it cannot be computed: ${error.message}.`);
      this.draw();
    }));
  }

  async record(state, quality, got) {
    const picture = (state.picture === "own" && this.own) || testPicture(state.picture);
    const { planes, width, height } = picture;
    const fast = quality === "drag" ? "drag" : "settled";
    const recorded = await this.client.call("blur", sensorOf(state, picture), planes, width, height, fast);
    const count = recorded.length / (width * height); // three of one, in white light
    got({ recorded: { ...picture, planes: recorded, count }, picture });
  }

  got(part, asked) {
    if (this.gone || this.stopped) return;
    this.shown = { ...this.shown, ...part };
    for (const name of Object.keys(part)) this.of[name] = asked;
    this.draw(part);
    this.look();
  }

  // The state that a part answers, looking as the controls say.
  stateOf(part) {
    const { state } = this;
    const asked = this.of[part]?.state;
    const own = (key) => asked && (matters(part, key, state) || matters(part, key, asked));
    return Object.fromEntries(Object.keys(state).map((key) => [key, (own(key) ? asked : state)[key]]));
  }

  draw(part = this.shown) {
    this.redraw = false;
    const { page } = this;
    const state = this.stateOf("wavefront");
    // How much of a sensor is worth a look is known by the measures, which come after.
    if (this.shown.psf && (this.stateOf("psf").view === "fine" ? part.psf : part.measures)) this.drawPsf();
    if (part.measures) this.drawPlots();
    if (part.wavefront) {
      const { low, high } = part.wavefront;
      this.seen = { ...drawWavefront(page.wavefront, part.wavefront, MAP_SIDE), ...(high === undefined ? {} : { low, high }) };
      const resolved = drawFringes(page.fringes, part.wavefront, MAP_SIDE);
      this.stage.showWavefront(part.wavefront);
      page.wavefrontSaid.textContent = wavefrontSaid(state, this.seen);
      const dark = short(state.obscuration, 3);
      const inner = state.obscuration ? `inner ${dark} of the radius obscured` : "no central obscuration";
      page.fringesSaid.textContent = resolved ? inner : "grey: too many fringes to draw";
    }
    if (part.recorded) this.drawRecorded();
    if (part.psf || part.measures) {
      this.drawNumbers();
      this.stage.renew(this.shown);
    }
    if (part.rays && !part.psf && this.shown.psf) this.drawPsf();
  }

  drawPsf() {
    const { shown, compare } = this;
    const state = this.stateOf("psf");
    this.stage.draw({ state, shown, held: compare.held, mode: compare.shown, shared: compare.shared });
    const said = computedSaid(state, shown.psf);
    this.page.computed.hidden = !said;
    tell(this.page.computed, said);
  }

  // What figureOf draws: settled answers, as they look now.
  figure() {
    const { settled, compare, page } = this;
    const looks = Object.fromEntries([...LOOKS].map((key) => [key, this.state[key]]));
    const name = english(page.name) === UNNAMED ? "" : english(page.name);
    return { state: { ...settled.state, ...looks }, shown: settled, held: compare.held, mode: compare.shown, shared: compare.shared, name };
  }

  // The picture on the sensor: as it is, through the lens, or through the held one, A.
  drawRecorded() {
    const { page, shown, compare } = this;
    if (!shown?.recorded) return;
    const { held } = compare;
    this.drawRings();
    if (page.before.checked) drawPicture(page.recorded, shown.picture);
    else if (!held || !page.heldPicture.checked) drawPicture(page.recorded, shown.recorded);
    else if (held.picture === shown.picture) drawPicture(page.recorded, held.recorded);
    else this.recordHeld(held, shown.picture);
  }

  // Spatial frequencies of the spokes of the star on the sensor, by their distance from its middle.
  drawRings() {
    const { page, state } = this;
    const there = state.picture === "star";
    page.rings.toggleAttribute("hidden", !there);
    const print = there && `${state.pixel} ${state.length_unit} ${state.focal_length} ${state.f_number} ${state.wavelength}`;
    if (!there || print === this.ringed) return;
    this.ringed = print;
    const { factor, name } = frequencyUnit(state);
    const perRadius = (1000 / state.pixel) * factor * (STAR.spokes / (2 * Math.PI));
    const marks = [];
    let last = Infinity;
    for (let f = niceTop(perRadius / STAR.radius); perRadius / f > 16; f = niceTop(1.01 * f)) {
      const x = STAR.middle[0] + perRadius / f;
      const y = STAR.middle[1];
      const r = perRadius / f;
      if (last - r < 10 + 7 * short(f, 2).length) continue; // their numbers would overlap
      last = r;
      marks.push(svg("path", { d: `M${x - r * 0.134} ${y - r / 2}A${r} ${r} 0 0 1 ${x - r * 0.134} ${y + r / 2}` }), svg("text", { x, y: y + 4 }, short(f, 2)));
    }
    page.rings.replaceChildren(...marks, svg("text", { x: 380, y: 282, "text-anchor": "end" }, name));
  }

  async recordHeld(held, picture) {
    const { planes, width, height } = picture;
    const recorded = await this.client.call("blur", sensorOf(held.state, picture), planes, width, height, "settled").catch(({ message }) => {
      this.tell(`The picture through A cannot be computed: ${message}`);
    });
    if (this.gone || !recorded) return;
    Object.assign(held, { picture, recorded: { ...picture, planes: recorded, count: recorded.length / (width * height) } });
    this.drawRecorded();
  }

  drawPlots() {
    const { page, shown, compare } = this;
    const state = this.stateOf("measures");
    const { profile, energy, mtf, d80, d80_axis } = shown.measures;
    const held = compare.held?.measures;
    const unit = lengthUnit(state);
    const scaled = (x, factor) => x.map((value) => value * factor);
    const curves = (table, factor, list, old) => {
      const x = scaled(table[Object.keys(table)[0]], factor);
      // Of A the curves that have a meaning without its sensor.
      const lasting = (old ? list : []).filter(([kind]) => kind === "main" || kind === "second");
      const named = (which, name) => (lasting.length > 1 ? `${which} ${name}` : which);
      const now = list.map(([kind, name, key]) => ({ kind, name: lasting.some(([one]) => one === kind) ? named("B", name) : name, x, y: table[key] }));
      const before = lasting.map(([kind, name, key]) => ({
        kind: kind === "main" ? "held" : "held second",
        name: named("A", name),
        x: scaled(old[Object.keys(old)[0]], factor),
        y: old[key],
      }));
      return [...before, ...now];
    };
    const end = (table, factor) => (table.r ?? table.f).at(-1) * factor;
    const radius = { unit: unit.name, label: `radius (${unit.name})` };
    const log = state.stretch === "log";
    // Up to the unaberrated peak, but where the curve would be flat.
    const high = niceTop(Math.max(...profile.mean, ...(held?.profile.mean ?? [])));
    const top = high < 0.2 ? high : Math.max(1, high);
    page.plots.profile.draw({
      x: { ...radius, top: end(profile, unit.factor) },
      y: log ? { log, bottom: 1e-5, top: 1 } : { top },
      curves: curves(profile, unit.factor, [["main", "mean", "mean"], ["limit", "unaberrated", "reference"]], held?.profile),
    });
    page.plots.energy.draw({
      x: { ...radius, top: end(energy, unit.factor) },
      y: { top: 1 },
      curves: curves(energy, unit.factor, [["main", "light", "share"], ["limit", "unaberrated", "reference"]], held?.energy),
      mark: { said: d80_axis === d80 || !(d80_axis > 0) ? "" : `80 % about the axis: ${short(d80_axis * unit.factor)}${unitAfter(unit.name)}` },
    });
    const frequency = frequencyUnit(state);
    // Of the sensor: half a cycle in each pixel.
    const nyquist = (500 / state.pixel) * frequency.factor;
    const last = end(mtf, frequency.factor);
    const there = (x, y, names = ["x ", "y "]) => {
      const [a, b] = [x, y].map((curve) => curveSaid(read({ x: mtf.f, y: curve }, nyquist / frequency.factor), mtf.error));
      const by = mtf.error && !(a.startsWith("<") && b.startsWith("<")) ? ` ± ${Math.ceil(1e3 * mtf.error) / 1e3}` : "";
      return `${a === b ? a : `${names[0]}${a}, ${names[1]}${b}`}${by}`;
    };
    const contrast = nyquist > last ? "beyond the diffraction limit" : `MTF ${there(mtf.x, mtf.y)}; with pixel ${there(mtf.pixel_x, mtf.pixel_y, ["", ""])}`;
    page.plots.mtf.draw({
      x: { unit: frequency.name, label: frequency.name, top: last },
      y: { top: 1 },
      curves: curves(mtf, frequency.factor, MTF_CURVES, held?.mtf),
      error: Math.max(mtf.error, held?.mtf.error ?? 0),
      mark: { at: nyquist, name: "Nyquist", said: mtf.refused ?? `Nyquist ${short(nyquist, 3)} ${frequency.name}: ${contrast}` },
    });
  }

  drawNumbers() {
    const { page, shown, compare } = this;
    const state = this.stateOf("measures");
    const now = numbersSaid(state, shown.psf, shown.measures);
    const held = compare.held ? numbersSaid(state, compare.held.psf, compare.held.measures) : {};
    for (const [key, node] of Object.entries(page.numbers)) {
      const by = now[key] && differenceSaid(now[key], held[key]);
      node.replaceChildren(now[key]?.text ?? "–", ...(by ? [el("small", {}, by)] : []));
    }
    const why = unprovenSaid(state, shown.psf);
    if (why === this.unproven) return;
    this.unproven = why;
    page.why?.remove();
    page.why = !why ? null : el("div", { class: "why" }, el("dt", { class: "unseen" }, "Why no error is proven"), el("dd", {}, why));
    if (why) page.panels.numbers.append(page.why);
  }

  // Sentences about the pictures are renewed when nothing moves.
  say() {
    const { page, state, shown } = this;
    const none = (what) => `${what}: not computed for this setting.`;
    const said = shown.psf && shown.measures ? psfSaid(state, shown.psf, shown.measures) : none("Point spread function");
    if (this.settled) page.code.textContent = this.settled.psf.python;
    page.psf.setAttribute("aria-label", this.compare.shown === "difference" ? `Difference, B minus A. B: ${said}` : said);
    if (!shown.wavefront) page.wavefront.setAttribute("aria-label", none("Wavefront over the pupil"));
    else if (this.seen) page.wavefront.setAttribute("aria-label", `Wavefront over the pupil: ${wavefrontSaid(state, this.seen)}.`);
    const [picked] = page.selects.picture.selectedOptions;
    const name = picked ? english(picked) : "Picture";
    const { width, height, reduced = 1 } = shown.picture ?? {};
    const pitch = `a sensor with pixels of ${short(sensorOf(state, { reduced }).pixel)} micrometres`;
    page.recorded.setAttribute("aria-label", shown.recorded ? `${name}, blurred as ${pitch} records it.` : none(name));
    page.recorded.title = reduced > 1 ? `Reduced to ${width} × ${height} pixels, of ${short(sensorOf(state, { reduced }).pixel, 3)} µm each` : "";
    const titles = { profile: "Profile", energy: "Encircled energy", mtf: "MTF" };
    for (const [key, { node, shown: curves }] of Object.entries(page.plots))
      node.setAttribute("aria-label", !curves ? none(titles[key]) : (key === "mtf" && shown.measures?.mtf.refused) || plotSaid(titles[key], curves.x, curves.curves));
    clearTimeout(this.telling);
    this.telling = setTimeout(() => (page.said.textContent = said), 700);
  }

  // In another language, which the address then names.
  speak(language) {
    speak(language);
    if (!this.url) return;
    const address = new URL(location.href);
    address.searchParams.set("lang", language);
    goTo(address);
  }

  tell(text) {
    this.said = text;
    const whole = [this.remarked, text].filter(Boolean).join(" ");
    this.page.notice.hidden = !whole;
    tell(this.page.notice, whole);
  }

  // What is told until the next change.
  remark(text) {
    if (text === (this.remarked ?? "")) return;
    this.remarked = text;
    this.tell(this.said);
  }

  // The fragment of a link, with the name of a lens that is not among the presets.
  linkText() {
    const { name, state, left_out } = this.exact ?? (this.lens?.left_out ? { ...this.lens, name: english(this.page.name) } : {});
    const own = name && (left_out || state !== this.given) && !PRESETS.some((preset) => preset.name === name);
    const words = own ? { name, without: left_out } : {};
    return [toText(this.state, this.start), ...Object.keys(words).map((key) => words[key] && `${key}=${encodeURIComponent(words[key])}`)].filter(Boolean).join("&");
  }

  nameFromLink() {
    const [name, left_out] = ["name", "without"].map((key) => wordsIn(location.hash, key));
    if (name) this.lenses.unshift({ name, source: "", left_out, state: this.state });
    this.named = undefined;
  }

  writeLink() {
    const text = this.linkText();
    if (location.hash.slice(1) !== text) goTo(text ? `#${text}` : location.pathname + location.search, { begun: false, further: begun(history.state) });
  }
}
