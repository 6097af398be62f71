// The lesson on depth: pairs of a clip with the depth that is found in them, or a camera's frames one by one, sharpened.

import { CAMERA } from "./camera.js";
import { seenAt } from "./depths.js";
import { el, menu, unique } from "./dom.js";
import { colour, drawPicture } from "./draw.js";
import { tell } from "./language.js";
import { unpacked } from "./load.js";
import { depthText } from "./packed.js";
import { linear, scratch } from "./pictures.js";
import { Readout } from "./stage.js";

const DIMMEST = 200; // electrons: the tables are made for 3000
const BRIGHTEST = 10_000;
const DECADES_OF_LIGHT = Math.log10(BRIGHTEST / DIMMEST);
const START = { stop: CAMERA.stops.indexOf(8), light: 3000, blur: 2 };
const GROUND = [128, 128, 128]; // of what is not known
const [NEAR, FAR_END] = CAMERA.between;
const FULL = 6000; // electrons of white, of a camera
const [WIDE, HIGH] = [640, 480]; // its frames
const SOURCES = { pairs: "Two pictures (computed clip)", camera: "Camera, one picture" };
const REFUSED = {
  NotAllowedError: "The browser was not allowed to use a camera. Allow it for this page, beside the address, and choose it again.",
  NotFoundError: "There is no camera here.",
  NotReadableError: "The camera is in use by another program.",
};

const inMetres = (distance, digits = 2) => `${distance.toFixed(digits)} m`;
const inMillimetres = (length) => `${length < 0.01 ? (1e3 * length).toFixed(1) : Math.round(1e3 * length)} mm`;

export class Depth {
  // told: called when something was changed that a step of the lesson may wait for.
  constructor({ client, level, told }) {
    Object.assign(this, { client, told, ...START, swapped: false, source: "pairs", n: 0, seen: new Set(), playing: !matchMedia("(prefers-reduced-motion: reduce)").matches });
    const [blocks, lines] = [CAMERA.width / 4, CAMERA.height / 4];
    this.canvases = {};
    const picture = (name, text, width = CAMERA.width, height = CAMERA.height) => {
      const canvas = (this.canvases[name] = el("canvas", { role: "img", "aria-label": text, width, height }));
      const title = el(`h${level + 1}`, { class: "title" }, text);
      return el("figure", { "data-picture": name }, el("figcaption", {}, title), el("div", { class: "frame" }, canvas));
    };
    this.pictures = el(
      "div",
      { class: "pictures" },
      picture("first", "First picture"),
      picture("second", "Second picture"),
      picture("depth", "Depth", blocks, lines),
      picture("sharp", "Sharp picture of both"),
    );
    this.choice = menu("Pictures", SOURCES, this.source, (source) => this.use(source), { "data-depth": "source" });
    this.pause = el("button", { type: "button", onclick: () => this.play(!this.playing) });
    this.rows = {
      stop: this.slider("stop", "f-number (defocus)", CAMERA.stops.length - 1, 1, (value) => this.set({ stop: value })),
      light: this.slider("light", "Light (noise)", 1, 0.02, (value) => this.set({ light: Number((DIMMEST * 10 ** (value * DECADES_OF_LIGHT)).toPrecision(2)) })),
      blur: this.slider("blur", "Radius of the blur", CAMERA.largest, 0.1, (value) => this.set({ blur: value })),
    };
    this.swap = el("input", { type: "checkbox", onchange: () => this.set({ swapped: this.swap.checked }) });
    this.order = el("label", { class: "tick" }, this.swap, "Exchange the two pictures");
    this.scale = el("div", { class: "scale" }, this.bar(), el("span", { class: "of" }, "grey: not known"));
    this.numbers = el("p", { class: "note", "data-depth": "numbers" });
    this.message = el("p", { class: "note", role: "status" });
    this.node = el(
      "section",
      { class: "depth", "aria-label": "Depth from two pictures" },
      el("div", { class: "group" }, this.choice, this.pause, this.order),
      el("div", { class: "sliders" }, ...Object.values(this.rows).map(({ node }) => node)),
      this.message,
      this.pictures,
    );
    this.pictures.append(this.scale, this.numbers);
    this.readout = new Readout(this.canvases.depth, () => [blocks, lines], (column, row) => this.value(column, row));
    this.show();
    this.loop();
  }

