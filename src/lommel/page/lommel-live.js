// Made by `make page` with ziglang==0.17.0; SHA-256 of the sources: 005c9b6f3ff50b61bcf6841963be1b85ae4c7736acaa8309abcb2328258ac270
/*! lommel, BSD-3-Clause. The compiled core holds parts of libc++ and libc++abi (Apache-2.0 WITH LLVM-exception), of
musl, wasi-libc and Zig (MIT), and of cloudlibc (BSD-2-Clause); the notices are in LICENSES of sources and wheels. */
const common = () => {
const BLOCKS = ["terms", "edge", "lines", "values", "numbers", "points", "planes", "blurred", "weights", "colours", "tables", "first", "second", "found", "sharp"];
class Core {
constructor(module) {
this.module = module;
this.renew();
}
renew() {
const fail = (at, length) => {
const text = new TextDecoder().decode(new Uint8Array(this.exports.memory.buffer, at, length).slice());
throw new RangeError(text);
};
const shorten = (number, at, room) => {
const rounded = Number(number.toPrecision(3));
const whole = rounded && Math.abs(rounded) < 1e-4 ? rounded.toExponential(2) : rounded.toPrecision(3);
const text = (whole.includes(".") ? whole.replace(/^([^e]*?)\.?0+(?=e|$)/, "$1") : whole).replace(/e([+-])(\d)$/, "e$10$2");
const { written } = new TextEncoder().encodeInto(text, new Uint8Array(this.exports.memory.buffer, at, room - 1));
new Uint8Array(this.exports.memory.buffer)[at + written] = 0;
return written;
};
const given = { fail, shorten };
const imports = {};
for (const { module, name } of WebAssembly.Module.imports(this.module)) {
imports[module] ??= {};
imports[module][name] = (module === "lommel" && given[name]) || (() => 52); // ENOSYS: there is no system
}
this.exports = new WebAssembly.Instance(this.module, imports).exports;
this.exports._initialize?.();
}
room(name, kind, length) {
return this.call("room", BLOCKS.indexOf(name), Math.max(1, length) * kind.BYTES_PER_ELEMENT) >>> 0; // above 2 GB, too
}
put(name, numbers) {
const at = this.room(name, numbers.constructor, numbers.length);
this.view(at, numbers.constructor, numbers.length).set(numbers);
return at;
}
view(at, kind, length) {
return new kind(this.exports.memory.buffer, at, length);
}
call(name, ...numbers) {
try {
return this.exports[name](...numbers);
} catch (error) {
this.renew();
if (error instanceof WebAssembly.RuntimeError) {
throw new RangeError(`the computation stopped for want of memory (${error.message})`);
}
throw error;
}
}
}
const FIELDS = {"focus": {"initial": "waves", "choices": ["waves", "distances"], "about": "Input of defocus: in waves, or by focal length, f-number, focus distance and object distance."}, "defocus": {"initial": 0.6, "low": -50, "high": 50, "row": {"group": "Wavefront", "label": "Defocus", "reach": [-5, 5], "step": 0.01, "unit": "", "said": "", "waves": true, "name": null, "when": [["focus", "waves"]]}, "about": "Seidel term W020 \u03c1\u00b2, waves at the edge of the pupil; positive: the sensor lies between lens and focus."}, "focus_distance": {"initial": 2, "low": 0.001, "high": 1000000000000.0, "row": {"group": "Wavefront", "label": "Focused at", "reach": [0.1, 1000], "step": null, "unit": "m", "said": "metres", "waves": false, "name": "Focus distance", "when": [["focus", "distances"]]}, "about": "Distance from the lens to objects in focus, metres, above the focal length; inf for infinity.", "infinite": true}, "object_distance": {"initial": 1.9, "low": 0.001, "high": 1000000000000.0, "row": {"group": "Wavefront", "label": "Object at", "reach": [0.1, 1000], "step": null, "unit": "m", "said": "metres", "waves": false, "name": "Object distance", "when": [["focus", "distances"]]}, "about": "Distance from the lens to the point object, metres, inf for infinity; nearer than the focus distance is positive defocus.", "infinite": true}, "spherical": {"initial": 0, "low": -25, "high": 25, "row": {"group": "Wavefront", "label": "Spherical", "reach": [-5, 5], "step": 0.01, "unit": "", "said": "", "waves": true, "name": null, "when": []}, "about": "Seidel term W040 \u03c1\u2074, waves at the edge of the pupil, unlike the Zernike term (4, 0) without defocus; positive: marginal rays focus beyond paraxial ones."}, "coma": {"initial": 0, "low": 0, "high": 10, "row": {"group": "Wavefront", "label": "Coma", "reach": [0, 3], "step": 0.01, "unit": "", "said": "", "waves": true, "name": null, "when": []}, "about": "Zernike term (3, 1), (3\u03c1\u00b3 \u2212 2\u03c1) cos \u03b8, waves at the edge of the pupil: a third of Seidel's W131, so that W131 = 0.75 is 0.25 here."}, "coma_angle": {"initial": 0, "low": -180, "high": 180, "row": {"group": "Wavefront", "label": "angle", "reach": [-180, 180], "step": 1, "unit": "\u00b0", "said": "degrees", "waves": false, "name": "Direction of coma", "when": []}, "about": "Direction in which the tail of the image points, degrees from the right, clockwise."}, "astigmatism": {"initial": 0, "low": 0, "high": 10, "row": {"group": "Wavefront", "label": "Astigmatism", "reach": [0, 3], "step": 0.01, "unit": "", "said": "", "waves": true, "name": null, "when": []}, "about": "Zernike term (2, 2), \u03c1\u00b2 cos 2\u03b8, waves at the edge of the pupil: half of Seidel's W222, whose other half is defocus."}, "astigmatism_angle": {"initial": 0, "low": -90, "high": 90, "row": {"group": "Wavefront", "label": "angle", "reach": [-90, 90], "step": 1, "unit": "\u00b0", "said": "degrees", "waves": false, "name": "Direction of astigmatism", "when": []}, "about": "Direction in which the image is wide where defocus is positive, degrees from the right, clockwise."}, "trefoil": {"initial": 0, "low": 0, "high": 10, "row": {"group": "Wavefront", "label": "Trefoil", "reach": [0, 3], "step": 0.01, "unit": "", "said": "", "waves": true, "name": null, "when": []}, "about": "Zernike term (3, 3), \u03c1\u00b3 cos 3\u03b8, waves at the edge of the pupil."}, "trefoil_angle": {"initial": 0, "low": -60, "high": 60, "row": {"group": "Wavefront", "label": "angle", "reach": [-60, 60], "step": 1, "unit": "\u00b0", "said": "degrees", "waves": false, "name": "Direction of trefoil", "when": []}, "about": "Direction in which the first ring of a little trefoil is brightest, degrees from the right, clockwise."}, "zernike": {"initial": "", "about": "Zernike terms without a slider, of an opened file or of the address (zernike=4,2:0.05;6,0:-0.01): n,m:waves rms.", "terms": 90, "degree": 12, "waves": 10}, "focal_length": {"initial": 50, "low": 0.1, "high": 1000000.0, "row": {"group": "Lens and light", "label": "Focal length", "reach": [1, 10000], "step": null, "unit": "mm", "said": "millimetres", "waves": false, "name": null, "when": [["length_unit", "arcsec"], ["focus", "distances"]]}, "about": "Focal length of the lens, millimetres; converts lengths on the sensor to angles."}, "f_number": {"initial": 4, "low": 0.7, "high": 300, "row": {"group": "Lens and light", "label": "f-number", "reach": [1, 32], "step": null, "unit": "", "said": "", "waves": false, "name": null, "when": []}, "about": "Sensor distance divided by aperture diameter; with distances, focal length divided by it."}, "obscuration": {"initial": 0, "low": 0, "high": 0.9, "row": {"group": "Lens and light", "label": "Obscuration", "reach": [0, 0.9], "step": 0.01, "unit": "of the radius", "said": "of the radius", "waves": false, "name": null, "when": []}, "about": "Radius of the central obscuration divided by the radius of the aperture."}, "vanes": {"initial": 0, "low": 0, "high": 8, "row": {"group": "Lens and light", "label": "Vanes", "reach": [0, 8], "step": 1, "unit": "", "said": "", "waves": false, "name": "Number of vanes", "when": []}, "about": "Number of straight vanes from the axis to the edge of the aperture, at equal angles; a logarithmic scale shows their spikes.", "whole": true}, "vane_width": {"initial": 0.03, "low": 0.001, "high": 0.5, "row": {"group": "Lens and light", "label": "width", "reach": [0.005, 0.2], "step": 0.005, "unit": "of the radius", "said": "of the radius", "waves": false, "name": "Vane width", "when": [["vanes", 1, 2, 3, 4, 5, 6, 7, 8]]}, "about": "Width of each vane divided by the radius of the aperture."}, "vane_angle": {"initial": 0, "low": -180, "high": 180, "row": {"group": "Lens and light", "label": "angle", "reach": [-180, 180], "step": 1, "unit": "\u00b0", "said": "degrees", "waves": false, "name": "Direction of the first vane", "when": [["vanes", 1, 2, 3, 4, 5, 6, 7, 8]]}, "about": "Direction of the first vane, degrees from the right, clockwise."}, "wavelength": {"initial": 550, "low": 100, "high": 30000, "row": {"group": "Lens and light", "label": "Wavelength", "reach": [380, 780], "step": 1, "unit": "nm", "said": "nanometres", "waves": false, "name": null, "when": []}, "about": "Wavelength of the light, nanometres; in white light, the one at which the wavefront is given in waves."}, "light": {"initial": "mono", "choices": ["mono", "white"], "about": "One wavelength, or seven lines of equal energy, 450 to 650 nm, with the same optical paths."}, "pixel": {"initial": 2, "low": 0.05, "high": 200, "row": {"group": "Sensor", "label": "Pixel of the sensor", "reach": [0.5, 20], "step": null, "unit": "\u00b5m", "said": "micrometres", "waves": false, "name": null, "when": []}, "about": "Pitch of the square pixels of the sensor, micrometres."}, "view": {"initial": "fine", "choices": ["fine", "sampled", "averaged"], "about": "A fine grid over the whole image, or the sensor's pixels: samples at their centres, or averages."}, "side": {"initial": 512, "low": 16, "high": 1024, "row": {"group": "Sensor", "label": "Window", "reach": [64, 1024], "step": 16, "unit": "pixels wide", "said": "pixels wide", "waves": false, "name": null, "when": []}, "about": "Height and width of the computed image, pixels.", "whole": true}, "noise": {"initial": "off", "choices": ["off", "on"], "about": "Photon noise and read noise of the sensor in the displayed images."}, "photons": {"initial": 10000, "low": 1, "high": 1000000000.0, "row": {"group": "Sensor", "label": "Photons", "reach": [10, 1000000.0], "step": null, "unit": "", "said": "electrons", "waves": false, "name": null, "when": [["noise", "on"]]}, "about": "Expected number of detected photons: of the whole PSF, and at a white pixel of the picture."}, "read_noise": {"initial": 2, "low": 0, "high": 1000, "row": {"group": "Sensor", "label": "Read noise", "reach": [0, 20], "step": 0.1, "unit": "e\u207b rms", "said": "electrons rms", "waves": false, "name": null, "when": [["noise", "on"]]}, "about": "Standard deviation of the read noise of each pixel, electrons."}, "rays": {"initial": "off", "choices": ["off", "on"], "about": "Points where rays through the pupil meet the sensor, without diffraction."}, "stretch": {"initial": "sqrt", "choices": ["sqrt", "linear", "log"], "about": "Brightness scale of the PSF: square root, linear or logarithmic."}, "map": {"initial": "auto", "choices": ["auto", "inferno", "viridis", "cividis", "gray"], "about": "Colours of the PSF; automatic: true colour in white light, inferno in light of one wavelength."}, "waves_unit": {"initial": "waves", "choices": ["waves", "rad", "nm"], "about": "Unit of the wavefront: waves, radians, or nanometres of path."}, "length_unit": {"initial": "um", "choices": ["um", "arcsec", "lambdaN"], "about": "Unit of lengths on the sensor: micrometres, arcseconds, wavelength times f-number."}, "picture": {"initial": "star", "choices": ["star", "bars", "text", "points", "own"], "about": "Picture that the sensor records through the lens."}};
const DIRECTED = [{"name": "coma", "n": 3, "m": 1}, {"name": "astigmatism", "n": 2, "m": 2}, {"name": "trefoil", "n": 3, "m": 3}];
const WHITE = [450.0, 483.3333333333333, 516.6666666666666, 550.0, 583.3333333333334, 616.6666666666667, 650.0];
const COLOURS = [[0.046949, -0.062906, 0.847108], [-0.092172, 0.081976, 0.306337], [-0.236066, 0.368993, -0.007236], [-0.03398, 0.461886, -0.075688], [0.490321, 0.2055, -0.052421], [0.622418, -0.033387, -0.015137], [0.20253, -0.022062, -0.002963]];
const CAMERA = {"focal_length": 0.035, "wavelength": 5.4e-07, "pixel": 4e-06, "foci": [1.35, 1.8], "between": [1.2, 2.0], "read": 3.0, "offset": 100.0, "stops": [16.0, 11.0, 8.0, 5.6], "height": 240, "width": 320, "blurs": 25, "largest": 6.0, "sizes": [1260, 1876, 2508, 3268, 666]};
const CRC = Uint32Array.from({ length: 256 }, (_, n) => {
for (let k = 0; k < 8; k++) n = n & 1 ? (n >>> 1) ^ 0xedb88320 : n >>> 1;
return n;
});
function crc32(bytes, before = 0) {
let sum = ~before;
for (const byte of bytes) sum = CRC[(sum ^ byte) & 255] ^ (sum >>> 8);
return ~sum >>> 0;
}
function generator(text) {
const state = Uint32Array.from({ length: 4 }, (_, i) => crc32(new TextEncoder().encode(`${i} ${text}`)) | 1);
return () => {
const [x, w] = [state[0], state[3]];
const t = x ^ (x << 11);
state.copyWithin(0, 1);
state[3] = w ^ (w >>> 19) ^ t ^ (t >>> 8);
return (state[3] + 0.5) / 2 ** 32;
};
}
function normal(uniform) {
return Math.sqrt(-2 * Math.log(uniform())) * Math.cos(2 * Math.PI * uniform());
}
function poisson(mean, uniform) {
if (mean < 30) {
const end = Math.exp(-mean);
let count = 0;
for (let product = uniform(); product > end; product *= uniform()) count++;
return count;
}
const slope = 0.931 + 2.53 * Math.sqrt(mean);
const a = -0.059 + 0.02483 * slope;
const [log, inverse] = [Math.log(mean), 1.1239 + 1.1328 / (slope - 3.4)];
for (;;) {
const u = uniform() - 0.5;
const v = uniform();
const us = 0.5 - Math.abs(u);
const k = Math.floor(((2 * a) / us + slope) * u + mean + 0.43);
if (us >= 0.07 && v <= 0.9277 - 3.6224 / (slope - 2)) return k;
if (k < 0 || (us < 0.013 && v > us)) continue;
if (Math.log((v * inverse) / (a / us ** 2 + slope)) <= k * log - mean - logFactorial(k)) return k;
}
}
function logFactorial(k) {
let below = 0;
let n = k + 1;
for (; n < 10; n++) below += Math.log(n);
return (n - 0.5) * Math.log(n) - n + 0.9189385332046727 + (1 / 12 - 1 / (360 * n * n)) / n - below;
}
function counted(expected, { read_noise }, seed) {
const uniform = generator(seed);
const read = read_noise ? () => read_noise * normal(uniform) : () => 0;
return Float32Array.from(expected, (mean) => poisson(mean, uniform) + read());
}
const { width: ACROSS, height: DOWN, foci: FOCI } = CAMERA;
const FINE = 4; // a pixel, along either axis
const BESIDE = 12; // pixels around things, for their blur
const BLOCK_SIDE = 4;
const swing = (n, period) => Math.sin((2 * Math.PI * n) / period);
const LEVELS = Array.from({ length: 9 }, (_, k) => 1 / (1 / 1.25 + (k / 8) * (1 / 1.85 - 1 / 1.25)));
const FAR = 1.92;
const THINGS = [
{ name: "panel", bright: 0.75, half: [38, 70], distances: [1.62], at: () => [66, 136] },
{ name: "disk", bright: 1.3, half: [30, 30], round: true, distances: [1.33], at: (n) => [170 + Math.round(100 * swing(n, 300)), 62] },
{ name: "card", bright: 1.25, half: [30, 26], distances: LEVELS, at: (n) => [212 + Math.round(50 * swing(n, 420)), 172], level: (n) => Math.round(4 - 4 * Math.cos((2 * Math.PI * n) / 360)) },
];
function scene(n) {
const things = THINGS.map(({ name, half, round, distances, at, level }, index) => {
const depth = level ? level(n) : 0;
return { name, index, half, round, depth, middle: at(n), distance: distances[depth] };
});
return [...things.sort((a, b) => a.distance - b.distance), { name: "wall", distance: FAR }];
}
const seenAt = (things, x, y) => things.find(({ middle, half, round }) => !middle || covers(x - middle[0], y - middle[1], half, round));
const covers = (x, y, [across, down], round) => (round ? Math.hypot(x / across, y / down) < 1 : Math.abs(x) < across && Math.abs(y) < down);
function tablesOf(bytes) {
const { buffer } = bytes.slice();
const head = new Float32Array(buffer, 0, 31);
const [, , , , , frames, degree, , rank, count, around, imageDegree, , images] = head;
const floats = new Float32Array(buffer, 0, 37 + around);
const steps = floats.subarray(30 + around);
const left = wholes(bytes.subarray(4 * floats.length));
const taken = (length) => left.splice(0, length);
const basis = taken(rank * frames * (degree + 1));
const kept = taken(images * frames * (imageDegree + 1));
const curves = (rows, step) => Array.from({ length: rows }, () => summed(taken(count)).map((value) => value * step));
const mixes = curves(rank, steps[0]);
const sharp = curves(images, steps[1]);
const statistics = [...steps.slice(2)].flatMap((step) => curves(1, step)[0]);
const file = [...floats.subarray(14, 30), ...basis.map((value) => value / 32767), ...floats.subarray(30, 30 + around)];
for (let c = 0; c < count; c++)
for (let k = 0; k < rank; k++) for (let l = k; l < rank; l++) file.push(mixes[k][c] * mixes[l][c] * (k === l ? 1 : 2));
file.push(...statistics, ...kept.map((value) => value / 32767));
for (let c = 0; c < count; c++) file.push(...sharp.map((row) => row[c]));
const made = new ArrayBuffer(4 * (14 + file.length));
new Int32Array(made).set([0x464d4c4c, ...head.subarray(1, 14)]);
new Float32Array(made, 56).set(file);
return new Uint8Array(made);
}
const wholes = (bytes) => Array.from({ length: bytes.length / 2 }, (_, i) => ((bytes[i] | (bytes[bytes.length / 2 + i] << 8)) << 16) >> 16);
function summed(differences) {
let [value, slope] = [0, 0];
return differences.map((by) => (value = ((value + (slope += by)) << 16) >> 16));
}
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
class Depths {
constructor(core) {
this.core = core;
}
camera(file, height = DOWN, width = ACROSS) {
const { core } = this;
this.made = null;
core.call("set_camera", core.put("tables", file), file.length, height, width);
this.made = { exports: core.exports, file, height, width };
}
open(bytes, fNumber) {
this.camera(tablesOf(bytes));
this.clip = this.render(fNumber);
}
found(first, second) {
const { core, made } = this;
if (made.exports !== core.exports) this.camera(made.file, made.height, made.width);
const { height, width } = made;
const count = 3 * Math.floor(height / BLOCK_SIDE) * Math.floor(width / BLOCK_SIDE);
const [out, image] = [core.room("found", Float32Array, count), core.room("sharp", Float32Array, height * width)];
core.call("depth", core.put("first", first), core.put("second", second), width, out, image);
return { found: core.view(out, Float32Array, count).slice(), sharp: core.view(image, Float32Array, height * width).slice() };
}
pair(n, light, swapped) {
const begin = performance.now();
const uniform = generator(`frame ${n}`);
const frames = FOCI.map((_, focus) => this.recorded(this.composed(n, focus), light, uniform));
if (swapped) frames.reverse();
const middle = performance.now();
const made = this.found(...frames);
return { ...made, frames, things: scene(n), ms: performance.now() - middle, rendering: middle - begin };
}
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
blurred(plane, width, height, { out, side }) {
const { core } = this;
const image = core.room("blurred", Float32Array, plane.length);
core.call("blur", out, side, core.put("planes", plane), 1, height * FINE, width * FINE, image);
const points = core.view(image, Float32Array, plane.length);
const made = new Float32Array(width * height);
for (let i = 0; i < plane.length; i++) made[Math.floor(i / (width * FINE * FINE)) * width + Math.floor((i % (width * FINE)) / FINE)] += points[i] / FINE ** 2;
return made;
}
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
const DEFAULTS = Object.freeze(Object.fromEntries(Object.entries(FIELDS).map(([key, field]) => [key, field.initial])));
const INFINITE = /^\s*\+?(inf(inity)?|∞)\s*$/i;
function accepted(key, value) {
if (typeof key !== "string" || !Object.hasOwn(FIELDS, key)) return undefined;
const field = FIELDS[key];
if (field.choices) return field.choices.includes(value) ? value : undefined;
if (field.terms) return furtherTerms(value, field) && value;
if (field.infinite && INFINITE.test(value)) return field.high;
if (typeof value === "string" && (value.length > 40 || !/^\s*[-+.\d]/.test(value))) return undefined;
const number = typeof value === "string" ? Number(value) : value;
if (typeof number !== "number" || Number.isNaN(number)) return undefined;
const inside = Math.min(field.high, Math.max(field.low, number));
return field.whole ? Math.round(inside) : inside === 0 ? 0 : inside; // no -0
}
function furtherTerms(text, { terms, degree, waves } = FIELDS.zernike) {
if (typeof text !== "string" || text.length > 40 * terms) return undefined;
const parts = text.split(";").filter(Boolean);
const found = parts.flatMap((part) => {
const match = /^(\d{1,2}),(-?\d{1,2}):([-+]?(?:\d+\.?\d*|\.\d+)(?:e[-+]?\d{1,3})?)$/.exec(part);
const [n, m, c] = (match ?? []).slice(1).map(Number);
return n >= 1 && n <= degree && Math.abs(m) <= n && (n - m) % 2 === 0 && Math.abs(c) <= waves ? [[n, m, c]] : [];
});
const different = new Set(found.map(([n, m]) => `${n},${m}`)).size;
return parts.length <= terms && different === parts.length ? found : undefined;
}
function changed(state, change) {
const next = { ...state };
for (const key of Object.keys(change ?? {})) {
const value = accepted(key, change[key]);
if (value !== undefined) next[key] = value;
}
return next;
}
function withSpikes(change, before = DEFAULTS) {
return Number(change?.vanes) > 0 && !before.vanes && !("stretch" in change) ? { ...change, stretch: "log" } : change;
}
const LONGEST_TEXT = 8000; // that is read
const pairsIn = (text) => String(text).slice(0, LONGEST_TEXT).replace(/^[#?]/, "").split("&").map((part) => part.split("=", 2)).filter((pair) => pair.length === 2);
function fromText(text) {
const change = Object.create(null);
for (const [key, value] of pairsIn(text)) if (Object.hasOwn(FIELDS, key)) change[key] = decoded(value);
return change;
}
const OTHER_KEYS = ["name", "without"]; // of links, beside those of states
function refused(change, address = "", lesson = "") {
const unknown = pairsIn(address).map(([key]) => key).filter((key) => !Object.hasOwn(FIELDS, key) && !OTHER_KEYS.includes(key));
const values = Object.keys(change).flatMap((key) => {
const text = String(change[key]);
const value = accepted(key, text);
const { low, high, row } = FIELDS[key];
if (value === undefined) return [`${key}=${text.slice(0, 40)} is not understood`];
if (typeof value !== "number" || INFINITE.test(text) || Math.abs(value - text) <= 1e-9 * Math.abs(value)) return [];
return [`${key} is ${low} to ${high}${row.said ? ` ${row.said}` : row.waves ? " waves" : ""}, so ${value} is shown instead of ${text.slice(0, 40)}`];
});
const said = [...(lesson ? [`lesson=${lesson.slice(0, 40)} is unknown`] : []), ...unknown.map((key) => `${key.slice(0, 40)} is unknown`), ...values];
if (address.length > LONGEST_TEXT) said.push(`of its ${address.length} characters the first ${LONGEST_TEXT} are read`);
const more = said.length > 3 ? `; and ${said.length - 3} more` : "";
return said.length ? `Not as in the address: ${said.slice(0, 3).join("; ")}${more}.` : "";
}
const wordsIn = (text, key) => decoded(new RegExp(`[#&]${key}=([^&]*)`).exec(text)?.[1] ?? "").slice(0, 200);
function decoded(text) {
try {
return decodeURIComponent(text);
} catch {
return text;
}
}
function toText(state, start = DEFAULTS) {
return Object.keys(FIELDS)
.filter((key) => state[key] !== FIELDS[key].initial || state[key] !== start[key] || (key === "stretch" && state.vanes))
.map((key) => `${key}=${encodeURIComponent(state[key]).replace(/%2C|%3A|%3B/g, decodeURIComponent)}`)
.join("&");
}
const STEPS_BACK = 200;
class History {
constructor() {
this.back = [];
this.forth = [];
this.gesture = "";
}
note(before, gesture) {
if (!gesture || gesture !== this.gesture || !this.back.length) {
this.back.push(before);
if (this.back.length > STEPS_BACK) this.back.shift();
}
this.gesture = gesture;
this.forth = [];
}
undo(now) {
return this.travel(now, this.back, this.forth);
}
redo(now) {
return this.travel(now, this.forth, this.back);
}
travel(now, from, to) {
if (!from.length) return undefined;
to.push(now);
this.gesture = "";
return from.pop();
}
}
const TURN = 2 * Math.PI;
function focused(state) {
if (state.focus !== "distances") return state;
const { focal_length, focus_distance, object_distance, wavelength } = state;
const focal = focal_length * 1e-3;
if (focus_distance <= focal) {
const [length, distance] = [focal_length, focus_distance].map((value) => Number(value.toPrecision(6)));
throw new RangeError(`the focus distance must exceed the focal length of ${length} mm, and is ${distance} m`);
}
const sensor = 1 / (1 / focal - 1 / focus_distance);
const diameter = focal / state.f_number;
const defocus = ((1 / sensor - 1 / focal + 1 / object_distance) * (0.5 * diameter) ** 2) / (2e-9 * wavelength);
return { ...state, focus: "waves", defocus, f_number: sensor / diameter };
}
function unitOfLength(state) {
return state.wavelength * 1e-3 * focused(state).f_number;
}
function stepOf(state, length) {
return (Math.PI * length) / unitOfLength(state);
}
function lengthOf(state, v) {
return (v * unitOfLength(state)) / Math.PI;
}
function cutoff(state) {
return 1e3 / unitOfLength(state);
}
function linesOf(state) {
return state.light === "white" ? WHITE.map((w) => [state.wavelength / w, 1 / WHITE.length]) : [[1, 1]];
}
function further(state) {
const turned = directed(state).map(({ n, m, size, angle }) => {
const turn = (m * angle * Math.PI) / 180;
return { n, m, along: size * Math.cos(turn), across: size * Math.sin(turn) };
});
const listed = furtherTerms(state.zernike).map(([n, m, rms]) => {
const edge = rms * Math.sqrt((m === 0 ? 1 : 2) * (n + 1));
return { n, m: Math.abs(m), along: m < 0 ? 0 : edge, across: m < 0 ? edge : 0 };
});
return [...turned, ...listed].filter(({ along, across }) => along !== 0 || across !== 0);
}
function directed(state) {
return DIRECTED.map((term) => ({ ...term, size: state[term.name], angle: state[`${term.name}_angle`] })).filter(
(term) => term.size !== 0,
);
}
function vanesOf({ vanes, vane_angle }) {
return Array.from({ length: vanes }, (_, k) => (vane_angle * Math.PI) / 180 + (TURN * k) / vanes);
}
function clearOf(state) {
const vanes = vanesOf(state);
const behind = (rho, turn) => rho * Math.cos(turn) > 0 && Math.abs(rho * Math.sin(turn)) < 0.5 * state.vane_width;
return (rho, theta) => rho <= 1 && rho >= state.obscuration && !vanes.some((angle) => behind(rho, theta - angle));
}
function radialOf({ n, m }, rho) {
const [p, q] = [(n + m) / 2, (n - m) / 2];
let factor = 1;
for (let k = 1; k <= q; k++) factor *= (p + k) / k;
let over = 0;
let slope = 0;
for (let k = 0, power = n; power > 0 && k <= q; k++, power -= 2) {
const part = factor * rho ** (power - 1);
over += part;
slope += power * part;
factor *= -((p - k) * (q - k)) / ((k + 1) * (n - k));
}
return { over, slope };
}
function termsOf(given, [x, y] = [0, 0]) {
const state = focused(given);
const { defocus, spherical } = state;
const terms = new Map();
const add = (n, m, c) => terms.set(`${n},${m}`, [n, m, (terms.get(`${n},${m}`)?.[2] ?? 0) + TURN * c]);
add(2, 0, 0.5 * (defocus + spherical));
add(4, 0, spherical / 6);
for (const { n, m, along, across } of further(state)) {
add(n, m, along);
if (m) add(n, -m, across);
}
add(1, 1, x / TURN);
add(1, -1, y / TURN);
return [...terms.values()].filter(([, , c]) => c !== 0);
}
const RADII = 64;
const PARTS_OF_ARC = 32;
function centroidOf(given) {
const state = focused(given);
if (!further(state).some(({ m }) => m) && !state.vanes) return [0, 0];
const slope = slopes(state);
const arcs = Math.max(1, state.vanes);
const inner = state.obscuration ** 2;
let [area, x, y] = [0, 0, 0];
for (let i = 0; i < RADII; i++) {
const share = (2 * Math.floor(i / 2) + 1 + (i % 2 ? 1 : -1) / Math.sqrt(3)) / RADII;
const rho = Math.sqrt(inner + (1 - inner) * share);
const hidden = state.vanes ? Math.asin(Math.min(1, (0.5 * state.vane_width) / rho)) : 0;
const step = (TURN / arcs - 2 * hidden) / PARTS_OF_ARC;
for (let k = 0; step > 0 && k < arcs * (PARTS_OF_ARC + 1); k++) {
const part = k % (PARTS_OF_ARC + 1);
const theta = (state.vanes ? (state.vane_angle * Math.PI) / 180 : 0) + (TURN * Math.floor(k / (PARTS_OF_ARC + 1))) / arcs + hidden + part * step;
const weight = step * (part % PARTS_OF_ARC ? (part % 2 ? 4 : 2) : 1);
const [outward, around] = slope(rho, theta);
const [c, s] = [Math.cos(theta), Math.sin(theta)];
area += weight;
x += weight * (outward * c - around * s);
y += weight * (outward * s + around * c);
}
}
return [x / area, y / area];
}
function waves(given) {
const state = focused(given);
const others = further(state);
return (rho, theta) => {
const t = rho * rho;
let sum = (state.defocus + state.spherical * t) * t;
for (const term of others) sum += radialOf(term, rho).over * rho * around(term, theta)[0];
return sum;
};
}
function around({ m, along, across }, theta) {
const [c, s] = [Math.cos(m * theta), Math.sin(m * theta)];
return [along * c + across * s, m * (across * c - along * s)];
}
function slopes(given) {
const state = focused(given);
const others = further(state);
return (rho, theta) => {
let outward = (2 * state.defocus + 4 * state.spherical * rho * rho) * rho;
let across = 0;
for (const term of others) {
const { over, slope } = radialOf(term, rho);
const [value, turning] = around(term, theta);
outward += slope * value;
across += over * turning;
}
return [TURN * outward, TURN * across];
};
}
function rayReach(state) {
const slope = slopes(state);
const angles = further(state).some(({ m }) => m) ? 48 : 1;
let most = 0;
for (let i = 0; i <= 24; i++) {
const rho = state.obscuration + ((1 - state.obscuration) * i) / 24;
for (let k = 0; k < angles; k++) most = Math.max(most, Math.hypot(...slope(rho, (TURN * k) / angles)));
}
return most;
}
function fineReach(state) {
const wanted = lengthOf(state, 1.15 * rayReach(state) + 14);
return 2 ** (Math.ceil(2 * Math.log2(wanted)) / 2);
}
function spreadReach(state, size) {
const wanted = (lengthOf(state, 1.15 * rayReach(state) + 30) - 0.5 * state.pixel) / state.pixel;
return Math.max(1, Math.min(Math.ceil(wanted), 128, size));
}
function largestStep(state, pixel) {
return stepOf(state, pixel) * Math.max(...linesOf(state).map(([stretch]) => stretch));
}
function pixelOf(state, side) {
return state.view === "fine" ? (2 * fineReach(state)) / side : state.pixel;
}
function pythonOf(state, side, pixel) {
const lines = ["import lommel as lm", ""];
const distances = state.focus === "distances";
const seidel = [];
if (state.defocus && !distances) seidel.push(`W020=${state.defocus}`);
if (state.spherical) seidel.push(`W040=${state.spherical}`);
lines.push(seidel.length ? `wavefront = lm.Wavefront.from_seidel(${seidel.join(", ")})` : "wavefront = lm.Wavefront()");
for (const { n, m, size, angle } of directed(state)) {
const term = `lm.Wavefront.zernike({(${n}, ${m}): ${size}}, unit="waves", normalization="edge")`;
lines.push(`wavefront += ${term}${angle ? `.rotated(${(angle * Math.PI) / 180})` : ""}`);
}
const listed = furtherTerms(state.zernike).map(([n, m, rms]) => `(${n}, ${m}): ${rms}`);
if (listed.length) lines.push(`wavefront += lm.Wavefront.zernike({${listed.join(", ")}}, unit="waves")`);
const light = [`wavelength=${metres(state.wavelength, -9)}`];
if (state.obscuration) light.push(`obscuration=${state.obscuration}`);
if (state.vanes) {
const [first] = vanesOf(state);
light.push(`spider=lm.Spider.equal(${state.vanes}, width=${state.vane_width}${first ? `, first=${first}` : ""})`);
}
if (distances) {
const { focal_length, f_number } = state;
const stop = focal_length > 1000 ? `aperture_diameter=${metres(focal_length / f_number, -3)}` : `f_number=${f_number}`;
const lens = [`focal_length=${metres(focal_length, -3)}`, stop, `focus_distance=${state.focus_distance}`, ...light];
if (lines.length > 3 || seidel.length) lens.push("aberrations=wavefront");
else lines.pop();
lines.push(`lens = lm.Lens(${lens.join(", ")})`, `pupil = lens.pupil(object_distance=${state.object_distance})`);
} else lines.push(`pupil = lm.Pupil(${["wavefront", ...light, `f_number=${state.f_number}`].join(", ")})`);
if (state.view !== "fine" && side < state.side) lines.push(`# The middle of the window of ${state.side} x ${state.side} pixels, whose light the page states.`);
const asked = ["pupil", String(side), `pixel=${metres(pixel, -6)}`];
if (state.light === "white") {
const list = WHITE.map((w) => metres(w, -9)).join(", ");
lines.push(`white = lm.methods.Polychromatic([${list}], [1.0] * ${WHITE.length})`);
asked.push("method=white");
}
if (state.view !== "averaged") asked.push("integrate=False");
lines.push(`psf = lm.psf(${asked.join(", ")})`);
const of = state.view === "averaged" ? 'of="optics"' : ""; // FWHM and diameters of the page are without the pixel
lines.push(`# As the page states them, in metres: psf.energy_diameter(0.8, ${['about="centroid"', of].filter(Boolean).join(", ")}), psf.fwhm(${of})`);
return lines.join("\n") + "\n";
}
function metres(value, exponent) {
const [digits, power] = value.toExponential().split("e");
return pythonFloat(Number(`${digits}e${Number(power) + exponent}`));
}
function pythonFloat(value) {
const [digits, power] = value.toExponential().split("e").map((part, index) => (index ? Number(part) : part));
const sign = power < 0 ? "-" : "+";
if (value !== 0 && (power < -4 || power >= 16)) return `${digits}e${sign}${String(Math.abs(power)).padStart(2, "0")}`;
if (Number.isInteger(value)) return `${value}.0`;
return power < 0 ? value.toFixed(Math.min(100, digits.replace(/[-.]/g, "").length - 1 - power)) : String(value);
}
const POINTS = 720; // of each circular edge
const ALONG = 40; // of each vane
const NODES = 400; // of the clear area
function lightOutside(state, low, high) {
const beyond = Math.min(-low, high) - rayReach(state);
if (!(beyond > 0)) return { share: NaN, error: Infinity };
const slope = slopes(state);
const [eps, half] = [state.obscuration, 0.5 * state.vane_width];
const angles = vanesOf(state);
const count = angles.length;
const hidden = (rho) => (count ? Math.min(Math.PI / count, Math.asin(Math.min(1, half / rho))) : 0);
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
const first = count > 1 ? half / Math.sin(Math.PI / count) : half;
const [from, to] = [Math.max(first, eps), 1].map((rho) => Math.sqrt(Math.max(0, rho ** 2 - half ** 2)));
for (const angle of angles) {
const normal = [-Math.sin(angle), Math.cos(angle)];
for (let k = 0; k < ALONG; k++) both(from + ((to - from) * (k + 0.5)) / ALONG, angle, normal, (to - from) / ALONG, (s) => slit(2 * half, s));
}
if (count === 1 && eps < half) both(1e-9, angles[0], [Math.cos(angles[0]), Math.sin(angles[0])], 2 * (half - eps), (s) => 1 / s);
const lines = linesOf(state).reduce((all, [stretch, part]) => all + part / stretch, 0);
const rings = (1 + (2 * Math.sqrt(eps)) / (1 - eps) + 2 * count) / clear;
return { share: (lines * sum) / (2 * Math.PI ** 2 * clear), error: (0.2 * rings) / beyond ** 2 };
}
function slit(w, s) {
const x = w * s;
return 2 * w * ((1 - Math.cos(x)) / x + sineRest(x));
}
function sineRest(x) {
if (x > 12) {
const y = 1 / (x * x);
return (Math.cos(x) * (1 - y * (2 - 24 * y))) / x + Math.sin(x) * y * (1 - y * (6 - 120 * y));
}
let rest = Math.PI / 2;
for (let n = 1, term = x; Math.abs(term) > 1e-16; n += 2, term *= (-x * x) / ((n - 1) * n)) rest -= term / n;
return rest;
}
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
class Engine {
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
extents(given, quality = "settled") {
const stated = changed(DEFAULTS, given);
const state = focused(stated);
this.refuse(stated, quality);
const fwhm = this.fwhm(state, quality);
const { share: inside, error: inside_error } = this.inside(state, quality);
return { fwhm, inside, inside_error };
}
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
this.light(state, centroid.map((at) => -at));
const far = radius < 0 ? reach : Math.min(reach, 1.02 * (radius + Math.hypot(...centroid)));
if (!cut) this.core.call("set_circles", far, Math.max(error, 1e-7));
const near = cut && evenly(Math.max(33, Math.ceil((radii * far) / reach)), far);
const about = cut ? sharesOf(state, near, this.cutLight(near, 1)).radius : this.core.call("radius_of", 0.8, far);
return { ...made, d80: about < 0 ? null : 2 * lengthOf(state, about) };
}
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
inside(state, quality) {
const width = state.side * pixelOf(state, state.side);
const low = -(Math.floor(state.side / 2) + 0.5) * pixelOf(state, state.side);
const past = lightOutside(state, stepOf(state, low), stepOf(state, low + width));
const found = { share: 1 - past.share, error: past.error };
if (found.error < 1e-5) return found;
const middle = stepOf(state, low + 0.5 * width);
if (!state.vanes && !unevenSlope(state)) return this.roundInside(state, stepOf(state, 0.5 * width), middle);
const across = 2 * Math.ceil(largestStep(state, width) / 1.8) + 1;
if (across > QUALITY[quality].across || this.tooLong(state, across, width / across, true)) return found.error < 0.01 ? found : { share: NaN, error: NaN };
const sum = this.image(state, across, width / across, true, QUALITY.settled.tol, null, [-middle, -middle])[2];
return { share: sum, error: SUMMED };
}
roundInside(state, half, middle) {
const ends = [half + middle, half - middle];
this.light(state);
this.core.call("set_circles", Math.SQRT2 * Math.max(...ends), 1e-7);
let share = 0;
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
blur(given, picture, width, height, quality = "drag") {
const stated = changed(DEFAULTS, given);
const state = focused(stated);
const size = width * height;
const count = Math.floor(picture.length / size);
const side = 2 * spreadReach(state, Math.min(width, height)) + 1;
const { core } = this;
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
noisy(light, state) {
const expected = light.map((value) => Math.max(0, value) * state.photons);
return counted(expected, state, seedOf(state, `picture ${termsOf(state)}`)).map((count) => Math.max(0, count / state.photons));
}
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
colour(pixels) {
const planes = this.core.view(this.core.room("colours", Float32Array, 3 * pixels), Float32Array, 3 * pixels);
let most = 0;
for (const value of planes) if (value > most) most = value;
const scale = most > 0 ? 1 / most : 0;
return planes.map((value) => Math.max(0, value * scale));
}
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
if (asked < 1e-3 && error.message === "tolerance not met") continue;
throw error;
}
copy?.set(core.view(out, Float32Array, side * side));
return core.view(numbers, Float64Array, 4).slice();
}
}
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
if (late(stated, quality)) throw new RangeError(`it would take too long. ${advice(stated, (given) => !late(given, "settled"))}`);
}
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
circles(v, energy) {
const { core } = this;
const at = core.put("points", v);
const out = core.room("numbers", Float64Array, 2 * v.length);
core.call("on_circles", at, v.length, energy ? 1 : 0, out, out + 8 * v.length);
const both = core.view(out, Float64Array, 2 * v.length).map((value) => Math.max(0, value));
return [both.slice(0, v.length), both.slice(v.length)];
}
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
const refused = `No MTF: it would take too long. ${advice(stated, cheap, 1)}`;
return { f: Float64Array.of(0, end * cutoff(state)), x: none, y: none, limit: none, refused };
}
if (!near) core.call("contrast", at, count, nodes, out, out + 16 * count, out + 32 * count);
const [x, y] = [0, 1].map((k) => core.view(out + 16 * count * k, Float64Array, 2 * count).slice());
const limit = core.view(out + 32 * count, Float64Array, count).slice();
const made = interpolated(samples, x, y, limit);
return { ...made, error, f: made.f.map((over) => over * cutoff(state)) };
}
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
function completed({ unaberrated, ...curves }, { peak }) {
return { ...curves, peak_strehl: peak / unaberrated };
}
function asked(state, quality) {
const slow = state.light === "white" || termsOf(state).some(([, m]) => m !== 0);
const { tol, side: most } = QUALITY[slow ? quality : "settled"];
let side = Math.min(state.side, state.view === "fine" ? most : QUALITY[quality].seen);
const averaged = state.view === "averaged";
const rows = alongRows(state, averaged);
const v = largestStep(state, state.pixel);
const white = state.light === "white";
if ((rows && state.view !== "fine") || (state.view === "sampled" ? unevenSlope(state) > 0 : averaged && unevenSlope(state) > 170)) {
const near = rows ? 0 : averaged ? (white ? 1000 : 2700) / Math.ceil(v) : 2 * Math.floor((white ? 800 : 2400) / v);
side = Math.min(side, Math.max(v > 40 ? 16 : 64, 2 * Math.floor(near / 2), 2 * Math.ceil(fineReach(state) / state.pixel)));
}
if (state.view !== "fine" && side * v > 6e4 && rayReach(state) > 20) side = Math.max(64, 2 * Math.floor(3e4 / v));
return { side, pixel: pixelOf(state, side), tol };
}
function keyOf(state, side, pixel, tol) {
return JSON.stringify([termsOf(state), linesOf(state), state.obscuration, vanesOf(state), state.vane_width, state.view === "averaged", stepOf(state, pixel), side, tol]);
}
function slopeOf(state) {
return rayReach(state) * Math.max(...linesOf(state).map(([stretch]) => stretch));
}
function unevenSlope(state) {
return termsOf(state).some(([, m]) => m !== 0) ? slopeOf(state) : 0;
}
function beyondSeries(state, integrate) {
return unevenSlope(state) > (state.light === "white" ? 500 : integrate ? 800 : 1500);
}
function alongRows(state, integrate) {
return state.vanes > 0 || beyondSeries(state, integrate);
}
function least(list, fits) {
let [low, high] = [0, list.length];
while (low < high) {
const middle = (low + high) >> 1;
if (fits(list[middle])) high = middle;
else low = middle + 1;
}
return list[low];
}
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
const found = [];
for (let k = -1; k < choices && !found.length; k++) {
const [first, [[, base]]] = k < 0 ? ["", [["", {}]]] : lists[k];
for (const [name, changes] of lists) {
if (name === first || found.length === (k < 0 ? most : 1)) continue;
const helps = least(changes, ([, change]) => fits({ ...state, ...base, ...change }));
if (helps) found.push([first && `${first} and`, name, helps[0]].filter(Boolean).join(" "));
}
}
const said = found.join(", or ") || "reduce the aberrations";
return `${said[0].toUpperCase()}${said.slice(1)}.`;
}
function beyondCircles(state) {
return slopeOf(state) > 2750 || (state.light === "white" && unevenSlope(state) > 700);
}
function seedOf({ photons, read_noise }, key) {
return `${key} ${photons} ${read_noise}`;
}
function withPixel({ pixel }, mtf) {
const turn = (f) => Math.PI * f * pixel * 1e-3;
const of = (curve) => curve.map((contrast, i) => (i ? Math.abs((contrast * Math.sin(turn(mtf.f[i]))) / turn(mtf.f[i])) : contrast));
return { ...mtf, pixel_x: of(mtf.x), pixel_y: of(mtf.y) };
}
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
function brightness(state) {
return linesOf(state).reduce((all, [stretch, part]) => all + part * stretch ** 2, 0);
}
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
function interpolated(samples, x, y, limit) {
const last = samples.length - 1;
const f = Float64Array.from({ length: PARTS * last + 1 }, (_, i) => {
const k = Math.min(last - 1, Math.floor(i / PARTS));
return samples[k] + ((i - PARTS * k) / PARTS) * (samples[k + 1] - samples[k]);
});
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
const moved = i % PARTS ? i : least < f[i] ? i - 1 : i + 1;
if (moved % PARTS) f[moved] = least;
}
}
const real = f.map((at, i) => Math.max(0, weightsAt(at, interval(i)).reduce((sum, [j, weight]) => sum + weight * limit[j], 0)));
return { f, x: curve(x), y: curve(y), limit: real };
}
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
function evenly(count, last) {
return Float64Array.from({ length: count }, (_, i) => (last * i) / (count - 1));
}
return { CAMERA, Core, DEFAULTS, DIRECTED, Engine, FIELDS, History, INFINITE, WHITE, changed, completed, crc32, focused, fromText, furtherTerms, linesOf, pythonFloat, refused, seenAt, termsOf, toText, unitOfLength, vanesOf, withSpikes, wordsIn };
};
const { CAMERA, Core, DEFAULTS, DIRECTED, Engine, FIELDS, History, INFINITE, WHITE, changed, completed, crc32, focused, fromText, furtherTerms, linesOf, pythonFloat, refused, seenAt, termsOf, toText, unitOfLength, vanesOf, withSpikes, wordsIn } = common();
function pythonJson(value, sorted) {
if (Array.isArray(value)) return `[${value.map((part) => pythonJson(part, sorted)).join(", ")}]`;
if (value instanceof Float) return value.text;
if (value !== null && typeof value === "object") {
const keys = sorted ? Object.keys(value).sort() : Object.keys(value);
return `{${keys.map((key) => `${JSON.stringify(key)}: ${pythonJson(value[key], sorted)}`).join(", ")}}`;
}
return JSON.stringify(value);
}
class Float {
constructor(value) {
this.text = pythonFloat(value);
}
}
function describedPsf(given, psf) {
const state = focused(given);
const float = (value) => new Float(value);
const { side, pixel, bound, area, values } = psf;
const terms = termsOf(state).map(([n, m, c]) => [n, m, float(c)]);
const lengthOf = unitOfLength(state);
const shape = [side, side];
const said = {
software: "lommel live",
pupil: {
wavefront: { terms },
obscuration: float(state.obscuration),
wavelength: float(state.wavelength * 1e-9),
f_number: float(state.f_number),
apodization: float(0),
geometry: null,
...(state.vanes ? { spider: { width: float(state.vane_width), angles: vanesOf(state).map(float) } } : {}),
},
method: methodOf(state, float),
sampling: state.view === "averaged" ? "pixel" : "center",
normalize: "energy",
pixel: float(pixel * 1e-6),
center: [float(side >> 1), float(side >> 1)],
integrate: state.view === "averaged",
unit: "m",
error_bound: bound === null ? null : float(bound),
derivative_bounds: {},
scale: float(((pixel / lengthOf) ** 2 * Math.PI) / 4 / area),
shape,
dtype: "float32",
};
const plain = new Uint8Array(values.buffer, values.byteOffset, values.byteLength);
const text = (value) => new TextEncoder().encode(value);
const sum = crc32(plain, crc32(text("values"), crc32(text(pythonJson(said, true)))));
return pythonJson({ ...said, checksum: `crc32 ${sum.toString(16).padStart(8, "0")}` }, false);
}
function methodOf(state, float) {
if (state.light !== "white") return { name: state.vanes ? "NonuniformFFT" : "NijboerZernike", tol: float(1e-6) };
const wavelengths = WHITE.map((line) => float(line * 1e-9));
const weights = linesOf(state).map(([, share]) => float(share));
return { name: "Polychromatic", wavelengths, weights, method: null, tol: float(1e-6) };
}
function el(name, attributes = {}, ...children) {
const node = document.createElement(name);
for (const [key, value] of Object.entries(attributes)) {
if (key.startsWith("on")) node.addEventListener(key.slice(2), value);
else if (value === true) node.setAttribute(key, "");
else if (value !== false && value !== undefined) node.setAttribute(key, value);
}
node.append(...children.filter((child) => child !== null && child !== undefined));
if (/^(input|select|button|summary)$/.test(name)) node.setAttribute("data-lm-suppress-shortcuts", "true");
return node;
}
let given = 0;
const unique = (name) => `lommel-${name}-${++given}`;
function menu(label, choices, value, onpick, attributes = {}) {
const options = Object.entries(choices).map(([key, text]) => el("option", { value: key }, text));
const node = el("select", { "aria-label": label, title: label, onchange: () => onpick(node.value), ...attributes }, ...options);
node.value = value;
return node;
}
const ANCHORS = {
inferno: "000004050417110a30210c4a320a5e450a6957106e67166e781c6d8a226a9a2865ab2f5ebc3754ca404ad84c3ee45a31ed6925f57b17f98e09fca108fbb61af9cb35f4df53f2f27dfcffa4",
viridis: "440154471063481f70472d7b4439834046883b528b365d8d31688e2c728e287c8e24868e21918c1f9a8a20a48628ae8035b77948c16e5ec96275d05490d743addc30c8e020e5e419fde725",
cividis: "00224e002a5f0031701a386f2a3f6d38476c434e6c4d556c575d6d61656f6a6c717374757d7c78868379918b789b9476a59c74b0a571bcae6cc6b667d2c060dec958e9d34ef6dd3ffee838",
gray: "000000ffffff", // of sRGB, whose steps look even by themselves
signed: "2a4a8c3f6fb36d9bd0a5c4e3dbe6f0f5f3efefd9ccdfa893ca7460a9443f7c2230",
};
function colour(map, t) {
const text = ANCHORS[map];
const last = text.length / 6 - 1;
const place = Math.min(1, Math.max(0, t)) * last;
const low = Math.min(Math.floor(place), last - 1);
return [0, 2, 4].map((at) => {
const [a, b] = [low, low + 1].map((k) => parseInt(text.slice(6 * k + at, 6 * k + at + 2), 16));
return Math.round(a + (b - a) * (place - low));
});
}
const DECADES = 5; // that the logarithmic stretch shows
const RAYS = "#5ee0ff";
const TRUE_COLOUR = "colour";
const mapOf = ({ map, light }) => (map !== "auto" ? map : light === "white" ? TRUE_COLOUR : "inferno");
const STRETCHES = {
linear: (share) => share,
sqrt: Math.sqrt,
log: (share) => 1 + Math.log10(Math.max(share, 1e-30)) / DECADES,
};
const pack = ([r, g, b], alpha = 255) => ((alpha << 24) | (b << 16) | (g << 8) | r) >>> 0;
const STEPS = 4095;
const tables = new Map();
function table(map, stretch) {
const name = `${map} ${stretch}`;
if (!tables.has(name)) {
const made = new Uint32Array(STEPS + 1);
for (let i = 0; i <= STEPS; i++) made[i] = pack(colour(map, STRETCHES[stretch]((i / STEPS) ** 4)));
tables.set(name, made);
}
return tables.get(name);
}
function fit(canvas, width, height) {
if (canvas.width !== width) canvas.width = width;
if (canvas.height !== height) canvas.height = height;
return canvas.getContext("2d");
}
const images = new WeakMap();
function pixels(canvas, width, height) {
const context = fit(canvas, width, height);
let image = images.get(canvas);
if (!image || image.width !== width || image.height !== height) {
image = context.createImageData(width, height);
images.set(canvas, image);
}
return { context, image, out: new Uint32Array(image.data.buffer) };
}
function largest(values) {
let top = 0;
for (let i = 0; i < values.length; i++) if (values[i] > top) top = values[i];
return top;
}
function drawPsf(canvas, { values, side, colour: planes }, { map, stretch, crop = side, top = largest(values) }) {
const { context, image, out } = pixels(canvas, crop, crop);
const first = Math.floor(side / 2) - Math.floor(crop / 2);
const scale = top > 0 ? 1 / top : 0;
const coloured = map === TRUE_COLOUR && planes;
const colours = table(map === TRUE_COLOUR ? "gray" : map, stretch);
const gain = coloured ? largest(values) * scale : scale;
const size = side * side;
const stretched = STRETCHES[stretch];
for (let y = 0, i = 0; y < crop; y++) {
const row = (first + y) * side + first;
for (let x = 0; x < crop; x++, i++) {
if (!coloured) {
const value = values[row + x];
out[i] = colours[value > 0 ? Math.min(STEPS, (Math.sqrt(Math.sqrt(value * scale)) * STEPS + 0.5) | 0) : 0];
continue;
}
const r = planes[row + x];
const g = planes[size + row + x];
const b = planes[2 * size + row + x];
const most = Math.max(r, g, b);
const factor = most > 0 ? LIGHT[(4095 * Math.max(0, stretched(Math.min(1, most * gain))) + 0.5) | 0] / most : 0;
out[i] = (255 << 24) | (SRGB[level(b * factor)] << 16) | (SRGB[level(g * factor)] << 8) | SRGB[level(r * factor)];
}
}
context.putImageData(image, 0, 0);
}
function drawBar(canvas, { map, stretch }, top = 1) {
const { context, image, out } = pixels(canvas, 256, 1);
for (let x = 0; x < 256; x++) out[x] = pack(colour(map === TRUE_COLOUR ? "gray" : map, x / 255));
context.putImageData(image, 0, 0);
if (stretch === "log") {
const first = Math.ceil(Math.log10(top) - DECADES - 1e-9);
const last = Math.floor(Math.log10(top) + 1e-9);
return integers(first, last).map((power) => [1 + (power - Math.log10(top)) / DECADES, powerOfTen(power)]);
}
const step = tickStep(top);
const floored = (value) => Math.floor(value / 10 ** Math.floor(Math.log10(value)) + 1e-9) * 10 ** Math.floor(Math.log10(value));
const marks = stretch === "sqrt" ? [0, ...[0.05, 0.2, 0.5, 1].map((share) => floored(share * top))] : integers(0, Math.floor(1e-9 + top / step)).map((k) => k * step);
const ticks = marks.map((mark) => [STRETCHES[stretch](mark / top), String(Number(mark.toPrecision(4)))]);
return ticks.filter(([at, word], k) => k === 0 || at - ticks[k - 1][0] > (6 * word.length + 6) / 200);
}
const integers = (first, last) => Array.from({ length: last - first + 1 }, (_, i) => first + i);
const tickStep = (top) => {
const power = 10 ** Math.floor(Math.log10(top / 4));
return power * [1, 2, 2.5, 5, 10].find((step) => step * power >= (top / 4) * (1 - 1e-9));
};
const powerOfTen = (power) => (power === 0 ? "1" : `1e${power}`);
function difference(b, a, crop, top) {
const made = new Float32Array(crop * crop);
const ratio = b.pixel / a.pixel;
const [middleB, middleA, half] = [Math.floor(b.side / 2), Math.floor(a.side / 2), Math.floor(crop / 2)];
const [perB, perA] = [1 / (b.pixel * b.pixel * top), 1 / (a.pixel * a.pixel * top)];
const at = (x, y) => (x >= 0 && y >= 0 && x < a.side && y < a.side ? a.values[y * a.side + x] : 0);
for (let row = 0, i = 0; row < crop; row++) {
const y = middleA + (row - half) * ratio;
const [y0, dy] = [Math.floor(y), y - Math.floor(y)];
for (let column = 0; column < crop; column++, i++) {
const x = middleA + (column - half) * ratio;
const [x0, dx] = [Math.floor(x), x - Math.floor(x)];
let held = at(x0, y0);
if (dx || dy) held = (1 - dy) * ((1 - dx) * held + dx * at(x0 + 1, y0)) + dy * ((1 - dx) * at(x0, y0 + 1) + dx * at(x0 + 1, y0 + 1));
made[i] = b.values[(middleB + row - half) * b.side + middleB + column - half] * perB - held * perA;
}
}
return made;
}
function drawSigned(canvas, values, side, reach, stretch) {
const { context, image, out } = pixels(canvas, side, side);
const colours = ramp("signed");
const scale = reach > 0 ? 1 / reach : 0;
for (let i = 0; i < out.length; i++) out[i] = colours[Math.round(255.5 + 255.5 * signedPlace(values[i] * scale, stretch))];
context.putImageData(image, 0, 0);
}
const signedPlace = (value, stretch) => Math.sign(value) * Math.max(0, STRETCHES[stretch](Math.abs(value)));
function drawSignedBar(canvas, stretch, reach) {
const { context, image, out } = pixels(canvas, 256, 1);
for (let x = 0; x < 256; x++) out[x] = pack(colour("signed", x / 255));
context.putImageData(image, 0, 0);
const shares = stretch === "log" ? [1e-4, 1e-2, 1] : stretch === "sqrt" ? [0.25, 1] : [0.5, 1];
const word = (share) => String(Number((share * reach).toPrecision(2)));
const [low, high] = [-1, 1].map((sign) => shares.map((share) => [0.5 + 0.5 * signedPlace(sign * share, stretch), `${sign < 0 ? "−" : "+"}${word(share)}`]));
return [...low.reverse(), [0.5, "0"], ...high];
}
function placesOfRays({ x, y }, { middle, field }) {
const places = Array.from(x, (at, i) => [middle + at / field, middle + y[i] / field]);
return places.filter((place) => place.every((at) => at >= 0 && at <= 1));
}
const ramps = new Map();
function ramp(map) {
if (!ramps.has(map)) ramps.set(map, Uint32Array.from({ length: 512 }, (_, i) => pack(colour(map, i / 511))));
return ramps.get(map);
}
function drawWavefront(canvas, wavefront, side) {
const seen = statistics(wavefront);
const reach = Math.max(0.05, Math.abs(seen.low), Math.abs(seen.high));
const { context, image, out } = pixels(canvas, side, side);
const colours = ramp("signed");
for (let i = 0; i < out.length; i++) {
const waves = wavefront[i];
out[i] = waves === waves ? colours[Math.round(511 * (0.5 + (0.5 * waves) / reach))] : 0;
}
context.putImageData(image, 0, 0);
return seen;
}
function drawFringes(canvas, wavefront, side) {
const { context, image, out } = pixels(canvas, side, side);
const colours = ramp("gray");
let resolved = true;
for (let i = 0; i < out.length; i++) {
const waves = wavefront[i];
const by = (k) => Math.abs(wavefront[k] - waves) || 0;
const x = i % side;
const slope = Math.max(x ? by(i - 1) : 0, x < side - 1 ? by(i + 1) : 0, by(i - side), by(i + side));
const contrast = Math.min(1, Math.max(0, 2.2 - 5 * slope));
if (waves === waves && !contrast) resolved = false;
out[i] = waves === waves ? colours[Math.round(275 + contrast * 225 * Math.cos(2 * Math.PI * waves))] : 0;
}
context.putImageData(image, 0, 0);
return resolved;
}
function statistics(wavefront) {
let count = 0;
let sum = 0;
let squares = 0;
let low = Infinity;
let high = -Infinity;
for (const waves of wavefront)
if (waves === waves) {
count++;
sum += waves;
squares += waves * waves;
if (waves < low) low = waves;
if (waves > high) high = waves;
}
if (!count) return { low: 0, high: 0, rms: 0 };
return { low, high, rms: Math.sqrt(Math.max(0, squares / count - (sum / count) ** 2)) };
}
const encoded = (light) => (light <= 0.0031308 ? 12.92 * light : 1.055 * light ** (1 / 2.4) - 0.055);
const SRGB = Uint8ClampedArray.from({ length: 4096 }, (_, i) => 255 * encoded(i / 4095));
const LIGHT = Float32Array.from({ length: 4096 }, (_, i) => (i <= 165 ? i / 4095 / 12.92 : ((i / 4095 + 0.055) / 1.055) ** 2.4)); // of a level
const GREYS = Uint32Array.from(SRGB, (level) => pack([level, level, level]));
const level = (light) => (light >= 1 ? 4095 : light > 0 ? (light * 4095 + 0.5) | 0 : 0);
function drawPicture(canvas, { planes, width, height, count }) {
const { context, image, out } = pixels(canvas, width, height);
const size = width * height;
if (count === 1) for (let i = 0; i < size; i++) out[i] = GREYS[level(planes[i])];
else
for (let i = 0; i < size; i++) {
const [r, g, b] = [planes[i], planes[size + i], planes[2 * size + i]];
out[i] = (255 << 24) | (SRGB[level(b)] << 16) | (SRGB[level(g)] << 8) | SRGB[level(r)];
}
context.putImageData(image, 0, 0);
}
const axisOf = (count) => (Math.floor(count / 2) + 0.5) / count;
function drawAtScale(canvas, source, { ratio, side, from, to, ground, smooth }) {
const context = fit(canvas, side, side);
context.fillStyle = ground;
context.fillRect(0, 0, side, side);
const size = side * ratio;
const corner = side * to - size * from;
context.imageSmoothingEnabled = smooth;
context.drawImage(source, corner, corner, size, size);
}
const WAVES_UNITS = { waves: "waves", rad: "radians", nm: "nanometres" };
const LENGTH_UNITS = { um: "micrometres", arcsec: "arcseconds", lambdaN: "λN" };
function wavesUnit({ waves_unit, wavelength }) {
return {
waves: { factor: 1, name: "waves" },
rad: { factor: 2 * Math.PI, name: "rad" },
nm: { factor: wavelength, name: "nm" },
}[waves_unit];
}
const withUnit = (text, name) => `${text} ${name === "waves" && /^[-−]?1$/.test(text) ? "wave" : name}`;
const unitAfter = (name) => (name === "″" ? name : ` ${name}`);
function lengthUnit(state) {
return {
um: { factor: 1, name: "µm", said: "micrometres" },
arcsec: { factor: 206.264806247 / state.focal_length, name: "″", said: "arcseconds" },
lambdaN: { factor: 1 / unitOfLength(state), name: "λN", said: "lambda N" },
}[state.length_unit];
}
function frequencyUnit(state) {
const { factor, name } = lengthUnit(state);
return state.length_unit === "um" ? { factor: 1, name: "cycles/mm" } : { factor: 0.001 / factor, name: `cycles/${name}` };
}
const SVG = "http://www.w3.org/2000/svg";
const SNAP = 4; // pixels
const LEAST = 1e-6; // below which curves are not read
const MARGIN = { left: 40, right: 10, top: 8, bottom: 34 };
function svg(name, attributes = {}, ...children) {
const node = document.createElementNS(SVG, name);
for (const [key, value] of Object.entries(attributes)) node.setAttribute(key, value);
node.append(...children);
return node;
}
function niceStep(length, most) {
const rough = length / most;
const power = 10 ** Math.floor(Math.log10(rough));
return power * ([1, 2, 5, 10].find((step) => step * power >= rough * (1 - 1e-9)) ?? 10);
}
function niceTop(value) {
if (!(value > 0)) return 1;
const power = 10 ** Math.floor(Math.log10(value));
return power * [1, 2, 5, 10].find((step) => step * power >= value * (1 - 1e-9));
}
function short(value, digits = 4) {
if (!Number.isFinite(value)) return "–";
const rounded = Number(value.toPrecision(digits));
return rounded && Math.abs(rounded) < 1e-3 ? rounded.toExponential() : String(rounded);
}
function curveSaid(value, error) {
if (value < (error || LEAST)) return `< ${error ? Math.ceil(1e3 * error) / 1e3 : "1e-6"}`;
return short(error > 0 && Number.isFinite(value) ? Number(value.toFixed(Math.max(0, Math.floor(-Math.log10(error))))) : value, 3);
}
class Plot {
constructor(title) {
this.axes = svg("g", { class: "axes" });
this.clip = `clip-${Math.random().toString(36).slice(2)}`;
this.window = svg("rect", { x: MARGIN.left, y: MARGIN.top - 2 });
this.curves = svg("g", { "clip-path": `url(#${this.clip})` });
this.cursor = svg("line", { class: "cursor", visibility: "hidden" });
this.mark = svg("g", { class: "mark", visibility: "hidden" }, svg("line"), svg("text"));
const inside = svg("clipPath", { id: this.clip }, this.window);
const said = { class: "plot", role: "img", "aria-label": title, tabindex: 0, "data-lm-suppress-shortcuts": "true" };
this.node = svg("svg", said, inside, this.axes, this.mark, this.curves, this.cursor);
this.readout = document.createElement("output");
this.readout.className = "readout";
this.readout.setAttribute("aria-hidden", "true");
this.paths = [];
this.width = 320;
this.height = 190;
this.shown = null;
this.watch = new ResizeObserver(() => this.measure());
this.watch.observe(this.node);
for (const name of ["pointermove", "pointerdown"]) this.node.addEventListener(name, (event) => this.point(event));
for (const name of ["pointerleave", "blur"]) this.node.addEventListener(name, () => this.leave());
this.node.addEventListener("keydown", (event) => this.step(event));
}
destroy() {
this.watch.disconnect();
}
measure() {
const { width, height } = this.node.getBoundingClientRect();
if (width < 40 || height < 40 || (width === this.width && height === this.height)) return;
[this.width, this.height, this.drawn] = [width, height, ""];
if (this.shown) this.draw(this.shown);
}
clear() {
while (this.paths.length) this.paths.pop().remove();
this.shown = null;
this.mark.setAttribute("visibility", "hidden");
this.leave();
}
draw(shown) {
this.shown = shown;
const { x, y, curves } = shown;
const inner = { width: this.width - MARGIN.left - MARGIN.right, height: this.height - MARGIN.top - MARGIN.bottom };
const across = (value) => MARGIN.left + (value / x.top) * inner.width;
const span = y.log ? Math.log10(y.top / y.bottom) : y.top;
const share = y.log ? (value) => Math.log10(Math.max(value, y.bottom / 10) / y.bottom) / span : (value) => value / span;
const up = (value) => MARGIN.top + (1 - share(value)) * inner.height;
const drawn = JSON.stringify([x, y, this.width, this.height]);
if (drawn !== this.drawn) this.frame(x, y, inner, across, up);
this.drawn = drawn;
this.across = across;
while (this.paths.length > curves.length) this.paths.pop().remove();
curves.forEach((curve, index) => {
if (!this.paths[index]) this.curves.append((this.paths[index] = svg("path")));
this.paths[index].setAttribute("class", `curve ${curve.kind}`);
this.paths[index].setAttribute("d", path(curve, across, up, x.top));
});
this.showMark(shown, inner);
if (this.pointed === undefined) this.leave();
else this.tell(this.pointed);
}
showMark({ x, mark }, inner) {
const there = mark && mark.at <= x.top;
this.mark.setAttribute("visibility", there ? "visible" : "hidden");
if (!there) return;
const [line, text] = this.mark.children;
const place = this.across(mark.at);
for (const [name, value] of [["x1", place], ["x2", place], ["y1", MARGIN.top], ["y2", MARGIN.top + inner.height]]) line.setAttribute(name, value);
const left = place > MARGIN.left + 0.7 * inner.width;
for (const [name, value] of [["x", place + (left ? -4 : 4)], ["y", MARGIN.top + 10], ["text-anchor", left ? "end" : "start"]]) text.setAttribute(name, value);
text.textContent = mark.name;
}
frame(x, y, inner, across, up) {
const { left, top } = MARGIN;
const [right, bottom] = [left + inner.width, top + inner.height];
for (const [name, value] of [["width", inner.width + 2], ["height", inner.height + 3]]) this.window.setAttribute(name, value);
this.node.setAttribute("viewBox", `0 0 ${this.width} ${this.height}`);
const lines = [];
const words = [];
const step = niceStep(x.top, inner.width > 240 ? 6 : 4);
for (let k = 0; k * step <= x.top * (1 + 1e-9); k++) {
lines.push(svg("line", { x1: across(k * step), x2: across(k * step), y1: top, y2: bottom }));
words.push(svg("text", { x: across(k * step), y: bottom + 14, "text-anchor": "middle" }, short(k * step)));
}
const count = Math.round(y.log ? Math.log10(y.top / y.bottom) : y.top / niceStep(y.top, inner.height > 90 ? 5 : 2));
for (let k = 0; k <= count; k++) {
const mark = y.log ? y.bottom * 10 ** k : (y.top * k) / count;
const word = y.log ? powerOfTen(Math.round(Math.log10(mark))) : short(mark, 3);
lines.push(svg("line", { x1: left, x2: right, y1: up(mark), y2: up(mark) }));
words.push(svg("text", { x: left - 6, y: up(mark) + 4, "text-anchor": "end" }, word));
}
words.push(svg("text", { x: (left + right) / 2, y: this.height - 4, "text-anchor": "middle", class: "name" }, x.label));
this.axes.replaceChildren(...lines, ...words);
for (const [name, value] of [["y1", top], ["y2", bottom]]) this.cursor.setAttribute(name, value);
}
point(event) {
if (!this.shown) return;
const box = this.node.getBoundingClientRect();
const { x } = this.shown;
const at = ((event.clientX - box.left - MARGIN.left) / (box.width - MARGIN.left - MARGIN.right)) * x.top;
if (at < 0 || at > x.top) return this.leave();
return this.tell(this.snapped(at));
}
step(event) {
const by = { ArrowLeft: -1, ArrowRight: 1 }[event.key];
if (event.key === "Escape") this.leave();
if (!by || !this.shown) return;
event.preventDefault();
const { top } = this.shown.x;
const unit = 0.1 * niceStep(top, 6); // so that round numbers are met
const at = (Math.round((this.pointed ?? 0.5 * top) / unit) + by * (event.shiftKey ? 5 : 1)) * unit;
this.tell(this.snapped(Math.min(top, Math.max(0, at))));
}
snapped(at) {
let reach = (SNAP / (this.width - MARGIN.left - MARGIN.right)) * this.shown.x.top;
let found = at;
for (const { x, y } of this.shown.curves) {
for (let i = 1; i < x.length - 1; i++) {
if (!(y[i] < y[i - 1] && y[i] <= y[i + 1] && Math.abs(x[i] - at) < reach)) continue;
[found, reach] = [x[i], Math.abs(x[i] - at)];
}
}
return found;
}
tell(at) {
this.pointed = at;
for (const name of ["x1", "x2"]) this.cursor.setAttribute(name, this.across(at));
this.cursor.setAttribute("visibility", "visible");
this.readout.textContent = `${short(at, 3)}${unitAfter(this.shown.x.unit)}: ${this.values(at)}`;
this.told?.();
}
values(at) {
const said = new Map();
for (const { name, ...curve } of this.shown.curves) {
const text = curveSaid(read(curve, at), this.shown.error);
const [, first, end = ""] = /^(.*?)( with pixel)?$/.exec(name);
said.set(end + text, { text: `${end} ${text}`, names: [...(said.get(end + text)?.names ?? []), first] });
}
return [...said.values()].map(({ text, names }) => names.join(", ") + text).join("; ");
}
leave() {
this.pointed = undefined;
this.cursor.setAttribute("visibility", "hidden");
this.readout.textContent = this.readout.title = this.shown?.mark?.said ?? "";
}
}
function path({ x, y }, across, up, end) {
let text = "";
let last = -1;
for (let i = 0; i < x.length; i++) {
const near = across(x[i]) - last < 0.5 && i < x.length - 1;
if (!Number.isFinite(y[i]) || (near && !(y[i] < y[i - 1] && y[i] <= y[i + 1]))) continue;
last = across(x[i]);
text += `${text ? "L" : "M"}${Math.round(across(x[i]) * 10) / 10} ${Math.round(up(y[i]) * 10) / 10}`;
if (x[i] > end) break;
}
return text;
}
function read({ x, y }, at) {
if (!(at >= x[0]) || at > x[x.length - 1]) return NaN;
let high = 1;
while (high < x.length - 1 && x[high] < at) high++;
return y[high - 1] + ((y[high] - y[high - 1]) * (at - x[high - 1])) / (x[high] - x[high - 1] || 1);
}
function stated(value, error = 0, digits = 4) {
if (!Number.isFinite(value)) return "–";
const size = Math.abs(value);
if (error > 0 && size < error) return `< ${upwards(error)}`;
if (size === 0) return "0";
const justified = error > 0 ? Math.floor(Math.log10(size)) - Math.ceil(Math.log10(error) - 1e-9) + 1 : digits;
const rounded = Number(value.toPrecision(Math.max(1, Math.min(digits, justified))));
return Math.abs(rounded) < 1e-3 || Math.abs(rounded) >= 1e7 ? rounded.toExponential().replace("e+", "e") : String(rounded);
}
const withMinus = (text) => text.replace(/^-/, "−");
function upwards(bound) {
const power = 10 ** Math.floor(Math.log10(bound) + 1e-9);
return stated(Number((Math.ceil(bound / power - 1e-9) * power).toPrecision(1)));
}
function ratioSaid(value, error = 0) {
const size = Math.max(0, value);
return size < 1e-3 || error > 1e-4 ? stated(size, error, 2) : size.toFixed(4);
}
function percentSaid(share, error = 0) {
const value = Math.max(0, 100 * share);
if (!(error < 1)) return "–"; // nothing is known of it
if (100 * error > value) return `< ${upwards(100 * error)} %`;
const missing = 100 - value;
const least = missing >= 0.05 ? 1 : missing > 0 ? Math.ceil(-Math.log10(missing)) + 1 : 6;
const digits = Math.max(0, Math.min(6, least, Math.floor(-Math.log10(100 * error || 1e-9))));
const said = value.toFixed(digits);
if (Number(said) < 100 || share === 1) return `${said} %`;
return `> ${(Math.floor((value - 100 * error) * 10 ** digits - 1e-9) / 10 ** digits).toFixed(digits)} %`;
}
const ASSUMED = 1e-6; // error where none is proven
function errorsOf(psf, measures) {
return { strehl: measures.strehl_error ?? ASSUMED, largest: psf.bound ?? ASSUMED, inside: measures.inside_error };
}
function numbersSaid(state, psf, measures) {
const said = {};
if (psf && measures) {
const { factor, name } = lengthUnit(state);
const { strehl, largest, inside } = errorsOf(psf, measures);
const wide = measures.d80 === null ? NaN : measures.d80 * factor;
said.strehl = { text: ratioSaid(measures.strehl, strehl), value: measures.strehl, error: strehl };
said.largest = { text: ratioSaid(measures.peak_strehl, largest), value: measures.peak_strehl, error: largest };
const least = 2 * measures.energy.r.at(-1) * factor; // where the curve ends
if (!Number.isNaN(measures.d80)) said.d80 = { text: `${measures.d80 === null ? `more than ${short(least, 2)}` : short(wide)}${unitAfter(name)}`, value: wide, error: 0, unit: name };
const { fwhm } = measures;
if (fwhm) said.fwhm = { text: `${short(fwhm * factor, 3)}${unitAfter(name)}`, value: fwhm * factor, error: 2e-3 * fwhm * factor, unit: name };
said.inside = { text: percentSaid(measures.inside, inside), value: 100 * measures.inside, error: 100 * inside, unit: "points" };
}
if (psf) {
said.bound = { text: psf.bound === null ? "none" : `≤ ${stated(psf.bound, 0, 2)}`, value: NaN };
said.time = { text: `${psf.ms < 10 ? psf.ms.toFixed(1) : Math.round(psf.ms)} ms`, value: NaN };
}
return said;
}
function differenceSaid(now, held) {
if (!Number.isFinite(now.value) || !Number.isFinite(held?.value)) return "";
const by = now.value - held.value;
if (Math.abs(by) <= now.error + held.error || Math.abs(by) < 1e-12) return "as A";
const size = now.unit === "points" ? Number(Math.abs(by).toFixed(Math.abs(by) < 0.1 ? 2 : 1)) : stated(Math.abs(by), now.error + held.error, 2);
return `${by < 0 ? "−" : "+"}${size}${now.unit ? unitAfter(now.unit) : ""} from A`;
}
function computedSaid(state, { side }) {
if (side >= state.side) return "";
const size = (count) => `${count} × ${count}`;
return state.view === "fine" ? `while it moves ${size(side)} samples` : `computed: ${size(side)} of ${size(state.side)} pixels`;
}
function unprovenSaid({ vanes }, psf) {
if (!psf || psf.bound !== null) return "";
const what = vanes ? "with vanes" : "with aberrations this large";
return `No bound is proven ${what}: the page integrates along rows of the aperture. The call “As Python” states one.`;
}
function psfSaid(state, psf, measures) {
const unit = lengthUnit(state);
const field = short(psf.side * psf.pixel * unit.factor, 3);
const [most, wide] = measures.d80 === null ? ["less than ", 2 * measures.energy.r.at(-1)] : ["", measures.d80];
const spot = `${most}80 % of the light within ${short(wide * unit.factor, 3)} ${unit.said} across`;
const { strehl, largest } = numbersSaid(state, psf, measures);
const bright = `Strehl ratio on the axis ${strehl.text}, brightest point ${largest.text}`;
return `Point spread function over ${field} ${unit.said}: ${spot}; ${bright}.`;
}
function valueSaid(state, psf, measures, column, row) {
const { side, pixel, values, counts, bound } = psf;
const middle = Math.floor(side / 2);
const at = (middle + row) * side + middle + column;
const { factor, name } = lengthUnit(state);
const place = [column, row].map((steps) => withMinus(short(steps * pixel * factor, 3))).join(", ");
const said = [];
if (counts) said.push(`${Math.round(counts[at])} electrons`);
const unaberrated = measures && psf.peak / measures.peak_strehl;
const error = bound ?? 0;
const over = unaberrated ? values[at] / unaberrated : NaN;
if (psf.peak > 0) said.push(`${stated(Math.max(0, values[at] / psf.peak), unaberrated ? (error * unaberrated) / psf.peak : 0, 3)} of the brightest`);
if (unaberrated) said.push(`${stated(Math.max(0, over), error, 3)} of the unaberrated peak`);
const by = bound && unaberrated ? ` ± ${upwards(bound)}` : "";
return `x, y = ${place}${unitAfter(name)}: ${said.join(", ")}${by}`;
}
function wavefrontSaid(state, seen) {
const { factor, name } = wavesUnit(state);
return `${withUnit(short((seen.high - seen.low) * factor, 3), name)} P–V, ${short(seen.rms * factor, 3)} rms`;
}
function waveSaid(state, wavefront, side, column, row) {
const waves = wavefront[row * side + column];
const place = [column, row].map((at) => withMinus(short((2 * at + 1) / side - 1, 2))).join(", ");
const { factor, name } = wavesUnit(state);
return `x, y = ${place} of the radius: ${waves === waves ? withUnit(withMinus(stated(waves * factor, 0, 3)), name) : "no light"}`;
}
function plotSaid(title, x, curves) {
const ends = curves.filter((curve) => curve.name && curve.y.length).map((curve) => {
const { x: at, y } = curve;
const level = title === "Encircled energy" ? 0.5 : 0.5 * y[0];
const k = y.findIndex((value) => (title === "Encircled energy" ? value >= level : value <= level));
const half = at[k - 1] + ((at[k] - at[k - 1]) * (level - y[k - 1])) / (y[k] - y[k - 1]);
return k > 0 ? `${curve.name} passes ${title === "Profile" ? "half its value on the axis" : "one half"} at ${short(half, 3)} ${x.unit}` : curve.name;
});
return `${title}: ${ends.join("; ")}.`;
}
const RAYS_SAID = "rays (geometrical optics)";
function cropOf({ view }, { psf: { side, pixel }, measures }) {
if (view === "fine" || !measures?.d80_axis) return side;
const wanted = 2 ** (Math.ceil(2 * Math.log2((4 * measures.d80_axis) / pixel)) / 2);
return Math.min(side, Math.max(16, 2 * Math.round(wanted / 2)));
}
function fieldOf(held) {
const { energy } = held.measures;
return Math.min(cropOf(held.state, held) * held.psf.pixel, 2.2 * (energy.r[energy.share.findIndex((share) => share > 0.98)] ?? Infinity));
}
const imageOf = ({ psf }) => (psf.counts ? { ...psf, values: psf.counts, colour: null } : psf);
const density = (image) => largest(image.values) / image.pixel ** 2;
function compose(canvases, { state, shown, held = null, mode = "one", shared = true }) {
const { psf } = shown;
const one = !held || mode === "difference";
const least = cropOf(state, shown);
const crop = one ? least : Math.max(least, 2 * Math.ceil(fieldOf(held) / (2 * psf.pixel)));
const field = crop * psf.pixel;
const map = mapOf(state);
const middle = axisOf(crop);
const found = { field, crop, middle, panels: [{ name: held ? "B" : "", canvas: canvases.now, state, shown }] };
if (held && one) {
const top = Math.max(density(psf), density(held.psf));
const values = difference(psf, held.psf, crop, top);
const reach = values.reduce((most, value) => Math.max(most, Math.abs(value)), 0);
drawSigned(canvases.now, values, crop, reach, state.stretch);
found.panels[0].name = "B − A";
return { ...found, ticks: drawSignedBar(canvases.bar, state.stretch, reach), label: "B minus A, of the brightest point of both", signed: true };
}
const image = imageOf(shown);
const old = held && imageOf(held);
const both = old && shared && Boolean(psf.counts) === Boolean(held.psf.counts);
const top = both ? Math.max(density(image), density(old)) * image.pixel ** 2 : largest(image.values);
const draw = (canvas, of, answer, shownImage, brightest) => {
const own = shownImage.pixel === psf.pixel ? Math.min(crop, shownImage.side) : cropOf(of, answer);
const colours = map === TRUE_COLOUR && !shownImage.colour ? "gray" : map;
const look = { map: colours, stretch: state.stretch, crop: own, top: brightest };
if (own === crop && answer === shown) return drawPsf(canvas, shownImage, look);
const plain = (canvases.scratch ??= document.createElement("canvas"));
drawPsf(plain, shownImage, look);
const ground = `rgb(${colour(colours === TRUE_COLOUR ? "gray" : colours, 0).join()})`;
const ratio = (own * shownImage.pixel) / field;
return drawAtScale(canvas, plain, { ratio, side: Math.max(512, own), from: axisOf(own), to: middle, ground, smooth: of.view === "fine" });
};
draw(canvases.now, state, shown, image, top);
if (old) {
draw(canvases.held, held.state, held, old, both ? (top * old.pixel ** 2) / image.pixel ** 2 : largest(old.values));
found.panels.unshift({ name: "A", canvas: canvases.held, state: held.state, shown: held });
}
const point = both ? "the brightest point of A and B, for equal light; the numbers are of each its own peak" : old ? "the brightest point of each" : "the brightest point";
const label = `${map === TRUE_COLOUR && image.colour ? "true colour, " : ""}${psf.counts ? "electrons per pixel" : `of ${point}`}${state.noise === "on" && !psf.counts ? ", without noise: that is of the sensor's pixels" : ""}`;
return { ...found, ticks: drawBar(canvases.bar, { map, stretch: state.stretch }, psf.counts ? Math.max(1, top) : 1), label };
}
function rulerOf(state, field) {
const { factor, name } = lengthUnit(state);
const step = niceStep(field * factor, 4);
return [`${short(step)}${unitAfter(name)}`, step / (field * factor)];
}
class Readout {
constructor(canvas, cells, said) {
this.text = el("output", { class: "place", hidden: true });
this.cross = el("i", { class: "cross", "aria-hidden": "true", hidden: true });
Object.assign(this, { canvas, cells: () => [cells()].flat(), said, at: null });
canvas.tabIndex = 0;
canvas.dataset.lmSuppressShortcuts = "true";
const frame = canvas.closest(".frame") ?? el("div", { class: "spot" });
if (!frame.contains(canvas)) {
canvas.replaceWith(frame);
frame.append(canvas);
}
canvas.after(this.text, this.cross);
for (const name of ["pointermove", "pointerdown"]) canvas.addEventListener(name, (event) => this.follow(event));
canvas.addEventListener("pointerleave", (event) => event.pointerType !== "touch" && this.put(null));
canvas.addEventListener("blur", () => this.put(null));
canvas.addEventListener("keydown", (event) => this.step(event));
}
follow(event) {
const box = this.canvas.getBoundingClientRect();
const share = (at, from, length, count) => Math.min(count - 1, Math.max(0, Math.floor(((at - from) / length) * count)));
this.text.setAttribute("aria-live", "off");
const [across, down = across] = this.cells();
this.put([share(event.clientX, box.left, box.width, across), share(event.clientY, box.top, box.height, down)]);
}
step(event) {
const by = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] }[event.key];
if (event.key === "Escape") return this.put(null);
if (!by) return;
event.preventDefault();
const [across, down = across] = this.cells();
const length = event.shiftKey ? Math.ceil(across / 16) : 1;
const from = this.at ?? [across, down].map((count, k) => Math.floor(count / 2) - by[k] * length);
this.text.setAttribute("aria-live", "polite");
this.put(from.map((at, k) => Math.min([across, down][k] - 1, Math.max(0, at + by[k] * length))));
}
put(at) {
this.at = at;
this.update();
}
update() {
const [across, down = across] = this.cells();
const said = this.at && this.at[0] < across && this.at[1] < down ? this.said(...this.at) : "";
this.text.hidden = this.cross.hidden = !said;
if (!said) return;
const [x, y] = this.at.map((at, k) => (100 * (at + 0.5)) / [across, down][k]);
this.text.textContent = said;
this.text.classList.toggle("below", y < 40); // away from the place itself
this.cross.style.left = `${x}%`;
this.cross.style.top = `${y}%`;
}
}
class Stage {
constructor(page, mapSide) {
this.page = page;
this.overlays = ["held", "psf"].map((name) => {
const overlay = svg("svg", { class: "rays", viewBox: "0 0 1000 1000", "aria-hidden": "true" }, svg("path"), svg("path"));
page[name].after(overlay);
return overlay;
});
this.label = el("span", { class: "of" });
this.legend = el("span", { class: "dots", hidden: true }, RAYS_SAID);
this.legend.style.setProperty("--rays", RAYS);
page.bar.parentNode.append(this.label);
page.psf.after(this.legend);
this.place = new Readout(page.psf, () => this.drawn?.crop ?? 0, (column, row) => this.value(column, row));
this.wave = new Readout(page.wavefront, () => mapSide, (column, row) =>
this.wavefront ? waveSaid(this.given.state, this.wavefront, mapSide, column, row) : "",
);
}
draw(given) {
const { page } = this;
this.given = given;
const canvases = (this.canvases ??= { now: page.psf, held: page.held, bar: page.bar });
const drawn = (this.drawn = compose(canvases, given));
const { state, shown, held } = given;
page.stage.dataset.view = state.view;
const [text, share] = rulerOf(state, drawn.field);
const [word, bar] = page.ruler.children;
word.textContent = text;
bar.style.width = `${100 * share}%`;
this.label.textContent = drawn.label;
page.selects.map.options[0].text = state.light === "white" ? "true colour" : "automatic";
const print = JSON.stringify(drawn.ticks);
if (print !== this.print) page.ticks.replaceChildren(...drawn.ticks.map(([at, word]) => el("span", { style: `left:${100 * at}%;transform:translateX(${-100 * at}%)` }, word)));
this.print = print;
const now = page.psf.parentNode.querySelector(".tag");
if (now) now.textContent = given.mode === "difference" ? "B − A" : "B";
[held?.rays, shown.rays].forEach((rays, k) => {
const there = state.rays === "on" && rays && !drawn.signed;
const path = there ? placesOfRays(rays, drawn).map(([x, y]) => `M${(1000 * x).toFixed(1)} ${(1000 * y).toFixed(1)}h0`).join("") : "";
this.overlays[k].toggleAttribute("hidden", !there);
for (const node of this.overlays[k].children) node.setAttribute("d", path);
if (k) this.legend.hidden = !there;
});
this.place.update();
}
clear() {
this.drawn = this.given = this.wavefront = undefined;
this.page.ruler.firstChild.textContent = "";
this.legend.hidden = true;
for (const overlay of this.overlays) overlay.toggleAttribute("hidden", true);
for (const readout of [this.place, this.wave]) readout.update();
}
renew(shown) {
if (this.given?.shown.psf !== shown.psf) return;
this.given.shown = shown;
this.place.update();
}
showWavefront(wavefront) {
this.wavefront = wavefront;
this.wave.update();
}
value(column, row) {
const { state, shown, held, mode } = this.given;
const middle = Math.floor(this.drawn.crop / 2);
const [across, down] = [column - middle, row - middle];
const half = shown.psf.side / 2;
if (Math.min(across, down) < -half || Math.max(across, down) >= half) return "beyond the window of B";
const said = valueSaid(state, shown.psf, shown.measures, across, down);
if (!held || mode !== "difference") return said;
return `B: ${said}`;
}
}
const PANEL = 1024;
const PADDING = 48;
const FONT = '"Helvetica Neue", Arial, "Liberation Sans", system-ui, sans-serif';
const STRETCHED = { linear: "linear scale", sqrt: "square-root scale", log: "logarithmic scale" };
const UNSAID = ["stretch", "map", "waves_unit", "length_unit", "picture", "view", "side", "rays", "light", "focus"];
function settingsSaid(state) {
const waves = wavesUnit(state);
const said = [`f/${short(state.f_number)}`, state.light === "white" ? "white light" : `${short(state.wavelength)} nm`];
for (const [key, { row }] of Object.entries(FIELDS)) {
if (UNSAID.includes(key) || ["f_number", "wavelength"].includes(key)) continue;
const value = state[key];
const hidden = row?.when?.length && !row.when.some(([name, ...values]) => values.includes(state[name]));
const plain = value === DEFAULTS[key] && !row?.waves && !row?.when?.length && key !== "pixel";
if (hidden || plain || value === 0 || value === "" || value === "off") continue;
if (key === "pixel" && state.view === "fine") continue;
if (key.endsWith("_angle") && !state[key.slice(0, -6)]) continue;
const unit = row?.waves ? waves.name : row?.unit ?? "";
const number = typeof value === "number" ? withMinus(short(value * (row?.waves ? waves.factor : 1))) : "";
said.push(key === "zernike" ? "further Zernike terms" : `${(row?.name ?? row?.label ?? key).toLowerCase()} ${unit === "°" ? `${number}°` : withUnit(number, unit)}`.trim());
}
return said.join(", ");
}
function bothSaid(...states) {
const [a, b] = states.map((state) => settingsSaid(state).split(", "));
const own = (these, others) => these.filter((one) => !others.includes(one)).join(", ") || "no other";
return `A: ${own(a, b)}. B: ${own(b, a)}. Both: ${a.filter((one) => b.includes(one)).join(", ")}.`;
}
function figureOf(given) {
const { state, shown, held, mode, name } = given;
const canvases = { now: document.createElement("canvas"), held: document.createElement("canvas"), bar: document.createElement("canvas") };
const drawn = compose(canvases, { ...given, mode: mode === "flicker" ? "beside" : mode });
const { panels } = drawn;
const whole = document.createElement("canvas");
whole.width = 2 * PADDING + panels.length * PANEL + (panels.length - 1) * PADDING;
const context = whole.getContext("2d");
const width = whole.width - 2 * PADDING;
const wrapped = (text, size, wide, weight = "") => {
context.font = `${weight} ${size}px ${FONT}`;
const lines = [""];
for (const word of text.split(" ")) {
const longer = lines.at(-1) ? `${lines.at(-1)} ${word}` : word;
if (context.measureText(longer).width > wide && lines.at(-1)) lines.push(word);
else lines[lines.length - 1] = longer;
}
return { lines, size, weight };
};
const title = wrapped(name || "Point spread function", 34, width, "bold");
const captions = panels.map((panel) => {
const numbers = numbersSaid(panel.state, panel.shown.psf, panel.shown.measures);
const values = `Strehl ratio on the axis ${numbers.strehl.text}; 80 % of the light within ${numbers.d80.text}`;
const text = panel.name === "B − A" ? bothSaid(held.state, state) : `${settingsSaid(panel.state)}. ${values}.`;
return wrapped(text, 24, PANEL);
});
const high = ({ lines, size }) => Math.ceil(lines.length * size * 1.35);
const top = PADDING + high(title) + 12 + Math.max(...captions.map(high)) + 16;
whole.height = top + PANEL + 150;
context.fillStyle = "#fff";
context.fillRect(0, 0, whole.width, whole.height);
context.textBaseline = "top";
const write = ({ lines, size, weight }, x, y, ink) => {
context.font = `${weight} ${size}px ${FONT}`;
context.fillStyle = ink;
lines.forEach((line, index) => context.fillText(line, x, y + index * size * 1.35));
};
write(title, PADDING, PADDING, "#111");
panels.forEach((panel, index) => {
const left = PADDING + index * (PANEL + PADDING);
write(captions[index], left, PADDING + high(title) + 12, "#333");
context.imageSmoothingEnabled = panel.state.view === "fine";
context.imageSmoothingQuality = "high";
context.drawImage(panel.canvas, left, top, PANEL, PANEL);
const dots = state.rays === "on" && panel.shown.rays && !drawn.signed ? placesOfRays(panel.shown.rays, drawn) : [];
for (const [x, y] of dots) dot(context, left + x * PANEL, top + y * PANEL, 3.2);
if (panel.name) label(context, panel.name, left + 16, top + 16, "bold");
const [text, share] = rulerOf(state, drawn.field);
const bottom = top + PANEL - 22;
context.fillStyle = "#000";
context.fillRect(left + 18, bottom - 8, share * PANEL + 4, 12);
context.fillStyle = "#fff";
context.fillRect(left + 20, bottom - 6, share * PANEL, 8);
label(context, text, left + 18, bottom - 54);
context.strokeStyle = "#888";
context.lineWidth = 1;
context.strokeRect(left - 0.5, top - 0.5, PANEL + 1, PANEL + 1);
});
const y = top + PANEL + 28;
context.imageSmoothingEnabled = true;
context.drawImage(canvases.bar, PADDING, y, width, 26);
context.strokeStyle = "#888";
context.strokeRect(PADDING - 0.5, y - 0.5, width + 1, 27);
context.font = `22px ${FONT}`;
context.fillStyle = "#111";
for (const [at, word] of drawn.ticks) {
const x = PADDING + at * width;
context.fillRect(Math.min(x, PADDING + width - 1), y + 26, 2, 7);
const wide = context.measureText(word).width;
context.fillText(word, Math.min(PADDING + width - wide, Math.max(PADDING, x - wide / 2)), y + 36);
}
const rays = state.rays === "on" && !drawn.signed && panels.some((panel) => panel.shown.rays);
context.fillText(`${drawn.label}, ${STRETCHED[state.stretch]}`, PADDING, y + 70);
context.textAlign = "right";
const made = "lommel";
context.fillStyle = "#666";
context.fillText(made, PADDING + width, y + 70);
if (rays) {
const right = PADDING + width - context.measureText(made).width - 40;
context.fillStyle = "#111";
context.fillText(RAYS_SAID, right, y + 70);
dot(context, right - context.measureText(RAYS_SAID).width - 16, y + 82, 7);
}
return whole;
}
function dot(context, x, y, radius) {
context.beginPath();
context.arc(x, y, radius, 0, 2 * Math.PI);
context.fillStyle = RAYS;
context.strokeStyle = "#000";
context.lineWidth = 1;
context.fill();
context.stroke();
}
function label(context, text, x, y, weight = "") {
context.font = `${weight} 26px ${FONT}`;
context.fillStyle = "rgb(0 0 0 / 65%)";
context.fillRect(x - 2, y - 4, context.measureText(text).width + 18, 38);
context.fillStyle = "#fff";
context.fillText(text, x + 7, y + 2);
}
function saveBlob(blob, name) {
const link = document.createElement("a");
link.href = URL.createObjectURL(blob);
link.download = name;
link.click();
setTimeout(() => URL.revokeObjectURL(link.href), 10000);
}
const ascii = (text) => new TextEncoder().encode(text);
async function withText(blob, keyword, text) {
const data = new Uint8Array(await blob.arrayBuffer());
const body = ascii(`tEXt${keyword}\0${text}`);
const piece = new Uint8Array(body.length + 8);
const view = new DataView(piece.buffer);
view.setUint32(0, body.length - 4);
piece.set(body, 4);
view.setUint32(body.length + 4, crc32(body));
const head = 33; // signature and IHDR
return new Blob([data.slice(0, head), piece, data.slice(head)], { type: "image/png" });
}
function savePng(given) {
figureOf(given).toBlob(async (blob) => saveBlob(await withText(blob, "Description", toText(given.state) || "defaults"), "lommel-psf.png"));
}
const MTF_PLACES = 6;
const HEADS = {
profile: ["radius (um)", "profile", "profile unaberrated"],
energy: ["radius (um)", "encircled energy", "encircled energy unaberrated"],
mtf: ["frequency (cycles/mm)", "MTF x", "MTF y", "MTF diffraction limit", "MTF x with pixel", "MTF y with pixel"],
};
function csvText(state, { psf, measures }) {
const numbers = numbersSaid(state, psf, measures);
const number = (key) => numbers[key].text.replace(/ %$/, "");
const { strehl: error } = errorsOf(psf, measures);
const said = [
"# lommel live",
...Object.keys(FIELDS).map((key) => `# ${key}=${state[key]}${state[key] === DEFAULTS[key] ? "" : " *"}`),
`# strehl_on_axis=${number("strehl")}`,
`# largest_value=${number("largest")}`,
`# diameter_80_percent_about_centroid_um=${measures.d80 === null ? "" : short(measures.d80)}`,
`# diameter_80_percent_about_axis_um=${measures.d80_axis === null ? "" : short(measures.d80_axis)}`,
`# light_in_window_percent=${number("inside")}`,
`# proven_error_over_peak=${psf.bound === null ? "" : stated(psf.bound, 0, 2)}`,
`# proven_error_of_profile_and_energy=${measures.strehl_error === null ? "" : stated(error, 0, 2)}`,
];
const places = (values, digits) => Array.from(values ?? [], (value) => (Number.isNaN(value) ? "" : Math.max(0, Number(value.toFixed(digits)))));
const proven = (values) => places(values, Math.min(12, Math.max(0, Math.floor(-Math.log10(error || 1e-12)))));
const lengths = (values) => Array.from(values ?? [], (value) => Number(value.toPrecision(8)));
const columns = Object.entries(HEADS).flatMap(([name, heads]) => {
const { r, f, mean, reference, share, ...mtf } = measures[name];
const circles = [lengths(r), proven(mean ?? share), proven(reference)];
const known = (values) => places(values, mtf.error > 0 ? Math.floor(-Math.log10(mtf.error)) : MTF_PLACES);
const parts = name === "mtf" ? [lengths(f), ...[mtf.x, mtf.y, mtf.limit, mtf.pixel_x, mtf.pixel_y].map(known)] : circles;
return heads.map((head, index) => [head, parts[index]]);
});
const rows = Math.max(...columns.map(([, values]) => values.length));
const lines = [columns.map(([head]) => head).join(",")];
for (let i = 0; i < rows; i++) lines.push(columns.map(([, values]) => values[i] ?? "").join(","));
return [...said, ...lines, ""].join("\r\n");
}
function saveCsv({ state, shown }) {
saveBlob(new Blob([csvText(state, shown)], { type: "text/csv" }), "lommel-curves.csv");
}
const escaped = (text) => text.replace(/[&<>"]/g, (c) => ({ "&": "&amp;", "<": "&lt;", ">": "&gt;", '"': "&quot;" })[c]);
function tiffBytes(state, psf) {
const { values, side, pixel } = psf;
const size = `PhysicalSizeX="${pixel}" PhysicalSizeXUnit="µm" PhysicalSizeY="${pixel}" PhysicalSizeYUnit="µm"`;
const space = "http://www.openmicroscopy.org/Schemas/OME/2016-06";
const text = ascii(
`<?xml version="1.0" encoding="UTF-8"?><OME xmlns="${space}" xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" ` +
`xsi:schemaLocation="${space} ${space}/ome.xsd" Creator="lommel live"><Image ID="Image:0" Name="point spread function">` +
`<Description>${escaped(describedPsf(state, psf))}</Description>` +
`<Pixels ID="Pixels:0" DimensionOrder="XYCZT" Type="float" SizeX="${side}" SizeY="${side}" ` +
`SizeC="1" SizeZ="1" SizeT="1" ${size}><Channel ID="Channel:0:0" SamplesPerPixel="1">` +
`<LightPath/></Channel><TiffData IFD="0" PlaneCount="1"/></Pixels></Image></OME>\0`,
);
const SHORT = 3;
const LONG = 4;
const fields = [
[256, LONG, 1, side],
[257, LONG, 1, side],
[258, SHORT, 1, 32],
[259, SHORT, 1, 1],
[262, SHORT, 1, 1],
[270, 2, text.length, 0],
[273, LONG, 1, 0],
[277, SHORT, 1, 1],
[278, LONG, 1, side],
[279, LONG, 1, 4 * side * side],
[339, SHORT, 1, 3],
];
const textAt = 8 + 2 + 12 * fields.length + 4;
const valuesAt = 16 * Math.ceil((textAt + text.length) / 16);
const file = new Uint8Array(valuesAt + 4 * side * side);
const view = new DataView(file.buffer);
file.set([0x49, 0x49, 42, 0, 8, 0, 0, 0, fields.length, 0]);
fields.forEach(([tag, kind, count, value], index) => {
const at = 10 + 12 * index;
view.setUint16(at, tag, true);
view.setUint16(at + 2, kind, true);
view.setUint32(at + 4, count, true);
view.setUint32(at + 8, { 270: textAt, 273: valuesAt }[tag] ?? value, true);
});
file.set(text, textAt);
for (let i = 0; i < values.length; i++) view.setFloat32(valuesAt + 4 * i, values[i], true);
return file;
}
function saveTiff({ state, shown }) {
saveBlob(new Blob([tiffBytes(state, shown.psf)], { type: "image/tiff" }), "lommel-psf.tif");
}
const WIDTH = 384;
const HEIGHT = 288;
const PICTURES = {
star: "Siemens star",
bars: "Bars",
text: "Text",
points: "Stars at night",
own: "Own picture …",
};
const drawn = new Map();
function testPicture(name) {
if (!drawn.has(name)) {
const draw = { star, bars, text, points }[name] ?? star;
drawn.set(name, { planes: draw(), width: WIDTH, height: HEIGHT, count: 1 });
}
return drawn.get(name);
}
function sampled(at) {
const plane = new Float32Array(WIDTH * HEIGHT);
const off = [-1 / 3, 0, 1 / 3];
for (let y = 0, i = 0; y < HEIGHT; y++)
for (let x = 0; x < WIDTH; x++, i++) {
let sum = 0;
for (const dy of off) for (const dx of off) sum += at(x + 0.5 + dx, y + 0.5 + dy);
plane[i] = sum / 9;
}
return plane;
}
const STAR = { spokes: 36, radius: 136, middle: [WIDTH / 2, HEIGHT / 2] };
function star() {
return sampled((x, y) => {
const dx = x - WIDTH / 2;
const dy = y - HEIGHT / 2;
const r = Math.hypot(dx, dy);
if (r > STAR.radius) return 0.75;
return r < 3 ? 0.4 : Math.sin(STAR.spokes * Math.atan2(dy, dx)) > 0 ? 0.92 : 0.03;
});
}
function bars() {
const groups = [];
let x = 14;
for (let width = 11.3; width > 0.95; width /= Math.SQRT2) {
groups.push([x, width]);
x += 5 * width + 14;
}
return sampled((px, py) => {
if (py > 196) return px < 150 + (py - 240) * 0.09 ? 0.03 : 0.92;
for (const [left, width] of groups) {
const along = (px - left) / width;
if (along < 0 || along > 5) continue;
if (py > 24 && py < 94) return along % 2 < 1 ? 0.03 : 0.92;
const down = (py - 110) / width;
if (down > 0 && down < 5) return down % 2 < 1 ? 0.03 : 0.92;
}
return 0.92;
});
}
function text() {
const lines = [
[46, "light is never"],
[36, "a point: it spreads"],
[26, "by lambda times N, and by"],
[20, "what the wavefront lacks to be a"],
[15, "sphere. 0123456789 αβγ"],
[10, "the smallest letters are five pixels high"],
];
const context = scratch(WIDTH, HEIGHT);
context.fillStyle = "#f4f4f4";
context.fillRect(0, 0, WIDTH, HEIGHT);
context.fillStyle = "#111";
context.textBaseline = "top";
let y = 16;
for (const [size, line] of lines) {
context.font = `${size}px Georgia, "Times New Roman", serif`;
context.fillText(line, 16, y);
y += size * 1.3 + 9;
}
return linear(context.getImageData(0, 0, WIDTH, HEIGHT).data, 1);
}
function points() {
const plane = new Float32Array(WIDTH * HEIGHT).fill(0.0015);
let seed = 20;
const random = () => (seed = (seed * 16807) % 2147483647) / 2147483647;
for (let k = 1; k <= 90; k++) plane[Math.floor(random() * HEIGHT) * WIDTH + Math.floor(random() * WIDTH)] += 120 / k ** 1.2;
return plane;
}
function scratch(width, height) {
const canvas = document.createElement("canvas");
canvas.width = width;
canvas.height = height;
return canvas.getContext("2d", { willReadFrequently: true });
}
const LINEAR = Float32Array.from({ length: 256 }, (_, i) => (i <= 10 ? i / 255 / 12.92 : ((i / 255 + 0.055) / 1.055) ** 2.4));
function linear(data, count) {
const size = data.length / 4;
const planes = new Float32Array(size * count);
for (let plane = 0; plane < count; plane++)
for (let i = 0; i < size; i++) planes[plane * size + i] = LINEAR[data[4 * i + plane]];
return planes;
}
const MOST = 480_000; // pixels that are blurred and drawn while something is dragged
async function ownPicture(file) {
const bitmap = await createImageBitmap(file).catch(() => {
throw new Error(`${file.name || "This file"} is not a picture that the browser reads.`);
});
const scale = Math.min(1, Math.sqrt(MOST / (bitmap.width * bitmap.height)));
const width = Math.max(8, Math.round(bitmap.width * scale));
const height = Math.max(8, Math.round(bitmap.height * scale));
const context = scratch(width, height);
context.imageSmoothingQuality = "high";
context.drawImage(bitmap, 0, 0, width, height);
bitmap.close();
const data = context.getImageData(0, 0, width, height).data;
let grey = true;
for (let i = 0; i < data.length && grey; i += 4) grey = data[i] === data[i + 1] && data[i] === data[i + 2];
const count = grey ? 1 : 3;
return { planes: linear(data, count), width, height, count, reduced: 1 / scale };
}
const DEEPEST = 20;
const ESCAPES = { b: "\b", t: "\t", n: "\n", f: "\f", r: "\r", '"': '"', "\\": "\\" };
const DECIMAL = /[+-]?(?:inf|nan|(?:0|[1-9](?:_?\d)*)(?:\.\d(?:_?\d)*)?(?:[eE][+-]?\d(?:_?\d)*)?)(?![\w.:-])/y;
const BARE = /[\w-]+/y;
function parseToml(text) {
const root = Object.create(null);
const lines = new Map();
const closed = new Set(); // tables that nothing may add to: inline ones, and those that had their header
let at = 0;
let counted = { place: 0, line: 1 }; // lines up to a place, so that a long file is gone through once
const lineAt = (place) => {
if (place < counted.place) counted = { place: 0, line: 1 };
const line = counted.line + text.slice(counted.place, place).split("\n").length - 1;
counted = { place, line };
return line;
};
const fail = (what, place = at) => {
throw new Error(`line ${lineAt(place)}: ${what}`);
};
const brief = (place) => JSON.stringify(text.slice(place, place + 30).split("\n")[0]);
const match = (pattern) => {
pattern.lastIndex = at;
const found = pattern.exec(text);
if (found) at += found[0].length;
return found?.[0];
};
const take = (word) => text.startsWith(word, at) && Boolean((at += word.length));
const blank = () => match(/[ \t]*(?:#[^\n]*)?/y);
const blanks = () => match(/(?:\s|#[^\n]*)*/y);
const expect = (word) => take(word) || fail(`${JSON.stringify(word)} is missing before ${brief(at)}`);
function string() {
const begin = at;
const mark = text[at];
const long = text.startsWith(mark.repeat(3), at);
const end = mark.repeat(long ? 3 : 1);
at += end.length;
if (long) match(/\n/y);
let made = "";
for (;;) {
if (at >= text.length || (!long && text[at] === "\n")) fail("a text has no closing quote", begin);
if (take(end)) {
while (long && text[at] === mark) made += text[at++];
return made;
}
if (mark === "'" || text[at] !== "\\") made += text[at++];
else {
at++;
if (long && match(/[ \t]*\n\s*/y)) continue;
const kind = text[at++];
const size = { u: 4, U: 8 }[kind];
const code = size && match(size === 4 ? /[\da-fA-F]{4}/y : /[\da-fA-F]{8}/y);
if (code && parseInt(code, 16) <= 0x10ffff) made += String.fromCodePoint(parseInt(code, 16));
else made += ESCAPES[kind] ?? fail(`\\${kind} is not an escape of TOML`);
}
}
}
function keys() {
const found = [];
do {
match(/[ \t]*/y);
found.push(/["']/.test(text[at] ?? "") ? string() : match(BARE) ?? fail(`a key is missing before ${brief(at)}`));
match(/[ \t]*/y);
} while (take("."));
return found;
}
function inside(table, path, place) {
for (const [index, key] of path.entries()) {
table[key] ??= Object.create(null);
if (table[key] === null || typeof table[key] !== "object" || Array.isArray(table[key]))
fail(`${path.slice(0, index + 1).join(".")} has a value and is no table`, place);
table = table[key];
}
return table;
}
function assign(table, above, depth) {
const place = at;
const path = keys();
expect("=");
match(/[ \t]*/y);
const last = path.at(-1);
const home = inside(table, path.slice(0, -1), place);
if (closed.has(home) && home !== table) fail(`${path.join(".")} adds to a table that is complete`, place);
if (last in home) fail(`${last} is given twice`, place);
const whole = [...above, ...path];
for (let count = above.length + 1; count <= whole.length; count++) {
const name = whole.slice(0, count).join(".");
if (!lines.has(name)) lines.set(name, lineAt(place));
}
home[last] = value(whole, depth);
}
function value(path, depth) {
if (depth > DEEPEST) fail("brackets are nested too deeply");
if (/["']/.test(text[at] ?? "")) return string();
if (take("[")) {
const list = [];
for (blanks(); !take("]"); blanks()) {
list.push(value(path, depth + 1));
blanks();
if (!take(",") && text[at] !== "]") fail(`a comma or "]" is missing before ${brief(at)}`);
}
return list;
}
if (take("{")) {
const table = Object.create(null);
for (match(/[ \t]*/y); !take("}"); match(/[ \t]*/y)) {
assign(table, path, depth + 1);
match(/[ \t]*/y);
if (!take(",") && text[at] !== "}") fail(`a comma or "}" is missing before ${brief(at)}`);
}
closed.add(table);
return table;
}
const plain = match(/(?:true|false)(?![\w-])/y);
if (plain) return plain === "true";
const number = match(DECIMAL) ?? fail(`${brief(at)} is not a text in quotes, a decimal number, true, false, a list or a table`);
const bare = number.replace(/_/g, "").replace("inf", "Infinity");
return Number(bare);
}
const grown = new Set(); // arrays of tables
function newTables() {
const tables = [];
grown.add(tables);
return tables;
}
text = text.replace(/^\ufeff/, "").replace(/\r\n?/g, "\n");
let here = root;
let above = [];
for (blanks(); at < text.length; blanks()) {
const place = at;
if (take("[[")) {
above = keys();
expect("]");
expect("]");
const home = inside(root, above.slice(0, -1), place);
const tables = (home[above.at(-1)] ??= newTables());
if (!grown.has(tables)) fail(`${above.join(".")} has a value and is no array of tables`, place);
tables.push((here = Object.create(null)));
lines.set(above.join("."), lineAt(place));
} else if (take("[")) {
above = keys();
expect("]");
here = inside(root, above, place);
if (closed.has(here)) fail(`the table [${above.join(".")}] is given twice`, place);
closed.add(here);
lines.set(above.join("."), lineAt(place));
} else assign(here, above, 0);
blank();
if (at < text.length && text[at] !== "\n") fail(`only one entry may stand in a line, got ${brief(at)} behind it`);
}
return { root, lines };
}
const POWERS = { m: 0, metres: 0, km: 3, cm: -2, mm: -3, um: -6, µm: -6, μm: -6, nm: -9, pm: -12, angstrom: -10 };
const INCHES = { in: 25.4e-3, inch: 25.4e-3 };
const QUANTITY = /^\s*([+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?|[+-]?inf(?:inity)?)\s*(\S*)\s*$/;
const shownValue = (value) => String(JSON.stringify(value) ?? value).slice(0, 60);
function metresOf(value) {
const found = QUANTITY.exec(typeof value === "number" ? String(value).replace("Infinity", "inf") : typeof value === "string" ? value : "");
if (!found) throw new Error(`must be a length with a unit, such as "550 nm", got ${shownValue(value)}`);
const [, digits, unit] = found;
if (/inf/.test(digits)) return digits[0] === "-" ? -Infinity : Infinity;
if (!unit && Number(digits) === 0) return 0;
if (Object.hasOwn(INCHES, unit)) return Number(digits) * INCHES[unit];
if (!Object.hasOwn(POWERS, unit) || unit === "metres")
throw new Error(`must have a unit, one of km, m, cm, mm, um, nm, pm, angstrom, in, got ${shownValue(value)}`);
const [mantissa, power = 0] = digits.toLowerCase().split("e");
return Number(`${mantissa}e${Number(power) + POWERS[unit]}`); // the nearest to the decimal
}
const ORDERS = ["nm", "noll", "ansi", "fringe"];
const FRINGE = [];
for (let group = 0; group < 6; group++)
for (let m = group; m >= 0; m--) FRINGE.push([2 * group - m, m], ...(m ? [[2 * group - m, -m]] : []));
FRINGE.push([12, 0]);
const MOST_DEGREE = 60;
function termOf(text, order) {
const refuse = (why) => {
throw new Error(`there is no Zernike term ${shownValue(text)} in the order ${order}: ${why}`);
};
let [n, m] = [0, 0];
if (order === "nm") {
const pair = /^\s*\(?\s*([+-]?\d+)\s*,\s*([+-]?\d+)\s*\)?\s*$/.exec(text) ?? refuse('it is written "n,m"');
[n, m] = [Number(pair[1]), Number(pair[2])];
if (Math.abs(m) > n || (n - m) % 2) refuse("m must be from -n to n, and n - m even");
} else {
const first = order === "ansi" ? 0 : 1;
if (!/^\s*\+?\d+\s*$/.test(text) || Number(text) < first) refuse(`it is a whole number from ${first}`);
const j = Number(text);
if (order === "fringe") return FRINGE[j - 1] ?? refuse("it ends with 37");
n = Math.floor((Math.sqrt(8 * (j - first) + 1) - 1) / 2);
const place = j - first - (n * (n + 1)) / 2; // from 0 within the degree
if (order === "ansi") m = 2 * place - n;
else m = (n % 2 ? 2 * Math.floor(place / 2) + 1 : 2 * Math.floor((place + 1) / 2)) * (j % 2 ? -1 : 1);
}
if (n > MOST_DEGREE) refuse(`n must be at most ${MOST_DEGREE}`);
return [n, m || 0];
}
const edgeOf = ([n, m], normalization) => (normalization === "rms" ? Math.sqrt((n + 1) * (m ? 2 : 1)) : 1);
const UNIT_NAMES = {
wave: "waves", rad: "radians", radian: "radians", meter: "m", meters: "m", micron: "um", microns: "um", micrometer: "um",
micrometers: "um", nanometer: "nm", nanometers: "nm", millimeters: "mm",
};
const UNITS_OF_TABLES = ["radians", "waves", ...Object.keys(POWERS), ...Object.keys(INCHES)];
const EXAMPLES = { order: "noll", unit: "waves", normalization: "rms" };
const ALLOWED = { order: ORDERS, unit: UNITS_OF_TABLES, normalization: ["rms", "edge"] };
function builtTable(settings, terms, where, faults) {
for (const key of Object.keys(settings))
if (!Object.hasOwn(ALLOWED, key) && key !== "wavelength")
faults.push(`${where(key)}: unknown key; there are order, unit, normalization, wavelength and terms`);
for (const [key, choices] of Object.entries(ALLOWED)) {
const got = settings[key];
if (got === undefined) faults.push(`${where(key)}: is missing; it is one of ${choices.join(", ").replace("nm, noll", "nm (n and m), noll")}`);
else if (!choices.includes(got)) faults.push(`${where(key)}: must be one of ${choices.join(", ")}, got ${shownValue(got)}`);
}
let wavelength = null;
if (settings.wavelength !== undefined)
try {
wavelength = checkedWavelength(metresOf(settings.wavelength));
} catch (error) {
faults.push(`${where("wavelength")}: ${error.message}`);
}
const seen = new Map();
if (!terms.length) faults.push(`${where("terms")}: is missing or empty; it has the coefficients by index`);
if (ORDERS.includes(settings.order))
for (const [index, value, place] of terms)
try {
const term = termOf(String(index), settings.order);
if (typeof value !== "number" || !Number.isFinite(value)) throw new Error(`must be a finite number, got ${shownValue(value)}`);
if (seen.has(term.join())) throw new Error(`the term ${index} is given twice`);
seen.set(term.join(), [...term, value * edgeOf(term, settings.normalization)]);
} catch (error) {
faults.push(`${place}: ${error.message}`);
}
return { terms: [...seen.values()], unit: settings.unit, wavelength };
}
function checkedWavelength(metres) {
if (!(metres >= 1e-12 && metres <= 1e-2)) throw new Error(`must be a wavelength from 1e-12 m to 1e-2 m, got ${metres} m`);
return metres;
}
function wavesOf({ terms, unit, wavelength }, at) {
const one = { waves: (wavelength ?? at) / at, radians: (wavelength ?? at) / at / (2 * Math.PI) };
const length = Object.hasOwn(INCHES, unit) ? INCHES[unit] : Number(`1e${POWERS[unit]}`);
const factor = one[unit] ?? length / at;
return terms.map(([n, m, value]) => [n, m, value * factor]);
}
function sectionTable(section, where, faults) {
const { terms = {}, ...settings } = section;
const entries = terms !== null && typeof terms === "object" && !Array.isArray(terms) ? Object.entries(terms) : [];
return builtTable(settings, entries.map(([index, value]) => [index, value, where(`terms.${index}`)]), where, faults);
}
const numberOf = (text) => {
const plain = text.trim().split(",").length === 2 && !text.includes(".") ? text.trim().replace(",", ".") : text.trim();
return /^[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?$/.test(plain) ? Number(plain) : plain;
};
function csvTable(text, faults) {
const settings = {};
const lines = {};
const rows = [];
const written = text.split("\n");
const first = written.find((line) => line.trim() && !line.trim().startsWith("#")) ?? "";
const between = first.includes(",") ? "," : first.includes(";") ? ";" : first.includes("\t") ? "\t" : /\s+/;
written.forEach((line, index) => {
const plain = line.trim();
const stated = /^#\s*(.*?)\s*:\s*(.*)$/.exec(plain);
if (stated) [settings[stated[1]], lines[stated[1]]] = [stated[2], index + 1];
else if (plain && !plain.startsWith("#"))
rows.push([index + 1, plain.split(between).map((cell) => cell.trim().replace(/^"(.*)"$/, "$1"))]);
});
if (settings.unit) settings.unit = UNIT_NAMES[settings.unit.toLowerCase()] ?? settings.unit;
const [place, head] = rows.shift() ?? [0, []];
const numbered = (name) => /^z\s*_?(\d+)$/i.exec(name)?.[1];
let names = head.map((name) => name.toLowerCase());
if (names.length && names.every(numbered)) {
if (rows.length !== 1 || rows[0][1].length !== names.length) faults.push(`line ${place}: below Z1, Z2, ... there must be one row of as many values`);
const [at, cells] = rows.shift() ?? [place, []];
rows.splice(0, rows.length, ...names.map((name, k) => [at, [name, cells[k] ?? ""]]));
names = ["index", "value"];
}
const kept = names.map((name, k) => [name, k]).filter(([name]) => !["name", "aberration", "description"].includes(name));
const columns = kept.map(([name]) => name);
const value = /^(value|coefficient|coeff|c)\s*(?:[([]\s*(\S+?)\s*[)\]])?$/.exec(columns.pop() ?? "");
const state = (key, got) => {
if (settings[key] !== undefined && settings[key] !== got) faults.push(`line ${place}: the columns say the ${key} ${got}, line ${lines[key]} ${settings[key]}`);
settings[key] ??= got;
};
const single = ["index", "term", "j", "zernike", ...ORDERS.slice(1)];
if (!value || !(columns.join() === "n,m" || (columns.length === 1 && single.includes(columns[0])))) {
faults.push(`line ${place}: the columns must be "n,m,value" or "index,value", got ${shownValue(head.join(","))}`);
return builtTable(settings, [["1", 0, ""]], (key) => key, []);
}
if (columns.length === 2) state("order", "nm");
else if (ORDERS.includes(columns[0])) state("order", columns[0]);
if (value[2]) state("unit", UNIT_NAMES[value[2]] ?? value[2]);
const terms = [];
for (const [at, cells] of rows) {
if (cells.length !== names.length) faults.push(`line ${at}: must have ${names.length} cells, got ${cells.length}`);
else {
const picked = kept.map(([, k]) => cells[k]);
const number = picked.pop();
terms.push([numbered(picked[0]) ?? picked.join(","), numberOf(number), `line ${at}`]);
}
}
return builtTable(settings, terms, (key) => (lines[key] ? `${key} (line ${lines[key]})` : EXAMPLES[key] ? `the line "# ${key}: ${EXAMPLES[key]}"` : key), faults);
}
function listingTable(text, faults) {
const kinds = new Set([...text.matchAll(/^\s*(?:Listing of|Using)\b.*?\b(Standard|Fringe|Annular)\b/gim)].map(([, kind]) => kind.toLowerCase()));
const [kind] = kinds;
if (kinds.size !== 1) faults.push("the terms must be Standard or Fringe, which the line 'Listing of Zernike ...' states");
else if (kind === "annular") faults.push("annular terms are not read here; lommel.load_zernike reads them, and saves them as a table");
if (!/^\s*(?:Peak to Valley|RMS|Maximum fit)\b.*?:\s*[\d.,eE+-]+\s+waves\s*$/m.test(text))
faults.push("the unit is not stated; listings have 'Peak to Valley ... waves'");
const settings = { order: kind === "fringe" ? "fringe" : "noll", unit: "waves", normalization: kind === "fringe" ? "edge" : "rms" };
const stated = /^\s*Wavelength\s*:\s*([\d.,]+)\s*(\S+)\s*$/m.exec(text);
if (stated) settings.wavelength = `${numberOf(stated[1])} ${stated[2]}`;
const terms = [];
text.split("\n").forEach((line, index) => {
const entry = /^\s*Z\s*(\d{1,4})\s*[:=]?\s*([+-]?[\d.,]+(?:[eE][+-]?\d+)?)\s*(?::.*)?$/.exec(line);
if (entry) terms.push([entry[1], numberOf(entry[2]), `line ${index + 1}`]);
else if (/^\s*Z\s*\d/.test(line)) faults.push(`line ${index + 1}: a term must have a number and a value, got ${shownValue(line.trim())}`);
});
return builtTable(settings, terms, (key) => key, faults);
}
function codeVTable(text, faults) {
const [title, sizes = "", ...rest] = text.split("\n").filter((line) => line.trim() && !line.trim().startsWith("!"));
const words = sizes.trim().toUpperCase().split(/\s+/);
const after = (name) => (words.includes(name) ? Number((words[words.indexOf(name) + 1] ?? "").replace("D", "E")) : NaN);
const [wave, one] = [after("WVL"), after("SSZ")];
const values = rest.flatMap((line) => line.trim().split(/\s+/)).map((word) => Number(word.replace(/d/i, "e")));
if (!title || !["ZRN", "ZFR"].includes(words[0]) || !words.includes("WFR"))
faults.push("the second line must begin with ZRN or ZFR and have WFR: Zernike terms of a wavefront");
else if (!(wave > 0 && one > 0)) faults.push("the second line must have WVL and SSZ, the wavelength in um and the value of one wave");
else if (values.length !== Number(words[1])) faults.push(`the second line says ${words[1]} values, got ${values.length}`);
if (values.includes(after("NDA"))) faults.push(`the term ${values.indexOf(after("NDA")) + 1} has no value (NDA)`);
const fringe = words[0] === "ZFR";
const index = (j) => {
const n = Math.floor((Math.sqrt(8 * j + 1) - 1) / 2); // by n, from cos(n theta) to sin(n theta)
return `${n},${n - 2 * (j - (n * (n + 1)) / 2)}`;
};
const terms = values.map((value, j) => [fringe ? String(j + 1) : index(j), value / one, `the term ${j + 1}`]);
const settings = { order: fringe ? "fringe" : "nm", unit: "waves", normalization: "edge", wavelength: `${wave} um` };
return builtTable(settings, terms, (key) => key, faults);
}
const MOST_BYTES = 1e6;
const MOST_FAULTS = 4;
const inWords = (value) => String(JSON.stringify(value) ?? value).slice(0, 60);
const refuse = (wanted, value) => {
throw new Error(`must be ${wanted}, got ${inWords(value)}`);
};
const real = (value) => (typeof value === "number" && Number.isFinite(value) ? value : refuse("a number", value));
const bounded = (from, to, open = false) => (value) =>
real(value) >= from && value <= to && !(open && value === to) ? value : refuse(`from ${from} to ${open ? "below " : ""}${to}`, value);
const positive = (value) => (real(value) > 0 ? value : refuse("a positive number", value));
const signed = (value) => (Number.isFinite(metresOf(value)) ? metresOf(value) : refuse("a finite length", value));
const distance = (value) => (metresOf(value) > 0 ? metresOf(value) : refuse("a positive length", value));
const extent = (value) => (distance(value) < Infinity ? metresOf(value) : refuse("a finite length", value));
const whole = (from, to) => (value) =>
Number.isInteger(value) && value >= from && value <= to ? value : refuse(`a whole number from ${from} to ${to}`, value);
const list = (each, least, most) => (value) =>
Array.isArray(value) && value.length >= least && value.length <= most ? value.map(each) : refuse(`a list of ${least} to ${most}`, value);
const word = (...choices) => (value) => (choices.includes(value) ? value : refuse(`one of ${choices.join(", ")}`, value));
const words = (value) => (typeof value === "string" ? value : refuse("a text in quotes", value));
const truth = (value) => (typeof value === "boolean" ? value : refuse("true or false", value));
const anything = (value) => value;
const ANGLES = { rad: 1, mrad: 1e-3, deg: Math.PI / 180, arcmin: Math.PI / 10800, arcsec: Math.PI / 648000, mas: Math.PI / 648e6 };
const ANGLE = /^\s*([+-]?[\d.]+(?:[eE][+-]?\d+)?)\s*(rad|mrad|deg|arcmin|arcsec|mas)\s*$/;
const TWO_TURNS = 4 * Math.PI + 1e-9; // larger numbers are probably degrees
function angle(value) {
const found = typeof value === "number" ? [value, value, "rad"] : ANGLE.exec(value);
if (!found) return refuse('an angle, a number of radians or a text such as "45 deg"', value);
const radians = real(Number(found[1]) * ANGLES[found[2]]);
return Math.abs(radians) <= TWO_TURNS ? radians : refuse('within two turns: radians, or a text such as "45 deg"', value);
}
const pitch = (value) => {
const sides = Array.isArray(value) ? list(extent, 2, 2)(value) : [extent(value)];
if (sides[0] > 0.1) refuse("at most 0.1 m", value);
return sides.every((side) => side === sides[0]) ? sides[0] : refuse("one length on this page, whose pixels are square", value);
};
const plainFill = (value) => (inWords(value) === "1" || inWords(value) === "[1,1]" ? 1 : refuse("1 on this page, whose pixels are active all over", value));
const named = (text) => Object.fromEntries(text.split(" ").map((key) => [key, anything]));
const SECTIONS = {
name: words,
source: words,
lens: {
focal_length: extent,
f_number: (value) => (real(value) >= 0.5 ? value : refuse("at least 0.5, the limit in air", value)),
aperture_diameter: extent,
focus_distance: distance,
sensor_distance: extent,
wavelength: (value) => checkedWavelength(metresOf(value)),
obscuration: bounded(0, 1, true),
model: word("paraxial", "aplanatic"),
corrected_for: word("object", "focus"),
apodization: (value) => (value === "aplanatic" || Array.isArray(value) ? value : bounded(0, 100)(value)),
},
aperture: {
spider: { width: extent, vanes: whole(1, 64), first: angle, angles: list(angle, 1, 64) },
ellipse: named("a b angle"),
cat_eye: named("shift radius"),
mask: named("holds file"),
telescope: words,
segments: named("rings gap middle angle piston tip tilt file"),
clear: anything,
blocked: anything,
},
aberrations: {
...Object.fromEntries("defocus spherical W020 W040 W060 W080 W131 W222 W220 W311".split(" ").map((key) => [key, real])),
spherical_rms: signed,
field: list(real, 2, 2),
zernike: anything,
},
object: { distance },
sensor: { pixel: pitch, shape: anything, integrate: truth, fill: plainFill },
field: {
...named("sensor edge order unit normalization direction columns rows file W131 W222 W220 W311"),
vignetting: named("height shift radius"),
shading: named("distance height light"),
},
colour: named("wavelengths focus_shift lateral heights"),
channels: named("wavelengths weights filters illuminant tol paths file"),
report: named("encircled_energy"),
};
const REQUIRED = ["lens.focal_length", "lens.wavelength", "sensor.pixel"];
function checkedSection(raw, schema, path, where, faults) {
const found = {};
for (const [key, value] of Object.entries(raw)) {
const name = path ? `${path}.${key}` : key;
const check = Object.hasOwn(schema, key) ? schema[key] : null;
const home = Object.keys(SECTIONS).find((section) => typeof SECTIONS[section] === "object" && Object.hasOwn(SECTIONS[section], key));
try {
if (!check) throw new Error(`unknown key; ${home ? `it is in [${home}]` : `there are ${Object.keys(schema).join(", ")}`}`);
if (typeof check === "function") found[key] = check(value);
else if (value === null || typeof value !== "object" || Array.isArray(value)) throw new Error(`must be a section, [${name}]`);
else found[key] = checkedSection(value, check, name, where, faults);
} catch (error) {
faults.push(`${where(name)}: ${error.message}`);
}
}
return found;
}
class Terms extends Map {
plus(n, m, value) {
this.set(`${n},${m}`, (this.get(`${n},${m}`) ?? 0) + value);
}
power(k, value) {
for (let j = 1, share = (3 * k) / ((k + 1) * (k + 2)); j <= k; j++) {
this.plus(2 * j, 0, value * share);
share *= ((2 * j + 3) / (2 * j + 1)) * ((k - j) / (k + j + 2));
}
}
seidel({ W020 = 0, W040 = 0, W060 = 0, W080 = 0, W131 = 0, W222 = 0, W220 = 0, W311 = 0, field: [x, y] = [1, 0] }) {
const square = x * x + y * y;
[W020 + (W220 + 0.5 * W222) * square, W040, W060, W080].forEach((w, index) => this.power(index + 1, w));
const tilt = (2 / 3) * W131 + W311 * square;
for (const [n, a, b, c] of [[1, tilt * x, tilt * y, 1], [3, (W131 / 3) * x, (W131 / 3) * y, 1], [2, 0.5 * W222 * (x * x - y * y), W222 * x * y, 2]]) {
this.plus(n, c, a);
this.plus(n, -c, b);
}
}
}
function addAplanatic(terms, radius, sphere, vergence, wavelength) {
if (!(radius * Math.abs(sphere) < 1 && radius ** 2 * 2 * Math.abs((sphere + vergence) * vergence) < 1))
throw new Error("lens.model: aplanatic is not possible with this aperture and these distances");
const path = (t) => {
const p = (radius ** 2 * t) / (1 + Math.sqrt(1 - sphere ** 2 * radius ** 2 * t));
return (2 * p * vergence) / (1 + Math.sqrt(1 + 2 * p * (sphere + vergence) * vergence)) / wavelength;
};
const count = 96;
const sums = new Float64Array(31);
for (let i = 0; i < count; i++) {
const theta = (Math.PI * (i + 0.5)) / count;
let weight = 1;
for (let k = 1; k < count / 2; k++) weight -= (2 * Math.cos(2 * k * theta)) / (4 * k * k - 1);
const x = Math.cos(theta);
const value = (weight / count) * path(0.5 + 0.5 * x);
let [before, here] = [0, 1];
for (let j = 0; j <= 30; j++) {
sums[j] += (2 * j + 1) * value * here;
[before, here] = [here, ((2 * j + 1) * x * here - j * before) / (j + 1)];
}
}
const size = sums.reduce((all, c) => all + Math.abs(c), 0);
for (let j = 1; j <= 30; j++) if (Math.abs(sums[j]) > 1e-13 * size) terms.plus(2 * j, 0, sums[j]);
}
function lensOf(raw, where, faults, opened) {
const { name, source = "", lens = {}, aperture = {}, aberrations = {}, object = {}, sensor = {}, ...others } = checkedSection(raw, SECTIONS, "", where, faults);
for (const key of REQUIRED) {
const [section, entry] = key.split(".");
if (raw[section]?.[entry] === undefined) faults.push(`${where(key)}: is missing`);
}
const { spider } = aperture;
if (spider && raw.aperture.spider.width === undefined) faults.push(`${where("aperture.spider")}: width is missing`);
if (spider && !(Boolean(spider.vanes) !== Boolean(spider.angles))) faults.push(`${where("aperture.spider")}: needs vanes or angles: one of the two`);
for (const [one, other, least] of [["f_number", "aperture_diameter", 1], ["focus_distance", "sensor_distance", 0]]) {
const got = (raw.lens?.[one] !== undefined) + (raw.lens?.[other] !== undefined);
if (got > 1 || got < least) faults.push(`${where("lens")}: give ${least ? "exactly" : "at most"} one of ${one} and ${other}`);
}
const { focal_length: f, wavelength, obscuration = 0, focus_distance: focus = Infinity } = lens;
if (focus <= f) faults.push(`${where("lens.focus_distance")}: must exceed the focal length`);
const { zernike } = aberrations;
let table = null;
if (zernike !== undefined) {
const at = (key) => where(`aberrations.zernike.${key}`);
if (zernike === null || typeof zernike !== "object" || Array.isArray(zernike)) faults.push(`${where("aberrations.zernike")}: must be a section`);
else table = zernike.file === undefined ? sectionTable(zernike, at, faults) : opened;
}
if (faults.length) return null;
const diameter = lens.aperture_diameter ?? f / lens.f_number;
const sensorAt = lens.sensor_distance ?? 1 / (1 / f - 1 / focus);
const inFocus = 1 / f - 1 / sensorAt; // of the object in focus, 1/m
const near = Math.abs(inFocus) < 1e-15 / f ? 0 : inFocus;
if (near < 0 && object.distance === undefined) throw new Error(`${where("object.distance")}: is missing: the sensor lies inside the focal plane, and no object is in focus`);
const objectAt = object.distance ?? 1 / near;
const vergence = 1 / sensorAt - 1 / f + 1 / objectAt;
const terms = new Terms();
const radius = 0.5 * diameter;
const aplanatic = lens.model === "aplanatic";
if (aplanatic) addAplanatic(terms, radius, lens.corrected_for === "focus" ? inFocus : -1 / sensorAt, vergence, wavelength);
else terms.power(1, (vergence * radius ** 2) / (2 * wavelength));
const { defocus = 0, spherical = 0, spherical_rms: rms = 0 } = aberrations;
const balanced = ((6 * Math.sqrt(5) * rms) / wavelength) / (1 - obscuration ** 2) ** 2;
const own = new Terms(); // of the lens itself, at every distance
own.seidel(aberrations);
own.power(1, defocus / Math.PI - (1 + obscuration ** 2) * balanced);
own.power(2, spherical / (2 * Math.PI) + balanced);
if (table) for (const [n, m, value] of wavesOf({ ...table, wavelength: table.wavelength ?? wavelength }, wavelength)) own.plus(n, m, value);
for (const [key, value] of own) terms.plus(...key.split(",").map(Number), value);
const leftOut = [];
const vanes = equalVanes(spider, radius);
const pending = typeof zernike?.file === "string" && !table;
if (pending) leftOut.push(`the Zernike table ${zernike.file}, which can be opened after this file`);
if (spider && !vanes) leftOut.push("the spider");
const parts = { vignetting: ["ellipse", "cat_eye"], stop: ["telescope", "segments", "clear", "blocked"], mask: ["mask"] };
for (const [part, keys] of Object.entries(parts)) if (keys.some((key) => Object.hasOwn(aperture, key))) leftOut.push(`the ${part}`);
if (lens.apodization && inWords(lens.apodization) !== "[]") leftOut.push("the apodization");
if (others.colour) leftOut.push("colour aberrations");
if (others.field) leftOut.push("aberrations of the field");
const focusAt = lens.sensor_distance === undefined ? focus : near === 0 ? Infinity : 1 / near;
const placed = Math.min(focusAt, objectAt) < FARTHEST_OBJECT && focusAt > 0 && !aplanatic;
const state = {
...(placed
? { focus: "distances", focus_distance: Math.min(focusAt, FARTHEST_OBJECT), object_distance: Math.min(objectAt, FARTHEST_OBJECT) }
: { focus: "waves" }),
f_number: (placed ? f : sensorAt) / diameter,
focal_length: f * 1e3,
obscuration,
wavelength: wavelength * 1e9,
pixel: sensor.pixel * 1e6,
...vanes,
};
return { name, source, pending, ...withWavefront(state, placed ? own : terms, leftOut) };
}
const FARTHEST_OBJECT = 1e12; // metres, which stands for infinity
function equalVanes(spider, radius) {
if (!spider) return null;
const width = spider.width / radius;
if (!(width < 2)) throw new Error("aperture.spider.width: must be below the diameter of the aperture");
const turn = 2 * Math.PI;
const angles = spider.angles ?? Array.from({ length: spider.vanes }, (_, k) => (spider.first ?? 0) + (turn * k) / spider.vanes);
const first = angles.reduce((least, at) => (Math.abs(at) < Math.abs(least) ? at : least));
const steps = angles.map((at) => ((at - first) * angles.length) / turn);
const places = new Set(steps.map((step) => ((Math.round(step) % angles.length) + angles.length) % angles.length));
if (angles.length > FIELDS.vanes.high || steps.some((step) => Math.abs(step - Math.round(step)) > 1e-9) || places.size < angles.length) return null;
const degrees = (first * 360) / turn;
return { vanes: angles.length, vane_width: width, vane_angle: degrees - 360 * Math.round(degrees / 360) };
}
function withWavefront(given, terms, leftOut = []) {
const left = new Map(terms);
const take = (key) => {
const value = left.get(key) ?? 0;
left.delete(key);
return value;
};
left.delete("0,0");
const spherical = 6 * take("4,0");
const state = { ...given, spherical };
if (state.focus === "distances") left.set("2,0", (left.get("2,0") ?? 0) - 0.5 * spherical);
else state.defocus = 2 * take("2,0") - spherical;
for (const { name, n, m } of DIRECTED) {
const [along, across] = [take(`${n},${m}`), take(`${n},${-m}`)];
state[name] = Math.hypot(along, across);
state[`${name}_angle`] = (Math.atan2(across, along) * 180) / Math.PI / m;
}
for (const [key, value] of Object.entries(state)) {
if (typeof value !== "number") continue;
const { low, high, row } = FIELDS[key];
const unit = row.waves ? "waves" : row.said;
if (!(value >= low && value <= high))
throw new Error(`${key} must be ${[`from ${low} to ${high}`, unit].filter(Boolean).join(" ")} on this page, got ${Number(value.toPrecision(4))}`);
state[key] = nine(value);
}
const { terms: most, degree, waves } = FIELDS.zernike;
const all = [...left].map(([key, value]) => {
const [n, m] = key.split(",").map(Number);
return { n, m, rms: value / Math.sqrt((n + 1) * (m ? 2 : 1)) };
});
const fits = ({ n, rms }) => Math.abs(rms) > 1e-10 && Math.abs(rms) <= waves && n <= degree;
const kept = all.filter(fits).sort((a, b) => Math.abs(b.rms) - Math.abs(a.rms)).slice(0, most);
const lost = Math.hypot(...all.filter((term) => !kept.includes(term)).map(({ rms }) => rms));
if (lost > 1e-9) leftOut.unshift(`further Zernike terms, ${lost.toPrecision(1)} waves rms`);
state.zernike = kept.sort((a, b) => a.n - b.n || a.m - b.m).map(({ n, m, rms }) => `${n},${m}:${nine(rms)}`).join(";");
return { state, left_out: leftOut.join("; ") };
}
const nine = (value) => Number(value.toPrecision(9));
function withTable(state, table) {
const at = table.wavelength ?? state.wavelength * 1e-9;
const terms = wavesOf({ ...table, wavelength: at }, at).map(([n, m, value]) => [`${n},${m}`, value]);
return withWavefront({ ...focused(state), wavelength: at * 1e9 }, terms);
}
function decodedText(bytes) {
const mark = bytes[0] === 0xff && bytes[1] === 0xfe ? "utf-16le" : bytes[0] === 0xfe && bytes[1] === 0xff ? "utf-16be" : "utf-8";
let text = "";
try {
text = new TextDecoder(mark, { fatal: true }).decode(bytes);
} catch {
text = new TextDecoder("latin1").decode(bytes);
}
return text.replace(/\r\n?/g, "\n");
}
function readFile(name, text, given, waiting = null) {
const suffix = /\.([a-z]+)$/i.exec(name)?.[1].toLowerCase() ?? "";
const faults = [];
let found = null;
try {
if (text.length > MOST_BYTES) throw new Error(`has ${text.length} characters; the limit is ${MOST_BYTES}`);
if (!Object.hasOwn(READERS, suffix)) throw new Error(`must end in .${Object.keys(READERS).join(", .")}: a lens file or a Zernike table`);
found = READERS[suffix](text, faults);
if (found?.terms && !faults.length) {
if (waiting) found = { name: waiting.name, ...structured(waiting.text, faults, found) };
else found = { name: name.slice(0, 80), source: "", ...withTable(given, found) };
}
} catch (error) {
faults.push(error.message);
}
if (faults.length) {
const more = faults.length > MOST_FAULTS ? `; and ${faults.length - MOST_FAULTS} more` : "";
throw new Error(`${(name || "The file").slice(0, 60)}: ${faults.slice(0, MOST_FAULTS).join("; ")}${more}.`);
}
return { ...found, name: found.name || name.replace(/\.toml$/i, ""), waiting: found.pending ? { name, text } : null };
}
const READERS = {
toml: structured,
json: (text, faults) => sectionTable(parsedJson(text), (key) => key, faults),
csv: csvTable,
txt: (text, faults) => (/^\s*(Listing of|Using)\b/im.test(text) ? listingTable : csvTable)(text, faults),
int: codeVTable,
zfr: codeVTable,
};
const SUFFIXES = Object.keys(READERS).map((suffix) => `.${suffix}`);
function structured(text, faults, opened = null) {
const { root, lines } = parseToml(text);
const where = (path) => {
for (let at = path; at; at = at.slice(0, Math.max(0, at.lastIndexOf(".")))) if (lines.has(at)) return `${path} (line ${lines.get(at)})`;
return path;
};
if (!root.lens && ["focal_length", "wavelength", "pixel"].some((key) => Object.hasOwn(root, key)))
throw new Error("has no sections; expected are [lens] and [sensor], each on a line of its own before its keys, such as [lens] above focal_length = \"50 mm\"");
if (root.objective && !root.lens) throw new Error("describes a microscope, [objective]; this page takes lenses, [lens]");
return root.terms && !root.lens ? sectionTable(root, where, faults) : lensOf(root, where, faults, opened);
}
function parsedJson(text) {
const root = JSON.parse(text);
if (root === null || typeof root !== "object" || Array.isArray(root)) throw new Error("must hold an object");
return root;
}
const SHIPPED = [{"name": "35 mm f/2 camera lens at full aperture, over a full-frame sensor", "source": "Illustrative: Seidel coefficients of the size that a classic fast double Gauss lens has, not those of a lens that was made.", "state": {"spherical": 0.4, "defocus": -0.4, "f_number": 2.0, "pixel": 0.5, "focal_length": 35.0}, "left_out": "aberrations of the field"}, {"name": "85 mm f/1.4 portrait lens", "source": "Nominal figures of the 85 mm f/1.4 class; colours as of an achromat with a secondary spectrum of f/2000.", "state": {"focus": "distances", "object_distance": 1.98, "f_number": 1.4, "pixel": 3.76, "focal_length": 85.0}, "left_out": "colour aberrations"}, {"name": "Hubble Space Telescope before its 1993 repair, at its best focus", "source": "2.4 m aperture, f/24, obscuration 0.33: STScI, Hubble Space Telescope Primer. Spherical aberration of about 0.265 um rms: C. J. Burrows et al., Astrophys. J. 369, L21 (1991), doi:10.1086/185950.", "state": {"spherical": 8.14078996, "defocus": -5.33032199, "f_number": 24.0, "obscuration": 0.33, "pixel": 2.5, "focal_length": 57600.0}, "left_out": ""}, {"name": "20x/0.75 microscope objective, quarter wave of spherical aberration", "source": "Magnification and aperture as of the Nikon CFI Plan Apochromat 20x/0.75 (tube lens 200 mm); camera with 6.5 um pixels. The aberration is that of a cover glass a few hundredths of a millimetre off.", "state": {"spherical": -0.0131582802, "defocus": -1.29051883, "f_number": 13.3333333, "wavelength": 515.0, "pixel": 6.5, "focal_length": 10.0, "zernike": "6,0:-0.00201597229;8,0:-0.000257895849;10,0:-3.68843058e-05;12,0:-5.64687297e-06"}, "left_out": "further Zernike terms, 9e-07 waves rms"}, {"name": "200 mm f/4 Newtonian telescope, a star 0.25 degrees off the axis", "source": "Invented telescope. Its coma and astigmatism are those of a paraboloid with the stop at the mirror, W131 = a theta / (16 N^2) and W222 = -a^2 theta^2 / (2 f): D. J. Schroeder, Astronomical Optics, 2nd ed. (2000), chapter 6. The vanes and the figure errors of the mirror are invented, of a size usual for amateurs' mirrors.", "state": {"spherical": -0.439082439, "defocus": 0.425407938, "coma": 1.033, "coma_angle": 53.1301024, "astigmatism": 0.123945095, "astigmatism_angle": -61.5530158, "trefoil": 0.154277843, "trefoil_angle": 30.0, "obscuration": 0.25, "pixel": 1.1, "focal_length": 800.0, "zernike": "1,-1:0.8264;1,1:0.6198", "vanes": 4, "vane_width": 0.01}, "left_out": ""}, {"name": "50 mm f/1.8 camera lens", "source": "Nominal figures of the 50 mm f/1.8 class; the pixel is that of the Sony IMX250 sensor.", "state": {"focus": "distances", "object_distance": 1.5, "f_number": 1.8, "pixel": 3.45}, "left_out": ""}, {"name": "Phone camera, 3.99 mm f/1.8", "source": "Focal length and f-number as in the EXIF data of the Apple iPhone 8 main camera; its pixels are 1.22 um.", "state": {"focus": "distances", "focus_distance": 0.5, "object_distance": 2.0, "f_number": 1.8, "wavelength": 530.0, "pixel": 1.22, "focal_length": 3.99}, "left_out": ""}];
const PRESETS = [{ name: "A lens without aberration", source: "", state: { defocus: 0 }, left_out: "" }, ...SHIPPED];
const NUMBERS = {
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
const meaning = (key) => ALL[key]?.[1] ?? "";
function help(level) {
const entry = ([name, about]) => el("div", {}, el("dt", {}, name), el("dd", {}, about));
const parts = Object.entries(sections()).map(([title, words]) =>
el("details", { open: title === "Numbers" }, el("summary", {}, el(`h${level + 1}`, {}, title)), el("dl", {}, ...Object.values(words).map(entry))),
);
return el("div", { class: "help", role: "region", "aria-label": "Help", hidden: true }, ...parts);
}
function explainOnClick(node) {
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
function sayBeside(node, tip, beside, text) {
tip.textContent = text;
tip.hidden = false;
const [page, place] = [node.getBoundingClientRect(), beside.getBoundingClientRect()];
const left = Math.min(place.left - page.left, page.width - tip.offsetWidth - 8);
tip.style.left = `${Math.max(8, left)}px`;
const below = place.bottom + tip.offsetHeight + 8 < innerHeight;
tip.style.top = `${below ? place.bottom - page.top + 4 : place.top - page.top - tip.offsetHeight - 4}px`;
}
const PICTURE = /\.(png|jpe?g|webp|gif|bmp|avif|svg)$/i; // of files that say no type
const LONG = 2000; // characters of an address that all programs take
function actions(view) {
const done = (button, text) => {
const { page } = view;
const before = (button.dataset.text ??= button.textContent);
button.style.minWidth = `${button.offsetWidth}px`;
button.textContent = text;
page.said.textContent = text;
setTimeout(() => (button.textContent = before), 1600);
};
const copy = async (button, text) => {
try {
await navigator.clipboard.writeText(text);
done(button, "Copied");
} catch {
showText(view, text);
}
};
const save = (make) => {
try {
if (!view.settled?.psf) throw new Error("nothing is computed yet");
make();
} catch (error) {
view.tell(`This cannot be saved: ${error.message}`);
}
};
const hold = () => {
const { shown, state } = view;
if (!shown?.psf || !shown.measures) return;
const { psf, measures, rays } = shown;
view.compare.hold({ state, psf, measures, rays, sentence: psfSaid(state, psf, measures) });
view.page.heldPicture.checked = false;
view.draw();
};
const openAny = async (file) => {
if (SUFFIXES.some((suffix) => file.name.toLowerCase().endsWith(suffix)) || !(/^image\//.test(file.type) || PICTURE.test(file.name))) return openFile(view, file);
try {
view.own = await ownPicture(file);
view.tell("");
if (view.gone) return;
view.set({ picture: "own" });
view.wanted ??= "picture";
view.schedule();
} catch (error) {
view.tell(error.message);
}
};
return {
pick(change) {
if (change.picture !== "own" || view.own) return view.set(change);
view.page.selects.picture.value = view.state.picture;
return view.page.choose.click();
},
async file(files) {
const isLens = ({ name }) => name.toLowerCase().endsWith(".toml");
const list = [...(files ?? [])].sort((a, b) => isLens(b) - isLens(a)); // tables after the lens that names them
view.page.file.value = "";
for (const file of list) await openAny(file);
},
before: () => view.drawRecorded(),
preset(index) {
const preset = PRESETS[Number(index)];
if (index === "" || !preset) return;
view.take(preset);
},
reset() {
view.controls.forget();
view.set(view.start);
},
hold,
exchange() {
const { held } = view.compare;
hold();
view.set(held.state);
},
release() {
view.compare.release();
view.page.heldPicture.checked = false;
view.draw();
},
mode(mode) {
view.compare.show(mode);
view.draw();
},
scale(scale) {
view.compare.shared = scale === "one";
view.draw();
},
turn: () => view.compare.swap(),
link: async () => {
const { page, state } = view;
const text = view.linkText();
const address = location.href.split("#")[0] + (text ? `#${text}` : "");
await copy(page.link, address);
const missing = [view.compare.held && "A", state.picture === "own" && "your own picture"].filter(Boolean).join(", ");
const said = [missing && `Not in the link: ${missing}.`];
if (address.length > LONG) said.push(`The link has ${address.length} characters: some programs cut addresses after ${LONG}. A lens file holds all of it.`);
if (said.some(Boolean)) sayBeside(page.node, page.tip, page.link, said.filter(Boolean).join(" "));
},
python: () => (view.shown?.psf ? copy(view.page.python, (view.settled ?? view.shown).psf.python) : undefined),
png: () => save(() => savePng(view.figure())),
csv: () => save(() => saveCsv(view.figure())),
tiff: () => save(() => saveTiff(view.figure())),
};
}
async function openFile(view, file) {
try {
if (file.size > MOST_BYTES) throw new Error(`${file.name} has ${file.size} bytes; the limit is ${MOST_BYTES}.`);
const text = decodedText(new Uint8Array(await file.arrayBuffer()));
if (view.gone) return false;
view.take(readFile(file.name, text, view.state, view.waiting));
view.tell("");
return true;
} catch (error) {
view.tell(error.message);
return false;
}
}
function showText(view, text) {
const { notice } = view.page;
const area = document.createElement("textarea");
area.readOnly = true;
area.rows = Math.min(12, text.split("\n").length);
area.value = text;
area.setAttribute("aria-label", "To copy");
notice.replaceChildren("The clipboard is refused here; copy this:", area);
notice.hidden = false;
area.select();
}
function acceptDrops(node, take) {
const over = (event) => node.classList.toggle("over", event.type === "dragenter" || event.type === "dragover");
const mine = (event) => [...(event.dataTransfer?.types ?? [])].includes("Files");
for (const name of ["dragenter", "dragover"])
node.addEventListener(name, (event) => {
if (!mine(event)) return;
event.preventDefault();
over(event);
});
for (const name of ["dragleave", "drop"]) node.addEventListener(name, over);
node.addEventListener("drop", (event) => {
if (!mine(event)) return;
event.preventDefault();
take(event.dataTransfer.files);
});
}
const wasmText = "eNq0VgV8G0e6H1rtSiNpdbF6cc53udU21ytTXAo5chUqhY/vHF/iNHbYdlm23Dj1c3ucHJQry6WDMv9eU6fMzMx8zOT4/b/Z9Vou/PjNSrvffPCfj2Z2WXPHes4Y47c4W/kKxlaoEgZbEaMHEVb45ObPSysY/qJU4sUVkgS4dxNbFsEjCViiCDE4xWKgFQpw58TBDXMSgmsYpM67DUp3N2inFI7An8C+yLB2NxhYKYCnBzlaDPwgjTgmmFbHACU7UAIPFMii0Q+8xBTwluGCoDnYcA9rg4YwADJSx1gbexUasBA/XEqFmtY4BqlHC8GQRSZwJJJ3sUBMvlcvQ3Z24DdxAgAZ+CZDXrCYFSYjzEoYGNSDZygJLQNHBbkVLhNkHhmMUgU6XCTKNamFslLoRigqRrmO9MNcR95hmNUiqzAtvBi0DWQBrkUrRU/wQWAEClFABBIPQIpR2qJAwlw6hugi1EQpGuCHZiDjIUnqdsSNBbygCGGskIdovBiZ0SSEG400QAieYePQGK9IrRWtBSq07cYwsggFVGiJDRL0XdRzAXiY/iB9YRqLwQJRJwCYegUPzGnDdQdrhFGFHWeFnKCnuhC1eQhzj0WL8i5idoEp5svPntTc0drUsaF5U8eajZ1Nm9pbTmxtOemg9Mp1G1eubepsXd/SdHxLJ4vH1m1cv75lnQ2t9s6WDSwRMtTq5tZ1TMsLU79IMZZMpV0385nMhAwNS7luOh5jlqu0q51MTTY7YbfPQsCYstLuxHS6Vrl6kmUpjHQt51IKgVn4A9PFmAAYh9c6wc3Vn0tigUzd5ydkGFSYxWjgEQ1dyyxHhQMrO84XNNca9OQvpr2cD56zuz3lS3uoL++pJu+l3L332UcDal9P76f317rGOmC/Ax24K/fYo6Zmgl1z0KQaV2v3YCWmHjjBVfVqau0hDgaYHKFxrKlcZsW00lbaUlqBUqrWYi79NYIhpg7v6XGP8P6RyScZfMod41B3osI6h6nDkf0pR0ycaNaePA2i6VypaWO+uKAUEiKUZmyGw+GnJj4/CDnRDlcc0bhgQWC5NTM5ArcO0PhnAhDm1nOO0MFypunaWX6tZTWoBjV7Wl43AO+gmkbpOEe6VsGyHIdznea18B+OpjUN5dYCBj/NXBpA3VM6fI7j1Ej7YMfmc+dls9yRUlrzFxyVLfCZRx9z7LRJx0m+cNEkvdhdwtNfcJ2apZPTU5yF6AZmEsBrgx7K2lmXw57r0VVnTFG1epmJiC03Oq7OziAi7ahZ2iUvOHIkJUz2NyZJ1675iuTSdqYcrY+ePLmmZrKzXAshoPHVIJT012zt1POvu2mVPtJ1pfeNbzrfSruOGfO/Pf+b9LOc+d9pynJaSyNhLq91QSP9XNdP0XoCFYTaU61YWJ9ONzvfXVhjo08lSjPWO64j4co3viVsxziwyDggj1Yr3VXptKPxU06L62gwhePUpnmac542AI6lRDa7+ltNCx1+/Ddi6NfJNROmzJwpTbC1BslyslTMwDdUR82yDshazLGquco64KPTmWgCuSYrv9XUyr/hBclpC0NVTlau1euc2S5X7rFaUyjgG5+EI8VELvjUNAAXT5lTs16pDTXTpk2apPecaus9p2dtx0YSs1mtC+mCXeDatZdje9lpe1w3LUI/mfal/nXUIp6moDUzXY5AZLo2TAhdVIDR/IMsrNLwh9Vqy+VjBMbkyRP9iRMdjAaHgFHSjdlNB86n0yNbwGJY2qywp6rPZrObZ7U70xwEuv/RvEO7hzuLlV6EBYAJDzRQQchOwDOONFCXIREEAG9OsFSIBlzD0xQbmNCCZqh2IvFcHJ3o1JqaGm2Ty1UdTuBKYhAf8FO1mjo1MD6J154UZMsO8PlYrAoXcxDfLH7yKc6pgSOcErVpfrZQv3mWg8FpocMcNHyUqwB5tqo/bY/iYTaC+nr97K56xSHHBBrheTXuHhwdtCRPL9JyKjmquDtRojRYphspcdxSD3dMByFvEAenBS2XRmKCKsMmcCTw4nQ+VdVGZRx94iROL0ouy5ixhfdy3DJdyuab+L24LMXZFhE71C7xfE9Pj6NLLN/zwunmyej2x6eCydang+fVdwRKdz2Duf0jsVtsfcv6je2nCKabWje0drY2r2s9tYUp1b5x43p2Do93tHQ2rWs9fk0nOz+YnNi8oaWDXczlpo7V7BKuV57Q2dTRsnLjhlUd7EquSWVla/vKdVC6nicDsqmlvX1jO7uDpzduaIJBpHEnT21oaW5vgnlne3NHJ3uIx0ne3tK8cg17nCdIP9R9ksfbm1e1ntDRtHE1e46nQxt6zbeubGHPcydCeYur7647oZ39lieMP83rW9qb2aVJa1XLps417FdJw17duq6zpZ1dn4yF1E3J+L8EZ3mu7+HTZ82YOXvenMaGuYUj5x+Fc/u4hYsWL1m67IRf8V/zM9Uj1mPWM+pV9ULsntgF9p/tf9mvOq87Lzg36pv0E/pJ/SO+nf+M/4JvFWeIPtEvzhTf5z8W54kLxIWiIgbFxeJy8Svxa3GVuEZcK24UN4mbxa3iNjEk7hR3ibvF/eJB8ZB4WDwiHhVPiqfE0+J58aJ4SbwmXhdviHfEu+I98VvxO/F78WfxF/FXcZ46X12gvnWR+ocaUT3W6Vav9RNrm7Xd+pk1aF1sXWJdZv3GusK60rrK2mHdZd1t3WPdZ71jvWu9Z31gXRy7JHZp7PLYu7H3Yu/HPoxdY19rX2ffYO+0b7fvsO+yn7GftZ+zX7Dftt+x37Xft3udrc4ZTp/zvvOB86HzO+fi+CXxS+OXx69NXJe4PnFj4u7EPYl7E/cnnk+8kHgx8VLiL4m/Jv6W+EfiF/psfY4+T5+Z/F7y+8kfJX+S3Jb8WfIXybOTleTFycQHL/u/SDWwTEfmpMwpmVMzp2WKma5Md6aHZ043fY/u38ozZ/BMH8/8D8/088yZPPMfnvkvzwzzzEAy05/SuzMxO8/2FDufOb2fzUkxpvMo6KHBPNOLTcL0lRxKYraHPePMTzGPFZgZr5UqOWb4I+5C8Hn+9JPbcjwp9HgVCIYnmtuCuvyWTaTCtdE+qgpthRxFu3nTsQbtfjtUHacCwR/XmNvRdfltLlSgQD7YbVc01vcNVfSzjs27RYl3S/OX3UBlO3zZWN9/ma/g7Gbfqg7jyEooDET5fFu+J+NZdTlLkz87/JixtI3YIdeqLWORZTy0jNflHLIUO/yEsdSBGJai2jLxSZZxbXJt5Xe5lB0H8vmpIMSKJ8qu9uL5h05qyyWhFCchoY5KvWT+QXtuHZQU4DbnUp5tnranzVN5iUbe17hrxAy3t7EnGJmtuYQXgwjReP2NkDEj41v9tCeJL8kIFr7bDcWQjkH2EXXZXfQzYHppD6QHErZezHPBh/qyK4q5tAkw6Vme05Y/e2Obb631nTxHIGA7+YajEVHCc67oy0kvkd+JHKy9oj+XSAoK/fsI3TJ6s9soo40sJyExnBF2LBg8FwMzHQro4aXzPZxQfLcPrsSv8DP9W8mnvka25IqtuRiczfTn0mi1wLF58CCZs7xETsI+QXzCzy8k+IgH50LfJPkLT9vgs0tST3pugC1hGlye7aU6/LingA79dBFKsSgpkgBBd+VcUoZHiS7PyLqQ+9JXYePm4HtOkSLqOjenGsHrQrQlIrBcHZlL7clFaBigy1P8xGX5UpuPiNOIvPF2BlQTejoMXXoW+Z2zgGrWjS3CSrFTfAl5isOG99OtF6r5Ui6eFNWdCP9CfNQKqcb6WFbV3ZIT1MJefC12050noY9pCmoeUaNb4M5oL8DERxc3Y2nZiMZalBIEhmXp1r81aFOMnQwdFq7hC2p4NuCLEOePdgUorOJBMGB2g5U5A0YMnkIHCiMjX6yv3Pi/Y/ounMbV49C6du+iOjx7Tu4dWyQnYDuKo4/gvJRHQ9HenkOhSBwsewokZC5yxfKqLYcwKCMQiyTTSJYpiP6H4KJECc6XjB4577EFCDvPPd7pc8rq0XU+h/HxPksxLMNMTfKex9ZCbWREbs53wTCfWkBtCD7P9/aotnzmRDKCzhWNUOrtuyzH4WBoITp9sae4+lmc5j7Od3LPTNpgnen0WFu+2IYIDkUQyFMeXsyGohHlS3SSNHIvAg4iJ0xE/d9nCJMDE6o0Aab0eBUgdzVE9xmR8QlWZhaGE0RpssJGfaS8wgsB/BF5qGFiZnKRJ9dEHiuIBSnkD07mmPYodbItDOAjM6Y7uaKSUT+aMjEi9mPMh6v0oN2Y5zkLlZT5Eb4ZdfMsunHPasspGOFBu4Rjk3gysFTGEmCadOFZCVUEe0Gd6Rf9bsziJV7k3bwki7v3YCCja30+xZAUMHAZ2j3sxH+WcgIBjvblUA69MToZgRpZRFf4LvPo1YFhb8Yr7V+P/WCLonNT5e946bld8tgUB3nt3XeMyIWIxRwg0mC+tqtx/3eGyjlROHHGKYf84YgPZuYQG04VetfBBntsxKbXL4NLtoYpW5qKwfQPR/wbpn2zVyHgUd/I7ZgOrN6SKEogwAAoA6jSsNy1ZZ+Webv9o6Eyut8bPHZp+b/CVzf5Y25UkF5UOnKxUga40GNON1Q5vQP4JeBz4zTy0DDqsjQtcOPhIokGT5oKBjgClzXgswHcc5amAkT+VPxYBTsyugr73RnfcNPwWbdVCkcseafvgUcfm1WuFG568VcXTnokOwTyjOW7JpX5NxpA/jXzGYwB4oZZaSj7dkg7OFA9uzLgxwZCTi2VPlYZGKzkYuQ7uW04OLMGTBfQDD5W8PcEWFHZFXowLZnglBWIxtwfpVBXykAU2WNDK1Pc6NLBWI4cDFOrom+mnGXwD0cLgeeptQE3Zrg14EamXmzAAOJwrYSLIWOx8kCkEUrGOwl2tQv4LPQY9Kh1nLl1UeOXgwyIqtpEyGwnYDUdW23BPsJGSwIz86MfYPJfoT9QNi/RnhNFs/tO+8SdN7aHRCMxy4+Wf9fwdZQhmGL8c6hErz4WNfNgjqGToTASjH+MsK+kZNB81VbLgmIOjDOUgRa2qy/zvJP27P02bVUZ7LXNKTm+YyVMxvaRCld47Lmr3h8qfSPFxkSWaZaqBFsUE50Lb9z2pTaslj3RfJDHqtAij1/bfvngnQx4VIfq4mE6Vo6BMOhXt1/eu5N9pc6zBnPIhKQdtzl/4e3njkg0kNcXqrm9W4eqaolGvom2mhVtYaq6wjza9LReFNLs8qBvjd+YFd/2LDSKrzxV8a3hrO94atjnngOUi+45+bH4uXc2VIazpFQoLJn16oQ/3YH98Ip88Oer5t6L/Qnd4eRVJ//wC3dvfqjh69v9n05Z8ETD8B/58J/BV//+xTnnnPN8w/blNN4O+b4zDNdx4+UyHLQHyghlXOMx/bIUEl1WdRBST53jy4hDHzP8HF9FjPHHPYX5XVLxOD2UJ+m/yrfqICPaqvPHak1gMEE5QFENCw9NL62+sPxOE45jFk3v+XzF59RNVXOsU8n0kdsXATm6Kr4817AhPxfOSPIEaR4ImGWaeipUGSCL8uBABDvoUldH/nkrx3sxGHkRzv9/vKi4wbFeDc696Po4OJSrwTGtAocFwIMX+BNciKryNuR4cGhUFwTlDqq+o/pdLPO3v3T2iIw2+J/xWuSeyJxFiwSfp+wjZ+Lg2BwBSbzBz96qjFXhey9/brfV3s93ljM/p0MuVNxZqoxROY7WpEQEKn7VUc0Gy2M7Sf9ASN4tcDgGpx+v9loEZ9GC4ACDG+EpafgM7Pz2Pw0/JXKy+shZdGTlozD4NiDNB6EJPZjLDV54QvDwoMQo4ZgwG9pT8BHb2mzxCnbws7976yl2Ne3g5xe/e9uDhfeGymBDcMczC45a8ad/QeBN+eO21/bcBUFh2zvN7jtyV0O5DKwdBr/Yax5OccgnTGo8a4AQypRocEDRZmb6PqXobSE+/QsNp+n4yiIXZWVyVKjdr7DsP7l/NYwSQzgBS8vrzK6uC7/cgSFh/Idd1A1mAmzqB5YU4Rl6dEp89PCHCI1lXAhtHhohG0P+sEctrHo1/XOoPEY3VH2A4MWTFzlFr2cyOxsIkRkUIrNImUNZ6EjuMWJKMLk2HTHeMjquocRyyqiYMuJDyguvwgHr2vYtXF8ZqhTOHX5lyX6vXEElW39u51V/vvo6Ijd/dvdd92y+lci7Pjwb5/D9IHN03I9hfOYF/81pV/wYoX2YOnHK0af9sgHai2c+Vl6duobIDd4xdz885yYiR3rZtikL7iAytZzG0yBzsbEiHGs+j2Wnb+rQz9r2kdTtNj5eKtApj/IGcM6a76Vzg5qaanqR6sDH3gW/Uyr40uenferWogqO7qeeYpvHL2uv7qOodpsOx+YLaRZ8TZizNrTtIaDqHX5O1VcgfI6uQvwfw6nXZwoA91/LT3jtDwsoMdN/tOaGPbdcTClfXuhPL7/9fuJ2bfxQTnjmKcM1425wI6At2/a/5u6brwPQ1/kP6tbF3iG9+876+vlv781mgzx6v7M+/+Vpcmd5XPtJD2exMl5f+86tI5T8KFZP4ZKV8IPQ/lZ26h6X/uTWMnJOpzRvZEvrXB1qvw/tYGdv6jVbujwwajEDytRyA54Ce9CgEa3KAB8oRwDl/6PmK6AjSY5tK6Gos1uqgeM//8vfP6s+mdmL396tOWfHR5+ZH5pbhmXUm5n1aNfMzLPa997C8ZiZ8TEzM6OZdfziRlRmV6m7tRqzd7bVVZmRkRE3IqFultTTK7EEkhdP42gMrvImY+ewpDAULQIRew0bQZHtRYA1ABS2FwHjgFYoD4AH6EJ5QD/gSOVNRnuRbU8/1a3bp/mJ9rlZinTDBldtnl3CxcTqwCmJ3USKL0m5QdKx5ETFKPZnkH4Ovq4x3kALIWmBIq6XIZl8C5G0jKRlJGdZh7TjFS86Vhvy+saTJ/8Yc2Y/2ZAicC46RtfLHDPfJscweUVP4NVsqhjOFBSnNA4seEVNU2+wRn6nB4/Gt8wdQq1dQKQc813VtLXV08mjjpVi4iq9+ajdOtcUPGWD4GofeI7+GEioNnEfUho7ALQWGkvR59rpvQxpuI2Isw05kDiaPv02r0G92SmvHhrbO+HgdGvAvelAkYH+8jpwb+0n0BO17Bgx7fG16rrGZkjgRSXEbImeOQ4vKJE7594SPMA/8terM8dl24INOR45+6iAqkpq2wOBD2K8GeIE1sQAEMusnWlpVkm6e4MDmuSChOAFJUaAke0gLJ0jwWJdnmWIBzUALjmXBYspCM5HspB1/4OpUGD9+PafkebWevoQ+ZmQn15NfdLZyzYYRp6i4hWsJB/JTPJtdyxfp5Q5IUziZ5hJNBOiJXFVm7a7OkeqXKAcv8CCtvXH0FFHgrdbulXVS9iCdELurXag+bRrj4FCgaBi5mTOYT0otRSqKenbUmQtQmUpYxAtGHgIMwgeBWS3icg6l/zzG+mOTMGLS//8qVzzxZuwE2mT6plUlyRunRK8y02iiOVRBOhWL4I4Ya+qV8gVeMvkAOvnH8JAr7rqlSdZ0yVDTRqAYZKPmhLRBJ2gZrnxnMYRSJcX404uX8OXTxroZjZNtRYfRHZKWdKS8MZljUINeu/8SPDoIvkZPVHMwO72REVP+jaME1ZxenaT8Jx+q5PH61diIljbBv5xAby0uhXig7KqK3t+mWFIyafcxPmfjgd19HRGB1B2RiKlqGqy9sZLp3S0uc6Udg5m7fi/mwhBhNOz4uiJzcAePeW/93ZwdenTyCBd9F/I64IOP1h5ioax8tL/icPAozd2d/+9OxLEliDKfOKrCWkI/rDz24Pa/+417YKuoPW+0z80S5a4ukQlFvvEl6/0JWF7G+elOobTSa9RpaMHvqTdApyOreC0NGly6Ky2cU1CdM5IOZCzotxnALTOCMRgAo4R5cxV8NsLJtN+IF8HUuxSv/Z/HkMQqh+WTunqR+TKZ70z3wfSs2u/29D8DzY3xQKNkotpaRz5tNP+pl/9rWdfvNnoIHvtqR/q4lNsxpW0pJb3Q7Ikl7XplY29j7n9OTScG7c9e4RCdrbJfcwnno2a8XYz2W5WPCXZ097drKLiD1Cx7anxu9D4dFNRZCjQH/TlLdvNgdMNFZWnG+dXKDyOuNgDfuLH2J6MaefOKv4iqvgQqyAFFbU+Tf95xJl6LbepdSmmnIbQNq5ezuLbUvz8WPx0Lg7lJ2P5F9APeLJmQma9P6BWkikyOGTc2Pad107bi2RTatufAAMaAZnlUi5H188o1usMky5iNsvGPIYyD+H1yo9u8eSJIgQcjXzyDm5u4yg8IfDPBEPfhCsGjucHFH2IK8Wjd8n1mPBBeJhH66r+IOr4jTOCjZKKX4gVP9FVlOTzba2ldZ98zgjMN1C5J3yYDL2XOc33qc/PbB69382btY5HADhkvD0cVn4QyyV1cxrjrXT/Q2MqahM5Q4uY6haMDR70ldftWwuCFDJHFV17vXEGh/YnNj0ld/JfIcZnVAkdcjJl5H5KKbsZ+eBCpLyKA+li4lAMzDBhf5+c2OaZI8p84iIaDiLVWN6VvSLGUijBPunzQb8g5D1O7VFrTXq6wZOXkUCCCkDG8rlNn3yj5zgX76tk2/1aavBMBH/Cv4VPRl/CORlhJuxryr4k/6eXioT+8Kir/yYLQtN+FOdrcv74ZpyvCbejcEyWDE7YTKv6p2x2eJiF+hP9Ay1QLXsdlul3NqZ3WGZBaPYPy7AXBnGMIy76Kfp0OJnDcq53H3qleJyJ/77uQ6+sd+iF5/ImHRx6pXzoBcw1kOISb265BZD7lEzepg8V1CY8ew7Ou8zC8y7kY/+4S3aMi0+PuCOz+yiMgxrPwYSyOF9SxOx1egX6Ug9Pr0gXacLQY12peDE8PwMdCc2nA61kmNOI/SCzoZu/3T2p1/2QwO51TFgf7ydN4Kxf0WicF2MMvO4nnvVROsbBwKzuwGTDE5CJ51oXocqEMXv7I/4705Ng3fGD/O1RPLcAT64cFJ+WYkUtqjvRRefJ3cLu9gVb2N1W78DNfPEbpPjBtJmcY2W9wlY6NPj7p6GBV2GX/C/DyX6LQ/wE7xoU+JG0xy+rXosmzPpqlcumV5EQLlimMSTVWDzKpO0oqFlDnfU0kK/Geo4LmtXXmnzDK7zvlns1bYr2mv80MVxXl+21vvDQQFI47Wsyus/oPbVrL2uLKQl9GjMRbYiz6lWMv2E7eVTksBo/kBLYRU99uebzr4zIOaouUZN6G33BM0gBVvIcbekra9XlhA6SCipZAZlRGzZTXkhToj2fYgv+FQe9u0DzBWmTxCzI/guob2pQTPmRT54lXi8h+kml7IkAnyb4CLwedI0R8HQATwM8S1M8gVc9g48qNECUcxmz4dMpdlptAtuqt6ATdNe9atPzyZJPodSglfKaQaLmelrreZ909EnPfNLRJ/dirVK4ohFPhXgmFEg1c60pdjlXIrYjbD5ibMsY27KLLSsoGsdmi/+jNX5vz8IuKxzF2NsQ4gwlmRTbKehmroGXdE9pB+cQPzyu6iiXTaFkCigECCrOUKCnjRUvqdkI8s4Xs/xRkj9W8qeU/JkF+MN4oI7jYz7AdtHoSCnwG74LrMX52oY3Uywvdx1YOvq0oZT09gJr9h9Y2w/s3SDEc5RkXPV29v2lOqauZYWNJSe87RywXtH8HzzPoudUlbI/4l0qRlI+U4OW03jgnRl6lwE0DHSII4AphmUm9xtNzrGHwqwb814LaBz89TW+zP7TGgERtUMFxFheeBczj5KJKJmAUupNf0if2fese2bXrPvugskcAuCDWw/vtkLt834uCZd/HK9K5szo4oGXU7+MCRbkTu/pD4heMnD6AJVcyBIaEoqZEhqGf5I8uTas6s9z0WWCrqESiF4aFWGvbua7aoBurzMkpzfU8okb3GGs0yCnxJDn/1w04XXPyfayoTEifmmjYHeje+bIKbde0JWhrtL9mkrqSUEj8HAnMyG9hz8g2zLqRN7b/vCvPwB+qPZDWw9n31D4+j+y0bnpYucgD+cAyULvhtYNhMweEGDhy/cLAYxAJ+hs6P4+MLJ7YJSRFYXE/ORHfv0BEZgX/fXvmLsMO1oAGiC6CJqB1fOw7I1dugd2OVld7hs7mIleYM4ceHuha/eDbrYHupgQR1P3eqVMb7rR4eidfEsxw7wTt3yzIYty+CWEkYQAc0WYSeTFBJRdi21cMZUluOm2SEqWOEvwgLeNO6Guq7DIKJkTvQ6nu73V8MeNSoO1PlgLUZocj4CDOtdU3LAdEeX0JlT+E7zFetjr+yVVg1XSG14CrIipy/HSKUA637BnJE2aUpFiYrkL461bMq1Vz8KcS6oSeVXeeIszbcOPlqzB9HqMSxo2XRkE0S2JZBvRQOa7w35EY6E4zFYwE44ChrgarhcsIbjqe5nqXJ1E9wUM9FO9sUOg9RFKWHMl/LYOfS5CpzF9W23fVpbkOIurYrKNJqMGBWKyT+WB2IrZoXHinE18Rx+/B3qd5v8PxoJWdkiDonFX9FVFlHl8r/BDyUZjQtaG7YSiH/JKMdZc5rCUxLFJ25/4ZX5LOm1/hS/Itw9zjWQjgajP82ZnnOz6jw6Bnb4neYPvovs+AsAuSC7E1zn6od5IlhOrcI6u6I5CMeYBaKcAiCyCbWTj3Q/cGGl1AEklNL7UIyUFKCYYIhhdx/hVP3Kzi6C37tmpTocA2K4ugfvw8dopvrNpnQuL3W5yQQFwdAdOwvsgSWSft3h4If83iBZO5dWY43if3i5AoiTPD3vr8f0vvEXC/RtvAy1+Up1LSBAIgICABwQWSBRIN8Cj5UgmBwvdJgwMeXzgqQERMccSJmCpeRzMLIWNTepzXC8xDkb5zsi9jdNiXCrGFTCuGBpXzBsHw8D8W5ysPeQsjJBU2QsZ6XzQ9ZEDp2LXiBkCChPuuaITkDKWRAStfwG05NLPLu/bwzBgipmL6y6RPOCpK7SLRfjq9D6S/SUc6pS+e9mYuptU0ht2BScXShQ1xGEW0h8TkoKHFVL6HIJGof48mjdkD0SauYCa4rvymq/gGl2pTgf2AsDwHPrSohPrDulz7g6Y8c02RN+lIVTDz5voTWMCmBvtzn0Cv4bCNiKa8Z+Q0LC/yXxKXxh+mcwXuDHjlEm6Y0Op6hnQivhomfdgpYQ52Ht3WMWKGm49aCirljSuUKsZBY644cgLVB5OQ5sHTsgrC2lK1AvVQ/tO61Yhq+fGDZrdL3kYVKIZabovCh5K/O5YA1BLJU7Cc1jick8G9Z64RBL2IpF0AXC7AEfPc8PGfV4pNUR8iHcS8U76eNsh3vZrxXvY8GzwFiwE9gEkpGE5KBFM91QdHc86p9POHZ/BS8GeUuJYLO6bKgofhtlXnA19PBS62AUZWmEw2d4Is7COvXtgq6QnzSfNcVweaRK2OzS0TFPON/NKvJWxvjz06YK0c7+lviEYfCciIPuofzx7Anrfr/CWpiAp1OAgvg1k5WoQ+sopbGXdf8IsFMo+MWiIbFftJv+CnNBvJ1DBjwXJv2Vvr5x2rxz4pPoJvvhf31h9cQuYi4KhvVu/+o20F/q+0fZ+0/D4btN7pejl6VgU8mDkV5e8CkRmRw5SN5P43IhtUxH31PjCM/+Y+TVu3oQnyPD4KDwbZf4PzHcaCe8FPWjpQQ960OhBGG4M6GEPwa2tb4dbW988t15i6BA3pRdbYYtXP8C/I3kZCct7LijtXslvTHitVd/W2MshUj2/e8g07T2ubjURufIC/0VPv+1ymXz94G3+nJpyw7rgymzFGpMo4+Krsavx8kPC54amxqPL3ouwP4p6SMhvUWBOzcOl8llrrqR3PT5MM5/IhUrM+Why0k99Tq/1uwUq00v6v/FVoCnLm/XuBaBbXyGe8wFP8MQmSlvni1euztzxRfcu6y30qvWq699GPwnlztznf4TMJZ2+kIn+gfySpSx6CrB1y111YCsud7L14PGJVm3i/nUSf+0WX9irbrT6qseBB3jEFa2qfk+2pTurahSpoPhMSewIRn6d8hivM7A7/FhpejvXoLMpVrIsI7+NddysKfmxUx5LR/9pksrhVuJLP6KvcRrEZI4pfMmCvsCZDuQSXOKzTreWmgWFy+Wk1pJOUoda2wHluQSKEt7aiZJS8CxQC+nCsyA+LLq3gUGLGfRPd6FjVJigSvpapgUmRy1LDbJjM7TdzkTtctvHdwXueABusQzcUVA2ki7HYkshIlBU+L3AQmMTrDcIUOMGXrugN8I1ghw+VG8gxaogiM86FFAxPjj3o7IywFZ4vmXYwt+n+EdYrzAc5E8AlHR1OaYfb7qzmmJi8OSLSYmSv6y5GfwhGxkfnDyldYkhACOnpIaTWpM0dMsfaBj5UsAHI412eC3XMRVUl04GAN2nuE+9q8mZYM/EgiMjQ3Q0IBEDkmiAq0tUdqMJY7KQDk1dAs1ej9ITtUh6XRh0EV4DQYHuJgfbrk6r3xdmUocj6HbzMrLap6S1HmHEU+mNah1AhKTphbns5xVE0mWDFiWiYFcSrDcjUcW1KOfbXHwsRFGOLyDtRB808K30m4sAo2ajXBxtgtF41oYkx+uN43FUcC3KuUXmSwlAtqvLst+lJbksdlnMdVmIlrkuxzJqAhAQ8lSxRpLOjympJ77zeCLQ2c5VrictrA16xCQHOT8BltBSsAEcul3TrwKpnMzFL1kSv+FwjsFJ9oif1Ib4OY+dY6270dbwcBFuskuO9e6AYcR90h2PUh6JBRIXf0ihRAl6Q+80FihNHUadQTNUNl0FFSse2twwwQ3LFCGH1iHD9QXqUVQbVls7g2IjaeXoa6i9cdA/1NYY6IOyoDfp0lWWXsgwCAWj33JfNaLghPbDZu4PAsVo2XJ7v6TA0yC3r/4QlRiAvoAh5J4U8bRVK7xeYHjuQYEj1TKAPWEmqzy3q7lr6TYesrg/ztX4RNwpdGt6Y7Gqp62Www5+uf5qihzeJG+yVlGxp7P5aZPT4QHvjPST6pxgyTE/UhV08arLHpRy9tDkPoHolRx4FJsr8ayBiEybUVfROFSFmzE0lPWkm3UnKPeuG/UNscGK+pywXukDuR5UoXhZH2NOlGCQH3OESqQpJhs83XBtSl6Sjw2kqL205eV1EuZkNm1Ul34ihuV4c7HsjDox31rSpJvDkaorjLoGZNIdIAX49ZiAL47VGYQMxsdKt/zjK0furvhcxluJrzEffuQIgbx0CkmLH7Re1nl0VwxBdNpkMbZ5MwK2I0K1cYQrK3WtRval/xFp5ndF03WX0tEI/g86C3hzDNhc51eQzivgRWTgSMYZumjGHRJaprDVFtMYj08xagKjMOdBHyJrw6nHBFZO/JjPN9B24kv5m1F0wSVNSq0KymRZLRu7Rrozcogucp96Qh+7kXriMKdyTGvMtfrfk53yFCE5gBFK16syqaI0/PUdLgNEG2QYBtOIXWP/JaPEbgcTJp1VIZlcTXZKxyNJppwbnphvmIZkShnQMRI4pS8tCbwiv1L/uZUMR0f6uLnBntDHA4WF/auWeRjDTAFDS/1bAkhjyk25xBuf9qbc7g/2cGUjFRI9boToidZGi95Y11BSyl7C4l6gknPERLpKSVT+iQYKxkaj2y8aQGd2DtTFUZrw6TMykBnxa9Pz5zC1m5WpUDY++iGkUFprQ9p3vgdpvnPxzk+qnbHaJbvzH5vJzj+l4UQ/bt456OlG4UbdvHMP5d3Of66xohW0olHpWHetdGj9c6oek23HNxsxEFnkSHJSlCOHP9TMT0pplu/8Z+qgHvFSBEkMmE3SejYelcEbdAClUB4+5OEFX4eH1+7pYQkPy/14WMLD0X/GTP6fZXj70fW3cRprSQeNLR4XbTQrXWKsSGKM8B796BSFrsRVeaohJcp30Do8lR9voblZWeOMaU/qNqHu6I6z5wsGY8FrGoXkDqnZQnvdtlOaVQjBCj8OQCH9bsvYBElkWkvzruuYExQ/qVndqCuZAlZbRfNg+HN0q2fqg3R9CPmFMhGQV80O8p/sy081h+AgMEUqT/YbZVJp/SGkvLcc6MnytC36QS0WBNUibe03JG39IX/wv0wUZmRE0Zv/dMYfutmPtqhKtxZ+HvSHjqrN5pBEapVQrurV2RhfwX6FYMJKEwHMBfoIoIwJ6/NdOG6cNY6HeLDYpYNlgsHyteKKwWK/IYNlDtd1xrXcoirMirtx/SaOrQMYSBhYjP+qDLMDa4I+wqfCL16SwAE8t0KRL6+jFLroJvoNt5tOcSRhxIiNardo17iCsMKUOoUlnU22W8MsLzrUE2XH2Mys0L1XVGOvY+1gmVjkQjlWKDjnR9fd1l50RWPPiC0jtA9CjYUZFmaQEb31aAVmBKhHMAN3MIp5UG95cUNjFVrxqznS2sh+LLsgse7jucpP4FdR9ALWjNbktMeZCVtgfdJtBehKgmQYl1atdnIaIhZLtzQw3nbPb7jERx5KtQgYnyyXk1pLOkndgDTjEiiSnqVU+i4ag2phW1gSH5a9SwvFu4EBdBd6RkUaVElfy7TA5qhlqUF2zng7k7XLjR/fFbzjAbzFMnitKOOCAW3GJUKb7YUWGqfB+hQharKB21nQG/GykMOH6lNIsSoI4rMOBVSMDynTVKYDbsbz7S7cbGNFMbeCAWKP9B2bWtFK+sW4Ju06trOufSqo05EEaRFmmrdR+BXWtqgLwxy6wCDo8vN5rcMvKzPphhEWKKzuj+l1G06Qbml8JJc9pXZhi5ljHad+sGnPqIosABcvtEJWaxSCSIO9ioRcq7j1Yird9Kj0PxYq/e9WTXYi3dRL6PRrhU5/vNDply6h082QTkezpryPYXYJX+5RlzCfPjrfMOlDX+M0yPmZJHgo50ePaoo1SCa48bhmolbEWHooJk3HnXQzAiP1qKZEO6lM/NjjFmS6lFTSYdSE2ko6FMl9G7dLkVgrlSLY11HtpaNYZkzBPLqIzJtd7G32kWWYHhFMq+WYHpnDVNoJgoRpwYaeDUhBLSmG9c0E3N9MrxOLVlBPDpHgCsREFZWizKEJdAYtghZ4RUFrEX1eLKfPdaTPUzQTHwr2SH4ntcefkx4k8ZA/R7+MOoZy1xBDuSBp8OeS8PHxK2WmpJjnz8WCgGIysyDtCHQZPhiFhfSYMJvQ6zKRrqhFgj72RaD/yYBA11e21wqBTlrnCPRFqVL2cj0NozRdnFGJtO+l1Tiq4aqgCYy4aGJHi566Va4vWIVc52Fo5HNiMmoEorE0kV5RjwquCppAisdZphhqEjelVRYGTra4w0raxw6ddCiDpZj14J3UCiiSzqtxUFTdxDcWMcn7aq0nOBYkkPnQzn0Ldc41kjFCnVPhfEgGkSuXRC5EJlkWOakKmhYS5xTDqAKZymklfT2K64s54hwlXb5hEAyZc6S21OxFnSNxILSLOgdGgnk9Nih2AiMwG6pvxtzBQB1WswXc+bWRO4cM41AA/iXc+Z/uxZ3/GSplNmLKzyspCtx52nHnKQqyAXcuyzraLeHOfy03Of6m4yL+3Oziz803jD83V3L8UWyvnJI1CAsYUKkQ/hw3AvqQP0e5xGhP/jz2kS/rQ6LpgkUc8L0JdAOaVhrzwjoJSTFg0EnNYgY9NkffQnqi02UMeikMeoF4DRh07jVupZhCR6dhnBfzFDomF0xEjwoUeh8FodDn4S0jhR7Z6jyS00KhT/wwoNIcSA8o9AWQj3qQr7TFMg5dd1hkMpc5spR6ZCYpj1allAelF3w51Ud9Fh26fFrnPPFRa0jA2IJyokll1oDAyE9gc+kRIllHssiWjyTgGJOYX2UeRWknq1CGqmSD1GPo5IEtzwfpMxEgRsPMmcCHWebAmrnMmQwyJ+2w00KX6110+WdXSrVp8Ff+5khzqDFMjXbTrWqLOdK8ENJc4JljzYsI3DxtDpg0KudocwQwx71gBlYHX1A3pM0xeQpt/slcaPPDQpnTxxnIuGW0+XgBbTYByeyENp+nxoh6TpDsO+s7/6lZAUk26UgyulG4EZJsTCTZmIyrsGmbLCbJaPCDJBPrnMfKPFlGkgnrxZK+YJ56/+7IABDDF3QAZxZxgPtx79I93RNudR/uyZGAA6k3CqSeIwYPiawlETTmby6ixaZLCSsp4UDluVO1C/ReQ0qU73DFVvrkpjBqq2ucK+1JS/cuEuafyDvC3IAwJzWRMO+4cvw46F0kzEUSOUZT5+qQMK826gMyC1SBMHcY/dWZ+hBdH+4IcycCQpgfCkTvYTgITJHEK/sNMRPmh2u3MGEtx32FE7bsR7RcEFGLhLXfkIT1h/2hwOpiAjWPatUVZ/zhm73bmh0nHfKHQewelkhVhPKBupqN7lVMtpUQ5hHAQqCfAVgIF13swnHjrHE8LIcOS0fKyuKRsg9cMVLsN2SkzOMKUMMpxLVzoH4TB9ZBjCKMKga/kjF2cK2DfjWw5YbZ8oMTHTnqxkW2fNSx5Y6Nap9OrFZ6rD//D22KBzqjwJaLFfNsuQlsOSxji5yUC1sO57wbsuUO7UUosuViht21DLkAtQtsedFjy6+NbLm0GrDldBvY8vfkRhN9ZpYw5mbAmEOrIXVgJ/GV0nrKlDkUGp/Sl1Dm3L3XUbRoUvj0qMbIAxduPK6ZiRUxlh6KSdOsk24seM1HNbrPi2Uet9ItF1XSY1SF6kp6FNF9W7dLkZgrlSLY11HtpaNYZkwxs7tYYHext91HlqF6RFCtlqN6ZA5V02fGMqih77NBKaglxbC+yX0u0qI3FYsK1JNDJFhATFRRKcpSNIHOqEXgsj4dwjWAHbaFFib2G1g1dGeC6jKqlmiK6s6h9khHNxGJjN0sb5zasIErxUnBgzfgoz5FXkx5FAwp8pSHqFDkRhrKe6lFR5Gn6Nhh5XZCkZdUJRT5CEIjX9YahfKu6S6K/JTSijbJ839SIPyVp6OKZ4Xq5eGvpf4De/8CKNlR1QvjvZ+9u3f36X3ePafPzKy9Z5JMkkkYICSTEJJpHDAxILn+9cq9n94bTODynTlwE0Q+rgQyIQGG94hRkxCZM31QwkuDIB7kkUFRo4KOChgVr6MGDIIaHmLQBP7rt1bVrt2n+8xMHgj3yiSnd+2q2vVYtWrVqlWr1qrBJKk1IXtdXtMb20AtvT2NC+5JwQaxbmLDD/uLEIZnxdGTxrzspRf5SVoxF0DqImykBeTrjQu/akrlPQf0Wr81pXLNutbXbOu3vULLzv7OCA20gLy27ZVqOxaD9TuvRGnZvYgBcTs9EANE5/i8NMvYuZaYxl+rxlK9TIpn6BkV/w9bA4Ow7KCWVoZMV6oPCxg1PLSSvQ7fGmMiNyeSueotgDR7+c6frK5kb3q9uS2gIbW3B5t46Ss9Xxz4OPt9VWuHHbmz2PbE3l7rlYUHSt8XU5ydlF3d5L7a4cOqhm0V3mFEFZbLdWXSKxz6CXnW7hkcv4FlhLccRaX3eoG674IvBk8bM2wG9pZE1JXW90D8VepVEM1AnrM1R56DBt4r0JDv+KvP1vGV5gOsK3ldcBVwl49SNW/rw7Z9+g0vQJO94zv4cK1BHerIxReIhKja5x7DCxwuzmT/ZK915IHNdcRazC9tB+79s/T3nvqv71i6aLD3uT879+u//Vv3fYTNAj5r5/fefKj9wxeXFgLvgCsPZ2zw7pd94A//8Ix3Pmmwd+c3X/q7B971BBgbvPnGix9//53vRfCqr33iA//5v+/A9/+/l105lf78TyPoQKAORgJn6G+QvibyQ165ycveAJAW4a2yVhQhx9wsMdHhPAZwAJVvALVlfDTR2iugUKvBPzjXAaG8FRYoo9U8Vg27eDWPUi3lTljKUf5gyA1MgsD+8LKiARQ9Irdp+Gobns6f5Gv+8q79MOHRX/lNTT8qT6T393+Mg/1j+OWcX3z/m1FYs8eZ7pCUg7+FFI5oplX88gar3F/9T1aEHQP80oo8uvrI9JHoo7ZC7osm5x1QU7Likekj0UdtaAhc0MBO+4qGoa94juvrb5u+ylP7+jvSV/yu76ukHLyr7CugLx5hbuWRpYffU+0rvmnim4fY5bvZTxYM0edxSvGtwh7sfd6bn3z5n7b/hl1ceYdW01s9L7i2Mk0GA8bVaz/1h//1gj/7LOP8F2478zWf++x/5Ykik+Gl33jPD//t5t/hGfSpZ32UbWyeAcOav3g/jGxez95t1Nins50ZUQAsvVTt5HNecWCgloGckUxB5cPcnMMU2bwXD1YOp29C24bJQOG774rgcBG6ZLHJWTrGOzj7+9y+f+WW/n//6aNzyx/9z2jp06TwX+A5iDzSYwnt/eTuAx/5/L/e/mH28PKe9334Lf+YY2a/+wdu2/+Ml72J+46GM8ayidf07U3xoRLBh8rx3ROV/rRWDOniSXgPrDJVeqRUjTPfVgTsXatq5lX9bwFa5uW8Pc8WM2kP+LzF6K/dZbzAlHTxthtCtQanq4ilDWVgf4UIcX9c+LZnYVEZNh9rPITt/8BTNs3tuSr3yb2tFKENH1lhkMMABj9cnN5iLGujPVdWWkPBKjsdfMtbP/o9/+nvZ5+8wq/soKGOBzwz/PDT/vknrn5g25OR8/bkhj57VBA3FsmDX+HUhfe/5vrHHSak7v9/P3ybpJqUU+8tfvWODCl3/OKDhysp9x7+hfd+9Lqv9WFL/ZruLZWUi7/yJ//cfeGnkHLw/f/4ikrKGf/9Ay9pvfPdSDl2zTX/byXl5o//6NdfdP9LkVJ7yda9lZSnfXX/5Z//0lMk5UNHZyspX3jVq7Y++f2xpOz/u7/a41LCu5+ZvOtVd+4RwMy8pZLyA0/80Euu+K9LmrL/8kpKdNrXtv50O9xT8TmRJ7Ik77VJg7328xVx8GEK4bfCQvPLG9aOlPEtRsr4XiJlPGSQMg6aSBk/AkgZP2pIGT/SSBmPHUgZj1WaYvHQYqdAMzVbHei2VBxWYnlVw7ZU+t0zdoIdeqtd32EHJrepJd8Kl5TtGTyg/mGfx+aSXe7D5SXYQe58QCqPOBFA9TJ1dcF2/H3KX7eCanz2JY2V07lbx2X3RrPfmtfcNWIh3LXBgNkHqt8KE/i3YgUJqe7amv2ibk7U+rWZ/d09A3GWydZ1B+ke8dh+Vu3mL2PX4okXXdhk0PcDf86/2VdFB6APZwpI5QdH/pxEpulvBn5yXXxtXzYI2Okc6FINFrz2d4nzvtXYpi1YPIIY8hHHOy5k5BfJ8kBqLEveKN/MsKgFT94iRnjyfe8YT96z1fGEelMJGRz6gvCLL64ljd5ziNkHM6WesWdVobD3gbd/6Y+f/mNX8Hg39bhQsyuVb64irs5x1Ly1SBWH9Ag9lkhqrmRvQDmIiiTKGYPW7OCjNT1EeqpWkW9lnhwPxDc1Y97G4WtZed50QRH7ydfUrPrYmdh7/mXbzpp6zf0/QS54ZU8KpdYAx1WUDnLx0AadL4AV21krh21U+KuGuZzPUm/JUkvPHW+rs38AWHCucSeXfU1j3XHxWZ5X2nT18FMznnJUFdETc6X7jPmE9L+JcU8g28o6ZNP3GcWU7H7FWeBShuH+vf1og9ld34aspEoBhYemqenZNH2m54/pQy27/uWmuAvEHuRtprjs5YjHpo6kh7728QbEDntkc+2+fbjdeN+43XcNtfutG7bbFX/HcPF437j4e4aKf9dJFL+2rvi140L996vFv+8kij8yXDzeNy7+tqHiP3QSxd81XDzeNy5+baj4j21Y/Jk1g5AHXz5UuL4fxXfZNw2he33Au3h4vHSkR+zgGyFVETja4xna8z1jaA8EWZik0RKFSlA04oiPiHdWIupL5WJWROar5lLV9rujLMjf4vwUGiol3u00vcJQho5kOeKke1lTQWdp7y7vl2a/dtG9qIBCzaa5JI9XISQqASt8bjwIiQNMCPomgAmQfNc8N80tmybfM/esFmYvjYK5lMkl3W5rRFipKYRcD2TtgFK1oVk5PHh43xgzPjmEGW9F1hPNyuHi8b5x8fcNFf+uDYt/sS8n8Tov11Wg70dqQzVgSRXjz6/7uNZAY867mTtP0QzCk8xzl5nCKHVovg5Xi/eN+3U7anXz9STAdtdw8XjfuPiPDRX/sZMo/uhw8XjfuPhjQ8V//CSKv3u4eLxvXPwDQ8V/8iSKPzZcPN43Lv7mT1SL/8xJFH/vcPF437j49w0Vf89JFH/fcPF437j4o0PFf3HD4gMWNP/XITYkrNjwfQus1mavVpG1MU/Opp1hoBckSBZwVTnysuvVFwWFVd/ugXHzpc7J0jOc0ZlkUkTWkjGXaGPe/eUq/X7xBrzRW3/q5RXe6OD1GnvzUOxPmdgbx+a9/2A19k2Ifdjc1bc090bs4dpQt25a34ELPH+4El8r8bP7wWVpgqbqHRLvhDUeG6rxZ0++xo9df4Ias1r/i1w4dmA3I296JjdBPsh9RdKaPX32sze/Di17nWc//iPPMZ+73EFNTTYlO/z7ULBuFolfv4pXVUdVt3NYeZEHJ1nOE58QeZyxq4UtsPK7LELDF1mSvf56xVmfgUEee+jP1hTd+bSt/4uv5ikjSdmt12vs9iVNejvs7mdvlliNz/5UPkSD3qAHSLs0CRPqfdIe4IQxgH26z4sRxPr6ECtd6dnWI+F7dL9XZvdNdl+z+5r9Vn+IX4+3a7AmnhR1YjyAhwBNwS4KpTHVtDydPhRnP6/9wD5HleTgKC7VOUcemiTKhX72FmRseRsmUfxkf7TgGJvZmnyDyEOCHP0aDvoPIk6bbOb9bXgYS1torOqaPJgGTMZNASsowCriRGhuJMoWsUPjGz0vGGce3NyrAv6LoxdzBtjVE8EZfmC4me4qplEIFAvseIGFUtvmalT7sGIF38jKg9JwmjOxnb4fI4RynPebIoTWgnFALq2hkI0Yc9zT27bbMAhMkVpjQw5obSBmqTAKraGwhoFVlrQKH9o6699TtT+NQxEVn8KxRWArCLQC3WojC4ezozcYK9RyAqV+Q1zjrREQMjf0RB4MdY77+Vm/tJf9q6VK3MJS/7ba1I3aGEgDsm/i+0d/9Kp1u9EbnGD0Xvkot0LxWNqRVduxeoJ2vB0+ksb4xJfaQSXsxTi5KBZCMBG54ZPBiDEUcseQEQBDCLUh/iuHMLBDSKGeyd92QDY1etsyNugfCQhBkyLU6qqOudh9gqYGvWKLXqiVq/fxRUuvNkqhdemkWtmx5h4oBky5EqlB4YAH0rKfR4MW9CIqf1xdtOCGFKnfJlC97YYqqBTXvq2guv2GDUHl5tg7Tx5U4RCovA1AFawHlazJw6D6+ddVQaUTwgAr+zYB6y2vOx6wDiEVzsyUWSVZoWXF83TFg9H684M7kJjekDTkuJ/3pd5L+Vf+DIjvYNLbsJbSy225+PTEt7gAODislwZ93oB71IAjihU8mbbc7KHm5Vy1ZhPAooFFlR+wwI4bctkvojniziotPZel/dZyUZNX7B7UxRgWW6yybtUtfDX1jr8EGpBmAYdmENdwswePVjHVs7ehDrRStI9wYaULyXIC7EjGlQvksdd4WjKieISFWcawNtRkzrx/t68GvlCq3soxi0PD+r974JuQiQMiLTE5prsAkNFGf7+3pG3W5oLqSoNvRxbOMGan334wDa/mwvC8wjwvN089j0irtj6975HHhOok1SsJLFbPO9yZzOTgPmkpu8yTzDMzz5pmhOULXwwH1SGZL6YopSnYS5vmm2f9q1lpQe4AcG2xiLTjJRxDnMFAnJECSB//rVfMAHgNl4Fm3oQYxQ2JndEPJ2iCZn60h0S52BxbAbaPrLnPLclgMCVR82Vn+HvyCTy4saI2QC0ZN+pQir9LYfahv+eaJWlhTPGGjZshU3U+gZqBNJPcynzS4A61rNGiid0+4DfJX6HnCqoZLn5Gesg1vCmfWdf6DuDHY5D199NSnpFHMx+EbG0qr9M0ytXrd/t5Rhmo5IxqaLSDkS83YH3pwY9CVVYb7WuLq7VFmJkZPwDSD8odQp7edrV+lu8zDZCDHHBNwrGrgxvdWzsWqQj0zMVbylUR0l4HqfBJekkGtSofx8/0t+LEl4sowbWRPD2rpXZk3m4DML4H4LpdmB93OOZl7xGnNXVWr8gTJZQN5EmgG40H2Ogd4pBQbtRkdyA/LJtdIoBYhD8MfmOdZuILNM/kzd6/SY/AfFOHOstFlj2AmHwS6ufo9iRq4RxsGj/39KwJkGOEnxqIhanybQVdN/sQDw+PMvD3mUGOxjIuw8F7DAouzcVQB7d6PLTraUVt3zJD1VDpmug1e9ThJyPIBB7AqywQHTLbumKauPXTBIhZl30dqZ1qQKgJNGJCGgFcoIbpIlfJfJoU0fd0yarp5l9u6GUPIpft/2TFFJg8Jk/3w3wG8Rw4zw+Bt3jE4CM/NM9VfWheZR3O42QKT9FT1GRgDSgxEuHT9/AZ5pRYyOPGBqhuWmuFgugERXmHwT5NE4pu3MYpda6IMVZVHEDebj8QmyeiedmRAfMwYPgoZHDIJ8ng/UJiGEIAkwijWENVKXYHExzA5hqYfGikYNwU8bzH8gsoas8oBlaBXRYUyr6h2MSADTlyEYkuZ73/sRp8HgBHq7G7XeSbykhyke/VSJ4gdvs/lR5tpCzBkTtdIT8xpQKs2dc6lr+umWViFAl3uqLaxd2RqMOVMQByGncM+KGiua+f6a1TD7biKDC34fAlAslgMMAJgVnIdD42jfj3phtKGSGoyIfkXejKxyR465jTZCMpRnqKE1ewDCqOXVfax11pn5TgmzcqTT9N+1I/sQMuA8va91LKP9fkrb2v/4dfXfmX3z54EZSnyhe+sdgWBkRWxDrYlaSPasVQILjBd6MkMAZAOsxklEoTyqUYOBYdA0mAsUNNMBR5Bg5Dison3UI85YKJC07rgj2DT6QL+WwlcewnU9xeNFAGbQa3XQsMXtsO3hzNlYM3q4NXaRDgbaoqZhE8IsH5pxZdUJu8SbMyHZtSGHVA/DD7rEo1Zg/3eh7TpvRCGnE7ustL+aaSdqGwTZSZq6DvzxcopozSZZgxqtbBxUsdtHATZizXEo7UQhmmKpdVTtWsmKt4gQf699jT/SIBbxd5ZBOZzxzBVFsipmiaejQ3WGHKM4PSZqrTQPYQmS7xk3mHmz8JyBwVyHSfWswKZDocmwDW3afiHVRoDtHSkQ7NKfR7VxbzvbyD2ogDHGs+MgDzQekyjlszPVi5cEAdfMmtK6b5q+nD/EBPpq/srWIqumMyhALWxrmIsyYUPBtXckuMflYbNDCAG3IMzKyINkI0VNlXtVKlnZg07SH+RDX951SjP+GhhspKu3KoGFDC7XAAd8Ere4MicfPLBa/i2dWSwXKCgl+tx9h/4K/iFm1/4AhZvf9Vf8lcusl+TSZywIMr74OcOyy2RHkxXQMVcjYh1b9NkT5Vr9eK6SuOb9vjS+IUX5oT8NKsrmvqoC0rns78m/mJrh/Es8GaK3h6rNDCzxHeHJvC25FBmss6LRIGj09hOUDZl2+QHoHdF6agzpsOr/DxvM1DU1V8GGnnZICU8yzb7LA9b+IBUU5d1j5tJJdu9hh+qt1Ac/v3+kt9T9ujmy4xvJm3tA33Swu+KjsqXX/buEpFnCeklsgdWsog+AAhdKMa1IKh8uwr0iMUVrT0uj5zf1pa0eDsKlqw+ihtzLK2qbKBgnV+1cFAHvXHwbWYYMjeDS7fU6jKMmZGpaWjUWkohkkBzAvBGhxUyzgcw5gsS/Aorpawm+LnUh2b7Cv4wVX4V2si8l2l43451WGt4RJ9MKAU1Xw4Q6sTP3bzA7hzQe2ZClopYjdq9rKvCmBCgfqx2lL2zzr0Z3JflBId8/MQTdcu4HMdOEfTodisTRFUbGqn8TxgUPJGfSoQPMU9i3WQIWRfQ61j0UXu3+ssT8rLRwPMd4PD69uFcKDTdmPVISwh7qTmG06t5rifYYkdPSlzn/2974Xj3HzqZLcbEyuqhrRXBdPmuCdUGfBlJi7iLC80Tkr6NXVirorPECmrMy9UwDJQX71B/gS2PchgpEQBRz5gpESRMJLZv4hALYSEJ9i4llBrQZvUoLH+QGJVePvyyG66IuSzwnQUia3U6X5ynskP9lXM6aFE9cOH81R9hHhIWnb/DcZFJxpkHWp7WG71aKkqNvoc8tbSD/tBKATZwU9b6M4AjDU1iSkiFE0eDLKh5eb6aaCmW/TCaaKGW2KxGoL5LkVjjCgUSIHF5yyx+VpWqHrlkEDtrOiOMjZif9Kd6MgpgLfBKUACvEB1/FfKRZMxpwBFolvc0DVopCshGhS6BjkR5fc5DKfStScFEJB1+YFduDrWTIzsJwD2/PL1ujMLyoWRvPSNfmhEc5a9X5kvkd9RiUBHhNS+3Xbcs62mAphgJGK5NBMz2xPIMRRnj3Qx8ftrc1hgA9035yr3BIRH9+DiUfFylPjM7FcQIyLLSLc4t83zl7fZ7Z/E765Gv6mMpmq0bnTUqyaQGLXbIrjLFiBBeo/H/nPVKTA42b2X/PKHbv3yn/7kRXs/8XH8u+/i7MYbrNYMtuwihMvOC3aTxOyiWnkMQggLvcB+SxHFIjQcoQlmCtoz0i7jGIuH+RJMOriZVY/1y0vI+zR1DJgVdbAQIrnF+d6PL1mTkGqQpjwmudx1gMK1CsPaY13UZ1It/VgYYH9XPVmO7PmvWftqwqfmMR6Uy4q4O09EfoPejGVOuiD0jn8DoZctJ9jcNZEN9bvCZrn7AGHP8FvcCCRFcC6MjXf2FwZRIvlKJNUl4QZ0ss8gZDwtFgLKXYUxlEgqedMr4MQXRXyr/EVgfKxqWJdiKTy7HmMqlAAFKcpGmEGLnM6PGYqwOWzJI9ghbcJRVheh0/0uJM6I2wHkKkPk1Kyd6rcJbN+z94v/aW3LK77wRxdTlL1cCYsI7dVpZVY0tCtdNeWT+9bg48GgCEXozxsw6GZjwYU9uVD1e3EyDA3cLtgiLHB4Hh6UOnKrKxBnmumJnmIDLhfN4/7NAeOgEUy4PiqIbhAQRRVFgfQ1Pq6CWsJxtDZEi8gDuzwouOwdGND7ZsXQi7h5DcZjjybvogBAvoQCeC/nBuyV0F2Y/XskCGzYjdCDNX83f5ggLBA/pwJxChnPAOH/tPY1vk80Cncli3/2WsPtU+7j0c31hnKOw5ejzosrF3bB63b9zRv+109cBG3HM//ft55+Zu8KDntrfEHoIaq9rHiQhr5sVK/DV4qNL7JfVdqnujDZ+82pSiCyMomjAIIyEAqh9dxjloZoAiAoueH5OrhLTx8AsKDLADuKd7W/u5Or3Gk1bJwaSPqLjaZdGDLdN11bGesj9YpHZdSVVQW7gYlU/K8Khhin5DRHZy0Vscoy1MWYIxyy+r0v4v0LP4/ws8nPj/Mz5ed94RLjpVjG+CJvcdo4ZufnBD9v8lm+xs8Vfmb8PMDPSX4e9WCXK5/i4N1cyrRgP1bZGQ7dzjGzmglRcxw8GEkV88jPS3QX61v/jjroU+x2iAji9pN2bdP5we11rFx31PMFlBG43QFKxMcLfY82aVq2JmtdL/sAntot6mW/jrfK9x+T77sK4u7YaQNEXzjXP+pRiOpvi4pFll15NOeqR3qmybdHtMhUkdtabHL3R3sgcTPuA9SuIBFQcaN9HjkoOKCMu2Fhg5frD2rTywNLbQK+BSZMkWTHHPsQMnKnAO36EupCsCPCzUnNBhHnhzVbTWvOPmKKz1joC4L1obqj/p0xcRNj4tojcWoqwdlhEFOKm7iHsZrrGgyKzQMI3DMFU74JXT4W5Aw2EN98C+LvDfOtstD3167DdnXNXI8mLZ9os/rGGAyI9t5w1+8+b9d/v+fiyg1N2kpbaBF/l/XWyptyNsP371khblIlP1q44uQ2A46Q66WcD/cTublk8OpOC+vWudxaE3nEgGOhEvcmEzft4kqwpWPimpW4j5q4xpi42THfzo+J6422RWcZx0c6ZTQv5N9Yl+qyLoEi1N0adFGV7tqzJFUCHKeNN3z+lKYXy15Dt4T/W2ak+yosaios8cypDzM0evyCdGlM+geeqFuPaJtJM376QKmvOqM1tsSgM/nGMTJ+xFoLBcuFPT6/CV+N1cGuP5iCzyQ8d5hnV7XIuEdYISkAGqv4RWeS8Hsg9D8IbWVx6r8muz6qZT9zwEDXgfPfIj8dXtIrChDMkJck41m60QVTTjXTU2Pk25etm4BOtRJrMN8YUYB4nGpsZY2IH2eu8BID3Vj8XFOkbLKHg4mfVa2WaIMvvx/AN4r7FBqBIhSFYjywdnvKqIF/wiQHkLVkEa6rZuFuzbWLPHuUfv+d1+ErZJRNmL+nqnQB0ZXeCpPPt8vn/iLYMhFLFU01qW3cjoO8lC0uUu2tdLOlnU74oQil/RW3yDhJBPeW/QUYLjV9GUsDiIsPRssFLPRsK0613K5OiB9U1/Ux/0WoGXFdJw9gkLyIomW0W2kyAEj1Ja5GTJTqoUtdAJAHMvp5GxgLDsmTNoqTeGky+oTQDEi/wI9CcbLWooDqgL728+fQz7yFui7B6XIdBquozWSyrodt6LFs0yPRrJF+qPzOVpRoSffLODaQq1EdJNRlP0jAwOOr7E4AU31O6/AqyeFMjsdLB4HXGBUBVaZyAPngInhtCnRWBzKr+3php6bozonWr7m6lI37ur8PkLBYeNAGUnGEOkoTPhHm4RfV+x33FOPr/TiTrbyphbY4NrDbgsAKoIUMyVGx4AcLm9GjDASqYc9JJAgd2etwzcOnprPwAvM92SF0TcqGpTFPUSlCOa2+eHdawjJXu6S3RHVnGr7aUQtyKURLaOX8qkq7Kyh/XSdAWM2WRYlg378UQhjTdiWuFKjD74rdmiD9TMzGM5rXKWk76lXOqaqsP87bfubTp96bnj3J520FK9TeJVMNEsvK1Ue4jqplvy442VSe9XJy14PW+IAkpubKSsEGM+/2dPcxKOJhuxtgpLFl4CoGJCUCpUypofAD/DG2ZQNTUMqNeMnML33vX//kTczrNo20S5evptygXFvNBfX36lTZnbfx2JlP4EF5RyV2GR4z+WR/+IyPLQRNB3tcRIhjJZqCqHBmqZgVf2iq+nQdxnsaIyqWAzOaYZZ46EMZoA4O4PmzJaUVYJgACJog97JyiNqVV2oNpa2Qv7a6wi/RVW2PZlV0CJOr2HNh3CG245+SkoewGTPNkMhxIhWu8PBOAe+myDNqU4bGQQlknTR7GIQ3eQrDA54C8VoF4tUKxGcqEK9aD8Tmow7E+NEA4+ChwvEHK3BsAo7NYTiqk1jguCDmLzXDFu/04spOr+Z2eiULAznweBEQlpGqcY8yfM6e1Tc/EBRC1eM1uRIdQu6wG3MH639IoUjydnH5Pod3LqmAPPsMNuhFHVUiVhzlGTUTxNCSTAaNkQ3jjMb0gyUT2RQ2IOfOysbROqtVl6HiYcd5n8YwMurgVHsCdG1Io40HcgKs28DdLZzAajUxfHfRXRVQ0Tr2psqktfj7eJnC8pR/XTpMFPtLw1nMUbfm7JStwWG/Yq3zi0EdztcSNRdMhCkVC66ptks/yeuqMydkW62xeeTzGAkgFNMGK9kHhXJ56rl0Yok8ub+ODXTddjeWYVSV2A4QSWqlDk2BnwCyddqiXtCBWzC0BW6HeAJ2uDEoWIxx4jHLmebUWlsF0DTDlcxxfR1pL1C9Tu2rrfnnCWlo7tnm1ClF40rhP/FpNvLaEvc4McRcj4eP/FW14OYDK+bQmTnqYNIAUDJoXcRwejFj+zQrEIObI+G1LMT7L1Vb5tCkgrCubvU16nIaM8FwIL8cikEO9aUXo9F+Rd7RVWGCp4yC2qkGAzNP09JVxbQM55ptjqh8WxXuDkzuwlOlJWnKhECLuq4kEIQEY5RyKzpmPR++ZTvvgl108bK2DKGIW+agobgs/HG9kk1QzM+rhch5pl+20KZw/3rSX15drXiS0rVVaTbNq6kwVZJixZzeCoOsS94KgKSsoRm3ujQBE1XJ3SxlNH9YS5lE2iSX013JM4ginppPYBAgBJoQa9K6o010oh10+9kZUJAyBiwkgcqUMUwR3Xbpt9OoJdKxgP++YyjmX36XYj5SijlTpZia3RLMmfUEs/D2nvU9i1/4m3MXLhb7L17ZtyN3DgaVbs6iCi/7R73FRj6Mc+WzRqdLGGrU4A9OukDPFSjaV1IgR1nKPUu+0PcBzwr+/ZbQ8XnAQuf/plE6Ps+VbKrQ8e5DpeObNqDjm0bp+CZ0ZtMIHd+kdHze9qn76NDx2XF0fGYDOj77qNHxmYdEx2ddcGY9Hd9EkzQ/QsdnRun47MOi47OjdHyWZkDHZ05Ax7uU0ex6Oj7zLaXjr380r7RBV4PDXvbnr7UX2CB5y73yZttflAm5J9vkdTfbftf3wnE6LAQB/ZLVYVERiO6D3uXJhWQ1Fn2HJ/cWshUpTDOsVDO8dSiDmhrxrbGR/k0epAl6yBhAy0mvC4XuC/4aVsD7l2PApFn31NY1S2LvXh/b3zVc1Uy1pu6GFdlaZsZVkoxEOnnBt/aq+2ytj729HK5h/4/AavoULgOrhrmcJRfL+VWf0O6UgF4bT92FIvKMOtVvScLzvGBUFFXRRBIpUP+F5alvqJYKKifkgFzY/xEzRAH70isCvDiEc8pPr2kk0XW+7Ps8+XP7v7lSS1I7JA+RXj1FfCzBH0IiJBJvkX1TNce1OV05RdlVVUegXeiMUrUcmWnLYsaW/kFTKTBqfjkI2w4c59XlfsokPz/Oz6nxZZil2hN/5lx921P6AkW06oUPMsom+bTE5zO2lYm20knZjOemAsRrhmZZt2UmVZcuiZGxaU15YrsMUSYp06QSAqi+JNlvy7hC4xa7niMBsPyQYOk0zYKrmMh+R5rU0II+NOcKpgYKHlsiMn1IMulHNsuHqpXWaQppGm1V7WiyEvcmE5e5OFWaKVWtAUZtUXaXHstIVPa7MrFbooxV11zJ0khtCdCRf9z6JBrulUsCWBeA2nPw+jgtwJ8Wp/N4hGZEKKEZGY+B1ZRywzDNyA89Zn1rUUv1ojFsRiudd18GibHrrCx6XDCy5F3tIPmyfyw2qTsuLWd2UCxkvycjhHubnGacuPVolv/rcvHmssgcwLUgzrns1wPWEy+6e58j/z538eCBoB8tZb+P0iAD7uKLboWRWOjrTZNpueDVo67ydInhOGdRPMT1GjEwzZ7V9g2wxqoWGWQ/AArqUIFP5FpuAUOtVbTcboQNlWjT/Ar8SwDVm0Yp2EBPZqcMeKgaNu3VcZp0IzNj/JTAzJ6zFLuVPs3zxlM+fOnD5EmgtK6q/anT6bAQsyphe7Mntjae/C9/+ul/ueFLb7/liNFVEAMSbhNjApv2UGlsH6jlDOllf3JDecMTF+OC7G9eIydUjoe7/+LVBwKwhynorvci1m0NqIbWgrSXmSgwF8Nq6e/X4w7vHkF5/Zf49kbsMa/stTmm3GDjmGA92h9AOw57oStIdNlwybP/EjRBOFXywXsYfewo+zvlPHAIlQFOOj1hqyzCbeWYQjivlGL6BK7Mw+fQgIeL5wYgza9NPSsK1TJinuotYQ61tEl85hlil1DTNuQTrsQOctwYQOy6xsQ8lksl2HjpdiOWuYjc6mzqM1zbbN/L52hGL8X+WgnIgYM7Ta4wfz9/WzHPk4y3/M6O+/sfnJZtCbdElsoEe2VptEdNbvGDtbAmkw2Fb6KFBz8nLmsl/sF7vHxBlMkKjIreceRvOFcaitr1Nczph7mcZJCH5FmaZxx4KeMnZhPSyQcXpGIuqnOfpvKa5pVO4mPsknWYcPUs0Bupchc16EMpxN0AlpMvZ10xAwv5TJpYxvNHlgSEgSmvoyq4DzZ83Zdp/wLpml/jbuYLdk4tCCJUO52aGNvVGmhAzVYbUFt2DYE19phItM+fZ/J7hRTfz1DpcOnaTX1BI6S24eL1YmvPjJmnr4uAkGnMIvm4vngNd+8Fcut1kXqIYkSrxvbQumsUHn0/Z2Cqg5wZgKngYj4IlBlQT59AIHvfj6ZV8KYvemtHFxkjPNeXFL0p77e+7luyhfis20J0qzuIz51gB/HT9cxeeUkMQ+ebd+8lHBpLbpR12vsDojR3dznBkj0rKvsIsGzFTFoqFqrzSNtkpnesWgZ5XekkTuWEIMD/ItxiGIJQ+QJgAUFoU7iGS9VreQd3udziXL3JVtKGaUMbZiggm+EoDHtPrBaR6nrmsxQZk/kRKIgevlepRmcFR+m3sYlCoMA6qtE1GLgJbI1SjQVQwIQWlGr0zKzqUg9Uo1GZQL11VGOav6GeYO8mIGXDUI1N1EDyDEXDVKNmqMaMUI2YezuLw6xhqtEoqUZjqVhQqrEIWrEAqrFYoRrqV9RO37ZSjbRKNRa0PNy3KalGt+zfQoVq9OyF2956qtFzVKM3hmosUFOoxoI5sx9PNXqGavRORDV646jGohmzhr5uBoRMYzavpxqbaXEM1VhE665ReAjVWEAjJysyt0maos0fFE1GWtQnW76fMlcFKVQywXiYR0MEgqL0Nzfc1jN10Ouot/10xQDeTXhhbSg89HYqYtQ0nubEJVZJ1v3vO26wajgYWzRFFY1aBSiOU3O572LoaKL3BI2jd+IzyZer6S0kcnmj6WTLbmXvKiPVdJKvnyNDHpacoWNpy9CKYbCGUt399tJoE4SAgSpyVM3tbTFWtHQ/DdKn+9/sE8JM/mPSNN4oS4IXXheUlxvOq9z5g7ThtvP4GbEhkfOqu9twdHfL8UP7W90Dh1ZIGCJO+IB6/+A8NDcPEEdVDpT1ilZFI7ZqmVv3oilIDZQHYKLZJLNh176f/QHStWgKl7DBvFxuxlbwsmnU1/v7CSiotFw2TnrJANPNNaelt3/blZhAd8DUlou9LGwckp03wbtzWne5yIyWU6haTsN3QZrYSsnQ2ya5SyAdag7ySbcDm9I7k8L8FdO8yKon6Ak8Oiz5loto5SI0oM6q3JQrlbUYi3cZgNVxe6AOFbjsD1VROo/4/bbzeAkCQQjcpU3KoATXWuaGSfMpRGdm9V7FrJxgzFb644IdcewqDgMrkVSHYtScjEk+b4somGAPA6VTdMFuNOUucEe3TU3EdDnmsALrxcOG2/oeOoGSL7mVZkWdXu4I4k4d8aMD1Xp+EAaLb/HqK2qQ9CqcEhH8mz08VmYFk4UbLUl6dhSRergxJWgQovZdFFpmSN534z3h90SpJZD+ZoG0HCeBAMY0jY/xnbTO4O6Mea9ZDyX79wyKJp9yqd+8SEaeIuM4t3MYqLR2WBVca5b50v2pjGWe4BHmDXB2kyt5y97+bFCyr999nr35merlocsVW3TPI9G7K7FvKmOpEvtejWXSYWiQk9S3Dt+SvjsIYLl57Omfx8AtIpCn7O9VMslWjebyGM8DON2WO3SLIDK4uhCCwu90h3w4uwPZ5pBcMUnKE7+sDJGQvxhYgntXpSZxyRLJFLT3S+AwEZdlEjx2FY0hkuC7IPwHVd5cUIW3iVxCaYL2iSAsoCaQRT1gisKlihcC+dHBzP5BONYYKEFIToo6HNOQj5gu4YUBZYrTEU5wIcXJdyoQcRdSUCT0750N6KK+qhePfEJoSNSfvttnnzJV98Twu0LBh+EzBYz0kE2lZPjdOltRL3ahasAGpZ8XFASttOpn95vPTII+tJjwFvflmJLGt8QVeeK26v3FUJnhQeHIEfTGnyV+9DTDzZohGFKfQ4Za+lqoN8d29czcBR/cLSvdFA4UmDFedVgT0YnlhJDqfPjYoAZDC6YF8JArStCBzG5BzXLTPk8EWzCROZ+2rSH2fpwsJ6vZyzHZH8ta/5Ugdut8aFt5385vwQVGZ4E9WOVcHrCOc3l6sXHsPcY8cnccR5b6ujRDmiSX4yCRWykvGw7yBpZGvaILhcMxEqYyTu9IgsGgkciU7LeXshsetLpB8QCrEM+u1ZUVc6vxixcj0dv7ePn3BZY/ei3Z31rDMl/ENaEv7rSUE/G7q9FvKqOpGq20U+9ujly71JubGrn+3qZG2u95SN2N1ds8j4dcRReBHsrnkTPlaq5L9TOKsk+qVbaaidotmTVWt63VzJ8al1ljwcmHVfNT61hV1bqT+wDXipUraY7eaDYXmSuUVuuuvMlAK5nUG+Lky2QYZJ820lwkH6uVuu5VHVa0TX14rqbLI24EAtuOEA/l1YDrWlkOdA+lQkX/+iD7U13usKRAoI15gKodExegsmyVx8FHXaVSeYYfMY9gLCU+H1AZ9vSlDkBXh2hR5RIS8wE1lH9pj58+Du39ZbWiK4djNXv2fpi4DK9ytaxiFiT7EtaZ9Gdd61qFr+3zH8XGPdx2vd7zIYkpRQ0wdFcioae4SbUrh4gTH5qGait2pTLuqNsvP/XLT4tIyBJnj5SKXae3yEe+h//Iv4oC6C6VBi+PzpW0s7RamAel3cI8BGbjVaw+InA7AkPENHLBWDw0B0PJsaW1wDHGMqaisaW1ytn1n5snak3amEseJa0NzBkwef1j/2YcoWV/XjFskeCaa6TnQ00urcnlul4krm+wX9RQ6lQ9PZXY3S7yTWUkSWRETUpAuMlbXsPNlJVBXtes7zU2q7TrQ/O+ztHSMZCNVC5eusNL1RhBEabbobtp6IChokBrHdPckW6UQsSPz3Hg4/bQTW2sQHNHB01KUHuUD0iwae3WJNZujT1Saxq7NX0/n0BX2jShXjdbI4BK10FJxxKjHsDORcNwZl93G15q99zlbRBt4eOFfUyEoTCLsWwB0SA9AsXp+Gr2l/gQ7riawGwMbCpMv5r9AVSPlodJdbaYrFeURy516HXzfs1w5noAD7jOgWaDPxf/lMFYnrqWfVnlr6Lso/YBg+o9BUdZ/suewUr68iDALbFymtG627MJidHv8be+Ir7llakKIUGvgIPblyAdmlXnVkg/MmsCR23gmA3cx4H+9f4TvbVZJxOoG5mAXjGfgVxTlrSm9ZusZjVb1SNz4eAQi+1hv/2MdoBJkP2V3sOhVnZMKZDyWaYGfIBnC4Z0cMWFdMNWT50SENwoc3Libu6EfRpnjj6WhavfUlv0ot/Tv+u1PP8Rb23RxxKf/bV5ia3V+bf7oao3ePAoBtnXDkDxriag6CAkK4YuEoG7pFIjeFOZpQBqK5FOFmwecE0n/nGK+eSMN8JPueYCzgTdLzCIfPc9Ud4aUmNlw7GZwdWhS+A2NAUBu5U4xNweKvjALMw7yF6Aa/aUXjRu2Tv3n//uLb8c/PGFVwJsjNUXcE6MLrbpDEC5BaJmkIpkgEIHFVa+l/2NYrhaRwoB7rDaSwf2Wva3wlf/k+dF18qNltncx/PIrFwAY+zKQ/gSBvjzyLCL/+Z011So59bMMmF9oFb295qegtblJe8wOGw46PQBcMxB0ZYs/L233oJ/v3txqQV5/p6VAUXlzBxQXFUsHRxS9fZwUIhpHSkKrnRXqt8P0h9lc/T2rFUviNqJ4isaAxVkRwkbOgyvqkF3351NO4M6YA3U/s2/l839txw4vrX0fx/b8b94w/FbsUmv030KLwzJ/X9oXA556Zf9qH5dYIy0qY182P+vXdJWgyg8w456y1zWvbVlnAXw9JUl1xOzP3hgGRSnioaMoYyUzZ7+mkOI7Mv7zf1DoTpr+g4tBxqXb4Jiji86oykZNEW1ca1bicsDJmOVHFDGqiwT0DSmumoaky8ZxW7olGh0dGgy++prpSWAtgm3aVpOHbHsuAKpxTfSTR3+Nb2BHlD2V67Tq1HSEXNfbqp/5GVQjJxE3GSpndS/g2N5/cRNpQbo7QspehqS0j+Jmr4x7RDxX8zh8NpQpwKWkjHLkSw2wxO+8A7nvlL9AKODwdnF+6L+MC8Iif5T8/pYy5KNIVmpyrTsFD3Cxjuq6qgtYzquVSpt2Jy72e3XhBJamFlV4gvmx+jQujImXDBzwY4LTgKjU+qwvJofE4Pq3TBWqYHhiJyXg3xu/J0JF9zkggvCxM8VvX35Is3mm2km3zK28szpUEvzaQtYnTlaxNTbDAzZsjaAfvMkIxtthroNYqEhO8lNpgkImOfyLTQnOgmCK7Nyjs3t7gEN5hjVpnDqnc/TJg51OdTl5/QAh6IdxqwFftvEp+ITOdIXGK1X8gXqocD5W0pjSABP177W2G1phkk/CfuaNMm0tnm+ciQZbBRTxjENvoqJmAnqZK/HVHJlFRNifHKCcyXng6VplXjmJLtqS5dil1TeFe4rwn85CpuC0s6k1Vx5L3/D/Yuy1+44iaLss46TB33HAydD9acUCUigUQ1HMt5D+66WvYBvFLk8zvZ7Q3cflv+muNwQxLIhgHVGfrdm28tdANBeM2tKzNR6aCegBAsfw/LVHAdumyv1e2Qf0KnuA+puH5DYfUDd7gM4lIjBc7cPgNRSdgKdSw3LHoHRgUZP24ML2okTc/ogbRyX1/E9vjWdpQlw/trbVfKzz+EbUuNGiEyKzN0Q17Yx7iOZ4ydtvN0q6BWHDiZNp7o/8FIsCiguzyr1OSD+nQBxSs9cgLVTg+GCk3UFx9gPJeiCs7qcSoyTaTWwH2oYmfZxBqACfr8Ev3xk8M7Cr648Rsx4bZfVnwsj4LwvDK5V7Jir2jf95BycEd2LFqEnFGGzqGegd+GZiFmho3PkQ1OjIQK+vKlnINDRh7aFJb04aOPi2lAVwCHMhBW+NfAz0eeAIr0uCh0VuWbcx3EY0vee2ssnpdQupKUdgH4SpX+v2e1P2fK9PKQJyFVlFQ1Vu7ODx6weFwKVpqCmu0qBHpqqXcoZihBIkDlhTU6KLM5EAPQcPhnQnEaWcr0IiBTRNMZ7WtdSHW/U4w6RTIw7QGpKjBNgdoABHcp0MA0dC/CmhynY8SbOaAbF0jx7DKZksmoZAcVFxuwFhg7cGoCXfV4bwENvEePlfqCkcOhCsopLy6hn47ixcsHjOTDkO3pODYGSb+jhDtU+bA3JN0K1k2LnEfKSVz3+GsdOYIPqZV/QDDATNmQySu5JVR1jF/Fq7ler9LB7UOPs988Sp4butEUNm90VenGl//6weFR9c5f7kudUrrZh0+OAVFFbx0eD8q2iOCSlrRbBYQpc8qAIHQzDyvboEMQk2Z/pZpZgp05fUEw4OJwHMoWqGxpuHaKqe6Vbni0zY7zUEdBzsBvIkGzUC/Jw1hAdNn3wD5N/cn0AnLXlskUnX8MQ1wxsV/yqC1ftFXnaHQ1rPxCqtjcUFNKWhdLeFQpNC9FUj6KVqkEGioeaFmOXbJtWpxAzS9/0ZAqti7l1IaSj2GIepnClAknyqqi3mj4dysQberD459dW94RKtCXRdxZg3b7wIV5NwR71WnwvliNxJ/veWTx1mz4oAt2nA6MohMkLCnClv8xzlPOIXVJJBfDPFxlR9o8il34rJFRhxSCkU0/S23JVlp+rZhQvQidNPpT9lMoE1G1adQdeALL8d2VP8+D00cE4ux/V28uV/pBlDa0JU1xlZB6K4WF3TXFBLV3dGRM6iZyuHRRUcqr8Qk1nUgRP51184TILySkjsiOD1ZVbUJ5fyTJang8bgVpeJoq6sDODn8csZX+DHObyfU0TYfzmTMPM4AkAKDSMnx/rNcJzRvnu9/3AsbVZub73kzwRjJsCawbDi3kDcVwbWBd+Vxu015DelxBxj2WFv6hcKQAudwywriAUUmRCCdhAL4VXyjcbYhVRkv2DZSYwIVrq45KjbzaLUGupdHg5pEaEabWs9dXQREgRxdZ/zgEoLCayVS0aaGTZQICt6lP//dk/omh7ISGiEBb+5eZlosqM7lMIBngx/id8UI2NEXufqryQh4oDVU4sd85ZqTfged5LVJ4h64qZohBdCMABYxGh8CeEM1qgPZtVxCWB7Gfwiy0y8/cqeQuGkwKlJpePlf+GrOoPG154Ptc8X6xU6IBHqnGndmMDCT2NWAsu8KZG/d2i7qepVZRLQKkNIQOLB8q4zM1WSeqXFLSSv5+I4B/ArfcRYFFMsi9vSFflovi9wiEmJXeI4rWWnWL6aEJralGKWigWR2ghV4Uzgy8L+NvqhgafFBlx8ZMIPzefohZvt+WCDnaMYHuyS7mMyWdcozd3gYiw8Rwb3wO+CE5n5C43boaL3QaP6uL6gLP19i0vlRaxZqkhjeUELubS3hJFS/2Yz/UC8dh0kzONjzLJN/tMRQ41qmLvtyaGm5uBGFivnl/uIF2jZvYVmS2zEsWVFDOKtm2Kl1EnroApX9/iESi3uzoEwYussZYa+PDsq3rQ4tDzjtibv25US6MGy+qiX+2JHrYHnShYuJV+UIiRyP4ZhTmzYMvKIGp+8uBdo4jVJh4/wKEKTxfCpsBrIGAB5GFIykTC1/zXtEhgW6gw8NRgVk2xDeRWsC0oUS0oW5AUYkon+xekFMoXK5fsiUCe6vvU6iassKs1NopUitnExAv/J4XciP9Z4NA+hZVkqFNe0kPtHkbTk3HMowqZqeK6InbLIHYbCGyROlSkNp2B5TKzpCpCBw6hpdkdbXaGhuI+DvHfZbzXUXdLU7ryT3Ob8xnpOIf0wHoWEhqZAPPSMb1dD1kipDWQ389BFBQyKGCQ4H/SzBL/5iEuXS+5d486hF0XRoZmKBRYhDR9SY+6oJZGZMpJniR51aQmwZTXJINp3ujzqiIpJxYpPFNhdogxiSbpu4MvNK7W+aCdR8q8uaOv00UmiUOQGrV0kkCdo5wmqe56J8jTaRJRqtNEJ976+RFjCHR6BJRgjILyYnDKYUfQ47DDXo08/lNUzwMd3FBRVBogpQNR1bmPZrCtK2KDLpDa1NUcM1YQTBlAVvFHRdHyxY+oTZ1WjoOzSGmhIE72dZ0ESv/E608ABR0MRBEv5UAzfkyoxQK5HlG6v+uAkQgwDG2ExB/VBEIRKBh5nFKEiIwQmkTkT8vVIpKsEkGaAcE3VVzgkfqQw1hCnCrPCWrLs2313Vv2SnFdB0/JsvRERN6RKhob92ZYArJ/VUGJlBObO0Ta9UiHUY8ELZDN4FoPnB48s9d1GfWWeBqwrv/+iwHL5ff+TD6ls3eaPP4O3IUbrFi5cZlXgnqUGNrrTm2mtRNaUxNpcmcNe/p9eaaTs01NGV6MBeT8LamkRfUXFDE1gRExNTA9+U0XMlAwrJ8ABJaSQPb47WXu9iSLvp7R9qAsoB7b4n7EjtlATlPKuIPLMp+MAccpXZfWuxLUMVNw6gwcViKOKdC7auA0vKorMgxizoMIgLfMrEwQl1gJlPKKxmPDS8d5bPBHPDb4ox4buNlVjw1oMXi943ts8NVjg/laPTY4f0JcwLXjPTb4zmPDg7q9cN42Rjw2eOs9NgSUWMcb2d03VD02oEGha9BIV0I0KHQNcg4v/k8F3y8/MvD9/KsfIfg+/ioB39sWkzOu81/CxNr8TZROnLyqSsdXa0tKSAKZ9LoZrpBYWcCULXthHusKW3daEQkeiXD/VBdbgojIoKqjLIF4A0WwrTETLqajMZmLmeSZN8V/KCugWESW03mTApzbiQU0pZSGY4z6/ouKWUgxZ/vBMq//s2AM5vuwwJVi8ZfzQywebbMeb6IaX/zCXS254RTIxS/3ijYE1ht81REhVzol981pajnn9R7jUkN4EXcRlhDazKF5CW3h0KyEtuL+1AsQIg75EsrRfAkV3LxtspnbRiRcdL5dXnJ9OUVeCn05VV4W9eU0muaXzfqyQ1626Mvp8rJVX86Ql56+nAkqau6nna6X86CjiEtq+U46UwGDl7NoB17OlpfH0Bl42SUvj6XT8PI4QkYqHk+hPM/hy2XFE2iXvJxLZ8vzPETu5h/eehE9js6inYg5nx5Lj0HgAk2q0amEZtDj6ZwHP+txmZyOgGR6rNxyu5xr+JyHEpCwk86jczkwuu3DF2fh51z5LCvO489sC0I6l1AMl49oFIDaT9Han0C7UbbWd4XWdz5dgLgnSBx3rFIYPjCFIdoWth2F1bgr2gP58Orisci4k87SxiNuFzfTFVbjRMnzGM7jCpP1JzS3HgO9IrINi842mlIGYhPut26iLiIZ4ziy5auMQnZVL12a8L2an5bTxD/uNJngSjr/AabJd6fJd6dJkGJWBM/Pt+JxadujrZgSxEVsoTQ/w0yJjAucNFPijIc+JbLqlNgCVD6TtvAM1CnBuEgk6L+JQ1sl1APCSWgR6K8ThptyuqD/6RavH4cXi9fb5WWbnQvT/LLJzgW89OxcwMuZZi5UkHzHCJKfWkXy0ypIrmiwS/GZsQDRwO+FCn7b4dpFO2WkgGcaZwY+NMh6niQDQf/0vT96cfUPww68eCw9QbD34upfsZsTBQmlOkWac8nG7hzFdzNnLNYo7j/e4P45Q+h6Hj0eBQJrHYY9TtHVTjjF/THoSg8XXU8HZp5u0fWMfgaStAWRjBeGqqs+1ya9BHompaCIFrW2MRqGPDp4gvqcCbQ5jZiSGeq7g6M2CTKdXlLVM7icUwWtTqUzFCt2ycsOi2PT/HK6xTG8nGZwrII820eQ55QK8ijozh6lgwqis5XaKWB2KZQfU9IvpRs6dsOQ5eidJwfZUwHEUy1kt0FKuI3ORCQDRCNT+MN9fsE/DC62Cq2SnJRmAKQpIQPNPAC/XV6rMyyxYXEDx76G/ecCKqKKdtsDULIvCQSIws2IOj7N0HuguJBa5xP+aX+PLt4YZqgf9euANdSLsJD3OBu/LWJ9VIKZK1pfnZ8jT8qfoNiaG1Kfn6eTL98tpk22YYNf0+GtgXgs4nGqFnuaWxWRR5fPKXkNsIBKpjP4EQwvmqcOoQTlO5WELMjLWUpHhXAwxp5pF01itD3FLZo1XgBDPGX9K55Iu+TlQjpbnk9C5EUGc9yiebFdNPdYVDldCY4uUVwm05QNl0Szku4eWkMvpCeVJOOCoRUxpAs0r1kotUZL4p5IF+E7XffoYtqDtwvoCcMFaCrInCtgh86D8y21OWeIzjzeFQAKo6mP0Wgt4CQWRB8ibrMBnE7/zvPi68hT6WHwIt0M+jiIDZZVhqdiOU1Q0aMKwkcEcZc46Z64xo3l/MO5Yasp+QrNWYJ4CFPZUshmqbBvdmJQFbejzkvd1eUQ29yKxNPo9/gUyLSlyCr6+Pjct31SecwvPQRvpRD6j3grRVxY8VbaXYaBQBH4X81vSyfwXfrOT73jU7XSd+kLK75L34EUjuTHGc516Tdf61yXnmyVzpEpl5ftf52ANLsezxF3o1wY33JG0jqPozcgrpa+3/d8CF+CivAldMIXiQ7hxDXiOAVVJOOBWnQYkCMPtfFotv9UpIswT4WpFdlKgAfH8gM5rYw0FKmG3K5guUVgKwhMBejxiOQq2ED0Ii5j5QSbAucydozkSgEuza02daM2BlXB1Qk0Hr75ynUaD/6jqfHw175XP1kc14Er4uP55I1P3ifviTzyoqB6acCxSCjiUa9UEsvQ4sBRKql64cXAqxdePbgeHv8YTVG/uzraEFNBToZ5AFCWj1AfgG8sN7Cy33+Vmxnx8RzxOsHaj+lJJac1IAaH6eM91wilWcZr/RphIHxdDUHfgCpBedhDS+JNdgih1PBTwaI5VVD7b5h4Ytvmi2+q2LbxLjDvM6pTkN0vkBRUw22nlQf0ZgDDkB/3Iqu1yufJQbuAolr8V4eLx/vGxX9oqPj7TqL4B4aLx/vGxd89VPz9Gxa/uWYvN1Et+6Y8ETJXlhZ1ln3aXJb42KeuP4Ai9L7EZpiZDfXj7Hf3r/v0Us8ftTQE88G/pw3LXid23n1MFcEeNSD0esQOG9D9fs8zEHidsU2EhQ8OVfDKt7NaCoKiSiW045pFwSUffwsuw0DlQXGveg3lDS8//jUUv5ZOOkrWr11Qi9J0RiZDC8ME1ZVXoQyxRqk6ako/fWme+OFi5OcVXX53y28NPzskeM7Svtz0iT81rEpar4HA7Er/8wYuymvWjZY6KbYhZajlJXsNWqXB1673fP4z4ozuZQpA3xBULciXoTndF10Te4UIpEcoujlb0yUG4FTlTWm/RCDEcakOilA6ze9hdPSBZQPRoYkCPBCb/giPuKlBwQ08Udggk7I2dvix6PtapHrfkyK1N9ktOqy5h3YIUCvoeeMweu4/MXrud+h5478rer7xBOj5dqx8IwhiT0CdszM9LAqFvaywCQCY3KBTh9NFgLWsThHxX7mWBaV3efXFnf0MGlVEgt0Ua8PBXBhkjFCrqzqWZQyYYNiY2C5jvq5aPr5o6XIlhdbP1W/VnXeopWPpQiVSg8IBD6RlP4sGLQhyqOcxr7qC/RxSv02g+qnvNFC96big+mmkCtF7Nti58dZkjfVH3dTI5IfzD3FIKb1FK9IqS9GSFx8vhbAlOt15Ej1RajHH9YZT29e/9pp9nKvqq1OTWqVzTrCIHb6Jcz2vUdk3dCErKsePvPXJ9mtfpBE6sx9ep27+Du/UNqFral/PF5Y6uxW5kCkzJZ9XNimE0y+sFNpbjURTJ29ETrOWZ3+hjPWTPB8W6j00W8pXzkTprSBldpuuLUsgtSje0lvy0h+Wwu+RbqormWMSXlwCOCr+JcWBHX72SHCneLLDB3DzKUskq3Is2b80kcXxWO2RrI6H3Oq48h9udTw8ujqeDBY92QvGYUOg5StpLNCAJR1WhxKBRQnla5JHMnK/4EbuF//DjdzbHt7IrWNY3y7pz9iQYSXhTBf3CdtKJQe7Q1hXnYwb8qz0SMb2XW5s3/0fbmx/6VEZ2zsk/QeGx9ZtRWQIMbDqZ/VpMrAX4ueSksqSP354H/HUfa8b3vf9hxveX/02E13vkYzcB9zI/fp/uJH74MMbuZNgnj68MfN0jvT+QmGF9pU2AHfJKJNwSW6+oiOwq2lGOnskI33EjfRH/8ON9G98a+foooxed/wcfcSL52+7kfud/3Ajd9fDG7kmNju/J7Fv8Vg+IOAU/WfevuPEBgW4DRucsod4dNVpe0ji0jyPVXG9r1dWVaiOF4qc+2d0vy4UOkzlxjbupuhSa3Xby5MVwR5xsW6N4vtm13Okln7Mi6Db6vN4es6YsEMWuQS5e9wd6sLnW9Q7yCM8u+aZ9NWsKdyyoN4QqICmefzGcUVsUCKmCA9tXH83mtU/R2Fk8jofbaEFddB/MXJfqxoEFfu6l5/knLkX95LgfsDtJZ+5tPEM6j6SGXTUzaA/+g83g/744c2gS447jnYUEz4VJx3JECew3xoK+Gk3fn/6H2787n5Utg9/foKt4SWyYdgrO4hdsnfQww0924BcZ+O9Q/hIxvYv3dj+7/9wY/tXD29sn3A8DhRixWwM56mDdeQRSdf+1g3WPf/hBuuz31omcqcKRscvgY/41PDzbuT+/j/cyH3hWzty6jw9+xbJRf/Jjdx9/+FG7ksPb+QuOuEWfYd/pKO8y0aUcr//SEbtn92ofe0/3Kj9y8MbtSfyqDnFLqirCUCNgp0PK4aFn31dC7dMiGn8i8b5DEWu/tExpr1ZlWZs7I5xkYsjkW4o+6Zbfbz6OMn7pjnJ07YzMParSy5BDwWZFhvgtDFJf+upCexTP/a61kuC6+KXVIwWHuXT6EjrUbtYsPyF3t7kU4TBeR0/ocxwoz6DFY8iTrnR54IP+gifzk8YzkH0isfRmQvezI2omE0ChMXBUFHfK+7/1r7GZjdNhu179n7xPyH2jy6mqHQnw7tgrjtP8Dzg5w3U7S1p+YBX9grpejN7JZ45dsf315BSX2I11qKlPnpuDp5XtJehe/sqyTYh8PHl0r3GdCgS1+AUZAcQAdur+BYIUqcYpsCj/sFA71wi6CMo6u7T1BYferOBWObA32W9gkfmUtnRpzj0T8Xn8L5ivu/Bmus8sHOuzwFVD+wnFPbyrhg+nH1qscnYcZ2WmzSewgD2JjJuCyZtmr1agBNyz6AJ2q1YaJW68jl51ooFTNYe8aOVL/p7EIANAd1pL/brfKuN5tTpKXFzSiNBK85XmrPuL2Vm+WaY/dSysmIrHjMFMaAQWsxzuY26mBf83MY5Q9qcb8fFh3wLhfl22ooWnTJ0K7WAxv6puJW6jVUE89NoOwdYcX8HncrbvdPxyiGAFHfP5ArF/mAZSvS4P7E9P4u25GdTnj8GYhTpzBQcBD6GRKW+GejtgUnEwfKMxjjfgbvMraNtqmy9i05n3fozctaS59sBZ+bn0Nn5E7jkl+Xn0mO5O49jkD0+P4/OyXfTE6S2ecgmHqwFtfx8Oq8Ms7Z7GX4ihWWY5bJ0HkLFk2geT1bMvw+6+KG87KHd8uwj8sn882CKocDndAGdj9jvoQvpiQjsLZP5EkrxlDLPl6C6v4f6CFyAjHso4lsMKz6X+mWPnkQXIeVJ9ES6kAOjwh58IhVcqN8FxUX8na3sKVy9lLOHEI0SJNq14XtoLyrQr+/w8TV0+p+MyIs1Mij2DBV5sZTFJe8ZWyRuJGi38PURn7slHXkiIp+okUFxYbVI7h0y8ZcXuiLt5ZF5PObpPDzOo9147AY+AN/PhVOQc/sxlODpsVD9Z3x4nDwfR4+XJ1+ykec59AR58iVFTMBdtE1XjNNpBxD3DDzOoLPwOIvOxONMOpuvBTG6Pgbmix9DO/Ed3yAbvot6iruLaieH/93J8d3J8R94cuAGaoEbqE/F41IsFkB0XPzTCXE6vkc4ketXZ2Eq0FOXUdx2rhOhnYzB38vz4VSeF6c9/DlB6+fE2Yz9pzIcdjIMzuT+n8Z9P8vMi6fQuXltzNzYETAyV+ZGrTI35qtzw6D8hTRv5kWtMi/sgIaKBxhWQWkTrzOuxG8gt+D0O572zHt/8v1fuNg+iycxFhQXEU8MILwaXLTP4smcKPilRQMTBWE19sLRKYJmcBKh1HKaPdFOF8SW7aM+PVGni2bW6B2mOxdJtXamPFGrvkCK1MhhtN5BF2hpw2itqHtc7N6Bxw56CrD7KQa7zxXsPfdhYvnZdDpQD3dFGd924g234c8Alp6Gt9PoLLydxchOQPbvxeffS0+191cL3F89C/wRUHoIz88RjD5rmWvt14D1jIPbuYg8f3ywxyAmPZ7RNsmfiCcIK2d8HNCOdjFKPoa7dU7+WCAoOp8zRchDRtR5RtTzwAxWEHO+gpjhGCR0+KckuIp4TyzJqQ6dpb9VDOBopHLe8092zDBKu80o7QD0MXTyfMroqAGsj7Oj8gQ6XYYKkN9Fj8Eb3xjE2zk8rhmG1dx2PUs/yKmgU55f8I+97QpX1jmdQtv4RjqoB0M/pK244LSVSD/q8dBxucJ1h0phlJqwiuYncKW1pChTGnsfYsevvcTsNg/9HN9uPRcWnMAOnIHxPZfOMKTusZzOj8fx4wzQRMQ9HulAlxBdY9Yb3T4X2dDoXWZRyJ+kAT+/yMyn3CxBfm6WxSDva8DPn4yL9YIzIe1Cp/S6cnWFR0OK6jL/eERU1/onIGKHW/DRKJ5zZtX/HkUwWbyLS2iHvFxqSOD3IfKycg2rrvpPs6v+023yOdI0u9p+z8ks56BojkW4lL6vpF17qV/BTekw7dX8utzbWh+rtV5Cl+FbXbDpafR0vO2li8cUYulppZBttum6gMvi79b4Jw0XonRSJ5CjrG4CYa6EZq7skjmxy96fP8NYi9etYg0/T9El7bw+Xyzfx6RhYgcuyKuVxcdxwg61D9jGJeLzOAtPofP2IXRZDxND/f09lmapTefxBnwZt59ph97xeoHwD8S3r/EBK7rvXmIElf1rPg+io45ba4P3q1t5WkIEemgjrc10dfuP7l/HgEInmCZ4SseFGJyHDp5HT7FWNI9sgrm2Gfg+nqFZyOm4hdbiG2zhwRIm/thyIj9xD/f7yYcBxWz8vp86AMycwmfGSCkWyYcpR7iEH9r4z+4rarrxx1VErp8D2PgL3LHtV1kDN5a62Lw/BY9WvglyN4SKTRJfPIXJyr6+rDmb1vJncE2Pp5l8t9SGgaOAFpmK3RwsC8Ss65IjcCYa33aYnjGQQBEfLupUr1gUf3AmvwBV7CmUep6Hl6R4LIMXo47R0b4zxAO93C7TVie9v4eJLQRTdF7OeCFCiwuEmMsqgRkG/gYlD0sTdnAmkDsl61y2D7R/iqDqLE/g+IFgiTZdLUhyniKfacaOEtk42vrPOo9CjkYR85xEMe3mJsLo78DY2/cUd0Ln0Z+r1v4Cb4odFmFAr4BNj0fs460Y0KHIAnVFrgK4l9KUTSpNmT15acoCZEQdFapM06wIVboqVOmWQpWuE6psMkIVmKue/r9ZqPLdfeN3943fFap8d3J8d3J8V6jyXaHKd4Uq3xWqfFeoAm6ZOj0eGCNd6T4q0hXmuxkHZv/9pSvfla58V7qiYhXyaTNPgKcyps0ZActjjy9gOZc2rRei1HiNnKcdxvZmTLWKzCRcQkRFkOI2o3iE4+QolI3KUeZkWww/dt8POUob4pQ2bUaezdZGf0QT0AzRfXr2DWiqKAgytcOUQmtoRlqTrYh+iyaHleSkmgw3+P2P15ZcqdbbJDwV7NHPmvhs78hniyNfSXRWjb5fo1WppRJ/g6qfsIqMKuKcwEzViLPmfnB8M1WX4GtVb18u77MvLovBCOcfFLYNs9egKZ10JP61iH+I9q6OYyXAH7YSEFgrAa98lM2VgNpgEqk9R2ew5HUncOv8F3EM35N1/gvYibO9vtIo/a7CGWm8JKPxUyhLbeitxPi9LS7q+/oNcTNUOogcwJdG6ZVvJW9wCbfH4ii1SRH6lOIBD8qaAKvsiAnFKUPUt85FDwaotk6RmaNFwC+dIrOv/opzY1ZMYhAPVyKm9n4+zf/uwW/+E4eDw/B9jtarz1JwzMGKjbNtLQPSw4PcNzwPBEXEC1kgHovq+GPb/tNKc2bQTgrOD26P+aktnhGPn0sFHEFqbXX1F3b4lvODO5CPUxLxaYmYtVihwP1Wy/pN5O+Ih7OO9PLKghfoSHCUA4Fx76BmfQm1cNwMyMUMTSu5aFBICU3R1Ar3kns/KMfj1XtWHwiKWeSurxXB6gq/RX2/H1LEs5w7Fr2I0yh6Yfb7VeuGzrEiBat5gMHqik3FaecfbE52KDPmAw4iXQaSJrkt8hGPJkaO5lYGFl3uXCl8dfw8WCnmAUlkbGnGvMtf++oNWsroDgYDQFHca89TynnMuBpkyn4ab87fqwdYornFzKVKbivuh+fAqDw179BMXrdeoTpPkWwZQzzTr4ew3bncj3VinOvfriNYupHlyYPJ9dCpyB/NpMZPwrURT0efn9P8XpoDu89z/sCEVIZjvY5FbD2lpSR1EZXwkL2ZhznuexSLFl18rixgD4g3p3htFXjev2ipSNb2/vVPzvzS9/61zw4c+RPe2RaN7AExN9bkD+7jD+x7yu/3VN5bkLZL59wUzNslTaDGGrtWV9F8bJzhUKPqwdsTjzgTle9XBjrw4hCxmGRpbzl0MhvbNMnTvizhWVz5pGASPxlJMUJBxfdqB48OeZXx9yjDGp3JeIb9Oxjz0+x/qy8cChWAIQA9w28zSxhy+Mbzsg8bRUFa0oRk7+Tfn3X9LT93zZOyjyApn6IQKYwdKx6F0KvM7tRvKHZxijFaU6Y1wSCNaPFOwUv+ND8WwRVMofGz/DiHWQU9O7AAr9M8uxQPqLUetoEK6ObbFbh5WBeUsFjoeuQxJAAtbxRaVfiAlLWyI9KNKTYCk8d47M47nHSThzQFXRfRtVw7FNzhUZcyuMfZx96jWs8rFpYU1NlHURKM72fH8J18VfQwCxf1JGCzL06SIK8Hm4YWbaEZpGylOTxgKD2nzaVpfuJtZ2t5CUnbsZ7zxuSYZwJHbeCIDdzhCXwW+wkvoaPzKD8FpqkBr+2UL+VZH/aeivw0ULT8VPXhZJAmBpno8IYDjqdj2STQaSZg2VtOi7FFiu0hSSZ8X0anyfM0OlVcR9Li05EYYj/jyeMIvpfQUX0cQwSOf07hfHQKF73ioTnDc0lRDG0T//KedU1prcGfSosArPStQ6fiVC6Wzzr6CRX6HODbLeZry3wvKhnbStvMWryae1rUaWgJLQrhRwlFRhlK8wAQKe9wFcucP+4cMTkVeBTWUvCCVHgyQ0mbaQHM4fYlGZvTTjy0BQ+tjOmpeSZjWpxoTItT6JQTDmfxSIZx/BCeZofwNJR9WjmEBS3auUEFOh/v01l7KjfYjGasfFOAYXRQf7GFekgeu3m9lQI6lTNWPPAWTDoPeEjXNIwb5vKMmbyHZMpO89sBftMJjElL29F71IpT5wOejPYcdbPfMLzjFDYtOR4zxQKaD1JCm5b023wb3hcRIiUIMQgC8E8JwFbuVa6U7mSwIiaDEIUgxJbjIcSiRYhteUanmom++OhP9EXFkC2PIoYUBkMU+4oSQxZpC0C8lRaBHh04QttGnSUgPR6dEkWoY6e6En6LKhlQReg/oKeznnS+M5i4E1LGqYIhWpROcFAzBvzYed5aKnI3s7vn+ug/wFtuQeeFY4LvW38JewsFPl8LyH5T1gwTo0tSmn1MV1aNXL+6Ys+ekf/svvfjCHYNAO+/GDEv6PMptE/zoDbzlLCoHraE3as2EdXYVrqFHIvx+OgdS+v6pNGL46OzcYW0xmRNx8Q1R+OYTXQmYN8aBnA7HIzzMDrsCref9uETa4ItJDf42bishx25mtyDmXB4FyD8sN/RP0Irsz/Gbx5aM3Zc2g4Uurb3p57yxrvz65M91kP5vRczz74L17qoxsCpuIHO/kTKiJVbvUS4WtVZOT9gQQ4kFCUqcA+V1axToOKCAAwTOhLplj+jIPskCjw/eKY5aQv0/lOgPsIS8sG/Z59SWiRW7ooEjz16a8lkyCUuyRvAmGfmsTaJfMbuW6iBy2EvgtfNNdMP7amGVmxw5ULez8RoiY854FNStSmhlV8u9ie4YjFvoVM6Im/N6pjsGVDIGdZWs08rnCQ/t9hfKkFI8Srmm1ZiqtCyE7dXCSgoHWoqmgRVQ8Hn1RwahEty14s3sf39Pl/bR8ULHJ+V8TbuRLIbtWN+8ibG7/d8SCIMph6bsqiqhjv0Onz/buj4cGX79d/9F58X2EodaYxKJRx18I0RhDX2KSYZFch55GM3XtlwmOCOPavKHLu9jMt0aKCjIWCPKruJCIQCgstjSveD7M+QTyvue5hL2Z8L6DiN++fg/zcT7eg6D9fIrsWzjk2fOM1rvCQuDYr4pc9wQFf8jzM0lrJ7FZkxOgeDIhEajfWnAWch8Aar+SBWxHIzk7dEoCL+ngNqQBbRgHRiUITlXTHGuyGBwYTshNeKbLW8V3YiyUGC6fJMaWgRUggBzeQKceiwA9lhRB5eyUNkS/IpaUg+LY3KZ/pH1T/DJH8N86q6xqE+XpP4R9c42bATiz4OU7Za8BaJcw9KccUql6beaos5LIERzmYEHsTBLiWiEqZO/RZolqHTw0tX1v3NJUZB0GPZXrhSprbwJJiMW6FKRsSPsMitKlkBn9AD6Q7UwLYRrcmttu20mJ8S7IFDE1qg7bIoV5gHXjC7cgR2Gs3nEc2Ja/g5rlTW2NM4E0VIR9bTBA6cK8Hamqi/0L5Pp7DSWC/fgTUZB6Wn0+mcW970JEFBb5/FGZzKKcjHD/K5+GeieHZMQ9q0fKcZCPhtQhMwFGiFZquOBp3GjWzdcNfvPm/Xf7/nYvtE30zFu7/HPnFCcXoZ/Zv2ieizEL1HZEP2qeAhSbli4VnvO/ph+3QpP351cPZrNq1+0D6RgtI4jeFwWnlYfKd9oi/oPlrNYTzwH7rwyd0HPvL5f739w/YpXfjYe9734bf8Y36RfQJyiH/3D9y2/xkve9NH7NPGH5z9/U0r3r9eZJ82/v/7Tx+dW/7of77TPm38034I/37hYvvUePQBqgdnjTTy2k/94X+94M8++yT7lEK+cNuZr/ncZ//rR+zTFv7Sb7znh/928+9cZJ82/lPP+ig37ow77dPG/+L92eTk5PUX26eNv1Qa91t32qdr5NnE4+mZCWOfPJjfP8pu82h8Gp5ufqDYNSbxsbQLqHg6D9wfcI2+ibdP/ub7CQU8+AN8In02nUEo6AxiXR/9rJJ+BrVkGsgW4HGMwnV+TUM8d4JT5+eZ/Mz4eQY/d/HzLH4ST7tcZCvCRDxO9h7XFNELeD47/U+QNdb/nBpIoAiFmg3rf55OdRaikXzIwcwGp6muocGgyAb5JKeRTeP3jLaCJdHT+3PwkhRPgNrouSpSRbuY1nYMRWN3YRRhrsq+l56gaqPn5BEfkyeYt5Z01BzpQMlV2kHncSZA5Jx+hjo7OIPrUC5ncFuooBBqo6Rqo5E2IE8ol+ZEFEnLKRFqr5qhEWBXnKPk+xyrr5mAT0nKBriNgT393gFCwlTsZXAEtR2tYKKpXMxMZbGdoc008dQ8koOyfDNFKrZt6MrXFCYLrfStKPb6yPlVOMiC1ETjwZbxhWyPnxGblecnBHTXUgKO6QBe2dD0jXga89EBtxjhxSJ+vh4xFRFzMC9GAdiPIZlTOOqFKKQfLPHp97n+1cL/Bcvn+suakw+olnDM81wGyWfAqVK8bBjchnKHi7qU71rWA5A8Fl856gsay5FWjjRVlW2IQQA0Tk2ay/k/hWKvXN2Qo/Ue14osClPtV1dYRnzdg+nsZ1ICnu4HKQFP9zRKhA9H8fxpQypF+cJKfx7ch+a/RPJDfimzxiOvcgJXBNKaIPt7/WCHf3UOqDbO9XfyAwJQfiRYmc/1L0RQjyd3S/CLCJ4jwXsR3IUg7qxjz4HgA4jdLsH9iCUJfhWxixK8H8GuBF+HDDMSPIBgC0EIt40lh2WqC5pmX9Cman+QiFg9fdUGjoltlDHKZyeMbBYF/y4cj4IO18aj4jAKxhUUjCwKeoqCGGZFwcihICMfUEYHaRmZHNZ5FI3HOogDsSNxiBYKtSkRLTCIFpKniGZ8LQVAtMBsREYRLdCvAhYwHRfRPEW0EOWfANECCqqI5klrvCqiBd+BiBZUEO2LjzKivfPkPSuEQ54VvA08KwTrPStgV3PfsGeF199Q9axQHkdH2Gp+m3wrvOGG4/lWeCNSH6YPgoM3rPdBEFZ9EIQn6YPg6kfqg8Ab1i4IrXbBz3Uavpzoh3KM6F0X8J81T1Ib2lmrNOVpKk3Zq2979G03sPRWlt3geX6wQ3bRO7CJxj6NwVzdhmc44j0/wJr3McxK4MRNujfVXWDsxMt6rSY+f+OPUt3RUlHHY3uRiK0aPfuWXWKTAhQLelhH6emtg6J1fkAol9JBkZrCqUnxoGiKLKarEYeLpla529T4M7pPJ/MNUvHQgtvUXlnRb1NqIKZJTcTQmBJaWkKsJdimUWpLaGkJMcXjSwCPyF1OrJDIHzreVPkCpLtemvLYTYwIX2AQUOwBCsD6XWHPEpoQjERjcjSvDrihjQAyZeQf5jbG2c+iCYqDPmUr1ZiaNhJyfqXxtwLY+n1KrZFPWxt92snrJNKECVlwJqTFxaRpM+jRMzDQPlpdR2dfDFyj7HDRGgJFTC0sdQLewxjxlQG1VqsKIS1Et1YYE8oPn6N4lx4q0rLznKVoAgIRpcPdaK5ozHgIpBUIROsh0DwOBNDTPJF+55OpjDjDpAGYNGiSBAb2Eh1sOHIsrDoW4VOl2/Egn+IxlTkg2JTlTRWYxHh0R6ele73zOtgUagGaKTWpdbiYHlAMInq4mBms3ErTxBEzxOGitQo8H1DKk0mqXaGpwwxiHohDVlcF1/yGgdukSDqr6huQgA6nxyUL/2y8Si/aFNAMVyC9WMHQwCJumxsTowAem/UjE4+MzA4L3mHtmEafANUQL+sB3wHgoXEwCvMLFfCJSmY7/d1ihijhTyKeRhOqLhgQBxKHBNLQ1khDN54JIlPTsZ3UCrkdEeO/h5K7UvzhvIVnRqj0cJ7SbN5Q9/hQ8AMboNOau331ktAmRmSeCVTXicPP50p8G2N9uIhvKTUVhAhHUKRB+szhoj1gkDe1VxmK4QnESLBugIcHsEVtoIjmPcFgB5hsjFIrjvTMUCoRmIDrCVDzOAQI0NKhvDCf1GFmuAgjE+p4Rsyx6JVHpM1Sh+RVZIHK4miBf4NlUIIuRfHp58zaFQjrIQmYgcJJhNwE0G7wNVrOzboAyDrmYm/RWF5yLWv2e34AVbtyMV5pOJ0e0QO5Gf2AHploJd6a3YoiNEpdT46sCJpTM0LbGipryktoKmg/jktVpY3f8kRS8gYjd1MwqV5OxkBpia81YouWR6VBaV3MfOK/K3tFS5d1AQWlHJFepZXeHC9RU1acNmF6UBsrK+MOtupNMRyHkiNG2SIyZ2xN9Nxu31XPQEuCg2sIEw4Ic4iTPWhXfUtUKPs3ax0BB6oqlG/fWIXy31WV880naMebHv12ZNyObF2bqNqm207Qpt8ablOg0cpPSiWMH6WVdj97PVILf+8uOVtTwoHWQvD2M58+9d707MmPrAhxgQOGPMKDwMNqhwLUP4NHP9EOQRWAsanvCQPv7wn2CFQpzH5BWPgaU9sQWKf5QCD4XDjHBC87QWH6SS+EWh7+BEjqlFcmBfbI+u6RB5F8SJ6yx0gtYmA6hSDfez/44T/9s7+69i+edCWEVRQz/qtClvjwdSeyePAGBdVoy1CXFqqLrrA9EdUrJSKDctLaJoryuups4XvtmTvxFeg8RPXEh5j7jXHk8e4jrBK7I0FJ7ABmFnIEQJlymcAq4JdvzLpFzs5hVFFOOVTEK4V0VrYRh7GggPT5tyhJqgPA4HOlQKqvDA4VyUpeN/idHC4Siq+SxR3UdjdTpZYHaN1V4yCFevwcQhCDvyt75wd7GIMaGJI6vyunIw1ockQMRh+ZasLGcT4KsT9fQ+9QfP9GEBa3p0l1T9Myw5oU7VvzCblikMrIoiSElUsnwoSNGBrUPgzmKKQJijjURUtvRfbMZOEWlTrMeRk84kQ5MiE83UIxdN985uFXvvnGWHmBhlJ4ilaLCH1Cx/MYgDEpACCVH31YwFDX7AIpzp4ge30dG5AnqWKyV97RBfw5zVpG3R8Ung6H7rJ1zcIWD8OGMV7JEyST0XsxDYpQlI45ylNoU0PWnk51+BKotbkBsgM58kmkWceOqXZBZcsbjTClyJRSy2RilP+2CmV+/jtPKPOW4wplDqlQ5v0nD6yoCqwjtQ2AFa4D1sU4gh+G1eHxsNKwLoSAG42DW7iPQSdaybGQHkCuArfweHADUBU2AF9LwZfoI8RD4TY4LtxWH4Ewa+U7Wpj1MDv11pFORdVORSfZqSseUaeAkMOdimynfszH8gjFHysfU9G4nqDpshBJIxDDO2HL/1xkpWcDCrHxukWazNkdg3SlWJJ+KA52gyGK428wifz1FAcHSvcPz6K3Dc0ibjtIqAoFvj305vbjzhtYfX6482b/CIoFVRQLThLFXnxSKParJz+YMMxsRvPwR18ejRlMzRNAr88N6ArnxV515aO+G84PDA2n3SFFukfaYED79177PLGX9K0d2F8/7sB+UAniD2xkXhxFoYcynPfgLjNI3RLGjX1d4mNtacVqOHLOLKUf9oMQewFr8hwjXE6jy9q18sCMdGLhWJj/WEVK1gZfOCkKcDQPIWflVDzGaXiscih89HRADoF9OHsTTVr9Gryifql3TbmAF+tBPtVk2eggEBiM1Nfsl6wwvjLHXfP5OBLzG9XxXzm/Ezu/s1/G59qzRAouQtegka6EaFBYbVB2h47Il8KGbKOuC/VYAn+jO8T1GnwhoKo47b1IAVlbK+pO2yLn+p2SXt4o34i1KOv4P2/yDHbC4LwlUGyVSqorA2qsFm0nQtbLRPkEtVUbMG9n71EYgu2E5Ku5ShP4b4VlWBO30ES5HxuAtXSseBuq5TN5R/efUHLt6iOjwLBiLQl1ZU5NGIKZ/Qqq49eARYBFG48utd12aeJwkQ0Oo3cTZV0cybp2q8UUd2WF264aFrBY1R5pYOq+msIlvcFglTLKVtC1ydXKRgwdeAiZsaNNVbmNJtwQAT08GFqH8iySp5eqfUGyT9NL1NZQx4Raruy8RSmQIDUiImeZCwWzgikcMAKuter+PX2X54WOCriLrSo8g4pt9l5Auq9bnBgqfQmmdIOp/i5ZsDncF0cNDckvjuMzkrid1Bi7cCxSQ++OeSgxgbA2e59U42FvzkTrglrIjwaKjZ1rgsdW99nomlk/vPIe9vCxTzrqzMDONXwKQPv49JB0w6sqfWNBAMaNMDCnS4l9bsPKT7/8gG71UetZtbfinWGeraGKNP2cF4AWRtdWtHB1RFleHShBD42jDtmyuQno5MN53cUmMi0jxQElKRUEaOiWsZykZhMaUzLghxyXr1RwcXAYczpeMRtTCkYy4FPJBQKSx5wJelE4keEID5PHEz8Y/5N1N8QtSB4oQyAkHpyYynCko36AJJ/E8UZWiCDNgzaE7BHkdgFSISrSospi1M1gOTa4yW71283ugPM6NgHl+YobPnIbuXX2q0qkVR/ek6F9g+8F3HLx91H4F9RaaKE6/pBV/axaq+0ZY16BSrt1S8MzDFmlgbKGIyf2mB4XAqEhF4hQKBEtXxetQDXauS3vR1u0QPyAJ7Xf9mvyyH7N3MHn8j0t39uo/NS5JQEYXWWQnAUo6QSVaXvS9L9hIGtV9yjqcMU3okbAzKzrSEoU4cg3VfkyPDLi6sBEByzBJ5zgisfsRR0Yn0eneLwue97LFP9QHs/HLs/2z2NmP/nIjU+6Dr5eTg+S/1/bQ5lPfty1OPBDWyZfiTxCYORDwKabSgG4A8Pv2euvN7iTvUGJQPo/Hg5X/KERrhisoGOL8baOL+6P44sLfHg188BLD38DBvZ3aP+F2pWea5bAnC1lv2Mmjp6l3KWo8rde4ONCtls7hu9fz8jEziOlx5k6/gkRX5MUxHl6UdtDDqlKxZZgm/FTA4uIlHE3uWMG9E7OjOeiVnKhQiJT3aqZom7diaMdeuM2EX7T1+tR5path1tXHtWNWKp6+eMCzx8W6/oKYz/7fXyqCZoqI+Tgnh54lA8c9ALxghwncIbcK48ZfssdM6iAcP3RR+CDJx+55YQKnGeiUDsTCVseM3ftOPiIXfYI+64cdywct3ccjtsDg+s5BhekveSsfSiajGOno3K7HFNt3Xb5odZr5USq+iY/ugEL94kDrVDHMTYqoDoUXC28CyXnmfy5LjjVzVaIUuUR6sPtojEe6kwXxZTbC9Da0T31Ox5V7NC10N78wkTTCOeDS3N4Jgfwxx1T/eEJjqlej921NaqAtZt8e5OcG2fmLlqGxN34OWcfLrNbrdbfdjfKQuNvSxU2kFP9ClOoaAeWoq4Gf4sALL1k2oF7aHKTGmNd1zsfcdHg3OI9qm6b41GYg4P01R6ufI6fQK9eOpO45hyoQT44ZjkCAiqNqX6oZmF2PhL6LXcVixzZM/TOU3GC2D4IzLX/OmlykeCaHE4nYnXGjL0YPmuafZMnw4/Fro5iUgwSQtBJ0Q1zHxMFJoGxKUqkjLYyWBOqAC8ldapXvjKUklAH44H6C2xN8gxjncm9Tyhgic5EE8NicuY+YYdkQBtRE3YU9LaYgibCj1+CNgBMA+ss2m3XrTJHW+mrjFpUaRzMKlGqpLopzZvE3okm+cgkoyZO6TjdntJhXxGUtwvvuHAgHWAJ4CeeeN1z3rLC7r32/twnn/rUf574HxdyrzJD9fXuXgTbb94LlPa/GwOD8wv+Azh9HT9Vl1Wt8iKS7sbS3SJTYZ0+tJOmyzGTHRAldNk3qIR5FjoN1NBNpztOXljVKmVVn37Hp94x5qwDeUZkVZ9CXm4bPz5Vc9Kqj8s1SWinR/g0VtTstzaUVL3wef3Wt1pO9Ynjyql+V3dqT6tyI1WzV0F52ixYibnuMFGPmOX42O0g3H5QQQoGSGupOLf7vfHO7QANcKhPES4W9YfV+kO7RoOkgcKG+KRsAUUSh2qwemzAlblWObasZbmyH/b8UXmdW8GtF2vuP+NusM6/XzDsW9BJ7h6mgPf3RljZVpWTbY0wsrtKRjbM/gAfH59vPUF3k5PvLhCv2t3PfzsnoBEX66oZ6JoaQAaCCIR0xdZQaOaKmaSxfoWHfQvHHbaZmfstO3I7+Zl77kbiGsctj5PZXMMiqX6mp9mFz8DV3S2U1FAaoB30H8uv/V0581mq8ocheYaihO7oLxWijsycYuwV8I2h3ONHsJyjFYFG++ntQZgYHZZRrgzNcoKh8RMFyMfgytTaf6Cc1V8oZ9X3hYN78o3wd3we8qg5VNyVlytLERotn1C0BFiBZKri5NVK2xS1P4PyFPVafMWqQLre7YpQK1MY4LxlteqK0NDUlBFQeAq/wR+LfgDjMbh6LNZ5g7w1iIFlQfMvzVPUCyYpj8EbKGSHL+A3V4uWin9lqdVOq/UTn1rZG8ameCS6c45BsBevIh2MiBPr/dCpejteFFuy13ieytOw8PN0dSLpAXi2vdue/KbW4dt+54mDq6yypM1ylLMM8rBi8IkCYRW9quGrIhqAqQTGYdasDgof4F8pqkVrs9PfjmJfLEhwixxLuD8UnlCJCsSCt//0DSIWZHy9HRLC7C9l7vQhaNDEVPmU/VIVecsUioEB8ChKgX2zO8N0vbTXZoWvq/7XX1/34C88SZRQ1KCcHKvtw+Vykc3h5lHeqGRcf2zQxO3ENQc/qq8dtm93rgydBiiOSquAolSRZIqy9KiZgJWLB+vNBKzIdQHpyNoqwoPDYuNCzZCsjoqzwWXh1FXWTwWdNqHv6WqrrlWtwCcAKWqALwthyyzP0D/qKFNgbbdExI+oaruL/0Nnb/uJ2oEL7znvZXnbHU20ZB+RVpq1To9+0nSHTxRcy2mS0sNUjRloP/NJ6Wk+VRZ48ZHsFwWvJ13+jA3MaQY9GVgtJqlN/Mf8cLtM+CrXbsP/Zc+VqtCdYBbHNIFbGTCIIaYM1+GOJYT7Qzun4vS1vso5gsqJXehO7AxPHKoYQEUDkXKEnrna5vgxH3FLWId0UJBJs+DF0xM3zcdMpi0l0Cx4CUYO5YINDuVCSBFgC5L/SilCOHIo5xrGn2ibOJtrU7hUPYODw+ZrDW0xgxsMFENBSwZobJXmIO5w9lf4dnB8ox/aoJM32Dp8dBGCKfzcelb17zZgVX31w/xhPwrMsqYNY3MbIzZC9jeG3+9t9CFOFok9u6fGhVpHCmQ3wLFYVHweq/5ac8mYsVgBd4s4RpOVdImwizrWQGq5PywCIKrPVkCcQRZdtNYRJ/O6m41UxKBuVBqB6TM/QPXeWh5SPQ/s4gmihMufu65eM3SHworFEqNPa/enRaR2SKpN8bEo6YyRFmEAbvNDSM5A21GRtb5SA4+FJ0AJoivmPBMHpAaOfJngI6lJXu6PHq62QFiWyh00yJ1PdTQlRQNTbaD7iFq3gCFjnqaN2aeCn4jrkBUspiZ/IxqSKJnf+vsF8nrdHAaIuSE+boz7ODpXQ6htHAUnUOllbBVASJFVRkIPN+SYzGjWkK8zp5He+ChLOC0P3A+r0qljx5dO/Tu14q9P0IrfGJ1o+73RmbZn+P3Akyszbf/Lxsw0ji1n2v2/WRs31fb/dk3n2v7fqI2dbPv9ymSjjSfbwYsHD22yfbN2zchsw8I/Ott0Cde2jMw2MrPtPTrbqpyUXzqLh6k5Lg1x38JZpw0dnnVxOetiRZLYzrpozKw7Utto2sXjpx0gImXCKh5tNO0iO+0AS7twN9L3ep4PZpiFZt7el8A87U/eqMe+tdIY0WoZvrASvmxPlT8ZGyztdq3yauwdyj1UNHxP1cveiZZgSLM3WO2h1cNUk090A8AR5CmWcMKtqw9F9c4fUr0LN1C989ar3kFb5IFh1bu/cZtvt92OMM2/Tap3f3vc/fM9utCfNKi+C6qHJcT67IgQy69qKfonqaV47SPV7g2HJX6+KsI+rE9eGoR2EVoDCUaf+z9uCLe6K4yx13QzWRTuGM6iXQJ0qQ/Uh2BRlyMTSLdrIFhGiy4QVgG0XczU6M3Cvor3n14V1aqVuw1FtXALAazaWFb76JZmdYe4PDUToxprPM4o/R+0dCOMwJcn+uJLY774pV60cF3wkiFJ0jFsdKrygDUnD5BNwrvwrtIATZIdxPsQTPWLu9Z98SH3xV3ui4/JF4bdwWKtH9+97uOPu4/vdh9/Uj4GCy0XIlGGCJAIEzVBaBGhBkJdhJoIzSAkVWYItQTrEWojtJ1DeO7kpxwpTYDtKpV0Os8vMuos74Pxw0lUuVhMPT+fliFG+gxN7stn8bpDfZ8GuW+MPOFsao4imnwBnG/S1PP5MbW8T6yt8Pv0PqovF/OQh4BezFOHZkHy8g75QBHf8rly+9mMag3HkV08KN8kncsX+gIstC2kzlL2j8acfgbzJNPLS5SiRjFf56tK2FHkLzoIyqdFBP6tQxEotDEItQCw+MtC3NCaiNPdQWRKbZpaynt9QQvJjNn9T6gaxUp03haahsRiug9a4CpfdJXXUas7M4RRf7R3nh/XLolYp2Yu/YGzUoaVWvi7tIeMaie3LpaUKV2SI0bcsJ/g7k+BPJqBLWA/K4OpKbG0tUWKxE145ZMQHcrFRnxAU/gEVvKKrbSlYho46mfOhvBW2jyURIATBq/wzQX2KYBsiuYs0NJqjWgAwUxX5X5Kp3LHZ16LIxS335Py1E8rTV9qPHcZPxapg+zchpAFHNEEY3VsgsHFjylrjR6mCkXBxBFdUmvz8waK1SNRonrukyI66THrFPkG1Mq3ksPjZJ2tsAngv04EAv1Wi72K6VZDdNpqiPIUw+A2qUGZfpPQpHWONdsP8cfcb1ONzteUPLRlrspcnOmrUuImICLOz8l/ft5QvJwSKsLgUJtL+aSSo3vXkaPPOHJ0ryNH9yCYOnz39eP71338Rffx/e7jr8rHejltTj88cNPwhw+4DzVJPrwRwbQvTQJ1WTbTTqqRXtOcifP3aPfmsTyB0jDh8nmcZvjgReyPoO1SEAwkiDmPKTBlsxwwEI4oxSG7UgXZkRg13+rA0jzmxJSK7VJEpsZICM3LKPYfKEmU0iegm7yqhQaVD0doDnLqBPExKaUDoMJToMLcKprC1ddhEiklFR2tX8Y90hvFt3l4UoTR7UiH+Jq6h8o5DpQMNQrg8p6DxSKmgiFY+STi9wPmRVa2r5heN7UwkC9dkv1bMEYRbKsYLQwIz13mSeYJowqT+FNyNsuVZzQNjF+kWSVn80LOpmn+xOSMH7d5DBlxwuPIGmYmfz6epmmmbIicZdTBFnIKF0VQHkaJYi5/ClNU56vVeOhxOyHj5EJIyJiGM0PG5rS51HakTcJK8iZB0SZp7lJ1vAlzqThuajmwTzqwTwyDHVjLtbcMRUtpUShaBQbz8HFjqNskTYxSN3+Erk3kPs0+TLrGVKtC1ADAqALAeZrjCRgBgC0AsCW9Bh13aDjr0LClNLnfwfGX4KOH3jjA9BxgJtcBZlHwEedjaBP+FLsmpMweTTIkxuFpvhlAadEE7OxO5hHELPAGMT4vl76ZfMGoLTRPkUXNKYyuohIjKCMbIaZmYrZajkJtXlfgB8IDTNlssGirYMs0MGS6xBDQrbEwmFoHg2mGwf9iB/UPZ04CWfDnWIweTWFOtrCEzxsOLwBbR531s3KXejMICC+kHg30JVOvBvpSE4cAhGMfMy/zrUZ8FegxKwT3ymhAnu0hCq/r2ZFIPRVYLSasnArM1E7LPQzIXaThXRwm2mi6TmBbMlEiplgvBuo6iKcbT0eAepbmzXScFlxLx826lszT4VkXMb51SEk/ka8zLxqeeRtjznSVkUDzlXfAYqDyqRzG+nRNExRyU27SLH11XvrQXOQB9oN91w+mMd7cxCkzPPM6ZBTiWg/RtPNwVhC/67VzszT5y3kHJARsoJqwsUuj4aRn0JcZs3elJrLI/rW0Bvj3/tDtF3+cZmxgDsR0QIY0Y0M9hLpM44TJN0c6gTvSEVmo04JV6YyP3TjEMZyIDKU4JizFMRHVnDhGNmTBxrWEWgvaNKzzymIfb58c9ssXEfJVdF7lkn5V5xWTJhInWGoXP1QVe3mE8kCakcmozqveonTiE8imx0ho/hrCrJOEtR41FvEotO2hpOoDnwS0VecYw2RhPXpWiILq7h5QgikUViqJVR5bo1gqqcIXm3uFb6DwHTrMjNEUA1GnZAzzbSoQ88pHqI8a+SoL87P7RtSK9R7tCIjd2eW5J32JtuK3spa+diGehy4/7m3yrzPDOiy3uHkdD/06vCsPfbPjoW9CMDWaD+u+uM19cbv74q0IWrmFEZGs+/Bd7kNNUhFJ+WEorIaVNeSxlT7k9VJ8kJSyiUYpuWiqoMMwtq1SjtEuJR8TpbyjU8pAMgEkQpNV0cGUfKTyixneGaHNVb6cmtQmnyafX8wuU8qhWWa59xVz1Hp+UVtWfY1JUFKaww7cSDO4BzFSYpUv3CHrhC8bIwnW9HyoBuokO3pVfp5xMoYa6DoXOCRjaNCkmPuHRdrJPkZSv7FyhryJKiQ+T2WGIrXo9uH5xTVkk2tILPSxBmcOsmAl1BV3rRuwCAu8xu7HdETgavO8wjwvpxTQwp9OztqSmETcpB7P5onf6+BkUTg6Qa0qo1AzjAISESbDhtQMm0AmXDPsSKtkEhZUJKJmyajmuIQF5RtqVSbBuXYWJsGxnomBMdZ+7qQwCPpyNYfJhK8QBkHDl4NBsMrOXcsgdI2zSAfvpoN3Yx28AeiU6gZacncK+/ohBqEHaiLQiyuR6DM1cp/aACg4WLKMAcXrGPSeYdBRqWAV2ISWsWKMtdlqnXSNiAGbFHVlJTNvWrTg+SOZcs/PFxWvVOLIDUdK7fl596HLCh6GgGBRjK49bAFBjbpjBATNdQKCSdDbSXte2XZ7EPWb0VbaPsOBrk74GqXlWNQqYoG6gj3RyTwJRIuHxAJtQL5NkycjFmipWKC2XiyAXkmzmShNgghxq2iyKhaooRYtuGhVxAJYeRt6V5sJLMaxJf0p7/EZoUDedexh5KAxBXTFRkws9WB+O7Z4Wls5FutpEZuxefPRpodHbeapiz+hNeKmlfc3grQ0oyxtLJOrQfEwmVEpQU2lBEo0REjW0h2yjmDNSQniUkqwMCQl0EwZLQxJCVrY5E6qOruPMaM6lz4JQqPnxfZORUQzGBJHVGoVogKyIq2lTaWQQMOZ5O1iC9ilphUSNFVIMOPA394Y/F2Rg8wYopMywPgx6SAQG2OoiumjxEhlBNVIIURdJUR6hWdyYxKUrCNBSv+WhBDpOX3NgS+mJtgBzmhdAjdLEUFeERPMOKScVyqqYoKmERNUMXOTA013HWgixcy2CIbr+Cs3vFjJhECOw1QVE8xjLxxT11DmKG+NzTssJhC2R3FzckhMwNhGkxUxwYJlCnSzVwXhDKXAlc0GjxYEX1Qft8SRsf2fXNf/Oi1CRNB9eDOySyn+FGRtAdikLv1thku59Mc0+UiW/sajvvTrLVKQc06rrv+1yvq/0VRVJRSLlhzQ9T8eOxXTMVNxhmIzFetmyqUbrP+TlUhK8xqmHDBNpp2v0642PO02xpm6TjglSnab7cQDHcpoVtYCt+3HnGu4OddWn72UqJygIXlikAxq6gdYPNHCSR0msHxOTtDjJmhTRQC7lXoqJ9C1CnKCFsgIhKGJtk5tSls5QVBxEPCOkE/QA3Y2Nv6GHxQjCLpIamMzRGQCh+EJJUZ5Zqn7UfLQrAY1Bquw4Jusqhq8MxjsgmKzMcHN51Cirvjbp/bXB57Tp8beT3wc/+67GB6rRVXpMh6pvV967t8e+NX777noKggMYrGP11pbPYSTHkrFpXV7bfW20twhrvrJxTQM4gRCOp0iEYNH4tNbdKbRavGuHhOHiAOJ1ebKKjpSV/QxDv0aaYNeyFU/EFD7+bDnghF1qrLqALNoDmsQ+UZt6SZrraLzdMig1NKF2iARe/PZNyxPBc1cRhSxfsrEUYZZsIBBiAgH4oT8qxgNMiZZFLW5oFInalAkrl7lU1E1qLy95v5N1IfpYiKok+2/EfjBzaKHJz7C9c3jCTSihyLQOL5Iw4mP3jZGfBR828VH1SvT0fFkG+7K9D97oYgnXmbUA0F5K1NTeLBInhmUnk4PKK8Pq1uCCBtPnPXzhAzHhgRH/LS6Jv1ELspwf7iI82Dr1C4eMC9qFw+5MAvRgpI4kd7Aj6BJJaBJF6Z0P/UK1RIB3r65SMDS7AJhoAQkapc1+ByAmgbWMGbN3Xf5oheoSSgrlQlKnUjFMm6DaOJ9vTQQflaNZCOjRChmaiF7Mr1dTPV9MOD581ftwwUbql/WQ7ZkXbbaaLZl4B6uCwkZKKdFmP2rYJiX/Rue+PiTHtDL4zbd+nKdROs/eQBZswfxi7SDpSHQTwc+3Pxb/c/I+XWsw+zNMW7+GF4iYYjfG5KnJv7V2gzV+zug1bAGBOeXu3wxBg55uiRla9dLsynIrr9RGp59ADFU5+T7QninkeCxkEnlC3Czqy4X4fjB1fldmwgkR3kyD0Ooy2LWvRxFFgGWCu6xSIt+EDcyMCkegI4c2vdAuJTdgIyI77/OX5I0jT9yvY3fPxT/JonHDhWIy9Cocc+VRyMPNnqB32iP3oOU2AvHRe5ykR8tI7ePi+yO+7w1JrKM0UbWefwe0RXTv/v31M77n0A8qPl7yFleLXOmen18g33tmjG87a+ARbztx9p6gWls/nA0/7NyUL30Tzx/+LZh7ByY9o+CxlrhCzCRQ2hS/YEAXe5SDPT7+auEZi9qPpim0HyZzdcaysf4wgUvgem67cvXH+DiYaIgBrreCCzUm8n3emqI5Rg/UVj3/OBuT0hkzcdwfdG+ZPzygEdx9XLer8URtA9hFiaoipE9zSFjwzXozZqjHibIIqZHtry293d+fe318X3n8gX+x8u/P7l4xVgmWRv0GcAHP81tXq04SCYXvKpXxh/cQy54Ze8BvwhAdC7pySXK2vf1Ch+dLK0r+6De2NkZw1DhZWY8y9HEAIvljBeTN94QTfBc8gjPZ5In/lNr2SuUpoAcXo0anwack6n0gxr7QvLVvM3l+g2nqSE/8uDTSgGEhtztZa8UalJXzEWCtXoEWovSW86Ikg+k0ytE+PqYlydaSu44I7VS8YPle/YqVKBGKJByOVYid08y4lmJ6KepbpX6el4pjwrd2kWRu8NWdf6r9qGppj0V9UwsgHtvvQX//ox5wyZFq4PsgDTDVyQRPc7bgDbi+M3D0n0jnvy+H09PvYwd0EXFE2f7r0EJaplrp94uC3QRSjUyKxRMGim9aq2PwizIpMVK2qSqe2pLY2LvHomttz3TfN/YCEi1yXILVnO+9katqLLp+Lzn4/ylMvl1ssoSLjQ4ex2+WsCkPD3YdV5ws4+g7nCDA/qiXMr9nnmpYVm0L1gjb/f1c148VnyJ7eaxTvtjnARjYJ8xJl3u9sX6/P94zuduu+WWaz6ywuYkP/Tqu3/uV/74tgvJBcFeH/WVYNyFJybBml8hF/f4FXLxVX5JD0UhlviwSvyqmu1n1Y74YnbLaK/e4uSyY2afz8V+TLLUCOH3aViUWzUoyq0Ipn1JdJNTtPkQhWtCWTlBu5pyVDIHOklnQLp09F6PjwGoFNbAbnR+3hmGRVBuK/Y+8PYv/fHTf+yKiynsIfGtgg8r/nIRrY2QuHiIxNUdiatXSVzdkbj6MIkD+x4yieMnSByG0xK4+0Hg4hMROAY79whgLscAjB7us1zW9oTZP+jngbsBsv//2ZO98UZrMS07KEE14hdIzE8hRj/FLKiObLU2CqUAUL9YdazJ0wNQY+YhtKRO9xRGpBw6igKmSJcvzOYuUNe58sTyoRt+GZ88cJMx0OH8aTMZ3abuV+qp3uXSu0hyw5uf3susW5qo5MAp0u1/DA5NbzHcL08YYq2vYVt/IOJ3fu7H05Nt6sFIJQnikqqJcKhq1JHlV3Fz0geNxC6eaaNhVluwkcX9feMB1N0yDKtf9QtBAXsyahrK+nm+0dVmScNz5N/n+G2CIjCaeQdjy8+M4jUWqQT5FEd8kquMnatV0TERgm/qpRDqFXKEwxErPtM8NKRoKH+LDsD30AxFOAi4LaKUONy/LVrKfgoZoYKLeIlTFhdxmYtTzhGqYSv+m/E44lNy+JaiifCahmdplppX9lbE1Vz11vWVsuegpopHxNRPMaP3SSpbeqCXsIMo8na/mMUzKebg0iugpitQXS8J7wahskrWwE+l+6D4LXftGzQj+t/8Gr6QtwkMV1OzaMamItWaQhHTejldUJTSJZoyLhGos5TLwcISCsNCOsPo6hh8NA6CDXzHORT6oFHTgLEY1VvM5xEv1vUWocmoxioEZrUCNnib2GpCcsvhNs0NaHYVqDCF6qBziPpu+8L1R+561dff/A2ueAMjF0GCo4ZpVBvpcgfc0E3HcNSFIzG7TMxHy5jtIzHdka9a62PkVbEEKFjuL17jh5in+Bu1Rxg++db3fu7jt7z3c19lIUDCr5+4Rd4hE8CuIwKau92petPP3nTALEjqlNDXC29iWEPOMNUuF3Tjh64ggrFR/qgh9p6RUf2tmWzn7JGSauLiEWxJzFi2niSzhYlS2vbUtt/yhiwTdtJ+ZkxS+tmnbjSuUK1pyqNxFJT+LQ00djmS5akWirpjZjrVB//rs5ywrpirFBfKb8qowr5WkVSuBVrf9QNlTurOhISbjmjP4DCbQTaU6AOcO6Rwea1gk7OJWRsvv5hckH1kJSBlkIu4uSoejJT7Jrwt5k2dCil5aio6olQvizVL03wtYZhyfqhp6DYjuxsjv7R0VomjNA/1hhQuPvG78Q6kDk0sGCACxaODR5Zn1FJ6+RVpLMTcjcFgHQyMuZTT9wxoYhW+FN02kfyKDBiVYtmAmrz0tAilpwVaSqPwZwMQ8E83WOWJPLkGq+JqIQ6KdOgLvNVxHFuJaa0x3RQwUIgWL++zETDJURpHIRe8qofUQ4NVfvjEf6Afqp7A8J8yV77MAb+ugLKM4zSmLmorNCnC+bpQyabQTpXggyLqzVaQRSWHTSanaBo+LCljk+qoTI9VtA6zkisBV9rYLdoi9kUzKxtDjHtymNsvBlWGaLrPsw75MTq2Y1h9IMnZyc+dhpPn4C5LXY6GfodtvLj7/+6a+ZOv5+fV5/GuDgcjn6wtZT8LupEHJik7z79Eku7SJOUWmfipA4sfzP7o1cK7cGVF7GJUKIJX2fY5gawMsaoyWR91eLlEDnmLFFjPdMcemrT7HqNHkHfUL1A/wwJ+TZH1QOFgV0SVLYsOXqfIA0Cn+cRi5haB2f4bz+7zAhiAo6Gsx9Vj6Zp5SzH7QMykE2vbkMe9Fk3dQpO30PTAUoI1NtDXMv7tVT43zUsezdDsYc7FkVAXFXstWRuDjtFu2kO0WvYzAJgYaXCUL1HKl2fkMxjJ56nef8WrcUnyqzeK0BDh/h/iV3rby96slBJCpZnsb26UF4a3fo/o7CsayeuWpPT/6DUoz3xXgkK/1bE0mfVLHXlN6P/5fvdtZnDir81bZmn0/zKmsIzQhXQL1bXbMz8shS9ZZf90TmVjtZ1q0g4PwCkxHDB+JuwgDbK/QMv0gjl52a+r9dha+v943lifcx4ESQFOzNiwtAhLrN39RchCJdRTKRJEnYDa77xWPnWc8/WBF4yzB2z4r5tudFbfnCuISM4Vyt33WbUI4gls4CIwaWrC3l69HE6XVKDKQ6oC611nSbL/DLLrdVGf0e1n8aoygUhul5odSaAXl1HWkugYyu9u5xZzhwTPWRI3R2i1FqLGvvsM+l2XogWlo8xIdZ4iNE5dxIGmGXkRbBMBzj43+RY1dqgiGGTPI37aY0sPO/aoyhmkbwjUOumIWw89vQRqGGKqp6fZW1Sg3G9pb8pdExkXHdmHLFASPQZCKgyEtbVEikR5dqkkSnhAfdCTGxKNPKAmnHDAnpPaLpHhBL1X9jTEowNbo0qMA5sQaAInaYKadbS2flt4tKgNHrZt9M/QimEnCLox7zJua81mq9nCwJp10tdRDNQ06gSWE4lq2agOKhej61yltlN9rboWYTkUEBl7cm48jvmBbiFJ7P0bn80DNfvfWsuj0khNHpTQNStjLXcMAqyyicXjwIrfAit+U7O1cjO7LIyTGS3c4atLKHCcyn9X9oALKxQNqlI7jLql3d+/Z2UgyLC2ulKWdUTKcptNimz2PZD5SeCX96xcyeYtMG0Ghnh+fx8xLyjq/CscGLeXxvdzbB/VWlylj3veuMd4croJEPYY5ytEkLxB4R2WijC4iq2+A8dQhf09eWj5f1dG2L/vy0zIZaGMDg9WsiMi6ok1H0UOCmVaRMCFO75iPoONX05UlDUOX3wGGcxf6YlBcMve//KV+39j6/N/wcOeAKnssnCQvd0a1SB++VkxouHfOqBglXtsTye8oZWX896qOQcKlW96znrmUX/odEF1ghMV/Rs7OCpiXJOpHsqBlcNVirIPIKHQoYIZFJ4kooh6kE2yQUGZy6gvsZ75uf7Hee7gNEwcE2olH/eXsl93Epqa3S/s2mNRZ+XCwUitRXho71cf/OSLP3/qZ9nUWVRF5kJsb1/ZMzF3XQhzK7so5o66o4ipWuW88aMi5HmZ549d+lQvPOQtvK6BqjE+w7tsBFV+pQvijF59TEp/NFm5QsIXw9alfvQi8tQ/zUduHF4dH82V94Pry76meph0xHPFq7X638UhtKWhbtuxp0Ri5RY02TPHASE+VgYEA04BF+zg+wbPD/TATGYZLMKiEhygW9k37I1gtRuSfvLp9ppvRJBrPnT2IUmSAn4fBWQfxy8FawOw5RXTjeX2mYnRmr49+xOf6A8MGXgPztN8PcCryhq1nnLXdX9Jv57IBflOUFZ6RFqRNdI3ItqvlCkJ5+eyWO7uVyyLOTJQYvUA/+Tt6NSP91VPxRCtQ0ZoqkeAv+KN0x5RgODUSnUH+jU15jDUK0RQoGf++iYksyLS1UiZUMll6wah/9E1NvAZpcqraOJBn8VnqfZQYTYg79n5kDIGhek9YaDS+wqueZqq2/Q1b+wpmY/jB04iBG7mAG5uDp+T3eEVgR71GEH8TZ4mvM+zYviD+PD+mgp+X+dZya8H3V9ttMJIu4Fv93vZJwBFOYjLA2WZ/id565DyXP+5gK+WWvG6a47eIj16C9nlofi4vMqc7IEU6GkeimiVlpsorJzCeaCHNe0xeM1hbv3F5tQr1NW/pat/rMyqFVvH/N3P61HYdj2gWlRB9gw/9PDCOC4mCd1bwzmGBP8JwZY7w4KgAMWROywLcVhmBPlaLaKy4ShtP5gnfIIuD5+vaXt2oLfVE7K3AggjsTePxlaIS5Q+GIpzkWAMloHgHBfTAotpwfEwLdwI08KTwTSdowa//vAVAkY96g3heCRS+MX7WJX0eX3ozCCiZX1ORE9VFAy5JX4RMe6VmBeuwzz9JNoY70ZOfx8q3vkW79wmyeEdNlpvcXjnD+Fd+BDxzqdoGO/8EbxD5AjmYT0Zh3461R599PPTj/hBKOc/snj+EcY3DwC0o34eytNTPaMEL5lZL2O11CtS4erxeeJcYA178kosm5uMsvLJ2JP0JCVb8NELwdmUx43qrGt1FWqoZQ67oQrdMqqrqrNfupr9lLjvS5Q5u9utlGdzA299s5ZnIlgumJSrIbngVTiDrBO3H2ePyaPJ6fzxK9ZxOq/wxFatxdpQd++RmIIyV25ka/9zdvroXpwfYXazcqH6JXIaAYy8in4ihF1V6t1J5cV5wLcmyi/iLrKehvF/F/Zv/wPm+lFciAyheACQdtyKOlVPUjf6AfSZ9njGTCT4nluUuyZ8b7VGfXcjtNRvqnou+0+ov6YnsqfXMvH58gqhZjtqKtFghPvxd9/45NoPtGvIski+ybJdsvhllsuxVwzS5wpcAXeGJR7Sb4SVNS+i0ih8qLIEjkc4QJQhPrjZZZzQSDbp7XDL0+9F0zMLOfIriqFaEwqQkNrvNHqZwI4KdQvTvwvWKxLscsg2TleA9eTQGPWPo0gmOKBiN8QtIiRx23WkoSuKz6A6qrcA9GdxKVtRzkD8TRkroyQXLBFalAuovO3Cdd7LenibKRMzkUmUicugwcaumx7OM10qQHkOC77qaXE2wIvox/XPgeRxVRNF8JS9FS9G2tECjZUraNiB6wwDTK3jzF/QWSAWeyR/kcjR5pKsBYkceKqteDGsdgg0RB3mwNOJc8IKPFUlpsLre5fwZ/xArjqhwCXdyMmZmK962krljOdAWRfTFG3szwAztHW/aDYiu9xWY5Z/3ASrZX8uhGDLuFhMSVXp2zXk3NaxqB0MHxOWt+h67iQ1/6/nj/eGy+CW5Qute7+Ke2XpKD1O/JquZ0bApku2zgx3y7oqE+IMlYa+I/Qa140gsHOb5ou0TteViJFGcM3cOlB5UbKvaOiJSDKkwFtAdx43AGRuOasJSA25i8RhTpUJCO+9xoMNxRxaJk9fGniBXkDjmhf14xdxEdnbrLaYIJGxklVKaGW/3LD7QjRTtS3lwIjSvtzvkC9ROvlskryncg1+fYaQG7Ht4lEK+2p5nZqc1yyYDAdpXH2JohcxDvkvEq/+wTU4PYlZdP5kj7x3v/JGnGFXvTuVlq9QrzVggXJ1RnaL2GxUs9yTiQ5MFczlAJeI8gKjOpWp98QeP8By6IP09uNi6bN2O0Kn+9tx4iyhRZShW2yz0PHPY5ay2+10zESdNQOmyChou4dmwl8/pPsG3tj7Bl71voF3ovsG1z1N7xoM+WqrU9j/xvA1g7ffOHrNwPu2XzN4x41jrxl4464ZvBN5a+mK78fXlbo+u0ogO2yXIycVH1uk18RQp0IUyNsMQCMbOsbVZQQxYaFFI9Opfg27aq7ib519U4rzhjrQ+DqK3/3KJ1/3ihuAb77im6/4Jg9SLy2L/PAV3xBSfJOQ4ptHSrgkW48fJca9+9oneTVriVkpg/RBJocRabvZgmOx/4Nsprzrxu9EmynvvvHkbab8kmLjz8NmyrcBFznDvyMu8ieqyfdQUfHzfoTJ6uHv2g3A1FVknFFe1lfajpvn7nIyRCIs/V3izhbJ5UbhK0dk/ELDvyRPvu5aXIk7ARiiE4NhPAh4nV3LU+c9OcCehX9gxl0uzoufEqdpo64BgzW3s+PkXFVVACoMbmrNMeR1e2rGPbiBuwinQWqmJBQQ5UF5pTygEJcIR0B9VtWVE34E/dTzruFHqGbvU5zIEcaN6xxhhMd3hPGrXiBDPOZKZu107EyeTAfeBhPGb7Ob8LNqNZX+hhRBS8gcXXio0tNImXzcZPLVyA97lFfRLAArObJxn6lbv3Vfvle/rN4NJO/hXXp5343rL7141Usv3kleennZwzJJ/bBa/Ks3fhuNaA/5SPHEvfuN63ykvOfG8T5SQrQyOZ6N7XWO+EJrY/ud8Dkh8NC9urKOeqTsK333+sR7I12pLu2J29n+dTK5XsRP/4XXmJWGf675f3PfWK5OpWq6VO1aF6FEilP9/5eM54QrsHXaqlsnFSZU/R/1r+sTw+tF1yC/Hoy871FsLCr48ZNpL/KduMm2tWRLdq3eoqNw3fcNjYCnI3AiQ+gPg2A9tNw3+X7TaVkc9Ut61Ffvjx/zl8xRPklhddklJ0axuiGSnyNwZIEdG/4u64kmVwMDozqhUCxVW53Gso/IkzzY93wRtJo4J0epcRirDNE0JmBk54CPKeQPE7A82V8L88El4bOiTSE/VM+iPaRnoYUVLW4firHrcfIiWTNC1ToOS7em1SPXjyaROkCJ+M/Cxt3RdevBcVSMM/Kzf0BT9RrssLelIsr+EWkqs9uDvbC5WnsJn1MCbHrSH+PWXVGnekU/3FhE8Pfuit5wz9nfPPNM3Dcv5bHjb1yI6NZ5BkuoDlVdlxkM0qrc8j9cbHi1P3VtoMZq9qbXi8p8eSHfHPDnTapzOeWp45XgQspz2hWu59At1NTr81rac1zzuVurVD80oDr21odNkRVN1Obh1TwBJkQ4jhQhliBHhHPzkPzzRSEnNJdCQ4U9GJghrYkHgr54Tt++pBMv+ycMho5CvMZIElXhHZ0cvKMqvOtD8K5TNALvSCTcDO/KPf/GELybFXgnFt7JCLwbuJYxDO+oAu8I8G4MtJqx8I4Y3hEYqjHwbjC86zxlxTu5EEm4xXC60Nl9Crn+l87GPkBRXa23ZF9CkrEVqBuNPSJQBhcFiFbPBzEN9q4/MdRlk1PgKFPL/DLKVMsPR93d8ooyZU0F1nG2JkkhlCrf+FpeFSU+uxWZZOQ1adXpR0JR5mz9TBDI5FLFSO2ZxPd/6xXuG02wepH8n9WL/Ce/IoVzOutOk+Mjrxij4Ocg4HQIY6dDGI/qELp0SQW9fIiVMLpAlqgf3IkP9CQi4M4c0VfZcIk43dosEVEepMMhBMAEa1E6ppo5FCEU9AVJyBiySVwskio8QnNQQf6IvmDAjbtLsUK8QiI7h/hJwbC+YORkkT/k+eNcXPS9PDSHWZaVxksiXvFTBAEb6fvHbhx1g/Ed6lDw6CNyKAjP0yfvUNAZrrgm9Mx1MseFhY6YqHKn8mRi7aeSoK4MUJPZnvGqNlgh/NVwdDhgMmvNYIVWYhidwG/JnWMG7MOb6jhw714X8tXthZfEdg7e51SJtIXGPufrfua4tzIj3A1Xq3mE8Bcr4c84U55SSqol3lYpEaTuIN41myYJ93Bz5Yt3rftixX2hSfLF7ZUvPrTuizvcF5okX6zJF8LFygTqS1NKmppbm38r46NRqGJVNVp05KIXMidYJH0i/mOpd8NM/rpay9f25M2WZywS4UYZgvs12JIDBfhfQOlqmjQUlybJC/OsL9aWUYw0LJ+iDgZsGjHSg3xGrZ029cBzVn2qoPHFPOK7NI+oBBUiv5wc9b96kwQRe68GQw5+RoOCr2qIa0lIlHMMhdnO73PEf5f1LBBgRyxWA0Kwvy6+EyDB2iSW7PMFSqhL2fKSGKVc5L/NG5gP2yL2uwLCc7y1daKtec6VdFEJd3Y3LeodU5+YsZNG4woqtoEwLS2mvhJYAqPYWUpD6RTTAn8pt7lytM8dK1CAz3KSZ5bnqbYEPIB9FtuI0x/8klfAFUDLXp6yz2I7KjJf7f4e+yxO4cqLU8uE37TP4jQkREjYw9eKvn6xfRY7uCCuhiTtioVnve/ok+yzON2l/fjVwdmv2bT6RPssztC04kw6k0NatDJ89lnstJ9TxCE8JNj62Hve9+G3/GN+kX0WZyH2k7sPfOTz/3r7k+yzOFs/l46++wdu2/+Ml73pI/ZZPAZQRsrB2d/ftOL960X2WeyyKf/ff/ro3PJH//Od9lk81qY87Yfw7xcuts/icZoCGD2euEeVBmuTr/3UH/7XC/7ss0+yz+IcKegLt535ms999r9+xD6LJ9gqXvqN9/zw327+nYvsszjXpnzqWR/lhp5xp30W59mUX7w/m5ycvP5i+yx225RLpaG/dad9Fue7BkfE4+0ZBLbP4swHv5+R/NNeccGDP1A8kbbSEzESp/Jg/QGX55ts9lk80WR/8AfyCymixxM+i/izSD+rpJ9KippSdURARBK0I1IkoxKlqEQgsuiSUy7oQuORgxgVyA08mWGmXeZphpAqA4bW5OsGjDA8ZAaDDOjJAJoMWKkCxJyISpBtr/adBGRVAESUMwiQ6UzOdKZmqqRvAXkGUeyCTJ0ZUEXl2hOroEqmc19pdM4b+bwQcfEmUByYY9n8Ajlbx1ZbtcSxw040fYbWxRewWPkkLrigFm4yqAlNehIozanGmGCxlXvKY3chSeBC2iIJB03CFoo0IYKVRl1sabO2gb+JhKYFstoIOecmcNFbKtFftdERXYjBM9FYEhDN9Z1qomkR+8hF2gwHl5udY4AmM8b9kI8U0MkQfCtOeYuLQIiFzF+MhJ35Hjwo79O0esQRov9kht+T+3U4qbqYnrycT5eV592yeflC2YF8s+2nLhhNUHbrzcquMdwmml4SKGCt6RM/AOdZZM5jhnLCb+pJN5aV4Emwz/2CwucTgKIQq16MSYvkowwfBiOrC4R+BGcPm2ldYmYSiYe8LGdhfS4yueBHorsukSMT4EXRx9rcltb6VAAnZgH4WQN4avJSJrli9WsP67Wyu+lRb4nml7h+sV/LevpQEvDVLC04CoR0WclF4TshDqnVYYywb5hP8SGFeuJLYRWQK8fVTkQ9GelPpouUAc2wUGY0ichJaiDSsSUVfmRPhefhZs9ZBa4dxZN4cuh+q0kT2GgYq5E9mhaupljQmIKbsJlHlx+yp0rEfciMooA6aNYpat8wn1EsV9ClGXNHkjFLbqjCtZl6z8lPlWctP5MTYVNYCqFN/UgwqBCGJ5/l4d5EC8vUVdSSYeMZuEixczmiw3Wm8PKzYICQETIM43wkquBRQZwU0xaJVES0SWBVFEnp1DwSspAA8psA5E19YePVcVybuohjbs56ENJ+dkFXyq4Upiuz2pVNaKVh5roE8FMhILcthul1wZPC0PnZ4XclINV2ujYWaE9h2jgDFnCGdIQFcUETloo5auibnlOKBgusf1pOWnazkzdgJ2LUCXlzYnexl8n1BzJaTT4aXuCWjO7TZO+PPaHxa5kH1qmlKryonoW5P5P+QxhFcIaAC/RVS4OR1qUFak1wlFg6Itb9/VFPL8FFY3jSpkzmiPAk88zMs7IdFMktbGeqrf0El09EBhyKNDiUTSEDEbYcQpHhpjSBRwfmJGCSp2ZuHFnbtG2zbWhJLDXgiVisQ+RCrxvU4hg89uG2sBpWlXrCslhKWTyX2mPECcBtQnebeswY5RP9xLWtTROUGsnylUW7x+WiGA6kw21z0j60RLqRHSo6KiBICEe/2W+IsGzycDG19yduunjp7x7zeyTXpSa5zM4KTa4MaIqm+CZ8x5cxuM+TYQFohi5JdfTQtFPK6SCSlDLKGOocXgVQ1LtOOny7I6jVrr5osILLhTCsJaLUWLQIMkqz37T6eUAKT8UijFa4lBhYxSzf7NCdhcf0+X4w9r6mr7is14xa/BpYazgaFjGHtYajR10wi539ll5FEzuTeVy9vBFRvJK+PWDlDd0Nf3zdbviI2w1Lku6G76rsnz+z7ouj7gtNUtNR8kVfiqOamRLZu0TUhwXcI0+9GOFakUTd7xG/BebtPrxV7bwFq0BWubvqxrNXID9WEKkIB79aWVEXlUYZHCdBwZUycRGrOojW2VECRE4M3YFtO/54ET/ZcuEDvj789GHOY+G8Xk4ESW728RD/9o16I13AQL7pomsTApJm85ZNhJI7+VwVKlD7Y1GZ27j6Tn+1kUC/lf/kemPEf6OeWdA3XGXQAfriugE65gZIknSA7q0M6UFnXus+k+MoFkp8dK5/5GclarwubXBUUwnhY5XwfQhrAz5WBoMDP4egM8h653XsEF/j5KubK+HbNQxx5cdRgrb7CGI1eNAF1yR4l4m4C2yf9hhdkxmodzwOeAhiEqkhObwAH8pZBGvkairv/ODFFLihakH1+YUUGGuMV1fuBxl89ZQXUUsxsUPSos7U+Ll9GQaKDIIEGGmJwoWOgAK9IHEFgnqD4keqlvuyvCEpn0FKhiBuiljF+fsQm4iWoA6gbkWooWm4FK16tb+jerV8VJYneFzOxeps9Jfwvqeci4houLkI5/Wuv8mqzCUwMNW5mCC/ACyvgzpdJeqh8ZCJsXp5y6RpnE0k5J/h1z6Iiem8TmJGRkYg33SzMuNxktkpcxJ1vG5oVu33VdrZlMGAPir6PQwU2E73qGnsxQtwFUwAwK7sLiGdLW1/u5ysE2h3He1uqTqIwiXFcAtHrkQm2YjIuFsd6JII7270dYFrLpMohU+A4OBXe2fphVkcv/dlcOcig3aoiPHcXTQOF53h1VASiE2JD9xaBTSATY8Mt0MyvCaDlZUVrHkDOUjDlRI05YBPwjURBpLrQk+VLplLGn5FlVmtdCjQLx2xn77k4d5M9rt6u0iAjJ/uCvnujqXMvbVDpavn2po7ZnTXgwknWGuH3NXNlUHlyvAK30H1glGdID0c6are3aKbxou5R/yY0as7WR7j0YWtH6qp1l4ohGJGQouYbXr6LcJb6EvXoC8NRlJPxX4fXayaA/+sHwrFHj7+To5zJaEBq1pcLp5d7LtwEptgKbyEH/EFtYuN8/6qiU7VBU+rd4yC8o5RvP4qfWyv0sdi651SYGMqwsuxd4wCOdsass0ZrA5EbAE4ncOPpH8xQ2c3iAsOiRM1YZIo2BOAfUYzZ8isZ8m7JAhV+p1lCTsQUvthi/pBC3VzXMaYCBD/EXotW1J3cJm+PhEwT7I1cGuSJ3CGosW6Rpj9qRgPlpWHqLaB0WgIzRtURwvtwsdvnlz/qxNyrNjAHTZwhANY2m7iJxao2+TJn/j6PKbpwd14Vhe7o7aEe23gfvPpAXx6s79k1y+qaZusPTKKsz82gOjvf7nvHNXxthkR0myGbX+FtN95KoaY3XuL3xcr721+zyrvE/weunfhpCOrRapnC/39lE+5M1QkM96CKeMU+FJA/mKaGvCHWvhiuY6alOL8+U/Qeu2TfheQydDCW7vMA+SWE1M89uUzeoYR0IRS3jYes0qH56Ro2fB3qSm7dJ/msWunOfwWCbapm2SbPSsRC0Z02aOe3a7CFIbkWyCkltEQewRW+jGLB4tZ8JijeTzmaRMem6gLEUyXZkAHaZqm8Md6yJNQ2/QoUK/rymmgLO3PrPYnkCYHRoeHW6n8A4il2F+Jr+ypTaAAU1hTyKWQXWZm8Zi11kjmML/njCBmvxp55MG7An55pjBU+RTpYFl5Xae8t9IZubeCTVmZPDEuuV0mt8clt8rk1rjktExOR5KpqeESd7KjagO3zhPeqR192JMD1nDogNVzB6yq5qZsQUDemgg6jKZ3BIkHADq0V8QW11DLADeeAjXdEa4dNnlm2MBKvXpWW3rVxkhR3Z7W8nrlfBl79oDWFzY0+z10ZiW9VuwWSHPwkcdo4wnaeHqyW+3HetpuI5IKBXdHw4EpoGoBrbx+JQtA+gLPG7uA1kCRQ0afjLznuzaJ8XGn5a6rpK6XXXtvEy7c+CPydZH8+PpF8hovHH84jfHQQ1emlBxAmHx94lR+mfhH4LpcBFYbQY/recaF+p59QuqL0XkD7/TrTa9XakCeo8rluzkJk+8Zaq95sYBkNK+Lhq3cx4VBzv5Pkq/m6/Z/A4rxeQpUMVf79MZf0VaHsy34My462M5l+/JJdQ0RUYeLw4RrU2cfFLGnKQQdgFz2m7XLRP4cqpL6HBjtedVU73K11BWh+SaKdRO6QJFW2BMVP3fJsFjcV2RcQcbDs5n8ZdSIowvpQ7EVXeTJpXoRdWIx29IyZEF4YbqJF5B30LVYOOTsGdAS3ErdyxZKwVEmz0xIILc0tob4tlCHFmgRDeRnD8/sDwwdZ5ioY7s6bVqWliIZpU3RZkpQL3Ug9OW2e5Q9xqshnfcDYKDb/VDr9bVaD9W2DMECsFH0ZFk0jRY9vXHR17qiHbVEuQL8NoGplUHBkGQKE44BkP19qq0yq+aLPAFjJgCN80wqXBjuwgIeC5Shnsz4darraGQYWwVdXbVHEjQqoQZQpUFN/iZvmuNm6PDo174O6TDW+g8Na7MRrG0DayNqA1uzCra2v8XY6n97sfUPHx627vDHYmv4iLEVRY/F1vA7EVvDjbFVSe+lnvdSJ4IHTfbcbCwi1BwSHvYmWmBUyNHt0Mnnx5YESI0tKTxuSb8feP7o1WAF6E2B7nrlosDNQXXbqxkOVDO8bigD9C5hRkIN0LasaQnEvm9s7O1jY2+uxN7pLnTd6FUqPuCNtuzFlfRrR5OXK8lXjyZfUUm+ajT5ac5JgovcUflm5+g3i5VkGk1uVZKz0eRaJTkcBrMTafOt7cCq1rmtSfZJ9b5DtWe3PcNX6FFG5FRw5dCitJTByr3OpnJgbCrzR6qXKqzS+5sRToTArA1ZP4ot0yTupksvqyqBrl6FVx9Qg7wBJWdnMprqbU3JG5XoJjm+jyD4/plPn3pvevbkRWy3jw9cdhtt1UbVmAeIO6yBFu3sz6zVCexEMV0aVWtqE1W/bGp7cciaWj5RkSzoSQhnc1rWRaZD05HZvpb94n7ZnOrVNdiDQ62JYjj208bLzLsBS3vBbVKKEPWJqUq3xb2mLyeI01ogAxHAQ2dY8JWnFKs1A/hZ4rpgj5hzY/tAk1rPnwtjnTftcjoNkjRtqtXFAPkQkVROfkqLqUfFgTGy9NesI546kDSWMjA7ZTm9XU3fiJR2j3Dbi/ZDDI20d0AtssORag86VNevofvxGaRgY4Wt8gp/1GEd/+pYpdSsjFWT+H1orEzwyIUrGDdpypAwR9frurK+4r3qsh5WgV4+XZXyyKkji2pgTwFYLGfxAdXdvuhoRTKnI24t8O//if+v/t4nrw74jBD7CkrySdzb1QHq1/NJc/zVt3Z94Uqmrrh5CU2vQaqlq0zdalc3nRBQMBDFClwxKxtiXfrMQBpL09lf6hquh38t/GQFqkIokTsFVOdVQDdYeT1FVsw66XFNM4iPzffBnqHBIi73f6Nc1aJO8OCsyNjC6lIDRlxSdoUSuPiJ9abjUGe0gGK4e7FeCY4zvnmG98BJNdFdX206F6AMwbohHYh+KMyc/QgupOj5wHGHKU/XFUETLoy5PTSGQcV/IkyENkcEs3v3MJ66BgMpm7AniqYBPs6S0gTjR3r96S3f6D8nLLVricmW6CVRabalqOcJ9vds423PNVaMVyGQAg/tgTtNcEBqVnf6qV7ebDI8cI6LLfLT2x5ckQVLcukFFfkSbFOk6jxNnHrHxI+Oihmga5sh6Elw0nwDyYmWhOC0QO7BGdU2yWfRINMkoWwIXQ6mA1PW05rmmGfGGcEDARwuU1c4Zr10kGafExoxazqFMjaJAfBLuf2zsLOSXWrjnslxKRSUnoE05bsmtArWVO1Sh/ixUC6I5qI51+jj79KedeqqfdROZ+99xbq8mLM9DvQqH0xSZjJ24XsuPKLysgV52SPhLoDbpQU8FsiHfIxbWrq0BaO6CeVhWW7KIQhCi9AXhtJYUwmWgU++Wa0Kb8FDFWoo2DPWCWDOWhR3BFQnBFZs4KAN7LeB+3wTOGYDR23giE+LRABjsZRv47q284huljtleOn7ol22PT+Fmvl22kan9OuilLSFQ0Ak1fo5lbaSCZ7W96B3g88UczihgKgRQkmGrSqE5XSaUwISZEM+TCvJl9OpleQuFGwYuFgqAWamqGgJHDc0y+Y0N2qOGmaGq+Bp0RcrTtyeqRO1Be3gQpvaFoYSsm9+utmlbKfN2I6wnmXZuu0naN23FFipojvxCG83+G8Gu6m15l0tlb/z8h63ZZuFFHVRBSC3VFXN2s7vppVT65J6qP8ULrtHbZ4MLQOoUwAo6rcu5TBhm0LURNQsUyvM8TXcKazcpbuVycwO+E4G/Dp4nEJ1htmal5+uAT8/I9ijiFbChM5QECF4ugYNVGkHzdC8gWgFXE1smJtGM6c/oaUJtJrFQnXQFHBu4IYr5sl7msDK1YiXIq8OnOY7lXLNuVEraEHJG4ZOqxFUKOuSb0F2TpFYF7O+nB4HAL5T5HkKzctzHjJ0JVCCG7McDCytqvUPcOMD0F5rUYvjbgpE8PC6QLeDoFsmLVSOTzSZHBVPzWrUSHWDmZ+pH+Y7ORvWp+IszjV+hQJHmWe0s1yozqYziR+PcQvVoluoNm2wUAGZsFCRn5MsVpPHWawa5CkJ7IwuVhNIw2bCLFaTlW5OlIvVJJFZrCbcYkU0+Qyk6WieTVQuVo9Zv1hllMoCRPg7/mLl8o5brDbRombU1SnPy0WLDwQZk4BzunrlLmJ0CSNQNG7/0BI2MbqEzQ0tYecML2E7dAlblCWs+JYuYXNUALiz/5cvYd9dwmbdEjb7bVnCCl3CCixhhSxhmPxYwibWil20a2QJO5s6gN9j8PjuElZZwhz9cWvZaNJJL2qERY3ICDsmORggKOQ6b+oG+Lj7po2XJLcWTeha1KGIZGWKdWX6P34LdYpuofixQGfzAwiLxymPxoZqOwe2j91QLciFg5x6do3qIsJetTlF1zDKETG6RvX4ATzA45Tvbrq+u2J9K1as7266zsZjOz0Gj23/IdevPahGFig0ypCs7ebVVq9pikH6UiVl28rclZyOsGnd41a37XiCBshz2/G3cAgazcv0cBR6xovv+nM/51ov6UsYzqdKI801flHVu9yXd5jKSfTkNQBtVDPVCMG2vSjlqdX7QKxIJ0b9OCROxtHEn1bKKgKURiSPrjFWyNY2VLhpz9BU+0U0e1VlrogPF/X1qr8wJe2vrMACUJ0vwvhyBIWyvFIZOI95LYCk1+O/i8pom7OXx+4ujt/yXFZcrXAqRLCUM5xRqq7Y6DnM9SMyHva8iO4Qw/PZxhF1CewAQL57CMiIo0K6JZpuaRUiCjsDkeCkIVI7aYjUvjUQceeWo8BJt0O08E1xHXg3shTieyfBefCXrYnr9PtZtdrdPxO8U2t7uWewVa+H4aA/sMroVi9Qj8WrB+HXB4EPx9YVA6OhNlAP8iLV9NqpmtQ7KOp/cysU1Fov0kMKNEU9/HhsKyWAo3DHUcYw2u7BHU/JNoXGIUV2TM5n6zJK9St7yEueKL9ZHZcQ2qpwyXfHK5A1USurCVqlJvYDFJdJcfv6K8HzKMx+EWcp0mjMPH6oSVapVu3U+5zrPca2TyRYpEqrPvoAMBUeaRiQjPXSIA5r+LWoX1kwSgSEZnOAY80Heqiln5S16oG+tiWTpma/gprRtdKgc5z+fBjqEHhWlfloUN7tgZqiA2hEzv7USKCWfVh9UPT3F049uA714OKBFBoTYu410lPvipEucxuPs8mCIxStv8NpQwfQhubbMBsoUMulGgRutoHbOYBjsGspgHb0jZ7ax77fPO/S5OAInlXt6DVbwFEbOGY+uQ/P/U47GkNSaq7baXYFTvQJGUO1wl2HpiK6QuJkQfx1ka/EfIHfRJlAnE5AKoNCg36nvGGTcejjQenm666gMg6gQ5gJPA+KmrMrBVjdFSxpnaHiOEg2RSBiGL6q31xkc/qsTs81YARwfnBWZiI42cqu2+o8Lu0PnM6B53QOPKtzUFUtSMBfqR9GSq1X6hT0IBV9HV1nG1Vnr2LZM5Z1PMZpsZo+9NV+INTRjTM40ettM5C5bmc5eQI7CmpJW9SlWpGqmaW0FKC2liSDJttYdGRCbdG2JTlPcJZ4ny/7xw4Hj2kwQ+NqUGYWojClW5VpaWY+o4RrVgEzR7HMRjzE3XhLQhjQREIt0AU1Xs/vqe6OqNwfoS/8PkX8V5qwSXF/ObUmbNS5+xQzZqqIbq6Lx2Omy4KxBoBnbUx6L18k3npBXQtlJrBY0+WBEiZ5Tu2HUdNarKlTvRQOcKPWcZEpzfOXVv131tzYQZP1VjlXhWeWbx5nsWYLbaZFKMpvpa1jLNbQeIs1OSwIFGMs1mxDwtYxFmu2G8shW8dYrDnFpY1YrDlV04rTsCtB0aMWa3bYz2EMQx4SHLVYczpiRyzWnHE8izVnbmixZueGFmvO2tBizdnOdsljiHvkGqxNHrVYs2u8xZrHbmix5nEbWqx5/IYWa87Z0GLNE1yDT6NijMWac9mCygLMr5zHllW2Uo+2YiQKOne8xZrdyK4GV7Zy9x9D+Ow0/uw0/aySXpCiJqrmrARICdot0jaNNCjFiaeUIYsum2kzhziTRQ7FHzzkv9P5zw08mWGmneZphpAqA4bWbHaF6H+7xpi3IQNoMmClChC5Q1SCjKp9XxSQVQFwGle3hZDpXM50rmaqpC/IUjAjZgtphlnj9RZrDE3Nm0pQcxj6q4uz+BlKQOhT2iQWa9JhyzQ1TZ+hdfF17LXPhxINZXmNOur3l84X6bDQmGN+0YM9moKxWQJbaUES7jMJC3SaJpyWGt5Wa9okzdAtZk8bZ97OJV9IdkGjJZ9ritTAae62Wyocny2VGNXMZR/Et4ijClqoRHURdRpwt4zajqgFKtaJ4DZB+LKJpqy+b9uYv0mFX1WVLRZTXlCuFE9Ews58Dg8S+yMXcm8uhNGbjJ5IFy7nvlSXz0pD8nlpYr5JepB3sM5gMXBGbnQVmhPTMdq/fIbaxI/zrWWKHG7UaiolgNhVFo/zYb4UIqwYHpwBW56vHSfIGlpT9KOMIbeJ1iVmJpFohspy5tfnIpNrFxcxuy6RI3ELXS7V1GhSWtsk9YQG8CYGvNSFkZu6YrL0ZRqWJsTITbbElVNqLdzUjHCqWbVws9VYuKkRhwSDmxjEpnEPYyzcdGHhBg8f45si6kKkX0gXKPPWIs8YWmjoFaekSOWst1Tw6u8v2biGs7Nq5x811Je8Mlr9G2FpVVOMqdXYprzKGU3lb9VgKuBoFVP/IfCdJhXEGnWrzqyaYzB8oc7l1R66Xj36fbAyaRnRkth9/dbzikQ3Yg1KqME8z9+6C9ZIaS1zEtgjGKqG36Em2D0PonWPER7Oq+R+9U/sw30ox4m21FwmOEFfdTI9SqR5hTDZK+X1pTtXwP0bldLsHr2RnVIdlWz8gT/0AbUOixfv/stwO64hiojZIYFctfFoevr00jlQ3hAdPyhm5mnV77aX+zJnfIdZISXcFGNOBqA1dQU2BRdurcHABkhQA0hUdxIAb61oVcwN2/Ad7Am5NRhQeMtA7h6vVTwkBywm+B+suo5hw2boDkx+1YNX8/u6v+AfCuUCWWQssnCC2A7nB9pm7cOoU+NB9c491bKbZZd6XWjNTihPzl9nbxC7yQGHbpaQVxFFtMyFOrCpaJIOVTQARBCKB4elWvEJzsnxYKXSDOVTq6KJN0Ze4i6muf0OtpQ/spGHAr2ZvfpAADDw/u8HOYIfz9TH5VZkUSpnBxboe7DvwW1mHAqpaicsueC7MosUrAq0l/ZQdlxuXy+GqwiREuyW+5oQtDSknrypuwsxQpwt6epZuM2kyKqa5po9lMO5ljxQtyQo0Zx/JUjGKLeobk+OuDFtbnKbV5ZERY4JcTJUMfUcDDYDSqXYokmeHITV0E05CPNI4p75DPS5IXqt2WdAF/SypMeATinJub8KsqYSYOwe7f7HyU6le9lfYpAk6FK04L+rquhmRVOSVEkXOdVHJoMCOzONoKZo6gLecCKk/hgo4kUSd1ifXzTVZFEz+0e02TQY36LJWoSecyZkq6mN0QWuoIhAqDLCoNXlrcXXhT6sQo3agyJj9zkmNTtVxzgZx5IcDuGaLTQj0RDwYw99r3qn9Fo+YN8o/RpWk3mEGkMmrRvOpHVj1KS1S5dUDBYaIEuU/U9blAjkqs1Q0/whcTxQP0xxLdo1qpJZJ4jHUb7TwZbkzyMZqu3Z3yPErCh8gqP5MGh9pAbciyD62b2RcaxgB0WEZ9c8E1zPl5nQWJJbtPzMPiulUwNAb/R3i9jqHGTjCjUPRnfYWjfnfjFyX6vLN89+XxEucb2udhkA0E+rRrOd0Sa/lv7bzlZdJXfX1hkxgBzNYbXmIJfbzK/wRa850E/hMZBtH8mV+VhlJjomFAPt8kb1Ckgdt0LMKLZUyjNODdozuuLu0zZ6xx/KcX4bKMY+uESM9go9x59Ay27UcEcs4XZeuC/PEPtyX4/sEb5Bw1OaWw/tbSmkTGYbB/jMqMoFtkY+jxaZNqkHDUvE6py5JfYfiy7zy4aGxZCnMg1bQBq3s22I17zpFcpYMLTLo3maA+3SOHuIz5cBn4E0rgTbEKliKY/d3IArQaGNc/irHL5rD7XTel4/lBvLiJID98kUTZqMsdjd5AKKnmw/9PXl+upMCcQAcUxz4GK5pfZIvo4dxgKKtSiAqMqRvJCjrsJHjuQ9PZL3qkfywTg5Eo7kXwFeBKGVMnSwDO0vQ/fdaEPHytDRMsRDbo/m8yWxLLmtejS/re/LOrUNZ7r5NirMafMp9rS57k6b6+5o3njdMmhEdWcM8RS7eegNHTcr7lHdCb16Q+fNsZoczGRboCYH0RYcztfLBtU3ahDuG3nAFuxdIK88cYOmT9gWNftY17YwnJC9PJzfpofzBSfY1m07Qeu+xeBKzRSgHMeqZlaYIa+bmvNYS1Yrt6dg+23hpTJFwG/oHH4bv5umTq9LOgVt2M6ln0KdPKEJA67t5RF93R7RYwuIaY/VfmEN0tmRI/qMuoBigEP4G/z8dA3dqOfxgmsOJnogjy6hu3VzKu+ASztoljYZwA6pPGQMT3csbwqVQopkaPQUfG4Ih1sAqn+aAszVirfCEg3XPs19KvU0/0bNESN2Btm0NkENV6UWr0RKS3aRjlStL9Weum+SJwy0J5aCpTwkarBTiZkHRWksMhVFaU8UpT1RlPbWKUqnwisPxMaWI/Nts141OVkVpfFURWkUrorSCnVdw9x61iEPqtLzop7W4dFQVWl+PGZ4HcNjsbKETWuBZjkDeg0tZ5PHWc6adjnLRpezrlnOmqWmtOtnt1zOJsvlrFtdzpymdJ3O1irEFsljiB9JZV2bp/b4dU367JY0ZHRLGiMHnVLJvUhTmtEuaHnPLG78aVX3MKFeJcKtbQkeiV3iJoeWuO7oErcwtMSdM7zE7dAlbvGES9x9Ly+XrjJ0tAwd0dBJLYUL38IljttxcjSbG/LdJe5bCK5Up4Rd4tzqppXmsRb67VjdJnV1626kMi0qnY/BY3u5tOki92K3xGnz3RKn1N8tcdrPh7HE3TBuiXOj5yofXd1Q4fjVDU17xKubqXKUTm13q9+49OHyR7TLhtc7p0NtDFQLIXeXiI+z6dLVavyOyy1TmS5TZ1Ogq9X/LTswqFHHqj+dGP3pR2dHtp0D28fuyE6xCxjFRt9w3daMEhevCDluHVMl6m/pju27O7bv7ti+u2M7Gw9oU3fRie/u31S/GrVhILAMuWrxZnGoqlG9fl/nMm4fzTiy10PtG2lXH3ffh+CGnPkNJYkqQ0dtCORZlifsFouZfvIMoUzT664iBYyziYCiDo8hFWZEgZrwQz0fxHi04VtAPR/gsK8CWg6oCRjE0gxmNFQ1scuRqT1NM5jaAU2DsmuNZYnG6YEaMrFmZGZM7yk9H8WYZvF8SNa1EiJdboGUdmWRQGW0jQgt0rVS+5DraYqcH1BEM+AH+H3yeufxwirnpulve55/rZoAyr5wo6qK+tZoi2p/BMPaH764VIe+KoS9R//l+gM10eT4Ir4mz51jQpVeff8KfEIx/rWWR+ofp/qtm9XORIi6W81jrSxAK0T9bjCmdGK/HZ5TPq66PvCs75k+9d9y436xrv/a60Xur/HZV/UUoOKg/o3wbDDiR8EyQwrcwLqixFF3xMhgkxLSuPAyExfx63Ifrstx7H01vy0Z/5Pqor7qfrIlyt2ffsen3sEn3L4YvvReqN60ic9h+59CCkfy41M1NlWpLhuzj4uFYvFaE5xsnaGpMxG1/YriJSuFev0XPo8LUH8F8l1EQekrU6pRf7LJeeYrqI2LhqQz6emhbHmE8kBa9gm0dEFPRCNR50Qa6rKaBM7NRCfNfhdxtfSVHls2Da4dMS/qywmxaAyok23GroreuKqMU4x1DKdq1t9+lP0cuDzwfDhTzqDaj0B3cBgdcwrk6ZAb/iB9nOe9jLzT1ZO/WOgRuEnnfX6z0PJK167pqzzrVt4zxzSXG5vETCWAxExUPMwOrBwMSyTGaxStivq5KI5aRXzpppwMBtoPmRLRlUUAC68hwe/5EnCpV4TGTqGv33M30g+UztuNZrpq8QfmHYgi5u08ewUF/hW53Aj4YYgLXN14OniYeMakmj54uFC2+oVBBVpSrEfWpJdPJBp4EprqU4rE9U0oXwnIXanIwgWnN3pDZvacvwrjNzI0RmB1+lkrhtulAXgRhV55hDhIA4ImeHBbFVUxL1pYIutL2S1Ajb7344Ba4LQswvSmOIRjU2hRO0ITm+QYejE7+ruzNxt1+Y//od61UAvfIdU3UHvvGgPeO6iOIjI1ELYdD1EdJ6saEYmdWhjHpgY0MqDJEvVZd/yKa6A6bY3FUYhcEUMSIeMRNnLn1JHa81ZVby25rmUv4qcLhLGVZLcCFhKda5ZcblrILYhFCRGH0AUeWU8Y1po9P6U6qpS7s3pWT0WK4UEvgAZON1o3PVi6dlAjezPqLCJC5qJJETTesF3UVkhBvN4iuctVSD3ZbfhmoVxeG6J35PpURKij3H1RpB0b15UUQbXdXyZnZXJLgQxcs5oVwJt69vNqGwL11iWHrOxmSDQqkbsh5Secp/wqxFeK/BZUPgycKsyLUDtRVyXyZ+iIgQ4A1NRAewAf418fyNMAHODxKrKFchOkdgRlJmLg5RZYhstjeLRgVht3pDIFJJpdmZDirIZbhakZu7XyaUzedKb79uqAkkAJ6xG4K4GjcH9KFgWLfr4jlr8SRqDzOAmP7IQ/GJcz3twT8i+rykpCjR3xggxGBFjbB2DxltyCKR3dkrM+3Etl8GAP0F5PMMyI6hoVcufHWcTm5IP/apIHg8J5d6dk73/5yv2/sfX5vyCeJsuXK3urRYSYgXNUcWiF4wZuByPJhw8NHKtpEDToH4iXYETuY1/mOrP79boEn1/EooNBftXDRfesvawC3yitdj9zz6pRqgqdC0MuEApeDXUIBpKvnrkERJYnBqPZprasKRA+SWdXXOu4EFkF2B/Tlz3cCWgB31qKuA741fLE2HyCjlKCiyvrSmIigFZgiVlFPQ1OAN7qHYP+DmQS9yzxOqN3AWOFIiAWWLbbCaxRVbHn3jLA44rDgo/K0EBoYZ1U90H34ZL7ZUtY6+GyJRdsXcnDcmjUD0suLAN5UD7je4FeaQ3dt2pmAWRhgVpiT3+tskodqQ1Zg3W3Ytq1UoHTJ0/Um1R/U06d+r/9anCoiDfamx5TIE36UySJ/qYujGWZ5ffnLGl2pBqn+b5Eq64nOlkaIfUqKiif9AJV0Ru3xPrKh0MLMlAmzi6cDBlpw7M/8Yk+BdmNQrdDCsvIq3qFAym54FU9lhVG2SvwgazdUf/OG58Ejc+Q/Kusi72Io+MXLWHQyrw2pyc5DW0K0TZlPisLdnpvPagLJaHaWgE9z6otSyvWxIhyI3dFb7jn7G+eeeaV1UtPrulBpelCXNwdTfDFIY9qpZ8UrOK+6QA3SW1Z5IJX9dixjmsLxasK4SK2WY4M1H8g2FYuZ+/j5d9XcDmUAqfpyfUcuoXqA6lGS3sOchxy1CmEFUZKGHtNkQPXzjpfJY1SQB+AUNVK7ghHqPMAglP7alE5L6tCULzC2wCijz4kIcdiSCYOkskQJNMKJOsWkvURSAJ56yeAZMJkfwiSDYYl4JdSfQz8Egc/wI28nMkZdmtNsuCDZljKCV6qm0MoOYMUDUMVdyaYtaca07zvwtXAFRqlAtnC74Hy8jsHBILeZTrxwc0K17Dm+Z5jyqlCvdRtk7cGslSBqhEthI68ldTp2J1Y8jLdWyTlBc6WhBb18i/I6yuFIPkUlNtDRwt98qs00Hd98yvD9OYHgvS6DfY1Xh+G5/nBXrGKsAc/GP2r+4wHvWsKT1vj2yzXcxbPZfF616Dh4jHwrWKEVrc2EBMcQKOrNPJnADl/HOTUAZMCUIHhQDBTXmbNpPDs1YY6B2DRTR+PvYKbS2H5clXPoEzoYCYEfw2MUmVwDg3Ss2tGIPUqWVOwY5A+kX+6L5tu/8n66GOQ0nMZivgge7VgqZ/9s5qsVgZT4GkcIaJfS1DCxBX4/+r5ujH//5jQSaDJmKXb/xciCzCskyKCdfULSJzM7i6Q1qhkA61oLMnaw/KKr6HmWtqp9X8KsqbsG7rcTnFh2ccFyEn2FgH9X/peNCpjkm583d2UqEnLVOAkXRnS4g2cFm8wqsXr0iUVk+aki0evOkvZvyKr3dPXsn/TVyiBB7Kf6KuWfiBbTuznIuznCCyV0K1AM8u2H7q76vRSr8ojLhD1WjxCbFzEPxVA6eE7eA6QG+/crA+iWRSpczJkzwN+6v7E6dX6DrP/GwYXTZAG+NqHQOokX+b9A9IZ0x1PUMy9CneDXVV1GwNcEMRL0/O5+H7XoIPfv8lu9n3d7PuYFd9QLHTijACyjD3YL8GtJIbiQWQBedNOy0BIZl9ZLYtjSEmkEUn6XIO2hN7ggY8EmqHCE4wQWGrpAyI4nsMAlzRRduACW2XpkE3aNlxP+r3c0n5m+shNqsjxtCYUgBCwR/fGikQUVHZ+YfpXQdi4LhZWzMlNvNIuAZhpKUphy2/7v2DFKKZVAaIYBdU9pWTQ+yqhXLpWbh3yM94X/DO2aXJepRs6uDTJrfZ3QzKdGRy8kQlj3iQO3vwaBI3gvEV1PNoi3At2kFe9mEGQ4w9yuDpp3jrIO1VT8x7u6OQhPzMXnbqg7rk6lK0V7QH4VY8mCKEaShugRuwFPH4Q3+W/3kjSiVvkIZBR+zAF/PHq+WgHPplE/I481QxdmjxM7dWizVIojKJc1OEX3fbAeYXu2kJqVriLpviuKbL+kzCR3C0jDxruf12TSF82ZVa6YDZlnrM8UUtn+cdNgVr25zIDN4+L7XcN+XuC5404zlCnFS3ns+LlemjvZvVZ/JXd1Qlqq9SXzI0DzGLmskwVaatGrsL3+qG49ZLlzu3Rcqbe6j3tybd94fojd73q62/+Bg996XdTd3jKc6igW0XlZudsD7SBxypJ1Ttd4sCV6vwETn7TiA5WgJUPlC/RYbx/2byvumtohV5o06tzkMi48w4dk5ADGMu6POEngC7NfetozJcRAvVHK3lQq20LyqKNERJUwoFkXRWQLad3BaHIYxzQjvpurcIuoIJMoRG3+4LJYk9FoOBVARCS57qsN7nU+Ik5yqF1/G8EeqUsmFLV1yivIZH9NTktk/tjruICHaSQrynbote06FjYxepxUxkwZ0H7CgaZSHqK4HARrhqfieFgsGqYRu4meZCp17S3KnnWr7W/EJuJN/D6mGo8J0cqksNFsCq3dCIKKjVgbUXFLDCB5AwnuuuAdEIOy+dxcixWxCzVLwH9/UeM/qGifyLoj5A4X9VZoOOaJ8OzIShnQ4JXJt6dEvtrQHuKK4d+RUMQT4wHN4+H+fY0tq6Yr4LfdZjfGIf5KNpgPirhQGMc5u8yPKVeVvWWwFBhpff4+k0P0dwrbNqCXvZeoS/3+F5QoWih4+fAb2SvfcUYpkulsNEQTxc5ni4a5elcOlKVp3soVeCeZGdJsr8O2RWvYB3p9fKq7Br5jreLcMn3w/jasXWR5gtKtg5aXMBiw9ZFytZFqF9ZjzFsnc+t+g0pNzCHFGIoip/kD7N1oVsAftEPYXoNZzCPCI2BtYLICMju8LDB5+Pjcjwel4FYOJkGq6XUNRxPuNXgTHxS6BtuQLjDknCHQN9wHPoe8/zwEa90crS2HgKcX4Xk2tMYLPu4nqJWEK5Qe6jXc9f1MBrXQxRpeojCORCN6+FbPS+scPihYnJkdxVqOEEdM0OQFqLrvtmqII73eHqb08dcjhGKhNgH2RtkKtiNTrkzCPAKdAabK1fHqzsDZYP1wMXtE/aChz5as0x0/w7LD4W6UYBfS7RAG50dNFIF5WwB65Etwxtf8R9gy/CpKGgLs+Y2DIEjqDgHD7VyX8dZeowzceOsGXO5P7MkaGxiYo4hd5m4Bk/9JqnOSTslaTvVzYGkSYIgZbeW09+ybCIbIgchL3sA5AvbiH7mXlN+DbUiaMj5/a3Ef5f1NFkYepx6qjfjdzmvbHqoKDY8JkqSHyHnhNrQ18+QUw5NOswPbKA6g9mIsyLOUyYTMh8eyqOTMFMbWR4F6mBXPLBBwLMTbrXd99lhq0+gBsd+VmcJPoEPJbgC5jCcPHpSkKNflgOQKmkKGcyEvt9T21cOWmL6AuVMoYf5FLgst43KArmETR6sdCDXJHk8/Ms0sdSPGSYe7CrsvmaJsrKjKzSleh7r7BVkFSYTi1FV56ONLG2aQNSEUdsGeAAZwMVY5AsoNfJAF9NUoVhWxoxslO5Yv1HaMi4WREM3LrvG75SwjGOzlN20fpN0yGqcsNkvBaiHmXhh1fOdJu+sJO8aTaZK8vbR5JlKcnc0Oakkt6rJKcdW+vcpz4uuNYozFX4cmji+8pdVZ8XVMzoXG6vHZMH7yriqjkOtxAVhy0Hl4wE/5Py/stcYDA5TfbUIV/JY2BEKRjLIp8iVxxSBOzdrZ4yjzTx2/pDT9H2eF16rjskyEConX9bjqrJPe4YnroEE5zCHLKCj/BjgLJJf3GdFhPZUdmCSXTMPeGuhxmmwQ3A5uNncC6QJ9SRu+q0mIoEo/eteDOO2aq8jAgdcg1VUVqK7YtiXIvod8OPe2tLQmEBh2b3qITsMIkDGWyQVSyvJ6qCQ8y1RaGrIWbPUIw6v8+Y625J1qq+IGCelMG8xwNtcdItayoy114zVHYqX1rjghLRAka+gqS1qYx/VplR9uIKReyrHNnnQWk+RAfvvukjWCESgz9pMFv3QaadKEopGVSQbTk2CHpvQOFXoVyMI0OnQolKU1ffSf/BPXqkQdYwoFRYhxzqlQq7tBGqEqMC3aoT+T1TUCL/J/zyOvJ+fdadG+JZXODVCV8tDUhzc9+irDB56xTiVQQA7W3nFqMrgYcTV0v9VdUfu9EGf/K5f+IsHb/r6sW88EfPSN8p+a4OCV6eukzVISK07OvLBV1xYWiZzXmAbZv8E+S2WM3ei4T26GjG3AGtG+gE8tcjZFVgUwZJs+5RvUJsooWYx/LMVW2E9tiGjbBVShPzC/17aywaI7O8wbJzXv9euTZ4yrR7piUyG0Ol+6zx/BiEWQkI4WWlYIHMAELU9DUxPzdGNystbVD18kMJVsOfruVPNrR0VSKfPBpw3sN+jk0oYqhCYY4yFetnt2mGw1Q6PpBI7gwuvcrqjyy9p67O3V3bYZkzV5pVnZY78QV/piGXNrdaVryp4685ZfBgT8cnwHVopTo/YmaM7PfpQHiXi8rDxEsVp9EDs7e6fEYMgscWKPvtyXLmFzYSLbKAvu5Cb5J1jLjBJIm6/DcFUv7hj3RdvdV/c4b54F4LYwa40VeS4P5b7ZAk2tZEEG2a9A9SrUn1ZbAIxwm+ubceI3T/Vl8ZRk63PLaHEqaXsnUgHOilu5gyjtbylG2fRPmgCgbN3IHEc70utlYEaY0s4v7VjlQHAVlGMUvCrbX54agBugv86XLS0gFLl1ItMmFh8pLVTx6hMFV5pIRwcBXKgrEtw8VxcY/c5gAOKsHp8UGsFKdyR++n6eC/tC8ipnn1Fe9+H7TBEISBpRVM472b2TnQc5YgFvjJd+BBxqu7LzF4tj+ptgCEHrnlg9eHdpjytGHVNdUsmFevgTCALYIGNjqmjqdw8MNBDsgK7YnWLYsrO9fdnNIGUCUC2ZIk7qKzTz4yBbiBLWVs+iYOYNS/3dDAU8lwL1hGMEMqhcKmc9XvsU3NSqFeNvqKXYyA5KtBIXYd5zAOM+RTm5xBZr5Xv/2XPc3rFtCohaZFtIO4Ml8OdPvTgjDhYPvRg4eWzthVHLrZPClF9MccNgBVf7TnPF+6zbF46Y7SAu2L2sDPGeu4mdMJxUx4XEhodnI6z3+uTj0ppE83TBPi95X2/xgjw4Azu6HzZ41L+waNNnN+/pmduDYEfEF3vCo/lWbW7FoBFGRfPtYUyOTKq5x0KEc/9mViiGR6B5735yZf/aftvLrZPmuVeF7M0R3Ojpn7HGvqFGcX5UTO/iN5UGvm90z71yhEhRU37ftg+XYox7PtB+9SUAk0SSLQsF26fyDACeCmMNnEaHvpfadr3w/aJT0esAPOnY039bmTodyMzvxsZ+XXGXhcA6PWNHDHxO9bA70bmfTcy7ruRad+NDPtqvAJ+foxZ396D3z9mHmyC1dpFNki7mbq0GQZp56k31tAvCiBkl8xztED4DEZL5/SzSvomQTK5Nre/qcBC2cUmiTrYdOaZ9X7k/hawm2ZJM6zIN/r9HU3tlc3cxnxhWYGRYUzTFP4uLeq9IlOV08m8Mzx9J4QXmFDBPj+vW+JZKab9QkxqHNp2HZGrhYDKl2T29rRtJlrvn68jcHIUjBvcc6Y8nashT2p8k3MpZSGFL6XPS0d8XLJUgusIKPqNykcJKXVkMe4Mkw8rLsm0KXXYf0c7lAJaC7PaJvumbdRetW78wk+9dTb9RGSfYyrGir1WeFgj9oi+Oitay+0Zr9qW7I0Vt8879gxWnLdpVjwNcYbTBAgm5EIaC46oKdKjyaX+Hu5WoAOU+zKmE5dhoGhKDI5uNGij2PzwB9GNXbM6doZ12TRcwn1evgm6cptGgQXHeQYfug8DH7oPCR8AN4FMMWGEZdOQ0k7AKMEkJ+Cus69clqgFTfDedpTumtZ0sOBqvQIGB0bi2YwZyM3h1mdgOaRjIcMltPd0U8eYOM8EqeV5DPeRWFjPoIpEMNJnjDTsj25QJx1fMk1BvoXPQry+T1t4cvdENCnwi1EReGB00RP88WEF+wUKf4eX4JjgtssCo4mWI68KRxWqyk1xow1wsd6j0dcol0qN3IemCQHOqDVY0jag+c0a9+I6XrXv44+q4+3D6YXkxitgo/A0UU19nbej6yMH+AnDLigquILKdfT2vn0Wc8hroz9qn8UsyG8X9IUDJG9zw9WAaLtqsmo11BVKja8R2Lh9zf7V4D8VK5XVy/r7j/IeSg08l7BIxegnE4AQuGDryztlDwXKIdXz5rgVKp8P9mAe4z4396rjJjJ65+ur7GcSZ5MaqKoMskyriaGP8vl1c0mnQKZTgOaB8Y5z6ttnNfKj9imgVkDqrBEYAYjO8jYutqWl3kiGyZDp7kj2QS/LM2kBEpVzTfv7jwGOkLe1sVkQPyA+ZXnnOBAKDYSalZ6iLcqpdl3fMdCC8qQbCNI56mOOTqikTpyTTTBALDhG2W63Ih/wRMqHiYRuZraXeWbWJ+2srOdHonxeJ49WYqaQI5Y4UHKu6eY1V4UYoVr0ZJgm+haaUjaQa1K2TZ3yRo5PGJ3jTHrqAF86iui5b5fWKUmbFJhN0rQ8p2kLrrJsoRkAbcb4K4PYNstbbl+bKFldUsLvJOe6p9BmxbKM7CJP7nfpBiN44Qu4nVjesW6CbOkWxJzkHuLtdt6qbukgxWhB9KxGbc2hx8dHtcPGxPZ3n1A7bIfTDvvF9QcfF3j+sHaYPYBQOaEmaKqxQl5VFXO1F6oNjELBxWX7IQ5AbxkaKhQbEvIkD1XI4+Os9FJUglNomCrhborqMWY9j9z++xguGMIDCKyw+JhwE3hs4q3pnyWpD4k9/+F+qn0G7vTfXaBT0SwGUVtf0byJZBtcq2yD0SToaqtEX/e3bI+oLiYVPFGoTMaJ38IM8SO72SZmCXw6OJa4xa9tFENtu5udoAmlobiyCPP02M22VgeynS2a2Ms2qV3dy6Z9X26jVZjRluXNdS/bAOqm/VAwvUFxnlAqmGpuyrU49AZ74wZuBfKmPAlTcG+5v60dWi0yWA9aKSYpUCet1DpctPCSDQ4Piik54oQjM68UuwBkEfF33AP4teCfAU3qSxMvK4O8pQdJQDGcUgwfoHDXUGyqOVq48ToY0NRh/r6VT5ForVYPveSoo2irdEXOvx54+5f++Ok/drmef7kxPnoxnxNVUKCqu9oaboNfqYJqVVgXU6suJaOKJfrVwwyS852CCQ6BplYH3MCpvGWOyrSRYsKeaij4yp6aJ8bZzsly9PDZQKmwnq4D9b12H5G3xI+e+lnPk0q8yz1V+VC3aOxiAM4+7HcyBimOodCylRXZIvTyumnrhN5i4LHGyBTRLXvDH/hf7/zbZ376x69q6zCZZtTLBEyklntDlspbi1A5TDZPyAxJxemWy1DBCEV18oyjStzRT6q8uC9tF7wVPWRfRYStVTc2lYNLCsAbVGn3vaO0e0xsf4ehnttKHd2ssCeZuDPiOSk+yK37AAdvQzrg1TPQ7H1KuvV0zOuvBMtLsjxDhf9XkQbNBY4Wv4R46qUAo0LDz/THfGg9oklK+gKrXVGeL4cIyU8iqjjqcS2PbAaKjOsBaCSpspO9Tio0PT13nV6y2oD40IlWnX/2vRBdfx80q8XklwqAke99Xh5LlL2pPypzrqvMWaxbyaljDALOmxhBNJE0x+slzThMUVvUvPSY2nzCXWNp3RGvEPUXqhlBc9040dELr9YFjCq8+eOEzEkpZK6BsalZpeQ6UrhiAZj1uxjIQ0/JugXqUktnqviiANAqjf2XBD9xebYbyrhQbTgWbXUVG6X2upitk9HqW4scf/bTXwuxwL9fjwxJPyUv+zVEFBXbFngY7MPi/U2fixD0XJOcerjEP3hX0zLoEfQiaqIqxD9lkl7R3TGc95xz/XMQ4k3sbt7B7tbYp6ENT9PwJef6l5QHhOQPHSV6p9d+6LzaD0kouPy84HKu5VgN1fCvq/iLiMKvi7ofUfh1UTd6iOJf10BoRXvn8x+ciCIZv9kH7Be3Iwq/2f++3kS9D1H4dVFHJOpINeooovDbXxMJP9XE/K+HX9cgsf6L3zJq5IisqLkBdRybjphh2X4UZEbpi6E29nTWFzRTdVbAFufYUAH7ZTsXQz3JFci7Q2282BGAZZh1pVt3Kr5W4oERhWGg7NeVLGibhVMEyfmdG6rqwh9EnjR9Ctqsatel3RYRGngKQzkEbIkknx/WgyhFElfSwO/xgpI6uWNJ0P5j1+qpka/uI/PAxkFToHomqTfY/lA5ckO+fsnzoSnidDAj474CZYeqdunj4atH0wQqM1hckZiI02NpL1ITSn5MNTcz1coUvVIKs49WdTHDUhczlFdRE4AuJj+quph4KUKKh3Uxn8JDVBpoifprXzELWKSn2hGU+KSp2vrsN1G1nFhHG93f+o3/CMqYnwirDnSqmu22tQijlFh1GGLjNtmVosDLyDi9VkdpUN28+hp8NIN7OrDCESyXKpmhcf2SGb3JhGNEG0A1ZxXncPiui3pD97BmYU909cDnuR77amZjcMKsGcmg8Dc8yU1FqcKuqoGIrscc545fZGHPiNLqCgvUVbwMVIWycpAr8aJQpXfZAIgN19eoXF8DrK+BXeZSc0FLcN7yX5ERZc5wZ4z3D2ogtwAoKKvS4hIpjlJkKP04YfeUOKMcFurKbIbSU1wRhpflqqNiTbExfRpWgnSTz/GUY2L7u09CBxK6lr+zXhSwu1SB7FbUEBdHtRTDwhnsGhEE/FYQwJ1yedfgWKOqt6VIJQrzmPvZq4SEyvj74GvubuAeTn0J5lcgWkblUfUtc76RffhGvoL8MSK1gNmBq8knPPd7GsBKjDr8q8jHJYll1ac55unzDk0Nbsez6hl5xX6/ZgN3mU/uxvNez3lGFgrW0oYlog51d2NJSFsV29cCzfE+fmpvuXbEgZYyAvRVSfuOYGnv5N+fdf0tP3fNk4wT/FAzWQi54xsFk36U/QnyqlLDkWilak6EC2b7BUir8Z5RwWmcIKdYxRoO4671IR8ZUb3r6xVxVoA5wn0wjp26GE+hDmt+RdmSDRvIHU8bk+yBIQNfWMA3oVIlyu3vy4OqOhoF6Q1DV+z3Tw1f9f4jXWNQ31HfXOVwheqrh9Qs+xNk1YZhKbBGF/6WLSV+0pWyJqVwPWULKFxN7/Q8ax8nKfwVo2fIU3ytMFfNMN6HC6doS37FHMRhtxPfKItpZVl4OFq45770xhe+UZZB+ixHAMj5y4rIv6A2zw8PynsRBVhcdOVUAwgfwi0e8dPMP/PG8VMEwvRXAs3IaZNNlcwXhdm/ITX9sO/5owufc4Gl+nyhtTDXD4USMBSGXKXqgoXNP3Id860v/EV18N6FYBW9ACMn6jzSZl8oKv908TPPPPMr0WDhe/RKF1N1/GT7mIQ8T7E20uXQqlVK9qy8zO4PaSC69niuPZ62p4b21E6iMbrFR0lW1hluANHXH0DUb3o+/FwJuBSrlWj6TtoUWLocmt1g5QKALll6eUjcIoLfRPuxWIl2SlB6cx9Ujaiko1cx0a5VaEwPVnXelJUoRehJGpLu9oyRrdP38CXN1fSHGCvGSBMgSDc+AfmqoBIUI1HIw1KZWIDxTaDXOhHC34b+hKMTx5zrfmE2V+oPpPwsfTAWkW6ggdB9zi4kOwQBL0LOjCIJXyHx7qZelnckNvtTNECECj/z6VPvTc+evOg5gLYMlyYaFmKlKeOAPV4TbIFsresqBhCHeKEq5CZcNRx6Iln8xFMCWZNRuSI040igzWghqxqxJz1tb4qK1VKemQ4GlEoXLWMiveSXWzG95a5NRoG5JN+RnCKApciankV+jeyaSHfKfswesMB4vhUTTyDO4eCkdK0Fnhx65DSBqzO35JMp+DOK0UhpPUV86sFpUCjTT8TsIk1RaGpVZvAYTtko4zhO6mhnstcLXz5FUys0uYq8qdXHi9DSiAFmdB7urVpbM4Oi/Fdd0qxohUysDuPdauyFUcmthD/s4zK3dPTGP/25fh64Pivgw8GhPAIllUKi7NNSiP/sIsZ8EPscMOp1+o+88Tf+ecd9Fw+ukkmX/rrnhW59cYsLLlGTfytHwV5Xb8PFQ5eOyrrBIlT9LjredwpDvVYUmMoP3wJ7hrdAKw7WDCmUwkfi7acJ25YNPeN9D/dwmksVqBBy+3w3Ow+HDNypVeLszwAdkY9H6OCqrHfxklqJA6bIdrh/t6Jcfe/b7r3k7G/CVh8GiOlOtPfWW/Dv6xezP9bbk1SvtmpbQnMJwy/tIEYlSYD9u3BJRvkvdJSxr7pdDuc47XZ/yZEFSeSZI+aka9UEJRCQchr6tmkPj36MHq+I5fmkX88bes3d1ihHNE21Mc0PnuQUVPnB/aL0L5NqrZhwl7BMDV/H7Zf70MZd4nYjwu99vBz/oV6WUqsbQyUSz9E6efsKphLUvKxX4FiSoFIpfhwm1FtvMXErTei1MIpXiwkcqUxQCmsdDUrwhy8J32Iqejg/zfTwLZ+C44tlvjm2lk+7+aCKF2HuQUdE5kaLyytmwWkEUnYxh2NOab9SJfRKyZLrm6SRidaxgYmCeWAGF3QmINa1JGoeE38esQcimrexAXGl9wO15hR4qGi4WLOJyzSU3IpGDjchs3mBBQ+9CdURQVMwUGiKqYO0okp7Hqxxsby/IEqh87JWzNLs4DD5NAPkmFkrzWLy5BoAmfriSt4DWfZohjqXCpVGLBg8sCLNoivLhKdbfVn8aZJRwRZ2v6rYeDI6Mlw6y1E3UqQpU64pmdnTjmuPacgUGjBFM2qznmrU5frO5baA5FqPzHnDHuK3+ZN23xq3VFLtgd/iACiqLH2KBRyEGPG42TBfNRvmX2QZqz+MwqYc8obXWtoQlrTB0IADvt1p4tsh/SbPmgXo+3lszbr4xH9sVriu36rMHNxXafWv2Sf8seaT6ovzDGuoOKX/YiF5enWVEjXHQ22KaWKJmstrqr7Qoc4y7ma1h9fpPBIlLSg58cc85KqegQpiauVNzHJEpco0auvy7DNK94YkL7Dm2eF24XSqvTTUlb5fPXbOoIlZWe4xvfWWbWyo2xS6QWFVfbMtnAqIRcaU2zhH66iR1GKq0p12hfNsUweH//yjKnkC7LViWg80OZnJ0KCYpCk+O977I2/5u3P2XPqN/49ckBewiezvJe8UnMEskV+926rEz9XHX37zI094zl2v4qVrepVb8v1nvmLP2e958GJqr66sHNr7v/7u8le+4+bPXoxRaK8M1P4QSnXfoXeZNq/Y+PtBpRUDE7r34pXVDS/YRhhcdYxfABS6oBiEfoUf6bIXMFLruZGPo4AWr8U6PSDhJm+Qu0uBaqfBrcqJCzZUruUcXMOaetN4IODYNu+V5CahL+ehDc7cUhymVsmZ8QLeEF4VCKUtt/xVQs0V2MvRdsbk4Tqo2n7uL6ohJYpkF//nIh+OB3DMvIIeHBpYmd7intXyruoZe1ZXmAN4wDOu0kMVqivRG7JsHOgR3u11hvD6XVFo+uBRCGYZuCHdCCx1ctczsPRnKOKXf/bys5/w+un/zkxNXO7CunvkQq1XXlml+LCWhrNILqauVtzqFCr2o7v8Bwu/6dAFXBkF3DN8qY6Dt6rNSbQ5HjT9cj2ySD9Wr0PYBlENkKG89bbfL2mbrjv3e2P9hYS82tzLSYTA3TZwxAbusIEVT7h4pa44JlNWSEPrSMpRz9LLWA9/wBsN3C1WoTHZOGqZoKVEiVSZmacADYthSumKK6VoDbDgHvUGlLpYRK14vFCluMnbT0CAlM9oY21Y8RAQnIUVKbwpIdZDUNxhx85mF6A7TKjXK+BMqCS5oyCRasQMtEM7V2CGZZWw5wEJ4Icm4fu2VVpzKiA0wQQ/b1nNO92WKnNwn6eDo2/HPB0hfTuKtxX7lvHLUftC/HLMvuzil/vstRWKn+5WCTDtZoTj7C91t63v2f+WN03LdGVoVnRdzD2dmmhgolMJwyeqrgMtXS1E21iHtIVr42qWRAXzJC/JoNyvYjvVsdxRW3erbYWeee/iPVnBFxPq421Yn6nDGq4F/+hkQY7I6jUOK/8oNBTW2H5XGu6CqXSxLeqQXCxUjAYFxlV7wE3ochpHT5iYEe2qDMh11Nhj4TlqSfkfeX5stC2cIpwa3vYpEBYjVLGN3jlW50+BytN8FWOBlIobf07yzBvFQs6V0Wi4njR5cPgLIYFiWXaNmqswI1Wz4OUScD+7YrE7D9YZwfOMwWO7qdY9tbEumb7NC+1mTDqlNwpFIZJ7U3bDag5Jl11r88QoFDfIz9WydYNdWRl6Kmyi3mFP1RpaqM1VvlLXQqTam4yYUHJq59pa1I3VmX9RKS8q9a2L96QIqk7eyzAFvwgSbCyGwVAx4H+LBct1nBcRZX5RHatsjIMPP/mb9l/thpJmfrP2/+vpIrVxhrIV91+HiezqfFZPL+uaVhU+bPEgNEBT+eVmffErVr99CE5+OhiyoxsP296C2CI7Ns44lrMq7+xv1Z39rfqo/S2XLqmA+kOuBpopnaXyk7/GJ87G6t84O1zqs8GcCdZxZl7etd+HXyn9aUv4vRA/lyztY0O1S/xHkbjuQR+0KHErE8FUV3Ip2iLtQlxdZikeYVGzx9yjFljr2a+qCbC8jhFC9rzOz/UWWGN3BPc7XqhqqVUVgVg7WkfVoVEKME4N8NakALLTb7K6ZgCjGupJBD0PQTKb0BFg6WpXlBNQAFEiceztlxqIq2PqMVT/tqo3EJV6AxFe1dIs9AYiRDi9AbwUPLLDegPfj3P0A545SI/7n7SnlDEyhNJnaT4ar92STmWfLa05xRtZc7rnP4ICwRdjOUYtp+iK545wamM4uRjrqoAfeI3jxZ2qyrID2Ck2BnDw0wV01MgJf+HvpVqVdbsCx0IVsSFr7d0Mzs8vDYtsZ/E0hft+TUmxaDfBqt5BtLslwZsFEGgCRc7owxcwZjCYc1K5v6gGB7QPEdxNlI0C1AfVM68IalbmXO9PLi43WDiQ6PYGFK6phci99lLtoGr7ZTX7B6mqDss8Yd+nEKstaj4HYDvu14OCwfpcPdWS2kAtqG64ryskrPzO5YpYV3FX7qnpKs3Bo0O9Qj9u9vZ+4onXPectK5+7eKD9MrLO3+X3sq0ht1VvzM9wWfbqW6QlUpj9I3IpoQdIs3/Cu1kJKQFq65qtc6uFR/8x0CoBHmM/lN0nXwCvMQDwER4un+vvrvRuT6V3GFPATwXWFF7WO9ffK1Vrn1DCruxLpswIYjhpqrbuy4hXgrVdj00ixdrQaR1ocreSvDia3KokZ9VkKqGL3+dmXzGnmCvesH6Fo1HOyNSYWFC1k1Ow+Px6BQscyFqX+07B4mmjChYXVpL3jCbXKsnhiJUo18C3eOWNi+yraIzzVBGIpwpMJpPCscAj9Z0XUlDUTCbPZXqKtXVANRjWARrpF/DDkIdq5IZCzVzIaSCoHgeQf9QHwe1REF6L9a6yK6+6GCmj4Ymh9M3Aha65E0sYYDGz5msXD8Qbh7P0Kgpxq9kXhBiz9hCeg73/dP6/fuPJZ3/t4hWxIXvYnX9aDw23Zq9DzsM4zRy1FBsoCIz/DzdDi6jiCaSu8K00TZj2RDxqesP93bCfXrWfDVrft8Zx+9Z4BH2LrG+OBNiQkHbI+eaoI1sdWOABC9b1E/y64sR3dE+xyZG+FkmvqAuV4AD6NIqpByKvYlfRLcRiOKxQ/TzME1Tmu5siVxbxBbXMwcCj6maCYtGKj8CW7+CHj9Iq1gY5HUUTpMx9j99A90Dn4U+iKyHi0AxC6nNNQjNqmkfELg9wJS/iXkC71S6u/6zyNf5QCefMyFwTaotz93i5iNdyz5hz6Qy5EPMpxti7OztDCgl62WCQ809VD4a8Z8vmV1ZV3UKRVzE76GnCgLzDe3/1I1fd9aX/8Q98DvZD8u9XnR6CyDVX+YRzfhmWH54jZ46auufWI6t7F1Y8/v/7eI3m6zQiQPOr9p+1EvIsEn2Oa/YP45RzBE9sQ4G8FEJPx9NdHUbb4mQ4ipMhQQoV3jqCij7gcmVvqEHjKs4hszQ6OlVziB9U1ShlObJSBWvGQf/O7E3WjSt8Wzq/ZzCHt2YdnenRLwXjzAEdGnRSU6hal9XMRYh+BYcfUkWDSrnwSRmMMzCGypQdVqtnIaLEQKJeg/FhxhwIbhxkhOoz2BvSwgQuiULb16wDxlYeGC3a0NnAws43iEZdd40aljMW2iLeHMO0XH3ItBzHRmpaDmNNdTX6JgaJZYsmGudJRbTv4UzD00Ou+qi5uQjG5lBSWDE2F1ljcyhcWJpDqoiNS9cNLG5yB8bVHpPvtMY3bkFUMUAXigG6utXVr1PodPWxBdPm6iYHBIwaugUK7cNtkgJSPzvZfRWHtXVVdoms1TDnIVRNz92h3mqv972mQ43Kob05s79fTdgrXVsuouzrEoERsQq7i3CKilHXnXqeqC5zQ/Xqm2qbG2JdFPL8QpSVW9aMQCLRKZctsExtPHbGkomfiFTJ3vA1GaPsG+nSX9OdcCDKaeIJqFTzReT6GIeX129NUp7aVm7Wui56iRXnexUVcvQwwmM3+guR+dVyWAF0WKYQu6XsXwAcDOrQ9kR5+QR7B9xx6cPMrwxUoGrOeUOLhdzsHDGxPKM58pRjdgzFtFS9DTF9rhY72yWT1OYKEV9MWNMf3N5Utcsn1vLOOvohsuOYMoqGKEjHEBAHbtWv5h8AmFrG2EQ+hZt+ajx9CkM3zUNSObZUUZCL6HDrpuB6tXIx6jAOWlfyTmpryqgzwO33in44TdJ0xTJwJsd2U0ieogkZcoF0EwbN0LQZRv/1PZ3lxsyVojFYfZIRiZ5fxNW+y8bLEtCi4yp1wSt7hYMjuSAvH1pVR1yBzYEFXt4H8qz7wnxeqswj/UbZlKJjbvJm5qPo6soXXepIS1Cm9sx4OS82YXy7lAFU84DYPOKzXI3aMxhn8inalE8EgPi8QHoFkB5gsMuXFQEk4D5lT4N1FIbuY0JvRsm/r+telRfBmGZOx6ni7o3juX2rGFpurUebpFV62N6RRriTqerxeoyqY71pu64eIbHF/Ppa5g/bWmp4W6leER5T7SHKDg9GK0RfZ2iT2FSc1Fm00I/4UKWnCL+oE2maAtC7zdyeBVkr6mIbaQHX3SOEen0uGZZHOccmSaIFGJfZsi/fitA1ORGsIOB2b049DoUcKhg/t/HfdqwdY26jn8J3xy+nkPDE6rKZtqFxRaSigJAJESGccfgK7sd26YfEFKfQKTBfcSpJZvt6GrdvC7fPXJKcpEQLFJtwV4tMS8NXcDjj9AVKgJtFJPliSbtc8ml4j+SbpsgcJQDFYM5nB8cl6+JOV2oJpQUIJGSHNkWn5aeoPEWu1J9Cp1dNXfH7Dn6nGIk2dkoszYCoamHqrwCkiU7NTyFgsNU23GKvmhAGpaACwNDOale4TO2v9oZf1XqPdDGvduikGo/G8rC55j/klqe0NcetP0abZ8h+v8d9CWWMItd4N3KIc52QsR/uRK8yhqGMYVyWczmXY0a2Wg6vD6PlfMeO8YIyANuwe9xG22HVeDttss6tFzDwDYbB3LLMvmm1XU89NdeCbnN5i6paI1qvFRMDsImoupT8hc5DUeeluGp3pCMXnmBsSW1L0xTXDdgsycIGqqOny7apc3ibo9KY5Qza2KYZ8HYzQ9KnVukHu0V6JDCUnJbJ6Uiyws7wIJQsG+aDmB9hKot4uFfGTfwpGUVhSZbwzku+dDga1lyKaApDkRjauWQYA62mUkMqxeXc/zWwA1W7BbPgDa8A/G2c4xRoqserPK9ps85fdN6lCVSZx5UhQcvESlGnuoZnZv2uEnm3fmOQSpJPEzSN0+vZSvKs5S308reyfdNo7lXSZlyIWzuUvVYW+wW7qINxyElRnlFs2l4N3GQpzjQgwXOMkxACwZ/hv82QS8n6gvUCe4NNGMkeNjlys29kURE0XiQWQW/HoqFw3BqATmyjBUXtLbQ9nyj13qfxxZZygjIAcBA8zaM9oaMr6yJ13KX0dezAFOAFVAbAJgGw6oSjHuJ6Mu2KbRonDdR5QAt5LM2YRDOmKFqSLuI5qdudiCZHFuJiKZ+hzShxM5GdHZtKJN80bg4AEpocIvmq8XNgZ2UO5DkU4fGFQdQcQzFl8XWigq9jEXViLKJOfQsQdQqIOrUOUZWWVBFVuxBKP4YQdVIRtTAYOukwFExlUWLoNioMhi70GSn5jyyGgueZQeEzx8dQHejNtLiUb1WAbjKczSbaTpMWQ7d+yzB0oYKhkwZDtwFDtyNuu8ZpA1U7fjKfkmZs03MM9A9qhtssei5ITShjqKZFxCwSoVSioqThJZbOjMPSvEzOR5LH7zFr/Qtlj6lXkHWnac6KdGS2c7H4pBDagAN2hi+KUl8nPD/7dR5aYDRtFxWPaTcjtzDZmBC3JNP9DpayJaHtFiwUAejDm0GY+YqqkEioh+34NBbe6coSpwDZruKN7ejs9uqUREF2C95u4Oxd/yLRKvTGOSjDieozdZumcDoHgtK69panbaO664Zn/byJx3PzVA2rN45zKNlkfw4Vm0LmOxcj2+uquFYO2PKJ0i3zxJowP0VWEUjmk9KiiWEhLvy1DAtxq7pPAPsUvHfyT6V9beqIEHdKq8vb6FKFolDHCnE7xxfiYvPHzjedELdN7Q2FuB0W4rZTytxurRTeDmhSP9Tzg5UVyta7rT6MrVtlk7hrD6S4o72ugexmZTxf8PJOAh7ZEDymAI+qL53MwiM7Pjwyyk4eHhnDY6oiQ+6QZWuSIwM0qj0iUgb8UgqgxAwWcWMU1FO4IRSLcRDEKJ5VzgIQGEImZuOqIH2ogGv/uwGuXQGcp5VQVj0NaB8eC0HbUDWeu1IwrgCPiJ80ZU8DvNHTAI8ynEOsPw1gcAAuV/aGGjR26Fo8xaA1OeBRPw4pcGdqbYoqR2oZ+ZVDUszfKuZk1LGNb482PqM2N7690fHahqhWQ99WmE4KwSvVpI1ed6Nqj0yc8yIhWqG6jc84vun6QNEANty4wKvBLZW6XBeCwVBDgHfVQPcr/ZabWCqKx40mpdPPL5hAtkt9lgF3j9MmKF7e5+LP1vi2s8xWRd3y7gy3ZwVv+k+r2H1pD+eB0xQ67QtlA4bbjEDr+bItrHprPBZ6UeVA3Ncv9BimOtTWQ38R2eO0KrmP9SBj5MzOexhnduHomV1YmaWhnaXh8WcpN/bkz+xCObOjaCy5j8kfIvfRKLkP1efmBuTerxxLUzSe3G8Mj6gKDz13iirwiCw8ouPDI6Lo5OER4RLAkA/boErux54g+qmerFXUFD5w8eDZQ2oh/7qhWghSTqQWgkwnrxbyryepFnKT7zVGFWt0HiSFtTrH00G9O4mE3h6kGdNTMXIkhAvhOFeDFUX+K8/Vguq5Wt2dqyUUontxeYnaVRZxZftMuXlD78WoxaVQ+XMfTvZEmc2XA8lCjx2tE9eGmGClCBnkEcoDaea4DC23iqRjDsieJQY5Nrb55wxv4ZDanAeGeh4YCSpH7qy0chbobP4d9NR/r298uQTiZ1NfclF1QANrVReMqodUEXV7xguq5FXMIc/5EVTFbZe/YnkuxGPovk2Qfo90zdg8Ut1OOQ+0oiOoWUmFLmJxXUT6G0EAZj4YQ1OLYJymEZoeoqfecuExe//QKSn2ijEoRzyWcsSOkv47UY5x2g/Rw9B+gCVHi/bxcbUfonHaDzGmw8lpP1Rp17PTzzfjhlrovXadjd6o6sXp3nU+mT7jfDJpkkyeexA0e9y4L3ms/y2WPKuvJXtsqnYp2mWGvK413b+upi+6mu53NX1VasIk4X7jVhw2vTu0WXrWmshFihB2pkLskVtyBaK6HZmgADoFRniTnB7QeQEhZDQxMw3rvRpw5Dv8g36RqQgho3TJpCXweCAK+H00FlvQB4QeT9IExGk8KBOlCXASW+YNauNYu4MZ2Vl/FDaBbnmm2e2+nuIGebMKNe1sBb6UqdilmSotb2EMOhSN0WeeEqvaEeFJ5pmZpwwPbk49A3VU98aTuACT5AmAhgtleQoGUEHHlja4Z5Coo9MNPKYhgbpKtLASkOxEvSU7W++pxFIH16Qg/OEaUlRNKcfgsQ+ObSlVK7mo0RbLf1f18slSRQBAbHApImcUyRFcrbu2AdyTVJfPryzq8LA+jQgto9o2tDyfAQDhYArgo0cIrOa/I7Ca3wZgzVJMMG0gQJuhjMCMZ78BKzrZgzoJHA8/S5OHixmaKWP4qH1ytdxY0eTe//KV+39j6/N/weMmTwO4mHP3+qXY0BkygjRToOy2ZdxXd4Yv4k6aXiljaPrwqgANUjGaHN5wBLXa1Rcxryfevu7yn62EOFF1pKbBB7R/hib7XvYNdIzrRh5+FfM5svvH8q8+DKzPeIj+yu3HmXFPDKLXr62z7zxLakN3Qygct41R7/4efEQzQ3XFNTwCxGPIXOOSUlRqgFA0RRenSMcVIWjRMjJE6RxTI7TM3JFP844hMxNGqrgMeeKUShpZ6Jej4/6lqmXBf/NiS6eLcpwrnSmag98aORGZFfhvWmIhs5+HyMt/Pa6gmy9SyF/6tCit2kwL1OsnEBhLaflWro0gmZaVfgstwj9JEer9yvBgyJF4IX7Zry96KH5fIC96Wn4soM1aARw/5LnR5N8KJnSRFuVoMuf6jgXWf8Ko4wRF876nAuBrpBdE7ZwLEYkzmOoedeHmIKRJue0puNXloPZ9M9725Vv4w63ccZIewZvU1qWH2SmfaKRTgNpD7xcR2k+0Fei61RyeU4fmZVS2VgDmKpDiF4E3COlh8fpi51DsHM0oxBLxOjejEOswnqhfHn5MUIbvMt3WS+UtmFEprB7+luq2ErwtFdto22BVDsU2O1J7il6I7vJRRd4WuTEQlbQDXFi7jVNoXD08XJxKpw7y09y326greNaStbbYukTb6TTahtzZ4WIH7WCacPqwFguXSKJewJlP5QwlyaLT6fTy5creKj43X9KRgRMBWtNKsoXY5qK5MYsgzosCi1MqCaeYYzKn4dCkurRX/PKGekgjJS5yV7ai4BaI8zbZI2yr6ClqDdgXakEN6DfK54V+lyAiR0HFSZSgR05dy9DthH43sL/B/IvSBsIcAT5K0JdI9YKCSATVaZGmz1Daf+5ScQZ10T0+MzwT262ngo+77AX5TrUwfxandpfzTTQJI/shXO2cLcYG8sdgkeXUl/HhBJAgk6FNUNYunW1Z/lidTvnjKKaCTHStyDHzfDvzisdj7nEXxijqnIOZyEmEwFEE8O0RBPDVHe4r90/LX7GZD3ogoQyznaDFj6XHQl3nCfQ4ehwC59JZvKyeyRPlbKbAj8mnld4KwJyFgBSnjcry8WG0EKdFSwwWMaPV5U0uM38rYjXIpEqHkTCMx3TSdphUTTEBnhCxZwYhA+YPbdEylZyg0HNLYkCGuNCi1kNbEeFc+6BOfPEEIg7YzKPZFtEe3DkijKW2R+re7PqjVWs7vtV102YgFM81PLZQG8jU7kP8IROmbdyV0Oy3DTRbtNacpELoFxhivbkk0nnOHxNetUyplPLqKkCms4TOEh5EW0BmWHFNfZGJjyWdmwyGCP6fcrI9xlfaX0BpgdqKjLoyPV4WzcfZFQotMf6jctri1iV6vDR5fa+xcmwFOtNj8xwyMtqKpqppPG0cuJCybXM8AxD0TfM84/8M5JCfK57yFJsBOv5IAfR4WjS+Ue204I/l/Rw6B01B89AqBd1Ws7IuqDbfuoV1M5rc5rru87QNR00b7tA24FamdIkzAqdkncSozlmkmwW7MEsdPDo0hceU8hDT5GFNZiNYIpKTa7VMDUul2HkGi/jaoPl8ETzpCDkBoMZTJGU8hPSZgDIcuTIbFRLTxogqvoUc3CrLQpsWTToT35LaZIClgg1gIeb/FoUBgqUFEpUcDnTzBUtpaCGf47LCYgFFKbekVS0qtkmVJFWeS4sWeVi/APm1XgrXYVFIT5CsGbJqclYmZ8rQASMIHvu4adwTrnWzIBrNrW9IaBqyeJyG9J/7aLRlEWBybVkA+Qkd+YFk9CTh0zbNSh59EGntpLXbieXmepUIbT4JIrRFeUVMDT/fzDWR9FNdT66rS+d8zp/kC2IYJtyQ6mypUB06AdUBmVlHeZTqLCAO+LtAM5X2dZH9/ypCpOy7kJo85IfPowiHeORZ7cpF8hgNN6QljnIgkJa0oSCaHCIQZPJlllSdo6QKNGsi36pkgZgHlA0c4y887EBjlKvIz5UA5TmeXFV+ngQyhuOEkCWGGuWi3GoxfzedqwNdnCvxEnk+5RrJJT2B/3s8knbTeSbneXg9n2PllQsHm4mVCPNxq3K/FHN27a5wfhk/bf/OFYAAaltVlvAEbSaKJW5AUtgOaA22nHO0ezojtcs2AweHN3xulunkOPFMS6VufDJM1RR/deeNTR+PR+jYksV1dEMJAxDbV2Qini6PoyaXU89DJRBaIJnZsPk4s8HNhMeumwkO2Wn9RpbjNkvOxzPkdY481s6RLToHtHlk5sLm48wFnQcpRbIbUC/LurPVl4N4yaCZDRFc41LjI6yhxtuCF/WDF+Q9SqlrVsLcR6G6DRGhyYJlpahFbZkSdkd/xK/s9Y/aFwI22JddGHn/Ya7gEUMjhpDF+ZAUPBHoIKDgpny8iMAfJ2egfEzOSVm0CMqrsqSnFBZbRyUVFk0V42wDbMnjUW60spTILbgj7RstHJWefOlbc9Jpbo9P7YFkinn7KPflEcxoLYChUQWCTjg3whs1yhZ/XEhsVi/jvhii0JcVvJB5OYiXzLzsx4taZePZt4V6T81DzEVsD0JzjG0sBBWLeFxSwFbPKFrnObhYJgUQbuhyPAb3H5/n3NtcN/O8pKd4FiACTAn+BRRBabuaGrSnL4uyrNFWWdIqYiD1Iqo7OgPlbZh/Vc3/bRX+oNyVAMzGbCR/kl7oedeW1pdCCg6JF76VAUUQKV1xaCCOFbyCE91B7SDbD/P16Xtx/dh7KWDzRV+PmRtLVIfshaOYBvBbbN7uxVvRqJxbrupJQp3qTkjeK/C14q98do+P3xUufVmsOfowM7wkdzdr34NPqK5m494P48QS86O93b492sYRMed29u3T9N8CP3DOLO5wthGtluZnrC8LwCW7Hj1te2LwEY52rb8LuXNcOz044OMIjoM8nPcr3dWXe4UiI7scwkV6UTxSC9DuHA5N7LKmwG0YAkjvYXzoZvNSQ/5lvSp7E8ehCYS+3eQvwcEFGq3Ggm73s5ejpc4I/Q14ZbpfNhftwDPMvg4ZvLZHJPg4QSDYC72Hi/1XJBZaxsdQBT78pKf+8WpqgkuMncHlJ9JdlTeiSqQ5nyCuPm1ByJM1Kf2DGEWUz5f6hrQH58qxDrWO/PLaYIAbNre2ltdEv1VH6BrnbWR0rPT1FXhlCPMgG4SH5adrKRAt2iLG44pBUWdkR/CZgxV8huDVHAylucYgJMUVlbV66cJkUFFPK8MrF7Il0kXbpleiESb8KoT7HjtSC64bcabiPJcc0E/EcYNqsKgfhDzQe+xhxT8K5iz82uLDZTgpfnp6tBGKzx1n3Pg+r3KHGnZivujpyfXdg/Lkeu0QgsabTl9sRh1YkagNLIXerKmE8O2V8BrCehD+ujIYHNXgkC+duypfHauE79MwDKLdZIPcmsNl8G4Xu19iD2qaON7Rk3ftWmpUAQbrVAHwrtk0SVUBKl8cWB36Iti/ugEo0FxXmnzm5vS9np3TPhdvXngsyzl9DHFKHL2RA8OCLXT9FWcQ8PET8PhDPNc8JQLHPCUCFUp0h1clRStelRYd9I5PjG72Uq3swMbmYV9sTMA+1zyfaWxt/ebFubNaqzZuuYbhnuX10jBXHgNIdbGpT7H67inqrAB0OaL3vv4ffnXlX3575aLnXFB7GgUbLwPszxHJsCQGk+5/6HHMhRL8KwR3S/AogucgiGMgWBFD8IuI3SHBNQS3S/AYgoSgmiVblODd+KyrZDKPtcbMfTrjamy5GhP3KfjcgBFC7Bdkr8bszhO1V4vimNzkdTxenDeqSymT+sQtpfwG6wONw7gqRDF8qCqAkVT4bl2tr5JvXK1W19VY19XgLMYppctVGmswgnkc9WYIzZwz/NoHB+/HWupjEfUrHs0Uke73VbaDL4TAKdiUlGjn0a01DwV/0cteg54bo8X6vdmoI/1HCl1IjI1HWMMvL2J8KjEULTghRTvwtnLi3rs6QtHW3no8inaXpqr540r4Xg2DcnxIgkoSfmGUot1f+eqgpGt4RcOYwR9DFgS5NRKrxM0F75DgEY2oUjR0zdKnm103ldLKO7JpkhZ1U+WLteEvgjvkfTxFW3Gl4bP/WBRN2EBgdkWFz1E5GO9cT9diR9fqAFWsdK2udA1U7QREDHNIofG0//Po2WuFnsVkDGk+E3pegkAIvAsBIXFFXSlekZASu8Pg/Clh+/yxoQ+vQ0kV0jJMVjCfx5KV1x+frKi730dIVva/s5w9x942QlbuuP14ZOWIphLCRyvhYxrG9H1fGQzuv32UrNxX+erA2134Zg0DcT50uyMgEqvckQveLsE1jaiSFXTNEomDCFfIyo14l2yapEW9rvLFHcNfBLfL+3iycrMrDZ9tTFa+S1a+S1beMIasKAKhjwicLFl54/HJCubzOLJy8OGSla9FrJwflf4q15OUa81UO1ROnP23cjD7KdS3INNDE930eHFldrxwdHJcPTQ3Cn94dlxQ+58O7Z9ZxfpLqki/u8T5UHE+HML5Pdwa2KsVn5AHXy4Q282zCo3WybBLUe0xKBTwqC2pb06DrkXk3G3C5DA+Nxnd5LTuvN6OPKS+mHYXkTVOdCG5IHRPu4pkewSHHsOQ+EEJ/ROw6XLj5QkmVRF6AJGXSDDj0F6EULdOBekbpoJib6QFJ2X2lis4LAuuUaTdCLKfVmzt8+cHMZp5hOB+CdYRPICgcv27DJuvPP0Qh98QNyAGgRWTGxtz+pFy+pDYVTl9vdnBpiEK35jpCmXyoAV4ey5+rhJVy0hFaBsSERRzbXaTmUABfzvCpbvr0r8QDRupPuZcKlVmH+iL59z2Blg/D/ob0tEV33ofsYEjvuCbyMOAcLfJkwsJ9HlM04O78ayuokdtCffawP3m0wP49ObAue6V2A95WtH79AlfwPgM9N9NqIND68j+oXXk6uMvIy+2ExwSv112isdCenWKxzrFlQSrrQh+7qjMF1BkJzakUanhorY9U1i1tGfJsI8WLZTM0Oi0EKt0plJA6X2ScDN+s59ZR1DVqJpaVi6/1pJ2CE29gnxDTtWC2gg53akQigxaaeTNnsZKN2/zqjYJNMP7qhnWhjJoA6w3Y/SjdJV0l+/jNv+IuUe5wvYpUCy4T3gVPyHsRfPFJW23iAYUrhZxeYuQ396MKbpS1K+0dvNXs4O4sXJb9tN4DIqEI+MBJatUr9hyXcljMai496zvWfzC35y7cOdKWWwN0c4/o/vmgYDVp8/1AfdIfaOgNSGZusPRumO5ZEnx+rpD1B3aui/m5ru66xvX3feV+LnLqb/vx2qcUC0j+Hucn4fs5wDAIiC+Q+WB3mRFKKQKd1H1Dh0r7O9g+PCD9j7w9i/98dN/7HK+jdxAomRtIqkLRz/UvFJcD4IWIrmFBaW8w1jaXEZSwldNegMu5ipjcgVXfTFoNje54JU9hpFbWlzwKpGW4KgLGuhoxi6u3hYZYrLV0ZrV7KcA6Tc/wGSZffET/13SK1qYXy2qfx+uaccUYXxaODjLstfDyCOwTF1Tk5+9ATHiAPQLgR85ie1Rvs2UOBuPX+W8oMelWcYQblvwllJimITtRvsfDSANc8WOEIgXT7jjqU79jBKYaeJPWhoS6gDClGDuhvxYxLLEn0E6HWd33Wiszlele2o483u++c3rvqmOMR6wq0mT/GVcsBhaVbKbgRwLaNAx+HIZsgLQVpdsouPv8BKOKvCT4dYZrM92Bnhmh4qM5xdSuoeKGPYDxYzgCnH0CqU8cuUJVswxFSs5h6m9ytXFxH+MCdktMuPl5GF/oEw4xVKvu24hBeJnN1/1Nqu2dH3VHFoBr2uKJuoKpEKREh7Uk5k5X/3uzHloM+f/yFPIm6Io0kuML/13n/RJOenDctLXRie8ne15S6d0Hmrf8wkFRt6hRHmLZOx2v0ZKSVpoUz37Z+C1JQjckwQ9CczdykS89SiadKi5TBMKYX9kU0yBaA34Qm10hgLsGWUSA7C768Mqt64D7HWxyQdo4A6WCcHbCl6Mdxc3W09Am6YIFmBbIEqtClGatkRpBkSpZYjSNIgSbnbRjCFKz92AKE2tJ0pfGyJKTUOUWiNE6Wop1RElAZejS63SS0TLeIl4GHTpdQe+S5ceEl16gwc/RY82VSIf6mCAzI2yH6H6ifZwiW7g0j8NQyU53/EEJzQEp/XwCE6oBOcv0GtKBVypgAskR0hNlXcJHO+Ca6GdkmfxlxV+dYWfkoxMiVWt8MRCn/H9dNKEY5IbmI1yM1OWcExXuZkpEA5xbz99AsIxuZ5w/OUrq4TDd9zMCQhH8HC4ma8wor+EU3e4bb3IiWmsbyrVkakRnsjoQb6lrwc8E7jZBLDnFkH0tSRS7hs9Lfl+87xLk+EGc1hivmYy3GcLOmoCGBx4RJWmetLUJ1/PX2UsH8A6fXeAlBs1RT7YH5nAfaEtggPpl3wvHPUZYBQ9fv6V45zYhQLLIV95ofOVF476ynPpkgrG4SFUAO4DXvKytyCzuo3jvmSH9FWcJMH0uT3C9ZUQYmpAbs5CTvm9x8PvM5f2GZeIYcUfng9/eF3x+WL94SnaxHiU/vDiEX943KHsj9UfnnosRHbsTLlFw/7wKvvNb/hivKNx7dC69LOvHF6XWpV1qRTCFU4IV5QCtsoiVZcVDN81ShmeXaCKBi4d8jOV9WjjpSo0S1XdrCv1ij0PbMfrmJu6EOnsb+VtBJKiIaYSEjJfYrHBIpe4Rc4FuYgEDU7L1W2AlkoL25CswrwV50jKdEoqCyEsCiZ2GUMH8WhTix+jC1pIYWVB+7rng181SE9u7Ugwwosq1145NHyEdBPeVaqtSTIvb0Mw7SMRtb0LdUBIKRF5w/rBa6j1FKAL+Za/jqj533qqlpDoBc1wCXwhuLzAmH5syEkEcMpXRSq5G6+7XCw4OI5AqCvYyGWIONQD2NnOTfZzSvCdN4Y/jWI9KlTrMZX1s3kcN3wpEwt43MOzS03GZAiZxB1j9ofGBVpzhw/LyhpilJCpomtos7KG4ntqyRo6oyGcrshV+Bpmbh+DKDXA1kL2x7JN78D0WF0+65O9en/iUrmcw5wOcAGv0Lomx4XqnI98rSfmR8JeHqSmDIgHJimgukguzeqbGNhDbY2/AyTCPea5yzzJPLN1puz64mgzznkPJSYp6jDOipDWXwc1C/iBWasu8YtJBsKkWqWoi5dMqxisjpkDmpBY8sUqRVPAnKIumuAYPPaJVdUJLJhaaVkstdnEQxvlckpFF4Zbj2knjcojaatrYSBu/AMp5MoigAXZSURoSdUW1qQHONMAqWwJtwFbfNlnAMiqI2mCK2QY6jsknMWK7DSuppYs5OcLwnngEZCK2CscEUI6g72ydu8PffD6OINyllnwDJXNAyqiuLs9LRSxLWteIvt1tM3Zs/AdkQ0c6RW94ivF0Jf1L1XSWHWSFVCI9IpdjaBqVyPQ9a3L5FU0l0Adhu1mcBGOG+IyV9VkkD/WZkYn1ROjsYkwlyUGNYwXGTX445UQaWUfFNZKOwPLr5oP9G08JEIHiYgi6SnDw0EgPKwQOgEEqjDAMhuoxahHAog8AFV/gedVXO2Ezq6HOlZk1oi85+OaPHlw1wzLW120F9SBG67EFCElpsC+JZ4c/JHQpRaTCCEFoaOmb/U9f5yzRLgr1PNhD9+pTxzEPlAbF3vf2Nh7xsbePTb242Njj4yNPWdc5A4XeYtjyRZls60uNam62dbkrJI8U012pt44Nb2AgWRtkw35ecxuQ1WaoKlq9sXbZ1w9pmd53vCnNf3U8GMectceZu5narOsq11lAyGqCUTDofRZDuGLGrCrylV88r43D8wXpMu1uuhNb/BQcunoOFCOFTyllBygGX62YrXclQ8FJmaHFR7mu9JVcSCv6AQ3KMDcqLoqxgtXEg67Kr6QYcHbA+Oylw+zrMPPABn0+INbsSpEwEclGzkmHrzyoTsm/n9QuzNJhw5hdZCP8YLGqqs2j39+TF8yvGTmpYuXrrycVSNsIuipQgP+z3N6/NUkgJ23MarygJ3aPkOotH2mYZEE9IVCQ8DgZW+XscL29XYcPuKQV/aovpvqPrqYgEzAbRoIAz/rSOcn4t/Hz4YiOM5BgiXAp6lzr4mONAVNMbZY4FK75Bo3QuRnh4Rm+FQmXbwuCdiO0hQfoQPD6JfgDdC9XTDoXZ7Un/2NuzAwlJa9Q4mQDFVhojHEQDYOGgK0p2jhsbdoS6u1jGICvh31kyKiCXwGmyyuK3lKHC+XnPiZe+KKP4IjIUgmpbkMbz0xTYXb8cCsw7sLNSnoKb8EGGkpAHlDO/ROmcEtgKBFbdvpvXlbmpu30PAWPZTmXvwtaW6yUXNTIzBRyO78DoBs/XiQ3Zm3pbnfOZCNN4SsrvR9oavZWzBX0Lar9G7Mc7kFPkRACZZ++DYlD0Uys6EFqksCX9V5SuW76zTxXUbHK1vn/Pm+EefP42KxTuiiOFFTJ89vEx2u9HfH8jcK03u8yup/rze8/AsFcizFB1CcMipjY4+MjX3f2NjbvUeRhaq2bDj2ZFkol3XHSM7qcABSDs6DKA54Gx7LCYV37diFAesmVsfs3bIAQ6MQkSEiM43MQ9WDuXys2lEkLs0DwnMXBVhqaqo5h+UlEXfuGu5CyUeUwdTEtvhhM3JTMXRVR4xZXhOJaUCl61KWwsCYsjqAaBpHR001gigkBI/2s/IUU/PH2p4xi2tNIjbzCWrKJ+qUS2+GLGe/pNTfVSobBbGEXufnhUtqAp3SvvfjeWplaKbdhRHdNXW9aKK52HFbX5nSQTBryTNeIKLvCbGtQDEAPkE1c9iA3+yXzUVAMROs5V84dqL7wq5IW52zrha1BtIWaprNfZs3Zp1DvHm1C4ZdTgEfZ9AM2+KqQTOUtIFBM9BHVxAGIQE41WenG0cZswk19qZm2x1wkaYpFQISpHd6ofUaYvzH+sJwoQIvMO+e2FyGeFcsMuviHwuZhPTyx/Si7tX8hfpN9fVCqu+YTdnFenL7WSrQkurCo9RJRaDPQjRF6K1WTxFUiUPhq429R1cqsnDBj7pfXj3uAUdT9cv7/lce3y/vxwM/YzUtJZpHPZUefNwTjhXBNaxNNVECi/eJWe++R3XsUHMeW8bCvIE2IEkwWM7+1KyBLnNaHrU5azEBfs6gn/h09kTNKlbheOCsTbpPoRU48pVIyhm0LcMiGkcrbfV7m1Ebj0mccS/J7AQwhNOWdXeK+MmClmpr8mmS6CPD1eUziB5pRTGr0R8fLqSYy+4QujdPM2TDHKJZE56j6TI8S6EI/SfxMefhbw6v0OxhEVvrIFKHGrD6lBjToYpILUS2KEUWa/zKsLPpq4MI9ppjTIoxpyZVO+Z4a4Fvf4+SaqB5xbCizJY8VgpN/uFb1JJ4oBO5av1/2H2Xk2sFhn0OXJyclFjmWcl1rOheF3RT38cxTx7nGblWEvWqU+HUtbMlFoZimY+JMFForvFj1FDbB2IYv1ATG5BNQvYIbIquLCZ6OSdTW7imNk2w2EhNuGidcQqxKaitHq+0XMcxCIB+Sp7ZTFRX1E95Xji6pXKurhPtWYCZA6Gop57iYeTft4IwSZRFKfsV3eYitupGmr/PI7uzi7DdU8P4SjlkA+cn52l+2asZ8/fYiLV0X5nIw+0yvey9yl6RX7WI/z5E/ntRrV89AdW6iYFbtS2PrfGgCMRF/cqhPETJbqAgEET0sIedKxVkwSqgsXqYaqtC64dNCbtrJGpTf2Ww6mICfM4xhwe69X865BIb+gr4NemTHpYgHgRREn3IMeA/jQBHsy+vpc9GaWNv+PgGjdTgIIBWTuY1QRMIEhAZSi3C+OHFxwsEi0kpFUmfKLUYIbTiHRPza6/Zx7mssAqt1KSWE37xt51a//7rmVfPvqFnV2/3vfrJ+ZAQv+vOh0RY8SHhVbxIeOu9SMgNA/Uigf64iRGhhkCYJHthQM9RItTqqo5lxoR2xoQUmxmDZBAMH1+01KOEFFoX1NPZ41OopccAaaSzRx6hPJBmZo8SvbpMqNFpdPKg+i6o+io2NfSROUGToFifOKyvcG14WNxP0qI2/P3+l+v3yKDys4comx1MNTzjMD7iZ8B/pfOUO6YrB7aq0d44Pzg4Tei+O6jGEdEBjsTdKLDv2Z9gAw1tKfGEkn0Sr7kcnt3eFIeroXE0ebp6cxoUrVUuwtOrDW3ycGtkAo+ris6+IgNHPemOIwVpbmTif4DLknvVnqjxNFah+sKNeTFFYC0Gq+pbrwsz69DTeWoxA0iAV8knaDrv0CQ8YlIHsgnjYgSW7tV+cyIuVcEOzLoL7Is0TdkSWjWhJoXZRz2+4QDInqr3AFqJnktkEtyPYEuC9+uFIB4CXa6mKMk+NHRel89JVdy7YkJ7ytX1W8+jScwXQDXNPg2QwkB/RROw6tt9qlRUIBe8qreK3eIBr/Q49SQ+0ZnTunJTF3yQ14x0hOZUraejEp2EGvh+v4dtlcC8hQHO+O1q6dvBae7bsuvxcxUOiL1KgvfZzicqMKj1+UWROfuwspuqGRC6L6t5PiJ5JuCqK1gqpkUUAIzTZqExCU3wC9Cxnt2J3IohNcLlIpzjzmMnw3myd18/lPpFTu2SSxA/98dCUcYLS3818+KxfoePRtTVe8K8QaEOI5Bbp4dd1EwIeg3HKYJZdHN4RmhjnW2sXZN9RfVVhNP38wnMfJGwdXT7Jp3G78Hp1b03T2rNgzwiTheGj5/iGpprAc84Kzwj3F9yTGx4xhh+O1A/eMZZintFR1qhanP8uO0L1x+561Vff/PLgBIluO5ncGU0oRUVPmHYsyMCcEXZWYPCm/S4YJ5n9pqzdiMmowYwxS2ihgVKIBHpiXqFWKjyZFszy7QKvEUsO6PNiH2fxIaIbSJWfepzAARDNj0SXWzhJrEFbQhysLeJVfzOMWwAvQCi2HPTb/DOWaUaXPvN00s0bSA+QVvsTg2yEw0quKlO3eyj0tsYPlVunwasYnGkcvO0aKllgiQp0Pn0IEMyh4xFvJqSI9vCk29Q51Fo0KJtEELaoEAbtNk2qPPQwLTZtarzcFvVK1vVW9eqZgVMEyfToNjBJt64QROuQROuQTCGShPaEoQqh0OdqovPpOpUOXLBwAUbQUXn4M6K11LWdIJiGOa/bLRxqk4Nfs/wvpLjRufcLdiLTlGq69IKXAhjashM5uWnH1qxfJdmza6ds2MZhVsG7azOFPywsxJ0+tAg+0088ymXR8dQp46dWVU5QErpgCaq83E0faUsOJXbsAEWFaXxNJ99DClVP4wU0twKnimrr1e4CApuQZdXKlHY7zA8oFO3ssLdgwBHtN8Qi2uuCVOuFlNO2uQOZQNo3GKlbwO5qgMFaYxAtEChUizuvmaWGE+CCk8q/WPux27Rbo4i8EeizlU6j4qcLMJ58RoJ1LIPq36yWi/LI702XsTuOuvGYuW6ESvjuUvvvd7umfc1G7jLBu42l0/fZewZvE+e/Imvz/s1PbjPW3fL9V6TccU3Je23gYP49I6K5mtgNV/3QwByIHSar/rBHZEJrES2CATCikvOiK9A2vf9e8gFr+y55fMBMNfaY1t0gtcLaqSO6Lq4KVq9Wq73ykWyDmnMDvL0oLsGRSTVgMbNfNU/wj3+iKXj9iqp7grLG8pnBnvsvesIj9253uB+X7Qk7clulUIQdbuNenMZdZuNwtkEompDr/37A77OpruF2Fw31XZcopy6fPA0qg1fTY2WSkY8JKMVdDg9GgaTwMxRAVkpBQ2NFDRyUtDYSEHrsiNL+h4lIgVtiCw+b6IGJDkJKLQG10lBJ7AEd8ZJQWOqqxQ0pJY4oI/WSUHD8VJQKM0taWI+pe6mCV6nwJ3jMUWTlFWloAmEpQhIFqVx9uqI0W2KVPVgSrUSJsCFT/ZvjIzFiN/SL8QZkO4Up4QeThM/jww3FD6dBoQUUMLO+pQV/p3Eyyw8KMkN/JaV1U5LoSwxHen9sAQHOQDazoY5JkHwp5BUTKHsDBCc4h/rcCXECUEGHzMZNczdaaWMbUS2qYUsLevcPF0v7Uv/wDr3FEGnEm+8iCO9UUefyBWM5NrQ6ef4D07KASg+DNd9eBLOQL/WCKJr1fPlWq7F8JfGv2tt2CsjtovrvDJG670yRvDK6GLFfe6QV8ZIdOzcyXfpXZeC43tlDCgY8AJXemXELN/QK2OwygyCc4JYumKk6DB46408MUbS6YABXGniwDhijNURo1xQrzhjjCngCuNRZ4wRxViE80g0GcoqaVz9AzNmWVGvYFECpOCQMEsJvGUGY71lRuT93z8u3onGpUnNb8G4YDzIy2vUwGxtkB0W6IqmnJCglAQz07Mz09OZ+WiP13fHizxKTmbEikavEME3cQAjM0r3fmGuFcnxmZ4rR8IlaNgdeTRKHYi471vZuuvPmx8IMEubquiWQRMnXi7SPnGcyuLUYa57OQc6OLEKLsAJYM3CiVquNwVgsn4tD8tdUfYmVC+sRRtbvTU33LBVkd2MDp/vLG43wZ/zj65a0IvNO1bQnEldcBI4qXVN9XEU2slngj22KdMwSuG9gJtAM9ykKbQHh25QyMdKGmIZNQf7ts4W6mxJhTPwVTSDUiB80jNMrX4G7illWRYliKKtwkF+aLPFJHAeSk1htQ4U3raj1xi+Z9GgFMdNDepAjgj2FRxNQ25s6HWNfJZfB3rxIoQkVc6leCrrxRVPMyfU0DsXCyowgzIXfnZAqljwmKI/uMTYuayX/Y7TSd7BKa1l9puBXeSc6pVCpgskyNRBcu6pA0thXjJFA8xbGYcZ8kRfDGM+gcFwBGI+GNkqwXtljyYgs5034uHGHjhPb8F5WtWlrYJR9xUVfJkw+DKowDesHHGGBtogMi2aARc0X0met+MaY1xdd7jhk33FrGJqXz4tkKBY0FqusGo/9aw/4zpnSqzikedhrw43TQ+hFGU0BU5tBsmMXWjApDYglUKLpsrum3Kjxu0IGKRFZB3I6xCsI8EhxetIsIOFEQqGg3yiCqEiNA6mJ0zJ4XoH08FJupYOHfENKTyua+lwHPHVCw4bEd8Q3VXiG40Q3wlDfOdpvkp8J8Sj9MR64sv9ByCY+IbGo3NTz3zb1BBRp94kAH1YpoaKhjVD02U44HEGNXfj8miiqLVZgqiqb2j6UhkBWUBXatYoCVYLv4czbMJlKq1/XJb7OMsCNW26Wz7GwFBd8qGEoseoZZC7xzam9uVTJP7sWc2IVb1oATi9SJvwSMx9z0k4B2jCZ5tB/IR8cV9zTQHElswF4zSjOaZXRqmEptWvaqYaYcb3jWD2NHZMcA2eT7S8qndoh6shZdjuTYhC6WGMU1tJ6AyvFzyAEysUrThb8BTeMqAZ3RGBAGc64TK0ZxqPaWrCQUJTvZlSQqKvPYXHFPlQc/MpxVtq52OvQugT2VbuveGu333erv9+z8WDCgHZDMn9IHdXOO+4cKBhbVnB822L0hEsCHCx6gTiOVETAr6cM7z0qfkmfrzs0nyxQjH7NdEFA/XRgyiPYvU9lJGxf78nu0u3R+DkEl7oCp8hVGligFzX6vBzH5V89WTznU/i8bR8SgrKm74dq03CrufoN6+olMsxVyxGMKbQjbbsP+GbUWlePwERDYX00cSgHAbskquHII5mtHqSecAQMsYnUFlbl+Rm9RuU5jTvpkFoqYVBagnNXhRVqXnUOO+uv+XREGqpfqKvco1h2eAkNeFKrGyZTeVe9WiKmtwxtFPwCMhIrbVVaTPEMbdSaDSYIOCF+HZC8Job6AP5TKM7qqKMdoLHxNegQcivBDulTHNmAlbaKvpn/GpgWkxcWbR6eYbiiQOh4yVerKtbqp9OiM4zVwTrGT1FDTDHThQ7oDptxhgN8tBShVZ5wtVUEoDaQzcWt8Ac2MYsUq2K1JA9ocUFFRSWRgkPeEXT2BfYQhPaBghNJg4JJVgZwIaBMkmUKE8FLoYAsJWBsPdlJ2pHVkACBhUxMoUDaeiKXpbgdd3DqKiikipfNpz2zad81gEa1WPqPu+y8o48yTu3zRNHYT2xICdyWV8PChCyBwUUYBYHQ4bP8SHTGqNWhLd9OGCJoNx5wmKeq8UYLZcOAnrPB2ciJib7XWXaOPKdn3rHp2qiV+E6JM0PQBMirpz/WK3iHcjHtfDjjEt72e+hgLKBD7912e+rPsPRSLQKfL747JW7EGve1N9X1BX89qTZJ3+QJ0JuIrShgUetgCagm6FVPTm5/+/GHMu1VT8mT+8creUdvd2VsZ+jfBLha/Mp0RURb7MzleKglPjUfNbFwN9dHf5CYyO+rONEmyKcNk/zQ8gABItNfVnRc5AidYrFLsg36FM5mIGtjfTQgPN2iP+u7D3gFw3w63ylV0tn3Py1wyhrZcgfs72wHolBBudWKTK+82O0EN9PUSbt5jD3U+i71hAzgDK86lZEy0y0zBBlklIl2dnOAr8xdbQKLR4VUcTFwc6Ma7JAAkAVp9p43bDBNM/DAvYe02IdXPUoaQ7qCC1Ky9r08Ku1rhwwwrIAyHMa7DOWF1G6Vq2FhE/Q8hQvLVX2TGX2JtUrvKI0zj8gKMUcccVX9sqTLBicReNKNzBf9Xxc41c5tlUtJn/4NExVjIyU2xtOK6JhUW449Kpf3T1SIsxi3AqHbXoLWLMdGS2cQX1rYQQJ/AzlCWOOTB9cxZUgIyV49UozNKiJ+u1K+l+MPSLo5ui0gpufqplHWDomn6liDXZKCx+4wT+JyyOajFRbK/i5UuDlMJf896GXDKs9qkwXPIqT0Uqtw8ATcdWaWLOBmpgRCjlWP0/GiqT8EZGUu+Es4scGaBD/VBDEp1j2Qw2tRK9Px5X9UGxqp/j4uyJuLO+KfLcr8snfcFcU867I5yngKEC5MQLN8d36vbJCdddcbcthc6+kXhodBXqN9hon1JpJ4p/DDN1JwKM+BI8G4FGvwKNu4VE/PjzqVD95eNQZHg23SwQpMyUlRwZolD+yyQH8QtmtDrgX6RsedUXfxNxoPd0X9fOAs1VUfj9+ApXfU+S+pRjeNtYClaHHZMY6K6qJ6RuDjbSu3V3qwCpPQ5ITMZPhWBmNCy8zcRG/LvehM4uLU1fzGweF8FRUdgNV2W35UCj8NPMIHsuBydeDHE6kQJiHTyGFQmUiWCczUr3uP1KFXUAyONk6Q60T7R3WBw8g1Xzh8yCAkjVJvouQu6IVLmc/Va1wz2iFO2sDnpSNh7tSnP2xHL/qPZlIuCWkoS69KL9OX/xPlKm51QsCYWrK68cYwgghGFOJ0CEMrE3KYzU+YrN7VLfrBCMPrgDgwEkucUUUiZKKboSUc8XyHFlOuwHS2zAsdryUYwH2xC6J3pY4t6r0KUilXa7c8x+9NpGKQqrjG6FQ+vvrFVI/PV4hVdnPZERx+kMnrw0M9FRtYEW1UW1g5FHO1SkEK/IFinxOIfgTwwrBdobGZoZGmKNjVINx7yC2eAasja0p+7iiIBweT0E45qigvAjfUj3hRB+hPJCW/cFxFYT/EKkPU1H+6HpFeXSmVJTHyzpF+T3jFOULTFFGlKWHoS2vWsk6jFWtZLREtZIfXs8++VB7tqvsWZh9Ch9/C3ryrOqO8ZFYsyhCY89CbJ5gzeKPnJK3m5OuEV3biOd5ocx3leEF9mJmeTdMbmbK09cnzteWMQ0w41iAHwhmmwSKMJH0PbtbFfaEuMZKXW6rBylTvhnhBX9EtaqfqYyGyjBLf40QDFEELZK6SqmgoiYbswTB7WolcpeKWVuqYCJwS6llWNoC/KRQsAAkAfQVkgBzXRRbPdjFzScoyjsix/aoLYOMZPNgR2Qw92WM6E7gMUEd0FDVbg2pDsUClR2hl+ru2Ncq4eQR5mF//qoipox53DY2kNLnKQrVFSSiRQVmWmBS1Ek+oImlIt1XGAWLGRw0MG88i4ydfUv5nBirTfE6z4LRrgCj2MQVS1ZqsbWcBfSTOpzcwA7kG3z/4Zq8x/2c3cdlwk871VFAtC/fTAsA9Rb0h9riHGKpMHDaaiP39X9ySaOaElXrx+aduKBv1i4TL7OhZC0KmoTLiARvz+gV26iuWWNCIxf0ZbuwL1xVqvAykuQaJRxJU89YIMJ1YxmelNqXsSIlzwAdAjw7cppYcD9UHuPRdqge0zy3nwXG2Z/pzAU8UHyXItq2jIFsQCNfisVknjjuYOuhVsu4DAB0UdbcUFmLG5d17VjEwc1Mxc6E+ymPQrmunF/qnHdrzk+eBFJuXG1auSmeQHETBuWUfaDEABo7OF14tlKEQWzQFiAC4Q1mzzZjGI2LmUBn56We91KMiBFLoT+uN0WEBoQkDw8N8OyVzBCdDMlHc3yUNJ4xra1nTA/DHa5vj5F37Sui6lX6O/zC3ZPZCSC4mxtWO1P1i7IixmOmqHM/9FNU7Rl9sJpl9uQUqp/BpUUEQk8UqampOozwHa09j29i9sMXQSBFkRgH2C6hnRzqqplMVADDzSpEN7QSPFYXy8xfyTKTiMIg5Buw9CgOZ4zo0JKHSE9cUHYL8IiyX8SqAV4AsSjNWL/hpGMGieuyIOBhbOcEarVFw8IMyhXvgBK1BNMQpfwAzSAOcKz5QI8F9SM0LyKtWDULAaNdhqE4gY/m54730aw2YKseb68uYqF2zuPtFc7j7YsfscfbLw0bvYirBlENFP96rNXSutynHTKLWndmUeujZlFduqQCkA+5GmByZ6n85G+ciVSGQva3zkRqXcZWTSBg3JPsNrVbKhqnaKDmU41M2EM9hmUe/K0aRB3CmchdMxs2iBpy0w5LwZE6A0P2vM5PCocNosZOve+XmxEEsovXBU6V+ajndpfqoW2dQc63OoOcmiS7iHch6ISyuudjIRCQCuTdMEjcpxl0LJOpiilPMS+Jcr3dh1lB5QzC0oR0DaFmpVy+FG1aIOVQyF8x55eytR9Kz6qxue0apaAjrZLOYPelbr/wYeHBPKTkLeS+VgP5z5HTrzaWH6xJeu4kVSwieZfa66dWHlPHmGEQrgWFqwzVEnZrKsHdHS9Pz9BIlNrq118IXVgop+AsdIraKoWG0gBNLiPjHmnQLFqwI5/reyJ/7fLfJrkWviCbUob9flG4nqVuP8bxHdcyJStbD8yBn9eQl/82c9EL3Cp82VEazpzCIm3uJ2APpLQ85momzNGiT1vJ43YuFfBHtIsvqhzBDMEL8csd9iXjlxV90fssBz3aohWIm35S1MeZpGz9xTs/kS/3A2vWQb91x6+sgJVpe9zgCUY96cWE3HuviZt+JsTK7oBvaD29XNUXOKh934K3feK7PuaOT0iPttACxUsPs1MdmhjpFKD20PuFPoGTiIX7pq06P6dpk4xKXAGYqwDlwU64lizFBuuL7aLYLs0rxJJ8E5c0rxCbZjzRo3d+TNKMHsECHwtQm1SmQzugmnDsOPr1BOTtPB5zFSHPiRtIai6NcorxLIoHv+RR8eC/eNrvnLCp1ZmQKafjQ8sY9bWClKHQ9tPRwnOqUJFtgEXfMwhJAsptHAI9YmC9QK7IbCOPXwVuHABnhQ5F1EZHzrGTm9WO8b6HoYmo3dTgUPYz4lRiG8T+tO3KHiR0IoUIqS6jAqLkOdss/8mH8nBlq4VNanW7FVKoDEQe4VUZlyXcUXC+PEwNyq69x/OiitHCWNeQuprTis6qiXRIqCHEESChTQxl1ZBhU5TpG9+L4Fm1d0F//5veNXjVpYUfcXZP1cRhXJo4jPGqxilg4jBGhDNxiBfYnR42cXgZ7PPdZU0cxv3XfdWYtYqRIZThVsM9ahFIupF9zpo9JamOwTFi8fCzD8Pi4f9xVgnfn8YsZWMvd01csy4vEHkVxrmPXTSounDIbNy+qgl49fDrczXTFc4M/TPVuqHehBYrU3kszwS7cAovAIqIbOF2POvWbn5s7ObD34G1erhA6hFWhOM8peX5RY9xMgI3wVerxUeqyMHEuVuEK83ZF/GtyWo/bdgcfElHONtmxbZ5iug1iW7hyA+myKlN6jitJAdijbJX6rBs53VQT+D2/Zq6RyjS7B9QtbhwKrIVmtj7iSde95y3rHyO65iktLS2PpD9+5oeUIzT39n7/Zfd+Tv3bIn38MnEVPYPcmc90d4RjFqjMNf8ac0BrmNmrWiblMtxn13vxK5xD9uDoq3SAVyQXdv7kplf+t6//skbq7UWs4MV19u2rYHVGtqj0TiYc2w1hT2ol+CwWPrGrBe3ZOA+S2Gf+3AxR9nqmys1NleLjC1TF36PxKXOzNqAAZ8Rv88ObEfAqlslIBkE3UMNDQ5bGePKXdehwYu/K3vPVo+P/2hseiHy2bwCvaJ+6TW5b50k+W25SOyts9MHB7Li7c9TDvIB2aWoib7sQzeaEmEaZ86NB3XQ/Ek5nZ/iYPZPqFp6pxegMoR8SA35npOvgitJ7ENmBAK9F89lDlyNwBKnMH4dqV2GlqLl3Nl+kv30fosX5ywpNKyq6mr2AaRRhDT06QuvgVzxfYKlNSG/l2APBYF0sEdJq5XH4yMs9P211+Kb91S+eWb5zeXD30gftGU13ZD62Zq2QF77v/ma9WVRWVZ3ff39rtr64ut8dRHCapHhcJHXP6wiFZCiYekKBLXPXvUKV9KusqQdIyXBpWSEvYLs77OvAAs4+EVEILH/ry9Hw96sV/o1JbvPrH81649gPHGhDgXZl2Tji0Hwhu06uqXO2XUcE4vFETJllUCPsVONnaPYe/x73Se6HdlvekNfuMNJD3NDTM06Q4eI/eLY2GMuVi0lSuwnx8beNbaED43Ne8dIXi/7aXXG57tOYCo7GPyb7ye80LnVG2vmsF27IpKwkhe1Tqx39kqzTnms81z3v1jQ5IIE2Ni6LadrN49m5wjnQ7BSSJ46bSqUtbK28BramibKT6C7mEjt6gzA1Z+IrTz4xUFc25cocEe6edf88tmEfFEnZE6RGZp52IBHxIEI53kIgCpqWR5hWdS+yf3GVKs17Wmik/yXutqZ0KGbMSV5A7eSM3TZQgFc2nC/0vTuwK/4a6IhV9JGqCXXZ6tuirkGvePhCctqrG18GUhwrv8jJ5P3K/ak5pkQT2WlH3KYowiPs+rmTmaEAxS3D/BA3apKH04BwNfiSgWHQakfsbJ3/8LW+JvvvOiIKJpsoECuZZO/UgwrSZB7hWtU1SdPVJ+8omBCiav5MCXrVcrr5BH/8c7CS12bx7UmFxyIoR0TwYsL9/dH3vgb/7zjR/6JwabXr4JSaYD89MfGkxYyi2b2VYxByc39M95Q77ABVRBVjJKqkYPRqxKjV7UD6OqlWg+KcmK5uP9Wb0lZO2H0dEX+F9CEvM6puiEAx8eoEWdfE+4/0bZhL6Oy0BA/cpMkKQ3gYaJjPNxdY9hbQIoeDUFDLWVEw4mcbryQhrOjDMwEBDpiUVTvEx+m1uoDQZ6lUhOuFGcy4UEmJk2ttrkJdH7lFvSkMUxIHLisx+3/l9IbSdGUksA12fMlzj6JIBNHVAEpUNtZdMHJg/Y1Q9l6yMG7JvDNiEWNCjltyn6bgNok7QHI9aCan09pU6/VrdYL1ZdYWGTasraKEKHWbq5oNzna3s2mGmTqaOGkxGJPPLMkYs+JNbDdK24isiZNS7Wv23r/mBFSYH9vfT3wtbQZQFtGDJ2TxRnWCsnnYkU2riy0NpQ6DBLRJtZjNJz2ZNYKu4ZVtVT3oy/GzwuBX+ALYtuPczjo6oZbkxg0bQeJ1UOahfBx5ukvKGYvqF0CZUucC1x9TdGGl3apvYNYmqHZHty5I9zZB2/uMS6I74HPtOx+nSRaJQ+43QrNGEYxhlGq9rLIC9sMI7UPii5QO/tHdFnVH78q9z7UwqSqhcunigsdXPuZUlxsK2ZmqbmTjYIqWENamJvdi3zYqkFj92wRodP98LyAMCMUXxLFF4EnzEvIACkF0Gt6c9pDKzAF91nMV+NAmkZm+3usik+oln87T1UIAFE3mqvIqdMZPcd8BI7ayVnM2ik1gwIngK0zAgoOVVR0h5YDUEud86KIr0gx60SzjIWreStFw89RtJ9g7FT9cyy7ZoOhXyNaVO4zO5GnMBBTJN3s2LEoPXFM6M5hGlNvXrFqDg8FwATbLS4yvf43hbfd+DmnSJdADGQCogZKEZ6VOeQb0gNyh+PFyoXHFBLlVO4HAnb4lh/ms5HcGXJnmpvRCUPOrZ1WWY6uC6GuC2M2Xg2z6WqbTVcGRHSbLsyx9YgUK2oK3VfmEBN0+LWpr/eb12T4tT70ihaahWhRDU1+Ci/Mxb31U9ez/D+Rqrz0YByGzOKE13lVt1qhfqp3HGWIIjNnI7u5i8zmzmB9iJye7NCzL71CY/ZnUNY4pIIu8WcDAp2Jx/3tfbPScQSENSFxJDkkTUoG5ohVdryDlR3FsIa70ihrXuS+SvU+9BJU2Ku+HgZlEYPKxca0wjulVi96v1ht1ZUErGIlT2IUxfoZssjJjJBgkP9lc4mzbc8+Wjg3mVC7OXVqreWNYcNH2dhrm50eNVZxYcX1EdXmEc5OhvsZQeQw1En+tNI7VXob7qQ7VqE6TcAueVZJzsqT/sql4EjGX4zhYpkvnQ4lCMkJMT+J14UWIC8HU5AOZv/6SueQ8d/0SFCAoUp+bbMXqTrnAZFY1GTFhtHkvZXkS0aTd1eSLxxN3llJ3lVNprDik+stXuliJ3sADR+11EGBphzHOofLdFIWOSjUzCdhheP2KAjFCse640LjQTGsMvrOJRYXuua0naHWboR7X4NzxKE9gdyitzx7MMqzR7h87+4+HRms49oDCkb580BBYKyNOFFiEVVsWNQVvpWmyaFaIu7nvOH+bthPr9rPBq3vW+O4fWs8gr5F1vpDIncGSTvkrD/Uka3urD8M99PZgviO7qnsyNDXIuGDZ5nfyUZ2E+7wvXisNaXAKY26jU+hqnXqutTYfq9TJKOf6OoG8stxCRijxCjUoTCjKip6qdmDSnjWVaHmzGPrJ6au1UR6UhRbJqqA0SbrsMJ8qscpfukjIfuGVFBHI+qlv9Th6oq67BT1/pCnah3qC0VPTlraVF2rKxaDrhTSo5psvrBcRVDqP6ikla346qU0ATOjVrmLU41ItNN3GnxoPbQnnYrTf/f845ij/ubQ7TXsfbga7Ri4JEDbGeYmj9WeCk8lJ6ExUH0w8KJxo17VtTeK6ZFsF+MhXfuIj3I49jL1MQatJG2DngjKPAlVD1gtNA21IVKNe2c13QeuwgqyuXJYWkGOrBVkcObi1OmGUul5qN76ieuF8hBaPqx1HzP13pd7RkSPIims6NvHaG5V316Fe1XjyKGUKoCVB9Kyv73B6dvHqm8fyUDpEVlQ1YS+B3lr6Ssf5TsbvFiiIxRwoHpX4/WvOu5djYerWP9Yzxuvn9sXW3VSaU2VcQ2Kf6EVhnK7ILl2LCLq5iM0nK1OsAp3VefXxPgHmMEkAnGlBp92IKa7ZLzpUx3nM6BHFML0qjiH/PEX5HjFdsE4U3ZXgUTviYUFG4vw4EL4ueApIJswWkM5MPrkT9xEBOROOV/Mh5yVFgx3MrQp36xe326hnSkbInZRTczP6jKkyssxedokitV8QNGp3h7LxlrTaI5Y02i6Bk7q1fFBzj/VczaakNtSk1pd3pSTsMptqQl7W2ri+LelcMF5tWi621JNam54W2qCb0s1U+qMvT2WyYfu9lhn9PbYhPS/M/72WFUta1IzudtjJ4ZHZwgek4BHpwKPjoVH5/jw6FDn5OHRYXhMVgSxEzRZvT2GT0c4hqYgE6bKygDOr6/AcaPTbTShvXtWIPYf8DkzmxxXR+dtK19F39Szy1pR33gKVJG744ITj1D4DbzeSPg9YYXf/rDw272Sb1mwbJQFy6rC72y98Ntn+PIfU5iJKszHtIYzUMqILe3xxnOLHao7dIXBigr77w1BxSNOta3ujLaaEQ24sCHjyCg12kJcrZcT7c7KiiLBJLVdg6g+cLCA//WV8nVI45WRQ1fTSmfyphqDgQqTMotrhU3eLkUzrfNlmxYQyHaIG+0mw/0wcrA2QKMSYSATFmgIn6ZqRv0pkHDrfApYeOl6K4/HQi+q3r41KxwWiWD9TduQQrHONnrTNn7oN20DZcdg12n4ZmkotCGo3rQNK7QhtLQhPD5t4Mae/M3SUG/aRmNpZbzupm00SitDtVhw4pu2gWZytPLE8IiG4BGst8QUacLJ2GM6eXjAHlNQmbchBSdz01Z5MrdD/sDFg2enp8sGmawrUXUEBNb5f8BS0kU/3vey68EFpY+6Gx4V6WJaVPm8/cfn80ZdcygjWr0J+VlEbOya4ybfa5zczcci5O2W84PiV24+Oi8o/novKB5sByv/D9lx3ckpEwohwoltz8lVFglDr+XmDcvXxxRZvt7HPhXtJ19vJihgdNfgUUP3hBEyyCOUB9Ky+25wNxqDkRuNdyj47s6C+nXBkEveSPMEe3CEjMZ5uD5XV/92iexR0FTdPLo9mOy7mhNxHNc8PwhTq21Z2C0dwqk1K2xuRjfNO0/NCIu69qrJj1Y0vgTzhR45BIqEsYkr2hrj6ikm5Iie2qaCpkII0LMfe+ualI40SXZR2iSuUwuroTBtbapJLq8pfai5BF2E0LVAPgpThWalp4qN1U66bnoj3Yyr3TRtg9Jp7gl/r7erTZ0taYKH9jl9BNFzcJ3SxMQlaoTTEZFSqjW47NyZOOcvAkqrHQcgHEQDzZuAHyjHIHE9a9m+psPfpJVrpK0xIxWsGynQENH+F+Kg91UBavKzl4PStHwMZbM//30Ct1CvpBjR8g3IoUXg9Ub3QSxqdko3fTwkwytE30bhIYbmrr1meEwbeHSqY4q6r8cZHMIWZNnI+DbHoLEHbkmtSGZ4jMK7Vq1OvtDxxIdjx9zEciiTbJp7XbtpolJ5itMQeQaUVNruMDbFjG0iaXJdt0IUOaZbTcrMmb/W3qzWbj/NKt3Slof4cFy3EBtqtyY1G1q+vsE04SoHV2a6F1B9fLfQiPU9SjboUSpNoLr2SD9e16NkTI8S8+HYHiW2R8im/UdbR3ukZWCbpD3S6tf1SPs0MkoK+vHEZTLvYG6kAlStBT2uYocdEb9KL9PqYKEUTnb5J0dKsWXzr7D6qhhS0w9SR70Ax5HZk248e2rV2bN+ouHTkdlj5kNt3Oxxc8qCojY0e9LhQeH81dljSE+RqoUhnjLukBwR7o17AOqjO5LQUKZXgvDkqFyPGk30qxANm6j7wNmKNUxfri60LPlqcq4D8nEspCiE3SjPRj5FCbxcQOBBwhP3cTGe+i2gpOyhfJuLRElb4fYwfx7GatFY/9AQFdCSX1268rpy6bpcJhqrDkCGSWCqWFinhsAiT9AcXcrBJeERDa+5toh4lBSWH4r5TBlTLdutgoYiJo4lIWm6aySlUqKHPGDVNFNTTXJHFKxri/1Mt/MWS5JxBbuOuC+0GvOhg5fr6sgXQ43XNoXrPgpGPjItCm01wfAX2tBwuCuJdiWsdCVY15VkuCvB6Kj567oSVL8wDL1+mKZ3eUEkeFXZxACJAw3ryqtGLyMyhwx6UIO0sKhbpEoQM1JblPvgb1HrkrUSAbEMqsl94J18hxXOx12wxlAJYoKJP9O9V11wI8J7xFjrU2waqmLlgRcEJ9ET7UGIRug6GDnLYv4YeIVyYc3w/TUw7kpeijpuY2EGjzS5ThGaik8pHGrjX/te5NpnuP0iBL8f9f1LJCoifn8R07Il0QZQBZuYTfv1/eflobYFwu/s1UI2QuQKS0vh5IlK2muQhmPNsKKNjK/VAYtOZnPY5nxI1UbwKyRzmaqujwCXY7LXSunom/OVjZZLF5QRj9FQIQkqZtZvs9fhS70GX5ei5Tpv6dcyttXp+R3WY90O2Q7FUjZq+j4cP6qZvbpaulB/rh/xA19OF1Dv8G7AzTZIeaSd1WVB8UWt9hc+qUUoiSFkR1EONHpPXtBJU9Hg4SwKFCmoprnc5stVWslESNEtrJhTcptTQH99RUW9WtX6Coq4UgXKLzW7dLZZcYUCHuRfr4ylv+sHWGTC6yhwe8Yq7HLGAD0Qh3mmus5CnJgFMmpDKBWhdtDbJRWh4XBYD3UDbQY64jIbsGIAVE1jfC7tia+5iga/K1741g+Nng9ZKm+AF2hL49EGDjenSIarQi0AnqkjLScUHgZ8gKpWFir+Ni6ohemfJEEoEoG+lwf+mE3+RBxF67b4vg6hnrbbhvgjq2/ozH8BRfpeZ3wRVd6A/HWb30RiXEWwyKAT09QQu4uA9uNwXZuikTbhEZo2qX9vxwmoeo+mudym/KEGC/8QuDbYr5S6RK6zyvoP80DrG+t66lV7qq1THkiP8fRQ11SqPIznLnfEjml13UJi4hJNbi3KcVmuBpc9FPqMyRlVew5IOKD6mjexR8zaX9ezulvGhr6JtJpQOzI6WP7oYB13nz+MYqG2wh+GeliVISlLsDF+eU7k4Veg7ZrlK0ArsNZeuSREuJFBCSPZwlR6UsSWIYCoVOxiJ0bnPiShCC0HUHO51q+ugykmsK69wsf4OriB8DHC2st3mHcB+JhoqIS25VsCbB5bwttCKsqtwEoIusTtY/imyATpjyFWvthc89RggHydvtH3Q72n7ety6zNrAKenXD1ePTNEHtqqXkAKEUmvN7hKkgMv/aS6DnLjTcYiHs6qsY7lw9RRqGhiOcMLbphHfh5ovaYVkbxFY1rhn1wrEiX9tivKEKZvrvB9gYKkgqYUGPBICwt/iK6GY9bLoo5apFt+bkTBalKHktwjLfK6DYusy5Kuvn058AHfj443WmqsmqGTx3bkMJkAJW4X+d9vdFPqQPJ1kEOcNxzHx5Fx6jIPt6w6hm53uH4M7apSeBhDD+0LpH0KXuC3tCo4TquCca1i/N2gZQ07rtod3QSmP++xfhr5yvgClcw+RC2UVOCGOSsfcq9CY3lGARgRYA5hKlMLPMwaQ8hYaTMiEv58mH3j8cYGRhhUDIzZNj1NlJnSXz15849Ha6X9x/d97uObxph/RJ4R+4/v5bwMylve+7mWs/74hldVrT9aXZ9ItX02cAjfv+O654klmW+tY/g3vup4dh8PIrWW/o+HYx3xp/Bt1ToieuPMI+JtvX3E/ljLj/jwEZp+xAhWTRWiSGur8J8WkrZxL++x2n7ruugl1hS8564noqZcV9A8spiAI2ttD0sgM9snXOsm/tlrFNiLhsruEJWnFOBuNvJoat4SX6HVmDbHLGpMP16WpW5Jk0QdAfFFRx27Xyc2gGSLTJ21PFvvu2pSNiSTVBvyXZU531WCoLCJIMazdUdK7dJBFX/eUo5t2twOma1o0qgSpYvI5JZSDYv2rDBFuOyCqxoreZZqTWhMNoB6juonq6GYKZpxfi1oUv0Eq7+jDjIo+wYx4QSaNseItq6nao3IKrLptgUGlWoq86vvQISxqkRdywJlwNh5fg9fNASgOlTDDJDQ9Mw1Lqs6snfwJhe8qqdNMhFHLx4AMEbdDkWfM6Ylk7YlnWvWNr5kwflSuEbekW/Cg/IFykxC74RVLJ5kFYspF/oG7bqBt68KvcVmFN+jBR7ETYMVDGPGL5toES+bkCfLa3jAduhcPk2bxYThNE0KLqwAFwacv1a+rMhQAzMYcfAoMdKZNURXxZmqDmomQ1q59sHRk5XLVy6N42lysIoR5JZ7tFlapaKhTBoxGHZkYFuAqn3d166rh8Te+6b1tWw6bGup4c05iQaMRqs9RJOHB6MVoq9ztFkdqOo839KPYA5LpyTpVJ8BhBfznNuzRc7e63J6twUXDAUBtsIOibH3vFmSaAv4l2Jfvg2ha/LtNEMF6slPoa0cCjl0Ks+g0/hvB7bWSuyB5vZZnM7Wji6ngPDE5jun09C4wpqkupqC0lbVFdyPHdIPiSlOp9NhgekMksz29UxuX6E6qLNc6RTNaoFcfS28Wi5cavgKDmecvoVzXPfjnEPy+ZJ2ueTT8B7JN0OWIxDa8+BMvhO3KtfFnUUBfFPlVumWOV7GwTPz02WcamLf6nQ6i21IwXxUym8+v+/kd/KRaGOnAc8OF3LMFHYEhYF40hn56QQM5ro9eAEvrNBtOwblVDoVwNDOale4TO2v9kbtVlnbWqdUO3RSjUdjedhc8x9yy1Pals9ygxltVCC2Ve6xYoxqrvFu5BDnOiFjP9yJrW4MpRxf/bZo97kcM7LVcngFGy3nO3aMt6hM9zR+y0+jHdgQ7qDNVpC3Rc0Fb6Gucc6HG2wC1g7AgW5zeUQdd/9yskKBYE3MODvTeVgjcX1TtT6WUQ2tnTaWynjl5roBmyVZekF19E6abWoXb11KLXLOoY0TNAeebK564UuIkFKYNtWQXBtKbpXJrZFkoWb5jFmW1ZBhiJ+amCM6lL1WVvEtsvTm23XcGE4z9hbgZjttZnALcIof9RcKyZrjP5gIFi6LQPFQ8ma0Zes+rP+obYQsykAQzS3lO9AKtex2WgBMP4226OAUtCPvKG2CuV98UZQolmdiTHdGnHj6ik8cDUtFpZH84QVtGkR+2t2w7gyhDG1F3FZBnOI0jdMGykjSFmPBewrN4LVySbqI55S5AkFTI0vJqbDpnKPEnLbb8d1cDtPm8cNUCGy3KKRPM0MxQ3qvet2IFVM6QDoOxH/b7VhgfVLnnMcfC+1STrSUb5Py881mFdpMO2jKjsW2b9lYbKmMxZQZi9MwFjsQt0PjpIE6+2gqn5ZmnKaSK/QP1q1PswOxRWpCGUM1EWKItqPU7XrjVUFkhmNuo1mTKkAND7u32FLOg606DwpMmx1IVCudWMY7jL2z/JxyEDuNCtCZFy3TFDOByImGzuY+QAewAV7DuwJc2a1VOzFLW2EFdAr0bWqIkqAzO9R+6Q70Y0elHwEKMifjf+d5/kab8KcVfnneeTn5rgRN3lNJ3juafE4lefdo8o5K8s5qMnaSegMX1n/s/XFEZkulfZKbXuWM8FYKCocL6mfOQtNZ1cs5dpRRrJGgiwc0u3lNvzEVN6+LX8KW7F/CrpzsHnQlKE2clOqR/SN8Lkt6jHPMk2Cit6sRbIhONU61nwr1hMtekKNZ9/KChY5gNWwbYxy+Gh/oGCYtzwhP3J3AuZCJ5hkuvF1MyslNC3cXj+EPZ4Q/jAlPnOTgu138xBdE48x2znJKxjnwrPV1n5Giixll4A+nwb8jMINEauXz1M675MHkrOl7rX8MZIQ8moMZ1XyBLeLlPYWRstzYo2+iHuykal8wcOYJeNWoB9AVvf79gchsJ/JFms83UzffEuwxtLdnK4ScmCedVoAXMnwC9bQC2ioRXzKWVkHpMnwyTcQBm3kkmzYi70mbCvRK2oLaN2vtWqHWjqZ862vnncjVMGu7hR+wzctSvWJRW7WIFuEbjo1gyjQn2yh8YRqLrxY4R91YqeWViOuYFNECxoZwdoGvhbWvle3LabO+DTURXM3WPkY34xK8nDsnbjVBghb7gYFXUbasYGzg4H3aOOH/MHl2oZ8wCcqFeVhqMMzUQ215Tj3lCh2iEMn7NtqGhqBxaJOAVqCILAuy91pvYnczGrwIsJgWHDEtIGmB9IXzALLoRwHQFxb08/39wVKO3TqeXdokT7janesHbB8Fq2lg1CUusxISToOz30uxluQ9bPdHJhKgM2YmorsHfTNp99vAfZ4JHPPKCbbYr8wvbv1WWTcWeYLxzHOTLCsn2VaAgXhE8h5/upWggkEYq4wn64TgwUJecAm1YkGtQEs2raEnWKU1kdQ0Qz2LJltoq6mQauuQBSwS8mXIp8lZmZwRoU2b0SYMAonQuM6VbRaEomKkHTXTjt5G7eg/91FrSg8g0qYsYMrVLCHQppBpymZBczTTyxeCPQDg+Fm2pTLL6ASzjD9dP9N0li0gDlRCDXhTg9E2gVPhnKj3f8fMU6PVmF/IPIeziF4+B405u3vrUfMZbnXK7aTC1gFs1DQxHRZj3lvLuTAD/otyymkGXdgKot0DZCSVHYso7ItZIeJYpiXhFJrRhHyGGAA0heTtNG1yT+P1FI7VPNg2Xw26ffA6ZV8VDyqztCc4O6nl5DQ9QlfLeaajPindmbGj7zAPY7p5wzF145mtG083ZLRusBC3WXJO07QZ6cyO9JZyJD2D+ah//IjqaKYUCetCsUw0lSEhXONwJj5T4FfdWj1bCSxb+lHPh0PYfidnJm7oUpgLhi4YifKOmIJeXiOb5wq2zzsoQvhL9sEh+1WXnnK7/zq94T5kMtiaC3ZSQ3NX6UsXr1K098a1x//dV/7ugicN9v7ki//wZ878OZ8rKaW2+iVsS6ykv5mEzeu8l6Eb1owzzEi4IwxS68eLeWAvyIPfRbhbsOVkeCMw6gB6CFNXr8sJHpmcY/Q/M4Cvg/vwq5e9m9mt4Ixh4jkBq6k+c7FZzOHhLmWfJKoxrOYH1Mx9sMOEicNdE+bRwpfcInWh21LfFtXUMV9pafqVWhNvi4RCP07dfU0edRaZFx0KREKEty515HYlZSzM76yWealTcY+rV1+DWu3qi4wg35d76Vh9O9Yz/H6P/zi9cmlZjiNh+LlyN5jFxBNqWpNRcci83QRsfN7lFx2IlmWsuBINbddQVPpMbmVvBsjVh/YiTZwfaD64wKheUNWtRxu95uqojQ5nciCDS7DFRKXDE9UOT6zvsGmO9nki76zr88Rwn3FtvXI/nPvcwTbbwUZ6nJsec6IARDsuKFVzutqw6t1SLLUIiiPshEaQ8Th4WKviIUDZKjGHTJiEOrRKTFNVFcWhavRodi1GMa8mXfjOxbxRvEOkeHEwRGIi/YNmHPIeNOHz0KTchxZ1MdV1JN3X33NN0TCZGxTu9t+X8DM4P1hL1D3L0dVh9ywfw7u6Z9EkuYL+cQTTviQK/ZGR34ffS4xvaGMGrdHnOMlXNNncIdc2hn9Nwa2iIQgcs4GjNnAksRa1W0rs2ljHURePjd/fDQFQQ9aUjJ/7G0sSnpTtX506WMM1nuosB0Ei+RxEQC4l0xQeM4flMIsCmllBaAqKx1NUFyu/lr1ocPtr3FZ492iat2N4W7FvR/F20L4dwdv+Jk1YLZMJdGNW5ch13nzxgPB+oL9nqeqQxfT7jtQEVmzgoA3st4H7mhZsNnDUBo40RcSWL6DSLnVZFonQdoR6Zhc4SYty31N5z80WTPq6BfBT2KUCuymaEjZgC00jTy2ocAIYgeZQrs3UG81V72cVcE7TAlrVw6Nn94KJJGUKv6aKyRW0eMnMyzG8kHm5Dy+7FOYMtsrLCl7IvBzES2Ze9uOlpkOS0Saelaa7c9xqakhPhLHZQlNAFQlvBf+2WUjJPLLx5gHMznpxyp3c42ILsgF4BixjEJ/PU/hz/vkXMJebEd7MYbxK3QiPQg04lM+mIt6HiHhe0Ie6eMVmExi7iWbBJBnESy1ommamKWyaZropcJpmzil0mjLxqCO7lA758vQFa2O4+7P+Ddt6DKGI42WrsrTVIcEl+BljFpNqli6sZW9FMjVKlxPfZDJ/f50aWCi+iud+Via5rw7wnx7QeQEhZG25alhtuSIMOhyswkZrA9ovN6GXTJwwN7ik98Gi40ENryH8Og3fgfABCZ/r36gGtWPF8ezt0vqAktJFi/NXtgs/u4vY+Svb4fyV7XnE/speHYaeCg8r5rWblvkbTzRhzZ7w7FITgjK9MJXdJkAWTy4z5rYsGEAoQeIGe5a3qVlx+oGvcfrD6TMaYiBmpFqxzIpp2bBhnv0xrHXCJk9CdfnEud87cYlcziqnc7AFNNL7dLiCZVRHtZ6YHwkrzEhNzBvxZ+LYjxo4KhDTx1b5tVEyGi1owsOlEnJlA/TyqO80ODC+DBipIHsLoCNMkP3se5DN5Mlu1uSUEq2Wl2KYNIeMslWe5YEdyw7pHTKukNcLIkCqTROHYB8F3vBajDL42T0YAEVr0iivQCaO3eF2C0jfRU1nLuAoUMG/FuhgNwKh02Vyti9GArXswwBbLm5E1/w8Il7Rj/ii68Tz6uaQgjGIBJctK5xE8QW1NTwjCh2WFjZ8BeDYK9j30B3GDeHqm8vE/XvIBa/sOR7lAdZUu43zY0vdhy1ViHulNXfhrgHqvtsG7rWB+zkA5uPj/ARl+KQ8+RNfnzf7kh4cxNOi3Z3XnRcc8E0JKzZwh/nkCJ5HfbThLk/agNgXaj3LWtwV5pvL9TXTyluaNaGgiuEooAvSJj3j35tDMX7dR1O/KDFH8Zv9jJxGBIwHeYjHrjzSC0GLw/ymRl6ukQHo2A9Wz5I0ebmSfHU1WZuRHcXwL+CEOzTIhME8nP7nqnX3qtF+tbynTc8OSFPFtd27vnz9AXU9r8liB+Ydrxq2zneSLj0/QWnI6JzxX8Ao7ePvWt8xp428CfI7XWVOlSm9O1Om9OZ1TOnrHFN6s2NKb0Iw1S9uX/fFbe6L290Xb1U29nXr2FilaACDpORptiJEwc3/qnWwCcucdpQ5zZ5RTLZrypdOgfaFBbTv8hnu5AEPp2/Cq+rajY4nGp5H3pm8i0eSb+KUY5mmLFQqo07eIx+8G7wb0xQ88WlWYp37LchPixy0zC1zFXgQmFtwK0QrCG0Gc7uZWmAVWiVzy4HSB6BQ2OmqptZWJpk4radNeUHdfBsqHkNOtoNzxVqNwIoNHLSB/TZw35QJHLOBozZwZIqKfAtty0/h+k6FiJlOBZa1lC/dbjusr6cBEsqmKhQ2q0QKqgD8OsqmTg3l2k6njOZq9TMHGCgy4DDkFDxOoVPB+Jxq2NR5ZVNVTKYvR/GSmZdjeCF94S5X2dQMgCp5MbytlLxYBpCVvBje9ic0pyNEORtF6gls0O1TtDNAJMUBHu9bSDABoZUSBTD4V/Uw+sPDXiArjujluY1ypOY0Df4R6+mefKvBDRa7JlIn3rQy2gylICn/ymJLj3EK9XBg63At0oZ8B9qMMiEwpzlB3tmTLGd3WQzHpbQDHdlKE/iD0IOmhEOdokV5LlIKmVJKPYxWjzJlUyfKZeq5LIY7dMitwm8utpqXPXvIBa/sabzuw13wqt4DAU8374XAo+W1/HSeLZj2uMgv+j/7SvqxhLkGYdrpzubTIKcKMYGeLjQeiH1beQhi3oJR2Mp6/MwuaAFqgZ06aq89z8DCbmZ2N+HhOJotob773vTyAzVFheywUGuX5S7Ncn8lywBZEM4c636Gsu5bzRgzqSi5djpDePKVBEHDlB/UF+XK98sL2PKtzJbfnii3beldHcvBet6/Y3j/juX9JQB5UfYL0p4Ixg7W9p71PYtf+JtzFy52dtCknas8bLR1paDsF5EbL4PzuVSfxxB4hjbs4ELXBpgHhLtQMg9Ws4NQkb0t+2k8BsUOwpe0Y5XosMOJFcb8viwdtNW14AGxrHmKUvsW5h+7nD1Tlw54V+eR2seIscR4kX39+lIIIuUUHRjibkBthfSTYnLfsmjNeRw1SRm/hbD5tNvhR1ihwS5ILgjVkjNp8unquOBolvcqa8xsZSXZ9lAKJT/fVC4umyjI3iYDUnDztzKMJ/kZnh/cx09MxnvxpPODY5M4akHHFlSO1dMrHuwsg/XUcBad9lU9fXGDBeTEi4MG7rCBFRs4aAP7+WxJ1lzU3oVq1RaEtiNk15Rt69aUYnQ9wUpx4vVk/6O5nswqxdf1RF8O6nqiLyt4IfNyR3U9uU81PRpu2blCX3RBulxfdKnagzGSPSEtQhzJj33cvAS09tJePk1dWsT1nlI9D3poeD+Va84VbAxcnLbmS5ywL18o14R8noP3TTLFwpGS8RV8Km3mbMUpSzTPIf5+s8pTTqMZMsGdDCse+7z2/geniZ/e+x9kAe3/4zPNWCD+8DTauaGo5TTzGT8rn7XGINdOOg1SltMgYtlJ2xHebiQuLZW4VI6uTgHyS08gDPN5UTpFdMn6oVsgger5QqoyIiw/WK0WacGsnjwv8h14HpvMCc/7J3NQJp43uIi6SRarTXaaQJG7I151i0k6092dyJTYTHGho33Kt7c80TG7K8vhzTZTUiTn/WmFEBQVQjA/ppizysmelpOdD45lLuzkCdLSs26s4GflO3HErY3bJiLNNmN+vlPNMG9DX74Bs9LXyCWxaSxggkqY9sj3LZ36szL10YouoycYSUz93E39+XVTf+E7YuoX1alfVKd+UZ36xSOf+ts2nvrQyT3FcHstcGg0jXNhdN9M2FYpDD174xm7mSF29kObrmPQ4ezKZD17eLLu5B8goe5jtoDX2wJQo9Wn4PCfgStTcFspLL0C+63pPkHinEsHczNbVVaaGlw/axjXd+ZnqTpHKnO1xG8omXB7ONU495pSFjOhdpXTW6VIYFPxuboyQEyN2iNiQSRKCIdGHHm6+Gy7jyUvwSrbwqYJLVnZVzqdCw9pa6UUIvPi42WHs+laKZUiMEAu9V5OXV8V+Cg2EYXNAjg6+K+C6PRuKFQCm8CicfBpEryQQ5dIaDeH9lJCZ+CUT5Eou135Mle/3MHBJtQXTeOPZ4W6hzFyEI39ZKZGJhomlqwkdGt6oeddK2LXgMRXyKEioggCtwgStl2HBlQTQRsnVmRs2S1oR3oJlDpFQnCHkRBwLSLwwGsn7ZPeK8z+QMifigxM3hqkLsjHgfTLvheOEamoDas/rCibtk0gLEJ0KDQdgn/QCCf4KD9yVvzsHbjhdEkFdj2ECiCp6cCWwFFkto4xa9kf4VUPPENSW++idR1CZQAn0qJsu1TKQ7Yv7eu/+Bryl4xr21C/lXuCfv969r4qrjukCYjT+77qTqJWsRXg4btMXGNnkEplfywN0Yunkj0P+Vk6kMC2IKoaFj4+zP/3txjmqODkYf5XwzA/9p0C879+qDBfUds+wXWAgh7JIFQeyWhYj2S87OsAY+6rp4ILjdH97Dz/HA565/k7Iea/QNykqcBQzdwE5yJFXLUWIW+rfXgjQvfCn78KF8qX2FkWirDT+U5LLPfjm6zQjHWmVtnYTBGnJFpZWERQLsededQEjzRM3JCGfRmAy1EgLbjETRy4rGdcxSPBw0XxfWLbwUeCuPd4tx96Yv0oYrKExSZAq0jtdwUoO+IODO16a6JzNRKVLD1ZQvBuXES8YTYuWH1pvqa5/qF1a3wWdZi7DRRxG+OQd8UJJStFMjC+VtTugHjOTiqXG5vkV95SbbBWH/dvrz9VbYOgLQSmMJGbvUgmLn6gL4y1Pr82D1P98MCWpvcxY/hnJduSxrPFHtfVPm5qU82e9Hl6kiaHa/LbXYW5AQxK9nvAVoBbjYz0PTkk9NVuyg7+Gvf3XyTFBP2LIRcpyy3X03QfTvC83NdhdoulhrXvRXD4OajC0/snVRv2mpfT0XotA1IEY9/jMK7S8eJzSB38/JgfsJRbVTKAB5ABq/0E+RCQVO0DTjMG0EI86ocVmuRj5VyRFwybUfEqUKAiAxvbQh1OQ8z5pgvJBxKrARjFc2MeRtxbwuc49+v5hd8n4r/LejLROH77EmqG7TNOVvegRaS30iO9Kh/C4EBXbQLNqOOzTNydncOUhSQELmBRQuACWhLaJUd7sTqtJ0/UvLJPKB1VCzxag5rG8tHTGmlYTNyYsahTTW2fFEEvF5vSxAGONR8o8dJPtI2JVqV+AsOKgkz9/3z43ffthd8/+UP3f6LqIix+7t45dp2M5e7L0EIcu4U4Hl2IXbqkookPsRJQp86S+eBdbkEOqJa92y3IMTmPUhRjQXZX5ahmjZvEmjlUpX2GS4IVWJdcxMU6GrHwBGo/yx9ZgQNu3NtUKVI9kMeCHvykoLoCD5kifZfHXA/aoC2ItBOxWfYxZAEeCfkG5dTmoPIWnJSph/JA7FqYUJewtqhjOwbOLylXoBXgO13zQrxqZ2AYTGACoyrir1xeitA6HbO+iS5lBpvVfJWLZnJ3u3VmHyFDKB1DS6UZ2oPsDuG1/WE7VOkeT5YJ8N1e9svIAgNLClM7K0WB1yzQ8ilSEmliAtUNdVuI8cVDGixwQ1imeM26k/IQwfEIB9bul4/CMHQJBVqB2vAcrif9XvQ5M13GuDsTbloTCpCQuhywFmECiVKAMjzTd9eZk4hhVqnipSncWAVE1aOVtAjQZhQOGQPsZ1V4LuMCMlA9u97Nr3/wsw9++OOfedUNRzgZzBYf6xManb0fH4qdF7hwKnxsju6VM4MQ9+h+TVEFCpGx4zhi5jiwC2N2pOKHJFFt7KoKduSCDRdswrc0jnxFGzuhCGrYjZW8KU6s8qDqHyOPnBq22tsRvE+db4yo73wjoh7Ic7jIvLFRMcjfTzZoZssF2+IUtzXczNZK3j5RM4UeW8Zr9x5e3vdU/BJW2JCI0rXVISc8VHXCQw1NO1w0qDHqLqNBNVdsdDK+fDBoI+U4PXVqMttG7cGKKrD42RpG33WyiMq85IIQGzCKqcjS10OOYB8usXiK/D4FfFSx3gQMxilYy5tAGhky77h2TsBaAg2rQHeQpOYK1fVMSC11UGjc2OioGFM56iNNWgoJkNoJ8tQs1mPg3xsxFV+FYfWC6Cz/OPpWy/5cyPWWcbGgiHpRdNd4P/tYqHDXMXufLkyO/O82vkPK27W+E5SAaGmkN3KZNeXYSr3v8SM1ZQ3q4uaK16+PetDxBuBdK7jsuXvpyN9PqlcpvHHTRk266hULnive0AWLaAUsEaZMuFE1JVKWWEuBxX2PvFHc98ZeycBNCSWFFWWwYO9T53/0hX/0lLdx2KN4sFr6VdaPVt+ME74XHl/c8IFvtbjhAw9F3PDrw+KGD36niBs+9FDFDc/0ofcmnV7LOT2v+jzq+4KgBl9pWSwFLK8dpsBYowKmMYLlvnXHWTOidT894HlBhYsKFFjojfJNEQVqogGvCcdII0k13fzsw1UOyS85JB+vOvPAIfmIcBwSXuB9aphDuhjcwhHLIQX9j1laESiHFFgOKbuz5IuCjfiijzwMvmhbSVFawxQFZEfJxf95vNPnowkollmD/bE+8Vd15b4/dj6gMB4qFpJWAeowacgTIfstVQOG0rO/lP023sgfcz4R6i1bnxA4ZgNHbeCIZ+aveDeGdGX9mheryrnJf4f9cMUGDtrAfo/qatNzjdkqWSz5F/wRBEd1auwbs1gesYslJSs6pVZlhQDF+B10SglAhEMNDolJipbQA8S1tfvUEH3viYovwQAXfmB3H/KzDIorHaNHkU+qojhxAi5ViPUTTGPcXE4RO0uTpg0zfO9BNKVnzXkAtcsMSJwfTvRwtOzRNKHCW4oudVdoDkGaxy8fYeDKIyb1jBWWTNE0vjSKQG082tVbTHmnahM2pQZeGvqiQhs0VXszU3YMW2muCY9Jbuu0npIMi2lEzJNHxj2+4oD3okuVDsAc2vS68gHEafRgnbgHPUhQdbyO7/jYCN8xLpbLOUm+4zfX8x1PLqnE9gqLsaPKYmhyt5K8OMKBuBZcbKiRPPr1JZ5ohRIn7rLojKopmgWOmJG1KazEYR/sBxWN6KTaCxw03WWpJTQYQ9Zg7O+W5cLbYOLuIo/wJPPMzFPI3dKwrq+PRRoNzX7XWNw0V1gD5g0L/sFooR2JBd+XgggmcvFXAv5g5OQl2AejoRE3lKJqbXuGXzNULU4JiP8ug9wmIh8cNoSUTAz8vCGlYRdVdZTYFOqSViNb1kIHPpXrt5hjeSvVK8HUooRDOySW0/kBtVGRTMNcaWXmQKiUol2p9LzJH+VNO4EyMwcyHVY1WcKoljfW078Wejs6PjIKbRFI143l+xbV1yxdWyk3AT4EGMZ8VtGELr4YKgasemsDSvm9snMQOpKiqSmOJ9UEi8BWWxxIc4tYLzsgc0j6kuClwdf584Y5CTAkI+JBtUP+QT8KymVH0TDB6A7tvfeHw+93hTyAnno16O/Jg+pwhWL/d4/wKDCCfX+IkRGfmWrEPBCBcrREIfETqTpg6mtPGB+1dTbU6HWD4OCjyxHaotRJAFnvreUh1fPAnA74xPXhQsHWa9bs8hJWVhypn3Q7LPyo0rJqU3wQciWNBoy19C4/xn0HANAfFs+OwY8iZtHHLooITzLPzDzVtjUQR1fKiqNlbCsVW3CML91suWTd3teoBTga21NYBamOZg9ps5YfUfsWuFO5tKe2XdVPJBxVGy8VKX8jCp0omd+YMqF0g4qYtQCMjzOn5OlYHuATdkWn0o/njZLOqL9VhZa1JBSWivcMaqNsT830rWGEs6jgusBRnmO1CrVUO0G4PaTXbHebqC5HiZlnHMd5ONjxQBWyT73CeQkHe+l0wtV3qBzgFCFOvZ4JEUbEiISXyxkvgKwD4BRKyhM9tamOSdCXcUETTg+4Mdo+e7qo14ARpUeP2joVAzdxENcg/ru0p+wlDgOpuYYDMbxVG482XsJti7WxqWlsKE1cKVpyNFanEAMeauPTQZHyz2EmQwGk5mJ0acLRsOvUo03/NHjmbyjVzEOMDhehFuwxLw+j6JJyclwD4+80M9xNm+yLwgRP9OvEf9/X6z9rKft7iQJbHXChPdijV8sEXGOXuTJ+ZMa7SkvO18y5WIOazNeYAVO+w4P1hfJe27njjDWz7799I2aadUEfb6H5BK7o/2GMK/r7g8gx6c5Us0XPygqGAtcvGOAWusKfO6coUd/HHm2E/3XrhHII5CnXK0cmQiIQmskTdTPWoAD6HkolCNnloybAu/dv4yd/7PVf+IqSt0RSx6UwDmG2NkErmpbwqbPYdctndeEZdrYPPjMPpF/h+H7d8ej160//4PvPePX9tT2j/XIpD6dfStY9ZzeOoke6Bf+Tb90W/NiGW/BPnXgL/kndgn93C/4bJ7UFP+IffwuuLkjdFhwbpOwvjrsFd/vmh7jhPsntdTB+e330kW6v0TUm4NH/9dvrsLq9Doe21ysPaXtNhummk9xcr4zdXNPw3vqIv25vfWzs3vrYw95b/9m3fG9969DeeMWvtoKWss9Ut8YetsbdjbfGJ7kVDrO/tFthGrMTXvFtZ3+zui3CyGgz/NGtkTf8frvX960+jkySoH8F3oc2SJx0BWhiQL6YsKtukBBXREACMGJgf8wGSVUlfGkpePWoH4hxaY+ip2y4QTpS2SAFYzZIvtkgBbpB8vud0Q0SaIbUT+Dh7AaJdDkFHIPh7ZFOFrg+Gbs9ovG7o3+/3RA9ws2Q9xA3Q1TZC4Un3gs9Upbjb751LMcDG7Ic95yY5fjb77IcynKsRgn2uaAtDb1ebqfGUe8EbMbLqjzGHR5vtTbiMcYxFiFmxO1eHuG54uXxOpqhEw5rkNgp8PR5wKPEshmM03nTkBFPRF1iaIDq5DG2j7AbCFpq0tiQ3VAmo6094oJCsBbCcuR6Oz3POO2gJ9aRKOTJjfweTVCLA8pUUGvNsBswPAouY8bcismUgZg21bZGOIxOmQGJIxxGG4RthqY25DBm1t0ZnqQZ/hLXMigFGcEB8QE0HoJNEtUNEO0m0lrCsLU4DkNywCtmKKKIZq7s6SAdRExMscTEFILMhoaWVHkICLj47qrHz/h8HlrDU8yM4Slm0GLDU6gEkeOUpzjqreMpHhjLUzzwsHmKe7/lPMVbPd93PMXRqgQJDfiCJVNjFqDAqIbjWVMhDh6VtT0p+Qg/+6LyEVbWM57dyJYqObk1zhx56L1ENxhjm+IZKzl4ZuZZG1GHqr7S2OUfK7eKJPqedQksLjAi0cPWqenkPCZQMy7S415Rd/O41PUN+sGy/ZSGM2Cx5k/hlVA5gMN+HOtOSshdRQNzvGKYrpax8BhKjShSouPW+FT6wUup3Odsc+IETM+7DJnMeubqnevADvnL+gaGIONvOjSBCYhJOUGTQwxBZhmCKccQNKih1v1jJhLWr7gyAXBDP7WSY1YnOqs7MqtZYkid9at9x672HV3t0/TDvh8IHlgvutxUrFBGxUcdvOITblCkBJ3dWexQyyUZeEQhoZwNzy6e4TIuMGb/qO7mEd1CtI9Wgz7UOsbgyJF1Bkfe5wyOHHEGRz6kBkeQ6OqICNZ9lrN3QaRWNqXPAcl3nMrVdfXTjX6HdgiMy5J+XK3El47Y/mX/pKZczH0Hlcx9eqGHTQRj2UvLvftLgXE+hwPFPA7X5T2UdJ/zWm60CPMIStKnwI6LtXo/1lx13ZiWx5PMMzPPmnFhjUeo1vCTvCl9N4tkDEB+Un1cp2AQ2u2aWHASk4qUQm2RcTKFcduMH8/l9YIfhMu50C/iVS2FjBS0ey2fhdHj2aV+8oJ8zuH9PBe4/+K86/SZNsFuMjhFaACyVibNEP/xxf9evwNFsWJRnGuh/M2UwsfXFjwysW0baiVie5oIti5C/F3a4xmwRlsPD4qccqEKhNlKtEghBkZ5SBzE7Z/NC/SYa/AxiYp8Gzrbw/K93ZYOvSwqcF9bYyjE1VRS8x9bKL+y2NzLUX9OHMhpu2h5ay20XW9SEhb8bbZEmhNaFxJRoTcVuJDtKCTnCA4UUkQeykXMAtcktYQipW0CBprFIzFdLLau5Hn/Oq5nipudCUA2F6co1LYXIQZru5awhQhvqGmL8Rh9CiTfp3CNOxAf4prKqVx1Lh88R6/QcgVbpIKOrcCVu7k4TWrSCnZoBYDHDq3Auv0JNRkV5CGSUbbwxQL7gFpyF/50rvlU4XFOZRiI954diOLPTCxp7BlU0LbD+ZnU4+/ynfzoXJOfRYt4O5tyAOj++nPyxzCm7CIvf6yg2QKdvVQs8J0DuBFXqTpQsITrND0WKPI4Djzu0t7aEJQfv5KfQwaqkxzoLhdPwN39jPihMN+uqacqbE5VkOQWJOdQbkCyHSABohyrlUBvM1TOcUA3QC2Iq82pw+9cXwj7ABmFWt+MVjPDFZ+quTcYY9yIRnNCTdYhQDJq4krbWPrl0PpcDt8t4fw8Sdit8bs5eETjz6fHYA25QBFnRuGcP1HAUEjRJHPqFPWuMoODnPQsvmKkenqcsotOwe6HwAFu4Umxlc5E05Ji66CYP84ZTtivU4gzHKYUIFZVvkADFJqznU2r78+7XJXQD0w7Z/M8pEUYTwBRDWGBY4tAjVGpyAeOWYCJNaxUnGErjUuAKlxoKctmBr/M05ROyXel/Zf1r6ULegycHbTjNudOr8gPu3Jo01CheVugdhqdwoQD7WZtWop3cDeL8IXsHCx/Atd5Xf9lXO5S/hjbF/Rts/ZtfwMYsCgOm0iUCamNC9uPeRHNXIMmb6YunUJPuOa9N4Gw3/mm3Yjrh4I3eJDtFFCvOE1d/SkEN3FH5leY2p1B/Hdlj6odGe7GY9Y1+8JKs5904mZjUND0x6DpthNPQLsv7XHMk4Y7c+FJdwZDkz/AC3Pf56a8UJuQL9HplOBeymPJ24e1HLWexXaSZCwukMUHwoiGcC1IhzGDkfZDUIy7+cTZpJD2GVzmzBl+7SbiYO1NxYRaQ9THf2Mz02gv9ksd2HJ4AS6hS87iIrqIJn60V+nODB4ztlc9t4ZheNA8n5pDzUNztGE0w3FFe4kLzi+i07TVDFDbTDqD1/8JLHAiHb/oJozAEhoM88zwKM0/aiCKv6INOjFjOxESfzXcCU4UOXRP19yzYIlpJ35OMfDfCTZT9FhBDXI8svxiR0AE/TAD6eIVtXui01nHoO1Wf3wKhtet9+UiiiYwil1qQHaKKVYJ0B6zbm1Y9MVc9FYpHBNghyxsveIMvhG/B5Ph8GDl+HXifiMGAn98u22GcLSNxUgbkXF8lz3kSsd3KBjOcCQLDXEki6s/g7ZKi2EfXftcoPNbVKKP6seSJTMOp4kE0NRtJkPe1mrGTkvgEhkmxV61+J4VG/pNBskDPrVfKFMSzTj8/jEzURs1g9bMoP6HMPd8mXvfgbPOk1n3nT/faphvteH5ltK5dB44qN10Ptirc+iJzCjR4/LH0qnMqW1ndvDx+VZ6HMkeRvYDedvy97hX193tH034uen84C48588PjiQ0Qy2xXSwCnxhAmOBnzjCUDseWc56gzdLqHxXOGW0nDgACISCgYirZshn2SYqiyJpj/yDlq+mDnhddR4G4OCNvCc9dUJfZR/xzaQ/vu4twWb3vi9P3UL2l1fdhkNRrGNWRiuNKAYvuXi/ENW/J+9SifqmwpiiEEsmLL4poHxAaSluyQ+QgNxHg94EvPsYSGcxZWmInnW0jCjXt1qs8O8EB+4Tmc17TdlRU1+24b7bMaLG09AQqIl8aoyJyTxjWdfNpRWDkrl/YzX2IzX1EGAfE2SsJFF/ag3ngke19HtrNr26luwglgBjEYAHFuNAlTZebupJPrywkeCSIaCDUwlA3Ecow2ji4eauaNZ6hANEzYlQV4iFz6TNQ73QS6nIolMoa1KT0g7AoIML/7CuyzW+u2+Y3zxdnBipkOLZOyPBJJ2Q45oQMn1EhAxLd/r9OrHwaV4UMuJi+Q4uowiEpu59o9xtl91uPVvfR+dZJdx9tVxlHaGUcGPey9U5YM07GEQ9tpQNnZfmHa3qqUKIUnkLmPYtQSuzJx6+6o5P1RRYOXSpwECqnn1gxAsHeG7OJyAjqIhGV6LlEKOHQCkugl5P09++EsMSa+RapdtPqjdpjq7BoVTXu2mJiS4QcE/zcBVlHjD1VRp6QvUmK1vIpLmd/V8Qa00r34cOF0n1FQpPEf8yjzhrJhXiMnUUR8+RBctHFIxORR6LliIuqBerSPCX4Y6qVsuRi0+EB7FmL5GIB8FigOSNSV3A3WXLRNc7NZ1Vy0VNP5mKja7Mpnb/lmno4c9QYSvj4gBbkZKDosiWiYr7HhXOIONCmzVxLYmpRG1CcW7yk2xJpWo5fEi6kp16/uZDNKKTNERzgWLSYuwPJxTwKkhJ6MGoHMNAUHonpYrGJTz/713E9EyJcWJBddMLbV36dL1jmULahSwuIRk1d3dXCmhzsUyWanGDrmSBZdrU94rK7G5e9tVI22bK7RKbsrSh7q5ZNpmwkG6FFRDHAPgdhQw4dEBU2FBTl29S3KOW8Dq8XNMyUYMhom7g85cB2CBqqQDllhffqpu8THOCNPztJnYQQQHFmUrsxyd3YXOlG23bjVGprN8CHoruJJms3kCwgMiDoEVcIVmgrahKXQR1KtKaW1tTimiaPPxiTqGlyg8HYJG0vWtjkt8WIe1bsWGFZD0zdK4hlME9TQOZnALf1P/VKvBWcq5fa1zld9uYVL3U+ZXY+nU7cU9kLuBnk0NLDHJgrfU+bwqil8qX89A2L3cHFblIzW0WXK+E/3gecyfsA4vCZ2Accvz7IdHz+wy6gRVu5P8xLonafyyWGimq7ruRnMmMeUMFLEgz1VtpCKJmfXDSXKaeH83QmkU7FLu8INknvEerSJh6bHj+7Y/n27mFpLXWZf98K/p3binK5A2GlAy0edZDKVpCmQGyFVodasmlJQNGk+oQH0xIJhVrCLZwXYkHcqE20YDYtbdNatFM3LVqVhdw8agTlSNUZhoAKb6h5PWSy40FGCRS1x/a/bfrfPqn+K7aohxnUpjgic6WpNW8HuZjNtwiutEzNA4B/IBTWp3m1bydQ2y0G23atDBRXd8grraxIXoS7EpPZDIkx8LYC+C2U8FPD01spQFXQseY/E4fmb7UwbfEDkxhdmxfSUmwRmJ5KZ4Bqwf0DRKA0q11BRDh5A5ZP5Q+359sIJjY3w8pivolYOq4qSerSzKyRKU1CHYUHTrYATaE6/NSlCMuQXYLaZhFavwTpAsSQRemWqlnr9e30Zx+ZM7d7V0/Cmdvr3gaebwW/1pnbv/zf7sxtrB+tk3XbVnWeVfrm+k7z3raRy7aT9NPWGdvFh+GuTVFQ3bWNoBsw7f86d20PG7c2xKxR/2w/XhqgvOttw5u5D+FdNnOapJu5jyGYqtJZiJ8a73rFPAtFpfMdZxipL6UI7mX/hhHiuzAVH0ZXFzEez3U+jK5wPoxe/Ih9GN0TxZ7VAHeE72jtoTsy4jEDg3WzL3cYMN7H/Oz+R8OvEbQUjuPbqPOwfRv9wkP0bZThmlICczK6qMXZP0v/ZKsd49ESf1upOGTX5y7zJPPMKvtC0YVVq1R51E9Ezb0OhQ6EtP46NCEifuiiH6iSdZsmdSWuurpzd5gnJJb8p+tCCTCnqIsmOAaPfVBSEWf0S1ppWSy1eVq1US6nVPbI3Po2eo9G5YG01bUwAo9AkRRyZRH1uPRJRGhJ1RbWpAeldyZhQ+CnMvtXALIEjfHOJPP/EHgd453pavw8d6x3pitGvTM5laNneVW5VKSxeik344eHBkUEtUV+hIIAoo8BlzpqPTESpINznQj48ACay0F6aH51jm8I97kbGcL9GmpLP5c2UpmmTsGj7NV9tX1OfwNqYsvQL1HFi+dSDGJ1hb79iL79oL5drm+X6NtefbtQVpm8rjInTGUI0pQda1KM6GeyApJY28Nas48h/TyOgEGo5SLFcAfLUP97oZ2NsdofaVEKCIWi5tCGhb6YgCESV0ywaT5gJWEK7lTXw5RmrzogJfQ/6d6cdBDN1LYjy4WMjRRKcyjODtisM5JfovOOtcGTVe/4Aew3e6vYBmMjmkhPIO6YcrN1GiePV+QzKuCZ7XuXiH30ed248JhP6z5buHLmYmfJB3c8Y2RRIbVUQJb7rswezWIiKTHf79Em6qEQZjoWaZG5nM2HjO751BJ1OaZc+4jtl5cvV/ZWkd8US0cGA7ey4fMQ0iPVB3/AL7bw25ZLepVzZh+T3aee+wou0TH168Io535K05XEabvzVA8t5oY6wHNhniiUfEpF9JeQb88n6kIzRRHYibJRSYhCykGEmIw6nG1oBAtfmeh5HcVMqNm8seJ3SeFrR9ScnjakTpnsl0KptkhUcka+VF8nH48EQ5RAeq+mAJOnQftd9GulgmQfUDN5SjHV1rs4vP5AzpcSIiaqEXW0oG4hqpugKnAsQs2idT9oG7mg0AoplR0M7760KVsEYh6CMjumllQJH9uro7Vl8RhEh4l/d6wqgtRVr7xu4DtB+IRml4TaOnhr88yOLUErE4U+uEF17w1/OKy5+SKG/y9C8lxsUajyI8QxGW3B4hmTDhd/slPMYCK0SwTxCMFI5gxCcKwGsorgbrWNqWOs+uNqJhNGFl+NsbbQcjDamYfW77fucId7pLqSEaXoSmrlLnrYgAYXiajCy90R0rBIDPU+GfVkVhSLVxb1Hg5COYIDHGs+EPw2n0jP0WVjYzMWgqMx92uM9Gwk6pM26gOvtFHH1kUx/bb8Zi89GAyZ64zXm+ukKHtwnKUpPc+pD5myqjtTVvVRU1YuXVLR2YdcDVrfWSo/+YYzaxVSLfumM2tVJ1xLsAaLqW4MW9GS7Mr2yUmVVCARO6RSMXK1BM1PdKBi4iqCPU+6FA2xJq50ngd4lCaughETVyG3/JfQcmImC3sFZM/r/KRw2MRV7BS13+OJAVp3KyXWHtYFocypFJCkIfiERXLIoqfQ9uaP4bQNeu7UkOAO/6AHFEMfYtSf7T/w8I161ocvr3w/rmvc4Zn7GnH/5n9WtXVd4UPpHRorTdJOiHna7OUH7F2WeKO7LNcf+A9g2fM3ogAcVuQuvDvGEYC4W9xiAsUwjGLx+wCe3vkYbLm/8uJhLfWrh1+fq5mu4Mf1YnI9eCahwCGzeIE1i1fE2T+8Ek+xc10/n9kV5RnyRPgxsd3BfbtWrba+0PEYWMo4DxBvsPfmSV3EB2U6jGiLXjxOt/Z+4onXPectK5+7eIBixUIN7yhvvQX/ftdcpksxfcX2jIcFZ4USwxKuGfOVN9z1u8/b9d/v0TrM/vr7L7vzd+7ZErMtwewfXiFmZCjCPLtEW32htvociqhVWpLQcI3DhlXfgQd5sjmIgK0vxs8LsYSAdYwoPVdOTxrgZJsUZfcDYshzVRHw+isbrqA81EYFFGT/iPaoYfSv1uDE7JBQbj3dlo9Vvt6mVFyJKK9Y1FcKCR7QcajCVq06RGSKzL5qnHQuLmVfl6BONayaHDrdD2EmQ+CQKBzQ3wjMucDZLBI1rQfrVvYl7ZiWLxNHFyWO2L/+GovO/Oo1lnGxoBV6iWRC71tlPy03N+SGiUv8+2EDi75WpYcplhQEKkdjPtz/iQLHwDYpgdZ8yLGXmbhItCU8wUBQFuGkOEwyC1s+iDEq4EsIvmz/vZ8oOBEZLuv1vwlvRRz5AD/rl/YAcGzNfgWwEeqZBxvXEppaVAImDddmByzy3Sd3DeSLCPlUraUmRYIen+4n55n8udjbV+oCcqK0JtGHozzZe9GqBfW1FIkvfKRxw5Te+OVi00mz9yFvLf2A78XXOdiZ1lnwKay5UgUzioVqihrU9o2VaT1QVeYwAcOUyMFzEQNDpWiMD4UllLDr169j4Z3jyjYhgQ5Rorv4uq49GCvthL5mr1Eurhw3dNQ1n4+yMYSoLqwMYWKHMPumYrowblJwEQ41iJtf6YoqNVUblN1zw0nYOHntgVEFFhhXGTKioouYBb63TycA1XSa2mX2a83gFHaL67s7jMNqL3moksO710kOP+4kh5ok5X4SQZHUoOuY3uGSGu2cKep4ZIVutosGxTCiI7rtYqenqScTqV4ZbOnWuK0b5Qm9i9FRDM70nsak8CeT6C/IBswTYCDxPg2URgtm5HUWbJs0mDJ+h9KNbkLm0K75Jed7VzIVXclWNGSzu4krmQc8Q4je+YtdshuOqKMoOp/XaJNFU4qGeHz0H1nNaVkNmFtTzDUUp4FtmEgnMLPm2X8anwaBV+/mi+rGDsoEy6h3jzRnC9qxI+cD+JyMc7NCDEdsE5UWe9keKp9iQ3E7mi83SGkrbYc7Mj+PkN16JJQ7WttwdivlNwgewhLoykqBOQ9xebE0oNM4Wx030FQsHh4BLcMLqU0MfRG/svalpkYvGlKBujzbUXVTklAijsx2UIBbohyFV+fMDJIrZ9JLrmnV9QI9wN/MOQPHWyX+bbjLHdG8VSqbp20c1L438LZPlBJr3PG69KhB26i29DA7tYnqI50C1B56v9AnUAo1KkunIQ7qEIWMSq0CMFeBFJ9Y12hSbLC+2BzF5kQKsSQvuCRSiFmntT1kYf0UfLdZUb8GjsEgJtXaXjrGdd8OY1/3aWYkunkymqs4Pd/B7d6hQINOK57FGXCrdgbcqgk48h3SaswUPDDAvpjZUMZlmmZ51GB3S+W9jjU8E3DpewY5dwhYz8QQGft8qjCg9gAAQw7APr3AmzOK1Hgn7aQzjX4wjlpBISbxI8QDwguGeQsR/DyNUg1lPyMbw1AFjCBw2INNcelTen6lZK5GMfeip/0I3BXdR3pWe+xtJ3FWe+M7QZhvfqc7q4Vn+O+e1X73rPbROKtVFNSz2hF0A6Y9jLPa757VvrGR+KLFqUea6+hDpPnM9d93rrv+i3dlyTRJr/8iaLwMxH3kKQ932MCNsj6OoNYNX17iN/jte72l8qyXo4bKyN4g4pa6MH32nrS1Z0VB3qwWOPK1ypSZ+UuViKVoZYvGGZhpy1FkRHiSeWbmaahWP3kG6qgatsLEkCuqgdwrD3E2aQWy8Hebkdo37dAkHlPUoamryrsiTt0+k4NJnpoSSy2wF3JeqBOmJQeTeOzLJynQg0mpJyyLpQ5wyOrwToIXnDT77I7wivlkP3Fty2gSCCmfX1lkPS4XxWRaRrVtaHk+LXRfNaYjeoTAav47Aqv5bQAWBPvgAARoM3D7wTmy38ARefYZ2X07ewQ0A+IwTdNlzPFoxJQ6bmL3NT6FZiNQfvgs7vWUQLm6DkwN048pmqrQjykh2yh0Q9LNwxGDdIs50ZhCnbVNgw9o/zSOo7I3omNcN/Lw6zchNYK9KjGoqHbS9EaLHsNbRuWvWqpfce3cdT7/2uNaj7fCVWJ0dB0x+pgjRkcdMfq4EqNxjGJDUDUhPDPpcFBVQW+i5RFoCx4RrNrV1e5MHW9iQ0L2QXWCTYBYMDjp78LxPmWy50an8GYEtSn4zQwGYjI5/CrqalAFBEv2q8pJRSKZp0j4OTE4McX1mO5JFprS3eT0Dn8vTZ9VuwTX2KZRBN/x9w2JVeXzOWXp5iUbmNIuSKIUVmyiGfHJv5D3jKP6RA6QcWUbLOgCLdKskEtuvwCoixGXPkZgVVHnOUjXc4FNnH9mWd8Z5NxG5BNRilXW5HbY/Wxd4aMl5ZtplqHSMycdm6k+vK3Vs0J7dJVhdmaCOD2aw1ZiEdi0WFrLAmBE3x/bW9xShH2Crjh43rqMVN3akhybyBUAWL6Zw3CKyvx9NbevJYVSPm/7sInmoczvVfbLm2U3VweXkOeEZy0vtBzZyqJXdcSHNQNjhd9mu5fjmVBUNmqMGCAxmXzQoHwoiQQSwJ9I8cdqlS9aQNTzRa5u1u5IZ6nHQdNuvO3L5zHg1DPN58+WviN6oMNI80oUhmtXfNJau6iV5vDLldRLmbeGVRY+rpo5oNGcuZSn2GJvFnTR4K5gjuydACB/D9erEwdeQqUFOjvm0Ay98iGfFJvH+qxvCBuJHSt6Ifg9hhAV6r1L+0GF7lyLHDvW3O1YG4Cp9ijTSeCj85ultdjGomnA6s0VGia25T2FHzUE/E0O1au71aZsXvPM7GzrlMmIUFNNamyjbdTU3WqNenpPzsz7or6Ed8aMJUTtVtIgsKG63bBWp2ZKU3ibokl9g20uOSCfgBGfDoaqQwF6RKLK3tSOWU0v7WUd3Y64eZk0T1bfCI0kDjSN9pQ1oilni8CkUsbfZF+2fjJkXMg3Sb4cK119nmqzQTL+sweM8TRz4KSW8Uy0Oa+78Fy7QfpB4f/5iNtabRZwqkgZJp64+QL6otETtkbvgTlJOh/LsA6BUFCVXRV1MUcEd7ErUNmLtFWH7PU2KCEhW0IJMiL3LdS8Rb4olRbXLtSbF3VRWDALFmMD4KOGjKXtxrRo9jPoW0W6nv5kxaWFb6aaAEinmiimGf/CsfoXNt6HQ+iU1SgQ1TMc86t1bsdrwDy5WCfP/uJG6ZG4YvGyX7/eeMP4f7xxlyMD8vQWH7ZFF9R6HPL1Op5ewpuRUE8Or+XgFC797kC3qjfj7q8zm1FnvbBA/kw1u9yRpV81+kzB4HBRdWJXd9Yuumft/cF/y78u/cmKxGWCA7sy9aoeXgfUwH8r2RvE+NwKNTQkaYfLzAPxPbxaNJ2jQeSwdXJhg5xHb+8Db//SHz/9x664eFDx4CdnwYwAWqTsjNrumh1EbDzJJiTMcwR0iamUoxlKizpirS7nACMc8uvKWjbhnD1XuW9fdEP7q/+c33QRpeReruyJiassxSVIGPVFj/IpPge47QvXH7nrVV9/8zeAjxu4fEyGDlGnZeXvhy/IZ1xDEyHPSBDA0ySF2Y3gfMy+OSGZ/yRwWMUvJcxJt/Ze8ssfuvXLf/qai55TyHru4fpM9luvNsyqvv42XktbchN4LBZzIvtQgGgY5AUAYwAZoBWx3KGYoJgjOFBCcM5qfjXFg3/RxYhOyBfIyy1zZkshC0HbuzBtJgcReGQqM6F8k56DA7sb6vQbIsDYfs4KywPCfaNNkKvgsItbsOZUmPkfbibh3luxwBi4Cu+wFDtk5+QYFAMijuTZ1wiX7z+7bQ8tRQ9w8u/Puv6Wn7v+ScSerBMgwUd//kUfObLjwEVVK+8JzbIoFzsfYP4CV+Sw1AWvZGSOsdGagRLjJE0j8yYeMZe5Uc2My5+sQmWVimCWGWSs3Y++V+5wlUW5XGDhd9mZ/6OsWKHHUfZwyk4O37hqx9iCAOBkk4/Ks5utVl2Y+/aY03fHnGrq1nhKf5q7cUtB9q8vL7/Uo1Wfy1b/g8raWgPzamHR7IfwKYpL/zr0OqMWEkVR1ZOWkyf90LcWhmf4RFmtBoc48AcXYNYpOfLUzY1KcY2gO9IpVd1C/lhb/MFzmpyD4ku/hSZ65IGufuYGd3Bn+kmeaHUji1peA3H2bTOKSNZ3BbSCPeFxS00XbLl/gXIlV6658iSlRM9u84btR5P7ga0k/8FrUEoN9Km6pKLj7b5pXKtgySWggJJkAuOGlm5ZfOqIpdyYUvAa6qZ8/eFaInAAFxk7dc8UFAM3lPUONjXtTNdKhK9yRtlrxqO1KoDFS6aK032M40gV4Oal+wowPbpumLWaGtktipkMMZcLeQQ8y9lXFIrkAbKAqyrZVU1qftH3Yz4XKJdZZ1BWKsxDM+vVuqDuTmU8YjzkzNxpbtWgVKXH33hh/81+auQhFClHRoGMSSCHOfaFJJlj0Gyopar41oePrFBOnZeF9VH9yjwu+S1AV2t3Q15EqhAJcALhAEUzyorsdfsW6fzVcatyQUDgkLQQ1cWEShUctGR5gnhRQck4XtUayMv+Ci0DzmBWSluV8nCYnEeSA6EfDfGedSvT0LsrENkoz8QPc/ySZL+PYUzLiJbE7uu3noczfxGkgL2/rJf97Y1aFtIx3sucBLg0RKGXb6ioi3V/H9uBLdLLZPVrMrrsGzY5rv5rPbGCAROyXJYqRGHK8n8rA2dECwKdNdW4yu5B9fC0VUclG3/gD31ArcNqT/Zl4vKF6o7HrTYeTU/16mmKPVuDYmPO2kN3VPkVOAjOSKW91bUoEJMnqeqW26ufjKp6N1naCjbZep4JbApzQYE9T29gygvjXHc+cr21ouWWXrLhOy4cUIsX4vCWATZY1QWYAr5G1Ff1CVX7wHF5divmMoZZB5o1ERFR+E6pUFcalcgkD1GzKBirWRRUNYuCk9Es8q1mkb9es8jjyPuHNYtuOzCqWRR82zWLfv7AWM2iYIxmkQ7KqEugojY8dvtfLtFSimpSps/mAR7P3RppmqfUC+0QEu6GHMQmrbaqJS++4Cy6VCqMpk8c6+LoxWNcHCnlsGo5YFXe7nv1Ue7CkI+ivItXBII9QiUjiwOoUhcB5MHCXARACTju478SJQKLEmi/Q4kINQQU22VP2CDR5kOtruqYi92Xh5algqwgUAxArfDXJwwyvkQIx9Ln6reybVeyHYEot1AJ8skjlAfSDDYIpMydgDHj/0rY2B9dI30zy1C8oGSIKKj0i2LvDD/8fgs7UV1D1ThwgINDXxBBdCt0MQTaZYd19431J7BsYGUFSZdLU//E63zIU7B/vXcJytTzDNZK7R/ZD0S9bb/AmSdrCGIfVlXVIRvPfhFVdco4nGtoHGAilb3z5PEjHMIPbwP8CNbjB/p/3zB+DIbwo4RTBEh9mzBk9bgY8lakPszp/gsj0z2sTvfwJKf71Sc13Y9Dw7xhGhZaGnaLH+AsJhy9XGG5wonA92vCvV+9VEBZXNrwjLY4uAN7CCR22E51PBkG+JYl7N/Xtr7G38agQALYBSBssi9vWLvdzaVcPqBI8/PYwtB2drugK8g4+IYQ7uAijQRDCYxW++UitHu7qcB9T5EgvCvBxdi4xMS+A7FDNxz+2PNiBxYsb+iI7Bw5EzQ2De9PRjNUjrpj0UjEoyaUAKFFjLDQwhkIRCKwt4GI07gYSDxDCz8UgAryGOsxFwOgx1RbwhKrKlT4ALvpmBK9bRTA46AfIiTXI1qplSDXZYehbVWVzj9TTyJubIOaBwaearYFHa0B3dUh99yQCwK7oR7+yL1VyV9H8SCxaAB/JO8s6VJNMSECCsRyPZeiyhjVLeFiCqBOTAOTgrS6Ke5dMnLpnZ7OQh0j9YZC0GTVmMA6jydfsGXJthAvgBFHA0itUHUpyR/ut2/ya+7cb3nDfa4h1g4PJxiIow3SnGoRNpPWS0bd9t9Cr+nwzZ2Fijcf3bdT/WltdFofvFGHUkSfy9uXN3WzlkpG2TouFS3BGY8aqK5h3Fi5LvZr8D7J2PL9ICdQb31e0RZnGwqBlvRBi2rkE9RSpSC88xvWJ2pgYch5LqHujFpGuMjzWpYkoW+TwPCMJtGYYhICM4AnZFu1SzTZE+1VauQd/qEJKS5T6tHsX4fqE9MABV7AL+QJS5hoSKUjlJweIE5DiGuFQgjQqQztQKuNvo32y8tTrghvUmtD1W8nES8gbKALNXyqkzTV/e/kpUUoggiqoQvoCkv2dNdiimpj6nbIozR7t6CrngoXDWgnRNTeB3kBRzWXeF3Tm/KKuw2a5CHBcLSog9mB76AQpeSJ0txz9E321JVEyIxaOZSIPGrj/AjOoyI1oAl8dJ9kv6TELnHE7gOw7ugonO8we4Ta+ULt4kLiYyF6YXWuxJVvfVkefBQZ5bVAc6J0nuwgLolZSuqUuPqQIFjhm0toNsnStbBK0/7Pn/iv8IcuN4Zu/SWVFxo2UR+6trou+priaYp+heIj+dRR7EBFEP4+6zjFOphCJWhNqEc/ZQViwUKLCDAkvi0HpRCufrFQwZAnRFBki6uWpHiX/bJeoUvX+YOi0KHgKwLZMAOdLBuAU1lzOhxThOGLqsOnesk6fKnkyOt6zdCBLmbiyAngmWQ3qfvLjgGU2Fs0Q11zq5ZA0M61cN3opWbI9XqkTi8V+1ab6lWb6pVN9V1TQ/IZrPhCuX0FNSRqxklPRBBrmVWYp0Sl5zEqDgzChsgArNWsde0PVgvzhSZof6IqQguFkEagZmO21Pcaw2yPjnaILUBUbktiEJJLen3Zm4jgU/WUdOhiXJ5LAolRn8QJr0CmXwG/YiUq8amp+lK+knV+9ZWsA3OUrGtI4hJFb51lWnCdpDWMkU8TCaT0lCks+AowmZwOMq4NUnxNsBykZYPS9Q1KTr5BDdOgJTRIC04oBtOiwIBJXpV+40Uwail9wka3cYwWY5C9Z8yNnLc2+WC7UWpMhTyXqxpTa+8uNabuNhpSHxM/iXKadIekjj+NW0Ga6lahEJW/gJDsWMbZBQ7BVbwe6s4kWsZ9X6MKpJuSBHk8WS4bME/XFAc5uTieIiiDr+Vt2PScsDgRQ1Ck2NHnNxEUTVSkiOnhW4oJSm+BGi0UmKldSWxKYrNMzPiMFQeD5Oshc8HbvdtBpxIjTb3Rx+9+vVzvLRehyl3eBecxtwdLkMeJ2kt/TQiEynnv9bSEbhH3ZXLiZfGpPf32i5wKTVZ8i+Pv8tugqldXiL52sMEhaADbsAQMhL0VkYof80SocEysFmjryM9+RW+RqePvDKqOAwZAJoDxz+SPDjnLRlcKQcaooEel6LJsk57Gmyx8RJ+9Cu95plijVWrXzNByHppA1bvcmS1l5jD79D0Dbk6LT2AnyxposnqeR63VQ3tfMvNL3/vXP/lWPjSfNGeL1zyJXJBPzycB3UvIMwcyfS/7oOpBmHahu9lK9l5ZSjLyTfRkxbPc+3S7ze3JpLkDhdckfzspaPKr8vEEBQTDRVBMlxxX4aiIm2kv+2LYqIPYgHT8iAvN3o+v96Y/+T9bHvcM/q1kOogxi1tz1DLBJ+BKVcyE1uM3O1eSipdJasI26xrjeYHvWF38UJG59I47LC6i3uHbHEYB52GTqJLlyt4DQRELsdazkeF6spU3b/RRgH3jZeKSPST0oAUsz37N7LGDNZ5qiNVuBPtw5oWuaA49nFB5s56sQBp11MPswPr2xdCe4iL+47Vq/NoBG39kKP4DZfw544vZMRLN1TI1tIzEEc+HO0UrLfHVZyY/Mj0u1WNePW/zQKOi6tFIPKy6DrElMjKzbxhjg54w3jJQLXXon4zPE1MsR99yxErxyiEKJCPV2GOapK4UkeAXlpCAQqXztwYxDC776pvK+Um1vKHS1IhCnA3PyEPuzsj96VDO1LjZwq/wLLoJAMVySFFFdSUu6QW5ICspxKtvZrSo74P9Bpe96nI16Ps57yVz3ZTGegkxXSuiAfmscOxh8at4K0E7wWR11R4bUgGP7INo1gCqS4lrsx4LiRKFmIJ33xURXmb6xsF7yum9IjWAPgyXrCtoC4MVxIiDqQkeXuUHDqlarLES4C78VTi0bOLcq2lux/X/umYU1tAUPakoT/gorB7wvSYIYPgicDySu9065BsQRZ/rkxrluts7f0NVmExPr/vbIV2tYRFJ5Zu7vDzG146q+tmHZHIAcYCdmmtYq6SmjgWpbnODXz1HL4vugBhArxsx4NT8j3jCJ/ywmdzmuf52YYjCNUPdNzF1b66tFr7698NgNShwB3gBV/MGm5JUU8yhawSEb4I4DPXFLUYfRiOP35eY6potxURxl/l/NYgwP9R5qtWN2FsYxwM4j67Ma9m44XzqPu95yrQ8bb0z4TiQXbgeRTU44/KS0S8UaQCviIjIipTSFXHVyeXlbZkELQLKuDwDs5TE3DEYigOS3sJrZOpGM62ukSs81m1oMcL+atXYu1Wkr8ubsNj+avZGNYBBgejo+2ZZ/jPoialkMfuIrFWf+Dj+sec3fFlD25vkdM6ASIcGqzAkJ+XguzutwRVd7YoUmkH+3h9Y2/KKL/wnHjct8avc/LIdgEcZz0tMWuaGjliKuTiQtqpdpfTnw7olboFYkx8yOpas5j6e3Tx4aEOK25jDam4RJTKIRQgOSW4OyWLNr/dicoXKoUaQwgBwYMfgJMxT04LMYVVHkeuSUSw6PI6Za3M2xOv4ck0OYpuBFHav8Q7NQO6srqgLFLmPh2w4eg5l1MOK5WM4VYBqntqg15EXpUJeSsppKVcA11ZRjHPtPcg7BDssKM8jfyCchUnesWeVWbxQ+6kXY+yXtScNhN4hrrn3B+/JrvnxMz5/ETdYlhCFBXhNbWOyhp61mLwyXq9olxJqLSN6BTVSGwi9or1T32dqWbrfkK745B/SplEwUKwMwGhhOeSD8wfDxDdeGmNQWucpfL/vjifUiaZAoag7arWqxl+OenkD9Qx48vq3GJ+LoboD73v4Y2o30c+I/y7FnZ5Yri5zE0RPGn6F3f06QQuYZpxcWlsppmhqsMKzRhXokrJmE2jYwNcxRaZuKab5MX1lD7/E4SuLmV55v2dltZhG9EAeuBL00f3/857f/6GfYUsx3/vCP/z1p/7+r97JqhXbb/nUEz8z8Ttw/fVDv3jzDSvbPoXYTRc+7d8+941/4thi+jB/PNPT51T1XtHUYZoivxIzKFx6Javeusr6ib1mBS+oGLRJo1ofqXPlfNY44JFtNc1gEzcnKDLFbMMER05cCsji/orcmZpYO5xPy7xWGJPmnh/kXTdZp/o78gkutMuwBRe6VGSGW5jmNpGZQTmXxtHFBNozywXRPP4bDGjquL0yPno60o825B1taoHhYpQQrhUtKz39X+D5zuwFfqyj4ew3oTOqCZo6bAgjPc6nHzvRp6/3fa/i97tqu1K4O5BqOUHfSx6HPlZbyo6YhTNm2Bp15f03nt1XSi4OnvGFEcB9VIi5Voq6lQ2Ww5bfKCn+b6o2vHahZc4ZrVWz2BkPpaCT9pPs9aKr5YkZO6pnf4NdpLatf+Nr+RxSErJbkUubYtJexWnZmyXak4Tsr61luOwNenT5es8HDbCC3exdgF+hZrUMGKtLgcq2OEW1zSrxRvrrqa4Sd7jKgSiLinPYS3vMiUK9BJi/zqUseekvJf7MdWGVDIWlpmakjPcuZcN3UAi7TKRvXT2VifUtkT0N8ZvTdKvr/qfPt3GV7+Mu2vw1ZJT8JnPi1LzBpOjRQRMRe/MUj916C35n3saD8gk8kryDx4y4OZ40grpMzZmIeiJsOYoKUx4BjBKahmqx1V6E2RPwJ8SPWWrhMUcpHjAeHInWyrw6opgUEeg8QUEiBshZS1ndpyPEhFMj5sqkmeEkkFaK1nil7GLqMnag5lk8eMbjMUczeMygA5BcTmFNmsLUns6j1PjFAP9mjHtMg6XT+9XVDc2CqJIKCJfgeiUWDMk3OdzpCjfY1W70uEG0wBwMNfLplgiy4fGk2KStRAGoSzXIoKxqthPTwIy6nizJODV0nJo6TqmOU0vHqV0aT81ovjI84jCD2m44YkCDpySg0cRjhhp4RDSppzPSaAG7ekSYMyFAWSJmyqSokqQPqMmNBbnTXsUZtIM8Qx0Jk9YI6rSVi+vMcML2Ilb3OXE+B0wbHo8Y41G34zG74Xj40q8BxWurblhQ5PphmZVyeFjmjGqzHZY6zanmrNkMqUGhXcUsMapd1pNdG6QVwr1kvyS0O9Tz9tDuCak+skt0a8j7J5stZlumjOckf/je/cHE7eTVkMOL1Om0an8+TVheYXiFs7W7iiJGU+uiUQBdzwbUbZrsFyR7ABRaWPw6W/QEE0lNucqqB7N6lVUvK3UwQp21AqI0/AxyJ6rDys9boiSfkutkGWCY4Dorh2kSR+7La8xOrK0OOOcURnzK2FXpPxaTzfINHaMhrVQs4559tb4EBf1lDmaW8k1T6PbLmu1eZKvmmXFFfGZ92iy/3Bxbyqkygxiy2roID3qYNHKvd04OAuAWCjcGu/qZeALeRCFknWogSa/IGrFdaCwfQSxNPVzp2sxlwBHVFkXlGb0nWJcJuhV1YQZDj54U6DluwoONZJvPtLiEVuGkM1f7PmI1Z5tUw6NEOq0xSFTgppv1Tc9w7pa2ktqULIH7VL/zmCjUWaKJqut5LrwFibxx60GG4yFUIv6PtvW7OlJ4maCtOk7ztHkZ0nnasgxkgW8YUWXfVNaIkp+LagRn+OXq8mWF315cfSuDh0yTyDWJwS71L+JG4laaFnO+uB24jerAtIJmATyiGQtDwARgoo7c0lWneAA4Kuremmd4Jix97Wcw85NPiQVTQU6kZJqhxundPDFmsiiyh1JI2S4dzE8h4mbmYr1qgrbx54XuF2TzTpNGj1iLM86HDGxOMWnbK2naBu13ntjp0sajzeC/zrCxOh/7LVaOl6uXnEcgUNery20BhLZJbui2FbpqnV6d1BTageIURYGEm5GBiz5lcBjvWrNtjjbAtkrbIWeJril86Ar/3HMYlAKPgkGaYhb8eHkTe91cM1r1YqXhVEgoZFVk+v6fzv3k459y4PMXY1/sy6YpE5KnuzQA3BGBO68TFqlKFHi1xV0HmTIovKJjnZ8GhRb8sfQaT/HEFjE5zLsy4UH1IfHaIpxOvuC2c/W1cq/GEFxbVdHWKrzBwhNdjx/b4RgdaAc4nWFsj4RiILkhuH7mAF05Q+l3y5LgnXT6upizGG7Mz4NCSUohDV2ksxTNd+KRK8XYJNOB6VQMtD0bt9qrgulTXBAHF7gZU4mhrX1R99+KidUh+PzZqmcOBZ1JZ99KZ3OSf02vCAbFY27Nd7lPt8uEzxlFKG8bosW4by+oKnsnFIC6Os1vpYzOdHssmmAl6x8vtvWwoOwa4HxXs+tOb/JWmiQkMrp2ZD/WpsfQJPJlNmYS76AZKGI7EPjKHhqmIhDoekVP7Y3OIiViKlzcfijPUrU0JStkXq+ADvb0yJN1TefqLWamcpJOBTs/HE8DWwJ6BxpOwvnYCg3tEb+eze3dgcbLSqKOKFi+g/RNtBnLSk6LYiMND+L8/mrO8EdztxoCfKouZb9seIuzzvVfB27idY6doJ0jcQ3Q0IbZkIc0iwuwKKb8ZGYkZnokJl0fw/yI5VvuCzvBtVb4gr9Qnl75V7mEulrIlK7utkLdOT6tiPC4vIhVA8ajCMDO67zLd07kq4LXpviqakBgp2tZjrf6at6w68a9cuCvxBtsUILHYpFyLErPxGgYQpXruaBzlMqWcMJkwoLS92DKQ8nd5FoxVYpDIUfIIXDo4o/Jysy4xipHOSxshN+1WdwHpVm44ru06PZwA7Pby2dhlgGBeU6eprk12eQcZvwz4j1L0mjPYMCMVQM+DoXjVlPrDBZQZp2CXFIbBxk0xXlXChQ5u1JwtbheKkDLsPvJaDLvQIxizzSahOMRzhDCIxK0uCk24mSVq86plLUr41XKC/NGH8aUhfLN6chAi1av9khpDXcq6YbqmKe2GCDX5JKB76qBpldZAwrL2zhZ+rpeGhh8C/mZIvwS/7qk5JWjyoU18lSsrUtIoOflu8nv3xjAiOHpuEO22/KHoRueSHUsJJU4a+V4yq0EJu7Je8x64PDI5ZZLgpU+67WGIuiviKgAZ9I8ePFozfGJqp15WNXusJ6bqbKk6ToT8O4o0iLzOsGninnBRaydDAZdoHDV0mJBU7EAc0rKkDlVWTb3XvPDX3vNVT/2xYsHqzilgKRiAg9h0tTIGy4B6HUFsVzW5wAUO/o1Fata/ho1opEt5JJRmbQo7q3mctKHHW+2DGrfBGPdYqn2chGwYEKNuYg0cl8+i9QZ4vg5bcm8DPPBsLTvgregfOuneUDTeZfmZJ0L8o4OkH7D5ahik3BzXX5VNNVC1iVPuGQ7HPsV87s0i33GBB4T6j4loA6nmLqmtCAUU9ZrT5S1pkrESlGXKub1o3opVaH6lb3Ruqc4AKDN4wmzQPJkwoOnbOQzyEJbyrGpvNcKek9XgoNJda+nt/I6chWzI4NdTKiNupg6UiXpu5ygIxrwJMAnkLZfyUSQ8wL3OGBR1hAlHIlJT+DN5ZhXmTCO5Nb7VF1cNmGNQLepqeChSO65n4/GDs+OOrCovg4yTaFHTE7xprc2GYmiyu5ZcXLe4iRPakBuXpzeKErOcxzjZMsgFQGiMoIIzigb1wSyA6NE6Sogf4xFmAXoXHESIXAwoFYeqEERLU1U3e31cZoC+sToS6wTvu8x2q75+Szv6aO8i8Yiy0xV9BOLoBznVQyGI77AK2CERMyqos2L8dEED1EXPE+XOhCOGKGJ3QxEUl8oaDtNQYHdZtFBKUzaYv52TpICFMdloBYdf917dNFyFb34UrpvOogikNU/k7vPefkXmxFpkZko1NT+VGeEbCsAkHiYAjaBx03rxCVD27PSytDe/3Xptfd/6L/+zcUD3DRUVG4pes8O06tZS68c0YtWIUMG1aF5oThdjDJesBudA1pYx9SCOLCNNq+M95RStmm7l6+L07Y5EMvqAvESTChAEVNlIMATCk9dQEMNuOiBhwBfaZDQED2NjBxFiJQiYHrmHcseGzBM4226vx1vYjOqhdk7q5NSw0YXBnhSmcUxmBjM4rgyi1vloq7COGivYRmyi/LBUO92z0OJforbreNuluZeJVOCldt7YdFi0QDhh4+PJvvh8AeLOjUBSjhQFqGWzjbQ71mIWUBiIZPMu9w7SEyVHNlZJFvTQCWXFuPRBSezmgfMZgGl2X5koCTr06LMaq0109OvjSZ1eAR7RATusIEVG0BvSfIENo8NrAQ2T6CNlzMrdFWW4Y5KBqZVJDAnaJTlXdPzaYMXimM0RxraNLKwKWHYZNe1IhqsW9oUAePhRc2aOWREwhvMkTKkL+3t40Z0BapdAzWasqR9RoyNgfTVGCJM4naRvtyBFzIvK3jJzMtBvNTsS8Ave2w2vFxuC8DLFWSKxsvV5nhPTU4pwKZTwp4bc49Fac0lFfYqDmFWYNJTIJKDWXNe3sQiSJOI69cBeQA1z3Dou29NXNLlm1n0WWyhLYN8K7XWCiIa5Llix5Q5c54TpCwmxdzcdHWetysLGVilyu5dxyqmGRmvTTrxIgzFltWVnN/7maKujzGa0JV7gqaXRWTI4J4W39CxSkrjcTpGGPe9v+EZZxy5p/d7qk1IXBDinkrDgUfj87mgqr0Xo6qmFPSKbcrwdEsWB2jj+BvaulpsPzSA95BC6Xub0HukFeJgMVZD+PyaYAvh0TbazoaP1q/687hwWCpLw34nZnRMm7nvL3/Rpc/9jVMufNJAVNg9UMoBPA0WK1pljgrbK1pbBO/gCb9APUiWOGNdMCAuz5Bzq7e3Y4kju0Aq5viuNokUYfnr16z9rZh5JTBD6pgA9FWlAHq6YsUaM5SBizCUOjK6Enx7UAjlwYoSZG9MXDomrjEmLoTxLqxMGoPUyO7/f/k7UXVSFSejsZqSd0UBH7lXnD5Wj1b0PFYeCfnZP8j5dAijg+RlH9ONpL7LEflvISaPyrhg7+Pl399enP02kvhYCNIHu2E/erFocFacUgp41piCCvTWinpFW7rOvKrALfsdlIUvV0rb39xn9prz5/CsiSws2Fizu7+z98h5vm5+79JPYW9Nm2g+xoY+Eq4PaDeuU6k0CRMf/nAeJ4ZB+h9twWAvzIUefPkBTiSIB7a+4Fz/mVzAPYAShSCO2e/aTXdLwXO6fxVAKuqnV1lxemQNtu/wn1tUY7hu19zE3q7al/3eAeu8ibkH5EhKzb6KekEiGr/8wyYs3/g6aA58FePY/zxuOvfZ3S2A1j/SuqzweqpUoKfs+Kp/Az4oYzNpAdhOzrqGmvTw3X6Q8UKBslVVWdP6f/SaahHhElfFAHQlCITKL0JXBAAoif27Xu6KSDRFNR4wrFbj4Wv1sClWccOXOFN1dQOQOoVqpSagMPt9HQ013J9A5RcaAZC/5E1zf03MXsO3KGZuW2Yu9LCgwBWaezD6eZN0QESWRk1YFspehSo5hd97ksJTDSpeagoK1wZbWC/VsQI2cnbh7fIr8sOsY90aMOOM+9jDDTWWqQ4IvxOF2GZy5XoBUpwS6mmPNgyiO4i9CtYFSpVjb/W3/kSR/DjBzI22OKO2a3GeGN1NHWScWSY9KQzWYwiF9Le+6AXWQHimJgYm1NXGJDXX8qnyyA5np3aNxHqqi4x95tNysY1PjKm9JJZUZ8ZloiYgDcUstvDJD/iM6OX8KhFM6BO5Bm9dYqLRGIBL9Sxxuym7QPb7vLKCO+2TI0UZK6FpYUlneCGZ5tyzAmdKaCr7OVhkRv/QAFgf7ULP7MF2jcl8GMV1+0T5nIO/R2rSaKat9kTHPjmJTZVyw1VgaVoKoBohArURPUnTKCRBo63nkAnwLBPU0Iy6pxwZeQhoNYMYTQgFnZdLO8f9Gu8RP820MZ8ydsLwYFxXl6VdfsASBz/EhXVdzkAxKxJY24woWYMeJgXLS2sDY0/xcibIU6vFVMUqdsXyYhl/cA+5IN+W8IsE5V3SI37yda4evwtOf1yvq4M+olXxaKuaZLJ+QrM6Y3VXB6rkr4ag/sC6GlTrFYhTH6Ne9odKyUVfEj/dFYpK2fGKLjl7Re927XM4b0OfYQppbZ178//meaNGhXBrSmVmoZxU9Q/8PUMcb3oZSi23ia2T7KjVF4Puwx+ttyb6gTD0RCc7HHNvwaPAXAT6GK+eUfbH0qdYdaa6WH/AgYVCi1EjQl3rffwB7o7eElBPWtmfyAKiniLjS4ukBzEDQdQgrny1Ol2C3y7VfVI/UOZGv+qJtRC1J9nGF3H2KeSyTlJiPEK1fx2vVcXdoGF7d0VvuOfsb5555pVVfr7MNWTQMw+GzLQH1IBmtcsMdm0V6tl8Fcjx35RWlBkPFS3XAmquqnfBonlr9rMI4FY6f27Ylq9cjHtgrgUwBAlFbCfceI5rM/dlVY2Xtqh5eKDlDVzbUrYaH6iCSSx2LUqx9YA8oA7VBW66nq8Y2zYYTFz1+LRA1FOIuvsUikX6d1lvCV5eS0MkR8LyXoXo2XvaV3NfMwQeHPjfjKLmUIILRWiA6H800SvkHR5UfAnsF54Rsirj1eOO0LwQxHH2JYNIzr5g77Q/VPEBrBRDJIX2oBXS7RA2xiKtvTAW0aBx6V05xo1BpMVAL/LSPLTKbSGSpLQcrke5vtzvJ8N1iOdEU7a4k9cL/Rzwh+uAPaYAdaAlXI4cyqEkaakA61ltz3zDWbVdOT5kmLthEZNQ6S1eGFzn6NOi7hwRbFn30yihxCKxfoOrQeTLnlD9lelsq1HM+217a5u0Zly/6X8DhqSuWcvDVBzc9b0XrOlGMcQhsY/7xmtQ3bRkbC8bQE3fO9ls8FalYQ6PfKY3jZd4L624JvVL9OFCwA3CHRs4XVKbJoyF2Z8q+QKzQkrmzuEHZMPQ2wPB27WU3Y1MuvaEeIgVBLiZxFK2Q9WyPFXLqjHPBn9+iapHNJazPxPcb5rr/MNaq6kLtlywDVrTYEDgdEX2+PwIIYyowzbmJPpxAG74UYcoZeshifHHvjefUZuys3oOPlcpeWx9aWUPp1bwIUQyVvTURJHc+eUtGmRmoNKo1Opt5vOVbmxywQXrGbiHDxflw579cIEWWOUvhZ7CyqF8HjchdRvYQDp/LOCGBaTl3CPcl8vBNA5Vz7WhAC5oM3lr/EltLd8icF4ckq7MA56ubm4vbcZXW/nBwhyiaa5iJodmZ6QspB5ab9LZvDDgSmrmdsSWwcr7d8uN/oklqZs2cRmHNQ68tWetA0QQMUbGTermFeji0daVHNaSaSVvwYUGThfMnl9veVuz6TG0dXvWnZ+O7axdOr6RbyoRJKI65IRdxZOJ0ZzqXEJK6o2zYF/kIu5BjTtUMWWW4PSwmBTZCVRU5XramC+35TlO0cXx3Xb+OwUMNwnjxuK43DPjwD1cREc5Zkwhp+TbUYToZdSKQI0mKCgfbPBt/M95D97jcdEBTQCo2ynQ9Eridmtad1qZyG3w2ZefJtNthroM1meM7flp4q3wNKptUOlpdCrVRmrjOG2KqTTQSn1u2ikPftYrdvBXpyFQ8A9LdK/gpB1U8Kf8crnm45diO/IhcIrm22OT8LJLrxCPafR2oUjkiX8++Za/+YJHOf/kubFEIEuBM3vak5fqCNvB3Z1nOsaTEGvTdjh+hKIbzegohrmH0eGEU/jvVDuioYzomNadyvmQP0TrAb4NR/RUO6KnjBnRU4ZHlKs+jf+2yYiGxxlRHnX4n9xwRLdhtEdqO22DEYXbShlR/mobAqdXR/R0N6LIh4FEPgROdSOKJDeigCMwHU1f+Y3qX3Hq0LieRjnK+ALPmCe+Y/dl1b9iG5rNBbzs+6t/xQ7Uc7/HQN8u+GdLIOQnk4pfhe8QnhSEuTuDIa/ApTCCdcUfayvDpxxeJvhZ8DMjX5fs1jVF7QVnMPE5Qw3HyMsHlWejMz4IXRUcUM2zWtcmc2ncuOeYglOIKbtFxKqZe3hkeelUpglNp5Bmub3ZimwycG5Islb5jL7rpE1+xeEzqk36zVJx8H7eGbUHshasrez90fpHr399zC6PqOUubeE689oqVign6BsMKC0VLMgbSj6C5JWVcmu5snK4cMsgaVD59/TzwxZdgwoX7GdvgS6YEb1W3BnLjLN9886qRWBCYKkDi1XIMgXOYPUqhtMlFWB9CBVAwNqBwYlDyKxzIiKGu76qDZBIhTVq0EktRSbsG5aUIwpxHGEsWoX6ia8iKJZ0kdzqlmyIC5U3DJ2/fHVn7OG7THzbZ2K48m40j3xhMCU7uEVjc1qMq3B/q7eD01dGvA9VZbbKlsIvbfo6i75FUHUDsQpO8xBurQfO3kgelujvLQGasu0AnEVqi7fBYefAK0LC39iEsnTdEiiZsbsRn3y3G9EX3Y3oi+5G5MXtRnzZRsTqM8U2THYK4uk11ubhziweCa4uuKrdtI+1GKpjN+JZBUhPWmV2I77sRnizMFSHMvOmbDkgFrkmcSBcV4cvuxG9W6NAlN2ILy0VGGI3ot/Y3UiM3QgSK6fw2P/vOzMAUBnSSlcOF6EDuQsyiTGj5WtFtqFyY6paphskV6aCi0KUkg6PlX568BXA6rB8uapnNt8YF7eDkg3kocEg/VOPp/ywnS6q6SG6n/2jnkv2Z4x58lBjcGlNYSWRxlc0qgjwiJDWv67UGYm0VFSJqb2ECyPeknNTbp1Ge5UM/AdmNVCdC+cmJrSSOOJ4PYPlIVdJnIh/Cl6oAI0TOBR/+6tHzRcd/4t3jPniJXoL0N5H1B2n7/ZQT9zTScuJrO3d+49fOHL+tt+7YM/eX197fXzf3G4bOG+P3WOET+3hnOmpvRXxyxCWfhnKKX/+npX0v/jYV45Yx7WeRxVrdVBRRvZOpZCwfeSrcezfE7M6QcWaLI5kVtL3ekEgh1YbnbMFOu65P6IXhWBcOVur23Oz+rpzMz1bG5tHD5fzSH004LzT2CWhQDfr2V9gz7rupO2/8t1W4CXmr6+gbGt3K94I5QKWj6+wdT7wOTO7si/eKAU6bboEeLTfFL3keeNML4s5E35A3dSaXIZESbbpQhJVSoiQSgn7qDWEeJA5hWOy8UY5VLEYUQ/qoshMtaowL/Btn4RwnkisF1TFetGQWC+CpGVIrBdiTcGoHC6cSjrVh8R6iWsLxVasF1uxXh2KLMNiveEli+pVf0XPQboT7IWrkKIkFI8R69VZrBcBVyLZbwv+PFtZAzXsg9t61aLyRt8TbW2v8EYB+C0AHORATJQd4JIhwKUVONQt4OoWcAnuIhwXcMlAynaAa1AAcKVUHwOuxIELYCIIuppQXmqShZaPuzKc4KXGhnfRxJHOOiBClZGJMOxgNv+jglFsKgCQhd8Daed3DgBg9pomcFB4gRNRiLc9ihTi3QHOLzbmG/Ogygp6Ttxs2cIqUwivYiuPJtMHViwax/SFhtFRJyPq8Gkc0xdqMRQp06cXescxfcF6pk+s9pqyryxCMH2ohQPBWKZP2c88GMP0BaNMX5hXGSzrWGSUywqGuKzgRJhx+6OIGTcGXjBqp9Wa1s3+5sCY3ZXbmrrtW+S2b9Ho9s2lSyomwkOqAkxfR3U//hbZFc4+sS8WfQWvERl7pcoyqdV8uBtckhsA+/C7S6w+SsRO/Oxe2te/9polQ6IiLacmt+qxrwPfSJE0CHGR7usitE8gXhuzr/O51X+l/rOEikl2UAZuXnVfN2Qm9lOeHx5HRckJx7GgGfWYPBrVXIqrUu+6CybH1VwSH3eJ4a6Or90kLnXq0FwCc2Ul2wOK1fnaOvbq6YzHxlmZcV2mTlFU8efnXz3snwwSWkn0nSeXqo+ylnwGDRsodWEHogdB5AM+rwN8SkAVbD+pwQZd1Wasj3aqHysKgTe+kDRooOjNrHEHavJtTckHuqtloMqHUE4nzT6zzhfLX+r75prVBmIs/t+IqyrOLGpfPw3sYHpyz6fQOXDmHGsAoUeT6Zd9NnItKKCnCwF+Qj6uAYLIzipwIhVBYQqWJFrXfH6dFFUT/tOZhKuEFX4pAgfAId2V5UGlLpkJdakrlKLlrKFu6gqRL0Jdyl+EmJTj66IAhBdMR0yBqVKZjkC/jcB0BMJ0YHIrmzHUlhA/sbSljqoVNWJti14sD5ckOkU7qA4yP641vAoUAhbiAGodXbnnPfDauoZUTojTA57YyrFnRKGRNKkFbxUrkS+Dkn0WX8mISF4RB31OsUA/RmY98A/lVXwBwd4zPyCOkmnRSeWlKGVGOstS8dPU/0xNHWIwOrzvnxn1UBzU21AST3TblHutagCFziB3usfMXczF7O+kjx5JEfyoSLZ0749HaFx8SNOS9KXYWznDO8bot7ZWjd3sq/iI8/dxMrIK7eh7nVT3i2o9+KlU012cLGeIuAbjgvvl2HaZvWmhHwNr0ufKSJAnBsvxkIoRVnlDoe7NpcvaAo5HOOAo1IN6E6Hp4BQ9ySaQGe5l+r2AdGYBTX7FZ5PWhAIkpB53rMuXQKL6hrqF6VfTOGZVObUdVy7/K96QQDX76QNlNS2ekj5J4xf1gLkQrRwZhmVW03GIyF+qj3YxTdzPxOA7mBcLVvFSUeeTbMRkAKRR1IVFxQQWFXMfwnJjj3O7otEihaqsFI53VM9rbEh4XqifPY0CPC43kiDrGARakOpCXVWJVSXP+GOUlucGXJfLxWkuARpIeoau7kNwScPHYzEX2u0hT4g8psh/BNwkQ+FDu+5cf4fMK6ekmjcplKq0kddSgC6+cESEnjrdWLURqX7npA1FrKwDzHAkgQKffHvgXBdFEfTjxTm6CqoE+slecH6EAsytZ/KDu/eDeEMPApzHW7BQ0vezf1KnPpgFha/3XaVA/LxQLgUnYCx2MkBlOb8X32X/gkWlaKsPx7ZU6oTdvs5qpW62ZDXMqBWbZrSz+1A5zDYMVykmTJezr6vpTBloJXYzsgrgHleEu7ruSvKAUrZf6k4ioMPpwJp3YHg4tfyjDovQqqflNbUqfdCjwI2MLyOD0X5+UYeB1PODmzkDV8w/B72l7Esq+iFOOOBpCfs9TVP1+uzLmuNMLjlvUcAhLsLVgCbYSurkL+8rWBM6G+jl06I5gPJygBvJt3Jwl1Gz2Q0300pP0F7YVt8BIZuEdkGRNFDQnuvfLOlqS/gmT0yOdtG0xPbgK2jfSHsKf201b44a/0Ibr+6J00DOMKnqLdXtc1NRl5qrhx3c9bb5RN6y3i1wDSMzWM6pmFiT1Bq8fzf6E5mWfVUhJ8Nj/KY+TafDzKWqBarTLtYZMiUkGCbTdJnuAge1gYqRYuVe3SJi2ujdLXdMVeMx0AVzSfXSfQy4DoTgRV3a5Sy5ttD+sWm+NFcaUdTMSR2wP7Z3fgLRCtbRk+/+2fQ1qcR9zcS1dcKC2Ki3UjO4LvpNGs00vZSnp7OYeOXiXMv+HPHplnGxWM7Vrt4ubA9HRbjYIUHZNPvigXXeUt8MvmSM53jyMBDqrM1eptA1Y3eBRUpXvAspcIeUmryzkryrmixlLi5Zb6IKCkTKthSNUyj4rnFcTqVvHwY7O3KY6Jy4QPqUh8alQAvYodyhIbJn1ZTTRfevXcJeXz8MKMR7aE3XIbWo5yKrcd+pj8xQ9Nf6vvpg1YMJ3WlA2Ix7lZG6CbTPS3vGjZ0/7MbOa3vOjZ0tJVWK0NJVSqmBn4hPcVwLxbzKvqE7dWyVGHTq167lp7YPNWCp9ckybDz4U+GQ87vIgk+3ANx2BNTdQazMWB0k/PtMQh1OMRKOKBpPQ5SsbIm6TIHnLetbKG+qHy7jVahJsXUFnIIdQ4ze7ZVPdbcfA88aaISP0zwKoQifLu0zm++Y0n2FMZAdqxej2Ba/rmx+aE4tOOWCLVcVw5q7Z33pJQI/dAHvgGC9UrF2AqOKqjntGdrJQBqjdVp1RlSNLJdWOmPs1eDuNupsap2h8QDhScUxItEXo5+b6oLJuGddUgoKogExMK6J0qheOqKMS0eUHum3FQ+ldR1G0x+RYMfOq4fwxa79L+b2c+NRvmzHAYrsemzBcUxq/EmqlzVLUJwjyUNRIEYsRmem7jiy4/oQ9NFzPR4XY8fK/yk2gWCp/avAua5RN7e+TtVAP/T5nsMFtRCv5LtLEw1QyMB5XwVPqLMrpoY4DDbdDbJ/QV90IDLZkogvYl9tUTPgoMqZ3e+kUS1OaS0zZAtpQKz94K+68GDcVD/Dodi2Zg8gpa8YH6PSQCqu+E3ofQVezrW/MWkBHam0/85PveNT7NgG3WqYlBa2wQ00Hw3qvwM5qNXnxxmMBh2lq19HM5VT4eqG6hGiAnCA39M2J8Cu5z5PVBga1lVJA8cnpc9JMaFBAs22lFnECKMzYnQ4MN4oW5QoxBsCZbwl+oAviX81WNQmfK27bsBPwTQWjDqjcKYrOhjqpz37N8U7K+FSrXVAz4eNDyRW6Z44/XQWt6/Lfd37iMD1liIsE34MCwM7u3nyN+2/2g02/C/frP1wySPdf50qZeAoUFnpim958V/34ZMpg1ubixfiqPK548M4PZJ6UMFwgdZe2Ddr/792bfhzCsvvGBjvFAhElksLOeoNJupmjfJFfqp2amDDLH2l7/nXWvj4t4yHzviG1Oz7A9+UA2MtsaOAUr9KQ00NNgbTxoWhlONAY3gssL7rgQI+RRmm/4EBiem4AVRgoAI4vL+eWEOWLH3lv1LT+ljNicLFWOMznQm3/Uf4/XLR94fkNzvqLuL55NtXCs35xy6E+XYLfnatnG/fu/jZze+77XU98Ihiq02LQPoleYTHHms795JhQ3J7xm28UaUVolsvRmCc4oriT6OvFj1SEC25xpPCWyXrQbTVzxaKRv+0aZU+agvLbqJjanKe8gnpVt7BY0eeVQvw1xfgipTc8qXCQsqScg2sMuocPh89hyl1Du0xLh+FvKkHBqVeeqUlpVBr0JrbzNj1DHoQiWstrBC87OJuDLXUnyQ1dVWarOgjUJOJfz7lYnCJrsXFSZnfKwVMEn+dgNRPwkRfC2CjSNeOKchVUIFYM+wADSENoc6g6IiYmDpiW0rVByxsBGoGNrHcRtSv80yBHFtsyhgURBNcnIX4hEUswGsHtbDktIwVHMUDHeal0q1NIOr1Su1nEG4J2SyztQorym2B80UUc7Lfo/bCQH1Q7/vz2ZSmcZ7CRYTUEiYlUJ/2onBLdfmdhTZ5itakipxuKEyNdiyeisa5sTILBM9Ju2O48VF2a81anbtVUaTq1PrBjZ1an8Ck+itOZBf9LM8b/rSmn5pDJQ+5azb3v5sX75e/+vgdfmNw8p77wVqNeO5HXOg89/P86vOg49C0dTW/LZ3Aj/+nmRXyjB9/8EjOj/+nkEKh8krOj/8Nr3Z+/Deu8yF49e+/8HlcwNKj79v/xleP8+2PuhSZ1rn3fyXiHqbz7je8er3z7u6yc96Nl3XOu/eMc95d8GdXM0YvPQwP3qdXtvMyYaz/xf/Bo9q/6Mf7XvZG6XR6k+81Ts6Ve4H9unPlHlZcuTtH7t56R+4Q0Tyg+yuxeww5xiFUAYVJnGPGljSQqyziyvaZcoWbDnXjGVFouGkckaoIhMtHOVUdYGGcMczIII9QHkjLfv9Vzmd7MOKz/eNIraWvidlhovcyd6E+qs5EEfu+bGnChxPs8rqnbK20fjSj5QuTpUIUnblDYhAy5Ctwp9y2DD0H0TKqcTZTjfefT6ZXn4cXuTtk2FuZTyxnwNNeV5U9AjIZpzgqfVMHzdKqc6ul2PZCtG4WqhhlNda1vFF+pZ7ZNUKpe0qxqwTtRwmuFkgImcKkRjTuEXxO8Y9tqzaRI4NLjTH4AL6Ym8ADB1D0jppq6r5IIWlKRsRT/Al6geZId1n4GqQwtK/erGLxt4lPW2JuLuH9+1AZ2vrWEmeByD8C2WERP2yDRNRWKwWyo5MdvZEotUoQ1gGXJqMx2q0ikJEmpgo/T6wrSH8YEgJWK1VjnEaDY3OzW6HTyAGoYKgs7hkaWqs2lLShiaEBsajtaEOlR5CAtyilJPum+puWWxRI2FVKKNKjkGxu4FO4s5FLYesoV/ec8qFegFznTDhc50w4co6K+VMtOMAY+fK1uhAW6uAbsoAISxZ0kjvvwftfPdZ78GHQPOufNoBMKBT6iJD4kXf+aWMzDyLCxFKL0HXnDjaG4fZEtar4xTPtbIBA4a1psLqpE6SuAFGpon4sRI1A8MQHbWh90ELSuQ8IijpVs8J0GKjqfNCmQ5XWx1SamEqXKo5vUem+QjoFhFnnZzZYSt8OhkivrgZmq4NRC0uD9b6FOZLy0I6+p6nIDPKMN+GZDFX396k2CYoBG+9XFvYIqFNd2OV2thLUyJgRkCJtTb7QHMgl6ie3gsH/cOhWMK+ygnmVNSxYv4YBBe8zMsJQhUOvkiUe+k9YwpyjcWH40MoI9brKYy5Y+x5o32MjQNU1TqTSKv7RUIIzWP0WqmsKhwgLQAuVIJ88QnkgLTvwarew1UcWtlc/An7mtSP8TKvKz7RG+JldJT8TZq/DxyfiX3543OFJheVV3Xas9bAPVx50vB5lU2DF9Fq/4+OG+aKH3f3XjHQ/fKHrPl7Wdf+J49g5PuDf9zA4uULAoPjKC2K2/+USLY1QjQjNorx7NYsMk2Y5PnyTk4avIp6D70PcZWlDVSA73NCubeh7YzeZqWS74IOE56YcKl0ul436V2DBFPfkDb1ZYP8rPY03J+I4Fks1WBI9Xt111njcR5046iFdZ1ZNL4ypBlhXQiGHZmDZaokiXeIPMjy4hxGSrdNvS7UUAfRkABRL/X1rCHGtSFEqW5J6yc9+SnckYRnPXS4T34TEVjCcxqxomeGnkUGZzGZ/Xk+XLFuhe+SbXBF4/Rn3QdzHiBoGAw/J8LPaHj8ldQPDGKtsI2q4HqhFIpUum64tCwDFJiXVaEJ0Jsc5LroJtQD3OgzDoIRhYGAYWBhqCHHKa9YqTUhNr4umqpGWo1wrR7nG7cMYjx1cHfeRMW6rBb48BjEw8Ps5JAi/BnzSuJsRB3N9+3LRhtVLNpEwZQrhmHPdglx6KgCgMPraSOEhcg+2AwIGPJ44H8Mw6bdgIXWrJt/mQp20CU5q8Bxeq/sehkqYLHsUpKGIx00ZGDHa1kllTT6rpnkQkjwoOEAuNSOl9tZ8fV4Kpj5Ifzf066w+ZS3mVeW3qg1klfHEEJxyHTFUbUKBPFa0pyGMeD7MuARh+KWTY7SGHvQ0zTnqX1XEtR+ruVEJqaGlN7VgX+uNtOhYS/W4VLje2KgcOTkE7uXCKJart08pnloeKkHrXedM+ytN73vHr6RmKqlVJEKeVgJUPunObAwS4IurZaQraCBqOk5DTr4Vx+9t7XggTdWQn0GXRnqf7/sOleC1MBrSig8dkQhk0u6WECbtOQhBJSISxMG6vFPCim07EGb1OVGSv1i8R+Fnu2unti6vY3I5OR3V8cQE0MpircnXmjwuEQ9UGGiFurVBhRvV42k9w/Ao6wm0nlDr8bSemtaD6aK1YLIcr46a1rFuYOsK88h5Xkz/OnAQ18OXuApx0Fhdc4ybQQw7Qqh+L8Vop3gjMBP8QgmHMql3I8zdEPr2h7UluSCM33NcQwXUeiMotA3FXMITexytrq51BVqXD9DEdpRRpY5yhCo3rsnXmoaHt6wp1JoircnXmjytSYdXa9LhPX5NntY0PMBlTYEBodbkaU01rUkHGPVggI9fS01rWTfEiQ5xXJHZf7KyEdo1qtejaqehhjGOuUwpXeTqxFWouSd73p/oQbeEZmQtRSgBOiIk7d6OkNo3DTiTKGRRddSpUa7xdWx/rF5/IqYGbX9A32S7nbR8UR3XOmKpAIAk1CNr+yJCsrZ3JXS1rOMhP3OY23rMkrQArSkXjVSqFKuTKSVqnkuhV0dknRoM3YYCxyr8ODt7v+Z70clCtYZmRArcWIFbN0ANjRJFCdRaCdRaCdRaCdTacYEalkCNVFLE6dKQCsLHWmTdwbCsarGsqqtVzWjLaxsDUKIc4MAp4eCUPwk3AtwvBH5kKI6CLlwHugqvHvV9Vfp6Ge6Yi36QMIAUZ7eiDdYZwHVai5fHKpBSoItEAx3CXMTHum4RHgpbhBS2pQNG0afQdRwtkctPep7qIB3L1GtgmlrIgvs0zwDGHLV9qXJ2MfnWPY72SHcoPlpUcrukckwtIHszPi/qovylB9qWO6gPUZXw9IDOs6EdyinXhZvEICsYs9u0Lb5UiiZ8X14Xg1Iw+KQyJ0jDQife89P3RuPwm4KyvQgHhgZ3JRy+ADR4RtEq44duroBuurnaLiFMTe2sopVuFsgxc6qyI0QhLuAMEEJjHFYGZOoargZjit4azO5fi6p0Esdj63iK9BklqyHGmk7H8aXXZWpqyTOmEwphVLth8SLZhSipWvLJgafwNip5tOC6GY0MkWavVHf7Teg7dxEnoYzjHu2OPsrdQ+ON8jIwGdmVhLpVLiXP0ZwKZaF6ev0w0lb2ISXShrrChYytusJhEoI3wuLTFdoXmpVtRkIZhzJhfJVelLhV57dQyAm6okoE1a5IoepjGR9wL6QqX8DSldALTS0++umP1nOcCp6ipyDiWRW6jI9qyQC/ryUXdX6XBdVcXQFQLNIhhyKdhmqWFCnSIWSRLqSNwFskD6l5inOPam/ReCCd6WZaLiJ4OLSDLFv7Z7EPKArNSEc506+GQcDLmzM8WnOGRz2wOqMiqYk4ilQgVc6apJw1oZ01kXIKcICMh25/JKTbn6C/XXmCXWXPdHHRU8ioIoyO8WyFGwieguMInvwTCZ68oQxFVBYreYt6hc3UI1ock6hWlNIz7WVdupdIKDRQiLTnUdnzCEnYX4zru5RSzvpGlck0+yVaqvKZ/Sv0MDBSVtPXKhKBLAW2amDwTgnNCG1DKANtc6zmxUvSDrRpHavJsXob2VEvVajqJ7LOy1A8VbUWwXfmDapjhRZOCuRGuSmgUSqa/+4ywy+HXjJK+MBPKL/hKwcFO6l4DeS+J99bg/6v9QTif78IUtAQyK7VPbWy9soY6UhIlthmIZNFJ5vl/mMwLeBRw8pM6+Ho05Ufa/lxWX5cKT/QLGO4NCz2o2Xr2ckwkW8okW/qwGuRZe1pZTrUL2HyWRe9FoBE7eHA6oyC5CT665qcWLqmDDVClqGOLf0h/MyUUInTShWBVhGUVQRlFQ0tsKlEL0RFddhayutjC1YmJ3XEKq2Sqb/yHMJQSaEUT/znweKV3gt0iAIaIk0Exsuy5jAHOFXXO/d2lnTLWTKj8yiTiB1yQoLQdp3gMhGxtwwFa4L+1pItCE1PiiY8RUFpmgMJ5lJSjl4iN8T1kDRw1hWS9K3+OFZAhxbN1SEzs8KCvlaCPkHIImTJyoQlKxM6VmYEGwH6UZ4jVnSsq7o9BYXrRAShIBoEnlwbdAJciBUX6hVcSHJvLB6o07LxaCCXlcuDJMh4raYL1dQqgO8Uczx3jK/CIYAJF6+DysVrtd2h133t2XzuB0hXqbHeb0VnsF5nh1VhTz9GDi3dl1euEGfCcu+gevEaL7g+Nnzx+mJcB/6ivXjNF7/sLa4AGUKxsCBtylb1/L9y/D9y7Xrw6od87fr/vIvPh0If9q5HFRzdKPf9F/F46lWYa6TH/CoWN7M/whXR7I/xCwUULMFysvunEoOcu4ZiILW8cCjG07F75gZHr5eozzf5QJ0qqtSvGlOXF+gS6Z2H7F3OH2hYJEYvAVXVVRkiUqQM8dDvwHmArlYtBK64u5lFKu5SKT2Ep0cNk09TJQ7TmxP4gQrMBgOP0HoSxKha1xyKCw1RIajruVz/k7Ulgc9d/CxtQ7qrlw1cvVzjptjblnLEbC9TUqr69tpOG61WUW1l3gutGdq6oFrpvikuLwxqTNVEjd6RPDpyR3JcLGaenudO6Al59jY9ifuU5/nj7kxqr0WBA7m1dk9hMByro3mh6gbVVDjru4uPmryrknzOaPL2SvKOarJU2R3XjpaLvF8jq9deUJjr86+dkU6JlSdw/uFLAv5rXRe8xHa8CIQ13M8X4PdcUy62qt7SN04hLC4XifG+g9QmolpI5H70a2fV7n73DQdqooTWF0dUR+V97PwJj2gajP/IZ2pUIG8pirb1/nU/eQEMfeO+by3Aii5f8RxTG40c0QIj1jVGCWI2H48WI2uRUesF+SRJg6dgAEa+hWcX0Wtfy2e1jjyGDf++9evWRjrOMyZfgPtzkZj0OwKTfki4kCRiQLPwK8ofRoQOi5/CmvgXnVNnijNMm9S76jRlYpZnGpx1uN/LuzSFDm3iB3d4gWYgPexxAYuBUbrDvegIj25R+96x1p8351toM4y65yRiN1CYDpbxRCgxfLgu8gO8UU6RqonlEVJ/MC/wuCTfNqZY4iKJi6Z8swBjQbzyUKHKEnOUL9PU1QDL5JLxtANr6KRvYHE17hTpxpwqXm6l7ewhB22lUxDYjAaTRhJt0cgtqdHM5Eo3oR8Vi/IBTNezU55iO23lvEQchpVpTkDMlxBzH2JIs/JLoQk2a6ZZ5WPNWqMAvuY4gp/U48n0AII9htp1P17E/H4/3mcIwa9yUMQxNXUMC9+6qvwprh8j6lIspqy3c69aN9z1u8/b9d/vudg+GSAW0ru/xz7RxlPK6N+0T2k6ovfgPv+d9okiuKmScsXCs9539MP26VJ+/Org7NdsWv2gfWpKQfqP37jgL3NO/Q9fXPupP/yvF/zZZ59kn9LQL9x25ms+99n/+hH7BLgQ/9JvvOeH/3bz71xknzb+U8/66KYV74w77dPG/+L92eTk5PUX26eNv/SH8O+37rRPjdeWon+6dN1pn0gb8TYlPab13fnk7gMf+fy/3v5h+5RPP/ae9334Lf+YX2Sfthnv/oHb9j/jZW/6iH3a+IOzv8/d+NeL7NPG/3//6aNzyx/9z3fap41/mnTjFy62T9edrTB97pmJ5ZXz9sHvH2fo/sFPe8WWB3+gOHVMIpvmZyxGab6Jsk/O/v2Ebx/8AVQKyRNwkacwoTCi04jkU9r84B94tD630c6IjfJyPxMquoiVedE60u0gR4eyvs8Z+RFjoXbENFZJHPjhHXhkxelipQfzOD8DEz2Bdu6Zul7sFKck8uFZSntReo8CPNr81QS+5F6clZ9BMefZgbXlbNUBN1pCO0FXH4MtyQQb3sp30Vk0QY9Zxm6caWwHrzwpi2mOW8ozfo37+wMOtnj6PpYLfhydkT+ezoTrdLNStOGAep5/CvUeBuLQQxyYyTJGj0rUGrBxaSpuBDp5QVm+jVpMzx/HxPzxoOL9l+U5FeIsIqJN+Rwt5JO0KLVB5qZu1LbTZBk+hebKMFFUhpmw0CRCjE41eW4Gbm2hSF5OpTl5nobIc6wfMj2PZScGiH0CdYkQOLdMpmm2QV/m+ZJxz4AASDEXinUq40J5fjHVRgJQqsuBUfTEF1J+Vz476HELMQG0rimuHeVwBYhGCRLtmvAEOhcV6NckH9MWOgdxWyRuhVtULZFTJVOXTh1bIhxLaKfw9S7uk3SDEEcSdwdXN1QiETLxh11XovNsIoeGc3jM0SQek3be5BAw5DonqBBeoqBt8txGm+S5iRbkuUCL8ly0fgYmzPyiaZlfeGTUwqNFj8PjcfR42rXEuDrf58c8PRbfPZYe870qWjdC2rP7L+UrHV7NT8uZ4f9HnRnfnRnfnRlBiokQPD8/D49LsUwAy7mEMziU4OZN3kIYU6GDss7ims5bRnE8IyT0WEbf3TwhHsMTYtfDnxC0fkI8Js95MhQ8EbbxhNhEj+W+7zKTYoryPB4zMabBhm8wMaLKxJhW5puxJTKTYrIyKeyAThs0IFJ8NvE6xSxyC2YDod/xtGfe+5Pv/8LF9llsBRe5mb8XNkVlDPZZnMOJgl1asuAh0FVju6Pzg0jQkVBqOcXIzhXEls0DI6NzBdEOD7U3mx1SU0Fa8ylSok6TYaSGFx4aRWpF3OPi9jQe0/AYhQmluJ0L7uYPE8cfgz3bY6hFGbDy8Xh7PON4Brx8LN4eS7vwtotRnYDqu/H5bjrPLAK0E/LYx4EvAnLnWQWzFwSzH7fMtTL2tRifZxif5xmfNwV7DFrSJkbaJCd51sTJ/jaa4T4uYP/I3ZrPC6AnOs/AmWLI5AyWIp8Dq1lBy7hKryk2KBgpCjosc9S3MoBUklIdOkt6q2PG0UjFtvFkxwyjNGlGaVqgj6HDc2p01ADWbXZUZgD5GVqgTEYOb8wP422exzXDsLbwAZMj/eBM2klnP7/gH2y5X7akPnfPpLNpYjmfwL6RIR/TDrDZ7EwJH9EZJRP91NzILgq4vlNvvQiFHGpJCOZZHsfP6IVw3cvjy1jSxGrfQxiiBxxgtpZNgcV8PlN17gtfUj2M9hm0jXvLSXBQNsXJBU3LDlbFBiiRCRl2tHZYqSY8QpFzxB4eW0Tgg5q8k450LudHiJExx3OzrlI1sxbn8pSF9BzdkV9NAYZdN0pKjvCRepkKqGuXaCy/oCeahDNY0BTZwu+yRdgdPud2m/uuwSLM9g2XZ1AJcXIVYG3Uj0nGa0qFSDjBFnCENcdACKa5KJpTJCTsofbr/VGLaOrdnnpWwSrFMMxjGNoiWevwUGScr5XnvCQUPN+28fKwSUUN4mOXFrh+XvXGGPOr9R6c4Q5uQ5ZFgTCJZIdiWYt0fV9Ei3VpEOkPxWI5YpY/tYSX5TLUJq6US7QlbZFvZSxPpdlbOfdpJjegb/ePEU2BAHcJVWEi2608fIEpv4LPFNTVz3KzCm00Mi5ngZzngECUkdM0KZOZH5jLeORU4DFEf6/DRLVmrtRkcU3n60JfZvYMHkyLmUjkMT98+AyP5UKjOYAaJEmbBafRdf5LPBGYBvY44r7uviFJaYFzLSO5J59lSHJSFquZ1LxuTPyqm0k1SqL3bRsqVW1CSKm3i0UAqDYEashMCWgCjIKq7QNIPGuW21aEkrpb1ICwfZmpBMSnKWZ+SD6EkxN4gJny18TB4SSlMv2n0EYGDIBzWY9DR5Qms926aZRNk/DQXcyoV8Zd+Swe2/OGKiZBDpbBikcIKSk15JCaRwHiQYNyczQ33pu3TlPVKRzndFzdWM6SWVTmxuUgXybJPM0xYvCjJh7H+VUieAmoSfdUhAh/+8StnEe9eK25VzQcyh/T1vVbF50bI4mZM7QCz8vNc4957tJz4S5lanBLrNgCcgE8kQMSo77GGT8RP+KhHORcFuSeXAhp57NokLS5AWgvLhWbQX+4j7N5TUdD1TrqIBZCroj7b8SxBtqi5ZFbBUznQReQ4RJrUuI88ZeSezPNyQgjUQrsAcwLOjnhak7pgeSdxUyaVYNpDZq2DHyXEWJprdhya74VHbGNbNDEj3M3pNSqw1bqe643phVEgdgNZ6R6ASzi5CTjLAcTHICmKHqhJtncdKEufgsIn7fQBDWu6RENqGZt6mhD1ScfhLe8BKOxS3mXVOWq3d8vhxBTQkaY0oCsFDxvLrXo1LWH1L/Hg3YcE/2jtvijqi3+2AXraov/+Hb2N7bF77whkScXgWN1dFS6/kn2DEyoyy6FV4po1C7/X6Mv3rVjLl3idOfe4dMd/zPuBEeTxKL/PXqYU8NJQ6C9D9XncNLHF/Z0PbgMtjX0cO/dau6evHKVA3ckubN361VcDN5dXhE5Ty5yYobLIujvADfhbh1UP1tnHkUrT/8hCTKY076uco0nrPby/nW9/KLr5f2ul1+VwvSLm39p6IvgoLyPP/XajzQtTT5LzS1zsRj2RrSiHKPSkf2OPSsPBPAvoR7cwdiyzvk1MLgMCifecJt9T9aPluoTmWNktCajVr8FKZBUDebFx9okmoYKeJwzS2IeqarE3p+46eKlv3vM7xE88uB6n2dNWvK0o6asQ6nIYwOKqobHxEivAAz2AF+QfUUNdmNU7kMsApJcxGIOKs7eCVqJKjDx4zKdxNMzls6WCLVb4k9h1Q7+ERtQQ/49OehugQi17Al3w7h5U5rucUJq6UZKESJLjyIkF+cZtG1FKVrSZTnJJ/CYkTPFjOr5JDhqyMKx4AHEIHIamqKMi2dAW1BOjzV+PiMrRkh47jJPMk/c6HzxNUxGJ9WlnZ4pikJ1tk+juK1TxH/c1gQ+D8ALzfIJvhBD44QcZ2fw1EQxFuKWLqAzMtzSe/C1do2YAZiEaqZCNTW3WzLsnkqPWZXpoJogICVPV/0W1BLJ99gfBZQJA9IkiI/m8Hdpbx84YYq4qdopHFSgPZSWy8CMo4Ne3ysbqpBRmxtxdRnwxF+MyC45wH1uKT9UIzG71qDUrgfz6MAUj/+clOiJL0eKxC2H8wmkfKLZ10nHmtonKImSx+RF1w5rqsysHZO4pjBJGeIyauvCF7obbDBJ4Ttl2yETyzjqVyfs+rZL33ZaA14cdaGiYaApmVjuuhBKVgid7m9nmqohthreLVN3lyEiePgVpz9KaO8AVVQNpgvV6sCRsqmvfzTNiUEgxmEv+0BpPAynprlXWhX79TIh9ypWEMg251e90HuZx6S6dKNoHEKcDj9L+LCLpjDCJrk6dCti/Ah5XhSd4hRGZET9nx+BmFIGRScFwKJm4/IIcb5+Z7zj11gXUP3oHxE7XrLzvVd0k0gcxMvCbqJwP9nP3iMrzhE/qKPRLzsp4x78/fOsdY+f+5fPJ9Bx+xU1ejFi5EPyim6sM/Txs/wNBf3f/7f3hc7Mx3tRQBGgrkh8DAMAulNPKGadd+gBKSCYTmKFiCjR7ZbCQL4ioI+EFsu47aI+i0ykj0U8EBkBXnEFXgFFChy505i9T0dbuxRkv1ox+6HmrzY2f/E/Ho75i/evN3/Bjama/8DbOgMYz2P0V7xVRs7gvaCWmP/p3/yy5+mHQfZrKN/Mh3EmYNRIF4UbmIAZtjaydjLWRtQOhWKJM0OhHTN2KL7shb7g3hjPXZVbA6o7C3zAWgF8qKsRJaAS1F2BG8acfRf8t7okiPVaVX8Rd1FEuaqh6rHWDHdCERIb1pKPFtPQvAEQJKoiCNAjN2hSGCdYet2FSwHcworGk2TyNNOQh6wfOWkjIe97mZTqu1IDHtGl4jiWQl4qzIsMHjrTMpNRIkB2W4jzNYdvcuBtRvIHXc0/IxEgNF0Tx2uJeAbVvL7Jy7AUAtg/qqYD/xha0CdHRu5zZORNg48JgnxwmIz4KoeoO3qCj5SeJCAAQk9+ij9msBz4qYHSk3r2oSGbQYacR6oDYwz/ZB92kxuvH6lMbv9bMbnvHJnc91UnN94e+uQ+yJNbPgyyI4/m5P7oQ5jcOnbVyX1fObkv5zKrkzg0101DHRMdkZzf8SxCO5/Q/uw3kENKc5MofSLPHDdRUCrgWzpCZoAsFb751HdzBN1Nv8/zNvAbMbM0pLKpkcn6meef5AQOT3oCjzelVO1jaPuYnLCPKCZ9X8jmFKNS4FerXDPFhH0uP/CanRdcoTHPJMWnQq7rI6xa1ZdrOKEQmx5cLXmawFydxqlnnL1SBFxqKDGA1ifxdF2Gx5dygzzWqvMOqMeHFIEpYHZ0GceTyfLz84alFNi5QeSBv8t6uBmM/V8dP9Hy0pqw4wGUn+FJiZoUwt9Cg/hPtpvXScJVz1/G42liNWc5e5fCnxK5mK3XPsQbZ6bdbq6tqsObVF3gpCh3eU2ME4tUQGeH9I78irNXZkyzr8m2UdzuJEWrkgghR/vwoJhATbuKDnVo4soeKsKGsw1j411OnBgMBkULeXYUbY5uIQ+3Asq7UgPDom5gg0dXGgdunwPN5b6X/Y5gREgNzCTNaCQ/AinpLcblG5ioFDgzIcfBmu9iDeQB3zqsuevV326sefDlJ4c1SryqWHOJXdb78TKe8vniMnZS1tIJxiqmeva76GYnHYn/PcSnnw58z9kv2M/WC+v2/jGxwO9YSPUxYglw//eGAog8Il/XuTqYtVp/DfaP+eUufwk1MhAiScrW0Avo8GfXQzsaez3EAP/696mlKgSPhdDixu61rur8dTED0rWJIOkojzx0BjDG2vGHdg9D6uFLxIlyBYs1dXEZC+17IGST6MiI+P7r/CVJ0/gj19v4/UPx6maoppKxGi5hcs/V1Ad5qt2/A+3RUdLYC8dF7nKRHy0jt4+L7I77vDUmsozRRtZ5/CyCvC5yy+RB+OKxV8nw1es8fjLJ2I9nDB91CeB0AK9MVW7E09j1CzAxgVtFzFNT5V/ckhejALA0SOYUjnohCukHS3wqfK5/NSrqB+w9cFlzMp7KFbDnEkt1MT8oXtZLL5aCLKqzpV3LFIlsKBaLebmnfnit8A1paqAT2wbypHHCYOrMsjZSYfgWrfe4VildJ5b0q1t4+pXXKzxYhZLtyQ9SAtr4NErgPk2K508bUinKB1XNPg+CpPkvkfzQZlXfBuRVJmIRSGuC7O/1gx3+1Tmg2uAhQyOAxAl/eXdNLOQkWghEMYnWDykPgl9EcJcE70VwpwRv9ESog+ADiCUJ7kfsIoLqL6wrwfsRnJHg65Ahk+ABBBMEQVUMK7qMuYaLir+PSeJaFWqsLl7awNHYRhmj+Jkw3lls/HI4Hhsd2o3HymFsjCvYGFls9BQbMeKKjZHDRsZDYI+O1zIyOQT0KBqLgDxuorrvOZwLRWRZ4lwgTZB9hOJcpDgXAOcCc1NpFOfMehT0iuC4OOcpzoUo/wQ4F1BQxTlPWuNVcS74zsa5oIJzH3+Uce6xXikIBBIYL5DqFDrIPmEWf6UQusE5/hd/MOaLPz472MKOX8Jy/fSFfXOHQ7cPH/X4t7njHE0S6eNbEUz1i7V1X7zLfbHmvnhfeRaU6O1m/fiudR9/yH18l/v4YwiqFSOcXcRlSNUOVNuA9IIhMAsh5WAQklrVywdCGULt8mLXBELbDeO1E/jcMSpKvrGQjLjJ5xdTNLm8Dycj0+rWceb5+awgs14cmt6Xz+N1FwrtIrQDoU0iccISLyp20GSSzV5Gmyii6RcUPerRzPP5MbO8b7lYRN0cM7uPucmix2/7sBWfpC4u8eyjDpQP4OoZsT1aoHlINfIFmuyHkNP7ePgUiaRERfiKE+LzPd+Mxzn5Fjwo36qHP9QXqKvbhwX2GCv5GzQNYpH3hEedQhgqJW0OUkKzy0vUgpOTfIbm++GlUMGD7W/R+UJpxSSCUjDcQKMLkVzRmpTTGQwWTyX0IkKTI05Xr5RGgYV6OJ2eoBkcWXMNtNjLW33BLfmYqxa/qypDgYeYIh8+Od2KXExeMVjP56L7EDzsve0nagcuvOe8l+UFf0Z6yowEtFZKz6dcHxquD/NqhhzMIXYLGHr0flFsm+abRlnOfBtDpGM0Avo804TL7NAm/InXhTzjJjRoHtDpUqamOGbEosw8zQDTFpa0p0sFe/Lxs3w74ckqiHqAJBaseuQvIZK2PfgFL9+mp0aszwlHcwCrOmD0pRl55I7GVJvDRw24BNfwocZ2yoOf8x68x52MFZM0KZlPpe3VJFUFUo+5eqvG6n3O6vhNoT+2iZFUTlBXRDeYN86IW1YxAbGoxRGKMwpmHdxj75A4OnJHZ4W5xRjQNtVzAe91DYPoBeyv4oMFtKQKyq/s5cXQHFAXQnmKxGcDOXi+PrXt0RZM0Xn1UppPCaoI3FLVLhQcKhaBRf7z802KLz2hOcxU6tqdz5qboeso2ccdJdMkoWSfRDB1yOYbxYN1H3/GfaxJqnigZHCTqDqZs/x1H37RfahJepavtUqTcEppXBb3pRrpNXVMnHHWXiwASgvAUljkZCKwbPATbZeCoLkNDSDqYRM3zYFZEASMZJL7NGNmum8cifiwxuS72b4A5OoZhgORiUWhBT3R/mJJlIQi6UTHqzqsUm+5EZqDnIppPrBbOgCK3QPF5lbJ7cfaMG2UkopJqV9LFiatD/qDMgEa0PEOqIMHMovhntQe1h0QcDKdyfG/oxjSniJZRzGmeeD+F1xIjFe92mZUr/C83DwtnmMfn+FP6cYmoRvi26yJu6Szhm7MUrKebkRCN04lPKHvqlRA/KfP55MVajBpicC2oZmuyRlto1PL2Ex17npCVuq4EsED2nM0wKpHdWkTAA0N9T065yW8y8z5jjaQphwdkLDShwzTP6OO8TZSGRIHe9DPTr/DfpXMMEG1yo3FtBuL2XVjUdOxSITY1vGnkFXP8dNCxcaNUX4qxPQZzWApnM0jBqJPjIzj83Lpp5IvUN1OCxQNEXMFJw/NNjJk3cRss3NE8VVO4ItJA9EZQOxUA81tArW6GHGuQCqfGQuD3joY1BkG1zDyPCx8nKUZ/CnUEoFZD/iYUcKgwfxEsVjGaVLsmAxhJKNAKBeT8UL8csy+ZPxy1L7IJXrMPR+oqStqZHXsIvgl8QV3t8Eak4covK5fwiKjCGgdwtUtdiYWO69gOO4iDV/OYaKNsHYGBc5Qp+rfWy0btGmRJpRJ0mVcaeMiaCNmpXJPXeKPSxrCU2cm75lOMQuHTOLjriggzEK2clXLr+rhQM0QL3+Zv8XKzzRON2127hn+KQXupDSByAlqWdy4rco/qYUBIIhEYzpZnmimH/InjhHa5BiheB0agVUxl/yvVVKUrGN6wC7i79KeCEOwdNEmipXtkV4K99jjzxYpJqBUBVt+lNHgv4OCMZrriyNjSvQdQ0OWoQHjrCri20hvkI3yNJh4mrQhT9MD+Hr2pjBTow14moDRVpQMEDYWYGlhlKdJUDhjgxkOmtGN26wD9PzGgAZYM5oVTFqkLocAuZ7uKGTo5gnKYBVmCcRKoLJg9bKjSiqsjlIiM7UQ7R9glAJe8I61hwq3aEKJqEqLFomHXMUJBTBzAbBaMOzWLF6YPgjglNmq0WZVDFdmq2uYLWd9Tpmt2DBb6Xhma9rwSz+9jl/Cu7I9mqT8EoKpQ3Df8EzrPv6i+1iTlGeSj0UZKp/XDw/cNPzhA+5DTZIPb0Qw7UuTsMVbNvNMqlFmax5xo8xWgN0UmK3Gss6kRbRdCso7QlAWldnqcEB2ZxiT2dynRV3L3bk7zZhRG2W2ZhE5a27BW2YLXTk5Zgs5N2a2pk/IbOm4R3pG8iEPz5K3CmDca82Tyh0rJoDLNzlYAG7YdErbZIXbD5gXU2X7ipmR7VrK94jz7GEtdhlN4+/SnqVeUzSjRlE7SroWhHTNlNOM8+kVI8N6BY714seHPIZM3xtiv3zZhlWolpKmUSbMxmY0KUwYl7eG8mQ1qVtGTCej2Yxhy1lhxAK3pCmhmtfmUtcRLwkrUZsGzZqm+UvN3dP5pwiflTmwTzuwLw6DHVjLtWdqZgZ7ZuJHrwKDBbNWKtu1OEq+/BGqxUSDOmOolqqIH5dogWWpUiyoy1YAyNKUfEbV7Y2+47yh1A4NOw4NMyW6yoAKPnrojQPMJgeY6REGFPgI5suxUsCuRSlzE02fgAFdBDcxja3WSTCgzaDCgAbKgAaZopJlQJ1abJUBTYYZUBAew4AGyoACW2aAITMlhoBujYHBKAM6QymY8OmHMyeBLPhTqM0CZpYBnR3HgA7Nyir7GVTZz6DKfgaG/Uxo0szLk+VAFY4bc6Az9vrIbIUDDSocaEC00XRdBLe/aBBTp2MNqOsgPrvxdASoO7Sg09FsdmbHzbpM5unwrIsY3yaBbzLzfJ150fDM2xhzZqpcAs2PY6BjasoS4JY+nXLTZumLsfRxc5WXFgyY1w9mhPotbsRL85w2bSxyyqm4ciNWOpZmmaXRstJqV8763m5pFhy6Wrn9P58Zd/lOiScGyOpWsr7irZOsH/jlddyDE9VoknIPCNprF+u+eJ2869UK98VNCFrJuhHir/vwNvehJqkQv/wwFCJbSq9jKwrP61Y4nielRLtRis6bpWA9VTl8Sxf3dilmnygF851SHJ+VInp1zo3QVFVIPa1C6hn5VmXsM6xVj05UWRTKIDOmqecXteXyUrEPrfzlfYUgRj5FKXETlqlF89RGxiWRWaf8yhi3vC9vqch6BWUXvrCKEqzpxSO1KtZWnh8Xx5zY2hjzag+JrRssFM+7lNEUrmY2KQUtwrDpp05ibWXWvWGZ9ew4mbVdbaWcfNGJsDdzKSi22CL5xIBr1x4Q5BOuY1tdx1L0yF2J5HHZAgF2PNZUWi58TUYx/tRTMLPuk9L8rZRyn4nygv+2gWgsUE1trTTGFFbk2+BFnhhGKKZZ7vCmjGQbT5Vs1wy4p6xkO4dkO9drcW2VbAPyYnmDJqipgqtSRI1LslTKsvNt9tZeR8dokgrZ10+q/MRKmrYMC5o3ow5ZQnIjaK5VBc092sz/9VjQvNlcvK0KmnspEkXQHEG+79OMzgGMbzFRjnC+RcevIdOHYYuU2vPz1kMXKT8MOfIWcaX2sOXINWqNkSPH6+TIUwDCFCYdJKVpRXgHqg50AFXPONBSuUhNGLw0b8uEc9LjJhaUctJNLRVtahhyjchF62F/aiPpsdvOtFvq53i97Bh9kkYzqZgCeeA20VR1O6NDrduZtl2CE72LSXX88m5WCLvOd935Ga5R4pVr1GGPZdq6abropmlz3TRtUYxpOrkBrwQcPegZZN1vA1eb5xUE0jiJP5bB1KSZE7KkNkHmFkhmIgYHl6b1vK8ihAH9s5NSxQm1JdA9lKMSGcwQ0EEFUYbZYDieBk2VzFNupxScI1HNcU+5KXU98zRc1BRgP0UtncUTxoyKME76sh8vZF6u5nAmYeWuavZAKbbDFivn1HTwn3Dwb60nkyJ8aQro9LxgQlpSIRhKApsCsal1hIRasmkBTm+mRnmflabWC1w2VzENmA4Oqm1MiW8G22L4EL32p+TFo2k53VbykjryMj+evEw+dCHKw5CczKMHEw9bclKjyTGSkwnEjZAXvR86tDmbE/LSUfIyB9RXJqFGWTkUNScvseQlGSUvGSJ5AgHuHZo6GXlJu+WVBAY5NyYwk8clME5eggWopTqlLRIWoW3EJV1jPFClJfmk45sr0qMtQFiRmOjsg6yz6bYMW7Wh4xA/o3lsVGNjSXbhYRKgmCbxp9u1OWEfWqA9W2BbpGPuzndwy726WauJCKUgfmLzpW3P5YqOig90FGtOhNIoRSg5bauQEs2UgfuviFDa4CimoLKqAoA2NWEZRQiX8gyZTrNFmsOwOMJSc4SFwxPaWlooJSgazpAXqhnY9U1YCcqESlDmHPyzDeEPio/a1eQEuDXix5SDgBGeChJkY0iSClCqkUKLJg0tqlWokNKkYSKUrCNCHaWBSooaAF/Nga9BE9gTAHxzAN8cTbhDqY5DzDmHmLHSUpWhTBgZShU1FxxoJteBZlFRM1PSjL9SQufLHnC8DCXXLW5MHWzrJg1x5l3L+Ly621WpHEi3xc2pigylIMY2mqrIUHLLquhOuAJCECPgSmHwKBd8aQJHmiWOjO3/1Lr+N7n//+vh8wSTyhMozDKB2BSmZExwfYLZgIKxglN7/aTcZWQyCJPKZSSciWwGYRWfENTPHyUGALMVZLlpDxWQVuUCalUuYKPJqlxAiZjWdl1j7GTsjJmMc9Qwk7FpJl1ndNLFMksrkdTJa5h0wDWZeL5OvNrwxNsYa5pmyilZmnBLQ+ErOWnp/HJnBS1KsfbBlJfwpUJe9YgSE0zaMmVGpEFtJzDZzJXZRol62mYVmOjaBIFJGyQDzFiq7TDGwvyK5U5tW7ksLbgD/EUSvterrETUsWsaEM3tEoaO8yN3lJ2tG5c52oKZsNUsUvMPc0ZspQX86aE2lsyIMsyIOm1R1T2YapgEmcUWtqH8sc4I3yxTfmWZEi2LztAaxUwFNqu6OmF7Oro6DWtZYIR0O+SWJgPtObs0baksTX4F230UHGsLab7UstBwJnkXMBsWKHZkOq0MlBsGrNixEmkMniPSOjSTGw/Ngg4NINeiJv4UvIIkAOZxifQcpcDcjLveYTAsnIBIN3xHpJ1wQUFqibTTtKgS6XDddFukVIm0QjRXb1GAVtNBa1z/R4n0FmhZZA9745biT2HWAsSUSM9RaxyRLvwhpKyQab9Cpv0KmfaVTHdUx+KkaTQAeGIavUitKo32qzTaJ9oIa1P1UR8PE7kasNMIDSaUsqVK2TBaFCvtUMqWHoeyIVspw+ldtRFpUxJrpQq+9aO6Uqpr/6+Kn5bwXO3O+UFXDS7A443uL7rnywoUmTl3TsUX3Hb1tkEeYF1e58IlpWcWAQWD7C/k2hG0tKEl/+vX663j9P/xvDG+owLyrA9Z76kX1Hoc8tXZUyDXzWckhNPZDA0XK0vZp/VmrTNK8fe+F467rYr/yhuretVXr+1FbCVFk/QqXxFy7GUmLuIsL9Q7wQH8+qiBNzSVmyGO1tT1EXtQhLZ1iLkToG3Ec0c8tHgUqvebS3vGA3f2x3o5WuyGbFxLqLWgTXrhQH9wmbzw9kH/nOSLCPn0PoSaIsFwVu9Dexgx49sH8AwB50Qfzu9P9ifqvc9L0SC51oY03aOFVTNNnTT7pN5cf/bDuRr+qaGr4VqFuxmOl3UXw58otdjrUTqE+9gOzz7Odfxb26OX2fUWtw5Z9Ro3GmFucf+Q54+7k6DOF+UK/Vk1fuP5ZD1S5QCPHATobe8/HXNv4Y/aDZ/PVwI9Z3kZ/76ktOK1ErhJIDh/INDJ8Do8cWwh7StCYWjcWfKziviC2qskD2YY/Kwe8cggNyz+I3Sjj194jgleRJ7Zc3/M0/M+3LZPhItZAwq5G7AU6EWUmuYjvnF/wEwj3NZ8btGQVuy/8ew+pMS2mdrCxvnBQbQqpsbeP3vpn//z0S9/5IIrOfxT/o6dZ7yWnnLVC17AnMEFtTt5wHCxs0GNEcdJd31osCKV6L9ng93ibLfegn9/dvGAGlQBRA+m0u4wfd+uqBIau43LRVL2+12edoya76bw3YYK4AuBb3OJ6R5m2y6SYHY3BjIP7QVY+EouUkpfhtAOCV3764cG6O8VWlZTFp0m07/sVSB9OajX0LDUTzgsdzG460NjQi2KTM8/cPFgoEOS/Rkat4qOP1NlVAffU8qo7jCHZB8DKVGTZwckdfxN4/vvsNIsLcT6CnIFShG3b1RE0eZCbkYqCuHuarBqd2xNo4hz+h+TMKrTKlR4dofUjGmPsSVfO5H9OboJ9uR9eF0T/TUP+sMlNtzCMEEGyb9WtPga8V7BmU98oi/m0SZK/Mr2DADMwQolawMTt33P4MpcHA9ye364L92gUEfcp8gZe+tz1H6kDjD+CX5qL/uASb8QxuDO+p7FL/zNuQsXS9aDn77+AI+PQ21ywat6ZfzBPeSCV/Ye8GH+gbxLenKVt/Z9vewvdIkjnuz/mQJA7YewTMj98yqIL9HZu0cfu/WxS53D3QsEhDAUz6D/qkB95iC8m4P3aRAXZr+owXdh6TkmYb0d9hkN34H4uyWsV3E/qeFPIXxUw3+K8Mc1fBA13aXhOz2D46pCJ9MCBCBvaON0qT+AL3ZK8Jjc9XV1bS9bSWXTF10TuwjqZTvlFV6HojJXX+KaGkrw00rjGiWV+4zMeDDgaAIfWQZ6F5ETG8JngTggJ66pIwb08CwmwrogKK1eqgw5fFClmulOTzOJUzkll2aTCgDwhQr1rILm1LCdlvpUgOXcv4GDC8qFuJ9kr8fCltcU1NTI/uZGZYhufC0vexqb3Yo8SvmQ8iosiG+WOBOb/bXmYAi8QRfKfqYlW3J8YfapG9dl+VvP81+GVVvsGlCg17X98wJZu88LlIMIn3zxq4roFRS9FLoK/HrdK66FGUxEx6+g+KVqNvE/984LdpCUX/3Ao2DjD9TlPXL8UJsJFAUvzYOWzuSXFhwrKb0ne9fmQaoN3IV9vWQnfBC+FPOE4ai8x0sLTkO6fCRJ6S2e7/F9wzH+58ReJnlqO0U9W/IuTNdJsMBJ7m+Y6S9fXWYKqm7hArcOHjLBcM8AxkpdQuETv1/ZS//Ac5zufmYhYlNIPMQOxBuyAz/B607RKFeeeCxDEGP5wiPBjdp6H9hZx8viU3v6qbrgxU7AfRVpafiM10JCi8XstWfPjcLsg2rXkltuOfeXed6oUSxAzDCt2f9Wvgqm6f5Kg1isYXZPWd7wPB9WFNV7JU5pBP9KO1XH9BswwcA0HyYrKmaqLvE8NhFr2T2u7q/VwAGB+UAXsr9BRNvNDQp0UmB87aSgIP3z72BzsxJTmuasWODohyiiBzqEveTaYHWs+dk/9wPvusbLxtgDopoCvqaA905nAhngsbsQa7L/v96Ts+uwa7HGZX8IEU8OX6m5dhQhHsQNZIT6oV5RxySNOD1PZEnLroVPQykgIcmEMosmF8Z//78eZ+d8qDZvSrVqbBW7abV5yBnwAsOTP4yiuURq/lDeTiU5RnUNapZJ6Q/lLSS12UehOrYCN6DmHAMlbn72d8AIaX6uzQew8XkRjWvjD6uOTR5gEumL7xDwXMb/6n7G7oB0Z6rbmhFAp+lZ1c8EDcxeyNAbfFvTbzn3x8LQxx7E2UknR9MUX/UwBWu182eaB6hC9z6KwgkwN2AIaULLbooMA+UZ9u0fZBIJ0ZnhL/DsYnFDYJED2T8qj433jMILami6j2UdNuayf0KqKTKwuljZfS42+5J8H5m3L8tbYN6+Im+xHGaeqRywMIpOWWr/HQiGWJgu662V1nztFPn+PSv4Uvhj2KQYODKMV7tZWblwMJAI2X5oz3WFd23+qlKTQ5i3KyuYlcpkGDhwdIC9wpWFz7ivjIVvGIVdQiRSpzeFwagfouhwEZWGgEX9KiY0chWzRHTQZFBAEyJdGaOy/cIYmy5oDBe3ioXSK2UpaNHoxuzCwUr6Kz6MtWHYcSfBYl8A5JCNskMWwxfpRhmes71UeVihU6plN4QcApDsnwEteTfxxM+r8DEgDFMNiId0irzVwtv7wNu/9MdP/7HLLyYXvKq39zny73MXD8BLnbhdaIYp2m23Co+/HW7rDtTtWR3Dyj7FFcicna2pd0kuzpKf5PnD89TXeepn9+iniNNUO+HhZfawztsTmUk78lKYSfvsWDNpA8/zN7AFd7u/zmCb+uG+zS8CaR0WyxWfAufvVjMcqGZ43ZgMuzQ9yG59uYvcYeQ0Glklfg+Rir3y0TSEG5Bnj73VyEFQWsC911nAVRZynQXcd/pe/STtP4Y/Yc0/Io+Hitebjy0CyCOd6ViID8UIFT/rznjs54fsPbo7D9J4rAwR6nWVx1zwPsF9DImsSoHKC1EvDE/iixa+lFACzlG/FbvGoXodjxmqqERqUEjggbTs7509SeUXvaq08AuPQFr4xRFpYViVFoYnKS28+pFKC71haWFopYU3esw2VpdkkCtw9nd7+D1q7eVfvqektExAVaTubOmXgex+9Be1ii19f50tffLEmr6P/24dILM2/Nm+z0JFbsZO2DWTXTVJ94oIfFhM8cuIQ7sldC2CVEbuMJG+EeJlX9MVFcDWiH9Ri6LpBRtSsDteO56ClRP2V6oTdp20cwYzEAcPojytrIJhCHC7ZRzCKPsFw2qYWMsUZF+3NHSHlpBpCTMogdS8LfQ8SiHAzJIicIgChLv/1+GTBJxSBK67ju4KbpMJdfU+PGxokAx4Int3Vqv1DH22vq8CcwSDTN/KspP0RwPwd/61FXvttipDIGvGYif4jgBfc2kcPoTFj3kTcOSg7FIT6CC+MxWkHw9iz14WcBvjXfuKyBI/xfsidjI3teEKlFleW1HUQDuWi7pK4ei/r/hPvqqqhJCoix31NWK3ZLgOpcidlWyPtffXeH7RfDcOrrKXfkA2OVSHocPlfRLZ5ciU0gFvgFrUcs4TeiwthObuKsX8k/0bUMDOxeug20MRTBWmt5SRz2pXMyA5K1pDyYSKiKthfYhYj3Fi8B/YDGPrwlBNrHd/dWtTgYie2UUs47L2uoaEPBGsKsYi48HL9qX+21/H9ArxKuVRIGnST13v5Dwar2IeUEe7Xf2bOAzYGCHG0h1G2KF0niMOHIHTjAAMrhrrW/EQltXleALtt+Lizu0QBDiZgrCdKhe8ggMrnBohNfvt12r7DxzwlbjCouaNqDRGHAMKJyL8UsPrAykKquOwREtRcTdiQYXv9ynayIyir1bUX6w5rza21dEYD7bRhh1m7Pc0HcbSJP/l/CBIW+WxRx+79bGLHx/lPDvMk/STZ2oP5Yq2QZX/BdRikOrhh4lillWDK8x3Nvqein5VJL73E0+87jlvWfnaxXYPsmfPABoW2nllP7UaRQGN1u2Xt/eC1+36mzf8r6dcpAcuPvllzJXuBofuxRYowlp6G8B6W6BbMFOy2yvE2X0m+nWeUSQC63BFEeNxVVEXRSwQMw2BmPEj945L0FJL0FI1ckCB5JLJM0QOeYJXvo71a89+7VHdKPJg7mkBmIixUZaNYNaUZDSyv9VuUKQG0kzssTL2WCX2cxorgL1Tz7KR5cZAJoQmKBeNcCnXenM7DplS1kE1X2btzhZJ3oAxN15/9lxTNDUrNfv3BeB6HpAlGEpT0d5PfBz/vnjxgFM/hlSsVh84NBBK5nZnP/PpU+9Nz568aLCiclbkgI3U6MoeP+vZg4IJE9Bny74h4QhgRDpTp7WAmlz+GrryvgBUl9/uwqRiuGBSNZ982xeuP3LXq77+5m/gJCigCSZX+KlBkpgn+Nhf4szQhp3Is/7a/Ux9oHAmBX9TGj6ZfRM1a9HwhDWlh3GgI9NYo6dgCa+YUXctM0gInZ16RjHVltbtg6QW1ZgUVdA0TVBKaND7GHv3v4YTTPNQpVTYkYYXU8YTVaKdmUJPntoT33tAkwyeQzKqM8LhqiEHbhb52mT/uUti+aJOs9TCpjQ1xc8IAKjF8Ujp6TY+67cua6PTdwSsUyc3vtuYCPqRykSLDjA4EXazjUpEvBLTtLjamgKsJnGRk2MxblcWk1hFMIIciI0JFXMlMVHJX5v478oedfj18N7uWXt/8N/yBsrvLvM51td4dFYdJRFxQAcnl7cHMlum0etp8nDw4FF2GcpWNrfFj4nsesBVOtfmNGCVFBFC2j6HnqGvYFMH+bzqDJruZnqcYrubDXV35iF0l8fF+Gy0fY6A7tyQot7j/vtyMO2L+Idqyg0nfU83D3p7b4J8inU25F2ahCFEfxmXxTMGEmcWKPEHwDWeFmgj32zmtdVgME/3lwMOuMvpOxAnFr7FggXxrj0rkIAfQPRa6R+yKk7qHX4g6IcvwmZ1Gh6LqfrtiqRJ4xepe8gINr7Mq0SXNlGXuszZrMDJJ7Z5ZVeNsLlm+tU/+BKcaudhim9W0RUKIdCcy0Pn0TAa0Pzqmx+IkU3SM37wF0Yi8namQz6ua2znhSS7Ab3HukzUpDqiUXd2I6IJTify0ExepO3K61Kkv9NWV3fiAZnNQ5FSC5ShTbmJ3FDDy06c93FhHYmvyVvSt9RmEhibqPfP0LDU9fI1wRqRUB2POs9lgg/aFTVvos6Xm+r/Au8kjSDyqYPuvgL9YmLJAIDkBGmL+Onuw4ZQTGenOt09mgGGz8g9/DwTSyWYjnq1S5ha9NnQQTmgQdcT03UQHWD4tdZBNTdCgTNBdZyD1p28hXs80W8plurqg5jh11RfXynj0tDFBiTq2elbQufB4ogzhe4MmJMaMO/q24y+tdS+twz2q5QSyAu30NxgVhvBgndgEVFcjOEUMScU4hLuBkIkp78x3JI0YRk1QAfP0VPrXaoGs7Pcu12IkJpw1mmv12MS8T5Vl4UkO6AzMuDaOKeKEwKYbH41EiQeuC0VLKJR7/Lxe7sciWkzd+Z1FI8gq0FkKiuMRYutTmH2GhSEYuP+TSbqtYhK5RMttPtUFWaIeC7SU+xQusJjpe15nbRHhEKh+26f2QIgOhKgIgLNzvDT0lYKa6QAqjkAKeBQAyoMydeKXo+KXIJGvqGM7LrIN2pkxeXU23wvtvixy53KhRRAhhHiFC0pdciAEx7DFz+0jy/xZn96g5El9NFMOZXjZJz/rb62vAW1vYiNYAoNiauiRLmfX0lerCbrZrbeX5YJhDn9XAk1BEax4ofupUkNH3nUUCYSg4KV9xrrg8yDX+gXX7O07uA9VuPCQh4wK5lbaGATl731tTp4u0pnWBCJOz3CWin2U1VCNJWMGFCw1YM1Ke6Xym/XCSDFoExhfOAhO+solv5QRGYhBhC8jT6+Wj82UrEOAmiQSs9MTPYeMwJeRSLpGm+kkQwlQGpUGpn9Cj4vG/VQW5S9F5+fyGbw+147qkn3VS+EdAN/RqfTz96l2xy1HK4Hq5x5/KEqJi5nUra1Eg/C5c67/LEf45JXCJ4Gq526TQHCUANslQRXVvI6xUgrEzKbECsieoDQAE4IBodzHyeDHFrJ4aopFLd9SgFqVMfcYhwEQ/Y3UdDkM7v6eNVW7bP1UsFdh31VY/NIbX3JShmq6gRrdav1L3Ouq9Qmj1BnlB0Ujrk+vtjaQy32hSjWL4tNbKENLVTu7zbEU0XKopS8hUdStNXRplzyTZE9QuYOI4nbgrZpYrCKSyC35BNq/CyjRPk6CLHzKTzYU742Vg30iLW2IsCM56bB87B2HZ3SkEf8ufhHnKEpkpz5rOnvjNimLWKROgfitQLOJrE3NaucuPuk2SWnrQk5EImMxL2vyOYNDkKJT9pXxWehFJdQG8k67LoCCBw9ADGy9/9TgDgVFXU3Eg0zEgFGRUaigWwNzUaRMFbaQrQ+5AmZxwIv7W7/CvFMBI2UFh6qmI9dBLq5IhMZgaKtu/EE25yAHya1q6ktTZXCAy3TkTLyKSlPm5QXcSdAVE/fXPeSMU5f9aQ72+joACCwWBUrVkHmUEImVsioCy2BTAzIxCpiEJxX94N2yu/ds5r9Q8XP6+P2OD69ZMQLWYzgiRRVLIP/+7MDYDx0qXuaLnV79W2Pvu22zYxcM7mIRSWbIQdwJH3PwZcfUHEdFFdlAcx+yrAKH6stSb7sTYjQ1ZN0eYwN64ioS5h7VDsooXyPpoYiJJQXkpft+rKdhPnIlGMApspCbbwK7uLqdps6f1oakTCfUEQWeEiQY1qYY7wJGbKfkYnekFis/EPeZ9WpKMdmvygizaYc91pHuHrqU6SCpBSqd5wyBzVVbV1M0Icq1A+lfeZkir/4WceMZsI8lZiAPq+VI7qavdOMsI64rvlcwCGpUueeKwWLhbX4Ywieiu5ZVipndv2AkzFaS4z7cjQtBzYRD4S67AUqak7/6W1PjSHE8kGemGyUVL71W4qbyIibBp68cCiFcEz3GgoSfiifD9AwdDVG7fUjJjQx95s8CrBFHdOfU8QS1HKxN2usc5JKtXTNE8UR/KE/wxcpqoutEtPAOkWCEKVu5N2qMRBUslp/+uJDF8cSerDvPYfvBAqwhfOzcHk2YoUgYTZjPrP0L+IYlB7YSmJzG8YYGOCDd++6/i4jUg77d0MwJSDBnAwVI3EA9DH0Wq9PAMPUiVz6/ihu8MIbGOV961IjtG57gF66nYS50FD0rfVSM0XO3zPWMdzMomY+0fJT3QSZi8kpVouOrA4ZZUYckQndQtwkZdUNfyYX+DJs+FdhH6jfuSafFgA2AKvpfuepphovFUEJhTTlNu9ab0fh6bbwLfLcxr2OUZrAA0LKOsCUWPfSTSEzmqeoxqBPKdNG8qkh4MhukT2RhGnaLKmBrKcWfZqKPjCuaXDi6otKlRryzqpN9eBAnzrwW9wktkG363l5l2awPE3qAXUT6zKkfro+3QIQrqhEcRMfQ3WM7ID1wjNTMrEoZm4wYKgS57i743R4aFrXM5oHw1YsmJQZFrQvcKklsVgxwT3PZi/trPb98hdd+tzfOOXCJ8Fl+yQIyTQsJU7LdTtGgy4GuQtk1Ovl5AmMWkPDMmvGZCa7VcZgygz5P148ACVhPNaraczCwJBjnohYQCQCTmZwMCyPjdJfe0j3oI74zxu5CCWRobsJhc286Jl45HH4akQsneBu1CdueW9srkaB4XJXoz7OCRz3uY/fEriLUW9+jbsY9VAqdVelQOhuU+qV/TyeoxeaIJJQlZt1l5regvy19GlQIPDEwZau16FW50m4L50zXhZLXU7d1ViVLd+OSC19jxco3dj7X3/sT/+0+3cv/H9zZBs+19/71Qc/+eLPn/r1iyEvVc6XOVtUIhsasFFgsHVXVmPTvjBrxjtJJZ1y85ijfXSx3oFUQv1lY5b4JTOmW45IMDsBJwYd4hUXJO/ZbWnyC6rKQsMn9XpFG/xJHiKGF32wKT55HMK9BQxt4fd3Ef9d1lOGwAyLEGm9s3dIpQxO+ef5okOhdh4eDpwCMlvbQiim9JRDyUA1+6SnLvgQdY1+crz3y9Gt/vbn8QSCh7K//dLuZ7Q9oIiZaCSpiuP3C4572dfxJC/7V8HSdaj4b4qKN8BTYTB6xm6VbMdzxFgaIWrSs8dEXQ6GegCsXFdsEFu50bD0K1pX49dyg1pGuWH2eHpQgsxNOU4jKY0akJV24FwP+y/+2YmKEvYoxquayOJ0/651vxovKtJpqUOxUCeKIrrwrFolvgXaSKir3F0qvq0z3ersgCQSIcR1NXQO2Je6VKWsqla1s2ihqtQuA223DIxZc3ysOYN8glRmiXL3cJPah8SAkuoGyk71FhyurVAD750BNWWtmRheDLAUKE9ibTC2MFXVeX0Cap5UhwGr28j5fy39rOc1N9IxmxnWMdteuhgGDnJZFpFUIyZW/kv1DfJEiVfD6Z/he/E23MQRqaig/Q6XwzP1b7+0tugU0ASFc/BfET5siAuCuJS9Qj6rumSK5M7tsOL6eLfDF6reFkCBRvBBiBH8vABxRzqsViCqXqFMI0wtbLpgTOlhf6yG3tIbH2VlQvW1DXpXVSV84DXHVyV8ox/gYmg8ThrmbpcuceF8S4UOvE23FQJbpIRvK2KVttdFGGrF1jq2qBa54v72ZXE/KrLsKHvQSLK5IP5i8rhf3CRffMN8oRF5YzhjHsvXeVMLnNICm2LYscFff9N+7aL2gyqULLyuZZgED5FKb6ybNjiRbtrTuaJhpXp7tRr0eQVNNus84iHolES/wvP4ZNmC9J/86nphKbbzBZq91W1Ra6VoeHgPD9Y3wvYQitIQbsR6A8Hiw3C6pAJkD7ESkOXOkvngF/CBCDTBFWa/qK+g1DHBwbNu1DDLEzBoM8Q/2T6CmRA9KtHMZi3heaUGPZFN4mIZEzzCItQNvFIAfIeTdr2oF2df0o2rHNsiO4f4SSr8he927nFKkSMcr/3WTF/vyW4We+UsXnWz2BN4r5vFBx/1xmQs+kLImj+BrK1KV952ArpyDW8D+plImLzCh0DWQ91YaIAWwpX3H8uv/V251w9wYqVC9WeojqC62eQdB4eQmVOMWQte5nOPH8FyHoKv12g/fVsQJkZDcMwtId10A3IbMjCQEIZKrEOgo8+P7C/MsYAvEsQn38il7ZKSGAion7eeuWdEPb58QpFwLDFXJD2Kr7anLdlndBYZ/ejnF0jELis1Mvi+GGm008aoGCb2PF2BSXX9OI8U/dW2zHWgid6amPEI+N2/VN0wy9ET+K7UgnXNKAxs4u1lc7VoZTe/nhv1/t2YG9rl23VoqZW9YWwSgM7IKbUWMZpv3a9Gho/gxDo6VKdE509F3nqis5e3owp39vKo0uTffM0JaPKfBJA2vQTcrxPfLRXjrPzWxURWTHiqFxTo2Ic6gOBeH+jg9/5OkahESiSTov0U8RmcSE0gA1JZJFEE5iCGFSd8dmOmd8jE0VLbGB6HFhU/OtQUCVYswr0Xl2cCHfykFKuVlkwZwUht/U/gx0apx5YYIxRbAzSpaDOUhmgaiFSNc8O/FRG/1dE+lU9GcpLVsTxC3taxdEK2ScHPDihKCi3ffDJVfZspaoNtzTPszpYK2S4YHdNJOMDb+3j59xW+PzPQ9mZwxpNJJ0yM+CDiRtiYWGzyUqrqfAFGIzCjkd4W1UvFYX6G1wJc3TyxTS8aeG3q3sqyI3jDQBzrFCme93SKipHAIxeKrcryRqM4vZvY+49fOHL+tt+7YM/eX197fXzf3G4bOM8cJ3X64VN7xGzhU3srPJopRiBVy6w0URZWud6Vt0XuuL9DSRlZbh/Q2KxXMPfPoGxIribhDW5HbPs/Ztp/11D7D140tv2zv/S9f/2TM7Rn74+88Tf+ecePzNrA5MNoP1qI9m/Ubv6+0T/IchF1Zs8lF2kPsihBnFQkLayp6uUZNxTBI0GepegnwY4jHtPQ/sF+GyLFTOSK7sSEItXYtvgIrcPy5creyP2IOy4alMkqA1zhvdQKV8H7+ViYlXtVTAmcozae2YCzINDl0idoiglqKbxboWlKVllQR5OCb5wRo4TA3uf91jd+5SVfZp1avtP2Px7O9ZTPv8ZdT3HiJXc/BW/rLqg8jzkE3YZUVfIF+CJU2cfirufph+zMGuUblgFFVO36+Lrac6xecpZ7k4k+QjzQqseX12HC7AsobOwdGL1pttE1mM/6XjD+ZrbIzf9hLK8ZofxoiKGNHEMbjTK0Ll1SQTBOvgoFv2Fns390zKxPbMRaX5V2+o6Zxe4Vu0Om9o6RjTRjUDKyYHdUDBIiThVS8BB+TtT7RxhZbHb/Bc2iQI9DkF0Pcf1hRrZyAb3PQzV83+iw3b0rvnjZQNBNxld30HhYrY7k4dxfuuPkb7AFQzfY/A1usPnrb7DBps39wzfY3vGa6g02w3DHynBHYLnHXWPjE5d4n8iFY6FJOKOsXGMLj3eNLSbfXFXTqSK32RJ9hPoAJr3zNce7xvYuHY1f8vzQHoIpTimmxXJ6pU4nAjy4HWrbI1KmWi0nC4fQ+DH0ADBLLtVQi+q6YZKL49kv67zXCvCdjnUor2gzy88AgbAUSXdSeSlCa1nb3g+/BMdfu3W4eey++M/m+CtSThyLOhoqrdAOZO9B7UJfIodq6R6zT8a+N7tDxZiEospbqQJv5ewtuRM8khYm6YdPHte6pSTrnZ96x6dqY3ANeVRa5dDtHcjL+MOPMxy2/doQtrl9FMW6uxKU626Ecv3nPg/qHd9axFs7LuJ9AKmPvpxKPRPA9EN1P/nBE+wn//iUJjjzhet8vjUUvGTiuuAl0XWlO/ajzmmM9MY6dHndrzhTUmN4+IhH5AFjIQrhL1bCn3HWoqQU5SrzuK8oYeRdQNwuNP/EuHzCm9K+/yJ2FgKFG2ryqUSTqTyMkKoe2zX5BCXI0aQG8R9vBFrIAM6ttU8zZy7zJCVgwFuUIiFVOeqUve0tOkZ6N0Uaixa0Si8Sk0CaDD9NPXrt8yvkRvYAr12mpUhrI00VIVhyL0o+X0Wptsj+fkCBprjv+KlhImQf0gXSxRoHMP06N1e/ENUouIWWcxuRZ8NiNVSXpDvqW55BNAl94uWiKQzKDDdYLrSX3sptaTiZbsq3YZEhq9YpLlLay9hOcSyPB4MNVUFEji2sdTxjT0db2DipSFydfVb7gL5ZvYuGTD65YTJjfDDOyiESsGFOfMx4Yjk3wxhBix5XDeDGJqFsH+IWOEMPrpmCPTpg8jlhvMbjZAiz3Hii0YTxUD+YBtBFTZu5WX3pbUZr8y0O2ltLg58ZbaZUQY0PoOuuJA3T09imZkzNcIDED2AxS7EBYOTIcLrWljwTBDvsPdUEn6eWZGsRPKTCFc5WSq1CK2/iFlGyOilKqImfto4l3GeYTa04NM9JnrU8V4VNcSvhrP46FzUR5essp2J+SZ6IqJqEQbFWwY0z0gkUzR1gIKJVusEVpTZnpnSLu9KRQZuBcUYN6W7ikLs3kXPWRRbqc2d1yqHA4v0PTouDs6b2osXDPRGojpSQB/KXKVvC3l5Bg+bBEPa4wddeFfTgZz0idt9DEc0Z27FFjsicI7m38EZu47cjfrtmnrGRpyDyFMms0OGxmdQBAubB9RpxOqd8ThMRkxPK0hgCLDDgk+rpXjx0qIVczVl+S2RLs9+CqWRwTIide5n7Mea5uoaVuERd12rcPMRX89Z3oIoelIacCkti3hLAehqgK6EdLvL0MvIMF3lmGblThGX5Wdyas7m6x/CoPIbHbocSd8N51zGlduGRFI8V6xz5nJw0gCw9DoeSQgfzzegTXC/CDnk+RxxD4vbr8VJM01jrOQvkfRNrDNEmiCinpZuPy2Od/HQaw2WHMescYyQmgOGCvABYuOReVTjUEpwCJ14SZticR1U9WlhmoqT+pRCe5ajpJYS28AfBCxDayiFfQvMc8iSE22Bdscnepa2CmXlbXub1JZOXKX3pyMusvqS0mV+26IsvLzP6sijgUfrmo06geNGS+R3RonYVL0QpXiYJr1Tk1JKn4BOQaZKIIouyHUIhlFPEyFWcIsaOqYANcKLR+SPoW5yDnydI1hWvOJfz2qJb9ASSb08hif6sVpKZSvTz7eo1sDhFKtGKt0ncHVzsUGnbSDJtJ0Tb0to6v3LphHUfWuRa2jmII4k7wlVVSqtxqmSKaLsrTdCKSUqoxJGwYlEXE6VrXNDqFdXY+lze5GzJAysfz54eJnyv5qeKmOexih+dB8TczQ9eJM/nYi9g/Nxq8PN0ruQMg59bHyF+XqBYd0GJn1MctVvws8eh8yW0iUPnSWi6xNmkxNlGibNP5OZtEZzdQonFTLw0LGbi5Yn64uPFIvAibeaXnr505WWTvsTyMq0vM3ixM2C2gs3xCDbPVrG5ixe7js3gpS0v2xXpM4Pnpxg83wYMOIeQhxhLJ+V5LiIvtKiQmRlQPIlRK0fgIjsffEXVU2ibzAekIyCZtg/NDkXciM6lJ3BgdK4IIuLn+DNl+9BMSbX6c+jC6kyRjE+ii2TyjZsp+GLb6Ezp6Ew5xfTBzJTtOglIm29mCg3NFJ0ilBOdYKZswaTYYmfKVsyUrXQBIhnpMFOCFBMjYAfZeMC7wjRmBW71beJZMWNmxZlc4E4zK2Ye+qzIqrNik1JqrA46KxgdGaOVVm8S+q202pfQFGaAzhkj85+j2KJ2hheL2h152eIIdWyJuy8v8246xJaedyt43h3Bc7+K54tVPE8Fzy3ppkmD4hMVFLfDhcuxOSmqrSPriq/nIllw9E/f+6MXV/8w7ECM7XSOIPDF1b/iQk4UNNTqBGueQDZ2jBkGM20s1ij6n2LRf9sQwp6rpF3xdmihqJWTTtF/DMLe8bARNhYdf4uwM8CiGdqESPVt3PKBsOC+txof+PQ4kEWLXFsYEcM8x1NI0CwQZxF+5Q0J5pWcsQKhuCStcAPrC2L5djVvy0vXYtlmfoktluFl0WBZBX06I+iTVtEnE/QZJYaji75bQS0RU9KhozcMWY6OTg6y6m7UQnYLdoFbrL/9rRr5ODqLHv/8gn9wK+9lS+oZ4XH0eABpQYqay2u0C7uLXfRYfGQYzFREZHTqEj1GFxZdbdt8pXeZIdaW/TC1OU0cPoFX6hr98/Y4Px4qvZ0zW6kM6tyjmYqL5YQyoxbqLGoG0NjPF00zT3mq6RBQjvuPPmYwXhjrqaZDQMhLlmuSCc5TckKeQuafxD/Wy8Y25WCY8SGddkhTf9NkliqeOhcicC6S1I/GE+hJukPbo0XoC/EL59aXTEuQAcZYY55ejGJyLeZqTdfMu0b20bJpEhwQCuzedbMER6hRdTPt3MG0DRcl/pHdHjSwG3AONSseTCuXNNWjoPFf2tV9TSj7mi72NZgbj6Gz7R7obImDBMF4wniYlsne/ZqH6MdgV+Uo5pfw8bfAeUG/YiYwEZNSQpL8/rXY+Q/b5CMfopeKsUAfQtrn2hJwAoKHCJURDhHmrXEpzrSKi2TOQUKkiPlQ2KtWS1voO0pB0pAwOP1eyKUzey2D/IozCq0JBUhIhZvWfl1AQUUPO0z/JPLaFbGoO53yDfQFU3i8eQ2+4hojJzV3PqAFWN5Rxk0saWH2L6olq5e3unpRJNO3lr6FRmptBIS6BBj1WUpG7hnlnj3ncjeO1Mi3aNBkYg9HNZqdvfkVEzx7D986K3ysNQ1z8cfnu4N5E468QM4S6L60qM5XQRDRxka/76nGKvbOvuKwM3vFzYU4zdPzXVX4SCF25Fjq9K/7cVi8hdHjobtbwP6QSS7EQS8wDfFQg3oo0SMiCrJ3vgIpIq5DvDoXFPU+COmwK1U1Cc+e0daO2AATUa4ZBmns1WHrSaxhpBKCq9bGRQCYIM0XCW6GKiO5V4NGtnh8l0RTwlc4BGXdWn6i5e/3kQNHd0WG0iE2og63Q5aIDvnCD6DYlkqNtHKfA/6lPeArzHjldaPSi1RIi42WFEDmblbZi1qhXNTSRBvZJ6eaM8s/7qiGrYvK7N48Lra/WyiG0pcxdspxKCo2s38VNKeqcvuDG5oFXXRWQe93VkGzis3PGWfyc9iQZ6tG2qSHTVh/fYSwdqtH6t2RE/U940w+FvzZ1UxOlx623Uc9eqoSWrTEENq3n/xZlj90bhpucG7qrT83hWmGB4bPTf/lhupJlp7fyOlV+G2y+3n/Dcc7t/ocUlmzOXgoN5FaYy4itYbuIUHo+0K9ENS6mt9OdAfp03ws6I29hPQppFCo54buGtJHqteQNq7z5L019V/4PIjlH32fTXeOveKEurIPv2b0htMRPUh85qgtYb8PMqm8QskoQNNQR7o618Ew5IH5goKKoeGHN90/OjLdW5Xpjpfj8FG/8fD5KMWL4endstP7WVVjHo8EREVogCQ+CHK/5LP61UF4iJyaQvttvh8MWeAMRi3xBxvo2AaZWvDxs99TCFpWTm1oSGsgcf+kXAPCfAn1bqSzcuXz2yqv1InaLiC7ZpMnS6uWH2S/j/JJk7KP40X14WbW2YKuGR9L5h5n5UpQAVu4ndJoLl6KWA0Z1nHxBM49u2KKhdsfWT93u4YXU3ft1y2mI7EAo0GbJ4xfTGUlFWUrrI13rV9RN9Z4/bsTaLxi3XS1/0B5nyUprJrP2t6fesob786vT0pzBMfuJA+D4HTtMByAZBmT/QloMEMu/dsT3Uv4g2/9vQRU8hDvJfzh8L2EoyP3EvZn2IGOvYNwpPYw7yB8dtwdBFSF3eZ3zF2ET2x8F+Hbp9r1R9+hql1/fFwNmz/RhfG9auPA21i968zgxOpdRzqlfldN9O7VtEsdcVa/69OPnn4Xri/1j2RYfg4ZHa+v3r9Ox4sTh5S8OJTdfWIlrz99GEpeD4sH+OQjkaV86tGSpXxXlvILvl+5tkPj7L1pSeAGRhaZLtUkIftLVVOF6OVIB72A8ya1nXiXvGOSZJ/GV7iNBD7lbo6veJBlt2lHOxUD5n0SOaNXqoCsGEbk6xcPKjaTI70pkwe2Eor0Ws3A1BZJAteGrq9QtOo+Xjkf0Z5bTHPPXUes7s59ZSi+up6hyMfF6sw0utWM3hkyVeOeJdOI7Zar+zTnigIT8K8UaF15OaYvRGLwEg6qhKbh1cPr39jX/SFe/9a8pr/oBerwx8HT73vODItaKRRZzghQn7tn1QLwHpQnAAzWxuVT0BexcULDKvWQu1TAGZqrRP2PyizBSKy4zw+lj+E+l23S8apEaP0VVid90DOW6AO5UGI2TpVO6kUYS3Sk9qFeczpWU/RHow6yZlGkrRyKi6sfOTkfpq43xprrnXAvebhorGSfFZg1KSSQfhsBq1xQOoTRBaqzry3Aps6o5mRISsusCEm2rmzqRv2sKPDSg36si9UGV+36Mg10K4AppvS6H/W5vOyTIkkIzw8uL28RQzd+jOW8qrm8eiVerSjicEUsilGgsnnGPDHPA00/LJx6Pw2OGiyglH/VEAPqFpjJp3rlmhnFlXsrsS4I8Qo3FXAY9lYzfJ/tTQ8PIkk/qUJkv/8IQRIAJJGApL4xSOqPHCRo64lg8nN+5GByshBJ+9kQRNKHCZHQQCQEROqAiIqoDURg2NACJOw3NwRIDICEwwAJK3ezsBnkRorFFHBXAEx6IsB8YxxVPMLwKEmMNN8HrN1NTXCDh7PPGe4t0tDKGEqHhSOQiYrGJcZg2FoRDvCerRbDvrdsFQ3bcboclVU9joGurkrU4SIaVDZ9hzh+gDV54ApZX1yNi1tdweAqYV1NL/e8atf9PZXVl7wVbe5qwWGuzxvxQ6NrvvYFUg1f1NPh9NAzPfUdYRyIN3gBBEJcYFgWCCvdrl2dtAKTah/5jVvxQ/LvUxeTC14pfuINVAePgljlDs/3GS2oJndGfTz5BqkvmySxE4s/VijnKmDEFQPtwyyk2nEX42QYi6ox0RgtYkUq/t6/rG2ONrxKOpSb3LU9sfbjmYIYnRn7+V2+EW0UFPN0veBLMS+cpygvC1tLFVZW76KV2wIMuEJG3cvYyUlh9kVr9dcXK2p4gokEVJQxMH7FPEnxNMW5JHP8Mdj5E7kkU874c77nvUw3l3SuTwjxUXGG82cNq7VuhMXayw6ExNrLdg3thIEbCe2ClUKhYTv0sV0fO/FAmqe7H/way95wCbPfzwPdWL/OB1N9nr+fn/jigK8FH+SWHtQw54GbMwlzOvKgdKTjiTR9Iv50/yYpe+we6K1aGWfRym/jJz55l38e/0mY42z8Ds5/Lv9p+HYO3+6DUEteX7/Xit+qT6R74HDXfNgpT2+Dj1i3lw11LxthrAKze9YbS6GyShTIWOJWnJh4lGSKEYpIBP/ZfdWta1BuXQO86uYFW1f+r7p1DYxt0jFXk/ZPuq1r2D/49XXW+TBsaIU2OPtyuWsNN9q1fulh7Fr/zzv19sXJ7HiXWmjDsMDwne/Av7+3jsbuvRjSmktx0Jqh6I12c0FlNyeWnjw177nAn39GXv/4Bn0VF/MZ+eP9y3cAW/CKNRWa3wibDfy8ny37gYceMtAM8uFWAZ/qbvllclckZgWDqFMlSjDaqT2nRLcJSAurafXK6lyvWJmhYGRfpxhY3deNi1W0NXu4xx7n5BX4m31tvaD4rZ7njT97BWyqfIvGAlJjYr84NvZYJfb+MvaoixXroBr7sdG8rpVZjVxHH/Z57vWvXS/c2V494Nk+csCz74Q3pH/kefJZkL38tY/wfnRVkHTDax+GIOnt3w4p61teOypl1cnwbToIPvTa44lXV9TW+xsunICzsSnei7Tk+mD0kpTfPb5C6Jf7tSLKYwgsW+IYqa5l6CXCI8e/RAgnXXdIlhohvFIJH9QwziWklBQeNFh7nV6QN1yw6YLIcDSB6rDYysrb/DT2XQGYbj6BB6ndjZ15hmzRErLgPBhvoX1DGzKsqMUkdfYJAtCkuaA4ta+YpmkMteyQ8hmK7J3DWZpEjog6xH+s3jKNDHOw/7lPM8+7zF2axAXFaZpCwibKwLzmC9YIdl/6z/6WaFospgE/u8CFefxMYdTmlvr8au4lziJ6pkzbhLQZpHFRLSCw3ku8HaXaIgkujOwG7g7elvW4oA7KqPdXGqzuDKDwc7MFMut9cvvmaILCpWIr7iRS38tz6L+iEwUtcIANrmxayrfRJM3tQ+x2/uSUYI92TEuiiDs2Hh/CjKYIT2cYRvhQq89iLvufKhf76VS5wHca1KeEF5qjU80FyUjcRemtPTErTyTbiWmaw5U9ftgre12aQvIcNHBnJM8sLu3olb1Zymlask1zGGZc52Xm4SejrcsYBGyTTxENyK7MY5SXkBQFoYIYo5+BkjgLCrN8hzxr+ekKCjFHM4URp4h5aNQ4tfRgU+wln/7gl70H7/MMMLIlIJ7kSWhHNUmN0kyBT5zqE6BF/3/2riO8bSQ6x44pUV4utSIKQYrlDSiKnZR7kdcWvX1Tj7kfZaf5yyVd6Tn6lp7olt57b76ll1t67733zP/mDTAwIYuWt1tbhHlDYEDM/P+U9+NxAuQFFDETIvKBYZ+qb7hRm700ci/Uj1qHNjLEONDJRu4NX6CuidwTUCqfhv/jqxGaVJ6ionHg6adgFFONn0CNYX7pS9ackA9oxvu8ywB1H8TBfAXOhbiKmJwRVfBwcZ8aVDCbU7A90M+Jp4WHFWe1SD6YUtMmZ//zD3LOnqE1BSgXMDOl0iQPbtTX1+k//3aGijRFeqrT+n7aRJE0Mx8NkB7wR/gvLqa1b/oNANo2YJHG6ceoW+CIn3xrn6o4b0RTmiVPtUfI6eMmkgMhQxXI0x0ng8cjhC4HaNfuvPSW/qiLgNwuFZCl4IZUFKJRQxuceQ59yw5tOpOoIdeMAM58bW6yVQ24OMDYPUx/FCiYvwTbs7YHn49HBRwANQLUzI8EAQGrHDPYNWBAMpYk4LdFq+rC/AwCAtUlfcNLBkx908WrAlDy2+vqsokh5d8NuqKP+N2gq7yMUdeASp3z1+vqOt5x4F5M3dBlViRi9Ia6ps+7QVcwAt7kkioSVXgZfTIhqrCM7ijQh7XPUopuUJno/vxAv3Komvqr9XQhLbqmtum6aiT9VUwaTA0CkgBibvIu8kA3yRF2FuY7dvMn83ZpiVqqygGP26qmS/wCpSmoKhQqj2oo3Wxfxd1BnypJGoN1Bal4QB4fp0ALCGB0QQDXZlCgyYNcgXA8462zfrUYjzSaaLCIe0Z9PMafiTl3Nd41kBWSTYivnRFn/4Nku3fiIvp89e8X4xnfydx+ZDJX40mmyBHxSX2aHFXklJnFV/99Me6bIsfIHJjM1XiaKXJAOAlXOkVWgL4KeTh4aBfg1YcLxp/D14KQWUQzVynkY0g1PtbsS+1liXKgAFEOTRyatE1qXwOjMd/BqNjDmT2ibLzgzTRekCG3gXhBxtotxtrG/VjTR48HpE1AMfZ13j4jsWBgiPDzdQ3DjoZhXcOwl4Vh72Qw3CZSNVIajm3VoI5qUl21AEc8vKpQSXnUUIEGakQt3C0DxciBaJCkBw50p1QwY1o8E9iO0Gpjwe6EAj7uIvPlLJD7VETubZrSAIk7Kaz9/bhqzwGuijShXSQAfQvcIoALoI4Y+YLBRcgzivBnagE/cqBUpSkjXXBvoVRNv8NtuqNz5erfF2qN6WUmUh7gqzQ2HJrSJL9I4VAW8DMeBfIBX10G8AEOAUU4RBb+IeAfCvxTuONYogYfG9TkY5NafGzRNkC+belA5AO4CgdFbRza1MGhQ3W6ta/h2gM5erSO69Zpw4YIXkaI4B4Ob6ELBtCVoms6VcQArdpIgw2Esm4Q0Z5mQh2k4NS6RvBcc2JDc+LWyTlBj3NiQ4WaDzXNhRJ1VIPWVZNuCS+qFKpCDjd8DNZHcMNzuOFTwXTb5AkvIocXtkF9wcGADKQl37AswTfAzZj+to//lD//nB/6qzv2iF4X3W0Rcxs7W7NHTTSGSFzkog0Sx2RzpzmjwoABSSg1odnA0oVz7fejXRoYusxcIMrjjATWhil84jQzXmRhXcHUZxHWAt0noVtC/KpAd1XQLZ36CVG+QYSfpWiTAi7rsOrUgdWhdVjrdAvWLQ12AtjnuHxOeza88DJWCh0NMYa3Ug62m4ztzn2zhmprRG9rRPfMZEOASQ0N26Ia4IiOlecQ2wivVlUNv5B6Zh6Bh1cFZy4RYC7hzh/cTlvAOBMwjlycSRfstuAg6U6l6aT/zbTZlGTMLy7bZmilSFrJ59r3lxyKt4kw+DZJccvBalEPVo8aKL1BbVzQpo654DpdppufFus/NhgRi7PrdJPK91WZp7/XVIGuIBjxCl3FRXYOyn7vojI/Hodp8hGr1O+B2ovEoU08tImDFR7/VQ+zOLpEOw/uawiYZm/wTOEyBGcyXurm66Y/0g14jbb5xNB8GSPUo7usUQFoKhP7EEqy5Ir0ZWj30Kx1KrqXs61PZb1WlOYvUE3PfbSxpwbaKGmusDGFvwopBgaOIzOaVWXU9vnIQy7GOTy0ZjXAgZ5hZodsXIXHx2cY0zCcY6hGYmI+O8BnYzJjvx7WbCmwfhWWvsBYPwPLjoxHjuY8HY5xEhoguTGs3+dfSl/RYwA/9DndG3N7R8arYtYq+NDDh7E4GrBMYbxyZp8zp87icMoUoCLSWAbq/9TAkCxdDUlspE8DXG87qUBDXhX04SxYwAs2zCq34TYwroFq0p5nVGg8JKuaOMZpwEvsiB0EHg9tCIWyVFUVACMZ3fQtUQx56Js8WfNLjOUWVY2HAsXiFitm8Rcl/gdP1woVpHh5NPEpHFt86ttZNb4dAWJASL3EL68HVEQnYe6df9Iny0l7FBg5xTOVlPUEUYh1sfYQqCo7o15QkalX6cstse7FDe5sELSPy/UWvy8wyxr5LCtlWFYDu2zLLMOyksuy2nPHMoukDxTLGsIywnjRuEdNtudkeBBK82okq1qGeFUhnr8k8WTnaGFGFTisJsQLmXg+inWI5y9PvPziT048LznJWyCeLSByCoikAM9+5lwXyXVRSti4wi1ClUXm1ixzQ/6RkDU4z5mieKSG8JbJ+gmJa7JgPushMMCDV2u7dMrj54rHoC5jQ9h7OmweM2xWlhk2z6soQ74en1RhhnFtq+YL1DTi5xmwUG/E2kCvmkxmm/qOPJcx8+uSyBwl8tELFHgiT4V7mHFzC5WlKwyoRqF2WuP1U9hV+HGpJh5smxtJ7QQQAx6As94+Rdpgv76p8LN7RvIK0MZV8kw2HgPPqn3W4uz2+PmlTUULacAwD9icF9m4MI80OOS+FaEGbjj/jM9k0QLf7EECJTJIQg1JARdNFRfVJV3IRXpRXTBVfM44nqFCauVMV7EV3XZ+5lDdTV+kGBrXPN+fha6Ir0F90Dn8lXtD0ISWhcMWy5n4Q+YtIrpLw8M06M/joD8qmF0K1aZ5LYkC8Jo2nU0Nhq5WIBC22FmR1wv+end5Pfjg/KIe/M/H68F/7GjAv+mkH6V68D9bPfgAYoPRgyV5Pk0mJ3xkJOFH74ok/NvLSsK/XzSSMHrdJirnHZOED04lYSsJH3zYJOFHeZLwwXMuCZ9KwgepJCydcGySmrxPkIQfnVQS/u0PiyQsrtwjJeFKrqZQxIghknDlhJLww6eQhB8+kyR8mCcJHz6TJPw9eZLw97yXkrBowaIMfzAl4VNJ+OEJJeGHzyQJH+ZJwofPJAl/T54k/D3PuSR8Kgk//GBIwg9PKgkf5knCh8+ZJHwqCZ9KwivvsCSMJVeQbk7wHknCcE/nO7nhrM53clvXderk/p60FFRbxsl98PRO7t9Pb4zmyJGED77Q+haxaPnSM/tmxQLTA+DE3a3OcAR4BVmkzY8R80vZAf5Qzus75+kP+nLeUj5xuDNcPzgWXaCG8YODISrKqMYrjmp8kLq/YT3B/S0/PGh9lkC5Zqa4p8/hHqBmnvf77BLebyndOh1QeuXY0q17N6n5ZJuvwNwqzaJUD+bHNwM4OrT3Vg+OLM0sxZbXkU4p9iGhWEMolkrGsAFfKxkfpJIxrEXJeBnW+eCFD17kKsZn8xXjZVmXW3o+6+JKDu8AY2FeROkJEbn5lpGu4OtS890SfE+JekrUVBMWej7Hg2JlmUHx5GrvyqLae/YxtXflKLX3bFbthZ2j9p5dVHvPJmrvWZTNdbmo9nL2qdr7rqm9/2mif4v6/xf0z3WVtMqrf2bxc9f1cUX/n1V71xbV3m/5/mPV3q/+/lTh/Uon/e+p2otSrKQgaq9Nnk+TcsLTqb05X2oDHTl+uQiJ37eJX7WJn7GJ77GJQ5t4aBMH5xKtuJJoxRXRirXs65MvWvEKcJLIvyFVsloxmAVxkfx75uQoPblmyOuThw/qohVvJloxVyDkQT/Z1rQG8rBg7EF6qkIPjkQrDplYyWd1fBYsasUP0Ra2yPnXw2INlhXYdFtTVoNVw4jJqqnLT04yv2TSAEXqpgB0Phi0zZYtqspsCK1iW1I+C6vSj5Tuo2Ng8bb6+C6ntjTs98PXnosjguhr7ulTnYL76HF1Lu9y6vOtPLvLKUYAVbC6lo9fGvIxK5Guyn2GZJdTagqPDvTPfLUcrVyPO215J4kMNME7pZ8THWCs71xFw3Vok18xiusQxSpUvYfcrj5lW5+aOjbTIZkh9hLheJwi3jeKeJ8V8UFa28NEHK9S3xXHPVccb8gupxCJoY/rg+jjqGBuAfTOAZ8TonWMPh5STD6f5uu0r/XxiIZUtrucdvaph5LhwoAo7uFPkOxyGspb7TXe5XTER8jGqAAjVHqOMh6SZ7Y5hcKKDWtSZRw0E/F1lPmIuJExHnsyHof69NTVZHc2ijLK+CBVxqvYPxLKeBMa5FZGGccw2jNiplAQnmJsczrBV5fH8GV+wqTVZOPCjDIu1pQCqSzP6N5xjSbmgeIRta3IPXZ2IcUJKlG/iWxyJ92XFIA8hyLxXgP1eJwtpO8QTPX3zNXER7oI/eevWARHesa7o8JE6bRjPhojPU42To2Ltt7zNXFUS3oGKhbw4efu7pMPkMQFeJRpx9kwFTkjGmc3TPXsfAfdSMmuMrbtAN2DO83kxZDGY1kTZaTxC9RyxsQm15UgTqRxH0RE3xJCGm/yHO/HoYUDQcjwbYaswNIuhYC2VBxf4YHqYjpmXUpzL6e5V9Lcq2nuNUkCrdu0qvXvM2YvSv31blohncGnCmYcUrtWSH+0Ht/CUf8g+8tGSFcipP/quroNIZ27eNVHper/u7rMvlL6vD7dQt9xh0vyREjfxYC1CSF9U49vLMxs0W1Vktn2ReXRJa42n0po/DDZ7A8t5uz9Z+fCOPj29Uy7I2YXt9qiLnb522LMIk06a30fqQGmbQ+QamDGyKkh5mqcivVX6eivoKiTru5hDI0RsREbo8oGGaNOfW0MjFFmo22MHqpHuuaynaXGPvdVRSNAhWyMqE5MXpgUj8nn48zuwlajERWNATkPhdCYitjLa8cKLRMNdBotEpOpGO/hz9ycuxLfdXZ482lOfO0O3XV2eIvkLubymRVgdvgu5tYTk7kSzzPFTYhPmtHcKS4wpMaXBuWtTDk2xe0hc2QyV+KZU1wBLNY2uhSnOCBLafYI8TAAUwdk7VDXkLWEeXuJtpC5RZtZxf1OqrgzNl+B4v4KsPmqPugx/zVd7Osaog2B6GXl0RWBaOMZIfq6Ad7rCURjnfUqQ3RLp17j1KZOvcKp9QS2lQS2bySwfVN/vQHDdkAVC04Yb1hwwnjTghNGLOCEfEZbxuiwsWmMEhvrxmjDsCQgB9ClBUCTC+gODDsst2EEbMwM7iOB+o5AfQIE7FHAxpxqfLyLzLcsFCIhQfw2zWiMxMdZSpQNWHdowpTA50jwSTOXIBa6RbpL8yN3bR3hz5PJMsuQpW7uv0dvZcjCZ75NH8cEzCfLHk0WyVI1ZNmRp7BkmRkejMwDCFlGLlmEJXiF4BiyDMCLgSVLA2Rp0OvI1LizCvwuFPh1HKDAr4MYWAlvamK0hRhXdYHXhBjtpyfGSy4xNk1/jTHCEEMjUoPa9Nib0osPATtOxSCBoQ3kTiZByaI7gmHRXWVjkHbXJWoII2BYdPfYIGGEA/XOAtTLLtR7LtQZCoHtwKkmKA8dlNvmCjAZIgO2bOduIXsXn+du3Ip2BzRmtJezcetb+kNGIt/PwGZONre4iHqhjsBGGLBjGTDJQPYu9++C3MxwUUiIJwzIgezhiSEr2q5Atg0cte2m3OtWR9/FiqJhXtUguo2+0cJrwDu3jnHkfogAnR6RhrWBW4eIGgyoUtK/ts0iiBSV7agesNGxOOtro2RxBqMnOHMAVF0AUN0FUMQAWuwRFwf/dBy1HRn3HtJ82ZrV2cXlalYWL1KzA6xsB0TIJGqYzNu0S3c+LdZ/3J1bb9MdVFKXi1KqQLewYLpFL+MiO6nMKuOe9YwUJHFY4DFYERbZdJMuiOqNmu/xaL0L1btvZICSUb1lpiZNgBuJpx/bwaK24Tgg9oaUIcJIO4irEOt+aYcC1W2jjLRRNY1Camz8/wEbM3j5s41junQe0uI5hXy8i0yMAHAOQdRHq4BHdryamM9+FZ+BFDyWzYmHubn57Gfw2R5h0EMlpaXYFwX0BcY6gGWpJfO0RWKbLmBkCv/99MbyAgL7C7x9VqwOC0jGATv8x1JjIXsTxO0J/DohXuz35w6dM0ecOUuXgQAg0kWkseDT/6nxY/FGAY1xndGAPMFlzXhn21SyPAtFr8G6WJ8K/w9/KSOABTIa1YwERngS8axLQFXGb1/ThqrJUCQLeXEEb1MEZKcBgQWzoKsZvnDp3oLfXvwEx5Vu69RWZ+q3D82t0iyi0PjtffP4j/ntq9ZvH7Ge8QLcJM4c2JLlXtxjMbtHJeqnYraiXj5zyhnmVPF9wZ5lmFN2mVN9/5lzypyeMEcbRL17VBIRzIC7KmTS+FT1DJkiIVOwHJkCwD2wcI8AwMiSSUSwAKU6ZAqWJ1N+6blkir1FOglCZRxNT6iRk58SLfbA3JC8RcbVXaWsTmsSeCqvdAvfqL+oUfeIoFH7cB5R6ZR/zwn/QDlXen6OhzBvmSHsvKplCEV8ksesMdJzSZYAqfTcQT9nJ4tYAcImMnPTnkgEPQpEeq5Tz0rPqPuy9E4h1anqSM8Re4rr4vy1ubUUViI9+/tUW5CeWRwD9Cgi30rPdtJddCfd8qqN1RE6zpb5ohxfx6rcLiE8wTluKNKzu2d+ihJXe75hXds3dSk3tPZ83dGewyO051aqPTfxdZfXnv187blFTUd79rPa81S05xAUpqmjPTczfnbobbH3uPb87bsv2kjjF7/wnNadP1brzmdYd14izvi3j1eef9FRm3/CSX8H0qw8m1LSMOLj4owfvKdxxivHxRmvpHHGSOfHGa/kxRmjCiTOGNrqOxRn/AilcpFPjDMW6Zh1zKbRMVsQMJ3eoS3fmIxkppQEJ8cSnNxJg5O3oAiJjhHiabclIBndRo8DkpHbN3LZeQ7VUJK0Oumzhyk3qWVWtzUJSW5RLT8kmVXXk0Uld58QldxIopLLS0cljyQqeXx8VPL46Kjk0bNEJddg1aidE5U8gWzVy2qvEzg8RP9iDGs+9Flopm34cCY6QnmKp5AngsAVsBOngujj8gNEI3wmVy9oN6UtqkB9rchkgjokybEJzLWvxW1Rwb4SR4QLPRFhY3vBDuogveBcegHTH6PKY9HJwzyUZUKQR0iPkujkMcyx+WgH6Z2lo5MHi9HJNZI6GCHg8okPO8Pt8p/OqLMVCqw6G9AahjLjm+K45TJmJGWT1YU4282LW76QiVueHBu3PMnELcN+urjli2mvfynNvZzmXklzr6a515wY53q+NAtoLinNth+TZrkHVQ2JcUZ8SEO19XkNV5qtuNLsBqRZDB+KOI70tuok0myFLnGleUbRCRJ/Pporde8vhM9mdK9t3GqdtqFwrfOMCekWh0Yh1WWNC6k+a1xINdGNI8UzuZgndzH1zaLWZ6NpjCqMdLkLo2WMGjW00TVGGYaVBNZQPQvSrCdrq7VUrxpRzehVgUizXlaajVzvrKw5stJsMZ4+UZod4M/Quvz3HBeuR0OaGml273F5yHtMmi1mpNmpdcAPM8VNrTQ7dIrz86TZopVmB440u7qMNFuR5ZD7mmUMqsa0bajawby2k8Z7PlGanUOanQObWrGDAvWKLvZVDdF+Is1W6IpAtP+MEH3VAO/VBKI9nXWXIbquU69wakOn5pyiBLYqge1rCWxf558vAWy7pCw4YbxmwQnjdQtOGD0BJzW0IQJszMaG1WlhkDG2YFgStBxAdxYA3XIBHTOgRa/aokSVmBncVwXqOwL1KRAwEPfBkCI+smL/hoVC1Uqzb1qHwVsZadajHZrmS7NCEFea3aPhk6TZ48gyc8li2OtBEM+Qhc980+i1g3yyDGi6SJYwT5ot5kmzq8voXHlk6YIXXUuWPsjSp1eRqXGXkWbJSrMEYihdxIYmxpaVZhGtKMTYenpivOQSY8P01xgjDDE0IkkxCfo6RZxqAnac6oEEhjYi1rSpY9FdhWHRHbLRTbvrDvUtI2A0LSNgtIQRDtTjBaiXXaivuVBnKPi2A6dIUB44KE9UzlSaHWY7dwvZvSWk2UGONPuGK80ODGyG9MYTpdnpUdIsAqJdyO5x/w7kusNFnjSbB9nDE0NWZAeB7BZwtEUbyNwgykizfSPNtug2+kYLr65Is12RZluAzhq1WJpFOtZZfQZUJ+lft0SabVPZjuo+G7HFWSPVaUM21gRnDoDCBQDVXABVGUALPWLe4O8fJc1Ol5Rm82pWpFmp2S5mo11qIVNXyDHSLCppm4tqLyXNLhe0zGJtCyHKjliLtlhLxVqJ2eqY5azM3aRRHnN5hxKPlYq1UVY0r7gu75ptppE2QjSTI9b6Cy5vaS7TyfMgFw/F9b2HTIwJNiQL7eS6vHFVGpI1MqPbkPaQwPgkIVkYWcTlnZZiQ7L0BcY6WH16l3dy4zQkq4gADXbqHkp0luvyluAs5y3w1OUtEVnes7m8fXF5R0BqRZAaUcVEPHUofm8jj+sfysjjEvwqzqzYkuVevMZi7Rp1qJGKtW1ay2dOOcOcUMSiaBnmlF3mhO8/c06ZsybM0UaL1u5R5z0PKK5/dAOKz9tX/dfwldaEb9RYFGvXqJUEFLdKp/x7TvgHyrli7XM8hFWW//GMlFCtNE64ZcTajiwKUjkmRj9nJ4tYE8KmlpmtrommsObECa99cOOEYxiy6nHF2jROGDg/WqwVlCwh1h4XKPx2KtZO3pFA4bdpcpJA4UnG754fKPz/7H0FeBtJ0rYGNBpJtjVODEq82a2ZW7ADtoN22HKSTWyHc174/4/5k48Z7NjHOWYmr/PcLdPzHSxv9piZmZlx6aDe6m5pZCvkOIvKrtzT1T3d1dXV1e/UQIWQuVX4yPd/28tGNphArGouRthoFTc9u8uyVLR2W6K1hy4PBfG/3eC5Eg/aKZxdDDnLCWKso3WpYQXPk3ILBZYqyGbX6djvOmIzmkTkagTE5zbtwj8UI1ufaJMl50A4COf+WitxlDj/vgrlH/TYAYKjI7GQcH2E6SeVy6taoOsY0DpCtYRjrlNHhOpSL48zbNWMjWZ8ldSphFRZPvsPRw0unkf8eK7txuOF1zHRV4GlX/8iTSwFBX/+iyuDgmtx6SDZ+GOrSNl28AJUVQWqVCRajp6dLcQk7YqkcW3PjY8WUV8Fug/ehAnPko1XZssCB0tu9h7bsmNDS+mhSf9QAISpDl4ci+Ndrw/cyEfrvmndWpZIhswb7swnuYqPGx3gJ7geX66uLJdSsDGLjnCLLFeMnfQSrYLwnlEieKnK4s60T0l1JcxskA9l9LDq+E/7CCWKWBfgVFX2lJ7yJHYPoD9Uc0HzIUoXiRt5mG1PBfC2cF5QGOfJDuC0CX4OBskLfQYwUj30OaWkCBxqyiPPUqo88y+2LMcIn+J6JcN2oDIqEjtIa6CqmLQmTmzRsUD4dwj3pzmxtOLrdeHAaWGBFyhb8CLIRRZCaJnp5xIyzFx3f8Rdf1m1uOte/7HDr7sjkTcSOsyaJwrOjXmx8OvuscKve2TrEOsSwx4KhHqSuJKgLHj5McOvv0KFX3+TJcuP+RAFSikd9M0qTHHPMO7MIZpxcZTEkcd/glejDVFsOZuTVPAatd51c2K8kE1JFvylttU7lAIB8mdKLisZ7tvXyxqy44MDbLEK30ko+x6lClfdxSH20VwKFVzRwqMz9zowIvH+pduECu3fx20SHr6B4X+tzJxF0qgxQKgsOiqjUKdCfYRZP/uf0kBV855QcpTV6kJn1Z7BHb1SOsKKA9ElC1sqpg4ZG5nI4sZLHWa7pRfhKHhVzKBElthVHNeVbSifkEsU7nwWiyf467NkXiPZL5VuxzdM9KwEWmF4/ZM1vLLTPQMTxPoI5iB869/UKvJlFwUtIEfTiNwBdXR2yCtW9vNkIWQaMtiJ2cXLtwg4dR4TeQx4iCeSCSNtEU/rgPTLs3l+6DEqyP6PYd6R3V7hTxfHLo55PZYWCIsbBKbj2FGGz5Z1JobPh9mRarKqKqc7ux1jDLQOuiTq4aK+6QkN4EhbO2ZKSQ4kreGMw7Lfb0zN5yfNbP454/4zfW2mIi9M8TAnXHnCzC9tXc5aJ9Bi5sQS7IWVmS5hpeDz2JNChxJAaMXC6ONh2Umdm2eh2nEJ2yxhW0vYhoRdSNgmV0nYNhKWLs/mvthj7pH9KHz94svSUYaJq4oylcGfoWQh12aMr0n3PhskDB9ZMQp8pYsH1XxUwnWYAPIc/wKzo3JZL59PQfAWvVqzWL8BgLiyk41rbNT6g1PEbrQhmodnWDzd23xtPrlJm39AfC55wVulLUd9Z8QuQh6cYiexeUxi9V3RY274J9xwI817lB5kE5O+waR5haQZdzOTPgOSzrdw/gOxfCtWPS4Gy2haNqxG5hRXiTeEC2IleACcf224ewD22jAefN9KqSjeWSy4gNt+dAbYZhI889YTokUKhmNguKOFBTcVfElYOINazVDJmeTCBVOHI0dFr2ksBQJYiPGjH/nYkkuLBO3buL+rm9ayueEwel5ESeyOvAixpQy0jYRJI8RG0vKzuLvQooWUx8Mo+n26eSgjSw96csOU7NXCOSYK+mAX9WTlmOnYJQk5UzJodOOSjfbs0s3EeRiJxC05U8YLBw6SNpFkeBZEK0+7L1QyZX7PIk4WFQ6GnumV2tRSYGdJBj3J40mLcIyni4joL3XP+chHH939zz/YbFIuMOa+d4tJ8chTWCK/36QgE8h9fA101+0mVQ8/kZT8y8J/fddnbjVpueSJj3M6X7Tg8M0mVSVRRJFwZvr6zu0mNXyJNTCpNEbEZaT/oe0v9B667ad3X3arSeXUD1z/rlvf9qtwk0n5VKFfvf8tE3sOvuo2kxr6K5o/vmDSunuTSQ39qfvuaHnUHRfcblJD3zmMf+/YbFJFx5jY2U/RDCZHv/jp/7fuqz/caFJp5OdvWfKiH/3w/91mUtP42F+vv/D7iz68yaSG/sV/vYOZW3y7SQ39nXcGjY2Nz9psUkMfEOY+eLtJy0xGxPNr6YVr0ujsv+yeuffz7HzJis75y/7o3CqF59G5eFYupLP/8inu0dZ0O9YkoYG/7NeBOLAmi1pBI/ZzoOGIzqNINzOzfiHAsnSRuOTho8deoQEGndrE8LbRQqylhWptZo1ZkMXUThmxubI1qziyHWIwwsVqfS0pKF/bMqcPsREKaa7RSYtpmTzn2VWwsPTgu1SWHk8Z2/xsrlmxiDLCD6KGHnWROBRKBpAtBsciENKZ6lzxgi6ClZBPwdnqIVnShCQTIlevWcL2JF+bjj14CEFEtvEdLIJThIUim8Miqg8ZDoDuiUy8CnuVpU7KY/CRXdqwgMfJlq8MNugsnLR0FtpFm2xe0N5SboedhsvgWFtGjQNaxK2l62Afm+pHHLK54WASOzzKWyrLvzC9vLmy/DvTy5sqy39RUc60+WtsPSX6sr5O5hnyJgsGGRkLv6E2eIamtB1u6puSvfaGSUXo+8++STHLOehXjgKITdSFFGYoXXBnm/lPGaYngq8JL2dWowLYC3oF1p15zUYWLpCZUgzepC6Gy5ecRcuu7snAWLXXIu7KWFUsOS7uBFFd7LQrhCugbyk5ZdHF/RpcIcbptY5jjXujDM0t7FAOWSxEbFP4aSGG7ta3PDlxaMMPeg6Gya1veiP+Xb4ZGNnpU/W94GXqgmYq8rd+8hP45/f9Oz9GySVXoiRMk0O+2tuDV70UFB9XTJMl7Efem4LXoeCSrc9+ysD/vO+cDRunDquq5FKa5++SSfIOm2vXf29j1fc0M7/dPBV5uqU7N/+7Rn3Jex1GkNBgG8I5O8qQTZkBRoaClm+Iuej8ExzgVJSqHJ5P3hS5ZpRT5FAqPshLzPi29DHz5E2eFP/lh7R5JIK6WR9HbOBtsnDjxeZa8ntMxJA3SowYykBkt92g3ZYLWPetGw6HroA6mxxe6nJREbwBLMplHWdepjJ8SO6buJI90Da7C8NLTvbCcH3pwtCPLH3NOlJ42uNHuNZpuEZcN8M5h8uQ47lBxSv3krl0DKFTPraCd5Q8QIXuuGfoncfxDP3ZZm6kPXSq5MSCs588VJ8wZDdKEvwyTN0lVM6qq0sPDxM5vGcIaLXM5/xc3D1xlTGwyMElsiMbDPNQdkUnNda1Kr8CGD9b/M5Gk+ESiZ3uaqf89F51K9NPd3E6HwTXareBIxOspFge/Ai8X0/mATvEP+3cgnf8XuXcCt76Qu23dUO3xEz14VflIPjEC0SbXmDZHL3xINnypodDdocT4KRqCyXuAXd7nIATBwBnmsvbgctbHbX32O2q9GxctsY83k5eJe2KeHb205bln6BvsPvRxjf4pSu+uBhL41LlLTMuQrkOYotc9hXiHAdaAj8c/1iiX+RzWfpXfPGKZnEWpoLLKjyFSpchflZl7egLLjd67IbIXhHz4dmVPrzpy3l2BujKGQao+1FlA4TMNAM0wutILUdZQ2Y5k8UJTMJIYe+j5TQnuAptm0WegGvXZ7cdCMov58iAyNU3NdCNJK5KKr1gV5+IF0zfJcKsVRq07uPeJdKzgbkIOcvJtLtE16AcTZ3EXaK9MI/XVL1L1K8ZwV5ry3BAb6/EeCjOx4rPiBdnl6OJuET0JFmmDriBf8p4VI9rzqvzK+Z8zdE6K9/PqdZjAaeZXcbCpPyfWUroGir4bhCU31UrufQONwi3NEPNj7hZtuQHrXGLf0gd/iUPmlc2C6+w2HGvNxsH7dUV3IKx+HhTzUbLUbLDSUQeccKu9X1toU8uXNSST18K302m//GUGguznHhjYZ3IDKpbTzg3bEAShDkk+TDAA9QiRa/HOWRxmu1xJpDW9ThPA9TpcR6nkv9RxH9RdS5Sp+xVuR2qrE/V7FVl3YrYrqqQIuZVFd4l+6G1Abux1OtdHUDqo9G8sWg+l/BvmF/VpAZiQlN/QPw70BY1XVyfkPM+kyiSOicYjZrHohamtuAcSpNkA87yGVyf6qmZqXxXe/TgKCRU1DtThg+4I2uU+2k6AKUxz++KQ1+5XDFARzb2R4rGwB/UypTLMVHY9x3hBhs/jKai+mWqSwAKrWqoDu5V3gC9kVnjPziLjzC1hYl34TVQPV3BjXpdv8LShjOOe6xKM+Ea3HNuotxKAo3r1tC+3Nb8wItPqNoHpdprv2I1nsXBjDPjNhzAz0yK9roc1Dj9TI/z9ph9MDle8crxka6Zrxy/5F3PNa8cy/KakDxT1ukiWXuHcJhVS7VXfSp4YnEx9Dk9wmka+Y7yG8aWecPYfNdaF9aXCxtUYa5cGJQLG1XhvHLh/HJhkypsLhe2lAtbVWG+XLigXLhQFbaVC88oFy5ShWdiSEuUa/ksHC9Tx4TjDnUc6jpwLkS6Do4fwYCkKWTEgA/nnsOXeOG5Mv94YUy9HoTX4SBhFulzkajdRmb5vCLSpVEHtbNXkfe6xWw1iP+IXNLF4Ca1WZWaiJbgUJqJlsLqQl9kgsh6lChLO/6Gy0z7Yad+pWmx3MuAZeoqPKnY4NhWwsqCmg87kCyVh7G7cDlPYTclsayWo2DCDlcgfa4drqz6bPYqPLzVQSnCwaQ5eIU5mOighDGIYuKi1f3jzxuN1iCTENsX9Qill9ZQ74E2LllNPfjx8Wri3IG2cC2thI9pHXXySf250XA9rTDXkmccmeQp2EDd5UdGlh8+zKSN1FW+HgNhk/EQswMKF9mXVLSwuV8AbtjbnwjXmDsLWnxLwObqS6M+LITV/QC5ueeEPaAnboy6t6749b1vfPqzv7Z5itspgOqHq6mbM/3UTd2gbtEfyUzRFh5bx9WjN/6labo0xe0araJVJVfURLr8SndankrrpE6em7fDjxJ/SUapJ3XAdncylTbTRrxQwS2oxqKtVeLsbeOCmT7p6HzU365ehJadDZLBvx/cMj7ag3mUyaukJtSqoM4ibaXtM13a0Q509ltmhLbiaIbLORow7rdVVOCK1M+CqDOSNakWTd3k+37+16Ed71prUhB/z1zTdq4R8mA/c9MdTXdd9ebNJg1X4XEqFQMRPiTxCdJWCBtshauMPN+gvH5nkchxA22i7apSndKlr242adnJu4ogShLBbZUxVBdRdXEShLaKedEiggqguZJAOuCK7aA+ccWu0XPdh62TrxW5G7VOhttCLutwjizhfC/xj1dOr6zuaFDePF6JzNmyxySiISHtZAXbVVKwXRLjdYWeyl3Qpt3KebqVhsJOrcM7lZ51iduU5TqRhGC1LKmTklLAzItQJ9TTETkViYK6eKgyqE7Y3k5uqgEvV2OI+DyyVMI5zAWR6Rwd02DYiQDMp7nzXYAcu6hPrypwMsjd7xEZQe57FD4ChOtkLVFHSUj2kM2NKFvZxZXNRzM68Oa5eMQpib/hkJb2HpH2bm59p9OHedAbjvZ805BEnN4t8wBBTGBMqMLM6pDUSZHIOtrJfLBzvEuTOrSpEBf3KurSUpn+8QPzaCoidqsgIZjiFZQOmWeMf6WMf6UWSqEBlZmhnWBI9R/jp4s7XkFJzSzmRtuuSmbAGw6PyUyXYaarzMxOeQ2fE5vVViZLdzDILdLZuh80rW0odWKPjhH0gkWXlc+WDqJiOEh7MM49evLX09oL69mRoN6gh0bKLHUqLAGJYTWo/Rwbgdh9Wj1KncHNvHGDd1YtttYRh1tB0k3Lqfs/2qibutqMAYf2cYIxou9OE7FFGFpBqwGHeS/cL+9cHmfx90+Yf+NhL9gfrrcgow7NPyZIeJclVIxWQDQhqwcz0QeoQNjfuBKvHBQh3BEfCitJ5m+c+RNYvkKvoi6soi5uzZu2irKA0iwQ1TEybuMhIFAwx3R+VjDiN7dlqMv4JnXYXd7nOrDPiUP8cMTyIpYaO267Ia3YjC2j7rUs7TWXRryGi9R7adS5q96mxfJsaKe6qsDKG+HSsBOdJMJu7kB9bqHccNStZyI+RBF1clkiCFfYfTzKDHcp64PF89AATU2nDJqajg2aaqCpBppqoKkGmmqgKXM/gya/BppmLv4aaMocEzRlZgea7L6HFkwKajCpBpNqMKkGk2ow6XTDJL8Gk2ow6WEDk/AfD/EZJ3Mr7jUaLr3haHBpuwFH2+cUHHnHBEcbZ4KjTdPB0ebq4Ei3sHeOwFF/HBxtMeBoQwkcbbhPwNFe2nR8cHR+dXC0A/W3nQo42lYFHA0cDxwVyuCoH+BoyyzA0TbaNrfgaCPDzG0nAI4gStpxiuBooBIcFeYCHLEC7Vbqo5YtP3nRiJ1n0FGqPQiVjmGmTg2j1GzuhkLtjEGUU4MnspPOgCgzjatCdIYVornjIDyB3vWGn8ROiA0fmsAl+kFRrklF1aymlG2ri+3NfOYvJlXu/zuWbOnyFuEuvZ53s1GbJushafQv82WsSQ05dqrvdXSA3V3UwaOzNfbQo/6RGbWNT4PKqKkonWLQkJcetEEdroyuy0Ag0sB56QxGie4HjsrgYDcQw26FVrh4qARRh44KUd8CiKr2py69CXXrlHQa6LQEXD0AV5mMQT01Q8hVB66CeAdLwNVmLJi26ZRwq52YHowbKKAabvVLuJUrVMWt9jFwq+L1+Lj1GMzEcatfxq3eNNwqsAhiTJbZ4bOssEOxwsEF0buGrlphOEM6YwJYY47QIeMwUZAOOjPkKUMPQxj50Jwi2cW8VPdREsl+2kf7/6mN9jOSLT/mDuBQBcnS3ABZzawBs2axdWgQWxXA/twsrkr82lG5ujC+RVzjDPAuFZw4enVOGr3i8z0z4asLXaEZ6NU36NWphl79WaBXF+hVfUlihczCgxG5JuYKuQKxGvT6oECuNeRaQ6415FpDrjXkWkOu7sMGueZnh1xryLWVa7Q8tJDrssS8hyto9WcFWmugtQZaa6C1BlproLUGWmug1b3PQGvz7EBrDbQ24TXy+wW0escErd5sQSsL3nsAe1oPTAetj6wArTCp01EraBWwFZRj4VYUA7j2auC61gBXgFkDXHs0cIXevyvav+WT87+w6TV8Ygmp7ufMFtb0/aACqXYp1Q07S4i16+rRd/1lvhHcBFBbH/8vgSvMiq2OWDtkWb1Sr6HpiLUL28iKYhyvoinAqJkB2s7nApD7huK/aAeTBa8aDLqihEH7Ph7/qdCHP1QYFE1hJPFfVNB2Tw+iUw8A3xxg+b7zmcU104cBsPpDDVYh2PhPS6XuX/qn6uM/EH8sYJVrAKz+9jeP2xj/sYFeqsHqd+4GWIXVVvsq+A9XGR4+kRAmIgxZQ1VUqft67qOb4j9tTmWyIEWCzDRUfQROBvzU0sF8okpJFkdOQBifEUYMpuoCsUsD1tQq+8iScE2Weo1BxD5UGC2uYjO7fjjcQ2tpzYFwWF9riar2lK+xYrBkpYYlO2dCq126CDv2YEn9Bgte7NnKQejaEGQJKGmVtuRdMTCzexZgZsUxwYzeHljMuus4jloZ63rn3Hc9iG1qsCp8ssvwKarBp4cPfJpXFT49kg48wOATWDr9mKiRawQlTAQgtoevmWGQiFHa2vsKJfVqlLR2zlGSXsorNAhaiTQPJZOWFFBaXoZOSXn80mHeThwldUEVumIoCRmW8omipBUKJXUgxH8fLZaFuScGmlYa0HTn7Ro0JacBpE20vAyjug9PB00746ApceKgafiBD5o2nypoqoGmTQ8w0DRcHTQNV4KmCxRoulCDpuFK0MQzsbKkTivVJsIsrywF2Qr361lXuX0Fq+TuYp5LkGRPCZLAnFOSDWfU1QZf0AlAlInpEKXgwupiD5QdGHvAShrW2OSiEja56DRhE/MKyEUsj+hioBMrHDwqQhmahlCCoyIU3rifcPoRinO/IpRB0Lh5eXdpMA5RLp5jfJIz+OQijPsiGn5w45NhwSfDs8UnDVyjvgKfXGDwyYX3NT5xj4lP3FnhE0jXxe5/n6GN48OM39RgRg1m1GBGDWacmgskDjOGSjAjWQkzuGyXeptS3wrcTckTAxyoNdeYQ+i7DH0XaPcf5BiKQ46h0wk56mqQIzYBWa6ReaBBDnuuIIeTfVC+U+rXnsyvPeRUe8ip9pBT7SGn2kNOD9u7dN7D5sn8ttpDTrNDrwu5xoL798l8a66ezLezD5FQBPlT/lxc/tifi6t9Lq72ubja5+Jqn4urfS6u7n7+XFym9rm4mYu/9rm4OgOOEtXAUd1JgyPwf66EnD+X2jEr7RLuaUAKPB2I7MZ0EqHsvHHvoGvCf7kSGXSiUcJ/6YoSwM7CPKWQ+JG/L0q3IXIq+sxwMnEHyxfzVEd2WO8Ab9RFDei3TgVQ9SSeHCd+j0MqyZPHoe38sSiHEHM4To1FAeLMecRJwAmX+Cq5M1DU3wTq5J8EqsnvaPpXdPXPaPpHgn7utHAkKFIdjJ0LNaMEY6DRqJG75NKchKbLgZggpgX9AQUSnS5Q0ek8Kp2VrwxoB5Ifza+IacfnkIPodNRIuVKEOpfm4yBsltClzSDksB5yFBzQcbrT6sPHvEiD/lzYSJkwTdmwBUJkfhou4HbTfFpjmKMW0w7PP+bchfw5K0ujmVse55b3bkPD3OwhJqapkYncaotkWyhA7zzM/VLJpoZCltlspYZliVvuYUyhQg8jexWyBdgzaiWXmSQvuEUFoQQ4VBoRpsgLWxHSEzUiF+DSQ/22sJXVoYVL81Qfptns3MltU15GgDh+blENgrn3wbyL8LX8R5ZGXkaUp7Skaeb+N9ZA6HIaYBAumMdEa8XwtSL4ShFAPxKU1QtaY/RLq06gVYULP6LTGzT9Ot3SZbqlSU1/g673Ck0/pOtNSAxERHVnZWs4WWWD2kCbtLJWaly5mugeCJwE0lbThawzOcqNhQHrXNNY6LOqUdOlkTvCPEgMbxfMtECOPJ3vUtP5eEyA6lH0lOaN8hy2UkA5am67FJu7VgFflARhHkWVydUx6DHZacxzvlRCLUVKoyxLAdQtMEpuhpvicaQwDih9pf5kqR6SC+spI2mGspJmSQXOTJFYm8gV5JjUpuuTLkKhl6IW8i3ckUiXMevogC+xIo+8g9pwmewo2cyDbOmpg0xxLq63KAlGuyOezD513BulYa7kuD3KwCjJMUVZGCtEBU9fzH8yFz5+XeI8yfvIZ5E/l2zy+How8keDW2UXzaghc29kaBHPOHhK81n84xlOk09phrtp8igD8fnQL94Ufb1/1XHazYLihCP0sXUNc8xvHdWpUKK6OmP0/vHQU2tYr9801as63Db34LHMyQOYz0EhAm6wVzXfrpo/F80nEGufZc4tJSERD0l75A9zg3zUxwwnIbWMEPrHlZAy5OMHPiAn6RLDYtFmp42DB9AAK6eY8/U4eHYgT7lGA5PMHYY2xhLhPaOAeIZqswtuk+CW1IAx5CrHwMw3UE7gL1nqevsAF6a4Edb2OjEfuO9vQnJ+w3IkmKtRpwlrJHLJQuhUl2wES5XkIgIRJpiXoT0WJRFUFcfWWOQhsqorsVQ54ZIdKulVxG7VQrtqgRQxr6oEiuirKnh+I2VzHxAWOVjDTswqMJqDiCxZw7AeLpWKg8rixAEsr1T2s7aVHp8Rnhb9uIWcYBY79NArLAOlZOPyOc82ROxvhpJhlsswt4g5z7jfaoOlwDMUmYKrFu041mwae3664GpXbZac0Ocz/TDNuQwf6TYpg2sOyqIvvQ+ksQ+kpb0oo10CPlxa3ClazZZazZAXplVblOECvi4IOE53wAQcJ/g4obcOtEdoTwFz8uSKke03YoKlOeEcL0AU2ejLZrUYVdHRUcHEGEeFihiuqyzrIM8R79rACuOIeH7T2+/1JCa+dZASw1eP4RjLWBEuvHo0+4q5DEnvQLGBk3BUGrXDsDR0SmHpby+HpXeyxMXTwtLfalupEwxKni8FJb+SI4snwIKORl4OQp7XQchTWMEShPwK1CVHgpFLFHIbK/dIRSDyMvPk6SElZSAIwJvUPGhGJD7+/zy6kH8UD5P59LAROVhNavuxjfwQs1QHNUc3qTW6BebXVpG/kxL5mxMP9SRxkUhZcEcs8nmqMvJ5Lhu878WzD3n+/hkhz/PxkOf5GSHP+0phyH0oEw5YDHza48gagZCOHZZ8ZqR2HYBY5rEyAHHexCl/tiWhuiGyQKE6ViNYGVjTsX73+cj5o8j6YwrqmufOEqHNRxasClRTnMRY37Zs6xJZm0eoHcQS/hsKQjyflBQFI1dFN3/O3PEAE1PBgg8WjiQqeOD8TCZutmxn3Bk1IsZSihzNko6k66JFkT93g+63Gj0IvfIhTLrDPaFiojCOc3mVa/sXMRqZYmMtdeqq1wF8mcLebcnq8ibfTo5UpMSjbpiajJIYoQOfgGOYH1YCTGwTNXSMR5g3XlfJ1TUQQRYOlocrawhjlaj0HxEDwscQiqNa/Vq9b49bow5Hk5Yo6M8sxT6fdKbFPv87e98BJUdx9D89M7s7u3NhBLfSwen/fz3zHA6T7ntPDwkR7sac4XCUc7bBIr3TOWALnBRt2ZxB4MPZ+vSZvT0HkYPT4aTjPQcyssl86chyzjaZr35V3Tuz2j2J5CyBtrurw1RXdVdXV9WMxj1KaRlvREqD9mslCjLmU2gQ59ikuNQ5DW1gNxrFbp1RKGF+AZEcuQ0ufte5pN6ein+22MP5831qBiclvAtBOuuMptOspGrv+Q4OZI+qtzs4qKSd9qKZcWMU196+3klJmbFYt+GA9Hgik0VTMCwf7E3QCNBghm9ffccft/3ue0uXU/5st3+/552hX3Dcu9+NW0+w1Nmq4HfoTcpUa63BNcqtU/SXjfae47zrcB30JZX6JD9U/hzfSTOgTps+jz+3D9Z1WecI0we2XmJo8SyRAb6cF+FYEoAOLuhwgZKJ6vBC7V8ohPPRg+kdsoJA5QHN2ei2j0Et9THsvlA/oNmSIrkGuX7OrfrWOXXM/xgZKwRtdbiv97rotA2i0nq6iU2lXbLpSiJ/qYlHmjQLM/PLB+t1YVF0O5CbwsRfJ//w+G++3viHxyfMPzT+fQ4OdMDk7VzbVgp7t0ldqpbKIKEMOP0NO6AMMY5yuyGSThrkATvIQW5NGlor1QODdC0UkKaW7heRl8dNmyyd4xPIQtYr8Fa7MonoKmyt1KFYKhSn2bGpYA+Q1YA/RBM0mOAGtHCSrmFeM9ddly7HYu1qrLZoqA5i1ms6mK4b2LOG6stjFWpPEz6vTXka2heOu41F1jtUTwk0i9o6+B/gx1lzuak/dKheG97/iIU/v+ugvQe56cQt68eJP9lC11n2uL4GfGJIZ9nlfY+4iYJCM9KnKU2dF/ZF/wlGE3q0+V+jPVDt1ZQ4/I/150k8Irt5SJIlkgzIv+u/XVFKXe5B6qWnebTa/iD5JZT9jWQHKPsLyV6gKD8r+RmH8v8l+UsAv03yVwJ+k+RvRn6b5G9F/lrJT+BJV0p+q5I1jvw2tJkRcRCXBbkOrhlHj/04O4tG/dmzntXAUjdQX5ih2MvZ25Dt4exGDBVlzwsyVH3O3iIyr9yQelfzRbSMvUko9JNETtg8QJW0yx3ABzRa7ktXOkAgH/cnoSzHg8ju0RzLp6hNKI22KmkUvMC29M2ZBQL0k3CKceMGOg60gTrHyzhQrakTDJaBeKPpAGnoWGkQnbkeODtCbF2O7iLJg9KGM0iZEWi0CW1E9qHmNKg5/84wA43ulBZEg7NE/UkjGVlXops37FB3vVJ+4xLorbAWUF1sOpmKc55Mp5DIS8oNoVdsezYVITmR0AC9SSkFYUooLDyyT7r6uoheTnpl1qsgo6EbiWEoNugyopWhtfajb2MSuONYMoYjSpHuYg9+raJrWPv0NA4ejBFdC0BnjiqeoYrSylJFe+Edvo9DX5EulN1glDzFqEasOKQKC6+xTlhJd0TRkMURYFl4tHKkosNqIEY+KSMdfwnZkDBhe6gH0l5K68gspEz0KznCUI60v9QBwi52jUoXjka/Rq0MKQeUJtyi685oQKPfcv+CKf2OS54p/Z5LRVLbIe/kgLFyOHGRneUsLhr+i/qsG79/qG5yLx2qoScfP0mB5HKmFKBYM8XaofU6A/h0l5nLBspwvl4Ydg5UxFoNCqDsYUMHAns4ipcnbl9Skn3rmn04wPpoOLz5FGf80HsWr2FmlM7RhUnSvU751ODo/QderY8Tky2QnIoLwpRFzBSonwW5TBYa+PO5I1MwEBpuihhquRyDh/aCCdx2qg85ffVaeJlL92JeDLFr1wVNmZeM6Kp28IYwCrDU3BFyDsnBYW7REYGblgyTKboBNOSygWtKj0Nn0J3Y6APuksTWaipRw4+c+9ufvORtywZ1lj2ub/gE/nMfHcpE5l3jBTTM0JmOkyjq24xrP56tmKnonCkH2YAkTu2T+kagovvhZc22hCatG2cEPYcnvySWPWR2SlzQXltNiS9XMEdR2PgpY9qLHsQeYPwwArr6MlBBzjQ8y17SkesZlfuzjwFYsmzjOXiZteE6r6hIhuAv3UusHBlostzu621TSTGn1SiaN37oklNjgjAlxpKS6Dn6rTX3+cd1OtlFK8AilxtPyQg+MRhqxbpPY+XrkujT5XcklQtxl4xWX86XLBh2dXlsBQN7CRjqsF47B3pxozO53TrqOtQdU7pIP9HDIJdd6mx/hZcuSMLPN4DHduYboDpKOpqqNR4Ei269hn2Oo7zIhyWEPqyg5EUMrE2qhCtZKUcSce7BtmoWQ9B0ihaIWbrIhygKzxpNz92IcxRwPkaFSlJ19vrsIBW4OUfpP3sq3FX0vbXqg2Bmdv8TXmIsq8GNzziLcY0qyBFKSrRCHlu8uLM7wxepWboFB17u7IToEdXrGMrUFKGL2ui2MwT/8XFXLBgJ2XE24KFFwPjg3uhRwUHxkRADlXA/lVHkRgEoVMsHXF1ocxcIaJtspypoqO+Tlu+iYQAGMoqGI5Tzius6JfXuRiXtl1GiodByMiTJEkkGKLmC2vSbVEuX18kM6Vdb9ev9WFtEUrltGhAJKMnWSMqUUyXatdw6hq87ZO0JX6j9adCeQ0O0sdxUyeRF2MhjZAkIWI5gNbx048BdZ73/BYfLDdfVbgOy3D7TMefx3rqA6/5mkHWzJ8ewjJxTHYvRbwx4I4zLkPgw0h2TFJEcl5Rw8BTJkKElB5MmJWzOcchLqBXERAB0HNoQSgw4ISURGoa6xGYdj1tB3MoItjft8FzvovRWtrdCbw4txOaTAbATi2JCgocDSjq4Ed0t06DCb5zRBnS2AZ3NQe9jqBB263ohFRU3eLIhpGICFcg39Ld/U6qdBYeYB0Xtx22sMzN+CKc+W2Y49ehvYY1a1eoAkNNC3GzWYhDR0D4FVhTEYURJkJRezmLHxkAm5a+Q0SGusEc1Dikpro55H1MTBw4kOPa6kERxN5LeOCLs5+EGB7fHuKI0pO2BtIOcLJSUsJk4OUmAx0ib10mXZVIakbohablE6gYE2C9NtAB7pYn4Zj0spnkS9ARLSHezO588+V1NvvykRyIA+HalpQ/5Vqqrk/kEnY8+uqy5GFHRuHE74ddGBAC8/zDLSKyerlCGHqRW0XN62Ouv54Fh87QEyvA9FhP02Mr/qoaWvIAg54NRcqSbu16ES6xAgwzqayijC2SqHp0Q0TQvDnANP9SLcmBtOgN7hGVXdBOaNfk2nuNkTXDw26boDCU7ugVddt3sVm72P1mQSWGHIJPyEwwy8SXIZEb/hWNMAoH+JjAxJoGJMTHw20y7bQZ+ZSAxJsHfMMbEtTEm7jMeY0I3dWgeRtuowhLRGmPyfScfY4Ji2xiTypOIMbn5acSYHLpDiInMgZD3JcRk1WhCPxJiggkhxATpzkNMzHqYlZTXAeAzQT7EJMiHmMiKkZWCEBOTThv4JWakLWakmoF/zrSbMPBx025dYENMgqcZYhI8QyEmWG/zIbkok9DpuldTiEl5zhCTMoWYFNuFmGAlJ8Qieg1mgBSmAS15TXlt8hHlI5NnFxuWxHyshr3MAJq4P6rnP51IlMBEogTi1Ea680iUczPnOqJQYm9Ot7qbc6vPOHO51Yu7dqsT3ENPyoHSIXrykJTpR188yix96oSeEXrSaBFGq2C0ih0NASfsmqdRaQAhLo8iSFJnGoEK1oHuzulAj3bqQA/XPzmHnrtzpyJm54JBrT5Ff06f4oZnDgV5709waOdU9P9JnYpfKRZwey/R38bF75JyzlSabi6Oatgaz5bXTzRd82pF/G4uJqUVaflooGBea3lwsE4b0LNTGqphOaZbirCaYofAKBQiCRDcY/RLkKcLbDExUEU2EDuIObDz8qjQnUS26Fp71SzdjuaBg5M5wB7DPw3j+x99/NeU9yYJ808Ac2ODJSHm1SzM4tnI8OwmaF5Ix72kcGQfzGygJv4eTWJVdPce4Km9g70tRUoF4x7SlZISLQxCUZ5GhRIVJj9PXj+0gw1BEyQAZLoopKF5i1SpoH23hkWmm2e5POnuiwu8QClDNMCaLJndj6cQrAdLsUfvCRgCwToJjMNSB6RZ7FGjyRIR6g2WfGxo6hEPXUrTU7VHaIIpKWQcyUVzK5ya4gq+UpfGphOvhsVi+20jxmLD7Il5A2vdpedBdyFfE86Jek130JOFrLJItpQTGG4gVFbGBSAWEL4huN2NhIgoQ/HkO3F94RliAky14V+8fPr/f+TnPyYvKlkAf1NlqtQyf1iNVrR3MCgKUYXV8i4iPtNhT1BqTyNBYCaLMOfuHdeud4oJoZZlfpC7RXhi725F2gpWjz7ddXEHgy7cCHFxcSfird5LUlHRBd/VWuEC0EuJB5VUpQ6bsdFWczWaLwTMhUFAa1dacO/9pH0/t3f3A4Db9wPmSguXW2C8JfLsIfvsEXn2kDx7iYw1LM8e4Wo0HwaMnz0iYw1L71dJ+2Xy7FcBwO2XAeZKC5dbhD9RKniCgUazTj7SqIoAlf+RcBsTcCRh5yTcssgjdJLQowAWFxt6VJXIowpHHpWi/20KO4ruELOHuONMrFA0y0AXD0LxzlwYkNscBhQ+UPELqxRHQWQSGXsfchvb0c95+R0NF69Yt9PuF+UNlh5B3KM7VUOkxF7mPymK2CAZnbekE/4FGjOkWXziTMIls9KLSKvpglTUyTo//PXvHXflb0/8JRngX81/vj7YGEns/ok3vGDsivljV5wwmFnshzbNTA3vXVP0/wsHa/XJ+qQuTNViL5Tq2Y/QLUEeAv/Grw9+6LHnH3AfPdmbTGQMaXRcX/QZNLKIutRN+zXYFpZb10NxKvo5XwxLEd937XB/ouFol9KTS5tklE3RRjSYpO4e6LK8rwmhdg+Gswk1MCTzqUiEAxewxIjnuDkCIegqBkfSj1gxC2LVzNhmhirLUNXCUPUPytDKk2VlWbiIVJctF4utXCwyF4tPn4slpjzMfNjtobZMdIleVIoDNAs0hYODB21464Ff6lTtjP49cXc3d7XSAfM3CfsSjn7UlGE+KqJ/GPKOjYmIuyXvbsm7e2/ulrx/de7ulrwtoeQnPpUI+LtaIuBnnVwIPJVaYuDfzhEiuCGLxURCYEW04B64Iq2tfbt09KK7Mb59lQKmHTdYjFFwg6SeEv6vJPyfg4YCSXxJnHCgEXHvR/dgsF1F2GcR9dWmgHpgZCLql7EnD084kveRz1ZBT/tyD5FbSExlpIgswk2U26joQYynFdcoqQnDQ5QrA8oVCqOCvnASgiJEkNHENV1drbiTdni64Rspyk38ibj50eNwWZP3SRP2bzMjUFPcx0UVjgpUwsGD2qLtwCWYlxIv7eVnfNNVwVN/p2TuK15vyw2v5eWSUrS9+Yp3L4o7fZuklH+bpGTfJint/G2SYuNtklLL2yQltOPER8J10U9z18hiy9skP5Pr7QuVB6a47JWhJsxRMQLKQkc0kfZghIi+s0FWHhhOPIXRnYgTEzLwzDy1F1N+/mRfTMlvk1+g8zP+Iops/GwxuUKzbNl7RCQyhK/k7eSCd4yxm3ZYi4yfroTT501Ym1js6UnWVY7tx0zNrvTnK6Xs42acLJhFtSMlDEwc7tBLiXsw4jjw+iHCeZGTcF7OSTivooDAauwCQkb2XhogwLI5GBEfMAwOYLGDw5N1ibj5Na9ePN2hZ8F+xHY3i+yH3ULBhFJ5a4X0WkjvwJsbu5T+pjIqHgmWJD7ttO0kIwFOHcpyyAt2oD+NTUfL2Y85NGJ7NSnjxOYjvbBC3Ie6ArtXrQ4PRhzqEllkA3hiEbYkRsQOSuqTMAOGqXhOkHToTjyjU6uXgAk8fFyGES0APJjmZ0xP4ewuIWY35gCsegzPiPTxGAyxhhRUUiIF71eeWuUTGeQFCaWNdjDzIWu3dMgyOZWozCzZCHyHVffjIOXwddfizx8G62ThHE3p/1UnR9dw3JRvoi8yRcCbAh6wSxdEQBTFXFQSieBm+or4Cny2TXIASYJzVhF3AQgmk6BeI0BQJ3gQ/Ub8npnuwkEpJMQdnuh/VAJfuP1BtVbR3/CDuYiOYl7KamtG9VaSspVurxi/k/nYY0mXV+TVqgpJgVxJB8JbRr5SZ9bW2BX1PuIomAykOmQLFWm9a4531hWwPeBTLDAOK13iViJxEOscdLZ9ySLuIhQEXww4SmbZuFvGLuFhpcYHWSKtQPl5SIjA5AvsiffQHv3uiRm2GbyLV+g8RjIJ5ZM7PTqKq1bek4sdGk/u6zLk2ewWGqAd9Z6vq1SjQ6CA+qolhpDCGNJ7dJXadXz4yqvePvDWewZtijFbPlBFoyTzW78wBfACgIfgGtlqU0FLc80xex/7tW3ftWlW8553eQecvtfUt22KGoym+T8qJTyHqvwHRFfdfMMblt5+72E2ZUR/vnnf0++79w3fsymNwfDVj1362rv/348Ot6mF33zsFXvV1PO22tTCv/xANG/evPWDNrXwo1mx/sFWmwpcMK1agsxutSnqWj6zhRlX9Y7TuWnJ+Pd++tCW79qUu37/0q999wu/ig+3qUXjwldsXveyNZ/4nk0tfKJ6DU3jocNtauHvfTm0/tdstamFv5in8aVBm2bT6dXEX2VWoU2TvR59aesaJc7copK9H31F0temcqHuow9qYTTXgGxKzV+q0ffRV5iF26m7aBn2Escx2gK9UC/gvnqvR69XuqV5F+0KF/s0gFcjLwTw7naqWAgUdRd/LbMiMXkEPpm20ruNVOhgfz81pwykAwt4XYDgcOCCqR1MP3MN3EkDy6nypEZ9gEalH13MBS1tUq5aW1wloga70suLOD/LFiBqlIhGbGKcuW6tyamaZQNGM6jr0iRcJvJGS0CCX0nXACemLtcSHJuePFZiXnxcKLWD+YQfzbQKRDuXBOX2+hlcWfzWNyUOgr1KUC00JaQ37kdJKd2PtQnkNOV6kUN0BPdVogRB84x+zwdKqREPHF5QLFrPLdLdvtvdvtu5fbdVmXeT77bnKfhu8RmRZqdttdlpi+lPzE9cpOPzk/kkrdzlfeaViasG61ZfW7Qz920PiNXzjLpvj6Qd+s1MG4t+JzeBVhABV7RA61PRx8/EMKm596cYVeGW8yfrzRSDhor+DEDCBgjxMiLRiiiJS+sctyYZL39rQgdza7oB0tBblbvJ+GaH+xAnA5QoXFh8LGryB+Nx/CKQzx+eoMSXiwzn5CKDnFxkHL7IFJDOVuMiahoXGhV9js1KJZnDJC9wNzoLwJwO3cge21evI9hNe/V6rc4WiOhB+bCLn7vr3P0PouZbDb/YrOGLyh89tHMV/4ee5+EMa3MDNQq0iKOix6UOWq4eZBBkQwDBAaijGUBbpSysSCraZxzq9ThsPBrHlnClnnRM6o4Mp/o5ccDHqN+AvY1WRuNaOEkDlnlutGIIf93Bn/wJo4cxOzpd0ZBFfdanJrfjMrXrrCcVKg5IcZJvvxiPcpq7lCmHG3WFcxFqNyXSNGg0BRm6+EuomoQTBC8H8pX4hBYJC0HOMlaETWK+TEQv7nTqbgGUgQIBKlj7mAnwszMJIWZoZCNUulDo4gIECJZckXkiEiV/MZ9VqsHD2YyHuoBN9zpKaI9psRksk6v/CCV4L72K38ur+KoAPolwFFsPfoTohEUNQ8IA564EcD/ObkO23+xKZcwL/fxBHFTf5liLxD6uRrAz78jJxM3M7kO5lzNoP4JZvHuNHeKR7P0QM8NvurQdi2vdv+p2ZFNgj2zHSLZjh2xHsJ43Z7llc3pmc5Z5QwrblfbqSSjX8got5zqhBNVS8baty00cy0deWrXdN9n+u+oa5j0QsZff4gfJaZBZycSYZsxZDWMZdXHY1AYzK/V7G6xsCKpJyytHWXulyHmARsZQLJ2MSEUOt3LE+qthKTZBkh72iKKfRtkfBVZYsQm9k+Uf9ZRNhhs2PkmT4Ypd2vHFHJt40Uc2PoNW/I9ufALmyaU5i7pvLepBZlE/CQb18Y1NBnWZ2VOxbL5kTofAaXiEfMqJipQ0uwMEBQyV8wYsndsbMDfu4gx4jyPhXJTIquNwLgHw7gLMlRauaYFSh7TvkVYd4APnIlxbZLOilrt0SBJJ0hMepVSrWReYEc78OMidx6zvwpp0BZI32PY4wkbwKXWi0zcCeIRQVkzonnE8eBRDp+mnfxS/vfh51uiK9H0na5d2jrDcsZRxwxL+nbgZJ3yNUq3ODJ44pksZH/g2cj5jwoXoTCAj2bMkm+H9aeXiDS1Z3i5QFTrblewQA2IP8AYnPEp4I6IP2Ctv4ToxHLCMvwBkg9AcUIQgVdJegY4m8btD2XIAIWeW8ZuUtSTLtxyE20wb1div5mtlsmFlSEcIjSFlNtF3TmNOxQp4MFF35NXE3xOvPpnx6lP/crz6yS559Zm/J159PuPVpn85Xt3Zyqs/KeW20hK98QlEpidk5+bsCFyZuIwGHvM+vFnnRDUmn1SflKsey1fzmP/lZGOKPAZ0W1vooe2AAxmQzkwD1O1a9rS0bHA6O65BOUNFOdfd6EOYqlRIbZN29VSVnVqLsuOvzJQdFHZQdg5p9+G+9F0nr3iq3+zb+aX/IaXUB9t+xQp2xS1nf4i/U4X853L58Vz+gQnkL+SVhH2K538Wpb3lO1m3Sdv8K+7bAJLaKyWLtT2TZb+TZac5e9Fcw7uzWdPtnL24XdNL2gBZ10uJiDN/ojdSY8WDSAFkw7UZBWygKRZl4eOqnQYijUURuUk1u5IFemUOeqORPt9XkJFfMqWZXAk9vpb1yDSadEtb6Oa20Im20A1toQ84O0AJdo8y6yqvOUVO+n2QxOIa7ovVKkJOlnDjUzJu9H20IIrY/TPuZtTbpnLWJewUUPkr6BDj0bI4xTCdqmgLV7gZr7yUHpDxyst45Rlead9S8VpFT7hW2ZkBvmUO+OY54BNzwDe0h4OerXCacyNioLuo4JJdE5BTtkIERI+EJpVeyd51N138ovQKXqrnYjZw5jtR7HOq4UnYxxmIi1oqaBMS1NHFxc4AJQUqakp9SiPmTXrt575+mX9keseHsxEhVlJ1ZHpBMwwf1kr9o9NffrQJ3NEeHKXrdQtwIdq6LeCB9uAOfupYSujtUNOTrhlNu1s69MQlJL0YrvXhvXGARKN2oKVWx2X5aNJ7R9M7Sy3Vz4orSPrROWqp7Y/lI0rtH7xfzDNZlB7WUrWIXw71Tk5V8xzddHwtrENDR7fweonh9Uhc4PR1ZA+XmpOIqydRvpvS1xlujxhukwEGSz6OKN1C6TxKN1O6h4nt2JPSDZT2pEvgyeaLYRUX/O8k89PH6U/pZCQPl17YqXQ1/YNzVLzAvga9gFUx2wxy9JHSSH46qYMx8a22ZeywfgvtSZTexKVjTOmYprqTpBRXQ9k0ca+uNpGoK3VP5XgP8jfo8lhSfVmeVHALRBesN2R+H14Wp/6kqARNzRCOggcu0L064BitlLz1BEWnpIpklYkJ0lVsF5ljssDMkjz7CzK6gB7USaKBMCLeY57fjLUOViRVoB4249ujwwzfDQrU1SEQ7t0R4V5BeC/d20A4VfAzSU/Belwl4U7Q9tqgHTLaGBfv1ns7ok3gFYkHzCscjUE0p+DbFrrvmaf7BJytnhC+uuM8qphHqGmiPA+toOBzeRTfrZT+MptPqafKhGbq00NWUDfMIS20oL5HHvXNCsNSu56xOVCfr5VFvQPxrAHKjLogv9kgX1MJkAGfSP17BucQYOV3tkxjXn4aW2Qa4MCup9GM/xaD/wV/KfxJ9LUgH+WR/1oO+cqOyFcs8hVGXrBGH8F6+hnFGo8Z1eGR6ZdzMDJbF70SHdOF7DP/mXHeYbkF3OQMFzEW3YSucVHEregJBlYSUSw6hYEFIqZF/zCwsohw0VUMrCLiXfQaAwsJ5ix1ZpVup8J30NVkG1VpZGaUXD8jiofFZRF/yaPbCViQdL0j6UYoLRUWJpEEXs0b0xY2gJ/9aCWack8MLzQZ7YYpmXcQu026D3IPlU9akdsGqvmbdAFSfskSdwS5fdxDF7svplyR44FfRTkaSR/kvo5zMAYeR7ku8Vt4uusd4rdwkYPbgr/XWTIz75JHrZQg2lUyRISrKeeeJaG0AT+KXUCc6wAi5Ol4ExEkEvTGlrha0HvXYlINbrLKZ4FiJnQBBoNv8AM7qSB3emjrulM0YAAl5w6x51rWJUypwE+mYubBk5A3XOV7YBieJw08XrzEXSZ4DC9mgim8msuUrTDub5KZLaLPmDVjmToGRZWh+H0slB1RxGq5kiq6o5u5Ato5ldLiSpj1o9/DMy8c8IGaUV3ln5MzKz77yCptNL5rXrYR+emb14/T0kYb+6m3/dhw0OnY9lrN3TY8rflqlfN+CdPAxYb+nyj2MaV8PxAP5ozCdX4kcVBYOaadMWTeN5YoeDnQBpEh0flAoDGO9qMLhELZFeeiAr5UsBrhkv4qOAXtDhPRc63C75UqCYjFRziPrz2KdJi1R2i3LymDi69jD2HlzX2IWpLXkuBPDIANWIM2r0I8ENkp5tixDlU+a1TbbESn8BLkcE2qSC4YxaJCzh8Vs08pXYToBgVtTZl/+6IZ3xXporeL2xHTVzpASuvoQlBA8omSLolnOoXolLADKR/h1JlKlFOnLmn2k9biTsYqCYxniPXAuJx16TJdurSyXbqau5h/pwIaje5quMIQr9IokNe1e4op+O1JXf52EtUxLvy2GD2HH+Om5sCNqrJRorrumko6G05N+p67y4+XP8eh2NmIHDoBxRDEJhdapDun6GMePbCwgOr244ruUTkqh9FFoK+UkiC6mEtBdEkG5cirYnSpQFKFxZbbZf+9Yae77Asw5NmD8fvKWOH2pzHwrXKVjXM/Ttb0yxhNmvbNPah2ZQEI8tJckMW7GJco7WKveUhWjuH3fdqjO5yczfj9P/a+ArytZFnznKNDtpTEiTWJEzlWdduWHcuJZEuJHJhJlEyc+A0vw4VHH8na2Tt5/N7cyTxmcpxlZqYs7+V7l5mZmZnHe7f+qm5LsuXMxcfJZzWcPg1V1dXVVdV9FniyPxGW8/dOT5x5GH4Qlz7KnveDuBFYeyu701LfFrA8V9+QX2C/wPQGkOpdK7i1Ln6n6PWMX2oTyZVSPZMiry8KSPjqRF/DaC6wGyAos/uOSgJytY3u3r7SlLCfuC80EW/pF4v4z101FzHdwG3BnKJM7MnH4cCuKVxwpc6Zw38ySWO4FsV0CldFnQKFTfArRc7JaXKTccBPsA1DDVgT8EKsLzzkF/TAlKN/bg93zlHyOnNlM10Ktdu2zHZu3oZlVJbBnOb+npGDOGdAi3YGqmuW6leikjlHnApMBRXiP5Lx8SgIoyKVQcBn6WTfzHINZ+VxmQFhz3PDFZrlXnJOxtFyj1NY7U/R6S2M4dzetJkDIOgZU8VQ9E4lmqNTe+9hQHx3uPdbw73/E+49v/fyYThxHiB1CgM/5QFWBcCqPHiu8ixcoQEsDs9umypldNbdVFahs9wXB0A6R6fYxP7kffKpxTdGoAkgc6UPtdIiBr5qKzxkxJoY9Vke9QyPUId7dmS4Z4eHe3igOkwe2YF/e/N73xnu/ebwcxr1jI66gFHP6Khn9kc9w13yoz6ltys/fdD6sUwgOYQieoDdWRnuFJ3to/DTMBmHwbvjMD9iNLHHoWsM5P7VGALnxzq6WEfnMdkIx2MyOgKT4SFMzv7YwmT0BcNkpJgMxmHyxBAmadwA8WvniPbu0NwYMcPgo/lmr8ujetpYp94Vz9oVwao9O4rpsx7Np/BRfCuqnl35/fk6dubrls69tzICg/gIxAc/1hEffoEQj0GfgSBxRjepFA0tCHa6Z+Z1HaswGBa43nlakIVwlkKOYS3g+rGAoRlT3V8E4sEiUIVfLtMPLkIENM8PXxS2yGUrjFO+VdmeQgx9eUaSZQA3o/OsEnJLK3cf2ID8haakTdVcnerxaE216AdZhcZpRsZqmUggiNLMHzaLRZqlsxDN/YXqi+JUfJ4qPXMeywI+9XnPMbYqTUnHT79bx2dGO37Gdxxjcrg5jb5w7BRclg8OAIwJvT/IkJjGDGMZNfN5CRlE+bMZRCSDOIFBqK80BnJ4EGXpdRUxoQQdkw7i7AD69lQPFE4cnJKJZWzhlkbODY9lJeKM4ugcw9TbMZaqaICRI2Oxf0zHUj48lrMYy1k6w8M/g7GATBfw7oLXpaQ07QZFJVMZN7ASD8zGSlilg0NTBEipuMeZdGrbzjLHwyxH8iwKxtsQg/w6IqOhWc6y53lIh/mcmcPE07Vt73eFZu7w/J3D/71j+cRksXTs+AmeHwX8cWnrHsVJmkn24NFehTvLcDov0z4jR1MFhTlVe/zUQ1sJHvAF7v8QAPzMOABXqNQzTLUIRuBMJ1DTCZoCDU75W4ATNeO/GYZjPw4Yys1fcpe/fhNwaCsoUrKcFlGvBPlU4CwuCZbYDGyBEit7bwqK5G5gtVoMrub/xVEU81Z57Kc9dkPDvTjUbAH9QoYK8zeQyXxPvRL1PjPvzCEdKSOmndOdPkyUfxQd2ddfxgh/gyqP9ahz6RcYHtRKtAB3c2xX1MERe+UAa1G64Qz2KSXvl9PbkotXZsVQIVF6P5Ar3xT6f+w/8bFPs+Jm+I7GkjjagWnHgttwAJj/kMUJA6bC+x504EOhCfe7Gw13N/LdVZ1ahCA3iZ/FqQZZpL1n2jpgptGum4zLvX0TNzImlMn1kpRKgL5GlCBIDndZ+4RtKTF2kq+xE3IHRzd0h3hDaNCZTqHWsiXR5He/FFedFtkz0BzngKn+BAdfCcKUK/dOdiPhqNPCVVHJSX6PM5+hY3om/RTx31bFnKaTzA7MGSpi5DMIcmHq56iME/sVLlfBQTOnqHxFdizn+W9uDHggDExJA7hktkrnaJp3pD0kYhgn8LdVIWYT5F6iObQilY+0YlzdVDFWBmC46hOY1uIAe9zFIiLgiVIlnvkdfiOjeYo4tbtjMu8w61EAoLsvxIM/xGQxjy2d9gaZMzSH7tpCD8e2HksvSEf4PhtVgM4ZKvQE0/pQM8+BLZzjte0tWWuQeobmUPkcndTKp5E57RcxdxyopM/0WleakBQsZYxTHiKPQhp5D3bDjG3O0lnNER7KEzy8ucvt450JDG5Obh5BL+A9OmcivSDQzgkJVYGb4yhSlTsJgJgTYCx4KsebsKaTAFx2/cTLnDEoXTaWH0V0mivGY8tQGOoeiuScRQlCuavB9EXnFzGCeW1AYXTUYyTGA0a4swDQCdzcTMgiOq6ZczwgLjmnMBHdtGrJC9uqXxGuAooRs0TxSRhBZ3iIJSXKkhKd4wpA4UWhoBHcqIyfGUqEbGz6mHuKZw9B1R79aBFzmMtI6V0cRdp9jMuHI53vBdGH6kApwTxPvCpQCRCDH538xVkxX0z9DXAs1pL+BmiBuBLxISv+tYE6Vj6Tnfuvg0DbeJ9yLDAvclCABSDX6yAZ+rAA5Dh0uMFBBu13fmgJiKANz5XN55SLZ9eqxNocW5bYBscWJAZnMEJMP2o2K9FPITqDqB5pKEv0zwV+DRNd6dQfUVUb939wuWYYjj1j0Y1Qtb+XoSuLY3L7m/nhFFyWxcSQqyY/dg/4AyWwc2AcbdXqr3IqEhwQYheimO0JqpG/jxKiyxejlF7+gRHZiBLBLXu5/AH0V1v/GVw+ZGPJsJ4/PqTn/znqjOP1/Hpsw+v60QWxGcD3Dor8A6cx/noYJg+d7wzBb+Zvfav3C3H7TXUTp1iuP5KcCOsES068kmzhCZJTGoPRWG9lcbJpCmaWgeZC4iCjFPpfvOMui1bHPBN6mSxHzbmcW6SUN9Jy5NZkaL+oH28YPYqQcTCkbRXc8NUO2eAimebgoxXiu9nsRE3E/BXhGtcrwjWuHUNcBKcN8UakkH+c1SnWZ7isVOvEhaeal9sE8JZ4bFNGj8YDmwGhAYbVR/5XSjzr43M0AWxaUP5+BzzS/AuJtG/T12HfchUyAF/H219POHFY7XW/9A2dEm+qy2aXjTlwHuLUL4GhWvnWqk0Fv/hSoZgyfgOHE1JFyO3Cuo9uvx1KMyD1PtLfFnK/lPLkgtO/7QyaysESvH+FYyBorX437HGxP+WNTB+SD4A7NwepuMft4Vs3mqmCMtiBSH6Wif4FLvHV/N1L/d5l0qdA7Tgw4kz9HaHozBV2jxL3VG3JXKc8TfWplvp6AXnfZiLY6O3eoNUyA0FoKtHvLKZgHBOUTX0nJoFcFeLjGa44Bzv5u+iDfsB0lXNWMak0JzqQk/BYBbCUaky7oGpeKuzzlW6sIHa3J2l3yghA2hyf1ayZsQVpqOCyZi0c7CsGfLC7GP7BTFAdlgw5q+ishEA3ZUpp8iWkEDxdLJCAvVgM/zcgLwAHCglorCj1vmrdcejBA5OIFL4b7Xv3BVN/Dx0FDlLt+N9HGlHwsT+DxEB04uzmwJH3z2GFGndWFYx2lpnKv/in3/F/MwYeRyOgN9YlJx7rwLugt1K19fUNij2fJsgLwIo8z/k5HjBlfIz9WMWSqDwYToxqLRnOg41SrJTyt1VBX6iglhE9qvoZfbLnQ993+JM9T3/jk2Pe+G1RlPOOZMxLnKVXW+n0ioFPkCyL0HgQ41n+Oq5m0Qon+5S/Ljcx8hRTsQwEyG9oxbnKcZCBKIMPUanfoxy/K/gG8YcO7WKKVNzFgTnK/Telp/4YRrDzw6ZI6JVJXFtIQvZKuFoqqKCXy28Ra4PeDeQ6gz23DMakfhgm999F4Bp4GClGsqWSsCnQpHeP/2vpZMoSXcLwCvnvmISFD1LBSXaxchflR8xieGwMrpCHGSGacwMrUQ7x7WM7/Hvr1mM7qVK7Bu+rIA0ZUIP3VmxRH3y1KQGD2+YYpkEffg7K0eRIPAdTUo53WoHX+kw7BJRkQwh9xHL0n95hOx93DfH/JvEAHSv3+gaboSniR+XtvjmNKa3wOtNjbGOEfTvTA7LMWZ3xdIZFJR7acX60bc7RMQ5FdcX6TTNLZ6CH45SQEZWx8UhfFjqASSF50A3uawo+Iu4BtP9uzzDXxd/I7lYddypGjcL6XyqfdZWj4pDO875Ca4dSTb6fyFCPcTeRj1HMClhL/AgbR+K275kqo3ly1xjOsShJ3AFS8drOf2i0D3auYuzoazJ7SLoegJyRS/M0z7u+SeQEZp4IwQJ0eXJ56XkULqN/J2mB5h/p7sku0uKu4v8jLPsvKn0gAH3smJNFMnh4iwvtGIM3dzCsAE3uPMIwGT7Ypcgr3Hr1LtqAWr1aseiKFOeSZLSv2k1TlKFo7R/jpidpmqbFaWGaEsa2SWgW+tpZYs0lyOA8ncHuUhTcZTpHp7HlLFAFl/1VelR6EZMGhiGYM0k/G3Lnwnt+8Nldmt6lk3d+8BNf8+zuTvEv/Zrw+Hk3pU6wQdg7WvBE+6bSw8xrkn5NNiS4KV/CAqP7thSrvrKk7HWTE2f3iWOJ0+hk/qOaJlMV+ARwjAybcZLyPm4Ri7EdoQiMAzVN3n7YwRegJ0lYYMSleMGLOB1RwtHvivBgxsqLZYsZjtiLNsV2h5e2YySVJ5ivgRwx1gmBUquMfYRIqMYLDW9tI7nRZyLHu2KGZkLk13mPCZ8nXknZw0ATU9zESRkOJxmrPRsQR7YqYvyYFI44KV580bYN2L4NGHjjeaDGcyj96VjPTr8iktDHeD8RPzBljk5BZTDZ/W8h74Q5/MMcnuHwn4lDLvcBFHASwTnOzaGljFnW7KlChk5CIQM6lP6h8kn4Q+L3V4Q0h/CXhB8QTu1V7LHNRRVgGB2iKMhV0Sum+4iq2AvoDkK/pILNA4SHKmXIG38Ex39WBp+SUXkhxz5C/AIDlZuc7i6CRBHp5l47NIWfUt/PJCrJVD0v+iNDc6ru2LFEtCPaiHk1vuCt9/A0nuvTCWd8qYHQ0j7ERsa4XUKwYJdpQQCAVBtYvNAFRUt6VmG0zNkCJbvSgzxv6rSA5lepBqn1Igdsnb9ENdCKkOPPMQ30f/Q/nns7T4SNV3Po2SIP/HgUBvyswRusnIO7xzylNrCpQ6ROETV6/C5w2aQlatCFnvR+pUfLtNqX/m0pT+WiwBWccORNKdekqDfqE1AcaCMz4CcDfhoUwPSNcNtE8n7g3g96sPHrF7/DAc7UDoRepypmcNEcMFuDEinWWafXYR4mEor2ZgOSzUt/qHtQ9a8T/x9rBdBHR1oBIt+/DP2TUdVprUfR7xuSRhpq+gG4WrxShmaNu90S61NbOyzQaxNuwZOMUMCRUa6AYLLmLHdlZyJQFwJfQzri9BqleKzNtwSGmfSghR60uAegdrD7T3sF6GU0NIA5lpUrRMR/76sY8sO6TFdQHCrNy9TAGBto5LLacU1QSoTMZCytoyktEZzFntJkth9FPC2KUB08ET57ymlRgJcb4VOJp+CIpwWO89WfJen4zn3h6QaUfDTpNKXDTVB7hwkHZDRKPOjYYfpRcICEhsgH1PQ0Eup4+mmiG80vIv1ESj+Rp5+jaShW1I1wK1ra50nE3NRAnl/sU9TbFpXI1JFkBt7b4leg8vmsSMxmeDHDeJ9CYAJQ4IvhGwMrCjNyXwXLRRckg1ayi6UFomwfmDuGDlZepEQ1bPE9x2eEXgj9WMOTtWFyaUvzbaHvNd98qPTBj9a0JZMM0QtRMtz+gOVkAkQBS+7pJR+ml/agJ230pP1FpJiwiI65mot+zVsVTKdEVGMfuC/thl9FAdwfaZZqNEfVqQ+rCkuWbDbCotgULTK1PNk1V7SWqY+gjJPWfg5klBDFyoK3YCCmEHvdrNMV/t0QwOSHmJhNaJ0SEBdt7P3zkL1txhNZDiKLEI4QGT8lEn0nXXm0O4bOgGPtJHbc0kmyyPgZTx4DMh/dsYRcIgmWd3cAToCQucKTx+Yqcmf04QI/uqYDhAjlZYCLWP0v0RJlR63+AoHrdJl/b9A1/n2WrvLvc1Tbm4hmzU1lo6G7e7IAElhXQlJ4JUPwyikXaF1naNENeo7WwftRwc3hv71/JrAsYYjDf5xvN+hZ2qCbeC6l9Bdw58pKMb8+/Ad3gHWHkIHIiAkoIuMAExFFigemzKsU/D4VBXf3oXxNoTgLEAuqMkGWVUUCsfo1KcU/RbI/RbI/fkiWF9vCT1HsT1HsjyMmq0RYZxL8KMiLiXfe+6cN7e+h6B1yoJhnWaZiCM9iKIarTgIn59fALi+oqQN/BupQsW8DRkmEFCtp6vv6jjqVqLMtz3sEmRPjolM9pwshVMN522ap+xaCZaqD0hY5YD+DFerAa2KVA05VVdIXtYGJENwC0eh/JGP98vUS4mWLnRdXaVNa4UazL6mg6vsVUSgwvqu6Nxab4gdMi0lrkVJujQPWr6J9/uUnCwR9UnOgo7Btwmt+nkBNwW3UuayUsTVRUSR48KJtSGJNlENMlUyBNMlhyWxol2eEbWSlAlDfcpKvvAP18sJwRirK4TWZphGmtxe6QbhMaQTHAk1R6iKeEpUM9YPCouqxgbQOQ4BO5gODVPAEfpwmE7CRZOjYZk0O2Vhh3WBYm5qqzkzK4V9KedT8vF1Q7NRJtG8PoYbn4KsgrKLRBtRxNcmSL+KkIF8GJeV+4PC6cCrueu8zqKIbcafWxlZDbUjo0PD9nki7+Ws4xFaxTbhOUABcEQAXeKgUAWO4UlvnKSA3hS40MbUUvy1BTVv2kwMSWJDcGteHynOHajUANaiwxxzAbHArG9zvhgJakQieoECMHBAzKuBqZ+zJlaXHU2KQIn2FMo0PIxuVyF4kdSON3EgzdIZw02yKAbQxxnWhjAZIoqEkoXeXU44pxyDTiS/7Yt1MrzGgkYX3aQ1/YskcfCI70t0Xh4kW9Q8yv8nORNGTOCguMOEpIc06OjOBEKFJdJKngv+OzG5ZQ/y26QooIHXKkYRW96e0ZGTCaySteDELYjMwpJVcKUqBjr6FUlC68g51qMrh2oLBXGzo6kskK1BLro5IOHwnAF0p+ltAv0P2DYbcDcAObeUDZAvFpSZipGSC4AzFKRLUJmPwGuFj4JG/sFlnsvOFbVDeo+u0rqygRvvNQJezX9E/V1aQoAKmAwQpraGeNUH/lu7UFRupYiNXbLRHOS9aXBPMvon5JoS/xlW9OaAD4PWpuONCSkoHcQeGmo/grnYYd/kI7nISWWRQ5XBt+RAfdXIDidzQENwFpFw7UpUR2JBiirG2zmB+c8BkOfX1kqJgBDl4eJ2SIbBHB2Du2S8CVcnr8uEcoFWfhAzSjA4yOlR6SVJqU4HfXvjANCP0cQ76y3NcmFqwhgT7q27gLAtGsmK7dveA6SFwS5UQJPClKgRhUHVKRTgQBWzDm6xBUIfKwoyAdjnCJpmIFnj0dogpoC9iezFw8JJsWGaAD/xxkaCHC0EWIfbhYRt/XICz67i+1mTUoQYBi9sif9IiZLdqT5i0R8Hhgym/SyGuoB6SdxepKn7pHSUS0bmoIY2HPGIGCcX/TBEhsgg0OcLqGyjS8FrINfUOFf0j220dMqjZ+0Ljo/k54KN5JD5aT8VH5yn4aI3iowN8LBzAx6cP/DsSHx1aEHy0DuPj4eeJjzk6y6VVgE2ctdGyMo5bVqfRKhd3nmJGlr7vU7VxfX8fQo29k2Zj3DaCChgGhl53I1/bO0nrvNn6A2E32vvtoYw49iN+ygYAoIhU8q8LKNoss3axWAt+u28/ZHs7J3lkVAdPiqjRR5UFigTqelJhIKJQPqI7h1DDwAB/WBOrqu2+bm9Tty9VtHWLAaHOSA2IwRzLtHaPbouHyNYb9o6j13dC5HxXqE9+iE2XCN8c8NZbRe7mxCsGdHN8y9RBX9siAN2hhKt8QyX0NUq3KGUGrTPkwbCFweljgQQYabmknjroEchXnso+RQlZJdKKoSJBOiXaOJJoqP3APC9kYu5SjiPE85Tj6woXOEi+2lwCDs0N2Q6Zi9yZzYLfW2zSRXT7eTxr8778wbEIUSaYFCHkxxgT3GSjG/UU9ENt/r0+nooGm/dEMJkxFfESzlREN5hADtOTriFH09NgJzljFvz2HtKsCnHaCCS3PqCvu4sh6tGdI3MCVwPWaEa+sKmfQ5vdWSa9BcyuBeybnK/UisKJAlqBjA+EcUXZJj9MzaoTfUO8UsJP3rfoDU5d0Ip0axESOF7vI3+JO6k2eNwmwgZ6bS63VW4OsSlaEikLeKrzqx20T3VHo7o/xNOYOj2VHRoqztRUnGmpONNUVkoNsMmR3Q4xH4a5bCB9uInC7I2pnlGKyNuhue7lN99lfsdmToi7rvsHu67yAdAHuW1QYIOGHzGhKgaoZzFwkelSoCX1vK1+b1guqEoKk0bbFua5SBF67fqboaOxcwEQXuSSU9KOUbzbSL80yS/lsE94MTDSYzBqkYw/T0y+/ZMVk2//yGJy6iAm8UFh1B7uIzBw6EL1grG6YEXQ0HeoqwITHl3NsV+ZWzcbYA94y7bwTkdRWtWdb2PMKxtmXTDcGoPhhsNwqhhuj2wEI2oxldVENt/AauDxi4UmGCC3rso8QS5lgrTrihnDOKJckE0+a32wUqheFEE25FVbow4Phjc6wBNTl2Jt0TXDeFcEuE10HUCvD0n0K7TasyuOV0oWVhLmi86zxrYZDrqYtVkpemUfJG0/PICC1kZ8YETyoc2+aahskwoMBeSJAFe82uvc98TDVPVJQl8pj8+YwGE3GfbqUQc94lAsj7mKZHL45sCiaqKBfOEtr9QW4Ej/AWOsFXaJNygy+O5bmwPvV/2stbhaUe7psI4eGFqWNati6kXiN/OBiw6SOKHj/HeaakjmTimxFaTAlJSCyrRP0jDOr7G8RHmvD2MzXcCmtz6sODPr0p0I3Vnn5rPB5pyHppjVrrSVGfYgV/OWDIsolrvCC4LPiNr7cnON4yosq45O/cVVUn7g5RxQ8VM8tpQkx4jK2IzifV+3d98KByKPoKWGCmqOdDFe7rFu7gV6IfabPM8BPKdXbbJB3CzQMkcSLo6368RBW6BqOghgwQCgzaLTLXHD+7tmwCQbgNaugx0KeFOAFwCuDQCMh0U1oouTiVN4BQMfnoJoT35PxCU/FrvUX0o59ZdizyhFszXQToHrzvSEP7qvYuy9hxv7WUw0+InwU1D+Le3y6z+E1zEAKnvHj0XqUKdPKYinOSCeSyBz9OHXRIIiTfwQElNKIik4JpqtgkBSaiiBIH4AazZTvGEZGcFgY+QIXhOZTa+eS3VVFvwF/Aw8V4xOy7o3xBIIgbapCEsUYZkirKYuBoo2rG4RsHsQURkQFdE6qHsEUV73+bHg3gA1/wio+U/7qEHqH/nUxyJF1AgSR9c4xThFwFUTP6SoOxprngmhL5HvS00PxWQH5vq8R9fbGWOoSZr4TyknCAn0H4kpTQhl+bleizAduCcdILKGXXWkiKwBkZkgMtJVQNGHEfgY+ZhHrueaqbsHS5Fb5wEIN5cQG1nRLKZAdko1XTCcwKBslEeouXepy3XQLd2OMVuUfZhVNYLp4IEcL9rskctb0Dxw5r7Pu+d49RITF0YdOVbb8KyWEVCkiFmtEK0QWVMFfi2lWwC6R03vMCMMZRG8AHvYVanKLCGYMhfVdQnDq1EAwC6aHGz/Iq2y2EGLPVrq0xKwB7BU4RGob2ZSD0hnnBziaXBdyU8jf0kjwjky0hWBmtKtvpM0cswdsbSlaFJXA8o9g1Y6pWgg5q2rfmNI1MN8OEyQOadMrmobrhp5bvIl+8IlKnRcpM2QOzC9WqihRTWupSZLjqlR5CAu6sDBGpoDMynDcAnQq/IYV/0AMwc//LhVMT0Ag+gwQFUrrdpob2WIXMQLTge669dJFXL9kLyf3pD4U0WBKi3iySJppnpZjetsoO9GbPqlyHU6ftdO+76O6ai4bS1QR7i/jSpKt9p5WQIijGYF83CFmgB8kzAzdN2UqRD+1FQ4aiq8Hb3bVJj6CTsVMPofJ1MBHf38pkKkUyHQqQBSr4PUD02FusLVTRVPwgJ0uKK2ejrArE+ZjqZGLW65KXJUC222KeBF19N+rrSffY60D4t6BrzXR2mfaoCRgm3c9p8nAidHyX2USN2b0WGSVl3AaGlvdWvzSNoYJe8tKD9A0pmSdAYI56hbe6kQzP0QHAQDv6T7Th4Cj3cByEF1ue+WSiMjZAlUm6Z3jh8hSzACUEwEiskqit6DhKpkKtZzRbMSKjp2ZK/23a7VRuMcQACZutKcbp3RpU1Rz9qLAFN0C3LQJt15w6p9UaWhu/7wZTDwF/lLoY305IiKQW86XwccExEqVpLl5igYXKeNWvRMHljzyDEl9vKoEv9tVWCLaFEkZsSUIpiA1eoPdqrqqLYMX95lxdOE217ChqNnr1WqFRVHCucFZwuWopTJu96WeKTm4s0RzQVss203mwdGXg7WKBeKk7HZYNjyqNDTnI4oaDgdWQm/D/tjuaIgmPqYnJ+9/cKxkHFmaNKVu6On2COxGeAeFKuGXrrjjgjp+bFLT+y1x8hg56Urzp/5vRVE4ets7Tuhuafoe147ZO4CAbrPg0qezkhFfGratwRyo3v7575s5w050Am1guoP6LTbdEFTRB1QSlOoYRV45Zwrip3dEHeEXqaYOlL31McxVHNVKcgs6Ft2VTtm1/bl7jqIyabMKiM+7alqveqAYGwkJJOpaa76QoXDjDo9f544p0SMb+1XnDpIDTXY1bBaiODOruoeqCxraohRU5Ua19nLAjtvquJvq9LjmauKiGDv5GG7gxoKmNzEfAUiIvGd64j1AyYveNDBcKE7/Ey5GhQnQtQZPSs7xBt7fySU4A+Fe783ZD1bpeDcPjgaDaLhICpYGLe3000mJTDBwPmOi9IG/3yAk5wIkQg/sDcbIhUhFXEqQqqAVIFThSFbCSwvMJmU3uYBD/95O4r6P3g/iiPNKYOLN1pqngN2t02LOrBrZQohtcvlqE/5P0cBqJzWwE+o5pST6b4fUkIkdhhopkF/WxWvalM3mYc6mQXoyrHVLa7uDTTtgSEU6hvopjgBSxcS3WTEyQnIQ3/aPPv56bCehXPVuCZcya9rA21yGeuV44Rq7MmcBm9tnE7YrGNCrWDV8kJk8UBz66rIplzV26ovSkYlqsN9QKWJ8jPvOSF98nvksgiZCFLi4QNEdSwRYk71p/EdEBLVQGI0KnMrEhM1HAAQIH1dyNFFpx1aGWhNjx564AcdwBhM0WBYR3uAoGve6SpRk3bizojgGTwtnUfRsjIgOWK5pJS4ILPfXNTZqzt8dJTmdZlTNcCSE3UuqJimmw9ARZ+qb2EDA2BJlGXnHugKaqVGURjaF46XKb/EER+TKhvlB6Y+hre1pJdtutgb4my2+RkwtiYYW2vA2OpPYWmtH0csjVv6QnM1FvTA1UbZWetodlYfZmf4PcjRFj5zjtYCrbcOcLQWSvK+TWsXQqhhM+B5W+0I3lYzbeKnnwdvI9583KPG3QemPsTm2kfP9bUvApsDGxdDRIOSYUPE2mfM/WrK/VrC/TCmfe6XCphyGVaqpxUG3C8f4X45NRUU7UOMkFkTY3Jtnxnm784MR1khhq6Axa56aIycHmaSSsQeSHqbj/LKdKAZNTXpK9LK0hw31bUqoAtc0QrXsqz+FWLgghBLuZPtrlCiXu/5P78xpyceLhPRVbqy+9gLsOSvndi1RCQl31vBbXQH7YZK3krQI2xdN/nKnXWLR0vIWhIG7y2DqzyRZBt0iXczZHDcX80TmzwWoxvy5+lS33SFiwI57EIWmfvRLbzC1VJX9JHzYKN/LzQX+IGKqit390Ej307nWvDK19plCKqXuNp8mzvUp+VtexHsc5N9eegCXQJZ8KTnB4iZHu/Mhlxwrj22l/XCDtT2RsVeFZ/KSzB+NfgVve/MLJGle08eGcs1GqiiMQquTzRGHboMLo29GsbzQ5FZpQuiLLhPTWr3lTBtijORRJZWiVNrQBQ9GpwcERAA2nIQZJ1ahtcx5QFKVp6QBg5XS5xapiXwPw5x/gXy2JAb2rWN8fciUK7btgvcv3nlhUZt3plqVYTYMq7vmiFKKbCZDkKPdVpaI4nTFR6AvcbjMFfcCOJNJVxN+LM+G/BYPcKFCOyw4Qa6QdfpBj3LA/6/bqM4kD0+C0+0BkiQGuI5lIx4DsEufJUuU/AEp02GZsAlR/X+IucacZ6ABgNA96Xzz/GdP/xHfJbmS28O+oZm6rpwqfuRn9BV6oJ9VWGZoIsKEMXvJje6aIKn4fcWF7lIm2P8C68ddhLruolKHegeFhAsUAtBy2+PV6RXTJv3ad600b0uZtV9atNdpg6VsLYYe6yUoDu42Ml8CXXNC9zkC90Qfy9UZGNmOu7+py9BI/fpLqhjEcveJOgfnHZeZ+5uaJc42S30+ApBVVGwYySugN4/XFA/6GND87zTz5xqg99eFm6IWFvUo4g9D3Bn7sQ1LGOYZn4p0+oGa6iuZGDWfi1VxB1eUQkQ4mI4tuDdAhSX1NBa0cXJAK4S1BPvwNqm0RPa2JvcdSJATJ2K2WQs3GUgwky1RYvgR/PdD7AMywE3Cge9ZZrfdz67pRwql0l2VZjSlx5z94Ui+bGH5ooGL2JtAlitgbBxiQzD1wYMYVNl4EkNeP6qXZUbgi6rMEqB8pdVtO6t3i26yEO9bAgTHu8FeMWf3X6vTSqGCHyFIy0PLV3ZcJob57irIwbfJT4VaGiA0QgYvaQiWYCl/c6Web4LwH8TyDZi/WjFdBTTq3bBYbqpflnMuGEOXkTWBnXUjV6cgk1DSEPEfBCSIyJ0q2aSfXeqFELfAxtQCsWKp5KJIWVpppbkyJFI8nRF6WCicxqNqV5cTWRUA5Zr/jDCgs7Iq0S75iUGwR16vsJvrso4QL23RszZqHCguo2QlD5B7Scx7g9xNhKaHflsPMm0Cu38Px/uufheCEfuUAILsD9T04FzugeCyBauM9iYqfTLmi2dHUPK1kQkM10/X3p84BWLauzLO7SqWsmGkPMrj6X4jnlxlJ5JOQJd2pSgo0HCgfpjAlQM3i2b4QHHMQD0J9crL74eqADDFLkIQ4jNtVKosqyHZlbBC92v54g/2PEy2r/Fx1YPvezazcG1SS/owsnFaxrd4TcOnG5Ca74gSukLKKgFIn1B7/O9QhmmF7qguYmvpihPrPVdowTJV33Vj3Z85aha4nwvJ+E5YnhuH3H0VvexeU2L8mNCiGKPpNr/9PHdnaFyV8kSEe3g8TW6tvNox11dZjU0r/qbJQomwhdlQcpkwRe0AJZQe81fYxwS0WtEUuhVFNqVkTzeQTEWtLjkL/ulZz9KGryvoumbpMF7K48syZFQkgAFSGlMAyZEGggx47pirhUPUNc1N6DXBlctv6RZ9KLWrQG39epja4l52ZPH9PIj+9N2RSyc6uLGeM5+iV5x7fywXPi3K/kXwOm/2taA5FWqsYgH9p5BDS7gSvQAdKZq6whBXdDMTDNCcI0yfSNCEOmJtYSRcfkR1TEd10AtX6rWNrVoRGC3L1T0/MAKSdsteQ2Uq81inlRf4ZbT4bawnvkTUzaDph+RNRNJK0qY0vSXOhGozoWrfgW6jPWCad2nAr03xK1dEcnKEoE3qP5M1qBVDR9ZrhZVMw4vF/3qMbxsoKoiMQIY+Eo2AmBiOY3JnRt4lf8v4T6uAIsdjDayNSckI5+k1xSpr0p27LOZSf3wriUQ5Jfe/nXH6KfJ41LfV8J09uf/3J97jlFOl+VHivEGSXkW7xB2yZHiZci7xMTGFIEKeYulbYK23GzR4DKg4vMAroj/NClrLRFPdQZUoIDS8NEjXfgDkoCZ7+7UL/5+3A17FVfGMCafMG/5XpkffuaRBphPDOKruzim7hm2LtdDH5/hsf3CU996DX2XCA/S8qzFvGXcvFak137YXC3SPVoGfBjY/N3KnLg7G1HMwRUwrhXUvUIXEFygiwgu0jJQuUybQCa9AFvOC3QXy+BdL5iO2GI06zwI8ry/z35aMmEmyfzFqX8qKuglnSAyveYvlu1FwpSIQI3+IEZ3I7KKijniTYrFSN7rg71CHEUNcf/usB8nXtPiOaXyAhef+gR21naCYE15L5eHNRP1Tgx95+g9mNmU4wav7qfZnDiJqY4umhj37vP1QnAOpfh1WRWFm0+4FyMhGTPBs+xAlYGrAU/wtgxZqzCJnhucgAgysSEb7cR7V/mxKQjVV4HifY3sG8WLerJpZowF8/beT2cFLOS+ZT2H9UbxvxfiVG5vjL9J4R7bgoItVpF75N7ORE1Hciel9BHjSMR3tAAuFEKczpHDdD9UqOB2MF6dVhjyLaMC3j8W6oSZQFKjkzhorpwMMdTN1CbQ5Wfhfg5xgxXO5ndzBJNqkhbxIRP6wVewH1Gs8Mt6rNud1CLbtqgbNek4D+UoVS3uji9C18DFGCd70/gWPP8ep5xVtSfcpegBHaPjdIJK0HH+3zEb2tL4DW1pSMvJOL036Dj6CIBS3AMg0NFESQTcH18olf3t4NaLgd7yoVaImngCoZ4YaBJKKf4Md+uw3JIJEgZHD9nJFs1QxJHXDbRi3mg5uPp49JsvUL57W2bxt4ZxqHP4gzrduK5BcRvgBYsO6KSAtwMawzoixIKcISNzAgXFmG+EhGLpF6lJZjsyuJpXfF5a9ECIsb/b2UG9I/dMxMVbPH70Ktj3IwyG71sM5drCExL199C5lMrKxT9bPll+GL51HHPnmyZ41BH+5CbUlGOYT3pFs3zMBD/gOEgSEsnrVniQ6LE4AVdWPJxFl3LEyohNSLcQm0SshFeL7js7U0iUcEF6CcoxvhH0OBUwf0/Q8W07BWI92TOnsDF7i07gBOG0O6Nny9tUxp7CPkPP8L27ld+JF9v2NJBZ/p1v2TO/2c5s4+tFt+m7fjPuzD1HheGLVrn1fxXaCk27I4l2lk737Xk58Qf+HmHvDGXdMc0yRHP4ulof3z0zVCEOLJ3n1Z0qWnSe+MUFpe0RrV3pyWNbc4JcSdR2Szztljke4TDcaQQrNKs7yBJ0eaucycFFFNkyl/DWC6ZBx7yCrwngzajD/VsircEBwKwLB0Z2C2BoP+G1tcZNXaFZnuEdrnRqy2xQy1yFYU7vMRNvW+cxsKt+Alia3YKOKF3m1fr6O6G94SwHmCjmWUdzV+kGZl5RDq1RkW6oXuY55rw3qWJuFcQfAMvRujb3HN0ERKdBggdbWhe5YI2ucWvurKztsiLzNtdW5no2hKuXAX305CwT0QsU0AyHW0oGdO4BVj7qMjZ1g0crUIsEZPHONEemWR6NsbFHHH/cyDS/cpq6IK6cl9StN4SZcJFpSiRxm8H4/BiF4F26aKaFbd6lDluP7KYzUakC3t6j5929QPewzRVuau/tVfXGPtr0ti3OCvezIp8V7WcVfFYBWaqy9+anu+M58l2aBkeeBgO9aMo8vouim5ugFer2qax0zfx2MPaYZzKyIs4ob5tpgktNue9ZdaAou62b72uPDhxUiaVP9Az6NA0CRNOsF8SDW3QT1HOTirJe3oDcxmoWenaT1R24vAkkbqMH5jl6lrMjUd8wSSldcV5R6eqO4H9uDF3dofLnRFc3la6UXuk8lXto6LOjLgPaeo7mEIDCAyWx6S3E+Q/tPTeWxFDkJwqJ3TxIYjffhcRuehK7+QUhMV5rn/OflFIye9a0IIGAokBfIKoGlwH1OeqBBp8J4T5BoD6hNFamgpw1voOQDxk/C9rg3lXoJs06+4jfwNJzqCTRXt+nOSjDur7r5jo+4uxsYxwtqUbzOiN6U26cbjqN7+ZYjTo/hjTWFJAeU4vJ/IjF5PpRFpMiZBA0O+0sJNhpT/P717GzpsBODywkt7nfXZI43caO8Tp33tx24ysdT6IwDHEwgSiikoAIRgG6/XQjAwPeD3tgSLgnVH53DJVvEusXadUB5B7T+jJdoc2nWFY2x9Pk5hAAVyGv0qoA8NaIZQUktkS1w5aV0oiUxTY58K5pyaKiZlZNAhEZ4s5xsZRM6QAVryfVUvI0vJ4ykVQyRSfF6DNP0VFIVSXKCa5e2gU1n2CWCJq+w+QYy45RXpbPHtCJfSXHTbedVw1jWUcvqhVJKa+ka0K7xEMcnDwc2FVH6cqz8NP3hvdtmUrj/+7/c3cV4HEjyXq6pZEUSzOWHe/Gie1LS98xM5OOlx4z88tnO/fF+wUWfGvnGJLHjNk8ZmZmZsZjZqal+utXj1qZSXwMG5huNVZXF3UJyhjrY6CUXfhFowFcEMaR8RL/7Iwv/d2g9M8npb/Ylfp4MIgUFJT+RRdx8Xt8iHmERfkBdTcPynN6Fp/EfRQmaMMD2S48kPXhgYxGPeoG/63n+ykfOwVHU3YRXx4ti/WWscGPDm5k4L/CwKxgLfIIalj+kAJ2ia7/tFfX+xnT7zrQroycKRm0Hkxaf7thcyONkMAf5edCvKcAW6z+rKD686arnxJUP2O6+pFB9WN7W4EATh6oh7Qw8ZhunzYCzZMzJlF2rDM+kJZBIK37dAcdFg38btryb9ADcXza8b8rNvEMMhzojW5Sg+Q6avgWC2r4W6UGovaWkKh27QUL5bGha/AmM93gf8MGL5vR4B/DBv/aa+C9lKhDcLM/Net68ELzCJzkYoZr7tBrm+PA3hHgTEn3Z80FBM1Zz4Wz/ugMsM6EDb4lbMBxd4Nx/67jwuNBr+umOv1nwF1/33W6Ouj0WdOgPDGofsrUmA/thnzfac+w9wwLpxj2YX1eCPkOzNMn12JvXv2Hj5zN/3Gvrl/KrgGP6B63hGHRJ8Jg0Fgu0iBcPXI4xmCfX6d3c/q89HEd+9HTYw+ajEE40emrhEzLf57J4lca03FtGDuYgX9xR4xymIUZ4wJ3wtlO9vrDFJJfLjC7AQJtDSgcGKwO8JNKIiyD0XFrI86fMDahJUVprdMb7bk2BZ/Eks1fFJl4el1Qzx2eIoIabzQPPVrjZiWrACbL4qvasqFcbjZXr9eIQ/zQY3IlWQqGgUyf6+wRZy8sCPnPfvCX7vGZI3i+YkSYlTrUy+HkT6VCyl7x9/8pp18YhMDvv2NrGLI9+lAnjDkhgJXF6Iq4HkXX1UdlALWViadhgCedRgCO72WzR7S9KuOkkQo4EF8hicHYmsRItK78D0B6iP7TobqdUIe5gPiAGubz8j/RdpB/vSqR2S//czvoMcagIIVi3ZnyBXo3AxI3D6co9MLiolb4SMVu0Prk6Ag37Q5v1ECe8DfQ5CkT6GB90XG+DDA/aER6vXBQ3nZawf7ubGhuOiBxiaIdeyPmUbd4bpfbfCZ5nf9ewDmoWGXmPZE0ET4hBvDvS8LXG+yC3geCTn6CT7k06XrzPvUqIeTcQMKdwlO7Wf7XC9swi4hwCjgf6qwv5XctB4hm6odta/aRib6OLPVlcvW/bJMhwjgbS+D1oUwCXnoV7T51DrY6WSMPWdyozDcQi42+PeBM4K1jgbguYJGOxMcX/UQ93qjmXeR9fKVLgdwFhRdRmjSClvRb5LElFnwg/PCcpNWSuuqqy9D4gXWK/OVSBLqxW9UBV6i3LdqqlikQDjrrRnxv7hADN4xuXdAARC8bXFGtyqDpVQ6O6C3coEgAyJo7iLhN8CjAy3+FXK4hJtqmm9OyK7Zc2k7YrJ289lp8I0FCJVeL7mCVqESe4+lxyOBaLqlit1YN3VL7Snzsg0b4yKU8rwefsViSqzm3hCOQpEM8dbymC0frxI3csD17S18+buDDxQ/dCEN1Xx7BUa4DZ5U5WVLGT1DIDs8Liq+SkcaSXsG9cyVcJgsIsuakTSqZVL0jVyCH/yKA9qsD5MBoMONgeNgtyizLfsFuxR2GE8R5h0XsJGu7rPHZiz8rHn6R8/DsU+ThAIXL0qxwy4rCgihMXK6Ii91i72ZG7FHocu5G3EehW4TvYtG/rbqG6GVr/q6YnXzRBQiN9RaeUBFVVkyxqXwFSXPmw1ItxQzVUvRVi5zsj1PSF8fkai/V8u8//W8/bWbqln9DjRRK8m+DTrv8f1+77D3nntrl+NGm+Hhol5fO1i7FLO3yMmqXM8ZEfjdcYMBwHzAZQYr59cBlSTSws4URI8OWlmETY0wHdGEp5ctpK4mOwON7pjCcvHzFpFxvcBF828X8f29mxtOBh6Hd0LhZUolc4qfYxC/D+uJHRR0ENFKElBsipFz5Dt07Fe1fRRL8IqdX27w6zqsjVDMldMwm8w9llGHNwzWH6K3HpPW7oBYgd7M2Ao1LZVZ+BJhqgUO+0HCGXUmbM0Y7xV3IYVzeV+cRebre6qdDCryGBu63Biw/oEQQrjWVS9xqXcEQAP17MNc5mUuW74fksUrHmwRIRnQ67MI2fl5ogqZ/2q8APfMVypWuzT+2bbqS/zUkZrTlPUQrOfxct6mL5WhVnEPSdP1eR8AeesFqN5uoAwk4vAW4ZHDB2YbQc3FAvgVRmQlFwTPyLiMoI2B3lfNIV+Gkdd9JaPeM8bNHzoj9UI0n5HXfTb/vmxplHyTYfvkgQs09XQxzihelUAHYMfJ9QNUqwr4MVHNf5L6qKqWoYJThURt4GPyEUMIY666ayxCeXXNgriXN3XfCZqkrwWa5ZNDADbWHG+kQ5TsZ9leAb1bbB+YiMN27JuUaltiliLAdMax0Cx+2RwGcI2RjQpERwOHFIAH1aThI/Izlp3y3SqAZQLxnCgiZ3UHxVrF3yJnJKw77SDH4/RazqdS2yTjJPOt9h1GB2xSMgqxEJPZNa8vFdI/UPiAzPQ9DGq5D+kwuCIT8zR9LMajzQvAyzjSnxxYFkvCVe0jCj8jqf/WZC63+IrT6iw/Z6i8+Uqv/WmNuQtT+AULWg3WluYN1T2wIu6G2YLmVaVFm2dBqC3ZbZvsltl/WArRfUqSzhdUW+d8bk007zvxzTBb6wVLzNsMTdczoX9LkD/EgQ/kaqkEeixP/xGvaQoezs2zcCb6sCFELu/wJspkvkxQGIGKcv1bRPsR0kUuo/JQ3HVCosd9fx+3GJLh8PdkEqMWhJ3T55L9uTfohrseG69mlCuY6QvDNiU5T8FghoN3i4aeH4s0ACA8tgnRlESRdXVLiIs2r6Yf1DAFCB4cQTLJRRfyeoJK7S2jL2JZj0KMgJjAiZA77AuHt6GCSApOgnSaxJqgr3xKgKw3QRUvmrdzCfzNmuAMmpP8tKn/wRRN/R0yWUUPVxVUkXKMlVogZ1nLEQHgxLkvmIhwxgVuiSiOp4rAAwnaSpHzsCH38UYa6xPgTTfdY0RAxVK3aZVWK+XPVIyltboqGyL+vR2MaK4DRltfY+tZqBcHuPpsEC96m9Jtiwo9IdrxhSnYMj3eyAxc92YFZoh1afCohvKhUXa5eJ0Fr+UaM2opOdA2NWss1SqluPj2aGZMYCWB54ERCxeWbMNheEon4IoOH+MJ6Wnxd41356ukzVSy7oYRL1lXGreRSkjrmfmgL0/oADSpMu1E952HmnYfFXs5DLPUj26i3TW2UDTfKTm1UiMK3o/OHK9Q7lO7GfZRaj9Lw7ki2590Rrv7P7RBxq/E/PBAmZGyyVZWqgVVlNATvyr4Oa4UWVgJamoXCep8gEd4jpI+VVDRNKUkK3EoaGtcxrJ1B87eD9c44HTbROmZtHkoT8p60IO8qBmRj1RaM+IimvvoSK9VT1+YugXv3f9TbOueK8n+R4wbcFT8yFwzICPdHRCOP1PZrYpLcDk/fEDwYk6+ADgCmGznbGkEuCe8QPBP7a5WjqDWXqUNLF1Gax0hoqsEsoYdnSJaLyXIpWS7ywtVZCGuIwc3Nmo4Jw9NN/m5jiovpp+W+flo96vXTX//ot/2VsuN7O327BCcdNjdltO+McmIfRfYcdXHu8k6ZYcAIZ3ZoikL12V9hYEGfJHdVdZaX7wvUMR4+1c85JWoeUy2vTtTy+/tq+QOXUMtXDlqRTMZqXevPrEHKyDfz6018EpcFP01pxCAVQSEYxD/bnWjyVxmz72IYLPfE4O0dBgtiMCMG4yqbgap9eFJ1Jqqo+XfPUvMPVTfTlE/xk0zs+QBhp8/2EPbss7MR9jHTSh+cEnaroUW7OmXRblxKK0XObjRfd1S7ReUtH0vddOuHoZu4lT1Buup1+RkTQSBGUwoqVnEI8l2SsxLv+0RuCOzpCct/JzZxMVpk97LaJHUxKrGZqM3YkfYdWIFSZ3Wi6HLHe323Ka9/nYlCsf6R33Sr4+62m4uhHu1EDzwpVMcYWKnIjw23z/TYQFmngz82tPacsx8/Wnvu2Y8hrT3v7J2L1p5/9tOJ1ioiFnco+3h9qMfrfQfNn4EO8fT3Lqjyu1F8qPnzGYX5PWTZQoqGFuY6dDgEflTJhPIcPNYQiVWQP14hb+81obFUOiM/csQbTSKhGyQmePQJhoqMkP9Nlczt2O14x2yPdqLtVvv8ohzeht7JqsffZ+nXDP+oWT4qm7y8ufFHzfxJl67/Ebbcyf8rV+qsOSL6jL62WEwD8dHcKguq5xTQOlebD6H2MpdvVEULspNq1JitaqQ3XlyE2EDNT6Iv3827aasaKxhD3KDDxj/FM24132VLGbFwyXq90OxcPdLoOtjB36hKIQNXPirCBkkdQEi1Yl4qwKbzUifNM05XAtlj/Xh3nWBv8cSj0aGrIicQUhuBBhXzRTP4jNEgAATio1AMnMMqAgjEhdUcwf2SuUZWDrTJqiMsfr8URLLUjWrBRTI451kH+WLxBRYdrFQnzhmBnQ8mpnh2z9EXWbrkPtFAFyfp+XMuYc5ZvaxK8oX1X/ZbkNXf5F/92S+rxaZugD9KcAjWit5ceuHydQgxFHI0IOVbIqlBma7TjYHNsbQd4UMLBciv0P3On7TLP+97QrPs9m3Iuw1Peujzn/UHk9X5+swtNd93HVpYt+TsM1ZqUO/PvfBJZvtJ5oUC1MOe9nNP2nnec/5AUPrqU89YkeR7r7typR3nbTtuEQN3s22j4XdnV6Lh8jNWqsvg84jwY9xiYyRkwOXciQPNA2TWarl5IJKD3b4wNs4hN6f3x1YYXukc6TQjcvBG9KobArlrRAqyd3FzoHfZmA5PtQX2SLTth9FITPwQZaHbiivwRaE84O7iJp+aH+o+J650ZbviY48/f4v9jXreXzbnb74FKkL9M54U3Py5eqpLOdXFomnZo5MMdDJ2qca/CrmCdDLkt4wuAc8fnT/HwYkDEBXQRaBAQ6VbLM+oru0G+cMnnP+BNuv+8LzCfoutD//GzUAc/2I7r6wd75cVAEKPl6oZkLiDJ2r5OS4nSOqm5RP4Fg6ijBxWf49b7HWVbs0BaUKuqiagvOwJ34DvmB8GKR9urNQUI+Op7QmuFJBQipuJVWOeMTJtU+VN+T/22wsNpvtac1/3txtq0SiiSmPEyva9R9BoWqUENkEB2EMLGqOJszjKbMj6MFbOz2mMgnEwUjgQhjHtMLKTk95GQU1aiSKXiYpIkMB+N8bej3Xva31kd4ii49TslZ0JsbPdRAzOagkmJ8EE0mf27rnLt6Qp0AkVG6IadOAuu9klK0Q6xignEuRrRgNVBXPQApLop/e3uDJXcCNwAhcXH79msA0eW+P0lWWzyVYoMplmbVpomlwrf6QpWURQsQ2JNwL8I+AoVRwdcmMO64dL2Gf7giAoSQ8FbF/g2F+4RaoM9O66on0RS8cVuSC0Y9DbeEY7hG+OXLGuOmskLVtBDs27H4UuUxFdY3bVmaosQx3T127BlRLv6GOjeQ7soXn276l2RjIb5KXEjsOA46oQaJU63BKFSyDtvoEo15VbrLwvu1Re+C3Bwn5jSpRZ2Z191aLM0bXTGrqRF9Xe0czt6TUdCe8IEm0+raAUt4KARUFAO8Dp64REJf27U/Iqb7gJNlCkzqoOZf9Of9rm2dfJWDW86cnF9acgUgUTYdWs2QJqCuXRPpK5ThLJeWBcaTQJMdeOhxESUGSqxhKHUQWJzbdSoHQOorFh93reJX50mmelqrCuzBPQdZh4PpyYxESGCsAW1V2AoTzjO1vv36hheg6Allnmm9Vbjyo20AuU+JmzOAEyu9HoLGIhjPp8ARYGvb/u206/cKBkvOBgU5IxbPO2STmZhKXvC0rLSenut3ely+sdLzmgYgTh40VzSiYag4mUgWbDEYyRTcVjehveEe64agGoXsD7SaoIxGxFu4lmicexGQysyS9qDbNCsNlET+/VeRoDDyqydXK/bbbXkhZPS24qTwj+dX3w0feKPu1x0HWIUY8LxSEQW/pMxkw37lf1wifB3Vh+n/StVoCS4X2itxkqfVNZMo3wjy4SSlf5goAU/iXXBcLRuC5MMOY54iE45jPXXQgKeqiojCkqqb/l+g7yrgK8jWMJ627vJNlnx3YbzoPVJSkzkyPLUcrMzMxOuXViB8pcO321S6cLuMzc2nKSMjMzM3Pt6P0zK+2dVJW5zX219hZmh3ZnZmffPQMNBYGRrDWBNFQLl7nmRkupiFeZ/yCRFZmtkVpiYex5aSZq9CaI1hrAVb647gismdUUEKO/O4idalIK7EZyEJTCwwszSB1WmES+GSLqwLw7wJi7o5gSl2GNhtftAtwgAkeUAvvRsoYhyhjAj5KD6EXvgoOAX5Q2PWyptCpDDibNGiYulmc7hx3B9IN4ytBmO6gwn5ITs4BkSFPAGDkadnmxjwTokXmZjCzACI931OLh0CfBh1TEPPyMXFnUSoNavzRIOw0lwHxjZ6gV5TgJ5AqrkO74byrW5DxommKimf9aiSQ/UEa6XbMxV/gXmaKNZi6yNQmH3/lfyxSkbhzUGMe41hFd+0ircfnjXKtLWhuOULeY2EJyYV6NtPdZN2TQZWRWDVk9W5LZoA2S81qXHiPF1KxqyVemDAy99JgCTrEpMkrGe6rqKA16kWYzynTJap9ElObFkLWrDZ56XZSxWKVAD23qGyMMf4Q0A7hTaTkRw/ZGKkECzJojSAhG4AEcCXDJpks3Um4ASEjQCSGQgLyUQ+G8PD/l4sBTq9nQF/DClzP5IS7zlWXXSvHkTUhMfP1od2v+OibVJptS38wdtQaJJD3lzrv2W2qHV5N+nn8rjfUKpbmeG+0zExZLMIrahk2/SXyVRegXw+vSu+w8fKdrHqz33XjGrUgPXTyN1reyu8DXKOTIogWZZD03NCARL4GH6MRypIaR3HVctQAMowhG8gdhCCXbvqtOLBArGlu2UEevuqfnRgpQugGRFZpAZYJaKDQMiVVlO+GRydDI+rIj63lkC0ZaDk29WbURAlDREAB4sSyAFxWAiQBApOiHiLrlpI84sSttiO7V4y1cjv1xwvtpojN+huhsR2PZ/c0TISxbrTX+PFhGHVaNe1rxVVaLVSOyiVaNpVqan5qvl+Rzd3tb1+kD3ipRDV1L8hGQT6UTHtkQGllfdqSS7ASMrChRdOtnKLrllBJAjcN6AwX7sKxuo5bQsIBG3AmPbAiNrC87UhHQjJGxX2+l4v4HLjgpImQk40YwB8r44cwPycyUQm+j2mBcMTsyNetG6EgrSkNMRjU4OdNNtd9qWlkMZfclYYENlQIhCGlSpbTIEtPGdTiREvhYO5GRZWNMnh9wHnho6u3D9sYwo/ZETstaZF8lZxx4zTM1ylBSy0KdxDhA3ocJosagDU1YPj92F/5p+zAQKZKT8TPkZDg/faURiTEJXIhOtkchO69FeFySTD71pNE75imIgAJUHHSgWOKEYdNX9dFckYFmZNxy8FoBT/sTq21JBCucDVmhEGYoDJbmmY0vz3ZOOWplH82xIrCMMyqANonE+hvQIEppINV1K2nq5Y7rSuVqmnCNbt2fiX8xmGXW//XQNp2wyewNmczusiZT7WgmpYn/kgTT5qLvOFvOrGiUfDyj2SAv76gyF1CU9sjjGtWWCI/6m7kzcmLzvAPd+7HYtJpYxI/vCl8K9fgopZsfe2DrVZ56rd5Pv3POoie8/trWPR53SE+Yd+UWr/z7jjF++rGdZg/zjEWynp+e9WVtXV3dpKSH8lqb0b/bUO0lIhyTsoObzcVoarp4d3J+OzQokqEJXcIgYVNFPHT4bSFSHWBFDJN4gX6EZqwAP+mTePUxP4SBdxuV5VHHDD+IesaHvngZYG05wcF1RM+B2SEc3QK5kMQAuX8g38yx/X4XUsaI0wbdA/hfY6bDNpo9eN/Zm2e9/oGof3Sl43re+vqCbj9965XXdJ/3fmKMhyH9Hxv9VesyWTOTl258TusGE8/o6f+Q6nHzDcYGfwxmf9TPeMRV8XvyoxMTmn9mhhCC6u4HZOcU/y/uLzZME6tEhTsGVmZjrobWwlVxaCOrZj/pZciQ+xT5Uf8Ot1C5lDayS831yP8QmgW7sk4LCEXqyuxuZESD3IdaB9wtMI4ctnXSeoB7NoLfnNdFDEsaWX36S8s6iNQMHTZuFUSwuXzhy5awI+KaI+jyBFAg0PRDWwDIDvkrG471aW9IGKl7DkuYtJnyJf+CgfkiFyGmBANxpE2XGTCEMenNiY3DJ9sCcXcENVBLCoe7Ui/3jKZ7bhxBnje7Myf2vrRRHiOtqdmAA7Tqw8qEPSijzN2BU7IuqbLcbY1BX5CW8RaN48/r3bjnVtDmjZ3X4/1dikwITKTBmw64gqpoXMx3SRkrZYw0sRL9zr/98AcrOucmfdI/vKc3HvPCfB/NgUP1vLjnzF1XvyPp+aSCVZcffsq/b2u6N7lVm9s+aq2Hk6x/qLe+/l9HR8dTyTbWz9fy9W4l6SX+GFg4IC3AnrCE3P0Pluiz36j3Pc9zcmE5238DOSvhkMx2PH/D+dOPsMx+kfjjxMBBR93zDEBVeBAgSb2SZR7/cTJ3lMyd31DmDsncCWSuUcZGvMKiH9V9Mm+rep8w9tKPXdp590rtN7P8PSdr28ZEEjwpgNlQRvzHNzQrIZ0/x2ARBYmjsERICtrLbG1pLpRPa23ZutokmOEEq9Yn2uJCIHOQaUQCmNazhKmVqpxDi/JGaAv2R1/7qS82NycMVrTvELWHsMv0pJmhhLGv90yI33Otgjdi+24UI+7pJxY8kIXZYM4/lvSkna56bhqkcVeSEpVka6TNwlvq+fT0UWvNSR794OVfTJ50fZIl1zVuD/ZGClwA0NyeV4x9p+NGAL378UUWmtp0S5JsDkQqbcCKMqzd6htnwGfJ3jfuoUPm3/jaLGChgxsjgUclfgzfw8NKZ7FWmvwnE9BDkuZsTlhGJzc0u/HGxck/jDTR5wUqFhVXUJZIxtlrHHhwauAh17tmOrLS1/Mal3gdNLq2RKcLuJMh4wVIh0+ZkOWG6WjISILDJSi/R8nD9FJ73NG2xSdLsALaZMg9Zi1gGwUUGWWfzPO4d/J83mapjfJ8Nmnh3Bl97RBwz0/XGR+Nuho8J6qhwHNNW+1g9B+HmxQAa/WpcQKFlkSsOl80U7kXslMtzt9TTP+q2KDYUNI4VjzqgVHoHM7AcrOpTwO0gsnI9BqtcPee1rsbX//jGDu8UgovNzR6ruju4s+lmnSx+8P/NrkWWHk1GAh222SqC33neBlpgbnUBr+cuKm0+eBtjxWtT25Gkbj1xXEXXzUlSd6TZz0R3+cSKh5y2+Rcd/Z+Kn6wMgsTRU6AHKKS2s6jpilaxIR8vK6+ZH2La6T+eyglp8KPNAosFKkHnrxpGrNQpM569bbPBD76i+IZF7f3oWjyiSJd3eiLrVMd1QfgqvM0PnLjD7K1tJNaplrWrhb0qr4YfM0r2TMBmo5dFJA7ARIAEvk+YIw6szTpW5nmPgnBC1198r2GSqtedEOyXVJefhHzgkfAsjP6MJp9n6tca2xk/NJZfNoPa2bsKT1ZfDjebktY1Gqppx2aGx07aOPlb24fe+pFi4w5o73NjbbT5MhItU2TdtsZajJCl5ws/NROI2bS7ATKcnzTsFpKeGrm2acYswFrFy+iJrKgdLPeSg09FIYsLq099qH/2xarJHeAqSh3QLPDCJ/FmmhR3sDWeYODpRjfoxp02gCjDqa5RRPM4ZCDx6su0kAZFlMVQb1OFOyFMicK0EQYWtSqkgQKzHhOMGBWQwI4ZwlsnSU4lLJ7BmzxnhJa1LQ6vgDS1ANs2bsMTeucKwQtX9FclHMxGpPHdX1b9YIYEj0uuv2sqZYySHOefXKe2JJNxFW3zcmhyNrHfgMFe1ECntf9YxpwsBReyGjZaKnFH6td69henNOKUoPW+xFBLs7ci1LtI3+mxM0WVDFv8qLK9eL8HdYuKaLXZ+avDl/vWhjzIq1IbIGkjOlDVzti+Q9WfruefJAihYQlkvkn/eCMnvF7rbg7YpiP9nn4tlT3zT1Y2os9P/ryvTevo1Xe1t2DyGb3LIpjVEyG2gxMmfZTpJ2ZLkXGC6MsC58YU5sCccapREVtO706b6o4X2CjNX9qnK+nISVvhB/GIb+uzcf9oWjOAra6GcjCtEmhnnIRnJ8uxGjqbAAApMWlMnEdehciObacemduZUMpvuekIFp6UmCpkwJb62g0OCn4GYEqsP7NA1XbzzCV1ndE7nZJ5G790sjdpsgdE4o/M0MIQfP35EhC6JMCUXRSIJw3rSjtiPSfwFoLVpqd72KS/kVp2wWqHl8ejuc/UkEtldKkFifjVsmqnfjGfBw/1NyhN76d3Gpphl8HjHdrgp0xAkRmqQW3M4I7LZ+geQAswayEWaaleoQ0ZiUMEt5OYYDWLLaLHYn8Zw063Do9P6FZW/RWw4Yo2lFUGSt+rSx+dYLXnauFU54UXQv0pUkPak1dC9SlQQ9q8yQYxSRAbuV7l2FFiKQRPLhMn7pQH2CaEIRTmHHMZ4elzjL39ABKZpDIWeCZUHWVtBOUtpNxOn+O0E8cP1X0Zmtdc5xLHjdMdR/Y6f0/Z1YNrE8NxINbSz+Lu1e4u0uD3ux32dxl/kn22M3dvQ+no6Wmp6IvkL6ggxbvZ6DBOl6Spzh8euv2O83nJz3+EZ42fPDl7ftLMO/99PZn5+j3e/Svt39H15z/5hWv3HLGC+fecPH7b9/yyac/vPLOGdMe/e4tJo8EGTeBFChZyMxAKGFrYPI7FBRwxW3REgIUgsTgBCMpbCmbzIEEU1/4GSJlAxlPHHjMI+ZiVd0GlIFugkCqgBsSwew5AQsgaMQQSGD1yfJafegBkxOpeY4k+V3PSuJJzUJ9ZjEtlRJiX7vETFCq2oRZAJOthPMhk+xldFBzs3Qs5r/k5WglMTdX6kCjdevKGhAXEhxKBtyfUGBXIsbSRD0auAgwcektLCRaozoIHCOFqn3Q8mZUpX4hsDTl0WzQdiiC2y7R2gVKQ2Wq7zvN4tNgLrr6ht0fd3TIIy7Vo44oE/iIA+lNjbr1GZnJvDyjFcyz0H5346wZRg4Wgh/GfGVJg3Ym1ln2Z2y9cySw2bY21hkgOCxDKurXt8YUkGwI3BwC0EKyXQuudlt5P3GkLL6/EtbR9yMEwoW0+hXs20Dm3dAjKiRO1IoPgXtYsQQUXhP4BFe5xFfRTk9TMVKIbOlo/QMDJ0CXK1TIS4G96cukuoFy9pEuvfuRx+9+uHv08ccef+bxxx68+zJw6ANZ8zvcWCzdswYELZSQ1LAWfPS5VH3dtfVV5AYevcu0EXUkwvIv0obV5xEiqRYwnX+Rnm94zh27TjAN9P886FYzxf+YQ9O+yJchHncnvILJPuQq6imVvk5z28dwxytghr3Dh9cKAEo8DyWryLItOx+YBeYJMoPpOcwxgQEnHA99+JKMUMPVsRYbWKmAUq/8a43Elv5OLmi9B2y78F/r7e3VCrwc7O9VMI2o1DYPjx+lsV7bQa8dKXDv2NWCBowbi5c/1mQmCyYtu5CbU4V7g1hES0V//+iXSaLuNcvS8BujdgEWxRo1ANgm7M5LWChIgyIMHOwmFKRhMYhL2F17SeklDBqlG4tyYJZuZFkwAZcyYYZSLC7/end47vc3PMXMO3HO2fli4vRx/q58H/uf7jTQKOhT/w9iz28GdMcmaMSnj1sf5W/1+9jnJTQlBEMT/Shp7IHQ2BMqhuBhJjFNsAw6hib8x2of4XLc+n/Wf9yxO9xszwBRAmt9ZCb0geDp3VeYMPZXmTfgsuE5wTy8ad3qxz8wwWwecWFjooDTTEgM814Kx68o+GcdA3HjHYsvnG8mnPSym+OOrBK4NuLfZD3TlzUTzbZZUV1u73DBqIz4xQu3rAqbCJ7W+mD75VMKBCsRZ6wo9rFuImrd9u+WfzlfkDfvy7+e5OGhMKWJUJ/u0ju4tUUQPxvx3faG+xO4BCNE36P8gYRg/xjEmXfDWndxiSBmWdMBkzUCZyIu0Z7f8aGReCmTEyp2Za3AGYjfbJtv6tVIQNaz7AXVC8fn2ohffPZzy/pG4vzrQ+tWmy4S5C+B+F37oruVHGKKwXs7PFOcrg+af2qquS2H6EtyUS4XF6frM4Tkn/HdZyqHsDGdOlKatFawPxtx1pmO1bENxKzJQ9dJhxkCj0G84XHIGu0G4obsUFTuxj58XM5EXNvSaUneM8ITC02VNppJ1wdxRktNel89sTrTIyJnrQxdH8T7pJ2FpOqJOaNgoCu/mK4P4mxdB0nzOmK5XfXTwHxJul0gHhNWMRxQS6i4RdvpXpIan/MGkfrInvUoriECcnwUs3SWCpyNOJupUzVYTdiw6uCoTj4mOCbiWR3i+Kpq4lPRzpZjvmsKxuVMxPWGIkwPVhGdTUVTXnGkBc5AvEHieMyNSkLkx5sbRMFY/RDnzZnklVpBGO89dJr1ZpwugR5/6fvZz8sJm46HsX92zaGvP7Q+iScVRsuIzXpzordFiY3PeQNI/vc6u9eWEQFmQiyfNgmBsxFn1jjKHCglsIuq1kUzFmuOy2MQZ4lJ/DpVQqgbSB3wuNhP92+I94l/O3irmBAuPbVYwW81XV/EGfLN0jlFxO3YuUvimHLjc230/A1Xr79gE0NmH27ethfVHJdLIM57oxjYQxADyrHmBufW0PVFfIIMv30UEhi/oWxQkdYcl/P6kevXLMDAEiemFVoZG834g64/4ry96k5B+URlitkH1c1rNMflMYjHKD7fUZJL2B2WP7D+6vzxORNxRrd3Y1828fqMctWmO2vp+iMuMQ2Elj8hjCzLrc0miWuOy7XR+JfffrHlEfF2/vfa15YbxucSiDNjyY3HHxAisQHnLa8uoOuP+ly2gmgmEei/0TXKRHZ8zutDfOmp1q2pxP6Tz7svu6wYn7MRZyt9NT6bSJD3BlR2/tpQMC6PQf3vPM+oWCLl77VfciZ9wcblTMQnXJwV7hJNdIlcv7qWub5gXM5A82sWWp53h9ic8CPYwG8d3b7Q/X9lJbEDiIgE7terYm/xcbkE6nMcpHk3iC7t1zOhY2nBuHwC7f/j3zicTSHudW7hHCZ8kIkMdaiYQ9cHcWaw8WEJFjQOd0wzaxmbX6H7V61bs+cuqMwwVcqPkabjQ1z7vZfFlhg49KLfnD13In19kMj+ck0ZNnGwbqTg3JlFG+jzI86OXpASkgTX1po23LpE56+NemvdmZo0EFr3cteA3TK6fqhPYyt+yoArGlW6WnNnCZzXi7TvnRyNOw8gPGrmYQulsfERcR4n8UvBI3ih8ybespJufwzEY+4cMP34BMT+sMCm2dPxayPO/iTKnZADSr2RyX5iPZhgJeLaJhaWynnweleBuvncVXR9epD40v0q/3wK3XbDMkzWfDo+xLXxicY3ceCmmZZzdo7NDxGXEHXdXFEIvB3vMu3YsnR8iPPebA78QMCI6D3d5ypj/TvqUi7+i4tgQEi2/iIlSbf/z8j4teq6TEoRqISqbfdPpOsTgzjTY4Y1pxjuPf6rxjFyssCZiLMWZv06XgJep/etSpIvxwTxIZ6l7KoZWAoXs0cMLrnS/bsE6ve6uqXKoOKaffcHZTp/3qd/fY5voY5ROVyUwzb4PBubPyF+8pzPvL5yaJeM6PabO/b7I6633d3PqwKmbgs8Ocdm7P4D8QmbP2cWVgJnw8cUA00hur6oD7eYmlbBidEY43UDQnT/izjPG+sNrgZ7ycN6207T/QvvIzL/MTN6qVgDKe1pOn6qMwTORpynoebZUAPZ8wxMSvfJ0vEjPqev/OeJWmiUuV12uqcfF8SPOKspS/NBHahmLRyWHpWm40f3fz8661A9KAxtYUjNK8YE9Ud8QmtX+pd6mOv/9PhCyWpcsA7xrEeOK0KfgcLbGdU9Ncvp+n/4140PMNRONUCgTu+iNxHf6P4dcYa1rWxpA3z8hC3yWSJFXz+If/h9fXJgRV/80VmSdPtjIP4trcbcgQN/LYofrgsbm38ibmd6NJTgQE7BLv3ehLHxFfHcWU47FjTCp/yd+W2eogLnvUfq13K1r7ARhqbo7f0RIU3nhziD296/gAu5mCT3cgf9+8YgPqfwvK0DFyov9GfVOc+l80NcQfnCwWIumBdMyzbQWCJwBuIfmlc9XtoEkTxWz8YuYTo/xCtPFfudaoJzz21F6qXk6f4RPf7iKF5VE8S9FF3uJSFHt3/EY9SEMlY2g0nFsb9OFsrR+b9Drs/KQ8NXmoHStiB708Xp/BFnmLwtaG6GluNxwtLTRQsEr1VttQWoxn8V/vu5wnlCXSMKDxueUVDwz8c6bwEzELzECZRZ/Oz3a6DFDXG2v9/C0EltHfsaYnWp4AOJJ0Mz/vlmolZvZ+Pvzyjc1HXCeS8M4b+Oi87EzWW6GuGYqvLPZM2vFFi0vIyYzziFWzMvaIX1UMCx8Zxz2ZKFu99w/rCwk4L5X21VDzb6YmfdF3KzXlHww//7Kma9D972tXW9QwMF1pXvrHWGGVhl+LklOyooCOUqm3XFsjDXwfJqrUIKnK64WiSE3cFme313NH5CwS9qJGjZE39seNdpmaA0CjgR8ic1C7Ww+xyuUk8sBdOdWV4qk//El3P/zrQJp2BWgbz0wcO3cH2zeQ0Tgykw/KTjSzH18FpFR3aBNwWLhprzVlUF4jzZ5IwwFwoyDc0/dnKZmL5/fOXdyxTsDo7/tHA5E7+ifw3LPU2BplKbYZ94AP7Jz1ft+58UEIfmg6+XD3au5sRns6MUrP0893zEq9t4k/kUN54ZBQx5da3hnjAsJc9O0dOAgkg1jxqX9wH4H69+rdQ7QIFfScL2LSe8see+R25q7KTg2pSurKmXmdjtlmuBe4CCkKSkzhH/25jakXPOl9X4vvvswBJLTwwSHurWK1Iw8F78rswuJtZ6teP4DhkKLIVPwZXc2/hfR7+0v11NgWKqiFP7sAvW3ib+JVKMX3/ixLJwSU2c9ep1w40lFDwWnXHaZZMPNn1yV4L7PAoCauq9ghY4Y4fltZIzZ1CQnZp14NwBV2xhjqLo39Mo2H82rWPiVg9M8eX+XycnUrD3G9dic2sANrro2EPhXyRMMfPXYMZ64P3RQVZlX0mw09tX27s3CK9JVt+U2E+Cv6z+8m9CobjNy6lOGT0kNG4M0frAOYUPR3ervHlPwsLl9Y+WLg3Fu5Pml8h2kuC0Xzpxd7Q7tlJl3v6ENhK87dddZswLxlcw06bseE2Cmdfi3QGJxri03LCk6HMSloftsQ3fcBW/k6T36guHhLlpxYzeo9swWS9rhnA9CdSxaRoiNrcxowl/9G6pJuHS5Huv22udsQas6Mn9chIU5s0G/9FgrI37ok+6hISszMtP61nnMSnpjc2vCRIu8Aw+F/wRjM1sHQl9iPPziT01QSUkAE/cEHn+YR4Je2KDW2rbPPGtNs/uv84mwUptdkF520XcRTfysMxjEr6aX+nZOc8Dnx1kUR33gL//i5ElU1WDsddSTzbuyiRhari3fM7dK9hIxZ2meekkiBis6Gg/ysLWG+xuFUol4VP5Uj33ChUsZ6eJ99pkElTZx2TeKYVguyXTF55IJCH6fKj13i5fXKTlfF57PAlJByiNMmVf3N1QPet6HAkZH2W8Lh5ywyVKalV2xpJgbHz4Ymt9ML5mpaGL2n0Sji29zkyZY4SdSd7fZHiPhHUrLQnqUTBep3HDJiqGBJc8Fc/0eX/ixOvp5+bxl8lkp1zK9iguv+w49jCaBP2bPAPNFibuFqL//Rp/+ZmW6fVj4hfxs1Y9H87xl7Ou+bD3kh742b/id4fxl73fGYopLfXAq2y3Hv7MX+Y2iVjWRLAwsGjTtecf/4/4A3ktSldwz4mfzyzgx+PAtjUY6QnBlIoUJvbylw0dn6e2fz6OHdF5tnGQH//WZ4/ky+7dxOct0zKQ4uerskmjP9s+GJ9fvz/Ui18PsdGl6m6WTDy9YtXOZfx6ORudfqnXFIL3Bm0Pf5VEwgTvWWa26Sws1Mb7VUUKCY8/9RXJ5/hhb2Kkt3ankTD6viyCkX0c993+ZJFSJgnbrQZNXL9ewTZeWBia8YAEV02xRHGRYLx8NHC62WMS1os5+uQmW+DdZXVZm3JIMMljXf2+yhGffbCyZns+CSnfh1Zu2xaE6+m0RbsUkLDP3+aFY7U7ni9UfbKfTYJUfaDMr8xTGKsv1iWwlISnZ0TbVRudsFWrOpcerSTh6MojK6eUeeLHuy2u2NSS0KzY0emxwgdTlt3bE95AwsKnOJfzNBC3WKP1cHIzCY2KZIRiLQszfqQwP+oVCY9Mzzi72bthxMglQ4c2fr6R/nfq3rrglwe5hEMnCZ7KNUEXlvli6VzT0OgPJPx4xdkbcIWF22T7rRciScjPaDn8qsQQ/7lQN/f+IAnaXxM0Z8WxcHWTbr/T3/n1D05XG3puh++y/DlwfpQEVW9jhw4yEN877Z5C1lQK6lqtRF+MnsUai/axxGZQkHY36MfPgkBcROyFWfE8Ch7NyFTIcD6DRRx0bw1fSkHISLS5Uqc/drlh1CpVgr+9iQgngOeG7eMYyfVLUWC7TEcts+4o9uT9tBAneQrslgY5bnCwxexZVIvEJgoan9S6LvFm4j9KLAynAwUnfoyCRXoAftVLaK/sLgr2JJ9Ty5jJwge8Zgp76lKQKKSZ4B57FvOM+9myxJiC2Su1JaICXfC7rlWLOhn88wcVNeuZ+mPuSm8mv7OnYJ/DxDQTdTeM8XjioOQZCsS1HgtJNrvgVuFXlO9cpaBq5i6NPGkvfP29Lwt2elDAvanOmJJ9FvsKPu/lWBScOh2p31Pmirnur/ipH0ZBXyA3YN5wAP6aFXc/M46Ca2dXddzN8MP7bf1ld2dSICyRsgUv8cekTK3J5fkUKH1OLgmRccPu5DtskimjgHTnKCYf88a0dzibnW+goLdToyt/kz++oDAifeQNBZF1gQc0vC5gL1lRfxW9p8CrlrGlaOohrP9UgEzx4H8QbxXgbeRMNKU0ZWZmuFz+BePfelehtikztw4nLjMzMzOGqcxsb1JmZmZm5o5djc/W+Zj0+Xmy82Zn3khxP8nb/HQO5TiO5wRO5FScmtNwWk7H6XmO53mBF3kVr+Y1vJbX8XqBE3hBEERBJagFjaAVdIJe5EReFERRVIlqUSNqRZ2oV3EqXiWoRJVKpVZpVFqVTqVXc2peLahFtUqtVmvUWrVOrddwGl4jaESNSqPWaDRajU6j13JaXitoRa1Kq9ZqtFqtTqvXcTpeJ+hEnUqn1ml0Wp1Op9eDRD2U10NqPdymB1eTXvpe/buFGU1dwru61ec5ozGkX7+gYFMfntcYjT0jTZ2Ndt6fCdDCz52Cevb8xQiBgxSmnwdBUfvjQOuF/ZkrXAicq8fPQPB8p64RppDvTxit1xpTlz5BnUzW4IjeneEJodUpOD4LtTkcH21aHWKP3l2sT2NpCB34/xyotZwoI8LfRqcn1CpuzmPY97gshFolHTLMOPLpK4wd8pGhQ9WLB1Ql0+K9wk4p/ckhIT52sP9KcnlEpZ0DHpjJ8k5hU/wntyUNKtWbc2n0cjJ02+65Y7LdINsKTV3reeot+THbAFOeAlcI5h184PqFCPcVBl+31BvW/DcLhHTJqClGHqev6L8lXxsScKbxsYI/DiObsg/Ztnn0MGIIWZX0ILYeSRfhXkzzcQr5uNG9hd/99aTAtvjNq+PMpFH7rhm4YXPt+S8vWZFY5lMVaeDxMm1eQ/4JK9rf294nF6lyPGFxraneRFvYs97onc3JbSlpytSatcgid1V0QJg3MSY+zyxm703KndY2HNRmGrnPe8UOPjORNHnsNajzi1b2/K/8mr05dX+QNDJHH7MP5FdWTn2/6UV6Eprcfah2UGVyY8rQQklrePIltVd8QJ385NKj0xN2dFWT057v889sbCTnL8acPufRmSSPKnxhQMd2ZEaj+q/WbC1N2Pl/ad3/y1stb/tHxEz355Q+G241ObZ9rFKg1ztyt/xepcOiY2HHEu4qtw+3uZLgGUqKjDp3LHi6mcxrv2n1ghZu3kUWjenR5E0F77YrivQ90aK8d+GU+Jym93lS50VFF/X9sHHH06GtDlrz11mR4cCd4qWV1VsSO3V+Ha406Mmb9vSarSxO/DzuZmScsjZP669rGzUl+ncD7/KllpIqR0JzlMp1nMw9vjWlc4t7pI5m0NGMdS6SjFFfP3l1Xas02Df1ZPJRtbnp45WNHkL+r+fTi2nd8ioXCrZL6/6ormI8XbjmybGdlDfF2hq3hHdUbkWcPFTudE0iPeGVhzlHkwWDpvjVj0whCU1LJGxdtoHUuXoqx4Dti0kpPmuVbncClRMV9/hVfD7WnHt1relTpK2WC/W3mUZldFeGTotMvZEsKim1c1+JreKvNO5yVK8xqpWvoSv7TRhnIFuLj7gYubQreRsVcCTT8rGkinKqVoViY8mpc1L19kNCSMd7xe6OOZNPwfORs3Uj9NNGrY7a9oR+t0PoGZ/am99txYLeNnpVHZtN8hhps58mbbdaZZLw1morV6ur8oGo3n0z96R2Hdhzj55oX4HteeCRWePrNi2S25J+oK9ba2/zuuuKb+k9G+5Xq+zu1+lZq6DGfev7udHBAwSACFAB1ACW0zgAhxavmVgdQA/4vwuuGqA6wOCCkwAygLjgvAE+AF8XnB/AH1DDBVcTUAsQ4IKrDagDqOuCqweoD2jggmsIaARo7IJrAmgKaOaCaw5oAWjpgmsFaA1o44JrC2gHaO+CMwICAUEuuGBACCD0t77n/o1rHGGAcEAEIBJgcmIrE9E2ytHlK00WzLeOIuTwIevIT21u6s9C8M7cgA6AvAAcHQGdAJ1prS4OXFdAN0B3yvVw4HoCegF6U66PA9cX0A/Qn3IDnPRfk/+CjZp87qnVBnovfWLzr9M9sl0P235Ptj2VrXvLakm7H67YrPusE7a4xEJbrFaZG/zUFhe+8IGNr7b3uo3f/G4fWgv1W2ichd5nwbpYh+bFehaqx0J1WqguC9Vhy9Nx2mObjhuDz6FFv92iH+OoH/vFutg36rLXQX1UB+rDvrFP7Av7RYvzhHF4H/aD+ex1UQ/WozpQL+qxxS+JuiNTa2Gs/Fs89oV5sV+sS3XYdWHfqJvpz8L0h9bCzA/eh/mwT+zL3i/WxXpUD+pl15P9fUAe/RiHfqyD/WDfmB/1YV2cL5wP+3oyv9/2+WA+Hxbm84HrjDqwHtZx7Bv1YF2cr7809N7PPKuMl6TuH/zqxPVsbN4zos2SUV/amt8eMw33qtpcSi4R2LJveT/p0v6x+Srdks3a2i0+BFZtZN4zPvPrGa8bmtuNaxa45YlRmjTYvYZvicaSV0y9K21rBJgPV2iT6aSqvUStmfoxDu8zY12sg3lpPYnqkahO1IU6pHnGRpOKhrWXLrXyWty8USszteg3o0U/tejH/NgP5kddEtZBfThfOB/YN/aJfWG/1KIf43AesB7mk7Au6sF6VAeuD+oxWzx9hKefAiRqzYyVfovHvmherIN9og7UhTpRN9ufmekPLfoxDu+z58P1RT3YL9bFejgvqJdZT7Tot1v0Yxzeh3Vw3bFvzI/6sC7Vh7rs/WI/2Dftk/18mJnPB+ZFHVgP66Auux6si/PF7nf+2/Ff6XhmYRzkv9HhoThf5yb/zbyXVpjrf0lHfqaOitHBkX9n/QWmTi1GB/mHdBRn6tRl6rRl+Ibkn1l/wtQJZep0Y/jAv0lHWSZPe6bOQIYfwfDdyN+z/gFMnv7OdYZNZ/hZyGPAn9RRkanT0TkPmcnUSSDMNcNPI39u/Rs75yETmDzLmTrbGH4zw0f9Th1VneOUPorzNdPvsJ2MzmNMnQOMjtXkd63/sJZMnXnOeQLTmHW5wOi4ydS5xOhQfkGHF7P+w53jojY586UvOfPcc+b+N0ydJ4yOY4Rdfzy/4D4Gzx+4D8HzA+4j8FyE+yM8D+O+GM8zuK/B8wjuS/AciftJPL/hPg7PO7jvwfMN7nPwHIb7MTyP4b4Mz1e4z8LzEu6b3H5h5AMMBBRg/O+T+4TvaLxZHiT63DmQ6YTcI9F3QYWGl+XN906Hx+2+KXfsEXfZ3/OePPJWfjVZ91Be/b5g+Gv9E3lIv3oVPZOfyp/q5bz3QN4n51Ku9Z1k3Ct/6t1628OE3bKl+oFibyrslDvoVvyw6q5Fbpm26G79tpvlthVTY9ZcXSXnStu0/sLhhTLqGAQYDBgCiAQMdVx2wHDACMqNdOBGAUYDxlBurAM3DjAeMIFyEx24SYDJgCmUm+rATQNMB8yg3EwHbhZgNmAO5eY6cPMA8wELKLfQgVsEWAxYQrmlDlwUIBoQQ7lYBy4OEA9IoFyiA5cESAakUG7ZTxTJCW9WpHN+wEOywxuA8XuQrPAOYON/1e/hIo8H9bsx8eh3HOh3/5n7nfxr/owu/O6/4UdB6Lf6MvyCPz3rh7EcsAKwks71KgduNWANYC3l1jlw6wEbABspt8mB2wzYAthKuW2AY1tT879fvlAuccobXotlj1KDnqVmXiqPyu3jUWZUlDxnYNGgLYnRcuT/oneMehMjD8y/sub1AXFyaJlsrfb5JMiFxwTBK0muvCp6+5gXKXJJ21gp57GNNXL+amvyVVuzTq5RqF2v4/6b5OJ7u8NruzyjfAC80uTv3+ful5vZxmmZ/fd0f8Tl6tE5H1TPLb2r7lEmo+GgIYeh4vpChqxnyxl8CwoGPruvQTOrheH5s26G8ePGGc6PX2yY5LXVoJ9y01AhIK90+FBdaVlKigSfajmddY6/v9mAxjq+69gih9vGGWrvyN2hUmy3x5bGm0uOftjoHFr0y5CXamUs8336dsAOgNkFZwEogFQXXBpgJ2CXA5eOAn9GfGPprAKCMLQG/Fm0LWU3IY2Sk7aHDViIdElOYZNUFMWaEnZLh4lBN07Slga7pnSD/P733tNPp8/z+c9HeWDk/1gACOm9hslqdwbkxHlqIUP9wk5sanP57WwUhieMsV33k4yGJB5YF6HjPpdnpkasEGhC+KsSU8Of8m3aT+RuT+WzXhydi/ZhkqHEhS/7SZ3viWGgFa9OarMhRJsLHdocsdqPbG8WPTN0aRg6zdgzoxiv3IzIliO4zXCjMlAD4VIZlq55wCUHfRS/WpEus5sP3x6x2K+Vbm1Bwtcfpt/1KzNuWyFkeQyVEeb4DSylJcmVmZmVaHSc413CNLZbn0RoykcOnLXnyiQrjhk4EVw1hMwfpggIqFJiLs7j+D/we7sD16O5SBcuo9yxAOHPdWwOkeeITyGxU09hcrMeaYunxOiNYpTgEOqB+uSrfebMmgYyAtSYv7iA6a7NXO7ZzqIZOgS1ldB6cBr+J2bhMtefl+59qCj6Iq5rzL1JxRRIXySlMB8FU0PEsCQ0YCnvvBQ5X3wOdRtIfeZPatxpNM1e8lqvi+vjpDD1GcDuojyer5Ow9e9hzy0LJMU/kbvCHN1X1cTt12LunFJeHfZly8Y5MCONVpEpSFc0cll1CIfpLpy1sCa5fxmBQVXMtn+A2ucwPubsoLmwnJ0awljqv0Ci4TWbdBtoOB/Os9myyIZ+5u0mU4pL1BB6J0FTQCmSuWtpnxaHVNNWlCYuJGSCDSHLh9F5fCspt4KY/qWN5SuNGef4nMT6Km5YGeFiXYGIbDTPz6YiENvGNt8grueHYP3bIQ7/8Sc3j27B43UWirG2dOSUcmxvM/PzHDErWUJJtQay8c/Itz7GhMe+jJw/iQlLz1O4uZB/ikwwvXMSJNt5YZyC3IoPDL4cB9kDTI8sw7PiBxP1Ovm3NZi7nwp41CNLxKhI8rz0UBK+i+iSdg5NuEDSTD+U7l1mWXg+fmrKiJm54R13AtdPM1AtPcVfEisx/OstHY1hfI48zduP+zmreppD312xstIgY3AMy8+l4hi9Ey9vI45ZqnFZ/CGZH4Q5pjqP7l3aqIyaymixYawSckLhxyaWJZ5g16fhZL2aS3dALO7Lvbks0czxyFhST3bxdMM6KkXamHlGnc5VgdyxdaJezwoDyxEcCAvCbL0cmna5uFWNQ225Glt/381qrxcs2eiOqHAe8p3OTHJ4iYzgRSxHriVVt5avPkUc7JVkhWsA02TSOeUsR3FZMimTNnLirQuHqsNQ8F7LyOhsfAUjaVfxhAEZvnrF45C/ArumxZyuD+G6/mmMIwcZHXoUVcMGwrUvUu95FMkHnxBq1EVccwHbgq+wJTiCcePDGfu5ip3BN6kdWoXWibFslvLBJkYc69IMHoWlMc4gi2dtI1mxW4Zv97uonZ2ByKREwuYrYxfig7CuOmMiJ7NOJ5Fp1/O5+f0G2+ZPwC3fFMU9F8g1P80I/RCEW7pYYHAUN9WzaKcKIjZTnKqCrXSGF1KcsorVJTHEaZbzMUGDpPBI6o2ckLZtwOdoM05H1jNQq8mNq0k0iqvyy0CsvwY7Uwe+j3qAnL0KFuY5LBvSwaU3jd3Z7chGNJIUrILD0S5GlorTN1uA6vfTWHw3Gospf6NRLsxqoy9MzI5Gfc49WhIns8Y+nmd5MYjqj2Xrn+XM6fXB78hIwiS9KY7dgIf7W5q/wfmVmyiseUCiQzo+lZU8HT6N262KHD2bR0GKL6HLa+i2vEJxcAfJLcrU/3sO/W2ZPGlw48SjGcjX3uf6PB24eY6UDRHctxiJnGIqq4IDqRGMwydxDH6bryIxQZ66B4r0fRgkrPYnYdmDvPfZiUDCAHrBnhxwF2fw4BCyeoJYO6ojLxWKadbXX/d0k7/d3Ily1EY1Zyv7Xy9HpVGCR4rGzLNexGPPClRKH5Kzc5BorjFq53u21F9hlscybCY8I23bfjytV+Bq3sTZ9cNYa6bJ9JcPUG8tZKK7FZYq7zmglMC0OwVcVdNA6EE0X2+/QKJ7Fn87v0dmyBexEcEcM1BkTfkVZsac5e615yhbipDaa8T4mlICsp9wvjaPJMksSq7tRchlG0pmkshgRtCkFt4IhjJJ1I5Thsc4mN1AzaA8rvPu4xe2kFHtP0nLuYSTyxpWysezpnALij2ZvN5yho5HUYw2PcZMnViiLayYpH+bYK0oymYOw6s+lMcN98nZ0Ymp/XiGCbpy9FYyd3KfsM5sOdP7xxDlXcB1AV1yDRYhUOdH05IyVsv18arkHz63G+Jv18B5uyqqs1WJPl2A76YXOL8roqVmIuk6v7FUailmu614ltWJe3gxyUqWjDH5zlQ9I6wLDyI3+IVPr9qZ7V+Cx8lFCDUVMfT6GO4ub7k1WEyEUB7+lrtwTblDuftF9Lz9KB7vQndlAnJ/NHLvcToPWMfbO6PZlT6XDwE72FV1mNHiCuyVEiPQIZJhchJc3uPD4GA25kuaqQ7U4N/qiRxJT6Pw9ACq8TK0uhcQWaRBVbw5qfH3qCwbw4QwRTwsFqJgHsbZine8mpmG6/ZE9OQvMN6qjEHRlbzp6Oe4rhtvQxX48mI/A6kJNP94itKixyhrW6M1y4Qp1f+wd0CE/pUuKE+tYkPqflafPcrG2WXIm9WRW/wKUelTTPZ8iHOUHfO37EB//Q+Cxo+l4954Bko7WZip+It/8NmyjPrtO3A8fp5w9WYeSz7EetN53lhksi6kmCq9cdR7LUdxaj03pa4yS2Epm9tfU73nDJc25rImtA9zgQE+/HWDsNkaaKXMxjGiDrPPieybr0XJp/OsGx3NWfXbJLweg/Oo5djfaSHoUByHfj9N71MNZoXfxW/fSs5UzsLgch11y8x4s0sHx29G/LzYyPYXVvg5RpOevAezrmssODQHw3QzNrsLMUs+FO1lIYS9+8iHSy9Y0W/AkPkXpo4toWjzYSL7FvA8r4ixRZXUbrnBsqJQDhjbMCtUF4W/IhlnfRD53/0IVpiMcc4EDs0/wZ+/hRFf+J4PtX4U6uQzv+Mr3Y6/diA8B/vrC1gccZssf1Gi19UhU2+L85t6zkVKEy8XhVOFLMLfUzG5PJPVZ0rw3GdLoP8cxqapEdd5nEnmn5jVKsS9i/J4BJoSI72Oe71J7Gt8xal6ayQ0hv+KeZmQa1fx/u6G9rE97HuYgKvaNpbKbIWF33mGLwMdZgzbbErT/1FwF3BNbX8AwM8AsYgJ+gfzYRdPsPF55TdMsCZ2oGIgKsbolI0wKDe6ROxWwI4LZ3SnDQg8fNJsYzAa7v/s9vdzOj997QWIHBzl/5SUH3+vdzIlL0HMxl6KvK0ti9xWK+03WbZKGc9gtoeJ0jN8f69Qxp/aeWZ5Yk1dpmxZDyBRgzu/6Dv+q9nwrJsuMdLMkFz8jm+96R9lLe8GVGep+1v3O74UrPvXg3Jit3kmh95/w+Wvs8dapCgtEO05/A1/1DBauimUGOm7lKl8wzPXztBPtCcWia4UPPqKf067H8vdSbxDde867lecNUv4ZO9SYo5d5sruL3h8dYLdq/HK8EdDDxO+4K1WOTtPdisAPQpYFbbhC+Yahr6x/UH8PnlVV/tnXCM6VEh/JOYJ15dEfcZuk37KjyUQ30rVm8b5jK/u3aizV0As2Citb67An+0aS6JPENcZm0yOqMDh/If1szcRX6sMzjatwH4b1NcyC4hFc+f/21yOa1NfVs3QJu41X3g+shx/r1m2SdjZRfwhztasHHPm1ZSu+0EcI40oay/DeXfdxKapxOwq/ftxZThwdl0m/w7x+xM7GzaV4WX+X2aNuEYsu7JhRmspHvv3xMkl54mT9Zw3byrFu/VXff65i9iYvWb9vRJ80P/1+rn/KMOb12uqlOCB3glmbwyIZa7z71gX45Qu00rfkcSiSDWWuAgLh/cdFko6SfkBe+cbFOHmrWNv/fyqtE+Ink8hXpjOFlunEpd9LsqvL8DvK50XzrpPLNJZxNlQgFXKEotnhBDLpp52fZSPp3j4Zx9yJjY2P3NeIx/Xr3huUXKYWLzhgYF9HuZ82RbjvlEZPv618FsunlXIlFgZEfOOU++pXGyhedvZVZ/YemV83N0cLFplujKPRXzr3e7FY3OwWW/kp+2tcpJ+lsslx2xc/niiypivSmcIPauz8IKhd4/60ohRhaXhxiz8dLKGx5THSvvRgcmZ2PjNeGuHcKUt7GInZ2LF7X37+i8Rc+6Jdl/NwHj11PhXp4lvufd+6EzHqQqhX8IupQ1n51mn49Wj8p+8MyU26NnHLxHjt5zHC1kLlOHDFtWUGC8xK4pyn0As2EKn7sM4frBiqgGLmMOJGrUyDY8132bR1dZB3Gcao5eKz9gIdyp+EN/6sd227xP28t43bmY2sbWRgXv1R9w8p9DJK4VYMK8xU/wBv51kqMG6SSx2eLXxwXucynvrmRxIjJ69YoW8w29p6exAV6VNNnQ4vcWVi7cuDzlJLLh6XuvIG/zr6FzRB0viuts1Vuav8daKJfe0gPjW2W0/l77ClX1shyBDYuvsXneDl3jxm7Z5xpOIDY7HbNRKwUnL/CsHRhKjirPn+pPwK7vt2hKFDBDHdXNI5XNckrjgsPp/xOjyf230Uzz9vuGJ9RXEYh1OwO3HeFJMvddDsdIqS/dfe4jLV+T4GSURC77ZHrG/j1fp3oqpSlDaxiLQ6i6ubdyZ9DSYmDPh5G+L23hg3najRE9leKuv2OEmnihcHvzmrNI7d3bsicOGfW33JQeU9ik9viYKiwzLiy0siNGT4IF5Yfjxc1lOjonSfQaei4Px4yXuujbzlH5yePlEf2zu2DJ3lr7SbRmqOm44MmW8utoopWe5j1azxpP65/T8VSclFvl3Si+CU8uxjCm3lV6z3Kz6KiyK9UlmnyAWZGTdLQmH4ucSqns2MQoYn54YD426oap5zRLicSU/km/D05RCN8ELYjGr7FDgfYjXSLgzyYlY8IPjZ/UY3sSO8Qv9R+l90rNzn8PeOOvRdSxiccyfGOdkiPnk+odV0E7GR/O3YtdLUA31GisPI0YmQb8WvYYSq4FTz6yIxfuuHlB/Cwk1R54YziVGZ5e7VL6DYkM70wvyNjLeU7ave/oBVNwf3jmfprTmp1y3T3B+1Mrzc4KIDRqX6K5LBbX9h1Mj9ivDa+wXj8EQnPhp6Zs5xJzQhRNsxQCNbRI/RSug5DDfy5vSIT2qynkoi9i4oPjCnAyYt/mKxrRI4h3ZD76rZoKhqTS73oaYvZTKrM2EoGv5tuYriQUedis+ZsFm46nTt4wmlpXPWxWeDd5S+eWmqhZi/VnFZ3PgzhrrxVOTiEWn2no5ufBw/2do8FWGT1KIJ+RBkONoKWcfsaB79/zmPJi75alogSExp1dlxad8KJeH695iESPDKe1BBTCZqpqV+L0ZUBnLyvJQIYhSckfMfkEspots5xeBUUm0fNFlYmvzr8u7i8B5yz3JRytl+MZlqenFYGLemJCzjLiu9D0ruAQadtoacTWJRXri0XtKIeE7c31nQxOg93/pnNMqAy9UlFiCicvCtd7bl4FWZlqlOJaYd+Wm3ZcyGNCb+WSukzJ8y9KrK8phVNyrZ4hLbD7TVjOmHPaY2jRZLCAWFNUxveVgrdIVyVInPn3i+9EDFTD/bt2J2fWNgB6NH238oQKev6l2fZVGbL2O7aD/GTJmR9s+iSfWbzs/x/Uz7FPXk490JzZOGuB+/Qwaut+qCvYS1xn9liz5AnZvuSzEbgDq0NrQcyreVOTrbarIuAHMDiPzFhxCuX2J0EQ7GuDd/W9XHvKvU88vbh+JeA2wdfZuu5bBY9QL7dphRtgAQ1oHts719qLp7BMjUXIDsCqrzU+nB9Ld6VbTUFkDjAu3SJgCfpRp94hWRtoAu/6un6Qm8KYF0Ve0ELsRdrqPtj/FeFI6zbaDjFEjzLqaOqceBVNnx/nUMtxGqGB1XAhVuUCLbthqI14jON3YXWw/aEsvz/PuZ4SN4KemuJme5kM1ZBgMM0mNYHOyaL6eN49G+dDOlDbClCDPUQ4CAe0yaU4zI22EF30J5+eJQ6imuzfUELsJlm79Y1nBD6CEhuF6yLgJfDqN3zYPB9I3HJeqox1NQC+3scM4gMoJWGuAeE3g7Dmu0wYH0WruilZG2AT7CtfcuYAC6Fo1egZKboIxW+pMatElOnCyxh+mtAlGJDIb7dE1et310EFG2gQmPI8yTx8/Kvdo/zTEbgbV17UuoaYB1AfPjbrIuBlcVGK2bBfwqYsjJQ0MtxkWHWd+yryFdLkOVcNcbIaPJnOinvjyaM3ADV2MsBmkj06GThZcpU0XxfxikpphZfjBwDrOVfrUgAVpv3L+xqePKgHK8kaHAZI1w5hD1+Y+gUBaPXnDOMRugb2V+2PNGSeqv/vTSGTcAvrnFwY+TQum3KdGs9GOFjB2d/tVMHyNMl+kmIp4LVD19McaFzMhvXPpgSlI1AI6Lhn+Kvg6vcWUuwAlt8BRYCi1oTN0+bQX35nSFnjNE+k0mvrSbmqWEkbaAndrtOpM1c9ShzRtqhjtVvgw5i+TPPWD1L6CJ8OMUStMpWY6TWO509UfI38y3FZIXHDlNJtxp2/Y3JyFeK1gyr1StoEJpDj/u9rHCFuhLzMjynXYi+IWqlUwSa2QtVAumcucoDdYmVUwpa0wvWW15B1zjq4dfaKXkbaC1dhF0apmPvQulzf/MtptMPHsu4iT6UHU7339HYxRG7TnGIdIh0/Ss/7D1Qy3DZw3tdGnwZ/u+bC7nbnYBm11u2R3vf2pr8JYMv5t0BHWF6Lu50jFTZ89HSW3gZqW/snrQ6fpGxsjfjGlbeDQkjslzfs65ZI11MJI22D4WuLzVWnXqYW9cf9D7HawP/jhUeglZ2pqj7YmMm6HylzeGVF6AJWl7d7CcNtBY3h/9kqt/fSfq9WLEK8d1munb/sm4NNPfKunI1E7WFkNRQi9nGg/FbsfTFI7eB+bnj2VH0yt2nRuPiprh10pzMubrGuUQrT+DyNth4CinTkV6AIV0f20mNGWQMWZvw04fnz6V97OKsZIAidHTS5IR56U9H9r5QxXApZPI5IfMQ7UuCOBTcxFCRxIk6Y4du+jNZmb45BIAqy8sUdCBP70er37tUySBN4YrPuqjtyo23ydSahMAmFWe617VXbQWfTHkUgmgXENyw+v51ymVUI8FIy2FEaESlctHuDSuYF/piFjKewZ5yh/5hNIRSzzVTBcKazL/f7FDAIpu62PB5mLUnB2i5nSpXKcNsvq+5cRSmFLo2tX+SVXyvt3HRl/KSy+6xU3kXWRvvmf6xRUJoWUZyVbJD721OLMuh5GKoWDV3mslSMu0BesbboYbRlUjpli8dw7kN7vcaWTMZJB3cvBzDP8aFpPc3CI4crgUEThsmEcTfluK1ZFPBkU7v1P7Id8qaZCOZl/MpjkvDKtljlP21RqsFCyDFrnNLzgQyht8vkeC5XJoCfR3L3/koAaGqrsZ6QyENt9441Qc6Wjhj6ORewOOD72vP8XwXXqcNeffsaoA6Qrhk724wTqZ9xXsv92wIsdOjxXFEfF7ZlO9r8OkNT8ru8bCqHm7J47yAg7wNFhdbUxCqUOUGt0UHIHXGOpCtz5sdS7m/N7mdIOsA1OfLqkz4ZGXwK7GGkHtB56mID54dS9K0EaiC2HGYeGQu0EiZTqustk/5fDUpzYmsGEU/7dNMNw5eCwaJF3I8uF+jl9voK5KIdjGnyXT4N8ivonfDwSyWGhmQpVoOJA657YMx4ly0HlL/lSX0EYvXrncCtTKgd5NdfEm7lGRz1/PxbJ5JBtZrzDkrlMJ9V7DDDanZAw78g1e+RD848+I+u/Eya8eweHmVB6r+0DDbSjE1J9g2b48iOp6T0D4xCvE4q+amZ9RALqg9EB0v+dYPnw5d8JEEGvrfilhpI74V8TF54d/zK1L/+lginthMU6mP2Pigel/zqZrL9OSN6Zcuo8P4bqSloyAbG7YNbliUdX9tpS84M2kf2/C9ZZVjs0sPyoE68jGxluFxwMePn+DBNA1TmrkfnfBbvlGfEp4ki6Mf2ilBF2gcOCf+SjOfGU2sO0P0xSF2y4pInfMRF0zVy2HirrgjVnq+1PimPpelOZNpJ1wZRdl8cG8KOp8i3VOoitgBX3TtnbqFlTHnNH/A8ZK2D0kpklJTiK3sqramO4Cvh+e8QIB5UA+vHuo1LmogJ0TuZrNeB4SofdoIdEChBJk3yyva9RYab5qihZAWIN/P8u7josquyP4/ilB+kalh662xj0nmWwu7dXZf252Cu4ZTs2NjbG47J2d4x6jw6P3bOsMViMTTesjq78zoHPPA/PGtz74jv5//m+28jS/pAkr15+gq4hNbJH6IeoObnS4mmat01VDamWYyvUp2etlYYRvoeOPkZ2Cunq+atx8BFY0IufCtleuhaeEkEv/Hbv6ZO7sNafRPI99SJY0EsvO36Tu7rKZElauIbtrTfB+ni6PbY+4xent3i/GHqR77EHwFo3YnW3dOHceDhBSQfzvfZU01ygH289bEcHwNnxpIbvuY+ADRak58T9R0MyYV04VfK9dzUsPJUEvwPKMzkmvxSnNO/Bm1whpet+s51+FFYpSDLfi8+HhTyx/cKmkeMK4Jww2onvyb+ADea0+OKq+Yvq4K9DaH8ftjdvaeq3JBNvm78OFrib7ERm3WZ79KGwNpDqOp/x79se1kWSkzfYXn0P2LkHkb77w7P+Kzg9iBxexfbsx8CXkui67YmFN6bCQjDV/Mj27pfA6igqfD1lh24zM75v8Da+hw9HJBOj14OzVufhE53JvC5sL/8urIujfTNkw8cZ4IEKajOF7enXwBERxDEmQvfJHL2dI750Pd/bd4cNVvR9/L4hF0NhVYPY+wrb4+8AKzzJodwR0ZqesGBLb/K9/m/hMaEkcNJvm56Oh3XtaRTf858JC2Z0e/C0V8krTY4lltZs7z8P3qGki5uG9Dt3DP6+HfmuhncAYE0Yuazp4/XLA1gol1bwLkAxrPMk5nU2y4cbYZWc9OOdAHtTP6lBatSsqJjmDxtsSXgc6wYkwPooMqxNd/X1znC1N93MOwJfwOl2xG1k/ZLeo+FsJdnNuwJTYYULWR6XP+TTUlhrTQo+ss7AVlgTSTWT2gW+PgJnRpM5vDtwERYKRXW42LHpvsmvxO0FvEMA58TQ0XVBb/p+gAfKSc5p1iVwRN/qXjzZu3jThDsKONOV9PFmnYJkuEc/8rbHaY/53WGlkjZ3C76BhVxx3OWayJ8mwLo2ZCDvGMyG1c/EY73Ca5ethrWW1IJ3DXbCmQ40Y9Km0wYNnONAmnjn4BacZ04m/Vl3cWwRPCWAavxY96DWNHemJcfSfoiwRk9M5UINzR0E2GBHKkcZC31jTXNbGs+7CCpY50g9/jVO6TEUzkghN3WskzAadvamp/KzF++Z3mJ1t69pMu8mrMS8pzctujToK9V2WLgpruUdhdOwyowslk+Mc7oJK6pF10usq1AEp9eJnfZ/951HHZxjTSXeWbCpwPezJcZrsughPrDBgy5YwroL8XCEH7HYdqP0Whc4z4ysau4wwEKR+OebkcW/TTDNLWh/3mVQw3p7mpPelDVsHaytFw/xTsNeOKdJDJ3X8cGM87C6ROzGuw1/w4oG6YKV76j7b+FMP1q+iXUcPsLucjp8ptf40S7o5fW0I2+3s65DGHxHRb6vlHdK7gSPsScneOdhIJxgS8dMHB2S8iMsvJa68u7DNPidDQ07ffv3qSvhzDqpuLkDAetei69uzFhYfwb2lhOHMawLcRce2CC6L/hs275XsOqK6MY7EUZYXSlZp53y3eKEzkO2UfrfGdaNCIVzYuivk5/2vN4RFvaJIbwjMRCurpf+7Zo9NSkDVt8QlbwrMR2WjOJcMcRcvwpOvyet4J2J3bC9HXW5v7r9WQobtNJa3p34u8XqZ860MjhqfGEJ5l0qxf+eKzovfWv0toNVxyUL3qWSw56udK55J/cxgab5WXEC71TFwLlV4o1zLnH3OpjmV6XFvFvVBU7Qi6OHNk4e0R9O9abf8o7VN/B8c7ouQHRs8yOcXiN6/8O6VplwiAeJ3TM5+t50OK9E0vHO1SJY9Ua8ZpPRSFfDUwTa3L3aCgu5UkJKwOare+G8JvFjNu9gwdeM0pIJr7rVaGFtoSjvybpYt2CFFdEPSwnupId1RqmOd7Jewgd8yK69RSN2VsHFlrS6gHWzPsAJDrRP8MOIBBv0TgfWiN/xjpYbLJSL76OG73/sD0tycp93taJgVbE407LWfU97WOdIS3hnqzNsKBaViQPWrOsPq8rELN7d+hZOsCJFF7OG7siAlRbEZTDvcMH3Isgf59YtvDcL1lnRNbzLtQTO9qUZwzp8HbYBrnYhu3mnazvc05m8XOT2buNhOKUHHTqMdbvOwa9CSBffiHXx12BFG3qMd7zuweqXYqLqxPC3BlhbKip516sCzjEj/9xWzs9/D0/xoSuXs86XNfq+a2OJ/54p7c67woJeTHvKul8BcNtoEuw2ddvTaPidF3n7A++Awde8aLj73A8B3eAEc2LOu2CD4J5u9Mgd/6wFw+FMVyKfyTph42GdC3Ey+LV1nAJXJpLPeTdsPqx1pwnnVv16dhWsd6O2RawjthU+IiObHf/KWLIfnhFEOz5iXTENzHrF771/T5l1GVY700Jz1hkrgHWOdKrHqID1RbCiXrobx7pj5XBuCA3Kpr0L3sMJchp6infI0Kdun0TtdlZWJLm3WF2USTUPWZcsEPOeQXRbyZ5Omjg4N5RmeLJOmQjr/Em48WXGyF6w8ERy4t2yL2F9Aj2T/Wxb4ij4WhBJ2cc6ZllwuoJ8+sU/OGy2yXKq5F2zZbChDb34eZaPahM8uStV5LHO2W5YISPrfiq/MPskrP6c1PLu2UWTq8Sg5xVdX+vgPE96rrmDBieEkVv9fYsyy+FdPemyWayLZoSfiPRc3uiLQTL00jWhZB3vpMlhrT/p3t02/EMwnO5GFXtZNy0Rzg0mZWfmpxpTYcEoevGOWn9Y2yiZFezurPjeZDsq5121cbDalYYlL82YOAU2JBCBd9YWwqpYanl49fPna2GFPZnMu2vb4YH+1EwzsXTmUVhtQ55H8g6byW40Kd9Tk3bHZIE85l22J3BmDFm/Xz8ntgw2+FLzWNZpew8rvEh+YrfZabIGfH4ZjeLdNjksGKXSQanFM0NhWW/yqD/ruLWF9WHU+0Bj/YvOcNck+ngt67oNgsWeZLxLydPMdPhICHkWyTpvk+Bv04jjpRePw2fBhkg6iXfflsOyYNrXrilctgUu70fCmztwsHBJqp+254PLWViWQOx4F+46fC2Mpq7YmNNND2/qTp4rWCfuLazyoTfKnii2N8KZnkTDu3FWjS1+F0Y8/rn9JsoDFsxIIu/IhcA6D3oy0svvabLJrtSNd+W6wOpSybhC+nRmMJweQTcks87cSPhTFlmRJLuanwUrOtBZvDs3B1a/EbPWbj1anwNPiaTIg1z4T3/hgpCm/XuOzE5vXjxWMCsOEMycxwlmDeyqZeb3coVgdo3d84ffY1czHNg2HbS1wkFbm1YHzhPGtTzOtvXjcLDdDgfi+Wsr2Wvfw2uPYnbAIXon9p9/nmFszh83jl0Hjmu5/53dfz2u5Tm5/Hfs6tIqgGE5XjBzY1d3LF/w5+Tg+XyuwXPkeA6f57F5LuZ6zD1bzU+2mr/D/LNW8yuY8/uHrd6LpUlU/wegoITt";
const depthText = "eNqtOQVAVNnaN6aLYWiQRhRUREUJlba7a127e8tY3VEU+7G7unatsnZ3t2sHNjJ0MzAM03Hj/OeO+MtD4j33fafPd8493/nuPV+cu237+r4IsjQGQZDYWinuc/8P8bCIhSmOaVf3w7Q0GvkIMZEpE6IjUwo6fcQ9jEeAvBuCSOP3HWwXf3O4Nrq8xeuO429GxQoGT4z/1ylR3O1T76K9MxdEy5/GdZ6E7gmfW9kratT9q+GOSmv4j0jH0Ns7HrcbOu1YsGZQc/+yXV77g8Cmo9/e3nxpZinQn4kNeO0c/WzuYcR9aNpGKQLWnZ4kzyrxO6BklxVHheZtf/FwQrI04cmgTd6XMQxlAGEiQBFbBAgCI0ywaou2LgaNIgiGwghn4ZisE5zFtBCYAQyOgENsowCMMIMAPkZgiwgNAwAAFgAO+3oQ30YQuAwEjKEEZjjOJJwpWVh1xGFgAMXgOIAx9MB1KUBDAmwEoeDTplAmwU3AsroNmLyaC8w0OIuiacqAzLKX2klgEMMklUilUnupVMYEe3tbJpXZwR6IkcAxErEEFnb29o5Obh6xe6729/ELCAwKbhkSGhraJqRFoLezkCh7f+NwysJJA3smdOszem7y7nPP8vUs+yYBQSGtQ9u2Dm3VMrhZoL+f9E7070jx0/O7182fMrxn57BgX09nmUQsFPD4PB6fCwNPIBBLHJ29/EM6xPcbM2fp5qN3s83OYcPmb795Lgn1F7tKZHyenFToijUqo0l+/q1Ei5lJst/pAomFS3N4ct+kWEuxDKgd1TxyiU9ygrHUga5yUvGJVQuQGgCq4+ev5NP7rW7/OziW15z7+QnVRR1fiS0AWwsnka8H+dL/ekr1FiDI5R9p+bTbmoNqVT9z4RPMXwWQrwXQNBPU0VsH1DUs7ob5Kw4WaoOqz7LOlmJhqiXrltaQddV9sF5b1n2q15J1cVDWJTQm6+aHvg43Nv0pavTi38LvtNGF974Z3JbLMrT7JnljyOjoyb2b9B6+aCHY8MuwPW/uli0GbxZbBEfO9+C8Wfj6/E35A0PotPtOCAjtUTSWC8a3HG2+NIGeHLsdJN3oUtUz9tXRCa6GFyMOgFHEuF2HHWMHqpVPzhsiAqUFnboMllTNCtl+BaTllfdttWZiVAhYlpB14tC8REdpzO+hBeEpo0EHimJEAKBpyGjILxaGc9gcePCEfBEEsUQED7ykWjaIYQbbsIDnX2KfNF2n1eu1ep1ep9PD3KAz6g0mg9loMZsJC0lSzEMZUcZmsdhsDofDhZEHIxee7rwAAV8ADzoMXAbYbDaOYTRpNWk1lRCqtFq9wWgwGk0wwfJj0BvgKjqd130dBIPWoNcbDHpmlAEOgy1IiMFkJREM53J5fL5AKBSIhMw+bDuB+4Ci7R9J6R+WWWna9gBGh3w68tVnBoXhs6JAaYivDjREsni32lKQx59VC6xVZ4itCeuwUh3R6pEwMP3W3WMhT3QGg8litcJ3ZkMB2mJUK4vycvIKyyoNZobjgCQJi8VogqzQqqtUqvLyktLCQhcHIOUhpBnyyGAwmi0ESQMUw5j3wubADEachWKMQqBIW6Rg1SY50McCvz8i2rYOaubn7eZsL+JgFk2p4smNU4cOX3r49tn5lFnfTlyw9XxaiQkTO7p7BQS2bNUuLLJzbNceA4aOmaLLWSUNgqqhTYcOER2joiLDQ4N9HNm6nPsnNy0Y171Dy6DWsUPm/nr8QaFZ5BHYOiwyihkT1jakVXDzAP/zww+tiGzTorm/VxM3F1c3n6BOw9e8jH06bp84xN/5r9M7bjxP7nst5N7iAe0DPBwd7Z1c3L0DglqHdUzoNXjUpOyzpTKxm0TK4cjFd425WpWVlCNXyCJTFUlnKq0CO4GQzZVcrQxvHoSWvrknD0v5kIb4Bw/87Zncx9v66IlMXUxmVWAuHeRFb5wreVac+r4sR6aGFXJF+IQseytKWuQX9wWV80kW557cdNOjTGyyGrsXZiNaAcnGLTVEGoz/FXy3DjQG9U+2suvqBf8ZWDlfuyyEf6TZMOr/Hw/LWifLFmzxs5b9HCB8Ju2/1lJg7m9fbhH8p/BLEvhieOPsr95G9N36RzXGdTogs/F16iWnWfqX3TbLE6GsZgsJYBWtT05SX+rUW7V06q06dOqf/1Od2uLg1fDdyTOiUiqOhl/RgHCvAGO77WNWh634+WEbu5/2RU6ZvfencyDc95XWI6/vTvBwrWFZ0sEbA3vu0XWOmTLybFuZ3S5MkkFqZ5wBO9ZwI8eln3V6A4z3Lx9rc/+3LJR8LJw8iGc4HjbnrBARaZ4ElIIFA0+P6/Mg5nyfIxrtxveR4OK+Be3LJs8FDrrxrrwu3KxMv3s518N/zzgDLsy0LF48q/CoY0nyjcitg4Mmr4z4KV63Fpt3IA0cCx4vjHdarwdl8S9+7B4LTi7Big8tavLd4Otzr4Gp6M2ZFzYe2LR+Urh39zmeHooPCoXiw4f0929epz1/9ODuzcuXzp+7eOdFMerVoeeIb0YP698joWNEm9bBQYFN/f39/P2bNg1qEdI+IrZrv5X38ovLVGqoMaBK1Oo0lRUlhRmvH147lrpj276zTwsIsbtvs6DmzaGU9fPy9nB3c3F0speKhTw2Slqjp4WFBAf4+nh6env5B7Zs16nr0PE/rtqy/9DuZX1E91NmjBgx4bvkTQfP3HqU9k6Rk5Obl5P54e2Lx3euXzhz5tyBvyxQJ+u02iq1Wl2hKq9QVlSoNUaK1yRq/PzpXfyElF5ToVSWKZXlFapKtUaj0etsKgnBeXaqNU2cJAIORkNVpaksK85RvHv57NmL9DJuuwnLfuztS5dnK94rsqC6K6/SGk0EhWI8scw9ILRzv2/nLumUnlmgVOmMVoJGMJSFQ9UGzQ02rc18ePutQezZtFlTX09XBwmfg1KEQatSFmSnv3n66OHD14X4mvnI10PfOzzM5k7ZnEHmIOEsaOdA04PPRawmvV5vskCibB4ihjDuHQwoBhCKshgtbjhCUhBIJpGkLdEAY/MYi0XAxgBFErCPgAg4AAYCtq2ElSQw2clxPNvkj/4nkyiaJKABZiYAiy+SCIVcFgtFwUdgfFmcIY0vFIrQovuBFkgpiqEYAqPNBcZwNs5mYShNEFaCBOAjuSgcgzCFzQ8GJGklkeZ//rLy1+1/Hjp2+tSpk0f+2rP195Tftp58Kxm2/frFQxefX/y5rf7BkR2bN27ZtntPauqfe7b/kZIsXzh/yZqDaaIhD35lZVfqDdoqVUWlWqc3GTTleW9fpeu9+08b3T1xYO8QTkVuTn5JOfyEKlUVFSqlsjDz2YWtc+KahDw5EmiXn/TD+IFdY6MTeo/5ee8bx3GX+QmxCvWs79YeemLdGgDW/OYYKrz7ffPis+vnjRk2eNiEmQuTfhnX7FZY6uA3zQiht29A8xZtI+L6jJy5dOu51xqxj0eV/NLRk+635ywfsunk3HSWGJQ8Pb156ezRfRM7tm0V6O/rE9Cm6/Tt3cy8Xk5+TZsF+AU0axkW12/MvKT1W45o9mmfvNjxg3G2tMOM1S5t7mxZvWTO+AFdIkNbNPP39XDE1RkK+yOnz/3tUlhAswTwe5Sb71QWG/UYJue8VOWqK0n6UrFE4mpvx2Ednet8H5iFgHVAbpeGlvERVq6j/NWKv7WJHXzzVrda0FF8/eEHX3KlT3sBxyOgRCsve1KlLQve14YsiNOXok/lh9hxaYXaJvKqPIEeIzHqB025QIeRKCW/eotvYBE4siIxnBCaWSQ44vjdu0o+gtLL5YkXWCROIa/lz5R2hRiB8i4GB6spgkU33Vslz6swcGj76MzA91m0FfQ99XW2gQ0WL/9qqwYAhzKkAXQjgFGNLNgQRRZOPWOQhvttQOF191d3NbiLf2ZRkfinJyIwNMSw2vcF1X0NvqCGXuLnyUxR71qfekDt5Rt7y7ZGnUSPS23su2qA7F+WQexXbhqTqSikJlRf5CGAIqxWK0HRiK2Nol/siaatYm1d9xcQSVPV6oDpQOoEmkXUxTAUY3HYxgI1zmXjGFoXK5kx1tp3wV/ej+R+eRcMcf/Lu+DjZ+D9CJUaNWDxi/CVOy3hzR9h7R9j18MihOXtvk1cMO30mV3sBeAHp8duZ9N73AJhownD07zEX6PGZU9YtiWtpZTirOrlE5w4oPdDkOqZOMc6aJHFDfiwD+QHubX3UwtBrn/o4hH9T40E3+0ZXtR5vBXkzPkh8/E+cNuDFO+673x8niX9+YabG8eddAcXX08Yqqd3ze1wbu6G5y25wPJ2QUQL9okN/ScIcuQ/zwk7un5y5bUCl9K/l11Fkk4dnrloFx6w7TCwL74yO/N2Ki+pufvbM2Dz9dFOx6JeIKyoHcryjH79E8h7TWcIbgydvwkM8TTtTpl9w0EkXWjaY+Xf0vjcd04uf9/v913SuDYtVVeXjJ1keHoU6J9NuO3jd7/HrBzHi8nWi9tCjvy4OKRZy15AYFKFXAvZ+5fSJXlT5pLR7iDq3Rr31K2H7x7xcnuwFMzGNvU/7rHnUgf6wfaErm6kYlLC6k5LTwOrX+aY0b8Rt66sysnJz83PzcvPK8zPz8l48+T2pRP7tq39ee6ytEH3FGdWTRveKyYssIlMyOcL7Rxd3by8fANbRCQOmThj1jTw4O7b3BKVSmcgAFcE74QFuElVpHh2aU2kQTivPGrwoH49EuNiItu3Dg7wbuLq7ORgLxVyKH1FUX6hcidvUKcgL0eJgMth84WOnkHtEwdPWrQ3t9ubrqaBPz2WbcL7LNh04PzdZ+l50ITT6TXlBW+u7144uH3TiHnn+FVJqTdfZheVqhhjwWjSGQxWVOwV0rkDR9nO13/gsC4tXAS0xWgwGPXQ1lUpi/LfPzz127wxE1Y+8FDcryxVqnVajaq0MDszQ5GlyHh15+ivcyfITbzgC1tKdqfsufAso6CgICtTkZlTVA6X0FVpjLIemypad7s3fPecLoGOHAwgbK5QLBZyMEJXnvPi2om01AwHxfIVW49de/g2S6m1MrdB8KDTQveIcRtvZzxf57Bs+/ALacVGjCdxcvWCd+SBgQEBfr7u/JL9cRkP16d1s6Z0khiUBfnZ2QpFVnZhiUprJDGRR3DH7t2DS7aZecjXw5gdZiuBABzHWRgOAYMFhlCG8oyLh6oGDGnjKmDTgLEmaYoBkmRMUzZHIJLJ+PqKgiq+UMzjcmw/IOB8aC+KZS6OIuOznX+pnD28PN0kfBz7JNwxnCN28PD28RDpFI+fPx/rYKjSm0gKANt/FBxGQBgq856evNZ17wQfUFVRoTGYLITN0iUIs9EIfQPvyD5925D73yX4y6xVap3BAimqvswy6at0pKzb+qFH1tyqYvN5HBaK2NZGaBRj8cVSe3uJADOV5UydbYDXknwOjny8cGMyjMUVsIxF+ZKmEqvWYGb8Wvyja4vSNGEyGEiek3eLiKbpG0dqUb6AB3eFABoCzFCcwxfxgKaSFHFRZkGUZiQyjDQC2WYlEZbEtQmv5LWyEqHFAh4LARQFqYY4QCEoG147ohZ1hdqCiexEPBTOseEgQLq4QomYrsivoB02uhomF3ZbdylDx/NoHhoS6EgWPL156cSGydP85tz+bWHyuNXHrt17kWsSeQU293flG3JvbR5qXsx+F9ZLNys/Pd6tWI9xWRhNEoAjknKtFXk5H9JOzGx/SYb8LXNPSFUoS3KyigmeVMjGAM7m8ZDSaxt/O35yU0Uv3bpnW4auC5VgGEsgdXJ2cg2Imnys8/T056O83kxa1Gu2g1Wy9t3Crs3dHZwcZWIexhYGzw+bvXD5yAXcMnHIN1RMVCufJq4e/q069xkzL+Vsic/YVHVEdODVB3uHSX6anp12YGF3u/cHV84Z2z+6daCXT0BI5/imL+fPREQDu19KSlZv7eIpggynKZQtdnBv1u/qkeQShTlEFSe/fq+Xn35KaBMnKQ++JgTnCN2i/6W54v5u0Yjlznz+h3KOHRQjuLzkiVFp0iGI3JShKoTvib5aIpC52kk4+O3JyrcOJBdFrsnfmQ1GDor4fYCPzbe42BW4JXfp5MEt0ZR2oFO65Tjp/P3O8OTHAkqFmVnyt55XXvJRV9fV8Vf6daji5flul9/S2HMwo8et+XffchEeLpe+tjfiepzEaYxaLEx30eN6DDZQapn7SIvUitM4xaKBXHFUVgQQthUjMVAkf5Q8QqjUCaxsAndwOWhM5GtUfBwQaLGdfMfdeEsxzqetOHXZM/yDh6gIkZEk+NCyQO3Jti/C+SiJYcXy7Y9H55aKeBYr6nW555NT48R6DAMW5L38wzHZyzC+HrWzoMSebtd7yg+nuUjNFvTWQgJvfdLlptEXr2IfCpm39sctd+Zy3uMOpj3BA/+Qn373Lfstam9JuAK+3qCXy+u1hWmYGrbiHEvrRtucTdvpbwC4lnrJbdSmRwxCUB8wazfEDhTlmOpdB2JrTajFxmo3pC6O0DScXhfRn8eg9D++Xq3HC2jEjQEIDRp4lTVaSK1FAAQaRer1thr5DWibXP+Amo/8wslhcDXQMHwmraZ7Ux8zkJq12myquSCw1WsP+Fj/kpn1+I01kd9voGi6znE2p6DOJ9I0zTgJGLYkCfl35tT3bTO4WlTiQg2FoXU4Ejwhri5SUgIBG68DjWO0xYrgAiP9BQ4ChqGUxWQiAPoR6nJEUMCxUDV6/n8+zuba8S+oHfgcFvYlGgEUwmFbiJr+B3/AnYi5BUfPfDtesz5zQJFyWdT4nNR+MsvK1fNHch3Xtl+xY9nKUGkhmNb52LszWHYri/3x+LSds3pPzvnXAnE7TfHje51Fwe8qxJP4Pbbmluf/bCa+f7Q5xd0tpeUfLt2O7ZD+Wcyee6njWeerrNne2879GMz/oyN+gb1zTreQ/oUOrDmZPcekTZmTfyfifdKvkVmzPSP7ejbxMX7z8Hy/B/bCiP5/P2PfFTz6jgsuPr6+5Fv37PU9+515+cK6+huRFQxZeXLPYt64n2VtpryacetgxqIloer4PpGROannCnlLf7lgt2uUuyJz8cOpw4UPYiTu0RGP9l4/P3C4Ij925rR5M7v08/olsz+iOLU1+QfVxdFZhoCNo2al6/psndNT1zf/w4VoJTp+yZgRO6Mml645c2b5kDudDIMPxvXo6sSP7syb02f5On6FrEf5dGHiEnLU2rgpK9YEv2UYTNMEjQMLxebggCJp5o2yCMZWZAEMMRIc3Ky14mychWMIsLIBTVooDpcrYlvMNBuxQCOU8V1xkvF9CZ3eSnGd7Fk0STE2IUHSJA4AjfDELB28ByYEUjsBx3bbSWAUXJs0E0JnvkWv16gtLJ5AJOBx2RRu++RIrcHOhUdAM9Jq1FsAhrMwEkDA2LixgnR0YJFmK0XDJ5Ef/9YCioaKtKoSkck4BPN/A6HJ6h9HsMJnGfUUi8tmNgHhYwYJNrFFiMFAMhgEbqP606NpNqYl7MUWtR5wuBwM0gNsa0DAcdJE8/gYswaCIuD/AJN0Gik=";
async function unpacked(text) {
const bytes = Uint8Array.from(atob(text), (c) => c.charCodeAt(0));
const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"));
return new Uint8Array(await new Response(stream).arrayBuffer());
}
async function compiledCore() {
return WebAssembly.compile(await unpacked(wasmText));
}
async function createCore(module = null) {
return new Core(module ?? (await compiledCore()));
}
const workerText = "\"use strict\";const { CAMERA, Core, DEFAULTS, DIRECTED, Engine, FIELDS, History, INFINITE, WHITE, changed, completed, crc32, focused, fromText, furtherTerms, linesOf, pythonFloat, refused, seenAt, termsOf, toText, unitOfLength, vanesOf, withSpikes, wordsIn } = (" + common + ")();let engine = null;\nself.onmessage = ({ data: { id, method, arguments: given } }) => {\ntry {\nif (method === \"start\") {\nengine = new Engine(new Core(given[0]));\nself.postMessage({ id, result: true });\nreturn;\n}\nconst result = engine[method](...given);\nself.postMessage({ id, result }, buffersOf(result));\n} catch (error) {\nself.postMessage({ id, error: error instanceof Error ? error.message : String(error) });\n}\n};\nfunction buffersOf(result, found = new Set()) {\nif (ArrayBuffer.isView(result)) found.add(result.buffer);\nelse if (result?.constructor === Object) for (const part of Object.values(result)) buffersOf(part, found);\nreturn [...found];\n}\n";
let told = false;
const shared = {};
const once = (name, make) => (shared[name] ??= make());
async function startedWorker(core) {
const url = URL.createObjectURL(new Blob([workerText], { type: "text/javascript" }));
const worker = new Worker(url);
return new Promise((resolve, reject) => {
worker.onerror = (event) => {
event.preventDefault?.();
worker.terminate();
reject(new Error(event.message || "it does not start"));
};
worker.onmessage = ({ data: { error } }) => (error === undefined ? resolve(worker) : reject(new Error(error)));
worker.postMessage({ id: 0, method: "start", arguments: [core] });
}).finally(() => URL.revokeObjectURL(url));
}
const SECOND = new Set(["measures", "curves", "blur"]); // computed beside the others
const THIRD = new Set(["openDepth", "depth", "sharpen"]); // of a lesson alone, in a Worker of its own
class Client {
constructor() {
this.lanes = [new Lane(), new Lane()];
}
get worker() {
return this.lanes.some(({ worker }) => worker);
}
async call(method, ...given) {
if (THIRD.has(method)) return (this.lanes[2] ??= new Lane()).call(method, ...given);
const lane = this.lanes[SECOND.has(method) ? 1 : 0];
const asked = JSON.stringify(given);
if (method === "measures" && this.last?.asked === asked) {
const [curves, extents, psf] = await Promise.all([lane.call("curves", ...given), this.last.psf.then(() => this.lanes[0].call("extents", ...given)), this.last.psf]);
return completed({ ...curves, ...extents }, psf);
}
const answer = lane.call(method, ...given);
if (method === "psf") this.last = { asked, psf: answer };
return answer;
}
stop(message = "the computation was stopped") {
for (const lane of this.lanes.slice(0, 2)) if (lane.waiting.size) lane.renew({ message });
}
destroy() {
for (const lane of this.lanes) lane.destroy();
}
}
class Lane {
constructor() {
this.waiting = new Map();
this.count = 0;
this.ready = this.start();
}
async start() {
const core = await once("core", compiledCore);
try {
this.worker = await startedWorker(core);
this.worker.onmessage = ({ data }) => this.answer(data);
this.worker.onerror = (event) => this.renew(event);
if (this.gone) this.destroy();
} catch (error) {
if (!told) console.info(`lommel: no Worker here (${error.message}), so the page computes by itself.`);
told = true;
this.engine = once("engine", () => new Engine(new Core(core)));
}
}
async call(method, ...given) {
await this.ready;
if (this.engine) return this.engine[method](...given);
return new Promise((resolve, reject) => {
const id = ++this.count;
this.waiting.set(id, { resolve, reject });
this.worker?.postMessage({ id, method, arguments: given });
});
}
renew(event) {
event.preventDefault?.();
this.worker?.terminate();
this.ready = this.start();
for (const id of [...this.waiting.keys()]) this.answer({ id, error: event.message || "the computation stopped" });
}
answer({ id, result, error }) {
const asked = this.waiting.get(id);
this.waiting.delete(id);
if (error === undefined) asked?.resolve(result);
else asked?.reject(new Error(error));
}
destroy() {
this.gone = true;
this.worker?.terminate();
this.worker = null;
this.waiting.clear();
}
}
const ALTERNATE = 800; // ms, slower than what may harm anybody
const MODES = { beside: "side by side", flicker: "in turn", difference: "difference, B − A" };
const SCALES = { one: "one scale", own: "each its own scale" };
class Compare {
constructor(page) {
this.page = page;
this.mode = "beside";
this.shared = true;
this.held = null;
this.still = matchMedia("(prefers-reduced-motion: reduce)");
}
hold(held) {
this.held = held;
this.page.held.setAttribute("aria-label", `A. ${held.sentence}`);
this.arrange();
}
renew(parts) {
Object.assign(this.held, parts);
this.page.held.setAttribute("aria-label", `A. ${this.held.sentence}`);
}
release() {
this.held = null;
this.arrange();
}
show(mode) {
this.mode = mode;
this.arrange();
}
get shown() {
return this.held ? this.mode : "one";
}
get turn() {
return this.page.stage.dataset.turn;
}
arrange() {
const { page, held, shown } = this;
clearInterval(this.timer);
page.compare.hidden = !held;
page.hold.hidden = Boolean(held);
page.node.dataset.compare = page.stage.dataset.mode = shown;
page.scale.hidden = shown === "difference";
page.turn.hidden = shown !== "flicker";
page.heldPicture.parentNode.hidden = !held;
for (const tag of page.stage.querySelectorAll(".tag")) tag.hidden = !held;
page.held.parentNode.hidden = !held || shown === "difference";
this.see("b");
if (shown === "flicker" && !this.still.matches) this.timer = setInterval(() => this.see(this.turn === "a" ? "b" : "a"), ALTERNATE);
}
see(turn) {
this.page.stage.dataset.turn = turn;
this.page.turn.textContent = turn === "a" ? "Show B" : "Show A";
}
swap() {
clearInterval(this.timer);
this.see(this.turn === "a" ? "b" : "a");
}
destroy() {
clearInterval(this.timer);
}
}
const GROUPS = [];
for (const [key, { row }] of Object.entries(FIELDS)) {
if (!row || (key.endsWith("_angle") && Object.hasOwn(FIELDS, key.slice(0, -6)))) continue;
if (GROUPS.at(-1)?.[0] !== row.group) GROUPS.push([row.group, []]);
GROUPS.at(-1)[1].push(Object.hasOwn(FIELDS, `${key}_angle`) ? [key, `${key}_angle`] : key);
}
const LIGHTS = { mono: "one wavelength", white: "white light" };
const FOCUS = { waves: "defocus in waves", distances: "by distances" };
const ABOVE = { Wavefront: [["focus", "Focus", FOCUS]] };
const BELOW = {
Wavefront: [["rays", "Rays", { off: "not shown", on: "over the image" }]],
Sensor: [["noise", "Noise", { off: "none", on: "photons and read noise" }]],
};
const SAID = 3; // terms without sliders, of which all are said in words that are clicked
const TERM_NAMES = {
"1,1": "tilt x", "1,-1": "tilt y", "2,0": "defocus", "2,2": "astigmatism 0°", "2,-2": "astigmatism 45°", "3,1": "coma x", "3,-1": "coma y",
"3,3": "trefoil 0°", "3,-3": "trefoil 30°", "4,0": "spherical", "4,4": "tetrafoil 0°", "4,-4": "tetrafoil 22.5°", "6,0": "second spherical",
};
const termsSaid = ({ zernike }) =>
furtherTerms(zernike)
.sort(([, , a], [, , b]) => Math.abs(b) - Math.abs(a))
.map(([n, m, c]) => `${TERM_NAMES[`${n},${m}`] ? `${TERM_NAMES[`${n},${m}`]} (Z${n}^${m})` : `Z${n}^${m}`} ${short(c, 3)}`);
const SIDEWAYS = 6; // px that a finger moves before a slider follows it
const PAUSE = 700; // ms without a change that end a gesture of the keyboard
class Controls {
constructor({ state, set, touched, only = [], level = 2 }) {
Object.assign(this, { set, touched });
this.rows = new Map();
this.menus = {};
this.gesture = { count: 0, key: "", time: 0 };
const shows = (key) => !only.length || only.includes(key);
const groups = GROUPS.map(([title, entries]) => {
const choices = (list = []) => list.filter(([key]) => shows(key)).map((choice) => this.choice(...choice, state));
const sliders = entries.map((entry) => this.entry(entry, state, shows)).filter(Boolean);
const further = title === "Wavefront" && shows("zernike") ? [this.further()] : [];
const rows = [...choices(ABOVE[title]), ...sliders, ...further, ...choices(BELOW[title])];
const extra = this.extra(title, state, shows);
if (!rows.length && !extra.length) return null;
const head = el("div", { class: "head" }, el(`h${level + 1}`, { class: "title" }, title), ...extra);
return el("div", { class: "section", role: "group", "aria-label": title }, head, ...rows);
});
const onsubmit = (event) => event.preventDefault();
this.node = el("form", { class: "controls", "aria-label": "Settings", onsubmit }, ...groups);
this.update(state);
}
entry(entry, state, shows) {
if (!Array.isArray(entry)) return shows(entry) ? this.row(entry, state) : null;
const [size, angle] = entry;
return shows(size) || shows(angle) ? el("div", { class: "pair" }, this.row(size, state), this.row(angle, state)) : null;
}
extra(title, state, shows) {
const inline = (key, word, label, choices) => {
if (!shows(key)) return [];
this.menus[key] = menu(label, choices, state[key], (value) => this.set({ [key]: value }), { "data-key": key });
const text = word ? [el("span", { "data-word": title === "Wavefront" ? "edge" : key }, word)] : [];
return [el("div", { class: "inline" }, ...text, this.menus[key])];
};
if (title === "Wavefront") return inline("waves_unit", "at the edge, in", "Unit of the wavefront", WAVES_UNITS);
if (title === "Lens and light") return inline("light", "", "Light", LIGHTS);
if (title === "Sensor") return inline("length_unit", "lengths in", "Unit of lengths", LENGTH_UNITS);
return [];
}
choice(key, label, choices, state) {
this.menus[key] = menu(label, choices, state[key], (value) => this.set({ [key]: value }), { "data-key": key });
return el("div", { class: "row choice", "data-row": key }, el("span", { "data-word": key }, label), this.menus[key]);
}
further() {
const remove = el("button", { type: "button", onclick: () => this.set({ zernike: "" }) }, "Remove");
this.terms = el("span", { "data-word": "zernike" });
this.termsRow = el("div", { class: "row choice", "data-row": "zernike" }, this.terms, remove);
return this.termsRow;
}
gestureOf(key, dragging) {
const { gesture } = this;
const now = performance.now();
if (gesture.key !== key || (!dragging && now - gesture.time > PAUSE)) gesture.count++;
Object.assign(gesture, { key, time: now });
return `${key} ${gesture.count}`;
}
row(key, state) {
const spec = FIELDS[key].row;
const id = unique(key);
const name = spec.name ?? spec.label;
const hint = `${FIELDS[key].about ?? name}\nDouble click, or Delete, for the default`;
const slider = el("input", { type: "range", "aria-label": name, "data-key": key, title: hint });
const box = el("input", { type: "text", id, "data-key": key, inputmode: "decimal", autocomplete: "off", "aria-errormessage": `${id}-fault` });
const unit = el("span", { class: "unit" }, spec.unit ?? "");
const fault = el("p", { class: "fault", id: `${id}-fault`, role: "alert", hidden: true });
const row = { key, spec, slider, box, unit, fault, name, dragging: false };
const reset = () => {
this.allow(row);
this.set({ [key]: FIELDS[key].initial });
};
this.slide(row);
slider.addEventListener("dblclick", reset);
slider.addEventListener("keydown", (event) => {
if (event.key === "Delete" || event.key === "Backspace") reset();
});
this.type(row);
const label = el("label", { for: id, title: hint, "data-word": key, ondblclick: reset }, spec.label);
this.rows.set(key, row);
return el("div", { class: "row", "data-row": key }, el("div", { class: "line" }, label, box, unit), fault, slider);
}
slide(row) {
const { key, slider } = row;
let touch = null;
const take = (at) => this.set({ [key]: valueAt(row, at) }, true, this.gestureOf(key, true));
const restore = () => {
row.shown = undefined;
this.update(this.state);
};
slider.addEventListener("pointerdown", (event) => {
this.gesture.key = "";
this.touched(key);
row.dragging = true;
touch = event.pointerType === "touch" ? { id: event.pointerId, x: event.clientX, before: this.state[key], at: null, moves: false } : null;
});
slider.addEventListener("pointermove", (event) => {
if (touch?.id !== event.pointerId || touch.moves || Math.abs(event.clientX - touch.x) < SIDEWAYS) return;
touch.moves = true;
if (touch.at !== null) take(touch.at);
});
slider.addEventListener("input", () => {
if (touch) touch.at = slider.valueAsNumber;
if (touch && !touch.moves) return restore();
this.touched(key);
if (!row.dragging) return this.set({ [key]: valueAt(row, slider.valueAsNumber) }, true, this.gestureOf(key, false));
return take(slider.valueAsNumber);
});
const end = (event) => {
if (touch && event.type === "pointercancel") {
if (touch.moves) this.set({ [key]: touch.before }, false, this.gestureOf(key, true));
else restore();
} else if (touch && event.type === "pointerup" && !touch.moves && touch.at !== null) take(touch.at);
if (event.type === "pointercancel" || event.type === "pointerup") touch = null;
row.dragging = false;
};
for (const name of ["pointerup", "pointercancel", "blur", "lostpointercapture"]) slider.addEventListener(name, end);
}
type(row) {
const { key, box } = row;
let fresh = false;
box.addEventListener("focus", () => {
row.before = this.state[key];
if (row.kept === undefined) box.value = textOf(row, row.before, 12);
box.select();
fresh = true;
});
box.addEventListener("click", () => {
if (fresh) box.select();
fresh = false;
});
box.addEventListener("input", () => {
this.edited = box;
if (faultOf(row)) return;
this.allow(row);
this.set({ [key]: typedIn(row) }, true, this.gestureOf(key, false));
});
box.addEventListener("keydown", (event) => event.key === "Escape" && this.allow(row));
const written = () => {
if (this.edited !== box) return row.kept === undefined && this.allow(row);
this.edited = undefined;
const wrong = box.value && faultOf(row);
if (!wrong) {
if (box.value) row.before = typedIn(row);
return this.allow(row);
}
row.kept = row.before;
row.fault.textContent = wrong;
this.mark(row);
this.set({ [key]: row.before }, false, this.gestureOf(key, false)); // of what was typed the beginning may have been a number
};
for (const end of ["change", "blur"]) box.addEventListener(end, written);
}
allow(row) {
row.kept = row.shown = undefined;
this.mark(row);
this.update(this.state);
}
mark({ box, fault, kept }) {
fault.hidden = kept === undefined;
box.setAttribute("aria-invalid", String(kept !== undefined));
}
forget() {
this.edited = undefined;
for (const row of this.rows.values()) this.allow(row);
}
typing() {
return Boolean(this.edited);
}
update(state) {
this.state = state;
const waves = wavesUnit(state);
for (const row of this.rows.values()) this.show(row, state, row.spec.waves ? waves : { factor: 1, name: row.spec.unit });
for (const [key, node] of Object.entries(this.menus)) node.value = state[key];
if (this.terms) {
const said = termsSaid(state);
const rest = said.length - SAID;
this.termsRow.hidden = !said.length;
this.terms.textContent = `Further Zernike terms: ${said.slice(0, SAID).join(", ")} waves rms${rest > 0 ? `, and ${rest} smaller` : ""}`;
this.terms.title = this.terms.dataset.also = said.length ? `${said.join(", ")} waves rms.` : "";
}
for (const { spec, box } of this.rows.values())
box.closest("[data-row]").hidden = spec.when.length > 0 && !spec.when.some(([key, ...values]) => values.includes(state[key]));
}
show(row, state, { factor, name }) {
const value = state[row.key];
const print = `${value} ${factor}`;
if (print === row.shown) return;
row.shown = print;
row.factor = factor;
if (row.kept !== undefined && row.kept !== value) row.kept = undefined;
this.mark(row);
const { slider, box, spec } = row;
if (!row.dragging) this.range(row, value);
slider.value = placeOf(row, value);
this.fill(row);
const text = textOf(row, value, Math.abs(value * factor) < 0.1 ? 3 : 4); // what the box has room for
if (this.edited !== box && row.kept === undefined) box.value = box.matches(":focus") ? textOf(row, value, 12) : text;
row.unit.textContent = name;
slider.setAttribute("aria-valuetext", withUnit(text, spec.waves ? name : spec.said).trim());
const said = spec.waves ? `${row.name}, ${name}` : [row.name, spec.said].filter(Boolean).join(", ");
if (box.getAttribute("aria-label") !== said) box.setAttribute("aria-label", said);
}
fill({ slider, spec }) {
const [least, most] = [Number(slider.min), Number(slider.max)];
const share = (at) => Math.min(1, Math.max(0, (at - least) / (most - least)));
const [zero, now] = [spec.step === null ? 0 : share(0), share(slider.valueAsNumber)];
slider.style.setProperty("--from", Math.min(zero, now).toFixed(4));
slider.style.setProperty("--to", Math.max(zero, now).toFixed(4));
}
range({ slider, spec, key }, value) {
const { low, high } = FIELDS[key];
const [from, to] = value < spec.reach[0] || value > spec.reach[1] ? [low, high] : spec.reach;
const [least, most] = spec.step === null ? [Math.log10(from), Math.log10(to)] : [from, to];
const wanted = { min: least, max: most, step: spec.step === null ? (most - least) / 400 : spec.step };
for (const [name, number] of Object.entries(wanted)) if (slider[name] !== String(number)) slider[name] = number;
}
}
const textOf = ({ key, factor }, value, digits) => (FIELDS[key].infinite && value >= FIELDS[key].high ? "∞" : short(value * factor, digits));
function typedIn({ key, box, factor }) {
if (FIELDS[key].infinite && INFINITE.test(box.value)) return FIELDS[key].high;
return box.value.trim() ? Number(box.value.replace(",", ".")) / factor : NaN;
}
function faultOf(row) {
const { key, name, spec, factor, unit } = row;
const { low, high, whole, infinite } = FIELDS[key];
const value = typedIn(row);
const inside = value >= low - 1e-12 * Math.abs(low) && value <= high + 1e-12 * Math.abs(high);
if (inside && !(whole && value % 1)) return "";
const [least, most] = [low, high].map((limit) => short(limit * factor));
const range = `${whole ? "a whole number, " : ""}${least} to ${infinite ? "∞ (or inf)" : most} ${spec.waves ? unit.textContent : spec.said}`.trim();
const turned = value < 0 && DIRECTED.find((term) => term.name === key);
return `${name} is ${range}${turned ? `; for the other sign turn its angle by ${180 / turned.m}°` : ""}. Still ${textOf(row, row.before, 4)}.`;
}
const placeOf = ({ spec }, value) => (spec.step === null ? Math.log10(value) : value);
const valueAt = ({ spec }, place) => (spec.step === null ? Number((10 ** place).toPrecision(3)) : place);
const ONE_WAY = 8000; // ms that a slider takes through its reach
const STEPS_OF_REACH = 20;
class Play {
constructor({ controls, button, set, state }) {
Object.assign(this, { controls, button, set, state });
this.still = matchMedia("(prefers-reduced-motion: reduce)");
this.count = 0;
this.choose([...controls.rows.keys()][0]);
}
follow() {
const there = (key) => !this.controls.rows.get(key).box.closest("[data-row]:is([hidden], .idle)");
if (!this.key || there(this.key)) return;
const key = [...this.controls.rows.keys()].find(there);
if (key) this.choose(key);
}
choose(key) {
this.stop();
this.key = key;
this.button.hidden = !key;
this.show();
}
show() {
if (!this.key) return;
const { name } = this.controls.rows.get(this.key);
const does = this.running ? "Pause" : this.still.matches ? "Step" : "Move";
this.button.textContent = `${this.running ? "❚❚" : "▶"} ${does}${does === "Step" ? ":" : ""} ${name}`;
this.button.setAttribute("aria-label", `${does} ${name}`);
const steps = "one step each time, since your system asks for reduced motion";
this.button.title = does === "Step" ? `Step: ${steps}` : `${does} ${name} (Escape stops): run the slider used last through its range`;
}
press() {
if (this.running) return this.stop();
const row = this.controls.rows.get(this.key);
const [least, most] = row.spec.reach.map((value) => placeOf(row, value));
const reach = most - least;
const from = Math.min(most, Math.max(least, placeOf(row, this.state()[this.key])));
const step = row.spec.step ?? reach / 400;
const gesture = `play ${++this.count}`;
const go = (way) => {
const along = way % (2 * reach);
const place = least + Math.min(along, 2 * reach - along);
const value = row.spec.step === null ? place : least + Math.round((place - least) / step) * step;
this.set({ [this.key]: Number(valueAt(row, value).toPrecision(12)) }, true, gesture);
};
if (this.still.matches) {
this.way = this.stepped === this.key ? this.way + reach / STEPS_OF_REACH : from - least + reach / STEPS_OF_REACH;
this.stepped = this.key;
return go(this.way);
}
this.running = true;
this.show();
const begin = performance.now();
const turn = (now) => {
if (!this.running) return;
go(from - least + (Math.max(0, now - begin) / ONE_WAY) * reach);
this.raf = requestAnimationFrame(turn);
};
this.raf = requestAnimationFrame(turn);
return undefined;
}
stop() {
cancelAnimationFrame(this.raf);
if (!this.running) return;
this.running = false;
this.show();
}
}
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
class Depth {
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
this.scale,
this.numbers,
);
this.readout = new Readout(this.canvases.depth, () => [blocks, lines], (column, row) => this.value(column, row));
this.show();
this.loop();
}
slider(key, name, max, step, take) {
const id = unique(key);
const input = el("input", { type: "range", id, min: 0, max, step, "data-depth": key, oninput: () => take(input.valueAsNumber) });
const output = el("output", { for: id });
return { input, output, node: el("div", { class: "row" }, el("div", { class: "line" }, el("label", { for: id }, name), output), input) };
}
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
title("first", paired ? `First picture, ${near}` : "As taken");
title("second", `Second picture, ${far}`);
title("sharp", paired ? "Sharp picture of both" : "Sharpened");
}
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
if (this.message.textContent !== text) this.message.textContent = text;
}
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
for (let i = 0; i < sharp.length; i++) {
const more = (sharp[i] - frame[i]) / FULL;
for (let k = i; k < planes.length; k += sharp.length) planes[k] += more;
}
drawPicture(this.canvases.sharp, picture);
}
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
let packedTables;
async function tablesAt(index) {
const bytes = await (packedTables ??= unpacked(depthText));
const begin = CAMERA.sizes.slice(0, index).reduce((sum, size) => sum + size, 0);
return bytes.slice(begin, begin + CAMERA.sizes[index]);
}
const UNNAMED = "Point spread function, live";
const VIEWS = { fine: "finely sampled", sampled: "at the pixels’ centres", averaged: "averaged by pixels" };
const STRETCH_NAMES = { linear: "linear", sqrt: "square root", log: "logarithm" };
const MAPS = { auto: "automatic", inferno: "inferno", viridis: "viridis", cividis: "cividis", gray: "grey" };
function cueMore(box) {
const look = () => box.classList.toggle("more", box.scrollHeight - box.scrollTop - box.clientHeight > 3);
const watch = new ResizeObserver(look);
const follow = () => [box, ...box.children].forEach((node) => watch.observe(node));
new MutationObserver(follow).observe(box, { childList: true });
follow();
for (const name of ["scroll", "toggle"]) box.addEventListener(name, look, true);
}
function layout({ state, set, controls, lessons, presets, actions, only, level, docs }) {
const shows = (key) => !only.length || only.includes(key);
const page = { selects: {}, numbers: {}, plots: {} };
const title = (key, text) => el(`h${level + 1}`, { class: "title", "data-word": key }, text);
const pick = (key, label, choices) => {
page.selects[key] = menu(label, choices, state[key], (value) => (actions.pick ?? set)({ [key]: value }), { "data-key": key });
return shows(key) ? page.selects[key] : null;
};
const canvas = (name, label) => (page[name] = el("canvas", { role: "img", "aria-label": label, width: 16, height: 16 }));
const button = (name, text, title, onclick, more) =>
(page[name] = el("button", { type: "button", title, onclick, "data-action": name, ...more }, text));
const figure = (name, text, menus, ...children) => {
const caption = el("figcaption", {}, title(name, text), el("span", { class: "menus" }, ...menus));
return el("figure", { class: name }, caption, ...children);
};
const notice = (page.notice = el("p", { class: "notice", role: "alert", hidden: true }));
page.said = el("p", { class: "unseen", role: "status" });
page.bar = canvas("bar", "Colours from nothing to the brightest value");
page.ticks = el("div", { class: "ticks", "aria-hidden": "true" });
page.ruler = el("div", { class: "ruler", "aria-hidden": "true" }, el("span"), el("i"));
page.stage = el(
"div",
{ class: "stage" },
el("div", { class: "frame held", hidden: true }, canvas("held", "The held setting A"), el("b", { class: "tag" }, "A")),
el(
"div",
{ class: "frame now" },
canvas("psf", "Point spread function"),
el("b", { class: "tag", hidden: true }, "B"),
page.ruler,
),
);
page.work = el("div", { class: "work", role: "status" }, (page.working = el("span")), button("stop", "Stop", "Stop computing", actions.stop));
page.stage.append(page.work, (page.computed = el("p", { class: "computed", hidden: true })));
const psf = figure(
"psf",
"Point spread function",
[pick("view", "Sampling", VIEWS), pick("stretch", "Stretch", STRETCH_NAMES), pick("map", "Colours", MAPS)],
page.stage,
el("div", { class: "progress", "aria-hidden": "true" }),
el("div", { class: "scale" }, page.bar, page.ticks),
);
const onchange = () => actions.file(page.file.files);
page.file = el("input", { type: "file", multiple: true, class: "unseen", tabindex: -1, "aria-label": "File", onchange });
const choose = (accept) => {
page.file.accept = accept;
page.file.click();
};
page.heldPicture = el("input", { type: "checkbox", onchange: actions.before });
page.before = el("input", { type: "checkbox", onchange: actions.before });
const hint = "A picture of your own; it stays in this browser. Or drop one here";
const picture = figure(
"picture",
"On the sensor",
[
pick("picture", "Picture", PICTURES),
shows("picture") ? button("choose", "Open …", hint, () => choose("image/*"), { "aria-label": "Open a picture" }) : null,
shows("picture") ? el("label", { class: "tick" }, page.before, "without lens") : null,
el("label", { class: "tick", hidden: true }, page.heldPicture, "through A"),
],
el("div", { class: "stage" }, canvas("recorded", "Test picture"), (page.rings = svg("svg", { class: "rings", viewBox: "0 0 384 288", "aria-hidden": "true" }))),
);
const small = (name, text) => {
const note = (page[`${name}Said`] = el("p", { class: "note" }));
return el("figure", { class: "small" }, el("figcaption", {}, title(name, text)), canvas(name, text), note);
};
const pupil = el("div", { class: "pupils" }, small("wavefront", "Wavefront"), small("fringes", "Pupil, one fringe per wave"));
const number = ([key, [name]]) => {
page.numbers[key] = el("dd", { "data-number": key }, "–");
return el("div", {}, el("dt", { "data-word": key }, name), page.numbers[key]);
};
const numbers = el("dl", { class: "numbers" }, ...Object.entries(NUMBERS).map(number));
const plot = (key, text, legend, held = [["held", "A"]]) => {
const made = (page.plots[key] = new Plot(text));
const keys = [...held, ...legend].map(([kind, text, b = ""]) => el("span", { class: `key ${kind}` }, el("span", { class: "b" }, b), text));
const caption = el("figcaption", {}, title(key, text), el("span", { class: "legend" }, ...keys));
return el("figure", { class: `curve ${key}` }, caption, made.node, made.readout);
};
const plots = el(
"div",
{ class: "plots" },
plot("profile", "Profile", [["main", "mean over angle", "B: "], ["limit", "unaberrated"]]),
plot("energy", "Encircled energy", [["main", "share of light", "B: "], ["limit", "unaberrated"]]),
plot(
"mtf",
"MTF",
[["main", "x", "B "], ["second", "y", "B "], ["limit pixel", "with pixel"], ["limit", "limit"]],
[["held", "A x"], ["held second", "A y"]],
),
);
page.preset = el("select", { "aria-label": "Preset", "data-key": "preset", onchange: () => actions.preset(page.preset.value) });
const names = presets.map((preset, index) => el("option", { value: String(index) }, preset.name));
page.preset.append(el("option", { value: "" }, "Presets …"), ...names);
page.source = el("details", { class: "source note", hidden: true }, el("summary"));
page.hint = el("p", { class: "note" }, "Drag a slider, or type a number; double-click for the default. Click any word, or “?”, for its meaning.");
const compare = el(
"span",
{ class: "group", role: "group", "aria-label": "Compare" },
button("hold", "Hold as A", "Keep this lens to compare others with; sampling, window and pixel are those of B", actions.hold),
(page.compare = el(
"span",
{ class: "group", hidden: true },
menu("How to compare", MODES, "beside", actions.mode),
(page.scale = menu("Scale of A and B", SCALES, "one", actions.scale)),
button("turn", "Show A", "Change between A and B by hand", actions.turn),
button("exchange", "⇄", "Exchange: go back to A, and hold what is here now", actions.exchange, { "aria-label": "Exchange" }),
button("release", "×", "Let go: forget A", actions.release, { "aria-label": "Let go" }),
)),
);
const files = el(
"span",
{ class: "group files", role: "group", "aria-label": "Save" },
button("link", "Copy link", "An address that restores this setting; neither A nor a picture of your own is in it", actions.link),
button("python", "Copy as Python", "The call of lommel that makes the same array", actions.python),
button("png", "PNG", "The point spread function as it is seen", actions.png),
button("csv", "CSV", "Profile, encircled energy and MTF", actions.csv),
button("tiff", "TIFF", "The values, float32, with their description; lm.PSF.load reads it", actions.tiff),
);
const opened = "A lens file (TOML) or Zernike coefficients (CSV, TXT, INT, TOML, JSON). Or drop one anywhere; it stays in this browser";
const tools = el(
"div",
{ class: "tools" },
shows("presets") ? page.preset : null,
shows("lessons") ? lessons.menu : null,
shows("presets") ? button("open", "Open …", opened, () => choose(SUFFIXES.join())) : null,
page.file,
shows("compare") ? compare : null,
);
page.name = el(`h${level}`, { class: "name" }, UNNAMED);
page.help = help(level);
const unfold = () => {
page.help.hidden = !page.help.hidden;
page.explain.setAttribute("aria-expanded", String(!page.help.hidden));
};
const header = el(
"div",
{ class: "header" },
page.name,
docs ? el("a", { class: "brand", href: docs }, "lommel") : el("span", { class: "brand" }, "lommel"),
button("explain", "?", "What every word means", unfold, { "aria-label": "Help", "aria-expanded": "false" }),
);
const hands = el(
"div",
{ class: "hands", role: "group", "aria-label": "Changes" },
button("undo", "↶", "Undo (Ctrl+Z)", actions.undo, { "aria-label": "Undo" }),
button("redo", "↷", "Redo (Ctrl+Shift+Z)", actions.redo, { "aria-label": "Redo" }),
button("reset", "Reset", "All settings as at the start", actions.reset),
button("play", "▶", "", actions.play),
);
page.side = el("div", { class: "side" }, lessons.node, hands, controls);
for (const box of [page.side, lessons.body]) cueMore(box);
page.code = el("pre", { tabindex: 0, "aria-label": "The call of lommel that makes the same array" });
const code = el("details", { class: "code", open: true }, el("summary", {}, "As Python"), page.code);
page.panels = { sensor: picture, pupil, numbers, curves: plots, code };
const named = Object.keys(page.panels).some((name) => only.includes(name));
for (const [name, node] of Object.entries(page.panels)) node.hidden = named && !only.includes(name);
page.node = el(
"div",
{ class: "lommel-live", role: "region", "aria-label": "Point spread functions, live" },
el("div", { class: "bar" }, header, el("div", { class: "top" }, tools, shows("files") ? files : null)),
el("div", { class: "under" }, page.hint, page.source),
notice,
page.help,
el("div", { class: "panels" }, psf, page.side, numbers, plots, el("div", { class: "beside" }, picture, pupil), code),
page.said,
);
page.tip = explainOnClick(page.node);
return page;
}
const MATHML = "http://www.w3.org/1998/Math/MathML";
const BORN_WOLF = "M. Born and E. Wolf, Principles of Optics, 7th ed. (1999), doi:10.1017/CBO9781139644181";
function math(name, ...parts) {
const node = document.createElementNS(MATHML, name);
const children = (part) => (typeof part !== "string" ? part : name === "mrow" ? tokens(part) : math("mrow", part));
node.append(...parts.flatMap(children));
return node;
}
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
not on the texture. Here a wall, a panel and two moving things are seen through a 35 mm lens, with the noise of light.`,
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
const lessonState = (name) => (Object.hasOwn(LESSONS, name) ? changed(DEFAULTS, LESSONS[name].state) : null);
const askedLesson = () => new URLSearchParams(location.search).get("lesson") ?? "";
function nameLesson(name) {
const address = new URL(location.href);
if (name) {
address.searchParams.set("lesson", name);
address.hash = "";
} else address.searchParams.delete("lesson");
try {
if (address.search !== location.search) history.pushState(null, "", address);
} catch {
}
}
class Lessons {
constructor(set, level = 2, turn = () => {}) {
Object.assign(this, { set, turn });
const titles = NAMES.map((name, index) => [name, `${index + 1} ${LESSONS[name].title}`]);
this.menu = menu("Lessons", { "": "Lessons …", ...Object.fromEntries(titles) }, "", (name) => this.open(name));
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
const styleText = ":host { display: block; container-type: inline-size; }\n:host([data-large]) { zoom: 1.3; }\n:host([data-large]) .lommel-live { --screen: calc(100vh / 1.3); }\n:host([data-large]) :is(.files, .under, .numbers > :has([data-number=\"time\"])) { display: none; }\n.lommel-live {\n--back: #ffffff;\n--text: #1b1f24;\n--muted: #57606a;\n--line: #d5dbe1;\n--soft: #f3f5f7;\n--accent: #1d5fb0;\n--second: #b04a12;\n--held: #7b4ba0;\n--bad: #a4161a;\ncolor-scheme: light;\n--screen: var(--lommel-screen, 100vh);\n--psf: max(200px, min(340px, 0.72 * var(--screen)), min(0.6 * var(--screen), var(--screen) - 316px));\nposition: relative;\ndisplay: flex;\nflex-direction: column;\ngap: 14px;\nmax-width: 2000px;\nmargin: 0 auto;\npadding: 16px;\nbox-sizing: border-box;\nbackground: var(--back);\ncolor: var(--text);\naccent-color: var(--accent);\nfont: 14px/1.4 system-ui, sans-serif;\nfont-variant-numeric: tabular-nums;\ntext-align: start;\n}\n@media screen {\n.lommel-live[data-theme=\"dark\"] {\n--back: #14171c;\n--text: #e7e9ec;\n--muted: #a3abb5;\n--line: #343b44;\n--soft: #1d2127;\n--accent: #7db4f8;\n--second: #f2a56a;\n--held: #cda3ee;\n--bad: #ff9c97;\ncolor-scheme: dark;\n}\n}\n.lommel-live *, .lommel-live *::before, .lommel-live *::after { box-sizing: border-box; }\n[hidden], .idle { display: none !important; }\n.unseen { position: absolute; width: 1px; height: 1px; margin: 0; overflow: hidden; clip-path: inset(50%); white-space: nowrap; }\n.title, .help :is(h2, h3) { margin: 0; font-size: 13px; font-weight: 600; white-space: nowrap; }\n[data-word] { cursor: help; }\n[data-word]:hover { text-decoration: underline dotted; text-underline-offset: 3px; }\nfigure { margin: 0; min-width: 0; }\nfigcaption {\ndisplay: flex;\nflex-wrap: wrap;\nalign-items: center;\njustify-content: space-between;\ngap: 4px 12px;\nmin-height: 28px;\nmargin-bottom: 6px;\n}\n.note, .unit, .legend, .tick, .inline, .readout { color: var(--muted); font-size: 12px; }\n.note { margin: 4px 0 0; }\nselect,\nbutton,\n.line input,\ntextarea {\nfont: inherit;\nfont-size: 13px;\ncolor: inherit;\nbackground: var(--back);\nborder: 1px solid var(--line);\nborder-radius: 6px;\npadding: 3px 8px;\nmin-height: 28px;\nmax-width: 100%;\n}\nselect { padding: 3px 4px; text-overflow: ellipsis; }\nbutton { cursor: pointer; }\nbutton:hover, select:hover, .line input:hover { border-color: var(--muted); }\n:focus-visible { outline: 2px solid var(--accent); outline-offset: 1px; }\n.menus, .group, .tools, .inline, .tick { display: flex; flex-wrap: wrap; align-items: center; gap: 6px; }\n.menus select, .menus button, .inline select { min-height: 26px; font-size: 12px; padding: 1px 4px; color: var(--text); }\n.header { display: flex; align-items: center; gap: 4px 12px; min-width: 0; }\n.name { display: -webkit-box; -webkit-box-orient: vertical; -webkit-line-clamp: 2; margin: 0; min-width: 0; font-size: 15px; line-height: 17px; font-weight: 600; overflow: hidden; overflow-wrap: anywhere; }\n.header { min-height: 34px; }\n.brand { color: var(--muted); }\na.brand { color: var(--accent); }\n.header button { min-width: 28px; padding: 3px 0; border-radius: 50%; font-weight: 600; }\n.bar, .top { display: flex; flex-wrap: wrap; gap: 6px 16px; align-items: center; }\n.top { flex: 1; justify-content: flex-end; }\n.top:not(:has(button, select)) { display: none; }\n.tools { flex: 1; justify-content: flex-end; }\n.tools > select { flex: 0 1 15em; min-width: 7.4em; }\n.tools > [data-key] ~ select { flex-basis: 11em; }\n.under { position: relative; height: 18px; min-width: 0; }\n.under .note, .source summary { margin: 0; overflow: hidden; text-overflow: ellipsis; white-space: nowrap; }\n.under .source:not([hidden]) + .note, .under .note:has(+ .source:not([hidden])) { display: none; }\n.source summary { cursor: pointer; }\n.source.warns { color: var(--bad); }\n.source[open] summary { position: absolute; inset: 0 0 auto; z-index: 4; white-space: normal; }\n.source[open] summary, .tip { padding: 6px 10px; border: 1px solid var(--line); border-radius: 6px; background: var(--back); color: var(--text); box-shadow: 0 3px 14px rgb(0 0 0 / 25%); }\n.tip { position: absolute; z-index: 5; max-width: min(320px, calc(100% - 16px)); font-size: 13px; }\n.help { columns: 300px; column-gap: 28px; padding: 12px 14px; border-radius: 8px; background: var(--soft); font-size: 12.5px; }\n.help details { break-inside: avoid; margin-bottom: 12px; }\n.help :is(h2, h3, h4) { display: inline; }\n.help summary { cursor: pointer; }\n.help dl { margin: 4px 0 0; }\n.help dl > div { break-inside: avoid; margin-bottom: 5px; }\n.help dt { font-weight: 600; }\n.help dd { margin: 0; color: var(--muted); }\n.notice { margin: 0; padding: 8px 12px; border: 1px solid var(--bad); border-radius: 6px; color: var(--bad); }\n.notice textarea { display: block; width: 100%; margin-top: 6px; font: 12px/1.4 ui-monospace, monospace; color: var(--text); }\n.side { min-width: 0; }\n.hands { display: flex; flex-wrap: wrap; gap: 5px; padding-bottom: 10px; }\n.hands button { padding: 3px 6px; }\n.controls, .section { display: flex; flex-direction: column; gap: 4px; min-width: 0; }\n.controls { gap: 14px; }\n[aria-disabled=\"true\"] { opacity: 0.5; cursor: default; }\n.head { display: flex; align-items: center; justify-content: space-between; gap: 8px; min-height: 26px; }\n.pair { display: grid; grid-template-columns: 1.35fr 1fr; gap: 10px; }\n.pair:not(:has(> .row:not([hidden]))) { display: none; }\n.choice > [data-word] { overflow-wrap: anywhere; min-width: 0; }\n.choice { display: flex; align-items: center; justify-content: space-between; gap: 8px; min-height: 28px; }\n.choice select, .choice button { min-height: 26px; font-size: 12px; padding: 1px 4px; min-width: 0; }\n.choice button { flex: none; }\n.row { min-width: 0; }\n.line { display: flex; align-items: center; gap: 6px; }\n.line label { flex: 1; min-width: 0; overflow: hidden; text-overflow: ellipsis; white-space: nowrap; }\n.pair .row + .row label, .pair .row + .row .unit { color: var(--muted); }\n.line input { width: 5.6em; padding: 1px 5px; min-height: 25px; text-align: end; appearance: textfield; -moz-appearance: textfield; }\n.line input[aria-invalid=\"true\"] { border-color: var(--bad); }\n.fault { margin: 3px 0 0; color: var(--bad); font-size: 12px; line-height: 1.3; }\n.line input::-webkit-inner-spin-button { display: none; }\n.pair .line { gap: 4px; }\n.pair .line label { font-size: 12.5px; }\n.pair .line input { width: 60px; padding: 1px 2px; font-size: 12.5px; }\n.pair .row + .row .line input { width: 53px; }\n.head .inline { flex-wrap: nowrap; min-width: 0; }\n.head .inline select { min-width: 0; }\n.head .inline span { white-space: nowrap; }\n.pair .row:first-child .unit { display: none; }\ninput[type=\"range\"] {\n--track: linear-gradient(to right, var(--line) calc(8px + (100% - 16px) * var(--from)), var(--accent) 0 calc(8px + (100% - 16px) * var(--to)), var(--line) 0);\ndisplay: block;\nwidth: 100%;\nheight: 24px;\nmargin: 0;\nappearance: none;\nbackground: none;\ncursor: pointer;\ntouch-action: pan-y;\n}\ninput[type=\"range\"]::-webkit-slider-runnable-track { height: 5px; border-radius: 3px; background: var(--track); }\ninput[type=\"range\"]::-moz-range-track { height: 5px; border-radius: 3px; background: var(--track); }\ninput[type=\"range\"]::-webkit-slider-thumb { appearance: none; width: 16px; height: 16px; margin-top: -5.5px; border-radius: 50%; background: var(--accent); border: 2px solid var(--back); }\ninput[type=\"range\"]::-moz-range-thumb { box-sizing: border-box; width: 16px; height: 16px; border-radius: 50%; background: var(--accent); border: 2px solid var(--back); }\ninput[type=\"range\"]:hover { filter: brightness(1.1); }\n.hands [data-action=\"play\"] { flex: 1; min-width: 0; font-size: 12px; overflow: hidden; text-overflow: ellipsis; white-space: nowrap; }\n.lesson { margin-bottom: 12px; padding: 8px 12px; border-radius: 8px; background: var(--soft); font-size: 13px; }\n.lesson p, .lesson ol { margin: 5px 0; }\n.lesson ol { padding-left: 20px; }\n.lesson li { margin-bottom: 3px; }\n.lesson li.done { color: var(--muted); list-style-type: \"\u2713 \"; }\n.lesson .question, .lesson summary { font-weight: 600; }\n.lesson .title { min-width: 0; white-space: normal; }\n.lesson .head .inline { flex: none; }\n.lesson math { display: block; margin: 6px 0; font-size: 15px; }\n.lesson button { min-height: 24px; padding: 1px 8px; font-size: 12px; }\n.more::after {\n--under: var(--back);\ncontent: \"\u25be more below\" / \"\";\nposition: sticky;\nbottom: -8px;\nz-index: 2;\ndisplay: block;\nheight: 26px;\nmargin-top: -26px;\npadding-top: 9px;\nline-height: 17px;\ntext-align: center;\nfont-size: 12px;\ncolor: var(--muted);\nbackground: linear-gradient(transparent, var(--under) 40%);\npointer-events: none;\n}\n.lesson .more::after { --under: var(--soft); bottom: 0; }\n.stage { position: relative; display: grid; gap: 8px; }\n.frame { position: relative; aspect-ratio: 1; min-width: 0; border-radius: 6px; background: var(--soft); }\ncanvas { display: block; width: 100%; border-radius: 6px; }\n.frame canvas { height: 100%; }\n.stage[data-view=\"sampled\"] canvas, .stage[data-view=\"averaged\"] canvas { image-rendering: pixelated; }\n.stage[data-mode=\"beside\"] { grid-template-columns: 1fr 1fr; }\n.stage[data-mode=\"flicker\"] .frame { grid-area: 1 / 1; }\n.stage[data-mode=\"flicker\"][data-turn=\"a\"] .now, .stage[data-mode=\"flicker\"][data-turn=\"b\"] .held { visibility: hidden; }\n.tag,\n.ruler {\nposition: absolute;\ncolor: #fff;\nbackground: rgb(0 0 0 / 62%);\nborder-radius: 5px;\nfont-size: 12px;\nline-height: 1.3;\npointer-events: none;\n}\n.tag { top: 8px; left: 8px; padding: 2px 7px; }\n.ruler { inset: auto 8px 8px; background: none; }\n.ruler span { display: inline-block; padding: 1px 5px; margin-bottom: 4px; border-radius: 5px; background: rgb(0 0 0 / 62%); }\n.ruler i { display: block; height: 3px; background: #fff; box-shadow: 0 0 0 1px rgb(0 0 0 / 60%); }\n.ruler:has(span:empty) { display: none; }\n.scale { margin-top: 6px; }\n.frame canvas, .numbers dd, .plot, .small canvas, .picture canvas, .code pre { transition: opacity 0.15s; }\n.late :is(canvas, dd, .plot, pre), dd.late { opacity: 0.3; }\n.progress { height: 2px; margin-top: 3px; overflow: hidden; border-radius: 1px; }\n.working .progress::before { content: \"\"; display: block; width: 30%; height: 100%; background: var(--accent); animation: run 1.2s linear infinite; }\n@keyframes run { from { transform: translateX(-100%); } to { transform: translateX(340%); } }\n.work { position: absolute; inset: auto 8px 8px; z-index: 1; display: flex; flex-wrap: wrap; gap: 6px 10px; align-items: center; justify-content: space-between; padding: 6px 10px; border-radius: 6px; background: var(--back); color: var(--text); border: 1px solid var(--line); }\n.work:not(.shown) { display: none; }\n.scale canvas { height: 8px; border-radius: 4px; }\n.ticks { position: relative; height: 16px; font-size: 11px; color: var(--muted); }\n.ticks span { position: absolute; }\n.beside { display: flex; flex-direction: column; gap: 16px; min-width: 0; }\n.pupils { display: grid; grid-template-columns: 1fr 1fr; gap: 18px; }\n.small canvas { max-width: 240px; aspect-ratio: 1; margin: 0 auto; }\n.small canvas { border-radius: 50%; }\n.small .note { text-align: center; }\n.small .title { white-space: normal; }\n.rays { position: absolute; inset: 0; width: 100%; height: 100%; pointer-events: none; }\n.rays path { fill: none; stroke: #000; stroke-linecap: round; stroke-width: 4px; vector-effect: non-scaling-stroke; opacity: 0.6; }\n.rays path + path { stroke: #5ee0ff; stroke-width: 2.5px; opacity: 1; }\n.place, .dots {\nposition: absolute;\nz-index: 1;\npadding: 2px 7px;\nborder-radius: 5px;\ncolor: #fff;\nbackground: rgb(0 0 0 / 72%);\nfont-size: 12px;\nline-height: 1.35;\npointer-events: none;\n}\n.computed { position: absolute; inset: auto 8px 34px auto; max-width: 60%; margin: 0; padding: 1px 6px; border-radius: 5px; color: #fff; background: rgb(0 0 0 / 72%); font-size: 11px; text-align: end; pointer-events: none; }\n.place { inset: 8px 8px auto auto; max-width: calc(100% - 60px); }\n.place.below { inset: auto 8px 40px auto; }\n.small .place { inset: auto 0 100%; }\n.small .place.below { inset: 100% 0 auto; }\n.spot { position: relative; max-width: 240px; margin: 0 auto; }\n.dots { z-index: 0; top: 8px; right: 8px; max-width: calc(100% - 52px); }\n.dots::before { content: \"\"; display: inline-block; width: 7px; height: 7px; margin-right: 6px; border-radius: 50%; background: var(--rays); }\n.cross { position: absolute; width: 15px; height: 15px; margin: -7.5px 0 0 -7.5px; pointer-events: none; }\n.cross { background: linear-gradient(#fff, #fff) 50% / 1px 100%, linear-gradient(#fff, #fff) 50% / 100% 1px; background-repeat: no-repeat; mix-blend-mode: difference; }\n.scale { display: grid; grid-template-columns: minmax(0, 1fr) auto; gap: 0 12px; align-items: start; }\n.scale .ticks { grid-row: 2; }\n.of { grid-area: 1 / 2 / span 2; max-width: 22em; margin-top: -4px; font-size: 12px; line-height: 1.25; color: var(--muted); }\n.lommel-live.over { outline: 3px dashed var(--accent); outline-offset: -6px; }\n.numbers {\ndisplay: grid;\ngrid-template-columns: repeat(auto-fit, minmax(96px, 1fr));\ngap: 4px 6px;\nmargin: 0;\npadding: 6px 10px;\nborder-radius: 8px;\nbackground: var(--soft);\n}\n.numbers > div { display: flex; flex-direction: column; justify-content: space-between; }\n.numbers dt { color: var(--muted); font-size: 11.5px; }\n.numbers dd { margin: 0; font-size: 16px; white-space: nowrap; }\n.numbers .why { grid-column: 1 / -1; }\n.numbers .why dd { font-size: 12px; white-space: normal; color: var(--muted); }\n.numbers small { display: block; white-space: normal; font-size: 12px; color: var(--held); }\n.plots { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(100%, 230px), 1fr)); gap: 14px; }\n.curve { display: flex; flex-direction: column; }\n.curve figcaption { margin: 0; }\n.plot { display: block; width: 100%; height: 200px; overflow: visible; }\n.axes line { stroke: var(--line); stroke-width: 1; shape-rendering: crispEdges; }\n:is(.axes, .mark, .rings) text { fill: var(--muted); font: 11px system-ui, sans-serif; }\n:host([data-large]) .axes text { font-size: 14px; }\n.mark line { stroke: var(--muted); stroke-dasharray: 2 3; }\n.rings { position: absolute; inset: 0; width: 100%; height: 100%; pointer-events: none; }\n.rings path { fill: none; stroke: #e8590c; stroke-width: 2; }\n.rings text { fill: #fff; stroke: #6b2500; stroke-width: 3px; paint-order: stroke; }\npath.curve { fill: none; stroke: var(--accent); stroke-width: 1.8; stroke-linejoin: round; }\npath.second { stroke: var(--second); stroke-dasharray: 7 4; }\npath.held { stroke: var(--held); stroke-width: 1.4; }\npath.pixel { stroke-width: 1.2; stroke-dasharray: 1.5 2.5; }\npath.held.second { stroke: var(--held); stroke-dasharray: 3 3; }\npath.limit { stroke: var(--muted); stroke-width: 1.2; stroke-dasharray: 5 4; }\n.cursor { stroke: var(--text); stroke-width: 1; }\n.legend { display: flex; flex-wrap: wrap; gap: 2px 12px; }\n.key::before { content: \"\"; display: inline-block; width: 16px; margin-right: 5px; border-top: 2px solid var(--accent); vertical-align: 3px; }\n.lommel-live[data-compare=\"one\"] :is(.key.held, .b), .lommel-live:not([data-compare]) :is(.key.held, .b) { display: none; }\n.key.second::before { border-top: 2px dashed var(--second); }\n.key.held::before { border-color: var(--held); }\n.key.limit::before { border-top: 2px dashed var(--muted); }\n.key.pixel::before { border-top-style: dotted; }\n.curve { --lines: 17px; position: relative; padding-bottom: var(--lines); }\n.curve.mtf { --lines: 34px; }\n.readout { position: absolute; inset: calc(100% - var(--lines)) 0 auto; z-index: 2; background: var(--back); }\n.code { min-width: 0; }\n.code summary { cursor: pointer; font-size: 13px; font-weight: 600; }\n.code pre { margin: 8px 0 0; padding: 10px 12px; white-space: pre-wrap; overflow-wrap: anywhere; border-radius: 8px; background: var(--soft); font: 11.5px/1.5 ui-monospace, monospace; }\n@container (width < 640px) {\n.lommel-live { padding: 10px; }\n.bar, .top, .panels { display: contents; }\n.files { order: 9; }\n.header, .under, .notice, .help { order: -1; }\n.under { height: auto; }\n.under .note { white-space: normal; }\n.tools > select, .tools > [data-key] ~ select { flex: 1 1 6em; }\n.psf { position: sticky; top: 0; z-index: 2; margin: 0 -10px; padding: 6px 10px; background: var(--back); border-bottom: 1px solid var(--line); }\n.psf .title { display: none; }\n.psf .scale { grid-template-columns: minmax(0, 1fr); }\n.psf .of { display: none; }\n.side { display: contents; }\n.lesson { margin: 0; }\n.hands { padding: 0; }\n.hands, .controls, .plots, .beside, .code { order: 1; }\n.psf figcaption { margin-bottom: 4px; justify-content: center; }\n.psf .menus { flex-wrap: nowrap; min-width: 0; }\n.psf .menus select { min-width: 0; flex: 1 1 auto; }\n.psf .frame { height: min(calc(0.45 * var(--screen) - 84px), calc(100cqw - 20px)); justify-self: center; max-width: 100%; }\n.psf .stage[data-mode=\"beside\"] .frame { height: auto; width: min(100%, calc(0.45 * var(--screen) - 84px)); }\n.numbers { grid-template-columns: repeat(3, auto); gap: 4px 12px; }\n.numbers dd { white-space: normal; }\n}\n@container (width >= 640px) {\n.lommel-live { gap: 8px; padding: 10px 22px 18px; }\n.header { flex: 1 1 200px; }\n.top, .files { flex: 1 1 100%; min-width: 0; justify-content: flex-end; }\n.tools { flex-wrap: nowrap; min-width: 0; }\n.tools .group select { width: 8.4em; }\n.tools :is(.group, button) { flex: none; flex-wrap: nowrap; }\n.panels {\ndisplay: grid;\ngrid-template: \"side psf\" \"side numbers\" \"side plots\" \"side beside\" \"side code\" 1fr / var(--side, 270px) minmax(0, 1fr);\ngap: 10px 22px;\n}\n.side {\ngrid-area: side;\nalign-self: start;\nposition: sticky;\ntop: calc(var(--pst-header-height, 0px) + 8px); \nmax-height: calc(var(--screen) - 92px);\noverflow-y: auto;\nscrollbar-width: thin;\npadding: 0 10px 8px 2px;\n}\n.hands { position: sticky; top: 0; z-index: 1; background: var(--back); }\n.psf { grid-area: psf; }\n.numbers { grid-area: numbers; }\n.plots { grid-area: plots; grid-template-columns: repeat(3, minmax(0, 1fr)); }\n.beside { grid-area: beside; }\n.code { grid-area: code; }\n.psf > :not(figcaption) { max-width: var(--psf); }\n}\n@container (880px <= width < 1180px) {\n.curve.mtf { --lines: 51px; }\n}\n@container (640px <= width < 880px) {\n.lommel-live .plots { grid-template-columns: repeat(2, minmax(0, 1fr)); }\n.curve.mtf { grid-column: 1 / -1; }\n}\n@container (width < 640px) {\n:host([data-large]) .plots { order: 0; }\n:host([data-large]) .plot { height: 120px; }\n}\n@container (700px <= width < 880px) {\n:host([data-large]) .lommel-live:not([data-lesson], [data-compare=\"beside\"]) { --psf: 206px; --side: 280px; }\n:host([data-large]) .lommel-live:not([data-lesson], [data-compare=\"beside\"]) .panels {\ngrid-template: \"side psf plots\" \"side numbers plots\" 1fr \"side beside beside\" \"side code code\" / var(--side) var(--psf) minmax(0, 1fr);\n}\n:host([data-large]) .lommel-live:not([data-lesson], [data-compare=\"beside\"]) .plots { grid-template: none / 1fr; }\n:host([data-large]) .lommel-live:not([data-lesson], [data-compare=\"beside\"]) .plot { height: 110px; }\n:host([data-large]) .lommel-live:not([data-lesson], [data-compare=\"beside\"]) .numbers { grid-template-columns: 1fr 1fr; align-self: start; }\n:host([data-large]) .lommel-live:not([data-lesson], [data-compare=\"beside\"]) .scale { grid-template-columns: 1fr; }\n:host([data-large]) .lommel-live:not([data-lesson], [data-compare=\"beside\"]) .of { display: none; }\n}\n@container (width >= 880px) {\n.panels {\ngrid-template: \"side psf plots\" \"side numbers plots\" \"side picture pupil\" \"side code code\" 1fr / var(--side, 270px) minmax(0, var(--psf)) minmax(200px, 1fr);\n}\n.plots { grid-template: repeat(3, minmax(0, 1fr)) / 1fr; }\n.plot { flex: 1 1 98px; height: auto; min-height: 98px; }\n.numbers { grid-template-columns: repeat(4, auto); }\n.beside { display: contents; }\n.picture { grid-area: picture; }\n.pupils { grid-area: pupil; align-content: start; }\n.panels:has(.plots[hidden]) { grid-template: \"side psf numbers\" \"side picture pupil\" \"side code code\" 1fr / var(--side, 270px) minmax(0, var(--psf)) minmax(200px, 1fr); }\n.panels:has(.plots[hidden]) .numbers { align-self: start; grid-template-columns: 1fr; }\n}\n@container (width >= 940px) {\n.top { flex-wrap: nowrap; }\n.files { flex: none; flex-wrap: nowrap; }\n}\n@container (width >= 1180px) {\n.top { flex-basis: 790px; }\n.panels {\ngrid-template: \"side psf plots pupil\" \"side numbers plots pupil\" \"side picture code code\" 1fr / var(--side, 280px) minmax(0, var(--psf)) minmax(200px, 1fr) 180px;\n}\n.pupils { grid-template-columns: 1fr; }\n.panels:has(.pupils[hidden]) { grid-template-areas: \"side psf plots plots\" \"side numbers plots plots\" \"side picture code code\"; }\n.panels:has(.plots[hidden]) { grid-template: \"side psf numbers pupil\" \"side picture code code\" 1fr / var(--side, 280px) minmax(0, var(--psf)) minmax(200px, 1fr) 180px; }\n}\n@container (width >= 1560px) {\n.top { flex: 0 1 960px; }\n.panels {\ngrid-template: \"side psf plots beside\" \"side numbers plots beside\" \"side code code code\" 1fr / var(--side, 290px) minmax(0, var(--psf)) minmax(200px, 1fr) minmax(200px, 1fr);\n}\n.beside { display: flex; }\n.pupils { grid-template-columns: 1fr 1fr; }\n.panels:has(.plots[hidden]) { grid-template: \"side psf numbers beside\" \"side code code code\" 1fr / var(--side, 290px) minmax(0, var(--psf)) minmax(200px, 1fr) minmax(200px, 1fr); }\n}\n@media (max-height: 500px) {\n.lommel-live .under, .lommel-live .psf .title { display: none; }\n@container (width >= 640px) {\n.lommel-live .side { display: flex; flex-direction: column; max-height: calc(var(--screen) - 16px); }\n.lommel-live .lesson { order: 1; margin-top: 12px; }\n}\n}\n.lommel-live:has(.lesson:not([hidden])) .under { display: none; }\n[data-lesson] .plots { grid-template-columns: repeat(auto-fit, minmax(200px, 1fr)); }\n:host([data-large]) [data-lesson] :is(.files, [data-key=\"preset\"], [data-action=\"open\"]) { display: none; }\n:host([data-large]) [data-lesson] .top { flex: 0 1 auto; }\n@container (width >= 640px) {\n[data-lesson] { --side: clamp(250px, 43cqw, 340px); }\n[data-lesson] .psf .title { display: none; }\n[data-lesson] .psf .menus { flex-wrap: nowrap; min-width: 0; }\n[data-lesson] .psf .menus select { flex: 0 1 auto; min-width: 0; }\n[data-lesson] .numbers { grid-template-columns: repeat(3, auto); gap: 8px 10px; }\n:host([data-large]) [data-lesson] { --side: clamp(250px, 46cqw, 364px); }\n:host([data-large]) [data-lesson] .side { max-height: calc(var(--screen) - 54px); }\n:host([data-large]) .lesson { line-height: 1.3; }\n:host([data-large]) .lesson .body :is(p, ol, li) { margin-block: 3px; }\n@media (min-height: 501px) {\n[data-lesson] .side { display: flex; flex-direction: column; overflow: hidden auto; }\n[data-lesson] .side > * { flex: none; }\n[data-lesson] .lesson { display: flex; flex-direction: column; flex: 0 1 auto; min-height: 190px; }\n[data-lesson] .lesson > * { flex: none; align-self: stretch; }\n[data-lesson] .lesson > .body { flex: 0 1 auto; min-height: 0; overflow-y: auto; scrollbar-width: thin; }\n}\n}\n@container (width >= 880px) {\n[data-lesson] { --side: clamp(250px, 30cqw, 340px); --psf: max(200px, min(0.6 * var(--screen), var(--screen) - 290px, 33cqw)); }\n[data-lesson]:not([data-compare=\"beside\"]) .panels {\ngrid-template: \"side psf above\" \"side psf plots\" \"side numbers plots\" 1fr \"side code code\" / var(--side) minmax(0, var(--psf)) minmax(200px, 1fr);\n}\n[data-lesson]:not([data-compare=\"beside\"]) .beside { display: contents; }\n[data-lesson]:not([data-compare=\"beside\"]) :is(.picture, .pupils) { grid-area: above; }\n[data-lesson]:not([data-compare=\"beside\"]) .plots { grid-template: none; grid-auto-rows: minmax(0, 1fr); }\n[data-lesson]:not([data-compare=\"beside\"]) .panels:has(.picture.idle + .pupils.idle) .plots { grid-row: psf-start / numbers-end; }\n[data-lesson] .pupils { grid-template-columns: 1fr 1fr; }\n[data-lesson] .numbers { align-self: start; }\n}\n@container (width >= 880px) {\n[data-compare=\"beside\"] { --psf: max(200px, min(0.4 * var(--screen), var(--screen) - 430px)); }\n[data-compare=\"beside\"] .panels {\ngrid-template: \"side psf psf\" \"side numbers numbers\" \"side plots plots\" \"side picture pupil\" \"side code code\" 1fr / var(--side, 280px) minmax(0, 1fr) minmax(0, 1fr);\n}\n[data-compare=\"beside\"] .psf > :not(figcaption) { max-width: calc(2 * var(--psf) + 8px); }\n[data-compare=\"beside\"] .plots { grid-template: auto / repeat(3, minmax(0, 1fr)); }\n[data-compare=\"beside\"] .numbers { grid-template-columns: repeat(6, 1fr); }\n[data-compare=\"beside\"] .plot { flex: none; height: 150px; }\n[data-compare=\"beside\"] .beside { display: contents; }\n[data-compare=\"beside\"] .pupils { grid-template-columns: 1fr 1fr; }\n}\n@container (width >= 1180px) {\n[data-compare=\"beside\"] { --psf: max(200px, min(0.6 * var(--screen), var(--screen) - 316px, (100cqw - 590px) / 2)); }\n[data-compare=\"beside\"][data-lesson] { --psf: max(200px, min(0.6 * var(--screen), var(--screen) - 316px, (100cqw - 650px) / 2)); }\n[data-compare=\"beside\"] .panels {\ngrid-template: \"side psf plots\" \"side numbers plots\" 1fr \"side picture pupil\" \"side code code\" / var(--side, 280px) calc(2 * var(--psf) + 8px) minmax(200px, 1fr);\n}\n[data-compare=\"beside\"] .numbers { align-self: start; }\n[data-compare=\"beside\"] .curve.mtf { --lines: 51px; }\n[data-compare=\"beside\"] .plots { grid-template: none / 1fr; grid-auto-rows: minmax(0, 1fr); }\n[data-compare=\"beside\"] .plot { flex: 1 1 110px; height: auto; }\n}\n@media (pointer: coarse) {\ninput[type=\"range\"] { height: 30px; }\n}\n@media (forced-colors: active) {\ninput[type=\"range\"] { forced-color-adjust: none; --line: GrayText; --accent: Highlight; --back: Canvas; }\npath.curve, .cursor { stroke: CanvasText; }\npath.second, .key.second::before { stroke: LinkText; border-color: LinkText; }\npath.limit { stroke: GrayText; }\n.axes text { fill: CanvasText; }\n.tag, .ruler span, .ruler i { forced-color-adjust: none; }\n}\n@media print {\n.lommel-live { --psf: 90mm; }\n.top, .hands, .under > .note:not(.source), .tip, .menus button, .menus .tick, .header button, .choice button, input[type=\"range\"], .more::after { display: none !important; }\n.lommel-live :is(select, input) { appearance: none; border: 0; background: none; outline: none; }\n.lommel-live .numbers { grid-template-columns: repeat(6, auto); }\n.lommel-live .lesson > .body { overflow: visible; }\n.ruler *, .tag, .dots, .key::before { print-color-adjust: exact; -webkit-print-color-adjust: exact; }\n.lommel-live .panels { display: grid; grid-template: none / 1fr 1fr; gap: 14px 20px; }\n.lommel-live :is(.panels, .beside) > * { grid-area: auto; break-inside: avoid; }\n.lommel-live :is(.code, .plots, .numbers) { grid-column: 1 / -1; }\n.lommel-live .plots { grid-template: auto / repeat(3, minmax(0, 1fr)); }\n.lommel-live .plot { flex: none; height: 130px; }\n.lommel-live .side { position: static; max-height: none; overflow: visible; }\n.lommel-live .psf { position: static; border: 0; }\n.lommel-live .beside { display: contents; }\n.lommel-live .pupils { grid-template-columns: 1fr 1fr; align-content: start; }\n.section { break-inside: avoid; }\n.lesson button { display: none; }\n}\n[data-depth] :is(.panels > :not(.side, .depth), .side > :not(.lesson), .files, .tools > :not([aria-label=\"Lessons\"]), .under) { display: none; }\n.depth { min-width: 0; container-type: inline-size; }\n.depth .group { gap: 6px 12px; }\n.depth .sliders { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(100%, 200px), 1fr)); gap: 0 24px; margin-top: 8px; }\n.pictures { display: grid; grid-template-columns: 1fr 1fr; gap: 6px 12px; }\n.pictures figcaption { margin: 0; }\n.pictures .title { white-space: normal; }\n.pictures .frame { aspect-ratio: 4 / 3; }\n.pictures [data-picture=\"depth\"] canvas { image-rendering: pixelated; }\n.depth > .scale { margin-top: 10px; }\n.depth .scale .ticks { grid-row: auto; white-space: nowrap; }\n.lommel-live[data-depth] { min-height: var(--screen); }\n.lommel-live[data-depth] .tools > select { flex-basis: 18em; }\n.depth > .note { min-height: 17px; }\n@container (width < 640px) {\n.depth { order: 0; }\n.pictures { gap: 4px 8px; }\n.pictures figcaption { min-height: 36px; align-items: end; }\n}\n@container (width >= 640px) {\n.lommel-live[data-depth] .panels { grid-template: \"side depth\" 1fr / var(--side) minmax(0, 1fr); }\n.depth { grid-area: depth; max-width: max(400px, 4 / 3 * (var(--screen) - 275px)); }\n}\n";
function followTheme(node, wanted = "auto") {
const dark = matchMedia("(prefers-color-scheme: dark)");
const apply = () => {
node.dataset.theme = wanted === "light" || wanted === "dark" ? wanted : themeAround() ?? (dark.matches ? "dark" : "light");
};
const watch = new MutationObserver(apply);
const attributeFilter = ["data-jp-theme-light", "data-theme", "data-mode", "data-vscode-theme-kind"];
for (const place of [document.documentElement, document.body]) watch.observe(place, { attributes: true, attributeFilter });
dark.addEventListener("change", apply);
apply();
return () => {
watch.disconnect();
dark.removeEventListener("change", apply);
};
}
function themeAround() {
const { body, documentElement } = document;
const lab = body.dataset.jpThemeLight;
if (lab === "true" || lab === "false") return lab === "true" ? "light" : "dark";
const code = body.dataset.vscodeThemeKind;
if (code) return /light/.test(code) ? "light" : "dark";
return [documentElement, body].map((node) => node.dataset.theme).find((theme) => theme === "light" || theme === "dark");
}
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
const LOOKS = new Set(["stretch", "map", "waves_unit", "length_unit", "focal_length", "picture"]);
const LOOKS_OF_PUPIL = new Set(["stretch", "map", "waves_unit", "length_unit", "picture", "light", "pixel", "view", "side"]);
const BESIDE_PUPIL = new Set([...LOOKS_OF_PUPIL, "focal_length", "f_number", "wavelength"]);
const BESIDE_LENS = new Set([...LOOKS, "view", "side"]);
const sameLens = (a, b) => Object.keys(FIELDS).every((key) => BESIDE_LENS.has(key) || key === "pixel" || a[key] === b[key]);
const SAMPLING = ["view", "side", "pixel"];
const sampledAs = (state, { view, side, pixel }) => ({ ...state, view, side, pixel });
const FINISHED = ["hold", "python", "png", "csv", "tiff"]; // buttons that act on settled answers
const CANVASES = { psf: ["psf"], wavefront: ["wavefront", "fringes"], recorded: ["recorded"] };
function partsOf(page) {
const { sensor, pupil, numbers, curves, code } = page.panels;
const frame = page.psf.parentNode;
return { psf: [frame, numbers], rays: [frame], measures: [numbers, curves], wavefront: [pupil], recorded: [sensor], code: [code] };
}
function matters(part, key, { focus }) {
if (part === "wavefront") return !(focus === "distances" ? LOOKS_OF_PUPIL : BESIDE_PUPIL).has(key);
return !LOOKS.has(key) || (focus === "distances" && key === "focal_length") || (part === "recorded" && key === "picture");
}
const sensorOf = (state, { reduced = 1 }) => ({ ...state, pixel: state.pixel * reduced });
function longSaid({ view, light }) {
if (view === "averaged") return "averages over pixels";
return light === "white" ? "white light, seven wavelengths" : "large aberrations";
}
class View {
constructor(element, { state, onchange, url = false, controls = [], theme = "auto", lesson = "", name = "", left_out = "", heading = 2, docs = "" } = {}) {
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
const touched = (key) => key !== this.play.key && this.play.choose(key);
this.controls = new Controls({ state: this.state, set, touched, only, level });
const does = {
...actions(this),
undo: () => this.travel(this.history.undo(this.state)),
redo: () => this.travel(this.history.redo(this.state)),
stop: () => (this.stopped ? this.settle() : this.stop()),
play: () => this.play.press(),
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
root.addEventListener("keydown", (event) => this.key(event));
root.addEventListener("click", (event) => this.guard(event), true);
acceptDrops(this.page.node, does.file);
root.addEventListener("pointerdown", (event) => event.target !== this.page.play && this.play.stop());
this.hide = () => document.hidden && this.play.stop();
document.addEventListener("visibilitychange", this.hide);
this.keys = (event) => {
if (event.key === "Escape") {
this.page.tip.hidden = true;
this.play.stop();
}
if (url && event.target === document.body) this.key(event);
};
document.addEventListener("keydown", this.keys);
element.append(this.host);
this.unfollow = followTheme(this.page.node, theme);
this.fromLink = () => {
const change = fromText(location.hash), said = refused(change, location.hash);
if (!Object.keys(change).length && !said) return; // it leads to a heading of the page
this.set({ ...this.start, ...withSpikes(change, this.start) });
this.remark(said);
this.nameFromLink();
};
if (url) addEventListener("hashchange", this.fromLink);
this.fromHistory = () => {
const name = askedLesson();
if (name === this.lessons.name) return;
this.lessons.show(name);
this.start = lessonState(name) ?? this.given;
this.set({ ...this.start, ...withSpikes(fromText(location.hash), this.start) });
};
if (url) addEventListener("popstate", this.fromHistory);
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
set(change, moving = false, gesture = "") {
const before = this.state;
change = withSpikes(change, before);
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
leave(keys) {
const now = performance.now();
for (const question of new Set([this.asked, ...Object.values(this.of)]))
for (const part of Object.keys(this.parts)) if (question && keys.some((key) => matters(part, key, this.state))) question.left[part] ??= now;
}
current(part) {
return this.of[part] !== undefined && this.of[part].left[part] === undefined;
}
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
if (page.working.textContent !== said) page.working.textContent = said;
page.work.classList.toggle("shown", Boolean(said));
page.stop.textContent = this.stopped ? "Compute" : "Stop";
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
key(event) {
event.stopPropagation();
if (event.target !== this.page.play || event.key === "Escape") this.play.stop();
if (!(event.ctrlKey || event.metaKey) || event.altKey || !/^[zy]$/i.test(event.key)) return;
if (this.controls.typing()) return; // the box undoes what is typed
event.preventDefault();
const forth = event.shiftKey || /y/i.test(event.key);
this.travel(forth ? this.history.redo(this.state) : this.history.undo(this.state));
}
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
nameLens() {
const { page, state } = this;
this.named = state;
const exact = this.lenses.find((lens) => sameLens(lens.state, state));
if (exact || sameLens(this.start, state)) this.lens = exact;
this.exact = exact;
const from = this.lens && this.lens.name !== PRESETS[0].name ? `Changed from: ${this.lens.name.replace(/^Changed from: /, "")}` : "";
const { heading } = this.lessons;
if (this.url) document.title = heading || this.title;
const plain = this.depth || exact?.name === PRESETS[0].name; // where a lesson starts: its title says more
page.name.textContent = plain && heading ? heading : exact ? exact.name : from || heading || UNNAMED;
page.name.title = page.name.textContent; // the heading is cut where there is no room
page.preset.value = String(PRESETS.findIndex(({ name }) => name === exact?.name)).replace("-1", "");
page.preset.title = page.preset.selectedOptions[0].text;
const without = (exact ?? this.lens)?.left_out;
const said = [without && `Left out here: ${without}. All that is shown is of the rest.`, exact?.source].filter(Boolean).join(" ");
page.source.hidden = !said;
page.source.classList.toggle("warns", Boolean(without));
page.source.firstChild.textContent = said;
}
take(lens) {
const state = { ...changed(DEFAULTS, lens.state) };
for (const key of BESIDE_LENS) if (key !== "focal_length") state[key] = this.state[key];
this.lenses = [{ source: "", left_out: "", ...lens, state }, ...this.lenses.filter(({ name }) => name !== lens.name)];
this.lens = this.named = undefined; // other notes, even of the same numbers
this.set(state);
this.schedule();
}
get waiting() {
return this.lenses.find((lens) => sameLens(lens.state, this.state))?.waiting;
}
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
const other = { ...DEFAULTS, coma: 0.1, astigmatism: 0.1 };
const warm = () => ["psf", "measures"].forEach((method) => this.client.call(method, other, "drag").catch(() => {}));
this.warming ??= setTimeout(warm, 400);
}
checkLesson() {
const read = Object.entries(this.page.plots).map(([key, { pointed }]) => [key, pointed]);
this.lessons.check(this.state, this.settled?.measures, { ...Object.fromEntries(read), depth: this.depth?.read });
}
showDepth(shown, level) {
if (shown === Boolean(this.depth)) return;
this.page.node.toggleAttribute("data-depth", shown);
if (!shown) return (this.depth = this.depth.destroy());
this.depth = new Depth({ client: this.client, level, told: () => "busy" in this.host.dataset || this.checkLesson() });
this.page.side.after(this.depth.node);
}
learn(name, state) {
this.start = state ? { ...state, map: this.state.map } : this.given;
if (state) this.set(this.start);
this.nameLens(); // also where no value changes, as when a lesson is closed
if (this.url) nameLesson(name);
}
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
this.remark(`A was let go, for with this sampling it cannot be computed: ${error.message}`);
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
if (this.page.computed.textContent !== said) this.page.computed.textContent = said;
}
figure() {
const { settled, compare, page } = this;
const looks = Object.fromEntries([...LOOKS].map((key) => [key, this.state[key]]));
const name = page.name.textContent === UNNAMED ? "" : page.name.textContent;
return { state: { ...settled.state, ...looks }, shown: settled, held: compare.held, mode: compare.shown, shared: compare.shared, name };
}
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
mark: { said: d80_axis === d80 || !(d80_axis > 0) ? "" : `80 % about the axis: ${short(d80_axis * unit.factor)}${unitAfter(unit.name)}` },
});
const frequency = frequencyUnit(state);
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
say() {
const { page, state, shown } = this;
const none = (what) => `${what}: not computed for this setting.`;
const said = shown.psf && shown.measures ? psfSaid(state, shown.psf, shown.measures) : none("Point spread function");
if (this.settled) page.code.textContent = this.settled.psf.python;
page.psf.setAttribute("aria-label", this.compare.shown === "difference" ? `Difference, B minus A. B: ${said}` : said);
if (!shown.wavefront) page.wavefront.setAttribute("aria-label", none("Wavefront over the pupil"));
else if (this.seen) page.wavefront.setAttribute("aria-label", `Wavefront over the pupil: ${wavefrontSaid(state, this.seen)}.`);
const name = page.selects.picture.selectedOptions[0]?.text ?? "Picture";
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
tell(text) {
this.said = text;
const whole = [this.remarked, text].filter(Boolean).join(" ");
this.page.notice.hidden = !whole;
if (this.page.notice.textContent !== whole) this.page.notice.textContent = whole;
}
remark(text) {
if (text === (this.remarked ?? "")) return;
this.remarked = text;
this.tell(this.said);
}
linkText() {
const { name, state, left_out } = this.exact ?? (this.lens?.left_out ? { ...this.lens, name: this.page.name.textContent } : {});
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
try {
history.replaceState(history.state, "", text ? `#${text}` : location.pathname + location.search);
} catch {
}
}
}
export { createCore, DEFAULTS, Engine };
export function psf(core, state = {}, quality = "settled") {
return new Engine(core).psf(changed(DEFAULTS, state), quality);
}
export function mount(element, options = {}) {
const view = new View(element, options);
return {
get state() {
return { ...view.state };
},
set: (change) => view.set(change),
open: (file) => openFile(view, file),
result: () => view.settled,
destroy: () => view.destroy(),
};
}
function render({ model, el }) {
const keys = Object.keys(FIELDS);
const traits = () => Object.fromEntries(keys.map((key) => [key, model.get(key)]).filter(([, value]) => value !== undefined));
let timer = 0;
const send = () => {
timer = 0;
const { state } = page;
for (const key of keys) if (model.get(key) !== state[key]) model.set(key, state[key]);
model.save_changes();
};
const onchange = () => {
timer ||= setTimeout(send, 50);
};
const page = mount(el, { state: traits(), onchange, controls: model.get("controls"), theme: model.get("theme") });
const hear = () => page.set(traits());
const heard = () => timer || hear();
for (const key of keys) model.on(`change:${key}`, heard);
return () => {
clearTimeout(timer);
for (const key of keys) model.off(`change:${key}`, heard);
page.destroy();
};
}
export default { render };
function mountScripts() {
const scripts = [...document.querySelectorAll("script[data-lommel]:not([data-lommel-done])")];
scripts.forEach((script, index) => {
script.dataset.lommelDone = "";
const place = document.createElement("div");
if (script.parentNode === document.head) document.body.append(place);
else script.after(place);
const asked = index === 0 ? new URLSearchParams(location.search).get("controls") : null;
mount(place, {
state: fromText(script.dataset.lommel),
url: index === 0,
controls: asked ?? script.dataset.lommelControls ?? [],
theme: script.dataset.lommelTheme,
lesson: script.dataset.lommelLesson,
name: script.dataset.lommelName,
left_out: script.dataset.lommelWithout,
heading: script.dataset.lommelHeading,
docs: script.dataset.lommelDocs,
});
});
}
if (typeof document !== "undefined") mountScripts();
