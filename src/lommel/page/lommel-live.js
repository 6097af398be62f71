// Made by `make page` with ziglang==0.17.0; SHA-256 of the sources: c2965949d151ed5d96192490176b0b6e75b7e8e533000aefad1285cb66cf9545
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
const wasmText = "eNrMeQd8E0f2/8zsrHalkbQKVg5zvuNWGy6X3iCNZq9jWrgcJIFcP+DABEQ3TrsIy2DiOL0XSJPltCvp/fM/YtJ777333iv4/32zq7VMyr/+ysjaffPavDq7HrFZyxdxxhi/wu7gMxmbKYsYbGaMbgSY4Z3rLy/OZPiKYpEXZhpEwLWN0EYBOFAIJQqaXCgUAq6QgCsHBheaExFYjSB23qa1tLUBtovh0PaE8gWGtduAwEqBerqRoYXADuKIY4JptQ9gsgIm4AABLGj+QugEmWNqLAA9L5B5eu0CiIEiTbW1tJaXoQDT+qOlZMhpDkAQe7QQBENDggBG9BUsIJPt1cuQnBXYTZhAgRHYZgS4cDEzDEYYldAxsAf3kBJKBoYKMitYJow8RTAKVbGySBRrYgtpxdCMkFSIYh3yR7GOrMPQq0VSYVh4ISgb0AK9Jq0U3YEHgBEwRA6RknigpBCFLXIkjKWtgRWkNVGMBvChGMB4CBK7FWFjAS5IQugr6KE2XojEaBKqq3iqNYT3sHBoDGSk0orWAhTKtmFoWqQFUCiJBgnqLqo5rTwKvw5fGMZCsEBUCVBMtYIb5tRwbcEa2quosINAh0lbgfqgayxajK8g5AogxUTjJ4fMWj5/xvLFs5Yun7ekdcbSluaD5zcfsnN69sIlsxfMaJ2/qHnGgc2tLB5buGTRouaFFrhaWpsXs0SIkHNnzV/IlFFKrU0xlkylHSezWWZQhoYpHScdjzHTkcpRdqYmmx20+U9AYEyaaWdwOl0rHTXENCVGupZzwxACs/APSAdjENTYvNYOLo76aRILZOp+NijDwMJMRgO3aKhaZtqyMpRj2z9XXCnAQ3+RdnMecPYW1rBfbil/tZUcurV0ttl2W0Wrbeeq7dUOStWYO26/kw17jS23rKkZZNXsPKTGUcrZRYrhOw1y5Ag5vHZXGwNIDt84g0MOM2NKKjNtSiUBSVlrMoe+Ct4QUoXX9IBbeN1k8n0CP3DF2M0ZLLHO7nIPhH/YnoMH67WHjgRpFJdyZL8tDiCJiAipGBttc9ipCM93RlCUzSWHNw5QIJhOzRgOx80dFb6ZQAlzRnAO14GyR6rasV6tadbLetkw0lf10LdzTaNh23s5ZpNp2jbnKs1rYT8MTSsa0qmFGvwp5tCA1q0Mm4+z7RrD2sW2+PgJ2Sy3DcMwJ07aO9vEx0z+9T4jh/zG4FOmDlH7Ovvx9M8du2b/oelh9hSUA9MB4LVBEWWtrMMhz1Vl1dHDZK2apj1i0zWPo7KjCUjbcqxyyAqOGBkGRHbQIknHqjnA4IZlD5usJg8dWlMz1J6uhBDg+G3gSvp3lrJH8N87aZney3EM9w9/tP+Udmw9Jv554h/pz7Qn/mVGltNaCgFzeK0DGOHnasQwpQZRQqg+5cwpI9LpWfZfp9RYahhXBnLTXzyObcCWP/xJWLa2YKq2wJgsZztz0mlb4U/azY6tgBS2XZvmac55WiuwTSmy2bl/mjHF5gf+IYaCHVozaNiYMYb2tlZrMu0sZTMwDumRY80dsyazzWqsNHfcdDoGVWDMyxp/mjGf/8ENopMPfZV21ligFtoNDpfOPkqRK8Brm4RtiMFc8OEwXO07bFzNIikX14wcOWSI2mq4pbYalbVsC1HMZpVqSjdZTVw51nT0l5W2BpTTVBSUrl8qYFtO5WlyWjFd5nDESNeGAaEPZaCSAIBNcxTsYbXKdHg/gDF06GBv8GAbo95WOob2kuzSnSbS/pFtwmJYWq+wlRyRzWaXjW2xR9pwdIfJfLly9rD3lWoqFoBOWKCgFYDRCvWMIwxUZggEKYA1B5ky1Aa9GqfINyDBBc6Q7WDCOdg8Uao1NTXKIpOrSpyUSwOD8FA/XMnhwwPhQ3jtIUG0rEA/7/dV4sNs+DeWH3qY/bfAEE6BWjox2zRi2Vgbg9NCu9uo+ChWgeYGOeLwLQu7W3Dq9yMaVoyQHHRMwBFuWAOuWjmjJXl6qjKGk6GSO4MNpAbLtCEkttNWtHUBIWygBrsFrVaLuARJhkhohzainQ+XtbKCsit3bMXpqclpGT1W8lUcl8wKafGl/A58TMnZKhHbzSpyv7293VZF5rc/vVLfmZ48FkxODe/rbw6Ybn0cc+sEsXlsUfOiJS2HCaZmzF88v3X+rIXz/9bMpGxZsmQRW8Pjy5tbZyycf+C8VnZ2MDl41uLm5ex8bixdPpddwNXsg1pnLG+evWTxnOXsUq6IZfb8ltkLwXQ1TwbgjOaWliUt7BaeXrJ4BgQijlt5anHzrJYZEG9tmbW8ld3H40RvaZ41ex57mCeIP+R9lMdbZs2Zf9DyGUvmsqd4OpShB/382c3saW5HWl7j8q8LD2ph7/GEtmfWouaWWezipDmneWnrPPavpEbPnb+wtbmFXZuMhdANyfhXgjOfq9v5qLGjxzRMGNdYP75pr4l7Y+P+zZSp++63/7SD/sH/yY+WD5gPmU/IF+WzsTtj51mfWt9YL9mv2M/a16sb1KPqMXUCP4Wfxs/gR4hOcaQ4ShwtjuUnibPFueI80SPOFxeIv4t/in+Jy8WV4ipxnbhe3CDWiV6xXtwqbhO3i7vFveI+cb94QDwoHhWPicfF0+JZ8Zx4SbwsXhFviDfFW+I98b74QHwiPhWfibPlOfJc+aeS/FK2myvNVeZq82TzFPNU83TzfPMC80LzYvMS81LzMvNy80bzNvN28w7zLvMN803zLfMd84LYhbGLYn+PvRV7O/ZO7L3YVdbV1jXWddbN1i3Wrdbt1pPWU9bT1rPWG9ab1lvWO9YRdqd9pN1lv2O/a79nf2BfGL8ofnH8H/GrE9ckrk1cn7gjcWfirsQ9iWcSzyaeSzyf+CzxeeKLxFeJNWqtOkudo45JHpc8PnlS8pTkqckzkmuSa5PnJy9MJp772lubqmeZ5ZlDModl/pY5PFPIrMi0Zdp10aP0O3hmNc8cwTOdPHMkz3TxzFE88y3PbOCZjTzTk8wck1JbMNHgs63E+sdXdrFxKcaUj4TuFswzHWgSpi7lYBINLnrGnphiLmtierxYLOeYxvc5U4Dn/spD8zmeFGogCwgbBuvLpDp/1VJi4Upz712lbaZR0Xb90n20trusgHUgCwgfztOXyXX+yQ5YwEA2WPlLGkd09pbVE7bF20SRtxn6a7RBK1vnGY0jui7yJIxd5pnVbuxVDokByffzfnvGNetypiJ71nkxLWlpsk2mVUvGIsl4KBmvy9kkKdZ5CS2pAjIkRbVk4vsk40rH2vQ3OhQdG/SJqcDFsitKjnLj/r2H5HNJMMWJSForVDfp32ONrwOThLpluZRr6bvlKn2XbqKRdzZu7NPD6WhsD0ZmdS7hxkCCN25XI2hM0/hqL+0ahDdICBKe0wbGEI6Btgm70VbwMkC6aRegCxCybsx1gAf7tEsKubR2MOmarp33z1yS98wFnu1zOAK07ddPhkcJ176kM2e4CX89YrDgkq5cIinI9WPhuqn5GvIU0UaWM0DRmD62DxA8FwMyHRLo5qb9dk5aPKcTpsQv8TJdq8mmzka23yWrczEYm+nKpVFqgWETYEEyZ7qJnAH5BOFJvz+F1Ec4GBfaZpC9sDQPmx2iuobrBLoNiAYf13JTy724K6Ed/OkCmGJRUAxSCHhFziFmWJRY4WraCsS++FvIODnYnpPEiLyOz8lG4FbA2yIAWq6OxA3lGlNRMNBuHOYlLvKLeQ8ep+F5400MWrXr6dB1wzXJ7pwJrXrd2FSsFDvMM0BPccjwLrp0gNUv5uJJUV2JsC/Uj1wh1Fgfy8q6G3KCStiNL0A33XII6hhTgiYQVGmBW6JegIiHKp6FpY1GFNbUlCBlWJYuXauDMsVYz1Bh4RqeoIJn3Z4I9XxolaGFlV0QunU3mJkjIMRgKXjA0Nf3ixHla/9HP78Do/Fpt2ldq2NqHe7th3ZEi8ARyFb0qD05L/ooKOrtceSK0eBi70RAxiNWzJf5HNygiIAskkwhWDoh6gvBRZEC7Bc1Hxnvsklw2+cub/U4RXVyncchfKDHUgzLMJ0T33XZArD19RnL/BUQ9FOTqAyB535Hu8z7mYNJCDyXNIKpo/OiHIeBoYRo9cRW4vInsJt7tL/DPD3JQzrT6rK8X8jDg93gBOLkw4oGMGqSX6SdpJG7keLAc9IJr799nHRy6ASrnuQRM16lkDsKpDs1SdsEKT0L3Qm81FFhFRsprrBCQH+fsZtGYqZj4ZNpwscKYlIK8YOROaZcCp2RDxzYdMZUK5eUMqpHnSZGwPaMeTCVbtSNPs+ZyKTh9/FlyJtr0oW7Zh77JaMbdQlHk7hGICm1JJQp4oVlRWQR6El1ul7UGzGTjkXpVNQobEGFi4gu8PgwDeo+g30o97ASvyzmBBys1GVvDrVRmfSBjSSiT/gsc+nRgWEt86T/1YPHrZK0b0r/5mef3Gjsk+IAr7zt5j5jCnzRG4ihdb64sXGH13tLOdF08OjDdv1gz7fH5OAbdhV61kEGPdZn0eOXwSRLQZTtn4pB9IM9v4ZoZ8McOFyxjcyOqUDqVQNJCQgYUMqgVCpIbly1bfOEzb+oL1f6vd5lF5a+FZ68zus3o4zwItORiWXYqHebCqa+yuh10F+Efq6NRhzqKyYbugSu3UMkUeBJncFAj8DH7PZYN645U1ECInvKXqyMjow+TdvfEl983Yajbyw37bnf6513P/Dg2FK56bpn/nHukPuzvQCPmL5xSIn/oR7gp5nNMLoJG0alvuRZIWxjQ3WtcrcX6w4xtZT6WLm7p5yLke1ktsZgz+rWVUAz2FjG1xVARWmXqMG0wQSnqIDUb34ForwiApFnD/bOTnHNSxtjKTIwDK2M3plypta/B0oIOFcuCLAxja0BNhJ1Y91aITbXcrgYIhYrdUccIWWgkUBXm4DXQpeBj0rHHl8XFX4piICoyk2kma2HWkXbVj7oIzRaEjozJx+HybdCvS0tXqSeEwXdfYd/b+f195BoJGTpgdJ79b9HGoIpxpe9RXr0saiYe3IMlQyGvmB80ccOSBlB8VVLTQuS2T1A0Ai40K6e4fNW6tm7LGpVI+i1ZSljYMUaEOnvIxmu8OCTl73VW/xDilW1mC6WqgCb5BPtCy/f+Ms8VsserF/IY1XaIotfPOXinlsY9FEeqpOHaX86ukOnXzjl4o717IA61+zJIRIGddwy/9yb1vYZKCC3M2RzOlb3VuUShXwdtZoZtTBlXWIeNT2tF7nUUOrxzIGNWfYs10SheNKVZc/ckPVsV27wuGtDy3m3H/pgfO0t9eUNWWJqatpv7AuDProZ/fC8cc/pc8bfgf4E74bkZYce//Pblt1b//tTvFOHTXq4fsOHfMPHwMuvz1izZs1T9adMp/FaiPfsDTAdF14qwUCruwRXBhQeU88ZwkCVVW2EVFNrPCPC0MsMX+PJCDFwuyc3/0osLqebdA36zvHMOtAINuu8/lyTMoggHYAoh033jirOPbf0+gxsxyya3v6zssepmqJ58EaU6SSzz4Pm6FP2jLUaDfpaGGOQJQhzd4As0dSVIUs3SZR6uiO1PQ5VdWSfO3ugFT2bWNHzH2NF2VFaTbVy7kaf7yoHc7VyTKuUQwLKgwf4w1yIqvTW57jeNAYmhK0Jsr6u+lls+Dc9e2afETX4x3gscldkjqZFgtdTtsme2NM/h0MGnuBnrpZaqumY5366+Vz39PWlzBra5ELG9cVyP0T//nIKRMDiVW3VrKfU30nqOGHQf8WiEOx+vNpqEexFk4INDGaEu6TGM6D9Uz7a8KjIGdVbztS9ypuqwbsBcd4DTvBB3FjshjsEx7YTjiK2Cd3QroSNaGvd4mV08BPvvfoou5w6+Kl937jxnqY38VjVrX3z45P2nvnRVyC4wz48+cWtNoLQdPLrs5zXjY31pRJ0rdP6Cx36Zhd6PdJJhWd2k4YSBRoYQNTMTN0pJT0txA+/oWE3HZhZxKIkdYyaardvmvZN7qv6CtCLHbA4vU53dV345g4dBoQ/2EjVoCfQTfXAkiLcQyenxKabP0goLG1CKHNvH8lo8Ph2OaXq0fRlb6kfrq96AcGDxxd4PzKUFjsTGiIxMERiETMHs1AR3WWENIDkSlfEQMlouwYTy0nNotOIFyk3/DTtuDC/XdPV5d5y09oNz++3/fOXUMoWrW297OPLryJw2U+22Hj7sn8TeOs7Z2Ifvgtgjrb7fh2bPe29MvKSE+HaO6mDh00+/O/14N53zIOluakrCFzs/vq2+8ZdR2BfBzt52KSbCUxNp/EYwFysPwn76Ndjo9XTecC/JNsaVO0WXl7K4ClVcN3YZ/X70togpzqbbsTa/Z1nwXtSBm/6/PAfbC3KYKWf2gt5l1/UUl1HUe6W7oHmC2EWvE3ovTaUbSdF1R2+puotEDZHn6b4FxtSL40RUNx1JT/oxQ8mUWBGnTDvmq1WnU8hn97UlZ5+012EXbHkHWPQ449qrB63ARspWnXyDlfcdv1VUPR7flzdwtjrxHfn0b8/+7VtWAPAydsf/bNfjTTWlwaUn+FiL5ba6itf/3cfBT/y1ZX4GOXwhdD6U3b4lhee9O8SYk67NMc/HHWOCrnfAnfQ2Us7dEuXuisSo8FMJdftSqB7tDaCZQnKu0uRglK/3jCXFMmGfNSNFVf1S8aGbFjCgL83iHjXkFFQgteLSlgrAaq8XlRiXIlWBV8JeCV0EX8Y/UocgfdieBcpu7jynjI9Hpg6PmbytuAFlxf+zwouKqwwOPEGl1OJ/0DJDSg6zZniURard5DqGjzPM1yDtCCSkqJI8A9Fkv0nRlLqSEodyf6qQ9kFT7zIsZwBr1e2t79Ce2ZUbGGJkHORY4B/yDHjv8gx2rwiT+BV1VYxcKdAnsyoscgriJquQc/I/+7JQ38He0dwtDaS8yK1AbZkX2a64FF4KqUPrszORrl6d8PWWzYdcPk77SZupUMon6n1XPA2oaWDYyyO76H5rQ1ouKjVEwuCHyQaza6LXEFHbzKvnx6CXu+CMzjhG3T2JipHZHT8BWR49uZ/SCtBMjwREy7dHBUKGwMP8CIlONmK9Aw8w4uU6JlSV1Y8oA/8dfklbcFrCywU+JdzQFRSXNHzuioItB1y19gkTjnUNgVE5rh+fmJXYeHcaAAHG8kYbjyfQ8BgOx1YKgVGmzYKCOdzjBgb2e6a0c57YJygmaSazslgivU8/xfQ7EsXXxx+Mvjp8rzLQnu1DYaOPLLicrISPsJM+LZpLs/j3CgGJ4mfIjaQTuFYkqCc4YfQbgFJVY4cv9SM0nfH00LhIbi/Wvg8c5q2wISOohMGzTVDeWoUJAJofSazW6AHWIlU5aFvNYe14ABCwh1AMLCGuVSTIhO8bVJmlWJbrKQZykPVsi1WacrRnfQm4rPM0aAxpiahwMPaxBFx8K8IRTdzCrEj9jyzJoDo3JJtpvXrS3AC7ajMWpoxNW6gJmEUg00+0sSgKdQJn5kW/o7GBBzJnEqzADxHg4sG6NanaRyZ5UFm86gSH8wLlnmcKLR66AfD+qcH9Rl5wskTvqknPPKk2oYk0ypK/ROm9/QeFfx7vRYXVlem+EcPwKWZHmIfgMuEuBPjMWqp4Bsv0O9/IvqhDv+dHYL26D9EMonkxfyVS/P4aRPlj7hZdLLWNjkVHhDxTs9uLBYqp0dLplW9weXirhmdINXvC6/tqSmhlZskGBGXHgBv7MaV4Wxa+JMgtvh+BR/2MWio+KOdLw+gToM1bP/leN6H+geaFTzicnFNLE7HPL7WjSO2F+m65OPp10lXEElEHrjxHt0gViQFIBTxLNKZKRMMJvzOiBqwtCLLjVFAczEEESaEg3Xo31yD+P1omAz/RmsSRUq7VE09YDwlIXN+sCigCwLIjVX95rvTXuUBy1bEXywUAgsEYRrwaEy4Zqj98seePrah4IkK76EdK8L82IXoSRqH5PZULGyZb7Z6clvj+uPQzp4q9/8LRdXps22Ndk1Jlr1U2UtDbsSRN3gOET48FoSyC+E7iaXkZZAZJLrXjXeXvc1KHlDxkqfcNNKjcBa7mZtyk/R6ksSbu1bxZaTiQa0CCjKQLmEAZC5WjZchHQ9MuZyYygRdrNnLAboUoc/U6Ar+xAjfFeJLXgpmratELQ5T0BxR30j/ukPzfj36Q2f3Tqsqu739tWQFP10fZU/KxWjTpZz1V6MVpdKqpBc1nuh24QlHBBQ6n7yLd/9Paq4CTHIcO9uSbMuWq7oGvsskfblPduiYmX08YWY+rj7cW975ZibZ2Q0z80I4OeYLMzMzMzP2l7z/PUltF23P3Wzg9mrKlp4e/HoC/3I1eLsW7r3lldHR78UVA8fzA4p+lisloh+V65bwQfcwjxaq/jbp+NNXCja5VPxuqvjVUFFTzN80GFr3KeaSwHwVlXvCh8nQ++jX8H3hq1eee8oDbj3XqXQEgEPGbw4xqe/BcklmbsN4q92HKUxFQyZnaAlTNYCxwYN+7tXwekuQQuYpOV17dfBKHNpfOOcpubMPhhifUWV0yMmUkfvxPDfnEh9sRcrnaSA9mTgUDTd03N9nF+7gmSPJ/O2TaDiIVG94V/YVqS+FEhyTPt/jN3T5iFN79n5f3NbjyUtLR4IKQMbyuc2YfKPnOJfuF9kd7pcLjWcixJP+2/Rk9O84JyPMhH0tOJbso0apuOdWjrrGb7Kga4YfwPmanD++Fudrwu3g6RJqRydsesjHp2xmepiF+gvjAy1QLbsOy9Sbez06LDMgNMeHZdgLgzjGERf9K/pUPJnDcq5WD70KPM6k/97hQ69ydOiF5/K+mBx6FXzoBcwVkOISr2+/HZD7gly+gz5U0On07Dk+79Ibz7uQj+PjLtkxbj49YkN69SiMOzWdgwll8RhJEb3r9Ar0pZqcXsEb0oShx7oKiWJ6fgY6Eppvi7SSZk4j2UFmQzd/u3uT1eOQwO7rmLA+P06ayFl/Ra9wXowx8HU/+lk/QMc4GJiLb8FkwxOQTudaT0KVjmP2m5/4oUxPgnXHPxTviOK5HXhy5aT4NinOqcXiW2EiRHKPuLu94xJ2t4s34Wa9+FVS/FDaTK6xsj7HVjo2uPjpaODzuEt+j3iyP+AQP8O7Bhb/ZMP5ly++Fk2Y9VV5JZvenIT4AjK9Jqne4FGmGJqoZh91xtNAvhbrOS5oVt/vqwOf4323yufL3g7XfcBMc11XD9d766GBpHDa15d0X9J7ate/fLBLEvoHzES0IS4XX8X4a/aTR0UFr/EPUgK76KWv9331nw0FR9U1agpvUix4BrFgJR+pMBmUQ34VoYOkgkpWQG50mt2UF9Jy0V4tsQX/Twe9K6B5S9okMS35T895mFbskh/55Fni26WLfizPzYUInyL4CLwRdL0W8FQETwE8Q1M8gbf4bD6qUABRzmX0gS+W2GkNGXxbvA5GYC68ajOKyVBMsVSjVe4Vg0TN1bJT6zGpFJM6ikmlmNwXq7xAKAr9maM/M+rI/Ci03q4EV6NvG2w+Ut/WqW/r0LeswPZO3Ob4m31+b8/ALyMcRetN7OISJaUUmyXoZq5BlHRPaSfD1Vd4XFVJrlxCyRJQCBBUXKJALXsjUVKzBvLO26P8ySV/jORPzfkz6uDvwwN1Gh/rHWw2jY6COv7Ah441OF878HqJ5eWuO5aOPk0sJb2jjtXH71gz7th7QIjnKMm4xRs59i9VKXUNK+wNBeFNCMD4nPepEnmZIqeqguOR6ApxkvLZgBKBk5Po9DS6EqBhoEMcHVhgWJZyf9BX3PdQWIYx75WAxp1/dp8vyw/YJyCSdqiAGMsL76LXUdIJJR1RKrweD+lXHnvW/e5Pm866b7VM5hAA33PpCWErNHzeT2fx8g/SVc2cGV08+Cqyy5hgQQ56X/PdopccXD4ozx7HEgoSOTMlNAz/MHtJp1nVn1SiS4uuVSUQfVlShL26XjfVA92RMSSn19TyRQdsMNUpkFPiyOf/dHLh6z6n3OVDr0X8ZX0Ov3s1ckdOudUGU5pMFcd1ldSTgl7gYSNHQmpHPCDbSjIi721/3688CHHkw/deegLHhsJv/32TgltuDg7yCA6QbIpuzbuRkN4BARa+6rgQwAkYES/Ww9+JkdmBUUleWOnzi9//Kw9KwHzRX/ymvstuRwtAA0Q3QjP2eh2W3dgVO7CryOv62NjBTViBO+vg7UDXHAfdcge6mBCbpfv2PNej6UbFo3eKrcAM82bc8s2BLMrxRwiNdAHmijiTyIsJKLse2zi7lCW4D1ukXJY4Q/CAt007oWAqLjK5zIlexdPd0Wr4Izovorc+egtRmhzPgIN6lF5ww6Ehyuk1qHwXvMV62qsHZIseq6TXvAQYEcuvwkunAOkxmiOD9BlfiBQTy6Eb33BJprXFZ2HOJVWZvCqvvcGZtuZHS9agRxbTkoZNVwlBmCWR8iA5yHx33I8oLBSn2QtmwlHAEC+m6wVLCK7qPnrxKJWl8AUM2Fm8OiAw+AQlvLkacRsHm5vQ6fXYVzP2lSW5nyVUcdkkl1GDAnHZF/JAbMTt0Bgsssl8oI/fBr1O8f9PpoJBdkiTojYU/VdOlHl6r/B7s4Nex6yN24mc/pFXirHmMoeVSz/2xfCrv8BvSRfDH/IFxfZ9XCPZSCCqR3t92GYr/6NDYKfuTdHg24bvMwDssdnj8PVI9XCvJcuJVXikWniNRbvlAWiWAIg8gm/k4z1P8JFDHG2aSmh85c+UFKA+wRDB6HoGv+pHYYYe9MZ9dqGKKQAm1PFWBzFev8R3uewqYbGHc1xgAY4K4GS8D5JE9tWAhxeK/4Bo4UJejTmP9+nNBiRqivy0Nx7f7+4NEu7x3kRa/GL+KEKCQAAEBDwgMEDCIt0Aj5IjmQosNHZUjMjpE9xBUCDuGMKEWWqMgyNP4WNf+ArXW5yDUz44uds5Jc4V4pyFc3bqnF13Do6B+Tc4WXvYZTghqbILGTE+MX3mxM3JNPoMHQoX7j1XGUgZQyKC1rsDLbn0R5f3H2MYMOWZC3VPlzzgqSu2S0X4CnqfyfESDl1B36NsLNwteTYadlaSC5M7NcRhFtIfE1KOCBdI6UcSNDnqH03zhuyBSDMXUFN8L7ziK4RGV3nQgb0AMHwkfSnRiXWH9Dn3LXDj7nZE3aUjVMPPm7CmMAGsjXbn/hY/Q2Ef0ZvpPyGh4X9f+oK+MPxKmS9wo9uCSbpnTKUWnwGt6B8V5j18SzcHf+8Jr1hRz60nDWXVksYL1CpGgXtcc88LVB5BQ5sHTsgrA2lK1MflDx8HrYYcWb02btDsAdkjoBLNSNP9UfBw4ndbBUANlTjpntPSL/dmUO+NSyThqCey0AFuBXBYXhs27l/yPE+Ib8A7S3hnY7zNFG/z9uI9bXg5eAsWAvsEEtKwHZQEpvtUlQIvQ9BFCMeXErL8RqB8xrg4uSoKH4HZV4KNNh4OXRyCDK04mMxohBl4x9E9eMjFkuKT5jQuz/RZ8FsaGqYp15v5XKKVsb6964sNaed+Pb8iGPxfRED2Ue989AT0k7/IWxpLUqhpsTGPZOVeFPoc3sq6D8AslIjcXxo3RLbnwzn+gZzQbxdQwY8F2XtztFcvwysHPlv8KF98xJXVl7aAlSiY+vvFV9jfL77i/t5tePx/03u16OXpWBTyYORXl3weicxADpKZWXpuxLbJpj01vvDM3zK/xs37+AQZHx+FZ6PM/6R1o4nw3mBBiQU1saBgQRhuDOiJhRTWpf+NsC7dfWF9iaZD3IJebIUvPv8k/o3ky0lY3nNBaXglv9fhtVa84maugsji88NDph7ude2giMiVF/if9OnfdJVMvn7yNn9FTblhZ7mynButs1y79GrsXrr8XuFzY1PtYXL0Iuw3oh4S8isKzKlVvMx9Oeir6V2P76eZT+RiJeZ8NLnol76i1/rdBpXF08e/+LLcFPL6bHgB6M6vkMj5gCdGYrJcGeftV+4dheNteJf1dnrVes+Nb1OchHJw9zZyFzq9lYn+wfySpSx6OWALy93ixKW03MnWg8cnWg2Ze68s/ewWX9irHgzqmueDB3jiK4Z88duyLT3cy5tEBaVnSmJHMPK7gsd4V4Ld4cdKPd65Bp29nZdlSXFr47hZX/NjpzyWNh8wK+RwK/O1b+irLaKYzDHW1yzoLc50IJfhEp+zdGuoWVK4VU5qDekkdag1ASjPJVCU8dZOlNSCp0UtpK1nQXxYdLeDUYue2Ke7aBgVOqoSW9u0wOWkZatDptVT382RqNnue3tX4LYTcO02cJuorBGTrfhiRQSKrN8FFhrr6L1GB/VuErWLehNcDeTwoXoNKVYFQXzOQgEV44NzPyqrI2zW863AFv4+xTthvcJwkD8BUNPVVZh+vA5nNXam8eSLSYmSv+64GeIhHxkfnDwVXY0hACeXpIaTWpE0dMsfaGh8LeCDkUY7vJbrmArqaicDgO4L3BfedRRM9GdmwJGRIyo5kIkDWXLAdTUqw2jCmLRiUHc10BxZFEvUIhuZ0DARXwNBgQqTgxn2lovfEWZSxSPo4dzLyWtfkNauwYin0k/JzwKImDSjbq7HeQWRYtugRYkoWEmCs30jqrgW5XxbSYxWFFXSsPFO9EED34rdigUENTOWk9EmGLVHbUiyPds7HkeWa1HOLUpfSweUKybrsUlDcmUyaddMWtGyZrKVUROBgJCnin2SdL6lpJ75EPFMoDMhVK4nLaxN9MAlBzk/A5bQYtkB7rqV6TcHqZyt9V+2pf+mwzl1Traj/6Q29p/z2Dl2Koy2noeLcJMhOc6GA4aGbdIdj1IeiRaJiz+kUKME1mD9A/iHfA6jTqMZKvtQQcU5D21umOGGZWzMobOQ4XqLehR1mtV2TqNYS1o5+ppq7x30T7X1GvqgLOrNQrrK0gsZBsEy+gPb6tALTmg/bOZ+N1KMhj03D8gsnga5/eL3UIkB6C0cofCkiKetLsfrBZrnHhTQeA8D2BNmsspzu45Ni9l0yOL+oMrbC2mnENb03mBVLwYlhx38cv211HN4k7wvh5yKPZ3NL/uKDg94Z6Re3FUES4X5kaqgi1ddjqCWs4e+8hlEr0bHc7G+Gs8a6JFl34SK3qEq3rTQUHezMOvOUO5dGPU9scE52ZyxXrGBXI+qULzNRiuJEhzyLfdQjTTFZIOnG64tKEqKsYcUtee2srzO4pzMrjVd7WfiWIU3F+vg1IX11pImYQ5Hqs4ZdQXIYE4gBfhdS8DbZ3QlhDTGxzws//iqkLtzX8l4q/HV8uFHhS6Ql04hafAPrZddlcIVR9A7Q7YZ26pvgG1DqPaOcGWlblDIvuL9kWZ+pTdduBRDDeKfGBO8Q+ewu87Pkc5z8CIycCTjNF30bUBCyRS2N2Aak/HJTs3gFOY86EPPmnjqMYOXM9/y+QbaznwtfzOKLrikL6iVpUyW1bI3+6S7pIDoovKFt/jQryRmDnMq92mHuVa9L/kpTxGSAxihdL0nkypK41/f4TJAdECOYTA1HBrHLxklfju4MAtexWRyHfkphhtJpoobXlhvWMRkKhjQFglc0JeSBJ7LT+r/eV7i6Eid1zeZC+q87N1l/6pkHsYwy4GhIfuGAFKYcgsuwTtQoyk3/MEeruylQnqPG6H3RGuvRG+q6ykpZS9hcC9QyTliJqYKEpX/RAN1xkGvhn/TgE4fnujsU2jCp0+jIdPwa9Pr5zCdOyrLY1n7lO9FChWd0qT98OOQ5odPPvyx/LDNV2QP37+fHb4rDSf659bDk55uctzktx7eK/fu8AM7rGiWVjQqbVVopWLrn867lnw7f64XB5FFjiRntm4c/lQzPykVZXX4gWSga3gpYklf4ZlLXU5EdYwGBqAUyuOHInzsOxDh9TsjrBFhfZwIa0TYfCBm8g+U4e2bG7+J01hJOihs8bjooJ+HxJhLYjR4j765mbquxlV9c09Kch+gdXgqPz9Acz/f54wZLqohI3N0x9nzrxpjwSsahRQOqbmE9moYljSrEIIL/HOCFOIHPK2Oksi0geZdF5gTFL+43zvoFjIF7A05zYPxz9HtvbI7SdenkF8oEwF51ewk/8m+6ub+FAIEpkjl2XF7mVQafwop7w139Gx72tpxp9oNnWqQtuaKpK0/5U9+0CzHjIxe9PoDXulP3eqbS1SlBoM4T/pTT8nP9aekp/YI5UW3dzTG59ivEExYaRKAlUCfAJQxYXy1guPBZeN4igeL2TpYZhgsby+uGCzmigyWNVzPMq71JarCrLiC6905tk5gIGFgMf57MsxO7Av66L48/vCSBE7guRWKfH0DpdCTbqFfuN1yM/cknGjYqeES7Rrn6Fa40hXwJPhkwhpmeNEhS5QdrT7yQo1eUU1WW+XgmXjkYjlWKATnmxu+aXjSK3rzSvGlQfso1Bu4YeAGOTFaj+ZwI0LdwA3cwSnmQb3hxQ2N89BKXs2R1lr2Y+VjM+N+qMqrC/gpitrAmtGaXIw4M2ELsFmTrQBdSSdpxmXI94KcgojB0i0NtDfh+Q2X+MhDqRIBDfFtclJrSCepm5BmXAJFYllKxbbtNaqFbWFJfFj2Lj2U6CYO0F20jIoiqhJb27TA56Rlq0NmzXlzJGu2O9/eFbztBF67DV4jyrhgTJuJiNBmu9BC4yJ6X6CL+nISdhn1JrwM5PCh+gJSrAqC+JyFAirGh5QpKlMRN+35dgU30xtRzK3ggPiTbEtTI1pJvzjXF8GwOTLtC0GdjiRIizDTvI3CT1gH21nNHLrAIOjy83mn4o+VQbrxCIsUVvhjemHDCdKtSI/ksqdULm4xK6zjZAeb9pKqyANw8UIrlJ1CIYg0+JuTkBtybr2ZStcjKv0PhEr/6z1dXijOqS10+vVCp79A6PSXbaHT9ZROR7O+vp9mdglf7tlPZz69eYxm0oe+2iLK+SNJ8FDON8/u7T4kM9x4XDNRK2KQXhGTpm2Q7hswUs/ua7STysy3Hrcg06VkIQaTJtQuxKBIHtu5FUXirVSK4FjHYpcOu80Zyzy6iKy7bXe7fWYbpmcE08V2TM+sYSrtBEHC1LKjlwVSUEuK4X0/A/d3pNeJR3PUU0AkOIeYqKJSlDk0gU7RktBqvBO0NtHndjt9rhJ9XqCZxGA5IvlN6og/Jz1I4il/DruMOoZyaIihbEka/LkkfHr8Kpgpsev8uXgQUcyOPCgCgS7DB6PQisWM2YSRyUxMUYsMNo5FoP/hhEBXVw/XC4FOWtcI9E2pUo9yvYijtNicUZm0H6VVm9RwVdQERpw1SaB2pG6P6y2rkOsqDo1qTUxGjUDUShOxinpUcFXUBFI8zTJ2qknClFZlHDjlZoMLaZ8MOjEog8UeWfBOagUUSee9NCgWYeJrRUzyfrE/EmwFCWQ+tLNtoc65RjJGqHMqXO+SSc/V23ou9Ey2reekKmjaTJxTHyYVyFROK7H1bK63a8Q5SkK+YRBMmXOkttTsos6ROBBaoc6BkWDetRrFTmAEZlP1fcsGJuqwmm3gzq9P3DlkGAcL+Ldw53+0izv/Y1TKbMSUn8+lKHLnReDOCxSUE+5clnW028Kd/3KlK/xNx038uV7hz/UV48/11eh/LjZXL8kbdAsYUKkQ/lxuAPqUP0e59NFO/jzZqLbZkN500SN0+G4CHVJ9w41lYZ2FpBgz6HBtC4OemsO2kJ4wuo1Br4VBt+ivCYPOVtNWiil0GI3j3K5T6JhcMBE9O1HoIxSEQl+Htx5T6MJWV4mcFgp95qcdKs2B9JhC3wR5M4J8PthtHLoKWJQylznylCwyk1QlrwrKg1rM9JzqzZhFhy5fdBVPfNQaEnDWUk70hcwaEGj8DD7XHl0k60iZ2PJGOhxjEvOrzKMoDbI5ylCVHZB6DJ0qsuXVJH1mAkQzzZwZYhhlDrxZzZzZJHOKgJ0Sulyt0OX/NK/zcxp/5W+NNIcazdRomG7zwa6R5lZIc4FnjTW3Cbh12hwwKVSu0ebowAr3ghlYHXxB3ZQ2x+QptPnfVUKbnxbKnD5OQ8Zto83bDbTZDCSzE9p8nRoj6jlDsh+ePfyAfg6SbBZIMrrJcSMkWUskWUvOLbBpm20myWjwgyQT75zHyjzbRpIJ68WS3jJPffxwZACI4xsMIJiNHOAxwnvZzvCEWz1GeHIk4EDqNZHUc8TgIZGVJILC/M1FtNiElDCSEg5Unru5c5He60lJ7gOu2EpfPCeM2t4+58pw0dC9S4T531aBMNcgzElNIswDV45/TnqXCHORRI7R1Lk3JcwXB90JmQUWkTB3GP2LV3an6Pp0IMydCAhhfioSvacRIDBFEs+P28VMmJ/u3MaENdzvc07Yetyj9YYeNUhYc0US1p/2pyKriwlUP3vIX/FKf/pW7y4dHSed8qdB7J6WnloQyifCeYOcOWCyXQhhngC0Av0RgFa4aLuC48Fl43haDh22jpT55pFyDFwxUswVGSnruALUeApx/Rqod+PAOolRhFHF4C9kjJ3cD9DvRbZcM1t+cqYSR927xJY3gS137NTw6cRqFc8Yz/9Tn9KBTiNsefJijS3XgS2HZ+KRk3JhyxGcd1O23KG9CCW2XNwwK8tQOix0kS23I7b8+sSWS6sJWw4lgS1/W6UV0Wd6C2OuJ4w5tGpSB3YSXwWtp0yZQ6H2BX0JZc7mvUqiti8Q07N7LQ9cuPG4ZiZWxCC9IiZNyyDdG/Caz+7VmBcrPW5hNhFj4pyoEumFWBTRY3u3okjclUoRHOtY7NJhtzljj/y2G/y2u/0+sw3VM4LqYjuqZ9ZQ1WNmrIQa+r4slIJaUgzv+8pXIi16C/HIop4CIkELMVGFUgXqvBKdoiXBZXwxhWsCO3yLLXSyG1k1mNNRdZ1US2+K6hDQcCbQTUQiYzfLG6chbuBqCVLw4A14M6bI7RKjYIUiL3iICkWupaG8l2oDRV7AsMPK7YQir6lKKPIGQo2vO/Xf7P0LoGRXVSeM13nWqTpVt859V9+63b3O6U7SedJASDohkC5sMDEgGf86MvM5M9EEh+92wySIfIwE0iEBGgjaYtQkRFJdFzUqaBDEi7waRI0K2iqPqMwYMWAU1ICoQRP4r99ae5996nG7Ow+UGenk1tln7332Y+2111577bXXQqTqmo6JyG/wfO86/5XjJgWcladneEIVslvUxql6mqpZE7LX5TW9sQ3U0tvTuOCeFGwQ62Y2/HCwCGF4Vhw9acwrX/F0P0kr5gJIXYRNtIB8vXHhV02pfFgNWPnWlMo1Y62v2dbveLWWnf2lERpoAXltx2vUdiwG6x4xGpvdjxgQt9MDMUB0rs9Ls4yda4lp/LVqLNXLpHiGnlHxf781MAjLDmppZcR0pfqwgFHDOwbZTfjWGBO5JZHMVW8BpNnLd/5kfZD9+BvNbQENqb092MRLX+P54sDH2e+rWjvsyJ3Ftif29lqvKTxQ+r6Y4uyk7Oom99UOH1Y1bKvwDiOqsFyuK5Ne4dBPyLN2z+D4DSwjvOUoKr3TC9R9F3wxeNqYUTOwtyairjTeA/FXqVdBNAN5ztYceQ4aeK9AQ77jrz5bx1eaD7Cu5HXBdcBdPkrVvK0P2/bpV70ATfaO7+DDtQZ1qCMXXyASomqfewwvcLg4k/2dvdaRBzbXUWsxv7QduO+P09951j///NrTh/te8BNLv/abv/HAB9gs4Pee9a233NH+7otLC4F3wZWHMzZ4zyvf8/u/f8YvPG2476yvveK3D73tKTA2eMuNFz/5wQ++E8Gr/vFj7/mP/20Xvv//vfLKufSnfgxBBwJ1MBI4Q3/D9PWRH/LKTV72owBpEd4ma0URcsybJSY6kscADqDyVaC2jI8mWnsFFGo1+AfnOiCUt8ECZbSex6phF6/nUaqlfBCWcpQ/GHEDkyBwMLysaABFj8ltGkbVX8ez9Cf5+v9190GY8OjfxfFIv7dM7x/+CAf7D+CXc37h3W9GYc0eZzoqKYPfQApHNNMqfnnDde6v/icrwq4hfmkgj64+Mn0k+qgNyH3R5LxDakpWPDJ9JPqojQyBCxrYaV/RMPT1NzfpK+LRV3lqX39L+orf8b5KyuDusq+AvniEuY1Hlh59T7Wv+KaJbx5hl+9hP1kwRJ/HKcW3CXuw74Vvfsbln2p/hl1ceXesp7d5XnBtZZoMh4yr137i9//zhX/8Wcb5z99+5us/99n/zBNFJsMrvvqO7/6Lrb/FM+gT3/shtrF5Bgxr/syDMLJ5PXu3UWOfznZmRAGw9FK1k895xYGBWgZyRjIFlY9wc45QZPNePBwcSd+Eto2SgcJ33xXBkSJ0yWKTs3SMd3jxd7l9/8wt/f/+w4eWDnzoP6Klz5bCf5rnIPJIjyW07+N7Dn3gr/75zvezh5d3vOv9b/nbHDP77d9x+8HnvvJN3Hc0nDGWTbymP9cUHyoRfKgc3z1R6U9rYEgXT8L7YJWp0iOlapz59iJg71pVM6/qfwvQMi/n732+mEl7yOctRv/uu40XmJIu3n5DqNbgdBWxtKEMHKwQIe6PC9/+vVhURs3HGg9hB9/zzC1Le6/KfXJvgyK04aMDBjkMYPDDxektxrI22ntlpTUUrLPTwbe89UPf8h/+evEZA35lBw11POCZ4buf/Q8/ePVDO56BnHcmN/TZo4K4sUge/ntOXXn3669/0hFC6sH/9/23S6pJOfX+4lfuypBy1888fKSScv+Rn37nh677xz5sqV/TvbWScvHf/9E/dF/yCaQcfvffvrqScsZ/e8/LW7/wdqTce801/28l5ZaP/pevvPTBVyCl9vLt+yopz/7ywcv/6ovPlJT3HVuspHz+ta/d/ox3x5Jy8C//bK9LCe95XvK2135wrwBm4S2VlO946vtefsV/XtOUg5dXUqLT/nH7j7XDvRWfE3kiS/I+mzTcZz8fiIMPUwi/FRaaX9q0dqRMbzFSpvcSKdMhg5Tp0ETK9BFAyvRRQ8r0kUbKdOxAyjSs0hSLhxY7BZqp2epAt6XisBLLqxq2pdLvnrET7NBb7fqOOjC5XS35VrikbO/wIfUP+0I2l+xyHykvwQ5z5wNSecSZAKqXqasLtuMfUP66FVTjsy+aWJ9jb5uW3ZvMfltec9eIhXDXhkNmH6h+G0zg34YVJKS6a2v2M7o5UevXZvZ39w7FWSZb1x2me8Vj+9m1W76EXYsnXnRhk0HfD/0J/2ZfFh2APpwpIJUfHPmTEpmmvx74yXXxtX3ZIGCnc6hLNVjwOtglzvvW2NzlZvEIYshHHO+4kJFfJMtDqbEseaN8s8CiFjx5ixjhyfe9Yzx5z1bHE+pNJWRw6AvCL7641jR67x3MPpgp9dy96wqFfQ/93Bf/8DnfdwWPd1OPCzW7UvnmOuLqHEfN24pUcUiP0GOJpOYg+2GUg6hIopwxaM0OPlrTQ6SnahX5NubJ8UB8UzPmbRy+lpXnTRcUsZ98Tc2qj52ZfRdctuPsudc/+IPkglf2pFBqDXFcRekwFw9t0PkCWLGdtXLYRoW/apjL+Sz1liy19Lzptjr7h4AF5xl3ctk/aqw7Lj7b80qbrh5+asZTjqoiemKudL8xn5D+Vxj3FGQbjCGbvi8opmQPKs4ClzIe7sO/cxBtMLvr25GVVCmg8NA0NT2bps/z/Cl9qGWvepUp7kKxB/k2U1x2A+KxqSPpoa99vBGxox7ZXLvvHG033jdv9z0j7X7rpu12xd81WjzeNy/+yyPFv+0kit8YK37juFD/3Wrx7zqJ4o+OFo/3zYt/20jx7zuJ4u8eLR7vmxd/90jxH9m0+DNrBiEPv2qkcH0/hu+yrxlC98aAd/HweOlIj9jBN0KqInC0xzO051um0B4IsjBJozUKlaBoxFEfEb9QiaivlYtZEZmvmmtV2++OsiB/i/NTaKiUeLfT9ApDGTqS5YiT7mVNBZ21fbu9X1z8x6ffjwoo1GyaS/J4FUKiErDC58aDkDjAhKBvApgAyXcvc9PcsmnyPW/vemH20iiYS5ld0+22RoSVmkLI9UDWDilVG5mVo4OH980x474RzHgrsp5oVo4Wj/fNiz/40ZFZuWnxL/PlJF7n5VgF+n60NlIDllQx/ny7qYGmnHczd56iGYQnmeduM4VR6sh8Ha0W75v3a2OkX+87CbDdPVo83jcv/uMjxX/kJIo/Nlo83jcv/oGR4j96EsXfM1o83jcv/qaPVYv/+EkUf+9o8XjfvPg7R4r/9EkUf/9o8XjfvPiPjBR/30kU/8Bo8XjfvPh7R4r/wqbFByxo/s8jbEhYseH7SzD1lb3OiKzVPDmbdoaBXpAgWcBV5cjLrldfFBRWfbsHxs2XOidLz3BGZ5JZEVlLxlyijXn3V6n0+2Wb8EZv/dFXVXijw9dr7C0jsT9qYm+cmvfBw9XYNyH2UXNXX8/cm7KHGyPdunm8Axd6/mglvlbiZ18Bl6UJmqp3SLwT1njvSI0/cfI1/sb1J6gxq/W/wIVjB3YL8qZnchPkg9xXJK3Z02c/+6mb0LKbPPvxH3iO+dztDmpqsinZ5T+AgnWzSPz6ZbyqOqq6ncPKizw4yXKe+ITI44xdLWyBld9tERq+yJLsjdcrzvoMDPLYQ3+2oejOp239X30dTxlJym67XmN3rmnSr8HufvZmidX47FPyIRr0w3qAtFuTMKHeJe0BThgD2Kf7vBhBrK8PsdKVnmM9Er5D93tldt9k9zW7r9lv80f49XinBmviSVEnxkN4CNAU7KJQGlNNy9PpQ3H2U9oP7HNUSQ6O4lKdc+ShSaJc6GdvQcaWt2kSxc/wJwuOsZmtyTeIvEOQo1/DQf9hxGmTzby/HQ9jaQuNVV2Th1MuADlQwAAFWEWcCM2NRNkidmh8o+cF08yDm3tVwH9x9GLOALt6IrjADww3013FNAqBYoEdL7BQattcjWofUazgG1l5UBpOcya203djhFCO835ThNBaMA7IpTUUshFjjntO23YbBoEpUmtsyAGtDcSsFUahNRTWMLDKklbhQ1tn/Xuq9qdxKKLiUzi2CGwFgVagW21k4XD2BzcYK9RyAqV+Q1zjrREQMjf0RB4MdY4H+Vm/tJf9i6VK3MJS/7ba1M3aGEgDsoOo/vEfPVd3dfSGJxi91zzOrVA8lnZk1Xasn6AdPwcfSVN84kvtoBL2YpxcFAshmIjc8MlgxBgKuWPICIAhhNoQ/5VDGNghpFDP5N9ySDY1etsyNugfCQhBkyLU6qqOudj9gqYGvWKLXqiVq/fxRUuvNkqhdemkWtmx5h4oZpiiEqlB4YAH0rI70KAVQUO1b+JVvQLcjtR/I1DdeUMVVIpr/6ag+rkbNgWVm2O/cPKgCkdA5W0CqmAcVLImj4LqjpuqoDITQoGV/RsBa3DT8YB1BKlwZqbMKskKLSuepysejNZfENyFxPSGpCHH/bwv9V7Bv/JnQHwXk96GtZRebsvFdye+xQXA4RG9NOjzBtyjBhxRDPgJ2nKLh5oP5Ko1mwAWDSyq/IAFdtyQy34GzRF3VmnpuSzttw4UNXnF7kFdjGGxxSrrVt3CV1Pv+EugAWkWcGgGcQ23ePBoFVM9+1nUgVaK9hEurHQhWU6AHcm0coE89hpPS0YUj7AwyxjWhprMmXfv8dXAF0rVWzlmcWhY/3cPfQ0ycUCkJSbHdBcAMtroH/TWtM3aXFBdafCdyMIZpuz02w+n4dVcGJ5XmOfl5qnnEWnV1qf3LfKYUZ2keiWBxep5hzuTmRzcJy1lt3mSeWbmWdOMsHzhi+GgOiTzxRylNAd7afN886x/NSstyB0Ari0WkXa8hmOIMxiIC1IA6eO/9ooFAK/hMtDCmxCjuCGxC/rhDM3Qwn/pIVEuNsdWgO0ja+5zSzIYTEnUfNkZ/t58Bg9urKgNUEvGjTqU4u9SmH3o771mTVoYU7xp4xbIVJ3PoGYgzSy3Mp81uEMta7RoZo8P+M3yV+i5gmqBi1+QHnINb8oXxlrfAfx4DLL+QVrLM/Jo4b2Qrc3ldZpHuXr97iDPKAOVnFENjXYw8uUGrC89+C9QldVG+9riam0RZmbGD4D0vXKHkKe3Xa2/1/eZBuAgR3h34djVwY3urR2LVAR65uKt5aoIaa+DVPgkvSSDWpWP42f6G3Hiy0WU4NpInp7VUju6bLcBGN9DcN0uzI87HPOyd4jTmjqrV+SJEsoG8iTQjcYDbPQucUgoN2qyu5Afls0uEUCswh8Gv7FOM/EFmufxZu8h9EiYb+pQ50CRZQ8jJp+F+jm6PYtaOAebxs89PWsC5Bjh54ZiYap8G6DrZh/i4eFRBv4+M8jROIDLcPAeg4JLczHUwa0eD+16dlHbf4Chaqh0TfSaPerwkxFkBg/gVRaIDpltXTFP3Pp5AsSsy76O1E41INQMGjEjjQAuUMN0katkPk2K6Hu6ZNV08y839LKvIpft/2zFFJg8Zk/3w3wB8Rw43w+Bt3jE4CPft8xVvW9ZZR3O42QKT9Fz1GRgDSkxEuHT9/IZ5pxYyOPGBqhuXmuFgugMRXmHwT5PM4pu3MY5da6IMVZVHEDebj8QmyeiedmRAfMwYPgoZHDIJ8nw3UJiGEIAkwijWENVKXYHExzA5hqYfGikYNwc8bzH8gsoas8oBlaBXRYUyr6m2MSADTlyFYkuZ73/kRp8HgBHq7F7XOSbykhyke/USJ4gdvs/lx5rpCzBkTtdIT8xpQKs2dc6lr+umWViFAl3uqLaxd2RqCOVMQByGncM+KGiub+f6a1TD7biKDC34fAlAslwOMQJgVnIdD42jfj35htKGSGoyPvkXejKRyR425TTZCMpRnqKE1ewDCqOHSvto660j0vwzZuVpp+mfamf2AGXgWXtWynln2vy1r43/s2vDP7pNw8/HcpT5QvfWGwLAyIrYh3sStJHtWIoENzg21ESGAMgHWYySqUZ5VIMHIuOgSTA2KEmGIo8A4chReWzbiGec8HEBed1wV7AJ9KFfLGSOPWTOW4vGiiDtoDbrgUGr20Hb4mWysFb1MGrNAjwNlUViwgeleDys4ouqE3epEWZjk0pjDogfph9VqUas4d7vYxpU3ohjbgd3QNr+ZaSdqGwLZSZq6DvzlcopozSAzBjVK2Di5c6aOVmnrGoJZyohTJMVS6rnKpZsVTxAg/077Gn+1UC3q7yyCYynzmCqbZEzNE89WhpOGDKs4DSFqrTQPYQmS7xs3mHmz8LyBwTyHSfVSwKZDocmwDW3WfhHVRoCdHSkQ4tKfR7VxbLvbyD2ogDHGs+MgDzQekyjtswPRhcNKQOvuTWFfP81fwRfqAn81f21jEV3TEZQgFr4zydsyYUPB9XckuM/t42aGAAN+QYmEURbYRoqLKvaqVKOzFr2kP8iWr6L6lGf8JDDZWVduVQMaCE2+EA7oJX9oZF4uaXC17Fs6slg+UEBb9Sj7H/wF/FLdrBwBGyev/L/pq5dJP9qkzkgAdX3oc5d1hsifJiugEq5GxCqn+bIn2WXq8V01cc37bHl8QpvjQn4KVZXdfUQVsGns78W/iJrh/Gs8GaK3h6rNDCzwneHJvCO5FBmss6LRIGj09hOUDZ398gPQK7L0xBnTcdXuHjebuHpqr4MNLOyQAp51m22WF73sQDopy6rH3aSC7d7DH8VLuB5vbv9/kSsbZHN11ieDNvaRselBZ8WXdUsv62cZWKOE9ILZE7tJRB8AFC6EY1qAVD5dmXpUcorGjpdX3m/rS0osHZVbRg9VHamGVtU2UDBev8qoOBPOZPg2sxw5C9B1y+p1CVZcyMSktHo9JQDJMCmBeCDTiolnG4F2NyQILHcLWE3RS/gOrYZF/BD67Cv1oTke8qHffLqQ5rDZfogwGlqObDGVqd+LGHH8CdC2vPU9BKEXtQs5f9gwAmFKjfW2M1Gh36M7kvSonu9fMQTUcX9HMdOEfTodgsTVFUbKLT+jxkUPJGfSoQPMU9i3WQIWT/hFqnoovcv9dZnpSXj4aY7waHx9uFcKDTdnPVISwh7qTma06t5rifYYmdPClzn/2174XT3HzqZLcbEyuqhrRXBdPmuCdUGfBlJi7iLC8xTkr6NXVirorPECmrMy9UwDJQX71B/iC2PchgpEQBRz5kpESRMJLZgyJQCyHhCTavJdRa0CY1aKw/kFgV3v48spuuCPmsMB1FYit1up+cb/KDfRVzeihR/fDhPFUfoTyQln3lBuOiEw2yDrU9LLd6tFQVG/2lytje7wehEGQHP22hOwMw1tQkpohQNHkwyIaWm+ungZpu0QuniRpuicVqCOa7FI0xolAgBRafs8Tma1mh6pVDArWzojvK2Ij9SXeiE6cA3ianAAnwAtXxXykXTaacAhSJbnFD16CJroRoUOga5ESU3+YwnErXnhRAQNblB3bh6lgzMbKfANjzS9frziwoF0by0h/xQyOas+z9YLlEfkclAh0RUvt2O3HPtpoKYIKRiOXSTMxsTyDHUDCwp4uJ399YwgIb6L45V7knIDy5BxePipejxOdlv4wYEVlGusW5fZm/vN1u/yR+TzX6TWU0VaN1o6NeNYHEqN0WwV22AAnS+zz2n6tOgcHJ7rvkl95325c+9UNP3/exj+LfAxdnr77Bas1gyy5CuOz8YA9JzG6qlccghLDQC+y3FFEsQsMRmmCmoD0j7QEcY/EwX4JJBzez6rH+wBryPlsdA2ZFHSyESG5xvvcDa9YkpBqkKY9JLncdoHCjwrD2WBf1eVRLPxIG2N9VT5Yje/5r1r6a8Kl5jAfldcTuyROR36A3U5mTLgi9499A6GXLCTZ3Q2RD/a6wWe4+QNgz/BY3AkkRnAtj45192iBKJF+JpLok3IBO9r8QMp4WCwHl7sIYSiSVvOkVcOKLIr5V/iIwPlY1rEuxFJ69CmMqlAAFKcpGmEGrnM6PBYqwOWzJI9glbcJRVheh0/0uJM6I2wXkKkPk1Kyd6rcJ7Ny77wv/YWPbqz//BxdTlN2ghEWE9uq0Misa2pWumvLJfWvw8XBQhCL05w0YdLOx4MKeXKj6vTgZhgZuF2wRFjg8jwxLHbn1AcSZZnqip9iAy0XzuH9LwDhoBBOujwqiGwVEUUVRIH29j6uglnAcq43QIvLALg8LLnsXBvSBRTH0Im5eg+nYo8m7KQCQL6EA3su5AfskdDdm/14EBRv2IPRwzd/DHyYIC8TPrUCcQsYzQPg/bPwj3yeahLuSxT99g+H2Kffx6OZ6QznH4csx58WVC7vwpt2f+eH/+YNPh7bjmf/vW08/s3cFh70NviD0CNVeBh6koa+c1OvwlWLji+xXlPapLkz2bnOqEoisTOIogKAMhEJoPfeYpSFIUAhKbni+Du7W0wcALOgywI7hXe3vnsVVnmU1bJwaSPrhRtMuDLO6b7q2Otb1ikdl1JVVBbuBiVT8rwqGGKfkNEdnLRWxyjLUxZgjHLL6vSvi/Qs/j/Kzyc+P8jPl5531NTGL8UC4Bn9tbQ5+gbc6Mzhu52eHnzf7a3nGzwE/Z/l5iJ9z/DzmwT5XPs/Be7i0BZkFWG0XUS7HLGkmRC1z8HAkVXSRP2QhA9Y50Z71KHY7RQRxC0q7uHJBsFHHCna0nvdQRuB2CSgRHzO9phVNyzZkzVvN3oOndotWs1/DW+X7j8j3WxTUW6ZOHyA824w95lGI6m+Piq0sw/Jo2VWP9EyT74xoK6jjRr1YcfdIeyB1i+4D1K4gEVBxo30eQSg6oIx72NIGlu33atPLg0s0Qb8FRsyTZMdcex8yrkjiRn0NdSHYESHnnGaDqPP9mq2mNWcf0OIhIP1oHYhQd6tANiWuMyVuZiJOTSY4ewxiUnGFexir2a7hsNg2hOA9UzDlK+jyvUHOYAMRzrcj/v4wJ0x67tB12LZumGvSuZZPtE19ZAyHlO+74e7ffuHu/3bfxZWbmkS0nbbi77LeRnljzmb49r0D4iZV8qOFAye/GXKEXDPlfLinyM0lg1cftLBun8etNZFHDTh6lbg3mbhWJe5DJm6hjHOgTKfENStxHzZxjSlxS1O+7U6JW51sn848jo90GmleyMaxZtVlzQLC1N369PQqTbbnTKogOE1Tb/RsKk0vln2Ibhf/TGap+yosaipI8cyJEDM7ejSDdGlM+r89UcWe0EQjuY9/qNRlXdAaW2LsmXzjNBk/YsmFggOFPVr/CXw1VT+7/nAKHpTw3GWeXdUw4x5h9aQAqK2iGZ1dwgtiEfhOaNOKw/8N2REqJAa+kvFb+Jn95CEDbQfef4n8tLr8jyhLMPNekpXv1U0xGHiqmZ4bg+C+bPMElKrBWIOpx4gCxOMEZDtrT/wAc5CXGGjH4hObImWpPRxi3KIaMNEmX367YIYq+VNohI9QKorxwDrvKVMHXguEAECXklUQr1qIezTXbvLssfuDH7wOXyGjbNj8vVUFDRFz4QaZfr5TPvdXwcKJCKtoGvPb6mkcJKhscZFKb7WbLe10wg9FMO2vuFDGqSM4vezTYM7UTGYsDSAuPpgsF7DQc7A41XK7OkG+U93cx/wXoWbEdZ3sgEHyUooOoN1KtwFAqq9xNWLOVA9o6gKAPJDRz9vAYHBTnrRRHMpLk9EnhBawPAj8KBSHbC0KqK7QRz9vRT/zFuq6BCfRdRi3ojaT0roezKHHsqWPRAtH+qGyPltRoiV9RcaxgVyN6iChLvtBAmYfX2VHAUz1T63DqySIMzl+MB0GXmNSXFSZ2gFkiavgyynQWR7ILO/r5Z6aojsnWh/o6n427qssIEDCagG5R11FF+pUTXhKmJJfVU953FOMr/cDTMbyphba4tjAbiECK6wWsiTHyoIfLJhGjzIQrIY9U5Eg9Gmvw5UQn5rOGgxM/WRH0DUpG1bJPEWlCOW0+uIJag1LYe2S3hrVnRn5akctyKUQLaGV86sq+A5R/lgnQGjN9kaJYt+/FAIb03YlthSoc/CKjZsg/XTMhjaa1ympO+ZVzrSq2wSczf34J0+9Pz1nls/mCla+vVumGqSblWuScDNVy94nONlUwng5uatEG3yYElNzMCjYuOY9nu5UhkU8aqMDTDe2F1zFkKREoJQpNRSegT/GFm5oCkq5ES9f+MVv/fMfupn54qaRjOly1pTblhvruaD+Pp0qe/I2HmflM3hQ3lHpXobHQj7bHz0PZGtC88FeFxHiCIrmIFZcWCsWxXeaqkldh/Gex4iKlcGMFpiBHvlQBqiDw3r+bE1pBZgqAIJmyL0M7qB25ZVaI2kD8jfWB/wSXdX2aFHFjDDPiv0Zxh0iPv4pKXkI+zLzDIkcp1fhgId3Dng3R55RsTI0Dgojo5LvMRDe7CkMD3kKxGsViFcrEJ+nQLxqHIjNxx2I8eMBxuEjheN3VuDYBBybo3BUh7LAcUHMX2yGLd4Vxo4FOFpzu8KSpYHMeLq4CMtI1RBIGT537/qbHwoKoerxhlyfDiGj2IO5g/U/pFCkfru5fJ/DZ62pMD3739jMF3VUiVhxqmdUUhBDazIZNEY2lwsa0w/WTGRT2IA8FWYsb1nHtupeVLzxOE/VGEZGHZyAz4CujWi/8UDOgJUbunuIM1itZkbvObprBSqGxz5WmbYWfx8foLDUCBhLhzljf200ix6Lm5wd15qsX1OsdT40qMP5WqISg4kwpyLEDdWM6Sd5XfXrhGyr5TaPfB4jAYRi2nCQvV8ol6deTmfWyJO77thk1213YxlGVZ/tAJGkVurQHPgJIFunLaoIHbgQQ1vgoognYIcbIwXDcCcei5xpSS27VQBNC1zJEtfXkfYC1evUvtqaip6RhuaebU6dUjSuPCggPvlGXlviXieyWOrx8JG/rtbefGDFEjqzRB1MGgBKBq2LGE4vFmyfFgVicIkkvJaFeP8VavccWlcQ7NWtbkddTm5mGA7kl0MxzKHq9DI02q/IRroqcPCUUVCb1mBglmleuqqYluEMtM0RlW+rguChyV14quAkTZkRaFHXlQSCkGCMUm5Fx6znozdyl12wiy5e1pYh9CCaWYI24wHhj+uVbIJifl4tRM4+/bKFNoX715P+8upqRZmUbqxLs2lZzYqpQhUr8fQGDLIueQMASVlDM251aQImqpK7Rcpo+YiWMou0WS6nO8hFDvGsfAaDAJnRjFie1h1uohPtsNvfLoCClDFgIQlUpoxhiui2S7+ZRi2RpAX89w1DMf/ssVLMb1LMhSrF1OyWYC6ME8zC23f2t6x+/jPnrVwstmK8sm9HPzgcVrq5iCq87G/1xhv5MOSVLxr9L2GoUYM/POkCPVegaGpJgRxlKfci+ULfhzwr+PfrQseXAQud/1sm6fgyV7KlQse7j5SOb9mEjm+ZpONb0JktE3R8i9LxZdun7uNDxxen0fGFTej44uNGxxceER1fdMGFcTq+hWZpeYKOL0zS8cVHRccXJ+n4Ii2Aji+cgI53KaPFcTq+8HWl4298PK+/Qa+Dw1726TfYy26QxOVeeQvuf5UJuSfb5LFbcL/te+E0fReCEH/N6ruoCET3QW/z5PKyGpa+y5M7DtlACtMMg2qGt45kULMkvjVM0r/ZgzRBDyQDaETp1aLQfcFfw2J4/3IMmDTrvtpYsyT2nvHY/u7RqhaqNXU3rcjWsjCtkmQi0skLvpGuxS/W+pAEyLEdpAUIrKfP5DKwxphrX3JlnV/1Cb1RCeiF9NRdVSLPKGr9piS80AsmBVcVHSeRGfVfUp4nh2oDoXL2DjiH/e8xAxqwl74iwItDT6dW9fpGEl3nyy7Rkz+3W1wq9S+1Q/IQWdczxXsTPC0kQlDxFtk3VaDcWNJ1VtRoVSkFeovO3FXLEaW2LH3sQwAUmAKjQJiDDO7CQWFdbr7M8vOj/JybXoZZ2D3xlM7Vtz2lRlBxq14lIaPGks9LfL5gW5loK51MzviEKkDq+NSNtWYWUnUWkxiJnNaUJ7bLEHySslgqT4BSTZL9lowrdHmxRzoaYE7cITg9T4vgQWayu6VJDS3ofUuuYGqg4KklItP7JJN+ZLO8r1ppneaQptFWiY9mK3FvMnGZi1N1nFKJG2DUFmW/rYc6EpX9jpCBlqh51TVXsjZRWwJ05B+3monufOX6AVYRoPYS/EnOC/DnxZ09HqEZEUpoQcZjaHWw3DDMM/JDQ1rfWtRSjWsMm9F3572aQWLsUStLJBeMLHlXO0i+7DaLLeroS8tZHBYr2e/aE1/iNOMerkeL/F+XizfXUJYArhVx+2W/HrIGetHd9/3y73MXDx8K+tFa9lGUBolxF190K2zHSl/vsMzL1bEedZUDTAx/uojiIdzXiKFp9qK2b4gVWfXTICkCUFCHioci13ILGGqto+V222yoRJuWB/BcAVRvGnVjAz2ZnTLgoerutNcndPSmzYzpUwIze8nS91b6bM+bTvnwpQ9jKoHSuqpeqU6nI0LMqoTtzZ5Y8XjGP33qk/90wxd/7tajRgtCTFO4LY8JbNlLpRl/oJYz0Zd9/Iby7iiu3AXZfa+X8yzH8T148fpDAZjJFHTXeylrzQZUQ2tB2stMFJgrZ7X0d+txh/eaoLz+y3171/Zer+y1OeTcZJuZYD06GEDvDjunK0i05HB9tP9yaQL4WvLBqRhN7yj7K+VTcGSVAU46PWEFLcI96JhCuMWUYvoEHs7D59Cth/PoBiDNr009WQrV5mKe6v1jDrW0SXxiGmJPUdM25DOuxA5y3BhASLvBxDyW6yrYpunmJMZclNzqxurTXNti38uXaEGv2/5qCcihgzvNDoplWr69WOZJRl1nMX7w7ofnZRPDLZGlMsHOWhrtUZNb/HAtrMlkQ+FbaOXhz4kzXIl/+D4vXxE1tQKjorcn+RvOlYai0H1N7vXDXM49yEPyIi0zDryC8ROzCenkg2dSoRjVuU9zeU3yaifxMfbUOky41BboXVe55Rrgtp6EGKD2VqGz25iB4XwezRzA83vWBISBKa+jyr0PN3zdxWn/AumaX+Nu5it2Tq0IIlQ7nZoY29UaaEDNVhtQW/YYgTUjmUi0z59n8nuFFN/PUOlo6dpNfUEjpLbR4vXKbM+Mmaevq4CQacwq+bgYeQ1378Vyn3aVeohiRKvG9tC6axQefT9nYKrrnQWAqeBi3guUGVJPn0Age5OQ5lVMpy96H0gXGSNq15cUvSlvzt70ddlw/KXbcHSr+437T7Df+LF6Zi/TJIah882793IOTSU3yjrt+w5Rx7unnGDJ3oFKSgIsWzGTlort6zzSNpnpHauOQl5XOokzPCEI8OwIhxuGIFS+AFhAENoUbuC69kbewS0xtzhX78iVtGHe0IYFCshmOAaT4TPrRaRapPkiRcYYfwQKokf1VarRGeDg/XY2fggUGKMaXcVAUSerK9VYAQVMaEWpRs/Mqi71QDUalQnUG6Ma8/wN9QR7twApG4ZqbKEGkhcoGqUaNUM1FoRqxNzbRRx9jVKNRkk1GmvFilKNVdCKFVCN1QrVUI+ldvq2lWqkVaqxouXhJk9JNbpl/1YqVKNnr/L2xqlGz1GN3hSqsUJNoRor5oR/OtXoGarROxHV6E2jGqtmzBr6uhUQMo3ZOk41ttLqFKqxitZdo/AQqrGCRs5WJHSzNEdb3ys6krSqT7apP2cuIVKoZILxMI9GCARF6a9vKgRg6qAXXW//sYppvZvxwrpUeOi9V8So0T3Nieuxkqy75V+4wSrtYGzRFFVTahWgOE4p5oGLof2J3hP0ld6GzyRfrka9kMjlTaaTLbuVvb2MVKNMvn6ODHlYcoaOpS1DA8NgjaS6m/OlOSiIDANV+6ga8ttm7HPpfhqkT/e/2e8JM/m3SdP4uSwJXnhdUF6bOL9ymxCyidvP52fEJkrOr+5uw8ndLceP7G91DxxakWKIOOED6v3Dy9AFPUQcVTl+1stfFV3bqs1v3YumIDVQNYDxZ5PMJmP7fvb7SNeiKVzDBvNyuXNbwcumUYzvHySgoNJy2Tjp9QVMN9eclt4rbldiAt0BU1uuDLNockTS3gTvzmndA0VmdKJC1YkavWXSxFZKht42yV0v6VBzmM+6Hdic3sYU5q+Y50VWfUzP4NFhOblccSsXoSF11uUOXqnaxVi82wCsjnsJdSjQZcdUBTuP+P3283kJAkEI3HVQyqBC1zrADZPmU4jOLOqNjUU571is9McFO+IyVlwRViKpDjWqJRmTfNkWUTDBHgVKp+iC3WjKLeOObpuaiOlyzBEF1stGTcL1PXQCJV9yGy2Kor7cPsRtPeJHh5X28SAMFt8P1lfUIOlVOCVyTGD28FiZFUwWbrQm6dkfIFKPQuYEDULUvptCywzJ+x68J/yeKLUE0t8ikJbDJxDAmObxMb6T1hncXTDvNev75ODeYdHkMzH1yBfJyFNkXPJ2jgCVNo6oymzNMl+6P5WxzBM8wrwBzm52kLfsvdIGJfv73RfaO6WpXku6XLFF9zwSvacS+6Yyliqx79RYJh2GBjm5fuvIrenbgwA2oaeeFXoM3CICeco+r3JMtpe0lMd4HsJZuNzOWwWRwaWIEBT+LHckiJM+kG0OyeWVpDwfzMoQCfmLgSW40VXqJpcskUxBe3MFrhhxDSfBY3fRGCEJvgvCM1HlzQVV1JvI9ZYmaJ8IwgJqAlnUt6aoZ6p4IZAfHczs74RjjYEShOSkqMPlDfmI6RJeGFCmOB3hBFddnHynAhF31QVFQqPfWZcu6ut6pcknhEYOBtK3++ytpur4GB5dKHg/vLGAkR6x1pSMvls3LuofL1R92aD0IIOCoMNW/exB85lJ0IcWE97qvpxW0vSWuCJP2Fa9GRkqMzwsHDmCJvr3qoc+yfBmzRCMKNshQy19A5SjY7t6Zu7qEG6tlQ4QhwrMGK86rIlo0HJCSHU+qmxQg6EFowV4yOUnaExmt6NmucOfJ4ItmMicT9vWEEtCTpaT1ey1m+yPZK3/+yB263xoW/nAWV+Hq5HOtnuwzrk8YB3n8vTK5NQbknnkbk9OLPV1aYY0Sa7dQSI3KK8xDvMGlka9/Av1xCkSpjJOb1+CwaCJyJTst5eygx+0ukHxEKsQz671wcDcl/zCxUj09j1Z/n2e5Y9eS/a31mTNF3AB6QtnWcqJ+D3V6DeV0VSNVtqpt0InLnTqnVCNHL8RqpH2ex5Sdxf2ds/jIVfRRaBH+HnkjMSai1j9jKLsE2rvrWai9khmjdVtazXzJ6dl1lhw8mHVsNUYq6o6enKb4FqxnyXN0bvS5op0hdJq3ZU3GWglk3r3nHyZDMPsU0aai+R7a6VmfFXjFW1T76Dr6YEJBwWBbUeIh/JqwHWtLAe6h1Khon99mN2jyx2WFAi0MQ9QtWPiAlSWrfM4+KirVEHP8COGF4wNxhcBKqM+xNS16PoILapca2I+oIbyL+3x08cRv39A7fPK4VjNntQfIS7Dq1xaqxgcyf4e60z6E651rcLX9vmPY+Mebbve6PmQxJSiBpjQK5HQU9yk2pUjxImPWEO1QjuojDvq9stP/fLTIhKyBEtsSsWu0/vpE9/DM+WfRQE0nUpTmseWStpZ2kPMg9IiYh4Cs/Eq9iQRuBOBEWIauWAsvp+DkeTY0lrGMWAZU9HY0lrl7PovyBO1U20MMU+S1gbmDJi8/gP/YlysZX9aMZmR4AJtpOdDTS6tyeW6XiSub7CM1FDqVD09ldg9LvJNZSRJZERNSkC4yTuwgXssg2Fel6xKs9RPoXbIdb3O0dIxkI1UrnS6w0vVL0ERptuhu7vogKGiQGt309y+bpRCxI8uceCj9tBNrbdAz0cHTUpQS5cPSbBpLeIk1iKOPVJrGos4fT+fQVfaNKP+PFsTgErHoKRjiVEPYEGjYTizr7gNL7V77lo4iLbw8WAf9ag1MosxtoDSID0Cxen4eva/8SEcfTWB2RjYVJh+NSgEqB4rD5PqbItZLz9PXAHRi+z9muHM9QAecF0CzQZ/Lp4vg6k8NbvEUvmrqAap5cGgeqvBUZb/tHc4SF8VBLhjVk4zGruXm5CYE59+ZyziO2KZKhwS9Ao4uHMN0qFFdZuF9KOLJnDMBu61gQc40L/ef6q3sehkAnUjE9DL6wuQa8qS1rQemdVgZ6t6ZC4cHGKxPey3n9sOMAmye/XWDrWyP1cKpHyWqQEf4NmCiR5ciCHdsNVTpzIEB82cnLh7PmGfphm6j2Xh6rfUyr1oA/X/+A08/xFvrdzHEp99xrzE1p79z/mhqjd48FUG2dcuQPHuJqDoICQrhi4SgbvSUiP4aVmkAEoukU4WbB5wqSf+AYr55Iw3ws+85kLOBE0xMIh8qz5R3hpSY2XDsZnBRaNL4JA0BQG7jTjE3B4qeM8iDEfIXoBr9pReNG7dt/Qf//ItvxT84UVXAmyM1RdyTowutukMQLkzogaWimSIQocVVr6X/YViuNpdCgHusNpLB/Zadp/w1X/nedG1cv9lMffxPLoo18UYu8DtZG8C+PPIsIv/4jTdVKjn1swyYTxQK/t7TU9B6/KSdwQcNlx/+gA45qDoVhb+vttuxb/fvrjUmbxg72BIUTkzhxRX1VCHd6gyfDgsxGiPFAUnvYPq98P0v7Che3vWqtdL7UTxFY2BCrKjhHUehlfVVLzvzqadqR6wBmpZ51/Lmv/g0PHtsP/rWKX/2RuO34otevnuE3hhSB7+fePMyEu/5Ef16wJj/k2t78OzQO2Stppa4Rl2zDvAZd1fO4CzAJ6+suR6YlAIDyyD4q7RkDGUkbJB1V91CJF96aC5rShUZ0PfoeVA0/LNUMzxRWcyJYNeqTaudRuhPGAyr5JDyliVZQZ6yVRXvWTyJaNYJJ0TjY4OzWb/+AZpCaBtwm2al1NHLDuuQGrxHXdTh39Nb6gHlP3BdXKRSjtibtfN9Y++EmqUs4ibLbWT+ndxLK+fuNfUAL19CUXPRlL6R1HTN0YjIv6LORxeG+pUwFIyZTmSxWZ0whfekdxXqh9gdDA4u3lf1B/lBSHRf1Zen2qzsjEiK1WZlp2iR9ksSFV5tWWM0rVKpQ2bcw87FJtRQgsDrkp8wfwYjVtXxowLZi7YccFZYHRKHZZX82NmWL1Jxio1MEqR83KQL02/YeGCW1xwRZj4paK3P1+lxXwrLeTbplaeOY1raT5tA6uzRKuYeluBIds2htCGnmVko61Qt0Es9Glnuck0AwHzUr6NlkQnQXBlUc6xud09oMESo9ocTr3zZdrCoS6HuvycH+JQtMOYtcJvW/hUfCZH+gqj9SBfoR4KXL61NLME8HTta40domaY9LOw3EmzTGubFyhHksH6MWUc0+CLm4iZoU72RkwlV1YxI2YtZzhXcgFYmlaJZ06yq1Z6KXZJ5c3iviL8l6KwKSjtjGUtlbf6N92/KHvtjpMoyj7nOHnQdzxwMlR/ZpGABBpFciTjPbTvajMM+EaRy+Osyjfs7kP5b4rLDUEsGwLYfeR3axC+3AUA7TWzpsRMrcd2AiBY+Bg2tZY4cPtSqd8j+4BOdR9Qd/uAxO4D6nYfwKFETKm7fQCklrIT6FxqWPYIjA40etoenNvOnJjTB2njuLyO7/Gt6SzNgPPX3q6Tn/0lviE1m4TIpMjcfXJtG+M+kjl+1sbbrYJeiOhg0nSq+wMvxaKA4vKsUp8D4v0CxDk9cwHWzg1HC07GCo6xH0rQBWfPOZUYJ9NqYD/UMDLt4wxABfx+CX75yOCdhV9deYyY8douqz8ZRsB5Xxhcq9ixVLWc+vEluDn6K7QIPaEIm0U9A70bz0QMFh1bIh+aGg0R8OVNPQOBRj+0LSzpxUEbF9eGqgAOYWas8K2Bn5k+BxTpdVHoqMg14z5Ow5C+96xePiuldiEt7QD0syj9W81uf86W7+UhzUCuKqtoqNqdHTwW9bgQqDQHNd11CvTQVC1eLlCEQILMCWtyUmRxJgKgl/DJkJY0spTrRUCkiOYx3vO6lup4ox53iGRi3AFSU2KcALMDDOhQpoNp6FiANz1MwY43cSY2KJbm2WMwJZNVOwooLjJGMjB04NYAvOyvtQE89BYxXuUHSgpHri+ruLSMej6OGyvXQb4fJoInz6khUPINPdyl2oetEflGqFZW7DxCXvKqx1/T2AlsUL3sC5oBBshGjFHJraqqy+0iXs/9apUedg9q9v3BReLU0J22qMm0u0MvrvTfHxWPqtfvcl/y/ZWLcNj0OCBV1Nbx0bB8qygOSWnrRXCEApc8LEIHw7CyPboDYpLsj3UzS7CApy8oJhweyQOZQtUNDbcOUdW90q3Pl5kxXeoI6DnYDWVINusFeThriI6YPvhHyD+5PgDO2nLZopOvYYhrhrYrftU5rPaKPO2OhrUfCFXbGwoKactCae+AQtNCNNWjaFA130DxSNNi7JJt0+oUYmbpm55MoXUxty6EdBRbzCMUDiqQJK+Keuvpc6BMvKlvjH96Q3VPqERbEn1nW9btCx/hRRbsUa/F92KTEje471/EU7fpwyLQfTowikIYyKAABgDKPMc4j1g8lVQA/wKREWUPiFz6rZBQhRVTk049Se/WVVl+rppRvAidNPmO7EdVJqAO2ao78AKQ5b8re5oHp48Oxtk/o3p7FdMfs8OBmjDFVUbmoRgedtcUF9TS1VEyoZPI6dpBQSWnyi/UKCdF8KHexRcus5CcMiI7Olwf3Iry/EqWyfJ8WB/U8jJR1IVVGvw8gaVRyGGu6tc0EaZyzjTMDJ4AgELDeBCy/ig8Z+7vQd8PHFublet7P8kTwbg5sGYw6Zg3EMe1gXXhd7Vuew3pfQkR91hW+AvKlQLguGOAdUVCIUUmlIAN9FL4u3yzIVYRJdnfWmYCE6Kl3jM5+hazCLXWSleaI2pEmFYHtL4amggpongRyDkAhcVEtqpFA40sGwiwVb31vzv7OxRtLyREFMJ3gNzTTFSZ0X0KwQAvxg/gg2psjNgvqsoLeag4UOXEcueclXoDnue9XOUZsq6YKQrRhQAcMBYRCn9COKMF2rODUlwSyH4Sv9giM3+vkrdgNClQanL5VPlvyKr+sACG5wvM82VKhQ55pBp3apE2kNCzibXgAm9u0pMu6n622lC5BJTaEDKweKCMB7jZKkn9koJW8vcTEfwDuPU+ByCKSfbnDemqXCu/XzjEpOQOUbzWcpYYSprRmlqUohaKxcVayFXhzODvBfxtdXCDT4qMuPhZhF+Qz1GLt9tyQQc7RrA92aVcxuxzr9F7vkBEWI+OjVcDXwSnC3LzG/fIxcqDR3VxqsDZevsPrJX2sxapIY3lBC7m0t4asSXJmM/1AvEFdbMzuo8yyTf7TEUONcFib8MmhptbgBhYL6pf7iBdo2b2ZZktixLFlRQLirZtig+gTlwBU76+xSNQbnd1CIKXWtMuNfDh2T/oQYtDz7tib/m6SS2NGmy2i361J3rYHnSiYDtX+kEhRiL7RxTmjIgdUAZR85MHvx1FrBb1+AEOVXi6EBYI3ggBCyAPs1MmEl7s/+n6EttChYGn5rVqim0gt4JtQYlqQdmCpBDDO9mDSCmUL1Yu2ROBPNX3qx1P2HdX220UqRSziYkX/g8KuRH/o8ChfQr7y1CnvKSH2j2MpifjmEcVMlPFdUXslkHsNhDYInWoSG06AztnZklVhA4cQkuzO9rsDA3FfRziv8t4r6OOnOZ05Z/nNucL0nEO6YH1IiQ0MgGWpWN6Fx+yREhrIL9fgigoZFDAfMH/oIU1/s1DXNFec+8edQi7LowMLVAosAhp/pIedUEtjciUkzxJ8qpJTYLhr1kG07LR51VFUk4sUvi8wuwQ0xNN0ncHX2hcjXm3XUbKsrnRr9NFJolDkBq1dJJAnaOcJqnuemfI02kSUarTRCfe+PyIMQQ6PQJKMEZBeY045bAj6HHYYX9JHv8pqueBDm6oKCoNkNKBqOo2SDPY1hWxQRdIbepq6BkrCKYMIKv4o6Jo+eJ71AJPK8fBWaS0UBAn+2edBEr/WuhxAAUdDEQRr+VAM37MqH0DuR5ROtbrgJEIMAxthMTT1QxCESgYeZxShIiMEJpF5I/J1SKSrBJBmgHBN1Wc65F6p8NYQpwqzxlqy7Nt9d1b9kpxXQdPyLL2RETekSoaG8dpWAKyf1FBiZQTmztE2vVIh1GPBA2Q7eBa354efL7XdRn11ngasK7/wYsBywPv/HFMKrUd7PF34C7cYMXKjcu8EtSjxNBed2ozr53QmppIkztr2NPvzzOdnG1qyvBiLCDnb0klLaq/uIipCYyIqYHpyW+6kIGCYf0EILCUBLLHbx/gbs+y6Ou5bQ/KAuoLLu5H7PIN5DSljDt4QOaTMfc4p+vSuJNCHTMFp87AUSXimAK9qwZOw6s6OcMg5jyIAHjLzMoEcYmVQCmvaHxBvGKaLwh/wheEP+kLgptd9QWBFoPXO74vCN/4gtCv1ReE81TEBVw73ReE73xBfE23F86Px4QvCG/cF0RAiXXpkf3xDVVfEGhQ6Bo00ZUQDQpdg5wrjf9TwfeOxwa+O173GMH3e68V8P3sanLGdf7LmVibv5nSPZRXVen4cm1NCUmgk142wxUSKwuYsmUvyWNdYetOKyLBIxHun+pieRARmajqgCVQP6MItjVmxsV0NCZzMbM88+b4D2UFFIvIcj5vUoBzO7GXppTScIxR339psQgp5mI/OMDr/yIYg+U+7HWlWPzl/BCLR9usx1uoxhe/cFdLbjgFcvHLvaINgfUzX3VxyJXOyX1zmjuQ83qPcakhvIq7CGsIbeXQsoS2cWhRQttxf+rFCBGHfAnlaL6ECm7eDtnM7SASLjrfKS+5vpwiL4W+nCovq/pyGs3zy1Z92SUv2/TldHnZri9nyEtPX84EFTX3007Xy3nQUcQltfwsOlMBg5ezaRdezpGXJ9AZeNktL0+k0/DyJEJGKp5MoTzP5ctlxVNot7ycR+fI83xE7uEf3noRPYnOprMQcwE9kZ6AwIWaVKNTCc2gJ9O5D3/W4zKRzgHJ9ES55XY51/A5DyUg4Sw6n87jwOS2D1+cjZ/z5LOsOJ8/sy0I6TxCMVw+olEAaj9Fa38K7UHZWt8VWt8FdCHiniJx3LFKYfjAFIZoW9hOFFbjrmgP5MOriyci41l0tjYecbu5ma6wGidKnidwHleYrD+hufUY6BWRHVh0dtCcMhBbcL91C3URyRjHkS1fZRSyq3rF2ozv1fy0nCb+cafJDFfS+eY0+eY0+XcwTYIUsyJ4Ub4dj0vbHm3HlCAuYhul+RlmSmRc4KyZEmc88imRVafENqDymbSNZ6BOCcZFIkH/LRzaLqEeEE5Cq0B/nTDclNMF/U+3eP0kvFi83ikvO+xcmOeXLXYu4KVn5wJezjRzoYLkuyaQ/NQqkp9WQXJFg92Kz4wFiAZ+r1Tw2w7XbjpLRgp4pnFm4EODrOcjWRD0U+/8LxdX/zDswIsn0lMEey+u/hV7OFGQUKpTpDmPbOxZk/hu5ozFGsX9JxvcP3cEXc+nJ6NAYK3DsCcputoJp7g/BV3p0aLr6cDM0y26ntHPQJK2IZLxwlB11efaopdAz6QUFNGi1g5Gw5BHB09QnzOBNqcRUzJDfXdx1BZBptNLqnoGl3OqoNWpdIZixW552WVxbJ5fTrc4hpfTDI5VkGfnBPKcUkEeBd05k3RQQXSOUjsFzG6F8hNK+qV0Q8duFLIcfdbJQfZUAPFUC9kdkBLuoDMRyQDRyBSedl9U8A+Di21IqyQnpQUAaU7IQDMPwG+X1+oMS2xY3MCxr2H/BQIVqKK97SEo2ZcEAkThTkQdn2boPVBcSK3zCf+8v1cXbwwz1I/6dcAa6kVYyHucjd9WsT4qwcwVra/Oz5Un5U9RbM0Nqc/P18mX7xHTJjuwwa/p8NZAPFbxOFWLPc2tisijy+ecvAZYQCXTGfwIRhfNU0dQgvKzlISsyMvZSkeFcDDGnmkXTWK0PcUtmjVeAEM8Zf0rnkq75eUiOkeeT0Pk0w3muEXzYrto7rWocroSHF2iuEymKZsuiWYl3TOyhl5ETytJxoUjK2JIF2peXShtjYbEPZWeju903aOLaS/eLqSnjBagqSBzroBdOg8usNTm3BE682RXACiMpj5Bo7WAk1gQfYi4zQZwPv1Lz4uvI0+lh8FLdTPo4yA2OKAyPBXLaYKKHlUQPiGIu8RJ98TpbiznH87BW03JV2jOEsT3mMqWwrXs4E2oyolBIW6XOi91V5dDbHMrEk+j3+NTINOWIqvo4+Nz3/ZJ5TG/+Aj8oELoP+EHFXFhxQ9q9wAMBIrA/2p+WzuBV9Rf+MTPf6JWekV9ScUr6s8jhSP5cYZzinr9Tc4p6slW6VykcnnZqxSk2Q14Tjgyhcw1uxFJY75MX424Wvpu3/MhfAkqwpfQCV8kOoR72IjjFFSRjAdq0WFAjjzUxqPZ/rOQLsI8FaZWZCsBHhzLD+S0MtJQpBpyu4LlFoGtIDAVoMcTkqtgE9GLOKOVE2wKnDPaKZIrAbg2t9rUzdoYVAVXJ9B4uP61YxoP/uOp8fDnvlc/WRzXgSvi43n7jU/e2++JfP2ioHppwLFIKOJRr1QSy9DiwFEqqfr3xcCrf189uB4d/xhNUY++OtoQU0FOhnkAUJaPUB+Abyw3sLKPvdbNjPh4Ln6dYO379KSS0xoQg8NQ8t5rhNIcwGv9GmEgfF0NQd+AKkF52ENr4qd2BKHU8FPBojlVUPuvMvFg2+YLb6rYtvEuNO8LqlOQPSiQFFTDbae7HtKbAQxDftyPrNYqnycH7QKKavFfHi0e75sX/9GR4h84ieIfGi0e75sXf/9I8Q9uWvzWmr3cxDP+oNwpQchcWVrVWfZJc1ni45+4/hCK0PsSW2FmNtSPs98+OPbppZ4/aWkIHsZ+RxuWvRGVySXSmmCPGhD6YcSOmtv9ds8zELjJ2CbCwgf3K/yK21ktBUFRpRLaccmi4NKPvw6XYaDyoLhXvYbyI686/jUUv5bOOkrWr11Yi9J0QSZDC8ME1ZVDKEOsUaqOmtJPX5onXrsY+XlFl9898lvDzy4Jnru2Pzd94k8Nq5LWayAwu9P/uInz85p1uqXuj21IGWp5yd6AVmnwpnGf6j8uruxeqQD0DUHVgnwZmtN90TWxV4hAeoSim7M1XWIATlXelPZLBEIcl+qgCKXT/B5GRx9YNhAdmijAA7Hp9/CImxoMuKUxgA0yKWtjhx+Lvq9Fqu8+KVJ7k92mwyr3m/XOSwU9bxxFz4MnRs+DDj1v/FdFz8MnQM+fw8o3gSD2BNS5RtPDolDYywqbAIDJDTp1ZV0EWMvqFBH/lWtZUPqtVy/f2U+gUUUk2E2xNhzMhUHGCLW6qmNZxoAJho2J7TLm66rl44uWLldSaP08/VYdhYdaOpYuVCI1KBzwQFr2k2jQiiCH+inzqivYLUj9NwLVm77RQPVjxwXVzUgVovd8sHPTrcka64+6qZHJL65C4ClPeotWpFWWoiUvPl4KYUt0uvMkeqrUYo7rDae2v3/tNfs5V9XTpya1SteeYBE7tT4r/hxi/lcXsqJy/Mhbn+x67Ys0Qmf2o+vUrd/gndohdE3t6+HuA9yhIxcyZabk88smhXARhpVCe6uRaOrsjchp1vLsT5Wxfprnw0K9J81G+cqZKL0VpMx+SteWNZBaFG/pLXnpd0vh90k31fHMvRJeXQM4Kt4oxd0dfvZK8Czxe4cP4BRUlkhW5Vizf2kii+O9tceyOg7c6njk393qOJxcHU8Gi57hBdOwIdDylTQWaMCaDqtDicCihPI1yWMZuZ9xI/ez/+5G7s5HN3JjDOvPS/pzN2VYSTjT1f3CtlLJwe4S1lUn46Y8Kz2WsX27G9tf/Hc3tr/0uIztOyT9O0bH1m1FZAgxsOqV9dkysBfh55KSypI/dXgf+9R9lxveX/l3N7zv/jcmut5jGblfcyP33n93I/e+RzdyJ8E8fWBz5ulc6f1FwgrtL20A7pZRJuGS3HxFR2BX04x09lhG+kNupD/8726kf/3rO0dXZfS60+foY148f8uN3N3/7kbutx/dyDWx2fldiX2Lx/IBAafoP/P2HSc2KMBt2ODCPcSjqy7eQxIH6Hmsiut9vbKqQnW8UOScRaP7daHQYSo3tnE3RZdaq9tenqwI9ohDdmsU3ze7nqO19CNeBN1Wn8fTc8aEHbLIJcg90+5QFz7fot5FHuHZNc+kr2ZN4ZYF9YZABTTN4zeOK2KDEjFFeGjj+nvQrP65Bkaa13l0Cy2og/7LkPta1SCo2Ne9/CTnzP24lwT3A24v+by1zWdQ97HMoD9wM+gP/93NoD96dDPokuOOox3FhE/FSUcyxAns14cCfsqN3z3/7sbvjx+X7cOfnmBreIlsGPbJDmK37B30cEPPNiDX2XzvED6Wsf3fbmz/7N/d2N776Mb2KcfjQCFWzKZwnjpYRx+TdO0+N1if/Xc3WJ/7+jKRZ6lgdOoS+NhPDf/ajdzn/92N3Be+viOnrtazr5Nc9AE3cl/8dzdyX3p0I/f0E27Rd/lHO8q7bEYpD/qPZdT+0Y3aP/27G7UHH92oPZVHzSl2iXYdAGoU7HxYMSz87J+1cMuEmMa/dJrPUOTqH5sw7Y3Yj0yN3TUtcnUi0g1l33Srj1cfJ3kHVW2OtO1QkVOXXIIeCjItNsBpY5L+xrMS2Kd+4nWtlwfXxS+vGC08xqfRkdajdrFg+Qu9vdmnCINzEz+hzHCjPoOBRxGn3OhzwYd9hE/nJwznIHrgcXTmgrdwIypmkwTCcDBU1PeJ+7+Nf2SzmybDzr37vvAfEPsHF1NUupPhXTDXnSd4HvLzBur21rR8wCt7jXS9mb0Wzxy74wdrSKmvsRpr0VIfPbcELyzaB6B7e0iyzQh8fLl0rzEdisSROAXZ6xAB26v4FghSpximwKP+4UDvXCLoSxDq7vPUFh96i4FY5sDfZb2CR+ZS2dGnOPRPxefw/mK578Ga6zKwc6nPAVUP7CcU9vKuGD5cfFaxxdhxnZebNJ7CAPYmMm4LJm2avV6AE3LPoAnarVholbryJXnWihVM1h7xo5Wv+nsRgA0B3Wmv9ut8q42W1OkpcXNKI0ED5yvNWfeXMrN8K8x+allZsR2PhYIAKA6t5rncRl3NC37u4Jwhbc134uJDvo3CfCdtR4tOGbmVWkBj/1TcSt3BKoL5abSTA6y4v4tO5e3e6XjlEECKu2f8yrQzOAAletyf2JmfTdvycyjPnwAxinRmDg4Cn0CiUt8M9PbALOJgeUZjnO/A3ebW0Q5Vtt5Np7Nu/Rk5a8nz7YAz83PpnPwpXPIr8/PoidydJzHInpyfT+fme+gpUtsyZBMP14JafgGdX4ZZ270MP5XCMsxyWTofoeJptIwnK+Y/AF38UF720h559hH5DP55OMVQ4HO6kC5A7LfQRfRUBPaVyXwJpXhmmeeLUN3fS30ELkTGvRTxLYaBz6V+yaOn0dOR8jR6Kl3EgUlhDz6RCi7S74Li6fydreyZXL2Us5cQjRIk2rXhW2gfKtCv7/LxNXT6n4HIizUyKPZWi+RUZOKS904tEjcStFv4+qjP3ZKOPBWRT9XIoLioWiT3Dpn4y4tckfbyyDIey3Q+HufTHjz2AB+A7+fBKch5/RhK8PREqP4zPjxJnk+iJ8uTL9nI81x6ijz5kiIm4G7aoSvG6bQLiHsGHmfQ2XicTWficSadw9eCGF2fAPPFT6Cz8B3fIBu9i3qKu4tqJ4f/73hyfHNyfHNy4AZqgRuoz8LjUiwWQHRc/NMJcTq+RziR61dnYyrQsw6guJ1cJ0JnMQZ/K8+HU3lenPbo5wSNz4lzGPtPZTicxTA4k/t/Gvf9bDMvnknn5bUpc2NXwMhcmRu1ytxYrs4Ng/IX0bKZF7XKvLADGioeyLACpU28zrgSvwW5gdM//+zn3f9D7/78xfZZPI2xoHg68cQAwqvBRfssnsGJgl9atGAiEFZjL5qcImgGJxFKLafZU+10QWzZPurTU3W6aGaN3mW683Sp1s6Up2rVF0qRGjmK1rvoQpQ2htaKusfH7l147KJnArufabD7PMHe8x4llp9DpwP1cFeU8e0svOE2/BnA0tPwdhqdjbezGdkJyP6t+Pxb6Vn2/mqB+6tngz8CSo/g+bmC0Wcf4Fr7NWA94+BOLiLPnxzsNYhJT2a0TfKn4gnCyhmfBLSj3YyST+BunZs/EQiKzudMEfKQEXWZEfV8MIMVxFyuIGY4BQkV/xwJriLeU0tyqkNn6W8VAzgaqZz3gpMdM4zSHjNKuwT6GDo8nzk5agDrk+yoPIVOl6EC5HfTE/DGNwbxdi6Pa4ZhNbddz9YPcirolBcV/GNvu8KVdU6n0A6+kQ7qwdAPaTsuOG0n0o96PHRcrnDdoVIYpSbssff3cKW1pChzGnsQsdPXXmJ2m4d+iW+3ngcLTmAHzsD4nkdnGFL3RE7nx5P4cQZoIuKejHSgS4iuMeuNbp+HbGj0brMo5E/TgJ8/3cyn3CxBfm6WxSDva8DPnyEX64EzIe1Gp/S6cnWFR0OK6jL/ZERU1/qnIGKXW/DRKJ5zZtX/FkUwWbyLS2iXvFxqSOC3IfKycg2rrvrPtqv+c2zyudI0u9p+y8ks56BojkW4lL6tpF37qF/BTekw7dP8utzbWp+otV5Cl+FbXbDp2fQcvO2ji6cUYulppZAdtum6gMvi79b4p40XAjqpE8hRVjeBMFdCM1d2y5zYbe/Pn2GsxetWsYafZ+qSdn6fL5bvZ9IwswsX5NXK4pM4YZfaB2zjEvH5nIWn0Pn7Ebqsh4mh/v6eSIvUpvN5A34At59pl97xerHwD8S3r/EBK7rvWWMElf1rvgyio45ba8N3q1t5WkMEemgjrc10dfuP7l/HgEInmCZ4SseFGJyPDp5Pz7RWNI9ugbm2Bfg+XqBFyOm4hdbiG2zhwRIm/8FyIp58D/fbyYcBxWz6vp86AMySwmfBSClWyYcpR7iEH9n4L+4varrxx1VErp8DsvEH3LHtV1kDN5a62Lw/E49WvgVyN4SKLRJfPJPJyv6+rDlbNvLnck1PpoV8j9SGgaOAVpmK3RIcEIhZ1yVH4Uw0vv0IPXcogSI+UtSpXrEo/vBCfiGq2Fso9TwfL0nxRAYvRh2jo31niAd6uV2mrU56fy8TWwim6Pyc8UKEFhcKMZdVAjMM/A1KHpUm7OJMIHdK1rlsH2j/TEHVRZ7A8UPBGm25WpDkfEU+04xdJbJxtPWfdT6FiOYiljmJYtrDTYTR36Gxt+8p7oTOoz9Xrf0F3hS7LMKAXgGbnozYJ1sxoEORFeqKXAVwL6UpW1Sasnjy0pQVyIg6KlSZp0URqnRVqNIthSpdJ1TZYoQqMFc9/02hyjf3jd/cN35TqPLNyfF/8+T4plDlm0KVbwpVvilU+aZQBdwydXo8MEa60n1cpCvMdzMOLP7rS1e+KV35pnRFxSrk01aeAM9iTFsyApYnHl/Ach5tGRei1HiNXKZdxvZmTLWKzCRcQ0RFkOI2o3iE0+QolE3KUZZkWww/dt8OOUob4pQ2bUWerdZGf0Qz0AzRfXr2NSjSKAgytcOUQmtoQVqTDUS/RZPDSnJSTYYb/P5Ha2uuVOttEp4K9upnTXy2b+Kz1YmvJDqrRKvXBqfUUsbfqOonrCKjijgnMFM14ay5HxzfTNUl+FrV2w+U99lXD4jBCOcfFLYNszegKZ10Iv4mxD9Ce1fHsRLgj1oJCKyVgNc8zuZKQG0widSeozNY8sYTuHX+0ziG78k6/wXsxNleX2mUflfhjDRek9F4E8pSG3qDGL+3x0V9f78hboZKB5FD+NIovfIN8gaXcGcsjlKbFKFPKR7woIwEtcqOmFCcMkR961z0cIBq6xSZOVoE/NIpMvvqD5wbs2IWg3ikEjG376/S/C8f/trfcTg4wq3/MbRefZaCYw4GNs62tQxIDw9z3/A8FBQRL2SBeCyq449t+88rzVlAOym4ILgz5qe2eEE8fq4VcASptdXVX9iRWy8I7kI+TknEpyViNmKFAvdbLes3kb8jHs460ssrC16gI8FRDgTGvYOa9SXUwnELIBcLNK/kokEhJTRHcwPuJfd+WI7H6/auPxQUi8hd3yiC9QG/RX2/z8jPs5w7Fr2U0yh6SfbRqnVD51iRgvU8wGB1xabivPMPtiQ7lAXzAQeRLgNJs9wW+YhHEyNHS4OhRZcPDgpfHT8PB8UyIImMLc2Yd/lrX71BSxnd4XAoUIR77WVKOY8ZV4NM2c14c/5ePcASzS0WLlVyW3E/vARG5Vl5hxbyuvUK1XmmZMsY4pl+PYLtzuV+rBPjPP9OHcHSjSxPHkyuR05F/mAhNX4Sro14Ovr8nOf30hzYA57zByakMpzqdSxi6yktJamrqISH7M08zHHfo1i06OLzZAF7SLw5xRvrwPP+09eKZGPfn//Qwi9+65/77MCRP+GdbdHIHhZzY03+4AH+wL6n/H5f5b0Fabt0zk3BvF3SBGpssGt1Fc3HxhkONaoevD3xiDNT+X4w1IEXh4jFLEt7y6GT2dimWZ72ZQnfy5XPCibxk5EUIxRUfK928OiQVxl/jzKs0ZmMZ9i/izE/zf5MfeFQqAAMAegFfltYw5DDN56XfcAoCtKaJiT7Zv/67Otv/clrnpZ9EEn5HIVIYewYeBRCrzI7qt9Q7OIUY7SmTGuCQRrR4p2Dl/x5fqyCK5hD4xf5cS6zCnp2YAFep2V2KR5Qaxy2gQroltsVuHlYF5SwWOh65DEkAC1vElpV+ICUtbIPSTfm2AhMHuOxJ+9w0s0e0hR0XUTXcu1QcJdHXcrgHmc/e49qvbBYWVNQZx9GSTC+n/05vpOvih5m4aqeBGz1xUkS5PVg09CibbSAlO20hAcMpee0tTTNT7ztbB1YQ9JOrOe8MbnXM4FjNnDUBu7yBD6r/YSX0Ml5lJ8C09SA107K1/KsD3tPRX4aKFp+qvHhpEgTg0x0eMMBx9OxbBLoNBOw7C2nxdgixfaQJBO+L6PT5HkanSquI2n1OUgMsZ/x5HEU30vomD7uRQSOf07hfHQKFz3w0JzRuaQohraJf3nPuqa01uBPpVUAVvrWoVNxKhfLZx39hAp9DvHtNvO1Zb5XlYxtpx1mLV7PPS3qNLSEVkH4pYQiowyleQIQlHfEYVnVH3eOmJwKPAprKXhFKjyZoaSttALmcOeajM1pJx7agodWxvTUPJMxLU40psUpdMoJh7N4LMM4fQhPs0N4Gso+rRzCglbt3KACnY/366w9lRtsRjNWvinAMDqov8xCPSSP3bzeRgGdyhkrHngLJp2HPKRrGsYNc3nBTN47ZMrO89shftMJjElLO9F71IpT50OejPYSdbNfN7zjHDYtOR4LxQqaD1JCW9b023wH3lcRIiUIMQgC8E8JwHbuVa6U7mSwIiaDEIUgxLbjIcSqRYgdeUanmom++vhP9FXFkG2PI4YUBkMU+4oSQ1ZpG0C8nVaBHh04QttBnTUgPR6dEkWoY6e6En6LKhlQReg/oKeznnS+M5i4E1LGqYIhWpROcFAzBvzUed5aK3I3s7vn+eg/wFtuQZeFY4LvW38NewsFPl8LyD4ia4aJ0SUpzX5DV1aNHF9dsWfPyH9+3/sBBLsGgA9ejJgX9/kU2qdlUJtlSlhUD1vC7lWbiGpcK+1CjsV4evSutbE+afTq9OhsWiGtKVnTKXHNyThmE50J2LeGAdwOB9M8jI66wu2nffjEmmELyQ1+Ni7rYUeuJvdgJhzeBQg/7Hf0D9HK7I/wm4fWjB2XtguFbuz70Wf+yD359cle66H8/ouZZ9+Na11UY+BU3EBnH5cyYuVWLxGuVnVWLghYkAMJRYkK3ENlNesUqLggAMOEjkS65c8oyD6BAi8InmdO2gK9/xSoj7CEfPDv2SeVFomVuyLBY6/eWjIZcolL8gYw5nl5rE0in7H7VmrgcthL4XVzw/RDe6qhgQ0OLuL9TIyW+JgDPiVVmxJa+eVif4IrFvMWOqUj8jasjsneIYWcYWM9+5TCSfJzi/21EoQUr2O+aSWmCi07cXuVgILSoaaiSVA1FHx+zaFBuCZ3vXgT2z/o87V9VLzC8VkZb+NOJLuBHfNHYmL8Qc+HJMJg6r1zFlXVcIdeh+/fAx0fruyg/nvw4vMDW6kjjVGphKMOvjGCsMY+xySjAjmPfOzGKxsOE9y1d12ZY7eXcZnuGOpoCNijym4iAqGA4PJepftB9ifIpxX3Pcyl7E8FdJzG/XPw/8xMO7rOwzWya/Gsy6YPTvMaL49LgyJ+6TMc0BX/4wyNteyvFJkxOoeDIhEajfWnAWch8Aar+SBWxHKzkLdEoCL+ngNqQBbRgHRiWITlXTHGuxGBwYzshDeKbL28V3YiyUGC6fI8aWgRUggBzeyAOHTEgewIIo8M8hDZknxOGpLPS6Pyhf4x9c8wy1/DvKqucaiP1yT+MWtcBz1m0ccRytYL3iJx7mEprljn0tRbbbGEJTDC2YzAgzjYpURUwtSp3wotMnR6eOnKur+1xCgIeizbC1fK1BaeBJNxO1TJiPgRFrlVJSvgE3oo3YEa2A6iDbnVtpNW81OCvXBoQiu0UxblCvPAC2ZXjsBOo+U8oiVxDb/ElcoaexpnogjpyHqawIFzJVhbE/UX2vfpFFYa6+W7sCbjoPR0Op1zy5ueJCjo7bM4g1M5Bfn4QT4X/zwUz45pSJuWn2UGAn6b0AQMhbYC2aqjQadxI1s33P3bL9z93+672D7RN1Pxnm+xT5xQnF5G/7p9IvpsRO8V2ZB9KnhIUq5Y+d53HXu/fbqUH7g6OOf1W9bfa59IQWmcxnA4rTws/qB9oi/oPlrNYTzwH7rw8T2HPvBX/3zn++1TuvCRd7zr/W/52/zp9gnIIf7t33H7wee+8k0fsE8bf3jxd7cMvH9+un3a+P/vP3xo6cCH/uMH7dPGP/u78O+nL7ZPjUcfoHpw9kQjr/3E7//nC//4s0+zTynk87ef+frPffY/f8A+beGv+Oo7vvsvtv7W0+3Txn/iez/EjTvjg/Zp43/mwWx2dvb6i+3Txl8qjfuND9qna+Q5xOPpmQljnzyY3z7JbvNofBKebr6j2D0l8Ym0G6h4Og/c73GNvom3T/7m2wkFPPwdfCJ9Dp1BKOgMYl0f/aySfga1ZBrIFuBJjMJ1fk1DPM8Cp87PM/mZ8fMMfu7m59n8JJ52uchWhIl4kuw9rimiF/N8dvqfIGus/zk3lEARCjUb1f88neosRCP5kIOZDc5TXUPDYZEN81lOI5vG7xltB0uip/fn4iUpngK10fNUpIp2Ma3tGIrG7sIokrmKfS89RdVGz80jPiZPMG8t6ag50oGSq7SDzudMgMi5/Qx1dnAG16FczuC2UUEh1EZJ1UYjbUCeUC7NiSiSllMi1F41QyPArjhXyfe5Vl8zAZ+SlA1wGwN7+r0LhISp2CvhCGonWsFEU7mYhcpiu0BbaeZZeSQHZflWilRs29CVrylMFlrpW1Hs9ZHzq3CYBamJxoMt4wvZHj8jNivPTwjorqUEHNMhfoUN7xvxNOajA24xwqtF/CI9Yioi5mBehgKwH0Myp3DUS1BIP1jj0+/z/KuF/wsOnOcf0Jx8QLWGY54XMEg+DU6V4gOGwW0od7iqS/nuA3oAksfiK0d9QWM50sqRpqqyDTEIgMapSXM5/6dQ7ZWLG3K03uNakUVhqv3qgmWUr3swnf08SsDTfScl4OmeTQn4cCmeP21IpShfWOm/Bveh+S+R/JBfyqzxyKucwBWBtCbIPq8f7PKvzgHVxnn+WfyAAJQfCVbm8/yLENTjyT0S/AKC50rwfgR3I4g769hzIPgQYndK8CBiSYJfRuyqBB9EsCvBm5BhQYKHEGwhCOG2seRwgOqCptkXtKnaHyQiVk9ftYFTYhtljPLZCSObRcG/DKejoMO16ag4ioJxBQUji4KeoiCGWVEwcijIyAeU0UE6gEwO6zyKpmMdxIHYkThEC4XalIgWGEQLyVNEM76WAiBaYDYik4gW6FcBC5iOi2ieIlqI8k+AaAEFVUTzpDVeFdGCb0BECyqI9jePM6L9wsl7VghHPCt4m3hWCMY9K2BX88CoZ4UfvqHqWaE8jo6w1fw38q3wIzccz7fCYaQ+Sh8EP3rDuA+CsOqDIDxJHwRXP1YfBN6odkFotQt+stPw5UQ/lGNE77qA/6x5ktrIzlqlKc9Waco+fdurb3uApbex7AbPC4JdsovehU009mkM5uo2PMMR7wUB1ryPYFYCJ35c96a6C4ydeFmv1cQXbP5RqjtaKup47CwStVUjZ9+yS2xSgGJBD+soPb1tWLQuCAjlUjosUlM4NSkeFk2RxXQ14kjR1Cr3mBp/QvfpZL5BKh5acJvag4F+m1IDMU1qIoamlNDSEmItwTaNUltCS0uIKZ5eAnhE7nJihUT+yPGmyhcg3fXSlMduZkL4AoOAYg9QANbvCnuW0IxgJBqTo3l1wA1tBJApI/8ItzHOfhJNUBz0KRtUY2popMr5lcbfBmDr9ym1Jj5tbfZpJ6+TSBNmZMGZkRYXs6bNoEfPxUD7aHUdnX0ZcI2yI0VrBBQxtbDUCXiPYMQHQ2qtVxVCWohuDRgTyg+/X/EuvaNIy85zlqIJCESUjnajOdCY6RBIKxCIxiHQPA4E0NM8kX7ns6mMOMOkAZg0aJYEBvYSHWw4ciysOhbhs6Tb8TCf4zGVOSDYlOVNFZjEeHQnp6V7/eB1sCnUAjRTalLrSDE/pBhE9EixMBzcRvPEEQvE4aK1DjwfUsqTSaod0NwRBjEPxB1WVwXX/EaB26RIOqvqG5CAjqbHJQv/fLxKL9oU0AJXIL0YYGhgEbfNjYlRAI/N+MjEEyOzy4J3VDum0SdANcTLOOA7ADw0DiZhfpECPlHJbKe/R8wQJfxJxNNoRtUFA+JA4pBAGtqaaOjmM0Fkajq2s1ohtyNi/PdQcleKP5K38MwIlR7JU1rMG+oeHwp+YAN0WnO3r14T2sSIzDOB6jpx+PkCiW9jrI8U8a2lpoIQ4QiKNEhfOFK0hwzypvYqQzE8gRgJxgZ4dABb1AaKaN4TDHaAycYoNXCkZ4FSRMgEHCdAzeMQIEBLh/KifFaHmeEijEyo4xkxx6JXHpG2SB2SV5EFKoujBX4Gy6AEXYri0y1m7QqE9ZAEzEDhJEJuAmi3cnIo51ZdAGQdc7G3aSwvuZY1+x0/gKpduRgPGk6nR/RAbkE/oEcmWom3ZW9GERqlricnVgTNqRmhbQ2VNeUlNBW0H8elqtLGb3kiKXmDkbspmFQvJ2OgtMTXGrFFy6PSoLQuZj7x35W9oqXLuoCCUo5Ir9JKb4nXqCkrTpswPaiNlZVxB1v1phiOQ8kRo2wRmTO2Jnput++qZ6AlwcE1hAmHhDnEyR60q74uKpT9W7SOgANVFcqf31yF8l9VlfP2E7TjTY9/OzJuRzbWJqq26adO0KbfGG1ToNHKT0oljB+llXY/eyNSC3/fbjlbU8KB1kLw9uOfPPX+9JzZDwxAXMQBQx7hQeBhtUMB6l/Ao59oh6AKwNjU94SB9/cGewWqFGY/Iyx8jaltCKxDPiUQfC6cY4KXnaAw/bgXQi0PfwIkdcorkwJ7ZH33yINIPiRP2WOkFjEwnUKQ733vff+n/vjPrv3Tp10JYRXFjP+qkCU+fN2JLB68QUE10jKtC4XqoqtsT0T1SonIoJy0tomivK46W/hee+ZOfAU6j1A98RHm/pE48nj3EVaJ3dGgJHYAMws5AqBMuUxgFfDLN2bdImfnMKoop9xRxINCOivbiCNYUED6/FuVJNUBYPC5UiDVB8M7imSQ1w1+J0eKhOKrZHEHtd3DVKnlAVp31zhIoR4/hxDE4O/K3gXBXsagBoakzu/K6UgDmhwRg9FHppqwcZyPQuzPN9A7FN+/EYTF7WlS3dO0zLAmRfu2fEauGKQysigJYeXSiTBhI4YGtY+AOQpphiIOddHS25A9M1m4RaUOc14GjzpRjkwIT7dQDN03n3nkNW++MVZeoKEUnqL1IkKf0PE8BmBMCgBI5UfvFzDUJbtCirMnyF4fYwPyJFVM9so7uoA/p1nLqAeDwtPh0F22rlnY4mHYMMaDPEEyGb0X06AIRemYozyFNjVk7elUhy+BWpsbIDeQY59EmnXqmGoXVLa82QhTikwptUwmRvl/U6HMW77xhDJ3HFcoM1ChzLtPHlhRFVhHa5sAKxwD1sU4gh+F1XA6rDSsCyHgRtPgFu5n0IlWciykB5CrwC08HtwAVIUNwNdS8CX6CPUBuK0fF25vfQzCrCPf4MKsR9Wpn57oVFTtVHSSnbriMXUKCDnaqch26vt8LI9Q/LHyMRWN6wmaLguRNAIxvBO2/M/TrfRsSCE2XrdKkzm7Y5CuFEvSj8TBbjBCcfxNJpE/TnFwoPTg6Cy6c2QWcdtBQlUo8G9Db37uuPPm4GOYN9dPoFhQRbHgJFHsZSeFYr9y8oMJw8xmNI986FXRlMHUPAH0+tyADjgv9qqDD/luOH9tZDjtDinSPdImA9q//9oXir2kr+/Avve4A/s+Hdjv2My8OIpCD2U4v/wxnrwgdWsYN/Z1iY+1pRWr4ci5sJa+3w9C7AWsyXOMcDmNLmvXygMz0omFY2H+YxUpWRt84aQowNE8hJyVU/EYp+GxyqHw0XMAOQT24+xNNGn1a/CK+qXeNeUCXqYH+VSTZaODQGAwUl+zX7LC+Mocd83n40jMb1THf+X8Tuz8zu7C59qzRAouQtegia6EaFBYbVD2Dh2RL4YN2UZdF+JYQv8md4jjGnwhoKo47b1UAVnbKOpO2yLn+p2SXt4o34i1KOv4P2/yDHbC4LwlUGyVSqqDITXWi7YTIetlonyG2qoNmLezX1YYgu2E5Ku5TjP4b8AyrJlbaabcjw3BWjpWvA3V8oW8o/tPKLl29ZFRYFixloS6MqdmDMHM3onq+DVgEWDRxqNLbbddmjlSZMMj6N1MWRdHsq7dejHHXRlw21XDAhar2hMNTN1Xc7ikNxyuU0bZAF2bXa9sxNCBR5AZO9pUldtoxg0R0MODoXUozyJ5fq3aFyT7NL9GbQ11TKjlys5blAIJUiMicpa5UDArmMIBI+Baq+7f07d5XuiogLvYqsIzqNhm7wKk+7rFiaHSl2BKN5jq75YFm8N9cdTQkPziOD4jiTuLGlMXjlVq6N0xDyUmENZmvyLVeNibM9G6sBbyo4FiY+ea4InVfTa6ZtYPr7yHPXrsk046M7BzDZ8C0D4+vUO64VWVvrEgAOMmGJjTpcQ+t2HwY686pFt91Hp27a38Dphn70EVafo5LwAtjK6taOHqiLK8OlCCHhpHHbJlcxPQyYfzuotNZFpGigNKUioI0NAtYzlJzSY0pmTIDzkuH1RwcXgEczoemI0pBRMZ5FPkAgHJY84EvSicyHCEh8njiR+M/8G6G+IWJA+UIRASD05MZTjSUT9Akk/ieCMrRJDmQRtC9ghyuwCpKipCUWUx6mawHBvcZDf67XZ3wHkdm4DyfMUNH7mN3Dp7txJp1Yf3ZGh/2PcCbrn4+yj8C2sttFAdf8iqfnat1faMMa9Apd26peEZhqzSQFnDkRN7TI8LgdCQC0QolIiWr4tWoBrt3JZfRVu0QPyAJ7Xf9mvyyDbMHXwu39Pyvc3KT51bEoCxrIzfUdnGCSvT9qTpf8VA1qruUdThim9EjYCZWdeRlCjCkW+q8mV4ZMTVgYkOWIJPOMEVj9mLOjA+j0/xeD3gea9U/EN5PB+7PNv/CjP7GUdvfNp18PVyepD8/9oeynzGk67FgR/aMvsa5BECIx8CNt1UCsAdGH7P3ni9wZ3sh5UIpP/90XDF75/gisEKOrYYb2N8cX8aX1zgw6uZB1579BswsL8j+y/UrvRcswTmbCm720wcPUv5bUWVv/ACHxey3doxev96QSZ2Hik9ztTxT4j4mqQgztOL2h5ySFUqtgTbjJ8aWESkTLvJHTOgz+LMeK5qJRcpJDLVrVoo6tadONqhN24T4Td9vR5lbtl6uHXlUd2IpaqXPy70/FGxrq8w9rOP4lNN0FQZIQf39NDjfOCgF4hX5DiBM+Reeczwm+6YQQWE40cfgQ+efOKWEypwnolC7UwkbHnM3LXj4CN22aPsu3DcsXDc3nE4bg8MrucYXJD2krP2oWgyjZ2Oyu1yTLWx7fIjrdfKiUT1TX90AxbuFwdaoY5jbFRAdSi4WngXSs43+XNdcKqbrVBKxSPUh9tFYzzUmS6KKbcXoLWTe+qff1yxQ9dCe/MLE00jnA8uzeGZHMAfd0x17ATHVG/E7toaVcDaTb69Sc6NM3MXLUPiHvycux+X2a1W62+5G2Wh8belChvIqX6FKVS0A0tRV4O/RQCWXjLtwj00uUmNsa7rnY+4aHBu8R5Vt83xKMzBQfpqD1c+x0+gVy+dSVxzDtQgHxyzHAEBlaZUP1KzMDsfCP2Wu4pFjuwZeuepOEFsHwTm2n+dNLlIcE0OpxOxOmPGXgyfNc2+yZPhx2JXRzEpBgkh6KTohrmPiQKTwNgUJVJGWxmsGVWAl5I61StfGUpJqIPxQP0FtiZ5hrHO5N4nFLBEZ6KJYTE5c5+wQzKgjagJOwp6W0xBE+HHL0EbAKaBdRbttutWmaOt9FVGLao0DmaVKFVS3ZTmzWLvRLN8ZJJRE6d0nG5P6bCvCMrbhXddNJQOsATwY0+97vvfMmD3Xvt+8uPPetY/zPz3i7hXmaH6encvgu0378VK+9+OgcH5Bf8BnL6On6rLqlZ5EUl3Y+lukamwTh/aSdPlmMkOiBK67BtUwjwLnQZq6KbTXScvrGqVsqpP/vwnfn7KWQfyTMiqPoG83DZ+fKLmpFUfwzTkRvN/+DRW1Oy3NpVUveSF/dbXW071e8eVU/2OEstnV7mRqtmroDxtFqzEXHeYqEfMcnzsdhBuP6ggBQOktVSc2/3udOd2gAY41GeCi5X6w2r9oV2jQdJAYUN8UraAIolDNVg9NuHKXKscW9ayXNl3e/6kvM6t4NaLNfefcTcY8+8XjPoWdJK7Ryng/d0JVrZV5WRbE4zs7pKRDbPfx8fH51tP0N3k5LsLxKt296/+LSegERfrqhnomhpABoIIhHTF1lBo5oqZpLF+hYd9C6cdtpmZ+3U7cjv5mXveZuIaxy1Pk9lcwyKpfqan2YXPwNXdLZTUUBqgHfSfyK/93TnzWaryhyF5rqKE7ugvFaKOzJxi7BXwjaHc40dwIEcrAo320zuDMDE6LJNcGZrlBEPTJwqQj8GVqbX/QDmrTytn1feFg3vGjfB3fD7yqDlU3JWXK0sRGi2fULQGWIFkquLk1UrbFLX/F8pT1GvxFasC6Xq3K0KtTGGA85bVqitCQ1NTRkDhKfwGfyz6AYzH4OqxWOcN8jYgBpYFzb80T1EvmKQ8Bm+gkB29gN9cL1oq/pWlVjut1k98amU/OjXFI9GdcwyCvXgV6WBEnFjvh07VG7yo25K93vNUnoaFn6erE0kPwbPt2/GMN7WO3P5bTx1eZZUlbZZjnGWYhxWDTxQIq+hVDV8V0RBMJTAOs2Z9WPgA/6CoFq3NTn8zin2xIMEtcizhwbDkCf29EAve+WM3iFiQ8fVOSAiz/y1zpw9BgyamyqcclKrIO0AhDAwojyIU2De7M0zXS3ttVvi66n/++XUP//TTRAlFDcrJsdp+XC4X2RxuHuWNSsbxY4MmbiduOPhRfeOIffvgYOQ0QHFUWgUUpYokU5SlJ80EDC4ejpsJGMh1AenIxjrCwyNq4wIjma1PirPBZeHUVdZPBZ02oe/paquuVa3AJwApaoAvC2HLLM/QP+ooU2Btt0TEj6hqu4v/Q2dv/8HaoYvuO/+VedsdTbRkH5FWmjWmRz9rusMnCq7lNEvpEarGDLWf+az0NJ8rC7z4aPYzgtezLn/GBuY0g54MrBez1Cb+Y364XSZ8mWu34f+090pV6E4wi2Oawa0MGMQQU4ZjuGMJ4cHQzqk4fYOvco6gcmIXuhM7wxOHKgZQ0UCkHKFnrrY5fsxH3BrWIR0UZNIsePH0xE3zMZNpSwk0C16CiUO5YJNDuRBSBNiC5L9SihBOHMq5hvEn2ibO5toUrlXP4OCw+VpDW8zgBkPFUNCSIRpbpTmIO5Ldi2+Hxzf6gQY9EoOto0cXIZjCvxxnVe/fhFX11Q/z+/0oMMuaNozNbUzYCDnYGH2/v9GHOFkk9uyeGhdqHSmQ3QDHYlHxeaz6G801Y8ZiAO4WcYwmg3SNsIu6t4HUcn9YBEBUn62AOIMsumiNESfzuoeNVMSgblQagekzP0D13kYeUj0P7OIJooTLn7uv3jB0h8KKxRKjT2v3p0WkdkiqTfGxKOmMkRZhAG73Q0jOQNtRkbW+UgOPhSdACaIr5jwTB6QGjnyZ4COpSV7uTx6utkBY1sodNMidT3U0JUUDU22g+4hat4IhY56mjdmngp+I65AVLKYmfyMakiiZ3/oHBfJ63RwGiLkhPm6M+zg6V0OobRwFJ1DpZWwVQEiRVUZCDzfkmMxo1pCvM6eR3vg4SzgtD9wPq9KpPz++dOpfqRWfOUErPjw50Q56kzNt7+j7oWdUZtrBV06ZaRxbzrQHf702baod/M2azrWDH65NnWwH/cpko80n2+GLh49ssn2tds3EbMPCPznbdAnXtkzMNjKz7R0626qclF86i4epOS4NcV/HWYeGjs+6uJx1sSJJbGddNGXWHa1tNu3i6dMOEJEyYRWPNpt2kZ12gKVduBvpOz3PBzPMQjNv38thnvaHbtRj31ppjGi9DF9UCV+2t8qfTA2WdrvWeTX27sg9VDR6T9XLfgEtwZBmP2y1h9aPUE0+0Q0AR5CnWMIJt60/EtU7f0T1LtxE9c4bV72DtshDo6p3f+E23267HWGa/xup3t133P3zZ3WhP0lQfRNUj1KI9bkJIZZf1VL0T1JL8drHqt0bjkr8fFWEfVSfvCII7SK0ARKMPvd/wBBudVcYY6/pZrIo3DGcRbsE6FIfqg/Boi5HJpBu10CwjBZdAFZBaLuYqdGbhX0V7z+nKqpVK3ebimrhFgJYtbms9vEtzeoOcXlqJkY11nicUfrfaulGGIEvT/TFl6Z88Yu9aOW64OUjkqR7sdGpygM2nDxANglvw7tKAzRJdhDvQjDVL+4e++J97ou73RcfkS8Mu4PFWj++Z+zjj7qP73Eff1w+BgstFyJRhgiQCBM1QWgVoQZCXYSaCC0gJFVmCLUE6xFqI7STQ3iexU85UpoB21Uq6XReVGTUObAfxg9nUeVqMfeifF6GGOkLNLs/X8TrLvV9GuS+MfKEs6klimj2xXC+SXMv4sfcgf1ibYXf5/dT/UCxDHkI6MUydWgRJC/vkA8U8S2fK7efzajWcBzZxYPyLdK5fKUvwELbQuqsZX9nzOlnME8yf2CNUtQo5ut8VQk7hvxFB0H5tIjAv3UoAoU2BqFWABb/gBA3tCbidHcQmVKb5tbyXl/QQjJjdj+AqlGsROdt0DRJLOb7oAWu8lVXeR21ujNDGPVHe5f5ce2aiHVq5tIfOCtlWKmFv0t7yKh2cutiSZnSNTlixA37Ge7+HMijGdgC9rMymJoSS1vbpEjchFc+CdGhXGzEBzSHT2Alr9hO2yqmgaN+5mwIb6etI0kEOGHwCt9cYJ8DyOZoyQItrdaIBhDMdFXup3Qqd3yWtThCcQc9KU/9tNL8pcZzl/FjkTrILm0KWcARTTBWx2YYXPyYs9boYapQFEwc0SW1Nr9soFg9EiWq5z4popMes86Rb0CtfCs5PE7GbIXNAP91IhDot1rsVUy3GqLzVkOUpxgGt0kNyvSbhGatc6zFfsh/4H6banS+puShLXNV5uJCX5UStwARcX5O/ovyhuLlnFARBofaXMpnlRzdP0aOPu3I0f2OHN2HYOrw3dePHxz7+Avu4wfdx1+Wj/Vy2pJ+eOjm0Q8fch9Kkn54I4JpX5oE6nLATDupRnpNSybO36vdW8byBErDhMvncVrggxexP4K2S0EwkCDmPObAlC1ywEA4ohSH7EoVZEdi1HyrA0vLmBNzKrZLEZkaIyG0LKPYf6gkUUqfBN3wqhYaVD4coTnIqRPEx6SUDoAKz4EKc6toDldfR0mklFR0tH4Z90hvFN/u4UkRRrcjHeJr6h4q5zhQMtQogMt7DharmAqGYOWziD8ImBdZ2b5ifmxqYSBfsSb7t2CKIth2MVoYEJ67zZPME0YVZvGn5GyRK89oHhi/SotKzpaFnM3T8onJGT9u9xgy4oTHkTXMTP58Ok3TTNkIOcuogy3kHC6KoDyMEsVc/hymqM5Xq/HQ43ZCxsmFkJIxCWeGjC1pc6ntSJuEleTNgqLN0tKl6ngT5lJx3NRyYJ91YJ8ZBTuwlmtvGYqW0qpQtAoMluHjxlC3WZqZpG7+BF2byX1afJR0jalWhagBgFEFgMu0xBMwAgBbAGBLeg067tBw0aFhS2lyv4PjL8FHD71xgOk5wMyOAWZV8BHnY2gT/hS7ZqTMHs0yJKbhab4VQGnRDOzszuYRxCzwBjE9L5e+lXzBqG20TJFFzTmMrqISIygjGyGmZmK2W45CbV5X4AfCA0zZarBou2DLPDBkvsQQ0K2pMJgbg8E8w+B/soP6RzMngSz4cyxGj+YwJ1tYwpcNhxeAraPO+Kzcrd4MAsILqUcDfcnUq4G+1MQhAOHYx8zLfLsRXwV6zArBvTIakGd7iMLrODsSWU8FqsWkKyeAmdppuZcBuZs0vJvDRJtN1xlsS2ZKxBTrxUBdB/F08+kIUC/SspmO84Jr6bRZ15J5OjrrIsa3DinpJ/J15kWjM29zzJmvMhJovvIOWAxUPpXDWJ+uaYJCbsrNmqWvjqWPm4s8wH6w7/rBPMabmzhnhmdZh4xCXOshmncezgrid712bpYm/0DeAQkBG6gmbOzSaDjpBfRlwexdqSlZsH8trQH+tT9y+8WfphkbmAMxHZARzdhQD6Eu0zhh8s2RTuCOdEQW6rRgVTrjYzcOcQwnIkMpjglLcQwTCCeOkQ1ZsHktodaCNo3qvLLYx9svh/3yRYR8FZ1XuaRf1XnFpInECZbaxQ9FxV4fIR6Slt1X0XnVW5ROfALZ9BQJzZ9DmHWSsNajxiKehLY9lFR94JOAtuocY5gcrMfPClFQ3d0DSjCFwkolscpjaxRLJVX4YnOv8A0UviOHmTGaYiDqlIxhvk0FYl75CPVRI19lYX72xQm1Yr1HOwFid3Z53klfoq34raylb1iJl6HLj3ub/OvMsI7KLW4Z46Fvwrvy0Lc4HvpmBFOj+TD2xe3uizvdF29F0MotjIhk7MO3uQ81SUUk5YehsBpW1pDHVvqQ10vxQVLKJhql5KKpgg7D2LZKOUa7lHzMlPKOTikDyQSQCM1WRQdz8pHKLxZ4Z4Q2V/lyalKbfJp9UbF4gFIOLTLLvb9YotaLitoB1deYBSWlJezAjTSDexAjJVb5wl2yTviyMZJgTc+HaqBOsqNX5ecFJ2Ooga5zgSMyhgbNirl/WKSd7WMk9RsrZ8ibqELi81RmKFKLbh+eX1xDtriGxEIfa3DmIAtWQl1x17oJi7DCa+xBTEcErjbPK8zzckoBLfzp5KytiUnELerxbJn4vQ5OFoWjE9SqMgo1wyggEWEybEjNsAlkwjXDjrRKJmFFRSJqloxqjktYUb6hVmUSnGtnYRIc65kYGGPt504Kg6AvV3OYTPgKYRA0fDkYBKvs3LUMQtc4i3Twbjp4N8bgDUCnVDfQkrtT2NePMAg9UBOBXlyJRJ+pkfvUBkDBwZJlDCgeY9B7hkFHpYJVYBNaxoox1marddI1IgZsUsSVlc68edGC549kyr0oX1W8UokjNxwptRfl3UcuK3gUAoJVMbr2qAUENepOERA0xwQEs6C3s/a8su32IOo3o620fYEDXZ3wNUrLsahVxAJ1BXuik3kWiBaPiAXagHybZk9GLNBSsUBtXCyAXkmzmSjNgghxq2i2KhaooRYtuGhVxAJYeRt6V5sJLMaxJf0p7/EZoUDedexh5KAxB3TFRkws9WB+O7Z4Xls5FetpFZuxZfPRlkdHbZapiz+hNeKmlfc3grS0oCxtLJOrQfE4mYGUoKZSAiUaIiRr6Q5ZR7DmpARxKSVYGZESaKaMVkakBC1scmdVnd3HmFGdS58FodHzYnunIqIFDIkjKrUKUQFZkdbSllJIoOFM8naxBexS0woJmiokWHDgb28O/q7IQRYM0UkZYPyYdRCIjTFUxfRJYqQygmqkEKKuEiK9wjO7OQlKxkiQ0r81JURyTl9z4IupCXaAM1qXwM1SRJBXxAQLDimXlYqqmKBpxARVzNziQNMdA02kmNkWwXAdf+WGV1YyEMhpmKpigmXshWPqGsoc5a3peUfEBML2KG7OjogJGNtotiImWLFMgW72qiBcoBS4stXg0Yrgi+rjljgytf+zY/2v0ypEBN1HNyO7lOJPQdYWgM3q0t9muJRLf0yzj2XpbzzuS7/eIgU557Tq+l+rrP+bTVVVQrFoyQFd/+OpUzGdMhUXKDZTsW6mXLrJ+j9biaQ0r2HKAdNk2vk67Wqj025znKnrhFOiZLfZTjzQoYwWZS1w237MuYabc2312UuJygkakicGyaCmfoDFEy2c1WECy+fkBD1ugjZVBLDbqadyAl2rICdogYxAGJpo69SmtJUTBBUHAT8f8gl6wM7Gpt/wg2IEQRdJbWyGiEzgMDyhxCjPrHU/RB6a1aDGcB0WfJN1VYN3BoNdUGw2Jrj5HErUFX/xrP544Pv71Nj3sY/i3wMXi8dqqCpdxiO174sv+ItDv/LgfU+/CgKDWOzjtTbW78BJD6Xi0rq9sX57ae4QV/3kYhoGcQYhnU6RiMEj8ektOtNotXhXj4lDxIHEanNlFR2pK/oYh36NtEEv4aofCqj9IthzwYg6VVl1gFk0RzWIfKO2dLO1VtF5DmRQaulCbZCIvfnsa5angmYuI4pYP2XiKMMsWMAgRIQDcUL+VYwGGZMsitpcUKkTNSwSV6/yqagaVN5ecz94I9eH6WIiqJNdjyjoTtOjEx/h+ubxBBrRIxFoHF+k4cRHd04RHwX/5uKj6pXp6HiyDXdl+h+8UMQTrzTqgaC8lakpPFgkzwxKT6cHlNdH1S1BhI0nzvr5QoZjQ4Ijflpdk34iF2W4P1zE+bB1ahcPmBe1i4dcmIVoQUmcSG/gR9CkEtCkC1O6n3y1aokAb99cJGBpdoMwUAIStdsafA5ATQNrGLPm7rt8wQvUJJSVygSlTqRiGbdBNPH+uTQQfnaNZCOjRChmaiF7Mr1dTPX9MOD5U1exy0QIoi7rIVsylq02me0AcE+uC4EMlNMizP5FMMzLHsITH3/cA3p50Pp7lU6i8U8eRtbsq/hF2uHSEOgXAh9u/m1fI+fXsQ6zNw9w86fwEglD/MGQPDXxr9ZmqN7fBa2GDSA4v9ztr6F6yNMlKdu4XppNQfaqG6Xh2XsQQ3VOPhiJdxoEHwiZVL4YN7vqchGOH1yd37WJQHKUJ/MwhLosZt0NKLIIsFRwj0Va9J24kYFJcRMsyKJ9N0Vr2Y3IiPj+Tf6apGn80ett/MGR+DdJPHaoQFyGRo17rjwaLHgg7y7t34ckJ2LvrrnYw2XsRdMid7vID5eRO6dFdqd93poSWcZo0+s8qo/p4un9/5o6e/8D6Ajlfw853YWz0oCvj2+w290w5rj9ARjH27+vrdeapuYPJ/N/bw5amP6R54/eQYydW9P+MVBeK5IBfnIITao/FKDLXYqBlD91lVDyVc0HgxWaL7P5WiP5GIu44DWwYrd/6fpDXDwMF8RA4lcDN/W+8v2emme5F08urHtBcI8nhLPmY7i+YF8yfnnIo7h6Ze9X4wg6iTAWE1SFy57mkLHhGvS+zTEP02YVkyY7sLHvt35t443xA+fxtf4ny78/unhg7JVsDPsM4MEnuc3rFbfJ5IJX9cr4w3vJBa/sPeQXAUjRJT25Wln7tl7ho5OlzWUfNB37PWMuKrzMjGc5mhhgsafxMvKmm6cJXkAe4fk88sSrai17jVIaEMmrUeOzgXMylb5TY19Cvhq9uVy/4TQ170cePF0pgNCQe7zstUJj6oq5SLC2kECBUXrLmVbygXR6sQhf3+vliZaSO35JbVd8Z/meHUIFapoCKZdjfXK3JyPMSo5+tmpcqQfoQXmA6FY0itzNtqpLYLUaTTXtqShtYlncd9ut+PfHzDE2KVofZq+TZviKJKLdeTvQRtzBeVjQb8ST3w/i6anvsUO61Hjigv8NKEHtdZ2ld84CXZpSjcwKBZNGSq9a41GYBRlabEkbqrqvtjYl9p6J2HrbM833jeWAVJssd2M15003akWVrchfeT5OZSqTXyerLOxCg7M34qsVTMrTg93nB7f4COq+NzhkXzKsj568KHtyv33Bynmnr5/zkjLwJbabxzrt7+UkmAj7tDH0co8vNun/+/d/7vZbb73mAwM2Mvm+193zk7/8h7dfRC4IpvuYrwTjbjwxCTb8Crm4z6+Qiy/zS3pHFGLhD6vEr6rvfnbtqC/GuIxO661OWjtl9vlc7EckS40QfpeGReVVg6LyimDal0Q3OUXHD1G4PJSVE7SrKcckc6CTdAGkS0fvh/ExAIWLiz9yo/P+zjAsgnKzse+hn/viHz7n+664mMIeEt8q+DDwDxTRxgSJi0dIXN2RuHqVxNUdiauPkjgw9SGTOH6CxGE4LYF7EAQuPhGBY7BzjwDmcgzA/uGWy2VtT7YAh/08cPdCDv4/e7PDN1o7atmPalBM+wUS8ybE6KeYBdWRrdZGoRQA6her5jV5eixqjD+EltTpTsMImkNHUcK17Md0+cJs7gJ1nYNPLB8qBpDxyQM3GQMdzpvtZHTOOuqp3vDSG0py75uf3isNut4VlXw5RSoUiMG36d2GQ/KEedb6Bjb7t+Cdn4fx9GTzOohUviCOqpoIh6pcHVkuFvcpfaaR2NeDNhoWtgUPMMwa/ugh1N0ybKxf9RZBAfs3ahrK+ld8z6vN8ofvl3+f47cZisB+5h2MLT8zijdY0BLkcxzxca4ydg5YRfNECL6pl0IoXcjBDkcMfGb00JCioVwvOgCPRAsU4XjgbRGlxOH+2yIeIWSEYi7iNU4YX8Rllbg3aRxPBf/NeBz1KTlya9FEeEPDi7RIzSt7A3FAV72LfaXsRKipQhMxAFQs6C2TykYf6CXsIIq80y8W8UyKJTj6CqjpClSHTMK7QdSs8jbwU+l+qIPLDfwGLYhWOL+GL+HNA8PV1Cz6sqnIuuZQxLxeWRcUpXSN5oyjBOqs5XLcsIbCsJAuMLo6th+Ng7gD33EOhT5o1DxgLKb2VvNlxIvNvVXoN6oJC4FZrYBl3iY2oJDncrhNS0NaXAcqzKE6aCKivts/f/3Ru1/7lTd/lSvexPRFkOAAYh7VRrrcATd0K4KoD9ko7EPGc100EbPbxHy4jNk5EdOd+Ko1HqOvBnF4ctpp/Ho/xNTF36ThwvAZt73zcx+99Z2f+zJLCxJ+/dit8g7hATYiETDfbWPV7X528yGzRqn3Ql9vxokFDjnsVANeUKIfuasIXkdZpoYYhkZGdcxmsp27V0qqiS9IcCoxI944lWZTFKVY7lltv+WNmDDspP3M2K70s0/eaHymWhuWx+IoKB1hGmjsdlTMU3UV9dvMpKsPlthngWJdkVmJMLTklHeFIa4iqdwftE7uh8qv1J2tCTdD0Z7hEbaXbIjTezh3SOGBjYJt0yZmubz8YnJBdqaVgLpBgOKmr7o6Eoac8LaaN3V2pOSpTemIUr1V1ixt+LWEh8r5oTak24z/boz80iRaJY7SPNSrVLghxe/GjZB6PrFggKwUjw4eWZ5RS0nol7F3FXl4Yzgcg4Gxq3L63iHNrMPpots5kl8RFqNSrCTQp5eeFqH0tEBLaRL+bCkCjuyG6zy3ZzdgflxNyUHjDn2BWzuOY3MyrQ0mpQIGCtHiA/ttBGx3lFZUyAWv6iH1juE6P3ziP5AU1WNg+M+Zu2ECGm1sohYYcGxTF/0WmhUpfl0IZ1PIqYr6QST1CiwopVLIJlNYNA0flsSySXVUpucvWocu7oamK7nsFm2RD6OZlb0ixj05wu0XyysjZN7nWYf8GB3bMSxIEPmcxc+zDHPPwd2WuhwL/Q4bg3GGAtx99Gdcz8+rz/e/E2X2P15jJ3qgG3lgkrLz/Usk6W5NUgaSiZ96uvjO7I9eJ+wMV1bELkblJHiVnaCT3MoQq86TdWaHl0vkNLhIGetBgOzpSrvvMXoEeUcdCPUzrOnXFFkPFA4GSFQrs+jgdY48AHSejzYWbhWYHbzxnD6viQGYHMp6XD1Ws4W3FIsPxUw6sdyNuOZr0dytNHsrzQ8tJdhgS34t4whfBXnzvArSAi0e4VwcCb1SMeyStTHoGO2mPW2rZT8JgIk1B0f5EqV8eUY+g5F8nur9n3gdblP+A2hG/0cR7t+LX+ltL3uzUkrImRayv7hRXhje+j2isy9rJK9bktL/zOtRnvmuBIV+q2NpMuuXOvKa0P+Tg+7bzODEZ8xbZmn0/zQ2s4wchnRX1bU7Nj8s5TFZZUt1bmWvtZNq0g4PwCkxHDB+HgwmDbNPo2V6E5287NfUzGwt/X88b6pzOg+ypQBHa2yBWuQn1kD/qghNEeqpYAkyUUDtt98gnzpm+vrAC6YZDjYs2Y/f6MzDOZ8RkRxAlBvys2sRJBbY00Xg29TWvb2jOZouqUCVR1QF1rvOmmT/CWTXe6U+0A2vKiaI5Bqq2aQEesMZZa2JMqL87nH+M3dJ8Nw18YeEVmshahW8z6DffSlaUHrUjFQ5KkLj1JccaJoRIcGIEeDsc5NvU6uIKpVB9jzipz3f9LCJj6qcQfrDgZoxnfD/ocecQA1DTPWYNXuLSp77Le1NuZEi48sje78FSqLnRUiFJbG2lkiRaNmulUQJD+gZenKVopEH1IS3Dhh+UiMnMpyg98qxhnh0YJRUiXFgEwJN4CRNUPuP1ihwC48WtcHWto2iGlox6i1B9+pdxm2t2ew+WxhYs076OoqB2lCdwXIiUS0b1UHlYp2dq9R2qlNW1yIshwIiY3jOjce9fqC7ShLHAMa581D9A7Q28qi0ZpMHJXTNyljLHYMA821iGjmwErnASuTUvq1c4S4L42RGC3dK6xIKnLvy35U94MKAomFVkIdRt7T72/cOhoIMG+uDsqyjUpbbf1Jks+8VMSACv7R3cCXbwcC0GRri+e19xLy4qPOvcGDcXprez6l9VLNylT7u/ZG9xuXTzYCwxzhfIYLkDQvviFSEwVVs9R04Rirs781Dy/+XZcCU1t8zIZeFMjoyHGQfEulPrPkoclAo0yICLhy1n8EYMCcalFXPMD6DDHay9BAhuHXff/r7Bz+8/UU/7WFPgFT2bTjMfs5a3yB+uVWsbfi3DSlY5x7bAwtvZOXlvLdpzqFC5WueM7N5zB85cFDl4URPA4zBHJU6vkemeignWw5XKcp+DQmFDhXspfAkEY3Vw2y7DZrMXEZ9jRXSz/M/ynMHx2biwVAr+ai/lr3XCW1qdr+we69FncFFw4lai/COfV9++OMv+6tTP8s20aIqMhdipPvKnom5+yLYZdlNMXfUnU7M1SoHkx8Wuc8rPX/q0qcK5CHv6nUNVNXyBd54I6giLV0QF/SOZFI6rsnKFRJOG7av9aOXkqeObD544+jq+HiuvO8bL/ua6vnSUc8Vr2btfwen1ZaGum3H3hKJlVvQZM+cEIT4WBkQDDgFXLCD7w97fqBnaDLLYDoWleCk3YrDYZgEq92IQJQnyIZvpJIbPpT7IVySAj6KArKP4ZeCjSHY8oqNx3L7zMRoQ9+e/7GP9YeGDLwDR2y+nulVxY9aT7nrerCkX0/lgnwnOytdJw1kjfSN1Pbvy5SE83NZLIr3KybIHBkosXqIf/J2bO4H+qrQYojWHUaOqqeCv+xNUzNRgOAgS5UMsEypkKLSK0RQoMoB+iYksyLl1UiZUMllY4PQ/9AGWwKNUuVVNPGwzxK1VHuoMBuS9/x8RGuDwvS+MFCBfgXXPE3VbfqGN/XgzMeJBCcRArdwAFc8R4/O7vKKQE9/jGz+Zk8T3uVZyfxhfPhgTWXBN3lWGOxBSVgbrTDSbuDbg172e4CinM3lgbJM/4O8MaQ8z38B4KulVtzzmtO4SE/jQvaNKM4wrzKHfSAFesCHIlqliScKKwdzHuhhTXsMXnOUW3+ZOQgLdfVv6eofK7NqJdkxf/dTejq2U8+sVlW2vcAPc56hHo5JQvfX5GgDwb9DsOWOtSAoQHHkzs9CnJ8Z2b5Wi6hsNErbD+YJn6DLo0du2p5d6G310OytAMJE7C2TsRXiEqUPh+KFJJiCZSA4x8W0wGJacDxMCzfDtPBkME3nqMGvY68WMOrpbwgPJZHCL97POqcv7EO5BhEt65wiepaiYMgt8YuIca/EvHAM8/STaHO8mzwQfoR451u8c5skh3fYaL3F4Z0/gnfhI8Q7n6JRvPMn8A6RE5iH9WQa+ulUe/zRz08/4AehHAnJ4vmHGN88ANCO+XkoT08VkhK8ZGa9jNWkr0iFqyfqifOVNeryK7FsbjLJyidTD9eTlGzBxy4CZ1OeQKpXr/V16KuWOeyGKnTLqFtV1dDpenaz+PlLlDm7x62U53ADb3uzlmciWC6YlKshueBVOJasE7cfx5HJ48np/NGrxzidV3ti1NZibai790hsRpm7ObK1v8VOH92L8yPMblUuVL9ETiOAkVdRZISwq0q9O6m8OFf51pb507mLrLphHOWF/Y3fY64fxYXIEIqrAGnHm1GnKlTqRj+AitNez9iTBN9zm3LXhO+teqnvro6WKk9VF2f/AfXX9JD29FomzmFeLdRsV00lGoxwP/D2G59R+452DVlWyTdZdkoWv8xyOfaKQfoCgSvgzrDEQ/qNsLLmRVRajw9VlsDxCAeIMsQHV8CMtxrJJr0dbXn6rWh6ZiFHfkWDVGtCARJSQ59GgRPYUaFuYfqXwbhuwW6HbNPUB1ihDo1RRzqKZIIDKnZD3CpCErdTRxpKpfgMOqZ6XUB/VteyI8oZiGMqY46U5CYmQqtyU5W3Xbj3e1kPbwtlYiYyiTLxAGiwMQCn5/VMlwpQnqHgqx4gZ+ul5nL/XEge36qJInjKfhovRtrRAo2Vu2rYgesMA0yth82f0Vkgpn0kf5HIaeca2kGJnIGqUXmxwHYHaIh61oFLFOetFXiqek2F1/cu4c/4gVx1QoFrspHTMzFfFboNlVMXg7Iupina2F9QpEHrftZsRHa7rcYi/7gJVsv+RAjBtmmxmJKq5bd7xAuuY1E7GD4mLHfoeu4kNf+v5093m8vgluULrftVFffK0lG6ptjQ9cwI2HTJ1pnhrmNXZUKcodLQnw+9xnUTCOz8q/kirdN1JWKkEVwz1xNUXpTsLxp6IpKMaPoWULLHVQGZW868AlJD7iJxmFMxAcXNr3F1QzGHDpCnLw28QFWgcc1L+/FLuYjsTqtAJkhkzGmVElrZLzfsvhDNVAVMOTCitC8XQeRLlE4+2y7vqVyDX58r5EaMwHiUwhBbXqcm5zULJsNBGldfo+iljEP+S8X9f3ANTk9iFp0/wyPv7a+5EcfaVTdQpYks1GstXaBcnZHdIjYb1Sz3ZKIDUwVzOcAlorzAaFNl6maxxw+wHPogvSa5Wjq33YnQ6f5OnDhLaBVlmC22LnT884S17OfsdMxEwzUTTMEoaLtHZsKfP6KLCd7Uiwle9WKCd6KLCdc9Wy8ljDh1q1PY/+rofYSfv3HyPoL3b34f4RdunHofwZt2H+FtyFtLB74fX1eq/+wugeywXY6cVHysSG8TQ50KUSBvCwCNbOgYVw8giAkbrlEo06l+Dft0ruJvnZ1YipeHOtD4Oorf/ppnXPfqG4BvvuKbr/gmD1J3Lqv88BXfEFJ805Dgm0dKuCRbjx8lxr392qd5NWuyWSmD9EEmhxFpu9mCY7H/g4yrvP3Gb0TjKr9448kbV/klxcafgnGVfwNc5Az/irjIn6hy3yNFxb/yI0xWD3/XbgKmriLjgvKyvtJ2XFF3t5ghEmHp7xp3tkguNzpgOSLjlxj+JXnGddfi7twJwBCdGAzTQcDr7EaeOjfLAfYs/AN773LDXhyaOE0b9SEYbLidHSfnqqoCUGFwU2u3Ia/bUzPuwQ3cRXgXEqBwFECUB+Xd84BC3DacAPXZVZ9P+BH0Uxe9hh+hmr1icSKPGTeOecwIj+8x41e8QIZ4yt3N2unYmTyDDv0sbB3/rN2En12rqfQ3pAhaQubowkOVnkbK5OMmk6/WgNj1vIpmAVjJkU37TP3/jX35Lv2yeomQvEd3D+ZXbhy/B+NV78F4J3kP5pWPynb1o2rxu2/8t7O2PepMxRM/8DeOOVP55RunO1MJ0crkeMa4xzz2hdYY9y/AOYXAQ/fqyjrqkbKv9N3rE++NdKW6tCf+afvXyeR6KT/9l1xjVhr+ueb/zX1j4jqVqulSNYBdhBIp3vf/XzIuFq7A1mn7Zc4EdjmzArmx1CeG10uv0fw4GHnX49hYVPADJ9Ne5Dtxk21ryZbsWr1NR+G6bxsZAU9H4EQW0x8FwXpkuW/2/abTsjjml/Sor24iP+KvmaN8ksLqsktOjK51QyQ/R+HxAjs2/F3WE02uBgZGdUKhWKpGPY0JIJEneTAE+lJoNXFOjlIrMlYZomlsxcjOAR9TyB8mYHmyzwjzwSXhs6JNIT9Uz6I9pmeBwooWtw/F2PU4eamsGaEqIoel/9PqkeuHkkg9pUT8Z2HjLvO69eA4WscZ+dnfoql6X3bULVMRZX+HNJXZ7cVe2NzBvYTPKQE2PemPcRGvqFO9ojJuTCf4+3ZHP3zfOV8780xcTC/lsdMvYYjo1rkQS6gOVV2XGQzSupgDOFJsagMgdW2gxnr2428ULfry5r454M+bVOdyylPHK8GFlOe0A67njlupqffstbTvd83nbq1T/Y4h1bG3PmKKrGiiNo+s5wkwIdLjSFxOBnJEODcPyb9AFHJCc080VNiDgRnRmngo6IuL9Z1rOvGyBzAYOgrxBiNJVIV3dHLwjqrwro/Au07RBLwjkXAzvCsGARoj8G5W4J1YeCcT8G7gpsYovKMKvCPAuzHUaqbCO2J4R2CopsC7wfCu85QVN+ZCJOE/w+lCZ19UyPW/eA72AYrqauYl+xKSjFFB3WjsFYEyuChAtHo+iGmwb/zEUJdNToFHTS3z71Gmmog45i6hV5QpayqwjrMNSQqhVDl4A6+KEp/dhkwy8pr0LtWPNLEPnKOfCQKZXKoYqT2T+D4fZpffaILVi+T/rF7k3/kVKZzTWXeaHB989RQFPwcBp0MYOx3CeFKH0KVLKujlI6yE0QWyRP3gKD7Qk4iAO/MhfZUNl4jTrXETEeVBOhxCAEwwK6VjqplDEUJBX5CEjCGbxMUiqcIjNAcV5E/oCwbcuN9WrBD3kcjOIX5SMKovGDlZ5Hd5/jRfGH0vD81hlmWl8ZKI+/wUQcBG+v4bN074y/hG9Tz4B4/N8yBcVJ+050Fn4eKa0DM3zBwXFjpiosqdypOJWaBKgvo8QE1me8ar2nBA+Kvh6HDIZNbaywqtxDA6gYOTo1MG7P1b6jhw714X8m3ulZfHdg4+4FSJtIXGkOdNP37ci5oRroureT1C+AuV8KedzU8pJdUSb6+UCFJ3GO+aTZOEe7il8sXbxr4YuC8kSb+4s/LF+8a+uMt9IUn6xYZ8IVysTKC+NKWkqbk1DjiYHo1CFauq0aIjF72EOcEi6RPxH0u9G2by19WsvrYnb7Y8Y7oIl8wQPKjBlhwowFEDSlcbpqH4Pklekmd9McuMYqRh+Rx1MGDziJEe5AtqFrWpB56L6nwFjS+WEd+lZUQlqBD55eSo/+WbJYjY+zUYcvDTGhR8VYtda0KinAcpzHZ+XyL+u6xngQCDY7FaGoKhdnGyAAnWFjF5n69QQl3KDqyJ9cpV/tu6iZ2xbWLoKyA8p5tlJ9qe51xJF5VwZ/fQql479YkZO2k0bqViGwgb1GITLIHJMIqdSTWUTjGt8JdymytH+9yxAgX4LCd5ZnmeakvAA9hnsYM4/eEvegV8BrTs5Sn7LHaiIvPVnm+xz+IUrrw4tUz4dfssTkNChIS9fK3oKxfbZ7GLC+JqSNKuWPnedx17mn0Wp7u0H7g6OOf1W9afap/FGZpWnElnckiLVobPPouz7OcUcQgPCbY+8o53vf8tf5s/3T6LsxH78T2HPvBX/3zn0+yzOEc/l46+/TtuP/jcV77pA/ZZPAFQRsrhxd/dMvD++en2Wey2Kf/ff/jQ0oEP/ccP2mfxRJvy7O/Cv5++2D6LJ2kKYPRk4h5VGqxNvvYTv/+fL/zjzz7NPotzpaDP337m6z/32f/8AfssnmKreMVX3/Hdf7H1t55un8V5NuUT3/shbugZH7TP4nyb8jMPZrOzs9dfbJ/FHptyqTT0Nz5on8UFrsER8Xh7BoHtszjz4W9nJP+kV1z48HcUT6Xt9FSMxKk8WL/H5fkmm30WTzXZH/6O/CKK6MmEzyL+LNLPKumnkqKmVB0REJEE7YgUyahEKSoRiCy65JQLutB05CBGBXIDT2aYabd5miGkyoChNfnYgBGGh8xgkAE9GUCTAStVgJgTUQmyndW+k4CsCoCIcgYBMp3Jmc7UTJX0bSDPIIpdkKkzA6qoXHtiPlTJdO4rjc55I58XIi7eAooDCy1bXyxn69hqq5Y4dtiJpi/QWHwB05ZP44ILauEmg9rapKeB0pxqrA4W27mnPHYXkQQuom2ScNgkbKNIEyKYc9TFlrZqG/ibSGhaIKuNkHNuAhe9rRL9ZRsd0UUYPBONJQHRXN+pJppWsY9cpa3whLnVeRBoMmPcD/lIAZ0MwbfilLd4OgixkPmLkXBWvhcPyvs0r65zhOg/g+H3jH4d3qwupmccyOfLyvNu2bx8pexAvtX2UxeMJii7dXtl1xhuE82vCRSw1vSJH4DzIjLnMUM54Td1uRvLSvA0GPJ+ceHzCUBRiPkvxqRV8lGGD8uS1QVCP4JXiK00lpiZROIhL8tZGc9FJhccTnTHEjkyAV4UfazNbWmtTwVwYhGAXzSApyYvZZIrVgf4MHMru5se9dZoeY3rF0O3rKcPJQFf7deCo0BIl5VcFL4T4pCaJ8YI+4b5FGdTqCe+FOYDuXJc7UTUM5D+DHq6MqAZFsqMZhE5Sw1EOrakwo/srfA83Owlq8C1q3gaTw7dbzVpBhsNY16yR/PC1RQrGlNwE7by6PJD9lSJ+BlZUBRQT846Re0b5jOK5Qq6tGDuSDJm6Q1V+EATNzv5qfKs5WdyohgfRiG0pR8JBhXC8OSLPNxbaOUAdRW1ZNh4Bq5S7HyT6HCdKbz8IhggZIQMw3gpiSp4VBAnxbRNIhURbRJYFUVSOjWPhCwkgPwWAHlLX9h49TDXpi7imJuzroa0n13QlbIrhenKonZlC1ppmLkuAfxUCMhti2GjXfCkMHR+cfRdCUi1na6NBdpTmDYugAVcIB1hQVzQhLViiRr6pueUosECM6GWk5bd7OwN2IkYdULenNhd7GVy/YGMVpOPhhe4JaP7NNn7Y09oHGDmgfV+qQovqmdh7s+kfxNGEbwm4AJ91SRhpHVpgVoTPCqWHot1f3/M00tw0RSetCmTOSI8yTwz86xsB0VyCyObapQ/weUTkQGHIg0OZVPIQIR5h1BkuCnN4NGBhQlY6amZG0fWiG3bbBtaEksNuCwWgxG50OsGtTgGj/24LawWWKWesCyWUhbPpfYYcQZwm9Hdph4zRvlMP3Fta9MMpUayfGXR7nG5KIYD6WjbnLQPLZFuZHcUHRUQJISj3+zXRVg2e6SY2/eDN1+89pdP+B2S61KzXGZnQLODIc3RHN+E7/gyBg94MiwAzcglqY4emnZKOR1EklJGGUOdI+sAirrhSUdvdwS12tVPHw5wuRC2tkSUGosWQUZp9hGrnwek8FQswmiFS4mBVczyzQ7dmYJMX+QHU+9r+orLes2oxa+BNZCjYRFzWAM5etQF+9nZb+pVNDFImcfVyxsRxYP05wJW3tDd8EfHdsNH3W5Yk2Q3fHdl//zpsS+OuS80Sa1JyRd9KY5qZkpkbxNRHxZwjzx1d4RrRRL1oEf8Fpi3B/BWNf0WrAuy4l6OG89egfxYQaQiHPxqZUVdVBplcJwEBVfKxJes6iBar0gJEDkxdAfm7vjjVfxkBwof8PXh0A9zHgvn9XIiSHKzj4f4t27UG+kCBvJNF12bEJA0m7dsIpTcyeeqUIGaJIvK3MYnePorjQT6rfwn1xsj/pt04YK+4SqDDtAXxgboXjdAmiQDdH9lSA87i1sPmBzHsFDio/P8oz8hUdN1aYNjmkoI31sJP4CwNuAjZTA49JMIOsutH7yOPedLnH51SyV8p4YhrvyoloB2H9VYBA+74IYE7zYRd4Ptkx5r1zAD9Y7HIQ9BTCLYltMX4EM5i2C2XK3nXRC8jAI3VC2oPr+EAmOg8erK/SCDr57yImopJnZIWtSZGr+gL8NAkUGQACMtUbjQEVCgFySuQFBvUHxP1Zhfljck5dNIyRDETRGrOP8AYhPREtQB1K0INTQNl6JVr/Zu1avlo7I8weNyLlZno7+G973lXEREw81FeLl3/U3WZS6BganOxUTyA2B5HdTpKlEPjUesjtXLWyZN45UiIf8Mv/ZeTEznnhIzMjIC+aablRmPk8xOmZOo46aRWXXQV2lnUwYD+qjo9yhQYGTdo6YxLC/AVTABALuz3xbS2dL2t8vJOoN219HulqqDKFxSDLdw5Epkks2IjLvVgS6J8O5GXxe45gESpfAZEBz8au8svTCL47e+En5fZNDuKGI89xSNI0VndDWUBGKb40O3VgENYNMjw+2QDK/JcDAYYM0bykEarpSgKYd8Eq6JMJBcF3qqdMlc0vArqsxqpUOBfumEofU1D/dmst/R20UCZPx0B+S7O5Yy9zbuKH1C1zbcMaO7Hkw4wdq4w13dHAwrV4YHfAfVCyZ1gvRwpKt6d6tuGq/mHvFjQa/uZHmMRxe2fqimWnuhEIoFCa1itunptwhvoS9dg740GEk9Ffsouli1G/5ZPxSKPXr8nRznSkIDhra4XDy72HfhJDbBUngJP+ILaxcbL/9Vq52qC55W7xgF5R2jePwqfWyv0sdiFJ5SYGMqwsupd4wCOdsaMdcZrA9FbAE4ncuPpH8xQ2cPiAsOiRM1YZIo2BOAfUEzZ8isZ8m7ERRV+rPKEnYhpPbDVvWDFurmuIwxESD+Q/RatqTu4DJ9YyJgnmWz4dYkT+AsSot1jTC7R+wJy8pDVNvEujSE5g2qo4V24eM3T67/1Qk5BjZwlw0c5QCWtpv5iQXqdnnyJ74+79X04B48q4vdMVvC/TbwoH6K2VeHZTW7flFN22TtkVGc/ZEBRP/gq3zn0Y63zYjQZp/LR7ak/c5Tsc3s3lv8vlp5b/N7Vnmf4ffQvQsnHVktUj1b6B+kfM6doSKZ8RZMGafA6QLyF/PUgOPUwhdjdtSkFOfPH0frtU/6XUAmQwtv7TIPkFtOTPHYny/oGUZAM0p523gsKh1ekqJlw9+lpuzSfVrGrp2W8Fsk2KZukW32okSsGNFlj3p2uwpTGJJvhZBaRkPsEVjpxyIeLGbBY4mW8VimLXhsoS5EMF1aAB2keZrDH+shz0Jt06NA3bMrp4GytD+L2p9AmhwYHR5upfIPIJZifyW+sqc2gQJMYU0hl0J2mVnEY9FaI1nC/F4ygpiDaveRB+8KOPCZw1Dlc6SDZeV1nfLeSmfi3go2ZWXyzLTkdpncnpbcKpNb05LTMjmdSKamhkvcyf5AzeLWecI7taP3e3LAGo4csHrugFXV3JQtCMjbEEGH0fSOIPEAQEf2itjiGmoZ4MZToKY7wo0jJs8CG1ipV89qS/fbGCmq29NaXq+c02PPHtD6woZmv4vODNJrxW6BNAcfeYw2nqCNpye71X6M03YbkVQouDsaDkwBVQto5fUrWQDSF3ve1AW0BoocMvpk5L3ItUnskTstd10ldb3s2nub8PXGH5Gvi+THxhfJa7xw+uE0xkMPXZlScgBh8vWJU/kDxD8C1wNFYLUR9LieZ1yo79nvSX0xOm/gnX6l6fVKDchzVbl8Dydh8j1XTTivFpCM5nXRsJX7uLDR2f8h8tV83cGvQjE+T4Eq5mqf3vgr2uqZtgXHx0UH27lsfz6rPiQi6nBxmHBt6uyHIvY8haADkMt+rXaZyJ9DVVJfAqO9rJrqXa6WuiI030KxbkJXKNIKe6Li5y4ZFqv7i4wryHh4tpJ/ADXi6EL6UGznLmJyqV5EnVjMtnYAsiC8MN3EC8g76FosHHL2XGgJbqfuZSul4CiTZyYkkFsaW0N826hDK7SKBvKzh2f2+4aOM0zUA16dthyQliIZpc3RVkpQL3Ug9OW2e5Q9washnfcDYKDb/VDr9bVaD9W2DMECsFH0bFk0TRY9v3nR17qiHbVEuQL8NoGplUHBkGQKE44BkP39qq2yqOaLPAFjJgCN80wqXBntwgoeK5Shnsw4gKrraGQYWwVdXbVHEjQqoQZQpUFN/iZvmuNm6PDo174O6SjW+o8Ma7MJrG0DayNqA1uzCra2v87Y6v/bYuuxR4etu/yp2Bo+ZmxF0VOxNfxGxNZwc2xV0nup573CieBBkz03G4sINYeEh72JFhgVcnQ7dPL5qSUBUlNLCo9b0u8Gnj95NVgBenMgu169KHBLUN32aoZD1Qw3jWSA3iXMSKgB2pY1LYHYd02NvXNq7C2V2KPuQteNXqXiQ95ky15WSb92MvlAJfnqyeQrKslXTSY/2/lNcJG7Kt+cNfnNaiWZJpNbleRsMrlWSQ5HwexE2nxrO7CqdW5rkn1C3fRQ7fltz/AVepQRORVcObQoLWWwcq+zqRwYm8r8keqlCqv07maEEyEwayPWj2LLNIlf6tIdq0qgq1fh1VnUMG9AydmZjKZ6W1PyRiW6SY7vIwi+f/yTp96fnjP7dLbbxwcue4y2aqNqzAPEHdZAi3b2J9bqBHaimC6NqjW1maoDN7W9OGJNLZ+pSBb0JISzOS3rItOh6chs38h+5qBsTvXqGuzBodZEMVwuoFEstzIBS3vBbVaKEPWJuUq3xQ+nLyeI81ogAxHAQ2dY8JWnFKs1Azhk4rpgj5hzY/tAs1rPnwpjnTftcjoPkjRvqtXFAPkQkVROfkqLqcfg6Viy9Desb546kDSWMjA7ZTm9U03fiJR2r3Dbq/ZDDI20d0gtssORag86VNevofvxv5CCjRW2ygP+qMM6/tWxSqlZGasm8fvIWJng0YsGGDdpypgwB+t1XVlfcXN1WQ+rQC+fr0p55NSRhSywpwAslrP4gOpuX3SsIpnTEbdG+Q/+4P9Xf+cz1od8Roh9BSX5LO7t6gD16/msOf7qW7u+8C5TV9y8hOY3INXSVaZutaubTggoGIhiBa6YlQ2xLn1mII2l+ex/6xquh38t/GQFqkIokTsFVOdVQDdYeT1FVsw66XFNM4gzznfBnqHBIi73z1CualEneHBWZGxhdakBIy4pu0IJvP7EetNxpDNaQDHavVivBMfZV66X98BJNdFdX206F6AMwdiQDlU/lI9uvgcXUvR84LjDlKdjRdCMC2Nuj4xhUHG0CBOhzQnB7L69jKeuwUDKJuyJommAj7OkNMP4kV5/ess3+s8JS+1aYrIlenlUmm0p6nmC/T3beNt7jRXjVQikwEN74E4THJCa1Z1+qpc3mwwPnONii/yctgfXb8GaXHpBRb4E2xSpOk8Tp94x8aOjYgbo2mYIehKcNd9AcqIlITgvkHt4QbVN8kU0yDRJKBtCl4PpwJT1tKYl5plxRvBQAM/M1BWOWS8dpNlfCo1YNJ1CGVvEAPil3P5F2FnJLrVxz+O4FApKz0Wa8l0zWgVrqnapQ/xYKRdEc9Gca/Txd2nPen/VPmqns3e9eiwv5myPA73KB7OUmYxdOKkLj6q8bEVe9kq4C+B2aQWPFfIhH+OWlr5vwahuQXlYlptyCILQKvSFoTTWVIJl4JNvVavC2/BQhRoK9k71FpizFsVdAdUJgYENHLaBgzbwgG8C99rAMRs46tMqEcBYrOU7uK6dPKJb5U4ZXvq+aJftzE+hZr6TdtAp/booJW3jEBBJtX5Ope1kgqf1Pejd4DPFHE4oIGqEUJJhqwphOZ3mlIAE2ZAP00ry5XRqJbkLBRsGLpZKgJkpKloCxw3NsjnNzZqjhpnhU3he9MWKE7dn7kRtQTu40Ka2haGE7FufY3YpO2krb0egZ1m2bueJW/f1A1aq6E48wjsN/pvBbmqteVdL5e+8vMdt2WEhRV1UAcitVVWzdvK7aeXcWFIP9Z/CZfeozZOhZQB1CgBF/dalHCZsU4iaiFpkaoU5voE7hZW7dLcxmdkFJ8uAXwePU6jOMNvw8tM14OdnBHtLRFOY0BkKIgRP16CBKu2iBVo2EK2Aq4kNc9No5vRntDSBVrNYqQ6aAs4N3GjFPHlPE1i5GvFS5NWB03ynUq45N2sFrSh5w9BpNYIKZV3yLcjOKRLrYsbL6XEA4DtFnqfQsjyXRYauBAq4scjBwNKqWv8QNz4A7bUWtTju5kAEDzcFuh0E3TJpoXJ8osnkqHhqVqNGqhvM/Ez9MD+Ls2F9Ks7mXNNXKHCUeUZnlQvVOXQm8eMJbqFadQvVlk0WKiATFiryc5LFavY4i1WDPCWBncnFagZp2EyYxWq20s2ZcrGaJTKL1YxbrIhmn4s0Hc1ziMrF6gnji1VGqSxAhL/jL1Yu77TFagutakZdnfK8XLT4QJAxCTinq1fuIiaXMAJF4/aPLGEzk0vY0sgSdu7oErZLl7BVWcKKr+sStkQFgLv4f/kS9s0lbNEtYYv/JktYoUtYgSWskCUMkx9L2MxGsZt2Tyxh51AH8HsCHpUl7JtLmKM/bi2bSDr5RY2wqBEZYccsBwMEhVznTd0AH3fftPmS5NaiGV2LOhSRrEyxrkz/x2+hTtEtFD9W6Bw8GGHxOOXx2FDt5MDOqRuqFblwkFPPrlFdRNirNqfoGkY5IibXqB4ejAd4nPLNTdfXY8X65or1zU3XOXjspCfgsePf5fq1F9XIAoVGGZK107xq9TZNMUhfqqRsR5m7ktMRNq172uq2E0/QAHnuOP4WDkGjeZkeiULPOPYdP/dzrvWSvoThfKo00lzjF1W9y315h6mcRE9eA9BGNVONEGzbi1KeWr0PxIp0YtSPQ+JkHE3cUymrCFAakTy6xlghW9tQ4aY9Q1PtF9HsVZW5Ij5S1MdVf2FK2h8MYAGozhdhfDmCQlleqQycx7wWQNLr8d/Ty2ibs5fH7i6O3/JcVlytcCpEsJQzmlGqrtjoOcL1IzIe9byI7hDD8/nGN3UJ7ABA/uMRICOOCumWaLqlVYgo7AxEgpOGSO2kIVL7+kDEnVtOAifdCdHC18R14D3IUsD3jp6hfcmauE6/nVWr3f0zwTu1tpd7Blv1ehgO+gOrjG71AvVYvHoQfn0Q+PB1XTEwGmoD9SAvUk2vs1STehdF/a9th4Ja66V6SIGmqIcfj22lBPAd7jjKGEbbPbjjKdmm0DikyP5czmfrMkr1K3vIS54ov1kdlxDaqj6xNb9XI2uiVlYTtEpN7AcoLpPi9vcHwQspzH4GZynSaMw8fqhJVqlW7dT7nOuXjW2fSLBIlVZ99AFgKjzSMCAZ66VBHNbwa1G/smCUCAjN5gDHmg/0UEs/KWvVA31tSyZNzd6JmtG10qBznP5UGOoQeFaV+VhQ3u2BmqIDaETO/tREoJZ9QH1Q9A8WTj24DvXggrWDuSdi7jXSU++KkS5zG4+zyYIjFK2/y2lDB9CG5tswmyhQy6UaBG6xgTs5gGOwaymAdvSNntrHftA879bk4CieVe3oDVvAMRu413zyAJ4HnXY0hqTUXLfT7Aqc6BMyhmqFuw5NRXSFxMmC+OsiX4n5Cr+JMoE4nYBUBoUG/U55wybj0EeD0s3X3UFlHECHMBN4HhQ1Z1cKsLo7WNM6Q8VxkGyKQMQwfFW/ucjm9FmdnmvACOD84AwWIjjZyq7b7jwuHQyczoHndA48q3NQVS1IwF+pH0ZKrVfqFPQgFX0dXWcbVWevYtkzlnU8xmmxmj701X4g1NGNMzjR620zkLluZzl5BjsKaklb1KVakaqZpbQUoLbWJIMm21h0ZEZt0bYlOU9wlviAL/vHDgfv1WCGxtWgzCxEYU63KvPSzHxBCdeiAmaJYpmNeIi78RZCMqCJhFqgC2q8nt9T3R1RuT9CX/h9jvivNGGT4v5yak3YqL/3OWbMVBHdXBePp0yXFWMNAM/alPRevkq89YK6FspMYLGmywMlTPKS2g+jprVYU6d6KRzgRo1xkSkt85dW/XfR3NhBk/VWOVeFZ5ZvnWaxZhttpVUoym+n7VMs1tB0izU5LAgUUyzW7EDC9ikWa3YayyHbp1isOcWlTVisOVXTitOwK0HRkxZrdtnPYQxDHhKctFhzOmInLNaccTyLNWduarHmrE0t1py9qcWac5ztkicQ98g1WJs8abFm93SLNU/c1GLNkza1WPPkTS3WnLupxZqnuAafRsUUizXnsQWVFZhfOZ8tq2ynHm3HSBR03nSLNXs0OwyubOfuP4Hw2Wn82Wn6WSW9IEVNVM1ZCZAStFulHRppUIoTTylDFl220lYOcSaLHIo/eMh/p/OfG3gyw0xnmacZQqoMGFqz1RWi/+2eYt6GDKDJgJUqQOQOUQkyqvZ9VUBWBcBpXN02QqbzONN5mqmSviJLwYKYLaQFZo3HLdYYmpo3laDmMPRXF2fxC5SA0Ke0RSzWpKOWaWqavkBj8XXstS+AEg1leY066veXLhDpsNCYe/2iB3s0BWOzBLbTiiQ8YBJW6DRNOC01vK3WtEWbIVvMnmmcvp1HvpDsgiZLPs8UqYHT3G23VDg+WyoxqpnLPohvEUcVtFKJ6iLqNOBuGbUTUStUjIngtkD4soXmrL5v25i/SYVfVZUtFlNeWK4UT0XCWfkSHiT2Ry7i3lwEozcZPZUuOpD7Ul2+KA3Jl6WJ+RbpQd7BOoPFwBm50VVoSUzHaP/yBWoTPy6wlilyuFGrqZQAYldZPC6A+VKIsGJ4cAZseb52nCBrbE3BRxlDbguNJWYmkWiBynKWx3ORybWbi1gcS+RI3EKXSzU1mpXWNkk9oQG8iQEvdWHkpq6YLH2Zh6UJMXKTrXHllFoLNzUjnGpWLdxsNxZuasQhweAmBrFp3MMYCzddWLjBw8f4poi6COkX0YXKvLXIM4YWGnrFKSlSOestFbz6B0s2ruHsrNr5Rw31Ja+MVv/HYWlVU4yp1dimvNYZTeVv1WAq4GgVU/8m8KFJ5cQadavOrJpjMHyhzuXVHrpePfooWJm0jGhJ7P5+64VFohuxBiXUYJ7nPnfBGimtA5wE9giGquF3qAl2z4No3WOEh/MquV/9g/txH8pxoi01lwlO0FedTI8SaV4hTPagvL70wQG4f6NSmn1Wb2SnVEclm3/gj3xArSPixbv/StyOa4giYnaHQK7aeDQ9fU7pHChvQFNPFDPztOp328t9mTO+w6yQEm6KMScD0Jq6ApuCC7fWYGADJKgBJKo7CYC3UbQq5oZt+C72hNwaDim8dSh3jzcqHpIDFhP8d1Zdx7BhM3QXJr/qwav5fd1f8A+FcoEsMhZZOEFsh/MDbbP2YdSp8bB6555q2a2yS70utGYnlCfnr7MfFbvJAYfeLCGvIopomQt1YFPRJB2qaAiIIBQPj0i14hOck+PhoNIM5VOrookfibzEXUxz+x1sKb9nMw8FejN7/aEAYOD933dyBD+ep4/LrciiVM4OLND3Yt+D28w4FFLVTlhywXdlFilYFWgv7aHsuNy+XgxXESIl2CP3NSFoaUg9eVN3F2KEOFvT1bNwm0mRVTXNNXsoh3MteaBuSVCiOf9KkIxRblHdnhxxY9rc5DavLImKHBPiZKhi6jkYbAaUSrFFkzw5CKuhm3IQ5pHEPe+56HND9Fqz/wW6oJclPQZ0SknO/VWQNZUAY/do9z9Odoru8ecYJAm6FC34/qqKblY0JUmVdJFTfWQyKLAz0whqiqYu4A0nQuqPgSJeJHGH9UVFU00WNbO/Q5tNg/EtmqxF6DlnQraa2hRd4AqKCIQqIwxaXd5avCn0YRVq0h4UGbvPManZqTrGyTiW5HAI12yhGYkGwC976L9S75ReywfsG6Vfw2oyj1BjxKR1w5m0bkyatHbpkorBQgNkibL/aYsSgVy1GWqaPySOB+qHKa5Fu0ZVMusE8TjKdzrYkvzXSIZqe/Z5hJgVhU9wNB8GrY/WgHsRRD97NjOOFeyiiPDsmmeC6/kyExprcouWn9nnpHRqAOiN/h4RW52LbFyh5sHojlrr5twvQ+5rdfnm2e8rwiWu19UuAwD6qTOaXTXa5NfSfzmrVVfJ3bV1RgwgR3NUrTnI5Tbzq33Raw70U3gMZNtHcmU+VpmJjgnFQLu8Ub0CUsetEDOKLZXyTFOD9oyuuPu0jd7xh3Kc3waKsQ8uEaO9Ws/xZ9CyGzXcEUu4nZfszzPEvsrXI3uEb9DwnObWQ3tbCimT2eYDfDCqcoGtkS+jRaZN6kHDErE6Z26J/ceiy/yyoWEx5KlMw1aQxu1sG+K1bHqFMlYM7fJomZZAuzTOHuLzZcDnIo0rwTZEqljLYzc34EpQaOMS/iqH79pD7TTO68dyYxlRcuA+maNZkzEWu5tcQNGT7Ye+vkpfnSmBGCCOaQlcLLfUHsnXscNYQbEWBRBVOZIXctRV+MiRvKdH8l71SD6YJkfCkfyrwYsgNChDh8vQwTL0wI02dG8ZOlaGeMjt0Xy+JpYld1SP5nf0fVmnduBMN99BhTltPsWeNtfdaXPdHc0br1sGjajujCGeYjcPvZHjZsU9qjuhV2/kvDlWk4OZbAvU5CDagsP5etmg+mYNwn0jD9iCvQvklSdu0PwJ26JmH+vaFoYTspeH8zv0cL7gBNu6HSdu3dcTXKmZApTjWNXMCjPkdVNzHmvJauX2FGy/LbxUpgj4jZzD7+B309T5saRT0IadXPop1MkTmjHg2lke0dftET22gJj2WO1XNiCdnTiiz6gLKAY4hL/Bz0/X0I16Hi+45mCiB/LoErpbN6fyDri0ixZpiwHsiMpDxvB0x/KmUCmkSEZGT8HnhnC0BaD6pynAXK14KyzRcO3T3KdST/Nv1hwxYmeQTWsT1HBVavFKpLRkF+lI1Xip9tR9C55ioD2xFCzlIVGDnUrMPChKY5GpKEp7oijtiaK0N6YonQqvPBQbW47Mt8161eRkVZTGUxWlUbgqSivUdQ1z61mHPKhKL4t6WodHQ1Wl+fGE0XUMj9XKEjavBZrlDOg1spzNHmc5a9rlLJtczrpmOWuWmtKun91yOZstl7NudTlzmtJ1OkerEFskTyB+JJV1bZna09c16bNb0pDRLWmMHHRKJfcqzWlGu6DlPbO48adV3cOEei6isrYleCR2iZsdWeK6k0vcysgSd+7oErdLl7jVEy5xD7yqXLrK0LEydFRDJ7UUrnwdlzhux8nRbG7IN5e4ryO4Up0Sdolzq5tWmsda6L/F6jarq1t3M5XpDAB8Ah47y6VNF7mXuSVOm++WOKX+bonTfj6KJe6GaUucGz1X+eTqhgqnr25o2mNe3UyVk3Rqp1v9pqaPlD+hXTa63jkdamOgWgi5u0R8nE2XrlbTd1xumcp0mTqHAl2t/m/ZgUGNOlb96cToTz8+O7KdHNg5dUd2il3AKDb6hmNbM0pcvCLktHVMlai/uWP75o7tmzu2r+uO7Rw8oE3dRSe+uX9T/WrUhoHAMuSqxZvFoapG9fi+zmXcOZlxYq+H2jfTrj7uvg/BTTnzG0oSVYaOlSEGrixP2C0WC/3kuUKZ5seuIgWMs4mAog6PIRVmRIGa8EM9H8R4tOFbQD0f4LCvAloOqAkYxNICZjRUNbHLkak9TwuY2gHNg7JrjWWJ6vTAWpoxZmQWTO8pvQDFmGbxfEjGWgmRLrdASruySKAy2kaEFulaqX3I9TRFzg8oogXwA/w+e73zeGGVc9P0Nz3Pv1ZNAGVfuFFVRX1rtEW1P4JR7Q9fXKpDXxXC3mP/dP2hGgCY/Q2+Js+dY0KVXn3/CnxCMf61kUfqH6f6rZvVzkSIulvNY60sQCtE/W44pXRivx1eVfnYuT7wrO+ZPvV/6caDYl3/DdeL3F/js3/QU4CKg/ofgWeDCT8KlhlS4AbWFSWOuiNGBpuUkMaFl5m4iF8P9OG6HMfeV/PbmvE/qS7qq+4nW6Lc/cmf/8TP8wm3L4YvvZeoN23ic9j+J5DCkfz4RI1NVarLxuxjYqFYvNYEJ1tnaOpMRG2/onjJSqFe/yUv5ALUX4F8F1FQ+sqUatSfbHK++Qpq46Ih6Ux6eihbHqE8kJb9Hlq6oieikahzIg11WU0C52aik2a/o34vX+OxZdPg2gnzor6cEIvGgDrZZuyq6I2ryjjFWMdwqmb97UfZLeDywPPhTDmDaj8C3eERdMwpkKcjbviD9Eme90ryTldP/mKhR+Amnff5zULLK127pq/1rFt5zxzTXG5sEjOVABIzUfEwO7ByMCyRGG9QtC7q56I4ahXxpZtyMhhoP2RKRFcWASy8hgS/52vApV4RGjuFvn7P3UjfUzpvN5rpqsUfmHcgipi38+wVFPhX5HIj4IchLnB14+ngYeIZk2r64OFC2eoXBhVoSbEeWZNePpFo4Eloqk8pEtc3oXwlIHelIgsXnN7ojZjZc/4qjN/I0BiB1elnrRjulAbgRRR65RHiIA0ImuDBbVVUxbxoYYmss9YMUKPv/QCgFjgtizC9OQ7h2BRa1I7QxCY5hl7Mrv6e7M1GXf7Tv693LdTCd0j1TdTeu8aA9y6qo4hMDYTtxENUx8mqRkRipxbGsakBjQxoskR91h2/4hqoTltjcRQiV8SQRMh4hI3cOXWk9rxV1VtLrmvZq/jpAmFsJdmbAQuJzjVLLjct5BbEqoSIQ+gCj6wnDGvNnp9SHVXK3Vk9q6cixfCgF0ADpxutmx4sXbuokd2OOouIkLloUgSNN2wXtRVSUA7lAX7lKqSe7KfwzUq5vDZE78j1qYhQR7n7okg7Nq0rKYJqu79MzsrklgIZuGY1K4A39ewtahsC9dYlh6zsZkg0KpG7IeUnnKf8KsRXivwWVD4MnCrMi1A7UVcl8ufqiIEOANTUQHsAH+NfH8jTABzg8SqyhXITpHYEZSZi4OUWWIbLY3i0YFYbd6QyBSSaXZmQ4qyGW4WpGbu18tlM3nSm+/bqgJJACesRuCuBo3B/ShYFi36+I5a/HEag8zgJj+yEPxyXM97cE/Ivq8pKQo2d8IIMRgRY2wdg8Zbciikd3ZqzPtwrZPBgD9BeTzDMiOoaFXLnx1nE5uTD/2ySh8PCeXenZN9/+vsHP7z9RT8tnibLlyt760WEmKFzVHHHgOOGbgcjyUfuGDpW0yBo0D8Ur8GI3Ee+xHVmX9HrEnx+EYsOBvlVDxfds/exCnyjtNr9vL3rRqkqdC4MuUAoeDXUIRhIvnrmEhBZnhiMZpvasqZA+CSdHbjWcSGyCrA/pi95uBPQAr61FHEd8KvlibH5BB2lBBdXxkpiIoBWYIlZRz0NTgDe6h2D/i7JBPcs8ZjRu4CxQhEQCyzsdjLWqKrYC24d4nHFEcFHZWggtLBOqvug+3DJ/co1rPVw2ZILtg7ysBwa9cOSC8tAHpTP+F6gV1pD962aWQBZWKCW2NNfraxSR2sj1mDdrZh2rVTg9MkT9SbV35RTp/6nXgcOFfFGe9NjCqRJ9yNJ9TdlYSzLLL8/d02zI9U4zfclWnU90cnSCKlXUUH5uBeoit60JdZXPhxakIEycXbhZMhIG57/sY/1KcheLXQ7pLCMvKpXOJCSC17VY1lhlL0GH8jaHfU/eOPToPEZkn+VdbEXcXT80jUMWpnX5vQkp6FNIdqmzGdlwU7vrwd1oSRU2yig51m1ZWnFmhhRbuTu6IfvO+drZ555ZfXSk2t6UGm6EBd3RxN8ccijWuknBeu4bzrETVJbFrngVT12rOPaQvG6QriIbZajQ/UfCLaVy9n3ZPn397gcSoHT9OR67riV6kOpRkv7fuS4w1GnEFYYKWHsNUUOXTvrfJU0SgF9AEJVK7kjHKHOAwhO7atF5bysCkHxCm8TiD7+kIQciyGZOEgmI5BMK5CsW0jWJyAJ5K2fAJIJk/0RSDYYloBfSvUp8Esc/AA38nImZ9itNcmCD5phKSd4qW4OoeQMUjQKVdyZYNaeakzzDFy/CVdolApkC78HysvvHBAIepfpxAc3K1zDhud7jimnCvVSt03eBshSBapGtBA68lZSp3s/iCUv071FUl7gbEloVS//gry+VgiST0G5PXS00Ce/SgN91ze/MkxvfihIr9tkX+P1YXieH+wVqwh78IPRv7rPeNC7pvC0Nb7Ncj1n8VwWr3cNGi4eA98qRmh1awMxwevQ6CqN/HFAzp8GOXXApABUYDgQLJSXWTMpPHu9oc4BWHTTx3tfzc2lsHy5qmdQJnQwE4K/AUapMjh3DNNzakYgdUjWFOwYpE/kn+7Lptt/hj76GKT0PIYiPshuEiz1s39Uk9XKYAo8jSNE9GsNSpi4Av+fPV835v8fEzoJNBmzdPv/EmQBhnVSRLCufgGJk9ndBdoakWygFY01WXtYXvFPqLmWdmr9IWRN2dd0uZ3jwrKPCpCT7C0C+v/le9GkjEm68c/upkRNWqYCJ+nKiBZv4LR4g0ktXpcuqZg0J108etVZy/4FWe2evpY9pK9QAg9kP9FXLf1AtpzYz0XYzxFYKqFbgWaWbT90d9XppV6VR1wg6rV4hNi4iH8qgNLDd/AcIDfeuVnvQ7MoUudkyJ4H/NT9idOr9R1m/1cMLpogDfC1D4HUSb7M+4elM6Y7nqCYexXuBruq6jYGuCCIl6YXcPH9rkEHv/9Wu9n3dbPvY1Z8TbHQiTMCyDL2Yr8Et5IYiq8iC8ibdloGQjL7ympZHENKIo1I0hcYtCX0Bg98JNAMFZ5ghMBSSx8QwfEIM7ikibIDF9gqS4ds0rbRetJv5Zb2M9NHblJFjqc1oQCEgD26N1YkoqCy8wvTPwvCxnWxsGJObuKVdgnATEtRClt+O/h5K0YxrQoQxSio7iklg95XCfXStXDrkJ/xvuAfsE2T8yrd0MGlSW61vxuS6czg8I1MGPMmcfCW1yNoBOctquPRFuFesIu86sUMghx/mMPVSfO2Yd6pmpr3cEcnD/mZuejUBXXP1aFso2gPwa96NEMI1VDaEDViL+Dxg/gu//VGkk7cIg+BjNpHKOCP1y9AO/DJLOJ35alm6NLsEWqvF22WQmEU5aIOv+i2B84rdNcWUrPCXTTFd02R9Z+GieRuGXnQcP/zmkT6simz0gWzKfOc5Ylausg/bgrUsj+RGbh1Wmy/a8jfUzxvwnGGOq1oOZ8VN+ihvZvVZ/NXdlcnqK1SXzI3DjCLmcsyVaStGrkK3+mH4tbLLXeyR8uZeqv3tGfc/vnrj9792q+8+as89KXfTd3hKc+hgm4VlZudsz3QBh6rJFXvdIkDV6rzEzj5NSM6GAArHypfoiN4/5J5X3fX0Aq90KZX5yCRcecdOiYhBzCWdXnCTwBdmvvW0ZgvIwTqj1byoFbbFpRFGyMkqIQDyVgVkC2ndwehyGMc0I75bq3CLqCCTKERt/uCyWJPRaDgVQEQkue6rDe51PiJOcqhMf43Ar1SFkyp6huU15DI/oaclsn9MVdxgQ5SyNeUbdEbWnQs7GL1uKkMmLOg/QWDTCQ9RXCkCNeNz8RwOFw3TCN3kzzI1GvaW5U869faX4jNxBt4fUo1npMjFcmRIliXWzoRBZUasLaiYhaYQHKGE90xIJ2Qw/J5nByLFTFL9YtAf/8xo3+o6J8I+iMkzld1Fui45snobAjK2ZDglYl3p8T+GtCe4sqhX9EQxBPjwc3jYb49ja0r5qvgdwzzG9MwH0UbzEclHGhMw/zdhqfUy6reGhgqrPQeX7/pIZp7hU1b0MveKfTlPt8LKhQtdPwc+I3spldPYbpUChuN8HSR4+miSZ7OpSNVebpHUgXuSXbWJPsbkV3xCtaRflhelV0j3/F2ES75fgBfO7Yu0nxBydZBiwtYbNi6SNm6CPUr6zGFrfO5Vb8u5QbmkEIMRfGT/FG2LnQLwM/4IUyv4QzmMaExsFYQGQHZHR4x+Hx8XI6n4zIQCyfTYLWUuobTCbcanIlPCn3DTQh3WBLuEOgbTkPfez0/fMwrnRytjUOA86uQXHsag2Wf1lPUCsIVag/1eu5YD6NpPUSRpoconAPRtB6+1fPCCocfKiZHdlehhhPUMTMEaSG67putCuJ4j6e3OX3M5RihSIh9kP2ITAW70Sl3BgFegc5gc+XqeHVnoGywHri4fcI+8NDHapaJ7h+1/FCoGwX4tUQLtNHZjxqpgnK2gPXEluHwq/8dbBk+EQVtYdbchiFwBBXn4KFW7us4S49xJm6cNWMu9xfWBI1NTMwx5C4T1+Cp3yTVOeksSdpJdXMgaZIgSNmj5fS3HTCRDZGDkJc9DPKFbUQ/c68pv4ZaETTk/P524r/LeposDD1OPdWb8dudVzY9VBQbHjMlyY+Qc0Zt6OtnyCmHJh3mBzZRncFsxFkR5ymTCZmPjOTRSZipjSyPAnWwCw9sIuA5C2613ffZEatPoAbHflJnCT6BDyW4AuYwnDx6UpCjX5YDkCppDhnMhH7QU9tXDlpi+gLlzKGH+Ry4LLeNygK5hE0erHQg1yx5PPwHaGatHzNMPNhV2HPNGmVlRwc0p3oeY/YKsgqTicWoqvPRRpY2zSBqxqhtAzyADOBiLPIFlBp5oItpqlAsK2MmNkpHxzdK26bFgmjoxmX39J0SlnFslrIfH98k3WE1TtjslwLUw0y8qOr5TpPPqiTvnkymSvLOyeSFSnJ3MjmpJLeqySnHVvr3Cc+LrjWKMxV+HJo4vvKXVWfF1TM6Fxurx2TB+8q4qo5DrcQFYctB5eMhP+T8v7LXGA6PUH29CAd5LOwIBRMZ5FPkymOKwJ2btTPG0WYeO3/IafouzwuvVcdkGQiVky/rcVXZp72jE9dAgnOYQxbQUX4McRbJL+6zIkJ7Kjswya6Zh7y1UOM02CG4HNxs7gXShHoSN/02E5FAlP4VL4ZxW7XXEYEDrsEqKivRXTHqSxH9Dvhxf21tZEygsOxe9ZAdBhEg4y2SiqWVZH1YyPmWKDQ15KxZ6hGH13lzzLZkneoDEeOkFOYtBnibi25RS5mx9oaxukPx2gYXnJAWKPIVNLVFbeyj2pSqD1cwcs/i2CYPWuuZMmD/TRfJGoEI9FmbyaIfOu1USULRqIpkw6lJ0GMTGqcK/WoEATodWlSKsvpe+jf+ySsVoo4JpcIi5FinVMi1nUCNEBX4Vo3Q/8GKGuHX+J/HkQ/ys+7UCO94tVMjdLU8IsXB/Y+/yuDg1dNUBgHs7MirJ1UGh4irpf+z6o7c6YM+420//acP3/yVe7/6VMxL3yj7bQwLXp26TtYgIbXu6MgHX3FhaZnMeYFtmD0A+S2WM3ei4T2+GjG3Amsm+gE8tcjZFVgUwZps+5RvUJsooWYx/LMVW2E9tiGjbBVShPzC/17ay9YR2d9l2Div/6BdmzxlWj3SE5kModP91vn+AkIshIRwstKwQOYAIGp7GpiemqMblZe3qHr4IIWrYM/Xc6eaWzsqkE6fDzhvYr9HJ5UwVCEwxxgL9bKf0w6DrXZ4JJXYGVx4ldMdXX5JW5/9fGWHbcZUbV55VubIH/SVjljW3Gpd+aqCN3bO4sOYiE+G79BKcXr04PWV06P35VEiLg8bL1ecRg/E3u7BBTEIElus6LMvx8GtbCZcZAN92YXcLO8cc6FJEnH77Qim+sVdY1+81X1xl/vibQhiBztoqsjxYCz3yRJsaiMJNsx6B6hXpfqy2ARihN9c244Re3CuL42jJlufW0OJc2vZ25AOdFLczBlGG3lLN86ifdAEAme/gMRpvC+1BkM1xpZwfmvHKgOAraIYpeBX2/zw1ADcDP91uGhpAaXKqReZMLH4SGunjlGZKrzSQjg4CuRAWZfg4rm4xu5zAAcUYfX4oNYKUrgj99PxeC/tC8ipnn1Ze9+H7TBEISBpRVM472b2NnQc5YgFvjJd+BBxqu7LzF4vj+ptgCEHrnlo9eHdpjytGHVNdUsmFevgzCALYIGNjqmjqdw8MNBDsgK7YnWLYsrO8w9mNIOUGUC2ZIk7qKzTz4yBbiBLWVs+i4OYDS/3dDAU8lwL1hGMEMqhcK2c9XvtU3NSqFeN/l4vx0ByVKCRug7zmAcY8znMzxGyXivf/9Pe7+8V86qEpEW2gbgLXA53+o6HF8TB8h0PF16+aFtx9GL7pBDVF0vcAFjx1Z7zfOE+y+alM0ULuCtmDztTrOduQSccN+VxIaHRwek4+70++aiUttAyzYDfO7D/VxkBHl7AHZ0veVzK33i0hfP71/TMrSHwA6LrXeGxPKt21wKwKOPiubZQJkdG9bxDIcejPzNrtMAj8MI3P+PyT7U/c7F90iL3ulikJVqaNPU71dAvzCguT5r5RfSW0sjvB+1TrxwRUtS07/vt06UYw77vtU9NKdAkgUTLcuH2iQwTgJfCaAun4aH/laZ932+f+HTCCjB/OtXU72aGfjcz87uZkV9n7HUFgB5v5ISJ36kGfjcz77uZcd/NTPtuZthX4xXwy1PM+vYe/vYp82ALrNauskHardSlrTBIu0y9qYZ+UQAhu2ReohXCZzBauqSfVdK3CJLJtbmDTQUWyi62SNThpjPPrPcjD7aA3bRImmEg3+j3dzW1VzZzG/OFZQVGhjFPc/i7tKj3ikxVTmfzzuj0nRFeYEYF+/y8bo1npZj2CzGpcWjbdUSuFgIqX5TZ29O2mWi9fz5G4OQoGDe4l7Q8M1dDntT4JudSykIKX0pflo74uGSpBNcRUPQblU8SUurIYtwZJR9WXJJpU+qw/452KAW0Fma1TfZN26i9at34+R9962L6scg+p1SMFXuj8LBG7BV9dVa0ltszXrUt2Y9U3D7v2jscOG/TrHga4gynCRDMyIU0FhxRU6RHs2v9vdytQAco92VMZy7DQNGcGBzdbNAmsfnRD6Ibu2Z17AzrsmW0hAe8fAt05bZMAguO8ww+dB8FPnQfET4AbgKZYsYIy+YhpZ2BUYJZTsBdZ1+4LFULmuG97STdNa3pYMHVegUMDozEsxkzkJvDrc/AckjHQoZLaO/ppo4xcZ4JUsvzGO4jsbBeQBWJYKTPGGnYH92gzjq+ZJ6CfBufhXh9n7bx5O6JaFLgF6Mi8MDooif448MK9osV/g4vwTHBbZcFRhMtR14VjipUlZviRhvgYr1Ho69RLpUauQ9NEwKcUWuwpm1A85s17sV1vGo/wB9Vx9uH0wvJjVfARuFpopr6umxH10cO8BOGXVBUcAWV6+idffsslpDXRn/IPotFkN8u6AsHSN6WRqsB0XbVZNVqqCuUGl8jsHn7mv2rwX8qViqrl/UPH+M9lBp4LmGRitFPJgAhcMHWl3fKHgqUQ6rnzWkrVL4c7MU8xn1u7lXHTWT0ztdX2c8kziY1UFUZZJlWMyMf5ctjc0mnQKZTgJaB8Y5z6ttnNfJD9imgVkDqrBEYAYjO8jYutqWl3kiGyZDp7kj2Qa/MM2kBEpVzTfuH7wUcIW9rY7MgfkB8yvLOcSAUGgg1Kz1FW5RT7bq+Y6AF5Uk3EKRz1MccnVFJnTgnm2GAjIPDsd1uRT7kiZQPEwndzGwv88ysT9pZWc+PRvmyTh6txEwhRyxxoORc0y1rrgoxQrXoyShN9C00pWwg16xsmzrljRyfMDrHmfTUAb50FNFz3y6tc5I2KzCbpXl5ztM2XGXZRgsA2oLxVwaxbZa33L42UbK6poTfSc51T6HNimUZ2U2e3O/SDUbwkhdzO7G8Y90E2dItiDnJvYNag7xV3dJBitGC6FmN2ppDj09PaodNie3vOaF22C6nHfaz4wcfF3r+qHaYPYBQOaEmaKqxQl5VFXO1F6oNjELBxWXXQxyA3jI0VCg2IuRJHqmQx8dZ6aWoBKfQMFXC3RTVY8x6HrnDDzBcMIS3IDBg8THhJvDUxNvSP05SHxJ7/sP9VPsM3Om/u0CnolkMora+onkTyTa4VtkGo0nQ1VaJvu5v2R5RXUwqeKJQmUwTv4UZ4id2s03MEvh0cCxxi1/bKIbadjc7QzNKQ3FlEebpsZttrQ9lO1s0sZdtUru6l037vtxGqzCjLcub6162AdRN+6FgeoPiPKFUMNXclGtx6EftjRu4Fcib8iRMwX3l/rZ2x3qRwXrQoJilQJ20UutI0cJLNjwyLObkiBOOzLxS7AKQRcTfcQ/g14J/hjSrL028DIZ5Sw+SgGI4pRg9QOGuodhUc7Rw43U4pLkj/H0rnyPRWq0eeslRR9FW6Yqcfz30c1/8w+d83+V6/uXG+NjFfE5UQYGq7mprtA1+pQqqVWFdzK27lIwqlujXjzBILnAKJjgEmlsfcgPn8pY5KtNGigl7qqHgK3tqnhhnOyfL0cNnA6XCeroO1PfZfUTeUj964mc9TyrxLvdc5UPdorGLATj7sN/JGKQ4hkLLBgPZIvTyumnrjN5i4LHGyBTRrfvC7/ifv/AXz/vkD1zV1mEyzaiXCZhILfeGLJW3FqFymGyekRmSitMtl6GCEYrq5BlHlbijn1R5cV/aLngresi+ighb65WxcQeXFIA3qNLuBydp95TY/i5DPXeUOrpZYU8ycWfEc1J8kFv3AQ7eRnXAK2eg2a8o6dbTMa8/CA6syfIMFf53Iw2aCxwtfgnx1EsBRoWGn+n3+dB6RJOU9AVWu6I8Xw4Rkp9EVHHU41oe2QwUGdcD0EhSZSd7nVRoenremF6y2oB4/4lWnX/wvRBdfxc0q8XklwqAke9dXh5LlL2pPylzrqvMWaxbyaljDALOmxhBNJE0x+OSZhymqC1qXnpMbT7hrrG07qhXiPoL1YyguW6c6OiFV+sCRhXe/GlC5qQUMtfA2NSsUnKdU1CxAMz6XQzkoadk3QJ1qaUzVXxRAGiVxv5Lgp+4PNsNZVyoNhqLtrqKjVJ7XczWyWj1rUWOP/6xfwyxwP+qHhmSfkpetoGIomLbAg+DfVi8v+ZzEYKe75GcerjEP3hX0zLoEfQiaqIqxD9lkl7R3TWa99zz/HMR4k3sHt7B7tHYZ6MNz9bwJef5l5QHhOSPHCV6p9e+6/zad0kouPz84HKu5d4aquFfV/EXEIVfF/UgovDrom70EMW/roHQivYu4D9OvgXJ+M1+zX5xJ6Lwm/3Z9SbqXYjCr4s6KlFHq1HHEIXf/oZI+Kkm5n89/LoGifVf/JZRE0dkRc0NqOPYdMQMy/ZfQGaUvhhqY09nfUEzVWcFbHGODRWwu+xcDPUkVyDvDrXxYkcAlmHGSrfuVHytxAMjCsNA2XuVLGibhVMEybn7hqq68PuQJ02fiTar2nVpt0WEBp7CUA4BWyLJ54f1IEqRxJU08Fu8oKRO7lgStP/ea/XUyFf3kXlg46ApUD2T1Btsv68cuSFfv+j50BRxOpiRcV+BskNVu/Tx8NWjaQKVGSyuSEzE6bG0F6kJJd+nmpuZamWKXimF2YeruphhqYsZyquoCUAXkx9VXUy8FCHFo7qYz+QhKg20RP27/94sYJGeakdQ4pOmauuzj6BqObGONru/9ev/HpQxPxZWHehUNdttaxFGKbHqMMTGbbIrRYGXkXF6rY7SoLp59TX4aAH3dGCFIzhQqmSGxvVLZvQmE44RbQDVnFWcw+G7LuoN3cOahT3R1QOf53rsq5mNwQmzZiTDwt/0JDcVpQq7qgYiup5ynDt9kYU9I0qrKyxQV/EyUBXKykGuxItCld5lAyA2XV+jcn0NsL4GdplLzQUtwXnLf0VGlLnAnTHeP6iB3AKgoKxKi0ukOEqRofTjhN1T4oxyWKgrsxlKT3FFGF6Wq46KNcXG9GlUCdJNPsdTTonl2XpiHUjoWt49LgrYU6pAditqiKuTWoph4Qx2TQgCfiMI4E65vGtwb6Oqt6VIBYV5mfvZISGhMv4++Jp7GriHU1+D+RWIllF5VH3LnG9kH76RryB/ikgtYHbgavIJz4OeBrASow7/KvJxSeKA6tPc6+nzLk0N7sSz6hl5YL/fsIG7zSf34Hm/5zwjCwVracMSUYe6p7EmpK2K7RuB5ngXP7W3XDviQEsZAfqqpH1XsLZv9q/Pvv7Wn7zmacYJfmgzKYTc8Y2CST/KPo68qtRwNBpUzYlwwWy/AGk13jMqOI0T5BSrWMNh3LU+5CMTqnd9vSLOCjBHuQ/GsVMX4ynUYcOvKFuyYQO542ljkr0wZOALC/hjqFSJcvvb8qCqjkZBesPIFfuDc6NXvf9Q1xjUd8w3VzlcofrqITXLPo6s2jAsBdbowl+wpcRPuFI2pBSup2wBhevpBz3P2sdJCn9g9Ax5im8U5qoZxvtI4RRtya+YgzjiduKbZTGtLAsPJwv33Jfe9MI3yzJMv9cRAHL+siLyL6wt88OD8l5EARYXXTnVAML7cItH/DTzz7Jx/BSBMN0r0IycNtlcyXxRmD2E1PT9vudPLnzOBZbq84XWwlw/FErAUBhxlaoLFjb/yHWvb33hr6qD9y4Eq+gFGDlR55E2+0JR+aeLn2Vu8GvQYOF79EoXU3X8ZPuZhLxQsTbS5dCqVUr2rLzM7o9oILr2eK49nranhvbUTqIxusVHSVbWGW4C0R85hKhf93z4uRJwKVYr0fSdtCmwdDk0u8HKBQBdsvTyENwiCr+J9mOxEu2UoPTmPqwaUUknr2KiXevQmB6u67wpK1GK0JM0JN3jGSNbp+/lS5rr6XcxVkyRJkCQbnwC8lVBJShGopCHpTKxAOMgwDcmQviL0J9xdOJe57pfmM1B/aGUn6UPxiLSDTQQus/ZhWSHIOBFyJlRJOErJN7T1MvyjsRm9wC/Rajw45889f70nNmnfz+gLcOliYaFGDRlHLDHa4ItkK11XcUA4hAvVIXchKuGQ08ki594SiBrMipXhGYcDbQZLWRVI/akp+1NUbFayzPTwYBS6aJlTKSX/HIbprfctckoMJfkO5JTBLAUWdOzyK+RXRPpTtnvNQcsajzfiIlnEOdwcFa61gJPDj1ymsHVmVvz2RT8GcXSSLSeIj714DQolOknYnaR5ig0tSozeC9O2SjjOE7qaGeyNwpfPkdzA5pdR97U6uNFaGnEADM6D/dXra2ZQVH+qy5pVrRCJlaH8Y/V2AujklsJv9vHZW7p6I2f+sl+Hrg+K+DD4R15BEoqhUTZp6QQ//lFjPkg9jlg1Ov07/mRD//DrgcuHl4lky79Nc8L3friFhdcoib/No6Cva7epouHLh2VdYNFqPpddLzvFIZ6rSgwlR+5FfYMb4VWHKwZUqiFj8fbTxO2LRt6xvsesSfU5loFKoTcPt/NzsMRA3dqlTj7E0BH5OMROrgu6128plbigCmyHe7foyhX3/ez919yztdgqw8DxHQn2nfbrfj3lYvZH+udSapXW7UtobmE4Zd2EKOSJMD+Xbgmo/xpHWXsq+6UwzlOu9Nfc2RBEnnmiDnpWjVBCQSknIa+bdnLox+jxwOxPJ/063lDr7nbGuWIpqk2pvnBk5yCKj94UJT+ZVJtFDPuEpap4Su4/fIA2rhb3G5E+H2Al+NjellKrW6MlEg8R+vk7S+YSlDzsl6BY0mCSqX4cZhRb73FzG00o9fCKF4vZnCkMkMprHU0KMEfviR8i6no4fw008O3fA6OLw7wzbGNfN7NB1W8CHMPOiIyN1pcXrEITiOQsoslHHNK+5UqoVdKllzfJI1MtI4NTBQsAzO4oDMBsa4lUcuY+MuIPRTRso0NiCt9EKi1pMBDRaPFmk1cpqHkNjRytAmZzQsseORNqI4ImoKBQlNMHaQVVdrzcI2L5f0FUQqdl41ikRaHR8inBSDHwkZpFpMn1xDI1BdX8h7IskcL1JGz/w5iweCBFWkWXVkmPN3qy+JPs4wKtrAHVcXGk9GR4dJZjrolBU2Zc03JzJ52WntMQ+bQgDlaUJv1VKMu13cetwUk13pkzhv2EL/Nn7T71rilkmoP/BYHQFFl6VMs4CDEiMfNhvmq2TD/IstY/X4UNuWQN7zW0oawpA2GBhzy7U4T347oN3nWLEDfz2Nr1sUn/mOzwnX9VmXm4L6s1T+oaOCPNZ9UX5xnWEPFKf2XCcnTq6uUqDkealNMM2vUPLCh6gsd6hzA3az26DqdR6KkBSUn/piHXNUzUEFMrbyJWY6oVJlGbV2e/S+leyOSF1jz7HC7cC2tvTbSlb5fPXbOoIlZWe4xvfWWbWyo2xy6QWFVfbMtnAqIRcaU2zhH66iR1GKu0p12hfNsUweH//yjKnkC7I1iXg80OZnJ0LCYpTk+O973PW/5y3P3XvrV/49ckBewmeyvJe8cnMGskV+926rEz9XHX37tA0/5/rtfy0vX/Dq35NvPfPXec97x8MXUXh8M7tj3P//y8tf8/C2fvRij0B4M1f4QSnXfoXeZNq/Y/PthpRVDE7r/4sH6phdsIwyuOsYvAApdUAxCv9qPdNkLGKn13MjHUUCL12KdHpBwkzfM3aVAtdPgVuXEBRsq13IOrmFNvWk8EHBsm/dKcpPQl/PQBmduKQ5Tq+TMeAFvCK8KhNKWW/4qoeYA9nK0nTF5uA6qtp/7q2pIiSLZxf+pyIfjIRwzD9CDO4ZWpre6d728q3rG3vUBcwAPecZVeqhCdSV6I5aNAz3Cu7POEB7fFYWmDx6FYJYFN9CNwFIndz0DS3+GIn7pJy4/5ylvnP9vzNTE5S6su1cu1HrllVWKj2hpOIvkYupqxa1OoWI/ust/sPCbjlzAlVHAPcNX6Dh469qcRJvjQdMv1yOL9CP1OoRtENUAGcpbbwf9krbpuvOgN9VfSMirzf2cRAjcYwNHbeAuGxh4wsUrdcUxmbJCGhojKcc8Sy9jPfwBbzR0t1iFxmTTqGWClhIlUmVmngI0LIYppQNXStEaYsE95g0pdbGIGni8UKW4ydtPQICUz2hjbRh4CAjOwooU3pQQ6yEo7rBjZ7Mb0B0l1OMKODMqSe4oSKQaMQPt0M4VmGFZJex5QAL4oUn4vm2V1pwKCM0wwc9bVvNOt6XKHDzg6eDo272ejpC+HcPbwL5l/HLMvhC/3GtfdvPLA/baCsXPcasEmHYzwnH2v1Vwpu/Zn8mbpmW6MjQrui7mnk5NNDDRqYThE1XXgZauFqJtrEPawrVxNUuignmSl2RY7lexnepY7qitu9W2gZ6+d/GeDPDFjPp4G9Vn6rCGa8E/OlmQI7J6jaPKPwoNhTW235WGu2AqXWyLOiQXCxWjYYFx1R5wE7qcxtEzJmZCuyoDch0z9lh4jlpS/geeHxttC1WEc4a3fQqExQhVbKN3jtX5U6DyNF/FWCCl4safkzzzRrGSc2E0Gq4nTR4c/kJIoFiW3aDmOsxI1Sx4uQTcz65Y7M6DMSN4njF4bDfVuqc21iXTn/VCuxmTTumNQlGI5N6U3bCaQ9Jl19o8MQrFDfJztWzdYFdWhp4Km6h32FO1hhZqc5Wv1LUQqfYmIyaUnNq5thZ1Y3Xmn1TKi0p96+I9KYKqk/cyTMHPgAQbi2EwVAz432rBch3nRUSZX1THKhvj4P3P+Jr9V7uhpJlfq/3/erpIbZ6hbMWD12Eiuzq/t6eXdU2rCp8CVcsboqnQp9QXv2L124fg5MeCETu68ajtLYgtsj+fZhzLWZV39rfqzv5WfdL+lkuXVED9EVcDzZTOWvnJZ/CJs7H6F84Ol/psMGeCdZyZl3ft9+NXSn/2Gn4vws8la/vZUO0a/1EkrnvQBy1K3MpEMNWVXIq2SLsQV5dZikdY1Nwx97gF1nr2bjUBltcxQsie1/k5boE1dkdwv+WFqpZaVRGItaN1VB0apQDj1ABvTQogO/0aq2sGMKqhnkTQ8xAkswkdAZaudqGcIAUQJRLH3n6pgbg6ph5D9b6q3kBU6g1EeFVLs9AbiBDh9AbwUvDIjuoNfDvO0Q955iA97t9nTyljZAilz9J8NF67JZ3KPldac4o3s+b02X8PCgRfiOUYtZyiA88d4dSmcHKxrKsAP/Aax4tnqSrLLmCn2BjAwU8X0FEjJ/yFv49qVdbtChwLVcSGrLV3Czg/vzQsspPF0xTu/1UlxaLdBKt6h9HulgRvEUCgCRQ5ow9fwJjBYM5J5f4bNTigfYjgbqJsFKA+rJ55RVCzMud6f3RxucHCgUS3N6RwQy1E7rOXaodV2y/r2d9KVXVY5gn7PoVYbVHzuQDbcb8eFgzWF+ipltQGakF1w31doWHhdy5XxLqKu3JfTVdpDh4b6RX6cYu372NPve773zL43MVD7ZeRdf42v5dtDbmtemN+gcuyV98iLZHC7O+QSwk9QJo9gHezElIC1NY1W+dWC4/+E6BVAjzGfij7onwBvMYAwEd4eOA8f0+ld3srvcOYAn4qsKbwst55/j6pWvuEEnZnXzJlRhDDSVO1dX+PeCVYO/XYJFKsDZ3WgSZ3K8mrk8mtSnJWTaYSuvh9QfZlc4o58Eb1KxyNckampsSCqp2cgsVfjytY4EDWutx3ChbPnlSwuKiSvHcyuVZJDiesRLkGvsUrb1xk/4DGOE8VAVwtyGQyKRwLPFLfeSEFRc1k8lymZ1pbB1SDYR2gkX4BPwx5qEZuKNTMhZwGgupxAPknfRDcGQXhtVjvKrvyqouRMhqeGErfDFzohjuxhAEWM2v+kUU0MbJa466qELeefV7tYme/gOdw399d8M9ffcY5/3jxQGzIHnHnn9ZDw23ZTch5BKeZk5ZiAwWB8f/hZmgRVTyB1BW+laYJ056IR01vtL+b9tOr9rNB431rHLdvjcfQt8j65kiADQlph5xvjjqy1YEFHrBgrJ/g1xUnvqF7ik2O9LVIekVdqAQH0KdJTD0Uec6uYmUhFsNhhernYZ6gMt/dFLmyiC+sZQ4GHlU3ExSLVnwEtnwXP3yUVrE2yOkomiBl7nv8BroHOg9/El0JEYcWEFKfaxJaUNM8InZ5iCt5KfcC2q12cf1Hla/xh0o4FybmmlBbnLvHB4p4I/eMOZfOiAsxn2KMvbuzM6KQoJcNhjn/VPVgyHu+bH5lVdUtFHkVs4OeJgzJO7LvVz5w1d1f/O9/w+dg3yX/fsXpIYhcc51POJcPwPLD98uZo6buve3o+r6Vgcf/fxuv0XydRgRoftX+s1ZCnkWiz3HN/hGcck7giW0okJdC6Ol4uqvDaFucDCdxMiRIocLbJlDRB1yu7I00aFrFOWSWRkenag7xvaoapSxHVqpgLTjofzB7k3XjCt+Wzu8ZzOFtWEdnevRLwTRzQHcMO6kpVK3LauYiRL+CI4+oomGlXPikDKYZGENlyg6r1bMQUWIgUa/B+DBjDgQ3DjJC9RnsjWhhApdEoe2frAPGVh4YLdrQ2cDCzjeIJl13TRqWMxbaIt4cw7RcfcS0HMdGaloOY011NfomBolliyYa50lFtO/hTMPTQ676pLm5CMbmUFJYMTYXWWNzKFxYmjtUERuXrhtY3OQOjKs9Jt9pjW/egqhigC4UA3R1q6tfp9Dp6usWDM3VTQ4IGDV0CxTah9skBaR+drIvVhzW1lXZJbJWw9RDqDM99w71Vnu97zUrqOEO7c2Z/VfUhL3StQNFlP2zRGBErMLuKpyiYtR1p54nqsvcUL36ptrmhlgXhbyoEGXlljUjkEh0ymULLFMbj52xZOInIiHZG78mY5R9I136a7oTDkQ5TTwBlWq+iByPcXh5/fYk5alt5Wat66KXW3G+V1EhRw8jPPagvxCZXy2HFUCHAxRit5Q9COBgUEe2J8rLJ7J3uBeC/OweHahA1ZzzhhYLudm5YmJ5QXPkKcfsGolpQb1NY/pcLXa2ayapzRUivpixpj+4valql89s5J0x+iGy45gyikYoSMcQEAdu1a/mHwCYWsbYRD6Hm35qPH0OQzfPQ1I5tlRRkIvocOvm4Hq1cjHqCA5aB3kntTVl1Bni9ntFP5xmab5iGTiTY7s5JM/RjAy5QLoJg2Zo2gKj/3hPF7kxS6VoDFafZESiFxVxte+y8bIEtOi4Sl3wyl7h4EguyMuHVtURV2BLYIEP7Ad51n1hvixV5pF+o2xK0TE3eTPzUXR15YsudaQlKFN7ZrycF1swvl3KAKplQGwZ8VmuRu0ZjAv5HG3JZwJAfFkgPQCkhxjs8mUggATc5+xpsI7CyH1M6M0o+fd13avyIhjTzOk4Vdy9cTy3bx1Dy631aIu0Sg/bO9IIdzJVPV6PUXWsN23H6hESWyyP17J8xNZSw9ugekV4SrV3UHZkOFkh+rpAW8Sm4qzOopV+xIcqPUX4VZ1I8xSA3m3l9qzIWlEX20gruO4eIdTrc8mwPMo5tkgSrcC4zLb9+XaErsmJYAUBt3tz6nEo5FDB+LmD/3Zi7ZhyG/0Uvjt+OYWEJ1aXrbQDjSsiFQWETIgI4YzDV3A/dko/JKY4hU6B+YpTSTLb19O4fdu4feaS5CwlWqDYhLtaZFoavkKOBGe5Hwlws4gkXyxpl0s+De+VfPMUmaMEoBjM+eziuGQs7nSlllBagEBCdmhzdFp+ispT5Er9KXR61dQVv+/id4qRaGPnxNKMElUUpv4KQJro1PwUAgZbbcNt9qoJYVAKKgAM7ax2hcvU/mpv+FWt90gX82qHTqrxaCwPm2v+I255Sttz3PpjtHmu7Pd73JdQxihyjXcjhzjXCRn70U70KmMYyhjGZTmXczlmZKvl8PowUc437hivKAOwA7vHHbQTVo130hbr3HoFA99gGCwdkNk3r7brqafmWtBtLm9VVWtE67ViYgA2EVWXkr/QeSjqvBRX7Y505MITjC2pbWma47oBmzVZ2EB19HTZNnUJb0tUGrNcQBvbtADebmFE+tQq/WC3SI8ERpLTMjmdSFbYGR6EkgOG+SDmR5jKIh7ulXETf05GUViSNbzzki8djkY1lyKaw1AkhnauGcZAq6nUkEpxOfd/A+xA1W7BInjDKwB/G+c4BZrr8SrPa9qi8xedd2kGVeZxZUjQMrFS1Kmu4ZlZv6tE3q3fGKSS5NMMzeP0erGSvGh5C738rWzfPJp7lbQZF+I27sjeIIv9il3UwTjkpCjPKDZvrwZusRRnHpDgOcZJCIHgL/DfVsilZH3BeoG9wRaMZA+bHLnZN76oKBqvEougd2LRUDhuD0AndtCKovY22pnPlHrv8/hiWzlBGQA4CJ7n0Z7R0ZV1kTruUvoYOzAHeAGVAbBZAKw64aiHuJ5Mu2KHxmkDZR7QSh5LM2bRjDmK1qSLeM7qdiei2YmFuFjLF2grStxKZGfHlhLJt0ybA4CEJodIvmr6HDirMgfyHIrw+MIgao6hmLP4OlPB16mIOjMVUee+Dog6B0SdG0NUpSVVRNUuhNKPEUSdVUQtDIbOOgwFU1mUGLqDCoOhK31GSv4ji6HgeRZQ+MLxMVQHeiutruXbFaBbDGezhXbSrMXQ7V83DF2pYOiswdAdwNCdiNupcdpA1Y6fzeekGTv0HAP9g5rhDoueK1ITyhipaRUxq0QolagoaXiJpQvTsDQvk/OJ5Ol7zFr/Itlj6hVk3WmasyIdmZ1cLD4phDbggJ3hi6LU1wnPz36dhxYYTTtFxWPezchtTDZmxC3JfL+DpWxNaLsFC0UA+uhmEGa+oiokEuphOz6PhXe+ssQpQHaqeGMnOruzOiVRkN2Ctxs4e9e/SLQKvWkOynCi+jzdpimczoWgtK695WnbqO664Vk/b+LxgjxVw+qN4xxKNtmfQ8WmkPnOxcj2uiqulQO2fKZ0yzyzIcxPkVUEkvmstGhmVIgLfy2jQtyq7hPAPgfvnfxTaV+bOiLEndPq8ja6VKEo1LFC3M7xhbjY/LHzTSfEbVN7UyFuh4W47ZQyt1srhbdDmtUP9fxgMKBs3G31EWzdKpvE3XshxZ3sdQ1kNyvj+YKXdxLwyEbgMQd4VH3pZBYe2fHhkVF28vDIGB5zFRlyhyxbkxwdolHtCZEy4JdSACVmsIibo6Cewo2gWMwHQUDxrHIWgMAIMjEbVwHpIwZc+18NcO0K4Dwza7LqaUD7yFQI2oaq8dxBwbgCPCJ+0pw9DfAmTwM8ynAOMX4awOAAXK7sjTRo6tC1eIpBa3LIo34cUuDO1NoUVY7UMvIrh6SYv1XMyahjG9+ebHxGbW58e7PjtU1RrYa+DZhOCsEr1aSNXnejao9MnPMiIRpQ3cZnHN90faBoCBtuXODV4JZKXa6L9qsYHqYQaqD7lX7LTSwVxeNGk9LpFxVMINulPsuQu8dpMxQf2O/iz9H4trPMVkXd8u4Mt2eAN/2nVey5tIfzwHkKnfaFsgGjbUag9SLZFla9Nd4belHlQNzXL/QYpjrU1kN/EdnjtCq5j/UgY+LMznsUZ3bh5JldWJmloZ2l4fFnKTf25M/sQjmzo2gquY/JHyH30SS5D9Xn5ibk3q8cS2smR+5PDI+oCg89d4oq8IgsPKLjwyOi6OThEeESwIgP26BK7qeeIPqpnqxV1BTec/Hw+SNqIf+yqVoIUk6oFoJMJ60W8i8nqRZys+81JhVrdB4khbU6x9NBvTuJhN4epBnTUzFyJIQL4ThXgxVF/ivP1YLquVrdnaslFKJ7cXmJ2lUWcWX7Tbl5w96LiSGdVP7ch5M9UWbz5UCy0GNH68S1ISZYKUIGeYTyQJo5LkPLrSLplAOy7xWDHJvb/HOGt3BIbc4DQz0PjASVI3dW6s4CKzb/Dnvqv9c3vlwC8bOpL7moOqCBtaoLRtVDqoi6PeMFVfIq5pDn/Aiq4rbLX7E8F+Ixct8mSL9FumZsHqlup5wHWtER1KykQhexOhaRfjgIwMwHU2hqEUzTNELTQ/TUO1B4zN4/ckqKvWIMyhFPpRyxo6T/SpRjmvZD9Ci0H2DJ0aJ9fFzth2ia9kOM6XBy2g9V2vX89K+acUMt9F47ZqM3qnpxun/MJ9OnnU8mTZLJcx+CZo8b9yWP9b/Fkmf1tWSPTdUuRbvMkNe1pgfHavqCq+lBV9OXpSZMEu43bsVh07tLm6VnrYlcpAhhZyrEHrklVyCq25EZCqBTYIQ3yekBnR8QQkYTM9Ow3qsBR77LP+wXmYoQMkrXTFoCjweigN9HY7EFfVjo8SzNQJzGgzJTmgAnsWXeoDaOtTuYkZ3xo7AZdMszzW739RQ3yJtVqGlnK/ClTMUuzVRpeQtj0KFoij7znFjVjghPMs/MPGV4cHPquaijujeexQWYJE8ANFwoy1MwgAo6trTBPYNEHZ1u4DEPCdRVooWVgGQn6i3Z2XpPJZY6uCYF4Q/XkKJqSjkGj/1wbEupWslFjbZY/ruql8+WKgIAYoNLETmjSI7gat21DeCepbp8fmVRh4f1eURoGdW2oeX5AgAIB1MAHz1GYDX/FYHV/DcA1iLFBNMGArQFygjMePbrsKKTfVUngePhF2n2SLFAC2UMH7XPrpcbK5rd95/+/sEPb3/RT3vc5HkAF3Pufr8UGzpDRpBmCpTdtoz76s7wRdxJ84MyhuaPrANoIhWj2dENR1CrXf105vXE29fd/vOVECeqjtQ0+ID2L9Bs38u+ho5x3cjDr2I+R3b/WP7Vh4H1GQ/RX7n9ODPuiUH0+rV19p1nSW3obgiF07Yx6t3fg49oZqiuuIZHgHgMmWtcU4pKDRCKpujiFOm0IgQtWkaGKJ1jaoSWmTvyad4xZGbGSBUPQJ44p5JGFvrl6Lh/qWpZ8N+y2NLpohznSmeOluC3Rk5EFgX+W9ZYyOznIfLyX48r6OarFPKXPq1Kq7bSCvX6iQiMUVq+nWsjSKZlpd9Gq/BPUoR6vzI8HHIkXohfDuqLHoo/EMiLnpbfG9BWrQCOH/LcaPJvBxO6SqtyNJlTDGM0xn/CpOMERfO+pwLga6QXRO2cCxGJM5jqHnXh5iCkWbntKbjV5aD2fSve9ufb+MPt3HGSHsGb1Pa1R9kpn2iiU4DaI+8XEdpPtB3out0cnlOHlmVUtlcA5iqQ4leBNwjpYfF4sUsodokWFGKJeJ1bUIh1GE/ULw8/ZijDd5lu66XyFsyoFFYPf1t1WwneloodtGO4LodiWx2pPUUvRHf5qCJvi9wYiEraAS6s3cYpNK4eHilOpVOH+Wnu2x3UFTxryVpbbF+jnXQa7UDu7Eixi3YxTTh9VIuFSyRRL+DMp3KGkmTR6XR6+XJlbx2fmy/p6NCJAK1pJdlC7HDR3JhVEOdVgcUplYRTzDGZ03BoUl3aK355Qzmk0RJXuSvbUXALxHmH7BF2VPQUtQbdF6KgBvQb5fNCv0sQkaOg4iRK0COnrmXozoJ+N7C/wfyL0gbCHBF8RNDXSHhB0UgExWmRpi9Q2n/BWnEGddE9PjM8E9utZ4GPu+zF+VlqYf5sTu0eyLfQLIzsh3C1c44YG8ifgEWWU1/JhxNAgkyGNkFZu3W2ZfkTdTrlT6KYCjLRtSLHzPPtzCuejLnHXZiiqHMuZiInEQLHEMC3RxHAV3e5r9w/LX9gMx/2QEIZZmeBFj+Rngh1nafQk+hJCJxHZ/OyeiZPlHOYAj8hn1d6KwBzFgJSnDYqy8eH0UKcVi0xWMWMVpc3ucz87YjVIJMqHUbCMN6rk7bDpGqOCfCMiD0zCBkwf2iblqnkBIWeVxIDMsSFVrUe2o4I59oHdeKLpxBxwGaezLaK9uDOEWEstT1S91bXH61a2/H1rpu2AqF4ruGxjdpApnYf4g+ZMG3jroQW/81As01rzUkqhH6BIdZbSyKd5/wx4VXLlEopr64CZDpL6CzhQbQNZIYV19QXmfpYkrnJYIjg/ykn22N8pf0FlFaorcioK9OTZdF8kl2h0BLjPyqnbW5doidLk8d7jZVjO9CZnpjnkJHRdjRVTeNp48CFlG1bwgzgoG+a5xn/ZyCH/Bx4ylNsBej4IwXQk2nV+Ea104I/lvdz6Vw0Bc1DqxR0283KuqLafGML61Y0uc11PeBpG46ZNtylbcCtTOkSZwROyTqJUV2ySLcIdmGROnh0aA6POeUh5snDmsxGsEQkJ9dqmRqWSrHLDBbxtUHL+Sp40glyAkBNp0jKeAjpMwFlOHJlNiokpo0RVXwLObhdloU2rZp0Jr4ltckASwUbwELM/60KAwRLCyQqORzo5iuW0tBKvsRlhcUKilJuSataVWyTKkmqPI9WLfKwfgHymykWjmFRSE+RrBmyanJWJmfK0AEjCB77uGncE651qyAaLY03JDQNWT1OQ/oveDzasgowubasgPyEjvxAMnqS8GmbZiWPP4i0dtLa7cRyc71KhLaeBBHaprwipoafb+WaSPqprifH6tI5n/Mn+YoYhgk3pTrbKlSHTkB1QGbGKI9SnRXEAX9XaKHSvi6y/19FiJR9F1KTh/zweRThEI88q125Sh6j4aa0xFEOBNKSNhREsyMEgky+zJKqc5VUgWbN5NuVLBDzgLKBY/yFhx1ojHIV+XkSoDzHk6vKz5dAxnCcEbLEUKNclFst5u+h83Sgi/MkXiIvoFwjuaSn8H9PRtIeOt/kPB+vF3CsvHLhYDOxEmE+blful2LOrt0Vzi/jp+3feQIQQG27yhKeos1EscQNSArbAa3BlnOudk9npHbZZuDg6IbPzTKdHCeeaanUjU9GqZrir+68senj8QgdW7I6RjeUMACxfUUm4unyJGpyOfU8VAKhBZKZDVuPMxvcTHji2ExwyE7jG1mO2yo5n8yQ1znyRDNHlJq0TfPIzIWtx5kLOg9SimQ3oF6WdWerL4fxkkEzGyK4xqXGR1hDjbcFL+0HL857lFLXrIS5j0J1GyJCkxXLShEsFWFK2B39Ub+y1z9mXwjYYF92Y+T9R7mCRwyNGEIW50NS8ESgg4CCm/LpIgJ/mpyB8ik5Z2XRIiivypKeUlhsH5dUODRVjLMNsCVPR7nJylIit+BOtG+ycFR68qVvz0mnuT0+tQeSKebt49yXxzCjtQCGRhUIOuHcCG/WKFv8cSGxVb2M+2KIQl8GeCHzchgvmXk5iBe1ysazbxv1npWHmIvYHoTmGNtYCCpW8bikgK2eSbTOc3CxTAog3NDleAruPznPube5buZ5SU/xLJgIgBL8EyiC0nY1NWhPX1ZlWaPtsqRVxEDqRVR3dAbKOzD/qpr/Oyr8QbkrAZiN2Uj+JL3I864trS+FFNwhXvgGQ4ogUrrijqE4VvAKTnQHtcPsehEgvxPXj71XADZf8PWYubFGdZa9IIppAL/F5u1+vBWNyrnlup4k1KnuhOS9Al8r/spn9/n4HXDpB8Saow8zw2tyd7P2LfiE6mo27t0wTiwx/6W3xy+PtnFEnNecffs0/ZfAD5wzi7ucbUSrpflp68sCcMlehZ62PTH4CEe71t+F3DmunR4c8vkIDkEezgeV7urL/UKRkV0O4SK9KB6pBWh3DocmdllT4HYMAaT3MD50i3mpIf8BvSp7M8ehCYS+3eyvwcEFGq3Ggu70sxvQUmeE/ka8Mt0vm4t24Blm/wwZvLZHJPg4QSAf5k242H9BYqFl/AaqwIcf99Q/Xk1NcImxM375EaS7Kl+NKpHmfIK4+rQFIU/WpPQPYhRR/qrUN6S9OFeOdah15A9sDIe4YXNb68CG6LfqCF3jvI1MjpW+vsaccvAgG4SH5adrKRAt2iLG44phUWdkR/B5wwE+Q/BqDobSXGMQkuKKylq9dGEyrKinleHBRWyJdNW26bVohAkfQrjvsSO14LoJZyrOc8nr9BNx3KAaLOoHIQ/0HntY8Y+COQu/tvjwAJwUPyc91gjF544zbvyAV7lDDTsxX/D05PreYXlyffQOBI03nb7YjDo8kKhNLIUONFVNg1bCRxHWg/Cby2BwjwZHfOkcq3x1fyX8oIZhEO12G+TWHCmD97rYQxJ7i6aJ4x09edeupdrNB1w3pV33yTuyaZIW9YXKF4fXR74IDq1vAgo015Umn7k5fb9n5zTD/D7zwmNZzul7NQ7E0Zs4MCzYQtefcQbUD/OdgMfv47nhKRG411MiUKFEd3lVUjTwqrTosHd8YnQLbA5KZzc3D/syYwL2Beb5PGNr69cvzp3VWrVxyzWM9iyvl4a58hhAqotNfYrVd09RZwWgyxG9741/8yuDf/rNwdO//8LasynYfBlgf45IhiUxmHT/fY9jLpLgnyG4R4LHEDwXQRwDwYoYgl9A7C4JbiC4U4L3IkgIqlmyVQneg8+6SibzWGvM3KcLrsaWqzFxn4LPDRghxH5B9nrM7jxRe7UojslNXsfjZXmjupQyqU/cUspvsD7QOIKrQhTDh6oCGEmF79bV+jr5xtVqdV2NdV0NzmacUrpcpbEGI5jHgTdD1cw5w6+9d/hurKU+FlG/4tFMEelBX2U7+EIInIJNSYl2Ht3a8FDwF7zsDei5MVqs35uNOtK/p9CFxNh4hDX88iLGJxJD0YITUrTDP1tO3AfWJyja0bcej6Id01RC+N5K+AGElXJ8RIMyS356kqIdlDj96pZK+E4NYwZ/FCUgyK3RWCFuLrghwbs1okrR0DVLnwaum0pp5R3ZNEmLur3yxdHRL4INeZ9O0e50peGzf18UTdhAYHZFhc9RORjvHKdrsaNrdYAqVrpWV7oGqnYCIoY5pNB49v959OwmoWcxGUOaz4OelyIQfDAjICSuqCvFKxJSYncEnD8lbJ8/NvThjSipQlpGyQrm81Sy8sPHJyvq7vcxkpVDv1DOnvt/doKsbNx5PLJyt6aqVfVK+H4NY/q+rwwGB39ukqw8WPnqsKRreKBhIM5H7nQERGKVO3LBuyR4VCOqZAVds0TiFoQrZOUmeUc2TdKibq58sTH6RXCXvE8nKwNXGj77Jln5JlnZnKz8yBSyIgiEwNsQOFmycvi4ZAXzeSpZ+dFHS1ZuiVnAEJX+KsdJyrVmqt1RTpyDt3EwexPqW5HpoYluerysMjteMjk5rh6ZG4U/NjvCC2v/wyH+86p4f0kV7fccH+v3cntgsVa8Qh5+lcBsD88rNFunw25FtiegUECktqbeOa3gqHr9pzc0aFzEzg0nTBGjUPO5m7SxERT8MfKQ+mja426xFLE1X3QRuSC0U7uKhnsFy57AsPpOCf0d8O1y4wcKRlcRegiRl0gw49A+hNAKnSzoOybLKH4nZfaWKzgsC65RrB0KspsFn+t9/vwwxjuPETwowQTBQxJsoGu786bZCPhVcRremmIAE1uAxpU93Qs0N98LxJvvBYDFVxW+MeQVYlRvQQvw9gL8XCXKmLEK2TYlMyjm2uzHzRQL+NsJPt5dqP7paNSM9b3O6VJlfoICec6xbyCiCH9TSjvwrX8SGzjKAWGKDfW7XZ5cSKDPezU9uAfPEYGELeF+G3jQfHoIn94SOOe+Evs+Tyt6lz7hLRifYYVwE+7wyEpzcGSlufr4U+5llgRAJrjbEoFYiLMSgViJgBJptSbBz11u5kSg2U6wSJNyxVVte6awamnPknHHUCiUzNDotBC7daZSQOldknALfrOfGCO5anZNbS/r12VJu4TqXkG+IbhqY22C4J6lEIoMWmnkLV4JN97seFWrBZrhXdUMGyMZtAHW3zH6UTpTutv3cd9/3CCk3oT7pNqTzG55LT8hDkbzxWltt4iGFK4XcXnPkN/ejOVoUNSvtJb117Mfw52W27OfwGNYJBwZDylZp3rF2usAEpIaz9qzv2X18585b4Vd3JQzGNHOg6P75qGAFazP8wH3SL2noDUhmbrDybpjuYZJ8XjdIeoObd0Xc/Nd3fXN6+77Svzc9dXf9WM1X6i2E/y9zhNEdisAWATEt6w80JusCEGqItxW1Vt2rNK/i+HDD9r30M998Q+f832XM61vIFGyNpHUhSsg0EDI/0EUkdzC0lKuD6VVZiQlfBmlN+RirjJGWUBOMWg2N7nglb1NlxbQUByGQUcdzdjN1dsiQ0y2Olqznt0MSL/5ISbL7K2f+O+SXtHC/GpR/dtwkTumCOPTwtFalr0RZiCBZeq8mvzshxEjLkI/H/iRk+ke4/tOibMC+WXOC3pcGm4M4dgFbyklho3Yae4HoAGkYa7YEQLx8wmHPdWpn1ECQ078SUtDQh1AmBLM3ZASkIEG8WeQX8fZb99o7NJX5X9qWvNbvva1676mrjMesqtJk/wDuIIxsqpktwE5VtCge+HtZcROQFudtsktAIeXcGWBnwz30mCftjPEM7ujyHh+IaV7RxHDwuBADGIQRw8o5ZErz7hijqnY0TlC7XWuLib+Y0zI3iwzXs4mDgbKplMs9boLGVIgfvbwZXCzakvX182xFvC6pmiizkIqFCnhQT2ZmfOPj2zmfHPm/B95TnlzFEV6zfEV/+qTPiknfVhO+trkhLezPW/plM5D7Xs+o8DIO5Qob5FMFQjUSClJC22qZ/8EvLYEgXuSoCeBuX2ZiD8fRZMONQ/QjELYn9g2UyB6Bb5QG8xQBXtGmcQA7O6CsUq26wB7Xaz2ARq4pWVC8MeCF+P/xc3WE9CmOYKN2BaIUqtClOYtUVoAUWoZojQPooS7X7RgiNILNiFKc+NE6cERotQ0RKk1QZSullIdURJwObrUKv1ItIwfiUdBl3740COiS9+kSz/swZPR402VyIfCGCBzo+xHqH6iPVyiG7j0U2GoJOcbnuCEhuC0Hh3BCZXg/C/0mlIBVwpwCckRUlPlXQLHu+DiaKfkWfwDCr+6wk9JRqbEqlZ4YsPPeIc6acIxyw3MJrmZOUs45qvczBwIhzjAnz8B4ZgdJxx/9poq4fAdN3MCwhE8Gm7m7xnRX86pu9y2XiTJNNV7lWrR1AhPZPQgAdPXQ54J3GIC2HOLqPpaEjn4jZ6W/KB53q3JcJQ5KlPfMBkesAUdMwEMDnymSlM9aeozruevMpYPYJ2+J0DKTZqijYpM4MHQBO7nQPpF3wsnvQoYVZC3vGaam7tQYDniTS903vTCSW96Ll1SwTg8ggrAfcCPXnYHMqtjuYh4BPVV3CjBOLo95PWVEGJqQLLOYlD5vc/D7/PW9huniWHFY54Pj3ld8QpjPeYp2sR4lB7z4gmPedyh7I/UY576NER27Ey5RSMe86r7za/6Yt6jce3IuvSTrxldl1qVdakUwhX1UgiHFUplyJVFqi4rGL5rlDI8u0AVDVxL5Gcq69HmS1Volqq6WVfqFYsf2I7XMTd1IdLZ38rbCCRFQ4wpJGS+xGKDRS5xi5wLchEJGpyWq9tQWooWtiFjhQEszpGU6ZRUFkLYHEzsMoYO4tGmFj8mF7SQwsqC9hXPB79qkJ7c2pFghFdV8n3nHaOHTLfjXeXemiTz8q0Ipn0kora3oQ4IKSUib1hPeQ21rwJ0Id/y1xE1/2tPFRcSvcIZroEvBJcXGOOQDTmrAE75qmolt+d1l4sFBwcWCHUFG7kMEYd6ADtbwsluUYLv/DV8Kor1MFHty1TWz+ZxHPWlTCzgkw/PLjUZkyFkEoeN2THjJK25y4ftZQ0xSshU0TW0WVlD8T21ZA1d0BDOX+SyfA0zt49BlBpgjSH7I9mmd2CcrC6f9clezj9xqVzOEU4HuIBXaF2T40J130e+1hPzI2E/EFJTBsQDkxRQXSSXZvVNDOyh2MbfARLhXvPcbZ5kntmYsbu+uOKMc95DidGKOsy3IqT110HNAn5g1qrT/GKWgTCrdivq4kfTqg6r6+aAZiSWfLFb0RQwp6iLZjgGj/1id3UGC6ZWWhZLbTYC0Ua5nFLRluHWy7RDo/JI2upaGIij/0AKubIIYGN2FhFaUrWFNekBzjRAKlvCbcBaX/a/Aciqq2mCs2SY8rtDOIuB7DSuppYs5BcIwnngEZCK2CscEUI6g72ydh8MffD6OKVytlvwDJXNAyqiuHs8LRSxLWuAInsv2uYsXviOyAaO9Irm8ZViCsx6oCpprLrRCihEesXyRlC1vBHo+tZl8iq6TaAOo5Y1uAjHDXGZ62pUyJ9qVaOT6onR1EQY1BKTG8bPjJoE8kqItLL3CWulnYFtWM0H+jYdEqGDRESR9JTh4SAQHlEInQACVRhgmQ3UptRjAUQegKq/2PMqznhCZ/lDXS8ya0Tei3CRnjw4dIZtri7aC+rADVdiipASU2DfGk8O/gh0CdT0j4UUhI6avtX3/GnuFKlm/YV6+E695iD2xqmxD9amxX5hauy9U2M/PjX27qmxF02L3O0ib3Ms2U7ZbKvTzV3VzbYZxEryajXZGYPj1PRCBpK1XjbiCTL7KVSlCZqqhmG8/cYZZHq2541+WtNPDT/mIXftUeZ+njbLOuNVNhCimkB0IEqv5hC+qIm7qlzFJ+9b88B8QbpcqxPf9AYPJZeukAPlWMFTSskBmuFnR6wevPKhwMRsqPAw35XOjAN5RSe4QQHmRtWZMV64knDUmfFFDAveHhinvny8+WV1CapHgXr8wa14qxABH5Vs5rp4/TWP3HXx/4PandE6dAirg3yMFzRWnbl5/PN9+pLhJTMvXbx05eXsGmETQc8SGvB/nlvkLycBLMFNUaYH7NQ6GkKldTQNiySgLxQaAgYv+3kZK2xf7xTzkZjg2N752NDqVPfRxQTbPzhW4+dH+VlHOj8R/y5+NhTBcQ4SrAE+TZ17TXSkKWiKscUCl9ol1zgawiZMaIZPZdLFY0nAdpSm+AgtGUa/BG8EnTvBoLd5Un/2GXelYCQt+wUlQjJUhYnGEAPZOGgI0N6ihce+oq2tljKKGXh/1E+KiGbwGay2uK7kKXG8XIPiZ+6Js/4IroZEMonmMrz1xDQVbscDsw7/L9SkoKf8EmCkpQDkDe3Q22QGtwCCFrVtp/flbWlu3kLDW/RImnvx16W5yWbNTY3ARCF71jcAZOvHg+xZeVua+40D2XhTyFINKgV9oavZWzBX0Lar9PbMC7gFPkRACS44wfspeSiSmQ0tUJ0W+KrOU6rnXaeJbzdaYNmoe2hH9Z176CmxWCd0UZypqRvoO0XLK/3tqfyNwvQ+r7L63++NLv9CgRxL8WsqqQE9mhp7dGrsu6bG3jmNhQJgp8TeNzX2ntrUlk2NPTq1hHOnZd01kbM6HICUg/MwigPehsdyQuFdO3VhwLqJ1TH7RVmAoXOIyBCRmUbmoerBXD5V7SgSp+cB4bmbAiw1NdWsw/KSiMN3DXeh5CPKYGqEWzy1GbmpmMKqI8Ysr4nENHDL41KWwsDcsrqIaBpXSE01kygkBI/29+Yppub3tT1rONcYTWzmM9SUT9Rtl94dOZD9klJ/V6lsFMRWOreEOVg1kk5p3/uBPLUyNNPuwojumrpeNNFc7LitN03pIJi15LkvFtH3jFhfoBgAn6GaOWzAb3aXuSoohoS1/IumTnRf2BVpq3Pn1aLWUNpCTbO5b/PGrHMHb17tgmGXU8DHmTzDtrhq8gwlbWLyDPTRFYRBSABO9erpxlHGbEbNwalhdwdcpGlKhYAE6Qe90PoVMR5mfWG4UIEXmHdPrDJDvCs2m3Xxj4VMQnr5fXqV92r+Qj2r+npl1XfMpuxiPbkfLRVoSXXhUeqkItDvRTRF6K1WTxGUjUPhq41FSFcqsnDBj7vnXj3uAUdT9dz7q685vufejwZ+xmpaSjSPeSo9+KgnHCuCG1ibaqIEFu8Xw999j+rYoeY8toyFeQNtQJJgsJz9qeEDXea0PGpz1mIG/JxBP/H67ImaVazC8cDZo3SfQitw/CuVlDNoW4ZFNK5Y2uoZN6M2HrM4416T2QlgCKct6+4c8ZMFLdXW5PMk0UdHq8sXED3RimJRoz86WkixlL1D6N4yLZANc4gWTXiJ5svwIoUi9J/Fx5yHvzkyoMUjIrbWQaQONWAXKjHGRRWRWohsUYos1jyWYWfT1wURLDrHmBRTTk2qls7x1gLf/stKqoHmFdOLMlvyWCk0+UduVVvjgU7kqn+AUQdfTq4VGPY5cHFyUmKZZyXXsaJ7XdBNvSPHPHmc7+RaSdSrbodT186W2CCKZT4mwkShucbTUUOtI4jp/EKNcEA2CdkjsCm6spjp5ZxMbeGa2jTDYiM18qJ1xinEpqC2erzSch3HIAD6KXlmM1FdUT/heeHklso5w060ZwFmDoSinvqShxsA3wrCJFEWpeydus1FbNXRNH+fR3ZnF2G7p6bzlXLIBs5Pztf8slczBvKxEWvpvjKRh9tletm7lL0iv2oz/1cQ+a9Ftd59Aqp1MwO3an0eW+NhEYgT+8EdeYiS3UBBIIjoUR88VyrIgnVAY/0I1daF1o8aG65VtO2RbzBcdzEBPueYI0Pd+j8HcolNvQlsSJ/0sATxIIiS6EOOAQ9rBDiafXktfT5Km3oHyDdopCYJAbRyMr9H0ASCBESGUgsYP3nx8QLBYlJKRdKnSi1GCK14x8T82mv2cy4rrEIrNanlhF/8bYdlg9czr559Tc+ufs736ifnZUI8szsvE2HFy4RX8TPhjfuZkBsG6mcC/XETI0INAcWKThgXc44SoVZXdSwzJrQzJqTYzBgkg2D4+KKlPiek0Lqgns4en0ItPQZII5k9+gjlgTQze5To1WVCTU6jb4Lq5EHVV7GpoY/MCZoExfrEYX2Fa8PD4n6SFrXR769/lX6PDCo/e4Sy2X+Za3lmbxRBdMZ/oYSdRZT5yrGt6rU3LggOzxOA4I6rcVB0aB7um4Z6NA3BPLj57ONiRD1FknONRB6EBcaaRtHKPoVMFAsTehW3F9mj7BOIzVspdE7ubIo719C4sTx975Ca61ynpzci2uThsskMHlcVnf1FBkZ81p1iCq7dFPG1Dy5GblZ6cv7YWIfGDLf+ZZA4cPPX1WlfF/bbod7zrGIBAASLk8/QfN6hWbjapA5EGsZ3CUzoq2HoRHy1gotYdDfjV2mesjW0akZtFbPze3zDAaGWiQo7cb58CFQzk+BBBFsI6sFFyMGarnJzlGTvHznmy5fM3ZGomNGecnX91gtp9rkGnBbIEc1VFAirTuPnSv0GcsGreuvYZB7ySldWT+ODoCWtKzd1wbl5zQhVaEm1gToqCEqoge8PetiNCcybGOfMeZjn+Ku17/PcywMSPIzgCxwYrpLgAxYMiUocan1+0dmQfUCYvxlVLUhcIaErupr9g5K9g8ObAIwPxApAV20rWphQh1+A1PXsKHIr2mCq3h+yNVMe7DpbS7um6PJgvP36kQxf5gxbyCV0RX8sFJ25sHSQ0xU3sbt8NHtZ3TV0DWp1GLHcsj/qE2dG0G40ThHPoqHDP/Jko+DnMyAcIqDryO5P+4nfw/Pr+26Z1ZqGeUScLvwiP8X3NEpllnNRWE741+SY2LCcMRyDoD6wnIsU94qO1Kpad/y4/fPXH737tV958yuBGiV4Dkawmz6jFRU+YdCzDwmMFXUXDSqv6GlDl2f4hjOnIzaphnmPEpFUrFICgcpW0c4Qc3ye7IoWmdSBNYllY1VH7LskNkTsPGLVaT8HhHBgzyTRxXZuEpvohhwIW6NYIuc5pqC1Arhhj12/yhtvFYpw7bfMr5GF+Axttxs9JhomqOCmZdqSfVh6G8Npy53zgFUsnlpumRclt0yQIgUynx5kSOaQMblXU7JkW3jyDeo8Dg3aZhuEkDYo0AbVbYM6jwxMddeqzqNt1VbbKoRGWjVfAdPMyTQodrCJN2/QjGvQTKVBKVyza0sQqpwtdao+RJOq1+aWC0Yu2IDh99Jsf8UtKitK9QpVS5F9+hCbtwa/Z3gf5A2KaOlWbGXnKND1aQAfxZgaMpN5GeqHVqrfpUWz6ac5WU5r5bi4OcQfqI6vQgM90Nmik6mIx5IDShVgRUgeoJj9OoB2xzD7iJEdpCR3YoeElXdwB+93TNIcBJn3BLkaIQvynGpK66mb/QZyVF0+Uo9y6LLcSks0V6GRSJqjpSMuBtU5Z41D/q+IwGBAWW8w4I5DMiRqdYjF/dmEaVqLaah6CDaLG1R5wQu0gXZuCPUuo8C6QKFSbBFBxceQ5VnQ41mljMxQ2b3fz0aRYb5e7pUaYlHlfmHZ5olALfuAKj6r4bQ80puXRezuyWL39ryp8uq6ueqN5x69UHuXZ96P2sAxG7jX3WqVK6Hvkyd/4uvzoLk++6A3dn32AZPxTt+UdMgGbsGnGxWV2sCq1B4KcQ0/dCq1plWRCdxlAwMEwoo30IjvVtr3g3vJBa/suYX0IWzrtceJKSjD64W1XeoDj0Q4X73Tntg77Xpxm70pk6eH6EBVBAEqv+9l7zXZBtFabqRC55odZ3n7+czgErX1tCeP8Nib6+3wj0Tg77W6N2s5AFEl9vYy9m0uFgcgElsbj+kfDNeyW3VXEptrrdqmy2VHoN9854iKdsDYt1ay+iEZ7aMj6bEwmAWiTgriSmlraKStkZO2xkbaWpedX9L3KBFpa0Nk/nkTNSDJSVqhnTgmbZ3BWt2ZJm2Nqa7S1pBa4go/GpO2htOlrVDOW9PEfE4dXxP8X4Gdx2OOZimrSlsTCGURkCxKzOwVFaNDFSk+zan2wwyQbLZ/U2RsV/ymfiFuiXRHOidEdp74eXS0ofAuNSSkgPx2xlMG/DuLl0X4cgKl0lMT4U+kUJbMTvR+VFKEHABtZ9Mcs1gZ5pBUzKHsDBCc4x/r+iXESUQGbzcZNcwdbSWUbUS2qYUsLetmPR2XKqa/Z92MikBVaTtexKXfpMtR5Aomcm3ufnTqByflihQfhmMfnoRb0r+cqtyvlUmh0LH9LZQKZXOrm/3F0tBlstfWtq4X1AZ4h0pnBRohOschyEkDFB0W4Wjh0Go+UfHxWPEewaBkBCBGFJpa/Bb6F+ahqCkAYLEFWECxgqyIxyqPIJ4+cQOi0QYUEfQbwW5xABWNQndcGL2URuZcwJNngKcjTbv3Fw2bmbjNVmTomIE3PxQAmE3V3+mKDY0DRdonjrOygv7ONXIvF0G1IM6+bLZtMaYIDgpyVYCGre6NPCy5texNqB6UDFJ4am44PQhcwc/ejBtjFzhTw01wB/wjk0RFDx0rP8ukLnhHm9W65vo44enkC8Fe25R53LX3XsxNoAVu0hzag7ME6Blj4oaYtea80tbZQp0tqZAJCvwWzQMo84SjGSe26KhDvkLOdou2Ci/4oc0W6U0eSk1htQ4U3rbD2Kiqj++iBqW4FNagDu77YOUEAW1A/SJSLfR8kV+Hqk++ALGRHDOC0Kj0QzMn/MiMNvmKKFaKLyf87Ibgo+BhFW6XG9e5rJf9ttO23M0prQPsMwASwiXVmJPSKAYqZOofNvfUf59QzEyQAbRWR2NBUD9vYeRnMCSOG1wOJtg1OO/r0QwkS8tGftXYC9/RLfiOqnr0VGAqb1PBmhmDNcMKlMPK+U1oYA62vkULIL3LleRlO7oxRtd1hxs+21f8Kub25/MCDIoFueV+nvZTDzIzrnPB4hboPA9+ddBpfgSx4PUey8MCkhnH0IBZbUAqhRZNFUw25bqAY0MYpEVk/WfrEIz51w0pHvOv62BhRBbhMJ+pQqgIjX/dGVNyOO5fNzhJz7qh86wbUnhcz7qhc2RbutM12tubedMNpbsBU9qqbNU4051RZ7rFMi0PKg51Z8Sh7sy4Q13uP82Af8tD49C2qQdabWrIbkbVpEElDgj2q6xK8zRdnsPIo+Y8RrKpMKecOHWzvHUFLTLVirZUUzWn0bO1MgLblS3SMI2SoK04Ub3sYgUXSdC8BPVOy/Ug5+pRs5KlhC1NAbS6LUMhxSrjn5kBq2xlZ38+J/46ChZLs7IL9YD47NwRj0RvvAGLr+HKt3JAZ0dCvrj4uKYQ7EfmghGf5wLmYEaphObV92SmOjHGP4ig/zxDSzz15zMtr+pB1yF0SBkY0RlRqTuCwWwrtV3gpYVHeWZA0cDZy6bw1iEtKK8GWp3prMzQnnk85qkJI/JN9fhICYnG6hwec+RD0cenFG+pnbSrlTUhEYZ33w13//YLd/+3+3R9N1RmG9VpeZhvLzH3rouGGtaWFTwpSYmN6CLlFDqZXl5QEzKKHZzhFc8SNzSvvLTiJRFuGKENoyQKKvOQLah/loyMjfBLst9Rxg3MTMJrYuEzhCpNDJDrRk/HnzupRG4V71fks3h8Zz4nJeVNHSp1CMG/O9BxXn1ph4jsY7EDMId+tIU1hgM7pYz9BKQ2FAJJM8NyHIoFjMs082etnmQeMojM/XtU1tblu1n9BqU55aN5kGNqYZRa6vBAtEWWUeOyuwGURyO4pSpavm65RqUYs9SEv6WyZTaVe9WDhIg7hnYKIgEbqbWxLm3GTvE2Co0SB4RUEEHNCGJzA31gn2l0R7U00U6muPI1KBXyK1lPKdOcmYCVclHB4VcD02LmyqLVyzMUTxwIHd/xMl0DU/1UDicOwMsivPkAN3QH7YRIQ2LHoRijYR5astAqpfJNpQGoPXRjcSssIm3OTtWqWA3G1lzLp7C0y3bYK5rmijVx5dwC7OZm7hBCMBgaNOAeJ8p8gcAWgNZgKGIzJ8w6OgABGI6IuobSygHn7MLo00C1xvNl8jA2qrGhWmiN/u7S9qnPyhCTCh3dF15WXhYmeceOQ3wq9WBKS/cDvoo8EbIiTwowmYMRG9H4kEmO0a/A236IiiNouZ2wmBdoMea4v4OAXniAdNfEZL+rPB5H/sInfv4TNTlgdh2S5ge6z/GI//h8+eeRj2vhxxmX9rKPooCygY++ddnH9GD3c1FD1PrMLiWu7lQO+vuLuoLfnp355A/zRIhOhDY08KgVUIly87SqMCQXod3gY2m3epjk6eWLjbyj11wydgmTzyJ8o5fPyam5eOZcqJQH9axn5YsuBr7B6vCtGBsBSx3ncRThrGyeH0INIPpo6ssAxjqG/OtULF2Q7xKnImOG1YGUxb5w18t/V/Ye8osGTkD5cqOWzsj5q0dQ1mDEd629uhvJ1XTngiYyfsZjtBDfz1Em7eYw91PIvNYAc4kZXnX3omUmWmaIMkmJk+giLQLBMXe0Ci0eFVHExcHihmsyICFAFQfEeN20wbTM44K9AObFGFzlMggt4YS1RWlZm8rxW2PlgGuWdUCe8+C1scqI+qkexCZ8GJCneGmp2lsq0zepXmYU9Vn+AWkplogrZqn4HRyjQnlqOdG5qEQPB7DMiRaXfjS+7Pm45aziN6t5Sf7owYBqYBjhnDeaVkSjEqhw5FW/umeiRFgNuA0er/SSpGY7Olk4w/+2IiJ+QDBPoTxh646phqu4EmRMBbdfaYYGNVG/HaT/yZhrOaxUE6SuRl7VCh5MxZLPtLIGM46FD4Thn8TlEUUvqm0U/BwUeDnCJd8ZefVRrTAVtNibrSF65VqEu6fehhyLAiS6lxi6LUJeVzWrsX2UT97YPspd+1Qf/EKPyK/gim/2UYlWkvvj+6hIE05yN+W73ZRP/nF3U35KsSMG5YZqiJNHt6IPBhS75mpbjuSR9N9ZYgRSTfQaIEk0k8R/P7N4JwGPeAQeiYgIKvCILTzi48Mjpvjk4REzPBK3u6SILEolR4dolD+57/HF0s2Qu2C493P3CqO8Udj+fJmb67vJjmKGaJNgNzCOuw4zGEOZYEzYNtbTH37ctSgTc13wdF90ewPOVtGn/L0T6FP+UxDE19Wv3UzhMCgVGb1+cADcgHgnJf7jk4lIdw4i26tDMLI/Typnsg4Zmi6YQgo9osNLLpXS9WHRdPBOK5BOHaRxYQGQbpNP/HdlDxGDIawaWPCoOr9l1xf2DjlLYwBVLDHGMVBeQJxdqtwqFCmCa0nIyz9vhta5JncazS1i9lHiZvA9qi1mRJsHG05eGrCE1Khj60INzzE1JBSuiSHRmC95Z2PVZdOryzZsfe2yvrbUB4mgqaPFsXkLcageiyDGg9KydL1PJrqE9jZueorcYhSD18YGn24SsQaAaROFv/RHgs10md0N5cCqJEOKGDHH6vhijQsvM3ERvx7oQxMV15Gu5jcOynpVUYQNVBG25UNN75PMcHosXidfjy04kQLhRD+BFAqVI2VNx0i1pf9IzwzE3dPJ1hlqnWjvqJY161d6/Ze8EMLPPLITIULuiq61nHRUda09o2vt7vDj+FQf7qJu9nE5bNTbJ5Gw3khDXXr9fEwL+xPKId/mBYFwyOWlXgxhhBBMlEToEAbWJuWxmvSw2b1SgQTnqlCsh/oerkZhhRHdDd1b6zYIrF5kN28NrNgNs2uLcV2qDpSqm4su6XlVVUpBKu1y9fb8xGWE1Kl5yiYEapofG1fzvGe6mqfuZZIJdeT3nbyOLdBTdWwV1SZ1bJFHt0FOzVaRL1Dkc2q2vz+qZmtJc2xIcwTiPE3hNsQpjsGzwB5TBKAUFbXb8HhqtzFHBeX18pZq3yb6COWBtOzYcdVu/wCpj1L9/A/H1c/RmVL9HC9j6ud7p6mfF5iijChrj0IHXXV9dRirur5oier6PrqeffKR9mx32bMw+xQ+/jr05Hur4ofHYiOiCI2VCLEkAqaHP3Kq025OukZ0bSNe6IUy31UuHNjrjuWNK7nvKE9fn7AndADTADMuZnZCMNskUISJpO/Zn6gemxDXWKnL7fUgZcq3cJ1YTlOl4+fptVC9O1v6SYSskSLoTNT1WA5nhLLLTxDcqbYXjZeAlqpTCNxSapmdUIFtiFCwACQB9BXyJXMJE3IDWJvNZyjKO3KA4lFbBhnJ5sEOwGBEy5imncFjhjqgoar0GVIdx+gqjkQv1c2wr1XCuSKMrv7UVUVMGW+N2pBGSJ/nKFQXjIieEeVMgUlRJ/mAZtaKdH9h1AkWcMLFW6pFZOzsX8uXxARsitdlFrZ3BRjFFq5YslKL2ZMV9JM6nNzAxvWrfKvgmrzH/Vzcz2XCPzrVUUC0HyJ/gHob+kNtcbS2Vhg4bbeR+/s/tKZRTYmq9WPzTlzQ12qXiXfXULIWBc3CEUOCt+f2ih1U16wxoZEr+rJT2BeuKlV49RQLa5RwJM09d4UIl3hleFJqX7ZCMzwDdAjw7MiF8oL7ocI9j3ZCI5eWcTgzv5b9qc5cwAPFdymiHQcwkA0orEuxmMwzxx1sPVBtGUP8gC7KWhopa3Xzsq6diji476jYmXA/5VEo15XzS53zbs/5yZNAyo2rTSsFLDMobsagnLIPlBhAY+OvC892ijCIDdoGRCC8EfF5DobRuHYJdHZe6nmvMHxH4LQ4TG+KCA0ISR4eGuDZi44hOhmSj+b4KGk6Y1obZ0yPwA2tf63TYoiqF9Tv8gt3++QsAMFdbLCqiapNk6lWxkJR537op6jaM9pPNcvsyba9n8HcUARCTxSpAac6TNsdq72Q7zf2w5dCukmRXLnfKaGzONRV45OoAOaQ9WDG0ErwWF0sM38uy0wiqnKQlWHjKA5djBzakodIzxFRdgvwiLKfwaoBXgCxKM3YlOGkzxgkrsuCgIexSBOoLRQNCzMoF6cDStS+SkN01QM0gzjAsfqB2T7oR2heRFqx6tFx85yM/Pi+kV8w3TeyWlatepq9uoiF2jlPs1c4T7Mve8yeZr84akoirpoZNVD8i6m2QOtyS3XE2GjdGRutTxobdemSCkA+4mqAyZ218pP7nOFRhkL2WWd4tC5jq4YFMO5J9lNqDVR0LdFAzaf6h7Ayei+WefC3amZ0BGcid3lr1MxoyE0bSsGROuFC9rzOTwpHzYzGTpntl5oRpPur1wUVPV7P7S7VM9qYmcu3OTOXG87M5bsQdBJ+3fOx7BBIBfJuGCTu0wI6lslUxZSnmJdEuTTuw1ifcgZhaZi5hlCzUi5fNTYtkHIo5K+Y80vZhg6lZ9fYiHWNUtCRVklnsPtSd1v4sPAgnpC8hVxnaiD/uXKg2sbygzVJjzKlilUk71Yr+NTKY+oY4wbCtaBwlcdbwm4NELgb2eWBLBqJUlv9+kug+QndKJyvz1FbTzSgrUKzB5BxrzRoES3YlS/1PZHld/lvi1y2XpFNKcP+oGgbL1K3H3P+HtcyJytbD8yBn9eQl/+2ctEr3Cp82VEazpzCKm3tJ8IeoLQ85mpmzHG1T9vJ43auFfDys5vvbxzFDMEL8ctd9iXjl4G+6DUPFipv0wrEPT4p6uOcW7b+4hWfyBf1jJp1jG/d4CsrYM9HPG7wDKOe9GJGbpPX5LQYrI+wO+AbWs8pV/UVDmrft+Ftv/iMj7njM9KjbbRC8dqj6xSuhU10ClB75P1Cn8BJxMJ903adn/O0RUYlrgDMVYDyxPq2loxig/Fiuyi2S8sKsSTfwiUtK8TmGU9UnYMfs7Sgp/rAxwLUJpXp0A6whfCAcs/OPQF5O4+n6OHnOXEDSY2QUU4xnkXx8Bc9Kh7+J0/7nRM2tToTMuV0fOjUor5WkDIU2n46WXhOFSqyA7DoewYhSUC5g0OgRwysF8vNkR3k8avAjQPgrNChiNroyLl2crOSLd73MjQRtYcaHMp+Ulw17MAREu1gjaMgNdI5qsuogCh5zuLJf/Bh26Gy1cImtbrdCilUBiKP8KqMyxoU9J2HjKr8L32H50UVU4CxriF1NVIVnS2S/UCoIcQRIKFNDGXVPGBTVMcb34rg2bW3QVv9a941eNWlhR9x9rmq4cC4NBwY41VNPsBwYIwIZzgQL7DmPGo48DJYvbvbGg6M+7dbY1ExMoQy3GoOR+3sSDey+60xUZLqGBwTdgT/8lHYEfw/ztbfu9OYpWzsO655ref45qNehXHuYxcNqi4cMpuMryqiXj36+gLNdIUz7v48tRkoF4XVdlMeyzPJ60C+C4EiIlu4E8+6tUYfG2v04kVAbQlCQqU3ZgAKntLy/ILHOBmBm+Cbx+KbVORg4jItglpb9rf41mS1nzZsDr6hIpxts2IxPEX0hkS3cHysBwmk7shKciA2HnulXtROXgf14Hb/r6rTgSLN/g5Vi2OkIhvQzL6PPfW673/L4HNcxyylpQ3zoezfN/SEa5pO2L5vv+yDv3XftngvH27MZX8r17kT7R3BVDQKc82f1xzgOhY2irZJuZwZ34ZeFd3gHrZx8iHSAdwb3dj38oVf/NY//6Ebq7UWi8OB623b1sDKMu3JaJznOraawh40lqB4IH1j1otbMnSfpbB6faRYomz9zZUa+QpZxvaeC79H4qhmYWPIgM+I3xeHtiNg1a1emQwC9lBjg8O2u7hy13UokOPvyt7z1Y/iA8ZSFiKfzyvQq+uXXpP71vWQL9zvg96Y9Ts4bhUfep5ykA/JLkUN32Xvv9GUiJOXJTce1EHzZ0XTY46D2RdRtfROr/tkCPlcDs7OfBVcSWIfMiMQ6H14HuDA1QjgqI3x62jtMrQULefO9pPsxw5avDh3TaFhdaTXs/cgjSKkoU8PvR5yxXcJltaE/F6CPRQE0sFeJa1WHo+PsND3f/sN+OYdlW+eV35z+eg30gdtWU03pH62oS2Q1/7HXz9eFpVldcfr73fVghbr2dZFCKtFhqNFvulRFamAFNVeVyCofXbo1a6k3WVJuyZKgqPGCHsF2d9nX75RioDWrSb233MDGvZmvdmuKdmXzPpXs1b+pxMX6lCQ/b1sfDEI3pi1xNunWUuciMXiqDJlSKCnWH/GzlGsKH5B94luR/br3sgX7lTaw9wQA67OfCBivzA19l4Xq/YHJfbjU2PvnlrC+6bmvWsir5f9uLq4810nMJUdDP7F9xNe6NzqjTVz1FpcEUlYyYva/NUbaqWxpDzWea77XyxoeaRGpIu6LadrN49m5wiXPrD9R566QiqUtbIW5hramibKT6AOm0jtamLf1Z+IBTp4m0Fc20eUcEe6edf88tmMfFEnZE6RGcqe2IBHxIEI53kIgCpqWR5hWdS+yW2+VKs17Wmik/yXutqZ0KGbMSV5A1dyM3TZQgFc2mi/0vSewK94QaIRF85GqKXOhSvOf7kGvWLkCctq7E58GUhwnv89J5P3H+xJzfMgnspK/9+w0hAeZ9XNncwIByhuH+CBulW1hpwGia/FlRoyw1LBZrDv4Mr2+Gu/8PSjop+0yc0FLZt8dQ7qtGzIvcLhqF5kSPQiQ0VDiRJX8xFKxu8y1Mkj/uOdhZe6Nk9rTS44EEOpKoJvFO7v9/zIh/9h1/f8HYMNykq4T0aWHvnp900nLWQWzewfMQYlN/dPeEO9Y2ZJa3rZWm8ngNGrEqPXtgMofqZaD4pyYrm4/1ZvTVk7ZfRkRX4QNCGvc6puCMDxMWrE2YPC/SfaNuxlVBYa4kduMSWlWTlMdIyHu1kLMwRI0aMhaDumjGg4kdONF9JwdpSBmYBAR+x06u3ZI9RafyjIs1RqwgXaTCY8yMSsqdU2N4Eaudz5nTXm/ogDl/W4/V8pfXwUTSkJXJM9X+LsswiCOHIVkAK1cYPenTxoXzOUrYccMd8SX5NWSI0KOW3KQZuA2iTtYcj1cN0jn9OmXqtbrZeoh66wyLRlbRUh4qqEuZDc5Gh7E5lqkKmjhbMSiz3xwpqIPWc2wHY7dwqwM9BShf623rZlhBTY318fB76WtgBoy4ihc1icxQYg+VysyMaVhdaGUodBIgrqeoyG057M2jbXsOop6370Zfh5CfALfEFs+3EuB13duAEfg6btIrElSIsQPi4858XF4oW1S6C4i3OBq68p2vB9LrV3EEsLtNiDk3SEO/vhIz3Gdei98ESW/bNOEq2SB9xuhRYMoxjDZlP7gMgL2wwjtbqJLlA7+zt0WVVpvyw3itRuo940kE8VFzq4bzanuNhWzMxScwMZBVWwhrQwN7tX17J/0aCxJraK0Ol+eH5AmBGKL4nii8ATtoAxQI4CnMsXCrWHVmAK7rNYrsaBNE3M9l+2Kj6h2tPtPEshAETdbK4ip05n9BzzEThqJ2exaKfUAgqcAbYuCCg4VNFVG1kOQC11zsvdDkWKRSeaZSxch1YWblkq2s8wduqVBiy7ZoOhXyNabnFkdiLPYSDmSLrZKcdCtwxZMaM7h3nuujWFtISHAmCGrQEXmd4+ncPbHvycW6RrIAYyAVEDpQgvyhzyDekBucPxYuW+bQqJcirXUwE7fMsP89lE7gy5M80NdOIh59bOqyxH14VQ14UpG6+G2XS1zaYrAyK6TRfm2DgixYqaQveVOcQEHX1t6utXzGsy+lofeUULzUK0quYbP4EX5uLe9YnrWf6fSFVeejgOw+tCWH+rOqsK9VMxj6VDFJk5G9nNXWQ2dwbrQ+T0ZIeefenVGnMwg7LGHSroEi8xINCZ+LHf2TcrHUdAWBMSR1JFI7dkYI5ebO+VXUx1MSPh7tLKmhe5r1L1AraG+xBVDwrDsoihu1E7rlmoOvYHxRaqriRgFSt5EqMo1s8kC05mhASD/B8wt4fb9uyjxUgJEbAaoWpt5I1Re0DZ1PvCnR411nEHyvUR1eYRzk5G+xlB5DDSSf600jtVehvtpDtWoTrNQLsyqyRn5Ul/eSc9UwWVBTExi2W+dOWTSAgnxPwkXhdagLwcTEE6mD30Gufm8GE9EhRgqJJfW/ciI676QSRWNVmxYTJ5XyX5ksnkPZXkiyaTz6ok764mU1jxdPUWr3Rck30VDZ+0S0GBphzHFoXLdFL2JyjUzCdhc+LOKAivhSB97LiQYTtxPcA5muJCN5y6PG5DGOHeP8LlYHVPgGGk2PLswSTPHlEwPOKu0x0djnHtAQWT/HmgIDDWIJwosYgqli7qCt9K0+RQLRGnbt5ofzftp1ftZ4PG+9Y4bt8aj6Fv6Al5UN2Re6hkO6TbD0+NQteBBbh/Md5P7LQVJ76heyo7MvS1SPjgWeY3B9CnSUy9y/fi6dZRnNKo2/gUqlqnDkGNRfU6RXoDQ1c3kF+OS8AYJUahDoUZVVHRS82+poRnrAo1Eh5b7yt1rSbSk6LYMlEFTBRZNxDmUz1O8UvPA9lBOfWqoxH10gvpaHVFXXaKehfNU7UO9TCiJyctbaqu1RX7OFcK6VFNNl9YriIo9R9U0sq2ceWGo4KZUavcxalGJNrpOw0+tB7ak07F6b95/nGMPF//2upVSOx9uBrtGLgkhbYxd40M164VnkpOQmP2+XDgRdNGvaprbxTTI9kuxiO69hEf5XAsZMViR26/tsGcCMo8CVUPWO0RjbQhUo17Z4vcB67CtrC5v1raFo5K28Kxatz/xQ2l0vNIvfUT1wvlIbR8VOs+Zuq9P/eMiB5FUljRt4/R3Kq+vQr3qiaHQylVAKuPGnRlbnD69rHq20cyUHpEFlQ1oT+LvLX0NY/zZR1eLNERCjhQvaTzI689/iWdR6lY/0TPm66fCxMy2c2KsKqMa1D8860wlNsFybVTEVE3H6HhbHWCVbirOr8mxur+AiYRiCs1+LQDMd0146Oe6jifAT2iEFYvxOXiD7w4xyu2C8ZFceXOEHaXLCzYXIQHx7wvAE8B2YTRGsqB0Sd/4iYiIHfK+TI+5Ky0YLSToU35WsUigF7BSdk6r4tqYn5WlyFVXo7J0yZRrCYpik71+mE21YxLc8KMS9M1cFatEQxz/qmes9GMXLeb1eryppyEVa7bzdjrdjPHv243g3tIRdNdt2tSc9PrdjN83a6ZUmfq9cNMPnTXDzuT1w9npP+d6dcPq2pZs5rJXT88MTw6I/CYBTw6FXh0LDw6x4dHhzonD48Ow2O2Ioidodnq9UN8OsExNAWZMFUGQ7iUvgLHjU630YT27R1A7D/kc2a2yK0X2dpWvoq+qb+UjaK++RSoInfHBWceo/AbeL2Z8HvGCr/9UeG3eyXfsmDZJAuWVYXf2bjw22f48h9TmJkqzKe0hjPIhT5pjzedW+xQ3aErbKBU2H9vBCoecaptdWey1YxowIVNGUdGqYkW6lU/nN10BgNFgllquwZRfehgAa/mg/J1ROOVkUNX00pn8qZ6F4MKkzKLG4VN3ilFM63zZZsWEMh2CPMIFZv04YZYy0goVlOaD6j4Qu+IzoGEW5dOwMJLx20a3ht6UfXStlnhsEgE41e1YekDl0Qmr2rHj/yqdqDsGAyKjV5NDoU2BJWr2lWzYuVFcQqPTxu4sSd/NTnUq9rRVFoZj13VjiZpZajmL058VTvQTI5Wnhge0Qg8gn+1q+tBZd6GFJzMVW3fXvMv3fgPn5+eLhtksg461b0OWOf/DvtcT/+BvpfdAC4ofdyd26hIF9Oiyue96vh83qTDC2VEqzchP4eIzR1e3Ox7jZO7+ViEvN1y3kX8ys1H51vEH/ctgvPWB5X/h+y47uSUuN2MW4+25+Qqi4Sh13LzhuXrY4osX+9jn4r2k683ExQwumvwqKF7wggZ5BHKA2nZF29wNxqDiRuN71Dw3ZMF9euCEUe3keYJ9uIIGY3zcH2url7jEtmjoKm6edT/LPIUzZk4jmueH4Sp1bYs7JYO4dQa0TU3o5vmnadmhEVde9XkRyuaXoL5Qo8cAkXC2MQVbY1x9RQzckRPbVNBUyEE6NmPvbEmpRNNkl2UNonr1MJqWhham2qSy2tKH2kuQRchdC2Qj8JUoVnpqWJjtZOum95EN+NqN03boHSae8Lf6+1qU2dLmuA5dU80X/QcXKc0MXGJGuF0RKQUV0M1O3cmzvmLgNJqxwEIB9FA8ybgB8oxSFzPWrav6eg3aeUaaWvKSAVjIyU0BNr/ShxwX1VATX52IyhNy8dQNvvL3yZwC/VKihEtvxo5tAi8vsZ9EKuandBNHw/J8FrRt1F4iHnDa68ZHdMGHp3qmKLu63EGh7AFWTYxvs0paOyBWwLsGpThMQnvWrU6+ULHEx9OHXMTy6FMs0nusXbTTKXyFKch8gwoqbTdYWyKGdtE0uxYt0IUOaVbTcrMmb/W3qzWbj/NKt3Slof4cFq3EBtqt2Y1G1o+3mCacZWDKzPdC6g+vVtoxHiPkk16lEoTqK490o/HepRM6VFiPpzao8T2CNm0/2jrZI+0DGyTtEda/ViPtE8To6Sgn05cZvMO5kaqQJVa0OMqdtgR8av0Mq0OFkrhZJd/dqwUVzb/CquviiE1/SB11AtwnJg96eazp1adPeMTDZ9OzB4zH2rTZo+bUxYUtZHZk44OCuevzh5DeopUDVPxlHGH5Ihwb+gBUx/dkYSGMh0C4clRuR41mujXIVptzgQUiQ1WX64utCz5anKu18vHsZCiEDbIPBv5TCXwcgGBBwlP3MfFeOq3gJKyh/JtLhIlbYXbw/xJGKs5bf1DQ1RAS3516TIGpSJdLhONVe8XoyQwVSysU0NgkSdoji7l4JLwiEbXXFtEPEkKyw/FJKuMqZbtVkFDERPHkpA03TWSUinRQx6wapqpmSepdCgYa4v9TLfzFkuSaQW7jrgvtBrzoYOX6+rEFyON1zaFYx8FEx+ZFoW2mmD0C21oONqVRLsSVroSjHUlGe1KMDlq/lhXguoXytCbD9P0bi+IBK8qmxggcaBhXXnVjmpE5pBBD2qQFhZ1i1QJYiZqi3If/C1qXbNWIiCWQTW5D7yT77DC+bgL1hgpoY35zZ/p3qsuuBHhPWKs9Sk2DVWx8tALgpPoifYgRCN0HYycQTp/CrxCubBm+P4aGHclL0Udt7EwgyeaXKcITcWnFI608c99L3LtM9x+EYLfj/r+JRIVEb+/lGnZmmgDqIJNzJab+v4L81DbQjAo9wYhGyFyhaWhevJEJe0mpOFYM6xoI+NrdTeik9kctjnXSrUJ/ArJXKaq6yPA5ZjsjVI6+uY8UKPl0gVlxGM0VEiCipn12+yH8aVeg69L0XKdt/QWGdvq9PwO67Fuh2yHYikbNX0bjh/VZGNdLV2ol9QP+IEvpwuod3Q34GYbpDzSzsqyoPiiLY8Ln9QilMQQsqMoBxq9Jy/opKlo8GgWBYoUVNNcbvPlKq1kIqToFlbMKbnNKaA/XlFRr1Y1XkERV6pA+aVml842K65QwIP865Wx9Lf9wBOHkxS4PWMVdjljgB6IwzxTXWchTswCGbURlIpQO+itca2Pw2E91A20GeiIy2zAigFQNY3pubQnvuYqGvyueOFbryt6PmSovAVeoC2NJxs42pwiGa0KtQB4po60nFB4GPABqlpZqPjbuLAWpn+UBKFIBPpeHvhTNvkzcRSNbfF9HUI9bbcN8SdW39CZ/wKK9L3O9CKqvAH5Y5vfBDGuIrHIoBPT1BC7i4D243CsTdFEm/AITZvUa7bjBFS9R9NcblP+SIOFfwhcG+xXSl0i11ll/Ud5oPHGup561Z5q65QH0mM8PdTVSg0P47nLHbFjWl23kJi4RJNbi3JclqvBZQ+FPmNyRtWeAxIOqL7mTewRs/bX9azulrGRbyKtJtSOTA6WPzlYx93nj6JYqK3wR6EeVmVIyhJsjl+eE3n4FWi7ZvkK0AqstVcuCRFuZFDCRLYwlZ4UsWUIICoVU+uJ0bkPSShCywHUXK71q+tgigmsa6/wMb4ObiB8jLD28h3mXQA+JhopoW35lgCbx5bwtpCKciuwEoIucfs6qfW6H+eGWPlic81TgwHydfojvh/qPW1fl1sfrAH7AuXq8eqZIfLQVnVCU4hIetxOL0kOvPST6jrIjTcZi3g0q8Y6lg9TR6GiieUML7hhHvl5oPWaVkTyFk1phX9yrUiU9NuuKEOYvrnC9wUKkgqaUmDAIy0s/BG6Gk5ZL4s6apFu+bkRBatJHUpyj7TI6zYtsi5Lujq85cB7fD863mip5XOGTh7bkcNkApS4XeR/u9FNqQPJxyCHOG80jo8j49RlHm1ZdQzd7nB8DO2qUngYQw/tC6R9Cl7gt7QqOE6rgmmtYvzdpGUNO67aHd0Epj/lsX4a+cr4ApXMPkQtlFTghjkrH3KvQmN5RgEYEWAOYSqoBT/MGkPIWGkzIhL+fJR94/HGBkYYVAyM2TY9W5SZ0l85efOPx2ql/cd3fe6jW6aYf0SeCfuP7+S8DMpb3/m5lrP+ePi1VeuPVtcnUm2fTdys9++67oViSebr6279R197PLuPb0JqLf3vj8Y64o/h26p1RPTGmUfE27h9xP5Uy4/48DGafsQIVk0Vokhrq/DvVpI2XwfVDXV4beu66OXWr4DnrieiplxX0DyymIAja20PSyAz2ydc6yb+2WcU2IuGyu4QlacU4G428mhqDsXFXSMxbY5Z1Zh+fECWujUkqXqExBcd9Xt+ndgAki0ydTbybNx12qxsSGapNuI6LXOu0wRBYRNBbK7rjpTapX80OM9Vjm3e3A5ZrGjSqBKli8jkllINi/aiMEW47IKrGoM8S7UmNCYbQj1H9ZPVUMwcLThXKTQL1wbW0VYHGZR9g5hwBk1bYkQb66laI7KKbLptgUGlmsr86rsQYawqUdeyQBkwdpnfw5eOAKgO1TADJDQ9c43Lqn7eHbzJBa/qaZOcX3YAxqjboehzp7Rk1rakc83G5pcsOJ94BN6Vb8GD8hXKTELvhFWsnmQVqykX+qPadQNvXxV6i60ovkcrPIhbhgMMY8YvW2gVL1uQJ8treMB26FI+T1vFhOE8zQouDIALQ85fK18GMtTADEYcPEqMdGYN0VVxHaqDmsmQVq59cPRs5fKVS+N4mh2uYwS55R5tlVapaCiTRgxHnWLYFqBqX/e1Y/WQmG/fMl7LliO2lhrenA9lwGiy2jto9shwskL0dYm2qrtQnefb+hHMYemUJJ3qC4Dwap5ze7bJ2XtdTu+24YKhIMB22CEx9p63ShJtA/9S7M93IHRNvpMWqEA9+Sm0nUMhh07lGXQa/+3C1lqJPdDcPovT2drR5RQQnth853QaGldYk1RXU1DaqrqC+7FL+iExxel0OiwwnUGS2b6eye0rVAcVzvrnaFEL5Opr4dVy4VLDV3A44/Rt6iC/qEk+X9Iul3wa3iv5FshyBEJ7Hl7Iz8KtyrG4synoP1AD9FXpljlexsEz89NlnGpi3+p0OpttSMF8VMpvPr+fxe/kI9HGzgOeHfEarYUdRWEgnnRGfjoBg7luDy6wCyt024lBOZVOBTC0s9oVLlP7q71Ru1XWttYp1Q6dVOPRWB421/xH3PKUduSL3GBGGxWIbcc9Vhmjmmu8GznEuU7I2I92YrsbQynHVydA2n0ux4xstRxewSbK+cYd420q0z2N3/LTaBc2hLtoqxXkbVNzwduoa7xC4gabgLUDcKDbXB5Rx92/nK1QIFgTMw70dB7WSPwoVa2PZVRDa+eNpTJeubluwGYNS69QHb2TZpvaxVuXUoucS2jjDC2BJ1uqXvgSIqQUpk01JNdGkltlcmsiWahZvmCWZTVkGOKnJuaI7sjeIKv4Nll68506bgynBXsLcKudNgu4BTjHj/pLhGQt8R9MBAuXRaB4KHkr2rJ9P9Z/1DZOFnUgiJbW8l1ohVp2Oy0App9G23RwCtqVd5Q2wdwvvihKFMszMaa7ID5kfcUnjoalotJI/uiCNg8iP+9uWHdGUIa2I267IE5xmsZpA2UkaZux4D2HZvBauSZdxHPOXIGguYml5FTYdM5RYk477fhuLYdp6/RhKgS22xTSp5mhWCC9Vz02YsWcDpCOA/HfTjsWWJ/UMezxx0K7lBPBZ2EoviLNKrSVdtGcHYsdX7ex2FYZizkzFqdhLHYhbpfGaQNl9tFcPi/NOE0lV+gfrFufZgdim9SEMkZqIsQQ7USpO/XGq4LIDMfSZrMmVYAaHnZfsa2cB9t1HhSYNruQqFY6sYx3GHsX+TnnIHYaFaAzLz1Ac8wEIicaupj7AB3ABniN7gpwZbdW7cQibYcV0DnQt7kRSoLO7FL7pbvQj10jDvEPlpen/9Lz/M024c8u/PK883LyXQmavLeSvG8y+dxK8p7J5F2V5LOqydhJ6g1cWP+x98cRma2V9kl+4rUVg/2uoHC0oKqH7bOrl3PsKKNYI0EXd3p285p+dS5uXhe/nC3Zv5w9gNk96CAoTZyU6pH9o3wuS3qMc68nwQS3qzXYEJ1qnGo/C+oJl704R7Pu5wULHcFq2DbGOHw1PtAxTFqeEZ64O4FzIRPNM1x4u5iUk5sX7i6ewh8uCH8YE544ycF3u/mJL4imme1c5JSMc+BZ6+s+I0UXM8rAH86Df0dgAYnUypepnXfJg8lZ03d4v8Vld4+WYEY1X2GLeHlPYaQsN/boW6gHO6naFwyceQJeNeoBdEWv/2AgMtuZfJWW863UzbcFew3t7dkKISfmSacV4IUMn0A9rYC2S8QXjaVVULoMn8wTccBmnsimjch70qYCvUJbpPatWrtWqLWjKV//2nkncjXM2m7jB2zzslSvWNVWraJF+IZjI5gyzck2Cl+YxuKrFc5RN1ZqeSXiOmZFtICxIZxd4Gth7Wtl+3LairexJoKr2d7H6GZcgpdz59DIVZCg1X5g4FWULSsYGzj4gDZO+D9Mnt3oJ0yCcmEelhoMM/VQW55TT7lChyhE8r6DdqAhaBzaJKAVKCLLiuy9xk3sbkWDVwEW04KjpgUkLZC+cB5AFv0oAPrCgn65fzBYy7Fbx7NLW+S5hZqM5wHbR8FqGhh1icushITT4GL6UqwleQ/b/YmJBOhMmYno7mHfTNqDNvCAZwL3euUEW+1X5he3frusG6s8wXjmuUmWlZNsO8BAPCJ5jz/dTlDBIIxVxpN1RvBgJS+4hFqxolagJZvW0BOs0ppIalqgnkWTbbTdVEi1MWQBi4R8GfJpclYmZ0Ro01a0CYNAIjSuc2VbBaGomGhHzbSjt1k7+i943JrSA4i0KSuYcjVLCLQpZJqyVdAczfTylWAvADh9lm2rzDI6/iwDmMdnms6yFcSBSqgBb2ow2ibchnpO1Pu/Y+ap0WrML2RewllEL1+CxpzdvfWo+Vy3OuV2UmHrADZqnpgOizHv7eVcWAD/RTnltIAubAfR7gEyksqORRT2xaIQcSzTknAKLWhCvkAMAJpD8k6aN7nn8XoKx2oebJuvBt0+fJ2yr4oHlVnaE5yd1XJymp+gq+U801Gfle4s2NF3mIcx3brpmLrxzMbG0w0ZjQ0W4rZKznmaNyOd2ZHeVo6kZzAf9U8fUR3NlCJhXSiWiQZZgYZrHM7EZwoc+lurZ4PAsqUf8nx4F+53cmbiRi6FuWDogpEo74gp6AMbZPNcwfZ5h0UIF9w+OGS/6h5WbvdfpzfcR0wGW3PBTmpo7ip98eJ1ivbduPHkv/z7v7zwacN9P/Sy3//xM3/S50pKqa1+CdsSg/TXk7B5nfdKdMOacYYZCXeEQWr9eDUP7AV58LsId+ELF94IjDqAHsLU1ZF3gkcm5xj9+4bwdfAgfvWydzO7HZwxTDwnYDXVATM2izk83KXsk0Q1htX8gJq5D3aZMHG4a8I8WviSW6Q+GFvq26KaOuUrLU2/UmvibZFQ6Mepu6/Jo84i86JDgUiI8NaljtyupIyF+Z31Mi91Kq6W9eprUKtd/XQjyPflXjpW304+o2cRBz3+4/TKpWU5joTh58rdYBYTz6hpTUbFEfN2M7DxebdfdCBalrHiSjS0U0NR6YC7lf0UQK5u2Vdp5oJA88EFRvWCqm492ug1V0dtdDiTAxlcgi1mKh2eqXZ4ZrzDpjna55m8M9bnmdE+49p65X4497mDbbaDjfQ4Nz3mRAGIdlxQquZ0tWHVu6VYahEUR9gJTSDjcfCwVsVDgLJVYg6ZMAl1aJWYpqoqikPV6MnsWoxiXk268I2LeZN4h0jx4mCIxEz6e8045D1owuehSbkPLepiqutour+/95qiYTI3KNzjvyvhZ3BBsJGoe5Z71kfds3wU7+qeRZPkCvrHEUz7kij0R0Z+P34vMX7GjRm0Rp/jJF/RZHOHXNsU/jUFt4qGIHCvDRyzgaOJtajdUmLXxjqOunhs/P4eCIAasqZk/DzYWJPwrGz/6tTBGq7xVGc5CBLJ5yACcimZ5vBYOCKHWRTQwgChOSgez1FdrPxa9qLB7a9xW+Hdo2ne7sXbwL4dw9th+3YUbwebNGO1TGbQjUWVI9d588UDwvuB/t61qkMW0++7UhMY2MBhGzhoAw80Ldhs4JgNHG2KiC1fQaVd6rIsEqGdCPXMLnCWVuW+p/KeWy2Y9HUb4KewSwV2czQnbMA2mkeeWlDhBDACzZFcW6k3mavezyrgnKcVtKqHR8/uBRNJyhR+TRWTK2jxkpmXe/FC5uUBvOxWmDPYKi8DvJB5OYyXzLwcxEtNhySjLTwrTXeXuNXUkJ4IY7ON5oAqEt4O/m2rkJJlZOPNA5idcXHKB7nHxTZkA/AMWKYgPp+n8Of8809gLrcivJXDeJW6EZ6EGnAoX0xFvA8R8bKgD3Xxis0mMHYLLYJJMoiXWtA0zUxT2DTNdFPgNM2cU+g0ZeJRR3YpHfLl6QvWxnD3Z/0btvUYQhHHy35alrY6JLgEP2PMYlLN0oWN7GeQTI3S5cTXmMw/WKcGFoov43mQlUkeqAP8pwd0fkAIWVuuGlZbrgiDDgfrsNHagPbLzeglEyfMDS7pXbDoeFjDGwjfpOG7ED4k4fP8G9Wgdqw4nv2CtD6gpHTR4vyV7cbPniJ2/sp2OX9lex+zv7LXhaGnwsOKee2mZf6mE01Ysyc8u9SEoEwvTGVvESCLJ5cFc1sWDCCUIHGDPcvb1Kw4/cDXOP3h9AUNMRAzUq1YZsW0bNgwz/4I1jphkyehunzi3O+duEQuZ53TOdgCGul9OlzBMqqjWk8sXomze6Qm5o34M3HsRw0cFYjpY6v82igZjRY04eFSCbmyIXp5zHcaHBhfBoxUkA0AHWGC7GffgmwmT3abJqeUaLW8FMOkOWSUrfIsD+xYdkTvkHGFvF4QAVJtmrkD9lHgDa8FlOGfPcMhULQmjfIKzoTYXW63gPTd1HTmAo4BFfxrgQ52IxA6XSZn+2IiUMs+ALDl4kZ0w88j4hX9qC+6TjyvbgkpmIJIcNky4CSK2QUbnhGFDksLG74CcOwV7HvoLuOGcP3NZeLBveSCV/Ycj/IQa6rdzvmxpe7DlirEvdKau3HXAHXfYwP328CDHBDmg5+gDB+XJ3/i6/MWX9KDw3hatPvgdecHh3xTwsAG7jKfHMXzmI823O2hDRL7Eq3ngBZ3hfnmcn3NtPKWZk0oqGI4CuiCtEnP+PeWUIxf99HUL0jMMfxmPyGnEQHjQR7isTuP9ELQ6ii/qZGXa2QAOvad1bMkTT5QSb66mqzNyP4Aw7+CE+7QIBMG80j6H6vW3atG+9XynjY9e500VV3bfYlt4opNPklWOzBve+2odb6TdOn5MUpDRueM/wJGaR9/1/qOOW3kTZDf+SpzqkzpPZkypYMxpvRmx5QOHFN6O4KpfnHX2BdvdV/c5b54m7KxN4+xsUrRAAZJydNsKETBzf+qdbAZy5x2lDnNnlvMtmvKl86B9oUFtO/yBe7kIQ+nb8Kr6tqNjicaXkbehbyLR5Jv4ZR7M01ZqVRGnbxHPng3eDemOXji06zEOvfbkJ9WOWiZW+Yq8CAwt+BWiAYIbQVzu5VaYBVaJXPLgdIHoFDY+aqm1nYmmTitpy15Qd18ByqeQk52gnPFWo3AwAYO28BBG3hgzgTutYFjNnB0jop8G+3IT+H6ToWImU4FlrWUL91pO6yvpwESyqYqFLaqRAqqAPw6yabOjeTaSadM5mr1MwcYKDLgMOQUPE6hU8H4nGrY1GVlU1VMpi/H8JKZl3vxQvrCXa6yqRkAVfJieBuUvFgGkJW8GN4OJrSkI0Q5G0XqATbS7VO0M0AkxQEe71tJMAGhQYkCGPyrehj90WEvkBVH9PLcQTlSc5oH/4j1dG++3eAGi10TqRNvWhlthVKQlH9lsa3HOIV6OLB9rBa0Id+FNqNMCMxpSZB38STL2VMWw3Ep7UJHttMM/iD0oDnhUOdoVZ6rlEKmlFIPo9WjTNnUmXKZegGL4e64w63Cby62m5e9e8kFr+xpvO7DXfCq3kMBTzfvJcCjAxv56TxbMO1xkV/0f/aX9GMNcw3CtNOdzadhThViAj1daDwQ+7byEMS8BaOwnfX4mV3QAtQCO3XUXnuegYXdyuxuwsNxLFtDfQ+86VWHaooK2bpQa5flbs3yYCXLW5EF4cyx7mco677djDGTipJrpzOEJx8kCBqm/LC+KFd+UF7Alm9ntvzORLltS+/qWA7Gef+O4f07lveXAORF2c9KeyIYO9jYd/a3rH7+M+etXOzsoEk713nYaPugoOxO5MbL8AIu1ecxBJ6hDbu40I0h5gHhLpTMg/Xsx6Aie3v2E3gMi12EL2nXOtERhxMDxvy+LB203bXgIbGseYpS+xbmH7ucPVOXDnhX55Haz4ixxniR/fP1pRBEyik6MMTdgNoK6SfF7P4DojXncdQsZfwWwubTHocfYYUGuyC5IFRLzqTZ56jjgmNZ3qusMYuVlWTHIymU/HxLubhsoSD7ORmQgpu/nWE8y8/wguABfmIy3o8nXRDcO4ujFnRsReVYPb3iwc4yWE8NZ9FpX9XTVzdZQE68OGjgLhsY2MBhGzjIZ0uy5qL2LlSrtiG0EyG7puwYW1OKyfUEK8WJ15ODj+d6sqgUX9cTfTms64m+DPBC5uWu6nrygGp6NNyyc4W+6IJ0ub7oUrVXxgh7QlqFOJIf+7l5CWjtpb18nrq0ius9pXoe9NDwfirXnCvYGLg4bc3XOGF/vlKuCfkyBx+YZYqFIyXjK/hU2srZilPWaJlD/P1WlaecRgtkgmcxrHjs89q7H54nfnrvfpgFtP+PzzRjhfjD0+isTUUtp5nP+Fn5rDUFuc6i0yBlOQ0ilrNoJ8I7jcSlpRKXytHVKUB+6QmEYT4vSqeILlk/dAskUD1fSVVGhOUHq9UqrZjVk+dFvgvPe2dzwvPB2RyUiecNLqJukcVqi50mUOTuiFfdYpbOdHcnMiU2c1zoZJ/ynS1PdMzuznJ4s82UFMl5f1ohBEWFECxPKebscrKn5WTng2OZC2fxBGnpWTdW8LPzs3DErY3bISLNNmN+fpaaYd6BvnwVZqWvkUti81jABJUw7ZHv6zr1F2XqoxVdRk8wkpj6uZv6y2NTf+UbYuoX1alfVKd+UZ36xWOf+js2n/rQyT3FcHstcGg0j3NhdN9M2FYpDD1n8xm7lSF2ziObrlPQ4ZzKZD1ndLKexT9AQt3HbAOvtw2gRqtPweE/A1em4I5SWHoF9lvzfYLEOZcO5ma2qqw0Nbh+9iiun5WfreocqczVEr+hZMLt4VTj3GtOWcyE2lVOb50igU3F5+pgiJgatSfEgkiUEA6NOPJ08dn2AEtegnW2hU0zWrKyr3Q6Fx7S9kopRObFx8suZ9O1UipFYIBc6v2cOl4V+Cg2EYXNAjg6+K+C6PQeKFQCm8CicfDZEryIQ5dIaA+H9lFCZ+CUT5Eo+3nly1z9cgcHm1AUymdDWaHuYYwcRGM/nqmRiYaJJSsJ3Z5e5HnXitg1IPEVckcRUQSBWwQJ2+47hlQTQRsnVmRs2ZvRjvQSKHWKhGDDSAi4FnBn78JrJ+2T3ivMjgn5U5GByVuD1AX5OJB+yffCKSIVtWH1BxVl07YJhEWIDoWmQ/APGuEEH+VHzoqfvQM3mi6pwK5HUAEkNR3YEvhDZLaOMVmGq6848AxJbb2L1nUIlQGcSIuy7VopD9m5tr//smvIXzOubUP9Vu4J+v3r2fuquO6QJiBO7/uqO4laxVaAh+8ycY2dQSqVfVwaohdPJXse8rN0IIFtQVQ1LHx8mN/79Yb5vY8E5n8+CvPPfKPA/C8eKcwHatsnuA5Q0CMZhMojGQ3rkYyX/TPAmPvqqeAiY3Q/O98/l4Pe+f5ZEPNfKG7SVGCoZm6C85AirlqLkLfVPrwRoXvhT12FC+Vr7CwLRdjp/EFLLA/im6zQjHWmVtnUTBGnJFpZWERQLsededQEjzRM3JCGfRmAy1EgLbjETRy4rGdcxSPBw0Xx/WLbwUeCuPd4ux96Yv0oYrKExSZAq0jtdwUoO+IOjOx6a6JzNRGVrD0DIfFuDIUecZSPRknzNc31D63b4LOoI9xtoIjbGIe8K04oGRTJ0PhaUbsD4jk7qVxubJJfeUu1wVp93L+z/iy1DYK2EJjCBDd7JZm4+KG+MNb6/No8QvUjw7JxAyTG8M9KtiWN54s9rqt93NSmmj3p8/QkTQ7X5Le7DnMDGJTso8BWgFuNjPQ9OST01W7KLv4a9/dfKsUE/YshFynLLdfTdD9O8Lzc12F2i6WGte9FcOT7UYWn90+qNuw1L6ej9VoGpAjGvscRXKXjxecOdfDzfX7AUm5VyQAeQAas9hPkQ0BStQ84zRhAC/GoH1Foko+VcyAvGDaj4lWgQEUGNraFOpyGmPNNF5IPJFYDMIrnxjyMuLeEz3Hu14sKv0/Ef5f1ZKJx/M411AzbZ5ys7kGLSG+lR3pVPoTBga7aBFpQx2eZuDs7lykLISRcwCpCwgW0JLRbjvZidVpPnqh5Zb9v6ChqKLQGNY3lo6c10rCYuDFjUaea2j4pgl4uNqWJAxxrPlDipZ9oGxOtSv0EhhUFmfr/+fD70r8t/P7OH7n/E1UXYfFz9/ap62Qsd19GFuLYLcTx5ELs0iUVTXyElYA6ddbMB7/oFuSAatkvuQU5JudRimIsyO6qHNWscZNYM4eqtM9wSbAC65KLuFhHIxaeQO1n+RMrcMCNu1OVItUDeSzowU8KqivwiCnSt3nM9aAN2oJIOxGbZR9DFuCRkG9QTm0OKm/BSZl6KA/EroUJdQlrizq2Y+DcpVyBVoDvdM0L8aqdgWEwgQmMqoi/cnkpQut0zPomupQZbFbzVS6ayd2GdWYfIUMoHZOWohnag+yXhdf2R+1QpXs9WSbAd3vZO5AFBpYUpnZWigKvWaDlU6Qk0sQEqhvqthDji4c0WOCGsEzxmnUn5SGC4xEOrN0vH4Vh6BIKtAK14TlaT/qt6HNmuoxxdybctCYUICF1OWAtwgQSpQBleKZvrzMnEcOsUsVLU7i5CoiqRwtpUaAtKBwyBtgtKjyXcQEZqJ5d7+HX3/uJh9//0U+/9oajnAxmi4/1CY3ONvCh2HmBC6fCx+bofjkzCHGP7j2KKlCIjB3HETPHgV0YsyMVPySJamNXVbAjF2y4YBO+pXHkK9rYCUVQw24M8qY4scqDqn+MPHJq2GpvR/A+db4xor7zjYh6IM/hIvPGZsUgfz/ZpJktF2yLU9zWaDNbg7x9omYKPbaM1569vLzvrfglrLAhEaUb6yNOeKjqhIcamnakaFBj0l1Gg2qu2OhkfPlg0CbKcXrq1GS2jdrDgSqw+NmvYfRdJ4uozEsuyGIDoJiKLH095Aj24xKLp8jvU8BHFeMmYDBOwUbeBNLIkHnHtXMC1hJoWAW6gyQ1B1TXMyG11EGhcWOjo2JM5aiPNGkpJEBqJ8hTs1hPgH9vxFR8FYbVC6KL/OPoWy37EyHX26bFgiLqRdHd0/3sY6HCXcfs3bowOfK/x/gOKW/X+k5QAqKlkd7EZdaUYyv1vsOP1JQ1qIubK16/PulBxxuCd63gsufupSN/P6lepfCmTRs16apXLHiueCMXLKIBWCJMmXCzakqkLLGWAov7HnmTuO9NvZKBmxJKCivKYMG+Zy3/l5f8wTN/lsMexcP10q+yfrT+ZpzwveT44ob3fr3FDe99JOKG942KG97/jSJu+MAjFTc8z4fem3R6I+f0vOrzqO8Lghp8pQNiKeDAxhEKjDUqYBojWO5bd5w1I1r300OeF1S4qECBhd4o3xRRoCYa8JpwjDSSVNPNzz5Y5ZD8kkPy8aozDxySjwjHIeEF3qdGOaSLwS0ctRxS0P+4pRWBckiB5ZCyD5V8UbAZX3T0UfBFO0qK0hqlKCA7Si7+z+Od/iqagWKZNdgf6xN/VVfuB2PnAwrjoWIhaRWgDpOGPBGy31I1YCg9+2vZ3Xgjf8r5RKi3bH1C4F4bOGYDRz0zf8W7MaQr42terCrnJv9d9sOBDRy2gYMe1dWm5wazVbJY8i/4IwiO6tTYP2WxPGoXS0oGOqXWZYUAxfhtdEoJQIRDDQ6JSYqW0APEtbX71BB975mKL8EAF35gdx/yswyKKx2jR5HPqqI4cQIuVYj1E0xj3FxOEbtIs6YNC3zvQTSlF815ALXLDEhcHk30cLTs0TyhwluLLnUHtIQgLeOXjzBw5RGTesEKS+ZoHl8aRaA2Hu3qLaa8U7UJm1IDLw19UaENmqq9WSg7hq0014THLLd1Xk9JRsU0IubJI+MeX3HAe+mlSgdgDm1+rHwAcR49GBP3oAcJqo7H+I6PT+M7JmK5nJPkO35jnO94RkkldlZYjF1VFkOTu5Xk1QkOxLXgYkON5NGvr/FEK5Q4cZdFZ1RN0axwxIKsTWElDvtgP6hoRCfVXuCg6XcstYQGY8gajP09slx4m0zc3eQRnmSemXkKuVsb1fX1sUijodnvGoub5gprwLxhwT8YLbQjseD7YhDBRC7+SsAfjpy8BPtgNDTihlJUrW3v6GuGqsUpAfHfZZDbROSDw4aQkomBnzekNOyiqo4Sm0Jd0mpky1rowKdy/RZzLG+leiWYWpRwaJfEcjo/oDYqkmmYK63MHAiVUrQrlZ43+aO8aSdQZuZApsOqJksY1fLGOP1robeT4yOj0BaBdN1Yvm9RfcPStUG5CfAhwDDms4omdPHFUDFg1dsYUsrvlZ2D0JEUTU1xPCkmWBS22uJAmlvEetkBmUPSlwQvDb7OnzfMSYAhGREPqh3y9/pRUC47ioYJRndk730wHH2/O+QB9NSrQX9vHlSHKxT7v3uFR4ER7AdDjIz4zFQj5oEIlKM1ComfSNUBU197wviorbORRo8NgoOPLkdoi1InAWS9t5GHVM8DczrgE9eHCwXbr9mwy0tYWXGkftLtsPCjSsuqTfFByJU0GjDW0rv9GPcdAEB/VDw7BT+KmEUfuykiPMk8M/NU29ZAHF0pK46Wsa1UbMExvnSz5ZJ1e1+jFuBobE9hFaQ6mj2izVp+RO1b4U7l0p7adlU/kXBUbbxUpPyNKHSiZH5jyoTSDSpi1gIwPs6ckudgeYBP2IFOpR/IGyWdUX+rCi1rSSgsFe8Z1EbZnprpW8MIZ1HBdYFSHt1+Vqil2gnC7SG9ZrvHRHU5Ssw84zjOw8GOB6qQffLVzks42EunE66+Q+UApwhx6vU8iDAiRiS8XM54AWQdAqdQUp7oqU11TIK+jAuacHrAjdH22dNFvQaMKD161NapGLiJg7gG8d+lPWUvcRhIzQ0ciOGt2ni08RJuW6yNTU1jQ2nioGjJ0VidQgx4qI1Ph0XKP0eYDAWQmovRpRlHw65Tjzb90+CZv6FUMw8xOlyEWrDHvDyCokvKyXENjL/TzHA3bbIvCBM8068T/31br/+9a9lfS1QIdpcL7cEevVom4Bq7zJXxIzPeVVpyvmbOxRrUZL7GDJjyHR6sL5T32s6bZqyZff/tnzDTrAv6dAvNJ3BF/3dTXNE/GESOSXemmi16VlYwFDi+YIBb6Ap/7pyiRH0fezTH/06sE8ohkKdcrxyZCIlAaCFP1M1YgwLoeyiVIGSXj5oA776/iJ/xkTd+/u+VvCWSOi2FcQiztQla0bSET53Fji2f1YVn1Nk++Mw8kH6F0/t11+PXr0/93ref8boHa3sn++VSHk2/lKx7zm4cRY91C/6Jr98W/IFNt+CfOvEW/JO6Bf/mFvzDJ7UFP+offwuuLkjdFhwbpOx/HXcL7vbNJ7vhfmTb62D69vrYY91eo2tMwKP/67fXYXV7HY5srwePaHtNhummk9xcD6Zurml0b33UH9tbPzB1b/3Ao95b/+nXfW9928jeeOBXW0Fr2f+ubo09bI27m26NT3YrHGZ/ZrfCNGUnPPBtZ3+9ui3CyGgz/MmtkTf6fqfX960+jkySoH8F3kc2SJx0BWhiQL6YsKtukBBXREACMGJgf8wGSVUlfGkpePWoH4hxaY+iZ266QTpa2SAFUzZIvtkgBbpB8vudyQ0SaIbUT+Dh7AaJdDkFHIPR7ZFOFrg+mbo9oum7o3+93RA9xs2Q9wg3Q1TZC4Un3gs9Vpbjvq8fy3HTP2zGcnzuxCzHZ5Xl+CbLsR4l2OeCtjT0ermdGse8E7AZr6zyGHcxj/GFzXiMaYxFiBlxp5dHeA68PB6jGTrhsAaJnQJPn4c8SiybwTidNw0Z8UTUJYYGqE4eY/sEu4GgpSaNTdkNZTLa0iN0MgRrISxHrrfT84zTDntiHYlCntzI79EMtTigTAW1Ngy7AcOj4DIWzK2YTBmIeVNta4LD6JQZkDjBYbRB2BZoblMOY2HszvAsLfCXuJZBKcgIDogPofEQbBJUK4RoN5HWEoatxXEYkkNesUARRbRwZU8H6TBiYoolJqYQZDY0tKTKQ0DAxXdXPX7GF/DQGp5iYQpPsYAWK09hJIgcpzzFMW+Up8B8n+QpEPsoeYq//rrzFG/1fN/xFMeqEiQ04G8smZqyAAVGNRzPmgpx8Kis7UnJR/jZ3yofYWU909mNbK2Sk1vjzJGH3st1gzG1KZ6xkoNnZp61CXWo6itNXf6xcqtIou9Zl8DiAiMSPWydmk7OYwI14yI97hV1N49LXd+gHxywn9JoBizW/Cm8EioHcMSPY91JCbmraGBOVwzT1TIWHkOpEUVKdNwan0o/eCmV+5xtTpyB6XmXIZNZz1y9cx3YIf8A3pQhyPibDs1gAmJSztDsCEOQWYZgzjEEDWqodf+YiYT1K65MANzQzw1yzOpEZ3VHZjVLDKkzvtp37Grf0dU+Td/v+4HggfWiy03FCmVUfNTBKz7hBkVK0NmdxS61XJKBRxQSytnw7OIZHsAFxuwBdTeP6BaifbQa9KHWMQZH7h4zOPI+Z3Dkbmdw5CNqcASJro6IYN3nQPY2iNTKpvQ5IPmOU7m6rn6O0e/QDoFxWdOPq5X40hHbv+yLasrF3HdQydwnV3rYRDCWvaLcu78CGOdzOFDM43Bd3kNJ9zmv5UaLMI+gJH0K7LhYq/dTzVXXjWl5PMk8M/OsGRfWeIRqDT/Jm9J3s0jGYoBQfVynYBDa7ZpYcBKTipRCbZFxMoVx24wfL+D1gh+Ey7nQL+JVLYWMFLR7I1+E0ePFtX7y4nzJ4f0yF3jw4rzr9Jm2wG4yOEVoALJWJi0Q//HF/16/A0WxYlWca6H8rZTCx9c2PDKxbRtqJWJ7mgi2LkL8XdrjGbBB248Mi5xyoQqE2Uq0SiEGRnlIHMQdXMwL9Jhr8DGJinwHOtvD8r3Tlg69LCpwX1tjKMTVVFLzH9sov7LY2stRf04cyGmnaHlrLbRTb1ISFvwdtkRaEloXElGhNxW4kJ0oJOcIDnAsWhzKRcwC1yS1hCKlHQIGWsQjMV0stg/yvH8d1zPHzc4EIFuLUxRqO4sQg7VTS9hGhDfUtM14jD4Fku9TuMZdiA9xTeVUrjqXD75fr9ByBdukgo6twJW7tThNatIKdmkFgMcurcC6/Qk1GRXkIZJRtvDFAvuAWnIX/nSu+VThcU5lGIj3nl2I4s9MLGnsGVTQjiP5mdTj7/Kz+NG5Jj+bVvF2DuUA0IP178+fwJiym7z8iYJmK3TOWrHCdw7gRlyl6kDBEq7z9ESgyJM48KRLexsjUH7yID+XDFRnOdA9UDwFd/cz4ofCfKemnqqwOVVBkluQnEu5AclOgASIcm+tBHqboXKuA7oBakFcbU4dfuf6QtgHyCjU+ha0mgWu+FTNvckY40Y0mhNqsg4BklETV9rG0i+H1udx+B4J5+dLwh6N38PBoxp/AT0Ba8iFijgLCuf8qQKGQoommVOnqHeVBRzkpGfzFSPV0+OU3XQKdj8EDnAbT4rtdCaalhTbh8Xycc5wwn6dQpzhMKUAsaryBRqg0JztbFl/d97lqoR+YNo5m+chrcJ4AohqCAsc2wRqjEpFPnTMAkysYaXiDNtpWgJU4UJLWbYy+GWepnRKvjvtv7J/LV3YY+Dsol23O3d6RX7ElUNbRgrN2wK10+gUJhxoN2vTUryLu1mEL2HnYPlTuM7r+q/kctfyJ9i+oG9btW8HG8CAVXHYRKJMSG1c2H7CS2nhGjR5K3XpFHrKNe+8GYT9g2/ag7h+KHiDB9lOAfWK09TVn0JwC3dkecDU7gzivyt7VO3IaDeeMNbsiyrNftqJm41BQdOfgKbbTjwF7b60xzFPG+3MRSfdGQxN/hAvzH2fm/ISbUK+RqdTgnspTyRvP9Zy1Ho220mSsbhQFh8IIxrCtSAdxgwm2g9BMe7mE2eTQtpncJkLZ/i1m4mDtTcVM2oNUR//lc1Mo73YL3Vgy+HFcgkdOYun09Np5r/0Kt1ZwGPB9qrn1jAMD5rnU3OkeWiONowWOK5or3HB+dPpNG01A9Q2k87g9X8GC5xIx59+M0ZgDQ2GeWZ4lOYfNRDFX9EmnViwnQiJvxrtBCeKHLqna+7ZsMR0Fn5OMfA/C2ym6LGCGuR4ZPnFjoAA/WQG0sUDtXui01nHoO1Wf3wKhtet9+UiiiYwil1qQHaKFmsI0F6zbm1a9MVc9HYpHBNglyxsveIMvhG/F5PhyHBw/DpxvxEDgT++3bZAONrGYqSNyDi+yx5ypeO7FAxnOJKFhjiSxdWfQdulxbCPrn0u0PltKtFH9VPJkhmH00QCaOo2kyFvazVTpyVwiQyTYq9afMvAhn6dQfKQT+2XyJREM468e8pM1EYtoDULqP8RzD1f5t434KzzZNZ948+3GuZbbXS+pXQenQ8Oag9dAPbqXHoqM0r0pPyJdCpzajuZHXxyvp2eRLKHkf1A3rb8Pe7Vdff4xxJ+brkguBvP5QuCowktUEtsF4vAJwYQZviZMwylw7HlnGdoq7T6vwjnjLYTBwCBEBBQMZVs2Qz7JEVRZM2xv5fy9fRhz4uuo0BcnJG3huduqMvsJ/65tIf3PUV4QL3vi9P3UL2l1fdjkNRrGNWRiuNKAYvuXi/CNW/J+6yifqmwpiiEEuSVL4poPxAaSluyQ+QgNxHg94EvPsYSGcxZWmInnW0jCjXt1qs8Z4ED9gnN57ym7aiorttx32yZ0WJp6QlURP5+iorIfWFY182nFYGRu35hN/chNvcRYRwQZ68kUHxpD+aBJ7b3eWg3v7qV7iKUAGIQgwUU40KXNF1u6mo+ubKQ4JEgooFQC0PdRCjDaOPg5q1q1niBAkQviFFViIfMpc9AvdNJqMuhUCprUJPS98KigAj/s3+QbX5zbJvfvECcGaiQ4f4xIcOnnZDhfidkuE+FDEh0+/86sfJpXBUy4GL6Li2iCoek7H6i3W+U3W89Xt1H51sn3X20XWUcoZVxYNzL1jthzTQZRzyylQ6cleXvrumpQolSeAqZ9yxCKbEnH7/qjk7WF1k4dKnAQaicfmLFCAR7b8xmIiOoi0RUoucSoYRDKyyBXk7SP3gWhCXWzLdItZtWb9QeW4VFq6px1xYTWyLkmOHnbsg6YuypMvKE7M1StJHPcTkHuyLWmFe6Dx8ulO4vEpol/mMeddFILsRj7CKKWCYPkosuHpmIPBItR1xUrVCXlinBH1OtlCUXW44MYc9aJBcrgMcKLRmRuoK7yZKLrnFuvqiSi554MlcbXVtN6fwt19TDmaPGUMLHB7QiJwNFly0RFcs9LpxDxIE2beVaElOL2oDi3OIl3ZZI83L8knAhPfX6zYVsRSFtjuAAx6LF3B1ILpZRkJTQg1E7gIHm8EhMF4stfPrZv47rmRHhworsohPevvLrcsEyh7INXVpBNGrq6q4W1uRgnyrR5ARbzwTJsqvtEZfd3bzs7ZWyyZbdJTJlb0fZ27VsMmUj2QgtIooB9iUIG3LogKiwoaAo36G+RSnndXhc0LBQgiGjHeLylAM7IWioAuWUAe/VTd9nOMAbf3aSOgshgOLMrHZjlruxtdKNtu3GqdTWboAPRXcTTdZuIFlAZEDQI64QrNB21CQugzqUaE0tranFNc0efzBmUdPsJoOxRdpetLDJb4sR96zYNWBZD0zdK4hlME9TQOZnALf1P/VKvB2cq5fa1yVd9pYVL3U+ZXY+nU7cU9kLuBnk0NLDHFgqfU+bwqil8qX89E2L3cXFblEzW0WXK+E/3gecyfsA4vCZ2Accvz7IdHz88S6gRdu5P8xLonafyyWGimq7DvIzmTEPqOAlCYZ6K20hlMxPLprLlNPDZTqTSKdil3cEW6T3CHVpC49Nj5/dqXx794i0lrrMv28H/85tRbncgbDSgRaPOkhlK0hTILZCq8Px2LQkoGhSfcKDaYmEQi3hFi4LsSBu1BZaMZuWtmkt2qmbFq3KQm4ZNYJypOIMQ0GFN9Q8DpnseJBBPZhRU/vfNv1vn1T/FVvUwwxqUxyRudLUmneCXCzm2wRXWqbmIcA/FArr07LatxOo7RGDbbsHQ8XVXfJKg4HkRbgrMZnNkBgDbwPAb6WEnxqe3k4BqoKONf+ZODR/u4Vpix+YxOjaspCWYpvA9FQ6A1QL7h8gAqVF7QoiwtkbsHwqf7gz30EwsbkVVhbzLbSTYlVJUpdmZo1MaRbqKDxwsgVoCtXhpy5FWIbsEtQ2i9D4EqQLEEMWpVuqZq3Xt9OfeGzO3B5YPwlnbjf/LHi+O/Frnbl95f92Z25T/WidrNu2qvOs0jfXN5r3ts1ctp2kn7bOlC4+KndtioLqrm0C3YBp/9e5a3vUuLUpZk36Z/uB0gDlsZ8d3cx9RN6xmdMk3cx9FMFUlc5C/NR41yvmWShyzndKw0h9KUVwL3sYI8R3YSo+jK4uYjxe4HwYXeF8GL3sMfswui+KPasB7gjfsdojd2TEYwYG6xZf7jBgvO/1s39+PPwaQUvhOL6NOo/at9FPP0LfRhmuKSUwJ6OLWpz9k/RPttoxHi3xt5WKQ3Z97jZPMs+ssi8UXVi1SpVH/UTU3OtQ6EBI669DEyLihy76gSpZt2lWV+Kqqzt3h3lGYsl/ji6UAHOKumiGY/DYDyUVcUa/ppWWxVKbp1Ub5XJKZY/MrW+j92hUHkhbXQsj8AgUSSFXFlGPS59FhJZUbWFNelB6ZxI2BH4qs4cAyBI0xjuTzP87wOsY70xX4+cFU70zXTHpncmpHH2vV5VLRRqrl3IzfnhoUERQW1RVyYTUwixc6qj1xEiQDs51IuDDV9FcDtIj86tzfEO4L9jMEO6DqC39XNpIZZo6BY+yVw/U9jv9DaiJHYB+iSpevIBiEKsr9O179O079e1yfbtE3/bp20WyyuR1lTlhKkOQpuxYk2JEP48VkMTaHtaa/QzpF3IEDEIdKFIMd3AA6n8vsbMxVvsjLUoBoVDUHNqw0BcTMETiihk2zQesJEzBs9T1MKXZ6w5JCf2PuzcnHUQzte3IchFjI4XSHIqz19usC5JfovOOtcGTVe/4Aey3eOvYBmMjmkhPIO6Yc7N1HiePV+QLKuBZ7HuXiH30Zd248JjP6z5buHLmYhfJB3e8YGRRIbVUQJb7rsweLWIiKTE/6NEW6qEQZjpWaZW5nK13GN3zuTXqcky59hHbLy9fruytI78plo4Oh25lw+chpEeqD/6QX2zjt22X9CrnzD4mu0899xVcomPq14VRzv2U5iuJ83bnqR5azA11gOeiPFEo+ZSK6C8h355P1IVmiiKwE2WjkhCFlIMIMRl1ONvICBa+MtHLOoqZULNlY8XvksLXjqg5PW1InTLZL4VSbZGo5Ix8qb5OPh4JhiiB9F5NASbPhva76NdKBcl+oGbyzGKurXdxeP2BnC8lRMxUI+poQd1CVDdBVeBYhFpE677TNnJFoRVSKjsY3n1pU7YJxDwEZXbMrakSPrZXx2oHxGMQHSH+3bWuCFJXvfK6ge8M4RNaXBNq6+CtzTM7tgStTBT64AbVvTf84bDm5ksZ/j8DyXOxTaHKjxDHZLQNi2dMOlz8yVliBhOh3SKIRwhGMhcQgmM1kFUE96htTB1j1R9XM5kwsvgGjLWFloPRWXlo/X7rDne0R6orGVGKrqRW7qKHDWhwkYgqvNwdIQ2LxFDvk1FPZkWxemVR7+EglCM4wLHmA8Fv8wl6Ll02NjZjITga8xWN0Z6NR33cRv3aa2zUvWNR/QdKfrOXHg5GzHXG4+Y6Kcq+Ns3SlJ7n1EdMWdWdKav6pCkrly6p6Owjrgat76yVnxzEMJo7G1TLrser8v51wrUEa7CY6sawFa3Jrmy/nFRJBRKxSyoVI1dr0PxEByomriLY86RL0RBr4krneYBHaeIqmDBxFXLLfwktJ2aysFdA9rzOTwpHTVzFTlH7HZ4YoHW3UmLtYV0QypxKAUkagk9YJEcsegptb34fTtug504NCe7yD3tAMfQhRv3Zqw49eqOe9dHLK9+O6xp3eXpfA6ahjdq6rvCh9E4aiyZpJ8Q8bXbjIXuXJd7sLssNh/4dWPb8cBSAw4rchXfHOAIQ94hbTKAYhlEsfh/C07sAgy33V142qqV+9ejrCzTTFfy4XkyuB88jFDhiFi+wZvGKOPu71+Apdq7rFzC7ojxDngg/JrY7uG/XqtXWlzgeA0sZ5wHiDffdMquL+LBMFyPa0IvH6da+jz31uu9/y+BzFw9RrFio4R3lbbfi32+by3Qppq/YnvGw4AwoMSzhhjFfecPdv/3C3f/tPq3D7K+//bIP/tZ922K2JZj97avFjAxFmGeXaKsv0lafSxG1SksSGq5x2LDqu/AgTzYHEbD1Zfh5CZYQsI4RpefJ6UkDnGyTouyfATHkuaoIeP2VDVdQHmqjAlg8QHvUMPqXa3BidodQbj3dlo9Vvt6mVFyJKK9Y1AeFBA/pOFRhq1YdIjJFZv9onHSurmX/okGZalg1OXS6H8JMhsAhUTigvxGYc4GzWSRqWg/WrezvtWNavkwcXZQ44uD4NZY7p11jmYgFrdBLJDN63yr7cbm5ITdMXOJfjxpY9LUqPUyxpCBQORrz4f4PFjgGtkkJtOZDjr3MxEWiLeEJBoKyCCfFYZJZ2PJBjFEBX0LwZfvv/WDBichwWa//NXgr4siH+Fm/tAeAY2v2TsBGqGcebF5LaGpRCZg0XJsdsMh3v9w1kC8i5FO1lpoUCXp8up+cb/LnYm9fqQvIidKaRB+O8mTvQqtW1NdSJL7wkcYNU3rjl4tNJ81+BXlr6Xt8L77Owc60zoJPYc2VKphRLFRT1KC2b6xM64GqMocJGKZEDp6LGBgqRWN8KCyhhF2/fh0L7xxXtgkJdIgS3cXXde3BWGkn9DW7Sbm4ctzQUdd8PsrGEKK6sDKEiR3C7HrgnPYskYKLcKRB3PxKV1Spqdqg7LM3nISNkzcemlRggXGVESMquohZ4Hv7dQJQTaepXWb/sRmcwm5xfXeHcVTtJQ9VcnjvmOTw405yqElS7qcRFEkNuo7pHa6p0c6Foo5HVuhmu2hQDCM6otsudnqaejKR6pXBlm6N27pRntG7GB3F4EzvacwKfzKL/oJswDwBBhLv80BptGBBXhfBtkmDKeN3KN3oJmQJ7Vpec753JVPRlWxFQza7W7iSZcAzhOidv9gtu+GIOoqiy3mNtlg0pWiEx0f/kdWcltWAuTXFXENxGtiGiXQCM2uZ/afxaRB49W6+qm7soExwAPXuleZsQzt25XwAn5NxblaI4YgdotJiL9tD5VNsKO5E8+UGKW2nnXBH5ucRsluPhHJHawfObqX8BsFDWAJdWSkw5yEuL5YGdBpnq+MGmorFw6OgZXghtYmhL+JX1r7U1OhFQypQl2e7qm5KEkrEkdkuCnBLlKPw6pyZQXLlTHrJNa26XqAH+Js5Z+B4q8S/A3e5I1q2SmXLtIOD2vcG3vaLUmKNO16XHjVoB9XWHmWntlB9olOA2iPvF/oESqFGZek0xEEdopBRqVUA5iqQ4hPrGk2KDcaLzVFsTqQQS/KCSyKFmHVa20MW1k/Bd1sV9WvgGAxiUq3tpVNc9+0y9nWfbUaimyeTuYrT813c7l0KNOi04lmcAbdqZ8CtmoAj34VWy0zBAwPsi5kNZVzmaZFHDXa3VN7rWMMzAZe+Z5Bzl4D1TAyRsc+nCgNqDwAw5ADs0wu8OaNIjc+is+hMox+Mo1ZQiFn8CPGA8IJh3kIEP0+jVEPZTwqlD1XACAKHPdgclz6n51dK5moUcy962o/AXdF9rGe19//sSZzV3vQLIMwD/JqzWvUM/82z2m+e1T72s1pFQT2rnUA3YNqjOKv95lntjzQSX7Q49UhzjD5Ems9c//2Fseu/eFeWTJP0+i+CxstA3Eee8nCHDdwo6+MIat3w5SV+g9++31srz3o5aqSM7LCIW+rC9Nl70taeFQV5s1rgxNcqU2bmL1UilqKVLZpmYKYtR5ER4UnmmZmnoVr95Lmoo2rYChNDrqgGcq88xNmkFcjC321Gat+0Q7N4zFGH5q4q74o4dftMDiZ5akostcBeyHmhTpiWHEzisT+fpUAPJqWesCyWOsAhq8M7C15w1uyzO8Ir5rP9xLUto1kgpHx+ZZH1uFwUk2kZ1bah5fm80H3VmI7oMQKr+a8IrOa/AbAg2AcHIEBbgNsPzpH9Oo7Is/8tu29nj4AWQBzmab6MOR6NmFPHTey+xqfQbATKD7+Xez0nUK6uA3Oj9GOO5ir0Y07INgrdlHTzcMQg3WJONKZQZ23T4APaP4/jqOwwOsZ1Iw+/HsQr7FWJQUW1k0a+sp2RI0npn7VUv+Lapet8/rXHtR5vhavE6J4xYvRRR4w0qSZX6JUYTWMUG4KqCeGZSYeDqgp6Ey2PQFvwiGDVrq52Z+p4ExsSsg+qE2wCxILBSX83jvcpkz03OoU3I6hNwW9mMBCTyeFXUVeDKkKwsF9VTioSyTxFws+JwYk5rsd0T7LQnO4m53f5+2j+7NoluMY2jyL4jr9vSKwqny8pS7cs2cCUdkESpbBiCy2IT/6VvGcc1Sc4ZsGVbWFBV2iVFoVccvsFQF2MuPQxAquKOs9Fup4LbOH8Cwf0nUHObUQ+EaVYZU1uh93P1hU+WlK+lRYZKj1z0rGV6qPbWj0rtEdXGWZnJojToyVsJVaBTaultSwARvT9sb3FLUXYJ+iKg+ftB5CqW1uSYxNcARDLN0synFCZf6Dm9rWkUMqXbR+20DKU+b3Kfnmr7Obq4BLynPCs5YWWI1tZ9KqO+LCmMDbw22r3cjwTispGjREDJCaTDxqUjySRQAL4Eyn+WK3yVQuIer7K1S3aHeki9Tho2o23/fkyBpx6pvn82do3RA90GGlZicJo7YpPWmsXtdISfrmSeinz1rDKwqdVswQ0WjKX8hRb7M2CLhrcFcyRvRMA5O/lenXiwEuotkBmxxKaoVc+5JNi61Sf9Q1hI7FjRS8Ev6cQokK9d2k/qNCda5Fjx5q7HWsDMNUeZToJfHR+q7QW21g0DVi9tULDxLa8p/CjhoC/CbFRdbfalM1rnpmdbZ0yGRFqqkmNHbSDmrpbrVFP78mZeV/U1/DOmLGGqD1KGgQ2VLcb1urUTGkOb3M0q2+wzSUH5DMw4tPBUHUoQI9IVNmb2jGr6aW9rKPbETcvk+bJ6huhkcSBptWeMkY05WwRmFTK+Jvsy9ZPRowL+SbJl2Olq89XbTZIxm85ZIynmQMntYxnos153UXn2Q3Sdwr/z0fc1mozwKkiZTHxxM0X0BeNnrA1eg/MSdL5WIZ1CISCquyqqIs5IriLHUBlL9JW3WGvt0EJCdkSSpARuW+l5q3yRam0uHGR3ryoi8KCWbAYGwAfNWQsbTemRbOfRN8q0vX0hyouLXwz1QRAOtVEMc34F47Vv7DxPhxCp6xGgaie4ZhfrXM7XgPmycU6efbpG6VH4orFy37teuMN4//xpl2ODMjTW3zYFl1Y63HI1+t4eglvQUI9ObyWg1O49PtldKt6M+7BOrMZddYLC+TPVLPbHVn6VaPPFAyPFFUndnVn7aJ79r7v/Jf8K9KfrEhcJjiwK1Ov6uF1SA38N8h+VIzPDaihIUk7UmYeiu/h9aLpHA0ih62TCxvmPHr7Hvq5L/7hc77viouHFQ9+chbMCKBFys6o7a7ZQcTGk2xGwjxHQJfAHzqaJbSoI9bqcg4wwiG/rqxlE87de5X79qU3tL/8D/nNT6eU3MuVPTFxlaW4BAmjvuhRPsfnALd//vqjd7/2K2/+KvBxE5ePycgh6rys/P3wxfmCa2gi5BkJAniapTB7NTgfs29OSOY/CRzW8UsJc9KtfZf80vtu+9KnXv/07y9kPfdwfSb7rdcZZlVf78ZraUtuBo/VYklkHwoQDYO8AGAMIAO0IpY7FDMUcwQHSgguWc2vpnjwL7oY0Rn5Anm5Zc5sKWQhaHsXps3kIAKPTGUmlG/Rc3Bgd0OdfkMEGNvPWWF5SLhvtAVyFRx2cQs2nAoz/8PNJNx7K1YYA9fhHZZih+ycHINiQMSRPP8a4fL957ftoaXoAc7+9dnX3/qT1z+N2JN1AiT40E+99ANHdx16etXKe0KLLMrFzgeYv8IVOSx1wSsZmWNstBagxDhL88i8hUfMZW5UM+PyJ6tQWaUimGUGGWv3o2+VO1xlUS4XWPjddub/F1as0OMoezhlJ4dvXLVjbEEAcLLJR+XZbVarLsx9e8zpu2NONXVrPKU/2924pSD7l1eVX+rRqs9lq/9BZW2tgXm1sGj2Q/gUxaV/HnqdSQuJoqjqScvJk37oWwvDM3qirFaDQxz4gwsw65QeecrmRqW4RtAd6ZSqbiG/ry3+4DlNzkHxpd9CEz3yQFf/1w3u4M70kzzR6kYWtbwG4uzbZhSRrO8KaAV7wuOWmi7Ycj8t5SJXrrnyJKVEz27zhu1HE/3grST+2GtQSg30qbqkouPtvmlcq2DJJaCAkmQC44aWbll86oil3JhS8Brqpnz8cC0ROICLjJ26ZwqKgRvKegebmnamayXCVzmj7DXj0VoVwOI1U8XpPsZxogpw89J9BZgeXTfMWk2N7M2KmQwxlwt5BDwHsi8rFMkDZAFXVbKrmtT8gu/HfC7gltnSoKxUmIdm1qt1Qdmd6njEeMiZudPcqkGpSo+/8cL+m/3UyEMoUo6MAhmTQA5z7AtJMseg2VBLVfGtDx9ZoZw6H1DWR/Qr87jktwBdrd0NeRGpQiTACYQDFM0oK7LX7Vuk81fHrcoFAYFD0kJUFxMqVXDQkuUJ4kUFJeN4VWsgL7sXLQPOYFZKW5XycJicR5JDoR+N8J51K9PQuysQ2SjPxA9z/JJkH8UwpmVES2L391svxJm/CFLA3l/Wy+67UctCOsb7ACcBLg1R6OUbKupi3d/PdmCL9DJZ/ZqMLvtHTY6r/1pPrGDAhCyXpQpRmLL832DojGhBoLOhGlfZZ1E9PG3VUcnmH/gjH1DriNqTfaW4fKG643GrjUfTU716mmLP1qDYmLP20B1VfgUOgjNSaW91LQrE5EmquuX26iejqt5NlraCTbaeZwKbwlxQYM/TG5jywjjXnY9cb6NouaWXbPiui4bU4oU4vHWIDVZ1AaaArxH1VX1C1T5wXJ7djrmMYdaB9rKfQkThO6VCXWlUIpM8Qs2iYKpmUVDVLApORrPIt5pF/rhmkceRD45qFr3l0KRmUfBvrll0x6GpmkXBFM0iHZRJl0BFbXTsrn+VREspqkmZPp8HeDp3a6RpnlIvtENIuBtyEJu02qqWvPiCs+hSqTCaPnWqi6OXTXFxpJTDquWAVfk536tPcheGfBTlXbwiEOwRKhlZHECVugggDxbmIgBKwHEf/5UoEViUQPsdSkSoIaDYLnvCBok2H2p1Vcdc7P48tCwVZAWBYgBqhb8+YZDxJUI4lj5Pv5Vtu5LtCES5hUqQTx6hPJBmsEEgZe4ETBn/18DG/uQa6ZtZhuIFJUNEQaVfFHsX+OH3W9iJ6hqqxoEDHBz6ggiq8oLFUNAuW9fdN9afwLKBlRUkPVCa+ide50Oegv3rvUtQpp5nsFZq/+hBIOrtBwXOPFlDEPuwqqoO2Xh2J6rqlHE415A4wOSnpLJfOHn8CEfww9sEP4Jx/ED/HxjFj7eO4EcJpwiQ+jfCkJ8+Lob8DFIf5XT/2YnpHlane3iS0/3qk5rux6Fh3igNCy0Nu9UPcBYTTl6usFzhTOD7NeHer14roCwubXhuWxzcgT0EEjtspzqeDAN8yxL2b2tbX+M/x6BAAtgFIGyyP29Yu93NtVw+oEjz89jC0Hb284KuIOPgG0K4g4s0EgwlMFrtl4vQ7hdMBe57igThXQkuxsYlJvZtiB254fCHnhc7sGB5Q0dk58iZoLFpeH8ymqFy1B2LRiIeNaEECK1ihIUWLkAgEoG9DUScxsVA4hla+KEAVJDHWI+5GAA9ptoallhVocIH2E3HlOhtowAeB/0QIbke0UqtBLkuOwxtq6p0/rF6EnFjG9Q8MPBUsy3oaA3org6554ZcENgN9ehH7q1K/jqKB4lFA/gjeXtJl2qKCRFQIJbruRRVxqhuCRdTAHViGpgUpNVNcb8oI5d+0NNZqGOk3lAImqwaE1jn8eQLtqzZFuIFMOJoAKkVqi4l+aP99k1+zZ37LW+0zzXE2uHhBANxtEGaUy3CZtJ6yajb/kvoNR2+ubNQ8eaj+3aqP7uNTuuDN+pQiuhzefvzpm7WUskoW8e1oiU441ED1TWMGyvXxX4N3icZW74d5ATqrS8s2uJsQyHQkj5oUY18hlqqFIR3fsP6RA0sDDnPJdSdUcsIF3ley5Ik9G0WGJ7RLBpTzEJgBvCEbKt2jWZ7or1KjbzDPzQjxWVKPZr961B9YhqgwAv4hTxhCRMNqXSEktMDxGkIca1QCAE6laEdaLXRt9F+eXnKFeFNam2o+u0s4gWEDXShhk91kqa6/529tAhFEEE1dAFdYcme7lpMUW1M3Q55lGa/JOiqp8JFA9oJEbX3Q17AUc01Xtf0prziboNmeUgwHC3qYHbgOyhEKXmiNPccfZM9dSURMqNWDiUij9o4P4LzqEgNaAIf3SfZXUrsEkfs3gPrjo7C+Q6zJ6idL9QuLiQ+FqIXVudKXPnWl+XBR5FRXgs0J0rnyQ7ikpilpE6Jqw8JghW+uYRmkyxdC6s07f/8if9qf+RyY+jWX1J5oWET9aFrq+uirymepuhXKD6STx3FDlQE4e+3jlOsgylUgtaEevRTViAWLLSIAEPi23JQCuHqFwsVDHlCBEW2uGpJinfZO/QKXTrmD4pCh4KvDmTDDHSybABOZc3pcEwRhi+qDp/qJevwpZIjr+s1Qwe6mIkjJ4Bnkt2k7i87BlBib9EMdc2tWgJBO9fCsdFLzZDr9UidXir2rTbVqzbVK5vql00FGjBY8YVy+wpqSNSMk56IINYyqzBPiUrPY1QcGIQNkQFYq1nr2h+sFuYLTdD+RFWEFgohjUDNxmyp7zVG2R4d7RBbgKjclsQgJJf0+rI3EcGn6inp0MW4PJcEEqM+iRNegUy/An7FSlTiU1P1pXwl6/zqK1kH5ihZ15DEJYreOsu04DpJaxgjny0SSOkpU1jwFWAyOR1kXBuk+JpgOUjLBqXjDUpOvkEN06A1NEgLTigG06LAgElelX7jRTBqLX3KZrdxjBZjkL1zyo2ctzb5YLtRakyFPJerGlNH315qTN1rNKQ+In4S5TRpQ1Knn8bdiTTVrUIhKn8BIdl1AGcXOARX8XqoO5PoAO77GlUg3ZQkyOPJctmAebqmOMjJxfEUQRl8I2/DpueMxYkYgiLFjj6/iaBopiJFTI/cWsxQeivUaKHATO1KYlMSm2VixmesOBgkXw+ZC97u3Qk6lRhp6o0+fg/q5XrvQBGq3OVtcB5zZ7AGeZyovfQ3hEConPd+T0voFnFfJideVp/V02+/wKnQZMW3OP4uvw2qenWF6GsHmxyCBrANS8BA2FsRqfi9nggV7hWrBdo68rN36S0ydfydQdVxyADIBDD+mfzRHc6y0ZVCkDEq6FEpuizbpKfxJgsf0WeH8J5nijVapXbNDC3noRlUvdud2VJmDrNP3zvk5rT4BHa2rIFmq+d51Fq/Y9/LF37xW//8h97Kh+az5mzxmqeRC/Lp+Sygewl55kCm72XvVT0I0y50NxtkvwJIiAc4jZ6teJZ7t263uT2ZNHeo8Jrlb2cFTX5VPp6hgGC4SBTTkeMqHBVxM+1lXwwbdRAbkI4fcaHZBr7el/7Q/2h53DP4t5LpIMYsbstRywyfgCtVMRNaj9/sXEkqXiapCdusG4znBb5jdfE7isyld9xhcRH1jtzuMAo4D5tElSxX9h4KiliItZ6NjNaTDd682UcB9o2XiUv2kNCDFrA8e4/ZYwcbPNUQq90I9uPMC13RHHo4ofJmPVmBNOqYh9mB9e0LoT3FRfxHa9X4Xztk44+OxL+3jD93ejG7JqK5WqaGlpE46vlwp2ilJb76zORHpselesyr520eaFRUPRqJR1XXIbZERmb2DWNs0BPGW4aqpQ79k+l5Yorl6FuOWCke3EGBZKQae0yT1EERCX5hCQkoVDp/WxDD4LKvvqmcn1TLGypNjSjE2fCCPOTujNyfDuVMjZst/ArPop8AQLEcUlRRXYlLekEuyEoK8fqbGS3q+2G/wWWvulwN+n7Oe8lcN6WxXkJMN4poSD4rHHtY/CreStBOMFldtceGVMAjez+aNYTqUuLarMdCokQhpuDdd0WEl4W+cfCecnqvSA2gj8Al6wBtYbCCGHEwNcEj6/zAIVWLNVYC3IW/CoeWTZx7Nc3tuP6f14zCGpqiJxXlCR+F1QO+1wdBAGPYjkdyt1tHfAOi6PN8UqNc93gXbKoKk+npdX8npKs1LCKpfHO3l8f42lFVP/uATA4gDrBTc41qldTUsSDVbW7wq+fqZdFdEAPodSMGnJr/EU/4hB82k9s8z98pDFG4Yaj7FqbuzY31wlf/fhisBgXlSGEvoApOSEmqKebQNQLCN0EcRvpSBrIPopHH70tMdc2WYqK4y/y/EkSYH+o81epG7CuM4wGcR1fmtWzccD71gPdCZVqePe5MOA5kF65HUQ3OeGDN6BeKNKB/v0RkRUrpQFx1cnl5WyZBi4AyLs/QLCUxdwyG4oCkt/IambrRTKtr5IDHug0tRthfrRp7t4r0dXkTFttfz35EDWBQIDr6vlmW/xh6YipZzI7KWvWxj+Ife37DlzW0vUlO5wyIdMdwHYbkUI589yFrcEVXuyKFZpC/7zs2tr368/+Bx01L/DI3v2wH4FHG8xKTlrmhI5ZiLg6lrWpXKf2psG6JWyDW5EeMjiXruY9nNw8e2ZDiNuaomltEiQxiEYJDkptDsljz6/2YXKFyqBGkMAAc2DE4CfPUtCBzWNVR5LpkFIsOj2Pm2pyN8Dq+XJOD2GYohd1vvEMzkDvrA3WBIvfxkA1Hz6GMelixfAynClDNUxv0OvKiVMhLSTkt5QrgxjqKca69h3mHYIcF5XnkD4WzMMm79q4zixdqP/VijP2y9rSh0DvENfd9533ZNT9wxl89nRssS4jCArymtjHZQM9aTF4ZrwfapYRaBxA9QI3UBkIPtHfq+0wtS/cb0hWf/Du0aRQMFSsDMFpYDvng/OEw8Y2XxhiU1nkKP+i74wl1oilQKOqOWq2r8ZdjXt5APUOevP6txudiqO7A+x7+mNrN9DPiv0txpyeWq8vcBOhJi19hd78OaCGmGWfXNgbFHM0NBzxrVIEuKWs2gYYNfAVTZO7WYp4f81f28EscvrJY6JX3ewbrxTyih/LAlaAPHfwf9/3ud/04W4r51pf8/q8963d/5YOsWrHz1k889dMzvwXXX9/1M7fcMNjxCcRuuejZ//K5r/4dxxbzR/jjhZ4+56r3iuaO0Bz5lZhh4dIrWfXWVdZP7DUreEHFoM0a1fpInSvni8YBj2yraQGbuCVBkTlmG2Y4cuZSQBb3V+TO1MzGkXxe5rXCmDT38jDvusk619+Vz3ChXYYtuNC1IjPcwjy3icwMyrk0ji5m0J5FLoiW8d9wSHPH7ZXx0dORfrQh72hTCwwXo4RwrWhZ6en/Qs93Zi/wYx0NZ78BnVFN0NRRQxjpcT79zRN9+kbf9yp+v6u2K4W7A6mWE/R95HHoI7W17MNm4YwZtkZd+eCN5/SVkouDZ3xhBHC/LsRcK0XdygbLYctHSor/G6oNr11omXNGa9UsdsZDKeik/SR7o+hqeWLGjurZX2AXqW3r//gb+BxSErLbkEubYtJey2nZmyXak4TsM9YyXPbDenT5Rs8HDbCC3ewXAb9CzWoZMFaXApVtcYpqm1XijfTXU10l7nCVA1EWFeewl/aYE4V6CTB/zKUseekvJv7CdWGVDIWlpmakjPduZcN3UQi7TKRvXT2VifUtkT0N8ZvTdKvr/qfPt3GV7+Mu2vw1yYj8JnPi1LzBpOjRQRMR+/IUjz16C/6svI0H5TN4JHkHjwVxczxrBHWZmjMR9USx5QgVpjwCGCU0D9Viq70IsyfgT4gfi9TCY4lSPGA8OBKtlWV1RDErItBlgoJEDJCzljLcp2uICadGLJVJC6NJIK0UbfBK2eWpC+xAzYt48IzHY4kW8FhAByC5nMOaNIepPZ9HqfGLAf7NGPeYB0un96urG5oVUSUVEK7B9UosGJJvcbjTFW6wq93ocYNohTkYauTzLRFkw+NJsUVbiQJQl2qQQVnVbCfmgRl1PVmScWroODV1nFIdp5aOU7s0nprRcmV4xGEGtd1wxIAGT0lAo4nHAjXwiGhWT2ek0Qp28YiwZEKAskQslElRJUkfUJObCnKnvYozaAd5hjoSZq0R1HkrF9eZ4YTtRazuc+J8CZg2Oh4xxqNux2Nx0/HwpV9DijfW3bCgyPFhWZRyeFiWjGqzHZY6LanmrNkMqUGh3cUiMapd1pNdG6QVwr1kdwntDvW8PbR7QqpP7BLdGvLu2WaL2ZY54znJH713fzhxO3k15PBSdTqt2p/PFpZXGF7hbO2uoojR1LpoFEDXswF1myb7BckeBoUWFr/OFj3BRFJTrrLqwaxeZdXLSh2MUGejgCgNP8Pcieqw8vOWKMnn5DpZBhgmuM7KYZrFkfuBDWYnNtaHnHMOIz5n7Kr0n4jJZvmGjtGQViqWcc++XF+Dgv4BDmaW8s1T6PbLmu1+ZKvmWXBFfHo8bZFfbokt5VSZQQxZbV2EBz3VgI9wRRYHAXALhRuDXf1MPAFvoRCyTjWQpFdkjdguNJaPIJamHq50beUy4Ihqm6Lygt4TrMsE3Y66MIOhR08K9Bw34cFGss1nWl1Dq3DSmat9H7Gas0Oq4VEindYYJCpw0836pmc4d0tbSW1K1sB9qt95TBTqrNFM1fU8F96CRN649SDD8RAqEf9HO/pdHSm8zNB2Hadl2noA0nnadgDIAt8wosq+pawRJb8A1QjO8MvV5cuA315WfSuDd5gmkWsSg13qX8WNxO00L+Z8cTtwB9WBaQUtAnhECxaGgAnARB25patO8QBwVNS9Lc/wTFj62s9g5iefEwumgpxIyTRDjdO7eWLMZFFkD6WQslM6mJ9CxM3MxXrVDO3gzwvdL8jmnWaNHrEWZ5wPGdicYtJ2VtK0DdrvPLHTpY1Hm8F/nWFjdT72W6wcL1cvOY9AoK5Xl9sKCGmT3NBtK3TVOr06qSm0A8UpigIJNyMDF33K8AjetWbbHG2AbZW2Q84SXVP40BX+uZcwKAUeBYM0xSz4gfIm9thcM1r1YqXhVEgoZFVk+v4fzvv4k5956K8uxr7Yl01TJiRPd2kAuCMCH7xOWKQqUeDVFncdZMqg8IqOdX4aFFrwx9JrPMUTW8TkMO/KhAfVh8Rrm3A6+YrbztU3yr0aQ3BjXUVb6/AGC090PX7shGN0oB3gdIaxPRKKgeSG4PqZQ3TlDKXfLUuCz6LTx2LOZrgxPw8KJSmFNHSVzlY0PwuPXCnGFpkOTKdioO05uNVeFUyf4oI4uMDNmEoMbe+Luv92TKwOwefPdj1zKOhMOuc2OoeT/Gt6RTAsnnBbvtt9ulMmfM4oQnnbEC3GfXtBVdk7oQDU1Wl+G2V0pttj0QwrWf9AsaOHBWX3EOe7ml13erO30SxxItC1I/uxNj2BZpEvszGzeAfNQBE7gcBX9tAwFYFA1yt6Vm9yFikRU+HizjvyLFVLU7JC5vUK6GBPjzxZ13Su3mpmKifpVLDzw/E0sCWgd6DhJJyPrdDQHvHrOdzeXWi8rCTqiILlO0jfQluxrOS0KjbS8CDO76/ngD83d7shwKfqUvYOw1ucfZ5/E7iJmxw7QWdNxDVAQxtmQx7SIi7Aopjyk4WJmPmJmHQ8hvkRy7c8EHaCa63wBX+hPL3yr3IJdb2QKV3dbYW6c3x2EeFxeRGrBoxHEYCd13mX75zIVwWvTfFV1YDATteyHG/19bxh14375cBfiTfYoASP1SLlWJSeidEwhCrXc0HnKJUt4YzJhAWl78GUh5K72Y1irhSHQo6QQ+DQxR+TlYVpjVWOclTYCL9ri7gPSotwxXdp0e3hBma3ly/CLAMCy5w8T0sbssk5wvhnxHuWpNHe4ZAZqwZ8HArHrabWGSygzDoFuaQ2DjJojvMOChS5OCi4WlwvFaBl2P1kNJt3IEaxZxpNwvEIZwhhZQta3BQbcbLKVZdUytqV8SrlhXmjD2PKQvmWdGSgRatXe6S0hjuVdEN1r6e2GCDX5JKB76qBpldZAwrL2zhZelMvDQy+hfxMEX65f11S8spR5cIaeSrW1iUk0PPyPeT3bwxgxPB03CHbY/nD0A1PpDoWkkqctXI85VYCE/eMvWY9cHjkcsslwUqf9VpDEfQHvko2+/fw4MWTNccnqnbhUVW7y3pupsqSputMwLujSIvM6wSfKuYFF7HOYjDoAoWrlhYLmoIFOqdQhsypyrK575rv/sfXX/V9X7h4uI5TCkgqZvAQJk2NvOESgF5XEMtlfQ5AsaNfU7Gq5a9RIxrZQi4ZlVmL4t56Lid92PFmB0Dtm2CsWyzVPlAELJhQYy4ijdyfLyJ1gTh+SVuyLMN8OCztu+AtKN/6aR7QfN6lJVnngryjA6TfcDmq2CTcXJdfFU21kLHkGZdsh+OgYn6XFrHPmMFjRt2nBNThFFPXnBaEYmy95Ymy1lSJGBR1qWJZP6qXUhWqX9mbrHuOAwDaMp4wCyRPJjzyxEY+gyy0pRybynutoPd0JTiYVPd7eiuvI1cxOzLYxYzaqIupI1WSvssJOqIBTwJ8Amn7lUwEOS9wjwMWZQ1RwpGY9ATeXO71KhPGkdx6n6qLyxasEeg2NRU8FMk99wvQ2NHZUQcW1ccg0xR6xOQUb3prk5EoquyeFSeXLU7ypAbklsXpjaLkMscxTrYMUhEgKiOI4IKycU0gOzAKcLwrIH+KRZgVPvYdcBIhcDigVh6oQREtTVTd7fVxmgP6xOhLrBO+7zHabvj5Iu/po7yLxiLLQlX0E4ugHOdVDIajvsArYIREzLqizcvw0QwPURc8T5c6EI4YoYndDERSXyhoO09Bgd1m0UEpTNpi/nZJkgIUx2WgFh1/3Xt00XIVvfhSum86iCKQ1T+Tu895+Vc2I2iRmSjU1P5UZ4RsKwCQeJQCNoHHTevEJUPbs9LK0L7/eem1D77vP3/m4iFuGioqtxS9F0fp1aKlV47oReuQIYPq0LJQnC5GGS/YjS4BLaxjaiCO2EZbVsZ7TinbvN3L18Vp2xKIZXWBeDkmFKCIqTIU4AmFpy6goQZc9MBDgK80SGiInkZGjiJEShEwPfOOYY8tGObxNt/fiTexGdXC7F3USalhowsDPKnM4hhMDGZxXJnFrXJRV2EctNewDNlF+XCod7uXoUQ/x+3WcTdLc6+SKcHK7b2kaLFogPDDx0ez/XD0g1WdmgAlHCiLUEtnG+j3IsQsILGQSeZd7h0kpkqO7CySrWmgkkuL8eiCk1ktA2aLgNJiPzJQkvVpVWa11prp6ddmkzo8ij0iAnfZwMAG0FuSPIHNYwODwOYJtPFyZoWuyjLcUcnAvIoElgSNsrxrej5v8EJxjJZIQ1smFjYlDFvsulZEw7GlTREwHl3UrJlDRiS8wRwpQ/rS3n5uRFeg2jVQozlL2hfE2BhIX40hwiRuN+nLXXgh8zLAS2ZeDuOlZl8Cftlrs+HlclsAXq4gUzRerjbHe2pySgE2nxL23Jh7LEprrqmwV3EIswKTngKRHCya8/ImFkGaRVy/DsgDqHmGQ9/9G+KSLt/Kos9iG20b5tuptVEQ0TDPFTvmzJnzkiBlMSvm5uar87xdWcjAKlV27zpWMS3IeG3RiRdhKLatD3J+72eKuj7GaEZX7hmaPyAiQwb3vPiGjlVSGk/TMcK47/uwZ5xx5J7e76k2IXFBiHsqDQceTc/ngqr2XkyqmlLQK3Yow9MtWRygjeNvaPt6sfOOIbyHFErf24TeI60QB4uxGsLn1wRbCI920E42fDS+6i/jwmGpLA37nZjRMW3lvr/qpZe+4MOnXPS0oaiwe6CUQ3gaLAZaZY4K2wOtLYJ38IRfoB4kS5xaFwTiU2zIudXb27XGkV0gFXN8V5tEirD89WvW/lbMvBKYIXVMAPqqUgA9XbFijQXKwEUYSh0ZXQm+PSiE8nBFCbI3JS6dEteYEhfCeBdWJo1BamT3/7/0jag6qYqT0VRNybujgI/cK04fq0creh4rj4T87G/lfDqE0UHyst/UjaS+yxH5byEmj8q4YN+T5d9fXJzdjSQ+FoL0wW7Yj0GJkuKKU0oBzwZTUIHeRlGvaEvXmVcVuGW/jbLw5aC0/c19Zq85fwLPmsjCgo0Nu/s7Z6+e58vm93f0U9hb0yaaj7Ghj4TrA9pN61QqTcLEhz+cJ4lhkP6HWs9VC8ofOfyqQ5xIEA9sf/F5/vO4gPsAJQpBHLPftZvuloLndP8qgFTUT6+y4vTIGmzf5b+gqMZw3a65ib1dtT/76CHrvAncA+dISs2+inpBIhq//LPKDPlN0Bz4B4xj/69w07nPOgcAWv9o67LC66lSgZ6y46v+zfigjM2kBWA7OesGatLDd/tBxgsFylZVZU3rf+b11SLCNa6KAehKEAiVX4SuCABQEvt3v8oVkWiKajxgWK3Gwz/Ww6ZYxQ1f7kzV1Q1A6hSqlZqAwuxjOhpquD+Byi80AiB/yZvm/pqYvYZvUczctsxc6GFBgSs092D08ybpgIgsjZqwLJS9FlVyCr/3JIWnGlS81BQUrg22sF6qYwVs5OzC2+VX5IdZx7o1YMYZ97OHG2ocoDog/DYUYpvJlesFSHFKqKc92jCI7iD2KlgXKFWOvdXf/oNF8gMEMzfa4ozarsV5YnQ3dZBxZpn0pDBYjyEU0t/+0hdbA+GZmhiYUVcbs9TcyOfKIzucndo1EuupLjL2mc/LxTY+Mab2mlhSXZiWiZqANBSz2MInP+Azopfzq0QwoU/kGrx1iYlGYwAu1bPEnabsAtkf8MoKPmifHCnKWAnNC0u6wAvJPOdeFDhTQnPZLfDjhf6hAbA+2oWe2cPtGpP5MIrr9onyOQd/j9Sk0Uxb7ZmOfXISmyrlhqvA0rQUQDVCBGojepbmUUiCRlvPITPgWWaooRl1Tzkx8hDQagYxmhAKOh8o7Rz3WVY4+CTTxnzO2AnDg3FdXZZ2+QFLHPwQF9Z1OQPFrEhgbTOiZAN6mBQcWNsYGnuKlzNBnlsv5ipWsSuWF8v4w3vJBfm2hF8kKO+SHvGTr3P1+F1w+vf0ujroI1oVT7aqSSbr72tWZ6zu6kCV/NUQ1DHralCtVyBOfYx62R8oJRd9Sfx0BxSVsuOBLjn7RO9243M4b0OfYQppY8y9+X/1vEmjQrg1pTKzUE6q+of+miGON70MpZbbxNZJ9odWXwy6D380bk30PWHoiU52OOXegkeBuQj0EV49o+zj0qdYdaa6WH/AgYVCi1EjQl3rffwh7o7eElBPWtknZAFRT5HxpUXSg5iBIGoQV75anS7BPyfVfVI/UOZGv+qJtRC1J9nGF3H2KeSyTlJiPEK1fx1vVMXdoGH7dkc/fN85XzvzzCur/HyZa8SgZx6MmGkPqAHNapcZ7No61LP5KpDjvymtKDPeUbRcC6i5rt4Fi+Zt2a0I4FY6f27Ylr+/GPfAXAtgCBKK2GkZ8/2uzdyXdTVe2qLmkaGWN3RtS9lqfKAKJrHYtSjF1kPygDpUV7jJej4wtm0wmLjqcY9A1FOIuvsUikX6d1lvDV5eS0MkR8PyXoXo2XvaV3NfMwQeHPrfjKLmUIILRWiI6L810QPyjgwrvgQOCs8IWZXx6nFXaF4I4jj7kkEkZ1+wdzoYqvgAVoohkkJ70ArpdggbY5HWXhiLaNC49K6c4sYg0mKgF3lpHlrlthBJUloO16NcX+73k9E6xHOiKVvcyeuFfg74o3XAHlOAOtASLkcO5VCStFSA9b1tz3zDWbVdOT5kmLthEZNQ6a1eGFzn6NOq7hwRbFn30yihxCKxfoOrQeTLnlD9lelsq1HM+217a5u0Zly/6X8VhqSu2cjDVBzc9b0Xb+hGMcQhsY/7xhtQ3bRkbB8bQE3fOdts8FalYQ6PfKY3jZd7r6i4JvVL9OFCwA3CMD44XVKbJoyF2R8DM1UaRUrmzuUHZMPQ2wPB272W/Qky6doT4iFWEOBmEkvZLlXL8lQtq8Y8G/z5Jaoe0TiQ/angftNc5x/VWk1dsOWCbdCaBgMCpyuyx+dHCGFEHbYxZ9GPQ3DDjzpUKVsOSYw/9n35gtqUXdRz8KVKyVPrSyt7OLWCDyGSsaKnJorkzi9v0SAzA5VGpVZvM1+udGOLC65Yz8A9fLgqH/bshyu0wip/KfQUBnfky7gJqdvABtL5YwE3LCAdyD3CfbkcTONI9VwbCuCCtpK3wZ/UNvJtAufVEenKMuDp6ub20lZ8tZ0fLMwhmucqFnJodkbKQuqh9RadzStDrqRmbkdsGw7evUdu9M+sSd20hcs4onHgrT1rHSCCiDEyblK3DqCLR9sHOawl0yBvwYUGThfMnl9veVuz6TG0dXvWnZ+O7aJdOr6abykRJKI65IRdxZOZyZzqXEJK6k2zYF/kIu5BjbtUMWWR4PSwmBXZCVRU5XralC935DlO0cXx3U7+OwUMNwnjxuK43DPjwD1cRUc5Zkohp+Q7UYToZdSKQI0mKCgfbvBt/M95D9/ncdEBzQCoOynQ9EriTmtad16ZyB3w2ZefJtNtgboM1udO7flp4q3wNKptUulpdCrVJmrjOG2KqTTQSn1u2ikPf9YrdvFXpyFQ8A9LdK/gpF1U8Kf8crnm45diJ/IhcIrm22uT8LJbrxBPafROoUjkiX8++Za/+bxHOf/kubFEIEuBM3vak5fqCNvB3ZNnOsazEGvTTjh+hKIbLegohrmH0eGEU/jvVDuioYzolNadyvmQP0TrAb5NR/RUO6KnTBnRU0ZHlKs+jf92yIiGxxlRHnX4n9x0RHdgtCdqO22TEYXbShlR/moHAqdXR/R0N6LIh4FEPgROdSOKJDeigCMwHU0ffLj6V5w6Mq6nUY4yPs8z5qk/v+ey6l+xA83mAl757dW/YhfqedBjoO8U/LMlEPKTScUv4DuGJwVh7i5gyCtwKYxgXfHH2srwKYeXCX4W/MzI1yW7dU1Re/EZTHzOUMMx8vJe5dnojPdCVwUHVMus1rXFXBo37jnm4BRizm4RsWrmHh5ZXjqVaULTKaRFbm82kE0Gzg1J1iqf0XdM2uRXHD6j2qTfLBUHH+SdUXsoa8HGYN9/qX/o+jfG7PKIWu7SFq4zb6xjhXKCvuGQ0lLBgryR5KNIHgzKreVgcKRwyyBpUPn39K98L5xycVjvCA2gC2ZErxV3xjLjbN+8s2sRmBBY6sBiFbJMgTNYvYrRdEkFWB9BBRCwdmBw4ggyy5wA85kN9VVtgEQqrFGDTmopMmHfsKQcUYjjCGPRKtRPfBVBsaSL5Fa3ZENcqLxh6PzlqztjD99l4ts+E8OVf4zmkS8MpmQHt2hsTotxFe5v9XZw+pqI96GqzFbZUvilTV9n0bcIqm4g1sFp3oFb64GzN5KHJfp7a4CmbDsAZ5Ha4m14xDnwipDwGZtQlq5bAiUzdjfik+92I/qiuxF90d2IvLjdiC/biFh9ptiGyU5BPL3G2jzcmcUjwdUFV7Wb9rEWQ3XsRjyrAOlJq8xuxJfdCG8WRupQZt6ULQfEItckDoRjdfiyG9G7NQpE2Y340lKBIXYj+o3djcTYjSCxcgqP/f/+MwMAlSGtdOVIETqQuyCTGDNavlZkGyo3plyZ1UFyZSq4KEQp6ehY6aeHXw2sDsuXq3pm841xcTso2UDeMRymn/J4yo/a6aKaHqL72d/puWR/wZgnDzUGl9YUVhJpfEWjigCPCGn960qdkUhLRZWY2mu4MOKtOTfl1mm0V8nAf2BWA9W5cG5iQiuJI47XM1gecpXEifin4IUK0DiBQ/FfeN2k+aLjf/G2KV+8XG8B2vuIuuP03R7qqXs7aTmRtb37/vbzRy/Y8TsX7t33axtvjB9Y2mMD5++1e4zwWT2cMz2rNxC/DGHpl6Gc8hfsHaT/yce+csI6rvU8qlirg4oysrcrhYTtI1+NY/+umNUJKtZkcSQzSN/pBYEcWm12zhbouOf+hF4UgnHlbK1uz83qY+dmerY2NY8eLueR+mjAeaexS0KBbtaz/4U969hJ23/mu63AS8xfX0HZ1u5WvBHKBSwfX2HrfOhzZnZlf3OjFOi06RLg0UFT9JrnTTO9LOZM+AF1U2tyGRIl2aYLSVQpIUIqJeyj1hDiQeYUPiMbb5RDFYsR9aAuisxUqwrzAt/2SQjnicR6QVWsF42I9SJIWkbEeiHWFIzKkcKppFN9RKyXuLZQbMV6sRXr1aHIMirWG12yqF71V/T9SHeCvXAdUpSE4ilivTqL9SLgSiT7bcGf5ytroIZ9cFuvWlTe6Huire0V3iQAvw6AgxyIibIDXDICuLQCh7oFXN0CLsFdhOMCLhlK2Q5wDQoArpTqU8CVOHABTARBVxPKS02y0PJxV4YTvNTY8C6aONIZAyJUGZkIww5m898rGMWmAgBZ+D2Qdn7nAABmr2kCB4UXOBGF+NnHkUK8PcD5xeZ8Yx5UWUHPiZstW1hlCuFVbPB4Mn1gxaJpTF9oGB11MqIOn6YxfaEWQ5EyfXqhdxrTF4wzfWK115R9ZRGC6UMtHAimMn3KfubBFKYvmGT6wrzKYFnHIpNcVjDCZQUnwow7H0fMuDHwgkk7rda0bnbfoSm7K7c1ddu3yG3fosntm0uXVEyER1QFmL6O6n58FtkVztzv7HP6Cl4jMvZKlWVSq/lwN7gmNwD243e3WH2UiLPws2dtf//aa9YMiYq0nJrcqse+DnwjRdIgxEW6r4vQPoF4bcq+zudW36v+s4SKSXZQBm5edV83Yib2E54fHkdFyQnHsaAZ9Zg8mtRciqtS77oLJsfVXBIfd4nhro6v3SQuderQXAJzZSXbQ4rV+doYe/UcxmPjrMy4LlOnKKr4c8frRv2TQUIrib7z5FL1UdaSz6BhA6Uu7ED0IIh8wOcmwKcEVMH2kxps0FVtxvpop/qxohB44wtJgwaK3syadqAm39aUfKC7WgaqfATldNLsf4/5Yvkzfd9as9pAjMX3Iq6qOLOqff0ksIPpyZc/gc6BM+dYAwg9mky/5LORa0EBPV0I8BPycQ0QRHZWgROpCApTsCbRuubz66yomvCfziRcJazwSxE4AA7priwPKnXJTKhLXaEULWcNdVNXiHwR6lL+IsSknF4XBSC8YDpiCrRKw3QE+m0EpiMQpgOTW9mMkbaE+ImlLXVUragRa1v0Ynm4JtEp2kF1kPlpreFVoBCwEAdQ6+TKveyB19Y1pHJCnB7yxFaOPSMKjaRJLXirWIl8GZTsL/GVjIjkFXHQ/YoF+jEy64F/KK/iCwj2nvkBcZRMi04qL0UpM9JZloqfpv6na+oQg9HhI//AqIfioN6Gknii26b8tVUNoNAZ5E73mrmLuZj9lfTRIymCHxXJlu798QiNiw9pWpK+AnsrZ3jHGP3W1qqxm/0VH3H+fk5GVqEdfa+T6n5RrQc/i2q6i5PlDBHXYFxwvxzbLrM3LfRjYE36AhkJ8sRgOR5SMcIqbyjUvbl0WVvA8QgHiOJ6UG8iNB2coifZBDKjvUy/FZDOLKDJr/hs0ppQgITU4451+RJIVN9QtzD9chrHrCqntuPK5X/gjQhUsx8/VFbT4inpkzR+VQ+YC9HKkWE4wGo6DhH5S/XRLqaJ+5kYfAfzYsEqXirqfJKNmAyANIq6sKiYwKJi7kNYbuxx7lQ0WqVQlZXC6Y7qeY0NCc+L9LNnU4DH5UYSZB2DQAtSXairKrGq5Bl/jNLy3IDrcrk4zSVAA0nP0NV9CC5p+His5kK7PeQJkccU+QDgJhkKH9p15/m7ZF45JdW8iQipCo28lgJ08SUTIvTU6caqjUj1OydtKGJlHWCGIwkU+OTbA+e6KIqgHy/L0VVQJdBP9oLzPRRgbj2PH9y978QbehDgPN6ChZK+n31RnfpgFhS+3neVAvHzErkUnICxOIsBKsv5/fguexCLStFWH45tqdQJu32d1UrdbMlqmFErNs1oZ19C5TDbMFqlmDA9kP2zms6UgVZityCrAO5xRbir664kDyll+6XuJAI6nA6seQeGh1PLP+qwCK16dl5Tq9KHPQrcyPgyMhjtFxV1GEi9ILiFM3DF/HPYW8v+XkU/xAmHPC3hoKdpql6ffVlznMkl5y0KOMRFuBrQBFtJnfwD+wvWhM6Gevm0aA6hvBzgRvJtHNxt1Gz2wM200hO0F7bVd0HIJqHdUCQNFLTn+bdIutoSvtkTk6NdNC2xPfgHtG+iPYW/sZ43J41/oY1X98RpIGeYVfWW6va5qahLzfUjDu5623wmb1nvFriGkRks51RMrFlqDd+9B/2JTMv+USEnw2P8pj5bp8PCpaoFqtMu1hkyJyQYJtN0me4CB7WBipFi5V7dImLa6N0td0xV4zHQBXNN9dJ9DLgOhOBFXdrlLLm20P6pab40VxpR1MxJHbA/tnd+AtEKltHT7/7J9DWpxD1o4to6YUFs1FupGVwX/SaNZppeytPTRUy8cnGuZX+C+HTbtFgs52pXbze2h5MiXOyQoGya/e2hMW+pbwZfMsVzPHkYCHXWZi9T6Jqxp8AipSveRRS4Q0pNPquSvLuaLGWurllvogoKRMq2FI1TKPiucVxOpW/vBzs7cZjonLhA+pSHxqVAC9ih3KEhsmfXlNNF969dw15fPwwoxHtoTdchtajnIqtx36mPzFD01/q++mDVgwndaUDYjHuVkboJtM9Le8aNnT/qxs5re86NnS0lVYrQ0lVKqYGfiE9xXAvFvMoOvk526tgqMejUr13LT20fasBS65Nl1HjwJ8IR53eRBZ9uAbjtCKi7g1iZsTpI+LeZhDqcYiQcUTSejShZ2RJ1mQLPW9a3UN5UP1zGq1CTYusKOAU7hhi926ufym4/Bp410Agfp3kUQhE+XdtvNt8xpfsLYyA7Vi9GsS1+rGx+aE4tOOWCLVcVw5q7Z33pJQI/dAHvgGC9UrF2AqOKqjntudrJQBqjdVp1RlSNLJdWOmPs1eDuNupsap2h8QDhScUxItEXo5+b6oLJuGddUgoKogExMK6J0qheOqKMS0eUHum3FQ+ldR1G0x+RYMfOq4fyxbb9uMmccuNRvmzHAYrsBkE0j+rGn6R6WbMExTmSvCMKxIjF5MzUHUd2XB+CPnqux+Ni7Fj5P8UmECy1fxU41zXq5tbXqRrohz7fc7iwFuKVfHdpogEKGTjvq+AJdXbF1BCHwaa7QfYV9EUHIpMtifgi9tUWNQMOqpzZPztpVItTWgcYsoU0INZ+8FddeDBuqp/hUGxbsweQ0leMj1FpIBVX/Gb0vgIv59rfmLSAjlTa/4VP/Pwn2LENutUwKS1sgxtoPhrU/3nkoFafH2cwGnSUrv4LmqmcClc3Uo8QFYAD/J62OQF2veCFosLQsK5KGjg+KX1OigkNEmi2pcwiRhidEaPDgfFG2aJEId4QKOMt0Qd8STxksKhN+Fp33YCfgmkqGHVG4UxXdTDET3v2sOKdlXCp1jqgBxHgV5FYpXvi9NNZ3L4u93XvIwLXW4uwTPg+LAzs7OYZX7P/ajfY8D99rfbdJY/04HWqlIGjQGWlK77lxX/d+0+mDG5tLl6II/d5hQ/j9EjqQQWjBVp7YV+r/f/atdHPKSy/w5m0QCCyXFrIUT9sot6sUb7IT9VODWyYpa/xPf9aCx//1unQmd6Qmn1/6Gu188sSOwoo9as00tRgczBtXhhKOR40RsYC67seKOBTlGH6HxiQmI4bQAUGKoDDu+uJNWTJ0lf+KzWt7605UbgYa3yeM+F28Ci/Xy76/uThCou7iOeTb18pNOcfuxHG7Rb+2T24wL538bOH3/fY63rgEcVWmxaB9EvyCI+91nbuJaOG5PZO23ijSitEt16MwDjFFcWfRl8teqQgWnKNJ4W3StaDaKufLRSN/mnTKn3UFpbdRMfU5DzlM9KtvIPHrjyrFuCPF+CKlNzypcJCypJyDawy6hy5AD2HKXUO7TUuH4W8qQcGpV56pSWlUGvQmtvM2PUMehCJay2sELzs4m4MtdSfJDV1VZqt6CNQk4l/PudicImuxcVJmd8qBcwSf52A1M/CRF8LYKNI1445yFVQgVgz7AANIQ2hzrDoiJiYOmJbStUHLGwEagY2sdxG1K/zTIEcW2zKGBREM1ychfiMRSzAaxe1sOS0jBUcxQMd5rXSrU2g6vVC7RcQbgnZLLO1CivKbYHzRRRzst+i9sJAfVDvu/PFlOZxnsJFhNQSJiVQn/aicEt1+V2ENnmK1qSKnG4oTI12LJ6FxrmxMgsEz0m7Y7jxcXZrzVqde1RRpOrU+msncGq9uV30157ILvrZnjf6aU0/NYdKHnLXbO5/NS/eN77u+B3+keDkPfeDtZrw3I+40Hnu5/nV50HHoWnran5bO4Ef/08yK+QZP/7gkZwf/08ghULllZwf/1e/zvnx36zOR+TVv/+SF3IBa4+/b//XvG6ab3/Upcg05t7/EOIepfPuw68bd97dPeCcd+NlzHn33mnOuwv+7GrG6LVH4cH79Mp2XiaM9b/433lU+0//gb6X/ah0Or3Z9xon58q9wH7duXIPK67cnSN3b9yRO0Q0D+n+SuweQ45xB6qAwiTOMWNLGshVFnFl+025wk2HuvGMKDTcNI5IVQTC5aOcqg6wMM4YZmSQRygPpGUfe63z2R5M+Gz/PaTW0tfH7DDRe6W7UF/Z5etU779ybcaHE+zyuqdsrbR+NKPlC5OlQhSduSNiEKoZpHen3LYMPQfRMqpxNlON95/PoNedjxe5O2TYW5lPLGfA015XlT0CMhmnOCp9UwfN0qrzqqXY9kK0bhaqGGU1xlreKL9Sz+waodQ9pdhVgvajBFcLJIRMYVIjGvcIPqf4x7ZVmwiR+KXGGHwAX8xN4IEDKHpHTTV1X6SQNCUT4in+BL1Ac6S7LHwNUhjaV29WsfjbxKctMTeX8P59pAxtfWuNs0DkH4HssIgftkEiaquVAtnRyY7eSJRaJQjrgEuT0RjtVhHIRBNThZ8HyCTSH4aEgNVK1XyK0eDY3OxW6DRyACoYKQs944bWqg0lbWhiaEAMtR3bUPQIEvAWpZRk1yOOIrlFgYTdpYQiPQbJ5iY+hTubuRS2jnJlz6kf6gXIMWfC4Zgz4cg5KuZPteAAY+TL1+pCWKiDb8gCIixZ0EnuvAe/6nVTvQcfAc2z/mkDyIRCoY8IiR955582NvMgIkwstQhdd+5gYxhuT1Sril88084GCBTemgarmzpB6goQlSrqx0LUCARPfNCG1gctJJ37gaCoUzUrTIeBqs4HbTpSaX1KpYmpdK3i+BaV7i+kU0CYMT+zwVr6c2CI9OpqYLY6GLWwNFjvW5gjKQ/t6Huaiswgz3gTnslQdX+/apOgGLDxfmVhj4A61YVdbmcrQY2MGQEp0tbkC82BXKJ+cisY/A+HbgXzKiuYV1nDgvE1DCj4gJERhiocep0s8dB/whLmHI0Lw4dWRqjXVR5zwdr3QPseGwGqrnEilVbxj4YSnMHqt1BdUzhEWABaqAT55BHKA2nZ61/nFrb6xML2hsfAz7xxgp9pVfmZ1gQ/s7vkZ8Lsh/HxifiX7552eFJheVW3HWs97MOVBx0/grIpsGJ6rd/xcaN80aPu/k0T3Q9f4rqPl7HuP3UaO8cH/PsfBSdXCBgUX3lBzK5/lURLI1QjQrMo717NIsOkWY4P3+Sk4auI5+D7CHdZ2lAVyI42tGsb+s7YTWYq2S74IOG5KYdKl8tlo/4VWDDFPXlDbxbY/0pP482ZOI7FUg2WRI9Xd501HvdRJ456SNeZVdMLY6oB1pVQyKEFWLZao0iX+DcxPLiHEZKt029LtRQB9GQAFEv9fWsIca1IUSpbk3rJz35MdyRhGc9dLhNvRmIrGE1jVrTM8OPIoExms7+sp0uWrdA98k+4IvD6k+6DuI8RNQwGHpLhFm2Pn5K6gWGMVbYRNVwP1CKRSpdN15YFgGKTkmo0ITqT4xwX3YRagHsdhWFQwjAwMAwsDDWEOOU1a5UmpKbXRVPVSMtRrpWjXOP2YYynDa6O++QYt9UCXx6DGBj43YoE4deATxp3G+Jgrm9/LtqweskmEqZMIRxzrjcjl54KACiMvjZSeIjcg+2AAIDnJ87HMEz6LVhI3arJt7lQJ22Ckxp8P6/VfU834NwGexSkoYjHTRkYMdrWSWVNPrumeSSEPCg4QC41I6X21nx9XgqmPkh/O/TrrD5lLeZV5beqDWSV8cQQnHIdMVRtQoE8VrRnI4x4Psy4BGH4pZNjtIYe9DTNOeqfVcS1H6m5UQmpoaU3tWBf64206FhL9bhUuN7YrBw5OQTu5cIolqu3TymeWh4qQetd50z7K03ve8evpGYqqVUkQp5WAlQ+6c5sDhLgi6tloitoIGo6TkNOvhXH723teCBN1ZCfQZdG+oDv+w6V4LUwGtGKDx2RCGTS7kFIJu25CEElIhLEwbp8loQV23YhzOpzoiR/sXiPws9O105tXV7H5HJyOqrjiQmglcVak681eVwiHqgw0Ap1a4MKN6vH03pG4VHWE2g9odbjaT01rQfTRWvBZDleHTWtY2xg6wrzyHleTP88UIi7w5e4CnHQWF1zjJtBDDtCqH4fxWineCMwE/wiCYcyqfcgzN0Q+vb7tTVcEJbfc11DFdRyIyi0DcVcwhN7HK2urnUFWpcP0MR2lFGljnKEKjevydeaRoe3rCnUmiKtydeaPK1Jh1dr0uE9fk2e1jQ6wGVNgQGh1uRpTTWtSQcY9WCAj19LTWsZG+JEhziuyOw/XtkI7Z7U61G101DDGMdcppQucnXiKtTckz3vT/SgW0ILWEsllAAdJYR270RI7ZsGnEkUsqg66tQo1/g6tj9Wrz8RU4O2P6Bvst1OWr6ojmsdsVQAQJLUiLV9FSFZ27sSulrW8ZCfOcxtPWFNWoDWlItGKlWK1cmUEjXPpdCrI7JODYZuQ4FjFX6cnb1f9b3oZKFaQzMiBW6swK0boIZGiaIEaq0Eaq0Eaq0Eau24QA1LoEYqKeJ0aUgF4WMtsu5gWFa1WlbV1aoWtOW1zQGIKAc44ZRwcMqfhJsB7qcDPzIUR0EXjoGuwqtHfV+Vvl6JO+aiHyQMIMXZ7WiDdQZwndbi5bEKpBToItFAhzAX8bGuW4SHwhYhhW3pgFH1KWQdR0vk8pOepzpIxzL1GpimFrLgPs0zgDFHbV+qnF1MvnWPoz3SHYqPFpXcLqkcUwvIfgqfF3VR/tIDbcsd1EeoSnh6QOfb0C7llOvCTWKQFYzZW7QtvlSKJnxbXheDUjD4pDInSMNCJ97z03dG0/CbgrK9CAeGBnclHL4YNHhB0Srjh26ugG66udqJkExN7ayiFaa8w2RrWzYWohAXcAYIoTEOKwMydY1WgzFFbw1m969FVTqJ46l1PFP6jJLVEGNNp+P00usyNbXkBdMJhTCq3bR4kexClFQt+eTAU3iblTxZcN2MRoZIs1equ/0m9J27iJNQxnGPd0cf5+6h8UZ5GZiM7EpC3SqXkudoToWyUD29fgRpq/uQEmlDXeFCxlZd4TAJwRth8ekK7QvNyrYgoYxDmTK+Qi9K3KrzWyjkBF1RJYJqV6RQ9bGMD7gXUpUvYOlK6CWmFh/99CfrOU4Fz9RTEPGsCl3Gx7VkgN/Xkos6v8uCaq6uACgW6ZBDkU5DNUOKFOk0ZJAupM3AWySPqHmKc49rb9F4IJ3pZlouIng4tIMsW/tnsQ8oCs1IRznTL4dBwMubMzxac4ZHPbA6kyKpmTiKVCBVzpqknDWhnTWRcgpwgIyHbn8kpNufoL9TeYLdZc90cdFTyKgijI7xbIWbCJ6C4wie/BMJnryRDEVUFit5i3qFzdQjWhyTqFaU0jPtZV26l0goNFCItOdR2fMISdhfTOu7lFLO+kaVyTT7JVqr8pn9K/QwMFJW09cqEoEsBbZqYPBZEloQ2oZQBtpWsprYkKEdaNMYq8mxehvZUS9VqOonss7LUDxLtRbBd+YNqmOFFk4K5Ea5KaBRKpr/7jLDL4VeMkn4wE8ov+ErBwU7qXgN5L4n31uD/q/1BOJ/uwhS0BDIrtU9tbL2yhjpSEiW2GYhk0Unm+X+YzAt4FHDykzr4ejTlR9r+XFZflwpP9AsU7g0LPaTZevZySiRbyiRb+rAa5Fl7WllOtQvYfJZF70WgETt4cDqjILkJPrrmpxYuqYMNUKWoY4t/SH8LJRQidNKFYFWEZRVBGUVDS2wqUQvREV12FrK61MLViYndcQqrZKpP/McwlBJoRRP/BfC4pXeC3SIAhoiTQTGY1lzmCMoVtc793aWdMtZsqDzKJOIXTghkdBOneAyEbG3DAVrgv72ki0ITU+KJjxFQWmaAwnmUlKOXiI3xPWQNHDWFZL0rf40VkCHFs3VITOzwoK+VoI+QcgiZMnKhCUrEzpWZgIbAfpJniNWdKyruj0FhetEBKFgSGrkVRt0AlyIFRfqFVxIcm8qHqjTsuloIJeVy4MkyHitpgvV1CqA7xRzPHeMr8IhgAkXr4PKxWu13aHXfe3ZfO4HSFepsd5vRWewXmfrqrCnHyOHlu7LK1eIM2G5d1C9eI0XXB8bvXh9Ma4Df8FevOaroPYWV4AMoVhYkDZlP63n/5Xj/4lr12993SO+dv1/3sXnO0If9q4nFRzdKPf9l/J46lWYa6TH/CoWN7M/xBXR7I/wCwUUntB6snuPxCDn7pEYSC0vGonxdOyet8nR6yXi800/UKeKKvWrxtTlBbpEeuche7vzBxoWidFLQFV1VYaIFClDPPQ7cB6gq1ULgQN3N7NIxV0qpXfg6VHD5NNUicP05gR+oAKzwcAjtJ4EMarWNYfiQkNUCOp6Ltf/eG1N4HM3P0vbkO7qZQNXLze4Kfa2pRwx28uUlKq+vbbTRqtVVFuZ9xJrhrYuqFa6b4rLC4MaUzVRo3ck7512R3IiFjNPz3Nn9IQ8+zk9ifuE5/nT7kxqr0WBA7m1dg8wGI/V0bxIdYNqKpz13cVHTd5dST53MnlnJXlXNVmq7E5rR8tFfkUjq9deUJjr86+ekc6JlSdw/uHLA/5rXRe83Ha8CIQ1PMgX4PdeUy62qt7SN04hLC4XifG+g9QmolpI5H70a2fX7n/7DYdqooTWF0dU98r71PkTHtM0GP+Rz9SoQN5SFG3r/et+8mIY+sZ931qAFV2+4jmmNho5ogVGrGuMEsRsPh4tRtYio9aL81mSBs/BAIx8C88uote+kS9qHXkMG/5969etjXScZ8y+GPfnIjHp9yGY9EPCRSQRQ1qEX1H+MCJ0WPwU1sS/6JI6U1xg2qTeVecpE7M88+Csw4Ne3qU5dGgLP7jDK7QA6WGPC1gNjNId7kVHeHSL2rdOtf68Nd9GW2HUPScRu4HCdLCMJ0KJ4cN1lR/gjXKKVE0sj5D6nXmBxyX5jinFEhdJXDTlWwUYK+KVhwpVllii/ADNXQ2wzK4ZTzuwhk76BhZX406Rbiyp4uV22skectBWOgWBrWgwaSTRNo3clhrNTK50C/pRsSgfwHQ9O+UpdtJ2zkvEYViZ5gTEfBExDyCGNCu/FDZBs2aaVT+WrDUK4GuOI/hJPZ5MDyHYY6hd9wNFzO8P4n2BEPwyB0UcU1PHsPCtq8qf4voxoi7FYsp6J/eqdcPdv/3C3f/tvovtkwFiIb3nW+wTbTyljP51+5SmI3ov7vN/0D5RBDdVUq5Y+d53HXu/fbqUH7g6OOf1W9bfa5+aUpD+4zcu+EucU//DF9d+4vf/84V//Nmn2ac09PO3n/n6z332P3/APgEuxL/iq+/47r/Y+ltPt08b/4nv/dCWgXfGB+3Txv/Mg9ns7Oz1F9unjb/0u/DvNz5onxqvLUX/dOn6oH0ibcLblPSYxrvz8T2HPvBX/3zn++1TPv3IO971/rf8bf50+7TNePt33H7wua980wfs08YfXvxd7sY/P90+bfz/9x8+tHTgQ//xg/Zp458t3fjpi+3TdWc7TJ97ZmJ55bx9+NunGbp/+JNese3h7yhOnZLIpvmBylyab6Lsk7N/O+Hbh78DlULyBFzkKUwojOg0IvmUtj78ex6N5zbaGbFRXu5nQkVXsTKvWke6HeToUNb3OSM/YizUjpjGKokDP7wLj6w4Xaz0YB7nZ2CiJ9DOPVPXi7Pw4aflw7OV9qL0HgV4tPmrGXzJvTg7P4NizrMLa8s5qgNutITOAl19ArYkM2x4K99NZ9MMPeEAduNMYzt45UlZzHPcWp7xa9w/GHCwxdP3iVzwk+iM/Ml0Jlynm5WiDQfUy/xTqPcwEIce4sBMljF6VKLWgI1LU3Ej0MkLyvId1GJ6/iQm5k8GFe+/Ms+pEGcREW3Jl2gln6VVqQ0yN3WjtpNmy/AptFSGiaIyzISFZhFidKrJcytwaxtF8nIqLcnzNESea/2Q6XksOzFA7FOoS4TAeWUyzbMN+jLPF417BgRAirlQrFMZF8rzi6k2EoBSXQ5Moie+kPK78tlhj1uICaB1zXHtKIcrQDRKkGjXhKfQeahAvyb5mLbRuYjbJnEDblG1RE6VTF06dWqJcCyhncLXu7lP0g1CHEncXVzdSIlEyMQfdl2JzrOJHBou4bFEs3jM2nmTQ8CQ65ygQniJgnbIcwdtkecWWpHnCq3Kc9X6GZgx84vmZX7hkVELjxY9CY8n0ZNp9xrj6nKfH8v0RHz3RHrCt6po3Qhpz+m/gq90eDU/LWeG/+91ZnxzZnxzZgQpJkLwovx8PC7FMgEs5xLO4FCCmzd5C2FMhQ7KOptrOv8AiuMZIaEnMvru4QnxBJ4Qux/9hKDxCfGEPOfJUPBE2METYgs9kfu+20yKOcrzeMrEmAcbvsnEiCoTY16Zb8aWyEyK2cqksAM6b9CASPHZxOsUs8gNzBaE/vlnP+/+H3r35y+2z2I7uMit/L2yKSJjsM/iXE4U7NKSgYeCrhrbnZwfRIKOhFLLKUZ2riC2bB4YGZ0riHZ4qL3Z6pCaCtKaT5ESdZqMIjW88NAkUiviHhe35/GYh8coTCjF7VxwN3+UOP4E7NmeQC3KgJVPxtuTGccz4OUT8fZE2o233YzqBFTfg8/30PmyCADVIY99EvgiIHeeVTB7RTD7SQe4Vsa+FuPzAuPzMuPzlmCvQUvawkib5CTPmjjZ30EL3McV7B+5W8t5AfRE5xk4cwyZnMFS5EtgNStoGVfpNcUGBSNFQYdljvpWBpBKUqpDZ0lvdcw4GqnYNp7smGGUZs0ozQP6MnR4zk2OGsC6w47KAiC/QCuUycjhjflhvC3zuGYY1hY+YHKkH5xJZ9E5Lyr4B1vuV66pz90z6RyaOZDPYN/IkI9pF9hsdqaEj+iMkol+Vm5kFwVc36m3XoRCDrUQEvMsT+Jn9BK47uXxZSxpYrXvIQzRAw4wWwdMgcVyvlB17gtfUj2M9hm0g3vLSXBQNsfJBc3LDlbFBiiRCRl2tHZYqSY8QpFzxF4eW0Tgg5q8k450LudHiJExx3OrrlI1sxbn8pSF9FzdkV9NAYZdN0pKjvCRepkKqGuXaCy/oCeahDNY0BTZwu+2RdgdPud2m/uuwSLM9k2XZ1AJcXIVYG3Uj0nGa06FSDjBFnCENcdACKa5KFpSJCTsoQ7q/VGLaOrdnnpWwSrFMCxjGNoiWevwUGScr5XnvCQUPN928PKwRUUN4mOXVrh+XvWmGPOr9R5e4A7uQJZVgTCJZIdiWYt0fV9Fi3VpEOkPxWI5YpE/tYSX5TLUJq6US7QlbZNvZSxPpcXbOPdpJjegb/ePEc2BAHcJVWEi2608fIEpv4LPFNTVz3KzCm02Mi5ngZzngkCUkfM0K5OZH5jLeORU4DFCf6/DRLVmrtRkcU3n60pfZvYCHkyLmUjkMT98+AyP5UKjOYAaJkmbBafRdf7LPRGYBvY44oHu/hFJaYFzLSO5J59lSHJSFquZ1LxuTPyqm0k1SqL3bRsqVW1CSKm3i0UAqDYEashMCWgCjIKq7QNIPGvKbVuEkrpb1ICw/QBTCYhPU8z8kHwIJ2fwADPlb4iDw1lKZfrPoY0MGADnsh6HjipNZrt18yibZuGhu1hQr4y780U8duYNVUyCHCyDFY8QUlJqyCE1jwLEgwbllmhpujdvnaaqUzjN6bi6sVwks6gsTctBvkySZVpixOBHTTyO86tE8BJQk+6pCBH+9olbuYx68Vpzr2g4lD/mreu3Ljo3RRKzZGgFnpeb517z3K3nwl3KxOCWWrEF5AJ4IgckJn2NM34ifsJDOci5LMg9uRDSzhfRIGlzA9BeXSu2gv5wHxfzmo6GqnXUQSyEXBH334hjDbRFyyO3CpjOgy4gwyXWpMRl4i8l91ZakhFGohTYA5hXdHLC1ZzSA8m7iJm0qAbTGoCjMvBdRoi1jWLbbfl2dMQ2skEzP8DdkFKrDlup77nemFYQBWI3nJHqxbCIk5OMsxxMcACaouiFmmRz04W6+C0gfN5GM9S4pkc0pJq1qaMNVZ98EN7yEozGruVdUpWrdv+gHELMCRlhSgOyUvC8udSiU9ceUv8OD9pxTPRP2uKPqrb4Yxesqy3+49vZ39wWv/OGRJ5cBI7V0VHp+ifZOzShLrsUHhTRpF3+P0dfvGunXLrE6c6Do6c7/hfcCY4miUX/L+thTg0nDYH2PlSfw0kfX9jT9eAy2NbQw723q7l78spVDtyR5M5+Sa/iYvDu9orIeXKREzNcFkF/h7gJd9tw7LOqeRStPP2bJMhgTvu6yjWesNrLQ7842suHXC8lSXt5I4KpfnHn6BfBQN6nn3odRpqWJp+l5pa5WAz7EbSiHKPSkf2uvYOHAviXUA/uYGxZ5/waGFwGhRNvuM2+J+tHS/WJzDEyWpNRq9+CFEiqBvPiY20STUMFPM6ZJTGPVFVi3w/efPHaXz7hdwgeeXC9z7MmLXnaUVPWoVTksQFFVcNjYqRXAAZ7gC/OvqwGuzEqB1EBApJcxGIOKs7eBlqJKjDx4zKdxNMzls6WCLVb4k9h3Q7+URtQQ/49OehugQi17Al3w7h5U5rucUJq6UZKESJLjyIkF+cZtG1FKVrTZTnJZ/BYkDPFjOr5LDhqyMKx4AHEIHIamqOMi2dAW1DOTzV+viArRkh47jZPMk/c6HzZNUxGZ9WlnZ4pikJ1tl+juK1zxH/c1gQ+D8ALLfIJvhBD44QcZ2fw1EQxFuKWLqALMtzovfC1do1YAJiEaqZCNTW3WzLsnkqPWZXpoJogICXPUf0W1BLJ99gfBZQJA9IkiI+W8Hdpbz84YYq4qdopHFSgPZSWy8CCo4Ne3ysbqpBRmxtxdRnwxF+MyC45wH1uKT9UIzG71qDUrgfL6MAcj/+SlOiJL0eKxC2H8wmkfKLZ10nHmtonKImSx+RF1w5rqsysHbO4pjBLGeIyauvCF7obbDBJ4Ttl2xETyzjqVyfs+rZb386yBrw46iJFw0BTMrHcdRGUrBA63d/JNFVDbDW8W6buKUNE8PArTn+U0P4yqKJqMF2kVgeOlk194+NpTgwCMQ572XtL42E4Nc290qrY+8qE3KtYQSDbnF/xQu+VHpPq0o2icQhxOvws4cMumsIIm+Tq0K2I8SPkeVV0ilMxIgP1f34EYkoZFJ0UAKuajcsjxPn6nfGOX2NdQPWjf1TseMnO937RTSJxEC8Lu4nC/WQ/e6esOEf9oI5Gv/KkjHvw9y+01j1+8p/+KoGO27vU6MW4kQ/NK7qxztDHT/A3FPR/91/eFTozH7+CAooAdUXiYxgA0J16QjHrvEMPSAHBdBIrBM9m3W4pDOQrAvpIaLWM2ynqs8hE+ljFA5ER4BVX4BVQpMCRO43Zu3W0tUtB9qsVsx9q/mpz8xf//dGYv9gYN3/Bjama/8DbmAGMFzL6K94qI2fwXlBLzP/0b3nlC/XDIHsPyjfzYZoJGDXSReEmJmBGrY382slYG1E7FIolzgyFdszYofiSF/qCe1M8d1VuDajuLPABawXwoa5GlIBKUHcFbhhz9l3w3+qSINZrVf1V3EUR5aqGqsdaM9wJRUhsWEs+WkxD8wZAkKiKIECP3KBJYZxg6XUXLgVwCysaT5LJ00wjHrK+56SNhLzrlVKq70oNeETXiuNYCnmFMC8yeOhMy0xGiQDZbSHO1xy+yYG3BckfdDX/gkSA0HRNHK8l4hlU8/omL8NSCGD/mJoO/ENoQZ8cGXnAkZE3DT8iCPL+UTLiqxyi7ugJPlJ6koAACD35Uf6YwXLoR4dKT+rZB0ZsBhlyHqkOjDH8k33QTW68Hq1Mbv/rMbk/NDG5H6hObrw98sl9mCe3fBhkH348J/evP4LJrWNXndwPlJP7ci6zOolDc9001DHREcn5Hc8itPMJ7c8+IjlQmptE6VN55riJglIB39IRMgNkrfDNp76bI+hu+m2et4nfiIW1MZVNRCbjM88/yQkcnvQEnm5KqdrH0PYxOWEfUUz6rpDNKUalwK9WuWaKCfsCfuA1Oz+4QmOeR4pPBa7ra1i0qi/XcEIhNj24WvJsgbk6jVPPOPukCLjUUGIArU/i6XoAHl/KDfJUq867oB4fUgSmgNnRAzieTA68KG9YSoGdG0Qe+Lush5vB2P/V8RMdWNsQdjyA8jM8KVGTQvhbaBD/yXbzOkm46kUH8Hi2WM05kL1N4U+JXMzWax/ijTPTbjc31tXhTaoucFKUe2BDjBOLVEBnh/SO/IqzV2ZMs3+SbaO43UmKViURQo72kWExg5p2Fx3q0MyVPVSEDWcbxsa7nDgzHA6LFvLsKtoc3UIebgWUd6UGhkXdwAaPrjQO3D4Hmgf6XvbbghEhNTCTNKOR/Aik0FsZl69holLgzIR8E2uOhzWQB3zdsOZ3XvdvjTVffdXJYY0SryrWXGKX9X58AE/5fPUAdlLW0gnGKqZ69rvoZiediP8o4tMvBL7n7BccZuuFdXv/mFjg90BI9SliCXD/D4YCiDwiX9e5Opi1Wn8D9o/55W5/DTUyECJJyjbQi8KDxUrRjvay9yAG+Nc/GOFqlQQfCKHFjd1rXdX562IGpGsTQdJRHnnoDGCMteMP7B6G1MOXiBO5m1h7b0KH0b6bIr7ngYyI79/kr0maxh+93sYfHIlXN0M1lYzVcAmTe87dVzuXtyDvLu3fh0wJHhCgjD1cxl40LXK3i/xwGblzWmR32uetKZFljDa9zqNq0eamyC2eh+Ghx14ww1c3efxkQnIQzxie6xJA7xBeQ5Zg4mms/QWYrsC4In6R4l+BAXwZCgCjg2RO4aiXoJB+sMZnxef5V6OifsA+BQ9oTsZeuRj2Akr6n8asofiAXoWxdGVVXTDtPkCRSIxisaOXe+qd14rkkKZmO7GZIE8aJ2ynzjdrORXmcNF6j2uV0mW6ab+6hadfeb3Cg60o2bR8JyWgmM+mBE7VpHj+tCGVonzQ2uyvQaY0/yWSHzqu6vGAvMr0LAJpTZB9Xj/Y5V+dA6oNHjI0Aqid8Jf31MRuTqKFQECTaP2Q/SD4BQR3S/B+BM+S4I2eiHoQfAixJMGDiF1FUL2IdSX4IIILErwJGTIJHkIwQRC0xjCoBzADcX3xY5g6rlWhxuqSpg2cjG2UMYqfCeOdxcYvhdOx0aHddKwcxca4go2RxUZPsREjrtgYOWxkPAT26HgdQCaHgB5FUxGQx00U+j2Hc6EIMkucCwzOMcgU5yLFuQA4F5j7S5M4Z1apoFcEx8U5T3EuRPnHxzksHlWc86Q1XhXngm9snAsqOPd7jzPOPdErxYNAAuMbUl1FB9nvK0tgKIRue47/xbEpX/zhOcE2dgcTmlUVF6WKoHpktDF2ZPQ2d8iz4Y6M3lU5Mrp77Iv3uS/udl98pDwhSvTOs358z9jHH3Uf3+M+/jiCatsIJxpxGVJlBNVBIL12CMxCSPkahKRW9f2BUIZQu7zuNYPQTsOOnQV87hjFJd/YTUbc7IuKOZo9sB/nJfPq7HHhRfmiILNeJ5rfny/jdTcK7SK0C6EtIofCwi+Kd9Bvki1gRlsoovkXFz3q0cKL+LFwYP+BYhV1c8zifuYxix6/7ccGfZa6uNqznzpQSYADaMT2aIWWIevIV2i2H0J67+PhUyTyExXsK06IJ/h8Kx7n5tvwoHy7HglRX6CuziBW1rK/k/wNmgexyHvCuc4hDEWTNgcpocUDa9SC65N8gZb74aVQzINFcNEEQ2nFLIJSMJxDowuRXNyalTMbDBZPJfQiQpMjTldflUathXo4s56hBRxkcw202stbfcEt+ZirFm+sKlmB35giHz1P3Y5cTF4xWC/iovsQR+y7/Qdrhy667/xX5gV/Rnr2jAS0VkrP51wfGq4Py2qcHCwj9hAYevR+VSye5lsmGdF8B0OkY/QE+jzThPfs0Bb8iS+GPOMmNGgZ0OlSpgY6FsTOzDItANNW1rSnawX79/GzfCfhyYqJeqwkdq165K8hknY8/Hkv36FnSazlCfdzAKu6ZfSlGXnkDsxUx8NHDbga1/Ch3HbKw5/zHr7PnZcVszQrmU+lndUkVRBSP7p618Zqgy7q+M2hP7aJkVROUGJEN5hjzohbVjEMsarFEYozamcd3G7vkLg/cgdqhbnbGNAO1X4B73UNg+jF7MXivQV0pwrKr+zlxcgcUMdCeYrE5wM5eL4+q+3RNkzRZfVdms8JqgjcUtU5FBwqVoFF/ovyLYovPaE5zFTq2p0vmvuiY5Ts046S3e8o2X0Ipg7ZfKOOMPbxF9zHmqTqCEoGt4gClDnh/6WxE373oSbpCT+CaV+ahLNL48i4L9VIr6lj4owL92IFUFoBlsJOJxOBAwY/0XYpCPrc0AuiHrZ28xxYBEHASCa5TwtmpvvGvYgPG02+m+0rQK6eYTgQmVgUWtFz7odKoiQUSSc6XtWNlfrQjdAc5FRM84Hd0gFQ7B4oNrdK7kTWRmmjlFTMSv1asjBpfdAflAnQgI53QB08kFkM96z2sO6AgPPqDK8HAeOiUbanSMYoxjwP3P+EY4npClk7jEIWnpebp8Vz7O4z/Cnd2CJ0QzyeNXHDdNHQjUVKxulGJHTjVMITWrBKBcSr+nI+W6EGs5YI7BiZ6Zqc0Q46tYzNVBOvJ2SljosSPKA9RwOs0lSXtgDQ0FvfK3New7vNnO9oA2nO0QEJK33IMP0z6hgfJJUhcbAH/ez0O+xtyQwTFK7cWMy7sVgcG4uajkUixLaOP4Ws+pOfFyo2bYzyUyG8z2gBS+FiHjEQfWJknJ6XSz+VfIHqTlqhaISYKzh5aHaQIesmZoedI4qvci5fzBqILgBipxpo7hCo1cW0cwVS+cJUGPTGYFBnGFzDyPOo8HGRFvCnUEsEZj3gY0YJgwbzE8ViGadZsW4ygpGMAqFcV8YL8cu99iXDbXr7UuOXo5h7PlBTV9TIat5F8FbiC+7ugI0mD1F4HV/CIqMeaN3E1S12JhY7r2A47iYNX85hos2wdgEFLlCn6vVb7R20aZVmlEnSZVxp4ypoI2alck9d4o9LGsJTZyHvmU6BheNM4vmuKCDiQrZyVcuv6uGYzRAv/wB/i5WfaZxu2uzcM/xTCtxJaQaRM9SyuPG2Kv+kdgeAIIiW6WR5ooV+yJ84RmiLY4TiMTQCq2Ku/l+rpCgZY3rALuLv0p4IQ7B00RaKle2RXgr32OPPVikmoFQFW/4Lo8F/AwVjNNcXR8aU6DuGhixDA8ZZFcd3kN4rm+RpMPE0aVOepgfw9ez94Yw6m/A0AaOtqB4gbOzC0sokT5OgcMYGMxy0oBu3RQfo5c0BDbBmtCiYtEpdDgFyPd1RyNAtE1TEKswSiJVAZcVqa0eVVNgipURmaiE6QcAoBbzgHesUFW7RhGpRlRatEg+5ihMKYOYKYLVi2K1FvDB9UMAJs1WjraoursxW1zFbapPOMFuxYbbS6czWvGG2fmyM2ZJ3ZbY0KMwWgqkieJXZGvv4C+5jTVJmSz4WFal82TBbN48xW+5DTVJmC8G0L03CFu+AmWdSjTJby4ibZLYC7KbAbDUO6ExaRduloLwjBGVVma0OB2R3hjFZzH1a1bXcncbTghm1SWZrEZGL9m68ZbZ+7GSZLeTcnNmaPyGzpeMe6cnJ+zw8S94qgMmvDU8qr7BiUuMWBwvADZtOadu8LHaAeTFXtq9YmNiupXy7OM8e1WKX0Tz+Lu1Z6jVHC2oqtaOka0VI10I5zTifXjwyrFfgWC9+vM9jyPS9EfbLl21YhWopaZpkwmxsRrPChHF5GyhPVpO6ZcR0MprNGLacFUYscEuaEqplbS51HfGSsBK1edCseVq+1NxIXX6m8FmZA/u8A/vqKNiBtVx7psZnsGcmfvQqMFjRtdKwXauT5MufoFpMNKgzhWqp4vhxiRZYlirFghJtBYAsTckXVAnfaEEuV9lPnYcODTMlusqACj566I0DzBYHmPkJBhT4CObLsVLArlUpcwvNn4ABXQU3MY+t1okZUGCUY0ADZUCDTFHJMaBWWbbKgCajDCgIj2FAA2VAgS0LwJCFEkNAt6bBYIIBXaAUTPj8o5mTQBb8KdQWATPLgC5OY0BHZmWV/Qyq7GdQZT8Dw34mNGvm5clyoArHzTnQBXupZLHCgQYVDjQg2my6roLbXzWIqdOxBtR1EF/cfDoC1B1a0eloNjuL02ZdJvN0dNZFjG+zwDeZeb7OvGh05m2OOQtVLoGWpzHQMTVlCXBLn065ebP0xVj6uLnKSwsGLOsHC0L9VjfjpXlOmzYWOeVUXLkZKx1Ls8zSaFlptTZnPXK3NAuOYq3c/h/OjLt808QTs2R1K1kfeGOS9VvGRDU3yTu4B01S7uFmBO1ljLEvbndf3Om+eCuCVrJuhPhjH77NfahJKsQvPwyFyJbS61hF4dZQ2k6EklKi3ShF581SsJ6qHL6li3u7FLPPlIL5TimOz0oRvbrsRmiuKqSeVyH1gnyrMvYF1rVHJ6osCmWQGdPci4ragfKqsQ9d/QP7C0GMfI5S4iYcoBYtUxsZ10RmnfIrY9yB/XlLRdZ3yWbZF1ZRgjW9jqS2xtrK8+M6mRNbGxNf7RGxdYOF4nmXMprDhc0mpaBFGDb91Emsrcy6NyqzXpwms7arrZSTrzoR9lYuBcUW2ySfmHXt2gOCfMZ1bLvrWIoeuYuSPC7bIMCOpxpQy4WvySjGn/oPZtZ9Vpq/nVLuM1Fe8N8OEI0VqqkFlsaUwop8B3zLE8MIxTTLHd6ckWzjqZLtmgH3nJVs55Bs53pZrq2SbUBe7HHQDDVVcFWKqHF1lkpZdr7D3uXr6BjNUiH7+lmVn1hJ07ZRQfNW1CFLSG4EzbWqoLlHW/m/Hguat5rruFVBcy9FogiaI8j3fVrQOYDxLWbKEc636fg1ZPowbJFSe1HeeuQi5UchR94mDtYetRy5Rq0pcuR4TI48ByDMYdJBUppWhHeg6kAHUPWMAy2Vi9SEwUvztkw4Jz1uYkEpJ93cWtGmhiHXiFy1fvfnNpMeu+1Mu6Xej8dlx+iTNJpJxRzIA7eJ5qrbGR1q3c607RKc6A1NquOXd7M3ufmuOz/DNUq8co067LFMWzdNV900bY5N0xbFmKazm/BKwNHDnkHWgzZwtXleQSCNs/hjGUxNmjkjS2oTZG6FZCZicHCVWs/7KkIY0D87KVWcUFsD3UM5KpHBDAEdVBBlmA2G42nQXMk85XZKwWUS1Rz3lJtSx5mn0aLmAPs5auksnjHGVYRx0peDeCHzcjWHMw0Ld1WzB0qxHbZYOaemg/+Mg39rnEyK8KUpoNPzghlpSYVgKAlsCsTmxggJtWTTApzeSo3ylivNjQtctlYxDZgODqptDIxvBdti+BC9DKjkxaN5Pd0W8pI68rI8nbzMPnIhyqOQnCyjBzOPWnJSo9kpkpMZxE2QF701OrI5WxLy0lHysgTUVyahRlk5FDUnL7HkJZkkLxkieQIB7h2aOxl5SbvlOQKDnJsSmNnjEhgnL8EC1FJN0xYJi9A24pKumhQ00pJ81vHNFenRNiCsSEx09kHW2XRbhu3a0GmIn9EyNqqxsS+78igJUEyz+NPt2pKwDy3Qnm2wONIxN+o7uPte3azVRIRSED+x+dK253JxR8UHOoo1J0JplCKUnHZUSIlmysD9V0QobXAUc1BkVQFAm5qwlyKES3mGTKfZKi1hWBxhqTnCwuEZbS2tlBIUDWfIC9UM7PpmrARlRiUoSw7+2abwB8VH7WqIAtwa8WPOQcAITwUJsikkSQUo1UihRbOGFtUqVEhp0igRSsaIUEdpoJKiBsBXc+Br0Az2BADfEsC3RDPuUKrjEHPJIWastFRlKDNGhlJFzRUHmtkx0KwqamZKmvFXSuh82QNOl6HkusWNqYNt3awhzrxrmZ5Xd7sqlQPptrg5V5GhFMTYRnMVGUpuWRXdCVdACGIEXCkMHuWCL03gSLPEkan9nxvrf5P7/z8fPU8wqzyBwiwTiM1hSsYEhyiYDSgYKzi1xyflbiOTQZhELqPhTGQzGob4hKCU/jgxAJitIMtNe6iAtCoXUKtyAVMnq+MCLGJai3aNqZOxM2UyLlHDTMammXSdyUkXyyytRFInr2HSAddk4vk68WqjE29zrGnqlDNkacYtDYWv5KSl88udFbQoxdoHA1/Clwp51SNKTDBpy5wZkQa1ncBkK1dmGyXqaVtVYKJrEwQmbZAMMGOptsOYEPMr9jy1beWytOIO8FdJ+F6vshJRx65pQDS3Sxg5zo/cUXY2Ni5LtA0zYbtZpJYf5YzYTiv400NtLJkRZZgRddqmqnsw4DALMostbEP5Y50Rvlmm/MoyJVoWnZE1ipkKbFZ1dcL2dHJ1GtOywAj5lLqlqYT2kl2atlWWJr+C7T4KjrWFtFxqWWg4k7wrmA0rFDsynVYGyg0DVuxYiTQGzxFpHZrZzYdmRYcGkGtRE38KXiCJAPO4RHqJUmBuxl3vMBhWTkCkG74j0k64oCB1RNpqWlSJdDg23VYpVSKtEM3VhxSg1XTQmuj/VCK9DVoW2aPeuKX4U5i1ADEl0kvUmkakC38EKStk2q+Qab9Cpn0l0x3VsThpGg0AnphGr1KrSqP9Ko32iTbD2lQ918ejRK4G7DRCgxmlbKlSNowWxUo7lLKlx6FsyFbKcHpXbUbalMRaqYJvvasOSnXt/1nx3hKep925IOiqGQb4wdH9RfcCWYEiM+fOrXiI26k+OMgDrMtLXri69LwioGCYfVouI0FLG1ryv3a93kVO/x/Pm+JRKiDPepb1nnVhrcchX11ABXIJfUFCOJ3N0HCxvZTdo/dtnamKv/a9cNodVvxX3mPVC8B6mS9i2ymapBf8ipBjLzNxEWd5id4UDuDtR82+oancDHG/pg6R2K8itK1DzJ0AbSOeO+K3xaNQfeJc2jN+ubOP65VpsSayeS2h1oI26YUD/OgV88LbD/1zki8i5NP7EGqgBMNZvSXtYcSMxx/AMwScE304b0DZJ9Snn5eiQXLZDWm6Rwurxps6afZJvc/+/EdzYfxT7sK4q6K8L46XseviT5Va7PUoHcL9bJ1nP+c6/l3uySvuerdbh6x6uRuNMHe7v8vzp91JUJeMcrH+7Bq/8XyyfqpygEcPAuQO+B9PubfwB+2Gz+crgZ6zvJJ/X17a9hoEbhIIzh8KdDLchCeOLaR9RSgMjTtL/t4ivrD2WuSRGQbvq0c9MsgNPwAI3ejjF/5kgpeSZ/bcH/H0vA938BPhYjaAQu5eLAV6EaWm+Yjv4R8y0wh3OF9QNKQVB288pw8psW2mtrBxQXAYrYqpse+PX/En/3DsSx+48EoO/6i/66wz3kDPvOrFL2bO4MLaB3nAcN2zQY0Jd0p3v284kEr03/PBbnG2227Fvz++eEgNqgCiBwNqd5m+71RUCY01xwNFUvb7bZ52jJpvp/DthgrgC4Fvc43pHmbbbpJg9icYyDy012LhQblIKX0lQrskdO2v3TFEf6/Qspqy6DSZ/mWHQPpyUK+RYamfcFjuZnDXR8aEWhSZnr/n4uFQhyT7UzRuHR1/nsqoBu8oZVRHjcj7IyAlagjtFkmdfv/4ENJEmqWFWA9CrkApYmOzIoo2F3KnLeQ8/5gGq9bI7tYo4pz+x111UoUKz45KzZj2GFvytRPZp9FNsCcfweuG6K950B8useFWhgkySP6NosWXi/cJznzsY30xmjZT4le2dwhgDgeUbAxN3M69wytzcUfI7fnuvnSDQh1xnyJnAq7PUYeROsT4J/ipvfI9Jv0imIg7+1tWP/+Z81YulqyDT15/iMfHoTa54FW9Mv7wXnLBK3sP+TAKQd4lPbngW/u2Xva/dIkjnuz/kQJA7buwTMit9CqIL9HZu1cfe/SxW13G3Q8EhDAUz6D/2gCedDS8h4MPaBAXZr+gwbdh6blXw3I77NMavgvx92hYruJ+XMOfQPiYhj+F8Ec1fBg13a3hD3oGx1WFTqYFCEDe0MbpUn8IX5wlwXvlrq+ra2fZSiqbvuqa2EVQL9spr3ATispcfYlraijBTyqNa5RU7n8D1nJCjCbwkUegdxE5sSF8FogDcuLyOmJAD89mIqwLgtLqtcqQwzNVqpk+6GkmcTWn5NJsUgEAFtyrvxU0p4bttNSnAiznFA4cXFAuxP0keyMWtrymoKZG9hc3KkP042/gZU9js9uQRykfUl6LBfHNEmdis89oDobAD+tC2c+0ZEuOL8o+eeNYlr/wPP+VWLXF2gEFeonbPz+Qtfv8QDmI8BkXv7aIXk3RK6CrwK/XvfpaGMdEdPxqil+hxhT/Y+/8YBdJ+dUPPAo2/0Ad4SPHd7WZQFHwijxo6Ux+RcGxktJ7hndtHqTawN3Y10t2wgfhKzBPGI7Ke7yi4DSky0eSlN7q+R7fN5zilU6saJKnFlXU3yXvwnSdBAuc5P6mmf7sdWWmoOosLnDr4B0mGO4dwoSpSyh84vcre+nveY7TPcgsRGwKiUfYgXhTduAHed0pGuXKE09lCGIsX3gkuFFb7wM763hZfVZPP1XHvNgJuK8iLQ2f8VpIaLEYw/YMwsNQjlq75JZbzv2VnjdpKgsQM0xrdq/yVTBY9+caxGINY3zK8obn+7CtqD4tcUoj+Fdar/qMfgMmGJjmw5BFxXjVJZ7HhmMtu8fV/YWaPSAwH+hCdh8i2m5uUKCTAuNrJwUF6Z98AxuhlZjSYGfFLkc/RBE90CHsJTeG61ON0v6JH3jXNV45xUoQ1RTwNQW8dzoTyACPPYXYmP3/9Z6RXYddizU5+12IeEb4Gs21qwjxIG4gI9R39Yo6JmnE6XkiS1p2LTwdSgEJSSaUWTS5MP77//U4O+dDtXlTqlUTrNhNqyVEzoAXmKP8bhTNJVLzu/J2KskxqmtQs0xKvytvIanNngvV3RW4ATXyGChx87O/EpRC83NtPoCNz4toWhu/W3Vs8gCTSF98h4DnMf5X9zN2B6Q7U93WTAA6Tc+ufiZoYPZCht7g25p+y7k/EoY+9iDOejo5mqb4qocpWKudl9M80Cqw91EUToC5AUNIE1p2U2QYKM+wb38nk0iIzgJ/gWcXixsCqxzIHlAeG+8ZhRfW0HQfyzosz2VfRKopMrC6WNmXXGz29/J9ZN6+LG+BefsHeYvlMPNM5YCFUXTKUofvQjDEwnRZb6O08WunyLfvHeBL4Y9hk2LoyDBe7WZlcNFwKBGy/dCe6wrv2vyPSk3uwLwdDDArlckwcODoAHuFKwufcV8ZC98wCruFSKRObwqDUb+DoiNFVJoHFvWrmNDIdZkl0EGTQQFNiHRljMr2C2NsuqAxXNw6FkqvlKWgRZMbs4uGg/SXfZhww7DjToLFvgDIYTfKtepGuaYbZfjT9lLlYYVOqZbdCHIIQLJ/ArTk3cQTP6/Cx4AwTDUgHtIp8tYLb99DP/fFP3zO911+MbngVb193y//PnfxELzUiduFZpii3Xar8Pjb0bbuQt2e1TGs7FNcgczZ2Zp6l+TiQvlpnj86T32dp372Of0UcZpqJzx8zx7ReXsi42lHXwHjaX851Xja0PP8TSzE3emPmXFT79y3+0UgrcNiOfApcF5wNcOhaoabpmTYrelB9uZXuchdRk6jkVXi9wip2GseT/O4AXn22FuNHASlXdy/dnZxlYUcs4v7C75XP0mrkOEPWqOQyOOh4nGjskUAeaQzKAvxoZim4mfdmZT9/IgVSHfnQRqPlSFCva7ymAveL7gvQ4JVKVB5IeqFOUp80cKXEkrAOeq3Yu04VF/kMaDKlUgNCgk8kJZ9wVmZVH7Rq0oL/+YxSAv/dkJaGFalheFJSguvfqzSQm9UWhhaaeGNHrON1SUZ5Aqc/T0efo9ZK/qX7y0pLRNQFak7C/tlIPtn9Be1ioV9f8zCPnliY9/Hf7cNNTMa/nzfZ6EiN+MsWDuTXTVJ94oIfFhM8SuJQ3skdC2CVEbuMpG+EeJlD+qKCmBrxFfUzmh64aYU7JffMJ2ClRP2l6sTdkzauYAZiIMHUZ5WVsEwBLjdMg1hlP2CuTVMrAMUZP9iaeguLSHTEhZQAqnRW+h5lEKAhTVF4BAFCHf/0OhJAk4pAtddR3cFt8mEunofHjY0SAY8kb07q9V6hj5bj1iBOYJBpq9n2Un6XwLwd/61FSvutipDIGvGjif4jgBfc2kcvgOLH/Mm4MhB2aUm0EF8ZypIPxrEnr0s4DbGu/cXkSV+ivdF7GRuatkVKHNgY6CogXYcKOoqhaP/NvCfcVVVCSFRxzvqgcRuyXAdSpE7K9keawWw8aKi+XYcXGWveI9scqgO84cH9ktklyNTSoe8AWpRy7lU6LG0EJq76xTzT/YwUMDOxeug20MRDBimt5aR39uuZkByVrRGkgkVEVfD+hCxHuPE4D+wGcbWhaGaWJ//6uymAhE9s4tYxmXtdY0IeSLYWoxFxoOXnWv9X7uJ6RXiVcqjQNKkH73eyXk0XsU8oI52u/qZOAzYRCHG0h1G2KF0/iQOHWXCdjgAg6sm/AYewrK6HE+g/VaPmDOHIKAqU4goUrngFRwYcGqE1OzuN2j7Dx3ylbjCzuaNqDRGHAMKJyL8UsPrQykKquOwREtRcTdiQYUf9CnaxLji/b7aVn+Z5rzaWFxHYzzYRht1o3HQ03QYS5P8l/ODIG2Vx1597NHHbn58iPPsMk/ST56nPZQr2gZV/idQi0FqDj80illWDQ6Y72z0PRX9qkh838eeet33v2XwjxfbPcjevUNoWGjnlf3UahQFNFq3X96+C2/a/Zkf/p/PfLoeuPjklzFXuhscuhdboQhr6e0A6+2BbsFMyW6vEMseDNE3eUaRCKzDFUWMx1VFXRSxQMw0BGLGj9w7LkFLLUFL1cgBBZJLJs8IOeQJXvk61q89+7VHdaPIg7mnBWAixkZZNoKxU5LRyD6r3aBIDaSZ2M+UsfdWYu+XWAXsB/UsG1luDGRCaIJy0QiXcq03t+OQKWUdVPOV1hptkeQNGHPj9WfvNUVTs1Kz/0AAruersgRDaSra97GP4t8XLh5y6keQitXqPXcMhZK53dmPf/LU+9NzZp8+HKicFTlgOTW6ssfPevY1wYQZ6LNlB1+PcAQwIp2p00ZATS5/A115VwCqy293Y1IxXDCpms+4/fPXH737tV9581cZoe8MaAYknX9qkCTmCT721zgztGFn8qx/94NMfUThDAV/TRo+m12PmrVo+Mea08M40JF5rNFzsIRXLKgTlwUkhM56PaOYakvr9kFSi2pMiiponmYoJTToXYy9r0KFpnmoUirsSMOLOeOfKtHOzKEnz+qJRz6gSQZ/IhnVGeFw1ZADt4h8bbb/gjWxfFGnRWphU5qa4hcEANTieKT0dBuf9VuXtdHpuwLWqZMb321MBP1IZaJFBxicCLvZRiUiXolpXhxwzQFWs7jIybEYtyuLWawiGEEOxMaEirmSmKjkr038d2WPOvx6ZF/37H3f+S95A+V3DzDh+UcenXVHSUQc0MHJ5Z2BzJZ59HqePBw8eJRdhrKVzW3xYya7AXCVzrU5DVglRYSQti+hZ+gr2NRhvqw6g6a7mR6n2O5mI91deATd5XExnhxtnyOgOzekqPe4/74cTPsi/qGacsNJ39PNg97emyGfYp0NeZdmYQjRP4DL4hkDiTMLlPgD4BpPC7SRbzbz2mowmKf7jfgYdzl9B+LEwrdYsSDevXcACfgtiN4ovUZWxUm9Iw8F/fCl2KzOw48xVb8dSJo0fpW6dxjBxpd4lejSFupSlzmbAVx/YptXdtUIm2umX/3DL8epdh6m+GYdXaEQAs2lPHR+DqMhLa+/+aEY2SQ94wd/YSQiP8d0yMd1jZ28kGSvRu+xLhM1qY5o1J29Rmf56VCNMJMXabvzuhTpn2WrqzvxgMzmkUipBcrQptxEbqjh5Syc93FhHYmvyVvSt9RmFhibqE/Q0LDU9fI1wRqRUB2POs9lgmfagZo3UZfMTfWKgXeSRhD51EF3X4t+MbFkAEBygrRV/HT3Y0MoBrVTne4eLQDDF+Qefp6JpRJMRyAs0zigOfps6KAc0KDriek6iA4w/FrrtpobocCZoTrOQetO3sI9num3FEt19UHM6Guqr4dkXBq62IBEPT99S+j8Whx1BtKdWXNSs+ZdfVvQt5Za/ZbBfp1SAnnhFpobzGojWPAOLCKKizGcIuaEQlyCbnCI5PQ3hrOSJiyjBujguXpqvVvVYM4q924XIaQmnHXa6/WYRHxS1WUhyV6vMzLg2jinihMCmGx+AxIkHrgtFayiUW/z8XunHIlpM8/K6ygeQVaDyFRWGIsWW53C7CYUhGLj/s0m6o2ISvUTKbT7LBVmiHgu0lPsULrCY6Xt+WFpjwiFQvfdfrMFQHQkQEUEmp3hp6WtFNZIAVRzAFLAoQZUGJKvFf0IKnIJGnm4jOy6yB/VyIojqp/1vdjix253KhdSABlGiFO0pNQhA054DF/80H6+xJvdc4ORJfSlmTiV42Sc//30G8pbUDuL2Aim0JC4KkqU+/mV5NVqsm5m6/0DMoEwp18goYbAKFb80L00qeEjjxrKRGJQsPJeYz2TefAW/bJr1sYO3mM1LizkAbOSuYUGNnHZz7xBB2936SILInGnR1grxX6qSoimkhEDCrZ6sCbF/VL57ZgAUgzKFMYzHrKzjmLpJUVkFmIAwdvs46v1YyMV6yCABhnpmcZk7zQj4FUkkq7xRhrJUAKkJqWR2bvwedmoR9qi7Ffw+YlsBr/7DZOadF/2Qkg38Gd0Ov3sF3Wbo5bD9WCVM08/VMXE5UzKtlbiQbjceZc/9WNc8grB02C1U2cqQBhqgK2S4GCQ1ylGWpmQ2YRYEdEDhIZwTTA8kvs4GeTQIIcDp1Cc+SkFqFEdc4txEAzZZ6KgyWd29emqrdpn67uCuw77qsbmkdr6kpUyVNUJ1upW61/mXFepTR6hzih7k7BD9enF1h5psS9BsX5ZbGILbWihcn+3If4rUhal5C08kqKt7jflkm+K7BEydxhJ3Ba0TTPDdVwCuTWfUeNnGSXK10GInc/hwf7ztbFqoEestRUBZjw3Df6ItevolIY84s/Fa+ICzZHkzBdNfxfENm0Ri9Q5EF8WcEGJvalZ5cQJKC2uOW1NyIFIZCTufSCbN7gNJT5pXxdPhlJcQm0k67DrCiBw9ADEyN7/TwHiVFTU3Ug0zEgEGBUZiQayNTQbRcJYaQvR+pAnZB4LvLS7/SvEXxE0Ulp4qGI+dhHo5kAmMgJFW3fjCbY5AT9MaldTW5KqhQdapiNl5FNSnjYpL+JOgKievrnuJVNcwepJd7bZ0QFAYLEqVqyCzKGETKyQUcdaApkYkIlVxCA4r04J7ZTft3c9+5uK99cn7XV8esmIF1iMxD8pqjgA/u9PD4Hx0KXu2brU7dO3vfq2xzYzcs3kIlaVbIYcwJH0fYdfdUjFdVBclQUw+zHDKnyktib5spsRoasn6fIYG9YRUZcw96h2UEL5Hk0NRUgoLyQvO/VlJwnzkSnHAEyVhdr4GtzN1e0xdf64NCJhPqGILPCQIMe0MMf4E8iQ/aRM9IbEYuUf8UmrrkY5NvsZsKZqgWXVusfVU58iFSSlUH3mlDmoqWrrYoI+VKF+KO0zJ1P8xS2OGc2EeSoxAX3eKEd0PfsFM8I64rrmcwF3SJU691wpWCysxR8leEZ0z7JSObPrB5yM0Vpj3JejaTmwiXgg1JEvUFFz+s9pe2oMIZYP8sRko6Tyrd9S3ERG3DTw5IVDKYRjutdQkPBD+XyAhqGrMWqvHzGhifmKyaMAW9UxvVURS1DLxd6msc51KtXSDU8UR/CH/oxepKgutkpMA+sqCUKUupF3q8ZAUMlqveyLZ10cS+jBvvf9fCdQgC2cn4XL8xErBAmzGfOZpX8Rx6D0wFYSm9swxsAAH7x71/V3G5Fy2L8fgimAROZkqBiJA6DfRK/1+gQwTF3Lpe+O4gYvvIFR3rcuNULrzAfopdtJmAsNRd9aLzVT5LxAYx3DzSxq5jMtP9VNkLmYnGK16MjqkFFmxBGZ0C3EzVJW3fBncoEvw4Z/HfaB+p1r8nkBYAOwmu93nmWq8VIRlFBIc27zrvV2FJ5uC98iz23c6xilGTwgpKwDTIl1Ot0UMqN5imoM+pQybSSfGgKO7M2yJ5IwzZslNZD11KJPU9EHxjUNTlz99FKlhryza3M9uNWnDrwZN4lt0O1+Yd6lBSxPs3pA3cS6DKmfrk+3AoQDlShu4WOojpEdsF54ZkomFsUsDYcMVeIc93ScDg/N63pGy2DYihWTssCC9hUutSQWAxPc+3z23c5q36966aUv+PApFz0NjtxnQUjmYSlxXq7bMRp0MchdIKNeLydPYNQaGZZFMyYL2e0yBnNmyP/24iEoCeOxXk1jFgaGHPNExAIiEXAyg8NheWyU/uojugd11H/hxEUoiQzdTShs5kXPxCOPw1cjYu0Ed6M+dus7Y3M1CgyXuxr1UU7guM999NbAXYz6qde7i1GPpFJ3VQqE7i0oBaQcz8kLTRBJqMrN2KWmAfLX0mdDgcATt1u6XodanSfhvnTO+F4sdTl1V2NVtnw7IrX0HV6gdGPff/6+T32q+5cv+X9zZBs919/35Yc//rK/OvUrF0Neqpwvc7aoRDY0YKPAYOuurMamfWHWjHeSSjrl5jFH++hivQOphHrRxizxS2ZMtxyRYHYCTgw6xAMXJO/5bWnyi6vKQqMn9XpFG/xJHiKGF32wKT55HMK9BQxt4fd3E/9d1lOGwAyLEGm9s3dEpQxO+edFokOhdh4eDZwCMlvbQiim9JRDyVA1+6SnLvgIdY1+aLpPzMmt/s4X8gSCh7K/+OKe57Y9oIiZaCSpiuP/LDjuZf+CJ3nZQ4KlY6j4sKLiDfBfGEyesVsl2+kcMZZGiJr07DFRR4ShHgAr1xUbxFZuNCy9jdbV+LVcm5ZRbpg9nh6UIHNTjtNISqMGZKUduNzD/ot/zkJFCXsU41VNZHG6f9e634AXFem01KFYqBNFEV15VqkS3wJtJNRV7i4Vj9eZbnV2QRKJEOK6GjoX7EtdqlJWVas6q2ihqtQuA223DExZc3ysOcN8hlRmiXL3cpPad4gBJdUNlJ3qrThcG1AD750hNWWtmRldDLAUKE9ibTC2MFXVpX0Cap5UhwGr28T5fy39rOc1N9MxWxjVMdtZOh4GDnJZFpFUIyZW/kv1DfJEiVfD6Z/he/FB3MQRqaig/RaXwzP1L764seoU0ASFc/BfET5siAuCuJS9Qj6rumSK5M4ZseL6dGfEF6neFkCBRvBBiBH8vBhxRzusViCqXqFMI0wtbLpgTOlRf6yG3tIbH2dlQvXADXpXVSX86uuPr0r4I36Ai6HxNGmYu126xoXzLRU69LO6rRDYIiX82SJWaXtdhKFWbK1ji2qRK+7vPCBOSUWWHWVfM5JsLoi/mD3uFzfLFwffoF9oRN4YzZjH8nXe1ALntMCmGHZs8NfX269d1KsQVbLwupZhEjxCKr25btpbT6Sb9hyuaFSp3l6tBn0eAkRmnUc8BJ2S6Fd4Hp8sW5D+nV9dLxzF1nN7bHzdFrVWioZH9/BgfSNsD6EoDeFGrDcQLD6MpksqQPYIKwFZ7qyZD34WH4hAE1xhdqe+glLHBLfPulHDLE/AoC0Q/2T7CWZC9KhEM5u1hOeVGvRENomLZUzwCItQN/BKAfAdTtrloh70SnTjKse2yM4hfpIKf+HRnXsMClkSjjd8faav9ww3i71yFv+0m8WewHtsFh9+3BuTQfTFIWv+BLK2Kl35uRPQlWt4G9DPRMLkFT4Esh7qxkIDtBCuvP9Efu3vzr1+gBMrFao/V3UE1c0m7zg4hMycYsxa8DKfe/wIDuQh+HqN9tOfDcLEaAhOuSWkm25AblMGBhJC3YJDIB7gjRWczLGALxLEZ9zIpe2WkhgIqJ+3nrlnRD2+fEIRGAoI6nQHE19tT1uy/6WzyOhHv6hAInZZqZHB98VIo502RsUwsefpCkyq68d5pOivtmWuA030NsSMR8Dv/qXqnBlHT8J3pRasG0ZhYAtvL5vrRSt78xu5Ue/eg7mhXf55HVpqZT86NQlAZ+SUWosYzbfuVyPDR3BiHR2qU6LzpyJvPdHZyy+gCnf28rjS5N94/Qlo8h8FkDa9HNyvE9+tFdOs/NbFRFZMeKoXFOjYhzqA4F4f6uD3wU6RqERKJJOi/RTxGRykJiIDUlkkUQTmIIYVJ3x2Y6Z3yMTRUtsYHocWFT861BQJVsyJEOHZM4EOflKK1UpLpoxgpLb+Z/Bjo9RjS4wRiq0BmlS0GUpDNA1Eqsa54d+KiN/qaJ/KJyM5yepYHiFv61g6Idus4GcHFCWFlm8+m6q+zRy1wbbmGXZna4VsF4yO6Swc4O17svz7e74/M9T2ZnDGk0knTIz4IOJG2JhYbPJSqup8AUYjMKOR3h7VS8VhfobXAlzdPLFNLxp4bereyrIjeMNA3NspUjzv6xQVI4FHLxJbleWNRnF6N7Pvbz9/9IIdv3Ph3n2/tvHG+IGlPTZwvjlO6vTDZ/WI2cJn9QY8milGIFXLrDRTFla53pW3Re54sENJGVluH9DYrFcw98+gbEiuJuENbkds+z9i2n/3SPsPP31q+xd/8Vv//IcWaO++7/mRD//Dru9ZtIHZR9F+tBDt36zd/H2jf5jlIurinksu0h5kUYI4qUhaWKHJyzNuKIJHgzxL0U+CHUc85qH9g/02RIqZyBXdiQlFqrFt8RFah+XLlb2J+xF3PX1YJqsMcMB7qQFXwfv5WJiVv1YxJXCO2nhmQ86CQJdLn6E5Jqil8G5A85Sss6COZgXfOCNGCYF9L/yNr/7yy7/EOrV8p+2/P5rrKZ9/vbue4sRL7n4K3sYuqLyQOQTdhlRV8gX4IlTZz+KuF+qHQfYFlG9YBhRRtevj62rPsXrJWe5NJvoI8UCrnlxehwmzv0FhU+/A6E2zza7BfNb3guk3s0Vu/ndTec0I5UcjDG3kGNpokqF16ZIKgvFIqgDADTubPVAyswBv9kV9VdrpO2YWu1fsDpnaO0Y20oxByciC3VExSIg4VUjBQ/g5Ue+fYGSx2X0QzaJAj0OQXQ9x/VFGtnIBvc9DNXrfaN3u3hVfvOytgm4yvrqDxsNqdSSP5v7SXSd/gy0YucHmb3KDzR+/wQabNg+O3mB72+urN9gMwx0rwx2B5Z52jY1PXOL9IheOhSbhjLJyjS083jW2mHxzVU2nitxmS/QR6gOY9PbXH+8a2y/qaPyi54f2EExxSjEtltMrdToR4MHtUNsekTLVajlZOITG96EHgFlyqYZaVNcNk1wcz96h814rwHc61qG8os0sPwMEwlIk3UnlpQitZW17P/wSHH/t0eHmsXvoH8zxV6ScOBZ1aShaoR3I3onahb5EDtXSvWafjH1v9ssqxiQUVd5KFXgrZ2/JneCRtDBJ33/yuNYtJVm/8Imf/0RtCq4hj0qrHLr9PPIy/vDjDIdt7xnBNrePolh3V4Jy3c1Qrv+CF0K94+uLeL92XMR7L1IffzmVeiaA6YfqfvL9J9hP/uEpTXDmK9f5fGsoePnMdcHLo+tKd+zHnNMY6Y116HL7LztTUlN4+Aj3ayRLjRB+6B0u/AVnLUpKUa4yj/uKEkbeBcTtQvMPxuUhrmZrii9lZyFQuKEmn0o0mcrDCKnqsV2Tz1CCHE1qEP/xRqCFDODcWvs1c+Yyz1ICBrxFKRJSlaPO2dveomOkd1OksWhBq/QiMQukyfDT1KPXPr9CbmQP8NplWoq0NtJUEYIl96LkcyP6bYvsH5a3Oe47fmqYCNkHdIF0scYBTL/OzZUvVOUdbqHl3AbybBj+FtUl6Y76lmcQzUKf+EDRFAZlgRssF9pLb+W2NJxMN+XbsMiQVesUFyntA9hOcSyPB4MNVUFEji2sdTxjT0db2DipSFydfVb7gL5ZvYuGTD65YbJgfDAuyiESsGFJfMx4Yjk3wxhBix5XDeDGJqFsP+JWOEMPrpmCvTpg8jlhvKbjZAiz3Hii0YTxUD+YBtBFTZu5VX3pbUVr820O2ttLg58ZbaVUQY0PoOuuJA3T09imZkzNcIDED2AxS7EBYOTIcLrWljwzBDvsPdUEX6aWZGsRPKTCFc52Sq1CK2/iVlGyOilKqImfto4l3GeYTa04NM9JnrU8V4VNcSvhrP46FzUR5WOWUzG/JE9EVE3CoFir4MYZ6QyK5g4wENEq3eCKUpszU7rNXenIoM3AOKOGdLdwyN2byDnrKgv1ubM65VBg8e6H58XBWVN70eLhnglUR0rIA/kHKFvD3l5Bg+bBEPa0wddeFfTwZz0idt9DES0Z27FFjsicI7m38EZu43cifqdmXrCRpyDyFMms0OGxmdUBAubB9RpxOqd8ThMRkxPK0hgCLDDgs+rpXjx0qIVczVl+S2RLs9+CqWRwzIide5n7Mea5uoaVuERd12rcMsRXy9Z3oIoelIacCkti3hrAehqgK6FdLvL0MvIMF3lmGXmWCMvys7k153B1T+BReQKP3S4l7obzrmNK7cYjKZ4o1jnyJTlpAFl6Eg4lhQ7mW9EnuF6EHfJ8iTiGxO3Xk6WYprHWczbI+xbWGKItEFHOSzeflMc6+ek0hssuY9Y5xkjMAMMFeQGwcM29qnCoJTgFTrwkzLA5j6p6tHKAiZL6l0J4kaPm1xDaxh8EL0ZoO4d8CS1zyJMQboN1xSZ7l7YLZuZteVnWl0xe5vSlIy+L+pLSVn7Zpi++vCzoy6qAR+mbjzqB4kVL5ndEq9pVvBCleJklvFKRU0uegk9AplkiiizKdgiFUE4RI1dxihg7pgI2wIkm54+gb3Eufp4iWQdecR7ntUW36Ckk355CEv1ZrSQzlejnO9VrYHGKVKIV75C4u7jYkdJ2kGTaSYi2pbV1fuXSCes+tMi1tHMRRxJ3lKuqlFbjVMkU0U5XmqAVk5RQiSNhxaIuJkrXuKDVK6qx9bm8xdmSB1Y+mT09zPhezU8VMc9nFT86H4i5hx+8SF7AxV7I+Lnd4OfpXMkZBj+3P0b8vFCx7sISP+c4ao/gZ49DF0hoC4fOl9B8ibNJibONEmefys3bJji7jRKLmXhpWMzEy1P1xceLReBV2sovPX3pyssWfYnlZV5fFvBiZ8BiBZvjCWxerGJzFy92HVvAS1tedirSZwbPTzF4vgMYcC4hDzGWzsrzPEReZFEhMzOgeBqjVo7A0+188BVVT6EdMh+QjoBk2lnODoe4EZ1HT+HA5FwRRMTP8WfKzpGZkmr159JF1ZkiGZ9GT5fJN22m4IsdkzOlozPlFNMHM1N26iQgbb6ZKTQyU3SKUE50gpmyDZNim50p2zFTttOFiGSkw0wJUkyMgB1k4wHvCvOYFbjVt4VnxYKZFWdygWeZWbHwyGdFVp0VW5RSY3XQWcHoyBittHqL0G+l1b6E5jADdM4Ymf8SxRa1M7xY1O7IyzZHqGNL3H15WXbTIbb0vFvB8+4EnvtVPF+t4nkqeG5JN80aFJ+poLgdLlyOzUlRbYysK76eh2TB0U+9879cXP3DsAMxdtK5gsAXV/+KizhR0FCrE6x5CtnYKWYYzLSxWKPof4pF/x0jCHueknbg7dhCUSsnnaL/FIS961EjbCw6/hZhF4BFC7QFkerbuOUDYcF9bzc+8OlJIIsWubYxIoZ5jqeQoEUgzir8yhsSzCs5YwVCcUla4QbWF8Ty7WrelpeuxbKt/BJbLMPLqsGyCvp0JtAnraJPJugzSQwnF323gloipqRDR28UshwdnRxk1d2ohew27AK3WX/72zXySXQ2PflFBf/gVt4r19QzwpPoyQDSihS1lNdoN3YXu+mJ+MgwmKmIyOjUNXqCLiy62rb5Su8Bhlhb9sPU5jQ4fBJeqWv0z9vT/Hio9HbJbKUyqHNPZioulhPKjFqos6gZQGM/XzTNPOWppkNAOe4/+pjBeGGsp5oOASEvWa5JJjhPyRl5Cpl/Gv9YLxs7lINhxod02iFN/U2TWap46lyEwHlIUj8aT6Gn6Q5trxahL8QvnFtfMi1BBhhjzQG6GMXkWszVmq6Zd4/vo3XTJDggFNi962YJjlCj6mbauYNpGy5K/CO7PWhgN+AcalY8mFYuaapHQeO/tKv7mlD2NV3sazA3nkDn2D3QORIHCYLxhPEoLZP90usfoR+D3ZWjmLvw8dfBeUG/YiYwEZNSQpL8/rXY+Y/a5CMfopeKsUAfQtoX2BJwAoKHCJURDhHmrXEpzrSKi2TOQUKkiPlQ2KtWS1voO0pB0ogwOP1WyKUzey2D/IozCq0JBUhIhZvWfl1AQUUPO0z/KPLaFbGoO53yDfQFU3i8eQ2+4hojJzV3PqAFWN5Rxk0saWH2oGrJ6uWtrl4UyfStpW+hkVobAaEuAUZ9lpKJe0a5Z8+53I0jNfItGjSZ2MNRjWZnb35ggufs5VtnhY+1pmEu/vh8dzBvwpEXyFkC3ZcW1fkqCCKgAMA7ftVYxd7ZVxx2Zq+4uRCneXq+qwofKcSOHEud/nU/AIu3MHo8cncL2B8yyYU46MWmIR5qUA8lekREQfa2VyMF4jqJV+eCot4HIR12paom4dkz2tpRG2AiyjXDII29Omw9iTWMVEJw1dq4CAATpPkiwc1QZST3atDIFo/vmmhK+AqHoKxby0+0/IM+cuDorshQOsRG1OF2yBLRIV/4ARTbUqmRVu5zwL+0B3yFGa+8blR6kQppsdGSAsjczSp7USuUi1qaaCP75FRzFvnHHdWwJwqZ3Vunxfb3CMVQ+jLFTjkORcVm9q+C5lRVbr9zU7Ogq84q6FecVdCsYvNzwZn8HDXk2aqRNulRE9b3TRDWbvVIvTtxor53msnHgj+7msnp2qO2+6hHT1VCi5YYQvtzJ3+W5Y+cm4abnJt64+emMM3w0Oi56YM3VE+y9PxGTq/CfyO7n1+54XjnVn+JVNZsDh7JTaTWlItIrZF7SBD6vkQvBLWu5rcT3UH6JB8LelMvIX0CKRTquaG7hnS0eg1p8zpP3ltT/yUvhFj+8ffZ9KGpV5xQV/bB10/ecPqwHiQ+b9KWsN8HmVReoWQUoGmoI12d62AY8sB8QUHV0PCjmu6/PjHdW5Xpjpfj8FEfefR8lOLF6PRu2en9vVVjHo8FREVogCQ+CHK/5LP61UF4hJyaQvtnfT8YscAZTFriDzbRsQ0yteDjZx9VCFpWTm1oSGsgcf+4XAPCfAn1bqSzcuXz2zqv1InaLiC7ZpMnS6uWH2QfQ/mkSdnv4UX14RbGbEHXjI8lc4+zciWogC3cTmk0Fy9FrIYM67h4AueeXTHFwu2PrJ+73aOLqbv26xbTiViA0aDNU6YvprKSirIV1sbfGV9RN9d4/asTaLxi3XS1f0d5nyUprJrPxr4ffeaP3JNfn5TmCO79IHkYBKdrh+EAJMuY7OOgwQy59C9OdC/h2L/GvYRjj/Rewh+M3kv4w4l7CQcz7ECn3kE4WnuUdxA+N+0OAqrCbvMb5i7C729+F+HfTrXrj75BVbs+flwNm0/owvhOtXHgba7edWZwYvWuo51Sv6smevdq2qWOOKvfdc/jp9+F60v9oxmWnzuMjteNXxnT8eLEESUvDmV/cmIlrz9+FEpej4oH+ORjkaV86puylMdLlvLTvl+5tkPT7L1pSeAGJhaZLtUkIfszVVOF6OVoB72A8ya1nXi3vGOSZJ/CV7iNBD7lHo6veJBlt2nHOhUD5n0SOaNXqoAMDCPylYuHFZvJkd6UyQNbCdSDETM0tUWSwLWh6wOK1t3HgwsQ7bnFNPfcdcTq7txXhkInWYWhyKfF6sw0utWM3hkyVeO+V6YR2y1X92nOFQUm4J8r0Lry8hl9IRKDl3BQJTQNrx5e77OvB0O8fta8pj/jBerwx8HT73vODItaKRRZzgRQX7B33QLwcyhPABhsTMunoC9i44SGVeohd6mAMzRXifofklmCkRi4z+9In8B9Ltuk41WJ0PorrE76sGcs0QdyocRsnCqd1IswluhI7SO95nSspuiPRh1mzaJIWzkSF1c/cnI+TF1vijXXD8K95JGiMcj+UmDWpJBA+m0ErHJB6RBGF6jOvrYAmzqjmpMhKS2zIiTZurKpG/WzosBLD/uxLlabXLXryzTQrQCmmNLrftTn8rJPiCQhvCC4vLxFDN34KZbzquby6pV4taKIwxWxKEaByuYZ88Q8DzT9sHDq/TQ4arCAUv5VQwyoW2Emn+qVa2YUV+6txLogxANuKuAw6q1m9D7bmx4dRJJ+UoXIQf8xgiQASCIBSX1zkNQfO0jQ1hPB5Cf9yMHkZCGS9rMRiKSPEiKhgUgIiNQBERVRG4jAsKEFSNhvbgqQGAAJRwESVu5mYTPIjYQlEGH3AZj0RID56jSqeJThUZIYab4PWLubmuAGj2T3G+4t0tBgCqXDwhHIREXjEmMwbKMIh3jP1otR31u2iobtOF2Oyqoex0BX1yXqSBENK5u+Ozh+iDV56AoZL67Gxa0PMLhKWNfTyz2v2nV/b2X1JW+gzV0vOMz1eRN+aHTN175AquGLejqcHnqmp74jjEPxBi+AQIgLDJ1nZy3QtKuTVmBS7SO/cSu+S/594mJywSvFT7yB6vBxEKvc5fk+owXV5M6ojyffIPVlkyR2YvHHCuVcBYy4YqB9mIVUO+5inAxjUTUmGqNFrEjF3/uXtc3RhldJh3KTu7Yn1n48UxCjM2M/v8s3oo2CYp6jF3wp5oXzFOVlYWupwsrqXbRyW4ABV8ioexk7OSnM/tZa/fXFihqeYCIBFWUMjF8xT1I8TXEuyRx/DHb+RC7JlDP+nO95r9TNJZ3nE0J8VJzh/FnDaq0bYbH2sktDO2GvUEJnwcCNhHbDSqHQsF362KmPs/BAmqe7H/way95wCXPQzwPdWN/kg6k+3z/IT3xxyNeCD3NLD2uY88DNmYQ5HXlQOtLxRJo+EX+6f7OUPXUP9FatjLNo5bfzE5+8zT+f/yTMcTZ+F+c/j/80fCeH7/RBqCWvr99rxW/VJ9I9cLgbPuyUp7fDR6zby4a6l40wVoHZPeuNpVBZJQpkLHErTkw8SjLFCEUkgv/sS9Wta1BuXQO86uYFW1f+r7p1DYxt0ilXkw7Ouq1r2B98Zcw6nw4eWoEGZ18ud63hZrvWv38Uu9b/8069fXEyO92lFtowKjD8hZ/Hv7+2jsbuvxjSmktx0Jqh6M12c0FlNyeWnjw177nCn39aXv9IT4BkD3coI3+qsPnBDmALXrGmQvMbYbOBnw+yZT/w0CMGmkE+3CrgU90tv0zuisSsYBB1qkQJRju155ToNgFpYTWtXlmd6xUrMxRM7OsGE/u6abGKtmYP98TjnLwCf7MHxwXFb/U8b/rZK2BT5Vs0FpCaEvuFqbH3VmK/UsYec7FqHVRiPzKZ17Uyq5Hr6KM+z73hDePCnZ3VA56dEwc8+094Q/p7XiifBdmNb3iM96OrgqRXv+FRCJJ+7t9Cyjp4w6SUVSfDv9FB8JE3HE+8OlRb7z980Qycjc3xXqQl1wejl6f87vEVQr/crxVRHkNg2RLHSHUtQy8RHjv+JUI46TpqLhEifFclPNAwziWklBQeNFh7nV6cN1yw6YLIcCyB6rDYysrb/DT2XQGYbj6DB6ndjbPyDNmiNWTBeTDeQvuGNmRYUYtZ6uwXBKBZc0Fxbn8xT/MYatkh5QsU2TuHizSLHBF1iP9YvWUeGZZg/3O/Zl52mbs0iwuK8zSHhC2UgXnNV6wR7L70n/0t0Twspgl+doELy/iZw6gtrfX51dxLXET0Qpm2BWkLSOOiWkBgvZe4gVJtkQQXRnYDdxdvy3pcUAdl1PuDBqs7///Zu47wtpXu+tu/KVN+/CmLKAQpljug2Jvci/xs0a+/1GX2S9lp/rJJV3qWXmapXXrvve7Sk7dL7733njl37gADE7Jo+XXrFWHuEBgQM+dMuQeXg0rRx6atZP3ep/5+IZXp3H7cRkwiLc4ohfdf8RAx1XVC/+BKbV91aJPCB8jd1pd0P7lnHsyURAX9YPl4OHeRKoRj+sMwPA+177NIsH+PA/upxwF8fbw+xXOhkHoSIFng7aJM1B7/rDwRLyc8ChGypw82ZC+iCj4O8Qauz+cECNoxIXsBKfL4NE+n8TOuVWYe/lyk9kM0ApbJXX4DMmIeo7wicVFwKvCP0ft4SVw7Ci+qAR8/oYamKvjnaCpocSroOTTuWNn/nwv8e8nD//nHM//z92ekMi7uA3h8TpEG7kfmR2kqmCdWFoTaogB5AUXMhIh8YNin6htu1GY/jdwL9aPWoY2MMA50spF7o5eoK5F7BpTKp9H/+GqMJpWnqGgcePopGMVU4ydQE5hfe9GaU/IBzXifdxmg7qM4WKzBuRBXEZMzpgoeLh5Qgwpmcwq2h/o58bTwsOKsFskHM2ra5Px//kHO2TO0pgDlAmamVJrmwY0G+jr959/OUJFmSM90Wt9PmyiS5uajIdJD/gj/xcW09k2/AUDbBizSJP0YdQsc8ZNv71MV541pRvPkqfYIOQPcRHIgZKgCebrjZPB4hNDlAO3aXZTe0h91EZDbpQKyFNyQikI0amiDM8+hb9mhLWcSNeKaEcCZr81Ndl4DLg4wdo/SHwUKFhdhe9b24PPxqIADoEaAmvmRICDgPMcMdg0YkIwlCfht03l1aXEGAYHqir7hFQOmgeniVQEo+e0NddXEkPLvBl3TR/xu0HVexqgbGpXI+esNdRPvOHAvpm7pMisSMXpL3dDn3aJrGAFvc0kViSq8ij6ZEFVYRncU6MP6FylFt6hM9HBxoF85VE391fq6kBbdUD26qRpJfxWTBlODgCSAmJu8izzQTXKEnYXFjt38ybxdWqKWqnLAY0/VdIlfoTQFVYVC5VENpZvtq7g7GFAlSWOwriAVD8nj4wxoAQGMLgjg2gwKNHkkFxCO57x11q8V47FGEw2Xcc+ojyf4MzXnno93BbKGZFPia+fE2f8g2e6duIgBX/37xXjOdzK3H5vM8/E0U+SY+KQBTY8qcsbM4qv/vhgPTJETZA5N5vl4lilySDgJVzpFVoC+Cnk4eGgX4NWHC8ZfwNeCkFlEM1cp5GNINT7W7EvtZYlyoABRDk0cmtQjta+B0VjsYFTs48w+UTZe8HYaL8iQ20S8IGPtDmNt82Gs6aPHA4KpoRj7Om+fkVgwMET4+YaGYUfDsK5h2M/CsH8yGPaIVI2UhmNbNaijmlRXLcARD68qVFIeNVSggRpRC3fLQDFyIBok6aED3RkVzJgWzwW2Y7TaRLA7pYCPu8h8OQvkARWRe5dmNETiXgprfz+u2nOAqyJNaRcJQN8CtwjgAqhjRr5gcBnyjCL8mVnAjx0oVWnGSBfcWyhV0+9wl+7pXLn694VaE3qZiZQH+CpNDIdmNM0vUjiUBfycR4F8wFdXAXyAQ0ARDpGFfwj4hwL/FO44lqjBxwY1+dikFh9b1APIe5YORD6Aq3BQ1MahTR0cOlSnO/sarn2Qo08buG6DNm2I4FWECO7h8Ba6YABdKbqhU0UM0KqNNNhAKOsWEe1pJtRBCk5taAQvNCc2NSfunJwT9CQnNlWo+VDTXChRRzVoQzXpjvCiSqEq5HDDx2B9BDc8hxs+FUy3TZ7wInJ4YRvUFxwMyUBa8g3LEnwzuIHpb/v0z/nzL/mhv7pnj+h10d0W7dwGszV71ERjiMRFLtogcUI2d5YzKgwZkIRSE5oNLV04134/2qWhocvcBaI8zlhgbZjCJ84y40UW1hVMfZZhLdB9GrolxK8KdFcF3dKpnxDlm0T4WYo2KeCyDqtOHVgd2oC1QXdg3dFgJ4B9gcsXtGfDC69ipdDREGN4K+Vgu8nY7jw0a6i2RnRPI7pvJhsCTGpo2BbVEEd0rDyH6CG8WlU1/ELqm3kEHl4VnLlE4M4lMH9wO20B41zAOHZxJl2w24LDpDuVppP+N9NmM5Ixv7hqm6GVImkln2vfX3Eo7hFh8G2S4paD1aI+rD41UHqD2rigTR1zwU26Src/L9Z/bDAiFmc36TaVH6oyT39vqAJdQzDiNbqOi+wclP3eRWV+PA7T5CNWqd8DtReJQ5t4bBMHazz+qz5mcXSFdh491BAwzd7gmcJVCM5kvNTN101/pBvwBvX4xNB8GSPUo7usUQFoKhP7EEqy5Ir0ZWj30Kx1KrqXs61PZb1WlOYvUE3PfbSxp4baKGmusDGDvwopBgaOYzOaVWXU9vnIQy7GOTy0ZjXAgZ5hbodsXIXHx2cY0zCcY6hGYmo+O8BnEzJjvx7WbCmwfg2WvsBYPwPLjoxHjuY8HY5xEhoguTGs3+dfSl/TYwA/9DndG3N7R8arYtYq+NDDh7E4GrBMYbxy5oAzZ87icMYUoCLSWAbq/9TQkCxdDUlspE9DXG87qUBDXhX04SxYwAs2zCp7cBsY10A1ac8zKjQekvOaOMZpwEvsiB0EHg9tCIWyVFUVACMZ3fQtUQx56Js8WfNLjOU2VY2HAsXiFmtm8Rcl/gdP1woVpHh5NPEpHFt86ts5b3w7AsSAkLrIL68HVEQnYe6df9Jny0l7FBg5xTOVlPUEUYh1sfYQqCo7o15SkalX6cstsR7EDe5sELSPy/UWvy8xyxr5LCtlWFYDu2zLrMKyksuy2gvHMoukDxXLGsIywnjReEBNthdkeBBK82okq1qGeFUhnr8i8WTnaGFGFTisJsQLmXg+inWI569OvPziT048LznJWyKeLSByCoikAM9+5lwXyXVRSti4wi1ClWXm1ixzQ/6RkHU4z5mieKSG8JbJ+hmJa7JgPusjMMCDV6tXOuXxC8Vjpi6wIew9HTaPGTYrqwybF1SUIV+fT6oww7i2VfMlahrx8wxYqDdibaBXTSazTX1HnsuY+XVJZI4S+egFCjyRp8IDnnGjhcrSFQZUo1A7rfH6Kewq/LhUEw+2zY2kdgKIAY/AWW+fIm2wX99U+Nk9I3kFaOMqeSYbj4Fn1T5rcXZ7/PzSpqKFNGCYB2wuimxcWkQaHHLfilADN1x8wReyaIFv9iiBEhkkoYakgMumiovqii7kMn1KXTJVfM44nqFCauVMV7EV3XZ+5lDdT1+kGBnXPN+fha6Ir0F90Dn8lXtD0ISWhcM2y5n4Q+YtIrpPo8M06M/joD8qmF0K1ZZ5LYkC8Jq2nE0NRq5WIBC22FmT1wv+end1PfjgwrIe/LXff6we/M+OBvzHTvqdVA/mUqA7HEBsMHqwJC+kyeSEj40k/M57Ign/9aqS8O8XjSSMXreJynnXJOEDKwmfSsIHHzVJ+J08SfjgVBJ+wSXhA5GE0044NklN3qdIwu+cVBL+64+IJCyu3KMl4UquplDEiCGScOWEkvDjZ5CEHz+XJHyYJwkfPpck/D15kvD3vK+SsGjBogyfSsIfSkn48Qkl4cfPJQkf5knCh88lCX9PniT8PaeS8AsuCT/+cEjCj08qCR/mScKHp5LwqST8gknCa++yJIwlV5BuTvA+ScJwT+c7ueGszndyW9d16uT+nrQUVFvGyX3w7E7u309vjObIkYQPvtL6FrFo+doz+2bFAtMD4MTdrc5wBHgFWaTNT4j5tewAfyznDZzz9AcDOW8lnzjcGa4fHIsuUMP4wcEQFWVU4zVHNT5I3d+wnuL+lh8etD5LoFwzU9zT53APUDPP+312Be+3lG6dDii9cmzp1r2b1HyyzVdgbpVmUaoH8+ObARwd2vurB0eWZpZiq+tIHxGKnVKsIRRLJWPYgK+VjA9SyRjWkmS8Eut88MIHL3IV47N5ivHqrMsvPZd1cSWHd4CxMC+i9ISI3HzLSFfwdaj53gm+p0Q9JWqqCQs9X9xBsbLKoHhytXdtWe09+4Tau3aU2ns2q/bCzlF7zy6rvWcTtfcsyua6XFZ7Ofs9U3tP1d7/NNG/Rf3/S/rnukpa5dU/s/ilG/q4pv/Pqr3ry2rvjxyv9n7L96cK7zc56W9E2qi9KEUkBav22uSFNCknPJvam/OlNtGR45eLkPh9m/g1m/gZm/gemzi0icc2cXAu0YoriVZcEa1Yy74++aIVrwEnifwbUiWrFYNZEBfJf2BOjtKTa4a8Pnn4oC5a8VaiFXMFQh70k21NayAPC8YepKcq9OBItOKQiZV8VsdnwbJWfIhSbZGL74DFGiwrsOm2pqwGq4YRk1VTl5+cZH7JpAGK1E0B+n48aJstW1SV2RBaxbakfBZWpR8pPUTHwOJt9cldTm1p2O+Hrz0XRwTR19zTpzoFD9Hj6lze5dTnW3l2l1OMAKpgdS0fvzTkY1YiXZX7DMkup9QUHh3on/lqOVq5Hnfa8k4SGWiCd0o/JzrAWN+5iobr0Ba/YhTXIYpVqPoAuV19Sg/6k6uRy5DMELtIOB6niA+MIj5gRXyY1vYoEcerNHDFcc8VxxuyyylEYujj+iD6OCqYWwC9c8DnhGgdo4+HFJPPp/k67Wt9PKIRle0up5196qNkuDAginv4EyS7nIbyVnuNdzkd8xGyMSrACJWeo4yH5JltTqGwYsOaVBkHzUR8HWc+Im5kjMeejMehPj11NdmdjaKMMj5MlfEq9o+EMt6EBrmdUcYxjPZFGTcUhKcY25xO8dXlMXyZnzBpNdm4MFHGjTWjQCrLM7p3XKOpeaB4TG0rck+cXUhxgkrUbyKb3En3JQUgz6FIvNdAfR5nC+k7BDP9PXM18bEuQv/5KxbBkZ7z7qgwUTrtmI8mSE+SjVPjoq33fE0c1ZKegYoFfPi5u/vkAyRxAR5l2nE2TEXOmCbZDVM9O99BN1Kyq4yeHaD7cKeZvBjSeCxroow0folazpjY5LoSxIk07oOI6FtCSONNnuP9OLRwIAgZvs2QFVjapRDQlorjazxQXU7HrCtp7tU091qaez3NvSFJoLVH57X+fcbsRam/3m0rpDP4VMGMQ2rXCum/sBHfwVH/IPvLRkhXIqT/2oa6CyH9kC8coFL1/11d5kApfd6A7qDvuMcleSKk72LA2oKQvqXHNxZmtumuKsls+7Ly6ApXm08lNH6YbPaHFnP2/rNzYRx8+3qm3RGzi1ttUxe7/G0zZpEmnbWxj9QQ07ZHSDUwY+TUCHM1TsX6q3T0V1DUSVf3MEbGiNiIjVFlg4xRp4E2hsYos9E2Rh/VI11z2c5SY5/7qqIRoEI2xlQnJi9Miifk83Fud2Gr0ZiKxoCch0JoQkXs5bVjhZapBjqNl4nJVIz38Gdhzl2L7zs7vPm0IL52h+47O7xFchdz+dwKMDt8F3PrqclcixeZ4qbEJ81p4RQXGFLjS4PyVqacmOL2kDk2mWvx3CmuABZrG12KUxyQpTR7hHgYgKkDsnaoa8hawry9RNvI3KatrOJ+L1XcGZuvQHF/Bdh8VR/0mP+aLvZ1DdGGQPSq8uiaQLTxnBB93QDv9QSisc56lSG6rVOvcWpLp17h1EYC20oC2zcS2L6pv96QYTukigUnjDcsOGG8acEJIxZwQj6jbWN02NgyRomNDWO0YVgSkAPo0hKgyQV0B4YdltswAjbmBveRQH1HoD4FAvYoYGNBNT7eR+ZbFgqRkCB+m+Y0QeLTLCXKBqw7NGVK4HMk+KS5SxAL3SLdp8WRu7aO8efpZJlnyFI399+jtzJk4TPfpk9jAuaTZY+my2SpGrLsyFNYsswND8bmAYQsY5cswhK8QnAMWYbgxdCSpQGyNOh1ZGrcWQV+Fwr8Bg5Q4DdADKyEtzQx2kKM67rAG0KM9rMT46JLjC3TX2OMMMTQiNSgNj32lvTiI8COUzFIYGgDuZNJULLojmBYdFfZGKbddYkawggYFt19NkgY4UC9swT1sgv1vgt1hkJgO3CqCcpDB+W2uQJMhsiALdu5W8jex+e5G7ei3QGNOe3lbNz6lv6Qkcj3M7BZkM0tLqNeqCOwEQbsWAZMM5C9z/27IDczXBQS4gkDciB7eGLIirYrkG0DR227KfeG1dF3saJomFc1iO6ib7TwGvLOrRMcuR8iQKdPpGFt4NYhogYDqpT0r22zCCJFZTuqB2x0LM4G2ihZnMHoC84cAFWXAFR3ARQxgJZ7xOXBPx1HbUfGvYc0X7ZmdXZxtZqVxYvU7BAr2yERMokaJvMu7dK9z4v1H3fn1rt0D5XU5aKUKtAdLJju0Mu4yE4qs8q4Zz0jBUkcFngMVoRFNt2mS6J6o+b7PFrvQvUeGBmgZFRvmalJE+BG4unHdrCobTgOiL0hZYgw0g7iKsS6X9qhQHXbKGNtVE2jkJoY/3/Axhxe/mzjmC6dh7R4QSEf7yMTIwCcQxD10SrgkR2vpuazX8NnIAWPZQviYW5hPvsZfLZHGPRQSWkp9kUBfYGxDmBZask8bZnYpgsYm8J/P70xv4Ag/gJvnxWrwwKSccAO/4nUWMjeBHF7Ar9OiBf7/blD58wxZ87TZSAAiHQRaSz49H+o2Ey8UUATXGc0IE9wWTPe2TaVLM9C0WuwLtanwv9jvhQLYIGMRjUjgRGeRDzrElCV8dvXtKFqMhTJQl4cwT2KgOw0ILBgFnQ1wxcu3Vvy24uf4LjSbZ3a6kz99qG5VZpFFBq/vW8e/wm/fdX67SPWM16Cm8SZA1uyPIj7LGb3qUSDVMxW1M9nTjnDnCq+L9izCnPKLnOqp8z54JnTF+Zog6j/gEoighlwV4VMGp+qniFTJGQKViNTALgHFu4RABhZMokIFqBUh0zB6mTKLz2XTLG3TCdBqIyj6Qk1cvJTosUemBuSt8y4uquU1WldAk/llW7hGw2WNeo+ETRqH84jKr0g/DvlHyjnSs8v8BDmrTKEXVC1DKGIT/KYNUZ6LskSIJWeO+jn7GQRK0DYRGZu2heJoE+BSM916lvpGXVflt4ppDpVHek5Yk9xXZy/NreWwkqkZ3+fakvSM8Qxhh5F5Fvp2U66i+6k277IIzpCx9kyX5Tjm1iV2yWEJzjHDUV6dvfMtyjJas+3rGv7ti7lltaebzrac3iE9txKtecmvu7q2rOfrz23qOloz35We56J9hyCwjRztOdmxs8OvS32ntSev333UzbS+FNfeU7rzp/UuvMZ1p1XiDP+6+OV59921OZfctI/kSrPXEoaRnxcnPGj9zXOeO24OOO1NM4Y6fw447W8OGNUgcQZQ1t9l+KM30GpXORT44xFOmYds2l0zBYETKd3aMs3JiOZKSXBybEEJ3fS4ORtKEKiY4R42p4EJKPb6HNAMnIHRi67wKEayiZFJ33+MOUmtczqtiYhyS2q5Ycks+p6sqjk7lOikhtJVHJ55ajksUQlT46PSp4cHZU8fp6o5BqsGrVzopKnkK36We11CoeH6F+MYc2HAQvN1IMPZ6ojlGd4CnkiCFwBO3EqiD4uP0I0whdy9YJ2M9qmCtTXikwmqEOSnJjAXPta3DYV7CtxRLjQExE2thfsoA7SC86lFzD9Mao8EZ08ykNZJgR5jPQ4iU6ewJyYj3aQ3lk5Onm4HJ1cI6mDMQIun/qwc9wu/+mMOluhwKqzAa1jKGPflIlbLmNGUjZZXYiz3by45UuZuOXpsXHL00zcMuxni1u+nPb6V9Lcq2nutTT3epp7w4lxrh8lzf7EqtJs+wlplntQ1ZAYZ8SHNFRbn9dwpdmKK81uQprF8KGI40jvqk4izVboCleaZxSdIPHno7lS9/5S+GxG9+rhVhvUg8K1wTMmpFscGoVUlzUupAascSHVRDfOKczkYp7cxTQwi1qfjaYxqjDS5S6MljFq1NBG1xhlGFYSWEf1LEmznqyt1lO9akw1o1cFIs16WWk2cr2zsubISrPFePZUaXaIPyPr8t9zXLgejWhmpNm9J+Uh7wlptpiRZmfWAT/KFDez0uzIKc7Pk2aLVpodOtLs+VWk2Yq7HJLXLGNQNaaeoWoH89pOGu/5VGl2AWl2AWxqxQ4K1Cu62Fc1RAeJNFuhawLRwXNC9FUDvFcTiPZ11n2G6IZOvcKpTZ1acIoS2KoEtq8lsH0dP1/CsO2SsuCE8ZoFJ4zXLThh9AWc1NCGCLAxG5tWp4VBxtiGYUnQcgDdWQJ0ywV0zIAWvWqbElVibnBfFajvCNRnQMBQ3AcjivjIiv0bFgpVK82+aR0Gb2WkWY92aJYvzQpBXGl2j0ZPlWaPIcvcJYthrwdBPEMWPvNNo9cO88kypNkyWcI8abaYJ82eX0XnyiNLF7zoWrIMQJYBvYpMjbuMNEtWmiUQQ+kiNjUxtq00i2hFIcb2sxPjokuMTdNfY4wwxNCIJMUkGOgUcaoJ2HGqDxIY2ohY06aORXcVhkV3yEY37a47NLCMgNG0jIDREkY4UI+XoF52ob7uQp2h4NsOnCJBeeCgPFU5E2l2lO3cLWT3VpBmhznS7BuuNDs0sBnRG0+VZmdHSbMIiHYhu8f9O5DrDhd50mweZA9PDFmRHQSy28DRNm0ic5MoI80OjDTborvoGy28uiLNdkWabQE669RiaRbpWGcNGFCdpH/dFmm2TWU7qvtsxBZnjVSnDdlYF5w5AAqXAFRzAVRlAC33iDmDv3+UNDtbSZrNr1mRZqVmu5iNdqmFTF0hx0izqKQeF9VeSZpdLWiZxdoWQpQdsRZtsZ6KtRKz1THLWZm7SaM84fIOJR4rFWujrGhecV3eNdtMY22EaCZHrPWXXN7SXKaT50EuHonrew+ZGBNsSBbayXV546o0JGtsRrcR7SGB8UlCsjCyiMs7LcWGZOkLjHVw/tld3smN05CsIgI02Kl76EZnictbgrOct8BTl7dEZHnP5/L2xeUdAakVQWpEFRPx1KH4/Y08rn8kI49L8Ks4s2JLlgfxOou169ShRirWtmk9nznlDHNCEYuiVZhTdpkTnjLng2fOujBHGy1af0Cd9z2guP7xDSi+YF/1X8dXWhe+UWNZrF2nVhJQ3Cq9IPw75R8o54q1L/AQVln9xzNSQrXSOOGWEWs7sihI5ZgY/ZydLGJNCJtaZra6LprCuhMnvP7hjROOYciqx4q12Thh4PxosVZQcpxYu0Kg8NupWDt9VwKF36bpSQKFpxm/e36gsEKd/z977wEnV3XdAb82b97MbHmLdqVFK+zzXhSyaqulqRm0O2IBdQlhGew0bHDCbyXnB24prLTCJkY2ciI7rlifGY2S4EaC88OfhQsSjovclbhh0uROPjdwmsDI/s7/nHtn3uyOKqKPYPbed24/99xz//fc+951ywe+9/AiVrLxTbirmoNxbbTem15a47p6W7snt7UnATcF938H8RvkPmi/PHM04Ud2cMc6cpcYbnyLhLsIcDWgVFpi737XG5uRJW6uxoX4nKdX/p3R1DMJPXIljd47H5Xe7jpHuec/0qv844VejMvR4bhwOD6u6Sd96tVYSgfTInNDtVzH3KY+kuiI14sUnmbjIZtInTZ1SMN6S79z1MvFe3F/PMcOsveFtzEx0oul3/0mQ6xdCr791sZLwZVd9pJs/PH0pmwvfiOiaoCGCkfrt2eXyhlOB8JprO0587FRxNeL7uP3oMNL5OGV2TrDUaWg9EvP9TJNy5umSfkQAFxTHb85c493u/EEaYTcI5u7O8/JJVw37MznOEqEjQ7UJ/4HfLm6MVxCUY1TKAhbZJ2jmUR/YUQQ1jNy4r/Eo+5MR5TTlTBXgyIIY4hRx3/6N5EzinGBmmrkUOWUO3FwBcpDtAC0CKwM4ARpiN4O9QJvF+ni8jh3dgyjTfwTVJDCJGIAI9GTiF3KCcMhptzyEuXrPX+r6/qW+ZSVK2m2D5HRm9hBWuD1qhx1s+OJjMVSf5+wP82OawVfBdqH0cJFXSBs8Q7wRQZC4tru5xCylbnrqbh3fWeze9fDZce+fj3YlIabEp+rFoqAc2Zh5vr14FjXr4fkmSvW5Q57CBDiiROIg7D4Lce8fv2tev36ba4MP29YBSivMhjZUZjnkqHcuYbIJoAvB1/If+K3Iw8RbEnNTj5+h453k50oLzzm5RH1y1/S7lMeBPCfKZ0leeCyIzOswTv2XMEaq3zIUf2e5sufeISv2Ed2eUQIRAqPXrl3oSJy378U6+jV/sOcJ+HwDRT/O6XnXJJMrQJCZJFRaYUmhfhIZaPSyyWDpurdUT7KaA0gszpncEF/JQVhxIEYkIspFV2HBw8PqcuZ1wosDUopUqP4bRmFkrqiV+Fvq+tQTtDplA/fxOyJf32T9Guq86XIdnbCRMnK0AbFG52s4pWZ7s/QQSyPqByY775MR1EksyhoMfmGRhSsUN/MhEeszOe5csI0PGAmZhMvbxGw6/9RGjLgIe5IJmzqS7lbV6BcqJBLk5BRQek6W3lfZnvFnwH8gS7RcrUBwuwGgenw+6r4PBlnovgiqB2JJqOqsbtLl6GNsbIMuAERA8S3JSED+Iy240op50AyEl6ioPS9rvwUPmnm8c8fj26MjJpKwyTPzdwWyAmzqDZ1+Yv92LCZHVewF0ZmoYaV4q9jTkp8coDQRstjN0Czk6btZaZ6WQ57PnpWOeyBwwE47FGgHPYMh7XImVwWW8xD8jbj6xf3S0FFJp4/Kl0Zs6gxhWMzxjekI5CTBM3HoygFXunioBq7jp5XACDv5F9sZlTEWcTpKY7fa0ZrCeM3BhBXPdm1wEOs//ZHMRtdmJ6BMyyhKW2KUZ+cpcc/IL6Awvh2ycvX74x4o+AHu5hJPG6TaP1A5TgqP8gZd9EZm00ju5n0r0w6o5yz7e5h0kGQzPNUfv505nkaRj0WgzU0rRNWF9cUq8S9yZmZEBwA518fdg9QvT60B9+3UhHFO4vlAHA7Smeg2kyCZd59ZXqWwnA0DDtaGHDV+FtShRk0zTaV/AoHnlndk/p6e01X7SKA6Wg/ypGPLQV0lqB9D/u7JmvDm717UDLvyGF25EGIKWVF36YkZ5nYRYZ/LheXuDSdenEYxbxPdwbCyDWNrlxYlblaao6Ogjx4o6azOrnSmSUJ+VVpNIoJyEN+Xm0z8Qy0RO4teZ60FwYcOH3CSTnGO11Ou09XnnJ9n0/snFXemoS2VOrTocDGkiJKkuNJZ8GP00VEdKTt9Qc+/4rB3//+kHU5wKr7RRdbF0eekhr5H60LMoE8zGugR/ZZVw8/kYRcPf2ldx/8pHXrIa+63h9405l7Pm5dDUlTSqVmtqxD+6xr6qXawLqSGRGHkfmHvL++aPu9//no+z5pXUn66Q/f/cn3/ixZal1OKvQ7N+zatm7rW++1rqXv7PnimRX30aXWtfQ/vvy+qZvve9E+61r66o349zdD1gVd28TGfkonVXLsG199yZJv/+Ai60omP941500//MFL7rWuzXzLrz585ffO+txS61r6N156H1du9j7rWvrfHo67urpuGrKupa+Qyn1mn3VBt4zn/nXNwLVuOvPI2iYWLDryTTf9zSMb0rObBP4WnY2zcgnNPPIVLtEzdC+TJSGDIxvMRRwYk6NGQFO2cyBjPqNEqWbTJH45xrAM4AQU4qPHYblDNgT6RPH20XSMpek6NktGLehg6qei6FyZmvUe2VmiMJLZOr7mlNXWNs8fxt0I5QLHGKDZNE/Oec4vuxh6sF2qpscpY4/P5toRi1tG+CAqD0HeNpckVgGyxuC7CIT0PE0rVlAcHPfkU3CeHpIlQ8gxIQ3MmCVMT/K16czBQzAi9azt4CwYRZgpMjmcRe0JwwHQQ+FJ2KCvSjRAvWh86tUmLOBx8uQrgx3mEUZaej7yRZ6sXpDfXM6HjYbzYFibR10rDIun1dbBESbVAz55nHFcwQyP8KmN4V+fGN7TGH5oYnh3Y/hPGsKZNmWBp11il/Vt0s/gN7lQyHhw8VvVB8tQ1ejh7uGqzLV7K0oYfvlwRdRyJ+Srk2KwTcSFFDPUFtylHv5Th+lO/IDU5XnNqAD2gl6BdSev2cjFApkpo/EuXQzXl5yjrtfckoG2WqtF3ZTBqKVmuHgERF3s9AvCVdA3l/w667J2DY6Qqenf+747Ho6547JKSnxy58joc/EzTEyCkV2vcbZf+P2FW5PcyG3vxr/3DwEj+8MSH6t9XdBU02jky1/Cv2j4GhyjDOMPIiQpkE+Rzu3x298MSoQVU6WG/Si8LX43AnaPvO61K6771G9eeFF1j0algArcf7srFO6xa9dr+lj0Q1OZh4eqaWhyOjx0jUF9ucd8RpCQYA/MmZkWyaMin/L3BC3vzZjoohNsYDXNNzYvorBKgW1llXzKZxu527bv4mGuPIWVk6p//ZA2t8Qd1WXUJg94m1xsvGAlKL8/Shnyps4mS1mRen17jdnyTJZ9d++eJBBQ55HPQ10WFfF7UEVZ1vHDW/SBvRTcxpG8FX2ntjDcc7ILwxfUFoZR6po166byn9ywiWM9AWvEJZOMc1iGHM8MKla5HafTMIRC2e/Gd9QsQOXBrGXofcexDP2fx7VBflKo8okZ571mVbtjyUGaI9hlmLpGqPyoq8sQh4l8njMEtLr2c34Bdk8CVQYu+Vgi+zLBcB3qpuicwbpu41cAs6nV7mwkGSaRTPJAjfKTStVcJiUPkJw98YeN2cCXDlYu1hu/Cdav13CDfeKfMW7BOv6YGrfi299o7LZBEtQq07z5TWsQf+UWkaZbXI9vb9xKnrzp4ZM3y4+RqNlAyVrAg4V+zI4PgDPB5O3D5K2+/oVev4bOxLI1Y/H2e9XpV+LM0lddNzpB2+DgK6xt8Jsf+MZsDI33q7XMmAh1HcQa2doKNY0PKYEdLhJz4Tc4LXP/A9/4QI8YC/PxBxoshSrLYD+LsjH0xR+0chwkePxQxobnNdjwJg3nU1NAd05SQIOb6woIDxMU0CYeRzIcdQzZ4UwuO1AJm8rrXyHJ/PjvkLcd5A5MuxGb7UBQu5wvDVIbpiumDnUCdRqtYH9/IlYws0uEXmtUaIPH3yXS3kBfJPzIzoRdorsQjqxOYpdoPdTjXU13iZZpRTDXms0S0PsbMR6CezPBM7LBpXOQRZYjppNcG4cpuiFkLKrHVefN6yvqfMHRCqvv5zQrsYxkdpZx0SkfsUNJpciNPwqC2l2NkEvpMINwTpPEfH9QYk2+1R13+QfX519uq31ls7zTZcO9mWx85NdWDspW4+NNNQ85p7lZvpOGxE6U5i/vSyIKYKKW58IdsN0Ul91A+S1JiZ1wS9ImPIPothPSJh1w4qQTTm8S4wC1cDFc6G932S0t9LfBbVvo/wk7+YX+9epcp8SrNc5VmmS9Pi3XsGGNuUjDBpXYr1FIib0ahWfJZZDamM1Y+nrXLCD1sfSMLekUDuHfRn5VkzqICd3LYuLfFX1p94vbHUl30BklTROPpT1b0qlMnYo0VCB5jPmRU3B8aqcepvKu9tjWMXBo1MxMRfZwQe4Yl9N9BYTGnN9Vg76aXNFAXyb2F4rEwB40jSnvR0dh3velNpj4oTSVGtWpAQEoTNOm+tir/JjIKXoNfzgV+9C15W134zVQ013xx8243ukaxZnFPW6jmggs7jnbqefiIHOTG/KXbc3P3npC0T4n0d5+v9v1fL7MuDjuwQB8Y06kN+BLjQs3hvzsbfG25sYbXjneP3/yK8c77r7ZvnIsw2sbnvU9Yg2Ssbcd3pIO1UX6qeBts0eTiN397BbwPKv+hrErXt3SS9rqge31wA4N7KwHxvXALg08ox44pR7YrYE99cCp9cBpGthbDzyzHjhdA/vqgTPqgWdp4PPQpDlqWn4+/PPUT/DPUn9i4sC4kJo48P8GA5LuhBEDPpz7m7zES86W/scLY/p6EF6HA4eZpTfD0dlGevm3RuHOTWdRP1sVea6bzVqD+I/wpTAaf0Inq1oW6Rx4JZt0LrQu5EU6iNzNIiz9+JvMs/knA+aVptmylwHNNL/86tEO33MdtwRqbzILzlw5jD0fy3lKBimHYXUOArZ5yblwb/aS85qezT4fh7dmUZ7gqVjPTuvZNoscqxBFxaUXLBv/87F0AR4c0X3pQqEsogW06Io+DrmAFuLH/guIn67oSxbTebAxLaEBTrSscyx5AZ1r15Iz9le4Cy6kwfqRkXP27GHSRTS/vh4DYam1ELMBCovs3Q05DC0TgJssWuYkC+zOgmHfHFTzgjvSYQyEC5YB5Ha+PlkIunNPOjhy7s8fe/efvu6BoSrnUwY1Si6gQX5YRoM0COrF5iOZebqY2zbrzrF7jnRP5KaYXdPz6fyaKWpbof5Kd0FOpQ3QAPfN7bCjZF+SUfGkWdDdA0ylIboIL1RwDppZOtLknr1LOGCyTTq9FPEv0xehZWYDZ/Dv+58YH1voR0p1GqmOjgoaGKURumyySTtdjsIe5orQCHyTTM7pCmt+O5/KHJGWMSPaLGeta1jTVvnUj3+1avndi60L4n9xrekyjpFwYw9+7L7uRz70niHrJueXI/PVgIOwIYlNkEbAbFQrOd/y811q9Xs+CR8vpKV0mUZqU1n69pB1rZEXfQZWkjBuRNrQnEXN2Ulg2vlcF8MiiACyqzFkFkyxs2hYTLELTF8PY+rktSIXo+NkY1/CYbP8/XP4eRHxj0fOIhnd6Up58/g8PMyUOcZJVwlpNQvYmpqArZE7Xs81XbkG0rRWjacjtCoZMDK8WuVsvphNma/bcmCs4SUNUE4CuPLC1G16OqJTb6Kg+dxUadQAdO8AZ9WBl6vRRHweWSIhDdeCyBaOgmllMoALmJ/gwtcAcqyhYTOqUJOVXPw6LkP5vk7xESDcAEuJ+nLg7HaPMxFdiXO0tY9mzMKb52IRpxz+JqsMt9cJt9dy7qv9YfSDTjjW8k2r5MbptdIPYMQ2tAlRuLLmSuqccGQJreZ6bIYVXUmzjKo44shwmm+4MvHjB/ZoKmeW00tC0MXnUiHhOqP950n7zzNMKXcgMldoNSqk5WfqM58LPpdyWln0jdVdjZVB3eA9ZmXm28rMr1dmtb6Gvxqdxe2tHy5dyTnSTFMOsjY6lAYwR2cIZsCiyMazpSvZw/1M69DOdabzX0CLr2xnQ4K+QQ+JlF4aUCwBjmE06HyOiUD0Pl0wRgPxJzFxc91ZtFhbp3zdCpxBOocGr+0jPiXdZxU4pI8dtBFlD9gbW6RC59IFgMM8F27Qdy6PPfhVr+DfeLII1d/Y7pYwdLT+6CCtuwyh0fRcsCZh8eBKDAMqEOY3jsQjB0G47oi9uqPC9Rvn+gksP9eMovkYRfM5t3DCKCoBSjNDtGA8BF3bgUBROabzWcGU39yWps7jTepk0HSlVi8nu8jenpT5Rcw1NtwOgluZHptHg4uZ2wvuSHkMj9KiO9KBNe0ezZazoQO6qsDI28ShyQAKcZJBLkA/t1DPOB2s94RtorI6N8+Jk3O9YW5lkYuU8cHseXaApu7HDZq6jw2aWqCpBZpaoKkFmlqgqfgUg6aoBZomD/4WaCoeEzQVTw00ecPPLpgUP9EwqQWTWjCpBZNaMKkFk6LnDExqwaQWTMJ/3MQ/O5mtuLcZuPSuo8Glyyw4guf0gaPwmODoosngaOlEcDTUHByZHNafJnC0LAuOLrbg6MIaOLrwSQFH62np8cHRpc3B0XLEv+TxgKNLmoCjFccDR+U6OFoGcHTxKYCjS7jo0wqOLqIhuuQEwBFYScsfJzha0QiOyqcDHLEArVXx0WHLJy+6MPOs9FW0V0KkM5hpQGGU6c21EKjVGYjy+OCJzKSTIMpk5aqIzlaF6PTVIDmR0nXCz2EmxIQPSeAQc1CUY9KoZquUjG4NML3Zz/xluZorH3JlSpe3CNeY8byWldoEXq9CpjjFgbbmDORYrd/rmIXqrqFZ3DpPsYdt9Q9tqz18GlRaTaNSKBoNfplGW9QRSOvmWwhEBjjPnVRRoqegRnVwsBaIYa2iFQ5eVYOoq44KUXcpRMX8NN9MQoPGJePGxq0B1xDAVTpjpXQN8g+bA1eDeFfWgKvHWLDg0ePCrZ4z8TJuoIBmuDWq4VaO0BS3esfArVrX4+PWY1Qmi1ujOm4NJ+BWgUVgY65eHU7lYvyiKny5IEq30FUFhh/IPNgLrNFHKJBxmAjILHpewl2GElah5atOK5KdzUP1csrB2UCX04bf66MNjGTrx9wBHJogWTo9QNZU1oJZO9hmKYhtDmB/bAdXI36d1Ti60L6zOMYMzlwj+Fn06p80esXneybD1wCyQpPQa2TRq98MvUangF4DoFf9ksS50gvPROTqnC7kCsRq0eszArm2kGsLubaQawu5tpBrC7kGzxnk2ttCrqeGXKdxjKnPLuQ6zznjuQpaoxZobYHWFmhtgdYWaG2B1hZoPSXQGjxpoLWnBVpPDbR24zXypwS0hscEreGpglZmfPg0trReMRG0vrABtEKlTkStoDXAVlCOhVsRDOC6yADXxRa4Asxa4LrQAFfI/d3phou/POXrS9/GCWtIdQM/XMySvgFUINX5KrrJQA2xzr9z7O4jUyzjtgG1DfP/cnGFHbHNEessGVZvMWNoImKdj2nk3NEsXpWs0pEmF7RdygEgD6/K/tLliA+8ajHouTUMOvzF7E+vPvyBYlBkhZZkf2nZ6D3TiAHTAHxzgPn7tzeOLpjYDIDVHxiwCsZmf4YrbVcvq7ZnfyD+SMHqDwWsPvzQ9Rdlf6yg5xqw+tCjAKvQ2jqvov4Y8VqHL+nJnBRNNlAVUdr+pfPzS7M/VafaWeAigWcGqv4GEgN+Gu6gPxGlxov9J8CMg1oRg6nmgzjfANb8+d7+OcmCEi2yChHzUHls9HxWsy/YmKyjxbTgimSjWWuJqC6srbGysOQ8A0tWT4ZWa0wQZuyVNfFbWQ5rZyvx5AFggZcMZtzalLwmA2bWngKYOffY8EqnB2azKTqLo87LFL369Be9EtPUyqbwyavDp/S5A59a8OmMpvDphXTF0ww+oUpPPCbq4hhxDRMBiK3jNTMUEjFKW/xkoaRFBiUtPu0oyQzlcw0IOg9uL4RMclKgdE4dOuXk+KXPdTtxlDQfojA/g5LwwFw+UZR0rqKkWbjif5hmy8BclwFN51nQdHifAU25CQBpKZ1Th1GDeyaCptVZ0OScOGja+PQHTUMt0PR4QdPSpxlo2tgcNG1sBE0vUtB0pQFNGxtBE/fEeTVxOk8nEa7yebVLtpINptf16fKyWzN3cZ1rkGRdDZJAnVOOFWc6vw+2oBOAKNsmQpRyAK2LOVBmYMwB59FGg02uqmGTq54gbGJfAbmK+ZG+GOjETVYeFaGsmoBQ4qMiFJ64X/nEIxT/KUUoK0Hj7OXdpZVZiPLi04xPOi0+uQrtvoo2PrPxyUbBJxtPFZ90cIz2BnzyIotPrnyy8UlwTHwSnBI+AXcDzP5PGto4Psx4qAUzWjCjBTNaMOPxmUCyMGNVDWbkGmEGh63RtynNVuBa9p0Q4ECs0405hL7G0teA9tRBjlVZyLHqiYQcbS3IkemAEscoPt0gh3e6IIdfeka+Uxo9Z0/mtw45tQ45tQ45tQ45tQ45tXbpwufMyfy+1iGnU0Ov0znGmU/tyXz3dJ3M90rPkqsIeh/35+J6W5+La30urvW5uNbn4lqfizv25+LanuLPxRVbn4ubPPhbn4trs+DIaQaO2k4aHKH+Z8uV82dTP3qlX657WiEBobmI7J5CDlfZhePh1sBe/xXIzaDbuuT6LxNRLrBz0U95OFEaXZ4W+nBzKsossrPtPuYv+qmNvKTdB95oSztQbpteoBrKfXLsRAt9UqeXQr7aLtqSduKKOfjzW9IY98yFxE7MDodE6hyOlfpQrIkfjDXLQ4Z+v4l+0NAPxMu40PL+eJTaoOwCiBk5jIHG0i4ukkM75Wq6ThAdYlq8LKZYbqeL9Xa6kGqpehsvtAMpSqc03GnHacjH7XTURZ21G+oCmgJP0iNXl/aA0Inx0EnxFeae7oJ++JgHabysM+miYlKgUjIVTOT6dLyI8y1wsq6kk6bafLj/0ecB+M+PMjR6OOdxznn9JciYs93OxAJ1MZFznSqPUylG6dzMDRLJo45yias5jTrmOV/6JWMKvXoYj5/AYxn6jKZRwJWkML5XL6EEOFSJSPIUJtNwpSdipAHAZYj4fck0FoepHNpL7UmB1c5hzpt60QK5xy8Y1UZw7SNUPsD1tfxHhkavtKiXCuIWuPYPuSuSgN0YjQhUjClvBCMyghCpIIC+P86IF6TGypeKTmxEhQMPGHevod9lcnqfyali6O8y8XYa+nYTb5vcgYhb3VnYOk5W2CA2kCYV1kaJy0QT2QOBnVjy6r6SZaaTOrckMctc95YkYlGj7jvSYBPXQe7wDlCZqeAjd+entTtvQAdoiSKndMZYkucOi6mTevruwORuRCASIeFs8iLKFJg76NHZBfRzby2Epo5SAWEliiFusRVy29w8tyOPdkDoG+WnRO3gXNJORXGLVBK3RHpxZp5E26SBIMecUV1fDnAVeu3WQt7C3ZSaMK46CuAlVhpSuNUoLvs4Rh7XQab0/Fam+C9udymHig6m3JnD6l+UFqCuxN+fFqGUxE9pCcoqx6kLL+Y/xStvWOL8ljxHeC7h+WzyKOT1YBqNxftkFi1qk7k0srSUexx1KiArynMPFyiiAsPdAoVUBPsiyBdPipGZv9rYHWRGscM39LF2TTq5vm3UpleJmuiM0ZeNJ6GOYTN+C9SucThvLiFknlMIMN8JgYg5w0Wafb9mfzayd3DXPvOcc8qBIyGc/jTayBmybzgtwBlMi0JYNq5MKlKEH+oBPkmRaBaztjShHdyADmg5rVxk2sG9A37KGg2V5NqhaVuYIzxnlHGfoU528X7wsUQdaENnYxu48h3UKfCXXF1vX8GBec6Epb1N1Af2/e2VnP/q+nqZqxGnbe6mNCAXV6cG5OGyVHGuIhChgnkYelvSHC5Vhd/dkoa4WTWQu1TZ4ZDl6ixS4qDm0K85kBJ7NUqsxEij4PxG3uMywCzyMYb9jFZgNAcWuXiMoD0CqgXHjcHOFRhe+dI/eW5hfNL1tCgnKHcKZvGSEKVCM1BeJq6Inwvki/4tUi4pcRj6tsTlMe53+6ApcIaiWA500I5jzBYw5xfKgZpqmeAnEaeMElgBiuwzeVIRaw4qoSwzDxQwDxQkv7RoTAIRTFpcKHIt1XItUpgUNC8qcgCvC+IjJT9mAvwO+x0zdSA/Qn7mFEQoK0bW37gTrMAOP/EARJCHsjwWizG9HR0R7B3jiNBwh+v5rruV+4hnbWCFcdx4/rHbHwvlTnx3Kzkb79wCP4axEq68c6y083ReSe9DsIGT4Ku12mdYmvi1a+nvq19L75eIgydcS/9Jz82f4KXkvbVLyT/IN4s7qILeRp65hLzXXEKexwiWS8g/gLjky2Xkcgu5h5H7qYaLyOuVp9A0KYeGyKXkOa2DrYjcj3/dK8q9m7mZXM8QE5GP0aTTj2f4h3RtSC++KM0vMDlwfT29+TsnN3+zEyKeOAEcCYv/MXPzeb7x5vPOUvzpW0/9yvPPTLryvDd75XnvpCvPh6UU6RIIEzzMBk52PbmbwKRjX0s++aZ2vYBY+7HxAuJee0/561y5qhssixXVsRhBy0CbblkWvAFP0Rgeoy0Kde25Myfx2OdCq0A0xUiM8e3JtC43a3ML1UCs139DQIj7k3IiYBTo7eavP211gIpprEKEKux3GurAz5Mr8XHX88f9MctiDKXUN1W61IwB5Cj852JQvD3iyMJmvarSfS4JEZ3yONLyKDf6L2U0UmVlLXHamscBfKli7nZldIWV28mXiORs3lutpDm00IdNwLeV36gMdC4RMfStRZgn3kD5GliIgIcIwyOQMYS2YljFXxAFwn4wxddcH2iPvHF3jJeOY3IL+o21u88r/oS7z7f75EOMd8DlTPvJVYCM9uRqzHlpGi5xbkEc2I1GMVr3u3hC+yJz7/HNoie3eQxvX4tri33MP5/maNikxO5CxNcoj5b3Ckglf5kjV51z8IMOJiqNR378qe3GKE7+HP+6tCC12HbzQPnlzCZbTa1hYbG/k3MAghn59pYH/ufgL+5dcg373+L1z519K11y7StfiVVPtMTZ52LfoTctcKi1BlfYt83lnxjtfce5filFfWmxuhuFmn8vb+cWcKLb3o1/3x6qUoEyjOlDt95leDFTdUCg80VpcxqBDx748CFXG0qlOym4s3bb/Ezld0kAAj8PknjjB94IWBog2zmAH0C2DCS3wtcvvrGP3V5F+6/WvErgLZXm+FfF229WSOtTQzflj9tNB5j9+YY+IkYWpuX3DFWr2kXxv6Bye9Dwq/Ti8Yc+Urt4fKe5aPzTcjjQQSc/KKFNtbB/P8LkinLNpKQZ7v1/bYaaxXY8N8sibedMDttMFngVjWitVIeHeFmoJOKY3l+rH8WhCHMj+k54oetd9C152oj4ixhauJf7bXjcKxubLuwBKg34xzxBBIm/lwUn7RgRmfnyl8vXQFg7atIWD1fBzGqFor1VQ5s5XL0mcXH/PdfnyrI0gwLtca8mZL3D1TKTDiG0iv6P8MfZeo8Jv3C4WhmZd/GMH393wfQhiVr55k3buX/qgk5177V9NfrOYap7r+l7zEtdAJrlfcRu2VnZF//bG1VR8OB/Efng2kZ2HLmsP8vi5Tqah9VZpM6g3uv/oMsuJ/k+XL98i8/S9t/qX8Teh9Q7yN6fqPdDLvsPqX8/NMO/qv8u0O9X/wHQv67+b8B/UP3fgv9L6t+Jkg6of58LGVf/QcTZr+ogKWjl2iRkO1LMFe8hROqvlzWzVkuqVX1GvYq94r0f3m7x7kBWcb28qF7VQLzfVJ1XqGm9L8lCtCAXx2Pe2OGnYh7gQB7lDuiDhJhzeEkHCvTjPFbKOj2o7h7NdPkejlPSSPtcjRRdYmMGZs4CA/pZOSVYcaM6DtBAVc7LOIDWnAgGy0h3o3kCqWGschS/GXCFowizqRB/D5qHn95+K4MZpca3IY7qPoTcApjzHqEZavxdjcE8+AuFP+VYc6Zi/M2bJ4R9xXWD2iLQ32QtoBQ2zEzhUWem17DKSws1pRc2nZtCaE44nEFvmi+DMXk8zLi0T5MGFCKVA+mwqXKaG5KxGgawQZLl5BpeUxB/XJoVcs0twF/uuoxd7MRPbvxlQZ8+YeJBHvFXQGjPcMU3XHHJtVwhv/RAEGDSdxkL1VcwZr1goJEAh7ILwavJiYB0R4GGCkcEsfBZcjSgzSIQo59cox1/Dt2QCmO7OQXcXnar8MxgT/yQTmF4jilY4qDCHkaNW54xGj+MUM1SJyjiusVfvbVGjf9L0ufM03/Lk2+e/keeQobt0Hc6wVg9nHrwHhIvFhrBqj67jd8/bFXv2uEKUsr0k+ZYL9dBAR4r5rFyYbUqBJndteU6gOp1PqgddjsgYqUCAKhj2PCByT6m4mtSry/N67j1zDgcFDxaGtn1Gmf7hd9fuFU6I3875XYz9nrN24ZGfzT/C3StmmxRyT1JTjvlfOkUwM+cLiZztfrLvGOaoBTObg93qO3lBH1oF5io2zHxkNNXrZT+weN1sQhD4lm54CZDZCxWNZnXlFEEUfOW47iMTBxmFR0zuUFkhE3xP4GH8mzoxO61SAy+czcGoHusscndk7ojj73/4X9e87L1Q1T3Xts38gfy74c8KTObj18vVMNkXcc4qctpG+vaj7Jd6VSmZMFBLUNWp7akvuWA6EHpHxptCQ2oG3MElyONX5ToGDIjJcmR3xQpyeIK5ig+Nv6azeTHv8QYkPppDjFyQEY5ndNQll2kw9c9quvnABmIZvlnaYNftzZ82Q9d6BD+8brE6pHBBsvtHP+gm4YZVONyu/GHFzkVYYhwYnOaV5xDv1/xll3b7tQXWhGEXFc8eaP41GBIrmCfmuRTXvF04Y/S4p1YS8Zb7pFFFgy7VNi8SYi9TCxRqVq5Hbi4lpi33dqqVKK2PRTyn/gI2GVFXeyv2KWL0tK7a8SXtmcjIDhO2xqCCQURF1OtYJwHwEYyWULpwwrKu4iRtUnlsSTLZ1iywpg1B+3gixpm0Rx3FoUyieJh5mj5Yzswj4JuplFwSYPeclN2IgXdzKP8n50VvhsG/rh7Izqzvv6zfUk5i+C273cWYhmV0ymUQbQLP4Z4eKw1w19ztPL7MOFl5k6oHoVeV7OnwqE5hMYP3Kr1377dUwtGynacm1FoCBozCotQfnDw+FhJbMxYn2ouuqIAFdDysEe5JmuBiIfJgxwEhPonGvN6zgZkVMbl7LjKWeC6zdVwb4er8dezQwC04gyrs0idQXbu4zj9xiVNcpW2kP+ShV9/CtlilprVppJYQam3wlqGzbCKrnXVMfLlF4z/wXsr/ztk56FhHlhe2dXGG2Vji4lGlWymYHdkyY7B7/7Fn16yVCAtpvka5RpbpmPm4+mUw3J/F9i6y8c0bHPOQMcw/oUh74BxGRofRrqr0xDOtWkeE0/IhgxSH0ya7Ig5x+FdQnKhJiJUx+EB4aoBp8ROjIglyotZx5dYi32bg03NIzyTOtTUrk3tUt6c3Mbg0wwwEkM1IWGHAyAdvRH/QJuBFx2d0Rr1uzXqoQz1QVANY/fdpKzix5t9HRAasBMB8Nfw2zmu28yCw50HoPa1JtaZ/UEJm/pimRHX519uqzs2eQNAZwvdZrMWg5izDvhgRU43jNiJ0vzlonbsGci0cAcbHZKi7KgmJXbCLYmM4wAWpHZC2qQDTpx0wulNYq59F1Zw2PbY7rJb4uEBtw2bLD7lMZjEuU6JV2ucqzTJen1armHDGnORhg0qsV+jkBJ7NYruzfoQpi499ARLSGfjdn46hToa9vLTbjkBoKsr0jTxWNqzJZ3K1KlIQwWSx5gfzTZuO/a1cQIAu/8wy+hZPSqyhwtyx7icbtn1py50WBdFRlADWfKSL1b+F9ZQ8jSmfBAdpVO6WevFWMQqNapTAwIYnaZN9XmGiD8G4ZBewx9OxT50bXk/7BG2u+JvIlrD3sbZTj0KJn4bFYkBsuP7bz2haN+WaP9eP2SSm3DIpHCCh0wCPWSyn57gMyaRUh+KzBmTyJwxMfT7TbyDhn4g0jMm0VN4xsSzZ0y8037GhFfqQB4GbfTAEjH5jMmnnewZEzw2PWNSPIkzJt96HGdMLpxwxETbwJUP9IjJ2GjKf/SICRqEIyZwj33ExMjDIeNCDkDfH2WPmETZIyYqMZAUPWJi3L2GfpfJ6X0mp4qhv8vE22no2028bZE9YhI9ziMm0Wk6YgJ5mwrNxZ6UZ9czG46YFI56xKTAR0zCZkdMIMkpd9ERxxtkwDRI6if2k/HH7I+NX7bYIBJTIQ1nmgyIe3+Upj6ekyiROYkSmZMo0fFOorzfbq7rKZTEP+q2upfZVofMNd9WD4+/rc50HynZB06XkFKyZE8/0qIoI/qcCCljpOTcYuRWRG7FWm4FHkBFqYfPGShzkYupJCfmHPjBbqB7R91Aj4+5gV666eQ29LxjbyqidR46aPKeYnDUPcWbT18V7Ht/qEOzTcXgWbqpeEeYw+o9z7/awu+uQsZUWt4VjhJsjW/V10+Il3mVEH93hWl+U7mwAlUwr7U8MlTlAejbJg1XII7l94WwmmKEwChUghPhcI/Bl2BPB7rFnIEKsSTEGKOcbZfPD51pbB89a686xKujLvTg7gzhjJH/LCU/OvLrn7Pf3801/yvU3NhgqYv8iqXZetY80rqd3C642/00d2kfzGzgJn4rWK0qdu9GPclf7L8vZFdr3M1YKc2zYHAVtTR+yPPD7nfzrh/icUhETIlA2Rsqa5Kc0SpFxO8kWGQ6pZXXpJ19SU4ElD3MA8hk3ox+lMK0bohiN00BDQfB2pmMyZIiRhZnVLixzIRqrUveOLznMR9J8nv3VB7jBpYZkMlJLm5b7rUcQrlXU37z3tSvQFhsuoPcsRgwU9Bu1Joxdhewyxz/IcwT1Qq1cclgqxWS9xXSPIZkntmS5FCxiOtbQm93wmEmalbS+HYsX6SFaIBwbeQnl+993p//+J+GqtTNxfQIVyr1/bAKS7S/GByFqoK0XM/MFz5MAaemGA0CM1mMNndOlF3/NeYItYr5Au992id27RbyULA4+k2ehzUYsHDtiIuHNZEM9d4kIJcX+B6RiwVALzs+IKlbdsSMjbgkwYg+AzSP4/tEnomB1HM1fr/E9+YKAfH7QfM0hicxkN8iLXvYlr1cyx7WshdpXiNa9nIJRvQR0KTs5ZrXiKZ+ocZfr2W/UAiIvx40T2N4EqP0z64bneBBo0NO9qRRDw6oHNLjNubAkR47Z+VmTx5pIj16FMHiYo8e9ejJo6KcPMrH32k4dhT/q5o9zHacnhWKvytEDwXh8XuZY0Be4zGg0uFikBtz5RREXSNj7ENvYzgGmV1+h7DFq9btcueqrMHSZ4q3ot2tqZSkbjNPQlUbrKOzlnSuf47zLHEr3v5mrkvWSg+VVqGcBlTZOj/ykXuvPfDwH/6UDfAb5d9Hhmo5qd0/9Uembb5v6ub7/mCobrEfvm3/npHpFZf/XzlUqe6u7qbcnkrilzT40J8PU6CFYH/j54sf/dWygR9yyf7u1OaBSNf2xe9GJImq/AkoqMC2cI3degj3xD+WhWE+lvWuze5/OTsepVxy/jbN5bZ4ByLs5uQ++HJNX0OFmhXMETyEwJAssyIzDr0AEeM+x8oRFQJWMXVkfCTALErcxo5t7FDXdqg7qUPdZ2iHFk+2Kwvai3CpYHsxnNyLofRi+Ph7MS+ch5kPo71EthM95hc/JRGiRcTHwdEHTfrWR3+5ryVn9OnUu63eJZci6d+01JfK6Udij/Sju0rmXIzYhJnY0rwtzdsamy3N2+rdJ1vzTj5K/oencgL++5NOwB9yskfg8TThDPwr5IQI435jMYETpKpasA7cVK6Mv0IT+vEPkL99lQKmHS9aiFywgvT0LQimyvF/PTQUqRPAQa0Gayfug/iHyOzYJ+yzJ+p7sgfq0TB7on697OShhEtlHAViFfQp0HWIrkISfoaLk0VYiUocN34U+ZErIa6GlEovcD3NUJdQyBX8xSYhOMIMGU09k9QjVxKRI80t/bYbjOt+IlZ+XBwWa/o+aSr729IRCAlneQjCVIFAbPAgNLQJ5AnmpdQv90oZH/Xc6HG/U9JkidebXeE1f7kkH/9/jUu8H+HxmG+T5LNvk+Tt2yT5Y79NEtbeJslPepskj3jiBHAkLP5xZhkZTnqb5Ce6vF3p+ugUT3ZlOIr0qEAaI+g4TUQ+jBDxJ2+GTGmHc5/C6M7MSbgy2Jk5tRdTfnqyL6Zkh8nPkPj0v4iCgZ8RJk95Vhd7n5nEhvBXy3Dy0HeoMd6XshaZoPxqbPr8DmQTwl6+zm6VY/hJp9aX9B90XdcWt7/+Sim5zVgJA5Mcd+hlx1uMcxx4/RDHeeEzx3nh0+O8Lh8I7Ek8UNjI3ssZQFCCxTjxAcPgIIQdPby7qiduHhbpRekOlwX7kdjdbGVf7+Vy5iiVP66sJ2W9g93cxGP3oeIodiSMtgl4pD3IOhLkssNeOfKCERjsxaBjcQ6SiHDmsSctYMaWKT23SbcPqQi7F59BLGD/gfJJG0XYicWxJTUitrFT3b3YB0jQnRM4bdSOMtrJXYNOkOyTAoxoEejRXilj7x7M3Xmc2U3kAFY1KVJk0vhChlqDCy65qgV/5PruWMBs0BckXDLoYP/rrN3SYcskDvXVzJK1g++w6v4lWDny5S/h338PVdnCOVrm/8duiL8k56YCc/qiDgT8PagH7NI5VRAhnACqQCYYi07sXkEgtkk5QJJGQMPcuyBEu9OoWmFCVGV6FP9C9z3r2EUOpYxzA6Sh/08xCrS3b3THXf6Vbsyc6AizWpasGdV/NYOt8oNFs+9kPvaYp8KmLKwqshbIPFGkfSuVL1alayuyFfUn3KPoZFSqTYdQyPJOct6Ziuj2SGaxyGxYUV5iqcbBWeeovelLFkkHV0HriwxH2SybdGreeRSWr32QJSYXnO+CwwymgL9LdQb5/HcKWtgk8w6R0C6pZFrST+50U5z0WH3PW+xAPJmvyyRTqVN5gHiceir1cAiVUAWE91hmKCuMIb2bejhe2+sPfP4Vg7///SHrIs9JH6jiXNKpk78wBfI0kIexNbLPulotkpCrp7/07oOftG495FXX+wNvOnPPx62LEORG8h8/pdKGHv0PFR37xldfsuTbP7jIulLRH++a86Yf/uAl91qX8xD6ll99+MrvnfW5pda19G+89L4zK+7sfda19L89HHd1dd00ZF1LXyHA+jP7rAu6qSnqZHD5PusibNJnttDiHprYnK8v2n7vfz76vk9aV5J++sN3f/K9P0uWWtdW484Nu7at2/rWe61r6Tt7vsjNeHSpdS39jy8H6n/RPuta+mppxt8MWbfenF7i/nWNFFo3PfPI2skyyj3zTTedfmRD2tckcAb14VNinJtnSNbl6GsJaY9sMILbTh0shr3c48htGs2gaZKWzjzyFZcmRe/gUeFhnEbY1cgqAby7XXZFCYTUIV/LLOqZPCbfwEPplUYrtMl+P0dnD7SDKHjKQXE42IKpLOY/R8u4nTOWWeXkcj3MufIfCjOHlm5zPXc8HFNVg1HpZ1VcUPfmoGpcVY0YxJhzvUrDpmrdG0k1oyrld2PLRN9oiVjxu5o0woxJhUqKadPXYvXMS4AFJTloT+kNGVQxyJBTq9wcn2ErS976ZoexdcwOQwtih3HjXHby5blAE+Ij9vXCJ6cjkNZVEATkGf8PJhSONWh59KEwtDu3cFt7t62926Pv3fag3RP2brtPYe/WSTonbNr2NG7aovk7p6Ye3O1T06msrbxr+swrE58fqlq8dv6xtm+7wazu07p9eymP0I/W0Vj8C10JTCYxcdMkanVP/NY3I5uyWfeXkauLVc5hu5upBg03fgSEVAwQussIh1zmJBatzVdNJr/sqgkJzKrpq9CG/lhmJROYER5AnQyy42LBEkCoeT8YxcmLQIF8eIKdwCxk4NOFDHy6kHFkIZODe6gnCRFSW9C48XvErJTXNuwWAffit4CYwdA170v7qlUcdiOfX4WqigUi/qV+2CXIrHW+9wyB+Rbhh40IXyF//NixIf5nfd/HHNZkBWoAtKqj0JenNhZXHzoIuiGC4gDVISHwUCloV6RFCqQO1WpSqhWNaUt7pZq27aa2ep2qtyeRTKNBjfYylozasnA3Z1iQtrHEcP2pTT75U4qPoHU8uyKiqPp6moqujgscr72aFvlxUB93y+oX+bGPJEmBfb2Y68UXI/S2VKNGtahgQ4d8CZVYOUHxykG+vMzQqmGhyEXHqrJJzZeJ+MWddupUQgFVYEIRso+WoH62JSWoGc7ZKJUOPHTIAxQIRC6UPlGNkl2YH3LdWh8eylgRchh0V7HDY4zUZrBel/7L2cF76T34e08PviqATyJcJtaDz+F0wvk1Q8Kg+A6AOFe8B+HtN6PSNeaFfh6NsQTf71iLxCyPcNhZRuTu1Kub3YczL2fweERnyeg1dohf1d8PMS38qMfDMRz3ntThKKbAbh2OsQ7HNh2O6HoZnIVJg9M3g7MgA1K73WVlk3L3glRkceYx6gJauhRi5OhKHOKjL63a5LfZ9MdLWsruQCR+dogv0NmgbiVTY5oxZ9WMZZzEEVMbzKyc7mUOh+NQTbnw6lFBr3xyHqTlm/GYvwEnFeW4laPWX4Kl2ByS9DFGXP5Tew5GUStIbOrwB5EuO2WT4Rt2nKTJcNNx7fhqjk39+JYdp9GKvx2ZHc88uSRjUQ+sRT2qW9Svg0H9TTsmGNTRslOxbK456obAG1GEfsqJH9lp3A7QKiCrzG7Akqa7Acepu24GvMrR41zsiNTpcS4lyOgCzdMYnomBpzaN362x2rQfMDaxbNHBilBJ0qZOrE536TLXnWzWRc24zlIc9M6v7d6FNekqJWuw7Xa0G9FPZSfegQaWLlbOqgmd26+WYj5DR/ynfxR/e/Fn5uim8p/cQN5oYuTQsZzxSnncE7ffKb3IdSdvZkjD0Vz2BFJf6wukJvIQ/yUqo96d6q3X++2uhze0VLw9VFX5bCXZ4Q5IfNBrPeGzg4EoadC9+hauk2ADVuqvBB0g3AY8BpAJje+Cj8YJOks65ECCz4jx77jWkqzfctDeFt64tfFqvlamA1azdJTRyFJbE997i/RU4qIewtSJffXWp1Nfvb3eV+94zvXV14/bV+96OvXVe+p9tes511ffm9xX/+u6XjNekoNPIAo/oTvfW58CX516Ug0U8yd4s86JK8I+Db4uE7w5Gyx5/qtTz1P1MagHm1IvbEYcrBMfuckSqVnM7okx6z1dn67BOcNFnde9+GY0VQPkTyO6OlWwU50EdoJX18EOHiaAnRc0+3Bf+fobNh3/m32nsuh/1HXdG5t+xQp2xfe95XXynSr435Xxb8/4D++E/06RJIxTlP9OPE3X72Tdj7iNn786qCSEHlAvZHt/3fuJuneveP/uaNl7h+pRHxTv3zeLelcTomA9fJdl///yG6mJq5ngQdiGZTMeMID+RlRZ6dduMwSikRWIfN2duJUM6oEM9RtG+3zahY68wzztrz9JirvrKeqIpvy+ptRdTak7m1Jvbko97EygMu37rpGrLHKK/3/mrjq8keTKdzWprZbsti2yZXhV48XLMozD6Zt8u57bOea7pT+CkjIh793SrLNfmBOv5zDMzMyMx8zMTP8EnNz7vddtSZZmwzDzWVX1ih5UVVfXe/2KXR6AJSWu6fdgtOoip0P4wJWMn30CJZgj5fx5ij/k3m+ZkdMlzBRw+dWoYNG1Dk49mM5N9hrJ8IeyCnLuYCirYCiroJAVhSUXf81wD79mSspC5eNU+PPOAH/OGeBPmA4HPyfhTPOBxcBcbKCSvSNhpWyVGYgajonKPyXadT8/ek3+YRmqr9UBsu95mQ0lJGgSzvMutjFpBk9ChnoUH/Uu5iDiJHEYcpiJbPJf+6W3vyW8Kv/Xxw9bZHiYB1flbOozCoNjrTw8nn/pSWPg2nRwlt9JE8AVlPUnwBdPB6v32kHO6B3KaeR39PK5iQoNW0HQQXOTnXdsgoCQe/FELtkZdZr08738rysT2Ru2iuBcVM4mcs+16kRpesf3sELJ5fl9J7Iul49Dg0fnZpxGP3/KDk6HHnB8Qtabhay3bCThT9k50pyHsVQfxvE5Dn+qkPZWIe1N8jDkLUsdQ9zOc/g8DhcK245FDp/AYSPfhCZbXgybeMF/n2vluNup8mgEX6h8X91QM/8/72rbLj+DbstWrCyGdfSLla1RcnIPbcJX2w+Jwvp6npNIXSupG4vUjWN5D9OUbaY6aWyHmmMsms39nxN7D6oMaGbgmj84xqqAmtnr7izYfDM+Fuf6vFFJxooxVrKBalOHErHRyo1tMRSVXBPB7YVNEDUxXZRG1y6otC1qj/Il7HEltQZCi/iOuTWONSV91wTq6Ti+DUqH+D7BgLuUAuHOYYQ7ivASdQ4Q5r8ASKOmYv0U49K7QTuYgnYqaKNdfFsfHEabwX0XAPOqWGMwz9n4doLvi6N8fw6UrYEyvnmYjiboSIkJFTrIYIMv6R78Vmp9pWbPfL1CGOc+d9LnaqAhDw6jRAujqD/PoFkuF50J9RaZEvUa7FkTpAV1Rf55BfIvMg7IQE41k34TaUgw8usTEpgfJeNVSgYk8JXJGOKvVRX/132r8OelbwL5bBT5t40gXz2MfLVEvirIK9aoo1i/65uKNbrpUXpV/s4RGB9bx0GFH9PR0M3/8HDek3ULuOkzXJex7A9Q1ca63Oo+oYBVdCnWPUUBS3SZ1v1HAZvRJVz3KgWsqsu77msKWMow714euyadtoWv7afwQuoRIh8y+vqZ5WYbL4v4Y41uHbDEzZ50c2xKi8SKy9Twan5AJexi/NyDR2KRblhooTP+qpOD+StFbTJ3pX8fdWm1KV6o/Gspwiq/uelvIXaef5+j/gmOxSwluKyJ0BJd6f8UYnIY+CCOzareIqDZk6q38BGD2kL8dVYKyme1q201or1dm2CEbtbYhprSJtKVqIAkVgMirOm4Fm4hFL3Bpk+K3qOO8tbg98rNZ8Q2E3IxZfYu6bDOCX2nF4+add0BA6gx5gE01zoucZQK/JSUgg4hQr9wVX9gaF6IBh4nNv0fUjweeFQYZuTTXHEGJLhfq5Rdzm7MxrFkDBRFM0TxYxgoh1HEaIFD5bnsD3VwczucYvcRONbP/g+aeZVAKJTr1lWvkytG/NDJKk80edd8GzfFzf7+nU/hoY0ypau3e8jBQd0ry5M5c9n0yaOvVmPaLxUapHiw/3dGdEy5Gq4EZBhuHP9uOQ+J7QF5A0RuHjgjPj4C9XiavV4QKNuhMHuDcmj4ivOGCJ4KTsFcMrwdSsFyhunS82sGv58yLmERH/O+vHM172F2jpHfdeKo9qdEQ1i9rgurJf0sCfrEBNhANCjzY7AH4nOKM8xYjzM3elRGM34KbyKG16SqxpIeBhViYU+PfSr55bBuMAywprj7Yhzffn75I1TtCPINJQh5HL0RHNC4M1rFBUWlFJWcKJBGLZzquVo51eHepCfmV3XByiWFZkj2gXZmWGW2qDJLpqwyO16luKcixdSZHerw6lQ/SLDWde6lwsH3vphm3uuyl6Bd6G3R+gh+gps5E251GraSvYRmX+rqB0pN9ufua/fy70FI1g8shx6CZApmD3qUUf2l7MyjgRMWcL10ruhfPcLlNHuT8hcpl2RvllSSvWUIJblBInurQnKDwTYyy/7jCXc7y16gzkl0dH7MFKdwF3Ab8FVuhu38I56s+TvRmhbtnrlR8nUAKPJaXJHFtxhvMuRjrgUItgf4vZmCQR7qs7lQ72ZvlyXnz1oz7R1zCk4f5Z33FDwCK7YZfmoDF+DxvP5o+YX0Ax5vYCl8rajXuvCLaXnOeKOLBCqlejYGbCAHkLDV8W9iMQePtuIbOf+i7gTEtY2+vT3I1hhutmRMhMf1xiL+U1dz4GIdZgt2gSqiT57lVFVTcHClxpmjfzJJQ5gWhbQAV1ELGGEzXCVlSELVq1gGnIPXMLSAZwIqhFphhysUH0zp+Of+4HOOopO8KtvFmlG0XYP13LbJVDWEmBbj25YPcdoYi66Do2ve1Z/v1+wyccqzXTSI/0iGs75n/JQaGMBLND+wK9zCkmQ3mBFulTvu0gpjyZAKRxs9TuFpv0Ct46BhmS9yXwMjqGnXQYr6VKI1Wti/lhnxVLP/arP/ebP/wP0fmOQTw8CpBRC+UDJsHQxbB8OajHyDmmAWh0t9u85ILAmpISOzxLgUDKRlWmAV+1uvl6sWHz3GTTCZG93RRlMQfg/XBckcuxhULzHVHaZQyV0aI3dpjNxJQpXMmjn0b//I/pPN/ivN10V1R6kOQHVHqe4cUN1hlEqqF9S78lciuhakImSDg+ihdFeE3IyWBih8d5IMjfeVZZicgZqwlGHRGYb7NkhgeKjUhUpdKcmLzHRJ+meQpJmQ5Mp3lyT9b5okfZWkN02ScyOSpGkE4tetEe0fo7Up2wyLS/Ptfs5U3R2t2VeUs6IiUnVL45JeKsW8gEvxnRz17MnvzyrtuUeOlq/rjvEgPIPgve92wZtvkuBBdJshrq0vqeSPPBDcYs8e0edYl9mwwe0eoQ15EK6Q4RieBdw+HmDoxq4fPATC4UNgHXa5gx4cIQo3V0cdhZ3FZZmtA/aq7BYQAy5NSTbA3Aqt8pFQ8Whl9CEN7L/QlfSpJ1cLPabWrqclkes4ceoIrdxsQ7zhdd5lz0pphZawNS8dqp8lRsWr1O3ZVXksNHE1MBY2IJ4J4q2vhHhnHPF2iThoKmTTAi4cW4DJ8gQBWJiA/aEFiceYZSmj5Q61hYjG10KEL0TMgQi1lQYhk0Q0BOt1xGQkKE1KxNKQ+24BuDWJg4VjUt0FD9DI8pAWzD8GpONzDFNv1zpaRwcsHKHFvVdpaUzSsgRalqjN5LeFFqZkA3U3yrOUmBYLoqhmu9MIqzFhLtSBVTtMmgpASoU9BtJC363wiodZjuQSCoZ9bINGniO0QCsMcqtM0uQ6Z9cw8fTZtv8GY9cm5+8a/u/Xk5lqWqvPzvH8CPDHpV2RFUZxRcDDrP0uI8t8WpVpX6FiTAXKc1rvce7I5GZywV/I/p1gcHMag7tU61nsdGqH+ExzaGmOMozBrPQCHKka/3Zjpl4OaMTzl/jy1zsBR14FZZfMBRqFVQIHfr4CJ8ES63CsJrFGaU3BcfgGVq3F0DX/fxs/5FflCSsCPc21jMVEtwHaNtqtKQ239B0eXbwPXRycTIYIX6bHwvoRc3iTZXTP9zdgSI4XETVd5KpySYyLNwtVfEzRDfJdtkBRZUVUEBKlGyA2uS3oS2wZ8aEv85HMqPfFTEzosByHYPKoqcjvVsKISe7yGw0QeJ+x5gBdfxRdv0RXT8t8BImNyvkZa1DxFXseNYcUMIq6rXC5x7GfihRmyeI4kmIJgKtPEYJoEmXgpC+cxHyPbnIz4l0jN8XnuUbOvHsOB1auJmf0+Y09W+fgYT07ywGP5zkOHoQhJ8705nNf1spFzHBpZJ7rMbBJdbQCF8P8d7xrWzTPE922KQXlHQSJLNfLmPPbrsvluviErDiC/EF5F1nlv7UJ9uhjPpMO4D52nZZpkYJBD4kQagf8He8SLwBUVKI19CKNj/Vii7apa50QYLnpOUzYENybLWI+EeREsQ6eI7tco0JHyOfU3i43r6awQxHslN+ThJj5ITnMUEetUtXSpjWg64IetxOfFixIKbze+V2Is0NBTyStmQpcxoRf5qfWHfIUQaoJ2nq8Ms1r44sALpaPp+JDn5rmqcNWmpEUdGAsUyaRqZBOrq17DHoYQDpfOcKkvBWZ99/j/lFnBsSR+BQBFrALJeur6z9HMoRa6oeUg4S/hVJbGmSIdCJMemuR2xBL40AY748iERE2LCRNhM6ddOv8hAMsHBRHd+vkBn2WKS/0hTlyWoz8Ugh21Js9EWPNAiIlXI6W9ZA76MvxiC4dGBaiVUjfanwc+U2sOyCnvN3ECnBPFxwjssKS08BPhyIZGy4+zbghb0eGbjxUdgJdLiOl9/Al0d5p+A72dVIHcpyppHE0A2V6klcSGCAYneHpimgfsj8QJy+sEpBDnETcAJv094wxo7dcJ+XlHjgs3OKAl/8THAQ4wE/EmyMHEQ7wE3wzuMlBBYfXycQKzg1cDDAv5BwkYph1D4ldzrFzJbbJsQ2JwZaLENM7yVYk+jFEOxL9FKINif6aVz6C5Kgze6+elDH+Q9+Yxkz9RCL30XTpViHnoMEH7XdyZgaL4wgEJnoQHxYZH+I1X+7qBpWRurzk4SQyIMTO80NWB+iB+hZKyFG86JTUdwcocjz/Rba5yd4JfLX3H+PyhnUdo8f04cQx/U+pLc3IMf0feShUpMiXI3+YzuEc/tDHFL9vTLRTmL4QzF7++PGlWUfxuqhW3hSK9yKB+GT62PgE7GUZOUhmGoPOV52qFFvLGCtWBWPOEAe8cOH4FnUOfD0bDFRTbqkStJzIZ4cUXyUOnsjYCvpP9e6F8S8JKhyMHJaKbNL03ysmGfnqNVBq1fTy4qP+xYiVHr41rh6+Na6IIS77nk0xJiTDP4XSKESe+hrVNuGvFDFZvcBviYcuZvFo3HMVCNQDWQPAHyTxygC3yXiikoqztzxJXbVohUj6d/FJqKeKBpmBJ1H7ZgbE+Xovv/HROiVuV4vLnHUxsP3h1C9Bz6zr1j1cLPLFRYOiiXgZhzPShOF+oZwH2o8z0g2GOqP1BMNXixTjzlcwmsr+VLWSxToWoZUrOYZhrZ3scZtR9plSU/Q+ucW7sFWQdnrcKy6sUaDudrEoILXlIj7I5BLbfHmlXloZDZCxLb83D7I/k3FdKQoXWVGRqwphblNyY83VUjcL4weuInsYddEdctBgVsjIiuSyRFCTcb+V7CmYCvD3UcbFNUiAReXPgYPeQnoPhtwDU0sh/iFIxLQKeynWmKJQOLcKDlaXPFRWFy6QFJ0GAgxwjq8oqDO1II0UPFdBG4dxBcET6IL8caB6t4gQhLZSqPogbqroeJPrjAxWdlEjgvei9vt8qYrfhggJYuzqGP4hV3zTPMywkWy49/wDEz0v+wsgChnEivhfIo0oVrNfQ2K4S2LwxUNr3F/T59TkB6dYblcozP/hb5/0BUa7w1Ef4g1JOgqnWuFucCms51p9k8JytSYKId+G5iecjwweGR9iY1RRB+pKHAJ7qDzGYFA0iqpR/o53gQsFqt4Yfm/6Fe/d+cAzJu7d+Qo1Pj6lxrt8fwZ7lclKDFL/VDq9ONiWIUvBABkh8pKT8K+iDVYHlJz8QXUXN0Dxm11lAI0ljtMYJG8F2GYnHITbefgYG2t/uo+u6QLwMkMxti6u/r6JV5iQZpiM98u6UyMgZiPpCeMzlE1Y0oOGb49qu8+VK8vwMIlFr2mTgnDBRs4nePRAjwPSbFwSZZPyqgOKiImKQZe+bldtQNXS4v0jzXh+JzoV7xj+C4u3ViuaTtwAggUNi6K27QFJXaoED+q7GQwhUCQaHFEwDRyumNl5LN6YGRIDkpJRSEIzTLSxQR7i41vkw51RTV6XOBJsudkul+AYcSSgGOsAMwDoFjvQOUbfDORyHB+/0FNR0reBnpScqz7EsARjfs2jf5xqufgH3GLdUzk1ZG8nN974j8m9HyjhTT6NQiOUbh0C+VQ9DDLc61fZQBGjjE/rNUEZk5EIGayfwsf6AmYdeXOYH0zLb2gDsNbDKeuuaw+31E1q3PV0ap+2Ld3dHBDcBL4jeLYVz4R85sEk3AD/cVCNqodBPhiA2l+haBEbpz4pSWtQoyStXWYGUzKb6VB2TWrvus6Q7jY1me7OaWYOphceMDNY1jqcSrDIzeh3dpKXaF6oebBAZO5SA/1juD4C7+V80maXc1EYyjDt8pzDlqXOh6lwjClnBIhj1I39B89xdAMrVm+rbigGjz2Nz1L6Axx4VOUgFYaAWqrqeI4Lsgs2jAueg61je0yuqfHsbh9jvw73uw6p6CBVD7l33LWqq5KIokTEA4TqigzSioynyIDptRKNOn5tUI4zMlTrayM+miaf6n1txNdGfDSCoEq1gVz3WjTn4tEGAQWgL4C+jcsOMjmW4h8lPBgnvBzMmqZsfFy4xvUOVakloOc8YO/6sp0YJZvULEpS4zRS/L+FaIuK/3v6T95fr2d++ilwMTAw9WhZvo6f5WHhmHsie9AYTBN4OCLwSOOhCjwaCjyaELiLCnqv1VtaxbXLoedGACc/rNBA73ILWqnNpAg9r5YSDmkFva+phFdVwmulhKOy3xURSMiEQrRAXhGOKIZshYIVBURoI+JmqxyAN14eXFOPa1x5skGprjzqQ94h65lVFuFhqSl4KGXXut5xcZmO43KcYNghsbYKsaLmmcTKtIrD5OgaDHzM7tnCGSuFLJiUf5m0LkxiuuqaIA9zRV0aoDbiH9w99mu/duJ+0om22x3i3wDkfnuuOayFsZog+aHdY7grcnrF1rHzrn32fffEw1iT0+u6rnUtwVOMFP9ZlAbwMdt2VT5VspbmETiaKx6DrL8C4Ihab1CVE26jb8/SSXa2BnpKuUCrvBXh4Cyagz1wzHeG7rMNjAsGxPEnSDxGA7X+wK5xwQ3irFpvYJdpXnbLlo4wyNX7A3J4F5ntD+CfEJmzkl3vDfi/lfkagm4mELQ8YM+eQ4YWULuL41VDXUjDZxC3Aw0p+bB2iIpbmWo21mmmSxj/cZp0TUOCotHlTKeah1op1ZFjUIuKuVnX+RgW81F9Mut/wmslAsG33Li5lZHTZ1mmkN2c3NeBQoxCPg5toQ3PdvS4+lzl/Hnc9Jy8KtEM/51Lnbv0WNGhkg6LD+ztFsOHmuUgOC+lc6i1a5t0Np23a89GzV0w1QNTd++yLUzFFTXsZRJHdgcBnoy8/wCNU/E+cVAAxBshnVdbwgQ+4EDRctehBXyW0C7IbAp9ggpjkRYcAB0fYjp4jcWExIaFuS6SnlVJ12gNQ4XXVpl+JCKPROS0gIsfedvao9UTsl2dU/dDMiWha9yjs489+yM33Xdvdy6VU8X0z15v2qu8gTX8N8cWVaWlon8qum1R4gH/xacCKeNzWF6yWxk5TNG3BLzukY8u4wFgIcCVkzYhBg+IY5EOFaqU91TbimqVZ/DUA8BVOEnJAI45QxwRko8zW7RU/d6do/7/GaqSvJD4XIpfP31O+3JK8RQfGR0nFRuuNnAJYidcjCNIftGsExrnsli+xGsHPFXoS8c9MDo5lMR9sP9Fx8f7SG4OrJdKXawNOSaL13c+zIj5vTajuiYy7mJeyOEkj9Oe84gjx7tiT1CVl5OqGMb72AAYTDuvtEfz1B4NenSe/G7xB+Vc4kNhD29JDdXHNHlZ+j/DymoO38Vhm8O/k29cGAfo+OYRLDM0geIv5POfnmpCaN6uydq1JvihccbkRYLP8wytIfwl8//sXUdw41iSBSERwIxqZtUR41XbfB9FSipREkgCJapMG7UpM957d2YpNtqtH1O39a6m6rzmuH53/GncPaLv6/117juK2XyZCQKipBrf67oqRBDuI3/m+/nTffAZDY971lrwnpG4XhBxaIQ+s9ypVsPF6DE+Z1E9+3GyFIm68j2kPHb6qlb/pTb9dTbz3jPG9rTUPrIohifNYvofsQXcjaBVfpw7rG1jEDIP4ac1cRPwsOUZ7uYAJA0tBF3weoaf8iqGAeGVsJGP5ut4+PCQQRyReL7BTT/fRF8ZwL2KUrx4QETr/nnj0aYcVi7lWzPG2MIQfT5+GwPGkHZkIwVvuxgQKwrHD4aC9C9YuYOmdCJmMHTUOrcuHX913InkXCFBz0w2T7+qRmrBQCu/DBGjmMm9lOUIGyhwcabUb82wie1Dpe+W2bNyKWXFula9U68bIZ4dL7NbadKAKeWTUj4FV38v6fZ2iPX+yO+PZiyb21eZddoyE5WoVCdeojtCRp6N+dq5ZRt19obpkyBBfHQ+goYSD1vkMXs+gfw/PbGup85MrMc1fSnp014NMZ4h/mvSbi//RWHVFGRXKcUbnTDGCKUWdFRGsHKvAl8sqwc6yo4UmTFCYC2H/C3YXeW6AnzM/Vj2x0h42h5fKg9TpaAkBaVSsKJq+bt15vESH9TwnNPWHgD5UwPHu3UJe7ycucRLKNjHgg+5ZKVRITrXVZhpX8qzkdZVmS3XSNPRfhZ4SsRsjsV9PzhySkS8ueg8EDxLDp6SGueFHxA6NXE/ftwQyWdDZ6QEj4j2KYEjMGqDxzp+Ej/GDkKoBR+i6UEQmtb4GZGM0U8QP7HhJ27wcxaGll10bW2FjblOgmjTwHja+iHi2W1NU6yeCTPq3lJu8TTM9w+xPOWNKfv7AIApQ1VeY3UBMuMZ/Ic2M83PaKcNdsv6BCCdM/NuwGLjzCOrP7h8w/WM4gWkY8wz4zZcKn18pfge14/vhMzFNrYnhW4LL0C3/fxG5aTKRGVLVuMla+OlaiipSEn1E0SM+f/e8ko95227zwEMxAv95EHneURcUYDzGOBh9Fa/poFdm6PD+govW8W6oOXz98KetbL6dV7j1toHaaN0eNlrVG5RY6ZAClkn2JPPfWVMtoguERIm6BJc2D/6t44UsJ4Osowgi3XbBpmcBTQHib3P3TuJM5WxEZmSXBKJnAfe+/n75MzXxFbhUUA3m/fukp1koWiFz98Pl3n0DXayL6euWAdpQtU2wA5n/11sID1r9lcOXMUl+byGK/L5CC7L56MYHL0iPh8eMzXa8dc5LxECEwOS8avb4leGTLl1VbiFa3gUE+p+NvBY++/oX5WX59jF9p8cz/fxCPbxGM/rVfqpfJfGzi3L7e0/VthNXCCNycgBqCZjI4kYsclBkHkZ0V+bKXhvzuUrxsXzZLGKKlVh5RrIV/ete275fw9kX4bsy5CVyXbpfxNiX0bsy0pWQTgUCH6D8BLwXqhLvhv/XvOyrcrFC2LL0PJgRIKJ2Z5b4PCCQqk1ZUvTJQY3plg5zCMRScw9CdIM5/GOIc5helvPz0Cbk/2SaJnHQsBm5NjtsHHwGW42MSTS1jFk7d8WpixX3MaUez2z9DVsEGINIhA09p+7skqJES4NLLwmp+eFIRMDWxgiffMam765pgEFkXfPfGOt83kmlNjEOhJ5mmwkcMjny6ec6YPxpFETo8gr6G02TjRMIc8YyrV6TT7QEEWXJ96aF7oz1uCQoFIQiFfK9lzYN5LfoGojZTQzRemWr97DgHW/fSDhGMFYh2nM4V0b3QSuIA1a7Kd7SPxLg0TC0H6jX0M9eaRPz9NbNpgXO2nsiep+hlTZBj1gfTsfMtrGxutCeB0GFjoLiWxfTKTXcr5aMukModG3zzLqLJvn1VhFhILhuIEe0h+ZSwhfYSWyecf3vBQ8xnD2fTRxEIcY41ObQSWo1srwv4yNzD+QLV3FCpHgXxm8pgxekq4ipsT0Vyp8nEpxPEkYcWiZfEsVTaX+ZAOBvh4dHETaeOaitjqPAktHogHCvjxlHwMUxmgXYpg4E2NnYool/lqC+uSq0pdXtTwEdgtS/94WdpiYL5J4T2PvaUpiwJe3J+xAxT5OFBkFIVEYJDKrucg45IRlNvDVLzZneiyM5iHejzH/WFfEI+74xe59Ua/ZpX4irZ3sVAM9XediX4BnQDrvOAuRgtCA9rjnUqY6unUOqd2mPSIg8eBIF9vzIa0HUtU1uu8x1r4mcwKskb0VvWA6v+sZBl3FQ2012W4tasZiYbMvoDNQqW9j6sr2OxFxZeIvKX4X9jXh3DXyjs/KGmEr4pIQi1BSFXDKyxGraLunyDWWmSLE/hsIPpJ9eUnBGpyrmJgqGGD+GMZy6oZoDKw0xclepjNmO2MV/y3z1E0aiUkjM2lUxzUvnzhWyX6K402BP5amPtXggHJ9oOwiZ3S1KDsq1OyY7AYnZZcdk10GtUWaJtutZS096nYD1G4oVHYRTGvHFjKiGjJJidQmwuZPNUpW9n5B9xA1wrFP4X63xfZ4gee1+uUm8rpZ5bkNOIsn8QDswJQHpjj3Nt2znAqr5zvPhZHmcx5m/PJNnFRLrW6Yz7qRZxZCZCmF8dMLqYfIpyqMfXhaCEEV1BCJGgcagC00HKjWKbIT1zKNwOfKF0nJxOhL7/OWUiAtmnsJLLrWw8zMUB78k0uiGetx1s2uHaPin1wgh4d8I3xIMUUBSvG22p9Yp+3Wm6mSdhGcstbzz43jzurG3l1Hj+YVpgYSjblYIk26fCwN0tGacBOE2iKM5KiqL3hJUUchx7YsQ+OPkhx0YWA0+3HLY/RDyGN0pjzKB8pj+gB5lMflMaU8+gvy+O7CvzPlMUVf5VGelMdnf0R5PIw3sg9qwHY925hXXEiU2kKOnlzu1dtBp77ftLDxcO6HoDh6KOyf5kZgid1g14fe8/HRQ5iIs/XFzkF89Ccd7fGy9/hBDgBZEZvlP1RWVGKzHnCyVvke3PmsJLNlV3qGIXVSjEJLFJYQK9dt8V9joiBrx8413klmiH4Ya1Y1P/iZ/AkcHGoTlbkYNOqCtsBvTMcK1m7gCa3QvPVs/qTj9TsdHvnVjp35XUldcvupRrc+voIxXvGOQNy8+lYYEl+31QB6El1p8lmz0MdIbiERBW0j5Ll2hsHjsRSCLr9LKAgW94DwbepUDMhmka4FrIDWKbB/JmhQPReeUpiEp2WTSNmJFvSFi7LpvhB2KcNwTd2hsCPEXF+qfYvr2CHZT/FcJX75c2IjLCtgEm5pPy5zgIf0uKOeED+o5PPq6ShqnPeuSjIVFMkULijCNQHISTzZHHI2nhpP8g2hP3fvlzyiHdtDaLkdkvvmXTTocc9RNIG3wDlahK9q6oO4fnBeoNfn6OrTb/LK5S238SNs0cZXgUUH6XU5mYRtN307vOUcP7LDnNRwuSO2lKx1s8CxRXLChhBpOXi+oEsS9Pa4LO/J4/htFRtqZVFOQ7l1qvpw6Bg1/5BnlzGdme1QmDkzMHOmNHNm5JmugmrymLeDAcZMlzXWhw8UUW+CehEpv9zphKu1/VaTLPfkqRtxV81/yCdqH6j4aLc1F+yjfUqAahLALGfH1aZLKJak1m3DG227oKd7HDT6bFOe64hJtdObktBlLwFQXeS7q/qcYHLPY/vxZlQsJatUYO4WUqqEsnz8iJK88/9VkndeWkmuLkqSv9HP1jtzAUYuLjavEhuqVFQMhy66HiVRi2t06g+3TsI+1QPvykveMzWR9szzLU65ZT9MVMLlKRIuXMKJSbg65gjGKEMXA7XN9zkbuHzVQIka4Q4tmKfCRapCu+q+k8gImQob9aGJzRRNXJSbtLXGZSC440L/gnISdJnU1v0xIncTgDvRQzJ92LLot7A9y7dcV+ohziSiF72yJq+EDzaZVRIU3ZuzpPLuKSswPlYDo5YPrh+GwmybxLyygeVPvSQQQwzQdZ56PEnxlYQUIUQu3W67qkdX3gfIVjOPmZlkuiB2YVINccu+8MwrKmWO0k8ec67IN8RB0c4ffEZ6XZuuWsOvdvESshqHQ1IQsKlz1loYrkDuzJoSHe5y1azX74wskSxEGdiW9IJVvYoh00Pog7lwHMUhspmV4l6k0ztsB87CRMmJSc4Em0gb51y6ZpI1UipThjQpRuKSoWKkk4XFKs8Y1dxuHsh3M5a7iBzUkVvKz9V2DlF8dsWWQ/KkqazOqN7vbdflW53G5FGxDNjAwKGrShGVOffKvQ79TRnnZJ7HVUeSEA99bMqXrlzOu4eQTaVcDVNlaUiU0WHdY0vy4LnXTJ6kDWvzCdWhsjche8ngQcNgnlzRJLoVmXjAK2pqeJY0evKXsVz59WXfezGRvReXa0Wpka0mOkWt+4aZ6kf/oamjj8rD3i+g4UfMjyXT3/pcuf13Y3f78Zq68GMdU0wPkRA8owY8u4Q5afiDWEVkO7/LnVWDSEKNycf2CJAEhQGE3xeklqcqN04jxyVYuAxN1Yx4cFSH5xKblVV+EUaqczXptBkqHwQFDdqRCaxrAktNYAMrMVCx6ewWU7qLgkopqBgTovu4oDz2+fXoRiOaf6Rovj0XDff+sd77euyCagtxYY5TiSOmrEb8gIruTKk1Soi0xDUtA1uimi6M9Qu1uO6kIqERbOfbiezAd/4xUdl1HVnNWB8IM0akZEpBDuhVxybIAQWZqiBjmwVq8Y3mgkT9bS5c15qJv1rShDuUDqg2122lQzUUvnwMA5sw3GBwNRrP7OjTOKBD8ri5Y6IW1Q/LLYwQpjyhi32vz+DH+npMNfNhfeyG6+oNARd7HbuqLWpVKwKQESqqVkGrIBuZwW9XmQuAGxjVBTOqUNapC+jDbmtTYYOb1bBjpUvs3gARGbseMqr9HWyL2YH1GTYOsUHpkS09VgTanam2Q+icZofUGJzU8JvUyJuY5khhMwJGStahWxqZ/5rm0FZo2GyATDVQYwfGjZk38fhGY+pxPJwEZCZ7IfOfibSSJB983blxyQZdi1TCuYXhVbKFEgNpZaBTThggdo5rOLCZQzNKJhEebpB7PYywXXcwdf7xw2fFZIEH8UmGWlTaotGuBBD7l8ZwapHbzJNu5HqX6jq9lvnT4wU9rPPMOuygVVmdRmxk98YzbCF2ope/F9ENrScJ1bKtPqaq/fN4zXBrxOsUoJGYLY7DLYzI+BE4Mmze1KHQOWsovDwU7sTfayis/p8dCuz9/4qhQEJ/1KEQ21CIdCgo1IcK9cWhMDS++lCpIaxMZylqObMOpodIrTcDlCHFSO2oks+sEMmkW2M/M+ynPyT2mVFPKffhcexjQB4Z205z/ydaa74I9zZI/c74JKQtFrAAac+6VSFFxV5moUK2AOnUIJ2Sw5m2rVQaB7O6C87ByKf0msiT7PESAF+Q72S5NdKGpYo6jLw4/jgsqQiImJiISddMvItANZhq9lzFrEA1ws6kal52bTkaLwAhZ4aGOXOdSdJ1Dc/mO2RT/DjtoOt48tnc8otmDXn91C+EqKkXebGTx75y5HE1lbzWgctEFMUGWXkcouYXKtiKuq2sNDi+TEmqPHqQv1trzEWUiDWNmCDWFPDYA1JDC0dV2n29N48YlFD3kjkcexOKWbUMcWgueOy5YL0UqWkdH8ZnRi4+dSxywdxs5aO5SfLKZoxMEad9y6N25tG456lHD9D8apzr9jfpH+trg6LVb7KKCE+85VUdkVnAK/26J+2dMrHmDPgCstwSvXjSlwjZ+rHdz+dX7tu61HwPe/V60j2rdc7z73TCDRPfU0ZQOKAAZGT9ZjxjSB6v14ZkVWL9JMINN+brvvLpszLUzh1qWGFkq7Dd6WKkCFMiZaRo2LYc9HTPpHOvw9duX5JeTrXt1W+xq+GyISj07a582wjLx3O7e0gw5Ymoyvjxg8jCer0GMHmskEktNdeT1ByDeNNZ/XaPDF1NvlXv8HCQJWro1UhYCCxnt3APQ5YDS8RYqsqS61JlQc8bPfkTRM5k5FogIjp66GTewRIFAjdNXxFE0Nq5KbMfTHmxgk4TF+bhp6rVNHCioE7xiHqI146+2tHNlztHf9WRONvakpd9yNe4+dppvqoUTvPtzMlElykYFt/JpdiXj2dkV3Y63Ok8c3S+w72Ye7Hsxdxb4t6S7C21ciXMvDBlcu6OdLj953kUr3/wOoqz0ynNy7BKS89RurdDiSnzWqlxCEOrFQi1SSNfyagMY+oTDDw4mczrkLoAYqQamSb+RIt4qM3KZD5rg1mZbhrbyuKGdYKmahKhDN8wNiU7zHRx56DbFDkpSUZPFcaQs+04ixy15JpqJZ/XWtHk13C+ck1oyZ7UI3jj02LCYcIBtaWzlhuRKwuPm1ggG5mFty1e1F20qBZpYKNd12deOaE01T7ya9TI5CaBdJ8sGnKK0HTqO3xCcCZ0LQKpvVGb24TY1VlAGaHQ14mcJHp0aKuJmp7d9ajudMRkMOKmW2dXgKgm9jmuayntrq8R4TlWWnpF0aYpIF1iuWFI7OvoDzs2es3DJ6G4oJrJwwAbbupcNDPNnA/lip612sKCHVhHJLbzjLhiWKlYUYX2Y9Rlqi+5xCckpkblRBieottKpbLCzqyl2fLR96HYRlRsZaPYhg9QaeX/IpUmT/pxa7URSmq14+qsPFudDdvqjJ+LGq3//Wu0klgvFzRayStH2LbWFQgDdQZctw3O0G2DUEHO/gi6DQOUN1A8/VwYttRcdfZYH/8E1BzVuCYiCnTbiYjx9639Bqb9StV+7NNc+yXKpky7lSgzk0b7Zce0X4aRsaI6oQi7KEKK8VwZZt+HMlxQhWr6VtrNtNVH2W8rSQOxM8nfrWe6Mmkio2GgtHLfVZppU5urIlwMMbZCik2rr9AEF41YZG7b7aFrVe/Zv1172FY8XAJwGXv37tcGLPy1Fnfv5QD0yo+t8Q2xi3lDg7cBuq3W3ck37WwuHjZ4aEMVfJ0Z3JaBpG7QrngzCM9qqPxXafVKX4I55E9h9zDcVC3K4lJa5uFW/DhvkWZxU+ORF6hG/7ajr+8wU3Xr6TlraDBH0gpv+bl8k4bqrjSb3RaCDrF5O9+h+rwutTy4iF3CYohITvBbmIln1irBuXI/v2QvBGFrz67ll7WmcpfJrwKb/g7SsIEcNz7/uZBLi4GhaPZCi5tiBqsvUUvTV8MSPYmwjYsaLLiFEcaHBsw84ZpIIMc2ZK+ioPC5ZuWIsoDc1oUgE5QhwobrgEm79qwpuNqQvU1sqP7b1PUvtMdaZWhX9k9/LwIyc9suYoQLpguD5bxTi6oo2NIQ40oAEkR5ap2wZZ255lZ8bc3d/Ir0I+x5D5avG3C506z12WfF6hklRFSHhXd0H1dxDY9Ih//THcWW7fH9V6IVhCAKrRzqtiuHNC98GZcQfZ6rTVojYNdR72tsMUBsIp6xAyRfiX80ir4uf5C1NJ98rKGNjxnaxGXlR/WA7uEm1VePmQnsGENMvtdDjPUQPUi+j4cYO7h+Sn3hlZNFYjd9oGLK2EOfmz5KbsraPd5SqgSbt3AhjEneTY4qVmyGgYB1jAMBiRlabxYhvgU38SSDH+GtuBU2cTO8TZ7+toOO/PEFnFN762Loy71vIUDWZ0HLf383zt9OdfsOG773ZPiyHmBpJu/2tTiFVEfypxW0xLyiH7hYaIN3oDpIPb4hd49UJfLbNY2R8ttbyfPUl12PaKgcNvOZNteeSCMPhaU+obr0Tk6rUHM9ha5dsNoAFygKa5UkvjJivQSsmKG8HqK6mlP6x0uZSQ8l+ngrBSHsOMcXpFhnNvOCk84nn/ijV7X/wv6pRSrX1CWR4k/j1CnXXBMb8VqYzAsoKps9MlQ0A8x4SRY4lF/VKpLwqFzvwV1avLoiZhMD7fih4c1D5fk+9pupHwP1AFrJXnTJsu4KHsFVXiQ04VF+uaaNaWwohTzGk4e8cah+Am95hE2fYInWvSgzUa6Fd6KPt2ic9V14MwRt70YPE7V3/5V0ofi8jFPWuB/9h+mMdxw8MwtPykYEfENYso13hIs+8b/bSvZ3Vatd1lngk2byfzYwrPP1z4YrtnmPbd7rgojyp8nRC3haIJ1HAurQwzuYXX+fNMUrPpjv6PuZLqngsWv5iamG6lTH75AgZTaP40ZIcSmAsmILEW+u189/LO+uBbBQGfJl6mB164Ir6rmWvncs6b4lKzMDkNFaeH8zrmKOqwu25OCAVla4xZlZRv0vU2nJFxnU6wbRKu/7eNu3ErkhImqCDTlEQ0UOqWZh3wodoAoyDud6KIeUAcF5ZVtC0T8nz0m0YtuR+IpW3Dq1pH7sA7X74Jh1o3PVZEgdxZatRIkN0ldZDL5vyvEycC98QFgQIBU6Xex4P9KDx1vZ/GjGBpsoesxdpYkRWP1GrMnhzvxwXB/mmdSaMOL/rU25RodDSQZCX4rnNrccjHlC56hS5W+nZGf9tjsiH1sL5WJlsBrJZsp84P7CLTmbyT94FzvmEH1Igf7h+3r53fBeCGw+f78G9xUHvpW2lf/F3VX9t5EkYWkkxZZHhj1pKXLirzvMKK+lgCQ7kte/ZQZDmHPMzMySfPR0L8d893zM9H/c2/HLcX1VM4rkKMe8m6R6Ws3zVXVPV3U1NjWVbDWSEUKmYYxaoC/4gD9IWDtCXNvGwEtszatnaBzYlbQrk3HUUMWsXRAUmaH+EgnEZ22eZDNqHTd9Q2ar1ww7YM7seJi0bMGW5NBCXSK2hWFtccJyN4MlZIKuzQ2X7NMIyG1sgsUOxcWE+ouvxE1T3vSLcdHtVlw4i9Zwot4Bf2eIv1faEqzVV523pPIzIrrY1mJ/9vVOqyddCRUAaPHnMsqtdivyVlcx6hZjZx8pl1AnqSUAFYoJS8BVjS/HLlqTADygiRaZqKM9WW0xGcqrviweTO/8KoysFO25CiPLxbaHntKFEiaAYc2IABKcyQ3Yg5riyuEadJWjDi1ddyP7hEXhUSvbiNS1vOpX8AiebPuTHV2lT9RPMX0JT+DpqI73qofHjsbPcZp4gT/FF7wHpwSkFP6y7nUZ1J0ctaJWjtsAbhMy7jTW+RqHiF9rnLZJdukrJwZJSjhNoZZBoAUhQSISlKqKYdRsVi0Ri7vIsIeJo1OmGrUd9DMSOHNPkQmHsQNsmR0EbrIhNMsn/0ypdzTXpLucob7qqTByTbPUDchWDHC9nGF9ilvWb5Xqq8XKKoTjT+JJHd+IyGCeFVhQTJ/z59Co3yF6NxUHHX8ej4NRBY2yicfykjCvPB869PwqjIiq4wLh8ZXW3I9/9KPjqwNS62tUwtSP04XuLJH34Roh4Q0KJa6ObZ2idpBdE/yabo+heR+XvTsQsE3Yo5RtY4dREuiVwvhDe6rvvHgJ/hSZQwJlddDbgW/5xWVChBVqAlIZfD2KdiKaxfiNGrXCWStc1IrH4IisRNQUpW1Ykf2zawNOv5TqGXV7WvQX6+EVf2nBXcZFmWXdNil88MS61ybWbWaFftMZdet/bEbdykHaumZGbeASLnMqdYSqwx5cXDOjfj74Z82ouwdPqJFk4djZARt7tqq59tedCiJCk5zQ2QqbHuCLVQFf1m/CaYHUdNg9RuKkMESI6sOcwUsIX39SH0nZf++Ul8O4SealETj0pZbCfRnLymqpF8Tcp49B/IglYx1Lle5GP7H63o4HpTeXxDipP+euszCUEzu+jLL+o8mWi9FEL1K+A1jJZX6vL4lkxhNYwlKns+qXTdw2ovl9qmtQbYRTdxSKODX+XX1KreBJ7EA/Y7S91yQwslzsTHzonbxuwrccUEbwJZTab4/cPyxaUiWUHotY7MBz5rBXEesaei+lLM89+xmv14lSA9JTDx1cyCtaDnV4JuPhsSmzpuexHkO9HtzAx0/iPCikUO/MXbjw0apOocrbp1TgR/lRVzBZ670H//M6BZ7muz9NFNjhZhZN9tlBkrFpI5LZQ1pjeTnaHjiDJuFYt56esp42qRbhd9vagQVblRzUgv6h6jFth/lB9sDjOsd3DBP8QthMV8/RZG3w4ihqZ4k4PN3x0zjbwgVOLFXLiAttwslXcBbTN0wUhN80B5MoVI6SxwopllbBN9tSlTnf03udcJSrhHgIuwl1n8AjMwH90z46EwxDCp0J0vFOxw52bwfmSOYwTzIv2VST/aAKp+3s+Xbcx/G/D/dQRt0TbYn0WwFY1AZKhA3xFWZ5jeTybyi+QON7QSpDz7Xd+8yHfVrnqozwA4mZm3HHLLofx/Ynhhnej7SaZ/H7eUg36FlC+lqj9wQBs1lynlxlBkk+8S3u6fosqMdfVp60M+HZnktrlwQDvO2el7j+UQxZRggKNtGledWaOLbjsQSkn2V+dCjislHGQN+iy3Kp0V9kIiqBvzC3dtmKcBnjgCznh+yMbvFmYrveuG82hGYlh3RXF/jccI+dqb1jgO3M7O8foeJfFjvmrXnxueGvU+l16j04/XIb97RP2bCl492N+H8EpvFcZx862kb2I6OnFlIi38ELQehFWLmpJ1Eq/oyKb/fosWpGivlHkyblsny04AhdnNhGBkMsW9Cmoyu/JbsxkAqLEi15h0lGzBhKv5KGFD8YQbaNNKukvxP5BhuxJFd9aFuELIoi42ZKwhwyCNWNLgVMVjYURzEi/45hWJSE49EVWQnQ+/M4ctSu/XbAVmpu8FZqrke/Ju90vttwbSMHFLxnjCUkkTGIqD1kFiO6s9rjb6mrMXu1FciShIFYTpqvSZESPhrdPqP+mQlhvS+K3i2lFAQSeJajPqZrLtO9AodxzGhGTVT7xlY04SeS6WTkfdrYjWV1k/sEM3g2wJiCdnasTFd8BAtjesybMtwaH3AtZJI2ZibeldsZIcU8EMetC+NBSHNTsdViuX0r1nRYk/6zVYmuBXui19NvUh3mjmvQXH52n2xrIPxh4ZbCq5OvGiPvvDwrvQ74V71yr5MQ+UmetdiET/EfShw+gg+ZZ3mVQapBkQd+a/PHSTZJhUGBoaw2i6ERhnLMGsqQ82GCDzlelJWjWkZ8UY9BL+8Yx9hVP0Gw3qJ3HNdf8yqM8+x6Pjod7gtXUeCCjz7ZxWF88TPMeNjfxpdZ+Myr/O0f83dc5VW0s3jLx+QMtluPVK+Lb6n9J0lfRD46DO8ncds1v0HPmlO+B6rk9VMYtSgHbOQlLtd4ibVDEUI8NvBu66Il3QTJuDnC9pYefVHuS6t+a/S9mlOF0TZhu+0SDngM+zaSnZi0dX2OWqTduI1kD5MsuL3MdY/bh9FYtbSfg3eHHfV6Fc3bApqeuYMqgRl9iMNw+EuuhK1S1TQmhcPvkkInFtwMDrkyTUIiD5p0ABXZqnUiC7UKKtEqjEGUZIl15HdJfzTSWZNR3LEIc2UcJeeFelwaIY6aKuC4SN4qis4+WW9rUO9p1R1HlSOaJwTX1nRwhfQAKlJb5KXB10WFNlu3y2RmVKoXOPpsyZ0ConuQwB1CFwwGWP88znyoy9uMHInt5F58Ap558hLI31PkVD+3wDD/SiV5yXIb6gTXsEypC89VYSJJ8sjow6wM44kBqqgG9ri8is0G7hK7Bd+MjCNM9evncSLySDfPjxCVpn7+91PmKxbN2KpCopLdqCCOCrpRqTgqNdNVFseGD43BErmBPCVyngJ0j+PVOXtUK5TFTtSvoWC4przt9j0tnMyoQCIKV10eNOYsXItFdcJe2az5Zqu01xyRNKduuJVtyhOArDpEjT/UUCV6qgh1vjzqyiH24hCONeVblG4DCXEfPM8dxzHqrXTbUiBluJK40HA1p+9/4wBczaHwd+GqargyvGIDCnS79zeiyxFbx7GRhAhPGMTyCxLmM+s7PhBiTPL/ArHqWohV/wLEqjHEqv8UiNVFMRXfImwwO+YOcQVCRBFfBNU+SUP0Reih7liAcLe6ghk3jBWQUi8Xc6QfSKqWviqtK6KKyUgz7zKR/DvOQjLW6ruxkTsV9bjp7ogkGG10lds50+MckRfd1LsO9kdqxuZAXa78nKBTHR3SUdPVb+rT1R+5ma4+5BqE1eZNN09+QV7yH3EVjrLPX9fNz0q769AwZvmtfwQVYY2of7mxTJBMJnkkDgiQ0yGiOhqzf169LQPf7XZXhT2vKG8MQHkTNWno7mhA5tHAdkyj+Wd0+s3BmGz2DOBurlexWwew1qfTJ8S2YeuNOv1c3yqrhh2UXXmNQmiRU+5P5F0FdBxH0t7uoZVmdnckS7Zi2XHNxDnmCyfvfBOO4Wdm/v208j0rDIplh8nvmMnxz3jMzMzMzMzhpL6qnt1e7Rrf8Rl2ehqqq6uLunpmOoKLDHenLXv0uQ5Q53WCgRxdNPY3r5OFFSA5TcjjBkeRHT2p9ZZNh8FLv+Dmzhkt4enTaAOFsmKUxo8EtamD8cnEbaiDMieh0VT9iW2+lzvVlXSS8C7xEHvvvPtP9AzwlVPhOBrcW7cl6o1/0xi7NHyWvtGDPOXcfBxP+Zab6txXerlv7eU+18vVc0GR+69e7tvqQ/Yhm+5AbJxt+AyJBTbyPbIW7x3iz0Lgjom1/WNibX1MrNEzcHvAX35N3eUpQ3hUef/kz5N4sLVnbPAjwA0DfgcAa4GWIo1z7PNnCWL7afqBAzV9oDGDTRvaVI7I4wRqN3q1H2+0uuFKuCCOr32BXFt9amnxn3jFfzFcvNkr/p3h4kd6xaf7xYQDfWukHu5w0mW6PVPer1DJ6J22asnUxyobHKt8//5CR7Ma9Wza/F1ogfNcHfwnhSYcZkO0fox13MCpPjc8xoIb3i3coKS9w2eqnXbZQLFs8Ct80wxX+KRf4bMjKrzXr/DBgQpVQwUYZTjq+o1mThZeqB5AkiiU1zY88trqfFBvK2gmrPu/ZhlDa697/F7/dQRaN/kVHuNXULg7Pbjv6Uvh+V6ri4cafdSTrvf2G22uGw0zkyy3veLTh2Ae0wd5665aYO8zlOkL7B8sl4XMY9d8mJsbXnG4jJtnDizK7zt8LfD+AzX9c2nqi5CwgOMbizYBgMGgUQBuCTz0ZVsy4Ms/wNoFg6L2M4V90jBseQAgYA2ARrz5avMPjtQAG43xhNrqrKKWHCPd5MZNVdOa2RRWsH3dbXuscIg69C8ZZ2rgRNKG6g492Rz4K5cEGAZ6DVjZcGzIP8jeOoYjoYW8YCdVIUYhJ9PrAxMOjwvWu0+nQFENu9Ux20o8uqFFQFPzwk0uL+Lb+WrzXGmYBMds5ztOqt5ocPep9B5o75kFI7/pmc+792+3EBgLcewul6Gc1y5v5ALO+/y7P8qLY/iLoO9HJcwcIuIbHGyHoetQ3rzTqK+OR8i1eRsDEFda6RR5dJJuGOHwvrZ5vGtVGOJKov/AfBlfDGDLJcRFyvKPAdPVGl6NJCqFMvQFwnvc0Enzj6NuI/1HsTGjv0qj06EBZQAFK2RzZPIbZIcKCjn1u8jkxuKmFPyUi6nhQnYaJzduhrsliMfyDTLVnAlyaHnWl3wG0GlUt+ziIx/zu3cJ2q9sRmbHSj5CL1iyl6EfiZqndsalm5yW/u8LHhIuBuUeoJr1PrgjOy8nVctp/Fz2EJUC2SrlOiegThXgM5goPQZj+w99KrNK5qpbJCB1nD1FPwoBVp/PP3EdIyce5Ds5C4FT/DykLoixA6Kmoe7JlTRVyOZV5P6B776odZrMnIFWjrCkJAtZ+7K6jRJlVMo9BBsbDKM+VTPtUkqpxgcb+jhpGeCB0gxebYvjhOF/lO1u0aGwjhPmFGMGJjTga2lcDlfkdpO69AmYEnMFB4z4WkyJ515Mo/IJZYz0Ss4Cc9mFYhVlErELFooZ1RpH0Di18HSsHp3HtrPFkblZBvrZxjkFjkJONsl+zAI2OSIgspbQaEyiEuwnncO3aymmyXmXd84Cxa7Dau2F556LL/wcSRPFJB3hnuwcE5KIOjpS9joCWltYmsJmFCasPvJID/4L6qV/DK9MPpk9xXdjNOWW9hbHxq6VgaN2RC1mIW6gahxPZgmoUEBRS0EtKShY16yPzhpN8ZAStysTUIdJvAmHivP1HJ07yhF2meDM1cR1Yk7EEmE5Byn8Zy21QoIoq1qNEYvLdbLkmqkHTLO0DoEUqoMeAXHS9pOmTu77TSf/pY11o1ei6zwSzsjSckZImCkJI0qFcAFNOmJaRa8mIaU6G+EgCWkS8Y/Jepm2llZiW9K91D4udhOTzhDVViMgrHYtUN0K4RJ19HV7KPYnvGDI/pQh53r2Jzz/ABYHHZja5AQXeCYHQga/9rtQKH2j89lho4NeDsXMdH/6BuZzIw0MxHrYwHxeDcxNxgQ1rcn3YZTK6ExQCpGF49AtOmP9In4M+6gyKQGF6A6kwVDyL6i7xGYCT5WbzGjn+Rd7+YWpvSguodoL+l7TtGtsHlKfrSoGDpWrKVG6OX6yeTKOgUL8iCKbwpaN0eNOI8hi/kOZJ9Hef6MM9ickd4t6d77ebVXjkpcRtLykjynj46DqBa4w8XF2O9f+oWh+PMPvTkejhHsVwYxU8yvI64z2sJOv1U1GGoW8VaT7OnL7AOmHteWcM0GrBXlYqGW1gcszhAn8sSYUyWbsLEAA9aegrz3cFw+/BqkLL4GXP/8azcHJqZiFRfxcZ7yqbxwsACfr6/2z/TrvdXX6OZ806i2hru4yWk7h5+J5GaxCK0Lsuof9dl9VxI5ZNtr5KqhRUhreAVrqwbejfaGrsIS+g7EYUyygy3VliN09NmJzRaqWvcBa7AFQUEb3yw10ZYsvJ8wV7R57PWC+nndY16Kjm/ZQ1Grv70OheFSBtojnIY5B3QZcLQrqL8A1D0Dqb4qcszI4NwG1jrPElwjyFFBQAdZ6pGSJsAYpEa4pST2gJ2YJ5RCzlBOoQJG0oJaAyH8kzBcw8jiANYHQBRC6H/fyiwRCxyj9haJ3lXH4YXoEwXHFrK1YNBXBaJ+YJOILqCpv80/+E9FAI5C4ZQgJ7p1CNqtFWIfsTO/1uzHlGPw+xswLt83nt+3SZbpFCE1ULS95n67hvPxWwC9CDZ3ICgpTrFGJSL3WSOMpQOgh/RX4o3+aClD6hcrlmg1kyqUKfR34pQPowMNy+b9yk+/yq9Lvu/y4WebynzzK5a+2L3QPw9s/15gdZNmVLwIykNcM5hNevRCCZQylmeZb7hF5VitaVwN3M1p/SuvPIEPqTwm9tYaVGum7jWkOx9Pqx5ssjIJVQ1tFF5ShHkfJVV6L5xvyr6rt0+VwLMv0IqHEYYc1cwC3Avqd/6sXsAHOsHMCQkryrwnFI10DxGrxRCBJl/7Mbl/XmUYnuP2GyAY6lVWOHwlKX2xNcpDjsf54dqrd1XH46JsLeuZBnRjI7x01/hqZ+I7ITISFBaYuVq6VIcUUSJozQxlPpCjUeLCPFXeLQD9wK5xOsTow1gkLWmRKCUCEotG2ILiDDvnI0AnqySWUC8ry73rkSoRcvvvyPZ3CDxkTLUH+NCwX5M++vhfnCJ2/aOVjREXAAiM5lpkZDnCgJ7OGuM01hTWY0FZJpUd7lwn8XUN8SfRpJLSpVydqQAyFuITe00YRDvW24owVCfpPxXgkgysR9wK5reNKATy1tMTUO7cUDLvrChmtiLWovGEhPCy18c0htRH5aiNapjbQS7Akbp5qiFpLigGXaBOTNf8WoDqtiaa+J2t1jA3RzaoQ0IFcQlyAy0N6yinMvw1gB9JISi8V8EF6RTW9ttQRfonwmSLk2RDGVdEVwS34li9lqPMhNYyL/RkUGDdRA0HDZh00zA4UNMRQD2+ivj80UdafKDs0UT4Jf4DGh6rUPRYMB0lqa5L6mybNA2+ayOjfbCPDcSH899d4sQq2ilWRiFdVNNX7W69tCWOFARYGmhpFwnKMiYggEl8R3IEDk8PZ0P1O8j1qBrVGI0F9jzSqgjn0Wh2jfuN91G1cz15jZcUBDPTJTXldIRSu18haSjHCup+UKOs4ZfmnkNIJWM8/6AteY4BtE46/tcThUxUQ4t2I0L2dC5j6TQINXLXIOs+HYn/j4FGYXysSpVZzRm1oToFq8xAX+GfqkWj0KFKRC1XkEhW5oFauZKGsoQbn50uNNRhd0qQ/Mibbl32aGbRPa7bV9unt//q4t4k43ta3txzdwSUvEmHBoql6YkxV9rja4pTS2pgpwABxYFiKTOzZ2wCYyceX9WLO0vx2zxwjLiXfF4zFJ1azvKZnlu8YNMt37scsb2w4layC5ULqjyrBykhXnbkqvBC3mWyni4JmRcEUxD/bX8akXzRmbF8UzA9IwSt29yiYKQWbSsGwaI4g1RgeYB1NKrH8V+5Wyx+JbVb/PcFP3HPiPYJdtXuAYFfv3jfBLjdG4r0co2RK6OhL9ep6riHzNTZnno0GJZdkI0XZ6psxhGvuruSuDyGj4lECMG4g5+anYxPvGlK1a/zo+Zqh6Hl3fzYxINut/mGbNAvyu3+alnHn7oO3jGAk3zLKqJwav8kEUMfBkHkMRRlDeKZ4eaa7TQFFvZhs/dn0mELUaN7XSpWEQhSClVDa1IbqXUIQVeet6ZnZlHSHcRfGk/6DCXyjcvhbfWXY3+yjEMbZ9qzQqb4zIIDBwzVsRJqGYYNkngfwU+G1a3b/7Hjt2t0/RV677teM167/leK1QgmLfdFBuh5T0/UBjepN4EM8kr4TXPlkZK+u3jwiM703D5tZ0ah/iyi+gbkJCu6QH87HGAL2SdJHCObuoRRU5kIy/NMtg5atH8QyuBjveSy4SQwhfUcRjy/ZxXDJLLaWgkVn+57LS8eojuvK4vty+bjv66qZbTzJM/Pd11WdCymZex2mnPj/xtmyWW1la6rhvZAdE35q5E4eUDkuiJapeJxnyztLabfIHMrExSgxC0VLvqlFAf90q5eiLRZzttqxULQFjah6b0Mm/vRacItOP5ljfwh7PBPV0uaWHDaHGXxJkadkKT8xwARxGVBIpKDDBRDTDpdRogEGty3TlrMsyhhzi8cwjYAuslSR4NIAPCiUz6rGb7UaHiJQH5lQ4LkYhYdBSmPVVmzAjGOXEWTjUQcY/ArOCHio3WKCAgau/cyBfTH4zB907rZZUt0C06clEzxQSBr+zCm+f9CQwfF17x6KNUVWbotc5cLWH7qd4NHvqN9HWsGjxaR2IR9i1TFWtNahZ5TOQYkhU6GBKI8JuAR5Mk5qg5ptrtvCd4cysF8m852eulP/3LKhmqGxLr9wceox11z+mt7o6vImTVVPuxg1LE2RPXu2BPf+33WnmsVTzXWM1LFn/t+pS1df+Rom6ZcuOnuWL0+9eOOsg/PdJZoE4H5vi6j45OZGVJw5e7aYRsQlwI+hSd41nS1W6kysqh7MvRYz1UNwOcKbFzkqTvde54pZPW3wucqnTSUOvkaxhiIQd60SBckjaRz8zhPTp1NpQT1lWvedUMdMUFCUybTiDnKRiQzQkdQ7eSWSeY4pp9yNePsj9t5hX1J26ttq7813wERIdKhmBersKYea5ENNLKrmA3zSBJ+0KYFUJL5UKJ9E+mm//eDzur17FLjSAEwFcilS4KGcJvNHi63tA3nthr3PcEl67V7B/Q5brnvJzSCc/sV0bixJt+gyICGLW7EMuNARF5T8cz6vX9U2zVxQFGRx6NY6iTbR5EBT7PSv4ioqVUUPlc9u+Ccc67EOrLyuslyStUzNbRsoZ5SQi73KojJnt4yrKrLJ/9v19MKCybyWOq8r3IRaVArUpOkBzu5lTPBoUiSKbIwMiIdkVEYuZLGQ4rCw8JG+VF62PDiA5AMCGOPA8Ez2WhtBNXYahW9jUZFggRXUxty3Ze5LeY44Qtb5atkLOxJjsn5HMXdkpSPtRDrgNqNnj1YucFWQEybWJzX4gKZvpnhWiQ4YeU+D/F2rIaZgHFaAL3ISzYKOjDKdCKz/OcC4SRyHRcjYWu2+sFqtNxVCTL023TWTa3wu/+GqTkTa1SI0Xgv4t0CjRGi0mtoKtgYXa5vFZWeCxYMkkPoZFxcZTarJQOt+U9TPQm44W1jFljsywGC4XkrYKMrmxGa1uKZT5LC8K5BJTVHRpfQO0yjG0rcxg9bNuxPmbf10LM+qA1ieFQc0Oy3uDfqS2vLUe7vIGFvhDppS5eJpu39SksvIJTw3qLtUX7gpwcBeMqTKLM/OWDHJffTrSYkGsSfF35HE3cmWPgsvMRFtOmyghLZMgEkmgAOw62JmUb6+6yJ+v9ifBOsZUrJqQ6V9337a6oqLGVaJWH68b/vJhIS4OFwlaRZAmkxkdJDIOk5lkr2guPBo7FPOwQOEGByZiLOkYMRAYvItZwifg2ms37zsUFxDV/csFxPm5TkGuhgdd/yOlZlEoHy02XRnEKha8MmWK7olXM8GyDLKfbOy2ylqA63Aib89ShKgsys5rIw9hNagXECEwe+3PG7XdQ1h4wmCT6mCYaudj6/zVUg09zovN+/lPsbLnZnryxKBFC0on1o1JypEbREiCNBoPDwYzaHjCb+LF5f7UjUBUk/IS1MwBOy2ol7PsoTt0DQa1qT79Ia1gKlZBWcNlNU8BhkUYmvnbtrsYE3xeBy7iT5R9C8eRB9tzxnkPQU6BzXqaKE0BGHzOtGUhAf3bwZOE0SwM38aty1mQZLo/sF3jRp9U1gVGpYfGSSMrsiFIpLVb95OKB4VOSfOobK1xmB7nbh4OSpoIaoyVFWp9pvvDRfUE4a5dgP0mjYHHwDzR9HM7G/QlA2YraN6M+ZjL6JZdHpKkEs7Re588boisAapZUHM9ctpcarBFKyNaJqZYg/fCIE0WGExfOsNartzBwTzcr2MpBRYR7PXXTK4aVV0OZTf0dQRiJQw+PU0rTdOC04X0I47oKsspNJzMNGrP7jEkV2WHf3up6VLT9lO1/3pPAkJlIEqu0m7UNijp/0o+ZS+zglfFYbfPlXhkaVPIUEqIZ6ho04McjIovcWAO41OoCt8mlfK6SYm5LlhvdmyrkoW0vdaG+yw7hMqBD+QGq8q7am9U/UbV/aM5t2NP8Pk6D3+LF1ZBFXKOeaaMrzkP7oUnnrsdfyIL4W/M6sPTqmFROKuDkXdzZ5Bp8a/d2D1IoLZEAVJlsz/XUPBVa/REpdZGW76f9fUOCVXUgzjfZVWJIMbsoucxnNd3SJGv9xkY8tI1/dwdxWAjdxK1LvadZxssAwf5C0zc3MO+MrMzMy5cptrUma6HCWl9R6WmZs4d1dmZmZmbnL+70m2vM53mesNaAWj0cxIM6NRlPWQxmSVAjWMqm+JKfjzSrsI9wROJxJsn319SwLMWvOSCVbRAjgK4FJtl2+szQAMIckdQiABfmmDwnt1VkYCQVOn3Sqe+Yue9uRDKguegUZIJKdj8m7zt4/3dub/voC5qbbm72bMT9c2lj7+7nv2X3rH11Nhnn4rtwaF1IzAjw/YSUdxMI7cps2+S36TDQO/Aq/L7LrLPDtf93Bj6CcyfmV6riXSKH0nuyttjXyELl7gSTbwIw2SiSHw4J04njQwUrsNrxGAYZXASP0oDKF5O3DN6YXBipaOLfXWq6kZ+LEClF5A1AINUJliLgQaisSpdr1oy1SkZWPZlo2qZQdaOh673rzGigCobCoCeLksgJc1gGMAgEMxDwd12xmfqLCydMG61091ePb2JzHv57HO+gWscz2DZe93T0Ww7HTW/OtgGfeUaNzXiUvKHSUasU2NaCzd0f7MLP3kz72ju6acW/vOENEwueSPAH+qvGjLpkjLxrItNWdHomXlEEF3foGgO97QAbBw7v6igH1cTraZSzQcoJHwoi2bIi0by7bUA2hHy4rfbqbi9AmOV+lByFjGj6EPpPFLR37iXP6EWUaNwrhqWuyErB/jllacTWyNqtk5M0X1Q4vgtMxF8wX4ggxVAi4IJalKOtTEXLiO4FCKNtbOUJJaGdPyA86zHdb87uH7oJlVf5YKCjvUrzKZX24216PRipIlC/eQcIC8rx4QCotlKML0+amr8M9bh4FICZ+sX8Any/v5M41DrJDAheNU+iii5w0LT0lR5bMmW++UH0EMI0DGwQeJJU+be8JqIYorM5CMjF8OXifgGXti9a04YI2zJSs1whoKwbKfaWvLBXqOP3qVEMUVJWAVzsgA2mSJ8w8Ygxg6BoquX8Wul8cfSOXq2nCIb71fiH8pmGU3+O3Qtr2oyuyPqMzesipTr2g2w8R/ywFzcTGHqx1vcjxOG89qt2jlHV3m+IuWHnlKi14SYVF/N2NiTmyRN6D7PxWb8UZA/YS+CKXQT4hUuv2Jh7ZZ9Zk3GsP0e+cvdtqbb2zTF6gK6ZEzr97ytX/fNSxMP7HztLkDa9FsEKYnf13f0NBwbCpAeu3N+bkD2UEypre/aeBmcxXsmsf+zskvhxY9GXboE4Oky4xEZPPbgada68Qsm7RAPaJZUYCfCsles80PZuDdRWZ51NHDj6KeCSEvQQZYO15x4zpm+kDvYI4pAV/AMUIenI3ngtD7oA8uo8U5s98H+N+ip8M3njbHftO2yAaDsyH/8ZVP6Xvn26m9Yfr2q6/rvfDD5LAATQY/tQar11PDmpS6fJPzOzc8ZlTf4MfMx7k7KBv8sBT542EmIFXFH0mPHnRo/5UJQgT12Q/wziu9BuBSy7YxS7S7Y2FmtuTqOBeuSUAalWgOark0ijyk58f63X4hc2mjZJeeEdD+EIYEu+nT0QGQMpnZ3alEY0XtqfFjtaJyVG5bD+cDzLN51Zv3pqjAlEZUnz85rYuemmXcxq2LHmwun/i6I2qI+Pa8PDwBFAiav7gEYNgRe2Wj1pBrQ9Jqvu/wpM3FNJYUuiI/X+ViJEqxIba0eZgBTRQm/TmxSXRnW8DvjiEHYkl3eErzq30L4JSd9iAvnNaTE/tc3iJPks4J2SIFOOujwoQ1KKPV3UHHZ32Kstx9zdm/opSpJRrbnzf6icCv5OKNlTdQ67sUmQiYWFMwAXAFs9iuIvQpjFWygpJYhXoX3XnEw5U9M1Ih5Q/v6U2GvTTLJ9NhUL0o7hu72xp3pYKQIlh95RFn/fuOtvtTW3f5o+df+9GUkj/kO9+O6+7ufibVpeTzjXy+X0W5rKJcBiGGVsSeWILv4UdLDrhvNYZBEHi5KJ/dfwCfNXPIs50u2mjW9GOaZ7+G/QkScPaj73sOoCoDMJBcr1I8T/w0nnua597vyHOPPPeKPDcoYyFecbFPGj6buXVjSIyD9BOX99y78uhbFf8DL+u61jFkPAXAbirD/lOb2jWTLppuaRaZwFGUI+SCsTI7O9oL6XM6O7apsQkzGmA18sQlLgIyB57GJIAZOUvaRqjKGLRMb4yy4voYGjv15fb2pKUE7XtYHcDtsgNpZxgwDs2aCfYHvlOwRtzQj6PFfYMkwUNZqA1F+SdSgXTT1S+MATfuSTFQSV0jXcW8pV9MT5h/7empEx++8qvjjr0xpTg3ZfieyhopUAFAc3td1fpe980Aeu+Tiy58QtttKeocsFS6gBVXsHZvbJkImyX7wPBHDp11k+uzgIUKfgUZHpf4ZYUBHiV0jpJKW/3IFMdDTqtoTpRHZza1+4mWJWgfxtr4d82Vi4l+RolkQlmNsx3SPNuhN/p2OrbytzNblnwTY/RdiUo3qUoWquUhHXH8yKwqmICCjCQclYLwBwweppfe866uLT9bUgmgS0UeaNLaaauAokI5pHoe/l6eztsuvXGezjYnzt3xNw4F9cJ0g/XJ/NeC5hw1BHiG7eoVjN/K3aQDbMQH8mUEWnKwen/Rbs69lD3B0fF7rC6viw1LFSXbacFDDbRC5WgEVhXbZjfACJiMTagzAnf/Of3Qv5wx9LGjM6XwclNL4IveKeoOV5vHyj/+b5vvgJTXgoAgt0tVXag7PchIlPWzDHY5qaml+ZDtThadT29OT9z56pRLrzk+RespcJ5K7HsZk4fecVyuN/sgkx+topiJpAqAHKqD2t7jti06xMi8v66v177Nt5r/exiDU9FHWgUSiuaHnr5ljCKhaB7/+h1fCNxEjOSoS0cPIGmrHUUe3RioWLcmbjbAdeUxastN3RLXMZpi2dyxTo3gq77G+LrXsmMBmtsuGsjdhM5Th7oOCKP3LG1e4GnvmxRqouvb4uuYWu2Sm1KjJePyi9o3PQaSjRpAa2X7XOM7rbERy2Rx3yDmTOtZfdkVRvtuV9JhqaOf0ZDceOvsm6xw6+jWsy9ZdNio0V1+fLS+bT7eNUa6XaN0Z0SXRhZ+1Y8nMdk7QTleyDsOhtDUzpNPE2ZDLX+cRG3UoDzX7zTPdRgUWUI6e+7L/6DlDIkdoCvGDtg7lPB4JYkO4wauiRscIsWIPl1gwgZodQj7Fm1Qh3MeMkJXkRbS0Jg6idGbQMHe0tGBAhQRQ4elOkigwYxQAQbfBWgAV1EC10QJDmN0z4Iu3ktCitrWwJUibX3AVocIit16FwjB6SvaS2IuVkvqlCn/L3pFHxI1Lrlz/AmOVkjTn396pthKqYhr7pieQ1JJn7YbYFTHCTwv+yc17Ta8ZCKjZOOll3iifu2T+7FPK4YqtP5PCLk0ci+GSh/tmSFmtmDGzOMWy5tejN9h7lIQgwE7f3T4Rt9Bm5c5I7EEUhjTh61+5AofrfJuI22QEoEMuRzoJ/3wxL4Re6+0B3yYT/Z99I7m3lvhR6UXf3GBK/fZooGzvKu3D57NHnSihmmfDLkZqDJjp0g3M0GKTBBFWRbuPdOLAinjVSGjfhxfvbe1ny+w0No/18833VDIW2CHKZff5Ob9/og35wBbUwxkodqk0E85Dy5MF3w0vTcAANJRqTJ+HWoXPDnqkKJh0qkUpfiBnYL40J0CR+8UuEZG48Wdgl/gqBLr39tRdcOMGqXzPZ67O8Rzd36t5+7Sc0eH4q9MECJo/5EUSQqzUyBKdgqE97YT54rIb4G5Vpxpbr6KTfmLc9kFqoE6PJzI34vBkipps8TL+NWyemd1Yj6BXyzuNgvfzn6NtKOvtSP8OrMy4iPFZD3hdoFzZ/hTLK6FJpictMuU1MwrrclJi8zbOQrQmaz0Yncyf59Ct99g+iea9SVvdUoRxbtLMitKX6tKX73i6y41wvuBofAD9KXNB7m2yQXq0uKD3PwQrNIhgG/la5chRWRI86rGZeo0ROoA06QgTiWEI509xXXF88A0YDCDLFcMz0Syq6WbZNhOJrj/HOMvhj2q+eYaWfO82560bH0e2PsfZ1YNLEERRAe3lLwad49wd5cE3erb6d2d+iNH9+ztP5yMlJiciDxA8ipcUjyvggTLmN7ZO1zPx97rfi1nH35yxL1v4DH9a59du/sL5pXvX/z4JPlmGf907dd00anPn/fUVcc9dvJlZ7764lVvvfPtUy8dt17GL19l8kCQceVJgKKFnBIQst8aWLtD8gI44VZ3MQGWe0zQMQYS2FI2OXlijK3OZwhlpoAd7BHzgHk+pbAeuacroMwL4IqYMbsUITEgSEBfkGBy0aZpxpD9ZIok5hHi6AqyELsy3FCbE5vFFKVYditnBPVq5UcGjHYedM5n4sWivc/1ZFeA/otdHU3EKon8BiZ1gDGpUrAhlhmjA59CIH8FCG5IiQNgjy6aK2ewPUEV+/zZ3rKTsVcHUnsgCqLnFsIlBguvErgCbGmdB7NC2yAzbptIU+Mp9vOkuLaRzC725owLLysP3a+jPuBmRpQBeQ0uFGa5oo6ufohHMk+OaBnzyLSTO4ySYUjeFvJ+yOerGXS4TlL2LBJb13XEsNrOutagIHSoUdPtl1ZXNWtWBN3oPVBxeztpohVxbqUUKLNrz4dpcO1QYIqdMuMytjVCY6EeUApKpOq8L5LBhErIaYrgIlzQxXQBHba01kMCIVn6tf99goKFXZ5zhxxrHZhWtW96ytkFOvvGu+698c7m7nvvufehe++5/cZzoEPnyZrfJZJFVc8aYLSglFSTz7vgsnp9ycXzRdcN3H2DqSFqiDnxvzAbJpcHCCSi6XHqGXKqKRo0qWsYY0//D0G2kin8Rxvq7jOcBvG3cOUsmOx8npdailmze6xFh4dOADMs/cTJnAAU09irVSHxVqsRzAbGNeQEpk1+DBEMdJzCLxhOjWGqefUbiQ1MpEkp5//1jpgs/d06o3UOsBblX+9b6lQgbfYVPC+sBxSqL39pKCqsk9oFa+3j0swqqcewsnjuPXXNZMYoWkLdGOd0rykW0M6dZtcOi7pBFrEs9UzlaFnfvV6axq+sWKj/bMWVMlg6XS1iJmzLLsX+mVG7AItijRoAjNcg7G7CQkEaFGHgYDehIA1rEZewEXslpZcwaJRuLMpZZulGYMEEXMqEGcDA4vLvvTs89/ubfXLmnTjn7Hwx4SKpJSnE/409Whp7QDT2xIoheLhJTBEsg66RKf8x2we4mLDun/Uftu+KNN89RJTCGj9ZoQEQPM37BkJjv6qCIbf1zwjmoY1rVz36iQlm94iLmBDsplZCcpj3QiRxGfufdQzETbYvPO/SSjjp57YmHFkpcB3Ev8t5Zy5pJVptc2J6PN7iglEacdfzN62LWgie9rpQ+6WT2IKViDOWlfgdbiHqPPbtUngxV5A37+u/nuLlpTiphdCY6tb/eUubIH4O4rvsjfYlcQlGmIFXxX1Jwf5xiDPvRLTv5BIhzPKW/aarBc5EXLKzsOt9M/FCNi9c/NIagTMQv9Ex18ynmYCcp7nzauaPz3UQd336a/O6ZsLl1cG1q8wWCPKXRPyOffGdqiZikuE7Ozxbgq4Pmn96uoVtEzGQ4qZSISFB1+cLkn/WD7/JTYSN2eSRspQ1gv05iLPOdK2KbyRmTPxylXSYJvA4xBsfha3WaSSuyX2Jyd8wgI/LmYjrWDktKnhKeGPh6TLG0+n6IM5oq80caCBWZXtF5a2RpeuD+ICMs7B0AzFrFAz1FBbS9UGco+cgZVFPLLWreRJcKEW3C8TjIiqHg+oIVY9YO70L0uNz3mekPnJnvUpqiaA8P6Uc3cUC5yDOYepWf64hbFj1cFS3EBMcE/GcLgl8ZQ3xsXhH2zH/1exxORNx/S9RZgeqie6W4kkvm2To9od4o+TxuGtVhOjP19cI9lj9EOfN+sMnvZIw2XPwNOv1OF0SPf7idzOfVRA2XQ/i/+yZRV9/aH2STyqOlhOb9GfFbo0RH5/zhpD873b3rikngsyFWX4dkgLnIM6sdZTdX0ZgrmqHi6ct1BqXxyHOEpf8faqU0DCU3u/lOkj3b4gPSHw/cLOEECk7tVAxYBVdX8QZCq0yecXErfjZixKY8uNzHfT8jZevPucQX8zf37hlL6Y1LpdEnPdaKbiPIIZU4i0Mz62m64u4kCy/fRQRGL+hrFeV0RqX8waR69c8yNAKJ6YUWZsYT1tO1x9x3h4Np5BCoirN/L3aptVa4/I4xOOUnm0vzSfsDinsX3d57viciTij17d5IJd4dUaleuPtNXT9EZecAsJLHxPGVhWHzf+Q0BqX66DxL731fPND4s3cH3WvrNaPzyURZ8aTG47fJ0Tjg1ysLs+j64/6bI6iWDYRHLjBPcZUbnzOG0B88an2LenEvpPPei+6LRufcxDnKH8zOZtMkHeHVHf8Xs8el8eh/leBd0w8kfbXmq95f3zFxuVMxIVcZ0S6xRI9olcvr2GuY4/LGWh+rcJLC24Tm5J+hhoGrKXbF7r/75wUThARlcT9dln8DT4ul0R9loMM7xrRo/NqOnQtZo/LhWj/H37jcg6FuM+5+bOY8F42OtyhchZdH8SZoSaHJFnQPNw1xbxtbH6F7l+9dvXuO6A6zUy5ME6Gjg9xnXc+lpvj4ODzQQvO7An09UEi+8u3ZNkkwNoR9rkzC9bT50ecEzsvLSwFrqwxa7x5gc5fB/X2+jO1GSC89sXOIbsldP1Qn8JR+pgFlzSr9bRnzxA4rx9p3zuaNG/fh8iY6YcslcfGR8R5Tclf2Q/hue7rRKsquv0xEI+7vd/sw2MQX26JTbGn49dBnPNRjCuUB8r90akB4n2YYCXiOqaWVioF8GonW8Ni9kq6Pn1IfJkBVX8+gV67YVkmay4dH+I6+ASTGzhwM8wqmnaMzQ8RlxRz31RZBLztb7PtOHJ0fIjzXm8Kfk/AiNhdvWeqY/076tJugQuLYUhYrsGVkqLb/ydk/Fp5VTatGFTD1bcFJtP1iUOc6TXtcFMJ3H10vdYxeqLAmYiz5uf8Pl4KPqf3rkxRqMAE8SGeo+KuFVwGrrkjhhfc6f5dEvW7Pb3S5VB5xb73vQqdP+/jvz7Lv0jXuAJc5bH1fk/H5k+InzznN2egAjqlonoDZo/9/4jrb/MM8KmEyVuDT86yGbv/QFxo06fsoipoWv8hzVBLmK4v6sNtZmbVcGI0zmTtkDDd/yLO88X6Q2vAXuqQ/tbTdP/C+4DMf8yNXyjVQlpnhm6A2jSBcxDnaap7N9ZC7hxD07K9cnT8iM8aqPh1og6aZW+Vn+4bxAXxI85qydG6Xw9qOfOHZUZl6PjR/d+NzjjYAIpfNjOk55RggvojLtTek/m1AWYHPjk+X6oGF6xDPOeh47Lwp6D4ZlpNX+1Suv7v/3WT/Qz1U40QrNu/4HXUd7p/R5xx2FaurBE+fMQW+C2Spq8fxN//fX02wbKBxKMzpOj2x0D8e0athUMTXF+QOFwfMTb/RNzO7Gg40QR57J0G/Ulj4yvi+TOcts9rho+FOwo7vMUEznuH1K/t8kBRM3yZpL/nZ5QMnR/iDG7n4Dwu5GNS3Itd9P8bh/isIhdbBy5UnR/MqXeeTeeHuKLK+QMlXLBgT8k11FxEt2/E37eufLS4BaJ5rL4NPSJ0fohXnSoJONUC557ZijZIK9D9I3r8hTG86hZIeCG21EdSnm7/iMepC2etaAXTymPXTxbJ0/m/Ra7PqoPDl1qB0rEk+zMl6PwRZ5i+Ybe2QtvxBBGZqWJswWtWWx0BqvNfjf/9XMGF0NCMwSOGp7HZ/3y88wYwQ8FLnWDZhU//fi20sDHB9u+3MnRSW8a+jlhVJvhg4vGXaf98Q1Gnv6P5788qPDR0I3nPjeC/jovOxI0lepqRmJrKr1StbxRYtr2Imss4hR9mnteO6KOgycZ71kUrFu55zfn9/G4K5n6zVTvQ7I+d9ZzPzXlJwc/AHyuZDX54x7f2dQ6NFByuentYd5iBVUWeW7S9koJwrop5TzwLc/9cUaNdRIHTJXfLpIjb2EyfH44mjyn4TY2ELHkciA3vPC0bksE/X5TCSa0ibexeE1e5L56Cqc4sH9WJf+JLuX9l20RSMIOtIHPg0E3cwHxO44RQCow+6vpTTH28TsmRw/alYMGX1oKV1cE4Ty41K8KNgmwjiw/dXCZmEJhYdeciBbtCEz/OX8rELxlcwfJPU6Cl3GE0IBGEfwzwV//xJwXEwbng7+OHnas98cn8KAVrPs12iXp5C2+xmOTBM6eAoaChPdwXgaUV2Cl5G1IQre5V6/YuCF/+8vcK/f0UBJQmbdt8whd75n/khuYOCq5M6smZfJGJ3Wq7ErwbKAhLSekeCbyFqR8553xRne+7zg4tsvLGIOmBXoMSBUPvJO7I7mRi7Ze7jm+XpcBK5BRcyr+FXz/6tfPNKgqU0kWdOofdsM4Oia/R4vz6EyeWREpp4ayXrxqvLaLgkdi0024b/bCpE3uSPOdQEFTb4BMyzxk7pKCdmj2Ngtz0nP3n9rtj8/OUxP6aQsG+sxldE7Z4YUov9v0+OYGCPd+5lpvag7DRBcceiPwmYZJ5oCYz3gsfjA2xLv9Ggp3+3rr+PSF4barGxuRBEgLlDJZ+Fw7HbV5MdsrqI6F5Q5j2+6ZT+HBsr+rrdyTMX9rwcPHicLw3ZW6pXDcJTvtkknfFemIrVOfsS+ogwdd+7UXGnFB8GTNj0vZXJJj7LNwVlGyCy8gPS4k9I2FpxG7byPWX8dsp+i+/NpEwO6OE0X90Kybnc5gh0kACdWyKpqjNLcxYaHn/5hoSLky8+6qzzhlrxIof36sgQXHOTAgcDcU6uM8HZEpJyMm++KSB5YJJy2xofUWQcJ5n+Im9PBSb3j4S/gDn5xN/Skg1LAhPXh/t8qCAhN3xoW11Hd74Fpun917lkmCtPpNd0eGKu+lFH5J9RMI3i0t9O+Z44TNDLGsS7vP3fz6yaLJaKPZK+vGGndkkTI70Vci7cwkbqbzdMieTBFHDZV2dR1nYOsNd7cLpJHysWKzvWamK5e0w9V2TSoIa55jsW+UwbJdU5vwTySTEuoQf3tPjj4u2uRR0JpKQsp/SLFfxxz2NNHKuJpCQ9UHWx/WgBy5ZWqe6I54EE5NDru0NofjqFUZu6vdIOLb4KjNtljF2JnVfi9FdEtausCKoh6F4veY1m5g4EtwKVL0z5/yJE6+mnpvDXyZTnfIp26O4wpLj2INYEgxu8Ay12pi4R5jBjyv85afaZlePSbjiZ6373p/jL+dc8ePsIb3ws9cTd0Xwl33fGokrL/bCq223HPrEX+a2iFrVRrEwsOzQs+cff3ni/oI25Uu494RPZ+bx43Hg2BqO9IVhysWKE/r5y0aOz9I7Px3Hjug+3fCZH/+Wpw8Vyu/ewOcs0TaU5uerulFzMNc+FJ/bsC/ch18P8dHFGh5WTDyzcuWOJfx6ORuffqHfEob3h2yLfJlCgpDvDHPbTBYWbuP7sjKNhEcfB4oV8gKw13EyW3ozSBh9Vx7FyD2O+297vEA5m4Rt1p9N3b9dwjacnx+edZ8Edy3xZAnRULxiNHiq+SMS1ok7+uWnWuK95fU5G/NIMC1gXf6x0hGfeaCqdlshCWk/vqzYujUE19ftiHVjk7A30Oa5Y40nXihcc3KQQ4J0Q7Ds7+xTGGsg3i24jIQnZ8Q61ZqdsJUruxcfrSLh6IojKyaVe+PHey0v2dSR0KrU1e21zA9TkdvTF9lIwvwnOLfpSTBuuVr7wcRWEpqVyCilOhZm8lBxbsxLEh6anXH2sPfAiJELRg4d/HyjA2/Xv3HDL37mEg789uetUhtyfok/lsk1C499T8LPl017gi6xcJvcgHXCJAmFWW2HXpYa4b/m6+Xf+0yCzrckrRkJLFzDtDfg9A9+/UMz1b88s8N3Wv0achklQc3XxKGLDMb3TLmrmDOZgvp2a7Hno2ex5uK9LPFpFGTcCfn5ix2Mi4o/Ny+ZQ8HDadmKWc5nsKgDnu2RiykIG4m1UO4OxC42jlqnS/K3NxVtCuJ5YHubjOUHpSmwXaKrnl1/FHv8bkqYkwIFdotDHNc72GL2LKpNciMFzY/r3Bf5MvGfpZZGU4GCEz9HwTIzCL/sI7xHbicFu1PPqWdNZ+FDPtNFvPUoSBbWSvKMP4t5J/xqW2RCwcwVOpIxwW74HffqBd0M/vlDilv1zQIxT+XXE9/aU7DXYUKGqYYHxng04bPUGQoktB8JS7W64daRl1RuX6agevpOzQIZH3zd3a/zdnhRwL2hwZiUexb7Bn7v5FkUnDodbdBX7o6576v8ZRBBwUAwN2jOcBD+ipVwLzuBgitnV3bdyQrAB20D5XZlUyAimbYZLw3EpM0Ok0sLKVD+lFoaJuuB3S502ChbTgHp2aSUeswX09nubO7SSEF/t2ZP4cZAfF5RVObIawqi64P3a/qcx16wYq4Xv6PAp47xH8RbBXgbO7N1KU2ZmRn/vAXja7yrUNuUmVuHoczMzMwYpjKzvUmZmZmZmTt2Nb62ri+TPh9Pds7szBkp7id5G6/UTE09X/SYVi3t1U/nUI7jeE7gRE7NaTgtp+P0nIHneJ4XeJFX8xpey+t4PW8QOIEXBEEU1IJG0Ao6QS8YRE7kRUEURbWoEbWiTtSLBjWn5tWCWlSr1Rq1Vq1T69UGDafhNYJG1Kg1Go1Wo9PoNQYtp+W1glbUqrUarVar0+q1Bh2n43WCTtSpdRqdVqfT6XUGPafn9YJe1Kv1Gr1Wr9Pr9QYDSDRAeQOkNsBtBnA17W3oPaB7qCmya1g3VQOeM5mC+/cPDIrsy/Nak6lXRGQXk533YwJ08HPnwF69fjFC4CBF5M+DoKj9aaD1wv7IFS4EztXTZyB4vnO38MjgHw8YrdfayK59AztHWoPD+3SBB4RWp+D4KNTmcHyyaXWIPft0tT6MpSF04P97oNZysowIfyudnlCrqJzH8B9xWQi1SjpkmHH08zcYO+Wjw4ZplgysSqbHe4SeVgaQw0J87BC/VeTKyEq7Bj40kxWdQ6f6TWlHGlaqP/fymBVk2PY988Zmu0m2F5q2rvrpd+R/2QZG5ilwlWDeIQdvXAx3W2n0UaXetOa/VSC4a0ZtMfIkfUW/rfnaEv+zTY4X/N9wsjn70O1bxgwnxuDVSQ9j65N04W7FtJ+mkk+b3Fr6PthACmyP37Imzkwad+iWgRs+z57/ytKViWU+V5EGnSjT9g3kn7iyw/0dfXORKicSltSe5kV0havXH7OrBbkjJU2dVqs2WeymjvYP9SKmxBeZxex9SLkzukaD204nD3iP2CFnJ5GmTzwGd3nZ2p7/tW/zt6cfDJZG5ehr9ob8yqppHza/TE9CknsM0w2uTG5OHVYoaS1Pvqb2jvevm59cfnxm4s5uGnKm+of8s5qYyIVLMWfOu3chyaMLXxzYqT2Z2bjB67XbShN2/l9Z9//yNsu7AeExM/w4pe/G202P7xinFOj9ntwrv0/puPh46PGEe8qdI22vJlQPIUVGnz8eNMNM5nfYvGZhS5VXkcVjezZ9W8Gr3coi/U62LO9VOCU+Z+SHPKnzo6KL+nzctPPZsNaHrPnrrsxw8G7x0sqarYmdu7wJUxr24iP39p6jLEn8Mv5WRJyyLk+bb+saNyOG94Pu8aWWkSpHQ3KUynWCzDuxLaVLy/ukrnbwsYx1L5GMUd8+e3RbpzTcP+1U8jGNudmTVY0fQf5vF9KLad3zKhcLtk/r8bieYjpTuNapcZ2Vt8XambaGdVJuh586XO5MLSI95ZVHOceQhYOn+jaISCEJzUokbFu+kdS9djrHwB1LSCk+a5XudwOUkxX3+lZ8Mc6ce03tGVOlbZaLDbZHjs7opgybHpF6M1lUUurkvhpbxU9p0vWYQWvSKN9CVvWfON5IthUfeSliWTfyLsr/aKYV40gV5XTtCsXGkdPnJc8OQ4NJp/vF7o09m0/B85GzVRH6aaNWT20HQr/bIfSMT+2tH7ZiQS8bvbquzSa5j7LZz5N3WK0yWXhntZVr1FN7Q1Sffpl7Ubse7PnHT3WvwfY6+Nis9VFNj+C2ph/ko2rjZV5/Q/EpvXfjgxqV3Xw7P28d2KRfA18VHTxAAIgANUADYDmtA3DomGuM1QMMgP93wdUAeAKMLjgJIAOIC84L4A3wccH5AvwANV1wtQC1Af4uuDqAuoB6Lrj6gAaAhi64RoDGgCYuuKaAZoDmLrgWgJaAVi641oA2gLYuuHaA9oAOLjgTIAAQ6IILAgQDQn7je+7fusYRCggDhAMiAJFObGUi2kY5unylycIF1lGEHDlsHfmpzU39WQjemRvQEZAXgKMToDOgC63V1YHrBugO6EG5ng5cL0BvQB/K9XXg+gH6AwZQbqCT/uvyX7BRU84/s9oAr2VPbf71+se26+E77ltt6Vf1blstaV/tqs26zT5pi0sstNVqlXlBz2xxYYse2vga+27Y+C3v96O1UL+FxlnofRasi3VoXqxnoXosVKeF6rJQHbY8naY/sem4OeQ8WvTbLfoxjvqxX6yLfaMuex3UR3WgPuwb+8S+sF+0OE8Yh/dhP5jPXhf1YD2qA/WiHlv80qi7MrUWxsq/xWNfmBf7xbpUh10X9o26mf4sTH9oLcz84H2YD/vEvuz9Yl2sR/WgXnY92d8H5NGPcejHOtgP9o35UR/WxfnC+bCvJ/P7bZ8P5vNhYT4fuM6oA+thHewb9WBdh/n6a8Pg9bx6lQmS1OOjb924Xk3Me0e2XTr6azvzu+ORIzyqtpCSSwS06lfeV7p8YFy+Srdls65Oy48BVRub907I/Gbmm0bm9uObB2x9apImD3Gr6VOiieQRU/9qu5r+5iMV2mY6pe4gUWumfozD+8xYF+tgXlpPonokqhN1oQ5pvqnx5KKhHaTLrT2WtGjc2kwt+s1o0U8t+jE/9oP5UZeEdVAfzhfOB/aNfWJf2C+16Mc4nAesh/kkrIt6sB7VgeuDesyW6t7Cs8/+ErVmxkq/xWNfNC/WwT5RB+pCnaib7c/M9IcW/RiH99nz4fqiHuwX62I9nBfUy6wnWvTbLfoxDu/DOrju2DfmR31Yl+pDXdgX9mPvm/bJfj7MzOcD86IOrId1UJddD9bF+WL2O//Z+G91PLcwDvLf6HBXnK9zk/9m3ksrzPW/pCM/U0fN6ODIv7P+AlOnNqOD/EM6ijN16jF12jF8I/LPrD9h6oQwdbozfMDfpKMsk6cDU2cQw49k+O7k71l/fybPAOc6w2cw/GzkMeBP6qjI1OnknIfMYuokEOaa4aeTP7f+TZzzkIlMnhVMne0Mv4Xho36njqrOcUpfxfma6Xf4LkbncabOQUbHGvK71n94K6bOfOc8AWnMulxkdNxi6lxmdCi/oMODWf8RznFRm5350pedee4Fc/9bps5TRsdxwq4/nl9wH4PnD9yH4PkB9xF4LsL9EZ6HcV+M5xnc1+B5BPcleI7E/SSe33Afh+cd3Pfg+Qb3OXgOw/0YnsdwX4bnK9xn4XkJ902qXxj5AIMABRj/h+S+YTubbJEHi953D2Y6KfdM9FlYodEVecv9M2Fxe27JnXrGXfGrfl8edTu/hqx/JK/5UDDsjeGpPLR//YrVk5/Jn+vnvP9Q3i/nUq73m2zaJ3/u02b7o4Q9ssXzYLG3FXbJHfUrq62+Z5FbpS2+16DdFrldxdSYtddWy7nSNm+4eGSRjDoGA4YAhgIiAMMclx0wAjCScqMcuNGAMYCxlBvnwI0HTABMpNwkB24yYApgKuWmOXDTATMAMyk3y4GbDZgDmEu5eQ7cfMACwELKLXLgFgOWAJZSbpkDFwWIBsRQLtaBiwPEAxIol+jAJQGSASmUW/4TRXLCmxXpnB/wkOzwBmD87iQrvAPY+F/1u7vI4079KiYe/Tgc/W4/c7+Xf82f0YXf7Tf8KAj9Vl+GX/CnZ/0wVgBWAlbRuV7twK0BrAWso9x6B24DYCNgE+U2O3BbAFsB2yi3HXB8W2r+DysWySVOe8FriexeavDz1MzL5NG5vd3LjI6S5w4qGrg1MVqO+L/onaPfxsiD8q+qdWNgnBxSJlvr/d4JcuGxgfBKkiuvjt4x9mWKXNI2Vsl5bGOtnL/G2nw11q6XaxZq3/uE32a5+L4e8NohzyzvD680+cf3uQfk5rZxRmb/PT0QfsUzOudDz9zSe0/3MhmNh4w5jBU3FDJmPVfO6FNQMPLZfYza2S2NL553N04YP954YcIS42SPbUbD1FvGCv55pSOH60nLU1Ik+FTL6axz/OPNBjTW8UPHVjnMNs5Se1fuAZViuz+xNNlScsyjxufRol+GvFQrY5nv03cAdgLMLjgLQAGkuuDSALsAux24dBT4M+IbjAxgM1K4AUZ9iFH5Nuiq+lylgOpEy0qqK+o33xkmq4AgDC0MfwaNTdpNSKPkpO2LDViIdElOYZNUEMEa0mFLh0l3O0lbGjtnt4JcTz+d/rHrqeGP5HiMo02xX/eL8v5cim0b0fOcy01zE1YI3kfkpQpTY27watovFC5N5blBJp8X7cOsXIXjL8IpmO+NcbANd4/psiFMl+OfdDlkE47890q+zdCnfziRcUkCTFB9i+iWQ3jM8KAjWAuRFjmWrinmpJMhyi9tKJPbzZNXV1kc8J6vukLErD/IT/eXzLhkg7D1EdRGWRIwuJR3ue7MrOhA61MKj7Knsd32GMJTnrI/2ZHTEjYcMXIhtHMYuT/NERRUp9lSkmtZfxLwcAfuh2uQbVhGm3M9Is972RymyCG/BjKmJmB2oQ9ZqxukGwggIDSMZrAhdRrPSVrTT3mQBvMX1zPd/S2nvm1n0Qw9Qj408/7ANAKjZ+E2N5A7nj9QU/ZHUt+UQokm6mVPkN9Qh5K5MeJYExG0lEc+yqQ2paBpBwU3AynITETb4g73DL5wbrwM5n6DOJxQxPteLvaB39hz0QppyWfUrLBE/24XmeE6zJ3Twt2D/mzZOAdmlPJedAqy7QOcUh/GabobyVa25P1cRnBIJ7Mdi9F4HsXT6h28bWhjp5YI1oa3keq/xyb9fvpTY7g5Wx75iOc83GROU7MGwo+kuB/UgnTNWj5Oy0Tm/lZUJi0kbKIdYctH8PnoVvIvhjD9xQeWrzRlvPMtcvo6OW9jgpttO6LyadxKLkAw4wPb/EM4VxeG7R+RHPzzLy4c3oLXvUqUM+z5VN3Ckb1vmV/rjEXzEpq7tJDPukmd7REmXvNn9HwJJi5NpWFzA/82mmF++RhIf+S2aT4KK54wdGc8VA0yPa4V7/Y3TDL4zH/vQ7nyrJ6r3+SJFYij1scAFZEriC35SOTE4+TODECl8BTLYuoI0FBF3MID38xo3J/NQL0lgb+lVmL890M+DUTxPC6Rh0/DSVZPJPK1OzY2WpQPjWV5SgHOaTvx8TXhiLUGpyRLqHgiwhH1eXzdpYuawFTGiI9glbALSm82sSwnml3PRlJ5dy5fgzLwXO7LKam3HI3LoODYF25sWEeH6AdmJmnyeVUwl+1d6DOwwch6FPujQrBYr4C2Qw0enePRWK7B1v/tZrXPbZZs9ERMpBbFz65ION1BTugE1qPXUqDfw0u/Rg58l2aFexDT5MpIcFWgqTWPfImNRD90I7IrCiXftYxOq8JfKI6Pat4wKMdLnyyc6lbgcH8xiX1hnDNMxDRuiDERh1E37idG9wR93oeRLn6G8IA+ktoL2BZ6mi2hsYyfEMO4553sDL1Az/AqdKLHsVnGD7t0SWxbyrkaVcp4o0pufhjNit1yvCr6Qs/sckQlcoiar4pDmB8i+pqMjZvMOr0cpp2r48Lr82ybPxGPOnOU9xynxjKRUYZhiLz7wgKjw3ioJ6NbIIT4TEk667fyOaaBpvxVrG5OJ1O7jafZWuTGxNFn4oKsfT9+h9/icmg9gz3anD+Ty4CkOr8DxH9242DuxGuBYhQc1bCyrGbZsB5u30vZXfUR+dgBckPVcDr8hdEtkvyYLUjX42ksvpKG1ZR/0GoTYbXJCyZVpaE5p5B3OZNZ45jFzdp0xAzHsfWvNuZ89yPg0GiipH1pytiAl+dD3r6C1JWbaOguJsepDL+ODm6MnMal98ocTq6lPt+fiOXdfLU+TVPoJ/LeqdL3XwqG2yq43u9B9NUZKPYUcW6eHlxIIX9DLEVWo1FQLmBVaDDdQpn45YwlYPMZpCYq0luszI8nQ0T1/CKqaojHfjsRzB7EINSb/Z6SDB0YRt5ACFtnTRRlIjCvfPkbTxf4x8OTeGdd1Ku3En5vOWoDUlxVNmWe7SKuebej1lJC9c4h0jiLwM7HbOk7zSyvZdhNvEnptnC8bVfgbnmf5PUjWGuhzfQ7xWi+b2CSpw3Wao/Zr5LNtMv1nNHQQrg4jZeXbiP1dRb/uD5Gbtgf8VGhHDFSZk3baWamJ3Pl7C1UrUUp+G7ChO4Wgqquk9pTS650Jc1n9yLstg0VC2nksCBE4h0PhCKQEHMgwfgIB6r66R5SxH1eEQFRCxH4+IvS6pO4uK1hpWIWaxq2oPytgntbkvh0NZ4x5keYqZdBmpUNEoaXCNWJp3XmCHz6IrjWX0T1js+YO05ghJA7hy/mcbnmOussljP951jifes5J6hPjdEiBHsDuL+kldUKP7jb/C/PPxoT6NBPqkMnXVXqpCXW47/pNq6PGnnXPYkyvT9YKrMUi9023Kz8jGdME3kq1ow1e81UAxNsGw6gMPSCZ3c/MjuwGa9jixC+38jwvSN4uj3k4lATscK1BFrvwj3/Mm2eJzDwDaBpghtfO7JR+HOAwmtlFLOOh5fHsKtsLk+CdrCr8yBjJJXYKyNOsFMcIxSkOLXHj6GhKiyXvKUrWIv/uiZxqKyUhsRB1LPkeO9ZT1yjFp1ZlhRkFdLROpaJUcp4WS1EyTKK5PZH3J1Zivv2HAwUjzPBppUhsZU8+PSTo/oePIxQ4sXtcAYLsnn75gYqi66hqmuLziwzpnT9y95BUX6udEN1aicbCsJZnXyYjbNbUbTopabpLmKyCUz2LsE13oH5W3ZguP4NIRPG8alwAoMtn1lYofxb3/DcupW+7TtwPppKjOZbrkmXYLsplQdWFawLa6LTYDx9PstRntrHBZkzzFJayuaP9+jak8TJjTWsifiBpeAgT/4+T9RsLXTyZ+Mc24vF8xz2zdeh+Vkq68akkax5iex7Y3EVWI7j5XeERGYS+b9Evt/QYlbMFQL2rSSpYxZGp3rpXWbBg116OL8y4deJAbbftiHAOY2yvD1YfDnLgsg5GJdZsNlTmFmKEeguCyPq0VOenLzNip9GDFu+YOq4Zho3HyTuxwJu1TYyrrGDni3nWdYYwX5TO2ZF6KP0dxzjbQ+g+L8AQpUmY1o9kcj50fz1RxRZDY950hNAg14d8z+95Kvz7x+Iqcbx3AIWx16iMlCMtHW9yPXZ4/qgj5Q4WbIU4nFpl0fkdQFmp2ayOqkZ7332BAfOYVypBpmfjyJh+YxZ74UpPKGIV7A56bLrKPyey76BuyT02SKlNfJ3zVOEnT2D72sPdI/sYV9JNu4a21gqtxUWvuYm/gx+smDEZnP+38UdR8Ww9gEcn61KqaoqRSqLqkpqExQzPRuQCxEXCF1UlLR1SUFtFSpoo0guRVwBBVTMmE1FktoSQrSgqqqtqlSpeZ/R45x7Xuc4M5/zm2mt5s/5faWBQgz+4bN9JfZk8txdzvAgTJ7/a2/Jc3lJyCzWUWPbnNjruGZ7HVlPiPw6nb3euHP7tNRP0vy2qT8AJqoNDS95S49rsPEN0YXG1J+0Bryl0+73K3t29ABMulz3q+5b+sBR3XH/lkOHWDquz3lDl98rVF14m7VQ9OeGN/RDNTuHBQnQ2OhgidwbeuLsCaNTA6FFokPFGa/pdyaXz7i5Qy+TXzXH7TVdYBp/bZUDNN8vf0ZPJa1Xfc7vrh47zxi8cq6SXuzx1H1rTzfAMmKdTsyrpN1sEu77VEHnZDl1tbyiP4nWvyAfQgvi55aeekWHGL7r+OscdBplYMJ/RR9eNV9nlRBaOF/2paGCfuVXV3p6C7SU5zg2sYI+GX7li9kC6Jj3RwudK+ioeUqzGWtokYXV54Zyuoa682GCJnSv6yT/pHL67aepC+I7u6BzU3xcymm+5aeyOVXQybJESYuELkoPETtT0FofRl9OkdBxZtL88IvQOVvcaxdIYFeh0lQxBrrt0LwJTWW06uQxY0v9obMMdv+xoIxeOdrp1bsV0DwtYu6lUnpd9L25FjPZecNcdblSeqB3lMt9LnTbHquLni/p213O7yNHQIuSFDjiEjp+aPWG+NZO+Pmxq6y4JXTDYtW0d69ZRxwziHhBT8rTEntS0JJXJc+/FNM573dPMr0MLdKx5c8rpuUkqS8nHINuM962J+M5bbQ3unD9bmie63Z/tef0l+k3F5ZugBbP+5cbWETzK5ckh85n53r34t88o01fMKUedtCCzXgO/oxeqH5h957R0J4zzqakP6VFTs4zijjQadkr7VWf0i69SY+WNnXA+02DD/xdSJdfHSM38jXrJ/H7qgto68HsjL7H0FjFcpv5BfT1sWp7ja6yjiLjsvJp3n09z6CTrBf6nRmbT3dfWL26/wA0/5Jo5eEnND3L+OzdbdBpob25nXk01R0fdW4FaxuzIs88epby82vZztDcH6vDS8X0A/7VSRxrdj60sBoX01NcSk6FjoIWLiKp1TR99meFMZcDzeefUp7xmFZ1XbKwq7kdus852YCit3vFu3dXQadVLfXpe0TvD1utPbEQ2tOOG1r9kG4wf7Fr/21ooWVdvjiXfmBoo8Y5Dy0Oujv/3xyaEjzYlxUHjd24yzmWTT8gZWZxe1g7zmvfBff+7RdPO7YVWnjYX2PjffrjJgtR7nJo6YVPHq736MUVUy5pAOg03yXvHO7S7/u0go7YQHsW9oZy79D295steYbQ3M3J8zVu05lTo98PjIDGKnx39GfSd/2WarZ2twGMv+ePY+9v0qWp1huUvkFjB781k9fp8ZdttsytgBbr8GMvXKUNk7/svyJmLeewJuYKXT79aZRdJrTwjc/GwMu0k25a8odzrL0Wxnmk0zV17pnXj0LzR239uvACPWC51C51HztvihQHnafHxE87et+Xtbt7+58ptE1f8+XWtawjyjYTp2iRTfnLhQuhsWtHByxP0Fdvtj196si6j7vP/ih9dUqorpflr/mGaWOiade/Gy1MR7NufiKvE0In3dZTUlBmbRqqouBJG/ab/xgnlUGLojtlAWBX419PjC6wJqa5VB8GtmcisrS2QAufFKSXngQvb7biPWbsPFYvL/UsqNNNkC9qaIXWLq3KugCu334RIrwFLeZI1sddBmfVzl003AUtrOJHeVwF98+MjEqYyXq1zNfiJliV4qki5UCLk78n784CyY/2fOcUtwCYQvzaveIOkE/Yr9pxAhpzPPLR9h4o9RjwvuEBLV59eK3SA3Du08ZrNhbs3Hda8Pts8NLGz3lnRzOAnaClc67nArnQKxf9H7NWf/Qs5BHwV57hb34Emls3RXcOBRTWbKAS17DzT4H2I2lwNPWRw31zaH7CpFE+YgDqmlujupsAlnUi8uCCPJB36sPuwQJoXvHLneZPgOUfh9RMkqCXFf77Vj4f2DjLCr94QWs54Pk1+eBIzHMf1xnQwr1+0x8WgD94xuMXqUC3lVs6nSwEYbKOg/UfGqFHm770fQouEp72xpnQIu/mXv4zcGXNK1Abyc4Nu8WjisCRv1Vk/NXQwp6VVg1FwGLRdZG1DTS/V276o+egvOOkbhoHGrMxajlSDMbiH0xT3zYATMLxWL7+BRDdfqZodgtaTJb4WJUAu9LTHbYHoT1dX0/rKQG7F11qfejBzudPpfJeAkfXunNPp0JLy3I4R0tBrbuPnZs6tMhArPJnGTj3ljnuXlsPsJxxOjs0JGA/VpJaSkNLTmrkBEqARv7j9+Iz0IJD5/0qJWDAYOI1i13sfJHD4enlQDnl7g3MDdp1oo96cjn409mrfqE1tLBEyvSWA0+5riSOEvS2LW83ra0AVunSLWZf6gCWoafCy60AN+9X77n7GNpzjlbQ6Ffgidlpn2tnoUc3+5vveQVWKxl0jAiF5mUOuL1+BdR033woXgUttfvaOqUS+D1w42BatQBfPzthh1wYnnRviTzGqwUuGzDXRvoYHlKZqI4tqwXZl98cuhJ+HL8ZsHQEJqgFi81W+jX+/Au/pVkzxMTXgkGNtYstwvaTZOGWEVhWLeC8r3bdlhdH9uR5mGCSWqB9cuE5IxCFO/coNjGyWrBi8hdDBWEYKTx9SAPTqgPuoSqB3sw+XKfB5ydjVwdMD1PmX7CjuK92RA3jVgcqOO07E+R2kqJ/fDQxQR3Y9c/Kl4E/fchpRWH9THwdiFLoPp/3OAKvfcIdYjLrgNfWEiuDMAGJPQctTFkdMDqyTzlIKCSDDc0bGFkduNV3zt9SfAyvT/9HAdOqBw6Lvy+vCI/F421OGmC8ehDRyXvQMBRH/vO3gxK2rB6Q07z8aDoWfxo7m4sJ6sHufdqdXvQRUiG0u4mJrwerXxAXd2KxZI0COQHLqgcjF0kda7ADZNxYte9MWT1QTGXmB2Ix5JzjCT8ZWT1wFOyV7IuIwp9t6jfBtBqA/L2a4ATnWDx333xdjNcAguWSFy0VhuMBI1prGbcGYLuZedcWFk+W6+CfmIAG8NDR/NS1SAGpHjevi4lvALKMrQljhYdJZ9vkj0xmA5hxcl2clH+Y9B5YCL8/+/yezVMuBfjyf9q5WFsDGLk+xuIaiCOVsuZpY1qNYNX7NWdcmV14f8+jERivEYz2nxR3/fFRPNT4tBa2rBHwQkM+Fg/F4K623caYoBF8uF5FBLvEk+4Oa40wUSPQCX4SLUcfJxc5u1ljWY1gE2BwhcHtZLnJrbdMWSO4JxDp1DlHkiEKy1sZWSNI/6QhdVbyxdere31gNJtA7shxjkVK6/DVxdeGGLsmYIxP3GXCCSWrHya9Y9yaQKr1oW1aTCj5j9d5U0zQBJzdDknmMXE4X/9wHxPfBPryn5zaM7Qfd3uhUMFkNoGCSR2tFswWcp6HSwVT1gTGN85qzWZ2kDUqW3oZWRPwULU9Le8SQa4Ivv+Z0WwGY3yzE7fmHcG/ru5vZ+yaQctT3jHZ0FbS9Btdzbg1g90LmsltIJr8kbuyhQloBs3SFW3pYdH46/gz8PffDNpP9B1TivobTxlvNh7LagYKGqO3Hh/cRv4zP/EjU9YMghqfGT0OO44HFww2MrJmMBSTetPp8XF8Um+KPqbVAgLX5WYkHNiNG//QVMd4LeD9M8F2UV4sXqAZ2si4tQC1oTWFMzTWkN8PV9tighYwVzNvyRthOHktsno8JmoBHh6DifH7d5FRcn5VTGYLCPtrfKFx+FHcacEOK0zSAlbcZu6c58Tg3aK53xlZC9xLc39age3EE3uuv2Q0W0HF9slcflQ4+bHI/QNj1wq2Ko8tzsP24TL92R2MWytYfj0xK4MJwrU3xtUzAXDv8rHs9t89q0l15rw2JmoFnCLVjceE0eRcg8s1TGYruM+d81oJC8EvhOsYYpJWcMJjlWev3DKyAG5iYm2tQLt22oa5/IOk3LG93YymDCgmyJzsB9zIZ3HfTTAe3CvX/rvjRkQcnjg1sptxk4E5z95WuoA43G/x1Z9MgAzsDkk26pLbTLoU9H1m4mVgUd2ervIDe/Cwr1L4+5cB+/T9KWM4AeT5b3uMMIkM3L5Ruqg1IhC3z5f+YGQysO6wgDNDcSe509Ori9FsA+9HGi28GRZHrtl7qJOxawPSOz/zt4efJg3Ufw4ybm1gfeKLqUP0aTxyyUt5TNAGXqz6Jo7CIvH6Fx3w+WsDhrtnPK5h/Emv92ocLKsNNJnX3goHCaTjq0scTNIGfqS6hvYfEOKDg+/7GVkbEPu9ESgq7CFPDT5UxbTawWZV/+hK4XF8Q9f3fsauHcimD27tp8/h71Jeq2PL2sGtZTqCPVgKnvLneE1M0A5aP3390jd4DDdfafGTiW8HfwfNquZhCfhanNDBstpBDEdeGBp+Bs8+b9XLlLUDn6Op16f0eZFYZVwXI2sHTeuvnKPDT+KXDh1Rw7Q6wIT1gwl+wlRcfs5BeYzXARzo1KYnzEk8uodkGLcOEGRrG1bHCcbfjbfqZgI6wF9q4cGPfobj+MyTepioA0xykcOL5YJI3S1/6mFZHUBuXIdDpPAEOct9qIkp6wAd1W6OYUwMeepmjirW1gEKXXjLljMHycwvewcYzU5wznJjTCAWQYZvujHE2HWCUdnZYAOTQK7y+VcNW9YJqMgjEyLDk/DxPwa0MUEnKHmtXvAQE+K5dmvh/38nWH7lzuRzIJGcXfFRAcvqBJ8dgwV+4Qfx1c/vdDNlncBeh9aaKbcXH30vq5GRdYIs99ve/uHJeFfmlFGYVhcwPThm04xeH9zqyAIDjNcF5iyvDqrlROFb7iXVMW5dYF3snZztTCwu3a0An/8usLLjydnb4iSyLi9AxsR3gSDrmR0q/LO4wpXH35nMLjDvgDqdzSSSnyy0DDBJFyB8qwO3is+QX5zbNLG2LmC04qBqbPhpvHxRtQ6m1Q2mX/IO9FLwxPdaKOpjvG6gMmViaSl9ilws+NDMuHWDtxcUFYPkYsmrKzfJmIBuoLP1uUYtfRbX0ao1wETdQCTLjCgMi8FPOD+Xx7K6gViNHqnskkqSYxYaY5JuYLXAbMA6IpmM3ZtTx8i6gcL2FmF2WCK5gWD30FEfI8aJmGuwu989Cxmrwofewb10MXKIJUUHV36sLkMWmxBW7J56DTJWRX6duTb5hOy3SfLQSbi3ziBX2VHpk7u8d2nWoc+zofLZPfZxyGJdQrGs8VCkHTLPkXJn99oBshijfpa8nUa5IcfYEe3snvsmZKk84ep//bapAFliQTmye+9CZOwjiRnfcMwV/fZXPOTXHvxvt5CekmCVfbeR+VzCgd2Lz0PG0vDph5jNvhXIInNqFrsn/wVZKkfV5ydEH+5EXmNKLR0L9+YV6tH9DoThiPKbFXq/rUmEvYR79GbI4vGUZHauyeLpyBIr4n4x3KtfgKy1gCDXpxp0rUb2nEBkJsA9+23IBVOopHT7d8WhyNhEKscL7t3HIQutKWxNyCXJWWT4fSdeZPfwkS0diP4xbx4qPka+N5uImgP38suQJbbUYm/ljb5S5GVcakQI3NNvR7a0JDRsLCVDcg3DzjKiTrF7+3rIUkWqz+7ainwzZH43/sdTuMc/A5lrQNxK3jQpxxUZU6FesHv965C3mRHjA4JTPvohS6ZT1uye/wFkjEOlT9z7zSH+tycTCkpw7z8N+ZIjFcusWPLoDrLHNGJ9O9sBQM4xJwpzFo3Z9QYZayaPs12AemSJASHXOeLYxn5kvj6xhO0EqDWi67vJnpzjLXtNkKUqhIUt7AbwkKusiQ0j5wufz0ZuM6TOsh2BP5E9VQndzV1xf/ggxzgSV9iuQCgyV5s4Zpu3YugIsliJqPgJOwPnkXOsqJyAaeO/ZyELJhERbHcgHxl7hwst8JnM69/+hqdXsB0CZJEN5dM5oXbxAPIyfUKUDbsEGk3DrrQjrsam7CjlIgt0iEWGsFPggLxgCVG3IHtU9HxkR0fqV7dgLTKWjPsWtlvt3IEsGUksYzsG4cjCT/idhRYdR08gixUoebZrcBlZoE55B6RkS3OQReoEw3YOSpDT5IiAC53522uQQ8ZROcawe9CBnKZFNdxx+ctSqXnYfG1K+quDgCxVJVq39r8zmozMV6Hs2C4CH1miQY0a7A9ZsBLZ24l4IYGdBB9kLUPqQV5MbMa+YQvnraEc2G5CPJq7GlI1BctX89ORsRd4IttRyEbmc4hYfX9bzRfI3DZcpwB2FWqQPTvxWdfXrx/ViSxSoki2szCiBX0/FaK/SHnSirHI0lHUwTjYXbBDtjQm5C8WNxbNQU7jEAm/OgzIWA1+oXZzffAO5DR5ainbZRAiV6lRIk8mcEMSsrgLv8V2Gq4iixjcLGrmm/2PkYUN+Dy22/AKmdtN0opGW1/XIQuMqeYU2HH4iaynT208MMbPR7t12K6qRF067DqYI5fyCY9W/VkOs5C3qRH32M7DMmSeCrXN38fUyQsZ+07OZbsPe5F7R1Dm2S/3hMYjCzrJ+l8dCGTJd/xb8f5DXbnIhvqE+jbYhShDXtaN6x0cffHaN2T+U1yX7UT0IwtbSSWXB0b/aMqGHdNPbsmF3QgzZJENtTvoo+vzmcjYNdyU7UgsQ27rIgfnxoRO8UYWFuOObFdiHzLZj0fipnJVCcieleRxtjNxBVlNldJ+fWL6QwpZKiYT2e7Eq2ELP2lRrROt/d41oPmcVvz/3yt6TK7rN1RF5t8l5dkulT6ygQ4VKTdLb9t4ZP5DfAfbqbJBTpbhxY+0bStnIPOfkbFst2oOMq8K91nZE7RpKTIwpNaxHau1yNFyVNI4XGOkF7JnO274A3atBMimo4jJGUGTKvchpzWQErZzdRiZX4sXjfDuoU4gh2DUr+7VeWQsmeQ5jTv77CpyGoP/jGE7WMhF/WTcjm/z2sXI4ne4vivsYpUgcxWJqg1OE2dVIUv6yU62k/UV+cZY4t+rNZsuy5DrFai2CtjNGkDmqVOLJr615I1oR89TO76e7WjpImPNeJ/1xusfTJBJfeI129WyRubX4wcUOvQypiNLNKgGtrM1G1lajzvau51MWorMb8ID2e7WOmSeIlGTH7jykjeyozyh7c52uJArLYnUR0mHKsOQJYrUSbbLFYccY0R5b5ixxvw0cps2cYXtdKUju2oRXw/r9p7JRHZaQK3cALtdj5C/mRJzjCyT7IqQuSOpO2zHqxJZ+BW359/bWCdFFjfijmzXqwVZxCF+vHSMzutDDhlLxR+DnS+ljmEnTiZMMkKmPdZBxqpwl4+w+zUOeeokYqJu6MWPk5B7xxB1f7EdMOSiMZSFXuTAuHnIPDlCju2CLUd21aWySk0CD25EFugQ+gdgJ8wPWaJNaEqNp2qEILfaE85sNywaWaxH8R4l7H6YgFylS6nUwI7YeeQsZeKsRrl33HXk/ROome9hVywHGfaK+wz3OIUVIgu1qHdysDNWgQyfh9BRW8edqkHmdpFltrA71oycbEpNiKH+qOhD5ulTZg/YDlnnsKdPoVQvt7ZM0Ru2sEZA5byFXbLxaO46gbrYkDErxxY52YzyNoCdMhxZYkJY9H/13rwQGasmNdlu2SrkKh6VG/Ppov1W5KIJhNM12DELRPbkEkO7TCaah/+2PuXIds2OIktHUvnOgWP5KchBcyluGuycXUHmKhNJO5vp8PvIQmeig+2e5f+2DJ/wuWXudwlymgH16FcHDZlnTpQsNaoRNCP/60odDYNdtH7kapx6lOaTP0G5a9g5ZkQS20nTRxabEPPnq1gMTET21KW4V2E3zR45eSLRlBsN+gEy1o+PYTtqS5HFPSSn4spsrsdvq1L6bFfNF1moQ5k7HPH2D0GW8giM7awdQuZPphQyT3z+nIjMVSOC2O5aOvIyE4qT49944DaycATx2YrtsP22LjUlzyDHpfS3MeID22WrRhbYEKeuV0VMbkKWGlFyk2GnrQ+ZO4bIs58X7qLcPWyxMmXNdtv0kbF+snE5qD9ghqz8B/F+Key4TUWuMqcMb/R0fZmNPHcK9SERdt2WI+OuhJ92w0eBJ3KWKfHJCnbeApDXuRAaBV8+WIQhS62oALb7dgxZeSK1WJWxUP4HuXkJYfGrA4eMFZBdezMGtB8iK/MIVbYL9xy5yJwCx8+I5lUhp8wnPnNhJ64OmT+WKm6q5qb3IAsMiBy2G6fYM+xec2LUj5e11qOQMQ5hz3bkTJElo6j7VmOMPzr8tg6ly3bl5iALG8n+4+RQrjuypyV12gF25jYjDwUSx6coP8sLRObOoMLY7lwEsrAWD0w8f7tLhBxiRaE8CP1//QUac5G8ilBWrZLr3Y5xesdhHK4vxlHkYhwJNHtuDs+r4Dl7+Td45KAXtn+/aKuIXrQd8Z8Xzvm+w9ep/Pc69GK7Knohnv3ZrvBnf0M/exe0OnqJXhP+Zf89/nDOXrcXHj19h88Pw/NtvsP3ZMCjFjxq/yeAoeeHcXTZI1q+YO9JQ/ez8yJ0jz57D5pnwXkGmtejucF/5oX/mSv7Dc9H/2f+Bs3Z87r/fBaGreX/Dwg9xiM=";
const depthText = "eNqtWQVgVMe6PrYu2Ww8gTgxIMSahEA2hkOxYoWLu7sTFgtOoBctUkqpYCU4tLhLoAQnJBB3Wdcj8+Zs8gqPhPRduN/M0X/OmX/+kV/m+90beyJIYiKCIB8fSQiyLKHufk5yXZnEJPa5/j08limQOiS0TR+taJte1L6Odi8ZAcrOCCJL/um3yOSrg7SKqpbP2tVOXJV4Y9bw5E0nxEnXT7xUeOUuUCgfJsV3X+USO6O2e9yQOxdjHCutMXORdmHX9zyIHDjxWEhGycuY4bN9I8nr96O1PvYJC9cejdd8E+RXsc/zl2Cw/eiw6zsuTCkH7f66qVpZ6nvuiluIU7mq1gcFG06OVb4t8/21klNRGhdWsPvxvdFpspTMb7bPG4WhGIKhCEwoQJE6ABSwh+0CH+tPsAjAAFoHHMUwsJHH4XE5XIJLEBycIDACwzEMEur+BVgwNKAZiqYpiiIp0kqSFqvVYrGYzbDA50NyHWE5hsBghTg84Th74OyVwOozDhMLFIPlAMa2ggGABgxgEADZQ1A2s21HUPZA2NYh9c+APbOfAJgYtiWwIQxtQKbay+ykMEngIZPKZDJ7mUzOJnt720kmt4NvIEUKy0glUnixs7d3dHLzSNx/sbe3r39AcEir0LCwsPDQlgFeziKy4tWVw+kLx/btltL566Ez0n4486hQT9g38w8ObRMW0SasdauQwAA/X9kNxXdI6cOzP2yYP35Qt/ioEJ/mznKpRCTkC/h8AQ8mvlAokTo6e/qFRif3Gj592Y6jN9+ZnaMGzt999cwlrlqtUes0Op3BZLHSKMETSx3dPHz8g1vCSqIiI8LDWgUH+Hq6OdlL+FwUUFajWafXarRatVr7RV2F3vYmSjLP/rQ1ben8WbNmzV2oXLNp14GjZ68/fFVYY+HI3AMj2nfuPWTUpBlzFixYMHvqmEFdvvIiSm7tm9XBvmAF6idxlcoFfCWVoyvV1BhNyvMvJBrMRFHdTxdLLTyGy1f6rEi0lMqBylHFp1K901KM5Q6M2qlGQG6ZjrwHeH9jSzB/OLjrCe+hXIx8EgDmJoFTyOdDuQz5D1HPOoBQKkF98xBbbiiBBm0Gf2P+GoB8LkCLXNDI28bQSLGkK+bPGGSoDWqlsunfN8kTlPbnY9napkZC0www77XNMlZ7sNePtM2y99qm/h17/6G2+fD+I22TBLVNyj9pm+DBO2ONLebFDV2yJeZGuC6mx9WQCB5hiPxX2tbQipTUmJmDnaOm7YyLJjs8VDhk7lfs3/ZIcfjwTsVQxbgezXoMWrQQ/HvpwP3Pb1YsAc9TzYIjZ7tyny58fvaa8p4hbNpdB4Rp06V4BArGtBpmuTAGTEzYBVZc6ajq2v7576NcDVmDfwNDyJH7Djsm9lVVZp41xAbIitp37CdVTw3d/SfIKqjq2XrdmLhQsDzl7fFDMzs4yhK+CyuKSR+6zI6h2NWYAezoxRAMwwiCgMpIwBcIRCKRUCISQ0gk7CGCZxbsVSKWSsFxrQYmG+B6qNFr9Tq9wag3mUwWM1RQNA0AimI4TnA4XA6Px+XxeXB5hWuskC/cNF8gYB/4XJYAC0Cth6OAIk0GnUYFV1it7Udmo9lkNhnNtmSCyWgwGvRyUq1hF2GNTqvVwWrroIPMqLU6o5lCUC5XIBSyvEslMNnZSWV2MhnUK/aOjl+0CM9ZbmUY2w9YrV4389/rdZjqVSGABRhIr08MJBL8axE0q/Vt+hFDEPau/oSwjywJ3tRntL4kTOx76w8jamHjDKzWsdI0YyMBxmJUVZYU5BUUV9QazBTsSUBRpMViNOl1Oq1KXVNTVVVWXlzs4gBkfIQyQ9kZDEazhaQYgLJ9zYGShyeYcQLFWNVMU7ZMw1uAsM14IPTdFhvRJjjQ18vN2V7MxSya8pzMKycOHb5w78Wjs+lTh41ZsOtsVpkJkzi6e/oHtGodGdU2PrFT1z4Dho/X5a2RBUMlHR4dHdsuLq5tTFiItyNHl3cnY/uCkV2iWwW3Sew/Y/Pvd4vNYo+ANlFt49gyURGhrUOC/P3ODjq0qm14yyA/z2ZuLq5u3sHtB617kvhw5E+SUD/nn0/uufJXWs9LobeW9PnK38PR0d7Jxd3LP7hNVLuU7v2GjH0Xc5zL5XD4OAIATlJWK0pSNCLhSmQuQT4Bwa1iWwa38AlwkUl4IpShKIS0UhTGAATlsfbPFw0S4P/H7iULtt4QjMseZv1lbIQ9WVtZUvj63um9a1OXrNl3uVAa9c2EGVOGdWrJL7v+49KRHcM8JJjVxPaNhjpdLpe4SWVcrlJy05ivrbFSSuRPqsSkppjcSqvQTiji8KQXa2OCgtHy57eUUenZWYhfSN8tj5TeXtb7mXJVKfW2GnOJVpY8d67lW3F6dkWeXAVvqFUxo9/aW1HKojz/U3CVgCK4t5Smqx4VEpPV2KX4HaIVUhzc+n7Rhfk/gzIV/COQT4EkmlYxTcLC+8xaWXyRjYHRf/8eXj9aEGypLte/BB8kiPesgf94kM3Y0rCJ4P+LpStAg+L/LP76ZihuNl2qKakz/rlN19MkO4GvG762uS4IbTVbKABv0U/NXDp1+d+1wVx3+pRw3xf5fFvyPZT9+NC9I3AcctdoexuTBFOPhtbNtY+sm2uNWDc//letm+PTH8T+kDY5Lr36aMyfGhDj6W+M3D18bdSqxffCo91axLT/Lj5ye3h29INZUxVn49cpoo/uUmhWd1S44ScU4ztcVtjN+6nt+GkH5p0BMT5PtR4FPfeCexsMy5f/drlvp/0GReL4Iacj1A5nRQ7ZlGrCGnBuq7T9qBcnWjwGxivnDkfdS39GY09l4/twc68ljjgpwmSGWzHFYHHPk0O7ZZ3PsFt3pfrnwpug+nB6H8GoYcBBN8qV35H3Ntf3Vt7lmO/enALnpliWLJlafNSxLO1K2139gsetjp2XrFuPzfw1CxwLGSVKdtqoBxXJj+d2SQQZqVjpoUXNZvW7POMSmIBenXJu66/bN46N8eoyvblH9pucnJzsN69evXiW9Sjzzs2rf144e/b8jaxSrFl0jwHDhgzo0zW5fUx4m5CgQH8/Pz9fP/+AwNato9omdOp5bGtpZbVao9UbIPQGnVpVDXXC4zsXMg4dyrjytJwUOXn6+Pr7+Xh7Nvdwc3N2cpTLpXYiAZ9A4dieGuzv3czDxdXZ1dXdyyeoTUxSz8ET5y1bsWR0vODZoQ1LlWlb9x//4/Zfz3PziktKK8pKi4ve5rzMyrx76+btsGAjtI3UKlVNdXVlRUVZeUlFWXWNgRJ5d56bvrxviIjR1JaXlhSXlpaWV1ZW16hqNWq9zmQiEVxoXz5BLhVxOCigSbNJr1ZVlBfl5+Xml6i5PikDe0U6A21FGaywqkatMxhZuwLBuHyx3NUnOCqp2xRBSVWN1mAiSRrY5ilO4AScB4y5MudNiVkgd3FzcYK+t4BDoAwFNaBaVVVWnPcu912RCls3H/l89LzBxwCwBSgYxFY3TkD7UywSC3iI1QStRWhHkazdazOxMBSHCcUAQtMWo8UNRygagmIPirIdDMA4fLGdVCrkYICmSPiOhARYACYSPltJK0Vi8oyRfNvHbM0AsAfNUKTFbDaTgBCIpSIRjyBQFNQBBSiKs6xBa1uMltwJsEBOUTaUBDMCr1BmHJxDYChDklaSAqCOXRSWgWQI1uAEFGWlkKAfl67evPvHQ8dOnjiRceTn/bu+S9+yK+OFdODuy+cPnf/r/OII/d0je3Zs3fn9D/sPHvxx/+5t6WnKhfNT1/2WJe5/dzPxrlZv0KprqmtVOr3JoKkqePH0td6r98ShXTr07RHKrc7PKyyrUqlUtXAc1VRWFuc+OrdrelKz0MwjAXaFK+aM6tspUZHSY/jiA88dR/4hSEnMUU2dtf5QpnWXP1i3xTFMdHN2UOnpjTOHD+w3cPSUhSuWjgy8FnWw3/NAUuTl4x/UMiI26evBU5btOvNMI/H2UCsvHM1wvz59Zf/tGTNeExJQ9vDkjmXThvbs0C6idQCcJf7hnSbt7mzmd3fybRHo7+sf2CoqqdfwmSs27jyi+Umb+XjPHOM0WfTktS7hN3auTZ0+qk/HtmEtA/18PBxx1Zsc+yMnz9xuNrFb9+4dFseGBft0cnV0dkkIiOowYNWkoa1eJxh+P0kPqkqavmjr8C7RgfEucgenhOa+QaHjomNiI1I87eiqL7IQv84cf+j8uWctr27e9Otja/OoxIRoP27uodW/t/l10u7S2tsZ9oYDSeX7p/YftOg02ftARfP2nRVBhjmR/R5oKt+4FBcxhBA6TUrzjdpSox7DlNwnNfmqWoq5UCqVutrbcYkjM5zvALMIEL8q7bLQCgFC5Dsqn666re0Q7VOwJnRBO8nle9k+1Grvr4RcD/8yrbIiU62tCPkpnCpK0pejmcpDnKSsEm0zpbpAqMcojJ6jqRLqMAqllRevCQwEiSOrOsSQIjNBgSOOs17WChCUWanscI6gcBp5pnxUaVeMkSj/fEiIiiYJpsUBtbKg2sBl7BW5Aa/eMlbQ88TnWWs2TN4GPtfgA0BaizRFbho43USFTf3gQxv3U1832QwGa/x9/asmW/FlNi6F/+8fEZiaEtjHsbT6d012UFOd+P5j9vLJuj6wTt+jKQemwT8aMD3y4D+NqybYXrocUj+z0Zi8hkY+RH1sHgE0abVaSZpBbM8N7FzWYrRKtI3F9iCRoeu1GPsCaRQMQTYmMBQjuBxjkQrncXAMbUyUbBnrrA2flDUD0fSU/CLrWlJK2BhrMJXYC8O69P+3x1EW8A1lrCnMbrBT1SB2mN9wpwrS/ps7VS+fDm1rpA/G9VnyOGb1XktM0H3sqwfY5ahYUVXkmY7rYtxdMiJv+sRF88ap4lt3FCp8U0MU3Vo4KUZM9lB86xqkuCt3UgzrsGDiyVP7OAvAHKcHbqdfd70GEkdbVPfeJadLJ6rHrd39opUssPc3a2qco2PjQ8DDiM1rZB1mcAeD7wKY1e2DD2dhleTAUwEzD/b14w9PnmR8l91cDg4uv5r4kgBDvMdecg307zLn/NTJ466Oav0gG2DLsvvxD3ZTHu7U6kqLzb8Cy4sFsS05x//de7QwT7l4etTRjeNqLxW5lN9efhFZceLwlEX7cP/vDwP70j+n5V4/yF8R5P7iFNhxeajTsbjHCBG3p7LqTa/eKdStFpOFVwbM3w76Nzf9kD7tioNYttC03yq4pvG+45xW9arXd/tkSeGtai6mjhhreHgU6B+Nvu7te6fr1DzH82nW89+HHpm7JDSwVXcgNNWEXgo98HOlS9r23NSh7iDu5Tr3g7sO3zzi6XZ3GZiGbe/9u8f+C9Hg7u6UTm5UztiUte2XnQRW39zhQ7eQ144uz8vLzy9gc1FBwbvs5/dvnD/+8/ebVyzZnNPnwqMjKyYM6p4YGeThIBYIxHZOrs2aefr4hUQoeg4ZP2lyq41P88qrVVodtKA5IqlMKkAt6tK8Z9e+H+Qds7I4KDElSREXGx0RFtzCu7mbkxPc7YJ2Pkrqa6vKq31Ht2/p6SQT8/hcrkBsz9rRCd2/nbuvJHHTgHbmpUexHqn7Mi7ffZJdUFaj0RuNOm1V/vMrv6YvnDp/x9UB3X+79ORdSVW1RmcwW1ib00ghIueAsBCOtZOfY3RCmJcMZ8wmmKAxr9XUVJcVvrx94vsNGw9kCWThRpVGByOE6tqKkqLCouLCwpy/Lv+yacUey+vrI+aUZfxy4tbLwvJK6FsUFpdWsva+WWck7RWLLmuw4quzekV4SDkogkL7XyjkcRHGqC17+/hm7uz+90oPHTp38/GrgjK1kQQoABRJIRynoI6TN/ywbazkl4jrt15WWhCeRObsBgXp5e3l6enuwqs6PYJv3n9C/nx+pNhYW1YGGcovKi6rVhlMNCZ09o9oH+9XdcTMRz4fw/eYrSQCcBwnMBzCtvGK0IaqN+cPqfv0D3cVchjA2vgMzYKiWIeBwxWK5XKBvrpILRBJoGdv2zKF30MrXiJ3cRQbH+39ucbZw7O5m1SAY/+ruzCcK3Hw8PL2EOtyHvz11wgHg1pvomwxcgRDcZgBaagteJhxqdOB0d5AXV2tgcFe0uZ/kKTZaDTSfK+2X/cMp355meInt6pVOoMFclQf9IXOmY6Sd9444Mi6a2qOgM8lUMRWN8KgGCGQwOi3VIiZKvImTDPAgLiAiyN1gWn2hBE8IWEsKZS2kFq1BjMbSMHrYikow5Amg4HiO3m1jG3xeutgLSoQ8mGrEMBAwBOKw4HKB5paSsxD2QpRBq2LdTEIFJuVQgipazN+2bPKWoSRCPkEAmgacg1pgEZQDgzSoxZVtcqCie3EfJT9hqVBQL54IqmEqS6sZhy2uhrGFXfecOGNju8RFBYa4EgVPbx64fi/x030nX59y8K0kWuPXbr1ON8k9gwI8nMVGPKv7RhgXsJ5GdVdN7XwdbJbqR7jERhDkYArlvGs1QV52VnHp3x1QY7clrunHMypLMt7W0ryZSIOBnAOn4+UX9q65feM7dXddRse7RywIUyKYYRQ5uTs5OofN+5Y/KTXfw3xfD52UfdpDlbp+pcLOwW5O0CfXcLHOKKQ+VHTFq4cvIBXIQn9F50Q19q7mauHX+v4r4fPTD9d5j3ioCpWEXDx7oGB0nmT3mX9urCL3avfVk8f0VvRJsDT2z80PrnFk/lTEHHfLhdWpKl2dWwuhgJnaJQjcXAP7HXxSFpZjjm0Jkl5+VZ3X/34sGZOMj7sJgTnitwUmzR/ur9c9O1KZ0HK4oO3s+7s+25Kp6A0c2VermeRVhqtOaNDf3PZe7+6Yudtw5MNmc76vBfSZzll1s1tvln0468PH55aPYu+vXf9F3k3NZsVh53m13y178S72l9bmLc+PPjC/KbCuef6rB99Zve4bq553rpyvUK8ZIDHRmVCnj74xebnWOacm+/WVT7p4SnIruLaCeGkUpZlGitNOgRRmt7UFMPhxVwsE8pd7aRc/Pq4qhdyiociF5WvzAYjvGnxRnnxZoHFxS7PPa1jfDNemab8KzS9U56Tzs/nDFd53L9clJutzAy68lyIOHuv7HmiR6RKWBS8RXlLLePgJt+zc+6/4iM8TCl7Zm/E9TiFMxi9RPTaRY/rMfiA0svdB1tkVpzBaYIBypyj8hKAcKwYhYES5f20b0WVOqGVQ+IOLr8ZOwg0NQIckGipnXLPzWRLKS5grDj9R/OYbA9xCSKnKJDdqkjVnGNfggtQCsNKlbsfDM0vF/MtVtTzj26ZJ0ZK9BgGLMgrZfYx+ZMogR61s6Dk/s6XocbNcpGZLei1hSTeJsPlqtEHV3MOhc5cP3fnjRncV7iDaX9I323Kky+HcV6g9paOF8Dnu1kz0xuU/f/vytrVfnqvGWFXjqbAtX6S3X/0tBCz4NNNhnU3KQ6UsHzaWfjoW6SBR4DRAKLRH7BmaFORXwBQ5ou3IT7hm/2Dc8kGqZroyfdP9Yrso4a9l0qj7lUTQ4/9uIkCH/6ygevJ0j4gw/SetQ+dzk8JA/ngroGYPqwQ2O4/LtBgu6WBxBpS64mz/00zTKPlbFOj0T8yDMO6bhiWuqKe8YbiZSOC/7fGj7jERRoaQxtx7/giXFVSSQuFHLwRMo4xFiuCC41MAxoEhqG0xWQiAVqHxtxDFHAt9Adv/v4e5/DsBOdUDgIugTUkI4BGuBwLOXy3rfAHwq+fqzavlgEfbdl8WPgLPcu4xUFe9jhpsZA0A4ESXDb2S1NWCy4EJiuHw+7oMFaTmUJwAsc5XB4H0Ze+K0P9Yg2HP/QKhX1uxM4oOnpq2CjNxtw+JZXL40blHewlt6xeO38wz3H9V6v2LF8dJisGE+OPvTyFvWttsf89OWvv1B7j8jYtkERqSh/ciheHvKyWjBV03ZVfVbjYTM6+vyPd3S291TaXzsf2yH4s5cy40O6080Vimtf3Z+aGCLa1w89x9k7vHNq72IGYnttteNb46YU3Yl+t2Nz27bTmbXs2b+Zt/Ne9s73u2otie99+xLkpvD+LB84/uJw6zP3dxm69Tj15bF37L7EV9F+dsX8Jf+Riefj4p5Ov/fZmUWqYKvnrtm3zDp4p5i9bes5u3xD3nNwl9yYMEt1NkLorYu8fuHy276CcwsQpE2dO6djLc2lubyTnxK60OTXnh741+G8dMvW17utd07vpehZmn1NUoqNSh3+7N25c+bpTp1b2v9He0O+3pK6dnASKeP70r1duEFTLu1ZNEnVIpYasTxq/al3IizqnnmRwYKE5XBzQFMMORIJkLXMCYIiR5OJmrRXnwC7BEGDlAIay0FweT8yxmBkOYoEmPxsIwSk2kELq9Faa52RPMBTNWuAkxVA4AAzClxA6lUZDCmV2Qq4t4k9iNKybMpMiZ4FFr9eoLARfKBbyeRwat80USmuwc+GT0Gi3GvUWgOEERgEIjIMbqylHB4IyW2mGpmAdDGob3wzU/+paRC7nkuz2JcJQ9fvC8EZAGPU0weOwjfh7cEOGTRwxAg1yloLAZtTPGIbhYFrSXmJR6QGXx8UgP8BWBwSOUyaGL8DYOthZ8z8aRiJC";
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