  // A slider with its name and value.
  slider(key, name, max, step, take) {
    const id = unique(key);
    const input = el("input", { type: "range", id, min: 0, max, step, "data-depth": key, oninput: () => take(input.valueAsNumber) });
    const output = el("output", { for: id });
    return { input, output, node: el("div", { class: "row" }, el("div", { class: "line" }, el("label", { for: id }, name), output), input) };
  }

  // The colours of distances.
  bar() {
    const canvas = el("canvas", { role: "img", width: 256, height: 1, "aria-label": `Colours of distances from ${inMetres(NEAR, 1)} to ${inMetres(FAR_END, 1)}; grey: not known` });
    const image = canvas.getContext("2d").createImageData(256, 1);
    for (let i = 0; i < 256; i++) image.data.set([...colour("viridis", 1 - i / 255), 255], 4 * i);
    canvas.getContext("2d").putImageData(image, 0, 0);
    const marks = [1.2, 1.4, 1.6, 1.8, 2].map((at) => {
      const share = (at - NEAR) / (FAR_END - NEAR);
      return el("span", { style: `left:${100 * share}%;transform:translateX(${-100 * share}%)` }, inMetres(at, 1));
    });
    return el("div", {}, canvas, el("div", { class: "ticks", "aria-hidden": "true" }, ...marks));
  }

  set(change) {
    Object.assign(this, change);
    this.show();
    this.touch();
  }

  play(playing) {
    this.playing = playing;
    this.video?.[playing ? "play" : "pause"]();
    this.show();
    if (playing) this.loop();
  }

  // What is asked for shows at once, before it is computed.
  show() {
    const paired = this.source === "pairs";
    const f = `f/${CAMERA.stops[this.stop]}`;
    const say = ({ input, output, node }, value, text, shown) => {
      input.value = value;
      input.setAttribute("aria-valuetext", text);
      input.style.setProperty("--from", 0);
      input.style.setProperty("--to", value / input.max);
      output.textContent = text;
      node.hidden = !shown;
    };
    say(this.rows.stop, this.stop, f, paired);
    say(this.rows.light, Math.log10(this.light / DIMMEST) / DECADES_OF_LIGHT, `${this.light} electrons`, paired);
    say(this.rows.blur, this.blur, `${this.blur.toFixed(1)} pixels`, !paired);
    this.order.hidden = this.scale.hidden = !paired;
    this.pictures.hidden = !paired && !this.shown; // none of a camera yet
    this.pause.textContent = this.playing ? "Pause" : "Play";
    const title = (name, text) => (this.canvases[name].closest("figure").querySelector(".title").textContent = text);
    for (const name of ["second", "depth"]) this.canvases[name].closest("figure").hidden = !paired;
    const [near, far] = CAMERA.foci.map((focus) => `${this.swapped ? "stated focus" : "focused at"} ${inMetres(focus).replace(" ", "\u00a0")}`);
    title("first", paired ? `First, ${near}` : "As taken");
    title("second", `Second, ${far}`);
    title("sharp", paired ? "Sharp picture of both" : "Sharpened");
  }

  // Pictures anew, for what was changed.
  touch() {
    this.changed = true;
    this.loop();
    this.told();
  }

  async use(source) {
    Object.assign(this, { source, shown: null });
    this.release();
    this.tell("");
    this.show();
    this.numbers.textContent = "";
    if (source === "camera") await this.open();
    this.touch();
  }

