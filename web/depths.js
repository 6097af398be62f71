// Live depth in a Worker: the tables of a camera, a clip rendered on points finer than the pixels, and single frames.

import { CAMERA } from "./camera.js";
import { generator, normal } from "./noise.js";

const { width: ACROSS, height: DOWN, foci: FOCI } = CAMERA;
const FINE = 4; // a pixel, along either axis
const BESIDE = 12; // pixels around things, for their blur
const BLOCK_SIDE = 4;

// What is before a wall: how bright, wide and high it is, in pixels to either side, whether round, and where and how far away in frame n.
const swing = (n, period) => Math.sin((2 * Math.PI * n) / period);
const LEVELS = Array.from({ length: 9 }, (_, k) => 1 / (1 / 1.25 + (k / 8) * (1 / 1.85 - 1 / 1.25)));
const FAR = 1.92;
const THINGS = [
  { name: "panel", bright: 0.75, half: [38, 70], distances: [1.62], at: () => [66, 136] },
  { name: "disk", bright: 1.3, half: [30, 30], round: true, distances: [1.33], at: (n) => [170 + Math.round(100 * swing(n, 300)), 62] },
  { name: "card", bright: 1.25, half: [30, 26], distances: LEVELS, at: (n) => [212 + Math.round(50 * swing(n, 420)), 172], level: (n) => Math.round(4 - 4 * Math.cos((2 * Math.PI * n) / 360)) },
];

// The things in frame n, nearest first, after which there is the wall.
export function scene(n) {
  const things = THINGS.map(({ name, half, round, distances, at, level }, index) => {
    const depth = level ? level(n) : 0;
    return { name, index, half, round, depth, middle: at(n), distance: distances[depth] };
  });
  return [...things.sort((a, b) => a.distance - b.distance), { name: "wall", distance: FAR }];
}

// The first of them at a place, in pixels.
export const seenAt = (things, x, y) => things.find(({ middle, half, round }) => !middle || covers(x - middle[0], y - middle[1], half, round));

const covers = (x, y, [across, down], round) => (round ? Math.hypot(x / across, y / down) < 1 : Math.abs(x) < across && Math.abs(y) < down);

// The file of LiveDepth.save() that web/depths.py packed.
export function tablesOf(bytes) {
  const { buffer } = bytes.slice();
  const head = new Float32Array(buffer, 0, 31);
  const [, , , , , frames, degree, , rank, count, around, imageDegree, , images] = head;
  const floats = new Float32Array(buffer, 0, 40 + around + rank);
  const steps = floats.subarray(30 + around, 40 + around);
  const sizes = floats.subarray(40 + around);
  const left = wholes(bytes.subarray(4 * floats.length));
  const taken = (length) => left.splice(0, length);
  const basis = taken(rank * frames * (degree + 1));
  const kept = taken(images * frames * (imageDegree + 1));
  const curves = (rows, step) => Array.from({ length: rows }, () => summed(taken(count)).map((value) => value * step));
  const mixes = curves(rank, steps[0]);
  const sharp = curves(images, steps[1]);
  const statistics = [...steps.slice(2)].flatMap((step) => curves(1, step)[0]);
  const file = [...floats.subarray(14, 30), ...basis.map((value, i) => (value / 32767) * sizes[Math.floor((i * rank) / basis.length)]), ...floats.subarray(30, 30 + around)];
  for (let c = 0; c < count; c++)
    for (let k = 0; k < rank; k++) for (let l = k; l < rank; l++) file.push(mixes[k][c] * mixes[l][c] * (k === l ? 1 : 2));
  file.push(...statistics, ...kept.map((value) => value / 32767));
  for (let c = 0; c < count; c++) file.push(...sharp.map((row) => row[c]));
  const made = new ArrayBuffer(4 * (14 + file.length));
  new Int32Array(made).set([0x464d4c4c, ...head.subarray(1, 14)]);
  new Float32Array(made, 56).set(file);
  return new Uint8Array(made);
}

// Whole numbers of 16 bits: low bytes, then high ones.
const wholes = (bytes) => Array.from({ length: bytes.length / 2 }, (_, i) => ((bytes[i] | (bytes[bytes.length / 2 + i] << 8)) << 16) >> 16);

