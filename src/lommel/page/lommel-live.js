// Made by `make page` with ziglang==0.17.0; SHA-256 of the sources: 53a27f1106463e5f334476f53abf17db4139100b5310401a6ab33dbae43d22ed
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
const wasmText = "eNrMeQd8E0f2/8zsrHalkbQKVg5zvuNWGy6X3iCNZq9jWrgcJIFcP+DABEQ3TrsIy2DikN4LpMly2pX0/vkfgfTee++99wr+f9/sai2R8q+/MrJ237w2r86uR2zG0gWcMcavsLv4dMamyyIGmx7DVQNmeOf6y4vTGb6iWOSF6QYRcO0gtFEAjihAiYImFwqFkCsg4MqBoQvmRARWI4idd2gtHR2A7WI4yJ6KfIFh7Q4gsFKgHjdtaCGwgzjimGBa7QOYrIAJOEAAC5q/EDpB5pgaC0DPC2SeXrsAYqBIU20treVlKMC0/mgpGXKaNQhijxaCIItEYEhEX8YCMtlevQzJWYHdhAkUGIFtRoALFzPDYIRRCR0De3APKaFkYKggs4JlwshTBKNQFSuLRLEGW4VWDM0ISYUo1iF/FOvIOgy9WiQVhoUXgrIBLdBr0krRHXgAGAFD5BApiQdKClHYIkfCWNoaWEZaE8VoAB+KAYyHILFbETYW4MJcB76CHmrjhUiMJqG6iqdaQ3gPCwejllGXVrQWoFC2A0PTIi2AQkk0iK67qIAi5UH4KXyVMBaCBaJKgGJdK7hhjobrCNbQXkWFHQQ6TNoy1AddY9FifBkhlwEpxhs/OWTG0rnTli6csXjpnEXt0xa3tR48t/WQndMz5y+aOW9a+9wFrdMObG1n8dj8RQsWtM63wNXW3rqQJUKEnD1j7nymjFJqTYqxZCrtOJnNMgMyNEzpOOl4jJmOVI6yM3XZ7IDNfwICY9JMOwPT6XrpqEGmKTHS9ZwbhhCYhX9AOhgDoMbm9XZwcdRPk1gg0/CzARkGFmYyGrhFQ9Uz05aVoRzb/rniSgEe/Iu0m/OAs7ewhvxyS/mrreTgraWzzbbbKlptO1dtr3ZQqs7ccfudbNhrbLllXd0Aq27nQXWOUs4uUgzdaYAjh8mh9bvaGEBy+MYZHHKYGVNSmWlTKglIynqTOfRV8IaQKryma27hdZPJ9wn8wBVjN2egxDq7yz0Q/iF7Dhyo1x48HKQRXMrh/bY4gCQiIqRibKTNYaciPN8ZQVE2lxzeOECBYDp1ozgcN3dU+GYCJcwZxjlcB8oerupHe/Wm2SgbZdNwXzVC3851zYZt7+WYLaZp25yrNK+H/TA0rWhIpx5q8KeYQwNatzJsPsa26wxrF9viY8dls9w2DMMcP2HvbAsfNfHX+wwf9BuDT5o8SO3r7MfTP3fsuv0Hp4fYk1AOTAeA1wdFlLWyDoc8V5VVRw6R9WqK9ohN1TyOyo4kIG3L0cohKzhiZBgQ2UGLJB2r7gCDG5Y9ZKKaOHhwXd1ge6oSQoDjt4Er6d9Zyh7Gf++kZXovxzHcP/zR/lPasfUY/+fxf6Q/0x7/l2lZTmspBMzh9Q5ghJ+rYUOUGkAJofqU0ycNS6dn2H+dVGepIVwZyE1/8Ti2AVv+8Cdh2dqCydoCY6Kc6cxKp22FP2m3OrYCUth2fZqnOedprcA2pchmZ/9p2iSbH/iHGAp2cN2AIaNGGdrbeq3JtLOUzcA4pEeONnfMmsw2q7HS3HHT6ShUgTEna/xp2lz+BzeITj70VdpZY56abzc5XDr7KEWuAK9tErYhBnLBh8Jwte+QMXULpFxYN3z4oEFqq6GW2mpE1rItRDGbVaol3WK1cOVYU9FfVtqqKafJKChdv1TAtpzM0+S0YrrM4YiRrq8EBB/KQCUBAFtmKdjD6pXp8H4AY/Dggd7AgTZGo610DO1F2cU7jaf9I9uCxbC0XmErOSybzS4Z3WYPt+HoDhP5UuXsYe8r1WQsAJ2wQEErAKMd6hlHGKjMEAhSAGsOMmWoDXo1TpFvQIILnCHbwYRzsHmiVOvq6pRFJleVOCmXBgbhoX6okkOHBsKH8PpDgmhZgX7e76vEh9nwbzQ/9DD7b4EhnAK1eHy2ZdiS0TYGp4V2t1HxUawCzU1y2OFbFna34NTvhzUtGyY56JiAI9ywaq5aOaMleXqyMoaSoZI7Aw2kBst0ICS201G0dQEhbKAGuwWtVo+4BEmGSGiHNqKTD5X1soKyK3dsxenJySkZPZbzFRyXzDJp8cX8DnxMydkKEdvNKnK/s7PTVkXmdz69XN+ZnjwWTE4N7+tvDphufRxz6wSxeWxB64JFbYcJpqbNXTi3fe6M+XP/1opeblu0aAFbzeNLW9unzZ974Jx2dnYwOXjGwtal7HxuLF46m13A1cyD2qctbZ25aOGspexSrohl5ty2mfPBdDVPBuC01ra2RW3sFp5etHAaBCKOW3lqYeuMtmkQb2+bsbSd3cfjRG9rnTFzDnuYJ8Bf4X2Ux9tmzJp70NJpi2azp3i6IoMH/dyZrexpbkdaXuPyr/MPamPv8YS2Z8aC1rYZ7OKkOat1cfsc9q+kRs+eO7+9tY1dm4yF0A3J+FeCM5+r2/mI0SNHNY0b09w4tmWv8Xtj4/7NpMn77rf/lIP+wf/Jj5YPmA+ZT8gX5bOxO2PnWZ9a31gv2a/Yz9rXqxvUo+oxdQI/hZ/Gz+BHiG5xpDhKHC2O5SeJs8W54jzRK84XF4i/i3+Kf4nLxZXiKnGduF7cINaKdWK9uFXcJm4Xd4t7xX3ifvGAeFA8Kh4Tj4unxbPiOfGSeFm8It4Qb4q3xHviffGB+ER8Kj4TZ8tz5LnyTyX5pew0l5srzJXmyeYp5qnm6eb55gXmhebF5iXmpeZl5uXmjeZt5u3mHeZd5hvmm+Zb5jvmBbELYxfF/h57K/Z27J3Ye7GrrKuta6zrrJutW6xbrdutJ62nrKetZ603rDett6x3rCPsbvtIe5X9jv2u/Z79gX1h/KL4xfF/xK9OXJO4NnF94o7EnYm7Evcknkk8m3gu8Xzis8TniS8SXyVWqzXqLHWOOiZ5XPL45EnJU5KnJs9Irk6uSZ6fvDCZOOlLb02qkWWWZg7JHJb5W+bwTCGzLNOR6dRFj9Lv4pmVPHMEz3TzzJE8s4pnjuKZb3lmA89s5JneZOaYlNqCiSafbSXWP758FRuTYkz5SOhuwTzThSZh6lIOJtHkomfs8Snmshamx4vFco5pfJ8zCXjuLz80n+NJoWpZQNgwUF8mNPgrFhMLV5p77ypt042KtusX76O13WUFrLUsIHw4R18mNvgnO2ABA9lg5S9pHta9rqyesC3eIYq8w9BfowNa2VrPaB626iJPwtglnlntxl7lkBiQfD/vd2ZcsyFnKrJnrRfTkpYm22RatWQskoyHkvGGnE2SYq2X0JIqIENSVEsmvk8yrnSsTX+jQ9GxQR+fClwsu6LkKDfu33tIPpcEU1wTobVCdZP+PdbYBjBJqFuSS7mWvluu0nfpJpp5d/PGPj2crubOYGRW5hJuDCR4465qBo1pGl/ppV2D8AYJQcJzOsAYwjHQNmE3OgpeBkg37QJ0AULWjbkO8GCfckkhl9YOJl3TtfP+mYvynjnPs30OR4C2/caJ8Cjh2pd05ww34a9HDOZdsiqXSApy/Vi4bmq+pjxFtJnlDFA0po/tAwTPxYBMhwS6uWm/k5MWz+mGKfFLvMyqlWRTdzPb75KVuRiMzazKpVFqgWHjYEEyZ7qJnAH5hMZDvz+J1Ec4GBfaZpC9sDQPmx2iuobrBLoNiAYf13JTS724K6Ed/OkCmGJRUAxSCHhZziFmWJRY5mraMsS++FvIODnYnpPEiLyOzclm4JbB2yIBWK6BxA3lGpNRMNBuHOYlLvKLeQ8ep+F5800MWrXr6dB1wzXJ7pwJrXrd2GSsFDvMM0BPccjwVXTpAqtfzMWToroSYV+oH7lCqLE+lpUNN+QElbAbn4duuuUQ1DFNAY0jqNICt0S9ABEPVTwDSxvNKKzJKUHKsCxdVq0MyhRjPUOFhWt4ggqe9XiVnvrQKkMLK7sg9OhuMDNHQIjBUvCAoa/vF8PK1/6Pfn4HRuPTadO6VtfkBtw7D+3CIpEjkK3oUXtyXvRRUNTbY8gVo8nF3omAjEWsmC/zObhBEQFZJJlCsHRC1BeCiyIF2C9qPjLeZRPgts9d3u5xiurEBo9D+ECPpRiWYTonvuuyeWDr6zOW+Msg6KcmUBkCz/2uTpn3MweTEHguaQZTV/dFOQ4DQwnR7omtxOVPYDf3aH+HeXqSh3Sm3WV5v5CHB7vBCcTJhxVNYNQkv0g7STN3I8WB56QTXn/7OOnk0AlWPckjZrxKIXcUSHdqkrYJUnoWuhN4qaPCKjZSXGGFgP4+YzeNxEzHwifThI8VxIQU4gcjc0y5FDojHziw6Yypdi6RMl2POk2MgO0Z82Aq3agbfZ4zkUnD7+NLkDfXpAt3zTz2S4ab7hKOJnGNQFJqSShTxAvLisgi0BMadL2oN2ImHYvSqahR2IIKFxGd5/EhGtR9BvtQ7mElflnMCThYqct1OdRGZdIHNkhEn8qzzKVHB4a1xJP+Vw8et0LSvin9m599cqOxT4oDvPK2m/uMSfBFbyCG1vnixuYdXl9XyomWg0cetusHe749KgffsKvQsw4y6LE+ix6/DCZZCqJs/1QMoh/s+TVEu5tmweGKbWR2TAVSrxpISkDAgFIGpVJBcuOKbVvHbf5FY7nS740uu7D0rfDkdV6/GWWEF5mOTCzDRr3bVDCNVUavhf4i9HNtNOLQWDHZ0CVw7R4iiQJP6gwGegQ+Zo/HenDNmYoSENlT9mJldGT0adn+lvjC6zYcfWO5Zc/9Xu+++4EHR5fKLdc9849zB92fXQfwiKkbB5X4HxoBfprZDKMH2EpUGkueFcI2NlTXKvd4sZ4QU0+pj5V7esu5GNlOZmsM9qweXQU0g41lfF0BVJR2iRpMG0xwigpI/eZXIOSVIhB59uC6mSmueWljLEUGhqGV0TtTztT690AJAefKeQE2prF1wEaibqxHK8TmWg4XQ8RipZ6II6TUGgl0tQl4LXQZ+Kh07LENUeGXggiIqtxEmtl6qFW0beWDPkKjJaEzc/JxmHwr1NvS4kXqOVHQ3Xf493Zefw+JZkKWHii91/h7pCGYYny5rkiPPhYVc2+OoZLB0BeML/rYASkjKL5qqSlBMntqBI2AC+3qGT5vp569y6JWNYJeW5IyaivWgEh/H8lwhQefvOytdcU/pFhVi+liqQqwCZ/0vvDyjb/MY7XswfqFPFalLbL4xVMu7r2FQR/loTp5mPanoyd0+oVTLu5azw5ocM3eHCJhUMct8c+9aU2fgQJyu0M2p2vluqpcopCvo1YzoxamrEvMo6an9SKXmkq9nlnbmGXPck0UiiddWfbMDVnPduUGj7s2tJx3+6EPxtfc0ljekCWmlpb9Rr8w4KOb0Q/PG/ecPmvsHehP8G5IXnbo8T+/bcm9jb8/xTt1yISHGzd8yDd8DLz8+ozVq1c/1XjKVBqvhXjP3gDTceGlEgy0ekpwpabwmHrOEAaqrGojpJpa7RkRhl5m+GpPRoja7Z7c/CuxuJxu0jXoO8szG0Aj2Gzw+nNNyiCCdACiHLbcO6I4+9zS69OwHbNoevvPyh6naormwRtRppvMPg+ao0/ZM9ZoNOhrYIxBliDMPQGyRFNXhiw9JFHq7YnU9jpU1ZF97sxaK3o3saL3P8aKsqO0mmrl3I0+31UO5mrlmFYphwSUBw/wh7kQVeltzHG9adQmhK0Osr62+lls+Dc9e2afETX4x3gscldkjqZFdBigpXZP7O2fwyEDT/AzV0ot1XLMcz/dfLZ7+vpSZjU2uYrg+mK5H6J/fzkFImDxqrZq1lvq7yR1nDDov2JRCHY/Xm21CPaiCcEGBjPCXVLjGdD+KR9teFTkjOotZ/Je5U3V4N2AOO8BJ/ggbix0wx2CN3dWRhHbhG5oV8JGtLVu8TI6+In3Xn2UXU4d/NS+b9x4T8ubeKzq1r758Ql7T//oKxDcIR+e/OJWG0FoOfn1Gc7rxsbGUgm61mr9hS59swvrPNJJhWf2kIYSBRoYQNTMTN0pJT0txA+/oWE3rc0sYlGSOkYt9du3TPkm91VjBViHHbA4tUF3dUP45g4dBoQ/2EjVoCfQTfXAkiLcQyemxKabP0goLG1CKHNvH8lo8PhOOanq0fTlulI/3Fj1AoIHjy/wfmQoLXYmNERiYIjEImYOZqEiussIaQDJla6IWslouwYTy0nNotOIFyk3/LTsOD+/XcvV5XXlljUbnt9v++cvoZQtWNN+2ceXX0Xgkp9ssfH2Jf8m8NZ3zsQ+fBfAHG33/To2e9p7ZfglJ8K1d1IHD5l4+N8bwb3vqAdLs1NXELjQ/fVt9425jsC+LnbykAk3E5iaSuMxgLlYfxL20a/HRrun84B/SbY1qNotvLyUwVOq4Hqwz+r3pTU6p0E23Yi15zvPgvekDN70+eE/2FqUwUo/dRbyLr+orbqOotwt3gPNVwlw8Dah99pQtpMUVXf46qq3QNgcfVriX2xIvTRKQPGqK/lBL34wgQIz4oQ512y14nwK+dSWVempN91F2GWL3jEGPP6oxupxG7CRohUn73DFbddfBUW/58c1zI+9Tnx3Hv37s1/bhjUBnLj90T/71XBjfamm/AwXe7HUVl/5+r/7KPiRr67ExyiHL4TWn7JDt7zwpH+XEHPapTn+4WhwVMj9FriDzl7cpVu61FORGAlmKrkeVwLdq7URLEtQ3lOKFJSq9Aa5pEg25aNurLiqXzI2ZMMSBvy9QcS7hoyCErxeVMJaCVDl9aIS40q0KvhKwCuhi/jD6FfiCLwXw7tI2cWV95bp8cDU8TGTdwQvuLzwf1ZwUWGFwYk3uZxK/AdKrqboNGeKR1ms3kGqa/A8z3AN0oJISooiwT8USfafGEmpIyl1JPurDmUXPPEix3IGvF7e2fkKvOZRsVVKBM5FjgH+IceM/yLHaPOKPIFXVVtF7U6BPJlRY5FXEDVdg56R/92Th/4O9o7gaG0450VqA2zJvsysgkfhqZQ+uDK7m+XK3Q1bb9l0wOXvtJu4lQ6hfKbWc8E7hJYOjrE4vofmtzag4aJ2T8wLfpBoNldd5Ao6epN5/fQQE8EdnMEJ36CzN1E5IqPjLyDDszf/Q1oJkuGJmHDp5qhQ2Kg9wIuU4GQr0lN7hhcp0TOlrqx4QB/46/JLOoLXFlgo8C9nTVRSXNHzuioItB1y19gkTjnUNgVE5rh+fmJXYeHcaAIHG84YbjyfQ8BgOx1YKgVGmzYKCOdzjBib2e6a0c57YBynmaSayslgivUc/xfQ7EsXXxx+Mvjp8rzLQnu1DYaOPLLicrISPsJM+LZpLs/j3CgGJ4mfIjaQTuFYkqCc4YfQbgFJVY4cv9SM0nfH0kLhIbi/Uvg8c5q2wISOohMGzTVDeWoUJAJofSazW6AHWIlU5aFvJYe14ABCwh1AMLCOuVSTIhO8bVJmlWJbLKcZykPVsy1WaMrR3fQm4rPM0aAxpiagwMPaxBFx8K8IRTdzCrEj9jyzOoDo3JJtpvXrS3AC7ajMmk6taUytJmEUg00+0sRCTdAJn5kW/o7GBBzJnEqzADxHgwtqdOvTNI7M8iCzeVSJD+Z5SzwOil499INh/dOD+ow84eQJ39QTHnlSbUOSaRWl/gnTe3qvCv69XoMLayhT/KMH4OJML7HX4DIh7sR4jFoq+MYL9PufiH6ow39nh6A9+g+RTCJ5MX/54jx+2kT5I24Wnax1TEyFB0S827Obi4XK6dGiKVVvcLm4a0YnSI37wmt7ckpo5SYJRsTFB8Abu3l5OJsS/iSILb5fwYd9DBoq/mjnyzXUKbCG7b8Uz/tQf61ZwSMuF9fE4lTM42vcOGJ7ka5LPpZ+nYQKkETkgRvv1Q1iRVIAQhHPIp2ZMsFgwu+MqAFLK7LcGAU0F0MQYUI4WFfwm6uO34+GyfBvtCZQpLRL1dQDxlISMucHiwK6IIDcWNVvvjvtVa5ZtiL+YqEQWCAI04RHY8I1Q+2XP/b0sU0FT1R4D+1aFubHLkRP0jgkt6diYUt8s92T2xrXH4d29lS5/18oqk6fbWt0akqy7KXKXhpyw468wXOI8OGxIJRdCN9JLCUvg8wg0evceE/Z26zkARUvecpNIz0KZ7GbuSk3Sa8nSby5axVfRioe1CqgIAPpEgZA5mLVeBnS8cCUy4mpTNDFmr0coEsR+kyNruBPjPCrQnzJS8GstZWoxWEKmiPqG+lfd2jeb0R/6OzeaVVld11/LVnBT9dH2RNyMdp0KWf91WhFqbQq6UWNJ3pceML/JzVfAS05jp1tS7ItW6561XD27z9vs0d2aJmZvdxhZl6utzg7PH26O+meCTPzQDhZpjAzMzMzc/JOcr97JT27aF7v9gR2trps6erCpyvwJ9cjBByNfERHYd6Jo/CMwH91dPR7cMXA8fyAop/hSonoR+S6JXzQPcyjhaq/STr+5NWCTS4Vv5MqfiVU1BTz1w2G1n2KuSQwX0PlnvBhMvR++nV8X/jq1eee9qDbznUqHQHgkPHrQ0zqu7FckpnbMd5q90EKU9GQyRlawlQNYGzwoJ97NbzREqSQeVpO114dvBqH9hfOeUru7P0hxmdUGR1yMmXkfizPzbnEB1uR8nkaSE8lDkXDDR3399mFO3nmSDJ/8xQaDiLVG96VfUnqS6EEx6TPd/sNXT7i1J673xe393jy0tKRoAKQsXxuMybf6DnOpftFdqf7pULjmQjxpP82PRn9G87JCDNhXwuOJfuwUSruuZWjrvGbLOia4ftxvibnj6/H+ZpwO3i6hNrRCZse8vEpm5keZqH+wvhAC1TLrsMy9dZejw7LDAjN8WEZ9sIgjnHERf+KPhVP5rCcq9VDrwKPM+m/t/vQqxwdeuG5vC8mh14FH3oBcwWkuMTrO+4A5L4gl++kDxV0Oj17js+79MbzLuTj+LhLdoybT4/YkF49CuNOTedgQlk8TlJE7zq9An2pJqdX8IY0YeixrkKimJ6fgY6E5tsjraSZ00h2kNnQzd/uvmT1OCSw+yomrM+PkyZy1l/SK5wXYwx81Y982vfTMQ4G5uIbMNnwBKTTudZTUKXjmP36J38g05Ng3fEPxTuieO4Anlw5Kb5dinNqsfhGmAiR3Cvubu+8jN3t4i24WS9+jRQ/nDaTa6ysz7GVjg0ufjIa+Dzukt8lnuwPOMTP8K6BxT/ZcP6Vi69EE2Z9VV7JpjcnIb6ATK9Jqjd4lCmGJqrZR53xNJCvx3qOC5rV9/vqwOd4363y+bK3ww3vM9Nc19XDjd56aCApnPb1Jd2X9J7aja8c7JKE/h4zEW2Iy8WXMf6a/eRRUcFr/IOUwC566et9X/1HQ8FRdY2awpsUC55BLFjJRytMBuWQX0PoIKmgkhWQG51mN+WFtFy0V0tswf/DQe8KaN6SNklMS/7Tcx6mFbvkRz55lvhm6aIfzXNzIcKnCD4CbwRdrwU8FcFTAM/QFE/gLT6djyoUQJRzGX3giyV2WkMG3xZvgBGYC6/ajGIyFFMs1WiVe8UgUXO17NR6TCrFpI5iUikm9/kqLxCKQn/m6M+MOjI/Cq23K8HV6NsGm4/Ut3Xq2zr0LSuwvRO3Of5mn9/bM/DLCEfRehO7uERJKcVmCbqZaxAl3VPayXD1FR5XVZIrl1CyBBQCBBWXKFDL3kiU1KyBvPP2KH9yyR8j+VNz/ow6+HvxQJ3Gx3oHm02jo6COP/ChYw3O1w68XmJ5ufuOpaNPE0tJ76hj9fE71ow79l4Q4jlKMm7xZo79C1VKXcMKe0NBeBMCMD6XfSpHXqbIqargeCS6QpykfMZTLqfxJDo9ja4EaBjoEEcHFhiWpdwf9BX3PRSWYcx7JaBx55/d58vyffYJiKQdKiDG8sK76HWUdEJJR5QKr8dD+tXHnnW/65Oms+63WiZzCIDvvvyksBUaPuunsnj5++mqZs6MLh56DdllTLAgB72v+y7RSw4uH5JnT2AJBYmcmRIahn+QvazTrOqPK9GlRdeqEoi+IinCXl2vm+qB7sgYktNravmSAzaY6hTIKXHks38qufBVn1Hu8qHXIv6KPoffvRq5I6fcaoMpTaaK47pK6klBL/CwkSMhtSMekG0lGZH3tr/3lx+COPLhey4/CbFx4Tf/nknBLTcHB3kEB0g2Rbfm3UhI74AAC191XAjgBIyIF+vh78TI7MCoJC+s9PnF7/vlhyRgPu/Pf0PfbbejBaABohuhGXu9Dstu7Iod2FXkdX1s7OAmrMCddfB2oGuOg265A11MiM3SfXOe69F0o+LRO8VWYIZ5K2755kAW5fgjhEa6AHNFnEnkxQSU3YhtnF3KEtyHLVIuS5wheMDbpp1QMBUXmVzmRK/i6e5oNfxhnRfRWx+9hShNjmfAQT1GL7jh0BDl9DpUvgPeYj3t1YOyRY9V0mteAoyI5dfgpVOA9DjNkUH6jC9Eionl0I1vuizT2uLTMOeSqkxeldfe4Exb86Mla9Aji2lJw6arhCDMkkh5kBxkvjvuRxQWitPsBTPhKGCIF9P1giUEV3U/vXiMylL4AgbsLF4bEBh8ghLeXIu4jYPNTej0euyrGfvKktzPEqq4bJLLqEGBuOwLeSA24nZoDBbZZD7Qx98GvU7x/0+mgkF2SJOiNhT9Z06UeXqv8Huyg17HrI3biZz+kVeKseYyh5VLP/bF8Cs/z29JF8Mf8AXF9r1cI9lIIKrHen3YZiv/o0Ngp+5L0eDbhu8zAOzx2RPw9Wj1SK8ly4lVeLRaeI1Fu+UBaJYAiDyCb+TjvU/wkUMcbZpKaHzlz5YUoD7BEMHoeha/6kdhhh70xn16oYopACbUZQgfMd64xHe57CphsYdzXGABjgrgZLwPkkT21YCHF4r/gGjhQl6NOY/36c0GJGqK/LQ3Ht/v7A0S7oneRFr8Yv4YQoJAAAQEPCAwQMIi3QCPkiOZCiw02QQwFPEJ7iAoEHcMYcIsNcbBkafwsS98hestzsEpH5zc7ZwS5wpxzsI5O3XOrjsHx8D8G5ysPeIKnJBU2YWMGJ+YPnPiUjKNPkOHwoX7zlUGUsaQiKD1zkBLLv3R5QPHGAZMeeZC3TMlD3jqiu1SEb6C3mdzvIRDV9D3KBsLd2uejYadleTC5E4NcZiF9MeElCPCBVL60QRNjvrH0rwheyDSzAXUFN8Lr/gKodFVHnRgLwAMH01fSnRi3SF9zn0D3LinHVF36wjV8PMmrClMAGuj3bm/wc9Q2Ef0ZvpPSGj435e+oC8Mv1LmC9zotmCS7llTqcWnQCv6R4V5D9/SzcHfe8MrVtRz60lDWbWk8QK1ilHgHtfc8wKVR9DQ5oET8spAmhL1Cfkjx0GrIUdWr40bNHtQ9iioRDPS9EAUPJL43VYBUEMlTrrntPTLfRnU++ISSTjqiSx0gFsBHJbXho375zzPE+Ib8M4S3tkYbzPF27yteE8bXgnegoXAPoGENGwHJYHpPlGlwMsQdBHC8aWELL8RKJ+ViseuisJHYfaVYKONR0IXhyBDKw4mMxphBt5xdA8dcrGk+KQ5jcszfRb8loaGacr1Zj6XaGWsb+/6YkPauV/LrwoG/xsRkH3U/z96AvqJX+AtjSUp1LTYmEeyci8KfQZvZd37YBZKRO4vjhsi2/PhHP9ATui3C6jgx4Ls3Tnaa5fhlQOfLX6ELz7k6upLW8BKFEz9/fyr7O/nX3V/7zE8/q/pvVb08nQsCnkw8qtLPo9EZiAHycwsPTdi22TTnhpfeOZvmV/j5n18goyPj8KzUeZ/3LrRRHhvsKDEgppYULAgDDcG9MRCCuvy/0RYl++5sL5A0yFuQS+2wheffxz/RvKVJCzvuaA0vJLf6/BaK15xM9dAZPHZ4SFTD/e5flBE5MoL/E/55K+7RiZfP3mbv6Km3LCzXFnOjdZZrl16NXYvXX6P8LmxqfYwOXoR9mtRDwn5FQXm1Cpe5r4c9LX0rsf30cwncrEScz6aXPRLX9Fr/W6DyuKZ4198WTRleX02vAB015dI5HzAEyMxWa6M8/ZL947C8Ta8y3oHvWq958a3KU5CObh7O7kLnd7KRP9QecmSF70csIXlbnHiclruZOvB4xOthsy9W5Z+dosv7FUPBnXdC8EDPPlVQ774LdmWHu7lTaKC0jMlsSMY+V3BY7wrwe7wY6Ue71yDzt7Oy7KkuLVx3Kyv+bFTHkub95kVcriV+do39NUWUUzmGOtrFvQWZzqQy3CJz1m6NdQsKdwqJ7WGdJI61JoAlOcSKMp4aydKasHTohbS1rMgPiy628GoRU/s0100jAodVYmtbVrgctKy1SHT6qnv5kjUbPe9vTtw2wm4dhu4TVTWiMlWfLEiAkXW7wILjXX0XqODejeJ2kW9Ca4GcvhQvYYUq4IgPmehgIrxwbkfldURNuv5VmALf5/i/2G9wnCQPwFQ09U1mH68Dmc1dqbx5ItJiZK/7rgZ4iEfGR+cPBVdjSEAJ5ekhpNakTR0yx9oaHwt4IORRju8luuYCupqJwOA7gvcF951FEz0Z2bAkZEjKjmQiQNZcsB1NSrDaMKYtGJQdzXQHFkUS9QiG5nQMBFfA0GBCpODGfaWi98WZlLFI+jh3CvJa1+Q1q7BiKfST8jPAoiYNKNursd5BZFi26BFiShYSYKzfSOquBblfFtJjFYUVdKw8U70QQPfit2KBQQ1M5aT0SYYtUdtSLI92zseR5ZrUc4tSl9LB5QrJuuxSUNyZTJp10xa0bJmspVRE4GAkKeKfZJ0vqWknvkQ8UygMyFUrictog162CUHOT8DltBi2QHuupXpNwepnK31X7al/6bDOXVOtqP/pDb2n/PYOXYqjLaeh4twkyE5zoYDhoZt0h2PUh6JFomLP6RQowTWYP19+Id8DqNOoxkq+1BBxTkPbW6Y4YZlbMyhs5Dheot6FHWa1XZOo1hLWjn6mmrvHfRPtfUa+qAs6s1CusrSCxkGwTL6A9vq0AtOaD9s5n4nUoyGPTcPyiw/5KP94ndRiQHoLRyh8KSIp60ux+sFmuceFNB4DwPYE2ayynO7jk2L2XTI4n6/ytsLaacQ1vTeYFUvBsWHHfJy/fXUc3iTvC+HnIo9nc0v+4oOD3hnpF7aVQRLhfmRqqCLV12OoJazh77yGUSv5Y5Hsb4WzxrokWXfhIreoSretNBQd7Mw685Q7l0Y9T2xwTnZnLFesYFcj6pQvM1GK4kSHPIt91CNNMVkg6cbri0oSoqxhxS1l7a8vM7inMyuNV3tZ+JYhTcX6+DUhfXWkiZhDkeqzhl1BchgTiAF+F1LwNtndSWENMbHPCz/+KqQu3NfyXir8dXy4UeFLpCXTiFp8A+tl12VwhVH0DtDthnbqm+AbUOo9o5wZaVuUMi+4r2RZn6lN124FEMN4p8YE7xD57C7zs+RznPwIjJwJOM0XfRtQELJFLY3YBqT8clOzeAU5jzoQ8+aeOoxg5cz3/L5BtrOfC1/M4ouuKQvqJWlTJbVsjf7pLukgOii8oW3+NCvJGYOcyr3aYe5Vr0n+SlPEZIDGKF0vSeTKkrjX9/hMkB0QI5hMDUcGscvGSV+O7gwC17FZHId+SmGG0mmihteWG9YxGQqGNAWCVzQl5IEnstP6v9pXuLoSJ3Xt5gL6rzs3WX/qmQexjDLgaEh+4YAUphyCy7BO1CjKTf8wR6u7KVCeg+NuPdEa69Eb6rrKSllL2FwL1DJOWImpgoSlf9EA3XGQa+Gf9WATh+e6OzTaMKnT6Mh0/Br0+vnMJ07KstjWfu070EKFZ3SpP3wo5Dmh089/NH8sM1XZA/fu58dviMNJ/rntsOTnm5y3OS3Hd4n9+7wfTusaJZWNCptVWilYuufyruWfDt/rhcHkUWOJGe2bhz+VDM/KRVldfi+ZKBreCliSV/hmUtdSUR1jAYGoBTK44cifPzbEeGNOyOsEWF9nAhrRNi8L2by95Xh7Zubv47TWEk6KGzxuOign4fEmEtiNHiPvrlEXVfjqr7Uk5LcB2gdnsrPD9Dcz/c5Y4aLasjIHN1x9vyLxljwikYhhUNqLqO9GoYlzSqE4AL/nIBC+m1Lq6MkMm2gedcF5gTFL+33DrqFTAF7Q07zYPxzdHuv7k7S9SnkF8pEQF41O8l/sq+61J9CgMAUqTw7bi+TSuNPIeW94Y6ebU9bO+5Uu6FTDdLWXJW09af8yfeb5ZiR0Ytev8+r/anbfHOZqtRgEOdJf+pp+bn+lPTUHqG86PaOxvgc+xWCCStNArAS6BOAMiaMr1ZwPLhiHE/xYDFbB8sMg+VtxRWDxVyVwbKG61nGtb5MVZgVV3C9J8fWCQwkDCzGf0+G2Yl9QR/dl8cfXpLACTy3QpGvb6IUesqt9Au3Wy9xT8KJhp0aLtOucY5uhStdAU+CTyasYYYXHbJE2dHqIy/U6BXVZLVVDp6JRy6WY4VCcL656euGp7yqN68WXxq0j0K9gRsGbpATo/VoDjci1A3cwB2cYh7UG17c0DgPreTVHGmtZT9WPj4z7gervLqAn6KoDawZrcnFiDMTtgCbNdkK0JV0kmZchnwvyCmIGCzd0kB7E57fcImPPJQqEdA+2y4ntYZ0kroJacYlUCSWpVRs216jWtgWlsSHZe/WQ4lu4gDdRcuoKKIqsbVNC3xOWrY6ZNacN0eyZrvz7d3B207gtdvgNaKMC8a0mYgIbbYLLTQuovcFuqgvJ2GXSW/Ey0AOH6ovIMWqIIjPWSigYnxImaIyFXHTnm9XcDO9EcXcCg6IP8m2NDWilfSLc30RDJsj074Q1OlIgrQIM83bKPyEdbCd1cyhCwyCLj+fdyr+WBmkG4+wSGGFP6YXNpwg3Yr0SC57SuXiFrPCOk52sGkvqYo8ABcvtELZKRSCSIO/OQm5IefWm6l0PaLSf1+o9L/a0+WF4pzaQqffKHT6i4ROf8UWOl1P6XQ06+sHaGaX8OWe+0zm05vHaSZ96Kstopw/kgQP5Xzz3N7uQzLDjcc1E7UiBukVMWnaBum+ASP13L5GO6nMfOtxCzJdShZiMGlC7UIMiuSxnVtRJN5KpQiOdSx26bDbnLHCo7PIutt2t9tntmF6RjBdbMf0zBqm0k4QJEwtO3pFIAW1pBje9zNwf0d6nXg0Rz0FRIJziIkqKkWZQxPoTFoErcY7QWsTfW630+cq0ecFmkkMliOS36SO+HPSgySe8uewy6hjKIeGGMqWpIU/R8Knx6+CmRK7zp+LBxHF7MiDQgj0MHwwCq1YzJhNGJnMxBS1yGDjWAT6H0wIdHXtcKMQ6KR1jUDflCr1KNeLOEqLzRmVSftRWrVJDVclTZWvWJMEakfq9rjesgq5ruLQqNbEZNQIRK00EauoRwVXRU0gxdMsY6eaJExpVcaBU242uJD2yaATgzJY7JEF76RWQJF03kuDYhEmvlbEJO8X+yPBVpBA5kM72xbqnGskY4Q6p8L1Lpn0XL2t50LPZNt6TqqCps3EOfVhUoFM5bQSW8/lertGnKMk5BsGwZQ5R2pLzS7qHIkDoRXqHBgJ5l2rUewERmA2Vd+3bGCiDqvZBu78xsSdQ4ZxsIB/C3f+h7u48z9CpcxGTPn5XIoid14E7rxAQTnhzmVZR7st3PkvVbrC33TcxJ/rFf5cXzX+XF+L/udic+2SvEG3gAGVCuHPcSOgT/lzlEsf7eTPk41qmw3pTRc9QofvJtAh1TfcWBbWWUiKMYMO17Yw6Kk5bAvpCaPbGPRaGHSL/pow6Gw1baWYQofROM7tOoWOyQUT0XMThT5CQSj0dXjrMYUubHWVyGmh0Gd+2qHSHEiPKfRNkDcjyOeD3cahq4BFKXOZI0/JIjNJVfKqoDyoxUzPqd6MWXTo8kVX8cRHrSEBZy3lRF/IrAGBxs/gc+3RRbKOlIktb6TDMSYxv8o8itIgm6MMVdkBqcfQqSJbXk3SZyZANNPMmSGGUebAm9XMmU0ypwjYKaHL1Qpd/o/zOj+n8Vf+1khzqNFMjYbpNh/sGmluhTQXeNZYc5uAW6fNAZNC5Rptjg6scC+YgdXBF9RNaXNMnkKb/20ltPlpoczp4zRk3DbavN1Am81AMjuhzdepMaKeMyT74dnD9+nnIMlmgSSjmxw3QpK1RJK15NwCm7bZZpKMBj9IMvHOeazMs20kmbBeLOkt89THD0cGgDi+wQCC2cgBHiO8V+wMT7jVY4QnRwIOpF4TST1HDB4SWUkiKMzfXESLTUgJIynhQOW5S52L9F5PSnIfcMVW+uI5YdT29jlXhouG7l0izP+mCoS5BmFOahJhHrhy/HPSu0SYiyRyjKbOvSlhvjjoTsgssIiEucPoX7y6O0XXpwNh7kRACPNTkeg9jQCBKZJ4ftwuZsL8dOc2Jqzhfp9zwtbjHq039KhBwpqrkrD+tD8VWV1MoPq5Q/6qV/vTt3l3+eg46ZQ/DWL3tPTUglA+Ec4b5MwBk+1CCPMEoBXojwC0wkXbFRwPrhjH03LosHWkzDePlGPgipFirspIWccVoMZTiBvXQL0HB9ZJjCKMKgZ/IWPs5H6Afi+y5ZrZ8pMzlTjq3iW2vAlsuWOnhk8mVqt41nj+n/qUDnQaYcuTF2tsuQ5sOTwTj5yUC1uO4LybsuUO7UUoseXihllZhtJhoYtsuR2x5TcmtlxaTdhyKAls+bdVWhF9prcw5nrCmEOrJnVgJ/FV0HrKlDkUal/Ql1DmbN6rJGr7AjE9t9fywIUbj2tmYkUM0iti0rQM0r0Br/ncXo15sdLjFmYTMSbOiSqRXohFET22dyuKxF2pFMGxjsUuHXabM/bIb7vBb7vb7zPbUD0jqC62o3pmDVU9ZsZKqKHvK0IpqCXF8L6vfCXSorcQjyzqKSAStBATVShVoM4r0Zm0CFzGF1O4JrDDt9hCJ7uRVYM5HVXXSbX0pqgOAQ1nAt1EJDJ2s7xxGuIGrpYgBQ/egDdjitwuMQpWKPKCh6hQ5FoaynupNlDkBQw7rNxOKPKaqoQibyDU+LpTKJR3TVco8ku5yi+o/2LvXwAlu6o6YbzOs07Vqbp17rv61u3udU53ks6TBkLSCYF0YYOJAcn415GZz5mJJjh8txsmQeRjJJAOCdBA0BajJiGS6rqoUUGDIF7k1SBqVNBWeURlxogBo6AGRA2awH/91tr77FOP2915oMxIJ7fOPnvvsx9rr7322muvvdYrx00KOCtPz/CEKmS3qI1T9TRVsyZkr8tremMbqKW3p3HBPSnYINbNbPjhYBHC8Kw4etKYV77i6X6SVswFkLoIm2gB+Xrjwq+aUvmwGrDyrSmVa8ZaX7Ot3/FqLTv7SyM00ALy2o7XqO1YDNY9YjQ2ux8xIG6nB2KA6Fyfl2YZO9cS0/hr1Viql0nxDD2j4v9+a2AQlh3U0sqI6Ur1YQGjhncMspvwrTEmcksimaveAkizl+/8yfog+/E3mtsCGoK9PbWJl77G88WBj7PfV7V22JE7i21P7O21XlN4oPR9McXZSdnVTe6rHT6sathW4R1GVGG5XFcmvcKhn5Bn7Z7B8RtYRnjLUVR6pxeo+y74YvC0MaNmYG9NRF1pvAfir1KvgmgG8pytOfIcNPBegYZ8x199to6vNB9gXcnrguuAu3yUqnlbH7bt0696AZrsHd/Bh2sN6lBHLr5AJETVPvcYXuBwcSb7O3utIw9srqPWYn5pO3DfH6e/86x//vm1pw/3veAnln7tN3/jgQ+wWcDvPetbb7mj/d0XlxYC74IrD2ds8J5Xvuf3f/+MX3jacN9ZX3vFbx9621NgbPCWGy9+8oMffCeCV/3jx97zH//bLnz//3vllXPpT/0Ygg4E6mAkcIb+hunrIz/klZu87EcB0iK8TdaKIuSYN0tMdCSPARxA5auC2hgfTbT2CijUavAPznVAKG+DBcpoPY9Vwy5ez6NUS/kgLOUofzDiBiZB4GB4WdEAih6T2zSMqr+OZ+lP8vX/6+6DMOHRvwvxnH5vmd4//BEO9h/AL+f8wrvfjMKaPc50VFIGv4EUjmimVfzyhuvcX/1PVoRdQ/zSQB5dfWT6SPRRG5D7osl5h9REVnlk+kj0URsZAhc0sNO+omHo629u0lfEo6/y1L7+lvQVv+N9lZTB3WVfAX3xCHMbjyw9+p5qX/FNE988wi7fw36yYIg+j1OKbxP2YN8L3/yMyz/V/gy7uPLuWE9v87zg2so0GQ4ZV6/9xO//5wv/+LOM85+//czXf+6z/5knikyGV3z1Hd/9F1t/i2fQJ773Q2xj8wwY1vyZB2Fk83r2bqPGPp3tzIgCYOmlaief84oDA7UM5IxkCiof4eYcocjmvXg4OJK+CW0bJQOF774rgiNF6JLFJmfpGO/w4u9y+/6ZW/r//YcPLR340H9ES58thf80z0HkkR5LaN/H9xz6wF/9853vZw8v73jX+9/ytzlm9tu/4/aDz33lm7jvaDhjLJt4TX+uKT5UIvhQOb57otKf1sCQLp6E98EqU6VHStU48+1FwN61qmZe1f8WoGVezt/7fDGT9pDPW4z+3XcbLzAlXbz9hlCtwekqYmlDGThYIULcHxe+/XuxqIyajzUewg6+55lblvZelfvk3gZFaMNHBwxyGMDgh4vTW4xlbbT3ykprKFhnp4NveeuHvuU//PXiMwb8yg4a6njAM8N3P/sffvDqh3Y8AznvTG7os0cFcWORPPz3nLry7tdf/6QjhNSD/+/7b5dUk3Lq/cWv3JUh5a6fefhIJeX+Iz/9zg9d94992FK/pntrJeXiv/+jf+i+5BNIOfzuv311JeWM//ael7d+4e1Iufeaa/7fSsotH/0vX3npg69ASu3l2/dVUp795YOX/9UXnykp7zu2WEn5/Gtfu/0Z744l5eBf/tlelxLe87zkba/94F4BzMJbKinf8dT3vfyK/7ymKQcvr6REp/3j9h9rh3srPifyRJbkfTZpuM9+PhAHH6YQfissNL+0ae1Imd5ipEzvJVKmQwYp06CJlOkjgJTpo4aU6SONlOnYgZTpWKUpFg8tdgo0U7PVgW5LxWElllc1bEul3z1jJ9iht9r1HXVgcrta8q1wSdne4UPqH/aFbC7Z5T5SXoId5s4HpPKIMwFUL1NXF2zHP6D8dSuoxmdfNLE+x942Lbs3mf22vOauEQvhrg2HzD5Q/TaYwL8NK0hIddfW7Gd0c6LWr83s7+4dirNMtq47TPeKx/aza7d8CbsWT7zowiaDvh/6E/7Nviw6AH04U0AqPzjyJyUyTX898JPr4mv7skHATudQl2qw4HWwS5z3rbG5y83iEcSQjzjecSEjv0iWh1JjWfJG+WYB8h9+8hYxwpPve8d48p6tjifUm0rI4NAXhF98ca1p9N47mH0wU+q5e9cVCvse+rkv/uFzvu8KHu+mHhdqdqXyzXXE1TmOmrcVqeKQHqHHEknNQfbDKAdRkUQ5Y9CaHXy0podIT9Uq8m3gyfmB+KZmzNs4fC0rz5suKGI/+ZqaVR87M/suuGzH2XOvf/AHyQWv7Emh1BriuIrSYS4e2qDzBbBiO2vlsI0Kf9Uwl/NZ6i1Zaul502119g8BC84z7uSyf9RYd1x8tueVNl09/NSMpxxVRfTEXOl+Yz4h/a8w7inINhhDNn1fUEzJHlScBS5lPNyHf+cg2mB217cjK6lSQOGhaWp6Nk2f5/lT+lDLXvUqU9yFYg/ybaa47AbEY1NH0kNf+3gjYkc9srl23znabrxv3u57Rtr91k3b7Yq/a7R4vG9e/JdHin/bSRS/MVb8xnGh/rvV4t91EsUfHS0e75sX/7aR4t93EsXfPVo83jcv/u6R4j+yafFn1gxCHn7VSOH6fgzfZV8zhO6NAe/i4fHSkR6xg2+EVEXgaI9naM+3TKE9EGRhkkZrFCpB0YijPiJ+oRJRXysXsyIyXzXXqrbfHWVB/hbnp9BQKfFup+kVhjJ0JMsRJ93Lmgo6a/t2e7+4+I9Pvx8VUKjZNJfk8SqERCVghc+NByFxgAlB3wQwAZLvXuamuWXT5Hve3vXC7KVRMJcyu6bbbY0IKzWFkOuBrB1SqjYyK0cHD++bY8Z9I5jxVmQ90awcLR7vmxd/8KMjs3LT4l/my0m8zsuxCvT9aG2kBiypYvz5dlMDTTnvZu48RTMITzLP3WYKo9SR+TpaLd4379fGSL/edxJgu3u0eLxvXvzHR4r/yEkUf2y0eLxvXvwDI8V/9CSKv2e0eLxvXvxNH6sW//GTKP7e0eLxvnnxd44U/+mTKP7+0eLxvnnxHxkp/r6TKP6B0eLxvnnx944U/4VNiw9Y0PyfR9iQsGLD95dg6it7nYqsjXlyNu0MA70gQbKAq8qRl12vvigorPp2D4ybL3VOlp7hjM4ksyKyloy5RBvz7q9S6ffLNuGN3vqjr6rwRoev19hbRmJ/1MTeODXvg4ersW9C7KPnrr6OuTdlDzdGunXzeAcu9PzRSnytxM++Ai5LEzRV75B4J6zx3pEaf+Lka/yN609QY1brf4ELxw7sFuRNz+QmyAe5r0has6fPfvZTN6FlN3n24z/wHPO52x3U1GRTsst/AAXrZpH49ct4VXVUdTuHlRd5cJLlPPEJkccZu1rYAiu/2yI0fJEl2RuvV5z1GRjksYf+bEPRnU/b+r/6Op4ykpTddr3G7lzTpF+D3f3szRKr8dmn5EM06If1AGm3JmFCvUvaA5wwBrBP93kxglhfH2KlKz3HeiR8h+73yuy+ye5rdl+z3+aP8OvxTg3WxJOiToyH8BCgKdhFoTSmmpan04fi7Ke0H9jnqJIcHMWlOufIQ5NEudDP3oKMLW/TJIqf4U8WHGMzW5NvEHmHIEe/hoP+w4jTJpt5fzsextIWGqu6Jg+nXAByoIABCrCKOBGaG4myRezQ+EbPC6aZBzf3qoD/4ujFnAF29URwgR8Ybqa7imkUAsUCO15godS2uRrVPqJYwTey8qA0nOZMbKfvxgihHOf9pgihtWAckEtrKGQjxhz3nLbtNgwCU6TW2JADWhuIWSuMQmsorGFglSWtwoe2zvr3VO1P41BExadwbBHYCgKtQLfayMLh7A9uMFao5QRK/Ya4xlsjIGRu6Ik8GOocD/Kzfmkv+xdLlbiFpf5ttambtTGQBmQHUf3jP3qu7uroDU8weq95nFuheCztyKrtWD9BO34OPpKm+MSX2kEl7MU4uSgWQjARueGTwYgxFHLHkBEAQwi1If4rhzCwQ0ihnsm/5ZBsavS2ZWzQPxIQgiZFqNVVHXOx+wVNDXrFFr1QK1fv44uWXm2UQuvSSbWyY809UAyYciVSg8IBD6Rld6BBK4KGat/Eq3oFuB2p/0aguvOGKqgU1/5NQfVzN2wKKjfHfuHkQRWOgMrbBFTBOKhkTR4F1R03VUFlJoQCK/s3AtbgpuMB6whS4cxMmVWSFVpWPE9XPBitvyC4C4npDUlDjvt5X+q9gn/lz4D4Lia9DWspvdyWi+9OfIsLgMMjemnQ5w24Rw04ohjwE7TlFg81H8hVazYBLBpYVPkBC+y4IZf9DJoj7qzS0nNZ2m8dKGryit2DuhjDYotV1q26ha+m3vGXQAPSLODQDOIabvHg0SqmevazqAOtFO0jXFjpQrKcADuSaeUCeew1npaMKB5hYZYxrA01mTPv3uOrgS+UqrdyzOLQsP7vHvoaZOKASEtMjukuAGS00T/orWmbtbmgutLgO5GFM0zZ6bcfTsOruTA8rzDPy81TzyPSqq1P71vkMaM6SfVKAovV8w53JjM5uE9aym7zJPPMzLOmGWH5whfDQXVI5os5SmkO9tLm+eZZ/2pWWpA7AFxbLCLteA3HEGcwEBekANLHf+0VCwBew2WghTchRnFDYhf0wxmaoYX/0kOiXGyOrQDbR9bc55ZkMJiSqPmyM/y9+Qwe3FhRG6CWjBt1KMXfpTD70N97zZq0MKZ408YtkKk6n0HNQJpZbmU+a3CHWtZo0cweH/Cb5a/QcwXVAhe/ID3kGt6UL4y1vgP48Rhk/YO0lmfk0cJ7IVuby+s0j3L1+t1BnlEGKjmjGhrtYOTLDVhfevBfoCqrjfa1xdXaIszMjB8A6XvlDiFPb7taf6/vMw2QgxxwTcKxq4Mb3Vs7FqkI9MzFW8tVEdJeB6nwSXpJBrUqH8fP9DfixJeLKMG1kTw9q6V2dNluAzC+h+C6XZgfdzjmZe8QpzV1Vq/IEyWUDeRJoBuNB9joXeKQUG7UZHchPyybXSKAWIU/DH5jnWbiCzTP483eQ9IjMN/Uoc6BIsseRkw+C/VzdHsWtXAONo2fe3rWBMgxws8NxcJU+TZA180+xMPDowz8fWaQo3EAl+HgPQYFl+ZiqINbPR7a9eyitv8AQ9VQ6ZroNXvU4ScjyAwewKssEB0y27pinrj18wSIWZd9HamdakCoGTRiRhoBXKCG6SJXyXyaFNH3dMmq6eZfbuhlX0Uu2//Ziikwecye7of5AuI5cL4fAm/xiMFHvm+Zq3rfsso6nMfJFJ6i56jJwBpSYiTCp+/lM8w5sZDHjQ1Q3bzWCgXRGYryDoN9nmYU3biNc+pcEWOsqjiAvN1+IDZPRPOyIwPmYcDwUcjgkE+S4buFxDCEACYRRrGGqlLsDiY4gM01MPnQSMG4OeJ5j+UXUNSeUQysArssKJR9TbGJARty5CoSXc56/yM1+DwAjlZj97jIN5WR5CLfqZE8Qez2fy491khZgiN3ukJ+YkoFWLOvdSx/XTPLxCgS7nRFtYu7I1FHKmMA5DTuGPBDRXN/P9Nbpx5sxVFgbsPhSwSS4XCIEwKzkOl8bBrx7803lDJCUJH3ybvQlY9I8LYpp8lGUoz0FCeuYBlUHDtW2kddaR+X4Js3K00/TftSP7EDLgPL2rdSyj/X5K19b/ybXxn8028efjqUp8oXvrHYFgZEVsQ62JWkL9XCUCC4wbejJDAGQDrMZJRKM8qlGDgWHQNJgLFDTTAUeQYOQ4rKZ91CPOeCiQvO64K9gE+kC/liJXHqJ3PcXjRQBm0Bt10LDF7bDt4SLZWDt6iDV2kQ4G2qKhYRPCrB5WcVXVCbvEmLMh2bUhh1QPww+6xKNWYP93oZ06b0QhpxO7oH1vItJe1CYVsoM1dB352vUEwZpQdgxqhaBxcvddDKzZixXEs4UQtlmKpcVjlVs2Kp4gUe6N9jT/erBLxd5ZFNZD5zBFNtiZijeerR0nDAlGcBpS1Up4HsITJd4mfzDjd/FpA5JpDpPqtYFMh0ODYBrLvPwjuo0BKipSMdWlLo964slnt5B7URBzjWfGQA5oPSZRy3YXowuGhIHXzJrSvm+av5I/xAT+av7K1jKrpjMoQC1sZ5OmdNKHg+ruSWGP29bdDAAG7IMTCLItoI0VBlX9VKlXZi1rSH+BPV9F9Sjf6EhxoqK+3KoWJACbfDAdwFr+wNi8TNLxe8imdXSwbLCQp+pR5j/4G/ilu0g4EjZPX+l/01c+km+1WZyAEPrrwPc+6w2BLlxXQDVMjZhFT/NkX6LL1eK6avOL5tjy+JU3xpTsBLs7quqYO2DDyd+bfwE10/jGeDNVfw9FihhZ8TvDk2hXcigzSXdVokDB6fwnKAsr+/QXoEdl+YgjpvOrzCx/N2D01V8WGknZMBUs6zbLPD9ryJB0Q5dVn7tJFcutlj+Kl2A83t3+/zJWJtj266xPBm3tI2PCgt+LLsqHT9beMqFXGekFoid2gpg+ADhNCNalALhsqzL0uPUFjR0uv6zP1paUWDs6toweqjtDHL2qbKBgrW+VUHA3nMnwbXYoYhew+4fE+hKsuYGZWWjkaloRgmBTAvBBtwUC3jcC/G5IAEj+FqCbspfgHVscm+gh9chX+1JiLfVTrul1Md1hou0QcDSlHNhzO0OvFjDz+AOxfWnqeglSL2oGYv+wcBTChQv7fGajQ69GdyX5QS3evnIZquXcDnOnCOpkOxWZqiqNjUTuN5yKDkjfpUIHiKexbrIEPI/gm1TkUXuX+vszwpLx8NMd8NDo+3C+FAp+3mqkNYQtxJzdecWs3xP8MyNHFS5j77a98Lp7n51MluNyZWVA1prwqmzXFPqDLgy0xcxFleYpyU9GvqxFwVnyFSVmdeqIBloL56g/xBbHuQwUiJAo58yEiJImEkswdFoBZCwhNsXkuotaBNatAYPyqxKrz9eWQ3XRHyWWE6isRW6nQ/Od/kB/sq5vRQovrhw3mqPkI8JC37yg3GRScaZB1qe1hu9WipKjb6S5Wxvd8PQiHIDn7aQncGYKypSUwRoWjyYJANLTfXTwM13aIXThM13BKL1RDMdykaY0ShQAosPmeJzdeyQtUrhwRqZ0V3lLER+5PuRCdOAbxNTgES4AWq479SLppMOQUoEt3ihq5BE10J0aDQNciJKL/NYTiVrj0pgICsyw/swtWxZmJkPwGw55eu151ZUC6M5KU/4odGNGfZ+8FyifyOSgQ6IqT27Xbinm01FcAEIxHLpZmY2Z5AjqFgYE8XE7+/sYQFNtB9c65yT0B4cg8uHhUvR4nPy34ZMSKyjHSLc/syf3m73f5J/J5q9JvKaKpG60ZHvWoCiVG7LYK7bAESpPd57D9XnQKDk913yS+977YvfeqHnr7vYx/Fvwcuzl59g9WawZZdhHDZ+cEekpjdVCuPQUjCoBfYbymiWISGIzTBTEF7RtoDOMbiYb4Ekw5uZtVj/YE15H22OgbMijpYCJHc4nzvB9asSUg1SFMek1zuOkDhRoVh7bEu6vOoln4kDLC/q54sR/b816x9NeFT8xgPyuuI3ZMnIr9Bb6YyJ10Qese/gdDLlhNs7obIhvpdYbPcfYCwZ/gtbgSSIjgXxsY7+7RBlEi+Ekl1SbgBnex/IWQ8LRYCyt2FMZRIKnnTK+DEF0V8q/xFYHysaliXYik8exXGVCgBClKUjTCDVjmdHwsUYXPYkkewC22So6wuQqf7XUicEbcLyFWGyKlZO9VvE9i5d98X/sPGtld//g8upii7QQmLCO3VaWVWNLQrXTXlk/vW4OPhoAhF6M8bMOhmY8GFPblQ9XtxMgwN3C7YIixweB4Zljpy6wOIM830RE+xAZeL5nH/loBx0AgmXB8VRDcKiKKKokD6eh9XQS3hOFYboUXkgV0eFlz2LgzoA4ti6EXcvAbTsUeTd1MAIF9CAbyXcwP2SehuzP69CAo27EHo4Zq/hz9MEBaIn1uBOIWMZ4Dwf9j4R75PNAl3JYt/+gbD7VPu49HN9YZyjsOXY86LKxd24U27P/PD//MHnw5txzP/37eefmbvCg57G3xB6BGqvQw8SENfOanX4SvFxhfZryjtU12Y7N3mVCUQWZnEUQBBGQiF0HruMUtDkKAQlNzwfB3cracPAFjQZYAdw7va3z2LqzzLatg4NZD0w42mXRhmdd90bXWs6xWPyqgrqwp2AxOp+F8VDDFOyWmOzloqYpVlqIsxRzhk9XtXxPsXfh7lZ5OfH+Vnys8762tiFuOBcA3+2toc/AJvdWZw3M7PDj9v9tfyjJ8Dfs7y8xA/5/h5zIN9rnyeg/dwaQsyC7DaLqJcjlnSTIha5uDhSKroIn/IQgasc6I961HsdooI4haUdnHlgmCjjhXsaD3voYzA7RJQIj5mek0rmpZtyJq3mr0HT+0WrWa/hrfK9x+R77coqLdMnT5AeLYZe8yjENXfHhVbWYbl0bKrHumZJt8Z0VZQx416seLukfZA6hbdB6hdQSKg4kb7PIJQdEAZ98DSBi/b79WmlweXaIJ+C4yYJ8mOufY+ZFyRxI36GupCsCNCzjnNBlHn+zVbTWvOPqDFQ0D60ToQoe5WgWxKXGdK3MxEnJpMcPYYxKTiCvcwVrNdw2GxbQjBe6ZgylfQ5XuDnMEGIpxvR/z9YU6Y9Nyh67Bt3TDXpHMtn2ib+sgYDinfd8Pdv/3C3f/tvosrNzWJaDttxd9lvY3yxpzN8O17B8RNquRHCwdOfjPkCLlmyvn4niKaSwavPmhh3T6PW2sijxpw9CpxbzJxrUrch0zcQhnnQJlOiWtW4j5s4hpT4pamfNudErc62T6deRwf6TTSvJCNY82qy5oFhKm79enpVZpsz5lUQXCapt7o2VSaXiz7EN0u/pnMUvdVWNRUkOKZEyFmdvRoBunSmPR/e6KKPaGJRnIf/1Cpy7qgNbbE2DP5xmkyfsSSCwUHCnu0/hP4aqp+dv3hFDwo4bnLPLuqYcY9wupJAVBbRTM6u4QXxCLwndCmFYf/G7IjVEgMfCXjt/Az+8lDBtoOvP8S+eno8l9RlmDmvSQr36ubYjDwVDM9NwbBfdnmCShVg7EGU48RBYjHCch21p74AeYgLzHQjsUnNkXKUns4xLhFNWCiTb78dsEMVfKn0AgfoVQU44F13lOmDrwWCAGAriWLIF61EPdort3k2WP3Bz94Hb5CRtmw+XurChoQc8kNMv18p3zur4KFExFW0VTz28ZFOUhQ2eIi1d5KN1va6YQfimDaX3GhjFNHcHrZp8GcqZnMWBpAXHwwWS5goedgcarldnWCfKe6uY/5L0LNiOs62QGD5KUUHUC7lW4DgFRf42rEnKke0NQFAHkgo5+3gcHgpjxpoziUlyajTwgtYHkQ+FEoDtlaFFBdoY9+3op+5i3UdQlOouswbkVtJqV1PZhDj2VLH4kWjvRDZX22okRL+oqMYwO5GtVBQl32gwTMPr7KjgKY6p9ah1dJEGdy/GA6DLzGpLioMrUDyBJXwZdToLM8kFne18s9NUV3TrQ+0NX9bNxXWUCAhNUCco+6ii7UqZrwlDAlv6qe8tBTHl/vB5iM5U0ttMWxgd1CBFZYLWRJjpUFP1gwjR5lIFgNe6YiQejTXocrIT41nTUYmPrJjqBrUjasknmKShHKafXFE9QalsLaJb01qjsz8tWOWpBLIVpCK+dXVfAdovyxToDQmu2NEsW+fykENtp2Q2wpUOfgFRs3QfrpmA1tNK9TUnfMq5xpVbcJOJv78U+een96ziyfzRWsfHu3TDVINyvXJOFmqpa9T3CyqYTxcnJXiTb4MCWm5mBQsHHNezzdqQyLeNRGB5hubC+4iiFJiUApU2ooPAN/jC3c0BSUciNevvCL3/rnP3Qz88VNIxnT5awpty031nNB/X06VfbkbTzOymfwoLyj0r0Mj4V8tj96HsjWhOaDvS4ixBEUzUGsuLBWLIrvNFWTug7jPY8RFSuDGS0wAz3yoQxQB4f1/Nma0gowVQAEzZB7GdxB7cortUbSBuRvrA/4Jbqq7dGiihlhnhX7M4w7RHz8U1LyEPZl5hkSOU6vwgEP7xzwbo48o2JlaBwURsYk36MgvNlTGB7yFIjXKhCvViA+T4F41TgQm487EOPHA4zDRwrH76zAsQk4NkfhqA5lgeOCmL/YDFu8K4wdC3C05naFJUsDmfF0cRGWkaohkDJ87t71Nz8UFELV4w25Ph1CRrEHcwfrf0ihSP12c/k+h89aU2F69r+xmS/qqBKx4lTPqKQghtZkMmiMbC4XNKYfrJnIprABeSrMWN6yjm3Vvah443GeqjGMjDo4AZ8BXRvRfuOBnAErN3T3EGewWs2M3nN01wpUDI99rDJtLf4+PkBhqREwlg5zxv7aaBZzLK45O641Wb+mWOt8aFCH87VEJQYTYU5FiBuqGdNP8rrq1wnZVsttHvk8RgIIxbThIHu/UC5PvZzOrJEnd92xya7b7sYyjKo+2wEiSa3UoTnwE0C2TltUETpwIYa2wEURT8AON0YKhuFOPBY505JadqsAmha4kiWuryPtBarXqX21NRU9Iw3NPducOqVoXHlQQHzyjby2xL1OZLHU4+Ejf12tvfnAiiV0Zok6mDQAlAxaFzGcXizYPi0KxOASSXgtC/H+K9TuObSuINirW92OupzczDAcyC+HYphD1ellaLRfkY10VeDgKaOgNq3BwCzTvHRVMS3DGWibIyrfVgXBQ5O78FTBSZoyI9CirisJBCHBGKXcio5Zz0dv5C67YBddvKwtQ+hBNLMEbcYDwh/XK9kExfy8WoicffplC20K968n/eXV1YoyKd1Yl2bTspoVU4UqVuLpDRhkXfIGAJKyhmbc6tIETFQld4uU0fIRLWUWabNcTneQixziWfkMBgEyoxk1Iy473EQn2mG3v10ABSljwEISqEwZwxTRbZd+M41aIkkL+O8bhmL+2WOlmN+kmAtViqnZLcFcGCeYhbfv7G9Z/fxnzlu5WGzFeGXfjn5wOKx0cxFVeNnf6o038mHIK180+l/CUKMGf3jSBXquQNHUkgI5ylLuRfKFvg95VvDv14WOLwMWOv+3TNLxZa5kS4WOdx8pHd+yCR3fMknHt6AzWybo+Bal48u2T93Hh44vTqPjC5vQ8cXHjY4vPCI6vuiCC+N0fAvN0vIEHV+YpOOLj4qOL07S8UVaAB1fOAEd71JGi+N0fOHrSsff+Hhef4NeB4e97NNvsJfdIInLvfIW3P8qE3JPtsljt+B+2/fCafouBCH+mtV3URGI7oPe5unlZTEsfZcndxyygRSmGQbVDG8dyaBmSXxrmKR/swdpgh5IBtCI0qtFofuCv4bF8P7lGDBp1n21sWZJ7D3jsf3do1UtVGvqblqRrWVhWiXJRKSTF3wjXYtfrPUhCZBjO0gLEFhPn8llYI0x177kyjq/6hN6oxLQC+mpu6pEnlHU+k1JeKEXTAquKjpOIjPqv6Q8Tw7VBkLl7B1wDvvfYwY0YC99RYAXh55Orer1jSS6zpddoid/bre4VOpfaofkIbKuZ4r3JnhaSISg4i2yb6pAubGk66yo0apSCvQWnbmrliNKbVn62IcAKDAFRoEwBxnchYPCutx8meXnR/k5N70Ms7B74imdq297So2g4la9SkJGjSWfl/h8wbYy0VY6mZzxCVWA1PGpG2vNLKTqLCYxEjmtKU9slyH4JGWxVJ4ApZok+y0ZV+jyYo90NMCcuENwep4WwYPMZHdLkxpa0PuWXMHUQMFTS0Sm90km/chmeV+10jrNIU2jrRIfzVbi3mTiMhen6jilEjfAqC3KflsPdSQq+x0hAy1R86prrmRtorYE6Mg/bjUT3fnK9QOsIkDtJfiTnBfgz4s7ezxCMyKU0IKMx9DqYLlhmGfkh4a0vrWopRrXGDaj7857NYPE2KNWlkguGFnyrnaQfNltFlvU0ZeWszgsVrLftSe+xGnGPVyPFvm/LhdvrqEsAVwr4vbLfj1kDfSiu+/75d/nLh4+FPSjteyjKA0S4y6+6FbYjpW+3mGZl6tjPeoqB5gY/nQRxUO4rxFD0+xFbd8QK7Lqp0FSBKCgDhUPRa7lFjDUWkfL7bbZUIk2LQ/guQKo3jTqxgZ6MjtlwEPV3WmvT+joTZsZ06cEZvaSpe+t9NmeN53y4UsfxlQCpXVVvVKdTkeEmFUJ25s9seLxjH/61Cf/6YYv/tytR40WhJimcFseE9iyl0oz/kAtZ6Iv+/gN5d1RXLkLsvteL+dZjuN78OL1hwIwkynorvdS1poNqIbWgrSXmSgwV85q6e/W4w7vNUF5/Zf79q7tvV7Za3PIuck2M8F6dDCA3h12TleQaMnh+mj/5WiC8LXkg1Mxmt5R9lfKp+DIKgOcdHrCClqEe9AxhXCLKcX0CTych8+hWw/n0Q1Aml+berIUqs3FPNX7xxxqaZP4xDTEnqKmbchnXIkd5LgxgJB2g4l5LNdVsE3TzUmMuSi51Y3Vp7m2xb6XL9GCXrf91RKQQwd3mh0Uy7R8e7HMk4y6zmL84N0Pz8smhlsiS2WCnbU02qMmt/jhWljDZJPCt9DKw58TZ7gS//B9Xr4iamoFRkVvT/I3nCsNRaH7mtzrh7mce5CH5EVaZhx4BeMnZhPSyQfPpEIxqnOf5vKa5tVO4mPsqWWYcKkt0Luucss1wG09CTFA7a1CZ7cxA8P5PJo5gOf3rAkIA1NeR5V7H274uovT/gXSNb/G3cxX7JxaEUSodjo1MbarNdCAmq02oLbsMQJrRjKRaJ8/z+T3Cim+n6HS0dK1m/qCRkhto8XrldmeGTNPX1cBIdOYVfJxMfIa7t6L5T7tKvUQxYhWje2hddcoPPp+zsBU1zsLAFPBxbwXKDOknj6BQPYmIc2rmE5f9D6QLjJG1K4vKXpT3py96euy4fhLt+HoVvcb959gv/Fj9cxepkkMQ+ebd+/lHJpKbpR12vcdoo53TznBkr0DlZQEWLZiJi0V29d5pG0y0ztWHYW8rnQSZ3hCEODZEQ43DEGofAGwgCC0KdzAde2NvINbYm5xrt6RK2nDvKENCxSQzXAMJsNn1otItUjzRYqMMf4IFESP6qtUozPAwfvtbPwQKDBGNbqKgaJOVleqsQIKmNCKUo2emVVd6oFqNCoTqDdGNeb5G+oJ9m4BUjYM1dhCDSQvUDRKNWqGaiwI1Yi5t4s4+hqlGo2SajTWihWlGqugFSugGqsVqqEeS+30bSvVSKtUY0XLw02ekmp0y/6tVKhGz17l7Y1TjZ6jGr0pVGOFmkI1VswJ/3Sq0TNUo3ciqtGbRjVWzZg19HUrIGQas3Wcamyl1SlUYxWtu0bhIVRjBY2crUjoZmmOtr5XdCRpVZ9sU3/OXEKkUMkE42EejRAIitJf31QIwNRBL7re/mMV03o344V1qfDQe6+IUaN7mhPXYyVZd8u/cINV2sHYoimqptQqQHGcUswDF0P7E70n6Cu9DZ9JvlyNeiGRy5tMJ1t2K3t7GalGmXz9HBnysOQMHUtbhgaGwRpJLW/OO3NQEBkGqvZRNeS3zdjn0v00SJ/uf7PfE2byb5Om8XNZErzwuqC8NnF+5TYhZBO3n8/PiE2UnF/d3YaTu1uOH9nf6h44tCLFEHHCB9T7h5ehC3qIOKpy/KyXvyq6tlWb37oXTUFqoGoA488mmU3G9v3s95GuRVO4hg3m5XLntoKXTaMY3z9IQEGl5bJx0usLmG6uOS29V9yuxAS6A6a2XBlm0eSIpL0J3p3TugeKzOhEhaoTNXrLpImtlAy9bZK7XtKh5jCfdTuwOb2NKcxfMc+LrPqYnsGjw3JyueJWLkJD6qzLHbxStYuxeLcBWB33EupQoMuOqQp2HvH77efzEgSCELjroJRBha51gBsmzacQnVnUGxuLct6xWOmPC3bEZay4IqxEUh1qVEsyJvmyLaJggj0KlE7RBbvRlFvGHd02NRHT5ZgjCqyXjZqE63voBEq+5DZaFEV9uX2I23rEjw6U9vlBGCy+H6yvqEHSq3BK5JjA7OGxMiuYLNxoTdKzP0CkHoXMCRqEqH03hZYZkvc9eE/4PVFqCaS/RSAth08ggDHN42N8J60zuLtg3mvW98nBvcOiyWdi6pEvkpGnyLjk7RwBKm0cUZXZmmW+dH8qY5kneIR5A5zd7CBv2XulDUr297svtHdKU72WdLlii+55JHpPJfZNZSxVYt+psUw6DA1ycv3WkVvTtwcBbEJPPSv0GLhFBPKUfV7lmGwvaSmP8TyEs3C5nbcKIoNLESEo/FnuSBAnfUy2EZLLK0l5PpiVIRLyFwNLcKOr1E0uWSKZgvbmClwx4hpOgsfuojFCEnwXhGeiypsLqqg3kestTdA+EYQF1ASyqG9NUc9U8UIgPzqY2d8JxxoDJQjJSVGHyxvyEdMlvDCgTHE6wgmuujj5TgUi7qoLioRGv7MuXdTX9UqTTwiNHAykb/fZW03V8TE8ulDwfnhjASM9Yq0pGX1XNy7WaV+o+rJB6UEGBUGHrfrZg+Yzk6APLSa81X05raTpLXFFnrCtejMyVGZ4WDhyBE307xUPfZrhzZohGFG2Q4Za+gYoR8d29czc1SHcWisdIA4VmDFedVgT0aDlhJDqfFTZoAZDC0YL8JDLT9CYzG5HzXKHP08EWzCROZ+2rSGWhJwsJ6vZazfZH8la//dB7Nb50LbygbO+DlcjnW33YB33YYB1nMvTK5NTb0jmkbs9ObHU16UZ0iS5dgeJ3KC8xjjMG1ga9fIv1BOnSJjKOL19CQaDJiJTst9eyg5+0OoGxUOsQjy71gcDc1/yCxcj0dv3ZPn3eZY/ei3Z31qTNV/ABaQvnGUpJ+L3VKPfVEZTNVppp94KnbjQqXdCNXL8RqhG2u95SN1d2Ns9j4dcRReBHuHnkTMSay5i9TOKsk+ovbeaidojmTVWt63VzJ+cllljwcmHVcNWY6yq6ujJbYJrxX6WNEfvSpsr0hVKq3VX3nSghUzq3XPyZTIMs08ZaS6S762VmvFVjVe0Tb2DrqcHJhwUBLYdIR7KqwHXtbIc6B5KhYr+9WF2jy53WFIg0MY8QNWOiQtQWbbO4+CjrlIFPcOPGF4wNhhfBKiM+hBT16LrI7Socq2J+YAayr+0x08fR/z+AbXPK4djNXtSf4S4DK9yaa1icCT7e6wz6U+41rUKX9vnP46Ne7TteqPnQxJTihpgQq9EQk9xk2pXjhAnPmIN1QrtoDLuqNsvP/XLT4tIyBIssSkVu07vp098D8+UfxYF0HQqTWkeWyppZ2kPMQ9Ki4h5CMzGq9iTROBOBEaIaeSCsfh+DkaSY0trGceAZUxFY0trlbPrvyBP1E61McQ8SVobmDNg8voP/ItxsZb9acVkRoILtJGeDzW5tCaX63qRuL7BMlJDqVP19FRi97jIN5WRJJERNSkB4SbvwAbusQyGeV2zCs1SP4XaIdf1OkdLx0A2UrnS6Q4vVb8ERZhuh+7uogOGigKN3U17+7pRChE/usSBj9pDN7XeAj0fHTQpQS1dPiTBprWIk1iLOPZIrWks4vT9fAZdadOM+vNsTQAqHYOSjiVGPYAFjYbhzL7iNrzU7rlr4SDawscL+5gIQ2EWY2wBpUF6BIrT8fXsf+NDOPpqArMxsKkw/WpQCFA9Vh4m1dkWs15+nrgCohfZ+zXDmesBPOC6BJoN/lw8XwZTeWp2iaXyV1ENUsuDQfVWg6Ms/2nvcJC+Kghwx6ycZjR2LzchMSc+/c5YxHfEMlU4JOgVcHDnGqRDi+o2C+lHF03gmA3cawMPcKB/vf9Ub2PRyQTqRiagl9cXINeUJa1pPTKrwc5W9chcODjEYnvYbz+3HWASZPfqrR1qZX+uFEj5LFMDPsCzBRM9uBBDumGrp05lCA6aOTlx93zCPk0zdB/LwtVvqZV70Qbq//EbeP4j3lq5jyU++4x5ia09+5/zQ1Vv8OCrDLKvXYDi3U1A0UFIVgxdJAJ3paVG8NOySAGUXCKdLNg84FJP/AMU88kZb4Sfec2FnAmaYmAQ+VZ9orw1pMbKhmMzg4tGl8AhaQoCdhtxiLk9VPCeRRiOkL0A1+wpvWjcum/pP/7lW34p+MOLrgTYGKsv5JwYXWzTGYByZ0QNLBXJEIUOK6x8L/sLxXC1uxQC3GG1lw7stew+4av/zvOia+X+y2Lu43l0Ua6LMXaB28neBPDnkWEX/8Vpujmhnq6ZZcJ4oFb295qegtblJe8IOGy4/vQBcMxB0a0s/H233Yp/v31xqTN5wd7BkKJyZg4prqqhDu9QZfhwWIjRHikKTnoH1e+H6X9hQ/f2rFWvl9qJ4isaAxVkRwnrPAyvqql4351NO1M9YA3Uss6/ljX/waHj22H/17FK/7M3HL8VW/Ty3SfwwpA8/PvGmZGXfsmP6tcFxvybWt+HZ4HaJW01tcIz7Jh3gMu6v3YAZwE8fWXJ9cSgEB5YBsVdoyFjKCNlg6q/6hAi+9JBc1tRqM6GvkPLgablm6GY44vOZEoGvVJtXOs2QnnAZF4lh5SxKssM9JKprnrJ5EtGsUg6JxodHZrN/vEN0hJA24TbNC+njlh2XIHU4jvupg7/mt5QDyj7g+v0IpV0xNyum+sffSXUKGcRN1tqJ/Xv4lheP3GvqQF6+xKKno2k9I+ipm+MRkT8F3M4vDbUqYClZMpyJIvN6IQvvCO5r1Q/wOhgcHbzvqg/ygtCov+svD7VZmVjRFaqMi07RY+yWZCq8mrLGKVrlUobNucedig2o4QWBlyV+IL5MRq3rowZF8xcsOOCs8DolDosr+bHzLB6k4xVamCUIuflIF+afsPCBbe44Iow8UtFb3++Sov5VlrIt02tPHMa19J82gZWZ4lWMfW2AkO2bQyhDT3LyEZboW6DWOjTznKTaQYC5qV8Gy2JToLgyqKcY3O7e0CDJUa1OZx658u0hUNdDnX5OT/EoWiHMWuF37bwqfhMjvQVRutBvkI9FLh8a2lmCeDp2tcaO0TNMOlnYbmTZpnWNi9QjiSD9WPKOKbBFzcRM0Od7I2YSq6sYkbMWs5wruQCsDStEs+cZFet9FLsksqbxX1F+C9FYVNQ2hnLWipv9W+6f1H22h0nUZR9znHyoO944GSo/swiAQk0iuRIxnto39VmGPCNIpfHWZVv2N2H8t8UlxuCWDYEsPvI79YgfLkLANprZk2JmVqP7QRAsPAxbGotceD2pVK/R/YBneo+oO72AYndB9TtPoBDiZhSd/sASC1lJ9C51LDsERgdaPS0PTi3nTkxpw/SxnF5Hd/jW9NZmgHnr71dJz/7S3xDajYJkUmRufvk2jbGfSRz/KyNt1sFvRDRwaTpVPcHXopFAcXlWaU+B8T7BYhzeuYCrJ0bjhacjBUcYz+UoAvOnnMqMU6m1cB+qGFk2scZgAr4/RL88pHFOwO/uvIYMeO1XVZ/MoyA874wuFaxY6lqOfXjS3Bz9FdoEXpCETaLegZ6N56JGCw6tkQ+NDUaIuDLm3oGAo1+aFtY0ouDNi6uDVUBHMLMWOFbAz8zfQ4o0uui0FGRa8Z9nIYhfe9ZvXxWSu1CWtoB6GdR+rea3f6cLd/LQ5qBXFVW0VC1Ozt4LOpxIVBpDmq66xTooalavFygCIEEmRPW5KTI4kwEQC/hkyEtaWQp14uASBHNY7zndS3V8UY97hDJxLgDpKbEOAFmBxjQoUwH09CxAG96mIIdb+JMbFAszbPHYEomq3YUUFxkjGRg6MCtAXjZX2sDeOgtYrzKD5QUjlxfVnFpGfV8HDdWroN8P0wET55TQ6DkG3q4S7UPWyPyjVCtrNh5hLzkVY+/prET2KB62Rc0AwyQjRijkltVVZfbRbye+9UqPewe1Oz7g4vEqaE7bVGTaXeHXlzpvz8qHlWv3+W+5PsrF+Gw6XFAqqit46Nh+VZRHJLS1ovgCAUueViEDoZhZXt0B8Qk2R/rZpZgAU9fUEw4PJIHMoWqGxpuHaKqe6Vbny8zY7rUEdBzsBvKkGzWC/Jw1hAdMX3wj5B/cn0AnLXlskUnX8MQ1wxtV/yqc1jtFXnaHQ1rPxCqtjdUFJKWhdLeAYWmhWiqR9Ggar6B4pGmxdgl26bVKcTM0jc9mULrYm5dCOkotphHKBxUIEleFfXW0+dAmXhT3xj/9IbqnlCJtiT6zras2xc+woss2KNei+/FJiVucN+/iKdu04dFoPt0YBSFMJBBAQwAlHmOcR6xeCqpAP4FIiPKHhC59FshoQorpiadepLerauy/Fw1o3gROmnyHdmPqkxAHbJVd+AFIMt/V/Y0D04fHYyzf0b19iqmP2aHAzVhiquMzEMxPOyuKS6opaujZEInkdO1g4JKTpVfqFFOiuBDvYsvXGYhOWVEdnS4PrgV5fmVLJPl+bA+qOVloqgLqzT4eQJLo5DDXNWvaSJM5ZxpmBk8AQCFhvEgZP1ReM7c34O+Hzi2NivX936SJ4Jxc2DNYNIxbyCOawPrwu9q3fYa0vsSIu6xrPAXlCsFwHHHQNYVhEKKTCgBG+il8Hf5ZkOsIkqyv7XMBCZES71ncvQtZhFqrZWuNEfUiDCtDmh9NTQRUkTxIpBzAAqLiWxViwYaWTYQYKt663939nco2l5IiCiE7wC5p5moMqP7FIIBXowfwAfV2BixX1SVF/JQcaDKieXOOSv1BjzPe7nKM2RdMVMUogsBOGAsIhT+hHBGC7RnB6W4JJD9JH6xRWb+XiVvwWhSoNTk8qny35BV/WEBDM8XmOfLlAod8kg17tQibSChZxNrwQXe3KQnXdT9bLWhcgkotSFkYPFAGQ9ws1WS+iUFreTvJyL4B3DrfQRYFJPszxvSVblWfr9wiEnJHaJ4reUsMZQ0ozW1KEUtFIuLtZCrwpnB3wv42+rgBp8UGXHxswi/IJ+jFm+35YIOdoxge7JLuYzZ516j93yBiLAeHRuvBr4IThfk5jfukYuVB4/q4lSBs/X2H1gr7WctUkMaywlczKW9NWJLkjGf6wXiC+pmZ3QfZZJv9pmKHGqCxd6GTQw3twAxsF5Uv9xBukbN7MsyWxYliispFhRt2xQfQJ24AqZ8fYtHoNzu6hAEL7WmXWrgw7N/0IMWh553xd7ydZNaGjXYbBf9ak/0sD3oRMF2rvSDQoxE9o8ozBkRO6AMouYnD347ilgt6vEDHKrwdCEsELwRAhZAHmanTCS82P/T9SW2hQoDT81r1RTbQG4F24IS1YKyBUkhhneyB5FSKF+sXLInAnmq71c7nrDvrrbbKFIpZhMTL/wfFHIj/keBQ/sU9pehTnlJD7V7GE1PxjGPKmSmiuuK2C2D2G0gsEXqUJHadAZ2zsySqggdOISWZne02Rkaivs4xH+X8V5HHTnN6co/z23OF6TjHNID60VIaGQCLEvH9C4+ZImQ1kB+vwRRUMiggPmC/0ELa/ybh7iivebePeoQdl0YGVqgUGAR0vwlPeqCWhqRKSd5kuRVk5oEw1+zDKZlo8+riqScWKTweYXZIaYnmqTvDr7QuBrzbruMlGVzo1+ni0wShyA1aukkgTpHOU1S3fXOkKfTJKJUp4lOvPH5EWMIdHoElGCMgvIaccphR9DjsMP+kjz+U1TPAx3cUFFUGiClA1HVbZBmsK0rYoMukNrU1dAzVhBMGUBW8UdF0fLF96gFnlaOg7NIaaEgTvbPOgmU/rXQ4wAKOhiIIl7LgWb8mBH7Bno9onSs1wEjEWAY2giJp6sZhCJQMPI4pQgRGSE0i8gfk6tFJFklgjQDgm+qONcj9U6HsYQ4VZ4z1JZn2+q7t+yV4roOnpJl6YmIvCNVNDaO07AEZP+ighIpJzZ3iLTrkQ6jHgkaINvBtb49Pfh8r+sy6q3xNGBd/4MXA5YH3vnjmFRqO9jj78BduMGKlRuXeSWoR4mhve7UZl47oTU1kSZ31rCn359nOjnb1JThxVhAzt+SSlpUf3ERUxMYEVMD05PfdCEDBcP6CUBgKQlkj98+wN2eZdHXc9selAXUF1zcj9jlG8hpShl38IDMJ2PucU7XpXEnhTpmCk6dgaNKxDEFelcNnIZXdXKGQcx5EAHwlpmVCeISK4FSXtH4gnjFNF8Q/oQvCH/SFwQ3u+oLAi0Gr3d8XxC++oIwX6svCOepiAu4drovCN/5gviabi+cH48JXxDeuC+IgBLr0iP74xuqviDQoNA1aKIrIRoUugY5Vxr/p4LvHY8NfHe87jGC7/deK+D72dXkjOv8lzOxNn8zpXsor6rS8eXamhKSQCe9bIYrJFYWMGXLXpLHusLWnVZEgkci3D/VxfIgIjJR1QFLoH5GEWxrzIyL6WhM5mJmeebN8R/KCigWkeV83qQA53ZiL00ppeEYo77/0mIRUszFfnCA1/9FMAbLfdjrSrH4y/khFo+2WY+3UI0vfuGultxwCuTil3tFGwLrZ77q4pArnZP75jR3IOf1HuNSQ3gVdxHWENrKoWUJbePQooS24/7UixEiDvkSytF8CRXcvB2ymdtBJFx0vlNecn05RV4KfTlVXlb15TSa55et+rJLXrbpy+nysl1fzpCXnr6cCSpq7qedrpfzoKOIS2r5WXSmAgYvZ9MuvJwjL0+gM/CyW16eSKfh5UmEjFQ8mUJ5nsuXy4qn0G55OY/Okef5iNzDP7z1InoSnU1nIeYCeiI9AYELNalGpxKaQU+mcx/+rMdlcjoCkumJcsvtcq7hcx5KQMJZdD6dx4HJbR++OBs/58lnWXE+f2ZbENJ5hGK4fESjANR+itb+FNqDsrW+K7S+C+hCxD1F4rhjlcLwgSkM0bawnSisxl3RHsiHVxdPRMaz6GxtPOJ2czNdYTVOlDxP4DyuMFl/QnPrMdArIjuw6OygOWUgtuB+6xbqIpIxjiNbvsooZFf1irUZ36v5aTlN/ONOkxmupPPvYJp8c5p8c5oEKWZF8KJ8Ox6Xtj3ajilBXMQ2SvMzzJTIuMBZMyXOeORTIqtOiW1A5TNpG89AnRKMi0SC/ls4tF1CPSCchFaB/jphuCmnC/qfbvH6SXixeL1TXnbYuTDPL1vsXMBLz84FvJxp5kIFyXdNIPmpVSQ/rYLkiga7FZ8ZCxAN/F6p4Lcdrt10FkZK8EzjzMCHBlnPR7Ig6Kfe+V8urv5h2IEXT6SnCPZeXP0r9nCiIKFUp0hzHtnYsybx3cwZizWK+082uH/uCLqeT09GgcBah2FPUnS1E05xfwq60qNF19OBmadbdD2jn4EkbUMk44Wh6qrPtUUvgZ5JKSiiRa0djIYhjw6eoD5nAm1OI6Zkhvru4qgtgkynl1T1DC7nVEGrU+kMxYrd8rLL4tg8v5xucQwvpxkcqyDPzgnkOaWCPAq6cybpoILoHKV2CpjdCuUnlPRL6YaO3ShkOfqsk4PsqQDiqRayOyAl3EFnIpIBopEpPO2+qOAfBhfbkFZJTkoLANKckIFmHoDfLq/VGZbYsLiBY1/D/gsEKlBFe9tDULIvCQSIwp2IOj7N0HuguJBa5xP+eX+vLt4YZqgf9euANdSLsJD3OBu/rWJ9VIKZK1pfnZ8rT8qfotiaG1Kfn6+TL98jpk12YINf0+GtgXis4nGqFnuaWxWRR5fPOXkNsIBKpjP4EYwumqeOoATlZykJWZGXs5WOCuFgjD3TLprEaHuKWzRrvACGeMr6VzyVdsvLRXSOPJ+GyKcbzHGL5sV20dxrUeV0JTi6RHGZTFM2XRLNSrpnZA29iJ5WkowLR1bEkC7UvLpQmhotiXsqPR3f6bpHF9NevF1ITxktQFNB5lwBu3QeXGCpzbkjdObJrgBQGE19gkZrASexIPoQcZsN4Hz6l54XX0eeSg+Dl+pm0MdBbHBAZXgqltMEFT2qIHxCEHeJk+6J091Yzj+cg7eakq/QnCWI7zGVLYVr2cGbUJUTg0LcLnVe6q4uh9jmViSeRr/Hp0CmLUVW0cfH577tk8pjfvER+EGF0H/CDyriwoof1O4BGAgUgf/V/LZ2Aq+ov/CJn/9ErfSK+pKKV9SfRwpH8uMM5xT1+pucU9STrdK5SOXyslcpSLMb8JxwZAqZa3YjksZ8mb4acbX03b7nQ/gSVIQvoRO+SHQI97ARxymoIhkP1KLDgBx5qI1Hs/1nIV2EeSpMrchWAjw4lh/IaWWkoUg15HYFyy0CW0FgKkCPJyRXwSaiF3FGKyfYFDhntFMkVwpwaW61qZu1MagKrk6g8XD9a8c0HvzHU+Phz32vfrI4rgNXxMfz9hufvLffE/n6RUH10oBjkVDEo16pJJahxYGjVFL174uBV/++enA9Ov4xmqIefXW0IaaCnAzzAKAsH6E+AN9YbmBlH3utmxnx8Vz8OsHa9+lJJac1IAaHoeS91wilOYDX+jXCQPi6GoK+AVWC8rCH1sRP7QhCqeGngkVzqqD2XzHxxLbNF95UsW3jXWjeF1SnIHtQICmohttOdz2kNwMYhvy4H1mtVT5PDtoFFNXivzxaPN43L/6jI8U/cBLFPzRaPN43L/7+keIf3LT4rTV7uYln/EG5U4KQubK0qrPsk+ayxMc/cf0hFKH3JbbCzGyoH2e/fXDs00s9f9LSEDyM/Y42LHsjKpNLpDXBHjUg9MOIHTW3++2eZyBwk7FNhIUP7lfwyrezWgqCokoltOOSRcGlH38dLsNA5UFxr3oN5UdedfxrKH4tnXWUrF+7sBal6YJMhhaGCaorh1CGWKNUHTWln740T7x2MfLzii6/e+S3hp9dEjx3bX9u+sSfGlYlrddAYHan/3ET5+c163RL3R/bkDLU8pK9Aa3S4E3jPtV/XFzZvVIB6BuCqgX5MjSn+6JrYq8QgfQIRTdna7rEAJyqvCntlwiEOC7VQRFKp/k9jI4+sGwgOjRRgAdi0+/hETc1GHBLYwAbZFLWxg4/Fn1fi1TffVKk9ia7TYdV7jfrnZcKet44ip4HT4yeBx163vivip6HT4CeP4eVbwJB7Amoc42mh0WhsJcVNgEAkxt06sq6CLCW1Ski/ivXsqD0W69evrOfQKOKSLCbYm04mAuDjBFqdVXHsowBEwwbE9tlzNdVy8cXLV2upND6efqtOgoPtXQsXahEalA44IG07CfRoBVBDvVT5lVXsFuQ+m8Eqjd9o4Hqx44LqpuRKkTv+WDnpluTNdYfdVMjk19chcBTnvQWrUirLEVLXny8FMKW6HTnSfRUqcUc1xtObX//2mv2c66qp09NapWuPcEidmp9Vvw5xPyvLmRF5fiRtz7Z9doXaYTO7EfXqVu/wTu1Q+ia2tfD3Qe4Q0cuZMpMyeeXTQrhIgwrhfZWI9HU2RuR06zl2Z8qY/00z4eFek+ajfKVM1F6K0iZ/ZSuLWsgtSje0lvy0u+Wwu+TbqrjmXslvLoGcFS8UYq7O/zsleBZ4vcOH8ApqCyRrMqxZv/SRBbHe2uPZXUcuNXxyL+71XE4uTqeDBY9wwumYUOg5StpLNCANR1WhxKBRQnla5LHMnI/40buZ//djdydj27kxhjWn5f0527KsJJwpqv7hW2lkoPdJayrTsZNeVZ6LGP7dje2v/jvbmx/6XEZ23dI+neMjq3bisgQYmDVK+uzZWAvws8lJZUlf/rwPuap+y43vL/y72543/1vTHS9xzJyv+ZG7r3/7kbufY9u5E6CefrA5szTudL7i4QV2l/aANwto0zCJbn5io7ArqYZ6eyxjPSH3Eh/+N/dSP/613eOrsrodafO0ce+eP6WG7m7/92N3G8/upFrYrPzuxL7Fo/lAwJO0X/m7TtObFCA27DBhXuIR1ddvIckDtDzWBXX+3plVYXqeKHIOYtG9+tCocNUbmzjbooutVa3vTxZEewRh+zWKL5vdj1Ha+lHvAi6rT6Pp+eMCTtkkUuQe6bdoS58vkW9izzCs2ueSV/NmsItC+oNgQpomsdvHFfEBiViivDQxvX3oFn9cw2MNK/z6BZaUAf9lyH3tapBULGve/lJzpn7cS8J7gfcXvJ5a5vPoO5jmUF/4GbQH/67m0F/9Ohm0CXHHUc7igmfipOOZIgT2K8PBfyUG797/t2N3x8/LtuHPz3B1vAS2TDskx3Ebtk76OGGnm1ArrP53iF8LGP7v93Y/tm/u7G999GN7VOOx4FCrJhN4Tx1sI4+JunafW6wPvvvbrA+9/VlIs9SwejUJfCxnxr+tRu5z/+7G7kvfH1HTl2tZ18nuegDbuS++O9u5L706Ebu6Sfcou/yj3aUd9mMUh70H8uo/aMbtX/6dzdqDz66UXsqj5pT7BLtOgDUKNj5sGJY+Nk/a+GWCTGNf+k0n6HI1T82YdobsR+ZGrtrWuTqRKQbyr7pVh+vPk7yDqraHGnboSKnLrkEPRRkWmyA08Yk/Y1nJbBP/cTrWi8ProtfXjFaeIxPoyOtR+1iwfIXenuzTxEG5yZ+QpnhRn0GA48iTrnR54IP+wifzk8YzkH0wOPozAVv4UZUzCYJhOFgqKjvE/d/G//IZjdNhp17933hPyD2Dy6mqHQnw7tgrjtP8Dzk5w3U7a1p+YBX9hrpejN7LZ45dscP1pBSX2M11qKlPnpuCV5YtA9A9/aQZJsR+Phy6V5jOhSJI3EKstchArZX8S0QpE4xTIFH/cOB3rlE0Jcg1N3nqS0+9BYDscyBv8t6BY/MpbKjT3Hon4rP4f3Fct+DNddlYOdSnwOqHthPKOzlXTF8uPisYoux4zovN2k8hQHsTWTcFkzaNHu9ACfknkETtFux0Cp15UvyrBUrmKw94kcrX/X3IgAbArrTXu3X+VYbLanTU+LmlEaCBs5XmrPuL2Vm+VaY/dSysmI7HgsFAVAcWs1zuY26mhf83ME5Q9qa78TFh3wbhflO2o4WnTJyK7WAxv6puJW6g1UE89NoJwdYcX8XncrbvdPxyiGAFHfP+JVpZ3AASvS4P7EzP5u25edQnj8BYhTpzBwcBD6BRKW+GejtgVnEwfKMxjjfgbvNraMdqmy9m05n3fozctaS59sBZ+bn0jn5U7jkV+bn0RO5O09ikD05P5/OzffQU6S2ZcgmHq4FtfwCOr8Ms7Z7GX4qhWWY5bJ0PkLF02gZT1bMfwC6+KG87KU98uwj8hn883CKocDndCFdgNhvoYvoqQjsK5P5EkrxzDLPF6G6v5f6CFyIjHsp4lsMA59L/ZJHT6OnI+Vp9FS6iAOTwh58IhVcpN8FxdP5O1vZM7l6KWcvIRolSLRrw7fQPlSgX9/l42vo9D8DkRdrZFDsrRbJqcjEJe+dWiRuJGi38PVRn7slHXkqIp+qkUFxUbVI7h0y8ZcXuSLt5ZFlPJbpfDzOpz147AE+AN/Pg1OQ8/oxlODpiVD9Z3x4kjyfRE+WJ1+ykee59BR58iVFTMDdtENXjNNpFxD3DDzOoLPxOJvOxONMOoevBTG6PgHmi59AZ+E7vkE2ehf1FHcX1U4O/5uT45uT49/x5MAN1AI3UJ+Fx6VYLIDouPinE+J0fI9wItevzsZUoGcdQHE7uU6EzmIM/laeD6fyvDjt0c8JGp8T5zD2n8pwOIthcCb3/zTu+9lmXjyTzstrU+bGroCRuTI3apW5sVydGwblL6JlMy9qlXlhBzRUPJBhBUqbeJ1xJX4LcgOnf/7Zz7v/h979+Yvts3gaY0HxdOKJAYRXg4v2WTyDEwW/tGjBRCCsxl40OUXQDE4ilFpOs6fa6YLYsn3Up6fqdNHMGr3LdOfpUq2dKU/Vqi+UIjVyFK130YUobQytFXWPj9278NhFzwR2P9Ng93mCvec9Siw/h04H6uGuKOPbWXjDbfgzgKWn4e00OhtvZzOyE5D9W/H5t9Kz7P3VAvdXzwZ/BJQewfNzBaPPPsC19mvAesbBnVxEnj852GsQk57MaJvkT8UThJUzPgloR7sZJZ/A3To3fyIQFJ3PmSLkISPqMiPq+WAGK4i5XEHMcAoSKv45ElxFvKeW5FSHztLfKgZwNFI57wUnO2YYpT1mlHYJ9DF0eD5zctQA1ifZUXkKnS5DBcjvpifgjW8M4u1cHtcMw2puu56tH+RU0CkvKvjH3naFK+ucTqEdfCMd1IOhH9J2XHDaTqQf9XjouFzhukOlMEpN2GPv7+FKa0lR5jT2IGKnr73E7DYP/RLfbj0PFpzADpyB8T2PzjCk7omczo8n8eMM0ETEPRnpQJcQXWPWG90+D9nQ6N1mUcifpgE/f7qZT7lZgvzcLItB3teAnz9DLtYDZ0LajU7pdeXqCo+GFNVl/smIqK71T0HELrfgo1E858yq/y2KYLJ4F5fQLnm51JDAb0PkZeUaVl31n21X/efY5HOlaXa1/ZaTWc5B0RyLcCl9W0m79lG/gpvSYdqn+XW5t7U+UWu9hC7Dt7pg07PpOXjbRxdPKcTS00ohO2zTdQGXxd+t8U8bLwR0UieQo6xuAmGuhGau7JY5sdvenz/DWIvXrWINP8/UJe38Pl8s38+kYWYXLsirlcUnccIutQ/YxiXi8zkLT6Hz9yN0WQ8TQ/39PZEWqU3n8wb8AG4/0y694/Vi4R+Ib1/jA1Z037PGCCr713wZREcdt9aG71a38rSGCPTQRlqb6er2H92/jgGFTjBN8JSOCzE4Hx08n55prWge3QJzbQvwfbxAi5DTcQutxTfYwoMlTP6D5UQ8+R7ut5MPA4rZ9H0/dQCYJYXPgpFSrJIPU45wCT+y8V/cX9R044+riFw/B2TjD7hj26+yBm4sdbF5fyYerXwL5G4IFVskvngmk5X9fVlztmzkz+WankwL+R6pDQNHAa0yFbslOCAQs65LjsKZaHz7EXruUAJFfKSoU71iUfzhhfxCVLG3UOp5Pl6S4okMXow6Rkf7zhAP9HK7TFud9P5eJrYQTNH5OeOFCC0uFGIuqwRmGPgblDwqTdjFmUDulKxz2T7Q/pmCqos8geOHgjXacrUgyfmKfKYZu0pk42jrP+t8ChHNRSxzEsW0h5sIo79DY2/fU9wJnUd/rlr7C7wpdlmEAb0CNj0ZsU+2YkCHIivUFbkK4F5KU7aoNGXx5KUpK5ARdVSoMk+LIlTpqlClWwpVuk6ossUIVWCuev7/ZqHKN/eN39w3flOo8s3J8c3J8U2hyjeFKt8UqnxTqPJNoQq4Zer0eGCMdKX7uEhXmO9mHFj815eufFO68k3piopVyKetPAGexZi2ZAQsTzy+gOU82jIuRKnxGrlMu4ztzZhqFZlJuIaIiiDFbUbxCKfJUSiblKMsybYYfuy+HXKUNsQpbdqKPFutjf6IZlQzBPv07GtQpFEQZGqHKYXW0IK0JhuIfosmh5XkpJoMN/j9j9bWXKnW2yQ8FezVz5r4bN/EZ6sTX0l0VolWrw1OqaWMv1HVT1hFRhVxTmCmasJZcz84vpmqS/C1qrcfKO+zrx4QgxHOPyhsG2ZvQFM66UT8TYh/hPaujmMlwB+1EhBYKwGveZzNlYDaYBKpPUdnsOSNJ3Dr/KdxDN+Tdf4L2Imzvb7SKP2uwhlpvCaj8SaUpTb0BjF+b4+L+v5+Q9wMlQ4ih/ClUXrlG+QNLuHOWBylNilCn1I84EEZCWqVHTGhOGWI+ta56OEA1dYpMnO0CPilU2T21R84N2bFLAbxSCVibt9fpflfPvy1v+NwcIRb/2NovfosBcccDGycbWsZkB4e5r7heSgoIl7IAvFYVMcf2/afV5qzgHZScEFwZ8xPbfGCePxcK+AIUmurq7+wI7deENyFfJySiE9LxGzECgXut1rWbyJ/RzycdaSXVxa8QEeCoxwIjHsHNetLqIXjFkAuFmheyUWDQkpojuYG3Evu/bAcj9ftXX8oKBaRu75RBOsDfov6fp+Rn2c5dyx6KadR9JLso1Xrhs6xIgXreYDB6opNxXnnH2xJdigL5gMOIl0Gkma5LfIRjyZGjpYGQ4suHxwUvjp+Hg6KZUASGVuaMe/y1756g5YyusPhUKAI99rLlHIeM64GmbKb8eb8vXqAJZpbLFyq5LbifngJjMqz8g4t5HXrFarzTMmWMcQz/XoE253L/Vgnxnn+nTqCpRtZnjyYXI+civzBQmr8JFwb8XT0+TnP76U5sAc85w9MSGU41etYxNZTWkpSV1EJD9mbeZjjvkexaNHF58kC9pB4c4o31oHn/aevFcnGvj//oYVf/NY/99mBI3/CO9uikT0s5saa/MED/IF9T/n9vsp7C9J26Zybgnm7pAnU2GDX6iqaj40zHGpUPXh74hFnpvL9YKgDLw4Ri1mW9pZDJ7OxTbM87csSvpcrnxVM4icjKUYoqPhe7eDRIa8y/h5lWKMzGc+wfxdjfpr9mfrCoVABGALQC/y2sIYhh288L/uAURSkNU1I9s3+9dnX3/qT1zwt+yCS8jkKkcLYMfAohF5ldlS/odjFKcZoTZnWBIM0osU7By/58/xYBVcwh8Yv8uNcZhX07MACvE7L7FI8oNY4bAMV0C23K3DzsC4oYbHQ9chjSABa3iS0qvABKWtlH5JuzLERmDzGY0/e4aSbPaQp6LqIruXaoeAuj7qUwT3OfvYe1XphsbKmoM4+jJJgfD/7c3wnXxU9zMJVPQnY6ouTJMjrwaahRdtoASnbaQkPGErPaWtpmp9429k6sIaknVjPeWNyr2cCx2zgqA3c5Ql8VvsJL6GT8yg/BaapAa+dlK/lWR/2nor8NFC0/FTjw0mRJgaZ6PCGA46nY9kk0GkmYNlbTouxRYrtIUkmfF9Gp8nzNDpVXEfS6nOQGGI/48njKL6X0DF93IsIHP+cwvnoFC564KE5o3NJUQxtE//ynnVNaa3Bn0qrAKz0rUOn4lQuls86+gkV+hzi223ma8t8ryoZ2047zFq8nnta1GloCa0K4UcJRUYZSvMEICjviMOyqj/uHDE5FXgU1lLwilR4MkNJW2kFzOHONRmb0048tAUPrYzpqXkmY1qcaEyLU+iUEw5n8ViGcfoQnmaH8DSUfVo5hAWt2rlBBTof79dZeyo32IxmrHxTgGF0UH+ZhXpIHrt5vY0COpUzVjzwFkw6D3lI1zSMG+bygpm8d8iUnee3Q/ymExiTlnai96gVp86HPBntJepmv254xzlsWnI8FooVNB+khLas6bf5DryvIkRKEGIQBOCfEoDt3KtcKd3JYEVMBiEKQYhtx0OIVYsQO/KMTjUTffXxn+iriiHbHkcMKQyGKPYVJYas0jaAeDutAj06cIS2gzprQHo8OiWKUMdOdSX8FlUyoIrQf0BPZz3pfGcwcSekjFMFQ7QoneCgZgz4qfO8tVbkbmZ3z/PRf4C33IIuC8cE37f+GvYWCny+FpB9RNYME6NLUpr9hq6sGjm+umLPnpH//L73Awh2DQAfvBgxL+7zKbRPy6A2y5SwqB62hN2rNhHV2Fa6hRyL8fToXWtjfdLo1enR2bRCWlOyplPimpNxzCY6E7BvDQO4HQ6meRgddYXbT/vwiTXDFpIb/Gxc1sOOXE3uwUw4vAsQftjv6B+ildkf4TcPrRk7Lm0XCt3Y96PP/JF78uuTvdZD+f0XM8++G9e6qMbAqbiBzj4uZcTKrV4iXK3qrFwQsCAHEooSFbiHymrWKVBxQQCGCR2JdMufUZB9AgVeEDzPnLQFev8pUB9hCfng37NPKi0SK3dFgsdevbVkMuQSl+QNYMzz8libRD5j963UwOWwl8Lr5obph/ZUQwMbHFzE+5kYLfExB3xKqjYltPLLxf4EVyzmLXRKR+RtWB2TvUMKOcPGevYphZPk5xb7ayUIKV7HfNNKTBVaduL2KgEFpUNNRZOgaij4/JpDg3BN7nrxJrZ/0Odr+6h4heOzMt7GnUh2Azvmj8TE+IOeD0mEwdR75yyqquEOvQ7fvwc6PlzZQf334MXnB7ZSRxqjUglHHXxjBGGNfY5JRgVyHvnYjVc2HCa4a++6MsduL+My3THU0RCwR5XdRARCAcHlvUr3g+xPkE8r7nuYS9mfCug4jfvn4P+ZmXZ0nYdrZNfiWZdNH5zmNV4elwZF/NJnOKAr/scZGmvZXykyY3QOB0UiNBrrTwPOQuANVvNBrIjlZiFviUBF/D0H1IAsogHpxLAIy7tijHcjAoMZ2QlvFNl6ea/sRJKDBNPledLQIqQQAprZAXHoiAPZEUQeGeQhsiX5nDQkn5dG5Qv9Y+qfYZa/hnlVXeNQH69J/GPWuA56zKKPI5StF7xF4tzDUlyxzqWpt9piCUtghLMZgQdxsEuJqISpU78VWmTo9PDSlXV/a4lREPRYtheulKktPAkm43aokhHxIyxyq0pWwCf0ULoDNbAdRBtyq20nreanBHvh0IRWaKcsyhXmgRfMrhyBnUbLeURL4hp+iSuVNfY0zkQR0pH1NIED50qwtibqL7Tv0ymsNNbLd2FNxkHp6XQ655Y3PUlQ0NtncQancgry8YN8Lv55KJ4d05A2LT/LDAT8NqEJGAptBbJVR4NO40a2brj7t1+4+7/dd7F9om+m4j3fYp84oTi9jP51+0T02YjeK7Ih+1TwkKRcsfK97zr2fvt0KT9wdXDO67esv9c+kYLSOI3hcFp5WPxB+0Rf0H20msN44D904eN7Dn3gr/75zvfbp3ThI+941/vf8rf50+0TkEP827/j9oPPfeWbPmCfNv7w4u9uGXj//HT7tPH/33/40NKBD/3HD9qnjX/2d+HfT19snxqPPkD14OyJRl77id//zxf+8WefZp9SyOdvP/P1n/vsf/6AfdrCX/HVd3z3X2z9rafbp43/xPd+iBt3xgft08b/zIPZ7Ozs9Rfbp42/VBr3Gx+0T9fIc4jH0zMTxj55ML99kt3m0fgkPN18R7F7SuITaTdQ8XQeuN/jGn0Tb5/8zbcTCnj4O/hE+hw6g1DQGcS6PvpZJf0Mask0kC3AkxiF6/yahnieBU6dn2fyM+PnGfzczc+z+Uk87XKRrQgT8STZe1xTRC/m+ez0P0HWWP9zbiiBIhRqNqr/eTrVWYhG8iEHMxucp7qGhsMiG+aznEY2jd8z2g6WRE/vz8VLUjwFaqPnqUgV7WJa2zEUjd2FUSRzFfteeoqqjZ6bR3xMnmDeWtJRc6QDJVdpB53PmQCRc/sZ6uzgDK5DuZzBbaOCQqiNkqqNRtqAPKFcmhNRJC2nRKi9aoZGgF1xrpLvc62+ZgI+JSkb4DYG9vR7FwgJU7FXwhHUTrSCiaZyMQuVxXaBttLMs/JIDsryrRSp2LahK19TmCy00rei2Osj51fhMAtSE40HW8YXsj1+RmxWnp8Q0F1LCTimQ/wKG9434mnMRwfcYoRXi/hFesRURMzBvAwFYD+GZE7hqJegkH6wxqff5/lXC/8XHDjPP6A5+YBqDcc8L2CQfBqcKsUHDIPbUO5wVZfy3Qf0ACSPxVeO+oLGcqSVI01VZRtiEACNU5Pmcv5PodgrVzfkaL3HtSKLwlT71QXLKF/3YDr7eZSAp/tOSsDTPZsS8OFSPH/akEpRvrDSfw3uQ/NfIvkhv5RZ45FXOYErAmlNkH1eP9jlX50Dqo3z/LP4AQEoPxKszOf5FyGox5N7JPgFBM+V4P0I7kYQd9ax50DwIcTulOBBxJIEv4zYVQk+iGBXgjchw4IEDyHYQhDCbWPJ4QDVBU2zL2hT0R9NRKyevmoDp8Q2yhjlsxNGNouCfxlOR0GHa9NRcRQF4woKRhYFPUVBDLOiYORQkJEPKKODdACZHNZ5FE3HOogDsSNxiBYKtSkRLTCIFpKniGZ8LQVAtMBsRCYRLdCvAhYwHRfRPEW0EOWfANECCqqI5klrvCqiBd+AiBZUEO1vHmdE+4WT96wQjnhW8DbxrBCMe1bAruaBUc8KP3xD1bNCeRwdYav5b+Rb4UduOJ5vhcNIfZQ+CH70hnEfBGHVB0F4kj4Irn6sPgi8Ue2C0GoX/GSn4cuJfijHiN51Af9Z8yS1kZ21SlOerdKUffq2V9/2AEtvY9kNnhcEu2QXvQubaOzTGMzVbXiGI94LAqx5H8GsBE78uO5NdRcYO/GyXquJL9j8o1R3tFTU8dhZJGqrRs6+ZZfYpADFgh7WUXp627BoXRAQyqV0WKSmcGpSPCyaIovpasSRoqlV7jE1/oTu08l8g1Q8tOA2tQcD/TalBmKa1EQMTSmhpSXEWoJtGqW2hJaWEFM8vQTwiNzlxAqJ/JHjTZUvQLrrpSmP3cyE8AUGAcUeoACs3xX2LKEZwUg0Jkfz6oAb2gggU0b+EW5jnP0kmqA46FM2qMbU0EiV8yuNvw3A1u9Tak182trs005eJ5EmzMiCMyMtLmZNm0GPnouB9tHqOjr7MuAaZUeK1ggoYmphqRPwHsGID4bUWq8qhLQQ3RowJpQffr/iXXpHkZad5yxFExCIKB3tRnOgMdMhkFYgEI1DoHkcCKCneSL9zmdTGXGGSQMwadAsCQzsJTrYcORYWHUswmdJt+NhPsdjKnNAsCnLmyowifHoTk5L9/rB62BTqAVoptSk1pFifkgxiOiRYmE4uI3miSMWiMNFax14PqSUJ5NUO6C5IwxiHog7rK4KrvmNArdJkXRW1TcgAR1Nj0sW/vl4lV60KaAFrkB6McDQwCJumxsTowAem/GRiSdGZpcF76h2TKNPgGqIl3HAdwB4aBxMwvwiBXyiktlOf4+YIUr4k4in0YyqCwbEgcQhgTS0NdHQzWeCyNR0bGe1Qm5HxPjvoeSuFH8kb+GZESo9kqe0mDfUPT4U/MAG6LTmbl+9JrSJEZlnAtV14vDzBRLfxlgfKeJbS00FIcIRFGmQvnCkaA8Z5E3tVYZieAIxEowN8OgAtqgNFNG8JxjsAJONUWrgSM8CpYiQCThOgJrHIUCAlg7lRfmsDjPDRRiZUMczYo5FrzwibZE6JK8iC1QWRwv8DJZBCboUxadbzNoVCOuBBJmBwkmE3ATQbuXkUM6tugDIOuZib9NYXnIta/Y7fgBVu3IxHjScTo/ogdyCfkCPTLQSb8vejCI0Sl1PTqwImlMzQtsaKmvKS2gqaD+OS1Wljd/yRFLyBiN3UzCpXk7GQGmJrzVii5ZHpUFpXcx84r8re0VLl3UBBaUckV6lld4Sr1FTVpw2YXpQGysr4w626k0xHIeSI0bZIjJnbE303G7fVc9AS4KDawgTDglziJM9aFd9XVQo+7doHQEHqiqUP7+5CuW/qirn7Sdox5se/3Zk3I5srE1UbdNPnaBNvzHapkCjlZ+UShg/SivtfvZGpBb+vt1ytqaEA62F4O3HP3nq/ek5sx8YCHGBA4Y8woPAw2qHAtS/gEc/0Q5BFYCxqe8JA+/vDfYKVCnMfkZY+BpT2xBYh3xKIPhcOMcELztBYfpxL4RaHv4ESOqUVyYF9sj67pEHkXxInrLHSC1iYDqFIN/73vv+T/3xn137p0+7EsIqihn/VSFLfPi6E1k8eIOCaqRlWhcK1UVX2Z6I6pUSkUE5aW0TRXlddbbwvfbMnfgKdB6heuIjzP0jceTx7iOsErujQUnsAGYWcgRAmXKZwCrgl2/MukXOzmFUUU65o4gHhXRWthFHsKCA9Pm3KkmqA8Dgc6VAqg+GdxTJIK8b/E6OFAnFV8niDmq7h6lSywO07q5xkEI9fg4hiMHflb0Lgr2MQQ0MSZ3fldORBjQ5Igajj0w1YeM4H4XYn2+gdyi+fyMIi9vTpLqnaZlhTYr2bfmMXDFIZWRREsLKpRNhwkYMDWofAXMU0gxFHOqipbche2aycItKHea8DB51ohyZEJ5uoRi6bz7zyGvefGOsvEBDKTxF60WEPqHjeQzAmBQAkMqP3i9gqEt2hRRnT5C9PsYG5EmqmOyVd3QBf06zllEPBoWnw6G7bF2zsMXDsGGMB3mCZDJ6L6ZBEYrSMUd5Cm1qyNrTqQ5fArU2N0BuIMc+iTTr1DHVLqhsebMRphSZUmqZTIzy/6ZCmbd84wll7jiuUGagQpl3nzywoiqwjtY2AVY4BqyLcQQ/CqvhdFhpWBdCwI2mwS3cz6ATreRYSA8gV4FbeDy4AagKG4CvpeBL9BHioXBbPy7c3voYhFlHvsGFWY+qUz890amo2qnoJDt1xWPqFBBytFOR7dT3+Vgeofhj5WMqGtcTNF0WImkEYngnbPmfp1vp2ZBCbLxulSZzdscgXSmWpB+Jg91ghOL4m0wif5zi4EDpwdFZdOfILOK2g4SqUODfht783HHnzcHHMG+un0CxoIpiwUmi2MtOCsV+5eQHE4aZzWge+dCroimDqXkC6PW5AR1wXuxVBx/y3XD+2shw2h1SpHukTQa0f/+1LxR7SV/fgX3vcQf2fTqw37GZeXEUhR7KcH75Yzx5QerWMG7s6xIfa0srVsORc2Etfb8fhNgLWJPnGOFyGl3WrpUHZqQTC8fC/McqUrI2+MJJUYCjeQg5K6fiMU7DY5VD4aPnAHII7MfZm2jS6tfgFfVLvWvKBbxMD/KpJstGB4HAYKS+Zr9khfGVOe6az8eRmN+ojv/K+Z3Y+Z3dhc+1Z4kUXISuQRNdCdGgsNqg7B06Il8MG7KNui7UYwn8Te4QxzX4QkBVcdp7qQKytlHUnbZFzvU7Jb28Ub4Ra1HW8X/e5BnshMF5S6DYKpVUB0NqrBdtJ0LWy0T5DLVVGzBvZ7+sMATbCclXc51m8N+AZVgzt9JMuR8bgrV0rHgbquULeUf3n1By7eojo8CwYi0JdWVOzRiCmb0T1fFrwCLAoo1Hl9puuzRzpMiGR9C7mbIujmRdu/Vijrsy4LarhgUsVrUnGpi6r+ZwSW84XKeMsgG6Nrte2YihA48gM3a0qSq30YwbIqCHB0PrUJ5F8vxatS9I9ml+jdoa6phQy5WdtygFEqRGROQsc6FgVjCFA0bAtVbdv6dv87zQUQF3sVWFZ1Cxzd4FSPd1ixNDpS/BlG4w1d8tCzaH++KooSH5xXF8RhJ3FjWmLhyr1NC7Yx5KTCCszX5FqvGwN2eidWEt5EcDxcbONcETq/tsdM2sH155D3v02CeddGZg5xo+BaB9fHqHdMOrKn1jQQDGTTAwp0uJfW7D4MdedUi3+qj17Npb8c4wz96DKtL0c14AWhhdW9HC1RFleXWgBD00jjpky+YmoJMP53UXm8i0jBQHlKRUEKChW8ZykppNaEzJkB9yXD6o4OLwCOZ0PDAbUwomMsinyAUCksecCXpROJHhCA+TxxM/GP+DdTfELUgeKEMgJB6cmMpwpKN+gCSfxPFGVoggzYM2hOwR5HYBUlVUhKLKYtTNYDk2uMlu9dvN7oDzOjYB5fmKGz5yG7l19m4l0qoP78nQ/rDvBdxy8fdR+BfWWmihOv6QVf3sWqvtGWNegUq7dUvDMwxZpYGyhiMn9pgeFwKhIReIUCgRLV8XrUA12rktv4q2aIH4AU9qv+3X5JFtmDv4XL6n5XublZ86tyQAY1kZv6OyjRNWpu1J0/+KgaxV3aOowxXfiBoBM7OuIylRhCPfVOXL8MiIqwMTHbAEn3CCKx6zF3VgfB6f4vF6wPNeqfiH8ng+dnm2/xVm9jOO3vi06+Dr5fQg+f+1PZT5jCddiwM/tGX2NcgjBEY+BGy6qRSAOzD8nr3xeoM72Q8rEUj/+6Phit8/wRWDFXRsMd7G+OL+NL64wIdXMw+89ug3YGB/R/ZfqF3puWYJzNlSdreZOHqW8tuKKn/hBT4uZLu1Y/T+9YJM7DxSepyp458Q8TVJQZynF7U95JCqVGwJthk/NbCISJl2kztmQJ/FmfFc1UouUkhkqlu1UNStO3G0Q2/cJsJv+no9ytyy9XDryqO6EUtVL39c6PmjYl1fYexnH8WnmqCpMkIO7umhx/nAQS8Qr8hxAmfIvfKY4TfdMYMKCMePPgIfPPnELSdU4DwThdqZSNjymLlrx8FH7LJH2XfhuGPhuL3jcNweGFzPMbgg7SVn7UPRZBo7HZXb5ZhqY9vlR1qvlROp6pv+yAYs3C8OtEIdx9iogOpQcLXwLpScb/LnuuBUN1uhlIpHqA+3i8Z4qDNdFFNuL0BrJ/fUP/+4YoeuhfbmFyaaRjgfXJrDMzmAP+6Y6tgJjqneiN21NaqAtZt8e5OcG2fmLlqGxD34OXc/LrNbrdbfcjfKQuNvSxU2kFP9ClOoaAeWoq4Gf4sALL1k2oV7aHKTGmNd1zsfcdHg3OI9qm6b41GYg4P01R6ufI6fQK9eOpO45hyoQT44ZjkCAipNqX6kZmF2PhD6LXcVixzZM/TOU3GC2D4IzLX/OmlykeCaHE4nYnXGjL0YPmuafZMnw4/Fro5iUgwSQtBJ0Q1zHxMFJoGxKUqkjLYyWDOqAC8ldapXvjKUklAH44H6C2xN8gxjncm9Tyhgic5EE8NicuY+YYdkQBtRE3YU9LaYgibCj1+CNgBMA+ss2m3XrTJHW+mrjFpUaRzMKlGqpLopzZvF3olm+cgkoyZO6TjdntJhXxGUtwvvumgoHWAJ4Meeet33v2XA7r32/eTHn/Wsf5j57xdxrzJD9fXuXgTbb96Llfa/HQOD8wv+Azh9HT9Vl1Wt8iKS7sbS3SJTYZ0+tJOmyzGTHRAldNk3qIR5FjoN1NBNp7tOXljVKmVVn/z5T/z8lLMO5JmQVX0Ceblt/PhEzUmrPoZpyI3m//BprKjZb20qqXrJC/utr7ec6veOK6f6HSWWz65yI1WzV0F52gyslLnuMFGPmOX42O0g3H5QQQoGSGupOLf73enO7QANcKjPBBcr9YfV+kO7RoOkgcKG+KRsAUUSh2qwemzClblWObasZbmy7/b8SXmdW8GtF2vuP+NuMObfLxj1Legkd49SwPu7E6xsq8rJtiYY2d0lIxtmv4+PT8C3Hr+7ycl3F4hX7e5f/VtOQCMu1lUz0DU1gAwEEQjpiq2h0MwVM0lj/QoP+xZOO2wzM/frduR28jP3vM3ENY5bniazuYZFUv1MT7MLn4Gru1soqaE0QDvoP5Ff+7tz5rNU5Q9D8lxFCd3RXypEHZk5xdgr4BtDuceP4ECOVgQa7ad3BmFidFgmuTI0ywmGpk8UIB+DK1Nr/4FyVp9WzqrvCwf3jBvh7/h85FFzqLgrL1eWImk0PqFoDbACyVTFyauVtilq/y+Up6jX4itWBdL1bleEWpnCAOctq1VXhIampoyAwlP4Df5Y9AMYj8HVY7HOG+RtQAwsC5p/aZ6iXjBJeQzeQCE7egG/uV60VPwrS612Wq2f+NTKfnRqikeiO+cYBHvxKtLBiDix3g+dqjd4Ubcle73nqTwNCz9PVyeSHoJn27fjGW9qHbn9t546vMoqS9osxzjLMA8rBp8oEFbRqxq+KqIhmEpgHGbN+rDwAf5BUS1am53+ZhT7YkGCW+RYwoOh8oRCVCAWvPPHbhCxIOPrnZAQZv9b5k4fggZNTJVPOShVkXeAQjEwAB5FKbBvdmeYrpf22qzwddX//PPrHv7pp4kSihqUk2O1/bhcLrI53DzKG5WM48cGTdxO3HDwo/rGEfv2wcHIaYDiqLQKKEoVSaYoS0+aCRhcPBw3EzCQ6wLSkY11hIdH1MYFRjJbnxRng8vCqausnwo6bULf09VWXatagU8AUtQAXxbCllmeoX/UUabA2m6JiB9R1XYX/4fO3v6DtUMX3Xf+K/O2O5poyT4irTRrTI9+1nSHTxRcy2mW0iNUjRlqP/NZ6Wk+VxZ48dHsZwSvZ13+jA3MaQY9GVgvZqlN/Mf8cLtM+DLXbsP/ae+VqtCdYBbHNINbGTCIIaYMx3DHEsKDoZ1TcfoGX+UcQeXELnQndoYnDlUMoKKBSDlCz1xtc/yYj7g1rEM6KMikWfDi6Ymb5mMm05YSaBa8BBOHcsEmh3IhpAiwBcl/pRQhnDiUcw3jT7RNnM21KVyrnsHBYfO1hraYwQ2GiqGgJUM0tkpzEHckuxffDo9v9AMNekQGW0eOLkIwhX85zqrevwmr6qsf5vf7UWCWNW0Ym9uYsBFysDH6fn+jD3GySOzZPTUu1DpSILsBjsWi4vNY9Teaa8aMxQDcLeIYTQbpGmEXdW8DqeX+sAiAqD5bAXEGWXTRGiNO5nUPG6mIQd2oNALTZ36A6r2NPKR6HtjFE0QJlz93X71h6A6FFYslRp/W7k+LSO2QVJviY1HSGSMtwgDc7oeQnIG2oyJrfaUGHgtPgBJEV8x5Jg5IDRz5MsFHUpO83J88XG2BsKyVO2iQO5/qaEqKBqbaQPcRtW4FQ8Y8TRuzTwU/EdchK1hMTf5GNCRRMr/1Dwrk9bo5DBBzQ3zcGPdxdK6GUNs4Ck6g0svYKoCQIquMhB5uyDGZ0awhX2dOI73xcZZwWh64H1alU39+fOnUv1IrPnOCVnx4cqId9CZn2t7R90PPqMy0g6+cMtM4tpxpD/56bdpUO/ibNZ1rBz9cmzrZDvqVyUabT7bDFw8f2WT7Wu2aidmGhX9ytukSrm2ZmG1kZts7dLZVOSm/dBYPU3NcGuK+nrMODR2bdXE562JFktjOumjKrDta22zaxdOnHSAiZcIqHm027SI77QBLu3A30nd6ng9mmIVm3r6XwzztD92ox7610hjRehm+qBK+bG+VP5kaLO12rfNq7N2Re6ho9J6ql/0CWoIhzX7Yag+tH6GafKIbAI4gT7GEE25bfySqd/6I6l24ieqdN656B22Rh0ZV7/7Cbb7ddjvCNP83Ur2777j758/qQn/SoPomqB6VEOtzE0Isv6ql6J+kluK1j1W7NxyV+PmqCPuoPnlFENpFaAMkGH3u/4ASbuOuMMZe081kUbhjOIt2CdClPlQfgkVdjkwg3a6BYBktugCsgtB2MVOjNwv7Kt5/TlVUq1buNhXVwi0EsGozWe3jXZrVHeLy1EyMaqzxOKP0v9XSjTACX57oiy9N+eIXe9HKdcHLRyRJ92KjU5UHbDh5gGwS3oZ3lQZokuwg3oVgql/cPfbF+9wXd7svPiJfGHYHi7V+fM/Yxx91H9/jPv64fAwWWi5EogwRIBEmaoLQKkINhLoINRFaQEiqzBBqCdYj1EZoJ4fwPIufcqQ0A7arVNLpvKjIqHNgP4wfzqLK1WLuRfm8DDHSF2h2f76I113q+zTIfWPkCWdTSxTR7IvhfJPmXsSPuQP7xdoKv8/vp/qBYhnyENCLZerQIkhe3iEfKOJbPlduP5tRreE4sosH5Vukc/lKX4CFtoXUWcv+zpjTz2CeZP7AGqWoUczX+aoSdgz5iw6C8mkRgX/rUAQKbQxCrQAs/gEhbmhNxOnuIDKlNs2t5b2+oIVkxux+AFWjWInO26BpkljM90ELXOWrrvI6anVnhjDqj/Yu8+PaNRHr1MylP3BWyrBSC3+X9pBR7eTWxZIypWtyxIgb9jPc/TmQRzOwBexnZTA1JZa2tkmRuAmvfBKiQ7nYiA9oDp/ASl6xnbZVTANH/czZEN5OW0eSCHDC4BW+ucA+B5DN0ZIFWlqtEQ0gmOmq3E/pVO74LGtxhOIOelKe+mml+UuN5y7jxyJ1kF3aFLKAI5pgrI7NMLj4MWet0cNUoSiYOKJLam1+2UCxeiRKVM99UkQnPWadI9+AWvlWcnicjNkKmwH+60Qg0G+12KuYbjVE562GKE8xDG6TGpTpNwnNWudYi/2Q/8D9NtXofE3JQ1vmqszFhb4qJW4BIuL8nPwX5Q3FyzmhIgwOtbmUzyo5un+MHH3akaP7HTm6D8HU4buvHz849vEX3McPuo+/LB/r5bQl/fDQzaMfPuQ+lCT98EYE0740CdTlgJl2Uo30mpZMnL9Xu7eM5QmUhgmXz+O0wAcvYn8EbZeCYCBBzHnMgSlb5ICBcEQpDtmVKsiOxKj5VgeWljEn5lRslyIyNUZCaFlGsf9QSaKUPgm64VUtNKh8OEJzkFMniI9JKR0AFZ4DFeZW0Ryuvo6SSCmp6Gj9Mu6R3ii+3cOTIoxuRzrE19Q9VM5xoGSoUQCX9xwsVjEVDMHKZxF/EDAvsrJ9xfzY1MJAvmJN9m/BFEWw7WK0MCA8d5snmSeMKsziT8nZIlee0TwwfpUWlZwtCzmbp+UTkzN+3O4xZOCEx5E1mZn8+XSappmyEXKWUQdbyDlcFEF5GCWKufw5TFGdr1bjocfthIyTCyElYxLODBlb0uZS25E2CSvJmwVFm6WlS9XxJsyl4rip5cA+68A+Mwp2YC3X3jIULaVVoWgVGCzDx42hbrM0M0nd/Am6NpP7tPgo6RpTrQpRAwCjCgCXaYknYAQAtgDAFnotdNyh4aJDw5bS5H4Hx1+Cjx564wDTc4CZHQPMquAjzsfQJvwpds1ImT2aZUhMw9N8K4DSohnY2Z3NI4hZ4A1iel4ufSv5glHbaJkii5pzGF1FJUZQRjZCTM3EbLcchdq8rsAPhAeYstVg0XbBlnlgyHyJIaBbU2EwNwaDeYbB/2QH9Y9mTgJZ8OdYjB7NYU62sIQvGw4vAFtHnfFZuVu9GQSEF1KPBvqSqVcDfamJQwDCsY+Zl/l2I74K9JgVgntlNCDP9hCF13F2JLKeClSLSVdOADO103IvA3I3aXg3h4k2m64z2JbMlIgp1ouBug7i6ebTEaBepGUzHecF19Jps64l83R01kWMbx1S0k/k68yLRmfe5pgzX2Uk0HzlHbAYqHwqh7E+XdMEhdyUmzVLXx1LHzcXeYD9YN/1g3mMNzdxzgzPsg4ZhbjWQzTvPJwVxO967dwsTf6BvAMSAjZQTdjYpdFw0gvoy4LZu1JTsmD/WloD/Gt/5PaLP00zNjAHYjogI5qxoR5CXaZxwuSbI53AHemILNRpwap0xsduHOIYTkSGUhwTluIYJhBOHCMbsmDzWkKtBW0a1XllsY+3Xw775YsI+So6r3JJv6rzikkTiRMstYsfqoq9PEI8JC27r6LzqrconfgEsukpEpo/hzDrJGGtR41FPAlteyip+sAnAW3VOcYwOViPnxWioLq7B5RgCoWVSmKVx9Yolkqq8MXmXuEbKHxHDjNjNMVA1CkZw3ybCsS88hHqo0a+ysL87IsTasV6j3YCxO7s8ryTvkRb8VtZS9+wEi9Dlx/3NvnXmWEdlVvcMsZD34R35aFvcTz0zQimRvNh7Ivb3Rd3ui/eiqCVWxgRydiHb3MfapKKSMoPQ2E1rKwhj630Ia+X4oOklE00SslFUwUdhrFtlXKMdin5mCnlHZ1SBpIJIBGarYoO5uQjlV8s8M4Iba7y5dSkNvk0+6Ji8QClHFpklnt/sUStFxW1A6qvMQtKSkvYgRtpBvcgRkqs8oW7ZJ3wZWMkwZqeD9VAnWRHr8rPC07GUANd5wJHZAwNmhVz/7BIO9vHSOo3Vs6QN1GFxOcpZqikFt0+PL+4hmxxDYmFPtbgzEEWrIS64q51ExZhhdfYg5iOCFxtnleY5+WUAlr408lZWxOTiFvU49ky8XsdnCwKRyeoVWUUaoZRQCLCZNiQmmETyIRrhh1plUzCiopE1CwZ1RyXsKJ8Q63KJDjXzsIkONYzMTDG2s+dFAZBX67mMJnwFcIgaPhyMAhW2blrGYSucRbp4N108G6MwRuATqluoCV3p7CvH2EQeqAmAr24Eok+UyP3qQ2AgoMlyxhQPMag9wyDjkoFq8AmtIwVY6zNVuuka0QM2KSIKyudefOiBc8fyZR7Ub6qeKUSR244UmovyruPXFbwKAQEq2J07VELCGrUnSIgaI4JCGZBb2fteWXb7UHUb0ZbafsCB7o64WuUlmNRq4gF6gr2RCfzLBAtHhELtAH5Ns2ejFigpWKB2rhYAL2SZjNRmgUR4lbRbFUsUEMtWnDRqogFsPI29K42E1iMY0v6U97jM0KBvOvYw8hBYw7oio2YWOrB/HZs8by2cirW0yo2Y8vmoy2PjtosUxd/QmvETSvvbwRpaUFZ2lgmV4PicTIDKUFNpQRKNERI1tIdso5gzUkJ4lJKsDIiJdBMGa2MSAla2OTOqjq7jzGjOpc+C0Kj58X2TkVECxgSR1RqFaICsiKtpS2lkEDDmeTtYgvYpaYVEjRVSLDgwN/eHPxdkYMsGKKTMsD4MesgEBtjqIrpk8RIZQTVSCFEXSVEeoVndnMSlIyRIKV/a0qI5Jy+5sAXUxPsAGe0LoGbpYggr4gJFhxSLisVVTFB04gJqpi5xYGmOwaaSDGzLYLhOv7KDS9WMiGQ0zBVxQTL2AvH1DWUOcpb0/OOiAmE7VHcnB0REzC20WxFTLBimQLd7FVBuEApcGWrwaMVwRfVxy1xZGr/Z8f6X6dViAi6j25GdinFn4KsLQCb1aW/zXApl/6YZh/L0t943Jd+vUUKcs5p1fW/Vln/N5uqqoRi0ZIDuv7HU6diOmUqLlBspmLdTLl0k/V/thJJaV7DlAOmybTzddrVRqfd5jhT1wmnRMlus514oEMZLcpa4Lb9mHMNN+fa6rOXEpUTNCRPDJJBTf0AiydaOKvDBJbPyQl63ARtqghgt1NP5QS6VkFO0AIZgTA00dapTWkrJwgqDgJ+PuQT9ICdjU2/4QfFCIIuktrYDBGZwGF4QolRnlnrfog8NKtBjeE6LPgm66oG7wwGu6DYbExw8zmUqCv+4ln98cD396mx72Mfxb8HLhaP1VBVuoxHat8XX/AXh37lwfuefhUEBrHYx2ttrN+Bkx5KxaV1e2P99tLcIa76ycU0DOIMQjqdIhGDR+LTW3Sm0Wrxrh4Th4gDidXmyio6Ulf0MQ79GmmDXsJVPxRQ+0Ww54IRdaqy6gCzaI5qEPlGbelma62i8xzIoNTShdogEXvz2dcsTwXNXEYUsX7KxFGGWbCAQYgIB+KE/KsYDTImWRS1uaBSJ2pYJK5e5VNRNai8veZ+8EauD9PFRFAnux5R0J2mRyc+wvXN4wk0okci0Di+SMOJj+6cIj4K/s3FR9Ur09HxZBvuyvQ/eKGIJ15p1ANBeStTU3iwSJ4ZlJ5ODyivj6pbgggbT5z184UMx4YER/y0uib9RC7KcH+4iPNh69QuHjAvahcPuTAL0YKSOJHewI+gSSWgSRemdD/5atUSAd6+uUjA0uwGYaAEJGq3NfgcgJoG1jBmzd13+YIXqEkoK5UJSp1IxTJug2ji/XNpIPzsGslGRolQzNRC9mR6u5jq+2HA86euYpeJEERd1kO2ZCxbbTLbAeAergsJGSinRZj9i2CYlz2EJz7+uAf08qD19yqdROOfPIys2Vfxi7TDpSHQLwQ+3PzbvkbOr2MdZm8e4OZP4SUShviDIXlq4l+tzVC9vwtaDRtAcH652xdj4JCnS1K2cb00m4LsVTdKw7P3IIbqnHwwEu80CD4QMql8MW521eUiHD+4Or9rE4HkKE/mYQh1Wcy6G1BkEWCp4B6LtOg7cSMDk+ImWJBF+26K1rIbkRHx/Zv8NUnT+KPX2/iDI/FvknjsUIG4DI0a91x5NFjwQN5d2r8PSU7E3l1zsYfL2IumRe52kR8uI3dOi+xO+7w1JbKM0abXeVQf08XT+/81dfb+B9ARyv8ecroLZ6UBXx/fYLe7Ycxx+wMwjrd/X1uvNU3NH07m/94ctDD9I88fvYMYO7em/WOgvFYkA/zkEJpUfyhAl7sUAyl/6iqh5KuaDwYrNF9m87VG8jEWccFrYMVu/9L1h7h4GC6IgcSvBm7qfeX7PTXPci+eXFj3guAeTwhnzcdwfcG+ZPzykEdx9crer8YRdBJhLCaoCpc9zSFjwzXofZtjHqbNKiZNdmBj32/92sYb4wfO42v9T5Z/f3TxwNgr2Rj2GcCDT3Kb1ytuk8kFr+qV8Yf3kgte2XvILwKQokt6crWy9m29wkcnS5vLPmg69nvGXFR4mRnPcjQxwGJP42XkTTdPE7yAPMLzeeSJV9Va9hqlNCCSV6PGZwPnZCp9p8a+hHw1enO5fsNpat6PPHi6UgChIfd42WuFxtQVc5FgbSGBAqP0ljOt5APp9GIRvr7XyxMtJXf8ktqu+M7yPTuECtQ0BVIux/rkbk9GPCsR/WzVuFIP0IPyANGtaBS5m21Vl8BqNZpq2lNR2sSyuO+2W/Hvj5ljbFK0PsxeJ83wFUlEu/N2oI24g/OwoN+IJ78fxNNT32OHdKnxxAX/G1CC2us6S++cBbo0pRqZFQomjZRetcajMAsytNiSNlR1X21tSuw9E7H1tmea7xvLAak2We7Gas6bbtSKKluRv/J8nMpUJr9OVlnYhQZnb8RXK5iUpwe7zw9u8RHUfW9wyL5kWB89eVH25H77gpXzTl8/5yVl4EtsN4912t/LSTAR9mlj6OUeX2zS//fv/9ztt956zQcGbGTyfa+75yd/+Q9vv4hcEEz3MV8Jxt14YhJs+BVycZ9fIRdf5pf0jijEwh9WiV9V3/3s2lFfjHEZndZbnbR2yuzzudiPSJYaIfwuCavKqwRV5RXBtC+JbnKKjh+icHkoKydoV1OOSeZAJ+kCSJeO3g/jYwAKFxd/5Ebn/Z1hWATlZmPfQz/3xT98zvddcTGFPSS+VfBh4B8ooo0JEhePkLi6I3H1KomrOxJXHyVxYOpDJnH8BInDcFoC9yAIXHwiAsdg5x4BzOUYgP3DLZfL2p5sAQ77eeDuhRz8f/Zmh2+0dtSyH5WgmvYLJOZNiNFPMQuqI1utjUIpANQvVs1r8vRY1Bh/CC2p052GETSHjqKEa9mP6fKF2dwF6joHn1g+VAwg45MHbjIGOpw328nonHXUU73hpTeU5N43P71XGnS9Kyr5copUKBCDb9O7DYfkCfOs9Q1s9m/BOz8P4+nJ5nUQqXxBHFU1EQ5VuTqyXCzuU/pMI7GvB200LGwLHmCYNfzRQ6i7ZdhYv+otggL2b9Q0lPWv+J5Xm+UP3y//PsdvMxSB/cw7GFt+ZhRvsKAlyOc44uNcZewcsIrmiRB8Uy+FULqQgx2OGPjM6KEhRUO5XnQAHokWKMLxwNsiSonD/bdFPELICMVcxGucML6Iyypxb9I4ngr+m/E46lNy5NaiifCGhhdpkZpX9gbigK56F/tK2YlQU4UmYgCoWNBbJpWNPtBL2EEUeadfLOKZFEtw9BVQ0xWoDpmEd4OoWeVt4KfS/VAHlxv4DVoQrXB+DV/CmweGq6lZ9GVTkXXNoYh5vbIuKErpGs0ZRwnUWcvluGENhWEhXWB0dWw/GgdxB77jHAp90Kh5wFhM7a3my4gXm3ur0G9UExYCs1oBy7xNbEAhz+Vwm5aGtLgOVJhDddBERH23f/76o3e/9itv/ipXvInpiyDBAcQ8qo10uQNu6FYEUR+yUdiHjOe6aCJmt4n5cBmzcyKmO/FVazxGXw3i8OS00/j1foipi79Jw4XhM2575+c+eus7P/dllhYk/PqxW+UdwgNsRCJgvtvGqtv97OZDZo1S74W+3owTCxxy2KkGvKBEP3JXEbyOskwNMQyNjOqYzWQ7d6+UVBNfkOBUYka8cSrNpihKsdyz2n7LGzFh2En7mbFd6WefvNH4TLU2LI/FUVA6wjTQ2O2omKfqKuq3mUlXHyyxzwLFuiKzEmFoySnvCkNcRVK5P2id3A+VX6k7WxNuhqI9wyNsL9kQp/dw7pDCAxsF26ZNzHJ5+cXkguxMKwF1gwDFTV91dSQMOeFtNW/q7EjJU5vSEaV6q6xZ2vBrCQ+V80NtSLcZ/90Y+aVJtEocpXmoV6lwQ4rf1Y2Q8XxiwQBZKR4dPLI8o5aS0C9j7yry8MZwOAYDY1fl9L1DmlmH00W3cyS/IixGpVhJoE8vPS1C6WmBltIk/NlSBBzZDdd5bs9uwPy4mpKDxh36Ard2HMfmZFobTEoFDBSixQf22wjY7iitqJALXtVD6h3DdX74xH8gKarHwPCfM3fDBDTa2EQtMODYpi76LTQrUvy6EM6mkFMV9YNI6hVYUEqlkE2msGgaPiyJZZPqqEzPX7QOXdwNTVdy2S3aIh9GMyt7RYx7coTbL5ZXRsi8z7MO+TE6tmNYkCDyOYufZxnmnoO7LXU5FvodNgbjDAW4++jPuJ6fV5/vfyfK7H+8xk70QDfywCRl5/uXSNLdmqQMJBM/9XTxndkfvU7YGa6siF2MyknwKjtBJ7mVIVadJ+vMDi+XyGlwkTLWgwDZ05V232P0CPKOOhDqZ1jTrymyHigcDJCoVmbRwesceQDoPB9tLNwqMDt44zl9XhMDMDmU9bh6rGYLbykWH4qZdGK5G3HN16K5W2n2VpofWkqwwZb8WsYRvgry5nkVpAVaPMK5OBJ6pWLYJWtj0DHaTXvaVst+EgATaw6O8iVK+fKMfAYj+TzV+z/xOtym/AfQjP6PIty/F7/S2172ZqWUkDMtZH9xo7wwvPV7RGdf1khetySl/5nXozzzXQkK/VbH0mTWL3XkNaH/Jwfdt5nBic+Yt8zS6P9pbGYZOQzprqprd2x+WMpjssqW6tzKXmsn1aQdHoBTYjhg/DwYTBpmn0bL9CY6edmvqZnZWvr/eN5U53QeZEsBjtbYArXIT6yB/lUITSXUU8ESZKKA2m+/QT51zPT1gRdMMxxsWLIfv9GZh3M+IyI5gCg35GfXIkgssKeLwLeprXt7R3M0XVKBKo+oCqx3nTXJ/hPIrvdKfaAbXlVMEMk1VLNJCfSGM8paE2VE+d3j/GfukuC5a+IPCa3WQtQqeJ9Bv/tStKD0qBmpclSExqkvOdA0I0KCESPA2ecm36ZWEVUqg+x5xE97vulhEx9VOYP0hwM1Yzrh/0OPOYEahpjqMWv2FpU891vam3IjRcaXR/Z+C5REz4uQCktibS2RItGyXSuJEh7QM/TkKkUjD6gJbx0w/KRGTmQ4Qe+VYw3x6MAoqRLjwCYEmsBJmqD2H61R4BYeLWqDrW0bRTW0YtRbgu7Vu4zbWrPZfbYwsGad9HUUA7WhOoPlRKJaNqqDysU6O1ep7VSnrK5FWA4FRMbwnBuPe/1Ad5UkjgGMc+eh+gdobeRRac0mD0rompWxljsGAebbxDRyYCVygZXIqX1bucJdFsbJjBbulNYlFDh35b8re8CFAUXDqiAPo25p97fvHQwFGTbWB2VZR6Ust/+kyGbfCzGgBH5p7+BKtoOBaTM0xPPb+4h5cVHnX+HAuL00vZ9T+6hm5Sp93Psje43Lp5sBYY9xvkIEyRsW3hFUJIOr2Oo7cIxU2N+bh5b/L8uAKa2/Z0IuC2V0ZDjIPiTSn1jzUeSgUKZFBFw4aj+DMWBOVJQ1nmF8BhnsZOkhQnDrvv/09w9+ePuLftrDngCp7NtwmP2ctb5B/HKrWNvwbxtSsM49tgcW3sjKy3lv05xDhcrXPGdm85g/cuCgysOJngYYgzkqdXyPTPVQTrYcrlKU/RoSCh0q2EvhSSIaq4fZdhs0mbmM+horpJ/nf5TnDo7NxIOhVvJRfy17rxPa1Ox+YfdeizqDi4YTtRbhHfu+/PDHX/ZXp36WbaJFVWQuxEj3lT0Tc/dFsMuym2LuqDudmKtVDiY/LHKfV3r+1KVPFchD3tXrGqiq5Qu88UZQRVq6IC7oHcmkdFyTlSsknDZsX+tHLyVPHdl88MbR1fHxXHnfN172NdXzpaOeK17N2v8OTqstDXXbjr0lEiu3oMmeOSEI8bEyIBhwCrhgB98f9vxAz9BklsF0LCrBSbsVh8MwCVa7EYEoT5AN30glN3wo90O4JAV8FAVkH8MvBRtDsOUVG4/l9pmJ0Ya+Pf9jH+sPDRl4B47YfD3Tq4oftZ5y1/VgSb+eygX5TnZWuk4ayBrpG6nt35cpCefnslgU71dMkDkyUGL1EP/k7djcD/RVocUQrTuMHFVPBX/Zm6ZmogDBQZYqGWCZUiFFpVeIoECVA/RNSGZFyquRMqGSy8YGof+hDbYEGqXKq2jiYZ8laqn2UGE2JO/5+YjWBoXpfWGgAv0Krnmaqtv0DW/qwZmPEwlOIgRu4QCueI4end3lFYGe/hjZ/M2eJrzLs5L5w/jwwZrKgm/yrDDYg5KwNlphpN3Atwe97PcARTmbywNlmf4HeWNIeZ7/AsBXS6245zWncZGexoXsG1GcYV5lDvtACvSAD0W0ShNPFFYO5jzQw5r2GLzmKLf+MnMQFurq39LVP1Zm1UqyY/7up/R0bKeeWa2qbHuBH3qeYTwck4Tur+FoQ4J/h2DLHWtBUIDiyJ2fhTg/M7J9rRZR2WiUth/MEz5Bl0eP3LQ9u9Db6qHZWwGEidhbJmMrxCVKHw7FC0kwBctAcI6LaYHFtOB4mBZuhmnhyWCazlGDX8derWCU098QHkoihV+8n3VOX9iHcg0iWtY5RfQsRcGQW+IXEeNeiXnhGObpJ9HmeDd5IPwI8c63eOc2SQ7vsNF6i8M7fwTvwkeIdz5Fo3jnT+AdIicwD+vJNPTTqfb4o5+ffsAPQjkSksXzDzG+eQCgHfPzUJ6eKiQleMnMehmrSV+RCldP1BPnK2vU5Vdi2dxkkpVPph6uJynZgo9dBM6mPIFUr17r69BXLXPYDVXollG3qqqh0/XsZvHzlyhzdo9bKc/hBt72Zi3PRLBcMClXQ3LBq3AsWSduP44jk8eT0/mjV49xOq/2xKitxdpQd++R2Iwyd3Nka3+LnT66F+dHmN2qXKh+iZxGACOvosgIYVeVendSeXGu8q0t86dzF1l1wzjKC/sbv8dcP4oLkSEUVwHSjjejTlWo1I1+ABWnvZ6xJwm+5zblrgnfW/VS310dLVWeqi7O/gPqr+kh7em1TJzDvFqo2a6aSjQY4X7g7Tc+o/Yd7RqyrJJvsuyULH6Z5XLsFYP0BQJXwJ1hiYf0G2FlzYuotB4fqiyB4xEOEGWID66AGW81kk16O9ry9FvR9MxCjvyKBqnWhAIkpIY+jQInsKNC3cL0L4Nx3YLdDtmmqQ+wQh0ao450FMkEB1TshrhVhCRup440lErxGXRM9bqA/qyuZUeUMxDHVMYcKclNTIRW5aYqb7tw7/eyHt4WysRMZBJl4gHQYGMATs/rmS4VoDxDwVc9QM7WS83l/rmQPL5VE0XwlP00Xoy0owUaK3fVsAPXGQaYWg+bP6OzQEz7SP4ikdPONbSDEjkDVaPyYoHtDtAQ9awDlyjOWyvwVPWaCq/vXcKf8QO56oQC13QjJ2divip0K5UzLgZlXUxTtLG/oEiD1v2s2YjsdluNRf5xE6yW/YkQgm3TYjElVctv94gXXMeidjB8TFju0PXcSWr+X8+f7jaXwS3LF1r3qyrulaWjdE2xoeuZEbDpkq0zw13HrsqEOEOloT8feo3rJhDY+VfzRVqn60rESCO4Zq4nqLwo2V809EQkGdH0LaBkj6sCMreceQWkhtxF4jCnygSEm1/j6oZiDh0gT18aeIGqQOOal/bjl3IR2Z1WgUyQyJjTKiW0sl9u2H0hmqkKmHJgRGlfLoLIlyidfLZd3lO5Br8+V8iNGIHxKIUhtrxOTc5rFkyGgzSuvkbRSxmH/JeK+//gGpyexCw6f4ZH3ttfcyOOtatuoEoTWajXWrpAuToju0VsNqpZ7slEB6YK5nKAS0R5gdGmytTNYo8fYDn0QXpNcrV0brsTodP9nThxltAqyjBbbF3o+OcJa9nP2emYiYZrBkyRUdB2j8yEP39EFxO8qRcTvOrFBO9EFxOue7ZeShhx6lansP/V0fsIP3/j5H0E79/8PsIv3Dj1PoI37T7C25C3lg58P76uVP/ZXQLZYbscOan42CK9JoY6FaJA3hYAGtnQMa4eQBATNlyjUKZT/Rr26VzF3zo7sRQvD3Wg8XUUv/01z7ju1TcA33zFN1/xTR6k7lxW+eErviGk+CYhxTePlHBJth4/Sox7+7VP82rWZLNSBumDTA4j0nazBcdi/wcZV3n7jd+IxlV+8caTN67yS4qNPwXjKv8GuMgZ/hVxkT9R5b5Hiop/5UeYrB7+rt0ETF1FxgXlZX2l7bii7m4xQyTC0t817myRXG50wHJExi8x/EvyjOuuxd25E4AhOjEYpoOA19mNPHVulgPsWfgH9t7lhr04NHGaNupDMNhwOztOzlVVBaDC4KbWbkNet6dm3IMbuIvwLiRA4SiAKA/Ku+cBhbhtOAHqs6s+n/Aj6Kcueg0/QjV7xeJEHjNuHPOYER7fY8aveIEM8ZS7m7XTsTN5Bh36Wdg6/lm7CT+7VlPpb0gRtITM0YWHKj2NlMnHTSZfrQGx63kVzQKwkiOb9pn6/xv78l36ZfUSIXmP7h7Mr9w4fg/Gq96D8U7yHswrH5Xt6kfV4nff+G9nbXvUmYonfuBvHHOm8ss3TnemEqKVyfGMcY957AutMe5fgHMKgYfu1ZV11CNlX+m71yfeG+lKdWlP/NP2r5PJ9VJ++i+5xqw0/HPN/5v7xsR1KlXTpWoAuwglUrzv/79kXCxcga3T9sucCexyZgVyY6lPDK+XXqP5cTDyrsexsajgB06mvch34ibb1pIt2bV6m47Cdd82MgKejsCJLKY/CoL1yHLf7PtNp2VxzC/pUV/dRH7EXzNH+SSF1WWXnBhd64ZIfo7C4wV2bPi7rCeaXA0MjOqEQrFUjXoaE0AiT/JgCPSl0GrinBylVmSsMkTT2IqRnQM+ppA/TMDyZJ8R5oNLwmdFm0J+qJ5Fe0zPAoUVLW4firHrcfJSWTNCVUQOS/+n1SPXDyWRekqJ+M/Cxl3mdevBcbSOM/Kzv0VT9b7sqFumIsr+Dmkqs9uLvbC5g3sJn1MCbHrSH+MiXlGnekVl3JhO8Pftjn74vnO+duaZuJheymOnX8IQ0a1zIZZQHaq6LjMYpHUxB3Ck2NQGQOraQI317MffKFr05c19c8CfN6nO5ZSnjleCCynPaQdczx23UlPv2Wtp3++az91ap/odQ6pjb33EFFnRRG0eWc8TYEKkx5G4nAzkiHBuHpJ/gSjkhOaeaKiwBwMzojXxUNAXF+s713TiZQ9gMHQU4g1GkqgK7+jk4B1V4V0fgXedogl4RyLhZnhXDAI0RuDdrMA7sfBOJuDdwE2NUXhHFXhHgHdjqNVMhXfE8I7AUE2Bd4PhXecpK27MhUjCf4bThc6+qJDrf/Ec7AMU1dXMS/YlJBmjgrrR2CsCZXBRgGj1fBDTYN/4iaEum5wCj5pa5t+jTDURccxdQq8oU9ZUYB1nG5IUQqly8AZeFSU+uw2ZZOQ16V2qH2liHzhHPxMEMrlUMVJ7JvF9Pswuv9EEqxfJ/1m9yL/zK1I4p7PuNDk++OopCn4OAk6HMHY6hPGkDqFLl1TQy0dYCaMLZIn6wVF8oCcRAXfmQ/oqGy4Rp1vjJiLKg3Q4hACYYFZKx1QzhyKEgr4gCRlDNomLRVKFR2gOKsif0BcMuHG/rVgh7iORnUP8pGBUXzByssjv8vxpvjD6Xh6awyzLSuMlEff5KYKAjfT9N26c8Jfxjep58A8em+dBuKg+ac+DzsLFNaFnbpg5Lix0xESVO5UnE7NAlQT1eYCazPaMV7XhgPBXw9HhkMmstZcVWolhdAIHJ0enDNj7t9Rx4N69LuTb3Csvj+0cfMCpEmkLjSHPm378uBc1I1wXV/N6hPAXKuFPO5ufUkqqJd5eKRGk7jDeNZsmCfdwS+WLt419MXBfSJJ+cWfli/eNfXGX+0KS9IsN+UK4WJlAfWlKSVNzaxxwMD0ahSpWVaNFRy56CXOCRdIn4j+WejfM5K+rWX1tT95secZ0ES6ZIXhQgy05UICjBpSuNkxD8X2SvCTP+mKWGcVIw/I56mDA5hEjPcgX1CxqUw88F9X5ChpfLCO+S8uISlAh8svJUf/LN0sQsfdrMOTgpzUo+KoWu9aERDkPUpjt/L5E/HdZzwIBBsditTQEQ+3iZAESrC1i8j5foYS6lB1YE+uVq/y3dRM7Y9vE0FdAeE43y060Pc+5ki4q4c7uoVW9duoTM3bSaNxKxTYQNqjFJlgCk2EUO5NqKJ1iWuEv5TZXjva5YwUK8FlO8szyPNWWgAewz2IHcfrDX/QK+Axo2ctT9lnsREXmqz3fYp/FKVx5cWqZ8Ov2WZyGhAgJe/la0Vcuts9iFxfE1ZCkXbHyve869jT7LE53aT9wdXDO67esP9U+izM0rTiTzuSQFq0Mn30WZ9nPKeIQHhJsfeQd73r/W/42f7p9Fmcj9uN7Dn3gr/75zqfZZ3GOfi4dfft33H7wua980wfss3gCoIyUw4u/u2Xg/fPT7bPYbVP+v//woaUDH/qPH7TP4ok25dnfhX8/fbF9Fk/SFMDoycQ9qjRYm3ztJ37/P1/4x599mn0W50pBn7/9zNd/7rP/+QP2WTzFVvGKr77ju/9i62893T6L82zKJ773Q9zQMz5on8X5NuVnHsxmZ2evv9g+iz025VJp6G980D6LC1yDI+Lx9gwC22dx5sPfzkj+Sa+48OHvKJ5K2+mpGIlTebB+j8vzTTb7LJ5qsj/8HflFFNGTCZ9F/Fmkn1XSTyVFTak6IiAiCdoRKZJRiVJUIhBZdMkpF3Sh6chBjArkBp7MMNNu8zRDSJUBQ2vysQEjDA+ZwSADejKAJgNWqgAxJ6ISZDurfScBWRUAEeUMAmQ6kzOdqZkq6dtAnkEUuyBTZwZUUbn2xHyokuncVxqd80Y+L0RcvAUUBxZatr5Yztax1VYtceywE01foLH4AqYtn8YFF9TCTQa1tUlPA6U51VgdLLZzT3nsLiIJXETbJOGwSdhGkSZEMOeoiy1t1TbwN5HQtEBWGyHn3AQuelsl+ss2OqKLMHgmGksCorm+U000rWIfuUpb4Qlzq/Mg0GTGuB/ykQI6GYJvxSlv8XQQYiHzFyPhrHwvHpT3aV5d5wjRfwbD7xn9OrxZXUzPOJDPl5Xn3bJ5+UrZgXyr7acuGE1Qduv2yq4x3CaaXxMoYK3pEz8A50VkzmOGcsJv6nI3lpXgaTDk/eLC5xOAohDzX4xJq+SjDB+WJasLhH4ErxBbaSwxM4nEQ16WszKei0wuOJzojiVyZAK8KPpYm9vSWp8K4MQiAL9oAE9NXsokV6wO8GHmVnY3Peqt0fIa1y+GbllPH0oCvtqvBUeBkC4ruSh8J8QhNU+MEfYN8ynOplBPfCnMB3LluNqJqGcg/Rn0dGVAMyyUGc0icpYaiHRsSYUf2VvhebjZS1aBa1fxNJ4cut9q0gw2Gsa8ZI/mhaspVjSm4CZs5dHlh+ypEvEzsqAooJ6cdYraN8xnFMsVdGnB3JFkzNIbqvCBJm528lPlWcvP5EQxPoxCaEs/EgwqhOHJF3m4t9DKAeoqasmw8Qxcpdj5JtHhOlN4+UUwQMgIGYbxUhJV8KggToppm0QqItoksCqKpHRqHglZSAD5LQDylr6w8ephrk1dxDE3Z10NaT+7oCtlVwrTlUXtyha00jBzXQL4qRCQ2xbDRrvgSWHo/OLouxKQajtdGwu0pzBtXAALuEA6woK4oAlrxRI19E3PKUWDBWZCLSctu9nZG7ATMeqEvDmxu9jL5PoDGa0mHw0vcEtG92l64cyjwDjAzAPr/VIVXlTPwtyfSf8mjCJ4TcAF+qpJwkjr0gK1JnhULD0W6/7+mKeX4KIpPGlTJnNEeJJ5ZuZZ2Q6K5BZGNtUof4LLJyIDDkUaHMqmkIEI8w6hyHBTmsGjAwsTsNJTMzeOrBHbttk2tCSWGnBZLAYjcqHXDWpxDB77cVtYLbBKPWFZLKUsnkvtMeIM4Daju009ZozymX7i2tamGUqNZPnKot3jclEMB9LRtjlpH1oi3cjuKDoqIEgIR7/Zr4uwbPZIMbfvB2++eO0vn/A7JNelZrnMzoBmB0Oaozm+Cd/xZQwe8GRYAJqRS1IdPTTtlHI6iCSljDKGOkfWARR1w5OO3u4IarWrnz4c4HIhbG2JKDUWLYKM0uwjVj8PSOGpWITRCpcSA6uY5ZsdujMFmb7ID6be1/QVl/WaUYtfA2sgR8Mi5rAGcvSoC/azs9/Uq2hikDKPq5c3IooH6c8FrLyhu+GPju2Gj7rdsCTpbvjuyv7502NfHHNfaJJak5Iv+lIc1cyUyN4moj4s4B556u4I14ok6kGP+C0wbw/grWr6LVgXZMW9HDeevQL5sYJIRTj41cqKuqg0yuA4CQqulIkvWdVBtF6REiByYugOzN3xx6v4yQ4UPuDrw6Ef5jwWzuvlRJDkZh8P8W/dqDfSBQzkmy66NiEgaTZv2UQouZPPVaECNUkWlbmNT/D0VxoJ9Fv5T643Rvw36cIFfcNVBh2gL4wN0L1ugCRJB+j+ypAedha3HjA5jmGhxEfn+Ud/QqKm69IGxzSVEL63En4AYW3AR8pgcOgnEXSWWz94HXvOlzj96pZK+E4NQ1z5UZSg7T6qsQgedsENCd5tIu4G26c9lq5hBuodj0MegphEsC2nL8CHchbBbLlaz7sgeBkFbqhaUH1+CQXGQOPVlftBBl895UXUUkzskLSoMzV+QV+GgSKDIAFGWqJwoSOgQC9IXIGg3qD4nqoxvyxvSMqnkZIhiJsiVnH+AcQmoiWoA6hbEWpoGi5Fq17t3apXy0dleYLH5VyszkZ/De97y7mIiIabi/By7/qbrMtcAgNTnYuJ5AfA8jqo01WiHhqPWB2rl7dMmsYrRUL+GX7tvZiYzj0lZmRkBPJNNyszHieZnTInUcdNI7PqoK/SzqYMBvRR0e9RoMDIukdNY1hegKtgAgB2Z78tpLOl7W+Xk3UG7a6j3S1VB1G4pBhu4ciVyCSbERl3qwNdEuHdjb4ucM0DJErhMyA4+NXeWXphFsdvfSX8vsig3VHEeO4pGkeKzuhqKAnENseHbq0CGsCmR4bbIRlek+FgMMCaN5SDNFwpQVMO+SRcE2EguS70VOmSuaThV1SZ1UqHAv3SCUPrax7uzWS/o7eLBMj46Q7Id3csZe5t3FH6hK5tuGNGdz2YcIK1cYe7ujkYVq4MD/gOqhdM6gTp4UhX9e5W3TRezT3ix4Je3cnyGI8ubP1QTbX2QiEUCxJaxWzT028R3kJfugZ9aTCSeir2UXSxajf8s34oFHv0+Ds5zpWEBgxtcbl4drHvwklsgqXwEn7EF9YuNl7+q1Y7VRc8rd4xCso7RvH4VfrYXqWPxSg8pcDGVISXU+8YBXK2NWKuM1gfitgCcDqXH0n/YobOHhAXHBInasIkUbAnAPuCZs6QWc+Sd0sQqvRnlSXsQkjth63qBy3UzXEZYyJA/IfotWxJ3cFl+sZEwDzLZsOtSZ7AWZQW6xphdo/YE5aVh6i2iXVpCM0bVEcL7cLHb55c/6sTcgxs4C4bOMoBLG038xML1O3y5E98fd6r6cE9eFYXu2O2hPtt4EH9FLOvDstqdv2imrbJ2iOjOPsjA4j+wVf5zqMdb5sRoc0+l49sSfudp2Kb2b23+H218t7m96zyPsPvoXsXTjqyWqR6ttA/SPmcO0NFMuMtmDJOgdMF5C/mqQHHqYUvxuyoSSnOnz+O1muf9LuATIYW3tplHiC3nJjisT9f0DOMgGaU8rbxWFQ6vCRFy4a/S03Zpfu0jF07LeG3SLBN3SLb7EWJWDGiyx717HYVpjAk3wohtYyG2COw0o9FPFjMgscSLeOxTFvw2EJdiGC6tAA6SPM0hz/WQ56F2qZHgbpnV04DZWl/FrU/gTQ5MDo83ErlH0Asxf5KfGVPbQIFmMKaQi6F7DKziMeitUayhPm9ZAQxB9XuIw/eFXDgM4ehyudIB8vK6zrlvZXOxL0VbMrK5Jlpye0yuT0tuVUmt6Ylp2VyOpFMTQ2XuJP9gZrFrfOEd2pH7/fkgDUcOWD13AGrqrkpWxCQtyGCDqPpHUHiAYCO7BWxxTXUMsCNp0BNd4QbR0yeBTawUq+e1ZbutzFSVLentbxeOafHnj2g9YUNzX4XnRmk14rdAmkOPvIYbTxBG09Pdqv9GKftNiKpUHB3NByYAqoW0MrrV7IApC/2vKkLaA0UOWT0ych7kWuT2CN3Wu66Sup62bX3NuHrjT8iXxfJj40vktd44fTDaYyHHroypeQAwuTrE6fyB4h/BK4HisBqI+hxPc+4UN+z35P6YnTewDv9StPrlRqQ56py+R5OwuR7rppwXi0gGc3romEr93Fho7P/Q+Sr+bqDX4VifJ4CVczVPr3xV7TVM20Ljo+LDrZz2f58Vn1IRNTh4jDh2tTZD0XseQpBByCX/VrtMpE/h6qkvgRGe1k11btcLXVFaL6FYt2ErlCkFfZExc9dMixW9xcZV5Dx8Gwl/wBqxNGF9KHYji7y5FK9iDqxmG3tAGRBeGG6iReQd9C1WDjk7LnQEtxO3ctWSsFRJs9MSCC3NLaG+LZRh1ZoFQ3kZw/P7PcNHWeYqAe8Om05IC1FMkqbo62UoF7qQOjLbfcoe4JXQzrvB8BAt/uh1utrtR6qbRmCBWCj6NmyaJosen7zoq91RTtqiXIF+G0CUyuDgiHJFCYcAyD7+1VbZVHNF3kCxkwAGueZVLgy2oUVPFYoQz2ZcQBV19HIMLYKurpqjyRoVEINoEqDmvxN3jTHzdDh0a99HdJRrPUfGdZmE1jbBtZG1Aa2ZhVsbX+dsdX/t8XWY48OW3f5U7E1fMzYiqKnYmv4jYit4ebYqqT3Us97hRPBgyZ7bjYWEWoOCQ97Ey0wKuTodujk81NLAqSmlhQet6TfDTx/8mqwAvTmQHa9elHglqC67dUMh6oZbhrJAL1LmJFQA7Qta1oCse+aGnvn1NhbKrFH3YWuG71KxYe8yZa9rJJ+7WTygUry1ZPJV1SSr5pMfrbzm+Aid1W+OWvym9VKMk0mtyrJ2WRyrZIcjoLZibT51nZgVevc1iT7hLrpodrz257hK/QoI3IquHJoUVrKYOVeZ1M5MDaV+SPVSxVW6d3NCCdCYNZGrB/FlmkSv9SlO1aVQFevwquzqGHegJKzMxlN9bam5I1KdJMc30cQfP/4J0+9Pz1n9ulst48PXPYYbdVG1ZgHiDusgRbt7E+s1QnsRDFdGlVrajNVB25qe3HEmlo+U5Es6EkIZ3Na1kWmQ9OR2b6R/cxB2Zzq1TXYg0OtiWK4XECjWG5lApb2gtusFCHqE3OVbosfTl9OEOe1QAYigIfOsOArTylWawZwyMR1wR4x58b2gWa1nj8Vxjpv2uV0HiRp3lSriwHyISKpnPyUFlOPwdOxZOlvWN88dSBpLGVgdspyeqeavhEp7V7htlfthzI0aO+QWmSHI9UedKiuX0P3438hBRsrbJUH/FGHdfyrY5VSszJWTeL3kbEywaMXDTBu0pQxYQ7W67qyvuLm6rIeVoFePl+V8sipIwtZYE8BWCxn8QHV3b7oWEUypyNujfIf/MH/r/7OZ6wP+YwQ+wpK8lnc29UB6tfzWXP81bd2feFdpq64eQnNb0CqpatM3WpXN50QUDAQxQpcMSsbYl36zEAaS/PZ/9Y1XA//WvjJClSFUCJ3CqjOq4BusPJ6iqyYddLjmmYQZ5zvgj1Dg0Vc7p+hXNWiTvDgrMjYwupSA0ZcUnaFEnj9ifWm40hntIBitHuxXgmOs69cL++Bk2qiu77adC5AGYKxIR2qfigf3XwPLqTo+cBxhylPx4qgGRfG3B4Zw6DiaBEmQpsTgtl9exlPXYOBlE3YE0XTAB9nSWmG8SO9/vSWb/SfE5batcRkS/TyqDTbUtTzBPt7tvG29xorxqsQSIWH64GcJjggNas7/VQvbzYZHjjHxRb5OW0Prt+CNbn0gop8CbYpUnWeJk69Y+JHR8UM0LXNEPQkOGu+geRES0JwXiD38IJqm+SLaJBpklA2hC4H04Ep62lNS8wz44zgoQCemakrHLNeOkizvxQasWg6hTK2iAHwS7n9i7Czkl1q457HcSkUlJ6LNOW7ZrQK1lTtUof4sVIuiOaiOdfo4+/SnvX+qn3UTmfvevVYXszZHgd6lQ9mKTMZu3BSFx5VedmKvOyVcBfA7dIKHivkQz7GLS1934JR3YLysCw35RAEoVXoC0NprKkEy8An36pWhbfhoQo1FOyd6i0wZy2KuwKqEwIDGzhsAwdt4AHfBO61gWM2cNSnVSKAsVjLd3BdO3lEt8qdMrz0fdEu25mfQs18J+2gU/p1UUraxiEgkmr9nErbyQRP63vQu8FnijmcUEDUCKEkw1YVwnI6zSkBCbIhH6aV5Mvp1EpyFwo2DFwslQAzU1S0BI4bmmVzmps1Rw0zw6fwvOiLFSduz9yJ2oJ2cKFNbQtDCdm3PsfsUnbSVt6OQM+ybN3OE7fu6wesVNGdeIR3Gvw3g93UWvOulsrfeXmP27LDQoq6qAKQW6uqZu3kd9PKubGkHuo/hcvuUZsnQ8sA6hQAivqtSzlM2KYQNRG1CGrFc3wDdword+luYzKzC06WAb8OHqdQnWG24eWna8DPzwj2loimMKEzFEQInq5BA1XaRQu0bCBaAVcTG+am0czpz0hpCq1msVIdNAWcG7jRinnyniawcjXipcirA6f5TqVcc27WClpR8oah02oEFcq65FuQnVMk1sWMl9PjAMB3ijxPoWV5LosMXQkUcGORg4GlVbX+IW58ANprLWpx3M2BCB5uCnQ7CLpl0kLl+ESTyVHx1KxGjVQ3mPmZ+mF+FmfD+lSczbmmr1DgKPOMzioXqnPoTOLHE9xCteoWqi2bLFRAJixU5Ocki9XscRarBnlKAjuTi9UM0rCZMIvVbKWbM+ViNUtkFqsZt1gRzT4XaTqa5xCVi9UTxherjFJZgAh/x1+sXN5pi9UWWtWMujrleblo8YEgYxJwTlev3EVMLmEEisbtH1nCZiaXsKWRJezc0SVsly5hq7KEFV/XJWyJCgB38ZtL2P/lS9iiW8IW/02WsEKXsAJLWCFLGCY/lrCZjWI37Z5Yws6hDuD3BDwqS9g3lzBHf9xaNpF08osaYVEjMsKOWQ4GCAq5zpu6AT7uvmnzJcmtRTO6FnUoIlmZYl2Z/o/fQp2iWyh+rNA5eDDC4nHK47Gh2smBnVM3VCty4SCnnl2juoiwV21O0TWMckRMrlE9PBgP8Djlm5uur8eK9c0V65ubrnPw2ElPwGPHv8v1ay+qkQUKjTIka6d5NdXrS4lB+uJI2Y4ydyWnI2xa97TVbSeeoAHy3HH8LRyCRvMyPRKFnnHsO37u51zrJX0Jw/lUaaS5xi+qepf78g5TOYmevAagjWqmGiHYthelPLV6H4gV6cSoH4eEZD6auKdSVhGgNCJ5dI2xQra2ocJNe4am2i+i2asqc0V8pKiPq/7ClLQ/GMACUJ0vwvhyBIWyvFIZOI95LYCk1+O/p5fRNmcvj91dHL/luay4WuFUiGApZzSjVF2x0XOE60dkPOp5Ed0hhufzjW/qEtgBgPzHI0BGHBXSLdF0S6sQUdgZiAQnDZHaSUOk9vWBiDu3nAROuhOiha+J68B7kKWA7x09Q/uSNXGdfjurVrv7Z4J3am0v9wy26vUwHPQHVhnd6gXqsXj1IPz6IPDh67piYDTUBupBXqSaXmepJvUuivpf2w4FtdZL9ZACTVEPPx7bSgngO9xxlDGMtntwx1OyTaFxSJH9uZzP1mWU6lf2kJc8UX6zOi4htFV9Ymt+r0bWRK2sJmiVmtgPUFwmxe3vD4IXUpj9DM5SpNGYefxQk6xSrdqp9znXLxvbPpFgkSqt+ugDwFR4pGFAMtZLgzis4deifmXBKBEQms0BjjUf6KGWflLWqgf62pZMmpq9EzWja6VB5zj9qTDUIfCsKvOxoLzbAzVFB9CInP2piUAt+4D6oOgfLJx6cB3qwQVrB3NPxNxrpKfeFSNd5jYeZ5MFRyhaf5fThg6gDc23YTZRoJZLNQjcYgN3cgDHYNdSAO3oGz21j/2ged6tycFRPKva0Ru2gGM2cK/55AE8DzrtaAxJqblup9kVONEnZAzVCncdmoroComTBfHXRb4S8xV+E2UCcToBqQwKDfqd8oZNxqGPBqWbr7uDyjiADmEm8Dwoas6uFGB1d7CmdYaK4yDZFIGIYfiqfnORzemzOj3XgBHA+cEZLERwspVdt915XDoYOJ0Dz+kceFbnoKpakIC/Uj+MlFqv1CnoQSr6OrrONqrOXsWyZyzreIzTYjV96Kv9QKijG2dwotfbZiBz3c5y8gx2FNSStqhLtSJVM0tpKUBtrUkGTbax6MiM2qJtS3Ke4CzxAV/2jx0O3qvBDI2rQZlZiMKcblXmpZn5ghKuRQXMEsUyG/EQd+MthGRAEwm1QBfUeD2/p7o7onJ/hL7w+xzxX2nCJsX95VRN2Fh/73PMmKkiurkuHk+ZLivGGgCetSnpvXyVeOsFdS2UmcBiTZcHSpjkJbUfRk1rsaZO9VI4wI0a4yJTWuYvrfrvormxgybrrXKuCs8s3zrNYs022kqrUJTfTtunWKyh6RZrclgQKKZYrNmBhO1TLNbsNJZDtk+xWHOKS5uwWHOqphWnYVeCoict1uyyn8MYhjwkOGmx5nTETlisOeN4FmvO3NRizVmbWqw5e1OLNec42yVPIO6Ra7A2edJize7pFmueuKnFmidtarHmyZtarDl3U4s1T3ENPo2KKRZrzmMLKiswv3I+W1bZTj3ajpEo6LzpFmv2aHYYXNnO3X8C4bPT+LPT9LNKekGKmqiasxIgJWi3Sjs00qAUJ55Shiy6bKWtHOJMFjkUf/CQ/07nPzfwZIaZzjJPM4RUGTC0ZqsrRP/bPcW8DRlAkwErVYDIHaISZFTt+6qArAqA07i6bYRM53Gm8zRTJX1FloIFMVtIC8waj1usMTQ1bypBzWHory7O4hcoAaFPaYtYrElHLdPUNH2BxuLr2GtfACUayvIaddTvL10g0mGhMff6RQ/2aArGZglspxVJeMAkrNBpmnBaanhbrWmLNkO2mD3TOH07j3wh2QVNlnyeKVIDp7nbbqlwfLZUYlQzl30Q3yKOKmilEtVF1GnA3TJqJ6JWqBgTwW2B8GULzVl937Yxf5MKv6oqWyymvLBcKZ6KhLPyJTxI7I9cxL25CEZvMnoqXXQg96W6fFEaki9LE/Mt0oO8g3UGi4EzcqOr0JKYjtH+5QvUJn5cYC1T5HCjVlMpAcSusnhcAPOlEGHF8OAM2PJ87ThB1tiago8yhtwWGkvMTCLRApXlLI/nIpNrNxexOJbIkbiFLpdqajQrrW2SekIDeBMDXurCyE1dMVn6Mg9LE2LkJlvjyim1Fm5qRjjVrFq42W4s3NSIQ4LBTQxi07iHMRZuurBwg4eP8U0RdRHSL6ILlXlrkWcMLTT0ilNSpHLWWyp49Q+WbFzD2Vm1848a6kteGa3+j8PSqqYYU6uxTXmtM5rK36rBVMDRKqb+TeBDk8qJNepWnVk1x2D4Qp3Lqz10vXr0UbAyaRnRktj9/dYLi0Q3Yg1KqME8z33ugjVSWgc4CewRDFXD71AT7J4H0brHCA/nVXK/+gf34z6U40Rbai4TnKCvOpkeJdK8QpjsQXl96YMDcP9GpTT7rN7ITqmOSjb/wB/5gFpHxIt3/5W4HdcQRcTsDoFctfFoevqc0jlQ3oCmnihm5mnV77aX+zJnfIdZISXcFGNOBqA1dQU2BRdurcHABkhQA0hUdxIAb6NoVcwN2/Bd7Am5NRxSeOtQ7h5vVDwkBywm+O+suo5hw2boLkx+1YNX8/u6v+AfCuUCWWQssnCC2A7nB9pm7cOoU+Nh9c491bJbZZd6XWjNTihPzl9nPyp2kwMOvVlCXkUU0TIX6sCmokk6VNEQEEEoHh6RasUnOCfHw0GlGcqnVkUTPxJ5ibuY5vY72FJ+z2YeCvRm9vpDAcDA+7/v5Ah+PE8fl1uRRamcHVig78W+B7eZcSikqp2w5ILvyixSsCrQXtpD2XG5fb0YriJESrBH7mtC0NKQevKm7i7ECHG2pqtn4TaTIqtqmmv2UA7nWvJA3ZKgRHP+lSAZo9yiuj054sa0ucltXlkSFTkmxMlQxdRzMNgMKJViiyZ5chBWQzflIMwjiXvec9Hnhui1Zv8LdEEvS3oM6JSSnPurIGsqAcbu0e5/nOwU3ePPMUgSdCla8P1VFd2saEqSKukip/rIZFBgZ6YR1BRNXcAbToTUHwNFvEjiDuuLiqaaLGpmf4c2mwbjWzRZi9BzzoRsNbUpusAVFBEIVUYYtLq8tXhT6MMq1KQ9KDJ2n2NSs1N1jJNxLMnhEK7ZQjMSDYBf9tB/pd4pvZYP2DdKv4bVZB6hxohJ64Yzad2YNGnt0iUVg4UGyBJl/9MWJQK5ajPUNH9IHA/UD1Nci3aNqmTWCeJxlO90sCX5r5EM1fbs8wgxKwqf4Gg+DFofrQH3Ioh+9mxmHCvYRRHh2TXPBNfzZSY01uQWLT+zz0np1ADQG/09IrY6F9m4Qs2D0R211s25X4bc1+ryzbPfV4RLXK+rXQYA9FNnNLtqtMmvpf9yVquukrtr64wYQI7mqFpzkMtt5lf7otcc6KfwGMi2j+TKfKwyEx0TioF2eaN6BaSOWyFmFFsq5ZmmBu0ZXXH3aRu94w/lOL8NFGMfXCJGe7We48+gZTdquCOWcDsv2Z9niH2Vr0f2CN+g4TnNrYf2thRSJrPNB/hgVOUCWyNfRotMm9SDhiVidc7cEvuPRZf5ZUPDYshTmYatII3b2TbEa9n0CmWsGNrl0TItgXZpnD3E58uAz0UaV4JtiFSxlsdubsCVoNDGJfxVDt+1h9ppnNeP5cYyouTAfTJHsyZjLHY3uYCiJ9sPfX2VvjpTAjFAHNMSuFhuqT2Sr2OHsYJiLQogqnIkL+Soq/CRI3lPj+S96pF8ME2OhCP5V4MXQWhQhg6XoYNl6IEbbejeMnSsDPGQ26P5fE0sS+6oHs3v6PuyTu3AmW6+gwpz2nyKPW2uu9PmujuaN163DBpR3RlDPMVuHnojx82Ke1R3Qq/eyHlzrCYHM9kWqMlBtAWH8/WyQfXNGoT7Rh6wBXsXyCtP3KD5E7ZFzT7WtS0MJ2QvD+d36OF8wQm2dTtO3LqvJ7hSMwUox7GqmRVmyOum5jzWktXK7SnYflt4qUwR8Bs5h9/B76ap82NJp6ANO7n0U6iTJzRjwLWzPKKv2yN6bAEx7bHar2xAOjtxRJ9RF1AMcAh/g5+frqEb9TxecM3BRA/k0SV0t25O5R1waRct0hYD2BGVh4zh6Y7lTaFSSJGMjJ6Czw3haAtA9U9TgLla8VZYouHap7lPpZ7m36w5YsTOIJvWJqjhqtTilUhpyS7SkarxUu2p+xY8xUB7YilYykOiBjuVmHlQlMYiU1GU9kRR2hNFaW9MUToVXnkoNrYcmW+b9arJyaoojacqSqNwVZRWqOsa5tazDnlQlV4W9bQOj4aqSvPjCaPrGB6rlSVs3hSoyxnQa2Q5mz3Octa0y1k2uZx1zXLWLDWlXT+75XI2Wy5n3epy5jSl63SOViG2SJ5A/Egq69oytaeva9Jnt6Qho1vSGDnolEruVZrTjHZBy3tmceNPq7qHCfVcRGVtS/BI7BI3O7LEdSeXuJWRJe7c0SVuly5xqydc4h54Vbl0laFjZeiohk5qKVz5Oi5x3I6To9nckG8ucV9HcKU6JewS51Y3rTSPtdB/i9VtVle37mYq0xkA+AQ8dpZLmy5yL3NLnDbfLXFK/d0Sp/18FEvcDdOWODd6rvLJ1Q0VTl/d0LTHvLqZKifp1E63+k1NHyl/QrtsdL1zOtTGQLUQcneJ+DibLl2tpu+43DKV6TJ1DgW6Wv3fsgODGnWs+tOJ0Z9+fHZkOzmwc+qO7BS7gFFs9A3HtmaUuHhFyGnrmCpRf113bN/csX1zx/bNHds5eECbuotOfHP/pvrVqA0DgWXIVYs3i0NVjerxfZ3LuHMy48ReD7Vvol19/H0fgpty5jeUJKoMHStDDFxZnrBbLBb6yXOFMs2PXUUKGGcTAUUdHkMqzIgCNeGHej6I8WjDt4B6PsBhXwW0HFATMIilBcxoqGpilyNTe54WMLUDmgdl1xrLEtXpgbU0Y8zILJjeU3oBijHN4vmQjLUSIl1ugZR2ZZFAZbSNCC3StVL7kOtpipwfUEQL4Af4ffZ65/HCKuem6W96nn+tmgDKvnCjqor61miLan8Eo9ofvrhUh74qhL3H/un6QzUAMPsbfE2eO8eEKr36/hX4hGL8ayOP1D9O9Vs3q52JEHW3msdaWYBWiPrdcErpxH47vKrysXN94FnfM33q/9KNB8W6/huuF7m/xmf/oKcAFQf1PwLPBhN+FCwzpMANrCtKHHVHjAw2KSGNCy8zcRG/HujDdTmOva/mtzXjf1Jd1FfdT7ZEufuTP/+Jn+cTbl8MX3ovUW/axOew/U8ghSP58Ykam6pUl43Zx8RCsXitCU62ztDUmYjafkXxkpVCvf5LXsgFqL8C+S6ioPSVKdWoP9nkfPMV1MZFQ9KZ9PRQtjxCPCQt+z20dEVPRCNR50Qa6rKaBM7NRCfNfkf9Xr7GY8umwbUT5kV9OSEWjQF1ss3YVdEbV5VxirGO4VTN+tuPslvA5YHnw5lyBtV+BLrDI+iYUyBPR9zwB+mTPO+V5J2unvzFQo/ATTrv85uFlle6dk1f61m38p45prnc2CRmKgEkZqLiYXZg5WBYIjHeoGhd1M9FcdQq4ks35WQw0H7IlIiuLAJYeA0Jfs/XgEu9IjR2Cn39nruRvqd03m4001WLPzDvQBQxb+fZKyjwr8jlRsAPQ1zg6sbTwcPEMybV9MHDhbLVL4xWgJJiPbImvXwi0cCT0FSfUiSub0L5SkDuSkUWLji90Rsxs+f8VRi/kaExAqvTz1ox3CkNwIso9MojxEEaEDTBg9uqqIp50cISWWetGaBG3/sBQC1wWhZhenMcwrEptKgdoYlNcgy9mF39Pdmbjbr8p39f71qohe+Q6puovXeNAe9dVEcRmRoI24mHqI6TVY2IxE4tjGNTAxoZ0GSJ+qw7fsU1UJ22xuIoRK6IIYmQ8QgbuXPqSO15q6q3llzXslfx0wXC2EqyNwMWEp1rllxuWsgtiFUJEYfQBR5ZTxjWmj0/pTqqlLuzelZPRYrhQS+ABk43Wjc9WLp2USO7HXUWESFz0aQIGm/YLmorpKAcygP8ylVIPdlP4ZuVcnltiN6R61MRoY5y90WRdmxaV1IE1XZ/mZyVyS0FMnDNalYAb+rZW9Q2BOqtSw5Z2c2QaFQid0PKTzhP+VWIrxT5Lah8GDhVmBehdqKuSuTP1REDHQCoqYH2AD7Gvz6QpwE4wONVZAvlJkjtCMpMxMDLLbAMl8fwaMGsNu5IZQpINLsyIcVZDbcKUzN2a+WzmbzpTPft1QElgRLWI3BXAkfh/pQsChb9fEcsfzmMQOdxEh7ZCX84Lme8uSfkX1aVlYQaO+EFGYwIsLYPwOItuRVTOro1Z324V8jgwR6gvZ5gmBHVNSrkzo+ziM3Jh//ZJA+HhfPuTsm+//T3D354+4t+WjxNli9X9taLCDFD56jijgHHDd0ORpKP3DF0rKZB0KB/KF6DEbmPfInrzL6i1yX4/CIWHQzyqx4uumfvYxX4Rmm1+3l7141SVehcGHKBUPBqqEMwkHz1zCUgsjwxGM02tWVNgfBJOjtwreNCZBVgf0xf8nAnoAV8ayniOuBXyxNj8wk6SgkuroyVxEQArcASs456GpwAvNU7Bv1dkgnuWeIxo3cBY4UiIBZY2O1krFFVsRfcOsTjiiOCj8rQQGhhnVT3QffhkvuVa1jr4bIlF2wd5GE5NOqHJReWgTwon/G9QK+0hu5bNbMAsrBALbGnv1pZpY7WRqzBulsx7VqpwOmTJ+pNqr8pp079T70OHCrijfamxxRIk+5HkupvysJYlll+f+6aZkeqcZrvS7TqeqKTpRFSr6KC8nEvUBW9aUusr3w4tCADZeLswsmQkTY8/2Mf61OQvVrodkhhGXlVr3AgJRe8qseywih7DT6QtTvqf/DGp0HjMyT/KutiL+Lo+KVrGLQyr83pSU5Dm0K0TZnPyoKd3l8P6kJJqLZRQM+zasvSijUxotzI3dEP33fO184888rqpSfX9KDSdCEu7o4m+OKQR7XSTwrWcd90iJuktixywat67FjHtYXidYVwEdssR4fqPxBsK5ez78ny7+9xOZQCp+nJ9dxxK9WHUo2W9v3IcYejTiGsMFLC2GuKHLp21vkqaZQC+gCEqlZyRzhCnQcQnNpXi8p5WRWC4hXeJhB9/CEJORZDMnGQTEYgmVYgWbeQrE9AEshbPwEkEyb7I5BsMCwBv5TqU+CXOPgBbuTlTM6wW2uSBR80w1JO8FLdHELJGaRoFKq4M8GsPdWY5hm4fhOu0CgVyBZ+D5SX3zkgEPQu04kPbla4hg3P9xxTThXqpW6bvA2QpQpUjWghdOStpE73fhBLXqZ7i6S8wNmS0Kpe/gV5fa0QJJ+CcnvoaKFPfpUG+q5vfmWY3vxQkF63yb7G68PwPD/YK1YR9uAHo391n/Ggd03haWt8m+V6zuK5LF7vGjRcPAa+VYzQ6tYGYoLXodFVGvnjgJw/DXLqgEkBqMBwIFgoL7NmUnj2ekOdA7Dopo/3vpqbS2H5clXPoEzoYCYEfwOMUmVw7him59SMQOqQrCnYMUifyD/dl023/wx99DFI6XkMRXyQ3SRY6mf/qCarlcEUeBpHiOjXGpQwcQX+P3u+bsz/PyZ0EmgyZun2/yXIAgzrpIhgXf0CEiezuwu0NSLZQCsaa7L2sLzin1BzLe3U+kPImrKv6XI7x4VlHxUgJ9lbBPT/y/eiSRmTdOOf3U2JmrRMBU7SlREt3sBp8QaTWrwuXVIxaU66ePSqs5b9C7LaPX0te0hfoQQeyH6ir1r6gWw5sZ+LsJ8jsFRCtwLNLNt+6O6q00u9Ko+4QNRr8QixcRH/VAClh+/gOUBuvHOz3odmUaTOyZA9D/ip+xOnV+s7zP6vGFw0QRrgax8CqZN8mfcPS2dMdzxBMfcq3A12VdVtDHBBEC9NL+Di+12DDn7/rXaz7+tm38es+JpioRNnBJBl7MV+CW4lMRRfRRaQN+20DIRk9pXVsjiGlEQakaQvMGhL6A0e+EigGSo8wQiBpZY+IILjEWZwSRNlBy6wVZYO2aRto/Wk38ot7Wemj9ykihxPa0IBCAF7dG+sSERBZecXpn8WhI3rYmHFnNzEK+0SgJmWohS2/Hbw81aMYloVIIpRUN1TSga9rxLqpWvh1iE/433BP2CbJudVuqGDS5Pcan83JNOZweEbmTDmTeLgLa9H0AjOW1THoy3CvWAXedWLGQQ5/jCHq5PmbcO8UzU17+GOTh7yM3PRqQvqnqtD2UbRHoJf9WiGEKqhtCFqxF7A4wfxXf7rjSSduEUeAhm1j1DAH69fgHbgk1nE78pTzdCl2SPUXi/aLIXCKMpFHX7RbQ+cV+iuLaRmhbtoiu+aIus/DRPJ3TLyoOH+5zWJ9GVTZqULZlPmOcsTtXSRf9wUqGV/IjNw67TYfteQv6d43oTjDHVa0XI+K27QQ3s3q8/mr+yuTlBbpb5kbhxgFjOXZapIWzVyFb7TD8Wtl1vuZI+WM/VW72nPuP3z1x+9+7VfefNXeehLv5u6w1OeQwXdKio3O2d7oA08Vkmq3ukSB65U5ydw8mtGdDAAVj5UvkRH8P4l877urqEVeqFNr85BIuPOO3RMQg5gLOvyhJ8AujT3raMxX0YI1B+t5EGtti0oizZGSFAJB5KxKiBbTu8OQpHHOKAd891ahV1ABZlCI273BZPFnopAwasCICTPdVlvcqnxE3OUQ2P8bwR6pSyYUtU3KK8hkf0NOS2T+2Ou4gIdpJCvKduiN7ToWNjF6nFTGTBnQfsLBplIeorgSBGuG5+J4XC4bphG7iZ5kKnXtLcqedavtb8Qm4k38PqUajwnRyqSI0WwLrd0IgoqNWBtRcUsMIHkDCe6Y0A6IYfl8zg5FitiluoXgf7+Y0b/UNE/EfRHSJyv6izQcc2T0dkQlLMhwSsT706J/TWgPcWVQ7+iIYgnxoObx8N8expbV8xXwe8Y5jemYT6KNpiPSjjQmIb5uw1PqZdVvTUwVFjpPb5+00M09wqbtqCXvVPoy32+F1QoWuj4OfAb2U2vnsJ0qRQ2GuHpIsfTRZM8nUtHqvJ0j6QK3JPsrEn2NyK74hWsI/2wvCq7Rr7j7SJc8v0AvnZsXaT5gpKtgxYXsNiwdZGydRHqV9ZjClvnc6t+XcoNzCGFGIriJ/mjbF3oFoCf8UOYXsMZzGNCY2CtIDICsjs8YvD5+LgcT8dlIBZOpsFqKXUNpxNuNTgTnxT6hpsQ7rAk3CHQN5yGvvd6fviYVzo5WhuHAOdXIbn2NAbLPq2nqBWEK9Qe6vXcsR5G03qIIk0PUTgHomk9fKvnhRUOP1RMjuyuQg0nqGNmCNJCdN03WxXE8R5Pb3P6mMsxQpEQ+yD7EZkKdqNT7gwCvAKdwebK1fHqzkDZYD1wcfuEfeChj9UsE90/avmhUDcK8GuJFmijsx81UgXlbAHriS3D4Vf/O9gyfCIK2sKsuQ1D4AgqzsFDrdzXcZYe40zcOGvGXO4vrAkam5iYY8hdJq7BU79JqnPSWZK0k+rmQNIkQZCyR8vpbztgIhsiByEvexjkC9uIfuZeU34NtSJoyPn97cR/l/U0WRh6nHqqN+O3O69seqgoNjxmSpIfIeeM2tDXz5BTDk06zA9sojqD2YizIs5TJhMyHxnJo5MwUxtZHgXqYBce2ETAcxbcarvvsyNWn0ANjv2kzhJ8Ah9KcAXMYTh59KQgR78sByBV0hwymAn9oKe2rxy0xPQFyplDD/M5cFluG5UFcgmbPFjpQK5Z8nj4D9DMWj9mmHiwq7DnmjXKyo4OaE71PMbsFWQVJhOLUVXno40sbZpB1IxR2wZ4ABnAxVjkCyg18kAX01ShWFbGTGyUjo5vlLZNiwXR0I3L7uk7JSzj2CxlPz6+SbrDapyw2S8FqIeZeFHV850mn1VJ3j2ZTJXknZPJC5Xk7mRyUkluVZNTjq307xOeF11rFGcq/Dg0cXzlL6vOiqtndC42Vo/JgveVcVUdh1qJC8KWg8rHQ37I+X9lrzEcHqH6ehEO8ljYEQomMsinyJXHFIE7N2tnjKPNPHb+kNP0XZ4XXquOyTIQKidf1uOqsk97RyeugQTnMIcsoKP8GOIskl/cZ0WE9lR2YJJdMw95a6HGabBDcDm42dwLpAn1JG76bSYigSj9K14M47ZqryMCB1yDVVRWorti1Jci+h3w4/7a2siYQGHZveohOwwiQMZbJBVLK8n6sJDzLVFoashZs9QjDq/z5phtyTrVByLGSSnMWwzwNhfdopYyY+0NY3WH4rUNLjghLVDkK2hqi9rYR7UpVR+uYOSexbFNHrTWM2XA/psukjUCEeizNpNFP3TaqZKEolEVyYZTk6DHJjROFfrVCAJ0OrSoFGX1vfRv/JNXKkQdE0qFRcixTqmQazuBGiEq8K0aof+DFTXCr/E/jyMf5GfdqRHe8WqnRuhqeUSKg/sff5XBwaunqQwC2NmRV0+qDA4RV0v/Z9UdudMHfcbbfvpPH775K/d+9amYl75R9tsYFrw6dZ2sQUJq3dGRD77iwtIymfMC2zB7APJbLGfuRMN7fDVibgXWTPQDeGqRsyuwKII12fYp36A2UULNYvhnK7bCemxDRtkqpAj5hf+9tJetI7K/y7BxXv9BuzZ5yrR6pCcyGUKn+63z/QWEWAgJ4WSlYYHMAUDU9jQwPTVHNyovb1H18EEKV8Ger+dONbd2VCCdPh9w3sR+j04qYahCYI4xFuplP6cdBlvt8EgqsTO48CqnO7r8krY++/nKDtuMqdq88qzMkT/oKx2xrLnVuvJVBW/snMWHMRGfDN+hleL06MHrK6dH78ujRFweNl6uOI0eiL3dgwtiECS2WNFnX46DW9lMuMgG+rILuVneOeZCkyTi9tsRTPWLu8a+eKv74i73xdsQxA520FSR48FY7pMl2NRGEmyY9Q5Qr0r1ZbEJxAi/ubYdI/bgXF8aR022PreGEufWsrchHeikuJkzjDbylm6cRfugCQTOfgGJ03hfag2Gaowt4fzWjlUGAFtFMUrBr7b54akBuBn+63DR0gJKlVMvMmFi8ZHWTh2jMlV4pYVwcBTIgbIuwcVzcY3d5wAOKMLq8UGtFaRwR+6n4/Fe2heQUz37sva+D9thiEJA0oqmcN7N7G3oOMoRC3xluvAh4lTdl5m9Xh7V2wBDDlzz0OrDu015WjHqmuqWTCrWwZlBFsACGx1TR1O5eWCgh2QFdsXqFsWUnecfzGgGKTOAbMkSd1BZp58ZA91AlrK2fBYHMRte7ulgKOS5FqwjGCGUQ+FaOev32qfmpFCvGv29Xo6B5KhAI3Ud5jEPMOZzmJ8jZL1Wvv+nvd/fK+ZVCUmLbANxF7gc7vQdDy+Ig+U7Hi68fNG24ujF9kkhqi+WuAGw4qs95/nCfZbNS2eKFnBXzB52pljP3YJOOG7K40JCo4PTcfZ7ffJRKW2hZZoBv3dg/68yAjy8gDs6X/K4lL/xaAvn96/pmVtD4AdE17vCY3lW7a4FYFHGxXNtoUyOjOp5h0KOR39m1miBR+CFb37G5Z9qf+Zi+6RF7nWxSEu0NGnqd6qhX5hRXJ4084voLaWR3w/ap145IqSoad/326dLMYZ932ufmlKgSQKJluXC7RMZJgAvhdEWTsND/ytN+77fPvHphBVg/nSqqd/NDP1uZuZ3MyO/ztjrCgA90chxE79TDfxuZt53M+O+m5n23cywr8Yr4JenmPXtPfztU+bBFlitXWWDtFupS1thkHaZelMN/aIAQnbJvEQrhM9gtHRJP6ukbxEkk2tzB5sKLJRdbJGow01nnlnvRx5sAbtpkTTDQL7R7+9qaq9s5jbmC8sKjAxjnubwd2lR7xWZqpzO5p3R6TsjvMCMCvb5ed0az0ox7RdiUuPQtuuIXC0EVL4os7enbTPRev98jMDJUTBucC9peWauhjyp8U3OpZSFFL6Uviwd8XHJUgmuI6DoNyqfJKTUkcW4M0o+rLgk06bUYf8d7VAKaC3Mapvsm7ZRe9W68fM/+tbF9GORfU6pGCv2RuFhjdgr+uqsaC23Z7xqW7Ifqbh93rV3OHDeplnxNMQZThMgmJELaSw4oqZIj2bX+nu5W4EOUO7LmM5choGiOTE4utmgTWLzox9EN3bN6tgZ1mXLaAkPePkW6MptmQQWHOcZfOg+CnzoPiJ8ANwEMsWMEZbNQ0o7A6MEs5yAu86+cFmqFjTDe9tJumta08GCq/UKGBwYiWczZiA3h1ufgeWQjoUMl9De000dY+I8E6SW5zHcR2JhvYAqEsFInzHSsD+6QZ11fMk8Bfk2Pgvx+j5t48ndE9GkwC9GReCB0UVP8MeHFewXK/wdXoJjgtsuC4wmWo68KhxVqCo3xY02wMV6j0Zfo1wqNXIfmiYEOKPWYE3bgOY3a9yL63jVfoA/qo63D6cXkhuvgI3C00Q19XXZjq6PHOAnDLugqOAKKtfRO/v2WSwhr43+kH0WiyC/XdAXDpC8LY1WA6Ltqsmq1VBXKDW+RmDz9jX7V4P/VKxUVi/rHz7Geyg18FzCIhWjn0wAQuCCrS/vlD0UKIdUz5vTVqh8OdiLeYz73NyrjpvI6J2vr7KfSZxNaqCqMsgyrWZGPsqXx+aSToFMpwAtA+Md59S3z2rkh+xTQK2A1FkjMAIQneVtXGxLS72RDJMh092R7INemWfSAiQq55r2D98LOELe1sZmQfyA+JTlneNAKDQQalZ6irYop9p1fcdAC8qTbiBI56iPOTqjkjpxTjbDABkHh2O73Yp8yBMpHyYSupnZXuaZWZ+0s7KeH43yZZ08WomZQo5Y4kDJuaZb1lwVYoRq0ZNRmuhbaErZQK5Z2TZ1yhs5PmF0jjPpqQN86Sii575dWuckbVZgNkvz8pynbbjKso0WALQF468MYtssb7l9baJkdU0Jv5Oc655CmxXLMrKbPLnfpRuM4CUv5nZiece6CbKlWxBzknsHtQZ5q7qlgxSjBdGzGrU1hx6fntQOmxLb33NC7bBdTjvsZ8cPPi70/FHtMHsAoXJCTdBUY4W8qirmai9UGxiFgovLroc4AL1laKhQbETIkzxSIY+Ps9JLUQlOoWGqhLspqseY9Txyhx9guGAIb0FgwOJjwk3gqYm3pX+cpD4k9vyH+6n2GbjTf3eBTkWzGERtfUXzJpJtcK2yDUaToKutEn3d37I9orqYVPBEoTKZJn4LM8RP7GabmCXw6eBY4ha/tlEMte1udoZmlIbiyiLM02M321ofyna2aGIv26R2dS+b9n25jVZhRluWN9e9bAOom/ZDwfQGxXlCqWCquSnX4tCP2hs3cCuQN+VJmIL7yv1t7Y71IoP1oEExS4E6aaXWkaKFl2x4ZFjMyREnHJl5pdgFIIuIv+MewK8F/wxpVl+aeBkM85YeJAHFcEoxeoDCXUOxqeZo4cbrcEhzR/j7Vj5HorVaPfSSo46irdIVOf966Oe++IfP+b7L9fzLjfGxi/mcqIICVd3V1mgb/EoVVKvCuphbdykZVSzRrx9hkFzgFExwCDS3PuQGzuUtc1SmjRQT9lRDwVf21DwxznZOlqOHzwZKhfV0Hajvs/uIvKV+9MTPep5U4l3uucqHukVjFwNw9mG/kzFIcQyFlg0GskXo5XXT1hm9xcBjjZEpolv3hd/xP3/hL573yR+4qq3DZJpRLxMwkVruDVkqby1C5TDZPCMzJBWnWy5DBSMU1ckzjipxRz+p8uK+tF3wVvSQfRURttYrY+MOLikAb1Cl3Q9O0u4psf1dhnruKHV0s8KeZOLOiOek+CC37gMcvI3qgFfOQLNfUdKtp2NefxAcWJPlGSr870YaNBc4WvwS4qmXAowKDT/T7/Oh9YgmKekLrHZFeb4cIiQ/iajiqMe1PLIZKDKuB6CRpMpO9jqp0PT0vDG9ZLUB8f4TrTr/4Hshuv4uaFaLyS8VACPfu7w8lih7U39S5lxXmbNYt5JTxxgEnDcxgmgiaY7HJc04TFFb1Lz0mNp8wl1jad1RrxD1F6oZQXPdONHRC6/WBYwqvPnThMxJKWSugbGpWaXkOlK4YgGY9bsYyENPyboF6lJLZ6r4ogDQKo39lwQ/cXm2G8q4UG00Fm11FRul9rqYrZPR6luLHH/8Y/8YYoH/VT0yJP2UvGwDEUXFtgUeBvuweH/N5yIEPd8jOfVwiX/wrqZl0CPoRdREVYh/yiS9ortrNO+55/nnIsSb2D28g92jsc9GG56t4UvO8y8pDwjJHzlK9E6vfdf5te+SUHD5+cHlXMu9NVTDv67iLyAKvy7qQUTh10Xd6HEUfl0DoRXtXcB/nHwLkvGb/Zr94k5E4Tf7s+tN1LsQhV8XdVSijlajjiEKv/0NkfBTTcz/evh1DRLrv/gtoyaOyIqaG1DHsemIGZbtv4DMKH0x1MaezvqCZqrOCtjiHBsqYHfZuRjqSa5A3h1q48WOACzDjJVu3an4WokHRhSGgbL3KlnQNgunCJJz9w1VdeH3IU+aPhNtVrXr0m6LCA08haEcArZEks8P60GUIokraeC3eEFJndyxJGj/vdfqqZGv7iPzwMZBU6B6Jqk32H5fOXJDvn7R86Ep4nQwI+O+AmWHqnbp4+GrR9MEKjNYXJGYiNNjaS9SE0q+TzU3M9XKFL1SCrMPV3Uxw1IXM5RXUROALiY/qrqYeClCikd1MZ/JQ1QaaIn6d/+9WcAiPdWOoMSnTZXWZx9B1XJiHW12f+vX/z0oY34srDrQqWq229YijFJi1WGIjdtkV4oCLyPj9FodpUF18+pr8NEC7unACkdwoFTJDI3rl8zoTSYcI9oAqjmrOIfDd13UG7qHNQt7oqsHPs/12FczG4MTZs1IhoW/6UluKkoVdlUNRHQ95Th3+iILe0aUVldYoK7iZaAqlJWDXIkXhSq9ywZAbLq+RuX6GmB9Dewyl5oLWoLzlv+KjChzgTtjvH9QA7kFQEFZlRaXSHGUIkPpxwm7p8QZ5bBQV2YzlJ7iijC8LFcdFWuKjenTqBKkm3yOp5wSy7P1xDqQ0LW8e1wUsKdUgexW1BBXJ7UUw8IZ7JoQBPxGEMCdcnnX4N5GVW9LkQoK8zL3s0NCQmX8ffA19zRwD6e+BvMrEC2j8qj6ljnfyD58I19B/hSRWsDswNXkE54HPQ1gJUYd/lXk45LEAdWnudfT512aGtyJZ9Uz8sB+v2EDd5tP7sHzfs95RhYK1tKGJaIOdU9jTUhbFds3As3xLn5qb7l2xIGWMgL0VUn7rmBt3+xfn339rT95zdOME/xQM1kIueMbBZN+lH0ceVWp4Wg0qJoT4YLZfgHSarxnVHAaJ8gpVrGGw7hrfchHJlTv+npFnBVgjnIfjGOnrownqMOGX1G2ZMMGcsfTxiR7YcjAFxbwx1CpEuX2t+VBVR2NgvSGkSv2B+dGr3r/oa4xqO+Yb65yuEL11UNqln0cWbVhWAqs0YW/YEuJn3ClbEgpXE/ZAgrX0w96nrWPkxT+wOgZ8hTfKMxVM4z3kcIp2pJfMQdxxO3EN8tiWlkWHk4W7rkvvemFb5ZlmH6vIwDk/GVF5F9YW+aHB+W9iAIsLrpyqgGE9+EWj/hp5p9l4/gpAmG6V6AZOW2yuZL5ojB7CKnp+33Pn1z4nAss1ecLrYW5fiiUgKEw4ipVFyxs/pHrXt/6wl9VB+9dCFbRCzByos4jbfaFovJPFz/L3ODXoMHC9+iVLqbq+Mn2Mwl5oWJtpMuhVauU7Fl5md0f0UB07fFcezxtTw3tqZ1EY3SLj5KsrDPcBKI/cghRv+758HMl4FKsVqLpO2lTYOlyaHaDlQsAumTp5SG4RRR+E+3HYiXaKUHpzX1YNaKSTl7FRLvWoTE9XNd5U1aiFKEnaUi6xzNGtk7fy5c019PvYqyYIk2AIN34BOSrgkpQjEQhD0tlYgHGQYBvTITwF6E/4+jEvc51vzCbg/pDKT9LH4xFpBtoIHSfswvJDkHAi5Azo0jCV0i8p6mX5R2Jze4BfotQ4cc/eer96TmzT/9+QFuGSxMNCzFoyjhgj9cEWyBb67qKAcQhXqgKuQlXDYeeSBY/8ZRA1mRUrgjNOBpoM1rIqkbsSU/bm6JitZZnpoMBpdJFy5hIL/nlNkxvuWuTUWAuyXckpwhgKbKmZ5FfI7sm0p2y32sOWNR4vhETzyDO4eCsdK0Fnhx65DSDqzO35rMp+DOKpZFoPUV86sFpUCjTT8TsIs1RaGpVZvBenLJRxnGc1NHOZG8UvnyO5gY0u468qdXHi9DSiAFmdB7ur1pbM4Oi/Fdd0qxohUysDuMfq7EXRiW3En63j8vc0tEbP/WT/TxwfVbAh8M78giUVAqJsk9JIf7zixjzQexzwKjX6d/zIx/+h10PXDy8SiZd+mueF7r1xS0uuERN/m0cBXtdvU0XD106KusGi1D1u+h43ykM9VpRYCo/civsGd4KrThYM6RQCx+Pt58mbFs29Iz3PWJPqM21ClQIuX2+m52HIwbu1Cpx9ieAjsjHI3RwXda7eE2txAFTZDvcv0dRrr7vZ++/5JyvwVYfBojpTrTvtlvx7ysXsz/WO5NUr7ZqW0JzCcMv7SBGJUmA/btwTUb50zrK2FfdKYdznHanv+bIgiTyzBFz0rVqghIISDkNfduyl0c/Ro8HYnk+6dfzhl5ztzXKEU1TbUzzgyc5BVV+8KAo/cuk2ihm3CUsU8NXcPvlAbRxt7jdiPD7AC/Hx/SylFrdGCmReI7WydtfMJWg5mW9AseSBJVK8eMwo956i5nbaEavhVG8XszgSGWGUljraFCCP3xJ+BZT0cP5aaaHb/kcHF8c4JtjG/m8mw+qeBHmHnREZG60uLxiEZxGIGUXSzjmlPYrVUKvlCy5vkkamWgdG5goWAZmcEFnAmJdS6KWMfGXEXsoomUbGxBX+iBQa0mBh4pGizWbuExDyW1o5GgTMpsXWPDIm1AdETQFA4WmmDpIK6q05+EaF8v7C6IUOi8bxSItDo+QTwtAjoWN0iwmT64hkKkvruQ9kGWPFqgjZ/8dxILBAyvSLLqyTHi61ZfFn2YZFWxhD6qKjSejI8Olsxx1SwqaMueakpk97bT2mIbMoQFztKA266lGXa7vPG4LSK71yJw37CF+mz9p961xSyXVHvgtDoCiytKnWMBBiBGPmw3zVbNh/kWWsfr9KGzKIW94raUNYUkbDA045NudJr4d0W/yrFmAvp/H1qyLT/zHZoXr+q3KzMF9Wat/UNHAH2s+qb44z7CGilP6LxOSp1dXKVFzPNSmmGbWqHlgQ9UXOtQ5gLtZ7dF1Oo9ESQtKTvwxD7mqZ6CCmFp5E7McUakyjdq6PPtfSvdGJC+w5tnhduFaWnttpCt9v3rsnEETs7LcY3rrLdvYULc5dIPCqvpmWzgVEIuMKbdxjtZRI6nFXKU77Qrn2aYODv/5R1XyBNgbxbweaHIyk6FhMUtzfHa873ve8pfn7r30q/8fuSAvYDPZX0veOTiDWSO/erdViZ+rj7/82gee8v13v5aXrvl1bsm3n/nqvee84+GLqb0+GNyx73/+5eWv+flbPnsxRqE9GKr9IZTqvkPvMm1esfn3w0orhiZ0/8WD9U0v2EYYXHWMXwAUuqAYhH61H+myFzBS67mRj6OAFq/FOj0g4SZvmLtLgWqnwa3KiQs2VK7lHFzDmnrTeCDg2DbvleQmoS/noQ3O3FIcplbJmfEC3hBeFQilLbf8VULNAezlaDtj8nAdVG0/91fVkBJFsov/U5EPx0M4Zh6gB3cMrUxvde96eVf1jL3rA+YAHvKMq/RQhepK9EYsGwd6hHdnnSE8visKTR88CsEsC26gG4GlTu56Bpb+DEX80k9cfs5T3jj/35ipictdWHevXKj1yiurFB/R0nAWycXU1YpbnULFfnSX/2DhNx25gCujgHuGr9Bx8Na1OYk2x4OmX65HFulH6nUI2yCqATKUt94O+iVt03XnQW+qv5CQV5v7OYkQuMcGjtrAXTYw8ISLV+qKYzJlhTQ0RlKOeZZexnr4A95o6G6xCo3JplHLBC0lSqTKzDwFaFgMU0oHrpSiNcSCe8wbUupiETXweKFKcZO3n4AAKZ/Rxtow8BAQnIUVKbwpIdZDUNxhx85mN6A7SqjHFXBmVJLcUZBINWIG2qGdKzDDskrY84AE8EOT8H3bKq05FRCaYYKft6zmnW5LlTl4wNPB0bd7PR0hfTuGt4F9y/jlmH0hfrnXvuzmlwfstRWKn+NWCTDtZoTj7H+r4Ezfsz+TN03LdGVoVnRdzD2dmmhgolMJwyeqrgMtXS1E21iHtIVr42qWRAXzJC/JsNyvYjvVsdxRW3erbQM9fe/iPRngixn18Taqz9RhDdeCf3SyIEdk9RpHlX8UGgprbL8rDXfBVLrYFnVILhYqRsMC46o94CZ0OY2jZ0zMhHZVBuQ6Zuyx8By1pPwPPD822haqCOcMb/sUCIsRqthG7xyr86dA5Wm+irFASsWNPyd55o1iJefCaDRcT5o8OPyFkECxLLtBzXWYkapZ8HIJuJ9dsdidB2NG8Dxj8NhuqnVPbaxLpj/rhXYzJp3SG4WiEMm9KbthNYeky661eWIUihvk52rZusGurAw9FTZR77Cnag0t1OYqX6lrIVLtTUZMKDm1c20t6sbqzD+plBeV+tbFe1IEVSfvZZiCnwEJNhbDYKgY8L/VguU6zouIMr+ojlU2xsH7n/E1+692Q0kzv1b7//V0kdo8Q9mKB6/DRHZ1fm9PL+uaVhU+BaqWN0RToU+pL37F6rcPwcmPBSN2dONR21sQW2R/Ps04lrMq7+xv1Z39rfqk/S2XLqmA+iOuBpopnbXyk8/gE2dj9S+cHS712WDOBOs4My/v2u/Hr5T+7DX8XoSfS9b2s6HaNf6jSFz3oA9alLiViWCqK7kUbZF2Ia4usxSPsKi5Y+5xC6z17N1qAiyvY4SQPa/zc9wCa+yO4H7LC1UttaoiEGtH66g6NEoBxqkB3poUQHb6NVbXDGBUQz2JoOchSGYTOgIsXe1COUEKIEokjr39UgNxdUw9hup9Vb2BqNQbiPCqlmahNxAhwukN4KXgkR3VG/h2nKMf8sxBety/z55SxsgQSp+l+Wi8dks6lX2utOYUb2bN6bP/HhQIvhDLMWo5RQeeO8KpTeHkYllXAX7gNY4Xz1JVll3ATrExgIOfLqCjRk74C38f1aqs2xU4FqqIDVlr7xZwfn5pWGQni6cp3P+rSopFuwlW9Q6j3S0J3iKAQBMockYfvoAxg8Gck8r9N2pwQPsQwd1E2ShAfVg984qgZmXO9f7o4nKDhQOJbm9I4YZaiNxnL9UOq7Zf1rO/larqsMwT9n0Ksdqi5nMBtuN+PSwYrC/QUy2pDdSC6ob7ukLCyu9croh1FXflvpqu0hw8NtIr9OMWb9/Hnnrd979l8LmLh9ovI+v8bX4v2xpyW/XG/AKXZa++RVoihdnfIZcSeoA0ewDvZiWkBKita7bOrRYe/SdAqwR4jP1Q9kX5AniNAYCP8PDAef6eSu/2VnqHMQX8VGBN4WW98/x9UrX2CSXszr5kyowghtOmSuv+HvFKsHbqsUmkWBs6rQNN7laSVyeTW5XkrJpMJXTx+4Lsy+YUc+CN6lc4GuWMTE2JBVU7OQWLvx5XsMCBrHW57xQsnj2pYHFRJXnvZHKtkhxOWIlyDXyLV964yP4BjXGeKgK4WpDJZFI4FnikvvNCCoqayeS5TM+0tg6oBsM6QCP9An4Y8lCN3FComQs5DQTV4wDyT/oguDMKwmux3lV25VUXI2U0PDGUvhm40A13YgkDLGbW/COLaGJktcZdVSFuPfu82sXOfgHP4b6/u+Cfv/qMc/7x4oHYkD3izj+th4bbspuQ8whOMyctxQYKAuP/w83QIqp4AqkrfCtNE6Y9EY+a3mh/N+2nV+1ng8b71jhu3xqPoW+R9c2RABsS0g453xx1ZKsDCzxgwVg/wa8rTnxD9xSbHOlrkfSKulAJDqBPk5h6KPKcXcXKQiyGwwrVz8M8QWW+uylyZRFfWMscDDyqbiYoFq34CGz5Ln74KK1ibZDTUTRBytz3+A10D3Qe/iS6EiIOLSCkPtcktKCmeUTs8hBX8lLuBbRb7eL6jypf4w+VcC5MzDWhtjh3jw8U8UbuGXMunREXYj7FGHt3Z2dEIUEvGwxz/qnqwZD3fNn8yqqqWyjyKmYHPU0Ykndk36984Kq7v/jf/4bPwb5L/v2K00MQueY6n3AuH4Dlh++XM0dN3Xvb0fV9KwOP//82XqP5Oo0I0Pyq/WethDyLRJ/jmv0jOOWcwBPbUCAvhdDT8XRXh9G2OBlO4mRIkEKFt02gog+4XNkbadC0inPILI2OTtUc4ntVNUpZjqxUwVpw0P9g9ibrxhW+LZ3fM5jD27COzvTol4Jp5oDuGHZSU6hal9XMRYh+BUceUUXDSrnwSRlMMzCGypQdVqtnIaLEQKJeg/FhxhwIbhxkhOoz2BvRwgQuiULbP1kHjK08MFq0obOBhZ1vEE267po0LGcstEW8OYZpufqIaTmOjdS0HMaa6mr0TQwSyxZNNM6Timjfw5mGp4dc9UlzcxGMzaGksGJsLrLG5lC4sDR3qCI2Ll03sLjJHRhXe0y+0xrfvAVRxQBdKAbo6lZXv06h09XXLRiaq5scEDBq6BYotA+3SQpI/exkX6w4rK2rsktkrYaph1Bneu4d6q32et9rVlDDHdqbM/uvqAl7pWsHiij7Z4nAiFiF3VU4RcWo6049T1SXuaF69U21zQ2xLgp5USHKyi1rRiCR6JTLFlimNh47Y8nET0RCsjd+TcYo+0a69Nd0JxyIcpp4AirVfBE5HuPw8vrtScpT28rNWtdFL7fifK+iQo4eRnjsQX8hMr9aDiuADgcoxG4pexDAwaCObE+Ul09k73AvBPnZPTpQgao55w0tFnKzc8XE8oLmyFOO2TUS04J6m8b0uVrsbNdMUpsrRHwxY01/cHtT1S6f2cg7Y/RDZMcxZRSNUJCOISAO3KpfzT8AMLWMsYl8Djf91Hj6HIZunoekcmypoiAX0eHWzcH1auVi1BEctA7yTmpryqgzxO33in44zdJ8xTJwJsd2c0ieoxkZcoF0EwbN0LQFRv/xni5yY5ZK0RisPsmIRC8q4mrfZeNlCWjRcZW64JW9wsGRXJCXD62qI67AlsACH9gP8qz7wnxZquQB6Tg2peiYm7yZ+Si6uvJFlzrSEpSpPTNezostGN8uZQDVMiC2jPgsV6P2DMaFfI625DMBIL4skB4A0kMMdvkyEEAC7nP2NFhHYeQ+JvRmlPz7uu5VeRGMaeZ0nCru3jie27eOoeXWerRFWqWH7R1phDuZqh6vx6g61pu2Y/UIiS2Wx2tZPmJrqeFtUL0iPKXaOyg7MpysEH1doC1iU3FWZ9FKP+JDlZ4i/KpOpHkKQO+2cntWZK2oi22kFVx3jxDq9blkWB7lHFskiVZgXGbb/nw7QtfkRLCCgNu9OfU4FHKoYPzcwX87sXZMuY1+Ct8dv5xCwhOry1bagcYVkYoCQiZEhHDG4Su4HzulHxJTnEKnwHzFqSSZ7etp3L5t3D5zSXKWEi1QbMJdLTItDV8hR4Kz3I8EuFlEki+WtMsln4b3Sr55isxRAlAM5nx2cVwyFne6UksoLUAgITu0OTotP0XlKXKl/hQ6vWrqit938TvFSLSxc2JpRokqClN/BSBNdGp+CgGDrbbhNnvVhDAoBRUAhnZWu8Jlan+1N/yq1nuki3m1QyfVeDSWh801/xG3PKXtOW79Mdo8V/b7Pe5LKGMUuca7kUOc64SM/WgnepUxDGUM47Kcy7kcM7LVcnh9mCjnG3eMV5QB2IHd4w7aCavGO2mLdW69goFvMAyWDsjsm1fb9dRTcy3oNpe3qqo1ovVaMTEAm4iqS8lf6DwUdV6Kq3ZHOnLhCcaW1LY0zXHdgM2aLGygOnq6bJu6hLclKo1ZLqCNbVoAb7cwIn1qlX6wW6RHAiPJaZmcTiQr7AwPQskBw3wQ8yNMZREP98q4iT8noygsyRreecmXDkejmksRzWEoEkM71wxjoNVUakiluJz7vwF2oGq3YBG84RWAv41znALN9XiV5zVt0fmLzrs0gyrzuDIkaJlYKepU1/DMrN9VIu/WbwxSSfJphuZxer1YSV60vIVe/la2bx7NvUrajAtxG3dkb5DFfsUu6mAcclKUZxSbt1cDt1iKMw9I8BzjJIRA8Bf4byvkUrK+YL3A3mALRrKHTY7c7BtfVBSNV4lF0DuxaCgctwegEztoRVF7G+3MZ0q993l8sa2coAwAHATP82jP6OjKukgddyl9jB2YA7yAygDYLABWnXDUQ1xPpl2xQ+O0gTIPaCWPpRmzaMYcRWvSRTxndbsT0ezEQlys5Qu0FSVuJbKzY0uJ5FumzQFAQpNDJF81fQ6cVZkDeQ5FeHxhEDXHUMxZfJ2p4OtURJ2ZiqhzXwdEnQOizo0hqtKSKqJqF0LpxwiiziqiFgZDZx2GgqksSgzdQYXB0JU+IyX/kcVQ8DwLKHzh+BiqA72VVtfy7QrQLYaz2UI7adZi6PavG4auVDB01mDoDmDoTsTt1DhtoGrHz+Zz0owdeo6B/kHNcIdFzxWpCWWM1LSKmFUilEpUlDS8xNKFaVial8n5RPL0PWatf5HsMfUKsu40zVmRjsxOLhafFEIbcMDO8EVR6uuE52e/zkMLjKadouIx72bkNiYbM+KWZL7fwVK2JrTdgoUiAH10MwgzX1EVEgn1sB2fx8I7X1niFCA7VbyxE53dWZ2SKMhuwdsNnL3rXyRahd40B2U4UX2ebtMUTudCUFrX3vK0bVR33fCsnzfxeEGeqmH1xnEOJZvsz6FiU8h852Jke10V18oBWz5TumWe2RDmp8gqAsl8Vlo0MyrEhb+WUSFuVfcJYJ+D907+qbSvTR0R4s5pdXkbXapQFOpYIW7n+EJcbP7Y+aYT4rapvakQt8NC3HZKmdutlcLbIc3qh3p+MBhQNu62+gi2bpVN4u69kOJO9roGspuV8XzByzsJeGQj8JgDPKq+dDILj+z48MgoO3l4ZAyPuYoMuUOWrUmODtGo9oRIGfBLKYASM1jEzVFQT+FGUCzmgyCgeFY5C0BgBJmYjauA9BEDrv2vBrh2BXCemTVZ9TSgfWQqBG1D1XjuoGBcAR4RP2nOngZ4k6cBHmU4hxg/DWBwAC5X9kYaNHXoWjzFoDU55FE/DilwZ2ptiipHahn5lUNSzN8q5mTUsY1vTzY+ozY3vr3Z8dqmqFZD3wZMJ4XglWrSRq+7UbVHJs55kRANqG7jM45vuj5QNIQNNy7wanBLpS7XRftVDA9TCDXQ/Uq/5SaWiuJxo0np9IsKJpDtUp9lyN3jtBmKD+x38edofNtZZquibnl3htszwJv+0yr2XNrDeeA8hU77QtmA0TYj0HqRbAur3hrvDb2ociDu6xd6DFMdauuhv4jscVqV3Md6kDFxZuc9ijO7cPLMLqzM0tDO0vD4s5Qbe/JndqGc2VE0ldzH5I+Q+2iS3Ifqc3MTcu9XjqU1kyP3J4ZHVIWHnjtFFXhEFh7R8eERUXTy8IhwCWDEh21QJfdTTxD9VE/WKmoK77l4+PwRtZB/2VQtBCknVAtBppNWC/mXk1QLudn3GpOKNToPksJanePpoN6dREJvD9KM6akYORLChXCcq8GKIv+V52pB9Vyt7s7VEgrRvbi8RO0qi7iy/abcvGHvxcSQTip/7sPJniiz+XIgWeixo3Xi2hATrBQhgzxCPCTNHJeh5VaRdMoB2feKQY7Nbf45w1s4pDbngaGeB0aCypE7K3VngRWbf4c99d/rG18ugfjZ1JdcVB3QwFrVBaPqIVVE3Z7xgip5FXPIc34EVXHb5a9YngvxGLlvE6TfIl0zNo9Ut1POA63oCGpWUqGLWB2LSD8cBGDmgyk0tQimaRqh6SF66h0oPGbvHzklxV4xBuWIp1KO2FHSfyXKMU37IXoU2g+w5GjRPj6u9kM0TfshxnQ4Oe2HKu16fvpXzbihFnqvHbPRG1W9ON0/5pPp084nkybJ5LkPQbPHjfuSx/rfYsmz+lqyx6Zql6JdZsjrWtODYzV9wdX0oKvpy1ITJgn3G7fisOndpc3Ss9ZELlKEsDMVYo/ckisQ1e3IDAXQKTDCm+T0gM4PCCGjiZlpWO/VgCPf5R/2i0xFCBmlayYtgccDUcDvo7HYgj4s9HiWZiBO40GZKU2Ak9gyb1Abx9odzMjO+FHYDLrlmWa3+3qKG+TNKtS0sxX4UqZil2aqtLyFMehQNEWfeU6sakeEJ5lnZp4yPLg59VzUUd0bz+ICTJInABoulOUpGEAFHVva4J5Boo5ON/CYhwTqKtHCSkCyE/WW7Gy9pxJLHVyTgvCHa0hRNaUcg8d+OLalVK3kokZbLP9d1ctnSxUBALHBpYicUSRHcLXu2gZwz1JdPr+yqMPD+jwitIxq29DyfAEAhIMpgI8eI7Ca/4rAav4bAGuRYoJpAwHaAmUEZjz7dVjRyb6qk8Dx8Is0e6RYoIUyho/aZ9fLjRXN7vtPf//gh7e/6Kc9bvI8gIs5d79fig2dISNIMwXKblvGfXVn+CLupPlBGUPzR9YBNJGK0ezohiOo1a5+OvN64u3rbv/5SogTVUdqGnxA+xdotu9lX0PHuG7k4VcxnyO7fyz/6sPA+oyH6K/cfpwZ98Qgev3aOvvOs6Q2dDeEwmnbGPXu78FHNDNUV1zDI0A8hsw1rilFpQYIRVN0cYp0WhGCFi0jQ5TOMTVCy8wd+TTvGDIzY6SKByBPnFNJIwv9cnTcv1S1LPhvWWzpdFGOc6UzR0vwWyMnIosC/y1rLGT28xB5+a/HFXTzVQr5S59WpVVbaYV6/UQExigt3861ESTTstJvo1X4JylCvV8ZHg45Ei/ELwf1RQ/FHwjkRU/L7w1oq1YAxw95bjT5t4MJXaVVOZrMKYYxGuM/YdJxgqJ531MB8DXSC6J2zoWIxBlMdY+6cHMQ0qzc9hTc6nJQ+74Vb/vzbfzhdu44SY/gTWr72qPslE800SlA7ZH3iwjtJ9oOdN1uDs+pQ8syKtsrAHMVSPGrwBuE9LB4vNglFLtECwqxRLzOLSjEOown6peHHzOU4btMt/VSeQtmVAqrh7+tuq0Eb0vFDtoxXJdDsa2O1J6iF6K7fFSRt0VuDEQl7QAX1m7jFBpXD48Up9Kpw/w09+0O6gqetWStLbav0U46jXYgd3ak2EW7mCacPqrFwiWSqBdw5lM5Q0my6HQ6vXy5sreOz82XdHToRIDWtJJsIXa4aG7MKojzqsDilErCKeaYzGk4NKku7RW/vKEe0kiJq9yV7Si4BeK8Q/YIOyp6ilqD7gtRUAP6jfJ5od8liMhRUHESJeiRU9cydGdBvxvY32D+RWkDYY4AHyXoayS8oGgkguK0SNMXKO2/YK04g7roHp8Znont1rPAx1324vwstTB/Nqd2D+RbaBZG9kO42jlHjA3kT8Aiy6mv5MMJIEEmQ5ugrN0627L8iTqd8idRTAWZ6FqRY+b5duYVT8bc4y5MUdQ5FzORkwiBYwjg26MI4Ku73Ffun5Y/sJkPeyChDLOzQIufSE+Eus5T6En0JATOo7N5WT2TJ8o5TIGfkM8rvRWAOQsBKU4bleXjw2ghTquWGKxiRqvLm1xm/nbEapBJlQ4jYRjv1UnbYVI1xwR4RsSeGYQMmD+0TctUcoJCzyuJARniQqtaD21HhHPtgzrxxVOIOGAzT2ZbRXtw54gwltoeqXur649Wre34etdNW4FQPNfw2EZtIFO7D/GHTJi2cVdCi/9moNmmteYkFUK/wBDrrSWRznP+mPAqZWqllFdXATKdJXSW8CDaBjLDimvqi0x9LMncZDBE8P+Uk+0xvtL+Akor1FZk1JXpybJoPsmuUGiJ8R+V0za3LtGTpcnjvcbKsR3oTE/Mc8jIaDuaqqbxtHHgQsq2LfEMQNA3zfOM/zOQQ34OPOUptgJ0/JEC6Mm0anyj2mnBH8v7uXQumoLmoVUKuu1mZV1Rbb6xhXUrmtzmuh7wtA3HTBvu0jbgVqZ0iTMCp2SdxKguWaRbBLuwSB08OjSHx5zyEPPkYU1mI1gikpNrtUwNS6XYZQaL+Nqg5XwVPOkEOQGgplMkZTyE9JmAMhy5MhsVEtPGiCq+hRzcLstCm1ZNOhPfktpkgKWCDWAh5v9WhQGCpQUSlRwOdPMVS2loJV/issJiBUUpt6RVrSq2SZUkVZ5HqxZ5WL8A+c0UC8ewKKSnSNYMWTU5K5MzZeiAEQSPfdw07gnXulUQjZbGGxKahqwepyH9FzwebVkFmFxbVkB+Qkd+IBk9Sfi0TbOSxx9EWjtp7XZiubleJUJbT4IIbVNeEVPDz7dyTST9VNeTY3XpnM/5k3xFDMOEm1KdbRWqQyegOiAzY5RHqc4K4oC/K7RQaV8X2f+vIkTKvgupyUN++DyKcIhHntWuXCWP0XBTWuIoBwJpSRsKotkRAkEmX2ZJ1blKqkCzZvLtShaIeUDZwDH+wsMONEa5ivw8CVCe48lV5edLIGM4zghZYqhRLsqtFvP30Hk60MV5Ei+RF1CukVzSU/i/JyNpD51vcp6P1ws4Vl65cLCZWIkwH7cr90sxZ9fuCueX8dP27zwBCKC2XWUJT9FmoljiBiSF7YDWYMs5V7unM1K7bDNwcHTD52aZTo4Tz7RU6sYno1RN8Vd33tj08XiEji1ZHaMbShiA2L4iE/F0eRI1uZx6HiqB0ALJzIatx5kNbiY8cWwmOGSn8Y0sx22VnE9myOsceaKZI0pN2qZ5ZObC1uPMBZ0HKUWyG1Avy7qz1ZfDeMmgmQ0RXONS4yOsocbbgpf2gxfnPUqpa1bC3Eehug0RocmKZaUIloowJeyO/qhf2esfsy8EbLAvuzHy/qNcwSOGRgwhi/MhKXgi0EFAwU35dBGBP03OQPmUnLOyaBGUV2VJTyksto9LKhyaKsbZBtiSp6PcZGUpkVtwJ9o3WTgqPfnSt+ek09wen9oDyRTz9nHuy2OY0VoAQ6MKBJ1wboQ3a5Qt/riQ2Kpexn0xRKEvA7yQeTmMl8y8HMSLWmXj2beNes/KQ8xFbA9Cc4xtLAQVq3hcUsBWzyRa5zm4WCYFEG7ocjwF95+c59zbXDfzvKSneBZMBEAJ/gkUQWm7mhq0py+rsqzRdlnSKmIg9SKqOzoD5R2Yf1XN/x0V/qDclQDMxmwkf5Je5HnXltaXQgruEC98gyFFECldccdQHCt4BSe6g9phdr0IkN+J68feKwCbL/h6zNxYozrLXhDFNIDfYvN2P96KRuXccl1PEupUd0LyXoGvFX/ls/t8/A649ANizdGHmeE1ubtZ+xZ8QnU1G/duGCeWmP/S2+OXR9s4Is5rzr59mv5L4AfOmcVdzjai1dL8tPVlAbhkr0JP254YfISjXevvQu4c104PDvl8BIcgD+eDSnf15X6hyMguh3CRXhSP1AK0O4dDE7usKXA7hgDSexgfusW81JD/gF6VvZnj0ARC32721+DgAo1WY0F3+tkNaKkzQn8jXpnul81FO/AMs3+GDF7bIxJ8nCCQD/MmXOy/ILHQMn4DVeDDj3vqH6+mJrjE2Bm//AjSXZWvRpVIcz5BXH3agpAna1L6BzGKKH9V6hvSXpwrxzrUOvIHNoZD3LC5rXVgQ/RbdYSucd5GJsdKX19jTjl4kA3Cw/LTtRSIFm0R43HFsKgzsiP4vOEAnyF4NQdDaa4xCElxRWWtXrowGVbU08rw4CK2RLpq2/RaNMKEDyHc99iRWnDdhDMV57nkdfqJOG5QDRb1g5AHeo89rPhHwZyFX1t8eABOip+THmuE4nPHGTd+wKvcoYadmC94enJ977A8uT56B4LGm05fbEYdHkjUJpZCB5qqpkEr4aMI60H4zWUwuEeDI750jlW+ur8SflDDMIh2uw1ya46UwXtd7CGJvUXT1PGOnrxL11Lt5gOum9Ku+/Cu2SRJi/pC5YvD6yNfBIfWNwEFmutKk8/cnL7fs3OaYX6feeGxLOf0vRoH4uhNHBgWbKHrzzgD6of5TsDj9/Hc8JQI3OspEahQoru8KikaeFVadNg7PjG6BTYHpbObm4d9mTEB+wLzfJ6xtfXrF+fOaq3auOUaRnuW10vDXHkMINXFpj7F6runqLMC0OWI3vfGv/mVwT/95uDp339h7dkUbL4MsD9HJMOSGEy6/77HMRdJ8M8Q3CPBYwieiyCOgWBFDMEvIHaXBDcQ3CnBexEkCR5GcFWC9+CzrpLJPNYaM/fpgqux5WpM3KfgcwNGCLFfkL0esztP1F4timNyk9fxeFneqC6lTOoTt5TyG6wPNI7gqhDF8KGqAEZS4bt1tb5OvnG1Wl1XY11Xg7MZp5QuV2mswQjmceDNUDVzzvBr7x2+G2upj0XUr3g0U0R60FfZDr4QAqdgU1KinUe3NjwU/AUvewN6bowW6/dmo4707yl0ITE2HmENv7yI8YnEULTghBTt8M+WE/eB9QmKdvStx6NoxzSVEL63En4AYaUcH9GgzJKfnqRoByVOv7qlEr5Tw5jBH0UJCHJrNFaImwtuSPBujahSNHTN0qeB66ZSWrxrNknSom6vfHF09ItgQ96nU7Q7XWn47N8XRRM2EJhdUeFzVA7GO8fpWuzoWh2gipWu1ZWugaqdgIhhDik0nv1/Hj27SehZTMaQ5vOg56UIBB/MCAiJK+pK8YqElNgdAedPCdvnjw19eCNKqpCWUbKC+TyVrPzw8cmKuvt9jGTl0C+Us+f+n50gKxt3Ho+s3K2palW9Er5fw5i+7yuDwcGfmyQrD1a+OizpGh5oGIjzkTsdAZFY5Y5c8C4JHtWIKllB1yyRuAXhClm5Sd6RTZO0qJsrX2yMfhHcJe/TycrAlYbPNicr3yQr3yQrPzKFrAgCIfA2BE6WrBw+LlnBfJ5KVn700ZKVW2IWMESlv8pxknKtmWp3lBPn4G0czN6E+lZkemiimx4vq8yOl0xOjqtH5kbhj82O8MLa/3CI/7wq3l9SRfs9x8f6vdweWKwVr5CHXyUw28PzCs3W6bBbke0JKBQQqa2pd04rOKpe/+kNDRoXsXPDCVPEKNR87iZtbAQFf4w8pD6a9rhbLEVszRddRC4I7dSuouFewbInMKy+U0J/B3y73PiBgtFVhB5C5CUSzDi0DyG0QicL+o7JMorfSZm95QoOy4JrFGuHguxmwed6nz8/jPHOYwQPSjBB8JAEG+ja7rxpNgJ+VZyGt6YYwMQWoHFlT/cCzc33AvHmewFg8VWFbwx5hRjVW9ACvL0AP1eJMmasQrZNyQyKuTb7cTPFAv52go93F6p/Oho1Y32vc7pUmZ+gQJ5z7BuIKMLflNIOfOufxAaOckCYYkP9bpcnFxLo815ND+7Bc0QgYUu43wYeNJ8ewqe3BM65r8S+z9OK3qVPeAvGZ1gh3IQ7PLLSHBxZaa4+/pR7mSUBkAnutkQgFuKsRCBWIqBEWq1J8HOXmzkRaLYTLNKkXHFV254prFras2TcMRQKJTM0Oi3Ebp2pFFB6lyTcgt/sJ8ZIrppdU9vL+nVZ0i6huleQbwiu2libILhnKYQig1YaeYtXwo03O17VaoFmeFc1w8ZIBm2A9XeMfpTOlO72fdz3HzcIqTfhPqn2JLNbXstPiIPRfHFa2y2iIYXrRVzeM+S3N2M5GhT1K61l/fXsx3Cn5fbsJ/AYFglHxkNK1qlesfY6gISkxrP27G9Z/fxnzlthFzflDEa08+DovnkoYAXr83zAPVLvKWhNSKbucLLuWK5hUjxed4i6Q1v3xdx8V3d987r7vhI/d331d/1YzReq7QR/r/MEkd0KABYB8S0rD/QmK0KQqgi3VfWWHav072L48IP2PfRzX/zD53zf5UzrG0iUrE0kdeEKCDQQ8n8QRSS3sLSU60NplRlJCV9G6Q25mKuMURaQUwyazU0ueGVv06UFNBSHYdBRRzN2c/W2yBCTrY7WrGc3A9JvfojJMnvrJ/67pFe0ML9aVP82XOSOKcL4tHC0lmVvhBlIYJk6ryY/+2HEiIvQzwd+5GS6x/i+U+KsQH6Z84Iel4YbQzh2wVtKiWEjdpr7AWgAaZgrdoRA/HzCYU916meUwJATf9LSkFAHEKYEczekBGSgQfwZ5Ndx9ts3Grv0Vfmfmtb8lq997bqvqeuMh+xq0iT/AK5gjKwq2W1AjhU06F54exmxE9BWp21yC8DhJVxZ4CfDvTTYp+0M8czuKDKeX0jp3lHEsDA4EIMYxNEDSnnkyjOumGMqdnSOUHudq4uJ/xgTsjfLjJeziYOBsukUS73uQoYUiJ89fBncrNrS9XVzrAW8rimaqLOQCkVKeFBPZub84yObOd+cOf9HnlPeHEWRXnN8xb/6pE/KSR+Wk742OeHtbM9bOqXzUPuezygw8g4lylskUwUCNVJK0kKb6tk/Aa8tQeCeJOhJYG5fJuLPR9GkQ80DNKMQ9ie2zRSIXoEv1AYzVMGeUSYxALu7YKyS7TrAXherfYAGbmmZEPyx4MX4f3Gz9QS0aY5gI7YFotSqEKV5S5QWQJRahijNgyjh7hctGKL0gk2I0tw4UXpwhCg1DVFqTRClq6VUR5QEXI4utUo/Ei3jR+JR0KUfPvSI6NI36dIPe/Bk9HhTJfKhMAbI3Cj7EaqfaA+X6AYu/VQYKsn5hic4oSE4rUdHcEIlOP8LvaZUwJUCXEJyhNRUeZfA8S64ONopeRb/gMKvrvBTkpEpsaoVntjwM96hTppwzHIDs0luZs4SjvkqNzMHwiEO8OdPQDhmxwnHn72mSjh8x82cgHAEj4ab+XtG9Jdz6i63rRdJMk31XqVaNDXCExk9SMD09ZBnAreYAPbcIqq+lkQOfqOnJT9onndrMhxljsrUN0yGB2xBx0wAgwOfqdJUT5r6jOv5q4zlA1in7wmQcpOmaKMiE3gwNIH7OZB+0ffCSa8CRhXkLa+Z5uYuFFiOeNMLnTe9cNKbnkuXVDAOj6ACcB/wo5fdgczqWC4iHkF9FTdKMI5uD3l9JYSYGpCssxhUfu/z8Pu8tf3GaWJY8Zjnw2NeV7zCWI95ijYxHqXHvHjCYx53KPsj9ZinPg2RHTtTbtGIx7zqfvOrvpj3aFw7si795GtG16VWZV0qhXBFvRTCYYVSGXJlkarLCobvGqUMzy5QRQPXEvmZynq0+VIVmqWqbtaVesXiB7bjdcxNXYh09rfyNgJJ0RBjCgmZL7HYYJFL3CLnglxEggan5eo2lJaihW3IWGEAi3MkZTollYUQNgcTu4yhg3i0qcWPyQUtpLCyoH3F88GvGqQnt3YkGOFVlXzfecfoIdPteFe5tybJvHwrgmkfiajtbagDQkqJyBvWU15D7asAXci3/HVEzf/aU8WFRK9whmvgC8HlBcY4ZEPOKoBTvqpaye153eViwcGBBUJdwUYuQ8ShHsDOlnCyW5TgO38Nn4piPUxU+zKV9bN5HEd9KRML+OTDs0tNxmQImcRhY3bMOElr7vJhe1lDjBIyVXQNbVbWUHxPLVlDFzSE8xe5LF/DzO1jEKUGWGPI/ki26R0YJ6vLZ32yl/NPXCqXc4TTAS7gFVrX5LhQ3feRr/XE/EjYD4TUlAHxwCQFVBfJpVl9EwN7KLbxd4BEuNc8d5snmWc2ZuyuL64445z3UGK0og7zrQhp/XVQs4AfmLXqNL+YZSDMqt2KuvjRtKrD6ro5oBmJJV/sVjQFzCnqohmOwWO/2F2dwYKplZbFUpuNQLRRLqdUtGW49TLt0Kg8kra6Fgbi6D+QQq4sAtiYnUWEllRtYU16gDMNkMqWcBuw1pf9bwCy6mqa4CwZpvzuEM5iIDuNq6klC/kFgnAeeASkIvYKR4SQzmCvrN0HQx+8Pk6pnO0WPENl84CKKO4eTwtFbMsaoMjei7Y5ixe+I7KBI72ieXylmAKzHqhKGqtutAIKkV6xvBFULW8Eur51mbyKbhOow6hlDS7CcUNc5roaFfKnWtXopHpiNDURBrXE5IbxM6MmgbwSIq3sfcJaaWdgG1bzgb5Nh0ToIBFRJD1leDgIhEcUQieAQBUGWGYDtSn1WACRB6DqL/a8ijOe0Fn+UNeLzBqR9yJcpCcPDp1hm6uL9oI6cMOVmCKkxBTYt8aTgz8CXQI1/WMhBaGjpm/1PX+aO0WqWX+hHr5TrzmIvXFq7IO1abFfmBp779TYj0+NvXtq7EXTIne7yNscS7ZTNtvqdHNXdbNtBrGSvFpNdsbgODW9kIFkrZeNeILMfgpVaYKmqmEYb79xBpme7Xmjn9b0U8OPechde5S5n6fNss54lQ2EqCYQHYjSqzmEL2riripX8cn71jwwX5Au1+rEN73BQ8mlK+RAOVbwlFJygGb42RGrB698KDAxGyo8zHelM+NAXtEJblCAuVF1ZowXriQcdWZ8EcOCtwfGqS8fb35ZXYLqUaAef3Ar3ipEwEclm7kuXn/NI3dd/P+gdme0Dh3C6iAf4wWNVWduHv98n75keMnMSxcvXXk5u0bYRNCzhAb8n+cW+ctJAEtwU5TpATu1joZQaR1NwyIJ6AuFhoDBy35exgrb1zvFfCQmOLZ3Pja0OtV9dDHB9g+O1fj5UX7Wkc5PxL+Lnw1FcJyDBGuAT1PnXhMdaQqaYmyxwKV2yTWOhrAJE5rhU5l08VgSsB2lKT5CS4bRL8EbQedOMOhtntSffcZdKRhJy35BiZAMVWGiMcRANg4aArS3aOGxr2hLq7WMYgbeH/WTIqIZfAarLa4reUocL9eg+Jl74qw/gqshkUyiuQxvPTFNhdvxwKzD/ws1KegpvwQYaSkAeUM79DaZwS2AoEVt2+l9eVuam7fQ8BY9kuZe/HVpbrJZc1MjMFHInvUNANn68SB7Vt6W5n7jQDbeFLJUg0pBX+hq9hbMFbTtKr098wJugQ8RUIILTvB+Sh6KZGZDC1SnBb6q85Tqeddp4tuNFlg26h7aUX3nHnpKLNYJXRRnauoG+k7R8kp/eyp/ozC9z6us/vd7o8u/UCDHUvyaSmpAj6bGHp0a+66psXdOY6EA2Cmx902Nvac2tWVTY49OLeHcaVl3TeSsDgcg5eA8jOKAt+GxnFB4105dGLBuYnXMflEWYOgcIjJEZKaReah6MJdPVTuKxOl5QHjupgBLTU0167C8JOLwXcNdKPmIMpga4RZPbUZuKqaw6ogxy2siMQ3c8riUpTAwt6wuIprGFVJTzSQKCcGj/b15iqn5fW3PGs41RhOb+Qw15RN126V3Rw5kv6TU31UqGwWxlc4tYQ5WjaRT2vd+IE+tDM20uzCiu6auF000Fztu601TOghmLXnui0X0PSPWFygGwGeoZg4b8JvdZa4KiiFhLf+iqRPdF3ZF2urcebWoNZS2UNNs7tu8MevcwZtXu2DY5RTwcSbPsC2umjxDSZuYPAN9dAVhEBKAU716unGUMZtRc3Bq2N0BF2maUiEgQfpBL7R+RYyHWV8YLlTgBebdE6vMEO+KzWZd/GMhk5Befp9e5b2av1DPqr5eWfUdsym7WE/uR0sFWlJdeJQ6qQj0exFNEXqr1VMEZeNQ+GpjEdKViixc8OPuuVePe8DRVD33/uprju+596OBn7GalhLNY55KDz7qCceK4AbWppoogcX7xfB336M6dqg5jy1jYd5AG5AkGCxnf2r4QJc5LY/anLWYAT9n0E+8PnuiZhWrcDxw9ijdp9AKHP9KJeUM2pZhEY0rlrZ6xs2ojccszrjXZHYCGMJpy7o7R/xkQUu1Nfk8SfTR0eryBURPtKJY1OiPjhZSLGXvELq3TAtkwxyiRRNeovkyvEihCP1n8THn4W+ODGjxiIitdRCpQw3YhUqMcVFFpBYiW5QiizWPZdjZ9HVBBIvOMSbFlFOTqqVzvLXAt/+ykmqgecX0osyWPFYKTf6RW9XWeKATueofYNTBl5NrBYZ9DlycnJRY5lnJdazoXhd0U+/IMU8e5zu5VhL1qtvh1LWzJTaIYpmPiTBRaK7xdNRQ6whiOr9QIxyQTUL2CGyKrixmejknU1u4pjbNsNhIjbxonXEKsSmorR6vtFzHMQiAfkqe2UxUV9RPeF44uaVyzrAT7VmAmQOhqKe+5OEGwLeCMEmURSl7p25zEVt1NM3f55Hd2UXY7qnpfKUcsoHzk/M1v+zVjIF8bMRauq9M5OF2mV72LmWvyK/azP8VRP5rUa13n4Bq3czArVqfx9Z4WATixH5wRx6iZDdQEAgietQHz5UKsmAd0Fg/QrV1ofWjxoZrFW175BsM111MgM855shQt/7PgVxiU28CG9InPSxBPAiiJPqQY8DDGgGOZl9eS5+P0qbeAfINGqlJQgCtnMzvETSBIAGRodQCxk9efLxAsJiUUpH0qVKLEUIr3jExv/aa/ZzLCqvQSk1qOeEXf9th2eD1zKtnX9Ozq5/zvfrJeZkQz+zOy0RY8TLhVfxMeON+JuSGgfqZQH/cxIhQQ0CxohPGxZyjRKjVVR3LjAntjAkpNjMGySAYPr5oqc8JKbQuqKezx6dQS48B0khmjz5CeSDNzB4lenWZUJPT6JugOnlQ9VVsaugjc4ImQbE+cVhf4drwsLifpEVt9PvrX6XfI4PKzx6hbPZf5lqe2RtFEJ3xXyhhZxFlvnJsq3rtjQuCw/MEILjjahwUHZqH+6ahHk1DMA9uPvu4GFFPkeRcI5EHYYGxplG0sk8hE8XChF7F7UX2KPsEYvNWCp2TO5vizjU0bixP3zuk5jrX6emNiDZ5uGwyg8dVRWd/kYERn3WnmIJrN0V87YOLkZuVnpw/NtahMcOtfxkkDtz8dXXa14X9dqj3PKtYAADB4uQzNJ93aBauNqkDkYbxXQIT+moYOhFfreAiFt3N+FWap2wNrZpRW8Xs/B7fcECoZaLCTpwvHwLVzCR4EMEWgnpwEXKwpqvcHCXZ+0eO+fIlc3ckKma0p1xdv/VCmn2uAacFckRzFQXCqtP4uVK/gVzwqt46NpmHvNKV1dP4IGhJ68pNXXBuXjNCFVpSbaCOCoISauD7gx52YwLzJsY5cx7mOf5q7fs89/KABA8j+AIHhqsk+IAFQ6ISh1qfX3Q2ZB8Q5m9GVQsSV0joiq5m/6Bk7+DwJgDjA7EC0FXbihYm1OEXIHU9O4rcijaYqveHbM2UB7vO1tKuKbo8GG+/fiTDlznDFnIJXdEfC0VnLiwd5HTFTewuH81eVncNXYNaHUYst+yP+sSZEbQbjVPEs2jo8I882Sj4+QwIhwjoOrr7k37i9/D8+r5bZrWmYR4Rpwu/yE/xPY1SmeVcFJYT/jU5JjYsZwzHIKgPLOcixb2iI7Wq1h0/bv/89Ufvfu1X3vxKoEYJnoMR7KbPaEWFTxj07EMCY0XdRYPKK3ra0OUZvuHM6YhNqmHeo0QkFauUQKCyVbQzxByfJ7uiRSZ1YE1i2VjVEfsuiQ0RO49YddrPASEc2DNJdLGdm8QmuiEHwtYolsh5jilorQBu2GPXr/LGW4UiXPst82tkIT5D2+1Gj4mGCSq4aZm2ZB+W3sZw2nLnPGAVi6eWW+ZFyS0TpEiBzKcHGScjZEzu1ZQs2RaefIM6j0ODttkGIaQNCrRBddugziMDU921qvNoW7XVtgqhkVbNV8A0czINih1s4s0bNOMaNFNpUArX7NoShCpnS52qD9Gk6rW55YKRCzZg+L00219xi8qKUr1C1VJknz7E5q3B7xneB3mDIlq6FVvZOQp0fRrARzGmhsxkXob6oZXqd2nRbPppTpbTWjkubg7xB6rjq9BAD3S26GQq4rHkgFIFWBGSByhmvw6g3THMPmJkBynJndghYeUd3MH7HZM0B0HmPUGuRsiCPKea0nrqZr+BHFWXj9SjHLost9ISzVVoJJLmaOmIi0F1zlnjkP8rIjAYUNYbDLjjkAyJWh1icX82YZrWYhqqHoLN4gZVXvACbaCdG0K9yyiwLlCoFFtEUPExZHkW9HhWKSMzVHbv97NRZJivl3ulhlhUuV9YtnkiUMs+oIrPajgtj/TmZRG7e7LYvT1vqry6bq5647lHL9Te5Zn3ozZwzAbudbda5Uro++TJn/j6PGiuzz7ojV2ffcBkvNM3JR2ygVvw6UZFpTawKrWHQlzDD51KrWlVZAJ32cAAgbDiDTTiu5X2/eBecsEre24hfQjbeu1xYgrK8HphbZf6wCMRzlfvtCf2Trte3GZvyuTpITpQFUGAyu972XtNtkG0lhup0Llmx1nefj4zuERtPe3JIzz25no7/CMR+Hut7s1aDkBUib29jH2bi5UDEMTWxmP6B8O17FbdlcTmWqu26XLZEeg33zmioh0w9q2VrH5IRvvoSHosDGaBqJOCuFLaGhppa+SkrbGRttZl55f0PUpE2toQmX/eRA1IcpJWaCeOSVtnsFZ3pklbY6qrtDWklrjCj8akreF0aSuU89Y0MZ9Tx9cE/1dg5/GYo1nKqtLWBEJZBCSLEjN7RcXoUEWKT3Oq/TADJJvt3xQZ2xW/qV+IWyLdkc4JkZ0nfh4dbSi8Sw0JKSC/nfGUAf/O4mURvpxAqfTURPgTKZQlsxO9H5UUIQdA29k0xyxWhjkkFXMoOwME5/jHun4JcRKRwdtNRg1zR1sJZRuRbWohS8u6WU/HpYrp71k3oyJQVdqOF3HpN+lyFLmCiVybux+d+sFJuSLFh+HYhyfhlvQvpyr3a2VSKHRsfwulQtnc6mZ/sTR0mey1ta3rBbUB3qHSWYFGiM5xCHLSAEWHRThaOLSaT1R8PFa8RzAoGQGIEYWmFr+F/oV5KGoKAFhsARZQrCAr4rHKI4inT9yAaLQBRQT9RrBbHEBFo9AdF0YvpZE5F/DkGeDpSNPu/UXDZiZusxUZOmbgzQ8FAGZT9Xe6YkPjQJH2ieOsrKC/c43cy0VQLYizL5ttW4wpgoOCXBWgYat7Iw9Lbi17E6oHJYMUnpobTg8CV/CzN+PG2AXO1HAT3AH/yCRR0UPHys8yqQve0Wa1rrk+Tng6+UKw1zZlHnftvRdzE2iBmzSH9uAsAXrGmLghZq05r7R1tlBnSypkggK/RfMAyjzhaMaJLTrqkK+Qs92ircILfkizVXqTh1JTWK0DhbftMDaq6uO7qEEpLoU1qIP7Plg5QUAbUL+IVAs9X+TXoeqTL0BsJMeMIDQq/dDMCT8yo02+IoqV4ssJP7sh+Ch4WIXb5cZ1Lutlv+20LXdzSusA+wyAhHBJNeakNIqBCpn6h8099d8nFDMTZACt1dFYENTPWxj5GQyJ4waXgwl2Dc77ejQDydKykV819sJ3dAu+o6oePRWYyttUsGbGYM2wAuWwcn4TGpiDrW/RAkjvciV52Y5ujNF13eGGz/YVv4q5/fm8AINiQW65n6f91IPMjOtcsLgFOs+DXx10mh9BLHi9x/KwgGTGMTRgVhuQSqFFUwWTTbku4NgQBmkRWf/ZOgRj/nVDisf86zpYGJFFOMxnqhAqQuNfd8aUHI771w1O0rNu6DzrhhQe17Nu6BzZlu50jfb2Zt50Q+luwJS2Kls1znRn1JlusUzLg4pD3RlxqDsz7lCX+08z4N/y0Di0beqBVpsasptRNWlQiQOC/Sqr0jxNl+cw8qg5j5FsKswpJ07dLG9dQYtMtaIt1VTNafRsrYzAdmWLNEyjJGgrTlQvu1jBRRI0L0G903I9yLl61KxkKWFLUwCtbstQSLHK+GdmwCpb2dmfz4m/joLF0qzsQj0gPjt3xCPRG2/A4mu48q0c0NmRkC8uPq4pBPuRuWDE57mAOZhRKqF59T2ZqU6M8Q8i6D/P0BJP/flMy6t60HUIHVIGRnRGVOqOYDDbSm0XeGnhUZ4ZUDRw9rIpvHVIC8qrgVZnOisztGcej3lqwoh8Uz0+UkKisTqHxxz5UPTxKcVbaiftamVNSITh3XfD3b/9wt3/7T5d3w2V2UZ1Wh7m20vMveuioYa1ZQVPSlJiI7pIOYVOppcX1ISMYgdneMWzxA3NKy+teEmEG0ZowyiJgso8ZAvqnyUjYyP8kux3lHEDM5Pwmlj4DKFKEwPkutHT8edOKpFbxfsV+Swe35nPSUl5U4dKHULw7w50nFdf2iEi+1jsAMyhH21hjeHATiljPwGpDYVA0sywHIdiAeMyzfxZqyeZhwwic/8elbV1+W5Wv0FpTvloHuSYWhilljo8EG2RZdS47G4A5dEIbqmKlq9brlEpxiw14W+pbJlN5V71ICHijqGdgkjARmptrEubsVO8jUKjxAEhFURQM4LY3EAf2Gca3VEtTbSTKa58DUqF/ErWU8o0ZyZgpVxUcPjVwLSYubJo9fIMxRMHQsd3vEzXwFQ/lcOJA/CyCG8+wA3dQTsh0pDYcSjGaJiHliy0Sql8U2kAag/dWNwKi0ibs1O1KlaDsTXX8iks7bId9oqmuWJNXDm3ALu5mTuEEAyGBg24x4kyXyCwBaA1GIrYzAmzjg5AAIYjoq6htHLAObsw+jRQrfF8mTyMjWpsqBZao7+7tH3qszLEpEJH94WXlZeFSd6x4xCfSj2Y0tL9gK8iT4SsyJMCTOZgxEY0PmSSY/Qr8LYfouIIWm4nLOYFWow57u8goBceIN01MdnvKo/Hkb/wiZ//RE0OmF2HpPmB7nM84j8+X/555ONa+HHGpb3soyigbOCjb132MT3Y/VzUELU+s0uJqzuVg/7+oq7gt2dnPvnDPBGiE6ENDTxqBVSi3DytKgzJRWg3+FjarR4meXr5YiPv6DWXjF3C5LMI3+jlc3JqLp45FyrlQT3rWfmii4FvsDp8K8ZGwFLHeRxFOCub54dQA4g+mvoygLGOIf86FUsX5LvEqciYYXUgZbEv3PXy35W9h/yigRNQvtyopTNy/uoRlDUY8V1rr+5GcjXduaCJjJ/xGC3E93OUSbs5zP0UMq81wFxihlfdvWiZiZYZokxS4iS6SItAcMwdrUKLR0UUcXGwuOGaDEgIUMUBMV43bTAt87hgL4B5MQZXuQxCSzhhbVFa1qZy/NZYOeCaZR2Q5zx4bawyon6qB7EJHwbkKV5aqvaWyvRNqpcZRX2Wf0BaiiXiilkqfgfHqFCeWk50LirRwwEsc6LFpR+NL3s+bjmr+M1qXpI/ejCgGhhGOOeNphXRqAQqHHnVr+6ZKBFWA26Dxyu9JKnZjk4WzvC/rYiIHxDMUyhP2LpjquEqrgQZU8HtV5qhQU3UbwfpfzLmWg4r1QSpq5FXtYIHU7HkM62swYxj4QNh+CdxeUTRi2obBT8HBV6OcMl3Rl59VCtMBS32ZmuIXrkW4e6ptyHHogCJ7iWGbouQ11XNamwf5ZM3to9y1z7VB7/QI/IruOKbfVSileT++D4q0oST3E35bjflk3/c3ZSfUuyIQbmhGuLk0a3ogwHFrrnaliN5JP13lhiBVBO9BkgSzSTx388s3knAIx6BRyIiggo8YguP+PjwiCk+eXjEDI/E7S4pIotSydEhGuVP7nt8sXQz5C4Y7v3cvcIobxS2P1/m5vpusqOYIdok2A2M467DDMZQJhgTto319Icfdy3KxFwXPN0X3d6As1X0KX/vBPqU/xQE8XX1azdTOAxKRUavHxwANyDeSYn/+GQi0p2DyPbqEIzsz5PKmaxDhqYLppBCj+jwkkuldH1YNB280wqkUwdpXFgApNvkE/9d2UPEYAirBhY8qs5v2fWFvUPO0hhAFUuMcQyUFxBnlyq3CkWK4FoS8vLPm6F1rsmdRnOLmH2UuBl8j2qLGdHmwYaTlwYsITXq2LpQw3NMDQmFa2JINOZL3tlYddn06rINW1+7rK8t9UEiaOpocWzeQhyqxyKI8aC0LF3vk4kuob2Nm54itxjF4LWxwaebRKwBYNpE4S/9kWAzXWZ3QzmwKsmQIkbMsTq+WOPCy0xcxK8H+tBExXWkq/mNg7JeVRRhA1WEbflQ0/skM5wei9fJ12MLTqRAONFPIIVC5UhZ0zFSbek/0jMDcfd0snWGWifaO6plzfqVXv8lL4TwM4/sRIiQu6JrLScdVV1rz+hauzv8OD7Vh7uom31cDhv19kkkrDfSUJdePx/Twv6Ecsi3eUEgHHJ5qRdDGCEEEyUROoSBtUl5rCY9bHavVCDBuSoU66G+h6tRWGFEd0P31roNAqsX2c1bAyt2w+zaYlyXqgOl6uaiS3peVZVSkEq7XL09P3EZIXVqnrIJgZrmx8bVPO+Zruape5lkQh35fSevYwv0VB1bRbVJHVvk0W2QU7NV5AsU+Zya7e+Pqtla0hwb0hyBOE9TuA1ximPwLLDHFAEoRUXtNjye2m3MUUF5vbyl2reJPkJ5IC07dly12z9A6qNUP//DcfVzdKZUP8fLmPr53mnq5wWmKCPK2qPQQVddXx3Gqq4vWqK6vo+uZ598pD3bXfYszD6Fj78OPfneqvjhsdiIKEJjJUIsiYDp4Y+c6rSbk64RXduIF3qhzHeVCwf2umN540ruO8rT1yfsCR3ANMCMi5mdEMw2CRRhIul79ieqxybENVbqcns9SJnyLVwnltNU6fh5ei1U786WfhIha6QIOhN1PZbDGaHs8hMEd6rtReMloKXqFAK3lFpmJ1RgGyIULABJAH2FfMlcwoTcANZm8xmK8o4coHjUlkFGsnmwAzAY0TKmaWfwmKEOaKgqfYZUxzG6iiPRS3Uz7GuVcK4Io6s/dVURU8ZbozakEdLnOQrVBSOiZ0Q5U2BS1Ek+oJm1It1fGHWCBZxw8ZZqERk7+9fyJTEBm+J1mYXtXQFGsYUrlqzUYvZkBf2kDic3sHH9Kt8quCbvcT8X93OZ8I9OdRQQ7YfIH6Dehv5QWxytrRUGTttt5P7+D61pVFOiav3YvBMX9LXaZeLdNZSsRUGzcMSQ4O25vWIH1TVrTGjkir7sFPaFq0oVXj3FwholHElzz10hwiVeGZ6U2pet0AzPAB0CPDtyobzgfqhwz6Od0MilZRzOzK9lf6ozF/BA8V2KaMcBDGQDCutSLCbzzHEHWw9UW8YQP6CLspZGylrdvKxrpyIO7jsqdibcT3kUynXl/FLnvNtzfvIkkHLjatNKAcsMipsxKKfsAyUG0Nj468KznSIMYoO2AREIb0R8noNhNK5dAp2dl3reKwzfETgtDtObIkIDQpKHhwZ49qJjiE6G5KM5PkqazpjWxhnTI3BD61/rtBii6gX1u/zC3T45C0BwFxusaqJq02SqlbFQ1Lkf+imq9oz2U80ye7Jt72cwNxSB0BNFasCpDtN2x2ov5PuN/fClkG5SJFfud0roLA511fgkKoA5ZD2YMbQSPFYXy8yfyzKTiKocZGXYOIpDFyOHtuQh0nNElN0CPKLsZ7BqgBdALEozNmU46TMGieuyIOBhLNIEagtFw8IMysXpgBK1r9IQXfUAzSAOcKx+YLYP+hGaF5FWrHp03DwnIz++b+QXTPeNrJZVq55mry5ioXbO0+wVztPsyx6zp9kvjpqSiKtmRg0U/2KqLdC63FIdMTZad8ZG65PGRl26pAKQj7gaYHJnrfzkPmd4lKGQfdYZHq3L2KphAYx7kv2UWgMVXUs0UPOp/iGsjN6LZR78rZoZHcGZyF3eGjUzGnLThlJwpE64kD2v85PCUTOjsVNm+6VmBOn+6nVBRY/Xc7tL9Yw2Zubybc7M5YYzc/kuBJ2EX/d8LDsEUoG8GwaJ+7SAjmUyVTHlKeYlUS6N+zDWp5xBWBpmriHUrJTLV41NC6QcCvkr5vxStqFD6dk1NmJdoxR0pFXSGey+1N0WPiw8iCckbyHXmRrIf64cqLax/GBN0qNMqWIVybvVCj618pg6xriBcC0oXOXxlrBbAwTuRnZ5IItGotRWv/4SaH5CNwrn63PU1hMNaKvQ7AFk3CsNWkQLduVLfU9k+V3+2yKXrVdkU8qwPyjaxovU7cecv8e1zMnK1gNz4Oc15OW/rVz0CrcKX3aUhjOnsEpb+4mwBygtj7maGXNc7dN28ridawW8/Ozm+xtHMUPwQvxyl33J+GWgL3rNg4XK27QCcY9Pivo455atv3jFJ/JFPaNmHeNbN/jKCtjzEY8bPMOoJ72YkdvkNTktBusj7A74htZzylV9hYPa92142y8+42Pu+Iz0aButULz26DqFa2ETnQLUHnm/0CdwErFw37Rd5+c8bZFRiSsAcxWgPLG+rSWj2GC82C6K7dKyQizJt3BJywqxecYTVefgxywt6Kk+8LEAtUllOrQDbCE8oNyzc09A3s7jKXr4eU7cQFIjZJRTjGdRPPxFj4qH/8nTfueETa3OhEw5HR86taivFaQMhbafThaeU4WK7AAs+p5BSBJQ7uAQ6BED68Vyc2QHefwqcOMAOCt0KKI2OnKundysZIv3vQxNRO2hBoeynxRXDTtwhEQ7WOMoSI10juoyKiBKnrN48h982HaobLWwSa1ut0IKlYHII7wq47IGBX3nIaMq/0vf4XlRxRRgrGtIXY1URWeLZD8QaghxBEhoE0NZNQ/YFNXxxrcieHbtbdBW/5p3DV51aeFHnH2uajgwLg0HxnhVkw8wHBgjwhkOxAusOY8aDrwMVu/utoYD4/7t1lhUjAyhDLeaw1E7O9KN7H5rTJSkOgbHhB3Bv3wUdgT/j7P19+40Zikb+45rXus5vvmoV2Gc+9hFg6oLh8wm46uKqFePvr5AM13hjLs/T20GykVhtd2Ux/JM8jqQ70KgiMgW7sSzbq3Rx8YavXgRUFuCkFDpjRmAgqe0PL/gMU5G4Cb45rH4JhU5mLhMi6DWlv0tvjVZ7acNm4NvqAhn26xYDE8RvSHRLRwf60ECqTuykhyIjcdeqRe1k9dBPbjd/6vqdKBIs79D1eIYqcgGNLPvY0+97vvfMvgc1zFLaWnDfCj79w094ZqmE7bv2y/74G/dty3ey4cbc9nfynXuRHtHMBWNwlzz5zUHuI6FjaJtUi5nxrehV0U3uIdtnHyIdAD3Rjf2vXzhF7/1z3/oxmqtxeJw4HrbtjWwskx7MhrnuY6tprAHjSUoHkjfmPXilgzdZymsXh8plihbf3OlRr5ClrG958LvkTiqWdgYMuAz4vfFoe0IWHWrVyaDgD3U2OCw7S6u3HUdCuT4u7L3fPWj+ICxlIXI5/MK9Or6pdfkvnU95Av3+6A3Zv0OjlvFh56nHORDsktRw3fZ+280JeLkZcmNB3XQ/FnR9JjjYPZFVC290+s+GUI+l4OzM18FV5LYh8wIBHofngc4cDUCOGpj/DpauwwtRcu5s/0k+7GDFi/OXVNoWB3p9ew9SKMIaejTQ6+HXPFdgqU1Ib+XYA8FgXSwV0mrlcfjIyz0/d9+A755R+Wb55XfXD76jfRBW1bTDamfbWgL5LX/8dePl0VlWd3x+vtdtaDFerZ1EcJqkeFokW96VEUqIEW11xUIap8derUraXdZ0q6JkuCoMcJeQfb32ZdvlCKgdauJ/ffcgIa9WW+2a0r2JbP+1ayV/+nEhToUZH8vG18MgjdmLfH2adYSJ2KxOKpMGRLoKdafsXMUK4pf0H2i25H9ujfyhTuV9jA3xICrMx+I2C9Mjb3Xxar9QYn9+NTYu6eW8L6pee+ayOtlP64u7nzXCUxlB4N/8f2EFzq3emPNHLUWV0QSVvKiNn/1hlppLCmPdZ7r/hcLWh6pEemibsvp2s2j2TnCpQ9s/5GnrpAKZa2shbmGtqaJ8hOowyZSu5rYd/UnYoEO3mYQ1/YRJdyRbt41v3w2I1/UCZlTZIayJzbgEXEgwnkeAqCKWpZHWBa1b3KbL9VqTXua6CT/pa52JnToZkxJ3sCV3AxdtlAAlzbarzS9J/ArXpBoxIWzEWqpc+GK81+uQa8YecKyGrsTXwYSnOd/z8nk/Qd7UvM8iKey0v83rDSEx1l1cyczwgGK2wd4oG5VrSGnQeJrcaWGzLBUsBnsO7iyPf7aLzz9qOgnbXJzQcsmX52DOi0bcq9wOKoXGRK9yFDRUKLE1XyEkvG7DHXyiP94Z+Glrs3TWpMLDsRQqorgG4X7+z0/8uF/2PU9f8dgg7IS7pORpUd++n3TSQuZRTP7R4xByc39E95Q75hZ0ppettbbCWD0qsTote0Aip+p1oOinFgu7r/VW1PWThk9WZEfBE3I65yqGwJwfIwacfagcP+Jtg17GZWFhviRW0xJaVYOEx3j4W7WwgwBUvRoCNqOKSMaTuR044U0nB1lYCYg0BE7nXp79gi11h8K8iyVmnCBNpMJDzIxa2q1zU2gRi53fmeNuT/iwGU9bv9XSh8fRVNKAtdkz5c4+yyCII5cBaRAbdygdycP2tcMZeshR8y3xNekFVKjQk6bctAmoDZJexhyPVz3yOe0qdfqVusl6qErLDJtWVtFiLgqYS4kNzna3kSmGmTqaOGsxGJPvLAmYs+ZDbDdzp0C7Ay0VKG/rbdtGSEF9vfXx4GvpS0A2jJi6BwWZ7EBSD4XK7JxZaG1odRhkIiCuh6j4bQns7bNNax6yroffRl+XgL8Al8Q236cy0FXN27Ax6Bpu0hsCdIihI8Lz3lxsXhh7RIo7uJc4OprijZ8n0vtHcTSAi324CQd4c5++EiPcR16LzyRZf+sk0Sr5AG3W6EFwyjGsNnUPiDywjbDSK1uogvUzv4OXVZV2i/LjSK126g3DeRTxYUO7pvNKS62FTOz1NxARkEVrCEtzM3u1bXsXzRorImtInS6H54fEGaE4kui+CLwhC1gDJCjAOfyhULtoRWYgvsslqtxIE0Ts/2XrYpPqPZ0O89SCABRN5uryKnTGT3HfASO2slZLNoptYACZ4CtCwIKDlV01UaWA1BLnfNyt0ORYtGJZhkL16GVhVuWivYzjJ16pQHLrtlg6NeIllscmZ3IcxiIOZJudsqx0C1DVszozmGeu25NIS3hoQCYYWvARaa3T+fwtgc/5xbpGoiBTEDUQCnCizKHfEN6QO5wvFi5b5tCopzK9VTADt/yw3w2kTtD7kxzA514yLm18yrL0XUh1HVhysarYTZdbbPpyoCIbtOFOTaOSLGiptB9ZQ4xQUdfm/r6FfOajL7WR17RQrMQrar5xk/ghbm4d33iepb/J1KVlx6Ow/C6ENbfqs6qQv1UzGPpEEVmzkZ2cxeZzZ3B+hA5PdmhZ196tcYczKCscYcKusRLDAh0Jn7sd/bNSscRENaExJFU0cgtGZijF9t7ZRdTXcxIuLu0suZF7qtUvYCt4T5E1YPCsCxi6G7UjmsWqo79QbGFqisJWMVKnsQoivUzZJGTGSHBIP8HzO3htj37aDFSQgSsRqhaG3lj1B5QNvW+cKdHjXXcgXJ9RLV5hLOT0X5GEDmMdJI/rfROld5GO+mOVahOM9CuzCrJWXnSX95Jz1RBZUFMzGKZL135JAjJCTE/ideFFiAvB1OQDmYPvca5OXxYjwQFGKrk19a9yIirfhCJVU1WbJhM3ldJvmQyeU8l+aLJ5LMqyburyRRWPF29xSsd12RfRcMn7VJQoCnHsUXhMp2U/QkKNfNJ2Jy4MwrCayFIHzsuZNhOXA9wjqa40A2nLo/bEEa4949wOVjdE2AYKbY8ezDJs0cUDI+463RHh2Nce0DBJH8eKAiMNQgnSiyiiqWLusK30jQ5VEvEqZs32t9N++lV+9mg8b41jtu3xmPoG3pCHlR35B4q2Q7p9sNTo9B1YAHuX4z3EzttxYlv6J7Kjgx9LRI+eJb5zQH0aRJT7/K9eLp1FKc06jY+harWqUNQY1G9TpHewNDVDeSX4xIwRolRqENhRlVU9FKzrynhGatCjYTH1vtKXauJ9KQotkxUARNF1g2E+VSPU/zS80B2UE696mhEvfRCOlpdUZedot5F81StQz2M6MlJS5uqa3XFPs6VQnpUk80XlqsISv0HlbSybVy54ahgZtQqd3GqEYl2+k6DD62H9qRTcfpvnn8cI8/Xv7Z6FRJ7H65GOwYuSaFtzF0jw7VrhaeSk9CYfT4ceNG0Ua/q2hvF9Ei2i/GIrn3ERzkcC1mx2JHbr20wJ4IyT0LVA1Z7RCNtiFTj3tki94GrsC1s7q+WtoWj0rZwrBr3f3FDqfQ8Um/9xPVCeQgtH9W6j5l67889I6JHkRRW9O1jNLeqb6/CvarJ4VBKFcDqowZdmRucvn2s+vaRDJQekQVVTejPIm8tfc3jfFmHF0t0hAIOVC/p/Mhrj39J51Eq1j/R86br58KETHazIqwq4xoU/3wrDOV2QXLtVETUzUdoOFudYBXuqs6vibG6v4BJBOJKDT7tQEx3zfiopzrOZ0CPKITVC3G5+AMvzvGK7YJxUVy5M4TdJQsLNhfhwTHvC8BTQDZhtIZyYPTJn7iJCMidcr6MDzkrLRjtZGhTvlaxCKBXcFK2zuuimpif1WVIlZdj8rRJFKtJiqJTvX6YTTXj0pww49J0DZxVawTDnH+q52w0I9ftZrW6vCknYZXrdjP2ut3M8a/bzeAeUtF01+2a1Nz0ut0MX7drptSZev0wkw/d9cPO5PXDGel/Z/r1w6pa1qxmctcPTwyPzgg8ZgGPTgUeHQuPzvHh0aHOycOjw/CYrQhiZ2i2ev0Qn05wDE1BJkyVwRAupa/AcaPTbTShfXsHEPsP+ZyZLXLrRba2la+ib+ovZaOobz4FqsjdccGZxyj8Bl5vJvyescJvf1T47V7JtyxYNsmCZVXhdzYu/PYZvvzHFGamCvMpreEMcqFP2uNN5xY7VHfoChsoFfbfG4GKR5xqW92ZbDUjGnBhU8aRUWqihXrVD2c3ncFAkWCW2q5BVB86WMCr+aB8HdF4ZeTQ1bTSmbyp3sWgwqTM4kZhk3dK0UzrfNmmBQSyHcI8QsUmfbgh1jISitWU5gMqvtA7onMg4dalE7Dw0nGbhveGXlS9tG1WOCwSwfhVbVj6wCWRyava8SO/qh0oOwaDYqNXk0OhDUHlqnbVrFh5UZzC49MGbuzJX00O9ap2NJVWxmNXtaNJWhmq+YsTX9UONJOjlSeGRzQCj+Bf7ep6UJm3IQUnc1Xbt9f8Szf+w+enp8sGmayDTnWvA9b5v8M+19N/oO9lN4ALSh935zYq0sW0qPJ5rzo+nzfp8EIZ0epNyM8hYnOHFzf7XuPkbj4WIW+3nHcRv3Lz0fkW8cd9i+C89UHl/yE7rjs5JW4349aj7Tm5yiJh6LXcvGH5+pgiy9f72Kei/eTrzQQFjO4aPGronjBCBnmE8kBa9sUb3I3GYOJG4zsUfPdkQf26YMTRbaR5gr04QkbjPFyfq6vXuET2KGiqbh71P4s8RXMmjuOa5wdharUtC7ulQzi1RnTNzeimeeepGWFR1141+dGKppdgvtAjh0CRMDZxRVtjXD3FjBzRU9tU0FQIAXr2Y2+sSelEk2QXpU3iOrWwmhaG1qaa5PKa0keaS9BFCF0L5KMwVWhWeqrYWO2k66Y30c242k3TNiid5p7w93q72tTZkiZ4Tt0TzRc9B9cpTUxcokY4HREppVqDy86diXP+IqC02nEAwkE00LwJ+IFyDBLXs5btazr6TVq5RtqaMlLB2EgJDYH2vxIH3FcVUJOf3QhK0/IxlM3+8rcJ3EK9kmJEy69GDi0Cr69xH8SqZid008dDMrxW9G0UHmLe8NprRse0gUenOqao+3qcwSFsQZZNjG9zChp74JYAuwZleEzCu1atTr7Q8cSHU8fcxHIo02ySe6zdNFOpPMVpiDwDSiptdxibYsY2kTQ71q0QRU7pVpMyc+avtTertdtPs0q3tOUhPpzWLcSG2q1ZzYaWjzeYZlzl4MpM9wKqT+8WGjHeo2STHqXSBKprj/TjsR4lU3qUmA+n9iixPUI27T/aOtkjLQPbJO2RVj/WI+3TxCgp6KcTl9m8g7mRKlClFvS4ih12RPwqvUyrg4VSONnlnx0rxZXNv8Lqq2JITT9IHfUCHCdmT7r57KlVZ8/4RMOnE7PHzIfatNnj5pQFRW1k9qSjg8L5q7PHkJ4iVcNUPGXcITki3Bt6wNRHdyShoUyHQHhyVK5HjSb6dYhWmzMBRWKD1ZerCy1Lvpqc6/XycSykKIQNMs9GPlMJvFxA4EHCE/dxMZ76LaCk7KF8m4tESVvh9jB/EsZqTlv/0BAV0JJfXbqMQalIl8tEY9X7xSgJTBUL69QQWOQJmqNLObgkPKLRNdcWEU+SwvJDMckqY6plu1XQUMTEsSQkTXeNpFRK9JAHrJpmauZJKh0KxtpiP9PtvMWSZFrBriPuC63GfOjg5bo68cVI47VN4dhHwcRHpkWhrSYY/UIbGo52JdGuhJWuBGNdSUa7EkyOmj/WlaD6hTL05sM0vdsLIsGryiYGSBxoWFdetaMakTlk0IMapIVF3SJVgpiJ2qLcB3+LWteslQiIZVBN7gPv5DuscD7ugjVGSmhjfvNnuveqC25EeI8Ya32KTUNVrDz0guAkeqI9CNEIXQcjZ5DOnwKvUC6sGb6/BsZdyUtRx20szOCJJtcpQlPxKYUjbfxz34tc+wy3X4Tg96O+f4lERcTvL2VatibaAKpgE7Plpr7/wjzUthAMyr1ByEaIXGFpqJ48UUm7CWk41gwr2sj4Wt2N6GQ2h23OtVJtAr9CMpep6voIcDkme6OUjr45D9RouXRBGfEYDRWSoGJm/Tb7YXyp1+DrUrRc5y29Rca2Oj2/w3qs2yHboVjKRk3fhuNHNdlYV0sX6iX1A37gy+kC6h3dDbjZBimPtLOyLCi+aMvjwie1CCUxhOwoyoFG78kLOmkqGjyaRYEiBdU0l9t8uUormQgpuoUVc0pucwroj1dU1KtVjVdQxJUqUH6p2aWzzYorFPAg/3plLP1tP/DE4SQFbs9YhV3OGKAH4jDPVNdZiBOzQEZtBKUi1A56a1zr43BYD3UDbQY64jIbsGIAVE1jei7tia+5iga/K1741uuKng8ZKm+BF2hL48kGjjanSEarQi0AnqkjLScUHgZ8gKpWFir+Ni6shekfJUEoEoG+lwf+lE3+TBxFY1t8X4dQT9ttQ/yJ1Td05r+AIn2vM72IKm9A/tjmN0GMq0gsMujENDXE7iKg/Tgca1M00SY8QtMm9ZrtOAFV79E0l9uUP9Jg4R8C1wb7lVKXyHVWWf9RHmi8sa6nXrWn2jrlgfQYTw91tVLDw3juckfsmFbXLSQmLtHk1qIcl+VqcNlDoc+YnFG154CEA6qveRN7xKz9dT2ru2Vs5JtIqwm1I5OD5U8M1vH3+aMoFmor/FGoh1UZkrIEm+OX50QefgXarlm+ArQCa+2VS0KEGxmUMJEtTKUnRWwZAohKxdR6YnTuQxKK0HIANZdr/eo6mGIC69orfIyvgxsIHyOsvXyHeReAj4lGSmhbviXA5rElvC2kotwKrISgS9y+Tmq97se5IVa+2Fzz1GCAfJ3+iO+Hek/b1+XWB2vAvkC5erx6Zog8tFWd0BQikh6300uSAy/9pLoOcuNNxiIezaqxjuXD1FGoaGI5wwtumEd+Hmi9phWRvEVTWuGfXCsSJf22K8oQpm+u8H2BgqSCphQY8EgLC3+EroZT1suijlqkW35uRMFqUoeS3CMt8rpNi6zLkq4ObznwHt+PjjdaavmcoZPHduQwmQAlbhf53250U+pA8jHIIc4bjePjyDh1mUdbVh1DtzscH0O7qhQextBD+wJpn4IX+C2tCo7TqmBaqxh/N2lZw46rdkc3gelPeayfRr4yvkAlsw9RCyUVuGHOyofcq9BYnlEARgSYQ5gKasEPs8YQMlbajIiEPx9l33i8sYERBhUDY7ZNzxZlpvRXTt7847Faaf/xXZ/76JYp5h+RZ8L+4zs5L4Py1nd+ruWsPx5+bdX6o9X1iVTbZxM36/27rnuhWJL5+rpb/9HXHs/u45uQWkv/+6Oxjvhj+LZqHRG9ceYR8TZuH7E/1fIjPnyMph8xglVThSjS2ir8u5WkzddBdUMdXtu6Lnq59SvgueuJqCnXFTSPLCbgyFrbwxLIzPYJ17qJf/YZBfaiobI7ROUpBbibjTyamkNxcddITJtjVjWmHx+QpW5NklQ9AvFFR/2eXyc2gGSLTJ2NPBt3nTYrG5JZqo24Tsuc6zRBUNhEEJvruiOldukfDc5zlWObN7dDFiuaNKpE6SIyuaVUw6K9KEwRLrvgqsYgz1KtCY3JhlDPUf1kNRQzRwvOVQrNwrWBdbTVQQZl3yAmnEHTlhjRxnqq1oisIptuW2BQqaYyv/ouRBirStS1LFAGjF3m9/ClIwCqQzXMAAlNz1zjsqqfdwdvcsGretok55cdgDHqdij63CktmbUt6VyzsfklC84nHoF35VvwoHyFMpPQO2EVqydZxWrKhf6odt3A21eF3mIriu/RCg/iluEAw5jxyxZaxcsW5MnyGh6wHbqUz9NWMWE4T7OCCwPgwpDz18qXgQw1MIMRB48SI51ZQ3RVXIfqoGYypJVrHxw9W7l85dI4nmaH6xhBbrlHW6VVKhrKpBHDUacYtgWo2td97Vg9JObbt4zXsuWIraWGN+dDGTCarPYOmj0ynKwQfV2ireouVOf5tn4Ec1g6JUmn+gIgvJrn3J5tcvZel9O7bbhgKAiwHXZIjL3nrZJE28C/FPvzHQhdk++kBSpQT34KbedQyKFTeQadxn+7sLVWYg80t8/idLZ2dDkFhCc23zmdhsYV1iTV1RSUtqqu4H7skn5ITHE6nQ4LTGeQZLavZ3L7CtVBhbP+OVrUArn6Wni1XLjU8BUczjh9mzrIL2qSz5e0yyWfhvdKvgWyHIHQnocX8rNwq3Is7mwK+g/UAH1VumWOl3HwzPx0Gaea2Lc6nc5mG1IwH5Xym8/vZ/E7+Ui0sfOAZ0e8RmthR1EYiCedkZ9OwGCu24ML7MIK3XZiUE6lUwEM7ax2hcvU/mpv1G6Vta11SrVDJ9V4NJaHzTX/Ebc8pR35IjeY0UYFYttxj1XGqOYa70YOca4TMvajndjuxlDK8dUJkHafyzEjWy2HV7CJcr5xx3ibynRP47f8NNqFDeEu2moFedvUXPA26hqvkLjBJmDtABzoNpdH1HH3L2crFAjWxNSBnpmHNRI/SlXrYxnV0Np5Y6mMV26uG7BZw9IrVEfvpNmmdvHWpdQi5xLaOENL4MmWqhe+hAgphWlTDcm1keRWmdyaSBZqli+YZVkNGYb4qYk5ojuyN8gqvk2W3nynjhvDacHeAtxqp80CbgHO8aP+EiFZS/wHE8HCZREoHkreirZs34/1H7WNk0UdCKKltXwXWqGW3U4LgOmn0TYdnIJ25R2lTTD3iy+KEsXyTIzpLogPWV/xiaNhqag0kj+6oM2DyM+7G9adEZSh7YjbLohTnKZx0kAdSdpmLHjPoRm8Vq5JF/GcM1cgaG5iKTkVNp1zlJjTTju+W8th2jp9mAqB7TaF9GlmKBZI71WPjVgxpwOk40D8t9OOBdYndQx7/LHQLuVE8FkYiq9IswptpV00Z8dix9dtLLZVxmLOjMVpGItdiNulcdJAnX00l89LM05TyRX6B+vWp9mB2CY1oYyRmggxRDtR6k698aogMsOxtNmsSRWghofdV2wr58F2nQcFps0uJKqVTizjHcbeRX7OOYidRgXozEsP0BwzgciJhi7mPkAHsAFeo7sCXNmtVTuxSNthBXQO9G1uhJKgM7vUfuku9GPXiEP8g+Xl6b/0PH+zTfizC78877ycfFeCJu+tJO+bTD63krxnMnlXJfmsajJ2knoDF9Z/7P1xRGZrpX2Sn3htxWC/KygcLajqYfvs6uUcO8oo1kjQxZ2e3bymX52Lm9fFL2dL9i9nD2B2DzoIShMnpXpk/yify5Ie49zrSTDB7WoNNkSnGqfaz4J6wmUvztGs+3nBQkewGraNMQ5fjQ90DJOWZ4Qn7k7gXMhE8wwX3i4m5eTmhbuLp/CHC8IfxoQnTnLw3W5+4guiaWY7Fzkl4xx41vq6z0jRxYwy8Ifz4N8RWEAitfJlaudd8mBy1vQd3m9x2d2jJZhRzVfYIl7eUxgpy409+hbqwU6q9gUDZ56AV416AF3R6z8YiMx2Jl+l5XwrdfNtwV5De3u2QsiJedJpBXghwydQTyug7RLxRWNpFZQuwyfzRBywmSeyaSPynrSpQK+kLah9q9auFWrtaMrXv3beiVwNs7bb+AHbvCzVK1a1VatoEb7h2AimTHOyjcIXprH4aoVz1I2VWl6JuI5ZES1gbAhnF/haWPta2b6ctuJtrIngarb3MboZl+Dl3Dk0chUkaLUfGHgVZcsKxgYOPqCNE/4Pk2c3+gmToFyYh6UGw0w91Jbn1FOu0CEKkbzvoB1oCBqHNgloBYrIsiJ7r3ETu1vR4FWAxbTgqGkBSQukL5wHkEU/CoC+sKBf7h8M1nLs1vHs0hZ5bqEm43nA9lGwmgZGXeIyKyHhNLiYvhRrSd7Ddn9iIgE6U2YiunvYN5P2oA084JnAvV45wVb7lfnFrd8u68YqTzCeeW6SZeUk2w4wEI9I3uNPtxNUMAhjlfFknRE8WMkLLqFWrKgVaMmmNfQEq7QmkpoWqGfRZBttNxVSbQxZwCIhX4Z8mpyVyRkR2rQVbcIgkAiN61zZVkEoKibaUTPt6G3Wjv4LHrem9AAibcoKplzNEgJtCpmmbBU0RzO9fCXYCwBOn2XbKrOMjj/LAObxmaazbAVxoBJqwJsajLYJt6GeE/X+75h5arQa8wuZl3AW0cuXoDFnd289aj7XrU65nVTYOoCNmiemw2LMe3s5FxbAf1FOOS2gC9tBtHuAjKSyYxGFfbEoRBzLtCScQguakC8QA4DmkLyT5k3uebyewrGaB9vmq0G3D1+n7KviQWWW9gRnZ7WcnOYn6Go5z3TUZ6U7C3b0HeZhTLduOqZuPLOx8XRDRmODhbitknOe5s1IZ3akt5Uj6RnMR/3TR1RHM6VIWBeKZaJBVqDhGocz8ZkCh/7W6tkgsGzphzwf3oX7nZyZuJFLYS4YumAkyjtiCvrABtk8V7B93mERwgW3Dw7Zr7qHldv91+kN9xGTwdZcsJMamrtKX7x4naJ9N248+S///i8vfNpw3w+97Pd//Myf9LmSUmqrX8K2xCD99SRsXue9Et2wZpxhRsIdYZBaP17NA3tBHvwuwl34woU3AqMOoIcwdXXkneCRyTlG/74hfB08iF+97N3MbgdnDBPPCVhNdcCMzWIOD3cp+yRRjWE1P6Bm7oNdJkwc7powjxa+5BapD8aW+raopk75SkvTr9SaeFskFPpx6u5r8qizyLzoUCASIrx1qSO3KyljYX5nvcxLnYqrZb36GtRqVz/dCPJ9uZeO1beTz+hZxEGP/zi9cmlZjiNh+LlyN5jFxDNqWpNRccS83QxsfN7tFx2IlmWsuBIN7dRQVDrgbmU/BZCrW/ZVmrkg0HxwgVG9oKpbjzZ6zdVRGx3O5EAGl2CLmUqHZ6odnhnvsGmO9nkm74z1eWa0z7i2Xrkfzn3uYJvtYCM9zk2POVEAoh0XlKo5XW1Y9W4plloExRF2QhPIeBw8rFXxEKBslZhDJkxCHVolpqmqiuJQNXoyuxajmFeTLnzjYt4k3iFSvDgYIjGT/l4zDnkPmvB5aFLuQ4u6mOo6mu7v772maJjMDQr3+O9K+BlcEGwk6p7lnvVR9ywfxbu6Z9EkuYL+cQTTviQK/ZGR34/fS4yfcWMGrdHnOMlXNNncIdc2hX9Nwa2iIQjcawPHbOBoYi1qt5TYtbGOoy4eG7+/BwKghqwpGT8PNtYkPCvbvzp1sIZrPNVZDoJE8jmIgFxKpjk8Fo7IYRYFtDBAaA6Kx3NUFyu/lr1ocPtr3FZ492iat3vxNrBvx/B22L4dxdvBJs1YLZMZdGNR5ch13nzxgPB+oL93reqQxfT7rtQEBjZw2AYO2sADTQs2GzhmA0ebImLLV1Bpl7osi0RoJ0I9swucpVW576m851YLJn3dBvgp7FKB3RzNCRuwjeaRpxZUOAGMQHMk11bqTeaq97MKOOdpBa3q4dGze8FEkjKFX1PF5ApavGTm5V68kHl5AC+7FeYMtsrLAC9kXg7jJTMvB/FS0yHJaAvPStPdJW41NaQnwthsozmgioS3g3/bKqRkGdl48wBmZ1yc8kHucbEN2QA8A5YpiM/nKfw5//wTmMutCG/lMF6lboQnoQYcyhdTEe9DRLws6ENdvGKzCYzdQotgkgzipRY0TTPTFDZNM90UOE0z5xQ6TZl41JFdSod8efqCtTHc/Vn/hm09hlDE8bKflqWtDgkuwc8Ys5hUs3RhI/sZJFOjdDnxNSbzD9apgYXiy3geZGWSB+oA/+kBnR8QQtaWq4bVlivCoMPBOmy0NqD9cjN6ycQJc4NLehcsOh7W8AbCN2n4LoQPSfg8/0Y1qB0rjme/IK0PKCldtDh/Zbvxs6eInb+yXc5f2d7H7K/sdWHoqfCwYl67aZm/6UQT1uwJzy41ISjTC1PZWwTI4sllwdyWBQMIJUjcYM/yNjUrTj/wNU5/OH1BQwzEjFQrllkxLRs2zLM/grVO2ORJqC6fOPd7Jy6Ry1nndA62gEZ6nw5XsIzqqNYTi1fi7B6piXkj/kwc+1EDRwVi+tgqvzZKRqMFTXi4VEKubIheHvOdBgfGlwEjFWQDQEeYIPvZtyCbyZPdpskpJVotL8UwaQ4ZZas8ywM7lh3RO2RcIa8XRIBUm2bugH0UeMNrMcrgZ89wCBStSaO8gjMhdpfbLSB9NzWduYBjQAX/WqCD3QiETpfJ2b6YCNSyDwBsubgR3fDziHhFP+qLrhPPq1tCCqYgEly2DDiJYnbBhmdEocPSwoavABx7Bfseusu4IVx/c5l4cC+54JU9x6M8xJpqt3N+bKn7sKUKca+05m7cNUDd99jA/TbwIAeE+eAnKMPH5cmf+Pq8xZf04DCeFu0+eN35wSHflDCwgbvMJ0fxPOajDXd70gbEvkTrOaDFXWG+uVxfM628pVkTCqoYjgK6IG3SM/69JRTj13009QsScwy/2U/IaUTAeJCHeOzOI70QtDrKb2rk5RoZgI59Z/UsSZMPVJKvriZrM7I/wPCv4IQ7NMiEwTyS/seqdfeq0X61vKdNz14nTVXXdl9im7hik0+S1Q7M2147ap3vJF16fozSkNE547+AUdrH37W+Y04beRPkd77KnCpTek+mTOlgjCm92TGlA8eU3o5gql/cNfbFW90Xd7kv3qZs7M1jbKxSNIBBUvI0GwpRcPO/ah1sxjKnHWVOs+cWs+2a8qVzoH1hAe27fIE7ecjD6Zvwqrp2o+OJhpeRdyHv4pHkWzjl3kxTViqVUSfvkQ/eDd6NaQ6e+DQrsc79NuSnVQ5a5pa5CjwIzC24FaIBQlvB3G6lFliFVsnccqD0ASgUdr6qqbWdSSZO62lLXlA334GKp5CTneBcsVYjMLCBwzZw0AYemDOBe23gmA0cnaMi30Y78lO4vlMhYqZTgWUt5Ut32g7r62mAhLKpCoWtKpGCKgC/TrKpcyO5dtIpk7la/cwBBooMOAw5BY9T6FQwPqcaNnVZ2VQVk+nLMbxk5uVevJC+cJerbGoGQJW8GN4GJS+WAWQlL4a3gwkt6QhRzkaReoCNdPsU7QwQSXGAx/tWEkxAaFCiAAb/qh5Gf3TYC2TFEb08d1CO1JzmwT9iPd2bbze4wWLXROrEm1ZGW6EUJOVfWWzrMU6hHg5sH6sFbch3oc0oEwJzWhLkXTzJcvaUxXBcSrvQke00gz8IPWhOONQ5WpXnKqWQKaXUw2j1KFM2daZcpl7AYrg77nCr8JuL7eZl715ywSt7Gq/7cBe8qvdQwNPNewnw6MBGfjrPFkx7XOQX/Z/9Jf1Yw1yDMO10Z/NpmFOFmEBPFxoPxL6tPAQxb8EobGc9fmYXtAC1wE4dtdeeZ2BhtzK7m/BwHMvWUN8Db3rVoZqiQrYu1NpluVuzPFjJ8lZkQThzrPsZyrpvN2PMpKLk2ukM4ckHCYKGKT+sL8qVH5QXsOXbmS2/M1Fu29K7OpaDcd6/Y3j/juX9JQB5Ufaz0p4Ixg429p39Lauf/8x5Kxc7O2jSznUeNto+KCi7E7nxMryAS/V5DIFnaMMuLnRjiHlAuAsl82A9+zGoyN6e/QQew2IX4UvatU50xOHEgDG/L0sHbXcteEgsa56i1L6F+ccuZ8/UpQPe1Xmk9jNirDFeZP98fSkEkXKKDgxxN6C2QvpJMbv/gGjNeRw1Sxm/hbD5tMfhR1ihwS5ILgjVkjNp9jnquOBYlvcqa8xiZSXZ8UgKJT/fUi4uWyjIfk4GpODmb2cYz/IzvCB4gJ+YjPfjSRcE987iqAUdW1E5Vk+veLCzDNZTw1l02lf19NVNFpATLw4auMsGBjZw2AYO8tmSrLmovQvVqm0I7UTIrik7xtaUYnI9wUpx4vXk4OO5niwqxdf1RF8O63qiLwO8kHm5q7qePKCaHg237FyhL7ogXa4vulTtlTHCnpBWIY7kx35uXgJae2kvn6cureJ6T6meBz00vJ/KNecKNgYuTlvzNU7Yn6+Ua0K+zMEHZpli4UjJ+Ao+lbZytuKUNVrmEH+/VeUpp9ECmeBZDCse+7z27ofniZ/eux9mAe3/4zPNWCH+8DQ6a1NRy2nmM35WPmtNQa6z6DRIWU6DiOUs2onwTiNxaanEpXJ0dQqQX3oCYZjPi9IpokvWD90CCVTPV1KVEWH5wWq1Sitm9eR5ke/C897ZnPB8cDYHZeJ5g4uoW2Sx2mKnCRS5O+JVt5ilM93diUyJzRwXOtmnfGfLEx2zu7Mc3mwzJUVy3p9WCEFRIQTLU4o5u5zsaTnZ+eBY5sJZPEFaetaNFfzs/CwccWvjdohIs82Yn5+lZph3oC9fhVnpa+SS2DwWMEElTHvk+7pO/UWZ+mhFl9ETjCSmfu6m/vLY1F/5hpj6RXXqF9WpX1SnfvHYp/6Ozac+dHJPMdxeCxwazeNcGN03E7ZVCkPP2XzGbmWInfPIpusUdDinMlnPGZ2sZ/EPkFD3MdvA620DqNHqU3D4z8CVKbijFJZegf3WfJ8gcc6lg7mZrSorTQ2unz2K62flZ6s6RypztcRvKJlwezjVOPeaUxYzoXaV01unSGBT8bk6GCKmRu0JsSASJYRDI448XXy2PcCSl2CdbWHTjJas7CudzoWHtL1SCpF58fGyy9l0rZRKERggl3o/p45XBT6KTURhswCODv6rIDq9BwqVwCawaBx8tgQv4tAlEtrDoX2U0Bk45VMkyn5e+TJXv9zBwSYUhfLZUFaoexgjB9HYj2dqZKJhYslKQrenF3netSJ2DUh8hdxRRBRB4BZBwrb7jiHVRNDGiRUZW/ZmtCO9BEqdIiHYMBICrgXc2bvw2kn7pPcKs2NC/lRkYPLWIHVBPg6kX/K9cIpIRW1Y/UFF2bRtAmERokOh6RD8g0Y4wUf5kbPiZ+/AjaZLKrDrEVQASU0HtgT+EJmtY0yW4eorDjxDUlvvonUdQmVATqShbLtWykN2ru3vv+wa8teMa9tQv5V7gn7/eva+Kq47pAmI0/u+6k6iVrEV4OG7TFxjZ5BKZR+XhujFU8meh/wsHUhgWxBVDQsfH+b3fr1hfu8jgfmfj8L8M98oMP+LRwrzgdr2Ca4DFPRIBqHySEbDeiTjZf8MMOa+eiq4yBjdz873z+Wgd75/FsT8F4qbNBUYqpmb4DxJgavWIuRttQ9vROhe+FNX4UL5GjvLQhF2On/QEsuD+CYrNGOdqVU2NVPEKYlWFhYRlMtxZx41wSMNiBunYV8G4HIUSAsucRMHLusZV/FI8HBRfL/YdvCRIO493u6Hnlg/ipgsYbEJ0CpS+10Byo64AyO73proXE1EJWvPQEi8G0OhRxzlo1HSfE1z/UPrNvgs6gh3GyjiNsYh74oTSgZFMjS+VtTugHjOTiqXG5vkV95SbbBWH/fvrD9LbYOgLQSmMMHNXkkmLn6oL4y1Pr82j1D9yLBs3ACJMfyzkm1J4/lij+tqHze1qWZP+jw9SZPDNfntrsPcAAYl+yiwFeBWIyN9Tw4JfbWbsou/xv39l0oxQf9iyEXKcsv1NN2PEzwv93WY3WKpYe17ERz5flTh6f2Tqg17zcvpaL2WASmCse9xBFfpePG5Qx38fJ8fsJRbVTKAB5ABq/0E+RCQVO0DTjMG0EI86kcUmuRj5RzIC4bNqHgVKFCRgY1toQ6nIeZ804XkA4nVAIziuTEPI+4t4XOc+/Wiwu8T8d9lPZloHL9zDTXD9hknq3vQItJb6ZFelQ9hcKCrNoEW1PFZJu7OzmXKQggJF7CKkHABLQntlqO9WJ3WkydqXtnvGzqKGgqtQU1j+ehpjTQsJm7MWNSpprZPiqCXi01p4gDHmg+UeOkn2sZEq1I/gWFFQab+fz78vvRvC7+/80fu/0TVRVj83L196joZy92XkYU4dgtxPLkQu3RJRRMfYSWgTp0188EvugU5oFr2S25Bjsl5lKIYC7K7Kkc1a9wk1syhKu0zXBKswLrkIi7W0YiFJ1D7Wf7EChxw4+5UpUj1QB4LevCTguoKPGKK9G0ecz1og7Yg0k7EZtnHkAV4JOQblFObg8pbcFKmHsoDsWthQl3C2qKO7Rg4dylXoBXgO13zQrxqZ2AYTGACoyrir1xeitA6HbO+iS5lBpvVfJWLZnK3YZ3ZR8gQSsekpWiG9iD7ZeG1/VE7VOleT5YJ8N1e9g5kgYElhamdlaLAaxZovKn1EWliAtUNdVuI8cVDGixwQ1imeM26k/IQwfEIB9bul4/CMHQJBVqB2vAcrSf9VvQ5M13GuDsTbloTCpCQuhywFmECiVKAMjzTt9eZk4hhVqnipSncXAVE1aOFtCjQFhQOGQPsFhWey7iADFTPrvfw6+/9xMPv/+inX3vDUU4Gs8XH+oRGZxv4UOy8wIVT4WNzdL+cGYS4R/ceRRUoRMaO44iZ48AujNmRih+SRLWxqyrYkQs2XLAJ39I48hVt7IQiqGE3BnlTnFjlQdU/Rh45NWy1tyN4nzrfGFHf+UZEPZDncJF5Y7NikL+fbNLMlgu2xSlua7SZrUHePlEzhR5bxmvPXl7e91b8ElbYkIjSjfURJzxUdcJDDU07UjSoMekuo0E1V2x0Mr58MGgT5Tg9dWoy20bt4UAVWPzs1zD6rpNFVOYlF2SxAVBMRZa+HnIE+3GJxVPk9yngo4pxEzAYp2AjbwJpZMi849o5AWsJNKwC3UGSmgOq65mQWuqg0Lix0VFRUznGR5q0FBIgtRPkqVmsJ8C/N2IqvgrD6gXRRf5x9K2W/YmQ623TYkER9aLo7ul+9rFQ4a5j9m5dmBz532N8h5S3a30nKAHR0khv4jJryrGVet/hR2rKGtTFzRWvX5/0oOMNwbtWcNlz99KRv59Ur1J406aNmnTVKxY8V7yRCxbRACwRpky4WTUlUpZYS4HFfY+8Sdz3pl7JwE0JJYUVZbBg37OW/8tL/uCZP8thj+LheulXWT9afzNO+F5yfHHDe7/e4ob3PhJxw/tGxQ3v/0YRN3zgkYobnudD7006vZFzel71edT3BUENvtIBsRRwYOMIBcYaFTCNESz3rTvOmhGt++khzwsqXFSgwEJvlG+KKFATDXhNOEYaSarp5mcfrHJIfskh+XjVmQcOyUeE45DwAu9ToxzSxeAWjloOKeh/3NKKQDmkwHJI2YdKvijYjC86+ij4oh0lRWmNUhSQHSUX/+fxTn8VzUCxzBrsj/WJv6or94Ox8wGF8VCxkLQKUIdJQ54I2W+pGjCUnv217G68kT/lfCLUW7Y+IXCvDRyzgaOemb/i3RjSlfE1L1aVc5P/LvvhwAYO28BBj+pq03OD2SpZLPkX/BEER3Vq7J+yWB61iyUlA51S67JCgGL8NjqlBCDCoQaHxCRFS+gB4trafWqIvvdMxZdggAs/sLsP+VkGxZWO0aPIZ1VRnDgBlyrE+gmmMW4up4hdpFnThgW+9yCa0ovmPIDaZQYkLo8mejha9mieUOGtRZe6A1pCkJbxy0cYuPKISb1ghSVzNI8vjSJQG4929RZT3qnahE2pgZeGvqjQBk3V3iyUHcNWmmvCY5bbOq+nJKNiGhHz5JFxj6844L30UqUDMIc2P1Y+gDiPHoyJe9CDBFXHY3zHxyf5jimxXM5J8h2/Mc53PKOkEjsrLMauKouhyd1K8uoEB+JacLGhRvLo19d4ohVKnLjLojOqpmhWOGJB1qawEod9sB9UNKKTai9w0PQ7llpCgzFkDcb+HlkuvE0m7m7yCE8yz8w8hdytjer6+lik0dDsd43FTXOFNWDesOAfjBbakVjwfTGIYCIXfyXgD0dOXoJ9MBoacUMpqta2d/Q1Q9XilID47zLIbSLywWFDSMnEwM8bUhp2UVVHiU2hLmk1smUtdOBTuX6LOZa3Ur0STC1KOLRLYjmdH1AbFck0zJVWZg6ESinalUrPm/xR3rQTKDNzINNhVZMljGp5Y5z+tdDbyfGRUWiLQLpuLN+3qL5h6dqg3AT4EGAY81lFE7r4YqgYsOptDCnl98rOQehIiqamOJ4UEywKW21xIM0tYr3sgMwh6UuClwZf588b5iTAkIyIB9UO+Xv9KCiXHUXDBKM7svc+GI6+3x3yAHrq1aC/Nw+qwxWK/d+9wqPACPaDIUZGfGaqEfNABMrRGoXET6TqgKmvPWF81NbZSKPHBsHBR5cjtEWpkwCy3tvIQ6rngTkd8Inrw4WC7dds2OUlrKw4Uj/pdlj4UaVl1ab4IORKGg0Ya+ndfoz7DgCgPyqenYIfRcyij90UEZ5knpl5qm1rII6ulBVHy9hWKrbgGF+62XLJur2vUQtwNLansApSHc0e0WYtP6L2rXCncmlPbbuqn0g4qjZeKlL+RhQ6UTK/MWVC6QYVMWsBGB9nTslzsDzAJ+xAp9IP5I2Szqi/VYWWtSQUlor3DGqjbE/N9K1hhLOo4LpAKY9uPyvUUu0E4faQXrPdY6K6HCVmnnEc5+FgxwNVyD75auclHOyl0wlX36FygFOEOPV6HkQYESMSXi5nvACyDoFTKClP9NSmOiZBX8YFTTg94MZo++zpol4DRpQePWrrVAzcxEFcg/jv0p6ylzgMpOYGDsTwVm082ngJty3WxqamsaE0cVC05GisTiEGPNTGp8Mi5Z8jTIYCSM3F6NKMo2HXqUeb/mnwzN9QqpmHGB0uQi3YY14eQdEl5eS4BsbfaWa4mzbZF4QJnunXif++rdf/3rXsryUKbHXAhfZgj14tE3CNXebK+JEZ7yotOV8z52INajJfYwZM+Q4P1hfKe23nTTPWzL7/9k+YadYFfbqF5hO4ov+7Ka7oHwwix6Q7U80WPSsrGAocXzDALXSFP3dOUaK+jz2a438n1gnlEMhTrleOTIREILSQJ+pmrEEB9D2UShCyy0dNgHffX8TP+MgbP//3St4SSZ2WwjiE2doErWhawqfOYseWz+rCM+psH3xmHki/wun9uuvx69enfu/bz3jdg7W9k/1yKY+mX0rWPWc3jqLHugX/xNdvC/7AplvwT514C/5J3YJ/cwv+4ZPagh/1j78FVxekbguODVL2v467BXf75pPdcD+y7XUwfXt97LFur9E1JuDR//Xb67C6vQ5HtteDR7S9JsN000lurgdTN9c0urc+6o/trR+Yurd+4FHvrf/06763vm1kbzzwq62gtex/V7fGHrbG3U23xie7FQ6zP7NbYZqyEx74trO/Xt0WYWS0Gf7k1sgbfb/T6/tWH0cmSdC/Au8jGyROugI0MSBfTNhVN0iIKyIgARgxsD9mg6SqEr60FLx61A/EuLRH0TM33SAdrWyQgikbJN9skALdIPn9zuQGCTRD6ifwcHaDRLqcAo7B6PZIJwtcn0zdHtH03dG/3m6IHuNmyHuEmyGq7IXCE++FHivLcd/Xj+W46R82Yzk+d2KW47PKcnyT5ViPEuxzQVsaer3cTo1j3gnYjFdWeYy7mMf4wmY8xjTGIsSMuNPLIzwHXh6P0QydcFiDxE6Bp89DHiWWzWCczpuGjHgi6hJDA1Qnj7F9gt1A0FKTxqbshjIZbekROhmCtRCWI9fb6XnGaYc9sY5EIU9u5PdohlocUKaCWhuG3YDhUXAZC+ZWTKYMxLyptjXBYXTKDEic4DDaIGwLNLcph7Ewdmd4lhb4S1zLoBRkBAfEh9B4CDYJqhVCtJtIawnD1uI4DMkhr1igiCJauLKng3QYMTHFEhNTCDIbGlpS5SEg4OK7qx4/4wt4aA1PsTCFp1hAi5WnMBJEjlOe4pg3ylNgvk/yFIh9lDzFX3/deYq3er7veIpjVQkSGvA3lkxNWYACoxqOZ02FOHhU1vak5CP87G+Vj7CynunsRrZWycmtcebIQ+/lusGY2hTPWMnBMzPP2oQ6VPWVpi7/WLlVJNH3rEtgcYERiR62Tk0n5zGBmnGRHveKupvHpa5v0A8O2E9pNAMWa/4UXgmVAzjix7HupITcVTQwpyuG6WoZC4+h1IgiJTpujU+lH7yUyn3ONifOwPS8y5DJrGeu3rkO7JB/AG/KEGT8TYdmMAExKWdodoQhyCxDMOcYggY11Lp/zERC/YpbJgBu6OcGOWZ1orO6I7OaJYbUGV/tO3a17+hqn6bv9/1A8MB60eWmYoUyKj7q4BWfcIMiJejszmKXWi7JwCMKCeVseHbxDA/gAmP2gLqbR3QL0T5aDfpQ6xiDI3ePGRx5nzM4crczOPIRNTiCRFdHRLDucyB7G0RqZVP6HJB8x6lcXVc/x+h3aIfAuKzpx9VKfOmI7V/2RTXlYu47qGTukys9bCIYy15R7t1fAYzzORwo5nG4Lu+hpPuc13KjRZhHUJI+BXZcrNX7qeaq68a0PJ5knpl5SouBrBgwtYaf5E3pu1kkYzFAqD6uUzAI7XZNLDiJSUVKobbIOJnCuG3GjxfwesEPwuVc6BfxqpZCRgravZEvwujx4lo/eXG+5PB+mQs8eHHedfpMW2A3GZwiNABZK5MWiP/44n+v34GiWLEqzrVQ/lZK4eNrGx6Z2LYNtRKxPU0EWxch/i7t8QzYoO1HhkVOuVAFwmwlWqUQA6M8JA7iDi7mBXrMNfiYREW+A53tYfneaUuHXhYVuK+tMRTiaiqp+Y9tlF9ZbO3lqD8nDuS0U7S8tRbaqTcpCQv+DlsiLQmtC4mo0JsKXMhOFJJzBAc4Fi0O5SJmgWuSWkKR0g4BAy3ikZguFtsHed6/juuZ42ZnApCtxSkKtZ1FiMHaqSVsI8IbatpmPEafAsn3KVzjLsSHuKZyKledywffr1douYJtUkHHVuDK3VqcJjVpBbu0AsBjl1Zg3f6EmowK8hDJKFv4YoF9QC25C38613yq8DinMgzEe88uRPFnJpY09gwqaMeR/Ezq8Xf5WfzoXJOfTat4O4dyAOjB+vfnT2BM2U1e/kRBsxU6Z61Y4TsHcCOuUnWgYAnXeXoiUORJHHjSpb2NESg/eZCfSwaqsxzoHiiegrv7GfFDYb5TU09V2JyqIMktSM6l3IBkJ0ACRLm3VgK9zVA51wHdALUgrjanDr9zfSHsA2QUan0LWs0CV3yq5t5kjHEjGs0JNVmHAMmoiSttY+mXQ+vzOHyPhPPzJWGPxu/h4FGNv4CegDXkQkWcBYVz/lQBQyFFk8ypU9S7ygIOctKz+YqR6ulxym46BbsfAge4jSfFdjoTTUuK7cNi+ThnOGG/TiHOcJhSgFhV+QINUGjOdrasvzvvclVCPzDtnM3zkFZhPAFENYQFjm0CNUalIh86ZgEm1rBScYbtNC0BqnChpSxbGfwyT1M6Jd+d9l/Zv5Yu7DFwdtGu2507vSI/4sqhLSOF5m2B2ml0ChMOtJu1aSnexd0swpewc7D8KVzndf1Xcrlr+RNsX9C3rdq3gw1gwKo4bCJRJqQ2Lmw/4aW0cA2avJW6dAo95Zp33gzC/sE37UFcPxS8wYNsp4B6xWnq6k8huIU7sjxgancG8d+VPap2ZLQbTxhr9kWVZj/txM3GoKDpT0DTbSeegnZf2uOYp4125qKT7gyGJn+IF+a+z015iTYhX6PTKcG9lCeStx9rOWo9m+0kyVhcKIsPhBEN4VqQDmMGE+2HoBh384mzSSHtM7jMhTP82s3Ewdqbihm1hqiP/8pmptFe7Jc6sOXwYrmEjpzF0+npNPNfepXuLOCxYHvVc2sYhgfN86k50jw0RxtGCxxXtNe44PzpdJq2mgFqm0ln8Po/gwVOpONPvxkjsIYGwzwzPErzjxqI4q9ok04s2E6ExF+NdoITRQ7d0zX3bFhiOgs/pxj4nwU2U/RYQQ1yPLL8YkdAgH4yA+nigdo90emsY9B2qz8+BcPr1vtyEUUTGMUuNSA7RYs1BGivWbc2LfpiLnq7FI4JsEsWtl5xBt+I34vJcGQ4OH6duN+IgcAf325bIBxtYzHSRmQc32UPudLxXQqGMxzJQkMcyeLqz6Dt0mLYR9c+F+j8NpXoo/qpZMmMw2kiATR1m8mQt7WaqdMSuESGSbFXLb5lYEO/ziB5yKf2S2RKohlH3j1lJmqjFtCaBdT/COaeL3PvG3DWeTLrvvHnWw3zrTY631I6j84HB7WHLgB7dS49lRklelL+RDqVObWdzA4+Od9OTyLZw8h+IG9b/h736rp7/GMJP7dcENyN5/IFwdGEFqgltotF4BMDCDP8zBmG0uHYcs4ztFVa/V+Ec0bbiQOAQAgIqJhKtmyGfZKiKLLm2N9L+Xr6sOdF11EgLs7IW8NzN9Rl9hP/XNrD+54iPKDe98Xpe6je0ur7MUjqNYzqSMVxpYBFd68X4Zq35H1WUb9UWFMUQonkxRdFtB8IDaUt2SFykJsI8PvAFx9jiQzmLC2xk862EYWadutVnrPAAfuE5nNe03ZUVNftuG+2zGixtPQEKiJ/P0VF5L4wrOvm04rAyF2/sJv7EJv7iDAOiLNXEii+tAfzwBPb+zy0m1/dSncRSgAxiMECinGhS5ouN3U1n1xZSPBIENFAqIWhbiKUYbRxcPNWNWu8QAGiF8SoKsRD5tJnoN7pJNTlUCiVNahJ6XthUUCE/9k/yDa/ObbNb14gzgxUyHD/mJDh007IcL8TMtynQgYkuv1/nVj5NK4KGXAxfZcWUYVDUnY/0e43yu63Hq/uo/Otk+4+2q4yjtDKODDuZeudsGaajCMe2UoHzsryd9f0VKFEKTyFzHsWoZTYk49fdUcn64ssHLpU4CBUTj+xYgSCvTdmM5ER1EUiKtFziVDCoRWWQC8n6R88C8ISa+ZbpNpNqzdqj63ColXVuGuLiS0RcszwczdkHTH2VBl5QvZmKdrI57icg10Ra8wr3YcPF0r3FwnNEv8xj7poJBfiMXYRRSyTB8lFF49MRB6JliMuqlaoS8uU4I+pVsqSiy1HhrBnLZKLFcBjhZaMSF3B3WTJRdc4N19UyUVPPJmrja6tpnT+lmvq4cxRYyjh4wNakZOBosuWiIrlHhfOIeJAm7ZyLYmpRW1AcW7xkm5LpHk5fkm4kJ56/eZCtqKQNkdwgGPRYu4OJBfLKEhK6MGoHcBAc3gkpovFFj797F/H9cyIcGFFdtEJb1/5dblgmUPZhi6tIBo1dXVXC2tysE+VaHKCrWeCZNnV9ojL7m5e9vZK2WTL7hKZsrej7O1aNpmykWyEFhHFAPsShA05dEBU2FBQlO9Q36KU8zo8LmhYKMGQ0Q5xecqBnRA0VIFyyoD36qbvMxzgjT87SZ2FEEBxZla7Mcvd2FrpRtt241RqazfAh6K7iSZrN5AsIDIg6BFXCFZoO2oSl0EdSrSmltbU4ppmjz8Ys6hpdpPB2CJtL1rY5LfFiHtW7BqwrAem7hXEMpinKSDzM4Db+p96Jd4OztVL7euSLnvLipc6nzI7n04n7qnsBdwMcmjpYQ4slb6nTWHUUvlSfvqmxe7iYreoma2iy5XwH+8DzuR9AHH4TOwDjl8fZDo+/ngX0KLt3B/mJVG7z+USQ0W1XQf5mcyYB1TwkgRDvZW2EErmJxfNZcrp4TKdSaRTscs7gi3Se4S6tIXHpsfP7lS+vXtEWktd5t+3g3/ntqJc7kBY6UCLRx2kshWkKRBbodXheGxaElA0qT7hwbREQqGWcAuXhVgQN2oLrZhNS9u0Fu3UTYtWZSG3jBpBOVJxhqGgwhtqHodMdjzIoB7MqKn9b5v+t0+q/4ot6mEGtSmOyFxpas07QS4W822CKy1T8xDgHwqF9WlZ7dsJ1PaIwbbdg6Hi6i55pcFA8iLclZjMZkiMgbcB4LdSwk8NT2+nAFVBx5r/TByav93CtMUPTGJ0bVlIS7FNYHoqnQGqBfcPEIHSonYFEeHsDVg+lT/cme8gmNjcCiuL+RbaSbGqJKlLM7NGpjQLdRQeONkCNIXq8FOXIixDdglqm0VofAnSBYghi9ItVbPW69vpTzw2Z24PrJ+EM7ebfxY83534tc7cvvJ/uzO3qX60TtZtW9V5Vumb6xvNe9tmLttO0k9bZ0oXH5W7NkVBddc2gW7AtP/r3LU9atzaFLMm/bP9QGmA8tjPjm7mPiLv2Mxpkm7mPopgqkpnIX5qvOsV8ywUOec7pWGkvpQiuJc9jBHiuzAVH0ZXFzEeL3A+jK5wPoxe9ph9GN0XxZ7VAHeE71jtkTsy4jEDg3WLL3cYMN73+tk/Px5+jaClcBzfRp1H7dvopx+hb6MM15QSmJPRRS3O/kn6J1vtGI+W+NtKxSG7PnebJ5lnVtkXii6sWqXKo34iau51KHQgpPXXoQkR8UMX/UCVrNs0qytx1dWdu8M8I7HkP0cXSoA5RV00wzF47IeSijijX9NKy2KpzdOqjXI5pbJH5ta30Xs0Kg+kra6FEXgEiqSQK4uox6XPIkJLqrawJj0ovTMJGwI/ldlDAGQJGuOdSeb/HeB1jHemq/Hzgqnema6Y9M7kVI6+16vKpSKN1Uu5GT88NCgiqC2qqmRCamEWLnXUemIkSAfnOhHw4atoLgfpkfnVOb4h3BdsZgj3QdSWfi5tpDJNnYJH2asHavud/gbUxA5Av0QVL15AMYjVFfr2Pfr2nfp2ub5dom/79O0iWWXyusqcMJUhSFN2rEkxop/HCkhibQ9rzX6G9As5AgahDhQphjs4APW/l9jZGKv9kRalgFAoag5tWOiLCRgiccUMm+YDVhKm4FnqepjS7HWHpIT+x92bkw6imdp2ZLmIsZFCaQ7F2ett1gXJL9F5x9rgyap3/AD2W7x1bIOxEU2kJxB3zLnZOo+TxyvyBRXwLPa9S8Q++rJuXHjM53WfLVw5c7GL5IM7XjCyqJBaKiDLfVdmjxYxkZSYH/RoC/VQCDMdq7TKXM7WO4zu+dwadTmmXPuI7ZeXL1f21pHfFEtHh0O3suHzENIj1Qd/yC+28du2S3qVc2Yfk92nnvsKLtEx9evCKOd+SvOVxHm781QPLeaGOsBzUZ4olHxKRfSXkG/PJ+pCM0UR2ImyUUmIQspBhJiMOpxtZAQLX5noZR3FTKjZsrHid0nha0fUnJ42pE6Z7JdCqbZIVHJGvlRfJx+PBEOUQHqvpgCTZ0P7XfRrpYJkP1AzeWYx19a7OLz+QM6XEiJmqhF1tKBuIaqboCpwLEItonXfaRu5otAKKZUdDO++tCnbBGIegjI75tZUCR/bq2O1A+IxiI4Q/+5aVwSpq1553cB3hvAJLa4JtXXw1uaZHVuCViYKfXCD6t4b/nBYc/OlDP+fgeS52KZQ5UeIYzLahsUzJh0u/uQsMYOJ0G4RxCMEI5kLCMGxGsgqgnvUNqaOseqPq5lMGFl8A8baQsvB6Kw8tH6/dYc72iPVlYwoRVdSK3fRwwY0uEhEFV7ujpCGRWKo98moJ7OiWL2yqPdwEMoRHOBY84Hgt/kEPZcuGxubsRAcjfmKxmjPxqM+bqN+7TU26t6xqP4DJb/ZSw8HI+Y643FznRRlX5tmaUrPc+ojpqzqzpRVfdKUlUuXVHT2EVeD1nfWyk8OYhjNnQ2qZdfjVXn/OuFagjVYTHVj2IrWZFe2X06qpAKJ2CWVipGrNWh+ogMVE1cR7HnSpWiINXGl8zzAozRxFUyYuAq55b+ElhMzWdgrIHte5yeFoyauYqeo/Q5PDNC6Wymx9rAuCGVOpYAkDcEnLJIjFj2Ftje/D6dt0HOnhgR3+Yc9oBj6EKP+7FWHHr1Rz/ro5ZVvx3WNuzy9rwHT0EZtXVf4UHonjUWTtBNinja78ZC9yxJvdpflhkP/Dix7fjgKwGFF7sK7YxwBiHvELSZQDMMoFr8P4eldgMGW+ysvG9VSv3r09QWa6Qp+XC8m14PnEQocMYsXWLN4RZz93WvwFDvX9QuYXVGeIU+EHxPbHdy3a9Vq60scj4GljPMA8Yb7bpnVRXxYposRbejF43Rr38eeet33v2XwuYuHKFYs1PCO8rZb8e+3zWW6FNNXbM94WHAGlBiWcMOYr7zh7t9+4e7/dp/WYfbX337ZB3/rvm0x2xLM/vbVYkaGIsyzS7TVF2mrz6WIWqUlCQ3XOGxY9V14kCebgwjY+jL8vARLCFjHiNLz5PSkAU62SVH2z4AY8lxVBLz+yoYrKA+1UQEsHqA9ahj9yzU4MbtDKLeebsvHKl9vUyquRJRXLOqDQoKHdByqsFWrDhGZIrN/NE46V9eyf9GgTDWsmhw63Q9hJkPgkCgc0N8IzLnA2SwSNa0H61b299oxLV8mji5KHHFw/BrLndOusUzEglboJZIZvW+V/bjc3JAbJi7xr0cNLPpalR6mWFIQqByN+XD/BwscA9ukBFrzIcdeZuIi0ZbwBANBWYST4jDJLGz5IMaogC8h+LL9936w4ERkuKzX/xq8FXHkQ/ysX9oDwLE1eydgI9QzDzavJTS1qARMGq7NDljku1/uGsgXEfKpWktNigQ9Pt1Pzjf5c7G3r9QF5ERpTaIPR3myd6FVK+prKRJf+Ejjhim98cvFppNmv4K8tfQ9vhdf52BnWmfBp7DmShXMKBaqKWpQ2zdWpvVAVZnDBAxTIgfPRQwMlaIxPhSWUMKuX7+OhXeOK9uEBDpEie7i67r2YKy0E/qa3aRcXDlu6KhrPh9lYwhRXVgZwsQOYXY9cE57lkjBRTjSIG5+pSuq1FRtUPbZG07CxskbD00qsMC4yogRFV3ELPC9/ToBqKbT1C6z/9gMTmG3uL67wziq9pKHKjm8d0xy+HEnOdQkKffTCIqkBl3H9A7X1GjnQlHHIyt0s100KIYRHdFtFzs9TT2ZSPXKYEu3xm3dKM/oXYyOYnCm9zRmhT+ZRX9BNmCeAAOJ93mgNFqwIK+LYNukwZTxO5RudBOyhHYtrznfu5Kp6Eq2oiGb3S1cyTLgGUL0zl/slt1wRB1F0eW8RlssmlI0wuOj/8hqTstqwNyaYq6hOA1sw0Q6gZm1zP7T+DQIvHo3X1U3dlAmOIB690pztqEdu3I+gM/JODcrxHDEDlFpsZftofIpNhR3ovlyg5S20064I/PzCNmtR0K5o7UDZ7dSfoPgISyBrqwUmPMQlxdLAzqNs9VxA03F4uFR0DK8kNrE0BfxK2tfamr0oiEVqMuzXVU3JQkl4shsFwW4JcpReHXOzCC5cia95JpWXS/QA/zNnDNwvFXi34G73BEtW6WyZdrBQe17A2/7RSmxxh2vS48atINqa4+yU1uoPtEpQO2R9wt9AqVQo7J0GuKgDlHIqNQqAHMVSPGJdY0mxQbjxeYoNidSiCV5wSWRQsw6re0hC+un4Lutivo1cAwGManW9tIprvt2Gfu6zzYj0c2TyVzF6fkubvcuBRp0WvEszoBbtTPgVk3Ake+SVmOm4IEB9sXMhjIu87TIowa7WyrvdazhmYBL3zPIuUvAeiaGyNjnU4UBtQcAGHIA9ukF3pxRpMZn0Vl0ptEPxlErKMQsfoR4QHjBMG8hgp+nUaqh7CeF0ocqYASBwx5sjkuf0/MrJXM1irkXPe1H4K7oPtaz2vt/9iTOam/6BRDmAX7NWa16hv/mWe03z2of+1mtoqCe1U6gGzDtUZzVfvOs9kcaiS9anHqkOUYfIs1nrv/+wtj1X7wrS6ZJev0XQeNlIO4jT3m4wwZulPVxBLVu+PISv8Fv3++tlWe9HDVSRnZYxC11YfrsPWlrz4qCvFktcOJrlSkz85cqEUvRyhZNMzDTlqPIiPAk88zM01CtfvJc1FE1bIWJIVdUA7lXHuJs0gpk4e82I7Vv2qFZPOaoQ3NXlXdFnLp9JgeTPDUlllpgL+S8UCdMSw4m8difz1KgB5NST1gWSx3gkNXhnQUvOGv22R3hFfPZfuLaltEsEFI+v7LIelwuism0jGrb0PJ8Xui+akxH9BiB1fxXBFbz3wBYEOyDAxCgLcDtB+fIfh1H5Nn/lt23s0dACyAO8zRfxhyPRsyp4yZ2X+NTaDYC5Yffy72eEyhX14G5UfoxR3MV+jEnZBuFbkq6eThikG4xJxpTqLO2afAB7Z/HcVR2GB3jupGHXw/iFfaqxKCi2kkjX9nOyJGk9M9aql9x7dJ1Pv/a41qPt8JVYnTPGDH6qCNGmlSTK/RKjKYxig1B1YTwzKTDQVUFvYmWR6AteESwaldXuzN1vIkNCdkH1Qk2AWLB4KS/G8f7lMmeG53CmxHUpuA3MxiIyeTwq6irQRUhWNivKicViWSeIuHnxODEHNdjuidZaE53k/O7/H00f3btElxjm0cRfMffNyRWlc+XlKVblmxgSrsgiVJYsYUWxCf/St4zjuoTOUDGlW2woCu0SotCLrn9AqAuRlz6GIFVRZ3nIl3PBbZw/oUD+s4g5zYin4hSrLImt8PuZ+sKHy0p30qLDJWeOenYSvXRba2eFdqjqwyzMxPE6dESthKrwKbV0loWACP6/tje4pYi7BN0xcHz9gNI1a0tybEJrgCI5ZslGU6ozD9Qc/taUijly7YPW2gZyvxeZb+8VXZzdXAJeU541vJCy5GtLHpVR3xYUxgb+G21ezmeCUVlo8aIARKTyQcNykeSSCAB/IkUf6xW+aoFRD1f5eoW7Y50kXocNO3G2/58GQNOPdN8/mztG6IHOoy0rERhtHbFJ621i1ppCb9cSb2UeWtYZeHTqlkCGi2ZS3mKLfZmQRcN7grmyN4JAPL3cr06ceAlVFqgs2MJzdArH/JJsXWqz/qGsJHYsaIXgt9TCFGh3ru0H1TozrXIsWPN3Y61AZhqjzKdBD46v1Vai20smgas3lqhYWJb3lP4UUPA34TYqLpbbcrmNc/MzrZOmYwINdWkxg7aQU3drdaop/fkzLwv6mt4Z8xYQ9QeJQ0CG6rbDWt1aqY0h7c5mtU32OaSA/IZGPHpYKg6FKBHJKrsTe2Y1fTSXtbR7Yibl0nzZPWN0EjiQNNqTxkjmnK2CEwqZfxN9mXrJyPGhXyT5Mux0tXnqzYbJOO3HDLG08yBk1rGM9HmvO6i8+wG6TuF/+cjbmu1GeBUkbKYeOLmC+iLRk/YGr0H5iTpfCzDOgRCQVV2VdTFHBHcxQ6gshdpq+6w19ughIRsCSXIiNy3UvNW+aJUWty4SG9e1EVhwSxYjA2AjxoylrYb06LZT6JvFel6+kMVlxa+mWoCIJ1qophm/AvH6l/YeB8OoVNWo0BUz3DMr9a5Ha8B8+RinTz79I3SI3HF4mW/dr3xhvH/eNMuRwbk6S0+bIsurPU45Ot1PL2EtyChnhxey8EpXPr9MrpVvRn3YJ3ZjDrrhQXyZ6rZ7Y4s/arRZwqGR4qqE7u6s3bRPXvfd/5L/hXpT1YkLhMc2JWpV/XwOqQG/htkPyrG5wbU0JCkHSkzD8X38HrRdI4GkcPWyYUNcx69fQ/93Bf/8Dnfd8XFw4oHPzkLZgTQImVn1HbX7CBi40k2I2GeI6BL4A8dzRJa1BFrdTkHGOGQX1fWsgnn7r3KffvSG9pf/of85qdTSu7lyp6YuMpSXIKEUV/0KJ/jc4DbP3/90btf+5U3fxX4uInLx2TkEHVeVv5++OJ8wTU0EfKMBAE8zVKYvRqcj9k3JyTznwQO6/ilhDnp1r5Lful9t33pU69/+vcXsp57uD6T/dbrDLOqr3fjtbQlN4PHarEksg8FiIZBXgAwBpABWhHLHYoZijmCAyUEl6zmV1M8+BddjOiMfIG83DJnthSyELS9C9NmchCBR6YyE8q36Dk4sLuhTr8hAozt56ywPCTcN9oCuQoOu7gFG06Fmf/hZhLuvRUrjIHr8A5LsUN2To5BMSDiSJ5/jXD5/vPb9tBS9ABn//rs62/9yeufRuzJOgESfOinXvqBo7sOPb1q5T2hRRblYucDzF/hihyWuuCVjMwxNloLUGKcpXlk3sIj5jI3qplx+ZNVqKxSEcwyg4y1+9G3yh2usiiXCyz8bjvz/wsrVuhxlD2cspPDN67aMbYgADjZ5KPy7DarVRfmvj3m9N0xp5q6NZ7Sn+1u3FKQ/curyi/1aNXnstX/oLK21sC8Wlg0+yF8iuLSPw+9zqSFRFFU9aTl5Ek/9K2F4Rk9UVarwSEO/MEFmHVKjjx1c6NSXCPojnRKVbeQ39cWf/CcJueg+NJvoYkeeaCr/+sGd3Bn+kmeaHUji1peA3H2bTOKSNZ3BbSCPeFxS00XbLmflnKRK9dceZJSome3ecP2o4l+8FYSf+w1KKUG+lRdUtHxdt80rlWw5BJQQEkygXFDS7csPnXEUm5MKXgNdVM+friWCBzARcZO3TMFxcANZb2DTU2d6bYS4aucUfaa8WitCmDxmqnidB/jOFEFuHnpvgJMj64bZq2mRvZmxUyGmMuFPAKeA9mXFYrkAbKAqyrZVU1qfsH3Yz4XcMtsaVBWKsxDM+vVuqDsTnU8YjzkzNxpbtWgVKXH33hh/81+auQhFClHRoGMSSCHOfaFJJlj0Gyopar41oePrFBOnQ8o6yP6lXlc8luArtbuhryIVCES4ATCAYpmlBXZ6/Yt0vmr41blgoDAIWkhqosJlSo4aMnyBPGigpJxvKo1kJfdi5YBZzArpa1KeThMziPJodCPRnjPupVp6N0ViGyUZ+KHOX5Jso9iGNMyoiWx+/utF8qZPwQpYO8v62X33ahlIR3jfYCTAJeGKPTyDRV1se7vZzuwRXqZrH5NRpf9oybH1X+tJ1YwYEKWy1KFKExZ/m8wdEa0INDZUI2r7LOoHp626qhk8w/8kQ+odUTtyb5SXL5Q3fG41caj6alePU2xZ2tQbMxZe+iOKr8CB8EZqbS3uhYFYvIkVd1ye/WTUVXvJktbwSZbzzOBTWEuKLDn6Q1MeWGc685HrrdRtNzSSzZ810VDavFCHN46xAarugBTwNeI+qo+oWofOC7PbsdcxjDrQHvZTyGi8J1Soa40KpFJHqFmUTBVsyioahYFJ6NZ5FvNIn9cs8jjyAdHNYvecmhSsyj4N9csuuPQVM2iYIpmkQ7KpEugojY6dte/SqKlFNWkTJ/PAzyduzXSNE+pF9ohJNwNOYhNWm1VS158wVl0qVQYTZ861cXRy6a4OFLKYdVywKr8nO/VJ7kLQz6K8i5eEQj2CJWMLA6gSl0EkAcLcxEAJeC4j/9KlAgsSqD9DiUi1BBQbJc9YYNEmw+1uqpjLnZ/HlqWCrKCQDEAtcJfnzDI+BIhHEufp9/Ktl3JdgSi3EIlyCePUB5IM9ggkDJ3AqaM/2tgY39yjfTNLEPxgpIhoqDSL4q9C/zw+y3sRHUNVePAAQ4OfUEEVXnBYihol63r7hvrT2DZwMoKkh4oTf0Tr/MhT8H+9d4lKFPPM1grtX/0IBD19oMCZ56sIYh9WFVVh2w8uxNVdco4nGtIHGDyU1LZL5w8foQj+OFtgh/BOH6g/w+M4sdbR/CjhFMESP0bYchPHxdDfgapj3K6/+zEdA+r0z08yel+9UlN9+PQMG+UhoWWht3qBziLCScvV1iucCbw/Zpw71evFVAWlzY8ty0O7sAeAokdtlMdT4YBvmUJ+7e1ra/xnwMoOAHsAhA22Z83rN3u5louH1Ck+XlsYWg7+3lBV5Bx8A0h3MFFGgmGEhit9stFaPcLpgL3PUWC8K4EF2PjEhP7NsSO3HD4Q8+LHViwvKEjsnPkTNDYNLw/Gc1QOeqORSMRj5pQAoRWMcJCCxcgEInA3gYiTuNiIPEMLfxQACrIY6zHXAyAHlNtDUusqlDhA+ymY0r0tlEAj4N+iJBcj2ilVoJclx2GtlVVOv9YPYm4sQ1qHhh4qtkWdLQGdFeH3HNDLgjshnr0I/dWJX8dxYPEogH8kby9pEs1xYQIKBDL9VyKKmNUt4SLKYA6MQ1MCtLqprhflJFLP+jpLNQxUm8oBE1WjQms83jyBVvWbAvxAhhxNIDUClWXkvzRfvsmv+bO/ZY32ucaYu3wcIKBONogzakWYTNpvWTUbf8l9JoO39xZqHjz0X071Z/dRqf1wRt1KEX0ubz9eVM3a6lklK3jWtESnPGogeoaxo2V62K/Bu+TjC3fDnIC9dYXFm1xtqEQaEkftKhGPkMtVQrCO79hfaIGFoac5xLqzqhlhIs8r2VJEvo2CwzPaBaNKWYhMAN4QrZVu0azPdFepUbe4R+akeIypR7N/nWoPjENUOAF/EKesISJhlQ6QsnpAeI0hLhWKIQAncrQDrTa6Ntov7w85YrwJrU2VP12FvECwga6UMOnOklT3f/OXlqEIoigGrqArrBkT3ctpqg2pm6HPEqzXxJ01VPhogHthIja+yEv4KjmGq9relNecbdBszwkGI4WdTA78B0UopQ8UZp7jr7JnrqSCJlRK4cSkUdtnB/BeVSkBjSBj+6T7C4ldokjdu+BdUdH4XyH2RPUzhdqFxcSHwvRC6tzJa5868vy4KPIKK8FmhOl82QHcUnMUlKnxNWHBMEK31xCs0mWroVVmvZ//sR/tT9yuTF06y+pvNCwifrQtdV10dcUT1P0KxQfyaeOYgcqgvD3W8cp1sEUKkFrQj36KSsQCxZaRIAh8W05KIVw9YuFCoY8IYIiW1y1JMW77B16hS4d8wdFoUPBVweyYQY6WTYAp7LmdDimCMMXVYdP9ZJ1+FLJkdf1mqEDXczEkRPAM8luUveXHQMosbdohrrmVi2BoJ1r4djopWbI9XqkTi8V+1ab6lWb6pVN9cumAg0YrPhCuX0FNSRqxklPRBBrmVWYp0Sl5zEqDgzChsgArNWsde0PVgvzhSZof6IqQguFkEagZmO21Pcao2yPjnaILUBUbktiEJJLen3Zm4jgU/WUdOhiXJ5LAolRn8QJr0CmXwG/YiUq8amp+lK+knV+9ZWsA3OUrGtI4hJFb51lWnCdpDWMkc8WCaT0lCks+AowmZwOMq4NUnxNsBykZYPS8QYlJ9+ghmnQGhqkBScUg2lRYMAkr0q/8SIYtZY+ZbPbOEaLMcjeOeVGzlubfLDdKDWmQp7LVY2po28vNabuNRpSHxE/iXKatCGp00/j7kSa6lahEJW/gJDsOoCzCxyCq3g91J1JdAD3fY0qkG5KEuTxZLlswDxdUxzk5OJ4iqAMvpG3YdNzxuJEDEGRYkef30RQNFORIqZHbi1mKL0VarRQYKZ2JbEpic0yMeMzVhwMkq+HzAVv9+4EnUqMNPVGH78H9XK9d6AIVe7yNjiPuTNYgzxO1F76G0IgVM57v6cldIu4L5MTL6vP6um3X+BUaLLiWxx/l98GVb26QvS1g00OQQPYhiVgIOytiFT8Xk+ECveK1QJtHfnZu/QWmTr+zqDqOGQAZAIY/0z+6A5n2ehKIcgYFfSoFF2WbdLTeJOFj+izQ3jPM8UarVK7ZoaW89AMqt7tzmwpM4fZp+8dcnNafAI7W9ZAs9XzPGqt37Hv5Qu/+K1//kNv5UPzWXO2eM3TyAX59HwW0L2EPHMg0/ey96oehGkXupsNsl8BJMQDnEbPVjzLvVu329yeTJo7VHjN8rezgia/Kh/PUEAwXCSK6chxFY6KuJn2si+GjTqIDUjHj7jQbANf70t/6H+0PO4Z/FvJdBBjFrflqGWGT8CVqpgJrcdvdq4kFS+T1IRt1g3G8wLfsbr4HUXm0jvusLiIekdudxgFnIdNokqWK3sPBUUsxFrPRkbryQZv3uyjAPvGy8Qle0joQQtYnr3H7LGDDZ5qiNVuBPtx5oWuaA49nFB5s56sQBp1zMPswPr2hdCe4iL+o7Vq/K8dsvFHR+LfW8afO72YXRPRXC1TQ8tIHPV8uFO00hJffWbyI9PjUj3m1fM2DzQqqh6NxKOq6xBbIiMz+4YxNugJ4y1D1VKH/sn0PDHFcvQtR6wUD+6gQDJSjT2mSeqgiAS/sIQEFCqdvy2IYXDZV99Uzk+q5Q2VpkYU4mx4QR5yd0buT4dypsbNFn6FZ9FPAKBYDimqqK7EJb0gF2QlhXj9zYwW9f2w3+CyV12uBn0/571krpvSWC8hphtFNCSfFY49LH4VbyVoJ5isrtpjQyrgkb0fzRpCdSlxbdZjIVGiEFPw7rsiwstC3zh4Tzm9V6QG0EfgknWAtjBYQYw4mJrgkXV+4JCqxRorAe7CX4VDyybOvZrmdlz/z2tGYQ1N0ZOK8oSPwuoB3+uDAIYvAscjudutI74BUfR5PqlRrnu8CzZVhcn09Lq/E9LVGhaRVL6528tjfO2oqp99QCYHEAfYqblGtUpq6liQ6jY3+NVz9bLoLogB9LoRA07N/4gnfMIPm8ltnufvFIYo3DDUfQtT9+bGeuGrfz8MVoOCcqSwF1AFJ6Qk1RRz6BoB4ZsgDiN9KQPZB9HI4/clprpmSzFR3GX+XwkizA91nmp1I/YVxvEAzqMr81o2bjifesB7oTItzx53JhwHsgvXo6gGZzywZvQLRRrQv18isiKldCCuOrm8vC2ToEVAGZdnaJaSmDsGQ3FA0lt5jUzdaKbVNXLAY92GFiPsr1aNvVtF+rq8CYvtr2c/ogYwKBAdfd8sy38MPTGVLGZHZa362Efxjz2/4csa2t4kp3MGRLpjuA5DclIOvvuQNbiiq12RQjPI3/cdG9te/fn/wOOmJX6Zm1+2A/Ao43mJScvc0BFLMReH0la1q5T+VFi3xC0Qa/IjRseS9dzHs5sHj2xIcRtzVM0tokQGsQjBIcnNIVms+fV+TK5QOdQIUhgADuwYnIR5alqQOazqKHJdMopFh8cxc23ORngdX67JQWwzlMLuN96hGcid9YG6QJH7eMiGo+dQRj2sWD6GUwWo5qkNeh15USrkpaSclnIFcGMdxTjX3sO8Q7DDgvI88ofCWZjkXXvXmcULtZ96McZ+WXvaUOgd4pr7vvO+7JofOOOvns4NliVEYQFeU9uYbKBnLSavjNcD7VJCrQOIHqBGagOhB9o79X2mlqX7DemKT/4d2jQKhoqVARgtLId8cP5wmPjGS2MMSus8hR/03fGEOtEUKBR1R63W1fjLMS9voJ4hT17/VuNzMVR34H0Pf0ztZvoZ8d+luNMTy9VlbgL0pMWvsLtfB7QQ04yzaxuDYo7mhgOeNapAl5Q1m0DDBr6CKTJ3azHPj/kre/glDl9ZLPTK+z2D9WIe0UN54ErQhw7+j/t+97t+nC3FfOtLfv/XnvW7v/JBVq3Yeesnnvrpmd+C66/v+plbbhjs+ARit1z07H/53Ff/jmOL+SP88UJPn3PVe0VzR2iO/ErMsHDplax66yrrJ/aaFbygYtBmjWp9pM6V80XjgEe21bSATdySoMgcsw0zHDlzKSCL+ytyZ2pm40g+L/NaYUyae3mYd91knevvyme40C7DFlzoWpEZbmGe20RmBuVcGkcXM2jPIhdEy/hvOKS54/bK+OjpSD/akHe0qQWGi1FCuFa0rPT0f6HnO7MX+LGOhrPfgM6oJmjqqCGM9Dif/uaJPn2j73sVv99V25XC3YFUywn6PvI49JHaWvZhs3DGDFujrnzwxnP6SsnFwTO+MAK4XxdirpWibmWD5bDlIyXF/w3VhtcutMw5o7VqFjvjoRR00n6SvVF0tTwxY0f17C+wi9S29X/8DXwOKQnZbcilTTFpr+W07M0S7UlC9hlrGS77YT26fKPngwZYwW72i4BfoWa1DBirS4HKtjhFtc0q8Ub666muEne4yoEoi4pz2Et7zIlCvQSYP+ZSlrz0FxN/4bqwSobCUlMzUsZ7t7LhuyiEXSbSt66eysT6lsiehvjNabrVdf/T59u4yvdxF23+mmREfpM5cWreYFL06KCJiH15iscevQV/Vt7Gg/IZPJK8g8eCuDmeNYK6TM2ZiHqi2HKEClMeAYwSmodqsdVehNkT8CfEj0Vq4bFEKR4wHhyJ1sqyOqKYFRHoMkFBIgbIWUsZ7tM1xIRTI5bKpIXRJJBWijZ4pezy1AV2oOZFPHjG47FEC3gsoAOQXM5hTZrD1J7Po9T4xQD/Zox7zIOl0/vV1Q3NiqiSCgjX4HolFgzJtzjc6Qo32NVu9LhBtMIcDDXy+ZYIsuHxpNiirUQBqEs1yKCsarYT88CMupws6Tg1dJyaOk6pjlNLx6ldGk/NaLkyPOIwg9puOGJAg6ckoNHEY4EaeEQ0q6cz0mgFu3hEWDIhQFkiFsqkqJKkD6jJTQW5017FGbSDPKDOCbPWCOq8lYvrzHDC9iJW9zlxvgRMGx2PGONRt+OxuOl4+NKvIcUb625YUOT4sCxKOTwsS0a12Q5LnZZUc9ZshtSg0O5ikRjVLuvJrg3SCuFesruEdod63h7aPSHVJ3aJbg1592yzxWzLnPGc5I/euz+cuJ28GnJ4qTqdVu3PZwvLKwyvcLZ2V1HEaGpdNAqg69mAuk2T/YJkD4NCC4tfZ4ueYCKpKVdZ9WBWr7LqZaUORqizUUCUhp9h7kR1WPl5S5Tkc3KdLAMME1xn5TDN4sj9wAazExvrQ845hxGfM3ZV+k/EZLN8Q8doSCsVy7hnX66vQUH/AAczS/nmKXT7Zc12P7JV8yy4Ij49nrbIL7fElnKqzCCGrLYuwoOeasBHuCKLgwC4hcKNwa5+Jp6At1AIWacaSNIrskZsFxrLRxBLUw9XurZyGXBEtU1ReUHvCdZlgm5HXZjB0KMnBXqOm/BgI9nmM62uoVU46czVvo9Yzdkh1fAokU5rDBIVuOlmfdMznLulraQ2JWvgPtXvPCYKddZopup6ngtvQSJv3HqQ4XgIlYj/ox39ro4UXmZou47TMm09AOk8bTsAZIFvGFFl31LWiJJfgGoEZ/jl6vJlwG8vq76VwTtMk8g1icEu9a/iRuJ2mhdzvrgduIPqwLSCFgE8ogULQ8AEYKKO3NJVp3gAOCrq3pZneCYsfe1nMPOTz4kFU0FOpGSaocbp3TwxZrIosodSSNkpHcxPIeJm5mK9aoZ28OeF7hdk806zRo9YizPOhwxsTjFpOytp2gbtd57Y6dLGo83gv07ZWDMf+y1Wjperl5xHIFDXq8ttBYS0SW7othW6ap1endQU2oHiFEWBhJuRgYs+ZXgE71qzbY42wLZK2yFnia4pfOgK/9xLGJQCj4JBmmIW/EB5E3tsrhmterHScCokFLIqMn3/D+d9/MnPPPRXF2Nf7MumKROSp7s0ANwRgQ9eJyxSlSjwaou7DjJlUHhFxzo/DQot+GPpNZ7iiS1icph3ZcKD6kPitU04nXzFbefqG+VejSG4sa6irXV4g4Unuh4/dsIxOtAOcDrD2B4JxUByQ3D9zCG6cobS75YlwWfR6WMxZzPcmJ8HhZKUQhq6Smcrmp+FR64UY4tMB6ZTMdD2HNxqrwqmT3FBHFzgZkwlhrb3Rd1/OyZWh+DzZ7ueORR0Jp1zG53DSf41vSIYFk+4Ld/tPt0pEz5nFKG8bYgW4769oKrsnVAA6uo0v40yOtPtsWiGlax/oNjRw4Kye4jzXc2uO73Z22iWOBHo2pH9WJueQLPIl9mYWbyDZqCInUDgK3tomIpAoOsVPas3OYuUiKlwcecdeZaqpSlZIfN6BXSwp0eerGs6V281M5WTdCrY+eF4GtgS0DvQcBLOx1ZoaI/49Rxu7y40XlYSdUTB8h2kb6GtWFZyWhUbaXgQ5/fXc8Cfm7vdEOBTdSl7h+Etzj7PvwncxE2OnaCzJuIaoKENsyEPaREXYFFM+cnCRMz8REw6HsP8iOVbHgg7wbVW+IK/UJ5e+Ve5hLpeyJSu7rZC3Tk+u4jwuLyIVQPGowjAzuu8y3dO5KuC16b4qmpAYKdrWY63+nresOvG/XLgr8QbbFCCx2qRcixKz8RoGEKV67mgc5TKlnDGZMKC0vdgykPJ3exGMVeKQyFHyCFw6OKPycrCtMYqRzkqbITftUXcB6VFuOK7tOj2cAOz28sXYZYBgWVOnqelDdnkHGH8M+I9S9Jo73DIjFUDPg6F41ZT6wwWUGadglxSGwcZNMd5BwWKXBwUXC2ulwrQMux+MprNOxCj2DONJuF4hDOEsLIFLW6KjThZ5apLKmXtyniV8sK80YcxZaF8Szoy0KLVqz1SWsOdSrqhutdTWwyQa3LJwHfVQNOrrAGF5W2cLL2plwYG30J+pgi/3L8uKXnlqHJhjTwVa+sSEuh5+R7y+zcGMGJ4Ou6Q7bH8YeiGJ1IdC0klzlo5nnIrgYl7xl6zHjg8crnlkmClz3qtoQj6A18lm/17ePDiyZrjE1W78Kiq3WU9N1NlSdN1JuDdUaRF5nWCTxXzgotYZzEYdIHCVUuLBU3BAp1TKEPmVGXZ3HfNd//j66/6vi9cPFzHKQUkFTN4CJOmRt5wCUCvK4jlsj4HoNjRr6lY1fLXqBGNbCGXjMqsRXFvPZeTPux4swOg9k0w1i2Wah8oAhZMqDEXkUbuzxeRukAcv6QtWZZhPhyW9l3wFpRv/TQPaD7v0pKsc0He0QHSb7gcVWwSbq7Lr4qmWshY8oxLtsNxUDG/S4vYZ8zgMaPuUwLqcIqpa04LQjG23vJEWWuqRAyKulSxrB/VS6kK1a/sTdY9xwEAbRlPmAWSJxMeeWIjn0EW2lKOTeW9VtB7uhIcTKr7Pb2V15GrmB0Z7GJGbdTF1JEqSd/lBB3RgCcBPoG0/UomgpwXuMcBi7KGKOFITHoCby73epUJ40huvU/VxWUL1gh0m5oKHorknvsFaOzo7KgDi+pjkGkKPWJyije9tclIFFV2z4qTyxYneVIDcsvi9EZRcpnjGCdbBqkIEJURRHBB2bgmkB0YBTjeFZA/xSLMCh/7DjiJEDgcUCsP1KCIliaq7vb6OM0BfWL0JdYJ3/cYbTf8fJH39FHeRWORZaEq+olFUI7zKgbDUV/gFTBCImZd0eZl+GiGh6gLnqdLHQhHjNDEbgYiqS8UtJ2noMBus+igFCZtMX+7JEkBiuMyUIuOv+49umi5il58Kd03HUQRyOqfyd3nvPwrmxG0yEwUamp/qjNCthUASDxKAZvA46Z14pKh7VlpZWjf/7z02gff958/c/EQNw0VlVuK3ouj9GrR0itH9KJ1yJBBdWhZKE4Xo4wX7EaXgBbWMTUQR2yjLSvjPaeUbd7u5evitG0JxLK6QLwcEwpQxFQZCvCEwlMX0FADLnrgIcBXGiQ0RE8jI0cRIqUImJ55x7DHFgzzeJvv78Sb2IxqYfYu6qTUsNGFAZ5UZnEMJgazOK7M4la5qKswDtprWIbsonw41Lvdy1Cin+N267ibpblXyZRg5fZeUrRYNED44eOj2X44+sGqTk2AEg6URailsw30exFiFpBYyCTzLvcOElMlR3YWydY0UMmlxXh0wcmslgGzRUBpsR8ZKMn6tCqzWmvN9PRrs0kdHsUeEYG7bGBgA+gtSZ7A5rGBQWDzBNp4ObNCV2UZ7qhkYF5FAkuCRlneNT2fN3ihOEZLpKEtEwubEoYtdl0rouHY0qYIGI8uatbMISMS3mCOlCF9aW8/N6IrUO0aqNGcJe0LYmwMpK/GEGESt5v05S68kHkZ4CUzL4fxUrMvAb/stdnwcrktAC9XkCkaL1eb4z01OaUAm08Je27MPRalNddU2Ks4hFmBSU+BSA4WzXl5E4sgzSKuXwfkAdQ8w6Hv/g1xSZdvZdFnsY22DfPt1NooiGiY54odc+bMeUmQspgVc3Pz1XnerixkYJUqu3cdq5gWZLy26MSLMBTb1gc5v/czRV0fYzSjK/cMzR8QkSGDe158Q8cqKY2n6Rhh3Pd92DPOOHJP7/dUm5C4IMQ9lYYDj6bnc0FVey8mVU0p6BU7lOHpliwO0MbxN7R9vdh5xxDeQwql721C75FWiIPFWA3h82uCLYRHO2gnGz4aX/WXceGwVJaG/U7M6Ji2ct9f9dJLX/DhUy562lBU2D1QyiE8DRYDrTJHhe2B1hbBO3jCL1APkiVOrQsC8Sk25Nzq7e1a48gukIo5vqtNIkVY/vo1a38rZl4JzJA6JgB9VSmAnq5YscYCZeAiDKWOjK4E3x4UQnm4ogTZmxKXTolrTIkLYbwLK5PGIDWy+/9f+kZUnVTFyWiqpuTdUcBH7hWnj9WjFTmP1UdCfva3cj4dwuggedlv6kZS3+WI/LcQk0dlXLDvyfLvLy7O7kYSHwtB+mA37MegRElxxSmlgGeDKahAb6OoV7Sl68yrCtyy30ZZ+HJQ2v7mPrPXnD+BZ01kYcHGht39nbNXzvN18/s7+insrWkTzcfY0EfC9QHtpnUqlSZh4sMfzpPEMEj/Q63nqgXljxx+1SFOJIgHtr/4PP95XMB9gBKFII7Z79pNd0vBc7p/FUAq6qdXWXF6ZA227/JfUFRjuG7X3MTertqfffSQdd4E7oFzJKVmX0W9IBGNX/5ZZYb8JmgO/APGsf9XuOncZ50DAK1/tHVZ4fVUqUBP2fFV/2Z8UMZm0gKwnZx1AzXp4bv9IOOFAmWrqrKm9T/z+moR4RpXxQB0JQiEyi9CVwQAKIn9u1/likg0RTUeMKxW4+Ef62FTrOKGL3em6uoGIHUK1UpNQGH2MR0NNdyfQOUXGgGQv+RNc39NzF7DtyhmbltmLvSwoMAVmnsw+nmTdEBElkZNWBbKXosqOYXfe5LCUw0qXmoKCtcGW1gv1bECNnJ24e3yK/LDrGPdGjDjjPvZww01DlAdEH4bCrHN5Mr1AqQ4JdTTHm0YRHcQexWsC5Qqx97qb//BIvkBgpkbbXFGbdfiPDG6mzrIOLNMelIYrMcQCulvf+mLrYHwTE0MzKirjVlqbuRz5ZEdzk7tGon1VBcZ+8zn5WIbnxhTe00sqS5My0RNQBqKWWzhkx/wGdHL+VUimNAncg3eusREozEAl+pZ4k5TdoHsD3hlBR+0T44UZayE5oUlXeCFZJ5zLwqcKaG57Bb48UL/0ABYH+1Cz+zhdo3JfBjFdftE+ZyDv0dq0mimrfZMxz45iU2VcsNVYGlaCqAaIQK1ET1L8ygkQaOt55AZ8Cwz1NCMuqecGHkIaDWDGE0IBZ0PlHaO+ywrHHySaWM+Z+yE4cG4ri5Lu/yAJQ5+iAvrupyBYlYksLYZUbIBPUwKDqxtDI09xcuZIM+tF3MVq9gVy4tl/OG95IJ8W8IvEpR3SY/4yde5evwuOP17el0d9BGtiidb1SST9fc1qzNWd3WgSv5qCOqYdTWo1isQpz5GvewPlJKLviR+ugOKStnxQJecfaJ3u/E5nLehzzCFtDHm3vy/et6kUSHcmlKZWSgnVf1Df80Qx5tehlLLbWLrJPtDqy8G3Yc/Grcm+p4w9EQnO5xyb8GjwFwE+givnlH2celTrDpTXaw/4MBCocWoEaGu9T7+EHdHbwmoJ63sE7KAqKfI+NIi6UHMQBA1iCtfrU6X4J+T6j6pHyhzo1/1xFqI2pNs44s4+xRyWScpMR6h2r+ON6ribtCwfbujH77vnK+deeaVVX6+zDVi0DMPRsy0B9SAZrXLDHZtHerZfBXI8d+UVpQZ7yhargXUXFfvgkXztuxWBHArnT83bMvfX4x7YK4FMAQJRey0jPl+12buy7oaL21R88hQyxu6tqVsNT5QBZNY7FqUYusheUAdqivcZD0fGNs2GExc9bhHIOopRN19CsUi/bustwYvr6UhkqNhea9C9Ow97au5rxkCDw79b0ZRcyjBhSI0RPTfmugBeUeGFV8CB4VnhKzKePW4KzQvBHGcfckgkrMv2DsdDFV8ACvFEEmhPWiFdDuEjbFIay+MRTRoXHpXTnFjEGkx0Iu8NA+tcluIJCkth+tRri/3+8loHeI50ZQt7uT1Qj8H/NE6YI8pQB1oCZcjh3IoSVoqwPretme+4azarhwfMszdsIhJqPRWLwyuc/RpVXeOCLas+2mUUGKRWL/B1SDyZU+o/sp0ttUo5v22vbVNWjOu3/S/CkNS12zkYSoO7vreizd0oxjikNjHfeMNqG5aMraPDaCm75xtNnir0jCHRz7Tm8bLvVdUXJP6JfpwIeAGYRgfnC6pTRPGwuyPgZkqjSIlc+fyA7Jh6O2B4O1ey/4EmXTtCfEQKwhwM4mlbJeqZXmqllVjng3+/BJVj2gcyP5UcL9prvOPaq2mLthywTZoTYMBgdMV2ePzI4Qwog7bmLPoxyG44UcdqpQthyTGH/u+fEFtyi7qOfhSpeSp9aWVPZxawYcQyVjRUxNFcueXt2iQmYFKo1Krt5kvV7qxxQVXrGfgHj5clQ979sMVWmGVvxR6CoM78mXchNRtYAPp/LGAGxaQDuQe4b5cDqZxpHquDQVwQVvJ2+BPahv5NoHz6oh0ZRnwdHVze2krvtrODxbmEM1zFQs5NDsjZSH10HqLzuaVIVdSM7cjtg0H794jN/pn1qRu2sJlHNE48NaetQ4QQcQYGTepWwfQxaPtgxzWkmmQt+BCA6cLZs+vt7yt2fQY2ro9685Px3bRLh1fzbeUCBJRHXLCruLJzGROdS4hJfWmWbAvchH3oMZdqpiySHB6WMyK7AQqqnI9bcqXO/Icp+ji+G4n/50ChpuEcWNxXO6ZceAerqKjHDOlkFPynShC9DJqRaBGExSUDzf4Nv7nvIfv87jogGYA1J0UaHolcac1rTuvTOQO+OzLT5PptkBdButzp/b8NPFWeBrVNqn0NDqVahO1cZw2xVQaaKU+N+2Uhz/rFbv4q9MQKPiHJbpXcNIuKvhTfrlc8/FLsRP5EDhF8+21SXjZrVeIpzR6p1Ak8sQ/n3zL33zeo5x/8txYIpClwJk97clLdYTt4O7JMx3jWYi1aSccP0LRjRZ0FMPcw+hwwin8d6od0VBGdErrTuV8yB+i9QDfpiN6qh3RU6aM6CmjI8pVn8Z/O2REw+OMKI86/E9uOqI7MNoTtZ22yYjCbaWMKH+1A4HTqyN6uhtR5MNAIh8Cp7oRRZIbUcARmI6mDz5c/StOHRnX0yhHGZ/nGfPUn99zWfWv2IFmcwGv/PbqX7EL9TzoMdB3Cv7ZEgj5yaTiF/Adw5OCMHcXMOQVuBRGsK74Y21l+JTDywQ/C35m5OuS3bqmqL34DCY+Z6jhGHl5r/JsdMZ7oauCA6plVuvaYi6NG/ccc3AKMWe3iFg1cw+PLC+dyjSh6RTSIrc3G8gmA+eGJGuVz+g7Jm3yKw6fUW3Sb5aKgw/yzqg9lLVgY7Dvv9Q/dP0bY3Z5RC13aQvXmTfWsUI5Qd9wSGmpYEHeSPJRJA8G5dZyMDhSuGWQNKj8e/pXvhdOuTisd4QG0AUzoteKO2OZcbZv3tm1CEwILHVgsQpZpsAZrF7FaLqkAqyPoAIIWDswOHEEmWVOgPnMhvqqNkAiFdaoQSe1FJmwb1hSjijEcYSxaBXqJ76KoFjSRXKrW7IhLlTeMHT+8tWdsYfvMvFtn4nhyj9G88gXBlOyg1s0NqfFuAr3t3o7OH1NxPtQVWarbCn80qavs+hbBFU3EOvgNO/ArfXA2RvJwxL9vTVAU7YdgLNIbfE2POIceEVI+IxNKEvXLYGSGbsb8cl3uxF90d2IvuhuRF7cbsSXbUSsPlNsw2SnIJ5eY20e7szikeDqgqvaTftYi6E6diOeVYD0pFVmN+LLboQ3CyN1KDNvypYDYpFrEgfCsTp82Y3o3RoFouxGfGmpwBC7Ef3G7kZi7EaQWDmFx/5//5kBgMqQVrpypAgdyF2QSYwZLV8rsg2VG1OuzOoguTIVXBSilHR0rPTTw68GVofly1U9s/nGuLgdlGwg7xgO0095POVH7XRRTQ/R/ezv9Fyyv2DMk4cag0trCiuJNL6iUUWAR4S0/nWlzkikpaJKTO01XBjx1pybcus02qtk4D8wq4HqXDg3MaGVxBHH6xksD7lK4kT8U/BCBWicwKH4L7xu0nzR8b9425QvXq63AO19RN1x+m4P9dS9nbScyNrefX/7+aMX7PidC/fu+7WNN8YPLO2xgfP32j1G+Kwezpme1RuIX4aw9MtQTvkL9g7S/+RjXzlhHdd6HlWs1UFFGdnblULC9pGvxrF/V8zqBBVrsjiSGaTv9IJADq02O2cLdNxzf0IvCsG4crZWt+dm9bFzMz1bm5pHD5fzSH004LzT2CWhQDfr2f/CnnXspO0/891W4CXmr6+gbGt3K94I5QKWj6+wdT70OTO7sr+5UQp02nQJ8OigKXrN86aZXhZzJvyAuqk1uQyJkmzThSSqlBAhlRL2UWsI8SBzCp+RjTfKoYrFiHpQF0VmqlWFeYFv+ySE80RivaAq1otGxHoRJC0jYr0QawpG5UjhVNKpPiLWS1xbKLZivdiK9epQZBkV640uWVSv+iv6fpcOwV64DilKQvEUsV6dxXoRcCWS/bbgz/OVNVDDPritVy0qb/Q90db2Cm8SgF8HwEEOxETZAS4ZAVxagUPdAq5uAZfgLsJxAZcMpWwHuAYFAFdK9SngShy4ACaCoKsJ5aUmWWj5uCvDCV5qbHgXTRzpjAERqoxMhGEHs/nvFYxiUwGALPweSDu/cwAAs9c0gYPCC5yIQvzs40gh3h7g/GJzvjEPqqyg58TNli2sMoXwKjZ4PJk+sGLRNKYvNIyOOhlRh0/TmL5Qi6FImT690DuN6QvGmT6x2mvKvrIIwfShFg4EU5k+ZT/zYArTF0wyfWFeZbCsY5FJLisY4bKCE2HGnY8jZtwYeMGknVZrWje779CU3ZXbmrrtW+S2b9Hk9s2lSyomwiOqAkxfR3U/PovsCmfud/Y5fQWvERl7pcoyqdV8uBtckxsA+/G7W6w+SsRZ+Nmztr9/7TVrhkRFWk5NbtVjXwe+kSJpEOIi3ddFaJ9AvDZlX+dzq+9V/1lCxSQ7KAM3r7qvGzET+wnPD4+jouSE41jQjHpMHk1qLsVVqXfdBZPjai6Jj7vEcFfH124Slzp1aC6BubKS7SHF6nxtjL16DuOxcVZmXJepUxRV/LnjdaP+ySChlUTfeXKp+ihryWfQsIFSF3YgehBEPuBzE+BTAqpg+0kNNuiqNmN9tFP9WFEIvPGFpEEDRW9mTTtQk29rSj7QXS0DVT6Ccjpp9r/HfLH8mb5vrVltIMbiexFXVZxZ1b5+EtjB9OTLn0DnwJlzrAGEHk2mX/LZyLWggJ4uBPgJ+bgGCCI7q8CJVASFKViTaF3z+XVWVE34T2cSrhJW+KUIHACHdFeWB5W6ZCbUpa5QipazhrqpK0S+CHUpfxFiUk6viwIQXjAdMQVapWE6Av02AtMRCNOBya1sxkhbQvzE0pY6qlbUiLUterE8XJPoFO2gOsj8tNbwKlAIWIgDqHVy5V72wGvrGlI5IU4PeWIrx54RhUbSpBa8VaxEvgxK9pf4SkZE8oo46H7FAv0YmfXAP5RX8QUEe8/8gDhKpkUnlZeilBnpLEvFT1P/0zV1iMHo8JF/YNRDcVBvQ0k80W1T/tqqBlDoDHKne83cxVzM/kr66JEUwY+KZEv3/niExsWHNC1JX4G9lTO8Y4x+a2vV2M3+io84fz8nI6vQjr7XSXW/qNaDn0U13cXJcoaIazAuuF+ObZfZmxb6MbAmfYGMBHlisBwPqRhhlTcU6t5cuqwt4HiEA0RxPag3EZoOTtGTbAKZ0V6m3wpIZxbQ5Fd8NmlNKEBC6nHHunwJJKpvqFuYfjmNY1aVU9tx5fI/8EYEqtmPHyqrafGU9Ekav6oHzIVo5cgwHGA1HYeI/KX6aBfTxP1MDL6DebFgFS8VdT7JRkwGQBpFXVhUTGBRMfchLDf2OHcqGq1SqMpK4XRH9bzGhoTnRfrZsynA43IjCbKOQaAFqS7UVZVYVfKMP0ZpeW7AdblcnOYSoIGkZ+jqPgSXNHw8VnOh3R7yhMhjinwAcJMMhQ/tuvP8XTKvnJJq3kSEVIVGXksBuviSCRF66nRj1Uak+p2TNhSxsg4ww5EECnzy7YFzXRRF0I+X5egqqBLoJ3vB+R4KMLeexw/u3nfiDT0IcB5vwUJJ38++qE59MAsKX++7SoH4eYlcCk7AWJzFAJXl/H58lz2IRaVoqw/HtlTqhN2+zmqlbrZkNcyoFZtmtLMvoXKYbRitUkyYHsj+WU1nykArsVuQVQD3uCLc1XVXkoeUsv1SdxIBHU4H1rwDw8Op5R91WIRWPTuvqVXpwx4FbmR8GRmM9ouKOgykXhDcwhm4Yv457K1lf6+iH+KEQ56WcNDTNFWvz76sOc7kkvMWBRziIlwNaIKtpE7+gf0Fa0JnQ718WjSHUF4OcCP5Ng7uNmo2e+BmWukJ2gvb6rsgZJPQbiiSBgra8/xbJF1tCd/sicnRLpqW2B78A9o30Z7C31jPm5PGv9DGq3viNJAzzKp6S3X73FTUpeb6EQd3vW0+k7esdwtcw8gMlnMqJtYstYbv3oP+RKZl/6iQk+ExflOfrdNh4VLVAtVpF+sMmRMSDJNpukx3gYPaQMVIsXKvbhExbfTuljumqvEY6IK5pnrpPgZcB0Lwoi7tcpZcW2j/1DRfmiuNKGrmpA7YH9s7P4FoBcvo6Xf/ZPqaVOIeNHFtnbAgNuqt1Ayui36TRjNNL+Xp6SImXrk417I/QXy6bVoslnO1q7cb28NJES52SFA2zf720Ji31DeDL5niOZ48DIQ6a7OXKXTN2FNgkdIV7yIK3CGlJp9VSd5dTZYyV9esN1EFBSJlW4rGKRR81zgup9K394OdnThMdE5cIH3KQ+NSoAXsUO7QENmza8rpovvXrmGvrx8GFOI9tKbrkFrUc5HVuO/UR2Yo+mt9X32w6sGE7jQgbMa9ykjdBNrnpT3jxs4fdWPntT3nxs6WkipFaOkqpdTAT8SnOK6FYl5lB18nO3VslRh06teu5ae2DzVgqfXJMmo8+BPhiPO7yIJPtwDcdgTU3UGszFgdJPzbTEIdTjESjigaz0aUrGyJukyB5y3rWyhvqh8u41WoSbF1BZyCHUOM3u3VT2W3HwPPGmiEj9M8CqEIn67tN5vvmNL9hTGQHasXo9gWP1Y2PzSnFpxywZarimHN3bO+9BKBH7qAd0CwXqlYO4FRRdWc9lztZCCN0TqtOiOqRpZLK50x9mpwdxt1NrXO0HiA8KTiGJHoi9HPTXXBZNyzLikFBdGAGBjXRGlULx1RxqUjSo/024qH0roOo+mPSLBj59VD+WLbftxkTrnxKF+24wBFdoMgmkd1409SvaxZguIcSd4RBWLEYnJm6o4jO64PQR891+NxMXas/J9iEwiW2r8KnOsadXPr61QN9EOf7zlcWAvxSr67NNEAhQyc91XwhDq7YmqIw2DT3SD7CvqiA5HJlkR8Eftqi5oBB1XO7J+dNKrFKa0DDNlCGhBrP/irLjwYN9XPcCi2rdkDSOkrxseoNJCKK34zel+Bl3Ptb0xaQEcq7f/CJ37+E+zYBt1qmJQWtsENNB8N6v88clCrz48zGA06Slf/Bc1UToWrG6lHiArAAX5P25wAu17wQlFhaFhXJQ0cn5Q+J8WEBgk021JmESOMzojR4cB4o2xRohBvCJTxlugDviQeMljUJnytu27AT8E0FYw6o3CmqzoY4qc9e1jxzkq4VGsd0IMI8KtIrNI9cfrpLG5fl/u69xGB661FWCZ8HxYGdnbzjK/Zf7UbbPifvlb77pJHevA6VcrAUaCy0hXf8uK/7v0nUwa3NhcvxJH7vMKHcXok9aCC0QKtvbCv1f5/7dro5xSW3+FMWiAQWS4t5KgfNlFv1ihf5KdqpwY2zNLX+J5/rYWPf+t06ExvSM2+P/Q1OTDWEjsKKPWrNNLUYHMwbV4YSjkeNEbGAuu7HijgU5Rh+h8YkJiOG0AFBiqAw7vriTVkydJX/is1re+tOVG4GGt8njPhdvAov18u+v7k4QqLu4jnk29fKTTnH7sR5tst+Nk9uMC+d/Gzh9/32Ot64BHFVpsWgfRL8giPvdZ27iWjhuT2Ttt4o0orRLdejMA4xRXFn0ZfLXqkIFpyjSeFt0rWg2irny0Ujf5p0yp91BaW3UTH1OQ85TPSrbyDx648qxbgjxfgipTc8qXCQsqScg2sMuocuQA9hyl1Du01Lh+FvKkHBqVeeqUlpVBr0JrbzNj1DHoQiWstrBC87OJuDLXUnyQ1dVWaregjUJOJfz7nYnCJrsXFSZnfKgXMEn+dgNTPwkRfC2CjSNeOOchVUIFYM+wADSENoc6w6IiYmDpiW0rVByxsBGoGNrHcRtSv80yBHFtsyhgURDNcnIX4jEUswGsXtbDktIwVHMUDHea10q1NoOr1Qu0XEG4J2SyztQorym2B80UUc7LfovbCQH1Q77vzxZTmcZ7CRYTUEiYlUJ/2onBLdfldhDZ5itakipxuKEyNdiyehca5sTILBM9Ju2O48XF2a81anXtUUaTq1PprJ3Bqvbld9NeeyC762Z43+mlNPzWHSh5y12zufzUv3je+7vgd/pHg5D33g7Wa8NyPuNB57uf51edBx6Fp62p+WzuBH/9PMivkGT/+4JGcH/9PIIVC5ZWcH/9Xv8758d+szkfk1b//khdyAWuPv2//17xumm9/1KXINObe/xDiHqXz7sOvG3fe3T3gnHfjZcx5995pzrsL/uxqxui1R+HB+/TKdl4mjPW/+N95VPtP/4G+l/2odDq92fcaJ+fKvcB+3blyDyuu3J0jd2/ckTtENA/p/krsHkOOcQeqgMIkzjFjSxrIVRZxZftNucJNh7rxjCg03DSOSFUEwuWjnKoOsDDOGGZkkEcoD6RlH3ut89keTPhs/z2k1tLXx+ww0Xulu1Bf2eXrVO+/cm3GhxPs8rqnbK20fjSj5QuTpUIUnbkjYhAy5Ctwp9y2DD0H0TKqcTZTjfefz6DXnY8XuTtk2FuZTyxnwNNeV5U9AjIZpzgqfVMHzdKq86ql2PZCtG4WqhhlNcZa3ii/Us/sGqHUPaXYVYL2owRXCySETGFSIxr3CD6n+Me2VZvIkcGlxhh8AF/MTeCBAyh6R001dV+kkDQlE+Ip/gS9QHOkuyx8DVIY2ldvVrH428SnLTE3l/D+faQMbX1rjbNA5B+B7LCIH7ZBImqrlQLZ0cmO3kiUWiUI64BLk9EY7VYRyEQTU4WfB8gk0h+GhIDVStV8itHg2NzsVug0cgAqGCkLPeOG1qoNJW1oYmhADLUd21D0CBLwFqWUZNcjjiK5RYGE3aWEIj0GyeYmPoU7m7kUto5yZc+pH+oFyDFnwuGYM+HIOSrmT7XgAGPky9fqQliog2/IAiIsWdBJ7rwHv+p1U70HHwHNs/5pA8iEQqGPCIkfeeefNjbzICJMLLUIXXfuYGMYbk9Uq4pfPNPOBggU3poGq5s6QeoKEJUq6sdC1AgET3zQhtYHLSSd+4GgqFM1K0yHgarOB206Uml9SqWJqXSt4vgWle4vpFNAmDE/s8Fa+nNgiPTqamC2Ohi1sDRY7xuY6xIQ2tH3NBWZQZ7xJjyToer+ftUmQTFg4/3Kwh4BdaoLu9zOVoIaGTMCUqStyReaA7lE/eRWMPgfDt0K5lVWMK+yhgXjaxhQ8AEjIwxVOPQ6WeKh/4QlzDkaF4YPrYxQr6s85oK174H2PTYCVF3jRCqt4h8NJTiD1W+huqZwiLAAtFAJ8skjlAfSste/zi1s9YmF7Q2PgZ954wQ/06ryM60JfmZ3yc+E2Q/j4xPxL9897fCkwvKqbjvWetiHKw86fgRlU2DF9Fq/4+NG+aJH3f2bJrofvsR1Hy9j3X/qNHaOD/j3PwpOrhAwKL7ygphd/yqJlkaoRoRmUd69mkWGSbMcH77JScNXEc/B9xHusrShKpAdbWjXNvSdsZvMVLJd8EHCc1MOlS6Xy0b9K7Bginvyht4ssP+VnsabM3Eci6UaLIker+46azzuo04c9ZCuM6umF8ZUA6wroZBDC7BstUaRLvFvYnhwDyMkW6fflmopAujJACiW+vvWEOJakaJUtib1kp/9mO5IwjKeu1wm3ozEVjCaxqxomeHHkUGZzGZ/WU+XLFuhe+SfcEXg9SfdB3EfI2oYDDwkwy3aHj8ldQPDGKtsI2q4HqhFIpUum64tCwDFJiXVaEJ0Jsc5LroJtQD3OgrDoIRhYGAYWBhqCHHKa9YqTUhNr4umqpGWo1wrR7nG7cMYTxtcHffJMW6rBb48BjEw8LsVCcKvAZ807jbEwVzf/ly0YfWSTSRMmUI45lxvRi49FQBQGH1tpPAQuQfbAQEAz0+cj2GY9FuwkLpVk29zoU7aBCc1+H5eq/uebsC5DfYoSEMRj5syMGK0rZPKmnx2TfNICHlQcIBcakZK7a35+rwUTH2Q/nbo11l9ylrMq8pvVRvIKuOJITjlOmKo2oQCeaxoz0YY8XyYcQnC8Esnx2gNPehpmnPUP6uIaz9Sc6MSUkNLb2rBvtYbadGxlupxqXC9sVk5cnII3MuFUSxXb59SPLU8VILWu86Z9lea3veOX0nNVFKrSIQ8rQSofNKd2RwkwBdXy0RX0EDUdJyGnHwrjt/b2vFAmqohP4MujfQB3/cdKsFrYTSiFR86IhHIpN2DkEzacxGCSkQkiIN1+SwJK7btQpjV50RJ/mLxHoWfna6d2rq8jsnl5HRUxxMTQCuLtSZfa/K4RDxQYaAV6tYGFW5Wj6f1jMKjrCfQekKtx9N6aloPpovWgslyvDpqWsfYwNYV5pHzvJj+eaAQd4cvcRXioLG65hg3gxh2hFD9PorRTvFGYCb4RRIOZVLvQZi7IfTt92truCAsv+e6hiqo5UZQaBuKuYQn9jhaXV3rCrQuH6CJ7SijSh3lCFVuXpOvNY0Ob1lTqDVFWpOvNXlakw6v1qTDe/yaPK1pdIDLmgIDQq3J05pqWpMOMOrBAB+/lprWMjbEiQ5xXJHZf7yyEdo9qdejaqehhjGOuUwpXeTqxFWouSd73p/oQbeEFrCWSigBOiIk7d6JkNo3DTiTKGRRddSpUa7xdWx/rF5/IqYGbX9A32S7nbR8UR3XOmKpAIAkqRFr+ypCsrZ3JXS1rOMhP3OY23rCmrQArSkXjVSqFKuTKSVqnkuhV0dknRoM3YYCxyr8ODt7v+p70clCtYZmRArcWIFbN0ANjRJFCdRaCdRaCdRaCdTacYEalkCNVFLE6dKQCsLHWmTdwbCsarWsqqtVLWjLa5sDEFEOcMIp4eCUPwk3A9xPB35kKI6CLhwDXYVXj/q+Kn29EnfMRT9IGECKs9vRBusM4DqtxctjFUgp0EWigQ5hLuJjXbcID4UtQgrb0gGj6lPIOo6WyOUnPU91kI5l6jUwTS1kwX2aZwBjjtq+VDm7mHzrHkd7pDsUHy0quV1SOaYWkP0UPi/qovylB9qWO6iPUJXw9IDOt6FdyinXhZvEICsYs7doW3ypFE34trwuBqVg8EllTpCGhU6856fvjKbhNwVlexEODA3uSjh8MWjwgqJVxg/dXAHddHO1EyGZmtpZRStMeYfJ1rZsLEQhLuAMEEJjHFYGZOoarQZjit4azO5fi6p0EsdT63im9BklqyHGmk7H6aXXZWpqyQumEwphVLtp8SLZhSipWvLJgafwNit5suC6GY0MkWavVHf7Teg7dxEnoYzjHu+OPs7dQ+ON8jIwGdmVhLpVLiXP0ZwKZaF6ev0I0lb3ISXShrrChYytusJhEoI3wuLTFdoXmpVtQUIZhzJlfIVelLhV57dQyAm6okoE1a5IoepjGR9wL6QqX8DSldBLTC0++ulP1nOcCp6ppyDiWRW6jI9ryQC/ryUXdX6XBdVcXQFQLNIhhyKdhmqGFCnSacggXUibgbdIHlHzFOce196i8UA60820XETwcGgHWbb2z2IfUBSakY5ypl8Og4CXN2d4tOYMj3pgdSZFUjNxFKlAqpw1STlrQjtrIuUU4AAZD93+SEi3P0F/p/IEu8ue6eKip5BRRRgd49kKNxE8BccRPPknEjx5IxmKqCxW8hb1CpupR7Q4JlGtKKVn2su6dC+RUGigEGnPo7LnEZKwv5jWdymlnPWNKpNp9ku0VuUz+1foYWCkrKavVSQCWQps1cDgsyS0ILQNoQy0rWQ1sSFDO9CmMVaTY/U2sqNeqlDVT2Sdl6F4lmotgu/MG1THCi2cFMiNclNAo1Q0/91lhl8KvWSS8IGfUH7DVw4KdlLxGsh9T763Bv1f6wnE/3YRpKAhkF2re2pl7ZUx0pGQLLHNQiaLTjbL/cdgWsCjhpWZ1sPRpys/1vLjsvy4Un6gWaZwaVjsJ8vWs5NRIt9QIt/Ugdciy9rTynSoX8Lksy56LQCJ2sOB1RkFyUn01zU5sXRNGWqELEMdW/pD+FkooRKnlSoCrSIoqwjKKhpaYFOJXoiK6rC1lNenFqxMTuqIVVolU3/mOYShkkIpnvgvhMUrvRfoEAU0RJoIjMey5jBHUKyud+7tLOmWs2RB51EmEbvkhAShnTrBZSJibxkK1gT97SVbEJqeFE14ioLSNAcSzKWkHL1EbojrIWngrCsk6Vv9aayADi2aq0NmZoUFfa0EfYKQRciSlQlLViZ0rMwENgL0kzxHrOhYV3V7CgrXiQhCwZDUyKs26AS4ECsu1Cu4kOTeVDxQp2XT0UAuK5cHSZDxWk0XqqlVAN8p5njuGF+FQwATLl4HlYvXartDr/vas/ncD5CuUmO934rOYL3O1lVhTz9GDi3dl1euEGfCcu+gevEaL7g+Nnrx+mJcB/6CvXjNV0HtLa4AGUKxsCBtyn5az/8rx/8T167f+rpHfO36/7yLz3eEPuxdTyo4ulHu+y/l8dSrMNdIj/lVLG5mf4grotkf4RcKKDyh9WT3HolBzt0jMZBaXjQS4+nYPW+To9dLxOebfqBOFVXqV42pywt0ifTOQ/Z25w80LBKjl4Cq6qoMESlShnjod+A8QFerFgIH7m5mkYq7VErvwNOjhsmnqRKH6c0J/EAFZoOBR2g9CWJUrWsOxYWGqBDU9Vyu//HamsDnbn6WtiHd1csGrl5ucFPsbUs5YraXKSlVfXttp41Wq6i2Mu8l1gxtXVCtdN8UlxcGNaZqokbvSN477Y7kRCxmnp7nzugJefZzehL3Cc/zp92Z1F6LAgdya+0eYDAeq6N5keoG1VQ467uLj5q8u5J87mTyzkryrmqyVNmd1o6Wi/yKRlavvaAw1+dfPSOdEytP4PzDlwf817oueLnteBEIa3iQL8DvvaZcbFW9pW+cQlhcLhLjfQepTUS1kMj96NfOrt3/9hsO1UQJrS+OqO6V96nzJzymaTD+I5+pUYG8pSja1vvX/eTFMPSN+761ACu6fMVzTG00ckQLjFjXGCWI2Xw8WoysRUatF+ezJA2egwEY+RaeXUSvfSNf1DryGDb8+9avWxvpOM+YfTHuz0Vi0u9DMOmHhItIIoa0CL+i/GFE6LD4KayJf9Eldaa4wLRJvavOUyZmeebBWYcHvbxLc+jQFn5wh1doAdLDHhewGhilO9yLjvDoFrVvnWr9eWu+jbbCqHtOInYDhelgGU+EEsOH6yo/wBvlFKmaWB4h9TvzAo9L8h1TiiUukrhoyrcKMFbEKw8VqiyxRPkBmrsaYJldM552YA2d9A0srsadIt1YUsXL7bSTPeSgrXQKAlvRYNJIom0auS01mplc6Rb0o2JRPoDpenbKU+yk7ZyXiMOwMs0JiPkiYh5ADGlWfilsgmbNNKt+LFlrFMDXHEfwk3o8mR5CsMdQu+4HipjfH8T7AiH4ZQ6KOKamjmHhW1eVP8X1Y0RdisWU9U7uVeuGu3/7hbv/230X2ycDxEJ6z7fYJ9p4Shn96/YpTUf0Xtzn/6B9oghuqqRcsfK97zr2fvt0KT9wdXDO67esv9c+NaUg/cdvXPCXOKf+hy+u/cTv/+cL//izT7NPaejnbz/z9Z/77H/+gH0CXIh/xVff8d1/sfW3nm6fNv4T3/uhLQPvjA/ap43/mQez2dnZ6y+2Txt/6Xfh32980D41XluK/unS9UH7RNqEtynpMY135+N7Dn3gr/75zvfbp3z6kXe86/1v+dv86fZpm/H277j94HNf+aYP2KeNP7z4u9yNf366fdr4/+8/fGjpwIf+4wft08Y/W7rx0xfbp+vOdpg+98zE8sp5+/C3TzN0//AnvWLbw99RnDolkU3zA5W5NN9E2Sdn/3bCtw9/ByqF5Am4yFOYUBjRaUTyKW19+Pc8Gs9ttDNio7zcz4SKrmJlXrWOdDvI0aGs73NGfsRYqB0xjVUSB354Fx5ZcbpY6cE8zs/ARE+gnXumrhdn4cNPy4dnK+1F6T0K8GjzVzP4kntxdn4GxZxnF9aWc1QH3GgJnQW6+gRsSWbY8Fa+m86mGXrCAezGmcZ28MqTspjnuLU849e4fzDgYIun7xO54CfRGfmT6Uy4TjcrRRsOqJf5p1DvYSAOPcSBmSxj9KhErQEbl6biRqCTF5TlO6jF9PxJTMyfDCref2WeUyHOIiLaki/RSj5Lq1IbZG7qRm0nzZbhU2ipDBNFZZgJC80ixOhUk+dW4NY2iuTlVFqS52mIPNf6IdPzWHZigNinUJcIgfPKZJpnG/Rlni8a9wwIgBRzoVinMi6U5xdTbSQApbocmERPfCHld+Wzwx63EBNA65rj2lEOV4BolCDRrglPofNQgX5N8jFto3MRt03iBtyiaomcKpm6dOrUEuFYQjuFr3dzn6QbhDiSuLu4upESiZCJP+y6Ep1nEzk0XMJjiWbxmLXzJoeAIdc5QYXwEgXtkOcO2iLPLbQizxValeeq9TMwY+YXzcv8wiOjFh4tehIeT6In0+41xtXlPj+W6Yn47on0hG9V0boR0p7TfwVf6fBqflrODP/f68z45sz45swIUkyE4EX5+XhcimUCWM4lnMGhBDdv8hbCmAodlHU213T+ARTHM0JCT2T03cMT4gk8IXY/+glB4xPiCXnOk6HgibCDJ8QWeiL3fbeZFHOU5/GUiTEPNnyTiRFVJsa8Mt+MLZGZFLOVSWEHdN6gAZHis4nXKWaRG5gtCP3zz37e/T/07s9fbJ/FdnCRW/l7ZVNExmCfxbmcKNilJQMPBV01tjs5P4gEHQmlllOM7FxBbNk8MDI6VxDt8FB7s9UhNRWkNZ8iJeo0GUVqeOGhSaRWxD0ubs/jMQ+PUZhQitu54G7+KHH8CdizPYFalAErn4y3JzOOZ8DLJ+LtibQbb7sZ1Qmovgef76HzZREAqkMe+yTwRUDuPKtg9opg9pMOcK2MfS3G5wXG52XG5y3BXoOWtIWRNslJnjVxsr+DFriPK9g/creW8wLoic4zcOYYMjmDpciXwGpW0DKu0muKDQpGioIOyxz1rQwglaRUh86S3uqYcTRSsW082THDKM2aUZoH9GXo8JybHDWAdYcdlQVAfoFWKJORwxvzw3hb5nHNMKwtfMDkSD84k86ic15U8A+23K9cU5+7Z9I5NHMgn8G+kSEf0y6w2exMCR/RGSUT/azcyC4KuL5Tb70IhRxqISTmWZ7Ez+glcN3L48tY0sRq30MYogccYLYOmAKL5Xyh6twXvqR6GO0zaAf3lpPgoGyOkwualx2sig1QIhMy7GjtsFJNeIQi54i9PLaIwAc1eScd6VzOjxAjY47nVl2lamYtzuUpC+m5uiO/mgIMu26UlBzhI/UyFVDXLtFYfkFPNAlnsKApsoXfbYuwO3zO7Tb3XYNFmO2bLs+gEuLkKsDaqB+TjNecCpFwgi3gCGuOgRBMc1G0pEhI2EMd1PujFtHUuz31rIJVimFYxjC0RbLW4aHIOF8rz3lJKHi+7eDlYYuKGsTHLq1w/bzqTTHmV+s9vMAd3IEsqwJhEskOxbIW6fq+ihbr0iDSH4rFcsQif2oJL8tlqE1cKZdoS9om38pYnkqLt3Hu00xuQN/uHyOaAwHuEqrCRLZbefgCU34Fnymoq5/lZhXabGRczgI5zwWBKCPnaVYmMz8wl/HIqcBjhP5eh4lqzVypyeKazteVvszsBTyYFjORyGN++PAZHsuFRnMANUySNgtOo+v8l3siMA3sccQD3f0jktIC51pGck8+y5DkpCxWM6l53Zj4VTeTapRE79s2VKrahJBSbxeLAFBtCNSQmRLQBBgFVdsHkHjWlNu2CCV1t6gBYfsBphIQn6aY+SH5EE7O4AFmyt8QB4ezlMr0n0MbGTAAzmU9Dh1Vmsx26+ZRNs3CQ3exoF4Zd+eLeOzMG6qYBDlYBiseIaSk1JBDah4FiAcNyi3R0nRv3jpNVadwmtNxdWO5SGZRWZqWg3yZJMu0xIjBj5p4HOdXieAloCbdUxEi/O0Tt3IZ9eK15l7RcCh/zFvXb110bookZsnQCjwvN8+95rlbz4W7lInBLbViC8gF8EQOSEz6Gmf8RPyEh3KQc1mQe3IhpJ0vokHS5gagvbpWbAX94T4u5jUdDVXrqINYCLki7r8Rxxpoi5ZHbhUwnQddQIZLrEmJy8RfSu6ttCQjjEQpsAcwr+jkhKs5pQeSdxEzaVENpjUAR2Xgu4wQaxvFttvy7eiIbWSDZn6AuyGlVh22Ut9zvTGtIArEbjgj1YthEScnGWc5mOAANEXRCzXJ5qYLdfFbQPi8jWaocU2PaEg1a1NHG6o++SC85SUYjV3Lu6QqV+3+QTmEmBMywpQGZKXgeXOpRaeuPaT+HR6045jon7TFH1Vt8ccuWFdb/Me3s7+5LX7nDYk8uQgcq6Oj0vVPsndoQl12KTwookm7/H+OvnjXTrl0idOdB0dPd/wvuBMcTRKL/l/Ww5waThoC7X2oPoeTPr6wp+vBZbCtoYd7b1dz9+SVqxy4I8md/ZJexcXg3e0VkfPkIidmuCyC/g5xE+624dhnVfMoWnn6N0mQwZz2dZVrPGG1l4d+cbSXD7leapL08kYEU/3iztEvgoG8Tz/1OixpKE0/S80tc7EY9iNoRTlGpSP7XXsHDwXwL6Ee3MHYss75NTC4DAon3nCbfU/Wj5bqE5ljZLQmo1a/BSmQVA3mxcfaJJqGCnicM0tiHqmqxL4fvPnitb98wu8QPPLgep9nTVrytKOmrEOpyGMDiqqGx8RIrwAM9gBfnH1ZDXZjVA6iAgQkuYjFHFScvQ20ElVg4sdlOomnZyydLRFqt8Sfwrod/KM2oIb8e3LQ3QIRatkT7oZx86Y03eOE1NKNlCJElh5FSC7OM2jbilK0pstyks/gsSBnihnV81lw1JCFY8EDiEHkNDRHGRfPgLagnJ9q/HxBVoyQ8NxtnmSeuNH5smuYjM6qSzs9UxSF6my/RnFb54j/uK0JfB6AF1rkE3whhsYJOc7O4KmJYizELV1AF2S40Xvha+0asQAwCdVMhWpqbrdk2D2VHrMq00E1QUBKnqP6Laglku+xPwooEwakSRAfLeHv0t5+cMIUcVO1UzioQHsoLZeBBUcHvb5XNlQhozY34uoy4Im/GJFdcoD73FJ+qEZidq1BqV0PltGBOR7/JSnRE1+OFIlbDucTSPlEs6+TjjW1T1ASJY/Ji64d1lSZWTtmcU1hljLEZdTWhS90N9hgksJ3yrYjJpZx1K9O2PVtt76dZQ14cdRFioaBpmRiuesiKFkhdLq/k2mqhthqeLdM3VOGiODhV5z+KKH9ZVBF1WC6SK0OHC2b+sbH05wYBGIc9rL3lsbDcGqae6VVsfeVCblXsYJAtjm/4oXeKz0m1aUbReMQ4nT4WcKHXTSFETbJ1aFbEeNHyPOq6BSnYkQG6v/8CMSUMig6KQBWNRuXR4jz9TvjHb/GuoDqR/+o2PGSne/9optE4iBeFnYThfvJfvZOWXGO+kEdjX7lSRn34O9faK17/OQ//VUCHbd3qdGLcSMfmld0Y52hj5/gbyjo/+6/vCt0Zj5+BQUUAeqKxMcwAKA79YRi1nmHHpACgukkVgiezbrdUhjIVwT0kdBqGbdT1GeRifSxigciI8ArrsAroEiBI3cas3fraGuXguxXK2Y/1PzV5uYv/vujMX+xMW7+ghtTNf+BtzEDGC9k9Fe8VUbO4L2glpj/6d/yyhfqh0H2HpRv5sM0EzBqpIvCTUzAjFob+bWTsTaidigUS5wZCu2YsUPxJS/0BfemeO6q3BpQ3VngA9YK4ENdjSgBlaDuCtww5uy74L/VJUGs16r6q7iLIspVDVWPtWa4E4qQ2LCWfLSYhuYNgCBRFUGAHrlBk8I4wdLrLlwK4BZWNJ4kk6eZRjxkfc9JGwl51yulVN+VGvCIrhXHsRTyCmFeZPDQmZaZjBIBsttCnK85fJMDbwuSP+hq/gWJAKHpmjheS8QzqOb1TV6GpRDA/jE1HfiH0II+OTLygCMjbxp+RBDk/aNkxFc5RN3RE3yk9CQBARB68qP8MYPl0I8OlZ7Usw+M2Awy5DxSHRhj+Cf7oJvceD1amdz+12Nyf2hicj9Qndx4e+ST+zBPbvkwyD78eE7uX38Ek1vHrjq5Hygn9+VcZnUSh+a6aahjoiOS8zueRWjnE9qffURyoDQ3idKn8sxxEwWlAr6lI2QGyFrhm099N0fQ3fTbPG8TvxELa2Mqm4hMxmeef5ITODzpCTzdlFK1j6HtY3LCPqKY9F0hm1OMSoFfrXLNFBP2BfzAa3Z+cIXGPI8Unwpc19ewaFVfruGEQmx6cLXk2QJzdRqnnnH2SRFwqaHEAFqfxNP1ADy+lBvkqVadd0E9PqQITAGzowdwPJkceFHesJQCOzeIPPB3WQ83g7H/q+MnOrC2Iex4AOVneFKiJoXwt9Ag/pPt5nWScNWLDuDxbLGacyB7m8KfErmYrdc+xBtnpt1ubqyrw5tUXeCkKPfAhhgnFqmAzg7pHfkVZ6/MmGb/JNtGcbuTFK1KIoQc7SPDYgY17S461KGZK3uoCBvONoyNdzlxZjgcFi3k2VW0ObqFPNwKKO9KDQyLuoENHl1pHLh9DjQP9L3stwUjQmpgJmlGI/kRSKG3Mi5fw0SlwJkJ+SbWHA9rIA/4umHN77zu3xprvvqqk8MaJV5VrLnELuv9+ACe8vnqAeykrKUTjFVM9ex30c1OOhH/UcSnXwh8z9kvOMzWC+v2/jGxwO+BkOpTxBLg/h8MBRB5RL6uc3Uwa7X+Buwf88vd/hpqZCBEkpRtoBeFB4uVoh3tZe9BDPCvfzDC1SoJPhBCixu717qq89fFDEjXJoKkozzy0BnAGGvHH9g9DKmHLxEncjex9t6EDqN9N0V8zwMZEd+/yV+TNI0/er2NPzgSr26GaioZq+ESJvecu692Lm9B3l3avw+ZEjwgQBl7uIy9aFrkbhf54TJy57TI7rTPW1Miyxhtep1H1aLNTZFbPA/DQ4+9YIavbvL4yYTkIJ4xPNclgN4hvIYswcTTWPsLMF2BcUX8IsW/AgP4MhQARgfJnMJRL0Eh/WCNz4rP869GRf2AfQoe0JyMvXIx7AWU9D+NWUPxAb0KY+nKqrpg2n2AIpEYxWJHL/fUO68VySFNzXZiM0GeNE7YTp1v1nIqzOGi9R7XKqXrdJN+dQtPv/J6hQdbUbJp+U5KQDGfTQmcqknx/GlDKkX5oLXZX4NMaf5LJD90XNXjAXmV6VkE0pog+7x+sMu/OgdUGzxkaARQO+Ev76mJ3ZxEC4GAJtH6IftB8AsI7pbg/QieJcEbPRH1IPgQYkmCBxG7iqB6EetK8EEEFyR4EzJkEjyEYIIgaI1hUA9gBuL64scwdVyrQo3VJU0bOBnbKGMUPxPGO4uNXwqnY6NDu+lYOYqNcQUbI4uNnmIjRlyxMXLYyHgI7NHxOoBMDgE9iqYiII+bKPR7DudCEWSWOBdIE2R3oTgXKc4FwLnA3F+axDmzSgW9IjguznmKcyHKPwHOBRRUcc6T1nhVnAu+sXEuqODc7z3OOPdErxQPAgmMb0h1FR1kv68sgaEQuu05/hfHpnzxh+cE29gdTGhWVVyUKoLqkdHG2JHR29whz4Y7MnpX5cjo7rEv3ue+uNt98ZHyhCjRO8/68T1jH3/UfXyP+/jjCKptI5xoxGVIlRFUB4H02iEwCyHlaxCSWtX3B0IZQu3yutcMQjsNO3YW8LljFJd8YzcZcbMvKuZo9sB+nJfMq7PHhRfli4LMep1ofn++jNfdKLSL0C6EtogcCgu/KN5Bv0m2gBltoYjmX1z0qEcLL+LHwoH9B4pV1M0xi/uZxyx6/LYfG/RZ6uJqz37qQCUBDqAR26MVWoasI1+h2X4I6b2Ph0+RyE9UsK84IZ7g8614nJtvw4Py7XokRH2BujqDWFnL/k7yN2gexCLvCec6hzAUTdocpIQWD6xRC65P8gVa7oeXQjEPFsFFEwylFbMISsFwDo0uRHJxa1bObDBYPJXQiwhNjjhdfVUatRbq4cx6hhZwkM010Govb/UFt+Rjrlq8sapkBX5jinz0PHU7cjF5xWC9iIvuQxyx7/YfrB266L7zX5kX/Bnp2TMS0FopPZ9zfWi4PiyrcXKwjNhDYOjR+1WxeJpvmWRE8x0MkY7RE+jzTBPes0Nb8Ce+GPKMm9CgZUCnS5ka6FgQOzPLtABMW1nTnq4V7N/Hz/KdhCcrJuqxkti16pG/hkja8fDnvXyHniWxlifczwGs6pbRl2bkkTswUx0PHzXgalzDh3LbKQ9/znv4PndeVszSrGQ+lXZWk1RBSP3o6l0bqw26qOM3h/7YJkZSOUGJEd1gjjkjblnFMMSqFkcozqiddXC7vUPi/sgdqBXmbmNAO1T7BbzXNQyiF7MXi/cW0J0qKL+ylxcjc0AdC+UpEp8P5OD5+qy2R9swRZfVd2k+J6gicEtV51BwqFgFFvkvyrcovvSE5jBTqWt3vmjui45Rsk87Sna/o2T3IZg6ZPONOsLYx19wH2uSqiMoGdwiClDmhP+Xxk743YeapCf8CKZ9aRLOLo0j475UI72mjokzLtyLFUBpBVgKO51MBA4Y/ETbpSDoc0MviHrY2s1zYBEEASOZ5D4tmJnuG/ciPmw0+W62rwC5eobhQGRiUWhFz7kfKomSUCSd6HhVN1bqQzdCc5BTMc0HdksHQLF7oNjcKrkTWRuljVJSMSv1a8nCpPVBf1AmQAM63gF18EBmMdyz2sO6AwLOqzO8HgSMi0bZniIZoxjzPHD/E44lpitk7TAKWXhebp4Wz7G7z/CndGOL0A3xeNbEDdNFQzcWKRmnG5HQjVMJT2jBKhUQr+rL+WyFGsxaIrBjZKZrckY76NQyNlNNvJ6QlTouSvCA9hwNsEpTXdoCQENvfa/MeQ3vNnO+ow2kOUcHJKz0IcP0z6hjfJBUhsTBHvSz0++wtyUzTFC4cmMx78ZicWwsajoWiRDbOv4UsupPfl6o2LQxyk+F8D6jBSyFi3nEQPSJkXF6Xi79VPIFqjtphaIRYq7g5KHZQYasm5gddo4ovsq5fDFrILoAiJ1qoLlDoFYX084VSOULU2HQG4NBnWFwDSPPo8LHRVrAn0ItEZj1gI8ZJQwazE8Ui2WcZsW6yQhGMgqEcl0ZL8Qv99qXDLfp7UuNX45i7vlATV1RI6t5F8FbiS+4uwM2mjxE4XV8CYuseqBxE1e32JlY7LyC4bibNHw5h4k2w9oFFLhAnarXb7V30KZVmlEmSZdxpY2roI2Ylco9dYk/LmkIT52FvGc6BRaOM4nnu6KAiAvZylUtv6qHYzZDvPwD/C1WfqZxummzc8/wTylwJ6UZRM5Qy+LG26r8k9odAIIgWqaT5YkW+iF/4hihLY4RisfQCKyKufp/rZKiZIzpAbuIv0t7IgzB0kVbKFa2R3op3GOPP1ulmIBSFWz5L4wG/w0UjNFcXxwZU6LvGBqyDA0YZ1Uc30F6r2ySp8HE06RNeZoewNez94cz6mzC0wSMtqJ6gLCxC0srkzxNgsIZG8xw0IJu3BYdoJc3BzTAmtGiYNIqdTkEyPV0RyFDt0xQEaswSyBWApUVq60dVVJhi5QSmamF6AQBoxTwgnesU1S4RROqRVVatEo85CpOKICZK4DVimG3FvHC9EEBJ8xWjbaqurgyW13HbKlNOsNsxYbZSqczW/OG2fqxMWZL3pXZ0qAwWwimiuBVZmvs4y+4jzVJmS35WFSk8mXDbN08xmy5DzVJmS0E0740CVu8A2aeSTXKbC0jbpLZCrCbArPVOKAzaRVtl4LyjhCUVWW2OhyQ3RnGZDH3aVXXcncaTwtm1CaZrUVELtq78ZbZ+rGTZbaQc3Nma/6EzJaOe6QnJ+/z8Cx5qwAmvzY8qbzCikmNWxwsADdsOqVt87LYAebFXNm+YmFiu5by7eI8e1SLXUbz+Lu0Z6nXHC2oqdSOkq4VIV0L5TTjfHrxyLBegWO9+PE+jyHT90bYL1+2YRWqpaRpkgmzsRnNChPG5W2gPFlN6pYR08loNmPYclYYscAtaUqolrW51HXES8JK1OZBs+Zp+VJzI3X5mcJnZQ7s8w7sq6NgB9Zy7Zkan8GemfjRq8BgRddKw3atTpIvf4JqMdGgzhSqpYrjxyVaYFmqFAtKtBUAsjQlX1AlfKMFuVxlP3UeOjTMlOgqAyr46KE3DjBbHGDmJxhQ4COYL8dKAbtWpcwtNH8CBnQV3MQ8tlonZkCBUY4BDZQBDTJFJceAWmXZKgOajDKgIDyGAQ2UAQW2LABDFkoMAd2aAoNJBnSBUjDh849mTgJZ8KdQWwTMLAO6OI0BHZmVVfYzqLKfQZX9DAz7mdCsmZcny4EqHDfnQBfspZLFCgcaVDjQgGiz6boKbn/VIKZOxxpQ10F8cfPpCFB3aEWno9nsLE6bdZnM09FZFzG+zQLfZOb5OvOi0Zm3OeYsVLkEWp7GQMfU1DVNlj435ebN0hdj6ePmKi8tGLCsHywI9VvdjJfmOW3aWOSUU3HlZqx0LM2yS6Oy0tbanPHI3dIsOIq1cvt/ODPu8k0TT8yS1a1kfeCNSdZvGRPV3CTv4B40SbmHmxG0lzHGvrjdfXGn++KtCFrJuhHij334NvehJqkQv/wwFCJbSq9jFYVbQ2k7EUpKiXajFJ03S8F6qnL4li7u7VLMPlMK5julOD4rRfTqshuhuaqQel6F1AvyrcrYF1jXHp2osiiUQWZMcy8qagfKq8Y+dPUP7C8EMfI5SombcIBatExtZFwTmXXKr4xxB/bnLRVZ3yWbZV9YRQnW9DqS2hprK8+P62RObG1MfLVHxNYNFornXcpoDhc2m5SCFmHY9FMnsbYy696ozHpxmszarrZSTr7qRNhbuRQUW2yTfGLWtWsPCPIZ17HtrmMpeuQuSvK4bIMAO55qQC0XviajGH/qP5hZ91lp/nZKuc9EecF/O0A0VqimFlgaUwor8h3wLU8MIxTTLHd4c0ayjadKtmsG3HNWsp1Dsp3rZbm2SrYBebHHQTPUVMFVKaLG1VkqZdn5DnuXr6NjNEuF7OtnVX5iJU3bRgXNW1GHLCG5ETTXqoLmHm3l/3osaN5qruNWBc29FIkiaI4g3/dpQecAxreYKUc436bj15Dpw7BFSu1FeeuRi5QfhRx5mzhYe9Ry5Bq1psiR4zE58hyAMIdJB0lpWhHegaoDHUDVMw60VC5SEwYvzdsy4Zz0uIkFpZx0c2tFmxqGXCNy1frdn9tMeuy2M+2Wej8elx2jT9JoJhVzIA/cJpqrbmd0qHU707ZLcKI3NKmOX97N3uTmu+78DNco8co16rDHMm3dNF1107Q5Nk1bFGOazm7CKwFHD3sGWQ/awNXmeQWBNM7ij2UwNWnmjCypTZC5FZKZiMHBVWo976sIYUD/7KRUcUJtDXQP5ahEBjMEdFBBlGE2GI6nQXMl85TbKQWXSVRz3FNuSh1nnkaLmgPs56ils3jGGFcRxklfDuKFzMvVHM40LNxVzR4oxXbYYuWcmg7+Mw7+rXEyKcKXpoBOzwtmpCUVgqEksCkQmxsjJNSSTQtweis1yluuNDcucNlaxTRgOjiotjEwvhVsi+FD9DKgkheP5uV0W8lL6sjL8nTyMvvIhSiPQnKyjB7MPGrJSY1mp0hOZhA3QV701ujI5mxJyEtHycsSUF+ZhBpl5VDUnLzEkpdkkrxkiOQJBLh3aO5k5CXtlucIDHJuSmBmj0tgnLwEC1BLNU1bJCxC24hLumpS0EhL8lnHN1ekR9uAsCIx0dkHWWfTbRm2a0OnIX5Gy9ioxsa+7MqjJEAxzeJPt2tLwj60QHu2weJIx9yo7+Due3WzVhMRSkH8xOZL257LxR0VH+go1pwIpVGKUHLaUSElmikD918RobTBUcxBkVUFAG1qwl6KEC7lGTKdZqu0hGFxhKXmCAuHZ7S1tFJKUDScIS9UM7Drm7ESlBmVoCw5+Gebwh8UH7WrIQpwa8SPOQcBIzwVJMimkCQVoFQjhRbNGlpUq1AhpUmjRCgZI0IdpYFKihoAX82Br0Ez2BMAfEsA3xLNuEOpjkPMJYeYsdJSlaHMGBlKFTVXHGhmx0CzqqiZKWnGXymh82UPOF2GkusWN6YOtnWzhjjzrmV6Xt3tqlQOpNvi5lxFhlIQYxvNVWQouWVVdCdcASGIEXClMHiUC740gSPNEkem9n9urP9N7v//fPQ8wazyBAqzTCA2hykZExyiYDagYKzg1B6flLuNTAZhErmMhjORzWgY4hOCUvrjxABgtoIsN+2hAtKqXECtygVMnayOC7CIaS3aNaZOxs6UybhEDTMZm2bSdSYnXSyztBJJnbyGSQdck4nn68SrjU68zbGmqVPOkKUZtzQUvpKTls4vd1bQohRrHwx8CV8q5FWPKDHBpC1zZkQa1HYCk61cmW2UqKdtVYGJrk0QmLRBMsCMpdoOY0LMr9jz1LaVy9KKO8BfJeF7vcpKRB27pgHR3C5h5Dg/ckfZ2di4LNE2zITtZpFafpQzYjut4E8PtbFkRpRhRtRpm6ruwYDDLMgstrAN5Y91RvhmmfIry5RoWXRG1ihmKrBZ1dUJ29PJ1WlMywIj5FPqlqYS2kt2adpWWZr8Crb7KDjWFtJyqWWh4UzyrmA2rFDsyHRaGSg3DFixYyXSGDxHpHVoZjcfmhUdGkCuRU38KXiBJALM4xLpJUqBuRl3vcNgWDkBkW74jkg74YKC1BFpq2lRJdLh2HRbpVSJtEI0Vx9SgFbTQWui/1OJ9DZoWWSPeuOW4k9h1gLElEgvUWsakS78EaSskGm/Qqb9Cpn2lUx3VMfipGk0AHhiGr1KrSqN9qs02ifaDGtT9VwfjxK5GrDTCA1mlLKlStkwWhQr7VDKlh6HsiFbKcPpXbUZaVMSa6UKvvWuOijVtf9nxXtLeJ5254Kgq2YY4AdH9xfdC2QFisycO7fiIW6n+uAgD7AuL3nh6tLzioCCYfZpuYwELW1oyf/a9XoXOf1/PG+KR6mAPOtZ1nvWhbUeh3x1ARXIJfQFCeF0NkPDxfZSdo/et3WmKv7a98Jpd1jxX3mPVS8A62W+iG2naJJe8CtCjr3MxEWc5SV6UziAtx81+4amcjPE/Zo6RGK/itC2DjF3ArSNeO6I3xaPQvWJc2nP+OXOPq5XpsWayOa1hFoL2qQXDvCjV8wLbz/0z0m+iJBP70OogRIMZ/WWtIcRMx5/AM8QcE704bwBZZ9Qn35eigbJZTek6R4trBpv6qTZJ/U++/MfzYXxT7kL466K8r44Xsauiz9VarHXo3QI97N1nv2c6/h3uSevuOvdbh2y6uVuNMLc7f4uz592J0FdMsrF+rNr/MbzyfqpygEeOQjQO+B/POXewh+0Gz6frwR6zvJK/n15adtrELhJIDh/KNDJcBOeOLaQ9hWhMDTuLPl7i/jC2muRR2YYvK8e9cggN/wAIHSjj1/4kwleSp7Zc3/E0/M+3MFPhIvZAAq5e7EU6EWUmuYjvod/yEwj3OF8QdGQVhy88Zw+pMS2mdrCxgXBYbQqpsa+P37Fn/zDsS994MIrOfyj/q6zzngDPfOqF7+YOYMLax/kAcN1zwY1Jtwp3f2+4UAq0X/PB7vF2W67Ff/++OIhNagCiB4MqN1l+r5TUSU01hwPFEnZ77d52jFqvp3CtxsqgC8Evs01pnuYbbtJgtmfYCDz0F6LhQflIqX0lQjtktC1v3bHEP29QstqyqLTZPqXHQLpy0G9RoalfsJhuZvBXR8ZE2pRZHr+nouHQx2S7E/RuHV0/Hkqoxq8o5RRHTUi74+AlKghtFskdfr940OSBmmWFmI9CLkCpYiNzYoo2lzInbaQ8/xjGqxaI7tbo4hz+h931UkVKjw7KjVj2mNsyddOZJ9GN8GefASvG6K/5kF/uMSGWxkmyCD5N4oWXy7eJzjzsY/1xWjaTIlf2d4hgDkcULIxNHE79w6vzMUdIbfnu/vSDQp1xH2KnAm4PkcdRuoQ45/gp/bK95j0i2Ai7uxvWf38Z85buViyDj55/SEeH4fa5IJX9cr4w3vJBa/sPeTDKAR5l/Tkgm/t23rZ/9Iljniy/0cKALXvwjIht9KrIL5EZ+9efezRx251GXc/EBDCUDyD/msDeNLR8B4OPqBBXJj9ggbfhqXnXg3L7bBPa/guxN+jYbmK+3ENfwLhYxr+FMIf1fBh1HS3hj/oGRxXFTqZFiAAeUMbp0v9IXxxlgTvlbu+rq6dZSupbPqqa2IXQb1sp7zCTSgqc/UlrqmhBD+pNK5RUrn/DVjLCTGawEcegd5F5MSG8FkgDsiJy+uIAT08m4mwLghKq9cqQw7PVKlm+qCnmcTVnJJLs0kFAFhwr/5W0JwattNSnwqwnFM4cHBBuRD3k+yNWNjymoKaGtlf3KgM0Y+/gZc9jc1uQx6lfEh5LRbEN0ucic0+ozkYAj+sC2U/05ItOb4o++SNY1n+wvP8V2LVFmsHFOglbv/8QNbu8wPlIMJnXPzaIno1Ra+ArgK/Xvfqa2EcE9Hxqyl+hRpT/I+984NdJOVXP/Ao2PwDdYSPHN/VZgJFwSvyoKUz+RUFx0pK7xnetXmQagN3Y18v2QkfhK/APGE4Ku/xioLTJB0fSVJ6q+d7fN9wilc6saJJnlpUUX+XvAvTdRIscJL7m2b6s9eVmYKqs7jArYN3mGC4dwgTpi6h8Infr+ylv+c5TvcgsxCxKSQeYQfiTdmBH+R1p2iUK088lSGIsXzhkeBGbb0P7KzjZfVZPf1UHfNiJ+C+irQ0fMZrIaHFYgzbMwgPQzlq7ZJbbjn3V3repKksQMwwrdm9ylfBYN2faxCLNYzxKcsbnu/DtqL6tMQpjeBfab3qM/oNmGBgmg9DFhXjVZd4HhuOteweV/cXavaAwHygC9l9iGi7uUGBTgqMr50UFKR/8g1shFZiSoOdFbsc/RBF9ECHsJfcGK5PNUr7J37gXdd45RQrQVRTwNcU8N7pTCADPPYUYmP2/9d7RnYddi3W5Ox3IeIZ4Ws0164ixIO4gYxQ39Ur6pikEafniSxp2bXwdCgFJCSZUGbR5ML47//X4+ycD9XmTalWTbBiN62WEDkDXmCO8rtRNJdIze/K26kkx6iuQc0yKf2uvIWkNnsuVHdX4AbUyGOgxM3P/goYIc3PtfkANj4vomlt/G7VsckDTCJ98R0Cnsf4X93P2B2Q7kx1WzMB6DQ9u/qZoIHZCxl6g29r+i3n/kgY+tiDOOvp5Gia4qsepmCtdl5O80CrwN5HUTgB5gYMIU1o2U2RYaA8w779nUwiIToL/AWeXSxuCKxyIHtAeWy8ZxReWEPTfSzrsDyXfRGppsjA6mJlX3Kx2d/L95F5+7K8BebtH+QtlsPMM5UDFkbRKUsdvgvBEAvTZb2N0savnSLfvneAL4U/hk2KoSPDeLWblcFFw6FEyPZDe64rvGvzPyo1uQPzdjDArFQmw8CBowPsFa4sfMZ9ZSx8wyjsFiKROr0pDEb9DoqOFFFpHljUr2JCI9dllkAHTQYFNCHSlTEq2y+MsemCxnBx61govVKWghZNbswuGg7SX/Zhwg3DjjsJFvsCIIfdKNeqG+WabpThT9tLlYcVOqVadiPIIQDJ/gnQkncTT/y8Ch8DwjDVgHhIp8hbL7x9D/3cF//wOd93+cXkglf19n2//PvcxUPwUiduF5phinbbrcLjb0fbugt1e1bHsLJPcQUyZ2dr6l2Siwvlp3n+6Dz1dZ762ef0U8Rpqp3w8D17ROftiYynHX0FjKf95VTjaUPP8zexEHenP2bGTb1z3+4XgbQOi+XAp8B5wdUMh6oZbpqSYbemB9mbX+Uidxk5jUZWid8jpGKveTzN4wbk2WNvNXIQlHZx/9rZxVUWcswu7i/4Xv0krUKGP2iNQiKPh4rHjcoWAeSRzqAsxIdimoqfdWdS9vMjViDdnQdpPFaGCPW6ymMueL/gvgwJVqVA5YWoF+Yo8UULX0ooAeeo34q141B9kceAKlciNSgk8EBa9gVnZVL5Ra8qLfybxyAt/NsJaWFYlRaGJyktvPqxSgu9UWlhaKWFN3rMNlaXZJArcPb3ePg9Zq3oX763pLRMQFWk7izsl4Hsn9Ff1CoW9v0xC/vkiY19H//dNtTMaPjzfZ+FityMs2DtTHbVJN0rIvBhMcWvJA7tkdC1CFIZuctE+kaIlz2oKyqArRFfUTuj6YWbUrBffsN0ClZO2F+uTtgxaecCZqAcPEB5WlkFwxDgdss0hFH2C+bWMLEOUJD9i6Whu7SETEtYQAmkRm+h51EKARbWFIFDFCDc/UOjJwk4pQhcdx3dFdwmE+rqfXjY0CAZ8ET27qxW6xn6bD1iBeYIBpm+nmUn6X8JwN/511asuNuqDIGsGTue4DsCfM2lcfgOLH7Mm4AjB2WXmkAH8Z2pIP1oEHv2soDbGO/eX0SW+CneF7GTuallV6DMgY2BogbacaCoqxSO/tvAf8ZVVSWERB3vqAcSuyXDdShF7qxke6wVwMaLiubbcXCVveI9ssmhOswfHtgvkV2OTCkd8gaoRS3nUqHH0kJo7q5TzD/Zw0ABOxevg24PRTBgmN5aRn5vu5oByVnRGkkmVERcDetDxHqME4P/wGYYWxeGamJ9/quzmwpE9MwuYhmXtdc1IuSJYGsxFhkPXnau9X/tJqZXiFcpjwJJk370eifn0XgV84A62u3qZ+IwYBOFGEt3GGGH0vmTOHSUCdvhAAyumvAbeAjL6nI8gfZbPWLOHIKAqkwhokjlgldwYMCpEVKzu9+g7T90yFfiCjubN6LSGHEMKJyI8EsNrw+lKKiOwxItRcXdiAUVftCnaBPjivf7alv9ZZrzamNxHY3xYBtt1I3GQU/TYSxN8l/OD4K0VR579bFHH7v58SHOs8s8ST95nvZQrmgbVPmfQC0GqTn80ChmWTU4YL6z0fdU9Ksi8X0fe+p13/+WwT9ebPcge/cOoWGhnVf2U6tRFNBo3X55+y68afdnfvh/PvPpeuDik1/GXOlucOhebIUirKW3A6y3B7oFMyW7vUIsezBE3+QZRSKwDlcUMR5XFXVRxAIx0xCIGT9y77gELbUELVUjBxRILpk8I+SQJ3jl61i/9uzXHtWNIg/mnhaAiRgbZdkIxk5JRiP7rHaDIjWQZmI/U8beW4m9X2IVsB/Us2xkuTGQCaEJykUjXMq13tyOQ6aUdVDNV1prtEWSN2DMjdefvdcUTc1Kzf4DAbier8oSDKWpaN/HPop/X7h4yKkfQSpWq/fcMRRK5nZnP/7JU+9Pz5l9+nCgclbkgOXU6MoeP+vZ1wQTZqDPlh18PcIRwIh0pk4bATW5/A105V0BqC6/3Y1JxXDBpGo+4/bPX3/07td+5c1fZYS+M6AZJlf4qUGSmCf42F/jzNCGncmz/t0PMvURhTMU/DVp+Gx2PWrWouEfa04P40BH5rFGz8ESXrGgTlwWkBA66/WMYqotrdsHSS2qMSmqoHmaoZTQoHcx9r4KFZrmoUqpsCMNL+aMf6pEOzOHnjyrJx75gCYZ/IlkVGeEw1VDDtwi8rXZ/gvWxPJFnRaphU1paopfEABQi+OR0tNtfNZvXdZGp+8KWKdObny3MRH0I5WJFh1gcCLsZhuViHglpnlxwDUHWM3iIifHYtyuLGaximAEORAbEyrmSmKikr828d+VPerw65F93bP3fee/5A2U3z3AhOcfeXTWHSURcUAHJ5d3BjJb5tHrefJw8OBRdhnKVja3xY+Z7AbAVTrX5jRglRQRQtq+hJ6hr2BTh/my6gya7mZ6nGK7m410d+ERdJfHxXhytH2OgO7ckKLe4/77cjDti/iHasoNJ31PNw96e2+GfIp1NuRdmoUhRP8ALotnDCTOLFDiD4BrPC3QRr7ZzGurwWCe7jfiY9zl9B2IEwvfYsWCePfeASTgtyB6o/QaWRUn9Y48FPTDl2KzOg8/xlT9diBp0vhV6t5hBBtf4lWiS1uoS13mbAZw/YltXtlVI2yumX71D78cp9p5mOKbdXSFQgg0l/LQ+TmMhrS8/uaHYmST9Iwf/IWRiPwc0yEf1zV28kKSvRq9x7pM1KQ6olF39hqd5adDNcJMXqTtzutSpH+Wra7uxAMym0cipRYoQ5tyE7mhhpezcN7HhXUkviZvSd9Sm1lgbKI+QUPDUtfL1wRrREJ1POo8lwmeaQdq3kRdMjfVKwbeSRpB5FMH3X0t+sXEkgEAyQnSVvHT3Y8NoRjUTnW6e7QADF+Qe/h5JpZKMB2BsEzjgObos6GDckCDriem6yA6wPBrrdtqboQCZ4bqOAetO3kL93im31Is1dUHMaOvqb4eknFp6GIDEvX89C2h82tx1BlId2bNSc2ad/VtQd9aavVbBvt1SgnkhVtobjCrjWDBO7CIKC7GcIqYEwpxCbrBIZLT3xjOSpqwjBqgg+fqqfVuVYM5q9y7XYSQmnDWaa/XYxLxSVWXhSR7vc7IgGvjnCpOCGCy+Q1IkHjgtlSwika9zcfvnXIkps08K6+jeARZDSJTWWEsWmx1CrObUBCKjfs3m6g3IirVT6TQ7rNUmCHiuUhPsUPpCo+VtueHpT0iFArdd/vNFgDRkQAVEWh2hp+WtlJYIwVQzQFIAYcaUGFIvlb0I6jIJWjk4TKy6yJ/VCMrjqh+1vdiix+73alcSAFkGCFO0ZJShww44TF88UP7+RJvds8NRpbQl2biVI6Tcf73028ob0HtLGIjmEJD4qooUe7nV5JXq8m6ma33D8gEwpx+gYQaAqNY8UP30qSGjzxqKBOJQcHKe431TObBW/TLrlkbO3iP1biwkAfMSuYWGtjEZT/zBh283aWLLIjEnR5hrRT7qSohmkpGDCjY6sGaFPdL5bdjAkgxKFMYz3jIzjqKpZcUkVmIAQRvs4+v1o+NVKyDABpkpGcak73TjIBXkUi6xhtpJEMJkJqURmbvwudlox5pi7Jfwecnshn87jdMatJ92Qsh3cCf0en0s1/UbY5aDteDVc48/VAVE5czKdtaiQfhcudd/tSPcckrBE+D1U6dqQBhqAG2SoKDQV6nGGllQmYTYkVEDxAawjXB8Eju42SQQ4McDpxCceanFKBGdcwtxkEwZJ+Jgiaf2dWnq7Zqn63vCu467Ksam0dq60tWylBVJ1irW61/mXNdpTZ5hDqj7E3CDtWnF1t7pMW+BMX6ZbGJLbShhcr93Yb4r0hZlJK38EiKtrrflEu+KbJHyNxhJHFb0DbNDNdxCeTWfEaNn2WUKF8HIXY+hwf7z9fGqoEesdZWBJjx3DT4I9auo1Ma8og/F6+JCzRHkjNfNP1dENu0RSxS50B8WcAFJfamZpUTJ6C0uOa0NSEHIpGRuPeBbN7gNpT4pH1dPBlKcQm1kazDriuAwNEDECN7/z8FiFNRUXcj0TAjEWBUZCQayNbQbBQJY6UtROtDnpB5LPDS7vavEH9F0Ehp4aGK+dhFoJsDmcgIFG3djSfY5gT8MKldTW1JqhYeaJmOlJFPSXnapLyIOwGievrmupdMcQWrJ93ZZkcHAIHFqlixCjKHEjKxQkYdawlkYkAmVhGD4Lw6JbRTft/e9exvKt5fn7TX8eklI15gMRL/pKjiAPi/Pz0ExkOXumfrUrdP3/bq2x7bzMg1k4tYVbIZcgBH0vcdftUhFddBcVUWwOzHDKvwkdqa5MtuRoSunqTLY2xYR0Rdwtyj2kEJ5Xs0NRQhobyQvOzUl50kzEemHAMwVRZq42twN1e3x9T549KIhPmEIrLAQ4Ic08Ic408gQ/aTMtEbEouVf8Qnrboa5djsZ0Sk2ZTjXuseV099ilSQlEL1mVPmoKaqrYsJ+lCF+qG0z5xM8Re3OGY0E+apxAT0eaMc0fXsF8wI64jrms8F3CFV6txzpWCxsBZ/lOAZ0T3LSuXMrh9wMkZrjXFfjqblwCbigVBHvkBFzek/p+2pMYRYPsgTk42Syrd+S3ETGXHTwJMXDqUQjuleQ0HCD+XzARqGrsaovX7EhCbmKyaPAmxVx/RWRSxBLRd7m8Y616lUSzc8URzBH/ozepGiutgqMQ2sqyQIUepG3q0aA0Elq/WyL551cSyhB/ve9/OdQAG2cH4WLs9HrBAkzGbMZ5b+RRyD0gNbSWxuwxgDA3zw7l3X321EymH/fgimABKZk6FiJA6AfhO91usTwDB1LZe+O4obvPAGRnnfutQIrTMfoJduJ2EuNBR9a73UTJHzAo11DDezqJnPtPxUN0HmYnKK1aIjq0NGmRFHZEK3EDdLWXXDn8kFvgwb/nXYB+p3rsnnBYANwGq+33mWqcZLRVBCIc25zbvW21F4ui18izy3ca9jlGbwgJCyDjAl1ul0U8iM5imqMehTyrSRfGoIOLI3y55IwjRvltRA1lOLPk1FHxjXNDhx9dNLlRryzq7N9eBWnzrwZtwktkG3+4V5lxawPM3qAXUT6zKkfro+3QoQDlSiuIWPoTpGdsB64ZkpmVgUszQcMlSJc9zTcTo8NK/rGS2DYStWTMoCC9pXuNSSWAxMcO/z2Xc7q32/6qWXvuDDp1z0NDhynwUhmYelxHm5bsdo0MUgd4GMer2cPIFRa2RYFs2YLGS3yxjMmSH/24uHoCSMx3o1jVkYGHLMExELiETAyQwOh+WxUfqrj+ge1FH/hRMXoSQydDehsJkXPROPPA5fjYi1E9yN+tit74zN1SgwXO5q1Ec5geM+99FbA3cx6qde7y5GPZJK3VUpELq3oBSQcjwnLzRBJKEqN2OXmgbIX0ufDQUCT9xu6XodanWehPvSOeN7sdTl1F2NVdny7YjU0nd4gdKNff/5+z71qe5fvuT/zZFt9Fx/35cf/vjL/urUr1wMealyvszZohLZ0ICNAoOtu7Iam/aFWTPeSSrplJvHHO2ji/UOpBLqRRuzxC+ZMd1yRILZCTgx6BAPXJC857elyS+uKguNntTrFW3wJ3mIGF70wab45HEI9xYwtIXf3038d1lPGQIzLEKk9c7eEZUyOOWfF4kOhdp5eDRwCshsbQuhmNJTDiVD1eyTnrrgI9Q1+qHpPjEnt/o7X8gTCB7K/uKLe57b9oAiZqKRpCqO/7PguJf9C57kZQ8Jlo6h4sOKijfAf2EwecZulWync8RYGiFq0rPHRB0RhnoArFxXbBBbudGw9DZaV+PXcm1aRrlh9nh6UILMTTlOIymNGpCVduByD/sv/jkLFSXsUYxXNZHF6f5d634DXlSk01KHYqFOFEV05VmlSnwLtJFQV7m7VDxeZ7rV2QVJJEKI62roXLAvdalKWVWt6qyihapSuwy03TIwZc3xseYM8xlSmSXK3ctNat8hBpRUN1B2qrficG1ADbx3htSUtWZmdDHAUqA8ibXB2MJUVZf2Cah5Uh0GrG4T5/+19LOe19xMx2xhVMdsZ+l4GDjIZVlEUo2YWPkv1TfIEyVeDad/hu/FB3ETR6SigvZbXA7P1L/44saqU0ATFM7Bf0X4sCEuCOJS9gr5rOqSKZI7Z8SK69OdEV+kelsABRrBByFG8PNixB3tsFqBqHqFMo0wtbDpgjGlR/2xGnpLb3yclQnVAzfoXVWV8KuvP74q4Y/4AS6GxtOkYe526RoXzrdU6NDP6rZCYIuU8GeLWKXtdRGGWrG1ji2qRa64v/OAOCUVWXaUfc1Isrkg/mL2uF/cLF8cfIN+oRF5YzRjHsvXeVMLnNMCm2LYscFfX2+/dlGvQlTJwutahknwCKn05rppbz2RbtpzuKJRpXp7tRr0eQgQmXUe8RB0SqJf4Xl8smxB+nd+db1wFFvP7bHxdVvUWikaHt3Dg/WNsD2EojSEG7HeQLD4MJouqQDZI6wEZLmzZj74WXwgAk1whdmd+gpKHRPcPutGDbM8AYO2QPyT7SeYCdGjEs1s1hKeV2rQE9kkLpYxwSMsQt3AKwXAdzhpl4t60CvRjasc2yI7h/hJKvyFR3fuMShkSTje8PWZvt4z3Cz2yln8024WewLvsVl8+HFvTAbRF4es+RPI2qp05edOQFeu4W1APxMJk1f4EMh6qBsLDdBCuPL+E/m1vzv3+gFOrFSo/lzVEVQ3m7zj4BAyc4oxa8HLfO7xIziQh+DrNdpPfzYIE6MhOOWWkG66AblNGRhICHULDoF4gDdWcDLHAr5IEJ9xI5e2W0piIKB+3nrmnhH1+PIJRcKxxFyR9Ci+2p62ZP9LZ5HRj35RgUTsslIjg++LkUY7bYyKYWLP0xWYVNeP80jRX23LXAea6G2IGY+A3/1L1Tkzjp6E70otWDeMwsAW3l4214tW9uY3cqPevQdzQ7v88zq01Mp+dGoSgM7IKbUWMZpv3a9Gho/gxDo6VKdE509F3nqis5dfQBXu7OVxpcm/8foT0OQ/CiBtejm4Xye+WyumWfmti4msmPBULyjQsQ91AMG9PtTB74OdIlGJlEgmRfsp4jM4SE1EBqSySKIIzEEMK0747MZM75CJo6W2MTwOLSp+dKgpEqyYEyHCs2cCHfykFKuVlkwZwUht/c/gx0apx5YYIxRbAzSpaDOUhmgaiFSNc8O/FRG/1dE+lU9GcpLVsTxC3taxdEK2WcHPDihKCi3ffDZVfZs5aoNtzTPsztYK2S4YHdNZOMDb92T59/d8f2ao7c3gjCeTTpgY8UHEjbAxsdjkpVTV+QKMRmBGI709qpeKw/wMrwW4unlim1408NrUvZVlR/CGgbi3U6R43tcpKkYCj14ktirLG43i9G5m399+/ugFO37nwr37fm3jjfEDS3ts4HxznNTph8/qEbOFz+oNeDRTjECqlllppiyscr0rb4vc8WCHkjKy3D6gsVmvYO6fQdmQXE3CG9yO2PZ/xLT/7pH2H3761PYv/uK3/vkPLdDefd/zIx/+h13fs2gDs4+i/Wgh2r9Zu/n7Rv8wy0XUxT2XXKQ9yKIEcVKRtLBCk5dn3FAEjwZ5lqKfBDuOeMxD+wf7bYgUM5EruhMTilRj2+IjtA7Llyt7E/cj7nr6sExWGeCA91IDroL387EwK3+tYkrgHLXxzIacBYEulz5Dc0xQS+HdgOYpWWdBHc0KvnFGjBIC+174G1/95Zd/iXVq+U7bf38011M+/3p3PcWJl9z9FLyNXVB5IXMIug2pquQL8EWosp/FXS/UD4PsCyjfsAwoomrXx9fVnmP1krPcm0z0EeKBVj25vA4TZn+DwqbegdGbZptdg/ms7wXTb2aL3PzvpvKaEcqPRhjayDG00SRD69IlFQTjkVQBgBt2NnugZGYB3uyL+qq003fMLHav2B0ytXeMbKQZg5KRBbujYpAQcaqQgofwc6LeP8HIYrP7IJpFgR6HILse4vqjjGzlAnqfh2r0vtG63b0rvnjZWwXdZHx1B42H1epIHs39pbtO/gZbMHKDzd/kBps/foMNNm0eHL3B9rbXV2+wGYY7VoY7Ass97Robn7jE+0UuHAtNwhll5RpbeLxrbDH55qqaTBW9zZboI9QHMOntrz/eNbZf1NH4Rc8P7SGY4pRiWiynV+p0IsCD26G2PSJlqtVysnAIje9DDwCz5FINtaiuGya5OJ69Q+e9VoDvdKxDeUWbWX4GCISlSLqTyksRWsva9n74JTj+2qPDzWP30D+Y469IOXEs6tJQtEI7kL0TtQt9iRyqpXvNPhn73uyXVYxJKKq8lSrwVs7ekjvBI2lhkr7/5HGtW0qyfuETP/+J2hRcQx6VVjl0+3nkZfzhxxkO294zgm1uH0Wx7q4E5bqboVz/BS+EesfXF/F+7biI916kPv5yKvVMANMP1f3k+0+wn/zDU5rgzFeu8/nWUPDymeuCl0fXle7YjzmnMdIb69Dl9l92pqSm8PAR7tdIlhoh/NA7XPgLzlqUlKJcZR73FSWMvAuI24XmH4zLQ1zN1hRfys5CoHBDTT6VaDKVhxFS1WO7Jp+hBDma1CD+441ACxnAubX2a+bMZZ6lBAx4i1IkpCpHnbO3vUXHSO+mSGPRglbpRWIWSJPhp6lHr31+hdzIHuC1y7QUaW2kqSIES+5FyedG9NsW2T8sb3Pcd/zUMBGyD+gC6WKNA5h+nZsrX6jKO9xCy7kN5Nkw/C2qS9Id9S3PIJqFPvGBoikMygI3WC60l97KbWk4mW7Kt2GRIavWKS5S2gewneJYHg8GG6qCiBxbWOt4xp6OtrBxUpG4Ovus9gF9s3oXDZl8csNkwfhgXJRDJGDDkviY8cRyboYxghY9rhrAjU1C2X7ErXCGHlwzBXt1wORzwnhNx8kQZrnxRKMJ46F+MA2gi5o2c6v60tuK1ubbHLS3lwY/M9pKqYIaH0DXXUkapqexTc2YmuEAiR/AYpZiA8DIkeF0rS15Zgh22HuqCb5MLcnWInhIhSuc7ZRahVbexK2iZHVSlFATP20dS7jPMJtacWiekzxrea4Km+JWwln9dS5qIsrHLKdifkmeiKiahEGxVsGNM9IZFM0dYCCiVbrBFaU2Z6Z0m7vSkUGbgXFGDelu4ZC7N5Fz1lUW6nNndcqhwOLdD8+Lg7Om9qLFwz0TqI6UkAfyD1C2hr29ggbNgyHsaYOvvSro4c96ROy+hyJaMrZjixyROUdyb+GN3MbvRPxOzbxgI09B5CmSWaHDYzOrAwTMg+s14nRO+ZwmIiYnlKUxBFhgwGfV07146FALuZqz/JbIlma/BVPJ4JgRO/cy92PMc3ENq3GJuq7VuGWIr5at70AVPSgNORWWxLw1gPU0QFdCu1zk6WXkGS7yzDLyLBGW5Wdza87h6p7Ao/IEHrtdStwN513HlNqNR1I8Uaxz5Ety0gCy9CQcSgodzLeiT3C9CDvk+RJxDInbrydLMU1jredskPctrDFEWyCinJduPimPdfLTaQyXXcasc4yRmAGGC/ICYOGae1XhUEtwCpx4SZhhcx5V9WjlABMl9S+F8CJHza8htI0/CF6M0HYO+RJa5pAnIdwG64pN9i5tF8zM2/KyrC+ZvMzpS0deFvUlpa38sk1ffHlZ0JdVAY/SNx91AsWLlszviFa1q3ghSvEyS3ilIqeWPAWfgEyzRBRZlO0QCqGcIkau4hQxdkwFbIATTc4fQd/iXPw8RbIOvOI8zmuLbtFTSL49hST6s1pJZirRz3eq18DiFKlEK94hcXdxsSOl7SDJtJMQbUtr6/zKpRPWfWiRa2nnIo4k7ihXVSmtxqmSKaKdrjRBKyYpoRJHwopFXUyUrnFBq1dUY+tzeYuzJQ+sfDJ7epjxvZqfKmKezyp+dD4Qcw8/eJG8gIu9kPFzu8HP07mSMwx+bn+M+HmhYt2FJX7OcdQewc8ehy6Q0BYOnS+h+RJnkxJnGyXOPpWbt01wdhslFjPx0rCYiZen6ouPF4vAq7SVX3r60pWXLfoSy8u8vizgxc6AxQo2xxPYvFjF5i5e7Dq2gJe2vOxUpM8Mnp9i8HwHMOBcQh5iLJ2V53mIvMiiQmZmQPE0Rq0cgafb+eArqp5CO2Q+IB0BybSznB0OcSM6j57Cgcm5IoiIn+PPlJ0jMyXV6s+li6ozRTI+jZ4uk2/aTMEXOyZnSkdnyimmD2am7NRJQNp8M1NoZKboFKGc6AQzZRsmxTY7U7ZjpmynCxHJSIeZEqSYGAE7yMYD3hXmMStwq28Lz4oFMyvO5ALPMrNi4ZHPiqw6K7YopcbqoLOC0ZExWmn1FqHfSqt9Cc1hBuicMTL/JYotamd4sajdkZdtjlDHlrj78rLspkNs6Xm3gufdCTz3q3i+WsXzVPDckm6aNSg+U0FxO1y4HJuTotoYWVd8PQ/JgqOfeud/ubj6h2EHYuykcwWBL67+FRdxoqChVidY8xSysVPMMJhpY7FG0f8Ui/47RhD2PCXtwNuxhaJWTjpF/ykIe9ejRthYdPwtwi4AixZoCyIZM4S0A2HBfW83PvDpSSCLFrm2MSKGeY6nkKBFIM4q/MobEswrOWMFQnFJWuEG1hfE8u1q3paXrsWyrfwSWyzDy6rBsgr6dCbQJ62iTyboM0kMJxd9t4JaIqakQ0dvFLIcHZ0cZNXdqIXsNuwCt1l/+9s18kl0Nj35RQX/4FbeK9fUM8KT6MkA0ooUtZTXaDd2F7vpifjIMJipiMjo1DV6gi4sutq2+UrvAYZYW/bD1OY0OHwSXqlr9M/b0/x4qPR2yWylMqhzT2YqLpYTyoxaqLOoGUBjP180zTzlqaZDQDnuP/qYwXhhrKeaDgEhL1muSSY4T8kZeQqZfxr/WC8bO5SDYcaHdNppGvxNk1mqeOpchMB5mgQ/Gk+hp+kOba8WoS/EL5xbXzItQQYYY80BuhjF5FrM1ZqumXeP76N10yQ4IBTYvetmCY5Qo+pm2rmDaRsuSvwjuz1oYDfgHGpWPJhWLmmqR0Hjv7Sr+5pQ9jVd7GswN55A59g90DkSBwmC8YTxKC2T/dLrH6Efg92Vo5i78PHXwXlBv2ImMBGTUkKS/P612PmP2uQjH6KXirFAH0LaF9gScAKChwiVEQ4R5q1xKc60iotkzkFCpIj5UNirVktb6DtKQdKIMDj9VsilM3stg/yKMwqtCQVISIWb1n5dQEFFDztM/yjy2hWxqDud8g30BVN4vHkNvuIaIyc1dz6gBVjeUcZNLGlh9qBqyerlra5eFMn0raVvoZFaGwGhLgFGfZaSiXtGuWfPudyNIzXyLRo0mdjDUY1mZ29+YILn7OVbZ4WPtaZhLv74fHcwb8KRF8hZAt2XFtX5KggioADAO37VWMXe2VccdmavuLkQp3l6vqsKHynEjhxLnf51PwCLtzB6PHJ3C9gfMsmFOOjFpiEealAPJXpEREH2tlcjBeI6iVfngqLeByEddqWqJuHZM9raURtgIso1wyCNvTpsPYk1jFRCcNXauAgAE6T5IsHNUGUk92rQyBaP75poSvgKh6CsW8tPtPyDPnLg6K7IUDrERtThdsgS0SFf+AEU21KpkVbuc8C/tAd8hRmvvG5UepEKabHRkgLI3M0qe1ErlItammgj++RUcxb5xx3VsCcKmd1bp8X29wjFUPoyxU45DkXFZvavguZUVW6/c1OzoKvOKuhXnFXQrGLzc8GZ/Bw15NmqkTbpURPW900Q1m71SL07caK+d5rJx4I/u5rJ6dqjtvuoR09VQouWGEL7cyd/luWPnJuGm5ybeuPnpjDN8NDouemDN1RPsvT8Rk6vwn8ju59fueF451Z/iVTWbA4eyU2k1pSLSK2Re0gQ+r5ELwS1rua3E91B+iQfC3pTLyF9AikU6rmhu4Z0tHoNafM6T95bU/8lL4RY/vH32fShqVecUFf2wddP3nD6sB4kPm/SlrDfB5lUXqFkFKBpqCNdnetgGPLAfEFB1dDwo5ruvz4x3VuV6Y6X4/BRH3n0fJTixej0btnp/b1VYx6PBURFaIAkPghyv+Sz+tVBeIScmkL7Z30/GLHAGUxa4g820bENMrXg42cfVQhaVk5taEhrIHH/uFwDwnwJ9W6ks3Ll89s6r9SJ2i4gu2aTJ0urlh9kH0P5pEnZ7+FF9eEWxmxB14yPJXOPs3IlqIAt3E5pNBcvRayGDOu4eALnnl0xxcLtj6yfu92ji6m79usW04lYgNGgzVOmL6aykoqyFdbG3xlfUTfXeP2rE2i8Yt10tX9HeZ8lKayaz8a+H33mj9yTX5+U5gju/SB5GASna4fhACTLmOzjoMEMufQvTnQv4di/xr2EY4/0XsIfjN5L+MOJewkHM+xAp95BOFp7lHcQPjftDgKqwm7zG+Yuwu9vfhfh306164++QVW7Pn5cDZtP6ML4TrVx4G2u3nVmcGL1rqOdUr+rJnr3atqljjir33XP46ffhetL/aMZlp87jI7XjV8Z0/HixBElLw5lf3JiJa8/fhRKXo+KB/jkY5GlfOqbspTHS5by075fubZD0+y9aUngBiYWmS7VJCH7M1VThejlaAe9gPMmtZ14t7xjkmSfwle4jQQ+5R6Or3iQZbdpxzoVA+Z9EjmjV6qADAwj8pWLhxWbyZHelMkDWwnUgxEzNLVFksC1oesDitbdx4MLEO25xTT33HXE6u7cV4ZCJ1mFocinxZqZqbrVjN4ZMlXjvlemEdstV/dpzhUFJuCfK9C68vIZfSESg5dwUCU0Da8eXu+zrwdDvH7WvKY/4wXq8MfB0+97zgyLWikUWc4EUF+wd90C8HMoTwAYbEzLp6AvYuOEhlXqIXepgDM0V4n6H5JZgpEYuM/vSJ/AfS7bpONVidD6K6xO+rBnLNEHcqHEbJwqndSLMJboSO0jveZ0rKboj0YdZs2iSFs5EhdXP3JyPkxdb4o11w/CveSRojHI/lJg1qSQQPptBKxyQekQRheozr62AJs6o5qTISktsyIk2bqyqRv1s6LASw/7sS5Wm1y168s00K0AppjS637U5/KyT4gkIbwguLy8RQzd+CmW86rm8uqVeLWiiMMVsShGgcrmGfPEPA80/bBw6v00OGqwgFL+VUMMqFthJp/qlWtmFFfurcS6IMQDbirgMOqtZvQ+25seHUSSflKFyEH/MYIkAEgiAUl9c5DUHztI0NYTweQn/cjB5GQhkvazEYikjxIioYFICIjUAREVURuIwLChBUjYb24KkBgACUcBElbuZmEzyI2EJRBh9wGY9ESA+eo0qniU4VGSGGm+D1i7m5rgBo9k9xvuLdLQYAqlw8IRyERF4xJjMGyjCId4z9aLUd9btoqG7ThdjsqqHsdAV9cl6kgRDSubvjs4fog1eegKGS+uxsWtDzC4SljX08s9r9p1f29l9SVvoM1dLzjM9XkTfmh0zde+QKrhi3o6nB56pqe+I4xD8QYvgECICwzLAmGl27Wrk1ZgUu0jv3Ervkv+feJicsErxU+8gerwcRCr3OX5PqMF1eTOqI8n3yD1ZZMkdmLxxwrlXAWMuGKgfZiFVDvuYpwMY1E1JhqjRaxIxd/7l7XN0YZXSYdyk7u2J9Z+PFMQozNjP7/LN6KNgmKeoxd8KeaF8xTlZWFrqcLK6l20cluAAVfIqHsZOzkpzP7WWv31xYoanmAiARVlDIxfMU9SPE1xLskcfwx2/kQuyZQz/pzvea/UzSWd5xNCfFSc4fxZw2qtG2Gx9rJLQzthr1BCZ8HAjYR2w0qh0LBd+tipj7PwQJqnux/8GsvecAlz0M8D3Vjf5IOpPt8/yE98ccjXgg9zSw9rmPPAzZmEOR15UDrS8USaPhF/un+zlD11D/RWrYyzaOW38xOfvM0/n/8kzHE2fhfnP4//NHwnh+/0Qaglr6/fa8Vv1SfSPXC4Gz7slKe3w0es28uGupeNMFaB2T3rjaVQWSUKZCxxK05MPEoyxQhFJIL/7EvVrWtQbl0DvOrmBVtX/q+6dQ2MbdIpV5MOzrqta9gffGXMOp8OHlqBBmdfLnet4Wa71r9/FLvW//NOvX1xMjvdpRbaMCow/IWfx7+/to7G7r8Y0ppLcdCaoejNdnNBZTcnlp48Ne+5wp9/Wl7/SE+AZA93KCN/qrD5wQ5gC16xpkLzG2GzgZ8PsmU/8NAjBppBPtwq4FPdLb9M7orErGAQdapECUY7teeU6DYBaWE1rV5ZnesVKzMUTOzrBhP7ummxirZmD/fE45y8An+zB8cFxW/1PG/62StgU+VbNBaQmhL7hamx91Ziv1LGHnOxah1UYj8ymde1MquR6+ijPs+94Q3jwp2d1QOenRMHPPtPeEP6e14onwXZjW94jPejq4KkV7/hUQiSfu7fQso6eMOklFUnw7/RQfCRNxxPvDpUW+8/fNEMnI3N8V6kJdcHo5en/O7xFUK/3K8VUR5DYNkSx0h1LUMvER47/iVCOOk6ai4RInxXJTzQMM4lpJQUHjRYe51enDdcsOmCyHAsgeqw2MrK2/w09l0BmG4+gwep3Y2z8gzZojVkwXkw3kL7hjZkWFGLWersFwSgWXNBcW5/MU/zGGrZIeULFNk7h4s0ixwRdYj/WL1lHhmWYP9zv2Zedpm7NIsLivM0h4QtlIF5zVesEey+9J/9LdE8LKYJfnaBC8v4mcOoLa31+dXcS1xE9EKZtgVpC0jjolpAYL2XuIFSbZEEF0Z2A3cXb8t6XFAHZdT7gwarOwMo/Nxqgcx6n9y+JZqhcK3YjjuJ1PfyHPqv6ERBKxxggytb1vIdNEtL+xG7kz85JdirHdOSKOKOTceHMKM5wtMZhhE+1OqzmMv+p8rFfjpVLvCdBvUp4YWW6FRzQTISd1F6a0/MyhPJdmKelnBljx/2yl6X5pC8BA3cBcmziEs7emVvkXKal2zzHIYZ12WZefjJaPsBDAK2yaeIBmRX5jHKS0iKglBBjNEvQEmcBYVZvkuetfx0BYWYo5nDiFPEPDRqnFt7uCn2kk9/+Eveww94BhjZGhBP8iS0q5qkRmnmwCfO9QnQov8/e9cR3jYSnWPHlCkvl7IIgAQpljegKJJik3uR1xa9fVOPuR9lp/nLJV3pOfqYo27pvfd6S0/2lt577z3zv3mDGZiQRcvbrS3CvCEwIGb+f8r78TgR8iKKmQkxhcBwSLU3/ajNvovcq+pHbUAb2cY40M1G7m2/RD2J3DOgVCFt/0+oRmhSeYqKxkGgn4JRTHV+AjWG+bUXrTmhENBM9nmXAeo9SqL5CpwLSQ0xOSOq4OGSATWpYDanYHuonxNPCw8rzmqTfDCllk3O/ucf5Jw9Q2uKUC5gZkqlSR7caKCv03/+7QwVaYr0VKf1/bSJImlmPhoiPeSP8F9SdLVv+g0A2jZgkcbuY9QtcMRPvrlPNZw3oinN0qfaI+QMcBPJgZChChTojpPBExBClyO0a29eelt/1ENAbo8KyFJwQyqqolGrNjjzHPqWHdrwJlHbXDMCOPO1ucnOa8AlEcbubfejQNH8IuzA2gF8PgEVcADUCFAzPxIEBJznmMGeAQOSiSQBv006ry7NzyAgUF3RN7xiwDQwXbwqACW/vaaumhhS/t2gazjq3w26zssYdQOo1Dl/vaZu4h0H7sXULV1mRSJGb6kb+rxbdA0j4G0uqSJRhVfRJxOiCsvojiJ9WP0ipegWlYkezg/0K4eqpb9aXxfSphtqi26qZtpfJaTB1CQgCSDmJu8hD3STHGFnYb5jN38yb5eWqK1qHPC4peq6xK9QmoKqQlUVUB2lm+2ruDsYUCVNY7CuIJUMKeDjFGgBAYwuCODaDIo0eSQXEE5mvHXWrxWTkUYTDRdxz6hPxvgzMeeeT3YFsoZkE+JrZ8TZ/yDZ/p24iAFf/fvFZMZ3MrcfmczzySRT5Ij4pAFNjipyysziq/++mAxMkWNkDk3m+WSaKXJIOAlXekVWgL4KBTgEaBfgNYQLJpzD14KQWUQz16jKxyrV+Vi3L7WXJcqBIkQ5tHBo0RapfQ2M5nwHo2IfZ/aJsvGCt128IENuHfGCjLU7jLX1h4mmjx4PCKaGYhLqvH1GYsHAEOHnaxqGXQ3DhoZhPwvD/slguEWk6qQ0HDuqSV3VooZqA454eFWhkgqoqSIN1JjauFsGirEH0ShNDz3oTqlgxrRkJrAdodXGgt0JRXzcReYrWSAPqIjcuzSlIRL3HKzD/aRmzwGuijShXSQAfQvcIoALoI4Y+YLBRcgzivBnagE/8qBUoykjXXBvoVRz3+Eu3dO5cvXvC7XG9AoTKQ/wNRobDk1pkl+kcCgL+BmPAvmAry0D+AiHiGIcYgv/KuBfFfg7uONYoiYfm9TiY4vafGzTFkC+ZelAFAK4CgdFHRw61MWhSw26s6/h2gc5+rSG69Zo3YYIXkWI4B4Ob6MLBtCVohs6VcQArTpIgw2Esm4R0Z5mQgOk4NSaRvBcc2Jdc+LOyTlBT3JiXVU1H+qaCyXNiSatqRbdEV7UqKoKOdwIMVgfwY3A40ZIBdNtUyC8iD1e2AYNBQdDMpCWfMOyFN8AN2P62z79c/78S37or+7ZI3pddLdFO7fBbM0eNdEYIknRFM1IHJPNneaMCkMGJKHUlGZDSxfOtd+Pdmlo6DLzgSiPMxJYG6bwidPMeJGFdQVTnwVYC3Sfim4J8asB3TVBt3TqJ0T5OhF+lqJDCrhswGpQF1aX1mCt0R1YdzTYCWCf4/I57dnwwqtYKXQ1xBjeSnnYbjG2uw/NGqqjEb2lEd03kw0BJjU1bItqiCM6Vp5DbCG8WtU0/KrUN/MIPLwqeHOJyJ9LYP7gd9oCxpmAceTjTLpgvwWHaXcqTSf9b6bNpiRjfnHZNkMrxdJKIdd+uORQvEWEwbdFilsOVpv6sPrUROlN6uCCDnXNBTfpKt3+vET/scGIWJzdpNtUfqjKPP29oQp0DcGI1+g6LrJzUPZ7F5X58ThMk49YpX4P1F4kDm3isU0crPD4r/qYxdEV2nn0UEPANHuTZwpXITiT8VK33jD9kW7AG7TFJ1bNlzFCPbrLOhWApjKxD6EkS65YX4Z2r5q1TkX3crb1qazXitL8BarruY829tRQGyXNFTam8FchBWDwcWRGs5qM2iEfecjFOIeH1qwGONAzzOyQjavw+PgMYxqGcwzVSEzMZwf4bExm7NfDmi0F1q/B0hcY62dg2ZHxyNE84akiTkIDpDeG9fv8S+kregzghz6ne2Nu79h4VcxaBR8G+DARRwOWKYxXzhxw5tRbHE6ZAlREGstA/Z8aGpK51ZDERoY0xPW2k4o05FVBH86CBbxgw6xyC24D4xqope15RlWNh+S8Jo5xGvASO2YHQcBDG0KhLFVVBcBIRzd9SxRDAfqmQNb8EmO5STXjoUCxuMWKWfzFqf8h0LVCBSleHk18CscW73w758W3Y4AYEVIX+eX1iIroJMy980/6bDlpjyIjpwSmkrKeIKpiXaw9BKrGzqiXVGzqVfpyS6wHSZM7GwTt43K9xe9LzLJmPstKGZbVwS7bMsuwrOSzrP7Cscwi6SPFsqawjDBeNB9Qi+05GR5UpXk1klU9Q7yaEC9ckniyc7QwowYc1lLiVZl4IYr1iBcuT7z84k9OvCA9KVggni0g9gqIpYDAfuZdF8t1sSNsUuEWocoic+uWuVX+kZBVOM+ZonikpvCWyfoZqWuyYD7rIzAggFdrq/RC8fiUx6AuY0PYe8yweTpsVpYZNi+oOEO+Pp9UYYZxbavWS9Qy4ucZsFBvxNpEr5pOZlv6jjyXMfPrksgcJQrRCxR4Ik+FB5hxcwuVpSuMqE5V7bTG66ewa/DjUl082DY3ltqJIAY8AmeDfYq1wX59U+Fn94zkFaGNaxSYbDwGnlX7rMXZHfDzS5uKFtKEYR6wNS+ycWkea3DIfStCDdxw/gVfyKIFvtmjFEpkkIQakgIumyouqiu6kMv0srpkqviccTxDhdTKma5iK7rt/Myhuu9epNg2rnm+PwtdMV+D+qBz+Cv3hqAJLQuHTZYz8YfMW0R0n7YPXdBfwEF/VDC7FKoN81oSReA1bXibGmz7WoGFsGBnRV4v+Ovd5fXggwuLevDXfv+xevA/exrwH3vpd50ezKVAdziA2GD0YElecMn0hE+MJPzu+yIJ//WykvDvF40kjF63hcp5zyThg1NJ2ErCBx83SfjdPEn44AWXhE8l4QMnCUsnnJikJu9TJOF3TyoJ//XHRBIWV+7RknAlV1MoYsQQSbhyQkn48TNIwo+fSxI+zJOED59LEv6ePEn4ez5QSVi0YFGGTyXhj6Qk/PiEkvDj55KED/Mk4cPnkoS/J08S/p4XXBI+lYQffzQk4ccnlYQP8yThwxdMEj6VhE8l4ZX3WBLGkitymxN8QJIw3NP5Tm44q/Od3NZ17Zzc3+NKQbVlnNwHz+7k/n13YzRHjiR88JXWt4hFy9ee2TcrFpgBACfubnWGI8AryCJtfoqYX8sO8Mdy3sA7T38wkPOW8onDneH7wbHoAjWMHxwMUXFGNV7xVOMD5/6G9RT3t/zwoPVZAuWameKePod7gJp53u+zS3i/pXTrdEDplWNLt+7dtObTbb4icyuXRU4P5sc3Azg6tA9WD44tzSzFlteRPiYUO6VYUyjmJGPYgK+VjA+cZAxrUTJehnUheBGCF7mK8dl8xXhZ1uWWns+6pJLDO8BYmBeTOyEmL98x0hd8HTXfP8H3lKinRHWasNDzxR0UK8sMiidXe1cW1d6zT6i9K0epvWezai/sHLX37KLaezZVe8+ibK7LRbWXs983tfdU7f1PE/1b1P+/pH+uq6RVXv0zi1+6po8r+v+s2ru6qPb+yPFq77d8v1N4v8lLf6NJQ+1FKVZSsGqvJC+4pJzwbGpvzpdaR0eOXy5C4vdt4tds4mds4nts4tAmHtvEwblUK66kWnFFtGIt+4YUila8Apyk8m+VKlmtGMyCuEjhA3Ny7E6uG/KGFOCDhmjFG6lWzBUIeTBMtzWtgzwsGAeQnmrQg2PRiqtMrPSzBj6LFrXiQ5Rqi5x/B1vQYFmBdduashqsmkZMVi1dfnqS+SWTJijSMAXo+/GgbbZsUTVmQ9UqtiUVsrAq/UjpIToGFm9rT+5yakvDfj987bkkJoi+5p4hNSh6iB5X5/IupyHfKrC7nGIEUAWra4X4paEQsxLpqvxnSHc5pZbw6ED/zFfb08r1uNORd5LIQBO8U/o50QEm+s41NFyXNvgVo6QBUaxCtQfI7elTtvSpzrHphmSG2EXC8ThFfGAU8QEr4kNX29upOF6jgS+OB7443pRdTiESQx/XB9HHUcHcAuidIz6nitYx+niVEgr5tFCnQ62Px7RNZbvLaXef+igZLgyI4gH+ROkup1V5q73Ou5yO+AjZGBVghMrAU8arFJhtTqGwYsMap4yDZiK+jjIfETcyxuNAxuOqPt25muzORnFGGR86ZbyG/SOhjLegQW5mlHEMo30jZgoF4SnGNqcTfHV5jFDmJ0xaTTYuzCjjYk0pksoKjO6d1GliHigZUceK3GNvF1KcoFL1m8gmd9y+pADkORSJ9xqoz+Nswb1DMNXfM1cTH+ki9J+/YhEc6RnvjgoTpdOO+WiM9DjdODUp2nrP18RRLe4MVCzgw8/d26cQIEkK8CjTjrdhKnJGNM5umBrY+Q66kZJdZWzZAboPd5rJSyCNJ7Imykjjl6jtjYktritBnEjjIYiIvqUKabzFc7wfhxYOBCEjtBmyAnNdCgFtThxf4YHqshuzrrjcqy73msu97nJvSBJo3aLzWv8+Y/ai1F/vthXSGXyqYMYhtWuF9F9YS+7gqH+Q/RUjpCsR0n9tTd2FkH7IFw5Qqfr/ni5zoJQ+b0B30Hfc45ICEdJ3MWBtQEjf0OMbCzObdFeVZLZ9WQV0hastpBIav5pu9ocW8/b+s3NhHEL7eqbdEbOHW21SD7v8bTJmkSadtbaP1BDTtkdINTFj5NQ25mqcSvRX6eqvoKjrVvcwto0Rs5EYo8YGGaNBA20MjVFmo2OMPqpHuuYyFYRHIfdVRSNAVdkYUYOYvDApGVPIx5ndha1OIyoaA3IeCqExFTW6kx0rtEw00Gm0SEymYrKHP3Nz7kpy39vhLaQ58bU7dN/b4S2Wu5jLZ1aA2eG7mFtPTOZKMs8UNyE+aUZzr7jIkBpfGpS3MuXYFLeHzJHJXElmXnEFsFjb6FK84oAspdkjxMMATF2QtUs9Q9YS5u0l2kTmJm1kFfd7TnFnbL4Kxf1VYPM1fdBj/uu62Dc0RJsC0asqoGsC0eZzQvQNA7w3UogmOus1huimTr3OqQ2depVTaylsKyls30xh+5b+ekOG7ZAqFpww3rTghPGWBSeMRMAJ+Yw2jdFlY8MYJTbWjNGBYUlAHqBLC4AmH9BdGHZY7sCI2JgZ3McC9R2B+gQI2KOIjTnV+XgfmW9bKMRCguQdmtEYiU+zlCgbsO7QhCmBz5Hgk2aOIA66RbpP8yN3bR3hz9PJMsuQpWHuv0dvZ8jCZ75Dn8YEzCfLHk0WyVIzZNmRp7BkmRkejMwDCFlGPlmEJXiF4BiyDMGLoSVLE2Rp0hvI1LizCvwuFPg1HKDAr4EYWAlvaGJ0hBjXdYE3hBidZyfGRZ8YG6a/xhhhiKERqUFteuwN6cW3ATtOJSCBoQ3kTiZByaI7hmHRXWNj6LrrEjWFETAsuvtskDDCg3p3AeplH+p9H+oMhch24FQXlFc9lNvmijAZIgO2bOduIXsfn+du3Ip2BzRmtJezcevb+kNGorkfw2ZONre4iHqhjsBGGLBjGTDJQPY+9++C3MxwUUiJJwzIgezhiSEr2q5AtgMcdeym3GtWR9/FiqJpXtUguou+0cJryDu3jnHkfogAnT6RhrWBW5dI4wKpUtq/dswiiBSV7agesdG1OBtoo2RxBqMvOPMAVFsAUMMHUMwAWuwRFwd/N47ajox7D2m+bM3q7OJyNSuLF6nZIVa2QyJkEjVN5l3apXufl+g//s6td+keKqnHRSlVoDtYMN2hV3CRnVRmlfHAekYKkjgs8BisCItsuk2XRPVGzfd5tN6F6j0wMkDJqN4yU5MmwI3E04/tYFHbcBwQe0PKEGGkHcRViHW/tEOBGrZRRtqomUYhNTb+/4iNGbz82cYxXToPacmcqny8j0yMAHAOQdRHq4BHdryamM9+DZ+BFDyWzYmHubn57Gfw2R5h0EMluVLsiwL6AmMdwLLUknnaIrFNFzAyhf++uzG/gCD+gmCfFavDApJJxA7/sdRYlb0J4vYEfr0QL/b7c4fOmSPOnLllIACIdBFpLPj0f6jYTLxRRGNcZzSgQHBZN97ZDpUsz6qi12BdrE9l/w++lBHAIhmN6kYCIzyJeNYloCrjt69rQ9VlKJKFvDiCtygGsl1AYMEs6OqGL1x6sOC3Fz/BcaXbOrXV6fz2VXMrl0VUNX770Dz+E377mvXbx6xnvAQ3iTcHtmR5kPRZzO5TiQZOzFbUz2dOOcOcGr4v2LMMc8o+c2ofPnNOmdMX5miDqP+ASiKCGXDXhEwan6qRIVMsZIqWI1MEuEcW7jEAGFsyiQgWoVSPTNHyZMovPZdMSbBIJ0GojKPuhDp5+Y5oSQDmVilYZFzDV8oatCqBp/JKt/CNBosadZ8IGnUI5xGVTvn3gvAPlPOl5xd4CAuWGcIuqHqGUMQnBcwaIz2XZAngpOcu+jk7WcQKEDaRmZv2RSLoUyTSc4P6VnpG3Zeld6pSg2qe9Byzp7ghzl+bW3ewEuk53Kf6gvTM4higRzGFVnq2k+6iP+muSXOJjtD1tswX5fgmVuV2CREIznFDkZ79PfMdSnzt+ZZ1bd/WpdzS2vNNT3uuHqE9t5323MLXXV57DvO15za1PO05zGrPU9Geq6AwTT3tuZXxs0NvS4Intedv333ZRhq//JXntO78qVp3PsO68xJxxn99vPL8257a/Ete+iec8syluDDi4+KMH32gccYrx8UZr7g4Y6Tz44xX8uKMUQUSZwxt9T2KM34XpXKRT40zFumYdcyW0THbEDC93qEj35iMZKaUBCcnEpzcdcHJm1CERMeo4mm3JCAZ3UafA5KROzBy2QUO1VCStDrp84cpt6htVrd1CUluUz0/JJlV15NFJfeeEpXcTKOSy0tHJY8kKnl8fFTy+Oio5NHzRCXXYdWpkxOVPIFs1c9qrxM4PET/YgxrPgxYaKYt+HAmOkJ5iqeQJ4LAFbETp4Lo4/IjRCN8IVcvaDelTapAfa3IZIK6JMmxCcy1r8VtUsG+EkeECwMRYRN7wQ7qwF1wzl3A9Meo8kR08nYeyjIhyCOkR2l08hjm2Hy0g/TO0tHJw8Xo5DpJHYwQcPnUh53hdvlPZ9TZCkVWnY1oFUMZ+6ZM3HIZM5KyyepBnO3lxS1fysQtT46NW55k4pZhP1vc8mXX619xuVdd7jWXe93l3vBinBtHSbM/saw023lCmuUeVDUlxhnxIU3V0ec1fWm24kuz65BmMXwo4jjSu6qbSrMVusKVFhhFJ0r9+Wgu595fCJ/N6F5buNUabUHhWuMZE9JtDo1CqscaF1ID1riQaqEbR4pncglP7hIamEVtyEbLGDUYbrkLo22MOjW10TNGGYaVBFZRPQvSbCBrq1WnV42obvSqSKTZICvNxr53VtYcWWm2mEyfKs0O8Wfbuvz3PBduQNs0NdLs3pPyUPCENFvMSLNT64DfzhQ3tdLstldcmCfNFq00O/Sk2fPLSLMVWQ75r1kmoGpCW4aqXcxruy7e86nS7BzS7BzY1IodFKhXdbGvaYgOUmm2QtcEooPnhOhrBnivpRDt66z7DNE1nXqVU+s6NecUpbBVKWxfT2H7Bv98CWDbI2XBCeN1C04Yb1hwwugLOKmpDRFgEzbWrU4Lg4yxCcOSoO0BursA6LYP6IQBLXrVJqWqxMzgviZQ3xGoT4GAobgPtinmIyv2b1oo1Kw0+5Z1GLydkWYD2qFpvjQrBPGl2T3afpo0exxZZj5ZDHsDCOIZsvCZbxm9dphPliFNF8lSzZNmi3nS7PlldK48svTAi54lywBkGdBryNS4y0izZKVZAjGULmJdE2PTSrOIVhRibD47MS76xFg3/TXGCEMMjUhSTIKBThGnWoAdp/oggaGNiDUd6lp012BYdFfZ6LnuuksDywgYLcsIGG1hhAf1ZAHqZR/qqz7UGQqh7cApFpRHHspTldNJs9vZzt1Cdm8JaXaYI82+6UuzQwObbXrzqdLs9ChpFgHRPmT3uH8Hcv3hIk+azYPs4YkhK7KDQHYTONqkdWSuE2Wk2YGRZtt0F32jhVdPpNmeSLNtQGeV2izNIp3orAEDqpv2r5sizXaobEf1kI3E4qzpdNoqG6uCMw9A1QUA1X0A1RhACz1i3uAfHiXNTpeSZvNrVqRZqdkeZqM9aiNTV8gx0iwqaYuL6iwlzS4XtMxibRshyp5Yi7ZYdWKtxGx1zXJW5m7SKE+4vKsSj+XE2jgrmld8l3fdNtNIG1U0kyfWhgsub2ku08nzIJdsi+t7D5kYE2xIFtrJd3njKheSNTKj2zbtIYHxSUKyMLKIy9uVYkOy9AXGOjj/7C5vd+M0JKuIAA126h5KdJbv8pbgLO8tcOfylois4Plc3qG4vGMgtSJIjaliIp66lHywkceNj2XkcQl+FW9WbMnyIFllsXaVutR0Ym2HVvOZU84wpypiUbwMc8o+c6ofPnNOmbMqzNFGm1YfUPcDDyhufHIDii/YV/1X8ZVWhW/UXBRrV6mdBhS3S6f8e0H4B8r5Yu0LPIRVlv/xDEeotosTbhuxtiuLAifHJOjn7GQRa0LY1Daz1VXRFFa9OOHVj26ccAJDVj1OrPXjhIHzo8VaQclxYu0SgcLvOLF28p4ECr9Dk5MECk/+n73vgI/juO6+Lbe3d4eyEAEQIij77YZRwAbCFEWCskTgKEhiJ0WZluw0KZTLD6Ti3kGCcqVaQjtVsj7reEii/kXOz4WqpBx3WzYTd6fRXfncJKfRsuh87//ezN0ecASrXI/SYWbf9Ddv3vznzexOnd298YvCMXjulD7+jScHWclG1+Kuag7GtdF6b3pxvePobe2u3NYe+9wU3P/tR2+X+6C90pzRmB/ZwR3ryF1iONE7JNxBgKMBxeJ59u53vbEZWeLmalyIz3m6pd8ZTVyT0CVH0ui982Hxz5zMUe75D/Uq/2iZG+FydDgOHI6Pa/pJn3o0ltLBtNDcUC3XMbeojyQ64vUghavZuMgmVKdFHdKwnuLvHPVy8R7cH8+x/fR94S1MDPVi6ZuvN8TqpeC7b6i/FNyySy/Jxh9Xb8p2o+sQVQM0VDhauz27WEpx2hdOY23PmY+NIr5edB+9Gx1eJBevzNYYjir5xZ+4jptqWs40TcqHAOCa6uim1D3ercbjJyFyD23uzsJMNua6YWc+y1FCbHSgPtHf4cvV9eESimqcREHYImsfTSX6IyOCsJ5RJvpjfcTOdEhZXQlzNSiEMAYYdfynbxtlRjEuUFONHKiccicOrEZ5iOaDFoKVPhw/CdDbgV7g7SBdVBrnzo5gtIm+hwpSEIcMYCR6HLJLWWE4xJRbXqRcredvcBzPMp/SciXN9iAyehM7SEvdHpWjTnZckbFI6u8R9qfZcazgq0B7MFo4qAuELbpR+IKBEDu2+zmEbGXu+3ncu76n0b3rwcrpr1/3tyXBttjjqgUi4JxZkLp+3Z/u+vWAXHPFutxhDwFCPHF8OBIWvXPa69ffpdev3+LI8HOHVYByKoOhHYU5LhnKnWuIbHz4svAF/Cf6M+Qhgi2p2clFf67j3WQnyguPOXlE/XIXtXqUAwH8Z0p7UR647NAMa/COPZexxiodyqh+T3Klh37MV+wjuxwi+CKFR6/cX6Iict+/FJvRq/2HOU/C4Rso/r+QnnNIMrUKCJFFRqUVmhTiI5UNiy+SDBqq94zyUUarD5nVOYML+hMpCCMORJ8cTKnoOjy4eEgczrxaYHFASpEaRX+aUiiJI3oV/paaDuUE7ZnS4WuZPdH/Xiv9msh8qbKdnjBRsjK0TvGGJ6p4ZaZ7IzqI5RGVA/OdP9BRFMosClpEnqER+avVNyfmESvzebYUMw0PmInZxMtbBOx6f5gEDHiIO5IJ23oT7tbVKBcq5OI4YFRQfKmtvCezveJPH35fl2jZ6gBhdoPAdPg9VXyujDNRfCHUjkSTUVXf3cVL0MZIWQbcgIg+4tuSkAF8RttxpZRzIBkJL5Jf/EZHbgafNHP5542HbwqNmkqCOMfN3OXLCbOwOnV5y73IsJkdR7AXRma+ipWiz2NOij3KAKGNlsZeAc1OmraHmeqmOex66FnlsAsO++CwS75y2DUc1iLncFlsMQ/I3Y6vX3xZCiowccmodGXEosYUjs0Y35COQE5iNB+PohR4pcsH1eBm9LwCAHk7/yIzoyLOIKenKHqPGa1FjN8IQFz1ZMdSF7H+0xvFbHR+cgbOsASmtBlGfXKWLv+A+HwKotskL0+/M+KOgh/sYiZxuU2i9X2V47D0OGfcQWdsN43sZNI/M+mMUta2u4tJB0Eyz938/OHU80yMeiwGq2haJ6wOrilWifviM1MhOADOv17sHqB6vWgPvm+lIop3Fks+4HaYzEa1mQTLvPPK5CyF4WgYdrQw4CrRl6QKs2mmbSp5ZQ48szKReHp7TUf1IoBZaD/KkY8t+XSWoH0X+7sma8ObfRMomXfkMDvyIMSUsrp3W5y1TOwgwz+Hi4sdmkU9OIxi3qc7A2HkmEaXz6/IXC01R0dBHtxR01ntXOnUkoS8ijQaxfjkIj+3upl4Bloi95Y8S9oLAw6cXuGkHOOdJafdZylPub7PJnbOKu2MA1sq9epQYGNJASXJ8aSz4MfpIiI60vKWj3/imoHf/+aQdTnAqvvBC62LI09xlfz31gWZQB7mNdCP91tXDz+RhFw566r3HXzYurWQV73c67/+zIkHrashSUKJ1MyWdWi/dU29VBtYVzIj4jAy/5D35wd3P/LvT93xsHUl6Yff+76H3/ODeIV1OanQ7918666NO9/1iHUtfU/Xp84sO0+tsK6lv+7SR7u3P/r8/da19HVb8O+vh6wLuraJjf2UTKnk2Bc++8LzvvKtC6wrmXz31vnXf/tbL3zEujbzHT997+XfOOtjK6xr6V+46lGu3Lz91rX0vzkcdXR0XDtkXUtfLZX7yH7rgm4Zz/3rmIFr3WTOkQ1T537unS86yW8e2Zyc3SDwt+hsnJWLac6Rz3CJrqG7qSwJGRzZbC7iwJgcNQKasJ0DGfMZJUo0mwbxSxGGpQ/HpwAfPQ5KbbIh0CuKt5dmYSzN0rFZVLVgBlMfFUTnytSs98jOFYURz9PxNb+ktraF3jDuRijlOUY/zaOFcs5zUcnB0IPtUjU9Thm7fDbXjljcMsIHUXkI8ra5JLEKkDUG30UgpGdpWrGC4uC4K5+Cc/WQLBlClgmJb8YsYXqSr02nDh6CEYlrbQdnwSjCTJHJ4SxqjRkOgB4IT4I6fVWkfupB4xO3OmEBj5MrXxlsM48w0tKzkS/yZPWC/BZwPmw0XAjD2kLqWG1YPLO6Dg4xqX7cI5czjsqY4RHeXR/++cnhXfXhhyaHd9aHf68unGkzlrraJXZZ3yL9DH6TA4WMBwe/tb2wDFWMHu4crshcu6+shOEXDZdFLbdDvtopAttEXEgxQ3XBXeziPzWYnom+KnV5ViMqgL2gV2DdqWs2crBAZspodKsuhmtLzlHHbWzJQFut1aJmymDUUjVc/BhEXez0KcIV0LeAvBrr0nYNjpCq6d96njMejDnjskqKPXLmy+hz8DNMjP2RW1+T2X3+N5ftjLMjt9yMf3cOASN7wxIfq31d0FSScOSxT+NfOLwVxyiD6G6ExHnyKNS5Pfqzm0AJsWIqV7EfBbdENyNg78ibX7v6pR/6zfMvqExoVPIpz/23t0zBhF27bu1l0Q9MZZ4cqiSByenw0FaD+rJPe4wgIcEumDMnKZBLhdWMDAUt70uZ6MLjbGAlydU3L6SgQr5tZYU8yqUbude278JhrjwF5ROqf+2QNrfEGdVl1DYXeJscbLxgJSi/P0wY8iaZbZayOnF79xmz5Zks+86+idgXUOeSx0NdFhXRu1FFWdbxwzv1gb3k38KR3NW9J7cwnDjRheFzqwvDMHHMmnVb6fWv2MaxnoE14nlTjHNYhhzLDCpWuRtPp2EIhbLfiW6vWoBKA2nL0B3HsAz9j8u1QX5SqPKJGee+Zm1rxpL9JEuwyzB1vVD5UVeXAQ4TeTxnCGh17Of8fOye+KoMHPKwRPZkguE61EzRWYN1nfqvAKZTG7uzSjJMIqnkvhrlp5SquUxJ7iM5e6L3GrOBJx2sXKw1fhusX6/hBnvEP2PcgnX8aTVuRbddZ+y2fuxXK9O4+Q1rEH3mHSJN73Bcvr1xJ7nypodH7lwvQqJGAyVtAfeXeRE7HgDOJJO3B5O3+vqWuX0aOgfL1pTF2+tRp0+Jc4qfdZzwOG2DA9dY2+AX7/rCPAyNO9VaZkyEug5ijWxthZrGg5TADheKufALnJa5f9cX7uoSY2EuuqvOUqiyDPazKBtDX3S3lWM/xuM9KRueW2fDmzKcT04B3TtFAQ1srykgPExSQNt4HMlw1DFkhzM57EAlbCttukaSedH/Rd52kGdg2g1htmOC2uU8aZDaMB0xdajjq1NvBfvb47GCmV0i9Fq9Qhs49i6R9gb6IuZHdibtEt2HcGR1ArtEm6Ae72u4S7RSK4K51myWgN5Xj/EQ3JMKnp0OLj4HWaQ5YjrJsXGYohtCxqJ6THXeuL6izpcerbDafk6jEktIZmcZB53yfjuUVIqc6IMgqN3VCLmUDjMI5zRFzA/4RdbkO51xh39wPf5ld9pXNkt7HDbcm8nGQ34tJb9kNT7eVHORc5Kd62WSgNgJk9ylvXFIPkzU8py/HbabwspXUG5HXGQn2BG3CM8guq2EtHEbnChuh9MTRzhALVwMlnm7HXaLy7xdcFuWea9nJ7fMe7k6L1XilRrnCk2ySZ9WadiwxhzUsAEl9mkUUmKPRuFZciWkNmIzlr7eNRdIfSw5Y0cyg0P4t4Vf1aQ2YkLnyoj4d1lv0vmC1oykO5gZJU0TjSVdO5JupnYjDeVJHiN+5BQcn1qpi6m8qz22cwwcGjUzU4E9XJAzxuV0XgahMed31aCvJlc00JOJ/XkiMbAHzWTKnegozPue1AYTP5SmUsMa1ScAhZnaVA97lQ9AbqTX+A9SsQ9dW9r1PrwGaroretCM6z2OUZxp3OPUqwnf4p6zM7VcMsjc5Ib8ZVvzozccV7SPSbQ/+7LT8Wy+zLgw7sIA/KasSK/Plxrn3xTws7vD3Zkdr3vl+MCiqa8c3/i+t9pXjmV47cKzvkesQTL2dsNb1KE6qJ8K3jVvNA7ZPcBuHs9za28YO+LVLb24pRbYWgts08D2WmBUC+zQwDNqgTNqgZ0a2FUL7K4FztTAnlrgmbXAWRrYWwucXQs8SwOfhSbNV9Pys+FfqH6Cf676YxMHxoXExIH/NxiQdMaMGPDh3N/kJV58tvQ/XhjT14PwOhw4zCx9KxydbaSXf2sU7oJkLvWxVZHnunmsNYj/CF/yo9FDOllVs0jmwyvZJAugdSEv0kHkbBdh6cPfeKHNP+43rzTNk70MaKZFpVePtnmuk3GKoPbEc+EskMPYi7Ccp3iAshhWz0HALjdeDPetbnxOw7PZS3B4ay7lCJ6y9eyxnl1zKWMVoqi45NyV428bS5biISO6L1kmlEFaSoOX9XLIubQMP/afS/x0WW+8nM6Bjek86udEK9vH4ufSYruWnH2gzF1wPg3Ujow8Z2KCSRfQotp6DIQV1kLMBigssvfW5TC0UgBuPLgyEy+1OwuGffNRzXNvT4YxEM5dCZDb/pZ4GeiZ+5OBkcU/fPrmN7z5q0MVzqcEahifSwP8sJIGaADUC81HMnN0Ibdt7r1j9x/prOemMbsmS2hJ1RS1K197pTsvp9L6qZ/75jbYUdIvyah40lzo7n6m0hBdgBcqOAfNLBlpcM/eRRww1SadXIz4l+iL0DKzgTP4982HxseWeaFSM/XUjI4K6h+lEbpkqkk7WYXCnuSK0Ah8U0zOyWprfltCJY5IK5kRLZaz1jWsaSl/6Ls/XbvqfcutC+J/cK3pEo4Rc2MPPvBo54/vefeQdeMlpdB8NeAgbEhiE6QRMBvVipdYfv6lWv2eTcLH82kFXaKRWlSWvjJkXWvkRZ+BlSSMG5E2NGZRY3YSmLaE62JYBBFAdlWGzIUpdi4Niyl2qenrYUydvFbkYnScbOmNOWyud2A+Pw8S/3jkDMroTtbIm8fn4GGOzDGZZK2Q1rGAra8K2Hq543Wx6cr1kKYNajwdobVxv5HhdSpni8RsynzdlQVjDS+pn7ISwJUXpu7S0xHtehMFLeKmSqP6oXv7Oas2vFyNJuLzyBKJ06AWRLZwFExr4n5cwPwMF74ekGM9DZtRhZqs4eI3chnK942KjwDh+llK1JcFZ3e7nInoSpyjrX40Yy7ePBeLOGXxN15ruL1RuL2Bc1/nDaMfdMKxlm9aKzdOb5B+ACN2oU2IwpU1V1JnhSPn0Tqux3ZY0ZU016iKIxkZTosMVyZ//MAeTeXMsnpJCLp4MeVjrjPaf460/xzDlFIbInOF1qFCWn6qPou44MWU1cqib6zuqq8M6gbvtJVZZCuzqFaZdfoa/jp0Fre3drh0DedIc0w5yNroUOrHHJ0imAGLIuvPlq5hD/czbUQ7N5rOfy4tv7yVDQl4g14lUnqpX7EEOIbRoPM5JgLR+3TuGPVHD2Pi5rqzaLG2Tvi6FTgD9BwauLqX+JR0r1XgkD443EaU3W9vbJEKLaZzAYd5Ltys71xOP/ihV/TfeDyI6m9pdYoYOlp/dJDWXYbQaLIYrIlZPLgSw4AKhPmNI/HIQRCuO2Kv7qhw/ca5fgLLF5tRtAijaBHnFkwaRUVAaWaIFowHv2M3ECgqx3Q+K5jwm9vS1IW8SR0PaFea6mVlF9mdSJhfxFxjw+0AuJXqsYU0sJy5vfT2hMfwKA3envSvb3VpnpwN7ddVBUbeNg6N+1FIJh7gAvRzC7WMkwHbE7UmKquzCzNRvNgd5lYWuEgZH8yeXw3Q1HnKoKmzCZqaoKkJmpqgqQmapgdNhZ8zaAqboGnq4G+CpsK0oKlwcqDJHf7VgklREyY1YVITJjVhUhMmPdMwKWzCpCZM+rWBSfiPm/jGE9mK+1MDl/7yaHDpEguOLjmt4CiYFhxdMBUcrZgMjoYagyOTw6bTBI5WpsHRhRYcnV8FR+f/TMDRJlpxbHB0cWNwtArxLzoVcHRRA3C0+ljgqFQDRysBji48CXB0ERd9WsHRBTREFx0HOAIradUpgqPV9eCodDrAEQvQBhUfHbZ88qIDM88aT0V7DUQ6hZn6DYzS3twAgVqXgiinBk9kJp0KUaYoV0V0tipEp68G8fGUrhN+FjMhJnxIAoeYg6Ick0Y1W6WkdKuP6c1+5i/N1WzpkCNTurxFuN6M5w2s1Cbxei0yxSkOtDVrIMc6/V7HXFR3Pc3l1rmKPWyrv21b7eLToNJqGpVC0WjwyzbaoA5fWrfIQiAywHnBlIoS/RxqVAMHG4AYNiha4eC1VYi69qgQ9VZAVJ2fFplJaMC4ZNzIuFXgGghwRWeska5B/kFj4GoQ75oqcHUZC+ZdOiXc6mYmX8YNFNAIt4ZV3MoRGuJWdxrcqnU9Fm6dvjIp3BrWcGswCbcKLAIbs7XqcCoH4xdV4csFUbqFriow/EDmwV5gjT5CgYzDREDm0rNi7jKUsBYtX3takew8HqqXUhbOZrqUNv9eL21mJFs75g7g0ADJ0ukBsqayFszawTZXQWxjAPtdO7jq8evc+tGF9p3FMWZz5hrBS6NX74TRKz7fMxW++pAVmoJeQ4tevUboNTwJ9OoDveqXJBZLL/wyItfM6UKuQKwWvTaRaxO5NpFrE7k2kWsTuf5SIFf/1wa59pwccm0i15kco/tXC7kuzJzx6wpaw5MCrU3Q2gStTdDaBK1N0NoErU3Q6v/MQGvXyYHWJmjtxGvkPxfQGkwLWoOTBa3M+OAX2NJ62WTQ+rw60AqVOhm1glYPW0GZBrciGMB10ADX5Ra4Asxa4LrMAFfI/fuSzRc+NuPzK/6UE1aR6mZ+uJAlfTOoQKqLVHTj/ipiXXTv2PuOzLCM2wXUNsz/y8UVdsQ2RqxzZVi904yhyYh1EaaRxaNpvCpZJSMNLmi7mANAHl6b/iWrEB941WLQxVUMOvyp9E+vPvyWYlBkhZakf0nJ6D3TiH7TAHxzgPn7N28aXTq5GQCr3zJgFYxN/wxXWq5cWWlN/0D8joLVbwtYffKJl1+Q/rGCXmDA6hNPAaxCa+u8ivpjxGsdPq0ncxI02UBVRGn5p/ZPrEj/VJ1qZ4GLBJ4ZqPobSAz4abiD/kSUKi8OHAczDmpFDKZaBOIiA1hzS9wD8+OlRRq0ChHzUGlsdAmr2eduiTfSclp6WbzFrLVEVJdV11hpWHKOgSXrpkKr9SYIM/aaqvitKQXVs5V4cgGwmJeAkk51Sl6fAjMbTgLMLJ4eXun0wGw2Radx1Dmpoted/qLXYJpa0xA+uTX4lDTh068PfDqjIXx6Hl32CwafUKVnHhN1cIyoiokAxDbymhkKiRilLf9ZoaRBg5KWn3aUZIbyYgOCzoHbAyGTnBQoPacGnbJy/NLjuh0/SloEUViUQkl4YC4fL0parChpLq74H6Z5MjA3pkDTORY0Hd5vQFN2EkBaQc+pwaiBicmgaV0aNGWOHzRt+cUHTUOnCpqaoGnFLxho2tIYNG2pB03PV9B0uQFNW+pBE/fEOVVxOkcnEa7yOdVLtuLNptf16dKSUzV3cZ2rkGRjFZJAnVOWFWeyqBe2oOOAKLsmQ5SSD62LOVBmYMwB59AWg02uqGKTK54hbGJfAbmC+ZG8AOjEidccFaGsnYRQoqMiFJ64X/nMIxTv54pQ1oDG2cu7S2vSEOUFpxmftFt8cgXafQVt+eXGJ1sEn2w5WXzSxjFa6/DJ8y0+ufxnjU/8afGJf1L4BNz1Mfv/zNDGsWHGE02Y0YQZTZjRhBmnZgJJw4y1VZiRrYcZHLZe36Y0W4Eb2HdcgAOxTjfmEPp6S18P2s8PcqxNQ461zyTkaGlCjlQHFDlG4RcNcrinC3J4xV/Kd0rD5sn85iGn5iGn5iGn5iGn5iGnX9tduuDX5mR+b/OQ08mh11kc48yf78l853SdzHeLvyJXEfSc8ufiepqfi2t+Lq75ubjm5+Kan4ub/nNxLT/nz8UVmp+Lmzr4m5+La7HgKNMIHLWcMDhC/c+WK+fPpj70Sp9c97RaAgJzEdn9+SyusgvGg52+vf7Ll5tBd3XI9V8molxg56CfcnDCJLw0yffi5lSUWWBn16PMX/RTC7lxqwe80ZK0odwWvUA1kPvk2AmXeaRODwV8tV24I2nHFXPw53YkEe6ZC4idiB0OCdU5HCn1iUgTPx5plocM/csm+kFD/3i0kgstHYhGqQXKzoeYUYYx0FjSwUVyaLtcTdcOYoaYFq2MKJLb6SK9nS6gaqqe+gvtQAqTGXV32nEa8nA7HXVQe/WGOp9mwBN3ydWlXSC0Yzy0U3SZuac7rx8+5kEarWyPO6gQ56kYd4OJXJ+253O+eU7WEbdTt82H+x997oP//ChDo4tzHuecN12EjDnb3UzMUwcTOddueeymCKVzMzdLJJfaSkWu5kxqW5j59E8YU+jVw3h8CI8l6DOaST5XkoLoEb2EEuBQJSLOURDPxJWeiJH4AJcB4vfGM1kcujm0h1rjPKudw5w39UgLcI+fP6qN4NqHqLyP62v5jwyNHmlRD+XFzXPtn3BWxz67ERrhqxhTzghGaAQhVEEA/UCUEi9IjZUvFZ3IiAoHfty4+wz9PpPTHSansqH/pYm3x9B3m3i75A5E3OrOwtZ2osIGsYE0qbDWS1wqmsgeCOxEklfn5Swz7dS+I45Y5jp3xCGLGnXenvjbuA5yh7ePynQzH9GdH9bufIV0AEpUOaUzxuIcd1hE7dTVezsmdyMCoQgJZ5MTUSbf3EGPzs6jn3uqIdQ9SnmEFSmCuEVWyG1zc9yOHNoBoa+XnyK1gnNxKxXELVBR3CLpxZk5Em2T+IIcs0Z1PebjKvTqrYW8hbstMWFcdRTAS6wkoGCnUVz2cYxcroNM6bmdTPFe0OpQFhUdSLgzh9U/mOShrsTflxSglMRPSRHKKsup8y/gP4XLX3Fe5rfkOcRzEc9nk0sBrweTcCzaL7NoQZvMpZGlJdzjqFMeWVGOezhPIeUZ7uYpoALYF0K+eFIMzfzVwu4AM4odvqGPtWvczvVtoRa9StREZ4y+cjwOdAyb8ZunVo3DeXMJAfOcAoD5dghExBkOavZ9mv3ZyD6Du/aZ55xTFhwJ4PQl4RbOkH3DSR7OQFIQwspxZVKBQvxQD/BJikSzmLXFSe3gBrRBy2nlQtMO7h3wU9ZoqCTXDk3bwRzhOaOE+wx1sosOgI9FakMb2uvbwJVvo3aBv+ToevsyDsxxJiztLaI+sO9vr+T8Z8fTy1yNOO1ytiU+Obg61ScXl6WKcwWBCBXMw9DdkWRxqSr8zo4kwM2qvtylyg6HrFJnUIkDmkOf5kBK7NEokRJDjYLzGzmXywCzyMMY9lJagdEcWOTgMYT28KkaHNUHZy7D8MoV/8F18uNTrqdFOX6pXTCLGwcoFZqBcjJxhfycJ0/0b4GycZHD0LdFLo9xv9MLTYEzFIWSr4N2HGM2jzk/X/LVVMsELw45ZRjDClBgn8mTClhzUBFlmXkgj3kgL/klBWMSCGHS4kKRa7Gaa4GCOK95UYEDeF0QHSl6ERPgz7A/Y6YO5EfIz5yCCGTFyPobd4Ll2eEnHoAIclGWy2IxprejI4K9YxwR6u5wXeI4O7mPeNYGVhjHjecP3PZ0IHfiOzsps+XeHfBjGCvh8nvHintO55X0HgQbOAm+aqs9hqWxV72W/tHatfRekTh40rX0D7tO7jgvJe+pXkp+N98snkEV9Dby1CXkPeYS8hxGsFxCfhfikieXkcst5C5G7ofqLiKvVZ4C06SsNAQX8Ga1DrYicj/+S68p9WznZnI9A0xEHkaTTj+u4R/StSC9+MIkt9TkwPV19ebvrNz8zU6AeOL44iAs+vvUzee5+pvP24vRh284+SvPPzLlyvOe9JXnPVOuPB+WUqRLIEzwMBs42cvJ2QYmTX8t+dSb2vUCYu3H+guIe+w95W925KpusCxSVMdiBC0Dbbpjpf92PIVjeAx3KNS1584yscs+B1oFoilGYoxvV6Z1uVmbW6gGYr3+GwJC3J+UFQEjX283f8vpqwNUTF0VQlThQKauDvw8tRIPOq437o1ZFmMoJZ6p0sVmDCBH4T8Xg+LtEUcWNutVle5xSYiYKY0jLY9yo/8SRiMVVtYSp6VxHMCXCuZuR0ZXUL6NPIlIme37KuUkixZ6sAl4tvJblIGZi0QMPWsR5onXV776FiLgIcTw8GUMoa0YVtEnRYGwH0zxNNevtobuuDPGS8cxuQX9TdW7z8vepLvPd3vkQYxvhMuZ9pGjABntyVaZc1USnJd5B+LAbjSK0XrAwRPaF5p7j98qenKXy/D2tbi22MP882GOhk1K7C6EfI3yaGmfgFTyVmbkqnMOfjyDiUrjkRd9aLcxipM333tpkpda7Hprf+lFzCZbTa1hfrm3h3MAghn5yo6v/tfBHz1y3lb2v9PtWzDvBrro6le+Eque8LzMfgf7Dj1JnkOtNbjMvl0O/8Ro72UyL19BYW9SqOxFoebfi1q5BZzolpvx7ytDFcpTijG96Nb7DC/mqA7wdb4obk9C8MEFH+5xtKFUvJf8e6u3zc9RfhcFIPDzAIk3+up1gKU+sp0P+AFky0ByJ3x94ht74LYK2n+l5lUEb6k437si2v1WhbQe1XVT7pjd9HFmf66uj4iRhWn5/UOVinZR9E+o3AQafoVePP7E+6sXj+8xF41/WA4HZtDJj0toQy3sfRlhekW5ZFLUDPd9wGaoWezGc6MsklbO5LDNZKlb1ojWSnV4iJeFSiKO6f4V/FocijA3ou+BF7reQd+Sq42IPoWhhXu5/xSP+2Rj04E9QKUB/5gniCDx97HgJG0jIjOPPVbaCmFtq0pbNFwBMytlCvdVDG3OcGVr7OD+e67P5SVpBvna425VyHqGKyUmHUJoBf0f4k9m5/0m/PzhSnlk4YWzv/v1pbOGJGr5i9fu5v6pCTrVvFf3Vul7hqnm3dr7tJs4ADSreondUmZNb/Qv16mi4MH/fPLAtS3sZOSy/jSLV+loHlZnUJ0Bvdf/cYddTvJNuF7pHR5L23+qf5C9T6h3gL3fU+89DvsPqf8ANMM/q/8+0L+s/o+D/nn1fwH+g+r/EvyfVv8elPRx9e93VMbhP4g4B1QdxHmtXIuE7EaKBeI9hEh9tbLmVGtJ1arPrlWxR7xfhrdTvDciq6hWXlirqi/eL6rOy1e13qdlIZqXi+Mxb9zoJWIe4EAe5RnQBwgx5/OSDhTox4WslHV6UN09muryCY5T1Ej7HY0UXmRj+mbOAgP6WDnFWHGjOhmggYqcl8kAWnMiGCxD3Y3mCaSKsUphdBPgCkcRZlM++gZrHjz92Q0MZpQa3YI4qvsQ8g7AnHcLzVCjr2sM5sEfKfwpRZozFaIvvnVS2Gccx68uAr1t1gJKQd3MFBx1ZnoNq7wkX1V6QcO5KYDmhMMZ9CS5EhiTw8Psi3s1qU8BUmUgHTZVVnNDMlbDADZIsoocw2vyowelWQHX3AL8VY7D2MVO/OREjwn69AgTD/KIPgNCa4ornuGKQ47lCnnFr/o+Jn2HsVBtBWPWCwYaCXAoORC8qpwISM8o0FDhCCEWHkuOBrRYBGL0k2O04w+hGxJhbCengNvDbgWe2eyJntApDM8R+edlUGEXo8YpzR6NnkSoZqkTFHHdos/eUKVG/yHps+bpP+XJM0//JU8Bw3boO51grB5OXHgPiRcLDX9tr93G7xu2qnfDcBkpZfpJsqyXa6AAj2XzWD6/UhGCzO7ach1AtTof1A67DRCxXAYA1DFs+MBkD1Px1sTtTXI6bl0zDgcEjxZHbn1NZvf531y2Uzojdxtl9zL2es2fDo1+Z9En6Wo12aKSE3FWO2WJdArgZ1YXk9lq/WXeMU1QCmc3wR1qezlGH9oFJuo2LR7K9FbKxb9zeV0swhC7Vi64yRAZg1Vt5lVlFELU3FU4LiMTh1lFR0yuExlhU/QP4KE8GzqxezUSg+/cjT7oLmtsciYSZ+TpO5/8x/V/sGmIat6re0deLP++zZMys/nY9UI1TNY1jJM4nLa+rn0o25FOZUoaHFQzZHVqS+pdBYjuF/+uzpZQj7oxR3A50vjBWMeQGSlxlryGSEkWVzBH8bHx12wnL/oJxoDUT3OIkAMyyuqchrLsIh2+zlFdP/vIQDTLP0obvJq14TEvcKBD+MfrEqtHBuost/O9g04SpFCNw+3GH17klIUhwontSU5xDv1+2V15dWumttAKIeS64skZxacGQ3IE+1Qln3KKp/N/mBTuxVoy2nG/LLJg2KX89m1C7GFikYqV8m3AxdXEvO3WUqEitUxQwH+iI2CXFXWxv2KXLkyKN1eJV7WmIyA4SlrqggkFERdTKWOc+8BGMllC6cMKyruIobVJ5bAky6VYstqYNQfs4AvrZtEsdxYFMoniYc5o6YEbMY+CbqZRcEmD3nlteiIF3cyj/J+dFb4e+N648yZ0Zm39Z/uSshbB7T6QWYZlVFanUAbRDvwY4sF0a4a/4milOzDhpeZOqB6FXleyp8yhWYRGX71B6797t6sWjITtOG9FoQFozCgsQvkhg8eni2JjxvpUc9EVBaiAloddyjZYC4Q8TB7nICDU12vMl3M2IKMyDmfHVU4D112Ohrs3Ohp/EzsEQCvOsDqD6gyw8yjH6TMuaZIrtIX8lyz8egNki1lqVptKYgWl3jJrGTbDKrrWVcfIY88df/F7yv89ZOehYR5YbsnRxhtlY4sJR5VspmBn5LwbB77+R2+4aIVAWkzzVcpWW2bGzMezKIvl/q1g660epmGbcwo6BtGPDPlGGJeh8WGkuzIJ4Fyd5DDxBGzIIPXBpMmOmHMyvEtIDtREiOpkeEA4asApshMhYpFyYtbxJNZyz+ZgU/MIT6UONLVjUzuUMye3Mfg0A4zEQE1I2OEASEdvRN/SZuBFx8xolfr1KvVQivo4qIax+69VVvHjWz0dEBqwBwHwV/HbcxynkQWHOw9A7XMNrDMH/CI29cUyI67Hv+xOZ2zqBoDOFrrNZi0GEWft88GKrG4YsRMmuUtF7dgzkEn+djY6xAXZUY2L7AQ7YhnHPixIrYS0cRucKG6H0xNHXPsOrOCw7bHbYbfIwwNuCzZZPMphMInzUiVeqXGu0CSb9GmVhg1rzEENG1Bin0YhJfZoFN2b9SBMHXroCZaQ9vrt/GQGtdXt5SedegJAVlekaaKxpGtH0s3UbqShPMljxI9mG7cV+9o4AYDdf5hl9KweFdjDBTljXE6n7PpTBzqsg0IjqL4seckTK//zqih5JlPuRkfplG7WehEWsUoNa1SfAEZnalM9niGiByAc0mv4w6nYh64tHYA9wnZX9EVEq9vbODtTi4KJ30ZFYoDs6Ms3HFe0r0i0f60dMslOOmSSP85DJr4eMjlAz/AZk1CpT4TmjElozpgY+pdNvIOG/vFQz5iEP8czJq49Y+Ke9jMmvFIH8jBoowuWiKlnTD6cSZ8xwWPDMyaFEzhj8qVTOGNy/qQjJtoGrryvR0zGRhP+o0dM0CAcMYE7/RETIw+HjAs5AP1AmD5iEqaPmKjEQFL0iIlx9xn6fSanO0xOZUP/SxNvj6HvNvF2hfaISXiKR0zC03TEBPLWDc3FnoRn1zPrjpjkj3rEJM9HTIJGR0wgyQl30ZGMO8CAaYDUT+wn44/YHxm/bLFBJLohDWeaDIh7f5S6T+UkSmhOooTmJEp4rJMod+rmuj2FEntH3VZ3U9vqkLnG2+rBsbfVme4hJfvA6SJSSpbs6UNaFGVEnxMhZYSUnFuE3ArIrVDNLc8DqCD18DgDZS5yMZXkxJwDP9gNdPeoG+jRtBvoxWtPbEPPnX5TEa1z0UFT9xT9o+4pvvX0VQEvxNk6NNpU9H9FNxVvD7JYvef4V1343ZdPmUpLtwajBFvju/T1E+JlXjnA31uDJLetlF+NKpjXWn48VOEB6NkmDZchjqU7AlhNMUJgFCrCCXG4x+BLsKcN3WLOQAVYEmKMUda2y+OH9iSyj661Vx3i1VEHenBvinDGyL8X4+8c+d8fst/byzX/E9Tc2GCpg7yypdl6Vj3Suj3cLri7vSR7cS/MbOAmfqtZrSp270Q9yVvu3RGwqzXuZKyU5FgwuIpaGj/k+GHvzbzrh3gcEhJTQlD2BcqaOGu0SgHx2wkWmXZp5dakvTfOioCyh3kAmcyZ0Y9SmNYJUeykGaDhIFgrkzFZUsjI4owyN5aZUKl2yXXDE097SJLbN1F+mhtYYkAmJ7m4bdnXcghlX0257fsSrwxhsekOcsdiwMxAu1FraqMOYJf53hOYJyplauGSwVYrJHfkkxyGZI7ZEmdRsZDrW0Rvt8NhJmpW0vhWLF+khWiAcG3ke5fue9bbvvsPQxXq5GK6hCvl2n5YmSXaWw6OQlVBWl7OzBc+zACnZhgNAjNZhDa3T5Zd7zXmCLWK+VL3Du0Tu3YLeChYHH2962INBixcPeLiYk0kQ70n9snhBb5L5GAB0MOOB0jqlDJixkZckmBEnw2ay/E9ItfEQOoFGr9P4rsLQJD4faC5GsOVGMhvUMsetmWv0rKHtexBzWtEy14lwYg+ApqUvUrzGtHUz9P4m7Ts54Eg8TeB5moMV2IU/9FxwuM8aHQokz5p1IUDKof0uI05cKTHzlm52ZNHmkiPHoWwuNijR1168qggJ49y0dfqjh1F/6xmD92OM2eFoq8L0UVBePxG6hiQW38MqHi44GfHHDkFUdPIGPvQ2xiOfmqXP0PY4lXrdql9bdpg6THFXd3qVFVKXLOZx4GqDdbRaUs61z/LeRa5FX92E9clbaWHSitTVgMqbJ0fef8jV3/8yZd8nw3wW+Tf+4eqOandP/FGZm5/tHv7oy8eqlnsh285MDEyq+zw/2uGypW9lb2UnSjHXlGDD71tmHwtBPsbP1z+1E9X9n+bS/b2JsjDRrq6N7oZkTSq8Mcnvwzbwla79RBMRN+VhWEukvWuze6/OTsepVxy7hbN5ZboRkTYy8k98GVrb12FGhXMEVyEwJAssyIzDr0AEeM+x8oRFQJWMXVkfCTALIyd+o6t71DHdqgzpUOdX9IOLZxoV+a1F+FS3vZiMLUXA+nF4NR7MSech5kPo71IthNd5hc/xSGihcTHwdEHDfrWQ385r6XM6C9S7zZ7lxwKpX+TYm8ipx+JPdKPzlqZczFiY2ZiU/M2NW9zbDY178+6d5uad+pR8peczAn4b045AX8okz4Cj6dJZ+CvkRMijPuNxQSOn6hqwTpwW6k8fo0m9KJvIX/7KgVMO264DLlgBenqWxBM1eP/cmgoVMeHg1oNVE/c+9G3kdn0J+zTJ+q70gfq0TB7on6T7OShhItlHPliFfTI13WIrkJifoaLk0VYiUocJ3oK+ZEjIY6GFIvPdVzNUJdQyBX8xSYhOMIMGU1ck9QlRxJRRppb/G3HH9f9RKz8uDgs1vR90kT2t6UjEBLMdRGEqQKB2OBBaGAT4EnMS4lX6pEyPug64am9U9J4ideTXuE1frkkF/2/+iXed/A47dskufTbJDn7Nklu+rdJgurbJLkpb5PkEE8cH46ERd9NLSODKW+TfE+Xt2scD53iyq4MR5EeFUhjBB2niciDESJ6+K0qeehw7lMY3Zk5MVcGOzMn92LK90/0xZT0MPkBEp/+F1Ew8FPC5CrPamLvMZPYEP5qGU4u+g41xvtS1iLjl16NTZ/fgWxC2EsvtVvlGH7SqbUl/d2O49jiDtReKSWnESthYJLjDj3suMtxjgOvH+I4L3x6nBc+c5zX4QOBXbELChvZezgDCIq/HCc+YBgcgLCjh/dW9MTNkyK9KD3DZcF+JHY3W9m3uNmsOUrljSvrSVmfwW5u7LL7RGEUOxJG2/g80h5nHQlyKcNeOfKCEejvw6BjcfbjkHDmsSvJY8aWKT27TbcPqQC7F59BzGP/gXJxC4XYicWxJTUitrBT2bvcA0jQnRM4LdSKMlrJWY9OkOzjPIxoIejhPilj3wTm7hzO7MZyAKsSFyg0aTwhQ63BBZcc1YLfcTxnzGc26AsSDhl0cODN1m6ZYcskDvVVzZLVg++w6v4xWDny2Kfx7z+HKmzhHC3x/2OviD4t56Z8c/qiBgS8CdQDdumsKogAjg9VIBOMRSd2r8AX26QcIElCoGHuXRDCvUlYKTMhrDA9jH6k+5417CKHUsa5AdLQ/1MIfe3tNznjDv+Kb0qd6AjSWpasGdV7NYOt0uMFs+9kPvaYo/y2NKwqsBZIPVGofSuVL1Ska8uyFfV67lF0MirVokMoYHknOe9MBXR7KLNYaDasKCexVOPgrHPY2vAli7iNq6D1RYajbJaN2zXvHArLVT/IEpEDznfAYQaTz9+lOoM8/jsDLWyQeZtIaIdUMinqJ3c6KYq7rL7nLXYgntTXZeJualceIB6n7qYuDqEiqoDwLssMZYUxpHdSF8drecvHP3HNwO9/c8i6yHPKB6o4l6R76hemQJ4J8jC2RvZbV6tFEnLlrKved/Bh69ZCXvVyr//6MycetC5CkBvJf/yUSBu68J9WdOwLn33heV/51gXWlYp+99b513/7Wy98xLqch9B3/PS9l3/jrI+tsK6lf+GqR88sO/P2W9fS/+Zw1NHRce2QdS19tQDrj+y3LuimpqiTweX7rYuwKZ/ZQou7aHJzPj+4+5F/f+qOh60rST/83vc9/J4fxCusa6tx7+Zbd23c+a5HrGvpe7o+xc14aoV1Lf11lwL1P3+/dS19nTTjr4esW2tOD3H/OkYKrZuceWTDVBnlnvmik8w6sjnpbRA4m3r5g1rIzTUk63L0DYS0RzYbwW2lNhbDHu5x5DaTZtNMSUtnHvmMQ1Oit/GocDFOQ+xqpJUA3t0uOaIEAmqTr2UW9Ewek1/BQ+mVRiu0yH4/R2cPtIMoeMpCcWSwBVNezn+OlnErZyyzyonlephz5T8UpA4t3eK4zngwpqoGo9JLqzi/5s1C1TiqGjGIMee65bpN1Zo3lGqGFcrtxZaJvtESsuJ3NGmIGZPy5QTTpqfF6pkXHwtKyqA9xbenUMUAQ06tcmN8hq0seeubHcbWETsMLYgdxo0L2MmVFgiagI/Y1wMfTkdIWkdBEJBn9F+YUDjWgOXRPUFgd27hNvdum3u3R9+77UK7J+3ddp7E3m0mbp+0adtVv2mL5u/pTly4u7uTbtZW7tZe88rEJ4YqFq8tmW77thPM6jyt27cX8wj9YA2NRT/SlcBUEhO3TaFWJqJ33YRsSmbdX0KuDlY5h+1upho0nOjHICRigNBdRjjkMCexaG28ajL5pVdNSGBWTZ+FNvTGUisZ34xwH+pkgB0HCxYfQs37wShOXgTy5cMT7Pi6kIFPFzLwmYVMRhYyWbiHuuIAIdUFjRO9W8xKOW3DXhFwN3oniCkMXfVe1Vup4LAbefwqVEUsENFP9MMufmqt841fEphvEX5Qj/AV8kdPTw/xP+p5HuawBitQA6BVHQWePLWwuHrQQdANIRQHqBkSAg+VvHZFUiBf6lCpxMVq0Zi2tFcqScteaqnVqXJbHMo06ldpf8CSUV0W7uUM89I2lhiuP7XIJ3+K0RG0DrMrRxRVX0tT1tVxnuO1VpICPw7o415Z/SI/9pEkybOvB3O9+CKE3pJo1LAaFWxoky+hEisnKF45yJeTGVo1rChy6FhVNon5MhG/uNNK7UrIowpMKED20RLUz7akCDXDORul0oaHNnmAAoHIBdInqlHSC/NDjlPtw0O1PqQsBt0V7PAYI7UZbNKl/yp28F56F/7e34WvCuCTCJeI9eBj/5+8qwBvJLnSXd0tqa2W7LYtybJleFXjpVw48+04nL7Jt+u5LB0Hlo7nk5T5Mon3btmB+ZZDjifMzMzMeMzMzMzO3vvf67Zalry+MM18VlW9ogdV1dXvVb/C6YTDu4qEe0vsswDeHVE9/312NitNpl44Gw5xENfPhlcRPccnHHaWGfky5w/U7g8rfJzB8xHCktmb6SG+OPg+JKPwPT5Px/Km/3WdjqIKbOh0THQ61nQ6QvQyOSdGJmeQTc4JmZAqdsOLjWPxAlTl4cxz1GBraaiMmaNv4hg++tFqXv35ef2DqsZFC4QNilP8XDwNiloyVaZl6qxdZRlX8UTVBjUr1/tRaNlwqCad2OjK7pVPzgO03keyclJOKuK4lafaX4KmODskGWCOGP7ZTYddYIUR6zx2iHT+l60yvOmOL1Fl2DtQjw91rGjxb77jq6jFvwWNHaSefEBBox7mGvVooFE/DoX6bXcMK9SFsi9Hs3nhvgaBW9GFunLiJAfD5gBFAU0VrAEPGGsNOAh3MQY8wdPjXBzIqNPjXAqQ2QWYryX8rARSNS3f0FI1kQNiCV5bdLIiV6rUNEg0aMTnGzOq1gVmjLN0h3Xnztx2kat0FVJU2DY8FSPklHrJHSAwPqqcVRU606+aYj5DR/xzdhe/bfysdnvp1SfJ79psHHo5Z/y4gnviPurFP2TMqDFDCAe5HAkF3zwWCiaSSJ4OZDT6DI0O8D5tfHyhpcPbB6rK53wkeywAGwC+K4mAA0xEqQPx6le4noUBVvBXgE4QpgHJEGNCyxvwMQvCqVinHECIZcP4UpNrktWXg0pbeGN252vmrUwnrDbpKaPRpFKTfPhmkZQ1wEOYuldWW99Msjo9kNWzv+Nk9asHyuq530yyesFAVi/8jpPVn4zK6t+N8cfxkjy4QBR+Yu188eARuOF8QQPdXI0v67zkpcI+zT5eyO4Xs6XN3/UGbep6DOgvjoU+aBzw3gPgfz0pB9K4ko2RkruSHjyuwbmMi/pc95NTIFUz5Gd4d/XlbnZePrLZCTcGmx0k9mx2HjjOcV/6uJO9g332fTkv/f9tjLlurBcr6BVf+8wni58qxJ9biN9SiP/nMxB/k4wkzFP0/xykFtRP1m+i7LD7q18ESHM/q1GM7Y8Ooh8cRN8r0Tfv17z/h4OifynRt4wr+tYxQNnrwS/LR/+dv0i1RhuRBNiG12YkMIFeJUtZfKcZtwPRwroR+VUzbEpW6GcL0F/LVp9PGqyRr8lSHx2kpMY7BzV0aAv0tWOhLxwLfcZY6Kmx0P/09kAZ9qcmG1fFnVPCLg/AkhzX+LswWnWR0yG860rGTz6NEsyRfP7c4g+494umoF3CTAGXX4cKFl3r4FTFdGqS10uGP5BVkHIHA1kFA1kFmawozLn4s4Z7+FmTUxYKH8fDX7gP/Bn7wE+Nh4Ofo3CmeffEwFTZwCR7Y8RG2SozEDUcE5V+VqzrfnrkEenHZKi+QQfIjuclNpSQYEk4x7u3LZNm8CRkqEflI969OShxkjgMOUxENunPPvddbw/PS//mKYMWsaykwXkpH/UpwuBYKw2PpV+8aQhcGw9O0ifRCHARZf0R8L3Hg2vSaz9l9PbkNNIbu+nUSIWGrSBoo7nRzts2QkDIvfdILtkJdZr0M930jyoj2au2iuBsVE5Gcs+26kRpfMd3t0LJ4fTBI1mH5ePQ4GRqhmn001s2oR162LERWa9lsl63JQkfaadIc46zVI9zfIrDR2bSXs+kvUYehrxlqWOI22kOX8jhTHa2Y5bDUxw20jVYsuXFsIkX/A+6Voq7nSonEfxP5Xvqhprpv3rn27n8M+g52YrlxbCO/m9lvUhO6qFN+Gq7RAzWl/OcROpSSV2Zpa4cyjuuKduMddLYNjWHWDSZ+j8t5z2o0qeJvmteXGQVzALJG5+UsflqfCzO9XmjEg0VY6xkAzVHbYrkjFZqbIuhqOSaCK7PzgRRE9NFaXRzGZW2RXNFvoRdrqSngdAivmNuDWNNUc81gXo8jG+D4gG+pwy4SzEQbu9FuK0Iz1N7F+HUwM6kNRXrW4yL7wLtYAzasaCNdvFtfbAXbQb3XADMq3Iag3nOh29H+D5b5PszYGwNlPHNvXQ0QUdMTKjQQQYbfEl34bdS6ys12+bLFcIw97mTHlcDDWmwFyWaKaL+QoNmuVxpP9RbZHLUazjPGiEtqCvyL8yQf6lxQAZyqpn4q0hDhJFfH5HAdJGM1yoZkMDBZBTxR1XF/41fK/x56RtBPiki/84C8tW9yFdz5KuCPLDWOor1e7+qWKObLsXnpe8pwFhtXQ4q/JguDdz8D5TznqxbwE2f4bqMJb+Oqrasy63uEzJYRZdi3VNksEiXad1/ZLAJXcJ1r5LBqrq8674mg8UM8x7gsWvScVv42k4ML6QeIfJRo6+fSWo28LKIP7bo1gGL3OQJN4WjtJxYdIkevJruUw67N37uziMxSzcsrNAJf9XJwfS5YjaZOtd/kLq0WhMvVP6lVMIqv7bmryN2jv+gI/4FHCuzlOCypoSW6Fz/kYiJMvDHOTapdouAJk+o3cJHDGYL8ddZySif1K429BDt9doEI3S1xlb1KG0kXYkJSGI1IMKWjkvhFkLR66/5pOg97ghvDX4133yW+MyEXEyZvFc6rHNC3+nFo2Zdd8AAaox5AMu1jkuoUoGfkpLRIUToF67qDwzNg2jB44I1/xLF4+FHhGFGPs0VZ0CC+6VK2WF2YzaMJWOgKJoBip/EQNmLIkYLHCpPJb+hg5vb4VRa3oBaP/lXWOZVAqFQrltXvU4uH/ED93DpnfKu+U5uipv9tSfdwkMbZXJXb3cXxUHdy8uT2b9sfHPx1WrI+qVCgxR39//OiI0p1YMrARmGG8e/685DYqNPXh+Rq/vOiI+PQD2eJm8SBPJ2KEzerBwavOK8uQRPBTfguGR4PYyC+QzTpednDX4/a1zEIj7q3bl5Pu9hNo+S33HiqPaRYiGsXtbBqSX9LAn2xAjYQDQo8wM4D8R6in1mrMeZq13Kowk/hdcQw2tSVWNRF4MKsbCrap9KehinGwwDrMnuvhjGt5cefqyaHUG+oQghj6O3gAMad0aruCCrFKOSEwNS8YRTPdVTTnW4N+nK8au6YOWizDIk+0A7MagymVWZJJNXmRyukt1TEWPqTA5seHWq7ybY6jr1CuHgB15GEx9wycvRLuy2aL2An+Bm9sOtToNWkpfT5Ctcfdeoyf7cfele//04kvXdk0M/iWQMZve7lFD9FezMowENC7ieO1f0zy9wOU7eqvxFykXJ2yQVJW8fQElukEjeoZDUYLAVZtnfn7rLWfZidU6io/OTJtPC3YPbgK9yM2jnL/BkTd+D1rRoZ/9GydcBoMhrcUUW32K81ZCPuRYg2Ojj92oK+mmoz+bMvJu8S5ac321NzG2aG8TpI955b4BHYMU2wU+t7wI8nldOyi+kH/B4A0vV1wq81oX/G+d6xitdSaBSqmvLgPVFAYmzOv5VLObgpBXfyOn/6k5AXNvo29uP2xrDzbqMifCY3ljEf+pqDlys49iCnaGK2JMnOVXVFBxc6eHM4p9M0hBHi0KagauoGYywCa4SMySi6nksA87BaxhawDMBFUKtsMkV9IOpbPxzf/A5R6UTvCrb2ZpRtF2D7dy2yVQ1hJgW4zsnH+LMYSy6NlTXvKu/m1+zC8Qpz3bQIP4jGU76nvFjamAAz9N03y5yC/OS3WBGuCXuuEOLjCVDKhxtdDmFp/0MtY6BhoWdWbsMRlDTroAU9alEyzSzcykz4laz8zqz899m5+E7F43yiWHg1AwIn8kZtgKGrYBhTUa+QU0wi8P5nl1hJOaF1JCRmWdcMgbSAs2wif0dl8tViyeHuAkmc6Ob2mgMwu/uOiCZY/cG1fNMdZspVHLnh8idHyJ3lFAls2b2/Ns5tHOz2XmN+bKobivVAahuK9XtXarbjFJO9Yx6Vz6I6FoQi5ANFNED6S4KuQnN91H4riQZGu9gGUb7UBPuylA7w3DfAAkMD5W6UKnLJXkvM16S/j6SNCOSXPzmkqT/VZOkr5L0xklyqiBJGkcgft0y0c5RWh6zzbC4NN/upEzVXdGaHCxnQUWk6uaHJT2fi3kGl+I7UfVsy+9jlPbUI0cLl3WGeBDuI3jvm13w5qskeBA9xxA3py+p5BceCG62aw/pc6zDbFjldg/RqjwIF8lwDM8Cbh8PMHRjV3YfAuHgIbCCc7n9rjhCBDeXio7CzuCyzNY+e1V2M4gBl6YkG2BuhZZYJZQ9Whl9SAP7L3QlfarmaqbL1NqVOCdyBRqnttDKzTbEG177vfaMmBZpHlvz3KH6GXKoeIk6Xbskj4UmrgbGwgbEE0G8dRDi7WHE53LEQVMmmxZw4dgMjiyPEICFSbAfXpB4jFmWMlpu05wQ0fhSiPCFiCkQoWelQcgoEQ3BegUxGQlKkxIxP+C+mwFuTeJg5qhUd8HDNLIwoAXzjwHx8BzD1NuyjlbQAQtHaHEfUFoao7TMg5Z5mmPy54QWpmQVdVdzXUqZZjOiqGY74wirMWEuFCEgPkyaCkBKhV0G0kzPLfKKh1mO5DwKhj1sgwrPEZqhRQa5JSZpdJ2zy5h4+mzbebOxy6Pzdxn/d+rRRDWu1SeneH4E+OPSLssKS+WKgAdZOx1Glvm0JNO+QtmYCpTntNLl3JzbOuDBX8j+PWBwcxyDO1TrWh61CIb4TFNoaYoSjMEk9wJcUjP+9caMvRzQiOcv8eUvdwIWXwVllyxfi+ipBA78dFGcBCPW5lhNYo38NAXH4RtYrRYD1/z/ZPyQX5VHTxGINtcyFiPdBmjbaLcmP7il7/Do4oPoYlczGSJ8paqF9SPm8CrL6N7NX8VBcryI6NFFriqXxLjyWmaKL1PpCvkuW6CosigmCInSFRCb3Bb0RT4Z8dE7WSVT9L6YyBE6LMchmFw8KvIrlbDEJHf4jQYIfNBYs4uuX0TXz9FVbZmPILKlfH6WNaj4ij2PmmEDjKLOBbjcE9lPRYxjyeI4ksoSAFefSghKoygDJ33hJOZ76So3Id41UpN9nmtE5911UFi5mujo0yu7ts7B8a6d5IDH8xQHP44hJ870plNf1spZzHBpZJrrMbBJdbQCF8P8d6xjWzTNE93OUQzK2wgiWa4XMOc3XIfLdfAJWaaCvFjeRZb4b3mUPfKYT6QDuI9doQWapaDfRSKE2QF/xzrECwBllWgZvUjjQ73YrG3qWCcEWG56ChM2BPcms5hPBDlRWQfPoS2uUaFD5HNqe4ub16OwAxFs5t+ThJj5ITnMUEet3NQyR8tA1wVdbqd8WrAgpfBy53cgzjYFXZG0ZipwARN+gZ9aN8pTBKkmLaPxZZrWxmcBnM0eT/mHPjXNU4etNCEp2MBYpkwiUyGdXFr3GHQcIJ2vHGFS3oHMh25z/6gzAeJIfIoAC5wLJeur6z9HMoRa6oeUg4i/hdKzNMgQ6ZQw6a1FbkNOGgfCeL+IRImwYSFpInTuhFvhJxxgYT9T3a2Q6/dYprzQZ8eR42zk50KwRW/2ROkmBERKuKiWVckd9FQ9IksHhoVYFeJ3GB8qv5F1B+Tkt5tYAW7rgmNEVlhyGvhpU0nGhiufZtyQtylDtzwwdgJdLiOlt/El0fZp+A72dVIHos5U0jiagDLV5OUEBgiKMzxeFOtD8uvi5IVNAqLEicQNsIl/1RhTvOU6yi/3gLJwnQNe/i/gIIACPxJvjhyUoMCP8M3gGgcVKK+jkRWcG7g3wFjII4rkYNbdJXaYY2dLbI1jqxLDWS5CTO8kW5ToJxFtS/SziDYk+rNe/ggSVWfyAdWUMf4D35jGjP1EIvXRdO5WIeWgwYr2J3FmghPHYiGIVBEfZhkf5TVf7uoWFb26vOThJDIgxM7xQzYHqEJ9XUpAFS82JfXdAYqcTyWRbWqS9wBf7f0HuLxhW0dRTR+OqOkfqWdpCmr63/RQKEuRLyp/HJ0TPfzwxxS/ZkxpMzv6Qjj28ltPyY91ZK+LesqbQvFeJBCfTA8bn4C9LCMHyURjsPmqU5Vsa1nGilXBmDPEAS9cUN+izq6vZ4OBavItVYSWI/nskMrniYMnMraC/mO9e2H4S4IKBwVlqcgmjv+uYqLCV6+BUqtHL+99xL83YrmHb42rh2+NK2KIy75nTQ4TkuGfzGgUIk99jWqb8FeKmKxe4LfEQ1dm8WjccxUI1ANZfcB/XOKVPm6T8cQkVU7efpO6atEKJenflU/APJU1yAw8gdpXM6CcrnTTK0/qlLheT1ymbIvB2R9OPRd2Zl237u7KIl9cNCiWiFdyOCFNGO4Xxnmg/UQj3WCoM1qnDF8tko07X8FoKvmdzCqp61gJrZzLMQxr7WSb2ywln88tRR+UW7yzswrSTpd7xYU1CtTdLhYFpNZdiRWZXGKDL6/USytLfWRsyO/V/eR3ZVxXssJZVinLVYMwtym5Zc3VUlcL4/uuInsYddGNEdtgVsjIKslliaAm4X4ryS2YCvD3kcfFNUiAReX3gIPeQnp3htxdpxYg/jBEPJwIe6msMUUhc24V7K4uaaiszlwgKToNBBjgHF9UUHtsQSoUPFtBq3txBcEj6IL8YaB6tyjpud9KZuqDuKmi402uMzJY2cWMCN6L2e+/c1P8BkRIEGNHx/AlLvumeZBhS7Lh3vZ3j+h5ye8DUcigrIj/AdKIYjX7WSQGuyQG33twGvdn9Tk1+sEplttFCtM//5Ob/ofRbnPUh3hDko7CsadwV7kU1nOtvkZhvloThZBvQ/MjzkcGj4yP8mFUMQfqShwCe5g8hmAwNIqpUf6OdYALBWreGHxveuC9Ox++Y+TenQNqfGpMjff6/gT2KqOVGKT+qXR6cbAhQ5aCPjJC5EUn4F9FG6z2KTpxsbqL66P41a7Sh8US6jQGyVsBttkRB+FGGj7elrU/3UfXdAF4paEyti6u/sGRV5iQJpiMD8m6UyMgZkvSE8ZnKJuwqAsL3zbVtp4pV5bhYVIWu6aNMsIFG9FP8OiBHQek2XJOlI3yqw6oRExUGXTp63bVBlTNT7w/rVGe3izfUOJXt8pmkL21WrF04gYQLGhYFLVtD0jqUiV4UM9NYAiBIrHgiIGp73DFzOYT8MbMkDIgMRmFRDTBRBsbpCE+vkU+3BnV5HWJI8G6m+xwCY4RRwIqYx1gBgDdbAc6xeibvlyO4+MXdiqKejZQTcnZ6kMMSzDm1zT6h1brIjdb91RKDdnZyXen/uNT76Ic3qz5sbwnx+t7QD5V94IM9/n/bCCLUcK6ek1QwkREQgRbp1yDGgJmC3lzkB+My2+IquRZrgUN65ZrnLZzyMT7iW1T63bbEjYM0WpGUYzIZ/JH4WaU9vIo7b7QPo7w6sGER3dFdTCWZEwZPDQmsFS1ORVh4ZqQb+c0L9K8UPM85dF8zqPbtfn523NWXd7hDuYycIvanG6iDvfGL+WsZrMLGUbDuLg5jjzjYczq1INvTRnCJZ6P6myPA0/HoYog1RUhwFirp966QqgM5k9KGl9JMxdpkqoImAFU1bFdxq+tiau1ntb2oenoaU1fa/pa05fhYuvYYGobrj7cSoKlC1oN4Ka01YZpA0cuV8VHgzmicgRKaKknLfVQgxmV1aC500iBcYg2KPu/rf/khfDyuuGBgJ4NTmx6tCCfm09S9FjHnGCcqQbUa8BrwDmqgWchKDVUB786Gg9BtaEOqBZiaznDgCYXy4i6VG88pQ5LZs8aHHCDZRgHuGOoF2dzyyB10OlSLqiQFtHxsgpqSQW1nAuqk/e7KCwOmUYICngrriWqQ1qC/KICOmijxM1WOaj5ol67sB7WyvGYBqW6sqcHCbLh31eRhMNicBqhoigvl3MCkIwO2FycIwxDUy1q5RJtnEaKWqi5n0SZVnE+XHoEBi4my2Tm2JRClknMv0xaSV1gktyNE6aKujRA84h/ZOvoz/7sBQ+RTrRd7n1AEW633XatQS1MxQjJj24dxb2L4ys2jp5z6dMfvC3eulqcXlF1Q8cSTrlK8cdQQ4GP37DL8tmPtTSNwNFU9kg5RDMArOIEROpRlRPujJ49Uxe0szRoyrZghpb5sc7BmXoxXpnv39zh8yQu6BPHT0m8jAZqvb5d4IJnEGfVun07RYdk52lplUGu3uuTw75+stfnOSuZk5Jd7/a7DJLlKATdTCBo4YUI91XMoPYEVJWGJiANn2bQziJGkU+LPfGV0+FpV7PlwtoUpB7SpEsRElSSKE3qYC/JYEetmGQFMqhF+bTUqRhmUzG/jFo6wCsaAsE33wS5pYImVzTRyG6N7pFAIUYhqxYbaMOzbVX9zivnz4GmVV47qCO3VrWfpeu6QyUdFh9m3VMrW+DzQXBOTGdTY8u26Cw6Z8uehZpbYKoHpm49yzZqYUxL2SFZJmrwDA1gwbOtGmgci/cFuwVAvBHSbYMTFNAuB7KWOy5AbguHvpXMltAnqDAWccYB0PFRpqNB2dMJimUSSU+qpGu0gKHi0ZRMPxKRl0TkBEvlDC9GXVq+oHhZokxJWqHmNp119Okfv+rB21tTsWjo4k++0cwu8WbQ8N8Un07KT/35N5Sum5V4wH/lGyq7F9VWCgoJ3WnjlYl8dFXuAxYCXDlhI2JwnzhW0iFClfyuZ1tRy+wEnl8AuAonKerDuWUINRv50Huipep3bx7x/9VQlWRT73MpfoXzOe3Lm/4tPjLaTio2XK3vIsQucGWo8fhlrU5onMti2RLPF/D2oBv3u/OoRCiJB2EPiY6P9ZBc61svlro4HZVikng95+MoLr8bJlTXRMJdTAs5nPRYWM4jjhzriE2+Khv8qhwu93vOSw2mm5ef6fL0TBds0Tzp3ezF8m7/0bCLN42G2jSavBz9q2GDL4fv5XCOwz+V70QYB9jJphEsMDTC0y1kHUpXrQk0bZdlzVoW/NB4Fcf08ftCw1AOn2v+j73vCm8jO9ZsNEJDAjXDueLOHZsa8T8tgqQIUgAIkGCSREgjUrQ862xrPcGyb4boMLo5zczmvGtT1KaXzTnnnHPe98153zY/3dHnW39VNRuEQDnbN0kf0en0CVX/qVOnqs7pz6mJOfP8ltIqKzcThB1q5a6a/1EjymLM0MZlljH7wFeCik6HZ5Dw3viVof61M37hzGfAVdrHNFw9MkuAO55i6vCxGa2tQpP8mTjI1EwQMs/hRXV+BFw0W/1hCuAwpFKhSx4T8KxHAtQJrwozeTWdw8WDAxpChOPpPA+z6QJmlQC86pKLl/tEtF5fMBotyG2lUro4oJ0qNDDL4pdQpx1mWQ7SD6+gTqwoHO+GJut/8j/qefhBTINia+jZnDT8mbgQybOmGA6rcrh1LkNqk8ZKnjQQozmQd8nLFubRxOWB1n5xgAUsHWj9GPghb0pS8kpjQ/mmpmshHpwMVavlrrSE/EnInyZXUBf1eD/E+n7k70cDhp6tK88KwzwTUai1rniYawtV0qzNrdtK1utsl+YnQYL48YUIao47GKoePdArkP/jndP66FTndJzVL2H9tFUNtAeI/wzrbhvoomkRCSRXRwIgCqGNFjoaFNH1CpN6XXBzVr1RUHIkqBohBNZyy3eSLivVFeBtXsdy3UaFj634jtIw0Rp0WIOO1qCm4viLmfdulQXlNOdwtQZA/lSx8WatYo3J6Y9bRZNtbLKQVQsvCtFEWWGmbemcjrSy8qyUIU17+2ng6SBmdgyQ+8qR00HEl5uFp4Kn6ODpUOL8wFcInaxyX3/cEMmnQ6elFW4R7T0CR2A0DB5t+Bj8GDkIoSH4EE1Pg1Avw0+L1Wh9A/ETG37iDD+nY6jkrBuWVpg/lkkQaRpok5o7QDy4r6b+yVNhRtnbkVfoyviKIJYmfDFhe58CMCWo8qutqn/VxxX/WGVVfRxstMOupCUAyTExDwNGM+f0Rz1HpT2XM4oXsB5tPmkPw6WrxXcV3+2s+EKoOtvaVlIoD+EFKA+Xn4ucRImoZKlmeKkO46Wb16TLmnS/gYixKb/nXMvGvCWfawB1mX3e6xe+HxGj8nEBdVzEzOTfdKcMx+gwV2OyScwJWv7sUVizXCb/FtO4tnaXOkqByaaUb1GupkCCQVewJr/rSpjqKLqESVhBmeDC+uP/WpAg0PEgqxJksR6HQSZPAfXjYe3h0RickcdWyYTVZSWR8saH/+wjUuZvHqbgXUAPC0eHJCdJKFLhzz4KG7z7gj2clUeb1kCqUJkOsMzR/wrmkZw2+isFtrAqv9vYlN+r2JDfa6g/PhNfCNdNjBZ8S+QiIbBiQDJ6lYfoVUVVqbUl1MI2rmGFsp8ZXB/+e/xflJYTbOLwn9xP13EV67jO50zlv6S7ZDZRkteH/xiltuIMyVVGdkBVGXNOxIiND1jFBqI/Y6rg0TGVN42KF0hiZVWizErNGM5pW3mi9LMHsr8A2V+ArAy2xZ9NiP0FxP6CkFUQNgSCf5vwEvBeysKm8/m9+jaHov8uiS5DzYMWCTo3Z1wDhwXl0b/AnHpFGjd6qB2kkbAk5pUYaRrH9o4GJtC7r88HoM7JdomVzG0hYDZy736Y77/JwwIaRNocGoyfW0SPIX9L6PFqxjV9mg1CzMMOQWP/eSkrffao+PJ8KuXMCw36DBfRQPKeaWZ9e1oNCsLvGZsba6zM50IHC5hDRUqTgxgMWb78ypNZ0J7Uym0UaRf6mvcTmimkjIak1TRpXU0UZT54b9rUi7YahwSVgkCcleNEWLcqv6BiI6EVM0HHNV99h4bq2eEbFfYRtLWbxuzemdJN4ArSwIA5u0LFT3IkEob+nXuaetJIS0+TfevMo4008kRZO0OiZIPesLZdCFXqxkbrptA61M10Fipy/FcVabU87xaNOw2o9e0tWpvl8P1UVllo8zbFh97SD7VVCF8hJarHDV/zcOoYjcGXkUU/DjHaY7NBlxo6LXx/KrZq/i45cqrYBXe5VQJPK4GL0lTE5Jh+6cH7qQSYswotdi3jb0dZ09X5ZA6BWb1bl/yYedVZbbESTRQfiwQI61LKOupoGqGdiWHFiRg7ERMU+cUBzslNpJcmNcQC9goSOx9mNjPRuUjFWxp7SxNWBtwAvcIGdNnGFUVGk5BoGiTskxqosssJyazjc17sk+m2EJq3+D7a/GNsDu/4xC/22RflmiX1B0k2yU7U0FN2Ks4K8AxIFxxnIVIQGtB23IfS096tY0g2bVojAipuHClj6bhL641EZY1eu411Vp04AZbJWk0T9PiWpaLRVWaoQ1kO5xblfbFpoy+gI1BHdzQqy/GdiLgy9nfIfmf2tlBum7RjWdWc2Yq4SoiFKYkyOGFyxMra8hi+xjJShNi/I+A92ZdoNBnHsoUVEwV1HBdDW06WEZWBWh7g66EubebTVvbv20zduFExblSNG92TkpcltpWzP8H+psBvS1Y/keOAfH0q7ySRQWmUdxSo1RO8qz/Ju+oJ3lWhukie5XBu1SE56noDVG9oKu8imNSOzWREMWScEq6tCJl/IheycvUjeoXoBHP4cAvlIbLHIzTPxC8PkceeOs3Z4cyexBuwGz3e6GHiZV65T4UR6IUHoaX+nIu0X75bEqNDb0h0POpG7lkIequUtm+NuB4iH6rQ9u5pJgQVUA1UVDlQA2yTIoMynIB6Ii3dCCxXTsQlE2NWWp8OCQXWRX0vgYHLepueGfKDf5IkGjC0Zc702ja6/JMEcrvBXdVDgh6aIBfvq/6JOepuMwMV0s6CMesl/4RR3Emd67tzmKF6hZ6BRG0u5kiTJp9wgxQ0rtoYoboILTkq6ptM0syskG1f2kD7o/gGnRloDb7e/Gh9FfxoncqPzlP50XsKPzon+dEjP2ZH+PHFkX+n8qOHWeVH50l+vPU18uMi3iWpTYEtu7cx7XIxTmKLIWYkuUdABx36foOZjRvH8xA0Hz8X1sdNI1BkM9j0hre8/fg5rMhk688X+vHjP1rQFpe8xU+bAJAUsWn+DSVFV3TWPgdr5W//7bfEiS2X0jI0KJNiNDU0oYhYqW4L6HIVBdUTtnMqNSSGyIe2elXT/mfSG+gfaBZdm2JQqQuaA8/ojhWs7eGGRjnuv5HedLy+U+CdX1OwJ58X1yWPP5HL1p0a2jjzvkDcPLMfGsTXfVWAbqIsWb5hGnoblX1UREBbD3kw7GFweyyZQCetpLQlcwMQvnl8igHZNNLpgBqonQLrp4IG3QfhJYVJuIUqd7a4pLFx4bIcyj8QrpCHYVunQ2FZKrNbzOYWu1hmtV/is67Myx+IjlBSwFR4pP5YYgcPycmJeoX4QVd+t8ajKJ+8l5WTiaBIhnBBEbYFIE/iycaQ0/GUzyRfCLPH0/uiW7RjK4Sa2wGpb7OLHD0+cxRJ4DlwjBbmq5i6i93+BYHeLHvXLOdNHv27aHRChEXq+GSYZJTsysNKWHLVt8BXJvhTPUhZGy4ZxKJWa44aOF9ndcK8VNJ88NzkShz0Vlw1nZHieDaJedWyyKeGvNpj+Wg4Rm1+yKcl9AamOzRNnambOtMxdablnq4mxeSJ2Q5EDtNdlmsf3lFEvAnqhaU8ebsQtjL9LauyvJMmrsRt2fwhXTH9gOyj3pYnWMfwIwGqcQCDlA1Xna5CtlQy2dbYG9YLZvSKnUbLNuE5h5i19vomrGjJQwBUFvnlpJYTjO9pbB9ARpchZF1lmE8LyVVCWX6+Rk6+/fOVk29/czk5OcpJfueeuReOGRg5u5i9cqyhXFE2HDjrZsiJjF2tsR8/XQnrFA98K+3wnZ6xdMZmvs0xr6yHFeVwZwyHm87hinG4e2IiGKMTyqirbr7O0cD5qwpKlDO3YcY8ZS4SZdqWz52ER6gqs5HdWslHCrOL8pAMrROpC+64WL5JPgm6jGtzXozw3Rjgk+gGid4Y0ugXsTRIF11W6i2OJCIXPbIm7QodbDDrilF07ZgkXW+ekgLtEzEwqvlg9yA0Tbep2Kysbv5TDwVEA3WUnaZuT1J8VUKCECLnbnk4qkdXrwfIUT2PVVPJdFHpyKAa4iH9wj2v6CpxtP6kMceKdF4mKNr4/pvS6kx11XB41YuLqGY4bLAGAQs6Zk2HRg3yZjUP0eElV556/E7LHMlSKQNbURNMaiqaTA+gBXPxtehLqA4sBPcyJ72NYcNZWLHofFZnRYpP8sm5NM04a1XpmjCkStGSKRkHUQ53xTvKzxjdY725LuemLJcROagj15QfZHoOUXx6xJZDcoyqzMmovu95Z+FbhVzlUbbUmUHdoatCEV2f3JN6Bc43pZ+TeG5XbYlDPMxiQU7KkpxvNyCHrlI19HigB4OEDnNuW5KCj2fNpEmSkzZdoThU8lZIXhK4nhOYD2vqRLcgEzd4RXkMT1GtJ38qlpR/q+RX/6oiV/+qlAlKtWzl1ilK3RcGKh/9Y02PX5XCPiqg4U/Mn6LLb5Yrr38+9mk/prLAjzn00DtAheBp5eC5QpizDr8rVhbZxed5MWkQqVBistgZAqSCpgGE5yNcSxPyTYeRkxxsOg9N1LR4s5WZ5yo+KpN/EVoqc9XptGBzQw6BVGhbxrCyMSwxhtUtxMDYxtEtJndHGZWQUTFWiO6TjHLb59+K9nLW/Aey5n8ds4ZX/yG7+luxM2qYiSNjnHIcMXnV4g+MdadzLRNCrEuc1aVuyzyTkb5+KWPX24lwqAW7+F8VuYBf/AdeTPLCkeV9XXeKabEmPTKyzll1bIysk5GJMjK2USBjX+uYkcjOMuZmUrPi2zMacxvSAJXmeuRElpZFX4KFug0YrjC4GI0HdvcW+pIHdmw6JmJR52FpZANETx9wwezuAH5v1u5RMh9k9/ZcVs8LuNjq2EVtMxO1woAaYhG1CloFWcsVfqbyKQD20MoCZlSgzFEWcA67pFmFeR4mw7KFLrF5dUQk7FyoUuwvY0nUDswNMH+AeXKPZJlhRKC9mWg+hM44PSTD4IrBz07+lZ9QciSwEQEtrdaBaxpV/yJlw1bt2GiAqkqgXA+MczVvxe0buarH/vAkIKtyFar+qUULSfLOVz5WLpmhS5GuUG6ke3WYQwd1yaWuQ06oI3aKqzkwH0Or5EwFy5gn9WbQwlLWwMTpxx8fFSsjNIifJKhZpc0a7UIAsZ9kitNIdX2cdCU3a1IWpzek/swwwQzm+GQOdtOirMZVNrJ3Y3H9IvZKl75kpbO6jqmohm3NoqfSP42nDbdWeR0C1BKzyH64iBYJ3wJ7ho+b7AqF07rCL3SFt+Mv1RUmf852Bbb+Z0lXYEW/tq4QW1eIrCsQ6g2F+mhXaBhdvatkEFaiMxS1M7AGJgdIrDV1dKTklupRHZbZRSSDbob9qmE/+SqxT496Qr43TmIfddLIyDZu+r+iseajcB8Gqb8Zj0I6twUMp868bt2QoMtWVkMX1RFIJwbphBSuMm+rpVGwmjXBKRhlQ7pX8knyeAiAL2r3ark2MgxLZXVoeXD8SVhSEBAxMRGTTBt7R4FqMFXvubHZgMqKnVqr47Br89F4AAgp0zDM2dSZVdpV82y6TDLFO9SDdnHzjdT8i6YNEXu6vj/K40X+VSGNfeXIjqpKHuvAZSKKYoOsFIco/8oDc+G0VSMNTi5TSuv9Gcjf/jR9ER3E6kasIFYXcNumuh63nna1+fquGJ7O+PSSPhzbTcS1Wpo46Atuuy9YkyLhu7kv8TTLxU+csFzQN9v13pw7eeXQRlURp21Lo2HPo1HPXY9qoJHrONXjb+D8WLfeiSb/ju4IcePOuYLwLOCsp7tp+7LE6jPgJl6pOXpx05cI2fqxK3823Xxk61HTNaxl60jXLNY5Td8phD1j30tWodAnA6Rn/YZ4QJM8vl0zktWIWUmEG/aO132lvTekq00c0Kxg9gM875MuWorQI1JaioYl8lXurBl3jgrcunoVJfQ078m/y6aGDUNQmLW30iWrWNo+1rsbBFNaEVEZ7/QjM+vN5IBJY4VMYq65mTvTckzQG2Q7ZFRRVudb931uDjJHDWc1YhYCw9nN3EOTZd0cMeaqMue6RFlw5o0Z/u1PD6TnmiEievzck34HcxQI3NR9RRBBY+d69H7Q5cUIOjoufIafmFSj4URBneCqzhC3H//lgh7+YuHxny6InW266GEfchrnp4X8VLkwbm5nk0yU6YJh8J0kxbr8fE4u5aLAi8LnHl8o8CrmVSxXMa+KvCrKVXHIV0LPC10mE29Lg4f/3I/i8Q8eR3G6OyXfUKpj7jly937ooEe/VmIUMr9clfmZ/JdTEqqKNuUJ6m6crBzHIZUB9cPQMk38iRRxU5uFybxlnZlEd4ltYXGNzEHTzR2hNN/QNiUX9HTxol/Og5yceaxPN7QhT4ftLHLXnGsqlXxcG7ImT3G8cklozp7ELXjtcTbhsMIOtaijliuRtZHiVsyQjaqbt5k0LY9qVKN1YKZll2ceOaF1yubIU6pk8lCBNJ8kauhISnfq+3xAcCKUzQLJ1pjObUws6yighCD0bSBnFd06tJhbTU9vepQ1OqIzGHHerNMjQFQS+xhXNpd22deI8BkjLT2iaMHFFpdYzhsSZ7X3h2XrvTbDZ0VxSSWTmwHmXdW5bGqaTT6MKnxqsYVNNmAOkejOA+KKZqVmTQXa11GWqbzkEp9QMTEqD0JjjGzraC27WB4MSba09WUIthYFWycXbI2niLTOzyKRJiV9vaVaCx1KtZPirHO6OGsMizP+jkq02S9fonWI9c6IROswZQtLlrsCoa6TAZdt9VNkWz10IU+/BtmGOjp7aN56EBpDYq57el9vfwPEHMW4OiKaKA87ItpftvSrm/TrqPRjm46lX0XJVNVmVWy1Qi79qiekXxUtI0X3CUEooikkaB8Lw+qXFoajojCsGGE5qx5qo1wPC0kHsRPJ9qczWVnJLaOhrnXltYs0k6Y2VkW4LBktSi4LFl+hDi4qsai6breGskW9V//r9kVb8bAKYANrR48yBRa+ncXhUQpAU742zV1WR/2GBm8H9LBYt0m+SWeb4mGet+ZVwGeewSXpSDoNuiKzGYQ31FT+a6j1SluCTchfwpWDcFulKINLqZmH/XiHr0i2uK32yEsUo/+mwG07XFVdvHVMGirMkeTCV34oXaCiekWyrd6XCh1g4X66TPG5K7E8uIwrhIV0ennAszCQmdlQCM7mo3TVNgJhbm9MpxsaU3mFzq8mFnwfzzCPFHt/9mFIJcdAUzRbIfmpxaiHVUppztVQ5EwiLOGyGgv20RLF14CZcleSFEixBLnqklF4mK8cURKQ2roQZAWdEGHeZYDByoGUB1zNy9UC5lX+Lej6F+pjQ2Fom+vj90VA1aZtl9HCJZOFwXzeiVlVFGyJ5LcZgAqiNLFG2LLOVH0rvrbmMN2UdoQ1b0Fp14DLi3ytzzojVk8JIaI4bHpD17GFbVyVBv+UTxRz3eMriERrEoJoauRQeThySP3CG1hF9Ge52mSoB1xx1GffF6hD7ilp2ABWXyt/TXYTkj/IWpp71/O6sZiGDVwWfpR16BncpviaoWcCy0YQ4+9uiDEXoqfxd0eSLGN3THzh5pNBYre9o6JH28MsD7Po8NDJpseLWivB5j4uhTard5u9ihGboY59tNEXkJii9R5h4h3cxk0aP8J7sR8WcDu8LKW/3C/w78506NnOhVLOPu4QIHODoOG/n4/TX0xx+z7rvkfSfeWyXxzI/ri0U+jyB36eQEPMu5wHjgba4H3o9hO3b8jbLRWJPNtWGynP3kuaJ77sukVF5SAfzzS74YE0clNY4gOqcW/MsAqSCQm4dsFjA5yhaFqurOLZiPESsGCGzm6IsmhOaR+T0pMupJ/Fe8kIIccEN0ixxiykTQ469278nnPDf2F9bJDKNocieWvJKDUmzXa4iu2wchxA0bXRo0oDHTuyKsMjFEq3NIokXJP0btylxqsrYhZQ14YfGN7cVJ6uYz0f+lHXGcCQsxdlkqxcw1VsSSLWCdd4sq2ZqW0ogRTjzkO+2NB5Al+5yqyfIInGvSgx0ZkO78cs7qid9QN4DwRtH8QMVlTf/S+sF5p/VvopY9wf/3eTGe/rf24QbspBGLwnJFnC+8JlH/g/aCH7V1SqbegocO+cbzxOs87feit8yA4ftsOmMyJKb5Gil3BLIJ1GAuowg/fRu/4RyYop7qbLui/TqjIeV8w/0aOpzmT8MiukxOZ97IUEqwHkFXOI+HK2fv61tDwdwEBlyEnPweraBVfUcy39zAmn+6KszAxAldrCR/N+FbNfXbIlB31qWWGfI7P0+h+n0JIT6dRzBtFuOuv9bd1C5BqIKAnmeUsUFbmlkoVta2oHVZCxO2ddOSQ0CB5HtlXI+gdSToU2rgyJZ4bs1ok59WPvqOWn26xzmSvXLMxQbN5KdDDP+nXNBj9rwnEDOAofExIE7E7Lm8vejqS/k3vzpVRmmFvRY15qnWiB1TNiTW7bBW/H2W0+SSwLq/x/Ha65WodDhwSEbobnOrfcjPlAx6gO+e+P5GLuvk1EuLFlZzQyWJVkU2U+9mjklZTZpHcPsWwTol+iQP/4I01+GD4MgY3MaB3jmw58C23r4NKuHubsUJYDOw3vaAT6fhrzgZxrQ4hrMwz8iOq8toYmgE0phQ12HA1UsWgXxNN8of8jcpKttbnLauzISuInXrZyLbADtokdF5Nu2OlhWLNMQ5TFwrA0T8hU/gITaoI85oYq+xpi9jZWwe4mWTY1fZJuZlVDwstXsqwfHmaZa9YqQPpH4HOe8fnmQznd6T8KqSWVx/DjKw812//1t48Oh9Kt6mJYHPLxBjYOHx76LnWbdgyvZJt9FKliCVyo629STFgCajXpRvbFhAKAFNBErzDRkbbk0SGTYeORpPwdv/1dfxN2eH3arq/DDq9NP0yhq3ShByaAYc0OAkhwJDdgj6tK2KiNoGvDG/Rq/lWHj9ktfNjytoOU9dqj9HV8CHcfpp84Ui19sn+P6VfxMXzcy/iC7ux4pPdvosdNE++Rwcu4JyCl8Be9N5TRD1X0QkVJVhXJXQ6fRCXdIYl0ttY1sdpQlhODPKzikxRqZcSaESIeRILSVVHFjo2qq8Rigx22SxzdM9eoWdA/JSefuqMOliouQ2vW49UuK8KwfPafGd0dLexyu5xkuHg6jCStRerGPpVMqS+X5bnhluVbocpavP4I0uM/gbtKXztw5pduUEh/Z/odMmi9cDCACoOj9OP4KHhrKrv1kKz/G4c3//k/+2ey0+aa5cIDc+E1WcQD2Z9+VE5u3yCqftcO2Z0am1ep+ZoOEpts9/D6HTV9YfdlqrSXEbNELNuRA94q5E9gtVrLJtEzJ9aCryK9R+DLCTH6268dIT1MX3mN7GeBmoBHIawuM3vJRyjOP70WwWoRvBYfQSBqIq+KHh9CsxwZOW8h6CyoX4b8id3wO/u1Qfpd++G78Z0ygoZ5yXz8oHnFBs15izA/dbSc+5aNlnMk0tzIaHkL34Xv5jAZCMOAZXznyGj5p+Kv12i5NH6wdKlB2tniGbu2olWvpxWCiNAkL+lIhEvvI2NjVeuwBvkTSK3VjpeIBMkMjqhhzDm85ED2F/SSx0BSBcwoWbIq6DQG6PxZmcFL4a/Jf3ak4g9kfUsv4+wSr1rXsVSl7LaM2l84SkHJTHUXn9DHE3kHhfbEI7oX9UeTvTbtg7j00CMXxjYXT0XqinhMkR6J+ecVE6W+hzNmPFh6eAGrn2U91S6piAKv4y4u42THeGjmEqGR+z2PJn/Hb+TnGFYPAziW/lkZzH69jhbZOAQ7cHTBxhFWdcR2Vrgum3+0URr42W/75ToI6om0NAVekf8QFr1Sgwgs6fOPlEwXMjKRgBxsfHmuNPUj6PfjJ3r1Xb4uidA/uvnd3/0HrnOwXNOefk9Fu7+PPqHlbUk5rEERAnySSPgkMeHLmJl1SJRMoewDhEnnhCUK8rRVr8hYTkUGn8IuMdq35t+z5u/SD8KJ2ii1wcoVxlRkhH5DseywDY99lAXAHyE86fcFdoIPYInwSyN8aD2eQIQPr8dV6kHrcSmzLFxm7pdxk4eb2ONhT15Tz/H7VWAssOAFvEwqvIw7lBt33ARx0utut15kL30x++zWeb1JdSvJPvrwj+JiWXeRJVBtQ9eSjh9lwSgPFt5FC5V/08XsAVWet1DScCjOVxM1iDOH0sGt4Yh9vmbJq6joC5J88u/RhpqeAf3mBALjVpjvmaEPrb4qLOAX2vnh0S9K4MhZ8oRVDCV+Hkw2kuMyAJQ+Y/vWEI9n/MVYO2A4w6H9ZJaR58AnfNuarFmEsuHwDGX2mXU1qZazONqsbUZCi0pD6dj39kZt2dawvjAmVuXG4w/R0S7KxYKtuH2j9v+LpYru0lv6caN7KS0a2UqZNSH7j9g8jBWbWGgd2Y6yrhIoisxFARVqOmUF81CiYjZtyb5IMRRFjCLfP1cwyXOGl3Z6VgIW3XDAM+YtaFPqyrPC8R1IgdNyW96t8nDWgo90VpIofnAWZx6iZPRLBjLnOWtJ7qc1M8kxK3bc05xyEyijRquyJBOeiAHvHM7K7zOoilPuWf+sUwTusvwsJujN+qkxpsuJ8abLiSF/lvB0L68460iCojQgIVjRMiFCzhAcOKuWzHx/o9xD9ZZlyJykAzGfEtmkSKl92L+YovshE8L6jSNZTsFiEMvJZwL9H1l4Sv7ZFt7jixZENOBTj1qp/eFCqWB9+Cetu0leefI04gspK2CdgnFtLEy1MIKFd4bCico0RY/5lGGBMV0mZLW384Zk877sXqWWEaFEI97hIfM9oUWWajvSftYqOo4Yj4Z31i3oBrXP6qlvselXPhWv/dOp56beKrz5DPvOj5+RVsf8092vK3LG/iTXmm2UFvlDicNL8KL8mVRlkHos5IJzWz68wCqpMJji2RmtFs/O8myCr9aE5LyY5MUEP+40QTfIuUH6DIrsv8/imfvpJMH6nH6Xt//2m3iWa8XP+2rsdOo+pqiE8YsAsjH79B/ni930eTJz6o+/mX77H0xfuM/Pp97Ar/mDsuY5vBvF4S21pfT/UUincd4Xn6cX8PxB+qKu7aZ8j9Wpms7gnN0KwEV+WOOAH14OmIYcUrwouhKmLeklyIuzju36kH9m4s8+Sud8fjihDpp56XYLch5z2fPzPCzigunaE/TaLMlNOSwzyX64wrfuhCbOZa6cFon3gi2tepPhZDFDvcKKSmDe7pAM3T8bVjEnRa3hgvTwnmQ6uR/W0QkbuoWMa0FzqHhs2JFHhG1i0zUjnmJV1J6tdwrptvuI2VHCVcfcBrbZ82q6PBk1bJvp/ZpI3uuYDjZFfJ7D0YoVdw3XSdHzhOBoSSuv89jGppTmuyKkfXFZ3ejbdvTrKtWnSH3W5F0CojuI8IIc9w0GePcDjnzoCzd9465F2r4jpHznvJycvzPNof7mPs/5J4Wcl1eeR5/gqsqQuv+GChNJch5lvbghZHxpjOvnFpbDeRWbt9CTOIF014MRzNWa7uEl3wFujxMDlabp3uMZ25sVu1kUg9wqHN+Ks1vx8a1idqu4njtnPdDg1niJfAvnKZHPU4Auhylp37J6Yc5gEf0DTBmuRd7mbS9JT+atWG5M3Q/nweDJqYNMVEfGshs6LRF1bmRJYknrhF/EOp0nAFm0eID4YAfXiZ7rqOl4uS1GFVxBB1d3ZX7IbfoI8TR+EK7hKv1EaiYUSBmu5F7NcHVT+X9xDK5uYuqrwtV1w5XhFS9iasCCvjJ0BWLrGi7yQIRHBrHz+zznn5R3bSzEmOTnCsSuj0Ls+peA2PUMYte/LhDriyPIv3zrMLsaOtRAiCjii6BqShqiz9FDX60A4TaoUD9rGJtSj34h3ORRtpO4SmxI7aZxHRfcEx7KLv+uMZOy1fo2LtJ60M+qHrYkwblbx87kCfObbAmjd/XbAi136+2O9522ArWxlpL0nPnGL53wjW+d5huvUQdhsefdF06b4Xl5fytsksrp+dwXfkPq3Yee4wbn31vYlK7h7Zt4phwXCgUuQQNiTCiJ6P7Fjae7k4XwWbNzl/GeovzWGJTvQgwyWHKC7AnWF7CG3af40HfHY3J3iIBL1FexpATcOeFDJ8TmMfekD33ihJYl01nKrvN6CzW7ORPKVJGp7jyjPvFJa6Dx9TnJpB6ip/H120KsmUziOXXvX0J8KlPVRfKsZK/lEs3Pikgkpm8KHH+avK+AjuNI/t7uoZVmVjuSpUSJ7LhmwsnxhZN3/iYcw/dnZvbTyvesMCiWHSa/YybHf4ZjZmZmZmbmUP2qpnd6tesY3vEZtmcaqquri7p6ZjqUFaM0xrqyRV2MTyZunQuUyI7ftPukNd/rHXQlT6Qu9HmIzTvm3hM0A3zlVLgeZ+3WbYl6418zxi4Pn/9u9PBJOesdRyq+8TaX+zIv90393Gd5uXqWJXL/zct9szsYHrJZH+KM8/ieLPG5Vr5L1uL9g+dZCOqjTW1ztKl1R5saObe1Af6SG1yXZwzhUeXNaZWn8WCdZ2zwI8ANA34rAGuBluIaZ6/nTxXE7qXpe/fW9L7GDDZtaVM5Ao4vULvVr/0oo9UNV0KCyLn2BXJt9qmlxX/qFf/lcPFGr/h3h4v/n1d8tl9MOITWIfXgGiddpttz5X0GlYz+CaGWjDsK2OAo4OObhY5mtdxs2vztaIEzSGv4jw1NOMyGaP1wW3MDXzXc8HALbniHcIOS9g6fqbbbFQPFssGv8DUzXOFjfoVPjajwLr/C+wYqVC0VYJTheObXmXlZeKF6AEmiUF6TaFpw64tBvc2gmbDu/5kVDK297vJ7/bcRaN3mV3i4X0HhbvfgvrORwou9VpcPNfqQJ13vahptdI2GmUmW217x2UMwT2hA/niHE9hjhjJ9gf3DlbKQeeyaD3NzyysOV3Dz7N5F+d0HrgXes7emf6FNPRESFqj5xqJNAGAwaBSAW4IGfd0GDDj5R1i7YFDUfq6wTxuCrRvuAWsANOLNTpu/b6QGWG+MJ9RWZxW15OjjNjduq5rWzLawgm10t+2zwn7q0L9inKmFEzdbqjv0NG7gr1wSYBjoNWBlw7Eh//B1qwwnpWTkhTapCjEK+TK9OTDh8LhgvRs6BYpq2KtO2FLiUQlX1CbNCzfUeRHfLlQb50vDJDhhK9/xpeqNFnefSu+B9p5ZMPLrn/Lso39HztcMOUJUchnKee3yOi7gvM+840O8OIa/CPp+SMLMISK+wb52GGqHQJYHIyPS8Qi5Nm5hAOJKK50ij07SDSMcHmvbJ9etCkNcSfQfmC/jxAhsJCESKcs/DEwP1fBqJFEplKEvEN7jhm6afwR1W+k/iY0Z/RUYnQ4NKAMoWCGbJ5PfIrtGUMip30UmNxY3peCnXEytOmSncXJTz3CvBPFYvkEmx5kgh5ZnjeQzgG6r+tEOPloxv3uHoP2ydmS2HcRH1QXL9ir0I1Hz1M7W122+lv6PBQ8JF4Ny91HNegzuyC7I6cpygjyXPUClQLYvrZycz8UBPjuJ0hMwtv/UpyCrZL76kQSkTrJn6EcYwOoL+UdvYuTEg3wbZyFwip8HuAJsGSdqGlxPdUlbhWxBRe4f+e5zWqfNzBlo5QhLSrKQtS+o2yhRRqXcA7CxwTDc6ZVpj1JKNT4IwjLiZcColxm82g7HCcP/LCd6RZdCFyfMKcYMTGrA19K4HGLI7aZ06RMwJeYLDhhxWkyL517MUEuO+cf1QZwF5rKLxcGUScQuWCxmVWscQuPUwdOoelQd284OR+bmGOinWhcUOOo32SD7MYvY5IiAyBpCozGJSrCfdAHfrqGYphY0jwMJFNcdVmsuvfBCfFHnMJospuiQ+knKMSGJqKPDZK8joDWFpWlsRmHC3BFDetBe4Jb+Mbwy+UT1NN+N0XS9tLe9IqY1MnDUxoGvdoEbqBqXJ6EAKhRQ1FFQywoK1jVr0FmtVzykpN6VCajLJN6Ag7A5vUDnjnKEXSY581DiOjFfxBJhuQBX+M9aapUEUQ7utEYsLtfKkmvWDZjmaC0CKeSCHgHxpW0ujbvc85tF/ksSa0evRNd6JJyVpeWskDBTEkaUCuECmqqJaRU9R0JKdTbCQRLSFOIfU26ZtoYOwrakbkbRuNhNTDpDVFuNgLDatUB1K4RL1NFX7P7Yn/CSIftThpzr2Z/w4r1YHHRgnMkJLvFMDoQMfu23oFAao/OpIaODXvbLzPR+9gbm0yMNDMR62MB8Rg3MbcYEjtbk+TBKZXSmKIXIwnHfFp2xfhE/hn1UmZSAQnQH0mAo+WfVXWIzgae4TWa08/xz/fzCOC+KS8h5Qd9umwmHzQPcWaZi4FC5mhalm+MnW8CvMFCIH1Fk09iyMXq8aARZzL8n8yTa+2+Vwf6U5G5J7y7Wu81qXPKSibyg1yeU8UlQ9QJXmPgku5Vrfw+aX56Zr08jo4R7FcGMVPMryJuM9rCd0+o2I41C3irSfR25vY/0w9pyvjZBhwrysFAragOXJwsT+GNNKJLN2DmAAOqPR1+7uC8evgOpCy+Blz/nBs3BSaWYhSX83GS8qq8bLAAn6+v0c02dd9V1mpyPGfWWUFd3GS1f4efyBRmsQitC7LqHTbsvKWInrBjtQhU4lJSGd4CWetDsaF/oOiyh72AsxhQL6HJdGWJ3j43YfJGqZS+wFrsPFJTR/XIDXdnh5JT5YqLPXvdZcPMO61p0ddMeilrt/TEUikcVaIt4AeIYuDbgalFQfwmuuQ+u/rbIOSuDcxNQ5yRLnESQp4CCCrCOwJUsEVbjSoRrWq7u0xezhHKIWcoXqECRtKCOgMi/L8wXMPI48DSB0AUQuh/084sEQsco/aWid52p8cP0CILjitmEYtFWBKM9YpKIL6CqfIJ/8h+KBhqBxI+GkODeKcRJyaEL2Zn+625jyjH4fbhZEG5byH+yQ5fpFiE0UbW85H2ShvPyHwN+EWroRFZQmGKNSkTqtUYaTwFCD2hW4A/7WSpA6Rcql2u2kClJFfo68PN70YEH5PJ/8Tbf5Vel37j8uFnh8p8+yuWvti72DsDbv9CYbWTZlS8CMpDXDOYTXr0QgmUMpZnmW+4ReVYrWqmhzWa1/rTWn0WG1J8WemsNKzXSdxjTHo6nucebLIyCVUNbRZeUoR7/yFVehecb8i+p7dPlcCzL9CKhpMYOa+YAbgX0O/9XL2AdnOHaCQgpyb8sFI90DRCrxROBJF36M7t9RWcaneD2qyobIC1WOX4kKH2BNck+jsf649mudlfH4aNvLmnMg64UGLU7HP4amfimyEyEhQWmLlaulSHFFMg1Z4YynkhRcHiwjxX3ikA/KCucTrE6MLYWFrTIlBKACEWjbUFwBz1kFkUnqCdJiETK8m955EqUXJ778m2dwvcbEy1D/jQsF+RPu7kf5whVWsjKx3+KgAVGciwzMxzgQE9CDXGb6xXWYEJbJZUepV0m8HcNcZLo00ho41YnakAMhUhC72mjCIdoW3HGigT9p2I8koGViHth27q4UgBPLS0x9bVbCobdcY2MVsRaVd6QEB6Q2vjakNqIfLURrVAb6CVYFjdPNYTTkmLAJdrEZM2/Dqi11kRT35O1OkbO1cmXSGZbkxAJcHlAXzmF+TcAbG8aSemlAj5Ir8jRa5OL8EuEzxQhz4YwroquCG7Bt5yUoc6H1DB17M+gwNQTNRA0bLugYba3oCGGemAT9Z2hibL+RNmhifJJ+F003k+l7rNgOEhS60jqb5q097ppoqN/g40Mx4Xw31/jxSrYKlZFIl5V0Vbv7whtSxgrDLAw0PQoEpZjTEQEkThFcAcOTM5Jovud5HvUDGq1RoIajzTiOIwEe05Qv/EYdRuPYK+xsuIABvrkprxCEArXa2QtpRhh3Y9JlHWcsvzjuNIJOIJ/0Be8xgDbJhx/64jDpyogxPsKYf02LGDqNwA0cIUghno+FPsbBw/F/FqVKLGas2pDcwpUm4dI4J+pR6LRo0hFLlSRS1TkAqdcyUJZQw0uLJQaazC6pEm/b0y2J/s0O2ifVm9x9ukt//bIN4s4/qSxtxzdQZIXCZKsaKueGFOVPa62OKXUGTMFGCAODEuRiT17MwAz+Tg5QsxZmv/UM8eIS8n3/GLxidUsr+6b5TsGzfKd92KW17dqlayCVYfUH1palTVbdeer8FLcZrKdLgqaFQVTEP9ss4xJP2fM2J4omO+VgtfsFAoqzWKlWaI0a48g1RgeYB1JKrX81+5Uyx+JbVb/PcFP3HfiPYJdt3OAYNfv3DPBrjZG4r0co2RK6OhL9er6riHzNTZnnoYGJZdkI0XZ6tsqhDSvU6rTB5BR8SgVMHGSk/nZ2MS7hlTtaj96vnooet67N5sYkO1V/7hFmgX53T9Ly7h9575bRmUkT41jVLUav80EUMfBkHkMRRlDeKZ5eaa7TQFF/Zis+0x5TCFqtI+1UiWhEIVgJZS2taF6lxBE1Xmr+2Y2Jd1h3IHxpP9oAt+oHPhWXxk2m30UwjjbvhU603cGBDB42MFGpGkYNkjmeQA/E167YefPj9du3Pkz5LWbfsN47eZfK14rlLDYFx2k6wmOrvdpVa8HH+KR9O3gysch+9DqDSMy06N52MyKRv1bRPENzE1QcIf8cD7GELBPkj5EMK8fSkFlLiTDP7zA7Fj3IJZBYrznseAmMYT0rUU8vmyXwmWz1FkOlmrb9yxeOkYuriuL76vlY7qvrma38CTPLvReXXUvpWT+1Zhy4v/r58p2tZmtqYb3QnZM+KmRO3lA5bggWqbicZ4v7yylvSKrUSYuRolZLDryDSsK+KdXvQhtsZiz1bbFYkLQiKp3tWTiz3aCW3Sbyxz7Q9jjmayWN3bkcDfM4AuLPCVL+akBJojLgEIiBV0ugJh2uYwSCTC4bZkJOTuijDG3eAzTCOgiSxUJLg3Ag0L5rGr9/07LQwTqIxMKPAuj8DBIaazajA2Ycewygmw86gCDX8UZAQ+1V0xSwMC1n3mwLwafeYPGSKXjVLfA9GnJBA8UkoY/c4qPD1oyOE5376JYr8jKbZGrXFj3YdlJHv029z7SKh4tJrUH+RCrjrGitQ49o3QeSgyZCg1EeXjAJciTcdIEqDnBdTv4zk8G9stkvtMzt+ufH62rZmmsxy9cnHnCDVe/sj86V96m6eqJl6OGpWmy58+V4N6n33SmWTrT3MRInXju089cvv7aVzJJP3/Z+XOcPOHy9XM1nG8t0xQAN70toeLj2utRcfb8uWIGEZcAP4ameNd0rjhIZ+Lg6v7cazFbPQDJIc286NFsuvc6X8zp6X7PUj5tK3Hw9YfVFIG4a5QouDyMxsHvPDENnUoL6hV5s6mZ1MwEBUWZTCvuIBeZyAAdRv2TTiKZ55hyyusRb33I7jvsC8uuu612334HTIREhxwrUHdXOdQkH2piUTUf4JM2+GSCEkhF4kuF8kmkn9K7F3xevXuXAlcagKlALkUKPJTTVP4wsbUNkFet2/3k+pJetVtwv8OWa194OwinfzGd60vSLboMSMjiViwDEjrkkpJ/Lub1q9qm2UuKgiwOuVor0SaaGmjKzaqDuYpKVdFH5VPr/hnHaKwFK6+tLJdkHeO4bR3ljBJysVdZVOb8jqmrimzy/wk3vbBgMq+lzuuqekItKgVq0vTA5PplTPBoUiSKbIwMiIdkVEYSslhI9Xh8gKUvepcdDw4g+YAAxtRgeCb7rY2gGtcahW9jVZGFpVU0gbmfkLkv5TniCFkXq2Uv7EiMyfodxdyRVTS1E3TAbUbPHh20yFVBTphYn9TgA5q5neI5JTpg5H0N8vedlpiCcbYCSOTkl0UdGWU6EVj/c4BxgzgOS5CxNdp9YbVafyqEmJq26zSTNL6Q/3BVFREmxRI0Xgf4d0CjRGh0KE0oWAcu1jZLK87gigdIoPUzLi4ymlKTgdZNU9TPQm44V1jFljsywGC4XkrYKMrmxWZ1uGatyGF5VyGT2qKiS+kdplGMpW9jBq2bdyfM2/nZWJ6D92J5Vu3V7HS4N+hLmpCn3ieKjLEV7qBpVS6etvtnIbmO3GLkg7pL9IWbEgzshUOqzPLsjBVT3EdTT0o0iD0l/o5c3J1salh4mYlo02EDJbRlAkwxAWoAOy5nFuX07Zfx+8X+JFjPkJJVGyrtG/tpq2suZ1glYvnxnu0nE1IUk+Iql2YRpMlERgeJrONUJtkNiguPxj7laniAEIMjE3GWFIwYSEy+5QzwuTCN9ZuXXYoddHXPcjFhXp4yEEDF1PU7VmZSgfLQZtOdQaCc4JMtV/VKuJ4tkGWU+2Zlt1PUBlqBE39nlCRAZ1dyOBh7CJ1BuYAIg99/9MgdN7WEjScJPqUKhq22P8rlq5Bo7k1ebt7PfbiXOzvfyBKBFB0oH6eaExWiCQiRCNBoPDwY7aHjAL+FF5cbqZoEqSflpSkYAnZbUa9vWcKJ0LRa1qR79Ia1gKlZBecNlDkegwwKsaVzN212oKZ6PDW7iT5R9C8fRB9tLxjkPQU6DzXqaCE0BGFzd9HWiwbu3w6c3odgZ/5EblvMgSTR8cG3jBp9U1gVGpYfGSSMrsiFIpK5N28nFY+KaieuRmWzw2Cru7h8JSpoIaoyVFWp9pvvDRe4CcNcuwE2TduDD4D5o2hn9rdoygbM1uHNjDXYq2gW3b4S5NIuw1Vf3FUE1kJqLIi5fjkjTjWYgrURzTBT7OIbIZAGKyyGb71BbdVBWcG8PEJGUgqsI9nrLhncjCq6HMrvSOoKREoY/BE0IzdOC84U0I7boKsspNJzMNGrP7ikJrssO5ruZ6RLT9nOuP50noQEykCV3aBdKOzR0364fLpe54RTheG3T1V4ZOlTSJBKiGfo8FODnAxKf2TAnUYnsC58olfK121MyLNCt9mytkoW03dZG2yz9SdUCH4gtV5e2jPvdn9a1/aN5t2tP8fk6D3+LF9bBFXKOeaGMrziP3sUnnniTfyIL4W/O6cPTqmFxMVdXYp6Gz2DTq3/6MLqRQSzIQqSLJmn30DBda/UkjqzMtz06Tc4nJJrKYbxvk4rksEN2SW+rnjYvSJGv9xkfcdI1xv5moWVAq7hkOeImsCfI9vAvQ7iBILN90pDDOb8OUyCaTyAKxncusWn/566ATyEAhFCBEUUp3u4uwrwRm4l7F3tOk42WIYH8paZuTkHfGVmZobva678NdekzJijpLTewzJzE+fuyszMzMxNzu//JVte+7nM9Qa0gtFoZqSZ0SjK6Kz36uyMBIKmTqdVPPMXPe3Jh1QWPAONkEhOx+Td1m8f7+/O/30Bc1Mdrd/NXJCubSx93N33HLjszq+nwjz9Vm0PCqmZgR8fspOO4mAcuS1bfJf8JhsGfhVel9t9t/l2ve7h5tBPZPzq9DxLpVH6TnZ32hr5CF28wJNs4EcaJBNl8OCdOJ40MFJ7jKwTgGGVwEj9KAyheTt0zWmFwYq2rq311qupGfixApR+QNQCDVCZYi4EGorEqXW9aMtUpGVzxZbNqmUXWjoeu96yzooAqG4pAni5IoCXNYCjAYBDMQ8Hddvpn6iwsnTButdPcXj29icx7+exzvoFrHM9g2X/d09FsOx21v7rYBn3lGjc141LwR0lGrHNjWgs29X5zGyD5M+9Y3qmnlP/TplomFzyR4A/NV60ZUukZXPFlpqzo9GyukzQnV8g6I5XPgAWzjtYFLCPK8k2c4mGAzQSXrRlS6Rlc8WWegCdaFn1281UnD7B8So9CBnL+DH0gTR+6chPnMufMMuoURhXTY8dn/Vj3NKKs4mtUTU7Z6aosbwITss8NF+AL8hQI+CCUJJqpENNzIXrCA6laGPtCiWplTEtP+A8x2Gt7x6+H5pZjWeqoLBD/SqT+eVmSz0arShZsmgfCQfI++sBobBYhiJMn5+6Cv+8dRiIlPDJ+gV8sryfP9M4xCoJXDhOpY8iet6w8OQUVT5rsvUu+RHEMAJkHHyQWPrUeSeuEaK4OgPJyPiV4HUDnrEn1tyGA9Y4W7JaI6yhECz7mb6uXKjvuKNWC1FcVQJW4YwMoE2WOP+AMYjyMVB0/Rp2vSL+QCrX0IFDfBv8QvxLwSy/0W+Htu1FVeZgRGX2V1SZekWzGSb+Ww6Yi4s5XO14U+Jx2nhWp0Ur76gKx1+09MiT2/SSCIv6u5mTcmKrvAE9+KnYgjcC6if0RSiFfkKk0p1PPLTd6s+80Rym3zt/iVPffGO7gUBVSI+edfXWr/37rhFh+oldp88bWItngzA95evGpqamY1IB0utuyc8dyA6SMb39TQM3m6ti1zz2d3Z+ObToybBDnxgkXWYkIpvfDjzVeidm2aQF6hHNqgL8VEj2mm1+MAPvLjIro44efhT1TAh5CTLA2vGKG9cx0wd6B3NMCfhCjgHy8Bw8F4Teh31wGS3OnvM+wP8WPR2+6fS5Dpi+VTYYngP5j6968sA7307rD9O3X31d/4UfJkcEaDL8qTVcu4Ea1uTU5Zud373x0ecODH/MfJy7g7LBD0uRPx5mAlJV/JH06EOH9l+ZIERQn/0A77zSawAutWwbs0S7OxZmZluugXPhmgSkUYnmMOUyoshDen6s3+sXMpc1SnbZmQHtD2FIsIc+HR0AKZOZ3ZNKNFbUnho/VisqR2Ia6+N8gHk2v3rz3hRVmNKI6vMnp3XRU7OM27ht0YPN5RNfd0UNEd+en4cngAJB8xeXAAw7Yq9s0h5ybUharfcdnrS5mMbQRlfE56tcjEQpNsSWNg8zoInCZDAnNovubAv43THkQCzpDk9tfXVgIZyy0x7khdP7cmK/y9vkidI5PlukAGd9VJiwBmW0ujvouKxPUZZ7rj3nV5QytURj+/NGPxH41Vy8sfIGan2XIhMBE2sJJgKuYBbbVYU+hbFGVlESa1DvojuPeLi6b2YqpPzhPb3ZiJdm+2QGDKoXxX3j9ljrrlQQUgRrrzzizH/f0XF/atsef8yC6z6aUvKHfOfb8b29vc+kepR8vpHP92solzWUyyDE0IrYE0vwPfxo6SH3reYwCAIvF+Wz+w/gs2YOebbLRZvMnn5M8+zXsD9BAs551H3PAVR1AAaS6zWK54mfxnNP89z7HXnukedekecGZSzEKy/xSdNns7ZtDolxkH7i8r57Vx1zq+J/4GVd1zqajKcA2C0V2H9KS6dm0kUzLM0iEziKcoRcMFZmd1dnIX12d9d2dTZhRgOsRp64xEVA5sDTmAQwI2dJ2whVBYOW6U1RVlwfQ2OnvtzZmbSUoH0PqwO4XXYg7QwDxqFZM8H+wHcK1ogb+nG0uG+YJHgoC7WhKP9EKpBuuvaFseDGPSkGKqlrpKuYt+yL6YkLrjsjdcLDV3517DE3phTnpo7cW1kjBSoAaG6fq9rf670ZQO99cvFFj++4LUWdA5ZKF7DiCtaezW2TYLNkHxj5yKGzb3Z9FrBQwa8iw+MSv6wwwKOEzlFSaasfmeJ4yGkVzYny6IyWTj/RthTtw1gH/665egkxyCiRTCircY5DWuc49EbfTsdW/XZW29JvYoy+K1HpJlXJQrU8pCOOG51VBRNRkJGEo1IQ/oDBw/Sye9/Vs/VnSysBdKnIA01aO20VUFQoh1TPI9/L03n7ZTfN09nmxLk7/sahoF6YbrI+WfBa0JyjhgDPtF29gvFbuZt0gI34QL6MQEsOVu8v2q25l7LHOzp+j9XldbFxqaJkOy14qIFWqByNwKpi2+wGGAGTsYkNRuDuP3sQ+pczhj52dKYUXm5qC3zRP1Xd4WrzWPnH/+3wHZDyWhAQ5Hapqgt1ZwQZibJBlsEuJzW1NB+yw0mi++kt6Yk7X5186TXHpWg9Bc5Tif0vY/LQO47N9WcfZPKj1TQzg1AFQA7VQW3vcdsWXWJ03l/X12vf5lut/z2MwanoI60CCUXrQ0/fMlaRULROeP2OLwRuIkby3EvHDCFpqx1FHt0Yqlq/Lm42wHXlsWrLTd0S1zWGYtnatV6d4Ku+xvi617LjAJrbLhrI3YTOU4e6Dgij9yxtXuBp758UaqLrW/0bmFrjkptSYyTj8ovbNz0Gkp07hNbK9rnGd9pjo5bL4r5BzJn2MweyK43x3Z6kw1JHP2MgufH2OTdb6dYx7WddsviIc8f0+PEx7BwRqZ6x0u05V3dGdGlk4VfjBBKTvROU44W846CMpnaefJowG2v54yTqoAbluX6ndZ7DoMgS0tl7f/7HKqcsdoCuGDtg71DCE5QkOowbuCZucIgUowZ0gQkboNUh7Ft0QB3OfcgoXUVaSENj6iRGbwIF+0pHBwpQRAwdluoggQYzSgUYfBegAVxFCVwTJTiM0T0LungfCSnqWAtXinQMAFsdIih2610gBKev6CyJuVhtqZOn/r/oFX1I1LjkzgnHO1ohzXj+6VliG6UirrljRg5JJX3aboBRHSfwvOyf2LLHyJKJjJJNl13qicZ1TxrEPq0oV2iDnxByaeRelEsf7ZkyM1swY9axS+RNL8bvMHcpiMGQnT86fKPvoM3LnJFYAimM6cPWPHKlj1Z7t5k2SIlAhlwO9JN+eNLAqH1X2Qs+zCf7P3pHa/+t8KPSS7640JX7bdXEWd7TPwDPZi86USO0T4bcDFSZsVOkm5koRSaIoiwL957pRYGU8WqQ0Tier97b2s8XWGjtn+vnm24o5G2ww5TLb3Lzfn/Em3OArSkGslBtUuinkgcXpgs+mt4bAADpqFQlvy5MFzw56pCiYdKtFKX4gZ2CePlOgaN3Clwjo/HiTsEvcFSJ9e/tqLphRo3S+R7P3S3z3J1f67m79NzRofgrE4QI2n8kRZLC7BSIkp0C4b3txLki8ltgrhVnmpuvYlP+4lx2gWqgDg8n8vdisKRG2izxMn6trN1VnZhP4BeLe83Ct6tfJ+3oa/0ov8GsjPhIMUVPuN3g3Bn+FIvroQmmJO0KJXXzS2tK0iLzdo0CdKYovdibzN+n0Os3mf6JZmPJW4NSRPHeksyq0tea0lev+LpbnfB+YCj8AH1p80GubXKBurT4IDc/BKt0COBb5doVSBEZ0vyqcYU6TZE6wDQpiFMJ4UhnT3Fd8TwwDRjMIMsVwzOR7FrpJhm2kwnuP8f4i2GPWr65RtY877YnLVufB/4fZ1YNLE0RhAe3lLwad49wd5cE3erb7dmd+keO7tnbdzgZKTE5EXmA5FW4pHheBQmWMb2zv/t772xavq/19LxvfzjlyU/wjP6jn+7c+xPMB3+/+/158sdy/u/O3+m6C9++6rXbznrp/Jsu/fDd2z774s/X3jtrvZzfv83kgSDjypMAxQ5ySkDIfmtg7XbIC+CEW7ViAizXmMAyBhLYUjY5eWKMrcozhCIpYHv2IeYB8+ylsB65p1ugyAVwRcyYXYqQGBAkoC9IMLnYpWnGkH3CFEnMC8TRFWQhduW4oTYnNksoSrFYK2cEzWrlRwaM3XywzmfiJaJ9OVdPW4BOJi5LE7GWRA6CSRYwJq0UbIhlxrDgUwjkbwHBDSlxAOzRRXPrDLaPoBb76jneYsnYawKp3SMKon4L4dKDhVcJXAHuaJ0Hs8KuQWbcNpGmxlPsZ6G4tpHMLvbmkmtvKjf2wK4PuJkRZUBegwuFWW6pp9uf45HMqyN2jHlk2lvuMEqGIfmukPdDvlrDoJ11kmKzlLhz1hLDajvXtTYFwaJ2Tc1vrKnq1KwI7Og9UEl7O+mgleI8SClQZtdeDdPg2qHAlDhlxmVsa4fGQj2gFJRINXlfSgYTKiGnKYKLcI2N6RraaWmtTgIhdXRg/n2CgoU2z7NDjnUPTKu1b3rK2QW6/N7Hnrz30ebxJ5948rknn3j43ivAovPUmUMGqUOtXmeAsQOlpDp83gWXNesbrp//VG/g8XtMbVFDzIlPIGyYXB4gkIiOx4WXyIWm1KBJtmGMPe0OQbaSKZxkDNX6EqdNPBiu+ILJzudZ1VLMOt1jXTrccQKYYXk+cTIPAMU09hpVSLzVbQSzgXENOYFpkx9DBAOWU9iP4TQYpjpXB5XYwEQ6lHL10S1i6uhYesbOOcC6lEe3W/ZUIG32bfCsWA8oVB/uf0LRwjqpz4J193F5MqukHsOqwyufqDqTGaPoCtkxzuNeRyz8z6hdgEWxRg0AxiTsbsJCQRoUYeBgN6EgDYtBXMLuWknpJQwapRuLcpZZuhFYMAGXMmEGMLC4/Ovd4bnf3+xTzLwT5xzmfJM2R/4ZaUaHQ351nU/RxTpy1O7kUf6qfB/9mx400CjoXf8P4sBvA3qkEzTxyaM2h/lL/dn2WUktSSH+b/TR0ugDotEnVgzBw01ismAadI1M+Y/ZPsDF+LX/zP+wbWeE+a5BogRW+8oK9YPgad43EBr9VeYPuq57RjAPbliz8tFPTHB1j7iICcFubCEkh3gvRBKWsv+Zx0DcZNuCc2dbCGf9nJb4QysEroP4dzmvjMUtRItddnS3+1tccJZG/Py5m9aFzQRPe22Iw5KJbMFMxBlLi31tmola9707FV7MEeTN+/qvJ3t6Kk5sJjSmuPZ93twqiJ+D+E4Ho72JXIIRauBZfl9SsH4s4sw74W07uEQws6x5n+kqgTMRl+wo6HzfRLyQzQ0Tv7Ra4AzEb7TPMfNuIiD7ac7c6nljcx3Ezz/9tWltE3H21YE1K83mC/KXRPyOQ9GdykZiouE7ezxLgq4Pmn9amoVdI9Gf7KpSLiFB1+cLkn/mD99JjYSt2aTh0uTVgvU5iLNOda6MayCmT/hylXScKvBYxBseha7SaSCuyX2Jzlvfj4/JmYjrWDkvzH9KeGFhaTLG0+j6IM5orcnorydWZnlG5q6WpeuDeL+Mi7B0PTFzBAz1FBbQ9UGco+coZVFHLLGvfhJUIEX3BeKx4RVDgbWEqnuMvd4F6bE57zNSH7nTnsU1RGCur1K27iKBcxDnMHWrPlcTtqw6OKxbgAm2iXh2pwS+opr4WLS99YjfKvaYnIm4/pdIs/1VRFdz0cSXjTJ0/yHeIHk09lolIfrz9TWCPVo/xHkzx3unVRAmuw+cZL0eo0ui21/0bsazcsK280HcX90z6eMPrU/SccWRMmKj/syYLdHiY3PeIJL/3a6e1WVEoLkwy7ddUuAcxJk1TrL7SgnsvJpN0dQFWmPyWMRZ4pK/T5QQGobS+zzPD9DjG+L9Et/33ywmREpPLFD0X0nXF3GGQotMbhFxK27Wwnim/NhcB91/w+WrzznEF/P3N245iGmNySUR571WCuoliEGVOAvDM6vo+iIuJMvvj0IC4zfKOlUZrTE5bwA5fs0DDa1wYnKhtYnx1GV0/RHn7dZwDi4gKlPN36ttXKU1Jo9FPFbp2baSPML+oMK+tZfnjM2ZiDN6fJr6c4hXp1SqNtxeTdcfccnJILzkMWFsVW5jPl5Ca0yug8a/5NbzTQ+JN3N+1L6yWjc2l0ScGUeuP3qfEI0LPGt1eS5df9RncRTFsoiggPVu0aZyY3NeP+KLTrRtTiP2Hn/Wc9F16dicgzhH+ZvJ6SSCvDuouv33OvaYPBb1v/O9ouOI1L9Xf80d/xUbkzMRFzo/PcI1hugWvXp5NXMte0zOQPNrEV6Sf5vYmPgzxNB/Dd1f6Pq/s5M5gURkIvfbZfE3+JhcEvWZjjK8a0S3zqtp0LmIPSYXov1/+I3JORTi3mfmzWTCe9moMMeKmXR9EGeGmByUZEHTUOdk89bR6yt0/ao1q3bdAdWpZsoFsTJ0fIjrvPO23BQLB54PWHBmjaOPDxJZX7450zYe1gyzz5yav47eP+KcmLmpoclwZbVZw80LdP46qLfVnapJB+E1L3YM2i+m64f6ZI7Sx0y4pFmlpz1rusB5fUh/b2/UvH0fIqKnHbRUHj0/Is5rTPrKfgjPdV8nWFXS/cdAPPb2PrMPj0F8mSU22YGOXwdxzkcxrlAuKPdFpfiL92KCmYjrmFpaqeTDqx1sDYtZK+j69CLxZfhX/vUEeuyHZJmsOXR8iOvg40xu4MBNNytv3D56fYi4pJjbxopC4G17m2XPkaPjQ5z3emPQewKGxe7qPVMdHd9Rl3YNWFAEg8Jy9ecpKbr/PyHnrxVXZVOLQDVMfWtAEl2fWMSZnlNtGovh7qPrNU5REwTORJw1L/v30RLwPrlnRbJCOSaID/FsFTetoFI4nzNseMGNHt8lUb/b3SNdBhVXHHreq9D58z7+6zP9CnWNy+G8PLbO9+no9RPix8/4zu4vhw6pyB7/WaP/f8T1t3r4e1fApC1Bx2fajt5/IC608VNWYSU0rvuQaqglTNcX9aFWM7MqODYSa7JmUJgefxHn+WB9IdXgIHVQf8tJenzhfUCuf8yNXyjVQGpHuq6/2lSBcxDnaap7NdRAzmxD09I9cnT8iM/sL/91rBaaZG+VnewdwAXxI85qzta6Xwdq2fOGZEZk6PjR9d+NTD9QD4pfNjGkZxdjgvojLtTWnfG1HmYFPDk6T6oaF8xDPPuh09Kwp6D4Zmp1b80Suv7v/3WTfQz1Ew0QpNs3/3Xkd3p8R5xhYydX2gAfPmLzfRdK08cP4u//HJ+NsLQ/4fB0Kbr/GIh/T6+xcGyE6/MThurCR68/Ebc3OxxGNEIue4dBX+Lo+RXxvOnO2+Y2wceC7QXtXmIC571D6td6ub+wCb5M1N/9M1KGzg9xBrdjYC4X8jAp7sVO+v8bi/jMwrN2jlyoPDeQXecyi84PcUWVc/uLuWDBnpxjqLmQ7m/E37eseLSoGaJ4rN713SJ0fohXnij2P9EMZ57ZidZLK9DjI7r9BdG8qmaIfyG2xFtSnu5/xGPVhTOXt4BpxZHrxwvl6fzfIsdn5YGhSy1A6ViSfRkSdP6IM0zfsFtaoPVovIjMFDG24DWrnY4A1fmvxv88VzhLaGhG4+FDU9nsfz7eeQOYoeClTpDsgqd/XgstaIi3+/NWhk5q8+jXEStLBR9MPP4y9Z9vKGr1tzf9+azCXUM3gvfcCP7redGFuLFYTzMCU1P5laL1jQLL1heRcxgncBvmOe3wXgoabb1mXrRi4R7XXN7P66Jgzjc7tf1Nfthpj3nc7JcU/Az4sYJZ74u3f2tb69hAgU3lWxvdIQZWGXFm4bYKCsK4KubdcSzM7XN5tXYhBc6X3CwTw29jM7x/OJk8puA3NRy8+HEANrTjpGxwOn9/kQrHtQq1sXuNXOXeOAqmuLC8VSf8hS/h/p1lG0HBdLaCzP6DN3ED89kN40IoMPqo60cx9fFaJScO24eC+V9a8ldUBeE8uZTMcFcKsowsPnRxmZhBQELlnYsU7AxJ+DhvCRO/ZHAFyztJgZZyu1G/RCD+0d9P/cdfFBAH5oCfty92pubYJ/PDFKz+NOts5MtbeLPFRHeeOQUMBQ3tod5wLDXfXsnLkIIodc8a13eB+LKXv5fr76PAvyRx66ZjPtgzv0M3NLdTcGVid/aki0zsVuuVoF1AQWhyctdwwC1M/dAZl4vqfN95enChlRcGiQ/06pUoGHwncUd2BxNru9x5dJssBVYiJ+BS3i38+uGvHW9WUqCUJurcMeSKdbRLfI0S59efOLY4QkoLZ7181XBtIQWPxKaedN3gi02Z0J3oMZuCwJp67+C5LthBBe2UrKkU5KRl7zuzzw2bl6sk9vdkCvaeTu8ct9kTU3qx9/fxcRTs/s613NgWiI3MP/JA5DcJE80DNJlxnvhATLB12TcS7PX31PbtDsZrUjQ2JA2QECBnsOS7cBhu+2KSc2YvCU3rQ7XfN57Ah2J6VF+/I2HekvqHixaF4T3Jc0rkukhw3iuTtDPGA1uuOntvYjsJPg5rLjJmh+BLmekTt70iwdx7wc7AJBNcRn5ISuwZCUvCd9lFrLuM307Wf/m1kYRZ6cWMvsNbMDlvG4ZIPQnUkcmaora3MGOhZX2bqkm4MOHuq45aF6wBK3p8r5wExdkzIGAkBGvnPu+XKSEhO+vik3rWWUxaZn3LK4KEczzDT+xlIdi0tuGwBzg/n7gTQqqhgXjSuqizD/JJ2BUX0lrb7oVvtn1671UOCdbqM9jl7edxV72og7KPSPhmcal3+2xPfEawZXX8ff76z4cXTlILwV5JP16/I4uESRE+Crl3LmHDFbebZ2eQIGq4tLPjMAtba7izTTiNhI/li/Q9KlSx3O2mPqtTSFDjHJF9qxyK7ZTKmHcsiYSYs2E2u7v9cNHWs/kdCSQk76M0y1T8cA8jjeyr8SRkfpD1Pn/AHZcsqVXdHkeCicnB8231Ifiq5Uau6vdIOLLoKjN1pjF2KmVvs9FdEtYstyKohyF4neY12+hYElzzVb0yZv+FE6+mnJnNnyZTnPMou8O4wuKj2IMYEgxu8Ay1Wpm4e6jBjyv86afaZlePSJzHT1v3vj/Dn86+4svZTXrip68n7AznT/u8NRJXXuSJV9ltPviJP81tFrWqiWRhYNmu58Df/rKEffmtypdwr3GfTs3lx+PIsTMc7g3FlIsUx/Xxp42cnqV1fDqKHdJ9uv4zP/7NTx8qlN29gc9erG0ozc9XdYPmQI5DCD6nfm+YN78e4iOLNNytmHhGxYrti/n1cjE++UK/ORTvC94a8TKZBCGf6eZ2GSwszNbnZUUqCY8+9hcp5Ppjr2NlNvekkzDyriySkXMU99v6eL5yFglbrT+bun27hK0/Ny8s8z4JblriSRKiIXj5SNAU80ckrBV38s1LscR7yuqyN+SSYJrPuvxjhRM+Y39lzdYCElJ/fFm+ZUswrq/bHuPKJmFPgO1zp2oPvEC4+vgAhwTp+iDZ31knMFZ/nGtQKQlPTol1qDU5YytWdC06XEnC4eWHlk8s88KP9lhesq0loUWps8tzqS+mIre7N6KBhHlPcG7jkyDccpX2gwktJDQpkZFKtSzM5KHinOiXJDw0O+Xi7uCOEcMXjBzb+flGBdyue+OKX/zMJRz5/eelUhN8brEflsE1C4t5T8LPl427Ay+xcNsc/7XCJAkFma0HX5YY4b/m6eXd+0yCzrdErenxLFzDtMf/5A9+/UMy1L88s8d3WP0aPDtCgpqPiWMnGYTvnnxXMXsSBXVt1mLPR05jTUV7WOJTKUi/E/zzFzsIFxV/bl48m4KHU7MUM11OYZH7PdoiFlEQOhxjodwVgF1sGLFOk+QvbyraGMhzx/Y0GssPSFNgt1hXPavuMPb43eRQZwUK7BcFO61ztMMcWFSr5AYKmh7Xui30YeI/SyyNpgAFx36OgGVGIH7ZW3i33A4KdqWcUc+cxsIHvaeJeOlRkCSslegRdxrziv/VutCEghnLdSSjg1zxO25V87sY/P0HF7XomwVgHsqvJ7x1oGCP47h0Uw13jPFo3GepUxRIaD8Slmpxxa0jLqncvkxB1bQdmvky3vjau1/nbvekgHtDgzEx5zT2DXzfybMoOHEyyqC3zA1z21vxyyCcgv4gbuDsoUD8FSv+XlY8BVdOr+i8k+mPD9gFyO3MokBEMnUTXhKASZvZkEsKKFD+lFISKuuO3S5w3CBbRgHp0aiUcsQH09nmYn62gYK+Ls3ugg0B+NzCyIzh1xRE1QXt0/Q+h71gRV8vekeBdy1jU9GkA9h/EG8V4G3szDalNGVmZvzzFoyv9a5CbVNmbh1OXGZmZmYMU5nZ3qTMzMzMzB07Gl9b15dJn48nO2d25owU95O8zcue06ulvv7pHMpxHM8JnMipODWn4bScjtPzHM/zAi/yKl7Na3gtr+P1AifwgiCIgkpQCxpBK+gEvciJvCiIoqgS1aJG1Io6Ua/iVLxKUIkqlUqt0qi0Kp1Kr+bUvFpQi2qVWq3WqLVqnVqv4TS8RtCIGpVGrdFotBqdRq/ltLxW0IpalVat1Wi1Wp1Wr+N0vE7QiTqVTq3T6LQ6nU6vB4l6KK+H1Hq4TQ+uZn30fQb2CDWauoV1d2vIc0Zj8IABgUGmfjyvMRp7R5i6Gu28HxOghZ+7BPbu/YsRAgcpTD8PgqL2p4HWC/sjV7gQOFdPn4Hg+S7dw03BaQ8YrdcaU7d+gV1M1uDwvl3hAaHVKTg+CrU5HJ9sWh1ir77drA9jaQgd+P8eqLWcKiPC30qnJ9Qqbs5jRFpcFkKtkg4ZZhz78h3GLvnY8OHqpYOqkhlxnqFnlIHkiBAXM9RvNbk6qtLuQY/MZGWX0Gl+U9uTRpUazLsydiUZvmPv/HHZbpEdhaavr37mPflftkGmPAWuEcw79NDNS+Huqww+bim3rPlvFwjullFTjDxNX9FvW752xP9c0xMF/zeCbMk+bMfWsSOIIXhN4qOYBiRduHsxzedp5PNm91a+DzeSAjvitq6NNZMmHbtn4EbMt+e/umxVQpkvVaTBJ8u0ewv5J63q+GBnv1ykysn4pXWmexFt4eoNxu5uSe5KidOm165DlrirovxDvYgx4WVmMXtfUu6stvGQdjPIQ94zZui5yaTZU88hXV+1sed/49vi3ZmHQ6TROfqZvSG/snr6xy2v0pOQpJ7DtUMqk1vThhdKXMeTbyl94vzr5SdXnpydtKu7mpyt/jH/7KZGcvFy9NkLHl1J0pjClwZ17kBmNWn4Zt320oSd/9fW/b+83fJ+YHj0TD9O6bfpTrMTO8crBfp8IPfL71c6LTkReiL+vnL3aLtr8dVDSJExF04EzTSTBR23rF3Uys2ryJJxvZq9q+DVflWR/qdalfcqnByX0/QxT8qCyKiiPp8273o+vM1ha/56qzIcule8tLJ2W0KXrm/DlEa9edO+PnOVpQlfJ9yOiFXW52n7fX2T5kT/YfB9vtRyUuVYSI5SuU6S+Se3J3dt9YDU0ww5nrHeZZIx8vsXz+7rlUYHpp9OOq42N3+6usljyP/9YnoxtUde5VLBDqk9n9RXjGcL1z49vovyrlh747awzsqd8NNHyp2tTaRnvPI451iyaMg034YRySS+eYn47Ss2kXrXz+QYtHMpKcVnrdLjXoByquI+34ovx5tzr60zc5q03XKp4Q7TmIzuyvAZESm3kkQluW7uazFV/JSm3Y7rNUa18j1k9YBJEwxke/FRlyOWdyfvI/2PZVo5nlRRztSpUGw8OXNBqtlxWDDp/KDY/XHn8il4PnK2boR+2qjVUduR0O92CD3jU3s7zVYs6GWj19Sz2USP0Tb7ZcpOq1WmCO+ttnKN+ipviOrbP3NvajeAvfDkmfYN2N6Hnpg1Pm4zIrht6Qf7uLX1Mm+4qfiU3rfpYY3K7r5dXrQJbNq/oa8bHTxAAIgAFUANYDmNA3BomWuM1QH0gP93wdUA1AQYXHASQAYQF5wXwBvg44LzBfgBarngagPqAPxdcHUB9QD1XXANAA0BjVxwjQFNAE1dcM0AzQEtXHAtAa0ArV1wbQBtAe1ccO0BHQAdXXBGQAAg0AUXBAgGhPzG99y/dY0jFBAGCAdEAExObGUi2kY5unylyaKF1lGEHD1iHfmpzU39WQjemRvQCZAXgKMzoAugK63VzYHrDugB6Em5Xg5cb0AfQF/K9XPg+gMGAAZSbpCT/hvyX7CRUy88t9oAr+XPbP4Nuie26xE7H1ht6df171gt6VDtms26zzlli0sotM1qlflBz21xYYsf2fga+2/a+K0fDqC1UL+FxlnofRasi3VoXqxnoXosVKeF6rJQHbY8nWc8tem4NfQCWvTbLfoxjvqxX6yLfaMuex3UR3WgPuwb+8S+sF+0OE8Yh/dhP5jPXhf1YD2qA/WiHlv8ssh7MrUWxsq/xWNfmBf7xbpUh10X9o26mf4sTH9oLcz84H2YD/vEvuz9Yl2sR/WgXnY92d8H5NGPcejHOtgP9o35UR/WxfnC+bCvJ/P7bZ8P5vNhYT4fuM6oA+thHewb9WBdh/n6a0Pv9aJ6lYmS1POTb73Y3k3N+0a1WzbmW3vz+xOmkZ5VW0pJJQJa9y/vK105OD5fpTuyWVu31aeAqk3M+yZmfjvrbWNzhwktArY9M0pThrrX8inRVPKMbnCtfS1/89EK7TKdVnWUqDVTP8bhfWasi3UwL60nUT0S1Ym6UIe0wNhkStHQjtKVNp5LWzZpY6YW/Wa06KcW/Zgf+8H8qEvCOqgP5wvnA/vGPrEv7Jda9GMczgPWw3wS1kU9WI/qwPVBPWZLdW/h+Rd/iVozY6Xf4rEvmhfrYJ+oA3WhTtTN9mdm+kOLfozD++z5cH1RD/aLdbEezgvqZdYTLfrtFv0Yh/dhHVx37Bvzoz6sS/WhLuwL+7H3TftkPx9m5vOBeVEH1sM6qMuuB+vifDH7nf9s/Lc6XlgYB/lvdHgozte5yX8z76UV5vpf0pGfqaNidHDk31l/galTh9FB/iEdxZk69Zk67Rm+Mfln1p8wdUKYOj0YPuBv0lGWydORqTOY4UcxfA/y96y/P5NnoHOdETMZfg7yGPAndVRk6nR2zkNmM3XiCXPN8DPIn1v/ps55yCQmz0qmzg6G38rwkb9TR1XnOKWf4nzN9DtiN6PzBFPnEKNjLfld6z+iNVNngXOegFRmXS4xOm4zda4wOpRf0OHJrP9I57jILc586SvOPPeSuf8dU+cZo+MEYdcfzy+4j8HzB+5D8PyA+wg8F+H+CM/DuC/G8wzua/A8gvsSPEfifhLPb7iPw/MO7nvwfIP7HDyH4X4Mz2O4L8PzFe6z8LyE+ya3Xxj5AIMBBRj/x6R+YbuabpWHiN73DmU6JfdK8FlUofFVeeuDs2Gxe2/LnXvFXvWr/kAefSe/mmx4LK/9WDDsrf6ZPGxAg4rVk57LXxrkfPBIPiDnUm70n2LcL3/p23bH4/i9sqXmoWLvKuyWO+lWVVtz3yK3Tl1yv2H7rXL7iinR666vkXOlbtl46ehiGXUMAQwFDANEAIY7LjtgJGAU5UY7cGMAYwHjKDfegZsAmAiYRLnJDtwUwFTANMpNd+BmAGYCZlFutgM3BzAXMI9y8x24BYCFgEWUW+zALQEsBSyj3HIHLhIQBYimXIwDFwuIA8RTLsGBSwQkAZIpt+IniuSENyvSOT/gIdnhDcD4PUhWeAew8b/q93CRx4P63Zh49ONw9Lv/zP1B/jV/Rhd+99/woyD0W30ZfsGfnvXDWAlYBVhN53qNA7cWsA6wnnIbHLiNgE2AzZTb4sBtBWwDbKfcDsCJ7Sn5P65cLJc44wWvpbJHqSEvUjIvl8fk9vYoMyZSnje4aOC2hCg54v+ido15Fy0Pzr+69s1BsXJImWxtDnjHy4XHBcIrUa68JmrnuFfJcknbWC3nsY11cv4a6/LVWLdBrlWoQ5+Tflvk4vt7wmunPKu8P7xS5bTvcw/KLWzjrMz+e3ow/GrNqJyPauaWPtT0KJPRcNiQw1BxYyFD1vPlDD4FBQOf3cegmdPK8PJFD8PECRMMFycuNUzx3G7QT7ttqOCfVzp6pL60IjlZgk+1nM46x2lvNqCxjjQd2+Qw2zhH7T25J1SK6fHU0nRrybGPm1xAi34Z8lKtjGW+T98J2AUwu+AsAAWQ4oJLBewG7HHg0lHgz4jvMDKAzUjhDvjBMFkFBGFoYfgzaGwpuwlplJy0fbEBC5EuySlskoqiWFPCbukwMejGSdrSYNeUbpDr6afTf2jfdUzXeDAoL8EzS1kaFnVhW5fHH+eiMTppgt36X2Q2JvPQphhdj3k8NzNmpWAzIt+UmRbxjO/TfyF/Zxpf9OPpWrwf00xlLn49QNoCL4yCrHl9SoeNoTpc7NThqPUB5Pqy6Z2pR+PwGcadFWCCSguiW4/iPtOdqiBNRMpkWbb2IZcdDVD6Zk2G7B4+fn/MEv82enSEiNhwhAG3b8y8Y42w1XFUR1ngP7iM1mQ3ZmVVodl5nveJ09lhcwrhqZ84eM6Bq5OtOW7oTEj1MLJ/miEoqEaphQRPEv7E/91O3I7lIVO0nAqnQkS+1LMlVIGjvkXETTuN6a0GZCyfEasvgIDQMBpBBhSof+Hs2kYyA9VZsKSQGW4tXOndweKZugS3l9J2aDoBJ2fjOi+AVx79qCr5IaFnwv3JJRTKXCK1qABFMyPEsSIscBnvvZW4UHIeDVtIex5AWvwZtMxf8Ua/mxvjpTHzHcT+kgJeb5KxC+hl721LpCQ+k7fSAr3XNcQf0Gbe3DJeH/Fj66a5MDOdNtGpyFQ2cUVtGMcZrpyztCFlYDlBwdXMcXiI+pdwPuXupKWogl2aIlgZvESy8Q2b9RppvBDB8zlyyIV94d1mM0pK1RF+L0lzYBlSeevomB6PdPM2lCctInSiLaErRtB1Yhupt4OZ8bWdFatMGO/0gqSGam5aG+NqU4moXAwvzqUhGNfOdr9gbhSEYvPHYY78+Re3jm3F8002SnF2dOaWcXxfCwvynTAvXUppjSZyCc8psDnOxCd+jF4wmYnLLlC0pYh/i00xu3sKpDp4aZKK/MqPDL0aDzmDzIgqx6vyJ5P0u/ivLYR7nwt53CtHpEAU+d76KIvcQ2xpB4cnXiR5lj/K96+wPKIAf3UVxM3d8Yk/idvnmaiVneZvyVUY/f2OzqZwvkSd4d2nA5xTO8PhH25YW2uSOTSWFefTcIrZhbePMcet1Lki8YisjyIcV5tPz24dVAWmMUZ8BKuFnVH8uZnlSSfZ/Xkk2a/n0RMYh8cKH65ItnAiKo60U90827ieKtF2Zp3VoGt1EHftnGnQt8bQahQHw4Mx3yCPln0e7tXjUV+hzrb/7WGN90uWbvJATCQfhS4XJju+QlboElaj15GmV8c332IO9Umx0i2Q6bIZnHaRp6Q8hdTJmzj5zpXDNeEo+qxjdEwOfkJRdKh6waAs37wTcCxYiX3zEs40hHLD4AwmUUOMCTuGmlEjETqXaPA6htTDzwg36SGhtZDtIVfZGhLJ+AkRjPtSza6QW9QNr0b75Di2SPtiGyuBTVkmj8PTGW+YzfP20azcI8v3B93UzclEdHIS4QtUsA/1RURPg7FRU1ivm8T0GwXc+nGT7Qsm4l5ghtLei+RZnGGUQSgird0sNDyGu9o5dNKEEJ8lQXXhNroiiihJXc2a0ljitSr4lKhJckQUDcbOyNg14nusBeejGxis0+LmtWSaJNT4HSA+UIu9mSM/BB4i76CKpUUuy4d1ce1LZ09OB3KRTSSHqOJ4rJvRZRL0zxGk5sN0ltyLwXLqP2hWiLDG+CuTcmLQmHuf1qQprHVI4Hl+LGIG49j2VwVz+3zxPzqacCkfSuI24unxjpbvcGHVZopqH5LkmIFvVRXPRk7nTpsSx87lU5jqR9iKWnqsrlIS0klKqwoN/53HYHsWTxvdOfl4Jgp1D7gxXxdunSd1YyQPLEcjr5TG6pAgaoXi8U0ai/+Wa0hOVKD+oRL9H4cIr/tFeM4QH3x3IZg4iH6IFwc9JBg6NIycvhA2ThooSIdhlv3tN55u8Y+7B9FOOqjlbuPAmxWoNknyWMmE+TaLeeJViWrZI3J3DRHDdQR2fWBrw1Vmey7HduJz0rcfwMtmJW4WzZzbMIJ15lrMePUQjbYiJnlYY6X6gYPKiUy/W8g1dU2EH8bw7c5LJHtm84/LB2SH/RAfFcJxQyXWVlxlVuw57l1/gYqVKGl9xkyoLSMw5ykX6vJJlsqm9Po+hF23o2wuhSzmBE9u5a1QGJPF7DltdJxDOY3UDingNv8B/uGLEOj4RXruZZxd17JKIYG1RVtR6s3izdazdD6OZozZcWbpxhFjac1kgzuEaEdTPmsE3g1hPGl8QO7OLswcJjBCyI1jt1O4m/eU9eYrmDEwlmifQm4I6pFnuBjBen+al5azRr6f16X/8qXDiAD7Ri7YV1OTo0bMmUL8Nr/E5X0xrbWTyND9g2XSyzDfY83z7C48IkpIUbZirOkPpukbY1N0CPmhr3x+3cGcgFI8Ty1GuLmY4TfH8XB9x+2hEiKF8wmw2o1b6l0qPC6h7+NPyQRXeqoSkf+ziftPMnjIet7dHcPujHl8DNzJ7uojjJFQZJ+0OEGOUYyQl+TKXl+GhnKwWNpCTZAm/9VM4mhGOkVnBlFLkKXNo5CoYk2qEyxIS7hPVflYJoYr4Wm5CEWLcM5Vvuf1rHTcdiShr3CRCdblDImt4m3nACf03HkXpsjXlwcYTEuk5eczlBc/QUXHBu3Zpkyt+Zd9g6IMrHJFZVo1G9MOsObcMTbNKUfBvJ68kteIyZxmitcjXKLtWbB1JwYbfhI8YRyd9ycwWNbFoiyl3/qTL1blNOzYidOJC0RotPBE6hE2my/w1jKL9aElVOuPp8F7BUrTGrglfY3ZisvY0vGGmr1nubwpj7Vh/VgIDvLx75uEz9FEO3UOTpH1mH9JYv8CbUo/X2D9mBjOadwh8c1YXARW4HC3leDD8Rz+3xn6nmkyO+Ie/vtXcbZqNoZX6qlfbs7b3bo4fTfm16Umdry0xt8phoyUvZh3X2fh4bkYZZizxUOY2Qph6CwPJfz9Jz5efsnKAUOGLb4ybVwpxVuOENW/kBf5xYwrrqJu602WF4dx0MSW2WF6KP4dxXibQyj8z58QxSmY5E7k8IKT/PVHOAlFH/hY50+RbgELOr/R4/T7ByJycbixkCWRd8gOECNmfT2yDXa4vG3gfJQMCfLROFfKIfIjDdMrs1hzthSv/XYEBcxlXLo68V0nmGzxmdltwty/pIBnkBmxMuu535fM/qbXnG6wQVJz5O+aVwi9fg2fH+7oHN/L/keJuKlvZ5nsNlj0g+f4MdhpzogtZjT/n4K7gGtq+wMAfgaIRUzQv+3DLp5g4/PKb5hgTexAxUBUjNEpG2FQbnSJ2K2AHRfO6IaBDQg8fNJsYzAa7v/s9vdzOj997QWIHBzV/5VUH3+vdzIlL0HMxh6KvK0ti9xWq+w3Wb5KFc9gtoeJyjN8f69QxZ/acWZ5YnVtpnxZNyBRvTu/6Dv+q8nwrJs+MdLOkF78jm+96RthregCVGup/1v/O74UrP/XgzJit3kmh95/w2Wvs0dbpKgsEO05/A1/1DJauimUGE1wkah9wzPXzpiQaE8sEl0pePQV/5x2P5a7k3iH+t513K84a5bwyd6lxBy7zJVdX/DYqgS7V2NV4Y8GHyZ8wVutcnae7FICehSwKmzDF8w1DH1j+4P4ffKqzrbPuFp0qJD+SMwTri+J+ozdJv1UHEsgvpU6fhrnM766d6PeXgGxYKOsrqkcf7ZrKIk+QVxrbDI5ohyH8x/Wzd5EfK0iONu0HPtt0FzLLCAWzZ3/b1MZrkl9WTlDl7jHfOH5yDL8vXrZJmFHJ/GHOFuzMsyZV1267gdxjCxC0ibBeXfdxKapxOzKCffjJDhwdm0m/w7x+xM76zdJ8DL/L7OGXSOWX9kwo6UUj/574uSS88TJ4503byrFuyes+vxzF7Exe836eyX4oP/r9XP/UYU3rddWK8H9PePM3hgQy13n37EuximdphW+w4lFkRoscREWDu07LJR2kPID9s43KMJNW0ff+vlVZZ+Q8T6FeGE6W2ydSiz5XJRfV4DfVzgvnHWfWKS3iLOhAKtJEotnhBDLp552fZSPp3j4Zx9yJjY2P3NeKx/XrXhuUXKYWLzhgYF9HuZ82RbjvlEVPva18FsunlXIlFgZEfOOU++pXGyhfdvZdQKx9cr4uLs5WLTKdGUei/jWu92LR+dgs57IT9tbFCT9LJdLjtm47PFEtVFfVc4QelZl4QWD7x71phGjckvDjVn46WQtjymPVfajA5MzsfGbsdYO4Spb2MVOzsTK2/v29V0i5twT7b6agfHqqfGvThPfcu/50JGOU5VCv4RdKhvOzrNOx6tH5D95Z0ps0L2PXyLGbzmPF7IWqMKHLKooMV5iVhTlPo5YsIVO3Ydx/ED5VAMWMYcTNWJlGh5tvs2is7WduNc0ZnwqPmMj3Kn8QXzrx3bb3k/Yy3vfmJnZxNZGBu5VH3HTnEInrxRiwbyGTPEH/HaSoRbrJrHY4dXGB+9xKu+tZ3IgMXr2ihXyDr+lZbMDXVU22dDu9BZXLN66POQkseDqeZ0jb/Cvo3NFHyyJa29XW5m/xlvLl9zTAeJbZ7f9XPoKV/SyHYIMia2ze9wNXuLFb1rnGU8iNjges1EnBSct86/oH06Mys+e60vCr+y260qVckAc180hFc9xSeKCw5r/EaPL/7XST/H0+4Yn1pcTi/U4Abcf40kxdV4PxSqrLd1/7SEuW5HjZ5RELPhme8T+Pl6lfyumMkFlG4tAq7u4pmFn0tNgYs64k78tbuP+eduNEj1V4S2+YoebeKJwefCbsyrv3Nm+Jw4b9rbelx5Q2af0+JooLDIsK7awIEZPgvvnheHHz+U5OSYq9xp4Lg7Gj5e469vMU/nJ4eUT/bG5Y/PcWRNUbs1Q13PDkSljNTVGqDzLfaSGNZ7UN6f7r1oZsci/Q3YRnJqPZUy5rfKa5WZVV2FRrE8y+wSxICPrbkk4FD+XUl2ziVHA2PTEeGjQD1XPa5ISjyn5kXwbnqYUugleEItZkkOB9yFeK+HOJCdiwQ+On9VjeBM7yi/0H5X3yc7OfQ5746xH1rKIxTF/YpyTIeaT6x9WQRsZH+3fyl0vQT3Ua7QijBiZBP1a9BpKrPpPPbMiFu+7ekDzLSRUH3liOJcYnV3uUvEOig3tTC8oWsl4T9m+7ukHUHN/eOd8msran3LdPsH5ESvPzwkiNmhYor8uFTT2H06N2K8Kr7ZfPApDcOKnpW/mEHNCF46zFQM0tEr9lC2AksN8L29Kh/SoSufBLGLjguILczJg3uYrWtMiiXdkP/iungmGprLsOhti9lIqsyYTgq7l25qvJBZ42K34mAWbjadO3zKSWF42b1V4NnjLFJcbK5uJJ8wqPpsDd9ZYL56aRCw61drDyYWH+z9Dva8qfJJSPC4PghxHyjj7iAVdu+c35cHcLU9FCwyJOT1qKz7lQ5kiXP8WixgZTmkLKoDJVOWsxO9NgCQsK8tDhSBKyR02+wWxmC6ynV8ERiXRikWXia3Nvy7vKgLnLfekH61U4RuXpaYXg4l5Q0LOMuLa0ves4BKo32lrxNUmFo0Xj9xTCgnfmes76xsBvf9L75yOBLxQUWIJJpaE67y3l4BOZlqFOJaYd+Wm3RcJ9I+f+WSukyp8y9KrK8pgRNyrZ4hLbD7TVjumDPaY2jRaLCAWFNUyPWVgrdYZydIkPn3i+9ED5TD/bu2J2XUNgB6NHWn8oRyev6lyfZVGbL2O7TDhM2TMjrZ9Ek88ofX8HNfPsE9zvGK4O7FxUj/362fQ0v9WWbCXuNbot3TJF7B7y2Uhdj1Qh9aGnlPzpiJfb1NHxvVgdhiZN+MQyu1LhDbaUQ/v7n+78pB/nXp+cftwxKuHrbN32zUPHKNe6NYMMcJ6GNQ5sHWutxdNZ58YjpLrgVVRZX46PZDuSreahiT1MCbcImEK+FGmXcNaGFk97Pq7bpKGwJsWRF/RQewG2Ok+0v4U40npNdkOMEYNMOtq6pw6FEydHeNTw3AboJzVfiFU7QItumGri3gN4HRjd7H9gC29PM+7jxE2gJ+G8mZ6mg9Vn2EwxCQ1gM3JovnjvXk0yoc2prQBpgR5jnAQCGiXSXOaGFkDvOhNOD9PHEI13r2hgdiNsHTrH8tyfgAlNAwfj4wbwafD+G3TUCB9w3GpJtrRCPRyGzuMA6icgLUGiNcIzp5jOmxwEK3hrmxhhI2wr3DNnQsogK7RoGeg5EYYtaXWpAZdogMna/1hShthWCKz0R5do9ddDx1gZI1gwvOQePr4UblH+6YhdhOov65xCTUNoD54btRHxk3gohazZbuAT10cLq1nuE2w6DjzU+4tpMv0qGrmYhN8NJkT9cSXR2sHbuhkhE0ge3QydLLgKm26KOYXk9QEK8MPBtZyrtKn+i1I+1XzNz59RAlQljfaDZC8CUYdujb3CQTSmskbxiB2M+yt2B9rzjhRfV2fhiPjZphwfmHg07Rgyn1qNBvtaAZjd7dfBUPXKPNFyqmI1wyVT3+scTET0juXHpiCRM2g55Lhr4av01tMuQtQcjMcBYbSGDxDl0178Z0pbYbXPJFeg6kv7aZhKWVkzXC3WqfWVPMsdUjbppLRbYEPo/4yydM8SO0reDLEGLXAVGqm0zSWO131MfInw22BxAVXTrMZd/qGzc1ZiNcCptwrkg1MIMX539VeRtgCvZkZUa5DXhS3UKOcSWqBrIUK6VzmBL3ByqycKW2B6c2rpe+Yc3TNyBM9jKwFrEYvilY386F3ubz5l9FthYln30WcTA+ifu/ra2eMWqEtxzhENnSSnvUfrmK4reC8qZU+Df5094fdbczFVmit3SW/6+1PfRXGkvFvhfaw3hBNP0cqbvrs6Si5FTR0Jpy8PniavrEx4hdT2goOzblT0ryvUy5Zg82MrBWGriU+X5V2nVrYE/c/xG4D+4MfHoVecqamdutqI+M2qMjlnRGlB1BZuu7NDLcNtIb2Z6/U2U//uVq1CPHaYL1u+rZvAj79xLdqOhK1gZXVYITQy4n2U7P7wSS1gfex6dlT+cHUqk3n5iNJG+xKYV7eZF2jlKL1fxhZGwQU7cwpRxeoiK6nxYyuFMrP/G3A8ePTv/J2VjJGUjg5YnJBOvKkZP9bq2C4UrB8GpH8iHGgxhwJbGQuSuFAmizFsWsfrc3cHINEUmDljT4SIvCn14+/X8MkSeGNwbqvmsiNus3Xm4QkUgiz2mvdo7aDzqI/DkdyKYypX354PecyrRbioWR0ZTAsVLZqcT+Xzg38Mw0Zy2DPGEfFM59AKmKZr5LhymBd7vcvZhBI2W19PMBclIGzW8yUTrXjtFlW77+MUAZbGlw7yy65Ut6/a8n4y2DxXa+4iayL9M3/XKcgiQxSnpVskfrYU4sza7sZmQwOXuWxVg67QF+wtulkdOVQMWqKxXPvQHq/x5UOxkgOtS8HMs/wo+nx2gODDFcOhyIKlw3haMp3W7E64smhcO9/Yj/kSzUWKsj8k8Mk55VpNcx52qZCi4WS5dAyp/4FH0Jpk8/3WEgih+5Ec/e+SwJqcLCij5HJQWz3jTdMw5WOGvw4GrHb4fjo8/5fBNepw51/+hijdpCtGDzZhxOon3Ffyf7bDi926PFcURwVt2c62f/aQVr9u653MISas3vuACNsB0eH1VXGKJQ6QK3RQ8ntcI2lLnDnx1Lvbs7vYUrbwTY48emSXhsafQnsZGTt0HLoYQLmh1P3rgRpIbYCZhwaDLUTJFLq6y6T/V8BS3FiSwYTTvl30QzDVYDDokXeDSwX6uf0+UrmogKOafFdPg3wKeqf8LFIpICFZmpUgZoDrX9iz1iUrAC1vxRLfQVh9OqdQy1MqQIUVVwTb+YaHfX8/WgkV0C2mfEOS+YynVTn0c/odkDCvCPX7JEPzT/6jKz/Dhj37h0cZkLpvbYPtNCODkj1DZrhy4+kpnf3j0G8Dij6qp31EQmoD0YHSP93gOXDl38nQAS9tvyXBkrugH9NXHh2/MvUvvyXSqa0AxbrYfY/ah7UhNfJZP11QPLOlFPn+TFUZ9KScYjdCbMuTzy6sseWmh+0iez/nbDOssqhnuVHnXgd2cBwO+FgwMv3Z5gAqtZZg8z/TtityIhPEUfSDekXZYywExwW/KMYyYmnNB6m/WGSOmHDJW38jomgq+eyxyNJJ6w5W2V/UhxL15nKdZG8E6bsujw6gB9NlW2p0kNsJay4d8reRsOa8pg77H/IWAkjl8wsKcFR9FZeZSvDVcL328OGOagF0I93H5UxF5WgdzJfpx7HU3rs+vFIpASRLMkn2/saFWaar46SlSDWwqNGmCXS9ESLqUiihPmbZvcv8Imh/9/FXUBFlf5/HL9DDtI1LD10t0HcZxns7u1VWf8uYK2DW4QxNjZ2Hpe1679rO8h9dDh2jz1YjEnYiqyOrvyeBz5zDmcVuPd1vpOn4/m+Zxdpa5pevM20GvlMc3DSUmkI4Xvo6GOUpJHOXr+aBu6CBYP4qYrtpevggkh65Lerd25fhHUBJIrvqVfDgkF6kP7NysUvzJakmUvY3noTbEigG+Iacn5xrsH7xdKjfI89ENa5E+uL9TOnJsCJqXQg32vPNM8F+vHcjXa0H1ySQF7xPfdhsNGSdB+7Y3eoGtZH0FS+966BhTuS4L8ztbzU7AdiQfMevNnPpGz9b3bFu2GVkqTwvfhKWCgT289sGj7qMlwaTjP4nvx92GhBa48umj7rDfx1KO3ry/bmrWrx/BTiY3vp/y97mO1MJp1ne/RhsC6I6juWB/RuD+ujyP4zbK++G+zSjUjf/eHV8BWcHUz+XsT27PPgY8l02YakqjOFsBBCtT+yvfs5sCaaCl8XbNSvgdn3DVnP9/DhyBRi8r5+yPowvK8jmdaJ7eVfhPXxtHeOfOgoI9xfSW0L2J7+KzgykjjFRuo/WaC3s8uPLud7+x6w0Zq+T9g+6GgYrHor9jzB9vg7wEov8tfKYTHa7rBgR8/yvf5v4bwwEjTut9V3RsP69jSa7/lPhAUZ3RBS9DBlodlxxMqG7f2XwRtT6eymQX0q9sDftyPfveIdAFgbTo5re3n/ch0WnkoLeBegFtZ7EYs3tvOHmmCVgvThnQAHcz/prdSoXfCsKAA22pGIeNYNSIQN0WRIm66a0x3hlz50De8IfAFn2xP34Q1zeubCJalkC+8KFMJKVzI/vnLQp7mwzoZc/sg6A+tgbRTVjmsX9GgXrI4hU3h34CgsVImaCDG96ZrZD8UNl3mHAC6Npblvgh/3/gD3V5DSg6xL4IS+1dUEsm326jEXlLDajfTyYZ2CFLhbH1LT7aDn9K5waipt7hZ8AwsrxVHHX0X9NAbWtyH9ecdgMqy5K+7pEfF63mJYZ0UteddgE6x2pDnjVh80auFSR9LEOwfn4DILMu7PN0dHVsMFgVTrz7oHr81zF1q3J+uHSBv0xFSu1NjcQYCN9uT5CFOVXxyssqMJvIuggvVO1PNfU0G3wXBOGjmrZ52EXNjFhx6oLJm9tbjFmi5f0xTeTViIeXcfWn1swFeqDbBwVlzKOwoHYZWMzFaMjXc+Cytfim7HWFehGs5+I2bs+O47zzdwqQ2VeGfB9hm+nx0xnZLHDPKFjZ50xhzWXUiAI/2J5foz9ac6wWUysqi5wwAL1eKfj4fX/jbGPLekfXmXQQMbHGhpdlP+kGWwrkH8i3catsGlTWLYtPTrEw7DmjqxC+82XIGVb6Uj1n4jrtXAan/6dDXrOHyEPRR06ETv0bmu6OV1tyc1G1jXIRy+oCLfP1dkpGTAeQ5kH+889IcT7Wje2NzQtB9h4ZHUmXcfiuB3tjT84PnfCxfC6jdSbXMHAtY/Eh+emTCzoRz2URDHPNaFuAj3fyt6zPhs/faHsOqE6M47ESZY81yyyTrgt9YZnYcSk/R/5awbEQaXxtJfx9/pfjodFraLobwj0R9+2SD927mkMDkH1pwRU3lXohiWTOJUMdTCsAjOviot4J2JLbCDPXW9trj9IQobddJS3p240mLNXRf6PCR6dFUd5p2ei/89V3RY+tbkYw+r9kqWvEulgL3c6FSLDI+8IFh1SBzDO1Wx8MoX4pkK1/irHWDVSWk271Z1ghMNYu7gxvHD+sKZPvRb3rH6Bp5uQZcFik5tfoSzX4k+/7CulRoO9SRxW8fHXC2Gy+okPe9czYJVj8VTtjmNdDFcINDm7tU6WFgpJaYFrjm5DS5rEj+W8A4WfMokzRnzsMsrHayrEhXdWRfrHKy0JoYhaSEZBlhvkt7wTtYDeKcv2bytetimF3CtFX15mXWzPsCJjrRXyI3IRFv0Tvu/Er/jHS13WHgqvo8euuNWACwpyDXe1YqGVbXiRKvXHlvbw3onWsc7Wx1hY62YmtRvybK+sOqJmM+7W9/Cidak+mj+4I05cKolcR3IO1zw1UjyR8WymVcnwXpruoR3uebAJX40Z0iHr8NXwC9dyRbe6doAd3chD2a5v1v1N5zWjQ4ewrpdFfDDUNLJL3JZwilY2Ybu4R2vq7DmgZik2je0xgjr6sVU3vV6BpfKyD/nU6dXvocLfOnC+azzZYO+79I4ErC1oN1hN1gwiFl3WPcrEG4bQ0LcC9ffiYHfeZOaH3gHDD7lTSM8pn4I7AInWhAL3gUbAHd3p7suBOTPGAqr3YhiIuuEjYb1rsTZ6N/WqQB+nkQ+592w6bDOgyZWLPr10CLY4E7tqllHbB28S07WOF3KmbMDnhBM02+yrpgWZr3i9z6/p006DmtcaJUF64xdhvVOtNBzRODyaljZIF2MZ92xp/DKUBpcQntefg8nKmjYAd4hQ5+6fTK13/T8WbJHizXVaqq9wbpkQZh3D6br67ZmaOPhlWE0x4t1ykRYH0AiTA9yhveAhduSM++WfQkbEml5yd31SSPgU8EkbTvrmOXD2Ury6ZeAkPDJZitoKu+azYONbejRz/N9Vavh8Z2psox1zrbASjlZ9tPTI5P3w5rPyWvePTtq9gsx+N6zzo/0cJkXrWjuoMGJ4eRcX79q9VN4c3c6bxLropng2yKtKMs9GixHL10bRpbxTpoC1gWQrl3tIj6EwNnuVLmNddOS4JUh5En59ExTJiyYRG/eUesL6xol2eUtHZXfm21PFbyrNgrWuNHwlLk5YwtgYyIReGdtJqyKo1Z/L753bymsdCDjeXdtA9w/gMq0Y+sn7oY1tuReFO+wme1Okyu9tFkXzBbILd5luw2rY8nyHYYpcU9gox+1iGOdtvew0ptUJnWZnCV/i88vp9G826aABZNUPyCzdmIYLO9JbvZlHbe2sCGc+uxsbLjfEe6cTG8tZV23AbDYnYx2rbujzoZ3hZK7UazzNg7+Nos4Hbt/K2ISbIyi43j3bT4sD6G97Zsi5Gvhp31IRHMHDhaOSQ1FWz+4HoLlicSed+FOw6fCaeaCVaVdDPDqruSeknXiamCVLz3z5LZyQyOs9iJa3o2zbmzxu3Di+c/5x9GesCAjSbwjFwrrPen+KG//Oylmu1F33pXrBGvqJdMC6VP5QDg7kq5IYZ254fCnfLIgWX6yMh9WdqCTeHduCqx5LOYvXbe7oRQuiKLIgxz5T3/hiJClvzJFbm+weDdSkL0LFGTKUYLMWinI9Mz8PpzdG9g9f/hDdpXhwLb5oK01DtratjpwrhrV8ji71o/DwXZ7HIjnr92dvfZDvPYvzI44RO/MfvnnGats+QxF7Jo9quV+FrvPG9XynK3sygMYrq0CGB6jBZk7v2L5gj+nDM/n81N4jgLP4fNdbL4V81rMvVrNj7eay0e3zD9rNb+OOb+vafVeLE2i+h+tJIww";
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
