// Made by `make page` with ziglang==0.17.0; SHA-256 of the sources: 588f27a140c2116961fd84aa6f18f6eef3cc7b9cb1429768c6be70bf16b0b5f1
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
const CAMERA = {"focal_length": 0.035, "wavelength": 5.4e-07, "pixel": 4e-06, "foci": [1.35, 1.8], "between": [1.2, 2.0], "read": 3.0, "offset": 100.0, "stops": [16.0, 11.0, 8.0, 5.6], "height": 240, "width": 320, "blurs": 25, "largest": 6.0, "sizes": [1646, 2270, 2910, 3674, 666]};
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
const wasmText = "eNrMeQd8E0f2/8zsrHalkbQKVg5zvuNWGy6X3iCNZq9jWrgcJIFcP+DABEQ3TrsIy2DikN4LpMly2pX0/vkfgfTee++99wr+f9/sai2R8q+/MrJ237w2r86uR2zG0gWcMcavsLv4dMamyyIGmx7DVQNmeOf6y4vTGb6iWOSF6QYRcO0gtFEAjihAiYImFwqFkCsg4MqBoQvmRARWI4idd2gtHR2A7WI4yJ6KfIFh7Q4gsFKgHjdtaCGwgzjimGBa7QOYrIAJOEAAC5q/EDpB5pgaC0DPC2SeXrsAYqBIU20treVlKMC0/mgpGXKaNQhijxaCIItEYEhEX8YCMtlevQzJWYHdhAkUGIFtRoALFzPDYIRRCR0De3APKaFkYKggs4JlwshTBKNQFSuLRLEGW4VWDM0ISYUo1iF/FOvIOgy9WiQVhoUXgrIBLdBr0krRHXgAGAFD5BApiQdKClHYIkfCWNoaWEZaE8VoAB+KAYyHILFbETYW4MJcB76CHmrjhUiMJqG6iqdaQ3gPCwejllGXVrQWoFC2A0PTIi2AQkk0iK67qIAi5UH4KXyVMBaCBaJKgGJdK7hhjobrCNbQXkWFHQQ6TNoy1AddY9FifBkhlwEpxhs/OWTG0rnTli6csXjpnEXt0xa3tR48t/WQndMz5y+aOW9a+9wFrdMObG1n8dj8RQsWtM63wNXW3rqQJUKEnD1j7nymjFJqTYqxZCrtOJnNMgMyNEzpOOl4jJmOVI6yM3XZ7IDNfwICY9JMOwPT6XrpqEGmKTHS9ZwbhhCYhX9AOhgDoMbm9XZwcdRPk1gg0/CzARkGFmYyGrhFQ9Uz05aVoRzb/rniSgEe/Iu0m/OAs7ewhvxyS/mrreTgraWzzbbbKlptO1dtr3ZQqs7ccfudbNhrbLllXd0Aq27nQXWOUs4uUgzdaYAjh8mh9bvaGEBy+MYZHHKYGVNSmWlTKglIynqTOfRV8IaQKryma27hdZPJ9wn8wBVjN2egxDq7yz0Q/iF7Dhyo1x48HKQRXMrh/bY4gCQiIqRibKTNYaciPN8ZQVE2lxzeOECBYDp1ozgcN3dU+GYCJcwZxjlcB8oerupHe/Wm2SgbZdNwXzVC3851zYZt7+WYLaZp25yrNK+H/TA0rWhIpx5q8KeYQwNatzJsPsa26wxrF9viY8dls9w2DMMcP2HvbAsfNfHX+wwf9BuDT5o8SO3r7MfTP3fsuv0Hp4fYk1AOTAeA1wdFlLWyDoc8V5VVRw6R9WqK9ohN1TyOyo4kIG3L0cohKzhiZBgQ2UGLJB2r7gCDG5Y9ZKKaOHhwXd1ge6oSQoDjt4Er6d9Zyh7Gf++kZXovxzHcP/zR/lPasfUY/+fxf6Q/0x7/l2lZTmspBMzh9Q5ghJ+rYUOUGkAJofqU0ycNS6dn2H+dVGepIVwZyE1/8Ti2AVv+8Cdh2dqCydoCY6Kc6cxKp22FP2m3OrYCUth2fZqnOedprcA2pchmZ/9p2iSbH/iHGAp2cN2AIaNGGdrbeq3JtLOUzcA4pEeONnfMmsw2q7HS3HHT6ShUgTEna/xp2lz+BzeITj70VdpZY56abzc5XDr7KEWuAK9tErYhBnLBh8Jwte+QMXULpFxYN3z4oEFqq6GW2mpE1rItRDGbVaol3WK1cOVYU9FfVtqqKafJKChdv1TAtpzM0+S0YrrM4YiRrq8EBB/KQCUBAFtmKdjD6pXp8H4AY/Dggd7AgTZGo610DO1F2cU7jaf9I9uCxbC0XmErOSybzS4Z3WYPt+HoDhP5UuXsYe8r1WQsAJ2wQEErAKMd6hlHGKjMEAhSAGsOMmWoDXo1TpFvQIILnCHbwYRzsHmiVOvq6pRFJleVOCmXBgbhoX6okkOHBsKH8PpDgmhZgX7e76vEh9nwbzQ/9DD7b4EhnAK1eHy2ZdiS0TYGp4V2t1HxUawCzU1y2OFbFna34NTvhzUtGyY56JiAI9ywaq5aOaMleXqyMoaSoZI7Aw2kBst0ICS201G0dQEhbKAGuwWtVo+4BEmGSGiHNqKTD5X1soKyK3dsxenJySkZPZbzFRyXzDJp8cX8DnxMydkKEdvNKnK/s7PTVkXmdz69XN+ZnjwWTE4N7+tvDphufRxz6wSxeWxB64JFbYcJpqbNXTi3fe6M+XP/1opeblu0aAFbzeNLW9unzZ974Jx2dnYwOXjGwtal7HxuLF46m13A1cyD2qctbZ25aOGspexSrohl5ty2mfPBdDVPBuC01ra2RW3sFp5etHAaBCKOW3lqYeuMtmkQb2+bsbSd3cfjRG9rnTFzDnuYJ8Bf4X2Ux9tmzJp70NJpi2azp3i6IoMH/dyZrexpbkdaXuPyr/MPamPv8YS2Z8aC1rYZ7OKkOat1cfsc9q+kRs+eO7+9tY1dm4yF0A3J+FeCM5+r2/mI0SNHNY0b09w4tmWv8Xtj4/7NpMn77rf/lIP+wf/Jj5YPmA+ZT8gX5bOxO2PnWZ9a31gv2a/Yz9rXqxvUo+oxdQI/hZ/Gz+BHiG5xpDhKHC2O5SeJs8W54jzRK84XF4i/i3+Kf4nLxZXiKnGduF7cINaKdWK9uFXcJm4Xd4t7xX3ifvGAeFA8Kh4Tj4unxbPiOfGSeFm8It4Qb4q3xHviffGB+ER8Kj4TZ8tz5LnyTyX5pew0l5srzJXmyeYp5qnm6eb55gXmhebF5iXmpeZl5uXmjeZt5u3mHeZd5hvmm+Zb5jvmBbELYxfF/h57K/Z27J3Ye7GrrKuta6zrrJutW6xbrdutJ62nrKetZ603rDett6x3rCPsbvtIe5X9jv2u/Z79gX1h/KL4xfF/xK9OXJO4NnF94o7EnYm7Evcknkk8m3gu8Xzis8TniS8SXyVWqzXqLHWOOiZ5XPL45EnJU5KnJs9Irk6uSZ6fvDCZuOZLb02qkWWWZg7JHJb5W+bwTCGzLNOR6dRFj9Lv4pmVPHMEz3TzzJE8s4pnjuKZb3lmA89s5JneZOaYlNqCiSafbSXWP758FRuTYkz5SOhuwTzThSZh6lIOJtHkomfs8Snmshamx4vFco5pfJ8zCXjuLz80n+NJoWpZQNgwUF8mNPgrFhMLV5p77ypt042KtusX76O13WUFrLUsIHw4R18mNvgnO2ABA9lg5S9pHta9rqyesC3eIYq8w9BfowNa2VrPaB626iJPwtglnlntxl7lkBiQfD/vd2ZcsyFnKrJnrRfTkpYm22RatWQskoyHkvGGnE2SYq2X0JIqIENSVEsmvk8yrnSsTX+jQ9GxQR+fClwsu6LkKDfu33tIPpcEU1wTobVCdZP+PdbYBjBJqFuSS7mWvluu0nfpJpp5d/PGPj2crubOYGRW5hJuDCR4465qBo1pGl/ppV2D8AYJQcJzOsAYwjHQNmE3OgpeBkg37QJ0AULWjbkO8GCfckkhl9YOJl3TtfP+mYvynjnPs30OR4C2/caJ8Cjh2pd05ww34a9HDOZdsiqXSApy/Vi4bmq+pjxFtJnlDFA0po/tAwTPxYBMhwS6uWm/k5MWz+mGKfFLvMyqlWRTdzPb75KVuRiMzazKpVFqgWHjYEEyZ7qJnAH5hMZDvz+J1Ec4GBfaZpC9sDQPmx2iuobrBLoNiAYf13JTS724K6Ed/OkCmGJRUAxSCHhZziFmWJRY5mraMsS++FvIODnYnpPEiLyOzclm4JbB2yIBWK6BxA3lGpNRMNBuHOYlLvKLeQ8ep+F5800MWrXr6dB1wzXJ7pwJrXrd2GSsFDvMM0BPccjwVXTpAqtfzMWToroSYV+oH7lCqLE+lpUNN+QElbAbn4duuuUQ1DFNAY0jqNICt0S9ABEPVTwDSxvNKKzJKUHKsCxdVq0MyhRjPUOFhWt4ggqe9XiVnvrQKkMLK7sg9OhuMDNHQIjBUvCAoa/vF8PK1/6Pfn4HRuPTadO6VtfkBtw7D+3CIpEjkK3oUXtyXvRRUNTbY8gVo8nF3omAjEWsmC/zObhBEQFZJJlCsHRC1BeCiyIF2C9qPjLeZRPgts9d3u5xiurEBo9D+ECPpRiWYTonvuuyeWDr6zOW+Msg6KcmUBkCz/2uTpn3MweTEHguaQZTV/dFOQ4DQwnR7omtxOVPYDf3aH+HeXqSh3Sm3WV5v5CHB7vBCcTJhxVNYNQkv0g7STN3I8WB56QTXn/7OOnk0AlWPckjZrxKIXcUSHdqkrYJUnoWuhN4qaPCKjZSXGGFgP4+YzeNxEzHwifThI8VxIQU4gcjc0y5FDojHziw6Yypdi6RMl2POk2MgO0Z82Aq3agbfZ4zkUnD7+NLkDfXpAt3zTz2S4ab7hKOJnGNQFJqSShTxAvLisgi0BMadL2oN2ImHYvSqahR2IIKFxGd5/EhGtR9BvtQ7mElflnMCThYqct1OdRGZdIHNkhEn8qzzKVHB4a1xJP+Vw8et0LSvin9m599cqOxT4oDvPK2m/uMSfBFbyCG1vnixuYdXl9XyomWg0cetusHe749KgffsKvQsw4y6LE+ix6/DCZZCqJs/1QMoh/s+TVEu5tmweGKbWR2TAVSrxpISkDAgFIGpVJBcuOKbVvHbf5FY7nS740uu7D0rfDkdV6/GWWEF5mOTCzDRr3bVDCNVUavhf4i9HNtNOLQWDHZ0CVw7R4iiQJP6gwGegQ+Zo/HenDNmYoSENlT9mJldGT0adn+lvjC6zYcfWO5Zc/9Xu+++4EHR5fKLdc9849zB92fXQfwiKkbB5X4HxoBfprZDKMH2EpUGkueFcI2NlTXKvd4sZ4QU0+pj5V7esu5GNlOZmsM9qweXQU0g41lfF0BVJR2iRpMG0xwigpI/eZXIOSVIhB59uC6mSmueWljLEUGhqGV0TtTztT690AJAefKeQE2prF1wEaibqxHK8TmWg4XQ8RipZ6II6TUGgl0tQl4LXQZ+Kh07LENUeGXggiIqtxEmtl6qFW0beWDPkKjJaEzc/JxmHwr1NvS4kXqOVHQ3Xf493Zefw+JZkKWHii91/h7pCGYYny5rkiPPhYVc2+OoZLB0BeML/rYASkjKL5qqSlBMntqBI2AC+3qGT5vp569y6JWNYJeW5IyaivWgEh/H8lwhQefvOytdcU/pFhVi+liqQqwCZ/0vvDyjb/MY7XswfqFPFalLbL4xVMu7r2FQR/loTp5mPanoyd0+oVTLu5azw5ocM3eHCJhUMct8c+9aU2fgQJyu0M2p2vluqpcopCvo1YzoxamrEvMo6an9SKXmkq9nlnbmGXPck0UiiddWfbMDVnPduUGj7s2tJx3+6EPxtfc0ljekCWmlpb9Rr8w4KOb0Q/PG/ecPmvsHehP8G5IXnbo8T+/bcm9jb8/xTt1yISHGzd8yDd8DLz8+ozVq1c/1XjKVBqvhXjP3gDTceGlEgy0ekpwpabwmHrOEAaqrGojpJpa7RkRhl5m+GpPRoja7Z7c/CuxuJxu0jXoO8szG0Aj2Gzw+nNNyiCCdACiHLbcO6I4+9zS69OwHbNoevvPyh6naormwRtRppvMPg+ao0/ZM9ZoNOhrYIxBliDMPQGyRFNXhiw9JFHq7YnU9jpU1ZF97sxaK3o3saL3P8aKsqO0mmrl3I0+31UO5mrlmFYphwSUBw/wh7kQVeltzHG9adQmhK0Osr62+lls+Dc9e2afETX4x3gscldkjqZFdBigpXZP7O2fwyEDT/AzV0ot1XLMcz/dfLZ7+vpSZjU2uYrg+mK5H6J/fzkFImDxqrZq1lvq7yR1nDDov2JRCHY/Xm21CPaiCcEGBjPCXVLjGdD+KR9teFTkjOotZ/Je5U3V4N2AOO8BJ/ggbix0wx2CN3dWRhHbhG5oV8JGtLVu8TI6+In3Xn2UXU4d/NS+b9x4T8ubeKzq1r758Ql7T//oKxDcIR+e/OJWG0FoOfn1Gc7rxsbGUgm61mr9hS59swvrPNJJhWf2kIYSBRoYQNTMTN0pJT0txA+/oWE3rc0sYlGSOkYt9du3TPkm91VjBViHHbA4tUF3dUP45g4dBoQ/2EjVoCfQTfXAkiLcQyemxKabP0goLG1CKHNvH8lo8PhOOanq0fTlulI/3Fj1AoIHjy/wfmQoLXYmNERiYIjEImYOZqEiussIaQDJla6IWslouwYTy0nNotOIFyk3/LTsOD+/XcvV5XXlljUbnt9v++cvoZQtWNN+2ceXX0Xgkp9ssfH2Jf8m8NZ3zsQ+fBfAHG33/To2e9p7ZfglJ8K1d1IHD5l4+N8bwb3vqAdLs1NXELjQ/fVt9425jsC+LnbykAk3E5iaSuMxgLlYfxL20a/HRrun84B/SbY1qNotvLyUwVOq4Hqwz+r3pTU6p0E23Yi15zvPgvekDN70+eE/2FqUwUo/dRbyLr+orbqOotwt3gPNVwlw8Dah99pQtpMUVXf46qq3QNgcfVriX2xIvTRKQPGqK/lBL34wgQIz4oQ512y14nwK+dSWVempN91F2GWL3jEGPP6oxupxG7CRohUn73DFbddfBUW/58c1zI+9Tnx3Hv37s1/bhjUBnLj90T/71XBjfamm/AwXe7HUVl/5+r/7KPiRr67ExyiHL4TWn7JDt7zwpH+XEHPapTn+4WhwVMj9FriDzl7cpVu61FORGAlmKrkeVwLdq7URLEtQ3lOKFJSq9Aa5pEg25aNurLiqXzI2ZMMSBvy9QcS7hoyCErxeVMJaCVDl9aIS40q0KvhKwCuhi/jD6FfiCLwXw7tI2cWV95bp8cDU8TGTdwQvuLzwf1ZwUWGFwYk3uZxK/AdKrqboNGeKR1ms3kGqa/A8z3AN0oJISooiwT8USfafGEmpIyl1JPurDmUXPPEix3IGvF7e2fkKvOZRsVVKBM5FjgH+IceM/yLHaPOKPIFXVVtF7U6BPJlRY5FXEDVdg56R/92Th/4O9o7gaG0450VqA2zJvsysgkfhqZQ+uDK7m+XK3Q1bb9l0wOXvtJu4lQ6hfKbWc8E7hJYOjrE4vofmtzag4aJ2T8wLfpBoNldd5Ao6epN5/fQQE8EdnMEJ36CzN1E5IqPjLyDDszf/Q1oJkuGJmHDp5qhQ2Kg9wIuU4GQr0lN7hhcp0TOlrqx4QB/46/JLOoLXFlgo8C9nTVRSXNHzuioItB1y19gkTjnUNgVE5rh+fmJXYeHcaAIHG84YbjyfQ8BgOx1YKgVGmzYKCOdzjBib2e6a0c57YBynmaSayslgivUc/xfQ7EsXXxx+Mvjp8rzLQnu1DYaOPLLicrISPsJM+LZpLs/j3CgGJ4mfIjaQTuFYkqCc4YfQbgFJVY4cv9SM0nfH0kLhIbi/Uvg8c5q2wISOohMGzTVDeWoUJAJofSazW6AHWIlU5aFvJYe14ABCwh1AMLCOuVSTIhO8bVJmlWJbLKcZykPVsy1WaMrR3fQm4rPM0aAxpiagwMPaxBFx8K8IRTdzCrEj9jyzOoDo3JJtpvXrS3AC7ajMmk6taUytJmEUg00+0sRCTdAJn5kW/o7GBBzJnEqzADxHgwtqdOvTNI7M8iCzeVSJD+Z5SzwOil499INh/dOD+ow84eQJ39QTHnlSbUOSaRWl/gnTe3qvCv69XoMLayhT/KMH4OJML7HX4DIh7sR4jFoq+MYL9PufiH6ow39nh6A9+g+RTCJ5MX/54jx+2kT5I24Wnax1TEyFB0S827Obi4XK6dGiKVVvcLm4a0YnSI37wmt7ckpo5SYJRsTFB8Abu3l5OJsS/iSILb5fwYd9DBoq/mjnyzXUKbCG7b8Uz/tQf61ZwSMuF9fE4lTM42vcOGJ7ka5LPpZ+nYQKkETkgRvv1Q1iRVIAQhHPIp2ZMsFgwu+MqAFLK7LcGAU0F0MQYUI4WFfwm6uO34+GyfBvtCZQpLRL1dQDxlISMucHiwK6IIDcWNVvvjvtVa5ZtiL+YqEQWCAI04RHY8I1Q+2XP/b0sU0FT1R4D+1aFubHLkRP0jgkt6diYUt8s92T2xrXH4d29lS5/18oqk6fbWt0akqy7KXKXhpyw468wXOI8OGxIJRdCN9JLCUvg8wg0evceE/Z26zkARUvecpNIz0KZ7GbuSk3Sa8nSby5axVfRioe1CqgIAPpEgZA5mLVeBnS8cCUy4mpTNDFmr0coEsR+kyNruBPjPCrQnzJS8GstZWoxWEKmiPqG+lfd2jeb0R/6OzeaVVld11/LVnBT9dH2RNyMdp0KWf91WhFqbQq6UWNJ3pceML/JzVfAS05jp1tS7ItW6561XD27z9vs0d2aJmZvdxhZl6utzg7PH26O+meCTPzQDhZpjAzMzMzc/JOcr97JT27aF7v9gR2trps6erCpyvwJ9cjBByNfERHYd6Jo/CMwH91dPR7cMXA8fyAop/hSonoR+S6JXzQPcyjhaq/STr+5NWCTS4Vv5MqfiVU1BTz1w2G1n2KuSQwX0PlnvBhMvR++nV8X/jq1eee9qDbznUqHQHgkPHrQ0zqu7FckpnbMd5q90EKU9GQyRlawlQNYGzwoJ97NbzREqSQeVpO114dvBqH9hfOeUru7P0hxmdUGR1yMmXkfizPzbnEB1uR8nkaSE8lDkXDDR3399mFO3nmSDJ/8xQaDiLVG96VfUnqS6EEx6TPd/sNXT7i1J673xe393jy0tKRoAKQsXxuMybf6DnOpftFdqf7pULjmQjxpP82PRn9G87JCDNhXwuOJfuwUSruuZWjrvGbLOia4ftxvibnj6/H+ZpwO3i6hNrRCZse8vEpm5keZqH+wvhAC1TLrsMy9dZejw7LDAjN8WEZ9sIgjnHERf+KPhVP5rCcq9VDrwKPM+m/t/vQqxwdeuG5vC8mh14FH3oBcwWkuMTrO+4A5L4gl++kDxV0Oj17js+79MbzLuTj+LhLdoybT4/YkF49CuNOTedgQlk8TlJE7zq9An2pJqdX8IY0YeixrkKimJ6fgY6E5tsjraSZ00h2kNnQzd/uvmT1OCSw+yomrM+PkyZy1l/SK5wXYwx81Y982vfTMQ4G5uIbMNnwBKTTudZTUKXjmP36J38g05Ng3fEPxTuieO4Anlw5Kb5dinNqsfhGmAiR3Cvubu+8jN3t4i24WS9+jRQ/nDaTa6ysz7GVjg0ufjIa+Dzukt8lnuwPOMTP8K6BxT/ZcP6Vi69EE2Z9VV7JpjcnIb6ATK9Jqjd4lCmGJqrZR53xNJCvx3qOC5rV9/vqwOd4363y+bK3ww3vM9Nc19XDjd56aCApnPb1Jd2X9J7aja8c7JKE/h4zEW2Iy8WXMf6a/eRRUcFr/IOUwC566et9X/1HQ8FRdY2awpsUC55BLFjJRytMBuWQX0PoIKmgkhWQG51mN+WFtFy0V0tswf/DQe8KaN6SNklMS/7Tcx6mFbvkRz55lvhm6aIfzXNzIcKnCD4CbwRdrwU8FcFTAM/QFE/gLT6djyoUQJRzGX3giyV2WkMG3xZvgBGYC6/ajGIyFFMs1WiVe8UgUXO17NR6TCrFpI5iUikm9/kqLxCKQn/m6M+MOjI/Cq23K8HV6NsGm4/Ut3Xq2zr0LSuwvRO3Of5mn9/bM/DLCEfRehO7uERJKcVmCbqZaxAl3VPayXD1FR5XVZIrl1CyBBQCBBWXKFDL3kiU1KyBvPP2KH9yyR8j+VNz/ow6+HvxQJ3Gx3oHm02jo6COP/ChYw3O1w68XmJ5ufuOpaNPE0tJ76hj9fE71ow79l4Q4jlKMm7xZo79C1VKXcMKe0NBeBMCMD6XfSpHXqbIqargeCS6QpykfMZTLqfxJDo9ja4EaBjoEEcHFhiWpdwf9BX3PRSWYcx7JaBx55/d58vyffYJiKQdKiDG8sK76HWUdEJJR5QKr8dD+tXHnnW/65Oms+63WiZzCIDvvvyksBUaPuunsnj5++mqZs6MLh56DdllTLAgB72v+y7RSw4uH5JnT2AJBYmcmRIahn+QvazTrOqPK9GlRdeqEoi+IinCXl2vm+qB7sgYktNravmSAzaY6hTIKXHks38qufBVn1Hu8qHXIv6KPoffvRq5I6fcaoMpTaaK47pK6klBL/CwkSMhtSMekG0lGZH3tr/3lx+COPLhey4/CbFx4Tf/nknBLTcHB3kEB0g2Rbfm3UhI74AAC191XAjgBIyIF+vh78TI7MCoJC+s9PnF7/vlhyRgPu/Pf0PfbbejBaABohuhGXu9Dstu7Iod2FXkdX1s7OAmrMCddfB2oGuOg265A11MiM3SfXOe69F0o+LRO8VWYIZ5K2755kAW5fgjhEa6AHNFnEnkxQSU3YhtnF3KEtyHLVIuS5wheMDbpp1QMBUXmVzmRK/i6e5oNfxhnRfRWx+9hShNjmfAQT1GL7jh0BDl9DpUvgPeYj3t1YOyRY9V0mteAoyI5dfgpVOA9DjNkUH6jC9Eionl0I1vuizT2uLTMOeSqkxeldfe4Exb86Mla9Aji2lJw6arhCDMkkh5kBxkvjvuRxQWitPsBTPhKGCIF9P1giUEV3U/vXiMylL4AgbsLF4bEBh8ghLeXIu4jYPNTej0euyrGfvKktzPEqq4bJLLqEGBuOwLeSA24nZoDBbZZD7Qx98GvU7x/0+mgkF2SJOiNhT9Z06UeXqv8Huyg17HrI3biZz+kVeKseYyh5VLP/bF8Cs/z29JF8Mf8AXF9r1cI9lIIKrHen3YZiv/o0Ngp+5L0eDbhu8zAOzx2RPw9Wj1SK8ly4lVeLRaeI1Fu+UBaJYAiDyCb+TjvU/wkUMcbZpKaHzlz5YUoD7BEMHoeha/6kdhhh70xn16oYopACbUZQgfMd64xHe57CphsYdzXGABjgrgZLwPkkT21YCHF4r/gGjhQl6NOY/36c0GJGqK/LQ3Ht/v7A0S7oneRFr8Yv4YQoJAAAQEPCAwQMIi3QCPkiOZCiw02QQwFPEJ7iAoEHcMYcIsNcbBkafwsS98hestzsEpH5zc7ZwS5wpxzsI5O3XOrjsHx8D8G5ysPeIKnJBU2YWMGJ+YPnPiUjKNPkOHwoX7zlUGUsaQiKD1zkBLLv3R5QPHGAZMeeZC3TMlD3jqiu1SEb6C3mdzvIRDV9D3KBsLd2uejYadleTC5E4NcZiF9MeElCPCBVL60QRNjvrH0rwheyDSzAXUFN8Lr/gKodFVHnRgLwAMH01fSnRi3SF9zn0D3LinHVF36wjV8PMmrClMAGuj3bm/wc9Q2Ef0ZvpPSGj435e+oC8Mv1LmC9zotmCS7llTqcWnQCv6R4V5D9/SzcHfe8MrVtRz60lDWbWk8QK1ilHgHtfc8wKVR9DQ5oET8spAmhL1Cfkjx0GrIUdWr40bNHtQ9iioRDPS9EAUPJL43VYBUEMlTrrntPTLfRnU++ISSTjqiSx0gFsBHJbXho375zzPE+Ib8M4S3tkYbzPF27yteE8bXgnegoXAPoGENGwHJYHpPlGlwMsQdBHC8aWELL8RKJ+ViseuisJHYfaVYKONR0IXhyBDKw4mMxphBt5xdA8dcrGk+KQ5jcszfRb8loaGacr1Zj6XaGWsb+/6YkPauV/LrwoG/xsRkH3U/z96AvqJX+AtjSUp1LTYmEeyci8KfQZvZd37YBZKRO4vjhsi2/PhHP9ATui3C6jgx4Ls3Tnaa5fhlQOfLX6ELz7k6upLW8BKFEz9/fyr7O/nX3V/7zE8/q/pvVb08nQsCnkw8qtLPo9EZiAHycwsPTdi22TTnhpfeOZvmV/j5n18goyPj8KzUeZ/3LrRRHhvsKDEgppYULAgDDcG9MRCCuvy/0RYl++5sL5A0yFuQS+2wheffxz/RvKVJCzvuaA0vJLf6/BaK15xM9dAZPHZ4SFTD/e5flBE5MoL/E/55K+7RiZfP3mbv6Km3LCzXFnOjdZZrl16NXYvXX6P8LmxqfYwOXoR9mtRDwn5FQXm1Cpe5r4c9LX0rsf30cwncrEScz6aXPRLX9Fr/W6DyuKZ4198WTRleX02vAB015dI5HzAEyMxWa6M8/ZL947C8Ta8y3oHvWq958a3KU5CObh7O7kLnd7KRP9QecmSF70csIXlbnHiclruZOvB4xOthsy9W5Z+dosv7FUPBnXdC8EDPPlVQ774LdmWHu7lTaKC0jMlsSMY+V3BY7wrwe7wY6Ue71yDzt7Oy7KkuLVx3Kyv+bFTHkub95kVcriV+do39NUWUUzmGOtrFvQWZzqQy3CJz1m6NdQsKdwqJ7WGdJI61JoAlOcSKMp4aydKasHTohbS1rMgPiy628GoRU/s0100jAodVYmtbVrgctKy1SHT6qnv5kjUbPe9vTtw2wm4dhu4TVTWiMlWfLEiAkXW7wILjXX0XqODejeJ2kW9Ca4GcvhQvYYUq4IgPmehgIrxwbkfldURNuv5VmALf5/i/2G9wnCQPwFQ09U1mH68Dmc1dqbx5ItJiZK/7rgZ4iEfGR+cPBVdjSEAJ5ekhpNakTR0yx9oaHwt4IORRju8luuYCupqJwOA7gvcF951FEz0Z2bAkZEjKjmQiQNZcsB1NSrDaMKYtGJQdzXQHFkUS9QiG5nQMBFfA0GBCpODGfaWi98WZlLFI+jh3CvJa1+Q1q7BiKfST8jPAoiYNKNursd5BZFi26BFiShYSYKzfSOquBblfFtJjFYUVdKw8U70QQPfit2KBQQ1M5aT0SYYtUdtSLI92zseR5ZrUc4tSl9LB5QrJuuxSUNyZTJp10xa0bJmspVRE4GAkKeKfZJ0vqWknvkQ8UygMyFUrictog162CUHOT8DltBi2QHuupXpNwepnK31X7al/6bDOXVOtqP/pDb2n/PYOXYqjLaeh4twkyE5zoYDhoZt0h2PUh6JFomLP6RQowTWYP19+Id8DqNOoxkq+1BBxTkPbW6Y4YZlbMyhs5Dheot6FHWa1XZOo1hLWjn6mmrvHfRPtfUa+qAs6s1CusrSCxkGwTL6A9vq0AtOaD9s5n4nUoyGPTcPyiw/5KP94ndRiQHoLRyh8KSIp60ux+sFmuceFNB4DwPYE2ayynO7jk2L2XTI4n6/ytsLaacQ1vTeYFUvBsWHHfJy/fXUc3iTvC+HnIo9nc0v+4oOD3hnpF7aVQRLhfmRqqCLV12OoJazh77yGUSv5Y5Hsb4WzxrokWXfhIreoSretNBQd7Mw685Q7l0Y9T2xwTnZnLFesYFcj6pQvM1GK4kSHPIt91CNNMVkg6cbri0oSoqxhxS1l7a8vM7inMyuNV3tZ+JYhTcX6+DUhfXWkiZhDkeqzhl1BchgTiAF+F1LwNtndSWENMbHPCz/+KqQu3NfyXir8dXy4UeFLpCXTiFp8A+tl12VwhVH0DtDthnbqm+AbUOo9o5wZaVuUMi+4r2RZn6lN124FEMN4p8YE7xD57C7zs+RznPwIjJwJOM0XfRtQELJFLY3YBqT8clOzeAU5jzoQ8+aeOoxg5cz3/L5BtrOfC1/M4ouuKQvqJWlTJbVsjf7pLukgOii8oW3+NCvJGYOcyr3aYe5Vr0n+SlPEZIDGKF0vSeTKkrjX9/hMkB0QI5hMDUcGscvGSV+O7gwC17FZHId+SmGG0mmihteWG9YxGQqGNAWCVzQl5IEnstP6v9pXuLoSJ3Xt5gL6rzs3WX/qmQexjDLgaEh+4YAUphyCy7BO1CjKTf8wR6u7KVCeg+NuPdEa69Eb6rrKSllL2FwL1DJOWImpgoSlf9EA3XGQa+Gf9WATh+e6OzTaMKnT6Mh0/Br0+vnMJ07KstjWfu070EKFZ3SpP3wo5Dmh089/NH8sM1XZA/fu58dviMNJ/rntsOTnm5y3OS3Hd4n9+7wfTusaJZWNCptVWilYuufyruWfDt/rhcHkUWOJGe2bhz+VDM/KRVldfi+ZKBreCliSV/hmUtdSUR1jAYGoBTK44cifPzbEeGNOyOsEWF9nAhrRNi8L2by95Xh7Zubv47TWEk6KGzxuOign4fEmEtiNHiPvrlEXVfjqr7Uk5LcB2gdnsrPD9Dcz/c5Y4aLasjIHN1x9vyLxljwikYhhUNqLqO9GoYlzSqE4AL/nIBC+m1Lq6MkMm2gedcF5gTFL+33DrqFTAF7Q07zYPxzdHuv7k7S9SnkF8pEQF41O8l/sq+61J9CgMAUqTw7bi+TSuNPIeW94Y6ebU9bO+5Uu6FTDdLWXJW09af8yfeb5ZiR0Ytev8+r/anbfHOZqtRgEOdJf+pp+bn+lPTUHqG86PaOxvgc+xWCCStNArAS6BOAMiaMr1ZwPLhiHE/xYDFbB8sMg+VtxRWDxVyVwbKG61nGtb5MVZgVV3C9J8fWCQwkDCzGf0+G2Yl9QR/dl8cfXpLACTy3QpGvb6IUesqt9Au3Wy9xT8KJhp0aLtOucY5uhStdAU+CTyasYYYXHbJE2dHqIy/U6BXVZLVVDp6JRy6WY4VCcL656euGp7yqN68WXxq0j0K9gRsGbpATo/VoDjci1A3cwB2cYh7UG17c0DgPreTVHGmtZT9WPj4z7gervLqAn6KoDawZrcnFiDMTtgCbNdkK0JV0kmZchnwvyCmIGCzd0kB7E57fcImPPJQqEdA+2y4ntYZ0kroJacYlUCSWpVRs216jWtgWlsSHZe/WQ4lu4gDdRcuoKKIqsbVNC3xOWrY6ZNacN0eyZrvz7d3B207gtdvgNaKMC8a0mYgIbbYLLTQuovcFuqgvJ2GXSW/Ey0AOH6ovIMWqIIjPWSigYnxImaIyFXHTnm9XcDO9EcXcCg6IP8m2NDWilfSLc30RDJsj074Q1OlIgrQIM83bKPyEdbCd1cyhCwyCLj+fdyr+WBmkG4+wSGGFP6YXNpwg3Yr0SC57SuXiFrPCOk52sGkvqYo8ABcvtELZKRSCSIO/OQm5IefWm6l0PaLSf1+o9L/a0+WF4pzaQqffKHT6i4ROf8UWOl1P6XQ06+sHaGaX8OWe+0zm05vHaSZ96Kstopw/kgQP5Xzz3N7uQzLDjcc1E7UiBukVMWnaBum+ASP13L5GO6nMfOtxCzJdShZiMGlC7UIMiuSxnVtRJN5KpQiOdSx26bDbnLHCo7PIutt2t9tntmF6RjBdbMf0zBqm0k4QJEwtO3pFIAW1pBje9zNwf0d6nXg0Rz0FRIJziIkqKkWZQxPoTFoErcY7QWsTfW630+cq0ecFmkkMliOS36SO+HPSgySe8uewy6hjKIeGGMqWpIU/R8Knx6+CmRK7zp+LBxHF7MiDQgj0MHwwCq1YzJhNGJnMxBS1yGDjWAT6H0wIdHXtcKMQ6KR1jUDflCr1KNeLOEqLzRmVSftRWrVJDVclTZWvWJMEakfq9rjesgq5ruLQqNbEZNQIRK00EauoRwVXRU0gxdMsY6eaJExpVcaBU242uJD2yaATgzJY7JEF76RWQJF03kuDYhEmvlbEJO8X+yPBVpBA5kM72xbqnGskY4Q6p8L1Lpn0XL2t50LPZNt6TqqCps3EOfVhUoFM5bQSW8/lertGnKMk5BsGwZQ5R2pLzS7qHIkDoRXqHBgJ5l2rUewERmA2Vd+3bGCiDqvZBu78xsSdQ4ZxsIB/C3f+h7u48z9CpcxGTPn5XIoid14E7rxAQTnhzmVZR7st3PkvVbrC33TcxJ/rFf5cXzX+XF+L/udic+2SvEG3gAGVCuHPcSOgT/lzlEsf7eTPk41qmw3pTRc9QofvJtAh1TfcWBbWWUiKMYMO17Yw6Kk5bAvpCaPbGPRaGHSL/pow6Gw1baWYQofROM7tOoWOyQUT0XMThT5CQSj0dXjrMYUubHWVyGmh0Gd+2qHSHEiPKfRNkDcjyOeD3cahq4BFKXOZI0/JIjNJVfKqoDyoxUzPqd6MWXTo8kVX8cRHrSEBZy3lRF/IrAGBxs/gc+3RRbKOlIktb6TDMSYxv8o8itIgm6MMVdkBqcfQqSJbXk3SZyZANNPMmSGGUebAm9XMmU0ypwjYKaHL1Qpd/o/zOj+n8Vf+1khzqNFMjYbpNh/sGmluhTQXeNZYc5uAW6fNAZNC5Rptjg6scC+YgdXBF9RNaXNMnkKb/20ltPlpoczp4zRk3DbavN1Am81AMjuhzdepMaKeMyT74dnD9+nnIMlmgSSjmxw3QpK1RJK15NwCm7bZZpKMBj9IMvHOeazMs20kmbBeLOkt89THD0cGgDi+wQCC2cgBHiO8V+wMT7jVY4QnRwIOpF4TST1HDB4SWUkiKMzfXESLTUgJIynhQOW5S52L9F5PSnIfcMVW+uI5YdT29jlXhouG7l0izP+mCoS5BmFOahJhHrhy/HPSu0SYiyRyjKbOvSlhvjjoTsgssIiEucPoX7y6O0XXpwNh7kRACPNTkeg9jQCBKZJ4ftwuZsL8dOc2Jqzhfp9zwtbjHq039KhBwpqrkrD+tD8VWV1MoPq5Q/6qV/vTt3l3+eg46ZQ/DWL3tPTUglA+Ec4b5MwBk+1CCPMEoBXojwC0wkXbFRwPrhjH03LosHWkzDePlGPgipFirspIWccVoMZTiBvXQL0HB9ZJjCKMKgZ/IWPs5H6Afi+y5ZrZ8pMzlTjq3iW2vAlsuWOnhk8mVqt41nj+n/qUDnQaYcuTF2tsuQ5sOTwTj5yUC1uO4LybsuUO7UUoseXihllZhtJhoYtsuR2x5TcmtlxaTdhyKAls+bdVWhF9prcw5nrCmEOrJnVgJ/FV0HrKlDkUal/Ql1DmbN6rJGr7AjE9t9fywIUbj2tmYkUM0iti0rQM0r0Br/ncXo15sdLjFmYTMSbOiSqRXohFET22dyuKxF2pFMGxjsUuHXabM/bIb7vBb7vb7zPbUD0jqC62o3pmDVU9ZsZKqKHvK0IpqCXF8L6vfCXSorcQjyzqKSAStBATVShVoM4r0Zm0CFzGF1O4JrDDt9hCJ7uRVYM5HVXXSbX0pqgOAQ1nAt1EJDJ2s7xxGuIGrpYgBQ/egDdjitwuMQpWKPKCh6hQ5FoaynupNlDkBQw7rNxOKPKaqoQibyDU+LpTKJR3TVco8ku5yi+o/2LvXwAlu6o6YbzOs07Vqbp17rv61u3udU53ks6TBkLSCYF0YYOJAcn415GZz5mJJjh8txsmQeRjJJAOCdBA0BajJiGS6rqoUUGDIF7k1SBqVNBWeURlxogBo6AGRA2awH/91tr77FOP2915oMxIJ7fOPnvvsx9rr7322muvvdYrx00KOCtPz/CEKmS3qI1T9TRVsyZkr8tremMbqKW3p3HBPSnYINbNbPjhYBHC8Kw4etKYV77i6X6SVswFkLoIm2gB+Xrjwq+aUvmwGrDyrSmVa8ZaX7Ot3/FqLTv7SxUamALy2o7XqO1YDNY9YjQ2ux8xIG6nB2KA6Fyfl2YZO9cS0/hr1Viql0nxDD2j4v9+a2AQlh3U0sqI6Ur1YQGjhncMspvwrTEmcksimaveAkizl+/8yfog+/E3mtsCGoK9PbWJl77G88WBj7PfV7V22JE7i21P7O21XlN4oPR9McXZSdnVTe6rHT6sathW4R1GVGG5XFcmvcKhn5Bn7Z7B8RtYRnjLUVR6pxeo+y74YvC0MaNmYG9NRF1pvAfir1KvgmgG8pytOfIcNPBegYZ8x199tq5fIR9gXcnrgusCd3yUqnlbH7bt0696AZrsHd/Bh2sN6lBHLr5AJETVPvcYXuBwcSb7O3utIw9srqPWYn5pO3DfH6e/86x//vm1pw/3veAnln7tN3/jgQ+wWcDvPetbb7mj/d0XlxYC74IrD2ds8J5Xvuf3f/+MX3jacN9ZX3vFbx9621NgbPCWGy9+8oMffCeCV/3jx97zH//bLnz//3vllXPpT/0Ygg4E6mAkcIb+hunrIz/klZu87EcB0iK8TdaKIuSYN0tMdCSPARxA5auC2hgfTbT2CihENfoPznVAKG+DBcpoPY9Vwy5ez6NUS/kgLOUofzDiBiZB4GB4WdEAih6T2zSMqr+OZ+lP8vX/6+6DMOHRvwvxnH5vmd4//BEO9h/AL+f8wrvfjMKaPc50VFIGv4EUjmimVfzyhuvcX/1PVoRdQ/zSQB5dfWT6SPRRG5D7osl5h9REVnlk+kj0URsZAhc0sNO+omHo629u0lfEo6/y1L7+lvQVv+N9lZTB3WVfAX3xCHMbjyw9+p5qX/FNE988wi7fw36yYIg+j1OKbxP2YN8L3/yMyz/V/gy7uPLuWE9v87zg2so0GQ4ZV6/9xO//5wv/+LOM85+//czXf+6z/5knikyGV3z1Hd/9F1t/i2fQJ773Q2xj8wwY1vyZB2Fk83r2bqPGPp3tzIgCYOmlaief84oDA7UM5IxkCiof4eYcocjmvXg4OJK+CW0bJQOF774rgiNF6JLFJmfpGO/w4u9y+/6ZW/r//YcPLR340H9ES58thf80z0HkkR5LaN/H9xz6wF/9853vZw8v73jX+9/ytzlm9tu/4/aDz33lm7jvaDhjLJt4TX+uKT5UIvhQOb57otKf1sCQLp6E98EqU6VHStU48+1FwN61qmZe1f8WoGVezt/7fDGT9pDPW4z+3XcbLzAlXbz9hlCtwekqUtIGGzhYIULcHxe+/XuxqIyajzUewg6+55lblvZelfvk3gZFaMNHBwxyGMDgh4vTW4xlbbT3ykprKFhnp4NveeuHvuU//PXiMwb8yg4a6njAM8N3P/sffvDqh3Y8AznvTG7os0cFcWORPPz3nLry7tdf/6QjhNSD/+/7b5dUk3Lq/cWv3JUh5a6fefhIJeX+Iz/9zg9d94992FK/pntrJeXiv/+jf+i+5BNIOfzuv311JeWM//ael7d+4e1Iufeaa/7fSsotH/0vX3npg69ASu3l2/dVUp795YOX/9UXnykp7zu2WEn5/Gtfu/0Z744l5eBf/tlelxLe87zkba/94F4BzMJbKinf8dT3vfyK/7ymKQcvr6REp/3j9h9rh3srPifyRJbkfTZpuM9+PhAHH6YQfissNL+0ae1Imd5ipEzvJVKmQwYp06CJlOkjgJTpo4aU6SONlOnYgZTpWKUpFg8tdgo0U7PVgW5LxWElllc1bEul3z1jJ9iht9r1HXVgcrta8q1wSdne4UPqH/aFbC7Z5T5SXoId5s4HpPKIMwFUL1NXF2zHP6D8dSuoxmdfNLE+x942Lbs3mf22vOauEQvhrg2HzD5Q/TaYwL8NK0hIddfW7Gd0c6LWr83s7+4dirNMtq47TPeKx/aza7d8CbsWT7zowiaDvh/6E/7Nviw6AH04U0AqPzjyJyUyTX898JPr4mv7skHATudQl2qw4HWwS5z3rbG5y83iEcSQjzjecSEjv0iWh1JjWfJG+WaBRS148hYxwpPve8d48p6tjifUm0rI4NAXhF98ca1p9N47mH0wU+q5e9cVCvse+rkv/uFzvu8KHu+mHhdqdqXyzXXE1TmOmrcVqeKQHqHHEknNQfbDKAdRkUQ5Y9CaHXy0podIT9Uq8m3gyfmB+KZmzNs4fC0rz5suKGI/+ZqaVR87M/suuGzH2XOvf/AHyQWv7Emh1BriuIrSYS4e2qDzBbBiO2vlsI0Kf9Uwl/NZ6i1Zaul502119g8BC84z7uSyf9RYd1x8tueVNl09/NSMpxxVRfTEXOl+Yz4h/a9i3BPINhhDNn1fUEzJHlScBS5lPNyHf+cg2mB217cjK6lSQOGhaWp6Nk2f5/lT+lDLXvUqU9yFYg/ybaa47AbEY1NH0kNf+3gjYkc9srl23znabrxv3u57Rtr91k3b7Yq/a7R4vG9e/JdHin/bSRS/MVb8xnGh/rvV4t91EsUfHS0e75sX/7aR4t93EsXfPVo83jcv/u6R4j+yafFn1gxCHn7VSOH6fgzfZV8zhO6NAe/i4fHSkR6xg2+EVEXgaI9naM+3TKE9EGRhkkZrFCpB0YijPiJ+oRJRXysXsyIyXzXXqrbfHWVB/hbnp9BQKfFup+kVhjJ0JMsRJ93Lmgo6a/t2e7+4+I9Pvx8VUKjZNJfk8SqERCVghc+NByFxgAlB3wQwAZLvXuamuWXT5Hve3vXC7KVRMJcyu6bbbY0IKzWFkOuBrB1SqjYyK0cHD++bY8Z9I5jxVmQ90awcLR7vmxd/8KMjs3LT4l/my0m8zsuxCvT9aG2kBiypYvz5dlMDTTnvZu48RTMITzLP3WYKo9SR+TpaLd4379fGSL/edxJgu3u0eLxvXvzHR4r/yEkUf2y0eLxvXvwDI8V/9CSKv2e0eLxvXvxNH6sW//GTKP7e0eLxvnnxd44U/+mTKP7+0eLxvnnxHxkp/r6TKP6B0eLxvnnx944U/4VNiw9Y0PyfR9iQsGLD95dg6it7nRFZq3lyNu0MA70gQbKAq8qRl12vvigorPp2D4ybL3VOlp7hjM4ksyKyloy5RBvz7q9S6ffLNuGN3vqjr6rwRoev19hbRmJ/1MTeODXvg4ersW9C7KPmrr6euTdlDzdGunXzeAcu9PzRSnytxM++Ai5LEzRV75B4J6zx3pEaf+Lka/yN609QY1brf4ELxw7sFuRNz+QmyAe5r0has6fPfvZTN6FlN3n24z/wHPO52x3U1GRTsst/AAXrZpH49ct4VXVUdTuHlRd5cJLlPPEJkccZu1rYAiu/2yI0fJEl2RuvV5z1GRjksYf+bEPRnU/b+r/6Op4ykpTddr3G7lzTpF+D3f3szRKr8dmn5EM06If1AGm3JmFCvUvaA5wwBrBP93kxglhfH2KlKz3HeiR8h+73yuy+ye5rdl+z3+aP8OvxTg3WxJOiToyH8BCgKdhFoTSmmpan04fi7Ke0H9jnqJIcHMWlOufIQ5NEudDP3oKMLW/TJIqf4U8WHGMzW5NvEHmHIEe/hoP+w4jTJpt5fzsextIWGqu6Jg+nXAByoIABCrCKOBGaG4myRezQ+EbPC6aZBzf3qoD/4ujFnAF29URwgR8Ybqa7imkUAsUCO15godS2uRrVPqJYwTey8qA0nOZMbKfvxgihHOf9pgihtWAckEtrKGQjxhz3nLbtNgwCU6TW2JADWhuIWSuMQmsorGFglSWtwoe2zvr3VO1P41BExadwbBHYCgKtQLfayMLh7A9uMFao5QRK/Ya4xlsjIGRu6Ik8GOocD/Kzfmkv+xdLlbiFpf5ttambtTGQBmQHUf3jP3qu7uroDU8weq95nFuheCztyKrtWD9BO34OPpKm+MSX2kEl7MU4uSgWQjARueGTwYgxFHLHkBEAQwi1If4rhzCwQ0ihnsm/5ZBsavS2ZWzQPxIQgiZFqNVVHXOx+wVNDXrFFr1QK1fv44uWXm2UQuvSSbWyY809UAyYciVSg8IBD6Rld6BBK4KGat/Eq3oFuB2p/0aguvOGKqgU1/5NQfVzN2wKKjfHfuHkQRWOgMrbBFTBOKhkTR4F1R03VUFlJoQCK/s3AtbgpuMB6whS4cxMmVWSFVpWPE9XPBitvyC4C4npDUlDjvt5X+q9gn/lz4D4Lia9DWspvdyWi+9OfIsLgMMjemnQ5w24Rw04ohjgybTlFg81H8hVazYBLBpYVPkBC+y4IZf9DJoj7qzS0nNZ2m8dKGryit2DuhjDYotV1q26ha+m3vGXQAPSLODQDOIabvHg0SqmevazqAOtFO0jXFjpQrKcADuSaeUCeew1npaMKB5hYZYxrA01mTPv3uOrgS+UqrdyzOLQsP7vHvoaZOKASEtMjukuAGS00T/orWmbtbmgutLgO5GFM0zZ6bcfTsOruTA8rzDPy81TzyPSqq1P71vkMaM6SfVKAovV8w53JjM5uE9aym7zJPPMzLOmGWH5whfDQXVI5os5SmkO9tLm+eZZ/2pWWpA7AFxbLCLteA3HEGcwEBekANLHf+0VCwBew2WghTchRnBDYxf0wxmaoYX/0kOiXGyOrQDbR9bc55ZkMJiSqPmyM/y9+Qwe3FhRG6CWjBt1KMXfpTD70N97zZq0MKZ408YtkKk6n0HNQJpZbmU+a3CHWtZo0cweH/Cb5a/QcwXVAhe/ID3kGt6UL4y1vgP48Rhk/YO0lmfk0cJ7IVuby+s0j3L1+t1BnlEGKjmjGhrtYOTLDVhfevBfoCqrjfa1xdXaIszMjB8A6XvlDiFPb7taf6/vMw2QgxxwTcKxq4Mb3Vs7FqkI9MzFW8tVEdJeB6nwSXpJBrUqH8fP9DfixJeLKMG1kTw9q6V2dNluAzC+h+C6XZgfdzjmZe8QpzV1Vq/IEyWUDeRJoBuNB9joXeKQUG7UZHchPyybXSKAWIU/DH5jnWbiCzTP483eQ9IjMN/Uoc6BIsseRkw+C/VzdHsWtXAONo2fe3rWBMgxws8NxcJU+TZA180+xMPDowz8fWaQo3EAl+HgPQYFl+ZiqINbPR7a9eyitv8AQ9VQ6ZroNXvU4ScjyAwewKssEB0y27pinrj18wSIWZd9HamdakCoGTRiRhoBXKCG6SJXyXyaFNH3dMmq6eZfbuhlX0Uu2//Ziikwecye7of5AuI5cL4fAm/xiMFHvm+Zq3rfsso6nMfJFJ6i56jJwBpSYiTCp+/lM8w5sZDHjQ1Q3bzWCgXRGYryDoN9nmYU3biNc+pcEWOsqjiAvN1+IDZPRPOyIwPmYcDwUcjgkE+S4buFxDCEACYRRrGGqlLsDiY4gM01MPnQSMG4OeJ5j+UXUNSeUQysArssKJR9TbGJARty5CoSXc56/yM1+DwAjlZj97jIN5WR5CLfqZE8Qez2fy491khZgiN3ukJ+YkoFWLOvdSx/XTPLxCgS7nRFtYu7I1FHKmMA5DTuGPBDRXN/P9Nbpx5sxVFgbsPhSwSS4XCIEwKzkOl8bBrx7803lDJCUJH3ybvQlY9I8LYpp8lGUoz0FCeuYBlUHDtW2kddaR+X4Js3K00/TftSP7EDLgPL2rdSyj/X5K19b/ybXxn8028efjqUp8oXvrHYFgZEVsQ62JWkL9XCUCC4wbejJDAGQDrMZJRKM8qlGDgWHQNJgLFDTTAUeQYOQ4rKZ91CPOeCiQvO64K9gE+kC/liJXHqJ3NoLzdQBm0Bt10LDF7bDt4SLZWDt6iDV2kQ4G2qKhYRPCrB5WcVXVCbvEmLMh2bUhh1QPww+6xKNWYP93oZ06b0QhpxO7oH1vItJe1CYVsoM1dB352vUEwZpQdgxqhaBxcvddDKzZixXEs4UQtlmKpcVjlVs2Kp4gUe6N9jT/erBLxd5ZFNZD5zBFNtiZijeerR0nDAlGcBpS1Up4HsITJd4mfzDjd/FpA5JpDpPqtYFMh0ODYBrLvPwjuo0BKipSMdWlLo964slnt5B7URBzjWfGQA5oPSZRy3YXowuGhIHXzJrSvm+av5I/xAT+av7K1jKrpjMoQC1sZ5OmdNKHg+ruSWGP29bdDAAG7IMTCLItoI0VBlX9VKlXZi1rSH+BPV9F9Sjf6EhxoqK+3KoWJACbfDAdwFr+wNi8TNLxe8imdXSwbLCQp+pR5j/4G/ilu0g4EjZPX+l/01c+km+1WZyAEPrrwPc+6w2BLlxXQDVMjZhFT/NkX6LL1eK6avOL5tjy+JU3xpTsBLs7quqYO2DDyd+bfwE10/jGeDNVfw9FihhZ8TvDk2hXcigzSXdVokDB6fwnKAsr+/QXoEdl+YgjpvOrzCx/N2D01V8WGknZMBUs6zbLPD9ryJB0Q5dVn7tJFcutlj+Kl2A83t3+/zJWJtj266xPBm3tI2PCgt+LLuqGT9beMqFXGekFoid2gpg+ADhNCNalALhsqzL0uPUFjR0uv6zP1paUWDs6toweqjtDHL2qbKBgrW+VUHA3nMnwbXYoYhew+4fE+hKsuYGZWWjkaloRgmBTAvBBtwUC3jcC/G5IAEj+FqCbspfgHVscm+gh9chX+1JiLfVTrul1Md1hou0QcDSlHNhzO0OvFjDz+AOxfWnqeglSL2oGYv+wcBTChQv7fGajQ69GdyX5QS3evnIZqOLujnOnCOpkOxWZqiqNhEp/V5yKDkjfpUIHiKexbrIEPI/gm1TkUXuX+vszwpLx8NMd8NDo+3C+FAp+3mqkNYQtxJzdecWs1xP8MSO3lS5j77a98Lp7n51MluNyZWVA1prwqmzXFPqDLgy0xcxFleYpyU9GvqxFwVnyFSVmdeqIBloL56g/xBbHuQwUiJAo58yEiJImEkswdFoBZCwhNsXkuotaBNatBYfyCxKrz9eWQ3XRHyWWE6isRW6nQ/Od/kB/sq5vRQovrhw3mqPkJ5IC37yg3GRScaZB1qe1hu9WipKjb6S5Wxvd8PQiHIDn7aQncGYKypSUwRoWjyYJANLTfXTwM13aIXThM13BKL1RDMdykaY0ShQAosPmeJzdeyQtUrhwRqZ0V3lLER+5PuRCdOAbxNTgES4AWq479SLppMOQUoEt3ihq5BE10J0aDQNciJKL/NYTiVrj0pgICsyw/swtWxZmJkPwGw55eu151ZUC6M5KU/4odGNGfZ+8FyifyOSgQ6IqT27Xbinm01FcAEIxHLpZmY2Z5AjqFgYE8XE7+/sYQFNtB9c65yT0B4cg8uHhUvR4nPy34ZMSKyjHSLc/syf3m73f5J/J5q9JvKaKpG60ZHvWoCiVG7LYK7bAESpPd57D9XnQKDk913yS+977YvfeqHnr7vYx/Fvwcuzl59g9WawZZdhHDZ+cEekpjdVCuPQQhhoRfYbymiWISGIzTBTEF7RtoDOMbiYb4Ekw5uZtVj/YE15H22OgbMijpYCJHc4nzvB9asSUg1SFMek1zuOkDhRoVh7bEu6vOoln4kDLC/q54sR/b816x9NeFT8xgPyuuI3ZMnkN9Ib6YyJ10Qese/gdDLlhNs7obIhvpdYbPcfYCwZ/gtbgSSIjgXxsY7+7RBlEi+Ekl1SbgBnex/IWQ8LRYCyt2FMZRIKnnTK+DEF0V8q/xFYHysaliXYik8exXGVCgBClKUjTCDVjmdHwsUYXPYkkewS9qEo6wuQqf7XUicEbcLyFWGyKlZO9VvE9i5d98X/sPGtld//g8upii7QQmLCO3VaWVWNLQrXTXlk/vW4OPhoAhF6M8bMOhmY8GFPblQ9XtxMgwN3C7YIixweB4Zljpy6wOIM830RE+xAZeL5nH/loBx0AgmXB8VRDcKiKKKokD6eh9XQS3hOFYboUXkgV0eFlz2LgzoA4ti6EXcvAbTsUeTd1MAIF9CAbyXcwP2SehuzP69CAo27EHo4Zq/hz9MEBaIn1uBOIWMZ4Dwf9j4R75PNAl3JYt/+gbD7VPu49HN9YZyjsOXY86LKxd24U27P/PD//MHnw5txzP/37eefmbvCg57G3xB6BGqvQw8SENfOanX4SvFxhfZryjtU12Y7N3mVCUQWZnEUQBBGQiF0HruMUtDkKAQlNzwfB3cracPAFjQZYAdw7va3z2LqzzLatg4NZD0w42mXRhmdd90bXWs6xWPyqgrqwp2AxOp+F8VDDFOyWmOzloqYpVlqIsxRzhk9XtXxPsXfh7lZ5OfH+Vnys8762tiFuOBcA3+2toc/AJvdWZw3M7PDj9v9tfyjJ8Dfs7y8xA/5/h5zIN9rnyeg/dwaQsyC7DaLqJcjlnSTIha5uDhSKroIn/IQgasc6I961HsdooI4haUdnHlgmCjjhXsaD3voYzA7RJQIj5mek0rmpZtyJq3mr0HT+0WrWa/hrfK9x+R77coqLdMnT5AeLYZe8yjENXfHhVbWYbl0bKrHumZJt8Z0VZQx416seLukfZA6hbdB6hdQSKg4kb7PIJQdEAZ97ClDSzb79WmlweXaIJ+C4yYJ8mOufY+ZFyRxI36GupCsCNCzjnNBlHn+zVbTWvOPqDFQ0D60ToQoe5WgWxKXGdK3MxEnJpMcPYYxKTiCvcwVrNdw2GxbQjBe6ZgylfQ5XuDnMEGIpxvR/z9YU6Y9Nyh67Bt3TDXpHMtn2ib+sgYDinfd8Pdv/3C3f/tvosrNzWJaDttxd9lvY3yxpzN8O17B8RNquRHCwdOfjPkCLlmyvlwT5GbSwavPmhh3T6PW2sijxpw9CpxbzJxrUrch0zcQhnnQJlOiWtW4j5s4hpT4pamfNudErc62T6deRwf6TTSvJCNY82qy5oFhKm79enpVZpsz5lUQXCapt7o2VSaXiz7EN0u/pnMUvdVWNRUkOKZEyFmdvRoBunSmPR/e6KKPaGJRnIf/1Cpy7qgNbbE2DP5xmkyfsSSCwUHCnu0/hP4aqp+dv3hFDwo4bnLPLuqYcY9wupJAVBbRTM6u4QXxCLwndCmFYf/G7IjVEgMfCXjt/Az+8lDBtoOvP8S+Wl1+R9RlmDmvSQr36ubYjDwVDM9NwbBfdnmCShVg7EGU48RBYjHCch21p74AeYgLzHQjsUnNkXKUns4xLhFNWCiTb78dsEMVfKn0AgfoVQU44F13lOmDrwWCAGAriWLIF61EPdort3k2WP3Bz94Hb5CRtmw+XurChoQc+kNMvl8p3zur4KFExFW0TTmt9XTOEhQ2eIild5qN1va6YQfimDaX3GhjFNHcHrZp8GcqZnMWBpAXHwwWS5goedgcarldnWCfKe6uY/5L0LNiOs62QGD5KUUHUC7lW4DgFRf42rEnKke0NQFAHkgo5+3gcHgpjxpoziUlyajTwgtYHkQ+FEoDtlaFFBdoY9+3op+5i3UdQlOouswbkVtJqV1PZhDj2VLH4kWjvRDZX22okRL+oqMYwO5GtVBQl32gwTMPr7KjgKY6p9ah1dJEGdy/GA6DLxGVVw0MbUDyBJXwZdToLM8kFne18s9NUV3TrQ+0NX9bNxXWUCAhNUCco+6ii7UqZrwlDAlv6qe8rinGF/vB5iM5U0ttMWxgd1CBFZYLWRJjpUFP1gwjR5lIFgNe6YiQejTXocrIT41nTUYmPrJjqBrUjasknmKShHKafXFE9QalsLaJb01qjsz8tWOWpBLIVpCK+dXVfAdovyxToDQmu2NEsW+fykENqbtSmwpUOfgFRs3QfrpmA1tNK9TUnfMq5xpVbcJOJv78U+een96ziyfzRWsfHu3TDVINyvXJOFmqpa9T3CyqYTxcnJXiTb4MCWm5mBQsHHNezzdqQyLeNRGB5hubC+4iiFJiUApU2ooPAN/jC3c0BSUciNevvCL3/rnP3Qz88VNIxnT5awpty031nNB/X06VfbkbTzOymfwoLyj0r0Mj4V8tj96HsjWhOaDvS4ixBEUzUGsuLBWLIrvNFWTug7jPY8RFSuDGS0wAz3yoQxQB4f1/Nma0gowVQAEzZB7GdxB7cortUbSBuRvrA/4Jbqq7dGiihlhnhX7M4w7RHz8U1LyEPZl5hkSOU6vwgEP7xzwbo48o2JlaBwURkYl32MgvNlTGB7yFIjXKhCvViA+T4F41TgQm487EOPHA4zDRwrH76zAsQk4NkfhqA5lgeOCmL/YDFu8K4wdC3C0Vu4KHUsDmfF0cRGWkaohkDJ87t71Nz8UFELV4w25Ph1CRrEHcwfrf0ihSP12c/k+h89aU2F69r+xmS/qqBKx4lTPqKQghtZkMmiMbC4XNKYfrJnIprABeSrMWN6yjm3Vvah443GeqjGMjDo4AZ8BXRvRfuOBnAErN3T3EGewWs2M3nN01wpUDI99rDJtLf4+PkBhqREwlg5zxv7aaBY9Fjc5O641Wb+mWOt8aFCH87VEJQYTYU5FiBuqGdNP8rrq1wnZVsttHvk8RgIIxbThIHu/UC5PvZzOrJEnd92xya7b7sYyjKo+2wEiSa3UoTnwE0C2TltUETpwIYa2wEURT8AON0YKhuFOPBY505JadqsAmha4kiWuryPtBarXqX21NRU9Iw3NPducOqVoXHlQQHzyjby2xL1OZLHU4+Ejf12tvfnAiiV0Zok6mDQAlAxaFzGcXizYPi0KxOASSXgtC/H+K9TuObSuINirW92OupzczDAcyC+HYphD1ellaLRfkY10VeDgKaOgNq3BwCzTvHRVMS3DGWibIyrfVgXBQ5O78FTBSZoyI9CirisJBCHBGKXcio5Zz0dv5C67YBddvKwtQ+hBNLMEbcYDwh/XK9kExfy8WoicffplC20K968n/eXV1YoyKd1Yl2bTspoVU4UqVuLpDRhkXfIGAJKyhmbc6tIETFQld4uU0fIRLWUWabNcTneQixziWfkMBgEyoxk1Iy473EQn2mG3v10ABSljwEISqEwZwxTRbZd+M41aIkkL+O8bhmL+2WOlmN+kmAtViqnZLcFcGCeYhbfv7G9Z/fxnzlu5WGzFeGXfjn5wOKx0cxFVeNnf6o038mHIK180+l/CUKMGf3jSBXquQNHUkgI5ylLuRfKFvg95VvDv14WOLwMWOv+3TNLxZa5kS4WOdx8pHd+yCR3fMknHt6AzWybo+Bal48u2T93Hh44vTqPjC5vQ8cXHjY4vPCI6vuiCC+N0fAvN0vIEHV+YpOOLj4qOL07S8UVaAB1fOAEd71JGi+N0fOHrSsff+Hhef4NeB4e97NNvsJfdIInLvfIW3P8qE3JPtsljt+B+2/fCafouBCH+mtV3URGI7oPe5snlZTUsfZcndxyygRSmGQbVDG8dyaBmSXxrmKR/swdpgh5IBtCI0qtFofuCv4bF8P7lGDBp1n21sWZJ7D3jsf3do1UtVGvqblqRrWVhWiXJRKSTF3wjXYtfrPUhCZBjO0gLEFhPn8llYI0x177kyjq/6hN6oxLQC+mpu6pEnlHU+k1JeKEXTAquKjpOIjPqv6Q8Tw7VBkLl7B1wDvvfYwY0YC99RYAXh55Orer1jSS6zpddoid/bre4VOpfaofkIbKuZ4r3JnhaSISg4i2yb6pAubGk66yo0apSCvQWnbmrliNKbVn62IcAKDAFRoEwBxnchYPCutx8meXnR/k5N70Ms7B74imdq297So2g4la9SkJGjSWfl/h8wbYy0VY6mZzxCVWA1PGpG2vNLKTqLCYxEjmtKU9slyH4JGWxVJ4ApZok+y0ZV+jyYo90NMCcuENwep4WwYPMZHdLkxpa0PuWXMHUQMFTS0Sm90km/chmeV+10jrNIU2jrRIfzVbi3mTiMhen6jilEjfAqC3KflsPdSQq+x0hAy1R86prrmRtorYE6Mg/bjUT3fnK9QOsIkDtJfiTnBfgz4s7ezxCMyKU0IKMx9DqYLlhmGfkh4a0vrWopRrXGDaj7857NYPE2KNWlkguGFnyrnaQfNltFlvU0ZeWszgsVrLftSe+xGnGPVyPFvm/LhdvrqEsAVwr4vbLfj1kDfSiu+/75d/nLh4+FPSjteyjKA0S4y6+6FbYjpW+3mGZl6tjPeoqB5gY/nQRxUO4rxFD0+xFbd8QK7Lqp0FSBKCgDhUPRa7lFjDUWkfL7bbZUIk2LQ/guQKo3jTqxgZ6MjtlwEPV3WmvT+joTZsZ06cEZvaSpe+t9NmeN53y4UsfxlQCpXVVvVKdTkeEmFUJ25s9seLxjH/61Cf/6YYv/tytR40WhJimcFseE9iyl0oz/kAtZ6Iv+/gN5d1RXLkLsvteL+dZjuN78OL1hwIwkynorvdS1poNqIbWgrSXmSgwV85q6e/W4w7vNUF5/Zf79q7tvV7Za3PIuck2M8F6dDCA3h12TleQaMnh+mj/5WiC8LXkg1Mxmt5R9lfKp+DIKgOcdHrCClqEe9AxhXCLKcX0CTych8+hWw/n0Q1Aml+berIUqs3FPNX7xxxqaZP4xDTEnqKmbchnXIkd5LgxgJB2g4l5LNdVsE3TzUmMuSi51Y3Vp7m2xb6XL9GCXrf91RKQQwd3mh0Uy7R8e7HMk4y6zmL84N0Pz8smhlsiS2WCnbU02qMmt/jhWliTyYbCt9DKw58TZ7gS//B9Xr4iamoFRkVvT/I3nCsNRaH7mtzrh7mce5CH5EVaZhx4BeMnZhPSyQfPpEIxqnOf5vKa5NVO4mPsqXWYcKkt0Luucss1wG09CTFA7a1CZ7cxA8P5PJo5gOf3rAkIA1NeR5V7H274uovT/gXSNb/G3cxX7JxaEUSodjo1MbarNdCAmq02oLbsMQJrRjKRaJ8/z+T3Cim+n6HS0dK1m/qCRkhto8XrldmeGTNPX1cBIdOYVfJxMfIa7t6L5T7tKvUQxYhWje2hddcoPPp+zsBU1zsLAFPBxbwXKDOknj6BQPYmIc2rmE5f9D6QLjJG1K4vKXpT3py96euy4fhLt+HoVvcb959gv/Fj9cxepkkMQ+ebd+/lHJpKbpR12vcdoo53TznBkr0DlZQEWLZiJi0V29d5pG0y0ztWHYW8rnQSZ3hCEODZEQ43DEGofAGwgCC0KdzAde2NvINbYm5xrt6RK2nDvKENCxSQzXAMJsNn1otItUjzRYqMMf4IFESP6qtUozPAwfvtbPwQKDBGNbqKgaJOVleqsQIKmNCKUo2emVVd6oFqNCoTqDdGNeb5G+oJ9m4BUjYM1dhCDSQvUDRKNWqGaiwI1Yi5t4s4+hqlGo2SajTWihWlGqugFSugGqsVqqEeS+30bSvVSKtUY0XLw02ekmp0y/6tVKhGz17l7Y1TjZ6jGr0pVGOFmkI1VswJ/3Sq0TNUo3ciqtGbRjVWzZg19HUrIGQas3Wcamyl1SlUYxWtu0bhIVRjBY2crUjoZmmOtr5XdCRpVZ9sU3/OXEKkUMkE42EejRAIitJf31QIwNRBL7re/mMV03o344V1qfDQe6+IUaN7mhPXYyVZd8u/cINV2sHYoimqptQqQHGcUswDF0P7E70n6Cu9DZ9JvlyNeiGRy5tMJ1t2K3t7GalGmXz9HBnysOQMHUtbhgaGwRpJdTfnS3NQEBkGqvZRNeS3zdjn0v00SJ/uf7PfE2byb5Om8XNZErzwuqC8NnF+5TYhZBO3n8/PiE2UnF/d3YaTu1uOH9nf6h44tCLFEHHCB9T7h5ehC3qIOKpy/KyXvyq6tlWb37oXTUFqoGoA488mmU3G9v3s95GuRVO4hg3m5XLntoKXTaMY3z9IQEGl5bJx0usLmG6uOS29V9yuxAS6A6a2XBlm0eSIpL0J3p3TugeKzOhEhaoTNXrLpImtlAy9bZK7XtKh5jCfdTuwOb2NKcxfMc+LrPqYnsGjw3JyueJWLkJD6qzLHbxStYuxeLcBWB33EupQoMuOqQp2HvH77efzEgSCELjroJRBha51gBsmzacQnVnUGxuLct6xWOmPC3bEZay4IqxEUh1qVEsyJvmyLaJggj0KlE7RBbvRlFvGHd02NRHT5ZgjCqyXjZqE63voBEq+5DZaFEV9uX2I23rEjw6U9vlBGCy+H6yvqEHSq3BK5JjA7OGxMiuYLNxoTdKzP0CkHoXMCRqEqH03hZYZkvc9eE/4PVFqCaS/RSAth08ggDHN42N8J60zuLtg3mvW98nBvcOiyWdi6pEvkpGnyLjk7RwBKm0cUZXZmmW+dH8qY5kneIR5A5zd7CBv2XulDUr297svtHdKU72WdLlii+55JHpPJfZNZSxVYt+psUw6DA1ycv3WkVvTtwcBbEJPPSv0GLhFBPKUfV7lmGwvaSmP8TyEs3C5nbcKIoNLESEo/FnuSBAnfSDbHJLLK0l5PpiVIRLyFwNLcKOr1E0uWSKZgvbmClwx4hpOgsfuojFCEnwXhGeiypsLqqg3kestTdA+EYQF1ASyqG9NUc9U8UIgPzqY2d8JxxoDJQjJSVGHyxvyEdMlvDCgTHE6wgmuujj5TgUi7qoLioRGv7MuXdTX9UqTTwiNHAykb/fZW03V8TE8ulDwfnhjASM9Yq0pGX23blzUP16o+rJB6UEGBUGHrfrZg+Yzk6APLSa81X05raTpLXFFnrCtejMyVGZ4WDhyBE3071UPfZLhzZohGFG2Q4Za+gYoR8d29czc1SHcWisdIA4VmDFedVgT0aDlhJDqfFTZoAZDC0YL8JDLT9CYzG5HzXKHP08EWzCROZ+2rSGWhJwsJ6vZazfZH8la//dB7Nb50LbygbO+DlcjnW33YB33YYB1nMvTK5NTb0jmkbs9ObHU16UZ0iS5dgeJ3KC8xjjMG1ga9fIv1BOnSJjKOL19CQaDJiJTst9eyg5+0OoGxUOsQjy71gcDc1/yCxcj0dv3ZPn3eZY/ei3Z31qTNV/ABaQvnGUpJ+L3VKPfVEZTNVppp94KnbjQqXdCNXL8RqhG2u95SN1d2Ns9j4dcRReBHuHnkTMSay5i9TOKsk+ovbeaidojmTVWt63VzJ+cllljwcmHVcNWY6yq6ujJbYJrxX6WNEfvSpsr0hVKq3VX3mSglUzq3XPyZTIMs08ZaS6S762VmvFVjVe0Tb2DrqcHJhwUBLYdIR7KqwHXtbIc6B5KhYr+9WF2jy53WFIg0MY8QNWOiQtQWbbO4+CjrlIFPcOPGF4wNhhfBKiM+hBT16LrI7Socq2J+YAayr+0x08fR/z+AbXPK4djNXtSf4S4DK9yaa1icCT7e6wz6U+41rUKX9vnP46Ne7TteqPnQxJTihpgQq9EQk9xk2pXjhAnPmIN1QrtoDLuqNsvP/XLT4tIyBIssSkVu07vp098D8+UfxYF0HQqTWkeWyppZ2kPMQ9Ki4h5CMzGq9iTROBOBEaIaeSCsfh+DkaSY0trGceAZUxFY0trlbPrvyBP1E61McQ8SVobmDNg8voP/ItxsZb9acVkRoILtJGeDzW5tCaX63qRuL7BMlJDqVP19FRi97jIN5WRJJERNSkB4SbvwAbusQyGeV2yKs1SP4XaIdf1OkdLx0A2UrnS6Q4vVb8ERZhuh+7uogOGigKt3U1z+7pRChE/usSBj9pDN7XeAj0fHTQpQS1dPiTBprWIk1iLOPZIrWks4vT9fAZdadOM+vNsTQAqHYOSjiVGPYAFjYbhzL7iNrzU7rlr4SDawscL+5gIQ2EWY2wBpUF6BIrT8fXsf+NDOPpqArMxsKkw/WpQCFA9Vh4m1dkWs15+nrgCohfZ+zXDmesBPOC6BJoN/lw8XwZTeWp2iaXyV1ENUsuDQfVWg6Ms/2nvcJC+Kghwx6ycZjR2LzchMSc+/c5YxHfEMlU4JOgVcHDnGqRDi+o2C+lHF03gmA3cawMPcKB/vf9Ub2PRyQTqRiagl9cXINeUJa1pPTKrwc5W9chcODjEYnvYbz+3HWASZPfqrR1qZX+uFEj5LFMDPsCzBRM9uBBDumGrp05lCA6aOTlx93zCPk0zdB/LwtVvqZV70Qbq//EbeP4j3lq5jyU++4x5ia09+5/zQ1Vv8OCrDLKvXYDi3U1A0UFIVgxdJAJ3paVG8NOySAGUXCKdLNg84FJP/AMU88kZb4Sfec2FnAmaYmAQ+VZ9orw1pMbKhmMzg4tGl8AhaQoCdhtxiLk9VPCeRRiOkL0A1+wpvWjcum/pP/7lW34p+MOLrgTYGKsv5JwYXWzTGYByZ0QNLBXJEIUOK6x8L/sLxXC1uxQC3GG1lw7stew+4av/zvOia+X+y2Lu43l0Ua6LMXaB28neBPDnkWEX/8VpuqlQz62ZZcJ4oFb295qegtblJe8IOGy4/vQBcMxB0a0s/H233Yp/v31xqTN5wd7BkKJyZg4prqqhDu9QZfhwWIjRHikKTnoH1e+H6X9hQ/f2rFWvl9qJ4isaAxVkRwnrPAyvqql4351NO1M9YA3Uss6/ljX/waHj22H/17FK/7M3HL8VW/Ty3SfwwpA8/PvGmZGXfsmP6tcFxvybWt+HZ4HaJW01tcIz7Jh3gMu6v3YAZwE8fWXJ9cSgEB5YBsVdoyFjKCNlg6q/6hAi+9JBc1tRqM6GvkPLgablm6GY44vOZEoGvVJtXOs24vKAyVglh5SxKssM9JKprnrJ5EtGsUg6JxodHZrN/vEN0hJA24TbNC+njlh2XIHU4jvupg7/mt5QDyj7g+vkIpV2xNyum+sffSXUKGcRN1tqJ/Xv4lheP3GvqQF6+xKKno2k9I+ipm+MRkT8F3M4vDbUqYClZMpyJIvN6IQvvCO5r1Q/wOhgcHbzvqg/ygtCov+svD7VZmVjRFaqMi07RY+yWZCq8mrLGKVrlUobNucedig2o4QWBlyV+IL5MRq3rowZF8xcsOOCs8DolDosr+bHzLB6k4xVamCUIuflIF+afsPCBbe44Iow8UtFb3++Sov5VlrIt02tPHMa19J82gZWZ4lWMfW2AkO2bQyhDT3LyEZboW6DWOjTznKTaQYC5qV8Gy2JToLgyqKcY3O7e0CDJUa1OZx658u0hUNdDnX5OT/EoWiHMWuF37bwqfhMjvQVRutBvkI9FLh8a2lmCeDp2tcaO0TNMOlnYbmTZpnWNi9QjiSD9WPKOKbBFzcRM0Od7I2YSq6sYkbMWs5wruQCsDStEs+cZFet9FLsksqbxX1F+C9FYVNQ2hnLWipv9W+6f1H22h0nUZR9znHyoO944GSo/swiAQk0iuRIxnto39VmGPCNIpfHWZVv2N2H8t8UlxuCWDYEsPvI79YgfLkLANprZk2JmVqP7QRAsPAxbGotceD2pVK/R/YBneo+oO72AYndB9TtPoBDiZhSd/sASC1lJ9C51LDsERgdaPS0PTi3nTkxpw/SxnF5Hd/jW9NZmgHnr71dJz/7S3xDajYJkUmRufvk2jbGfSRz/KyNt1sFvRDRwaTpVPcHXopFAcXlWaU+B8T7BYhzeuYCrJ0bjhacjBUcYz+UoAvOnnMqMU6m1cB+qGFk2scZgAr4/RL88pHBOwu/uvIYMeO1XVZ/MoyA874wuFaxY6lqOfXjS3Bz9FdoEXpCETaLegZ6N56JGCw6tkQ+NDUaIuDLm3oGAo1+aFtY0ouDNi6uDVUBHMLMWOFbAz8zfQ4o0uui0FGRa8Z9nIYhfe9ZvXxWSu1CWtoB6GdR+rea3f6cLd/LQ5qBXFVW0VC1Ozt4LOpxIVBpDmq66xTooalavFygCIEEmRPW5KTI4kwEQC/hkyEtaWQp14uASBHNY7zndS3V8UY97hDJxLgDpKbEOAFmBxjQoUwH09CxAG96mIIdb+JMbFAszbPHYEomq3YUUFxkjGRg6MCtAXjZX2sDeOgtYrzKD5QUjlxfVnFpGfV8HDdWroN8P0wET55TQ6DkG3q4S7UPWyPyjVCtrNh5hLzkVY+/prET2KB62Rc0AwyQjRijkltVVZfbRbye+9UqPewe1Oz7g4vEqaE7bVGTaXeHXlzpvz8qHlWv3+W+5PsrF+Gw6XFAqqit46Nh+VZRHJLS1ovgCAUueViEDoZhZXt0B8Qk2R/rZpZgAU9fUEw4PJIHMoWqGxpuHaKqe6Vbny8zY7rUEdBzsBvKkGzWC/Jw1hAdMX3wj5B/cn0AnLXlskUnX8MQ1wxtV/yqc1jtFXnaHQ1rPxCqtjcUFNKWhdLeAYWmhWiqR9Ggar6B4pGmxdgl26bVKcTM0jc9mULrYm5dCOkotphHKBxUIEleFfXW0+dAmXhT3xj/9IbqnlCJtiT6zras2xc+woss2KNei+/FJiVucN+/iKdu04dFoPt0YBSFMJBBAQwAlHmOcR6xeCqpAP4FIiPKHhC59FshoQorpiadepLerauy/Fw1o3gROmnyHdmPqkxAHbJVd+AFIMt/V/Y0D04fHYyzf0b19iqmP2aHAzVhiquMzEMxPOyuKS6opaujZEInkdO1g4JKTpVfqFFOiuBDvYsvXGYhOWVEdnS4PrgV5fmVLJPl+bA+qOVloqgLqzT4eQJLo5DDXNWvaSJM5ZxpmBk8AQCFhvEgZP1ReM7c34O+Hzi2NivX936SJ4Jxc2DNYNIxbyCOawPrwu9q3fYa0vsSIu6xrPAXlCsFwHHHAOuKhEKKTCgBG+il8Hf5ZkOsIkqyv7XMBCZES71ncvQtZhFqrZWuNEfUiDCtDmh9NTQRUkTxIpBzAAqLiWxViwYaWTYQYKt663939nco2l5IiCiE7wC5p5moMqP7FIIBXowfwAfV2BixX1SVF/JQcaDKieXOOSv1BjzPe7nKM2RdMVMUogsBOGAsIhT+hHBGC7RnB6W4JJD9JH6xRWb+XiVvwWhSoNTk8qny35BV/WEBDM8XmOfLlAod8kg17tQibSChZxNrwQXe3KQnXdT9bLWhcgkotSFkYPFAGQ9ws1WS+iUFreTvJyL4B3DrfQ5AFJPszxvSVblWfr9wiEnJHaJ4reUsMZQ0ozW1KEUtFIuLtZCrwpnB3wv42+rgBp8UGXHxswi/IJ+jFm+35YIOdoxge7JLuYzZ516j93yBiLAeHRuvBr4IThfk5jfukYuVB4/q4lSBs/X2H1gr7WctUkMaywlczKW9NWJLkjGf6wXiC+pmZ3QfZZJv9pmKHGqCxd6GTQw3twAxsF5Uv9xBukbN7MsyWxYliispFhRt2xQfQJ24AqZ8fYtHoNzu6hAEL7WmXWrgw7N/0IMWh553xd7ydZNaGjXYbBf9ak/0sD3oRMF2rvSDQoxE9o8ozBkRO6AMouYnD347ilgt6vEDHKrwdCEsELwRAhZAHmanTCS82P/T9SW2hQoDT81r1RTbQG4F24IS1YKyBUkhhneyB5FSKF+sXLInAnmq71c7nrDvrrbbKFIpZhMTL/wfFHIj/keBQ/sU9pehTnlJD7V7GE1PxjGPKmSmiuuK2C2D2G0gsEXqUJHadAZ2zsySqggdOISWZne02Rkaivs4xH+X8V5HHTnN6co/z23OF6TjHNID60VIaGQCLEvH9C4+ZImQ1kB+vwRRUMiggPmC/0ELa/ybh7iivebePeoQdl0YGVqgUGAR0vwlPeqCWhqRKSd5kuRVk5oEw1+zDKZlo8+riqScWKTweYXZIaYnmqTvDr7QuBrzbruMlGVzo1+ni0wShyA1aukkgTpHOU1S3fXOkKfTJKJUp4lOvPH5EWMIdHoElGCMgvIaccphR9DjsMP+kjz+U1TPAx3cUFFUGiClA1HVbZBmsK0rYoMukNrU1dAzVhBMGUBW8UdF0fLF96gFnlaOg7NIaaEgTvbPOgmU/rXQ4wAKOhiIIl7LgWb8mFH7BnI9onSs1wEjEWAY2giJp6sZhCJQMPI4pQgRGSE0i8gfk6tFJFklgjQDgm+qONcj9U6HsYQ4VZ4z1JZn2+q7t+yV4roOnpBl7YmIvCNVNDaO07AEZP+ighIpJzZ3iLTrkQ6jHglaIJvBtb49Pfh8r+sy6q3xNGBd/4MXA5YH3vnjmFRqO9jj78BduMGKlRuXeSWoR4mhve7UZl47oTU1kSZ31rCn359nOjnb1JThxVhAzt+SSlpUf3ERUxMYEVMD05PfdCEDBcP6CUBgKQlkj98+wN2eZdHXc9selAXUF1zcj9jlG8hpShl38IDMJ2PucU7XpXEnhTpmCk6dgaNKxDEFelcNnIZXdXKGQcx5EAHwlpmVCeISK4FSXtH4gnjFNF8Q/oQvCH/SFwQ3u+oLAi0Gr3d8XxC+8QWhX6svCOepiAu4drovCN/5gviabi+cH48JXxDeuC+IgBLr0iP74xuqviDQoNA1aKIrIRoUugY5Vxr/p4LvHY8NfHe87jGC7/deK+D72dXkjOv8lzOxNn8zpXsor6rS8eXamhKSQCe9bIYrJFYWMGXLXpLHusLWnVZEgkci3D/VxfIgIjJR1QFLoH5GEWxrzIyL6WhM5mJmeebN8R/KCigWkeV83qQA53ZiL00ppeEYo77/0mIRUszFfnCA1/9FMAbLfdjrSrH4y/khFo+2WY+3UI0vfuGultxwCuTil3tFGwLrZ77q4pArnZP75jR3IOf1HuNSQ3gVdxHWENrKoWUJbePQooS24/7UixEiDvkSytF8CRXcvB2ymdtBJFx0vlNecn05RV4KfTlVXlb15TSa55et+rJLXrbpy+nysl1fzpCXnr6cCSpq7qedrpfzoKOIS2r5WXSmAgYvZ9MuvJwjL0+gM/CyW16eSKfh5UmEjFQ8mUJ5nsuXy4qn0G55OY/Okef5iNzDP7z1InoSnU1nIeYCeiI9AYELNalGpxKaQU+mcx/+rMdlIp0DkumJcsvtcq7hcx5KQMJZdD6dx4HJbR++OBs/58lnWXE+f2ZbENJ5hGK4fESjANR+itb+FNqDsrW+K7S+C+hCxD1F4rhjlcLwgSkM0bawnSisxl3RHsiHVxdPRMaz6GxtPOJ2czNdYTVOlDxP4DyuMFl/QnPrMdArIjuw6OygOWUgtuB+6xbqIpIxjiNbvsooZFf1irUZ36v5aTlN/ONOkxmupPPvYJp8c5p8c5oEKWZF8KJ8Ox6Xtj3ajilBXMQ2SvMzzJTIuMBZMyXOeORTIqtOiW1A5TNpG89AnRKMi0SC/ls4tF1CPSCchFaB/jphuCmnC/qfbvH6SXixeL1TXnbYuTDPL1vsXMBLz84FvJxp5kIFyXdNIPmpVSQ/rYLkiga7FZ8ZCxAN/F6p4Lcdrt10lowU8EzjzMCHBlnPR7Ig6Kfe+V8urv5h2IEXT6SnCPZeXP0r9nCiIKFUp0hzHtnYsybx3cwZizWK+082uH/uCLqeT09GgcBah2FPUnS1E05xfwq60qNF19OBmadbdD2jn4EkbUMk44Wh6qrPtUUvgZ5JKSiiRa0djIYhjw6eoD5nAm1OI6Zkhvru4qgtgkynl1T1DC7nVEGrU+kMxYrd8rLL4tg8v5xucQwvpxkcqyDPzgnkOaWCPAq6cybpoILoHKV2CpjdCuUnlPRL6YaO3ShkOfqsk4PsqQDiqRayOyAl3EFnIpIBopEpPO2+qOAfBhfbkFZJTkoLANKckIFmHoDfLq/VGZbYsLiBY1/D/gsEKlBFe9tDULIvCQSIwp2IOj7N0HuguJBa5xP+eX+vLt4YZqgf9euANdSLsJD3OBu/rWJ9VIKZK1pfnZ8rT8qfotiaG1Kfn6+TL98jpk12YINf0+GtgXis4nGqFnuaWxWRR5fPOXkNsIBKpjP4EYwumqeOoATlZykJWZGXs5WOCuFgjD3TLprEaHuKWzRrvACGeMr6VzyVdsvLRXSOPJ+GyKcbzHGL5sV20dxrUeV0JTi6RHGZTFM2XRLNSrpnZA29iJ5WkowLR1bEkC7UvLpQmhotiXsqPR3f6bpHF9NevF1ITxktQFNB5lwBu3QeXGCpzbkjdObJrgBQGE19gkZrASexIPoQcZsN4Hz6l54XX0eeSg+Dl+pm0MdBbHBAZXgqltMEFT2qIHxCEHeJk+6J091Yzj+cg7eakq/QnCWI7zGVLYVr2cGbUJUTg0LcLnVe6q4uh9jmViSeRr/Hp0CmLUVW0cfH577tk8pjfvER+EGF0H/CDyriwoof1O4BGAgUgf/V/LZ2Aq+ov/CJn/9ErfSK+pKKV9SfRwpH8uMM5xT1+pucU9STrdK5SOXyslcpSLMb8JxwZAqZa3YjksZ8mb4acbX03b7nQ/gSVIQvoRO+SHQI97ARxymoIhkP1KLDgBx5qI1Hs/1nIV2EeSpMrchWAjw4lh/IaWWkoUg15HYFyy0CW0FgKkCPJyRXwSaiF3FGKyfYFDhntFMkVwJwbW61qZu1MagKrk6g8XD9a8c0HvzHU+Phz32vfrI4rgNXxMfz9hufvLffE/n6RUH10oBjkVDEo16pJJahxYGjVFL174uBV/++enA9Ov4xmqIefXW0IaaCnAzzAKAsH6E+AN9YbmBlH3utmxnx8Vz8OsHa9+lJJac1IAaHoeS91wilOYDX+jXCQPi6GoK+AVWC8rCH1sRP7QhCqeGngkVzqqD2X2XiwbbNF95UsW3jXWjeF1SnIHtQICmohttOdz2kNwMYhvy4H1mtVT5PDtoFFNXivzxaPN43L/6jI8U/cBLFPzRaPN43L/7+keIf3LT4rTV7uYln/EG5U4KQubK0qrPsk+ayxMc/cf0hFKH3JbbCzGyoH2e/fXDs00s9f9LSEDyM/Y42LHsjKpNLpDXBHjUg9MOIHTW3++2eZyBwk7FNhIUP7lfwyrezWgqCokoltOOSRcGlH38dLsNA5UFxr3oN5UdedfxrKH4tnXWUrF+7sBal6YJMhhaGCaorh1CGWKNUHTWln740T7x2MfLzii6/e+S3hp9dEjx3bX9u+sSfGlYlrddAYHan/3ET5+c163RL3R/bkDLU8pK9Aa3S4E3jPtV/XFzZvVIB6BuCqgX5MjSn+6JrYq8QgfQIRTdna7rEAJyqvCntlwiEOC7VQRFKp/k9jI4+sGwgOjRRgAdi0+/hETc1GHBLYwAbZFLWxg4/Fn1fi1TffVKk9ia7TYdV7jfrnZcKet44ip4HT4yeBx163vivip6HT4CeP4eVbwJB7Amoc42mh0WhsJcVNgEAkxt06sq6CLCW1Ski/ivXsqD0W69evrOfQKOKSLCbYm04mAuDjBFqdVXHsowBEwwbE9tlzNdVy8cXLV2upND6efqtOgoPtXQsXahEalA44IG07CfRoBVBDvVT5lVXsFuQ+m8Eqjd9o4Hqx44LqpuRKkTv+WDnpluTNdYfdVMjk19chcBTnvQWrUirLEVLXny8FMKW6HTnSfRUqcUc1xtObX//2mv2c66qp09NapWuPcEidmp9Vvw5xPyvLmRF5fiRtz7Z9doXaYTO7EfXqVu/wTu1Q+ia2tfD3Qe4Q0cuZMpMyeeXTQrhIgwrhfZWI9HU2RuR06zl2Z8qY/00z4eFek+ajfKVM1F6K0iZ/ZSuLWsgtSje0lvy0u+Wwu+TbqrjmXslvLoGcFS8UYq7O/zsleBZ4vcOH8ApqCyRrMqxZv/SRBbHe2uPZXUcuNXxyL+71XE4uTqeDBY9wwumYUOg5StpLNCANR1WhxKBRQnla5LHMnI/40buZ//djdydj27kxhjWn5f0527KsJJwpqv7hW2lkoPdJayrTsZNeVZ6LGP7dje2v/jvbmx/6XEZ23dI+neMjq3bisgQYmDVK+uzZWAvws8lJZUlf/rwPuap+y43vL/y72543/1vTHS9xzJyv+ZG7r3/7kbufY9u5E6CefrA5szTudL7i4QV2l/aANwto0zCJbn5io7ArqYZ6eyxjPSH3Eh/+N/dSP/613eOrsrodafP0ce8eP6WG7m7/92N3G8/upFrYrPzuxL7Fo/lAwJO0X/m7TtObFCA27DBhXuIR1ddvIckDtDzWBXX+3plVYXqeKHIOYtG9+tCocNUbmzjbooutVa3vTxZEewRh+zWKL5vdj1Ha+lHvAi6rT6Pp+eMCTtkkUuQe6bdoS58vkW9izzCs2ueSV/NmsItC+oNgQpomsdvHFfEBiViivDQxvX3oFn9cw2MNK/z6BZaUAf9lyH3tapBULGve/lJzpn7cS8J7gfcXvJ5a5vPoO5jmUF/4GbQH/67m0F/9Ohm0CXHHUc7igmfipOOZIgT2K8PBfyUG797/t2N3x8/LtuHPz3B1vAS2TDskx3Ebtk76OGGnm1ArrP53iF8LGP7v93Y/tm/u7G999GN7VOOx4FCrJhN4Tx1sI4+JunafW6wPvvvbrA+9/VlIs9SwejUJfCxnxr+tRu5z/+7G7kvfH1HTl2tZ18nuegDbuS++O9u5L706Ebu6Sfcou/yj3aUd9mMUh70H8uo/aMbtX/6dzdqDz66UXsqj5pT7BLtOgDUKNj5sGJY+Nk/a+GWCTGNf+k0n6HI1T82YdobsR+ZGrtrWuTqRKQbyr7pVh+vPk7yDqraHGnboSKnLrkEPRRkWmyA08Yk/Y1nJbBP/cTrWi8ProtfXjFaeIxPoyOtR+1iwfIXenuzTxEG5yZ+QpnhRn0GA48iTrnR54IP+wifzk8YzkH0wOPozAVv4UZUzCYJhOFgqKjvE/d/G//IZjdNhp17933hPyD2Dy6mqHQnw7tgrjtP8Dzk5w3U7a1p+YBX9hrpejN7LZ45dscP1pBSX2M11qKlPnpuCV5YtA9A9/aQZJsR+Phy6V5jOhSJI3EKstchArZX8S0QpE4xTIFH/cOB3rlE0Jcg1N3nqS0+9BYDscyBv8t6BY/MpbKjT3Hon4rP4f3Fct+DNddlYOdSnwOqHthPKOzlXTF8uPisYoux4zovN2k8hQHsTWTcFkzaNHu9ACfknkETtFux0Cp15UvyrBUrmKw94kcrX/X3IgAbArrTXu3X+VYbLanTU+LmlEaCBs5XmrPuL2Vm+VaY/dSysmI7HgsFAVAcWs1zuY26mhf83ME5Q9qa78TFh3wbhflO2o4WnTJyK7WAxv6puJW6g1UE89NoJwdYcX8XncrbvdPxyiGAFHfP+JVpZ3AASvS4P7EzP5u25edQnj8BYhTpzBwcBD6BRKW+GejtgVnEwfKMxjjfgbvNraMdqmy9m05n3fozctaS59sBZ+bn0jn5U7jkV+bn0RO5O09ikD05P5/OzffQU6S2ZcgmHq4FtfwCOr8Ms7Z7GX4qhWWY5bJ0PkLF02gZT1bMfwC6+KG87KU98uwj8hn883CKocDndCFdgNhvoYvoqQjsK5P5EkrxzDLPF6G6v5f6CFyIjHsp4lsMA59L/ZJHT6OnI+Vp9FS6iAOTwh58IhVcpN8FxdP5O1vZM7l6KWcvIRolSLRrw7fQPlSgX9/l42vo9D8DkRdrZFDsrRbJqcjEJe+dWiRuJGi38PVRn7slHXkqIp+qkUFxUbVI7h0y8ZcXuSLt5ZFlPJbpfDzOpz147AE+AN/Pg1OQ8/oxlODpiVD9Z3x4kjyfRE+WJ1+ykee59BR58iVFTMDdtENXjNNpFxD3DDzOoLPxOJvOxONMOoevBTG6PgHmi59AZ+E7vkE2ehf1FHcX1U4O/5uT45uT49/x5MAN1AI3UJ+Fx6VYLIDouPinE+J0fI9wItevzsZUoGcdQHE7uU6EzmIM/laeD6fyvDjt0c8JGp8T5zD2n8pwOIthcCb3/zTu+9lmXjyTzstrU+bGroCRuTI3apW5sVydGwblL6JlMy9qlXlhBzRUPJBhBUqbeJ1xJX4LcgOnf/7Zz7v/h979+Yvts3gaY0HxdOKJAYRXg4v2WTyDEwW/pGjFRCCsxl40OUXQDE4ilFpOs6fa6YLYsn3Up6fqdNHMGr3LdOfpUq2dKU/Vqi+UIjVyFK130YUobQytFXWPj9278NhFzwR2P9Ng93mCvec9Siw/h04H6uGuKOPbWXjDbfgzgKWn4e00OhtvZzOyE5D9W/H5t9Kz7P3VAvdXzwZ/BJQewfNzBaPPPsC19mvAesbBnVxEnj852GsQk57MaJvkT8UThJUzPgloR7sZJZ/A3To3fyIQFJ3PmSLkISPqMiPq+WAGK4i5XEHMcAoSOvxTElxFvKeW5FSHztLfKgZwNFI57wUnO2YYpT1mlHYJ9DF0eD5zctQA1ifZUXkKnS5DBcjvpifgjW8M4u1cHtcMw2puu56tH+RU0CkvKvjH3naFK+ucTqEdfCMd1IOhH9J2XHDaTqQf9XjouFzhukOlMEpN2GPv7+FKa0lR5jT2IGKnr73E7DYP/RLfbj0PFpzADpyB8T2PzjCk7omczo8n8eMM0ETEPRnpQJcQXWPWG90+D9nQ6N1mUcifpgE/f7qZT7lZgvzcLItB3teAnz9DLtYDZ0LajU7pdeXqCo+GFNVl/smIqK71T0HELrfgo1E858yq/y2KYLJ4F5fQLnm51JDAb0PkZeUaVl31n21X/efY5HOlaXa1/ZaTWc5B0RyLcCl9W0m79lG/gpvSYdqn+XW5t7U+UWu9hC7Dt7pg07PpOXjbRxdPKcTS00ohO2zTdQGXxd+t8U8bLwR0UieQo6xuAmGuhGau7JY5sdvenz/DWIvXrWINP8/UJe38Pl8s38+kYWYXLsirlcUnccIutQ/YxiXi8zkLT6Hz9yN0WQ8TQ/39PZEWqU3n8wb8AG4/0y694/Vi4R+Ib1/jA1Z037PGCCr713wZREcdt9aG71a38rSGCPTQRlqb6er2H92/jgGFTjBN8JSOCzE4Hx08n55prWge3QJzbQvwfbxAi5DTcQutxTfYwoMlTP6D5UQ8+R7ut5MPA4rZ9H0/dQCYJYXPgpFSrJIPU45wCT+y8V/cX9R044+riFw/B2TjD7hj26+yBm4sdbF5fyYerXwL5G4IFVskvngmk5X9fVlztmzkz+WankwL+R6pDQNHAa0yFbslOCAQs65LjsKZaHz7EXruUAJFfKSoU71iUfzhhfxCVLG3UOp5Pl6S4okMXow6Rkf7zhAP9HK7TFud9P5eJrYQTNH5OeOFCC0uFGIuqwRmGPgblDwqTdjFmUDulKxz2T7Q/pmCqos8geOHgjXacrUgyfmKfKYZu0pk42jrP+t8ChHNRSxzEsW0h5sIo79DY2/fU9wJnUd/rlr7C7wpdlmEAb0CNj0ZsU+2YkCHIivUFbkK4F5KU7aoNGXx5KUpK5ARdVSoMk+LIlTpqlClWwpVuk6ossUIVWCuev7/ZqHKN/eN39w3flOo8s3J8c3J8U2hyjeFKt8UqnxTqPJNoQq4Zer0eGCMdKX7uEhXmO9mHFj815eufFO68k3piopVyKetPAGexZi2ZAQsTzy+gOU82jIuRKnxGrlMu4ztzZhqFZlJuIaIiiDFbUbxCKfJUSiblKMsybYYfuy+HXKUNsQpbdqKPFutjf6IZqAZovv07GtQpFEQZGqHKYXW0IK0JhuIfosmh5XkpJoMN/j9j9bWXKnW2yQ8FezVz5r4bN/EZ6sTX0l0VolWrw1OqaWMv1HVT1hFRhVxTmCmasJZcz84vpmqS/C1qrcfKO+zrx4QgxHOPyhsG2ZvQFM66UT8TYh/hPaujmMlwB+1EhBYKwGveZzNlYDaYBKpPUdnsOSNJ3Dr/KdxDN+Tdf4L2Imzvb7SKP2uwhlpvCaj8SaUpTb0BjF+b4+L+v5+Q9wMlQ4ih/ClUXrlG+QNLuHOWBylNilCn1I84EEZCWqVHTGhOGWI+ta56OEA1dYpMnO0CPilU2T21R84N2bFLAbxSCVibt9fpflfPvy1v+NwcIRb/2NovfosBcccDGycbWsZkB4e5r7heSgoIl7IAvFYVMcf2/afV5qzgHZScEFwZ8xPbfGCePxcK+AIUmurq7+wI7deENyFfJySiE9LxGzECgXut1rWbyJ/RzycdaSXVxa8QEeCoxwIjHsHNetLqIXjFkAuFmheyUWDQkpojuYG3Evu/bAcj9ftXX8oKBaRu75RBOsDfov6fp+Rn2c5dyx6KadR9JLso1Xrhs6xIgXreYDB6opNxXnnH2xJdigL5gMOIl0Gkma5LfIRjyZGjpYGQ4suHxwUvjp+Hg6KZUASGVuaMe/y1756g5YyusPhUKAI99rLlHIeM64GmbKb8eb8vXqAJZpbLFyq5LbifngJjMqz8g4t5HXrFarzTMmWMcQz/XoE253L/Vgnxnn+nTqCpRtZnjyYXI+civzBQmr8JFwb8XT0+TnP76U5sAc85w9MSGU41etYxNZTWkpSV1EJD9mbeZjjvkexaNHF58kC9pB4c4o31oHn/aevFcnGvj//oYVf/NY/99mBI3/CO9uikT0s5saa/MED/IF9T/n9vsp7C9J26Zybgnm7pAnU2GDX6iqaj40zHGpUPXh74hFnpvL9YKgDLw4Ri1mW9pZDJ7OxTbM87csSvpcrnxVM4icjKUYoqPhe7eDRIa8y/h5lWKMzGc+wfxdjfpr9mfrCoVABGALQC/y2sIYhh288L/uAURSkNU1I9s3+9dnX3/qT1zwt+yCS8jkKkcLYMfAohF5ldlS/odjFKcZoTZnWBIM0osU7By/58/xYBVcwh8Yv8uNcZhX07MACvE7L7FI8oNY4bAMV0C23K3DzsC4oYbHQ9chjSABa3iS0qvABKWtlH5JuzLERmDzGY0/e4aSbPaQp6LqIruXaoeAuj7qUwT3OfvYe1XphsbKmoM4+jJJgfD/7c3wnXxU9zMJVPQnY6ouTJMjrwaahRdtoASnbaQkPGErPaWtpmp9429k6sIaknVjPeWNyr2cCx2zgqA3c5Ql8VvsJL6GT8yg/BaapAa+dlK/lWR/2nor8NFC0/FTjw0mRJgaZ6PCGA46nY9kk0GkmYNlbTouxRYrtIUkmfF9Gp8nzNDpVXEfS6nOQGGI/48njKL6X0DF93IsIHP+cwvnoFC564KE5o3NJUQxtE//ynnVNaa3Bn0qrAKz0rUOn4lQuls86+gkV+hzi223ma8t8ryoZ2047zFq8nnta1GloCa2C8EsJRUYZSvMEICjviMOyqj/uHDE5FXgU1lLwilR4MkNJW2kFzOHONRmb0048tAUPrYzpqXkmY1qcaEyLU+iUEw5n8ViGcfoQnmaH8DSUfVo5hAWt2rlBBTof79dZeyo32IxmrHxTgGF0UH+ZhXpIHrt5vY0COpUzVjzwFkw6D3lI1zSMG+bygpm8d8iUnee3Q/ymExiTlnai96gVp86HPBntJepmv254xzlsWnI8FooVNB+khLas6bf5DryvIkRKEGIQBOCfEoDt3KtcKd3JYEVMBiEKQYhtx0OIVYsQO/KMTjUTffXxn+iriiHbHkcMKQyGKPYVJYas0jaAeDutAj06cIS2gzprQHo8OiWKUMdOdSX8FlUyoIrQf0BPZz3pfGcwcSekjFMFQ7QoneCgZgz4qfO8tVbkbmZ3z/PRf4C33IIuC8cE37f+GvYWCny+FpB9RNYME6NLUpr9hq6sGjm+umLPnpH//L73Awh2DQAfvBgxL+7zKbRPy6A2y5SwqB62hN2rNhHV2Fa6hRyL8fToXWtjfdLo1enR2bRCWlOyplPimpNxzCY6E7BvDQO4HQ6meRgddYXbT/vwiTXDFpIb/Gxc1sOOXE3uwUw4vAsQftjv6B+ildkf4TcPrRk7Lm0XCt3Y96PP/JF78uuTvdZD+f0XM8++G9e6qMbAqbiBzj4uZcTKrV4iXK3qrFwQsCAHEooSFbiHymrWKVBxQQCGCR2JdMufUZB9AgVeEDzPnLQFev8pUB9hCfng37NPKi0SK3dFgsdevbVkMuQSl+QNYMzz8libRD5j963UwOWwl8Lr5obph/ZUQwMbHFzE+5kYLfExB3xKqjYltPLLxf4EVyzmLXRKR+RtWB2TvUMKOcPGevYphZPk5xb7ayUIKV7HfNNKTBVaduL2KgEFpUNNRZOgaij4/JpDg3BN7nrxJrZ/0Odr+6h4heOzMt7GnUh2Azvmj8TE+IOeD0mEwdR75yyqquEOvQ7fvwc6PlzZQf334MXnB7ZSRxqjUglHHXxjBGGNfY5JRgVyHvnYjVc2HCa4a++6MsduL+My3THU0RCwR5XdRARCAcHlvUr3g+xPkE8r7nuYS9mfCug4jfvn4P+ZmXZ0nYdrZNfiWZdNH5zmNV4elwZF/NJnOKAr/scZGmvZXykyY3QOB0UiNBrrTwPOQuANVvNBrIjlZiFviUBF/D0H1IAsogHpxLAIy7tijHcjAoMZ2QlvFNl6ea/sRJKDBNPledLQIqQQAprZAXHoiAPZEUQeGeQhsiX5nDQkn5dG5Qv9Y+qfYZa/hnlVXeO4PqxJ/GPWuA56zKKPI5StF7xF4tzDUlyxzqWpt9piCUtghLMZgQdxsEuJqISpU78VWmTo9PDSlXV/a4lREPRYtheulKktPAkm43aokhHxIyxyq0pWwCf0ULoDNbAdRBtyq20nreanBHvh0IRWaKcsyhXmgRfMrhyBnUbLeURL4hp+iSuVNfY0zkQR0pH1NIED50qwtibqL7Tv0ymsNNbLd2FNxkHp6XQ655Y3PUlQ0NtncQancgry8YN8Lv55KJ4d05A2LT/LDAT8NqEJGAptBbJVR4NO40a2brj7t1+4+7/dd7F9om+m4j3fYp84oTi9jP51+0T02YjeK7Ih+1TwkKRcsfK97zr2fvt0KT9wdXDO67esv9c+kYLSOI3hcFp5WPxB+0Rf0H20msN44D904eN7Dn3gr/75zvfbp3ThI+941/vf8rf50+0TkEP827/j9oPPfeWbPmCfNv7w4u9uGXj//HT7tPH/33/40NKBD/3HD9qnjX/2d+HfT19snxqPPkD14OyJRl77id//zxf+8WefZp9SyOdvP/P1n/vsf/6AfdrCX/HVd3z3X2z9rafbp43/xPd+iBt3xgft08b/zIPZ7Ozs9Rfbp42/VBr3Gx+0T9fIc4jH0zMTxj55ML99kt3m0fgkPN18R7F7SuITaTdQ8XQeuN/jGn0Tb5/8zbcTCnj4O/hE+hw6g1DQGcS6PvpZJf0Mask0kC3AkxiF6/yahnieBU6dn2fyM+PnGfzczc+z+Uk87XKRrQgT8STZe1xTRC/m+ez0P0HWWP9zbiiBIhRqNqr/eTrVWYhG8iEHMxucp7qGhsMiG+aznEY2jd8z2g6WRE/vz8VLUjwFaqPnqUgV7WJa2zEUjd2FUSRzFfteeoqqjZ6bR3xMnmDeWtJRc6QDJVdpB53PmQCRc/sZ6uzgDK5DuZzBbaOCQqiNkqqNRtqAPKFcmhNRJC2nRKi9aoZGgF1xrpLvc62+ZgI+JSkb4DYG9vR7FwgJU7FXwhHUTrSCiaZyMQuVxXaBttLMs/JIDsryrRSp2LahK19TmCy00rei2Osj51fhMAtSE40HW8YXsj1+RmxWnp8Q0F1LCTimQ/wKG9434mnMRwfcYoRXi/hFesRURMzBvAwFYD+GZE7hqJegkH6wxqff5/lXC/8XHDjPP6A5+YBqDcc8L2CQfBqcKsUHDIPbUO5wVZfy3Qf0ACSPxVeO+oLGcqSVI01VZRtiEACNU5Pmcv5PodorFzfkaL3HtSKLwlT71QXLKF/3YDr7eZSAp/tOSsDTPZsS8OFSPH/akEpRvrDSfw3uQ/NfIvkhv5RZ45FXOYErAmlNkH1eP9jlX50Dqo3z/LP4AQEoPxKszOf5FyGox5N7JPgFBM+V4P0I7kYQd9ax50DwIcTulOBBxJIEv4zYVQk+iGBXgjchw4IEDyHYQhDCbWPJ4QDVBU2zL2hT0R9NRKyevmoDp8Q2yhjlsxNGNouCfxlOR0GHa9NRcRQF4woKRhYFPUVBDLOiYORQkJEPKKODdACZHNZ5FE3HOogDsSNxiBYKtSkRLTCIFpKniGZ8LQVAtMBsRCYRLdCvAhYwHRfRPEW0EOWfANECCqqI5klrvCqiBd+AiBZUEO1vHmdE+4WT96wQjnhW8DbxrBCMe1bAruaBUc8KP3xD1bNCeRwdYav5b+Rb4UduOJ5vhcNIfZQ+CH70hnEfBGHVB0F4kj4Irn6sPgi8Ue2C0GoX/GSn4cuJfijHiN51Af9Z8yS1kZ21SlOerdKUffq2V9/2AEtvY9kNnhcEu2QXvQubaOzTGMzVbXiGI94LAqx5H8GsBE78uO5NdRcYO/GyXquJL9j8o1R3tFTU8dhZJGqrRs6+ZZfYpADFgh7WUXp627BoXRAQyqV0WKSmcGpSPCyaIovpasSRoqlV7jE1/oTu08l8g1Q8tOA2tQcD/TalBmKa1EQMTSmhpSXEWoJtGqW2hJaWEFM8vQTwiNzlxAqJ/JHjTZUvQLrrpSmP3cyE8AUGAcUeoACs3xX2LKEZwUg0Jkfz6oAb2gggU0b+EW5jnP0kmqA46FM2qMbU0EiV8yuNvw3A1u9Tak182trs005eJ5EmzMiCMyMtLmZNm0GPnouB9tHqOjr7MuAaZUeK1ggoYmphqRPwHsGID4bUWq8qhLQQ3RowJpQffr/iXXpHkZad5yxFExCIKB3tRnOgMdMhkFYgEI1DoHkcCKCneSL9zmdTGXGGSQMwadAsCQzsJTrYcORYWHUswmdJt+NhPsdjKnNAsCnLmyowifHoTk5L9/rB62BTqAVoptSk1pFifkgxiOiRYmE4uI3miSMWiMNFax14PqSUJ5NUO6C5IwxiHog7rK4KrvmNArdJkXRW1TcgAR1Nj0sW/vl4lV60KaAFrkB6McDQwCJumxsTowAem/GRiSdGZpcF76h2TKNPgGqIl3HAdwB4aBxMwvwiBXyiktlOf4+YIUr4k4in0YyqCwbEgcQhgTS0NdHQzWeCyNR0bGe1Qm5HxPjvoeSuFH8kb+GZESo9kqe0mDfUPT4U/MAG6LTmbl+9JrSJEZlnAtV14vDzBRLfxlgfKeJbS00FIcIRFGmQvnCkaA8Z5E3tVYZieAIxEowN8OgAtqgNFNG8JxjsAJONUWrgSM8CpYiQCThOgJrHIUCAlg7lRfmsDjPDRRiZUMczYo5FrzwibZE6JK8iC1QWRwv8DJZBCboUxadbzNoVCOuBBJmBwkmE3ATQbuXkUM6tugDIOuZib9NYXnIta/Y7fgBVu3IxHjScTo/ogdyCfkCPTLQSb8vejCI0Sl1PTqwImlMzQtsaKmvKS2gqaD+OS1Wljd/yRFLyBiN3UzCpXk7GQGmJrzVii5ZHpUFpXcx84r8re0VLl3UBBaUckV6lld4Sr1FTVpw2YXpQGysr4w626k0xHIeSI0bZIjJnbE303G7fVc9AS4KDawgTDglziJM9aFd9XVQo+7doHQEHqiqUP7+5CuW/qirn7Sdox5se/3Zk3I5srE1UbdNPnaBNvzHapkCjlZ+UShg/SivtfvZGpBb+vt1ytqaEA62F4O3HP3nq/ek5sx8YgLiIA4Y8woPAw2qHAtS/gEc/0Q5BFYCxqe8JA+/vDfYKVCnMfkZY+BpT2xBYh3xKIPhcOMcELztBYfpxL4RaHv4ESOqUVyYF9sj67pEHkXxInrLHSC1iYDqFIN/73vv+T/3xn137p0+7EsIqihn/VSFLfPi6E1k8eIOCaqRlWhcK1UVX2Z6I6pUSkUE5aW0TRXlddbbwvfbMnfgKdB6heuIjzP0jceTx7iOsErujQUnsAGYWcgRAmXKZwCrgl2/MukXOzmFUUU65o4gHhXRWthFHsKCA9Pm3KkmqA8Dgc6VAqg+GdxTJIK8b/E6OFAnFV8niDmq7h6lSywO07q5xkEI9fg4hiMHflb0Lgr2MQQ0MSZ3fldORBjQ5Igajj0w1YeM4H4XYn2+gdyi+fyMIi9vTpLqnaZlhTYr2bfmMXDFIZWRREsLKpRNhwkYMDWofAXMU0gxFHOqipbche2aycItKHea8DB51ohyZEJ5uoRi6bz7zyGvefGOsvEBDKTxF60WEPqHjeQzAmBQAkMqP3i9gqEt2hRRnT5C9PsYG5EmqmOyVd3QBf06zllEPBoWnw6G7bF2zsMXDsGGMB3mCZDJ6L6ZBEYrSMUd5Cm1qyNrTqQ5fArU2N0BuIMc+iTTr1DHVLqhsebMRphSZUmqZTIzy/6ZCmbd84wll7jiuUGagQpl3nzywoiqwjtY2AVY4BqyLcQQ/CqvhdFhpWBdCwI2mwS3cz6ATreRYSA8gV4FbeDy4AagKG4CvpeBL9BHqA3BbPy7c3voYhFlHvsGFWY+qUz890amo2qnoJDt1xWPqFBBytFOR7dT3+Vgeofhj5WMqGtcTNF0WImkEYngnbPmfp1vp2ZBCbLxulSZzdscgXSmWpB+Jg91ghOL4m0wif5zi4EDpwdFZdOfILOK2g4SqUODfht783HHnzcHHMG+un0CxoIpiwUmi2MtOCsV+5eQHE4aZzWge+dCroimDqXkC6PW5AR1wXuxVBx/y3XD+2shw2h1SpHukTQa0f/+1LxR7SV/fgX3vcQf2fTqw37GZeXEUhR7KcH75Yzx5QerWMG7s6xIfa0srVsORc2Etfb8fhNgLWJPnGOFyGl3WrpUHZqQTC8fC/McqUrI2+MJJUYCjeQg5K6fiMU7DY5VD4aPnAHII7MfZm2jS6tfgFfVLvWvKBbxMD/KpJstGB4HAYKS+Zr9khfGVOe6az8eRmN+ojv/K+Z3Y+Z3dhc+1Z4kUXISuQRNdCdGgsNqg7B06Il8MG7KNui7EsYT+Te4QxzX4QkBVcdp7qQKytlHUnbZFzvU7Jb28Ub4Ra1HW8X/e5BnshMF5S6DYKpVUB0NqrBdtJ0LWy0T5DLVVGzBvZ7+sMATbCclXc51m8N+AZVgzt9JMuR8bgrV0rHgbquULeUf3n1By7eojo8CwYi0JdWVOzRiCmb0T1fFrwCLAoo1Hl9puuzRzpMiGR9C7mbIujmRdu/Vijrsy4LarhgUsVrUnGpi6r+ZwSW84XKeMsgG6Nrte2YihA48gM3a0qSq30YwbIqCHB0PrUJ5F8vxatS9I9ml+jdoa6phQy5WdtygFEqRGROQsc6FgVjCFA0bAtVbdv6dv87zQUQF3sVWFZ1Cxzd4FSPd1ixNDpS/BlG4w1d8tCzaH++KooSH5xXF8RhJ3FjWmLhyr1NC7Yx5KTCCszX5FqvGwN2eidWEt5EcDxcbONcETq/tsdM2sH155D3v02CeddGZg5xo+BaB9fHqHdMOrKn1jQQDGTTAwp0uJfW7D4MdedUi3+qj17Npb8c4wz96DKtL0c14AWhhdW9HC1RFleXWgBD00jjpky+YmoJMP53UXm8i0jBQHlKRUEKChW8ZykppNaEzJkB9yXD6o4OLwCOZ0PDAbUwomMsinyAUCksecCXpROJHhCA+TxxM/GP+DdTfELUgeKEMgJB6cmMpwpKN+gCSfxPFGVoggzYM2hOwR5HYBUlVUhKLKYtTNYDk2uMlu9Nvt7oDzOjYB5fmKGz5yG7l19m4l0qoP78nQ/rDvBdxy8fdR+BfWWmihOv6QVf3sWqvtGWNegUq7dUvDMwxZpYGyhiMn9pgeFwKhIReIUCgRLV8XrUA12rktv4q2aIH4AU9qv+3X5JFtmDv4XL6n5XublZ86tyQAY1kZv6OyjRNWpu1J0/+KgaxV3aOowxXfiBoBM7OuIylRhCPfVOXL8MiIqwMTHbAEn3CCKx6zF3VgfB6f4vF6wPNeqfiH8ng+dnm2/xVm9jOO3vi06+Dr5fQg+f+1PZT5jCddiwM/tGX2NcgjBEY+BGy6qRSAOzD8nr3xeoM72Q8rEUj/+6Phit8/wRWDFXRsMd7G+OL+NL64wIdXMw+89ug3YGB/R/ZfqF3puWYJzNlSdreZOHqW8tuKKn/hBT4uZLu1Y/T+9YJM7DxSepyp458Q8TVJQZynF7U95JCqVGwJthk/NbCISJl2kztmQJ/FmfFc1UouUkhkqlu1UNStO3G0Q2/cJsJv+no9ytyy9XDryqO6EUtVL39c6PmjYl1fYexnH8WnmqCpMkIO7umhx/nAQS8Qr8hxAmfIvfKY4TfdMYMKCMePPgIfPPnELSdU4DwThdqZSNjymLlrx8FH7LJH2XfhuGPhuL3jcNweGFzPMbgg7SVn7UPRZBo7HZXb5ZhqY9vlR1qvlROJ6pv+6AYs3C8OtEIdx9iogOpQcLXwLpScb/LnuuBUN1uhlIpHqA+3i8Z4qDNdFFNuL0BrJ/fUP/+4YoeuhfbmFyaaRjgfXJrDMzmAP+6Y6tgJjqneiN21NaqAtZt8e5OcG2fmLlqGxD34OXc/LrNbrdbfcjfKQuNvSxU2kFP9ClOoaAeWoq4Gf4sALL1k2oV7aHKTGmNd1zsfcdHg3OI9qm6b41GYg4P01R6ufI6fQK9eOpO45hyoQT44ZjkCAipNqX6kZmF2PhD6LXcVixzZM/TOU3GC2D4IzLX/OmlykeCaHE4nYnXGjL0YPmuafZMnw4/Fro5iUgwSQtBJ0Q1zHxMFJoGxKUqkjLYyWDOqAC8ldapXvjKUklAH44H6C2xN8gxjncm9Tyhgic5EE8NicuY+YYdkQBtRE3YU9LaYgibCj1+CNgBMA+ss2m3XrTJHW+mrjFpUaRzMKlGqpLopzZvF3olm+cgkoyZO6TjdntJhXxGUtwvvumgoHWAJ4Meeet33v2XA7r32/eTHn/Wsf5j57xdxrzJD9fXuXgTbb96Llfa/HQOD8wv+Azh9HT9Vl1Wt8iKS7sbS3SJTYZ0+tJOmyzGTHRAldNk3qIR5FjoN1NBNp7tOXljVKmVVn/z5T/z8lLMO5JmQVX0Ceblt/PhEzUmrPoZpyI3m//BprKjZb20qqXrJC/utr7ec6veOK6f6HSWWz65yI1WzV0F52gyslLnuMFGPmOX42O0g3H5QQQoGSGupOLf73enO7QANcKjPBBcr9YfV+kO7RoOkgcKG+KRsAUUSh2qwemzClblWObasZbmy7/b8SXmdW8GtF2vuP+NuMObfLxj1Legkd49SwPu7E6xsq8rJtiYY2d0lIxtmv4+PT8C3Hr+7ycl3F4hX7e5f/VtOQCMu1lUz0DU1gAwEEQjpiq2h0MwVM0lj/QoP+xZOO2wzM/frduR28jP3vM3ENY5bniazuYZFUv1MT7MLn4Gru1soqaE0QDvoP5Ff+7tz5rNU5Q9D8lxFCd3RXypEHZk5xdgr4BtDuceP4ECOVgQa7ad3BmFidFgmuTI0ywmGpk8UIB+DK1Nr/4FyVp9WzqrvCwf3jBvh7/h85FFzqLgrL1eWIjRaPqFoDbACyVTFyauVtilq/y+Up6jX4itWBdL1bleEWpnCAOctq1VXhIampoyAwlP4Df5Y9AMYj8HVY7HOG+RtQAwsC5p/aZ6iXjBJeQzeQCE7egG/uV60VPwrS612Wq2f+NTKfnRqikeiO+cYBHvxKtLBiDix3g+dqjd4Ubcle73nqTwNCz9PVyeSHoJn27fjGW9qHbn9t546vMoqS9osxzjLMA8rBp8oEFbRqxq+KqIhmEpgHGbN+rDwAf5BUS1am53+ZhT7YkGCW+RYwoNhyRP6eyEWvPPHbhCxIOPrnZAQZv9b5k4fggZNTJVPOShVkXeAQhgYUB5FKLBvdmeYrpf22qzwddX//PPrHv7pp4kSihqUk2O1/bhcLrI53DzKG5WM48cGTdxO3HDwo/rGEfv2wcHIaYDiqLQKKEoVSaYoS0+aCRhcPBw3EzCQ6wLSkY11hIdH1MYFRjJbnxRng8vCqausnwo6bULf09VWXatagU8AUtQAXxbCllmeoX/UUabA2m6JiB9R1XYX/4fO3v6DtUMX3Xf+K/O2O5poyT4irTRrTI9+1nSHTxRcy2mW0iNUjRlqP/NZ6Wk+VxZ48dHsZwSvZ13+jA3MaQY9GVgvZqlN/Mf8cLtM+DLXbsP/ae+VqtCdYBbHNINbGTCIIaYMx3DHEsKDoZ1TcfoGX+UcQeXELnQndoYnDlUMoKKBSDlCz1xtc/yYj7g1rEM6KMikWfDi6Ymb5mMm05YSaBa8BBOHcsEmh3IhpAiwBcl/pRQhnDiUcw3jT7RNnM21KVyrnsHBYfO1hraYwQ2GiqGgJUM0tkpzEHckuxffDo9v9AMNeiQGW0ePLkIwhX85zqrevwmr6qsf5vf7UWCWNW0Ym9uYsBFysDH6fn+jD3GySOzZPTUu1DpSILsBjsWi4vNY9Teaa8aMxQDcLeIYTQbpGmEXdW8DqeX+sAiAqD5bAXEGWXTRGiNO5nUPG6mIQd2oNALTZ36A6r2NPKR6HtjFE0QJlz93X71h6A6FFYslRp/W7k+LSO2QVJviY1HSGSMtwgDc7oeQnIG2oyJrfaUGHgtPgBJEV8x5Jg5IDRz5MsFHUpO83J88XG2BsKyVO2iQO5/qaEqKBqbaQPcRtW4FQ8Y8TRuzTwU/EdchK1hMTf5GNCRRMr/1Dwrk9bo5DBBzQ3zcGPdxdK6GUNs4Ck6g0svYKoCQIquMhB5uyDGZ0awhX2dOI73xcZZwWh64H1alU39+fOnUv1IrPnOCVnx4cqId9CZn2t7R90PPqMy0g6+cMtM4tpxpD/56bdpUO/ibNZ1rBz9cmzrZDvqVyUabT7bDFw8f2WT7Wu2aidmGhX9ytukSrm2ZmG1kZts7dLZVOSm/dBYPU3NcGuK+jrMODR2fdXE562JFktjOumjKrDta22zaxdOnHSAiZcIqHm027SI77QBLu3A30nd6ng9mmIVm3r6XwzztD92ox7610hjRehm+qBK+bG+VP5kaLO12rfNq7N2Re6ho9J6ql/0CWoIhzX7Yag+tH6GafKIbAI4gT7GEE25bfySqd/6I6l24ieqdN656B22Rh0ZV7/7Cbb7ddjvCNP83Ur2777j758/qQn+SoPomqB6lEOtzE0Isv6ql6J+kluK1j1W7NxyV+PmqCPuoPnlFENpFaAMkGH3u/4ASbuOuMMZe081kUbhjOIt2CdClPlQfgkVdjkwg3a6BYBktugCsgtB2MVOjNwv7Kt5/TlVUq1buNhXVwi0EsGozWe3jXZrVHeLy1EyMaqzxOKP0v9XSjTACX57oiy9N+eIXe9HKdcHLRyRJ92KjU5UHbDh5gGwS3oZ3lQZokuwg3oVgql/cPfbF+9wXd7svPiJfGHYHi7V+fM/Yxx91H9/jPv64fAwWWi5EogwRIBEmaoLQKkINhLoINRFaQEiqzBBqCdYj1EZoJ4fwPIufcqQ0A7arVNLpvKjIqHNgP4wfzqLK1WLuRfm8DDHSF2h2f76I113q+zTIfWPkCWdTSxTR7IvhfJPmXsSPuQP7xdoKv8/vp/qBYhnyENCLZerQIkhe3iEfKOJbPlduP5tRreE4sosH5Vukc/lKX4CFtoXUWcv+zpjTz2CeZP7AGqWoUczX+aoSdgz5iw6C8mkRgX/rUAQKbQxCrQAs/gEhbmhNxOnuIDKlNs2t5b2+oIVkxux+AFWjWInO26BpkljM90ELXOWrrvI6anVnhjDqj/Yu8+PaNRHr1MylP3BWyrBSC3+X9pBR7eTWxZIypWtyxIgb9jPc/TmQRzOwBexnZTA1JZa2tkmRuAmvfBKiQ7nYiA9oDp/ASl6xnbZVTANH/czZEN5OW0eSCHDC4BW+ucA+B5DN0ZIFWlqtEQ0gmOmq3E/pVO74LGtxhOIOelKe+mml+UuN5y7jxyJ1kF3aFLKAI5pgrI7NMLj4MWet0cNUoSiYOKJLam1+2UCxeiRKVM99UkQnPWadI9+AWvlWcnicjNkKmwH+60Qg0G+12KuYbjVE562GKE8xDG6TGpTpNwnNWudYi/2Q/8D9NtXofE3JQ1vmqszFhb4qJW4BIuL8nPwX5Q3FyzmhIgwOtbmUzyo5un+MHH3akaP7HTm6D8HU4buvHz849vEX3McPuo+/LB/r5bQl/fDQzaMfPuQ+lCT98EYE0740CdTlgJl2Uo30mpZMnL9Xu7eM5QmUhgmXz+O0wAcvYn8EbZeCYCBBzHnMgSlb5ICBcEQpDtmVKsiOxKj5VgeWljEn5lRslyIyNUZCaFlGsf9QSaKUPgm64VUtNKh8OEJzkFMniI9JKR0AFZ4DFeZW0Ryuvo6SSCmp6Gj9Mu6R3ii+3cOTIoxuRzrE19Q9VM5xoGSoUQCX9xwsVjEVDMHKZxF/EDAvsrJ9xfzY1MJAvmJN9m/BFEWw7WK0MCA8d5snmSeMKsziT8nZIlee0TwwfpUWlZwtCzmbp+UTkzN+3O4xZOCEx5E1mZn8+XSappmyEXKWUQdbyDlcFEF5GCWKufw5TFGdr1bjocfthIyTCyElYxLODBlb0uZS25E2CSvJmwVFm6WlS9XxJsyl4rip5cA+68A+Mwp2YC3X3jIULaVVoWgVGCzDx42hbrM0M0nd/Am6NpP7tPgo6RpTrQpRAwCjCgCXaYknYAQAtgDAlvQadNyh4aJDw5bS5H4Hx1+Cjx564wDTc4CZHQPMquAjzsfQJvwpds1ImT2aZUhMw9N8K4DSohnY2Z3NI4hZ4A1iel4ufSv5glHbaJkii5pzGF1FJUZQRjZCTM3EbLcchdq8rsAPhAeYstVg0XbBlnlgyHyJIaBbU2EwNwaDeYbB/2QH9Y9mTgJZ8OdYjB7NYU62sIQvGw4vAFtHnfFZuVu9GQSEF1KPBvqSqVcDfamJQwDCsY+Zl/l2I74K9JgVgntlNCDP9hCF13F2JLKeClSLSVdOADO103IvA3I3aXg3h4k2m64z2JbMlIgp1ouBug7i6ebTEaBepGUzHecF19Jps64l83R01kWMbx1S0k/k68yLRmfe5pgzX2Uk0HzlHbAYqHwqh7E+XdMEhdyUmzVLXx1LHzcXeYD9YN/1g3mMNzdxzgzPsg4ZhbjWQzTvPJwVxO967dwsTf6BvAMSAjZQTdjYpdFw0gvoy4LZu1JTsmD/WloD/Gt/5PaLP00zNjAHYjogI5qxoR5CXaZxwuSbI53AHemILNRpwap0xsduHOIYTkSGUhwTluIYJhBOHCMbsmDzWkKtBW0a1XllsY+3Xw775YsI+So6r3JJv6rzikkTiRMstYsfioq9PkI8JC27r6LzqrconfgEsukpEpo/hzDrJGGtR41FPAlteyip+sAnAW3VOcYwOViPnxWioLq7B5RgCoWVSmKVx9Yolkqq8MXmXuEbKHxHDjNjNMVA1CkZw3ybCsS88hHqo0a+ysL87IsTasV6j3YCxO7s8ryTvkRb8VtZS9+wEi9Dlx/3NvnXmWEdlVvcMsZD34R35aFvcTz0zQimRvNh7Ivb3Rd3ui/eiqCVWxgRydiHb3MfapKKSMoPQ2E1rKwhj630Ia+X4oOklE00SslFUwUdhrFtlXKMdin5mCnlHZ1SBpIJIBGarYoO5uQjlV8s8M4Iba7y5dSkNvk0+6Ji8QClHFpklnt/sUStFxW1A6qvMQtKSkvYgRtpBvcgRkqs8oW7ZJ3wZWMkwZqeD9VAnWRHr8rPC07GUANd5wJHZAwNmhVz/7BIO9vHSOo3Vs6QN1GFxOcpZqikFt0+PL+4hmxxDYmFPtbgzEEWrIS64q51ExZhhdfYg5iOCFxtnleY5+WUAlr408lZWxOTiFvU49ky8XsdnCwKRyeoVWUUaoZRQCLCZNiQmmETyIRrhh1plUzCiopE1CwZ1RyXsKJ8Q63KJDjXzsIkONYzMTDG2s+dFAZBX67mMJnwFcIgaPhyMAhW2blrGYSucRbp4N108G6MwRuATqluoCV3p7CvH2EQeqAmAr24Eok+UyP3qQ2AgoMlyxhQPMag9wyDjkoFq8AmtIwVY6zNVuuka0QM2KSIKyudefOiBc8fyZR7Ub6qeKUSR244UmovyruPXFbwKAQEq2J07VELCGrUnSIgaI4JCGZBb2fteWXb7UHUb0ZbafsCB7o64WuUlmNRq4gF6gr2RCfzLBAtHhELtAH5Ns2ejFigpWKB2rhYAL2SZjNRmgUR4lbRbFUsUEMtWnDRqogFsPI29K42E1iMY0v6U97jM0KBvOvYw8hBYw7oio2YWOrB/HZs8by2cirW0yo2Y8vmoy2PjtosUxd/QmvETSvvbwRpaUFZ2lgmV4PicTIDKUFNpQRKNERI1tIdso5gzUkJ4lJKsDIiJdBMGa2MSAla2OTOqjq7jzGjOpc+C0Kj58X2TkVECxgSR1RqFaICsiKtpS2lkEDDmeTtYgvYpaYVEjRVSLDgwN/eHPxdkYMsGKKTMsD4MesgEBtjqIrpk8RIZQTVSCFEXSVEeoVndnMSlIyRIKV/a0qI5Jy+5sAXUxPsAGe0LoGbpYggr4gJFhxSLisVVTFB04gJqpi5xYGmOwaaSDGzLYLhOv7KDa+sZCCQ0zBVxQTL2AvH1DWUOcpb0/OOiAmE7VHcnB0REzC20WxFTLBimQLd7FVBuEApcGWrwaMVwRfVxy1xZGr/Z8f6X6dViAi6j25GdinFn4KsLQCb1aW/zXApl/6YZh/L0t943Jd+vUUKcs5p1fW/Vln/N5uqqoRi0ZIDuv7HU6diOmUqLlBspmLdTLl0k/V/thJJaV7DlAOmybTzddrVRqfd5jhT1wmnRMlus514oEMZLcpa4Lb9mHMNN+fa6rOXEpUTNCRPDJJBTf0AiydaOKvDBJbPyQl63ARtqghgt1NP5QS6VkFO0AIZgTA00dapTWkrJwgqDgJ+PuQT9ICdjU2/4QfFCIIuktrYDBGZwGF4QolRnlnrfog8NKtBjeE6LPgm66oG7wwGu6DYbExw8zmUqCv+4ln98cD396mx72Mfxb8HLhaP1VBVuoxHat8XX/AXh37lwfuefhUEBrHYx2ttrN+Bkx5KxaV1e2P99tLcIa76ycU0DOIMQjqdIhGDR+LTW3Sm0Wrxrh4Th4gDidXmyio6Ulf0MQ79GmmDXsJVPxRQ+0Ww54IRdaqy6gCzaI5qEPlGbelma62i8xzIoNTShdogEXvz2dcsTwXNXEYUsX7KxFGGWbCAQYgIB+KE/KsYDTImWRS1uaBSJ2pYJK5e5VNRNai8veZ+8EauD9PFRFAnux5R0J2mRyc+wvXN4wk0okci0Di+SMOJj+6cIj4K/s3FR9Ur09HxZBvuyvQ/eKGIJ15p1ANBeStTU3iwSJ4ZlJ5ODyivj6pbgggbT5z184UMx4YER/y0uib9RC7KcH+4iPNh69QuHjAvahcPuTAL0YKSOJHewI+gSSWgSRemdD/5atUSAd6+uUjA0uwGYaAEJGq3NfgcgJoG1jBmzd13+YIXqEkoK5UJSp1IxTJug2ji/XNpIPzsGslGRolQzNRC9mR6u5jq+2HA86euYpeJEERd1kO2ZCxbbTLbAeCeXBcCGSinRZj9i2CYlz2EJz7+uAf08qD19yqdROOfPIys2Vfxi7TDpSHQLwQ+3PzbvkbOr2MdZm8e4OZP4SUShviDIXlq4l+tzVC9vwtaDRtAcH65219D9ZCnS1K2cb00m4LsVTdKw7P3IIbqnHwwEu80CD4QMql8MW521eUiHD+4Or9rE4HkKE/mYQh1Wcy6G1BkEWCp4B6LtOg7cSMDk+ImWJBF+26K1rIbkRHx/Zv8NUnT+KPX2/iDI/FvknjsUIG4DI0a91x5NFjwQN5d2r8PSU7E3l1zsYfL2IumRe52kR8uI3dOi+xO+7w1JbKM0abXeVQf08XT+/81dfb+B9ARyv8ecroLZ6UBXx/fYLe7Ycxx+wMwjrd/X1uvNU3NH07m/94ctDD9I88fvYMYO7em/WOgvFYkA/zkEJpUfyhAl7sUAyl/6iqh5KuaDwYrNF9m87VG8jEWccFrYMVu/9L1h7h4GC6IgcSvBm7qfeX7PTXPci+eXFj3guAeTwhnzcdwfcG+ZPzykEdx9crer8YRdBJhLCaoCpc9zSFjwzXofZtjHqbNKiZNdmBj32/92sYb4wfO42v9T5Z/f3TxwNgr2Rj2GcCDT3Kb1ytuk8kFr+qV8Yf3kgte2XvILwKQokt6crWy9m29wkcnS5vLPmg69nvGXFR4mRnPcjQxwGJP42XkTTdPE7yAPMLzeeSJV9Va9hqlNCCSV6PGZwPnZCp9p8a+hHw1enO5fsNpat6PPHi6UgChIfd42WuFxtQVc5FgbSGBAqP0ljOt5APp9GIRvr7XyxMtJXf8ktqu+M7yPTuECtQ0BVIux/rkbk9GPCsR/WzVuFIP0IPyANGtaBS5m21Vl8BqNZpq2lNR2sSyuO+2W/Hvj5ljbFK0PsxeJ83wFUlEu/N2oI24g/OwoN+IJ78fxNNT32OHdKnxxAX/G1CC2us6S++cBbo0pRqZFQomjZRetcajMAsytNiSNlR1X21tSuw9E7H1tmea7xvLAak2We7Gas6bbtSKKluRv/J8nMpUJr9OVlnYhQZnb8RXK5iUpwe7zw9u8RHUfW9wyL5kWB89eVH25H77gpXzTl8/5yVl4EtsN4912t/LSTAR9mlj6OUeX2zS//fv/9ztt956zQcGbGTyfa+75yd/+Q9vv4hcEEz3MV8Jxt14YhJs+BVycZ9fIRdf5pf0jijEwh9WiV9V3/3s2lFfjHEZndZbnbR2yuzzudiPSJYaIfwuDYvKqwZF5RXBtC+JbnKKjh+icHkoKydoV1OOSeZAJ+kCSJeO3g/jYwAKFxd/5Ebn/Z1hWATlZmPfQz/3xT98zvddcTGFPSS+VfBh4B8ooo0JEhePkLi6I3H1KomrOxJXHyVxYOpDJnH8BInDcFoC9yAIXHwiAsdg5x4BzOUYgP3DLZfL2p5sAQ77eeDuhRz8f/Zmh2+0dtSyH9WgmPYLJOZNiNFPMQuqI1utjUIpANQvVs1r8vRY1Bh/CC2p052GETSHjqKEa9mP6fKF2dwF6joHn1g+VAwg45MHbjIGOpw328nonHXUU73hpTeU5N43P71XGnS9Kyr5copUKBCDb9O7DYfkCfOs9Q1s9m/BOz8P4+nJ5nUQqXxBHFU1EQ5VuTqyXCzuU/pMI7GvB200LGwLHmCYNfzRQ6i7ZdhYv+otggL2b9Q0lPWv+J5Xm+UP3y//PsdvMxSB/cw7GFt+ZhRvsKAlyOc44uNcZewcsIrmiRB8Uy+FULqQgx2OGPjM6KEhRUO5XnQAHokWKMLxwNsiSonD/bdFPELICMVcxGucML6Iyypxb9I4ngr+m/E46lNy5NaiifCGhhdpkZpX9gbigK56F/tK2YlQU4UmYgCoWNBbJpWNPtBL2EEUeadfLOKZFEtw9BVQ0xWoDpmEd4OoWeVt4KfS/VAHlxv4DVoQrXB+DV/CmweGq6lZ9GVTkXXNoYh5vbIuKErpGs0ZRwnUWcvluGENhWEhXWB0dWw/GgdxB77jHAp90Kh5wFhM7a3my4gXm3ur0G9UExYCs1oBy7xNbEAhz+Vwm5aGtLgOVJhDddBERH23f/76o3e/9itv/ipXvInpiyDBAcQ8qo10uQNu6FYEUR+yUdiHjOe6aCJmt4n5cBmzcyKmO/FVazxGXw3i8OS00/j1foipi79Jw4XhM2575+c+eus7P/dllhYk/PqxW+UdwgNsRCJgvtvGqtv97OZDZo1S74W+3owTCxxy2KkGvKBEP3JXEbyOskwNMQyNjOqYzWQ7d6+UVBNfkOBUYka8cSrNpihKsdyz2n7LGzFh2En7mbFd6WefvNH4TLU2LI/FUVA6wjTQ2O2omKfqKuq3mUlXHyyxzwLFuiKzEmFoySnvCkNcRVK5P2id3A+VX6k7WxNuhqI9wyNsL9kQp/dw7pDCAxsF26ZNzHJ5+cXkguxMKwF1gwDFTV91dSQMOeFtNW/q7EjJU5vSEaV6q6xZ2vBrCQ+V80NtSLcZ/90Y+aVJtEocpXmoV6lwQ4rfjRsh9XxiwQBZKR4dPLI8o5aS0C9j7yry8MZwOAYDY1fl9L1DmlmH00W3cyS/IixGpVhJoE8vPS1C6WmBltIk/NlSBBzZDdd5bs9uwPy4mpKDxh36Ard2HMfmZFobTEoFDBSixQf22wjY7iitqJALXtVD6h3DdX74xH8gKarHwPCfM3fDBDTa2EQtMODYpi76LTQrUvy6EM6mkFMV9YNI6hVYUEqlkE2msGgaPiyJZZPqqEzPX7QOXdwNTVdy2S3aIh9GMyt7RYx7coTbL5ZXRsi8z7MO+TE6tmNYkCDyOYufZxnmnoO7LXU5FvodNgbjDAW4++jPuJ6fV5/vfyfK7H+8xk70QDfywCRl5/uXSNLdmqQMJBM/9XTxndkfvU7YGa6siF2MyknwKjtBJ7mVIVadJ+vMDi+XyGlwkTLWgwDZ05V232P0CPKOOhDqZ1jTrymyHigcDJCoVmbRwesceQDoPB9tLNwqMDt44zl9XhMDMDmU9bh6rGYLbykWH4qZdGK5G3HN16K5W2n2VpofWkqwwZb8WsYRvgry5nkVpAVaPMK5OBJ6pWLYJWtj0DHaTXvaVst+EgATaw6O8iVK+fKMfAYj+TzV+z/xOtym/AfQjP6PIty/F7/S2172ZqWUkDMtZH9xo7wwvPV7RGdf1khetySl/5nXozzzXQkK/VbH0mTWL3XkNaH/Jwfdt5nBic+Yt8zS6P9pbGYZOQzprqprd2x+WMpjssqW6tzKXmsn1aQdHoBTYjhg/DwYTBpmn0bL9CY6edmvqZnZWvr/eN5U53QeZEsBjtbYArXIT6yB/lURmiLUU8ESZKKA2m+/QT51zPT1gRdMMxxsWLIfv9GZh3M+IyI5gCg35GfXIkgssKeLwLeprXt7R3M0XVKBKo+oCqx3nTXJ/hPIrvdKfaAbXlVMEMk1VLNJCfSGM8paE2VE+d3j/GfukuC5a+IPCa3WQtQqeJ9Bv/tStKD0qBmpclSExqkvOdA0I0KCESPA2ecm36ZWEVUqg+x5xE97vulhEx9VOYP0hwM1Yzrh/0OPOYEahpjqMWv2FpU891vam3IjRcaXR/Z+C5REz4uQCktibS2RItGyXSuJEh7QM/TkKkUjD6gJbx0w/KRGTmQ4Qe+VYw3x6MAoqRLjwCYEmsBJmqD2H61R4BYeLWqDrW0bRTW0YtRbgu7Vu4zbWrPZfbYwsGad9HUUA7WhOoPlRKJaNqqDysU6O1ep7VSnrK5FWA4FRMbwnBuPe/1Ad5UkjgGMc+eh+gdobeRRac0mD0rompWxljsGAebbxDRyYCVygZXIqX1bucJdFsbJjBbulNYlFDh35b8re8CFAUXDqiAPo25p97fvHQwFGTbWB2VZR6Ust/+kyGbfK2JABH5p7+BKtoOBaTM0xPPb+4h5cVHnX+HAuL00vZ9T+6hm5Sp93Psje43Lp5sBYY9xvkIEyRsW3hGpCIOr2Oo7cIxU2N+bh5b/L8uAKa2/Z0IuC2V0ZDjIPiTSn1jzUeSgUKZFBFw4aj+DMWBONCirnmF8BhnsZOkhQnDrvv/09w9+ePuLftrDngCp7NtwmP2ctb5B/HKrWNvwbxtSsM49tgcW3sjKy3lv05xDhcrXPGdm85g/cuCgysOJngYYgzkqdXyPTPVQTrYcrlKU/RoSCh0q2EvhSSIaq4fZdhs0mbmM+horpJ/nf5TnDo7NxIOhVvJRfy17rxPa1Ox+YfdeizqDi4YTtRbhHfu+/PDHX/ZXp36WbaJFVWQuxEj3lT0Tc/dFsMuym2LuqDudmKtVDiY/LHKfV3r+1KVPFchD3tXrGqiq5Qu88UZQRVq6IC7oHcmkdFyTlSsknDZsX+tHLyVPHdl88MbR1fHxXHnfN172NdXzpaOeK17N2v8OTqstDXXbjr0lEiu3oMmeOSEI8bEyIBhwCrhgB98f9vxAz9BklsF0LCrBSbsVh8MwCVa7EYEoT5AN30glN3wo90O4JAV8FAVkH8MvBRtDsOUVG4/l9pmJ0Ya+Pf9jH+sPDRl4B47YfD3Tq4oftZ5y1/VgSb+eygX5TnZWuk4ayBrpG6nt35cpCefnslgU71dMkDkyUGL1EP/k7djcD/RVocUQrTuMHFVPBX/Zm6ZmogDBQZYqGWCZUiFFpVeIoECVA/RNSGZFyquRMqGSy8YGof+hDbYEGqXKq2jiYZ8laqn2UGE2JO/5+YjWBoXpfWGgAv0Krnmaqtv0DW/qwZmPEwlOIgRu4QCueI4end3lFYGe/hjZ/M2eJrzLs5L5w/jwwZrKgm/yrDDYg5KwNlphpN3Atwe97PcARTmbywNlmf4HeWNIeZ7/AsBXS6245zWncZGexoXsG1GcYV5lDvtACvSAD0W0ShNPFFYO5jzQw5r2GLzmKLf+MnMQFurq39LVP1Zm1UqyY/7up/R0bKeeWa2qbHuBH+Y8Qz0ck4Tur8nRBoJ/h2DLHWtBUIDiyJ2fhTg/M7J9rRZR2WiUth/MEz5Bl0eP3LQ9u9Db6qHZWwGEidhbJmMrxCVKHw7FC0kwBctAcI6LaYHFtOB4mBZuhmnhyWCazlGDX8deLWDU098QHkoihV+8n3VOX9iHcg0iWtY5RfQsRcGQW+IXEeNeiXnhGObpJ9HmeDd5IPwI8c63eOc2SQ7vsNF6i8M7fwTvwkeIdz5Fo3jnT+AdIicwD+vJNPTTqfb4o5+ffsAPQjkSksXzDzG+eQCgHfPzUJ6eKiQleMnMehmrSV+RCldP1BPnK2vU5Vdi2dxkkpVPph6uJynZgo9dBM6mPIFUr17r69BXLXPYDVXollG3qqqh0/XsZvHzlyhzdo9bKc/hBt72Zi3PRLBcMClXQ3LBq3AsWSduP44jk8eT0/mjV49xOq/2xKitxdpQd++R2Iwyd3Nka3+LnT66F+dHmN2qXKh+iZxGACOvosgIYVeVendSeXGu8q0t86dzF1l1wzjKC/sbv8dcP4oLkSEUVwHSjjejTlWo1I1+ABWnvZ6xJwm+5zblrgnfW/VS310dLVWeqi7O/gPqr+kh7em1TJzDvFqo2a6aSjQY4X7g7Tc+o/Yd7RqyrJJvsuyULH6Z5XLsFYP0BQJXwJ1hiYf0G2FlzYuotB4fqiyB4xEOEGWID66AGW81kk16O9ry9FvR9MxCjvyKBqnWhAIkpIY+jQInsKNC3cL0L4Nx3YLdDtmmqQ+wQh0ao450FMkEB1TshrhVhCRup440lErxGXRM9bqA/qyuZUeUMxDHVMYcKclNTIRW5aYqb7tw7/eyHt4WysRMZBJl4gHQYGMATs/rmS4VoDxDwVc9QM7WS83l/rmQPL5VE0XwlP00Xoy0owUaK3fVsAPXGQaYWg+bP6OzQEz7SP4ikdPONbSDEjkDVaPyYoHtDtAQ9awDlyjOWyvwVPWaCq/vXcKf8QO56oQC12Qjp2divip0GyqnLgZlXUxTtLG/oEiD1v2s2YjsdluNRf5xE6yW/YkQgm3TYjElVctv94gXXMeidjB8TFju0PXcSWr+X8+f7jaXwS3LF1r3qyrulaWjdE2xoeuZEbDpkq0zw13HrsqEOEOloT8feo3rJhDY+VfzRVqn60rESCO4Zq4nqLwo2V809EQkGdH0LaBkj6sCMreceQWkhtxF4jCnygSEm1/j6oZiDh0gT18aeIGqQOOal/bjl3IR2Z1WgUyQyJjTKiW0sl9u2H0hmqkKmHJgRGlfLoLIlyidfLZd3lO5Br8+V8iNGIHxKIUhtrxOTc5rFkyGgzSuvkbRSxmH/JeK+//gGpyexCw6f4ZH3ttfcyOOtatuoEoTWajXWrpAuToju0VsNqpZ7slEB6YK5nKAS0R5gdGmytTNYo8fYDn0QXpNcrV0brsTodP9nThxltAqyjBbbF3o+OcJa9nP2emYiYZrJpiCUdB2j8yEP39EFxO8qRcTvOrFBO9EFxOue7ZeShhx6lansP/V0fsIP3/j5H0E79/8PsIv3Dj1PoI37T7C25C3lg58P76uVP/ZXQLZYbscOan42CK9JoY6FaJA3hYAGtnQMa4eQBATNlyjUKZT/Rr26VzF3zo7sRQvD3Wg8XUUv/01z7ju1TcA33zFN1/xTR6k7lxW+eErviGk+CYhxTePlHBJth4/Sox7+7VP82rWZLNSBumDTA4j0nazBcdi/wcZV3n7jd+IxlV+8caTN67yS4qNPwXjKv8GuMgZ/hVxkT9R5b5Hiop/5UeYrB7+rt0ETF1FxgXlZX2l7bii7m4xQyTC0t817myRXG50wHJExi8x/EvyjOuuxd25E4AhOjEYpoOA19mNPHVulgPsWfgH9t7lhr04NHGaNupDMNhwOztOzlVVBaDC4KbWbkNet6dm3IMbuIvwLiRA4SiAKA/Ku+cBhbhtOAHqs6s+n/Aj6Kcueg0/QjV7xeJEHjNuHPOYER7fY8aveIEM8ZS7m7XTsTN5Bh36Wdg6/lm7CT+7VlPpb0gRtITM0YWHKj2NlMnHTSZfrQGx63kVzQKwkiOb9pn6/xv78l36ZfUSIXmP7h7Mr9w4fg/Gq96D8U7yHswrH5Xt6kfV4nff+G9nbXvUmYonfuBvHHOm8ss3TnemEqKVyfGMcY957AutMe5fgHMKgYfu1ZV11CNlX+m71yfeG+lKdWlP/NP2r5PJ9VJ++i+5xqw0/HPN/5v7xsR1KlXTpWoAuwglUrzv/79kXCxcga3T9sucCexyZgVyY6lPDK+XXqP5cTDyrsexsajgB06mvch34ibb1pIt2bV6m47Cdd82MgKejsCJLKY/CoL1yHLf7PtNp2VxzC/pUV/dRH7EXzNH+SSF1WWXnBhd64ZIfo7C4wV2bPi7rCeaXA0MjOqEQrFUjXoaE0AiT/JgCPSl0GrinBylVmSsMkTT2IqRnQM+ppA/TMDyZJ8R5oNLwmdFm0J+qJ5Fe0zPAoUVLW4firHrcfJSWTNCVUQOS/+n1SPXDyWRekqJ+M/Cxl3mdevBcbSOM/Kzv0VT9b7sqFumIsr+Dmkqs9uLvbC5g3sJn1MCbHrSH+MiXlGnekVl3JhO8Pftjn74vnO+duaZuJheymOnX8IQ0a1zIZZQHaq6LjMYpHUxB3Ck2NQGQOraQI317MffKFr05c19c8CfN6nO5ZSnjleCCynPaQdczx23UlPv2Wtp3++az91ap/odQ6pjb33EFFnRRG0eWc8TYEKkx5G4nAzkiHBuHpJ/gSjkhOaeaKiwBwMzojXxUNAXF+s713TiZQ9gMHQU4g1GkqgK7+jk4B1V4V0fgXedogl4RyLhZnhXDAI0RuDdrMA7sfBOJuDdwE2NUXhHFXhHgHdjqNVMhXfE8I7AUE2Bd4PhXecpK27MhUjCf4bThc6+qJDrf/Ec7AMU1dXMS/YlJBmjgrrR2CsCZXBRgGj1fBDTYN/4iaEum5wCj5pa5t+jTDURccxdQq8oU9ZUYB1nG5IUQqly8AZeFSU+uw2ZZOQ16V2qH2liHzhHPxMEMrlUMVJ7JvF9Pswuv9EEqxfJ/1m9yL/zK1I4p7PuNDk++OopCn4OAk6HMHY6hPGkDqFLl1TQy0dYCaMLZIn6wVF8oCcRAXfmQ/oqGy4Rp1vjJiLKg3Q4hACYYFZKx1QzhyKEgr4gCRlDNomLRVKFR2gOKsif0BcMuHG/rVgh7iORnUP8pGBUXzByssjv8vxpvjD6Xh6awyzLSuMlEff5KYKAjfT9N26c8Jfxjep58A8em+dBuKg+ac+DzsLFNaFnbpg5Lix0xESVO5UnE7NAlQT1eYCazPaMV7XhgPBXw9HhkMmstZcVWolhdAIHJ0enDNj7t9Rx4N69LuTb3Csvj+0cfMCpEmkLjSHPm378uBc1I1wXV/N6hPAXKuFPO5ufUkqqJd5eKRGk7jDeNZsmCfdwS+WLt419MXBfSJJ+cWfli/eNfXGX+0KS9IsN+UK4WJlAfWlKSVNzaxxwMD0ahSpWVaNFRy56CXOCRdIn4j+WejfM5K+rWX1tT95secZ0ES6ZIXhQgy05UICjBpSuNkxD8X2SvCTP+mKWGcVIw/I56mDA5hEjPcgX1CxqUw88F9X5ChpfLCO+S8uISlAh8svJUf/LN0sQsfdrMOTgpzUo+KoWu9aERDkPUpjt/L5E/HdZzwIBBsditTQEQ+3iZAESrC1i8j5foYS6lB1YE+uVq/y3dRM7Y9vE0FdAeE43y060Pc+5ki4q4c7uoVW9duoTM3bSaNxKxTYQNqjFJlgCk2EUO5NqKJ1iWuEv5TZXjva5YwUK8FlO8szyPNWWgAewz2IHcfrDX/QK+Axo2ctT9lnsREXmqz3fYp/FKVx5cWqZ8Ov2WZyGhAgJe/la0Vcuts9iFxfE1ZCkXbHyve869jT7LE53aT9wdXDO67esP9U+izM0rTiTzuSQFq0Mn30WZ9nPKeIQHhJsfeQd73r/W/42f7p9Fmcj9uN7Dn3gr/75zqfZZ3GOfi4dfft33H7wua980wfss3gCoIyUw4u/u2Xg/fPT7bPYbVP+v//woaUDH/qPH7TP4ok25dnfhX8/fbF9Fk/SFMDoycQ9qjRYm3ztJ37/P1/4x599mn0W50pBn7/9zNd/7rP/+QP2WTzFVvGKr77ju/9i62893T6L82zKJ773Q9zQMz5on8X5NuVnHsxmZ2evv9g+iz025VJp6G980D6LC1yDI+Lx9gwC22dx5sPfzkj+Sa+48OHvKJ5K2+mpGIlTebB+j8vzTTb7LJ5qsj/8HflFFNGTCZ9F/Fmkn1XSTyVFTak6IiAiCdoRKZJRiVJUIhBZdMkpF3Sh6chBjArkBp7MMNNu8zRDSJUBQ2vysQEjDA+ZwSADejKAJgNWqgAxJ6ISZDurfScBWRUAEeUMAmQ6kzOdqZkq6dtAnkEUuyBTZwZUUbn2xHyokuncVxqd80Y+L0RcvAUUBxZatr5Yztax1VYtceywE01foLH4AqYtn8YFF9TCTQa1tUlPA6U51VgdLLZzT3nsLiIJXETbJOGwSdhGkSZEMOeoiy1t1TbwN5HQtEBWGyHn3AQuelsl+ss2OqKLMHgmGksCorm+U000rWIfuUpb4Qlzq/Mg0GTGuB/ykQI6GYJvxSlv8XQQYiHzFyPhrHwvHpT3aV5d5wjRfwbD7xn9OrxZXUzPOJDPl5Xn3bJ5+UrZgXyr7acuGE1Qduv2yq4x3CaaXxMoYK3pEz8A50VkzmOGcsJv6nI3lpXgaTDk/eLC5xOAohDzX4xJq+SjDB+WJasLhH4ErxBbaSwxM4nEQ16WszKei0wuOJzojiVyZAK8KPpYm9vSWp8K4MQiAL9oAE9NXsokV6wO8GHmVnY3Peqt0fIa1y+GbllPH0oCvtqvBUeBkC4ruSh8J8QhNU+MEfYN8ynOplBPfCnMB3LluNqJqGcg/Rn0dGVAMyyUGc0icpYaiHRsSYUf2VvhebjZS1aBa1fxNJ4cut9q0gw2Gsa8ZI/mhaspVjSm4CZs5dHlh+ypEvEzsqAooJ6cdYraN8xnFMsVdGnB3JFkzNIbqvCBJm528lPlWcvP5EQxPoxCaEs/EgwqhOHJF3m4t9DKAeoqasmw8Qxcpdj5JtHhOlN4+UUwQMgIGYbxUhJV8KggToppm0QqItoksCqKpHRqHglZSAD5LQDylr6w8ephrk1dxDE3Z10NaT+7oCtlVwrTlUXtyha00jBzXQL4qRCQ2xbDRrvgSWHo/OLouxKQajtdGwu0pzBtXAALuEA6woK4oAlrxRI19E3PKUWDBWZCLSctu9nZG7ATMeqEvDmxu9jL5PoDGa0mHw0vcEtG92my98ee0DjAzAPr/VIVXlTPwtyfSf8mjCJ4TcAF+qpJwkjr0gK1JnhULD0W6/7+mKeX4KIpPGlTJnNEeJJ5ZuZZ2Q6K5BZGNtUof4LLJyIDDkUaHMqmkIEI8w6hyHBTmsGjAwsTsNJTMzeOrBHbttk2tCSWGnBZLAYjcqHXDWpxDB77cVtYLbBKPWFZLKUsnkvtMeIM4Daju009ZozymX7i2tamGUqNZPnKot3jclEMB9LRtjlpH1oi3cjuKDoqIEgIR7/Zr4uwbPZIMbfvB2++eO0vn/A7JNelZrnMzoBmB0Oaozm+Cd/xZQwe8GRYAJqRS1IdPTTtlHI6iCSljDKGOkfWARR1w5OO3u4IarWrnz4c4HIhbG2JKDUWLYKM0uwjVj8PSOGpWITRCpcSA6uY5ZsdujMFmb7ID6be1/QVl/WaUYtfA2sgR8Mi5rAGcvSoC/azs9/Uq2hikDKPq5c3IooH6c8FrLyhu+GPju2Gj7rdsCTpbvjuyv7502NfHHNfaJJak5Iv+lIc1cyUyN4moj4s4B556u4I14ok6kGP+C0wbw/grWr6LVgXZMW9HDeevQL5sYJIRTj41cqKuqg0yuA4CQqulIkvWdVBtF6REiByYugOzN3xx6v4yQ4UPuDrw6Ef5jwWzuvlRJDkZh8P8W/dqDfSBQzkmy66NiEgaTZv2UQouZPPVaECNUkWlbmNT/D0VxoJ9Fv5T643Rvw36cIFfcNVBh2gL4wN0L1ugCRJB+j+ypAedha3HjA5jmGhxEfn+Ud/QqKm69IGxzSVEL63En4AYW3AR8pgcOgnEXSWWz94HXvOlzj96pZK+E4NQ1z5US0B7T6qsQgedsENCd5tIu4G2yc91q5hBuodj0MegphEsC2nL8CHchbBbLlaz7sgeBkFbqhaUH1+CQXGQOPVlftBBl895UXUUkzskLSoMzV+QV+GgSKDIAFGWqJwoSOgQC9IXIGg3qD4nqoxvyxvSMqnkZIhiJsiVnH+AcQmoiWoA6hbEWpoGi5Fq17t3apXy0dleYLH5VyszkZ/De97y7mIiIabi/By7/qbrMtcAgNTnYuJ5AfA8jqo01WiHhqPWB2rl7dMmsYrRUL+GX7tvZiYzj0lZmRkBPJNNyszHieZnTInUcdNI7PqoK/SzqYMBvRR0e9RoMDIukdNY1hegKtgAgB2Z78tpLOl7W+Xk3UG7a6j3S1VB1G4pBhu4ciVyCSbERl3qwNdEuHdjb4ucM0DJErhMyA4+NXeWXphFsdvfSX8vsig3VHEeO4pGkeKzuhqKAnENseHbq0CGsCmR4bbIRlek+FgMMCaN5SDNFwpQVMO+SRcE2EguS70VOmSuaThV1SZ1UqHAv3SCUPrax7uzWS/o7eLBMj46Q7Id3csZe5t3FH6hK5tuGNGdz2YcIK1cYe7ujkYVq4MD/gOqhdM6gTp4UhX9e5W3TRezT3ix4Je3cnyGI8ubP1QTbX2QiEUCxJaxWzT028R3kJfugZ9aTCSeir2UXSxajf8s34oFHv0+Ds5zpWEBgxtcbl4drHvwklsgqXwEn7EF9YuNl7+q1Y7VRc8rd4xCso7RvH4VfrYXqWPxSg8pcDGVISXU+8YBXK2NWKuM1gfitgCcDqXH0n/YobOHhAXHBInasIkUbAnAPuCZs6QWc+SdyMoqvRnlSXsQkjth63qBy3UzXEZYyJA/IfotWxJ3cFl+sZEwDzLZsOtSZ7AWZQW6xphdo/YE5aVh6i2iXVpCM0bVEcL7cLHb55c/6sTcgxs4C4bOMoBLG038xML1O3y5E98fd6r6cE9eFYXu2O2hPtt4EH9FLOvDstqdv2imrbJ2iOjOPsjA4j+wVf5zqMdb5sRoc0+l49sSfudp2Kb2b23+H218t7m96zyPsPvoXsXTjqyWqR6ttA/SPmcO0NFMuMtmDJOgdMF5C/mqQHHqYUvxuyoSSnOnz+O1muf9LuATIYW3tplHiC3nJjisT9f0DOMgGaU8rbxWFQ6vCRFy4a/S03Zpfu0jF07LeG3SLBN3SLb7EWJWDGiyx717HYVpjAk3wohtYyG2COw0o9FPFjMgscSLeOxTFvw2EJdiGC6tAA6SPM0hz/WQ56F2qZHgbpnV04DZWl/FrU/gTQ5MDo83ErlH0Asxf5KfGVPbQIFmMKaQi6F7DKziMeitUayhPm9ZAQxB9XuIw/eFXDgM4ehyudIB8vK6zrlvZXOxL0VbMrK5Jlpye0yuT0tuVUmt6Ylp2VyOpFMTQ2XuJP9gZrFrfOEd2pH7/fkgDUcOWD13AGrqrkpWxCQtyGCDqPpHUHiAYCO7BWxxTXUMsCNp0BNd4QbR0yeBTawUq+e1ZbutzFSVLentbxeOafHnj2g9YUNzX4XnRmk14rdAmkOPvIYbTxBG09Pdqv9GKftNiKpUHB3NByYAqoW0MrrV7IApC/2vKkLaA0UOWT0ych7kWuT2CN3Wu66Sup62bX3NuHrjT8iXxfJj40vktd44fTDaYyHHroypeQAwuTrE6fyB4h/BK4HisBqI+hxPc+4UN+z35P6YnTewDv9StPrlRqQ56py+R5OwuR7rppwXi0gGc3romEr93Fho7P/Q+Sr+bqDX4VifJ4CVczVPr3xV7TVM20Ljo+LDrZz2f58Vn1IRNTh4jDh2tTZD0XseQpBByCX/VrtMpE/h6qkvgRGe1k11btcLXVFaL6FYt2ErlCkFfZExc9dMixW9xcZV5Dx8Gwl/wBqxNGF9KHYji7y5FK9iDqxmG3tAGRBeGG6iReQd9C1WDjk7LnQEtxO3ctWSsFRJs9MSCC3NLaG+LZRh1ZoFQ3kZw/P7PcNHWeYqAe8Om05IC1FMkqbo62UoF7qQOjLbfcoe4JXQzrvB8BAt/uh1utrtR6qbRmCBWCj6NmyaJosen7zoq91RTtqiXIF+G0CUyuDgiHJFCYcAyD7+1VbZVHNF3kCxkwAGueZVLgy2oUVPFYoQz2ZcQBV19HIMLYKurpqjyRoVEINoEqDmvxN3jTHzdDh0a99HdJRrPUfGdZmE1jbBtZG1Aa2ZhVsbX+dsdX/t8XWY48OW3f5U7E1fMzYiqKnYmv4jYit4ebYqqT3Us97hRPBgyZ7bjYWEWoOCQ97Ey0wKuTodujk81NLAqSmlhQet6TfDTx/8mqwAvTmQHa9elHglqC67dUMh6oZbhrJAL1LmJFQA7Qta1oCse+aGnvn1NhbKrFH3YWuG71KxYe8yZa9rJJ+7WTygUry1ZPJV1SSr5pMfrbzm+Aid1W+OWvym9VKMk0mtyrJ2WRyrZIcjoLZibT51nZgVevc1iT7hLrpodrz257hK/QoI3IquHJoUVrKYOVeZ1M5MDaV+SPVSxVW6d3NCCdCYNZGrB/FlmkSv9SlO1aVQFevwquzqGHegJKzMxlN9bam5I1KdJMc30cQfP/4J0+9Pz1n9ulst48PXPYYbdVG1ZgHiDusgRbt7E+s1QnsRDFdGlVrajNVB25qe3HEmlo+U5Es6EkIZ3Na1kWmQ9OR2b6R/cxB2Zzq1TXYg0OtiWK4XECjWG5lApb2gtusFCHqE3OVbosfTl9OEOe1QAYigIfOsOArTylWawZwyMR1wR4x58b2gWa1nj8Vxjpv2uV0HiRp3lSriwHyISKpnPyUFlOPwdOxZOlvWN88dSBpLGVgdspyeqeavhEp7V7htlfthxgaae+QWmSHI9UedKiuX0P3438hBRsrbJUH/FGHdfyrY5VSszJWTeL3kbEywaMXDTBu0pQxYQ7W67qyvuLm6rIeVoFePl+V8sipIwtZYE8BWCxn8QHV3b7oWEUypyNujfIf/MH/r/7OZ6wP+YwQ+wpK8lnc29UB6tfzWXP81bd2feFdpq64eQnNb0CqpatM3WpXN50QUDAQxQpcMSsbYl36zEAaS/PZ/9Y1XA//WvjJClSFUCJ3CqjOq4BusPJ6iqyYddLjmmYQZ5zvgj1Dg0Vc7p+hXNWiTvDgrMjYwupSA0ZcUnaFEnj9ifWm40hntIBitHuxXgmOs69cL++Bk2qiu77adC5AGYKxIR2qfigf3XwPLqTo+cBxhylPx4qgGRfG3B4Zw6DiaBEmQpsTgtl9exlPXYOBlE3YE0XTAB9nSWmG8SO9/vSWb/SfE5batcRkS/TyqDTbUtTzBPt7tvG29xorxqsQSIGH9sCdJjggNas7/VQvbzYZHjjHxRb5OW0Prt+CNbn0gop8CbYpUnWeJk69Y+JHR8UM0LXNEPQkOGu+geRES0JwXiD38IJqm+SLaJBpklA2hC4H04Ep62lNS8wz44zgoQCemakrHLNeOkizvxQasWg6hTK2iAHwS7n9i7Czkl1q457HcSkUlJ6LNOW7ZrQK1lTtUof4sVIuiOaiOdfo4+/SnvX+qn3UTmfvevVYXszZHgd6lQ9mKTMZu3BSFx5VedmKvOyVcBfA7dIKHivkQz7GLS1934JR3YLysCw35RAEoVXoC0NprKkEy8An36pWhbfhoQo1FOyd6i0wZy2KuwKqEwIDGzhsAwdt4AHfBO61gWM2cNSnVSKAsVjLd3BdO3lEt8qdMrz0fdEu25mfQs18J+2gU/p1UUraxiEgkmr9nErbyQRP63vQu8FnijmcUEDUCKEkw1YVwnI6zSkBCbIhH6aV5Mvp1EpyFwo2DFwslQAzU1S0BI4bmmVzmps1Rw0zw6fwvOiLFSduz9yJ2oJ2cKFNbQtDCdm3PsfsUnbSVt6OQM+ybN3OE7fu6wesVNGdeIR3Gvw3g93UWvOulsrfeXmP27LDQoq6qAKQW6uqZu3kd9PKubGkHuo/hcvuUZsnQ8sA6hQAivqtSzlM2KYQNRG1CGrFc3wDdword+luYzKzC06WAb8OHqdQnWG24eWna8DPzwj2loimMKEzFEQInq5BA1XaRQu0bCBaAVcTG+am0czpz2hpAq1msVIdNAWcG7jRinnyniawcjXipcirA6f5TqVcc27WClpR8oah02oEFcq65FuQnVMk1sWMl9PjAMB3ijxPoWV5LosMXQkUcGORg4GlVbX+IW58ANprLWpx3M2BCB5uCnQ7CLpl0kLl+ESTyVHx1KxGjVQ3mPmZ+mF+FmfD+lSczbmmr1DgKPOMzioXqnPoTOLHE9xCteoWqi2bLFRAJixU5Ocki9XscRarBnlKAjuTi9UM0rCZMIvVbKWbM+ViNUtkFqsZt1gRzT4XaTqa5xCVi9UTxherjFJZgAh/x1+sXN5pi9UWWtWMujrleblo8YEgYxJwTlev3EVMLmEEisbtH1nCZiaXsKWRJezc0SVsly5hq7KEFV/XJWyJCgB38f/yJeybS9iiW8IW/02WsEKXsAJLWCFLGCY/lrCZjWI37Z5Yws6hDuD3BDwqS9g3lzBHf9xaNpF08osaYVEjMsKOWQ4GCAq5zpu6AT7uvmnzJcmtRTO6FnUoIlmZYl2Z/o/fQp2iWyh+rNA5eDDC4nHK47Gh2smBnVM3VCty4SCnnl2juoiwV21O0TWMckRMrlE9PBgP8Djlm5uur8eK9c0V65ubrnPw2ElPwGPHv8v1ay+qkQUKjTIka6d5NdXrS4lB+uJI2Y4ydyWnI2xa97TVbSeeoAHy3HH8LRyCRvMyPRKFnnHsO37u51zrJX0Jw/lUaaS5xi+qepf78g5TOYmevAagjWqmGiHYthelPLV6H4gV6cSoH4eEZD6auKdSVhGgNCJ5dI2xQra2ocJNe4am2i+i2asqc0V8pKiPq/7ClLQ/GMACUJ0vwvhyBIWyvFIZOI95LYCk1+O/p5fRNmcvj91dHL/luay4WuFUiGApZzSjVF2x0XOE60dkPOp5Ed0hhufzjW/qEtgBgPzHI0BGHBXSLdF0S6sQUdgZiAQnDZHaSUOk9vWBiDu3nAROuhOiha+J68B7kKWA7x09Q/uSNXGdfjurVrv7Z4J3am0v9wy26vUwHPQHVhnd6gXqsXj1IPz6IPDh67piYDTUBupBXqSaXmepJvUuivpf2w4FtdZL9ZACTVEPPx7bSgngO9xxlDGMtntwx1OyTaFxSJH9uZzP1mWU6lf2kJc8UX6zOi4htFV9Ymt+r0bWRK2sJmiVmtgPUFwmxe3vD4IXUpj9DM5SpNGYefxQk6xSrdqp9znXLxvbPpFgkSqt+ugDwFR4pGFAMtZLgzis4deifmXBKBEQms0BjjUf6KGWflLWqgf62pZMmpq9EzWja6VB5zj9qTDUIfCsKvOxoLzbAzVFB9CInP2piUAt+4D6oOgfLJx6cB3qwQVrB3NPxNxrpKfeFSNd5jYeZ5MFRyhaf5fThg6gDc23YTZRoJZLNQjcYgN3cgDHYNdSAO3oGz21j/2ged6tycFRPKva0Ru2gGM2cK/55AE8DzrtaAxJqblup9kVONEnZAzVCncdmoroComTBfHXRb4S8xV+E2UCcToBqQwKDfqd8oZNxqGPBqWbr7uDyjiADmEm8Dwoas6uFGB1d7CmdYaK4yDZFIGIYfiqfnORzemzOj3XgBHA+cEZLERwspVdt915XDoYOJ0Dz+kceFbnoKpakIC/Uj+MlFqv1CnoQSr6OrrONqrOXsWyZyzreIzTYjV96Kv9QKijG2dwotfbZiBz3c5y8gx2FNSStqhLtSJVM0tpKUBtrUkGTbax6MiM2qJtS3Ke4CzxAV/2jx0O3qvBDI2rQZlZiMKcblXmpZn5ghKuRQXMEsUyG/EQd+MthGRAEwm1QBfUeD2/p7o7onJ/hL7w+xzxX2nCJsX95dSasFF/73PMmKkiurkuHk+ZLivGGgCetSnpvXyVeOsFdS2UmcBiTZcHSpjkJbUfRk1rsaZO9VI4wI0a4yJTWuYvrfrvormxgybrrXKuCs8s3zrNYs022kqrUJTfTtunWKyh6RZrclgQKKZYrNmBhO1TLNbsNJZDtk+xWHOKS5uwWHOqphWnYVeCoict1uyyn8MYhjwkOGmx5nTETlisOeN4FmvO3NRizVmbWqw5e1OLNec42yVPIO6Ra7A2edJize7pFmueuKnFmidtarHmyZtarDl3U4s1T3ENPo2KKRZrzmMLKiswv3I+W1bZTj3ajpEo6LzpFmv2aHYYXNnO3X8C4bPT+LPT9LNKekGKmqiasxIgJWi3Sjs00qAUJ55Shiy6bKWtHOJMFjkUf/CQ/07nPzfwZIaZzjJPM4RUGTC0ZqsrRP/bPcW8DRlAkwErVYDIHaISZFTt+6qArAqA07i6bYRM53Gm8zRTJX1FloIFMVtIC8waj1usMTQ1bypBzWHory7O4hcoAaFPaYtYrElHLdPUNH2BxuLr2GtfACUayvIaddTvL10g0mGhMff6RQ/2aArGZglspxVJeMAkrNBpmnBaanhbrWmLNkO2mD1tnHk7j3wh2QVNlnyeKVIDp7nbbqlwfLZUYlQzl30Q3yKOKmilEtVF1GnA3TJqJ6JWqBgTwW2B8GULzVl937Yxf5MKv6oqWyymvLBcKZ6KhLPyJTxI7I9cxL25CEZvMnoqXXQg96W6fFEaki9LE/Mt0oO8g3UGi4EzcqOr0JKYjtH+5QvUJn5cYC1T5HCjVlMpAcSusnhcAPOlEGHF8OAM2PJ87ThB1tiago8yhtwWGkvMTCLRApXlLI/nIpNrNxexOJbIkbiFLpdqajQrrW2SekIDeBMDXurCyE1dMVn6Mg9LE2LkJlvjyim1Fm5qRjjVrFq42W4s3NSIQ4LBTQxi07iHMRZuurBwg4eP8U0RdRHSL6ILlXlrkWcMLTT0ilNSpHLWWyp49Q+WbFzD2Vm1848a6kteGa3+j8PSqqYYU6uxTXmtM5rK36rBVMDRKqb+TeBDk8qJNepWnVk1x2D4Qp3Lqz10vXr0UbAyaRnRktj9/dYLi0Q3Yg1KqME8z33ugjVSWgc4CewRDFXD71AT7J4H0brHCA/nVXK/+gf34z6U40Rbai4TnKCvOpkeJdK8QpjsQXl96YMDcP9GpTT7rN7ITqmOSjb/wB/5gFpHxIt3/5W4HdcQRcTsDoFctfFoevqc0jlQ3oCmnihm5mnV77aX+zJnfIdZISXcFGNOBqA1dQU2BRdurcHABkhQA0hUdxIAb6NoVcwN2/Bd7Am5NRxSeOtQ7h5vVDwkBywm+O+suo5hw2boLkx+1YNX8/u6v+AfCuUCWWQssnCC2A7nB9pm7cOoU+Nh9c491bJbZZd6XWjNTihPzl9nPyp2kwMOvVlCXkUU0TIX6sCmokk6VNEQEEEoHh6RasUnOCfHw0GlGcqnVkUTPxJ5ibuY5vY72FJ+z2YeCvRm9vpDAcDA+7/v5Ah+PE8fl1uRRamcHVig78W+B7eZcSikqp2w5ILvyixSsCrQXtpD2XG5fb0YriJESrBH7mtC0NKQevKm7i7ECHG2pqtn4TaTIqtqmmv2UA7nWvJA3ZKgRHP+lSAZo9yiuj054sa0ucltXlkSFTkmxMlQxdRzMNgMKJViiyZ5chBWQzflIMwjiXvec9Hnhui1Zv8LdEEvS3oM6JSSnPurIGsqAcbu0e5/nOwU3ePPMUgSdCla8P1VFd2saEqSKukip/rIZFBgZ6YR1BRNXcAbToTUHwNFvEjiDuuLiqaaLGpmf4c2mwbjWzRZi9BzzoRsNbUpusAVFBEIVUYYtLq8tXhT6MMq1KQ9KDJ2n2NSs1N1jJNxLMnhEK7ZQjMSDYBf9tB/pd4pvZYP2DdKv4bVZB6hxohJ64Yzad2YNGnt0iUVg4UGyBJl/9MWJQK5ajPUNH9IHA/UD1Nci3aNqmTWCeJxlO90sCX5r5EM1fbs8wgxKwqf4Gg+DFofrQH3Ioh+9mxmHCvYRRHh2TXPBNfzZSY01uQWLT+zz0np1ADQG/09IrY6F9m4Qs2D0R211s25X4bc1+ryzbPfV4RLXK+rXQYA9FNnNLtqtMmvpf9yVquukrtr64wYQI7mqFpzkMtt5lf7otcc6KfwGMi2j+TKfKwyEx0TioF2eaN6BaSOWyFmFFsq5ZmmBu0ZXXH3aRu94w/lOL8NFGMfXCJGe7We48+gZTdquCOWcDsv2Z9niH2Vr0f2CN+g4TnNrYf2thRSJrPNB/hgVOUCWyNfRotMm9SDhiVidc7cEvuPRZf5ZUPDYshTmYatII3b2TbEa9n0CmWsGNrl0TItgXZpnD3E58uAz0UaV4JtiFSxlsdubsCVoNDGJfxVDt+1h9ppnNeP5cYyouTAfTJHsyZjLHY3uYCiJ9sPfX2VvjpTAjFAHNMSuFhuqT2Sr2OHsYJiLQogqnIkL+Soq/CRI3lPj+S96pF8ME2OhCP5V4MXQWhQhg6XoYNl6IEbbejeMnSsDPGQ26P5fE0sS+6oHs3v6PuyTu3AmW6+gwpz2nyKPW2uu9PmujuaN163DBpR3RlDPMVuHnojx82Ke1R3Qq/eyHlzrCYHM9kWqMlBtAWH8/WyQfXNGoT7Rh6wBXsXyCtP3KD5E7ZFzT7WtS0MJ2QvD+d36OF8wQm2dTtO3LqvJ7hSMwUox7GqmRVmyOum5jzWktXK7SnYflt4qUwR8Bs5h9/B76ap82NJp6ANO7n0U6iTJzRjwLWzPKKv2yN6bAEx7bHar2xAOjtxRJ9RF1AMcAh/g5+frqEb5Txecc3BRA/k0SV0t25O5R1waRct0hYD2BGVh4zh6Y7lTaFSSJGMjJ6Czw3haAtA9U9TgLla8VZYouHap7lPpZ7m36w5YsTOIJvWJqjhqtTilUhpyS7SkarxUu2p+xY8xUB7YilYykOiBjuVmHlQlMYiU1GU9kRR2hNFaW9MUToVXnkoNrYcmW+b9arJyaoojacqSqNwVZRWqOsa5tazDnlQlV4W9bQOj4aqSvPjCaPrGB6rlSVsXgs0yxnQa2Q5mz3Octa0y1k2uZx1zXLWLDWlXT+75XI2Wy5n3epy5jSl63SOViG2SJ5A/Egq69oytaeva9Jnt6Qho1vSGDnolEruVZrTjHZBy3tmceNPq7qHCfVcRGVtS/BI7BI3O7LEdSeXuJWRJe7c0SVuly5xqydc4h54Vbl0laFjZeiohk5qKVz5Oi5x3I6To9nckG8ucV9HcKU6JewS51Y3rTSPtdB/i9VtVle37mYq0xkA+AQ8dpZLmy5yL3NLnDbfLXFK/d0Sp/18FEvcDdOWODd6rvLJ1Q0VTl/d0LTHvLqZKifp1E63+k1NHyl/QrtsdL1zOtTGQLUQcneJ+DibLl2tpu+43DKV6TJ1DgW6Wv3fsgODGnWs+tOJ0Z9+fHZkOzmwc+qO7BS7gFFs9A3HtmaUuHhFyGnrmCpRf3PH9s0d2zd3bF/XHds5eECbuotOfHP/pvrVqA0DgWXIVYs3i0NVjerxfZ3LuHMy48ReD7Vvol19/H0fgpty5jeUJKoMHStDDFxZnrBbLBb6yXOFMs2PXUUKGGcTAUUdHkMqzIgCNeGHej6I8WjDt4B6PsBhXwW0HFATMIilBcxoqGpilyNTe54WMLUDmgdl1xrLEtXpgbU0Y8zILJjeU3oBijHN4vmQjLUSIl1ugZR2ZZFAZbSNCC3StVL7kOtpipwfUEQL4Af4ffZ65/HCKuem6W96nn+tmgDKvnCjqor61miLan8Eo9ofvrhUh74qhL3H/un6QzUAMPsbfE2eO8eEKr36/hX4hGL8ayOP1D9O9Vs3q52JEHW3msdaWYBWiPrdcErpxH47vKrysXN94FnfM33q/9KNB8W6/huuF7m/xmf/oKcAFQf1PwLPBhN+FCwzpMANrCtKHHVHjAw2KSGNCy8zcRG/HujDdTmOva/mtzXjf1Jd1FfdT7ZEufuTP/+Jn+cTbl8MX3ovUW/axOew/U8ghSP58Ykam6pUl43Zx8RCsXitCU62ztDUmYjafkXxkpVCvf5LXsgFqL8C+S6ioPSVKdWoP9nkfPMV1MZFQ9KZ9PRQtjxCPCQt+z20dEVPRCNR50Qa6rKaBM7NRCfNfkf9Xr7GY8umwbUT5kV9OSEWjQF1ss3YVdEbV5VxirGO4VTN+tuPslvA5YHnw5lyBtV+BLrDI+iYUyBPR9zwB+mTPO+V5J2unvzFQo/ATTrv85uFlle6dk1f61m38p45prnc2CRmKgEkZqLiYXZg5WBYIjHeoGhd1M9FcdQq4ks35WQw0H7IlIiuLAJYeA0Jfs/XgEu9IjR2Cn39nruRvqd03m4001WLPzDvQBQxb+fZKyjwr8jlRsAPQ1zg6sbTwcPEMybV9MHDhbLVLwwq0JJiPbImvXwi0cCT0FSfUiSub0L5SkDuSkUWLji90Rsxs+f8VRi/kaExAqvTz1ox3CkNwIso9MojxEEaEDTBg9uqqIp50cISWWetGaBG3/sBQC1wWhZhenMcwrEptKgdoYlNcgy9mF39Pdmbjbr8p39f71qohe+Q6puovXeNAe9dVEcRmRoI24mHqI6TVY2IxE4tjGNTAxoZ0GSJ+qw7fsU1UJ22xuIoRK6IIYmQ8QgbuXPqSO15q6q3llzXslfx0wXC2EqyNwMWEp1rllxuWsgtiFUJEYfQBR5ZTxjWmj0/pTqqlLuzelZPRYrhQS+ABk43Wjc9WLp2USO7HXUWESFz0aQIGm/YLmorpKAcygP8ylVIPdlP4ZuVcnltiN6R61MRoY5y90WRdmxaV1IE1XZ/mZyVyS0FMnDNalYAb+rZW9Q2BOqtSw5Z2c2QaFQid0PKTzhP+VWIrxT5Lah8GDhVmBehdqKuSuTP1REDHQCoqYH2AD7Gvz6QpwE4wONVZAvlJkjtCMpMxMDLLbAMl8fwaMGsNu5IZQpINLsyIcVZDbcKUzN2a+WzmbzpTPft1QElgRLWI3BXAkfh/pQsChb9fEcsfzmMQOdxEh7ZCX84Lme8uSfkX1aVlYQaO+EFGYwIsLYPwOItuRVTOro1Z324V8jgwR6gvZ5gmBHVNSrkzo+ziM3Jh//ZJA+HhfPuTsm+//T3D354+4t+WjxNli9X9taLCDFD56jijgHHDd0ORpKP3DF0rKZB0KB/KF6DEbmPfInrzL6i1yX4/CIWHQzyqx4uumfvYxX4Rmm1+3l7141SVehcGHKBUPBqqEMwkHz1zCUgsjwxGM02tWVNgfBJOjtwreNCZBVgf0xf8nAnoAV8ayniOuBXyxNj8wk6SgkuroyVxEQArcASs456GpwAvNU7Bv1dkgnuWeIxo3cBY4UiIBZY2O1krFFVsRfcOsTjiiOCj8rQQGhhnVT3QffhkvuVa1jr4bIlF2wd5GE5NOqHJReWgTwon/G9QK+0hu5bNbMAsrBALbGnv1pZpY7WRqzBulsx7VqpwOmTJ+pNqr8pp079T70OHCrijfamxxRIk+5HkupvysJYlll+f+6aZkeqcZrvS7TqeqKTpRFSr6KC8nEvUBW9aUusr3w4tCADZeLswsmQkTY8/2Mf61OQvVrodkhhGXlVr3AgJRe8qseywih7DT6QtTvqf/DGp0HjMyT/KutiL+Lo+KVrGLQyr83pSU5Dm0K0TZnPyoKd3l8P6kJJqLZRQM+zasvSijUxotzI3dEP33fO184888rqpSfX9KDSdCEu7o4m+OKQR7XSTwrWcd90iJuktixywat67FjHtYXidYVwEdssR4fqPxBsK5ez78ny7+9xOZQCp+nJ9dxxK9WHUo2W9v3IcYejTiGsMFLC2GuKHLp21vkqaZQC+gCEqlZyRzhCnQcQnNpXi8p5WRWC4hXeJhB9/CEJORZDMnGQTEYgmVYgWbeQrE9AEshbPwEkEyb7I5BsMCwBv5TqU+CXOPgBbuTlTM6wW2uSBR80w1JO8FLdHELJGaRoFKq4M8GsPdWY5hm4fhOu0CgVyBZ+D5SX3zkgEPQu04kPbla4hg3P9xxTThXqpW6bvA2QpQpUjWghdOStpE73fhBLXqZ7i6S8wNmS0Kpe/gV5fa0QJJ+CcnvoaKFPfpUG+q5vfmWY3vxQkF63yb7G68PwPD/YK1YR9uAHo391n/Ggd03haWt8m+V6zuK5LF7vGjRcPAa+VYzQ6tYGYoLXodFVGvnjgJw/DXLqgEkBqMBwIFgoL7NmUnj2ekOdA7Dopo/3vpqbS2H5clXPoEzoYCYEfwOMUmVw7him59SMQOqQrCnYMUifyD/dl023/wx99DFI6XkMRXyQ3SRY6mf/qCarlcEUeBpHiOjXGpQwcQX+P3u+bsz/PyZ0EmgyZun2/yXIAgzrpIhgXf0CEiezuwu0NSLZQCsaa7L2sLzin1BzLe3U+kPImrKv6XI7x4VlHxUgJ9lbBPT/y/eiSRmTdOOf3U2JmrRMBU7SlREt3sBp8QaTWrwuXVIxaU66ePSqs5b9C7LaPX0te0hfoQQeyH6ir1r6gWw5sZ+LsJ8jsFRCtwLNLNt+6O6q00u9Ko+4QNRr8QixcRH/VAClh+/gOUBuvHOz3odmUaTOyZA9D/ip+xOnV+s7zP6vGFw0QRrgax8CqZN8mfcPS2dMdzxBMfcq3A12VdVtDHBBEC9NL+Di+12DDn7/rXaz7+tm38es+JpioRNnBJBl7MV+CW4lMRRfRRaQN+20DIRk9pXVsjiGlEQakaQvMGhL6A0e+EigGSo8wQiBpZY+IILjEWZwSRNlBy6wVZYO2aRto/Wk38ot7Wemj9ykihxPa0IBCAF7dG+sSERBZecXpn8WhI3rYmHFnNzEK+0SgJmWohS2/Hbw81aMYloVIIpRUN1TSga9rxLqpWvh1iE/433BP2CbJudVuqGDS5Pcan83JNOZweEbmTDmTeLgLa9H0AjOW1THoy3CvWAXedWLGQQ5/jCHq5PmbcO8UzU17+GOTh7yM3PRqQvqnqtD2UbRHoJf9WiGEKqhtCFqxF7A4wfxXf7rjSSduEUeAhm1j1DAH69fgHbgk1nE78pTzdCl2SPUXi/aLIXCKMpFHX7RbQ+cV+iuLaRmhbtoiu+aIus/DRPJ3TLyoOH+5zWJ9GVTZqULZlPmOcsTtXSRf9wUqGV/IjNw67TYfteQv6d43oTjDHVa0XI+K27QQ3s3q8/mr+yuTlBbpb5kbhxgFjOXZapIWzVyFb7TD8Wtl1vuZI+WM/VW72nPuP3z1x+9+7VfefNXeehLv5u6w1OeQwXdKio3O2d7oA08Vkmq3ukSB65U5ydw8mtGdDAAVj5UvkRH8P4l877urqEVeqFNr85BIuPOO3RMQg5gLOvyhJ8AujT3raMxX0YI1B+t5EGtti0oizZGSFAJB5KxKiBbTu8OQpHHOKAd891ahV1ABZlCI273BZPFnopAwasCICTPdVlvcqnxE3OUQ2P8bwR6pSyYUtU3KK8hkf0NOS2T+2Ou4gIdpJCvKduiN7ToWNjF6nFTGTBnQfsLBplIeorgSBGuG5+J4XC4bphG7iZ5kKnXtLcqedavtb8Qm4k38PqUajwnRyqSI0WwLrd0IgoqNWBtRcUsMIHkDCe6Y0A6IYfl8zg5FitiluoXgf7+Y0b/UNE/EfRHSJyv6izQcc2T0dkQlLMhwSsT706J/TWgPcWVQ7+iIYgnxoObx8N8expbV8xXwe8Y5jemYT6KNpiPSjjQmIb5uw1PqZdVvTUwVFjpPb5+00M09wqbtqCXvVPoy32+F1QoWuj4OfAb2U2vnsJ0qRQ2GuHpIsfTRZM8nUtHqvJ0j6QK3JPsrEn2NyK74hWsI/2wvCq7Rr7j7SJc8v0AvnZsXaT5gpKtgxYXsNiwdZGydRHqV9ZjClvnc6t+XcoNzCGFGIriJ/mjbF3oFoCf8UOYXsMZzGNCY2CtIDICsjs8YvD5+LgcT8dlIBZOpsFqKXUNpxNuNTgTnxT6hpsQ7rAk3CHQN5yGvvd6fviYVzo5WhuHAOdXIbn2NAbLPq2nqBWEK9Qe6vXcsR5G03qIIk0PUTgHomk9fKvnhRUOP1RMjuyuQg0nqGNmCNJCdN03WxXE8R5Pb3P6mMsxQpEQ+yD7EZkKdqNT7gwCvAKdwebK1fHqzkDZYD1wcfuEfeChj9UsE90/avmhUDcK8GuJFmijsx81UgXlbAHriS3D4Vf/O9gyfCIK2sKsuQ1D4AgqzsFDrdzXcZYe40zcOGvGXO4vrAkam5iYY8hdJq7BU79JqnPSWZK0k+rmQNIkQZCyR8vpbztgIhsiByEvexjkC9uIfuZeU34NtSJoyPn97cR/l/U0WRh6nHqqN+O3O69seqgoNjxmSpIfIeeM2tDXz5BTDk06zA9sojqD2YizIs5TJhMyHxnJo5MwUxtZHgXqYBce2ETAcxbcarvvsyNWn0ANjv2kzhJ8Ah9KcAXMYTh59KQgR78sByBV0hwymAn9oKe2rxy0xPQFyplDD/M5cFluG5UFcgmbPFjpQK5Z8nj4D9DMWj9mmHiwq7DnmjXKyo4OaE71PMbsFWQVJhOLUVXno40sbZpB1IxR2wZ4ABnAxVjkCyg18kAX01ShWFbGTGyUjo5vlLZNiwXR0I3L7uk7JSzj2CxlPz6+SbrDapyw2S8FqIeZeFHV850mn1VJ3j2ZTJXknZPJC5Xk7mRyUkluVZNTjq307xOeF11rFGcq/Dg0cXzlL6vOiqtndC42Vo/JgveVcVUdh1qJC8KWg8rHQ37I+X9lrzEcHqH6ehEO8ljYEQomMsinyJXHFIE7N2tnjKPNPHb+kNP0XZ4XXquOyTIQKidf1uOqsk97RyeugQTnMIcsoKP8GOIskl/cZ0WE9lR2YJJdMw95a6HGabBDcDm42dwLpAn1JG76bSYigSj9K14M47ZqryMCB1yDVVRWorti1Jci+h3w4/7a2siYQGHZveohOwwiQMZbJBVLK8n6sJDzLVFoashZs9QjDq/z5phtyTrVByLGSSnMWwzwNhfdopYyY+0NY3WH4rUNLjghLVDkK2hqi9rYR7UpVR+uYOSexbFNHrTWM2XA/psukjUCEeizNpNFP3TaqZKEolEVyYZTk6DHJjROFfrVCAJ0OrSoFGX1vfRv/JNXKkQdE0qFRcixTqmQazuBGiEq8K0aof+DFTXCr/E/jyMf5GfdqRHe8WqnRuhqeUSKg/sff5XBwaunqQwC2NmRV0+qDA4RV0v/Z9UdudMHfcbbfvpPH775K/d+9amYl75R9tsYFrw6dZ2sQUJq3dGRD77iwtIymfMC2zB7APJbLGfuRMN7fDVibgXWTPQDeGqRsyuwKII12fYp36A2UULNYvhnK7bCemxDRtkqpAj5hf+9tJetI7K/y7BxXv9BuzZ5yrR6pCcyGUKn+63z/QWEWAgJ4WSlYYHMAUDU9jQwPTVHNyovb1H18EEKV8Ger+dONbd2VCCdPh9w3sR+j04qYahCYI4xFuplP6cdBlvt8EgqsTO48CqnO7r8krY++/nKDtuMqdq88qzMkT/oKx2xrLnVuvJVBW/snMWHMRGfDN+hleL06MHrK6dH78ujRFweNl6uOI0eiL3dgwtiECS2WNFnX46DW9lMuMgG+rILuVneOeZCkyTi9tsRTPWLu8a+eKv74i73xdsQxA520FSR48FY7pMl2NRGEmyY9Q5Qr0r1ZbEJxAi/ubYdI/bgXF8aR022PreGEufWsrchHeikuJkzjDbylm6cRfugCQTOfgGJ03hfag2Gaowt4fzWjlUGAFtFMUrBr7b54akBuBn+63DR0gJKlVMvMmFi8ZHWTh2jMlV4pYVwcBTIgbIuwcVzcY3d5wAOKMLq8UGtFaRwR+6n4/Fe2heQUz37sva+D9thiEJA0oqmcN7N7G3oOMoRC3xluvAh4lTdl5m9Xh7V2wBDDlzz0OrDu015WjHqmuqWTCrWwZlBFsACGx1TR1O5eWCgh2QFdsXqFsWUnecfzGgGKTOAbMkSd1BZp58ZA91AlrK2fBYHMRte7ulgKOS5FqwjGCGUQ+FaOev32qfmpFCvGv29Xo6B5KhAI3Ud5jEPMOZzmJ8jZL1Wvv+nvd/fK+ZVCUmLbANxF7gc7vQdDy+Ig+U7Hi68fNG24ujF9kkhqi+WuAGw4qs95/nCfZbNS2eKFnBXzB52pljP3YJOOG7K40JCo4PTcfZ7ffJRKW2hZZoBv3dg/68yAjy8gDs6X/K4lL/xaAvn96/pmVtD4AdE17vCY3lW7a4FYFHGxXNtoUyOjOp5h0KOR39m1miBR+CFb37G5Z9qf+Zi+6RF7nWxSEu0NGnqd6qhX5hRXJ4084voLaWR3w/ap145IqSoad/326dLMYZ932ufmlKgSQKJluXC7RMZJgAvhdEWTsND/ytN+77fPvHphBVg/nSqqd/NDP1uZuZ3MyO/ztjrCgA90chxE79TDfxuZt53M+O+m5n23cywr8Yr4JenmPXtPfztU+bBFlitXWWDtFupS1thkHaZelMN/aIAQnbJvEQrhM9gtHRJP6ukbxEkk2tzB5sKLJRdbJGow01nnlnvRx5sAbtpkTTDQL7R7+9qaq9s5jbmC8sKjAxjnubwd2lR7xWZqpzO5p3R6TsjvMCMCvb5ed0az0ox7RdiUuPQtuuIXC0EVL4os7enbTPRev98jMDJUTBucC9peWauhjyp8U3OpZSFFL6Uviwd8XHJUgmuI6DoNyqfJKTUkcW4M0o+rLgk06bUYf8d7VAKaC3Mapvsm7ZRe9W68fM/+tbF9GORfU6pGCv2RuFhjdgr+uqsaC23Z7xqW7Ifqbh93rV3OHDeplnxNMQZThMgmJELaSw4oqZIj2bX+nu5W4EOUO7LmM5choGiOTE4utmgTWLzox9EN3bN6tgZ1mXLaAkPePkW6MptmQQWHOcZfOg+CnzoPiJ8ANwEMsWMEZbNQ0o7A6MEs5yAu86+cFmqFjTDe9tJumta08GCq/UKGBwYiWczZiA3h1ufgeWQjoUMl9De000dY+I8E6SW5zHcR2JhvYAqEsFInzHSsD+6QZ11fMk8Bfk2Pgvx+j5t48ndE9GkwC9GReCB0UVP8MeHFewXK/wdXoJjgtsuC4wmWo68KhxVqCo3xY02wMV6j0Zfo1wqNXIfmiYEOKPWYE3bgOY3a9yL63jVfoA/qo63D6cXkhuvgI3C00Q19XXZjq6PHOAnDLugqOAKKtfRO/v2WSwhr43+kH0WiyC/XdAXDpC8LY1WA6Ltqsmq1VBXKDW+RmDz9jX7V4P/VKxUVi/rHz7Geyg18FzCIhWjn0wAQuCCrS/vlD0UKIdUz5vTVqh8OdiLeYz73NyrjpvI6J2vr7KfSZxNaqCqMsgyrWZGPsqXx+aSToFMpwAtA+Md59S3z2rkh+xTQK2A1FkjMAIQneVtXGxLS72RDJMh092R7INemWfSAiQq55r2D98LOELe1sZmQfyA+JTlneNAKDQQalZ6irYop9p1fcdAC8qTbiBI56iPOTqjkjpxTjbDABkHh2O73Yp8yBMpHyYSupnZXuaZWZ+0s7KeH43yZZ08WomZQo5Y4kDJuaZb1lwVYoRq0ZNRmuhbaErZQK5Z2TZ1yhs5PmF0jjPpqQN86Sii575dWuckbVZgNkvz8pynbbjKso0WALQF468MYtssb7l9baJkdU0Jv5Oc655CmxXLMrKbPLnfpRuM4CUv5nZiece6CbKlWxBzknsHtQZ5q7qlgxSjBdGzGrU1hx6fntQOmxLb33NC7bBdTjvsZ8cPPi70/FHtMHsAoXJCTdBUY4W8qirmai9UGxiFgovLroc4AL1laKhQbETIkzxSIY+Ps9JLUQlOoWGqhLspqseY9Txyhx9guGAIb0FgwOJjwk3gqYm3pX+cpD4k9vyH+6n2GbjTf3eBTkWzGERtfUXzJpJtcK2yDUaToKutEn3d37I9orqYVPBEoTKZJn4LM8RP7GabmCXw6eBY4ha/tlEMte1udoZmlIbiyiLM02M321ofyna2aGIv26R2dS+b9n25jVZhRluWN9e9bAOom/ZDwfQGxXlCqWCquSnX4tCP2hs3cCuQN+VJmIL7yv1t7Y71IoP1oEExS4E6aaXWkaKFl2x4ZFjMyREnHJl5pdgFIIuIv+MewK8F/wxpVl+aeBkM85YeJAHFcEoxeoDCXUOxqeZo4cbrcEhzR/j7Vj5HorVaPfSSo46irdIVOf966Oe++IfP+b7L9fzLjfGxi/mcqIICVd3V1mgb/EoVVKvCuphbdykZVSzRrx9hkFzgFExwCDS3PuQGzuUtc1SmjRQT9lRDwVf21DwxznZOlqOHzwZKhfV0Hajvs/uIvKV+9MTPep5U4l3uucqHukVjFwNw9mG/kzFIcQyFlg0GskXo5XXT1hm9xcBjjZEpolv3hd/xP3/hL573yR+4qq3DZJpRLxMwkVruDVkqby1C5TDZPCMzJBWnWy5DBSMU1ckzjipxRz+p8uK+tF3wVvSQfRURttYrY+MOLikAb1Cl3Q9O0u4psf1dhnruKHV0s8KeZOLOiOek+CC37gMcvI3qgFfOQLNfUdKtp2NefxAcWJPlGSr870YaNBc4WvwS4qmXAowKDT/T7/Oh9YgmKekLrHZFeb4cIiQ/iajiqMe1PLIZKDKuB6CRpMpO9jqp0PT0vDG9ZLUB8f4TrTr/4Hshuv4uaFaLyS8VACPfu7w8lih7U39S5lxXmbNYt5JTxxgEnDcxgmgiaY7HJc04TFFb1Lz0mNp8wl1jad1RrxD1F6oZQXPdONHRC6/WBYwqvPnThMxJKWSugbGpWaXkOlK4YgGY9bsYyENPyboF6lJLZ6r4ogDQKo39lwQ/cXm2G8q4UG00Fm11FRul9rqYrZPR6luLHH/8Y/8YYoH/VT0yJP2UvGwDEUXFtgUeBvuweH/N5yIEPd8jOfVwiX/wrqZl0CPoRdREVYh/yiS9ortrNO+55/nnIsSb2D28g92jsc9GG56t4UvO8y8pDwjJHzlK9E6vfdf5te+SUHD5+cHlXMu9NVTDv67iLyAKvy7qQUTh10Xd6HEUfl0DoRXtXcB/nHwLkvGb/Zr94k5E4Tf7s+tN1LsQhV8XdVSijlajjiEKv/0NkfBTTcz/evh1DRLrv/gtoyaOyIqaG1DHsemIGZbtv4DMKH0x1MaezvqCZqrOCtjiHBsqYHfZuRjqSa5A3h1q48WOACzDjJVu3an4WokHRhSGgbL3KlnQNgunCJJz9w1VdeH3IU+aPhNtVrXr0m6LCA08haEcArZEks8P60GUIokraeC3eEFJndyxJGj/vdfqqZGv7iPzwMZBU6B6Jqk32H5fOXJDvn7R86Ep4nQwI+O+AmWHqnbp4+GrR9MEKjNYXJGYiNNjaS9SE0q+TzU3M9XKFL1SCrMPV3Uxw1IXM5RXUROALiY/qrqYeClCikd1MZ/JQ1QaaIn6d/+9WcAiPdWOoMQnTdXWZx9B1XJiHW12f+vX/z0oY34srDrQqWq229YijFJi1WGIjdtkV4oCLyPj9FodpUF18+pr8NEC7unACkdwoFTJDI3rl8zoTSYcI9oAqjmrOIfDd13UG7qHNQt7oqsHPs/12FczG4MTZs1IhoW/6UluKkoVdlUNRHQ95Th3+iILe0aUVldYoK7iZaAqlJWDXIkXhSq9ywZAbLq+RuX6GmB9Dewyl5oLWoLzlv+KjChzgTtjvH9QA7kFQEFZlRaXSHGUIkPpxwm7p8QZ5bBQV2YzlJ7iijC8LFcdFWuKjenTqBKkm3yOp5wSy7P1xDqQ0LW8e1wUsKdUgexW1BBXJ7UUw8IZ7JoQBPxGEMCdcnnX4N5GVW9LkQoK8zL3s0NCQmX8ffA19zRwD6e+BvMrEC2j8qj6ljnfyD58I19B/hSRWsDswNXkE54HPQ1gJUYd/lXk45LEAdWnudfT512aGtyJZ9Uz8sB+v2EDd5tP7sHzfs95RhYK1tKGJaIOdU9jTUhbFds3As3xLn5qb7l2xIGWMgL0VUn7rmBt3+xfn339rT95zdOME/zQZlIIueMbBZN+lH0ceVWp4Wg0qJoT4YLZfgHSarxnVHAaJ8gpVrGGw7hrfchHJlTv+npFnBVgjnIfjGOnLsZTqMOGX1G2ZMMGcsfTxiR7YcjAFxbwx1CpEuX2t+VBVR2NgvSGkSv2B+dGr3r/oa4xqO+Yb65yuEL11UNqln0cWbVhWAqs0YW/YEuJn3ClbEgpXE/ZAgrX0w96nrWPkxT+wOgZ8hTfKMxVM4z3kcIp2pJfMQdxxO3EN8tiWlkWHk4W7rkvvemFb5ZlmH6vIwDk/GVF5F9YW+aHB+W9iAIsLrpyqgGE9+EWj/hp5p9l4/gpAmG6V6AZOW2yuZL5ojB7CKnp+33Pn1z4nAss1ecLrYW5fiiUgKEw4ipVFyxs/pHrXt/6wl9VB+9dCFbRCzByos4jbfaFovJPFz/L3ODXoMHC9+iVLqbq+Mn2Mwl5oWJtpMuhVauU7Fl5md0f0UB07fFcezxtTw3tqZ1EY3SLj5KsrDPcBKI/cghRv+758HMl4FKsVqLpO2lTYOlyaHaDlQsAumTp5SG4RRR+E+3HYiXaKUHpzX1YNaKSTl7FRLvWoTE9XNd5U1aiFKEnaUi6xzNGtk7fy5c019PvYqyYIk2AIN34BOSrgkpQjEQhD0tlYgHGQYBvTITwF6E/4+jEvc51vzCbg/pDKT9LH4xFpBtoIHSfswvJDkHAi5Azo0jCV0i8p6mX5R2Jze4BfotQ4cc/eer96TmzT/9+QFuGSxMNCzFoyjhgj9cEWyBb67qKAcQhXqgKuQlXDYeeSBY/8ZRA1mRUrgjNOBpoM1rIqkbsSU/bm6JitZZnpoMBpdJFy5hIL/nlNkxvuWuTUWAuyXckpwhgKbKmZ5FfI7sm0p2y32sOWNR4vhETzyDO4eCsdK0Fnhx65DSDqzO35rMp+DOKpZFoPUV86sFpUCjTT8TsIs1RaGpVZvBenLJRxnGc1NHOZG8UvnyO5gY0u468qdXHi9DSiAFmdB7ur1pbM4Oi/Fdd0qxohUysDuMfq7EXRiW3En63j8vc0tEbP/WT/TxwfVbAh8M78giUVAqJsk9JIf7zixjzQexzwKjX6d/zIx/+h10PXDy8SiZd+mueF7r1xS0uuERN/m0cBXtdvU0XD106KusGi1D1u+h43ykM9VpRYCo/civsGd4KrThYM6RQCx+Pt58mbFs29Iz3PWJPqM21ClQIuX2+m52HIwbu1Cpx9ieAjsjHI3RwXda7eE2txAFTZDvcv0dRrr7vZ++/5JyvwVYfBojpTrTvtlvx7ysXsz/WO5NUr7ZqW0JzCcMv7SBGJUmA/btwTUb50zrK2FfdKYdznHanv+bIgiTyzBFz0rVqghIISDkNfduyl0c/Ro8HYnk+6dfzhl5ztzXKEU1TbUzzgyc5BVV+8KAo/cuk2ihm3CUsU8NXcPvlAbRxt7jdiPD7AC/Hx/SylFrdGCmReI7WydtfMJWg5mW9AseSBJVK8eMwo956i5nbaEavhVG8XszgSGWGUljraFCCP3xJ+BZT0cP5aaaHb/kcHF8c4JtjG/m8mw+qeBHmHnREZG60uLxiEZxGIGUXSzjmlPYrVUKvlCy5vkkamWgdG5goWAZmcEFnAmJdS6KWMfGXEXsoomUbGxBX+iBQa0mBh4pGizWbuExDyW1o5GgTMpsXWPDIm1AdETQFA4WmmDpIK6q05+EaF8v7C6IUOi8bxSItDo+QTwtAjoWN0iwmT64hkKkvruQ9kGWPFqgjZ/8dxILBAyvSLLqyTHi61ZfFn2YZFWxhD6qKjSejI8Olsxx1SwqaMueakpk97bT2mIbMoQFztKA266lGXa7vPG4LSK71yJw37CF+mz9p961xSyXVHvgtDoCiytKnWMBBiBGPmw3zVbNh/kWWsfr9KGzKIW94raUNYUkbDA045NudJr4d0W/yrFmAvp/H1qyLT/zHZoXr+q3KzMF9Wat/UNHAH2s+qb44z7CGilP6LxOSp1dXKVFzPNSmmGbWqHlgQ9UXOtQ5gLtZ7dF1Oo9ESQtKTvwxD7mqZ6CCmFp5E7McUakyjdq6PPtfSvdGJC+w5tnhduFaWnttpCt9v3rsnEETs7LcY3rrLdvYULc5dIPCqvpmWzgVEIuMKbdxjtZRI6nFXKU77Qrn2aYODv/5R1XyBNgbxbweaHIyk6FhMUtzfHa873ve8pfn7r30q/8fuSAvYDPZX0veOTiDWSO/erdViZ+rj7/82gee8v13v5aXrvl1bsm3n/nqvee84+GLqb0+GNyx73/+5eWv+flbPnsxRqE9GKr9IZTqvkPvMm1esfn3w0orhiZ0/8WD9U0v2EYYXHWMXwAUuqAYhH61H+myFzBS67mRj6OAFq/FOj0g4SZvmLtLgWqnwa3KiQs2VK7lHFzDmnrTeCDg2DbvleQmoS/noQ3O3FIcplbJmfEC3hBeFQilLbf8VULNAezlaDtj8nAdVG0/91fVkBJFsov/U5EPx0M4Zh6gB3cMrUxvde96eVf1jL3rA+YAHvKMq/RQhepK9EYsGwd6hHdnnSE8visKTR88CsEsC26gG4GlTu56Bpb+DEX80k9cfs5T3jj/35ipictdWHevXKj1yiurFB/R0nAWycXU1YpbnULFfnSX/2DhNx25gCujgHuGr9Bx8Na1OYk2x4OmX65HFulH6nUI2yCqATKUt94O+iVt03XnQW+qv5CQV5v7OYkQuMcGjtrAXTYw8ISLV+qKYzJlhTQ0RlKOeZZexnr4A95o6G6xCo3JplHLBC0lSqTKzDwFaFgMU0oHrpSiNcSCe8wbUupiETXweKFKcZO3n4AAKZ/Rxtow8BAQnIUVKbwpIdZDUNxhx85mN6A7SqjHFXBmVJLcUZBINWIG2qGdKzDDskrY84AE8EOT8H3bKq05FRCaYYKft6zmnW5LlTl4wNPB0bd7PR0hfTuGt4F9y/jlmH0hfrnXvuzmlwfstRWKn+NWCTDtZoTj7H+r4Ezfsz+TN03LdGVoVnRdzD2dmmhgolMJwyeqrgMtXS1E21iHtIVr42qWRAXzJC/JsNyvYjvVsdxRW3erbQM9fe/iPRngixn18Taqz9RhDdeCf3SyIEdk9RpHlX8UGgprbL8rDXfBVLrYFnVILhYqRsMC46o94CZ0OY2jZ0zMhHZVBuQ6Zuyx8By1pPwPPD822haqCOcMb/sUCIsRqthG7xyr86dA5Wm+irFASsWNPyd55o1iJefCaDRcT5o8OPyFkECxLLtBzXWYkapZ8HIJuJ9dsdidB2NG8Dxj8NhuqnVPbaxLpj/rhXYzJp3SG4WiEMm9KbthNYeky661eWIUihvk52rZusGurAw9FTZR77Cnag0t1OYqX6lrIVLtTUZMKDm1c20t6sbqzD+plBeV+tbFe1IEVSfvZZiCnwEJNhbDYKgY8L/VguU6zouIMr+ojlU2xsH7n/E1+692Q0kzv1b7//V0kdo8Q9mKB6/DRHZ1fm9PL+uaVhU+BaqWN0RToU+pL37F6rcPwcmPBSN2dONR21sQW2R/Ps04lrMq7+xv1Z39rfqk/S2XLqmA+iOuBpopnbXyk8/gE2dj9S+cHS712WDOBOs4My/v2u/Hr5T+7DX8XoSfS9b2s6HaNf6jSFz3oA9alLiViWCqK7kUbZF2Ia4usxSPsKi5Y+5xC6z17N1qAiyvY4SQPa/zc9wCa+yO4H7LC1UttaoiEGtH66g6NEoBxqkB3poUQHb6NVbXDGBUQz2JoOchSGYTOgIsXe1COUEKIEokjr39UgNxdUw9hup9Vb2BqNQbiPCqlmahNxAhwukN4KXgkR3VG/h2nKMf8sxBety/z55SxsgQSp+l+Wi8dks6lX2utOYUb2bN6bP/HhQIvhDLMWo5RQeeO8KpTeHkYllXAX7gNY4Xz1JVll3ATrExgIOfLqCjRk74C38f1aqs2xU4FqqIDVlr7xZwfn5pWGQni6cp3P+rSopFuwlW9Q6j3S0J3iKAQBMockYfvoAxg8Gck8r9N2pwQPsQwd1E2ShAfVg984qgZmXO9f7o4nKDhQOJbm9I4YZaiNxnL9UOq7Zf1rO/larqsMwT9n0Ksdqi5nMBtuN+PSwYrC/QUy2pDdSC6ob7ukLDwu9croh1FXflvpqu0hw8NtIr9OMWb9/Hnnrd979l8LmLh9ovI+v8bX4v2xpyW/XG/AKXZa++RVoihdnfIZcSeoA0ewDvZiWkBKita7bOrRYe/SdAqwR4jP1Q9kX5AniNAYCP8PDAef6eSu/2VnqHMQX8VGBN4WW98/x9UrX2CSXszr5kyowghpOmauv+HvFKsHbqsUmkWBs6rQNN7laSVyeTW5XkrJpMJXTx+4Lsy+YUc+CN6lc4GuWMTE2JBVU7OQWLvx5XsMCBrHW57xQsnj2pYHFRJXnvZHKtkhxOWIlyDXyLV964yP4BjXGeKgK4WpDJZFI4FnikvvNCCoqayeS5TM+0tg6oBsM6QCP9An4Y8lCN3FComQs5DQTV4wDyT/oguDMKwmux3lV25VUXI2U0PDGUvhm40A13YgkDLGbW/COLaGJktcZdVSFuPfu82sXOfgHP4b6/u+Cfv/qMc/7x4oHYkD3izj+th4bbspuQ8whOMyctxQYKAuP/w83QIqp4AqkrfCtNE6Y9EY+a3mh/N+2nV+1ng8b71jhu3xqPoW+R9c2RABsS0g453xx1ZKsDCzxgwVg/wa8rTnxD9xSbHOlrkfSKulAJDqBPk5h6KPKcXcXKQiyGwwrVz8M8QWW+uylyZRFfWMscDDyqbiYoFq34CGz5Ln74KK1ibZDTUTRBytz3+A10D3Qe/iS6EiIOLSCkPtcktKCmeUTs8hBX8lLuBbRb7eL6jypf4w+VcC5MzDWhtjh3jw8U8UbuGXMunREXYj7FGHt3Z2dEIUEvGwxz/qnqwZD3fNn8yqqqWyjyKmYHPU0Ykndk36984Kq7v/jf/4bPwb5L/v2K00MQueY6n3AuH4Dlh++XM0dN3Xvb0fV9KwOP//82XqP5Oo0I0Pyq/WethDyLRJ/jmv0jOOWcwBPbUCAvhdDT8XRXh9G2OBlO4mRIkEKFt02gog+4XNkbadC0inPILI2OTtUc4ntVNUpZjqxUwVpw0P9g9ibrxhW+LZ3fM5jD27COzvTol4Jp5oDuGHZSU6hal9XMRYh+BUceUUXDSrnwSRlMMzCGypQdVqtnIaLEQKJeg/FhxhwIbhxkhOoz2BvRwgQuiULbP1kHjK08MFq0obOBhZ1vEE267po0LGcstEW8OYZpufqIaTmOjdS0HMaa6mr0TQwSyxZNNM6Timjfw5mGp4dc9UlzcxGMzaGksGJsLrLG5lC4sDR3qCI2Ll03sLjJHRhXe0y+0xrfvAVRxQBdKAbo6lZXv06h09XXLRiaq5scEDBq6BYotA+3SQpI/exkX6w4rK2rsktkrYaph1Bneu4d6q32et9rVlDDHdqbM/uvqAl7pWsHiij7Z4nAiFiF3VU4RcWo6049T1SXuaF69U21zQ2xLgp5USHKyi1rRiCR6JTLFlimNh47Y8nET0RCsjd+TcYo+0a69Nd0JxyIcpp4AirVfBE5HuPw8vrtScpT28rNWtdFL7fifK+iQo4eRnjsQX8hMr9aDiuADgcoxG4pexDAwaCObE+Ul09k73AvBPnZPTpQgao55w0tFnKzc8XE8oLmyFOO2TUS04J6m8b0uVrsbNdMUpsrRHwxY01/cHtT1S6f2cg7Y/RDZMcxZRSNUJCOISAO3KpfzT8AMLWMsYl8Djf91Hj6HIZunoekcmypoiAX0eHWzcH1auVi1BEctA7yTmpryqgzxO33in44zdJ8xTJwJsd2c0ieoxkZcoF0EwbN0LQFRv/xni5yY5ZK0RisPsmIRC8q4mrfZeNlCWjRcZW64JW9wsGRXJCXD62qI67AlsACH9gP8qz7wnxZqswj/UbZlKJjbvJm5qPo6soXXepIS1Cm9sx4OS+2YHy7lAFUy4DYMuKzXI3aMxgX8jnaks8EgPiyQHoASA8x2OXLQAAJuM/Z02AdhZH7mNCbUfLv67pX5UUwppnTcaq4e+N4bt86hpZb69EWaZUetnekEe5kqnq8HqPqWG/ajtUjJLZYHq9l+YitpYa3QfWK8JRq76DsyHCyQvR1gbaITcVZnUUr/YgPVXqK8Ks6keYpAL3byu1ZkbWiLraRVnDdPUKo1+eSYXmUc2yRJFqBcZlt+/PtCF2TE8EKAm735tTjUMihgvFzB//txNox5Tb6KXx3/HIKCU+sLltpBxpXRCoKCJkQEcIZh6/gfuyUfkhMcQqdAvMVp5Jktq+ncfu2cfvMJclZSrRAsQl3tci0NHyFHAnOcj8S4GYRSb5Y0i6XfBreK/nmKTJHCUAxmPPZxXHJWNzpSi2htACBhOzQ5ui0/BSVp8iV+lPo9KqpK37fxe8UI9HGzomlGSWqKEz9FYA00an5KQQMttqG2+xVE8KgFFQAGNpZ7QqXqf3V3vCrWu+RLubVDp1U49FYHjbX/Efc8pS257j1x2jzXNnv97gvoYxR5BrvRg5xrhMy9qOd6FXGMJQxjMtyLudyzMhWy+H1YaKcb9wxXlEGYAd2jztoJ6wa76Qt1rn1Cga+wTBYOiCzb15t11NPzbWg21zeqqrWiNZrxcQAbCKqLiV/ofNQ1Hkprtod6ciFJxhbUtvSNMd1AzZrsrCB6ujpsm3qEt6WqDRmuYA2tmkBvN3CiPSpVfrBbpEeCYwkp2VyOpGssDM8CCUHDPNBzI8wlUU83CvjJv6cjKKwJGt45yVfOhyNai5FNIehSAztXDOMgVZTqSGV4nLu/wbYgardgkXwhlcA/jbOcQo01+NVnte0RecvOu/SDKrM48qQoGVipahTXcMzs35XibxbvzFIJcmnGZrH6fViJXnR8hZ6+VvZvnk09yppMy7EbdyRvUEW+xW7qINxyElRnlFs3l4N3GIpzjwgwXOMkxACwV/gv62QS8n6gvUCe4MtGMkeNjlys298UVE0XiUWQe/EoqFw3B6ATuygFUXtbbQznyn13ufxxbZygjIAcBA8z6M9o6Mr6yJ13KX0MXZgDvACKgNgswBYdcJRD3E9mXbFDo3TBso8oJU8lmbMohlzFK1JF/Gc1e1ORLMTC3Gxli/QVpS4lcjOji0lkm+ZNgcACU0OkXzV9DlwVmUO5DkU4fGFQdQcQzFn8XWmgq9TEXVmKqLOfR0QdQ6IOjeGqEpLqoiqXQilHyOIOquIWhgMnXUYCqayKDF0BxUGQ1f6jJT8RxZDwfMsoPCF42OoDvRWWl3LtytAtxjOZgvtpFmLodu/bhi6UsHQWYOhO4ChOxG3U+O0gaodP5vPSTN26DkG+gc1wx0WPVekJpQxUtMqYlaJUCpRUdLwEksXpmFpXibnE8nT95i1/kWyx9QryLrTNGdFOjI7uVh8UghtwAE7wxdFqa8Tnp/9Og8tMJp2iorHvJuR25hszIhbkvl+B0vZmtB2CxaKAPTRzSDMfEVVSCTUw3Z8HgvvfGWJU4DsVPHGTnR2Z3VKoiC7BW83cPauf5FoFXrTHJThRPV5uk1TOJ0LQWlde8vTtlHddcOzft7E4wV5qobVG8c5lGyyP4eKTSHznYuR7XVVXCsHbPlM6ZZ5ZkOYnyKrCCTzWWnRzKgQF/5aRoW4Vd0ngH0O3jv5p9K+NnVEiDun1eVtdKlCUahjhbid4wtxsflj55tOiNum9qZC3A4LcdspZW63VgpvhzSrH+r5wWBA2bjb6iPYulU2ibv3Qoo72esayG5WxvMFL+8k4JGNwGMO8Kj60sksPLLjwyOj7OThkTE85ioy5A5ZtiY5OkSj2hMiZcAvpQBKzGARN0dBPYUbQbGYD4KA4lnlLACBEWRiNq4C0kcMuPa/GuDaFcB5ZtZk1dOA9pGpELQNVeO5g4JxBXhE/KQ5exrgTZ4GeJThHGL8NIDBAbhc2Rtp0NSha/EUg9bkkEf9OKTAnam1KaocqWXkVw5JMX+rmJNRxza+Pdn4jNrc+PZmx2uboloNfRswnRSCV6pJG73uRtUemTjnRUI0oLqNzzi+6fpA0RA23LjAq8EtlbpcF+1XMTxMIdRA9yv9lptYKorHjSal0y8qmEC2S32WIXeP02YoPrDfxZ+j8W1nma2KuuXdGW7PAG/6T6vYc2kP54HzFDrtC2UDRtuMQOtFsi2semu8N/SiyoG4r1/oMUx1qK2H/iKyx2lVch/rQcbEmZ33KM7swskzu7AyS0M7S8Pjz1Ju7Mmf2YVyZkfRVHIfkz9C7qNJch+qz81NyL1fOZbWTI7cnxgeURUeeu4UVeARWXhEx4dHRNHJwyPCJYARH7ZBldxPPUH0Uz1Zq6gpvOfi4fNH1EL+ZVO1EKScUC0EmU5aLeRfTlIt5Gbfa0wq1ug8SAprdY6ng3p3Egm9PUgzpqdi5EgIF8JxrgYrivxXnqsF1XO1ujtXSyhE9+LyErWrLOLK9pty84a9FxNDOqn8uQ8ne6LM5suBZKHHjtaJa0NMsFKEDPII8ZA0c1yGlltF0ikHZN8rBjk2t/nnDG/hkNqcB4Z6HhgJKkfurNSdBVZs/h321H+vb3y5BOJnU19yUXVAA2tVF4yqh1QRdXvGC6rkVcwhz/kRVMVtl79ieS7EY+S+TZB+i3TN2DxS3U45D7SiI6hZSYUuYnUsIv1wEICZD6bQ1CKYpmmEpofoqXeg8Ji9f+SUFHvFGJQjnko5YkdJ/5UoxzTth+hRaD/AkqNF+/i42g/RNO2HGNPh5LQfqrTr+elfNeOGWui9dsxGb1T14nT/mE+mTzufTJokk+c+BM0eN+5LHut/iyXP6mvJHpuqXYp2mSGva00PjtX0BVfTg66mL0tNmCTcb9yKw6Z3lzZLz1oTuUgRws5UiD1yS65AVLcjMxRAp8AIb5LTAzo/IISMJmamYb1XA458l3/YLzIVIWSUrpm0BB4PRAG/j8ZiC/qw0ONZmoE4jQdlpjQBTmLLvEFtHGt3MCM740dhM+iWZ5rd7uspbpA3q1DTzlbgS5mKXZqp0vIWxqBD0RR95jmxqh0RnmSemXnK8ODm1HNRR3VvPIsLMEmeAGi4UJanYAAVdGxpg3sGiTo63cBjHhKoq0QLKwHJTtRbsrP1nkosdXBNCsIfriFF1ZRyDB774diWUrWSixptsfx3VS+fLVUEAMQGlyJyRpEcwdW6axvAPUt1+fzKog4P6/OI0DKqbUPL8wUAEA6mAD56jMBq/isCq/lvAKxFigmmDQRoC5QRmPHs12FFJ/uqTgLHwy/S7JFigRbKGD5qn10vN1Y0u+8//f2DH97+op/2uMnzAC7m3P1+KTZ0howgzRQou20Z99Wd4Yu4k+YHZQzNH1kH0EQqRrOjG46gVrv66czribevu/3nKyFOVB2pafAB7V+g2b6XfQ0d47qRh1/FfI7s/rH8qw8D6zMeor9y+3Fm3BOD6PVr6+w7z5La0N0QCqdtY9S7vwcf0cxQXXENjwDxGDLXuKYUlRogFE3RxSnSaUUIWrSMDFE6x9QILTN35NO8Y8jMjJEqHoA8cU4ljSz0y9Fx/1LVsuC/ZbGl00U5zpXOHC3Bb42ciCwK/LessZDZz0Pk5b8eV9DNVynkL31alVZtpRXq9RMRGKO0fDvXRpBMy0q/jVbhn6QI9X5leDjkSLwQvxzUFz0UfyCQFz0tvzegrVoBHD/kudHk3w4mdJVW5WgypxjGaIz/hEnHCYrmfU8FwNdIL4jaORciEmcw1T3qws1BSLNy21Nwq8tB7ftWvO3Pt/GH27njJD2CN6nta4+yUz7RRKcAtUfeLyK0n2g70HW7OTynDi3LqGyvAMxVIMWvAm8Q0sPi8WKXUOwSLSjEEvE6t6AQ6zCeqF8efsxQhu8y3dZL5S2YUSmsHv626rYSvC0VO2jHcF0OxbY6UnuKXoju8lFF3ha5MRCVtANcWLuNU2hcPTxSnEqnDvPT3Lc7qCt41pK1tti+RjvpNNqB3NmRYhftYppw+qgWC5dIol7AmU/lDCXJotPp9PLlyt46Pjdf0tGhEwFa00qyhdjhorkxqyDOqwKLUyoJp5hjMqfh0KS6tFf88oZySKMlrnJXtqPgFojzDtkj7KjoKWoNui9EQQ3oN8rnhX6XICJHQcVJlKBHTl3L0J0F/W5gf4P5F6UNhDki+Iigr5HwgqKRCIrTIk1foLT/grXiDOqie3xmeCa2W88CH3fZi/Oz1ML82ZzaPZBvoVkY2Q/hauccMTaQPwGLLKe+kg8ngASZDG2CsnbrbMvyJ+p0yp9EMRVkomtFjpnn25lXPBlzj7swRVHnXMxETiIEjiGAb48igK/ucl+5f1r+wGY+7IGEMszOAi1+Ij0R6jpPoSfRkxA4j87mZfVMnijnMAV+Qj6v9FYA5iwEpDhtVJaPD6OFOK1aYrCKGa0ub3KZ+dsRq0EmVTqMhGG8Vydth0nVHBPgGRF7ZhAyYP7QNi1TyQkKPa8kBmSIC61qPbQdEc61D+rEF08h4oDNPJltFe3BnSPCWGp7pO6trj9atbbj6103bQVC8VzDYxu1gUztPsQfMmHaxl0JLf6bgWab1pqTVAj9AkOst5ZEOs/5Y8KrlimVUl5dBch0ltBZwoNoG8gMK66pLzL1sSRzk8EQwf9TTrbH+Er7CyitUFuRUVemJ8ui+SS7QqElxn9UTtvcukRPliaP9xorx3agMz0xzyEjo+1oqprG08aBCynbtsQzAEHfNM8z/s9ADvk58JSn2ArQ8UcKoCfTqvGNaqcFfyzv59K5aAqah1Yp6LablXVFtfnGFtataHKb63rA0zYcM224S9uAW5nSJc4InJJ1EqO6ZJFuEezCInXw6NAcHnPKQ8yThzWZjWCJSE6u1TI1LJVilxks4muDlvNV8KQT5ASAmk6RlPEQ0mcCynDkymxUSEwbI6r4FnJwuywLbVo16Ux8S2qTAZYKNoCFmP9bFQYIlhZIVHI40M1XLKWhlXyJywqLFRSl3JJWtarYJlWSVHkerVrkYf0C5DdTLBzDopCeIlkzZNXkrEzOlKEDRhA89nHTuCdc61ZBNFoab0hoGrJ6nIb0X/B4tGUVYHJtWQH5CR35gWT0JOHTNs1KHn8Qae2ktduJ5eZ6lQhtPQkitE15RUwNP9/KNZH0U11PjtWlcz7nT/IVMQwTbkp1tlWoDp2A6oDMjFEepToriAP+rtBCpX1dZP+/ihAp+y6kJg/54fMowiEeeVa7cpU8RsNNaYmjHAikJW0oiGZHCASZfJklVecqqQLNmsm3K1kg5gFlA8f4Cw870BjlKvLzJEB5jidXlZ8vgYzhOCNkiaFGuSi3WszfQ+fpQBfnSbxEXkC5RnJJT+H/noykPXS+yXk+Xi/gWHnlwsFmYiXCfNyu3C/FnF27K5xfxk/bv/MEIIDadpUlPEWbiWKJG5AUtgNagy3nXO2ezkjtss3AwdENn5tlOjlOPNNSqRufjFI1xV/deWPTx+MROrZkdYxuKGEAYvuKTMTT5UnU5HLqeagEQgskMxu2Hmc2uJnwxLGZ4JCdxjeyHLdVcj6ZIa9z5Ilmjig1aZvmkZkLW48zF3QepBTJbkC9LOvOVl8O4yWDZjZEcI1LjY+whhpvC17aD16c9yilrlkJcx+F6jZEhCYrlpUiWCrClLA7+qN+Za9/zL4QsMG+7MbI+49yBY8YGjGELM6HpOCJQAcBBTfl00UE/jQ5A+VTcs7KokVQXpUlPaWw2D4uqXBoqhhnG2BLno5yk5WlRG7BnWjfZOGo9ORL356TTnN7fGoPJFPM28e5L49hRmsBDI0qEHTCuRHerFG2+ONCYqt6GffFEIW+DPBC5uUwXjLzchAvapWNZ9826j0rDzEXsT0IzTG2sRBUrOJxSQFbPZNonefgYpkUQLihy/EU3H9ynnNvc93M85Ke4lkwEQAl+CdQBKXtamrQnr6syrJG22VJq4iB1Iuo7ugMlHdg/lU1/3dU+INyVwIwG7OR/El6keddW1pfCim4Q7zwDYYUQaR0xR1DcazgFZzoDmqH2fUiQH4nrh97rwBsvuDrMXNjjeose0EU0wB+i83b/XgrGpVzy3U9SahT3QnJewW+VvyVz+7z8Tvg0g+INUcfZobX5O5m7VvwCdXVbNy7YZxYYv5Lb49fHm3jiDivOfv2afovgR84ZxZ3OduIVkvz09aXBeCSvQo9bXti8BGOdq2/C7lzXDs9OOTzERyCPJwPKt3Vl/uFIiO7HMJFelE8UgvQ7hwOTeyypsDtGAJI72F86BbzUkP+A3pV9maOQxMIfbvZX4ODCzRajQXd6Wc3oKXOCP2NeGW6XzYX7cAzzP4ZMnhtj0jwcYJAPsybcLH/gsRCy/gNVIEPP+6pf7yamuASY2f88iNId1W+GlUizfkEcfVpC0KerEnpH8QoovxVqW9Ie3GuHOtQ68gf2BgOccPmttaBDdFv1RG6xnkbmRwrfX2NOeXgQTYID8tP11IgWrRFjMcVw6LOyI7g84YDfIbg1RwMpbnGICTFFZW1eunCZFhRTyvDg4vYEumqbdNr0QgTPoRw32NHasF1E85UnOeS1+kn4rhBNVjUD0Ie6D32sOIfBXMWfm3x4QE4KX5OeqwRis8dZ9z4Aa9yhxp2Yr7g6cn1vcPy5ProHQgabzp9sRl1eCBRm1gKHWiqmgathI8irAfhN5fB4B4NjvjSOVb56v5K+EENwyDa7TbIrTlSBu91sYck9hZNE8c7evKuXUu1mw+4bkq77sO7ZpMkLeoLlS8Or498ERxa3wQUaK4rTT5zc/p+z85phvl95oXHspzT92ociKM3cWBYsIWuP+MMqB/mOwGP38dzw1MicK+nRKBCie7yqqRo4FVp0WHv+MToFtgclM5ubh72ZcYE7AvM83nG1tavX5w7q7Vq45ZrGO1ZXi8Nc+UxgFQXm/oUq++eos4KQJcjet8b/+ZXBv/0m4Onf/+FtWdTsPkywP4ckQxLYjDp/vsex1wkwT9DcI8EjyF4LoI4BoIVMQS/gNhdEtxAcKcE70WQEFSzZKsSvAefdZVM5rHWmLlPF1yNLVdj4j4FnxswQoj9guz1mN15ovZqURyTm7yOx8vyRnUpZVKfuKWU32B9oHEEV4Uohg9VBTCSCt+tq/V18o2r1eq6Guu6GpzNOKV0uUpjDUYwjwNvhqqZc4Zfe+/w3VhLfSyifsWjmSLSg77KdvCFEDgFm5IS7Ty6teGh4C942RvQc2O0WL83G3Wkf0+hC4mx8Qhr+OVFjE8khqIFJ6Roh3+2nLgPrE9QtKNvPR5FO6aphPC9lfADCCvl+IgGZZb89CRFOyhx+tUtlfCdGsYM/ihKQJBbo7FC3FxwQ4J3a0SVoqFrlj4NXDeV0uJds0mSFnV75Yujo18EG/I+naLd6UrDZ/++KJqwgcDsigqfo3Iw3jlO12JH1+oAVax0ra50DVTtBEQMc0ih8ez/8+jZTULPYjKGNJ8HPS9FIPhgRkBIXFFXilckpMTuCDh/Stg+f2zowxtRUoW0jJIVzOepZOWHj09W1N3vYyQrh36hnD33/+wEWdm483hk5W5NVavqlfD9Gsb0fV8ZDA7+3CRZebDy1WFJ1/BAw0Ccj9zpCIjEKnfkgndJ8KhGVMkKumaJxC0IV8jKTfKObJqkRd1c+WJj9IvgLnmfTlYGrjR89k2y8k2ysjlZ+ZEpZEUQCIG3IXCyZOXwcckK5vNUsvKjj5as3BKzgCEq/VWOk5RrzVS7o5w4B2/jYPYm1Lci00MT3fR4WWV2vGRyclw9MjcKf2x2hBfW/odD/OdV8f6SKtrvOT7W7+X2wGKteIU8/CqB2R6eV2i2TofdimxPQKGASG1NvXNawVH1+k9vaNC4iJ0bTpgiRqHmczdpYyMo+GPkIfXRtMfdYilia77oInJBaKd2FQ33CpY9gWH1nRL6O+Db5cYPFIyuIvQQIi+RYMahfQihFTpZ0HdMllH8TsrsLVdwWBZco1g7FGQ3Cz7X+/z5YYx3HiN4UIIJgock2EDXdudNsxHwq+I0vDXFACa2AI0re7oXaG6+F4g33wsAi68qfGPIK8So3oIW4O0F+LlKlDFjFbJtSmZQzLXZj5spFvC3E3y8u1D909GoGet7ndOlyvwEBfKcY99ARBH+ppR24Fv/JDZwlAPCFBvqd7s8uZBAn/dqenAPniMCCVvC/TbwoPn0ED69JXDOfSX2fZ5W9C59wlswPsMK4Sbc4ZGV5uDISnP18afcyywJgExwtyUCsRBnJQKxEgEl0mpNgp+73MyJQLOdYJEm5Yqr2vZMYdXSniXjjqFQKJmh0WkhdutMpYDSuyThFvxmPzFGctXsmtpe1q/LknYJ1b2CfENw1cbaBME9SyEUGbTSyFu8Em682fGqVgs0w7uqGTZGMmgDrL9j9KN0pnS37+O+/7hBSL0J90m1J5nd8lp+QhyM5ovT2m4RDSlcL+LyniG/vRnL0aCoX2kt669nP4Y7LbdnP4HHsEg4Mh5Ssk71irXXASQkNZ61Z3/L6uc/c94Ku7gpZzCinQdH981DAStYn+cD7pF6T0FrQjJ1h5N1x3INk+LxukPUHdq6L+bmu7rrm9fd95X4ueurv+vHar5QbSf4e50niOxWALAIiG9ZeaA3WRGCVEW4raq37FilfxfDhx+076Gf++IfPuf7Lmda30CiZG0iqQtXQKCBkP+DKCK5haWlXB9Kq8xISvgySm/IxVxljLKAnGLQbG5ywSt7my4toKE4DIOOOpqxm6u3RYaYbHW0Zj27GZB+80NMltlbP/HfJb2ihfnVovq34SJ3TBHGp4WjtSx7I8xAAsvUeTX52Q8jRlyEfj7wIyfTPcb3nRJnBfLLnBf0uDTcGMKxC95SSgwbsdPcD0ADSMNcsSME4ucTDnuqUz+jBIac+JOWhoQ6gDAlmLshJSADDeLPIL+Os9++0dilr8r/1LTmt3zta9d9TV1nPGRXkyb5B3AFY2RVyW4DcqygQffC28uInYC2Om2TWwAOL+HKAj8Z7qXBPm1niGd2R5Hx/EJK944ihoXBgRjEII4eUMojV55xxRxTsaNzhNrrXF1M/MeYkL1ZZrycTRwMlE2nWOp1FzKkQPzs4cvgZtWWrq+bYy3gdU3RRJ2FVChSwoN6MjPnHx/ZzPnmzPk/8pzy5iiK9JrjK/7VJ31STvqwnPS1yQlvZ3ve0imdh9r3fEaBkXcoUd4imSoQqJFSkhbaVM/+CXhtCQL3JEFPAnP7MhF/PoomHWoeoBmFsD+xbaZA9Ap8oTaYoQr2jDKJAdjdBWOVbNcB9rpY7QM0cEvLhOCPBS/G/4ubrSegTXMEG7EtEKVWhSjNW6K0AKLUMkRpHkQJd79owRClF2xClObGidKDI0SpaYhSa4IoXS2lOqIk4HJ0qVX6kWgZPxKPgi798KFHRJe+SZd+2IMno8ebKpEPhTFA5kbZj1D9RHu4RDdw6afCUEnONzzBCQ3BaT06ghMqwflf6DWlAq4U4BKSI6SmyrsEjnfBxdFOybP4BxR+dYWfkoxMiVWt8MSGn/EOddKEY5YbmE1yM3OWcMxXuZk5EA5xgD9/AsIxO044/uw1VcLhO27mBIQjeDTczN8zor+cU3e5bb1Ikmmq9yrVoqkRnsjoQQKmr4c8E7jFBLDnFlH1tSRy8Bs9LflB87xbk+Eoc1SmvmEyPGALOmYCGBz4TJWmetLUZ1zPX2UsH8A6fU+AlJs0RRsVmcCDoQncz4H0i74XTnoVMKogb3nNNDd3ocByxJte6LzphZPe9Fy6pIJxeAQVgPuAH73sDmRWx3IR8Qjqq7hRgnF0e8jrKyHE1IBkncWg8nufh9/nre03ThPDisc8Hx7zuuIVxnrMU7SJ8Sg95sUTHvO4Q9kfqcc89WmI7NiZcotGPOZV95tf9cW8R+PakXXpJ18zui61KutSKYQr6qUQDiuUypAri1RdVjB81yhleHaBKhq4lsjPVNajzZeq0CxVdbOu1CsWP7Adr2Nu6kKks7+VtxFIioYYU0jIfInFBotc4hY5F+QiEjQ4LVe3obQULWxDxgoDWJwjKdMpqSyEsDmY2GUMHcSjTS1+TC5oIYWVBe0rng9+1SA9ubUjwQivquT7zjtGD5lux7vKvTVJ5uVbEUz7SERtb0MdEFJKRN6wnvIaal8F6EK+5a8jav7XniouJHqFM1wDXwguLzDGIRtyVgGc8lXVSm7P6y4XCw4OLBDqCjZyGSIO9QB2toST3aIE3/lr+FQU62Gi2peprJ/N4zjqS5lYwCcfnl1qMiZDyCQOG7Njxklac5cP28saYpSQqaJraLOyhuJ7askauqAhnL/IZfkaZm4fgyg1wBpD9keyTe/AOFldPuuTvZx/4lK5nCOcDnABr9C6JseF6r6PfK0n5kfCfiCkpgyIByYpoLpILs3qmxjYQ7GNvwMkwr3muds8yTyzMWN3fXHFGee8hxKjFXWYb0VI66+DmgX8wKxVp/nFLANhVu1W1MWPplUdVtfNAc1ILPlit6IpYE5RF81wDB77xe7qDBZMrbQsltpsBKKNcjmloi3DrZdph0blkbTVtTAQR/+BFHJlEcDG7CwitKRqC2vSA5xpgFS2hNuAtb7sfwOQVVfTBGfJMOV3h3AWA9lpXE0tWcgvEITzwCMgFbFXOCKEdAZ7Ze0+GPrg9XFK5Wy34BkqmwdURHH3eFooYlvWAEX2XrTNWbzwHZENHOkVzeMrxRSY9UBV0lh1oxVQiPSK5Y2gankj0PWty+RVdJtAHUYta3ARjhviMtfVqJA/1apGJ9UTo6mJMKglJjeMnxk1CeSVEGll7xPWSjsD27CaD/RtOiRCB4mIIukpw8NBIDyiEDoBBKowwDIbqE2pxwKIPABVf7HnVZzxhM7yh7peZNaIvBfhIj15cOgM21xdtBfUgRuuxBQhJabAvjWeHPwR6BKo6R8LKQgdNX2r7/nT3ClSzfoL9fCdes1B7I1TYx+sTYv9wtTYe6fGfnxq7N1TYy+aFrnbRd7mWLKdstlWp5u7qpttM4iV5NVqsjMGx6nphQwka71sxBNk9lOoShM0VQ3DePuNM8j0bM8b/bSmnxp+zEPu2qPM/TxtlnXGq2wgRDWB6ECUXs0hfFETd1W5ik/et+aB+YJ0uVYnvukNHkouXSEHyrGCp5SSAzTDz45YPXjlQ4GJ2VDhYb4rnRkH8opOcIMCzI2qM2O8cCXhqDPjixgWvD0wTn35ePPL6hJUjwL1+INb8VYhAj4q2cx18fprHrnr4v8HtTujdegQVgf5GC9orDpz8/jn+/Qlw0tmXrp46crL2TXCJoKeJTTg/zy3yF9OAliCm6JMD9ipdTSESutoGhZJQF8oNAQMXvbzMlbYvt4p5iMxwbG987Gh1anuo4sJtn9wrMbPj/KzjnR+Iv5d/GwoguMcJFgDfJo695roSFPQFGOLBS61S65xNIRNmNAMn8qki8eSgO0oTfERWjKMfgneCDp3gkFv86T+7DPuSsFIWvYLSoRkqAoTjSEGsnHQEKC9RQuPfUVbWy1lFDPw/qifFBHN4DNYbXFdyVPieLkGxc/cE2f9EVwNiWQSzWV464lpKtyOB2Yd/l+oSUFP+SXASEsByBvaobfJDG4BBC1q207vy9vS3LyFhrfokTT34q9Lc5PNmpsagYlC9qxvAMjWjwfZs/K2NPcbB7LxppClGlQK+kJXs7dgrqBtV+ntmRdwC3yIgBJccIL3U/JQJDMbWqA6LfBVnadUz7tOE99utMCyUffQjuo799BTYrFO6KI4U1M30HeKllf621P5G4XpfV5l9b/fG13+hQI5luLXVFIDejQ19ujU2HdNjb1zGgsFwE6JvW9q7D21qS2bGnt0agnnTsu6ayJndTgAKQfnYRQHvA2P5YTCu3bqwoB1E6tj9ouyAEPnEJEhIjONzEPVg7l8qtpRJE7PA8JzNwVYamqqWYflJRGH7xruQslHlMHUCLd4ajNyUzGFVUeMWV4TiWnglselLIWBuWV1EdE0rpCaaiZRSAge7e/NU0zN72t71nCuMZrYzGeoKZ+o2y69O3Ig+yWl/q5S2SiIrXRuCXOwaiSd0r73A3lqZWim3YUR3TV1vWiiudhxW2+a0kEwa8lzXyyi7xmxvkAxAD5DNXPYgN/sLnNVUAwJa/kXTZ3ovrAr0lbnzqtFraG0hZpmc9/mjVnnDt682gXDLqeAjzN5hm1x1eQZStrE5BnooysIg5AAnOrV042jjNmMmoNTw+4OuEjTlAoBCdIPeqH1K2I8zPrCcKECLzDvnlhlhnhXbDbr4h8LmYT08vv0Ku/V/IV6VvX1yqrvmE3ZxXpyP1oq0JLqwqPUSUWg34toitBbrZ4iKBuHwlcbi5CuVGThgh93z7163AOOpuq591dfc3zPvR8N/IzVtJRoHvNUevBRTzhWBDewNtVECSzeL4a/+x7VsUPNeWwZC/MG2oAkwWA5+1PDB7rMaXnU5qzFDPg5g37i9dkTNatYheOBs0fpPoVW4PhXKiln0LYMi2hcsbTVM25GbTxmcca9JrMTwBBOW9bdOeInC1qqrcnnSaKPjlaXLyB6ohXFokZ/dLSQYil7h9C9ZVogG+YQLZrwEs2X4UUKReg/i485D39zZECLR0RsrYNIHWrALlRijIsqIrUQ2aIUWax5LMPOpq8LIlh0jjEpppyaVC2d460Fvv2XlVQDzSumF2W25LFSaPKP3Kq2xgOdyFX/AKMOvpxcKzDsc+Di5KTEMs9KrmNF97qgm3pHjnnyON/JtZKoV90Op66dLbFBFMt8TISJQnONp6OGWkcQ0/mFGuGAbBKyR2BTdGUx08s5mdrCNbVphsVGauRF64xTiE1BbfV4peU6jkEA9FPyzGaiuqJ+wvPCyS2Vc4adaM8CzBwIRT31JQ83AL4VhEmiLErZO3Wbi9iqo2n+Po/szi7Cdk9N5yvlkA2cn5yv+WWvZgzkYyPW0n1lIg+3y/Sydyl7RX7VZv6vIPJfi2q9+wRU62YGbtX6PLbGwyIQJ/aDO/IQJbuBgkAQ0aM+eK5UkAXrgMb6EaqtC60fNTZcq2jbI99guO5iAnzOMUeGuvV/DuQSm3oT2JA+6WEJ4kEQJdGHHAMe1ghwNPvyWvp8lDb1DpBv0EhNEgJo5WR+j6AJBAmIDKUWMH7y4uMFgsWklIqkT5VajBBa8Y6J+bXX7OdcVliFVmpSywm/+NsOywavZ149+5qeXf2c79VPzsuEeGZ3XibCipcJr+Jnwhv3MyE3DNTPBPrjJkaEGgKKFZ0wLuYcJUKtrupYZkxoZ0xIsZkxSAbB8PFFS31OSKF1QT2dPT6FWnoMkEYye/QRygNpZvYo0avLhJqcRt8E1cmDqq9iU0MfmRM0CYr1icP6CteGh8X9JC1qo99f/yr9HhlUfvYIZbP/MtfyzN4oguiM/0IJO4so85VjW9Vrb1wQHJ4nAMEdV+Og6NA83DcN9Wgagnlw89nHxYh6iiTnGok8CAuMNY2ilX0KmSgWJvQqbi+yR9knEJu3Uuic3NkUd66hcWN5+t4hNde5Tk9vRLTJw2WTGTyuKjr7iwyM+Kw7xRRcuyniax9cjNys9OT8sbEOjRlu/csgceDmr6vTvi7st0O951nFAgAIFiefofm8Q7NwtUkdiDSM7xKY0FfD0In4agUXsehuxq/SPGVraNWM2ipm5/f4hgNCLRMVduJ8+RCoZibBgwi2ENSDi5CDNV3l5ijJ3j9yzJcvmbsjUTGjPeXq+q0X0uxzDTgtkCOaqygQVp3Gz5X6DeSCV/XWsck85JWurJ7GB0FLWldu6oJz85oRqtCSagN1VBCUUAPfH/SwGxOYNzHOmfMwz/FXa9/nuZcHJHgYwRc4MFwlwQcsGBKVONT6/KKzIfuAMH8zqlqQuEJCV3Q1+wcleweHNwEYH4gVgK7aVrQwoQ6/AKnr2VHkVrTBVL0/ZGumPNh1tpZ2TdHlwXj79SMZvswZtpBL6Ir+WCg6c2HpIKcrbmJ3+Wj2srpr6BrU6jBiuWV/1CfOjKDdaJwinkVDh3/kyUbBz2dAOERA15Hdn/YTv4fn1/fdMqs1DfOIOF34RX6K72mUyiznorCc8K/JMbFhOWM4BkF9YDkXKe4VHalVte74cfvnrz9692u/8uZXAjVK8ByMYDd9RisqfMKgZx8SGCvqLhpUXtHThi7P8A1nTkdsUg3zHiUiqVilBAKVraKdIeb4PNkVLTKpA2sSy8aqjth3SWyI2HnEqtN+DgjhwJ5Joovt3CQ20Q05ELZGsUTOc0xBawVwwx67fpU33ioU4dpvmV8jC/EZ2m43ekw0TFDBTcu0Jfuw9DaG05Y75wGrWDy13DIvSm6ZIEUKZD49yDgZIWNyr6Zkybbw5BvUeRwatM02CCFtUKANqtsGdR4ZmOquVZ1H26qttlUIjbRqvgKmmZNpUOxgE2/eoBnXoJlKg1K4ZteWIFQ5W+pUfYgmVa/NLReMXLABw++l2f6KW1RWlOoVqpYi+/QhNm8Nfs/wPsgbFNHSrdjKzlGg69MAPooxNWQm8zLUD61Uv0uLZtNPc7Kc1spxcXOIP1AdX4UGeqCzRSdTEY8lB5QqwIqQPEAx+3UA7Y5h9hEjO0hJ7sQOCSvv4A7e75ikOQgy7wlyNUIW5DnVlNZTN/sN5Ki6fKQe5dBluZWWaK5CI5E0R0tHXAyqc84ah/xfEYHBgLLeYMAdh2RI1OoQi/uzCdO0FtNQ9RBsFjeo8oIXaAPt3BDqXUaBdYFCpdgigoqPIcuzoMezShmZobJ7v5+NIsN8vdwrNcSiyv3Css0TgVr2AVV8VsNpeaQ3L4vY3ZPF7u15U+XVdXPVG889eqH2Ls+8H7WBYzZwr7vVKldC3ydP/sTX50FzffZBb+z67AMm452+KemQDdyCTzcqKrWBVak9FOIafuhUak2rIhO4ywYGCIQVb6AR36207wf3kgte2XML6UPY1muPE1NQhtcLa7vUBx6JcL56pz2xd9r14jZ7UyZPD9GBqggCVH7fy95rsg2itdxIhc41O87y9vOZwSVq62lPHuGxN9fb4R+JwN9rdW/WcgCiSuztZezbXCwOQCS2Nh7TPxiuZbfqriQ211q1TZfLjkC/+c4RFe2AsW+tZPVDMtpHR9JjYTALRJ0UxJXS1tBIWyMnbY2NtLUuO7+k71Ei0taGyPzzJmpAkpO0QjtxTNo6g7W6M03aGlNdpa0htcQVfjQmbQ2nS1uhnLemifmcOr4m+L8CO4/HHM1SVpW2JhDKIiBZlJjZKypGhypSfJpT7YcZINls/6bI2K74Tf1C3BLpjnROiOw88fPoaEPhXWpISAH57YynDPh3Fi+L8OUESqWnJsKfSKEsmZ3o/aikCDkA2s6mOWaxMswhqZhD2RkgOMc/1vVLiJOIDN5uMmqYO9pKKNuIbFMLWVrWzXo6LlVMf8+6GRWBqtJ2vIhLv0mXo8gVTOTa3P3o1A9OyhUpPgzHPjwJt6R/OVW5XyuTQqFj+1soFcrmVjf7i6Why2SvrW1dL6gN8A6Vzgo0QnSOQ5CTBig6LMLRwqHVfKLi47HiPYJByQhAjCg0tfgt9C/MQ1FTAMBiC7CAYgVZEY9VHkE8feIGRKMNKCLoN4Ld4gAqGoXuuDB6KY3MuYAnzwBPR5p27y8aNjNxm63I0DEDb34oADCbqr/TFRsaB4q0TxxnZQX9nWvkXi6CakGcfdls22JMERwU5KoADVvdG3lYcmvZm1A9KBmk8NTccHoQuIKfvRk3xi5wpoab4A74RyaJih46Vn6WSV3wjjardc31ccLTyReCvbYp87hr772Ym0AL3KQ5tAdnCdAzxsQNMWvNeaWts4U6W1IhExT4LZoHUOYJRzNObNFRh3yFnO0WbRVe8EObLdKbPJSawmodKLxth7FRVR/fRQ1KcSmsQR3c98HKCQLagPpFpFro+SK/DlWffAFiIzlmBKFR6YdmTviRGW3yFVGsFF9O+NkNwUfBwyrcLjeuc1kv+22nbbmbU1oH2GcAJIRLqjEnpVEMVMjUP2zuqf8+oZiZIANorY7GgqB+3sLIz2BIHDe4HEywa3De16MZSJaWjfyqsRe+o1vwHVX16KnAVN6mgjUzBmuGFSiHlfOb0MAcbH2LFkB6lyvJy3Z0Y4yu6w43fLav+FXM7c/nBRgUC3LL/Tztpx5kZlzngsUt0Hke/Oqg0/wIYsHrPZaHBSQzjqEBs9qAVAotmiqYbMp1AceGMEiLyPrP1iEY868bUjzmX9fBwogswmE+U4VQERr/ujOm5HDcv25wkp51Q+dZN6TwuJ51Q+fItnSna7S3N/OmG0p3A6a0VdmqcaY7o850i2VaHlQc6s6IQ92ZcYe63H+aAf+Wh8ahbVMPtNrUkN2MqkmDShwQ7FdZleZpujyHkUfNeYxkU2FOOXHqZnnrClpkqhVtqaZqTqNna2UEtitbpGEaJUFbcaJ62cUKLpKgeQnqnZbrQc7Vo2YlSwlbmgJodVuGQopVxj8zA1bZys7+fE78dRQslmZlF+oB8dm5Ix6J3ngDFl/DlW/lgM6OhHxx8XFNIdiPzAUjPs8FzMGMUgnNq+/JTHVijH8QQf95hpZ46s9nWl7Vg65D6JAyMKIzolJ3BIPZVmq7wEsLj/LMgKKBs5dN4a1DWlBeDbQ601mZoT3zeMxTE0bkm+rxkRISjdU5PObIh6KPTyneUjtpVytrQiIM774b7v7tF+7+b/fp+m6ozDaq0/Iw315i7l0XDTWsLSt4UpISG9FFyil0Mr28oCZkFDs4wyueJW5oXnlpxUsi3DBCG0ZJFFTmIVtQ/ywZGRvhl2S/o4wbmJmE18TCZwhVmhgg142ejj93UoncKt6vyGfx+M58TkrKmzpU6hCCf3eg47z60g4R2cdiB2AO/WgLawwHdkoZ+wlIbSgEkmaG5TgUCxiXaebPWj3JPGQQmfv3qKyty3ez+g1Kc8pH8yDH1MIotdThgWiLLKPGZXcDKI9GcEtVtHzdco1KMWapCX9LZctsKveqBwkRdwztFEQCNlJrY13ajJ3ibRQaJQ4IqSCCmhHE5gb6wD7T6I5qaaKdTHHla1Aq5FeynlKmOTMBK+WigsOvBqbFzJVFq5dnKJ44EDq+42W6Bqb6qRxOHICXRXjzAW7oDtoJkYbEjkMxRsM8tGShVUrlm0oDUHvoxuJWWETanJ2qVbEajK25lk9haZftsFc0zRVr4sq5BdjNzdwhhGAwNGjAPU6U+QKBLQCtwVDEZk6YdXQAAjAcEXUNpZUDztmF0aeBao3ny+RhbFRjQ7XQGv3dpe1Tn5UhJhU6ui+8rLwsTPKOHYf4VOrBlJbuB3wVeSJkRZ4UYDIHIzai8SGTHKNfgbf9EBVH0HI7YTEv0GLMcX8HAb3wAOmuicl+V3k8jvyFT/z8J2pywOw6JM0PdJ/jEf/x+fLPIx/Xwo8zLu1lH0UBZQMffeuyj+nB7ueihqj1mV1KXN2pHPT3F3UFvz0788kf5okQnQhtaOBRK6AS5eZpVWFILkK7wcfSbvUwydPLFxt5R6+5ZOwSJp9F+EYvn5NTc/HMuVApD+pZz8oXXQx8g9XhWzE2ApY6zuMowlnZPD+EGkD00dSXAYx1DPnXqVi6IN8lTkXGDKsDKYt94a6X/67sPeQXDZyA8uVGLZ2R81ePoKzBiO9ae3U3kqvpzgVNZPyMx2ghvp+jTNrNYe6nkHmtAeYSM7zq7kXLTLTMEGWSEifRRVoEgmPuaBVaPCqiiIuDxQ3XZEBCgCoOiPG6aYNpmccFewHMizG4ymUQWsIJa4vSsjaV47fGygHXLOuAPOfBa2OVEfVTPYhN+DAgT/HSUrW3VKZvUr3MKOqz/APSUiwRV8xS8Ts4RoXy1HKic1GJHg5gmRMtLv1ofNnzcctZxW9W85L80YMB1cAwwjlvNK2IRiVQ4cirfnXPRImwGnAbPF7pJUnNdnSycIb/bUVE/IBgnkJ5wtYdUw1XcSXImApuv9IMDWqifjtI/5Mx13JYqSZIXY28qhU8mIoln2llDWYcCx8Iwz+JyyOKXlTbKPg5KPByhEu+M/Lqo1phKmixN1tD9Mq1CHdPvQ05FgVIdC8xdFuEvK5qVmP7KJ+8sX2Uu/apPviFHpFfwRXf7KMSrST3x/dRkSac5G7Kd7spn/zj7qb8lGJHDMoN1RAnj25FHwwods3VthzJI+m/s8QIpJroNUCSaCaJ/35m8U4CHvEIPBIREVTgEVt4xMeHR0zxycMjZngkbndJEVmUSo4O0Sh/ct/ji6WbIXfBcO/n7hVGeaOw/fkyN9d3kx3FDNEmwW5gHHcdZjCGMsGYsG2spz/8uGtRJua64Om+6PYGnK2iT/l7J9Cn/KcgiK+rX7uZwmFQKjJ6/eAAuAHxTkr8xycTke4cRLZXh2Bkf55UzmQdMjRdMIUUekSHl1wqpevDoungnVYgnTpI48ICIN0mn/jvyh4iBkNYNbDgUXV+y64v7B1ylsYAqlhijGOgvIA4u1S5VShSBNeSkJd/3gytc03uNJpbxOyjxM3ge1RbzIg2DzacvDRgCalRx9aFGp5jakgoXBNDojFf8s7GqsumV5dt2PraZX1tqQ8SQVNHi2PzFuJQPRZBjAelZel6n0x0Ce1t3PQUucUoBq+NDT7dJGINANMmCn/pjwSb6TK7G8qBVUmGFDFijtXxxRoXXmbiIn490IcmKq4jXc1vHJT1qqIIG6gibMuHmt4nmeH0WLxOvh5bcCIFwol+AikUKkfKmo6Rakv/kZ4ZiLunk60z1DrR3lEta9av9PoveSGEn3lkJ0KE3BVdaznpqOpae0bX2t3hx/GpPtxF3ezjctiot08iYb2Rhrr0+vmYFvYnlEO+zQsC4ZDLS70YwgghmCiJ0CEMrE3KYzXpYbN7pQIJzlWhWA/1PVyNwgojuhu6t9ZtEFi9yG7eGlixG2bXFuO6VB0oVTcXXdLzqqqUglTa5ert+YnLCKlT85RNCNQ0Pzau5nnPdDVP3cskE+rI7zt5HVugp+rYKqpN6tgij26DnJqtIl+gyOfUbH9/VM3WkubYkOYIxHmawm2IUxyDZ4E9pghAKSpqt+Hx1G5jjgrK6+Ut1b5N9BHKA2nZseOq3f4BUh+l+vkfjqufozOl+jlextTP905TPy8wRRlR1h6FDrrq+uowVnV90RLV9X10PfvkI+3Z7rJnYfYpfPx16Mn3VsUPj8VGRBEaKxFiSQRMD3/kVKfdnHSN6NpGvNALZb6rXDiw1x3LG1dy31Gevj5hT+gApgFmXMzshGC2SaAIE0nfsz9RPTYhrrFSl9vrQcqUb+E6sZymSsfP02uhene29JMIWSNF0Jmo67Eczghll58guFNtLxovAS1VpxC4pdQyO6EC2xChYAFIAugr5EvmEibkBrA2m89QlHfkAMWjtgwyks2DHYDBiJYxTTuDxwx1QENV6TOkOo7RVRyJXqqbYV+rhHNFGF39qauKmDLeGrUhjZA+z1GoLhgRPSPKmQKTok7yAc2sFen+wqgTLOCEi7dUi8jY2b+WL4kJ2BSvyyxs7wowii1csWSlFrMnK+gndTi5gY3rV/lWwTV5j/u5uJ/LhH90qqOAaD9E/gD1NvSH2uJoba0wcNpuI/f3f2hNo5oSVevH5p24oK/VLhPvrqFkLQqahSOGBG/P7RU7qK5ZY0IjV/Rlp7AvXFWq8OopFtYo4Uiae+4KES7xyvCk1L5shWZ4BugQ4NmRC+UF90OFex7thEYuLeNwZn4t+1OduYAHiu9SRDsOYCAbUFiXYjGZZ4472Hqg2jKG+AFdlLU0Utbq5mVdOxVxcN9RsTPhfsqjUK4r55c6592e85MngZQbV5tWClhmUNyMQTllHygxgMbGXxee7RRhEBu0DYhAeCPi8xwMo3HtEujsvNTzXmH4jsBpcZjeFBEaEJI8PDTAsxcdQ3QyJB/N8VHSdMa0Ns6YHoEbWv9ap8UQVS+o3+UX7vbJWQCCu9hgVRNVmyZTrYyFos790E9RtWe0n2qW2ZNtez+DuaEIhJ4oUgNOdZi2O1Z7Id9v7IcvhXSTIrlyv1NCZ3Goq8YnUQHMIevBjKGV4LG6WGb+XJaZRFTlICvDxlEcuhg5tCUPkZ4jouwW4BFlP4NVA7wAYlGasSnDSZ8xSFyXBQEPY5EmUFsoGhZmUC5OB5SofZWG6KoHaAZxgGP1A7N90I/QvIi0YtWj4+Y5GfnxfSO/YLpvZLWsWvU0e3URC7VznmavcJ5mX/aYPc1+cdSURFw1M2qg+BdTbYHW5ZbqiLHRujM2Wp80NurSJRWAfMTVAJM7a+Un9znDowyF7LPO8GhdxlYNC2Dck+yn1Bqo6FqigZpP9Q9hZfReLPPgb9XM6AjORO7y1qiZ0ZCbNpSCI3XChex5nZ8UjpoZjZ0y2y81I0j3V68LKnq8nttdqme0MTOXb3NmLjecmct3Iegk/LrnY9khkArk3TBI3KcFdCyTqYopTzEviXJp3IexPuUMwtIwcw2hZqVcvmpsWiDlUMhfMeeXsg0dSs+usRHrGqWgI62SzmD3pe628GHhQTwheQu5ztRA/nPlQLWN5Qdrkh5lShWrSN6tVvCplcfUMcYNhGtB4SqPt4TdGiBwN7LLA1k0EqW2+vWXQPMTulE4X5+jtp5oQFuFZg8g415p0CJasCtf6nsiy+/y3xa5bL0im1KG/UHRNl6kbj/m/D2uZU5Wth6YAz+vIS//beWiV7hV+LKjNJw5hVXa2k+EPUBpeczVzJjjap+2k8ftXCvg5Wc33984ihmCF+KXu+xLxi8DfdFrHixU3qYViHt8UtTHObds/cUrPpEv6hk16xjfusFXVsCej3jc4BlGPenFjNwmr8lpMVgfYXfAN7SeU67qKxzUvm/D237xGR9zx2ekR9toheK1R9cpXAub6BSg9sj7hT6Bk4iF+6btOj/naYuMSlwBmKsA5Yn1bS0ZxQbjxXZRbJeWFWJJvoVLWlaIzTOeqDoHP2ZpQU/1gY8FqE0q06EdYAvhAeWenXsC8nYeT9HDz3PiBpIaIaOcYjyL4uEvelQ8/E+e9jsnbGp1JmTK6fjQqUV9rSBlKLT9dLLwnCpUZAdg0fcMQpKAcgeHQI8YWC+WmyM7yONXgRsHwFmhQxG10ZFz7eRmJVu872VoImoPNTiU/aS4atiBIyTawRpHQWqkc1SXUQFR8pzFk//gw7ZDZauFTWp1uxVSqAxEHuFVGZc1KOg7DxlV+V/6Ds+LKqYAY11D6mqkKjpbJPuBUEOII0BCmxjKqnnApqiON74VwbNrb4O2+te8a/CqSws/4uxzVcOBcWk4MMarmnyA4cAYEc5wIF5gzXnUcOBlsHp3tzUcGPdvt8aiYmQIZbjVHI7a2ZFuZPdbY6Ik1TE4JuwI/uWjsCP4f5ytv3enMUvZ2Hdc81rP8c1HvQrj3McuGlRdOGQ2GV9VRL169PUFmukKZ9z9eWozUC4Kq+2mPJZnkteBfBcCRUS2cCeedWuNPjbW6MWLgNoShIRKb8wAFDyl5fkFj3EyAjfBN4/FN6nIwcRlWgS1tuxv8a3Jaj9t2Bx8Q0U422bFYniK6A2JbuH4WA8SSN2RleRAbDz2Sr2onbwO6sHt/l9VpwNFmv0dqhbHSEU2oJl9H3vqdd//lsHnuI5ZSksb5kPZv2/oCdc0nbB9337ZB3/rvm3xXj7cmMv+Vq5zJ9o7gqloFOaaP685wHUsbBRtk3I5M74NvSq6wT1s4+RDpAO4N7qx7+ULv/itf/5DN1ZrLRaHA9fbtq2BlWXak9E4z3VsNYU9aCxB8UD6xqwXt2ToPkth9fpIsUTZ+psrNfIVsoztPRd+j8RRzcLGkAGfEb8vDm1HwKpbvTIZBOyhxgaHbXdx5a7rUCDH35W956sfxQeMpSxEPp9XoFfXL70m963rIV+43we9Met3cNwqPvQ85SAfkl2KGr7L3n+jKREnL0tuPKiD5s+KpsccB7MvomrpnV73yRDyuRycnfkquJLEPmRGIND78DzAgasRwFEb49fR2mVoKVrOne0n2Y8dtHhx7ppCw+pIr2fvQRpFSEOfHno95IrvEiytCfm9BHsoCKSDvUparTweH2Gh7//2G/DNOyrfPK/85vLRb6QP2rKabkj9bENbIK/9j79+vCwqy+qO19/vqgUt1rOtixBWiwxHi3zToypSASmqva5AUPvs0KtdSbvLknZNlARHjRH2CrK/z758oxQBrVtN7L/nBjTszXqzXVOyL5n1r2at/E8nLtShIPt72fhiELwxa4m3T7OWOBGLxVFlypBAT7H+jJ2jWFH8gu4T3Y7s172RL9yptIe5IQZcnflAxH5hauy9LlbtD0rsx6fG3j21hPdNzXvXRF4v+3F1cee7TmAqOxj8i+8nvNC51Rtr5qi1uCKSsJIXtfmrN9RKY0l5rPNc979Y0PJIjUgXdVtO124ezc4RLn1g+488dYVUKGtlLcw1tDVNlJ9AHTaR2tXEvqs/EQt08DaDuLaPKOGOdPOu+eWzGfmiTsicIjOUPbEBj4gDEc7zEABV1LI8wrKofZPbfKlWa9rTRCf5L3W1M6FDN2NK8gau5GbosoUCuLTRfqXpPYFf8YJEIy6cjVBLnQtXnP9yDXrFyBOW1did+DKQ4Dz/e04m7z/Yk5rnQTyVlf6/YaUhPM6qmzuZEQ5Q3D7AA3Wrag05DRJfiys1ZIalgs1g38GV7fHXfuHpR0U/aZObC1o2+eoc1GnZkHuFw1G9yJDoRYaKhhIlruYjlIzfZaiTR/zHOwsvdW2e1ppccCCGUlUE3yjc3+/5kQ//w67v+TsGG5SVcJ+MLD3y0++bTlrILJrZP2IMSm7un/CGesfMktb0srXeTgCjVyVGr20HUPxMtR4U5cRycf+t3pqydsroyYr8IGhCXudU3RCA42PUiLMHhftPtG3Yy6gsNMSP3GJKSrNymOgYD3ezFmYIkKJHQ9B2TBnRcCKnGy+k4ewoAzMBgY7Y6dTbs0eotf5QkGep1IQLtJlMeJCJWVOrbW4CNXK58ztrzP0RBy7rcfu/Uvr4KJpSErgme77E2WcRBHHkKiAFauMGvTt50L5mKFsPOWK+Jb4mrZAaFXLalIM2AbVJ2sOQ6+G6Rz6nTb1Wt1ovUQ9dYZFpy9oqQsRVCXMhucnR9iYy1SBTRwtnJRZ74oU1EXvObIDtdu4UYGegpQr9bb1tywgpsL+/Pg58LW0B0JYRQ+ewOIsNQPK5WJGNKwutDaUOg0QU1PUYDac9mbVtrmHVU9b96Mvw8xLgF/iC2PbjXA66unEDPgZN20ViS5AWIXxceM6Li8ULa5dAcRfnAldfU7Th+1xq7yCWFmixByfpCHf2w0d6jOvQe+GJLPtnnSRaJQ+43QotGEYxhs2m9gGRF7YZRmp1E12gdvZ36LKq0n5ZbhSp3Ua9aSCfKi50cN9sTnGxrZiZpeYGMgqqYA1pYW52r65l/6JBY01sFaHT/fD8gDAjFF8SxReBJ2wBY4AcBTiXLxRqD63AFNxnsVyNA2mamO2/bFV8QrWn23mWQgCIutlcRU6dzug55iNw1E7OYtFOqQUUOANsXRBQcKiiqzayHIBa6pyXux2KFItONMtYuA6tLNyyVLSfYezUKw1Yds0GQ79GtNziyOxEnsNAzJF0s1OOhW4ZsmJGdw7z3HVrCmkJDwXADFsDLjK9fTqHtz34ObdI10AMZAKiBkoRXpQ55BvSA3KH48XKfdsUEuVUrqcCdviWH+azidwZcmeaG+jEQ86tnVdZjq4Loa4LUzZeDbPpaptNVwZEdJsuzLFxRIoVNYXuK3OICTr62tTXr5jXZPS1PvKKFpqFaFXNN34CL8zFvesT17P8P5GqvPRwHIbXhbD+VnVWFeqnYh5Lhygyczaym7vIbO4M1ofI6ckOPfvSqzXmYAZljTtU0CVeYkCgM/Fjv7NvVjqOgLAmJI6kikZuycAcvdjeK7uY6mJGwt2llTUvcl+l6gVsDfchqh4UhmURQ3ejdlyzUHXsD4otVF1JwCpW8iRGUayfSRaczAgJBvk/YG4Pt+3ZR4uREiJgNULV2sgbo/aAsqn3hTs9aqzjDpTrI6rNI5ydjPYzgshhpJP8aaV3qvQ22kl3rEJ1moF2ZVZJzsqT/vJOeqYKKgtiYhbLfOnKJ5EQToj5SbwutAB5OZiCdDB76DXOzeHDeiQowFAlv7buRUZc9YNIrGqyYsNk8r5K8iWTyXsqyRdNJp9VSd5dTaaw4unqLV7puCb7Kho+aZeCAk05ji0Kl+mk7E9QqJlPwubEnVEQXgtB+thxIcN24nqAczTFhW44dXnchjDCvX+Ey8HqngDDSLHl2YNJnj2iYHjEXac7Ohzj2gMKJvnzQEFgrEE4UWIRVSxd1BW+labJoVoiTt280f5u2k+v2s8Gjfetcdy+NR5D39AT8qC6I/dQyXZItx+eGoWuAwtw/2K8n9hpK058Q/dUdmToa5HwwbPMbw6gT5OYepfvxdOtozilUbfxKVS1Th2CGovqdYr0BoaubiC/HJeAMUqMQh0KM6qiopeafU0Jz1gVaiQ8tt5X6lpNpCdFsWWiCpgosm4gzKd6nOKXngeyg3LqVUcj6qUX0tHqirrsFPUumqdqHephRE9OWtpUXasr9nGuFNKjmmy+sFxFUOo/qKSVbePKDUcFM6NWuYtTjUi003cafGg9tCeditN/8/zjGHm+/rXVq5DY+3A12jFwSQptY+4aGa5dKzyVnITG7PPhwIumjXpV194opkeyXYxHdO0jPsrhWMiKxY7cfm2DORGUeRKqHrDaIxppQ6Qa984WuQ9chW1hc3+1tC0clbaFY9W4/4sbSqXnkXrrJ64XykNo+ajWfczUe3/uGRE9iqSwom8fo7lVfXsV7lVNDodSqgBWHzXoytzg9O1j1bePZKD0iCyoakJ/Fnlr6Wse58s6vFiiIxRwoHpJ50dee/xLOo9Ssf6JnjddPxcmZLKbFWFVGdeg+OdbYSi3C5JrpyKibj5Cw9nqBKtwV3V+TYzV/QVMIhBXavBpB2K6a8ZHPdVxPgN6RCGsXojLxR94cY5XbBeMi+LKnSHsLllYsLkID455XwCeArIJozWUA6NP/sRNREDulPNlfMhZacFoJ0Ob8rWKRQC9gpOydV4X1cT8rC5Dqrwck6dNolhNUhSd6vXDbKoZl+aEGZema+CsWiMY5vxTPWejGbluN6vV5U05Catct5ux1+1mjn/dbgb3kIqmu27XpOam1+1m+LpdM6XO1OuHmXzorh92Jq8fzkj/O9OvH1bVsmY1k7t+eGJ4dEbgMQt4dCrw6Fh4dI4Pjw51Th4eHYbHbEUQO0Oz1euH+HSCY2gKMmGqDIZwKX0FjhudbqMJ7ds7gNh/yOfMbJFbL7K1rXwVfVN/KRtFffMpUEXujgvOPEbhN/B6M+H3jBV++6PCb/dKvmXBskkWLKsKv7Nx4bfP8OU/pjAzVZhPaQ1nkAt90h5vOrfYobpDV9hAqbD/3ghUPOJU2+rOZKsZ0YALmzKOjFITLdSrfji76QwGigSz1HYNovrQwQJezQfl64jGKyOHrqaVzuRN9S4GFSZlFjcKm7xTimZa58s2LSCQ7RDmESo26cMNsZaRUKymNB9Q8YXeEZ0DCbcunYCFl47bNLw39KLqpW2zwmGRCMavasPSBy6JTF7Vjh/5Ve1A2TEYFBu9mhwKbQgqV7WrZsXKi+IUHp82cGNP/mpyqFe1o6m0Mh67qh1N0spQzV+c+Kp2oJkcrTwxPKIReAT/alfXg8q8DSk4mavavr3mX7rxHz4/PV02yGQddKp7HbDO/x32uZ7+A30vuwFcUPq4O7dRkS6mRZXPe9Xx+bxJhxfKiFZvQn4OEZs7vLjZ9xond/OxCHm75byL+JWbj863iD/uWwTnrQ8q/w/Zcd3JKXG7Gbcebc/JVRYJQ6/l5g3L18cUWb7exz4V7SdfbyYoYHTX4FFD94QRMsgjlAfSsi/e4G40BhM3Gt+h4LsnC+rXBSOObiPNE+zFETIa5+H6XF29xiWyR0FTdfOo/1nkKZozcRzXPD8IU6ttWdgtHcKpNaJrbkY3zTtPzQiLuvaqyY9WNL0E84UeOQSKhLGJK9oa4+opZuSIntqmgqZCCNCzH3tjTUonmiS7KG0S16mF1bQwtDbVJJfXlD7SXIIuQuhaIB+FqUKz0lPFxmonXTe9iW7G1W6atkHpNPeEv9fb1abOljTBc+qeaL7oObhOaWLiEjXC6YhIKa6GanbuTJzzFwGl1Y4DEA6igeZNwA+UY5C4nrVsX9PRb9LKNdLWlJEKxkZKaAi0/5U44L6qgJr87EZQmpaPoWz2l79N4BbqlRQjWn41cmgReH2N+yBWNTuhmz4ekuG1om+j8BDzhtdeMzqmDTw61TFF3dfjDA5hC7JsYnybU9DYA7cE2DUow2MS3rVqdfKFjic+nDrmJpZDmWaT3GPtpplK5SlOQ+QZUFJpu8PYFDO2iaTZsW6FKHJKt5qUmTN/rb1Zrd1+mlW6pS0P8eG0biE21G7Naja0fLzBNOMqB1dmuhdQfXq30IjxHiWb9CiVJlBde6Qfj/UomdKjxHw4tUeJ7RGyaf/R1skeaRnYJmmPtPqxHmmfJkZJQT+duMzmHcyNVIEqtaDHVeywI+JX6WVaHSyUwsku/+xYKa5s/hVWXxVDavpB6qgX4Dgxe9LNZ0+tOnvGJxo+nZg9Zj7Ups0eN6csKGojsycdHRTOX509hvQUqRqm4injDskR4d7QA6Y+uiMJDWU6BMKTo3I9ajTRr0O02pwJKBIbrL5cXWhZ8tXkXK+Xj2MhRSFskHk28plK4OUCAg8SnriPi/HUbwElZQ/l21wkStoKt4f5kzBWc9r6h4aogJb86tJlDEpFulwmGqveL0ZJYKpYWKeGwCJP0BxdysEl4RGNrrm2iHiSFJYfiklWGVMt262ChiImjiUhabprJKVSooc8YNU0UzNPUulQMNYW+5lu5y2WJNMKdh1xX2g15kMHL9fViS9GGq9tCsc+CiY+Mi0KbTXB6Bfa0HC0K4l2Jax0JRjrSjLalWBy1PyxrgTVL5ShNx+m6d1eEAleVTYxQOJAw7ryqh3ViMwhgx7UIC0s6hapEsRM1BblPvhb1LpmrURALINqch94J99hhfNxF6wxUkIb85s/071XXXAjwnvEWOtTbBqqYuWhFwQn0RPtQYhG6DoYOYN0/hR4hXJhzfD9NTDuSl6KOm5jYQZPNLlOEZqKTykcaeOf+17k2me4/SIEvx/1/UskKiJ+fynTsjXRBlAFm5gtN/X9F+ahtoVgUO4NQjZC5ApLQ/XkiUraTUjDsWZY0UbG1+puRCezOWxzrpVqE/gVkrlMVddHgMsx2RuldPTNeaBGy6ULyojHaKiQBBUz67fZD+NLvQZfl6LlOm/pLTK21en5HdZj3Q7ZDsVSNmr6Nhw/qsnGulq6UC+pH/ADX04XUO/obsDNNkh5pJ2VZUHxRVseFz6pRSiJIWRHUQ40ek9e0ElT0eDRLAoUKaimudzmy1VayURI0S2smFNym1NAf7yiol6taryCIq5UgfJLzS6dbVZcoYAH+dcrY+lv+4EnDicpcHvGKuxyxgA9EId5prrOQpyYBTJqIygVoXbQW+NaH4fDeqgbaDPQEZfZgBUDoGoa03NpT3zNVTT4XfHCt15X9HzIUHkLvEBbGk82cLQ5RTJaFWoB8EwdaTmh8DDgA1S1slDxt3FhLUz/KAlCkQj0vTzwp2zyZ+IoGtvi+zqEetpuG+JPrL6hM/8FFOl7nelFVHkD8sc2vwliXEVikUEnpqkhdhcB7cfhWJuiiTbhEZo2qddsxwmoeo+mudym/JEGC/8QuDbYr5S6RK6zyvqP8kDjjXU99ao91dYpD6THeHqoq5UaHsZzlztix7S6biExcYkmtxbluCxXg8seCn3G5IyqPQckHFB9zZvYI2btr+tZ3S1jI99EWk2oHZkcLH9isI6/zx9FsVBb4Y9CPazKkJQl2By/PCfy8CvQds3yFaAVWGuvXBIi3MighIlsYSo9KWLLEEBUKqbWE6NzH5JQhJYDqLlc61fXwRQTWNde4WN8HdxA+Bhh7eU7zLsAfEw0UkLb8i0BNo8t4W0hFeVWYCUEXeL2dVLrdT/ODbHyxeaapwYD5Ov0R3w/1Hvavi63PlgD9gXK1ePVM0Pkoa3qhKYQkfS4nV6SHHjpJ9V1kBtvMhbxaFaNdSwfpo5CRRPLGV5wwzzy80DrNa2I5C2a0gr/5FqRKOm3XVGGMH1zhe8LFCQVNKXAgEdaWPgjdDWcsl4WddQi3fJzIwpWkzqU5B5pkddtWmRdlnR1eMuB9/h+dLzRUsvnDJ08tiOHyQQocbvI/3ajm1IHko9BDnHeaBwfR8apyzzasuoYut3h+BjaVaXwMIYe2hdI+xS8wG9pVXCcVgXTWsX4u0nLGnZctTu6CUx/ymP9NPKV8QUqmX2IWiipwA1zVj7kXoXG8owCMCLAHMJUUAt+mDWGkLHSZkQk/Pko+8bjjQ2MMKgYGLNterYoM6W/cvLmH4/VSvuP7/rcR7dMMf+IPBP2H9/JeRmUt77zcy1n/fHwa6vWH62uT6TaPpu4We/fdd0LxZLM19fd+o++9nh2H9+E1Fr63x+NdcQfw7dV64jojTOPiLdx+4j9qZYf8eFjNP2IEayaKkSR1lbh360kbb4Oqhvq8NrWddHLrV8Bz11PRE25rqB5ZDEBR9baHpZAZrZPuNZN/LPPKLAXDZXdISpPKcDdbOTR1ByKi7tGYtocs6ox/fiALHVrkqTqEYgvOur3/DqxASRbZOps5Nm467RZ2ZDMUm3EdVrmXKcJgsImgthc1x0ptUv/aHCeqxzbvLkdsljRpFElSheRyS2lGhbtRWGKcNkFVzUGeZZqTWhMNoR6juonq6GYOVpwrlJoFq4NrKOtDjIo+wYx4QyatsSINtZTtUZkFdl02wKDSjWV+dV3IcJYVaKuZYEyYOwyv4cvHQFQHaphBkhoeuYal1X9vDt4kwte1dMmOb/sAIxRt0PR505pyaxtSeeajc0vWXA+8Qi8K9+CB+UrlJmE3gmrWD3JKlZTLvRHtesG3r4q9BZbUXyPVngQtwwHGMaMX7bQKl62IE+W1/CA7dClfJ62ignDeZoVXBgAF4acv1a+DGSogRmMOHiUGOnMGqKr4jpUBzWTIa1c++Do2crlK5fG8TQ7XMcIcss92iqtUtFQJo0YjjrFsC1A1b7ua8fqITHfvmW8li1HbC01vDkfyoDRZLV30OyR4WSF6OsSbVV3oTrPt/UjmMPSKUk61RcA4dU85/Zsk7P3upzebcMFQ0GA7bBDYuw9b5Uk2gb+pdif70DomnwnLVCBevJTaDuHQg6dyjPoNP7bha21EnuguX0Wp7O1o8spIDyx+c7pNDSusCaprqagtFV1Bfdjl/RDYorT6XRYYDqDJLN9PZPbV6gOKpz1z9GiFsjV18Kr5cKlhq/gcMbp29RBflGTfL6kXS75NLxX8i2Q5QiE9jy8kJ+FW5VjcWdT0H+gBuir0i1zvIyDZ+anyzjVxL7V6XQ225CC+aiU33x+P4vfyUeijZ0HPDviNVoLO4rCQDzpjPx0AgZz3R5cYBdW6LYTg3IqnQpgaGe1K1ym9ld7o3arrG2tU6odOqnGo7E8bK75j7jlKe3IF7nBjDYqENuOe6wyRjXXeDdyiHOdkLEf7cR2N4ZSjq9OgLT7XI4Z2Wo5vIJNlPONO8bbVKZ7Gr/lp9EubAh30VYryNum5oK3Udd4hcQNNgFrB+BAt7k8oo67fzlboUCwJmYc6Ok8rJH4UapaH8uohtbOG0tlvHJz3YDNGpZeoTp6J802tYu3LqUWOZfQxhlaAk+2VL3wJURIKUybakiujSS3yuTWRLJQs3zBLMtqyDDET03MEd2RvUFW8W2y9OY7ddwYTgv2FuBWO20WcAtwjh/1lwjJWuI/mAgWLotA8VDyVrRl+36s/6htnCzqQBAtreW70Aq17HZaAEw/jbbp4BS0K+8obYK5X3xRlCiWZ2JMd0F8yPqKTxwNS0WlkfzRBW0eRH7e3bDujKAMbUfcdkGc4jSN0wbKSNI2Y8F7Ds3gtXJNuojnnLkCQXMTS8mpsOmco8Scdtrx3VoO09bpw1QIbLcppE8zQ7FAeq96bMSKOR0gHQfiv512LLA+qWPY44+Fdikngs/CUHxFmlVoK+2iOTsWO75uY7GtMhZzZixOw1jsQtwujdMGyuyjuXxemnGaSq7QP1i3Ps0OxDapCWWM1ESIIdqJUnfqjVcFkRmOpc1mTaoANTzsvmJbOQ+26zwoMG12IVGtdGIZ7zD2LvJzzkHsNCpAZ156gOaYCURONHQx9wE6gA3wGt0V4MpurdqJRdoOK6BzoG9zI5QEndml9kt3oR+7RhziHywvT/+l5/mbbcKfXfjleefl5LsSNHlvJXnfZPK5leQ9k8m7KslnVZOxk9QbuLD+Y++PIzJbK+2T/MRrKwb7XUHhaEFVD9tnVy/n2FFGsUaCLu707OY1/epc3Lwufjlbsn85ewCze9BBUJo4KdUj+0f5XJb0GOdeT4IJbldrsCE61TjVfhbUEy57cY5m3c8LFjqC1bBtjHH4anygY5i0PCM8cXcC50Immme48HYxKSc3L9xdPIU/XBD+MCY8cZKD73bzE18QTTPbucgpGefAs9bXfUaKLmaUgT+cB/+OwAISqZUvUzvvkgeTs6bv8H6Ly+4eLcGMar7CFvHynsJIWW7s0bdQD3ZStS8YOPMEvGrUA+iKXv/BQGS2M/kqLedbqZtvC/Ya2tuzFUJOzJNOK8ALGT6BeloBbZeILxpLq6B0GT6ZJ+KAzTyRTRuR96RNBXqFtkjtW7V2rVBrR1O+/rXzTuRqmLXdxg/Y5mWpXrGqrVpFi/ANx0YwZZqTbRS+MI3FVyuco26s1PJKxHXMimgBY0M4u8DXwtrXyvbltBVvY00EV7O9j9HNuAQv586hkasgQav9wMCrKFtWMDZw8AFtnPB/mDy70U+YBOXCPCw1GGbqobY8p55yhQ5RiOR9B+1AQ9A4tElAK1BElhXZe42b2N2KBq8CLKYFR00LSFogfeE8gCz6UQD0hQX9cv9gsJZjt45nl7bIcws1Gc8Dto+C1TQw6hKXWQkJp8HF9KVYS/IetvsTEwnQmTIT0d3Dvpm0B23gAc8E7vXKCbbar8wvbv12WTdWeYLxzHOTLCsn2XaAgXhE8h5/up2ggkEYq4wn64zgwUpecAm1YkWtQEs2raEnWKU1kdS0QD2LJttou6mQamPIAhYJ+TLk0+SsTM6I0KataBMGgURoXOfKtgpCUTHRjpppR2+zdvRf8Lg1pQcQaVNWMOVqlhBoU8g0ZaugOZrp5SvBXgBw+izbVplldPxZBjCPzzSdZSuIA5VQA97UYLRNuA31nKj3f8fMU6PVmF/IvISziF6+BI05u3vrUfO5bnXK7aTC1gFs1DwxHRZj3tvLubAA/otyymkBXdgOot0DZCSVHYso7ItFIeJYpiXhFFrQhHyBGAA0h+SdNG9yz+P1FI7VPNg2Xw26ffg6ZV8VDyqztCc4O6vl5DQ/QVfLeaajPivdWbCj7zAPY7p10zF145mNjacbMhobLMRtlZzzNG9GOrMjva0cSc9gPuqfPqI6milFwrpQLBMNsgIN1zicic8UOPS3Vs8GgWVLP+T58C7c7+TMxI1cCnPB0AUjUd4RU9AHNsjmuYLt8w6LEC64fXDIftU9rNzuv05vuI+YDLbmgp3U0NxV+uLF6xTtu3HjyX/593954dOG+37oZb//42f+pM+VlFJb/RK2JQbprydh8zrvleiGNeMMMxLuCIPU+vFqHtgL8uB3Ee7CFy68ERh1AD2Eqasj7wSPTM4x+vcN4evgQfzqZe9mdjs4Y5h4TsBqqgNmbBZzeLhL2SeJagyr+QE1cx/sMmHicNeEebTwJbdIfTC21LdFNXXKV1qafqXWxNsiodCPU3dfk0edReZFhwKREOGtSx25XUkZC/M762Ve6lRcLevV16BWu/rpRpDvy710rL6dfEbPIg56/MfplUvLchwJw8+Vu8EsJp5R05qMiiPm7WZg4/Nuv+hAtCxjxZVoaKeGotIBdyv7KYBc3bKv0swFgeaDC4zqBVXderTRa66O2uhwJgcyuARbzFQ6PFPt8Mx4h01ztM8zeWeszzOjfca19cr9cO5zB9tsBxvpcW56zIkCEOm4olTN6WrDqndLsdQiKI6wE5pAxuPgYa2KhwBlq8QcMmES6tAqMU1VVRSHqtGT2bUYxbyadOEbF/Mm8Q6R4sXBEImZ9Peacch70ITPQ5NyH1rUxVTX0XR/f+81RcNkblC4x39Xws/ggmAjUfcs96yPumf5KN7VPYsmyRX0jyOY9iVR6I+M/H78XmL8jBszaI0+x0m+osnmDrm2KfxrCm4VDUHgXhs4ZgNHE2tRu6XEro11HHXx2Pj9PRAANWRNyfh5sLEm4VnZ/tWpgzVc46nOchAkks9BBORSMs3hsXBEDrMooIUBQnNQPJ6julj5texFg9tf47bCu0fTvN2Lt4F9O4a3w/btKN4ONmnGapnMoBuLKkeu8+aLB4T3A/29a1WHLKbfd6UmMLCBwzZw0AYeaFqw2cAxGzjaFBFbvoJKu9RlWSRCOxHqmV3gLK3KfU/lPbdaMOnrNsBPYZcK7OZoTtiAbTSPPLWgwglgBJojubZSbzJXvZ9VwDlPK2hVD4+e3QsmkpQp/JoqJlfQ4iUzL/fihczLA3jZrTBnsFVeBngh83IYL5l5OYiXmg5JRlt4VpruLnGrqSE9EcZmG80BVSS8HfzbViEly8jGmwcwO+PilA9yj4ttyAbgGbBMQXw+T+HP+eefwFxuRXgrh/EqdSM8CTXgUL6YingfIuJlQR/q4hWbTWDsFloEk2QQL7WgaZqZprBpmummwGmaOafQacrEo47sUjrky9MXrI3h7s/6N2zrMYQijpf9tCxtdUhwCX7GmMWkmqULG9nPIJkapcuJrzGZf7BODSwUX8bzICuTPFAH+E8P6PyAELK2XDWstlwRBh0O1mGjtQHtl5vRSyZOmBtc0rtg0fGwhjcQvknDdyF8SMLn+TeqQe1YcTz7BWl9QEnposX5K9uNnz1F7PyV7XL+yvY+Zn9lrwtDT4WHFfPaTcv8TSeasGZPeHapCUGZXpjK3iJAFk8uC+a2LBhAKEHiBnuWt6lZcfqBr3H6w+kLGmIgZqRascyKadmwYZ79Eax1wiZPQnX5xLnfO3GJXM46p3OwBTTS+3S4gmVUR7WeWLwSZ/dITcwb8Wfi2I8aOCoQ08dW+bVRMhotaMLDpRJyZUP08pjvNDgwvgwYqSAbADrCBNnPvgXZTJ7sNk1OKdFqeSmGSXPIKFvlWR7YseyI3iHjCnm9IAKk2jRzB+yjwBtei1EGP3uGQ6BoTRrlFZwJsbvcbgHpu6npzAUcAyr41wId7EYgdLpMzvbFRKCWfQBgy8WN6IafR8Qr+lFfdJ14Xt0SUjAFkeCyZcBJFLMLNjwjCh2WFjZ8BeDYK9j30F3GDeH6m8vEg3vJBa/sOR7lIdZUu53zY0vdhy1ViHulNXfjrgHqvscG7reBBzkgzAc/QRk+Lk/+xNfnLb6kB4fxtGj3wevODw75poSBDdxlPjmK5zEfbbjbQxsk9iVazwEt7grzzeX6mmnlLc2aUFDFcBTQBWmTnvHvLaEYv+6jqV+QmGP4zX5CTiMCxoM8xGN3HumFoNVRflMjL9fIAHTsO6tnSZp8oJJ8dTVZm5H9AYZ/BSfcoUEmDOaR9D9WrbtXjfar5T1tevY6aaq6tvsS28QVm3ySrHZg3vbaUet8J+nS82OUhozOGf8FjNI+/q71HXPayJsgv/NV5lSZ0nsyZUoHY0zpzY4pHTim9HYEU/3irrEv3uq+uMt98TZlY28eY2OVogEMkpKn2VCIgpv/VetgM5Y57Shzmj23mG3XlC+dA+0LC2jf5QvcyUMeTt+EV9W1Gx1PNLyMvAt5F48k38Ip92aaslKpjDp5j3zwbvBuTHPwxKdZiXXutyE/rXLQMrfMVeBBYG7BrRANENoK5nYrtcAqtErmlgOlD0ChsPNVTa3tTDJxWk9b8oK6+Q5UPIWc7ATnirUagYENHLaBgzbwwJwJ3GsDx2zg6BwV+TbakZ/C9Z0KETOdCixrKV+603ZYX08DJJRNVShsVYkUVAH4dZJNnRvJtZNOmczV6mcOMFBkwGHIKXicQqeC8TnVsKnLyqaqmExfjuElMy/34oX0hbtcZVMzAKrkxfA2KHmxDCAreTG8HUxoSUeIcjaK1ANspNunaGeASIoDPN63kmACQoMSBTD4V/Uw+qPDXiArjujluYNypOY0D/4R6+nefLvBDRa7JlIn3rQy2gqlICn/ymJbj3EK9XBg+1gtaEO+C21GmRCY05Ig7+JJlrOnLIbjUtqFjmynGfxB6EFzwqHO0ao8VymFTCmlHkarR5myqTPlMvUCFsPdcYdbhd9cbDcve/eSC17Z03jdh7vgVb2HAp5u3kuARwc28tN5tmDa4yK/6P/sL+nHGuYahGmnO5tPw5wqxAR6utB4IPZt5SGIeQtGYTvr8TO7oAWoBXbqqL32PAMLu5XZ3YSH41i2hvoeeNOrDtUUFbJ1odYuy92a5cFKlrciC8KZY93PUNZ9uxljJhUl105nCE8+SBA0TPlhfVGu/KC8gC3fzmz5nYly25be1bEcjPP+HcP7dyzvLwHIi7KflfZEMHawse/sb1n9/GfOW7nY2UGTdq7zsNH2QUHZnciNl+EFXKrPYwg8Qxt2caEbQ8wDwl0omQfr2Y9BRfb27CfwGBa7CF/SrnWiIw4nBoz5fVk6aLtrwUNiWfMUpfYtzD92OXumLh3wrs4jtZ8RY43xIvvn60shiJRTdGCIuwG1FdJPitn9B0RrzuOoWcr4LYTNpz0OP8IKDXZBckGolpxJs89RxwXHsrxXWWMWKyvJjkdSKPn5lnJx2UJB9nMyIAU3fzvDeJaf4QXBA/zEZLwfT7oguHcWRy3o2IrKsXp6xYOdZbCeGs6i076qp69usoCceHHQwF02MLCBwzZwkM+WZM1F7V2oVm1DaCdCdk3ZMbamFJPrCVaKE68nBx/P9WRRKb6uJ/pyWNcTfRnghczLXdX15AHV9Gi4ZecKfdEF6XJ90aVqr4wR9oS0CnEkP/Zz8xLQ2kt7+Tx1aRXXe0r1POih4f1UrjlXsDFwcdqar3HC/nylXBPyZQ4+MMsUC0dKxlfwqbSVsxWnrNEyh/j7rSpPOY0WyATPYljx2Oe1dz88T/z03v0wC2j/H59pxgrxh6fRWZuKWk4zn/Gz8llrCnKdRadBynIaRCxn0U6EdxqJS0slLpWjq1OA/NITCMN8XpROEV2yfugWSKB6vpKqjAjLD1arVVoxqyfPi3wXnvfO5oTng7M5KBPPG1xE3SKL1RY7TaDI3RGvusUsnenuTmRKbOa40Mk+5TtbnuiY3Z3l8GabKSmS8/60QgiKCiFYnlLM2eVkT8vJzgfHMhfO4gnS0rNurOBn52fhiFsbt0NEmm3G/PwsNcO8A335KsxKXyOXxOaxgAkqYdoj39d16i/K1EcruoyeYCQx9XM39ZfHpv7KN8TUL6pTv6hO/aI69YvHPvV3bD71oZN7iuH2WuDQaB7nwui+mbCtUhh6zuYzditD7JxHNl2noMM5lcl6zuhkPYt/gIS6j9kGXm8bQI1Wn4LDfwauTMEdpbD0Cuy35vsEiXMuHczNbFVZaWpw/exRXD8rP1vVOVKZqyV+Q8mE28OpxrnXnLKYCbWrnN46RQKbis/VwRAxNWpPiAWRKCEcGnHk6eKz7QGWvATrbAubZrRkZV/pdC48pO2VUojMi4+XXc6ma6VUisAAudT7OXW8KvBRbCIKmwVwdPBfBdHpPVCoBDaBRePgsyV4EYcukdAeDu2jhM7AKZ8iUfbzype5+uUODjahKJTPhrJC3cMYOYjGfjxTIxMNE0tWEro9vcjzrhWxa0DiK+SOIqIIArcIErbddwypJoI2TqzI2LI3ox3pJVDqFAnBhpEQcC3gzt6F107aJ71XmB0T8qciA5O3BqkL8nEg/ZLvhVNEKmrD6g8qyqZtEwiLEB0KTYfgHzTCCT7Kj5wVP3sHbjRdUoFdj6ACSGo6sCXwh8hsHWOyDFdfceAZktp6F63rECoDOJEWZdu1Uh6yc21//2XXkL9mXNuG+q3cE/T717P3VXHdIU1AnN73VXcStYqtAA/fZeIaO4NUKvu4NEQvnkr2PORn6UAC24Koalj4+DC/9+sN83sfCcz/fBTmn/lGgflfPFKYD9S2T3AdoKBHMgiVRzIa1iMZL/tngDH31VPBRcbofna+fy4HvfP9syDmv1DcpKnAUM3cBOdJCly1FiFvq314I0L3wp+6ChfK19hZFoqw0/mDllgexDdZoRnrTK2yqZkiTkm0srCIoFyOO/OoCR5pQNw4DfsyAJejQFpwiZs4cFnPuIpHgoeL4vvFtoOPBHHv8XY/9MT6UcRkCYtNgFaR2u8KUHbEHRjZ9dZE52oiKll7BkLi3RgKPeIoH42S5mua6x9at8FnUUe420ARtzEOeVecUDIokqHxtaJ2B8RzdlK53Ngkv/KWaoO1+rh/Z/1ZahsEbSEwhQlu9koycfFDfWGs9fm1eYTqR4Zl4wZIjOGflWxLGs8Xe1xX+7ipTTV70ufpSZocrslvdx3mBjAo2UeBrQC3Ghnpe3JI6KvdlF38Ne7vv1SKCfoXQy5Slluup+l+nOB5ua/D7BZLDWvfi+DI96MKT++fVG3Ya15OR+u1DEgRjH2PI7hKx4vPHerg5/v8gKXcqpIBPIAMWO0nyIeApGofcJoxgBbiUT+i0CQfK+dAXjBsRsWrQIGKDGxsC3U4DTHnmy4kH0isBmAUz415GHFvCZ/j3K8XFX6fiP8u68lE4/ida6gZts84Wd2DFpHeSo/0qnwIgwNdtQm0oI7PMnF3di5TFkJIuIBVhIQLaElotxztxeq0njxR88p+39BR1FBoDWoay0dPa6RhMXFjxqJONbV9UgS9XGxKEwc41nygxEs/0TYmWpX6CQwrCjL1//Ph96V/W/j9nT9y/yeqLsLi5+7tU9fJWO6+jCzEsVuI48mF2KVLKpr4CCsBdeqsmQ9+0S3IAdWyX3ILckzOoxTFWJDdVTmqWeMmsWYOVWmf4ZJgBdYlF3GxjkYsPIHaz/InVuCAG3enKkWqB/JY0IOfFFRX4BFTpG/zmOtBG7QFkXYiNss+hizAIyHfoJzaHFTegpMy9VAeiF0LE+oS1hZ1bMfAuUu5Aq0A3+maF+JVOwPDYAITGFURf+XyUoTW6Zj1TXQpM9is5qtcNJO7DevMPkKGUDomLUUztAfZLwuv7Y/aoUr3erJMgO/2sncgCwwsKUztrBQFXrNA402tj0gTE6huqNtCjC8e0mCBG8IyxWvWnZSHCI5HOLB2v3wUhqFLKNAK1IbnaD3pt6LPmekyxt2ZcNOaUICE1OWAtQgTSJQClOGZvr3OnEQMs0oVL03h5iogqh4tpEWBtqBwyBhgt6jwXMYFZKB6dr2HX3/vJx5+/0c//dobjnIymC0+1ic0OtvAh2LnBS6cCh+bo/vlzCDEPbr3KKpAITJ2HEfMHAd2YcyOVPyQJKqNXVXBjlyw4YJN+JbGka9oYycUQQ27Mcib4sQqD6r+MfLIqWGrvR3B+9T5xoj6zjci6oE8h4vMG5sVg/z9ZJNmtlywLU5xW6PNbA3y9omaKfTYMl579vLyvrfil7DChkSUbqyPOOGhqhMeamjakaJBjUl3GQ2quWKjk/Hlg0GbKMfpqVOT2TZqDweqwOJnv4bRd50sojIvuSCLDYBiKrL09ZAj2I9LLJ4iv08BH1WMm4DBOAUbeRNII0PmHdfOCVhLoGEV6A6S1BxQXc+E1FIHhcaNjY6KMZWjPtKkpZAAqZ0gT81iPQH+vRFT8VUYVi+ILvKPo2+17E+EXG+bFguKqBdFd0/3s4+FCncds3frwuTI/x7jO6S8Xes7QQmIlkZ6E5dZU46t1PsOP1JT1qAubq54/fqkBx1vCN61gsueu5eO/P2kepXCmzZt1KSrXrHgueKNXLCIBmCJMGXCzaopkbLEWgos7nvkTeK+N/VKBm5KKCmsKIMF+561/F9e8gfP/FkOexQP10u/yvrR+ptxwveS44sb3vv1Fje895GIG943Km54/zeKuOEDj1Tc8Dwfem/S6Y2c0/Oqz6O+Lwhq8JUOiKWAAxtHKDDWqIBpjGC5b91x1oxo3U8PeV5Q4aICBRZ6o3xTRIGaaMBrwjHSSFJNNz/7YJVD8ksOycerzjxwSD4iHIeEF3ifGuWQLga3cNRySEH/45ZWBMohBZZDyj5U8kXBZnzR0UfBF+0oKUprlKKA7Ci5+D+Pd/qraAaKZdZgf6xP/FVduR+MnQ8ojIeKhaRVgDpMGvJEyH5L1YCh9OyvZXfjjfwp5xOh3rL1CYF7beCYDRz1zPwV78aQroyvebGqnJv8d9kPBzZw2AYOelRXm54bzFbJYsm/4I8gOKpTY/+UxfKoXSwpGeiUWpcVAhTjt9EpJQARDjU4JCYpWkIPENfW7lND9L1nKr4EA1z4gd19yM8yKK50jB5FPquK4sQJuFQh1k8wjXFzOUXsIs2aNizwvQfRlF405wHULjMgcXk00cPRskfzhApvLbrUHdASgrSMXz7CwJVHTOoFKyyZo3l8aRSB2ni0q7eY8k7VJmxKDbw09EWFNmiq9mah7Bi20lwTHrPc1nk9JRkV04iYJ4+Me3zFAe+llyodgDm0+bHyAcR59GBM3IMeJKg6HuM7Pj7Jd0yJ5XJOku/4jXG+4xklldhZYTF2VVkMTe5WklcnOBDXgosNNZJHv77GE61Q4sRdFp1RNUWzwhELsjaFlTjsg/2gohGdVHuBg6bfsdQSGowhazD298hy4W0ycXeTR3iSeWbmKeRubVTX18cijYZmv2ssbporrAHzhgX/YLTQjsSC74tBBBO5+CsBfzhy8hLsg9HQiBtKUbW2vaOvGaoWpwTEf5dBbhORDw4bQkomBn7ekNKwi6o6SmwKdUmrkS1roQOfyvVbzLG8leqVYGpRwqFdEsvp/IDaqEimYa60MnMgVErRrlR63uSP8qadQJmZA5kOq5osYVTLG+P0r4XeTo6PjEJbBNJ1Y/m+RfUNS9cG5SbAhwDDmM8qmtDFF0PFgFVvY0gpv1d2DkJHUjQ1xfGkmGBR2GqLA2luEetlB2QOSV8SvDT4On/eMCcBhmREPKh2yN/rR0G57CgaJhjdkb33wXD0/e6QB9BTrwb9vXlQHa5Q7P/uFR4FRrAfDDEy4jNTjZgHIlCO1igkfiJVB0x97Qnjo7bORho9NggOProcoS1KnQSQ9d5GHlI9D8zpgE9cHy4UbL9mwy4vYWXFkfpJt8PCjyotqzbFByFX0mjAWEvv9mPcdwAA/VHx7BT8KGIWfeymiPAk88zMU21bA3F0paw4Wsa2UrEFx/jSzZZL1u19jVqAo7E9hVWQ6mj2iDZr+RG1b4U7lUt7attV/UTCUbXxUpHyN6LQiZL5jSkTSjeoiFkLwPg4c0qeg+UBPmEHOpV+IG+UdEb9rSq0rCWhsFS8Z1AbZXtqpm8NI5xFBdcFSnl0+1mhlmonCLeH9JrtHhPV5Sgx84zjOA8HOx6oQvbJVzsv4WAvnU64+g6VA5wixKnX8yDCiBiR8HI54wWQdQicQkl5oqc21TEJ+jIuaMLpATdG22dPF/UaMKL06FFbp2LgJg7iGsR/l/aUvcRhIDU3cCCGt2rj0cZLuG2xNjY1jQ2liYOiJUdjdQox4KE2Ph0WKf8cYTIUQGouRpdmHA27Tj3a9E+DZ/6GUs08xOhwEWrBHvPyCIouKSfHNTD+TjPD3bTJviBM8Ey/Tvz3bb3+965lfy1RIdhdLrQHe/RqmYBr7DJXxo/MeFdpyfmaORdrUJP5GjNgynd4sL5Q3ms7b5qxZvb9t3/CTLMu6NMtNJ/AFf3fTXFF/2AQOSbdmWq26FlZwVDg+IIBbqEr/LlzihL1fezRHP87sU4oh0Cecr1yZCIkAqGFPFE3Yw0KoO+hVIKQXT5qArz7/iJ+xkfe+Pm/V/KWSOq0FMYhzNYmaEXTEj51Fju2fFYXnlFn++Az80D6FU7v112PX78+9XvffsbrHqztneyXS3k0/VKy7jm7cRQ91i34J75+W/AHNt2Cf+rEW/BP6hb8m1vwD5/UFvyof/wtuLogdVtwbJCy/3XcLbjbN5/shvuRba+D6dvrY491e42uMQGP/q/fXofV7XU4sr0ePKLtNRmmm05ycz2Yurmm0b31UX9sb/3A1L31A496b/2nX/e99W0je+OBX20FrWX/u7o19rA17m66NT7ZrXCY/ZndCtOUnfDAt5399eq2CCOjzfAnt0be6PudXt+3+jgySYL+FXgf2SBx0hWgiQH5YsKuukFCXBEBCcCIgf0xGyRVlfClpeDVo34gxqU9ip656QbpaGWDFEzZIPlmgxToBsnvdyY3SKAZUj+Bh7MbJNLlFHAMRrdHOlng+mTq9oim747+9XZD9Bg3Q94j3AxRZS8Unngv9FhZjvu+fizHTf+wGcvxuROzHJ9VluObLMd6lGCfC9rS0Ovldmoc807AZryyymPcxTzGFzbjMaYxFiFmxJ1eHuE58PJ4jGbohMMaJHYKPH0e8iixbAbjdN40ZMQTUZcYGqA6eYztE+wGgpaaNDZlN5TJaEuP0MkQrIWwHLneTs8zTjvsiXUkCnlyI79HM9TigDIV1Now7AYMj4LLWDC3YjJlIOZNta0JDqNTZkDiBIfRBmFboLlNOYyFsTvDs7TAX+JaBqUgIzggPoTGQ7BJUK0Qot1EWksYthbHYUgOecUCRRTRwpU9HaTDiIkplpiYQpDZ0NCSKg8BARffXfX4GV/AQ2t4ioUpPMUCWqw8hZEgcpzyFMe8UZ4C832Sp0Dso+Qp/vrrzlO81fN9x1Mcq0qQ0IC/sWRqygIUGNVwPGsqxMGjsrYnJR/hZ3+rfISV9UxnN7K1Sk5ujTNHHnov1w3G1KZ4xkoOnpl51ibUoaqvNHX5x8qtIom+Z10CiwuMSPSwdWo6OY8J1IyL9LhX1N08LnV9g35wwH5KoxmwWPOn8EqoHMARP451JyXkrqKBOV0xTFfLWHgMpUYUKdFxa3wq/eClVO5ztjlxBqbnXYZMZj1z9c51YIf8A3hThiDjbzo0gwmISTlDsyMMQWYZgjnHEDSoodb9YyYS1q+4MgFwQz83yDGrE53VHZnVLDGkzvhq37GrfUdX+zR9v+8HggfWiy43FSuUUfFRB6/4hBsUKUFndxa71HJJBh5RSChnw7OLZ3gAFxizB9TdPKJbiPbRatCHWscYHLl7zODI+5zBkbudwZGPqMERJLo6IoJ1nwPZ2yBSK5vS54DkO07l6rr6OUa/QzsExmVNP65W4ktHbP+yL6opF3PfQSVzn1zpYRPBWPaKcu/+CmCcz+FAMY/DdXkPJd3nvJYbLcI8gpL0KbDjYq3eTzVXXTem5fEk88zMs2ZcWOMRqjX8JG9K380iGYsBQvVxnYJBaLdrYsFJTCpSCrVFxskUxm0zfryA1wt+EC7nQr+IV7UUMlLQ7o18EUaPF9f6yYvzJYf3y1zgwYvzrtNn2gK7yeAUoQHIWpm0QPzHF/97/Q4UxYpVca6F8rdSCh9f2/DIxLZtqJWI7Wki2LoI8Xdpj2fABm0/MixyyoUqEGYr0SqFGBjlIXEQd3AxL9BjrsHHJCryHehsD8v3Tls69LKowH1tjaEQV1NJzX9so/zKYmsvR/05cSCnnaLlrbXQTr1JSVjwd9gSaUloXUhEhd5U4EJ2opCcIzjAsWhxKBcxC1yT1BKKlHYIGGgRj8R0sdg+yPP+dVzPHDc7E4BsLU5RqO0sQgzWTi1hGxHeUNM24zH6FEi+T+EadyE+xDWVU7nqXD74fr1CyxVskwo6tgJX7tbiNKlJK9ilFQAeu7QC6/Yn1GRUkIdIRtnCFwvsA2rJXfjTueZThcc5lWEg3nt2IYo/M7GksWdQQTuO5GdSj7/Lz+JH55r8bFrF2zmUA0AP1r8/fwJjym7y8icKmq3QOWvFCt85gBtxlaoDBUu4ztMTgSJP4sCTLu1tjED5yYP8XDJQneVA90DxFNzdz4gfCvOdmnqqwuZUBUluQXIu5QYkOwESIMq9tRLobYbKuQ7oBqgFcbU5dfid6wthHyCjUOtb0GoWuOJTNfcmY4wb0WhOqMk6BEhGTVxpG0u/HFqfx+F7JJyfLwl7NH4PB49q/AX0BKwhFyriLCic86cKGAopmmROnaLeVRZwkJOezVeMVE+PU3bTKdj9EDjAbTwpttOZaFpSbB8Wy8c5wwn7dQpxhsOUAsSqyhdogEJztrNl/d15l6sS+oFp52yeh7QK4wkgqiEscGwTqDEqFfnQMQswsYaVijNsp2kJUIULLWXZyuCXeZrSKfnutP/K/rV0YY+Bs4t23e7c6RX5EVcObRkpNG8L1E6jU5hwoN2sTUvxLu5mEb6EnYPlT+E6r+u/kstdy59g+4K+bdW+HWwAA1bFYROJMiG1cWH7CS+lhWvQ5K3UpVPoKde882YQ9g++aQ/i+qHgDR5kOwXUK05TV38KwS3ckeUBU7sziP+u7FG1I6PdeMJYsy+qNPtpJ242BgVNfwKabjvxFLT70h7HPG20MxeddGcwNPlDvDD3fW7KS7QJ+RqdTgnupTyRvP1Yy1Hr2WwnScbiQll8IIxoCNeCdBgzmGg/BMW4m0+cTQppn8FlLpzh124mDtbeVMyoNUR9/Fc2M432Yr/UgS2HF8sldOQsnk5Pp5n/0qt0ZwGPBdurnlvDMDxonk/NkeahOdowWuC4or3GBedPp9O01QxQ20w6g9f/GSxwIh1/+s0YgTU0GOaZ4VGaf9RAFH9Fm3RiwXYiJP5qtBOcKHLonq65Z8MS01n4OcXA/yywmaLHCmqQ45HlFzsCAvSTGUgXD9TuiU5nHYO2W/3xKRhet96XiyiawCh2qQHZKVqsIUB7zbq1adEXc9HbpXBMgF2ysPWKM/hG/F5MhiPDwfHrxP1GDAT++HbbAuFoG4uRNiLj+C57yJWO71IwnOFIFhriSBZXfwZtlxbDPrr2uUDnt6lEH9VPJUtmHE4TCaCp20yGvK3VTJ2WwCUyTIq9avEtAxv6dQbJQz61XyJTEs048u4pM1EbtYDWLKD+RzD3fJl734CzzpNZ940/32qYb7XR+ZbSeXQ+OKg9dAHYq3Ppqcwo0ZPyJ9KpzKntZHbwyfl2ehLJHkb2A3nb8ve4V9fd4x9L+LnlguBuPJcvCI4mtEAtsV0sAp8YQJjhZ84wlA7HlnOeoa3S6v8inDPaThwABEJAQMVUsmUz7JMURZE1x/5eytfThz0vuo4CcXFG3hqeu6Eus5/459Ie3vcU4QH1vi9O30P1llbfj0FSr2FURyqOKwUsunu9CNe8Je+zivqlwpqiEEqQV74oov1AaChtyQ6Rg9xEgN8HvvgYS2QwZ2mJnXS2jSjUtFuv8pwFDtgnNJ/zmrajorpux32zZUaLpaUnUBH5+ykqIveFYV03n1YERu76hd3ch9jcR4RxQJy9kkDxpT2YB57Y3ueh3fzqVrqLUAKIQQwWUIwLXdJ0uamr+eTKQoJHgogGQi0MdROhDKONg5u3qlnjBQoQvSBGVSEeMpc+A/VOJ6Euh0KprEFNSt8LiwIi/M/+Qbb5zbFtfvMCcWagQob7x4QMn3ZChvudkOE+FTIg0e3/68TKp3FVyICL6bu0iCockrL7iXa/UXa/9Xh1H51vnXT30XaVcYRWxoFxL1vvhDXTZBzxyFY6cFaWv7umpwolSuEpZN6zCKXEnnz8qjs6WV9k4dClAgehcvqJFSMQ7L0xm4mMoC4SUYmeS4QSDq2wBHo5Sf/gWRCWWDPfItVuWr1Re2wVFq2qxl1bTGyJkGOGn7sh64ixp8rIE7I3S9FGPsflHOyKWGNe6T58uFC6v0holviPedRFI7kQj7GLKGKZPEguunhkIvJItBxxUbVCXVqmBH9MtVKWXGw5MoQ9a5FcrAAeK7RkROoK7iZLLrrGufmiSi564slcbXRtNaXzt1xTD2eOGkMJHx/QipwMFF22RFQs97hwDhEH2rSVa0lMLWoDinOLl3RbIs3L8UvChfTU6zcXshWFtDmCAxyLFnN3ILlYRkFSQg9G7QAGmsMjMV0stvDpZ/86rmdGhAsrsotOePvKr8sFyxzKNnRpBdGoqau7WliTg32qRJMTbD0TJMuutkdcdnfzsrdXyiZbdpfIlL0dZW/XssmUjWQjtIgoBtiXIGzIoQOiwoaConyH+halnNfhcUHDQgmGjHaIy1MO7ISgoQqUUwa8Vzd9n+EAb/zZSeoshACKM7PajVnuxtZKN9q2G6dSW7sBPhTdTTRZu4FkAZEBQY+4QrBC21GTuAzqUKI1tbSmFtc0e/zBmEVNs5sMxhZpe9HCJr8tRtyzYteAZT0wda8glsE8TQGZnwHc1v/UK/F2cK5eal+XdNlbVrzU+ZTZ+XQ6cU9lL+BmkENLD3NgqfQ9bQqjlsqX8tM3LXYXF7tFzWwVXa6E/3gfcCbvA4jDZ2IfcPz6INPx8ce7gBZt5/4wL4nafS6XGCqq7TrIz2TGPKCClyQY6q20hVAyP7loLlNOD5fpTCKdil3eEWyR3iPUpS08Nj1+dqfy7d0j0lrqMv++Hfw7txXlcgfCSgdaPOogla0gTYHYCq0Ox2PTkoCiSfUJD6YlEgq1hFu4LMSCuFFbaMVsWtqmtWinblq0Kgu5ZdQIypGKMwwFFd5Q8zhksuNBBvVgRk3tf9v0v31S/VdsUQ8zqE1xROZKU2veCXKxmG8TXGmZmocA/1AorE/Lat9OoLZHDLbtHgwVV3fJKw0GkhfhrsRkNkNiDLwNAL+VEn5qeHo7BagKOtb8Z+LQ/O0Wpi1+YBKja8tCWoptAtNT6QxQLbh/gAiUFrUriAhnb8DyqfzhznwHwcTmVlhZzLfQTopVJUldmpk1MqVZqKPwwMkWoClUh5+6FGEZsktQ2yxC40uQLkAMWZRuqZq1Xt9Of+KxOXN7YP0knLnd/LPg+e7Er3Xm9pX/2525TfWjdbJu26rOs0rfXN9o3ts2c9l2kn7aOlO6+KjctSkKqru2CXQDpv1f567tUePWppg16Z/tB0oDlMd+dnQz9xF5x2ZOk3Qz91EEU1U6C/FT412vmGehyDnfKQ0j9aUUwb3sYYwQ34Wp+DC6uojxeIHzYXSF82H0ssfsw+i+KPasBrgjfMdqj9yREY8ZGKxbfLnDgPG+18/++fHwawQtheP4Nuo8at9GP/0IfRtluKaUwJyMLmpx9k/SP9lqx3i0xN9WKg7Z9bnbPMk8s8q+UHRh1SpVHvUTUXOvQ6EDIa2/Dk2IiB+66AeqZN2mWV2Jq67u3B3mGYkl/zm6UALMKeqiGY7BYz+UVMQZ/ZpWWhZLbZ5WbZTLKZU9Mre+jd6jUXkgbXUtjMAjUCSFXFlEPS59FhFaUrWFNelB6Z1J2BD4qcweAiBL0BjvTDL/7wCvY7wzXY2fF0z1znTFpHcmp3L0vV5VLhVprF7KzfjhoUERQW1RVSUTUguzcKmj1hMjQTo414mAD19FczlIj8yvzvEN4b5gM0O4D6K29HNpI5Vp6hQ8yl49UNvv9DegJnYA+iWqePECikGsrtC379G379S3y/XtEn3bp28XySqT11XmhKkMQZqyY02KEf08VkASa3tYa/YzpF/IETAIdaBIMdzBAaj/vcTOxljtj7QoBYRCUXNow0JfTMAQiStm2DQfsJIwBc9S18OUZq87JCX0P+7enHQQzdS2I8tFjI0USnMozl5vsy5IfonOO9YGT1a94wew3+KtYxuMjWgiPYG4Y87N1nmcPF6RL6iAZ7HvXSL20Zd148JjPq/7bOHKmYtdJB/c8YKRRYXUUgFZ7rsye7SIiaTE/KBHW6iHQpjpWKVV5nK23mF0z+fWqMsx5dpHbL+8fLmyt478plg6Ohy6lQ2fh5AeqT74Q36xjd+2XdKrnDP7mOw+9dxXcImOqV8XRjn3U5qvJM7bnad6aDE31AGei/JEoeRTKqK/hHx7PlEXmimKwE6UjUpCFFIOIsRk1OFsIyNY+MpEL+soZkLNlo0Vv0sKXzui5vS0IXXKZL8USrVFopIz8qX6Ovl4JBiiBNJ7NQWYPBva76JfKxUk+4GayTOLubbexeH1B3K+lBAxU42oowV1C1HdBFWBYxFqEa37TtvIFYVWSKnsYHj3pU3ZJhDzEJTZMbemSvjYXh2rHRCPQXSE+HfXuiJIXfXK6wa+M4RPaHFNqK2DtzbP7NgStDJR6IMbVPfe8IfDmpsvZfj/DCTPxTaFKj9CHJPRNiyeMelw8SdniRlMhHaLIB4hGMlcQAiO1UBWEdyjtjF1jFV/XM1kwsjiGzDWFloORmflofX7rTvc0R6prmREKbqSWrmLHjagwUUiqvByd4Q0LBJDvU9GPZkVxeqVRb2Hg1CO4ADHmg8Ev80n6Ll02djYjIXgaMxXNEZ7Nh71cRv1a6+xUfeORfUfKPnNXno4GDHXGY+b66Qo+9o0S1N6nlMfMWVVd6as6pOmrFy6pKKzj7gatL6zVn5yEMNo7mxQLbser8r71wnXEqzBYqobw1a0Jruy/XJSJRVIxC6pVIxcrUHzEx2omLiKYM+TLkVDrIkrnecBHqWJq2DCxFXILf8ltJyYycJeAdnzOj8pHDVxFTtF7Xd4YoDW3UqJtYd1QShzKgUkaQg+YZEcsegptL35fThtg547NSS4yz/sAcXQhxj1Z6869OiNetZHL698O65r3OXpfQ2YhjZq67rCh9I7aSyapJ0Q87TZjYfsXZZ4s7ssNxz6d2DZ88NRAA4rchfeHeMIQNwjbjGBYhhGsfh9CE/vAgy23F952aiW+tWjry/QTFfw43oxuR48j1DgiFm8wJrFK+Ls716Dp9i5rl/A7IryDHki/JjY7uC+XatWW1/ieAwsZZwHiDfcd8usLuLDMl2MaEMvHqdb+z721Ou+/y2Dz108RLFioYZ3lLfdin+/bS7TpZi+YnvGw4IzoMSwhBvGfOUNd//2C3f/t/u0DrO//vbLPvhb922L2ZZg9revFjMyFGGeXaKtvkhbfS5F1CotSWi4xmHDqu/CgzzZHETA1pfh5yVYQsA6RpSeJ6cnDXCyTYqyfwbEkOeqIuD1VzZcQXmojQpg8QDtUcPoX67BidkdQrn1dFs+Vvl6m1JxJaK8YlEfFBI8pONQha1adYjIFJn9o3HSubqW/YsGZaph1eTQ6X4IMxkCh0ThgP5GYM4FzmaRqGk9WLeyv9eOafkycXRR4oiD49dY7px2jWUiFrRCL5HM6H2r7Mfl5obcMHGJfz1qYNHXqvQwxZKCQOVozIf7P1jgGNgmJdCaDzn2MhMXibaEJxgIyiKcFIdJZmHLBzFGBXwJwZftv/eDBSciw2W9/tfgrYgjH+Jn/dIeAI6t2TsBG6GeebB5LaGpRSVg0nBtdsAi3/1y10C+iJBP1VpqUiTo8el+cr7Jn4u9faUuICdKaxJ9OMqTvQutWlFfS5H4wkcaN0zpjV8uNp00+xXkraXv8b34Ogc70zoLPoU1V6pgRrFQTVGD2r6xMq0HqsocJmCYEjl4LmJgqBSN8aGwhBJ2/fp1LLxzXNkmJNAhSnQXX9e1B2OlndDX7Cbl4spxQ0dd8/koG0OI6sLKECZ2CLPrgXPas0QKLsKRBnHzK11RpaZqg7LP3nASNk7eeGhSgQXGVUaMqOgiZoHv7dcJQDWdpnaZ/cdmcAq7xfXdHcZRtZc8VMnhvWOSw487yaEmSbmfRlAkNeg6pne4pkY7F4o6Hlmhm+2iQTGM6Ihuu9jpaerJRKpXBlu6NW7rRnlG72J0FIMzvacxK/zJLPoLsgHzBBhIvM8DpdGCBXldBNsmDaaM36F0o5uQJbRrec353pVMRVeyFQ3Z7G7hSpYBzxCid/5it+yGI+ooii7nNdpi0ZSiER4f/UdWc1pWA+bWFHMNxWlgGybSCcysZfafxqdB4NW7+aq6sYMywQHUu1easw3t2JXzAXxOxrlZIYYjdohKi71sD5VPsaG4E82XG6S0nXbCHZmfR8huPRLKHa0dOLuV8hsED2EJdGWlwJyHuLxYGtBpnK2OG2gqFg+PgpbhhdQmhr6IX1n7UlOjFw2pQF2e7aq6KUkoEUdmuyjALVGOwqtzZgbJlTPpJde06nqBHuBv5pyB460S/w7c5Y5o2SqVLdMODmrfG3jbL0qJNe54XXrUoB1UW3uUndpC9YlOAWqPvF/oEyiFGpWl0xAHdYhCRqVWAZirQIpPrGs0KTYYLzZHsTmRQizJCy6JFGLWaW0PWVg/Bd9tVdSvgWMwiEm1tpdOcd23y9jXfbYZiW6eTOYqTs93cbt3KdCg04pncQbcqp0Bt2oCjnwXWi0zBQ8MsC9mNpRxmadFHjXY3VJ5r2MNzwRc+p5Bzl0C1jMxRMY+nyoMqD0AwJADsE8v8OaMIjU+i86iM41+MI5aQSFm8SPEA8ILhnkLEfw8jVINZT8plD5UASMIHPZgc1z6nJ5fKZmrUcy96Gk/AndF97Ge1d7/sydxVnvTL4AwD/BrzmrVM/w3z2q/eVb72M9qFQX1rHYC3YBpj+Ks9ptntT/SSHzR4tQjzTH6EGk+c/33F8au/+JdWTJN0uu/CBovA3EfecrDHTZwo6yPI6h1w5eX+A1++35vrTzr5aiRMrLDIm6pC9Nn70lbe1YU5M1qgRNfq0yZmb9UiViKVrZomoGZthxFRoQnmWdmnoZq9ZPnoo6qYStMDLmiGsi98hBnk1YgC3+3Gal90w7N4jFHHZq7qrwr4tTtMzmY5KkpsdQCeyHnhTphWnIwicf+fJYCPZiUesKyWOoAh6wO7yx4wVmzz+4Ir5jP9hPXtoxmgZDy+ZVF1uNyUUymZVTbhpbn80L3VWM6oscIrOa/IrCa/wbAgmAfHIAAbQFuPzhH9us4Is/+t+y+nT0CWgBxmKf5MuZ4NGJOHTex+xqfQrMRKD/8Xu71nEC5ug7MjdKPOZqr0I85IdsodFPSzcMRg3SLOdGYQp21TYMPaP88jqOyw+gY1408/HoQr7BXJQYV1U4a+cp2Ro4kpX/WUv2Ka5eu8/nXHtd6vBWuEqN7xojRRx0x0qSaXKFXYjSNUWwIqiaEZyYdDqoq6E20PAJtwSOCVbu62p2p401sSMg+qE6wCRALBif93Tjep0z23OgU3oygNgW/mcFATCaHX0VdDaoIwcJ+VTmpSCTzFAk/JwYn5rge0z3JQnO6m5zf5e+j+bNrl+Aa2zyK4Dv+viGxqny+pCzdsmQDU9oFSZTCii20ID75V/KecVSf4JgFV7aFBV2hVVoUcsntFwB1MeLSxwisKuo8F+l6LrCF8y8c0HcGObcR+USUYpU1uR12P1tX+GhJ+VZaZKj0zEnHVqqPbmv1rNAeXWWYnZkgTo+WsJVYBTatltayABjR98f2FrcUYZ+gKw6etx9Aqm5tSY5NcAVALN8syXBCZf6BmtvXkkIpX7Z92ELLUOb3KvvlrbKbq4NLyHPCs5YXWo5sZdGrOuLDmsLYwG+r3cvxTCgqGzVGDJCYTD5oUD6SRAIJ4E+k+GO1ylctIOr5Kle3aHeki9TjoGk33vbnyxhw6pnm82dr3xA90GGkZSUKo7UrPmmtXdRKS/jlSuqlzFvDKgufVs0S0GjJXMpTbLE3C7pocFcwR/ZOAJC/l+vViQMvodoCmR1LaIZe+ZBPiq1TfdY3hI3EjhW9EPyeQogK9d6l/aBCd65Fjh1r7nasDcBUe5TpJPDR+a3SWmxj0TRg9dYKDRPb8p7CjxoC/ibERtXdalM2r3lmdrZ1ymREqKkmNXbQDmrqbrVGPb0nZ+Z9UV/DO2PGGqL2KGkQ2FDdblirUzOlObzN0ay+wTaXHJDPwIhPB0PVoQA9IlFlb2rHrKaX9rKObkfcvEyaJ6tvhEYSB5pWe8oY0ZSzRWBSKeNvsi9bPxkxLuSbJF+Ola4+X7XZIBm/5ZAxnmYOnNQynok253UXnWc3SN8p/D8fcVurzQCnipTFxBM3X0BfNHrC1ug9MCdJ52MZ1iEQCqqyq6Iu5ojgLnYAlb1IW3WHvd4GJSRkSyhBRuS+lZq3yhel0uLGRXrzoi4KC2bBYmwAfNSQsbTdmBbNfhJ9q0jX0x+quLTwzVQTAOlUE8U04184Vv/CxvtwCJ2yGgWieoZjfrXO7XgNmCcX6+TZp2+UHokrFi/7teuNN4z/x5t2OTIgT2/xYVt0Ya3HIV+v4+klvAUJ9eTwWg5O4dLvl9Gt6s24B+vMZtRZLyyQP1PNbndk6VeNPlMwPFJUndjVnbWL7tn7vvNf8q9If7IicZngwK5MvaqH1yE18N8g+1ExPjeghoYk7UiZeSi+h9eLpnM0iBy2Ti5smPPo7Xvo5774h8/5visuHlY8+MlZMCOAFik7o7a7ZgcRG0+yGQnzHAFdAn/oaJbQoo5Yq8s5wAiH/Lqylk04d+9V7tuX3tD+8j/kNz+dUnIvV/bExFWW4hIkjPqiR/kcnwPc/vnrj9792q+8+avAx01cPiYjh6jzsvL3wxfnC66hiZBnJAjgaZbC7NXgfMy+OSGZ/yRwWMcvJcxJt/Zd8kvvu+1Ln3r907+/kPXcw/WZ7LdeZ5hVfb0br6UtuRk8VoslkX0oQDQM8gKAMYAM0IpY7lDMUMwRHCghuGQ1v5riwb/oYkRn5Avk5ZY5s6WQhaDtXZg2k4MIPDKVmVC+Rc/Bgd0NdfoNEWBsP2eF5SHhvtEWyFVw2MUt2HAqzPwPN5Nw761YYQxch3dYih2yc3IMigERR/L8a4TL95/ftoeWogc4+9dnX3/rT17/NGJP1gmQ4EM/9dIPHN116OlVK+8JLbIoFzsfYP4KV+Sw1AWvZGSOsdFagBLjLM0j8xYeMZe5Uc2My5+sQmWVimCWGWSs3Y++Ve5wlUW5XGDhd9uZ/19YsUKPo+zhlJ0cvnHVjrEFAcDJJh+VZ7dZrbow9+0xp++OOdXUrfGU/mx345aC7F9eVX6pR6s+l63+B5W1tQbm1cKi2Q/hUxSX/nnodSYtJIqiqictJ0/6oW8tDM/oibJaDQ5x4A8uwKxTeuQpmxuV4hpBd6RTqrqF/L62+IPnNDkHxZd+C030yANd/V83uIM700/yRKsbWdTyGoizb5tRRLK+K6AV7AmPW2q6YMv9tJSLXLnmypOUEj27zRu2H030g7eS+GOvQSk10KfqkoqOt/umca2CJZeAAkqSCYwbWrpl8akjlnJjSsFrqJvy8cO1ROAALjJ26p4pKAZuKOsdbGrama6VCF/ljLLXjEdrVQCL10wVp/sYx4kqwM1L9xVgenTdMGs1NbI3K2YyxFwu5BHwHMi+rFAkD5AFXFXJrmpS8wu+H/O5gFtmS4OyUmEemlmv1gVld6rjEeMhZ+ZOc6sGpSo9/sYL+2/2UyMPoUg5MgpkTAI5zLEvJMkcg2ZDLVXFtz58ZIVy6nxAWR/Rr8zjkt8CdLV2N+RFpAqRACcQDlA0o6zIXrdvkc5fHbcqFwQEDkkLUV1MqFTBQUuWJ4gXFZSM41WtgbzsXrQMOINZKW1VysNhch5JDoV+NMJ71q1MQ++uQGSjPBM/zPFLkn0Uw5iWES2J3d9vvRBn/iJIAXt/WS+770YtC+kY7wOcBLg0RKGXb6ioi3V/P9uBLdLLZPVrMrrsHzU5rv5rPbGCAROyXJYqRGHK8n+DoTOiBYHOhmpcZZ9F9fC0VUclm3/gj3xArSNqT/aV4vKF6o7HrTYeTU/16mmKPVuDYmPO2kN3VPkVOAjOSKW91bUoEJMnqeqW26ufjKp6N1naCjbZep4JbApzQYE9T29gygvjXHc+cr2NouWWXrLhuy4aUosX4vDWITZY1QWYAr5G1Ff1CVX7wHF5djvmMoZZB9rLfgoRhe+UCnWlUYlM8gg1i4KpmkVBVbMoOBnNIt9qFvnjmkUeRz44qln0lkOTmkXBv7lm0R2HpmoWBVM0i3RQJl0CFbXRsbv+VRItpagmZfp8HuDp3K2RpnlKvdAOIeFuyEFs0mqrWvLiC86iS6XCaPrUqS6OXjbFxZFSDquWA1bl53yvPsldGPJRlHfxikCwR6hkZHEAVeoigDxYmIsAKAHHffxXokRgUQLtdygRoYaAYrvsCRsk2nyo1VUdc7H789CyVJAVBIoBqBX++oRBxpcI4Vj6PP1Wtu1KtiMQ5RYqQT55hPJAmsEGgZS5EzBl/F8DG/uTa6RvZhmKF5QMEQWVflHsXeCH329hJ6prqBoHDnBw6AsiqMoLFkNBu2xdd99YfwLLBlZWkPRAaeqfeJ0PeQr2r/cuQZl6nsFaqf2jB4Gotx8UOPNkDUHsw6qqOmTj2Z2oqlPG4VxD4gCTn5LKfuHk8SMcwQ9vE/wIxvED/X9gFD/eOoIfJZwiQOrfCEN++rgY8jNIfZTT/WcnpntYne7hSU73q09quh+HhnmjNCy0NOxWP8BZTDh5ucJyhTOB79eEe796rYCyuLThuW1xcAf2EEjssJ3qeDIM8C1L2L+tbX2N/xxAwQlgF4Cwyf68Ye12N9dy+YAizc9jC0Pb2c8LuoKMg28I4Q4u0kgwlMBotV8uQrtfMBW47ykShHcluBgbl5jYtyF25IbDH3pe7MCC5Q0dkZ0jZ4LGpuH9yWiGylF3LBqJeNSEEiC0ihEWWrgAgUgE9jYQcRoXA4lnaOGHAlBBHmM95mIA9Jhqa1hiVYUKH2A3HVOit40CeBz0Q4TkekQrtRLkuuwwtK2q0vnH6knEjW1Q88DAU822oKM1oLs65J4bckFgN9SjH7m3KvnrKB4kFg3gj+TtJV2qKSZEQIFYrudSVBmjuiVcTAHUiWlgUpBWN8X9ooxc+kFPZ6GOkXpDIWiyakxgnceTL9iyZluIF8CIowGkVqi6lOSP9ts3+TV37re80T7XEGuHhxMMxNEGaU61CJtJ6yWjbvsvodd0+ObOQsWbj+7bqf7sNjqtD96oQymiz+Xtz5u6WUslo2wd14qW4IxHDVTXMG6sXBf7NXifZGz5dpATqLe+sGiLsw2FQEv6oEU18hlqqVIQ3vkN6xM1sDDkPJdQd0YtI1zkeS1LktC3WWB4RrNoTDELgRnAE7Kt2jWa7Yn2KjXyDv/QjBSXKfVo9q9D9YlpgAIv4BfyhCVMNKTSEUpODxCnIcS1QiEE6FSGdqDVRt9G++XlKVeEN6m1oeq3s4gXEDbQhRo+1Uma6v539tIiFEEE1dAFdIUle7prMUW1MXU75FGa/ZKgq54KFw1oJ0TU3g95AUc113hd05vyirsNmuUhwXC0qIPZge+gEKXkidLcc/RN9tSVRMiMWjmUiDxq4/wIzqMiNaAJfHSfZHcpsUscsXsPrDs6Cuc7zJ6gdr5Qu7iQ+FiIXlidK3HlW1+WBx9FRnkt0JwonSc7iEtilpI6Ja4+JAhW+OYSmk2ydC2s0rT/8yf+q/2Ry42hW39J5YWGTdSHrq2ui76meJqiX6H4SD51FDtQEYS/3zpOsQ6mUAlaE+rRT1mBWLDQIgIMiW/LQSmEq18sVDDkCREU2eKqJSneZe/QK3TpmD8oCh0KvjqQDTPQybIBOJU1p8MxRRi+qDp8qpesw5dKjryu1wwd6GImjpwAnkl2k7q/7BhAib1FM9Q1t2oJBO1cC8dGLzVDrtcjdXqp2LfaVK/aVK9sql82FWjAYMUXyu0rqCFRM056IoJYy6zCPCUqPY9RcWAQNkQGYK1mrWt/sFqYLzRB+xNVEVoohDQCNRuzpb7XGGV7dLRDbAGiclsSg5Bc0uvL3kQEn6qnpEMX4/JcEkiM+iROeAUy/Qr4FStRiU9N1Zfylazzq69kHZijZF1DEpcoeuss04LrJK1hjHy2SCClp0xhwVeAyeR0kHFtkOJrguUgLRuUjjcoOfkGNUyD1tAgLTihGEyLAgMmeVX6jRfBqLX0KZvdxjFajEH2zik3ct7a5IPtRqkxFfJcrmpMHX17qTF1r9GQ+oj4SZTTpA1JnX4adyfSVLcKhaj8BYRk1wGcXeAQXMXroe5MogO472tUgXRTkiCPJ8tlA+bpmuIgJxfHUwRl8I28DZueMxYnYgiKFDv6/CaCopmKFDE9cmsxQ+mtUKOFAjO1K4lNSWyWiRmfseJgkHw9ZC54u3cn6FRipKk3+vg9qJfrvQNFqHKXt8F5zJ3BGuRxovbS3xACoXLe+z0toVvEfZmceFl9Vk+//QKnQpMV3+L4u/w2qOrVFaKvHWxyCBrANiwBA2FvRaTi93oiVLhXrBZo68jP3qW3yNTxdwZVxyEDIBPA+GfyR3c4y0ZXCkHGqKBHpeiybJOexpssfESfHcJ7ninWaJXaNTO0nIdmUPVud2ZLmTnMPn3vkJvT4hPY2bIGmq2e51Fr/Y59L1/4xW/98x96Kx+az5qzxWueRi7Ip+ezgO4l5JkDmb6XvVf1IEy70N1skP0KICEe4DR6tuJZ7t263eb2ZNLcocJrlr+dFTT5Vfl4hgKC4SJRTEeOq3BUxM20l30xbNRBbEA6fsSFZhv4el/6Q/+j5XHP4N9KpoMYs7gtRy0zfAKuVMVMaD1+s3MlqXiZpCZss24wnhf4jtXF7ygyl95xh8VF1Dtyu8Mo4DxsElWyXNl7KChiIdZ6NjJaTzZ482YfBdg3XiYu2UNCD1rA8uw9Zo8dbPBUQ6x2I9iPMy90RXPo4YTKm/VkBdKoYx5mB9a3L4T2FBfxH61V43/tkI0/OhL/3jL+3OnF7JqI5mqZGlpG4qjnw52ilZb46jOTH5kel+oxr563eaBRUfVoJB5VXYfYEhmZ2TeMsUFPGG8ZqpY69E+m54kplqNvOWKleHAHBZKRauwxTVIHRST4hSUkoFDp/G1BDIPLvvqmcn5SLW+oNDWiEGfDC/KQuzNyfzqUMzVutvArPIt+AgDFckhRRXUlLukFuSArKcTrb2a0qO+H/QaXvepyNej7Oe8lc92UxnoJMd0ooiH5rHDsYfGreCtBO8FkddUeG1IBj+z9aNYQqkuJa7MeC4kShZiCd98VEV4W+sbBe8rpvSI1gD4Cl6wDtIXBCmLEwdQEj6zzA4dULdZYCXAX/iocWjZx7tU0t+P6f14zCmtoip5UlCd8FFYP+F4fBAGMYTseyd1uHfENiKLP80mNct3jXbCpKkymp9f9nZCu1rCIpPLN3V4e42tHVf3sAzI5gDjATs01qlVSU8eCVLe5wa+eq5dFd0EMoNeNGHBq/kc84RN+2Exu8zx/pzBE4Yah7luYujc31gtf/fthsBoUlCOFvYAqOCElqaaYQ9cICN8EcRjpSxnIPohGHr8vMdU1W4qJ4i7z/0oQYX6o81SrG7GvMI4HcB5dmdeyccP51APeC5Vpefa4M+E4kF24HkU1OOOBNaNfKNKA/v0SkRUppQNx1cnl5W2ZBC0Cyrg8Q7OUxNwxGIoDkt7Ka2TqRjOtrpEDHus2tBhhf7Vq7N0q0tflTVhsfz37ETWAQYHo6PtmWf5j6ImpZDE7KmvVxz6Kf+z5DV/W0PYmOZ0zINIdw3UYkkM58t2HrMEVXe2KFJpB/r7v2Nj26s//Bx43LfHL3PyyHYBHGc9LTFrmho5Yirk4lLaqXaX0p8K6JW6BWJMfMTqWrOc+nt08eGRDituYo2puESUyiEUIDkluDsliza/3Y3KFyqFGkMIAcGDH4CTMU9OCzGFVR5HrklEsOjyOmWtzNsLr+HJNDmKboRR2v/EOzUDurA/UBYrcx0M2HD2HMuphxfIxnCpANU9t0OvIi1IhLyXltJQrgBvrKMa59h7mHYIdFpTnkT8UzsIk79q7zixeqP3UizH2y9rThkLvENfc9533Zdf8wBl/9XRusCwhCgvwmtrGZAM9azF5ZbweaJcSah1A9AA1UhsIPdDeqe8ztSzdb0hXfPLv0KZRMFSsDMBoYTnkg/OHw8Q3XhpjUFrnKfyg744n1ImmQKGoO2q1rsZfjnl5A/UMefL6txqfi6G6A+97+GNqN9PPiP8uxZ2eWK4ucxOgJy1+hd39OqCFmGacXdsYFHM0NxzwrFEFuqSs2QQaNvAVTJG5W4t5fsxf2cMvcfjKYqFX3u8ZrBfziB7KA1eCPnTwf9z3u9/142wp5ltf8vu/9qzf/ZUPsmrFzls/8dRPz/wWXH9918/ccsNgxycQu+WiZ//L5776dxxbzB/hjxd6+pyr3iuaO0Jz5FdihoVLr2TVW1dZP7HXrOAFFYM2a1TrI3WunC8aBzyyraYFbOKWBEXmmG2Y4ciZSwFZ3F+RO1MzG0fyeZnXCmPS3MvDvOsm61x/Vz7DhXYZtuBC14rMcAvz3CYyMyjn0ji6mEF7FrkgWsZ/wyHNHbdXxkdPR/rRhryjTS0wXIwSwrWiZaWn/ws935m9wI91NJz9BnRGNUFTRw1hpMf59DdP9Okbfd+r+P2u2q4U7g6kWk7Q95HHoY/U1rIPm4UzZtgadeWDN57TV0ouDp7xhRHA/boQc60UdSsbLIctHykp/m+oNrx2oWXOGa1Vs9gZD6Wgk/aT7I2iq+WJGTuqZ3+BXaS2rf/jb+BzSEnIbkMubYpJey2nZW+WaE8Sss9Yy3DZD+vR5Rs9HzTACnazXwT8CjWrZcBYXQpUtsUpqm1WiTfSX091lbjDVQ5EWVScw17aY04U6iXA/DGXsuSlv5j4C9eFVTIUlpqakTLeu5UN30Uh7DKRvnX1VCbWt0T2NMRvTtOtrvufPt/GVb6Pu2jz1yQj8pvMiVPzBpOiRwdNROzLUzz26C34s/I2HpTP4JHkHTwWxM3xrBHUZWrORNQTxZYjVJjyCGCU0DxUi632IsyegD8hfixSC48lSvGA8eBItFaW1RHFrIhAlwkKEjFAzlrKcJ+uISacGrFUJi2MJoG0UrTBK2WXpy6wAzUv4sEzHo8lWsBjAR2A5HIOa9IcpvZ8HqXGLwb4N2PcYx4snd6vrm5oVkSVVEC4BtcrsWBIvsXhTle4wa52o8cNohXmYKiRz7dEkA2PJ8UWbSUKQF2qQQZlVbOdmAdm1PVkScapoePU1HFKdZxaOk7t0nhqRsuV4RGHGdR2wxEDGjwlAY0mHgvUwCOiWT2dkUYr2MUjwpIJAcoSsVAmRZUkfUBNbirInfYqzqAd5AF1Tpi1RlDnrVxcZ4YTthexus+J8yVg2uh4xBiPuh2PxU3Hw5d+DSneWHfDgiLHh2VRyuFhWTKqzXZY6rSkmrNmM6QGhXYXi8SodllPdm2QVgj3kt0ltDvU8/bQ7gmpPrFLdGvIu2ebLWZb5oznJH/03v3hxO3k1ZDDS9XptGp/PltYXmF4hbO1u4oiRlProlEAXc8G1G2a7BckexgUWlj8Olv0BBNJTbnKqgezepVVLyt1MEKdjQKiNPwMcyeqw8rPW6Ikn5PrZBlgmOA6K4dpFkfuBzaYndhYH3LOOYz4nLGr0n8iJpvlGzpGQ1qpWMY9+3J9DQr6BziYWco3T6HbL2u2+5GtmmfBFfHp8bRFfrkltpRTZQYxZLV1ER70VAM+whVZHATALRRuDHb1M/EEvIVCyDrVQJJekTViu9BYPoJYmnq40rWVy4Ajqm2Kygt6T7AuE3Q76sIMhh49KdBz3IQHG8k2n2l1Da3CSWeu9n3Eas4OqYZHiXRaY5CowE0365ue4dwtbSW1KVkD96l+5zFRqLNGM1XX81x4CxJ549aDDMdDqET8H+3od3Wk8DJD23WclmnrAUjnadsBIAt8w4gq+5ayRpT8AlQjOMMvV5cvA357WfWtDN5hmkSuSQx2qX8VNxK307yY88XtwB1UB6YVtAjgES1YGAImABN15JauOsUDwFFR97Y8wzNh6Ws/g5mffE4smApyIiXTDDVO7+aJMZNFkT2UQspO6WB+ChE3MxfrVTO0gz8vdL8gm3eaNXrEWpxxPmRgc4pJ21lJ0zZov/PETpc2Hm0G/3WGjdX52G+xcrxcveQ8AoG6Xl1uKyCkTXJDt63QVev06qSm0A4UpygKJNyMDFz0KcMjeNeabXO0AbZV2g45S3RN4UNX+OdewqAUeBQM0hSz4AfKm9hjc81o1YuVhlMhoZBVken7fzjv409+5qG/uhj7Yl82TZmQPN2lAeCOCHzwOmGRqkSBV1vcdZApg8IrOtb5aVBowR9Lr/EUT2wRk8O8KxMeVB8Sr23C6eQrbjtX3yj3agzBjXUVba3DGyw80fX4sROO0YF2gNMZxvZIKAaSG4LrZw7RlTOUfrcsCT6LTh+LOZvhxvw8KJSkFNLQVTpb0fwsPHKlGFtkOjCdioG25+BWe1UwfYoL4uACN2MqMbS9L+r+2zGxOgSfP9v1zKGgM+mc2+gcTvKv6RXBsHjCbflu9+lOmfA5owjlbUO0GPftBVVl74QCUFen+W2U0Zluj0UzrGT9A8WOHhaU3UOc72p23enN3kazxIlA147sx9r0BJpFvszGzOIdNANF7AQCX9lDw1QEAl2v6Fm9yVmkREyFizvvyLNULU3JCpnXK6CDPT3yZF3TuXqrmamcpFPBzg/H08CWgN6BhpNwPrZCQ3vEr+dwe3eh8bKSqCMKlu8gfQttxbKS06rYSMODOL+/ngP+3NzthgCfqkvZOwxvcfZ5/k3gJm5y7ASdNRHXAA1tmA15SIu4AItiyk8WJmLmJ2LS8RjmRyzf8kDYCa61whf8hfL0yr/KJdT1QqZ0dbcV6s7x2UWEx+VFrBowHkUAdl7nXb5zIl8VvDbFV1UDAjtdy3K81dfzhl037pcDfyXeYIMSPFaLlGNReiZGwxCqXM8FnaNUtoQzJhMWlL4HUx5K7mY3irlSHAo5Qg6BQxd/TFYWpjVWOcpRYSP8ri3iPigtwhXfpUW3hxuY3V6+CLMMCCxz8jwtbcgm5wjjnxHvWZJGe4dDZqwa8HEoHLeaWmewgDLrFOSS2jjIoDnOOyhQ5OKg4GpxvVSAlmH3k9Fs3oEYxZ5pNAnHI5whhJUtaHFTbMTJKlddUilrV8arlBfmjT6MKQvlW9KRgRatXu2R0hruVNIN1b2e2mKAXJNLBr6rBppeZQ0oLG/jZOlNvTQw+BbyM0X45f51SckrR5ULa+SpWFuXkEDPy/eQ378xgBHD03GHbI/lD0M3PJHqWEgqcdbK8ZRbCUzcM/aa9cDhkcstlwQrfdZrDUXQH/gq2ezfw4MXT9Ycn6jahUdV7S7ruZkqS5quMwHvjiItMq8TfKqYF1zEOovBoAsUrlpaLGgKFuicQhkypyrL5r5rvvsfX3/V933h4uE6TikgqZjBQ5g0NfKGSwB6XUEsl/U5AMWOfk3Fqpa/Ro1oZAu5ZFRmLYp767mc9GHHmx0AtW+CsW6xVPtAEbBgQo25iDRyf76I1AXi+CVtybIM8+GwtO+Ct6B866d5QPN5l5ZknQvyjg6QfsPlqGKTcHNdflU01ULGkmdcsh2Og4r5XVrEPmMGjxl1nxJQh1NMXXNaEIqx9ZYnylpTJWJQ1KWKZf2oXkpVqH5lb7LuOQ4AaMt4wiyQPJnwyBMb+Qyy0JZybCrvtYLe05XgYFLd7+mtvI5cxezIYBczaqMupo5USfouJ+iIBjwJ8Amk7VcyEeS8wD0OWJQ1RAlHYtITeHO516tMGEdy632qLi5bsEag29RU8FAk99wvQGNHZ0cdWFQfg0xT6BGTU7zprU1Goqiye1acXLY4yZMakFsWpzeKksscxzjZMkhFgKiMIIILysY1gezAKMDxroD8KRZhVvjYd8BJhMDhgFp5oAZFtDRRdbfXx2kO6BOjL7FO+L7HaLvh54u8p4/yLhqLLAtV0U8sgnKcVzEYjvoCr4AREjHrijYvw0czPERd8Dxd6kA4YoQmdjMQSX2hoO08BQV2m0UHpTBpi/nbJUkKUByXgVp0/HXv0UXLVfTiS+m+6SCKQFb/TO4+5+Vf2YygRWaiUFP7U50Rsq0AQOJRCtgEHjetE5cMbc9KK0P7/uel1z74vv/8mYuHuGmoqNxS9F4cpVeLll45ohetQ4YMqkPLQnG6GGW8YDe6BLSwjqmBOGIbbVkZ7zmlbPN2L18Xp21LIJbVBeLlmFCAIqbKUIAnFJ66gIYacNEDDwG+0iChIXoaGTmKEClFwPTMO4Y9tmCYx9t8fyfexGZUC7N3USelho0uDPCkMotjMDGYxXFlFrfKRV2FcdBewzJkF+XDod7tXoYS/Ry3W8fdLM29SqYEK7f3kqLFogHCDx8fzfbD0Q9WdWoClHCgLEItnW2g34sQs4DEQiaZd7l3kJgqObKzSLamgUouLcajC05mtQyYLQJKi/3IQEnWp1WZ1Vprpqdfm03q8Cj2iAjcZQMDG0BvSfIENo8NDAKbJ9DGy5kVuirLcEclA/MqElgSNMryrun5vMELxTFaIg1tmVjYlDBssetaEQ3HljZFwHh0UbNmDhmR8AZzpAzpS3v7uRFdgWrXQI3mLGlfEGNjIH01hgiTuN2kL3fhhczLAC+ZeTmMl5p9Cfhlr82Gl8ttAXi5gkzReLnaHO+pySkF2HxK2HNj7rEorbmmwl7FIcwKTHoKRHKwaM7Lm1gEaRZx/TogD6DmGQ5992+IS7p8K4s+i220bZhvp9ZGQUTDPFfsmDNnzkuClMWsmJubr87zdmUhA6tU2b3rWMW0IOO1RSdehKHYtj7I+b2fKer6GKMZXblnaP6AiAwZ3PPiGzpWSWk8TccI477vw55xxpF7er+n2oTEBSHuqTQceDQ9nwuq2nsxqWpKQa/YoQxPt2RxgDaOv6Ht68XOO4bwHlIofW8Teo+0QhwsxmoIn18TbCE82kE72fDR+Kq/jAuHpbI07HdiRse0lfv+qpde+oIPn3LR04aiwu6BUg7habAYaJU5KmwPtLYI3sETfoF6kCxxal0QiE+xIedWb2/XGkd2gVTM8V1tEinC8tevWftbMfNKYIbUMQHoq0oB9HTFijUWKAMXYSh1ZHQl+PagEMrDFSXI3pS4dEpcY0pcCONdWJk0BqmR3f//0jei6qQqTkZTNSXvjgI+cq84fawereh5rDwS8rO/lfPpEEYHyct+UzeS+i5H5L+FmDwq44J9T5Z/f3FxdjeS+FgI0ge7YT8GJUqKK04pBTwbTEEFehtFvaItXWdeVeCW/TbKwpeD0vY395m95vwJPGsiCws2Nuzu75y9ep4vm9/f0U9hb02baD7Ghj4Srg9oN61TqTQJEx/+cJ4khkH6H2o9Vy0of+Twqw5xIkE8sP3F5/nP4wLuA5QoBHHMftduulsKntP9qwBSUT+9yorTI2uwfZf/gqIaw3W75ib2dtX+7KOHrPMmcA+cIyk1+yrqBYlo/PLPKjPkN0Fz4B8wjv2/wk3nPuscAGj9o63LCq+nSgV6yo6v+jfjgzI2kxaA7eSsG6hJD9/tBxkvFChbVZU1rf+Z11eLCNe4KgagK0EgVH4RuiIAQEns3/0qV0SiKarxgGG1Gg//WA+bYhU3fLkzVVc3AKlTqFZqAgqzj+loqOH+BCq/0AiA/CVvmvtrYvYavkUxc9syc6GHBQWu0NyD0c+bpAMisjRqwrJQ9lpUySn83pMUnmpQ8VJTULg22MJ6qY4VsJGzC2+XX5EfZh3r1oAZZ9zPHm6ocYDqgPDbUIhtJleuFyDFKaGe9mjDILqD2KtgXaBUOfZWf/sPFskPEMzcaIszarsW54nR3dRBxpll0pPCYD2GUEh/+0tfbA2EZ2piYEZdbcxScyOfK4/scHZq10isp7rI2Gc+Lxfb+MSY2mtiSXVhWiZqAtJQzGILn/yAz4hezq8SwYQ+kWvw1iUmGo0BuFTPEneasgtkf8ArK/igfXKkKGMlNC8s6QIvJPOce1HgTAnNZbfAjxf6hwbA+mgXemYPt2tM5sMortsnyucc/D1Sk0YzbbVnOvbJSWyqlBuuAkvTUgDVCBGojehZmkchCRptPYfMgGeZoYZm1D3lxMhDQKsZxGhCKOh8oLRz3GdZ4eCTTBvzOWMnDA/GdXVZ2uUHLHHwQ1xY1+UMFLMigbXNiJIN6GFScGBtY2jsKV7OBHluvZirWMWuWF4s4w/vJRfk2xJ+kaC8S3rET77O1eN3wenf0+vqoI9oVTzZqiaZrL+vWZ2xuqsDVfJXQ1DHrKtBtV6BOPUx6mV/oJRc9CXx0x1QVMqOB7rk7BO9243P4bwNfYYppI0x9+b/1fMmjQrh1pTKzEI5qeof+muGON70MpRabhNbJ9kfWn0x6D780bg10feEoSc62eGUewseBeYi0Ed49Yyyj0ufYtWZ6mL9AQcWCi1GjQh1rffxh7g7ektAPWlln5AFRD1FxpcWSQ9iBoKoQVz5anW6BP+cVPdJ/UCZG/2qJ9ZC1J5kG1/E2aeQyzpJifEI1f51vFEVd4OG7dsd/fB953ztzDOvrPLzZa4Rg555MGKmPaAGNKtdZrBr61DP5qtAjv+mtKLMeEfRci2g5rp6Fyyat2W3IoBb6fy5YVv+/mLcA3MtgCFIKGKnZcz3uzZzX9bVeGmLmkeGWt7QtS1lq/GBKpjEYteiFFsPyQPqUF3hJuv5wNi2wWDiqsc9AlFPIeruUygW6d9lvTV4eS0NkRwNy3sVomfvaV/Nfc0QeHDofzOKmkMJLhShIaL/1kQPyDsyrPgSOCg8I2RVxqvHXaF5IYjj7EsGkZx9wd7pYKjiA1gphkgK7UErpNshbIxFWnthLKJB49K7coobg0iLgV7kpXloldtCJElpOVyPcn25309G6xDPiaZscSevF/o54I/WAXtMAepAS7gcOZRDSdJSAdb3tj3zDWfVduX4kGHuhkVMQqW3emFwnaNPq7pzRLBl3U+jhBKLxPoNrgaRL3tC9Vems61GMe+37a1t0ppx/ab/VRiSumYjD1NxcNf3XryhG8UQh8Q+7htvQHXTkrF9bAA1fedss8FblYY5PPKZ3jRe7r2i4prUL9GHCwE3CMP44HRJbZowFmZ/DMxUaRQpmTuXH5ANQ28PBG/3WvYnyKRrT4iHWEGAm0ksZbtULctTtawa82zw55eoekTjQPangvtNc51/VGs1dcGWC7ZBaxoMCJyuyB6fHyGEEXXYxpxFPw7BDT/qUKVsOSQx/tj35QtqU3ZRz8GXKiVPrS+t7OHUCj6ESMaKnpookju/vEWDzAxUGpVavc18udKNLS64Yj0D9/DhqnzYsx+u0Aqr/KXQUxjckS/jJqRuAxtI548F3LCAdCD3CPflcjCNI9VzbSiAC9pK3gZ/UtvItwmcV0ekK8uAp6ub20tb8dV2frAwh2ieq1jIodkZKQuph9ZbdDavDLmSmrkdsW04ePceudE/syZ10xYu44jGgbf2rHWACCLGyLhJ3TqALh5tH+SwlkyDvAUXGjhdMHt+veVtzabH0NbtWXd+OraLdun4ar6lRJCI6pATdhVPZiZzqnMJKak3zYJ9kYu4BzXuUsWURYLTw2JWZCdQUZXraVO+3JHnOEUXx3c7+e8UMNwkjBuL43LPjAP3cBUd5ZgphZyS70QRopdRKwI1mqCgfLjBt/E/5z18n8dFBzQDoO6kQNMriTutad15ZSJ3wGdffppMtwXqMlifO7Xnp4m3wtOotkmlp9GpVJuojeO0KabSQCv1uWmnPPxZr9jFX52GQME/LNG9gpN2UcGf8svlmo9fip3Ih8Apmm+vTcLLbr1CPKXRO4UikSf++eRb/ubzHuX8k+fGEoEsBc7saU9eqiNsB3dPnukYz0KsTTvh+BGKbrSgoxjmHkaHE07hv1PtiIYyolNadyrnQ/4QrQf4Nh3RU+2InjJlRE8ZHVGu+jT+2yEjGh5nRHnU4X9y0xHdgdGeqO20TUYUbitlRPmrHQicXh3R092IIh8GEvkQONWNKJLciAKOwHQ0ffDh6l9x6si4nkY5yvg8z5in/vyey6p/xQ40mwt45bdX/4pdqOdBj4G+U/DPlkDITyYVv4DvGJ4UhLm7gCGvwKUwgnXFH2srw6ccXib4WfAzI1+X7NY1Re3FZzDxOUMNx8jLe5VnozPeC10VHFAts1rXFnNp3LjnmINTiDm7RcSqmXt4ZHnpVKYJTaeQFrm92UA2GTg3JFmrfEbfMWmTX3H4jGqTfrNUHHyQd0btoawFG4N9/6X+oevfGLPLI2q5S1u4zryxjhXKCfqGQ0pLBQvyRpKPInkwKLeWg8GRwi2DpEHl39O/8r1wysVhvSM0gC6YEb1W3BnLjLN9886uRWBCYKkDi1XIMgXOYPUqRtMlFWB9BBVAwNqBwYkjyCxzAsxnNtRXtQESqbBGDTqppciEfcOSckQhjiOMRatQP/FVBMWSLpJb3ZINcaHyhqHzl6/ujD18l4lv+0wMV/4xmke+MJiSHdyisTktxlW4v9XbwelrIt6HqjJbZUvhlzZ9nUXfIqi6gVgHp3kHbq0Hzt5IHpbo760BmrLtAJxFaou34RHnwCtCwmdsQlm6bgmUzNjdiE++243oi+5G9EV3I/LidiO+bCNi9ZliGyY7BfH0GmvzcGcWjwRXF1zVbtrHWgzVsRvxrAKkJ60yuxFfdiO8WRipQ5l5U7YcEItckzgQjtXhy25E79YoEGU34ktLBYbYjeg3djcSYzeCxMopPPb/+88MAFSGtNKVI0XoQO6CTGLMaPlakW2o3JhyZVYHyZWp4KIQpaSjY6WfHn41sDosX67qmc03xsXtoGQDecdwmH7K4yk/aqeLanqI7md/p+eS/QVjnjzUGFxaU1hJpPEVjSoCPCKk9a8rdUYiLRVVYmqv4cKIt+bclFun0V4lA/+BWQ1U58K5iQmtJI44Xs9gechVEifin4IXKkDjBA7Ff+F1k+aLjv/F26Z88XK9BWjvI+qO03d7qKfu7aTlRNb27vvbzx+9YMfvXLh3369tvDF+YGmPDZy/1+4xwmf1cM70rN5A/DKEpV+GcspfsHeQ/icf+8oJ67jW86hirQ4qysjerhQSto98NY79u2JWJ6hYk8WRzCB9pxcEcmi12TlboOOe+xN6UQjGlbO1uj03q4+dm+nZ2tQ8ericR+qjAeedxi4JBbpZz/4X9qxjJ23/me+2Ai8xf30FZVu7W/FGKBewfHyFrfOhz5nZlf3NjVKg06ZLgEcHTdFrnjfN9LKYM+EH1E2tyWVIlGSbLiRRpYQIqZSwj1pDiAeZU/iMbLxRDlUsRtSDuigyU60qzAt82ychnCcS6wVVsV40ItaLIGkZEeuFWFMwKkcKp5JO9RGxXuLaQrEV68VWrFeHIsuoWG90yaJ61V/R97t0CPbCdUhREoqniPXqLNaLgCuR7LcFf56vrIEa9sFtvWpReaPviba2V3iTAPw6AA5yICbKDnDJCODSChzqFnB1C7gEdxGOC7hkKGU7wDUoALhSqk8BV+LABTARBF1NKC81yULLx10ZTvBSY8O7aOJIZwyIUGVkIgw7mM1/r2AUmwoAZOH3QNr5nQMAmL2mCRwUXuBEFOJnH0cK8fYA5xeb8415UGUFPSdutmxhlSmEV7HB48n0gRWLpjF9oWF01MmIOnyaxvSFWgxFyvTphd5pTF8wzvSJ1V5T9pVFCKYPtXAgmMr0KfuZB1OYvmCS6QvzKoNlHYtMclnBCJcVnAgz7nwcMePGwAsm7bRa07rZfYem7K7c1tRt3yK3fYsmt28uXVIxER5RFWD6Oqr78VlkVzhzv7PP6St4jcjYK1WWSa3mw93gmtwA2I/f3WL1USLOws+etf39a69ZMyQq0nJqcqse+zrwjRRJgxAX6b4uQvsE4rUp+zqfW32v+s8SKibZQRm4edV93YiZ2E94fngcFSUnHMeCZtRj8mhScymuSr3rLpgcV3NJfNwlhrs6vnaTuNSpQ3MJzJWVbA8pVudrY+zVcxiPjbMy47pMnaKo4s8drxv1TwYJrST6zpNL1UdZSz6Dhg2UurAD0YMg8gGfmwCfElAF209qsEFXtRnro53qx4pC4I0vJA0aKHoza9qBmnxbU/KB7moZqPIRlNNJs/895ovlz/R9a81qAzEW34u4quLMqvb1k8AOpidf/gQ6B86cYw0g9Ggy/ZLPRq4FBfR0IcBPyMc1QBDZWQVOpCIoTMGaROuaz6+zomrCfzqTcJWwwi9F4AA4pLuyPKjUJTOhLnWFUrScNdRNXSHyRahL+YsQk3J6XRSA8ILpiCnQKg3TEei3EZiOQJgOTG5lM0baEuInlrbUUbWiRqxt0Yvl4ZpEp2gH1UHmp7WGV4FCwEIcQK2TK/eyB15b15DKCXF6yBNbOfaMKDSSJrXgrWIl8mVQsr/EVzIiklfEQfcrFujHyKwH/qG8ii8g2HvmB8RRMi06qbwUpcxIZ1kqfpr6n66pQwxGh4/8A6MeioN6G0riiW6b8tdWNYBCZ5A73WvmLuZi9lfSR4+kCH5UJFu698cjNC4+pGlJ+grsrZzhHWP0W1urxm72V3zE+fs5GVmFdvS9Tqr7RbUe/Cyq6S5OljNEXINxwf1ybLvM3rTQj4E16QtkJMgTg+V4SMUIq7yhUPfm0mVtAccjHCCK60G9idB0cIqeZBPIjPYy/VZAOrOAJr/is0lrQgESUo871uVLIFF9Q93C9MtpHLOqnNqOK5f/gTciUM1+/FBZTYunpE/S+FU9YC5EK0eG4QCr6ThE5C/VR7uYJu5nYvAdzIsFq3ipqPNJNmIyANIo6sKiYgKLirkPYbmxx7lT0WiVQlVWCqc7quc1NiQ8L9LPnk0BHpcbSZB1DAItSHWhrqrEqpJn/DFKy3MDrsvl4jSXAA0kPUNX9yG4pOHjsZoL7faQJ0QeU+QDgJtkKHxo153n75J55ZRU8yYipCo08loK0MWXTIjQU6cbqzYi1e+ctKGIlXWAGY4kUOCTbw+c66Iogn68LEdXQZVAP9kLzvdQgLn1PH5w974Tb+hBgPN4CxZK+n72RXXqg1lQ+HrfVQrEz0vkUnACxuIsBqgs5/fju+xBLCpFW304tqVSJ+z2dVYrdbMlq2FGrdg0o519CZXDbMNolWLC9ED2z2o6UwZaid2CrAK4xxXhrq67kjyklO2XupMI6HA6sOYdGB5OLf+owyK06tl5Ta1KH/YocCPjy8hgtF9U1GEg9YLgFs7AFfPPYW8t+3sV/RAnHPK0hIOepql6ffZlzXEml5y3KOAQF+FqQBNsJXXyD+wvWBM6G+rl06I5hPJygBvJt3Fwt1Gz2QM300pP0F7YVt8FIZuEdkORNFDQnuffIulqS/hmT0yOdtG0xPbgH9C+ifYU/sZ63pw0/oU2Xt0Tp4GcYVbVW6rb56aiLjXXjzi4623zmbxlvVvgGkZmsJxTMbFmqTV89x70JzIt+0eFnAyP8Zv6bJ0OC5eqFqhOu1hnyJyQYJhM02W6CxzUBipGipV7dYuIaaN3t9wxVY3HQBfMNdVL9zHgOhCCF3Vpl7Pk2kL7p6b50lxpRFEzJ3XA/tje+QlEK1hGT7/7J9PXpBL3oIlr64QFsVFvpWZwXfSbNJppeilPTxcx8crFuZb9CeLTbdNisZyrXb3d2B5OinCxQ4Kyafa3h8a8pb4ZfMkUz/HkYSDUWZu9TKFrxp4Ci5SueBdR4A4pNfmsSvLuarKUubpmvYkqKBAp21I0TqHgu8ZxOZW+vR/s7MRhonPiAulTHhqXAi1gh3KHhsieXVNOF92/dg17ff0woBDvoTVdh9Sinousxn2nPjJD0V/r++qDVQ8mdKcBYTPuVUbqJtA+L+0ZN3b+qBs7r+05N3a2lFQpQktXKaUGfiI+xXEtFPMqO/g62aljq8SgU792LT+1fagBS61PllHjwZ8IR5zfRRZ8ugXgtiOg7g5iZcbqIOHfZhLqcIqRcETReDaiZGVL1GUKPG9Z30J5U/1wGa9CTYqtK+AU7Bhi9G6vfiq7/Rh41kAjfJzmUQhF+HRtv9l8x5TuL4yB7Fi9GMW2+LGy+aE5teCUC7ZcVQxr7p71pZcI/NAFvAOC9UrF2gmMKqrmtOdqJwNpjNZp1RlRNbJcWumMsVeDu9uos6l1hsYDhCcVx4hEX4x+bqoLJuOedUkpKIgGxMC4JkqjeumIMi4dUXqk31Y8lNZ1GE1/RIIdO68eyhfb9uMmc8qNR/myHQcoshsE0TyqG3+S6mXNEhTnSPKOKBAjFpMzU3cc2XF9CProuR6Pi7Fj5f8Um0Cw1P5V4FzXqJtbX6dqoB/6fM/hwlqIV/LdpYkGKGTgvK+CJ9TZFVNDHAab7gbZV9AXHYhMtiTii9hXW9QMOKhyZv/spFEtTmkdYMgW0oBY+8FfdeHBuKl+hkOxbc0eQEpfMT5GpYFUXPGb0fsKvJxrf2PSAjpSaf8XPvHzn2DHNuhWw6S0sA1uoPloUP/nkYNafX6cwWjQUbr6L2imcipc3Ug9QlQADvB72uYE2PWCF4oKQ8O6Kmng+KT0OSkmNEig2ZYyixhhdEaMDgfGG2WLEoV4Q6CMt0Qf8CXxkMGiNuFr3XUDfgqmqWDUGYUzXdXBED/t2cOKd1bCpVrrgB5EgF9FYpXuidNPZ3H7utzXvY8IXG8twjLh+7AwsLObZ3zN/qvdYMP/9LXad5c80oPXqVIGjgKVla74lhf/de8/mTK4tbl4IY7c5xU+jNMjqQcVjBZo7YV9rfb/a9dGP6ew/A5n0gKByHJpIUf9sIl6s0b5Ij9VOzWwYZa+xvf8ay18/FunQ2d6Q2r2/aGv1c4vS+wooNSv0khTg83BtHlhKOV40BgZC6zveqCAT1GG6X9gQGI6bgAVGKgADu+uJ9aQJUtf+a/UtL635kThYqzxec6E28Gj/H656PuThyss7iKeT759pdCcf+xGmG+34Gf34AL73sXPHn7fY6/rgUcUW21aBNIvySM89lrbuZeMGpLbO23jjSqtEN16MQLjFFcUfxp9teiRgmjJNZ4U3ipZD6KtfrZQNPqnTav0UVtYdhMdU5PzlM9It/IOHrvyrFqAP16AK1Jyy5cKCylLyjWwyqhz5AL0HKbUObTXuHwU8qYeGJR66ZWWlEKtQWtuM2PXM+hBJK61sELwsou7MdRSf5LU1FVptqKPQE0m/vmci8EluhYXJ2V+qxQwS/x1AlI/CxN9LYCNIl075iBXQQVizbADNIQ0hDrDoiNiYuqIbSlVH7CwEagZ2MRyG1G/zjMFcmyxKWNQEM1wcRbiMxaxAK9d1MKS0zJWcBQPdJjXSrc2garXC7VfQLglZLPM1iqsKLcFzhdRzMl+i9oLA/VBve/OF1Oax3kKFxFSS5iUQH3ai8It1eV3EdrkKVqTKnK6oTA12rF4FhrnxsosEDwn7Y7hxsfZrTVrde5RRZGqU+uvncCp9eZ20V97IrvoZ3ve6Kc1/dQcKnnIXbO5/9W8eN/4uuN3+EeCk/fcD9ZqwnM/4kLnuZ/nV58HHYemrav5be0Efvw/yayQZ/z4g0dyfvw/gRQKlVdyfvxf/Trnx3+zOh+RV//+S17IBaw9/r79X/O6ab79UZci05h7/0OIe5TOuw+/btx5d/eAc96NlzHn3XunOe8u+LOrGaPXHoUH79Mr23mZMNb/4n/nUe0//Qf6Xvaj0un0Zt9rnJwr9wL7defKPay4cneO3L1xR+4Q0Tyk+yuxeww5xh2oAgqTOMeMLWkgV1nEle035Qo3HerGM6LQcNM4IlURCJePcqo6wMI4Y5iRQR6hPJCWfey1zmd7MOGz/feQWktfH7PDRO+V7kJ9ZZevU73/yrUZH06wy+uesrXS+tGMli9MlgpRdOaOiEGoZpDenXLbMvQcRMuoxtlMNd5/PoNedz5e5O6QYW9lPrGcAU97XVX2CMhknOKo9E0dNEurzquWYtsL0bpZqGKU1RhreaP8Sj2za4RS95RiVwnajxJcLZAQMoVJjWjcI/ic4h/bVm0iROKXGmPwAXwxN4EHDqDoHTXV1H2RQtKUTIin+BP0As2R7rLwNUhhaF+9WcXibxOftsTcXML795EytPWtNc4CkX8EssMiftgGiaitVgpkRyc7eiNRapUgrAMuTUZjtFtFIBNNTBV+HiCTSH8YEgJWK1XzKUaDY3OzW6HTyAGoYKQs9IwbWqs2lLShiaEBMdR2bEPRI0jAW5RSkl2POIrkFgUSdpcSivQYJJub+BTubOZS2DrKlT2nfqgXIMecCYdjzoQj56iYP9WCA4yRL1+rC2GhDr4hC4iwZEEnufMe/KrXTfUefAQ0z/qnDSATCoU+IiR+5J1/2tjMg4gwsdQidN25g41huD1RrSp+8Uw7GyBQeGsarG7qBKkrQFSqqB8LUSMQPPFBG1oftJB07geCok7VrDAdBqo6H7TpSKX1KZUmptK1iuNbVLq/kE4BYcb8zAZr6c+BIdKrq4HZ6mDUwtJgvW9grktAaEff01RkBnnGm/BMhqr7+1WbBMWAjfcrC3sE1Kku7HI7WwlqZMwISJG2Jl9oDuQS9ZNbweB/OHQrmFdZwbzKGhaMr2FAwQeMjDBU4dDrZImH/hOWMOdoXBg+tDJCva7ymAvWvgfa99gIUHWNE6m0in80lOAMVr+F6prCIcIC0EIlyCePUB5Iy17/Orew1ScWtjc8Bn7mjRP8TKvKz7Qm+JndJT8TZj+Mj0/Ev3z3tMOTCsuruu1Y62Efrjzo+BGUTYEV02v9jo8b5Ysedfdvmuh++BLXfbyMdf+p09g5PuDf/yg4uULAoPjKC2J2/askWhqhGhGaRXn3ahYZJs1yfPgmJw1fRTwH30e4y9KGqkB2tKFd29B3xm4yU8l2wQcJz005VLpcLhv1r8CCKe7JG3qzwP5XehpvzsRxLJZqsCR6vLrrrPG4jzpx1EO6zqyaXhhTDbCuhEIOLcCy1RpFusS/ieHBPYyQbJ1+W6qlCKAnA6BY6u9bQ4hrRYpS2ZrUS372Y7ojCct47nKZeDMSW8FoGrOiZYYfRwZlMpv9ZT1dsmyF7pF/whWB1590H8R9jKhhMPCQDLdoe/yU1A0MY6yyjajheqAWiVS6bLq2LAAUm5RUownRmRznuOgm1ALc6ygMgxKGgYFhYGGoIcQpr1mrNCE1vS6aqkZajnKtHOUatw9jPG1wddwnx7itFvjyGMTAwO9WJAi/BnzSuNsQB3N9+3PRhtVLNpEwZQrhmHO9Gbn0VABAYfS1kcJD5B5sBwQAPD9xPoZh0m/BQupWTb7NhTppE5zU4Pt5re57ugHnNtijIA1FPG7KwIjRtk4qa/LZNc0jIeRBwQFyqRkptbfm6/NSMPVB+tuhX2f1KWsxryq/VW0gq4wnhuCU64ihahMK5LGiPRthxPNhxiUIwy+dHKM19KCnac5R/6wirv1IzY1KSA0tvakF+1pvpEXHWqrHpcL1xmblyMkhcC8XRrFcvX1K8dTyUAla7zpn2l9pet87fiU1U0mtIhHytBKg8kl3ZnOQAF9cLRNdQQNR03EacvKtOH5va8cDaaqG/Ay6NNIHfN93qASvhdGIVnzoiEQgk3YPQjJpz0UIKhGRIA7W5bMkrNi2C2FWnxMl+YvFexR+drp2auvyOiaXk9NRHU9MAK0s1pp8rcnjEvFAhYFWqFsbVLhZPZ7WMwqPsp5A6wm1Hk/rqWk9mC5aCybL8eqoaR1jA1tXmEfO82L654FC3B2+xFWIg8bqmmPcDGLYEUL1+yhGO8UbgZngF0k4lEm9B2HuhtC336+t4YKw/J7rGqqglhtBoW0o5hKe2ONodXWtK9C6fIAmtqOMKnWUI1S5eU2+1jQ6vGVNodYUaU2+1uRpTTq8WpMO7/Fr8rSm0QEuawoMCLUmT2uqaU06wKgHA3z8Wmpay9gQJzrEcUVm//HKRmj3pF6Pqp2GGsY45jKldJGrE1eh5p7seX+iB90SWsBaKqEE6CghtHsnQmrfNOBMopBF1VGnRrnG17H9sXr9iZgatP0BfZPtdtLyRXVc64ilAgCSpEas7asIydreldDVso6H/MxhbusJa9ICtKZcNFKpUqxOppSoeS6FXh2RdWowdBsKHKvw4+zs/arvRScL1RqaESlwYwVu3QA1NEoUJVBrJVBrJVBrJVBrxwVqWAI1UkkRp0tDKggfa5F1B8OyqtWyqq5WtaAtr20OQEQ5wAmnhINT/iTcDHA/HfiRoTgKunAMdBVePer7qvT1StwxF/0gYQApzm5HG6wzgOu0Fi+PVSClQBeJBjqEuYiPdd0iPBS2CClsSweMqk8h6zhaIpef9DzVQTqWqdfANLWQBfdpngGMOWr7UuXsYvKtexztke5QfLSo5HZJ5ZhaQPZT+Lyoi/KXHmhb7qA+QlXC0wM634Z2KadcF24Sg6xgzN6ibfGlUjTh2/K6GJSCwSeVOUEaFjrxnp++M5qG3xSU7UU4MDS4K+HwxaDBC4pWGT90cwV0083VToRkampnFa0w5R0mW9uysRCFuIAzQAiNcVgZkKlrtBqMKXprMLt/LarSSRxPreOZ0meUrIYYazodp5del6mpJS+YTiiEUe2mxYtkF6KkasknB57C26zkyYLrZjQyRJq9Ut3tN6Hv3EWchDKOe7w7+jh3D403ysvAZGRXEupWuZQ8R3MqlIXq6fUjSFvdh5RIG+oKFzK26gqHSQjeCItPV2hfaFa2BQllHMqU8RV6UeJWnd9CISfoiioRVLsihaqPZXzAvZCqfAFLV0IvMbX46Kc/Wc9xKnimnoKIZ1XoMj6uJQP8vpZc1PldFlRzdQVAsUiHHIp0GqoZUqRIpyGDdCFtBt4ieUTNU5x7XHuLxgPpTDfTchHBw6EdZNnaP4t9QFFoRjrKmX45DAJe3pzh0ZozPOqB1ZkUSc3EUaQCqXLWJOWsCe2siZRTgANkPHT7IyHd/gT9ncoT7C57pouLnkJGFWF0jGcr3ETwFBxH8OSfSPDkjWQoorJYyVvUK2ymHtHimES1opSeaS/r0r1EQqGBQqQ9j8qeR0jC/mJa36WUctY3qkym2S/RWpXP7F+hh4GRspq+VpEIZCmwVQODz5LQgtA2hDLQtpLVxIYM7UCbxlhNjtXbyI56qUJVP5F1XobiWaq1CL4zb1AdK7RwUiA3yk0BjVLR/HeXGX4p9JJJwgd+QvkNXzko2EnFayD3PfneGvR/rScQ/9tFkIKGQHat7qmVtVfGSEdCssQ2C5ksOtks9x+DaQGPGlZmWg9Hn678WMuPy/LjSvmBZpnCpWGxnyxbz05GiXxDiXxTB16LLGtPK9OhfgmTz7rotQAkag8HVmcUJCfRX9fkxNI1ZagRsgx1bOkP4WehhEqcVqoItIqgrCIoq2hogU0leiEqqsPWUl6fWrAyOakjVmmVTP2Z5xCGSgqleOK/EBav9F6gQxTQEGkiMB7LmsMcQbG63rm3s6RbzpIFnUeZROzCCYmEduoEl4mIvWUoWBP0t5dsQWh6UjThKQpK0xxIMJeScvQSuSGuh6SBs66QpG/1p7ECOrRorg6ZmRUW9LUS9AlCFiFLViYsWZnQsTIT2AjQT/IcsaJjXdXtKShcJyIIBUNSI6/aoBPgQqy4UK/gQpJ7U/FAnZZNRwO5rFweJEHGazVdqKZWAXynmOO5Y3wVDgFMuHgdVC5eq+0Ove5rz+ZzP0C6So31fis6g/U6W1eFPf0YObR0X165QpwJy72D6sVrvOD62OjF64txHfgL9uI1XwW1t7gCZAjFwoK0KftpPf+vHP9PXLt+6+se8bXr//MuPt8R+rB3Pang6Ea577+Ux1OvwlwjPeZXsbiZ/SGuiGZ/hF8ooPCE1pPdeyQGOXePxEBqedFIjKdj97xNjl4vEZ9v+oE6VVSpXzWmLi/QJdI7D9nbnT/QsEiMXgKqqqsyRKRIGeKh34HzAF2tWggcuLuZRSruUim9A0+PGiafpkocpjcn8AMVmA0GHqH1JIhRta45FBcaokJQ13O5/sdrawKfu/lZ2oZ0Vy8buHq5wU2xty3liNlepqRU9e21nTZaraLayryXWDO0dUG10n1TXF4Y1JiqiRq9I3nvtDuSE7GYeXqeO6Mn5NnP6UncJzzPn3ZnUnstChzIrbV7gMF4rI7mRaobVFPhrO8uPmry7kryuZPJOyvJu6rJUmV3WjtaLvIrGlm99oLCXJ9/9Yx0Tqw8gfMPXx7wX+u64OW240UgrOFBvgC/95pysVX1lr5xCmFxuUiM9x2kNhHVQiL3o187u3b/2284VBMltL44orpX3qfOn/CYpsH4j3ymRgXylqJoW+9f95MXw9A37vvWAqzo8hXPMbXRyBEtMGJdY5QgZvPxaDGyFhm1XpzPkjR4DgZg5Ft4dhG99o18UevIY9jw71u/bm2k4zxj9sW4PxeJSb8PwaQfEi4iiRjSIvyK8ocRocPip7Am/kWX1JniAtMm9a46T5mY5ZkHZx0e9PIuzaFDW/jBHV6hBUgPe1zAamCU7nAvOsKjW9S+dar15635NtoKo+45idgNFKaDZTwRSgwfrqv8AG+UU6RqYnmE1O/MCzwuyXdMKZa4SOKiKd8qwFgRrzxUqLLEEuUHaO5qgGV2zXjagTV00jewuBp3inRjSRUvt9NO9pCDttIpCGxFg0kjibZp5LbUaGZypVvQj4pF+QCm69kpT7GTtnNeIg7DyjQnIOaLiHkAMaRZ+aWwCZo106z6sWStUQBfcxzBT+rxZHoIwR5D7bofKGJ+fxDvC4Tglzko4piaOoaFb11V/hTXjxF1KRZT1ju5V60b7v7tF+7+b/ddbJ8MEAvpPd9in2jjKWX0r9unNB3Re3Gf/4P2iSK4qZJyxcr3vuvY++3TpfzA1cE5r9+y/l771JSC9B+/ccFf4pz6H7649hO//58v/OPPPs0+paGfv/3M13/us//5A/YJcCH+FV99x3f/xdbferp92vhPfO+Htgy8Mz5onzb+Zx7MZmdnr7/YPm38pd+Ff7/xQfvUeG0p+qdL1wftE2kT3qakxzTenY/vOfSBv/rnO99vn/LpR97xrve/5W/zp9unbcbbv+P2g8995Zs+YJ82/vDi73I3/vnp9mnj/7//8KGlAx/6jx+0Txv/bOnGT19sn64722H63DMTyyvn7cPfPs3Q/cOf9IptD39HceqURDbND1Tm0nwTZZ+c/dsJ3z78HagUkifgIk9hQmFEpxHJp7T14d/zaDy30c6IjfJyPxMquoqVedU60u0gR4eyvs8Z+RFjoXbENFZJHPjhXXhkxelipQfzOD8DEz2Bdu6Zul6chQ8/LR+erbQXpfcowKPNX83gS+7F2fkZFHOeXVhbzlEdcKMldBbo6hOwJZlhw1v5bjqbZugJB7AbZxrbwStPymKe49byjF/j/sGAgy2evk/kgp9EZ+RPpjPhOt2sFG04oF7mn0K9h4E49BAHZrKM0aMStQZsXJqKG4FOXlCW76AW0/MnMTF/Mqh4/5V5ToU4i4hoS75EK/ksrUptkLmpG7WdNFuGT6GlMkwUlWEmLDSLEKNTTZ5bgVvbKJKXU2lJnqch8lzrh0zPY9mJAWKfQl0iBM4rk2mebdCXeb5o3DMgAFLMhWKdyrhQnl9MtZEAlOpyYBI98YWU35XPDnvcQkwArWuOa0c5XAGiUYJEuyY8hc5DBfo1yce0jc5F3DaJG3CLqiVyqmTq0qlTS4RjCe0Uvt7NfZJuEOJI4u7i6kZKJEIm/rDrSnSeTeTQcAmPJZrFY9bOmxwChlznBBXCSxS0Q547aIs8t9CKPFdoVZ6r1s/AjJlfNC/zC4+MWni06El4PImeTLvXGFeX+/xYpifiuyfSE75VRetGSHtO/xV8pcOr+Wk5M/x/rzPjmzPjmzMjSDERghfl5+NxKZYJYDmXcAaHEty8yVsIYyp0UNbZXNP5B1AczwgJPZHRdw9PiCfwhNj96CcEjU+IJ+Q5T4aCJ8IOnhBb6Inc991mUsxRnsdTJsY82PBNJkZUmRjzynwztkRmUsxWJoUd0HmDBkSKzyZep5hFbmC2IPTPP/t59//Quz9/sX0W28FFbuXvlU0RGYN9FudyomCXlgw8FHTV2O7k/CASdCSUWk4xsnMFsWXzwMjoXEG0w0PtzVaH1FSQ1nyKlKjTZBSp4YWHJpFaEfe4uD2Pxzw8RmFCKW7ngrv5o8TxJ2DP9gRqUQasfDLensw4ngEvn4i3J9JuvO1mVCeg+h58vofOl0UAqA557JPAFwG586yC2SuC2U86wLUy9rUYnxcYn5cZn7cEew1a0hZG2iQnedbEyf4OWuA+rmD/yN1azgugJzrPwJljyOQMliJfAqtZQcu4Sq8pNigYKQo6LHPUtzKAVJJSHTpLeqtjxtFIxbbxZMcMozRrRmke0Jehw3NuctQA1h12VBYA+QVaoUxGDm/MD+Ntmcc1w7C28AGTI/3gTDqLznlRwT/Ycr9yTX3unknn0MyBfAb7RoZ8TLvAZrMzJXxEZ5RM9LNyI7so4PpOvfUiFHKohZCYZ3kSP6OXwHUvjy9jSROrfQ9hiB5wgNk6YAoslvOFqnNf+JLqYbTPoB3cW06Cg7I5Ti5oXnawKjZAiUzIsKO1w0o14RGKnCP28tgiAh/U5J10pHM5P0KMjDmeW3WVqpm1OJenLKTn6o78agow7LpRUnKEj9TLVEBdu0Rj+QU90SScwYKmyBZ+ty3C7vA5t9vcdw0WYbZvujyDSoiTqwBro35MMl5zKkTCCbaAI6w5BkIwzUXRkiIhYQ91UO+PWkRT7/bUswpWKYZhGcPQFslah4ci43ytPOcloeD5toOXhy0qahAfu7TC9fOqN8WYX6338AJ3cAeyrAqESSQ7FMtapOv7KlqsS4NIfygWyxGL/KklvCyXoTZxpVyiLWmbfCtjeSot3sa5TzO5AX27f4xoDgS4S6gKE9lu5eELTPkVfKagrn6Wm1Vos5FxOQvkPBcEooycp1mZzPzAXMYjpwKPEfp7HSaqNXOlJotrOl9X+jKzF/BgWsxEIo/54cNneCwXGs0B1DBJ2iw4ja7zX+6JwDSwxxEPdPePSEoLnGsZyT35LEOSk7JYzaTmdWPiV91MqlESvW/bUKlqE0JKvV0sAkC1IVBDZkpAE2AUVG0fQOJZU27bIpTU3aIGhO0HmEpAfJpi5ofkQzg5gweYKX9DHBzOUirTfw5tZMAAOJf1OHRUaTLbrZtH2TQLD93Fgnpl3J0v4rEzb6hiEuRgGax4hJCSUkMOqXkUIB40KLdES9O9ees0VZ3CaU7H1Y3lIplFZWlaDvJlkizTEiMGP2ricZxfJYKXgJp0T0WI8LdP3Mpl1IvXmntFw6H8MW9dv3XRuSmSmCVDK/C83Dz3muduPRfuUiYGt9SKLSAXwBM5IDHpa5zxE/ETHspBzmVB7smFkHa+iAZJmxuA9upasRX0h/u4mNd0NFStow5iIeSKuP9GHGugLVoeuVXAdB50ARkusSYlLhN/Kbm30pKMMBKlwB7AvKKTE67mlB5I3kXMpEU1mNYAHJWB7zJCrG0U227Lt6MjtpENmvkB7oaUWnXYSn3P9ca0gigQu+GMVC+GRZycZJzlYIID0BRFL9Qkm5su1MVvAeHzNpqhxjU9oiHVrE0dbaj65IPwlpdgNHYt75KqXLX7B+UQYk7ICFMakJWC582lFp269pD6d3jQjmOif9IWf1S1xR+7YF1t8R/fzv7mtvidNyTy5CJwrI6OStc/yd6hCXXZpfCgiCbt8v85+uJdO+XSJU53Hhw93fG/4E5wNEks+n9ZD3NqOGkItPeh+hxO+vjCnq4Hl8G2hh7uvV3N3ZNXrnLgjiR39kt6FReDd7dXRM6Ti5yY4bII+jvETbjbhmOfVc2jaOXp3yRBBnPa11Wu8YTVXh76xdFePuR6KUnayxsRTPWLO0e/CAbyPv3U67CkoTT9LDW3zMVi2I+gFeUYlY7sd+0dPBTAv4R6cAdjyzrn18DgMiiceMNt9j1ZP1qqT2SOkdGajFr9FqRAUjWYFx9rk2gaKuBxziyJeaSqEvt+8OaL1/7yCb9D8MiD632eNWnJ046asg6lIo8NKKoaHhMjvQIw2AN8cfZlNdiNUTmIChCQ5CIWc1Bx9jbQSlSBiR+X6SSenrF0tkSo3RJ/Cut28I/agBry78lBdwtEqGVPuBvGzZvSdI8TUks3UooQWXoUIbk4z6BtK0rRmi7LST6Dx4KcKWZUz2fBUUMWjgUPIAaR09AcZVw8A9qCcn6q8fMFWTFCwnO3eZJ54kbny65hMjqrLu30TFEUqrP9GsVtnSP+47Ym8HkAXmiRT/CFGBon5Dg7g6cmirEQt3QBXZDhRu+Fr7VrxALAJFQzFaqpud2SYfdUesyqTAfVBAEpeY7qt6CWSL7H/iigTBiQJkF8tIS/S3v7wQlTxE3VTuGgAu2htFwGFhwd9Ppe2VCFjNrciKvLgCf+YkR2yQHuc0v5oRqJ2bUGpXY9WEYH5nj8l6RET3w5UiRuOZxPIOUTzb5OOtbUPkFJlDwmL7p2WFNlZu2YxTWFWcoQl1FbF77Q3WCDSQrfKduOmFjGUb86Yde33fp2ljXgxVEXKRoGmpKJ5a6LoGSF0On+TqapGmKr4d0ydU8ZIoKHX3H6o4T2l0EVVYPpIrU6cLRs6hsfT3NiEIhx2MveWxoPw6lp7pVWxd5XJuRexQoC2eb8ihd6r/SYVJduFI1DiNPhZwkfdtEURtgkV4duRYwfIc+rolOcihEZqP/zIxBTyqDopABY1WxcHiHO1++Md/wa6wKqH/2jYsdLdr73i24SiYN4WdhNFO4n+9k7ZcU56gd1NPqVJ2Xcg79/obXu8ZP/9FcJdNzepUYvxo18aF7RjXWGPn6Cv6Gg/7v/8q7Qmfn4FRRQBKgrEh/DAIDu1BOKWecdekAKCKaTWCF4Nut2S2EgXxHQR0KrZdxOUZ9FJtLHKh6IjACvuAKvgCIFjtxpzN6to61dCrJfrZj9UPNXm5u/+O+PxvzFxrj5C25M1fwH3sYMYLyQ0V/xVhk5g/eCWmL+p3/LK1+oHwbZe1C+mQ/TTMCokS4KNzEBM2pt5NdOxtqI2qFQLHFmKLRjxg7Fl7zQF9yb4rmrcmtAdWeBD1grgA91NaIEVIK6K3DDmLPvgv9WlwSxXqvqr+IuiihXNVQ91prhTihCYsNa8tFiGpo3AIJEVQQBeuQGTQrjBEuvu3ApgFtY0XiSTJ5mGvGQ9T0nbSTkXa+UUn1XasAjulYcx1LIK4R5kcFDZ1pmMkoEyG4Lcb7m8E0OvC1I/qCr+RckAoSma+J4LRHPoJrXN3kZlkIA+8fUdOAfQgv65MjIA46MvGn4EUGQ94+SEV/lEHVHT/CR0pMEBEDoyY/yxwyWQz86VHpSzz4wYjPIkPNIdWCM4Z/sg25y4/VoZXL7X4/J/aGJyf1AdXLj7ZFP7sM8ueXDIPvw4zm5f/0RTG4du+rkfqCc3JdzmdVJHJrrpqGOiY5Izu94FqGdT2h/9hHJgdLcJEqfyjPHTRSUCviWjpAZIGuFbz713RxBd9Nv87xN/EYsrI2pbCIyGZ95/klO4PCkJ/B0U0rVPoa2j8kJ+4hi0neFbE4xKgV+tco1U0zYF/ADr9n5wRUa8zxSfCpwXV/DolV9uYYTCrHpwdWSZwvM1WmcesbZJ0XApYYSA2h9Ek/XA/D4Um6Qp1p13gX1+JAiMAXMjh7A8WRy4EV5w1IK7Nwg8sDfZT3cDMb+r46f6MDahrDjAZSf4UmJmhTC30KD+E+2m9dJwlUvOoDHs8VqzoHsbQp/SuRitl77EG+cmXa7ubGuDm9SdYGTotwDG2KcWKQCOjukd+RXnL0yY5r9k2wbxe1OUrQqiRBytI8MixnUtLvoUIdmruyhImw42zA23uXEmeFwWLSQZ1fR5ugW8nAroLwrNTAs6gY2eHSlceD2OdA80Pey3xaMCKmBmaQZjeRHIIXeyrh8DROVAmcm5JtYczysgTzg64Y1v/O6f2us+eqrTg5rlHhVseYSu6z34wN4yuerB7CTspZOMFYx1bPfRTc76UT8RxGffiHwPWe/4DBbL6zb+8fEAr8HQqpPEUuA+38wFEDkEfm6ztXBrNX6G7B/zC93+2uokYEQSVK2gV4UHixWina0l70HMcC//sEIV6sk+EAILW7sXuuqzl8XMyBdmwiSjvLIQ2cAY6wdf2D3MKQevkScyN3E2nsTOoz23RTxPQ9kRHz/Jn9N0jT+6PU2/uBIvLoZqqlkrIZLmNxz7r7aubwFeXdp/z5kSvCAAGXs4TL2ommRu13kh8vIndMiu9M+b02JLGO06XUeVYs2N0Vu8TwMDz32ghm+usnjJxOSg3jG8FyXAHqH8BqyBBNPY+0vwHQFxhXxixT/Cgzgy1AAGB0kcwpHvQSF9IM1Pis+z78aFfUD9il4QHMy9srFsBdQ0v80Zg3FB/QqjKUrq+qCafcBikRiFIsdvdxT77xWJIc0NduJzQR50jhhO3W+WcupMIeL1ntcq5Qu00371S08/crrFR5sRcmm5TspAcV8NiVwqibF86cNqRTlg9Zmfw0ypfkvkfzQcVWPB+RVpmcRSGuC7PP6wS7/6hxQbfCQoRFA7YS/vKcmdnMSLQQCmkTrh+wHwS8guFuC9yN4lgRv9ETUg+BDiCUJHkTsKoLqRawrwQcRXJDgTciQSfAQggmCoDWGQT2AGYjrix/D1HGtCjVWlzRt4GRso4xR/EwY7yw2fimcjo0O7aZj5Sg2xhVsjCw2eoqNGHHFxshhI+MhsEfH6wAyOQT0KJqKgDxuotDvOZwLRZBZ4lxgcI5BpjgXKc4FwLnA3F+axDmzSgW9IjguznmKcyHKPz7OYfGo4pwnrfGqOBd8Y+NcUMG533ucce6JXikeBBIY35DqKjrIfl9ZAkMhdNtz/C+OTfniD88JtrE7mNCsqrgoVQTVI6ONsSOjt7lDng13ZPSuypHR3WNfvM99cbf74iPlCVGid57143vGPv6o+/ge9/HHEVTbRjjRiMuQKiOoDgLptUNgFkLK1yAktarvD4QyhNrlda8ZhHYaduws4HPHKC75xm4y4mZfVMzR7IH9OC+ZV2ePCy/KFwWZ9TrR/P58Ga+7UWgXoV0IbRE5FBZ+UbyDfpNsATPaQhHNv7joUY8WXsSPhQP7DxSrqJtjFvczj1n0+G0/Nuiz1MXVnv3UgUoCHEAjtkcrtAxZR75Cs/0Q0nsfD58ikZ+oYF9xQjzB51vxODffhgfl2/VIiPoCdXUGsbKW/Z3kb9A8iEXeE851DmEomrQ5SAktHlijFlyf5Au03A8vhWIeLIKLJhhKK2YRlILhHBpdiOTi1qyc2WCweCqhFxGaHHG6+qo0ai3Uw5n1DC3gIJtroNVe3uoLbsnHXLV4Y1XJCvzGFPnoeep25GLyisF6ERfdhzhi3+0/WDt00X3nvzIv+DPSs2ckoLVSej7n+tBwfVhW4+RgGbGHwNCj96ti8TTfMsmI5jsYIh2jJ9DnmSa8Z4e24E98MeQZN6FBy4BOlzI10LEgdmaWaQGYtrKmPV0r2L+Pn+U7CU9WTNRjJbFr1SN/DZG04+HPe/kOPUtiLU+4nwNY1S2jL83II3dgpjoePmrA1biGD+W2Ux7+nPfwfe68rJilWcl8Ku2sJqmCkPrR1bs2Vht0UcdvDv2xTYykcoISI7rBHHNG3LKKYYhVLY5QnFE76+B2e4fE/ZE7UCvM3caAdqj2C3ivaxhEL2YvFu8toDtVUH5lLy9G5oA6FspTJD4fyMHz9Vltj7Zhii6r79J8TlBF4JaqzqHgULEKLPJflG9RfOkJzWGmUtfufNHcFx2jZJ92lOx+R8nuQzB1yOYbdYSxj7/gPtYkVUdQMrhFFKDMCf8vjZ3wuw81SU/4EUz70iScXRpHxn2pRnpNHRNnXLgXK4DSCrAUdjqZCBww+Im2S0HQ54ZeEPWwtZvnwCIIAkYyyX1aMDPdN+5FfNho8t1sXwFy9QzDgcjEotCKnnM/VBIloUg60fGqbqzUh26E5iCnYpoP7JYOgGL3QLG5VXInsjZKG6WkYlbq15KFSeuD/qBMgAZ0vAPq4IHMYrhntYd1BwScV2d4PQgYF42yPUUyRjHmeeD+JxxLTFfI2mEUsvC83DwtnmN3n+FP6cYWoRvi8ayJG6aLhm4sUjJONyKhG6cSntCCVSogXtWX89kKNZi1RGDHyEzX5Ix20KllbKaaeD0hK3VclOAB7TkaYJWmurQFgIbe+l6Z8xrebeZ8RxtIc44OSFjpQ4bpn1HH+CCpDImDPehnp99hb0tmmKBw5cZi3o3F4thY1HQsEiG2dfwpZNWf/LxQsWljlJ8K4X1GC1gKF/OIgegTI+P0vFz6qeQLVHfSCkUjxFzByUOzgwxZNzE77BxRfJVz+WLWQHQBEDvVQHOHQK0upp0rkMoXpsKgNwaDOsPgGkaeR4WPi7SAP4VaIjDrAR8zShg0mJ8oFss4zYp1kxGMZBQI5boyXohf7rUvGW7T25cavxzF3POBmrqiRlbzLoK3El9wdwdsNHmIwuv4EhYZ9UDrJq5usTOx2HkFw3E3afhyDhNthrULKHCBOlWv32rvoE2rNKNMki7jShtXQRsxK5V76hJ/XNIQnjoLec90CiwcZxLPd0UBEReylataflUPx2yGePkH+Fus/EzjdNNm557hn1LgTkoziJyhlsWNt1X5J7U7AARBtEwnyxMt9EP+xDFCWxwjFI+hEVgVc/X/WiVFyRjTA3YRf5f2RBiCpYu2UKxsj/RSuMcef7ZKMQGlKtjyXxgN/hsoGKO5vjgypkTfMTRkGRowzqo4voP0XtkkT4OJp0mb8jQ9gK9n7w9n1NmEpwkYbUX1AGFjF5ZWJnmaBIUzNpjhoAXduC06QC9vDmiANaNFwaRV6nIIkOvpjkKGbpmgIlZhlkCsBCorVls7qqTCFiklMlML0QkCRingBe9Yp6hwiyZUi6q0aJV4yFWcUAAzVwCrFcNuLeKF6YMCTpitGm1VdXFltrqO2VKbdIbZig2zlU5ntuYNs/VjY8yWvCuzpUFhthBMFcGrzNbYx19wH2uSMlvysahI5cuG2bp5jNlyH2qSMlsIpn1pErZ4B8w8k2qU2VpG3CSzFWA3BWarcUBn0iraLgXlHSEoq8psdTgguzOMyWLu06qu5e40nhbMqE0yW4uIXLR34y2z9WMny2wh5+bM1vwJmS0d90hPTt7n4VnyVgFMfm14UnmFFZMatzhYAG7YdErb5mWxA8yLubJ9xcLEdi3l28V59qgWu4zm8Xdpz1KvOVpQU6kdJV0rQroWymnG+fTikWG9Asd68eN9HkOm742wX75swypUS0nTJBNmYzOaFSaMy9tAebKa1C0jppPRbMaw5awwYoFb0pRQLWtzqeuIl4SVqM2DZs3T8qXmRuryM4XPyhzY5x3YV0fBDqzl2jM1PoM9M/GjV4HBiq6Vhu1anSRf/gTVYqJBnSlUSxXHj0u0wLJUKRaUaCsAZGlKvqBK+EYLcrnKfuo8dGiYKdFVBlTw0UNvHGC2OMDMTzCgwEcwX46VAnatSplbaP4EDOgquIl5bLVOzIACoxwDGigDGmSKSo4BtcqyVQY0GWVAQXgMAxooAwpsWQCGLJQYAro1BQaTDOgCpWDC5x/NnASy4E+htgiYWQZ0cRoDOjIrq+xnUGU/gyr7GRj2M6FZMy9PlgNVOG7OgS7YSyWLFQ40qHCgAdFm03UV3P6qQUydjjWgroP44ubTEaDu0IpOR7PZWZw26zKZp6OzLmJ8mwW+yczzdeZFozNvc8xZqHIJtDyNgY6pKUuAW/p0ys2bpS/G0sfNVV5aMGBZP1gQ6re6GS/Nc9q0scgpp+LKzVjpWJpllkbLSqu1OeuRu6VZcBRr5fb/cGbc5Zsmnpglq1vJ+sAbk6zfMiaquUnewT1oknIPNyNoL2OMfXG7++JO98VbEbSSdSPEH/vwbe5DTVIhfvlhKES2lF7HKgq3htJ2IpSUEu1GKTpvloL1VOXwLV3c26WYfaYUzHdKcXxWiujVZTdCc1Uh9bwKqRfkW5WxL7CuPTpRZVEog8yY5l5U1A6UV4196Oof2F8IYuRzlBI34QC1aJnayLgmMuuUXxnjDuzPWyqyvks2y76wihKs6XUktTXWVp4f18mc2NqY+GqPiK0bLBTPu5TRHC5sNikFLcKw6adOYm1l1r1RmfXiNJm1XW2lnHzVibC3cikottgm+cSsa9ceEOQzrmPbXcdS9MhdlORx2QYBdjzVgFoufE1GMf7UfzCz7rPS/O2Ucp+J8oL/doBorFBNLbA0phRW5DvgW54YRiimWe7w5oxkG0+VbNcMuOesZDuHZDvXy3JtlWwD8mKPg2aoqYKrUkSNq7NUyrLzHfYuX0fHaJYK2dfPqvzESpq2jQqat6IOWUJyI2iuVQXNPdrK//VY0LzVXMetCpp7KRJF0BxBvu/Tgs4BjG8xU45wvk3HryHTh2GLlNqL8tYjFyk/CjnyNnGw9qjlyDVqTZEjx2Ny5DkAYQ6TDpLStCK8A1UHOoCqZxxoqVykJgxemrdlwjnpcRMLSjnp5taKNjUMuUbkqvW7P7eZ9NhtZ9ot9X48LjtGn6TRTCrmQB64TTRX3c7oUOt2pm2X4ERvaFIdv7ybvcnNd935Ga5R4pVr1GGPZdq6abrqpmlzbJq2KMY0nd2EVwKOHvYMsh60gavN8woCaZzFH8tgatLMGVlSmyBzKyQzEYODq9R63lcRwoD+2Ump4oTaGugeylGJDGYI6KCCKMNsMBxPg+ZK5im3Uwouk6jmuKfclDrOPI0WNQfYz1FLZ/GMMa4ijJO+HMQLmZerOZxpWLirmj1Qiu2wxco5NR38Zxz8W+NkUoQvTQGdnhfMSEsqBENJYFMgNjdGSKglmxbg9FZqlLdcaW5c4LK1imnAdHBQbWNgfCvYFsOH6GVAJS8ezevptpCX1JGX5enkZfaRC1EeheRkGT2YedSSkxrNTpGczCBugrzordGRzdmSkJeOkpcloL4yCTXKyqGoOXmJJS/JJHnJEMkTCHDv0NzJyEvaLc8RGOTclMDMHpfAOHkJFqCWapq2SFiEthGXdNWkoJGW5LOOb65Ij7YBYUViorMPss6m2zJs14ZOQ/yMlrFRjY192ZVHSYBimsWfbteWhH1ogfZsg8WRjrlR38Hd9+pmrSYilIL4ic2Xtj2XizsqPtBRrDkRSqMUoeS0o0JKNFMG7r8iQmmDo5iDIqsKANrUhL0UIVzKM2Q6zVZpCcPiCEvNERYOz2hraaWUoGg4Q16oZmDXN2MlKDMqQVly8M82hT8oPmpXQxTg1ogfcw4CRngqSJBNIUkqQKlGCi2aNbSoVqFCSpNGiVAyRoQ6SgOVFDUAvpoDX4NmsCcA+JYAviWacYdSHYeYSw4xY6WlKkOZMTKUKmquONDMjoFmVVEzU9KMv1JC58secLoMJdctbkwdbOtmDXHmXcv0vLrbVakcSLfFzbmKDKUgxjaaq8hQcsuq6E64AkIQI+BKYfAoF3xpAkeaJY5M7f/cWP+b3P//+eh5glnlCRRmmUBsDlMyJjhEwWxAwVjBqT0+KXcbmQzCJHIZDWcim9EwxCcEpfTHiQHAbAVZbtpDBaRVuYBalQuYOlkdF2AR01q0a0ydjJ0pk3GJGmYyNs2k60xOulhmaSWSOnkNkw64JhPP14lXG514m2NNU6ecIUszbmkofCUnLZ1f7qygRSnWPhj4Er5UyKseUWKCSVvmzIg0qO0EJlu5MtsoUU/bqgITXZsgMGmDZIAZS7UdxoSYX7HnqW0rl6UVd4C/SsL3epWViDp2TQOiuV3CyHF+5I6ys7FxWaJtmAnbzSK1/ChnxHZawZ8eamPJjCjDjKjTNlXdgwGHWZBZbGEbyh/rjPDNMuVXlinRsuiMrFHMVGCzqqsTtqeTq9OYlgVGyKfULU0ltJfs0rStsjT5FWz3UXCsLaTlUstCw5nkXcFsWKHYkem0MlBuGLBix0qkMXiOSOvQzG4+NCs6NIBci5r4U/ACSQSYxyXSS5QCczPueofBsHICIt3wHZF2wgUFqSPSVtOiSqTDsem2SqkSaYVorj6kAK2mg9ZE/6cS6W3Qssge9cYtxZ/CrAWIKZFeotY0Il34I0hZIdN+hUz7FTLtK5nuqI7FSdNoAPDENHqVWlUa7VdptE+0Gdam6rk+HiVyNWCnERrMKGVLlbJhtChW2qGULT0OZUO2UobTu2oz0qYk1koVfOtddVCqa//PiveW8DztzgVBV80wwA+O7i+6F8gKFJk5d27FQ9xO9cFBHmBdXvLC1aXnFQEFw+zTchkJWtrQkv+16/Uucvr/eN4Uj1IBedazrPesC2s9DvnqAiqQS+gLEsLpbIaGi+2l7B69b+tMVfy174XT7rDiv/Ieq14A1st8EdtO0SS94FeEHHuZiYs4y0v0pnAAbz9q9g1N5WaI+zV1iMR+FaFtHWLuBGgb8dwRvy0eheoT59Ke8cudfVyvTIs1kc1rCbUWtEkvHOBHr5gX3n7on5N8ESGf3odQAyUYzuotaQ8jZjz+AJ4h4Jzow3kDyj6hPv28FA2Sy25I0z1aWDXe1EmzT+p99uc/mgvjn3IXxl0V5X1xvIxdF3+q1GKvR+kQ7mfrPPs51/Hvck9ecde73Tpk1cvdaIS52/1dnj/tToK6ZJSL9WfX+I3nk/VTlQM8ehAgd8D/eMq9hT9oN3w+Xwn0nOWV/Pvy0rbXIHCTQHD+UKCT4SY8cWwh7StCYWjcWfL3FvGFtdcij8wweF896pFBbvgBQOhGH7/wJxO8lDyz5/6Ip+d9uIOfCBezARRy92Ip0IsoNc1HfA//kJlGuMP5gqIhrTh44zl9SIltM7WFjQuCw2hVTI19f/yKP/mHY1/6wIVXcvhH/V1nnfEGeuZVL34xcwYX1j7IA4brng1qTLhTuvt9w4FUov+eD3aLs912K/798cVDalAFED0YULvL9H2nokporDkeKJKy32/ztGPUfDuFbzdUAF8IfJtrTPcw23aTBLM/wUDmob0WCw/KRUrpKxHaJaFrf+2OIfp7hZbVlEWnyfQvOwTSl4N6jQxL/YTDcjeDuz4yJtSiyPT8PRcPhzok2Z+icevo+PNURjV4RymjOmpE3h8BKVFDaLdI6vT7x4ckDdIsLcR6EHIFShEbmxVRtLmQO20h5/nHNFi1Rna3RhHn9D/uqpMqVHh2VGrGtMfYkq+dyD6NboI9+QheN0R/zYP+cIkNtzJMkEHybxQtvly8T3DmYx/ri9G0mRK/sr1DAHM4oGRjaOJ27h1emYs7Qm7Pd/elGxTqiPsUORNwfY46jNQhxj/BT+2V7zHpF8FE3Nnfsvr5z5y3crFkHXzy+kM8Pg61yQWv6pXxh/eSC17Ze8iHUQjyLunJBd/at/Wy/6VLHPFk/48UAGrfhWVCbqVXQXyJzt69+tijj93qMu5+ICCEoXgG/dcG8KSj4T0cfECDuDD7BQ2+DUvPvRqW22Gf1vBdiL9Hw3IV9+Ma/gTCxzT8KYQ/quHDqOluDX/QMziuKnQyLUAA8oY2Tpf6Q/jiLAneK3d9XV07y1ZS2fRV18QugnrZTnmFm1BU5upLXFNDCX5SaVyjpHL/G7CWE2I0gY88Ar2LyIkN4bNAHJATl9cRA3p4NhNhXRCUVq9VhhyeqVLN9EFPM4mrOSWXZpMKALDgXv2toDk1bKelPhVgOadw4OCCciHuJ9kbsbDlNQU1NbK/uFEZoh9/Ay97GpvdhjxK+ZDyWiyIb5Y4E5t9RnMwBH5YF8p+piVbcnxR9skbx7L8hef5r8SqLdYOKNBL3P75gazd5wfKQYTPuPi1RfRqil4BXQV+ve7V18I4JqLjV1P8CjWm+B975we7SMqvfuBRsPkH6ggfOb6rzQSKglfkQUtn8isKjpWU3jO8a/Mg1Qbuxr5eshM+CF+BecJwVN7jFQWnSTo+kqT0Vs/3+L7hFK90YkWTPLWoov4ueRem6yRY4CT3N830Z68rMwVVZ3GBWwfvMMFw7xAmTF1C4RO/X9lLf89znO5BZiFiU0g8wg7Em7IDP8jrTtEoV554KkMQY/nCI8GN2nof2FnHy+qzevqpOubFTsB9FWlp+IzXQkKLxRi2ZxAehnLU2iW33HLur/S8SVNZgJhhWrN7la+Cwbo/1yAWaxjjU5Y3PN+HbUX1aYlTGsG/0nrVZ/QbMMHANB+GLCrGqy7xPDYca9k9ru4v1OwBgflAF7L7ENF2c4MCnRQYXzspKEj/5BvYCK3ElAY7K3Y5+iGK6IEOYS+5MVyfapT2T/zAu67xyilWgqimgK8p4L3TmUAGeOwpxMbs/6/3jOw67FqsydnvQsQzwtdorl1FiAdxAxmhvqtX1DFJI07PE1nSsmvh6VAKSEgyocyiyYXx3/+vx9k5H6rNm1KtmmDFblotIXIGvMAc5XejaC6Rmt+Vt1NJjlFdg5plUvpdeQtJbfZcqO6uwA2okcdAiZuf/ZWgFJqfa/MBbHxeRNPa+N2qY5MHmET64jsEPI/xv7qfsTsg3ZnqtmYC0Gl6dvUzQQOzFzL0Bt/W9FvO/ZEw9LEHcdbTydE0xVc9TMFa7byc5oFWgb2PonACzA0YQprQspsiw0B5hn37O5lEQnQW+As8u1jcEFjlQPaA8th4zyi8sIam+1jWYXku+yJSTZGB1cXKvuRis7+X7yPz9mV5C8zbP8hbLIeZZyoHLIyiU5Y6fBeCIRamy3obpY1fO0W+fe8AXwp/DJsUQ0eG8Wo3K4OLhkOJkO2H9lxXeNfmf1Rqcgfm7WCAWalMhoEDRwfYK1xZ+Iz7ylj4hlHYLUQidXpTGIz6HRQdKaLSPLCoX8WERq7LLIEOmgwKaEKkK2NUtl8YY9MFjeHi1rFQeqUsBS2a3JhdNBykv+zDhBuGHXcSLPYFQA67Ua5VN8o13SjDn7aXKg8rdEq17EaQQwCS/ROgJe8mnvh5FT4GhGGqAfGQTpG3Xnj7Hvq5L/7hc77v8ovJBa/q7ft++fe5i4fgpU7cLjTDFO22W4XH3462dRfq9qyOYWWf4gpkzs7W1LskFxfKT/P80Xnq6zz1s8/pp4jTVDvh4Xv2iM7bExlPO/oKGE/7y6nG04ae529iIe5Of8yMm3rnvt0vAmkdFsuBT4HzgqsZDlUz3DQlw25ND7I3v8pF7jJyGo2sEr9HSMVe83iaxw3Is8feauQgKO3i/rWzi6ss5Jhd3F/wvfpJWoUMf9AahUQeDxWPG5UtAsgjnUFZiA/FNBU/686k7OdHrEC6Ow/SeKwMEep1lcdc8H7BfRkSrEqBygtRL8xR4osWvpRQAs5RvxVrx6H6Io8BVa5EalBI4IG07AvOyqTyi15VWvg3j0Fa+LcT0sKwKi0MT1JaePVjlRZ6o9LC0EoLb/SYbawuySBX4Ozv8fB7zFrRv3xvSWmZgKpI3VnYLwPZP6O/qFUs7PtjFvbJExv7Pv67baiZ0fDn+z4LFbkZZ8HameyqSbpXRODDYopfSRzaI6FrEaQycpeJ9I0QL3tQV1QAWyO+onZG0ws3pWC//IbpFKycsL9cnbBj0s4FzEAcPIjytLIKhiHA7ZZpCKPsF8ytYWIdoCD7F0tDd2kJmZawgBJIjd5Cz6MUAiysKQKHKEC4+4dGTxJwShG47jq6K7hNJtTV+/CwoUEy4Ins3Vmt1jP02XrECswRDDJ9PctO0v8SgL/zr61YcbdVGQJZM3Y8wXcE+JpL4/AdWPyYNwFHDsouNYEO4jtTQfrRIPbsZQG3Md69v4gs8VO8L2Inc1PLrkCZAxsDRQ2040BRVykc/beB/4yrqkoIiTreUQ8kdkuG61CK3FnJ9lgrgI0XFc234+Aqe8V7ZJNDdZg/PLBfIrscmVI65A1Qi1rOpUKPpYXQ3F2nmH+yh4ECdi5eB90eimDAML21jPzedjUDkrOiNZJMqIi4GtaHiPUYJwb/gc0wti4M1cT6/FdnNxWI6JldxDIua69rRMgTwdZiLDIevOxc6//aTUyvEK9SHgWSJv3o9U7Oo/Eq5gF1tNvVz8RhwCYKMZbuMMIOpfMncegoE7bDARhcNeE38BCW1eV4Au23esScOQQBVZlCRJHKBa/gwIBTI6Rmd79B23/okK/EFXY2b0SlMeIYUDgR4ZcaXh9KUVAdhyVaioq7EQsq/KBP0SbGFe/31bb6yzTn1cbiOhrjwTbaqBuNg56mw1ia5L+cHwRpqzz26mOPPnbz40OcZ5d5kn7yPO2hXNE2qPI/gVoMUnP4oVHMsmpwwHxno++p6FdF4vs+9tTrvv8tg3+82O5B9u4dQsNCO6/sp1ajKKDRuv3y9l140+7P/PD/fObT9cDFJ7+MudLd4NC92ApFWEtvB1hvD3QLZkp2e4VY9mCIvskzikRgHa4oYjyuKuqiiAVipiEQM37k3nEJWmoJWqpGDiiQXDJ5RsghT/DK17F+7dmvPaobRR7MPS0AEzE2yrIRjJ2SjEb2We0GRWogzcR+poy9txJ7v8QqYD+oZ9nIcmMgE0ITlItGuJRrvbkdh0wp66Car7TWaIskb8CYG68/e68pmpqVmv0HAnA9X5UlGEpT0b6PfRT/vnDxkFM/glSsVu+5YyiUzO3OfvyTp96fnjP79OFA5azIAcup0ZU9ftazrwkmzECfLTv4eoQjgBHpTJ02Ampy+RvoyrsCUF1+uxuTiuGCSdV8xu2fv/7o3a/9ypu/ygh9Z0AzTK7wU4MkMU/wsb/GmaENO5Nn/bsfZOojCmco+GvS8NnsetSsRcM/1pwexoGOzGONnoMlvGJBnbgsICF01usZxVRbWrcPklpUY1JUQfM0QymhQe9i7H0VKjTNQ5VSYUcaXswZ/1SJdmYOPXlWTzzyAU0y+BPJqM4Ih6uGHLhF5Guz/ResieWLOi1SC5vS1BS/IACgFscjpafb+KzfuqyNTt8VsE6d3PhuYyLoRyoTLTrA4ETYzTYqEfFKTPPigGsOsJrFRU6OxbhdWcxiFcEIciA2JlTMlcREJX9t4r8re9Th1yP7umfv+85/yRsov3uACc8/8uisO0oi4oAOTi7vDGS2zKPX8+Th4MGj7DKUrWxuix8z2Q2Aq3SuzWnAKikihLR9CT1DX8GmDvNl1Rk03c30OMV2Nxvp7sIj6C6Pi/HkaPscAd25IUW9x/335WDaF/EP1ZQbTvqebh709t4M+RTrbMi7NAtDiP4BXBbPGEicWaDEHwDXeFqgjXyzmddWg8E83W/Ex7jL6TsQJxa+xYoF8e69A0jAb0H0Ruk1sipO6h15KOiHL8VmdR5+jKn67UDSpPGr1L3DCDa+xKtEl7ZQl7rM2Qzg+hPbvLKrRthcM/3qH345TrXzMMU36+gKhRBoLuWh83MYDWl5/c0Pxcgm6Rk/+AsjEfk5pkM+rmvs5IUkezV6j3WZqEl1RKPu7DU6y0+HaoSZvEjbndelSP8sW13diQdkNo9ESi1QhjblJnJDDS9n4byPC+tIfE3ekr6lNrPA2ER9goaGpa6XrwnWiITqeNR5LhM80w7UvIm6ZG6qVwy8kzSCyKcOuvta9IuJJQMAkhOkreKnux8bQjGonep092gBGL4g9/DzTCyVYDoCYZnGAc3RZ0MH5YAGXU9M10F0gOHXWrfV3AgFzgzVcQ5ad/IW7vFMv6VYqqsPYkZfU309JOPS0MUGJOr56VtC59fiqDOQ7syak5o17+rbgr611Oq3DPbrlBLIC7fQ3GBWG8GCd2ARUVyM4RQxJxTiEnSDQySnvzGclTRhGTVAB8/VU+vdqgZzVrl3uwghNeGs016vxyTik6ouC0n2ep2RAdfGOVWcEMBk8xuQIPHAbalgFY16m4/fO+VITJt5Vl5H8QiyGkSmssJYtNjqFGY3oSAUG/dvNlFvRFSqn0ih3WepMEPEc5GeYofSFR4rbc8PS3tEKBS67/abLQCiIwEqItDsDD8tbaWwRgqgmgOQAg41oMKQfK3oR1CRS9DIw2Vk10X+qEZWHFH9rO/FFj92u1O5kALIMEKcoiWlDhlwwmP44of28yXe7J4bjCyhL83EqRwn4/zvp99Q3oLaWcRGMIWGxFVRotzPrySvVpN1M1vvH5AJhDn9Agk1BEax4ofupUkNH3nUUCYSg4KV9xrrmcyDt+iXXbM2dvAeq3FhIQ+YlcwtNLCJy37mDTp4u0sXWRCJOz3CWin2U1VCNJWMGFCw1YM1Ke6Xym/HBJBiUKYwnvGQnXUUSy8pIrMQAwjeZh9frR8bqVgHATTISM80JnunGQGvIpF0jTfSSIYSIDUpjczehc/LRj3SFmW/gs9PZDP43W+Y1KT7shdCuoE/o9PpZ7+o2xy1HK4Hq5x5+qEqJi5nUra1Eg/C5c67/Kkf45JXCJ4Gq506UwHCUANslQQHg7xOMdLKhMwmxIqIHiA0hGuC4ZHcx8kghwY5HDiF4sxPKUCN6phbjINgyD4TBU0+s6tPV23VPlvfFdx12Fc1No/U1peslKGqTrBWt1r/Mue6Sm3yCHVG2ZuEHapPL7b2SIt9CYr1y2ITW2hDC5X7uw3xX5GyKCVv4ZEUbXW/KZd8U2SPkLnDSOK2oG2aGa7jEsit+YwaP8soUb4OQux8Dg/2n6+NVQM9Yq2tCDDjuWnwR6xdR6c05BF/Ll4TF2iOJGe+aPq7ILZpi1ikzoH4soALSuxNzSonTkBpcc1pa0IORCIjce8D2bzBbSjxSfu6eDKU4hJqI1mHXVcAgaMHIEb2/n8KEKeiou5GomFGIsCoyEg0kK2h2SgSxkpbiNaHPCHzWOCl3e1fIf6KoJHSwkMV87GLQDcHMpERKNq6G0+wzQn4YVK7mtqSVC080DIdKSOfkvK0SXkRdwJE9fTNdS+Z4gpWT7qzzY4OAAKLVbFiFWQOJWRihYw61hLIxIBMrCIGwXl1Smin/L6969nfVLy/Pmmv49NLRrzAYiT+SVHFAfB/f3oIjIcudc/WpW6fvu3Vtz22mZFrJhexqmQz5ACOpO87/KpDKq6D4qosgNmPGVbhI7U1yZfdjAhdPUmXx9iwjoi6hLlHtYMSyvdoaihCQnkhedmpLztJmI9MOQZgqizUxtfgbq5uj6nzx6URCfMJRWSBhwQ5poU5xp9AhuwnZaI3JBYr/4hPWnU1yrHZz4A1VQssq9Y9rp76FKkgKYXqM6fMQU1VWxcT9KEK9UNpnzmZ4i9uccxoJsxTiQno80Y5ouvZL5gR1hHXNZ8LuEOq1LnnSsFiYS3+KMEzonuWlcqZXT/gZIzWGuO+HE3LgU3EA6GOfIGKmtN/TttTYwixfJAnJhsllW/9luImMuKmgScvHEohHNO9hoKEH8rnAzQMXY1Re/2ICU3MV0weBdiqjumtiliCWi72No11rlOplm54ojiCP/Rn9CJFdbFVYhpYV0kQotSNvFs1BoJKVutlXzzr4lhCD/a97+c7gQJs4fwsXJ6PWCFImM2Yzyz9izgGpQe2ktjchjEGBvjg3buuv9uIlMP+/RBMASQyJ0PFSBwA/SZ6rdcngGHqWi59dxQ3eOENjPK+dakRWmc+QC/dTsJcaCj61nqpmSLnBRrrGG5mUTOfafmpboLMxeQUq0VHVoeMMiOOyIRuIW6WsuqGP5MLfBk2/OuwD9TvXJPPCwAbgNV8v/MsU42XiqCEQppzm3ett6PwdFv4Fnlu417HKM3gASFlHWBKrNPpppAZzVNUY9CnlGkj+dQQcGRvlj2RhGneLKmBrKcWfZqKPjCuaXDi6qeXKjXknV2b68GtPnXgzbhJbINu9wvzLi1geZrVA+om1mVI/XR9uhUgHKhEcQsfQ3WM7ID1wjNTMrEoZmk4ZKgS57in43R4aF7XM1oGw1asmJQFFrSvcKklsRiY4N7ns+92Vvt+1UsvfcGHT7noaXDkPgtCMg9LifNy3Y7RoItB7gIZ9Xo5eQKj1siwLJoxWchulzGYM0P+txcPQUkYj/VqGrMwMOSYJyIWEImAkxkcDstjo/RXH9E9qKP+CycuQklk6G5CYTMveiYeeRy+GhFrJ7gb9bFb3xmbq1FguNzVqI9yAsd97qO3Bu5i1E+93l2MeiSVuqtSIHRvQSkg5XhOXmiCSEJVbsYuNQ2Qv5Y+GwoEnrjd0vU61Oo8Cfelc8b3YqnLqbsaq7Ll2xGppe/wAqUb+/7z933qU92/fMn/myPb6Ln+vi8//PGX/dWpX7kY8lLlfJmzRSWyoQEbBQZbd2U1Nu0Ls2a8k1TSKTePOdpHF+sdSCXUizZmiV8yY7rliASzE3Bi0CEeuCB5z29Lk19cVRYaPanXK9rgT/IQMbzog03xyeMQ7i1gaAu/v5v477KeMgRmWIRI6529IyplcMo/LxIdCrXz8GjgFJDZ2hZCMaWnHEqGqtknPXXBR6hr9EPTfWJObvV3vpAnEDyU/cUX9zy37QFFzEQjSVUc/2fBcS/7FzzJyx4SLB1DxYcVFW+A/8Jg8ozdKtlO54ixNELUpGePiToiDPUAWLmu2CC2cqNh6W20rsav5dq0jHLD7PH0oASZm3KcRlIaNSAr7cDlHvZf/HMWKkrYoxivaiKL0/271v0GvKhIp6UOxUKdKIroyrNKlfgWaCOhrnJ3qXi8znSrswuSSIQQ19XQuWBf6lKVsqpa1VlFC1Wldhlou2VgyprjY80Z5jOkMkuUu5eb1L5DDCipbqDsVG/F4dqAGnjvDKkpa83M6GKApUB5EmuDsYWpqi7tE1DzpDoMWN0mzv9r6Wc9r7mZjtnCqI7ZztLxMHCQy7KIpBoxsfJfqm+QJ0q8Gk7/DN+LD+ImjkhFBe23uByeqX/xxY1Vp4AmKJyD/4rwYUNcEMSl7BXyWdUlUyR3zogV16c7I75I9bYACjSCD0KM4OfFiDvaYbUCUfUKZRphamHTBWNKj/pjNfSW3vg4KxOqB27Qu6oq4Vdff3xVwh/xA1wMjadJw9zt0jUunG+p0KGf1W2FwBYp4c8WsUrb6yIMtWJrHVtUi1xxf+cBcUoqsuwo+5qRZHNB/MXscb+4Wb44+Ab9QiPyxmjGPJav86YWOKcFNsWwY4O/vt5+7aJehaiShde1DJPgEVLpzXXT3noi3bTncEWjSvX2ajXo8xAgMus84iHolES/wvP4ZNmC9O/86nrhKLae22Pj67aotVI0PLqHB+sbYXsIRWkIN2K9gWDxYTRdUgGyR1gJyHJnzXzws/hABJrgCrM79RWUOia4fdaNGmZ5AgZtgfgn208wE6JHJZrZrCU8r9SgJ7JJXCxjgkdYhLqBVwqA73DSLhf1oFeiG1c5tkV2DvGTVPgLj+7cY1DIknC84eszfb1nuFnslbP4p90s9gTeY7P48OPemAyiLw5Z8yeQtVXpys+dgK5cw9uAfiYSJq/wIZD1UDcWGqCFcOX9J/Jrf3fu9QOcWKlQ/bmqI6huNnnHwSFk5hRj1oKX+dzjR3AgD8HXa7Sf/mwQJkZDcMotId10A3KbMjCQEOoWHALxAG+s4GSOBXyRID7jRi5tt5TEQED9vPXMPSPq8eUTisBQQFCnO5j4anvakv0vnUVGP/pFBRKxy0qNDL4vRhrttDEqhok9T1dgUl0/ziNFf7Utcx1oorchZjwCfvcvVefMOHoSviu1YN0wCgNbeHvZXC9a2ZvfyI169x7MDe3yz+vQUiv70alJADojp9RaxGi+db8aGT6CE+voUJ0SnT8VeeuJzl5+AVW4s5fHlSb/xutPQJP/KIC06eXgfp34bq2YZuW3LiayYsJTvaBAxz7UAQT3+lAHvw92ikQlUiKZFO2niM/gIDURGZDKIokiMAcxrDjhsxszvUMmjpbaxvA4tKj40aGmSLBiToQIz54JdPCTUqxWWjJlBCO19T+DHxulHltijFBsDdCkos1QGqJpIFI1zg3/VkT8Vkf7VD4ZyUlWx/IIeVvH0gnZZgU/O6AoKbR889lU9W3mqA22Nc+wO1srZLtgdExn4QBv35Pl39/z/ZmhtjeDM55MOmFixAcRN8LGxGKTl1JV5wswGoEZjfT2qF4qDvMzvBbg6uaJbXrRwGtT91aWHcEbBuLeTpHieV+nqBgJPHqR2KosbzSK07uZfX/7+aMX7PidC/fu+7WNN8YPLO2xgfPNcVKnHz6rR8wWPqs34NFMMQKpWmalmbKwyvWuvC1yx4MdSsrIcvuAxma9grl/BmVDcjUJb3A7Ytv/EdP+u0faf/jpU9u/+Ivf+uc/tEB7933Pj3z4H3Z9z6INzD6K9qOFaP9m7ebvG/3DLBdRF/dccpH2IIsSxElF0sIKTV6ecUMRPBrkWYp+Euw44jEP7R/styFSzESu6E5MKFKNbYuP0DosX67sTdyPuOvpwzJZZYAD3ksNuArez8fCrPy1iimBc9TGMxtyFgS6XPoMzTFBLYV3A5qnZJ0FdTQr+MYZMUoI7Hvhb3z1l1/+Jdap5Ttt//3RXE/5/Ovd9RQnXnL3U/A2dkHlhcwh6DakqpIvwBehyn4Wd71QPwyyL6B8wzKgiKpdH19Xe47VS85ybzLRR4gHWvXk8jpMmP0NCpt6B0Zvmm12DeazvhdMv5ktcvO/m8prRig/GmFoI8fQRpMMrUuXVBCMR1IFAG7Y2eyBkpkFeLMv6qvSTt8xs9i9YnfI1N4xspFmDEpGFuyOikFCxKlCCh7Cz4l6/wQji83ug2gWBXocgux6iOuPMLLVC+h9HqrR+0brdveu+OJlbxV0k/HVHTQeVqsjeTT3l+46+RtswcgNNn+TG2z++A022LR5cPQG29teX73BZhjuWBnuCCz3tGtsfOIS7xe5cCw0CWeUlWts4fGuscXkm6tqOlXkNluij1AfwKS3v/5419h+UUfjFz0/tIdgilOKabGcXqnTiQAPbofa9oiUqVbLycIhNL4PPQDMkks11KK6bpjk4nj2Dp33WgG+07EO5RVtZvkZIBCWIulOKi9FaC1r2/vhl+D4a48ON4/dQ/9gjr8i5cSxqEtD0QrtQPZO1C70JXKolu41+2Tse7NfVjEmoajyVqrAWzl7S+4Ej6SFSfr+k8e1binJ+oVP/PwnalNwDXlUWuXQ7eeRl/GHH2c4bHvPCLa5fRTFursSlOtuhnL9F7wQ6h1fX8T7teMi3nuR+vjLqdQzAUw/VPeT7z/BfvIPT2mCM1+5zudbQ8HLZ64LXh5dV7pjP+acxkhvrEOX23/ZmZKawsNHuF8jWWqE8EPvcOEvOGtRUopylXncV5Qw8i4gbheafzAuD3E1W1N8KTsLgcINNflUoslUHkZIVY/tmnyGEuRoUoP4jzcCLWQA59bar5kzl3mWEjDgLUqRkKocdc7e9hYdI72bIo1FC1qlF4lZIE2Gn6Yevfb5FXIje4DXLtNSpLWRpooQLLkXJZ8b0W9bZP+wvM1x3/FTw0TIPqALpIs1DmD6dW6ufKEq73ALLec2kGfD8LeoLkl31Lc8g2gW+sQHiqYwKAvcYLnQXnort6XhZLop34ZFhqxap7hIaR/AdopjeTwYbKgKInJsYa3jGXs62sLGSUXi6uyz2gf0zepdNGTyyQ2TBeODcVEOkYANS+JjxhPLuRnGCFr0uGoANzYJZfsRt8IZenDNFOzVAZPPCeM1HSdDmOXGE40mjIf6wTSALmrazK3qS28rWptvc9DeXhr8zGgrpQpqfABddyVpmJ7GNjVjaoYDJH4Ai1mKDQAjR4bTtbbkmSHYYe+pJvgytSRbi+AhFa5wtlNqFVp5E7eKktVJUUJN/LR1LOE+w2xqxaF5TvKs5bkqbIpbCWf117moiSgfs5yK+SV5IqJqEgbFWgU3zkhnUDR3gIGIVukGV5TanJnSbe5KRwZtBsYZNaS7hUPu3kTOWVdZqM+d1SmHAot3PzwvDs6a2osWD/dMoDpSQh7IP0DZGvb2Cho0D4awpw2+9qqghz/rEbH7HopoydiOLXJE5hzJvYU3chu/E/E7NfOCjTwFkadIZoUOj82sDhAwD67XiNM55XOaiJicUJbGEGCBAZ9VT/fioUMt5GrO8lsiW5r9Fkwlg2NG7NzL3I8xz9U1rMQl6rpW45Yhvlq2vgNV9KA05FRYEvPWANbTAF0J7XKRp5eRZ7jIM8vIs0RYlp/NrTmHq3sCj8oTeOx2KXE3nHcdU2o3HknxRLHOkS/JSQPI0pNwKCl0MN+KPsH1IuyQ50vEMSRuv54sxTSNtZ6zQd63sMYQbYGIcl66+aQ81slPpzFcdhmzzjFGYgYYLsgLgIVr7lWFQy3BKXDiJWGGzXlU1aOVA0yU1L8UwoscNb+G0Db+IHgxQts55EtomUOehHAbrCs22bu0XTAzb8vLsr5k8jKnLx15WdSXlLbyyzZ98eVlQV9WBTxK33zUCRQvWjK/I1rVruKFKMXLLOGVipxa8hR8AjLNElFkUbZDKIRyihi5ilPE2DEVsAFONDl/BH2Lc/HzFMk68IrzOK8tukVPIfn2FJLoz2olmalEP9+pXgOLU6QSrXiHxN3FxY6UtoMk005CtC2trfMrl05Y96FFrqWdiziSuKNcVaW0GqdKpoh2utIErZikhEocCSsWdTFRusYFrV5Rja3P5S3Oljyw8sns6WHG92p+qoh5Pqv40flAzD384EXyAi72QsbP7QY/T+dKzjD4uf0x4ueFinUXlvg5x1F7BD97HLpAQls4dL6E5kucTUqcbZQ4+1Ru3jbB2W2UWMzES8NiJl6eqi8+XiwCr9JWfunpS1detuhLLC/z+rKAFzsDFivYHE9g82IVm7t4sevYAl7a8rJTkT4zeH6KwfMdwIBzCXmIsXRWnuch8iKLCpmZAcXTGLVyBJ5u54OvqHoK7ZD5gHQEJNNONztKxI3oPHoKBybniiAifo4/U3aOzJRUqz+XLqrOFMn4NHq6TL5pMwVf7JicKR2dKaeYPpiZslMnAWnzzUyhkZmiU4RyohPMlG2YFNvsTNmOmbKdLkQkIx1mSpBiYgTsIBsPeFeYx6zArb4tPCsWzKw4kws8y8yKhUc+K7LqrNiilBqrg84KRkfGaKXVW4R+K632JTSHGaBzxsj8lyi2qJ3hxaJ2R162OUIdW+Luy8uymw6xpefdCp53J/Dcr+L5ahXPU8FzS7pp1qD4TAXF7XDhcmxOimpjZF3x9TxJBo5+6p3/5eLqH4YdiLGTzhUEvrj6V1zEiYKGWp1gzVPIxk4xw2CmjcUaRf9TLPrvGEHY85S0A2/HFopaOekU/acg7F2PGmFj0fG3CLsALFqgLYhU38YtHwgL7nu78YFPTwJZtMi1jRExzHM8hQQtAnFW4VfekGBeyRkrEIpL0go3sL4glm9X87a8dC2WbeWX2GIZXlYNllXQpzOBPmkVfTJBn0liOLnouxXUEjElHTp6o5Dl6OjkIKvuRi1kt2EXuM3629+ukU+is+nJLyr4B7fyXrmmnhGeRE8GkFakqKW8Rruxu9hNT8RHhsFMRURGp67RE3Rh0dW2zVd6DzDE2rIfpjanweGT8Epdo3/enubHQ6W3S2YrlUGdezJTcbGcUGbUQp1FzQAa+/miaeYpTzUdAspx/9HHDMYLYz3VdAgIeclyTTLBeUrOyFPI/NP4x3rZ2KEcDDM+pNMOaepvmsxSxVPnIgTOQ5L60XgKPU13aHu1CH0hfuHc+pJpCTLAGGsO0MUoJtdirtZ0zbx7fB+tmybBAaHA7l03S3CEGlU3084dTNtwUeIf2e1BA7sB51Cz4sG0cklTPQoa/6Vd3deEsq/pYl+DufEEOsfugc6ROEgQjCeMR2mZ7Jde/wj9GOyuHMXchY+/Ds4L+hUzgYmYlBKS5Pevxc5/1CYf+RC9VIwF+hDSvsCWgBMQPESojHCIMG+NS3GmVVwkcw4SIkXMh8JetVraQt9RCpJGhMHpt0IundlrGeRXnFFoTShAQirctPbrAgoqethh+keR166IRd3plG+gL5jC481r8BXXGDmpufMBLcDyjjJuYkkLswdVS1Yvb3X1okimby19C43U2ggIdQkw6rOUTNwzyj17zuVuHKmRb9GgycQejmo0O3vzAxM8Zy/fOit8rDUNc/HH57uDeROOvEDOEui+tKjOV0EQAQUA3vGrxir2zr7isDN7xc2FOM3T811V+EghduRY6vSv+wFYvIXR45G7W8D+kEkuxEEvNg3xUIN6KNEjIgqyt70aKRDXSbw6FxT1PgjpsCtVNQnPntHWjtoAE1GuGQZp7NVh60msYaQSgqvWxkUAmCDNFwluhiojuVeDRrZ4fNdEU8JXOARl3Vp+ouUf9JEDR3dFhtIhNqIOt0OWiA75wg+g2JZKjbRynwP+pT3gK8x45XWj0otUSIuNlhRA5m5W2YtaoVzU0kQb2SenmrPIP+6ohj1RyOzeOi22v0cohtKXKXbKcSgqNrN/FTSnqnL7nZuaBV11VkG/4qyCZhWbnwvO5OeoIc9WjbRJj5qwvm+CsHarR+rdiRP1vdNMPhb82dVMTtcetd1HPXqqElq0xBDanzv5syx/5Nw03OTc1Bs/N4VphodGz00fvKF6kqXnN3J6Ff4b2f38yg3HO7f6S6SyZnPwSG4itaZcRGqN3EOC0PcleiGodTW/negO0if5WNCbegnpE0ihUM8N3TWko9VrSJvXefLemvoveSHE8o+/z6YPTb3ihLqyD75+8obTh/Ug8XmTtoT9Psik8golowBNQx3p6lwHw5AH5gsKqoaGH9V0//WJ6d6qTHe8HIeP+sij56MUL0and8tO7++tGvN4LCAqQgMk8UGQ+yWf1a8OwiPk1BTaP+v7wYgFzmDSEn+wiY5tkKkFHz/7qELQsnJqQ0NaA4n7x+UaEOZLqHcjnZUrn9/WeaVO1HYB2TWbPFlatfwg+xjKJ03Kfg8vqg+3MGYLumZ8LJl7nJUrQQVs4XZKo7l4KWI1ZFjHxRM49+yKKRZuf2T93O0eXUzdtV+3mE7EAowGbZ4yfTGVlVSUrbA2/s74irq5xutfnUDjFeumq/07yvssSWHVfDb2/egzf+Se/PqkNEdw7wfJwyA4XTsMByBZxmQfBw1myKV/caJ7Ccf+Ne4lHHuk9xL+YPRewh9O3Es4mGEHOvUOwtHao7yD8LlpdxBQFXab3zB3EX5/87sI/3aqXX/0Dara9fHjath8QhfGd6qNA29z9a4zgxOrdx3tlPpdNdG7V9MudcRZ/a57Hj/9Llxf6h/NsPzcYXS8bvzKmI4XJ44oeXEo+5MTK3n98aNQ8npUPMAnH4ss5VPflKU8XrKUn/b9yrUdmmbvTUsCNzCxyHSpJgnZn6maKkQvRzvoBZw3qe3Eu+UdkyT7FL7CbSTwKfdwfMWDLLtNO9apGDDvk8gZvVIFZGAYka9cPKzYTI70pkwe2EqgHoyYoaktkgSuDV0fULTuPh5cgGjPLaa5564jVnfnvjIUOskqDEU+LVZnptGtZvTOkKka970yjdhuubpPc64oMAH/XIHWlZfP6AuRGLyEgyqhaXj18HqffT0Y4vWz5jX9GS9Qhz8Onn7fc2ZY1EqhyHImgPqCvesWgJ9DeQLAYGNaPgV9ERsnNKxSD7lLBZyhuUrU/5DMEozEwH1+R/oE7nPZJh2vSoTWX2F10oc9Y4k+kAslZuNU6aRehLFER2of6TWnYzVFfzTqMGsWRdrKkbi4+pGT82HqelOsuX4Q7iWPFI1B9pcCsyaFBNJvI2CVC0qHMLpAdfa1BdjUGdWcDElpmRUhydaVTd2onxUFXnrYj3Wx2uSqXV+mgW4FMMWUXvejPpeXfUIkCeEFweXlLWLoxk+xnFc1l1evxKsVRRyuiEUxClQ2z5gn5nmg6YeFU++nwVGDBZTyrxpiQN0KM/lUr1wzo7hybyXWBSEecFMBh1FvNaP32d706CCS9JMqRA76jxEkAUASCUjqm4Ok/thBgraeCCY/6UcOJicLkbSfjUAkfZQQCQ1EQkCkDoioiNpABIYNLUDCfnNTgMQASDgKkLByNwubQW4kLIEIuw/ApCcCzFenUcWjDI+SxEjzfcDa3dQEN3gku99wb5GGBlMoHRaOQCYqGpcYg2EbRTjEe7ZejPreslU0bMfpclRW9TgGurouUUeKaFjZ9N3B8UOsyUNXyHhxNS5ufYDBVcK6nl7uedWu+3srqy95A23uesFhrs+b8EOja772BVINX9TT4fTQMz31HWEcijd4AQRCXGDoPDtrgaZdnbQCk2of+Y1b8V3y7xMXkwteKX7iDVSHj4NY5S7P9xktqCZ3Rn08+QapL5sksROLP1Yo5ypgxBUD7cMspNpxF+NkGIuqMdEYLWJFKv7ev6xtjja8SjqUm9y1PbH245mCGJ0Z+/ldvhFtFBTzHL3gSzEvnKcoLwtbSxVWVu+ildsCDLhCRt3L2MlJYfa31uqvL1bU8AQTCagoY2D8inmS4mmKc0nm+GOw8ydySaac8ed8z3ulbi7pPJ8Q4qPiDOfPGlZr3QiLtZddGtoJe4USOgsGbiS0G1YKhYbt0sdOfZyFB9I83f3g11j2hkuYg34e6Mb6Jh9M9fn+QX7ii0O+FnyYW3pYw5wHbs4kzOnIg9KRjifS9In40/2bpeype6C3amWcRSu/nZ/45G3++fwnYY6z8bs4/3n8p+E7OXynD0IteX39Xit+qz6R7oHD3fBhpzy9HT5i3V421L1shLEKzO5ZbyyFyipRIGOJW3Fi4lGSKUYoIhH8Z1+qbl2Dcusa4FU3L9i68n/VrWtgbJNOuZp0cNZtXcP+4Ctj1vl08NAKNDj7crlrDTfbtf79o9i1/p936u2Lk9npLrXQhlGB4S/8PP79tXU0dv/FkNZcioPWDEVvtpsLKrs5sfTkqXnPFf780/L6R3oCJHu4Qxn5U4XND3YAW/CKNRWa3wibDfx8kC37gYceMdAM8uFWAZ/qbvllclckZgWDqFMlSjDaqT2nRLcJSAurafXK6lyvWJmhYGJfN5jY102LVbQ1e7gnHufkFfibPTguKH6r53nTz14BmyrforGA1JTYL0yNvbcS+5Uy9piLVeugEvuRybyulVmNXEcf9XnuDW8YF+7srB7w7Jw44Nl/whvS3/NC+SzIbnzDY7wfXRUkvfoNj0KQ9HP/FlLWwRsmpaw6Gf6NDoKPvOF44tWh2nr/4Ytm4GxsjvciLbk+GL085XePrxD65X6tiPIYAsuWOEaqaxl6ifDY8S8RwknXUXOJEOG7KuGBhnEuIaWk8KDB2uv04rzhgk0XRIZjCVSHxVZW3uanse8KwHTzGTxI7W6clWfIFq0hC86D8RbaN7Qhw4pazFJnvyAAzZoLinP7i3max1DLDilfoMjeOVykWeSIqEP8x+ot88iwBPuf+zXzssvcpVlcUJynOSRsoQzMa75ijWD3pf/sb4nmxWIa8LMLXFjGzxxGbWmtz6/mXuIiohfKtC1IW0AaF9UCAuu9xA2UaoskuDCyG7i7eFvW44I6KKPeHzRY3RlA4edWC2TW++T2LdEMhWvFdtxJpL6X59B/RScKWuEAG1zZspbvoFla2o/YnfzJKcFe7ZiWRBF3bDo+hBnNEZ7OMIzwoVafxVz2P1Uu9tOpcoHvNKhPCS+0RKeaC5KRuIvSW3tiVp5IthPztIQre/ywV/a6NIfkJWjgLkieRVza0St7i5TTvGSb5zDMuC7LzMNPRtsPYBCwTT5FNCC7Mo9RXkJSFIQKYox+AUriLCjM8l3yrOWnKyjEHM0cRpwi5qFR49zaw02xl3z6w1/yHn7AM8DI1oB4kiehXdUkNUozBz5xrk+AFi0i7v/P3nWEt41E59gxZcrLpSyikmJ5A4oiKTa5F3lt0ds39Zj7UXaav1zSlZ6jjznqlt57r7f0ZG/pvffeM/+bN8DAhCxa3m5tEeYNgAEx8/9T3s/HCShmJsTkA8M+RW+6UZv9LHIv1K/agDayjXGgm4/c236JehK5Z0CpfNr+H1+N0KTyFjWNA0+/BaOY6vwGagzzay9ac0I+oJns8y4D1HuUBPMVOBeSCDE5I6rh5ZIBNalkNqdge4j31G8LDyuuapOcmFLLJmf/8w9yzZ6hNQUoFzAzpdKkCG400PfpP/92hso0RXqq0/p52kSRNDOnhkgP+RT+S8pZ7Zt+A4C2DVimcXYadQsc8Ztv7lOE60Y0pVn6VnuEnAEeIjkQMlSJPN1xMng8QuhygHbtzStv61M9BOT2qIQsBTekohCNGtrgzHPoW3Zow5lEbXPNCODMx+YmO68BlwQYu7ezHwUK5hdhe9b24PPxqIQDoEaAmvmRICDgPMcM9gwYkEwkCfht0nl1aX4GAYHqin7gFQOmgeniVQko+e01ddXEkPLvBl3DUf9u0HVexqgbQKXO+es1dRPfceBeTN3SZdYkYvSWuqGvu0XXMALe5pJqElV4FX0yIaqwiu4o0IfVL1KKblGV6OH8QH/lULX0R+vrQtp0Q23RTdVM+6uENJiaBCQBxNzkPeSBbpIj7CzNd+zmT+bbpRVqq4gDHrdUXZf4FUpTUNUoVB7VUbrZvoq7gwHV0jQG6xpSyZA8Pk6BFhDA6IIArs2gQJMHuQLhZMZbZ/1aORlpNNFwEfeM+mSMPxNz7flkVyBrSDYhvndGnP0Pku0+iYsY8N2/X05m/CTz+JHJPJ9MckWOiC8a0OSoIqfMLL7778vJwBQ5RubQZJ5Pprkih4SLcKdTZA3oq5GHg4d2AV59uGD8+Qq88xRxNHNEIR9DqvOxbr/UXpUoBwoQ5dDCoUVbpPY1MJrzHYyKfVzZJ8rHC97O4gUZcuuIF2Ss3WGsrT9MNH30eEAwNRQTX+ftMxJLBoYIP1/TMOxqGDY0DPt5GPZPBsMtIlUnpeHYUU3qqhY1VBtwxMurGlWUR00VaKDG1OanuVCMHYgGaXroQHdKJTOmJTOB7QitNhbsTijg4y4yX8kDeUBl5N6lKQ2RuJfB2t9PInsNcFWmCe0y6nDhxIJ81wB1xMgXDC5CnlGEP1ML+JEDpYimjHTBvYVSlH2Gu3RP58rdvy/UGtMrTKQiwEc0Nhya0qS4SOFQHvAzHgWKAR8tA/gAh4BiHGIL/xDwDwX+GdxxrFCTj01q8bFFbT62aQsg37J0IPIBXIWDog4OHeri0KUG3dnXcO2DHH1aw31rtG5DBK8iRHAPh7fRBQPoStENnSpjgFYdpMEGQlm3iGhPM6EBUnBqTSN4rjmxrjlx5+ScoCc5sa5CzYe65kJFc6JJa6pFd4QXEYWqVMANH4P1EdzwHG74VDLdNnnCi9jhhW1QX3AwJANpyTcsS/HN4Aamv+3TP+fPv+SH/uqePaLXRXdb5rmNzNbsURONIZKUuWiDxDHZ3GnBqDBkQBJKTWk2tHThXPv5aJeGhi4zF4jyOiOBtWEKXzjNjRd5WNcw9VmAtUD3qeiWEL8I6I4E3dKpnxDl60T4WYoOKeCyAatBXVhdWoO1Rndg3dFgJ4B9jtvntCcjAV3FSqGrIcbwVsrBdoux3X1o1lAdjegtjei+mWwIMKmpYVtWQxzRsfIcYgvh1SrS8Aupb+YReHlVcuYSAeYS7vzB7bQFjDMB48jFmXTBbgsO0+5Umk7631ybTUnG/PKybYZWiqWVfK59f8mheIsIg2+LFLccrDb1YfWpidKb1MENHeqaG27SVbr9eYn+I8GIvDi7Sbep+lBVefp7Q5XoGoIRr9F13GTnoOz3Livz43GYJh+xSv0eqL1IHNrEY5s4WOHxX/Uxi6MrtPPooYaAafYmzxSuQnAm46VuvWH6I92AN2iLLwzNhzFCPbrLOpWApiqxD6EiS65Y34Z2D81ap6Z7Odv6VNVrRWn+EtX13Ecbe2qojYrmChtT+KuQYmDgODKjWSSjts9HHnIxzuGlNasBDvQMMxmy+S68Ps5hTMNwjqEaiYk5d4BzYzJjvx7WpBS2fg2WvsFYPwPLjoxHjuY8HU5wERogfTCs3+dfSl/RYwC/9DndG3N7x8arYtYqOOnhZCKOBixTGK+cOeDMqbM4nDIFqIw0loH6PzU0JMtWQxIb6dOQ75dOKtCQVyV9OAsW8IINs8otuA2MayBK2/OMCo2H5LwmjnEa8BI7ZgeBx0Mbh0IJVVUNwEhHN/1IFEMe+iZP1vwSY7lJkfFQoFg8YsUs/uLU/+DpWqGSFC+vJj6FY4vPfDvnxbdjgBgQUhf5y+sBldFJmGcXX/TZctEeBUZO8Uwl5T1BFGJdrD0EKmJn1EsqNvUqfbkl1oOkyZ0NgvZxu97i9yVmWbOYZZUcy+pgl22ZZVhWcVlWf+FYZpH0kWJZU1hGGC+aD6jF9pwMD0JpXo1kVc8RLxLi+UsST3aOFmZEwGGUEi9k4vko1iGevzzxios/OfG89CJvgXi2gNgpIJYCPHvOuS+W++KMsEmNW4Rqi8ytW+aG/CMhq3CeM0XxSk3hLZP1M1LXZMmc6yMwwINXa6vyAvH4lMdCXWBD2Hs6bB4zbNaWGTYvqDhHvj5fVGOGcW2r1kvUMuLnGbBQb8TaRK+aTmZb+ok8lzHz64rIHBXy0QuUeCJPpQeYcXMLVaUrDKhOoXZa4+unsCP4cakuHmybG0vtBBADHoGz3j7F2mC/vqnws3tG8grQxhF5JhuvgXfVPmtxdnv8/tKmooU0YZgXbM3LbFyaxxoc8tyaUAMPnH/BF7JogU/2KIUSGSShhqSAy6aKy+qKLuQyvawumSo+ZxzPUCG1cqar2IpuOz9zqO5nX6TYNq55fj4LXTHfg/qgc/grz4agCS0Lh02WM/GHzLeI6D5tH2ZBfx4H/VHJ7FKoNszXkigAr2nD2dRgO6cVCIQFOyvy9YK/3l1eDz64sKgHf+33H6sH/7OjAf+xk34304NRCusOBxAbjB4syQtZMr3gEyMJv/u+SMJ/vawk/PtlIwmj122hct4zSfjASsKnkvDBx00SfrdIEj44lYRfcEn4QCThrBNOTFKT9ymS8LsnlYT/+uMiCYsr90hJuFaoKZQxYogkXDuhJPz4GSThx88lCR8WScKHzyUJf0+RJPw9H6QkLFqwKMMfTUn4VBJ+fEJJ+PFzScKHRZLw4XNJwt9TJAl/z6kk/IJLwo8/GpLw45NKwodFkvDhqSR8Kgm/YJLwynssCWPJFWSbE3xAkjDc08VObjiri53c4rp2nNzfk5WCass5uQ+e3cn9+9mD0RwFkvDBV1rfIhYtX3tm36xYYHoAnLi71RmOAK8hi7T5KWJ+LTvAH8t1A+c6fWIg1y3lE4c7w/WDY9EFahg/OBii4pxqvOKoxgc59/fBU9zf8sOD1mcJlGtminv6HJ4BahZ5v88u4f2W0q3TAaXXji09de/amk+3+QrMo7IsyvRgfn0zgKND+2D14NjSzFJseR3plGIfE4o1hWKZZAwb8LWS8UFOMj5YkIyXYp0PXvjgRaFifLZIMV6adcWlF7MuqRXwDjAW5sWUXRCTk58x0hV8M2q+b4LvKVFPiZppwkLPF3hQrC0zKJ5c7V1ZVHvPPqH2rhyl9p7Nq72wC9Tes4tq79lU7T2LsrkuF9ReyT5Ve98vtfc/TfRvWf//kv65ropWefXPLH7pmj6u6P/zau/qotr7I8ervd+CS0Th/SYn/Y2chtprSrGSgqi9kryQJeWCZ1N7Cz7UOjpy/HIREr9vE79mEz9jE99jE4c28dgmDs6lWnEt1YprohVr2dcnX7TiFeAklX9DquW1YjAL4iL5D8zFcXZx3ZDXJw8nGqIVb6RaMVcg5EE/3da0DvKwYOxBeoqgB8eiFYdMrPRcA+eCRa34EKXaIuffAYs1WFZgs21NWQ1WTSMmq5YuP73I/JJJExRpmAL083jQNlu2qIjZEFrFtqJ8FlalH6k8RMfA4m305C6ntjTs98P3nktiguhrnulTg4KH6HF1Lu9y6vOjPNnlFD0PmCG6lo9fGvIxK5Guyn2HdJdTagmPDvTPfLUdrVyPOx35ThIZaIJ3Sr8nOsBEPzlCw3Vpg79ilDQgitUoeoDcnr5kC/qTq5HLkMwQu0g4HqeID4wiPmBFfJjV9nYqjkc0cMVxzxXHm7LLKURi6OP6IPo4KphbAL1zwNeEaB2jj4eUkM+X+Trta308pm2q2l1Ou/vUR8lwYUAU9/AnSHc5DeVb7XXe5XTER8jGqAAjVHqOMh6SZ7Y5hcKKDWsyZRw0E/F1lDtF3MgYjz0Zj0N9ueNqkp2N4pwyPsyU8Qj7R0IZb0GD3Mwp4xhG+0bMFArCU4xtTif46PIavsxPmLSabFyYUcbFmlIgleUZ3Tup08S8UDKijhW5x84upLhApeo3kU3uZPuSApDnUCS+10B9HmdL2XcIpvpzFmriI12E/vNXLIIjPePdUWGidNoxp8ZIj9ONU5Oy1HuxJs7Vkl2BigV8+L17++QDJEkJHmXacTZMRc6IxvkNUz2Z73A3gi5DHAAyQPfhTjN5CaTxRNZEOWn8ErWdMbHFdSWIE2ncBxHRt4SQxls8x/txaOFAEDJ8myErsKxLIaAtE8dXeKC6nI1ZV7Lcq1nutSz3epZ7Q5JA6xad1/r3GbMXpf54t62QzuBTJTMOqV0rpP/CWnIHR/2D7K8YIV2JkP5ra+ouhPRDvnGAStX/93SZA6X0dQO6g77jHpfkiZC+iwFrA0L6hh7fWJjZpLuqIrPty8qjK1xtPlXQ+GG62R9azNn7z86FcfDl65npjpg9PGqTetjlb5MxizTprLV9pIaYtj1CqokZI6e2MVfjVKI/Sld/BEXdbHUPY9sYMRuJMSI2yBgNGmhjaIwqGx1j9FE90jVXqSQ88rmvKhsBKmRjRA1i8sKkZEw+H2d2F7Y6jahsDMh5KITGVNboTnas0DLRQKfRIjGZiske/szNtSvJfWeHN5/mxPfu0H1nh7dYnmJun1kBZoefYh49MZkryTxX3IT4ohnNneICQ2p8aFDeypRjU9weMkcmcyWZOcWVwGJto0txigOylGaPEA8DMHVB1i71DFkrmLdXaBOZm7SRV9zvZYo7Y/NVKO6vApuv6YMe81/Xxb6hIdoUiF5VHl0TiDafE6JvGOC9kUI00VmvMUQ3dep1Tm3o1KucWkthW0th+2YK27f0xxsybIdUE3Cy8aaAk423BJxsJAJOyGe0aYwuGxvGqLCxZowOG0ICcgBdWQA0uYDuwrDDcgdGwMbM4D4WqO8I1CdAwB4FbMypzsf7yHzbQiEWEiTv0IzGSHyapUTVgHWHJkwJnEeCL5rlCCLQLdN9mh+5a+sIf55OllmOLA3z/D16O0cWvvId+jQmYDFZ9miySJbIkGVH3sKSZWZ4MDIvIGQZuWQRltCYRseQZQheDC1ZmiBLk95ApsadVeB3ocCv4QAFfg3EwEp4QxOjI8S4rgu8IcToPDsxLrrE2DD9NcYIQwyNSA1q02NvSC++DdhxKgEJDG0gdzIJKhbdMRuC7oiNYdZdV6gpjGBD0N1ng4QRDtS7C1CvulDvu1BnKAS2A6e6oDx0UG6bK8BkiAzY8p27hex9nC/cuBXtDmjMaK9g49a39UlGIj/PwGZONre8iHqhjsBGGLBjGTDJQfY+9++C3NxwUUqJJwwogOzhiSEr2q5AtgMcdeym3GtWR9/FiqJpvqpBdBd9o4XXkHduHePI/RABOn0iDWsDty4RNRlQlbR/7ZhFECmq2lE9YKNrcTbQRkVwxkZfcOYAKFoAUMMFUMwAWuwRFwf/bBy1HRn3HtJ8+ZrV2eXlalYWL1KzQ6xsh0TIJGqazLu0S/c+L9F/3J1b79I9VFKPi1KqRHewYLpDr+AmO6nMK+Oe9YyUJHFY4jFYERbZdJsuieqNmu/zaL0L1XtgZICKUb1lpiZNgAeJpx/bwUbGxd8g9oZUIcJIO4irEOt+aYcSNWyjjLQRmUYhNTb+/4CNGbz8+cYxXToPacmcQj7eRyZGADiHIOqjVZhHMl5NzLlfwzmQgseyOfEwNzfnfgbn9giDHiopK8V+UUDfYKwDWJZaMk9bJLbpAkam8N/PHsxfQBB/gbfPitVhCckkYIf/WGosZG+CuD2BXyfEi/3+3KFz5ogzZ9kyEABEuow0Fnz6PzXO+yIooDHuMxqQJ7isG+9shyqWZyH0GlkX60vh/zEfigWwQEajupHACG8innUJqMr57evaUHUZimQhL47gLYqB7CwgsGQWdHXDFy7dW/Dbi5/guNJtnUp1On770DwqyyIKjd/eN6//hN8+sn77mPWMl+AmcebAliwPkj6L2X2q0CATsxX1i5lTzTEnwucFe5ZhTtVlTvThM+eUOX1hjjaI+g+oIiKYAXckZNL4VI0cmWIhU7AcmQLAPbBwjwHA2JJJRLAApTpkCpYnU2HpxWRKvEU6CUJlHM0uqJOTnxEt8cDckLxFxjVcpaxBqxJ4Kl/pFr7RYFGj7hNBo/bhPKLKC8K/U/6Bcq70/AIPYd4yQ9gFVc8Rivgij1ljpOeKLAEy6bmLfk4mi7wChE1k5qZ9kQj6FIj03KC+SM9c91XpnUJqUORIzzF7ihvi/LW59QxWIj37+1RfkJ4hjjH0KCY/lZ5l0l12J92RNJfoCF1ny3xRjm9iVW6XEJ7gHA8U6Tm/Z76gJKc937Ku7du6lFtae77paM/hEdpzO9OeW/i4y2vPfrH23KaWoz37ee15KtpzCArT1NGeW66fnfW2xHtSe/723ZdtpPHLX3lO686fqnXnM6w7LxFn/NfHK8+/7ajNv+SkfyJTnrmULIz4uDjjRx9onPHKcXHGK1mcMdLFccYrRXHGqAKJM4a2+h7FGb+LUqXIp8QZi3TMOmbL6JhtCJhO79CRT0xGMlNKgpMTCU7uZsHJm1CERMcI8bZbEpCMbqPPAcnIHRi57AKHaiibFJ30+cOUW9Q2q9u6hCS3qV4ckiyq60mikntPiUpuplHJ1aWjkkcSlTw+Pip5fHRU8uh5opLrsOrUKYhKnkC26ue11wkcHqJ/MYY1HwYsNNMWfDgTHaE8xVvIG0HgCtiJU0P0cfURohG+kKsXtJvSJtWgvtZkMkFdkuTYBObar8VtUsl+JY4IN3oiwib2hh3UQXbDuewGpj9GlSeik7eLUJYLQR4hPUqjk8cwx+bUDtI7S0cnDxejk+skdTBCwOVTX3aGxxW/nVFnaxRYdTagVQxl7JsycctVzEiqJqsHcbZXFLd8KRe3PDk2bnmSi1uG/Wxxy5ezXv9Klns1y72W5V7Pcm84Mc6No6TZn1hWmu08Ic1yD6qaEuOM+JCm6ujrmq40W3Ol2XVIsxg+FHEc6V3VTaXZGl3hSvOMohOk/nw0V+beXwifzeleW3jUGm1B4VrjGRPSbQ6NQqrHGhdSA9a4kGqhG0eKZ3IJT+4SGphFrc9GyxgRjGy5C6NtjDo1tdEzRpUNkQRWUT0L0qwna6vVTK8aUd3oVYFIs15emo1d76ysOfLSbDmZPlWaHeLPtnX57zkuXI+2aWqk2b0n5SHvCWm2nJNmp9YBv50rbmql2W2nOL9Imi1baXboSLPnl5Fma+5ySL5mmYCqCW0ZqnYxr+1m8Z5PlWbnkGbnwKZW7KBAvaqLfU1DdJBKszW6JhAdPCdEXzPAey2FaF9n3WeIrunUq5xa16k5pyiFrUph+3oK2zf450sA2x4pAScbrws42XhDwMlGX8BJTW2IAJuwsS6qFBtkjE02hARtB9DdBUC3XUAnDGjRqzYpVSVmBveRQH1HoD4FAobiPtimmI+s2L9poRBZafYt6zB4OyfNerRD02JpVgjiSrN7tP00afY4ssxcshj2ehDEc2ThK98yeu2wmCxDmi6SJSySZstF0uz5JXSuQrL0wIueJcsAZBnQa8jUuMtJs2SlWQIxlC5iXRNj00qziFYUYmw+OzEuusRYN/01xghDDI1IUkyCgU4Rp1qAHaf6IIGhjYg1HepadEdsCLpDNnpZd92lgTCCjZYwgo22MMKBerIA9aoL9VUX6gwF33bgFAvKAwflqcqZSbPb+c7dQnZvCWl2WCDNvulKs0MDm21686nS7PQoaRYB0S5k97h/B3Ld4aJImi2C7OGJISuyg0B2EzjapHVkrhPlpNmBkWbbdBd9o4VXT6TZnkizbUBnldoszSKd6KwBA6qb9q+bIs12qGpHdZ+NxOKsmem0IRurgjMHQOECgOougCIG0EKPWDT4+0dJs9MlpdmimhVpVmq2h9loj9rI1BVyjDSLStriojpLSbPLBS2zWNtGiLIj1qItVjOxVmK2umY5K3M3aZQnXN6hxGNlYm2cF81rrsu7Ls3ELu8QzeSItf6Cy1uay3TyPMgl2+L63kMmxgQJyUI7uS5v3OWEZI3M6LZNPPBhfJKQLIws4vLOSrEhWfoGYx2cf3aXd/bgNCSrjAANduoeutFZ4vKW4CznW+CZy1sisrznc3n74vKOgdSaIDWmmol46lLywUYeNz6WkccV+FWcWbEly4NklcXaVepSMxNrO7RazJxqjjmhiEXxMsypuswJP3zmnDJnVZijjTatPqDuBx5Q3PjkBhRfsF/1X8VHWhW+UXNRrF2ldhpQ3K68IPw75R8o54q1L/AQVlv+xzMyQrWzOOG2EWu7sijI5JgE/ZxMFnlNCJvaZra6KprCqhMnvPrRjRNOYMiqxxVrszhh4PxosVZQsoxYe0yg8DuZWDt5TwKF36HJSQKFJzm/e3Gg8P+z9yZwchTX/fhUd09Pz8wevWh3tbDCft1RyIpDWi4dGKQdIUC3hLAMdi5scMJnJecDvh1WWmErRjZyIjs+sf5mNUrCnWB/8N/yKeH4kONLyQ985ZJv8vMFziVjZP/e972q6Z6d0YGQ7xXsVPWr69WrqlffelXdlUDmprb/64/PZyUb34K7qjkY10brvenVVcbobe2e3NaeBFwV3P8dxK+V+6D92szRhB/ZwR3ryF1imPhWCTcIMBpQrV7k7n7XG5uRJW6uxoX4nKdX+73R1LMJPTKSRu+dj6pvMYUj3PMf6VX+8TwvxuXocAwcjo9r+kmfBjSW0iG0yN5QLdcxd6iPJDriDSCFp9l4yCZSp0Md0rCB6u8d8XLxAdwfz7GD/H3hHUyM9GLpd7zeEhuXgm+7rflScCcuvSQbP57elO3Fr0NUDdBQkWh2e3a1lpN0IJLG2p4zHxtFfL3oPn4nGrxKHl6ZzQQOloLqjz3j5apWslWT8tEBcE11/IbcPd6d1hOkEXKPXO7mnEIxYd6wM1/kKBE2OsBP/B58ubo5XELBxgkUhC2y7tFcoj+3XRDWMyrEf6GP2JmOqKgrYWaDInTGEKOOf4Y2UGEU4wKcauRQ+yk34vAylIdoAWgRRBnACdIQrR3qBd4G6eLaODd2DKNN/F0wSGESMYCR6EnELhVF4OimXPMqlbKWv80Y3wmfcv1Kq+2jy+hN7CDNRVdFo/Wy40kfi4V/n7A/zY5xHV87tA+jhQEv6GzxdshFBkJiXPNzCDlmHvhF3Lu+o9296+Hio1+/HmxIww2Jz6yF0sGJmyR3/XpwtOvXQybpFetyhz06EOKJE8CRsPiNR71+/U16/frtBsMPTSAdqKR9MHKjsMQlQ7kzh8gmgK8IX8g/8VuQB9jX7sdOKX6rjnebnSgvPJbkEfyVLuv0qQQC5M+U7qo8cNmRHdaQHXuuYo1VO1hQ/Z6Wah/6EV+xj+xKiBBILzwyc28HI3LfvxRb0Kv9RzhPwuEbKP63ScsZQqYNBYTI0kelFpoU3UeYjaovlAzaqveCylFGa4A+q3MGF/SXUhBGHIgBGUypaDo8eHhIDWfeKLA6LKUIR/GbcwolNaJX4e/IdCgn6C7UDt3C4ol/eou0a4oURvt2fsJEySrQJsUbPUXFqzPdn6KBuD+COQjfvEBHUSSzKGgx+ZZGFCxT38yER6zM58VawjQ8YCZmEy9vEbDr/0kaMuAhbkgmbBhMuVmXoVyokMuTkFFB9QbHvC+zveLPAP5Al2jFxgBhcYPAdPh9VXyejDMoPgx1FbvRUdXU3NUrUMdYRQbcgIgB4ruSkAF8VtsxUyo5kGwPZxxW/XpPaRqfNPP4zx+Pbo6smkrDpMTV3BLICbOoMXX5C/zYipkdI9gLI7PcwErxw5iTEp8KQGijtbGboNlJ0w6wUL28hD0fLasS9iDhABL2KFAJe1bCWuRMLost5iF5G/H1iy9JQRUmXjAqTRlzV2MKx2aMb0mHXw0Sqo9HUQq80sVBNXYLel4BgLyb/2I7oyLOfE5PcfwuO1qrGL8xgLjqyR4IOqr9lz+K2eji9BScYQltadOs+uQsGesA8UGNxndIXr5+Z8QbhTzYxUzicZ1E6wfaj6Pao5xxD52y0Vayl0n/wqRTakVX7z4mHQDJPvfz88dyz9Mx6rEYzNC0TFg9zClWiXuSU3MhOADOf4PYPQB7g6gPvm+lXRTvLNYCwO0onQG2mQTLvHlxerrCcFQMO1oYcPX4i8LCDJruqkr+BAeeWt+d+np7TU/jIoDTUH+UIx9bCuh0Qfse9ndt1lY2e3ajZN6Rw+zIgxBTyrLBDUnRCbGHrPwMF5cYOo0GcBjFvk93CsLI2EpPXFyXuVo4R0OhP3ijtrG6menckoT8ulQaxQTkIT+vsZl4Cmoi95Y8Q+oLAw6cQZGkHOM9TU67n6YyZX6fSeycXtuchK5UGtShwMaSCkqS40mnw4/TRUR0uOM1+z/1ouE//MYi53KAU/fzL3UujjwlDfLfOxdkAnmE10A/2utcPfxEEnLtac9/8MCHnZuFvORGf/brT939QedqSJpSKpy5sg7uda7yZbWBcyUzIg4j+w95Pzx/20f+44m7PuxcSfqxdz/44Xd9P1noXE4q9PvX7dyyZvObPuJcR9/R9+lTJ8wTC53r6K+48qH+jQ89Z69zHX3levz760XOBV3rxMZ+SluYHHvk88+76MvfvMS5ksl3dp71+m9983kfca7LfNNP3n3110//5ELnOvojz3+ImTtzr3Md/W8OxT09Pbcscq6jLxPmPr7XuUpXwXP7GjtwnZvOPLy6de7n1vmCSX/78Lr0jDaBv0Nn4KxcQjMPf45L9Czdy2VJyODwOnsRB8bkqO2gKds5kDGfUaJUs2kTvxZjWAZwAgrx0eOw1iUbAoOieAfpNIyl03RsVq1a0ME0RBXRuTI16z2ybDWUj/jo+Dqrpra2c/wR3I1QK3OM2XQmnSPnPOfUDIYebJeq6XHK2OOzuW7E4pYRPojKQ5C3zZGkoQBZY/BdBEJ6hqaFFVQOjnvyKThPD8mSJRSZkAZ2zBKmJ/nadO7gIQSRes52cDqMIiwUmRxOp86E4QDoocgkbNJXVZpNA6h86jUmLOBx8uQrg132EUZaeibyRZ6sXpDf2ZwPGw3PgWHtHOpZZkU8vbEOjjCp7vfJ44zjCczwCO9vDn94cnhfc/jByeG9zeHfbQpn2rS5njaJW9Z3SDtD3mSgkPFg8LdiEJahutXDvSN1mWv3TChh5IUjE6KWu9G/uimG2KS7kGKGxoK72sc/GUwvxF8RXp7Rjgpgr+gVWLdlzUYGC2SmjMY7dTGcLTlHjdfekoG6OqtFZspg1NIwXPwIRF3sDCnCFdB3NvmZ6PJ2DY6Q4/TvfN+Mh2NmXFZJiU/mLBl9Bn9WiEmwZOfLCtsu/sa8zUlxye3vwL+7FwEj+yMSH6t9XdDU02jJZz+Df9HIdThGGcb3IiQpk0+Rzu3xW94ASoQV00QD+1F4e/wOBOxa8uqXL7vho7998SX13RqVAipz++2aoHC3W7teN8hdP7TMPL6onoY2p0OLrrOor/ikzwgSPdiDcGamFfKosoyRoaDlPTkTXXScFaynpebqRRTWKXC1rHMlS/lK7nL1u3SEmadw4inxnx3S5pqYUV1GbfCAt8lg4wUrQfn7k5Qhb1rY4CjLUm9wjzVbnsp93+zZnQQC6jzyeajLoiJ+J1iUZR0/vFEf2EvB7RzJWzZ4YgvD3U91YfisxsIwSo1ds26ovfKmDRzrZ7BGvKjFOIdlyDHMoGqV234yDUMolP0mvrNhAaoN5y1Ddx3DMvS/HnMj+aFQlRMLznvZis6CIwdpkWCXYeoqofKjri5DHCbyec4Q0Grc5/wC7J4EqgwM+Vgi+zLBMA+ZKbposa5p/gpgPrXanW1PhkkklzxQo3xLqZpLS/IAydkTv9uaDXxpYJViVvkNsH69jCvsE/9Z4xas40+qcSu+43XWbhskQYOZttVvz0H8uVulN91qPHOz2UyevOnhs8Xaj5Go7UDJWcCDeX7Mjg+AM8nk7cPkrb6hed6Qhs7EsjVn8fYH1BlS4szq542JjtM2OPwiZxv8wj2PnImhcbday6yJUNdBrJEzWyHS+OglEcyoYi58hNOy9O955J4+MRaW4nuaLIXalyF+7srW0Bffq/0YxeDxvpwNz2uy4bUO5xNSQPe3KKDhjZkCwsMkBbSBx5EORxlDbjiTYQcqYUNt7YskmR//LfJ2g7wA027EZjsQ1C7nS4XUhmnU1CFOoE6zFezvjscKZneJ0GrNCm342LtE2hpoi4Qf2Zm0S/QAwpHVU9glWgv1+EDbXaLFlhHMtbpZAvpQM8ZD8EAueEY+uHousshLxDaScXGYohtC1qJ6LHXenl9V53OPVFi2n9OuxJom01nGoFHe64aS9iITvw8EtbvaTi6lwwzCObV0831BlTX5ZjNu+A+uz3/Fze6VzdoOw4Z7O9n4yK+jFtScxsebah5yTouz/EIaEjtRWrpyMIkogIlanst3wnZTWXwTlTYlVXbCTUmHyAxdt5OQNumCEyfdcAaSGAeoRYrhPH+bYbc6z98Ct2Oe/0p2SvP8G9W5QYnXapxrNMlafVqqYSMac76GDStxSKOQEgc0Cs+Si9FrYzZj6etds4DUx9JTNqXTOIT/1vOrmtRFTOhdHBP/XTWY9j63syDpDhRGSdPEY2nfprSfqf1IQ2WSx5gfOQXHp07qYyrvao9tHoOERu3MVGEPF2TGuJzeq9Bp7PldNeiryRUV9GVif7b0GNiDpjPlbjQU5n1fuMHED6Wp1CijBgSgMF2r6mOv8gPST9Fq/INU7EPT1rY8iNdAbXPFH7TjeodRxdmEe0yzmggc7jmjkOVSQOY2N+Qv25qfuO24on1Sor3lS6bnmXyZcWXcgwH45qL03oAvNS7fHPKzt8nbXBxveuV435zWV463P7i18coxhtcWPOt7xBokY28bvFUdqvP1U8FbzhxNInb3sVvG86zsDWMjXt3SSzqywM4ssEsDu7PAOAvs0cBTssBpWWCvBvZlgf1Z4HQNHMgCT80CT9PAwSxwRhZ4ugY+A1U6S03Lz4T/HPUT/LPUn9g4MC6kNg78v8WApDdhxIAP5/42L/GSM6T98cKYvh6E1+EgYRbpVjg620gr/84o3LNTvryMrYo8153JWoP4R+RSHo0/pJNVI4v0LHglm/RsaF30F2kgMhulswzhNznH5Z/Mtq80nSl7GdBMc2ovHe3yPVMwVVAHkllwzpbD2HOwnKdkmIoYVuciYIuXnAd3q5ec3/Zs9gU4vDWLSgTPhPPscJ4ts6jgFKKouPTCxeN/NpbOxUMBP3E6TyjzaS7Nv2qQQy6kefhj/4XET1cNJgvofNiYLqLZnGhx91jyLDrPrSVn7JvgJriYhrMjI+fu3s2kS2hOth4DYaGzELMBCovsXU05LFosADeZv7iQzHU7C1Z8Z4HNC+9MRzAQLlwMkNv9mmQe6IX3p8NLzvvBk+941au/sqjO+dRAjZILaZgfFtMwDYN6qf1IZoku5brNun/s/Yd7m6Vpza7pBXRBwxS1pZy90l2WU2mzaTa3zR2wo+RfktHuSbOgu2czlRbRJXihgnPQzNIlbe7Zu4wDWm3S6eWIf4W+CC0zGySDf9/40PjYPD9SaqGZWtBRQbNHaQld0WrSTpeisMeZEVoCX4vJOV3mzG8XUI0j0mIWRIeTrHOtaDomPvqdn6xY+uAC54L4n8w1XcExEq7sgQ881Puj+965yLnJBbXIfjXgAGxIYhOkJRA22EoucPJ8u1r9nkkix4tpIV2hkTq0L315kXPVyKttBlHS5Spo1KG9iNqLkyC0C5gXKyJ0AWTXEMgsmGJn0YiYYufath7B1MlrRS5Gx8n6wYTDZvn7zuLn+cR/PHLmy+hOl8ubx+fjYabMMYV0hZBWcgdb1ehgq+SO1/NsU65Cb1qtxtMltCKZbfvwSu1nc8RsynLdUoRgrSxpNhUlgJkXoW7R0xHdehMFzeGqSqVmQ/fO5qy68HI1qojPI0skpGEuiFzhKJiWJ7NxAfPPuPBVgByraMSOKnCynItfw2Wo3NcoPgKEm829RH1FSHabx5mIrsQ52sZHM2bhzXOxiFMRv8kKK+01Iu3VnPtKfwTtoBOOs3zTCrlxerW0AwSxBXVCFGbWXkldFIlcRCuZj42woitpllUVhwsynOZYqTR//CA7msqZFfWSEDTxeVROmGfU/3yp//lWKLUuRGaGVoIhLT/Hzxwu+DwqKrNoG6e7mpkBb/AelZk5jpk5GTMr9TX8lWgsrm92uHQ550gzbTnI2upQmo05OkewAxZFNp8tXc4ebmdag3qusY3/LFpwdScbEvQNevRIaaXZiiUgMYwGnc8xEeAnogvHaHb8YUzczDt3LdbWKV+3AmeYzqXh6weJT0kPOgWO3geH64iyZzdubAFD59GFgMM8F67Tdy6PPvihV/TfeDIf7K/vNFUMHeUfDaS8yxAaTc+DaBLuHszECKACYX7jSDxyEITrjtirOyrM3zjzJ7D8PDuK5mAUzeHcwkmjqAoozQLRgvEQ9GwDAgVzTOezgim/uS1VPYc3qZNh25TKXlF2kb3dKcuLWGpsuB2GtLIWwxe+F7C0596Z8hgepfl3prNXdXp0ppwNna2rCoy8DRyazEYhhWSYC9DPLWQZp8OuJbIqqqiL5xTi5DxvhGtZ4SJlfLB4fj1AU+/TBk29RwdNU6BpCjRNgaYp0DQFmiq/YNAUTYGm1sE/BZoqRwVNlRMDTd7IrxdMiqdg0hRMmoJJUzBpCib9rGFSNAWTpmDSbwxMwn9cxT99Kltxb7Zw6e1HgktXOHB0xUkFR+FRwdElreBo4WRwtKg9OLI5rD1J4GhxHhxd6sDRxQ1wdPHPBRytpYXHBkeXtwdHSxH/sqcDji5rA46WHQsc1TJwtBjg6NITAEeXcdEnFRxdwjDzsuMARxAlLX2a4GhZMziqnQxwxB1otXYfHbZ88qIHM89yX7v2cnTpHGaabWGUtuZqdKiVOYjytOCJzqStEKVFuSqic6wQnTwOkuMpXSf8ImZCTPjoCRxiD4pyTBrVbC0l060Bpjf3mb+8VIu1g0amdHmLcJUdz6tZqU2S9QpkilMcqGvRQo6V+r2OWWB3Fc3i2nkZ9kCtv+Vq7eHToFJrGpVCUWnIy1Xaoo5AajfHQSACF5B5C6NEvwCOMnCwGohhtaIVDl7RgKgrjghRdwKi6vw0x05Cw9Yl68bWbQDXUIArGmO5NA3yD9sDV4t4lzeAq8dYsOzR08KtXmHyZdxAAe1wa9TArRyhLW71joJblddj49b2zLTg1ijDreEk3CqwCGIsZuxwKoPxC1b4ckGUnkFXdBh+IPugF1hrG6FAxmHoIFzgMxJuMpSwAjVfcVKR7Jk8VK+kIpx1dCWt+4NBWsdINjvmDuDQBsnSyQGyllkHZt1gm6Ugtj2A/Y4bXM34dVbz6EL9TucYMzhzjeDn0av/lNErPt/TCl8D9BVqQa+RQ69+O/QanQB6DYBe9UsS50kr/Coi18LJQq5ArA69/kog1ynkOoVcp5DrFHKdQq5TyDX4jUGuAyeGXKeQ63SO0f/rhVzPKZzymwpaoxMCrVOgdQq0ToHWKdA6BVqnQOsUaA1+bqC178RA6xRo7cVr5L8Q0BoeFbSGJwpaWfDhL7Gl9arJoPXZTaCVVWoLagWtCbaCcjTcimAA1/kWuC5wwBVg1gHXeRa4ot8/mK679LPTHl74Zk7YQKrr+OFS7unrQL0YnUW7bjK7gVjn3D/24OFpTnBbgNpG+H9cXJGN2LaIdZYMqzfaMTQZsc7BNHLeaB6vIivAqNYL2i7nAJBHVuT/0qWID7zqMOh5DQw68un8n159+E3FoMgKNcn/pTWr92wlZtsK4JsDLN+/uXl07uRqAKx+04JVCDb/Z6XSce3iemf+D8RvK1j9loDVxx+78ZL8Hyvosy1YfewJgFVobZ1XwT9GvPLwGT2Zk6LKFqoiSsc/d39qYf5P1ak2FqRIkJmFqr+FxICfVjpoT0RpyGLfcQjjgDJiMdUcEOdYwFq6wNt3VjK3SvOdQsQ8VBsbvYDV7LPWJ2toAc29Kllv11rSVedla6wcLDnfwpKVrdBqlQ3CjL280f2W18LG2Uo8eQBYLEtASdOYklflwMzqEwAz5x0dXun0wGLWoptw1Pm5olee/KKXY5pa3hY+eRl8Sqfg028OfDqlLXx6Nl31SwafwNLPHhP1cIy4gYkAxNbwmhkKiRilLfh5oaT5FiUtOOkoyQ7l8ywIOh/uADqZ5KRA6dwMOhXl+KXPvB0/SpqDrjAnh5LwwFI+XpR0nqKkWbjif4TOlIG5Jgeazneg6dBeC5qKkwDSQjo3g1HDuyeDppV50FQ4ftC0/pcfNC16uqBpCjQt/CUDTevbg6b1zaDpOQqarragaX0zaOKWOL/Rnc7XSYRZPr9xyVayzra6Pl1ZMw1zF/PcgCRrGpAE6pyKrDjTOYOwBR0HRNkyGaLUAmhdzIEyA2MOOJ/WW2xyTQObXPMzwibuFZBrWB7pc4FOTLL8iAhlxSSEEh8RofDE/eKfPULxf6EIZTlonL28u7Q8D1Gee5LxSbfDJ9eg3tfQ+l9tfLJe8Mn6E8UnXRyjswmfPMfhk6t/3vgkOCo+CU4In0C6AWb/nxvaODbMeGwKZkzBjCmYMQUznp4JJA8zVjRgRrEZZnDYKn2b0m4FrmbfcQEOxDrJmEPpqxx9FWi/OMixIg85VvwsIUfHFOTINUCVY1R+2SCHd7Igh1/9lXynNJo6mT91yGnqkNPUIaepQ05Th5x+Y3fpwt+Yk/mDU4ecTgy9nsYxTv3Fnsw3J+tkvlf9NbmKYOBpfy5u4Oifi5v6XNzU5+KmPhc39bm4qc/FdfyCPxdXmfpcXOvgn/pcXIcDR4V24KjjKYMj8H+GXDl/Bg2hVYbkuqdlEhDai8jeXy7iKrtwPNwcuOu/ArkZdEuPXP9lI8oFdgbtVIITpdGVaXkQN6eizAo7Wx5i+aKdOshLOn3gjY60C+V26AWqodwnx040zyd1Bijkq+2iTWk3rpiDv7QpjXHPXEjsxOxwSKTOoVipj8Wa+NFYszxo6V+y0Q9Y+v54MRda2xePUgeUXYBuRgXGQGNpDxfJod1yNV03iAViWrw4plhup4v1drqQGqkGmi+0AylKpzXdacdpyMftdNRD3Y0b6gKaBk/SJ1eX9oHQjfHQTfFV9p7usn74mAdpvLg76aFKUqZq0g8hMj9dz+F8y5ysJ+mmfpcPtz/aPID8+VGGRh/nPM45r70MGXO225hYph4mcq798thPMUrnaq6TSB511arM5nTqOqfwmR8zptCrh/H4ITzWoM9oOgXMJIXxR/QSSoBD7RFJicJkOq70RIw0ALgMEX8wmc7doZ9DB6gzKbPaOcR50wBqIPf4BaNaCeY+AvMBrq/lHxkaA6gRpyyLW2buHzPLkoDdGJUIwLw29CHbIQ5aFx0B9H1x1r3Qa1z/sl0ntl2FA/dbd4+lP2BzusvmNGHpb7fxdlj6Nhtvi9yBiFvdubN1PdXOhm6D3mQ7a3OPy6JJ3wOBnVjy6r2a+0w3dW9KYu5zvZuSiLsa9d6ZBhvQ4XCHdwBm+lmOaM6PaXPehAbQEqWf0iljSYkbLKZu6hu8E5O77QKRdBLOpiRdmQJ7Bz0au4x2HmiEUP8olRFWpRjdLdZOnlW3xPUooR7o9M39p0qdkFzSSRVxK1QVt0p6cWaJRNukgSDHolVdnw1wFXrj1kLewt2Q2jBmHQXwEisNKdxsFZd7HCOPeZApvbSZKf5zOw0Vwehwyo05ov75aRnqSvxDaQVKSfyUVqGsipy6/Fz+qVx900WF35HnCM9VPJ9BHoW8HkyjsXivzKIVrTKXRo6WcouDpzKyohK3cJkiKjPcLVNIFYgvQv/iSTGy81cHu8MsKHb4hj7Wrkk389tBHXqVqI3OGH3xeBLqGLbjt0ydGofz5hJCljmFAPPd6BAxZzhfsx/S7M9A9gXctc8y55yKkEgIZyiN1nOG7BtJy3CG04oQFo+rkCoU4Q98QE5SJKrFoq1OqgdXoAtaTpmLbD24dSBPWaOBSeYOVdvEEuE5o4b7DHWyi/dBjlXqQh26m+vAzHdRt8BfMrrevooDS5wJ9/YOUR/Y93dXcv6L8fUyV9udtpgNaUAGV6cG5OGyVHGuIRChgnkYepvSIi5Vhd9sSpnVGziYnbXscMhSdeYrcVhzGNIcSIkDGiVWYqRRcH6j5HEZEBb5GMN+TiswmoOIDB4jaI+AGsFxc3DhKgyvUvUfPVMeb7meFuUEtW7BLF4SolT2YQ2MiSviZ9Yhon8rVEyqHIa2rXJ5jPvNIDQFzlBUaoEO2nGM2TLm/HItUFMtE/wk4pRRUuanCvtsnlTBmoOqKMvOA2XMA2XJL61Yk0AEkxYXilyrjVwrFCZlzYsqHMDrgpjv6Y6ZAH+B/QU7dSA/Qn72FEQoK0bW37gTrMwOP/EARJCHsjzuFmN6OzoiuDvGEaHpDtcLjNnMbcSzNrDCOG48/8AdT4ZyJ77ZTIX192+CH8NYCVffP1bdcTKvpPfRsYGT4GvU2mdYmviNa+kfyq6l96vEwZOupf+wZ0rHeSn5QONS8nv5ZvECWLC3kWeXkA/YS8hLGMFyCfk9iEu+XEYut5B7GLkfbbqIPGOeQlulIioil5IXwUPGiNyPf8OLagMbuZrMZ4iJyMdo0unHs/JDug6kF1+UlubaHJhfT2/+LsrN3+yEiCdOAEfC4r/P3Xxear75vLsaf+y2E7/y/OMtV54P5K88H2i58nxEStEmMWTgYTFwshvJbICQjn4teetN7XoBsbZj8wXEA+6e8lcbuaobIosV1XE3gpaBNt20OHgtnqIxPEabFOq6c2eFxGOfgVZB1xQjMca3J9O63KzNNVQDsV7/jQ5C3J5UlA5Ggd5u/pqTxgNUTDMLEVjYV2jigZ9bmfig8fxxf8yJGEMp9S1Ll9sxgBxF/lwMindHHLmzZV6odJ9LQsRCbZzTYpRb/ZcyGqmzspY4He3jAL7UMXcbGV3hxB3kS0QqbNxTn0iLqKEPm4DvmF+vAixcJt3QdxZhnngDlWvgIAIeIgyPoAov6ophFf+DKBD2Qyi+5vqVzsgbN2O8dByTW9Bvbtx9PuFPuvt8m88ud+PtcDnTITIKkFGfYkM4z0/Diwq3Ig7sRqMYrfsMnlC/yN57vNXD7xaP4e3LcW2xj/nnYxwNm5TYXYj4GuXR2h4BqeQvLshV5xz8aAETlcYjP/7oNmsUJ/8s/4a0LFxs2Tq79kIWk2NTOSwv8HdwDkAwS7686Sv/feCHH7noOva/0Rs6+8zb6LLrX/xirHqiiwp7DfYdBtIyhzpr8AT7thj+E6O9XyjcuJCiwbRS34VC7b8XdnINONHt78C/Ly+qU5lyghlEsz5gZTFTdUCg80V1YxpBDh7kcJ/RilL1fgrub9w2P1PlXRWAwM/DJN74K68DLA2Q7VmAH0C2DCQ3wzckvrEP3FFH/a/VvKqQLVXP8q+Jt21VSOtTUzOVjtlM+1n8paY2IkYWtubvX1SvaxPF/wzmdqPi1+jF44+9t3Hx+A570fjH5HBgAY38qIS21cL+lyQMV5RrJlXNcM//7zLULLbhuV0WaSdncshlMteb0IjOSnVoES8LlUQc0/sr+LU4FGFvRN8BL3S9QduSp5WIP42hhXu534zHPbKxaWAP0N6AfywTRNghEbjjpF1LpM989rO169BZuxq9LR6pQ5j1CYr21C1t5kj9usTg/nvm5+qaVIMCbXGv0ckGRuo1Jh1EaB3tH+GnsPn9NvzikfrEknMunfGdr809bZFEnfjCLdu4fbKOTpn3+sEGfccIZd7rBp/0UgNAs3SQ2K0Vlg/G//o6VRQ8+J9DPqS2np2CXNafF/FSHc0j6sxXZ1jv9X/UsMtJvgHXr93qc2/7L/XPZ+9j6h1m73fVe59h/0H174Nm+Bf1PwD6l9S/H/SH1f8I/AfU/0X4P6P+HShpv/r3GvRx9R9AnH2qDpKyMtchIduQ4mzxHkSkoaysmQ0uqcH6jIzFAfF+Cd5e8W5HVnFWXpSxGoj3C6rzyg2t9xlZiJbl4njMG9v9VMwDHMijvAD6MCHmWbykAwX68RxWyjo9qO4ezTX5bo5T1Uh7jUaKLnMxAztnQQBDrJwSrLjBTgFooC7nZQqA1pwIBstId6N5AmlgrFoUvwFwJSmosKkcf501D57echuDGaXGtyOO6j6E3AqY806hWWr8NY3BMvhzhT+1WHOmSvyFrZPCPmdM0FgE+hucBZTCppkpPOLM9DJWeWm5ofTCtnNTCM0JhzMYSEs1CKaEhxmXD2rSgEKkKqB3uFRFzQ3JWA0D2CDJUjJW1hTEH5Rqhcy5A/hLjWHs4iZ+MvFnBX36hIkHecSfA6EzJxXfSsWQcVIhv/qVIMCkbxgLZSsYo6VYaCTAoWbQ8Rr9REB6QYGGdo4I3cLnnqMBHQ6BWP1krHb8AXRDKoLt5RRwB9itwzODPfFjOoXhOabgogIY9jBqTG3GaPw4QjVLnaCIeYs/f1uDGv+npC/ap/+SJ98+/bc8hQzboe90gnF6OPXgPSheLDSCFYNuG39oxKne1SMTSCnTT1pkvZyBAjxO2MeJi+t1IcjsrjXXAZTxfEAb7A5AxIkJAEAdw1YOTPYxFV+XeoNpScetZ8fhsODR6pKdLytsu/gb8zZLY5TuoOIuxl4ve/Oi0W/P+Qe6Xk22YHJ3UtRGuUAaBfCzqIvJYoN/mXdsFZTC2e3mBnWtnKAN3QITvB0VDxUG6xPV93i8LpbOkHiuX3CV0WUcVrWZN5RRhK7mLcVxGZk47Co6ZnJTlxExxf8IGcqzpRO71yMx5M7NGIDuscYmszs1S568+/F/WvWCtYuo4eWJbckfyb9v8aTMYj42X2DDZp1hnNRw2mZeh1C2kUZlSg4cZBmyOnUlDS4FRA+q72myJTSjbswRXI5Ufn6iY8iOlKRIflukJIsrmKP42PjLNpIf/xhjQPjTHGLkgIyKOqehLLdIh693VNfPATIQzfJPUgc/szZ81g8N6xD88brE6ZHhJsvtWf4Bk4Y5VGO43vjhRc6ECEQksTEtKc6hP5zwFl/fWcgWWhE6ua54SlbxqcGQjGCfRs+nkuLp8p+klfuxlow3vV8WWTDsUnnjBiEOMLFK1frEHcDFjcS87dZRpyp17KaQf+LDEJfr6mJ/xS5dlFbf0SA+vzMfAcFx2tEUTCiIuJj6BMZ5AGwkkyWUPqygvIsYOZtUCUuyUk4ky6xZc9gNvqhpFi1yY1EokygeZo7WPrAd8yjodhqFlDTojbfkJ1LQ7TzK/7lZ4Wth4I+bm9GY2fpP2xJ5OQS3bV9hHpZRRZ1CGUQb+DHEw6OtGf6Ko9XuwoSXmzuhehR6XcueCQ4tIjT+ym3K/7ZtnlowUrbjbEWhIWgsKCxC+aGAxyeryKiE9anmoisKUAEtDzE6brMWiHiYPMpBQKiv1Jg3cjYggxnD2THLeeC6xWi4t91o/LXsEACtOCPqzFdnmJ2HOM6QdUmTXKM15F9y8OtV6FssUrvaVBIrKPVOsJZhM6yia111LPnss8b/6F0T/7PIzUMjPLC8mtHKq7KxxaCplWynYLPkou3DX/vzV122UCAtpvkG5TpXZsHOx6dREcv9nRDrTl+nYc05Bx3D+IeWvB3GZWh8GOmuTUM416clTDwhGzJIfTBpsiPmnALvEpKBmojAToEHhFEDTpWdGBGrVBKzji+xFvguB5eaR3gudaipjUttqGRPbmPwaQYYiaGakLDDAZCO1oi/qdXAi46F0Qb1aw3qwRz1UVCtYPfeoqLix62+DggN2IEA+Bv47Vxj2llwuPEA1P5PG+vMvqCKTX2xzIjr819xsxlr3QDQ2UK32ZzFIOasAz5YUdQNI3aitHSlqB13BjIt38lGh6QiO6pJlZ1wUyLjOIAFqZOQNumCEyfdcAaSmLnvwQoO2x7bDLtVDA92O3iThZ0SBpM4NyjxWo1zjSZZq09LNWxEY87XsGElDmkUUuKARtG9WR+dqUcPPcES0t28nZ9Oo66mvfy0V04A6OqKNE08lvZtSvuZ2o80VCZ5jPnRbuN2Yl8bJwCw+w+zjJ7Vowp7uCAzxuX0yq4/9aDBeiiyHTWQJS/5YuV/dgMlT2fKvWgondLtWi/GIlapUUYNCGB0ulbV5xki/oB0DrQafjgV+9C0tX2wR7jmir+AaE17G2cUsiiY+F1UJAbIjr9023FF+7JE+7fskElx0iGT8nEeMgn0kMk++hmfMYmU+lhkz5hE9oyJpX/Jxjtg6fsjPWMS/QLPmHjujIl30s+Y8EodyMOijT5YIlrPmHyskD9jgse2Z0wqT+GMyRefxhmTiycdMdE6MPOBHjEZG035R4+YoEI4YgL36EdMbH84aF30A9D3RfkjJlH+iIn2GPQUPWJi3T2W/oDN6S6b04Slv93G22Hp22y8LZE7YhI9zSMm0Uk6YoL+1g/NxZ6UZ9dTm46YlI94xKTMR0zCdkdM0JNTbqLDBW+YAdMwqZ/YT9Yfsz+2ftliQ5foR2841WZA3Pqj1P90TqJE9iRKZE+iRMc6iXI3NtezUyiJf8RtdS+3rY4+135bPTz2tjrTfaRkHyRdRUrJkj1DSIuibNfnREgZIyXnFiO3CnKrNHIr8wCqCB8+Z2CFi1yUSU7MOfCD20D3jriBHh91A716y1Pb0POOvqmI2nlooNY9xeCIe4pbTx4L+t6f8tBuUzH4Nd1UvDMsYvVe4r/Gwu+Bcs5UWtsZjhJsjW/S10+Il3kTIX53hmlpQ628DCzY11p+tKjOA9B3VRqZQHes3RXCaooRAqNQFU6Ewz0WX0I8XWgWewYqxJIQY4yKrl4+P3SnsXv0nL3qIK+OetCCu3KEU5b8RzX59uGf/oD9/i7m/C/BubXBUg/5E47m+Gx4pHY7uF5wt/lp8fJBmNkgTfwtY7Wq2L0XfJK/wL8rZFc57mWslJa4YzCLWho/lPhh1zt41w/xOCQipkSg7AlVNEnRapUK4ncTLDLdUsvr0u7BpCgdlD0sA/TJkh39KIVpveiKvTQNNBwE62QyJkuKGFmcMsGVZSHUG03yupHdT/pIUtqze+JJrmCNAZmc5OK6FV/OIVR8KZU27kn9CXQWl+4ANywGzDTUG1wzxu4BdjnLfwzzRH2COrhkFat2krvKaQlDssRiSYpgLGJ+q2jtbjgsRM1KKt+J5YvUEBUQqS357pV7nvFn3/lH3kXt5WL6RCoT2X7YBPdofwEkClWF3nIjC1/kMA2SmmY1CMxkMercPbnv+i+zR6i1m8/17tI2cWu3kIeCw9Gv9zyswYCFG0dcPKyJZKgPJAEZXuB7RAYLgAF2fEBSUyuIGRtxSYIRfQZoHgwCRJ6NgdRna/whie+dDYLEHwLN0xiexEB+87XsEVf2Ui17RMuer3kt0bKXSjCiLwFNyl6qeS3R1M/W+Gu17GeDIPHXguZpDE9iVP/JmOg4DxodLORPGvXhgMpBPW5jDxzpsXNWbtnJIyTSo0cRLC7u6FGfnjyqyMmjUvzVpmNH8b+o2cNux+lZofhrQvRQEB6/njsG5DUfA6oeqgTFMSOnIDKNjLEPvY3hGOR2+QuELV61bte6V+QNlj5TvGWdpqFSksxmnoSqNlhH5y3pzH+R86xyLd7yBuYlb6WHSpugogbU2Tq/5L0fuX7/43/8PTbAr5d/713UyEnt/qm/ZPrGh/o3PvRHizKL/cjt+3YvOW3C8P/LF03Ud9V3UXH3ROJXNfjgn41QoIVgf+MHC574yeLZ3+KS/V2p5qGRrh+M34FIElXlE1AwAdvCdW7rIdwdf0cWhqX4Xrguu//h7HiUcsml2zWX2+PtiLCLk/uQy3WDTQy1K5gjeAiBIVlmRRYcWgFdjNscK0cwBKxieWR8JMAsSkxzwzY3qHENaloa1PyKNmjlqTZlWVsRLpVdK4atrRhKK4ZPvxVLInmY+TDaq+Qa0WN58VMSIVpEfBwcbdCmbX20l3k5FUanWveXqXXJUCTtm1YHUzn9SOyRdjQrZM7FiE1YiFOad0rzTo3NKc071bo/b83bepT8j0/kBPw3Wk7AHyzkjsDzU8sZ+BfJCRHG/dZiAidIVbVgHbihNjH+Ik3ox99E/u5VCph2vGgecsEK0tO3IJgqx//10FCkTgAHXA03TtwH8beQ2bFO2Gcn6vuaDtSDI3uifq3s5KGEy2UcBWIV9CnQdYiuQhJ+houTRViJShwTP4H8yEiI0ZBq9VnG0wx1CYVcIV9sEkIiLJDR1LNJPTKSiApS3ervmmBc9xOx8uPisFjT90lT2d+WhkBIOMtDEKYKBGKDB6GhS4AnMS+lfm1AynifZ6Kn905J+yXeQH6F1/7lklL8f5uXeN/G41HfJinl3yYpubdJSkd/myRsvE1SanmbpIR44gRwJCz+Tm4ZGba8TfJdXd4uNz4axZNdGY4iLSqQxnZ0nCYiH0aI+MNb0ae0wblNYXRn4STMDHZmTuzFlO891RdT8sPk+0h88l9EwcDPdSZPZZZ1e5+FxIbwl8pw8tB24BjvSzmLTFB7KTZ9fg99E529doPbKsfwk0bNlvT3GmNccfuyV0rJtBMlDExy3GGAHW8BznHg9UMc54XPHueFT4/zGj4Q2Jd4oLCRfYAzQEcJFuDEBwyDw+jsaOFddT1x87j0XpRe4LJgPxK7m2P2NV6xaI9S+eMqelLRF7Cbm3jsPlYZxY6E1TYBj7RHWUeCXCuwV468YAQGezDouDsHSUQ489iXljFjy5Re3KDbh1SB3YvPIJax/0ClpIMi7MTi2JIaETvYqe+CGbBa050TOB3UiTI6yaxCI0j2SRlGtAj0aI+UsWc35u4SzuwmcgCrnlQosml8IUOtwYWUjGrBbxvfjAUsBn1BwpBFB/te7eyWBbZM4lBfwyzZOPgOq+5fQJRLPvsZ/PuvRXW2cI7W+P+xm+LPyLmpwJ6+yICAvxt8wC5dVAURwgmgCmSCcejE7hVAm4h5FwgY86zh1gUh2pVG9QkmRHWmR/EPdd8zwy5yKGWcKyAV/f8qUaCtfbMZN/xXvTl3oiPMa1lyZlT/pQy2ao9W7L6T/dhjicob8rCqwlog90SRtq0wX6lL007IVtQruUXRyGCqQ4dQyP2d5LwzVdDskcxikd2wopLEUo2Ds85RZ9uXLJIuZkH5RYajbJZNujXvEgorNT7IEpOB5HvgsIAp4O9SnUI+/05DDdtk3iU9tEeYTKv6yZ1eipM+p+95ix2IJ/d1maSfulUGiMep+6mPQ6gKFhDe54ShorCG9F7q43gdr9n/qRcN/+E3FjkXebZ8oIpzSftbvzAF8nSQR7A1ste5yhZJyLWnPf/BAx92bhbykhv92a8/dfcHnYsQ5EbyHz+lUoc+/KeMjj3y+edd9OVvXuJcYfQ7O896/be++byPOJfzEPqmn7z76q+f/smFznX0R57/0KkT5sy9znX0vzkU9/T03LLIuY6+TID1x/c6F3TLKXiyuHyvcxHW8pkt1LiPJlfn4fnbPvIfT9z1YedK0o+9+8EPv+v7yULnOjbuX7dzy5rNb/qIcx19R9+nuRpPLHSuo7/iSqD+5+x1rqOvlGr89SLnZtUZIG5fY3uhc9NTD69u7aPcMl8w6WmH16WDbQJn0CB/UAu5eZbkXI6+mpD28DrbcTupi7vhALc4cptOM2i6pKVTD3/OUEv0Lh4VHsZphF2NvBLAu9s1I0ogpC75WmZFz+Qx+SYeSi+2WqFD9vs5OnugHUTBUxGKo4AtmIkF/HOkjDs5Y51VnlKuhzhX/qEwd2jpduOZ8XBMVQ1GpZ9XcUHmLULVGFWNGMSYc72Jpk3VzBsJm1GdSruwZaJvtESs+I0mjTBjUnkixbTpa7F65iXAgpIKqE/1tTlUMcyQU1luj8+wlSVvfbPD2Dpmh6EFscO48Wx2SrWzgSbER+wbgE9ORyCtURAE5Bn/NyYUjjXsZHRfGLqdW7hH3rud2rud2rvtQ70n7d32nsDebSHpnrRp29e8aYvq7+hPPbjb+tN+1lbedYP2lYlPLao7vHbB0bZveyGs3pO6fXs5j9D3ZWgs/qGuBFpJTNzQQq3vjt/0BmRTs+v+GnI1WOUccruZatAw8Y9ASMUAobuMcMiwJLFobb9qsvnlV01IYFdNn4c29MdyK5nAjvAA6mSYHYMFS4BOzfvBKE5eBArkwxPsBHYhA58uZODThUxBFjJFuAf7khAhjQWNid8pZqWS1mGXdHAvfiOIOQzd8D5/sF7HYTfy+VWoulgg4h/rh12C3Frn678iMN8h/LAZ4Svkj588OsT/hO/7mMParEAtgFZ1FPry1MHd1YcOgm6IoDhALZAQeKiUtSnSCgXCQ72eVBtFY9rSVqmnHbuoI+OpfkcSyTQaNGgv4J7RWBbu4gzLUjfuMcw/dcgnf6rxYdSOZ1dEFFWfpZnQ1XGZ43XW0wo/DuvjLln9Ij/2kSQps28Ac734YoTenmrUqBEVYuiSL6ESKycoXjnIV5IZWjUsFLnoWFU2qf0yEb+400ndSiiDBSZU0PdRE/DnalKFmuGcrVLpwkMXHkSBoMuF0iaqUfIL84PGNNrwYNaGVMSgu4YdHmOkNoO1uvRfyg7eS+/D7/v78FUBfBLhCrEefBKnEy5oGBKGxbcfxLPFewDeITsqjTUvDPFojCX4SwVnkZjlEQ47y4jclXqZ2X0k6xYhj0c0loxea4f4SfZ+iK3h+zwejuG493MdjmIK7NXhGOtw7NDhiKaXwVluGZy+HZxlGZDa7IaVTcrNC1KFu3OdWQK0NDJs67oSR/fRl1Zd8ttd+mMlreZ3IBI/P8TnYjbIW8msMU3NWQ1jGScpiKkNZlZO94ICwteSVyvzShvolU/Og7R0Ix5LN+Gkohy3Kqj1l2AptockfYwRwz+N52AUXKHHpoXaluCKEzYZvnb7UzQZbjimHV/Nsakf37r9JFrxt20/DvPkRTmLeuAs6lFmUb8BBvXXb59kUEfNTsSyueqIGwKvQxH6KSd+ZKd5O0BZQFa53YCLjr4b0J533Qx4SUGPcyHLghWjtfqr9R00T2N4NgaeOjR+r8bq0HbA2MSyRQcrQiVJhzqxOr3VK4xpNeuCM+ZZioPe+anbu3AmXaXkDba9BW1GtFOtEG/fDuKldpCREeuwtRTzGTrin6FR/A7gZ+bohtorbyJvNLH9sOAk41VLuCduX6H6HGNaNzOk4qguMBf4bfgC4UQe4r8AM+rdod6M77cAoJnN2r09sKpydj25wA2Q+KA3WsJnRwYi0ojmKAhUTLABK/wrQQcI1wGPAfqExjeQo3WC7qoOOZDgs93493h42hIwRlQLqWxMY7zar5XpgNUsCypoZKm1iT9yq7RUYsCHCHVyW73pl6mt3pK11Vt/49rq4WO21dt/mdrqnVlb7fyNa6uvt7bV/wButpElsajNqMgTuvNd2RT40tQTNlDMK8ljIBBPiPg0+IZc8MZ8sOT5L4UsT9XHoB5oS724HXE4I/7oFkekdjF7W2I2WjqbriE5K0Wd1714K6qqARrajK5OEOzUW8BO8NIM7OBhEth5VrsP99VuvGnDiX+z72iL/ieMMTe3/YoV7Ip3vfHV8p0q+N+e82/L+Q/tgP9+6UkYpyj/bXg6Tb+T9SWNm3/F/QBIGrpfvejb+zLvhzLvHvH+7ZGy9w5mUR8V79+1i/pAG6JgvRoLcd//8BupiZFM9AFiw7IZDxhAfy2qrPpT0w6BaGQFIg+byVvJoO7PUR+x2udjBjryTvu0L/eEFA9mKTJEU7urLXVnW+qOttStbamHCpOoTPuGsf0qj5xi/uQBROJ4rZ6F3urQNbpw41MyXvwJxGCJuPGzzcukd8DkrEsYKZDy3UiQoGjtnGqYrpn4Hgnwsrbya1xA1lZ+1la+bSsKnBQ/Y7iEzxhXs0Dl2Ja+8wj0HUegb21Phzxb6VznxomB7tBgS3ZzxJuyFRYgUqRcqdp+2V33avNW1B6SrnqvdpDDhUKcBOISdhJmFYaTkDSAByFTCxTOKwyzU+RHYjdgN5a2qX3m7e99T3B57TuvaeQIelDzL6/xUZ88DR/WqgXLaj95bRO5oz05rt1CLcQZiOu1kIfbkzuk1I01Zm9SSG9t82ite1kLOSnBGUB2rYUPJBEcQuhwSyglZf1o0itGa18ttQTPTCpwhpA4bgkdSvQjSu0LPjuRmlxQu6Ql6AJ5OdS/qWaa6+jVto3DOjSyrKWt59u2XpoUxb0m6SYNuYFb9Qb2d7N7jW3tpba12QCDLp/E7N7Fbg+7O9k9xZ7tmMbuVnZ7a/Oxky0Lwz4s8D+U9tdwt1PpJjg/Li3vNNRX+6/CFcl09xr0dIFiLhr06JOlpfnq1ArIE99qWysb1n/AYxJPvydP19qna5vCbtCnpK+qgyYZoL4mEXXVvJfLeQ/eb6DyxrRvTZOofOqL77vFivmVeFmc0zNQiZqiMVcCoKbTAEU4o4W9xH6mIlHaB2fMngmiPgwXrWM63dYy6afpmVwgD06kp4GQI95j7m/mmqINaR+z/v+Y+wrgRpIsbWeRyi5JLsuSJVuGV9kejGUcntH2xv7u+IeOaSgiDiXtoCdi2LvHDB73MTMzLO8xdtAxMwQc3wUc+Pa+770qS5bc08d33WFVQmXmo8T36qVkp+FtSzaB91MdqSsZAe7NAtwzgNeldwIw/kICzZIG9Wc6n70E2OEZYGcKNuvlt/XhLNhIHvmQkC+pNQZoDuPbObqvTtP9C6lsDY3wnVk8OsQjEyCqeIjjAl/jQ/qttPKGzZH7DzJhhvpoZIRixGEQzoIkrWnQv9KxWrwXXw70NXEV6HXas6aMK+gEnjUY8F/rPIEhn+ou+y/EIaXkN+Y4sDKNxrcaGuTAldGYhp9FDf7v/O+CH0PfHPD5NPA/OAX80izwSxXwSwo8obYyBvU7/kuhZjNDyd4y+JGpNBxbJ2EN03Q87eY/rvYTOm4RNpvDbRjLf5VFi8SGW10nVGk1G4p1TVGlpTZM6/qjSlu0IVzXKlXakg3vuq6p0jJuC29agGvSs5bw9eOMXkgXhIEfdbb9zGEPy80i/6DRbTAt9c2H/TJNaRHZ9LkZXq2MpUp7FX9eBkks4+2CWuicX3XGsvIGVZssvyG4xVxa3aBeqIL7JOYof8MNwR5D1wW3vDG4E6FE7YE/VGLWJG8IPlJDPAz8WISaprcIpfmw6S0Chqi2UH+dtRLzpjW1b0a0z1kVAOgpC+2aKW2qTakKSEN1AgJNx310C2HgjW8IxMB79I1YGvxytfiMYTOhF1Pm79AGG4jYnl49ajZsBcxEC4EG1FybXGIgU/gMlRIPRcK+cDV/YKxekSYcd94Q3GtwvPmNSjCnn+aqMyCF/T7D7HVwY3YaSkBgILoJiD9JQZkFkdJCh8rL+a+ZcKMexOA+gsf6+d9TM28ciBRzW7radXKlxE+crKKj6V7zB1EVqv2Vt38mRJvvVK7eXkaSQINRvS/u8u9mn3F6azWl/TKmkYsn63/vVMc0MMOVUBzSncfvnlfp3B/LwpiBp8beqY+P0Dye5t+lAFT1SJR/t1FossX57pieCp6nuWT0HJWCVQ+zoeeS4+/POp+CxecXPnDw/7CGOTgvQd+ro9qPVA3h0v19s1riZ0nUJ6aEhqzhOx9KeyCcU1ymx9IgcncoVTDHLHwDQ9wmLWkIuFOoGIqGEjBUG7yO1g0OCYUr7744De9o8Lq3mtqR6DtJ+YQcfQ8pYGHvrIgPy0IZC3lVIE1bODUGZuXUoHuToZpfNRQqn5aaIV0HFouTIs2ySFNcVaR5ukh5TwVXNNKc6PAa0jiJQOu6/A1KwXd/nSy+2+dfz3qpt2XtU/ApbO5ysDVkUkv+9dL8Bt84UWrCn3tgzeu/j2W0cWI59PGMZiT2eCi5NL4BzjzaPGFRqptzRVOuVFTO8u8lfS3m0/z7NJbm3z9JFb1BIv8BSxk4CttUL/vLT33JXvbV5pzEpPMnXXkK93LUQV/lblLPn3FmHfwIa7NX+5evVAITAAPeXjdg+S3G9zoJ2NdCPvbH/H1KQuzhbG4u1bv5D+mQ89tri90D9zydPuqe93l6BDZoc/7Uxz7k9LzzmP6S+yHkjSSlrxXzWhf9c1adMz7kY03Vt4ZFwrSxHkDSVid4EmwOYQZIyRz8s60E1LWN7d4+tqgj3e2pTEQX7MYi/JmrOVKxQbOFoiU11Sc3EVuyGB1cmXHm9J920oimRZG06CqqRQlbRJEMKaksvQU8QA63YayBcwILRFbgAAXKD6ZM/tEefc5J/DBG5WK17gxs34aeu+gAq7YiswZ4u/ohTpey6Hs8usaq/vqgXmwIYgtFnxXyP6NRM1hwQSZtCvC6rIyLTdSwrtltEMJvoeG+bAJKpNQQbA8R42zfkrULxGEDF7lvkxDSKXaIivlUkm1pHd8HQnyWO/42d/yP7vjNx3fP0wlppFSLiLcqgu2QYDskWAfAt6VDYuG5Pip2AMS6ohoBmHXAUhJQNqQFFfsPPKBXLT42TU0lMio9sEozIv4y3yfKCL2KWK8D6x4wNHTXT6G7Po3uPKKGJjCb+Xd87vgz3PG3uP8Q1j3DOiTWPcO6d4J1DyBVWLfMu/KVkK6HmTLZ8SB6wt1NRTeX9TFffilORm7hyjxML4NNVPGwbIzivk8UkB4ZdpFhV3Hyle5sTgaX4aSb4+Tm/y1OBv9lnAyMkwtncXJ5ipNyFoL89dsix+dl+4xlRsFL84vjAbB6KVzzK/NZQVGu+vXTnF6v2Nzipfhej3qO9PdjDHeM61427u+fokF0GcYv/F9nvPsvYjyR7iLFd22TKsHUhOBXh8U5m8f6IMMu6j0nuzoRbopDiHMB6k8JKieBnZNJIJpMAju0yx0P6QhRqbk17SjsKrwLso7hVdm3GCIsHY22SdyabOFIqJxaAT65wfUXm9I27eSqNQS2xU5WIbnDE6ee4opq2+oNr/eO4qpMNmWdS/PKofpValS8Jf1hsaXTQodXA3NgI+C5Ar52JcB7pwHvVoATp5I3a4QFoRZNlmcR4MBE6GcHJMhYAS6z5p50FYn2vweJQJFYJhJmK01E5pFoK9Q7DKkkGE6GxPqE+r5F2DqCR+u8FvfhHRbYmODC/oeEbKaPoesdFl522ACYo7j4dxsu7Xlc1onLunSBfldxASa7LLtbnaUksloiJfWifxZidSDmIxOs+ixqxgB9KxoiUVojv4kRj72c0XW+GI24DJqaR6Qlm0jyW0BpfpwrttnxbG47/m5XbM/3323+P26ki0tZvdFcRv8I+Ye3fZkVxUmNSVNZx30ACzptabevSSlTodFcdobIrahtAk/6kvc/QgJ3ziJwX+rDgiud+gydZZk1LUtOGcwrL8CxqfGfc+7MywGdev5SX/56J+D0VlBXyfq1iFkl6FWBm+okmKEeQnUNtStrCoTpG5jr+emLAP/GBRG2yvNWBHqaWwCKuWZD1u2sWVcZbtkenk28h02cnExGfH6jHQvbR8zRkwXAvT7YpSE5NyJmuoiiekmMT24oVfGJxA/qd9mayiKbqoLQoDxItultQf8Cy4gf/QCOZKa9L+ZqQsfhOCKRp01FfqkWxUC5jx0NAXiPK9wJuME0uEEFrp2WBXykRVz1z8QetcCgh9TMKGAM9KKG994GPxUZzZLVcaQk+iCsgcR8xPMgG0zccAroHj/pF9W7xsCVn+c6PfMeeh5Y+bqe0Q8eohPTDDZ/RRMPyPMyHh9LkVNneiuDQMfKVfZwrWQF5ZDYkQZroYth/F3oF2uygo5edCUj5j0+Uh2uN9jn930f7/X5CVl5BHmP7kW28Lc9Tx6d5nNtgO5jd2RDViUcDxmJqHbg34W+YACQspBssxWt/FQrRVm39AuvCBSoepkdNiL1mmUoECGfJDHhOXeIEjU5JwFiR4eo3kxhJyw4qL4nidjzI/HsoV7WKlVLV7YJrg+HqCe5qFCIYfiAD/pkZ0/CoXLaMi1xgx1+A7PWCzqLMNaRbVa+LStW+SoTV6vpqfzQp2555rBVFjVGHRh4ChSBhTZyH/e54DaSrL8iAFR+gJm3H6F9llkkcqI+RQgF7UKlCMz1nxcVoTXzQ4pH6mM1SpWAGcqdmJ2+KJjbVkvjUAkfTAMRCxcsolVE3j/sdzDDMS0al0d3O+LHI/AUA31pjpxVkl8yoZj2Zi8CqMEgMcT1aNkOucORHo/Y0EGxUK1C9gMu4JHf3LhDdKrbTQpNPLIBxymvOOS0+dOTWGXDJxcBG/MOVHSTibKT4OIdffuIXxIdXaTv4MA6dajHmYYagjkxs5O8CsGQj+kenm2q9iH/VXXyApWAHuKk6gbYZb/snJu+5TqtLvfgYeGepJwf7sQj5AF+at4cU4l5gJ9KwgP8VGo8vE7nRnBU8ComcyBPJVXDrJdp6HUIXauhGxDa1RBtuYQhu5NsU4M/yWCPQfsioa3BSwzqFKRHnfm77aQM8E98Yzp35icSg4BVV24VBo5Vxm96OzJzWhzHRDC1g/iozPhRjPl6VzexjM3lZSyB8kAYui6IoA6wA/U9vqFH8apTMt8dxMgHEitvBy7/EcJrrX8o3nfQdUwf00dzx/QfabY01TG9fXVRHdUTBD3yp+kcz+FnPqb4Fefig9L0RWj28hufUpl1lNtFs/KWSL0XaUogbsSFTwgvy8xhNLcQdb7qVKVaWiYcsWqUOSd41CTh8S3LnPh6dhRUVy2pUtac6meHkmAfrF/MFjW2n9ndC6e/JKjhMXVYqrzJsr+ouXTqq9fQsDXTy1e9MXgVQ5WHbwubh28LG2AM67rnBjUmFIefUmkUMc98jVqd9FfKkI5epLeGI5+APZUflZper0C0xkz/WA3XxrxNZkFVUkn+/Z9Og7KqQKzt+wRaq/2qQhDwYZZ+SvjB4M5w8NBj1iWeM4vLAXQxtP1B7EupZ7Zx62U+Uf7yokHVRHwjnotahUO7VM4T7Lc5bYaiDrA+1eFqkVLuAktmVflvVVpJHcdi1vIGhCjW1sgR6ozzn680Re/RW7xLWwWtZ4hWeWGNJdpql4MCY3s+xkEm3tjH5ZV2aWU8Zsa+/j41zn9b5bpWvlxmxVWuKoRRp+YmlmtvPaWEH/uarmHMRTcltg1SqGTFelkiscnRbi3/THYF+vuowuoaJOSg8juEwW4hfRlSXmZdiynBTEoMXJW8klhIQaicW4Uno8sgMlJXLpAUnDYfFHCENy2pd+aLMvXitZa0OwsrEZ4Fl+jPJlL2OHHoB4elqo/slprJm15n5DiyqxqRtFe13z9Wqvh9slDIxr7J8L2+/KZ5klHEuuA+CgwZruXz3yWg5EFigP8e4wxyNLvEyGSVhORXTaxxL9k8Nf/BKYfbTYkGf/pHn/5PALuHYED2RqINRWda4e7iLY7nVvwGiarRWiQif9uWnyKfGZCMH4UxqqoDbSSOCL2qPKbTqGhUVaP+XegTFglNvaHfm/7b7t153+fO3btzhRI/dUaJdwTBItcq84WQZP6prHvhsa8iK+GYGRHz0ofpX8UqXBpL+vA95i5uzNef8rUxNZY8TkOS7gq4zE7xiPYH0eNFYu3ZOrpuA8A3Okm4dPGN98xtYSJZBBrv1XGnLgSsiLUlymeki7B0SA3fkdQPv0ivLONkkqheE+0a4gqNnk9AeqjHIWpFUiFVpNVVBxILkEqIl223l4pQliqL9+9vJysH8fMxtm61g6jctRaq6eQNIBzQOCha3WpPZkOVwiEjv0gRIkaqwVEF09jzipmDJ7hjRkrClEycpaSyCKRdgfmOH98yn+6M6rpdQiDc880+3kBIEAgl4TgAAhDccgW6DPDdWC/HCfhLPZWkoyK0k5JrzYcYh2D2rxW2z1Otu/1qY8G41NaVnX53Gjw+WLi7Su/Ug0z3ydneTFIgS7NJDm3+GysoQ5LjrN4ikgOJVJGAdoqf6msyNOSdSX54Vn7bKqCtHs9YD313sqDuSPvFz5HuxWLN1jYnCHcI7xScXYMzlYDEnUt3Bv90UiJLs0kBCcDSV3i1DJ3GPq1Qa0u7Qq1bZYZnZHayCe860j30vQneXekA795FEIedi9PLIge1HmIph7hF/crO8lLLiyyP9oegrrTZPuSoNbJdeXCH9vnueXhPuO1+HRA20O3U54aE7GEYWyoio4COAhyAKFb1wcKepkKISeKGxqUuGWhF6y8+uDxbMjFuqhiHFWc5f4yskoBV09hnZJUEVklglQTsyGO9XrWszifTFTKVCSNNGBVJ1UCux0D4YQJCMzJWio/FJT/NCd9+wLMoiXaeN1IfPVDVk/DNjnTKN6V9kTH8X2MQDdj/I/un+8UHGg4iQlgcDTobsq4ebeqSvtWDekBOQuKonXtCcQlJ54gkcZKQxrGFI5LHcdDDIyOiMQWqorSSx8clvvfZrajqSmVmnA7prYdnj2hdbx2rtIcSs+XNisOR9Nn6lsZl0zi8VXE4rtrtK0MiIErWEngDOJaEvFUM+pYQs45Y+qwjJm0ag+iuRlRPsjMq1OJGoxH5HUGva7yIZrlmyRMu+7UHPF7XDjDDx1mCzbB1rWQrS16OrcCVdgOD+P9T8NmtzHcdOByBMRl+gdoGTVA2zBXAIBoY6FqBdBl+/+H5S5fuvE0bsXr7E/jbTLntyHcmpSirKaM/eniedzOeXXDt/HX3fcGtR+rRq4P4to0k/WKHnln09Y/h20x8fL/Y0k+DCpEVPgpZLqcdLy0mnKOVxACdDxG/Oyqusk52tT3sVLAlW5j68bjKLs9LcEfnMWxOfDgWhD9VwwkrqI+gzMOLu4Ks+nBcLIvX1anIOST5xmgsBdf+zdGY/gCZ2dTsxnCM/4X214h4A0HicsdRcY04abH0IunvZHFUNCWQFuvpU4oC6Y+KmOMe+16RTA1sIf4Ql2Yl8YnEGpSmCXusws5SFFV2QpaSsm82rD9GZX80H8j2X7iN40PhrRZKfnPqtFeHKWZ35tdRxJBSiOPHNdYBlZsdD19rlL+Op7G6NZEN/F0rvRftGM+zkInF+44OS/GRTiUE12VyjawdFh25Wq47LK5myUMSdYFEPXwRZrVRJptmSAsUp+bjkHMRZnzieCbcd568QOSdoo7RVtiBTyhQ1tz3rIGfAXRLNDuKn4ICKLKSAsTjR4EHxlh2SC4RpCHK6aZxuk6FcJ3fR1A8IlGWx8pyadHgAH1wKFt3Tl+ouKMLrm1pH8nV57/gx5+89ehwOdNTvOwnv9OtbmHB6PC3DAumyjIweD5+dlXDIf4SLCiry2xrU4cWthrntkoCNpWMmRYxufZwkQqSx4JQbCIiteo+6KJm2ttFznZM8DVEJR3TAWbEozgJeDbKmpbedPDG4O+dLIku/AO8hW1egHigpwGfGTCj57Vg29fHPmXoTp/wqA8buoawcrxbNO067dpAZ3y+9TJKJZ4auYXrTDZ8YcToDWN6d2ZZWlAN2Ekw3gecwbF/zKVhkRxNrCg6VJCAWV6vkrrQV739km4CltQAPRh5zFF7pEFl97Vgdl/UV6PT+9V7dP//o9GQu5G26T06GI7+3kEpjOc78Ozi+cf6LQlgoC5thY8NpKac5CKcswxN4yArxbaOWdsKHytfoik/f7/SyTafX+oe1WPoSjsc+ZTA7RRgh56Ep6ajVKuzQHYkpToyqS4B48EZt8zIqDHt7K9HqxvReAua7ZJTnqE59d1QWfRG5rSXDprtYNsAyvlTH1erUKHIrMiWKkj+lb3vjG8jO/JsNAE0JHBmOCued2zK4v+1CJIiSAEgQIJJEiGNSNHynLOt8wTL3gxxw8zmNDOXNweKuvTlcs4555zv++V83y5/WuvnrX9VNbsJgXK2N0k/sNPrF6r+r169qnqvAy6ZPf8oBXAUUqnQZY8beM6jBRqEV5WZvJLO49LhIY0lwvF0gYe5dBFzSgBe9cjFKwMiWq8vGo0W5bZSKV0a0pYVmphj8cto0FazIgcJLLuKBrGicLwXWvHu6H808hCFmEbHduHZvDT82bgUybOWGBdrcrj9TIbUFg2aPGkiRmso75KXbSyghStDrf3SEItYPtT6MThE3pSk5JXGj/JNTddGPDwdzlbP3W0J+ZOQPy2usp7Q44MQ6/uRvx8NGZ62oTwrFXkmolBrXfVQ2DZqpFmH27uVrdfZTs5PggTx44sR1GR3WKgevdSrkP/jHdj66EwHdpzVL2H9tFVNdIaI/wzrbpvsomVRCyRXV4IkSqGDNroaONHzCpN6PWqONb1RUnIkqBkhBNZyy3ebrijVFeAdXlPl76DKx1Z8V2mYaA26rEFXa1BXcfyZzMO3xoJymnO4WgcgPxnTkDVrDetMTp/dGlpsY4uFrFkIUogmKwozbUv3bKRVlGflDGna288CTxcxs2MQ3eePnC4ivtwqPRU8Ew6eLiXOd32e0Mkq96XHDZF8NnTaWuE20d4ncARGRfBow8fgx8hBCBXgQzQ9DUL9DD9tVqP9ZcRPbPiJM/ycjaGys64orbBwIpNQGaqii/lDxMMH6g6YOhNmlL1deYXujs8LYmnCFxO29ykAU4Iqvzqq+td8XPEPWtbUD8JGO+zKWgKQnBDzKGA08zoq5l0q77ucUbyA9ejwSacIl54W31N8d7LiS6HmbOtYSaFSwAtQKZafi5xEiahkqWV4qRXx0str0mNNel9GxOi8P/Kc69mYt+xzDaAhs8/7g9J3ImLkPi6igUuYnfqb7rjhGB3m60w2hXlBy589DuuWy9TfYhrX1u5RRykx2bTyLcrVFEjA6CrW5e+GEqY2ii5hElZRIbiw8fi/liRQdDzIagRZrMciyOQpoL4+rD88HoMz8tgqmbC6rCRS3vjwn31EyvzNoxS8C+hh8fiI5CQJRSr82Udhk3dfsIdz8mjLGkgVKtMBVjj6X8UCkrNGf6XANtbk7w625O81bMrf62g8PhdfDDdMjJZ82+QJQmDVgGT0qhToVUNNqbUt1MIOrmOVsp8Z3Cj+Hv8XpeUkm1j8yf10A9ewgRt8zlT+l3SXzCbL8nrxx0i2VWdIrjKyA6rKmHMiRmx8wBo2Ef0ZUwWPT6i8ZVS8SBIrqxJlVmoGc07bKpPlXzyQ/RXI/gpkZbCd+MWE2F9B7K8IWQVhUyD4twkvAe/lLLQ6n9+r/7MQIXhZdBlqHrRI0AE66xo4PHCPMZ2SU3+Cxo0+6odpJCyJ5YpGmuaJvaOJSfQf6PMhqHOyXWIlc1sImI3cexAWBm/ysIgmkTaPJmPsltBnWOAy+ryadU2fZoMQ87BL0Nh/XspqoH0qvjyfTjnzQpMOgSU0kbxnhlnfmVGDgvB71ubGGk/zHaGLRcyjKqXJQQyGLF/+ypM50J7Uzm0UaQ/6mvcTmimkjKak1TRpQ00UFT54b9rSi44ahwSVgkCcl+Nk2LAqv6BiI6EVM0HXNV99h4bqueKNKvsIOtpNY3bvTOkmcAVpYFCdXaHqJzkSCUP/Fj5NPWmkpafJgXXm0UYaeaKsnSFRskFvWNsuhhp1Y6N1S2gdGmY6C1U5/quqtFqe9yaMO02o9e0tWpvl8J1UVllo6w7Fh97Sj7lVCV8hJWonDV/3kOsYzeHnkMUgDjE6Y7NBT1CtEdh/KrZq/i45cqrYA3fCVQLPkMDqqkJMjunXILyfShA6q9Bm1zL+dpU1PZ1P5hCY07sNyY+Z15zVFk/RwsRjkQBhQ0rZQAMtI7QzMaw6EWMnYoIJfpWAc3IT6eUpDcOAvYLEzovMZiY6F6l6S2NvacLKgJukV9mAHtu4qshoERItg4R9dgM1djkhmXV8zot9Mt0RQvMW30eHP8bv8I5P/GKffVGuWVJ/kGST7EQNPRWn4pwAz4B00XEWIgWhAW3XfSh97d06hmTTpnUioOrGkQqWT7q03khU1ui121jn1IkTYJms1zVBn29ZKhpdZYZayLKYW5T3xZaNvoCOQF3d9agix09HxJWxv0v2O7N3hHI7pB3LquXMVsRVQyxMSZTBCZMjVtZWxvA1lpEixP6tAe/JvoyjxViXbayaKGjgpBjacrKMqAzU8yBgD4fpMJ+Osv/AZurGjapxo2bc6J2WvCyxo5z9IfY3BX5HsvqhHAfk61N5J4kMSqO8o0CtneJd40ne1U7xrgbVRfIsi7nVCnLU9Qao3tBS3kUwqR2byYhiyDglXFsVMv9QLmTl6vv0CtEp5vDhNioFsscjNM/ELw+Rx6cazdnh3J7EG7Abfd7oY/IlXrlPhVHqpTdCW/05l2i/fJckRpfekOhk1I3csxD0Vjnt3B5xPUQ+VKHj3dNMCCqgmqiqcqAG2BZFBmU4AfVEWroRWK6ciEsmxpy0Pi0IBdZFfS+Bwc16m54Z8oM/SRINGfkyb3ptBz3+JIHcbnLn9ZCgjxbIxQeqf2KeutvsUIW0s2DMmso/YRR3Uuf67jxmqV6hbyBRm4s50qTJp9wgJY29VkaYLkJLjor6FpO0Mitkx5c/0P4oYS3ODLSHX2p+tL8AfrTP5Ef3qfzoP4Uf3dP86JMfcyP8+MzIvzP50cec8qP7JD/e+iL5cQnvlNSmwFbc25j2uGAnsQUTs5Lco6SDDn0/YWbj5sk8BK3Hz4eNcdMITLAZbHrTW955/DxWZbL150uD+PEfLWmLy97ip00ASIrYNP+mkqInOuuAg7Xyd/D2W+LElktpGZqUSTFaGpowgdiorovschUFtVO2cyo1JIbIh456VdPBt6U3MTjULHo2xaBSFzQHntEdK1jbx02NhDx4Pb3leP10iXd+pGRPfkZclzz+UC5bd+vo4Nz7AnHz7EFoEl8PVAG6hYpk+bpp6B1UD1AVAW095I2ih8HtsWQCnbSS0pbVDUH45vEpBmTTSGcC6qB2CmycCRr03ggvKkzCbTlUJdxEQ+fCFTlUvitcJQ/Djk6HwopUZm8im1vsYYXVfpHPejIvf0N0hLICpsoj9ccyO3hITk/Uq8QPevJ3ezyK8sl7RTmZCIpkCBcUYUcA8iSebAw5G0/5TPKFMHcyvZ9wi3ZshVBzOyT1bXaRo8dnjiIJPAeO0cJ8FVP3sDe4KNCbY++a47zJI4SXjE6IsEQdnwyTjJI9eVgNy676lvjKJP9IDClrw2WFWNJqzVMD5+usTliQSpoPnhthiYPeiquls1Icz6awoFoW+dSUV/ssH03HqM0P+bSM/tB0h5apMw1TZ7qmzrTd09WimDw124HIYbrLcu3DO4qIN0G9sJQnb5fCdqa/ZVWWd9LElbhtmz+kq6YfkH3U2/IEGyg+EqAaBzBM2XDV6apkSzWTbc39ol4wq1fsNFq2Cc95xKy11zdhRcseAqCyyC+ntJxgfE9j+0gyegwh6ynDfFpIrppHsvxFcvLtX66cfPsry8mpUU7yW/jMvXTCwMjZxeyVY03lirLh0Fk3S05k7GqP/UDqatigeOBbaZfv9I2lszbzbY15ZSOsKoe7Yzjccg5XjcO9UxPBGN1QQUN18w2OBs5fVVCinLlNM+Ypc5Eo07Z97iQ8Qk2ZjezWqo0UuV2Uh6SwlqQhuOOC+hb5JOgyrs17McJ3Y4BPopskerOg0S9heZguuazUWxxJRC56ZE3aEzrYYNYTo+j6CUl63jwlBTqnYmBU88HeYWiZblO1WVnD/KceCogmGqg4Td2epPiqhgQhRM7dSjGqR1e4B8hRPY81U8l04enIoBrign7hnlf0lDhaf9KYY0W6IBMUbfzgTWl1prpqtLzqxROoZThssgYBizpmzYRmHfJmLQ/R4SVXp3r8TtscyVIpA9uEJpjSVDSZHkIL5gJt0ZdQG1oI7hVOeptFw1lYteB9VmdVik/yybk0zThrVemZMKRK0ZYpGQdRDncTd5WfMXonenNDzk1ZriByUEeuKb+R6TlE8dkRWw7JMaoyJ6P6vuedhW+VcpVH2dJgBg2HrgpF9HxyT+qVON+Ufk7iuV21LQ7xMIdFOalIcr7dhBx6StXQ54EeDBI6zLttSQo+mTWTJklO2nSV4lDJWyV5SeBGTmA+rKsT3YJM3OAV5TE8E2o9+VOxpPxbZb/6V1W5+lflTFCqZSu3TlHqvjBU+egfdHr8ihT2UQEN/8T8M+Hym+XK6z8T+7Qf01ngxzz66B+iSvC0c/BcJcxZh98VK4vs4md4MWUQqVJisthZAqSKlgGE5yNcSxPyTYeR0xxsOQ9N1LR5s52Z56o+KpN/Edoqc9XptGhzQw6BVGjbxrCKMSwxhjUsxMDYxtEtJndHGZWQUTFWie7TjHLb59+K9nPW/Aey5n+dsIZX/yG7+luxM6rIxJExTjmOmLxq8w+MdWdzLRNCrEuc1aVhS0GTkb5+OWPX24lwqA27+F9VuYBf/Ieq8q7iyMr7OneTabMmfTKywVl1bIxskJGJMjK2USBjX/uEkcjOMuZmUrPqWzgac5vSAJXmeuxpVw0tX6aFhg0YrjC4GI2Hdvc2BpIHdm06JmJR52FpZANEXx9wUe3eEH5vjvdMMh9m9/ZdVi8IuNjq2EVtKxO1woA6YhG1CloFWdsVfqbyKQD20c4CZlSgzFMWcA67rFmFBR6mwoqFLrF5DUQk7HyoUeyvYFnUDswPsXCIBXKPZJllRKC9mWg+hM44PSTD4KrBz07+lZ9QciSwEQFtrdahaxo1/2pl01Zm2GiAmkqgXA+MczVv1e0buarH/vAkIGtyFWr+OUYLSfLOVzlRLpmhS5GeUG6ke3WZQxcNyaWhQ05oIHaKqzkwH0Nr5EwVK1gg9WbRxnLWwMTpxz8+KlZHaBA/SVCzSps12oUAYj8pKE55dfNx0pVcb1IWp1dQf2aZYBbzfDIPu2lRVuMqG9m7sbh+EXuly5+10lldx1RUw7bm0Ffpn8YzhlurvA4BaolZYj9cQpuEb4M9w8dNdoXSr3SFs7rC2/Fn6wpTv2S7Alv/i6IrsKJfbFeIrStE1hUI9aZCfbQrNI2u3lUyCCvRGYraHVoDk0Mk1poGulJyW/WoLsvsIZJBN8N+zbCffIHYp0c9Id+bp7GPBmlkZBs3/V/VWPNRuBdB6m/Go5DObQHF1JnXrRcS9NjKWuihNgLpxCCdkMI15m21NArWsiY4BSMf0rNKPkkeDwHwhe9eLddGirBUVoe2B8efhiUFARETEzHJjLF3FKgGU/WeG5sJVKvYmbU6Cbs2H40HgJAyTcOcTZ1ZpT01z6YrJFO8Sz1oD7deT82/aNoQsad7AER5vMi/KqWxrxzZVVXJYx24TERRbJCV4hDlX4JgLpy2aqTB6WVKaWMwC/kdzNAX0UWsbsQqYnUBd2yq63HraU+br++K4emcTy/pw7EdR1yrpYmDvuCO+4I1KRK+m/sSz7Jc/NApywV9sz3vzbmTVw4d1BRx2rY0KnoejXruenQDzY/EqR5/gvNj3Z4nmvo7umvEzbvPlIRnAec93S3buyVWnwE3+krN0YtbvkTI1o9d/bPp1iNbj5quY93XkfKUsc5p+ulS2Df2vWgVCgMyQHrWT8RDmuTxtZqRrEbMSiLcsH+y7ivtvy5dbfJQzQptW33tky5aitAnUtqKhmXyVe6sG3eOS9zeeg1l9DXvqb/LpoZNQ1CYs7fSZatY2jnRu5sEU1oVURnvDiIz683mgEljhUxirrnZuzNyTNAfZrto1FBR51vvfW4OMkcNZzViFgLD2c3cQ5Nlwxwx5qoy57pEWXDmjVn+DmaG0nPVECEIev5Jv4M5CgRu6r4iiKCxc316P+jyYgQdHRc+w09MqtFwoqBOcE1niDuP/3JJD3+x9PhPl8TONjPhYR9yGuenpfxUuTBubmeTTFTogmHwnSTFhvz5DrmUixIvSt/x+GKJVzGvYrmKeTXBqwm5mij4Suh5octk8m1pcPHnfhSPf/A4irPdKfmmU11zz5G7D0IXffq1EqOQ+eVqzM/kv5ySUDV0KE/QcONk9SQOqQLQD6OWaeJPpIib2ixM5i3rzCS6S2wLi2tmDppe7gil+Ya2Kbmgp4sXg0oe5OTMY316oQN5WrSzyF1zrqlU8nGtYE2e5njlktCcPYlb8DrjbMJhlR1qSUctVyLrI8WtmiEbNTdvM2laGdWoRuvATCsuzzxyQuuUzZGnVcnkoQppPknU1JGU7tT3+YDgRKiYBZKtMZ3bmFjRUUAJQejbQM4qunVoKbeant30KGt0RGcw4rxZZ0eAqCT2Ma5iLu2KrxHhM0ZaekTRoostLrFcMCTOae8PK9Z7bYbPiuKySiY3Ayy4qnPF1DSbfJAq9tRiC1tswDwi0Z2HxBXNSq26CrQvoSxTecklPqFqYlQehOYY2dbVWvawMixItrT9OQi2NgVbNxdszaeItO4vIpEmJX2ppVobXUq10+Kse7Y4axbFGf+OSrS5z12idYn17ohE6zJlG8uWuwKhoZMBl22NM2RbI/QgT78I2YYGuvto3X4jNAtirnd2X+98GcQcxbg6IlqoFB0Rnc9Z+jVM+nVV+rFNJ9KvqmSqabOqtlohl361U9KvhraRoveEIBTRFBJ0ToRh7bMLw1FRGFaNsJxVF9oo10Uh6SB2ItkediYrq7llNDS0rrx2kWbS1MaqCFckoyXJZdHiK9TBRSUWNdft1lGxqPfaf925ZCse1gBsYv34UabAwrezODpOAWjKV2e4E+uo39Dg7YAuinWb5Jt0tikeFnhrQQV85hlclo6k06CrMptBeF1N5T9CrVfaEmxC/iKuHoY7KkUZXErNPBzEu3xFssUdtUdephj9NyVu2+Gq6tLtE9JQYY4kF77yPekiFdWrkm3tgVToEIsP0hWKzz2J5cEVXCUspNPLA56FoczMCiE4W4/SNdsIhLm9PpNuakzlVTq/Wlj0vT7DAlLs/9mHIZUcA03RbIXkpxajPtYopTlXwwRnEmEZV9RYcIC2KL4GzJS7kqRAimXIVY+MwsN85YiSgNTWhSCr6AYZx1wGrBZjz/KAqwW5WsSCyr9FXf9CfawQhra1MX5fBNRs2nYFbVw2WRjM552YVUXBlkh+WwGoIkoTa4Qt60zVt+Jra47SLWlHWPcWlPcMuLzI1/psMGL1jBAiisOWN3QD29jBNWnwz/lEMdc9Po9ItBYhiJZGDlWKkUPqF97EGqI/y9UmhR5w1VHva2zRgNxT0rABrL5W/rrsJiQ/yFqa+zfyurGYpg1cFn6UdehZ3KH4mqVnAitGEOPvXogxH6Kn8XdXkqxgb0x84daTQWJ3vKOiT9vDHA9z6PLQzabHS1orweYBLocOq3eHvYoRm6GBA3QwEJCYovUeYeJd3MEtGj/Ce3EQFnEnvCSlvzQo8Xd3JvRtd0Mp5wB3CZD5YdDw35+J019Ncfs+677H0n3lcjAxlD10aafQ5Q/8hIGGmPc4DxwNtMH70Bskbt+Qt9sqEnm2ozZSnr2XNE982XUbFetrPp5pdsWBNHJTWOIDqnFvzLAKkgkJuHbBYwOcoWhZrqzi+YjxErBghu5eiLJoTrZPktKTLqSfw3vJCCHHJDdIscYspi0OOvdv/p5nir+wMTZIZYdDkby1bJQak2YnXMNOWD0JoOjZ6FGjgY4dWZXhEQql2xpFEq5LejfuUuPVFTGLaGjDDw1vbipPN7CRD/1o6Ayg4OxFhSSr1HEN20wkdcJ1nuxoZmobSiDFuPOQLzZ1nsBXrjHrJ0iicS9KTHRnwvsxh7tqZ/0A3gNB2wcxi1XVd/8L64XWn5V+yhj3x//dZMb7Bt8xDLfkIAzeF5Is433hig/8H7SQ/asq1TZ1FLj/jG9OTrPO33orfMgOH7bDljMiSm+TopdxWyCdRgLqMIv30bv+EcmKKe6lK7ov05oyHlfNP8EQ8shk/AorpMTmfeyHBGsB5BVziPhytn7+1bQyE8BAZchJ38Hq2gVX1HMt/ewpp/uSrMwMQI3awkfzfhWzX122JQcDalnhgCOz9PofpNCSE+nU8wbRXjrn/W3DQuSaiCgJFnhLFBW5pZKFbWtpB1WQsTtnXTkkNAieRLZVyfo3pJwqbVwZEs8V7NaJOfVj76iVp9usc5mrKkPiKDZvJbpYYP16ZoOfM+G4CRyHjwkJAvZm5M0Vb0cy2M29+VIqM8yt6DEvtU60wOoZsSa3Sye34+w2nySWhVX+vxZrrtbh0CUBoZvhuc4tN2M+0DGqS/77I7mYf2ATEe7F2B2NDFYl2VSZjz0aeSVlNum9I6zYhOjXKNA//kiTH4UPQ2AjM1rH+JYD30Lburi8p4d5O1TkwE7DOxqBfpDGfCDn2hDi2gwD36c6r62hCWBTymGTHUcDVSzaBfEMXxh8n5xka23usRq7spL4iZetXAvsgG1ix8Wkm3Z6FNYt0xBlsTAszRN6Kr6gCZkgj7mhyr6OmL2NVbC7SZZNXZ+kW1nVkPDy5Szrh0dZ5pq1CpDBMficZ3y+9VBOdwePQmpJ5TH8+PJDzfZ//e3jo0K6NV0MiyM+3sTm0cMj36Vuy47h5WyzjwmqWAIX6vpbFBOWgFpNuplthloCkAKa6GUmOtaWPDpiMmw+SjdlR9N3/k3Y4bUZu74BO7w68zCFrtKFHpgAhjU7CCDBkdyAPa4qYbM+gq5Nb9Ar+YatH7Nb+LDlbQcp69VH6Wv4EO49TD9xrFr61OA+06/hY/i4l/GzurPjsd6/hT43TbxPBq/gvoCUwl/03lDBINTQD1UlWU0kdyV8EtV0lyTS2VrPxGpTWU4M8rCGT1KoVRBrRoh4EAlKV0UNuzaqrhGLTXbYHnF031yjZkH/lJx86q46WGq4Aq1Zn1d7vqPsHvvPrO6OFva4XU5SLJ4OI0lrkbqxTyVT6ssVeW64ZflWqLIWrz2C9PhP4J7S1w6c+aWbFNJfn36dDFovHA6hwuA4/Tg+Ct6azm49JOv/xtGtf/7P/pnstLluufDAXHhNFvFA9qcflZM7N4mq37VLdqfG5jVqvqaDxCbbPbx+V01f2HuJKu0VxCwRKzzagLcG+Qms1urZJHr21FrwNaT3CXw52dTNeI+RHqUvv0r2s0BNIEcSVpeZvegjFOefXotgtQhei48gEDWRV0WPD6FZjoyctxF0FjSoQH5iN/z6QX2YfsNB+EZ8vYygYUEyHz9oXrVBc8EizM8cLee/aqPlPIk0PzJa3sY34Bs5TAbCMGAFXz8yWv6p+Es1Wi6PHyxdapB2tnjGrq1o1etphSAiNMmLOhLh8vvI2FjVOqxDfgKp9frJEpEgmcERVcScw0sOZH9JL3kMJFXArJIlq4JOY4Dun5UZvBT+qvxnR5r4rqxv6WWcXeIV6zqWqpzdllH7Z49TUDJT3cUn9PFk3kGhPfGY7kX9o8lenfFBXHrosQtjm4unInVFPKZIj8X887I+oZBVAs16sHRxAaufZT3VnwthgddwD1dwumM8NHOJ0Mj9nsdTv+Mn+cmGtaMAjqV/VgazH9fRIhuHYAeOLtg8xpqO2M4K12XzDztKA7/9a369DoJ6Ii1NgZflP4RFL9chAkv6/CMl08WMTCQgBxtfnitN/QgGg/iJXn2Pr0siDI5vfeM3/oEbHCzXtaffV9Hu72NAaHlbUg5rUIQAnyQSPklM+DJmZh0SJVOo2ADh0jlhiYI8bdXLMpZTkcGnsEeMDqz59635e/SDcKI2Sm2wcqUxFRmhXyGWHb7hsY2yAPhHCE/6/Sw7wQewTPilET60EU8iwoc34hr1oI24nFkWrjD3K7jFwy3s87Avr6nn+P0qMBZZ8CJeIhVewl3Kjbtugjjtdbdb72YvfXf2aa4LepPqVpJ9GOIfxRMV3UWWQLUNXcs6flQEozxYeBctVP7dF7MH1HjeRlnDoThfTdQgzhzKh7eLEft8zZLXUNUXJPnU36MNNT0H+s0JBMatMN9zhY+xviIs4Ffc+XHSz0jgyHnyhFUMZX5CTDaS4zIAlL/N9q0hHs/5i7F2wHCOQ/vpLCPPgU/4tjVZswgVw+E5yuxzG2pSrWRxtFnbjIQWlYbyie/t9fqKrWF9YUysys3HH6KjXZSLRVtx+3r9/0+Uq7pLb/kHje7ldMLIVs6sCdl/xOZhrNrEQuvIdlR0lcCEyFyUUKWmU1EwFxJNZNOW7KsVhShiTPD9Z0omec7x0k7PS8CiGw54xrwFbUpdeVY6uQMpcEZuy7s1Hs5b8JHOShLFD87j3EOUjX7JUOY85y3Jg7RuJjlmxY57llNuEhXUaVWWZMITMeDJlvvy91nUxCn3nH/6KQJ3WX4Ok/Rm/dwY0+XkeNPlZMGfJTzdzyvOOpKgKA9JCFa0QoiQMwQHzqslM9/fKPdQvWUZMifpQMynTDYpUuof9q+q6H7IhLB+B0mWU7AYxHLybYH+jyw8Jf+0C+/xRQsiGvKpR63U/3CpXLI+/MPW3SSvPHka8YWUFbBOwbg2FqZaGMHCO4VwogpN0WM+d1hiTJcJWfZ2vSHZvC+7V61nRCjTiHd0pCUVtchyfVfaz1pFJxHjUXFn3ZJuUPucnvoWm37lU/H6P51+fvqt0pvPsu/84Dlpdcyf7n5dlTP2J7nWbKN0gn8ocXgJXlS+LVUZpB4LueDclg8vskoqDKZ5dk6rxbPzPJvkq3UhOS+meDHJD0BN0g0iez/rpyjK6XP8hsAUwfq8frt38PabeI5rxS/4aux0+gGmqYRx73PZmH3mj/PFXvoOMnP6j7+Zfu0fTF94wE+s3sSP/EFZ8xzehYniltpS+v8opTO44IvP04t4x2H6bl3bTfkeq1M1ncUzdisAl/h5kkN+nDlgBnJI8W7RlTBjSS9DXpxzbDcK/pnJP/sonff54aQ6aBak2y3Kecxlz+/gYQkXTdeepNdmWW7KYYVJDsJVvnU3tKQq7sppk3gv2NKqNxlOFjPUK6yqBObtLsnQ+7NhDfNS1DouSg/vS6ZTB2ED3bCpW8i4FjSPqseGHXtE2Ba2XDPiKdZE7dn+dCndcR8xO0q45pjbxA57Xl2XJ6OOHTO9XxfJewMzwaaI7+BwtGrFXccNUvQCITha0uprPHawJaX5rgjpQFxWNwf2mZQNlerTpD5r8k4B0V1EeEGOBwYDvOsNjnwYCDd9464l2r4jpHzngpxcuDvDof7WAc/5k0IuyCvvwIDgqsmQevC6ChNJcgEVvbgpZHxxjOvnNlbCBRWbt9GXOIF0z4MRzNWa7uNF3wFunxMDlabp/uNZ25sVe1kUg9wqndyKs1vxya2J7NbERu6c9UCD2+Ml8m1coES+QAG6EvhRmBX1wpzDEgaHmDZci7zN216WnsxbsdyYfhAugMGT04eZqI6MZTd1WiLq3MiSxLLWCb+KdbpAALJo8QDxwS5uED03UNfxckeMKriKLq7tyfyQ2/QR4mn8RriOa3I7VjOhQMpwJffqhqtbyv9LY3B1C9NfEK5uGK4Mr3g3pocs6PNDVyC2ruMSD0R4ZBC7cMBz+bG862MhxiS/VCB2YxRiNz4LxG5kELvxJYHYQBxB/nVch9m10KUGQkQRXwRVS9IQfY4e+moFCHdAhfo5w9i0evRL4ZYcuZ3ENWJDajeDG7jonvBQcfl3nZlUrNZ3cInWg0FW9bDNL8bcPnEmT5rfZFsYvaffFmi7W29vvO+0HaiNtUlSOapv/PIp3/j2Wb7xOnUQFnvBfeG0GV6Q97fDFqmcXsh94Tel3gPoOW5y/r2NLeka3r7JZytxqVTiEjQgxqSSiO5f3Hy6O1kInzU7dxnvK8pvj0H5HsQgg2UnyL5gfRHr2HuKD31vPCb3CgRcpr6KZSXg7ikfOiG2gPknfeiTp7Qsmc5Sdl3QW6jbzdlQoYpMdedZ9YlPWQONr89LJo0QPY2vXxNizWQKz6t7/zLiM5mqLpLnJHstl2h+TkQiMX3r58n7Cug4juTv7R5aaWa1I1lKlMiOayacHF84eedvwjF8f2ZmP618zwqDYtlh8jtmcvxnOGZmZmZmZg7Vr2p6p1e7juEdn2F7pqG6urqoq2emmR1DWTFKY6wrW9TF+GTi1rlAiez4TbtPWvO93kFX8kTqQp+H2Lxj7j1BM8BXToXrkddu3ZaoN/41Y+zy8BnxRg+olPPgceziG29zuS/zct/Uz32Wl4vzLjX337zcN7vD4yGb9UHPOLPvyRKfa+W7ZC3eP5yehaA+/tQ2x59ad/ypkbNdG+AvucF1ecYQHlXenGh5Gg/WecYGPwLcMOC3ArAWaCmucT57/lRB7F6avndvTe9rzGDTljaVw9/4ArVb/dqPMlrdcCUkiJxrXyDXZp9aWvynXvFfDhdv9Ip/d7j4/3nFZ/vFhINqHVIPrnHSZbo9V95nUMnonyJqybjjgg2OCz6+WehoVsvNps3fjhY4p7SG/9jQhMNsiNYPtzU38FXDDQ+34IZ3CDcoae/wmWq7XTFQLBv8Cl8zwxU+5lf41IgK7/IrvG+gQtVSAUYZjnB+nZmXhReqB5AkCuU1CY+8troY1NsMmgnr/p9ZwdDa6y6/138bgdZtfoWH+xUU7nYP7jsbKbzYa3X5UKMPedL1rqbRRtdomJlkue0Vnz0E84QG5I93OIE9ZijTF9g/XCkLmceu+TA3t7zicAU3z+5dlN994FrgPXtr+hfa1BMhYYGabyzaBAAGg0YBuCXwuQXh3YCTf4S1CwZF7ecK+7Qh2LrhHrAGQCPe7LT5+0ZqgPXGeEJtdVZRS45HbnPjtqppzWwLK9hGd9s+K+ynDv0rxplaOGuzpbqjjREI/solAYaBXgNWNhwb8g9ot8pwUkpGXmiTqhCjkC/TmwMTDo8L1ruhU6Cohr3qhC0lHpVwRW3SvHBDnRfx7UK1cb40TIITtvIdX6reaHH3qfQeaO+ZBSO//inPPpo/TEQWccWLSy5DOa9dXscFnPeZd3yIF8fwF0HfD0mYOUTEN9jXDkPtEMjyYGREOh4h18YtDEBcaaVT5NFJumGEw2Nt++S6VWGIK4n+A/NlnBjAliSUBGX5h4HpoRpejSQqhTL0BcJ73NBN84+gbiv9J7Exo78Co9OhAWUABStk82TyW2TXCAo59bvI5MbiphT8lIupVYfsNE5u6hnulSAeyzfI5DgT5NDyrJF8BtBtVT/awUcr5nfvELRf1o7MtoP4qLpg2V6FfiRqntrZ+rrN19L/seAh4WJQ7j6qWY/BHdkFOYFZTpnnsgeoFMj2pZXT9bk4wGcnUXoCxvaf+hRklcxXP5KA1En2DP0IA1h9If/oTYyceJBv4ywETvHzAFeALeNETYPrqS5pq5AtqMj9I999Tuu0mTkDrRxhSUkWsvYFdRslyqiUewA2NhiGO70y7VFKqcYHW/r4Zhkw6mUGr7bDccLwP8uJXtGl0MUJc4oxA5Ma8LU0LocYcrspXfoETIn5ggNGnBbT4rkXM6h8Shnj+iDOAnPZxeJgyiRiFywWs6o1DqFx6uBpVD2qjm1nhyNzcwz0U60LChzym2yQ/ZhFbHJEQGQNodGYRCXYT7qAb9dQTFMLmseBBIrrDqs1l154Ib6ocxhNFlN0SP0k5ZiQRNTRYbLXEdCawtI0NqMwYe6IIT1oL3BL/xhemXyieprvxmi6XtpbHM+6RgaO2hF1mIW4gapxPAkloEIBRR0FtaygYF2zBp3VesVDSupdmYC6TOINOCyb0wt07ihH2GWSMw8lrhPzRSwRlgtwhf+spVZJEOXgTmvE4nKtLLlm3YBpjtYikEIu6BEQX9rm0rjLPb9Z5L8ksXb0SnStR8JZWVrOCgkzJWFEqRAuoKmamFbRcySkVGcjHCQhTSH+MeWWaWvoIGxL1i+Rj4vdxKQzRLXVCAirXQtUt0K4RB19xe6P/QkvGbI/Zci5nv0JL96LxUEHxpmc4BLP5EDI4Nd+CwqlMTqfGjI66GW/zEzvZ29gPj3SwECshw3MZ9TA3GZM4GhNvg+jVEZnupmKLBz0bdEZ6xfxY9hHlUkJKER3IA2Gkn9W3SU2E3iK22RGO88/188vjPOiuIScF/Tttplw2DzAnWUqBg6Vq2lRujl+sgX8CgOF+BFFNo0tG6PHi0aQxfx7Mk+ivf9WGexPSe6W9O5ivdusxiUvI9HyuD6hjE+Cqhe4wsQn2a1c+3ui+fHMfH0aGSXcqwhmpJpfQd5ktIftnFa3GWkU8laR7uvI7X2kH9aW87UJOlSQh4VaURu4PFmYwB9rQpFsxs4BBFB/PPraxX3x8B1IXXgJvPw5N2gOTirFLCzh5ybjVX3dYAE4WV+nn2vqvKuu0+R8zKi3hLq6y2j5Cj+XL8hgFVoRYtc9bNp9SRE7YcVoF6rAoaQ0vAO01INmR/tC12EJfQdjMaZYQJfryhC7e2zE5otULXuBtdh9oKCM7pcb6MoOJ6fMFxN99rrPgpt3WNeiq5v2UNRq74+hUDyqQFvECxDHwLUBV4uC+ktwzX1w9bdFzlkZnJuAOidZ4iSCPAUUVIB1hFxhibAaVyJc03J1n76YJZRDzFJKpAJF0oI6AiL/vjBfwMjjwNMEQhdA6H7Qzy8SCF2CMIqgd52p8cP0CILjitmEYtFWBKM9YpKIL6CqfIJ/8h+KBhqBxI+GkODeKcRJyaEL2Zn+625jyjH4fbhZEG5byH+yQ5fpFiE0UbW85H2ShvPyHwN+EWroRFZQmGKNSkTqtUYaTwFCD2hW4A/7WSpA6Rcql2u2kClJFfo68PN70YEH5PJ/8Tbf5Vel37j8uFnh8p8+yuWvti72DsDbv9CYbWTZlS8CMpDXDOYTXr0QgmUMpZnmW+4ReVYrWqmhzWa1/rTWn5UM1J8WemsNKzXSdxjTHo6nucebLIyCVUNbRZeUoR7/yFVehecb8i+p7dPlcCzL9CKhpMYOa+YAbgX0O/9XL2AdnOHaCQgpyb8sFI90DRCrxROBJF36M7t9RWcaneD2qyIb6FRWOX4kKH2BNck+jsf649mudlfH4aNvLmnMg64UGLU7HP4amfimyEyEhQWmLlaulSHFFMg1Z4YynkhRcHiwjxX3ikA/KCucTrE6MLYWFrTIlBKACEWjbUFwBz0Ei3InqCdJKAnK8m955EqUXJ778m2dwvcbEy1D/jQsF+RPu7kf5whrf9HKx3+KgAVGciwzMxzgQE9CDXGb6xXWYEpbIZUepV0m8HcNcZLo00ho41YnakAMhUhC72mjCIdoW3HGigT9p2I8koGViHth27q4UgBPLS0x9bVbCobdcY2MVsRaVd6QEB6Q2vjakNqIfLURrVAb6CVYFjdPNYTTkmLAJdrEZM2/Dqi11kRT35O1OkbOlcnXSGZbkxAJcHlAXzmF+TcAbG8aydFLBdynV+TotclF+CXCZ4qQZ0MYV0VXBLfgW07KUOdDapg69mdQYOqJGggatl3QMNtb0BBDPbCJ+s7QRFl/ouzQRPkk/C4a769S91gwHCSpdST1N03ae9000dG/wUaG40L476/xYhVsFasiEa+qaKv3d4S2JYwVBlgYaHoUCcsxJiKCSJwiuAMHJuck0f1O8j1qBrVaI0GNRxpxHEaCPSeo33iMuo1HsNdYWXEAA31yU14hCIXrNbKWUoyw7sckyjpOWf5xXOkEHIEf7gteY4BtE46/dcThq0JluWVoDn0bFjD1GwAauEIQQz0fiv2Ng4difq1KlFjNWbWhOQWqzUMk6p/BI9HoUaQiF6rIJSpygVOuZKGsoQYXFkqNNRhd0qTfNybbk32aHbRPq7c4+/SWf3vkm0Ucf9LYW47uIMmLBElWtFVPjKnKHldbnFLqjJkCDBAHhqXIxJ69GYCZfJwcIeYszX/qmWPEpeR7frH6xGKWV/fN8h2DZvnOezHL61u1SlbBqkPqDy3ByriuuvNVeCluM9lOFwXNioIpiH+2WcaknzNmbE8UzPdKwWt2KgWFZrHSLFGatUeQagwPsI4klVr+a3eq5Y/ENqv/nuAn7jvxHsGu2zlAsOt37plgVxsj8V6OUTIldPSlenV915D5GpszT0ODkkuykaJs9W0VQprXKdXpA8ioeJQKmDjJyfxsbOJdQ6p2tR89Xz0UPe/dm00MyPaqf9wizYL87p+lZdy+c98tozKSp8YxqlqN32YCqONgyDyGoowhPNO8PNPdpoAiF5Ptf6Y8phA12sdaqZJQiEKwEkrb2lC9Swii6rzVfTObku4w7sB40n80gW9UDnyrrwybzT4KYZxt3wqd6TsDACw87GAj0jQMGyTzPICfCa/dsPPnx2s37vwZ8tpNv2G8dvOvFa8VIKzuiw7S9QRH1/u0qteDD/FI+nZw5eOQfWj1hhGZ6dE8bGZFo/4tovgG5iYouEN+OB9jCNgnSR8imNcPpaAyF5LhH15gdqx7EMsgMd7zWHCTGEL61iIeX7ZL4bJZ6iwHS7XtexYvHSMX15XF99XyMd1XV7NbeJJnF3qvrrqXUjL/akw58f/1c2W72szWVMN7ITsm/NTInTygclwQLVPxOM+Xd5bSXpHVKBMXo8QsFh35hhUF/NOrXoS2WMzZattiMSFoRNW7WjLxZzvBLbrNZY79IezxTFbLGztyuBtm8IVFnpKl/NQAE8RlQCGRgi4XQEy7XEaJBBjctsyEnB1RxphbPIZpBHSRpYoElwbgQaF8VrX+f6flIQL1kQkFnoVReBikNFZtxgbMOHYZQTYedYDBr+KMgIfaKyYpYODazzzYF4PPvEFjpNJxqltg+rRkggcKScOfOcXHBy0ZHKe7d1GsV2TltshVLqz7sOwkj36bex9pFY8Wk9qDfIhVx1jRWoeeUToPJaaZgAaiPDzgEuTJOGkC1Jzguh185ycD+2Uy3+mZ2/XPj9ZVszTW4xcuzjzhhqtf2R+dK2/TdPXEy1HD0jTZ8+dKcO/TbzrTLJ1pbmKkTjz36WcuX3/tK5mkn7/s/DlOnnD5+rkazreWaQqAm96WUPFx7fWoOHv+XDGDiEuAH0NTvGs6VxykM3FwdX/utZitHoDkEG9e5Gg23XudL+b0dL9nKZ+2lTj4+sNqikDcNUoUXB5G4+B3npiGTqUF9Yq82dRMamaCgqJMphV3kItMZIAOo/5JJ5HMc0w55fWItz5k9x32hWXX3Va7b78DJkKiQ44VqLurHGqSDzWxqJoP8EkbfDJBCaQi8aVC+STST+ndCz6v3r1LgSsNwFQglyIFHsppKn+Y2NoGyKvW7X5yfUmv2i2432HLtS+8HYTTv5jO9SXpFl0GJGRxK5YBCR1ySck/F/P6VW3T7CVFQRaHXK2VaBNNDTTlZtXBXEWlquij8ql1/4xjNNaClddWlkuyjnHcto5yRgm52KssKnN+x9RVRTb5/4SbXlgwmddS53VVPaEWlQI1aXpgcv0yJng0KRJFNkYGxEMyKiMJWSykejw+wNIXvcuOBweQfEAAY2owPJP91kZQjWuNwrexqsjC0iqawNxPyNyX8hxxhKyL1bIXdiTGZP2OYu7IKpraCTrgNqNnjw5a5KogJ0ysT2rwAc3cTvGcEh0w8r4G+ftOS0zBOKwAJ3Lyy6KOjDKdCKz/OcC4QRyHJcjYGu2+sFqtPxVCTE3bdZpJGl/If7iqigiTYgkarwP8O6BRIjQ6lCYUrAMXa5ulFWdwxQMk0PoZFxcZTanJQOumKepnITecK6xiyx0ZYDBcLyVsFGXzYrM6XLNW5LC8q5BJbVHRJXoXmynG0rcxg9bNuxPm7fxsLM/Be7E8q/ZqdjrcG/QlTchT7xNFxtgKd9C0KhdP2/2zklxGbjHyQd0l+sJNCQb2wiFVZnl2xoop7qOpJyUaxJ4Sf0cu7k42NSy8zES06bCBEtoyAaaYADWAHZczi3L69sv4/WJ/EqxnSMmKDdX2jf201TWXM6wSsfx4z/aTCSmKSXGVS7MI0mQio4NE1nEqk+wGxYVHY59yNTxAiMGRiThLCkYMJCbfcobwOZjG+s3LLsUOurpnuZgwL08ZCKBi6vodKzOpQHlos+nOIFBO8MmWq3olXM8WyDLKfbOy2ylqA63Aib8zShKgsys5HIw9hM6gXECEwe8/euSOm1rCxpMEn1IFw1bbH+XyVUg09yYvN+/nPtzLnZ1vZIlAig6Uj1PNiQrRhAgRBGg0Hh6M9tBxgN/Ci8uNVE2C1JN4aUoMAbutqNe3LOFEaFota9I9esNawNSsgvMGyhyPQQaF2NK5mzY7UFM9nprdRJ8o+pcPoo+2FwzyngKdhxp1tBAagrC5u2jLhQf3bwdO70OwM38ity3mQJLo+OBbRo2+KawKDcuPDBJGV+RCEcncm7eTikdFtRNXo7LZYbDVXVy+EhW0EFUZqqpU+833hgvchGGudYA+ddr+A2CDo2hn9rdoygbM1uHNjHnYi2gW3b4S5NIuw1Vf3FUE1iC1LIi5fjkjTjWYgrURzTBT7OIbIZAGKyyGb71BbdVBWcG8PEJGUgqsI9nrLhncjCq6HMrvSOoKREoY/BE0IzdOC84U0I7boKsspNJzMNGrP7ikJrssO5ruZ6RLT9nOuP50noQEykCV3aBdKOzR0364fLpe54RTheG3T1V4ZOlTSJBKiGfo8FODnAxKf2TAnUYnsC58olfK121MyLNCt9mytkoW03dZG2yz9SdUCH4gtV5e2jPvdn9a1/aN5t2tP8fk4F7/LF9bBFXKOeaGMrziP3sUnnniTfyIL4W/O6cPTqmFxMVdXYp6Gz2DTq3/6MLqRSRmAwqSLJmn30DBda/UkjqzMtz06Tc4nJJrKYbxvk4rksEN2SW+rnjYvSJGv9xkfcdI1xv5moWVAq7hkOeImsCfI9vAvQ7iBILN90pDDOb8OUyCaTyAKxncusWn38PdVYA3cith72rXcbLBMjyQt8zMzTngKzMzM3xfc+WvuSZlxhwlpfUelpmbOHdXZmZmZm5yfv8v2fLaz2WuN6AVjEYzI82MRlE21WYAhpDkDiGQAL+0QeG9OjsjgaCp02kVz/xFT3vyIZUFz0AjJJLTMXm39dvH+7vzf1/A3FRH63czF6RrG0sfd/c9By678+upME+/VduDQmpm4MeH7KSjOBhHbssW3yW/yYaBX4XX5Xbfbb5dr3u4OfQTGb86Pc9SaZS+k92dtkY+Qhcv8CQb+JEGyUQZPHgnjicNjNQeI+sEYFglMFI/CkNo3g5dc1phsKKta2u99WpqBn6sAKUfELVAA1SmmAuBhiJxal0v2jIVadlcsWWzatmFlo7HrressyIAqluKAF6uCOBlDeBoAOBQzMNB3Xb6JyqsLF2w7vVTHJ69/UnM+3mss34B61zPYNn/3VMRLLudtf86WMY9JRr3deNScEeJRmxzIxrLdnU+M9sg+XPvmJ6p59S/UyYaJpf8EeBPjRdt2RJp2VyxpebsaLSsLhN05xcIuuOVD4CF8w4WBezjSrLNXKLhAI2EF23ZEmnZXLGlHkAnWlb9djMVp09wvEoPQsYyfgx9II1fOvIT5/InzDJqFMZV02PHZ/0Yt7TibGJrVM3OmSlqLC+C0zIPzRfgCzLUCLgglKQa6VATc+E6gkMp2li7QklqZUzLDzjPcVjru4fvh2ZW45kqKOxQv8pkfrnZUo9GK0qWLNpHwgHy/npAKCyWoQjT56euwj9vHQYiJXyyfgGfLO/nzzQOsUoCF45T6aOInjcsPDlFlc+abL1LfgQxjAAZBx8klj513olrhCiuzkAyMn4leN2AZ+yJNbfhgDXOlqzWCGsoBMt+pq8rF+o77qjVQhRXlYBVOCMDaJMlzj9gDKJ8DBRdv4Zdr4g/kMo1dOAQ3wa/EP9SMMtv9NuhbXtRlTkYUZn9FVWmXtFshon/lgPm4mIOVzvelHicNp7VadHKO6rC8RctPfLkNr0kwqL+buaknNgqb0APfiq24I2A+gl9EUqhnxCpdOcTD223+jNvNIfp985f4tQ339huIFAV0qNnXb31a/++a0SYfmLX6fMG1uLZIExP+bqxqanpmFSA9Lpb8nMHsoNkTG9/08DN5qrYNY/9nZ1fDi16MuzQJwZJlxmJyOa3A0+13olZNmmBekSzqgA/FZK9ZpsfzMC7i8zKqKOHH0U9E0JeggywdrzixnXM9IHewRxTAr6AY4Q8PAfPBaH3YR9cRouz57wP8L9FT4dvOn2uA6ZvlQ2G50D+46uePPDOt9P6w/TtV1/Xf+GHyREBmgx/ag3XbqCGNTl1+Wbnd2989LkDwx8zH+fuoGzww1Lkj4eZgFQVfyQ9+tCh/VcmCBHUZz/AO6/0GoBLLdvGLNHujoWZ2ZZr4Fy4JgFpVKI5rOXSKPKQnh/r9/qFzGWNkl12ZkD7QxgS7KFPRwdAymRm96QSjRW1p8aP1YrKUbltfZwPMM/mV2/em6IKUxpRff7ktC56apZxG7cterC5fOLrrqgh4tvz8/AEUCBo/uISgGFH7JVN2kOuDUmr9b7DkzYX01hS6Ir8fJWLkSjFhtjS5mEGNFGYDObEZtGdbQG/O4YciCXd4amtrw4shFN22oO8cHpfTux3eZs8UTrHZ4sU4KyPChPWoIxWdwcdl/UpynLPtef8ilKmlmhsf97oJwK/mos3Vt5Are9SZCJgYi3BRMAVzGK7qtCnMNbIKkpiDepddOcRD1f3zUyFlD+8pzcb8dJsn8yAQfWiuG/cHmvdlQpCimDtlUec+e87Ou5Pbdvjj1lw3UdTSv6Q73w7vre395lUj5LPN/L5fg3lsoZyGYQYWhF7Ygm+hx8tPeS+1RwGQeDlonx2/wF81swhz3a5aJPZ049pnv0a9idIwDmPuu85gKoOwEByvUbxPPHTeO5pnnu/I8898twzPC+ijIV45SU+afps1rbNITEO0k9c3nfvqmNuVfwPvKzrWkeT8RQAu6UC+09p6dRMumiGpVlkAkdRjpALxsrs7uospM/u7tquzibMaIDVyBOXuAjIHHgakwBm5CxpG6GqYNAyvSnKiutjaOzUlzs7k5YStO9hdQC3yw6knWHAODRrJtgf+E7BGnFDP44W9w2TBA9loTYU5Z9IBdJN174wFty4J8VAJXWNdBXzln0xPXHBdWekTnj4yq+OPebGlOLc1JF7K2ukQAUAze1zVft7vTcD6L1PLr7o8R23pahzwFLpAlZcwdqzuW0SbJbsAyMfOXT2za7PAhYq+FVkeFzilxUGeJTQOUoqbfUjUxwPOa2iOVEendHS6SfalqJ9GOvg3zVXLyEGGSWSCWU1znFI6xyH3ujb6diq385qW/pNjNF3JSrdpCpZqJaHdMRxo7OqYCIKMpJwVArCHzB4mF5277t6tv5saSWALhV5oElrp60CigrlkOp55Ht5Om+/7KZ5OtucOHfH3zgU1AvTTdYnC14LmnPUEOCZtqtXMH4rd5MOsBEfyJcRaMnB6v1FuzX3UvZ4R8fvsbq8LjYuVZRspwUPNdAKlaMRWFVsm90AI2AyNrHBCNz9Zw9C/3LG0MeOzpTCy01tgS/6p6o7XG0eK//4vx2+A1JeCwKC3C5VdaHujCAjUTbIMtjlpKaW5kN2OEl0P70lPXHnq5Mvvea4FK2nwHkqsf9lTB56x7G5/uyDTH60mmImkioAcqgOanuP27boEqPz/rq+Xvs232r972EMTkUfaRVIKFofevqWsYqEonXC63d8IXATMZLnXjpmCElb7Sjy6MZQ1fp1cbMBriuPVVtu6pa4rjEUy9au9eoEX/U1xte9lh0H0Nx20UDuJnSeOtR1QBi9Z2nzAk97/6RQE13f6t/A1BqX3JQaIxmXX9y+6TGQ7NwhtFa2zzW+0x4btVwW9w1izrSfOZBdaYzv9iQdljr6GQPJjbfPudlKt45pP+uSxUecO6bHj49h54hI9YyVbs+5ujOiSyMLvxonkJjsnaAcL+QdB2U0tfPk04TZWMsfJ1EHNSjP9Tut8xwGRZaQzt778z9WOWWxA3TF2AF7hxKeoCTRYdzANXGDQ6QYNaALTNgArQ5h36ID6nDuQ0bpKtJCGhpTJzF6EyjYVzo6UIAiYuiwVAcJNJhRKsDguwAN4CpK4JoowWGM7lnQxftISFHHWrhSpGMA2OoQQbFb7wIhOH1FZ0nMxWpLnTz1/0Wv6EOixiV3Tjje0QppxvNPzxLbKBVxzR0zckgq6dN2A4zqOIHnZf/Elj1GlkxklGy67FJPNK570iD2aUW5Qhv8hJBLI/eiXPpoz5SZ2YIZs45dIm96MX6HuUtBDIbs/NHhG30HbV7mjMQSSGFMH7bmkSt9tNq7zbRBSgQy5HKgn/TDkwZG7bvKXvBhPtn/0Tta+2+FH5Ve8sWFrtxvqybO8p7+AXg2e9GJGqF9MuRmoMqMnSLdzEQpMkEUZVm490wvCqSMV4OMxvF89d7Wfr7AQmv/XD/fdEMhb4Mdplx+k5v3+yPenANsTTGQhWqTQj+VPLgwXfDR9N4AAEhHpSr4dahd8OSoQ4qGSbdSlOIHdgri5TsFjt4pcI2Mxos7Bb/AUSXWv7ej6oYZNUrnezx3t8xzd36t5+7Sc0eH4q9MECJo/5EUSQqzUyBKdgqE97YT54rIb4G5Vpxpbr6KTfmLc9kFqoE6PJzI34vBkhpps8TL+LWydld1Yj6BXyzuNQvfrn6dtKOv9aP8BrMy4iPFFD3hdoNzZ/hTLK6HJpiStCuU1M0vrSlJi8zbNQrQmaL0Ym8yf59Cr99k+ieajSVvDUoRxXtLMqtKX2tKX73i6251wvuBofAD9KXNB7m2yQXq0uKD3PwQrNIhgG+Va1cgRWRI86vGFeo0ReoA06QgTiWEI509xXXF88A0YDCDLFcMz0Sya6WbZNhOJrj/HOMvhj1q+eYaWfO82560bH0e+H+cWTWwNEUQHtxS8mrcPcLdXRJ0q2+3Z3fqHzm6Z2/f4WSkxORE5AGSV+GS4nkVJFjG9M7+7u+9s2n5vtbT87794ZQnP8Ez+o9+unPvTzAf/P3u9+fJH8v5vzt/p+sufPuq124766Xzb7r0w3dv++yLP19776z1cn7/NpMHgowrTwIUO8gpASH7rYG12yEvgBNu1YoJsFxjAssYSGBL2eTkiTG2Ks8QiqSA7dmHmAfMs5fCeuSeboEiF8AVMWN2KUJiQJCAviDB5GKXphlD9glTJDEvEEdXkIXYleOG2pzYLKEoxWKtnBE0q5UfGTB288E6n4mXiPblXD1tATqZuCxNxFoSOQgmWcCYtFKwIZYZw4JPIZC/BQQ3pMQBsEcXza0z2D6CWuyr53iLJWOvCaR2jyiI+i2ESw8WXiVwBbijdR7MCrsGmXHbRJoaT7GfheLaRjK72JtLrr2p3NgDuz7gZkaUAXkNLhRmuaWebn+ORzKvjtgx5pFpb7nDKBmG5LtC3g/5ag2DdtZJis1S4s5ZSwyr7VzX2hQEi9o1Nb+xpqpTsyKwo/dAJe3tpINWivMgpUCZXXs1TINrhwJT4pQZl7GtHRoL9YBSUCLV5H0pGUyohJymCC7CNTama2inpbU6CYTU0YH59wkKFto8zw451j0wrda+6SlnF+jyex978t5Hm8effOLJ55584uF7rwCLzlNnDhmkDrV6nQHGDpSS6vB5F1zWrG+4fv5TvYHH7zG1RQ0xJz6BsGFyeYBAIjoeF14iF5pSgybZhjH2tDsE2UqmcJIxVOtLnDbxYLjiCyY7n2dVSzHrdI916XDHCWCG5fnEyTwAFNPYa1Qh8Va3EcwGxjXkBKZNfgwRDFhOYT+G02CY6lwdVGIDE+lQytVHt4ipo2PpGTvnAOtSHt1u2VOBtNm3wbNiPaBQfbj/CUUL66Q+C9bdx+XJrJJ6DKsOr3yi6kxmjKIrZMc4j3sdsfA/o3YBFsUaNQAYk7C7CQsFaVCEgYPdhII0LAZxCbtrJaWXMGiUbizKWWbpRmDBBFzKhBnAwOLyr3eH535/s08x806cc5jzTdoc+WekGR0O+dV1PkUX68hRu5NH+avyffRvetBAo6B3/T+IA78N6JFO0MQnj9oc5i/1Z9tnJbUkhfi/0UdLow+IRp9YMQQPN4nJgmnQNTLlP2b7ABfj1/4z/8O2nRHmuwaJEljtKyvUD4Kned9AaPRXmT/ouu4ZwTy4Yc3KRz8xwdU94iImBLuxhZAc4r0QSVjK/mceA3GTbQvOnW0hnPVzWuIPrRC4DuLf5bwyFrcQLXbZ0d3ub3HBWRrx8+duWhc2EzzttSEOSyayBTMRZywt9rVpJmrd9+5UeDFHkDfv67+e7OmpOLGZ0Jji2vd5c6sgfg7iOx2M9iZyCUaogWf5fUnB+rGIM++Et+3gEsHMsuZ9pqsEzkRcsqOg830T8UI2N0z80mqBMxC/0T7HzLuJgOynOXOr543NdRA///TXprVNxNlXB9asNJsvyF8S8TsORXcqG4mJhu/s8SwJuj5o/mlpFnaNRH+yq0q5hARdny9I/pk/fCc1ErZmk4ZLk1cL1ucgzjrVuTKugZg+4ctV0nGqwGMRb3gUukqngbgm9yU6b30/PiZnIq5j5bww/ynhhYWlyRhPo+uDOKO1JqO/nliZ5RmZu1qWrg/i/TIuwtL1xMwRMNRTWEDXB3GOnqOURR2xxL76SVCBFN0XiMeGVwwF1hKq7jH2ehekx+a8z0h95E57FtcQgbm+Stm6iwTOQZzD1K36XE3YsurgsG4BJtgm4tmdEviKauJj0fbWI36r2GNyJuL6XyLN9lcRXc1FE182ytD9h3iD5NHYa5WE6M/X1wj2aP0Q580c751WQZjsPnCS9XqMLoluf9G7Gc/KCdvOB3F/dc+kjz+0PknHFUfKiI36M2O2RIuPzXmDSP53u3pWlxGB5sIs33ZJgXMQZ9Y4ye4rJbDzajZFUxdojcljEWeJS/4+UUJoGErv8zw/QI9viPdLfN9/s5gQKT2xQNF/JV1fxBkKLTK5RcStuFkL45nyY3MddP8Nl68+5xBfzN/fuOUgpjUml0Sc91opqJcgBlXiLAzPrKLri7iQLL8/CgmM3yjrVGW0xuS8AeT4NQ80tMKJyYXWJsZTl9H1R5y3W8M5uICoTDV/r7ZxldaYPBbxWKVn20ryCPuDCvvWXp4zNmcizujxaerPIV6dUqnacHs1XX/EJSeD8JLHhLFVuY35eAmtMbkOGv+SW883PSTezPlR+8pq3dhcEnFmHLn+6H1CNC7wrNXluXT9UZ/FURTLIoIC1rtFm8qNzXn9iC860bY5jdh7/FnPRdelY3MO4hzlbyankwjy7qDq9t/r2GPyWNT/zveKjiNS/179NXf8V2xMzkRc6Pz0CNcYolv06uXVzLXsMTkDza9FeEn+bWJj4s8QQ/81dH+h6//OTuYEEpGJ3G+Xxd/gY3JJ1Gc6yvCuEd06r6ZB5yL2mFyI9v/hNybnUIh7n5k3kwnvZaPCHCtm0vVBnBliclCSBU1DnZPNW0evr9D1q9as2nUHVKeaKRfEytDxIa7zzttyUywceD5gwZk1jj4+SGR9+eZM23hYM8w+c2r+Onr/iHNi5qaGJsOV1WYNNy/Q+eug3lZ3qiYdhNe82DFov5iuH+qTOUofM+GSZpWe9qzpAuf1If29vVHz9n2IiJ520FJ59PyIOK8x6Sv7ITzXfZ1gVUn3HwPx2Nv7zD48BvFllthkBzp+HcQ5H8W4Qrmg3BeV4i/eiwlmIq5jammlkg+vdrA1LGatoOvTi8SX4V/51xPosR+SZbLm0PEhroOPM7mBAzfdrLxx++j1IeKSYm4bKwqBt+1tlj1Hjo4Pcd7rjUHvCRgWu6v3THV0fEdd2jVgQREMCsvVn6ek6P7/hJy/VlyVTS0C1TD1rQFJdH1iEWd6TrVpLIa7j67XOEVNEDgTcda87N9HS8D75J4VyQrlmCA+xLNV3LSCSuF8zrDhBTd6fJdE/W53j3QZVFxx6HmvQufP+/ivz/Qr1DUuh/Py2Drfp6PXT4gfP+M7u78cOqQie/xnjf7/Edff6uHvXQGTtgQdn2k7ev+BuNDGT1mFldC47kOqoZYwXV/Uh1rNzKrg2EisyZpBYXr8RZzng/WFVIOD1EH9LSfp8YX3Abn+MTd+oVQDqR3puv5qUwXOQZynqe7VUAM5sw1NS/fI0fEjPrO//NexWmiSvVV2sncAF8SPOKs5W+t+HahlzxuSGZGh40fXfzcy/UA9KH7ZxJCeXYwJ6o+4UFt3xtd6mBXw5Og8qWpcMA/x7IdOS8OeguKbqdW9NUvo+r//1032MdRPNECQbt/815Hf6fEdcYaNnVxpA3z4iM33XShNHz+Iv/9zfDbC0v6Ew9Ol6P5jIP49vcbCsRGuz08Yqgsfvf5E3N7scBjRCLnsHQZ9iaPnV8Tzpjtvm9sEHwu2F7R7iQmc9w6pX+vl/sIm+DJRf/fPSBk6P8QZ3I6BuVzIw6S4Fzvp/28s4jMLz9o5cqHy3EB2ncssOj/EFVXO7S/mggV7co6h5kK6vxF/37Li0aJmiOKxetd3i9D5IV55otj/RDOceWYnWi+tQI+P6PYXRPOqmiH+hdgSb0l5uv8Rj1UXzlzeAqYVR64fL5Sn83+LHJ+VB4YutQClY0n2ZUjQ+SPOMH3DbmmB1qPxIjJTxNiC16x2OgJU578a//Nc4SyhoRmNhw9NZbP/+XjnDWCGgpc6QbILnv55LbSgId7uz1sZOqnNo19HrCwVfDDx+MvUf76hqNXf3vTnswp3Dd0I3nMj+K/nRRfixmI9zQhMTeVXitY3CixbX0TOYZzAbZjntMN7KWi09Zp50YqFe1xzeT+vi4I53+zU9jf5Yac95nGzX1LwM+DHCma9L97+rW2tYwMFNpVvbXSHGFhlxJmF2yooCOOqmHfHsTC3z+XV2oUUOF9ys0wMv43N8P7hZPKYgt/UcPDixwHY0I6TssHp/P1FKhzXKtTG7jVylXvjKJjiwvJWnfAXvoT7d5ZtBAXT2Qoy+w/exA3MZzeMC6HA6KOuH8XUx2uVnDhsHwrmf2nJX1EVhPPkUjLDXSnIMrL40MVlYgYBCZV3LlKwMyTh47wlTPySwRUs7yQFWsrtRv0SgfhHfz/1H39RQByYA37evtiZmmOfzA9TsPrTrLORL2/hzRYT3XnmFDAUNLSHesOx1Hx7JS9DCqLUPWtc3wXiy17+Xq6/jwL/ksStm475YM/8Dt3Q3E7BlYnd2ZMuMrFbrVeCdgEFocnJXcMBtzD1Q2dcLqrzfefpwYVWXhgkPtCrV6Jg8J3EHdkdTKztcufRbbIUWImcgEt5t/Drh792vFlJgVKaqHPHkCvW0S7xNUqcX3/i2OIIKS2c9fJVw7WFFDwSm3rSdYMvNmVCd6LHbAoCa+q9g+e6YAcVtFOyplKQk5a978w+N2xerpLY35Mp2Hs6vXPcZk9M6cXe38fHUbD7O9dyY1sgNjL/yAOR3yRMNA/QZMZ54gMxwdZl30iw199T27c7GK9J0diQNEBCgJzBku/CYbjti0nOmb0kNK0P1X7feAIfiulRff2OhHlL6h8uWhSG9yTPKZHrIsF5r0zSzhgPbLnq7L2J7ST4OKy5yJgdgi9lpk/c9ooEc+8FOwOTTHAZ+SEpsWckLAnfZRex7jJ+O1n/5ddGEmalFzP6Dm/B5LxtGCL1JFBHJmuK2t7CjIWW9W2qJuHChLuvOmpdsAas6PG9chIUZ8+AgJEQrJ37vF+mhITsrItP6llnMWmZ9S2vCBLO8Qw/sZeFYNPahsMe4Px84k4IqYYG4knros4+yCdhV1xIa227F77Z9um9VzkkWKvPYJe3n8dd9aIOyj4i4ZvFpd7tsz3xGcGW1fH3+es/H144SS0EeyX9eP2OLBImRfgo5N65hA1X3G6enUGCqOHSzo7DLGyt4c424TQSPpYv0veoUMVyt5v6rE4hQY1zRPatcii2Uypj3rEkEmLOhtns7vbDRVvP5nckkJC8j9IsU/HDPYw0sq/Gk5D5Qdb7/AF3XLKkVnV7HAkmJgfPt9WH4KuWG7mq3yPhyKKrzNSZxtiplL3NRndJWLPciqAehuB1mtdso2NJcM1X9cqY/RdOvJpyZjZ/mkxxzqPsDuMKi49iD2JIMLjBM9RqZeLuoQY/rvCnn2qbXT0icR4/bd37/gx/OvuKL2c36Ymfvp6wM5w/7fPWSFx5kSdeZbf54Cf+NLdZ1KomkoWBZbueA3/7yxL25bcqX8K9xn06NZcfjyPHznC4NxRTLlIc18efNnJ6ltbx6Sh2SPfp+s/8+Dc/fahQdvcGPnuxtqE0P1/VDZoDOQ4h+Jz6vWHe/HqIjyzScLdi4hkVK7Yv5tfLxfjkC/3mULwveGvEy2QShHymm9tlsLAwW5+XFakkPPrYX6SQ64+9jpXZ3JNOwsi7skhGzlHcb+vj+cpZJGy1/mzq9u0Stv7cvLDM+yS4aYknSYiG4OUjQVPMH5GwVtzJNy/FEu8pq8vekEuCaT7r8o8VTviM/ZU1WwtISP3xZfmWLcG4vm57jCubhD0Bts+dqj3wAuHq4wMcEqTrg2R/Z53AWP1xrkGlJDw5Jdah1uSMrVjRtehwJQmHlx9aPrHMCz/aY3nJtpaEFqXOLs+lvpiK3O7eiAYS5j3BuY1PgnDLVdoPJrSQ0KRERirVsjCTh4pzol+S8NDslIu7gztGDF8wcmzn5xsVcLvujSt+8TOXcOT3n5dKTfC5xX5YBtcsLOY9CT9fNu4OvMTCbXP81wqTJBRkth58WWKE/5qnl3fvMwk63xK1psezcA3THv+TP/j1D8lQ//LMHt9h9Wvw7AgJaj4mjp1kEL578l3F7EkU1LVZiz0fOY01Fe1hiU+lIP1O8M9f7CBcVPy5efFsCh5OzVLMdDmFRe73aItYREHocIyFclcAdrFhxDpNkr+8qWhjIM8d29NoLD8gTYHdYl31rLrD2ON3k0OdFSiwXxTstM7RDnNgUa2SGyhoelzrttCHif8ssTSaAhQc+zkClhmB+GVv4d1yOyjYlXJGPXMaCx/0nibipUdBkrBWokfcacwr/lfrQhMKZizXkYwOcsXvuFXN72Lw9x9c1KJvFoB5KL+e8NaBgj2O49JNNdwxxqNxn6VOUSCh/UhYqsUVt464pHL7MgVV03Zo5st442vvfp273ZMC7g0NxsSc09g38H0nz6LgxMkog94yN8xtb8Uvg3AK+oO4gbOHAvFXrPh7WfEUXDm9ovNOpj8+YBcgtzOLAhHJ1E14SQAmbWZDLimgQPlTSkmorDt2u8Bxg2wZBaRHo1LKER9MZ5uL+dkGCvq6NLsLNgTgcwsjM4ZfUxBVF7RP0/sc9oIVfb3oHQXetYxNRZMOYP9BvFWAt7Ez25TSlJmZ8c9bML7Wuwq1TZm5dThxmZmZmTFMZWZ7kzIzMzMzd+xofG1dXyZ9Pp7snNmZM1LcT/I2L3tOr5b6+qdzKMdxPCdwIqfi1JyG03I6Ts9zPM8LvMireDWv4bW8jtcLnMALgiAKKkEtaAStoBP0IifyoiCKokpUixpRK+pEvYpT8SpBJapUKrVKo9KqdCq9mlPzakEtqlVqtVqj1qp1ar2G0/AaQSNqVBq1RqPRanQavZbT8lpBK2pVWrVWo9VqdVq9jtPxOkEn6lQ6tU6j0+p0Or0eJOqhvB5S6+E2Pbia9dH3Gdgj1GjqFtbdrSHPGY3BAwYEBpn68bzGaOwdYepqtPN+TIAWfu4S2Lv3L0YIHKQw/TwIitqfBlov7I9c4ULgXD19BoLnu3QPNwWnPWC0XmtM3foFdjFZg8P7doUHhFan4Pgo1OZwfLJpdYi9+nazPoylIXTg/3ug1nKqjAh/K52eUKu4OY8RaXFZCLVKOmSYcezLdxi75GPDh6uXDqpKZsR5hp5RBpIjQlzMUL/V5OqoSrsHPTKTlV1Cp/lNbU8aVWow78rYlWT4jr3zx2W7RXYUmr6++pn35H/ZBpnyFLhGMO/QQzcvhbuvMvi4pdyy5r9dILhbRk0x8jR9Rb9t+doR/3NNTxT83wiyJfuwHVvHjiCG4DWJj2IakHTh7sU0n6eRz5vdW/k+3EgK7IjbujbWTJp07J6BGzHfnv/qslUJZb5UkQafLNPuLeSftKrjg539cpEqJ+OX1pnuRbSFqzcYu7sluSslTpteuw5Z4q6K8g/1IsaEl5nF7H1JubPaxkPazSAPec+Yoecmk2ZPPYd0fdXGnv+Nb4t3Zx4OkUbn6Gf2hvzK6ukft7xKT0KSeg7XDqlMbk0bXihxHU++pfSJ86+Xn1x5cnbSru5qcrb6x/yzmxrJxcvRZy94dCVJYwpfGtS5A5nVpOGbddtLE3b+X1v3//J2y/uB4dEz/Til36Y7zU7sHK8U6POB3C+/X+m05EToifj7yt2j7a7FVw8hRcZcOBE000wWdNyydlErN68iS8b1avauglf7VUX6n2pV3qtwclxO08c8KQsio4r6fNq86/nwNoet+eutynDoXvHSytptCV26vg1TGvXmTfv6zFWWJnydcDsiVlmfp+339U2aE/2Hwff5UstJlWMhOUrlOknmn9ye3LXVA1JPM+R4xnqXScbI7188u69XGh2YfjrpuNrc/OnqJo8h//eL6cXUHnmVSwU7pPZ8Ul8xni1c+/T4Lsq7Yu2N28I6K3fCTx8pd7Y2kZ7xyuOcY8miIdN8G0Ykk/jmJeK3r9hE6l0/k2PQzqWkFJ+1So97Acqpivt8K74cb869ts7MadJ2y6WGO0xjMrorw2dEpNxKEpXkurmvxVTxU5p2O67XGNXK95DVAyZNMJDtxUddjljenbyP9D+WaeV4UkU5U6dCsfHkzAWpZsdhwaTzg2L3x53Lp+D5yNm6Efppo1ZHbUdCv9sh9IxP7e00W7Ggl41eU89mEz1G2+yXKTutVpkivLfayjXqq7whqm//zL2p3QD2wpNn2jdgex96Ytb4uM2I4LalH+zj1tbLvOGm4lN636aHNSq7+3Z50Sawaf+Gvm508AABIAJUADWA5TQOwKFlrjFWB9AD/t8FVwNQE2BwwUkAGUBccF4Ab4CPC84X4Aeo5YKrDagD8HfB1QXUA9R3wTUANAQ0csE1BjQBNHXBNQM0B7RwwbUEtAK0dsG1AbQFtHPBtQd0AHR0wRkBAYBAF1wQIBgQ8hvfc//WNY5QQBggHBABMDmxlYloG+Xo8pUmixZaRxFy9Ih15Kc2N/VnIXhnbkAnQF4Ajs6ALoCutFY3B647oAegJ+V6OXC9AX0AfSnXz4HrDxgAGEi5QU76b8h/wUZOvfDcagO8lj+z+TfontiuR+x8YLWlX9e/Y7WkQ7VrNus+55QtLqHQNqtV5gc9t8WFLX5k42vsv2njt344gNZC/RYaZ6H3WbAu1qF5sZ6F6rFQnRaqy0J12PJ0nvHUpuPW0Ato0W+36Mc46sd+sS72jbrsdVAf1YH6sG/sE/vCftHiPGEc3of9YD57XdSD9agO1It6bPHLIu/J1FoYK/8Wj31hXuwX61Iddl3YN+pm+rMw/aG1MPOD92E+7BP7sveLdbEe1YN62fVkfx+QRz/GoR/rYD/YN+ZHfVgX5wvnw76ezO+3fT6Yz4eF+XzgOqMOrId1sG/Ug3Ud5uuvDb3Xi+pVJkpSz0++9WJ7NzXvG9Vu2Zhv7c3vT5hGelZtKSWVCGjdv7yvdOXg+HyV7shmbd1WnwKqNjHvm5j57ay3jc0dJrQI2PbMKE0Z6l7Lp0RTyTO6wbX2tfzNRyu0y3Ra1VGi1kz9GIf3mbEu1sG8tJ5E9UhUJ+pCHdICY5MpRUM7SlfaeC5t2aSNmVr0m9Gin1r0Y37sB/OjLgnroD6cL5wP7Bv7xL6wX2rRj3E4D1gP80lYF/VgPaoD1wf1mC3VvYXnX/wlas2MlX6Lx75oXqyDfaIO1IU6UTfbn5npDy36MQ7vs+fD9UU92C/WxXo4L6iXWU+06Ldb9GMc3od1cN2xb8yP+rAu1Ye6sC/sx9437ZP9fJiZzwfmRR1YD+ugLrserIvzxex3/rPx3+p4YWEc5L/R4aE4X+cm/828l1aY639JR36mjorRwZF/Z/0Fpk4dRgf5h3QUZ+rUZ+q0Z/jG5J9Zf8LUCWHq9GD4gL9JR1kmT0emzmCGH8XwPcjfs/7+TJ6BznVGzGT4OchjwJ/UUZGp09k5D5nN1IknzDXDzyB/bv2bOuchk5g8K5k6Oxh+K8NH/k4dVZ3jlH6K8zXT74jdjM4TTJ1DjI615Het/4jWTJ0FznkCUpl1ucTouM3UucLoUH5Bhyez/iOd4yK3OPOlrzjz3Evm/ndMnWeMjhOEXX88v+A+Bs8fuA/B8wPuI/BchPsjPA/jvhjPM7ivwfMI7kvwHIn7STy/4T4Ozzu478HzDe5z8ByG+zE8j+G+DM9XuM/C8xLum9x+YeQDDAYUYPwfk/qF7Wq6VR4iet87lOmU3CvBZ1GFxlflrQ/OhsXuvS137hV71a/6A3n0nfxqsuGxvPZjwbC3+mfysAENKlZPei5/aZDzwSP5gJxLudF/inG//KVv2x2P4/fKlpqHir2rsFvupFtVbc19i9w6dcn9hu23yu0rpkSvu75GzpW6ZeOlo4tl1DEEMBQwDBABGO647ICRgFGUG+3AjQGMBYyj3HgHbgJgImAS5SY7cFMAUwHTKDfdgZsBmAmYRbnZDtwcwFzAPMrNd+AWABYCFlFusQO3BLAUsIxyyx24SEAUIJpyMQ5cLCAOEE+5BAcuEZAESKbcip8okhPerEjn/ICHZIc3AOP3IFnhHcDG/6rfw0UeD+p3Y+LRj8PR7/4z9wf51/wZXfjdf8OPgtBv9WX4BX961g9jJWAVYDWd6zUO3FrAOsB6ym1w4DYCNgE2U26LA7cVsA2wnXI7ACe2p+T/uHKxXOKMF7yWyh6lhrxIybxcHpPb26PMmEh53uCigdsSouSI/4vaNeZdtDw4/+raNwfFyiFlsrU54B0vFx4XCK9EufKaqJ3jXiXLJW1jtZzHNtbJ+Wusy1dj3Qa5VqEOfU76bZGL7+8Jr53yrPL+8EqV077PPSi3sI2zMvvv6cHwqzWjcj6qmVv6UNOjTEbDYUMOQ8WNhQxZz5cz+BQUDHx2H4NmTivDyxc9DBMnTDBcnLjUMMVzu0E/7bahgn9e6eiR+tKK5GQJPtVyOuscp73ZgMY60nRsk8Ns4xy19+SeUCmmx1NL060lxz5ucgEt+mXIS7Uylvk+fSdgF8DsgrMAFECKCy4VsBuwx4FLR4E/I77DyAA2I4U74AfDZBUQhKGF4c+gsaXsJqRRctL2xQYsRLokp7BJKopiTQm7pcPEoBsnaUuDXVO6Qa6nn07/oX3XMV3jwaC8BM8sZWlY1IVtXR5/nIvG6KQJdut/kdmYzEObYnQ95vHczJiVgs2IfFNmWsQzvk//hfydaXzRj6dr8X5MM5W5+PUAaQu8MAqy5vUpHTaG6nCxU4ej1geQ68umd6YejcNnGHdWgAkqLYhuPYr7THeqgjQRKZNl2dqHXHY0QOmbNRmye/j4/TFL/Nvo0REiYsMRBty+MfOONcJWx1EdZYH/4DJak92YlVWFZud53idOZ4fNKYSnfuLgOQeuTrbmuKEzIdXDyP5phqCgGqUWEjxJ+BP/dztxO5aHTNFyKpwKEflSz5ZQBY76FhE37TSmtxqQsXxGrL4AAkLDaAQZUKD+hbNrG8kMVGfBkkJmuLVwpXcHi2fqEtxeStuh6QScnI3rvABeefSjquSHhJ4J9yeXUChzidSiAhTNjBDHirDAZbz3VuJCyXk0bCHteQBp8WfQMn/FG/1uboyXxsx3EPtLCni9ScYuoJe9ty2RkvhM3koL9F7XEH9Am3lzy3h9xI+tm+bCzHTaRKciU9nEFbVhHGe4cs7ShpSB5QQFVzPH4SHqX8L5lLuTlqIKdmmKYGXwEsnGN2zWa6TxQgTP58ghF/aFd5vNKClVR/i9JM2BZUjlraNjejzSzdtQnrSI0Im2hK4YQdeJbaTeDmbG13ZWrDJhvNMLkhqquWltjKtNJaJyMbw4l4ZgXDvb/YK5URCKzR+HOfLnX9w6thXPN9koxdnRmVvG8X0tLMh3wrx0KaU1msglPKfA5jgTn/gxesFkJi67QNGWIv4tNsXs7imQ6uClSSryKz8y9Go85AwyI6ocr8qfTNLv4r+2EO59LuRxrxyRAlHke+ujLHIPsaUdHJ54keRZ/ijfv8LyiAL81VUQN3fHJ/4kbp9nolZ2mr8lV2H09zs6m8L5EnWGd58OcE7tDId/uGFtrUnm0FhWnE/DKWYX3j7GHLdS54rEI7I+inBcbT49u3VQFZjGGPERrBZ2RvHnZpYnnWT355Fkv55HT2AcHit8uCLZwomoONJOdfNs43qqRNuZdVaDrtVB3LVzpkHfGkOrURwMD8Z8gzxa9nm4V49HfYU62/63hzXeL1m6yQMxkXwUulyY7PgKWaFLWI1eR5peHd98iznUJ8VKt0Cmy2Zw2kWekvIUUidv4uQ7Vw7XhKPos47RMTn4CUXRoeoFg7J8807AsWAl9s1LONMQyg2DM5hEDTEm7BhqRo1E6FyiwesYUg8/I9ykh4TWQraHXGVrSCTjJ0Qw7ks1u0JuUTe8Gu2T49gi7YttrAQ2ZZk8Dk9nvGE2z9tHs3KPLN8fdFM3JxPRyUmEL1DBPtQXET0NxkZNYb1uEtNvFHDrx022L5iIe4EZSnsvkmdxhlEGoYi0drPQ8BjuaufQSRNCfJYE1YXb6IoooiR1NWtKY4nXquBToibJEVE0GDsjY9eI77EWnI9uYLBOi5vXkmmSUON3gPhALfZmjvwQeIi8gyqWFrksH9bFtS+dPTkdyEU2kRyiiuOxbkaXSdA/R5CaD9NZci8Gy6n/oFkhwhrjr0zKiUFj7n1ak6aw1iGB5/mxiBmMY9tfFczt88X/6GjCpXwoiduIp8c7Wr7DhVWbKap9SJJjBr5VVTwbOZ07bUocO5dPYaofYStq6bG6SklIJymtKjT8dx6D7Vk8bXTn5OOZKNQ94MZ8Xbh1ntSNkTywHI28UhqrQ4KoFYrHN2ks/luuITlRgfqHSvR/HCK87hfhOUN88N2FYOIg+iFeHPSQYOjQMHL6Qtg4aaAgHYZZ9rffeLrFP+4eRDvpoJa7jQNvVqDaJMljJRPm2yzmiVclqmWPyN01RAzXEdj1ga0NV5ntuRzbic9J334AL5uVuFk0c27DCNaZazHj1UM02oqY5GGNleoHDionMv1uIdfUNRF+GMO3Oy+R7JnNPy4fkB32Q3xUCMcNlVhbcZVZsee4d/0FKlaipPUZM6G2jMCcp1yoyydZKpvS6/sQdt2OsrkUspgTPLmVt0JhTBaz57TRcQ7lNFI7pIDb/Af4hy9CoOMX6bmXcXZdyyqFBNYWbUWpN4s3W8/S+TiaMWbHmaUbR4ylNZMN7hCiHU35rBF4N4TxpPEBuTu7MHOYwAghN47dTuFu3lPWm69gxsBYon0KuSGoR57hYgTr/WleWs4a+X5el/7Llw4jAuwbuWBfTU2OGjFnCvHb/BKX98W01k4iQ/cPlkkvw3yPNc+zu/CIKCFF2Yqxpj+Ypm+MTdEh5Ie+8vl1B3MCSvE8tRjh5mKG3xzHw/Udt4dKiBTOJ8BqN26pd6nwuIS+jz8lE1zpqUpE/s8m7j/J4CHreXd3DLsz5vExcCe7q48wRkKRfdLiBDlGMUJekit7fRkaysFiaQs1QZr8VzOJoxnpFJ0ZRC1BljaPQqKKNalOsCAt4T5V5WOZGK6Ep+UiFC3COVf5ntez0nHbkYS+wkUmWJczJLaKt50DnNBz512YIl9fHmAwLZGWn89QXvwEFR0btGebMrXmX/YNijKwyhWVadVsTDvAmnPH2DSnHAXzevJKXiMmc5opXo9wibZnwdadGGz4SfCEcXTen8BgWReLspR+60++WJXTsGMnTicuEKHRwhOpR9hsvsBbyyzWh5ZQrT+eBu8VKE1r4Jb0NWYrLmNLxxtq9p7l8qY81ob1YyE4yMe/bxI+RxPt1Dk4RdZj/iWJ/Qu0Kf18gfVjYjincYfEN2NxEViBw91Wgg/Hc/h/Z+h7psnsiHv471/F2arZGF6pp365OW936+L03Zhfl5rY8dIaf6cYMlL2Yt59nYWH52KUYc4WD2FmK4ShszyU8Pef+Hj5JSsHDBm2+Mq0caUUbzlCVP9CXuQXM664irqtN1leHMZBE1tmh+mh+HcU420OofA/f0IUp2CSO5HDC07y1x/hJBR94GOdP0W6BSzo/EaP0+8fiMjF4cZClkTeITtAjJj19cg22OHytoHzUTIkyEfjXCmHyI80TK/MYs3ZUrz22xEUMJdx6erEd51gssVnZrcJc/+SAp5BZsTKrOd+XzL7m15zusEGSc2Rv2teIfT6NXx+uKNzfC/7HyXipr6dZbLbYNEPnuPHYKc5I7aY0fx/Cu4CrqntDwD4GSAWMUH/tg+7eIKNzyu/YYI1sQMVA1ExRqdshEG50SVitwJ2XDijGwY2IPDwSbONwWi4/7Pb38/p/PS1FyBycFT/V1J9/L3eyZS8BDEbeyjytrYsclutst9k+SpVPIPZHiYqz/D9vUIVf2rHmeWJ1bWZ8mXdgET17vyi7/ivJsOzbvrESDtDevE7vvWmb4S1ogtQraX+b/3v+FKw/l8Pyojd5pkcev8Nl73OHm2RorJAtOfwN/xRy2jpplBiNMFFovYNz1w7Y0KiPbFIdKXg0Vf8c9r9WO5O4h3qe9dxv+KsWcIne5cSc+wyV3Z9wWOrEuxejVWFPxp8mPAFb7XK2XmySwnoUcCqsA1fMNcw9I3tD+L3yas62z7jatGhQvojMU+4viTqM3ab9FNxLIH4Vur4aZzP+OrejXp7BcSCjbK6pnL82a6hJPoEca2xyeSIchzOf1g3exPxtYrgbNNy7LdBcy2zgFg0d/6/TWW4JvVl5Qxd4h7zhecjy/D36mWbhB2dxB/ibM3KMGdedem6H8QxsghJmwTn3XUTm6YSsysn3I+T4MDZtZn8O8TvT+ys3yTBy/y/zBp2jVh+ZcOMllI8+u+Jk0vOEyePd968qRTvnrDq889dxMbsNevvleCD/q/Xz/1HFd60XlutBPf3jDN7Y0Asd51/x7oYp3SaVvgOJxZFarDERVg4tO+wUNpByg/YO9+gCDdtHX3r51eVfULG+xTihelssXUqseRzUX5dAX5f4bxw1n1ikd4izoYCrCZJLJ4RQiyfetr1UT6e4uGffciZ2Nj8zHmtfFy34rlFyWFi8YYHBvZ5mPNlW4z7RlX42NfCb7l4ViFTYmVEzDtOvadysYX2bWfXCcTWK+Pj7uZg0SrTlXks4lvvdi8enYPNeiI/bW9RkPSzXC45ZuOyxxPVRn1VOUPoWZWFFwy+e9SbRozKLQ03ZuGnk7U8pjxW2Y8OTM7Exm/GWjuEq2xhFzs5Eytv79vXd4mYc0+0+2oGxqunxr86TXzLvedDRzpOVQr9EnapbDg7zzodrx6R/+SdKbFB9z5+iRi/5TxeyFqgCh+yqKLEeIlZUZT7OGLBFjp1H8bxA+VTDVjEHE7UiJVpeLT5NovO1nbiXtOY8an4jI1wp/IH8a0f2217P2Ev731jZmYTWxsZuFd9xE1zCp28UogF8xoyxR/w20mGWqybxGKHVxsfvMepvLeeyYHE6NkrVsg7/JaWzQ50VdlkQ7vTW1yxeOvykJPEgqvndY68wb+OzhV9sCSuvV1tZf4aby1fck8HiG+d3fZz6Stc0ct2CDIkts7ucTd4iRe/aZ1nPInY4HjMRp0UnLTMv6J/ODEqP3uuLwm/stuuK1XKAXFcN4dUPMcliQsOa/5HjC7/10o/xdPvG55YX04s1uME3H6MJ8XUeT0Uq6y2dP+1h7hsRY6fURKx4JvtEfv7eJX+rZjKBJVtLAKt7uKahp1JT4OJOeNO/ra4jfvnbTdK9FSFt/iKHW7iicLlwW/OqrxzZ/ueOGzY23pfekBln9Lja6KwyLCs2MKCGD0J7p8Xhh8/l+fkmKjca+C5OBg/XuKubzNP5SeHl0/0x+aOzXNnTVC5NUNdzw1HpozV1Bih8iz3kRrWeFLfnO6/amXEIv8O2UVwaj6WMeW2ymuWm1VdhUWxPsnsE8SCjKy7JeFQ/FxKdc0mRgFj0xPjoUE/VD2vSUo8puRH8m14mlLoJnhBLGZJDgXeh3ithDuTnIgFPzh+Vo/hTewov9B/VN4nOzv3OeyNsx5ZyyIWx/yJcU6GmE+uf1gFbWR8tH8rd70E9VCv0YowYmQS9GvRayix6j/1zIpYvO/qAc23kFB95InhXGJ0drlLxTsoNrQzvaBoJeM9Zfu6px9Azf3hnfNpKmt/ynX7BOdHrDw/J4jYoGGJ/rpU0Nh/ODVivyq82n7xKAzBiZ+WvplDzAldOM5WDNDQKvVTtgBKDvO9vCkd0qMqnQeziI0Lii/MyYB5m69oTYsk3pH94Lt6JhiayrLrbIjZS6nMmkwIupZva76SWOBht+JjFmw2njp9y0hiedm8VeHZ4C1TXG6sbCaeMKv4bA7cWWO9eGoSsehUaw8nFx7u/wz1vqrwSUrxuDwIchwp4+wjFnTtnt+UB3O3PBUtMCTm9Kit+JQPZYpw/VssYmQ4pS2oACZTlbMSvzcBkrCsLA8Vgigld9jsF8Riush2fhEYlUQrFl0mtjb/uryrCJy33JN+tFKFb1yWml4MJuYNCTnLiGtL37OCS6B+p60RV5tYNF48ck8pJHxnru+sbwT0/i+9czoS8EJFiSWYWBKu895eAjqZaRXiWGLelZt2XyTQP37mk7lOqvAtS6+uKIMRca+eIS6x+Uxb7Zgy2GNq02ixgFhQVMv0lIG1WmckS5P49InvRw+Uw/y7tSdm1zUAejR2pPGHcnj+psr1VRqx9Tq2w4TPkDE72vZJPPGE1vNzXD/DPs3xiuHuxMZJ/dyvn0FL/1tlwV7iWqPf0iVfwO4tl4XY9UAdWht6Ts2biny9TR0Z14PZYWTejEMoty8R2mhHPby7/+3KQ/516vnF7cMRrx62zt5t1zxwjHqhWzPECOthUOfA1rneXjSdfWI4Sq4HVkWV+en0QLor3WoaktTDmHCLhCngR5l2DWthZPWw6++6SRoCb1oQfUUHsRtgp/tI+1OMJ6XXZDvAGDXArKupc+pQMHV2jE8Nw22Aclb7hVC1C7Tohq0u4jWA043dxfYDtvTyPO8+RtgAfhrKm+lpPlR9hsEQk9QANieL5o/35tEoH9qY0gaYEuQ5wkEgoF0mzWliZA3wojfh/DxxCNV494YGYjfC0q1/LMv5AZTQMHw8Mm4Enw7jt01DgfQNx6WaaEcj0Mtt7DAOoHIC1hogXiM4e47psMFBtIa7soURNsK+wjV3LqAAukaDnoGSG2HUllqTGnSJDpys9YcpbYRhicxGe3SNXnc9dICRNYIJz0Pi6eNH5R7tm4bYTaD+usYl1DSA+uC5UR8ZN4GLWsyW7QI+dXG4tJ7hNsGi48xPubeQLtOjqpmLTfDRZE7UE18erR24oZMRNoHs0cnQyYKrtOmimF9MUhOsDD8YWMu5Sp/qtyDtV83f+PQRJUBZ3mg3QPImGHXo2twnEEhrJm8Yg9jNsLdif6w540T1dX0ajoybYcL5hYFP04Ip96nRbLSjGYzd3X4VDF2jzBcppyJeM1Q+/bHGxUxI71x6YAoSNYOeS4a/Gr5ObzHlLkDJzXAUGEpj8AxdNu3Fd6a0GV7zRHoNpr60m4allJE1w91qnVpTzbPUIW2bSka3BT6M+sskT/Mgta/gyRBj1AJTqZlO01judNXHyJ8MtwUSF1w5zWbc6Rs2N2chXguYcq9INjCBFOd/V3sZYQv0ZmZEuQ55UdxCjXImqQWyFiqkc5kT9AYrs3KmtAWmN6+WvmPO0TUjT/QwshawGr0oWt3Mh97l8uZfRrcVJp59F3EyPYj6va+vnTFqhbYc4xDZ0El61n+4iuG2gvOmVvo0+NPdH3a3MRdbobV2l/yutz/1VRhLxr8V2sN6QzT9HKm46bOno+RW0NCZcPL64Gn6xsaIX0xpKzg0505J875OuWQNNjOyVhi6lvh8Vdp1amFP3P8Quw3sD354FHrJmZrarauNjNugIpd3RpQeQGXpujcz3DbQGtqfvVJnP/3natUixGuD9brp274J+PQT36rpSNQGVlaDEUIvJ9pPze4Hk9QG3semZ0/lB1OrNp2bjyRtsCuFeXmTdY1Sitb/YWRtEFC0M6ccXaAiup4WM7pSKD/ztwHHj0//yttZyRhJ4eSIyQXpyJOS/W+tguFKwfJpRPIjxoEacySwkbkohQNpshTHrn20NnNzDBJJgZU3+kiIwJ9eP/5+DZMkhTcG675qIjfqNl9vEpJIIcxqr3WP2g46i/44HMmlMKZ++eH1nMu0WoiHktGVwbBQ2arF/Vw6N/DPNGQsgz1jHBXPfAKpiGW+SoYrg3W537+YQSBlt/XxAHNRBs5uMVM61Y7TZlm9/zJCGWxpcO0su+RKef+uJeMvg8V3veImsi7SN/9znYIkMkh5VrJF6mNPLc6s7WZkMjh4lcdaOewCfcHappPRlUPFqCkWz70D6f0eVzoYIznUvhzIPMOPpsdrDwwyXDkciihcNoSjKd9txeqIJ4fCvf+J/ZAv1VioIPNPDpOcV6bVMOdpmwotFkqWQ8uc+hd8CKVNPt9jIYkcuhPN3fsuCajBwYo+RiYHsd033jANVzpq8ONoxG6H46PP+38RXKcOd/7pY4zaQbZi8GQfTqB+xn0l+287vNihx3NFcVTcnulk/2sHafXvut7BEGrO7rkDjLAdHB1WVxmjUOoAtUYPJbfDNZa6wJ0fS727Ob+HKW0H2+DEp0t6bWj0JbCTkbVDy6GHCZgfTt27EqSF2AqYcWgw1E6QSKmvu0z2fwUsxYktGUw45d9FMwxXAQ6LFnk3sFyon9PnK5mLCjimxXf5NMCnqH/CxyKRAhaaqVEFag60/ok9Y1GyAtT+Uiz1FYTRq3cOtTClClBUcU28mWt01PP3o5FcAdlmxjssmct0Up1HP6PbAQnzjlyzRz40/+gzsv47YNy7d3CYCaX32j7QQjs6INU3aIYvP5Ka3t0/BvE6oOirdtZHJKA+GB0g/d8Blg9f/p0AEfTa8l8aKLkD/jVx4dnxL1P78l8qmdIOWKyH2f+oeVATXieT9dcByTtTTp3nx1CdSUvGIXYnzLo88ejKHltqftAmsv93wjrLKod6lh914nVkA8PthIMBL9+fYQKoWmcNMv87YbciIz5FHEk3pF+UMcJOcFjwj2IkJ57SeJj2h0nqhA2XtPE7JoKunssejySdsOZslf1JcSxdZyrXRfJOmLLr8ugAfjRVtqVKD7GVsOLeKXsbDWvKY+6w/yFjJYxcMrOkBEfRW3mVrQxXCd9vDxvmoBZAP959VMZcVILeyXydehxP6bHrxyOREkSyJJ9s72tUmGm+OkpWglgLjxphlkjTEy2mIokS5m+a3b/AJ4b+fxd3ARVV+v9x/A45SNew9NDdBnGfZbC7t1dl/buAtQ5uEcbY2Nh5XNau/67tIPfR4dg99mAxJmErsjq68nse+Mw5nFXg3tf5Tp6O5/ueXaStaXrxNtNq5DPNwUlLpSGE76Gjj1GSRjp7/WoauAsWDOKnKraXroMLIumR367euX0R1gWQKL6nXg0LBulB+jcrF78wW5JmLmF7602wIYFuiGvI+cW5Bu8XS4/yPfZAWOdOrC/Wz5yaACem0oF8rz3TPBfox3M32tF+cEkCecX33IfBRkvSfeyO3aFqWB9BU/neuwYW7kiC/87U8lKzH4gFzXvwZj+TsvW/2RXvhlVKksL34ithoUxsP7Np+KjLcGk4zeB78vdhowWtPbpo+qw38NehtK8v25u3qsXzU4iP7aX/v+xhtjOZdJ7t0YfBuiCq71ge0Ls9rI8i+8+wvfpusEs3In33h1fDV3B2MPl7Eduzz4OPJdNlG5KqzhTCQgjV/sj27ufAmmgqfF2wUb8GZt83ZD3fw4cjU4jJ+/oh68Pwvo5kWie2l38R1sfT3jnyoaOMcH8ltS1ge/qv4MhI4hQbqf9kgd7OLj+6nO/te8BGa/o+Yfugo2Gw6q3Y8wTb4+8AK73IXyuHxWi7w4IdPcv3+r+F88JI0LjfVt8ZDevb02i+5z8RFmR0Q0jRw5SFZscRKxu2918Gb0yls5sG9anYA3/fjnz3incAYG04Oa7t5f3LdVh4Ki3gXYBaWO9FLN7Yzh9qglUK0od3AhzM/aS3UqN2wbOiANhoRyLiWTcgETZEkyFtumpOd4Rf+tA1vCPwBZxtT9yHN8zpmQuXpJItvCtQCCtdyfz4ykGf5sI6G3L5I+sMrIO1UVQ7rl3Qo12wOoZM4d2Bo7BQJWoixPSma2Y/FDdc5h0CuDSW5r4Jftz7A9xfQUoPsi6BE/pWVxPIttmrx1xQwmo30suHdQpS4G59SE23g57Tu8KpqbS5W/ANLKwURx1/FfXTGFjfhvTnHYPJsOauuKdHxOt5i2GdFbXkXYNNsNqR5oxbfdCohUsdSRPvHJyDyyzIuD/fHB1ZDRcEUq0/6x68Ns9daN2erB8ibdATU7lSY3MHATbak+cjTFV+cbDKjibwLoIK1jtRz39NBd0Gwzlp5KyedRJyYRcfeqCyZPbW4hZrunxNU3g3YSHm3X1o9bEBX6k2wMJZcSnvKByEVTIyWzE23vksrHwpuh1jXYVqOPuNmLHju+8838ClNlTinQXbZ/h+dsR0Sh4zyBc2etIZc1h3IQGO9CeW68/Un+oEl8nIouYOAyxUi38+Hl772xjz3JL25V0GDWxwoKXZTflDlsG6BvEv3mnYBpc2iWHT0q9POAxr6sQuvNtwBVa+lY5Y+424VgOr/enT1azj8BH2UNChE71H57qil9fdntRsYF2HcPiCinz/XJGRkgHnOZB9vPPQH060o3ljc0PTfoSFR1Jn3n0ogt/Z0vCD538vXAir30i1zR0IWP9IfHhmwsyGcthHQRzzWBfiItz/regx47P12x/CqhOiO+9EmGDNc8km64DfWmd0HkpM0v+Vs25EGFwaS38df6f76XRY2C6G8o5Ef/hlg/Rv55LC5BxYc0ZM5V2JYlgyiVPFUAvDIjj7qrSAdya2wA721PXa4vaHKGzUSUt5d+JKizV3XejzkOjRVXWYd3ou/vdc0WHpW5OPPazaK1nyLpUC9nKjUy0yPPKCYNUhcQzvVMXCK1+IZypc4692gFUnpdm8W9UJTjSIuYMbxw/rC2f60G95x+obeLoFXRYoOrX5Ec5+Jfr8w7pWajjUk8RtHR9ztRguq5P0vHM1C1Y9Fk/Z5jTSxXCBQJu7V+tgYaWUmBa45uQ2uKxJ/FjCO1jwKZM0Z8zDLq90sK5KVHRnXaxzsNKaGIakhWQYYL1JesM7WQ/gnb5k87bqYZtewLVW9OVl1s36ACc60l4hNyITbdE77f9K/I53tNxh4an4PnrojlsBsKQg13hXKxpW1YoTrV57bG0P651oHe9sdYSNtWJqUr8ly/rCqidiPu9ufQsnWpPqo/mDN+bAqZbEdSDvcMFXI8kfFctmXp0E663pEt7lmgOX+NGcIR2+Dl8Bv3QlW3inawPc3YU8mOX+btXfcFo3OngI63ZVwA9DSSe/yGUJp2BlG7qHd7yuwpoHYpJq39AaI6yrF1N51+sZXCoj/5xPnV75Hi7wpQvns86XDfq+S+NIwNaCdofdYMEgZt1h3a9AuG0MCXEvXH8nBn7nTWp+4B0w+JQ3jfCY+iGwC5xoQSx4F2wA3N2d7roQkD9jKKx2I4qJrBM2Gta7Emejf1unAvh5Evmcd8OmwzoPmlix6NdDi2CDO7WrZh2xdfAuOVnjdClnzg54QjBNv8m6YlqY9Yrf+/yeNuk4rHGhVRasM3YZ1jvRQs8RgcurYWWDdDGedceewitDaXAJ7Xn5PZyooGEHeIcMfer2ydR+0/NnyR4t1lSrqfYG65IFYd49mK6v25qhjYdXhtEcL9YpE2F9AIkwPcgZ3gMWbkvOvFv2JWxIpOUld9cnjYBPBZO07axjlg9nK8mnXwJCwiebraCpvGs2Dza2oUc/z/dVrYbHd6bKMtY52wIr5WTZT0+PTN4Paz4nr3n37KjZL8Tge886P9LDZV60ormDBieGk3N9/arVT+HN3em8SayLZoJvi7SiLPdosBy9dG0YWcY7aQpYF0C6drWL+BACZ7tT5TbWTUuCV4aQJ+XTM02ZsGASvXlHrS+sa5Rkl7d0VH5vtj1V8K7aKFjjRsNT5uaMLYCNiUTgnbWZsCqOWv29+N69pbDSgYzn3bUNcP8AKtOOrZ+4G9bYkntRvMNmtjtNrvTSZl0wWyC3eJftNqyOJct3GKbEPYGNftQijnXa3sNKb1KZ1GVylvwtPr+cRvNumwIWTFL9gMzaiWGwvCe52Zd13NrChnDqs7Ox4X5HuHMyvbWUdd0GwGJ3Mtq17o46G94VSu5Gsc7bOPjbLOJ07P6tiEmwMYqO4923+bA8hPa2b4qQr4Wf9iERzR04WDgmNRRt/eB6CJYnEnvehTsNnwqnmQtWlXYxwKu7kntK1omrgVW+9MyT28oNjbDai2h5N866scXvwonnP+cfR3vCgowk8Y5cKKz3pPujvP3vpJjtRt15V64TrKmXTAukT+UD4exIuiKFdeaGw5/yyYJk+cnKfFjZgU7i3bkpsOaxmL903e6GUrggiiIPcuQ//YUjQpb+yhS5vcHi3UhB9i5QkClHCTJrpSDTM/P7cHZvYPf84Q/ZVYYD2+aDttY4aGvb6sC5alTL4+xaPw4H2+1xIJ6/dnf22g/x2r8wO+IQvTP75Z9nrLLlMxSxa/aolvtZ7D5vVMtztrIrD2C4tgpgeIwWZO78iuUL/pwyPJ/PT+E5CjyHz3ex+VbMazH3ajU/3mouH90y/6zV/Drm/L6m1XuxNInqf2jXjjc=";
const depthText = "eNqtWQVAVUm/P3U7uFwalBYBFQGRUq6ErWu3a6/drSt4LexF97N1Xdd1w1rB7m7RFVsE6a7beWLeHOD79Amy79P3mzk1/zkz/8l/zJ69m/sgSGwsgiCfXnEIsqJT3fuC+Lo8sXHsd306vFYokDp0ikqZoIhKKexYR3sQjwBlNwSRxf/6Z7v468O0ispWLzrUTF0Te2vemPgf0sRxN9NeKzyylyiUj+Nieq1xipxT0yt65L3LEfYV1oiFSIfgm/setRs69XjgL/IXEWPme7cjbz4M13rZdlq6/liMZqC/T/l+998DwI5jo2/uvDCjDHT4+7ZqdYn3uWsugQ5lqhovFGw6OVH5vtT7jwpOeUl0cP7epw8mJMsS0gfuWDQeQzEEQxEYUIAidQAoYK/aB/ysv8EsAANoHXAUw8BmHofH5XAJLkFwcILACAzHMEioKwuwYGhAMxRNUxRFUqSVJC1Wq8ViMZthhi+H5CbCcgyBwQpxeMNx9sLZJ4HVRxwGFigG8wGMbQUDAA0YwMAmAYCgbGTbjqDshbCtQ+q/AXtnfwEwMGxLYEMY2oDMtJXZSGGQwEsmlclktjKZnA22trU3mdwGpkCKFOaRSqTwYWNra+/g4hZ74HI/T29fv4DA1kHBwcEhQa38PBxFZPmba0dSlk4c0DOh2zej5iT/fOZJgZ6wbeYbENQ2OLRtcJvWgS39fLxltxQ/IiWPz/68afHkYT1jwgK9mjvKpRKRkC/g8wU8GPhCoURq7+juExQe33fM7BU7j93OMTuGDV289/qZC5VqtUqj1mr0BqOFojFCKJI7uHp4+we2DQ5rHx7ePiwkuHWAj2czJ7mNkIshtMVs1Ou0GrVGrVZ/1VChdz2J4vSzv25LXr543rx5C5cq1/2w++CxszcfvymotnBkri1DO3brN3L8tDkLlixZMn/md8O6t/cgiu/sn9fZNn8V6iNxlsoFfCWVpSvRVBtNyvOvJBrMRFG9ThdJLTyGy1d6rYq1lMiByl7Fp5I8kxOMZXaM2qFaQG6djXwA+PBSG2D8eHLXEz5AuQz5LACMTQKnkC+HcgXyX6KedQChVIL65iG1sWEPNGgz+A8WrwPIlwK0yAaNpDaGRrLFXTN/wSRDa6FWLm+6+CaZgr395VixvqmZ0HT9zAdps4KVHuzzE2mz4iNpU58G3z+WNh+/fyJt4qC0SfgnaRMwYlekscWi6FGJWyNuhegiel8PDOURhnbfJm8L2uA4J2LuCMewWbuiw8nOjxV26QcUB7Y/URw5sksxSjGpd7Pew75fCv61fOiBl7fLE8HLJLPg6Nke3OdLX569oXxgCJ513w5h2nYvGouC71qPtlz4DkzttBusutZF1aPjy7/GOxsyRvwJRpLj9h+xjx2gqkg/a4j0kxV27DJIqp4ZtPcSyMiv7NNmw3fRQWBlwvsTh+d2tpd1+jG4MCJl1AobhmJ3YwawsxdDMAwjCAIKIwFfIBCJREKJSAwhkbCXCN5ZsE+JWCoFJ7QaGGqh0ek0eq1eB3dFvclkspihgKJpAFAUChKCw+FyeDwuj8+D2yvcY4V84Q+LBQL2g89lCTADlHo4CijSZNBp4Aar09YWZDaaTWaT0VwbTDAYDUaDXk6qNTCLRqPTanWw2jroIDNqrc5ophCUyxUIhSzvUgkMNjZSmY1MBuWKrb39V23CC1ZaGaa2AFaq1638D3IdhnpRCGAGBtLrAwOJBP9GKM1K/Vr5iCEI+1Z/Q9hPlgRf6iNanxMGNt3689ga2DiDwQTlPk0ztSTAWIyqiuL83Pyi8hqDmYIjCSiKtFiMJr1Op1Wpq6srK0vLioqc7ICMj1Bm2HcGg9FsISkGoOxYc2DPwxuMOIFirGimqdpIw1eAsM14JPTeHhnaNqClt4eLo62Yi1k0ZVnp19IOH7nw4NWTsykzR3+3ZPfZjFITJrF3dff1a92mXVhUTGzXHv2HjJmsy10nC4BCOiQ8PLJDdHRURHCgpz1Hl3svdceScd3DWwe0jR08Z8tf94vMYje/tmFR0WyesNCgNoH+vj5nhx1eExXSyt/HvZmLk7OLZ0DHYRuexT4e96skyMfxt5P7rv2d3OdK0J3E/u193eztbR2cXD18A9qGdUjoNWjkxJw9Q3l8LofAUYRhKJK0wm5jEIIvsXP28Alo3TYoGBbs4SyX8jkoQ1NwvlIkoGFfYwTUwL5qkgDfi3sTl2y7JZiUOdr6+8RQW7Kmorjg7YPTP61PSly3/2qBNGzglDkzRndtxS+9+cvycV2C3SSY1cSOjYY6XSaXuEhlXK5SctuYp622UkrkElVsUlNMdoVVaCMUcXjSyzUR/gFo2cs7yrCUzAzEJ3DA1idKTw/rw3S5qoR6X4U5hSuLXzrW8K04Pb88V66CL9SaiAnvba0oZVGe/zWgUkAR3DtK03W3conJauxelINohRQHt37YdGH876BMAv8I5HMgiSYlTNOw8L6wVhZfpWNg9H+Kh89PNoTaUBfrE8FHAeIDa+C/nmRztjZsIvi/Yvkq0CD7P3d/fTMUt5vK1XSvM77ZTdfTJDst3zZMrjVdENpqtlAAvqKfW7l00sqG1SEN0XiGr9JulIP4PHYrwiF3jba3sZqZejTUbm58ot3caES7+eX/Vbs5MftR5M/J06NTqo5FXNKACHdfY7u9Y9aHrVn2IOT5edeIjj/GtNsRkhn+aN5MxdmYDYrwY7sVmrVdFC54mmJy56sKm0W/Rk2edXDRGRDh9Vzrlt/nJ/Bgk2Hlyj+vDuh6wKCInTzydKja7qzILpNSTVkHzm2Tdhz/Kq3FU2C8du5I2IOUFzT2XDa5Pzf7RuzYkyJMZrgTUQSW9Tk5qmfG+VSbDdeqfiu4DaqOpPQXjB8N7HTjnfldeO+zve/kXo348d0pcG6GJTFxZtEx+9Lka1G7BwVMWhu5KF63EZv7RwY4HjheFO+wWQ/K458u7B4LUpOwksPfN5s36OqcK2AKen3GuW1/7Ng8McKj++zmbpnvsrKyMt+9efPqRcaT9Hu3r1+6cPbs+VsZJViz8N5DRo8c0r9HfMeIkLaB/i19fXx8vH18/Vq2aRMW1alrn+PbSiqq1Bqt3gChN+jUqiooE57eu5B6+HDqtedlpMjB3cvb18fL0725m4uLo4O9XC61EQn4BArn9swAX89mbk7Ojs7Orh5e/m0j4vqMmLpoxarECTGCF4c3LVcmbztw4uLdv19m5xYVl5SXlhQVvs96nZF+/87tu8EBrAWqVqmqq6oqystLy4rLS6uqDZTIs9vClJUDAkWMpqaspLiopKSkrKKiqlpVo1HrdSYTieBC27IpcqmIw0EBTZpNerWqvKwwLzc7r1jN9UoY2redI9CWl8IKK6vVOoOR1SsQjMsXy529AsLies4QFFdWaw0mqAuC2nWKQ9kK1wFjrsh6V2wWyJ1cnByg7S3gEChDQQmoVlWWFuXmZOcUqrANi5EvR59bfAyAWgcFg9TWjRNQ/xSLxAIeYjVBbRHqUSSr99aqWBiKw4BiAKFpi9HigiMUDUGxF0XVXgzAOHyxjVQq5GCApkiYRkICzAADCb+tpJUiMXnqOH7tz2zNALAXzUCVzGw2k4AQiKUiEY8gUBTUAQUoirOsQW1bjBbf87NATlHWlQQjAp+wzzg4h8BQBqowJAVAHbsozAPJEKzCCSjKSiH+vyxfu2XvL4ePn0xLSz3624HdP6Zs3Z36Sjp079Xzh8//fX5ZqP7+0X07t+3a8/OBQ4d+ObB3e0qycunipA1/ZogH399C5NToDVp1dVWNSqc3GTSV+a+ev9V79Js6qnvnAb2DuFV5uQWllSqVqgbOo+qKiqLsJ+d2z45rFpR+1M+mYNWC8QO6xioSeo9ZdvCl/biLgoTYLNXMeRsPp1t3+4INW+2DRbfn+5ec3jx3zNBBQyfMWLpq+biWN8IODXrZkhR5ePn6twqNjPtmxIwVu8+80Eg83dTKC8dSXW/OXj14R+qct4QElD4+uXPFrFF9OncIbeMHV4lvSNdpe7uZ+b0cvFu09PX2bdk6LK7vmLmrNu86qvlVm/503wLjLFn49PVOIbd2rU+aPb5/l6jgVi19vNzscdW7LNujJ8/cPe0xYNDA3t1iwtr4urs6Obi5B0b2GjVr0Xchr4Znb91WOrWi29LkZZP6Rrdyd3awc3Jz92sdGtVRoYgKbiFHKr5KQ/wmffLh8+detLq+5Yc/nlqbh8V2CvfhZh9e+1fbP6btLam5m2prOBhXdmDm4GHfnyb7HSxv3rGbwt+woN2gR5qKd05FhQwhhEaT0nyrpsSoxzAl91l1nqqGYi6USKXOtjZc4ugcx3vALALEH0qbDLRcgBB59srna+5qO4d75a8LWtJBcvVBphe11rO9kOvmW6pVlqerteWBv4ZQhXH6MjRdeZgTl1GsbaZU5wv1GIXRCzSVQh1GobTy8g2BgSBxZE3nCFJkJihw1H7e6xoBgjKrlZ3PERROIy+UTypsijAS5Z8PDFTRJMG0OKhW5lcZuIytItvvzXvGCvqkNa2tNYnp28GXKnwASGuQpshNA6ebqLCpAj7WcT/3d5PNYLDG0xsmNSzo63RcCv93iQgMTXXYp760+rQmB6ipQfzwM/v4bF0faacf0JQB06CMBkyPO/RP86oJtpevhNQvbDQmr6aRj1Hvm0cAzdqwJM0gtd8N9FxWY7RKtI359iCRoeulGJuANAqGIBvrMBQjuBxjoQrncXAMbawr2TzWWVs+29cMRJOr+ut8h5ISopaxBkuJfcCaEfR/jzjKAqZQxuqCzAYnVQ18h3kNT6og7f/zpOr181FRRvpQdP/EpxFrf7JE+D/E2j/CroZFiirbTRJNinB1Sm132ys6nDdJFdOmi1DhnRSo6NnCQTF2uptiuLO/4r7cQTG685KpJ0/t5ywBCxweuZx+2+MGiJ1gUT3IiU+RTlVPWr/3VWtZy34D11U7hkfGBILHoVvWyTrP4Y4AP/oxazsGHMnAKsihp/zmHhrgwx8TP82Yk9lcDg6tvB77mgAjPSdecW7p233B+ZnTJ10f3+ZRJsBWZA7iH+qpPNK19bUWW/4AlldLIltxTvyr3wRhrnLZ7LBjmyfVXCl0Kru78jKyKu3IjO/34757jgDbkkuzsm8e4q/yd311Cuy8OsrhePRThIjeV1H5rm+/BOpOi+nCa0MW7wCDm5t+Tpl1zU4sW2o6YBXc0Hjec0yufNP3x/2yuJDW1ZeTxk40PD4G9E8m3PT0vtdjZq79+WTr+T1BRxcmBrVs3QsITdVBV4IO/lbhlLwjO2mUK4h+vcH10O4jt4+6u9xfAWZhO/r95XbgQji4vzehqwuVNTFhfccVJ4HVO3vMqK3kjWMrc3Pz8vLZWJifn5P58uGt8yd+27NlVeKWrP4XnhxdNWVYr9h2/m52YoFAbOPg3KyZu5dPYKiiz8jJ06a33vw8t6xKpdVBDZojksqkAtSiLsl9cWPPMM+I1UX+sQlxiujI8NDggBaezV0cHOBpF9TzUVJfU1lW5T2hYyt3B5kY+q64ArEtq0d36jV84f7i2B+GdDAvP4b1TtqfevX+s8z80mqN3mjUaSvzXl77I2XpzMU7rw/p9eeVZznFlVUancFsYXVOI4WIHP2CAznWrj724Z2CPWRQ+TbBAJV5raa6qrTg9d20PZs2H8wQyEKMKo0OegjVNeXFhQWFRQUFWX9f/f2HVfssb2+OXVCa+nvandcFZRXQtigoKqlg9X2zzkjaKr6/qsGKrs/rG+om5aAICvV/oZDHRRijtvT909vZ8wc/KDl8+Nztp2/yS9VGEqAAUCSFcBz8u0zf9PP2iZLfQ2/eeV1hQXgSmaML7EgPTw93qI/xKk+P5ZsPpMlfLm4nNtaUlkKG8gqLSqtUBhONCR19QzvG+FQeNfORL8eYfWYriQAcquAYDoHBB4bQhsp35w+r+w8OcRZyGMDq+AzNgqJYg4HDFYrlcoG+qlAtEEmgZV97ZAr/h1q8RO5kLzY++em3akc39+YuUgGO/Vt2YThXYufm4ekm1mU9+vvvsXYGtd5E1frIEQzFYQSkoSb/ceqVrgcneAJ1VZUGOnvJWvuDJM1Go5Hme0R90yeE+v11go/cqlbpDBbIUb3TFxpnOkrebfOQoxtuqDkCPpdAkdq6EQbFCIEEer+lQsxUnjtllgE6xAVcHKlzTLM3jOAJCWNxgbSF1Ko1mFlHCl7nS0EZBrrkDRTfwaNVZIu320ZoUYGQD1uFAAYC3lAcTlQ+0NRQYh7KVogyaJ2vi0Fgt1kphJA6N+OXvqioQRiJkE8ggKYh15DG+ls50EmPWlRVKgsmthHzUfgPS2MB+eKJpBKmqqCKsdvmbJhU1G3ThXc6vpt/cJCfPVX4+PqFE/+aNNV79s2tS5PHrT9+5c7TPJPY3c/fx1lgyLuxc4g5kfM6rJduZsHbeJcSPcYjMIYiAVcs41mr8nMzM07MaH9BjtyVuyYcyqoozX1fQvJlIg4GcA6fj5Rd2bb1r9QdVb10m57sGrIpWIphhFDm4Ojg7Bs96XjMtLd/j3R/OfH7XrPsrNKNr5d29Xe1gza7hI9xRIGLw2YtXT1iCa9cEvQt3Sm6jWczZzefNjHfjJmbcrrUc+whVaTC7/L9g0Oli6blZPyxtLvNmz/Xzh7bT9HWz93TNygmvsWzxTMQ8YDuF1Ylq3Z3aS6GHc7QKEdi59qy7+WjyaVZ5qDqOOXVO7289ZODmznI+HCYEJwrclH8oLnk+vr74asdBW5zdY6e4tKL64eFyoxFb188z1bJOm8uatfj7ZVO4d8ddLBGcdO+ddO+Sb/34HmByTF66p7HFkdXND2xZdah1V9l3VRvURxxWFzdfn9aTs0fLczbHh96ZX5X7thnY8YvXvN73zRXv2xTsVEhThzitlnZKVcf8GrLSyx9we2cDRXPersLMiu5NkK4qJSl6cYKkw5BlKZ31UVwejGXS4VyZxspF785qfKVnOKhyGXlG7PBCF9avFNevp1vcbLJdU3uEtOMV6opa4+mdM110Pl4neEqT/iWibIzlen+114KEUfP1X3SerdTCQsDtirvqGUc3OR9dsHDN3yEhyllL2yNuB6ncAajE0VvnfS4HoMfKL3SdYRFZsUZnCYYoMw6Ji8GCMeKURgoVj5MHi6q0AmtHBK3c/rT2FmgqRbggERLbJT7bsdbSnABY8Xpi80jMt3ExYicokBm60JVc45tMS5AKQwrUe59NCqvTMy3WFH3iz3T08ZJ9BgGLMgbZeZx+bMwgR61saDkgW5XocTNcJKZLeiNpSTeNtXputELV3MOB83duHDXrTncN7id6UDggO3Kk69Hc16htpYuF8CXm1lzUxrk/b+fytrUfP6sGWF3jqbAtX6W3X+0tBCz4PNNhnU32R0oYfm8sfDJv0gDiwCjAUSjBbBqaFOeXwBQ5iuPIT5rm/2Dcck6qZoYyQ9f9YLsk4Z96JVGzasmph77cxMZPi6ygenJ0j4iw/CBtY+Nzs91BvLRW4Nu+rhCUPv+aYYGxy0Ne6wBtZ44/19QvjWar3ZpNFoiwzCs6YZhSavqGW/YvaxH8JMa/zeXuEhDY2gj5h1fhKuKK2ihkIM3QsYxxmJFcKGRaUCDwDCUtkBfMUDr0Jh5iAKuhf4o5T//4xyejeCcyk7AJbCGZATQCJdjIUf9xNbUYBDZvmJ1BfatgUmP1qd9nWUZvczfwxYnLRaSZiBQgsv6fmnKasGFwGTlcNgTHcZqMlMITuA4B/rkEH1JTinqE2k48rFVKOx/K3JO4bFTo8drNmf3L65YGT0+91BfuWXt+sUjePYb26/Zt3JtsKwITI05/voUltPGYvtXfMZPM3tPyv1hiaSdpuTRnRhx4OsqyURBj915lQXLzOT8hztTXF1SWm936nZ8n+yXEs6cCx1OO14mZnnsObMwULC9A36O89PsbkH9iuyI2dk9x2RMnl1wK/LNqi1R72c1j+rTvJmn8dsHZ/vetxVF9rv7hHNb+HAeD5x/dDVptGvO5p59Tz17al3/rdgKBq9NPZDIH7dMHjL5+fQbf777PilYFf9NVFTuoTNF/BXLz9nsH+malZ34YMow0f1OUldF5MODV88OGJZVEDtj6twZXfq6L8/uh2Sl7U5eUH1+1HuD77aRM9/qvtk9u6euT0HmOUUFOj5pzPCfoieVbTh1avXgWx0Ng/6M69HVQaCI4c/+ZvUmQZW8R+U0UeckauTGuMlrNgS+qjPqSQYHFprDxQHUzdnRJkhWMycAhhhJLm7WWnEOHBIMAVYOYCgLzeXxxByLmeEgFqjys44QnGIdKaROb6V5DrYEQ9GsBk5SDIUDwCB8CaFTaTSkUGYj5NZ6/EmMhnVTZlLkKLDo9RqVheALxUI+j0PjtSuF0hpsnPgkVNqtRr0FYDiBUQAC4+DGKsrejqDMVqj5UrAOBq2d3wyU/+oaRC7nkuzxJcJQ9efC8EVAGPU0weOwjYCou0GGTRwxAhVyloLAZtSvGIbhYFrSVmJR6QGXx8UgP+DfywLHKRPDF2BsHawQ+x/YMht7";
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