// What has these second differences, modulo 2^16.
function summed(differences) {
  let [value, slope] = [0, 0];
  return differences.map((by) => (value = ((value + (slope += by)) << 16) >> 16));
}

// Opaque rectangles of all sizes, of mean 1.
function leaves(width, height) {
  const plane = new Float32Array(width * height).fill(1);
  const uniform = generator("leaves");
  for (let k = 0; k < 16_000; k++) {
    const size = Math.min((2 * FINE) / Math.sqrt(uniform()), 40 * FINE);
    const [across, down] = [size * (0.4 + 1.2 * uniform()), size * (0.4 + 1.2 * uniform())];
    const [left, top] = [uniform() * (width + across) - across, uniform() * (height + down) - down];
    const value = 0.4 + 1.2 * uniform();
    for (let y = Math.max(0, Math.ceil(top)); y < Math.min(height, top + down); y++)
      plane.fill(value, y * width + Math.max(0, Math.ceil(left)), y * width + Math.max(0, Math.min(width, Math.ceil(left + across))));
  }
  return plane;
}

export class Depths {
  constructor(core) {
    this.core = core;
  }

  // A file of tables for pairs of this size; its camera is made anew where the core was.
  camera(file, height = DOWN, width = ACROSS) {
    const { core } = this;
    this.made = null;
    core.call("set_camera", core.put("tables", file), file.length, height, width);
    this.made = { exports: core.exports, file, height, width };
  }

  // The packed tables of an f-number, and the clip as the lens images it.
  open(bytes, fNumber) {
    this.camera(tablesOf(bytes));
    this.clip = this.render(fNumber);
  }

  // Distance, standard error and misfit of blocks, one after the other, and the sharp image of a pair of 16 bits.
  found(first, second) {
    const { core, made } = this;
    if (made.exports !== core.exports) this.camera(made.file, made.height, made.width);
    const { height, width } = made;
    const count = 3 * Math.floor(height / BLOCK_SIDE) * Math.floor(width / BLOCK_SIDE);
    const [out, image] = [core.room("found", Float32Array, count), core.room("sharp", Float32Array, height * width)];
    core.call("depth", core.put("first", first), core.put("second", second), width, out, image);
    return { found: core.view(out, Float32Array, count).slice(), sharp: core.view(image, Float32Array, height * width).slice() };
  }

  // Frame n with noise, of so many electrons in the mean, and what is found of it; swapped: the frames in the other order.
  pair(n, light, swapped) {
    const begin = performance.now();
    const uniform = generator(`frame ${n}`);
    const frames = FOCI.map((_, focus) => this.recorded(this.composed(n, focus), light, uniform));
    if (swapped) frames.reverse();
    const middle = performance.now();
    const made = this.found(...frames);
    return { ...made, frames, things: scene(n), ms: performance.now() - middle, rendering: middle - begin };
  }

  // Layer by layer, the farthest first.
  composed(n, focus) {
    const { wall, things } = this.clip[focus];
    const frame = wall.slice();
    for (const { index, depth, middle, half } of scene(n).slice(0, -1).reverse()) {
      const { light, cover } = things[index][depth];
      const [left, top] = middle.map((at, k) => at - half[k] - BESIDE);
      const [across, down] = half.map((size) => 2 * (size + BESIDE));
      for (let y = Math.max(0, -top); y < Math.min(down, DOWN - top); y++)
        for (let x = Math.max(0, -left); x < Math.min(across, ACROSS - left); x++) {
          const [from, to] = [y * across + x, (top + y) * ACROSS + left + x];
          frame[to] = frame[to] * (1 - cover[from]) + light[from];
        }
    }
    return frame;
  }

  // Photons are so many that their noise is normal.
  recorded(frame, light, uniform) {
    const dice = (this.dice ??= normals());
    const out = new Uint16Array(frame.length);
    for (let y = 0, i = 0; y < DOWN; y++) {
      let at = Math.floor(uniform() * dice.length);
      for (let x = 0; x < ACROSS; x++, i++) {
        const electrons = light * frame[i];
        out[i] = Math.max(0, electrons + Math.sqrt(electrons + CAMERA.read ** 2) * dice[at++ & 65535] + CAMERA.offset + 0.5);
      }
    }
    return out;
  }

