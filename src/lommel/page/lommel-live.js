// Made by `make page` with ziglang==0.17.0; SHA-256 of the sources: 685d769d3689ba541c25bce5caf9c2869cd8aa774ef67cbb7591883545efbadd
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
const wasmText = "eNq0V3dAG9f9f+t0Jz1JpxqlxqV1TxeaZi+T5QUi8soydp09MLVxDN6At0DEOJS6Oxt3CZHVkT07HLxH9t57z67sgfl93rvjEBl//t6hu+/7js/7rvfuIHXNiyghhN5kddDZhMwWOQwyO4S7Jgz/SfWP5mYT/FguR7OzuRLg3qbYPAuekoDFslqczWY9LV+AOwVH3TBXQnA1Q6nTNo3S1gbayvnD90fbZwnWbgMDK3nweGhHs54fSiOMCabFMUDJ9JTAAwUyq/W1vTIDvKG5IPQ8q9zTa2ch9IC01NLW2l74BkTjB0sJX9MoZmj1YCEYksAEjgTyVuKJle/Fyyg70/Nbc0BoM8XnHs9fzPCT4WfFDwzq3tOX+Jaeo0y7pZfxM68z6HsI2l8kyLVS82U53w1flA1y7esHuQ68w9CrDVmB1I3htQ1kHq6hVgqe4IPA0ApBQBok7IFkg7QFgfi5tDTRqlAjuWCA75uBDPukUjcDbsjj+bX2YoXcR6PZwExNfLjBSDWC//QbB2O4om6tYC1Qvm0bhpYFKKB8S2wQr++CntPgQfp1+vw0Zr0Fgk4AsO4VPDDHhmvz1tBRBY3tJdovWutspu+hYDHaqpitYLKp/Nsr65obapsX1y1tnr+kpXZpU/2KhvqVR8TnLFwyZ0FtS8Oi+trz61tIOLRwyaJF9QtNaDW11C8mEZ8h5tU1LCSS/zHWHSMkGovbduJbiREJNQxh2/FwiBi2kLa0EiXJ5Ih9vg0BIcKI2yPj8VJhy1GGITDipZRyzhhm/h+YNsYIwFi01PJutvxOFAskyr47IkGgQgyiBh7BkKXEsIQ/sLJlfU9SKUGP/n7cSbngWfua5T/YT/xwfzH6AGEfeNBBElAHO/IQeaiUJcZhhxxuwV2+334lJSPMkiNGldhS2kcKNubwEbaoEGNKj7IwwKQIjWJNYRMjJIU04oaQApQQpQax1U8iGMWU/j0+7OHfvzT5OoNvuGMcbY8UWOcYcSyyX37cyJF67dFjIRpHhRg75IsNSiAhTEhCxlsUfkrFp0cgJ9KigiIaGywIDLtkAkXgxmESv4QHQuwKShE6WNZYWTrRLTWMSlEpqsamZSXwjiip5pZ1vG1kDMOyKJVxWgr/4WhcqiHsUsDgTxJbDaDuzy06ybJKuHmkZdLJU5JJanHOjanTTkhm6IQTTzp57KhTOJ1eM0rOsGfS+Pdsq+RHo+Pl1nR0A9EJoKVeDyXNpE1hT+XgquPLRamcpSMip2odWybHKyJuiYnSVl5Q5IhzmByqTaK2WXIap9y0yk+UJ44eXVIy2jpVMsagcboXSvwMU1oV9Ew7LuLH2zZ3zjrbOiduW3pMPXfq2erPsKaeV5ukai2JhNm01AaN9FNZUS7lCFUQ1Z5i9vSKeLzO+vH0ElOWU8lRm6HmsS0OX846h5mW9qBGe8BPFHPsufG4JfEnrHrbkmAyyyqN0zilNK4BLEOwZHLeObXTLXr+WSE07OiSEeUTJnAdbalGMqykqqbnHMojJhqHJQ1iGcVcYRz25ekEdAGfn+Tn1DbQsxwvO41+rMJK8gVyoVVlU2GfLKUKBXztE7M4G0kZHQPH5YzySSWLhFhcMnbsqFFy/zGm3H9c0rRMZDGZlDITz5gZKm3zVOwvM24Oa6caNJTuX9XAlqihcRW0JLrNEQiPl/oJUZeqwGABQGbmSvhDSqVh0yECY/Toke7IkRZGpSV1Dq0lyaWHT5VYKZnBYlhar7C/qEgmk8smNlljLQR66Im0WdrHWjOErMECwIQHEqggeAvgCUUaVJshEQoA3iw3hI8GXM2TKjYwoQVNX22F4tk4O9GqJSUl0lQuF7W4AhccQ/EBP0aKMWM845W0dKWXLdPDp0OxClzEQnwT6arV1hrPEaoStXRqMlOxbKKFQdVCx1jo+CBXHnKVqFi7X/YYE0GdWVHVWiEo5JhAwz+wht01OFFL0niN5GOUo4LaIzlKg2XakBLLbstZuoEkkPQDVVSrlSIvXpFh4vuhnWinY0SpGGRZg0+bGPGa6KyEHhfQdRS3RKsw6VK6C5chKFnHQkebOZpub2+3ZI6k25++QD+JnjzmTS7xn5u3ekrbH8fc/BXbJ7SoftGSptWMyNqGxQ0tDXULG9bUEyGalixZRLppuLm+pXZhw/nzW8jvvMmKusX1zeRKypc2zyNXUTlneUttc/2cJYvnNpPrqVQqcxqa5iyE0q006pG19U1NS5rIVhpfsrgWBoHGNhpbXF/XVAvzlqa65hZyLw0reVN93Zz55CEaUfq+7iM03FQ3t2F5c+2SeeRJGvdt1Hu+YU49eYpaAcqrVPx44fIm8i6NaH/qFtU31ZFrosbc+qUt88lfopo9r2FhS30TuS0a8qk7o+FPGSVpKnfScRPHT6iaMqm6cnLm+Kkn4OA+ZXrNjJk/mrX8z/Qv9KfifuNB43HxgngmtCv0B/N98zPzRetl6xnrDnmnfEQ+Kn9FL6aX0svpenYh62Rd7Kfs5/TX7Lfs9+wPrMB62ZXsWvZn9hd2A7uJ3cxuZ3ewO9k/2V2sj21j29kOtofdw+5l97H72QPsEfYoe4w9xZ5hz7IX2UvsZfY6e4O9yd5l77F/sf+x99kH7Lfid+L34pw/io/FgGg3LjA6jN8YFxkXG5cavcaVxlXGNcZfjeuM640bjE3GdmOHsdPYbbxuvGG8abxtXBm6KnR16NrQm6G3Qm+H3g3dbN5i3mrebm4xt5rbzB3mE+aT5lPmM+br5hvmm+bb5nrrQqvT+on1tvWO9a71L+uq8NXha8J/Ct8SuTVyW+SOyM7IrsjuyN2RpyPPRJ6NPBf5IPJh5KPIJ5ErZLfcKH8nN0R/Hv1F9NfRi6IXRy+LXhHtjvZGr4pGrv6f2x2rJInmxMrE6sSaxNpENtGaaEu066ZH63fQxHqauJAmOmniJzTRRRM/pYnPaeILmuiniUI0sSEm9yWsKk32Z5sfv6CLTIoRItMo6NHePNGBTULk9RRKrMrBnrGmxohDMkSPF3OFFNH8AXs6+DR9warGFI0yOVwFgv6R+jatLL1uqVKhUmufUIQ2mw+i3bn0ZI22x/RVh6lA8J/5+nZiWfoiGypQUD6YjddVV3T2FeQTlknbWI62cf3jbUAlm1xeXdF1jSvg7DLXKA7j+IIv9ETpdGO6PeEYZSlDKn82uSFtaWqxpVwrtgwFlmHfMlyWspQl2+RGtKX0xLBkxZaRr7MMS51rI73XVtmxIJ8a80IsOCxvSyecvndlYyoKpbAWAnVQ6kTT95iTy6AkALcsFXNM/TQdqZ/CiVTTzuq9A3rYHdXt3kisT0WcEESIxumqhoxoGV3vxh2u+FwZwcK126Do0yHIvqTO27JuAkwn7oB0QMLWCTk2+FCfdV02FdcBRh3DsRrTVyxpdI0FrpWmCARsK115IiKKONZ1nSnuRNKbkYMF13WlIlGmQv85Qje0XlWjymg1SXFINGeAnAwGTYXAjPsC9XDi6XaqUFy7E66Er3MTXeuVT53VZOZ161MhOJvoSsXRap5jU+BBNGU4kRSHfUTzgZ+eruADHpzzfePKX3jaCJ9tJXW4Y3vYHKbe5ZhOrNkNOwLo0I9noRQKksIVIOjWlK2U4VGk1dGyVuQ+dzps7BR8TwmliLpOTolq8FoRbQ6EWq5MmXPp8Bo0DND5ajdyTTrX6CLiOCKv3kKAqkOP+6Fzx1B+pwyg6nVDNVgptNrlkMcobGiXunVANZ1LhaOsuBPhn4+PWiHVWB/LirK/pZhqYSe8ALtp20r0MaaKmqKowS2wLdgLMHHRxXVYmlejsWpiTIFhWXXrWu+1KcZmgg7z13CZanjS4zIf5z9mASik4EDQo3eDkbgQRgSeQgcKAwPfryjc/o8hfRtO42q31LpmR00Znu2rOoYWSTHYDuLI4yjNpdFQam9PUqFwHCz7MyRkMnJF0qIxhTBURiBmUSKRLF0Q+TGjLKcSnM5pPeW8Q6Yh7DR1aItLVVZPLHMpjM93SYxgGaJrknYcsgBqAwN8WboVhunYNNWG4NN0R7toTCdWKCPoXFcNpY7Oa1IUDvoWrMVl+7Mbn8Bp7hL4DPf0pBHWiRaHNKazjYjgaASBPKXhRRUUtSidUydJNXUCYC9yhYmov3hcYVJgQlVPGpEzWgRIbQnRbi3SPsFKz/xwvCh1Vsigjyqv8IIBf4AfrZmY6VyklWssjRXYtBjyBydTRDoqdbzRD+BLMyJbqEDJdD/qMhFFHEKIC1fVQ+3GNE0ZqCRPD9BlqJtjqBt1jEaclwQPvUsoNonDPUuhLQEmlS48y6GKYE8r0/0i3wgZNEeztI3meHbfdgxkdIFLyzWp9xn8Q7v7nfhJLsUQ4GBf9qXQG4OTAagpi+Dy32WOenVgmMtckf70wV+sE+rcFOmtzz65l58coyBv3rF1gE9HLPoA4Rrzxb3Vh77el0+xzIrxq4/693FvT0ghNpwq6l0HG+yxAVO9fglcMiVMyY9iIZj++7jPYNpZNRcBD/qm3A5Jz+pVjqJ4AgyAEoAKCcu96w6qn7LPx5WFwf1e6ZCr818wV9zhDrlRQHpR6cDFQh7gTA45XVnk9Cbg54BPtdPIQ+Wgy1y3wO3HsigaPKor6OEwXEaPS3pwTxlSFSDwp+CGCtiRwZU5ZFt48R39G+4qZI6b+Xrn3Q88ODFfyNzxzJ//MOr+ZB/IC0/dOypPz6oE+UHiWxg9iutnpTLvmj5t4UB1zEKPG+rxOaWq9KFCT28hFVK+K7c1B2dWj+4CNYOPBfwcBlZQdoEejHPCqMoKREPuD1Koq8pAENmDfXNiVOuqgzEfOOinVgTfTClD4x+LFgLPEQs8bkhzS8ANTJ1QjwbE4VrwF0PGQvmeQMOXDHcS7GIX8FnoEOip1rEmlwWNn/cywIpqEyCTzYCV6thq9PYRNloUmInf/AKTL5h8W5g0p/Ycy+rdt/Zrd97QHmLVipl/IP9e5ZkoA6be+KQvp159JGjm3hRBJ0NhwBsfD5DTYtxrvmKrWV4xe4YZck8L29Xladqi9uweU21V7u21ZTE+vGM5TIb2kfBXePDJG97qy50VI0MiQzdLUYINxKTPhZfv+kEjVkuu0B/koSK0wOMXL762dxsBnqpDcfEwHSpHjx/0Cxdf27GZnFbmGL0pZIKrHbcs/YctGwc4Gsjp9NXsjvV9RbVEI9+htpoRbGFVdYF5sOnVekFIVfle1xi+MQuu6RhoFFc4ouAa/UnXckS/Sx0LKH/cuerB8MZtlYX+pFLKZGZOfGHEf7diPzzP77ls7uRd2J/Q7Y/esOqX39ux7N7KMy92Lymf9nBl/39o///AF59d3t3d/VTlxaeq8ZrPd61+uI4bzefhoNmTRyjDGo/I5zjj6LKig1D1VLfLA476mKHdrggYw497FeaPlYpD1UM4XP3mukYZZIo2ytyhWiswmKAcoFQNM/eOy837Q/71WhzHJJju/G7Bpaqbgrn3RZToVG7/EcjBVXD5Rs2GfCOc4coTpLnHY+bV1BG+So+yyPf2BLC9turqwD9nznAver/kRe//jxcFW2qYYnDqBNdXwaFcDI5pETgsAO69wB+mjBWVtzJF9aExvCCk26v6puJ3MU9vefaKAR5s8P/htUgdltigFtFpAMrwM7F3aI6AON7gV6wX2irzs+e+s88857LN+cQV6pDzFTfnCkNUiqI1VSI8FbfoqCa9+aGdJH/BOG1jOBy9048We828s2iad4DBDf+U1HwCdvri//Y/ylK8+MipOb7wZRh8GyjNe6AJPZjzxY5/QlD/oMTI4ZjQG9oR8BHbWm/xAnbwE++9+ii5Ue3gp2a8cdc9mTf78mBDsPXxaSfM/u+nEDjl/7noxf33QpC56PU6+3W+tzKfB9YmjZ/t0A8r2+cqTNV4Ro9CyKtEgwNKbWYidwuh3hbsm7/QcJoOryxykRc6R5nSQzKzPk99WjlI9OEEzJ1apnd1mf/lDgwO43/vVd2gJ8BW/UCizD9DT4yxLx/+EKGxtAu+zb0DykaTv2wX04teTZ/05YfoyqIPELx40iwlolxqsyuAEJhBITALlCmUmQzkDlFMDiaVuiO+xpJUaUuSElpFlxEfUo5/ZQ5b2Hhw5tZCXyGzsf/5mYc8f50q2aKNLTf878ZbFLns2/vu3bnsn4rc/s4VOIf3gEyp434I41tPu6+Mve7XCO2d2IryE9f+qRLaMyY8mJ8Xu0mRi52Tdtw36Q5FDnSQi8qnbVVk7FQ1HgOZCg0V4WT9ecxbXF2HLtJ4EFfdbuLjpQCd/CCvB+es/l7a6NVUV9MJVHu+8i54TwjvS5+u/catpSo4uJ/as40OvaapuI+C2i09FpvPp4n3NaHPWt+2XQEV7/Duoq9A+BxcmfDH/bGXJjAAd91Ml7/472kqMeN+Nf+2/dddqVJ+aqYrfuqWPYrbuuQdPuLxRzVXjx3gBkDrLjr0ph133gKgM+kvyhaGXld6uzec+bvXDiRVIE88ZMN3fziWb84Paz/u4CwW2uubX//ngEp+EKsjcPGC/0FonpMcs9/Vv/lnHjlXpzTFPxxltvS134K2t7OXdugtne/5P2quAjqS5MhWZWZRZ7dUA883d/L5suvIzF6mMoyfjhaOGcwtwzLqZmY94zEzs0Z7dwvPY2Y8ZmZmRjPr+eJHZGZXqbu1GvPubKurMiMjI35EQv0sKbQ4h4SRciecoeKbWBuuzQYpP7ERFWx09EosgeQFkzgag6u8ydjaLykMRfNAxF7DRFBkexFgDQCF7UXAOKAVygPgAbpQHtAPOFJ5k9NeZNPRz/SmzQ1+on1OniHdsMFN108t4WJieXAqYjeR4gtSrpd0LDlKYxS7M0g3B1/baKehhZA0QBHXi5BMvoxIGkbSMJLTrEPa8YoXHRtr8vrGI0f+CXNmN9mQInAuOkbXixzTXyHHMHlFT+DVdKrozxQUpywOLHhFTTOnsUZ+tQePxrfMHUKtnUWkHPNd9aQ19dPII89KMXGVHX+wOXa6LnnKBsHV3vc09csgodrE/nyqsANAa6GxUvpcO7mbJg03E3G2JgcSD86edrNToN7MhFcPhe2dcHCq1eDeVKDIQH85Fbi39oPoiVp6Rkw5fC1b31j3CbyohJgt0TPD4QUlcmftm4MH+Ef+uvTkIdm2YEOOR84uKqCqkrHpgMAHMU73cQJrogGIYdZOtzSrJP5e44AmOSsheEGJEWBkOwhLa0mwXJVnGeJBNYBLTmfBcgKC8+EsZOz3MhUKrB/bfgNpbo2jD5GfCfnp0olLvL1sg2bkKSouhZXkI5lJvm2P5WvTVB8WJvGjzCTqEdGSuBrr1l+dJlU2UI6fZEHTuoPoyJPg7THVpvWL2YJsRO4te9Bc5ttjoFAgqJg5mdOgh0sNhWpC+o6lZC1CZShjEC0YuA8zCB4FZLeJyFqbfOONdEem4M2lb3wy1zzjOHYibVI/g+qSxK5SgvvcJIpYHkWAbv1CiBP2af1yuQJvmexh/fxDGOhlW7/iCGt6WF+TAmCY5KOmBJpEJ6hZbjyjcQDS5UW4k8tX8+UTerqZTUtbgw8iO6EsaUl47bImRQ16934k1P9LJD+jJykzsNs9SaMnXRuGCavYmN4kPKffZOXx+hWYCFY2gX9cAC+tb4J4r6z2Zc+rcgwp+VTrOP9T8aCOns7oAMpMSaQMVU3e3njphI42V5nSLsCsHfr2kRBEOD0rH3x4PbBHT/qezg5uXLksMkjnX0xel3T4wcozNIyVl34fDgMffKO/+x5/JIgtQZT54OcS0hD8Yec3e7Xf4xTtgq6g9d7r75slS9y4QiUW+8RVr3AVYXsz52V6EKeTTqFKRQ9cRbsFOB1bwWlp0hTQWW/imoTonJFyoGBFhcsB6DgnEIMJOEaUM1fBbyeYdPv+YhVIsUvd2u87iCDUPyOd0tXPypXLO2e+96Vn1263ofnfr6+LBQolF9DSOHCZ1/7GP/nLZ12w3qgge+3Rn/bxKdfjSlpRy3shWZLL2uzKxtxDv/PZNJwbuzl9hEJ2tsk99BGuGW42o81myVGSPfVdzTIqPvgsqth01PjXIbLR1BQZCvQHXHVis9mz0VBRtdFYt0ThscTF7nEjN8T2ZEg7d1bxyaji91kFKaip9Qb9x1sZ6rXapNaVmPJGCG3i6hYW35TijVj8Mi4O5c+L5U/z5RvNiMx6X0CtIlNkcMi4Me07rp2058um1LS/DgY0AjLNpUKOrp9ero5zTLqI2TQbixjKIoTXpW5wwpEnKSFgaeSTd3BzE0fhCYF/Mhj687hi4Hh+QNHvc6V49OtyPSR8EB7m0XzVB6OOfz8p2KRS8fex4s99RUU+39waWvfJ55zAfD2VO8KHydC76TfyfeaKk+sPvtfx9bGKRwA4ZLzF+6Q+gOWSutnAeKvs9ypMRW0iZ2gRU9WCscGDfupU+5aSIIXMg1O6dmrtJA7tD687Su7kEojxGVVCh5xMGdnfTFOzHvngUqRcGgfSBcShaJihw/4+ObzJM0eU+eD5NBxEqjG8K3t5jKVQgl3S5wNuTsg7nNojVppso8kdaZJAggpAxvK5TZd8o+c4G+/rZNP+aabxTAR/4r95T0afxjkZYSbsa8a+JD/YSUVCv3/U1X2TBaFpfwnna3L++Cacrwm3k+KYLOmdsOk27Z6ymf5hFuoPdw60QLXseFim3tHozmGZAaHZPSzDXhjEMY646KfoU+FkDsu52n7oleFxJv77gg+98s6hF57Lm6x36JXxoRcwV0CKS5w+cQKQu4xM3qQPFYx1fPbsnnfpueddyMfucZfsGOefHnFHevtRGAc1noMJZXGmpIje6fQK9KXqn16RLtKEoce6MvGif34GOhKaNwKtpJnTiP0gs6Gbv+1dqdfdkMD2tUxYH+omTeCsX94onBdjDLz215/5S3SMg4FZ34rJhicgHc+1zkeVDmP2lvO+h+lJsO74Qf52KJ4TwJMre8UbUpxSi/o2dOE9uVPY3W4ew+62fjtuZotfL8X3p83kDCvrUmylQ4MjT0MDl4Zd8jeHk/0Wh/gJ3jUo8SNpD11WvwZNmPVVaSGb3pSE+AIyjSapxuBRJmsHQc0K6oyjgXw11nNc0Ky+0hRrLr0Q65FLJ03ZXnPhSHPduGqvdaWDBpLCaV+T031O76lde1lbTkjoI5iJaEOc169k/DXbyaOigNX4gZTALnriqhVXfHZAzlF1hZrMmegLnkFKsJKnKUNfeZteTuggqaCSFZAZY81mygtpqWgvJtiCf9ZC7zbQXEnaJDFLsv8s6psalBN+5JNniddJiH4jTc3hAJ8i+Ai8DnSNFvBUAE8BPENTPIFXP5OPKhRAlHMZveayCXZabQLb6jejE3TnX7Xp+GTIp1Cq0Sp1ikGi5moyVrM+qeiTmvqkok/2RSrN4IpCPFPEM6FAplPXmnKbcxViO8DmI8a2irGtfGxZQdlYNlv8H6zwe3sGdhnhKIbOhBDnKMml2ExAN3MNvKR7Sjs4h/jhcVVFuXwCJRNAIUBQcY4CNWmMeEnNBpC3rpzmTyr5YyR/Ks6fToB/AQ/UcXzMBtjMGx0ZBX7N+cAanK+tOT3B8nL7gaWjTxNKSW8nsHr3gTXdwN4JQjxHScbVb2PfX6Ji6hpW2BhywhnvgHEp71PF8zx6TlUZ+yPeZWIk5TM1aDmNe97pvnc5QMNAhzgCmGFY5nK/1hQceyjM/Zh3SkDj4K+u8GV+4QoBEbVDBcRYXngXPYuSjijpgFLmdHdIn9z1rPv+p/Zn3XeVTOYQAB84dq7fCrXP/d0kXP5TvKqYM6OL+15O/TImWJC93je+X/SSgZP7pMnZLKEgkTJTQsPwn5MnjjWr+rdCdOmgq68EopdGRdir69muGqDb6QzJ6TS1fPwadxjrFMgpMeR5vxtNeO2z851saLSIX9qksLtRHXPklFvN6UpTV9luTSX1pKAReLiTqZDawR+QbTl1Iu9t/8Kf3Qd+pO3PHzuXfUPh6/7RROcm852DPJwDJHO961vXE9I7QICFr9gtBDACnaCzvvu7wMjsgFFOVpQS8yO/+Gf3icC88L/+Wt9u2NEC0ADRudB0rZ6FZWfssh2wK8jqatfYwUz0AnNmwNsJXbMbdPMd0MWEOJjY16Wp7kw3Khy9k28ZZph34JZv1mRRDr+EMPAzCSkMM4m8mICya7GNKyeyBDd+i5TKEmcIHvC2cSfkuwqLTCpzolPhdLezGv6aTrNgrQvWQpQmxwPgoE7XNTdsB0Q5vRGVX4e3WPc7da+kbrBKOs1LgBGx9HK8dAqQztTsGUmTpkykmFj2YXwrb42xhmHOJVWJvCqvncGZtuZHS9agOz3GJQ2brhyC6JZE8rVoIPPdYT+isFDsZyuYCUcBQ1z31wuWEFzV3XR9ukqi+wIG+qnf4BFoXYQS1lwJv41Fn/PQaXTXVtO1lSU5zuKqmGyiyahBgZjsMnkgNmJ2aJxYaxLn6eN3Q69V/P/eWNDKDqlXNPRFn0uJMo/vFf58stbokLVhO5HSD3mlGGsuc1ipxLHJ2j//I35LOmv/mS/It1/gGslGAlGd4fTWMNn2Hx0CW3VX8gbfpf8+AMDOSs7G12nqgU5LlhOrcJqq6Y5CMeQBaCYAiCyCbWTjnffcGGl1AEklNL7Sh0sKUEwwRDC6DvKrfuSmj6Az9lmZyvoAGF+XwH34eO0E3/lkXAiL3a5zQQlwlAcn4X2QJLIrWjy8kP9rRAtn8mrMIbxPb+YgUZHn+51x+P4mZ5Bw5zgTaPEj6emEBIEACAh4QGCARIl0AzxKjmQKsNBtwsCQx3ueHBARcwxhwiw1xsHUUtjYZK7A9QLjYJTzRu5snBLjMjGuhHFl37hy1jgYBubf4GTtAadghKTKTshI572uD+w5GrtGzBBQmHDXJZWAlDEkImh9E9CSSze9vGcHw4Apz1yoe5jkAU9doV0swpfX+3D2l3AYZ/TdycbMPiVNOsOu5ORCSUoNcZiF9MeElMLDGil9GkGTov4MmjdkD0SauYCa4rt2iq/gGl2lXgf2AsDwNPpSohPrDumz9laY8aU2RN2uIVTDz5voTWECmBnt1n4Qv4bCNiKa8Z+Q0LC/yV1GXxh+ucwXuNHDjEm6g32p+unQivgoP+/hW8Ls7b0zrGJFDbfuNZRVSxrXqFWMAkdcc+QFKgenoc0BJ+SVgTQl6tnpA7tOqzZFVs+MGzS7V/IgqEQz0nRPFDyQ+N2hAqCGSqyEZ7/E5a4M6l1xiSTsRCLxAbDbAEfPM8PGfiJN04j4HLyTiHfSxdv08TafL979hqeCt2AhsPcgIQ2LQYlg2ier6Hjunc68Oy4Xl4E9pcTBWNw1VRQ+CLOvOBv6eCDrggsytMJgMp0RZmAde3ffNpWeFJ80x3F5oEm83dLQME0528yl4q2M9cWhz+aknf3L9IuCwVcjArKP+trpE9Bv/zFvaUqSQg0O4ttAVi4HoWfzVtZeiFkoErl/0m2IbE/bdf4FOaHfDqOCHwuSb2Nvr5z4Vw5cUv86X3z/F1df3AIWoqBv74u+yPa+6Itv75cKjzua3itFL0/HopAHI7+65NJAZHpykLoZxedGbJvKuKfGF575h8yvcfMmPEGGx0fh2Sjzf3K200h4z+lBSQ+q14NCD8JwY0D3eohuHftKuHXsS+fWizUd4mb0YitscelP8u9IXkbC8p4LSv0r+Y0Or7WqmxtzOUTq5/mHTN3e5epWEZErL/Cf/7SbL5fJ1/Xe5i+oKTccl1yZLxmtk1Tb+Grscrz8eeFzQ1Pt0GXnRdifQz0k5LcoMKcW4TJ1eauvpHc9fpFmPpELlZjz0eSIm7iCXuu3c1RmD+v+xlfJTSGvV/0LQDe9XDznA57giUlSZawrX7E8dceV/l3WE/Sq9bLt3kY/CWVv7gbMJZ2ulIn+vvySpSx6KWDzy12951hc7mTrweMTrdrEfmsSf+0WX9irrrXqqseABzjvijat/1a2pVvL6SBSQfGZktgRjPxxxmN8nIPd4cdK3dm5Bp1NuZTnOfmtjeVmTcWPnfJYOrhwlMnhVuIqN6CvYRbEZI4pXcWCrsSZDuQSXOKzSreGmkWFC+Wk1pBOUoda44FyXAJFCW/tREkleJaohXTpWBAfFt3ZwKBF9/qnu9AxKnRQJX0t0gKTo5aFBpmh7ttupqJmse3D2wN32AO3XATuICgbSJdDsaUUESgq3U5gobEO1msEqLE9r23UG+AaQA4fqteQYlUQxGcVCqgYH5z7UVkVYCsd3wps/u9TfA3WKwwH+RMAFV1djunHaX9WU440nnwxKVHyV2NuBn/IRsYHJ0/ZuMIQgJETUsNJrUgauuUPNAxcJeCDkeZ2dJ5lmQoaV1YGAN1nuM+cHZMzwZ6RAUdGhqhoQCIGJNEAO65Q6UcTxmQpHepxBTQ7PUpP1CLpdKHRRXgNBAXKTw6mXZ7UfyfMpApH0O36ZWS1y0jreIART6U3pqsAIiRNJ8xVN68gki0atCgRBduSYLUZiCquRTnfFuJjKYoKfAFpK/qggW+l30IEGDUT5eJoE4yG0zYkOVxtLI+jkmtRzi1yV0kA8m1dVt0uDcnlsctypstStMx0OZRRE4CAkKOKFZK0bkhJPXLe45FAZ7yrXE9aWBv0iEkWcm4ELKGlZAM4dNum3xSkcjITv2RB/PrDOQYn2SF+UhviZx12jmPlR1vDw0W4SZ8cq/6AYcB90h2PUh6JJRIXf0ihQgl6Q+80FihNLUadRjNUNr6CilMe2twwwQ3LlCGHViHD9SXqUTTWrHZsNYq1pJWlr772xkJ/X1ujoQ/Kgt7Ep6ssvZBhEEpGv+W+xoiCFdoPm7m/DxSjYcvNvZKSH/LRvv4HVGIAuhKGkHtSxNPWOMXrBZrnHirAePcD2BFmsspzuzF3Ld3GQxb7T0U6PBx3Cn5NbwxW9axVctjBL9dfTZHDm+RN3qZU7OhsftIUdHjAOyP1hHFBsBSYH6kKunjVZQ8qOXtoCpdA9EoOPIr1lXjWQEQmzcBXNBZV4WYIDdV45GfdEcqd9aO+ITY4pT5HrFf6QK4HVShe1MdQEsUb5IYcoQppiskGTzdcm5GX5GMDKWovbXl5HYU5mU0b0DQ5EsMKvLlYeaMOz7aWNPFzOFJ1iVFXgEy6A6QAfzwk4MuD4xxCGuNjyS//+CqQu0uukPFW4WvIhx8FQiAvnULS4Aetl+MiuiuGIDptMh/bohkA2wGh2ljClZXaViH7su9Cmrlt0bT+UjoawP9eZ4K3Dw6ba90S0nkJvIgMHMk4TRfN0COhZApbbjGNyfhko0YwCnMe9CGyJpx6jGDlyA35fANtR66SvxlFF1zSZNSqpEyW1bIxK6Q7J4foonCZI/SxGxmPLOZUjukYc636DrJTniIkBzBC6XpZJlWUhr++w2WAaI0Mw2AasGvsv2SU2G1hwshbFZLJjslO6XggyVRww8OzDbOQTBkDOkQCZ/SlJIGX5FfqP76U4+hIHdI3mMPqUKCwsH9VMg9jmKXA0FD/hgBSmHIzLnHaZZ0p1//BHq5spEKix40QPdHaKNEb6xpKStlLGNwLVHKOmEhXGYnKP9FAwVhrVPspDej01p5x+WCa8Okz0JAZ8GvTs+cwYzstS0PZ8ME/jxTKxkqT9q0fRZpvXbD1G+nWMN0mu/VdzWjr62k40Y/jW3sd3aS4SY9v3SV1duuiMVa0klY0Kh0q30qF1r+bjodk26H1RgxEFlmSHJXVwOIvNfOTUpYXWxdRB+MBL0WQxIBZJ62n4lEVvEEHUArl4UMenvUFeHjtjh5W8LDajYcVPBxchJn8IhnebnD9zZzGStJBYYvHRWvNkk+MJUmMAd6jHxyl0FW4qo42pCR1HlqLp/JDLTQ3SyucMe0R1SbUHd1x9nxSYyw4RaOQ3CE1x9Bete2EZhVCsMaPPVBIv9sy1EESmdbSvGs9c4LiJzTLa+NapoDlNqV5MPw5uuWT4710vQ/5hTIRkFfN9vKf7CuONvvgIDBFKo92G2VSadw+pLwzHOjR4rQtu0Et5wTVIG3NFyVt3T639+JRihkZUXT6wpNu33E3OEZVqjXwc6/b9+B0vdknkVomlOvx8nSML9F+BTBhpYkAFgJ9BFDGhHHFNhzXThnHfTxYzMLBMsJg+XxxxWAxX5TBMoPrKnCltKUqmhVncP0Sjq09GEgYWIz/sgyzPSuCPsKXhl+8JIE9eG6FIlddRyl0/lPoN9yecpQjCSMGbFR7jHaNSwgrTBlnsMTbZPwaZnjRoZ4oO4Z6aoXqvKIaex0qC8vEIhvKsULBOTe47ub2/Csac1JsGaB9EGoMzDAwg4zorEdLMCNAPYAZuINRzIM6w4sbGqe+lbyaI6217MfysxJjf6VIi8P4VRQ1hzWjNTnrcGbCFhiX+K0AXUmQNOPSpsteTkHEYOmWBtoZ//yGS3zkoVSJgHbJYjmpNaST1PVIMy6BIulZSqXvstGoFraFJfFh2du1ULzrGUB3oWdUZEGV9LVIC2yOWhYaZGaMN1NZs9j44e3BO+zBWy6C14gyLujRZlwitNlOaKFxFqzPEKIm77mdR70BLwM5fKg+gxSrgiA+q1BAxfiQMkVlKuCmHd9uw800RhRzKxgg9kjfsakRraRfjGsy37GZdu0yQZ2OJEiLMNO8jcKvsLbluNTMoQsMgi4/n49V+GVlJt0wwgKF5f+Ynt9wgnTL4iO57CmVDVvMAus49YNNe05VZAG4eKEV8rFCIYg02JuSkG1Tbj2fStcdKv2fhEr/32WdH87W1QI6/Vqh0x8rdPqlC+h03afT0ayp7qGZXcKXfcTDmE8fnKmZ9KGvYRbk3FQSPJR1g0c05QokE9w4XDNRK2Is3ReTpkMv3QzASD2iqdBOKhM3dLgVMh0ltXQYNaG2lg5FctfGbVMk1kqlCHZ11DvpKBcZUwqPziKzZpc7m31gEaYHBNN6MaYHZjCVdoIgYVqyoacCUlBLimF9MwL3N9VrxaIl1JNDJLgEMVFFpSizaAKdUQuMYAJU0JpHn5eL6XMV6fMMzcSHkj2S30nt8OekB0nc58/RL6OOoewbYiiXJC38ORI+Pn5lzJSUs/y5WBBQTKYWZEKg++GDUVhKjwmzCZ0uE+mKWiToY1cE+j/3CHR1ZXutEOikdYZAn5cqVSfXszBKs/kZlUj7TloNoxquCprAiLMmcbTsqFvm+pJVyHURhkYxIyajRiAaShPpFfWo4KqgCaR4nGXKviZxU1rlYeDk8zuspX3s0EqHMljKaQ/OSq2AIum8HAdF7Se+oYhJ3tcrHcGhIIHMh3buW6hzrpGMEeqcCmdD0otcNT9yMTLJoshJVdA0lzinGEYVyFROK+nrEVxfzhDnKPH5hkHQZ86R2lKzE3WOxIHQNuocGAnm46FGsRUYgVlffTPkDnrqsJrN4c6vjdw5ZBiHEvAv4M7/ZSfu/F9RKbMRU34ulaLAnWeeO89QkPe4c1nW0W4Bd/6nhS7wNx3n8ed6G3+uv2j8ub6S449ic+WErEFYwIBKhfDncgPQ+/w5yiVGO/LnsY9iUR8STRss4oDvTKBr0LTSmBfWUUyKLoNOauYz6LE5+hbSE50uYtArYdBLxKvHoHOvcSvFFDo6DeO8nKXQMblgInpEpNA7KAiFPgtvFSn0yFYXkZwWCn3k+gGV5kC6S6HPg3zQgXypLRdx6MpjkctcZslS6pGZpCJalVEeVE7w5VQfdFl06HLZuOCJj1pDAsaWlBNNJrMGBAZuBJsrhxDJOpJHtnwgAceYxPwq8yhKvWyKMlQla6QeQ6cIbHnRS5+RADHoZ84IPkwzB9bMZM6olzmZx04JXa620eUfW6rSdY2/8jdDmkONZmrUT7dpW86Q5qWQ5gLPDGteRuBmaXPApFA5Q5sjgAXuBTOwOviCuj5tjslTaPMPFUKb7xfKnD5WQ8Yuos2Hc2izEUhmK7T5LDVG1HOCZN9a3bqwWQJJNvIkGd2kuBGSbEgk2ZCMq7FpG80nyWjwgyQT66zDyjxaRJIJ68WSrmSeevfuyAAQw+d0AGfmcoC7cO/SHd0TbnUX7smRgAWpNwikniUGD4msJBEU5m8uosXGp4SRlLCg8uzRsQ30XkNKUudxxVb6yLowassrnCvtEUP3NhLmHyw8Ya5BmJOaSJh7rhw/9jobCXORRI7R1LncJ8zrtfEemQXqQJhbjP765HgfXe/3hLkVASHM9wWidz8cBKZI4qXdhpgJ8/1jOzdhDcd9iRO26ka0mhNRg4Q1X5SEdfvdvsDqYgLVj2jTK066/cedPTY9Ttrn9oPY3S+RqgnlPeN6OrqXMdnWQphHAEuBfgpgKVx0uQ3HtVPGcb8cOiwcKUvzR8oucMVIMV+UkTKLK0ANpxDXzoD6JRxYezGKMKoY/FrG2N4VD/1yYMs1s+V7Rypy1I2NbPnAs+WWjWqfRqxWdrA7//dtigc6g8iWixUzbLn2bDksE4uslAtbDuec7bPlFu1FKLLlYobZtgzFw0Ib2PKyw5ZfG9lyadVjy6HEs+XvLrQi+kwvYMx1jzGHVk3qwE7iK6P1lClzKNQuoy+hzLl7p6Jo2WTw6RGNlgcu3DhcMxMrYizdF5OmuZduDHjNRzSqy4vlDrfSLRfV0mNUhepaehTRXVu3TZGYK5Ui2NVR76SjXGRMObW7nGN3ubPdBxahekBQrRejemAGVd1lxnKooe9TQSmoJcWwvilcIdKiNxOLStSTQyRYQkxUUSnKMjSBzqhF4DIu68PVgx22hRY69BtZNXSng+oqqpZoimrvUHvA001EImM3yxunNmzgKnFS8OAN+KBLkZcTHgV9ijzjISoUuZaG8l5q6SnyjKc4rNz2/9n7F0DJrqpOGK/zrFN1qm6d+66+dbt7ndOdpPOkgZB0QiBd2GBiQDL+dWTm05logsN3u2ESRD5GAumQAM1LW4yahEiq66KGlwZBvMirUdSooK3yiA4zBg0YBDU81KAJ/Ndvrb3PPvW43Z0QlBnp5NbZZ+999mPttddee+2111IROXbuKiJvcghnhLmPSNU1HROR3+D5HjPJ4yYFnJWnp3hCFbKb1capepqqWROy1+U1vbEN1NLb07jgnhRsEOsmNvxwsAhheFYcPWnMS1/yZD9JK+YCSF2ETbSAfL1x4VdNqfymGrDyrSmVa8ZaX7Ot3/FyLTv7ayM00ALy2o5XqO1YDNbdYjQ2uw8xIG6nB2KA6Fyfl2YZO9cS0/hr1Viql0nxDD2j4v9+a2AQlh3U0sqI6Ur1YQGjhrcPstfiW2NM5OZEMle9BZBmL9/5k/VBdtPrzG0BDcHentrES1/h+eLAx9nvq1o77MidxbYn9vZaryg8UPq+mOLspOzqJvfVDh9WNWyr8A4jqrBcriuTXuHQT8izds/g+A0sI7zlKCq90wvUfRd8MXjamFEzsLckoq403gPxV6lXQTQDec7WHHkOGnivQEO+468+U9evkA+wruR1wXWBOz5K1bytD9v26de8AE32ju/gw7UGdagjF18gEqJqn3sML3C4OJP9vb3WkQc211FrMb+0Hbjvz9Lff9o/v2XtycN9z/nZpd/4nd++/wNsFvCHzvrOm29vf//FpYXAO+HKwxkbvPul7/mjPzrjrU8a7jvr6y/5vUNvewKMDd5848WPf+CD70Twqn/86Hv+43/dhe//fy+9ci79+Z9G0IFAHYwEztDfMH115Ie8cpOXHQZIi/BWWSuKkGNulZjoSB4DOIDK14DaMj6aaO0VUIhq9B+c64BQ3goLlNF6HquGXbyeR6mW8kFYylH+YMQNTILAwfCyogEUPSa3aRhVfwvP0p/kq//XXQdhwqN/J8cj/Z4yvX/4wxzs349fzvmFd78BhTV7nOmopAx+Gykc0Uyr+OUN17m/+p+sCLuG+KWBPLr6yPSR6KM2IPdFk/MOqSlZ8cj0keijNjIELmhgp31Fw9DX39mkr4hHX+Wpff1d6St+x/sqKYO7yr4C+uIR5lYeWXrkPdW+4psmvnmYXb6b/WTBEH0epxTfKuzBvue+4SmXf7L9l+ziyrt9Pb3V84JrK9NkOGRcvfbjf/SfL/yzzzDOf/62M1/92c/8Z54oMhle8rV3fP9fbf1dnkEf/6EPsY3NM2BY8xcfgJHN69m7jRr7dLYzIwqApZeqnXzOKw4M1DKQM5IpqHyEm3OEIpv34uHgSPp6tG2UDBS++64IjhShSxabnKVjvMOLf8Dt+2du6f/3Hz60dOBD/xEtfboU/gs8B5FHeiyhfR/bc+gDn/vnO97PHl7e8a73v/Hvcszst3/PbQef+dLXc9/RcMZYNvGavrkpPlQi+FA5vnui0p/WwJAunoT3wipTpUdK1TjzbUXA3rWqZl7V/xagZV7O3/tsMZP2oM9bjP5ddxkvMCVdvO2GUK3B6SpiaUMZOFghQtwfF77th7CojJqPNR7CDr7nqVuW9l6V++TeBkVow0cHDHIYwOCHi9NbjGVttPfKSmsoWGeng29804e+4z/8zeJTBvzKDhrqeMAzw/c//R9+7OoHdzwFOe9IbuizRwVxY5E89GVOXXn3q69/3BFC6sH/9/23SapJOfW+4tfuzJBy5y8+dKSSct+RX3jnh677xz5sqV/TvaWScvGX//Qfui/4OFIOv/vvXl5JOeO/vufFrbe+HSn3XHPN/1tJufkjP/jVFz7wEqTUXrx9XyXl6V85ePnnvvhUSXnfscVKyudf+crtT3l3LCkH//ov9rqU8O5nJW975Qf3CmAW3lhJ+Z4nvu/FV/znNU05eHklJTrtH7f/dDvcW/E5kSeyJO+zScN99vOBOPgwhfBbYaH5pU1rR8r0FiNlei+RMh0ySJkOTaRMHwGkTB81pEwfaaRMxw6kTMMqTbF4aLFToJmarQ50WyoOK7G8qmFbKv3uGTvBDr3Vru+oA5Pb1JJvhUvK9g4fVP+wz2VzyS73kfIS7DB3PiCVR5wJoHqZurpgO/5+5a9bQTU++6KJ9Tn21mnZvcnst+Y1d41YCHdtOGT2geq3wgT+rVhBQqq7tma/qJsTtX5tZn9371CcZbJ13WG6Vzy2n127+UvYtXjiRRc2GfT90J/zb/YV0QHow5kCUvnBkT8nkWn6W4GfXBdf25cNAnY6h7pUgwWvg13ivG+KzV1uFo8ghnzE8Y4LGflFsjyYGsuSN8o3C5D/8JO3iBGefN87xpP3bHU8od5UQgaHviD84otrTaP33s7sg5lSz9y7rlDY9+Cbv/gnz/jhK3i8m3pcqNmVyjfXEVfnOGreWqSKQ3qEHkskNQfZT6AcREUS5YxBa3bw0ZoeIj1Vq8i3Mk+OB+KbmjFv4/C1rDxvuqCI/eRralZ97Mzsu+CyHWfPvfqBHyMXvLInhVJriOMqSoe5eGiDzhfAiu2slcM2KvxVw1zOZ6m3ZKml50231dk/BCw4z7iTy/5RY91x8dmeV9p09fBTM55yVBXRE3Ol+435hPS/wLinINtgDNn0fUExJXtAcRa4lPFwH/79g2iD2V3fhqykSgGFh6ap6dk0fZbnT+lDLbv+Zaa4C8Ue5NtMcdnLEI9NHUkPfe3jDYgd9cjm2n3HaLvxvnm77x5p95s2bbcr/s7R4vG+efFfGSn+bSdR/MZY8RvHhfofVIt/10kUf3S0eLxvXvzbRop/30kUf9do8XjfvPi7Ror/8KbFn1kzCHn4ZSOF6/sxfJd93RC61wW8i4fHS0d6xA6+EVIVgaM9nqE93zGF9kCQhUkarVGoBEUjjvqIeGslor5WLmZFZL5qrlVtvzvKgvwtzk+hoVLi3U7TKwxl6EiWI066lzUVdNb27fZ+efEfn3wfKqBQs2kuyeNVCIlKwAqfGw9C4gATgr4JYAIk37XMTXPLpsn3rL3rhdlLo2AuZXZNt9saEVZqCiHXA1k7pFRtZFaODh7eN8eMe0cw403IeqJZOVo83jcv/uBHRmblpsW/yJeTeJ2XYxXo+9HaSA1YUsX4822mBppy3s3ceYpmEJ5knrvNFEapI/N1tFq8b96vjZF+ve8kwHbXaPF437z4j40U/+GTKP7YaPF437z4+0eK/8hJFH/3aPF437z41360WvzHTqL4e0aLx/vmxd8xUvynTqL4+0aLx/vmxX94pPh7T6L4+0eLx/vmxd8zUvwXNi0+YEHzfx5hQ8KKDd9fgamv7FVGZK3mydm0Mwz0ggTJAq4qR152vfqioLDq2z0wbr7UOVl6hjM6k8yKyFoy5hJtzLu/TKXfL9qEN3rTT72swhsdvl5jbx6J/SkTe+PUvA8crsa+HrGPmLv6ZubelD3cGOnWTeMduNDzRyvxtRI/ewBcliZoqt4h8U5Y4z0jNf7sydf44etPUGNW638BhfMO7GbkTc/kJsgHua9IWrOnz35222vRstd69uM/9hzzudsd1NRkU7LLvx8F62aR+PUreFV1VHU7h5UXeXCS5TzxCZHHGbta2AIrv9siNHyRJdnrrlec9RkY5LGH/mxD0Z1P2/q//iqeMpKU3Xq9xu5c06TfgN397A0Sq/HZJ+VDNOgn9ABptyZhQr1L2gOcMAawT/d5MYJYXx9ipSs9x3okfIfu98rsvsnua3Zfs9/qj/Dr8U4N1sSTok6MB/EQoCnYRaE0ppqWp9OH4uzntR/Y56iSHBzFpTrnyEOTRLnQz96IjC1v0ySKn+JPFhxjM1vDNxJ5uyBHv4aD/sOI0yabeX8bHsbSFhqruiYPpVwAcqCAAQqwijgRmhuJskXs0PhGzwummQc396qA/+LoxZwBdvVEcIEfGG6mu4ppFALFAjteYKHUtrka1T6iWME3svKgNJzmTGyn78YIoRzn/aYIobVgHJBLayhkI8Yc94y27TYMAlOk1tiQA1obiFkrjEJrKKxhYJUlrcKHts7691TtT+NQRMWncGwR2AoCrUC32sjC4ezYDcYKtZxAqd8Q13hrBITMDT2RB0Od4wF+1i/tZf9sqRK3sNS/rTZ1szYG0oDs6/j+0R+9at1u9IYnGL1XPMqtUDyWdmTVdqyfoB1vho+kKT7xpXZQCXsxTi6KhRBMRG74ZDBiDIXcMWQEwBBCbYj/yiEM7BBSqGfyP39INjV62zI26B8JCEGTItTqqo652P2Cpga9YoteqJWr9/FFS682SqF16aRa2bHmHihmmKISqUHhgAfSsjeiQSuChmrfxKt6BXgDUv+NQPVLN1RBpbj2bwqqO27YFFRujr315EEVjoDK2wRUwTioZE0eBdUbX1sFlZkQCqzs3whYt7/2eMAaIBXOzJRZJVmhZcXzdMWD0foLgjuRmN6QNOS4n/el3kv4V/4MiO9k0tuwltLLbbn47sS3uAA4PKKXBn3egHvUgCOKAZ5MW272UPOBXLVmE8CigUWVH7DAjhty2S+iOeLOKi09l6X91oGiJq/YPaiLMSy2WGXdqlv4auodfwk0IM0CDs0gruFmDx6tYqpnv4Q60ErRPsKFlS4kywmwI5lWLpDHXuNpyYjiERZmGcPaUJM58+49vhr4Qql6K8csDg3r/+7Br0MmDoi0xOSY7gJARhv9g96atlmbC6orDb4DWTjDlJ1++6E0vJoLw/MK87zcPPU8Iq3a+vS+Qx4zqpNUrySwWD3vcGcyk4P7pKXsNk8yz8w8a5oRli98MRxUh2S+mKOU5mAvbZ5vnvWvZqUFuQPAtcUi0o7XcAxxBgNxQQogffyXXrEA4DVcBlp4vcQANzR2QT+coRla+MEeEuVic2wF2D6y5j63JIPBlETNl53h781n8ODGitoAtWTcqEMp/i6F2Yf+3mvWpIUxxZs2boFM1fkMagbSzHIr81mDO9SyRotm9viA3yx/hZ4rqBa4+AXpIdfw+nxhrPUdwI/HIOsfpLU8I48W3gvZ2lxep3mUq9fvDvKMMlDJGdXQaAcjX27A+tKDH4SqrDba1xZXa4swMzN+AKTvlTuEPL3tav1Dvs80AAc5wrsLx64ObnRv7VikItAzF28tV0VIex2kwifpJRnUqnwcP9PfjhNfLqIE10by9KyW2tFluw3A+B6C63ZhftzhmJe9Q5zW1Fm9Ik+UUDaQJ4FuNB5go3eJQ0K5UZPdifywbHaJAGIV/jD4jXWaiS/QPIs3e/+CHgnzTR3qHCiy7EHE5LNQP0e3Z1FLDZf4V3NPz5oAOUb4uaFYmCrfBui62Yd4eHiUgb/PDHI0DuAyHLzHoODSXAx1cKvHQ7ueXtT2H2CoGipdE71mjzr8ZASZwQN4lQWiQ2ZbV8wTt36eADHrsq8jtVMNCDWDRsxII4AL1DBd5CqZT5Mi+p4uWTXd/MsNvewh5LL9n62YApPH7Ol+mC8gngPn+yHwFo8YfOT7lrmq9y2rrMN5nEzhKXqOmgysISVGInz6Xj7DnBMLedzYANXNa61QEJ2hKO8w2OdpRtGN2zinzhUxxqqKA8jb7Qdi80Q0LzsyYB4GDB+FDA75JBm+W0gMQwhgEmEUa6gqxe5gggPYXAOTD40UjJsjnvdYfgFF7RnFwCqwy4JC2dcUmxiwIUeuItHlrPc/XIPPA+BoNXaPi3x9GUku8p0ayRPEbv/n0mONlCU4cqcr5CemVIA1+1rH8tc1s0yMIuFOV1S7uDsSdaQyBkBO444BP1Q09/czvXXqwVYcBeY2HL5EIBkOhzghMAuZzsemEf/edEMpIwQVeZ+8C135sARvnXKabCTFSE9x4gqWQcWxY6V9xJX2MQm+YbPS9NO0L/UTO+AysKx9J6X8c03e2ve6v/21wT/9zuEnQ3mqfOEbi21hQGRFrINdSfpSLQwFght8O0oCYwCkw0xGqTSjXIqBY9ExkAQYO9QEQ5Fn4DCkqHzWLcRzLpi44Lwu2Av4RLqQL1YSp34yx+1FA2XQFnDbtcDgte3gLdFSOXiLOniVBgHepqpiEcGjElx+WtEFtcmbtCjTsSmFUQfED7PPqlRj9nCvlzFtSi+kEbeje2At31LSLhS2hTJzFfTd+QrFlFF6AGaMqnVw8VIHrdyEGcu1hBO1UIapymWVUzUrlipe4IH+PfZ0v0rA21Ue2UTmM0cw1ZaIOZqnHi0NB0x5FlDaQnUayB4i0yV+Nu9w82cBmWMCme7TikWBTIdjE8C6+zS8gwotIVo60qElhX7vymK5l3dQG3GAY81HBmA+KF3GcRumB4OLhtTBl9y6Yp6/mj/CD/Rk/sreOqaiOyZDKGBtnCdz1oSCZ+NKbonRP9QGDQzghhwDsyiijRANVfZVrVRpJ2ZNe4g/UU3/JdXoT3ioobLSrhwqBpRwOxzAXfDK3rBI3Pxywat4drVksJyg4NfqMfYf+Ku4RTsYOEJW73/FXzOXbrJfl4kc8ODK+zDnDostUV5MN0CFnE1I9W9TpE/T67Vi+orj2/b4kjjFl+YEvDSr65o6aMvA05l/Mz/R9cN4NlhzBU+PFVr4OcGbY1N4BzJIc1mnRcLg8SksByj70g3SI7D7whTUedPhFT6et3loqooPI+2cDJBynmWbHbbnTTwgyqnL2qeN5NLNHsNPtRtobv8+f63vaXt00yWGN/OWtuEBacFXdEcl628bV6mI84TUErlDSxkEHyCEblSDWjBUnn1ZeoTCipZe12fuT0srGpxdRQtWH6WNWdY2VTZQsM6vOhjIY/40uBYzDNm7weV7ClVZxsyotHQ0Kg3FMCmAeSHYgINqGYd7MCYHJHgMV0vYTfFzqI5N9hX84Cr8qzUR+a7Scb+c6rDWcIk+GFCKaj6codWJH3v4Ady5sPYsBa0UsQc1e9lXBDChQP2e2lr2Dzr0Z3JflBLd4+chmq5dwOc6cI6mQ7FZmqKo2NRO43nIoOSN+lQgeIp7FusgQ8j+EbVORRe5f6+zPCkvHw0x3w0Oj7cL4UCn7eaqQ1hC3EnN15xazfE/wzI0cVLmPvsb3wunufnUyW43JlZUDWmvCqbNcU+oMuDLTFzEWV5gnJT0a+rEXBWfIVJWZ16ogGWgvnqD/DFse5DBSIkCjnzQSIkiYSSzfxKBWggJT7B5LaHWgjapQWP9gcSq8Pbnkd10RchnhekoElup0/3kfJMf7KuY00OJ6ocP56n6COWBtOyBG4yLTjTIOtT2sNzq0VJVbPRZ5K2l7/eDUAiyg5+20J0BGGtqElNEKJo8GGRDy83100BNt+iF00QNt8RiNQTzXYrGGFEokAKLz1li87WsUPXKIYHaWdEdZWzE/qQ70YlTAG+TU4AEeIHq+K+UiyZTTgGKRLe4oWvQRFdCNCh0DXIiyu9yGE6la08KICDr8gO7cHWsmRjZTwDs+ZXrdWcWlAsjeelP+qERzVn2frBcIr+jEoGOCKl9u524Z1tNBTDBSMRyaSZmtieQYygY2NPFxO9vLGGBDXTfnKvcExCe3IOLR8XLUeKzsl9FjIgsI93i3LbMX95mt38Sv6ca/foymqrRutFRr5pAYtRui+AuW4AE6b0e+89Vp8DgZPdd8ivvu/VLn/zxJ+/76Efw7/6LsxtvsFoz2LKLEC47P9hDErObauUxCCEs9AL7LUUUi9BwhCaYKWjPSHsAx1g8zJdg0sHNrHqsP7CGvE9Xx4BZUQcLIZJbnO/96Jo1CakGacpjkstdByjcqDCsPdZFfRbV0g+HAfZ31ZPlyJ7/mrWvJnxqHuNBeR2xe/IE8hvpzVTmpAtC7/g3EHrZcoLN3RDZUL8rbJa7DxD2DL/FjUBSBOfC2Hhn/9MgSiRfiaS6JNyATvYphIynxUJAubswhhJJJW96BZz4oohvlb8IjI9VDetSLIVn12NMhRKgIEXZCDNoldP5sUARNocteQS70CY5yuoidLrfhcQZcbuAXGWInJq1U/02gZ17933hP2xse/nn//hiirKXKWERob06rcyKhnalq6Z8ct8afDwcFKEI/XkDBt1sLLiwJxeqfi9OhqGB2wVbhAUOzyPDUkdufQBxppme6Ck24HLRPO7fHDAOGsGE66OC6AYBUVRRFEhf7eMqqCUcx2ojtIg8sMvDgsvehQG9f1EMvYib12A69mjybgoA5EsogPdybsA+Cd2F2b8XQcGGPQg9VPP38IcJwgLxcysQp5DxDBD+Dxv/yPeJJuGuZPHPX2O4fcp9PLq53lDOcfhyzHlx5cIufO3uv/yJ//FjT4a245n/75tOP7N3BYe9Db4g9DDVXgYepKEvndTr8JVi44vs15T2qS5M9m5zqhKIrEziKICgDIRCaD33mKUhSFAISm54vg7u0tMHACzoMsCO4V3t757FVZ5lNWycGkj6i42mXRgy3TddWxnro/WKR2XUlVUFu4GJVPyvCoYYp+Q0R2ctFbHKMtTFmCMcsvq9K+L9Cz+P8rPJz4/wM+Xn/eEa46VYxvgCb3HaOGbn5ww/b/JZvsbPAT8zfh7i5yw/j3mwy5XPcfBuLmVesB+r7AKH7uCYRc2EqCUOHo6kimXk5yW6i/Wtf2cd9Cl2O0QEcftJu7blguCOOlauO+v5CsoI3O4AJeLjlb5HWzQt25C1rpe9B0/tFvWy38Bb5fsPy/ddBXF36rQBoq+c5x/zKET1t0XFKsuuPFpy1SM90+Q7IlplqshtLba4+6M9kLgF9wFqV5AIqLjRPo8cFBxQxt2wsMHL9Xu16eWBJZqg3wIT5kiyY469Dxm5U4B2fQ11IdgR4easZoOI8/2araY1Zx8wxWcs9AXBel/dUf/OlLiZKXHtiTg1leDsMIgpxS3cw1jNdQ2HxdYhBO6Zginfgi7fE+QMNhDffBvi7wvz7bLQ9zeuw3Z1w1yPJi2faKv6xhgOifbdcNfvPXf3f7334soNTdpO22gVf5f1NsqbcjbDd+8dEDepkh8tHDi5zZAj5Hop5+P7iWguGbz6oIV16zxurYk8asCxUol7vYmbd3El2NIpcc1K3IdMXGNK3OKUb5enxPUm26KzjOMjnTKaF/JvrEt1WZdAEepuDXpyle7asyRVApymjTd6/pSmF8teQ7eE/1tmpPsqLGoqLPHMqQ8zNHr8gnRpTPqHnqhbT2ibkdy5P1Tqqy5ojS0x6Ey+cYyMH7HWQsGBwh6f/wy+mqqDXX8oBZ9JeO4yz65qkXGPsEJSADRW8YvOJOH3QOi/Fxqz4tR/Q3Z9VMt+9pCBrgPnv0R+OrqkVxQgmCEvScYP6UYXTDnVTE+NkW9ftm4COtVKrMF8Y0QB4nGqsZ01In6UucJLDHRj8XNNkbLJHg4mfk61WqJNvvxuAN8o7lNoBIpQFIrxwNrtKaMG/gmTHECWklW4rpqFezTXbvLsUfoDH7wOXyGjbML8vVWlCxVd4VaYfL5TPvdXwZaJWKpoqklt43Yc5KVscZFKb7WbLe10wg9FKO2vuEXGSSK4t+x/guFS05exNIC4+GCyXMBCz7biVMvt6oT4XnVdH/NfhJoR13XyAAbJCyk6gHYrTQYAqb7G1YiJUj10qQsA8kBGP28DY8EhedJGcRIvTUafEFoQ0g/4UShO1loUUF2hLyZN0M+8hbouwelyHQarqM1ksq6HbeixbNMj0ayRfqj8zlaUaEkPyDg2kKtRHSTUZT9IwMDjq+yDAKb6nNbhVZLDmRyPlw4Dr1EVAU1M5QDywVXw2hTorA5kVvf1wk5N0Z0TrV9zdSkb93V/HyBhtfCgDaTiCHWUJnwizMOvqvc79JTH1/tRJlt5UwttcWxgtwWBFUALGZKjYsEPFjajRxkIVMOek0gQOrLX4ZqHT01n4QXme7IBuiZlw9KYp6gUoZxWX7w7rWGZq13SW6O6Mw1f7agFuRSiJbRyflWl3SMof6wTIKxmy6JEsO9fCiGMabsSVwrU4XfFbk2Qfipm4xnN65S0HfMq51RV1h/nbT/ziVPvS8+Z5fO2ghVq75KpBoll5eojXEfVsvcKTjaVZ72c3PWgDT4giak5GBRsMPNuT3cfwyIetbsBRhpbBq5iSFIiUMqUGgo/wB9jWzY0BaXciBcv/PJ3fvrHb2Jet2mkXbp8NeUG5cZ6Lqi/T6fKnryNx1n5DB6Ud1Ril+GxkM/2R8/42ELQfLDXRYQ4VqI5iAoX1opF8Yemqk/XYbznMaJiOTCjBWaJRz6UAergAJ4/W1NaAYYJgKAZci+D26ldeaXWSNqA/I31Ab9EV7U9WlTRIUyuYs+FcYfYjn9KSh7CZsw8QyLHiVQ44OGdA97NkWfUpgyNgxLIqDR7DIQ3eQrDQ54C8VoF4tUKxGcpEK8aB2LzUQdi/GiAcfhw4fi9FTg2AcfmKBzVSSxwXBDzl5thi3d6cWWnVyt3eo6FgRx4uggIy0jVuEcZPnfv+hseDAqh6vGGXIkOIXfYg7mD9R/MHyR5u7l8n8NnramAPPtf2KAXdVSJWHGUZ9RMEENrMhk0RjaMCxrTD9ZMZFPYgJw7KxtH66xWXYaKhx3nfRrDyKiDU+0Z0LURjTYeyBmwbkN3t3AGq9XM6N1Fd1VARevYmyqT1uLv4wMUlqf8Y+kwUeyvjWYxR92as1O2Bof9irXOLwZ1OF9L1FwwEeZULLih2i79JK+rzpyQbbXG5pHPYySAUEwbDrL3CeXy1HPpzBp5cn8dG+i67W4sw6gqsR0gktRKHZoDPwFk67RFvaADt2BoC9wO8QTscGOkYBjjxGORMy2ptbYKoGmBK1ni+jrSXqB6ndpXW/PPM9LQ3LPNqVOKxpXCf+LTbOS1Je51YoilHg8f+etqwc0HViyhM0vUwaQBoGTQuojh9GLB9mlRIAY3R8JrWYj3X6K2zKFJBWFd3epr1OU0ZobhQH45FMMc6ksvQqP9iryjq8IETxkFtVMNBmaZ5qWrimkZzjXbHFH5tircHZrchadKS9KUGYEWdV1JIAgJxijlVnTMej56y3bZBbvo4mVtGUIRtyxBQ/GA8Mf1SjZBMT+vFiLnmX7ZQpvC/etJf3l1teJJSjfWpdm0rKbCVEmKFXN6AwZZl7wBgKSsoRm3ujQBE1XJ3SJltHxES5lF2iyX0x3kGUQRT8tnMAgQAs2oaXDZ0SY60Q67/ewCKEgZAxaSQGXKGKaIbrv0O2nUEulYwH/fMhTzf3+bYn6jFHOhSjE1uyWYC+MEs/D2nf0dq5//y/NWLhb7L17Zt6MfHA4r3VxEFV72d3qLjXwY58oXjU6XMNSowR+edIGeK1C0r6RAjrKUe5F8oe9DnhX8+02h48uAhc7/LZN0fJkr2VKh492HS8e3bELHt0zS8S3ozJYJOr5F6fiy7VP30aHji9Po+MImdHzxUaPjCw+Lji+64MI4Hd9Cs7Q8QccXJun44iOi44uTdHyRFkDHF05Ax7uU0eI4HV/4ptLx1z2aV9qgq8FhL/ufr7EX2CB5y73yZtunyoTck23y2M223/O9cJoOC0FAv2Z1WFQEovugt3lyIVmNRd/pyb2FbCCFaYZBNcObRjKoqRHfGhvp3+RBmqCHjAG0nPS6UOi+4K9hBbx/OQZMmnVvbaxZEnv3eGx/92hVC9WauptWZGtZmFZJMhHp5AXf3Kvui7U+9vZyuIb9PwLr6VO5DKwa5nKWXCznV31Cu1MCem08dReKyDPqVL8tCc/1gklRVEUTSaRA/ReUp76hWiqonJADcmH/B8wQBexLrwjw4hDOKT+9upFE1/my7/Pkz+3/lkotSe2QPER69VTxsQR/CImQSLxF9k3VHDeWdOUUZVdVHYF2oTNK1XJkpi2LGVv6B02lwKj55SBsu3CcV5f7KbP8/Ag/56aXYZZqT/yZc/VtT+kLFNGqFz7IKJvk8xKfL9hWJtpKJ2UznpsKEK8FWmTdloVUXbokRsamNeWJ7TJEmaRMk0oIoPqSZL8j4wqNW+x6jgbA8tsFS+dpEVzFTPa70qSGFvS+JVcwNVDw1BKR6X2SST+yWd5XrbROc0jTaKtqR7OVuNebuMzFqdJMqWoNMGqLsrv0WEaist+Tid0SZay65krWJmpLgI7849Yn0XCvXBLAugDUXoLXx3kB/rw4nccjNCNCCS3IeAytppQbhnlGfugx61uLWqoXjWEzWum8+zJIjF1nZdHjgpEl72oHyZf9Y7FF3XFpOYvDYiX7fRkh3NvkNOPErUeL/F+XizeXRZYArhVxzmW/HrKeeNHd9yPy77MXDx8M+tFa9gcoDTLgLr7oVhiJlb7eNJmXC1496ipPlxiOcxHFQ1yvEUPT7EVt3xBrrGqRQfYDoKAOFfhEruUWMNRaR8vtRthQiTYtD+BfAqjeNErBBnoyO2XAQ9Wwaa9PaNJNmxnTpwRm9pKl2K306Z43nfLhSx8mTwKldVXtT51OR4SYVQnbGzyxtfGUf/rkJ/7phi+++ZajRldBDEi4TYwJbNlLpbF9oJYzpJf96Q3lDU9cjAuyv3q1nFA5Hu6Bi9cfDMAepqC73gtZtzWgGloL0l5mosBcDKulf1CPO7x7BOX1X+zbG7H3eGWvzTHlJhvHBOvRwQDacdgLXUGiy4ZLnv0XownCqZIP3sPoY0fZfcp54BAqA5x0esJWWYTbyjGFcF4pxfQJXJmHz6EBDxfPDUCaX5t6VhSqZcQ81VvCHGppk/jMM8QuoaZtyGdciR3kuDGA2HWDiXksl0qw8dLtRoy5qLnF2dSnuLbFvpcv0YJeiv31EpBDB3eaHTB/v3xbscyTjLf8zo77ux+al20Jt0SWygR7ZWm0R01u8UO1sCaTDYVvoZWHPisuayX+oXu9fEWUyQqMit5x5G84VxqK2vU1zOmHuZxkkIfkRVpmHHgJ4ydmE9LJBxekYi6qc5/m8prm1U7iY+ySZZhw9SzQG6lyFzXoQynE3QCWky9nXTEDC/ksmjmA5w+sCQgDU15HVXAfavi6L9P+BdI1v8bdzFfsnFoRRKh2OrUxpqs10ICarTagtuwaAmvsMZFonz/P5PcKKb6fodLR0rWb+oJGSG2jxevF1p4ZM09fVwEh05hV8nF98Rru3vPl1usq9RDFiFaN7aF11yg8+n7OwFQHOQsAU8HFvBcoM6SePoFA9r4fzavgTV/01o4uMkZ4ri8pelPeb33tN2UL8Vm3hehWdxB/fYIdxE/XM3vlJTEMnW/evRdzaCq5UdZp3/eI0tzd5QRL9g5U9hFg2YqZtFQsVOeRtslM71i1DPK60kmcyglBgP9FuMUwBKHyBcACgtCmcAOXqjfyDu5yucW5epOtpA3zhjYsUEA2wzEY9p5ZLyLV9cwXKTIm8yNQED18r1KNzgBH6bexiUKgwBjV6BoM3AK2RqnGCihgQitKNXpmVnWpB6rRqEyg3hjVmOdvqCfYuwVI2TBUYws1kLxA0SjVqBmqsSBUI+beLuIwa5RqNEqq0VgrVpRqrIJWrIBqrFaohvoVtdO3rVQjrVKNFS0P921KqtEt+7dSoRo9e+G2N041eo5q9KZQjRVqCtVYMWf206lGz1CN3omoRm8a1Vg1Y9bQ162AkGnM1nGqsZVWp1CNVbTuGoWHUI0VNHK2InObpTna+l7RZKRVfbLl+zlzVZBCJROMh3k0QiAoSn9r0209Uwe9jnrbT1cM4N2EF9aGwkNvpyJGTeNpTlxilWTd/77lBquGg7FFU1TRqFWA4jg1l/svho4mek/QOHorPpN8uZreQiKXN5lOtuxW9rYyUk0n+fo5MuRhyRk6lrYMDQyDNZJa3m93RpsgBAxUkaNqbm+bWtEy+2qQPt3/Zh8VZvLvkqbxRlkSvPC6oLzccH7lzh+kDbedz8+IDYmcX93dhpO7W44f2d/qHji0QsIQccIH1PuHl6G5eYg4qnKgrFe0KhqxVcvcuhdNQWqgPAATzSaZDbv2/ewPka5FU7iGDeblcjO2gpdNo77eP0hAQaXlsnHSSwaYbq45Lb39267EBLoDprZc7GVh44jsvAnendO6B4rMaDmFquU0ehekia2UDL1rkr0E0qHmMJ91O7A5vTMpzF8xz4useoKewaPDkm+5iFYuQkPqrMtNuVJZi7F4twFYHbcH6lCBy/5IFaXziN9vO5+XIBCEwF3apAxKcK0D3DBpPoXozKLeq1iUE4zFSn9csCOOXcVhYCWS6lCMWpIxyZdtEQUT7FGgdIou2I2m3AXu6LapiZguxxxRYL1o1HBb30MnUPIlt9KiqNPjjqDcziN+dKBazw/CYPEtXn1FDZJehVMign+zh8fKrGCycKM1Sc+OIVIPN+YEDULUvptCywzJ+x68J/yeKLUMcRlSIC3HSSCAMc3jY3wnrTO4u2Dea9ZDycG9w6LJp1zqNy+SkafIOM7tHAEqbRxRBdeaZb50fypjmSd4hHkDnN3sIG/Z258NSvb3u8+1Nz9TvTx0uWKL7nkkek8l9vVlLFVi36mxTDoMDXKS+taRW9K3BwEsN089/fMYuEUE8pT9jUom2arRUh7jeQin23KHbhVEBlcXQlD4s9whH87umGwjJFdMkvLELytDJOQvBpbg3lWpSVyyRDIF7f0SOEzEZZkEj91FY4Qk+C4I/0GVNxdU4W0il1CaoH0iCAuoCWRRD5iicKnihUB+dDCzvxOONQZKEJKTog7HNOQjpkt4YUCZ4nSEE1xIcfKdCkTchRQUCf17ZwO6qK/rxSOfEBoR9adv99mnTNU9MfyuUPB++EwBIz1iUykZfbfOVtSLXagasEHp5wUFQSut+tkD5jOToA8tJrzFfTmtpOktcUWesK16fzFUZnhYOHIEvfEfEj96muFWzRCMqM8hQy19DdSbY7t6Zu6CD+6WlW4KhwrMGK86rInoxHJCSHU+fGxQg6EF0wJ4yBUl6EBmb0DNctM+TwRbMJE5n7atIfZ+nCwnq9nLMdmfyFr/5SB263xoW3n/Wd+EC4zOAnuwjlsrwDrO5enFxqn3GPPI3XGcWOrr0gxpklyOg0RuUF42HOYNLI16RRcKh1MkTGWc3pEEg0ETkSnZby9lNzxodYPiIVYhnl3rg4G51fiFi5Ho7Xu8/Ps8yx+9luxvrWGZL+Ca0BfOspQT8Xuq0a8vo6karbRT725OXLvUm5saOX5vUyPt9zyk7sbqbZ7HQ66ii0AP5fPImXI116X6GUXZx9QqW81E7ZHMGqvb1mrmj0/LrLHg5MOq+akxVlW17uQ+wLVi5UqaozeazUXmCqXVuitvOtBKJuXuNvkyGYbZJ4w0F8n31Epd96oOK9qmPjzX0wMTbgQC244QD+XVgOtaWQ50D7VCQf/6MPukLndYUiDQxjxA1Y6JC1BZts7j4KOuUqk8w4+YRzCWEp8HqIx6+lIHoOsjtKhyCYn5gBrKv7THTx+H9v4BtaIrh2M1e/Z+hLgMr3K1rGIWJPsS1pn0Z13rWoWv7fMfxcY90na9zvMhiSlFDTB0VyKhp7hJtStHiBMfmoZqK3ZQGXfU7Zef+uWnRSRkCfbSlIpdp7fIJ76H/8i/iALoLpUGL48tlbSztFqYB6XdwjwEZuNVrD4icAcCI8Q0csFYPDQHI8mxpbWMY8AypqKxpbXK2fWfkydqTdqYS54krQ3MGTB5/fv/xThCy/68YtgiwTXXSM+Hmlxak8t1vUhc32C/qKHUqXp6KrF7XOTry0iSyIialIBwk3dgAzdTBsO8rlnfaWxWaddH5n2do6VjIBupXLx0h5eqMYIiTLdDd9PQAUNFgdY6prkj3SiFiB9Z4sBH7KGb2liB5o4OmpSg9igflGDT2q1JrN0ae6TWNHZr+n4+g660aUa9brYmAJWOQUnHEqMewM5Fw3BmX3UbXmr33OVtEG3h48E+6lFrZBZj2QKiQXoEitPx9ex/4UO442oCszGwqTD9avYHUD1WHibV2WKyXlGeuNSh1837NcOZ6wE84LoEmg3+XPxTBlN56lr2ZZW/irKP2gcMqvcUHGX5T3uHg/RlQYBbYuU0o7HbswmJ0e/pt74ivuWVqQohQa+AgzvXIB1aVOdWSD+6aALHbOAeG7ifA/3r/Sd6G4tOJlA3MgG9Yr4AuaYsaU3rN1nNaraqR+bCwSEW28N++5ntAJMg+wu9h0Ot7B6lQMpnmRrwAZ4tGNLBFRfSDVs9dUpAcKPMyYm7uRP2aZo5+lgWrn5LbdGLfk//z17D8x/x1hZ9LPHZp81LbK3Ov9kPVb3Bg0cxyL52AYp3NQFFByFZMXSRCNwllRrBm8oiBVBbiXSyYPOAazrxj1LMJ2e8EX7qNRdyJuh+gUHku++J8taQGisbjs0Mrg5dArehKQjYrcQh5vZQwXsWxbwD9gJcs6f0onHLvqX/+Ndv/JXgTy66EmBjrL6Qc2J0sU1nAMotEDWDVCRDFDqssPK97C8Vw9U6Ughwh9VeOrDXsr8SvvrvPS+6Vm60LOY+nkcX5QIYYxe4nez1AH8eGXbxX5zumgr13JpZJowHamV/r+kpaF1e8o6Aw4aDTh8AxxwUbcnC33frLfj3exeXWpAX7B0MKSpn5pDiqmLp8HZVbw+HhZjWkaLgSndQ/X6Y/iCbo7dnrXpB1E4UX9EYqCA7StjQYXhVDbr77mzaGdQBa6D2b/61bO7ffuh41tL/tWzH/+INx2/FFr1O93G8MCQP/5FxOeSlX/Kj+nWBMdKmNvJh/792SVsNovAMO+Yd4LLuqx3AWQBPX1lyPTH7gweWQXGqaMgYykjZ7OmvO4TIvnTQ3D8UqrOh79ByoGn5Zijm+KIzmZJBU1Qb17qVuDxgMlbJIWWsyjIDTWOqq6Yx+ZJR7IbOiUZHh2azf3iNtATQNuE2zcupI5YdVyC1+Ea6qcO/pjfUA8r+4Dq5GqUdMffl5vpHXwrFyFnEzZbaSf07OZbXT9xUaoDevoCipyMp/dOo6RvTDhH/xRwOrw11KmApmbIcyWIzOuEL70juK9UPMDoYnN28L+qP8oKQ6D8tr0+1LNkYkZWqTMtO0aNsvKOqjtoypuNapdKGzbmH3X7NKKGFmVUlvmB+jA6tK2PGBTMX7LjgLDA6pQ7Lq/kxM6zeDWOVGhiOyHk5yJem35lwwS0uuCJM/FLR25+v0mK+lRbybVMrz5wOtTSftoHVWaJVTL2twJBtG0PoN88ystFWqNsgFhqys9xkmoGAeSnfRkuikyC4sijn2NzuHtBgiVFtDqfe+TJt4VCXQ11+zg9xKNphzFrhty18Kj6TI32F0XqQr1APBS7fUhpDAni69rXGbkszTPpZ2NekWaa1zQuUI8lgo5gyjmnwVUzEzFAnex2mkiurmBHjkzOcK7kALE2rxDMn2VVbuhS7pPKucF8R/ktR2BSUdiatlsp7+ZvuX5S9dsdJFGWfcZw86DseOBmqP7VIQAKNajiS8R7ad7XsBXyjyOVxtt8bdveh/DfF5YYglg0BrDPyuzXbXu4CgPaaWVNiptZjOwEQLHwMy1dLHLhtqdTvkX1Ap7oPqLt9QGL3AXW7D+BQIgbP3T4AUkvZCXQuNSx7BEYHGj1tDy5oZ07M6YO0cVxex/f41nSWZsD5a2/Xyc8+i29IjRshMikyd0Nc28a4j2SOn7XxdqugVxw6mDSd6v7AS7EooLg8q9TngPjXAsQ5PXMB1s4NRwtOxgqOsR9K0AVndTktY3Q/1MB+qGFk2scZgAr4/RL88pHBOwu/uvIYMeO1XVZ/LoyA874wuFaxY6lq3/RjS3BGdB9ahJ5QhM2inoHehWciZoWOLZEPTY2GCPjypp6BQEcf2haW9OKgjYtrQ1UAhzAzVvjWwM9MnwOK9LoodFTkmnEfp2FI33taL5+VUruQlnYA+lmU/p1mtz9ny/fykGYgV5VVNFTtzg4ei3pcCFSag5ruOgV6aKp2KRcoQiBB5oQ1OSmyOBMB0Ev4ZEhLGlnK9SIgUkTzGO95XUt1vFGPO0QyMe4AqSkxToDZAQZ0KNPBNHQswJsepmDHmzijGRRL8+wxmJLJqmUEFBcZsxcYOnBrAF72OW0AD71FjJf5gZLCkQvJKi4to56N48bKBY8fgSHfyXNqCJR8Qw93qfZha0S+EaqdFDuPkJe86vHXNHYCG1Qv+7xmgJmwEZNRck+q6hi7iNdzv1qlh92DGmd/YJE4NXSnLWrY7K7Qiyv990fFo+qbu9yX/Ejlahs2PQ5IFbV1fDQs3yqKQ1LaehEcocAlD4vQwTCsbI9uh5gk+zPdzBLs1OkLigmHR/JAplB1Q8OtQ1R1r3TLs2VmTJc6AnoOdkMZks16QR7OGqIjpg/+EfJPrg+As7ZctujkaxjimqHtil914aq9Ik+7o2HtB0LV9oaCQtqyUNo7oNC0EE31KBpUDTJQPNK0GLtk27Q6hZhZ+qYnU2hdzK0LIR3FFvMIhYMKJMmrot56+gwoE2/qweIfX1PdEyrRlkTfWYB1+8KHeTUFe9Rr8b1YjsSd7PsW8dRt+rAIdJ8OjKIQJi8owJX+Ms8xziN2SSUVwL9AZETZ34tc+k2QUIUVg5BOPUlvy1VZfq6aUbwInTT59uynVCagbtOqO/ACkOW/K3uaB6ePDsbZV1G9vVzpj1nWQE2Y4ioj81AMD7trigtq6erOmNBJ5HTtoKCSU+UXajqTIng67+ILl1lIThmRHR2uD25BeX4ly2R5PmwEanmZKOrCzgx+HrOW/SVymMv3NU2E8ZszDTODJwCg0DB+fqzXCM8Z5XvA9wPH1mbl+t5P8kQwbg6sGQwv5g3EcW1gXfhdbdBeQ3pfQsQ9lhX+gnKlALjcMcC6glBIkQklYAO9FF4p32CIVURJ9reWmcCEaKmPS46+2SxCrbXS4eWIGhGm1QGtr4YmQoootv5zDkBhMZGtatFAI8sGAmxVn/rvzv4ORdsLCRGFsPAvNy8TVWZ0n0IwwIvx3+ODamyM2PtV5YU8VByocmK5c85KvQHP816s8gxZV8wUhehCAA4YiwiFPyGc0QLt17KfwSWB7Gfxiy0y8/cqeQtGkwKlJpdPlf+GrOoPG154Psc8X6RU6JBHqnGndmMDCT2dWAsu8OYm/d2i7qerVZRLQKkNIQOLB8p4gJutktQvKmglfz8RwT+AW+9zAKKYZH/ekK7KRfH7hENMSu4QxWstZ4npoxmtqUUpaqFYHKGFXBXODL4k4G+rGxp8UmTExc8i/Jx8jlq83ZYLOtgxgu3JLuUyZp95jd7cBSLCxnNsfA/4IjhdkLvcuBkudhs8qovrA87W239grbSItUgNaSwncDGX9taI7T7GfK4XiMemm5xpfJRJvtlnKnKoURV7vzUx3NwCxMB69fxyB+kaNbMvy2xZlCiupFhQtG1TfAB14gqY8vUtHoFyu6tDELzQGmupgQ/PvqIHLQ4974y95esmtTRqsKwu+tWe6GF70ImChVvpB4UYiewfUJgzC3ZAGUTNTx68axSx2sTjBzhU4elC2BR4LQQsgDwMSZlI+Jr/Ry0S2BYqDDw1mFVTbAO5FWwLSlQLyhYkhZjSyf4JKYXyxcoleyKQp/p+tboJK+xqjY0ilWI2MfHC/04hN+K/Fzi0T2ElGeqUl/RQu4fR9GQc86hCZqq4rojdMojdBgJbpA4VqU1nYLnMLKmK0IFDaGl2R5udoaG4j0P8dxnvddTd0pyu/PPc5nxBOs4hPbBehIRGJsCydExv10OWCGkN5PdLEAWFDAoYJPjvtLDGv3mIS9dr7t2jDmHXhZGhBQoFFiHNX9KjLqilEZlykidJXjWpSTDlNctgWjb6vKpIyolFCs9UmB1iTKJJ+u7gC42rMR+0y0hZNnf0dbrIJHEIUqOWThKoc5TTJNVd7wx5Ok0iSnWa6MQbnx8xhkCnR0AJxigoLwanHHYEPQ477NXI4z9F9TzQwQ0VRaUBUjoQVZ37aAbbuiI26AKpTV3NMWMFwZQBZBV/VBQtX/yA2tRp5Tg4i5QWCuJkX9VJoPSvhR4HUNDBQBTxWg4048eMWiyQ6xGl+7sOGIkAw9BGSPxRzSAUgYKRxylFiMgIoVlE/rRcLSLJKhGkGRB8fcUFHqkPOYwlxKnynKG2PNtW371lrxTXdfCULEtPROQdqaKxcW+GJSD7ZxWUSDmxuUOkXY90GPVI0ADZDq71wOnBM3tdl1FvjacB6/ofvBiwPPDOn8nndPbOk8ffgbtwgxUrNy7zSlCPEkN73anNvHZCa2oiTe6sYU+/P890crapKcOLsYCcvyWVtKj+/CKmJjAipgamJ7/pQgYKhvUTgMBSEsgev32Auz3Loq9ntj0oC6jHtrgfsWM2kNOUMu7gAZlPxoDjnK5L464EdcwUnDoDR5WIYwr0rho4Da/qigyDmPMgAuAtMysTxCVWAqW8ovHY8JJpHhv8CY8N/qTHBm521WMDWgxe7/geG3zjsUG/Vo8Nzp8QF3DtdI8NvvPY8DXdXjhvGxMeG7xxjw0BJdbxRnb3DVWPDWhQ6Bo00ZUQDQpdg5zDi/9TwXfnNwa+N77qGwTfR18p4Pul1eSM6/wXM7E2fzOlEyevqtLxldqaEpJAJ71shiskVhYwZctekMe6wtadVkSCRyLcP9XFliAiMqjqKEsg3kARbGvMjIvpaEzmYmZ55s3xH8oKKBaR5XzepADndmIBTSml4Rijvv/CYhFSzMV+cIDX/0UwBst9WOBKsfjL+SEWj7ZZj7dQjS9+4a6W3HAK5OKXe0UbAusNvuqIkCudk/vmNHcg5/Ue41JDeBV3EdYQ2sqhZQlt49CihLbj/tTzESIO+RLK0XwJFdy8HbKZ20EkXHS+U15yfTlFXgp9OVVeVvXlNJrnl636sktetunL6fKyXV/OkJeevpwJKmrup52ul/Ogo4hLavlZdKYCBi9n0y68nCMvj6Ez8LJbXh5Lp+HlcYSMVDyeQnmey5fLiifQbnk5j86R5/mI3MM/vPUiehydTWch5gJ6LD0GgQs1qUanEppBj6dzH/qMx2UinQOS6bFyy+1yruGzHkpAwll0Pp3HgcltH744Gz/nyWdZcT5/ZlsQ0nmEYrh8RKMA1H6K1v4E2oOytb4rtL4L6ELEPUHiuGOVwvCBKQzRtrCdKKzGXdEeyIdXF49FxrPobG084nZzM11hNU6UPI/hPK4wWX9Cc+sx0CsiO7Do7KA5ZSC24H7rFuoikjGOI1u+yihkV/WStRnfq/lpOU38406TGa6k8+1p8u1p8u9gmgQpZkXwvHw7Hpe2PdqOKUFcxDZK8zPMlMi4wFkzJc54+FMiq06JbUDlM2kbz0CdEoyLRIL+Wzi0XUI9IJyEVoH+OmG4KacL+p9u8fpxeLF4vVNedti5MM8vW+xcwEvPzgW8nGnmQgXJd00g+alVJD+tguSKBrsVnxkLEA38Xqngtx2u3XQWRkrwTOPMwIcGWc9HsiDoJ9/5gxdX/zDswIvH0hMEey+u/hV7OFGQUKsTpDmPbOxZk/hu5ozFGsX9xxvcP3cEXc+nx6NAYK3DsMcputoJp7g/BV3pkaLr6cDM0y26ntHPQJK2IZLxwlB11efaopdAz6QUFNGi1g5Gw5BHB09QnzOBNqcRUzJDfXdx1BZBptNLqnoGl3OqoNWpdIZixW552WVxbJ5fTrc4hpfTDI5VkGfnBPKcUkEeBd05k3RQQXSOUjsFzG6F8mNK+qV0Q8duFLIcfdbJQfZUAPFUC9kdkBLuoDMRyQDRyBT+cJ9X8A+Di61CqyQnpQUAaU7IQDMPwG+X1+oMS2xY3MCxr2H/OYCKqKK97UEo2ZcEAkThDkQdn2boPVBcSK3zCf+8v1cXbwwz1I/6dcAa6kVYyHucjd9WsT4qwcwVra/Oz5Un5U9QbM0Nqc/P18mX7xHTJjuwwa/p8NZAPFbxOFWLPc2tisijy+ecvAZYQCXTGfwIRhfNU0dQgvKzlISsyMvZSkeFcDDGnmkXTWK0PcUtmjVeAEN5Yv0rnki75eUiOkeeT0Lkkw3muEXzYrto7rWocroSHF2iuEymKZsuiWYl3TOyhl5ETypJxoUjK2JIF2peXShtjYbEPZGejO903aOLaS/eLqQnjBagqSBzroBdOg8usNTm3BE683hXACiMpj5Go7WAk1gQfYi4zQZwPv1rz4uvI0+lh8ELdTPo4yA2OKAyPBXLaYKKHlUQPiGIu8RJ98Q1biznH84NW03JV2jOEsRDmMqWwrXs69g3OzGoittR56Xu6nKIbW5F4mn0e3wKZNpSZBV9fHzu2z6pPOaXH4a3Ugj9J7yVIi6seCvtHoCBQBH4X81vayfwXfrWj7/l47XSd+kLKr5L34IUjuTHGc516cHXOtelJ1ulc2TK5WXXowR+vgzPCXejkLlmNyBpzOPojYirpe/2PR/Cl6AifAmd8EWiQzhxjThOQRXJeKAWHQbkyENtPJrtPw3pIsxTYWpFthLgwbH8QE4rIw1FqiG3K1huEdgKAlMBejwhuQo2Eb2Iy1g5wabAuYydIrlSgEtzq03drI1BVXB1Ao2Hg68c03jwH02Nh0/7Xv1kcVwHroiP55M3PnmfvCfyyIuC6qUBxyKhiEe9UkksQ4sDR6mk6oUXA69eePXgenT8YzRF/e7qaENMBTkZ5gFAWT5CfQC+sdzAyj7ySjcz4uM54nWCtR/Wk0pOa0AMDtPHe68RSnMAr/VrhIHwdTUEfQOqBOVhD62JN9kRhFLDTwWL5lRB7b9g4oltmy+8vmLbxrvQvC+oTkH2gEBSUA23ne58UG8GMAz5cR+yWqt8nhy0CyiqxX9ltHi8b178R0aKv/8kin9wtHi8b178fSPFP7Bp8Vtr9nITz/ivyxMhc2VpVWfZJ8xliY99/PpDKELvS2yFmdlQP85+7+DYp5d6/qSlIfgI+31tWPZasfPuY6oI9qgBodchdtSA7nd7noHAa41tIix8cKjCr7id1VIQFFUqoR2XLAou/fibcBkGKg+Ke9VrKD/xsuNfQ/Fr6ayjZP3ahbUoTRdkMrQwTFBdeSXKEGuUqqOm9NOX5okfLkZ+XtHld4/81vCzS4Lnru3PTZ/4U8OqpPUaCMzu9D9u4qK8Zt1oqZNiG1KGWl6yV6NVGnzNuOfznxFndC9VAPqGoGpBvgzN6b7omtgrRCA9QtHN2ZouMQCnKm9K+yUCIY5LdVCE0ml+D6OjDywbiA5NFOCB2PQHeMRNDQpu4InCBpmUtbHDj0Xf1yLV+54Uqb3JbtFhlfvNeuelgp43jqLnwROj50GHnjf+q6LnT54APd+MlW8CQewJqHN2podFobCXFTYBAJMbdOpwugiwltUpIv4r17Kg9C6vvrizn0Gjikiwm2JtOJgLg4wRanVVx7KMARMMGxPbZczXVcvHFy1drqTQ+nn6rbrzDrV0LF2oRGpQOOCBtOxn0aAVQQ71POZVV7CfQ+q/Eah+6lsNVK8/Lqh+GqlC9J4Ndm66NVlj/VE3NTL5xfkHfN9Jb9GKtMpStOTFx0shbIlOd55ET5RazHG94dT296+9Zj/nqvrq1KRW6ZwTLGKn1mdljUPM/+pCVlSOH3nrkx3UvkgjdGY/sk7d/C3eqR1C19S+Hu4+wGk5ciFTZko+v2xSCKdfWCm0txqJps7eiJxKxPiSkDLWT/J8WKj30GwpXzkTpbeClNlturasgdSieEtvyUu/Xwq/V7qprmTukfDqGsBR8S8pDuzws1eCZ4knO3wAN5+yRLIqx5r9SxNZHO+pfSOr4+1udRz8u1sdj0ysjieFRU/xgmnYEGj5ShoLNGBNh9WhRGBRQvma5BsZuV9wI/eL/+5G7pce0ciNM6xvlvRnbsqwknCmq/uFbaWSg90lrKtOxk15VvpGxvZtbmzf/u9ubH/5URnbOyX9e0bH1m1FZAgxsOpn9ekysBfh55KSypI/dXi/8an7Tje87/p3N7y/9m9MdL1vZOTe40buN/7djdx7H9nInQTz9P7NmadzpfcXCSu0v7QBuFtGmYRLcvMVHYFdTTPS2Tcy0kfdSH/o391I/+Y3d46uyuh1p8/Rb3jx/B03cr/7727k7npkI9fEZuf3JfaNHssHBJyi/8zbd5zYoAC3YYNT9hCPrjptD0lcmuexKq739cqqCtXxQpFz/4zu14VCh6nc2MbdFF1qrW57ebIi2CMu1q1RfN/seo7W0g97EXRbfR5PzxkTdsgilyD3TLtDXfh8i3oXeYRn1zyTvpo1hVsW1BsCFdA0j984rogNSsQU4aGN6+9Bs/rnKoxMXuejLbSgDvovQu5rVYOgYl/38pOcM/fhXhLcD7i95LPWNp9B3W9kBh1zM+iP/93NoD95ZDPokuOOox3FhE/FSUcyxAnsN4cCfsKN3yf/3Y3f3Y/K9uHPT7A1vEQ2DPtkB7Fb9g56uKFnG5DrbL53CL+Rsf1fbmz/97+7sf2LRza2TzgeBwqxYjaF89TBOvoNSdf+yg3Wvf/uBusz31wm8iwVjE5dAr/xU8PPuZH7m393I/f5b+7IqfP07JskF/17N3L3/7sbuS8+spF78gm36Lv8ox3lXTajlAf9b2TU/sGN2j/+uxu1f3pko/ZEHjWn2CXadQCoUbDzYcWw8LOvauGWCTGNf+E0n6HI1T82YdobsR+eGrtrWuTqRKQbyr7pVh+vPk7yvm5O8rTtUJFTl1yCHgoyLTbAaWOS/vbTEtinfux1rRcH18UvrhgtPMan0ZHWo3axYPkLvb3JpwiD81p+QpnhRn0GA48iTrnR54IP+wifzk8YzkH0wOPozAVv5kZUzCYJhOFgqKjvE/d/G//IZjdNhp17933hPyD2jy+mqHQnw7tgrjtP8Dzk5w3U7a1p+YBX9nLpejN7BZ45dscP1JBSX2M11qKlPnpuDp5btA9A9/aVkm1G4OPLpXuN6VAkrsEpyA4hArZX8S0QpE4xTIFH/cOB3rlE0Jcg1N3nqS0+9BYDscyBv8t6BY/MpbKjT3Hon4rP4f3Fct+DNddlYOdSnwOqHthPKOzlXTF8uPi0Youx4zovN2k8hQHsTWTcFkzaNHuVACfknkETtFux0Cp15UvyrBUrmKw94kcrX/X3IgAbArrTXu3X+VYbLanTU+LmlEaCBs5XmrPuL2Vm+VaY/dSysmI7HgsFMaAQWs1zuY26mhf83ME5Q9qa78TFh3wbhflO2o4WnTJyK7WAxv6puJW6g1UE89NoJwdYcX8XncrbvdPxyiGAFHfP+JVpZ3AASvS4P7EzP5u25edQnj8GYhTpzBwcBD6GRKW+GejtgVnEwfKMxjjfgbvNraMdqmy9m05n3fozctaS59sBZ+bn0jn5E7jkl+bn0WO5O49jkD0+P5/OzffQE6S2ZcgmHqoFtfwCOr8Ms7Z7GX4ihWWY5bJ0PkLFk2gZT1bMvx+6+KG87KU98uwj8in881CKocDndCFdgNjvoIvoiQjsK5P5Ekrx1DLPF6G6v5f6CFyIjHsp4lsMA59L/ZJHT6InI+VJ9ES6iAOTwh58IhVcpN8FxZP5O1vZU7l6KWcvIRolSLRrw3fQPlSgX9/p42vo9D8FkRdrZFDsrRbJqcjEJe+dWiRuJGi38PVRn7slHXkiIp+okUFxUbVI7h0y8ZcXuSLt5ZFlPJbpfDzOpz147AE+AN/Pg1OQ8/oxlODpsVD9Z3x4nDwfR4+XJ1+ykee59AR58iVFTMDdtENXjNNpFxD3DDzOoLPxOJvOxONMOoevBTG6Pgbmix9DZ+E7vkE2ehf1FHcX1U4O/9/x5Pj25Pj25MAN1AI3UJ+Gx6VYLIDouPinE+J0fI9wItevzsZUoKcdQHE7uU6EzmIM/k6eD6fyvDjtkc8JGp8T5zD2n8pwOIthcCb3/zTu+9lmXjyVzstrU+bGroCRuTI3apW5sVydGwblL6JlMy9qlXlhBzRUPMCwCkqbeJ1xJX4DuQWn3/L0Z9334+/+/MX2WTyJsaB4MvHEAMKrwUX7LJ7CiYJfWjQwURBWYy+anCJoBicRSi2n2RPtdEFs2T7q0xN1umhmjd5luvNkqdbOlCdq1RdKkRo5ita76EKUNobWirrHx+5deOyipwK7n2qw+zzB3vMeIZafQ6cD9XBXlPHtLLzhNvwZwNLT8HYanY23sxnZCcj+nfj8O+lp9v5qgfurZ4M/AkqP4Pm5gtFnH+Ba+zVgPePgTi4izx8f7DWISY9ntE3yJ+IJwsoZHwe0o92Mko/hbp2bPxYIis7nTBHykBF1mRH1fDCDFcRcriBmOAUJHf4pCa4i3hNLcqpDZ+lvFQM4Gqmc94KTHTOM0h4zSrsE+hg6PJ86OWoA6+PsqDyBTpehAuR302PwxjcG8XYuj2uGYTW3Xc/WD3Iq6JTnFfxjb7vClXVOp9AOvpEO6sHQD2k7LjhtJ9KPejCO+RjlukOlMEpN2GPvH+JKa0lR5jT2IGKnr73E7DYP/RLfbj0PFpzADpyB8T2PzjCk7rGczo/H8eMM0ETEPR7pQJcQXWPWG90+D9nQ6N1mUcifpAE/f7KZT7lZgvzcLItB3teAnz8FF+sFZ0LajU7pdeXqCo+GFNVl/vGIqK71T0DELrfgo1E858yq/x2KYLJ4F5fQLnm51JDA70LkZeUaVl31n25X/WfY5HOlaXa1/Y6TWc5B0RyLcCl9V0m79lG/gpvSYdqn+XW5t7U+Vmu9hC7Dt7pg09PpGXjbRxdPKcTS00ohO2zTdQGXxd+t8U8aLwR0UieQo6xuAmGuhGau7JY5sdvenz/DWIvXrWINP0/VJe38Pl8s38+kYWYXLsirlcXHccIutQ/YxiXi8zkLT6Hz9yN0WQ8TQ/39PZYWqU3n8wb8AG4/0y694/V84R+Ib1/jA1Z037PGCCr713wZREcdt9aG71a38rSGCPTQRlqb6er2H92/jgGFTjBN8JSOCzE4Hx08n55qrWge3QJzbQvwfbxAi5DTcQutxTfYwoMlTP6D5UR+4h7ud5MPA4rZ9H0/dQCYJYXPgpFSrJIPU45wCT+y8V/cX9R044+riFw/B2TjD7hj26+yBm4sdbF5fyoerXwL5G4IFVskvngqk5X9fVlztmzkz+SaHk8L+R6pDQNHAa0yFbs5OCAQs65LjsKZaHzbEXrmUAJFfKSoU71iUfyhhfxCVLG3UOp5Pl6S4rEMXow6Rkf7zhAP9HK7TFud9P5eJrYQTNH5OeOFCC0uFGIuqwRmGPgblDwqTdjFmUDulKxz2T7Q/qmCqos8geMHgzXacrUgyfmKfKYZu0pk42jrP+t8ChHNRSxzEsW0h5sIo79DY2/fU9wJnUd/rlr7C7wpdlmEAb0CNj0esY+3YkCHIivUFbkK4F5KU7aoNGXx5KUpK5ARdVSoMk+LIlTpqlClWwpVuk6ossUIVWCuev7bQpVv7xv/b943fluo8u3J8e3J8W2hyreFKt8WqnxbqPJtoQq4Zer0eGCMdKX7qEhXmO9mHFj815eufFu68m3piopVyKetPAGexpi2ZAQsjz2+gOU82jIuRKnxGrlMu4ztzZhqFZlJuIaIiiDFbUbxCKfJUSiblKMsybYYfuy+G3KUNsQpbdqKPFutjf6IZlQzBPv07GvQVFEQZGqHKYXW0IK0JhuIfosmh5XkpJoMN/j9j9TWXKnW2yQ8FezVz5r4bN/EZ6sTX0l0Vo1+QKMrSi0af4Oqn7CKjCrinMBM1YSz5n5wfDNVl+BrVW8/UN5nXz0gBiOcf1DYNsxejaZ00on41yD+4dm7Op6VAH/USkBgrQS84lE2VwJqg0mk9hydwZLXnsCt8/+MY/ierPNfwE6c7fWVRul3Fc5I4zUZjZ9CWWpDbxDj97a4qO/vN8TNUOkgcghfGqVXvkHe4BLuiMVRapMi9CnFAx6UNQFW2RETilOGqG+dix4OUG2dIjNHi4BfOkVmX/2Bc2NWzGIQj1Qi5vZ9Ls3/+qGv/z2HgyPwfY7Wq89ScMzBwMbZtpYB6eFh7hueh4Ii4oUsEI9Fdfyxbf95pTkLaCcFFwR3xPzUFi+Ix8+1Ao4gtba6+gs7cssFwZ3IxymJ+LREzEasUOB+q2X9JvJ3xMNZR3p5ZcELdCQ4yoHAuHdQs76EWjhuAeRigeaVXDQopITmaG7AveTeD8vxeNXe9QeDYhG56xtFsD7gt6jv9xn5eZZzx6IXchpFL8j+oGrd0DlWpGA9DzBYXbGpOO/8gy3JDmXBfMBBpMtA0iy3RT7i0cTI0dJgaNHlg4PCV8fPw0GxDEgiY0sz5l3+2ldv0FJGdzgcChThXnuZUs5jxtUgU/bTeHP+Xj3AEs0tFi5VcltxP7wERuVpeYcW8rr1CtV5qmTLGOKZfj2C7c7lfqwT4zz/Dh3B0o0sTx5MrodPRf54ITV+Eq6NeDr6/Jzn99Ic2P2e8wcmpDKc6nUsYuspLSWpq6iEh+wNPMxx36NYtOji82QBe1C8OcUb68Dz/pPXimRj36d/fOGXv/PTPjtw5E94Z1s0sgfF3FiTP7ifP7DvKb/fW3lvQdounXNTMG+XNIEaG+xaXUXzsXGGQ42qB29PPOLMVL4fDHXgxSFiMcvS3nLoZDa2aZanfVnCD3Hls4JJ/GQkxQgFFd+rHTw65FXG36MMa3Qm4xn272TMT7P/rb5wKFQAhgD0Ar8trGHI4RvPy95vFAVpTROSfbN/c/b1t/zcNU/KPoCkfI5CpDB2DDwKoVeZfVC/odjFKcZoTZnWBIM0osU7By/58/xYBVcwh8Yv8uNcZhX07MACvE7L7FI8oNY4bAMV0C23K3DzsC4oYbHQ9chjSABa3iS0qvABKWtlR6Ubc2wEJo/x2JN3OOkmD2kKui6ia7l2KLjToy5lcI+zn71HtZ5brKwpqLMPoSQY38/uwXfyVdHDLFzVk4CtvjhJgrwebBpatI0WkLKdlvCAofSctpam+Ym3na0Da0jaifWcNyb3eCZwzAaO2sCdnsBntZ/wEjo5j/JTYJoa8NpJ+Vqe9WHvqchPA0XLTzU+nBRpYpCJDm844Hg6lk0CnWYClr3ltBhbpNgekmTC92V0mjxPo1PFdSStPgOJIfYznjyO4nsJHdPHPYjA8c8pnI9O4aIHHpozOpcUxdA28S/vWdeU1hr8qbQKwErfOnQqTuVi+ayjn1ChzyG+3Wa+tsz3qpKx7bTDrMXruadFnYaW0CoIv5RQZJShNA8AkfKOVLHM+ePOEZNTgUdhLQWvSIUnM5S0lVbAHO5ck7E57cRDW/DQypiemmcypsWJxrQ4hU454XAW38gwTh/C0+wQnoayTyuHsKBVOzeoQOfj/TprT+UGm9GMlW8KMIwO6i+yUA/JYzevt1JAp3LGigfegknnIQ/pmoZxw1xeMJP3dpmy8/x2iN90AmPS0k70HrXi1PmQJ6O9RN3sNw3vOIdNS47HQrGC5oOU0JY1/TbfgfdVhEgJQgyCAPxTArCde5UrpTsZrIjJIEQhCLHteAixahFiR57RqWairz76E31VMWTbo4ghhcEQxb6ixJBV2gYQb6dVoEcHjtB2UGcNSI9Hp0QR6tiproTfokoGVBH6D+jprCed7wwm7oSUcapgiBalExzUjAE/dZ631orczezueT76D/CWW9Bl4Zjg+9Zfw95Cgc/XArLfkjXDxOiSlGYf1pVVI8dXV+zZM/Kf3fd+FMGuAeADFyPm+X0+hfZpGdRmmRIW1cOWsHvVJqIa10q7kGMxnh69a22sTxq9Oj06m1ZIa0rWdEpcczKO2URnAvZNYQC3w8E0D6OjrnD7aR8+sWbYQnKDn43LetiRq8k9mAmHdwHCD/sd/WO0MvsT/OahNWPHpe1CoRv7fuqpP3l3fn2y13oov+9i5tl341oX1Rg4FTfQ2Z9KGbFyq5cIV6s6KxcELMiBhKJEBe6hspp1ClRcEIBhQkci3fJnFGQfQ4EXBM8yJ22B3n8K1EdYQj749+zjSovEyl2R4LFXby2ZDLnEJXkDGPOsPNYmkc/YfQs1cDnshfC6uWH6oT3V0MAGBxfxfiZGS3zMAZ+Sqk0JrfxysT/BFYt5C53SEXkbVsdk75BCzrCxnn1C4ST5ucX+WglCitcx37QSU4WWnbi9SkBB6VBT0SSoGgo+v+bQIFyTu168ie0f9PnaPipe4fisjLdxJ5DdwI75wzIx/oDnQxJhMPWeOYuqarhDr8P374aOD1d2UP89cPH5ga3UkcaoVMJRB98YQVhjn2OSUYGcRz5245UNhwnu2ruuzLHby7hMtw91NATsUWU3EYFQQHB5j9L9IPsz5NOK+x7mUvbnAjpO4/45+P/lTDu6zsM1smvxrMumD07zGi+OS4MifukzHNAV/+MMjbXsPkVmjM7hoEiERmP9acBZCLzBaj6IFbHcLOQtEaiIv+eAGpBFNCCdGBZheVeM8W5EYDAjO+GNIlsv75WdSHKQYLo8SxpahBRCQDM7IA4dcSA7gsgjgzxEtiSfk4bk89KofKF/TP0zzPLXMK+qaxzXhzWJf3SNkw07sejjCGXrBW+ROPewFFesc2nqrbZYwhIY4WxG4EEc7FIiKmHq1G+FFhk6Pbx0Zd3fWmIUBD2W7YUrZWoLT4LJuB2qZET8CIvcqpIV8Ak9lO5ADWwH0YbcattJq/kpwV44NKEV2imLcoV54AWzK0dgp9FyHtGSuIZf4kpljT2NM1GEdGQ9TeDAuRKsrYn6C+37dAorjfXyXViTcVB6Op3OueVNTxIU9PZZnMGpnIJ8/CCfi38WimfHNKRNy88yAwG/TWgChkJbgWzV0aDTuJGtG+76vefu/q/3Xmyf6JupeM932CdOKE4vo3/LPhF9NqL3imzIPhU8JClXrPzQu4693z5dyo9eHZzz6i3r77VPpKA0TmM4nFYeFn/QPtEXdB+tRpgf+A9d+NieQx/43D/f8X77lC58+B3vev8b/y5/sn0Ccoh/+/fcdvCZL339B+zTxh9e/IMtA++fn2yfNv7/+w8fWjrwof/4Qfu08U//Pvz7hYvtE/HaB6genD3RyGs//kf/+cI/+8yT7FMK+fxtZ776s5/5zx+wT1v4S772ju//q62/+2T7tPEf/6EPcePO+KB92vhffCCbnZ29/mL7tPGXSuN++4P26Rp5DvF4embC2CcP5ndPsts8Gp+Ap5vvKXZPSXws7QYqns4D94dco2/i7ZO/+W5CAQ99D59In0NnEAo6g1jXRz+rpJ9BLZkGsgV4HKNwnV/TEM+zwKnz80x+Zvw8g5+7+Xk2P4mnXS6yFWEiHid7j2uK6Pk8n53+J8ga63/ODSVQhELNRvU/T6c6C9FIPuRgZoPzVNfQcFhkw3yW08im8XtG28GS6On9uXhJiidAbfQ8FamiXUxrO4aisbswijBXZd9LT1C10XPziI/JE8xbSzpqjnSg5CrtoPM5EyBybj9DnR2cwXUolzO4bVRQCLVRUrXRSBuQJ5RLcyKKpOWUCLVXzdAIsCvOVfJ9rtXXTMCnJGUD3MbAnn7vAiFhKvZSOILaiVYw0VQuZqGy2C7QVpp5Wh7JQVm+lSIV2zZ05WsKk4VW+lYUe33k/CocZkFqovFgy/hCtsfPiM3K48kCumspAcd0iF9hw/tGPI356IBbjPBqET9Pj5iKiDmYF6EA7MeQzCkc9QIU0g/W+PT7PP9q4f+CA+f5BzQnH1Ct4ZjnOQyST4FTpfiAYXAbyh2u6lK++4AegOSx+MpRX9BYjrRypKmqbEMMAqBxatJczv8pFHvl6oYcrfe4VmRRmGq/usIy4useTGc/ixLwdN9LCXi6p1MCPlyK508bUinKF1b6c+A+NP8lkh/yS5k1HnmVE7gikNYE2d/oB7v8q3NAtXGefxY/IADlR4KV+Tz/IgT1eHKPBL+A4LkSvA/B3Qjizjr2HAg+iNidEjyIWJLgVxC7KsEHEOxK8LXIsCDBQwi2EIRw21hyOEB1QdPs89pU9EcTEaunr9rAKbGNMkb57ISRzaLgX4fTUdDh2nRUHEXBuIKCkUVBT1EQw6woGDkUZOQDyuggHUAmh3UeRdOxDuJA7EgcooVCbUpECwyiheQpokWKaAEQLTAbkUlEC/SrgAVMx0U0TxEtRPknQLSAgiqiedIar4powbcgogUVRPvCo4xobz15zwrhiGcFbxPPCsG4ZwXsau4f9azwuhuqnhXK4+gIW81/I98KP3HD8Xwr/CRSH6EPgsM3jPsgCKs+CMKT9EFw9Tfqg8Ab1S4IrXbBz3Uavpzoh3KM6F0X8J81T1Ib2VmrNOXpKk3Zp2979W0PsPRWlt3geUGwS3bRu7CJxj6NwVzdhmc44r0gwJr3YcxK4MRNujfVXWDsxMt6rSa+YPOPUt3RUlHHY2eRiK0aPfuWXWKTAhQLelhH6emtw6J1QUAol9JhkZrCqUnxsGiKLKarEUeKpla5x9T4M7pPJ/MNUvHQgtvUHgz025QaiGlSEzE0pYSWlhBrCbZplNoSWlpCTPH0EsAjcpcTKyTyR443Vb4A6a6Xpjx2MxPCFxgEFHuAArB+V9izhGYEI9GYHM2rA25oI4BMGflHuI1x9rNoguKgT9mgGlPTRkLOrzT+VgBbv0+pNfFpa7NPO3mdRJowIwvOjLS4mDVtBj16JgbaR6vr6OyLgGuUHSlaI6CIqYWlTsB7BCM+GFJrvaoQ0kJ0a8CYUH74I4p36e1FWnaesxRNQCCidLQbzYHGTIdAWoFANA6B5nEggJ7mifQ7n01lxBkmDcCkQbMkMLCX6GDDkWNh1bEInybdjof5HI+pzAHBpixvqsAkxqM7OS3d6wevg02hFqCZUpNaR4r5IcUgokeKheHgVponjlggDhetdeD5kFKeTFLtgOaOMIh5IG63uiq45jcK3CZF0llV34AEdDQ9Lln4Z+NVetGmgBa4AunFAEMDi7htbkyMAnhsxkcmnhiZXRa8o9oxjT4BqiFexgHfAeChcTAJ84sU8IlKZjv9PWKGKOFPIp5GM6ouGBAHEocE0tDWREM3nwkiU9OxndUKuR0R47+HkrtS/JG8hWdGqPRIntJi3lD3+FDwAxug05q7ffWa0CZGZJ4JVNeJw8/nSHwbY32kiG8pNRWECEdQpEH6wpGiPWSQN7VXGYrhCcRIMDbAowPYojZQRPOeYLADTDZGqYEjPQuUIkIm4DgBah6HAAFaOpQX5bM6zAwXYWRCHc+IORa98oi0ReqQvIosUFkcLfAvsQxK0KUoPv2cWbsCYT0kATNQOImQmwDarZwcyrlZFwBZx1zsLRrLS65lzX7fD6BqVy7Gg4bT6RE9kJvRD+iRiVbirdmtKEKj1PXkxIqgOTUjtK2hsqa8hKaC9uO4VFXa+C1PJCVvMHI3BZPq5WQMlJb4WiO2aHlUGpTWxcwn/ruyV7R0WRdQUMoR6VVa6c3xGjVlxWkTpge1sbIy7mCr3hTDcSg5YpQtInPG1kTP7fZd9Qy0JDi4hjDhkDCHONmDdtU3RYWyf7PWEXCgqkL55s1VKP9VVTnfcIJ2vP7Rb0fG7cjG2kTVNt12gjb99mibAo1WflIqYfworbT72euQWvj7dsvZmhIOtBaCt5/5xKn3pefMfmAgxAUOGPIIDwIPqx0KUP8CHv1EOwRVAMamvicMvL832CtQpTD7BWHha0xtQ2Cd5gOB4HPhHBO87ASF6ce8EGp5+BMgqVNemRTYI+u7Rx5E8iF5yh4jtYiB6RSCfO977/s/+Wd/ce3/fNKVEFZRzPivClniw9edyOLBGxRUoy3TulCoLLrK9kRUr5SIDMpJa5soyuuqs4XvtWfuxFeg8zDVEx9m7p+MI493H2GV2B0NSmIHMLOQIwDKlMsEVgG/fGPWLXJ2DqOKcsrtRTwopLOyjTiCBQWkz79FSVIdAAafKwVSfTC8vUgGed3gd3KkSCi+ShZ3UNs9TJVaHqB1V42DFOrxcwhBDP6u7F0Q7GUMamBI6vyunI40oMkRMRh9ZKoJG8f5KMT+fAO9Q/H9G0FY3J4m1T1NywxrUrRvzWfkikEqI4uSEFYunQgTNmJoUPsImKOQZijiUBctvRXZM5OFW1TqMOdl8KgT5ciE8HQLxdB9w5lHXvGGG2PlBRpK4SlaLyL0CR3PYwDGpACAVH70fgFDXbIrpDh7guz1MTYgT1LFZK+8owv4c5q1jHowKDwdDt1l65qFLR6GDWM8yBMkk9F7MQ2KUJSOOcpTaFND1p5OdfgSqLW5AXIDOfZJpFmnjql2QWXLm40wpciUUstkYpT/NxXK/Py3nlDmjccVytyuQpl3nzywoiqwjtY2AVY4BqyLcQQ/Cqsj02GlYV0IATeaBrdwP4NOtJJjIT2AXAVu4fHgBqAqbAC+loIv0UeoD8BteFy4rX8DwqzBt7Qw6xF26k0TnYqqnYpOslNXfEOdAkKOdiqynfphH8sjFH+sfExF43qCpstCJI1ADO+ELf/zZCs9G1KIjdct0mTO7hikK8WS9MNxsBuMUBx/k0nkj1McHCg9MDqLfmlkFnHbQUJVKPBvQ2/uON68gdXnRzxvDk6gWFBFseAkUexFJ4Viv3bygwnDzGY0j3zoZdGUwdQ8AfT63IAOOC/2qoMP+W443zMynHaHFOkeaZMB7d937XPFXtI3d2B/47gD+14liN+zmXlxFIUeynB+5aM8eUHq1jBu7OsSH2tLK1bDkXNhLX2/H4TYC1iT5xjhchpd1q6VB2akEwvHwvzHKlKyNvjCSVGAo3kIOSun4jFOw2OVQ+GjZwByCOzH2Zto0urX4BX1S71rygW8SA/yqSbLRgeBQDHSvGa/bIXxlTnums/HkZjfqI7/yvmd2Pmd/Qo+154lUnARugZNdCVEg8Jqg7I7dUS+GDZkG3VdiGMJ/ZvcIY5r8IWAquK090IFZG2jqDtti5zrd0p6eaN8I9airOP/vMkz2AmD85ZAsVUqqQ6G1Fgv2k6ErJeJ8hlqqzZg3s7eoTAE2wnJV3OdZvDfgGVYM7fQTLkfG4K1dKx4G6rlC3lH959Qcu3qI6PAsGItCXVlTs0Ygpn9Kqrj14BFgEUbjy613XZp5kiRDY+gdzNlXRzJunbrxRx3ZcBtVw0LWKxqTzQwdV/N4ZLecLhOGWUDdG12vbIRQwceRmbsaFNVbqMZN0RADw+G1qE8i+T5tWpfkOzT/Bq1NdQxoZYrO29RCiRIjYjIWeZCwaxgCgeMgGutun9P3+Z5oaMC7mKrCs+gYpu9E5Du6xYnhkpfgindYKq/WxZsDvfFUUND8ovj+Iwk7ixqTF04Vqmhd8c8lJhAWJu9S6rxsDdnonVhLeRHA8XGzjXBY6v7bHTNrB9eeQ979NgnnXRmYOcaPgWgfXx6u3TDqyp9Y0EAxk0wMKdLiX1uw+CnX3ZIt/qo9ezam/DOMM82UEWaftYLQAujaytauDqiLK8OlKCHxlGHbNncBHTy4bzuYhOZlpHigJKUCgI0dMtYTlKzCY0pGfJDjssHFVwcHsGcjgdmY0rBRAZ8KrlAQPKYM0EvCicyHOFh8njiB+O/s+6GuAXJA2UIhMSDE1MZjnTUD5DkkzjeyAoRpHnQhpA9gtwuQKqKilBUWYy6GSzHBjfZrX672R1wXscmoDxfccNHbiO3zn5NibTqw3sytD/hewG3XPx9FP6FtRZaqI4/ZFU/u9Zqe8aYV6DSbt3S8AxDVmmgrOHIiT2mx4VAaMgFIhRKRMvXRStQjXZuy7vRFi0QP+BJ7bf9mjyyXzd38Ll8T8v3Nis/dW5JAEZXGSRnAUo6QWXanjT9LxjIWtU9ijpc8Y2oETAz6zqSEkU48k1VvgyPjLg6MNEBS/AJJ7jiMXtRB8bn0Skerwc876WKfyiP52OXZ/vnMLOfcvTGJ10HXy+nB8n/r+2hzKc87loc+KEts69AHiEw8iFg002lANyB4ffsddcb3Ml+QolA+t8eCVf8vgmuGKygY4vxNsYX96fxxQU+vJp54LVHvgED+zuy/0LtSs81S2DOlrLfNRNHz1LuUlT5Ky/wcSHbrR2j968XZGLnkdLjTB3/hIivSQriPL2o7SGHVKViS7DN+KmBRUTKtJvcMQP6LM6M56pWcpFCIlPdqoWibt2Jox164zYRftPX61Hmlq2HW1ce1Y1Yqnr540LPHxXr+gpjP/sDfKoJmioj5OCeHnqUDxz0AvGKHCdwhtwrjxl+2x0zqIBw/Ogj8MGTT9xyQgXOM1GonYmELY+Zu3YcfMQue5R9F447Fo7bOw7H7YHB9RyDC9JectY+FE2msdNRuV2OqTa2XX649Vo5kaq+6Y9swML94kAr1HGMjQqoDgVXC+9Cyfkmf64LTnWzFUqpeIT6cLtojIc600Ux5fYCtHZyT/2WRxU7dC20N78w0TTC+eDSHJ7JAfxxx1R/dIJjqtdhd22NKmDtJt/eJOfGmbmLliFxD37O3Y/L7Far9XfcjbLQ+NtShQ3kVL/CFCragaWoq8HfIgBLL5l24R6a3KTGWNf1zkdcNDi3eI+q2+Z4FObgIH21hyuf4yfQq5fOJK45B2qQD45ZjoCASlOqH6lZmJ0PhH7LXcUiR/YMvfNUnCC2DwJz7b9OmlwkuCaH04lYnTFjL4bPmmbf5MnwY7Gro5gUg4QQdFJ0w9zHRIFJYGyKEimjrQzWjCrAS0md6pWvDKUk1MF4oP4CW5M8w1hncu8TCliiM9HEsJicuU/YIRnQRtSEHQW9LaagifDjl6ANANPAOot223WrzNFW+iqjFlUaB7NKlCqpbkrzZrF3olk+MsmoiVM6TrendNhXBOXtwjsvGkoHWAL40Sde9yNvHLB7r30/97GnPe0fZv7bRdyrzFB9vbsXwfab93yl/W/HwOD8An8MTl/HT9VlVau8iKS7sXS3yFRYpw/tpOlyzGQHRAld9g0qYZ6FTgM1dNPpzpMXVrVKWdUn3vLxt0w560CeCVnVx5GX28aPj9ectOojmIbcaP4Pn8aKmv3WppKqFzy33/pmy6k+elw51e/pTu3pVW6kavYqKE+bgZUy1x0m6hGzHB+7HYTbDypIwQBpLRXndr8/3bkdoAEO9anCxaL+sFp/aNdokDRQ2BCflC2gSOJQDVaPTbgy1yrHlrUsV/b9nj8pr3MruPVizf1n3A3G/PsFo74FneTuEQp4f3+ClW1VOdnWBCO7u2Rkw+wP8fEJ+Nbjdzc5+e4C8ard/dy/5QQ04mJdNQNdUwPIQBCBkK7YGgrNXDGTNNav8LBv4bTDNjNzv2lHbic/c8/bTFzjuOVpMptrWCTVz/Q0u/AZuLq7hZIaSgO0g/5j+bW/O2c+S1X+MCTPVJTQHf2lQtSRmVOMvQK+MZR7/AgO5GhFoNF+ekcQJkaHZZIrQ7OcYGj6RAHyMbgytfYfKGf1P5Wz6vvCwT3lRvg7Ph951Bwq7srLlaVIGo1PKFoDrEAyVXHyaqVtitqfQnmKei2+YlUgXe92RaiVKQxw3rJadUVoaGrKCCg8hd/gj0U/gPEYXD0W67xB3gbEwLKg+ZfmKeoFk5TH4A0UsqMX8JvrRUvFv7LUaqfV+olPrezw1BSPoDtXZRDMxatIByPixHo/dKrejhfFluzVnqfyNCz8PF2dSHoInm3fjqe8vnXktt994vAqqyxpsxzjLMM8rBh8okBYRa9q+KqIhmAqgXGYNevDwgf4B0W1aG12+jtR7IsFCW6RYwkPhsoTClGBWPCOn75BxIKMr3dAQpj9L5k7fQgaNDFVPuWgVEXeAQphYEB5FKHAvtmdYbpe2muzwtdV/+PT1z30C08SJRQ1KCfHavtxuVxkc7h5lDcqGcePDZq4nbjh4Ef1jSP27YODkdMAxVFpFVCUKpJMUZaeNBMwuHg4biZgINcFpCMb6wgPj6iNC4xktj4pzgaXhVNXWT8VdNqEvqerrbpWtQKfAKSoAb4shC2zPEP/qKNMgbXdEhE/oqrtLv4Pnb3tx2qHLrr3/JfmbXc00ZJ9RFpp1pge/azpDp8ouJbTLKVHqBoz1H7ms9LTfK4s8OKj2S8KXs+6/BkbmNMMejKwXsxSm/iP+eF2mfAVrt2G/9PeK1WhO8EsjmkGtzJgEENMGY7hjiWEB0M7p+L0Nb7KOYLKiV3oTuwMTxyqGEBFA5FyhJ652ub4MR9xa1iHdFCQSbPgxdMTN83HTKYtJdAseAkmDuWCTQ7lQkgRYAuS/0opQjhxKOcaxp9omziba1O4Vj2Dg8Pmaw1tMYMbDBVDQUuGaGyV5iDuSPYX+HZ4fKMfaNDDMtg6cnQRgin87Dir+tebsKq++mF+vx8FZlnThrG5jQkbIQcbo+/3NfoQJ4vEnt1T40KtIwWyG+BYLCo+j1V/o7lmzFgMwN0ijtFkkK4RdlH3NJBa7g+LAIjqsxUQZ5BFF60x4mRe97CRihjUjUojMH3mB6je28hDqueBXTxBlHD5c/fVG4buUFixWGL0ae3+tIjUDkm1KT4WJZ0x0iIMwG1+CMkZaDsqstZXauCx8AQoQXTFnGfigNTAkS8TfCQ1ycv9ycPVFgjLWrmDBrnzqY6mpGhgqg10H1HrFjBkzNO0MftU8BNxHbKCxdTkb0RDEiXzW/+gQF6vm8MAMTfEx41xH0fnagi1jaPgBCq9jK0CCCmyykjo4YYckxnNGvJ15jTSGx9lCaflgfthVTp1z/GlU/9Krfj0CVrxm5MT7aA3OdP2jr4fekplph186ZSZxrHlTHvgt2rTptrB36npXDv4m7Wpk+2gX5lstPlkO3zx8OFNtq/XrpmYbVj4J2ebLuHalonZRma2vUNnW5WT8ktn8TA1x6Uh7ps569DQsVkXl7MuViSJ7ayLpsy6o7XNpl08fdoBIlImrOLRZtMustMOsLQLdyN9p+f5YIZZaObtezHM0/74jXrsWyuNEa2X4Ysq4cv2VvmTqcHSbtc6r8be7bmHikbvqXrZW9ESDGn2E1Z7aP0I1eQT3QBwBHmKJZxw6/rDUb3zR1Tvwk1U77xx1Ttoizw4qnr3l27z7bbbEab5v5Hq3V8dd/98ry703wbVSYPqEQmxPjMhxPKrWor+SWopXvuNaveGoxI/XxVhH9EnLwlCuwhtgASjz/0fVcJt3BXG2Gu6mSwKdwxn0S4ButSH6kOwqMuRCaTbNRAso0UXCKsA2i5mavRmYV/F+8+oimrVyt2molq4hQBWbS6rfXRLs7pDXJ6aiVGNNR5nlP63WroRRuDLE33xxSlf/HIvWrkuePGIJOkebHSq8oANJw+QTcLb8K7SAE2SHcS7EEz1i7vGvnif++Iu98WH5QvD7mCx1o/vHvv4I+7ju93HH5OPwULLhUiUIQIkwkRNEFpFqIFQF6EmQgsISZUZQi3BeoTaCO3kEJ5n8VOOlGbAdpVKOp3nFRl1DuyH8cNZVLlazD0vn5chRvoCze7PF/G6S32fBrlvjDzhbGqJIpp9Ppxv0tzz+DF3YL9YW+H3+f1UP1AsQx4CerFMHVoEycs75ANFfMvnyu1nM6o1HEd28aB8i3QuX+kLsNC2kDpr2d8Zc/oZzJPMH1ijFDWK+TpfVcKOIX/RQVA+LSLwbx2KQKGNQagVgMU/IMQNrYk43R1EptSmubW81xe0kMyY3X+PqlGsROdt0DRJLOb7oAWu8lVXeR21ujNDGPVHe5f5ce2aiHVq5tIfOCtlWKmFv0t7yKh2cutiSZnSNRwxyg37Ge7+HMijGdgC9rMymJoSS1vbpEjchFc+CdGhXGzEBzSHT2Alr9hO2yqmgaN+5mwIb6etI0kEOGHwCt9cYJ8DyOZoyQItrdaIBhDMdFXup3Qqd3yWtThCcQc9KU/9tNL8pcZzl/FjkTrILm0KWcARTTBWx2YYXPyYs9boYapQFEwc0SW1Nr9soFg9EiWq5z4popMes86Rb0CtfCs5PE7GbIXNAP91IhDot1rsVUy3GqLzVkOUpxgGt0kNyvSbhGatc6zFfog/5n6banS+puShLXNV5uJCX5UStwARcX5O/vPyhuLlnFARBofaXMpnlRzdN0aOPuXI0X2OHN2LYOrw3dePHxj7+Avu4wfcx1+Rj/Vy2pJ+eOim0Q8fdB9Kkn54I4JpX5oE6nLATDupRnpNSybO36vdW8byBErDhMvncVrggxexP4K2S0EwkCDmPObAlC1ywEA4ohSH7EoVZEdi1HyrA0vLmBNzKrZLEZkaIyG0LKPYf7AkUUqfBN3wqhYaVD4coTnIqRPEx6SUDoAKz4EKc6toDldfR0mklFR0tH4Z90hvFN/m4UkRRrcjHeJr6h4q5zhQMtQogMt7DharmAqGYOWziD8ImBdZ2b5ifmxqYSBfsib7t2CKIth2MVoYEJ67zZPME0YVZvGn5GyRK89oHhi/SotKzpaFnM3T8onJGT9u8xgycMLjyJrMTP58Ok3TTNkIOcuogy3kHC6KoDyMEsVc/hymqM5Xq/HQ43ZCxsmFkJIxCWeGjC1pc6ntSJuEleTNgqLN0tKl6ngT5lJx3NRyYJ91YJ8ZBTuwlmtvGYqW0qpQtAoMluHjxlC3WZqZpG7+BF2byX1afIR0jalWhagBgFEFgMu0xBMwAgBbAGBLeg067tBw0aFhS2lyv4PjL8FHD71xgOk5wMyOAWZV8BHnY2gT/hS7ZqTMHs0yJKbhab4VQGnRDOzszuYRxCzwBjE9L5e+lXzBqG20TJFFzTmMrqISIygjGyGmZmK2W45CbV5X4AfCA0zZarBou2DLPDBkvsQQ0K2pMJgbg8E8w+B/sIP6RzIngSz4cyxGj+YwJ1tYwpcNhxeAraPO+Kzcrd4MAsILqUcDfcnUq4G+1MQhAOHYx8zLfLsRXwV6zArBvTIakGd7iMLrODsSqacCq8WElVOBmdppuZcBuZs0vJvDRJtN1xlsS2ZKxBTrxUBdB/F08+kIUC/SspmO84Jr6bRZ15J5OjrrIsa3DinpJ/J15kWjM29zzJmvMhJovvIOWAxUPpXDWJ+uaYJCbsrNmqWvjqWPm4s8wH6w7/rBPMabmzhnhmdZh4xCXOshmncezgrid712bpYm/0DeAQkBG6gmbOzSaDjpBfRlwexdqSlZsH8trQH+jT9y+8WfphkbmAMxHZARzdhQD6Eu0zhh8s2RTuCOdEQW6rRgVTrjYzcOcQwnIkMpjglLcQwTCCeOkQ1ZsHktodaCNo3qvLLYx9svh/3yRYR8FZ1XuaRf1XnFpInECZbaxQ9VxV4eIR6SpjIZo/Oqtyid+ASy6SkSmk9DmHWSsNajxiKehLY9lFR94JOAtuocY5gcrMfPClFQ3d0DSjCFwkolscpjaxRLJVX4YnOv8A0UviOHmTGaYiDqlIxhvk0FYl75CPVRI19lYX52/4Rasd6jnQCxO7s876Qv0Vb8VtbS16zEy9Dlx71N/nVmWEflFjeP8dCvxbvy0Dc7HvomBFOj+TD2xW3uizvcF29C0MotjIhk7MO3uQ81SUUk5YehsBpW1pDHVvqQ10vxQVLKJhql5KKpgg7D2LZKOUa7lHzMlPKOTikDyQSQCM1WRQdz8pHKLxZ4Z4Q2V/lyalKbfJp9XrF4gFIOLTLLvb9YotbzitoB1deYBSWlJezAjTSDexAjJVb5wp2yTviyMZJgTc+HaqBOsqNX5ecFJ2Ooga5zgSMyhgbNirl/WKSd7WMk9RsrZ8ibqELi8xQzVFKLbh+eX1xDtriGxEIfa3DmIAtWQl1x17oJi7DCa+xBTEcErjbPK8zzckoBLfzp5KytiUnELerxbJn4vQ5OFoWjE9SqMgo1wyggEWEybEjNsAlkwjXDjrRKJmFFRSJqloxqjktYUb6hVmUSnGtnYRIc65kYGGPt504Kg6AvV3OYTPgKYRA0fDkYBKvs3LUMQtc4i3Twbjp4N8bgDUCnVDfQkrtT2NePMAg9UBOBXlyJRJ+pkfvUBkDBwZJlDCgeY9B7hkFHpYJVYBNaxoox1marddI1IgZsUtSVlcy8edGC549kyj0vX1W8UokjNxwptefl3YcvK3gEAoJVMbr2iAUENepOERA0xwQEs6C3s/a8su32IOo3o620fYEDXZ3wNUrLsahVxAJ1BXuik3kWiBaPiAXagHybZk9GLNBSsUBtXCyAXkmzmSjNgghxq2i2KhaooRYtuGhVxAJYeRt6V5sJLMaxJf0p7/EZoUDedexh5KAxB3TFRkws9WB+O7Z4Xls5FetpFZuxZfPRlkdGbZapiz+hNeKmlfc3grS0oCxtLJOrQfE4mYGUoKZSAiUaIiRr6Q5ZR7DmpARxKSVYGZESaKaMVkakBC1scmdVnd3HmFGdS58FodHzYnunIqIFDIkjKrUKUQFZkdbSllJIoGEVEnSxBexS0woJmiokWHDgb28O/q7IQRYM0UkZYPyYdRCIjTFUxfRJYqQygmqkEKKuEiK9wjO7OQlKxkiQ0r81JURyTl9z4IupCXaAM1qXwM1SRJBXxAQLDimXlYqqmKBpxARVzNziQNMdA02kmNkWwXAdf+WGV1YyEMhpmKpigmXshWPqGsoc5a2peUfFBML2KG7OjogJGNtotiImWLFMgW72qiBcoBS4stXg0Yrgi+rjljgytf+zY/2v0ypEBN1HNiO7lOJPQdYWgM3q0t9muJRLf0yz38jS33jUl369RQpyzmnV9b9WWf83m6qqhGLRkgO6/sdTp2I6ZSouUGymYt1MuXST9X+2EklpXsOUA6bJtPN12tVGp93mOFPXCadEyW6znXigQxktylrgtv2Ycw0359rqs5cSlRM0JE8MkkFN/QCLJ1o4q8MEls/JCXrcBG2qCGC3U0/lBLpWQU7QAhmBMDTR1qlNaSsnCCoOAt4S8gl6wM7Gpt/wg2IEQRdJbWyGiEzgMDyhxCjPrHU/RB6a1aDGcB0WfJN1VYN3BoMl6Gw2Jrj5HErUFX/1tP544Ef61Nj30Y/g3/0Xi8dqqCpdxiO174vP+atDv/bAvU++CgKDWOzjtTbWb8dJD6Xi0rq9sX5bae4QV/3kYhoGcQYhnU6RiMEj8ektOtNotXhXj4lDxIHEanNlFR2pK/oYh36NtEEv4KofDKj9PNhzwYg6VVl1gFk0RzWIfKO2dJO1VtF5BmRQaulCbZCIvfnsa5angmYuI4pYP2XiKMMsWMAgRIQDcUL+VYwGGZMsitpcUKkTNSwSV6/yqagaVN5ec/866sN0MRHUyQ7eCPzgZtEjEx/h+ubxBBrRwxFoHF+k4cRHvzRFfBT8m4uPqlemo+PJNtyV6X/wQhFPvNSoB4LyVqam8GCRPDMoPZ0eUF4fVbcEETaeOOvnCxmODQmO+Gl1TfqJXJTh/nAR58PWqV08YF7ULh5yYRaiBSVxIr2BH0GTSkCTLkzpfvzlqiUCvH1DkYCl2Q3CQAlI1G5r8DkANQ2sYcyau+/yBS9Qk1BWKhOUOpGKZdwG0cT7amkg/OwayUZGiVDM1EL2ZHq7mOr7YcDz569il4kQRF3WQ7ZkLFttMtsB4J5cFwIZKKdFmP2zYJiX/Que+PhjHtDLg9bfy3QSjX/yILJmD+EXaYdLQ6CfCHy4+bf6n5Hz61iH2Zt7uPlTeImEIX5fSJ6a+FdrM1Tv74JWwwYQnF/u8tdQPeTpkpRtXC/NpiC7/kZpePYexFCdk+8P4Z1GgveETCqfj5tddbkIxw+uzu/aRCA5ypN5GEJdFrPuZSiyCLBUcI9FWvS9uJGBSfEgdOTQvgfDtewGZER8/7X+mqRp/NHrbfzBkfjXSzx2qEBchkaNe648Gnmw0Qv8RnvkHqTGXjQtcreL/FAZuXNaZHfa560pkWWMNrLO4/cNXTH9639N7bz/DsSDmr+HnO5qWWmq18c32NduGMPb/gAs4m0/3NYLTFPzh5P5fygH1Uv/1PNHbxvGzoFp/xhorBW+ABM5hCbVHwzQ5S7FQL+fv0po9qrmg2kKzZfZfK2RfIwvXPAamK7bvnT9IS4eJgpioOuNwEK9mXyfp4ZY7uEnCuteENyNIJ+q+RiuL9iXjF8e9CiuXs779TiC9iHMwgRVMbKnOWRsuAa9WXPMwwRZxfTIDmzs+93f2HhdfP95fIH/8fLvTy8eGMskG8M+A3jwCW7zesVBMrngVb0y/vBecsErew/6RQCic0lPLlHWvqtX+OhkaV3ZB/XGzs4YhgovM+NZjiYGWCxnvIi86YZogueQR3g+izzxn1rLXq40BeTwatT4dOCcTKXv1dgXkK/mbS7XbzhNDfmRB59WCiA05G4ve4VQk7piLhKs1SPQWpTeckaUfCCdXiHC1/d4eaKl5I4zUisV31u+Z69EBWqEAimXYyVy9yQjzEqOfrrqVqmv50F5VOjWLorcHbaq81+1D0017amoZ2IB3HfrLfj3Z8wbNilaH2aHpBm+Ionocd4GtBHHbx6W7hvx5PeDeHrqZeyQLiqeONt/NUpQy1xn6e2yQBehVCOzQsGkkdKr1ngUZkGGFlvShqrura1Nib17Irbe9kzzfWMjINUmyy1YzfmaG7Wiyqbjc56P85fK5NfJKku40ODstfhqBZPy9GD3+cHNPoK6ww0O6YtyKQ945qWGZdG+YI28w9fPefEY+BLbzWOd9vdwEoyBfcqYdLnbF+vz/+1HPnvbLbdc84EBm5N836vu/rlf/ZPbLiIXBHt9zFeCcReemAQbfoVc3OtXyMVX+CW9PQqxxIdV4lfVbD+7dtQXs1tGe/UWJ5edMvt8LvbDkqVGCL9Lw6LcqkFRbkUw7Uuim5yizYcoXBPKygna1ZRjkjnQSboA0qWj9zp8DEClsAZ2o/PzzjAsgnJbse/BN3/xT57xw1dcTGEPiW8SfBj4B4poY4LExSMkru5IXL1K4uqOxNVHSRzY95BJHD9B4jCclsA9AAIXn4jAMdi5RwBzOQZg9HCf5bK2J8z+YT8P3A2Qg//P3uwnb7QW07LDElQjfoHE/BRi8KnOgurIVmujUAoA9YtVx5o8PQA1Zh5CS+p0T2FEyqGjKGCKdPnCbO4CdZ0rTywfuuGX8ckDNxkDHc6fNpPRbep+tZ7qXS69iyQ3vPnpvdS6pYlKDpwi3f7H4ND0FsMD8oQh1voGtvWHIn7n50E8PdmmHo5UkiAuqZoIh6pGHVl+FTcnfdBI3sGDNhpmtQUbWSGTmkOou2UYVr/qF4IC9mTUNJT1c3yjq82Shh+Rf5/ltxmKwGjmHYwtPzOKN1ikEuRzHPExrjJ2rlZFx0QIvqmXQqhXyBEORwz8teyn0JCiofwtOgDfQwsU4SDgtohS4nD/tohHCBmhgivxGgcWF3GZxmk+jeOp4L8Bj6M+JUduKZoIb2h4kRapeWVvIK7mqreur5Q9BzVFPKKmfooFvU9S2dILeoEdRJF3+MUinkmxBJdeATVdgep6SXg3CJVVsgZ+Kt0PxW+5a9+gBdH/5tfwBbxNYLiamkUzNhWp1hyKmNfL6YKilK7RnHGJQJ21XA4W1lAYFtIFRlfH4KNxEGzgO86h0AeNmgeMxajear6MeLGutwpNRjVWITCrFbDB28RWE5JbDrdpaUiL60CFOVQHnUPUd9vnrz961yu/+oavccWbGLkIEhw1zKPaSJc74AY2HeNRF03E7DYxHypjdk7EdCe+ao3HyKtiCVCw3F+82g8xT/E3aY8wfMqt7/zsR25552e/wkKAhF8/eou8QyaAXUcENHe7U/Wmn/30IbMgqVNCXy+8iWENOcNUu1zQjR+5ggjGRvmjhth7Rkb1t2aynbtXSqqJi0ewJTFj2ThJZgsTpbTtaW2/5Y1YJuyk/cyYpPSzj99oXKFa05TH4igo/VsaaOx2JMtTLRR1x8x0qg/+12c5YV0xVykulN+UUYV9rSKpXAu0vuuHypzUnQkJNx3RnuERNoNsKNF7OHdI4YGNgk3OJmZtvPxickH2kZWAlEEu4uaqejAS7pvwtpo3dSqk5Kmp6IhSvSzWLE3ztYRhyvmhpqHbjOxujPzS0lkljtI81BtSuPjE7+odyDo0MWCACBSPDh5ZnlFL6eWX0VgRczeGwzEYGHMpp+8d0sw6fCm6bSL5FRkwKsWyATV56WkRSk8LtJQm4c8GIOCfbrjOE3l2A1bF1UIcFOnQF3ir4zi2EtPaYLopYKAQLT6w30bAJEdpHIVc8KoeUm8frvPDJ/4D/VD1BIb/nLnyZQ74dQWUZRynMXVRW6FZEc7XhUo2hXaqBB8UUW+2giwqOWwyOUXT8GFJGZtUR2V6rGLq0JVcCbjSxm7RFrEvmlnZGGLckyPcfjGoMkLTfZ51yI/RsR3D6gNJzln8PMtw8hzcbanLsdDvsI0Xd//fXTN/yvX8vPp8/3tRZv9jNfaNB7qRByYpO9+/RJLu0iTlFpn4qQOL783+5FXCu3BlRexiVCiCV9n2OYGsDLGqMlkfdXi5RA55i5SxHgTIHpq0+x6jR5B31C9QP8MCfk2R9UDhYFdElS2LDl7nyANA5/nEYuEWgdnBG8/p8wIYgKOhrMfVY+laeGOx+GDMpBNr24jHvRbN3UKzt9D80FKCDTbQ1zL+7VU+N89LHi3Q4hHOxZFQFxV7LVkbg47RbtpDtFr2swCYGGlwlC9Rypdn5DMYyeep3v/ZV+GS5FdACfs/hXD/HvxKb3vZG5RSQqi0kP3ljfLC8NbvEZ19WSN53ZKU/l++GuWZ70pQ6Lc6liazfqkjrwn9Pz/ovs0MTnzavGWWRv8PYwrLCF1It1Bduz3zw1L4klX2T+dWNlY7qSbt8ACcEsMB42fBDtIw+59omV4wJy/7DbUeW0v/H8+b6nPOgyApwIkZG5YWYYm1u78KWaiEeipFgqgTULvrNfKp45yvD7xgmj1gw3/ddKOz+uZcQURyrlDuvs+uRRBPYAMXgUlTE/b26uVouqQCVR5WFVjvOmuS/WeQXa+L+kA3vKpMIJLbpWZHEujFZZS1JjqG8rvHucXcJcFz18TNEVqthaix7z6DfvelaEHpKDNSnacIjVMXcaBpRl4E20SAs89NvkWNHaoIBtnziJ/22NLDjj2qcgbpTwRqnXTCrYeeXgI1DDHV09PsjSpQ7re0N+WuiYyLjux9FiiJHgMhFQbC2loiRaI8u1YSJTygPujJDYlGHlATTjhgz0ltl8hwgt4rexri0YGtUSXGgU0INIGTNEHNOlpbvy08WtQGD9s2+mdoxagTBN2Ydxm3tWaz1WxhYM066esoBmoadQbLiUS1bFQHlYvRda5S26m+Vl2LsBwKiIw9OTce9/iBbiFJ7P0bn81DNfvf2sij0khNHpTQNStjLXcMAqyyicXjwIrfAit+U7O1cjO7LIyTGS3c4atLKHCcyn9X9oALA4qGVakdRt3S7u/eOxgKMmysD8qyjkpZbrNJkc2+FzI/CfzK3sGVbN4C02ZoiOd39xHz/KLOv8KBcXtpej+n9lGtxVX6uPcn9xpPTjcBwh7jfIUIkjcsvCNSEQZXsdV34BipsL83Dy3/X5YBC1lfZkIuC2V0ZDjIjoqoJ9Z8FDkolGkRAReO2s9g45cTFWWNwxefQQbzV3piENyy7z99+YHf3P68X/CwJ0AquywcZm+2RjWIX24WIxr+rUMK1rnH9nTCG1l5Oe+tmnOoUPm656xnHvNHThdUJzhR0b+xg6Mixg2Z6qEcWDlcpSh7DxIKHSqYQeFJIoqoh9kkGxSUuYz6GuuZn+d/hOcOTsPEMaFW8hF/LfsNJ6Gp2f3C7r0WdQYXDSdqLcLb933loY+96HOnfoZNnUVVZC7E9vaVPRNz10Uwt7KbYu6oO4qYq1XOGz8kQp6Xev7UpU/1wkPewusaqBrjC9hlc1DlV7ogLujVx6T0R5OVKyR8MWxf60cvJE/903zgxpHV8VFded87XvY11cOko54rXq3V/x4OoS0NdduOvSUSK7egyZ45DgjxsTIgGHAKuGAH35/w/EAPzGSWwSIsKsEBupV9w94IVrsR6SdPkA3fiCA3fOjsQ5IkBfwBCsg+gl8KNoZgyyumG8vtMxOjDX179kc/2h8aMvAOnKf5eoBXlTVqPeWu64GSfj2RC/KdoKz0iDSQNdI3ItovlykJ5+eyWO7uO3JaMaJTYvUQ/+Tt2NyP9lVPxRCt243QVI8Af9Wbpj2iAMGpleoOcI/UmEO1V4igQM/89U1IZkWkq5EyoZLLxgah/6ENNvAZpcqraOJhn8VnqfZQYTYk79n5iDIGhem9YaDS+wqueZqq2/QNb+opmY/jB04iBG7mAG5ujp6T3ekVgR71GEH8TZ4mvMuzYvjD+PCBmgp+X+tZya8H3V9ttMJIu4FvD3rZRwFFOYjLA2WZ/jt5Y0h5nv8cwFdLrXjdNUdvkR69hezyUHxcXmVO9kAK9DQPRbRKy00UVk7hPNDDmvYYvOYot/4ic+oV6urf0tU/tsyqiq1j/u7n9Shspx5Qraoge4EfenhhHBeThO6ryTkGgn+PYMudYUFQgOLIHZaFOCxTQb6pFlHZaJS2H8wTPkGXR8/XtD270NvqCdmbAISJ2JsnYyvEJUofCsW5SDAFy0BwjotpgcW04HiYFm6GaeHJYJrOUYNffwT8UphcDUWrBb00n+FGzLHac/vQmUFEy/qciJ6mKBhyS/wiYtwrMS8cwzz9JNoc7yZOfx8u3vkW79wmyeEdNlpvdHjnj+Bd+DDxzqdoFO/8CbxD5ATmYT2Zhn461R599PPTD/hBKOc/snj+McY3DwC0Y34eytNTPaMEL5lZL2O11CtS4erxeeJcYI168kosm5tMsvLJ1JP0JCVb8LGLwNmUx43qrGt9HWqoZQ67oQrdMqqrqrNfup79tLjvS5Q5u9utlOdwA299g5ZnIlgumJSrIbngVTiDrBO3H2ePyaPJ6fzJy8c4nZd7YqvWYm2ou/dITEGZKzeytf85O310L86PMLtZuVD9EjmNAEZeRT8Rwq4q9e6k8uI84FsT5U/mLrKehvF/F/Y3/pC5fhQXIkMoHgCkHbeiTtWT1I1+AH2mvZ4xEwm+5xblrgnfW61R390ILfWbqp7L/gPqr+mJ7Om1THy+vFyo2a6aSjQY4X707Tc+pfY97RqyrJJvsuyULH6Z5XLsFYP0OQJXwJ1hiYf0G2FlzYuoNAofqiyB4xEOEGWID252GSc0kk16O9ry9DvR9MxCjvyKYqjWhAIkpPY7jV4msKNC3cL0r4NxRYLdDtmm6Qqwnhwao/5xFMkEB1TshrhVhCRup440dEXxGVRH9RaA/qyuZQPlDMTflLEySnLBEqFVuYDK2y5c572sh7eFMjETmUSZeAA02Nh108N5pksFKM8RwVc9Lc6GeBH9uP65kDyua6IInrI34cVIO1qgsXIFDTtwnWGAqXWc+Qs6C8Rij+QvEjnaXEM7KJEDT7UVL4bVbgcNUYc58HTinLACT1WJqfD63iX8GT+Qq04ocE02cnom5quetlI54zlQ1sU0RRv7C4o0aN0vmo3IbrfVWOQfN8Fq2Z8LIdg2LRZTUlX6do84t3UsaoeHD4TljbqeO0nN/+v5073hMrhl+ULr3q3iXlk6So8Tv67rmRGw6ZKtM8Pdsq7KhDhDpaFvCb3GdRMI7Nym+SKt03UlYqQRXDO3DlRelOwvGnoikowo8BbQnccNAJlbzmoCUkPuInGYUzEBxXuv8WBDMYcOkKcvDbxAL6BxzQv78Qu5iOyXrLaYIJGxklVKaGW/3LD7QjRTtS3lwIjSvtzvkC9ROvlskryncg1+faaQG7Ht4lEK+2p5nZqc1yyYDAdpXH2NohcyDvkvFK/+wTU4PYlZdP4Uj7y3v+JGnGFXvTuVlq9QrzVggXJ1RnaL2GxUs9yTiQ5MFczlAJeI8gKjOpWp98QeP8By6IP09uNq6bN2J0Kn+ztx4iyhVZRhtti60PHPY9ayO+x0zESdNRNMwShou0dmwqcf1n0Db+p9A69638A70X2D656udw1GfLXVKex/bfSawZtvnLxm4P2bXzN4y41Trxl4064ZvBV5a+nA9+PrSl2f3Q7IJbbLkZOKjxXpbWKoUyEK5G2BIsX7mHH1AIKYsNCikelUv4ZdNVfxt86+KcV5Qx1ofB3Fb3/FU657+Q3AN1/xzVd8kwepl5ZVfviKbwgpvklI8c0jJVySrcePEuPefu2TvJq1xKyUQfogk8OItN1swbHY/0E2U95247eizZS333jyNlN+WbHx52Ez5d8AFznDvyIu8ieqyfdwUfFzfoTJ6uHv2k3A1FVkXFBe1lfajpvn7nIyRCIs/V3jzhbJ5UbhK0dk/ALDvyRPue5aXIk7ARiiE4NhOgh4nd3IU+c9OcCehX9gxl0uzoufEqdpo64Bgw23s+PkXFVVACoMbmrNMeR1e2rGPbiBuwinQQIUjgKI8qC8Uh5QiEuEE6A+u+rKCT+Cfup51/AjVLP3KU7kCOPGMUcY4fEdYfyaF8gQT7mSWTsdO5On0KFfggnjX7Kb8LNrNZX+hhRBS8gcXXio0tNImXzcZPLVyA97lFfRLAArObJpn6lbv7Ev36lfVu8GkvfILr2868bxSy9e9dKLd5KXXl76iExSP6IW/9qN/4ZGtEd8pHji3v3GMR8p77hxuo+UEK1Mjmdje8wRX2htbL8VPicEHrpXV9ZRj5R9pe9en3hvpCvVpT1xO9u/TibXC/npv+Aas9LwzzX/b+4by9WpVE2Xql3rIpRIcar//5LxnHAFtk7bdeukwoSq/6P+dX1ieL3wGuTXg5F3PYqNRQU/ejLtRb4TN9m2lmzJrtXbdBSu+66REfB0BE5kCP0REKyHl/sm3286LYtjfkmP+ur98cP+mjnKJymsLrvkxChWN0TycxSOLLBjw99lPdHkamBgVCcUiqVqq9NY9hF5kgf7ni+EVhPn5Cg1DmOVIZrGBIzsHPAxhfxhApYn+7QwH1wSPivaFPJD9SzaY3oWKKxocftQjF2PkxfKmhGq1nFYujWtHrl+KInUAUrEfxY27o6uWw+Oo2KckZ/9LZqq12BHvS0VUfZ3SFOZ3V7shc3V2kv4nBJg05P+GLfuijrVK/rhxiKCv2939BP3nvP1M8/EffNSHjv9xoWIbp1nsITqUNV1mcEgrcst/yPFplf7U9cGaqxnN71OVObLC/nmgD9vUp3LKU8drwQXUp7TDrie22+hpl6f19J+xDWfu7VO9duHVMfe+ogpsqKJ2jyynifAhEiPI3HnGMgR4dw8JP8CUcgJzaXQUGEPBmZEa+LBoC+e03eu6cTL/h6DoaMQbzCSRFV4RycH76gK7/oIvOsUTcA7Egk3w7tyz78xAu9mBd6JhXcyAe8GrmWMwjuqwDsCvBtDrWYqvCOGdwSGagq8GwzvOk9Z8U6eqiFBCpwudHa/Qq7/xXOwD1BUV+st2ReRZGwF6kZjrwiUwUUBotXzQUyDfeMnhrpscgocZWqZX0KZavnhmLtbXlGmrKnAOs42JCmEUuXgNbwqSnx2KzLJyGvSu1Q/0sTef45+JghkcqlipPZM4vufeLn7RhOsXiT/Z/Ui/96vSOGczrrT5PjAy6co+DkIOB3C2OkQxpM6hC5dUkEvH2YljC6QJeoHH8QHehIRcGeO6qtsuEScbm2WiCgP0uEQAmCCtSgdU80cihAK+oIkZAzZJC4WSRUeoTmoIH9CXzDgxt2lWCFeIZGdQ/ykYFRfMHKyyO/z/GkuLvpeHprDLMtK4yURr/gpgoCN9P3DN064wfhWdSh47BtyKAjP0yfvUNAZrrgm9Mx1MseFhY6YqHKn8mRi7aeSoK4MUJPZnvGqNhwQ/mo4OhwymbVmsEIrMYxO4Lfkg1MG7P1b6jhw714X8tXtlRfHdg7e71SJtIXGPudrf+a4tzIj3A1Xq3mE8Bcq4U85U55SSqol3lYpEaTuMN41myYJ93Bz5Yu3jX0xcF9Ikn5xR+WL9419caf7QpL0iw35QrhYmUB9aUpJU3Nr828wPRqFKlZVo0VHLnoBc4JF0ifiP5Z6N8zkr6u1fG1P3mx5xiIRbpQheFCDLTlQgP8FlK6mSUNxaZK8IM/6Ym0ZxUjD8jnqYMDmESM9yBfU2mlTDzwX1acKGl8sI75Ly4hKUCHyy8lR/ys3SRCx92kw5OCnNCj4qoa41oREOcdQmO38vkT8d1nPAgF2xGI1IAT76+I7ARKsLWLJPl+hhLqUHVgTo5Sr/Ld1E/Nh28R+V0B4Tre2TrQ9z7mSLirhzu6hVb1j6hMzdtJoXEHFNhCmpcXUVwJLYBQ7S2konWJa4S/lNleO9rljBQrwWU7yzPI81ZaAB7DPYgdx+kNf9Aq4AmjZy1P2WexERearPd9hn8UpXHlxapnwW/ZZnIaECAl7+VrRVy+2z2IXF8TVkKRdsfJD7zr2JPssTndpP3p1cM6rt6w/0T6LMzStOJPO5JAWrQyffRZn2c8p4hAeEmx9+B3vev8b/y5/sn0WZyP2Y3sOfeBz/3zHk+yzOEc/l46+/XtuO/jMl77+A/ZZPAZQRsrhxT/YMvD++cn2Wey2Kf/ff/jQ0oEP/ccP2mfxWJvy9O/Dv1+42D6Lx2kKYPR44h5VGqxNvvbjf/SfL/yzzzzJPotzpaDP33bmqz/7mf/8AfssnmCreMnX3vH9f7X1d59sn8V5NuXjP/QhbugZH7TP4nyb8osPZLOzs9dfbJ/FHptyqTT0tz9on8UFrsER8Xh7BoHtszjzoe9mJP+EV1z40PcUT6Tt9ESMxKk8WH/I5fkmm30WTzTZH/qe/CKK6PGEzyL+LNLPKumnkqKmVB0REJEE7YgUyahEKSoRiCy65JQLutB05CBGBXIDT2aYabd5miGkyoChNfnYgBGGh8xgkAE9GUCTAStVgJgTUQmyndW+k4CsCoCIcgYBMp3Jmc7UTJX0bSDPIIpdkKkzA6qoXHtiFVTJdO4rjc55I58XIi7eAooDcyxbny9n69hqq5Y4dtiJpi/QWHwBi5VP4oILauEmg5rQpCeB0pxqjAkW27mnPHYXkQQuom2ScNgkbKNIEyJYadTFlrZqG/ibSGhaIKuNkHNuAhe9rRL9FRsd0UUYPBONJQHRXN+pJppWsY9cpa1wcLnVOQZoMmPcD/lIAZ0MwbfilLd4MgixkPmLkXBWvhcPyvs0rx5xhOg/heH3lH4dTqoupqccyOfLyvNu2bx8pexAvtX2UxeMJii79WZl1xhuE82vCRSw1vSJH4DzIjLnMUM54Tf1pBvLSvAk2Od+fuHzCUBRiFUvxqRV8lGGD4OR1QVCP4Kzh600lpiZROIhL8tZGc9FJhf8SHTHEjkyAV4UfazNbWmtTwVwYhGAXzSApyYvZZIrVr/2sF4ru5se9dZoeY3rF/u1rKcPJQFfzdKCo0BIl5VcFL4T4pBaHcYI+4b5FB9SqCe+FFYBuXJc7UTUU5D+FHqyMqAZFsqMZhE5Sw1EOrakwo/srfA83Owlq8C1q3gSTw7dbzVpBhsNYzWyR/PC1RQrGlNwE7by6PJD9lSJuA9ZUBRQB806Re0b5jOK5Qq6tGDuSDJm6Q1VuDYT7zn5qfKs5WdyotgURiG0pR8JBhXC8OSLPNxbaOUAdRW1ZNh4Bq5S7FyO6HCdKbz8IhggZIQMwzgfiSp4VBAnxbRNIhURbRJYFUVSOjWPhCwkgPwWAHlLX9h4dRzXpi7imJuzHoS0n13QlbIrhenKonZlC1ppmLkuAfxUCMhti2F6XfCkMHR+cfRdCUi1na6NBdpTmDYugAVcIB1hQVzQhLViiRr6pueUosEC65+Wk5bd7OwN2IkYdULenNhd7GVy/YGMVpOPhhe4JaP7NL1w5lFg/FrmgXVqqQovqmdh7s+kfxtGEZwh4AJ91dJgpHVpgVoTHCWWjoh1f3/M00tw0RSetCmTOSI8yTwz86xsB0VyC9uZams/weUTkQGHIg0OZVPIQIQth1BkuCnN4NGBOQmY5KmZG0fWNm3bbBtaEksNeCIW6xC50OsGtTgGj/24LayGVaWesCyWUhbPpfYYcQZwm9Hdph4zRvlMP3Fta9MMpUayfGXR7nG5KIYD6WjbnLQPLZFuZLcXHRUQJISj3+w3RVg2e6SY2/djN1289teP+X2S61KzXGZnQLODIc3RHN+E7/gyBvd7MiwAzcglqY4emnZKOR1EklJGGUOdI+sAinrXSUdvdwS12tVPHg5wuRCGtUSUGosWQUZp9ltWPw9I4alYhNEKlxIDq5jlmx26s/CYPs8Ppt7X9BWX9ZpRi18Daw1HwyLmsNZw9KgLZrGz39araGJnMo+rlzciigfpmwNW3tDd8EfGdsNH3W5YknQ3fFdl//ypsS+OuS80SU1HyRd9KY5qZkpkbxNRHxZwjzz1YoRrRRL1gEf8Fpi3+/FWtfMWrAuy4l6OG89egfxYQaQiHPxqZUVdVBplcJwEBVfKxEWs6iBaZ0cJEDkxdAe27fjjVfxkBwof8PXhpw9zHgvn9XIiSHKzj4f4d27UG+kCBvJNF12bEJA0m7dsIpTcyeeqUIHaH4vK3MbVd/prjQT6rfwn1xsj/pv0zIK+4SqDDtAXxgboHjdAkqQDdF9lSA8781r3mxzHsFDio/P8oz8rUdN1aYNjmkoI31MJ34+wNuDDZTA49HMIOoOsH7yOHeJrnHx1cyV8h4YhrvyIloB2H9VYBA+74IYE7zIRd4Htkx5r1zAD9Y7HIQ9BTCI1JIcX4EM5i2CNXE3lXRC8iAI3VC2oPr+AAmON8erK/SCDr57yImopJnZIWtSZGj+nL8NAkUGQACMtUbjQEVCgFySuQFBvUPxA1XJfljck5VNIyRDETRGrOH8/YhPREtQB1K0INTQNl6JVr/Z3Va+Wj8ryBI/LuVidjf4a3veWcxERDTcX4bze9TdZl7kEBqY6FxPJD4DldVCnq0Q9NB4xMVYvb5k0jbOJhPwz/Np7MTGd10nMyMgI5JtuVmY8TjI7ZU6ijteOzKqDvko7mzIY0EdFv0eBAtvpHjWNvXgBroIJANid3SWks6Xtb5eTdQbtrqPdLVUHUbikGG7hyJXIJJsRGXerA10S4d2Nvi5wzQMkSuEzIDj41d5ZemEWx+98Kdy5yKDdXsR47ikaR4rO6GooCcSmxIdurQIawKZHhtshGV6T4WAwwJo3lIM0XClBUw75JFwTYSC5LvRU6ZK5pOFXVJnVSocC/dIJ++lrHu7NZL+nt4sEyPjpDsh3dyxl7m3cXrp6rm24Y0Z3PZhwgrVxu7u6ORhWrgwP+A6qF0zqBOnhSFf17lbdNF7NPeLHgl7dyfIYjy5s/VBNtfZCIRQLElrFbNPTbxHeQl+6Bn1pMJJ6KvYH6GLVHPhn/FAo9ujxd3KcKwkNWNXicvHsYt+Fk9gES+El/IgvrF1snPdXTXSqLnhavWMUlHeM4vGr9LG9Sh+LrXdKgY2pCC+n3jEK5GxrxDZnsD4UsQXgdC4/kv7FDJ09IC44JE7UhEmiYE8A9gXNnCGzniXvRlBU6c8qS9iFkNoPW9UPWqib4zLGRID4j9Fr2ZK6g8v0dYmAeZatgVuTPIEzFC3WNcLsk2I8WFYeotomRqMhNG9QHS20Cx+/eXL9r07IMbCBO23gKAewtN3ETyxQt8mTP/H1eY+mB3fjWV3sjtkS7rOBB8ynh/Dpzf6aXb+opm2y9sgozv7EAKJ/8GW+c1TH22ZEaLPP5SNb0n7nqRhidu8tfl+tvLf5Pau8z/B76N6Fk46sFqmeLfQPUj7nzlCRzHgLpoxT4EsB+Yt5asAfauGL5TpqUorz5z9F67VP+l1AJkMLb+0yD5BbTkzx2J8v6BlGQDNKedt4LCodXpKiZcPfpabs0n1axq6dlvBbJNimbpFt9qJErBjRZY96drsKUxiSb4WQWkZD7BFY6cciHixmwWOJlvFYpi14bKEuRDBdWgAdpHmawx/rIc9CbdOjQL2uK6eBsrQ/i9qfQJocGB0ebqXyDyCWYn8lvrKnNoECTGFNIZdCdplZxGPRWiNZwvxeMoKYg2rkkQfvCvjlmcNQ5XOkg2XldZ3y3kpn4t4KNmVl8sy05HaZ3J6W3CqTW9OS0zI5nUimpoZL3MmOqQ3cOk94p3b0fk8OWMORA1bPHbCqmpuyBQF5GyLoMJreESQeAOjIXhFbXEMtA9x4CtR0R7hxxORZYAMr9epZbelVGyNFdXtay+uV82Xs2QNaX9jQ7PfRmUF6rdgtkObgI4/RxhO08fRkt9qPcdpuI5IKBXdHw4EpoGoBrbx+JQtA+nzPm7qA1kCRQ0afjLznuTaJ8XGn5a6rpK6XXXtvEy7c+CPydZH8yPgieY0XTj+cxnjooStTSg4gTL4+cSp/gPhH4HqgCKw2gh7X84wL9T37qNQXo/MG3ulXm16v1IA8V5XL93ASJt8z1V7zagHJaF4XDVu5jwuDnP0fJ1/N1x38GhTj8xSoYq726Y2/oq0OZ1vwZ1x0sJ3L9uez6hoiog4XhwnXps5+KGLPUwg6ALns12uXifw5VCX1JTDay6qp3uVqqStC8y0U6yZ0hSKtsCcqfu6SYbG6v8i4goyHZyv5B1Ajji6kD8V27iIml+pF1InFbGsHIAvCC9NNvIC8g67FwiFnz4SW4HbqXrZSCo4yeWZCArmlsTXEt406tEKraCA/e3hmf2joOMNEHdvVacsBaSmSUdocbaUE9VIHQl9uu0fZY7wa0nk/AAa63Q+1Xl+r9VBtyxAsABtFz5ZF02TR85sXfa0r2lFLlCvAbxOYWhkUDEmmMOEYANnfr9oqi2q+yBMwZgLQOM+kwpXRLqzgsUIZ6smMX6e6jkaGsVXQ1VV7JEGjEmoAVRrU5G/ypjluhg6Pfu3rkI5irf/wsDabwNo2sDaiNrA1q2Br+5uMrf6/Lbb+0SPD1l3+VGwNv3FsRdHTsDX8VsTWcHNsVdJ7qee9xIngQZM9NxuLCDWHhIe9iRYYFXJ0O3Ty+aklAVJTSwqPW9IfBJ4/eTVYAXpTILtevShwc1Dd9mqGQ9UMrx3JAL1LmJFQA7Qta1oCse+aGnvH1NibK7EfdBe6bvQqFR/yJlv2okr6tZPJByrJV08mX1FJvmoy+enOSYKL3FX55qzJb1YryTSZ3KokZ5PJtUpyOApmJ9LmW9uBVa1zW5PsY+p9h2rPbnuGr9CjjMip4MqhRWkpg5V7nU3lwNhU5o9UL1VYpXc3I5wIgVkbsX4UW6ZJ3E2XXlZVAl29Cq8+oIZ5A0rOzmQ01duakjcq0U1yfB9B8P0znzj1vvSc2Sez3T4+cNljtFUbVWMeIO6wBlq0sz+zViewE8V0aVStqc1U/bKp7cURa2r5TEWyoCchnM1pWReZDk1HZvtG9osHZXOqV9dgDw61Jorh2E8bLzNvByztBbdZKULUJ+Yq3Rb3mr6cIM5rgQxEAA+dYcFXnlKs1gzgZ4nrgj1izo3tA81qPX8ujHXetMvpPEjSvKlWFwPkQ0RSOfkpLaYegwNjydLfsI546kDSWMrA7JTl9A41fSNS2r3Cba/aDzE00t4htcgOR6o96FBdv4bux6eQgo0VtsoD/qjDOv7VsUqpWRmrJvH7yFiZ4NGLBhg3acqYMAfrdV1ZX/FedVkPq0Avn69KeeTUkYUssKcALJaz+IDqbl90rCKZ0xG3FvgP/tj/V3/nU9aHfEaIfQUl+Szu7eoA9ev5rDn+6lu7vnAlU1fcvITmNyDV0lWmbrWrm04IKBiIYgWumJUNsS59ZiCNpfnsf+karod/LfxkBapCKJE7BVTnVUA3WHk9RVbMOulxTTOIj813wZ6hwSIu93+jXNWiTvDgrMjYwupSA0ZcUnaFErj4ifWm40hntIBitHuxXgmOM755hvfASTXRXV9tOhegDMHYkA5VP5SPbn4AF1L0fOC4w5SnY0XQjAtjbo+MYVDxnwgToc0Jwey+vYynrsFAyibsiaJpgI+zpDTD+JFef3rLN/rPCUvtWmKyJXpxVJptKep5gv0923jbe40V41UIpMBDe+BOExyQmtWdfqqXN5sMD5zjYov8jLYHV2TBmlx6QUW+BNsUqTpPE6feMfGjo2IG6NpmCHoSnDXfQHKiJSE4L5B7aEG1TfJFNMg0SSgbQpeD6cCU9bSmJeaZcUbwYACHy9QVjlkvHaTZZ4VGLJpOoYwtYgD8Um7/IuysZJfauGdxXAoFpWciTfmuGa2CNVW71CF+rJQLorlozjX6+Lu0Z526ah+109k7Xz6WF3O2x4Fe5YNZykzGLnzPhUdVXrYiL3sl3AVwu7SCxwr5kI9xS0uXtmBUt6A8LMtNOQRBaBX6wlAaayrBMvDJt6pV4W14qEINBXunOgHMWYvizoDqhMDABg7bwEEbuN83gXts4JgNHPVplQhgLNbyHVzXTh7RrXKnDC99X7TLduanUDPfSTvolH5dlJK2cQiIpFo/p9J2MsHT+h70bvCZYg4nFBA1QijJsFWFsJxOc0pAgmzIh2kl+XI6tZLchYINAxdLJcDMFBUtgeOGZtmc5mbNUcPMcBU8L/pixYnbM3eitqAdXGhT28JQQvatzzC7lJ20FdsR1rMsW7fzxK375gErVXQnHuGdBv/NYDe11ryrpfJ3Xt7jtuywkKIuqgDk1qqqWTv53bRybiyph/pP4bJ71ObJ0DKAOgWAon7rUg4TtilETUQtglrxHN/AncLKXbpbmczsgu9kwK+DxylUZ5htePnpGvDzM4K9imglTOgMBRGCp2vQQJV20QItG4hWwNXEhrlpNHP6M1qaQKtZrFQHTQHnBm60Yp68pwmsXI14KfLqwGm+UynXnJu1glaUvGHotBpBhbIu+RZk5xSJdTHj5fQ4APCdIs9TaFmey5ChK4ES3FjkYGBpVa1/iBsfgPZai1ocd1MggofXBrodBN0yaaFyfKLJ5Kh4alajRqobzPxM/TA/i7NhfSrO5lzTVyhwlHlGZ5UL1Tl0JvHjMW6hWnUL1ZZNFiogExYq8nOSxWr2OItVgzwlgZ3JxWoGadhMmMVqttLNmXKxmiUyi9WMW6yIZp+JNB3Nc4jKxeox44tVRqksQIS/4y9WLu+0xWoLrWpGXZ3yvFy0+ECQMQk4p6tX7iImlzACReP2jyxhM5NL2NLIEnbu6BK2S5ewVVnCim/qErZEBYC7+O0l7P/yJWzRLWGL/yZLWKFLWIElrJAlDJMfS9jMRrGbdk8sYedQB/B7DB7fXsIqS5ijP24tm0w66UWNsKgRGWHHLAcDBIVc503dAB9337T5kuTWohldizoUkaxMsa5M/8dvoU7RLRQ/VugcPBhh8Tjl0dhQ7eTAzqkbqhW5cJBTz65RXUTYqzan6BpGOSIm16geHowHeJzy7U3XN2PF+vaK9e1N1zl47KTH4LHj3+X6tVeqwQKFRhmStdO82uo1TTFIX6qkbEeZu5LTETate9rqthNP0AB57jj+Fg5Bo3mZHolCz3jxHT/3c671kr6E4XyqNNJc4xdVvct9eYepnERPXgPQRjVTjRBs24tSnlq9D8SKdGLUj0PiZBxNfLJSVhGgNCJ5dI2xQra2ocJNe4am2i+i2asqc0V8pKiPq/7ClLQ/GMACUJ0vwvhyBIWyvFIZOI95LYCk1+O/J5fRNmcvj91dHL/luay4WuFUiGApZzSjVF2x0XOE60dkPOp5Ed0hhuezjSPqEtgBgHz3CJARR4V0SzTd0ipEFHYGIsFJQ6R20hCpfXMg4s4tJ4GT7oRo4eviOvBuZCnge0fP0L5kTVyn382q1e7+meCdWtvLPYOtej0MB/2BVUa3eoF6LF49CL8+CHw4tq4YGA21gXqQF6mm11mqSb2Lov7Xt0NBrfVCPaRAU9TDj8e2UgI4CnccZQyj7R7c8ZRsU2gcUmT3yPlsXUapfmUPeckT5Ter4xJCWxUu+e58ObImamU1QavUxH6A4jIpbn9/EDyXwuwXcZYijcbM44eaZJVq1U69z7neYWz7RIJFqrTqow8AU+GRhgHJWC8N4rCGX4v6lQWjREBoNgc41nygh1r6SVmrHuhrWzJpavarqBldKw06x+nPh6EOgWdVmY8F5d0eqCk6gEbk7E9NBGrZ+9UHRf9g4dSD61APLh5MoTEh5l4jPfWuGOkyt/E4myw4QtH6u5w2dABtaL4Ns4kCtVyqQeBmG7iDAzgGu5YCaEff6Kl97AfM8y5NDo7iWdWO3rAFHLOBe8wn9+N50GlHY0hKzXU7za7AiT4hY6hWuOvQVERXSJwsiL8u8pWYr/CbKBOI0wlIZVBo0O+UN2wyDn0kKN183RVUxgF0CDOB50FRc3alAKu7gjWtM1QcB8mmCEQMw1f1m4tsTp/V6bkGjADOD85gIYKTrey67c7j0sHA6Rx4TufAszoHVdWCBPyV+mGk1HqlTkEPUtHX0XW2UXX2KpY9Y1nHY5wWq+lDX+0HQh3dOIMTvd42A5nrdpaTZ7CjoJa0RV2qFamaWUpLAWprTTJoso1FR2bUFm1bkvMEZ4n3+7J/7HDwHg1maFwNysxCFOZ0qzIvzcwXlHAtKmCWKJbZiIe4G28hJAOaSKgFuqDG6/k91d0Rlfsj9IXf54j/ShM2Ke4vp2rCxjp3n2PGTBXRzXXxeMp0WTHWAPCsTUnv5avEWy+oa6HMBBZrujxQwiQvqf0walqLNXWql8IBbtQYF5nSMn9p1X8XzY0dNFlvlXNVeGb51mkWa7bRVlqFovx22j7FYg1Nt1iTw4JAMcVizQ4kbJ9isWansRyyfYrFmlNc2oTFmlM1rTgNuxIUPWmxZpf9XIxh4CHBSYs1pyN2wmLNGcezWHPmphZrztrUYs3Zm1qsOcfZLnkMcY9cg7XJkxZrdk+3WPPYTS3WPG5TizWP39RizbmbWqx5gmvwaVRMsVhzHltQWYH5lfPZssp26tF2jERB5023WLMH2dXgynbu/mMIn53Gn52mn1XSC1LURNWclQApQbtV2qGRBqU48ZQyZNFlK23lEGeyyKH4g4f8dzr/uYEnM8x0lnmaIaTKgKE1W10h+t/uKeZtyACaDFipAkTuEJUgo2rfVwVkVQCcxtVtI2Q6jzOdp5kq6SuyFCyI2UJaYNZ43GKNoal5UwlqDkN/dXEWv0AJCH1KW8RiTTpqmaam6Qs0Fl/HXvsCKNFQlteoo35/6QKRDguNuccverBHUzA2S2A7rUjC/SZhhU7ThNNSw9tqTVu0GbLF7GnjzNt55AvJLmiy5PNMkRo4zd12S4Xjs6USo5q57IP4FnFUQSuVqC6iTgPullE7EbVCxZgIbguEL1tozur7to35m1T4VVXZYjHlheVK8UQknJUv4UFif+Qi7s1FMHqT0RPpogO5L9Xli9KQfFmamG+RHuQdrDNYDJyRG12FlsR0jPYvX6A28eMCa5kihxu1mkoJIHaVxeMCmC+FCCuGB2fAludrxwmyxtYUfJQx5LbQWGJmEokWqCxneTwXmVy7uYjFsUSOxC10uVRTo1lpbZPUExrAmxjwUhdGbuqKydKXeViaECM32RpXTqm1cFMzwqlm1cLNdmPhpkYcEgxuYhCbxj2MsXDThYUbPHyMb4qoi5B+EV2ozFuLPGNooaFXnJIilbPeUsGrf7Bk4xrOzqqdf9RQX/LKaPV/BpZWNcWYWo1tyiud0VT+Vg2mAo5WMfVvAx+aVE6sUbfqzKo5BsMX6lxe7aHr1aM/ACuTlhEtid3fbz23SHQj1qCEGszz/JW7YI2U1gFOAnsEQ9XwO9QEu+dBtO4xwsN5ldyv/rH9uA/lONGWmssEJ+irTqZHiTSvECZ7UF5f+uAA3L9RKc3u1RvZKdVRyeYf+CMfUOuIePHuvxS34xqiiJjdLpCrNh5NT59ROgfKG9DUE8XMPK363fZyX+aM7zArpISbYszJALSmrsCm4MKtNRjYAAlqAInqTgLgbRStirlhG76TPSG3hkMKbxnK3eONiofkgMUE/41V1zFs2AzdicmvevBqfl/3F/xDoVwgi4xFFk4Q2+H8QNusfRh1ajys3rmnWnaz7FKvC63ZCeXJ+evssNhNDjh0q4S8iiiiZS7UgU1Fk3SooiEgglA8PCLVik9wTo6Hg0ozlE+tiiZ+MvISdzHN7XewpfyBzTwU6M3s9QcDgIH3f9/LEfx4lj4utyKLUjk7sEDfi30PbjPjUEhVO2HJBd+VWaRgVaC9tIey43L7ejFcRYiUYI/c14SgpSH15E3dXYgR4mxNV8/CbSZFVtU01+yhHM615IG6JUGJ5vwrQTJGuUV1e3LEjWlzk9u8siQqckyIk6GKqedgsBlQKsUWTfLkIKyGbspBmEcS96xnos8N0WvNPgW6oJclPQZ0SknO/VWQNZUAY/do9z9Odirdy/4XBkmCLkUL/uuqim5WNCVJlXSRU31kMiiwM9MIaoqmLuANJ0Lqj4EiXiRxh/V5RVNNFjWzv0ObTYPxLZqsReg5Z0K2mtoUXeAKigiEKiMMWl3eWnxt6MMq1KQ9KDJ2n2NSs1N1jJNxLMnhEK7ZQjMSDYBf9tD3qXdKr+UD9o3Sr2E1mUeoMWLSuuFMWjcmTVq7dEnFYKEBskTZ/7RFiUCu2gw1zR8SxwP1wxTXol2jKpl1gngc5TsdbEn+HJKh2p79DULMisInOJoPg9ZHa8C9CKKfPZsZxwp2UUR4ds0zwfV8mQmNNblFy8/sM1I6NQD0Rn+PiK3ORTauUPNgdEetdXPuFyH3tbp88+z3FeES1+tqlwEA/dQZza4abfJr6b+c1aqr5O7aOiMGkKM5qtYc5HKb+eW+6DUH+ik8BrLtI7kyH6vMRMeEYqBd3qheAanjVogZxZZKeaapQXtGV9x92kbv+EM5zm8DxdgHl4jRXq7n+DNo2Y0a7ogl3M4L9ucZYl/m65E9wjdoeE5z66G9LYWUyWzzAT4YVbnA1siX0SLTJvWgYYlYnTO3xP5j0WV+2dAwyJhipmErSON2tg3xWja9QhkrhnZ5tExLoF0aZw/x+TLgM5HGlWAbIlWs5bGbG3AlKLRxCX+Vw3ftoXYa5/VjubGMKDlwn8zRrMkYi91NLqDoyfZDX1+mr86UQAwQx7QELpZbao/k69hhrKBYiwKIqhzJCznqKnzkSN7TI3mveiQfTJMj4Uj+5eBFEBqUocNl6GAZuv9GG7qnDB0rQzzk9mg+XxPLkjuqR/M7+r6sUztwppvvoMKcNp9iT5vr7rS57o7mjdctg0ZUd8YQT7Gbh97IcbPiHtWd0Ks3ct4cq8nBTLYFanIQbcHhfL1sUH2zBuG+kQdswd4F8soTN2j+hG1Rs491bQvDCdnLw/kdejhfcIJt3Y4Tt+6bCa7UTAHKcaxqZoUZ8rqpOY+1ZLVyewq23xZeKlME/EbO4Xfwu2nq/FjSKWjDTi79FOrkCc0YcO0sj+jr9ogeW0BMe6z2KxuQzk4c0WfUBRQDHMLf4Oena+hGOY9XXHMw0QN5dAndrZtTeQdc2kWLtMUAdkTlIWN4umN5U6gUUiQjo6fgc0M42gJQ/dMUYK5WvBWWaLj2ae5Tqaf5N2uOGLEzyKa1CWpola54JVJasot0pGq8VHvqvkWeMNCeWAqW8pCowU4lZh4UpbHIVBSlPVGU9kRR2htTlE6FVx6KjS1H5ttmvWpysipK46mK0ihcFaUV6rqGufWsQx5UpZdFPa3Do6Gq0vx4zOg6hsdqZQmb1wLNcgb0GlnOZo+znDXtcpZNLmdds5w1S01p189uuZzNlstZt7qcOU3pOp2jVYgtkscQP5LKurZM7enrmvTZLWkuI5Y0Rg46pZJ7leY0o13Q8p5Z3PjTqu5hQj0XUVnbEjwSu8TNjixx3cklbmVkiTt3dInbpUvc6gmXuPtfVi5dZehYGTqqoZNaCle+iUsct+PkaDY35NtL3DcRXKlOCbvEudVNK81jLfTfYnWb1dWtu5nKdAYAPgaPneXSpovci9wSp813S5xSf7fEaT8fwRJ3w7Qlzo2eq3xidUOF01c3NO0bX91MlZN0aqdb/aamj5Q/oV02ut45HWpjoFoIubtEfJxNl65W03dcbpnKdJk6hwJdrf5v2YFBjTpW/enE6E8/OjuynRzYOXVHdopdwCg2+oZjWzNKXLwi5LR1TJWov71j+/aO7ds7tm/qju0cPKBN3UUnvr1/U/1q1IaBwDLkqsWbxaGqRvX4vs5l3DmRcXKvh9o3064+3r4Pwc058xtKElWGjtkQyLMsT9gtFgv95JlCmebHriIFjLOJgKIOjyEVZkSBmvBDPR/EeLThW0A9H+CwrwJaDqgJGMTSAmY0VDWxy5GpPU8LmNoBzYOya41lier0wFqaMWZkFkzvKb0AxZhm8XxIxloJkS63QEq7skigMtpGhBbpWql9yPU0Rc4PKKIF8AP8Pnu983hhlXPT9Hc8z79WTQBln79RVUV9a7RFtT+CUe0PX1yqQ18Vwt5j/3T9oRoAmH0BX5PnzjGhSq++fwU+oRj/2sgj9Y9T/dbNamciRN2t5rFWFqAVon43nFI6sd8Or6p87FwfeNb3TJ/67CxerOu/5nqR+2t89hU9Bag4qP9JeDaY8KNgmSEFbmBdUeKoO2JksEkJaVx4mYmL+PVAH67Lcex9Nb+tGf+T6qK+6n6yJcrdn3jLx9/CJ9y+GL70XqDetInPYfsfRwpH8uPjNTZVqS4bs4+IhWLxWhOcbJ2hqTMRtf2K4iUrhXr9FzyXC1B/BfJdREHpK1OqUX+yyfnmK6iNi4akM+npSdl4hPJAWvZRtHRFT0QjUedEGuqymgTOzUQnzX4PcbX0FR5bNg2unTAv6ssJsWgMqJNtxq6K3riqjFOMdQynatbffpT9HLg88Hw4U86g2o9Ad3gEHXMK5OmIG/4gfZznvZS809WTv1joEbhJ531+s9DySteu6Ss961beM8c0lxubxEwlgMRMVDzMDqwcDEskxhsUrYv6uSiOWkV86aacDAbaD5kS0ZVFAAuvIcHv+RpwqVeExk6hr99zN9L3lM7bVTPdaPEH5h2IIubtPHsFBf4VudwI+GGIC1zdeDp4mHjGpJo+eLhQtvqFQQVaUqxH1qSXTyQaeBKa6lOKxPVNKF8JyF2pyMIFpzd6I2b2nL8K4zcyNEZgdfpZK4Y7pQF4EYVeeYQ4SAOCJnhwWxVVMS9aWCLra9ktQI2+96OAWuC0LML0pjiEY1NoUTtCE5vkGHoxu/p7sjcYdflP/ZHetVAL3yHVN1F77xoD3ruojiIyNRC2Ew9RHSerGhGJnVoYx6YGNDKgyRL1WXf8imugOm2NxVGIXBFDEiHjETZy59SR2vNWVW8tua5lr+KnC4SxlWS3AhYSnWuWXG5ayC2IVQkRh9AFHllPGNaaPT+lOqqUu7N6Vk9FiuFBL4AGTjdaNz1YunZRI3sD6iwiQuaiSRE03rBd1FZIQbzeIrnLVUg92W34ZqVcXhuid+T6VESoo9x9UaQdm9aVFEG13V8mZ2VyS4EMXLOaFcCbevbzahsC9dYlh6zsZkg0KpG7IeUnnKf8KsRXivwWVD4MnCrMi1A7UVcl8mfqiIEOANTUQHsAH+NfH8jTABzg8SqyhXITpHYEZSZi4OUWWIbLY3i0YFYbd6QyBSSaXZmQ4qyGW4WpGbu18ulM3nSm+/bqgJJACesRuCuBo3B/ShYFi36+I5a/Gkag8zgJj+yEPxyXM97cE/Ivq8pKQo2d8IIMRgRY2wdg8Zbcgikd3ZKzPtxLZPBgD9BeTzDMiOoaFXLnx1nE5uTD/2ySh8PCeXenZN9/+vIDv7n9eb8gnibLlyt760WEmKFzVHH7gOOGbgcjyUduHzpW0yBo0D8Ur8GI3Ie/xHVmD+h1CT6/iEUHg/yqh4vu2ftYBb5RWu1+1t51o1QVOheGXCAUvBrqEAwkXz1zCYgsTwxGs01tWVMgfJLODlzruBBZBdgf05c83AloAd9airgO+NXyxNh8go5SgosrYyUxEUArsMSso54GJwBv9Y5Bf5dkgnuWeMzoXcBYoQiIBZbtdgJrVFXsObcM8bjiiOCjMjQQWlgn1X3Qfbjkfuka1nq4bMkFWwd5WA6N+mHJhWUgD8pnfC/QK62h+1bNLIAsLFBL7OmvV1apo7URa7DuVky7Vipw+uSJepPqb8qpU/+TrwKHinijvekxBdKk+5Ak+pu6MJZllt+fu6bZkWqc5vsSrbqe6GRphNSrqKB8zAtURW/aEusrHw4tyECZOLtwMmSkDc/+6Ef7FGQ3Ct0OKSwjr+oVDqTkglf1WFYYZS/HB7J2R/0P3vgkaHyG5F9lXexFHB2/cA2DVua1OT3JaWhTiLYp81lZsNP76kFdKAnVNgroeVZtWVqxJkaUG7k7+ol7z/n6mWdeWb305JoeVJouxMXd0QRfHPKoVvpJwTrumw5xk9SWRS54VY8d67i2ULyuEC5im+XoUP0Hgm3lcvY9Xv59GZdDKXCanlzP7bdQfSjVaGk/ghy3O+oUwgojJYy9psiha2edr5JGKaAPQKhqJXeEI9R5AMGpfbWonJdVIShe4W0C0UcfkpBjMSQTB8lkBJJpBZJ1C8n6BCSBvPUTQDJhsj8CyQbDEvBLqT4FfomDH+BGXg5yxru1JlnwQTMs5QQv1c0hlJxBikahijsTzNpTjWnet+Fq4AqNUoFs4fdAefmdAwJB7zKd+OBmhWvY8HzPMeVUoV7qtsnbAFmqQFW7k4eOvJXU6Z4PYsnLdG+RlBc4WxJa1cu/IK+vEILkU1BuDx0t9Mmv0kDf9c2vDNMbHgzS6zbZ13h9GJ7nB3vFKsIe/GD0r+4zHvSuKTxtjW+zXM9ZPJfF612DhovHwDeJEVrd2kBMcAiNrtLInwHk/GmQUwdMCkAFhgPBQnmZNZPCs1cZ6hyARTd9vOfl3FwKy5eregZlQgczIfgbYJQqg3P7MD2nZgRSr5Q1BTsG6RP5p/uy6fafoo8+Bik9j6GID7LXCJb62T+oyWplMAWexhEi+rUGJUxcgf/Pnq8b8/+PCZ0EmoxZuv1/AbIAwzopIlhXv4DEyezuAm2NSDbQisaarD0sr/hH1FxLO7X+ELKm7Gu63M5xYdlHBMhJ9kYB/f/yvWhSxiTd+Kq7KVGTlqnASboyosUbOC3eYFKL16VLKibNSRePXnXWsn9GVrunr2X/oq9QAg9kP9FXLf1AtpzYz0XYzxFYKqFbgWTWbT90d9XppV6VR1wg6rV4hNi4iH8qgNLDd/AcIDfeuVnvRbMoUudkyJ4H/NT9idOr9R1m/xcMLpogDfC1D4HUSb7M+welM6Y7nqCYexXuBruq6jYGuCCIl6YXcPH9rkEHv/8mu9n3dbPvY1Z8TbHQiTMCyDL2Yr8Et5IYioeQBeRNOy0DIZl9ZbUsjiElkUYk6XMM2hJ6gwc+EmiGCk8wQmCppQ+I4HiEGVzSRNmBC2yVpUM2adtoPel3ckv7mekjN6kix9OaUABCwB7dGysSUVDZ+YXpXwRh47pYWDEnN/FKuwRgpqUohS2/Hfy8FaOYVgWIYhRU95SSQe+rhHrpWrh1yM94X/AP2KbJeZVu6ODSJLfa3w3JdGZw+EYmjHmTOHjzqxE0gvMW1fFoi3Av2EVe9WIGQY4/zOHqpHnrMO9UTc17uKOTh/zMXHTqgrrn6lC2UbSH4Fc9miGEaihtiBqxF/D4QXyX/3ojSSdukYdARu0jFPDH6xegHfhkFvG78lQzdGn2CLXXizZLoTCKclGHX3TbA+cVumsLqVnhLpriu6bI+k/CRHK3jDxouH+6JpG+bMqsdMFsyjxneaKWLvKPmwK17M9lBm6dFtvvGvL3BM+bcJyhTitazmfFy/TQ3s3qs/kru6sT1FapL5kbB5jFzGWZKtJWjVyF7/RDcevlljvZo+VMvdV72lNu+/z1R+965Vff8DUe+tLvpu7wlOdQQbeKys3O2R5oA49Vkqp3usSBK9X5CZz8uhEdDICVD5Yv0RG8f8m8r7traIVeaNOrc5DIuPMOHZOQAxjLujzhJ4AuzX3raMyXEQL1Ryt5UKttC8qijRESVMKBZKwKyJbTu4JQ5DEOaMd8t1ZhF1BBptCI233BZLGnIlDwqgAIyXNd1ptcavzEHOXQGP8bgV4pC6ZU9dXKa0hkf0NOy+T+mKu4QAcp5GvKtugNLToWdrF63FQGzFnQ/oJBJpKeIjhShOvGZ2I4HK4bppG7SR5k6jXtrUqe9WvtL8Rm4g28PqUaz8mRiuRIEazLLZ2IgkoNWFtRMQtMIDnDie4YkE7IYfk8To7Fipil+mWgv/8No3+o6J8I+iMkzld1Fui45snobAjK2ZDglYl3p8T+GtCe4sqhX9EQxBPjwc3jYb49ja0r5qvgdwzzG9MwH0UbzEclHGhMw/zdhqfUy6reGhgqrPQeX7/pIZp7hU1b0MveKfTlXt8LKhQtdPwc+I3sNS+fwnSpFDYa4ekix9NFkzydS0eq8nQPpwrck+ysSfbXIrviFawjvU5fhV0j3/F2ES75vh9fO7Yu0nxBydZBiwtYbNi6SNm6CPUr6zGFrfO5Vb8p5QbmkEIMRfGT/FG2LnQLwC/6IUyv4QzmG0JjYK0gMgKyOzxi8Pn4uBxPx2UgFk6mwWopdQ2nE241OBOfFPqGmxDusCTcIdA3nIa+93h++A2vdHK0Ng4Bzq9Ccu1pDJZ9Wk9RKwhXqD3U67ljPYym9RBFmh6icA5E03r4Js8LKxx+qJgc2V2FGk5Qx8wQpIXoum+2KojjPZ7e5vQxl2OEIiH2QfYTMhXsRqfcGQR4BTqDzZWr49WdgbLBeuDi9gn7wEMfq1kmun/U8kOhbhTg1xIt0EZnh1WqYDhbwHpiy/CTL/93sGX4eBS0hVlzG4bAEVScg4daua/jLD3Gmbhx1oy53F9YEzQ2MTHHkLtMXIOnfpNU56SzJGkn1c2BpEmCIGWPltPfdsBENkQOQl72IMgXthH9zL2m/BpqRdCQ8/vbif8u62myMPQ49VRvxm9zXtn0UFFseMyUJD9Czhm1oa+fIaccmnSYH9hEdQazEWdFnKdMJmQ+MpJHJ2GmNrI8CtTBLjywiYDnLLjVdt9nR6w+gRoc+1mdJfgEPpTgCpjDcPLoSUGOflkOQKqkOWQwE/oBT21fOWiJ6QuUM4ce5nPgstw2KgvkEjZ5sNKBXLPk8fAfoJm1fsww8WBXYc81a5SVHR3QnOp5jNkryCpMJhajqs5HG1naNIOoGaO2DfAAMoCLWuSDBNPIA11MU4ViWRkzsVE6Or5R2jYtFkRDNy67p++UsIxjs5TdNL5Jut1qnLDZLwWoh5l4UdXznSafVUnePZlMleSdk8kLleTuZHJSSW5Vk1OOrfTv454XXWsUZyr8ODRxfOUvq86Kq2d0LjZWj8mC95VxVR2HWokLwpaDysdDfsj5f2WvMRweYVF3EQ7yWNgRCiYyyKfIlccUgTs3a2eMo808dv6Q0/Rdnhdeq47JMhAqJ1/W46qyT3tHJ66BBOcwhyygo/wY4iySX9xnRYT2VHZgkl0zD3lrocZpsENwObjZ3AukCfUkbvqtJiKBKP2rXgzjtmqvIwIHXINVVFaiu2LUlyL6HfDjvtrayJhAYdm96iE7DCJAxlskFUsryfqwkPMtUWhqyFmz1CMOr/PmmG3JOtUHIsZJKcxbDPA2F92iljJj7Q1jdYfitQ0uOCEtUOQraGqL2thHtSlVH65g5J7GsU0etNZTZcD+qy6SNQIR6LM2k0U/dNqpkoSiURXJhlOToMcmNE4V+tUIAnQ6tKgUZfW99G/9k1cqRB0TSoVFyLFOqZBrO4EaISrwrRqh/2MVNcKv8z+PIx/gZ92pEb7x5U6N0NXysBQH9z/6KoO3v3yayiCAnQ1ePqkyeARxtfR/VN2RO33Qp7ztF/7nQzd99Z6vPRHz0jfKfhvDglenrpM1SEitOzrywVdcWFomc15gG2Z/D/ktljN3ouE9uhoxtwBrJvoBPLXI2RVYFMGabPuUb1CbKKFmMfyzFVthPbYho2wVUoT8wv9e2suGiOzvMmyc13/Ark2eMq0e6YlMhtDpfut8fwEhFkJCOFlpWCBzABC1PQ1MT83RjcrLW1Q9fJDCVbDn67lTza0dFUinzwacN7Hfo5NKGKoQmGOMhXrZHdphsNUOj6QSO4MLr3K6o8svaeuzN1d22GZM1eaVZ2WO/EFf6Yhlza3Wla8qeGPnLD6Mifhk+A6tFKdH7MzRnR69L48ScXnYeLHiNHog9nYPLohBkNhiRZ99OQ5uYTPhIhvoyy7kJnnnmAtNkojbb0Mw1S/uHPviTe6LO90Xb0MQO9hBU0WOB2O5T5ZgUxtJsGHWO0C9KtWXxSYQI/zm2naM2INzfWkcNdn63BpKnFvL3op0oJPiZs4w2shbunEW7YMmEDh7CxKn8b7UGgzVGFvC+a0dqwwAtopilIJfbfPDUwNwM/zX4aKlBZQqp15kwsTiI62dOkZlqvBKC+HgKJADZV2Ci+fiGrvPARxQhNXjg1orSOGO3E/H4720LyCnevZl7X0ftsMQhYCkFU3hvJvZW9FxlCMW+Mp04UPEqbovM3u9PKq3AYYcuOah1Yd3m/K0YtQ11S2ZVKyDM4MsgAU2OqaOpnLzwEAPyQrsitUtiik7zz+Y0QxSZgDZkiXuoLJOPzMGuoEsZW35LA5iNrzc08FQyHMtWEcwQiiHwrVy1u+1T81JoV41+rJejoHkqEAjdR3mMQ8w5nOYnyNkvVa+/6e9P9Ir5lUJSYtsA3EXuBzu9O0PLYiD5dsfKrx80bbi6MX2SSGqL5a4AbDiqz3n+cJ9ls1LZ4oWcFfMHnamWM/dgk44bsrjQkKjg9Nx9nt98lEpbaFlmgG/d2D/rzMCPLSAOzpf8riUv/VoC+f3r+mZW0PgB0TXu8JjeVbtrgVgUcbFc22hTI6M6nmHQo5Hf2bWaIFH4LlveMrln2z/5cX2SYvc62KRlmhp0tTvVEO/MKO4PGnmF9FbSiO/H7RPvXJESFHTvu+3T5diDPu+1z41pUCTBBIty4XbJzJMAF4Koy2chof+V5r2fb994tMJK8D86VRTv5sZ+t3MzO9mRn6dsdcVAHq8kRMmfqca+N3MvO9mxn03M+27mWFfjVfAL08x69t76LunzIMtsFq7ygZpt1KXtsIg7TL1phr6RQGE7JJ5iVYIn8Fo6ZJ+VknfIkgm1+YONhVYKLvYIlGHm848s96PPNgCdtMiaYaBfKPf39nUXtnMbcwXlhUYGcY8zeHv0qLeKzJVOZ3NO6PTd0Z4gRkV7PPzujWelWLaL8SkxqFt1xG5WgiofFFmb0/bZqL1/vkYgZOjYNzgXtLyzFwNeVLjm5xLKQspfCl9WTri45KlElxHQNFvVD5JSKkji3FnlHxYcUmmTanD/jvaoRTQWpjVNtk3baP2qnXj53/qTYvpRyP7nFIxVuyNwsMasVf01VnRWm7PeNW2ZD9Zcfu8a+9w4LxNs+JpiDOcJkAwIxfSWHBETZEeza7193K3Ah2g3JcxnbkMA0VzYnB0s0GbxOZHPohu7JrVsTOsy5bREu738i3QldsyCSw4zjP40H0E+NB9WPgAuAlkihkjLJuHlHYGRglmOQF3nX3hslQtaIb3tpN017SmgwVX6xUwODASz2bMQG4Otz4DyyEdCxkuob2nmzrGxHkmSA3PY7mPxMJ6AVUkgpE+Y6Rhf3SDOuv4knkK8m18FuL1fdrGk7snokmBX4yKwAOji57gjw8r2M9X+Du8BMcEt10WGE20HHlVOKpQVW6KG22Ai/Uejb5GuVRq5D40TQhwRq3BmrYBzW/WuBfX8ap9P39UHW8fTi8kN14BG4WniWrq67IdXR85wE8YdkFRwRVUrqN39O2zWEJeG/0h+ywWQX67oC8cIHlbGq0GRNtVk1Wroa5QanyNwObta/avBv+pWKmsXtY/fIz3UGrguYRFKkY/mQCEwAVbX94peyhQDqmeN6etUPlysBfzGPe5uVcdN5HRO19fZT+TOJvUQFVlkGVazYx8lC+PzSWdAplOAVoGxjvOqW+f1cgP2aeAWgGps0ZgBCA6y9u42JaWeiMZJkOmuyPZB700z6QFSFTONe0fvgdwhLytjc2C+AHxKcs7x4FQaCDUrPQUbVFOtev6joEWlCfdQJDOUR9zdEYldeKcbIYBMg4Ox3a7FfmQJ1I+TCR0M7O9zDOzPmlnZT0/GuXLOnm0EjOFHLHEgZJzTbesuSrECNWiJ6M00bfQlLKBXLOybeqUN3J8wugcZ9JTB/jSUUTPfbu0zknarMBslublOU/bcJVlGy0AaAvGXxnEtlnecvvaRMnqmhJ+JznXPYU2K5ZlZDd5cr9LNxjBC57P7cTyjnUTZEu3IOYk93ZqDfJWdUsHKUYLomc1amsOPT41oR02Lba/54TaYbucdtgvjh98XOj5o9ph9gBC5YSaoKnGCnlVVczVXqg2MAoFF5cdhDgAvWVoqFBsRMiTPFwhj4+z0ktRCU6hYaqEuymqx5j1PHKH72e4YAhvRmDA4mPCTeCpibemf5akPiT2/If7qfYZuNN/d4FORbMYRG19RfMmkm1wrbINRpOgq60Sfd3fsj2iuphU8EShMpkmfgszxE/sZpuYJfDp4FjiFr+2UQy17W52hmaUhuLKIszTYzfbWh/KdrZoYi/bpHZ1L5v2fbmNVmFGW5Y3171sA6ib9kPB9AbFeUKpYKq5Kdfi0GF74wZuBfKmPAlTcF+5v63dvl5ksB40KGYpUCet1DpStPCSDY8Mizk54oQjM68UuwBkEfF33AP4teCfIc3qSxMvg2He0oMkoBhOKUYPULhrKDbVHC3ceB0Oae4If9/K50i0VquHXnLUUbRVuiLnXw+++Yt/8owfvlzPv9wYH7uYz4kqKFDVXW2NtsGvVEG1KqyLuXWXklHFEv36EQbJBU7BBIdAc+tDbuBc3jJHZdpIMWFPNRR8ZU/NE+Ns52Q5evhsoFRYT9eB+j67j8hb6kdP/KznSSXe5Z6rfKhbNHYxAGcf9jsZgxTHUGjZYCBbhF5eN22d0VsMPNYYmSK6ZV/4Pf/jrX/1rE/86FVtHSbTjHqZgInUcm/IUnlrESqHyeYZmSGpON1yGSoYoahOnnFUiTv6SZUX96Xtgreih+yriLC1Xhkbd3BJAXiDKu1+YBrtnojt7zLUc0epo5sV9iQTd0Y8J8UHuXUf4OBtVAe8cgaavUtJt56Oef1BcGBNlmeo8P8a0qC5wNHilxBPvRRgVGj4mf6wD61HNElJX2C1K8rz5RAh+UlEFUc9ruWRzUCRcT0AjSRVdrLXSYWmp+eN6SWrDYj3nWjV+QffC9H1d0GzWkx+qQAY+d7l5bFE2Zv6kzLnusic1bqVnDrGIOC8iRFEE0lzPC5pxmGK2qLmpcfU5hPuGkvrjnqFqL9QzQia68aJjl54tS5gVOHNnyZkTkohcw2MTc0qJdc5BRULwKzfxUAeekrWLVCXWjpTxRcFgFZp7L8k+InLs91QxoVqo7Foq6vYKLXXxWydjFbfWuT4s5/+xxAL/Lv1yJD0U/KyX0dEUbFtgYfBPizeX/e5CEHPDcmph0v8g3c1LYMeQS+iJqpC/FMm6RXdXaN5zz3PPxch3sTu4R3sHo19OtrwdA1fcp5/SXlASP7IUaJ3eu37zq99n4SCy88PLuda7qmhGv51FX8BUfh1UQ8gCr8u6kaPo/DrGgitaO8C/uPkm5GM3+w99os7EIXf7H9fb6LehSj8uqijEnW0GnUMUfjtb4iEn2pi/tfDr2uQWP/Fbxk1cURW1NyAOo5NR8ywbD8IMqP0xVAbezrrC5qpOitgi3NsqID9ip2LoZ7kCuTdoTZe7AjAMsxY6dadiq+VeGBEYRgo+w0lC9pm4RRBcn73hqq68HuRJ02fijar2nVpt0WEBp7CUA4BWyLJ54f1IEqRxJU08Du8oKRO7lgStP+ea/XUyFf3kXlg46ApUD2T1Btsf6QcuSFfv+z50BRxOpiRcV+BskNVu/Tx8NWjaQKVGSyuSEzE6bG0F6kJJT+smpuZamWKXimF2YequphhqYsZyquoCUAXkx9VXUy8FCHFo7qYT+UhKg20RP27vmwWsEhPtSMo8WlTpfXZb6FqObGONru/9Zv/HpQxPxpWHehUNdttaxFGKbHqMMTGbbIrRYGXkXF6rY7SoLp59TX4aAH3dGCFIzhQqmSGxvVLZvQmE44RbQDVnFWcw+G7LuoN3cOahT3R1QOf53rsq5mNwQmzZiTDwt/0JDcVpQq7qgYiup5ynDt9kYU9I0qrKyxQV/EyUBXKykGuxItCld5lAyA2XV+jcn0NsL4GdplLzQUtwXnLf0VGlLnAnTHeP6iB3AKgoKxKi0ukOEqRofTjhN1T4oxyWKgrsxlKT3FFGF6Wq46KNcXG9GlUCdJNPsdTTont7zkJHUjoWv7uuChgT6kC2a2oIa5OaimGhTPYNSEI+O0ggDvl8q7BPY2q3pYiFRTmZe5nrxQSKuPvg6+5u4F7OPU1mF+BaBmVR9W3zPlG9uEb+Qryp4jUAmYHriaf8DzoaQArMerwryIflyQOqD7NPZ4+79TU4A48q56RB/b7DRu4y3xyN573ec4zslCwljYsEXWouxtrQtqq2L4RaI538VN7y7UjDrSUEaCvStp3Bmv7Zv/m7Otv+blrnmSc4Ic2k0LIHd8omPSj7E+RV5UajkaDqjkRLpjtFyCtxntGBadxgpxiFWs4jLvWh3xkQvWur1fEWQHmKPfBOHbqYjyFOmz4FWVLNmwgdzxtTLIXhgx8YQFfj0qVKLe/Kw+q6mgUpDeMXLE/ODd61fuPdY1Bfcd8c5XDFaqvHlKz7E+RVRuGpcAaXfgrtpT4MVfKhpTC9ZQtoHA9/aDnWfs4SeEPjJ4hT/GNwlw1w3gfKZyiLfkVcxBH3E58syymlWXh4WThnvvSm174ZlmG6Q85AkDOX1ZE/oW1ZX54UN6LKMDioiunGkB4H27xiJ9m/lk2jp8iEKa/EGhGTptsrmS+KMz+Banp+33Pn1z4nAss1ecLrYW5fiiUgKEw4ipVFyxs/pHrHt/6wl9VB+9dCFbRCzByos4jbfaFovJPFz/L3OBXoMHC9+iVLqbq+Mn2Mwl5rmJtpMuhVauU7Fl5md0f0UB07fFcezxtTw3tqZ1EY3SLj5KsrDPcBKI/cQhRv+X58HMl4FKsVqLpO2lTYOlyaHaDlQsAumTp5SG4RRR+E+3HYiXaKUHpzX1YNaKSTl7FRLvWoTE9XNd5U1aiFKEnaUi62zNGtk7fy5c019PvY6yYIk2AIN34BOSrgkpQjEQhD0tlYgHG14FeYyKEvwr9GUcn7nGu+4XZHNQfTPlZ+mAsIt1AA6H7nF1IdggCXoScGUUSvkLi3U29LO9IbPZJNECECj/ziVPvS8+ZffKPANoyXJpoWIhBU8YBe7wm2ALZWtdVDCAO8UJVyE24ajj0RLL4iacEsiajckVoxtFAm9FCVjViT3ra3hQVq7U8Mx0MKJUuWsZEeskvt2J6y12bjAJzSb4jOUUAS5E1PYv8Gtl1keZ45h5zwKLG842YeAZxDgdnpWst8OTQI6cZXJ25JZ9NwZ9RjEZK6yniUw9Og0KZfiJmF2mOQlOrMoP34JSNMo7jpI52Jnud8OVzNDeg2XXkTa0+XoSWRgwwo/NwX9XamhkU5b/qkmZFK6SxZhjvVmMvjEpuJfx+H5e5paM3fvLn+nng+qyAD4e35xEoqRQSZZ+QQvxnFzHmg9jngFGv03/gJ3/zH3bdf/HwKpl06W94XujWF7e44BI1+bdyFOx19TZdPHTpqKwbLELV76Ljfacw1GtFgan8yC2wZ3gLtOJgzZBCLXw83n6asG3Z0DPe94g9oTbXKlAh5Pb5bnYejhi4U6vE2Z8BOiIfj9DBdVnv4jW1EgdMke1w/25Fufq+X7rvknO+Dlt9GCCmO9G+W2/Bv69ezP5Y70hSvdqqbQnNJQy/tIMYlSQB9u/CNRnl/6mjjH3VHXI4x2l3+GuOLEgiz5y9KtitJCiBgJTT0Lcte3n0Y/R4IJbnk349b+g1d1ujHNE01cY0P3iSU1DlBw+K0r9Mqo1ixl3CMjV8Fbdf7kcbd4vbjQi/9/Ny/Ed6WUqtboyUSDxH6+TtL5hKUPOyXoFjSYJKpfhxmFFvvcXMrTSj18IoXi9mcKQyQymsdTQowR++JHyLqejh/DTTw7d8Do4vDvDNsY183s0HVbwIcw86IjI3WlxesQhOI5CyiyUcc0r7lSqhV0qWXN8kjUy0jg1MFCwDM7igMwGxriVRy5j4y4g9FNGyjQ2IK30AqLWkwENFo8WaTVymoeRWNHK0CZnNCyx4+E2ojgiagoFCU0wdpBVV2vNQjYvl/QVRCp2XjWKRFodHyKcFIMfCRmkWkyfXEMjUF1fyHsiyRwvUkbP/DmLB4IEVaRZdWSY83erL4k+zjAq2sAdUxcaT0ZHh0lmOuiUFTZlzTcnMnnZae0xD5tCAOVpQm/VUoy7Xdx63BSTXemTOG/YQv82ftPvWuKWSag/8FgdAUWXpUyzgIMSIx82G+arZMP8iy1j9URQ25ZA3vNbShrCkDYYGHPLtThPfjug3edYsQN/PY2vWxSf+Y7PCdf1WZebgvqzVP6ho4I81n1RfnGdYQ8Up/RcJydOrq5SoOR5qU0wza9Q8sKHqCx3qHMDdrPboOp1HoqQFJSf+mIdc1TNQQUytvIlZjqhUmUZtXZ59SuneiOQF1jw7aBdfS2uvjXSl71ePnTNoYlaWe0xvvWUbG+o2h25QWFXfbAunAmKRMeU2ztE6aiS1mKt0p13hPNvUweE//6hKngB7o5jXA01OZjI0LGZpjs+O9/3AG//63L2Xfu3/IxfkBWwm+xvJOwdnMGvkV++2KvFz9fGXX//AE37krlfy0jW/zi357jNfvvecdzx0MbXXB4Pb9/2Pv778FW+5+TMXYxTag6HaH0Kp7jv0LtPmFZt/P6y0YmhC9108WN/0gm2EwVXH+AVAoQuKQeiX+5EuewEjtZ4b+TgKaPFarNMDEm7yhrm7FKh2GtyqnLhgQ+VazsE1rKk3jQcCjm3zXkluEvpyHtrgzC3FYWqVnBkv4A3hVYFQ2nLLXyXUHMBejrYzJg/XQdX2c39VDSlRJLv4Pxf5cDyEY+YBenD70Mr0Vveul3dVz9i7PmAO4EHPuEoPVaiuRG/EsnGgR3h31BnC47ui0PTBoxDMsuAGuhFY6uSuZ2Dpz1DEr/zs5ec84XXz/5WZmrjchXX3yoVar7yySvERLQ1nkVxMXa241SlU7Ed3+Q8WftORC7gyCrhn+BIdB29dm5Noczxo+uV6ZJF+uF6HsA2iGiBDeevtoF/SNl13HvCm+gsJebW5j5MIgbtt4KgN3GkDA0+4eKWuOCZTVkhDYyTlmGfpZayHP+CNhu4Wq9CYbBq1TNBSokSqzMxTgIbFMKV04EopWkMsuMe8IaUuFlEDjxeqFDd5+wkIkPIZbawNAw8BwVlYkcKbEmI9BMUdduxsdgO6o4R6XAFnRiXJHQWJVCNmoB3auQIzLKuEPQ9IAD80Cd+3rdKaUwGhGSb4ectq3um2VJmD+z0dHH27x9MR0rdjeBvYt4xfjtkX4pd77MtufrnfXluh+BlulQDTbkY4zv6X7rb1Pfvf8qZpma4MzYqui7mnUxMNTHQqYfhE1XWgpauFaBvrkLZwbVzNkqhgnuQlGZb7VWynOpY7aututa3QM+9dvCcDfDGjPt5G9Zk6rOFa8I9OFuSIrF7jqPKPQkNhje13peEumEoX26IOycVCxWhYYFy1B9yELqdx9IyJmdCuyoBcx4w9Fp6jlpT/sefHRttCFeGc4W2fAmExQhXb6J1jdf4UqDzNVzEWSKm48eckz7xRrORcGI2G60mTB4e/EBIolmU3qLkOM1I1C14uAfezKxa782DMCJ5nDB7bTbXuqY11yfSXvNBuxqRTeqNQFCK5N2U3rOaQdNm1Nk+MQnGD/FwtWzfYlZWhp8Im6h32VK2hhdpc5St1LUSqvcmICSWndq6tRd1YnfknlfKiUt+6eE+KoOrkvQxT8IsgwcZiGAwVA/63WLBcx3kRUeYX1bHKxjh4/1O+bv/Vbihp5tdr/7+eLlKbZyhb8cB1mMiuzh/q6WVd06rCp0DV8oZoKvQp9cWvWP32ITj56WDEjm48ansLYovsnmnGsZxVeWd/q+7sb9Un7W+5dEkF1B92NdBM6ayVn3wanzgbq3/p7HCpzwZzJljHmXl5134/fqX0p6/h9yL8XLK2nw3VrvEfReK6B33QosStTARTXcmlaIu0C3F1maV4hEXNHXOPW2CtZ7+mJsDyOkYI2fM6P8ctsMbuCO53vVDVUqsqArF2tI6qQ6MUYJwa4K1JAWSnX2d1zQBGNdSTCHoegmQ2oSPA0tUulBOkAKJE4tjbLzUQV8fUY6j+VVVvICr1BiK8qqVZ6A1EiHB6A3gpeGRH9Qa+G+fohzxzkB7377WnlDEyhNJnaT4ar92STmWfKa05xZtZc7r334MCwRdiOUYtp+jAc0c4tSmcXCzrKsAPvMbx4lmqyrIL2Ck2BnDw0wV01MgJf+Hvo1qVdbsCx0IVsSFr7d0Mzs8vDYvsZPE0hft/XUmxaDfBqt5htLslwZsFEGgCRc7ow+cxZjCYc1K5v6AGB7QPEdxNlI0C1IfVM68IalbmXO9PLy43WDiQ6PaGFG6ohch99lLtsGr7ZT37W6mqDss8Yd+nEKstaj4XYDvu18OCwfocPdWS2kAtqG64rys0LPzO5YpYV3FX7q3pKs3BYyO9Qj9u9vZ99InX/cgbB5+9eKj9MrLO3+P3sq0ht1VvzC9wWfbqW6QlUpj9HXIpoQdIs7/Hu1kJKQFq65qtc6uFR/8x0CoBHmM/lN0vXwCvMQDwER4eOM/fU+nd3krvMKaAnwqsKbysd56/T6rWPqGE3dkXTZkRxHDaVGndlxCvBGunHptEirWh0zrQ5G4leXUyuVVJzqrJVEIXv8/JvmxOMQfeqH6Fo1HOyNSUWFC1k1Ow+Ny4ggUOZK3Lfadg8fRJBYuLKsl7J5NrleRwwkqUa+AbvfLGRfYVNMZ5qgjgakEmk0nhWOCR+s4LKShqJpPnMj3V2jqgGgzrAI3whfphyEM1ckOhZi7kNBBUjwPIP+mD4I4oCK/FelfZlVddjJTR8MRQ+mbgQjfciSUMsJhZ848soomR1Rp3VYW49ezzQoxZewjP4b6/v+Cfv/aUc/7x4oHYkD3izj+th4Zbs9ci5xGcZk5aig0UBMb/h5uhRVTxBFJX+FaaJkx7Ih41vdH+btpPr9rPBo33rXHcvjW+gb5F1jdHAmxISDvkfHPUka0OLPCABWP9BL+uOPEt3VNscqSvRdIr6kIlOIA+TWLqochzdhUrC7EYDitUPw/zBJX57qbIlUV8YS1zMPCoupmgWLTiI7Dlu/jho7SKtUFOR9EEKXPf4zfQPdB5+JPoSog4tICQ+lyT0IKa5hGxy4NcyQu5F9ButYvrP6h8jT9UwrkwMdeE2uLcPT5QxBu5Z8y5dEZciPkUY+zdnZ0RhQS9bDDM+aeqB0Pes2Xzq6uqbKHIq5gd9DRhSN6Rfb/2gavu+uJ/+1s+B/s++fdrTg9B5JrrfMK5fACWH35Ezhw1de+tR9f3rQw8/v+7eI3m6zQiQPOr9p+1EvIsEn2Wa/aP4JRzAk9sQ4G8FEJPx9NdHUbb4mQ4iZMhQQoV3jqBij7gcmVvpEHTKs4hszQ6OlVziO9V1ShlObJSBWvBQf+D2eutG1f4tnR+z2AOb8M6OtOjXwqmmQO6fdhJTaFqXVYzFyH6FRx5WBUNK+XCJ2UwzcAYKlN2WK2ehYgSA4l6DcaHGXMguHGQEarPYG9ECxO4JApt/2gdMLbywGjRhs4GFna+QTTpumvSsJyx0Bbx5him5eojpuU4NlLTchhrqqvRNzFILFs00ThPKqJ9D2canh5y1SfNzUUwNoeSwoqxucgam0PhwtLcrorYuHTdwOImd2Bc7TH5Tmt88xZEFQN0oRigq1td/TqFTlcfWzBtrm5yQMCooVug0D7cJikg9bOT3V9xWFtXZZfIWg1TD6HO9Nyd6q32et9rOtSoHNqbM/sH1IS90rUDRZR9VSIwIlZhdxVOUTHqulPPE9VlbqhefVNtc0Osi0KeV4iycsuaEUgkOuWyBZapjcfOWDLxE5GQ7I1fkzHKvpEu/TXdCQeinCaegEo1X0SOxzi8vH57kvLUtnKz1nXRi60436uokKOHER570F+IzK+WwwqgwwEKsVvK/gnAwaCObE+Ul0+wd8Adl76Y+cVABarmnDe0WMjNzhUTywuaI085ZtdITAvqbRrT52qxs10zSW2uEPHFjDX9we1NVbt8ZiPvjNEPkR3HlFE0QkE6hoA4cKt+Nf8AwNQyxibyOdz0U+Ppcxi6eR6SyrGlioJcRIdbNwfXq5WLUUdw0DrIO6mtKaPOELffK/rhNEvzFcvAmRzbzSF5jmZkyAXSTRg0Q9MWGP3He7rIjVkqRWOw+iQjEj2viKt9l42XJaBFx1Xqglf2CgdHckFePrSqjrgCWwILfGA/yLPuC/NlqTKP9BtlU4qOucmbmY+iqytfdKmDlkiZ2jPj5bzYgvHtUgZQLQNiy4jPcjVqz2BcyOdoSz4TAOLLAukBID3EYJcvAwEk4D5nT4N1FEbuY0JvRsm/r+telRfBmGZOx6ni7o3juX3rGFpurUdbpFV62N6RRriTqerxeoyqY71pO1aPkNhiebyW5SO2lhreBtUrwlOqvZ2yI8PJCtHXBdoiNhVndRat9CM+VOkpwq/qRJqnAPRuK7dnRdaKuthGWsF19wihXp9LhuVRzrFFkmgFxmW27c+3I3RNTgQrCLjdm1OPQyGHCsbPHfy3E2vHlNvop/Dd8cspJDyxumylHWhcEakoIGRCRAhnHL6C+7FT+iExxSl0CsxXnEqS2b6exu3bxu0zlyRnKdECxSbc1SLT0vAVHM44fYUS4GYRSb5Y0i6XfBreK/nmKTJHCUAxmPPZxXHJWNzpSi2htACBhOzQ5ui0/BSVp8iV+lPo9KqpK37fxe8UI9HGzomlGRBVLUz9FYA00an5KQQMttqG2+xVE8KgFFQAGNpZ7QqXqf3V3vCrWu+RLubVDp1U49FYHjbX/Ifd8pS257j1x2jzTNnv97gvoYxR5BrvRg5xrhOKDSOd6FXGMJQxjMtyLudyzMhWy+H1YaKcb90xXlEGYAd2jztoJ6wa76Qt1rn1Cga+wTBYOiCzb15t11NPzbWg21zeqqrWiNZrxcQAbCKqLiV/ofNQ1Hkprtod6ciFJxhbUtvSNMd1AzZrsrCB6ujpsm3qEt6WqDRmuYA2tmkBvN3CiPSpVfrBbpEeCYwkp2VyOpGssDM8CCUHDPNBzI8wlUU83CvjJv6cjKKwJGt45yVfOhyNai5FNIehSAztXDOMgVZTqSGV4nLu/wbYgardgkXwhlcA/jbOcQo01+NVnte0RecvOu/SDKrM48qQoGVipahTXcMzs35XibxbvzFIJcmnGZrH6fViJXnR8hZ6+VvZvnk09yppMy7EbdyevUYW+xW7qINxyElRnlFs3l4N3GIpzjwgwXOMkxACwV/gv62QS8n6gvUCe4MtGMkeNjlys298UVE0XiUWQe/EoqFw3B6ATuygFUXtbbQznyn13ufxxbZygjIAcBA8z6M9o6Mr6yJ13KX0MXZgDvACKgNgswBYdcJRD3E9mXbFDo3TBso8oJU8lmbMohlzFK1JF/Gc1e1ORLMTC3Gxli/QVpS4lcjOji0lkm+ZNgcACU0OkXzV9DlwVmUO5DkU4fGFQdQcQzFn8XWmgq9TEXVmKqLOfRMQdQ6IOjeGqEpLqoiqXQilHyOIOquIWhgMnXUYCqayKDF0BxUGQ1f6jJT8RxZDwfMsoPCF42OoDvRWWl3LtytAtxjOZgvtpFmLodu/aRi6UsHQWYOhO4ChOxG3U+O0gaodP5vPSTN26DkG+gc1wx0WPVekJpQxUtMqYlaJUCpRUdLwEksXpmFpXibnE8nT95i1/kWyx9QryGanqWdFOjI7uVh8UoA2yAE7wxdFqa8Tnp/9Og8tMJp2iorHvJuR25hszIhbkvl+B0vZmtB2CxaKAPTRzSDMfEVVSCTUw3Z8HgvvfGWJU4DsVPHGTnR2Z3VKoiC7BW83cPauf5FoFXrTHJThRPVZuk1TOJ0LQWlde8vTtlHddcOzft7E4zl5qobVG8c5lGyyP4eKTSHznYuR7XVVXCsHbPlM6ZZ5ZkOYnyKrCCTzWWnRzKgQF/5aRoW4Vd0ngH0O3jv5p9K+NnVEiDun1eVtdKlCUahjhbid4wtxsflj55tOiNum9qZC3A4LcdspZW63VgpvhzSrH+r5wWBA2bjb6iPYulU2ibv3Qoo72esayG5WxvMFL+8k4JGNwGMO8Kj60sksPLLjwyOj7OThkTE85ioy5A5ZtiY5OkSj2hMiZcAvpQBKzGARN0dBPYUbQbGYD4KA4lnlLACBEWRiNq4K0ocLuPa/GuDaFcB5Wgll1dOA9pGpELQNVeO5g4JxBXhE/KQ5exrgTZ4GeJThHGL8NIDBAbhc2Rtp0NSha/EUg9bkkEf9OKTAnam1KaocqWXkVw5JMX+rmJNRxza+Pdn4jNrc+PZmx2uboloNfRswnRSCV6pJG73uRtUemTjnRUI0oLqNzzi+6fpA0RA23LjAq8EtlbpcF+1XMTxMIdRA9yv9lptYKorHjSal088rmEC2S32WIXeP02YoPrDfxZ+j8W1nma2KuuXdGW7PQN/wT6vYc2kP54HzFDrtC2UDRtuMQOt5si2semu8J/SiyoG4r1/oMUx1qK2H/iKyx2lVch/rQcbEmZ33CM7swskzu7AyS0M7S8Pjz1Ju7Mmf2YVyZkfRVHIfkz9C7qNJch+qz81NyL1fOZbWTI7cnxgeURUeeu4UVeARWXhEx4dHRNHJwyPCJYARH7ZBldxPPUH0Uz1Zq6gpvOfi4bNH1EL+eTO1EKScUC0EmU5eLeSfT1It5Cbfa0wq1ug8SAprdY6ng3p3Egm9PUgzpqdi5EgIF8JxrgYrivxXnqsF1XO1ujtXSyhE9+LyErWrLOLK9pty84bei1GLS6Hy5z6c7Ikymy8HkoUeO1onrg0xwUoRMsgjlAfSzHEZWm4VSacckP2QGOTY3OafM7yFQ2pzHhjqeWAkqBy5s1J3Flix+XfYU/+9vvHlEoifTX3JRdUBDaxVXTCqHlJF1O0ZL6iSVzGHPOdHUBW3Xf6K5bkQj5H7NkH6HdI1Y/NIdTvlPNCKjqBmJRW6iNWxiPQ3gwDMfDCFphbBNE0jND1ET70Dhcfs/cOnpNgrxqAc8VTKETtK+q9EOaZpP0SPQPsBlhwt2sfH1X6Ipmk/xJgOJ6f9UKVdz04/14wbaqH32jEbvVHVi9N9Yz6ZPuV8MmmSTJ57ETR73Lgveaz/LZY8q68le2yqdinaZYa8rjU9MFbTF1xND7iaviI1YZJwv3ErDpveXdosPWtN5CJFCDtTIfbILbkCUd2OzFAAnQIjvElOD+j8gBAympiZhvVeDTjyXf5hv8hUhJBRumbSEng8EAX8PhqLLeiDQo9naQbiNB6UmdIEOIkt8wa1cazdwYzsjB+FzaBbnml2u6+nuEHerEJNO1uBL2UqdmmmSstbGIMORVP0mefEqnZEeJJ5ZuYpw4ObU89EHdW98SwuwCR5AqDhQlmeggFU0LGlDe4ZJOrodAOPeUigrhItrAQkO1Fvyc7Weyqx1ME1KQh/uIYUVVPKMXjsh2NbStVKLmq0xfLfVb18tlQRABAbXIrIGUVyBFfrrm0A9yzV5fMrizo8rM8jQsuotg0tzxcAQDiYAvjoGwRW818RWM1/A2AtUkwwbSBAW6CMwIxnvwkrOtlDOgkcD79Is0eKBVooY/iofXa93FjR7L7/9OUHfnP7837B4ybPA7iYc/f5pdjQGTKCNFOg7LZl3Fd3hi/iTpoflDE0f2QdQBOpGM2ObjiCWu3qJzOvJ96+7vKfrYQ4UXWkpsEHtH+BZvte9jV0jOtGHn4V8zmy+8fyrz4MrM94iP7K7ceZcU8MotevrbPvPEtqQ3dDKJy2jVHv/h58RDNDdcU1PALEY8hc45pSVGqAUDRFF6dIpxUhaNEyMkTpHFMjtMzckU/zjiEzM0aqeADyxDmVNLLQL0fH/UtVy4L/lsWWThflOFc6c7QEvzVyIrIo8N+yxkJmPw+Rl/96XEE3X6WQv/RpVVq1lVao108gMJbS8u1cG0EyLSv9NlqFf5Ii1PuV4eGQI/FC/HJQX/RQ/P5AXvS0/J6AtmoFcPyQ50aTfzuY0FValaPJnOu7J3DOb8YdJyia9z0VAF8jvSBq51yISJzBVPeoCzcHIc3KbU/BrS4Hte9b8bY/38YfbueOk/QI3qS2rz3CTvlEE50C1B5+v4jQfqLtQNft5vCcOrQso7K9AjBXgRS/CrxBSA+Lx4tdQrFLtKAQS8Tr3IJCrMN4on55+DFDGb7LdFsvlbdgRqWwevjbqttK8LZU7KAdw3U5FNvqSO0peiG6y0cVeVvkxkBU0g5wYe02TqFx9fBIcSqdOsxPc9/uoK7gWUvW2mL7Gu2k02gHcmdHil20i2nC6aNaLFwiiXoBZz6VM5Qki06n08uXK3vr+Nx8SUeHTgRoTSvJFmKHi+bGrII4rwosTqkknGKOyZyGQ5Pq0l7xyxvKIY2WuMpd2Y6CWyDOO2SPsKOip6g1YF+oBTWg3yifF/pdgogcBRUnUYIeOXUtQ3cW9LuB/Q3mX5Q2EOaI4COCvkbCC4pGIihOizR9gdL+c9aKM6iL7vGZ4ZnYbj0NfNxlz8/PUgvzZ3Nq90C+hWZhZD+Eq51zxNhA/hgsspz6Uj6cABJkMrQJytqtsy3LH6vTKX8cxVSQia4VOWaeb2de8XjMPe7CFEWdczETOYkQOIYAvj2KAL66033l/mn5A5v5sAcSyjA7C7T4sfRYqOs8gR5Hj0PgPDqbl9UzeaKcwxT4Mfm80lsBmLMQkOK0UVk+PowW4rRqicEqZrS6vMll5m9HrAaZVOkwEobxHp20HSZVc0yAZ0TsmUHIgPlD27RMJSco9LySGJAhLrSq9dB2RDjXPqgTXzyBiAM282S2VbQHd44IY6ntkbq3uv5o1dqOb3bdtBUIxXMNj23UBjK1+xB/yIRpG3cltPhvBpptWmtOUiH0Cwyx3loS6TznjwmvWqZUSnl1FSDTWUJnCQ+ibSAzrLimvsjUx5LMTQZDBP9POdke4yvtL6C0Qm1FRl2ZHi+L5uPsCoWWGP9ROW1z6xI9Xpo83musHNuBzvTYPIeMjLajqWoaTxsHLqRs2xJmAAd90zzP+D8DOeTnwFOeYitAxx8pgB5Pq8Y3qp0W/LG8n0vnoiloHlqloNtuVtYV1eYbW1i3osltrut+T9twzLThTm0DbmVKlzgjcErWSYzqkkW6RbALi9TBo0NzeMwpDzFPHtZkNoIlIjm5VsvUsFSKXWawiK8NWs5XwZNOkBMAajpFUsZDSJ8JKMORK7NRITFtjKjiW8jB7bIstGnVpDPxLalNBlgq2AAWYv5vVRggWFogUcnhQDdfsZSGVvIlLissVlCUckta1apim1RJUuV5tGqRh/ULkF/rpXAMi0J6gmTNkFWTszI5U4YOGEHw2MdN455wrVsF0WhpvCGhacjqcRrSf86j0ZZVgMm1ZQXkJ3TkB5LRk4RP2zQrefRBpLWT1m4nlpvrVSK09SSI0DblFTE1/Hwr10TST3U9OVaXzvmcP8lXxDBMuCnV2VahOnQCqgMyM0Z5lOqsIA74u0ILlfZ1kf3/KkKk7LuQmjzkh8+jCId45FntylXyGA03pSWOciCQlrShIJodIRBk8mWWVJ0LUqU0aybfrmSBmAeUDRzjLzzsQGOUq8jPkwDlOZ5cVX6+BDKG44yQJYYa5aLcajF/D52nA12cJ/ESeQHlGsklPYH/ezyS9tD5Juf5eL2AY+WVCwebiZUI83G7cr8Uc3btrnB+GT9t/84TgABq21WW8ARtJoolbkBS2A5oDbacc7V7OiO1yzYDB0c3fG6W6eQ48UxLpW58MkrVFH91541NH49H6NiS1TG6oYQBiO0rMhFPl8dRk8up56ESCC2QzGzYepzZ4GbCY91MGEN2Gt/IctxWyfl4hrzOkcfaObJN54A2j8xc2HqcuaDzIKVIdgPqZVl3tvpyGC8ZNLMhgmtcanyENdR4W/DCfvD8vEcpdc1KmPsoVLchIjRZsawUwVIRpoTd0R/1K3v9Y/aFgA32ZTdG3n+EK3jE0IghZHE+JAVPBDoIKLgpny4i8KfJGSifknNWFi2C8qos6SmFxfZxSYVDU8U42wBb8nSUm6wsJXIL7kT7JgtHpSdf+vacdJrb41N7IJli3j7KffkGZrQWwNCoAkEnnBvhzRpliz8uJLaql3FfDFHoywAvZF4O4yUzLwfxolbZePZto97T8hBzEduD0BxjGwtBxSoelxSw1TOJ1nnOXCxIAYQbuhxPwf3H5zn3NtfNPC/pKZ4FEwFQgn8CRVDarqYG7enLqixrtF2WtIoYSL2I6o7OQHkH5l9V839HhT8odyUAszEbyZ+kF3netaX1pZCC28UL32BIEURKV9w+FMcKXsGJ7qB2mB2E+fr0nbh+7L0EsPmCr8fMjTWqQ/bCUUwD+C02b/fhrWhUzi3X9SShTnUnJO8V+FrxVz6718fvgEs/INYcfZgZXpO7m7XvwCdUV7Nx74ZxYon5wd4e3x5t44iYczv79mn6L4EfOGcWdzrbiFZL81PWlwXgkl2PnrY9MfgIR7vW34XcOa6dHhzy+QgOQR7OB5Tu6st9QpGRXQ7hIr0oHqkFaHcOhyZ2WVPgNgwBpPcwPnSzeakh/wG9KnsTx6EJhL7d5K/BwQUarcaC7vCzl6Glzgj9DfwKul82F+3AM8y+Chm8tkck+DhBIB/mTbjYf0ZioWV8GFXgw4956h+vpia4xNgZv/wE0l2VN6JKpDmfIK4+bUHIkzUp/YMYRZTPlfqGtBfnyrEOtY78gY3hEDdsbm0d2BD9Vh2ha5y3kcmx0teX45UhzINsEB6Wn66lQLRoixiPK4ZFnZEdwWcNB/gMwas5GEpzjUFIiisqa/XShcmwop5WhgcXsSXSVdumV6ARJvxKhPseO1ILrptwpuI8lxzST8Rxg2qwqB+EPNB77GHFPwrmLPza4sMDcFL8jPRYIxSfO8648f1e5Q417MR8wdOT63uG5cn10dsRNN50+mIz6vBAojaxFDrQVDUNWgkfRVgPwm8qg8HdGhzxpXOs8tV9lfADGoZBtNtskFtzpAze42IPSezNmiaOd/TkXbuWajfvd92Udt2Ld8mmSVrUFypfHF4f+SI4tL4JKNBcV5p85ub0fZ6d0wzze80Lj2U5p+/ROBBHb+LAsGALXX/hqcVWmO8EPP4Izw1PicA9nhKBCiW606uSooFXpUWHveMTo5thc1A6u7l52BcZE7DPMc9nGVtbv3Vx7qzWqo1brmG0Z3m9NMyVxwBSXWzqU6y+e4o6KwBdjuh9r/vbXxv80+8MnvwjF9aeTsHmywD7c0QyLInBpPsfeRxzkQT/AsE9EjyG4LkI4hgIVsQQ/AJid0lwA8GdErwHQUJQzZKtSvBufNZVMpnHWmPmPl1wNbZcjYn7FHxuwAgh9guyV2F254naq0VxTG7yOh4vyhvVpZRJfeKWUn6D9YHGEVwVohg+VBXASCp8t67W18k3rlar62qs62pwNuOU0uUqjTUYwTwOvBmqZs4Zfu29w3djLfWxiPoVj2aKSA/4KtvBF0LgFGxKSrTz6NaGh4K/4GWvRs+N0WL93mzUkf4DhS4kxsYjrOGXFzE+nhiKFpyQoh3+pXLi3r8+QdGOvul4FO2YphLC91TC9yOslOPDGpRZ8guTFO2gxslXN1fCd2gYM/gjKAFBbo3GCnFzwQ0J3qURVYqGrln6NHDdVEqLd8mmSVrUbZUvjo5+EWzI+3SKdocrDZ/9+6JowgYCsysqfI7KwXjnOF2LHV2rA1Sx0rW60jVQtRMQMcwhhcbT/8+jZ68RehaTMaT5LOh5KQLBBzMCQuKKulK8IiEldkfA+VPC9vljQx9ei5IqpGWUrGA+TyUrrzs+WVF3v98gWTn01nL23PdLE2Rl447jkZW7NFWtqlfC9yGs0/d9ZTA4+OZJsvJA5avDmi7hgYaBOB++wxEQjRXuyAXvlOBRjaiSFXTNEombEa6QldfKO7JpkhZ1U+WLjdEvgjvlfTpZGbjS8NnmZOXbZOXbZOUnppAVQSAE3obAyZKVnzwuWcF8nkpWDj9SsnJzzAKGqPRXOU5SrjVT7fZy4hy8lYPZT6G+FZ0ekuimx4sqs+MFk5Pj6pG5UfhjsyO8sPbfHeI/q4r3l1TRfs/xsX4vtwcWa8Ur5OGXCcz28LxCs3U67FZkewwKBURqa+qd0wqOqtd/ekODxkXs3HDCFDEKNZ+7SRsbQcGfIQ+pj6Y97hZLEVvzRReRC0I7tatouFew7DEMq++V0N8D3y43fqBgdBWhBxF5iQQzDu1DCK3QyYK+Y7KM4ndSZm+5gsOy4BrF2qEg+2nB53qfPz+M8c5jBA9KMEHwkAQb6NruvGk2An5VnIa3phjAxBagcWVP9wLNzfcC8eZ7AWDxVYVvDHmFGNWb0QK8PQc/V4kyZqxCtk3JDIq5NrvJTLGAv53g492F6l+IRs1Y3+OcLlXmJyiQ5xz7BiKK8DeltAPf+iexgaMcEKbYUL/b5MmFBPq8R9ODu/EcEUjYEu6zgQfMp4fw6c2Bc+4rse/ztKJ36RPegvEZVgg34Q6PrDQHR1aaq48/5V5kSQBkgrstEYiVOAsRiJUIKJFWaxL83OVmTgSa7QSLNClXXNW2ZwqrlvYsGXcMhULJDI1OC7FbZyoFlN4lCTfjN/uZMZKrZtfU9nL5tZa0S6juFeQbgqs21iYI7lkKoUjRykTe7JVw482OV7VaoBneVc2wMZJBG2D9HaMfpTOlu3wf9/3HDULqTbiPqz3J7OdeyU+Ig9F8cVrbLaIhhetFXN4z5Lc3YDkaFPUrrWX99ez1uNNyW/YzeAyLhCPjISXrVK9Yex1AQlLjWXv2d6x+/i/PW2EXN+UMRrTz4Oi+eTBgBevzfMA9Uu8paE1Ipu5wsu5YrmFSPF53iLpDW/fF3HxXd33zuvu+Ej93ffUP/FjNF6rtBH+v8wSR3QwAFgHxLSsP9CYrQpCqCLdV9ZYdq/TvYvjwg/Y9+OYv/skzfvhypvUNJErWJpK6cAUEGgj5P4gikltYWsr1obTKjKSEL6P0hlzMVcYoC8gpBs3mJhe8srfp0gIaisMw6KijGbu5eltkiMlWR2vWs58GpN/wIJNl9tZP/HdJr2hhfrWo/l24yB1ThPFp4Wgty14HM5DAMnVeTX72E4gRF6GfD/zIyXSP8X2nxFmB/ArnBT0uDTeGcOyCt5QSw0bsNPcD0ADSMFfsCIH4+YTDnurUzyiBISf+pKUhoQ4gTAnmbkgJyECD+DPIr+PsrhuNXfqq/E9Na37H179+3dfVdcaDdjVpkn8AVzBGVpXsFiDHChp0D7y9jNgJaKvTNrkF4PASrizwk+FeGuzTdoZ4ZrcXGc8vpHRvL2JYGByIQQzi6AGlPHLlGVfMMRU7Okeovc7VxcR/jAnZrTLj5WziYKBsOsVSr7uQIQXiZw9fBjertnR93RxrAa9riibqLKRCkRIe1JOZOf/w8GbOt2fO/5HnlDdFUaTXHF/yrz7pk3LSh+Wkr01OeDvb85ZO6TzUvuczCoy8Q4nyFslUgUCNlJK00KZ69o/Aa0sQuCcJehKY25eJ+PNRNOlQ8wDNKIT9iW0zBaJX4Au10RkKsGeUSQzA7i4Yq2S7DrDXxWofoIFbWiYEfyx4Mf5f3Gw9AW2aI9iIbYEotSpEad4SpQUQpZYhSvMgSrj7RQuGKD1nE6I0N06U/mmEKDUNUWpNEKWrpVRHlARcji61Sj8SLeNH4hHQpdcdelh06dt06Sc8eDJ6tKkS+VAYA2RulP0I1U+0h0t0A5d+MgyV5HzLE5zQEJzWIyM4oRKcT6HXlAq4UgEXSI6QmirvEjjeBRdHOyXP4h9Q+NUVfkoyMiVWtcITG37GO9RJE45ZbmA2yc3MWcIxX+Vm5kA4xAH+/AkIx+w44fjfr6gSDt9xMycgHMEj4Wa+zIj+Yk7d5bb1Ikmmqd6rVIumRngiowcJmL4e8kzgZhPAnltE1deSyMFv9LTkB8zzLk2Go8xRmfqGyXC/LeiYCWBw4DNVmupJU59yPX+VsXwA6/TdAVJeqynaqMgEHghN4D4OpF/0vXDSq4BRBfn5V0xzcxcKLEe86YXOm1446U3PpUsqGIeHUQG4D/jRy96IzOpYjvuS3a6v4kYJxtHtIa+vhBBTA5J1FoPK770efp+1tt84TQwrHvN8eMzrilcY6zFP0SbGo/SYF094zOMOZX+iHvPUpyGyY2fKLRrxmFfdb37NF/MejWtH1qWffcXoutSqrEulEK6ol0I4rFAqQ64sUnVZwfBdo5Th2QWqaOBaIj9TWY82X6pCs1TVzbpSr1j8wHa8jrmpC5HO/lbeRiApGmJMISHzJRYbLHKJW+RckItI0OC0XN2G0lK0sA0ZKwxgcY6kTKekshDC5mBilzF0EI82tfgxuaCFFFYWtK96PvhVg/Tk1o4EI7yqku87bh89ZLoN7yr31iSZl29CMO0jEbW9DXVASCkRecN6ymuofRWgC/mWv46o+V96qriQ6BXOcA18Ibi8wBiHbMhZBXDKV1UruT2vu1wsODiwQKgr2MhliDjUA9jZEk72c0rwnb+GT0axHiaqfZnK+tk8jqO+lIkFfPLh2aUmYzKETOKwMfsj4yStucuH7WUNMUrIVNE1tFlZQ/E9tWQNXdAQzl/ksnwNM7ePQUQNYo0h+xPZpndgnKwun/XJXs4/calczhFOB7iAV2hdk+NCdd9HvtYT8yNhPxBSUwbEA5MUUF0kl2b1TQzsodjG3wES4V7z3G2eZJ7ZmLG7vrjijHPeQ4nRijrMtyKk9ddBzQJ+YNaq0/xiloEwq3Yr6uJH06oOq+vmgGYklnyxW9EUMKeoi2Y4Bo/9Ynd1BgumVmqL5T82AtFGuZxS0Zbh1su0Q6PySNrqWhiIo/9ACrmyCGBjdhYRWlK1hTXpAc40QCpbwm3AWl/2vwDIqqtpgrNkmPK7XTiLgew0rqaWLOQXCMJ54BGQitgrHBFCOoO9snYfDH3w+jilcrZb8AyVzQMqori7PS0UsS1rgCL7DbTNWbzwHZENHOkVzeMrxRSY9UBV0lh1oxVQiPSK5Y2gankj0PWty+RVdJtAHUYta3ARjhviMtfVqJA/1apGJ9UTo6mJMKglJjeMnxk1CeSVEGll7xXWSjsD27CaD/RtOiRCB4mIIukpw8NBIDyiEDoBBKowwDIbqE2pbwQQeQCq/nzPqzjjCZ3lD3W9yKwRec/DRXry4NAZtrm6aC+oAzdciSlCSkyBfWs8Ofgj0CVQ07uFFISOmr7J9/xp7hSpZv2FevgOXnM09sapsQ/UpsV+YWrsPVNjPzY19q6psRdNi9ztIm9xLNlO3WyL081d1c22GcRK8mo12RmD49T0QgaStV424gkyuw1VaYKmqmEYb79xBpme7Xmjn9b0U8OPechde4S5n6XNss54lQ2EqCYQHYjSqzmEL2riripX8cn7zjwwX5Au1+rEN73BQ8mlK+RAOVbwlFJygGb42cDqwSsfCkzMjig8zHelM+NAXtEJblCAuVF1ZowXriQcdWZ8EcOCtwfGqS8fb35FXYLqUaAef3Ar1oUI+KhkM9fFw1c8fNfF/w9qd0br0CGsDvIxXtBYdebm8c8P60uGl8y8dPHSlZeza4RNBD1NaMD/eW6Rv5IEsAQ3RZkesFPraAiV1tE0LJKAvlBoCBi87M0yVti+3iHmIzHBsb3zsaHVqe6jiwm2f3Csxs+P8LOOdH4i/l38bCiC4xwkWAN8mjr3muhIU9AUY4sFLrVLrnE0RH52u9AMn8qki8eSgO0oTfERWjKMfgneCDp3gkFv86T+7C/dlYKRtOwtSoRkqAoTjSEGsnHQEKC9RQuPfUVbWq1lFDPw/qifFBHN4DNYbXFdyVPieLkGxc/cE2f9EVwNiWQSzWV464lpKtyOB2Yd/l+oSUFP+SXASEsByBvaobfKDG4BBC1q207vy9vS3LyFhrfo4TT34m9Kc5PNmpsagYlC9qxvAcjWjwfZs/K2NPdbB7LxppClGlQK+kJXszdirqBtV+ntmedwC3yIgBJccIL3U/JQJDMbWqA6LfBVnadUz7tOE99mtMCyUffQjuo799BTYrFO6KI4U1M30L8kWl7p703lbxSm93qV1f8+b3T5FwrkWIr3qKQG9Ghq7NGpse+aGnvHFBYKgJ0We+/U2LtrU1s2Nfbo1BLOnZZ110TO6nAAUg7OwygOeBseywmFd+3UhQHrJlbH7O2yAEPnEJEhIjONzEPVg7l8qtpRJE7PA8JzNwVYamqqWYflJRGH7xruQslHlMHUCLd4ajNyUzGFVUeMWV4TiWnglselLIWBuWV1EdE0rpCaaiZRSAge7R/KU0zNH2571nCuMZrYzGeoKZ+o2y69O3Ig+2Wl/q5S2SiIrXRuCXOwaiSd0r73o3lqZWim3YUR3TV1vWiiudhxW2+a0kEwa8kzny+i7xmxvkAxAD5DNXPYgN/sV8xVQTUkLOVfNHWi+8KuSFudO68WtYbSFmqazX2bN2ad23nzahcMu5wCPs7kGbbFVZNnKGkTk2egj64gDEICcKpXTzeOMmYzag5ODbs74CJNUyoEJEg/6IXWr4jxMOsLw4UKvMC8e2KVGeJdsdmsi38sZBLSyx/Wq7xX8xfqWdXXK6u+YzZlF+vJ/WitQEqqC49SJxWB/hCiKUJvtXqKoGwcCl9tLEK6UpGFC37UPffqcQ84mqrn3ne/4vieez8S+BmraSnRPOap9OAjnnCsCG5gbaqJEli8Xwx/9z2qY4ea89gyFuYNtAFJgsFy9qeGD3SZ0/KozVmLGfBzBv3E67MnalaxCscDZ4/SfQqtwPGvVFLOoG0ZFtG4YmmrZ9yM2njM4ox7TWYngCGctqy7c8RPFrRUW5PPk0QfHa0uX0D0RCuKRY3+yGghxVJ2p9C9ZVogG+YQLZrwEs2X4UUKReg/i485D39zZECLR0RsrYNIHWrALlRijIsqIrUQ2aIUWax5LMPOpq8KIlh0jjEppp2aVCyd460Fvv0dSqqB5hXTizJb8lgpNPlHblFb44FO5Kp/gFEHX06uFRj2OXBxclJimWcl17Gie13QTb0jxzx5nO/kWknUq26HU9fOltggimU+JsJEobnG01FDrSOI6fxCjXBANgnZI7ApurKY6eWcTG3hmto0w2IjNfKidcYpxKagtnq80nIdxyAA+il5ZjNRXVE/7nnh5JbKOcNOtGcBZg6Eop76kocbAN8KwiRRFqXsV3Wbi9iqo2n+Po/szi7Cdk9N5yvlkA2cn5yv+WWvZgzkYyPW0n1lIg+3y/Sydyp7RX7VZv67EPmvRbV+7QRU6yYGbtX6PLbGwyIQJ/aD2/MQJbuBgkAQ0aM+eK5UkAXrgMb6EaqtC60fNTZcq2jbI99guO5iAnzOMUeGuvV/BuQSm3oT+HXpkx6WIB4EURJ9yDHgYY0AR7Mvr6XPRmlT7wD5Bo3UJCGAVk7mDUETCBIQGUotwvjhxccLBItJKRVJnyi1GCG04h0T82uv2c+5rLAKrdSklhN+8bcdlg1ez7x69jU9u3qz79VPzsuEeGZ3XibCipcJr+Jnwhv3MyE3DNTPBPrjJkaEGgKKFZ0wLuYcJUKtrupYZkxoZ0xIsZkxSAbB8PFFS31OSKF1QT2dPT6FWnoMkEY6e+QR4iFpZvYo0avLhJqcRt8G1cmDqq9iU0MfmRM0CYr1icP6CteGh8X9JC1qo98ffJl+jwwqP3uYstl/mWt5Zm8UQXTGf6GEnUWU+cqxreq1Ny4IDs8TgOCOq3FQdGge7puGejQNwTy4+exPxYh6iiTnGok8CAuMNY2ilX0CmSgWJvQqbi+yR9nHEJu3Uuic3NEUd66hcWN5+t4hNde5Tk9vRLTJw2WTGTyuKjr7iwyM+Kw7xRRce23E1z64GLlZ6cn5Y2MdGjPc+hdB4sDNX1enfV3Yb4d6z9OKBQAQLE4+Q/N5h2bhapM6EGkY3yUwoa+GoRPx1QouYtHdjF+lecrW0KoZtVUM5/f8DQeEWiYq7MT58iFQzUyCBxFsIagHFyEHa7rKzVGSvW/kmC9fMndHomJGe8rV9VvPpdlnGnBaIEc0V1EgrDqNnyv1G8gFr+qtY5N5yCtdWT2JD4KWtK7c1AXn5jUjVKEl1QbqqCAooQa+P+hhNyYwb2KcM+dhnuOv1r7Pcy8PSPAwgs9xYLhKgvdbMCQqcaj1+UVnQ/Z+Yf5mVLUgcYWEruhq9g9I9g4ObwIwPhArAF21rWhhQh1+AVLXsw8it6INpup9IVsz5cGus7W0a4ousejg+pEMX+EMW8gldEV/LBSdubB0kNMVN7G7fDR7Wd01dA1qdRix3LI/6hNnRtBuNE4Rz6Khwz/yZKPg5zMgHCKg68juT/uJ38Pz6/tuntWahnlEnC78Ij/F9zRKZZZzUVhO+NfkmNiwnDEcg6A+sJyLFPeKDmpVQGT8uO3z1x+965VffcNLgRoleA5GsJs+oxUVPmHQs6MCY0XdRYPKK3ra0OUZvuHM6YhNqmHeo0QkFauUQKCyVbQzxByfJ7uiRSZ1YE1i2VjVEfsuiQ0RO49YddrPASEc2DNJdLGdm8QmuiEHwtYolsh5jilorQBu2GPXr/HGW4UiXPvN82tkIT5D2+1Gj4mGCSq4aZm2ZB+S3sZw2nLHPGAVi6eWm+dFyS0TpEiBzKcHGZI5ZEzu1ZQs2RaefIM6j0KDttkGIaQNCrRBddugzsMDU921qvNIW7XVtgqhkVbNV8A0czINih1s4s0bNOMaNFNpUArX7NoShCpnS52qD9Gk6rW55YKRCzZg+L00219xi8qKUr1C1VJknz7E5q3B7xneB3mDIlq6BVvZOQp0fRrARzGmhsxkXob6oZXqd2nRbPppTpbTWjkubg7xB6rjq9BAD3S26GQq4rHkgFIFWBGSByhmvwmg3T7MfsvIDlKSO7FDwso7uJ33OyZpDoLMu4NcjZAFeU41pfXUzT6MHFWXj9SjHLost9ASzVVoJJLmaOmIi0F1zlnjkP8rIjAYUNYbDLjjkAyJWh1icX82YZrWYhpqPATr4gZVXvACbaCdG0K9yyiwLlCoFFtEUPExZHkW9HhWKSMzVHbv90tRZJivF3ulhlhUuV9YtnkiUMver4rPajgtj/TmZRG7e7LYvT1rqry6bq5647lHL9Te6Zn3ozZwzAbucbda5Uro++TJn/j6PGiuzz7gjV2fvd9kvMM3JR2ygZvx6UZFpTawKrWHQlzDD51KrWlVZAJ32sAAgbDiDTTiu5X2/eBecsEre24hfRDbeu1xYgrK8HphbZf6wCMRzlfvtCf2Trte3GZvyuTpITpQFUGAyu97qtsEo3zRWm6kQueaHWd5+/nM4BK19bQnj/DYm+vt8A9H4O+1ulu1HICoEvuGMvZtLlYOQBBbG4/pHwzXspt1VxKba63apstlR6DffO+IinbA2LdWsvohGe2jI+mxMJgFok4K4kppa2ikrZGTtsZG2lqXnV/S9ygRaWtDZP55EzUgyUlaoZ04Jm2dwVrdmSZtjamu0taQWuIKPxqTtobTpa1QzlvTxHxOHV8T/F+BncdjjmYpq0pbEwhlEZAsSszsFRWjQxUpPs2p9sMMkGy2/9rI2K74bf1C3BLpjnROiOw88fPoaEPhXWpISAH57YynDPh3Fi+L8OUESqWnJsKfSKEsmZ3o/aikCDkA2s6mOWaxMswhqZhD2RkgOMc/1vVLiJOIDN5uMmqYO9pKKNuIbFMLWVrWzXo6LlVM/9C6GRWBqtJ2vIhLv0mXo8gVTOTa3P3o1A9OyhUpPgzHPjwJt6R/PVW5XyuTQqFj+zsoFcrmVjf7i6Why2SvrW1dL6gN8A6Vzgo0QnSOQ5CTBig6LMLRwqHVfKLi47HiPYJByQhAjCg0tfgt9C/MQ1FTAMBiC7CAYgVZEY9VHkE8feIGRKMNKCLoN4Ld4gAqGoXuuDB6KY3MuYAnzwBPR5p27y8aNjNxm63I0DEDb3gwADCbqr/TFRsaB4q0TxxnZQX9nWvkXi6CakGcfdls22JMERwU5KoADVvdG3lYcmvZ61E9KBmk8NTccHoQuIKf3YobYxc4U8NNcAf8o5NERA8dKz/LpC54R5vVuub6OOHp5AvBXtuUedy1957PTaAFbtIc2oOzBOgZY+KGmLXmvNLW2UKdLamQCQr8Fs0DKPOEoxkntuioQ75CznaLtgov+KHNFulNHkpNYbUOFN62w9ioqo/vogaluBTWoA7u+2DlBAFtQP0iUi30fJFfh6pPvgCxkRwzgtCo9EMzJ/zIjDb5iihWii8n/OyG4KPgYRVulxvXuayX3eW0LXdzSusA+wyAhHBJNeakNIqBCpn6h8099d8nFDNTZACtldFYENTPWxj5GQyJ4waXgwl2Dc77ejQDydKykV819sJ3dAu+o6oePRWYFd5GsWbGYM2wAuWwcn4TGpiDrW/RAkjvciV52Y5ujNF13eGGz/YVv4q5/fm8AINiQW65n6f91IPMjOtcsLgFOs+DXx10mh9BLHi9x/KwgGTGMTRgVhuQSqFFUwWTTbku4NgQBmkRWf/ZOgRj/nVDisf86zpYGJFFOMxnqhAqQuNfd8aUHI771w1O0rNu6DzrhhQe17Nu6BzZlu50jfb2Zt50Q+luwJS2Kls1znRn1JlusUzLg4pD3RlxqDsz7lCX+08z4N/y0Di0beqBVpsasptRNWlQiQOC/Sqr0jxNl+cw8qg5j5FsKswpJ07dLG9dQYtMtaIt1VTNafRsrYzAdmWLNEyjJGgrTlQvu1jBRRI0L0G903I9wLl61KxkKWFLUwCtbstQSLHK+GdmwCpb2dmfz4m/joLF0qzsQj0gPjt3xCPRG2/A4mu48q0c0NmRkC8uPq4pgP2SuWDE57mAOZhRKqF59T2ZqU6M8Q8i6D/P0BJP/flMy6t60HUIHVIGRnRGVOqOYDDbSm0XeGnhUZ4ZUDRw9rIpvGVIC8qrgVZnOisztGcej3lqwoh8Uz0+UkKisTqHxxz5UPTxKcVbaiftamVNSITh3XfDXb/33N3/9V6zviuV2UZ1Wh7m20vMvfOioYa1ZQVPSlJiI7pIOYVOppcX1ISMYgdneMnTxA3NSy+teEmEG0ZowyiJgso8ZAvqnyUjYyP8kuz3lHEDM5Pwmlj4DKFKEwPkutHT8edOKpFbxfsV+Swe35vPSUl5U4dKHULw7w50nFdf2iEi+1jsAMyhH21hjeHATiljPwGpDYVA0sywHIdiAeMyzfxZqyeZhwwic/8elbV1+W5Wv0FpTvloHuSYWhilljo8EG2RZdS47G4A5dEIbqmKlq9brlEpxiw14W+pbJlN5V71ICHijqGdgkjARmptrEubsVO8lUKjxAEhFURQM4LY3EAf2Gca3VEtTbSTKa58DUqF/ErWU8o0ZyZgpVxUcPjVwLSYubJo9fIMxRMHQsd3vEjXwFQ+1cOJA/CyCG8+ihvYQTsh0pDYcSjGaJiHliy0Sql8U2kAag/dWNwCi0ibs1O1KlaDsTXX8iks7bId9oqmuWJNXDm3ALu5mduFEAyGBg24x4kyXyCwBaA1GIrYzAmzjg5AAIYjoq6htHLAObsw+jRQrfF8mTyMjWpsqBZao7+7tH3qszLEpEJH97mXlZeFSd6x4xCfSj2Y0tL9gK8iT4SsyJMCTOZgxEY0PmSSY/Qr8LYfomKWlngnLuY5Wow57u8goBceIN01MdnvK4/HkW/9+Fs+XpMDZtchaX6g+xyP+I/Pl9/C+VALP864tJf9AQooG/jIW5d9RA92Pxs1RK3P7FLi6k7loL+/qCv47dmZT/4wT4ToRGhDA49aAZUoN0+rCkNyEdoNPpZ2q4dJnl6+2Mg7es0lY5cw+SzCN3r5nJyai2fOhUp5UM96Wr7oYuAbrA7firERsNRxHkcRzsrm+SHUAKKPpr4MYKxjyL9OxdIF+S5xKjJmWB1IWewLd738d2XvQb9o4ASULzdq6Yycv34EZQ1GfNfaq7uRXE13Lmgi42c8Rgvx/Rxl0m4Ocz+FzGsNMJeY4VV3L1pmomWGKJOUOIku0iIQHHNHq0DxWhFFXBwsbrgmAxICVHFAjNdNG0zLPC7YC2BejMFVLoPQEk5YW5SWtakcvzVWDrhmWQfkOQ9eG6uMqJ/qQWzChwF5ipeWqr2lMn2T6mVGUZ/lH5CWYom4YpaK384xKpSnlhOdi0r0cADLnGhx6UfjK56PW84qfrOal+SPHgyoBoYRznmjaUU0KoEKR171q7snSoTVgFvh8UovSWq2o5OFM/xvLSLiBwTzFMoTtu6YariKK0HGVHD7lWZoUBP120H6n4y5lsNKNUHqauRVreDBVCz5TCtrMONY+EAY/klcHlH0otpGwc9BgZcjXPIdkVcf1QpTQYu92RqiV65FuHvqbcixKECie4mh2yLkdVWzGttH+eSN7aPctU/1wS/0iPwKrvhmH5VoJbk/vo+KNOEkd1O+20355B93N+WnFDtiUG6ohjh5dCv6YECxa6625UgeSf+dJUYg1USvAZJEMmn8jzCLdxLwiEfgkYiIoAKP2MIjPj48YopPHh4xwyNxu0uKyKJUcnSIRvmT+x5fLN0MuQuGez93rzDKG4Xtz1e4ub6b7ChmiDYJdgPjuOswgzGUCcaEbWM9/YlHXYsyMdcFT/dFtzfgbBV9yo+eQJ/yn4Igvq5+7WYKh0GpyOj1gwPgBsQ7KfEfn0xEunMQ2V4dgpH9eVI5k3XI0HTBFFLoER1ecqmUrg+LpoN3WoF06iCNCwuAdJt84r8re4gYDGHVwIJH1fktu76wd8hZGgOoYokxjoHyAuLsUuVWoUgRXEtCXv55M7TONbnTaG4Rs48SN4PvUW0xI9o82HDy0oAlpEYdWxdqeIapIaFwTQyJxnzJOxurLpteXbZh62uX9bWlPkgETR0tjs1biEP1WAQxHpSWpet9MtEltLdx01PkFqMYvDY2+HSTiDUATJso/KU/GWymy+xuKAdWJRlSxIg5VscXa1x4mYmL+PVAH5qouI50Nb9xUNariiJsoIqwLR9qep9ghtNj8Tr5emzBiRQIJ/pxpFCoHClrOkaqLf0nemYg7p5Ots5Q60R7R7WsWb/S67/guRB+5pGdCBFyV3St5aSjqmvtGV1rd4cfx6f6cBd1sz+Vw0a9fRIJ64001KXXz8e0sD+mHPKtXhAIh1xe6sUQRgjBREmEDmFgbVIeq0kPm90rFUhwrgrFeqjv4WoUVhjR3dC9tW6DwOpFdvPWwIrdMLu2GNel6kCpurnokp5XVaUUpNIuV2/PT1xGSJ2ap2xCoKb5kXE1z09OV/PUvUwyoY78vpPXsQV6qo6totqkji3y6DbIqdkq8gWKfE7N9g9H1WwtaY4NaY5AnKcp3IY4xTF4FthjigCUoqJ2Gx5P7TbmqKC8Xt5S7dtEHyEekpb90XHVbo8h9RGqn//xuPo5OlOqn+NlTP187zT18wJTlBFl7RHooKuurw5jVdcXLVFd30fWs48/3J7tLnsWZp/Ax9+EnvxQVfzwjdiIKEJjJUIsiYDp4Y+c6rSbk64RXduI53qhzHeVCwf2umN540ruO8rT1yfsCR3ANMCMi5mdEMw2CRRhIul79meqxybENVbqcls9SJnyLVwnltNU6fhZei1U786WfhIha6QIOhN1PZbDGaHs8hMEd6rtReMloKXqFAK3lFpmJ1RgGyIULABJAH2FfMlcwoTcANZm8xmK8o4coHjUlkFGsnmwAzAY0TKmaWfwmKEOaKgqfYZUxzG6iiPRS3Uz7GuVcK4Io6s/f1URU8ZbozakEdLnOQrVBSOiZ0Q5U2BS1Ek+oJm1It1fGHWCBZxw8ZZqERk7+9fyJTEBm+J1mYXtXQFGsYUrlqzUYvZkBf2kDic3sHH9Gt8quCbvcT8X93OZ8I9OdRQQ7YfIH6Dehv5QWxytrRUGTttt5P7+j69pVFOiav3YvBMX9PXaZeLdNZSsRUGzcMSQ4O2ZvWIH1TVrTGjkir7sFPaFq0oVXj3FwholHElzz1whwiVeGZ6U2pet0AzPAB0CPDtyobzgfqhwz6Od0MilZRzOzK9lf64zF/BA8V2KaMcBDGQDCutSLCbzzHEHWw9UW8YQP6CLspZGylrdvKxrpyIO7jsqdibcT3kUynXl/FLnvNtzfvIkkHLjatNKAcsMipsxKKfsAyUG0Nj468KznSIMYoO2AREIb0R8noNhNK5dAp2dl3reSwzfETgtDtObIkIDQpKHhwZ49qJjiE6G5KM5PkqazpjWxhnTI3BD61/rtBii6gX1O/3C3T45C0BwFxusaqJq02SqlbFQ1Lkf+imq9oz2U80ye7Jt72cwNxSB0BNFasCpDtN2x2rP5fuN/fCFkG5SJFfud0roLA511fgkKoA5ZD2YMbQSPFYXy8w9sswkoioHWRk2juLQxcihLXmI9BwRZbcAjyj7Rawa4AUQi9KMTRlO+rRB4rosCHgYizSB2kLRsDCDcnE6oETtqzREVz1AM4gDHKsfmO2DfoTmRaQVqx4dN8/JyI/vG/k5030jq2XVqqfZq4tYqJ3zNHuF8zT7om/Y0+wXR01JxFUzowaKfznVFmhdbqmOGButO2Oj9Uljoy5dUgHIh10NMLmzVn7yV87wKEMhu9cZHq3L2KphAYx7kt2m1kBF1xIN1Hyqfwgro/dgmQd/q2ZGR3Amcpe3Rs2Mhty0I1JwpE64kD2v85PCUTOjsVNm+5VmBOn+6nVBRY/Xc7tL9Yw2Zubybc7M5YYzc/kuBJ2EX/d8LDsEUoG8GwaJ+7SAjmUyVTHlKeYlUS6N+zDWp5xBWBpmriHUrJTLV41NC6QcCvkr5vxStqFD6dk1NmJdoxR0pFXSGey+1N0WPiw8iCckbyHXmRrIf64cqLax/GBN0qNMqWIVybvVCj618pg6xriBcC0o3MrjlbBbAwTuRnZ5IItGotRWv/4CaH5CNwrn63PU1hMNaKvQ7AFk3CsNWkQLduVLfU9k+V3+2yKXrVdkU8qwPyjaxovU7cecv8e1zMnK1gNz4Oc15OW/rVz0CrcKX3aUhjOnsEpb+4mwBygtj7maGXNc7dN28ridawW8/Ozm+xtHMUPwQvxyp33J+GWgL3rNg4XK27QCcY9Pivo455atv3jFJ/JFPaNmHeNbN/jKCtjzEY8bPMOoJ72YkdvkNTktZkKs7A74htYzylV9hYPa92142y8+42Pu+Iz0aButULz2yDqFa2ETnQLUHn6/0CdwErFw37Rd5+c8bZFRiSsAcxVI8bC+rSWj2GC82C6K7dKyQizJt3BJywqxecYTVefgxywt6Kk+8LEAtUllOrQDbCE8oNzTc09A3s7jKXr4eU7cQFIjZJRTjGdRPPRFj4qH/snTfueETa3OhEw5HR86taivFaQMhbafThaeU4WK7AAs+p5BSBJQ7uAQ6BED6/lyc2QHefwqcOMAOCt0KKI2OnKundysZIv3vQxNRO2hBoeynxVXDTtwhEQ7WOMoSI10juoyKiBKnrN48h982HaobLWwSa1ut0IKlYHII7wq47IGBX3nIaMq/0vf4XlRxRRgrGtIXY1URWeLZD8QaghxBEhoE0NZNQ/YFNXxxncieHbtbdBW/7p3DV51aeFHnH2majgwLg0HxnhVkw8wHBgjwhkOxAusOY8aDrwMVu/usoYD4/5t1lhUjAyhDLeaw1E7O9KN7K+tMVFCdfwIJuwIfvYR2BH8P87W37vTmKVs7Duuea3n+OajXoVx7mMXDaouHDKbjK8qol49+voczXSFM+7+LLUZqBeFxXZTHsszyetAvguBIiJbuAPPurVGHxtr9OJFQG0JQkKlN2YACp7S8vyCxzgZgZvgm8fim1TkYOIyLYJaW/a3+NZktZ82bA6+oSKcbbNiMTxF9IZEt3B8rAcJpO7ISnIgNh57pV7UTl4H9eB2/6+r04Eizf4OVYtjpCIb0My+jz7xuh954+CzXMcspaUN86Hs3zf0hGuaTti+777sg79777Z4Lx9uzGV/K9e5E+0dwVQ0CnPNn9cc4DoWNoq2SbmcGd+GXhXd4B62cfIh0gHcG93Y9+KFX/7OT//4jdVai8XhwPW2bWtgZZn2ZDTOcx1bTWEPGktQPJC+MevFLRm6z1JYvT5SLFG2/oZKjXyFLGN7z4XfI3FUs7AxZMBnxO+LQ9sRsOpWr0wGAXuoscFh211cues6FMjxd2Xv2epH8e+NpSxEPptXoJfXL70m963rIV+43we8Met3cNwqPvQ85SAflF2KGr7L3nejKREnL0tuPKiD5s+KpsccB7P7UbX0Tq/7ZAj5XA7OznwVXEliHzIjEOh9eB7gwNUI4KiN8eto7TK0FC3nzvaT7KcPWrw4d02hYXWk17P3II0ipKFPD74acsV3CZbWhPxegj0UBNLBXiWtVh6Pj7DQ93/vNfjmHZVvnlV+c/noN9IHbVlNN6R+tqEtkNf+x149XhaVZXXH6+931YIW69nWRQirRYajRb7+ERWpgBTVXlcgqH32ype7knaXJe2aKAmOGiPsFWR/n335RikCWrea2H/PDWjYG/Rmu6ZkXzTrX81a+Z9OXKhDQfYl5E0xCN6YtcTbpllLnIjF4qgyZUigp1h/xs5RrCh+XveJbkf2W97IF+5U2sPcEAOuznwgYr8wNfYeF6v2ByX2Y1Nj75pawvum5r1zIq+X3aQu7nzXCUxlB4N/8f2EFzq3emPNHLUWV0QSVvKiNn/1hlppLCmPdZ7r/hcLWh6pEemibsvp2s2j2TnCpQ9s/5GnrpAKZa2shbmGtqaJ8hOowyZau5jYd/UnYoEO3mYQ1/YRJdyRbt4lv342I1/UCZlTZIayJzbgEXEgwnkeAqCKWpZHWBa1b3KbL9VqTXua6CT/pa52JnToZkxJ3sCV3AxdtlAAlzbarzS9O/ArXpBoxIWzEWqpc+GK81+uQa8YecKyGrsTXwYSnOf/wMnk/Yo9qXkWxFNZ6f8bVhrC46y6uZMZ4QDF7QM8ULeq1pDTIPG1uFJDZlgq2Az2HVzZHn/9rU8+KvpJm9xc0LLJV+egTsuG3CscjupFhkQvMlQ0lChxNR+hZPwuQ5084j/eWXipa/O01uSCAzGUqiL4RuH+/sBP/uY/7PqBv2ewQVkJ98nI0iM//eHppIXMopn9A8ag5Ob+EW+od8wsaU0vW+vtBDB6VWL0ynYAxc9U60FRTiwX99/krSlrJ4yersj/BJqQ1zlVNwTg+Bg14uyfhPtPtG3Yy6gsNMSP3GJKSrNymOgYD3ezFmYIkKJHQ9B2TBnRcCKnGy+k4ewoAzMBgY7Y6dTbs0eotf5gkGep1IQLtJlMeJCJWVOrbW4CNXK58ztrzP0RBy7rcfsfKH18FE0pCVyTPV/i7LMIMnFEFZACtXGD3p08aF8zlK2HHDHfEl+TVmiNCjlpykGbgNok7UHI9XDdI5/Tpl6rW60XqIeusMi0ZW0VIeKqhLmQ3ORoexOZapCpo4WzEos98cKaiD1nNsB2O3cKsDPQUoX+tt62ZYQU2N9XHwe+lrYAaMuIoXOyOMMGIPlcrMjGlYXWhlKHQSIK6nqMhtOezNo217DqKet+9EX4eQHwC3xBbPtxLgdd3bgBH4Om7SKxJUiLED4uPOP5xeKFtUuguItzgauvKdrwfS61dxBLC7TYg5N0hDv74SM9xnXovfBEln1VJ4lWyQNut0ILhlGMYbOpfUDkhW2GkVrdRBeonf0duqyqtF+RG0Vqt1FvGsinigsd3DebU1xsK2ZmqbmBjIIqWENamJvdq2vZP2vQWBNbReh0Pzw/IMwIxZdE8UXgCVvAGCBHAc7lC4XaQyswBfdZLFfjQJomZvs7rIpPqPZ0O09TCABRN5uryKnTGT3HfASO2slZLNoptYACZ4CtCwIKDlV01UaWA1BLnfNyt0ORYtGJZhkL16GVhVuWivYzjJ16pQHLrtlg6NeIllscmZ3IcxiIOZJudsqx0C1DVszozmGeu25NIS3hoQCYYWvARaa3T+fwtgc/5xbpGoiBTEDUQCnCizKHfEN6QO5wvFi5b5tCopzK9VTADt/yw3w2kTtD7kxzA514yLm18yrL0XUh1HVhysarYTZdbbPpyoCIbtOFOTaOSLGiptB9ZQ4xQUdfm/r6gHlNRl/rI69ooVmIVtV848fxwlzcuz5+Pcv/E6nKSw/HYXhdCOtvVWdVoX6q5rFkiCIzZyO7uYvM5s5gfYicnuzQsy++XGMOZlDWuF0FXeIlBgQ6Ez/2O/tmpeMICGtC4kiqaOSWDMzRi+29soupLmYk3F1aWfMi91WqXsDWcB+i6kFhWBYxdDdqxzULVcf+oNhC1ZUErGIlT2IUxfqZZMHJjJBgkP8D5vZw2559tBgpIQJWI1Stjbwxag8om3pfuNOjxjruQLk+oto8wtnJaD8jiBxGOsmfVnqnSm+jnXTHKlSnGWhXZpXkrDzpL++kZ6qgsiAmZrHMl658EgnhhJifxOtCC5CXgylIB7N/eYVzc/igHgkKMFTJr617kRFX/SASq5qs2DCZvK+SfMlk8p5K8kWTyWdVkndXkymseLp6o1c6rskeQsMn7VJQoCnHsUXhMp2U/QkKNfNJ2Jy4IwrCayFIHzsuZNhOXA9wjqa40A2nLo/bEEa4949wOVjdE2AYKbY8ezDJs0cUDI+463RHh2Nce0DBJH8eKAiMNQgnSiyiiqWLusK30jQ5VEvEqZs32t9N++lV+9mg8b41jtu3xjfQN/SEPFHdwT1Ush3S7YenRqHrwALcvxjvJ3baihPf0j2VHRn6WiR88CzzmwPo0ySm3ul78XTrKE5p1G18ClWtU4egxqJ6nSK9gaGrG8gvxyVgjBKjUIfCjKqo6KVmX1PCM1aFGgmPrfeVulYT6UlRbJmoAiaKrBsI86kep/il54Hs61JBHY2ol15IR6sr6rJT1Ltonqp1qIcRPTlpaVN1ra7Yx7lSSI9qsvnCchVBqf+gkla2jas3HAXMjFrlLk41ItFO32nwofXQnnQqTv/V849j5PngK6tXIbH34Wq0Y+CSFNrG3DUyXLtWeCo5CY3Z58OBF00b9aquvVFMj2S7GI/o2kd8lMOxkBWLHbn9pg16IijzJFQ9YLVHNNKGSDXunS1yH7gK28Lm/mppWziytoXBmYurpBtKpeeReusnrhfKQ2j5qNZ9zNR7f+4ZET2KpLCibx+juVV9exXuVU0Oh1KqAFYfNejK3OD07WPVt49koPSILKhqQt+LvLX0FY/yZR1eLNERCjhQvaTzE6887iWdR6pY/1jPm66fCxMy2U8rwqoyrkHxz7fCUG4XJNdORUTdfISGs9UJVuGu6vyaGKv7C5hEIK7U4NMOxHTXjI96quN8BvSIQli9EJeLP/r8HK/YLhgXxZU7Q9hdsrBgcxEeHPM+BzwFZBNGaygHRp/8iZuIgNwp54v4kLPSgtFOhjbl6xWLAHoFJ2XrvC6qiflZXYZUeTkmT5tEsZqkKDrV64fZVDMuzQkzLk3XwFm1RjDM+ad6zkYzct1uVqvLm3ISVrluN2Ov280c/7rdDO4hFU133a5JzU2v283wdbtmSp2p1w8z+dBdP+xMXj+ckf53pl8/rKplzWomd/3wxPDojMBjFvDoVODRsfDoHB8eHeqcPDw6DI/ZiiB2hmar1w/x6QTH0BRkwlQZDOFS+gocNzrdRhPat3cAsf+Qz5nZIrdeZGtb+Sr6pv5SNor65lOgitwdF5z5BoXfwOvNhN8zVvjtjwq/3Sv5lgXLJlmwrCr8zsaF3z7Dl/+YwsxUYD6tNZxBLvRJe7zp3GKH6g5dYQOlwv57I1DxiFNtqzuTrWZEAy5syjgySk20UK/64eymMxgoEsxS2zWI6kMHC3g1H5SvIxqvjBy6mlY6kzfVuxhUmJRZ3Chs8k4pmmmdL9u0gEC2Q5hHqNikDzfEWkZCsZrS/HsVX+gd0TmQcOvSCVh46bhNw3tCL6pe2jYrHBaJYPyqNix94JLI5FXt+OFf1Q6UHYNBsdGryaHQhqB6VbtiVqy8KE7h8WkDN/bkryaHelU7mkor47Gr2tEkrQzV/MWJr2oHFE2nlZvDIxqBR/CvdnU9qMzbkIKTuart22v+pRv/4bPT02WDTNZBp7rXAev832Cf68k/2veyl4ELSh915zYq0sW0qPJ51x+fz5t0eKGMaPUm5GcQsbnDi5t8r3FyNx+LkLdbzruIX7n56HyL+OO+RXDe+oDy/5Ad152cErebcevR9pxcZZEw9Fpu3rB8fUyR5et97FPRfvL1ZoICRncNHjV0TxghgzxCPCQtu/8Gd6MxmLjReKeC7+4sqF8XjDi6jTRPsBdHyGich+tzdfUal8geBU3VzaP+Z5GnaM7EcVzz/CBMrbZlYbd0CKfWiK65Gd007zw1Iyzq2qsmP1rR9BLMF3rkECgSxiauaGuMq6eYkSN6apsKmgohQM9+7I01KZ1oku6ipElcpxZW08LQ2lSTXF5T+khzCboIoWuBfBSmCs1KTxUbq5103fQmuhlXu2naBqXT3BP+Xm9Xmzpb0gTPqXui+aLn4DqliYlL1AinIyKluBqq2bkzcc5fBJRWOw5AOIgGmjcBP1COQeJ61rJ9TUe/SSvXSFtTRioYGynQENH+V+KA+6oCavKzG0BpWj6Gstlf/i6BW6hXUoxo+Ubk0CLw+nL3QaxqdkI3fTwkwytE30bgoeYNr71mdEwbeHSqY4q6r8cZHMIWZNnE+DanoLEHbgmwa1CGxyS8a9Xq5AsdT3w4dcxNLIcyyaa5x9pNM5XKU5yGyDOgpNJ2h7EpZmwTSbNj3QpR5JRuNSkzZ/5ae7Nau/00q3RLWx7iw2ndQmyo3ZrVbGj5eINpxlUOrsx0L6D69G6hEeM9SjbpUSpNoLr2SD8e61EypUeJ+XBqjxLbI2TT/qOtkz3SMrBN0h5p9WM90j5NjJKCfjpxmc07mBupAFVrQY+r2GFHxK/Sy7Q6WCiFk13+2bFSXNn8K6y+KobU9IPUUS/AcWL2pJvPnlp19oxPNHw6MXu0MqpNmz1uTllQ1EZmTzo6KJy/OnsM6SlSNUzFU8YdkiPCvaEHTH10RxIayvRKEJ4cletRo4k+hGi1ORNQJDZYfbm60LLkq8m5XiUfx0KKQtgg82zkU5XAywUEHiQ8cR8X46nfAkrKHsq3uUqUpBVuD/PnYazmtPUPDVEBLfnVpcsYlIp0uUw0Vr1fjJLAVLGwTg2BRZ6gObqUg0vCIxpdc20R8RRSaD8Uk6wyplq2WwUNRUwcS0LSdNdISqVED3nAqmmmZp6k0qFgrC32M93OWyxJphXsOuK+0GrMhw5erqsTX4w0XtsUjn0UTHxkWhTaaoLRL7Sh4WhXEu1KWOlKMNaVZLQrweSo+WNdCapfGIZeP0zTu7wgEryqbGKAxIGGdeVVO6oRmUMGPahBWljULVIliJmoLcp98Leodc1aiYBYBtXkPvBOvsMK5+MuWGOkhDbmN3+me6+64EaE94ix1qfYNFTFykMvCE6iJ9qDEI3QdTByBun8KfAK5cKa4ftrYNyVvBR13MbCDJ5ocp0iNBWfUjjSxk/7XuTaZ7j9IgS/H/X9SyQqIn5/IdOyNdEGUAWbmC039f3n5qG2hWBQ7tVCNkLkCktD9eSJStprkIZjzbCijYyv1d2ITmZz2OZcK9Um8Cskc5mqro8Al2Oy10rp6JvzQI2WSxeUEY/RUCEJKmbWb7PX4Uu9Bl+XouU6b+ktMrbV6fkd1mPdDtkOxVI2avouHD+qyca6WrpQL6kf8ANfThdQ7+huwM02SHmknZVlQfFFWx4XPqlFKIkhZEdRDjR6T17RSVLR4NEsChQpqKa53ObLVVrJREjRLayYU3KbU0B/vKKiXq1qvIIirlSB8kvNLp1tVlyhgAf51ytj6e/5gScOJylwe8Yq7HLGAD0Qh3mmus5CnJgFMmojKBWhdtBb41ofh8N6qBugGdoRl9mAFQOgahrTc2lPfM1VNPhd8cK3Xlf0fMhSeQO8QFsaTzZwtDlFMloVagHwTB1pOaHwMOADVLWyUPG3cWEtTP80CUKRCPS9PPCnbPJn4iga2+L7OoR62m4b4k+svqEz/wUU6Xud6UVUeQPyxza/CWJcRWKRQSemqSF2FwHtx+FYm6KJNuERmjap12zHCah6j6a53Kb8kQYL/xDYNrivlLpErrPK+o/yQOONdT31qj3V1ikPpMd4eqhrKlUexnOXO2LHtLpuITFxiSa3FuW4LFeDyx4KfcbkjKo9ByQcUH3Nm9gjZu2v61ndLWMj30RaTagdmRwsf3KwjrvPH0WxUFvhj0I9rMqQlCXYHL88J/LwK9B2zfIVoBVYa69cEiLcyKCEiWxhKj0pYssQQFQqptYTo3MfklCElgOouVzrV9fBFBNY117hY3wd3ED4GGHt5TvMuwB8TDRSQtvyLQE2jy3hbSEV5VZgJQRd4vZ1Uut1P84NsfLF5pqnBgPk6/QnfT/Ue9q+Lrc+WAP2BcrV49UzQ+ShreqEphCR9LidXpIceOkn1XWQG28yFvFoVo11LB+mjkJFE8sZXnDDPPLzQOs1rYjkLZrSCv/kWpEo6bddUYYwfUOF7wsUJBU0pcCAR1pY+CN0NZyyXhZ11CLd8nMjClaTOpTkHmmR121aZF2WdHV4y4H3+H50vNFSy+cMnTy2I4fJBChxu8j/bqObUgeSj0EOcd5oHB9HxqnLPNqy6hi63eH4GNpVpfAwhh7aF0j7FLzAb2lVcJxWBdNaxfi7Scsadly1O7oJTH/eY/008pXxBSqZfYhaKKnADXNWPuRehWp5xgAwIsAcwlSmFniYNYaQsdJmRCT8+Sj7xuONDYwwqBgYs216uigzpb928uYfj9VK+4/v+uxHtkwx/4g8E/Yf38l5GZS3vPOzLWf98SdfWbX+aHV9ItX22cTNev/O654rlmS+ue7WD7/yeHYffwqptfS/PRLriK/Ht1XriOiNM4+It3H7iP2plh/x4Tdo+hEjWDVViCKtrcK/X0nafB1UN9Thta3rohdbvwKeu56ImnJdQfPIYgKOrLU9LIHMbJ9wrZv4Z59RYC8aKrtDVJ5SgLvZyKOpORQXd43EtDlmVWP68QFZ6tY0SdQREF901O/5dWIDCOX71NnIs3HXabOyIZml2ojrtMy5ThMEhU0EsbmuO1Jql/7R4DxXObZ5cztksaJJo0qULiKTW0o1LNqLwhThsguuagzyLNWa0JhsCPUc1U9WQzFztOBcpdAsXBtYR1sdZFD2DWLCGTRtiRFtrKdqjcgqsum2BQaVairzq+9ChLGqRF3LAmXA2GV+D184AqA6VMMMkND0zDUuq/p5d/AmF7yqp01yftkBGKNuh6LPndKSWduSzjUbm1+y4HziEXhXvgUPylcoMwm9E1axepJVrKZc6GHtuoG3rwq9xVYU36MVmqUtwwGGMeOXLbSKly3Ik+U1PGA7dCmfp61iwnCeZgUXBsCFIeevlS8DGWpgBiMOHiVGOrOG6Kq4DtVBzWRIK9c+OHq2cvnKpXE8zQ7XMYLcco+2SqtUNJRJI4ajTjFsC1C1r/vasXpIzLdvGa9lyxFbSw1vzocyYDRZ7e00e2Q4WSH6ukRb1V2ozvNt/QjmsHRKkk71BUB4Nc+5Pdvk7L0up3fbcMFQEGA77JAYe89bJYm2gX8p9uc7ELom30kLVKCe/BTazqGQQ6fyDDqN/3Zhaw1ir2hun8XpbO3ocgoIT2y+czoNjSusSaqrKShtVV3B/dgl/ZCY4nQ6HRaYziDJbF/P5PYVqoMKZ/1ztKgFcvW18Gq5cKnhKziccfo2dZBf1CSfL2mXSz4N75V8C2Q5AqE9Dy3kZ+FW5Vjc2RT0768B+qp0yxwv4+CZ+ekyTjWxb3U6nc02pGA+KuU3n9/P4nfykWhj5wHPjniN1sKOojAQTzojP52AwVy3BxfYhRW67cSgnEqnAhjaWe0Kl6n91d6o3SprW+uUaodOqvFoLA+ba/7DbnlKO/JFbjCjjQrEtuMeq4xRzTXejRziXCdk7Ec7sd2NoZTjqxMg7T6XY0a2Wg6vYBPlfOuO8TaV6Z7Gb/lptAsbwl201Qrytqm54G3UNV4hcYNNwNoBONBtLo+o4+5fzlYoEKyJGQd6Og9rJH6UqtbHMqqhtfPGUhmv3Fw3YLMmSy+ojt5Js03t4q1LqUXOJbRxhpbAky1VL3wJEVIK06Yakmsjya0yuTWRLNQsXzDLshoyDPFTE3NEt2evkVV8myy9+U4dN4bTgr0FuNVOmwXcApzjR/0FQrKW+A8mgoXLIlA8lLwVbdm+H+s/ahsnizoQREtr+S60Qi27nRYA00+jbTo4Be3KO0qbYO4XXxQliuWZGNNdEB+yvuITR8NSUWkkf3RBmweRn3c3rDsjKEPbEbddEKc4TeO0gTKStM1Y8J5DM3itXJMu4jlnrkDQ3MRScipsOucoMaeddny3lsO0dfowFQLbbQrp08xQLJDeqx4bsWJOB0jHgfhvpx0LrE/qGPb4Y6FdyongszAUX5G6CnH7dtGcHYsd37Sx2FYZizkzFqdhLHYhbpfGSQN19tFcPi/NOE0lV+gfrFufZgdim9SEMkZqIsQQ7USpO/XGq4LIDMfSZrMmVYAaHnZfsa2cB9t1HhSYNruQqFY6sYx3GHsX+TnnIHYaFaAzLzxAc8wEIicaupj7AB3ABniN7gpwZbdW7cQibYcV0DnQt7kRSoLO7FL7pbvQj10jDvEPlpen/9rz/M024U8v/PK883LyXQmavLeSvG8y+dxK8p7J5F2V5LOqydhJ6g1cWP+x98cRma2V9kl+5pXOCG+loHC0oKqH7bOrl3PsKKNYI0EXd3p285p+bS5uXhe/mC3Zv5g9gNk96CAoTZyU6pH9o3wuS3qMc48nwQS3qzXYEJ1qnGo/DeoJlz0/R7Pu4wULHcFq2DbGOHw1PtAxTFqeEZ64O4FzIRPNM1x4u5iUk5sX7i6ewh8uCH8YE544ycF3u/mJL4imme1c5JSMc+BZ6+s+I0UXM8rAH86Df0dgAYnUypepnXfJg8lZ03d4v8Vld4+WYEY1X2GLeHlPYaQsN/boW6gHO6naFwyceQJeNeoBdEWv/0AgMtuZfJWW863UzbcFew3t7dkKISfmSacV4IUMn0A9rYC2S8QXjaVVULoMn8wTccBmnsimjch70qYCvZK2oPatWrtWqLWjKd/82nkncjXM2m7jB2zzslSvWNVWraJF+IZjI5gyzck2Cl+YxuKrFc5RN1ZqeSXiOmZFtICxIZxd4Gth7Wtl+3LairexJoKr2d7H6GZcgpdz59DIVZCg1X5g4FWULSsYGzh4vzZO+D9Mnt3oJ0yCcmEelhoMM/VQW55TT7lChyhE8r6DdqAhaBzaJKAVKCLLiuy9xk3sbkWDVwEW04KjpgUkLZC+cB5AFv0oAPrCgn65fzBYy7Fbx7NLW+S5hZqM5wHbR8FqGhh1icushITT4GL6UqwleQ/b/YmJBOhMmYno7mHfTNqDNnC/ZwL3eOUEW+1X5he3frusG6s8wXjmuUmWlZNsO8BAPCJ5jz/dTlDBIIxVxpN1RvBgJS+4hFqxolagJZvW0FOskppIalqgnkWTbbTdVEi1MWQBi4R8GfJpclYmZ0Ro01a0CYNAIjSuc2VbBaGomGhHzbSjt1k7+s951JrSA4i0KSuYcjVLCLQpZJqyVdAczfTylWAvADh9lm2rzDI6/iwDmMdnms6yFcSBSqgBb2ow2ibchnpO1Pu/Y+ap0WrML2RewllEL1+CxpzdvfWo+Uy3OuV2UmHrADZqnpgOizHv7eVcWAD/RTnltIAubAfR7gEyksqORRT2xaIQcSzTknAKLWhCvkAMAJpD8k6aN7nn8XoKx2oebJuvBt0+fJ2yr4oHlVnaE5yd1XJymp+gq+U801Gfle4s2NF3mIcx3brpmLrxzNx4jg0ZjQ0W4rZKznmaNyOd2ZHeVo6kZzAf9U8fUR3NlCJhXSiWiQZZgYZrHM7EZwoc+lurZ4PAsqUf8nx4F+53cmbiRi6FuWDogpEo74gp6AMbZPNcwfZ5h0UIF9w+OGS/6h5WbvdfpzfcR0wGW3PBTmpo7ip98eJ1ivbduPH4v/7yX1/4pOG+H3/RH/3MmT/ncyWl1Fa/hG2JQfpbSdi8znspumHNOMOMhDvCILV+vJoH9oI8+F2Eu/CFC28ERh1AD2HqeLT0ml4m5xj9e4fwdfAAfvWydzN7AzhjmHhOwGqqA2ZsFnN4uEvZJ4lqDKv5ATVzH+wyYeJw14QxWvwlt0h9MLbUt0U1dcpXWpp+pdbE2yKh0I9Td1+TR51F5kWHApEQ4a1LHbldSRkL8zvrZV7qVFwt69XXoFa7+slGkO/LvXSsvp18Rs8iDnr8x+mVS8tyHAnDz5W7wSwmnlHTmoyKI+btZmDj8y6/6EC0LGPFlWhop4ai0gF3K7sNIFe37Ks0c0Gg+eACo3pBVbcebfSaq6M2OpzJgQwuwRYzlQ7PVDs8M95h0xzt80zeGevzzGifcW29cj+c+9zBNtvBRnqcmx5zogBEOy4oVXO62rDq3VIstQiKI+yEJpDxOHhYq+IhQNkqMYdMmIQ6tEpMU1UVxaFq9GR2LUYxryZd+NbFvEm8Q6R4cTBEYib9w2Yc8h404fPQpNyHFnUx1XU03d/fe03RMJkbFO7x35XwM7gg2EjUPcvd66PuWT6Cd3XPoklyBf1jCKZ9SRT6IyO/H7+XGD/jxgxao89xkq9osrlDrm0K/5qCW0VDELjHBo7ZwNHEWtRuKbFrYx1HXTw2fn8PBEANWVMyfh5srEl4VrZ/depgDdd4qrMcBInkcxABuZRMc3gsHJHDLApoYYDQHBSP56guVn4te9Hg9te4rfDu0TRv9+BtYN+O4e2wfTuKt4NNmrFaJjPoxqLKkeu8+eIB4f1Af+9a1SGL6fedqQkMbOCwDRy0gfubFmw2cMwGjjZFxJavoNIudVkWidBOhHpmFzhLq3LfU3nPrRZM+roN8FPYpQK7OZoTNmAbzSNPLahwAhiB5kiurdSbzFXvZxVwztMKWtXDo2f3gokkZQq/porJFbR4yczLPXgh83I/XnYrzBlslZcBXsi8HMZLZl4O4qWmQ5LRFp6VprtL3GpqSE+EsdlGc0AVCW8H/7ZVSMkysvHmAczOuDjlg9zjYhuyAXgGLFMQn89T+HP++Scwl1sR3sphvErdCE9CDTiUL6Yi3oeIeFnQh7p4xWYTGLuFFsEkGcRLLWiaOtMMbJo63QxwmjrnDHSaMvGoI7uUDvny9AVrY7j7s/4N23oMoYjjZW+Spa0OCS7BzxizmFSzdGEj+wUkU6N0OfF1JvMP1KmBheIreB5kZZL76wD/6QGdHxBC1parhtWWK8Kgw8E6bLQ2oP1yE3rJxAlzg0t6Fyw6HtbwBsKv1fCdCB+S8Hn+jWpQO1Ycz94irQ8oKV20OH9lu/Gzp4idv7Jdzl/Z3m/YX9mrwtBT4WHFvHbTMn/TiSas2ROeXWpCUKYXprKfFyCLJ5cFc1sWDCCUIHGDPcvb1Kw4/cDXOP3h9AUNMRAzUq1YZsW0bNgwz/4E1jphkyehunzi3O+duEQuZ53TOdgCGul9OlzBMqqjWk/Mj4QVZqQm5o34M3HsRw0cFYjpY6v82igZjRY04eFSCbmyIXp5zHcaHBhfBoxUkN0O6AgTZD/7DmQzebJbNDmlRKvlpRgmzSGjbJVneWDHsoHeIeMKeb0gAqTaNHM77KPAG16LUQY/e4ZDoGhNGuUVnAmxu9xuAem7qenMBRwDKvjXAh3sRiB0ukzO9sVEoJa9H2DLxY3ohp9HxCv6UV90nXhe3RxSMAWR4LJlwEkUsws2PCMKHZYWNnwF4Ngr2PfQncYN4fobysSDe8kFr+w5HuVB1lS7jfNjS92HLVWIe6U1d+GuAeq+2wbus4EHOCDMBz9BGT4mT/7E1+fNvqQHh/G0aPfB684PDvmmhIEN3Gk+OYrnMR9tuMuTNiD2BVrPAS3uCvPN5fqaaeUtzZpQUMVwFNAFaZOe8e/NoRi/htkBeIhAbfjNfkZOIwLGgzzEY3ce6YWg1VF+UyMv18gAdOx7q2dJmnygknx1NVmbkR3D8K/ghDs0yITBPJL+x6p196rRfrW8p03PDklT1bXdl9gmrtjk02SxA/PWV45a5ztJl54fpTRkdM74L2CU9vF3re+Y00beBPmdrzKnypTenSlTOhhjSm9yTOnAMaW3IZjqF3eOffEm98Wd7ou3KRt70xgbqxQNYJCUPM2OCFFw879qHWzGMqcdZU6zZxaz7ZrypXOgfWEB7bt8gTt5yMPpm/Cqunaj44mGl5F3Ie/ikeRbOOWeTFNWKpVRJ++RD94N3o1pDp74NCuxzv025KdVDlrmlrkKPAjMLbgVogFCW8HcbqUWWIVWydxyoPQBKBR2vqqptZ1JJk7raUteUDffgYqnkJOd4FyxViMwsIHDNnDQBu6fM4F7bOCYDRydoyLfRjvyU7i+UyFiplOBZS3lS3faDuvraYCEsqkKha0qkYIqAL9OsqlzI7l20imTuVr9zAEGigw4DDkFj1PoVDA+pxo2dVnZVBWT6csxvGTm5R68kL5wl6tsagZAlbwY3gYlL4a3wyUvhreDCS3pCFHORpF6Aht0+xTtDBBJcYDH+xYSTEBoUKIABv+qHkZ/dNgLZMURvTx3UI7UnObBP2I93ZtvN7jBYtcEdcqbVkZboRQk5V9ZbOsxTqEeDmwfqwVtyHehzSgTAnNaEuRdPMly9pTFcFxKu9CR7TSDPwg9aE441DlalecqpZAppdTDaPUoUzZ1plymnsNiuNtvd6vwG4rt5mXvXnLBK3sar/twF7yq92DA0817AfDowEZ+Os8WTHtc5Bf9n/0l/VjDXIMw7XRn82mYU4WYQE8XGg/Evq08BDFvwShsZz1+Zhe0ALXATh21155nYGG3Mrub8HAcy9ZQ3/2vf9mhmqJCNhRq7bLcpVkeqGRZRxaEM8e6n6Gs+3YzxkwqSq6dzhCefJAgaJjyw/qiXPlBeQFbvp3Z8jsS5bYtvatjORjn/TuG9+9Y3r+jbYP/Y2lPBGMHG/vO/o7Vz//leSsXOzto0s51HjbaPigo+yXkxsvwAi7V5zEEnqENu7jQjSHmAeEulMyD9ez1UJG9LfsZPIbFLsKXtGud6IjDiQFjfl+WDtruWvCgWNY8Ral9C/OPXc6eqUsHvKvzSO1nxFhjvMi+en0pBJFyig4McTegtkL6STG7/4BozXkcNUsZv4Ww+bTH4UdYocEuSC4I1ZIzafYZ6rjgWJb3KmvMYmUl2fFwCiU/31IuLlsoyO6QASm4+dsZxrP8DC8I7seTJ+N9eNIFwT2zOGpBx1ZUjtXTKx7sLIP11HAWnfZVPX11kwXkxIuDBu60gYENHLaBg3y2JGsuau9CtWobQjsRsmvKjrE1pZhcT7BSnHg9OfhorieLSvF1PdGXw7qe6MsAL2Re7qyuJ/erpkfDLTtX6IsuSJfriy5Ve2WMsCekVYgj+bGfm5eA1l7ay+epS6u43lOq50EPDe+ncs25go2Bi9PWfI0T9ucr5ZqQL3Pw/lmmWDhSMr6CT6WtnK04ZY2WOcTfb1V5ymm0QCZ4FsOKxz6vvfuheeKn9+6HWED7//hMM1aIPzyNztpU1HKa+Yyflc9aU5DrLDoNUpbTIGI5i3YivNNIXFoViYseXZ0C5JeeQBjm86J0iuiS9UO3QALV85VUZURYfrBardKKWT15XuS78LxnNic8H5jNQZl43uAi6hZZrLbYaQJF7o541S1m6Ux3dyJTYjPHhU72Kd/Z8kTH7K4shzfbTEmRnPenFUJQVAjB8pRizi4ne1pOdj44lrlwFk+Qlp51YwU/Oz8LR9zauB0i0mwz5udnqRnmHejL12BW+hq5JDaPBUxQCdMe+b6pU39Rpj5a0WX0BCOJqZ+7qb88NvVXviWmflGd+kV16hfVqV9841N/x+ZTHzq5pxhurwUOjeZxLozumwnbKoWh52w+Y7cyxM55eNN1CjqcU5ms54xO1rP4B0io+5ht4PW2AdRo9Sk4/GfgyhTcUQpLr8B+a75PkDjn0sHczFaVlaYG188exfWz8rNVnSOVuVriN5RMuD2capx7zSmLmVC7yumtUySwqfhcHQwRU6P2hFgQiRLCoRFHni4+2+5nyUuwzrawaUZLVvaVTufCQ9peKYXIvPh42eVsulZKpQgMkEu9j1PHqwIfxSaisFkARwf/VRCd3g2FSmATWDQOPl2CF3HoEgnt4dA+SugMnPIpEmVvVr7M1S93cLAJRaF8NpQV6h7GyEE09mOZGplomFiyktDt6UWed62IXQMSXyG3FxFFELhFkLDtvn1INRG0cWJFxpbdinakl4hSJyQEG0ZCwLWAO3sXXjtpn/ReYfZHQv6MyEDz1iB1QT4OpF/yvXCKSEVtWB2rKJu2TSAsQnQoNB2Cf9AIJ/goP3JW/OwduNF0SQV2PYwKIKnpwJbAHyOzdYzJMlx9xYFnSGrrXbSuQ6gM4ERalG3XSnnIzrX9/RddQ/6acW0b6rdyT9DvX8/eV8V1hzQBcXrfV91J1Cq2Ajx8l4lr7AxSqexPpSF68VSy5yE/SwcS2BZEVcPCx4f5X3yzYY4KThrm94zC/NPfKjD/y4cL84Ha9gmuAxT0SAah8khGw3ok42VfBRhzXz0VXGSM7mfn++dy0DvfPwti/gvFTZoKDNXMTXAeUsRVaxHyttqHNyJ0L/z5q3ChfA3OsrgIO50/aInlQXyTFZqxztQqm5op4pREKwuLCMrluDOPmuCRhokb0rAvA3A5CqQFl7iJA5f1jKt4JHi4KL5fbDv4SBD3Hm/3Q0+sH0VMlrDYBGgVqf2uAGVH3IGRXW9NdK4mopK1p0gI3o2h0COO8tEoab6muf6hdRt8FnWEuw0UcRvjkHfFCSWDIhkaXytqd0A8ZyeVy41N8itvqTZYq4/7d9SfprZB0BYCU5jgZq8kExc/1BfGWp9fm0eofmRoS9P7mDH8s5JtSePZYo/rah83talmT/o8PUmTwzX57a7D3AAGJfsDYCvArUZG+p4cEvpqN2UXf437+y+UYoL+xZCLlOWW62m6Hyd4Xu7rMLvFUsPa9yI48iOowtP7J1Ub9pqX09F6LQNSBGPf4wiu0vHic7s6+PlhP2Apt6pkAA8gA1b7CfIhIKnaB5xmDKCFeNSPKDTJx8o5kBcMm1HxKlCgIgMb20IdTkPM+aYLyQcSqwEYxXNjHkbcW8LnOPfreYXfJ+K/y3oy0Th+5xpqhu0zTlb3oEWkt9IjvSofwuBAV20CLajjs0zcnZ3LlIUkBC5gVULgAloS2i1He7E6rSdP1LyyPzR0FDUUWoOaxvLR0xppWEzcmLGoU01tnxRBLxeb0sQBjjUfKPHST7SNiValfgLDioJM/f98+H3x3xZ+f++P3P+Jqouw+Ll729R1Mpa7LyMLcewW4nhyIXbpkoomPrxKQLqwGOsHb3cLckC17JfdghyT8yhFMRZkd1WOata4SayZQ1XaZ7gkWIF1yUVcrKMRC0+g9rP8iRU44Mb9kipFqgfyWNCDnxRUV+ARU6Rv85jrQRu0BZF2IjbLPoYswCMh36Cc2hxU3oKTMvVQHohdCxPqEtYWdWzHwPkV5Qq0Anyna16IV+0MDIMJTGBURfyVy0sRWqdj1jfRpcxgs5qvctFM7jasM/sIGULpmLQUzdAeZO8QXtsftUOV7vVkmQDf7WV3IgsMLClM7awUBV6zQONNrY9IExOobqjbQowvHtJggRvCMsVr1p2UhwiORziwdr98FIahSyjQCtSG52g96Xeiz5npMsbdmXDTmlCAhNTlgLUIE0iUApThmb69zpxEDLNKFS9N4eYqIKoeLaRFgbagcMgYYD+nwnMZF5CB6tn1Hn79w5996P0f+dQrbzjKyWC2+Fif0Ojs1/Gh2HmBC6fCx+boPjkzCHGPbkNRBQqRseM4YuY4sAtjdqTihyRRbeyqCnbkgg0XbMK3NI58RRs7oQhq2I1B3hQnVnlQ9Y+RR04NW+3tCN6nzjdG1He+EVEP5DlcZN7YrBjk7yebNLPlgm1xitsabWZrkLdP1Eyhx5bx2rOXl/e9Fb+EFTYkonRjfcQJD1Wd8FBD044UDWpMustoUM0VG52MLx8M2kQ5Tk+dmsy2UXs4UAUWP3sPRt91sojKvOSCLDYAiqnI0tdDjmA/LrF4ivw+BXxUMW4CBuMUbORNII0MmXdcOydgLYGGVaA7SFJzQHU9E1JLHRQaNzY6Kmoqx/hIk5ZCAqR2gjw1i/UY+PdGTMVXYVi9ILrIP46+1bI/F3K9bVosKKJeFN093c8+Fircdcx+TRcmR/73GN8h5e1a3wlKQLQ00pu4zJpybKXed/iRmrIGdXFzxevXJz3oeEPwrhVc9ty9dOTvJ9WrFN60aaMmXfWKBc8Vb+SCRTQAS4QpE25WTYmUJdZSYHHfI28S972pVzJwU0JJYUUZLNj3tOUffMEfP/WXOOxRPFwv/SrrR+tvwAnfC44vbviNb7a44TcejrjhvaPihvd9q4gb3v9wxQ3P8qH3Jp3eyDk9r/o86vuCoAZf6YBYCjiwcYQCY40KmMYIlvvWHWfNiNb99JDnBRUuKlBgoTfKN0UUqIkGvCYcI40k1XTzsw9UOSS/5JB8vOrMA4fkI8JxSHiB96lRDulicAtHLYcU9D9maUWgHFJgOaTsaMkXBZvxRR98BHzRjpKitEYpCsiOkov/83inz0UzUCyzBvtjfeKv6sr9YOx8QGE8VCwkrQLUYdKQJ0L2O6oGDKVnfy37XbyRP+V8ItRbtj4hcI8NHLOBo56Zv+LdGNKV8TUvVpVzk/9O++HABg7bwEGP6mrTc4PZKlks+Rf8EQRHdWrsn7JYHrWLJSUDnVLrskKAYtyFTikBiHCowSExSdESeoC4tnafGqLvPVPxJRjgwg/s7kN+lkFxpWP0KPJZVRQnTsClClg/kWmMm8spYhdp1rRhge89iKb0ojkPoHaZAYnLo4kejpY9midUeEvRpe6AlhCkZfzyEQauPGJSL1hhyRzN40ujCNTGo129xZR3qjZhU2rgpaEvKrRBU7U3C2XHsJXmmvCY5bbO6ynJqJhGxDx5ZNzjKw54L7xU6QDMoc2PlQ8gzqMHY+Ie9CBB1fEY3/GxCb5jWiyXc5J8x4fH+Y6nlFRiZ4XF2FVlMTS5W0leneBAXAsuNtRIHv36Gk+0QokTd1l0RtUUzQpHLMjaFFbisA/2g4pGdFLtBQ6afs9SS2gwhqzB2N8jy4W3ycTdTR7hSeaZmaeQu7VRXV8fizQamv2+sbhprrAGzBsW/IPRQjsSC74vBhFM5OKvBPzhyMlLsA9GQyNuKEXV2vaOvmaoWpwSEP9dBrlNRD44bAgpmRj4eUNKwy6q6iixKdQlrUa2rIUOfCrXbzHH8laqV4KpRQmHdkksp/ND1EYhmYa50srMgVApRbtS6XmTP8qbdgJlZg5kOqxqsoRRLW+M078Wejs5PjIKbRFI143l+xbVNyxdG5SbAB8CDGM+q2hCF18MFQNWvY0hpfxe2TkIHUnR1BTHk2qCRWCrLQ6kuUWslx2QOSR9SfDS4Ov8ecOcBBiSEfGg2iF/rx8F5bKjaJhgdEf23gfD0fe7Qh5AT70a9PfmQXW4QrH/u1d4FBjBfiDEyIjPTDViHohAOVqjkPiJVB0w9bUnjI/aOhtp9NggOPjocoS2KHUSQNZ7G3lI9TwwpwM+cX24ULD9mg27vISVFUfqJ90OCz+qtKzaFB+EXEmjAWMtvcuPcd8BAPRHxbNT8KOIWfSxmyLCk8wzM0+1bQ3E0ZWy4mgZ20rFFhzjSzdbLlm39zVqAY7G9hRWQaqj2SParOVH1L4F7lQu7altV/UTCUfVxktFyt+IQidK5jemTCjdoCJmLQDj48wpeQaWB/iEHehU+tG8UdIZ9beq0LKWhMJS8Z5BbZTtqZm+KYxwFhVcFyjl0e1nhVqqnSDcHtJrtntMVJejxMwzjuM8HOx4oArZx1/uvISDvXQ64eo7VA5wihCnXs+CCCNiRMLL5YwXQNYhcAol5Yme2lTHJOjLuKAJpwfcGNs+PV3Ua8CI0qNHbZ2KgZs4iGsQ/13aU/YSh4HU3MCBGN6qjUcbL+G2xdrY1DQ2lCYOipYcjdUpxICH2vh0WKT8c4TJUACpuRhdmnE07Dr1aNM/DZ75G0o18xCjw0WoBXvMyyMouqScHNfA+DvNDHfTJvuCMMEz/Trx33f1+j+0lv2NRIGtDrjQHuzRq2UCrrHLXBk/MuNdpSXna+ZcrEFN5mvMgCnf4cH6Qnmv7bxpxprZ99/+CTPNuqBPt9B8Alf0fzfFFf0DQeSYdGeq2aJnZQVDgeMLBriFrvDnzilK1PexR3P878Q6oRwCecr1ypGJkAiEFvJE3Yw1KIC+h1IJQnb5qAnw7vur+Ckfft3nv6zkLZHUaSmMQ5itTdCKpiV86ix2bPmsLjyjzvbBZ+aB9Cuc3q87H71+ffIPv/uMVz1Q2zvZL5fySPqlZN1zduMo+ka34B/75m3B7990C/6JE2/BP/7tLbhuwX/zpLbgR/3jb8HVBanbgmODlH3quFtwt28+2Q33w9teB9O318e+0e01usYEPPq/fnsdVrfX4cj2evCwttdkmG46yc31YOrmmkb31kf9sb31/VP31vc/4r31n3/T99a3juyNB361FbSW/a/q1tjD1ri76db4ZLfCYfa/7VaYpuyEB77t7G9Vt0UYGW2GP7k18kbf7/D6vtXHkUkS9K/A+8gGiZOuAE0MyIcJu+oGSeKKCEgARgzsj9kgqaqELy0Frx71AzEu7VH01E03SEcrG6RgygbJNxukQDdIfr8zuUECzZD6CTyc3SCRLqeAYzC6PdLJAtcnU7dHNH139K+3G6JvcDPkPczNEFX2QuGJ90LfKMvxV988luO1/7AZy/GZE7Mc936b5VCWYz1KsM8FbWno9XI7NY55J2AzXlrlMe5kHuPzm/EY0xiLEDPiDi+P8Bx4eTxGM3TCYQ0SOwWePg95lFg2g3E6bxoy4omoSwwNUJ08xvYJdgNBS00am7IbymS0tUdcUAjWQliOXG+n5xmnHfbEOhKFPLmR36MZanFAmQpqbRh2A4ZHwWUsmFsxmTIQ86ba1gSH0SkzIHGCw2iDsC3Q3KYcxsLYneFZWuAvcS2DUpARHBAfQuMh2CRR3QDRbiKtJQxbi+MwJIe8YoEiimjhyp4O0mHExBRLTEwhyGxoaEmVh4CAi++uevyML+ChNTzFwhSeYgEtVp7CSBA5TnmKY94oT4H5PsFTIPaR8hSf+6bzFG/yfN/xFMeqEiQ04AuWTE1ZgAKjGo5nTYU4eFTW9qTkI/zsb5WPsLKe6exGtlbJya1x5shD78W6wZjaFM9YycEzM8/ahDpU9ZWmLv9YuVUk0fesS2BxgRGJHrZOTSfnMYGacZEe94q6m8elrm/QDw7YT2k0AxZr/hReCZUDOOLHse6khNxVNDCnK4bpahkLj6HUiCIlOm6NT6UfvJTKfc42J87A9LzLkMmsZ67euQ7skH9A38AQZPxNh2YwATEpZ2h2hCHILEMw5xiCBjXUun/MRML6FVcmAG7o5wY5ZnWis7ojs5olhtQZX+07drXv6Gqfpu/3/UDwwHrR5aZihTIqPurgFZ9wgyIl6OzOYpdaLsnAIwoJ5Wx4dvEMD+ACY/b36m4e0S1E+2g16EOtYwyO3DVmcOR9zuDIXc7gyIfV4AgSXR0RwbrPgextEKmVTelzQPIdp3J1Xf0Mo9+hHQLjsqYfVyvxpSO2f9n9asrF3HdQydwnVnrYRDCWvaTcu78EGOdzOFDM43Bd3kNJ9zmv5UaLMI+gJH0K7LhYq/dTzVXXjWl5PMk8M/OsGRfWeIRqDT/Jm9J3s0jGYoBQfVynYBDa7ZpYcBKTipRCbZFxMoVx24wfz+H1gh+Ey7nQL+JVLYWMFLR7I1+E0ePFtX7y/HzJ4f0yF3jw4rzr9Jm2wG4yOEVoALJWJi0Q//HF/16/A0WxYlWca6H8rZTCx9c2PDKxbRtqJWJ7mgi2LkL8XdrjGbBB248Mi5xyoQqE2Uq0SiEGRnlIHMQdXMwL9Jhr8DGJinwHOtvD8r3Tlg69LCpwX1tjKMTVVFLzH9sov7LY2stRf04cyGmnaHlrLbRTb1ISFvwdtkRaEloXElGhNxW4kJ0oJOcIDnAsWhzKRcwC1yS1hCKlHQIGWsQjMV0stg/yvH8d1zPHzc4EIFuLUxRqO4sQg7VTS9hGhDfUtM14jD4Fku9TuMZdiA9xTeVUrjqXD35Er9ByBdukgo6twJW7tThNa5IKdmkFgMcurcC6/Qk1GRXkIZJRtvDFAvuAWnIX/nSu+VThcU5lGIj3nl2I4s9MLGnsGVTQjiP5mdTj7/Kz+NG5Jj+bVvF2DuUA0AP1H8kfw5iym7z8sYJmK3TOWrHCdw7gRlyl6kDBEq7z9FigyOM48LhLexsjUH78ID+XDFRnOdA9UDwBd/cz4ofCfKemnqqwOVVBkluQnEu5AclOgASIck+tBHqboXKuA7oBakFcbU4dfuf6QtgHyCjU+ha0mgWu+FTNvckY40Y0mhNqsg4BklETV9rG0i+H1udx+G4J5+dLwh6N38PBoxp/AT0Ga8iFijgLCuf8iQKGQoommVOnqHeVBRzkpGfzFSPV0+OU3XQKdj8EDnAbT4rtdCaalhTbh8Xycc5wwn6dQpzhMKUAsaryBRqg0JztbFl/d97lqoR+YNo5m+chrcJ4AohqCAsc2wRqjEpFPnTMAkysYaXiDNtpWgJU4UJLWbYy+GWepnRKvjvtv7R/LV3YY+Dsol23OXd6RX7ElUNbRgrN2wK10+gUJhxoN2vTUryLu1mEL2DnYPkTuM7r+i/lctfyx9i+oG9btW8HG8CAVXHYRKJMSG1c2H7MC2nhGjR5K3XpFHrCNe+8CYT9g6/fg7h+KHiDB9lOAfWK09TVn0JwC3dkecDU7gzivyt7VO3IaDceM9bsiyrNftKJm41BQdMfg6bbTjwB7b60xzFPGu3MRSfdGQxN/iAvzH2fm/ICbUK+RqdTgnspjyVvP9Zy1Ho220mSsbhQFh8IIxrCtSAdxgwm2g9BMe7mE2eTQtpncJkLZ/i1m4iDtdcXM2oNUR//hc1Mo73YL3Vgy+H5uIQuOYsn05Np5gd7le4s4LFge9VzaxiGB83zqTnSPDRHG0YLHFe017jg/Ml0mraaAWqbSWfw+j+DBU6k40++CSOwhgbDPDM8SvOPGojir2iTTizYToTEX412ghNFDt3TNfdsWGI6Cz+nGPifBTZT9FhBDXI8svxiR0CAfjID6eKB2j3R6axj0HarPz4Fw+vW+3IRRRMYxS41IDvFFKsEaK9ZtzYt+mIuersUjgmwSxa2XnEG34jfi8lwZDg4fp2434iBwB/fblsgHG1jMdJGZBzfZQ+50vFdCoYzHMlCQxzJ4urPoO3SYthH1z4X6Pw2leij+qlkyYzDaSIBNHWbyZC3tZqp0xK4RFpNbq9afMfAhn6LQfKgT+0XyJREM468e8pM1EYtoDULqP9hzD1f5t634KzzZNZ968+3GuZbbXS+pXQenQ8Oag9dAPbqXHoiM0r0uPyxdCpzajuZHXx8vp0eRz6Kkf1A3rb8Pe7Vdff4xxJ+brkguAvP5QuCowktUEtsF4vAJwYQZviZMwylw7HlnGdoq7T6B4VzRtuJA4BACAiomEq2bIZ9kqIosubY30v5evqQ50XXUSAuzshbw3M31GX2E/9c2sP7niI8oN73xel7qN7S6vsxSOo1jOpIxXGlgEV3rxfhmrfkfVpRv1RYUxRCieTFF0W0HwgNpS3ZIXKQmwjw+8AXH2OJDOYsLbGTzrYRhZp261Wes8AB+4Tmc17TdlRU1+24b7bMaLG09AQqIl+aoiJybxjWdfNpRWDkrl/YzX2IzX1EGAfE2SsJFF/ag3ngie19HtrNr26luwglgBjEYAHFuNAlTZebupJPrywkeCSIaCDUwlA3Ecow2ji4eZOaNV6gANELYlQV4iFz6TNQ73QS6nIolMoa1KT0vbAoIML/7CuyzW+ObfObF4gzAxUy3DcmZPiUEzLc54QM96qQAYlu/18nVj6Nq0IGXEzfpUVU4ZCU3U+0+42y+61Hq/vofOuku4+2q4wjtDIOjHvZeiesmSbjiEe20oGzsvz9NT1VKFEKTyHznkUoJfbk41fd0cn6IguHLhU4CJXTT6wYgWDvjdlMZAR1kYhK9FwilHBohSXQy0n6B8+CsMSa+RapdtPqjdpjq7BoVTXu2mJiS4QcM/zcDVlHjD1VRp6QvVmKNvI5LudgV8Qa80r34cOF0v1FQrPEf8yjLhrJhXiMXUQRy+RBctHFIxORR6LliIuqFerSMiX4Y6qVsuRiy5Eh7FmL5GIF8FihJSNSV3A3WXLRNc7NF1Vy0RNP5mqja6spnb/lmno4c9QYSvj4gFbkZKDosiWiYrnHhXOIONCmrVxLYmpRG1CcW7yk2xJpXo5fEi6kp16/uZCtKKTNERzgWLSYuwPJxTIKkhJ6MGoHMNAcHonpYrGFTz/713E9MyJcWJFddMLbV35dLljmULahSyuIRk1d3dXCmhzsUyWanGDrmSBZdrU94rK7m5e9vVI22bK7RKbs7Sh7u5ZNpmwkG6FFRDHAvgRhQw4dEBU2FBTlO9S3KOW8Do8LGhZKMGS0Q1yecmAnBA1VoJwy4L266fsMB3jjz05SZyEEUJyZ1W7Mcje2VrrRtt04ldraDfCh6G6iydoNJAuIDAh6xBWCFdqOmsRlUIcSramlNbW4ptnjD8YsaprdZDC2SNuLFjb5bTHinhW7Bizrgal7BbEM5mkKyPwM4Lb+p16Jt4Nz9VL7uqTL3rLipc6nzM6n04l7KnsBN4McWnqYA0ul72lTGLVUvpSfvmmxu7jYLWpmq+hyJfzH+4AzeR9AHD4T+4Dj1weZjs9/2AW0aDv3h3lJ1O5zucRQUW3XQX4mM+YBFbwkwVBvpS3EJePJRXOZcnq4TGcS6VTs8o5gi/QeoS5t4bHp8bM7lW/vHpHWUpf59+3g37mtKJc7EFY60OJRB6lsBWkKxFZodTgem5YEFE2qT3gwLZFQqCXcwmUhFsSN2kIrZtPSNq1FO3XTolVZyC2jRlCOVJxhKKjwhprHIZMdDzKoBzNqav/bpv/tk+q/Ygs8zGhtiiMyV5pa806Qi8V8m+BKy9Q8BPiHQmF9Wlb7dgK1PWKwbfdgqLi6S15pMJC8CHclJrMZEmPgbQD4rZTwU8PT2ylAVdCx5j8Th+ZvtzBt4cGTGF1bFtJSbBOYnkpngGrB/QNEoLSoXUFEOHsDlk/lD3fmOwgmNrfCymK+hVg6ripJ6tLMrJEpzUIdhQdOtgBNoTr81KUIy5BdgtpmERpfgnQBYsiidEvVrPX6dvqz35gzt/vXT8KZ202/BJ7vDvxaZ24P/N/uzG2qH62TddtWdZ5V+ub6VvPetpnLtpP009aZ2sVH4K5NUVDdtU2gGzDt/zp3bY8YtzbFrEn/bD9aGqA89kujm7kP4103c5okm7mPIJiq0lmInxrvesU8C0Wl8x1nGKkvpQjuZQ9ihPguTMWH0dVFjMdznA+jK5wPoxd9wz6M7o1iz2qAO8J3rPbwHRlhzJjButmXOwwY73v87KuPhl8jaCkcx7dR5xH7NvqFh+nbKMM1pQTmZHRRi7N/lP7JVjvGoyX+tlJxyK7P3eZJ5plV9oWiC6tWqfKon4iaex0KHQhp/XVoQkT80EU/UCXrNs3qSlx1defuMM9ILPnP0IUSYE5RF81wDB77oaQizujXtFJbLP/xtGqjXE6p7JG59W30Ho3KA2mra2EEHoEiKeTKIupx6bOI0JKqLaxJD0rvTMKGwE9l9i8AZAka451J5v/t4HWMd6ar8fOcqd6Zrpj0zuRUjn7Iq8qlIo3VS7kZPzw0KCKoLaqqZEJqYRYuddR6YiRIB+c6EfDhITSXg/Tw/Ooc3xDuczYzhPtPqC39bNpIZZo6BY+yV/fX9jv9DaiJHYB+iSpePIdiEKsr9O0H9O179e1yfbtE3/bp20WyyuR1lTlhKkOQpuxYk2JEP4sVkMTaHtaa/Qzp53IEDEIdKFIMd3AA6n8vsLMxVvsjLUoBoVDUHNqw0BcTMETiihk2zQesJEzBs9T1MKXZoUNSQv9j7s1JB9FMbTuyXMTYSKE0h+LsVTbrguSX6LxjbfBk1Tt+APvN3jq2wdiIJtITiDvm3Gydx8njFfmCCngW+94lYh99WTcuPObzus8Wrpy52EXywR0vGFlUSC0VkOW+K7NHi5hISswPerSFeiiEmY5VWmUuZ+vtRvd8bo26HFOufcT2y8uXK3vryG+KpaPDoVvZ8HkI6ZHqgz/oF9v4bdslvco5s4/J7lPPfQWX6Jj6dWGUcz+l+UrivN15qocWc0Md4LkoTxRKPqUi+kvIt+cTdaGZogjsRNmoJEQh5SBCTEYdzjYygoWvTPSyjmIm1GzZWPG7pPC1I2pOTxtSp0z2S6FUWyQqOSNfqq+Tj0eCIUogvVdTgMnTof0u+rWogDEbqJk8tZhr610cXn8g50sJETPViDpaULcQ1U1QFTgWoRbRuu+1jVxRaIWUyg6Gd1/alG0CMQ9BmR1za6qEz9sr7v8B8RhER4h/d60rgtRVr7xu4DtD+IQW14TaOnhr88yOLUErE4U+uEF17w1/OKy5+UKG/y9C8lxsU6jyI8QxGW3D4hmTDhd/chbMYEpoNwTxEoKRzAWE4FgNZBXBPWobU8dY9cfVTCaMLL4aY22h5WB0Vh5av9+6wx3tkepKRpSiK6mVu+hhAxpcJKIKL3dHSMMiMdT7ZNSTWVGsXlnUezgI5QgOcKz5QPDbfIKeS5eNjc1YCI7GPKAx2rPxqI/ZqPe8wkbdMxbF9Nvym730cDBirjMeN9dJUfa1aZam9DynPmLKqu5MWdUnTVm5dElFZx92NWh9Z6385OvOrFVItezgodKsVZ1wLcEaLKa6MWxFa7Ir2y8nVVKBROySSsXI1Ro0P9GBiomrCPY86VI0xJq40nke4FGauAomTFyF3PJfRsuJmSzsFZA9r/OTwlETV7FT1H6HJwZo3a2UWHtYF4Qyp1JAkobgExbJEYueQtubP4zTNui5U0OCu/zDHlAMfYhRf3b9oUdu1LM+ennlu3Fd405P72vANLRRW9cVPpTeSWPRJO2EmKfNbjhk77LEm91ledmhfweWPX8zCsBhRe7Cu2McAYi74RZTUeywpxa/D+HpXYDBlvsrLxrVUr969PU5mukKflwvJteDZxEKHDGLF1izeEWc/d0r8BQ71/ULmF1RniFPhB8T2x3ct2vVausLHI+BpYzzAPGG+26e1UV8WKbDiLboxeN0a99Hn3jdj7xx8NmLhyhWLNTwjvLWW/Dv98xluhTTV2zPeFhwBpQYlnDDmK+84a7fe+7u/3qv1mH219992Qd/995tMdsSzP725WJGhiLMs0u01Rdpq8+liFrWkoSG1U69suq78CBPNgcRsPVF+HkBlhCwjhGl58npSQOcbJOi7KuAGPJcVQS8/sqGKygPtVEBLB6gPWoY/Ss1ODG7XSi3nm7Lxypfb1MqrkSUVyzqg0KCh3QcqrBVqw4RmSKzfzBOOlfXsn+WoE41rJocOt0PYSZD4JAoHNDfCMy5wNksEjWtB+tW9iXtmJYvE0cXJY44OH6N5Y5p11gmYkEr9BLJjN63ym6Smxtyw8Ql/s2ogUVfq9LDFEsKApWjMR/u/1iBY2CblEBrPuTYy0xcJNoSnmAgKItwUhwmmYUtH8QYFfAlBF+2/96PFZyIDJf1+l+HtyKOfJCf9Ut7ADi2Zr8K2Aj1zIPNawlNLSoBk4ZrswMW+e6XuwbyRYR8qtZSkyJBj0/3k/NN/lzs7St1ATlRWpPow1Ge7J1o1Yr6WorEFz7SuGFKb/xysemk2buQt5a+x/fi6xzsTOss+BTWXKmCGcVCNUUNavvGyrQeqCpzmIBhSuTguYiBoVI0xofCEkrY9evXsfDOcWWbkECHKNFdfF3XHoyVdkJfs9coF1eOGzrqms9H2RhCVBdWhjCxQ5gdBM5pzxIpuAhHGsTNr3RFlZqqDcruveEkbJy89tCkAguMq4wYUdFFzALf268TgGo6Te0y+4/N4BR2i+u7O4yjai95qJLDe8Ykhx9zkkNNknI/haBIatB1TO9wTY12LhR1PLJCN9tFg2IY0RHddrHT09STiVSvDLZ0a9zWjfKM3sXoKAZnek9jVviTWfQXZAPmCTCQeJ8HSqMFC/K6CLZNGkwZv0PpRjchS2jX8przvSuZiq5kKxqy2d3ClSwDniFE7/zFbtkNR9RRFF3Oa7TFoilFIzw++o+s5rSsBsytKeYaitPANkykE5hZy+w/jU+DwKt381V1YwdlggOod680ZxvasSvnA/icjHOzQgxH7BCVFnvZHiqfYkNxJ5ovN0hpO+2EOzI/j5DdeiSUO1o7cHYr5TcIHsIS6MpKgTkPcXmxNKDTOFsdN9BULB4eBS3DC6lNDH0Rv7L2paZGLxpagbg821V1U5JQIo7MdlGAW6IchVfnzAySK2fSS65p1fUCPcDfzDkDx1sl/h24yx3RslUqW6YdHNS+N/C2X5QSa9zxuvSoQTuotvYIO7WF6hOdAtQefr/QJ1AKNSpLpyEO6hCFjEqtAjBXgRSfWNdoUmwwXmyOYnMihViSF1wSKcSs09oesrB+Cr7bqqhfA8dgEJNqbS+d4rpvl7Gv+3QzEt08mcxVnJ7v4nbvUqBBpxXP4gy4VTsDbtUEHPkuaTVmCh4YYF/MbCjjMk+LPGqwu6XyXscangm49D2DnLsErGdiiIx9PlUYUHsAgCEHYJ9e4M0ZRWp8Fp1FZxr9YBy1gkLM4keIB4QXDPMWIvh5GqUayn5WKH2oAkYQOOzB5rj0OT2/UjJXo5h70dN+BO6K7jd6VnvfL53EWe1r3wrCPHirO6uFZ/hH46z222e13z6rVRTUs9oJdAOmPYKz2m+f1f5kI/FFi1OPNMfoQ6T5zPXft45d/8W7smSapNd/ETReBuI+8pSHO2zgRlkfR1Drhi8v8Rv89n3eWnnWy1EjZWQ/KeKWujB99p60tWdFQd6sFjjxtcqUmflLlYilaGWLphmYactRZER4knlm5mmoVj95JuqoGrbCxJArqoHcKw9xNmkFsvB3m5HaN+3QLB5z1KG5q8q7Ik7dPpODSZ6aEkstsBdyXqgTpiUHk3jsz2cp0INJqSe0xfIfcMjq8M6CF5w1++yO8Ir5bD9xbctoFggpn19ZZD0uF8VkWka1bWh5Pi90XzWmI/oGgdX8VwRW898AWBDsgwMQoC3A7QfnyH4TR+TZ/5Ldt7NHQAsgDvM0X8Ycj0bMqeMmdl/jU2g2AuWHP8S9nhMoV9eBuVH6MUdzFfoxJ2QbhW5Kunk4YpBuMScaU6iztmnwAe2fx3FU9pPoGNeNPPz6dUiNYK9KDCqqnTS90aLH8JZR+YuW6ldcu3Sdz7/2uNbjrXCVGN09Row+4oiRJtXkCr0So2mMYkNQNSE8M+lwUFVBb6LlEWgLHhGs2tXV7kwdb2JDQvZBdYJNgFgwOOnvxvE+ZbLnRqfwZgS1KfjNDAZiMjn8KupqUEUIFvaryklFIpmnSPg5MTgxx/WY7kkWmtPd5Pwufx/Nn127BNfY5lEE3/H3DYlV5fMlZemWJRuY0i5IohRWbKEF8cm/kveMo/pEDpBxZRss6Aqt0qKQS26/AKiLEZc+RmBVUee5SNdzgS2cf+GAvjPIuY3IJ6IUq6zJ7bD72brCR0vKt9IiQ6VnTjq2Un10W6tnhfboKsPszARxerSErcQqsGm1tJYFwIi+P7a3uKUI+wRdcfC8/QBSdWtLcmyCKwBi+WYJwykq8/fX3L6WFEr5su3DFlqGMr9X2S9vld1cHVxCnhOetbzQcmQri17VER/WFMYGflvtXo5nQlHZqDFigMRk8kGD8pEkEkgAfyLFH6tVvmoBUc9XubpFuyNdpB4HTbvxtj9fxoBTzzSfP1v7luiBDiMtK1EYrV3xSWvtolZa4l9UUi9l3hpWWfi0apaARkvmUp5ii71Z0EWDu4I5sncCgPy9XK9OHHgJlRbo7FhCM/TKh3xSbJ3qs74hbCR2rOiF4PcUQlSo9y7tBxW6cy1y7Fhzt2NtAKbao0wngY/Ob5XWYhuLpgGrt1ZomNiW9xR+1BDwNyE2qu5Wm7J5zTOzs61Tpjcem2pSYwftoKbuVmvU03tyZt4X9TW8M2asIWqPkgaBDdXthrU6NVOaw9sczeobbHPJAfkMjPh0MFQdCtAjElX2pnbManppL+vodsTNy6R5svpGaCRxoGm1p4wRTTlbBCaVMv4m+7L1kxHjQr5J8uVY6erzVZsNkvGfO2SMp5kDJ7WMZ6LNed1F59kN0vcK/89H3NZqs4BTRcow8cTNF9AXjZ6wNXoPzEnS+ViGdQiEgqrsqqiLOSK4ix1AZS/SVt1ur7dBCQnZEkqQEblvoeYt8kWptLhxkd68qIvCglmwGBsAHzVkLG03pkWzn0XfKtL19McrLi18M9UEQDrVRDHN+BeO1b+w8T4cQqesRoGonuGYX61zO14D5snFOnn2P2+UHokrFi/7jeuNN4z/x5t2OTIgT2/xYVt0Ya3HIV+v4+klvAUJ9eTwWg5O4dLvHehW9WbcA3VmM+qsFxbIn6lmtzuy9KtGnykYHimqTuzqztpF9+x93/sv+VelP1mRuExwYFemXtXD65Aa+G+QHRbjcwNqaEjSjpSZh+J7eL1oOkeDyGHr5MKGOY/evgff/MU/ecYPX3HxsOLBT86CGQG0SNkZtd01O4jYeJLNSJjnCOgS+ENHs4QWdcRaXc4BRjjk15W1bMK5e69y377whvZX/iG/6cmUknu5sicmrrIUlyBh1Bc9yuf4HOC2z19/9K5XfvUNXwM+buLyMRk5RJ2Xlb8fPj9fcA1NhDwjQQBPsxRmN4LzMfvmhGT+k8BhHb+UMCfd2nfJr7zv1i998tVP/pFC1nMP12ey33mVMqvm9XfxWtqSm8FjtVgS2YcCRMMgLwAYA8gArYjlDsUMxRzBgRKCS1bzqyke/IsuRnRGvkBebpkzWwpZCNrehWkzOYjAI1OZCeVb9Bwc2N1Qp98QAcb2c1ZYHhLuG22BXAWHXdyCDafCzP9wMwn33ooVxsB1eIel2CE7J8egGBBxJM++Rrh8/9lte2gpeoCzf3P29bf83PVPIvZknQAJPvTzL/zA0V2Hnly18p7QIotysfMB5q9wRQ5LXfBKRuYYG60FKDHO0jwyb+ERc5kb1cy4/MkqVFapCGaZQcba/eg75Q5XWZTLBRZ+t535P8iKFXocZQ+n7OTwjat2jC0IAE42+ag8u8Vq1YW5b485fXfMqaZujaf0p7sbtxRk//yy8ks9WvW5bPU/qKytNTCvFhbNfgiforj006HXmbSQKIqqnrScPO2HvLUwPKMnymo1OMSBP7gAs07pkadsblSKawTdkU6p6hbyh9viD57T5BwUX/otNNEjD3T1Uze4gzvTT/JEqxtZ1PIaiLNvm1FEsr4roBXsCY9barpgy/2fUi5y5ZorT1JK9Ow2b9h+NNEP3kryH7wGpdRAn6pLKjre7pvGtQqWXAIKKEkmMG5o6ZbFp45Yyo0pBa+hbsrHD9cSgQO4yNipe6agGLihrHewqakz3VYifJUzyl4zHq1VASxeM1Wc7mMcJ6oANy/dV4Dp0XXDrNXUyG5VzGSIuVzII+A5kH1ZoUgeIAu4qpJd1aTmF3w/5nMBt8yWBmWlwjw0s16tC+ruVMYjxkPOzJ3mVg1KVXr8jRf23+ynRh5CkXJkFMiYBHKYY19IkjkGzYZaqopvffjICuXU+YCwPqpfmcclvwXoau1uyItIFSIBTiAcoGhGWZG9bt8inb86blUuCAgckhaiuphQqYKDlixPEC8qKBnHq1oDedlfoGXAGcxKaatSHg6T80hyKPSjEd6zbmUaencFIhvlmfhhjl+S7A8wjGkZ0ZLY/f3Wc+XMH4IUsPeX9bK/ulHLQjrG+wAnAS4NUejlGyrqYt3fz3Zgi/QyWf2ajC77R02Oq/9aT6xgwIQsl6UKUZiy/N9g6IxoQaCzoRpX2b2oHp626qhk8w/8kQ+odUTtyb5UXL5Q3fG41caj6alePU2xZ2tQbMxZe+iOKr8CB8EZqbS3uhYFYvIkVd1ye/WTUVXvJktbwSZbzzOBTWEuKLDn6Q1MeWGc685HrrdRtNzSSzZ850VDavFCHN4yxAarugBTwNeI+qo+oWofOC7P3oC5jGHWgfay2xBR+E6pUFcalcgkD1OzKJiqWRRUNYuCk9Es8q1mkT+uWeRx5AOjmkU/f2hSsyj4N9cseuOhqZpFwRTNIh2USZdARW107A6+TKKlFNWkTJ/NAzyduzXSNE+pF9ohJNwNOYhNWm1VS158wVl0qVQYTZ841cXRi6a4OFLKYdVywKq82ffqk9yFIR9FeRevCAR7hEpGFgdQpS4CyIOFuQiAEnDcx38lSgQWJdB+hxIRaggotsuesEGizYdaXdUxF7s/Dy1LBVlBoBiAWuGvTxhkfIkQjqXP029l265kOwJRbqES5JNHiIekGWwQSJk7AVPG/xWwsT+5RvpmlqF4QckQUVDpF8XeBX74/RZ2orqGqnHgAAeHviCC6FZgMVS0y4a6+8b6E1g2sLKCpAdKU//E63zIU7B/vXcJytTzDNZK7R89CES97aDAmSdrCGIfVlXVIRvPfglVdco4nGtIHGDy81LZW08eP8IR/PA2wY9gHD/Q//tH8WN9BD9KOEWA1L8RhrzpuBjyC0h9hNP9Fyeme1id7uFJTverT2q6H4eGeaM0LLQ07BY/wFlMOHm5wnKFM4Hv14R7v3qtgLK4tOGZbXFwB/YQSOywnep4MgzwLUvYv6ttfY3fwaBAAtgFIGyyP29Yu93NtVw+oEjz89jC0Hb2ZkFXkHHwDSHcwUUaCYYSGK32y0Vo9xZTgfueIkF4V4KLsXGJiX0rYkduOPyJ58UOLFje0BHZOXImaGwa3p+MZqgcdceikYhHTSgBQqsYYaGFCxCIRGBvA5QWczGQeIYWfigAFeQx1mMuBkCPqbaGJVZVqPABdtMxJXrbKIDHQT9ESK5HtFIrQa7LDkPbqiqdf6aeRNzYBjUPDDzVbAs6WgO6q0PuuSEXBHZDPfqRe6uSv47iQWLRAP5I3lbSpZpiQgQUiOV6LkWVMapbwsUUQJ2YBiYFaXVT3Ntl5NIPejoLdYzUGwpBk1VjAus8nnzBljXbQrwARhwNILVC1aUkf7TfvsmvuXO/5Y32uYZYOzycYCCONkhzqkXYTFovGXXbfwm9psM3dxYq3nx03071p7fRaX3wRh1KEX0ub3/e1M1aKhll67hWtARnPGqguoZxY+W62K/B+yRjy3eDnEC99blFW5xtKARa0gctqpHPUEuVgvDOb1ifqIGFIee5hLozahnhIs9rWZKEvs0CwzOaRWOKWQjMAJ6QbdWu0WxPtFepkXf4h2akuEypR7N/HapPTAMUeAG/kCcsYaIhlY5QcnqAOA0hrhUKIUCnMrQDrTb6NtovL0+5IrxJrQ1Vv51FvICwgS7U8KlO0lT3v7OXFqEIIqiGLqArLNnTXYspqo2p2yGP0uyXBV31VLhoQDshovZ+yAs4qrnG65relFfcbdAsDwmGo0UdzA58B4UoJU+U5p6jb7KnriRCZtTKoUTkURvnR3AeFakBTeCj+yT7FSV2iSN274F1R0fhfIfZE9TOF2oXFxIfC9ELq3Mlrnzry/Lgo8gorwWaE6XzZAdxScxSUqfE1YcEwQrfXEKzSZauhVWa9n/+xH+5P3K5MXTrL6m80LCJ+tC11XXR1xRPU/QrFB/Jp45iByqC8PdbxynWwRQqQWtCPfopKxALFlpEgCHxbTkohXD1i4UKhjwhgiJbXLUkxbvsTr1Cl475g6LQoeDLA9kwA50sG4BTWXM6HFOE4Yuqw6d6yTp8qeTI63rN0IEuZuLICeCZZDep+8uOAZTYWzRDXXOrlkDQzrVwbPRSM+R6PVKnl4p9q031qk31yqb6ZVOBBgxWfKHcvoIaEjXjpCciiLXMKsxTotLzGBUHBmFDZADWata69gerhX6hCaY/URWhhUJII1CzMVvqe41RtkdHO8QWICq3JTEIySW9vuxNRPCpeko6dDEuzyWBxKhP4oRXINOvgF+xEpX41FR9KV/JOr/6StaBOUrWNSRxiaK3zjItuE7SGsbIp4sEUnrKFBZ8BZhMTgcZ1wYpviZYDtKyQel4g5KTb1DDNGgNDdKCE4rBtCgwYJJXpd94EYxaS5+w2W0co8UYZL865UbOm5p8sN0oNaZCnstVjamjby81pu4xGlIfFj+Jcpq0IanTT+PuQJrqVqEQlb+AkOw6gLMLHIKreD3UnUl0APd9jSqQbkoS5PFkuWzAPF1THOTk4niKoAy+kbdh03PG4kQMQZFiR5/fRFA0U5EipkduKWYovQVqtFBgpnYlsSmJzTIx4zNWHAySr4fMBW/37gCdSow09UYfvwf1cr13oAhV7vI2OI+5I1iDPE7UXvobQiBUznufpyV0i7gvkxMvq0/r6bdf4FRosuJbHH+X3wZVvbpC9LWDTQ5BA9iGJWAg7K2IVPweT4QK96jVAmkd+dk79RaZOv7OoOo4ZABkAhj/TP7odmfZ6EohyBgV9KgUXZZtMqfxmoWP6LNX4j3PFGu0Su2aGVrOQzOoerc7s6XMHGafvnfIzWnxCexsWQPNVs/zqLV++74XL/zyd376x9/Eh+az5mzxmieRC/Lp+Sygewl55kCm72XvVT0I0y50Nxtk75KlJCPfRM9WPMv9mm63uT2ZNHeo8Jrlb2cFTd4tH89QQDBcJIrpyHEVjoq4mfayL4aNOogNSMePuNDs1/H1vvTH/3vL457Bv5VMBzFmcWuOWmb4BFypipnQevxm50pS8TJJTdhm3WA8L/Adq4vfXmQuveMOi4uod+Q2h1HAedgkqmS5svdgUMRCrPVsZLSebPCGzT4KsG+8TFyyh4QetIDl2YbZYwcbPNUQq90I9uPMC13RHHo4ofJmPVmBNOqYh9mB9e0LoT3FRfxHatX49xyy8UdH4n+jjD93ejG7JqK5WqaGlpE46vlwp2ilJb76zORHpselesyr520eaFRUPRqJR1XXIbZERmb2DWNs0BPGW4aqpQ79k+l5Yorl6FuOWCke3E6BZKQae0yT1EERCX5hCQkoVDp/axDD4LKvvqmcn1TLGypNjSjE2fCCPOTujNyfDuVMjZst/ArPop8BQLEcUlRRXYlLekEuyEoK8fobGC3q+2G/wWWvulwN+n7Oe8lcN6WxXkJMN4poSD4rHHtY/CreStBOMFldtceGVMAjex+aNYTqUuLarMdCokQhpuDdd0WEl4W+cfCecnqvSA2gj8Al6wBtYbCCGHEwNcEj6/zAIVWLNVYC3IW/CoeWTZx7Nc3tuP6na0ZhDU3Rk4ryhI/C6gHfq4MAhi8CxyO5260jvgFR9Hk+qVGuu70LNlWFyfT0ur8T0tUaFpFUvrnLy2N87aiqn71fJgcQB9ipuUa1SmrqWJDqNjf41XP1suguiAH0uhEDTs3/iCd8wg+byW2e5+8UhijcMNR9C1P35sZ64at/PwxWgwJ3gBdwNYdtSlJNMYeuERC+CeIw0he3GH0AjTx+X2Kqa7YUE8Vd5v+1IML8UOepVjdiX2EcD+A8ujKvZeOG86n7vecq0/L0cWfCcSC7cD2KanDGA2tGv1CkAbwiIiIrUkoH4qqTy8vbMglaBJRxeYZmKYm5YzAUByS9hdfI1I1mWl0jBzzWbWgxwv5q1di7VaSvy5uw2P569pNqAIMC0dH3zbL8Z9ATU8li9kFZqz76Efxjz2/4soa2N8npnAGRbh+uw5CclIPvjlqDK7raFSk0g/x937Ox7eWf/w88blriV7j5ZTsAjzKel5i0zA0dsRRzcShtVbtK6c+HdUvcArEmP2J0LFnPfTy7efDwhhS3MUfV3CJKZBCLEByS3BySxZpf78PkCpVDjSCFAeDAjsFJmKemBZnDqo4i1yWjWHR4HDPX5myE1/HlmhzENkMp7D7jHZqB3FkfqAsUuY+HbDh6DmXUw4rlYzhVgGqe2qDXkRelQl5KymkpVwA31lGMc+09zDsEOywozyN/KJyFSd61d51ZvFD7qRdj7Je1Jw2F3iGuue97782u+dEzPvdkbrAsIQoL8JraxmQDPWsxeWW8HmiXEmodQPQANVIbCD3Q3qnvM7Us3W9IV3zyb9emUTBUrAzAaGE55IPzh8LEN14aY1Ba5yn8oO+OJ9SJpkChqDtqta7GX455eQP1DHny+rcYn4uhugPve/hjajfTz4j/LsWdnliuLnMTRE8afoXd/TqghZhmnF3bGBRzNDcc8KxRBbqkrNkEGjbwVUyRuVuKeX7MX9nDL3H4ymKhV97vGawX84geygNXgj508L/f+wff9zNsKeY7X/BHv/G0P/i1D7Jqxc5bPv7ET838Llx/fd8v3nzDYMfHEbvloqf/y2e/9vccW8wf4Y8Xevqcq94rmjtCc+RXYoaFS69k1VtXWT+x16zgBRWDNmtU6yN1rpwvGgc8sq2mBWzilgRF5phtmOHImUsBWdxfkTtTMxtH8nmZ1wpj0tzLw7zrJutcf1c+w4V2GbbgQteKzHAL89wmMjMo59I4uphBexa5IFrGf8MhzR23V8ZHT0f60Ya8o00tMFyMEsK1omWlp/8LPd+ZvcCPdTScfRg6o5qgqaOGMNLjfPrbJ/r0db7vVfx+V21XCncHUi0n6PvI49CHa2vZh8zCGTNsjbrywRvP6SslFwfP+MII4H5TiLlWirqVDZbDlt8qKf6HVRteu9Ay54zWqlnsjIdS0En7SfY60dXyxIwd1bO/xC5S29b/mdfwOaQkZLcilzbFpL2S07I3SLQnCdmnrWW47Cf06PJ1ng8aYAW72dsBv0LNahkwVpcClW1ximqbVeKN9NdTXSXucJUDURYV57CX9pgThXoJMH/MpSx56S8n/sJ1YZUMhaWmZqSM925lw3dRCLtMpG9dPZWJ9S2RPQ3xm9N0q+v+p8+3cZXv4y7a/HoLEvlN5sSpeYNJ0aODJiL25Skee/QW/Fl5Gw/KZ/BI8g4eC+LmeNYI6jI1ZyLqibDlKCpMeQQwSmgeqsVWexFmT8CfED8WqYXHEqV4wHhwJFory+qIYlZEoMsEBYkYIGctZbhP1xATTo1YKpMWRpNAWina4JWyy1MX2IGaF/HgGY/HEi3gsYAOQHI5hzVpDlN7Po9S4xcD/Jsx7jEPlk7vV1c3NCuiSiogXIPrlVgwJN/icKcr3GBXu9HjBtEKczDUyOdbIsiGx5Nii7YSBaAu1SCDsqrZTswDM+p6siTj1NBxauo4pTpOLR2ndmk8NaPlyvCIwwxqu+GIAQ2ekoBGE48FauAR0ayezkijFeziEWHJhABliVgok6JKkj6gJjcV5E57FWfQDvIMdSTMWiOo81YurjPDCduLWN3nxPkSMG10PGKMR92Ox+Km4+FLv4YUb6y7YUGR48OyKOXwsCwZ1WY7LHVaUs1ZsxlSg0K7i0ViVLusJ7s2SCuEe8l+RWh3qOftod0TUn1il+jWkHfPNlvMtswZz0n+6L37w4nbyashhxeq02nV/ny6sLzC8Apna3cVRYym1kWjALqeDajbNNkvSPYgKLSw+HW26Akmkpp6lVUOZvUqq15W6mCEOhsFRGn4GeZOVIeVn7dEST4n18kywDDBdVYO0yyO3A9sMDuxsT7knHMY8TljV6X/WEw2yzd0jIa0UrGMe/aV+hoU9A9wMLOUb55Ct1/WbPchWzXPgiviU+Npi/xyc2wpp8oMYshq6yI86KkGfIQrsjgIgFso3Bjs6mfiCXgLhZB1qoEkvSJrxHahsXwEsTT1cKVrK5cBR1TbFJUX9J5gXSbodtSFGQw9elKg57gJDzaSbT7T6hpahZPOXO37iNWcHagGzAjptMYgUYGbbtY3PcO5W9pKalOyBu5T/c5jolBnjWaqrue58BYk8satBxmOh1CJ+D/a0e/qSOFlhrbrOC3T1gOQztO2A0AW+IYRVfYtZY0o+TmoRnCGX64uXwb89qLqWxm83TSJXJMY7FL/Km4kbqd5MeeL24E7qA5MK2gRwCNasDAETAAm6sgtXXWKB4Cjou6teYZnwtLXfgYzP/mcWDAV5ERKphlqnN7NE2MmiyJ7KIWUndLB/BQibmYu1qtmaAd/Xuh+QTbvNGv0iLU443zIwOYUk7azkqZt0H7niZ0ubTzaDP7rlI0187HfYuV4uXqZzykE6np1ua2AkDbJDd22Qlet06uTmkI7UJyiKJBwMzJw0acMj+Bda7bN0QbYVmk75CzRNYUPXeGfewmDUuBRMEhTzIIfLW9ij801o1UvVhpOhYRCVkWm7//hvI89/qmHPncx9sW+bJoyIXm6SwPAHRH44HXCIlWJAq+2uOsgUwaFV3Ss89Og0II/ll7jKZ7YIiaHeVcnPKj+Ltg3A6eTr7jtXH2j3KsxBDfWVbS1Dm+w8ETX48dOOEYH2gFOZxjbI6EYSG4Irp85RFfOUPrdsiT4LDp9LOZshhvz86BQklJIQ1fpbEXzs/DIlWJskenAdCoG2p6DW+1VwfQpLoiDC9yMqcTQ9r6o+2/HxOoQfP5s1zOHgs6kc26lczjJv6ZXBMPiMbfmu92nO2XC54wilLcN0WLctxdUlb0TCkBdnea3UkZnuj0WzbCS9Y8WO3pYUHYPcb6r2XWnN3srzRInAl07sh9r02NoFvkyGzOLd9AMFLGTdsJsDhqmIhDoekVP603OIiViKlzceXuepWppSlbIvF4BHezpkSfrms7VW8xM5SSdCnZ+OJ4GtgT0DjSchPOxFRraI349h9u7C42XlUQdUbB8B+lbaCuWlZxWxUYaHsT5/fUc8OfmbjcE+FRdyu40vMXZ5/mvBTfxWsdO0FkTcQ3Q0IbZkIe0iAuwKKb8ZGEiZn4iJh2PYX7E8i33h53gWit8wV8oT6/8q1xCXS9kSld3W6HuHJ9eRHhcXsSqAeNRBGDndd7lOyfyVcFrU3xVNSCw07Usx1t9PW/YdeM+OfBX4g02KMFjtUg5FqVnYjQMocr1XNA5SmVLOGMyYUHpezDloeRudqOYK8WhkCPkEDh08cdkZWFaY5WjHBU2wu/aIu6D0iJc8V1adHu4gdnt5Yswy4DAMifP09KGbHKOMP4Z8Z4labR3OGTGqgEfh8Jxq6l1Bgsos05BLqmNgwya47yDAkUuDgquFtdLBWgZdj8ZzeYdiFHsmUaTcDzCGUJY2YIWN8VGnKxy1SWVsnZlvEp5Yd7ow5iyUL4lHRlo0erVHimt4U4l3VDd46ktBsg1uWTgu2qg6VXWgMLyNk6WvraXBgbfQn6mCL/Yvy4peeWocmGNPBVr6xIS6Hn5HvL7NwYwYng67pDtsfxh6IYnUh0LSSXOWjmeciuBiXvKXrMeODxyueWSYKXPeq2hCPoDXyWb/bt58OLJmuMTVbvwiKrdZT03U2VJ03Um4N1RpEXmdYJPFfOCi1hnMRh0gcJVS4sFTcUCmVMoQ+ZUZdncd833/+Orr/rhL1w8XMcpBSQVM3gIk6ZG3nAJQK8riOWyPgeg2NGvWbGq8teoEY1sIZeMyqxFcW89l5M+7HizA6D2TTDWLZZqHygCFkyoMReRRu7PF5G6QBy/pC1ZlmE+HJb2XfAWlG/9NA9oPu/SkqxzQd7RAdJvuBxVbBJursuviqZayFjyjEu2w3FQMb9Li9hnzOAxo+5TAupwiqlrTgtCMWW99kRZa6pEDIq6VLGsH9VLqQrVr+xN1j3HAQBtGU+YBZInEx48ZSOfQRbaUo5N5b1W0Hu6EhxMqvs8vZXXkauYHRnsYkZt1MXUkSpJ3+UEHdGAJwE+gbT9SiaCnBe4xwGLsoYo4UhMegJvLvd4lQnjSG69T9XFZQvWCHSbmgoeiuSe+wVo7OjsqAOL6mOQaQo9YnKKN721yUgUVXbPipPLFid5UgNyy+L0RlFymeMYJ1sGqQgQxQhKcEHZuCaQHRgFON4ZkD/FIswKH/sOOIkQOBxQKw/UoIiWJqru9vo4zQF9YvQl1gnf9xhtN/x8kff0Ud5FY5FloSr6iUVQjvMqBsNRX+AVMEIiZl3R5kX4aIaHqAuep0sdCEeM0MRuBiKpLxS0naegwG6z6KAUJm0xf7skSQGK4zJQi46/7j26aLmKXnwp3TcdRBHI6p/J3ee8/CubEbTITBRqan+qM0K2FQBIPEoBm8DjpnXikqHtWWllaN//uPTaB973n//y4iFuGioqtxS9F0fp1aKlV47oReuQIYPq0LJQnC5GGS/YjS4BLaxjaiCO2EZbVsZ7TinbvN3L18Vp2xKIZXWBeDEmFKCIqTIU4AmFpy6goQZc9MBDgK80SGiInkZGjiJEShEwPfOOZY8NGObxNt/fiTexGdXC7F3USalhowsDPKnM4hhMDGZxXJnFrXJRV2EctNewDNlF+XCod7uXoUQ/x+3WcTdLc6+SKcHK7b2gaLFogPDDx0ez/XD0g1WdmgAlHCiLUEtnG+j3IsQsILGQSeZd7h0kpkqO7CySrWlgJZeK8eiCk1ktA2aLgNJiPzJQkvVpVWa11prp6ddmkzo8ij0iAnfawMAG0FuSPIHNYwODwOYJtPFyZoWuyjLcUcnAvIoElgSNsrxrej5v8EJxjJZIQ1smFjYlDFvsulZEw7GlTREwHl3UrJlDRiS8wRwpQ/rS3n5uRFeg2jVQozlL2hfE2BhIX40hwiRuN+nLnXgh8zLAS2ZeDuOlZl8Cftlrs+HlclsAXq4gUzRerjbHe2pySgE2nxL23Jh7LEprrqmwV3EIswKTngKRHCya8/ImFkGaRVy/DsgDqHmGQ9/9G+KSLt/Kos9iG20b5tuptVEQ0TDPFTvmzJnzkiBlMSvm5uar87xdWcjAKlV27zpWMS3IeG3RiRdhKLatD3J+72eKuj7GaEZX7hmaPyAiQwb3vPiGjlVSGk/TMcK47/tNzzjjyD2931NtQuKCEPdUGg48mp7PBVXtvZhUNaWgV+xQhqdbsjhAG8ff0Pb1YuftQ3gPKZS+twm9R1ohDhZjNYTPrwm2EB7toJ1s+Gh81V/GhcNSWRr2OzGjY9rKfX/ZCy99zm+ectGThqLC7oFSDuFpsBholTkqbA+0tgjewRN+gXqQLHFqXRCIT7Eh51Zvb9caR3aBVMzxXW0SKcLy169Z+1sx80pghtQxAeirSgH0dMWKNRYoAxdhKHVkdCX49qAQysMVJcjelLh0SlxjSlwI411YmTQGqZHd///Kt6LqpCpORlM1Je+KAj5yrzh9rB6tyHmsPhLys7+V8+kQRgfJy35bN5L6Lkfkv4OYPCrjgn2Pl39/dXH2u0jiYyFIH+yG/RiUKCmuOKUU8GwwBRXobRT1irZ0nXlVgVt2F8rCl4PS9jf3mb3m/Dk8ayILCzY27O7vnL16ni+b39/TT2FvTZtoPl4DuRCuD2g3rVOpNAkTH/5wHieGQfofaj1TLSh/+PDLDnEiQTyw/fnn+c/iAu4FlCgEccx+3266Wwqe0/2rAFJRP73KitMja7B9l/+cohrDdbvmJvZ21f7sDw5Z503gHjhHUmr2VdQLEtH45Z9VZshfC82Br2Ac+5/DTec+20MB0PpHW5cVXk+VCvSUHV/1b8IHZWwmLQDbyVk3UJMevtsPMl4oULaqKmta/y9fXS0iXOOqGICuBIFQ+UXoigAAJbF/18tcEYmmqMYDhtVqPPxjPWyKVdzwxc5UXd0ApE6hWqkJKMw+oqOhhvsTqPxCIwDyl7xp7q+J2Wv4FsXMbcvMhR4WFLhCcw9GP2+SDojI0qgJy0LZK1Elp/B7T1J4qkHFC6ag9NpgC+ulOlbARs4uvF1+RX6YdaxbA2accT97uKHGAaoDwm9FIbaZXLlegBSnhHraow2D6A5ir4J1gVLl2Fv97T9WJD9KMHOjLc6o7VqcJ0Z3UwcZZ5ZJTwqD9RhCIf3tL3y+NRCeqYmBGXW1MUvNjXyuPLLD2aldI3U9xSJjn/m8XGzjE2Nqr4kl1YVpmagJSEMxiy188gM+I3o5v0oEE/pErsFbl5hoNAbgUj1L3GnKLpD9fq+s4IP2yZGijJXQvLCkC7yQzHPuRYEzJTSX/RwsMqN/aACsj3ahZ/ZQu8ZkPoziun2ifM7B3yM1aTTTVnumY5+cxKZKueEqsDQtBVCNEIHaiJ6leRSSoNHWc8gMeJYZamhG3VNOjDwEtJJBjSaEgs4HSjvHfZYVDj7BtDGfM3bC8GBcV5elXX7AEgc/xIV1Xc5AMSsSWNuMKNmAHiYFB9Y2hsae4uVMkOfWi7mKVeyK5cUy/vBeckG+LeEXCcq7pEf85OtcPX4XnP6oXlcHfUSr4slWNclk/UPN6ozVXR2okr8agvoj62pQrVcgTn2MetkxpeSiL4mf7oCiUnY80CVnn+jdbnwW523oM0whbYy5N/8vnjdpVAi3plRmFspJVf/Q3zDE8aaXodRym9g6yf7Y6otB9+FPxq2JvicMPdHJDqfcW/AoMBeBPsyrZ5T9qfQpVp2pLtYfcGCh0GLUiFDXeh9/kLujtwTUk1b2MVlA1FNkfGmR9CBmIIgaxJWvVqdL8Juluo/rB8rc6Fc9sRai9iTb+CLOPoFc1klKjEeo9q/jjaq4GzRs3+7oJ+495+tnnnlllZ8vc40Y9MyDETPtATWgWe0yg11bh3o2XwVy/DelFWXG24uWawE119W7YNG8NbsZAdxK588N2/Lli3EPzLUAhiChiO2EGz/i2sx9WVfjpS1qHhlqeUPXtpStxgeqYBKLXYtSbD0kD6hDdYGbrucDY9sGg4mrHp8UiHoKUXefQrFI/y7rrcHLa2mI5GhY3qsQPXtP+2rua4bAg0P/m1HUHEpwoQgNEf13JnpA3pFhxZfAQeEZIasyXj3uDM0LQRxnXzKI5OwL9k4HQxUfwEoxRFJoD1oh3Q5hYyzS2gtjEQ0al96VU9wYRFoM9CIvzUOr3BYiSUrL4XqU68v9fjJah3hONGWLO3m90M8Bf7QO2GMKUAdawuXIoRxKkpYKsH6o7ZlvOKu2K8eHDHM3LGISKr3FC4PrHH1a1Z0jgi3rfhollFgk1m9wNYh82ROqvzKdbTWKeb9tb22T1ozrN/2vwZDUNRt5mIqDu773/A3dKIY4JPZx33gDqpuWjO1jA6jpO2ebDd6qNMzhkc/0pvFi7yUV16R+iT5cCLhBGMYHp0tq04SxMLsbmKnSKFIydy4/IBuG3h4I3u617M+QSdeeEA+xggA3k1jKdqlalqdqWTXm2eDPL1H1iMaB7M8F95vmOv+o1mrqgi0XbIPWNBgQOF2RPT4/Qggj6rCNOYt+HIIbftQhStl6SGL8se/LF9Sm7KKegy9VSp5aX1rZw6kVfAiRjBU9NVEkd355iwaZGag0KrV6m/lypRtbXHDFegbu4cNV+bBnP1yhFVb5S6GnMLg9X8ZNSN0GNpDOHwu4YQHpQO4R7svlYBpHqufaUAAXtJW8Df6ktpFvEzivjkhXlgFPVze3l7biq+38YGEO0TxXsZBDszNSFlIPrbfobF4ZciU1czti23Dw7j1yo39mTeqmLVzGEY0Db+1Z6wARRIyRcZO6dQBdPNo+yGEtmQZ5Cy40cLpg9vx6y9uaTY+hrduz7vx0bBft0vG1fEuJIBHVISfsKp7MTOZU5xJSUm+aBfsiF3EPatyliimLBKeHxazITqCiKtfTpny5I89xii6O73by3ylguEkYNxbH5Z4ZB+7hKjrKMVMKOSXfiSJEL6NWBGo0QUH5UINv43/We+hej4sOaAZA3UmBplcSd1rTuvPKRO6Az778NJluC9RlsD5zas9PE2+Fp1Ftk0pPo1OpNlEbx2lTTKWBVupz00556DNesYu/Og2Bgn9YonsFJ+2igj/ll8s1H78UO5EPgVM0316bhJfdeoV4SqN3CkUiT/zzybf8zec9yvknz40lAlkKnNnTnrxUR9gO7p480zGehVibdsLxIxTdaEFHMcw9jA4nnMJ/p9oRDWVEp7TuVM6H/CFaD/BtOqKn2hE9ZcqInjI6olz1afy3Q0Y0PM6I8qjD/+SmI7oDoz1R22mbjCjcVsqI8lc7EDi9OqKnuxFFPgwk8iFwqhtRJLkRBRyB6Wj64Derf8WpI+N6GuUo4/M8Y574lj2XVf+KHWg2F/DS767+FbtQzwMeA32n4J8tgZCfTCp+Ad8xPCkIc3cBQ16BS2EE64o/1laGTzm8TPCz4GdGvi7ZrWuK2vPPYOJzhhqOkZf3Ks9GZ7wXuio4oFpmta4t5tK4cc8xB6cQc3aLiFUz9/DI8tKpTBOaTiEtcnuzgWwycG5Islb5jL5j0ia/4vAZ1Sb9Zqk4+ADvjNpDWQs2Bvt+sP6h618Xs8sjarlLW7jOvLGOFcoJ+oZDSksFC/JGko8ieTAot5aDwZHCLYOkQeXf08/5Xjjl4rDeEbodumBG9FpxZywzzvbNO7sWgQmBpQ4sViHLFDiD1asYTZdUgPVhVAABawcGJwbIrHMiolp2RF/VBkikwho16KSWIhP2DUvKEYU4jjAWrUL9xFcRFEu6SG51SzbEhcobhs5fvroz9vBdJr7tMzFceTeaR74wmJId3KKxOS3GVbi/1dvB6Ssi3oeqMltlS+GXNn2dRd8iqLqBWAeneTturQfO3kgelujvrQGasu0AnEVqi7fhEefAK0LCX9qEsnTdEiiZsbsRn3y3G9EX3Y3oi+5G5MXtRnzZRsTqM8U2THYK4uk11ubhziweCa4uuKrdtI+1GKpjN+JZBUhPWmV2I77sRnizMFKHMvOmbDkgFrkmcSAcq8OX3YjerVEgym7El5YKDLEb0W/sbiTGbgSJlVN47P/3nxkAqAxppStHitCB3AWZxJjR8rUi21C5MeXKrA6SK1PBRSFKSUfHSj89/HJgdVi+XNUzm2+Mi9tByQby9uEw/aTHU37UThfV9BDdz/5OzyX7C8Y8eagxuLSmsJJI4ysaVQR4REjrX1fqjEQoVavE1F7DhRFvzbkpt06jvUoG/gOzGqjOhXMTE1pJHHG8nsHykKskTsQ/BS9UgMYJHIq/5VWT5ouO/8Vbp3zxYr0FaO8j6o7Td3uoJ+7tpOVE1vbu+7vPH71gx+9fuHffb2y8Lr5/aY8NnL/X7jHCp/VwzvS03kD8MoSlX4Zyyl+wd5D+Jx/7ygnruNbzqGKtDirKyN6mFBK2j3w1jv37YlYnqFiTxZHMIH2nFwRyaLXZOVug4577E3pRCMaVs7W6PTerj52b6dna1Dx6uJxH6qMB553GLgkFulnPPoU969hJ23/mu63AS8xfX0HZ1u5WvBHKBSwfX2HrfOizZnZlX7hRCnTadAnw6KApes3zppleFnMm/IC6qTW5DImSbNOFJKqUECGVEvZRawjxIHMKn5aNN8qhisWIelAXRWaqVYV5gW/7JITzRGK9oCrWi0bEehEkLSNivRBrCkblSOFU0qk+ItZLXFsotmK92Ir16lBkGRXrjS5ZVK/6K/oRpDvBXrgOKUpC8RSxXp3FehFwJZL9tuDPs5U1UMM+uK1XLSpv9D3R1vYKbxKA3wTAQQ7ERNkBLhkBXFqBQ90Crm4Bl+AuwnEBlwylbAe4BgUAV0r1KeBKHLgAJoKgqwnlpSZZaPm4K8MJXmpseBdNHOmMARGqjEyEYQez+e8VjLCpIIAs/B5IO79zAACz1zSBg8ILnIhC/NKjSCHeHuD8YnO+MQ+qrKDnxM2WLawyhfAqNng0mT6wYtE0pi80jI46GVGHT9OYvlCLoUiZPr3QO43pC8aZPrHaa8q+sgjB9KEWDgRTmT5lP/NgCtMXTDJ9YV5lsKxjkUkuKxjhsoITYcYdjyJm3Bh4waSdVmtaN/urQ1N2V25r6rZvkdu+RZPbN5cuqZgID6sKMH0d1f24F9kVztzv7DP6Cl4jMvZKlWVSq/lwN7gmNwD243e3WH2UiLPws2dtf//aa9YMiYq0nJrcqse+DnwjRdIgxEW6r4vQPoF4bcq+zudW/4X6zxIqJtlBGbh51X3diJnYj3t+eBwVJSccx4Jm1GPyaFJzKa5KvesumBxXc0l83CWGuzq+dpO41KlDcwnMlZVsDylW52tj7NUzGI+NszLjukydoqjizxtfNeqfDBJaSfSdJ5eqj7KWfAYNGyh1YQeiB0HkAz6vBXxKQBVsP6nBBl3VZqyPdqofKwqBN76QNGig6M2saQdq8m1NyQe6q2WgyodRTifN/teYL5b/re9ba1YbiLH4LxBXVZxZ1b5+AtjB9OQrH0fnwJlzrAACiQKIL/ls5FpQQE8XAvyEfFwDBJGdVeBEKoLCFKxJtK75/Dorqib8pzMJVwkr/FIEDoBDuivLg0pdMhPqUlcoRctZQ93UFSJfhLqUvwgxKafXRQEIL5iOmAJTpTIdgX4bgekIhOnA5FY2Y6QtIX5iaUsdVStqxNoWvVgerkl0inZQHWR+Wmt4FSgELMQB1Dq5ci974LV1DamcEKeHPLGVY8+IQiNpUgveKlYiXwYl+yy+khGRvCIO+mvFAv0YmfXAP5RX8QUEe8/8gDhKpkUnlZeilBnpLEvFT1P/UzV1iMHo8OF/YNRDcVBvQ0k80W1TPmdVAyh0BrnTvWbuYi5m90kfPZIi+FGRbOneH4/QuPiQpiXpS7C3coZ3jNFvba0au9lf8RHn7+dkZBXa0fc6qe4X1Xrw06imuzhZzhBxDcYF98ux7TJ700I/Btakz5GRIE8MluMhFSOs8oZC3Ztrl6UFHI9wwFGoB/UmQtPBKXqSTSAz2sv0OwHpzAKa/IrPJq0JBUhIPe5Yly+BRPUNdQvTr6RxzKpyajuuXP4H3ohANbvpUFlNi6ekT9L4VT1gLkQrR4bhAKvpOETkL9VHu5gm7mdi8B3MiwWreKmo80k2YjIA0ijqwqJiAouKuQ9hubHHuVPRaJVCVVYKpzuq5zU2JDwv0s+eTgEelxtJkHUMAi1IdaGuqsSqkmf8MUrLcwOuy+XiNJcADSQ9Q1f3Ibik4eOxmgvt9pAnRB5T5N8DbpKh8KFdd56/S+aVU1LNm4hAVdLIaylAF18wIUJPnW6s2ohUv3PShiJW1gFmOJJAgU++PXCui6II+vGiHF0FVQL9ZC84P0AB5taz+MHd+168oQcBzuMtWCjp+9n96tQHs6Dw9b6rFIifF8il4ASMxVkMUFnO78N32T9hUSna6sOxLZU6Ybevs1qpmy1ZDTNqxaYZ7eyLqBxmG0arFBOmB7KvqulMGWgldguyCuAeV4S7uu5K8pBStl/qTiKgw+nAmndgeDi1/KMOi9Cqp+c1tSp92KPAjYwvI4PRfl5Rh4HUC4KbOQNXzD+HvbXsSyr6IU445GkJBz1NU/X67Mua40wuOW9RwCEuwtWAJthK6uQf2F+wJnQ21MunRXMI5eUAN5Jv5eBuo2azB26mlZ6gvbCtvgtCNgnthiJpoKA9z79Z0tWW8E2emBztommJ7cFX0L6J9hT+xnrenDT+hTZe3ROngZxhVtVbqtvnpqIuNdePOLjrbfOZvGW9W+AaRmawnFMxsWapNXz3HvQnMi37B4WcDI/xm/p0nQ4Ll6oWqE67WGfInJBgmEzTZboLHNQGKkaKlXu4RdRpo3e33DFVjcdAF8w11Uv3MeA6EIIXdWmXs+TaQvunpvnSXGlEUTMndcD+2N75CUQrWEZPv/tH09ekEvdPJq6tExbERr2VmsF10a/XaKbppTw9XcTEKxfnWvbniE+3TYvFcq529XZjezgpwsUOCcqm2d8eGvOW+gbwJVM8x5OHgVBnbfYyha4ZewosUrriXUSBO6TU5LMqyburyVLm6pr1JqqgQKRsS9E4hYLvGsflVPr2frCzE4eJzokLpE95aFwKtIAdyh0aInt2TTlddP/aNez19cOAQryH1nQdUot6LrIa9536yAxFf63vqw9WPZjQnQaEzbhXGambQPu8tGfc2Pmjbuy8tufc2NlSUqUILV2llBr4ifgUx7VQzKvs67pTx1aJQad+7WAHzPShBiy1PllGjQd/PBxxfhdZ8OkWgNuOgLo7iJUZq4OEf5dJqMMpRsIRRePpiJKVLVGXKfC8ZX0L5U31w2W8CjUptq6AU7BjiNG7vfqp7PZj4FkDjfBxmkchFOHTtf1m8x1Tur8wBrJj9WIU2+LHyuaH5tSCUy7YclUxrLl71pdeIvBDF/AOCNYrFWsnMKqomtOeqZ0MpDFap1VnRNXIcmmlM8ZeDe5uo86m1hkaDxCeVBwjEn0x+rmpLpiMe9YlpaAgGhAD45oojeqlI8q4dETpkX5b8VBa12E0/REJduy8eihfbNuPm8wpNx7ly3YcoMhehi04jkmNP0n1smYJinMkeXsUiBGLyZmpO47suD4EffRcj8fF2LHyf4pNIFhq/ypwrmvUza2vUzXQD32+53BhLcQr+e7SRAMUMnDeV8ET6uyKqSEOg013g+wB9EUHIpMtifgi9tUWNQMOqpzZV500qsUprQMM2UIaEGs/+KsuPBg31c9wKLat2QNI6SvGx6g0kIorfjN6X4GXc+1vTFpARyrtv/Xjb/k4O7ZBtxompYVtcAPNR4P6b0EOavX5cQajQUfp6j+jmcqpcHXVenTDAnCA39M2J8Cu5zxXVBga1lVJA8cnpc9JMaFBAs22lFnECKMzYnQ4MN4oW5QoxBsCZbwl+oAviX8xWNQmfK27bsBPwTQVjDqjcKarOhjipz17UPHOSrhUax3QgwjwISRW6Z44/XQWt6/Lfd37iMD1liIsE34YCwM7u3nK1+2/2g02/E9fr31/ySM9cJ0qZeAoUFnpim958V/3/pMpg1ubixfiyH1e4cM4PZJ6UMFogdZe2Ndr/792bfRzCsvvcMIsEIgslxZy1E+YqFs1yhf5qdqpgQ2z9BW+519r4ePfMh060xtSs+8Pfl0OjLXEjgJK/SqNNDXYHEybF4ZSjgeNkbHA+q4HCvgUZZj+BwYkpuMGUIGBCuDw7npiDVmy9JX/Sk3re2pOFC7GGp/lTLgdPMrvl4u+P3m4wuIu4vnk21cKzfnHboT5dgt+dg8usO9d/Ozh9z3ldT1stWCrTYtA+iV5hMdeazv3klFDcnunbbxRpRWiWy9GYJziiuJPo68WPVIQLbnGk8JbJetBtNXPFopG/7RplT5qC8tuomNqcp7yGelW3sFjV55VC/DHC3BFSm75UmEhZUm5BlYZdY5cgJ7DlDqH9hqXj0Le1AODUi+90pJSqDVozW1m7HoGPYjEtRZWCF52cTeGWupPkpq6Ks1W9BGoycQ/n3MxuETX4uKkzO+UAmaJv05A6mdhoq8FsFGka8cc5CqoQKwZdoCGkIZQZ1h0RExMHbEtpeoDFjYCNQObWG4j6td5pkCOLTZlDAqiGS7OQnzGIhbgtYtaWHJaxgqO4oEO81rp1iZQ9Xqh9gsIt4RsltlahRXltsD5Ioo52e9Qe2GgPqj33fliSvM4T+EiQmoJkxKoT3tRuKW6/C5CmzxFa1JFTjcUpkY7Fk9D49xYmQWC56TdMdz4KLu1Zq3OPaooUnVq/bUTOLXe3C76K05kF/1szxv9tKafmkMlD7lrNve/mhfvG151/A7/ZHDynvvBWk147kdc6Dz38/zq86Dj0LR1Nb+tncCP/yeYFfKMH3/wSM6P/8eRQqHySs6P/42vcn78N6vzYXn177/guVzA2qPv2//lr5rm2x91KTKNufd/JeIeofPun3zVuPPu7gHnvBsvY867905z3l3wZ1czRq89Ag/ep1e28zJhrP/F/8aj2n/yj/a97LB0Or3J9xon58q9wH7duXIPK67cnSN3b9yRO0Q0D+r+SuweQ45xO6qAwiTOMWNLGshVFnFl+025wk2HuvGMKDTcNI5IVQTC5aOcqg6wMs4esCLRR4iHpGUfeaXz2R5M+Gz/KFJr6atjdpjovdRdqK/s8nWq91+6NuPDCXZ53VO2Vlo/mtHyhclSIYrO3BExCBnyFbhTbluGnoNoGdU4m6nG+8+n0KvOx4vcHTLsrcwnljPgaa+ryh4BmYxTHJW+qYNmadV51VJseyFaNwtVjLIaYy1vlF+pZ3aNUOqeUuwqQftRgqsFEkKmMKkRjXsEn1P8Y9uqTeTI4FJjDD6AL+Ym8MABFL2jppq6L1JImpIJ8RR/gl6gOdJdFr4GKQztqzerWPxt4tOWmJtLeP8+Uoa2vrXGWSDyj0B2WMQP2yARtdVKgezoZEdvJEqtEoR1wKXJaIx2qwhkoompws8DZBLpD0NCwGqlaj7FaHBsbnYrdBo5ABWMlIWecUNr1YaSNjQxNCCG2o5tKHoECXiLUkqyg7IwRXKLAgm7SwlFegySzU18Cnc2cylsHeXKnlM/1AuQY86EwzFnwpFzVMyfasEBxsiXr9WFsFAH35AFRFiyoJPceQ++/lVTvQcfAc2z/mkDyIRCoY8IiR955582NvMgIkwstQhdd+5gYxhuT1Sril88084GCBTemgarmzpB6goQlSrqx0LUCARPfNCG1gctJJ37gaCoUzUrTIeBqs4HbTpSaX1KpYmpdK3i+BaV7i+kU0CYMT+zwVr6ZjBEenU1MFsdjFpYGqz3LcyRlId29D1NRWaQZ7wJz2Sour9ftUlQDNh4v7KwR0Cd6sIut7OVoEbGjIAUaWvykRZALlE/uRUM/odDt4J5lRXMq6xhwfgaBhS838gIQxUOHZIlPkINAcXO0bgwfGhlhHpd5TEXrH0PtO+xEaDqGidSaRX/aCjBGax+C9U1hUOEBaCFSpBPHiEekpa96lVuYatPLGyv/gb4mddO8DOtKj/TmuBndpf8TJi9Dh+fiH/5/mmHJxWWV3XbsdbDPlx50PETKJsCK6bX+h0fN8oXPeLuv2ai++ELXPfxMtb9J05j5/iAf/8j4OQKAYPiKy+I2cGXSbQ0QjUiNIvy7tUsMkya5fjwTU4avop4Dr4Pc5elDVWB7GhDu7ah74zdZKaS7YIPEp6bcqh0uVw26l+BBVPckzf0ZoH9r/Q03pyJ41gs1WBJ9Hh111njcR914qiHdJ1ZNb0wphpgXQmFHFqAZas1inSJ/ymGB/cwQrJ1+m2pliKAngyAYqm/bw0hrhUpSmVrUi/52et1RxKW8dzlMvGnkdgKRtOYFS0z3IQMymQ2+8t6umTZCt0j/4wrAq8/6z6I+xhRw2DgIRl+Ttvjp6RuYBhjlW1EDdcDtUik0mXTtWUBoNikpBpNiM7kOMdFN6EW4F5HYRiUMAwMDAMLQw0hTnnNWqUJqel10VQ10nKUa+Uo17h9GONpg6vjPjnGbbXAl8cgBgZ+NyNB+DXgk8bdgjiY69ufizasXrKJhClTCMec61bk0lMBAIXR10YKD5F7sB0QMODxxPkYhkm/BQupWzX5NlfqJE1wUoMf4bW67+kGnNtgj4I0FPG4KQMjRts6qazJZ9ckj4aQBwUHyKVmpNTemq/PS8HUB+nvhX6d1aesxbyq/Fa1gawynhiCU64jhqpNKJDHivZ0hBHPhxmXIAy/dHKM1tCDnqY5R/2Lirj2wzU3KiE1tPSmFuxrvZEWHWupHpcK1xublSMnh8C9XBjFcvX2KcUT5WklaL3rnGl/pel97/iV1EwltYpEyEMlison3ZnNQQJ8cbVMdAUNRE3HacjJt+L4va0dD6SpGvIz6NJI7/d9H6jkvBZGI1rxoSMSgUzaPRLCpD0XIahERII4WJfPkrBi2y6EWX1OlOQvFu9R+Nnp2qmty+uYXE5OR3U8MQG0slhr8rUmj0vEAxUGWqFubVDhZvV4Ws8oPMp6Aq0n1Ho8raem9WC6aC2YLMero6Z1jA1sXWEeOc+L6acDB3E9fImrEAeN1TXHuBnEsCOE6vdRjHaKNwIzwS+ScCiTeg/C3A2hb39UW8MFYfk91zVUQK03gkLbUMwlPLHH0erqWlegdfkATWxHGVXqKEeocvOafK1pdHjLmkKtKdKafK3J05p0eLUmHd7j1+RpTaMDXNYUGBBqTZ7WVNOaMMBaDwb4+LXUtJaxIU50iOOKzP5jlY3Q7km9HlU7DTWMccx1SskiVyeuQs092fP+RA+6JbSAtVRCCdBRQmj3ToTUvmnAmUQhi6qjTo1yja9j+2P1+hMxNWj7A/om2+2k5YvquNYRSwUAJKEeWdtXJYS1vSuhq2UdD/mZw9zWY9akBWhNuWikUqVYnUwpUfNcCr06IuvUYOg2FDhW4cfZ2ft134tOFqo1NCNS4MYK3LoBamiUKEqg1kqg1kqg1kqg1o4L1LAEaqSSIk6XhlQQPtYi6w6GZVWrZVVdrWpBW17bHICIcoATTgkHp7DZshngfiHwI0NxFHThGOgqvHrU91Xp66W4Yy76QcIAUpy9AW2wzgCu01q8PFaBlAJdJBroEOYiPtZ1i/BQ2CKksC0dMIo+ha7jaIlcftLzVAfpWKZeA9PUQhbcp3kGMOao7UuVs4vJt+5xtEe6Q/HRopLbJZVjagHZbfi8qIvylz3QVu6gPkJVwtMDOt+GdimnXBduEoOsYMx+XtviS6VownfldTEoBYNPKnOCNCx04j0/fWc0Db8pKNuLcGBocFfC4fNBgxcUrTJ+YHOl6Kabq50SwtTUzipa6WaBHDOnKjtCFOICzgAhNMZhZUCmrtFqMKborcHs/rWoSidxPLWOp0qfUbIaYqzpdJxeel2mppa8oJ0wEEa1mxYvkl2Ikqolnxx4Cm+zkicLrpvRyBBp9kp1t9+EvnMXcRLKOO7R7uij3D003igvA5ORXUmoW+VS8hzNqVAWqqfXjyBtdR9SIm2oK1zI2KorHCYheCMsPl2hfaFZ2RYklHEoU8ZX6EWJW3V+C4WcoCuqRFDtihSqPpbxAfdCqvIFLF0JvcDU4qOf/mQ9x6ngqXoKIp5Vocv4qJYM8PtaclHnd1lQzdUVAMUiHXIo0mmoZkiRIp2GDNKFtBl4i+RhNU9x7lHtLRoPpDPdTMtFBA+HdpBla/8s9gFFoRnpKGf6lTAIeHlzhkdrzvCoB1ZnUiQ1E0eRCqTKWZOUsya0syZSTgEOkPHQ7Y+EdPsT9HcqT7C77JkuLnoKGVWE0TGerXATwVNwHMGTfyLBkzeSoYjKYiVvUa+wmXpEi2MS1YpSeqa9rEv3EgmFBgqR9jwqex4hCfuLaX2XUspZ36gymWa/RGtVPrN/hR4GRspq+lpFIpClwFYNDD5LQgugbRLKQNtKVhMbMrQDbRpjNTlWbyM76qUKVf1E1nkZiqep1iL4zrxBdazQwkmB3Cg3BTRKRfPfXWb4ldBLJgkf+AnlN3zloGAnFa+B3Pfke2vQ/7WeQPzvFkEKGgLZtbqnVtZeGSMdCckS2yxksuhks9x/DKYFPGpYmWk9HH268mMtPy7LjyvlB5plCpeGxX6ybD07GSXyDSXyTR14LbKsPa1Mh/olTD7rotcCkKg9HFidUZCcRH9dkxNL15ShRsgy1LGlP4SfhRIqcVqpItAqgrKKoKyioQU2leiFqKgOW0t5fWrByuSkjlilVTL1F55DGCoplOKJ/1xYvNJ7gQ5RQEOkicB4WdYc5gCn6nrn3s6SbjlLFnQeZRKxCyckEtqpE1wmIvaWoWBN0N9esgWh6UnRhKcoKE1zIMFcSsrRS+SGuB6SBs66QpK+yZ/GCujQork6ZGZWWNDXStAnCJUIaVmZsGRlQsfKTGAjQD/Jc8SKjnVVt6egcJ2IIBQMSY28aoNOgAux4kK9ggtJ7k3FA3VaNh0N5LJyeZAEGa/VdKGaWgXwnWKO547xVTgEMOHidVC5eK22O/S6rz2bz/0A6So11vut6AzW62yoCnv6MXJo6b68okI+E5Z7B9WL13jB9bHRi9cX4zrwF+zFa74Kam9xBcgQioUFaVP2Jj3/rxz/T1y7Xn/Vw752/X/exefbQx/2ricVHN0o9/0X8njqVZhrpMf8KhY3sz/GFdHsT/ALBRSe0Hqy+0mJQc7dIzGQWl40EuPp2D1rk6PXS8Tnm36gThVV6leNqcsLdIn0zkP2NucPNCwSo5eAquqqDBEpUoZ46HfgPEBXqxYCB+5uZpGKu1RKb8fTo4bJp6kSh+nNCfxABWaDgUdoPQliVK1rDsWFhqgQ1PVcrv+x2prA5y5+lrYh3dXLBq5ebnBT7G1LOWK2lykpVX17baeNVquotjLvBdYMbV1QrXTfFJcXBjWmaqJG70jeM+2O5EQsZp6e587oCXl2h57Efdzz/Gl3JrXXosCB3Fq7BxiMx+poXqS6QTUVzvru4qMm764knzuZvLOSvKuaLFV2p7Wj5SIf0MjqtRcU5vr862ekc7DyJJx/+OKA/1rXBS+2HS8CYQ0P8gX4vdeUi62qt/SNUwiLy0VivO8gtYmoFhK5H/3a2bX73n7DoZooofXFEdU98j51/oTHNA3Gf+QzNSqQtxRF23r/up88H4a+cd+3FmBFl694jqmNRo5ogRHrGqMEMZuPR4uRtcio9fx8lqTBczAAI9/Cs4votW/ki1pHHsOGf9/6dWsjHecZs8/H/blITPodhUk/JFxEEjGkRfgV5Q8jQofFT2FN/IsuqTPFBaZN6l11njIxyzMPzjo86OVdmkOHtvCDO7xCC5Ae9riA1cAo3eFedIRHt6h951Trz1vzbbQVRt1zErEbKEwHy3gilBg+XFf5Ad4op0jVxPIIqd+bF3hcku+YUixxkcRFU75VgLEiXnmoUGWJJcoP0NzVAMvsmvG0A2vopG9gcTXuFOnGkipebqed8N7DbaVTENiKBpNGEm3TyG2p0czkSregHxWL8gFM17NTnmInbee8RByGlWlOQMwXEXM/Ykiz8kthEzRrJln1Y81aowC+5jiCn9TjyfQggj2G2nU/WsT8/gDeFwjBr3BQxDE1dQwL37qq/CmuHyPqUiymrHdyr1o33PV7z939X++92D4ZIBbSe77DPtHGU8ro37JPaTqi9+I+/wftE0VwUyXlipUfetex99unS/nRq4NzXr1l/b32qSkF6T9+44K/xDn1P3xx7cf/6D9f+GefeZJ9SkM/f9uZr/7sZ/7zB+wT4EL8S772ju//q62/+2T7tPEf/6EPbRl4Z3zQPm38Lz6Qzc7OXn+xfdr4S78P/377g/ap8dpS9E+Xrg/aJ9ImvE1Jj2m8Ox/bc+gDn/vnO95vn/Lph9/xrve/8e/yJ9unbcbbv+e2g8986es/YJ82/vDiH3A3/vnJ9mnj/7//8KGlAx/6jx+0Txv/dOnGL1xsn64722H63DMTyyvn7UPfPc3Q/UOf8IptD31PceqURDbND1Tm0nwTZZ+c/bsJ3z70PagUkifgIk9hQmFEpxHJp7T1oT/0aDy30c6IjfJyPxMquoqVedU60u0gR4eyvs8Z+RFjoXbENFZJHPjhXXhkxelipQfzOD8DEz2Bdu6Zul6chQ8/JR+erbQXpfcowKPNX83gS+7F2fkZFHOeXVhbzlEdcKMldBbo6mOwJZlhw1v5bjqbZugxB7AbZxrbwStPymKe49byjF/j/sGAgy2evo/lgh9HZ+SPpzPhOt2sFG04oF7mn0K9h4E49BAHZrKM0aMStQZsXJqKG4FOXlCW76AW0/PHMTF/PKh4/6V5ToU4i4hoS75EK/ksrUptkLmpG7WdNFuGT6GlMkwUlWEmLDSLEKNTTZ5bgVvbKJKXU2lJnqch8lzrh0zPY9mJAWKfQF0iBM4rk2mebdCXeb5o3DMgAFLMhWKdyrhQnl9MtZEAlOpyYBI98YWU35XPDnvcQkwArWuOa0c5XAGiUYJEuyY8gc5DBfo1yce0jc5F3DaJG3CLqiVyqmTq0qlTS4RjCe0Uvt7NfZJuEOJI4u7k6kZKJEIm/rDrSnSeTeTQcAmPJZrFY9bOmxwChlznBBXCSxS0Q547aIs8t9CKPFdoVZ6r1s/AjJlfNC/zC4+MWni06HF4PI4eT7vXGFeX+/xYpsfiu8fSY75TRetGSHtO/yV8pcOr+Wk5M/x/rzPj2zPj2zMjSDERgufl5+NxKZYJYDmXcAaHEty8yVsIYyp0UNbZXNP5B1AczwgJPZbRdw9PiMfwhNj9yCcEjU+Ix+Q5T4aCJ8IOnhBb6LHc991mUsxRnsdTJsY82PBNJkZUmRjzynwztkRmUsxWJoUd0HmDBkSKzyZep5hFbmC2IPRbnv6s+3783Z+/2D6L7eAit/L3yqaIjME+i3M5UbBLSlY8BLpqbHdyfhAJOhJKLacY2bmC2LJ5YGR0riDa4aH2ZqtDaipIaz5FStRpMorU8MJDk0itiHtc3J7HYx4eozChFLdzwd38EeL4Y7Bnewy1KANWPh5vj2ccz4CXj8XbY2k33nYzqhNQfQ8+30PnyyIAVIc89nHgi4DceVbB7BXB7Mcd4FoZ+1qMzwuMz8uMz1uCvQYtaQsjbZKTPGviZH8HLXAfV7B/5G4t5wXQE51n4MwxZHIGS5EvgdWsoGVcpdcUGxSMFAUdljnqWxlAKkmpDp0lvdUx42ikYtt4smOGUZo1ozQv0MfQ4Tk3OWoA6w47KguA/AKtUCYjhzfmh/G2zOOaYVhb+IDJkX5wJp1F5zyv4B9suV+6pj53z6RzaOZAPoN9I0M+pl1gs9mZEj6iM0om+mm5kV0UcH2n3noRCjnUkhDMszyOn9EL4LqXx5expInVvocwRA84wGwdMAUWy/lC1bkvfEn1MNpn0A7uLSfBQdkcJxc0LztYFRugRCZk2NHaYaWa8AhFzhF7eWwRgQ9q8k460rmcHyFGxhzPrbpK1cxanMtTFtJzdUd+NQUYdt0oKTnCR+plKqCuXaKx/IKeaBLOYEFTZAu/2xZhd/ic223uuwaLMNs3XZ5BJcTJVYC1UT8mGa85FSLhBFvAEdYcAyGY5qJoSZGQsIc6qPdHLaKpd3vqWQWrFMOwjGFoi2Stw0ORcb5WnvOSUPB828HLwxYVNYiPXVrh+nnVm2LMr9Z7aIE7uANZVgXCJJIdimUt0vV9FS3WpUGkPxSL5YhF/tQSXpbLUJu4Ui7RlrRNvpWxPJUWb+Xcp5ncgL7dP0Y0BwLcJVSFiWy38vAFpvwKPlNQVz/LzSq02ci4nAVyngsCUUbO06xMZjx4LuORU4HHCP29DhPVmrlSk8U1na8rfZnZC3gwLWYikcf88OEzPJYLjeYAapgkbRacRtf5L/ZEYBrY44j7u/tHJKUFzrWM5J58liHJSVmsZlLzujHxq24m1SiJ3rdtqFS1CSGl3i4WAaDaEKghMyWgCTAKqrYPIPGsKbdtEUrqblEDwvYDTCUgPk0x80PyIZycwQPMlL8hDg5nKZXpP4c2MmAAnMt6HDqqNJnt1s2jbJqFh+5iQb0y7s4X8diZN1QxCXKwDFY8QkhJqSGH1DwKEA8alFuipenevHWaqk7hNKfj6sZykcyisjQtB/kySZZpiRGDHzXxOM6vEsFLQE26pyJE+NsnbuUy6sVrzb2i4VD+mLeu37ro3BRJzJKhFXhebp57zXO3ngt3KVODW2LFFpAL4IkckJj0Nc74ifgJD+Ug57Ig9+RCSDtfRIOkzQ1Ae3Wt2Ar6w31czGs6GqrWUQexEHJF3H8jjjXQFi2P3CpgOg+6gAyXWJMSl4m/lNxbaUlGGIlSYA9gXtHJCVdzSg8k7yJm0qIaTGsoHMHAdxkh1jaKbbfm29ER28gGzfwod0NKrTpspb7nemNaQRSI3XBGqufDIk5OMs5yMMEBaIqiF2qSzU0X6uK3gPB5G81Q45oe0ZBq1qaONlR98kF4y0swGruWd0lVrtr9g3IIMSdkhCkNyErB8+ZSi05de0j9+zxoxzHRP2mLP6ra4o9dsK62+I9vZ39zW/zOGxJ5chE4VkdHpeufZO/QhLrsUnhQRJN2+T+NvnjXTrl0idOdB0ZPd/wvuBMcTRKL/l/Rw5waThoC7X2oPoeTPr6wp+vBZbCtoYd7b1dz9+SVqxy4I8md/bJexcXg3eUVkfPkIidmuCyC/g5xE+7W4dhnVfMoWnn6t0mQwZz2dZVrPGG1l4d+ebSXD7peapL08kYEU/3ijtEvgoG8Tz/1Oow0KU0/S80tc/JgggWtKMeodGS/a+/gwQD+JdSDOxhb1jm/BgaXQeHEG26z78n60VJ9InOMjNZk1Oq3IAVC1cK8+FibRNNQAY9zZknMI1WV2PdjN1289teP+X2CRx5c7/OsSUuedtSUdSgVeWxAUdXwmBjpFYDBHuDzsy+rwW6MykFUgIAkF7GYg4qzt4JWogpM/LhMJ/H0jKWzJULtlvhTWLeDf9QG1JB/Tw66WyBCLXvC3TBu3pSme5yQWrqRUoTI0qMIycV5Bm1bUYrWdFlO8hk8FuRMMaN6PguOGrJwLHgAMYichuYo4+IZ0BaU81ONny/IihESnrvNk8wTNzpfdA2T0Vl1aadniqJQne3XKG7rHPEftzWBzwPwQot8gi/E0Dghx9kZPDVRjIW4pQvoggw3ei98rV0jFgAmoZqpUE3N7ZYMu6fSY1ZlOqgmCEjJM1S/BbVE8j32RwFlwoA0CeKjJfxd2tsPTpgibqp2CgcVaA+l5TKw4Oig1/fKhipk1OZGXF0GPPEXI7JLDnCfW8oP1UjMrjUotevBMjowx+O/JCV64suRInHL4XwCKZ9o9nXSsab2CUqi5DF50bXDmioza8csrinMUoa4jNq68IXuBhtMUvhO2XbExDKO+tUJu77t1rezrAEvjrpI0TDQlEwsd10EJSuETvd3Mk3VEFsN75ape8oQETz8itMfJbTvAFVUDaaL1OrA0bKpr3s0zYlBIMZhL/uN0ngYTk1zr7Qq9t4yIfcqVhDINufXvNB7qcekunSjaBxCnA4/S/iwi6Ywwia5OnQrYvwIeV4VneIURmRE/Z8fAUwpC0UnBcCqZuPyCHG+fme849dYF1D96B8VO16y871PdJNIHMTLwm6icD/Zz35VVpyjflBHo196UsY9+PvnWuseP/dPn4P9veydavRi3MiH5hXdWGfo42f5Gwr6f/Av7wqdmY93oYAiQF2R+BgGAHSnnlDMOu/QA1JAMJ3ECsGzWbdbCgP5ioA+Elot43aK+iwykT5W8UBkBHjFFXgFFClw5E5j9ms62tqlIHt3xeyHmr/a3PzFf3sk5i9+fdz8BTemav4Db2MGMJ7L6K94q4ycwXtBLTH/07/5pc/VD4NsA+Wb+TDNBIwa6aJwExMwo9ZG3nMy1kbUDoViiTNDoR0zdii+5IW+4N4Uz12VWwOqOwt8wFoBfKirESWgEtRdgRvGnH0X/Le6JIj1WlV/FXdRRLmqoeqx1gx3QhESG9aSjxbT0LwBECSqIgjQIzdoUhgnWHrdhUsB3MKKxpNk8jTTiIesHzhpIyHveqmU6rtSAx7RteI4lkJeIsyLDB460zKTUSJAdluI8zWHb3LgbUHyB13NvyARIDRdE8driXgG1by+ycuwFALYP6amA/8EWtAnR0bud2Tk9cMPC4K8b5SM+CqHqDt6go+UniQgAEJPfoo/ZrAc+qmh0pN69v4Rm0GGnEeqA2MM/2QfcJMbrx+sTG7/mzG5j05M7vurkxtvD39yH+bJLR8G2Ycezcn9mw9jcuvYVSf3/eXkvpzLrE7i0Fw3DXVMdERyfsezCO18Qvuz35IcKM1NovSJPHPcREGpgG/pCJkBslb45lPfzRF0N/0uz9vEb8TC2ojKpkYm4zPPP8kJHJ70BJ5uSqnax9D2MTlhH1FM+q6QzSlGpcCvVrlmign7HH7gNTs/uEJjnkWKTwWu60tYtaov13BCITY9uFrydIG5Oo1Tzzj7pAi41FBiAK1P4ul6AB5fyg3yVKvOu6AeH1IEpoDZ0QM4nkwOPC9vWEqBnRtEHvi7rIebwdj/1fETHVjbEHY8gPIzPClRk0L4W2gQ/8l28zpJuOp5B/B4uljNOZC9TeFPiV7Mlmsf4o0z0243N9bV4U2qLnBSlHtgQ4wTi1RAZ4f0jvyKs1dmTLN/lG2juN1JilYlEUKO9pFhMYOadhcd6tDMlT1UhA1nG8bGu5w4MxwOixby7CraHN1CHm4FlHelBoZF3cAGj640Dtw+B5oH+l52l2BESA3MJM1oJD8CKfRWxuVrmKgUODMh38aa42EN5AHfNKz5vVf9W2PNQy87OaxR4lXFmkvsst6PD+Apn68ewE7KWjrBWMVUz34f3eykE/F/gPj0E4HvOfsFB9l6Yd3ePyYW+N0TUn2KWALc/32hACKPyNd1rg5mrdbfgP1jfrnLX0ONDIRIkrIN9KLwYLFStKO97D2IAf7171dLVQjeE0KLG7vXuqrz18UMSNcmgqSjPPLQGcAYa8cxu4ch9fAl4kS5gsWauriMhfY9GPI9D2REfP+1/pqkafzR6238wZF4dTNUU8lYDZcwuedq6oM81e7fhfboKGnsRdMid7vID5WRO6dFdqd93poSWcZoI+s8fhZBXhu5ZfIwfPHYq2T46rUeP5lkHMQzho+6BHA6hNeQZZV4Grt+ASYmcKuIeWqq/Itb8iIUAJYGyZzCUS9AIf1gjU+Fz/OvRkX9gL0HHtCcjKdyBew5lPQ/hflB8QG99GIpyKo6W9p9gCKRDcViMS/31A+vFb4hTQ10YttAnjROGEydWdZGKgzfovUe1yql68SSfnULT7/yeoUHq1CyPfleSkAbn04J3KdJ8fxpQypF+aCq2edAkDT/JZIf2qzq24C8ykQsAmlNkP2NfrDLvzoHVBsYMm4EkDjhL++uiYWcRAuBKCbR+iHlQfALCO6W4H0IniXBGz0IdST4IGJJggcRu4qg+gvrSvABBBck+FpkyCR4CMEEQVAVw4oewFzDRcWPYJK4VoUaq4uXNnAytlHGKH4mjHcWG78UTsdGh3bTsXIUG+MKNkYWGz3FRoy4YmPksJHxENij43UAmRwCehRNRUAeN1Hd9xzOhSKyLHEuMDjHIFOcixTnAuBcYG4qTeKcWY+CXhEcF+c8xbkQ5Z8A5wIKqjjnSWu8Ks4F39o4F1Rw7qOPMs491isFgUAC4wVSnUIH2R+axV8phG5wjv/FH0354k/OCbax45ewXD99Yd/c4dDG2OHQ29xxzoY7HHpX5XDorrEv3ue+uMt98eHyLCjR28368d1jH3/EfXy3+/hjCKoVI5xdxGVI1Q5U24D0giEwCyHlYBCSWtXLB0IZQu3yYtcMQjsN43UW8LljVJR8YyEZcbPPK+Zo9sB+nIzMq1vHhefli4LMenFofn++jNfdKLSL0C6EtojECUu8qNhBk0k2exltoYjmn1/0qEcLz+PHwoH9B4pV1M0xi/uZmyx6/LYfW/FZ6uISz37qQPkArp4R26MVWoZUI1+h2X4IOb2Ph0+RSkpEhK84IT7f8614nJtvw4Py7Xr4Q32Burp9WFnL/k7yN2gexCLvCY86hzBUStocpIQWD6xRC05O8gVa7oeXQgUPtr9F5wulFbMISsFwA40uRHJFa1ZOZzBYPJXQiwhNjjhdvVIaBRbq4XR6hhb4yBo10Govb/UFt+Rjrlr9rooMBR5iinz05HQ7cjF5xWA9j4vuQ/Cw77Yfqx266N7zX5oX/BnpKTMS0FopPZ9zfWi4PiyrGXIwh9gtYOjR+1WxbZpvmWQ58x0MkY7RCOjzTBMus0Nb8CdeF/KMm9CgZUCnS5ma4lgQizLLtABMW1nTnq4V7MnHz/KdhCerIOoBkliw6pG/hkja8dDnvXyHnhqxPicczQGs6oDRl2bkkTsaU20OHzXgElzDhxrbKQ991nvoXncyVszSrGQ+lXZWk1QVSD3m6q0aq/e5qOM3h/7YJkZSOUFdEd1g3jgjblnFBMSqFkcoziiYdXCPvUPi6MgdnRXmFmNAO1TPBbzXNQyi57O/ivcW0JIqKL+ylxcjc0BdCOUpEp8N5OD5+rS2R9swRZfVS2k+J6gicEtVu1BwqFgFFvnPy7covvSE5jBTqWt3vmhuho5Rsk85Snafo2T3Ipg6ZPON4sHYx19wH2uSKh4oGdwiqk7mLP9Xxs7y3YeapGf5CKZ9aRJOKY3L4r5UI72mjokzztqLFUBpBVgKi5xMBA4Y/ETbpSBobkMDiHrYxM1zYBEEASOZ5D4tmJnuG0ciPqwx+W62rwC5eobhQGRiUWhFT7QfLImSUCSd6HhVh1XqLTdCc5BTMc0HdksHQLF7oNjcKrn9WBuljVJSMSv1a8nCpPVBf1AmQAM63gF18EBmMdyz2sO6AwJOpjO8HgSMi0bZniIZoxjzPHD/Ay4kpqte7TCqV3hebp4Wz7GPz/CndGOL0A3xbdbEXdJFQzcWKRmnG5HQjVMJT+i7KhUQ/+nL+WyFGsxaIrBjZKZrckY76NQyNlOdu56QlTquRPCA9hwNsOpRXdoCQENDfa/OeQnvNnO+ow2kOUcHJKz0IcP0z6hjvI1UhsTBHvSz0++wXyUzTFCtcmMx78ZicWwsajoWiRDbOv4Usuo5fl6o2LQxyk+FmD6jBSyFi3nEQPSJkXF6Xi79VPIFqjtphaIRYq7g5KHZQYasm5gddo4ovsoJfDFrILoAiJ1qoLlDoFYXI84VSOULU2HQG4NBnWFwDSPPI8LHRVrAn0ItEZj1gI8ZJQwazE8Ui2WcZsWOyQhGMgqEcjEZL8Qv99iXDPfm7UuNX45i7vlATV1RI6tjF8EviS+4uwPWmDxE4XV8CYuMIqB1CFe32JlY7LyC4bibNHw5h4k2w9oFFLhAnap/b7Vs0KZVmlEmSZdxpY2roI2Ylco9dYk/LmkIT52FvGc6BRaOM4mPu6KAMAvZylUtv6qHAzVDvPwD/C1WfqZxummzc8/wTylwJ6UZRM5Qy+LG26r8k1oYAIIgWqaT5YkW+iF/4hihLY4RisfQCKyKueR/rZKiZIzpAbuIv0t7IgzB0kVbKBa2R3sp3GOPP1ulmIBSFWz5QUaD/woKxmiuL46MKdF3DA1ZhgaMs6qI7yC9QTbJ02DiadKmPE0P4OvZm8IZdTbhaQJGW1EyQNhYgKWVSZ4mQeGMDWY4aEE3bosO0MubAxpgzWhRMGmVuhwC5Hq6o5ChWyYog1WYJRArgcqK1cuOKqmwOkqJzNRCtH+AUQJ4xTvWHircogkloiotWiUechUnFMDMFcBqxbBbi3hh+iCAU2arRltVMVyZra5jtoz1OWW2YsNspdOZrXnDbP30GLOFd2V7NEmZLQRTRfAqszX28Rfcx5qkzJZ8LMpQ+bJhtm4aY7bch5qkzBaCaV+ahC3eATPPpBpltpYRN8lsBdhNgdlqHNCZtIq2S0F5RwjKqjJbHQ7I7gxjspj7tKpruTt3pwUzapPM1iIiF+0teMts/fTJMlvIuTmzNX9CZkvHPdIzkvd5eJa8VQDjXhueVF5hxaTGLQ4WgBs2ndK2eVnsAPNirmxfsTCxXUv5HnGePaLFLqN5/F3as9RrjhbUKGpHSdeKkK6FcppxPr1iZFivwLFe/Hifx5DpeyPsly/bsArVUtI0yYTZ2IxmhQnj8jakPKwmdcuI6WQ0mzFsOSuMWOCWNCVUy9pc6jriJWElavOgWfO0fKm5e7r8VOGzMgf2eQf21VGwA2u59kzNzGDPTPzoVWCwYtZKZbtWJ8mXP0G1mGhQZwrVUhXx4xItsCxVigV12QoAWZqSL6i6vdF3XK6ynzoPHRpmSnSFAVV89NAbB5gtDjDzEwwo8BHMl2OlgF2rUuYWmj8BA7oKbmIeW60TM6DAKMeABsqABpmikmNArVpslQFNRhlQEB7DgAbKgAJbFoAhCyWGgG5NgcEkA7pAKZjw+UcyJ4Es+FOoLQJmlgFdnMaAjszKKvsZVNnPoMp+Bob9TGjWzMuT5UAVjptzoAv2+shihQMNKhxoQLTZdF0Ft79qEFOnYw2o6yC+uPl0BKg7tKLT0Wx2FqfNukzm6eisixjfZoFvMvN8nXnR6MzbHHMWqlwCLU9joGNqyhLglj6dcvNm6Yux9HFzlZcWDFjWDxaE+q1uxkvznDZtLHLKqbhyM1Y6lmaZpdGy0mpXzvrebmkWHLpauf0/nBl3+U6JJwbI6layPvDGJOs3j4lqXivv4B40SbmHmxC01y7GvrjNfXGH++JNCFrJuhHij334NvehJqkQv/wwFCJbSq9jKwrP61Y4nielRLtRis6bpWA9VTl8Sxf3dilmnykF851SHJ+VInp1zo3QXFVIPa9C6gX5VmXsC6xVj05UWRTKIDOmuecVtQPlpWIfWvkH9heCGPkcpcRNOEAtWqY2Mq6JzDrlV8a4A/vzloqs75TNsi+sogRrevFIrYq1lefHxTEntjbGvNojYusGC8XzLmU0h6uZTUpBizBs+qkVsTmZdW9UZr04TWZtV1spJ191IuytXAqKLbZJPjHg2rUHBPmM69h217EUPXJXInlctkGAHU81lZYLX5NRjD/1FMys+6w0fzul3GeivOC/HSAaK1RTWyuNKYUV+Q54kSeGEYpplju8OSPZxlMl2zUD7jkr2c4h2c71WlxbJduAvFjeoBlqquCqFFHjkiyVsux8h72119ExmqVC9vWzKj+xkqZto4LmrahDlpDcCJprVUFzj7byfz0WNG81F2+rguZeikQRNEeQ7/u0oHMA41vMlCOcb9Pxa8j0Ydgipfa8vPXwRcqPQI68TVypPWI5co1aU+TI8ZgceQ5AmMOkg6Q0rQjvQNWBDqDqGQdaKhepCYOX5m2ZcE563MSCUk66ubWiTQ1DrhG5aj3sz20mPXbbmXZL/RyPy47RJ2k0k4o5kAduE81VtzM61LqdadslONG7mFTHL+9mX+vmu+78DNco8co16rDHMm3dNF1107Q5Nk1bFGOazm7CKwFHD3sGWQ/awNXmeQWBNM7ij2UwNWnmjCypTZC5FZKZiMHBpWk976sIYUD/7KRUcUJtDXQP5ahEBjMEdFBBlGE2GI6nQXMl85TbKQXnSFRz3FNuSh1nnkaLmgPs56ils3jGmFERxklfDuKFzMvVHM4krNxVzR4oxXbYYuWcmg7+Mw7+rXEyKcKXpoBOzwtmpCUVgqEksCkQmxsjJNSSTQtweis1yvusNDcucNlaxTRgOjiotjElvhVsi+FD9NqfkheP5vV0W8hL6sjL8nTyMvvwhSiPQHKyjB7MPGLJSY1mp0hOZhA3QV70fujI5mxJyEtHycsSUF+ZhBpl5VDUrLzEkZdkkrxkiOQJBLh3aO5k5CXtlucIDHJuSmBmj0tgnLwEC1BLdUpbJCxC24hLumo80EhL8lnHN1ekR9uAsCIx0dkHWWfTbRm2a0OnIX5Gy9ioxsaS7MojJEAxzeJPt2tLwj60QHu2wbZIx9yd7+CWe3WzVhMRSkF48uZL257rFR0RH+go1pwIpVGKUHLaUSElmikD918RobTBUcxBZVUFAG1qwjKKEC7lGTKdZqu0hGFxhKXmCAuHZ7S1tFJKUDScIS9UM7Drm7ESlBmVoCw5+Gebwh8UH7WryQlwa8SPOQcBIzwVJMimkCQVoFQjhRbNGlpUq1AhpUmjRCgZI0IdpYFKihoAX82Br0Ez2BMAfEsA3xLNuEOpjkPMJYeYsdJSlaHMGBlKFTVXHGhmx0CzqqiZKWnGXymh82UPOF2GkusWN6YOtnWzhjjzrmV6Xt3tqlQOpNvi5lxFhlIQYxvNVWQouWVVdCdcASGIEXClMHiUC740gSPNEkem9n9urP9N7v//eOQ8wazyBAqzTCA2hykZE1yfYDagYKzg1B6flLuNTAZhErmMhjO1E6ITlsME9fNHiQHAbAVZbtpDBaRVuYBalQuYOlkdF2AR09qua0ydjJ0pk3GJGmYyNs2k60xOulhmaSWSOnkNkw64JhPP14lXG514m2NNU6ecIUszbmkofCUnLZ1f7qygRSnWPpjyEr5UyKseUWKCSVvmzIg0qO0EJlu5MtsoUU/bqgITXZsgMGmDZIAZS7UdxliYX7HcqW0rl6UVd4C/SsL3epWViDp2TQOiuV3CyHF+5I6ys7FxWaJtmAnbzSK1/AhnxHZawZ8eamPJjCjDjKjTNlXdg6mGWZBZbGEbyh/rjPDNMuVXlinRsuiMrFHMVOhmFasTtqeTq9OYlgVGyKfULU0ltJfs0rStsjT5FWz3UXCsLaTlUstCw5nkXcFsWKHYkem0MlBuGLBix0qkMXiOSOvQzG4+NCs6NIBci5r4U/ACSQSYxyXSS5QCczPueofBsHICIt3wHZF2wgUFqSXSTtOiSqTDsem2SqkSaYVort6iAK2mg9ZE/6cS6W3Qssge8cYtxZ/CrAWIKZFeotY0Il34I0hZIdN+hUz7FTLtK5nuqI7FSdNoAPDENHqVWlUa7VdptE+0Gdam6qM+HiVyNWCnERrMKGVLlbJhtChW2qGULT0OZUO2UobTu2oz0qYk1koVfOtHdVCqa/+Pip+W8DztzgVBVw0uwOON7i+6F8gKFJk5d27FF9xO9bZBHmBdXufCJaVnFQEFw+x/yrWjGmTNMDRxvd46Tv8fz5viOyogz/qQ9Z52Ya3HIV+dPQVy3XxBQjidzdBwsbKUfVJv1jqjFH/je+G026r4r7yxqld99dpexFZSNEmv8hUhx15m4iLO8gK9ExzAr48aeENTuRniaE1dH7EHRWhbh5g7AdpGPHfEQ4tHoXq/ubRnPHBnf6qXo8VuyOa1hFoL2qQXDvCjl8kLbz/0z0m+iJBP70OoKRIMZ/U+tIcRM759AM8QcE704fz+ZB9T731eigbJtTak6R4trJpp6qTZx/Xm+rMfydXwT0xcDUcV9mY4XsYuhj9RarHXo3QI97Mdnv2c6/i3ticvs+stbh2y6jVuNMLc4v4+z592J0GdL8oV+rNr/MbzyXqkygEeOQjQ2953T7m38Mfths/nK4Ges7yUf19cWvEaBG4SCM4fCnQyvBZPHFtI+4pQGBp3lvxDRXxh7ZWSBzMMflaPemSQGxb/EbrRxy88xwQvJM/suT/s6XkfbtsnwsVsAIXcDVgK9CJKTfMR37g/ZKYRbms+p2hIKw7eeE4fUmLbTG1h44LgMFoVU2Pfn73kz//h2Jc+cOGVHP4pf9dZZ7yGnnrV85/PnMGFtQ/ygOFiZ4MaE46T7nrfcKCVyL9ng93ibLfegn9/dvGQGlQBRA+m0u40fd+pqBIau40HiqTs99s87Rg1307h2w0VwBcC3+Ya0z3Mtt0kwezPMJB5aC/AwldykVL6UoR2Seja37h9iP5eoWU1ZdFpMv3LXgnSl4N6jQxL/YTDcheDuz4yJtSiyPT8PRcPhzok2Z+jcevo+LNURjV4RymjOmpE3h8GKVGTZzdL6vSbxoeQJtIsLcT6CnIFShEbmxVRtLmQO2wh5/nHNFi1O3aXRhHn9D/mqtMqRHh2VGrGtMfYkq+dyP4nugn25MN43RD9NQ/6wyU23MIwQQbJv1G0+BrxPsGZj360L+bRZkr8yvYOAczhgJKNoYnbuXd4ZS6OB7k939+XblCoI+5T5Iy99TnqMFKHGP8EP7WXvsekXwRjcGd/x+rn//K8lYsl6+AT1x/i8XGoTS54Va+MP7yXXPDK3oM+zD+Qd0lPrvLWvquXfUqXOOLJ/h8pANS+D8uE3D+vgvgSnb179bFHH7vVOdx9QEAIQ/EM+q8M4DNHw3s4eL8GcWH2Cxp8G5aeeySst8M+peE7EX+3hPUq7sc0/HGEj2n4kwh/RMOHUdNdGv6gZ3BcVehkWoAA5A1tnC71h/DFWRK8R+76urp2lq2ksumrroldBPWynfIKr0VRmasvcU0NJfgJpXGNksr9L8BaTojRBD7yCPQuIic2hM8CcUBOXFNHDOjh2UyEdUFQWr1WGXL4oEo10wc9zSRO5ZRcmk0qAMCCe/WsgubUsJ1GfSrAcu7fhIMLyoW4n2Svw8KW1xTU1Mj+8kZliH7mNbzsaWx2K/Io5UPKK7EgvkHiTGz2ac3BEPgJXSj7mZZsyfFF2cdvHMvyV57nvxSrttg1oECva/vnB7J2nx8oBxE+5eJXFtHLKXoJdBX49bqXXwszmIiOX07xS9Rs4n/snR/sIim/+oFHweYfqMt75Pi+NhMoCl6SBy2dyS8pOFZSek/xrs2DVBu4G/t6yU74IHwJ5gnDUXmPlxSchnT5SJLSWzzf4/uGU/zPib1M8tR2inq25F2YrpNggZPc3zTT/35VmSmouoUL3Dp4uwmGe4cwVuoSCp/4/cpe+oee43QPMgsRm0LiEXYg3pQd+DFed4pGufLEUxmCGMsXHglu1Nb7wM46Xlaf1tNP1QUvdgLuq0hLw2e8FhJaLGavPXtuFGbvVbuW3HLLub/U8yaNYgFihmnN/kL5Kpimu0eDWKxhdk9Z3vB8H1YU1XslTmkE/0o7VZ/Wb8AEA9N8mKyomKm6xPPYRKxl97i6v1QDBwTmA13I/goRbTc3KNBJgfG1k4KC9M+/hc3NSkxpmrNigaMfooge6BD2khvD9anmZ//cD7zrGi+dYg+Iagr4mgLeO50JZIDHnkKsyf7/ek/JrsOuxRqX/T5EPCV8hebaVYR4EDeQEer7ekUdkzTi9DyRJS27Fj4NpYCEJBPKLJpcGP/9/3qcnfOh2rwp1aqxVeym1eYhZ8ALDE9+P4rmEqn5fXk7leQY1TWoWSal35e3kNRmH4Xq2ArcgJpzDJS4+dl9wAhpfq7NB7DxeRFNa+P3q45NHmAS6YvvEPA8xv/qfsbugHRnqtuaCUCn6dnVzwQNzF7I0Bt8W9NvOfeHw9DHHsTZSSdH0xRf9TAFa7XzZ5oHWgX2PorCCTA3YAhpQstuigwD5Rn27e9kEgnRWeAv8OxicUNglQPZ3yuPjfeMwgtraLqPZR025rL7kWqKDKwuVvZFF5t9Sb6PzNuX5S0wb1+Rt1gOM89UDlgYRacsdfhOBEMsTJf1NkprvnaKfPfeAb4U/hg2KYaODOPVblYGFw2HEiHbD+25rvCuzf+g1OR2zNvBALNSmQwDB44OsFe4svAZ95Wx8A2jsFuIROr0pjAY9dspOlJEpSFgUb+KCY1cxywRHTQZFNCESFfGqGy/MMbaBRPDxa1jofRKWQpaNLkxu2g4SH/Vh7E2DDvuJFjsC4AcdqNcq26Ua7pRhudsL1UeVuiUatmNIIcAJPtHQEveTTzx8yp8DAjDVAPiIZ0ib73w9j345i/+yTN++PKLyQWv6u37Efn3Wd4fMEBP3C40wxTttluFx9+OtnUX6vasjmFln+IKZM7O1tS7JBdnyU/y/NF56us89bPP6KeI01Q74eFl9ojO2xOZSTv6EphJ++xUM2lDz/M3sQV3hz9msE39cN/mF4G0DovlwKfA+bvVDIeqGV47JcNuTQ+yW1/mIncZOY1GVonfw6Rir3g0DeEG5NljbzVyEJQWcD/nLOAqCzlmAfetvlc/SfuP4Y9Z84/I46HicfOxRQB5pDMdC/GhGKHiZ90Zj/2bEXuP7s6DNB4rQ4R6XeUxF7xfcF+GBKtSoPJC1AvDk/iihS8llIBz1G/FrnGoXsdjhioqkRoUEnggLfu8syep/KJXlRZ+4RuQFv7thLQwrEoLw5OUFl79jUoLvVFpYWilhTd6zDZWl2SQK3D2d3v4PWbt5V++t6S0TEBVpO5s6ZeB7KvoL2oVW/r+mC198sSavo//bh1qZjT82b7PQkVuxlmwaya7apLuFRH4sJjilxKH9kjoWgSpjNxlIn0jxMv+SVdUAFsjHlCLoumFm1Kwd7xmOgUrJ+yvVifsmLRzATMQBw+iPK2sgmEIcLtlGsIo+wXDaphYByjI/tnS0F1aQqYlLKAEUvO20PMohQALa4rAIQoQ7v5fRk8ScEoRuO46uiu4TSbU1fvwsKFBMuCJ7N1ZrdYz9Nn6vgrMEQwyfTPLTtIfDMDf+ddW7LXbqgyBrBmLneA7AnzNpXH4dix+zJuAIwdlR01CB/GdqSD9SBB79rKA2xjv3l9Elvgp3hexk7mpDVegzIGNgaIG2nGgqKsUjv7rwH/KVVUlhERd7KivEbslw3UoRe6sZHusvb/G84rm23Fwlb3kPbLJoToMHR7YL5FdjkwpHfIGqEUt5zyhx9JCaO6uU8w/2YNAATsXr4NuD0UwVZjeUkb+ULuaAclZ0RpJJlREXA3rQ8R6jBOD/8BmGFsXhmpivfurW5sKRPTMLmIZl7XXNSLkiWBVMRYZD152rvV/47VMrxCvUh4Fkib91PVOzqPxKuYBdbTb1b+MwwD2qHks3WGEHUrnOeLQUSZshwMwuGqsb+AhLKvL8QTab/KIOXMIAqoyhYgilQtewYEBp0ZIzX73Ndr+Q4d8Ja6wqHkjKo0Rx4DCiQi/1PD6YIqC6jgs0VJU3I1YUOEHfIo2M6PoqxX1F2nOq41tdTTGg220UYcZBz1Nh7E0yX85PwjSVnns1ccefezmx4c4zy7zJP3kWdpDuaJtUOV/ALUYpObwQ6OYZdXggPnORt9T0a+KxPd99InX/cgbB/94sd2D7N07hIaFdl7ZT61GUUCjdfvl7bvwtbv/8if+x1OfrAcuPvllzJXuBofuxVYowlp6G8B6W2C2YFqy2yvEsgdD9Gs9o0gE1uGKIsbjqqIuilggZhoCMeNH7h2XoKWWoKVq5IACySWTZ4Qc8gSvfB3r15792qO6UeTB3NMCMBFjoywbwawpyWhk92o3KFIDaSb202XsPZXYv9ZYAewH9SwbWW4MdEJognDRCJdyrTe045ApZR1U86XW7myR5A0Yc+P1Z+81RVOzUrN/fwCu5yFZgqE0Fe376Efw7wsXDzn1w0jFavWe24dCydzu7Gc+cep96TmzTx4OVM6KHLCRGl3Z42c9+5pgwgz02bKvSzgCGJHO1GkjoCaXv4GuvCsA1eW3uzCpGC6YVM2n3Pb564/e9cqvvuFrjNB3BDTD5Ao/NUgS8wQf+2ucGdqwM3nWv+sBpj6icIaCvy4Nn80Ovlq7KYdc8NEph3GgI/NYo+dgCa9YUHctC0gInZ16RjHVltbtg6QW1ZgUVdA8zVBKaNC7GHuvR4WmeahSKuxIw4s544kq0c7MoSdP64nvPaBJBs8hGdUZ4XDVkAM3i3xttv+cNbF8UadFamFTmpriFwQA1OJ4pPR0G5/1W5e10ek7A9apkxvfbUwE/UhlokUHGJwIu9lGJSJeiWleXG3NAVazuMjJsRi3K4tZrCIYQQ7ExoSKuZKYqOSvTfx3ZY86/HpkX/fsfd/7L3kD5XcPMOH5Rx6ddUdJRBzQwcnlHYHMlnn0ep48HDx4lF2GspXNbfFjJnsZ4Cqda3MasEqKCCFtX0LP0FewqcN8WXUGTXczPU6x3c1GurvwMLrL42J8Nto+R0B3bkhR73H/fTmY9kX8QzXlhpO+p5sHvb03Qz7FOhvyLs3CEKJ/AJfFMwYSZxYo8QfANZ4WaCPfbOa11WAwT/cbAAfc5fQdiBML32LFgnj33gEk4DcjeqP0D1kVJ/WOPBj0wxdiszoPj8VU/XYgadL4VerebgQbX+JVoktbqEtd5mwGcPKJbV7ZVSNsrpl+9Q+/GKfaeZjim3V0hUIINJfy0Hk0jIa0vP6GB2Nkk/SMH/yFkYi8memQj+saO3khyW5E77EuEzWpjmjUnb1cZ/npUI0wkxdpu/O6FOmfZaurO/GAzOaRSKkFytCm3ERuqOHlLJz3cWEdia/JW9K31GYWGJuo98/QsNT18jXBGpFQHY86z2WCD9qBmjdR58tN9X+Bd5JGEPnUQXdfgX4xsWQAQHKCtFX8dPdjQyims1Od7h4tAMMX5B5+nsFSiUxHICzTOKA5+mzooBzQoOuJ6TqIDjD8WuugmhuhwJmhOs5B607ewj2e6bcUS3X1Qczoa6qvr5RxaehiAxL17PSNofNgcdSZQncGzEkNmHf1bUHfWmrfWwb7kFICeeEW6g1mYyNY8A4sIoqLMZwi5oRCXIJucIjk9DeGW5ImLKMG6OC5emq9W9Vgzir3bhchpCacddrr9ZhEvE/VZSHJXqUzMuDaOKeKEwKYbH41EiQeuC0VrKJRb/Pxe4cciWkzz8rrKB5BVoPIVFYYixZbncLsNSgIxcb9m0zUaxGVyidaaPdpKswQ8Vykp9ihdIXHStvzOmmPCIVC991+swVAdCRARQSaneGnpa0U1kgBVHMAUsChBlQYkq8V/QQqcgka+ZNlZNdFHtbIisupX/K92OLHbncqF1IAGUaIU7Sk1CEDTngMX/zQfr7Em33yBiNL6EszcSrHyTj/e9NryltQO4vYCKbQkLgqSpT7+ZXk1Wqybmbr/QMygTCnnyOhhsAoVvzQvTSp4SOPGspEYlCw8l5jfZB58Av9omvWxg7eYzUuLOQBs5K5hQY2cdkvvEYHb3fpDAsicadHWCvFfqpKiKaSEQMKtnqwJsX9UvntmABSDMoUxgcesrOOYukPRWQWYgDB2+zjq/VjIxXrIIAGGemZxmS/akbAq0gkXeONNJKhBEhNSiOzd+LzslEPt0XZu/D5iWwG/9prJjXpvuKFkG7gz+h0+tnbdZujlsP1YJUzTz9UxcTlTMq2VuJBuNx5lz/1Y1zyCsHTYLVTtylAGGqArZLgYJDXKUZamZDZhFgR0QOEhnBCMDyS+zgZ5NAgh6umUNz2KQWoUR1zi3EQDNlfRkGTz+zq01Vbtc/WSwV3HfZVjc0jtfUlK2WoqhOs1a3Wv8y5rlKbPEKdUfZTwjHXpxdbe7jFvgDF+mWxiS20oYXK/d2GeKpIWZSSt/BIirY62pRLvimyR8jcYSRxW9A2zQzXcQnklnxGjZ9llChfByF2PocHe8rXxqqBHrHWVgSY8dw0eB7WrqNTGvKIPxf/iAs0R5IzXzT9XRDbtEUsUudAvFbA2ST2pmaVE3eftLjmtDUhByKRkbj3gWze4CCU+KR9XXwWSnEJtZGsw64rgMDRAxAje/8/BYhTUVF3I9EwIxFgVGQkGsjW0GwUCWOlLUTrQ56QeSzw0u72rxDPRNBIaeGhivnYRaCbA5nICBRt3Y0n2OYE/DCpXU1taaoUHmiZjpSRT0l52qS8iDsBonr6hrqXTHH6qifd2WZHBwCBxapYsQoyhxIysUJGXWgJZGJAJlYRg+C8uh+0U37f3vXsbyt+Xh+31/HpJSNeyGIET6So4gD4vz8/BMZDl7qn61K3T9/26tse28zINZOLWFWyGXIAR9L3Hn7ZIRXXQXFVFsDs9YZV+HBtTfJlP40IXT1Jl8fYsI6IuoS5R7WDEsr3aGooQkJ5IXnZqS87SZiPTDkGYKos1Mar4G6ubo+p8yZpRMJ8QhFZ4CFBjmlhjvFnkCH7WZnoDYnFyj/ifVadinJs9otgTdUCy6p1hKunPkUqSEqhescpc1BTFHvUBH2oQv1Q2mdOpviLn3PMaCbMU4kJ6PNGOaLr2VvNCOuI65rPBdwuVercc6VgsbAWfwzBU9E9y0rlzK4fcDJGa41xX46m5cAm4oFQl71ARc3pP6PtqTGEWD7IE5ONksq3fktxExlx08CTFw6lEI7pXkNBwg/l8wEahq7GwF6/xoQm5gGTRwG2qmN6syKWoJaLvUVjnZNUqqUbniiO4A/9Gb1IUV1slZgG1ikShCh1I+9WjYGgktX60xcfujiW0IN970f4TqAAWzg/C5dnI1YIEmYz5jNL/yKOQemBrSQ2t2GMgQE+ePeu6+82IuWwfx8EUwISzMlQMRIHQL+NXuv1CWCYOpFL3x3FDV54A6O8b11qhNZtD9BLt5MwFxqKvrVeaqbI+XvGOoabWdTMZ1p+qpsgczE5xWrRkdUho8yIIzKhW4ibpay64c/kAl+GDf867AP1O9fk8wLABmA13+88TavBKEBQQiHNuc271ttReLotfIs8t3GvY5Rm8ICQsg4wJda9dFPIjOYpqjHoU8q0kXxqCDiyW2VPJGGaN0tqIOupRZ+mog+MaxqcuPrJpUoNeWfX5npwoE8d+C1uEtug2/3cvEsLWJ5m9YC6iXUZUj9dn24BCAcqUdzCx1AdIztgvfDMlEwsilkaDhmqxDnu7jgdHprX9YyWwbAVKyZlgQXtK1xqSSwGJrj32eylndW+X/bCS5/zm6dc9CS4bJ8FIZmHpcR5uW7HaNDFIHeBjHq9nDyBUWtkWBbNmCxkb5AxmDND/ncXD0FJGI/1ahqzMDDkmCciFhCJgJMZHA7LY6P01x/WPaij/nPHL0JpZOhuQmEzL3omHnkcvhoRaye4G/XRW94Zm6tRYLjc1aiPcALHffYjtwTuYtRtr3YXox5Ope6qFAjdzyv1yt6I5+SFJogkVOVm7FLT7chfS58OBQJPHGzpeh1qdZ6E+9I542Wx1OXUXY1V2fLtiNTSd3iB0o19//mHP/nJ7l+/4P/NkW30XH/fVx762Is+d+pXL4a8VDlf5mxRiWxowEaBwdZdWY1N+8KsGe8klXTKzWOO9tHFegdSCfWXjVnil8yYbjkiwewEnBh0iAcuSN6z29Lk51eVhUZP6vWKNviTPEQML/pgU3zyOIR7Cxjawu/vJv67rKcMgRkWIdJ6Z2+gUgan/PM80aFQOw+PBE4Bma1tIRRTesqhZKiafdJTF3yYukY/Pt375eRWf+dzeQLBQ9lffXHPM9seUMRMNJJUxfGvCo572T/jSV72L4KlY6j4oKLiDfBUGEyesVsl2+kcMZZGiJr07DFRl4OhHgAr1xUbxFZuNCz9itbV+LVcm5ZRbpg9nh6UIHNTjtNISqMGZKUdONfD/ot/zkJFCXsU41VNZHG6f9e6X40XFem01KFYqBNFEV14Vq0S3wJtJNRV7i4V39aZbnV2QRKJEOK6GjoX7EtdqxJWVas6q2ihqtQuA223DExZc3ysOcN8hlRmiXL3cpPat4sBJdUNlJ3qLThcG1AD750hNWWtmRldDLAUKE9ibTC2MFXVeX0Cap5UhwGr28T5fy39jOc1N9MxWxjVMdtZuhgGDnJZFpFUIyZW/kv1DfJEiVfD6Z/he/E23MQRqaig/S6XwzP1r764seoU0ASF8wgcGD5siAuCuJS9Qj6rumSK5M7tsOL6dLfDF6neFkCBRvBBiBH8PB9xRzusViCqXqFMI0wtbLpgTOkRf6yG3tIbH2VlQvW1DXpXVSV86NXHVyX8ST/AxdB4mjTM3S5d48L5lgod+iXdVghskRL+UhGrtL0uwlArttaxRbXIFfd3HhD3oyLLjrKvGUk2F8RfzB73i5vki6+bLzQib4xmzGP5Om9qgXNaYFMMOzb464Ov0a8rUdcjqmThdS3DJHiYVHpz3bT1E+mmPYMrGlWqt1erQZ+PoMNmnUc8BJ2S6Fd4Hp8sW5D+vV9dLxzFtr5As19wW9RaKRoe3cOD9Y2wPYSiNIQbsd5AsPgwmi6pANnDrARkubNmPvhFfCACTXCF2S/pKyh1THDwrBs1zPIEDNoC8U+2n2AmRI9KNLNZS3heqUFPZJO4WMYEj7AIdQOvFADf4aRdLupBr0Q3rnJsi+wc4iep8Be+27nHoJAl4XjNN2f6ek9xs9grZ/Gb3Cz2BN5js/jwo96YDKIvDlnzJ5C1VenKHSegK9fwNqCfiYTJK3wIZD3UjYUGaCFcef+x/NrfnXv9ACdWKlR/puoIqptN3nFwCJk5xZi14GU+9/gRHMhD8PUa7ae/FISJ0RCccktIN92A3KYMDCSEugWHQDzAGys4mWMBXySIT7mRS9stJTEQUD9vPXPPiHp8+YQiMBQQ1OkOJr7anrZkn9JZZPSjn1cgEbus1Mjg+2Kk0U4bo2KY2PN0BSbV9eM8UvRX2zLXgSZ6G2LGI+B3/1J1wyxHT+C7UgvWDaMwsIW3l831opXd+jpu1Lv3YG5ol9+sQ0ut7PDUJACdkVNqLWI037pfjQwfwYl1dKhOic6firz1RGcvb0EV7uzlUaXJH371CWjynwaQNr0Y3K8T360V06z81sVEVkx4qhcU6NiHOoDgXh/s4PeBTpGoREokk6L9FPEZHKQmIgNSWSRRBOYghhUnfHZjpnfIxNFS2xgehxYVPzrUFAlWzIkQ4dkzgQ5+UorVSkumjGCktv5n8GOj1GNLjBGKrQGaVLQZSkM0DUSqxrnh34qI3+pon8onIznJ6lgeIW/rWDoh26zgZwcUJYWWbz6bqr7NHLXBtuYZdmdrhWwXjI7pLBzg7Xu8/Psy358ZanszOOPJpBMmRnwQcSNsTCw2eSlVdb4AoxGY0Uhvi+ql4jA/w2sBrm6e2KYXDbw2dW9l2RG8YSDu6RQpnvd2ioqRwKMXia3K8kajOL2b2fd3nz96wY7fv3Dvvt/YeF18/9IeGzjfHCd1+uHTesRs4dN6Ax7NFCOQqmVWmikLq1zvytsidzzYoaSMLLcPaGzWK5j7Z1A2JFeT8Aa3I7b9Hzbtv2uk/YefPLX9i7/8nZ/+8QXau+8HfvI3/2HXDyzawOwjaD9aiPZv1m7+vtE/zHIRdWbPJRdpD7IoQZxUJC2s0OTlGTcUwaNBnqXoJ8GOIx7z0P7BfhsixUzkiu7EhCLV2Lb4CK3D8uXK3sT9iDufPCyTVQY44L3UgKvg/XwszMrnVEwJnKM2ntmQsyDQ5dJnaI4Jaim8G9A8JessqKNZwTfOiFFCYN9zf/trv/riL7FOLd9p+2+P5HrK37x6/HoKeHB3PwVvYxdUnsscgm5Dqir5AnwRquxncddz9cMg+zzKNywDiqja9fF1tedYveQs9yYTfYR4oFWPL6/DhNkXUNjUOzB602yzazCf8b1g+s1skZv/3VReM0L50QhDGzmGNppkaF26pIJgPJwqAHDDzmZ/XzKzAG92v74q7fQdM4vdK3aHTO0dIxtpxqBkZMHuqBgkRJwqpOAh/Jyo908wstjs/hOaRYEehyC7HuL6I4xs9QJ6n4dq9L7R0O7eFV+8bF3QTcZXd9B4WK2O5JHcX7rz5G+wBSM32PxNbrD54zfYYNPmgdEbbG99dfUGm2G4Y2W4I7Dc066x8YlLvF/kwrHQJJxRVq6xhce7xhaTb66q6VSR22yJPkJ9AJPe9urjXWN7u47GL3t+aA/BFKcU02I5vVKnEwEe3A617REpU62Wk4VDaPwwegCYJZdqqEV13TDJxfHsTp33WgG+07EO5RVtZvkZIBCWIulOKi9FaC1r2/vhl+D4a48ON4/dg/9gjr8i5cSxqEtD0QrtQParqF3oS+RQLd1r9snY92bvUDEmoajyVqrAWzl7S+4Ej6SFSfr+k8e1binJeuvH3/Lx2hRcQx6VVjl0ewvyMv7w4wyHbRsj2Ob2URTr7kpQrrsZyvWf81yod3xzEe89x0W830Dqoy+nUs8EMP1Q3U++7wT7yT85pQnOfOU6n28NBS+euS54cXRd6Y79mHMaI72xDl1u+1VnSmoKDx/hfo1kqRHCD77Dhb/grEVJKcpV5nFfUcLIu4C4XWj+iXH5hDelff+F7CwECjfU5FOJJlN5GCFVPbZr8hlKkKNJDeI/3gi0kAGcW2u/Zs5c5llKwIC3KEVCqnLUOXvbW3SM9G6KNBYtaJVeJGaBNBl+mnr02udXyI3sAV67TEuR1kaaKkKw5F6UfG5Ev22R/cPyNsd9x08NEyF7vy6QLtY4gOnXubn6hahGwS20nNuIPBsWq6G6JN1R3/IMolnoEx8omsKgLHCD5UJ76a3cloaT6aZ8GxYZsmqd4iKlfQDbKY7l8WCwoSqIyLGFtY5n7OloCxsnFYmrs89qH9A3q3fRkMknN0wWjA/GRTlEAjYsiY8ZTyznZhgjaNHjqgHc2CSU7UfcCmfowTVTsFcHTD4njNd0nAxhlhtPNJowHuoH0wC6qGkzt6ovva1obb7NQXt7afAzo62UKqjxAXTdlaRhehrb1IypGQ6Q+AEsZik2AIwcGU7X2pJnhmCHvaea4MvUkmwtgodUuMLZTqlVaOVN3CpKVidFCTXx09axhPsMs6kVh+Y5ybOW56qwKW4lnNVf56ImonzMcirml+SJiKpJGBRrFdw4I51B0dwBBiJapRtcp9QmZkq3uSsdGbQZGGfUkO4WDrl7EzlnXWWhPndWpxwKLN790Lw4OGtqL1o83DOB6kgJeSD/AGVr2NsraNA8GMKeNvjaq4Ie+oxHxO57KKIlYzu2yBGZcyT3Ft7IbfxOxO/UzAs28hREnqKZBTo8NrM6QMA8uF4jTueUz2oiYnJCWRpDgAUGfFY93YuHDrWQqznLb4lsafZbMJUMjhmxcy9zP8Y8V9ewEpeo61qNW4b4atn6DlTRg9KQU2FJzFsDWE8DdCW0y0WeXkae4SLPLCPPEmFZfja35hyu7jE8Ko/hsdulxN1w3nVMqd14JMVjxTpHviQnDSBLj8OhpNDBfCv6BNeLsEOeLxHHkLj9erwU0zTWes4Ged/CGkO0BSLKeenm4/JYJz+dxnDZZcw6xxiJGWC4IC8AFq65VxUOtQSnwImXhBk251FVj1YOMFFS/1IIL3LU/BpC2/iD4PkIbeeQL6FlDnkSwm2wrthk79J2wcy8LS/L+pLJy5y+dORlUV9S2sov2/TFl5cFfVkV8Ch981EnULxoyfyOaFW7iheiFC+zhFcqcmrJU/AJyDRLRJFF2Q6hEMopYuQqThFjx1TABjjR5PwR9C3Oxc8TJOvAK87jvLboFj2B5NtTSKI/o5VkphL9fKd6DSxOkUq04h0SdycXO1LaDpJMOwnRtrS2zq9cOmHdhxa5lnYu4kjijnJVldJqnCqZItrpShO0YpISKnEkrFjUxUTpGhe0ekU1tj6Xtzhb8sDKx7Onhxnfq/mpIub5rOJH5wMx9/CDF8kLuNgLGT+3G/w8nSs5w+Dn9m8QPy9UrLuwxM85jtoj+Nnj0AUS2sKh8yU0X+JsUuJso8TZJ3LztgnObqPEYiZeGhYz8fJEffHxYhF4lbbyS09fuvKyRV9ieZnXlwW82BmwWMHmeAKbF6vY3MWLXccW8NKWl52K9JnB81MMnu8ABpxLyEOMpbPyPA+RF1lUyMwMKJ7EqJUj8GQ7H3xF1VNoh8wHpCMgmXa62VEibkTn0RM4MDlXBBHxc/yZsnNkpqRa/bl0UXWmSMYn0ZNl8k2bKfhix+RM6ehMOcX0wcyUnToJSJtvZgqNzBSdIpQTnWCmbMOk2GZnynbMlO10ISIZ6TBTghQTI2AH2XjAu8I8ZgVu9W3hWbFgZsWZXOBZZlYsPPxZkVVnxRal1FgddFYwOjJGK63eIvRbabUvoTnMAJ0zRua/RLFF7QwvFrU78rLNEerYEndfXpbddIgtPe9W8Lw7ged+Fc9Xq3ieCp5b0k2zBsVnKihuhwuXY3NSVBsj64qv50kycPST7/zBi6t/GHYgxk46VxD44upfcREnChpqdYI1TyAbO8UMg5k2FmsU/U+x6L9jBGHPU9IOvB1bKGrlpFP0n4Kwdz5ihI1Fx98i7AKwaIG2IFJ9G7d8ICy47+3GBz49DmTRItc2RsQwz/EUErQIxFmFX3lDgnklZ6xAKC5JK9zA+oJYvl3N2/LStVi2lV9ii2V4WTVYVkGfzgT6pFX0yQR9Jonh5KLvVlBLxJR06OiNQpajo5ODrLobtZDdhl3gNutvf7tGPo7Opsc/r+Af3Mp76Zp6RngcPR5AWpGilvIa7cbuYjc9Fh8ZBjMVERmdukaP0YVFV9s2X+k9wBBry36Y2pwmDp/AK3WN/nl7mh8Pld4uma1UBnXuyUzFxXJCmVELdRY1A2js54ummac81XQIKMf9Rx8zGC+M9VTTISDkJcs1yQTnKTkjTyHzT+If62Vjh3IwzPiQTjukqb9pMksVT52LEDgPSepH4wn0JN2h7dUi9IX4hXPrS6YlyABjrDlAF6OYXIu5WtM18+7xfbRumgQHhAK7d90swRFqVN1MO3cwbcNFiX9ktwcN7AacQ82KB9PKJU31KGj8l3Z1XxPKvqaLfQ3mxmPoHLsHOkfiIEEwnjAeoWWyX371w/RjsLtyFPMr+Pib4LygXzETmIhJKSFJfv9a7PxHbfKRD9FLxVigDyHtc2wJOAHBQ4TKCIcI89a4FGdaxUUy5yAhUsR8KOxVq6Ut9B2lIGlEGJx+J+TSmb2WQX7FGYXWhAIkpMJNa78uoKCihx2mfxp57YpY1J1O+Qb6gik83rwGX3GNkZOaOx/QAizvKOMmlrQw+yfVktXLW129KJLpW0vfQiO1NgJCXQKM+iwlE/eMcs+ec7kbR2rkWzRoMrGHoxrNzt78wATP2cu3zgofa03DXPzx+e5g3oQjL5CzBLovLarzVRBEtLHR73uqsYq9s6847MxecXMhTvP0fFcVPlKIHTmWOv3rfhQWb2H0eOTuFrA/ZJILcdDzTUM81KAeSvSIiILsrS9HiojrEK/OBUW9D0I67EpVTcKzZ7S1ozbARJRrhkEae3XYehJrGKmE4Kq1cREAJkjzRYKbocpI7tWgkS0e3zXRlPAVDkFZt5afaPkHfeTA0V2RoXSIjajD7ZAlokO+8AMotqVSI63c54B/aQ/4CjNeed2o9CIV0mKjJQWQuZtV9qJWKBe1NNFG9smp5izyjzuqqWV/LrN767TY/h6hGEpfptgpx6Go2Mx+N2hOVeX2ezc1C7rqrII+4KyCZhWbnwvO5OeoIc9WjbRJj5iwvneCsHarR+rdiRP1vdNMPhb82dVMTtcesd1HPXqqElq0xBDaN5/8WZY/cm4abnJu6o2fm8I0w4Oj56b/dEP1JEvOb/TANPw3svv5wA3HO7f6LFJZszl4ODeRWlMuIrVG7iFB6PsCvRDUuprfTnQH6RN8LOhNvYT0caRQqOeG7hrSB6vXkDav8+S9NfVf8FyI5R99n01Hp15xQl3ZB149ecPpQ3qQ+KxJW8J+H2RSeYWSUYCmoY50da6DYcgD8wUFFUPDj2y6/+bEdG9VpjtejsNH/dYj56MUL0and8tO7x+qGvP4RkBUhAZI4oMg90s+q18dhIfJqSm0f8n3gxELnMGkJf5gEx3bIFMLPn72BwpBy8qpDQ1pDSTuH5NrQJgvod6NdFaufH5b55U6UdsFZNds8mRp1fKD7CMonzQp+yheVB9uYcwWdM34WDL3OCtXggrYwu2URnPxUsRqyLCOiydw7tkVUyzc/sj6uds9upi6a79uMZ2IBRgN2jxh+mIqK6koW2Ft/L3xFXVzjdf7TqDxinXT1f495X2WpLBqPhv7fuqpP3l3fn1SmiO454PkYRCcrh2GA5AsY7I/BQ1myKV/daJ7CX/0Tb+XgEoe7r2EY6P3Ev544l7CwQw70Kl3EI7WHuEdhM9Mu4OAqrDb/Ja5i/CHm99F+LdT7fqTb1HVrj89robNx3RhfKfaOPA2V+86MzixetfRTqnfVRO9ezXtUkec1e/65KOn34XrS/2jGZaf242O141fHdPx4sQRJS8OZX92YiWvux+Bktcj4gE+/o3IUj7xbVnKoyVL+QXfr1zboWn23rQkcAMTi0yXapKQ/W9VU4Xo5WgHvYDzJrWdeJe8Y5Jkn8BXuI0EPuVujq94kGW3acc6FQPmfRI5o1eqgAwMI/LVi4cVm8mR3pTJA1sJ1IMRMzS1RZLAtaHrA4rW3ceDCxDtucU099x1xOru3FeGQidZhaHIp8XqzDS61YzeGTJV435IphHbLVf3ac4VBSbgPQq0rrx8Wl+IxOAlHFQJTcOrh9e/sq8HQ7zea17TX/QCdfjj4On3PWeGRa0UiixnAqjP2btuAfiZV1sABhvT8inoi9g4oWGVeshdKuAMzVWi/odklmAkBu7z29PHcJ/LNul4VSK0/gqrkz7kGUv0gVwoMRunSif1IowlOlL7SK85Hasp+qNRh1mzKNJWjsTF1Y+cnA9T15tizfWDcC95pGgMss8KzJoUEki/jYBVLigdwugC1dnXFmBTZ1RzMiSlZVaEJFtXNnWjflYUeOlhP9bFapOrdn2ZBroVwBRTet2P+lxe9jGRJIQXBJeXt4ihGz/Fcl7VXF69Eq9WFHG4IhbFKFDZPGOemOeBph8WTr2fBkcNFlDKv2qIAXULzORTvXLNjOLKvZVYF4R4wE0FHEa91YzeZ3v9I4NI0k+qEDnof4MgCQCSSEBS3xwk9W8cJGjriWDyc37kYHKyEEn72QhE0kcIkdBAJARE6oCIiqgNRGDY0AIk7Dc3BUgMgISjAAkrd7OwGeRGisUUcFcATHoiwHxtGlU8yvAoSYw03wes3U1NcINHsr823FukocEUSoeFI5CJisYlxmDYRhEO8Z6tF6O+t2wVDdtxuhyVVT2Oga6uS9SRIhpWNn23c/wQa/LQFTJeXI2LWx9gcJWwrqeXe1616/7eyupL3kCbu15wmOvzJvzQ6JqvfYFUw4d6ujg99ExPfUcYh+INXgCBEBcYOs/OWqBpVyetwKTaR37jVnyf/Pv4xeSCV4qfeAPV4aMgVrnT831GC6rJnVEfT75B6ssmSezE4o8VyrkKGHHFQPswC6l23MU4Gcaiakw0RotYkYq/91mOqUcbXiUdyk3u2p5Y+/FMQYzOjP38Lt+INgqKeYZe8KWYF85TlJeFraUKK6t30cptAQZcIaPuZezkpDD7W2v11xcraniCiQRUlDEwfsU8SfE0xbkkc/wx2PkTuSRTzvizvue9VDeXdJ5PCPFRcYbzZw2rtW6ExdrLLgnB2stODZ0FAzcS2g0rhULDduljpz7OwgNpnu5+8Gsse8MlzEE/D3Rj/VofTPX5/kF+4otDvhZ8mFt6WMOcB27OJMzpyKOlH5Yn0vSJ+NP9m6TsqXugN2llnEUrv42f+ORt/vn8J2GOs/G7OP95/KfhOzh8hy+EGnl9/V4rfpM+ke6Bw93wYac8vQ0+Yt1eNtS9bISxCszuWW8shcoqUSBjiVtxYuJRkilGKCIR/GdfrG5dg3LrGuBVNy/YuvJ/1a1rYGyTTrmadHDWbV3D/uCrY9b5dPDQCjQ4+3K5aw0327V+6RHsWv/PO/X2xcnsdJdaaMOowPCtb8G/v7GOxu67GNKaS3HQmqHozXZzQWU3J5aePDXvucKff0pe/0RPgGQPdygjf6qw+YEOYAtesaZC8xths4GfD7BlP/DQIwaaQT7cKuBT3S2/TO6KxKxgEHWqRAlGO7XnlOg2AWlhNa1eWZ3rFSszFEzs6wZT9nWTsQZtdQ/32OOcvAJ/s38aFxS/yfO86WevgE2Vb9FYQGpK7Bemxt5TiX2gjD3mYtU6qMR+eDKva2VWI9fRR3ye+7LXjAt3dlYPeHZOHPDsP+EN6R94rnwWZDe85hu8H10VJN34mkcgSHrzv4WU9fbXTEpZdTL8Gx0ED15zPPHqEbX1/hMXzcDZ2BzvRVpyfTB6ccrvHl8h9HW/Jr3KYwgsW+IYqa5l6CXCY8e/RAgnXUfNJUKE76yEBxrGuYSUksKDBmuv0/Pzhgs2XRAZjiVQHRZbWXmbn8a+KwDTzWfwILW7cVaeIVu0hiw4D8ZbaN/QhgwrajFLnf2CADRrLijO7S/maR5DLTukfIEie+dwkWaRI6IO8R+rt8wjwxLsf+7XzMsuc5dmcUFxnuaQsIUyMK/5ijWC3Zf+s78lmheLacDPLnBhGT9zGLWltT6/mnuJi4heKNO2IG0BaVxUCwis9xI3UKotkuDCyG7g7uRtWY8L6qCMen/QYHVnAIWfWy2QWe+T27dEMxSuFdtxJ5H6Xp5D/xWdKGiFA2xwZctavoNmaWk/YnfyJ6cEe7VjWhJF3LHp+BBmNEd4OsMwwodafRZz2f9UudhPp8oFvtOgPiW80BKdai5IRuIuSm/tiVl5ItlOzNMSruzxw17Z69IckpeggbsgeRZxaUev7C1STvOSbZ7DMOO6LDMPPxltP4BBwDb5FNGA7Mo8RnkJSVEQKogx+gUoibOgMMt3ybOWn66gEHM0cxhxipiHRo1zaw81xV7y6Q99yXvofs8AI1sD4kmehHZVk9QozRz4xLk+AVq0iDjuB2YC7O8Ch///7H1HfNvKd/Vnf6ZM+fFPPREACVIsd0BRJEWKlHt9tujX05fZL2Wn+ZdNutKz9DJL7dJ773WXnrxdeu+998y59w4wMGGLtv/dekWYOwQGxMw5U+7B5YTUeNeP2hxmkXt1+6gtaCO7GAf6+ci93ddoIJF7CkoT0u5/h2aCJtWnqFkcBPYpGMXU5CcwU5hf87oz9ygENJND3mWABo+SaLEG50LSQEzOhGp4uGREbSrJ5hRsj+1z4mnhYcVZXdIPZtRxyfl//72ecyC0pgjlAmZSKu0VwY1G9jr751/PUJlmSM9s2t7PmiiS5vLRGOkxf4T/knJW+9JvANCuAcs0zT5G3QJH/OTbh9TAeROa0Tx9qgNCzgg30RwIGaZEge04GTwBIXQ5QrsOFpX37UcDBOQOqIQsAzekoToate6CM8+hb9mnLW8Stcs1o4CTr81Ndt4CLokwdu9mPwoULV6HHTg7gM8noBIOgBoBavIjQUDAeY4ZHAgYkEw0Cfht03lzcXEGAYHmsr3hZQHTSLp4UwJKfmvDXJEYUv7doKs42t8NusbLGHPdohI5f7VhbuAdB+7FzE1bZk0jRm+a6/a8m3QVI+AtLqmmUYVX0CcTogqr6I4ie1j/QmPoJlWJHi6O7CuHpmO/2tAW0qXrZodumHbaXyVkwdQmIAkg5iYfIA900xxlZ2mx7zZ/krdLK9Q1DQ543DFNW+KXG0tBU6O6CaiJ0mX7Ku4ORlRL0xisa0glYwr4OANaQADRBQFcl0GRJQ9yFcLJnLfO+tVyMrFoovEy7hn1yRR/9uTc88lthayQbI/42jlx9t9rtn8nLmLEV/9eOZnzneT2E8k8n+zlipwQnzSivacVOWNm8dV/V05GUuQUmWPJPJ/MckWOCSfhSq/IGtBXowCHAO0CvIZwwYQL+FoQMoto5gbV+VinJh+b7qX2qkY5UIQohw4OHdohc2iB0V7sY1Qc4swhUT5e8FYWL8iQ20S8IGPtDmNt82Fi6WPHA4JpoZiENu+QkVgSGCL8fMPCsG9h2LIwHOZhOHwxGO4QmSYZC8eeaVPfdKhluoAjHt7UqGICapvIAjWmLu6Wg2LsQTRK02MPujMqyZiWzBW2E7TaVLG7RxEfbyPzjTyQR1RG7l2a0RiJexmsw8Ok4c4Brsq0R7eRAPQdcMsALoA6YeQrBpchzyjCn5kD/MSDUoNmjHTFvYNSI/sOd+mezdWrf0+pNaU3mEhFgG/QVDg0o73iIpVDecDPeRQoBnxjFcBHOEQU4xA7+NcB/7rCP4M7jhVq87FNHT52qMvHLu0A5DuODkQhgGtwMNTDoUd9HPrUojuHFq5DkGNIG7hugzZdiOAVhAge4PA+umAA3Ri6blNlDNCmhzTYQCjrJhEdWCa0QApObVgELywnNi0n7rw4J+hJTmyauuVD03KhQn3Tpg3ToTvKiwbVTamAGyEG66dwI/C4EVJJum0KlBexxwvXoKHiYEwCac0XlqX4ZnAD09/6aZ/9Z1/8g395zx3R66K7LWNu42Zr7miJxhBJyly0IHFKLndWMCqMGZCEUlOajR1dONd9P7pNY6HL3AeiPs5EYS1M4RNnufEiD+sapj5LsFboPhPdGuLXALobim7t1F8Q5ZtE+FmKHhngsgWrRX1YfdqAtUF3YN2xYCeAfYHLF3TgwguvYKXQtxBjeBvjYbvD2O4/lDVUzyJ6xyJ6KJMNBSa1LWzLZowjOlaeQ+wgvNo0LPzqNJR5BB7elLy5RIS5hD9/8DttBeNcwTjxcaZdsN+C47Q71abT/jfXZjPSMb+8apuhlWJtpZBrP1xxKN4hwuDbIcMtB6tLQ1hDaqP0NvVwQY/6csENukK3Pjexf1wwIhZnN+gWVR+aKk9/r5sSXUUw4lW6hovcHJT93mUjPx6HafJTVqnfDbUXiWOXeOwSR2s8/pshZnF0mfYfPbQQkGZv80zhCgRnEi915x3pj2wDXqcdPrEuX0aEenSXTSoBTVViH0JFl1yxvQztXpe1Ts32cq71qWrXitr8JWrauY81DszYGhXLFTZm8FchxcDAcSKjWUNH7ZCPPORinMNDW1YDHOgZ5m7IxlV4fHyGMQ3DOYZqJPbksyN8NiUZ++2w5kqB9auw7AVi/TQsNzI+dTTn6XCCk9AA6Y1h/R7/UvqaHQP4oc/Z3pjbOxaviqxV8GGADxN1NGCZwnjlzBFnzrzF4YwpQGWksQy0/5mxkCxbDWlsZEhjXO86qchC3pTs4SxYwAs2zCp34DYQ10Ajbc8zpi4ekvOWOOI04CV2zA6CgIc2hEI5qpoagJGObvaWKIYC9E2Brvk1xnKbGuKhQLG4xZos/uLU/xDYWqGSFq+Ppj6FE4vPfDvnxbejQIwIqdf55fWIyugk5N7FJ32WnnRAkcgpgVRS3hNEdayLrYfANNgZ9ZqJpV61L3fEepC0ubNB0D4ut1v8vsYsaxezrJJjWRPsci2zCssqPsuarxzLHJI+rljWVpYRxov2A+qwvSDhQV2b1yLZNHPEayjxwhWJpztHKzMawGEjJV6diReiWI944erEKy7+xYkXpCcFS8RzBcReAbEWELjPvOtivS7OCJvUuEWotszcpmNunX8kZB3Oc6YoHqmtvGWyfnrqmizJZ0MEBgTwau1UTnn8SvGYqQtsKHtPGDZPh83aKsPmBRPnyDfkk2rMMK5t03mNOiJ+ngEL7UasbfSq6WS2Y+/IcxmZX1dU5qhQiF6gxBN5Kj3AjJtbqKpdYURNqlunNV4/hd2AH5ea6sF2ubHWTgQx4BE4GxxSbA3260uFnz0QyStCGzcokGw8Bp7V+qzV2R3w82ubqhbShiEP2FmU2bi4iC049L41pQZuuPj8L2DRAt/sUQolEiShhrSAS1LFZXPZFnKJPmQuShWfE8czVEirnNkqdqLb/k8fm/vZixS74prn+7PQFfM1qA86h796bwia0LJw2GY5E39I3iKi+7R7nAX9BRz0RyXZpdBsyWtJFIHXtOVtarDrawUOwoqdNX294K9ur64HH11Y1oO/5vtO1IP/ydOA/8hLf5DpwSiFdYcjiA2iB2vyQpZMT/ikkYQ/+IhIwn+1qiT8e2WRhNHrdlA5HzZJ+OhUEnaS8NEnmiT8QZEkfHQqCb/ikvBRJglrJ5xI0pL3GZLwBy8qCf/VJ4okrK7cp0rCtUJNoYwRQyXh2gtKwo+fQxJ+/FKS8HGRJHz8UpLwdxdJwt/90ZSEVQtWZfjjUxI+lYQfv6Ak/PilJOHjIkn4+KUk4e8ukoS/+1QSfsUl4ccfH5Lw4xeVhI+LJOHjU0n4VBJ+xSThtQ+zJIwlV5RtTvBRkoThni52csNZXezkdq7rzMn93VkpqLack/vo+Z3cv5fdGM1RIAkffYXzLWLR8jVnDmXFAjMA4NTdbc5wBHgNWWTN/6fm17AD/LGeN/LOsx+M9LyVfOJwZ/h+cCy6QA3xg4MhJs6pxmueanyUub9hPcP9rT886HyWQLllprqnz+EeoGaR9/vsCt5vLd05HVB67cTSU/euq/l0m69IbpVlUaYH8+PLAI4O7aOrB8eOZo5iq+tIpxT7BKFYWymWScawAV8nGR9lkjGsJcl4JdaF4EUIXhQqxmeLFOPVWVdYejHrkloB7wBjZV5M2Qkx+fmOkb7g61PzIyX4nhL1lKiZJqz0fIUHxdoqg+KLq71ry2rv2SfU3rWnqb1n82ov7AK19+yy2ns2VXvPomyuy2W1l7NP1d6PmNr7HxL9W7b/v2Z/rqtiVV77M4tfsmGPa/b/vNq7vqz2/vDJau83f1+m8H6jl/4GpEXtRSlOUlC11yUvZEk94fnU3oIvtYmOHL9chMTvucSvusRPu8R3u8SxSzx2iaNzqVZcS7XimmrFVvYNKVSteA04SeXfOtXyWjGYBXGRwgdycpyd3BTyhhTgg5ZqxVupVswVCHkwTLc1bYI8LBgHkJ4a0INj1YrrTKz0sxY+i5a14mOU6opcfDtb0GBZgc22NWU12LRFTDYdW356kvySSRsUaUkB9n48aMuWLabBbKg7xbZiQhZWtR+pPETHwOJt48ldTl1p2O+Hrz2XxATRV+4ZUouih+hxbS7vchryrQK3yylGAFNyulaIXxoKMSvRrsp/hnSXU+ooj47sz3x1Pa3cjjs9fSeJBJrgnbHPiQ4wsXduoOH6tMWvGCUtiGI1ajxA7sCesgP9ydfIdUhmiL1OOJ6kiI9EER+xIj7Oans3FccbNPLF8cAXx9u6yylEYujj9qD6OCqYWwC9c8Tn1NE6oo/XKaGQTwttOrT6eEy7VHW7nPYPaYiS4cKAKB7gT5TuclrXt9qbvMvphI+QjVEBIlQGnjJep0C2OYXCig1rMmUcNFPxdZL7iLiRMR4HOh7X7emZq8ntbBTnlPFxpow3sH8klPEONMjtnDKOYXQoYqZSEJ5ibHO6h6+ujxHq/IRJa8nGhYkyrtaMIq2sQHTvpEl78kDJhHpO5J56u5DiBJOq30QuuZ/tSwpAnkOReK+BhjzOlrJ3CGb2exZq4hNbhP3zlyyCIz3n3VFhonTal4+mSE/TjVOTsqv3Yk0c1ZKdgYoFfPi5B4cUAiRJCR5l2vc2TEXOhKb5DVMDN99BN1Jxq4wdN0AP4U6TvATSeKJropw0fpG63pjY4bpSxKk0HoKI6FvqkMY7PMf7MWjhQBAyQpehK7CsSyGgLRPH13igupSNWZez3CtZ7tUs91qWe12TQOsOnbf69xnZi9J+vVtOSGfwmZKMQ+a2E9J/fiO5g6P9QfY3REg3KqT/6oa5CyH9mC8coVLt/wNb5sgYe96I7qDvuMclBSqk38aAtQUhfcuObyzMbNNdU9HZ9iUT0GWutpAqaPx6utkfWszb+8/NhXEI3euZbkfMAW61TQPs8rfNmEWabNbGIVJjTNseIdXGjJFTu5ircSqxX6Vvv4Khfra6h7ErRsxGIkaDDRKjRSNrjMWostETY4jq0a656mapSch9VVkEqDobE2oRkxcmJVMK+Th3u7A1aUJlMSDnoRCaUhl7ee07oWXPAp0my8RkKiYH+LOQc9eS+94ObyEtiK/dp/veDm+x3kUunzsBZp/vIrfek8y1ZJErbo/4pDktvOIiITW+NCjvZMqpFHeAzIlkriVzr7gSWGxtdClecUCWsexR4mEApj7I2qeBkLWCeXuFtpG5TVt5xf1eprgzNt+E4v4msPmWPdgx/21b7DsWom2F6BUT0FWFaPslIfqOAO+dFKKJzXqLIbptU29zasum3uTURgrbWgrbd1PYvme/3phhO6aaAyeMdx04YbznwAkjUXBCPqNtMfpsbIlRYWNDjB4MRwLyAF1ZAjT5gO7DcMNyD0bExlxwHyvU9xXqe0DAAUVsLKjJx/vIfN9BIVYSJJ9Cc5oi8amOElUB6z7tMSXwORJ80twniINume7T4qm7tk7w59lkmefI0pL7H9D7ObLwmZ9Cn8oELCbLAe0tk6UhZNnXp3BkmQsPJvIASpaJTxZlCV4hOIEsY/Bi7MjSBlna9A4yLe6cAn8bCvwGDlDgN0AMrIS3LDF6SoxrtsDrSoze8xPjdZ8YW9JfY4wQYlhEWlBLj72lvfguYMepBCQQ2kDuZBJUHLpjGA7dDTbGWXddobZjBAxF95ANUkZ4UO8vQb3qQ33oQ52hELkOnJqK8rqHctdcESZDJGDLd+4OsvfxeeHGrWh3QGNOBwUbt75vP2Qk8v0ENgtyueVl1Ct1FDbKgH3HgL0cZO9z/67IzQ0XpZR4yoACyB6/MGRV21XI9oCjntuUe8Pp6LexomjLqxpEd9E3OniNeefWKR/RDxGgMySysBa49YmozYCqpP1rTxZBZKjqRvWIjb7D2cgaFYczGEPFmQegxhKAWj6AYgbQco+4PPhn46jryLj30ObL16zNLq9Ws7p40ZodY2U7JkImUVsy79Jtuve5if3j79x6l+6hkgZclDEluoMF0x16Axe5SWVeGQ+cZ6SkieMSj8EG3zigW3RRVW/U/JBH69tQvUciA1RE9daZmjYBbqSefmwHi9qG44DYG1KFCKPtoK5CrPu1HUrUco0ysUZDGoXMVPz/ERtzePnzjSNdOg9pyYLqfLyPTIwAcA5B1EergEduvNqTz34Vn4EUPJYtiIe5hXz20/jsgDDooZKyUtyLAvYCsY5gOWrpPG2Z2NIFTKTw38tuzC8gqL8gOGTF6riEZBKxw3+qNVZnb4K6PYFfL8SL/f7coXPmhDPn2TIQAES6jDQWfPY/M30i3iiiKa4TDShQXDbFO9ujiuNZXfUarIvtqfD/8JcSASzS0agpEhjhSdSzrgFVOb990xqmqUORLuTVEbxDMZCdBQSWZEHXFL5w6cGS3179BCeV7urUVWfmt6/LrbIsorr47UN5/Cf89g3nt49Zz3gNbhJvDuzI8iAZspg9pAqNMjHb0LCYOdUccxr4vmDPKsyp+sxpfOyZc8qcoTLHGkTDB1RREUzA3VAyWXyaVo5MsZIpWo1MEeAeObjHAGDsyKQiWIRSPTJFq5OpuPRCMiXBMp0UoTqOZic0ycvPiJYEYG6dgmXGtXylrEXrGniqr3Qr32i0rFEPiaBRh3AeUeWUf68I/0A5X3p+hYewYJUh7IJp5ghFfFLArBHpuaJLgEx67qOfc5NFrABhE8ncdKgSwZAilZ5bNHTSM+q+qr1TnVrU8KTnmD3FLXX+utxmBiuVnsNDai5JzyyOAXoUU+ikZzfpLvuTbvcij+oIfW/LfFWOb2BV7pYQgeIcN1Tp2d8zP0OJrz3fdK7tW7aUm1Z7vuFpz/WnaM/dTHvu4Ouurj2Hxdpzlzqe9hzmteeZas91UJhmnvbcyfnZobclwZPa87fd/pCLNP7QV5yzuvP/t7rzGdadV4gz/quTleff8tTmX/TSP54pz1xKFkZ8Upzxo49qnPHaSXHGa1mcMdLFccZrRXHGqAKNM4a2+mGKM/4ApXKRz4wzVumYdcyO6JhdCJhe79DTb0wimRmjwcmJBif3s+DkbShCqmPU8bQ7GpCMbmPIAcnIHYlcdoFDNYxLqk768mHKHerK6rapIcldahaHJLPq+mJRyYNnRCW306jk6spRyRONSp6eHJU8fXpU8uRlopKbsJrUK4hK3oNsNcxrr3tweKj+xRi2fBix0Ew78OHs2QjlGZ5CnwgCV8ROnBqij6uPEI3wBVy9oN2MtqkG9bWmkwnqkyanEpjrXovbppJ7JY4IFwYqwibugn3UQXbBuewCpj9GlSeik3eLUJYLQZ4gPUmjk6cwp/LRPtL7K0cnj5ejk5ukdTBBwOUzH3aO2xU/naizNYqcOhvROoYy9k1J3HIVM5KqZA0gzg6K4pYv5uKW906MW97LxS3Dfr645UtZr385y72S5V7Ncq9lude9GOfW06TZH19Vmu09Ic1yD2raGuOM+JC26dnz2r40W/Ol2U1Isxg+DHEc6V3TT6XZGl3mSgtE0YlSfz6aK3PvL4XP5nSvHdxqg3agcG3wjAnpLodGITVgjQupEWtcSHXQjXMKM7mEJ3cJjWRRG7LREaMBI1vuwuiK0aS2NQZiVGE4SWAd1bMkzQa6tlrP9KoJNUWvilSaDfLSbOx7Z3XNkZdmy8nsmdLsGH92ncv/wHPhBrRLM5FmD56Uh4InpNlyTpqdOQf8bq64mZNmd73iwiJptuyk2bEnzZ5fRZqt+cshfc0yAVUT2hGq9jGv7Wfxns+UZheQZhfAplXsoEC9aYt9y0J0lEqzNbqqEB29JETfEuC9lUJ0aLPuM0Q3bOpNTm3a1IJTlMLWpLB9O4XtO/j5EobtgIwDJ4y3HThhvOPACWOo4KS2NVSATdjYdDotDBJjG4YjQdcDdH8J0F0f0AkDWvWqbUpVibngvqFQ31eoz4CAsboPdinmIyv27zooNJw0+55zGLyfk2YD2qdZsTSrBPGl2QPafZY0exJZ5j5ZhL0BBPEcWfjM90SvHReTZUyzZbLUi6TZcpE0e34VnauILAPwYuDIMgJZRvQWMi3uctIsOWmWQAxji9i0xNh20iyiFZUY289PjNd9YmxKf40xQohhEUmGSTCyKeJUB7Dj1BAkENqoWNOjvkN3A4ZDd52NQdZd92nkGAGj4xgBo6uM8KCeLEG96kN93Yc6QyF0HTjFivLIQ3mqcmbS7G6+c3eQPVhBmh0XSLPv+tLsWGCzS+8+U5qdPU2aRUC0D9kD7t+BXH+4KJJmiyB7/MKQVdlBIbsNHG3TJjI3iXLS7Eik2S7dRd/o4DVQaXag0mwX0FmnLkuzSCc2a8SA6qf967ZKsz2qulE9ZCNxOGtnOm2djXXFmQeg+hKAmj6AGgyggh5xefAPnybNzlaUZotqVqVZrdkBZqMD6iLTVsgJ0iwqaYeL6q0kza4WtMxibRchyp5Yi7ZYz8Rajdnqy3JW527aKE+4vOsaj5WJtXFeNK/5Lu+ma6aJNepoJk+sDZdc3tpc0snzIJfsquv7AJkYE1xIFtrJd3njqiwkayKj2y4dIIHxSUOyMLKoyzsrxYVk2QvEOjr//C7v7MZpSFYZARrs1D32o7PU5a3BWd5b4JnLWyOygpdzeYfq8o6B1JoiNaaaRDz1KfnoRh63PiEjjyvwq3izYkeWB8k6i7Xr1Kd2Jtb2aL2YOdUcc+oqFsWrMKfqM6f+sWfOKXPWlTnW6NL6A+p/1AOKW5+8AcUX3Kv+6/hK68o3ai+LtevUTQOKu5VT/r0i/APlfLH2FR7Caqv/eEZGqG4WJ9wVsbavi4JMjknQz7nJItaEsKkrs9V11RTWvTjh9Y/fOOEEhq56fLHWjxMGzv+Pve+Ak6O48u7q7unpmdnQi3ZXCwv26z4dtyJIS1IySDtCgLKEsAz2JWzwHb9d+X7g7GOlFbZsZCP7hD/8HZZ1ZjS6M3LA6YfPwknizkHOcsDpkpztzwkuyhj5vvd/r3q6Z2cUEHJewU5Vv0qvXlW9+ter6q6jbtZqLzn+Zu1xXxRenm3Wnn9KXhReTuefzIvC5zfZ3du/KBxD5qZ64JuPzGMlG23GXdUcjGuj9d70yipj9LZ2V25rj32uCu7/9qOXy33QXnXGaMyP7OCOdeQuMUz0Cgk3CDAaUKksSO9+1xubkSVursaF+JynW/2j0cS1CV0ykkbvnQ8rrzPOUe75D/Uq/2iuG+FydDgGDsfHNf2kTwMaS+kQWmhvqJbrmDvUR4gu8QaQwtVsXGQTqtOhDmnYQOWPjnq5+ADuj+fYfv6+8A4mhnqx9N2vssTGpeC339F8KbiKK70kGz+u3pTtRlsRVQM0VCSa3Z5dqeYk7YuksbbnzMdHEV8vuo92oMEr5OKV2UzgYMmv/Mw1bq5qRVs1KR8dANdUR9ty93h3Wo+fhMg9THM35zuFmHnDznyBo4TY6AA/0bvw5ermcAkFGydRELbIukdziV5tuyCsZ+REr9FH7EyHVNCVMLNBITpjgFHHP0Nj5IxiXIBTjRxoP+VGHF6G8hDNBy2EKH04fhKgtQO9wNsgXVSd4MaOYLSJfgAGKYhDBjASPQ7ZpYIIHN2Ua16hYtbydxjjpcKnXL/SanvoMnoTO0hz0FXRaL3suNLHIuHfI+xPs2PSjq8d2oPRwoAXdLboDpELBkJs0ubnEEqZeeev4t71v2p373qw+NjXr/tjSTAWe8xaIB2cuEly16/7x7p+PWCSXrEud9ijAyGeOD4cCYu2H/P69Tv1+vUdBsMPTSAdqKh9MExHYZFLhnJnDpGND18BvoB/oruQB9jX7sdOMXqdjnebnSgvPBblEfwVr+j0qAgC5M+U7oo8cNmhHdaQHXuuYY1VPeSofk+K1Q/8lK/YR3ZFRPClFx6dub8GI3LfvxTr6NX+I5wn4fANFP//lZYzhEwbCgiRpY9KLTQpuo8wG1aeLRm0Ve+OylFGq48+q3MGF/RaKQgjDkSfDKZUNB0eXDwkhjNvFFgZllKEo+j/5BRKYkSvwt+R6VBO0O1UD9/G4ol+fpu0a4IURvt2fsJEySrQJsUbPk7FqzPdX6KBuD+COQjfPEtHUSizKGgReZZG5C9T34yYR6zM54VqzDQ8YCZmEy9vEbDr/UUSMOAhbkgmjA0m3Kz6KQRuzSvjgFFB5aaUeU9me8WfPvy+LtEKjQHC4gaB6fB7qvhcGWdQfBjqKnajo6qpuStXoY6Rigy4ARF9xE9LQgbwWW3HTKnkQLI9vEJ+5Zs9xWl80szlP28ivDW0aioJ4iJXc7MvJ8zCxtTlzfciK2Z2jGAvjMxSAytFX8CcFHvkAKGNVsdvgWYnTTvAQnXzEnY9tKxK2IWEfUjYJV8l7FoJa5EzuCy2mAfkbsDXL74sBZWZePGoNGX0P7eBwrEZ41vSYy8FCdXHoygFXunioBq7jp5XACDv5r/IzqiIM4/TUxT9jR2tFYzfCEBc9WQPBB1W/9MbxWx0aXIazrAEtrRpVn1ylox1gPigRqM3Sl6efmfEHYU82MVM4nKdROv72o/D6vc44x46bYOtZC+T/plJp1ULab37mHQQJPvcz88fzj1Px6jHYjBD0zJh9TCnWCXujU/PheAAOP8NYvcA7A2iPvi+lXZRvLNY9QG3w+RMsM0kWObNc5OzFIajYtjRwoCrR18SFs6k6WlVyatx4On13QlqzYz1NC4COAP1RznysSWfzhK072J/12ZtZbN3N0rmHTnMjjwIMaUsGxyLC6kQe8jKz3BxsaEzaACHUez7dKchjIytdO3SuszVwjkaCv3BHbWN1c1M55Yk5NWl0ijGJxf5uY3NxNNQE7m35ElSXxhw4AyKJOUY7xly2v0MlSnz+2Ri56zqpjhIS6VBHQpsLCmjJDmedBb8OF1EREc6Xnbg488Z/tNvLUpdDkjV/bzLUxdHnuIG+R9TF2QCeYTXQD/dl7p6+Ikk5Poznnn/wQ+mbhbyvJu9Wa86fff7U1dDkoQS4Swt69C+1FW+rDZIXcmMiMPI/kPeX5y39UPff3TPB1NXkn74Xfd/8I0/jhemLicV+n3rdm5es+m1H0rdlL6975On18yjC1M3pb/o6gf7Nzz4tH2pm9JXrse/v1uUuqBrndjYT0kLk+MPffYZC7767ctSVzL5wc5zX/Wdbz/jQ6mbZr7x5++69ptnfWxh6qb0h575IDN3zr7UTelvOhz19PTctih1U/oyYe4j+1JX6Sp4bl9jB27qJjOOrG6d+7l1vmSS3z+yLjm7TeAf0Nk4KxfTjCOf4RJdS3dzWRIyOLLOXsSBMTlqO2jCdg5kzGeUKNFs2sSvRhiWPhyfAnz0OKh2yYbAoCjeQToDY+kMHZsVVQt2MA1RWXSuTM16jyxbDeUjPjq+zq2qre18bwR3I1RLHGMWnUPnyznP2VWDoQfbpWp6nDJ2+WxuOmJxywgfROUhyNvmSNJQgKwx+C4CIT1J08IKKgfHXfkUnKuHZMkSCkxIfDtmCdOTfG06d/AQgkjc1HZwFowiLBSZHM6izpjhAOiByCRo0lcVmkUDqHziNiYs4HFy5SuDXfYRRlp6MvJFnqxekN95nA8bDc+HYe186llmRTy9sQ4OMake8MjljKMaZniE9zeHf3FyeF9z+KHJ4b3N4T9sCmfatDmuNkm6rO+Qdoa8yUAh48Hgb8UgLEN1q4d7R+oy1+6tKWHk2SM1Ucvd6F/dFEFs0l1IMUNjwV3p458MpjvR14SXJ7WjAtgDvSrWbVmzkcECmSmj0Rt0MZwtOUeN296SgbqmVovMlMGopWG4OAyiLnaGBOEq6DuPvEx0ebsGR8hx+g7PMxPBuJmQVVLskTlXRp/BnxVi7C/Z+QJn66XfmrspLizZ8Xr8e/MiYGRvROMH0Wt0QVNPwiWf/hT+hSM34BhlEL0VIXGJPAp1bo/uejUoIVZMtQb2o2BHdDcCdi156QuX3fQPv3/pZfXdGpV8KnH77apRsDtdu94wyF0/sMw8sqieBDanw4tusKiv8JjHCBI92IVwZiRlcqm8jJGhoOW9ORNdeIIVrCfF5uqFFNTJT2tZ50oW85Xcldbv8hFmnoLa4+I/O6TNNTGjuowac4G3yWDjBStB+fuLhCFv4oyllGWJO7jXmi1P575v9u6OfQF1Lnk81GVREe0Ai7Ks44ft+sBe8ndwJHfZ4MktDOuPd2H4FClFl2zGrlnHqi++ZYxj/QLWiAtajHNYhhzHDKpWuW2n0jCEQtlvojc1LEDV4bxl6N7jWIb+x2VukJ8UqnJiwbkvWNHppGQ/KRDsMkxdJVR+1NVlgMNEHs8ZAlpN+jk/H7snvioDQx6WyJ5MMMxDZoouWKxrmr8CmE+tdmfbk2ESySX31SjfUqrm0pLcR3L2RO+0ZgNPGlilmFV+DNavF3CFPeI/a9yCdfwxNW5Fb3yltdv6sd9gpn3123IQffp26U23G9fcajaRK296eGyx9iIkajdQ8hZwf64XseMB4EwyeXsweatvaK47pKEzsGzNWby9AXWGlDij8lljwhO0DQ4/J7UNfuktD52DobFHrWXWRKjrINbIma0QaTz0EtjhQjEXPsRpWfpveegtfWIsLEZvbrIUal+G+LkrW0Nf9BbtxygGj2/N2fDcZhtey3A+KQX0thYFNLwhU0B4mKSAxngc6XCUMZQOZzLsQCWMVdc+R5J50X3IOx3kDky7Icx2TFC7nCcVUhumEVOHOr46zVawt5+IFczuEqHVmhXa8PF3ibQ10BYxP7IzaZfoHQhHVo9jl2gt1OM72u4SLbaMYK7VzRLQh5oxHoIHcsFn5oMrFyCLvERsI5k0DlN0Q8haVI+rzpXftup8ztEKy/Zz2pVY1WQ6yxg0yv3pUNJeZKK/B0HtrraTS+kwg3BOLd18v19hTb7JTBj+g+vxX2FT+spmdbthw72dbDzk11H1q6nGx5tqLnJOCjM9JwmInTApXj0Yh+TDRC3PpXthuykvvoWKG+MKO8HGuENkhq7bSUgbd8GJ4m44A3GEA9QixWCut9WwW5nrbYbbMdd7MTvFud7N6tykxOs1znWaZK0+LdWwEY05T8OGlTikUUiJAxqFZ8nF6LURm7H09a6ZQOrjyWkbk2kcwn/r+VVN6iIm9C6OiP+uGUx6n97pSLqDzihpmmg86duY9DO1H2moRPIY8SOn4PjUSX1M5V3t8U3jkNConZnK7OGCzDiX03sNOo09v6sGfTW5ooKeTOxPlR4De9B0prwZDYV53xNuMPFDaSo1zKg+AShM16p62Kt8AP1GWg0/nIp9aNrq5vvxGqhtruh9dlxvN6o4m3CPaVYTfop7znayXBxkbnND/rKt+ZE7TijaRyXa675iep7MlxmXJ1wYgG8tSO/1+VLj0q0BP7sb3U2FiaZXjvfPbn3leNv9WxqvHGN4bcazvkesQTL2tsJb0aE6Tz8VvPmc0Thkdz+7JTzPzN4wNuLVLb24IwvszAK7NLA7C4yywB4NPC0LnJYF9mpgXxbYnwVO18CBLPD0LPAMDRzMAs/MAs/SwCehSueOgqpfQj5f/QT/TPXHNg6MC4mNA//vMSDpjRkx4MO5v89LvPhsaX+8MKavB+F1OEiYRboFjs420sp/MAr3vGQmDbFVkee6c1hrEP+IXEqj0ft1smpkkZwLr2STnAeti/4iDURmg3SWIfzG56f5x7PsK03nyF4GNNPs6vNHuzzXOKYC6kA8E855chh7NpbzFA9TAcPqAgRsduML4W5x44vans2+GIe3ZlKR4Kmlnu2pZ/NMclKFKCouuWTxxMvHkzl4cPATJXOFMo/m0LxrBjnkEpqLP/ZfQvx0zWA8ny6CjWkBzeJEi7vH46fQhela8sz9NW6CS2k4OzJywe7dTLqMZmfrMRAWphZiNkBhkb2rKYdFiwXgxvMWO/GcdGfBiu9csHnJvckIBsIliwFyu18WzwXdeSAZXnLhTx57/Ute+rVFdc6nCmoYX0LD/LCYhmkY1MvtRzKLdDnXbeZ94w8c6W2WpjW7JhfTxQ1T1OZS9kp3SU6lzaJZ3Db3wI6Sf0lGuyfNhO6exVRaRJfhhQrOQTNLlrS5Z+8KDmi1SSdXIv5V+iK0zGyQDP596wMT43O9UKlOM9XRUUGzRmkJXdVq0k6WorBHmBFaAl+LyTlZlprfLqYqR6TFLIiOVLKpa0XTUfuHH/x8xdL756cuiP/BXNNVHCPmyh5834O9P33bGxalbnxxNbRfDTgIG5LYBGkJhA224otTed6tVr8nk8jxUlpIV2mkDu1LX12Uumrk1TaDKOlKFTTq0F5E7cVJENrFzIsVEboAsmsIZCZMsTNpREyxc2xbj2Dq5LUiF6PjZP1gzGEzvf3n8vM84j8eOfNkdCfL5c3ji/AwQ+YYJ1khpJXcwVY1OtgqueP1QtuUq9CbVqvxdAmtiGfZPrxS+9lsMZuyXDcXIFgrS5pFBQlg5kWom/V0RLfeREGzuapSqVnQvbM4qy68XI0q4vPIEglpmAuitHAUTMvjWbiA+Rdc+CpAjlU0YkcVOFnOxa/hMlTuaxQfAcLN4l6ivgIku9XlTERX4hxt46MZM/HmuVjEqYDfeIWV9hqR9mrOfaU3gnbQCSe1fNMKuXF6tbQDBLEZdUIUZtZeSV0QiSyglczHBljRlTTTqoojjgyn2VYqzR8/yI6mcmYFvSQETXwhlWLmGfW/SOp/kRVKtQuRmaGVYEjLz/Ezmwu+kArKLNom1V3NzIA3eI/JzOyUmdkZMyv1NfyVaCyub3a4dDnnSDNsOcja6lCahTk6R7ADFkU2ny1dzh5uZ1qDeq6xjf8Umn9tJxsS8Aa99khppVmKJSAxjAadzzER4CekS8ZpVvQBnrjBO3ct1tYJX7cCZ5guoOEbB4lPSQ+mChy9jx3UEWXPatzYAoYupEsAh3kuXKfvXB578EOv6L+JeB7YX99pKhg6yj8aSHmXITSaXAjRxNw9mIkRQAXC/MaReOQgCNcdsVd3VJi/CeZPYPmFdhTNxiiazbkFk0ZRBVCaBaIF48Hv2QoECuaYzmcFE35zW6p6Pm9Sx8PalJa9guwiu7sTlhex1NhwOwxpZS2GL3zPZ2nPuTfhMTxK8+5NZq3qdDH69rg0S1cVGHljHBrPQiFOPMwF6OcWsoyT4awl0iqqqAvnO1F8oTvCtSxzkTI+WDy/HaCp9wmDpt4p0DQFmqZA0xRomgJNxwZN5V8xaAqnQFPr4J8CTeVjgqbyyYEmd+S3CyZFUzBpCiZNwaQpmDQFk37RMCn8nYFJUzBpCibhP67iXz6erbi7LFy6+2hw6aoUHF11SsFRcExwdFkrOFo4GRwtag+ObA5rTxE4WpwHR5en4OjSBji69JcCjtbSwuODoyvbg6OliH/FEwFHV7QBR8uOB46qGThaDHB0+UmAoyu46FMKji5jmHnFCYAjiJKWPkFwtKwZHFVPBTjiDrRau48OWz550YOZZ7mnXXs5unQOM81SGGVbczU61MocRHlC8ERn0haI0qpcFdGlrBCdOg7iEyldJ/wCZkJM+OgJHGIPinJMGtVsLSXTrT6mt/Qzf3mpFqqHjEzp8hbhKjueV7NSmyTrFcgUpzhQ14KFHCv1ex0zwe4qmsm1czPsgVp/J621i0+DSq1pVApFpSGvtNIWdfhSu9kpBCJwAZm3MEr0K+AoAwergRhWK1rh4BUNiLriqBB1p0JUzE+z7SQ0bF2ybmTdBnANAFylMZZL0yD/oD1wtYh3eQpcWQz4fCg9IdzqOpMv4wYKaIdbwwZu5Qhtcat7DNyqvB4ft7ZlphW3hhluDSbhVoFFEGMhY4dTGYxfsMKXC6L0DLqiw/AD2Qe9wFrbCAUyDkMH4QKfFHOToYQVqPmKU4pkz+GhejUV4Kyjq2ndnwzSOkay2TF3AIc2SJZODZC1zKZgNh1sMxXEtgewP0gHVzN+ndk8ulC/szjGmZy5RvDy6NV73OgVn+9pha8++gq1oNcwRa9eO/QangR69YFe9UsSF0or/CYiV+dUIVcg1hS9/kYg1ynkOoVcp5DrFHKdQq5TyNX/nUGuAyeHXKeQ63SO0f/bhVzPd077XQWt4UmB1inQOgVap0DrFGidAq1ToHUKtPq/NNDad3KgdQq09uI18l8JaA2OCVqDkwWtLPjg19jSes1k0PrUJtAKlToZtYLWDFtBOQZuRTCA6zwLXOenwBVgNgWucy1wRb+/P1l3+aenfXHhXZywgVTX8cPl3NPXgXopOot23XhWA7HOvm/8/iPTUsFtBmob4f9xcUU2Ytsi1pkyrO60Y2gyYp2NaeTC0TxeRVaAUa0XtF3JASCPrMj/JUsRH3g1xaAXNjDoyCfzf3r14bcVgyIr1CT/l1St3rOVmGUrgG8OsHzfdOvonMnVAFj9tgWrEGz+z0ql4/rF9c78H4jfVbD6HQGrjzx882X5P1bQ51mw+vCjAKvQ2jqvgn+MeOXhU3oyJ0GVLVRFlI5/6v74wvyfqlNtLEiRIDMLVX8PiQE/rXTQnojSkMX+ExDGQWXEYqrZIM62gLV4sbv/3HhOhealChHzUHV89GJWs09ZH6+h+TTnmni9XWtJV52brbFysOQiC0tWtkKrVTYIM/byRvdbXg0aZyvx5DLAgiwBJU1jSl6VAzOrTwLMXHhseKXTA4tZi27CURflil556otejmlqeVv45GbwKfndgU9T8Om0tvDpqXTNrxl8Aku/eEzUwzGiBiYCEFvDa2YoJGKUNv+XhZLmWZQ0/5SjJDuUL7Qg6CK4A+hkkpMCpQsy6FSQ45ce83biKGk2usLsHErCA0v5RFHShYqSZuKK/xE6RwbmmhxouigFTYf3WdBUmASQFtIFGYwa3j0ZNK3MgybnxEHT+l9/0LRoCjQ9UdC08NcMNK1vD5rWN4OmpyloutaCpvXNoIlb4qJGd7pIJxFm+aLGJVvxOtvq+nR11TTMXcxzA5KsaUASqHMqsOJMZg+qLei4EGXzZIhS9aF1MQfKDIw54CJab7HJdQ1sct0vCJukr4Bcx/JIng50YuLlR0UoKyYhlOioCIUn7uf+4hGK9ytFKMtB4+zl3aXleYjy9FOMT7pTfHId6n0drf/NxifrBZ+sP1l80sUxOpvwydNSfHLtLxuf+MfEJ/5J4RNI18fs/0tDG8eHGQ9PwYwpmDEFM6ZgxhMzgeRhxooGzCg0wwwOW6VvU9qtwNXsOyHAgVinGHMofVVKXwXarw5yrMhDjhW/SMjRMQU5cg1Q4RjlXzfI4Z4qyOFVfiPfKQ2nTuZPHXKaOuQ0dchp6pDT1CGn39lduuB35mT+4NQhp5NDr2dwjNN/tSfzzak6me9WfkuuIhh4wp+LGzj25+KmPhc39bm4qc/FTX0ubupzcR2/4s/Flac+F9c6+Kc+F9eRgiOnHTjqeNzgCPyfLVfOn01DaJUhue5pmQQE9iKyB0oFXGUXTASb/PT6L19uBt3cI9d/2YhygZ1BOxXhhEl4dVIaxM2pKLPMzuYHWb5opw5y404PeKMj6UK5HXqBaiD3ybETzvVInQEK+Gq7cGPSjSvm4C9uTCLcMxcQOxE7HBKqczhS6sORJv5epFkesvSv2OgHLf1AtJgLre6PRqkDys5HNyOHMdB40sNFcmi3XE3XDaJDTIsWRxTJ7XSR3k4XUCPVQPOFdiCFybSmO+04DXm4nY56qLtxQ51P0+CJ++Tq0j4QujEeuim6xt7TXdIPH/MgjRZ3xz1UjktUifshROan62mcb4mT9cTd1J/mw+2PNvchf36UodHHOU9wzmuvQMac7VYmlqiHiZxrvzz2U8Slo6rrJJJLXdUKszmdus53PvUzxhR69TAeP4DHKvQZTSefmaQg+qBeQglwqD0iLlIQT8eVnoiR+ACXAeIPxtO5O/Rz6AB1xiVWO4c5bxpADeQeP39UK8Hch2Dex/W1/CNDYwA14pQlcUvM/cNmWeyzG6ESPpjXhj5sO8Qh66IjgL4/yroXek3av2zXiWxX4cAD1t1r6e+0Oe2xOdUs/W4bb7ulb7XxNssdiLjVnTtb1+PtbOg26E22szb3uCya9D0Q2Ikkr95ruc90U/fGOOI+17sxDrmrUe+9iT/GPMgd3j6Y6Wc5ojk/rM15CxpAS5R+SqeNx0VusIi6qW/wXkzutguE0kk4m6J0ZfLtHfRo7BLaeaARQv2jVEJYhSJ0t0g7eVbdItejiHqg0zf3nwp1QnJxJ5XFLVNF3ArpxZlFEm2T+IIcC1Z1fdrHVeiNWwt5C3cssWHMOgrgJVYSULDJKq70cZxc5kGm9OImpnhP7zRUAKPDCTfmiPrnJSWoK/EPJWUoJfFTUoGyKnDq0tP5p3ztLQucP5DnEM8VPJ9NLgW8HkzC8ehDMouWtcpcGqW0hFscPJWQFRW5hUsUUonhbokCKkN8IfoXT4qhnb862B1mQbHDN/Sxdo27md8O6tCrRG10xuiLJ+JAx7AdvyXq1DicN5cQsMwpAJjvRoeIOMN5mv2QZn82sndw1z7LnHMqQCIBnKEkXM8Zsm+EGS5AamUhLJ5QIZUpxB/4gJykSFSLRVuZVA+uQBe0nDIX2npw60CeskYDk8wdqraRJcJzRhX3GepkF+2DHCvUhTp0N9eBme+iboG/ZHS9fQ0HFjkT7u0doj6w759eyfnPxtPLXG132mzGEp8Mrk71ycVlqeJcRyBCBfMwdDcmBVyqCr/ZmDCrN3EwO2vZ4ZCl6sxT4rDmMKQ5kBIHNEqkxFCj4PxG0eUyICzyMIa9nFZgNAcRGTyG0B4+NYKj5mDnGgyvYuVzrilNtFxPi3L8ardgFjcOUCr7sAbGxBXyM+sQ0b9lKsQVDkPbVrg8xv1mEJoCZyjKVV8H7QTGbAlzfqnqq6mWCV4ccsowLvFTmX02TypjzUEVlGXngRLmgZLkl5StSSCESYsLRa6VRq5lCuKS5kVlDuB1QcT3dEdMgN9hv2OnDuRHyM+egghkxcj6G3eCldjhJx6ACHJRlsvdYlxvR0eE9I5xRGi6w/ViYzZxG/GsDawwgRvP33fPY4HciW82kbP+vo3wYxgr4dr7xivbT+WV9B46NnASfI1aewxLY69xLf3+7Fp6r0IcPOla+g+6pniCl5IPNC4lfyvfLO6ABXsbeXYJ+YC9hLyIESyXkL8FccmTy8jlFnIXI/fBpovIM+YpsFUqoCJyKXkBPGSMyP34Nz2nOrCBq8l8BpiIPIwmnX5cKz+k60B68YVJcY7Ngfl19ebvgtz8zU6AeOL44iAs+ofczefF5pvPuyvRP95x8leef7jlyvOB/JXnAy1Xno9IKdokhgw8LAZOdjOZMQjp2NeSt97UrhcQazs2X0A8kN5T/lIjV3VDZJGiOu5G0DLQphsX+6/AUziOx3CjQt303JkTu+wz0CrommIkxvh2ZVqXm7W5hmog1uu/0UGI25MK0sHI19vNX3bKeICKaWYhBAv7nSYe+LmVifcb15vwxlMRYyglnmXpSjsGkKPIn4tB8ekRR+5smRcq3eOSENGpTnBajHKr/xJGI3VW1hKno30cwJc65m4joyuo3UOeRCRnw956LSmghh5sAl7K/HoVoHOFdEMvtQjzxOurXP0UIuAhxPDwK/CirhhW0cdFgbAfQvE01691hu6EGeel47jcgn5r4+7zmjfp7vOtHrvcjbfB5UyHyChARn0KDeE8MwkWOLcjDuxGoxit+w2eUL/Q3nu8xcXvZpfh7QtxbbGH+efDHA2blNhdCPka5dHqXgGp5C125KpzDv6eg4lK45EXPbjVGsXJO9e7KSkJF5u3zKo+m8WUsqkcluZ72zkHIJglX934tf86+O8fWnAD++90h8475w664sbnPhernnCBs89g32EgKXFoag2usW+z4T8x2nuOc/NCCgeTcn0XCrX/nt3JNeBEO16Pf19dVKcS5QQziGZ9p5XFDNUBvs4XlQ1JCDm4kMPbjFaUKveRf1/jtvkZKu+KAAR+HibxRl99JWCpj2zPBfwAsmUguQm+IfGNv++eOup/veZVgWypcq53XXT7FoW0HjU1U/G4zXSAxV9saiNiZGFr/sCiel2bKPoamNuNil+nF48//J7GxePb7UXjH5bDgQ4a+XsS2lYLe1/RMFxRLplUNMO9f59mqFlsxXO7LJJOzuRwmskct6YRUyvV4UW8LFQScUz3b9WP4lCEvRF9O7zQ9QZtS65WIvoEhhbu5b4Lj3tlY9PAHqC9Af9YJoiwXSJwx0m6lkif+fSnqzegs3Y1els0Uocw6zUK99YtbcZI/YbY4P575ufaqlSDfG1xt9HJBkbqVSYdQmgd7R/ix9n0gA2/dKReW3L+5Wf+4BtzzlgkUWtfum0rt0/W0Snz3jjYoG8focx7w+BjbmIAaJYOErtVZ/lg9M9oaGaPB//TyIPU1rPjyGX9eREv1dE8os48dYb1Xv/vGXY5ybfgetXbPe5t/6n+eex9WL3D7P2het9m2H9I/fuhGf5Z/e8E/SvqPwD6F9X/EPwH1f9l+D+l/u0o6YD69xnt4/AfRJz9qg7ikjLXISFbkeI88R5CpKGsrBkNLqnB+pkZiwPi/Qq8veLdhqyirLwwY9UX75dU55UaWu+TshAtycXxmDe2eYmYBziQR7kD+jAh5rm8pAMF+vF8Vso6PajuHs01+W6OU9FI+4xGCq9IY/p2zoIAhlg5xVhxgx0HaKAu52UcQGtOBINlqLvRPIE0MFY1jF4NuBI7KmwqRd+A5uGn193BYEap0Q7EUd2HkNsBc94gNEuNvq4xWAavUfhTjTRnKkcPbZkU9hlj/MYi0BtLLaAUNM1MwVFnphewyktKDaUXtJ2bAmhOOJzBQFKsQjBFPJx55aAm9SlAKge9I01V0NyQjNUwgA2SLCVjZU1+9H6pVsCcpwB/qTGMXdKJn0z0KUGfHmHiQR7Rp0HozEnFs1IxZFKpkFf5mu9j0jeMhbIVjNFSLDQS4FA16HiNfiIg3VGgoZ0jRLfwuOdoQEeKQKx+MlY7/hi6IRHB9nIKuAPs1uE5kz3RT3QKw3NE/gIHDLsYNaZ65mj0MEI1S52giHmLPnNHgxr9u6Qv2Kf/kCfPPv2nPAUM26HvdIJJ9XDiwntIvFho+CsG0238oZFU9a4eqSGlTD9JgfVyBgrwWLOPtUvrdSHI7K411wGU8fxZbbB7ABFrNQBAHcNWDkz2MBXfkLiDSVHHrWvH4bDg0cqSnS9wtl76rbmbpDGK91BhF2OvF9y1aPS7sz9BN6rJFkzujgvaKBdLowB+FnQxWWjwL/OOVsFSOLvd3KBpK8dow3SBCd6OiYecwXqt8m6X18XSGWI37RdcZXQZi1XTzBvKKERXc5fy5pBOHHYVHTG5qcuImKKDkKE8WzqxeyMSQ+7cjD7oLmtsMrsTs+SxNz/y+VXPWruIGl6e2Jb8mfz7Dk/KLObj8wU2bNYZxkkMp23mdQhlG2lUpuTAQZYhq9O0pMGlgOh+5d3NtoQm1I05gsuRys+LdQzZkRIXyGuLlGRxBXMUHxt/wQbyokcxBoQ/zSFCDsiooHMaykoX6fD1jur62UcGolk+J3XwMmvDp73AsA7BH69LUj0y3GS5Pdc7aJIgh2oM1xs/vMipiUBEEhuSouIc+tOau/jGTidbaIXo5LriKVrFpwZDMoJ9Gj2fioqnS3+RlO/DWjLa+IAssmDYpdKGMSEOMLFClXrtHuDiRmLeduuoU4U6dlPAP9FjEFfa1cX+il26MKm8vkF8Zmc+AoKjpKMpmFAQcTH1Gsa5D2wkkyWUPqygvIsYpjapIpZkxZxIllmz5nA6+MKmWbTAjUWBTKJ4mDFafd82zKOg22kUUtKgO2/LT6Sg23mU/0tnhW8EvjdhbkVjZuu/tC2pkCK4rfuduVhGFXQKZRBt4McQD461ZvhbjlbdgwkvN3dC9Sj0up49NQ4tIDT66h3K/9atrlowErbjbEGhAWgsKCxC+cHB42MVZFTE+lRz0RUFqICWhxkdt1kLhDxMvsdBQKgv1pg3czYggxnD2THLeeC62Wi4u81o/LXsEACtOCPqzFNnmJ0HOc6QdUmTXKc15F9K4ddL0LdYpLratCRWUOqtsZZhM6yia111LPn0Uyb+7I21/16UzkMjPLDcqtHKq7KxxaCpLVmnYLNkwbbhb7zmJVcsFEiLab5BuSEt07Hz8RlUwHJ/J8S609NpWHPOQccgesSSt8G4DI0PI931SQDnxqSIiSdgQwapDyZNdsSc4/AuIRmoiRDsODwgjBpwKuxEiFihoph1PIk130tzSFPzCM+lDjS1SVMbKtqT2xh8mgFGYqAmJOxwAKSjNaJvaTXwoqMz2qB+vUE9lKN+F1Qr2H23qaj4cYunA0IDtiMA/gZ+u8CYdhYcbjwAtc+3sc7s9yvY1BfLjLge/xU2mfHWDQCdLXSbLbUYRJy1zwcrCrphxE6YFK8WtZOegUxK97LRIS7LjmpcYSfYGMs49mFB6iSkjbvgRHE3nIE4Yu57sILDtsdWw26FhwfcDt5kYaeIwSTOTUq8XuNcp0nW6tNSDRvRmPM0bFiJQxqFlDigUXRv1kNn6tFDT7CEdDdv5yfTqKtpLz/p1RMAsroiTcN7K30bk36m9iMNlUgeI36027id2NfGCQDs/sMso2f1qMweLsiMczm9sutPPWiwHgptR/VlyUueWPmf2kDJ05nyVjSUTul2rRdhEavUMKP6BDA6Xavq8QwRPYDOIa3GP0jFPjRtdT/sEWlzRQ8hWtPextlOFgUTfxoViQGyoy/fcULRviLR/jU7ZFKYdMikdIKHTHw9ZLKffsFnTEKlPhzaMyahPWNi6V+x8Q5a+oFQz5iEv8IzJm56xsQ95WdMeKUO5GHRRh8sEa1nTD7s5M+Y4LHtGZPy4zhj8qUncMbk0klHTLQOzLyvR0zGRxP+0SMmqBCOmMA99hET2x8OWRf9APT9Yf6ISZg/YqI9RnsKjphYd6+lv9PmtMfmVLP0u2287Za+1cbbHKZHTMIneMQkPEVHTNDf+qG52JPw7Hp60xGT0lGPmJT4iEnQ7ogJenLCTXTEcYcZMA2T+on9ZP0R+yPrly02dIl+9IbTbQbErT9K/U/kJEpoT6KE9iRKeLyTKG/ONtdxCiX2jrqt7ua21dHn2m+rB8ffVme6h5Tsg6QrSClZsmcIaVGU7fqcCCkjpOTcIuRWRm7lRm4lHkBl4cPjDFS4yMUyyYk5B35IN9Ddo26gR8fcQK/c9vg29Nxjbyqidi4aqHVP0T/qnuKWU8eCvvenPLTbVPR/SzcV7w0KWL0X+a+x8HtnKWcqre4MRgm2xjv19RPiZV4twO/OICmOVUvLwIJ9reWni+o8AL20SiM1dMfqngBWU4wQGIUqcEIc7rH4EuLpQrPYM1ABloQYY1RI6+XxQ3cSpY9uaq86xKujHrTgrhzhtCXfr8TfPfK/P2G/t4s5fy04tzZY6iGvltJSPhseqd12rhfcrV5SuHIQZjZIE3/LWK0qdu8Fn+TN9/YE7CrHvYyVkiJ3DGZRS+OHIj/sej3v+iEeh4TElBCUvYGKJi5YrVJG/G6CRaZbanlD0j0YF6SDsodlgD5ZtKMfpTCtF12xl6aBhoNgnUzGZEkhI4vTalxZFkK90SSvHNn9mIckxb27a49xBasMyOQkF9et8EIOocLzqbhhb+LV0FnSdAe5YTFgpqHe4Joxdg+wy7new5gn6jXq4JJVrNpJ9pSSIoZkkcUSF8BYyPxW0NrdcFiImpVUvhPLF6khKiBSW/LDq/c+6eU/+BzvovZyMX0ilVq2H1bjHu3Nh0ShqtBbbmbhixymQVLTrAaBmSxCnbsn913vBfYItXbzOe4ebZN07RbwUEhx9KtcF2swYOHGERcXayIZ6gOxT4YX+C6RwQJggB0PkNRUHTFjIy5JMKKfCZoLgwCRa2Mg9Xkaf0jiu+cJAfGHQHM1hisxkN88LXskLXuplj2iZc/TvJZo2UslGNGXgCZlL9W8lmjqp2r8tVr2U4WA+GtBczWGKzEqnzcmPMGDRoec/EmjPhxQ+Tc9bmMPHOmxc1Zu2ckjJNKjRyEsLunRoz49eVSWk0fF6FDTsaPon9TsYbfj9KxQ9HUhuigIj9/IHQNym48BVQ6X/cK4kVMQmUbG2IfexnD0c7v8DmGLV63b1e4VeYOlxxR3WadpqJQ4s5nHgaoN1tF5SzrzX+A8K1yLu17NvOSt9FBpNSpoQJ2t80ve86EbDzzy5z9iA/x6+feeRY2c1O6feEumb3iwf8ODf7Yos9iP7Ni/e8kZNcP/L19Uq++q76LC7lrsVTT40MtHyNdCsL/xk/mP/nzxrO9wyd6uRPPQSDcORncjkkYV+fjk12BbuCHdegh2Rz+QhWExkvVumt1/c3Y8Srnk4g7NZUe0DRF2cXIPcrlhsImhdgVzBBchMCTLrMiCQyugi3GbY+UIhoBVLI+MjwSYhbFpbtjmBjVpg5qWBjW/oQ1afrxNWdJWhEultBWD1lYMpBWDJ96KRZE8zHwY7RVKG9FlefFTHCJaSHwcHG3Qpm09tJd5ITmjU63769S6ZCiU9k0qg4mcfiT2SDuaFZhzZcTGLMQpzTuleafG5pTm/WW37pTmbT1K/ucncwL+my0n4A85+SPweJp0Bv45ckKEcb+1mMDxE1UtWAeOVWsTz9GEXvQt5J++SgHTjhvORS5YQbr6FgRT9fi/HBoK1fHhgKvhxol7P/o2MjveCfvsRH1f04F6cGRP1K+VnTyUcKWMI1+sgh75ug7RVUjMz3BxsggrUYljop8iPzISYjSkUnmKcTVDXUIhV8gXm4SQCAtkNHFtUpeMJCJHqlv5Q+NP6H4iVn5cHBZr+j5pIvvb0hAICWa6CMJUgUBs8CA0SBPgScxLiVcdkDLe65rwib1T0n6JN5Bf4bV/uaQYfb95ifcdPB7zbZJi/m2SYvo2SfHYb5MEjbdJii1vkxQRTxxfHIRF/y+3jAxa3ib5gS5vlxsPjeLKrgxHkRYVSGM7Ok4TkQcjRPSBLdrz0ODcpjC6s3BiZgY7Myf3YsoPH++LKflh8iMkPvUvomDg5zqTqzLLur3HQmJD+PNlOLloO3CM96VSi4xffT42ff4IfROdvXpTulWO4SeNmi3p32qMSYvbn71SSqadKGFgkuMOA+y483GOA68f4jgvfHqcFz57nNfwgcC+2AWFjewDnAE6ij8fJz5gGBxGZ0cL76rriZuHpfeidIfLgv1I7G4psy9zCwV7lMqbUNGTit7Bbm7ssvtweRQ7Elbb+DzSvsc6EuSqw1458oIR6O/FoOPu7Mch4cxjX1LCjC1TemFMtw+pDLtXrY4djLhCxbiDQuzE4tiSGhE72KnvghmwUtWdEzgd1IkyOsmsQiNI9nEJRrQQ9HCvlLF3N+buIs7sxnIAqx6XKbRpPCFDrcGFlIxqwe8az4z7LAZ9QcKQRQf7X5raLR22TOJQX8Ms2Tj4DqvuX0GUSz79Kfz7z0V1tnCOVvn/8VuiT8q5Kd+evsiAgLcbfMAuXVAFEcDxoQpkgknRid0rgDYR8y4QMOZZw60LQrgrCes1JoR1pofRI7rvmWEXOZQywRWQiv5NOfS1tW81E4b/KrfmTnQEeS1LqRnVez6Drer3ynbfyX7ssUilsTysKrMWyD1RqG0rzJfr0rQ12Yp6MbcoGhlMdegQCri/k5x3pjKaPZRZLLQbVlSUWKpxcNY57Gz7kkXcxSwov8hwlM2ycbfmXURhxcYHWSIykHwPHBYw+fxdqtPI499pqGGbzLukh/YIk0lFP7nTS1Hcl+p73mIH4sl9XSbup26VAeJx6n7q4xCqgAWE96XCUFFYQ3ov9XG8jpcd+Phzhv/0W4tSF3m2fKCKc0n6W78wBfJ0kEewNbIvdZUtkpDrz3jm/Qc/mLpZyPNu9ma96vTd709dhCA3kv/4KZE69OE/ZXT8oc8+Y8FXv31Z6gqjP9h57qu+8+1nfCh1OQ+hb/z5u6795lkfW5i6Kf2hZz54es2csy91U/qbDkc9PT23LUrdlL5MgPVH9qWupYNT8GRx+b7URVjLZ7ZQ4z6aXJ0vztv6oe8/uueDqStJP/yu+z/4xh/HC1M3ZeO+dTs3r9n02g+lbkrf3vdJrsajC1M3pb/oaqD+p+1L3ZS+Uqrxd4tSN6vOAHH7GtsLUzc5/cjq1j7KLfMlk5xxZF0y2CbwTBrkD2ohN9eSUpejryakPbLOdtxO6uJuOMAtjtym05k0XdLS6Uc+Y6glehePChfjNMSuRl4J4N3tqhElEFCXfC2zrGfymHwLD6XnWq3QIfv9HJ090A6i4KkAxeFgC6Y2n3+OlnEnZ6yzyuPK9TDnyj8U5A4t7TCumQjGVdVgVHp5Fedn3gJUjVHViEGMOdetNW2qZt5Q2AzrVNyFLRN9oyVkxW80aYgZk0q1BNOmp8XqmRcfC0pyUJ/KK3KoYpghp7LcHp9hK0ve+maHsXXEDkMLYodx43nsFKvnCZqAj9g3AB9OR0haoyAIyDP6T0woHGs4ldHbgiDduYV79L3bqb3bqb3bPtR70t5t70ns3Tpx96RN277mTVtUf3t/4sLd2p/0s7Zybxi0r0x8fFE9xWsXH2v7thfC6j2l27dX8gh9b4bGon/XlUAriYljLdT67ujOVyObql33V5GrwSrnf9LdTDVomOgwCIkYIHSXEQ4ZliQWre1XTTa//KoJCeyq6bPQht54biXj2xHuQ50Ms2OwYPHRqXk/GMXJi0C+fHiCHV8XMvDpQgY+u5BxZCFTgHuoLw4Q0ljQmGiHmJWKWodd0sHdaDuIOQzd8D5zsF7HYTfy+FWoulggokf1wy5+bq3zzd8QmJ8i/KAZ4Svkj352bIj/Uc/zMIe1WYFaAK3qKPDkqYO7qwcdBN0QQnGA6pAQeKiUtCmSMvnCQ70eVxpFY9rSVqknHbuoI+Opfk8cyjTqN2jP4p7RWBbu4gxLUjfuMcw/dcgnfyrRY6gdZleOKKo+S1PT1XGJ43XWkzI/DuvjLln9Ij/2kSQpsW8Ac734IoTuSDRq2IgKMXTJl1CJlZMoXhzkK8oMrRpWFDl0rCqbxH6ZiF/c6aRuJZTAAhPK6PuoCfhLa1KBmuGcrVLpwkOXPECBoMsF0iaqUfIL80PGNNrwUNaGVMCgu44dHmOkNoO1uvRfyg7eS+/D7wN9+KoAPolwlVgPPobTCRc3DAnD4jsA4nniPQjvkB2VxpoXhng0RhL8FSe1SMx0CYedZUTuStzM7D6SezmDxyMaS0avtUMcyd4PsTV8r8vDMZhwf6nDUUyBvTocIx2OHToc0fQyOEstg9Ozg7MkA1Kb3bCySbh5QSpzd64zS4CWRoZtXVfi6D760mqafEea/nhJK/kdiNjLD/E5mA3yVjJrTFNzVsNYxkkcMbXBzMrpnuUgfC251RKvtIFe+eQ8SEs34LF4i5xUxHErR62/BEuxPSTpYYwY/mk8+6PgCj02caqb/atO2mT48m2P02Q4dlw7vppjEy96xbZTaMW/fdsJmCcX5CzqfmpRDzOL+k0wqL9y2ySDOmp2MpbNVUfdENiKIvRTTvzITvN2gLKArHK7AQuOvRvQnnfdDHieo8e5kKVjxWit/mp9B83VGK6NgacOjd+rsTq0HTA2sWzRwYpQSdKhTqROb+UqY1rNuuCMeZbioHd+nu5dpCZdpeQNtr2ONiPaqepEd2wD8XI7yMiIddhaivkMHfHP0Ch+B/AzY3Ss+uJbyB2NbT90Usm4lSLuidvvVJ5mTOtmBiou1QXmAr8Nny+cyEP0GjCj3r9Sb8b36wDQzCbt3i5YVTmnPdnhBog90Bst4bGDgShpRHM4AhVjbMAK/0rQAcJ1wKOPPqHxDeRoHb+7okMOJPhsN/4jHp62BIwR1UIqG9MYr/ZrZTpgNUtHBY0stTbRB2+XlooN+BChTm6rO3+d2uqurK1e9zvXVl84blv99a9TW+3I2uoNv3Nt9Y3WtvpvwM02siQWtRkVeUJ3/k02BT4/cYUNFPNichkIRDURnwbflAvekA+WPP/ZyfJUfQzqwbbUS9sRhzMiz5mWSO1i9rbEbLR0Nl1DclaKOq+70ctQVQ3Q0CZ0dbJgZ1cL2PGfn4EdPEwCO09p9+G+6s23jJ3sN/uOveh/1Bhza9uvWMGuuOfOl8p3quC/O+ffmvMf3g7/fdKTME5R/l/j6Qz9TtZXNG7+FfeDSkLoAfWib+/PvB/IvHvF+/ajZe8eyqJ+T7zvaBf1nW2IgvWqLMT9/81vpMZGMtEHiA3LZjxgAP2tqLLK/5p2CEQjKxD5opm8lQzqgRz1i1b7fNhAR77JPu3PPSHF/VmKDNFU97Sl7mxL3d6WuqUt9bAzicq0bxnbr/LIKeJPHkAkKa+Vc9FbVclpF258SsaNPoIYLJF0/Gx1M+kdNDnrEkYKpLwHCWIUrZ1TDdNVE71ZAtysrbwqF5C1lZe1lWfbivxUip8yXMKnTFoz0Pcchb7zKPTtR6FvaU+HPFvpXOfGiYHuwGBLdlPIm7JlFiBSJFyp6gHZXXerc1dUH5Su+hbtIEccJ4p9cQk7CTOd4TggDeBByFSHgrnOMDsFfiR2fXYjaZvqp+5+z7v9K6s/eFmWI9RK1buy+uhLm2j4sFbVX1b9+SuayB3tyVH1Nmohnom4bgt5uD25Q0rdUGX2JoX0VjeNVruXtZDjIpwBZNda+EAcwiGEDreEUlzSjya9aLT69WJL8Iy4DGcIiaOW0KFYP6LUvuDzYqnJxdXLWoIulpdDvVuqprmObnXrBKxDI8ta2nqebeulcUHc6+Ju0pCbuFVvYn83u9fZ1l5qW5sNMOjyccTuHnZ72N3J7mn2bMc0drew21udh51sWRj2YYH/gaS/irudirfA+Vlxeaehvup/OlfF09PXoKcLFEujQY8+Vlyar07VQZ74Vtta2bD+Ex6TePojebrePl3fFHaTPsV9FR008QD1NYmoq+q+UM578H4DlTYkfWuaROVRX/S226yYX4yXxTk9A5WwKRpzJQBqOg1QiDNa2EvsZyoSJX1wxu2ZIOrDcNE6JtNtLeN+mp7JBfLgRHoaCDniPeb+Zq4pHEv6wHqlmd9eqmT8bjGQLlXA8MBkhgeU4dNpoMEw/3kcIimV660mqRyDba8N2xVhG/ni3XpvMttMHks8cF6W0xgscz582yL3aXm5b8dmq6eC75tcjz7Uo0JcUakHGQB8eR7Fdys1vdbmLnOyjdAsfS5kjJOhDlVvMkt0Wp71nQbZcrzC0VjvJ5Oy3oHzrCGehXVlfqdlvmYSMIN2Yvh3CusQoud3trRAT74ae7QaaIHjV6OZ/z2W/7f9ovhn1dfCfJRn/v4c8+XJzJdT5svCfMr1/ZbrvaeUaxQzSpUrq+/N0dhsHXhFnqYL+c/8p8Z5R/QWeNM5XNVY9JDglUDVreIESyuqKlZMYWmhqmnFH5ZWUhWuWMXSyqreFddYWoVpzgLn0P9n7iuAG8mStPVKVaWyBS5Bty3LtrJeu4diGJd3tUPuiF5mZpLr7yVPxFD/3j1m8HiOmZn5lpmCjpkh4JjJN5ffl1WW1FIvU3dYlY8z38t6kJmVz8miLXzjqA4vpBUB8A5nx89U7WFxWMSfanSbiEt865xfgSmtBjZ8aoZX7VzKuGvxc6VyYhHuZdBCp/iqM5L2zVSbrNwcPMpcWj2MXqiC50uEWf5hDwt2AF0ePOqW4KxCMe2Bny4RapKbg2cTgjDw5Qq1TG9RldY501sEgKC2oL/OWkF5y5raMyPa+60KRehug7bNlDZhU1QBEWoAEdV0PJ9uIYhe/rBADL3X3RJsY79qm89IbSZ4MWX6i2ywqQE709OjZtN2wIgERHaF5tr4Uicyw4+kFHSQCPvC1fyBoXoSDTzOPix4suFx2y3sMMdPc+kMiLg/3yi7Ud2YzWKpGBiKboLie8AoF6IIboFD5ZX0t5igu3OE1H0ExPrpP0MzbyMQGuXcutp1ciXHT9zDjR7iWfNntSqt9jff/GXK2shTunq7koKDZqXML+7ieetfOn20mtF+2aBhFI/3/95RxzTi+cA0mO9wXn93PLlzL5dKDuDu3Dv6+Kiax9P0x4hAWY+E6Y9bD02OOD8RwVPBeZhLhvdDKVi+YTb1fMTh9wPOJzrEt1Ye2r9T9zD7t0ow8HRU+2xqCJdfMKDVEj9Lgj4xATYYGuR5OuyBVE5xkTe2oonbYynBVFfhhxFqjGWZkNIOpgIUjiUAVBvdCOsGpxGZK+6+mMV3d3Tj/zO1I8h3kuCpfPQT7AHC3lkRXy0K1VHIU4E0beHUHJmVUxPuTcY0v2oSK58UmiHuA7OlSZFWUaQlrizSmi1S3FOBHY20Jjq8pjSPA6p1Xfle9uCvfrcs/apPvwf1Qm+L2qfwI27uYrg1ZVJL+j3S+l7fPFZqqj/3QFrHVb0cweax5dArEayjs/OxpNL8XnXm0YOEhb1uzhWhXJn0cj39SfYvQz5Jf4qhJP3pSazwBon0Zyxm5MBsU2/Z333RR33LvsOckxh3vscVUrirtA74KneTev4aK+voF1GbZR1cvFIJjAEMectekKAamp9yEuBdq+Kxl+P3bqnqGc7W5kK9m/4cp5w/OLm0uu/O0+kjzrzn4RHYsE3x08h9Fcvz8PX8xehXld/QpfS1Qq914f/USznji33EWOYaZzHicgogYasT3OUTPWpl9I08+h/bCdC1jZ3eXp41NN7tkCfCM3Zjkf7R1ZzdKwSzhawjNeqTWxpathAcXJlx5vQfX9IQpkWhdOAqqgMOW9IidY1JZPkOHQNNwTEMNWBNQIHQCuxrAftgquB/bQ8+5yQ6p7Ny1m04Q9v3VM+dnVCqeiTmpOK7yg9xVsGLfg2ia93VXxE0snXRUCUboEL8RzBsBRUX1KUHBu5LO882tIY+k3vaEX5TGx7IhmKpMTUFe2MNYbXvyMkzoGH9qJttoSPkRDYEKeZTSbakc/R87Ygvd0c/7I7+yx3ddvTEBf30RPZUB4R3yg4bosOGSrxW2YcpNDpLn/3dbKhI9ElqqMj0FZeiA2VdOqpi/9kX8qrF18/0JjpZK923Susg/Eo/AMkKXQuq+0r1mlJo5PZnyO3PkDtPqJHZcBf8Ozp19KXu6AfdJ0X1mlFdBdVrRvXaMdVr0j+mumPelT8W0Y1qnYPsIIiejO4GyU2lnyPzRxvJ0FU+9hgmF6EmLMewaAzsvgcSND406kKjrhzJa9zikQwuMpJubiQ3Pr9GMvi0jWRgI1lZNJIrUyMpiwjEr98SObpVthZsMzJcmp8djZSqj0Zr+rHHmahwVH1/dqT75TB3cCm+p6jnkL/PM9p1Xvey/oLBTB+EFxn4yuf7wLtP08CD6FWN8at2SJVgakHw3XF2ytaxgXbDttZ7Sra5EG6IUwhrQYi1oMNmsuHxIhBOFoEh7HLzMRwhsjc3px2Fnda82q25elX2HUDA5QSDPXRuTTZVJFQsrYo+RgP7LzTFNk1y1RkrtdmwXhI5hMRpjbRqtT16w1v7pex0XTakj6156VD9NI2KN2Uwzja5LJzg1cCc2IaSEvGTHwvxtVnEV0vEQVMxNieBi0IdmCzPEYCJidjPTkjKY5mOMmpek1US0ftEiAhIxAqJoK00CJknokesh4DICUaTEdGf9L7v0Mmm6KNzK4v76uMMWJ+m5YpAI+qz7xhevYPMyxAN6OCQFv+rRktvnpY+aOnLqpK/SlqUkm2U3S5lKbF0C6KkkQ0WEdZQwnzIQQA8S5oNAHOFY42Uzq7f0BkPbzmCfWQMd7ENmlpHpCMbGuU3laT5eS7bwotna9vRT7hsa/793cL/o2aytFxvNFsr+n5U8ae5fZEURnGN0ZOko4EiKxuyyde+JgVPVa3PZTjW1LK3yfDsX4z9L6KDTyzq4IE0xplyLR4z/SwrqGlFUvBgWnoBjkyNf79zCy8HdPT8RV/+vBNw+ijIXTK/FjGrBF4VuAEnwYTWFGoQ6pXWFBLQN7BpLSau+f/RBaEeleetCCjNzRSLuWarqNtZs6403LIzPJr4VTRxLJkM8fw+EwvbR8zhXZmie0WwDUNyHETMdFGL8pIYHz+sUMXHEr2I32UzFkU2qIIgKC/CsPG2oP9Vy4h3PER7yYn3xZQmdJiO6dB12lTk12thpCQP9EQDBN7iMneMbjCNblCia9KyAI8ki8r3M7ZHLTDslWtmFTCGumbQfG9SPxV1mCXTcaTEfADXQCI8onmUiRMPnKL9Ht3ll+hdY+SKz3MdZd5jD4GVb1BGP3oxnJjW1eYva+lD+XlFHy8Hy9GZXnsUcK7s4g1nJW0tp5EnpGlfm3dE/84MspPSll6erUodlK/hkXC6Xsc7v+cHmm+AT8gKEeSTeBbZ1L+t+e7hMp+yAbiPHcq6dKWajxEIoXbA35mB6AQgRSHZQiusfKaVrKhbBpknAZlWvYIXlqatrQIKRDBOEhvznDrQEjU5JYGGDg+0ejOFnQzBfvk9SYg3PxSPN9TLyVLVsipbQNdXx1pP/CCxEKPwhT4YYDjXpDrmSFuiRa7jhV/XVev/cxVB6IRsofItaVvlXUR2i+Wp/NCnYWnmsFWWGIIOTMdUSVQq2Mjzcc7V0dYoe18VUFJ+FomPPdT2UWYJxAl9igAL2IVKFpjrPy9koZPmh1QfiY9olCoBEjg6EV76LENqj5bGVXZ8MI1EJNiwCKsIvT/nh7rCIS7MC9HdUHy+q2OqE31hjlwvOb8YhGzam72IYq0DJEY4Rcsm5K7uUjxiUwfYglqF+s+6ACK/uXkH5JS3m2SMPLQJx3GsMOX08LMmEXnDxw8qbkjbJ+vGE2Un0NU8zH2IL4kOH4Tv4MBe6irFmUaagikoM0leQSB4bvYNr29Q+5D+Fp28qEqAQpyEboBd/Tecc9O3XCfl5R4QFu5IgvXhrD6qEOAn9OaojwgC/ERiCPATqUF4nczN4FrBtYjGRJ5IQsOsKwndqNBlhB6m0DYg2nIJId5JtkHwPQDXCH4AYI/gRwByCaKoM/0Vk5Qp/hPfmM4t/ERiFKDq0q3CiGtb9Pg3a2IKi2NqCBITxIdFwjt0zudd3RTRm8vLSAKOgQC6PAhVHWAC9R3koCieOiXz3QGKfCARx3bk0l8gvmz96Zrfqa5jWkwfzonpn222NFNi+t+pIFMRkoAif5jOUQ4/+zHFbzoX7RemLwKzl9/5wtKsozgumpW3hPRexJgAi8H9MDRpnEEKgqlB0PnSqUq5tYwxY9XAc070UZMY4luUOfb17MCortxSJag54WeHEus5mF/MZjW0X7e7F2a/JKjpY0pYyrGp1/+2NvEDc+3kzgmaXl57S3AtoNLDN+HSw3dlghhg7nseRmNCcfpTKI1CS6OvUdYJf6WAOHuhvwmHPtbhKf2o1Hi9AsjKEf9ywrUct8lUqJKK05/+EhiUlQUitu/jc1BPFRVqB55D6bsFHwwOx6MXv95eifvN4nKkuhjY/mjom6BntnnrSh9zfHHRIDUR36fPJVbhtF0o54H2mxybAasrWl/k9GqRgu8CRrOq9PdKrSTnsQi13KwQ2NoaOdQ6o/SDpaboLbzFu7BVYD1jbZUX1jDSdruYFBDa8ZEKMjXHnl5eaZdWRjkS9vh7d57+Pvm6VmQukqIylQphrZOpsaVarrvZ8bmvcQ9jLrrBsT3tCnJWxMsSQU2KS/HSL8WrAH8fJUzXIFVMKn9AHHgL6ZUacyVfLcYEszH0cMLuldggolA6t6oezy6j0Lq6dIFEdHp4gMEV3rCotYUZZSrjZRa1fSGuIHgOXZA/G0new8LBDw4LVR+GW2rGb7zOyGFmpxoRfU+133+Wqvg9DKFgGAfGw0/2xTfNk4Qs4ob7MDg20aukfwhEMQaxIf5HCAPEbPZhBCa7JNxYObHG/QjWqUUfnGK63ZBw9Fd//iX/rWivKRhgeENhQ+FCK9xtzcX5nMUfJmE5W4uEvOLM0hNNR4JyxjvUGJXqQJuJQ2APlcdMHBSNVDXy78wAuEjV1Bv83vTju3fnrV81d+/OxyjxngUlfikIlrBXmS+kUeafyl4vfeyRZaWaIyFEWnIO/lWswuVcknNPMndxObLf7Ws5NJYQp2kUTwXYZif6CPdG4Ruy2NqzfXSDEwBu3IqxdfHNt8wdYUJZUjLewnmnIUAsi9gS+DPkJiwZQ8N3KI2Dr+eVZVhMYuo1s6QgnNhQPqHcAz0OSMvikqgsKa86kEiUqBh02XF7OavKcmnx/paVpLUfnV/So1ugf+F+tTi5ZtR24hYQTGqYGFm/2ZTZdAVccMBdAhuBKmpxqGTKPa6Z2X8jTs0aEyOmLs5iEllSwl2max4+wEU6XBo1eGRSoLrjWwPNoZAoUJUYc0Fs3+8Xu9BYSXA5L8gJ8At9lSS7WdWkJZeZHzFMw/Qrg/YjnYWf6NNmxUaqzd2dQ8vBG0aVJ5bxnUaA/XFT6jsXRAWyfGGU0zY/zgoKSFZUXm8BWVEiEhKhGirflS6jVUvemaRXF6W3i9rgcKf9gO9BdHng28UpqveV0rYDywu1KnaIUg1sp7BsG5aJBNoD8/EO2M9GNUH+bFQA8lH6Y2SVlUloQnyyiLIysbogsWs7trZ0QXNX2ge+O6G5W9Lse1/ptUO+EkWl/YKBb996ww1vfOwLbWpQdCXalQhOGFDV83x1wDq0YEtamGMGeibKWlMdVxVeGlLZsRqkhV6rIAx+rz+Ru81lfQBxWTa+bJEvm3Whr71JFYG0EDGpI7A6AtZhe8T5algoa7GyrKo5MBM1+aNv/KwF6gI8fHVBLjuUdaWp/SxV/TnwHek8D/pxnc3ZKXam46i8/eDWj3zk7GMe5Igg+oWDcmjQxbiN9NB3pkqtXBEkCL7j4Fbck7e4YPfWy5//tY8+1PHsSUfDJ4qxyE7ChorZnyddi3zDXrbKzzSyNWng0Ze4eP3XJdInJKyQm8iyBvzmbrZlXDe0h+myI1nFNBzJlmzAFjLW+xKPVP/vq7ko/EWEY1TQ2M0z0YybokmNcZ5lss6dwpoMNMo3d3PpYx/W2s3HWYOJLSY3x/lYo5bQByHoVgJBy+MOMy9OIpQ+hVF1ckpZTQLbSG/TBaFs71KDcLqqM1kWl3w4ooU/wtIqWTGWkKC0jAtDciFK1aWJFIdSUiEoTWRyxmYO+ni7PJgNYEuNB/EtFy1/yZTkjZJDJHfm1zRQCL8pKgrqoo5KdqmJ6i6znr8cMituE+W0/l0mlz5gb6tHIWOLtx0eFOwjnZIJLq+Ll+4BtQyXH2RDlDxAp1bQqQcPZN1GWJdLSo525bxYGA30dOYFjQvxPnucAcQ7kp51NSBVOe6BomadEZDagTrLyOyQPqKiWNSLHgAd71A6dN7B3IIJTZrCkW7ZSDdEwCpLktmZhUMecsglktMSjf3psaye5VK9gRV8w4RmckLahzK89WvfddejtX00WX/Pj7nupi7bTv9W1JaktNEKzkf3dQlX9S8+Xzu+VrQ2dXzkvogbXAnQUJwjLkR07VyWiEbnolBkDCK18mberGZ6tCVMVYjwNQ1KksMVYQihiASQUqGm5cfv34Jr5JeFW7BAc+mGO9BwwHPZlwVIWPMs2PON3CeAzvoYQhfdWjeFlUd51rKLjWv4Nt+2WVeCJ/XJwKOw2qPhM7sIPizPKnWWxd5ghFdE99IBDCd1J59K0wKpNtEWEo0JeEnnZFHgDFdOWeZ2bJmmwMGuTtduB31QWuBUzAKHHn2aY999Ek9i7wjH2Bf2TAJ9Qiejf3GqntPnL+lzVZ9/Qat+xQFajTYe6xqbQNUR6ol3bLJfaWdbnLG2iB8qX4ZRNX6/zckWnt/kXkeBYKmnC30C5Ia4Dp4yycS0RbT/CWQoCRRDcXkdE0UYOLwMpYa4xd/xlXdT4T4qO68kkGbAuJgfYE6uoA+w2wpMxGgIpfhp5OX6L2CZtmz+H3vfFd5GdqwJNEJDAj3DueSdOzY14n9aBEkRpAAQIMEkiZBGpGh51tnWeoJl3wzxBunmNDOb865NUZteNuecc8553zfnfdv8dK3PW39VNbsJgXK2b5I+otPpE6r+U6dOVZ3TaqoOuGiW1aMEgDjepEKX3IP7vPttG4RXlZm8nszj4uEhp63C8WSBh7lkEXNKAF71yMXLAyJary8YjRbltlIpWRrSqhCamGPxy2hw1rwiBwnxuYIGsaJwvBta0e7ofzQyZ3FE808792xeGv5cVCzIs5YM4TU53HpXitQWTUs8aSJCayjvkpdtLKCFy0Ot/dIQi1g+1PrRTS9vSlLySiP5+KamayMang4sqmeOj5j8icmfFte7lvR4P0T6fsHfLwwZKLShPCvmeSaCUGtd9aDENmqkWYcbbZWt19meuk+DBNGTCwWo8eQwVz36C1ch/8e7EvXRma7EKK1fzPppq5roDBH9adbdtjtFy/zHJFdX3NXF0EEbXXVh97zCpF4P3EpTbxSVHDFqRgiBtdzyfX8rSnUFeIfXkVx3UOVjK76rNIy1Bl3WoMsaCNop9z+f+lrWWFBGcw5W6wDkT0Y0pM1aw7omF1m+hhbb2GIhaxYMEgoTFYWZtqV7NtIqyrNyijTt7WeBp4uI2TGc6UtHThcFvtwqPhM8JQdPlxLnB79E6KSV++rjhkg+GzptrXCbaO8LcAijPHi04WPwY+QghHLwIZqeBaF+ip82q9H+GuInMvxEKX7OxlDZWZeXVlg4kUkQaRqEPZg/RDS8r4bZyTNhRtnblVdoeP6SIJbEfDFme58BMCWo8qujin/NxxX/tGBNFWk22mFX1hKA+ISYRwGjmddRMTt/ed/ljOIFrEeHTzp5uPS0+J7iu5MWXww1Z1vHSgqVHF6ASr78TOTESkQlSy3FSy2Pl15Wkx5r0vsaIqZYZ8U853o65i37TANoyBTx3qD4AygwhhoX0MBFzE7+dTehc4wO83Umm8S8oOXPHId1y2XybzCNa2t3qaMUmWxa+VbI1BRI6N4q1uV3QwlTG0WXMAmrqBBc2HjyX4oSsjceZDWCLNJjHmTyFFCvC9YfHY/BGXlslYxZXVYSCW985M88JmX+xlEC3gX0sHh8RHKShCIV/szjsMm7L9nDOXm0ZQ2kCpXqACsc/a9gAfFZo79SYBtr8ruDLfm9ik35vYbGk3PRhXDdxGjRN7AtEQKrBiSjVyVHrxpqSq1toRZ2cA2rlP3M4Hr+78l/VlpOsIn5P7mfbOAqNnCdz5nKf0l3yWyiLK/n/xhTtOoMyVRGdkBVGTNORIiMD1jDJgp/2lTB4xMqbxkVL5DEyqpYmZWY6ZKTtspE+Rcg+wuQ/dkDWRlsS7+A2F9A7M8mIasgbAoE/ybhJeC9lAa5ZvN79UTlYrUuiS5DzYMWCbqiZl0Dh4dQMbpOcuqXaNzoo36YFIQlEa/ESNM8sXc0MYH+fX0+BHVOtktCe90WAmYj9+6HhcFbPCyiSaTNo8lopyX0GaC1jD6vZl3Tp9kgRDzsEjT2n5dl+3z+As+nE868JMukiiU0Eb93hlnfnlGDgvB71ubGGtnw/aGLRcyjKqXJQcyFLF9+5ckcaE9qZzaKpAe+5v1EzRRSRlPSapqkoSaKCh+8L2npRUeNQ4JKQSDOy3EibFiVX1KxEdOGGaPrmq++QzP1XP5GlX0EHe2mEbt3qnQTuII0MLzJrlD1kwyJhKF/lZymnqSgpSfxgXXm0UYaeQppO0OsZIPesLZdCDXqxkbrFp0aDTOdhaoc/2VVWi3PeyXjThNqfXubtmY5/ACVVRbauk3xobf0s1pVwldIidpJw9c9+DVCc/hFZDGIQoTO2GzQE1RrLOyfjKyav1OOnCr2wD1JlcAzSuCSNBUROab78ns/lXBgVqHNrmX87SprejqfzCAwp3cbkh8zrzmrzX3VQumJSICwIaVsoIGWEdqZGFadiJETMUaJ+8NzTm4ivTypDnHYK4jtPM9sZqJzkaq3NPKWxqwMuF11lQ3osY2riowWIdEySNTMy1xjlxOSWcfnvNgn0x0hNG/xfXT4p5EU2Xf2I599Ua5ZUn8Qp5PsWA09FafinADPgHTBcRYKCkID2q57UPrau3UMSadN60RA1Y0jFSyfdGm9Eaus0Wu3sc6pCyfAMlmva4K+vcVUNLrKDDWXZT63QtYXWzb6AjoCdXX/mYocP1cgroz9XbLfmb0jlNsh7VhWLWO2Iq4aImFKrAyOmRyRsrYyhq+RjBQh8l3fvSd7QH2LUQfbWDVR0MBJMbTlpBlRGahn4ZgemNBhPh1l/4HN1I0bVeNGzbjROy15WWJHOfuT7G8K/I5k9ZMZDsjXZ/JOEhmURnlHgVo7xbvG07yrneJdDaqLZFnmc6vl5KjrDVC9oaW8K8CkdmQmI4oh45RwbVXI/JOZkJWrH9UrFE4xhw+3UcmRPRqheSp+eSh4pKDTnB3O7Em8AbvR540+Jl7llftUGC9cfBja6s+5SPvleyQxuvSGFE5G3YJ7FoLeKiedWyOuh4IPVeh49zQTggqoJqqqHKgBtkWRQRlOQD2Vlm4Elisn4pKJMCetT3JCgXVR30tgmKnepmeG/OCfJCkMGYEwT7WPD3v8kwRyu8k9sEOMPlogF++ba3WeutvsUIW0s2DM6rY/bhR3Umf67jxmqV6hbyBRm4s50qTJp9wgRY2CNUaoLkJLjor6FpO0UitkxwPRaX/Ee4bODLSHX21+tL8MfrTP5Ef3mfzoP4Mf3dP86JMfcyP8+PzIvzP50cec8qP7ND/e/gr5cRHvltSmwFbc25iIMU5KttD1WUnu8apBh75fb2bj5sk8BK0nL4SNcdMIlNgMNr3pLe88eQGrMtn6c8VB9OSPFLXFZW/xsyYAJEVkmn9TSdETnXXAwVr5O3jnbXFhy6W0DE3KpAitQ2ZZQmRU1+VOmYqC2inbOZUaIQblQ0e9qsnge5MbGBxqFj2bYlCpC5oDz+iOFazt44bGpB08SG46Xj9X5J1fXbQnnxHXJY8/mcnW3To6OPf+QNw8dxCaxNd9VYBuoiJZPjANvYPqAaoioK2HPMx7GNweSybQSSspbYHTEIRvFp1iQDaNdCagDmqnwMaZoEHvYXhFYRJuocZ9CC5pBFO4LIfKD4Yr5GHY0elQWJHK7JXSucUeVljtV/isJ/Pyh6IjlBUwVR6pP5bZwUN8eqJeJX7Qk9/t8SjKJu8V5WQsKJIhXFCEHQHI03iyMeRsPGUzyZfC3Mn0vuQW7cgKoeZ2SOrb7CJDj88cRRJ4Dhyjhfkqpu5ib3BBoDfH3jXHeZPHai4ZnVDAEnV8MkwyivfkYTUsu+pb5CsT/JFIPtaGC7ywpNWapwbO11mdsCCVNB88tyQSB70VV0tmpTieTWJBtSzyqSmv9lk+mo5Rmx/yaRn9oekOLVNnGqbOdE2dabunq0UxeWq2A5HDdJdl2od3FBFvgnphKU/eKYbtVH9LqyzvJLErcds2f0hWTT8g+6i3ZQk2kH8kQDUOYJiw4arTVcmWairbmvt5vWBWr9hprGwVnvOIWGuvb8yKlj0EQGWRX05qOcH4nkT2uVp5qUb/BBnm00Jy1TyS5a+Qk+/8fOXkO19fTk6OcpJfJWfuxRMGFpxdzF451lSuKBsOnXWz5ETKrvbYT1Wuhg2KB76VdPlO31g6azPf1phXNsKqcrg7hsMt53DVONw7NRGM0BWUNVQ33+BokPKXA00hY27TjHnKXMTKtG2fOwmPUFNmI721mo0UZhflIc5F9TcEd1za3CKfBF3GtXkvRvhuDPBJdJNEb+Y0+iUsD5Mll5V6iyOJyEWPrEl6QgcbzHpiFF0/IUnPm6ekQOdUDIxqPtg7DC3Tbao2K2uY/9QDAdFkJJrT1O1Jiq+qtC+EgnO3ko/q0bXGAXJUz2PNVDJdAjgyqIYop1+45xU9JY7WnzTmWJEsyARFGz94S1qdqq72bXwNtUItxWGTNQhY1DFrJjTrkDdrWYgOL7lO0ON32uZIlkoZ2EqaYFJT0WR6CC2YS2VFX0JtaKG0lznpbeYNZ2HVgqhZnVUpPs4m59I046xVpWfCkCpFW6ZkHEQ53JXuKD8j9E705oacm7LsTmOG3bum/DDVc4jisyO2HJJjVGVORvV9zzsN3ypmKo+ypcEMGg5dFYro+eSe1Ctyvin9nMRzu2pbHOJhDotyUpHkfLsJOfSUqqHPAz0YJHSYd9uSFHwyayZN4oy0ySrFoZK3SvKSwI2MwHxYVye6BZm4wauQxfCU1HryJyNJ+TfLfvUvq3L1L8upoFTLVmadotR9aajy0T+t8+R1KexjAhr+RPwpufxmufL6ZyKf9mM6DfyYRx/9Q1QJnnYGniuEOevwOyNlkV18hheTBpEqJSaLnSVAqmgZQHg+wrUkVr5xGDnNwZbz0ERNmzfbqXmu6qMy+VdAW2WuOp0WbW7IIZAKbdsYVjGGxcawhoUYGNs4ukXk7iijYjIqwirRfZpRbvv8m4X9jDX/nqz5nyes4dW/T6/+ZuSMyjNxZIxTjiMir9r8gbHubK6lQoh1idK6NGxRXjzS1y+l7HonFg61YRf/syoX8It/z4tJvyCyvK/rvh5t1qRPRjY4q46MkQ0yMlZGRjYKpOxrnzAS6VnK3FRqVn0zPWNuUxqg0lyPnMjSsuiLZdCwAcMVBhej0dDu3sJA8sCuTcdELOo8LCnYANHnA13euDeE35uze5TMh+m9fZfVCwIutjpyUdtKRa0woI5IRK2CVkHWdoWfqXwKgH2004AZFSjzlAWcwy5rVmGBh8mwYqFLbF4DBRJ2PtQo9lewLGoH5odYOMQCuUeyzDIi0N6MNR9CZ5wekmJw1eBnJ//STyg5YtiIgLZW69A1jZp/P7CJKou00QA1lUCZHhhlat6q2zcyVY/94WlA1uQq1PzDeBaS5J2vcqJcMkOXIj2h3Ej36jKHLhqSS0OHnNBA5BRXc2A2htbImSpWsEDqzaKN5bSBsdOPPz4qVkdoED1NULNKmzXahQAiP0kVp5HqpuOkK7nepDROL6f+zDLBLOb5ZB5206KsxlW2YO9G4vpF5JUuf8FKp3UdU1EN25pDX6V/Es0Ybq3yOgSoJWaJ/XAJbRK+DfYMHzfZFYq/0BXO6grvRF+oK0z+nO0KbP3Piq7Ain6lXSGyrlCwrkCoNxXqo12haXT1rpJCWInOUNTu0BoYy9htrWmgKyW3VY/qssweCjLoptivGfbjLxP79KjH5HvzNPbRII2MbOOm/6saaz4K9zxI/c1oFNKZLSCfOvW69aQlPbZS5haojUA6NkjHpHCNeVstjYK1tAlOwUI6pHslnyaPhwD4EmSvlmsjeVgqq0Pbg+NPw5KCgIiJiJh4xtg7ClSDqXrPjc0GVFbszFqdhF2bj8YDQEiZpmHOps6s0p6aZ5MVkinapR60h5sPEvMvmjZE7Olq7EIWL/Ivi0nkK0d2VVXyWAcuE1EUG2SlOBSyPfmZC6etGmlweplS0hjMQv4OZuiL6CJSN2IVkbqAOzbV9bj1pKfN13fF8HTOp5f04djeD67V0sRBX3DHfcGaFDHfzXyJZ1kufvKU5YK+2Z735szJK4cOaoo4bVtSyHsejXruelQDjVxHiR5/PefHulFKYfJv6fr9G3feVRSeBZz3dDdtF41IfQbccikxRy9u+hIhWz925c8kW49tNWqyjvV0Fem6xTonyeeKYd/Y94pVKAzIAOlZvz4a0iSPb9GMZC1iWhLhhv2TdV9J/4F0tYlDNSu0lZEv+qSLliL0iZS2omGZfJU768ad4yI3Gl5DGX3Ne/Jvs6lh0xAU5uytZNkqlnRO9O4mwZRURVRGu4OCmfVmM8AkkUImNtfcrLjmhK3oD9P9DGqoqPOt9343B5mjhrMaMQuB4exm7qHJsmGOGHNVmXNdoiw488as/Akih9Jz1RAhCHrhab+DOQoEbuq+IoigsXN9ej/o8mIEHR0XPsOPTarRcKKgjnFVZ4g7T/5SUQ9/ofjkTxXFzjZT8rAPOY2y02J2qlwYN7ezSSYqdMEw+E6SYkN+vl8u5aLIi+L3P7lQ5FXEq0iuIl6VeFWSq1LOV0LPC10mE+9Ig/N/7kfx+AePozjbnZJt/9M19xy5ez900adfKzYKmV+uxvxM/sspCVVDh/IEDTdOVk/ikCqA+mFomSb+RIq4qc3CZN62zkyiu8S2sLhm6qDpZY5Qmm9om5ILerp4MahkQU7OPNanFzqQp3k7i9w155pKJR/XctbkaY5XLgnN2RO7Ba8zziYcVtmhlnTUciWyPlLcqhmyUXPzNpMmlVGNarQOzLTi8swjJ7RO6Rx5WpVMHqqQ5pNETQ4R6k59vw8IToSKWSDZGtO5jYkVHQWUEIS+DeSsoluHljKr6dlNL6SNLtAZjChr1tkRICqJfYyrmEu74mtE+IyRlh5RtOhii0ssFwyJc9r7w4r1Xpvhs6K4pJLJzQALrupcNjXNJh9GFT612MIWGzCPgujOQ+KKZqVWXQXaV1GWqbzkEp9QNTEqD0JzjGzrai17WBnmJFvS/iIEW5uCrZsJtuYzRFr3Z5FIk5K+2lKtjS6l2mlx1j1bnDXz4oy/oxJt7ouXaF1ivTsi0bpM2cay5a5AaOhkwGVb4wzZ1gg9yNOvQLahge4+WrcehmZOzPXO7uudr4GYoxhXR0QLlbwjovNFS7+GSb+uSj+26UT6VZVMNW1W1VYrZNKvdkr61dA2UvSeEoQimoSTnRNhWPvCwnBUFIZVIyxn1bk2ynVeSDqIjUi+m5jJympmGQ0NrSuvTaS5NLWxqoDLktGS5LJo8RXq4KISi5rrduuoWNR77b/sXLQVD2sANrF+/DhVYOGbWRwdJwA05Rsz3BNz1G9o8HZA58W6TfJNOtsUDwu8taACPvUMLktH0mnQFZnNIDxQU/mvptYrbQk2IX8FVw7DbZWiDC6lZh4Ool2+ItnittojL1GM/usiN+1wVXXp1glpqDAXJBe+8sPJIhXVK5Jt7b5U6BCL95MVis89ieXBZVwhLKTTywOehaHMzHIhOFuPkzXbBoS5PZhJNjWm8gqdXy0s+q6LYQEJ9v/Mo5BIjoGmaLZC8lOLUR9rlNKcq6HEmURYxmU1FhygLYqvATPhniQJkGAZctUjo/AoWzmiJCC1dSHIKrpBxjGTAQ4rA1IWcCWPdR8TlX+Luv6F+lguDG1rY/y+CKjZtO0y2rhksjCYzzs2q4qCLZb8tgJQRSGJrRG2rDNR34qvrTlKtqQdYd1bUN4z4PIiW+uzwYjVM0KIKA5b3tANbGMHV6XBP+0TxUz3+BIi0VqEIFoaOVTJRw6pX3gTayj8Ga42yfWAK476dDf4BuSekoYNYPW18tdkLyH5g6yluXc9qxuLadrAZeFHaYeexW2Kr1l6JrBiBDH+7kmh86HwLP7uSpIV7I2JL9x6OkjstndU9Gl7mONhDl0euun0eElrJdg8wKXQYfVus1cxYjM0cIAOBgISU7TeK0y8g9u4SeNHeB8OwiJuh1el9FcHRf7JpiV922dOyjnAHQJkfhg0/PczUfKLKG7fb933WLqvXA5KQ9nN1OwUEh3JzeQ1xLzHeeBooA3ej94gdvuGvN1WkcizHbWR8ux9pHnsy67bVFQOs/FMs8sPpAU3hcU+oBr3xgyrIJkQg2sXPDbAGYqW5coqni8wXgIWzNDdC4U0mlPax6T0pAvp5/A+MkLIMWH76LPii0mLg869G7/7Xfm/sDE2SGWHQ5G8tWyUGpNmJ1zFTlg9CaDo2ehRo4GOHVmV4REKJdsaRRKuSXo37lLj1RUxi2howw8Nb24qTzawkQ39aOgMIOfsRYUkq9RxFdtMJHXCNZ7saGZqG4ohxbjzkC82dZ7AV64y66dIonEvSkx0Z8IHMIc7amf9IN4LQduHMItV1Xf/M+uF1p+RfsoY9yf/zWTG+wffPww35SAM3heSLOP94bIP/B+ykP0rKtU2dRS4l+5IRrPO33w7fNgOH7HDljOikNwiRS/hlkA6KQiowyzeT+/6RyUrpribrOiuTGvKeFwx/0SfpjqT8SuskBKb97EfYqwFkFfMocCX0/XzbySVmQAGKkNO+g5W1y64op5r6WdPOd2XZGVmAGrUFj6W9auI/eqSLTkYUMsKBxyZpdf/BIWWnEinnjeI9pI5728bFiLXRIGSYIG3RFGRWypZ2LaWdlAFGbtz2pVDTIPgSWRblax/KOVUaeNKkXguZ7eOzakfeUetPNtmnclcuWZhhmLzVqKLBdavZzb4OROOm8Bx+LiQIGBvRt5c8XbEg93Mmy+lMsPMih7xUutEC6yeEWty2y54O0pv80lsWVjl/0u+5modDl0SEBU6413nlpsRH+gY1SX//ZFczN+3iQi3H+yORgarkmyqzMcfj7ySMJvk7hFWbEL0ixXon3isyY/CRyCwkRmtY3zLgW+hbV1c2tPDvB0qcmCn4R2NQD9IIj6Qc20IcW2GgR9VndfW0ASwKeWwyY6jgSoW7YJohi8MflRO0rU2d1mN3WOpwOjLVq4FdsC2sONi0k07PZI3NNNQSGNhWJonZCp/QRMyQRZzQ5V9HRF7G6tgd+M0m7o+SbbSqiHm5Wtp1o+O0sw1axUgg2PwOc/4fOuRnO4OHofEkspj+PG1R5rt//xbx0e5dGu6GBZHfLyJzaNHR75H3ZYdw2vpZh8lqlgCF+r6WxQTloBaTbKZ7m9fBJAAmug1JjrWljw+YjJsPpaUv/23vftvwA5vztj1ddjhjZlHCXSVLvTABDCs2UEACY7kBuxxVQmb9RF0bXqDXs/24P+43cJHLG87SFlvPE7exIdx91HyyWPV0icH95h+DR/HJ7yMz+q+jsd6/yb63DLxHhm8gnsCUgp/0XtDBYNQQz9UlWQ1kdyV8ClUk12SSGdrPROrTWU5McjDGj5FoVZBpBmhwINIULoqati1UXWNWGyyw/aIo3vmGjUL+qfl5NN31MFSw2Vozfq82mNFGJbP/jOru6OFPW6XE+eLp8NI0lqkbuRTyYT6ckWeG25ZvhWqrMWbjyE9/pO4q/TlwWZ+ySaF9Lcl3yqD1kuHQ6gwOE4+gY+Bt6bTW4/I+r9+dPOf/dN/KvtsrlsuPDAXXpNFPJD9ycfk5PYNoup37pLdibF5jZqv6SCRyXYPr99V0xf2XqVKexkRS8QKjzbgrUH+BFZr9XQSPXtqLfgaknsEvpwQo7/t2jGSo+S1N8h+FqgJeBTC6jKzV3yE4vzTaxGsFsFr8VEEoqbgVdHjI2iWIyPnLQSdBQ0qkD+xG37boD5Mvv0gfAe+TUbQsCCZjx80r9iguWAR5meOlvPfsNFynkSaHxktb+Hb8R0cJgNhGLCCbxsZLf9k9NUaLZfHD5YuNUg7Wzxj11a06vW0QhARmuQVHYlw6f1kbKRqHdYhfwKp9frJEpEgmcERlcecw0sOZH9RL3kMJFXArJIlrYJOY4Dun5EZvBT+hvxnRyr9YNq39DJKL/G6dR1LVU5vy6j92eMElMxUd/FJfTyRdVBoTzyme1F/NNkbMz6ISw89dmFsc/FEpK6IxwTJsZh/XtMnFLJKoFkPls4vYPWztKf6cyEs8Cbu4jJOd4xHZi4RGrnf83jyt/0Gbp6/dhTAsfTPyGD263S0SMch2IGjCzaPsaYjtrPCddnsE3vSwO/7pl+mg6CeSEsT4DX5D2HRa3WIwJI+/1jJdCElEwnIwcaX50pTP4rBIHqqV9/l65IIg+Ob3/Edv/86B8t17en3VLT7+xgQWt6WhMMaFCHAp4iETxETvoyZWYdYyRQqPkCYdI5ZoiBPW/WajOVUZPBp7BGjA2v+PWv+Hv0gnKiNUhusXHFMRUbol4tlh293bKMsAP4I4Um/z7ITfBDLhF9SwIc3ogkU8JGNqEY9aCMqp5aFy8z9Mm7ycBP7POzLa+o5/oAKjEUWvIhXSYVXcYdy446bIE573e3Wy+ylL6cfSZrSm1S34nSL/n8YlSq6iyyBahu6lnX8qAhGebDwLlqo/AscZg+o8byNsoZDcb4aq0GcOZQPb+Uj9vmaJa+hqi9I8sm/Qxtqcg70mxMIjFthvudyn8V8XVjA72nzM5Gfl8CR8+QJqxjK/JiTbCTHZQAof6/tW0M8nvMXI+2A4RyH9tNZFjwHPuHb2mTLIlQMh+cos89tqEm1ksbRpm0zElpUGsonvrcH9RVbw/rSmFiVG08+LK42KheLtuL2Qf3/lcpV3aW3/BNG93JSMrKVU2tC+h+ReRirNrHQOrIdFV0lUBKZiyKq1HQqCuZcolI6bUm/H5CLIkaJ77+raJLnHC/t9LwELLrhgGfMW9Cm1JVnxZM7kAJn5La8W+PhvAUf6awkVvzgPM49QtnoFw9lznPektxP6maSY1bsuGc55SZQQZ1WZUkmPBEDnuwvL7/PoSZOuef9IzwFcI/l5zFBb9ZPjzFdTow3XU7k/FnC0/2s4qwjCYrykIRgRSuECDlDcOC8WjKz/Y0yD9XbliFzkg7EfMpkkyKl/hH/voXuh0wI6xdpZDkFi0EkJ98b6P9Iw1Oyj2zwHl+0IKIhn3rUSv0PFctF68M/Zd1N8sqSJwW+kLAC1ikY18bCVAsjWHgnF05UoSl6zIfniozpMiHL3q43JJv3p/eq9ZQIZRrxjo6Y7yktslzflfazVoWTiPFCfmfdom5Q+7ye+habfuVT8fo/mX5h+u3iW8+x7/xE+umKSHe/rsoZ+5Nca7aFpMQfShxegheV701UBqnHQi44t+XDC6ySCoNpnp3TavHsPM8m+GpdSM6LSV5M8FM8E3SDyN7Pz6HE/vs8nrufTBKsL+hXVAfvvIXnuVZ8yldjJ9P3MU0lLPlmyHdBb8/8Mb7YS14kM6f/2FvJt/yB5KX7/NjlDfzqPyBrnsN7UMpvqS2l//diMoMpX3zO/cEPk5d1bTfle6RO1WQW77JbAbjIj/Ee8jO5ATOQQ4KXRVfCjCW9BHlxzrHdyPlnJv7M42Te54cT6qBZkG63KOcRlz2/yMMSLpiuPUGvzbLclMMKkxyEK3zrTmhJVdyV0ybxXrKlVW8xnCxiqFdYVQnM212Sofdnwhrmpah1XJAe3pdMJw/CBrphU7eQcS1oHlWPDTv2iLAtbLlmxFOsidqz/blisuM+YnaUcNUxt4kd9ry6Lk9GHTtmer8mkvc6ZoJNEV/kcLRqxV3DdVJ0ihAcLWn1TR472JLSfFeEZCAuqxuS27Tks6FSfZrUZ03eLSC6gwJekuOBwQDveciRDwPhpm/ctUTbdwEJ35mSk6k7Mxzqbx7wnH9SyJS88iIGBFdNhtSDBypMJMkUKnpxQ8j4yhjXzy2shCkVm7fQlziBZM+DEczVmuzjFd8Bbp8TA5Wmyf6TWdubFXtpFIPcKp7citJb0cmtUnqrtJE5Zz3Q4NZ4iXwLU5TIUxSgK2Fa2reiXphzWMLgENOGa5G3WdvL0pN5K5Ib0/fDFBg8OX2YiuqCseyGTktEnRtZkljWOuGbWacpApBFiweID3Zxnei5jrqOlztiVMEVdHF1T+aH3KaPEE+ih+EartJPpGZCgZThSu7VDVc3lf8Xx+DqJqa/LFxdN1wZXvEypocs6EtDVyC2ruEiD0R4wSA2dcBz/kl518ZCjEl+rkDs+ijErn8BiF1PIXb9qwKxgTiC/DulDrOroUsNhIgivgiqlqQh+hw99NUKEG6DCvXzhrFp9egXw005cjuJq8SG1G4G13HBPeGh4vLvGjOpWK1v4yKtB4O06mGbH/G5deJMnjC/ybYwek+/LdB2t97eeN9pO1Aba5OkclTf+KVTvvHts3zjdeogLHbKfeG0GU7J+9thi1ROpjJf+A2p9wB6jhucf29jS7qGt2/iuUpULBa5BA2IMKEkovsXN57tThbCp83OXMb7ivJbY1C+BzHIYNkJsi9YX8Q69p7hQ98bj8m9HAGXqa9iWQm4e8qHTogtYP5pH/rEKS1LprOUXVN6C3W7ORsqVJGp7jynPvFJa6Dx9QXJpBEKz+LrN4VIM5nEC+rev4ToTKaqi+R5yV7LJZr55Sti+qbAsawzRn15l9TG82yfMu66G0rM4zedbmkt1+lV8v/JuwrwOI4lvd1DK82sdkS2YslxzYSTx0zf8004hmNmPn9a+X1WGBTLDnNyzHeOj+ExMzMzMzNzqP6qnp1e7ToKPH6GnZ6G6urqoq6emZ7midSFPg+xecfce4JmgK+cCsc5Kt66LVFv/HPG2NXh07qNHhUoJ3PjALxXXFfnPs/LfWU/90lerjt5ECdTermvqo/xhmy6I3dxcto/SXyulR+QtXj/mHAWAncQpW0OorT1QZRGTtlsgD/7irrLxwzhUeXN2YKP4sHWnrHBjwA3DPg1AKwFWoo0TsrO/0UQu5Omb1mv6X2NGWzakqZ64jknULvVr/2XRqsbCQmg9I9dXyDXLp9aWvzrXvFvDxfv8Ip/frj4Z7zik/1iwpGhNVIPdjjpMt2eKu8zqGT0z3O0ZOqDWw0Obj2hWehoVqueTZu/Di1wYqSD/zehCYfZEK1vso4bONVww00W3PB64QYl7S0+U+2zawaKZYNf4XNmuML7/AofGlHhTX6Ftw1UqFoqwCjDYbovM4uy8EL1AJJEobwm4ZHXVmeDertAM2Hd/zdrGFp7PeD3+u8j0LrOr3CTX0Hh7vPgvqGRwrO9VucPNXqXJ11vbBrtqBsNM5Mst73ik4dgPqQB+a39tcAeO5TpC+wvr5WFzGPXfJibW15xuIab59YX5Tfdcy3w5vWa/pY09UVIWMDxjUWbAMBg0CgAtwQD3LJHD5j/Y1i7YFDUvq+wHzUMWzbccfA7GvFmp83fOlIDbDPGE2qLWdVaclBtmxu3VU1rZltYwTa62/ZZ4W7q0N9hnKmFE19bqjv07GTgr1wSYBjoNWBlw7Eh/6hs6xiOhBbyQptUhRiFnEyvDkw4PC5Y74ZOgaIa9qqH7C7xqERd1CbNC7e7vIhvl6odi6VhEjxkD99xUvVGi7tPpfdAe88sGPnl//zkY36ug8BY6M5WRDmvXV7GBZz3kTe8ixfH8BdB33dKmDlExDe4qx2GrkN5002jvjoeIdeO3QxAXGmlU+TRSbphhMPjbPvhrlVhiCuJ/gPzZXwxgC2XUC4oy98FTDdpeDWSqBTK0BcI73FDN83fjbqt9E/Exoz+CoxOhwaUARSskC2Sya+WXSMo5NTvIpMbi5tS8FMuppYL2Wmc3LgZ7pUgHss3yFRzJsih5Vkj+Qyg26pYuV3Vym/bL2g/rx2ZvRv4qLpg1V6EfiRqnto5l25zWvo/DjwkXAzK3Uc167HCEHZJzsKV87657AEqBbJ9aeWccy4O8NlJlD4EY/svfQqySharb0lACmf7y0cYwOpL+XuuYuTgQeLcfQmc4ucBdUGMHRA1DXVPrqStQrakIvfHfPcxrdNm5gy0coQlJVnI2sfVbZQoo1LuAdjYYBj12ZVpj1JKNT7Y0sc3ywAPcGbwajscJwz/q5zoFV0K6zhhTjFmYFIDvpbG5QhDbjelS5+AKbFYcMCIr8WMeO7FLLXkUHakN3AWmMsuFxspk4hdsFzMqdY4jMaps+SO2hyHD97hyNw8A/1Q64xigYEm22U/ZhmbHBEQ2UxoNCZRCfaTzuDbzRTT1JLLO2OZYtdhtfncM8/EF3UOp8liig5zT1KOCUlEHR0uex0BbS4szWAzChNWHzGkB+0F9dI/hleGT1RzTZytOuOW9rZXxLRZBo7aEXWYhbiBqvHBg/gtdRTUqoKCdc0adBY0xUNK3K5MQF0m8XYcWczXM3TuKEfYZZIzNxHXiTkRS4TlDKTwn7XUtARRNnZaIxaXW2TJNVcPmOZpCwIpVAc9AuKkbZKmTh76zSL/JYkto1eiWzwSzsnSck5ImCkJI0qFcAFNOWJaRa8mIaU6G+EgCWkK8Y+pepm2mTZgW9K9RD4udhOTzhDVViMgrHYtEN2qwgV19Bl7d+xPeM6Q/SlDzvXsT3j2OhYHHZja5ATneCYHQga/9ktQKI3R+eCw0UEvd8fM9L73BuZDIw0MxHrYwHxYDcx1xgQ1rcn3YZTK6ExQCpGFQ+ktOmP9In4M+6gyKQGF6A6kwVDyj6i7xGYCT3GbzGjn+Uf7+YWpvSguodoL+nLbTNTYPKA+y1QMHCpXM6J0c/xkS2QcA4X4EUU2gy0bo8eLRpDF/KsyT6K9f18Z7NdJ7lb07my926XGJS8jaHlJP6SMHwZVL3CFiR9m93Dtr0HzyzPz7jQySrhXEcxINb+CvMpoD/v4Wl1npFHIW0W6ryO395F+WFsuOhO0SZCHhVpTG7j8kzCBP9aEItmMnQcIoP536OsA98XDr0Hqwkvg5U++QnNwUilmYQU/Vxmv6ssGC8DJ+jr9fFPnTa5Ok/M+o94S6uouo+UUfs5fksEqtCLErnvYtPuUIvaQNaNdqoIGJdDwFtBSD5od7QtdhiX0LYzFmGIBXa4rQ+zusRFbLFK17AXWYveBgjK6X26gKzt8ecRiMdFnr/ss1fMO61p0ddMeilrt/bEUikcVaIt4CeIY1G3A1aKgfhtccx+kfr/IOSuDcxNQ52GW+BJBngIKKsA6EilZIiwgJcI1I6n79MUsoRxilnICFSiSFtQREPnXhPkCRh4HniYQugBC9/V+fpFA6Bil31b0LjMOP0yPIDiumE0oFm1FMDokJon4AqrKJ/gn/4ZooBFIfHMICe6dQjarRViH7Ez/dbcx5Rj83mSWhNuW8m/v12W6RQhNVC0vef9Rw3n5twC/CDV0IisoTLFGJSL1WiONpwChBzQr8Bu/lwpQ+oXK5ZotZMqlCn0d+LF1dOA9cvk/cZ3v8qvSb1x+3Kxx+R89yuWv9iz37oG3f6Yxe8myK18EZCCvGcwnvHohBMsYSjPNt9wj8qxWtK4G7ua0/ozWn5MM1J8RemsNKzXSNxjTHo6n1Y83WRgFq4a2is4pQz3+kau8CM835J9U26fL4ViW6UVCicMOa+YAbgX0O/9XL2ArnGHnBISU5J8Sike6BojV4olAki79md0+rTONTnD7GZENdCqrHD8SlD7DmuQujsf649mndlfH4aNvzmnMgzgxkN9bavw1MvEFkZkICwtMXaxciyHBl5U0Z4YynggoNHiwjxX3ikA/KCucTrE6MNYJC1pkSglAhKLRtiC4gw75yNAJ6sklxEXK8i965EqEXL778iWdwrcbE61C/jQsF+T/cnU/zhE6f9HKx3+KgAVGciwzMxzgQE9CDXGbawprMKGtkkqP0i4T+LuG+JLo00hoU69O1IAYCnEJvaeNIhyibcUZKxL0n4rxSAZXIu6FbVvHlQJ4ammJqXduKRh23yUyWhFrUXlDQnjP1MZnh9RG5KuNaI3aQC/Bqrh5qiFqLSkGXKJNTNb8c4DqtCaa+p6s1TG2RDerQkAHcglxAS4P6CunMP88gK2nkZReKuCD9Ipqeu2sI/wS4TNFyLMhjKuiK4Jb8C1fylDnQ2oYF/szKDBuogaChu06aJitFzTEUO/ZRH15aKKsP1F2aKJ8En4Fje+mUvdZMBwkqa1J6m+atNffNJHRv8JGhuNC+O+v8WIVbBWrIhGvqmir93ektiWMFQZYGGhmFAnLMSYigki4cnAHDkwOZ0P3O8n3qBnUgkaCGo804jiMBHseon7jseo2HsleY2XFAQz0yU15hSAUrtfIWkoxwrrvlSjrOGX5+5DSCTiSf9AXvMYA2yYcf+uIw6cqIMT7CqF7GxYw9RsAGrjqkHWeD8X+xsHjML9WJUqs5pza0JwC1eYhLvDP1CPR6FGkIheqyCUqckGtXMlCWUMNLi2VGmswuqRJv25Mdij7NDdonxZ21/bpNf/+F68Wcfx2Y285uoNLXiTCgkVb9cSYquxxtcUppY0xA8AAcWBYikzs2asBmMnHlyPFnKX5dzxzjLiUfM8vVp9YzPJC3yx/d9As33InZnlby6lkFSwXUn9cCVZGuuouVuG5uM1kO10UNCsKpiD+2WYZk37MmLFDUTBfl4L7rxcKKs1ipVmiNGuPINUYHmAdTSqx/Jdcr5Y/Etus/nuCn7jvxHsEu/T6AYJddv2hCXaxMRLv5RglU0JHX6pX13cNma+xOfOvaFBySTZSlK2+rUK45u5K7voAMioeJQDjBnJuvjc28dYhVbvgR88XhqLnvTuziQHZXvXHu6VZkN/2vbSMt98NywhG8i2jjMqp8etMAHUcDJnHUJQxhGeGl2e62xRQVMdk+58pjylEjfZxVqokFKIQrITStjZU7xKCqDpvoW9mU9Idxn3gq/SPTeAblXu+1VeGzWYfhTDOtm+FTvSdAQAWHq5hI9I0DBsk8zyA7wmvXX7994/Xrrj+e8hrV17/k8VrV/1Y8VoBwuq+6CBdH1LT9T6t6uXgQzySvg9c+bfI3lS9YkRmegwPm1nRqH+LKL6BuQkK7pAfzscYAvZJ0scK5u6hFFTmQjL80yuDjq0fxDK4GO95LLhJDCF9bRGPr9qVcNWsdFaDFWf7nsRLx6iO68ri+2L5mO6Lq7ndPMlzS70XV91zKVl8Maac+P+2+bJd7WJrquG9kB0TfmrkVh5QOS6Ilql4nKfLO0tpr8gcysTFKDHLRUe+YUUB//SqZ6EtFnO22rtcTAgaUfWmlkz8ybXgFt0mmWN/CHs8k9Xqjo4c7oYZfGaRMxtQ/sgAE8RlQCGRgi4XQEy7XEaJBhjctsyEnB1RxphbPIZpBHSRpYoElwbgQaF8VrV+ttPyEIH6yIQCT8IoPAxSGqt2YQNmHLuMIBuPOsDgpzkj4KH2ikkKGLj2swj2xeAzf9C522ZJdQtMn5ZM8EAhafgzp/iEoCWD4+vBAxRriqzcFrnKha0/LDvJo99bv480zaPFpPYgH2LVMVa01qFnlC5CiSFToYEoNwVcgjwZJ02AmhNct4Pv/GRgv0zmOz1xn/751tZqjsZ6/MLFiQ+54uIX9kdXl7dppvqH81HD0gzZ0+dLcO/jrzrRrJxormKkHnrq409cvfzSFzJJP37e6fN8+fvzt807OF9apSkAbnpbQcW/bW9DxbnT54tZRFwC/Bia4l3T+WKDzsTG6v7cazFXPQCXw7x5kaPZdO91sZjX0/2epHzaVuLg6w8LFIG4m5UoSB5O4+B3npiGTqUF9ZRp3Xc5HTNBQVEm04o7yEUmMkCHU/+kk0jmOaaccjfiPY89eIt9Ztmtb6uDN98CEyHRoZoVqHugHGqSDzWxqJoP8EkbfDJBCaQi8aVC+STST+ndCT4vPnhAgSsNwFQglyIFHsppKr9BbG0D5EVbD/6TS9KLDgrut9hyyzNvBuH0L6ZzW0m6RZcBCVncimXAhQ47p+Sfs3n9qrZp7pyiIItDrrZItImmBppys2ojV1GpKvqofGjrn+IYjS1g5S2V5ZKsY2pu20o5o4Rc7FUWlTm9Y1xVkU3+P1FPLyyYzGup8zrtJtSiUqAmTQ9Mdi9jgkeTIlFkY2RAPCSjMnIhi4VUj8cHWPqid9nx4ACSDwhgjAPDM9lvbQTV2GkUvo1FRYIFpmkCcz8hc1/Kc8QRss5Wy17YkRiT9TuKuSMrHWkn0gG3GT17tGGZq4KcMLE+qcEHNHszxfNKdMDI+xrkDzstMQXjbAVwkZNflnVklOlEYP3PAcbt4jisQMY2a/eF1Wr9qRBi6rXtrplc4zP5D1d1IjJRrUDjdYB/BzRKhEabuEDA1uBibbOy5gyueJAEUj/j4iKjKTUZaN00Rf0s5IbzhVVsuSMDDIbrpYSNomxRbFaHazpFDss7jUxqi4oupXeYRjGWvo0ZtG7enTBv53tjeTauY3mm1zU7He4N+pIm5Kn3iSJjbIU7aEaVi6ft/lRIriOX8Nyg7lJ94aYEA3vmkCqzPDtjxRT30dSTEg1iT4m/I4nbk50NC68yEW06bKCEtkyAKSaAA7D/fGZRvr7+PH6/2J8E6xlSsmJDtX1jP211yfkMq0QsPz60/WRCQlwcrpI0yyBNJjI6SGQdpzLJQVBceDT2KefgAUIMjkzEWVIwYiAx+ZYzwOfCNNZvXnYprqGre5aLCfPyHAOdj467fsfKTCJQPtpsujMIVC34ZMvpXgnXswWyjHLfrOx2itpAK3Diz42SBOjsSg4HYw+hMygXEGHw+7f+Yv9VLWHjSYJPqYJhq31/WeerkGjuVV5u3s+9ycudW2xkiUCKDpRPrZoTFaIJESII0Gg8PBjtoeMAv4QXlxupmgSpJ+WlKRgCdltRr29ZwonQtFrWpIf0hrWAqVkFpw2U1TwGGRRia+du2uxgTfF4HLuJPlH0zx9EH23PGOQ9BboINepooTQEYfM60ZaEB/f3B07vQ7Az/wduW8yDJNEJwZeMGn1TWBUalh8ZJIyuyIUiktVv3k4qHhU5J86hsqvGYE+dOH8tKmghqjJUVan2m+8NF9QThrl2A/SatgcfAPNH0c7sT9GUDZitI5oZ87AX0Sy6fSXIpd0ir31xVxFYg9SyIOb65aw41WAK1kY0y0xxgG+EQBqssBi+9Qa1x7kDgnl5pIykFFhHsdddMrhZVXQ5lN9R1BWIlDD4I2lWb5wWnC2gHfdCV1lIpedgold/cIkjuyw7mu5npUtP2c7W/ek8CQmUgSq7XbtQ2KOn/Qj5dL3OCV8Vht8+VeGRpU8hQSohnqEjHhnkZFD6LQPuNDqBrvAfvFJOtzEhTwrrzZYtVbKcvsnaYK91n1Ah+IHUen5pT+yfYt+6tG80b2/9JiZH7/Fn9dIiqFLOMVeU4QX/1aPwxIdexY/4Uvjz8/rglFpIJG7rUtTb4Rl0av1nF1YvIjEbUJDYVXv8FRRc9kItcZmV4aaPv6LGKbmUYhjvy7QiGdyQXeE0nuvqFTH65SbbOka63sFpFlYKuEbf1J/YEvjzZBu4l0GcQLDFXmmIwZw+j0kwjQdwIYPbuvz4X3DL6Du4uwrwxo0lLGklx4mCZXggq8zMzTngKzMzM3xfc+WvuSZlxhwlJVmHZeYmzt2VmZmZmZuc3//v2ivZz2VuFFgtzM7OzO7M7Kw3xpQUdwiBBPilDAr31dkZCQRN7U4zOvMXP+3Jh1QWPAONkEhexeSd1m8f7+8ufL6AuemO1u9mLkjX1sgcd/c9By678+vpsEC/VduDYmpm4CeGrJQtOZhAbssW36W+yYWBX4XX5Xbfbb5dr3u4OfSTWb86M89SGZS+k9udtkYhQpco8iQX+LEGqWQZPHgntutpGOk9RtYJwDBLYKR/FIZQvB265rTiYEVb19Zq61XXDHyjCKUfEJVAA1Q2yoVAQ5HYtY4bb5mOtWyu2LJZtuxCS9tl11vWmTEA1S0RgJcrAWAuARwNAByKfjio207/RIaVPQese/0Um2dvfxLzfh7rzF/AOsfVWPZ/91QMy2577b8OlglXisZ93bgU3JaiYWyuRWPZrs5nZhskf+4d0zP1nPp3ykRD55I/AvypceMtW2Itmyu2VJwdjZbVZYJu/wJBt93yAbBw3sFIwD6uJNvMJRo20Ei68ZYtsZbNFVuqAXSiZdVvN1Nx+gTHq9QgPCPrG+gDafxRkZ8Elz+hl1GtMK6abhyf8w1uaSXYxFKo6p0zXdRYXgSnZR6aL8AXZKgRcEEoSTWeTU3MhesIDiWysXaFklTKmJYfcJ7jsNZ3D98PzczGM2RQ2KZ+9VKF5WZLNRqlKFmyaB8JB8j7qwGhMCpDEabPT12Ff946DERK+GT+Aj6Z7s+faRxilQdcOE6pj2J6XrPw5DRVPmuy9S6FERgYATIOPkgsfeq8E9cIUVydhWRk/UrwugFP2xNrbsMBK5xNr1ohrKAQLPuZvq63UN9xR60WoriqBKzEGRlAmyyx/wFjEOVjoOj6Nex6RXxAKt/QgUN8G/xC/EvBLL/Rb4e25cZV5mBMZfZXVJlqRbMYJv5bDpiLiz5cbbtTEgnaeGanSSvvqArHX5T0eCe3qSURFvV3MyflxVYFA3rwU7EFbwRUT+iL0BPqCZHKdD7x0HarP/NGc5h57/wlTn3zje0GAlkhM3rW1Vu/9u+7RoSZJ3adPm9gLp4LwsyUrxubmpqOSQdIr7slv+5AdpAy1PY3Ddxcvopd89jfWYXl0KQnww59YpBymJGMbX7b8FTrbcO0SAvUI5pVRfjpkOzV2/xgBt4dZFZGHT38KOrZEPISZIG17UYb14buA72DOboEfCHHAHl4Dp4LQu/DPriMFmfPeR/gf4ueDt90+lwHTN8qFwzPgfzHVz154J1vp/WHmduvvq7/wg9TIwI0Gf7UHK7dQA5rcvryzc7v3vjocweGP2Y+zt1B2eCXKcmfCLMBqSr+SHr0oUPrr0wQIqjOfoB3buk1AJealoVZotwdEzOzLd/AuXBNEtIoRXOYchlT5CE9P9bv9YuZy2olu+zMgPaH0CTYQ52ODoCUzsztSSVqRNpT4cdqkXKUblsf5wPMs/nlm/umqMKURlSfvzmtI0/N1G7jtpEHmy8kvu6KGyK+NT8PTwAFguYfLgEYdsxe2aQ95NqQMlvvOzxlcTE1UoIV1ddXeYNEiRpiS5uHGdBEYjKYF5vFd7YF/G4DORBLusNTW18dWAin7JQHeeH0vrzY7/I270TPPj4XUYCzPi5MWIOySt0ddFzOpyh7e64951eUMrlEY/vzRj8Z+NVcvLHyBnJ990Q2BsZoCSYCrmAW21WFPoWxxquiJNag3kV3HvFwdd/MdEj5w3tmsxEvzfbJDBhUL4r7xu2x1l3pIKQI1l55xJn/vqPj/vS2Pf6YBdd9NC3lD/n2t+N7e3ufSfdI+XyjkO/XUC5rKJdBiKFF2BNL8D38aOkh563mMAgCNx/ns/MP4LNiDnm2y0WbzJ55TPHs17A/SQLOedR9zwFUdQAGkus1kufJn8ZzV/Hc/R157pLnbsRzjTIW4pWX+KTps1nbNofEOMg8cXnfvauOuVXyP3BzjmMeTcZTAKyWCuw/paVTMemiGaZikQ4cxTlCLmgrs7urs5g+u7truzqLMOMBVi1PXOJiIPPgqeEBmJazlKWFqoJBy/SmKIvWx1DbqS93dqZMKWjfw+oAbpcVeFaWAeNQr5lgf+DbRWvECf0EWtw3TBI8lIPakJR/Ih14Tqb2hbHgxj1pBiqpazxHMm/ZFzMTF1x3RvqEh6/86thjbkxLzk0dube0RopUAND8Ple1v9d7M4De++Tiix7fcVuaOgcs9RzASkhYeza3TYLNkntg5COHzr7Z9TnAQgW/igxPePhjhgEeKXS2lEpL/spG4yGnZTQnzqMzWjr9ZNtStA+NDn6uuXoJMcgokZeUVuMch7TOceiNvpUxVv12VtvSb2KMvuOh0k2ykolqBUhHHDc6JwsmoiDrEY5MQfgDBg8zy+59V8/Wny0tBdChIg8Uaa2MWURRohxSPY98r0Dn7ZfdtEBnixPn7sQbh4J6YabJ/GTBa0FzjhoCPNNy1ArGH+lu0gHW4gP50gLtcbBqf9Fqzb+UO95W8XusLq+LjUsVJdspwUMNtELleARWFlt6N0ALmGdMbNACd//Zg9C/nDH0seMzpfhyU1vgi/6p8g5Xi8fKP/5vh2+DlNeCgCC3Q1VdrDsjyHooG2QZ7HJSU0nzITucJLqf3pKeuP3VyZdec1ya1lNgP5Xc/zImD73j2Hx/7kEmP1pNMhNJGQA5VAW13cctS3SJ0QV/XV2vfZtvtv73MAan4o9nFkkoWh96+paxkoSidcLrd3whcBMxkudeOmYISUvuKPLoxlDV+nUJvQGuKo+VW27ylriuMRTL1q716gRf1TXG172WGwfQ3HZRQO4mdJ46VHVAGLVnafECT2v/lJATXd3q38DUGpfclB7jMS6/uHXTYyDZuUNoLW2fa3y73Ri1XA73DWLOtJ85kFtpjO/0pGyW2uoZA8lNtM+52Uq3jmk/65LFR5w7psdPjGHniEj1jPWcnnNVZ0SXRhb+NI4nMdk7QdluyDsOymhqFcinCLOxkj9Oog5qUJ7rt1vnOQyKLOnZe+/P/1hll8UO0BVjB+wdSniClESbcQNHxw0O8cSoAVWgwwZodQj7Fh1Qh3MfMkpV8UykoTFVEqPXgYJ9PVsFClBEDG2WqiCBAjNKBhh8B6ABXEYJHB0lOIzRPRO6eB8PUtSxFq4U6RgAtipEEHXrXiAEp6/oLIm5mG3pk6f+v+hFPiRqXHLnhONtpZBmPP/0LLGNVBHX3DEjj6SUPmU3wKhOEHhB9k9s2WNkyURGyabLLvVE47onDWKfVpQrtMFPCLk0ci/KpY/2TJmZLZgx69glCqYX43eYuxTEYMgqHB2+0bfR5mXOSCyBFMbMYWseudJHq73bTBukRCBDLgfqyTw8aWDUvqvsBR/mk/0fvaO1/1b4UZklX1zoyv22auIs7+kfgGezF52oEconQ24WqkzbKZ6TneiJbBBH2Svee6YWBVLGrUFG4zi+um8rP19gobV+rp+vu6GQt8EOky6/zi34/TFvzga2uhjIQrV5Qj2VPLgwU/TR1N4AAHi2TFXw61C76MlRh0SGSbdUlOIHdgoS5TsFttopcLSMJqKdgl/gqBLr39tRdcKsHKX9PZ67U+a527/Wc3fouaND8VcmCBG0/kiKpITeKRAlOwXCfdtOcEXkj8Bci2aaU6hiUf4SXHaBaiAPDycL92KwpMazWOJm/Vqvdld5Yj6JPyzu1Qvfrn6dZ8Vf60f5DdHKaACRKWrC7QbnTvMnKq6HJpiSsiqU1M3vmVNSJpm3axygPUXqxd5U4T6FXr9J9080G0veGqQiSvSWZFaVvtaUvrrR6251wv2BofAL6HsWH+RaOheoeyYf5BaGYJYOAXyrXLsCKWJDml82rlCnKVYHmKYEcSohHOnsSq5Lnge6AYMZZLlkeDaWXes5KYbtvCT3nw3+Ydijlm+OljXX/R+nVg00SxGEB7eUvBp3j3B3lwTd6tvp2Z16I0fP7O0tTkZKTE5EHiB5Fe4RnldBgmVvemef+293Ny3f13r+8Y8nnVy/D3zO19+d9PhHeFr3wc+37/kI5r1/3v72nPTncv7/9j/omvPfvOKVW8544dwbLn7/7Vs++eyvV945Y72c371F5Z4g48pRAgoacoxAyG5SsLZbcglwxEmsmADLf4hgGH0xnyirHB0xhlbkGXyRFLBdexFzj3n2EliH3NFNUOQFdEXMmG0MEBkQkkdXkGC0Qcdxxkh7hTFQUs8RB1uQE7Etxw21ObKqoQjFXuvCGUCyWrmhQAc9H4x1mXiJaG/O1dMUoBOJy9BILCVJB8BEU9iiVAo2hWrGMOCi9+RugoQbEmIP2KEN6uYZbC9BLfaVc7zFkrGTBGK7KwmI+C2ESw8WXiGwBVjTOvdqhbpBZpyaQGPjKHSzMNm2SZlt6NRFV99QLsz+Xe8LnSCmHnkN1hfmdFM93foMD6ReHlAz5oFpT7n9kDL00elC3vX5SgmDtuuYis1SYm2NIYbVNNe1NgXBoHRNzK+vqcrUrAjM4BxQSXsaZdBKce6n6Cmzba+EsbdtX2BKnGnGZWxrh4ZC3WMqKIFq8q6UDEYUQo5jABvgKhPiVbRtaS1OCXzUtH/+XYSChSbPs0OWZQ9UK7VvOsrZerr07kcev/vh5tHHH3v8mccfe/Duy8CgdaTVQYOkUaqnFTBqEEqqw+est1myvu7a+Uf0Ch69S9UWNcQc+TjChtHmHjylJONx/kXpfFVq0ETTMIaOdoaQppTJn2AM1foiK008EK74gsrW5VnVUsgy3UNdOtzaBJhhuT+xaR4ACnHoJCofeZJtBLWBYQ05gmqjG3wABYaj34dhJRimOlcHlFjBSDKU6cojW4So6Wh6Rm0tYF3KI9ste5ogbvZu8KxY95io3tx3hyKFtaneC9bdx+XOrJI69CuNlz9WdSozhiQrZHYzahdgUXRRA4Btwu6GxUJBGhRh4GA3oSANi0HY3bGS0ksYNEo3FuUss3Qjy4IJuJQJM4CBxce/usPz3b/hKWZe7nDPuTlx5ujf7i7qYkfs9v+daYamQ2F2j5yik7X/gMPJA8KiQh/6nZ40kFrQ//p/EmGL29EznWgQnzxgt0/4V3+ufZahw/i7VNGPloYeEA09sWKKHm4S40THoG9iHhIS8gEuxq74e/7Dxi1hllv7iCJY5i0/ogdET/O+wYihn/LcPueVzwjWntXLlzz6iYl294iLmxEcXiPB6Be8EI9bwPl7jom42cbZ5842EkcMsxpj9y4WuR7i3xU80uY1Eo0OmZEdrm9x0SqN+PlzN23zGwiB7oogp/ljOKKTiDMXFHrbNRDVrju2KL2YLopb8PVfT3R3Vx7TQGiNd+7+vK5JVH8u4lucTHbE8wlmsJF76X2GqHw04qw7oc2b+UQgq6Rhp/lSkbMQZ7Tmtb2vJ17IZ4dIXVomcibiN1qmW3jWE5D5NGtG5czhuR7i55/+Wruinjj7avfyJRazRPEzEL/jVHCnnEeMMX7niGdI0/lB409JsXLgET2Jzmql0tJ0fr4g8af/8B7LI+wtxg4UJy4Tlecizj7VtiSmjpg0+stV8tAEkUcjXvcoeKleHXFN4UtkzqoefFjOQlzP5sic3KeEBxaSImc6kc4P4symqrSeWmJJhnt49jJ5Oj+I98gdFZOtJaYMgrGB0mw6P4hzDQ7JWNUQ8x0rnwTkydDjAvHo0LJ+/2pC3TXK0eCC7PBc8BnJj8Jp98Iqwj/bWyVTf67IuYhzWfoVnysJe3YN7NPPw0TXRDyzTRpfXEl8LNjUtN9nKWdYzkLc8Eu4xa4Kor2hYMxLnpzImYjXMQ5EXysnJH6+vkZwhvKHuGDKKM+UMsJs2+6T7NfDdAZ6/bnvJj8rJezbHsQc7JhC9z80PwnHlQdLiDWGU6LWR0oNzwV9SPx32zuXlRD+lmJs7xaGyLmIs6oOy+8sJrDzGnYFE2brDMujEWdLMX6fKCK0jGV3up/vpec3xHukv++6WUiIF5+Yrey7hM4v4kylRrnsAuJWzNQ5sSzF4bke4uy6y1efc4kvlu9v3HKS1BmWMxAXvFYJ6CKIPrUYK+MzS+n8Ij5CXjg+8glMOFBWqsvpDMsFvUj/tfQ3tsGJcfm2ZqYTFtL5R1ywTetIYB5Rnmz5XmPNUp1heTTi0SrPNhblEI57lHauuDx9eM5CnNnpVd+TRbw6pVax+vYyOv+IM8aB2PzHhKlNqZ3lKGmdYbkeWv/5t56vfUi8mf6j+pXNyuE5A3FWDLnqwH1CIsb/rM3lGXT+UZ/KVZbMIAL8VrlEmisMzwU9iM890bwuhdhx/FnnRecFw3Mu4lzVb2anEwjybp/6pt8rOcPyaNT/yfWIjCGS/1n2NXvUV2xYzkJ8xPlJYc5RRIfE1cvLWCs4w3ImGl+j2Pzc28Sa+J9Bxr7L6fGFlv+dmcj1J8Lj+d8uS73Bh+UM1KcckhNcIzr0Xk2EtrmcYfkI2v+Hn2E5l0Lc88zMKSx4Lx8RcqhsCp0fxFlBZnsYbKjvbxtn2TS0v0LLVyxfuvUOqE+wUM2LlqPrh7jeO0/rtdGw+3mvFXfqSLp/kEh5xYZ0+1hYPsA5c2oW3f4sxLlRM5KDE+HKMou6mxfo+PVQb645VZUKYstfbO5znEfnD/VxXJWP6XBJu8JAd+okkQu6kfG9iad9+z6ERU7cY606tD4iLuAlfOU8hOf6r+Nsyunxx0Q8+vZOiw+PQWqhNTbOia6/HuLcj5L8Edmg2h2R5CvVhYlOIq5nbm2jlguvNnO0rKYupvPThdQvzbf84BPodOyXZ7Gn0/VDXA8faXYDB36qRSlv09D+EHGGpMuasnwQbHyb4chVoOuHuOD1moD3BAxI3jV4pj40v6Mu6+w3uwD6xBRqz1My9Pj/hKxfi6/KJxeAeojmBr8EOj/RiLPcJ9jxCuHuo+tVhyNGi5yFOHtm5u8DReB5cvviRKVSTFQ/xDPVXHQCiuF81oDxBRd6fmegfrejU7YEyq44db5Xo+MXfPzXp/jk65uWwnlFbKX306H9E+LHz3hP6ymFVpnwTt+pQ+2PuOEGN1/PMhi7PuD4FPuh+w/ER6z5lJFfDryVH5KNdcTo/KLe32RhUQHHBqPNlveJ0fMv4gIvrDuoEpxk9hiuP0nPL4IPyP7H0vSFShUkt6bq+2pMEDkXcYG2pkddFWRNMzYv3q5A1x/xKT2lv45VQ738rZKTXb24qP6Isxsyde7XgEbmzH65QTm6/mj5d4OTdteC8pe1TNlphZgo/4iPaO5I+1oLU/2eHJgpU4mLziGe+fDwgpCnoPxmQmVX1Xw6/+//dbOdTM0TdRCg3z3rdfh3en5HnGnnoFBcBx8+YrO858jS/Qfx93/6Jw8W9MTtmyRDjz8m4t9Tq6wO8eD6rLj+mtCh/Sfijhb7QggeZHM2G3XHD62viOdMOrJxRj18zNuU1+IhKXLBOyR/TZd78uvhyxjDbT/D5ej4EGfyW3tn8CEHk+FfbKPbNxrxKflnHQ7xofxcb2bN0al0fIgrq53bVcgHK864LGPtOSJnIv6+cfGjuQ0QIWB3reoQp+NDvPxEoe+JBjjzzEGiVlaJnh/R68+OFFQ0QOwLyfmeDEV6/CMerSmWvqgRzMv2Xz+er0jH/xbpn+W7+y81AqVnTXanSdPxI840f8NpbISmA7HicuMlOaLXrA56ItQUvhr/81zhLKGlHYmH9k/gcP5+vPMGMGPRS50A+dlP/7wWml0X6/DnrQwd1LqhryOWFIs+mHj8ZcLfbyiqDTfV//mswlVLP0zw3AT+67p4lLgxz0A7DNNQ+5Wk840C66YX4dOZJ3A71jnd0C4KePYeUy7asHG3a0ffz2ynYPo3B41d9T7YabeZ/MyXFPz0+7GYVeuNt3xrXnGojgK78rd2+v1MrDzszJyNZRSE8NUsO2LYmMvn0krdfAqOXHKxjg+9jU32/HHY7DEFv6mBwHmP/bD+zSflA1Mp4IUrHdfJ18Xu8fiqXTEUjD/K9lQffRCfz/8nwz6MgkkcJblde27iRpbT6kYGUWDyUd+HYhni1SqHuRwvCmZ9acxdXBGACxSS0kOdKcgwsfrQzmdhRn5x5XcuUrAlKO7jzPks/JLRFSznJAU6qi0mPdL++EdfH80fBykgdk8HH09v7EzVsU+W+yhY9mnq2fCXt/AGqzGuAksKmEpauv1doVhyrqOKhzEFEZruVc7v/PGFL38vMtxJgW9R/Ia1x7ywZz57b2hvouDKmI7MsRdZ2K2mKwFbgYLgxMT2Ab9bmObeM0cvagp9y+m+OTYeGMQ/MKhVoaDvnfQd+c0srPly24GN8hTYiJ+ASzm38Ov7vra+WUKBSorEkdZ+Z6y1RfprhJQw/8SxeWEyOjj75au6a3MoeCQ54aTzam9s/OiOeLdpFPhX1XoGzjiK7VHSTcqYQEFWSubOMztdsJnZKpL/jKNgx+nUtpHr3DGVFzt+Hx9JwbbvfOs1zf7Y4Kz9D8R/kzDG0k+bFeOO90YF2pZ8I8HRcHt197ZAvCpJa3VCLwl+Ckbzv4uF4PYvxh5J7yKhflWw7nveCbw/qlP99TsSZs6vfTh3bgjemTi9SKGdhCM75BK2RLlhi9Sn7YhvIcHLaflF5rQgfAErdczGVyRYes7e4p9ghssp9stIPiNhfuhWh7CVl/HbiYYvv/JImJpayOzetx5T8LRjiteSQO0fpy1hfwszHbGwe20lCRdG333VWn0Uq8MKHt8rJUF52mTwGwzCWvjPe+SKSMjMuPikln0Wk5Vb1fiKIOGcwPgTZ2EQNrF5IOQBLown5sQI9WB/PGFlxNkHuSRsjQlqqm7xwNfZP733KosEW83JnNKW87izQcQe+UckfLO61LVpmjs+OdC6Mva+sPzzgTljNYKwV7KPV23OIGFsmJdS9p1L2EDZ7YZpaSRIGC9oa93HxlYYb2kWSyHhY+lcQ7cydSx7k7nXsiQSNLj75d+qBmNbZNJmHksgIepsiN22Dh9coulsbmscCYk7Ke0SNR/czUQr82osCekf5D3P73bFGUXV6ptiSDAz23O+uTYIX7rIxFnzHgn7515lJU8xxU4l7WgwuUvC8kU2BPUwCK/RvmYfGU2Cc666R9q0gzjxavyZacJjMulIDuWwD1eadwB7EEWC0Q2BsU4TC3cNNvpxRXj8VNfi6n7p8/hp2673Z4THmVe8udtId/z09bgtocJjr7cmUqpz3fEKh3V7PgmP+Q0SNlXhbAysWwychNdfGLczt0n1Eu4x8tOpGcL6HOI6GA90BWOqBcoju4XHJoefpbR+OoDt1X+66rOw/uuePlQquXsDnzZP11hWGK/6au3eLKcgfHrtjhBPYT6kBudqudqw8LSyxZvmCfN11PTkC8OGYLw7cEPYy0QSRnhNsnRIY2Mh9l4vy5JJePSxp0Ap2xd7HS23rjOVhMF3JeHMrAO4z4bHs1QzSNhg+9nc5dslbNW5mSHpwvZ00ZFKkJYIwksHA8ZbCtt7hdRh75wka7yzpCZzdTYJ5rnsyz8WH8Yn7yqv2pBHQvKPL4vWrw/EDfVbopw5JGz3s39+uNINzxOrPN7LJUG2NkD+d8YJjN0T4xxQTMKTU5KtGvVHsMWL2+fuKydh36K9i8aUeOAHOq0v2VeT0KjS1u6+wBtTU9jWFVZHwswnOJ/3JAC3Xqr7YHQjCfUqZLhKNRsze6g8PfIlCQ8tTh11dXLFiIELJodahPFG+N2ueeOMX/zMJw61k+ChVhV4bp4Plsa3CIl6T8LPl7xt/pfYuH2W7woxkoS89KY9L4tM8F8zDXLufSZB71u8zqRYNq5l3ul78ocw/0Fpml+eOeKbbX71nR0kQcPL7FAbGYBvG3dXOXMsBTXNtpLPB09j9QXb2VITKEi9E/jzFycAl5B6blk4jYKHEzKU04+ewsJ3uTWHzaUgeCDKSrXdD7tYN2ibwhD+vbkEz1/gim3nmSr2ylLgME9fM6NmH/b43bjgI0oUOM4NPLzykAPmxKaaGKspqH9c7TLHi4X/LLI2GQ8UHPs5CNZp/vhlT7FtCpsp2Jp0RjN9Ihvv85wo7mFAQYKYTrxbzGnMI/ZX0xwzCiYv0mNEBjjjd1wqZrUzhf8/sKDR0MIPc1N9PfqtEwXbD41MNddyxZiPRn6WOUWBtO4jMZlGZ9w27JLa7csUVEzcrJ0r54mvuPt1xiZ3Cvg3tJhjsk5j38D7nSKbghMnI4y6Slwwlx1lv4xCKegJ4PtP6/fHX7Fj72XEUnDl9OK2O+m+eK+Dn8KWDArEGclr8SI/TNbCjpyfR4Hqp6SiYHlX7HbeodXyJRSQbjyVpP1emN7Go5Zn6yjobtfuyFvth8/ID08beE1BRE3ATm3Pc9gLduT1gncUeFYz1xaM3Y31nvD/D+KtAryNndmmlKbMzIx/3oLxtd5VqG3KzK3DicvMzMyMYSoz25uUmZmZmbljR+Nr6/oy6fPxZOfMzpyR4n6St6mW+vqncyjHcTwncCKn4tSchtNyOk7PczzPC7zIq3g1r+G1vI7XC5zAC4IgCipBLWgEraAT9CIn8qIgiqJKVIsaUSvqRL2KU/EqQSWqVCq1SqPSqnQqvZpT82pBLapVarVao9aqdWq9htPwGkEjalQatUaj0Wp0Gr2W0/JaQStqVVq1VqPVanVavY7T8TpBJ+pUOrVOo9PqdDq9HiTqobweUuvhNj24mvXR9xnYI9Ro6hbW3a0hzxmNwQMGBAaZ+vG8xmjsHWHqarTzfkyAFn7uEti79y9GCBykMP08CIranwZaL+yPXOFC4Fw9fQaC57t0DzcFpz1gtF5rTN36BXYxWYPD+3aFB4RWp+D4KNTmcHyyaXWIvfp2sz6MpSF04P97oNZyqowIfyudnlCruDmPEWlxWQi1SjpkmHHsy3cYu+Rjw4erlw6qSmbEeYaeUQaSI0JczFC/1eTqqEq7Bz0yk5VdQqf5TW1PGlVqMO/K2JVk+I6988dlu0V2FJq+vvqZ9+R/2QaZ8hS4RjDv0EM3L4W7rzL4uKXcsua/XSC4W0ZNMfI0fUW/bfnaEf9zTU8U/N8IsiX7sB1bx44ghuA1iY9iGpB04e7FNJ+nkc+b3Vv5PtxICuyI27o21kyadOyegRsx357/6rJVCWW+VJEGnyzT7i3kn7Sq44Od/XKRKifjl9aZ7kW0has3GLu7JbkrJU6bXrsOWeKuivIP9SLGhJeZxex9Sbmz2sZD2s0gD3nPmKHnJpNmTz2HdH3Vxp7/jW+Ld2ceDpFG5+hn9ob8yurpH7e8Sk9CknoO1w6pTG5NG14ocR1PvqX0ifOvl59ceXJ20q7uanK2+sf8s5saycXL0WcveHQlSWMKXxrUuQOZ1aThm3XbSxN2/l9b9//ydsv7geHRM/04pd+mO81O7ByvFOjzgdwvv1/ptORE6In4+8rdo+2uxVcPIUXGXDgRNNNMFnTcsnZRKzevIkvG9Wr2roJX+1VF+p9qVd6rcHJcTtPHPCkLIqOK+nzavOv58DaHrfnrrcpw6F7x0srabQldur4NUxr15k37+sxVliZ8nXA7IlZZn6ft9/VNmhP9h8H3+VLLSZVjITlK5TpJ5p/cnty11QNSTzPkeMZ6l0nGyO9fPLuvVxodmH466bja3Pzp6iaPIf/3i+nF1B55lUsFO6T2fFJfMZ4tXPv0+C7Ku2LtjdvCOit3wk8fKXe2NpGe8crjnGPJoiHTfBtGJJP45iXit6/YROpdP5Nj0M6lpBSftUqPewHKqYr7fCu+HG/OvbbOzGnSdsulhjtMYzK6K8NnRKTcShKV5Lq5r8VU8VOadjuu1xjVyveQ1QMmTTCQ7cVHXY5Y3p28j/Q/lmnleFJFOVOnQrHx5MwFqWbHYcGk84Ni98edy6fg+cjZuhH6aaNWR21HQr/bIfSMT+3tNFuxoJeNXlPPZhM9Rtvslyk7rVaZIry32so16qu8Iapv/8y9qd0A9sKTZ9o3YHsfemLW+LjNiOC2pR/s49bWy7zhpuJTet+mhzUqu/t2edEmsGn/hr5udPAAASACVAA1gOU0DsChxWsmVgfQA/7fBVcDUBNgcMFJABlAXHBeAG+AjwvOF+AHqOWCqw2oA/B3wdUF1APUd8E1ADQENHLBNQY0ATR1wTUDNAe0cMG1BLQCtHbBtQG0BbRzwbUHdAB0dMEZAQGAQBdcECAYEPJb33P/xjWOUEAYIBwQATA5sZWJaBvl6PKVJosWWkcRcvSIdeSnNjf1ZyF4Z25AJ0BeAI7OgC6ArrRWNweuO6AHoCflejlwvQF9AH0p18+B6w8YABhIuUFO+m/If8FGTr3w3GoDvJY/s/k36J7YrkfsfGC1pV/Xv2O1pEO1azbrPueULS6h0DarVeYHPbfFhS1+ZONr7L9p47d+OIDWQv0WGmeh91mwLtahebGeheqxUJ0WqstCddjydJ7x1Kbj1tALaNFvt+jHOOrHfrEu9o267HVQH9WB+rBv7BP7wn7R4jxhHN6H/WA+e13Ug/WoDtSLemzxyyLvydRaGCv/Fo99YV7sF+tSHXZd2DfqZvqzMP2htTDzg/dhPuwT+7L3i3WxHtWDetn1ZH8fkEc/xqEf62A/2DfmR31YF+cL58O+nszvt30+mM+Hhfl84DqjDqyHdbBv1ONQF+frrw2914vqVSZKUs9PvvViezc17xvVbtmYb+3N70+YRnpWbSkllQho3b+8r3Tl4Ph8le7IZm3dVp8CqjYx75uY+e2st43NHSa0CNj2zChNGepey6dEU8kzusG19rX8zUcrtMt0WtVRotZM/RiH95mxLtbBvLSeRPVIVCfqQh3SAmOTKUVDO0pX2ngubdmkjZla9JvRop9a9GN+7Afzoy4J66A+nC+cD+wb+8S+sF9q0Y9xOA9YD/NJWBf1YD2qA9cH9Zgt1b2F51/8JWrNjJV+i8e+aF6sg32iDtSFOlE325+Z6Q8t+jEO77Pnw/VFPdgv1sV6OC+ol1lPtOi3W/RjHN6HdXDdsW/Mj/qwLtWHuuz9Yj/YN+2T/XyYmc8H5kUdWA/roC67HqyL88Xsd/6z8d/qeGFhHOS/0eGhOF/nJv/NvJdWmOt/SUd+po6K0cGRf2f9BaZOHUYH+Yd0FGfq1GfqtGf4xuSfWX/C1Alh6vRg+IC/SUdZJk9Hps5ghh/F8D3I37P+/kyegc51Rsxk+DnIY8Cf1FGRqdPZOQ+ZzdSJJ8w1w88gf279mzrnIZOYPCuZOjsYfivDR/5OHVWd45R+ivM10++I3YzOE0ydQ4yOteR3rf+I1kydBc55AlKZdbnE6LjN1LnC6FB+QYcns/4jneMitzjzpa8489xL5v53TJ1njI4ThF1/PL/gPgbPH7gPwfMD7iPwXIT7IzwP474YzzO4r8HzCO5L8ByJ+0k8v+E+Ds87uO/B8w3uc/AchvsxPI/hvgzPV7jPwvMS7pvcfmHkAwwGFGD8H5P6he1qulUeInrfO5TplNwrwWdRhcZX5a0PzobF7r0td+4Ve9Wv+gN59J38arLhsbz2Y8Gwt/pn8rABDSpWT3ouf2mQ88Ej+YCcS7nRf4pxv/ylb9sdj+P3ypaah4q9q7Bb7qRbVW3NfYvcOnXJ/Ybtt8rtK6ZEr7u+Rs6VumXjpaOLZdQxBDAUMAwQARjuuOyAkYBRlBvtwI0BjAWMo9x4B24CYCJgEuUmO3BTAFMB0yg33YGbAZgJmEW52Q7cHMBcwDzKzXfgFgAWAhZRbrEDtwSwFLCMcssduEhAFCCacjEOXCwgDhBPuQQHLhGQBEim3IqfKJIT3qxI5/yAh2SHNwDj9yBZ4R3Axv+q38NFHg/qd2Pi0Y/D0e/+M/cH+df8GV343X/Dj4LQb/Vl+AV/etYPYyVgFWA1nes1DtxawDrAesptcOA2AjYBNlNuiwO3FbANsJ1yOwAntqfk/7hysVzijBe8lsoepYa8SMm8XB6T29ujzJhIed7gooHbEqLkiP+L2jXmXbQ8OP/q2jcHxcohZbK1OeAdLxceFwivRLnymqid414lyyVtY7WcxzbWyflrrMtXY90GuVahDn1O+m2Ri+/vCa+d8qzy/vBKldO+zz0ot7CNszL77+nB8Ks1o3I+qplb+lDTo0xGw2FDDkPFjYUMWc+XM/gUFAx8dh+DZk4rw8sXPQwTJ0wwXJy41DDFc7tBP+22oYJ/XunokfrSiuRkCT7VcjrrHKe92YDGOtJ0bJPDbOMctffknlAppsdTS9OtJcc+bnIBLfplyEu1Mpb5Pn0nYBfA7IKzABRAigsuFbAbsMeBS0eBPyO+w8gANqMVPxgmq4AgDC0MfwaNLWU3IY2Sk7YvNmAh0iU5hU1SURRrStgtHSYG3ThJWxrsmtINcj39dPoHBIHQvuuYrvFgUF6CZ5ayNCzqwrYujz/ORWN00gS79b/IbEzmoU0xuh7zeG5mzErBZkS+KTMt4hnfp/9C/s40vujH07V4P6aZylz8eoC0BV4YBVnz+pQOG0N1uNipw1HrA8j1ZdM7U4/G4TOMOyvABJUWRLcexX2mO1VBmoiUybJs7UMuOxqg9M2aDNk9fPz+mCX+bfToCBGx4QgDbt+YeccaYavjqI6ywH9wGa3JbszKqkKz8zzvE6ezw+YUwlM/cfCcA1cnW3Pc0JmQ6mFk/zRDUFCNUgsJniT8if+7nbgdy0OmaDkVToWIfKlnS6gCR32LiJt2GtNbDchYPiNWXwABoWE0ggwoUP/C2bWNZAaqs2BJITPcWrjSu4PFM3UJbi+l7dB0Ak7OxnVeAK88+lFV8kNCz4T7k0solLlEalEBimZGiGNFWOAy3nsrcaHkPBq2kPY8gLT4M2iZv+KNfjc3xktj5juI/SUFvN4kYxfQy97blkhJfCZvpQV6r2uIP6DNvLllvD7ix9ZNc2FmOm2iU5GpbOKK2jCOM1w5Z2lDysBygoKrmePwEPUv4XzK3UlLUQW7NEWwMniJZOMbNus10nghgudz5JAL+8K7zWaUlKoj/F6S5sAypPLW0TE9HunmbShPWkToRFtCV4yg68Q2Um8HM+NrOytWmTDe6QVJDdXctDbG1aYSUbkYXpxLQzCune1+wdwoCMXmj8Mc+fMvbh3biuebbJTi7OjMLeP4vhYW5DthXrqU0hpN5BKeU2BznIlP/Bi9YDITl12gaEsR/xabYnb3FEh18NIkFfmVHxl6NR5yBpkRVY5X5U8m6XfxX1sI9z4X8rhXjkiBKPK99VEWuYfY0g4OT7xI8ix/lO9fYXlEAf7qKoibu+MTfxK3zzNRKzvN35KrMPr7HZ1N4XyJOsO7Twc4p3aGwz/csLbWJHNoLCvOp+EUswtvH2OOW6lzReIRWR9FOK42n57dOqgKTGOM+AhWCzuj+HMzy5NOsvvzSLJfz6MnMA6PFT5ckWzhRFQcaae6ebZxPVWi7cw6q0HX6iDu2jnToG+NodUoDoYHY75BHi37PNyrx6O+Qp1t/9vDGu+XLN3kgZhIPgpdLkx2fIWs0CWsRq8jTa+Ob77FHOqTYqVbINNlMzjtIk9JeQqpkzdx8p0rh2vCUfRZx+iYHPyEouhQ9YJBWb55J+BYsBL75iWcaQjlhsEZTKKGGBN2DDWjRiJ0LtHgdQyph58RbtJDQmsh20OusjUkkvETIhj3pZpdIbeoG16N9slxbJH2xTZWApuyTB6HpzPeMJvn7aNZuUeW7w+6qZuTiejkJMIXqGAf6ouIngZjo6awXjeJ6TcKuPXjJtsXTMS9wAylvRfJszjDKINQRFq7WWh4DHe1c+ikCSE+S4Lqwm10RRRRkrqaNaWxxGtV8ClRk+SIKBqMnZGxa8T3WAvORzcwWKfFzWvJNEmo8TtAfKAWezNHfgg8RN5BFUuLXJYP6+Lal86enA7kIptIDlHF8Vg3o8sk6J8jSM2H6Sy5F4Pl1H/QrBBhjfFXJuXEoDH3Pq1JU1jrkMDz/FjEDMax7a8K5vb54n90NOFSPpTEbcTT4x0t3+HCqs0U1T4kyTED36oqno2czp02JY6dy6cw1Y+wFbX0WF2lJKSTlFYVGv47j8H2LJ42unPy8UwU6h5wY74u3DpP6sZIHliORl4pjdUhQdQKxeObNBb/LdeQnKhA/UMl+j8OEV73i/CcIT747kIwcRD9EC8OekgwdGgYOX0hbJw0UJAOwyz722883eIfdw+inXRQy93GgTcrUG2S5LGSCfNtFvPEqxLVskfk7hoihusI7PrA1oarzPZcju3E56RvP4CXzUrcLJo5t2EE68y1mPHqIRptRUzysMZK9QMHlROZfreQa+qaCD+M4dudl0j2zOYflw/IDvshPiqE44ZKrK24yqzYc9y7/gIVK1HS+oyZUFtGYM5TLtTlkyyVTen1fQi7bkfZXApZzAme3MpboTAmi9lz2ug4h3IaqR1SwG3+A/zDFyHQ8Yv03Ms4u65llUICa4u2otSbxZutZ+l8HM0Ys+PM0o0jxtKayQZ3CNGOpnzWCLwbwnjS+IDcnV2YOUxghJAbx26ncDfvKevNVzBjYCzRPoXcENQjz3AxgvX+NC8tZ418P69L/+VLhxEB9o1csK+mJkeNmDOF+G1+icv7YlprJ5Gh+wfLpJdhvsea59ldeESUkKJsxVjTH0zTN8am6BDyQ1/5/LqDOQGleJ5ajHBzMcNvjuPh+o7bQyVECucTYLUbt9S7VHhcQt/Hn5IJrvRUJSL/ZxP3n2TwkPW8uzuG3Rnz+Bi4k93VRxgjocg+aXGCHKMYIS/Jlb2+DA3lYLG0hZogTf6rmcTRjHSKzgyiliBLm0chUcWaVCdYkJZwn6rysUwMV8LTchGKFuGcq3zP61npuO1IQl/hIhOsyxkSW8XbzgFO6LnzLkyRry8PMJiWSMvPZygvfoKKjg3as02ZWvMv+wZFGVjlisq0ajamHWDNuWNsmlOOgnk9eSWvEZM5zRSvR7hE27Ng604MNvwkeMI4Ou9PYLCsi0VZSr/1J1+symnYsROnExeI0GjhidQjbDZf4K1lFutDS6jWH0+D9wqUpjVwS/oasxWXsaXjDTV7z3J5Ux5rw/qxEBzk4983CZ+jiXbqHJwi6zH/ksT+BdqUfr7A+jExnNO4Q+KbsbgIrMDhbivBh+M5/L8z9D3TZHbEPfz3r+Js1WwMr9RTv9yct7t1cfpuzK9LTex4aY2/UwwZKXsx777OwsNzMcowZ4uHMLMVwtBZHkr4+098vPySlQOGDFt8Zdq4Uoq3HCGqfyEv8osZV1xF3dabLC8O46CJLbPD9FD8O4rxNodQ+J8/IYpTMMmdyOEFJ/nrj3ASij7wsc6fIt0CFnR+o8fp9w9E5OJwYyFLIu+QHSBGzPp6ZBvscHnbwPkoGRLko3GulEPkRxqmV2ax5mwpXvvtCAqYy7h0deK7TjDZ4jOz24S5f0kBzyAzYmXWc78vmf1NrzndYIOk5sjfNa8Qev0aPj/c0Tm+l/2PEnFT384y2W2w6AfP8WOw05wRW8xo/j8FdwHX1PYHAPwMEIuYoH/bh108wcbnld8wwZrYgYqBqBijUzbCoNzoErFbATsunNENAxsQePik2cZgNNz/2e3v53R++toLEDk4qv8rqT7+Xu9kSl6CmI09FHlbWxa5rVbZb7J8lSqewWwPE5Vn+P5eoYo/tePM8sTq2kz5sm5Aonp3ftF3/FeT4Vk3fWKknSG9+B3fetM3wlrRBajWUv+3/nd8KVj/rwdlxG7zTA69/4bLXmePtkhRWSDac/gb/qhltHRTKDGa4CJR+4Znrp0xIdGeWCS6UvDoK/457X4sdyfxDvW967hfcdYs4ZO9S4k5dpkru77gsVUJdq/GqsIfDT5M+IK3WuXsPNmlBPQoYFXYhi+Yaxj6xvYH8fvkVZ1tn3G16FAh/ZGYJ1xfEvUZu036qTiWQHwrdfw0zmd8de9Gvb0CYsFGWV1TOf5s11ASfYK41thkckQ5Duc/rJu9ifhaRXC2aTn226C5lllALJo7/9+mMlyT+rJyhi5xj/nC85Fl+Hv1sk3Cjk7iD3G2ZmWYM6+6dN0P4hhZhKRNgvPuuolNU4nZlRPux0lw4OzaTP4d4vcndtZvkuBl/l9mDbtGLL+yYUZLKR7998TJJeeJk8c7b95UindPWPX55y5iY/aa9fdK8EH/1+vn/qMKb1qvrVaC+3vGmb0xIJa7zr9jXYxTOk0rfIcTiyI1WOIiLBzad1go7SDlB+ydb1CEm7aOvvXzq8o+IeN9CvHCdLbYOpVY8rkov64Av69wXjjrPrFIbxFnQwFWkyQWzwghlk897fooH0/x8M8+5ExsbH7mvFY+rlvx3KLkMLF4wwMD+zzM+bItxn2jKnzsa+G3XDyrkCmxMiLmHafeU7nYQvu2s+sEYuuV8XF3c7BolenKPBbxrXe7F4/OwWY9kZ+2tyhI+lkulxyzcdnjiWqjvqqcIfSsysILBt896k0jRuWWhhuz8NPJWh5THqvsRwcmZ2LjN2OtHcJVtrCLnZyJlbf37eu7RMy5J9p9NQPj1VPjX50mvuXe86EjHacqhX4Ju1Q2nJ1nnY5Xj8h/8s6U2KB7H79EjN9yHi9kLVCFD1lUUWK8xKwoyn0csWALnboP4/iB8qkGLGIOJ2rEyjQ82nybRWdrO3Gvacz4VHzGRrhT+YP41o/ttr2fsJf3vjEzs4mtjQzcqz7ipjmFTl4pxIJ5DZniD/jtJEMt1k1iscOrjQ/e41TeW8/kQGL07BUr5B1+S8tmB7qqbLKh3ektrli8dXnISWLB1fM6R97gX0fnij5YEtferrYyf423li+5pwPEt85u+7n0Fa7oZTsEGRJbZ/e4G7zEi9+0zjOeRGxwPGajTgpOWuZf0T+cGJWfPdeXhF/ZbdeVKuWAOK6bQyqe45LEBYc1/yNGl/9rpZ/i6fcNT6wvJxbrcQJuP8aTYuq8HopVVlu6/9pDXLYix88oiVjwzfaI/X28Sv9WTGWCyjYWgVZ3cU3DzqSnwcSccSd/W9zG/fO2GyV6qsJbfMUON/FE4fLgN2dV3rmzfU8cNuxtvS89oLJP6fE1UVhkWFZsYUGMngT3zwvDj5/Lc3JMVO418FwcjB8vcde3mafyk8PLJ/pjc8fmubMmqNyaoa7nhiNTxmpqjFB5lvtIDWs8qW9O91+1MmKRf4fsIjg1H8uYclvlNcvNqq7ColifZPYJYkFG1t2ScCh+LqW6ZhOjgLHpifHQoB+qntckJR5T8iP5NjxNKXQTvCAWsySHAu9DvFbCnUlOxIIfHD+rx/AmdpRf6D8q75Odnfsc9sZZj6xlEYtj/sQ4J0PMJ9c/rII2Mj7av5W7XoJ6qNdoRRgxMgn6teg1lFj1n3pmRSzed/WA5ltIqD7yxHAuMTq73KXiHRQb2pleULSS8Z6yfd3TD6Dm/vDO+TSVtT/lun2C8yNWnp8TRGzQsER/XSpo7D+cGrFfFV5tv3gUhuDET0vfzCHmhC4cZysGaGiV+ilbACWH+V7elA7pUZXOg1nExgXFF+ZkwLzNV7SmRRLvyH7wXT0TDE1l2XU2xOylVGZNJgRdy7c1X0ks8LBb8TELNhtPnb5lJLG8bN6q8GzwlikuN1Y2E0+YVXw2B+6ssV48NYlYdKq1h5MLD/d/hnpfVfgkpXhcHgQ5jpRx9hELunbPb8qDuVueihYYEnN61FZ8yocyRbj+LRYxMpzSFlQAk6nKWYnfmwBJWFaWhwpBlJI7bPYLYjFdZDu/CIxKohWLLhNbm39d3lUEzlvuST9aqcI3LktNLwYT84aEnGXEtaXvWcElUL/T1oirTSwaLx65pxQSvjPXd9Y3Anr/l945HQl4oaLEEkwsCdd5by8Bncy0CnEsMe/KTbsvEugfP/PJXCdV+JalV1eUwYi4V88Ql9h8pq12TBnsMbVptFhALCiqZXrKwFqtM5KlSXz6xPejB8ph/t3aE7PrGgA9GjvS+EM5PH9T5foqjdh6HdthwmfImB1t+ySeeELr+Tmun2Gf5njFcHdi46R+7tfPoKX/rbJgL3Gt0W/pki9g95bLQux6oA6tDT2n5k1Fvt6mjozrwewwMm/GIZTblwhttKMe3t3/duUh/zr1/OL24YhXD1tn77ZrHjhGvdCtGWKE9TCoc2DrXG8vms4+MRwl1wOrosr8dHog3ZVuNQ1J6mFMuEXCFPCjTLuGtTCyetj1d90kDYE3LYi+ooPYDbDTfaT9KcaT0muyHWCMGmDW1dQ5dSiYOjvGp4bhNkA5q/1CqNoFWnTDVhfxGsDpxu5i+wFbenmedx8jbAA/DeXN9DQfqj7DYIhJagCbk0Xzx3vzaJQPbUxpA0wJ8hzhIBDQLpPmNDGyBnjRm3B+njiEarx7QwOxG2Hp1j+W5fwASmgYPh4ZN4JPh/HbpqFA+objUk20oxHo5TZ2GAdQOQFrDRCvEZw9x3TY4CBaw13ZwggbYV/hmjsXUABdo0HPQMmNMGpLrUkNukQHTtb6w5Q2wrBEZqM9ukavux46wMgawYTnIfH08aNyj/ZNQ+wmUH9d4xJqGkB98Nyoj4ybwEUtZst2AZ+6OFxaz3CbYNFx5qfcW0iX6VHVzMUm+GgyJ+qJL4/WDtzQyQibQPboZOhkwVXadFHMLyapCVaGHwys5VylT/VbkPar5m98+ogSoCxvtBsgeROMOnRt7hMIpDWTN4xB7GbYW7E/1pxxovq6Pg1Hxs0w4fzCwKdpwZT71Gg22tEMxu5uvwqGrlHmi5RTEa8ZKp/+WONiJqR3Lj0wBYmaQc8lw18NX6e3mHIXoORmOAoMpTF4hi6b9uI7U9oMr3kivQZTX9pNw1LKyJrhbrVOranmWeqQtk0lo9sCH0b9ZZKneZDaV/BkiDFqganUTKdpLHe66mPkT4bbAokLrpxmM+70DZubsxCvBUy5VyQbmECK87+rvYywBXozM6Jch7wobqFGOZPUAlkLFdK5zAl6g5VZOVPaAtObV0vfMefompEnehhZC1iNXhStbuZD73J58y+j2woTz76LOJkeRP3e19fOGLVCW45xiGzoJD3rP1zFcFvBeVMrfRr86e4Pu9uYi63QWrtLftfbn/oqjCXj3wrtYb0hmn6OVNz02dNRcito6Ew4eX3wNH1jY8QvprQVHJpzp6R5X6dcsgabGVkrDF1LfL4q7Tq1sCfuf4jdBvYHPzwKveRMTe3W1UbGbVCRyzsjSg+gsnTdmxluG2gN7c9eqbOf/nO1ahHitcF63fRt3wR8+olv1XQkagMrq8EIoZcT7adm94NJagPvY9Ozp/KDqVWbzs1HkjbYlcK8vMm6RilF6/8wsjYIKNqZU44uUBFdT4sZXSmUn/nbgOPHp3/l7axkjKRwcsTkgnTkScn+t1bBcKVg+TQi+RHjQI05EtjIXJTCgTRZimPXPlqbuTkGiaTAyht9JETgT68ff7+GSZLCG4N1XzWRG3WbrzcJSaQQZrXXukdtB51FfxyO5FIYU7/88HrOZVotxEPJ6MpgWKhs1eJ+Lp0b+GcaMpbBnjGOimc+gVTEMl8lw5XButzvX8wgkLLb+niAuSgDZ7eYKZ1qx2mzrN5/GaEMtjS4dpZdcqW8f9eS8ZfB4rtecRNZF+mb/7lOQRIZpDwr2SL1sacWZ9Z2MzIZHLzKY60cdoG+YG3TyejKoWLUFIvn3oH0fo8rHYyRHGpfDmSe4UfT47UHBhmuHA5FFC4bwtGU77ZidcSTQ+He/8R+yJdqLFSQ+SeHSc4r02qY87RNhRYLJcuhZU79Cz6E0iaf77GQRA7diebufZcE1OBgRR8jk4PY7htvmIYrHTX4cTRit8Px0ef9vwiuU4c7//QxRu0gWzF4sg8nUD/jvpL9tx1e7NDjuaI4Km7PdLL/tYO0+ndd72AINWf33AFG2A6ODqurjFEodYBao4eS2+EaS13gzo+l3t2c38OUtoNtcOLTJb02NPoS2MnI2qHl0MMEzA+n7l0J0kJsBcw4NBhqJ0ik1NddJvu/ApbixJYMJpzy76IZhqsAh0WLvBtYLtTP6fOVzEUFHNPiu3wa4FPUP+FjkUgBC83UqAI1B1r/xJ6xKFkBan8plvoKwujVO4damFIFKKq4Jt7MNTrq+fvRSK6AbDPjHZbMZTqpzqOf0e2AhHlHrtkjH5p/9BlZ/x0w7t07OMyE0nttH2ihHR2Q6hs0w5cfSU3v7h+DeB1Q9FU76yMSUB+MDpD+7wDLhy//ToAIem35Lw2U3AH/mrjw7PiXqX35L5VMaQcs1sPsf9Q8qAmvk8n664DknSmnzvNjqM6kJeMQuxNmXZ54dGWPLTU/aBPZ/zthnWWVQz3LjzrxOrKB4XbCwYCX788wAVStswaZ/52wW5ERnyKOpBvSL8oYYSc4LPhHMZITT2k8TPvDJHXChkva+B0TQVfPZY9Hkk5Yc7bK/qQ4lq4zlesieSdM2XV5dAA/mirbUqWH2EpYce+UvY2GNeUxd9j/kLESRi6ZWVKCo+itvMpWhquE77eHDXNQC6Af7z4qYy4qQe9kvk49jqf02PXjkUgJIlmST7b3NSrMNF8dJStBrIVHjTBLpOmJFlORRAnzN83uX+ATQ/+/i7uAiir9/zh+hxyka1h66G6DuM8y2N3bq7L+XcBaB7cIY2xs7Dwua9d/13aQ++hw7B57sBiTsBVZHV35PQ985hzOKnDv63wnT8fzfc8u0tY0vXibaTXymebgpKXSEML30NHHKEkjnb1+NQ3cBQsG8VMV20vXwQWR9MhvV+/cvgjrAkgU31OvhgWD9CD9m5WLX5gtSTOXsL31JtiQQDfENeT84lyD94ulR/keeyCscyfWF+tnTk2AE1PpQL7XnmmeC/TjuRvtaD+4JIG84nvuw2CjJek+dsfuUDWsj6CpfO9dAwt3JMF/Z2p5qdkPxILmPXizn0nZ+t/sinfDKiVJ4XvxlbBQJraf2TR81GW4NJxm8D35+7DRgtYeXTR91hv461Da15ftzVvV4vkpxMf20v9f9jDbmUw6z/bow2BdENV3LA/o3R7WR5H9Z9hefTfYpRuRvvvDq+ErODuY/L2I7dnnwceS6bINSVVnCmEhhGp/ZHv3c2BNNBW+LtioXwOz7xuynu/hw5EpxOR9/ZD1YXhfRzKtE9vLvwjr42nvHPnQUUa4v5LaFrA9/VdwZCRxio3Uf7JAb2eXH13O9/Y9YKM1fZ+wfdDRMFj1Vux5gu3xd4CVXuSvlcNitN1hwY6e5Xv938J5YSRo3G+r74yG9e1pNN/znwgLMrohpOhhykKz44iVDdv7L4M3ptLZTYP6VOyBv29HvnvFOwCwNpwc1/by/uU6LDyVFvAuQC2s9yIWb2znDzXBKgXpwzsBDuZ+0lupUbvgWVEAbLQjEfGsG5AIG6LJkDZdNac7wi996BreEfgCzrYn7sMb5vTMhUtSyRbeFSiEla5kfnzloE9zYZ0NufyRdQbWwdooqh3XLujRLlgdQ6bw7sBRWKgSNRFietM1sx+KGy7zDgFcGktz3wQ/7v0B7q8gpQdZl8AJfaurCWTb7NVjLihhtRvp5cM6BSlwtz6kpttBz+ld4dRU2twt+AYWVoqjjr+K+mkMrG9D+vOOwWRYc1fc0yPi9bzFsM6KWvKuwSZY7Uhzxq0+aNTCpY6kiXcOzsFlFmTcn2+OjqyGCwKp1p91D16b5y60bk/WD5E26ImpXKmxuYMAG+3J8xGmKr84WGVHE3gXQQXrnajnv6aCboPhnDRyVs86Cbmwiw89UFkye2txizVdvqYpvJuwEPPuPrT62ICvVBtg4ay4lHcUDsIqGZmtGBvvfBZWvhTdjrGuQjWc/UbM2PHdd55v4FIbKvHOgu0zfD87YjoljxnkCxs96Yw5rLuQAEf6E8v1Z+pPdYLLZGRRc4cBFqrFPx8Pr/1tjHluSfvyLoMGNjjQ0uym/CHLYF2D+BfvNGyDS5vEsGnp1ycchjV1YhfebbgCK99KR6z9RlyrgdX+9Olq1nH4CHso6NCJ3qNzXdHL625PajawrkM4fEFFvn+uyEjJgPMcyD7eeegPJ9rRvLG5oWk/wsIjqTPvPhTB72xp+MHzvxcuhNVvpNrmDgSsfyQ+PDNhZkM57KMgjnmsC3ER7v9W9Jjx2frtD2HVCdGddyJMsOa5ZJN1wG+tMzoPJSbp/8pZNyIMLo2lv46/0/10OixsF0N5R6I//LJB+rdzSWFyDqw5I6byrkQxLJnEqWKohWERnH1VWsA7E1tgB3vqem1x+0MUNuqkpbw7caXFmrsu9HlI9OiqOsw7PRf/e67osPStycceVu2VLHmXSgF7udGpFhkeeUGw6pA4hneqYuGVL8QzFa7xVzvAqpPSbN6t6gQnGsTcwY3jh/WFM33ot7xj9Q083YIuCxSd2vwIZ78Sff5hXSs1HOpJ4raOj7laDJfVSXreuZoFqx6Lp2xzGuliuECgzd2rdbCwUkpMC1xzchtc1iR+LOEdLPiUSZoz5mGXVzpYVyUqurMu1jlYaU0MQ9JCMgyw3iS94Z2sB/BOX7J5W/WwTS/gWiv68jLrZn2AEx1pr5AbkYm26J32fyV+xzta7rDwVHwfPXTHrQBYUpBrvKsVDatqxYlWrz22tof1TrSOd7Y6wsZaMTWp35JlfWHVEzGfd7e+hROtSfXR/MEbc+BUS+I6kHe44KuR5I+KZTOvToL11nQJ73LNgUv8aM6QDl+Hr4BfupItvNO1Ae7uQh7Mcn+36m84rRsdPIR1uyrgh6Gkk1/ksoRTsLIN3cM7XldhzQMxSbVvaI0R1tWLqbzr9QwulZF/zqdOr3wPF/jShfNZ58sGfd+lcSRga0G7w26wYBCz7rDuVyDcNoaEuBeuvxMDv/MmNT/wDhh8yptGeEz9ENgFTrQgFrwLNgDu7k53XQjInzEUVrsRxUTWCRsN612Js9G/rVMB/DyJfM67YdNhnQdNrFj066FFsMGd2lWzjtg6eJecrHG6lDNnBzwhmKbfZF0xLcx6xe99fk+bdBzWuNAqC9YZuwzrnWih54jA5dWwskG6GM+6Y0/hlaE0uIT2vPweTlTQsAO8Q4Y+dftkar/p+bNkjxZrqtVUe4N1yYIw7x5M19dtzdDGwyvDaI4X65SJsD6ARJge5AzvAQu3JWfeLfsSNiTS8pK765NGwKeCSdp21jHLh7OV5NMvASHhk81W0FTeNZsHG9vQo5/n+6pWw+M7U2UZ65xtgZVysuynp0cm74c1n5PXvHt21OwXYvC9Z50f6eEyL1rR3EGDE8PJub5+1eqn8ObudN4k1kUzwbdFWlGWezRYjl66Nows4500BawLIF272kV8CIGz3alyG+umJcErQ8iT8umZpkxYMInevKPWF9Y1SrLLWzoqvzfbnip4V20UrHGj4Slzc8YWwMZEIvDO2kxYFUet/l58795SWOlAxvPu2ga4fwCVacfWT9wNa2zJvSjeYTPbnSZXemmzLpgtkFu8y3YbVseS5TsMU+KewEY/ahHHOm3vYaU3qUzqMjlL/hafX06jebdNAQsmqX5AZu3EMFjek9zsyzpubWFDOPXZ2dhwvyPcOZneWsq6bgNgsTsZ7Vp3R50N7wold6NY520c/G0WcTp2/1bEJNgYRcfx7tt8WB5Ce9s3RcjXwk/7kIjmDhwsHJMairZ+cD0EyxOJPe/CnYZPhdPMBatKuxjg1V3JPSXrxNXAKl965slt5YZGWO1FtLwbZ93Y4nfhxPOf84+jPWFBRpJ4Ry4U1nvS/VHe/ndSzHaj7rwr1wnW1EumBdKn8oFwdiRdkcI6c8PhT/lkQbL8ZGU+rOxAJ/Hu3BRY81jMX7pud0MpXBBFkQc58p/+whEhS39litzeYPFupCB7FyjIlKMEmbVSkOmZ+X04uzewe/7wh+wqw4Ft80Fbaxy0tW114Fw1quVxdq0fh4Pt9jgQz1+7O3vth3jtX5gdcYjemf3yzzNW2fIZitg1e1TL/Sx2nzeq5Tlb2ZUHMFxbBTA8Rgsyd37F8gV/Thmez+en8BwFnsPnu9h8K+a1mHu1mh9vNZePbpl/1mp+HXN+X9PqvViaRPU/9/go9Q==";
const depthText = "eNqtWQVAVUm/P3U7uFwalBYBFQGRUq6ErWu3a6/drSt4LexF97N1Xdd1w1rB7m7RFVsE6a7beWLeHOB7+gTZ9+n3mzk1/zkz/8l/zJ69m/sgSGwsgiCfXnEIsqJT3fuC+Lo8sXHsd306vFYokDp0ikqZoIhKKexYR3sQjwBlNwSRxf/6Z7v468O0ispWLzrUTF0Te2vemPgf0sRxN9NeKzyylyiUj+Nieq1xipxT0yt65L3LEfYV1oiFSIfgm/setRsy9XjgL/IXEWPme7cjbz4M13rZdlq6/liMZqC/T/l+998DwI5jo2/uvDCjDHT4+7ZqdYn3uWsugQ5lqhovFGw6OVH5vtT7jwpOeUl0cP7epw8mJMsS0gfuWDQeQzEEQxEYUIAidQAoYK/aB/ysv8EsAANoHXAUw8BmHofH5XAJLkFwcILACAzHMEioKwuwYGhAMxRNUxRFUqSVJC1Wq8ViMZthhi+H5CbCcgyBwQpxeMNx9sLZJ4HVRxwGFigG8wGMbQUDAA0YwMAmAYCgbGTbjqDshbCtQ+q/AXtnfwEwMGxLYEMY2oDMtJXZSGGQwEsmlclktjKZnA22trU3mdwGpkCKFOaRSqTwYWNra+/g4hZ74HI/T29fv4DA1kHBwcEhQa38PBxFZPmba0dSlk4c0DOh2zej5iT/fOZJgZ6wbeYbENQ2OLRtcJvWgS39fLxltxQ/IiWPz/68afHkYT1jwgK9mjvKpRKRkC/g8wU8GPhCoURq7+juExQe33fM7BU7j93OMTuGDV289/qZC5VqtUqj1mr0BqOFojFCKJI7uHp4+we2DQ5rHx7ePiwkuHWAj2czJ7mNkIshtMVs1Ou0GrVGrVZ/1VChdz2J4vSzv25LXr543rx5C5cq1/2w++CxszcfvymotnBkri1DO3brN3L8tDkLlixZMn/md8O6t/cgiu/sn9fZNn8V6iNxlsoFfCWVpSvRVBtNyvOvJBrMRFG9ThdJLTyGy1d6rYq1lMiByl7Fp5I8kxOMZXaM2qFaQG6djXwA+PBSG2D8eHLXEz5AuQz5LACMTQKnkC+HcgXyH6KedQChVIL65iG1sWEPNGjzB7YXrwPIlwK0yAaNpDaGRrLFXTN/wSRDa6FWLm+y+KaZgr395VixvqmZ0HT9zAdpw0qJFezzE2mz4iNpU58G3z+WNh+/fyJt4qC0SfgnaRMwYlekscWi6FGJWyNuhegiel8PDOURhnbfJm8L2uA4J2LuCMewWbuiw8nOjxV26QcUB7Y/URw5sksxSjGpd7Pew75fCv61fOiBl7fLE8HLJLPg6Nke3OdLX569oXxgCJ513w5h2nYvGouC71qPtlz4DkzttBusutZF1aPjy7/GOxsyRvwJRpLj9h+xjx2gqkg/a4j0kxV27DJIqp4ZtPcSyMiv7NNmw3fRQWBlwvsTh+d2tpd1+jG4MCJl1AobhmJ3Y4ad6wBDMAwjCAIKIwFfIBCJREKJSAwhkbCXCN5ZsE+JWCoFJ7QaGGqh0ek0eq1eB3dFvclkspihgKJpAFAUChKCw+FyeDwuj8+D2yvcY4V84Q+LBQL2g89lCTADlHo4CijSZNBp4Aar09YWZDaaTWaT0VwbTDAYDUaDXk6qNTCLRqPTanWw2jroIDNqrc5ophCUyxUIhSzvUgkMNjZSmY1MBuWKrb39V23CC1ZaGaa2AFaq1638D3IdhnpRCGAGBtLrAwOJBP9GKM1K/Vr5iCEI+1Z/Q9hPlgRf6iNanxMGNt3689ga2DiDwQTlPk0ztSTAWIyqiuL83Pyi8hqDmYIjCSiKtFiMJr1Op1Wpq6srK0vLioqc7ICMj1Bm2HcGg9FsISkGoOxYc2DPwxuMOIFirGimqdpIw1eAsM14JPTeHhnaNqClt4eLo62Yi1k0ZVnp19IOH7nw4NWTsykzR3+3ZPfZjFITJrF3dff1a92mXVhUTGzXHv2HjJmsy10nC4BCOiQ8PLJDdHRURHCgpz1Hl3svdceScd3DWwe0jR08Z8tf94vMYje/tmFR0WyesNCgNoH+vj5nhx1eExXSyt/HvZmLk7OLZ0DHYRuexT4e96skyMfxt5P7rv2d3OdK0J3E/u193eztbR2cXD18A9qGdUjoNWjkxJw9Q3l8LofAUYRhKJK0wm5jEIIvsXP28Alo3TYoGBbs4SyX8jkoQ1NwvlIkoGFfYwTUwL5qkgDfi3sTl2y7JZiUOdr6+8RQW7Kmorjg7YPTP61PSly3/2qBNGzglDkzRndtxS+9+cvycV2C3SSY1cSOjYY6XSaXuEhlXK5SctuYp622UkrkElVsUlNMdoVVaCMUcXjSyzUR/gFo2cs7yrCUzAzEJ3DA1idKTw/rw3S5qoR6X4U5hSuLXzrW8K04Pb88V66CL9SaiAnvba0oZVGe/zWgUkAR3DtK03W3conJauxelINohRQHt37YdGH8z6BMAv8I5HMgiaYlTJOw8L6wVhZfpWNg9P8WD5+fbAi1oS7WJ4KPAsQH1sB/PMnmbG3YRPD/xfJVoEH2f+7++mYobjeVq+leZ3yzm6ynaXZavm2YXGu6ILTVbKEAfEU/t3LppJUNq0MaR8MMX6XdKAfxeexWhEPuGm1vYzUz9Wio3dz4RLu50Yh288t/Vbs5MftR5M/J06NTqo5FXNKACHdfY7u9Y9aHrVn2IOT5edeIjj/GtNsRkhn+aN5MxdmYDYrwY7sVmrVdFC54mmJy56sKm0W/Rk2edXDRGRDh9Vzrlt/nJ/Bgk2Hlyj+vDuh6wKCInTzydKja7qzILpNSTVkHzm2Tdhz/Kq3FU2C8du5I2IOUFzT2XDa5Pzf7RuzYkyJMZrgTUQSW9Tk5qmfG+VSbDdeqfiu4DaqOpPQXjB8N7HTjnfldeO+zve/kXo348d0pcG6GJTFxZtEx+9Lka1G7BwVMWhu5KF63EZv7RwY4HjheFO+wWQ/K458u7B4LUpOwksPfN5s36OqcK2AKen3GuW1/7Ng8McKj++zmbpnvsrKyMt+9efPqRcaT9Hu3r1+6cPbs+VsZJViz8N5DRo8c0r9HfMeIkLaB/i19fXx8vH18/Vq2aRMW1alrn+PbSiqq1Bqt3gChN+jUqiooE57eu5B6+HDqtedlpMjB3cvb18fL0725m4uLo4O9XC61EQn4BArn9swAX89mbk7Ojs7Orh5e/m0j4vqMmLpoxarECTGCF4c3LVcmbztw4uLdv19m5xYVl5SXlhQVvs96nZF+/87tu8EBrAWqVqmqq6oqystLy4rLS6uqDZTIs9vClJUDAkWMpqaspLiopKSkrKKiqlpVo1HrdSYTieBC27IpcqmIw0EBTZpNerWqvKwwLzc7r1jN9UoY2redI9CWl8IKK6vVOoOR1SsQjMsXy529AsLies4QFFdWaw0mqAuC2nWKQ9kK1wFjrsh6V2wWyJ1cnByg7S3gEChDQQmoVlWWFuXmZOcUqrANi5EvR59bfAyAWgcFg9TWjRNQ/xSLxAIeYjVBbRHqUSSr99aqWBiKw4BiAKFpi9HigiMUDUGxF0XVXgzAOHyxjVQq5GCApkiYRkICzAADCb+tpJUiMXnqOH7tz2zNALAXzUCVzGw2k4AQiKUiEY8gUBTUAQUoirOsQW1bjBbf87NATlHWlQQjAp+wzzg4h8BQBqowJAVAHbsozAPJEKzCCSjKSiH+vyxfu2XvL4ePn0xLSz3624HdP6Zs3Z36Sjp079Xzh8//fX5ZqP7+0X07t+3a8/OBQ4d+ObB3e0qycunipA1/ZogH399C5NToDVp1dVWNSqc3GTSV+a+ev9V79Js6qnvnAb2DuFV5uQWllSqVqgbOo+qKiqLsJ+d2z45rFpR+1M+mYNWC8QO6xioSeo9ZdvCl/biLgoTYLNXMeRsPp1t3+4INW+2DRbfn+5ec3jx3zNBBQyfMWLpq+biWN8IODXrZkhR5ePn6twqNjPtmxIwVu8+80Eg83dTKC8dSXW/OXj14R+qct4QElD4+uXPFrFF9OncIbeMHV4lvSNdpe7uZ+b0cvFu09PX2bdk6LK7vmLmrNu86qvlVm/503wLjLFn49PVOIbd2rU+aPb5/l6jgVi19vNzscdW7LNujJ8/cPe0xYNDA3t1iwtr4urs6Obi5B0b2GjVr0Xchr4Znb91WOrWi29LkZZP6Rrdyd3awc3Jz92sdGtVRoYgKbiFHKr5KQ/wmffLh8+detLq+5Yc/nlqbh8V2CvfhZh9e+1fbP6btLam5m2prOBhXdmDm4GHfnyb7HSxv3rGbwt+woN2gR5qKd05FhQwhhEaT0nyrpsSoxzAl91l1nqqGYi6USKXOtjZc4ugcx3vALALEH0qbDLRcgBB59srna+5qO4d75a8LWtJBcvVBphe11rO9kOvmW6pVlqerteWBv4ZQhXH6MjRdeZgTl1GsbaZU5wv1GIXRCzSVQh1GobTy8g2BgSBxZE3nCFJkJihw1H7e6xoBgjKrlZ3PERROIy+UTypsijAS5Z8PDFTRJMG0OKhW5lcZuIytItvvzXvGCvqkNamtNY3p28GXKnwASGuQpshNA6ebqrCJAj7WcT/3d5PNYLDG0xsmNSzo63RcCv93iQgMTXXYp760+rQmB6ipQfzwM/v4bF0ftNOP0JQB06CMBkyPO/RP86oJtpevhNQvbDQmr6aRj1Hvm0cAzdqwJM0gtd8N9FxWY7RKtI359iCRoeulGJuANAqGIBvrMBQjuBxjoQrncXAMbawr2TzWWVs+29cMRJOr+ut8h5ISopaxBkuJfcCaEfT/jjjKAqZQxuqCzAYnVQ18h3kNT6og7b95UvX6+agoI30oun/i04i1P1ki/B9i7R9hV8MiRZXtJokmRbg6pba77RUdzpukimnTRajwTgpU9GzhoBg73U0x3NlfcV/uoBjdecnUk6f2c5aABQ6PXE6/7XEDxE6wqB7kxKdIp6onrd/7qrWsZb+B66odwyNjAsHj0C3rZJ3ncEeAH/2YtR0DjmRgFeTQU35zDw3w4Y+Jn2bMyWwuB4dWXo99TYCRnhOvOLf07b7g/Mzpk66Pb/MoE2ArMgfxD/VUHuna+lqLLX8Ay6slka04J/7Vb4IwV7lsdtixzZNqrhQ6ld1deRlZlXZkxvf7cd89R4BtyaVZ2TcP8Vf5u746BXZeHeVwPPopQkTvq6h817dfAnWnxXThtSGLd4DBzU0/p8y6ZieWLTUdsApuaDzvOSZXvun7435ZXEjr6stJYycaHh8D+icTbnp63+sxM9f+fLL1/J6gowsTg1q27gWEpuqgK0EHf6twSt6RnTTKFUS/3uB6aPeR20fdXe6vALOwHf3+cjtwIZy5vzehqwuVNTFhfccVJ4HVO3vMqK3kjWMrc3Pz8vLZWJifn5P58uGt8yd+27NlVeKWrP4XnhxdNWVYr9h2/m52YoFAbOPg3KyZu5dPYKiiz8jJ06a33vw8t6xKpdVBDZojksqkAtSiLsl9cWPPMM+I1UX+sQlxiujI8NDggBaezV0cHOBpF9TzUVJfU1lW5T2hYyt3B5kY+q64ArEtq0d36jV84f7i2B+GdDAvP4b1TtqfevX+s8z80mqN3mjUaSvzXl77I2XpzMU7rw/p9eeVZznFlVUancFsYXVOI4WIHP2CAznWrj724Z2CPWRQ+TbBAJV5raa6qrTg9d20PZs2H8wQyEKMKo0OegjVNeXFhQWFRQUFWX9f/f2HVfssb2+OXVCa+nvandcFZRXQtigoKqlg9X2zzkjaKr6/qsGKrs/rG+om5aAICvV/oZDHRRijtvT909vZ8wc/KDl8+Nztp2/yS9VGEqAAUCSFcBz8u0zf9PP2iZLfQ2/eeV1hQXgSmaML7EgPTw93qI/xKk+P5ZsPpMlfLm4nNtaUlkKG8gqLSqtUBhONCR19QzvG+FQeNfORL8eYfWYriQAcquAYDoHBB4bQhsp35w+r+w8OcRZyGMDq+AzNgqJYg4HDFYrlcoG+qlAtEEmgZV97ZAr/h1q8RO5kLzY++em3akc39+YuUgGO/Vt2YThXYufm4ekm1mU9+vvvsXYGtd5E1frIEQzFYQSkoSb/ceqVrgcneAJ1VZUGOnvJWvuDJM1Go5Hme0R90yeE+v11go/cqlbpDBbIUb3TFxpnOkrebfOQoxtuqDkCPpdAkdq6EQbFCIEEer+lQsxUnjtllgE6xAVcHKlzTLM3jOAJCWNxgbSF1Ko1mFlHCl7nS0EZBrrkDRTfwaNVZIu320ZoUYGQD1uFAAYC3lAcTlQ+0NRQYh7KVogyaJ2vi0Fgt1kphJA6N+OXvqioQRiJkE8ggKYh15DG+ls50EmPWlRVKgsmthHzUfYfSGMB+eKJpBKmqqCKsdvmbJhU1G3ThXc6vpt/cJCfPVX4+PqFE/+aNNV79s2tS5PHrT9+5c7TPJPY3c/fx1lgyLuxc4g5kfM6rJduZsHbeJcSPcYjMIYiAVcs41mr8nMzM07MaH9BjtyVuyYcyqoozX1fQvJlIg4GcA6fj5Rd2bb1r9QdVb10m57sGrIpWIphhFDm4Ojg7Bs96XjMtLd/j3R/OfH7XrPsrNKNr5d29Xe1gza7hI9xRIGLw2YtXT1iCa9cEvQt3Sm6jWczZzefNjHfjJmbcrrUc+whVaTC7/L9g0Oli6blZPyxtLvNmz/Xzh7bT9HWz93TNygmvsWzxTMQ8YDuF1Ylq3Z3aS6GHc7QKEdi59qy7+WjyaVZ5qDqOOXVO7289ZODmznI+HCYEJwrclH8oLnk+vr74asdBW5zdY6e4tKL64eFyoxFb188z1bJOm8uatfj7ZVO4d8ddLBGcdO+ddO+Sb/34HmByTF66p7HFkdXND2xZdah1V9l3VRvURxxWFzdfn9aTs0fLczbHh96ZX5X7thnY8YvXvN73zRXv2xTsVEhThzitlnZKVcf8GrLSyx9we2cDRXPersLMiu5NkK4qJSl6cYKkw5BlKZ31UVwejGXS4VyZxspF785qfKVnOKhyGXlG7PBCF9avFNevp1vcbLJdU3uEtOMV6opa4+mdM110Pl4neEqT/iWibIzlen+114KEUfP1X3SerdTCQsDtirvqGUc3OR9dsHDN3yEhyllL2yNuB6ncAajE0VvnfS4HoMfKL3SdYRFZsUZnCYYoMw6Ji8GCMeKURgoVj5MHi6q0AmtHBK3c/rT2FmgqRbggERLbJT7bsdbSnABY8Xpi80jMt3ExYicokBm60JVc45tMS5AKQwrUe59NCqvTMy3WFH3iz3T08ZJ9BgGLMgbZeZx+bMwgR61saDkgW5XocTNcJKZLeiNpSTeNtXputELV3MOB83duHDXrTncN7id6UDggO3Kk69Hc16htpYuF8CXm1lzUxrk/f+fytrUfP6sGWF3jqbAtX6W3X+0tBCz4PNNhnU32R0oYfm8sfDJv0gDiwCjAUSjBbBqaFOeXwBQ5quPIT5jm/2Dcck6qZoYyQ9f9YLsk4Z96JVGzasmph77cxMZPi6ygenJ0j4iw/CBtY+Nzs91BvLRW4Nu+rhCUPv+aYYGxy0Ne6wBtZ44/19QvjWar3ZpNFoiwzCs6YZhSavqGW/YvaxH8P/W+AmXuEhDY2gj5h1fhKuKK2ihkIM3Qoaix2JFcKGRaUCDwDCUtkBfMUDr0Jh5iAKuhf4o5X//xzk8G8E5lZ2AS2ANyQigES7HQo76ia2pwSCyfcXqCuxbA5MerU/7Ossyepm/hy1OWiwkzUCgBJf1/dKU1YILgcnK4bAnOozVZKYQnMBxDvTJIfqSnFLUJ9Jw5GOrUND/VuScwmOnRo/XbM7uX1yxMnp87qG+csva9YtH8Ow3tl+zb+XaYFkRmBpz/PUpLKeNxfav+IyfZvaelPvDEkk7TcmjOzHiwNdVkomCHrvzKguWmcn5D3emuLqktN7u1O34PtkvJZw5FzqcdrxMzPLYc2ZhoGB7B/wc56fZ3YL6FdkRs7N7jsmYPLvgVuSbVVui3s9qHtWneTNP47cPzva9byuK7Hf3Cee28OE8Hjj/6GrSaNeczT37nnr21Lr+W7EVDF6beiCRP26ZPGTy8+k3/nz3fVKwKv6bqKjcQ2eK+CuWn7PZP9I1KzvxwZRhovudpK6KyIcHr54dMCyrIHbG1LkzuvR1X57dD8lK2528oPr8qPcG320jZ77VfbN7dk9dn4LMc4oKdHzSmOE/RU8q23Dq1OrBtzoaBv0Z16Org0ARw5/9zepNgip5j8ppos5J1MiNcZPXbAh8VWfUkwwOLDSHiwOom7OjTZCsZk4ADDGSXNysteIcOCQYAqwcwFAWmsvjiTkWM8NBLFDlZx0hOMU6Ukid3krzHGwJhqJZDZykGAoHgEH4EkKn0mhIocxGyK31+JMYDeumzKTIUWDR6zUqC8EXioV8HofGa1cKpTXYOPFJqLRbjXoLwHACowAExsGNVZS9HUGZrVDzpWAdDFo7vxko/9U1iFzOJdnjS4Sh6s+F4YuAMOppgsdhGwFRd4MMmzhiBCrkLAWBzahfMQzDwbSkrcSi0gMuj4tBfsC/lwWOUyaGL8DYOlgh9j+brRt4";
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