  // The camera of this machine; a sentence where there is none.
  async open() {
    this.tell("No picture leaves this page: frames are filtered here and forgotten. The browser asks for the camera.");
    try {
      if (!navigator.mediaDevices) throw new Error("The browser gives the camera only to pages from https or from this machine.");
      const stream = await navigator.mediaDevices.getUserMedia({ video: { width: { ideal: WIDE }, height: { ideal: HIGH } } });
      if (this.gone || this.source !== "camera") return stream.getTracks().forEach((track) => track.stop());
      this.video = el("video", { muted: true, playsinline: true });
      Object.assign(this.video, { muted: true, srcObject: stream });
      await this.video.play();
      this.tell("No picture leaves this page: frames are filtered here and forgotten.");
    } catch (error) {
      this.release();
      this.tell(REFUSED[error.name] ?? `There is no picture of a camera: ${error.message}`);
    }
  }

  release() {
    this.video?.srcObject?.getTracks().forEach((track) => track.stop());
    this.video = null;
  }

  tell(text) {
    tell(this.message, text);
  }

  // One picture after the other while they play; otherwise that which was asked for.
  async loop() {
    this.again = true;
    if (this.looping) return;
    this.looping = true;
    while (this.again && !this.gone) {
      this.again = false;
      try {
        await this.run();
      } catch (error) {
        if (!this.gone) this.tell(`This cannot be computed: ${error.message}`);
        this.opened = undefined;
      }
    }
    this.looping = false;
  }

  // Pictures are computed while those before are drawn.
  async run() {
    let ahead = this.ask();
    while (ahead) {
      const got = await ahead;
      const more = !this.gone && (this.playing || this.changed);
      ahead = more ? this.ask() : null;
      if (!this.gone && got?.source === this.source) this.draw(got);
      await new Promise((next) => setTimeout(next));
      await new Promise(requestAnimationFrame);
    }
  }

  ask() {
    this.changed = false;
    if (this.source === "pairs") return this.askPair();
    return this.video ? this.askFrame() : null;
  }

  async askPair() {
    const { client, stop } = this;
    if (this.opened !== stop) {
      this.tell(`Rendering the scene at f/${CAMERA.stops[stop]} …`);
      await client.call("openDepth", await tablesAt(stop), CAMERA.stops[stop]);
      this.opened = stop;
      if (this.source === "pairs") this.tell("");
    }
    if (this.playing) this.n++;
    const got = await client.call("depth", this.n, this.light, this.swapped);
    return { ...got, source: "pairs", stop };
  }

  async askFrame() {
    const { video } = this;
    const context = (this.scratch ??= scratch(WIDE, HIGH));
    // The middle of what the camera sees.
    const scale = Math.max(WIDE / video.videoWidth, HIGH / video.videoHeight);
    const [across, down] = [video.videoWidth * scale, video.videoHeight * scale];
    context.drawImage(video, (WIDE - across) / 2, (HIGH - down) / 2, across, down);
    const size = WIDE * HIGH;
    const planes = linear(context.getImageData(0, 0, WIDE, HIGH).data, 3);
    const frame = new Float32Array(size);
    for (let i = 0; i < size; i++) frame[i] = FULL * (0.2126 * planes[i] + 0.7152 * planes[size + i] + 0.0722 * planes[2 * size + i]);
    const begin = performance.now();
    const sharp = await this.client.call("sharpen", await tablesAt(CAMERA.stops.length), frame, HIGH, WIDE, this.blur);
    return { source: "camera", planes, frame, sharp, ms: performance.now() - begin };
  }

  draw(got) {
    this.shown = got;
    this.pictures.hidden = false;
    const now = performance.now();
    if (this.playing && this.drawn) this.rate = 0.9 * (this.rate || now - this.drawn) + 0.1 * (now - this.drawn);
    this.drawn = this.playing ? now : 0;
    if (got.source === "camera") this.drawCamera(got);
    else this.drawPair(got);
    if (now - (this.counted ?? -Infinity) < 400 && this.playing) return;
    this.counted = now;
    const rate = this.playing && this.rate ? `${Math.round(1e3 / this.rate)} frames/s; ` : "";
    this.numbers.textContent = rate + this.summary(got);
    this.told();
  }