  // All layers in both frames: {wall, things: [thing][distance] of {light, cover}}.
  render(fNumber) {
    const texture = (this.texture ??= leaves(ACROSS * FINE, DOWN * FINE));
    return FOCI.map((focus) => {
      const lens = { focus, fNumber };
      const wall = this.blurred(texture, ACROSS, DOWN, this.spread(lens, FAR));
      const things = THINGS.map(({ bright, half, round, distances }, index) => {
        const [across, down] = half.map((size) => 2 * (size + BESIDE));
        const cover = new Float32Array(across * down * FINE * FINE);
        const light = cover.slice();
        for (let y = 0, i = 0; y < down * FINE; y++)
          for (let x = 0; x < across * FINE; x++, i++) {
            if (!covers((x + 0.5) / FINE - across / 2, (y + 0.5) / FINE - down / 2, half, round)) continue;
            cover[i] = 1;
            light[i] = bright * texture[(y + 60 * index) * ACROSS * FINE + x + 300 * (index + 1)];
          }
        return distances.map((distance) => {
          const spread = this.spread(lens, distance);
          return { light: this.blurred(light, across, down, spread), cover: this.blurred(cover, across, down, spread) };
        });
      });
      return { wall, things };
    });
  }

  // The PSF on points, of a thin lens, and how many a side.
  spread({ focus, fNumber }, distance) {
    const { core } = this;
    const { focal_length, wavelength, pixel } = CAMERA;
    const radius = (0.5 * focal_length) / fNumber;
    const defocus = ((Math.PI * radius ** 2) / (2 * wavelength)) * (1 / distance - 1 / focus);
    const step = (Math.PI * pixel * (1 - focal_length / focus)) / (FINE * wavelength * fNumber);
    const side = 2 * Math.ceil((4 * Math.abs(defocus) + 60) / step) + 1; // geometrical blur, and rings until 1 % of the light is left
    core.call("set_light", core.put("terms", Int32Array.of(2, 0)), core.put("edge", Float64Array.of(defocus)), 1, 0, core.put("lines", Float64Array.of(1, 1)), 1);
    core.call("set_vanes", 0, 0, 0);
    const out = core.room("values", Float32Array, side * side);
    core.call("psf", side, step, 1, 1e-5, out, core.room("numbers", Float64Array, 4), 0, 0, 0);
    return { out, side };
  }

  // A plane of points behind a PSF, in pixels.
  blurred(plane, width, height, { out, side }) {
    const { core } = this;
    const image = core.room("blurred", Float32Array, plane.length);
    core.call("blur", out, side, core.put("planes", plane), 1, height * FINE, width * FINE, image);
    const points = core.view(image, Float32Array, plane.length);
    const made = new Float32Array(width * height);
    for (let i = 0; i < plane.length; i++) made[Math.floor(i / (width * FINE * FINE)) * width + Math.floor((i % (width * FINE)) / FINE)] += points[i] / FINE ** 2;
    return made;
  }

  // A single frame, in electrons, whose blur has this radius in pixels, by Wiener's filter for it; bytes: the packed filters.
  sharpen(bytes, frame, height, width, blur) {
    const { core } = this;
    const print = `${height} ${width} ${blur}`;
    if (this.filter?.print !== print || this.filter.exports !== core.exports) {
      const head = new Float32Array(bytes.slice(0, 16).buffer);
      const left = wholes(bytes.subarray(16));
      const at = Math.min((blur / CAMERA.largest) * (CAMERA.blurs - 1), CAMERA.blurs - 1.001);
      const k = Math.floor(at);
      const factors = [];
      while (left.length) {
        const curve = summed(left.splice(0, CAMERA.blurs));
        factors.push(head[3] * (curve[k] + (at - k) * (curve[k + 1] - curve[k])));
      }
      core.call("set_filter", core.put("found", Float32Array.from(factors)), factors.length - 1, core.put("tables", head), height, width);
      this.filter = { print, exports: core.exports };
    }
    const image = core.room("sharp", Float32Array, frame.length);
    core.call("filter", core.put("first", frame), height, width, image);
    return core.view(image, Float32Array, frame.length).slice();
  }
}

function normals() {
  const uniform = generator("noise");
  return Float32Array.from({ length: 65536 }, () => normal(uniform));
}
