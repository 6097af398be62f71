// Live depth in a Worker: the tables of a camera, a clip rendered on points finer than the pixels, and single frames.

import { CAMERA } from "./camera.js";
import { generator, normal } from "./noise.js";

const { width: ACROSS, height: DOWN, foci: FOCI } = CAMERA;
const FINE = 4; // a pixel, along either axis
const BESIDE = 12; // pixels around things, for their blur
const BLOCK_SIDE = 4;

// What is before a wall: what is printed on it, how wide and high it is, in pixels to either side, whether round, and where and how far away in frame n.
const swing = (n, period) => Math.sin((2 * Math.PI * n) / period);
const LEVELS = Array.from({ length: 9 }, (_, k) => 1 / (1 / 1.25 + (k / 8) * (1 / 1.85 - 1 / 1.25)));
const FAR = 1.92;
const THINGS = [
  { name: "book", surface: book, half: [38, 66], distances: [1.62], at: () => [64, 140] },
  { name: "ball", surface: football, half: [32, 32], round: true, distances: [1.33], at: (n) => [178 + Math.round(96 * swing(n, 300)), 92] },
  { name: "card", surface: card, half: [25, 34], distances: LEVELS, at: (n) => [212 + Math.round(50 * swing(n, 420)), 176], level: (n) => Math.round(4 - 4 * Math.cos((2 * Math.PI * n) / 360)) },
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

// How bright things are at a place from their middle, in pixels: 1 is grey.
function wallpaper(x, y) {
  const [dx, dy] = [Math.abs(x - 14), y + 68];
  if (dx < 48 && Math.abs(dy) < 32) return dx > 44 || Math.abs(dy) > 28 ? 0.3 : landscape(x - 14, dy);
  const stripe = Math.abs(Math.floor(x / 20)) % 2;
  const from = Math.abs((((x / 20) % 1) + 1) % 1 - 0.5) + Math.abs((((y / 16 + 0.5 * stripe) % 1) + 1) % 1 - 0.5);
  return from > 0.14 && from < 0.3 ? 1.25 : 0.88 + 0.16 * stripe;
}

function landscape(x, y) {
  if (Math.hypot(x - 22, y + 14) < 6) return 1.7;
  if (y > 14 - 0.08 * x) return (x % 6) + 6 > 9 && y < 22 ? 0.25 : 0.6;
  const under = Math.max(24 - 0.9 * Math.abs(x + 16), 14 - 0.7 * Math.abs(x - 18)) + y - 8;
  return under < 0 ? 1.25 : under < 7 ? 1.65 : 0.55;
}

const TITLE = ["01110", "10001", "10001", "10001", "01110", "11110", "10001", "11110", "10000", "10000", "11111", "00100", "00100", "00100", "00100", "01110", "00100", "00100", "00100", "01110", "01111", "10000", "10000", "10000", "01111", "01111", "10000", "01110", "00001", "11110"];

// OPTICS, in letters of 5 x 5, and lines of words.
function book(x, y) {
  const [column, row] = [Math.floor((x + 30) / 1.7), Math.floor((y + 52) / 3)];
  if (Math.abs(x) < 33 && y > -58 && y < -30) {
    const letter = Math.floor(column / 6);
    const ink = row >= 0 && row < 5 && column >= 0 && letter < 6 && TITLE[5 * letter + row][column % 6] === "1";
    return ink ? 0.25 : 1.6;
  }
  const [line, at] = [Math.floor((y + 24) / 6), Math.floor((x + 30) / 2)];
  const inked = Math.abs(x) < 30 && line >= 0 && line < 13 && (y + 24) % 6 < 3.4 && Math.sin(12.9 * at + 78.2 * line) > -0.5 && (at + 3 * line) % 7 > 0;
  return inked ? 1.2 : 0.6;
}

const GOLDEN = (1 + Math.sqrt(5)) / 2;
const PATCHES = [0, 1, 2].flatMap((turn) => [-1, 1].flatMap((a) => [-1, 1].map((b) => [0, 1, 2].map((k) => [0, a, b * GOLDEN][(k + turn) % 3] / Math.hypot(1, GOLDEN)))));

// Black around the corners of an icosahedron, which is turned, with light from the left and above.
function football(x, y) {
  const [p, q] = [x / 32, y / 32];
  const r = Math.sqrt(Math.max(0, 1 - p * p - q * q));
  const [u, v] = [0.9 * p - 0.44 * q, 0.44 * p + 0.9 * q];
  const along = PATCHES.map(([a, b, c]) => a * u + b * v + c * r).sort((one, other) => other - one);
  const seam = along[0] - along[1] > 0.02 && along[1] - along[2] > 0.02 ? 1.6 : 0.7;
  return (along[0] > 0.92 ? 0.2 : seam) * (0.55 + 0.5 * Math.max(0, r - 0.4 * p - 0.5 * q));
}

// A five of diamonds.
function card(x, y) {
  const pips = [[-12, -20], [12, -20], [0, 0], [-12, 20], [12, 20]];
  if (Math.abs(x) > 23 || Math.abs(y) > 32) return 0.9;
  return pips.some(([a, b]) => Math.abs(x - a) / 6 + Math.abs(y - b) / 9 < 1) ? 0.35 : 1.6;
}

// Grain of paper, cloth and leather on points: opaque rectangles of all sizes, of mean 1.
function grains(side) {
  const plane = new Float32Array(side * side).fill(1);
  const uniform = generator("grain");
  for (let k = 0; k < 6000; k++) {
    const size = Math.min((2 * FINE) / Math.sqrt(uniform()), 40 * FINE);
    const [across, down] = [size * (0.4 + 1.2 * uniform()), size * (0.4 + 1.2 * uniform())];
    const [left, top] = [uniform() * (side + across) - across, uniform() * (side + down) - down];
    const value = 0.65 + 0.7 * uniform();
    for (let y = Math.max(0, Math.ceil(top)); y < Math.min(side, top + down); y++)
      plane.fill(value, y * side + Math.max(0, Math.ceil(left)), y * side + Math.max(0, Math.min(side, Math.ceil(left + across))));
  }
  return plane;
}

const GRAIN = 600; // points

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

  // The light of a surface on points: what is printed there, with grain from a place of its own.
  paint(surface, width, height, shift, seen) {
    const grain = (this.grain ??= grains(GRAIN));
    const plane = new Float32Array(width * height * FINE * FINE);
    for (let row = 0, i = 0; row < height * FINE; row++)
      for (let column = 0; column < width * FINE; column++, i++) {
        const [x, y] = [(column + 0.5) / FINE - width / 2, (row + 0.5) / FINE - height / 2];
        if (seen(x, y)) plane[i] = surface(x, y) * grain[((row + shift) % GRAIN) * GRAIN + ((column + 5 * shift) % GRAIN)];
      }
    return plane;
  }

  // A thing before blur, with room for it.
  layers({ surface, half, round }, index) {
    const [across, down] = half.map((size) => 2 * (size + BESIDE));
    const light = this.paint(surface, across, down, 60 * (index + 1), (x, y) => covers(x, y, half, round));
    return { light, cover: light.map((value) => (value ? 1 : 0)), across, down };
  }

  // All layers in both frames: {wall, things: [thing][distance] of {light, cover}}.
  render(fNumber) {
    const [paper, ...painted] = (this.sharp ??= [this.paint(wallpaper, ACROSS, DOWN, 0, () => true), ...THINGS.map((thing, index) => this.layers(thing, index))]);
    return FOCI.map((focus) => {
      const lens = { focus, fNumber };
      const wall = this.blurred(paper, ACROSS, DOWN, this.spread(lens, FAR));
      const things = THINGS.map(({ distances }, index) => {
        const { light, cover, across, down } = painted[index];
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