  summary(got) {
    if (got.source === "camera") return `sharpened in ${got.ms.toFixed(1)} ms, brightness only`;
    const { found } = got;
    const count = found.length / 3;
    const misfits = found.slice(2 * count).filter((_, i) => found[i] === found[i]).sort();
    const known = Math.round((100 * misfits.length) / count);
    const fit = misfits.length ? `, misfit ${misfits[misfits.length >> 1].toFixed(2)}` : "";
    const said = `depth known at ${known} %${fit}`;
    this.canvases.depth.setAttribute("aria-label", `Depth: ${said}`);
    return `${said}; depth and sharp picture take ${got.ms.toFixed(1)} ms`;
  }

  drawPair({ frames, found, sharp }) {
    const { width, height, offset } = CAMERA;
    const bright = 1 / (2 * this.light);
    frames.forEach((frame, k) => {
      const planes = Float32Array.from(frame, (value) => bright * (value - offset));
      drawPicture(this.canvases[k ? "second" : "first"], { planes, width, height, count: 1 });
    });
    drawPicture(this.canvases.sharp, { planes: sharp.map((value) => bright * value), width, height, count: 1 });
    const context = this.canvases.depth.getContext("2d");
    const image = (this.image ??= context.createImageData(width / 4, height / 4));
    for (let i = 0; i < found.length / 3; i++) {
      const share = (FAR_END - found[i]) / (FAR_END - NEAR);
      const [r, g, b] = share === share ? (shades[Math.round(255 * Math.min(1, Math.max(0, share)))] ??= colour("viridis", Math.min(1, Math.max(0, share)))) : GROUND;
      image.data.set([r, g, b, 255], 4 * i);
    }
    context.putImageData(image, 0, 0);
    if (this.playing) this.readout.text.setAttribute("aria-live", "off");
    this.readout.update();
  }

  drawCamera({ planes, frame, sharp }) {
    const picture = { planes, width: WIDE, height: HIGH, count: 3 };
    drawPicture(this.canvases.first, picture);
    // Of all colours as much more or less.
    for (let i = 0; i < sharp.length; i++) {
      const more = (sharp[i] - frame[i]) / FULL;
      for (let k = i; k < planes.length; k += sharp.length) planes[k] += more;
    }
    drawPicture(this.canvases.sharp, picture);
  }

  // Truth and what is found at a block.
  value(column, row) {
    if (!this.shown?.found) return "";
    const { found, things } = this.shown;
    const count = found.length / 3;
    const i = row * (CAMERA.width / 4) + column;
    const [distance, error] = [found[i], found[count + i]];
    this.pointed = true;
    const said = error < Infinity ? `found ${inMetres(distance, 3)} ± ${inMillimetres(error)}` : "not known";
    return `true ${inMetres(seenAt(things, 4 * column + 2, 4 * row + 2).distance, 3)}, ${said}`;
  }

  // What steps of the lesson ask for.
  get read() {
    this.seen.add(CAMERA.stops[this.opened]);
    const { pointed, light, swapped, seen, source } = this;
    return { pointed, light, swapped, seen, source };
  }

  destroy() {
    this.gone = true;
    this.release();
    this.node.remove();
  }
}

const shades = [];

// The tables of a stop, or after the last those of single frames.
let packedTables;
async function tablesAt(index) {
  const bytes = await (packedTables ??= unpacked(depthText));
  const begin = CAMERA.sizes.slice(0, index).reduce((sum, size) => sum + size, 0);
  return bytes.slice(begin, begin + CAMERA.sizes[index]);
}
