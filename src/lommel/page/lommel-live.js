// Made by `make page` with ziglang==0.17.0; SHA-256 of the sources: 694e20cbe72635c720fbf038d33b5017f45463c82ff64a437d3e9fba52fc3751
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
const wasmText = "eNq0VnVgG0e6H1rtSiPt6mL14pzvcqutr69McSlky1WoFCelY8eXOI0dth2WLQfqc3vF5CBJSZbLfWV8kIbKzMzMzK3j95vZ9VrJtX++WWn3mw9+89HMLmlonUsJIfS/rDV0GiHTRB6DTIvgrgkjeFL9p/lpBH+Wz9PcNK4EuHcoNs+BpyRgsZwW53I5XysQ4E4VBzfMlRBczVDqtEOjdHSAtvLBCPzR9jmCtTvAwEo+PB7a0Zzvh9KIYoJpaQxQMn0l8ECBzGl9ba/MAG9oLgg9zyn39No5CH0gLbW0tbYXgQHR+OFSItA0ShlaPVwIhiQ0gSOhvJ34YuV76TKw0/pgaA4Ibab4POD5ixlBMoKsBIFB3X8GksDSd5Rpt/QyQeZ1BgMPQQeLhLlWaoEsH7gRiHJhrgP9MNehdxh6tUErkLoxdNtomcY11ErhE3wQGFohDEiDRH2QXJi2MJAgl5Ym2hVqLB8O8AMzkNGAVOpmyI34vKDWfqyQB2g0F5qpSQA3EKlGCJ66cYJRqqhbK1wLVGDbgaFlIQqowBIbRPdd2EAhuJ9+nb4gjTl/gbATAKx7BQ/MseE6/DV0VGFjGz4n6Kl2RK0fTN8j4aK0XTHbwWQT+c+XNLQ21bfOa1jQOmt+W/2ClsbFTY1LDrKnz5k/fXZ9W9PcxvpTGttINDJn/ty5jXNMaLW0Nc4jsYAhZjY0zSGSX5RYnyAknrAdJ/mz5JCkGoZwHDsaIYYjpCOtZFkqNWS3n0NAiDBsZ6htlwtHDjMMgWGXU8o5Y5gFPzAdjCGAsWi55d8c+Ys4FkhW/HJIkkCFGEQNPMIhy4lhiWBgZcv6laRSgh7+a9tNe+BZu5uVv9lD/MeeYvhewtl7n30koPZ15X5yfynLjAP2O9CCu3yPPcrKhphlBw0rc6R0DhZsxIFDHFElRpQfYmGASREaxZrCIUZECmnYhpAClBDlBnHUXyIYxZTB3d7pEdx3mfyYwU/cMQ51hgqsc5g4HNmvPGLoUL328JEQjaJCjBz0xQElkBAmJCGjLQo/peLTg5ATaVFBEY0DFgSGUzaGInDjAIl/0gchThWlCB0sa6QsH+uVG0a1qBY1IzOyGngHldVyyzrSMbKGYVmUSpuWw384aks1hFMOGPwkcdQA6p7couMsq4ybB1smHT8hlaIW59yYOOmoVJaOOfqYY0cOO47TyXXD5BRnKrV/5Vhlxw+3K63J6AaiE0DL/R5KmSmHwp7KgVVHV4pyeYKOiJyodRyZGq0I2xJjpaO8oMgR5zDZX5vEHbPsJE65aVUeLY8ePrysbLh1omSMQeNkPxT7t6a0qujvHFvYRzoOd3//B+uPtmPpMfFPE/+gfoY18c/1KarWkkiYQ8sd0Eg/lVWVUg5RBVHtKaZNrrLtBusvk8tMWUklR20Gm8exOHz5/R+ZaWkP6rQH/Ggx3Zlh25bET1iNjiXBZJZVblObUmprAMsQLJWa+cf6yRY95fcRNOzwsiGVY8ZwHW25RjKslKqm7xzKI8YaB6QMYhmlXGEcsOt0DLqAz0rxP9Y30d+7fnaag1iFleKz5RyrxqHCOVZKFQr42idmcTaUMjoCjssplePK5goxr2zkyGHD5J4jTLnnqJRpmchiKiVl1s6aWSod80TsL9M2d2qnOjSU7l/VwJaoo7YKWhLd5giE2+VBQtSlKjBQAJDZGRL+kHJpOHSQwBg+fKg3dKiFUW1JnUNrfmrBgRMlVkplsRiW1ivsKapSqdTCsS3WSAuB7n80bZXO4dYUIeuwADDhgQQqCN4GeEKRBtVmSIQCgDeLDBGgAVfzpIoNTGhBM1BbrHgOzk60allZmTSVyyUtrsAFx1B8wI+QYsQI33gJLV/iZ8v08elgrAIXsRDfWLp0mbXcd4SqRC2YmMpWLRxrYVC10GEWOj7MlY9cI6pW7JE7zERQv6uqaa8SFHJMoBEcWDvdNThRS1K7TvIRylFBnaEcpcEyHUiJ5eQ7qaU7SAJKP1BGtZyNxPhVhk3giPZiJR0hysMyDjwdYth18ROSeqyiqyluyXZh0gX0blyGoGQVixxq5mmms7PTknmS6XxupX4SdfvkCX+y5kn/ed02X+mOpzA3z2a7ReY2zp3fsowRWd80r6mtqWFO0/JGIkTL/PlzyQYabW1sq5/TdMqsNnK+P1ncMK+xlVxM+YLWmeQSKqcvaqtvbZw+f96MVnINlUplelPL9DlQuonGfbK+saVlfgvZRu358+phEGpsp4l5jQ0t9TBva2lobSMP0KiStzQ2TJ9FHqUxpR/oPk6jLQ0zmha11s+fSZ6hdmCj3vNN0xvJs9QKUd6g4i9zFrWQD2hM+9Mwt7GlgVwWN2Y0LmibRa6Ka/bMpjltjS3k5ngkoG6LR79llGSovIuOGjt6TM2EcbXV47NHTjwKB/dxk+umTD3+hEVX0qvoaeIh4xHjKfGyeD5yd+RC83PzO/MV6zXreetWeZt8XD4hz6br6D/ov+gadirrYt3sNHYGPYedxy5gF7Ii62UXs8vZlewqdi27nt3AbmG3stvY/7Lb2Wa2nd3B7mT3svvZA+xB9hB7mD3OnmBPsmfZ8+wF9gp7lb3G3mJvs3fYB+xD9hH7jH3OvmDnifPFBeKPF4mvRb/oNFYaq41zjbXGOuMfRq9xsXGJcZnxn8bVxjXGtcYm4w7jTuMu4x7jLeNt4x3jPePiyCWRSyOXR96JvBt5L/JB5AbzRvMm8xZzq7nN3G7eaT5tPmM+az5vvmW+bb5jvmeusU61uqy/Wu9Z71sfWB9Zl0QvjV4WvSJ6Y+ym2M2xW2N3xe6O3RO7L/Zc7PnYC7EXY1/Evox9Ffsmtl5ukBvl+fL0+BnxM+PnxNfG18X/GV8f3xDvjV8Sj732grc+UU2SrcklyWXJ5ckVyVyyPdmR7KTJlbrv0f1raPJUmuyiyb/SZDdNnkaT39PkDzTZR5PFePK0hNydsJoM2ZNteWplNxmXIERmUNBD/XlyNTYJkddQKLEaF3vGmpggLskSPV7JF9NE8/udyeDTzMqlzWkaZ3JnFQj6hurbpIrMqgVKhUqtfVQJ2jQ+gHbbgmM12r1moFqqogSfzNK3oysyax2oQEH5YDZfXVvVtbkon7ZM2sHytIPrP+8AKtnk8dqq7ss8AWcXekZpGEcWA6EvymSaM51J16hIG1L5s8mLaEtTiy3lWqllJLSMBpbRirSlLNkmL6YtpS+GJSu1jP2YZVTqXBuZHY7KjgX5xIQfYtFlBUe60cwDS5rTcShFtRCoA1I3nrnfHF8BJQG4hemEa+qn6Ur9FG6slnbV7ujXw1ld2+mP5Jp0zI1AhGjc7lrIiJbRNZ7tcsXnyggWntMBxYCOQLaLOu/IeUkwXdsF6YKErRtxHfChfsLVubStA4y7hms1Z9bPb/aM2Z6VoQgEbCtTfTQiirnW1V1p7sYyW5CD2Vd3p2NxpkI/A6EbWq+mWWW0lqQ5JJrTT44Fg6YjYNqBQD1cO9NJFYrndMGV6NVesnuN8qmrlky9ek06AmeT3WkbreY7NgEexNOGG0tz2MfA1/iZyQo+5MG5wDeu/IWnzfDZUVKXu46PzWHqX67pJlq9qCuADn07B6VImBSuAEG3px2tbLuxdlfL2pH7/MmwcdLwPS2UIuo6Pi1qwWtHtHlFYLkKZc6ly+vQMEDny7zYZZl8s4eIbUReu5UAVYduB6Fz11B+pw2g6nUjdVgpsszjkCcobGi3uq2GaiafjsZZaSfCvwAftUKqsT6WFRX/lWaqhd3obOym7UvQx2oKaoKiBrbA9nAvwMRDFzdgaV6LxqpLMAWGZdWtew16yx9bCDosWMNjquFJj8cCnE/MIlBI0YWgR+8GI3kqjAg81Tqf9Pf/uqp4y/8M6jtwGlenpdY1V9dV4Nm5dDUWCQOB7QCOPILSfAYNpfb2OBUKx8GyJ0NCxiNXJCOa0whDZQRiFicSydIFkV8zyvIqwZm81lPOu2QSws5Ql7Z5VGX16AqPwvgUjyQIliG6JhnXJbOh1t/PF2baYZhJTFJtCD7NrO4UzZnkYmUEnatrobS667I0hYOBBWvz2J7suqdxmnsEPsM9PWmGdbLNJc2ZXDMiOBRBIE8ZeFEDRS3K5NVJUkvdENiPXGEi6h+eUpgUmFDVk2bkjJYAUkdCdI8WaZ9gpWdBOH6UOitkwEeVV3jBgN/PD9VMzHQuMso1lsEKbFIC+YOTaSJdlTreHASwy4zINipQMt2PukxEEfsR4sFV9VC7MUPTBirJM/10IermGrgByGjGeUnw0LuEYpO43LcU2hJgUunCszyqCPakCt0v8u2IQfM0Rztonud278RARmd7tFKTep/BP7R70Inf5NMMAQ705eY0emNg0g81ZRFewbvMVa8ODHOhJzLfPnLmKqHOTZHZ9sIzO/ixCQryhju39fPJiEUfIFxjvrKjdv+3NhfSLLt49LJDPj7ivTFpxIZTRb3rYIM91m+q1y+BS6aEKTk+EYHpx0d8B9OumhkIeMA35XZE+lZvcBQFAn8AlABUSFjuWLVP44Tdvq4uDuz3apdcWviBeeJWb9CNItKLSocuFuGjPm0GONUlTm8Cfh74VDuNPFQPuMx1C9xyOIujweO6gj4Ow2X0eKQH97QhVQFCf4pepIgdGV7Z/bZH593ad/rtxewRU9/quu/hR8YWitlbn7/ywmEPpTaDPPXEHcMK9PfVIL9I/gyjR3GDrFQXPDOgLRyorlns8SI9AadclT5S7OktpiPKd+W25uDM6tFdoGbwsYi/y8AKyy7QgzYnjKqsQDTo/gCFuqoMhJE9snl6gmpddTAWQgeD1IrwmyltaPzD0ULguWK2z41obhm4oakb6dGAOFyLwWLIWKTQE2oEklInNbvUBXwWugR6qnWs8RVh4xf8DLCS2oTIZAtgpTq2mvU+ArqMAzN5zpmY/MDke8KkebXnWE7vvhU/tvNK9hCrVczCw4UPq3+HMmDqj28259Wrj4TN3Jsm6GQo9Pvj635yUoL7zVdqdYJfzJ6dDLmvhe3q8QxtU3v2XlNtVe7vtYUJvnPHcpgM7iMRrPDIM9e+uzn/+wQp2WK6WUoSbCAmfS68dvtvmrFaarH+II+UoIUev7Lu8t7tBHiqDqXFw3SwHD1B0C+vu3z1FnJShWv0ppEJrnbcwsyFWzf2czSQ2xWoOavXbC6pJRr5VrXVjHALq6oLzMNNr9YLQ6op9HrGzhuz6JmugUbxhCuKntGX8ixX9HnUtYBy0V1LH4lu3F5d7EsppWx26tiXh3y6DfvhJX7/P2eMvxv7E7p98WuXnvWrOxc+UP27dd7fKyc9Vt33Ce37DHzx3b82bNjwbPW6E9V4M+B7Vh9cx40WCnDQ7CkglJ0aj8gXOePospKDUPXUBo+HHPUxQzd4opRRctyrMP+iVFyqHsLl6j/DM/AK0bRR4Q3WWoHBBOUApWqYfWBUfuaFhbfqcRyTcHrXL4seVd1UMsc6xWSXcvsiIIdX0eMbNRvyjXCGK0+Q5h6fWVBTVwQqPcqi0NsTwvY6qqtD/9zpO3vRu4sXvf8/XhQdqWFKwakbXv8ODuVScExLwGEBcP8F/hhlrKS81WmqD42dC0I2+FXfVPou5pmtL6zv5+EG/wyvReqy5OlqEZ0GjVJ6JvYOzhEQxxt8/RqhrbJ/e/EXu810/7mlkPyXOuQCxS354iCVpmhNlQhfxSs5qklvYXAnyTMZpx0Mh6N/+tFSr5l/Fk3yDzC4EZySmk/Azqz7tO8JlualR07dkcVdYfBtoDTvhyb0YM7nucEJQXHsBCOPY0JvaFfAR2xrvcWL2MFPf/jGE+Q6tYOfnfL27fdn38FrVW/tbU9NOmrap99C4FZ+svaVPXdAkF37VoPzFt9RXSgAa5PGz63WDyu32VOYqvGMHoVQUIkGB5TazETeI4R6W7Cf/kLDaVoanC5nQegcZcv3y57wffrb6gFiM07A/IkVeldXBF/uwOAw/niH6gY9AbbqBxJnwRl6dILtevhDhMbSLgQ2D/QrG02e1Skml7yavtlcGKSrSz5A8OLJsLSIc6nN1gOhxOyT0CxUplBmMpS7RDE5mFTqjvgRS1KjLUlaaJWiTrgXcYMre8Cc5n2zNxU3F7Mb+16aut9LV6uSzd3Ydu1n192oyIU/333HXQv/V5F3vL8e5/C9INPquB/E+Nlz3usjrz4Hob2fWFx59IorqqE9ZcwjhZmJ6xU5zz3mzgfH3arI/tVkbeWkbYpM6OP8SZDpyGARjtWfx7zN03XoJs37cNXtJj5eitApDPB6cM7q76WNuqZ+Nd1Qteff3gUfCuF/6dMVP7m1VAUH9lNnrtmll7WU9lFYuwWHY/MFNPG/JvRZG9h2KqDSHb6h5CsQPodXNvp1X+LVMQzA3TfQRa98PEklZtTZs27ec9XFKuUnZrvtE7feq7jt89/nQ556QnP1uBPcEGjV2v2vv/O2GwH0O3pmxZzIW0rvntN/d/6be5MakEfvd/r/UXMV0JEkR7YSirq6pR54vrmTz5dVZuZlKsP46ZiZzS3DMupmZj3aNTOzRntnHjMzHjMzM5pZzxc/IjO7St2t1Zh3Z1tdlRkZGfEjEupnSTe/7Vnm/Zu99DOO5mLLVr/xX9/9JYAffXUWS92W3xDmP33wnrd52dPfvUmYY5ZW9MBBj51e+j9IWkb2hcd5SG+eCC3OIWGk3AlnqfgG1oZru0nKT2xGBZsdvRJLIHnBJI7G4CpvMrYPSgpD0TwQsdewERTZXgRYA0BhexEwDmiF8gB4gC7Ke/QDjlTeZLQX2XL0U92wtclPtE/JUqQbNrhq/dQSLiaWB6ckdhMpviDleknHkiMVo9idQbo5+NLGOAMthKQFirhehGTydUTSMpKWkZxmHdKOV7zoWG3I62uPHfsnzJndZEOKwLnoGF0vcsx8gxzD5BU9gVfTqaI/U1Cc0jiw4BU1TZ3BGvnNHjwa3zJ3CLV2FpFyzHeNJ60dP4488qwUE1fp9fexG6ebgqdsEFzt3U7THwYJ1SbV+5XGDgCthcZS9LlycntDGl5OxNmaHEjcJ33cy50G9WYnvHpobO+Eg9OtAfemA0UG+svpwL21H0VP1NIzYtrha7nyjU2fwItKiNkSPTMcXlTCd1X1xuAB/pG/Tp08ItsWbMjxyNlFBVRVUtsOCHwQ40wfJ7AmBoBYZu1MS7NK4u8NDmiSsxKCF5QYAUa2g7CsKhIsVuVZhnhQA+CS01mwmIDgfAAL2epHmAoF1g9rv4M0t9bRh8jPhPx0auISby/bYBh5iopTsJJ8JDPJt52xfKlS5qgwiZ9kJtGMiJbEVW1af3WaVFWBcvwsC9rWHUZHngRvN3Srxs9mC9IRubfsQXOpb4+BQoGgYuZkToMeLrUUqgnp21BkLUJlKWMQLRh4ADMIHgVkt4nIVlVyy2vpjkzBm0u3fAzXfO467ETaZPwEqkuSapUS3OcmUcTyKAJ0x8+EOGGvxs+XK/CWyT7Wzz+EgV6uxi84xpru39ekARgm+agpEU3QCWqWG89oHIB0eRbu5PLFfPnInm5m0xRFVklkJ5QlLQmvXdQo1KB370dC/T9H8jN6opiB3emJip50bRgmrGJzepPwnH5DJY/XL8BEsLIF/OMCeOH4Boj3ysa+7GllhiEln3Id5386HtTR0xkdQNkpiZSiqsnaay+c0NHmKlPaOZi1I981EoIIp2fFfY6uB/bo0T/c2cHVpUsjg3T+D5DXBR1+sPIUDWPlhT+Kw8D7XOvvftgfCWJLEGU++qWENAR/2PmtXu0PO027oEtovff6+2bJEleXqMRin7jyBa4kbF/OeakO43TSaVTp6IErabcAp2MruvBNmhw6x1u4JiE6Z6QcyFlR7jIAWmcEYjABx4hy5sr47QqTad+brwIpdqlb+6OHEYTxL0undPUrcuWyzpnv3ejZtdttaP736+tigUbJBbQ0Dlzqtb/+T/7ySResN5Hxu/L4L/n4FOtxJS2p5Z2RLMlFbXppY+9oXvFkGs5NtTV9hEJ2tskdzUefhJrhVjPaapYcJdlj39Eso+LvUbHlqPHb0XizGVNkKNDvc+WJrWbfZkNF5WZTuSUKT0Vc7D43ckNsT4a0c2cV/x5VvJ9VkIIxtd6k/3grQ72WW9S6FFM2IbSFq+ex+JYUPy0WP46LQ/mxWP5Z9AOerBmRWe8JqJVkigwOGTe2fduVk/Z82ZTa9tfBgEZAprmUy9H144vVOsOki5hNszGPocxDeJ1ygxOOPFGEQEUjH96Rm1s4Ck8I/JPB0NfjioHj+QFF7+dK8ejtcj0kfBAe5tF81d9HHX9+UrBRUvH7seLXfUVJPr+8tbTuk88ZgflaKneED5OhtzebfJ+6/OT6fe58/Xqt4xEADhlf4X3S78NySd1sYryV1Y9oTEVtImdoEVPdMmPT6lo53b6pIEghcx9F106vncSh/dF1R8md/CDE+IwqoUNOpoyq31TKrkc+uBApp+JAuoA4FAMzTNjfJ0e3eOaIMh89n4aDSDWWd2XPj7EUSrBL+rzPzQl5h1N74EqTbjaZI00SSFAByFg+t+mSb/QcV8X7cbJV/Wlq8EwEf+K/eU9Gn8c5GWEm7GvKviQ/0UlFQr9/1NV9kwWhaT+E8zU5f3wDzteE28HTJdR2TthMq7qnbHbnYRbO06cHWqBadj0s029rTOewzILQ7B6WGT7xdxZHXPRT9OlwMoflXO889ErxOBP/fcWHXlnn0AvP5U3aO/RK+dALmGsgxSXOnDgByF1KJm/RhwpqE589u+ddZu55F/Kxe9zFO8YFp0fckdl5FMZBjedgQlmcKSlidju9An2p+6dXpIs0YeixrlS82HF+lp5gzZuBVjLMacR+kNnQzd/V7ajXvZDA1UuZsD7STZrAWT+/0Tgvxhh46a8/8UN0jIOBOX4lJhuegEw81zofVSaM2Vec98NMT4J1xw/yt0PxnACeXNkr3pRiRS3Gr0IX3pObhd3t0zewux2/FTezxa+V4nvQZnKGlXUKW+nQ4P8eiwZOhV3yrcPJfotD/ATvGhT4kbRHLhq/BE2Y9dUql02vIiFcsExjSKqxeJRJ20FQs4I662ggX471HBc0q680+ZpTeN8td2rSFO0V3zcyXFeX7ZWucNBAUjjtazK6z+g9tSsvaosJCX0CMxFtiLPxCxl/w3byqMhhNX4gJbCLnrhyxeVfHJBzVF2iJnU2+oJnkAKs5Gna0lfWqosJHSQVVLICMqM2bKa8kKZEez7BFvyLFfTuAM0VpE0SsyD7z6K+qUEx4Uc+eZZ4jYToN5SyRwN8muAj8DrQNUbA0wE8DfAsTfFriBkfVWiAKOcyZs2lE+y02gS2jd+ITtCdf9Wm45Mln0KpQSvlNINEzfWk1rM+6eiTnvqko0/Vs7RK4YpGPBXimVAg1dS1ptjhXInYDrD5iLEtY2xLH1tWUDSVmM3+D1b4vT0Lu/iHckNnQ4gzlGRSbCegm7kGXtI9pZ0MV5fjcVVHuWwCJRNAIUBQcYYCPWmseEnNBpCvXDHNHyX5YyV/SsmfaYA/gAfqOD5mA2znjY6UAr/mfGAtztfWnJlgebnxwNLRpw2lpLcTWLP3wNpuYG8GIZ6jJOPGb2Hfn6Nj6lpW2FhywlnvgHVK9qnseRY9p6qU/RHvUjGS8pkatJzGPe9M37sMoGGgQxwBTDEsM7lfa3KOPRRmfsw7LaBx8FdX+DL7vhUCImqHCoiJPPMuZhYlE1EyAaXUme6QPrnnWffkjln3HQWTOQTA+zbO9Vuh9qm/m4TLf4pXJXNmdHG3i6lfxgQLste7+V7RSwZO7qqSs1lCQ0IxU0LD8J+TR9WGVf1bLrqM6NqpBKIXRkWKFJnZrhqg2+kMyekMtXzEGncY6zTIKTHkab8bTXjpk7PdbGiMiF/YKNjd6K45fMqt53RlqKt0r6aSelLQCDzcyVRI7+IPyLaMOpH3tj/wZ3eFH6p9/8a58I0LX/OPNjo3me8c5OEcIJnrXd+6npDZBQIsfPleIYAR6ASd9d3fA0Z2F4wysqKQmB/74J/dNQLzzP/6a7N72H0LQANE50LTtXoWlt2xS3fBLieryz1jBzO5F9jZB293dO1e0M12QRcT4mBSvUYp05ludDh6J99SzDBvwy3frMmiHH4JYeBnElIYZhJ5MQFlV2IbV0xkCW78FknJEmcJHvC2cSfkuwqLjJI50el4ujtdDX/NqDRY64K1EKXJ8RA4qNPNmBu2A6KcXo/Kb8NbrAedvnMybrBKOsNLgBUxdTFeOgVIZxr2jKRJUypSTCz7MN6wIdPa+ImYc0lVIq/KG2dxpm340ZI1mE6PcUnDpiuDILolkWwtGsh8d9iPaCwUB9kKZsJRwBCP++sFSwiu+vZmfLpOovsCBvoZv84j0LoIJay5FH5bpvjmodOYrq22aytLcpzFVTHZRpNRgwIx2aXyQGzFbN8YLLJNnKeP3wm9leb/98eCVnZIvaKhL/qSIso8vlf4/mStMSFrw3ZC0Q95pRhrLnNYSuLYpO2v/xG/JZ22f8wX5NsHuEaykUDUZzizPUx2/EeHwJW+HXmD78J/HwJgZyVn4+s0fS9nJMuJVThNj+mOQjHkAWgnAIgsgm1k4833XRtpdQBJJTS+1AMkBSgmGCIYXYf5VT9y00fQ2epJqU77AFhfx1sd+HjlBN/ZpM6FxW7XuaAAONqDk/A+iBMZfDAeXsj/NaKFU3k15gjep7dzkCjJ84POOnzfylkk3DnOBlr8mDqdkCAQAAEBDwgskCiQboBHy5FMDha6TRgY8njfYyIibI4lTMBS8ziYWgobm9TluF5gHIxy3sjdjdNiXCrGFTCu6BtXzBoHw8D8W5ys3fMUjOBU2RUZ6bzX9aF9x2PXiBkCChNut6QTkDKWRAStWwEtuXTTyzt1MfSYYubiuvtLHvDUFdrFInx5vQ9gfwmHOqXvTjam1XUq6Qy7gpMLJYoa4jAL6Y8JScHDMVL6NIKGx8EZNG/IHog0cwE1xffYab6Ca3SlvA7sBYDhafSlRSfWHdJXVa+EGV9rQ/SNGkI1/LyJ3jQmgJnRXlUfxa+hsI2IZvwnJDTsbzKX0heGXybzBW7MMGWS7nBfavx4aEV8tJ/38C1h9vbeHFaxooZb9xrKqiWNx6jVjAJH3HDkBSoHp6HNASfklYU0JerZ6l5dp3WrkNUz4wbN7pzcGyrRjDTdCQX3In53qAGopZJKwnNQ4nI7BvV2HEJuFyOR+ABUOwGXnvvDpvqMUioiPgfvJOKddPG2fbztl4t3v+Ep4S1YMOw9SEjDYlAimNVjdHQ8806n3h2XicvMiLvscCzumioK743Zl52NfdyLdcEFHlpxMNnOCLOwjr27W6ukJ80nzXFcHmoSsds3tExTzjZzSryVsb449OmctKv+Un1VMPhmRED2Ud86fQJ69x/zlqYgKdTgIL4NZOVyEPricWxlq+/DLBTKPtpriGxX7Tr/gpzQb0dRwY8FyXeyt5dO/CsHLhn/Ol/82FdXX9wC5qKgb+/Gn3w17YW+r7a9XzM8bmp6LxW9PB2LQh6M/OqSU4HI9OQgdTOKz43YNhVxT40vPPMPmV/j5k14ggyPj8KzUeb/wmynkfCe04OWHnSvB40ehOHGgO71EN3a+Ea4tfG1c+vZhg5xU3qxFbY49Qv8O5IXybO+HPQp/0p+Y/xrrXjFzV4MkfHT/EOmaW9xeauJyJUX+M9/3MsvlsnX9d7mz6kpN6wLrsyWrDGJMlV8NXY5Xr5f+NzQ1Dh02XkR9mWoh4T8FgXm1DxcKpe15lJ61+MDNPOJXKjEnI8mx9zE5fRafzVHZXr/7m98FWjK8mbVvwB0w/PFcz7gCZ7YRGlbueIFy1N3XOHfZT1Br1ovV93b6Ceh7M192gfJXNLpCpno7yYvWfKipwCbX+7G+zbicidbDx6faNUm1W2T+Gu3+MJeda3Vlz0UPMB5l7Rq/LeyLd1eVoNIBcVnSmJHMPLrlMd4nYHd4cdK0925ep1NsZRlGfltbMXNmpIfO9nOZvB9o1QOtxJXugF9DdMgJnNM4UoWdAXOdCCX4BKfVbq11CwqXCgntZZ0kjrUWg+U4xIoSmRrx0pKwbNALaQLx4L4sOjuBgYtptc/3YWOUWGCKulrkRaYHLUsNMgOTd92OxW1i20f3hi4wx64xSJwB0HZQLocii2FiKyyvbuBhcYmWG8QoKbqeV1FvQGuAeTwoXoDKVYFQXxWoYCK8SFlJZWVAbbC8a3A5v8+xbdgvcJwkD8BUNLVxZh+nPFnNcXI4MkXkxIlf1lzM/hDNjI+OHlK6xJDAEZOSA0ntSZp6JY/0DBwpYAPRprb0XlWxVRQXVZ+AFQuxX3qqpqcCfaMLDgyMkRHAxIxIIkGVHWJSj+aMCYL6dDUJdDs9Cg9UYuk04VBF+E1EBRoPznYdnky/jthJnU4gm7XLyKrXUpa6wFGPJVeq1YBREiaTpjLbl5BJF00aFHCCnYmwWozEFVci3K+zcXHQhTl0nDgKtEHDXwr/eYiwKjZKBdHm2A0nLYhyeFqU/E4KrgW5dwic6UEINvRZdnt0pJcFrssZrosWMtsl0MZNQEICDmqWCHJyg0pqUfOezwS6Kx3letJi2iDHjapgpwbAUtoKdgADt2O6VeBVE5m4pcsiF9/OMfgJLvEj2tj/CqHnWOt/WhreLgIN+mTY9UfMAy4T7rjUcojsUDi4g8plChBb+idxgKlaYVRZ9AMlY2voGLFQ5sbJrhhmSLk0CpkuJ7HFIpqw2rryqDYSFpV9NXX3lTQ39fWGOiDsqA38ekqSy9kGISC0W+5rxpRqIT2w2bu7wPFaNlye+ek4Id8tB//AyoxAF0BQ8g9KeJpq1Z4vcDw3IMCGu9+ADvCTFZ5bldz19JtPGSp/ilXw6Nxp+DX9MZiVU9bLYcd/HL95RQ5vEneZK2iYkdn85Mmp8MD3hnpR9Y5wZJjfqQq6OJVlz0o5eyhyV0C0Us58Cg2l+JZAxGZNANf0VSoCjdDaCjrkZ91Ryh3lR/1DbHBivocsV7pA7keVKF4UR9DSRRvkBtyhEqkKSYbPN1wbUpeko8NpKi9tOXldRTmZDZtUJduJIbleHOx9EYdnW0taeLncKTqEqOuAZl0B0gBfj0k4IvDdQYhg/Gx5Jd/fOXI3SWXy3gr8TXkw48cIZCXTiFp8YPWyzqP7oohiE6bzMc2bwbAdkCoNhXhykqrViP70u9Fmrkd0az8pXQ0gP+9zjzeEhw2t3JLSOcl8CIycCTjDF00Q4+ElilsucU0JuOTjRrBKMx50IfI2nDqMYKVIzfk8w20HblS/mYUXXBJk1KrgjJZVsvGrpDujByii9yljtDHbqQeVZhTOaY15lr93WSnPEVIDmCE0vWyTKooDX99h8sA0RoZhsE0YNfYf8kosbuCCSNvVUimqiY7peOBJFPODY/ONkxDMqUM6BAJnNKXlgRekl+p//RShqMjfcRcY4/qI7J3l/2rJj/8lKuAoaX+LQGkMeWmXOKMSztTrv+DPVzZSIVEjxsheqK10aI31jWUlLKXsLgXqOQcMZGuUhKVf6KBgrHW6PZzBtCZ7X11cR+a8Okz4NEw4NemZ89h6mpapkLZ8D7vRwqltTakfftnkObbF2z/htoeqh2y29/bjLa/nYYT/bh+e7+jG4Ubdf32LZSrtr+/xopW0IpGpUPtW+nQ+ndVPSTbjqw3YiCyqCLJUVEOKvylZn5SSrN8+/upg3rASxFLuhzPXPpUPCqDN+gASqE8fMjDs74CD6/c1cMSHpZ78bCEh4Pvx0z+/TK83eDql3Maa0kHjS0eF601Sz4xliQxBniPfnCcQlfiqjzekBLlPLQVnsqPtNDcLK1wxrTHdJtQd3TH2fNZg7HgNI1CcofUbKC9btsJzSqE4Bg/9pFC/ALP0ARJZFpL827lmRMUP7JZXqvHMgUst4rmwfDn6JZP1vvp+gDyC2UiIK+a7ec/2Zcfbw6wz7XmVB7tNcqk0roDSHlnOdCjxWlbdINazAmqRdrar0raugNu/w+MFGZkRNGZ7zvpDlzvBhtUpVsLP/e7A/dR680BidQyoTyul6djfAn7FYIJK00EMBfoI4AyJqzLd+C4dso4HuDBYhcOlhEGy5eLKwaL/aoMlhlcVxnXcoOqMCvuxPVrOLb2YSBhYDH+yzLM9q0I+gifCr94SQL78NwKRa68ilLo/OvoN9yuO86RhBEDNqrdoF3jEsIKU+oUlnibrF/DLC861BNlx9BMrdCdV1Rjr0NdwTKxqArlWKHgnBtc9fL2/Esae1JsGaB9EGoszLAwg4zorEdLMCNAPYAZuINRzIM6y4sbGivfSl7NkdZG9mPZWYmtPpKr/Ch+FUXPYc1oTU67nBmzBdYlfitAVxIkw7i0atnLaYhYLN3SwDjrn99wiY88lGoRMC5ZLCe1lnSSuh5pxiVQJD1LqfRdNAbVwrawJD4se6MWinc9A+gu9IyKNKiSvhZpgc1Ry0KD7IzxdiprFxs/vDF4hz14i0XwWlHGBT3ajEuENtsNLTROg/UpQtRkPbezqDfgZSGHD9WnkGJVEMRnFQqoGB9SpqlMB9yM49sduNnGimJuBQPEnti3NLWilfSLcU3qO7bTrl0qqNORBGkRZpq3UfgV1raoC8McusAg6PLzea3DLysz6YYRFigs/8f0/IYTpFsaH8llT6mrsMXMsY5TP9i0Z1RFFoCLF1ohqzUKQaTBXkVCVau49Xwq3XSo9H8SKv1/l012NF3XC+j0K4VOf5jQ6RcuoNNNn05Hs6a8o2F2CV/VA+/PfPrgTMOkD30N0yDnppLgoSo3eGBTrEAywY3DNRO1IsbSfTFpOvTSzQCM1AObEu2kMnFDh1sh01Eylg6jJtSOpUOR3LNxOxSJtVIpgl0d4910FIuMKYRHZ5FZs4vdzT60CNNDgul4MaaHZjCVdoIgYVqwoacEkldLimF9MwL3N9VbiUVLqCeHSHAJYqIKpVRWoQl0Ri0wgglQQWsefV4sps91pM9TNBMfCvZIfie1w5+THk7iPn9eMast/LlviKFckLTw50j4+PiVMlNSzOXPYYFHMZlakAqB7ocPRmEhPSbMJnS6TKQrapGgjz0R6P/cI9D1pe2VQqCT1hkCfV6qlJ1cT8MoTednVMLtu2k1jGq4KmrKXc6axNGio26Z6wtWIdd5GBr5jJiMGoFoKE2kV9SjgquCJpDicZYp+prETWmVhYGTze9wLO1jh5V0KIOlmPbgKqkVUCSdl+OgGPuJbyhikvfjlY7gUJBA5kM79y3UOddIxgh1ToWzIelFrlwUOR+ZZFHkpMprmk+cUwyjCmQqp5X09UCuL2aIc5T4fMMg6DPnSG2p2Y0694nzwB3UOTASzOuhQXElMAKzvvpmyB301GE1m8OdXxm5c8gwDgXgX8Cd/8tu3Pm/olJmI6b8nOKiyJ2nnjtPUZD1uXNe1tFuAXf+p7nJ8Tcd5/HnZgd/br5q/Lm5lOOPYnvphKxBWMCASoXw53ID0Pv8Oco5Rrvz57GPfFEfEs0qWMQB351AN6BppTEvrKOYFF0GndTMZ9Bjc/QtpCc6XcSgl8KgF4hXj0HnXuNWiil0dBrGeTFLoWNywUT0wEihd1AQCn0W3jJS6JGtziM5LRT6yPUDKs2BdJdCnwf5oAP5Ulss4tC1xyKTuawiS6lHZpLyaFVKeVA6wZdTfdBl0aHLpXXOEx+1hgSMLSgnmlRmDQgM3Ag2lw4hknUki2z5QALOY3LA8EAdlXpZhTJUJWukHkMnD2x53kufkQAx6GfOCD5MMwfWzGTOqJc5qcdOC12ud9Dln1oq1brBX/mbIc2hxjA16qdb1RYzpHkhpLnAM8OaFxG4WdocMGlUztDmCGCOe8EMrA6+oK5Pm2PyFNr8Y7nQ5geFMqdPxUOgWkSbD+fQZiOQzJXQ5rPUGFHPCZJ9e3X7+5olkGQjT5LRjcKNkGRDIsmGZNwYm7bRfJKMBj9IMrGucliZR4tIMmG9WNIVzFOfijsYAGz4vA7gzDwOcC/uXbire8Kt7sU9PhKoQOoNAqlXEYOHRNaSCBrzNxfRYuNTwkpKVKDyquN1Fei9hpQo53HFVvrYujBqyyucK+0xS/dVJMw/mnvC3IAwJzWRMPdcOX7sd1UkzEUSOUZT53KfMB+v1ftkFhgHwrzC6B+frA/Q9UFPmFciIIT5gUD0HmSfa81JvLTXEDNhfrCu5ias5bgvccKW3YiWcyJqkbD2q5Kw7qA7EFhdTKDmga265KQ7eL2rNqbHSQfcQRC7ByVSY0J5Xz2eju5lTLZjIcwjgIVAPwWwEC662IHj2injeFAOHRaOlKX5I2UPuGKk2K/KSJnFFaCGU4grZ0D9Gg6s/RhFGFUM/ljG2P4VD/1yYMsNs+X7Rzpy1E0V2fKBZ8srNqp9HLFa6eHu/N+3KR7oDCJbzlbMsuXGs+WwTCyqpFzYcjjnqj5bXqG9CEW2XMywO5aheFhYBba86LDlV0a2XFr12HIo8Wz5O3OjiT4zCxhz02PModWQOrCT+EppPWXKHAqNS+lLKHPu3ukoWjQpfHpgY+SBCzcO18zEihhL98WkaealGwte84GN7vJimcOtdMtFY+kxqkL1WHoU0T1bt0ORmCuVItjVMd5NR7HImGJqdzHH7mJ3uw8tQvWQoDpejOqhGVRNlxnLoIa+Twklr5YUw/omd7lIi95ULCpQTw6RYAExUYVSKkvRBDqjFoHLurQPVw922BZamNhvKW25OxNUl1G1RFNUe4faQ55uIhIZu1neOLVhA1eKk4IHb8AHXYq8mPAo6FPkKQ9RociNNJT3UgtPkac8xWHlroQiL6GIKfIBhAaurDUX4l3TnRT5caUVbZL/n71/AbTsqOqE8bOfZ5+zz7ln3/fpe253r727k3SeNBCSTgikDzaYGJCMfx2Z+XQmmMDw3b4wCSIfI4F0SIDmJS1GTUKkb5+LEl4aBPEir0ZRo4K2yiM6zBg0YBDU8FCDJvBfv7Wqdu3zuN2dEJQZ6eSeXbuqdj1WrVq1atWqtUZNCjgrT0/yhCpkN6uNU/U0VbMmZK/La3pjG6ilt6dxwT0p2CDWTWz44UARwvCsOHrSmJe+5Il+klbMBZC6CBtrAfl648KvmlJ510G91m9NqVwz0vqabf2Ol2vZ2V+r0MAUkNd2vEJtx2KwfvcVKC27FzEgbqcHYoDoXJ+XZhk71xLT+GvVWKqXSfEMPaPi/0FrYBCWHdTSypDpSvVhAaOGh9ey1+JbY0zk5kQyV70FkGYv3/mT9bXsZ15nbgtoCPb21CZe+grPFwc+zn5f1dphR+4stj2xt9d6ReGB0vfFFGcnZVc3ua92+LCqYVuFdxhRheVyXZn0Cod+Qp61ewbHb2AZ4S1HUendXqDuu+CLwdPGDJuBvSURdaXRHoi/Sr0KohnIc7bmyHPQwHsFGvIdf/W5Or7SfIB1Ja8LrgPu8lGq5m192LZPv+EFaLJ3fAcfrjWoQx25+AKREFX73GN4gcPFmezv7bWOPLC5jlqL+aXtwH1/lv7+U/75bStPHOx7zs8t/Mbv/PZ9H2KzgM8863tvPtz+4YtLC4F3wJWHMzZ410vf90d/dMbbnzDYd9Y3X/J7B9/xOBgbvPnGix97/4ffjeBV//jx9/3H/7oL3///XnrlTPoLP4OgA4E6GAmcob9B+urID3nlJi97PUBahLfKWlGEHHOLxERH8hjAAVS+AdSW8dFEa6+AQq0G/+BcB4TyVligjNbzWDXs4vU8SrWUD8NSjvIHQ25gEgQOhJcVDaDoUblNw1fb8HT+JF/9v+48ABMe/bXf0vRjeEp6/8BHOdi/G7+c80vvfSMKa/Y40x2Scui3kcIRzbSKX95gnfur/8mKsGuAX1qTR1cfmT4SfdTWyH3R5LwDaiKrPDJ9JPqoDQ2BCxrYaV/RMPQVz0l9/R3TV3lqX39X+orf0b5KyqE7y74C+uIR5lYeWXr4PdW+4psmvnmIXb6L/WTBEH0epxTfKuzBvue+8UmXf7r9l+ziyju8nt7qecG1lWkyGDCuXvvJP/rPF/7Z5xjnv3jbma/+/Of+M08UmQwv+ca7fvivtv4uz6BPPvMjbGPzDBjW/KX7YWTzevZuo8Y+ne3MiAJg6aVqJ5/zigMDtQzkjGQKKh/h5hyhyOa9eLB2JH0D2jZMBgrffVcER4rQJYtNztIx3qH5P+D2/TO39P/7Dx9ZWP3If0RLnyqF/yLPQeSRHkto3yf2HPzQF/759g+yh5d3veeDb/q7HDP7nT9w24Gnv/QN3Hc0nDGWTbymb22KD5UIPlSO756o9Ke1ZkgXT8J7YJWp0iOlapz5tiJg71pVM6/qfwvQMi/n732WmEl7wOctRn/jTuMFpqSLt90QqjU4XUUsbSgDBypEiPvjwrc9E4vKsPlY4yHswPuevGVh71W5T+5trQht+OgagxwGMPjh4vQWY1kb7b2y0hoK1tnp4Jve/JHv+Q9/M/+kNX5lBw11POCZ4Yef+g8/cfUDO56EnLcnN/TZo4K4sUge/CqnLr331dc/5ggh9cD/+8HbJNWknHpv8Wt3ZEi545cePFJJuffIL777I9f9Yx+21K/p3lJJufirf/oP3Rd8EimH3vt3L6+knPFf3/fi1tvfiZS7r7nm/62k3PyxH/36C+9/CVJqL96+r5Ly1K8duPwLX36ypHzg2Hwl5YuvfOX2J703lpQDf/0Xe11KeNczkne88sN7BTBzb6qk/MDjP/DiK/7ziqYcuLySEp32j9t/ph3urficyBNZkvfZpME++/maOPgwhfBbYaH5lU1rR8rkFiNlci+RMhkySJkMTaRMHgGkTB41pEwaaaRMxg6kTMYqTbF4aLFToJmarQ50WyoOK7G8qmFbKv3uGTvBDr3Vru+wA5Pb1JJvhUvK9g4eUP+wz2VzyS73kfIS7CB3PiCVR5wKoHqZurpgO/4+5a9bQTU++7KJ9Tn21knZvfHst+Y1d41YCHdtMGD2geq3wgT+rVhBQqq7tma/pJsTtX5tZn9370CcZbJ13UG6Vzy2n127+SvYtXjiRRc2GfT94J/zb/Y10QHow5kCUvnBkT8vkWn6W4GfXBdf25cNAnY6B7tUgwWvA13ivG+OzV1uFo8ghnzE8Y4LGflFsjyQGsuSN8o3c5D/8JO3iBGefN87xpP3bHU8od5UQgaHviD84otrRaP3Hmb2wUypp+9dVyjse+CtX/6Tp/3YFTzeTT0u1OxK5ZvriKtzHDVvLVLFIT1CjyWSmmvZT6EcREUS5YxBa3blo5EeIj1Vq8i3gifnB+KbmjFv4/C1rDxvuqCI/eRralZ97Eztu+CyHWfPvPr+nyAXvLInhVJrgOMqSge5eGiDzhfAiu2slcM2KvxVw1zOZ6m3ZKml50221dk/CCw4z7iTy/5RY91x8dmeV9p09fBTM55yVBXRE3Ol+435hPS/wLinINvaCLLp+5xiSna/4ixwKcNw//4BtMHsrm9DVlKlgMJD09T0bJo+w/Mn9KGWXf8yU9yFYg/yNlNc9jLEY1NH0kNf+3gDYoc9srl23z7cbrxv3u47h9r95k3b7Yq/Y7h4vG9e/D1Dxb/jJIrfGCl+47hQ/4Nq8e85ieKPDheP982Lv22o+A+cRPF3DheP982L3xgq/qObFn9mzSDkoZcNFa7vx/Bd9k1D6F4X8C4eHi8d6RE7+EZIVQSO9niG9nzPBNoDQRYmabRCoRIUjTjqI+LtlYj6SrmYFZH5qrlStf3uKAvytzg/hYZKiXc7Ta8wlKEjWY446V7WVNBZ2bfb++X5f3zivaiAQs2muSSPVyEkKgErfG48CIkDTAj6JoAJkHznIjfNLZsm3zP2rhdmL42CuZTpFd1ua0RYqSmEXA9k7aBStaFZOTx4eN8cMz4xhBlvRtYTzcrh4vG+efH3DRX/jk2Lf5EvJ/E6L0cq0PejtaEasKSK8efXfkxroAnn3cydp2gG4UnmudtMYZQ6NF+Hq8X75v26HbW6+XoSYLtzuHi8b178R4eK/+hJFH9suHi8b1783UPFf+wkir9ruHi8b178A0PFf+Ikir97uHi8b178zR+vFv+Zkyj+3uHi8b558e8ZKv6ekyj+vuHi8b558ceGiv/SpsUHLGj+z0NsSFix4fsmWK3NXqUia2OenE07w0AvSJAs4Kpy5GXXqy8KCqu+3QPj5kudk6VnOKMzybSIrCVjLtHGvPvLVPr9ok14ozf/9MsqvNGh6zX25qHYnzaxN07Me/+hauwbEPuwuatva+7N2MONoW7dNNqBCz1/uBJfK/Gz+8FlaYKm6h0S74Q13j1U48+dfI0fvf4ENWa1/pdQOO/Abkbe9ExugnyQ+4qkNXv67Ge3vRYte61nP/5jzzGfu91BTU02Jbv8+1CwbhaJX7+GV1VHVbdzWHmRBydZzhOfEHmcsauFLbDyuy1CwxdZkr3uesVZn4FBHnvozzYU3fm0rf9Lr+IpI0nZrddr7M4VTXor7O5nb5RYjc8+LR+iQT+lB0i7NQkT6j3SHuCEMYB9us+LEcT6+hArXek51iPhu3S/V2b3TXZfs/ua/VZ/iF+Pd2qwJp4UdWI8gIcATcEuCqUx1bQ8nT4UZ7+g/cA+R5Xk4Cgu1TlHHpokyoV+9iZkbHmbJlH8JH+84Bib2Zp8g8jDghz9Gg76DyFOm2zm/W14GEtbaKzqmjyYBkzGTQFrKMAq4kRobiTKFrFD4xs9L5hkHtzcqwL+i6MXcwbY1RPBOX5guJnuKqZRCBQL7HiBhVLb5mpU+4hiBd/IyoPScJozsZ2+FyOEcpz3myKE1oJxQC6toZCNGHPc09q22zAITJFaY0MOaG0gZqUwCq2hsIaBVZa0Ch/aOuvfU7U/jUMRFZ/CsUVgKwi0At1qIwuHs2M3GCvUcgKlfkNc460REDI39EQeDHWO+/lZv7SX/bOlStzCUv+22tTN2hhIA7Jv4vtHfvSqdbvRG5xg9F7xCLdC8VjakVXbsX6CdrwVPpIm+MSX2kEl7MU4uSgWQjARueGTwYgxFHLHkBEAQwi1If4rhzCwQ0ihnsn/wkHZ1Ohty9igfyQgBE2KUKurOuZi9wuaGvSKLXqhVq7exxctvdoohdalk2plx5p7oBgw5UqkBoUDHkjL3oQGLQkaqn0Tr+oV4I1I/TcC1VtuqIJKce3fFFS337ApqNwce/vJgyocApW3CaiCUVDJmjwMqje9tgoqMyEUWNm/EbAOv/Z4wFpDKpyZKbNKskLLiufpigej9RcEdyAxvSFpyHE/70u9l/Cv/BkQ38Gkt2EtpZfbcvHpiW9xAXBwRC8N+rwB96gBRxRr/ARtudlDzau5as0mgEUDiyo/YIEdN+SyX0JzxJ1VWnouS/ut1aImr9g9qIsxLLZYZd2qW/hq6h1/CTQgzQIOzSCu4WYPHq1iqmdvQR1opWgf4cJKF5LlBNiRTCoXyGOv8bRkRPEIC7OMYW2oyZx57x5fDXyhVL2VYxaHhvV/98A3IRMHRFpickx3ASCjjf4Bb0XbrM0F1ZUG344snGHCTr/9YBpezYXheYV5Xm6eeh6RVm19et8jjynVSapXElisnne4M5nJwX3SUnabJ5lnZp41zQjLF74YDqpDMl/MUEozsJc2yzfP+lez0oLcAeDaYhFpxys4hjiDgTgnBZA+/kuvmAPwGi4Dzb0BMYIbGjunH07RFM39aA+JcrE5tgJsH1lzn1uSwWBKoubLzvD35lN4cGNFbYBaMm7UoRR/l8LsQ3/vNSvSwpjiTRs3R6bqfAo1A2mmuZX5tMEdalmjRVN7fMBvmr9CzxVUc1z8nPSQa3hDPjfS+g7gx2OQ9Q/QSp6RR3Pvh2xtJq/TLMrV63cHeEYZqOSMami0g5EvN2B96cGPQlVWG+1ri6u1RZiZGT8A0vfLHUKe3na1fqbvMw3AQY7w7sKxq4Mb3Vs7FqkI9MzFW8lVEdJeB6nwSXpJBrUqH8fP9LfjxJeLKMG1kTw9q6V2dNFuAzC+B+G6XZgfdzjmZe8SpzV1Vq/IEyWUDeRJoBuNB9joXeKQUG7UZHcgPyybXSKAWIY/DH5jnWbiCzTP4M3ev6BHwnxThzqrRZY9gJh8Gurn6PY0aqnhEv9y7ulZEyDHCD8zEAtT5dsaum72IR4eHmXg7zODHI1VXIaD9xgUXJqLoQ5u9Xho11OL2v5Vhqqh0jXRa/aow09GkCk8gFdZIDpktnXFLHHrZwkQsy77OlI71YBQU2jEFBohuEAN00Wukvk0KaLv6ZJV082/3NDLHkQu2//piikweUyf7of5HOI5cL4fAm/xiMFHfmCRq/rAoso6nMfJFJ6iZ6jJwBpQYiTCp+/lM8wZsZDHjQ1Q3azWCgXRKYryDoN9lqYU3biNM+pcEWOsqjiAvN1+IDZPRPOyIwPmYcDwUcjgkE+SwXuFxDCEACYRRrGGqlLsDiY4gM01MPnQSMG4GeJ5j+UXUNSeUQysArssKJR9Q7GJARty5DISXc56/6M1+DwAjlZj97jIN5SR5CLfrZE8Qez2fyY91khZgiN3ukJ+YkoFWLOvdSx/XTPLxCgS7nRFtYu7I1FHKmMA5DTuGPBDRXN/P9Nbpx5sxVFgbsPhSwSSwWCAEwKzkOl8bBrx7003lDJCUJEPyLvQlY9K8NYJp8lGUoz0FCeuYBlUHDtS2sdcaZ+Q4Bs3K00/TftSP7EDLgPL2vdSyj/X5K19r/vbX1v7p9859EQoT5UvfGOxLQyIrIh1sCtJX6qFoUBwg+9ESWAMgHSYySiVppRLMXAsOgaSAGOHmmAo8gwchhSVT7uFeMYFExec1QV7Dp9IF/L5SuLET2bQXm6gDNocbrsWGLy2HbwFWigHb14Hr9IgwNtUVcwjeFSCi08puqA2eZPmZTo2pTDqgPhh9lmVaswe7vUipk3phTTidnRXV/ItJe1CYVsoM1dB35svUUwZpaswY1Stg4uXOmjpJp6xqCUcq4UyTFUuq5yqWbFQ8QIP9O+xp/tlAt4u88gmMp85gqm2RMzQLPVoYbDGlGcOpc1Vp4HsITJd4qfzDjd/GpA5JpDpPqWYF8h0ODYBrLtPwTuo0AKipSMdWlDo964sFnt5B7URBzjWfGQA5oPSZRy3YXqwdtGAOviSW1fM8lezR/iBnsxe2VvHVHTHZAgFrI3zRM6aUPAsXMktMfqZbdDAAG7IMTDzItoI0VBlX9VKlXZi2rSH+BPV9F9Qjf6EhxoqK+3KoWJACbfDAdwFr+wNisTNLxe8imdXSwbLCQp+rR5j/4G/ilu0A4EjZPX+1/wVc+km+3WZyAEPrrwPcu6w2BLlxXQDVMjZhFT/NkX6FL1eK6avOL5tjy+JU3xpTsBLs7quqYO2rHk682/mJ7p+CM8Ga67g6bFCCz/HeHNsCm9HBmku67RIGDw+heUAZV+5QXoEdl+YgjpvOrzCx/M2D01V8WGknZMBUs6zbLPD9ryJB0Q5dVn7tJFcutlj+Kl2A83t3+uv9D1tj266xPBm3tI23C8t+JruqGT9beMqFXGekFoid2gpg+ADhNCNalALhsqzr0qPUFjR0uv6zP1paUWDs6toweqjtDHL2qbKBgrW+VUHA3nMnwTXYoohexe4fE+hKsuYGZWWjkaloRgmBTAvBBtwUC3jcDfGZFWCx3C1hN0UP4fq2GRfwQ+uwr9aE5HvKh33y6kOaw2X6IMBpajmwxlanfixhx/AnQtrz1DQShF7ULOXfU0AEwrU766tZP+gQ38m90Up0d1+HqLp2gV8rgPnaDoUm6UpiopN7TSeBw1K3qhPBYKnuGexDjKE7B9R60R0kfv3OsuT8vLRAPPd4PBouxAOdNpurjqEJcSd1HzDqdUc/zMsQ2MnZe6zv/G9cJKbT53sdmNiRdWQ9qpg2hz3hCoDvszERZzlBcZJSb+mTsxV8RkiZXXmhQpYBuqrN8ifwLYHGYyUKODIB4yUKBJGMvsnEaiFkPAEm9cSai1okxo01h9IrApvfx7ZTVeEfFaYjiKxlTrdT843+cG+ijk9lKh++HCeqo9QHkjL7r/BuOhEg6xDbQ/LrR4tVcVGn0feWvpBPwiFIDv4aQvdGYCxpiYxRYSiyYNBNrTcXD8N1HSLXjhN1HBLLFZDMN+laIwRhQIpsPicJTZfywpVrxwSqJ0V3VHGRuxPuhMdOwXwNjkFSIAXqI7/SrloMuEUoEh0ixu6Bo11JUSDQtcgJ6L8PofhVLr2pAACsi4/sAtXx5qJkf0EwJ5fuV53ZkG5MJKXvt4PjWjOsvdriyXyOyoR6IiQ2rfbiXu21VQAE4xELJdmYmZ7AjmGgoE9XUz8/sYCFthA9825yj0B4fE9uHhUvBwlPiP7VcSIyDLSLc5ti/zlbXb7J/F7qtFvKKOpGq0bHfWqCSRG7bYI7rIFSJDe47H/XHUKDE523yW/8oFbv/Lpn3zivo9/DP/uuzi78QarNYMtuwjhsvODPSQxu6lWHoMQwkIvsN9SRLEIDUdogpmC9oy0qzjG4mG+BJMObmbVY/3qCvI+VR0DZkUdLIRIbnG+9+Mr1iSkGqQpj0kudx2gcKPCsPZYF/UZVEs/GgbY31VPliN7/mvWvprwqXmMB+V1xO7JE5HfoDcTmZMuCL3j30DoZcsJNndDZEP9rrBZ7j5A2DP8FjcCSRGcC2Pjnf1PgyiRfCWS6pJwAzrZZxAynhYLAeXuwhhKJJW86RVw4osivlX+IjA+VjWsS7EUnl2PMRVKgIIUZSPMoGVO58ccRdgctuQR7EKb5Ciri9DpfhcSZ8TtAnKVIXJq1k712wR27t33pf+wse3lX/zjiynKXqaERYT26rQyKxrala6a8sl9a/DxUFCEIvTnDRh0s7Hgwp5cqPq9OBmGBm4XbBEWODyPDEodufU1iDPN9ERPsQGXi+Zx/+aAcdAIJlwfFUQ3CIiiiqJA+mofV0Et4ThWG6JF5IFdHhRc9i4M6H3zYuhF3LwGk7FHk3dTACBfQgG8l3MD9knoTsz+vQgKNuxB6MGav4c/TBAWiJ9bgTiFjGeA8H/Y+Ee+TzQOdyWLf/4aw+1T7uPRzfWGco7Dl2POiysXduFrd//lT/2Pn3gitB3P/H/ffPqZvSs47G3wBaGHqPay5kEa+tJxvQ5fKTa+yH5NaZ/qwmTvNacqgcjKJI4CCMpAKITWc49ZGqIJgKDkhufr4E49fQDAgi4D7Bje1f7uWVzlWVbDxqmBpL/UaNqFIdN907WVsT5ar3hURl1ZVbAbmEjF/6pgiHFKTnN01lIRqyxDXYw5wiGr33si3r/w8yg/m/z8GD9Tft4XrjBeimWML/EWp41jdn5O8fMmn+Vr/FzjZ8bPg/yc5ucxD3a58hkO3sWlzAr2Y5Wd49DtHDOvmRC1wMFDkVSxiPy8RHexvvXvqIM+xW6HiCBuP2nXtlwQ3F7HynVHPV9CGYHbHaBEfLzU92iLpmUbstb1svfhqd2iXvYbeKt8/1H5vqsg7k6cNkD0pfP8Yx6FqP62qFhm2ZVHC656pGeafHtEy0wVua3FFnd/tAcSN+c+QO0KEgEVN9rnkYOCA8q4iy1sYLl+vza9PLDUJuBbYMIMSXbMsQ8gI3cK0K6voC4EOyLcnNZsEHF+ULPVtObsQ6b4jIW+IFgfqDvq35kQNzUhrj0Wp6YSnB0GMaW4hXsYq7muwaDYOoDAPVMw5VvQ5buDnMEG4ptvQ/y9Yb5dFvr+xnXYrm6Y69Gk5RNtVd8YgwHRvhvu/L3n7v6v91xcuaFJ22kbLePvst5GeVPOZvj+vWvETarkRwvXnNxmwBFyvZTz8f1ENJcMXn3Ywrp1HrfWRB414FiqxL3BxM26uBJs6YS4ZiXuIyauMSFufsK3ixPieuNt0VnG8ZFOGc0L+TfWpbqsS6AIdbcGPbFKd+1ZkioBTtLGGz5/StOLZa+hW8L/LTPSfRUWNRWWeObUhxkaPX5BujQm/UNP1K1Htc20GTcdLPVV57TGlhh0Jt84RsaPWGuhYLWwx+c/i68m6mDXH0zBZxKeu8yzq1pk3COskBQAjVX8ojNJ+D0Q+h+EtrI49d+QXR/Vsp87aKDrwPkvkZ9Wl/QhBQhmyEuS8Uzd6IIpp5rpqTHy7cvWTUCnWok1mG+MKEA8TjW2s0bEjzNXeImBbix+rilSNtnDwcTPq1ZLtMmX3w/gG8V9Co1AEYpCMR5Yuz1l1MA/YZIDyFqyCNdVs3CP5tpNnj1Kv//D1+ErZJRNmL+3qnQB0ZXeCpPPd8rn/jLYMhFLFU01qW3cjoO8lC0uUu2tdLOlnU74oQil/RW3yDhJBPeW/U8wXGr6MpYGEBcfjJcLWOjZVpxquV2dED+orutj/otQM+K6Th7AIHkhRatot9JkAJDqK1yNmCjVQ5e6ACAPZPTzNjAWHJInbRQn8dJk9AmhOZB+gR+F4mStRQHVFfpi0gT9zFuo6xKcLtdhsIraTCbretiGHss2PRLNGumHyu9sRYmWdL+MYwO5GtVBQl32gwQMPL7KPgxgqs9pHV4lOZzJ8XjpIPAa4yKgylQOIB9cBq9Ngc7qQGZ1Xy/s1BTdOdH6NVeXsnFf9/cBEpYLD9pAKo5QR2nCJ8I8/LJ6v+OeYny9H2eylTe10BbHBnZbEFgBtJAhOSoW/GBhM3qUgUA17DmJBKEjex2uefjUdBZeYL4nW0PXpGxYGvMUlSKU0+qLd6cVLHO1S3orVHem4asdtSCXQrSEVs6vqrR7BOWPdAKE1WxZlAj2/UshhDFtV+JKgTr8rtitCdLPxGw8o3mdkrZjXuWcqsr647ztZz916r3pOdN83lawQu2dMtUgsaxcfYTrqFr2fsHJpvKsl5O7HrTBByQxNdfWCjaYeZenu49BEQ/b3QAjjS0DVzEgKREoZUoNhR/gj7EtG5iCUm7Ei+d++Xs/+5M3Ma/bNNIuXb6acoNyYz0X1N+nU2VP3sbjrHwKD8o7KrHL8JjLp/vDZ3xsIWg22OsiQhwr0QxEhXMrxbz4Q1PVp+sw3rMYUbEcmNEcs8RDH8oAdXAAz5+tKK0AwwRA0BS5l7XD1K68UmsobY38jfU1fomuans0r6JDmFzFngvjDrEd/5SUPITNmFmGRI4TqXCNh3cGeDdDnlGbMjQOSiAj0uxhEN7kKQwPegrEaxWIVysQn6FAvGoUiM1HHIjxIwHGwUOF4w9W4NgEHJvDcFQnscBxQcxfboYt3unFlZ1erdzpORYGcuDJIiAsI1XjHmX43L3rb3wgKISqxxtyJTqE3GEP5g7WfzB/kOTt5vJ9Dp+1ogLy7H9hg17UUSVixVGeUTNBDK3IZNAY2TDOaUw/WDGRTWEDcu6sbByts1p1GSoedpz3aQwjow5OtadA14Y02nggp8C6DdzdwimsVlPDdxfdVQEVrWNvqkxai7+PVyksT/lH0mGi2F8ZzqJH3SZnp2wNDvsVa51fDOpwvpaouWAizKhYcEO1XfpJXledOSHbao3NI5/HSAChmDZYyz4glMtTz6VTK+TJ/XVsoOu2u7EMo6rEdoBIUit1aAb8BJCt0xb1gg7cgqEtcDvEE7DDjZGCYYwTj3nOtKDW2iqApjmuZIHr60h7gep1al9tzT9PSUNzzzanTikaVwr/iU+zkdeWuNeJIRZ6PHzkr6sFNx9YsYDOLFAHkwaAkkHrIobTiznbp3mBGNwcCa9lId5/idoyhyYVhHV1q69Rl9OYKYYD+eVQDHKoL70IjfYr8o6uChM8ZRTUTjUYmEWala4qpmU414R15sq3VeHuwOQuPFVakqZMCbSo60oCQUgwRim3omPW8+Fbtosu2EUXL2vLEIq4ZQEaiqvCH9cr2QTF/LxaiJxn+mULbQr3ryf95dXViicp3ViXZtOimgpTJSlWzOmtMci65K0BSMoamnGrSxMwUZXczVNGi0e0lGmkTXM53bU8gyjiKfkUBgFCoCmxJq072kQn2iG3n50DBSljwEISqEwZwxTRbZd+J41aIh0L+O87hmL+7+9SzG+VYs5VKaZmtwRzbpRgFt6+s79n+Yt/ed7SxWL/xSv7dvTDg0Glm/Oowsv+Tm+xkQ/jXPm80ekShho1+IOTLtBzBYr2lRTIUZZyz5Mv9H3As4J/vy10fBGw0Pm/ZZyOL3IlWyp0vPtQ6fiWTej4lnE6vgWd2TJGx7coHV+0feo+MnR8fhIdn9uEjs8/YnR87iHR8XkXnBul41tomhbH6PjcOB2ff1h0fH6cjs/THOj43AnoeJcymh+l43PfVjr+ukfySht0NTjsZf/zNfYCGyRvuVfebPtMmZB7sk0eudn2e74XTtJhIQjoV6wOi4pAdB/0Dk8uJKux6Ds8ubeQrUlhmmGtmuHNQxnU1IhvjY30b/IgTdBDxgBaTnpdKHRf8NewAt6/HAMmzbqnNtIsib1rNLa/e7iquWpN3U0rsrXMTaokGYt08oJv71X3+Vofe3s5XMP+H4H19MlcBlYNczlLLpbzqz6h3SkBvTaeugtF5Bl1qt+WhOd6wbgoqqKJJFKg/gvKU99QLRVUTsgBubD/I2aIAvalVwR4cQjnlJ9e3Uii63zZ93ny5/Z/C6WWpHZIHiK9erL4WII/hERIJN4i+6ZqjhsLunKKsquqjkC70Bmlajky05bFjC39g6ZSYNT8chC2XTjOq8v9lGl+foyfM5PLMEu1J/7Mufq2p/QFimjVCx9klE3yWYnP52wrE22lk7IZz00FiNcczbNuy1yqLl0SI2PTmvLEdhmiTFKmSSUEUH1Jst+RcYXGLXY9RwNg+WHB0lmaB1cxlf2uNKmhBX1gwRVMDRQ8sURk+oBk0o9slg9UK63TDNI02qra0XQl7g0mLnNxqjRTqloDjNqi7E49lpGo7PdkYrdEGauuuZKVsdoSoCP/uPVJNNwrlwSwLgC1F+D1cVaAPytO5/EIzYhQQnMyHgOrKeWGYZaRH3rM+tailupFY9iMVjrvvgwSY9dZWfS4YGTJu9pB8mX/WGxRd1xazvygWMp+X0YI9zY5zThx69E8/9fl4s1lkQWAa0mcc9mvB6wnXnT3PVv+ff7iwQNBP1rJ/gClQQbcxRfdCiOx1NebJrNywatHXeXpEsNxzqN4iOs1YmCaPa/tG2CNVS0yyH4AFNShAp/ItdwChlrraLndCBsq0abFNfiXAKo3jVKwgZ7MThnwUDVs2uuTNOnGZsbkKYGZvWApdit9qudNpnz40ofJk0BpXVX7U6fTESFmVcL2Rk9sbTzpnz79qX+64ctvveWo0VUQAxJuE2MCW/ZSaWwfqOUM6WV/ekN5wxMX44Lsr14tJ1SOh7v/4vUHArCHKeiu90LWbQ2ohtaCtJeZKDAXw2rpH9TjDu8eQXn9F/v2RuzdXtlrc0y5ycYxwXp0IIB2HPZCV5DosuGSZ//FaIJwquSD9zD62FF2r3IeOITKACednrBVFuG2ckwhnFdKMX0CV+bhc2jAw8VzA5Dm16aeFYVqGTFP9ZYwh1raJD7zDLFLqGkb8ilXYgc5bgwgdt1gYh7LpRJsvHS7EWMuam5xNvUZrm2+7+ULNKeXYn+9BOTAwZ2m15i/X7ytWORJxlt+Z8f9vQ/OyraEWyJLZYK9sjTaoya3+MFaWJPJhsK30NKDnxeXtRL/4D1eviTKZAVGRe848jecKw1F7foa5vTDXE4yyEPyPC0yDryE8ROzCenkgwtSMRfVuU8zeU3zaifxMXbJMky4ehbojVS5ixr0oRTibgDLyZezrpiBhXwGTa3i+SMrAsLAlNdRFdwHG77uy7R/gXTNr3E38yU7p5YEEaqdTm2M6WoNNKBmqw2oLbuGwBp7TCTa588z+b1Ciu9nqHS4dO2mvqARUttw8XqxtWfGzNPXZUDINGaZfFxfvIa793y59bpMPUQxolVje2jdNQqPvp8zMNVBzhzAVHAx7wfKDKinTyCQve9Hsyp40xe9taOLjBGe60uK3pT3W1/7bdlCfN5tIbrVHcRfn2AH8TP1zF55SQxD55t378UcmkhulHXa9wOiNHdXOcGSvWsq+wiwbMVMWioWqvNI22Smd6xaBnld6SRO5YQgwP8i3GIYglD5AmABQWhTuIFL1Rt5B3e53OJcvclW0oZZQxvmKCCb4RgMe0+tF5HqeubzFBmT+REoiB6+V6lGZw1H6bexiUKgwAjV6BoM3AK2RqnGEihgQktKNXpmVnWpB6rRqEyg3gjVmOVvqCfYuwVI2TBUYws1kDxH0TDVqBmqMSdUI+bezuMwa5hqNEqq0VgplpRqLINWLIFqLFeohvoVtdO3rVQjrVKNJS0P921KqtEt+7dUoRo9e+G2N0o1eo5q9CZQjSVqCtVYMmf2k6lGz1CN3omoRm8S1Vg2Y9bQ162AkGnM1lGqsZWWJ1CNZbTuGoWHUI0lNHK6InObphna+n7RZKRlfbLl+xlzVZBCJROMh3k0RCAoSn9r0209Uwe9jnrbz1QM4N2EF9aGwkNvpyJGTeNpTlxilWTd/77tBquGg7FFU1TRqFWA4jg1l/suho4mek/QOHo7PpN8uZreQiKXN55OtuxW9o4yUk0n+fo5MuRhyRk6lrYMrRkGayjV3W8vjTZBCBioIkfV3N42taJl9tUgfbr/zT4uzOTfJU3jjbIkeOF1QXm54fzKnT9IG247n58RGxI5v7q7Dcd3txw/tL/VPXBohYQh4oQPqPcPLUJz8yBxVOVAWa9oVTRiq5a5dS+agtRAeQAmmk0yG3bt+9kfIl2LpnAFG8zL5WZsBS+bRn29f4CAgkrLZeOklwww3VxzWnr7t12JCXQHTG252MvCxiHZeRO8O6d1V4vMaDmFquU0fBekia2UDL1rkr0E0qHmIJ92O7AZvTMpzF8xy4useoKewqPDkm+5iFYuQgPqrMtNuVJZi7F4twFYHbcH6lCBy/5IFaXziN9vO5+XIBCEwF3apAxKcK1Vbpg0n0J0Zl7vVczLCcZ8pT8u2BHHruIwsBJJdShGLciY5Iu2iIIJ9jBQOkUX7EZT7gJ3dNvUREyXY44osF40bLit76ETKPmSW2le1OlxR1Bu5xE/OqxajwdhsPgWr76iBkmvwikRwb/Zw2NlVjBZuNGKpGfHEKmHGzOCBiFq302hZYbkfQ/eE35PlFqGuAwpkJbjJBDAmGbxMb6T1hncnTPvNeuh5MDeQdHkUy71mxfJyFNkHOd2jgCVNo6ogmvNMl+6P5WxzBM8wrwBzm56LW/Z258NSvb3u8+1Nz9TvTx0uWKL7nkkek8l9g1lLFVi362xTDoMDXKS+taRW9J3BgEsN088/fMYuEUE8pT9jUom2arRQh7jeRCn23KHbhlEBlcXQlD4s9whH87umGwjJFdMkvLELytDJOQvBpbg3lWpSVyyRDIF7f0SOEzEZZkEj91FY4gk+C4I/0GVNxdU4W0il1CaoH0iCAuoCWRRD5iqcCnihUB+dDCzvxOONQZKEJKTog7HNOQjpkt4YUCZ4nSEE1xIcfKdCkTchRQUCf17ZwO6qK/rxSOfEBoS9afv9NmnTNU9MfyuUPBB+EwBIz1kUykZfldnK9a1XqgasEHp5wUFQSut+tn95jOToA8tJrzFfTmhpMktcUWeuK16fzFUZnhQOHIEvfFnqh89yXCLZgiG1OeQoZa+BurNsV09M3fBB3fLSjeFAwVmjFcd1kR0YjkhpDofPjaowdCCaQE85IoSdCCzW1Gz3LTPE8EWTGTOp21riL0fJ8vJavZyTPYnstZ/NYjdOh/aVt531rfhAqOzwB6s49YKsI5zeXqxceI9xjwau+Polvq6NEOaJJfjIJFbKy8bDvIGlka9oguFwwkSpjJO70iCwaCxyJTst5eyGx60ukHxAKsQz671tTVzq/FLFyPR2/dY+fdFlj96LdnfWsMyX8I1oS+dZSkn4vdUo99QRlM1Wmmn3t0cu3apNzc1cvTepkba73lI3Y3V2zyPh1xFF4EeyueRM+Vqrkv1M4qyT6hVtpqJ2iOZNVa3rdXMn5yUWWPByYdV81MjrKpq3cl9gGvFypU0R280m4vMFUqrdVfedKCVTMrdbfJlMgyyTxlpLpLvrpW67lUdVrRNfXiup6tjbgQC244QD+XVgOtaWQ50D7VCQf/6IPu0LndYUiDQxjxA1Y6JC1BZts7j4KOuUqk8w4+YRzCWEp8HqAx7+lIHoOtDtKhyCYn5gBrKv7THTx+H9v6qWtGVw7GaPXs/QlyGV7laVjELkn0F60z6c651rcLX9vmPXOMedrte5/mQxJSiBhi6K5HQU9yk2pVDxIkPTUO1FbtWGXfU7Zef+uWnRSRkCfbSlIpdp7fIx76H/8i/iALoLpUGL48tlLSztFqYB6XdwjwEZuNVrD4icDsCQ8Q0csEY6xwFQ8mxpbXAMcYypqKxpbXK2fWfkydqTdqYSx4nrQ3MGTB5/bv/xThCy/68YtgiwTXXSM+Hmlxak8t1vUhc32C/qKHUqXp6KrF7XOQbykiSyIialIBwk7e6gZspa4O8rlmFZqk3Qe2Q63qdo6VjIBupXLx0h5eqMYIiTLdDd9PQAUNFgcY6pr0j3SiFiB9b4MDH7KGb2liB5o4OmpSg9igfkGDT2q1JrN0ae6TWNHZr+n4+ha60aUq9brbGAJWOQEnHEqMewM5Fw3BmX3cbXmr33OVtEG3h48E+6lFrZBZj2QKiQXoEitPx9ex/4UO442oCszGwqTD9avYHUD1WHibV2WKyXlEeu9Sh1837NcOZ6wE84LoAmg3+XPxTBhN56lr2VZW/irKP2gcMqvcUHGX5T3sHa+nLggC3xMppRiO3ZxMSo9+Tb31FfMsrUxVCgl4BB3euQDo0r86tkH503gSO2cDdNnAfB/rX+4/3NuadTKBuZAJ6xXwOck1Z0prWb7Ka1WxVj8yFg0Mstof99tPbASZB9hd6D4da2d1KgZTPMjXgAzxbMKSDKy6kG7Z66pSA4EaZkxN3cyfs0yRz9LEsXP2W2qIX/Z7+na/h+Y94a4s+lvjss+Yltlbn3+qHqt7gwaMYZF+7AMU7m4Cig5CsGLpIBO6SSo3gTWWeAqitRDpZsHnANZ34xynmkzPeCD/5mgs5E3S/wCDy3fdEeWtIjZUNx2YGV4cugdvQFATsVuIQc3uo4H3zMO8gewGu2VN60bhl38J//Os3/UrwJxddCbAxVl/IOTG62KYzAOUWiJpBKpIBCh1UWPle9peK4WodKQS4w2ovHdhr2V8JX/33nhddKzda5nMfz6PzcgGMsQvcTvYGgD+PDLv4L053zQn1dM0sE0YDtbK/1/QUtC4veUfAYcNBpw+AYw6KtmTh77v1Fvz7vYtLLcgL9q4NKCpn5oDiqmLp4LCqt4eDQkzrSFFwpbtW/X6Q/iibo9ezVntB1E4UX9EYqCA7StjQYXhVDbr77mzaGdQBa6D2b/61bO4fPnh8a+n/Orbjf+mG47dii16n+yReGJIH/si4HPLSr/hR/brAGGlTG/mw/1+7pK0GUXiGHfNWuax7a6s4C+DpK0uuJ2Z/8MAyKE4VDRlDGSmbPf11hxDZVw6Y+4dCdTb0HVoONCnfFMUcX3TGUzJoimrjWrcSymNMxio5oIxVWaagaUx11TQmXzKK3dAZ0ejo0HT2D6+RlgDaJtymWTl1xLLjCqQW30g3dfjX9AZ6QNlfu06uRmlHzH25mf7Rl0Ixchpx06V2Uv8OjuX1EzeVGqC3L6DoqUhK/zRq+sa0Q8R/MYfDa0OdClhKJixHstgMT/jCO5L7SvUDjA4GZzfvi/rDvCAk+k/J6xMtSzaGZKUq07JT9Cgb76iqo7aM6bhWqbRhc+5ht19TSmhhZlWJL5gfo0PryphywcwFOy44DYxOqcPyan5MDap3w1ilBoYjcl4O8oXJdyZccIsLLgkTv1D09ufLNJ9vpbl828TKM6dDLc2nbWB1FmgZU28rMGTbxgD6zdOMbLQV6jaIhYbsNDeZpiBgXsi30YLoJAiuzMs5Nre7BzRYYFSbwal3vkhbONTlUJefswMcinYYs5b4bQufik/lSF9itF7Ll6iHAhdvKY0hATxd+1pjt6UZJv007GvSNNPa5gXKkWSwUUwZxzT4KiZipqiTvQ5TyZVVTInxySnOlVwAlqZV4pmT7KotXYpdUnlXuK8I/5UobApKO5NWC+W9/E33L8peu+MkirLPOU4e9B0PnAzVn1wkIIFGNRzJeA/tu1r2Ar5R5PI42+8Nu/tQ/pvickMQy4YA1hn53ZptL3cBQHvNrCkxU+uRnQAIFj6G5asFDty2UOr3yD6gU90H1N0+ILH7gLrdB3AoEYPnbh8AqaXsBDqXGpY9AqMDjZ62Bxe0Uyfm9EHaOC6v43t8azpLU+D8tbfr5Gefxzekxo0QmRSZuyGubWPcRzLHT9t4u1XQKw4dTJpOdX/gpVgUUFyeVepzQPxrAeKMnrkAa2cGwwUnIwXH2A8l6IKzupxKjJNpNbAfahiZ9nEGoAJ+vwS/fGTwzsKvrjxGzHhtl9WfDyPgvC8MrlXsWKjaN/3EApwR3YsWoScUYbOoZ6B34pmIWaFjC+RDU6MhAr68qWcg0NGHtoUlvTho4+LaUBXAIcyUFb418DPV54AivS4KHRW5ZtzHSRjS957Sy6el1C6kpR2Afhqlf6/Z7c/Y8r08pCnIVWUVDVW7s4PHvB4XApVmoKa7ToEemqpdyjmKEEiQOWFNTooszkQA9AI+GdCCRpZyvQiIFNEsxntW11Idb9TjDpFMjDtAakqME2B2gAEdynQwDR0L8KaHKdjxJs5oBsXSPHsMpmSyahkBxUXG7AWGDtwagJd9QRvAQ28R42V+oKRw6EKyikvLqGfhuLFywePZMOQ7fk4NgZJv6OEu1T5sDck3QrWTYucR8pJXPf6axE5gg+plX9QMMBM2ZDJK7klVHWMX8XruV6v0sHtQ4+z3zxOnhu60RQ2b3Rl6caX//rB4VH1zl/uSZ1eutmHT44BUUVvHR4PyraI4JKWtF8ERClzyoAgdDMPK9ugwxCTZn+lmlmCnTl9QTDg4kgcyhaobGm4doqp7pVueJTNjstQR0HOwG8iQbNYL8nDWEB0xffCPkH9yfQCcteWyRSdfwxDXDGxX/KoLV+0VedodDWs/EKq2N1QUkpaF0t41Ck0L0VSPorWqQQaKh5oWY5dsm1anEDNL3/RkCq2LuXUhpKPYYh6hcK0CSfKqqLeePg3KxJt6sPjH11T3hEq0JdF3FmDdvvAhXk3BHvVafC+WI3En+955PHWbPigC3acDoyiEyQsKcKW/zHOM84hdUkkF8C8QGVH29yKXfjMkVGHFIKRTT9LbclWWn6tmFC9CJ00+nP20ygTUbVp1B14Asvx3ZU/z4PTRwTj7Oqq3lyv9EcsaqAlTXGVkHorhYXdNcUEtXd0ZEzqJnK4dFFRyqvxCTWdSBE/nXXzhMgvJKSOyo4P1tVtQnl/JMl6eDxuBWl4mirqwM4OfR61kf4kc5vJ9TRNh/OZMw8zgCQAoNIyfH+s1wnNG+e73/cCxtVm5vveTPBGMmwFrBsOLeQNxXBtYF35XG7TXkN6XEHGPZYW/pFwpAI47BlhXJBRSZEIJ2EAvhVfKNxpiFVGS/a1lJjAhWurjkqNvNotQa6V0eDmkRoRptar11dBESBHF1n/OASgsJrJVLRpoZNlAgK3qU/+92d+haHshIaIQFv7l5mWiyozuUwgGeDH+e3xQjY0Re5+qvJCHigNVTix3zlmpN+B53otVniHripmiEF0IwAFjEaHwJ4QzWqD9SvazuCSQ/Rx+sUVm/l4lb8FwUqDU5PKJ8t+QVf1hwwvP55jni5QKHfRINe7UbmwgoacSa8EF3sy4v1vU/VS1inIJKLUhZGDxQBlXudkqSf2yglby9xMR/AO49T4HIIpJ9ucN6apcFL9XOMSk5A5RvNZylpg+mtKaWpSiForFEVrIVeHM4CsC/ra6ocEnRUZc/DTCz8lnqMXbbbmggx0j2J7sUi5j+unX6M1dICJsPMfG94AvgtM5ucuNm+Fit8Gjurg+4Gy9/asrpUWseWpIYzmBi7m0t0LRSj/mc71APDbd5Ezjo0zyzT5TkUONqtj7rYnh5uYgBtar55c7SNeomX1VZsu8RHElxZyibZviVdSJK2DK17d4BMrtrg5B8EJrrKUGPjz7mh60OPS8I/YWrxvX0qiJlXboV3uih+1BJwoWbqUfFGIksn9AYc4s2KoyiJqfPHjXKGK1iccPcKjC04WwKfAaCFgAeRiSMpHwNf+PWiSwLVQYeGowq6bYBnIr2BaUqBaULUgKMaWT/RNSCuWLlUv2RCBP9f1qdRNW2NUaG0UqxWxi4oX/nUJuxH8vcGifwkoy1Ckv6aF2D6PpyTjmUYXMVHFdEbtlELsNBLZIHSpSm87AcplZUhWhA4fQ0uyONjtDQ3Efh/jvMt7rqLulGV35Z7nN+Zx0nEN6YD0PCY1MgEXpmN6uhywR0hrI7xcgCgoZFDBI8N9pboV/8xCXrlfcu0cdwq4LI0NzFAosQpq9pEddUEsjMuUkT5K8alKTYMprmsG0aPR5VZGUE4sUnqkwO8SYRJP03cEXGlcjPmgXkbJo7ujrdJFJ4hCkRi2dJFDnKKdJqrveKfJ0mkSU6jTRiTc6P2IMgU6PgBKMUVBeDE457Ah6HHbYq5HHf4rqeaCDGyqKSgOkdCCqOvfRDLZ1RWzQBVKbuppjxgqCKQPIKv6oKFq++BG1qdPKcXAWKS0UxMm+rpNA6V8LPQ6goIOBKOKVHGjGjym1WCDXI0r3dx0wEgGGoY2Q+KOaQigCBSOPU4oQkRFC04j8GblaRJJVIkgzIPiGigs8Uh9yGEuIU+U5RW15tq2+e8teKa7r4ClZlp6IyDtSRWPj3gxLQPbPKiiRcmJzh0i7Hukw6pGgAbIdXOuB04Nn9rouo94KTwPW9T9wMWC5+u6fzWd09s6Sx9+Bu3CDFSs3LvNKUI8SQ3vdqc2sdkJraiJN7qxhT78/z3Rytqkpw4uxgJy/JZW0qP78IqYmMCKmBqYnv+lCBgqG9ROAwFISyB6/vcrdnmbR19PbHpQF1GNb3I/YMRvIaUoZd3BV5pMx4Dij69KoK0EdMwWnzsBhJeKYAr2rBk7Dq7oiwyDmPIgAeMvMygRxiZVAKa9oPDa8ZJLHBn/MY4M/7rGBm1312IAWg9c7vscGXz026NfGY4PzJ8QFXDvZY4PvPDZ8Q7cXztvGmMcGb9RjQ0CJdbyR3XVD1WMDGhS6Bo11JUSDQtcg5/Di/1Tw3fGtge9Nr/oWwffxVwr43rKcnHGd/2Im1uZvqnTi5FVVOr5WW1FCEsik181whcTKAqZs2QvyWFfYutOKSPBIhPunutgSREQGVR1hCdQbKIJtjZlyMR2NyVzMNM+8Gf5DWQHFIrKczZsU4NxOLKAppTQcY9T3X1jMQ4o53w9Wef2fB2Ow2IcFrhSLv5wfYvFom/V4C9X44hfuaskNp0AufrlXtCGw3uCrjgi50hm5b04zqzmv9xiXGsLLuIuwgtBWDi1KaBuH5iW0Hfenno8QcciXUI7mS6jg5u2QzdwOIuGi853ykuvLKfJS6Mup8rKsL6fRLL9s1Zdd8rJNX06Xl+36coa89PTlTFBRcz/tdL2cBx1FXFLLz6IzFTB4OZt24eUceXkUnYGX3fLyaDoNL48hZKTisRTK81y+XFY8jnbLy3l0jjzPR+Qe/uGtF9Fj6Gw6CzEX0KPpUQhcqEk1OpXQDHosnfvg5zwuE+kckEyPlltul3MNn/dQAhLOovPpPA6Mb/vwxdn4OU8+y4rz+TPbgpDOIxTD5SMaBaD2U7T2x9EelK31XaH1XUAXIu5xEscdqxSGD0xhiLaF7URhNe6K9kA+vLp4NDKeRWdr4xG3m5vpCqtxouR5FOdxhcn6E5pbj4FeEdmBRWcHzSgDsQX3W7dQF5GMcRzZ8lVGIbuql6xM+V7NT8tp4h93mkxxJZ1/B9Pku9Pku9MkSDErgufl2/G4tO3RdkwJ4iK2UZqfYaZExgVOmylxxkOfEll1SmwDKp9J23gG6pRgXCQS9N/Coe0S6gHhJLQM9NcJw005XdD/dIvXj8GLxeud8rLDzoVZftli5wJeenYu4OVMMxcqSL5rDMlPrSL5aRUkVzTYrfjMWIBo4PdSBb/tcO2ms2SkgGcaZwY+NMh6viQDQT/97h+9uPqHYQdePJoeJ9h7cfWv2MOJgoRanSDNeWRjzxrHdzNnLNYo7j/W4P65Q+h6Pj0WBQJrHYY9RtHVTjjF/QnoSg8XXU8HZp5u0fWMfgaStA2RjBeGqqs+1xa9BHompaCIFrV2MBqGPDp4gvqcCbQ5jZiSGeq7i6O2CDKdXlLVM7icUwWtTqUzFCt2y8sui2Oz/HK6xTG8nGZwrII8O8eQ55QK8ijozhmngwqic5TaKWB2K5QfVdIvpRs6dsOQ5eizTg6ypwKIp1rI7oCUcAediUgGiEam8If7vIJ/GFxsFVolOSnNAUgzQgaaeQB+u7xWZ1hiw+IGjn0N+88RqEAV7bYHoGRfEggQhZsRdXyaofdAcSG1zif8s/5eXbwxzFA/6tcBa6gXYSHvcTZ+W8b6qAQzV7S+Oj9XnpQ/TrE1N6Q+P18nX75HTJvswAa/psNbA/FYxuNULfY0tyoijy6fM/IaYAGVTGfwIxheNE8dQgnKz1ISsiQvZysdFcLBGHumXTSJ0fYUt2jWeAEM8ZT1r3g87ZaXi+gceT4BkU80mOMWzYvtornXosrpSnB0ieIymaZsuiSalXTP0Bp6ET2hJBkXDq2IIV2oeXWhNDVaEvd4eiK+03WPLqa9eLuQHjdcgKaCzLkCduk8uMBSm3OH6MxjXQGgMJr6KI3WAk5iQfQh4jYbwNn0rz0vvo48lR4GL9TNoI+D2GBVZXgqltMEFT2qIHxMEHeJk+6Ja9xYzj+cG7aakq/QnCWIhzCVLYUr2Texb3ZiUBW3o85L3dXlENvcisTT6Pf4FMi0pcgq+vj43Ld9UnnMLz8Eb6UQ+o95K0VcWPFW2l2FgUAR+F/Nbysn8F369k++7ZO10nfpCyq+S9+GFI7kxxnOdemB1zrXpSdbpXNkyuVl16MEfr4MzzF3o5C5ZjcgacTj6I2Iq6Xv9T0fwpegInwJnfBFokM4cY04TkEVyXigFh0G5MhDbTya7T8F6SLMU2FqRbYS4MGx/EBOKyMNRaohtytYbhHYCgJTAXo8JrkKNhG9iMtYOcGmwLmMnSC5EoBrc6tN3ayNQVVwdQKNhwOvHNF48B9JjYfP+l79ZHFcB66Ij+eTNz55n7wn8siLguqlAccioYhHvVJJLEOLA0eppOqFFwOvXnj14Hp4/GM0Rf3u6mhDTAU5GeYBQFk+Qn0AvrHcwMo+9ko3M+LjOeJ1grUf05NKTmtADA7Tx3uvEUqzitf6Nfg693U1BH0DqgTlYQ+tiDfZIYRSw08Fi+ZUQe2/YOKJbZsvvaFi28a70LzPqU5Bdr9AUlANt53WHtCbAQxDftyLrNYqnycH7QKKavFfGy4e75sX/4Gh4u87ieIfGC4e75sXf9dQ8fdvWvzWmr3cxDP+m/JEyFxZWtZZ9ilzWeKjn7z+IIrQ+xJbYWY21I+z3zsw8umlnj9uaQjmg39fG5a9Vuy8+5gqgj1qQOh1iB02oPv9nmcg8FpjmwgLHxyq8CtuZ7UUBEWVSmjHJYuCSz/+NlyGgcqD4l71GspPvez411D8WjrtKFm/dmEtStM5mQwtDBNUV16JMsQapeqoKf30pXnih4uRn1d0+d0jvzX87JLguSv7c9Mn/tSwKmm9BgKzO/2Pm7gor1k3Wuqk2IaUoZaX7NVolQZfM+r5/GfFGd1LFYC+IahakC9Dc7ovuib2ChFIj1B0c7amSwzAqcqb0n6JQIjjUh0UoXSa38Po6APLBqJDEwV4IDb9ER5xUwPArXiisEEmZW3s8GPR97VI9b4nRWpvslt0WOV+s955qaDnjcPoeeDE6HnAoeeN/6ro+foToOdbsfKNIYg9AXXOzvSwKBT2ssImAGByg04dThcB1rI6RcR/5VoWlN7lQzW28LNoVBEJdlOsDQdzYZAxQq2u6liWMWCCYWNiu4z5umr5+KKly5UUWj9Pv1V33qGWjqULlUgNCgc8kJb9HBq0JMihnse86gr280j9NwLVT3+ngeoNxwXVzyBViN6zwM5NtiZrrD/qpkYmvzj/gO876S1akVZZipa8+HgphC3R6c6T6PFSizmuN5za/v611+znXFVfnZrUKp1zgkXs1PqsrHGQ+V9dyIrK8SNvfbID2hdphM7sh9epm7/DO7VD6Jra1/OFpc5uRS5kykzJ55dNCuH0CyuF9lYj0dTpG5FTiRhfElLG+gmeDwv1Hpot5StnovRWkDK7TdeWFZBaFG/pLXnpD0vh90g31ZXM3RJeXgE4Kv4lxYEdfvZK8CzxZIcP4OZTlkhW5Vixf2kii+PdtW9ldTzsVse1f3er45Hx1fFksOhJXjAJGwItX0ljgQas6LA6lAgsSihfk3wrI/eLbuR+6d/dyL3l4Y3cCMP6Vkl/+qYMKwlnurxf2FYqOdhdwrrqZNyUZ6VvZWzf4cb2nf/uxvaXH5GxvUPSf2B4bN1WRIYQA6t+Vp8qA3sRfi4pqSz5k4f3W56673bD+55/d8P7a//GRNf7VkbufW7kfuPf3ci9/2GN3MkwTx/cnHk6V3p/kbBC+0sbgLtllEm4JDdf0RHY1TQjnX0rI33UjfRH/t2N9G9+e+fosoxed+Ic/dYXz99xI/e7/+5G7s6HN3JNbHZ+X2Lf5LF8QMAp+s+8fceJDQpwGzY4ZQ/x6KrT9pDEpXkeq+J6X6+sqlAdLxQ598/ofl0odJjKjW3cTdGl1uq2lycrgj3iYt0axffNrudoLf2oF0G31efx9JwxYYcscglyz6Q71IXPt6h3kUd4ds0z6atZU7hlQb0hUAFN8/iN44rYoERMER7auP4eNKt/rsLI5HU+2kIL6qD/IuS+VjUIKvZ1Lz/JOXMv7iXB/YDbSz5jZfMZ1P1WZtAxN4P++N/dDPqThzeDLjnuONpRTPhUnHQkQ5zAfnso4Kfc+H3639343fWIbB/+/ARbw0tkw7BPdhC7Ze+ghxt6tgG5zuZ7h/BbGdv/5cb2f/+7G9u/eHhj+7jjcaAQK2YTOE8drKPfknTtr9xg3fPvbrA+9+1lIs9SwejEJfBbPzX8ghu5v/l3N3Jf/PaOnDpPz75NctG/dyN337+7kfvywxu5J55wi77LP9pR3mUzSnnA/1ZG7R/cqP3jv7tR+6eHN2qP51Fzil1QVxOAGgU7H1YMCz/7uhZumRDT+BdO8hmKXP1jE0x7syrNxNhdkyKXxyLdUPZNt/p49XGS901zkqdth4qcuuQS9FCQabEBThuT9LefksA+9aOva704uC5+ccVo4TE+jY60HrWLBctf6O1NPkUYnNfyE8oMN+ozWPMo4pQbfS74kI/w6fyE4RxEr3kcnbngzdyIitkkgTAcDBX1feL+b+Mf2eymybBz774v/QfE/vHFFJXuZHgXzHXnCZ4H/byBur0VLR/wyl4uXW9mr8Azx+74/hpS6iusxlq01EfPzcFzi/YqdG9fKdmmBD6+XLrXmA5F4hqcguwgImB7Fd8CQeoUwxR41D8U6J1LBH0ERd19ltriQ28+EMsc+LusV/DIXCo7+hSH/qn4HN5fLPY9WHNdBHYu9Dmg6oH9hMJe3hXDh/NPKbYYO66zcpPGUxjA3kTGbcGkTbNXCXBC7hk0QbsVC61SV74gz1qxhMnaI3608mV/LwKwIaA77eV+nW+10YI6PSVuTmkkaM35SnPW/aXMLN8Ks59aVlZsx2OuIACKQ8t5LrdRl/OCnzs4Z0hb8524+JBvozDfSdvRolOGbqUW0Ng/FbdSd7CKYH4a7eQAK+7volN5u3c6XjkEkOLuGb8y7QxWoUSP+xM787NpW34O5fmjIEaRzszAQeCjSFTqm4HeHphGHCzPaIzzHbjb3DraocrWu+l01q0/I2cteb4dcGZ+Lp2TP45Lfml+Hj2au/MYBtlj8/Pp3HwPPU5qW4Rs4sFaUMsvoPPLMGu7l+HHU1iGWS5L5yNUPIEW8WTF/Pugix/Ky17aI88+Ip/EPw+mGAp8ThfSBYj9HrqIHo/AvjKZL6EUTy7zfBmq+3upj8CFyLiXIr7FsOZzqV/x6An0RKQ8gR5PF3FgXNiDT6SCi/S7oHgif2crezJXL+XsJUSjBIl2bfge2ocK9Os7fHwNnf4nIfJijQyKvdUiORWZuOS9E4vEjQTtFr4+6nO3pCOPR+TjNTIoLqoWyb1DJv7yIlekvTyyiMcinY/H+bQHjz3AB+D7eXAKcl4/hhI8PRqq/4wPj5HnY+ix8uRLNvI8lx4nT76kiAm4m3boinE67QLinoHHGXQ2HmfTmXicSefwtSBG10fBfPGj6Cx8xzfIhu+inuLuotrJ4X93cnx3cvw7nhy4gVrgBupT8LgUiwUQHRf/dEKcju8RTuT61dmYCvSUVRS3k+tE6CzG4O/l+XAqz4vTHv6coNE5cQ5j/6kMh7MYBmdy/0/jvp9t5sWT6by8NmFu7AoYmStzo1aZG4vVuWFQ/iJaNPOiVpkXdkBDxQMMq6C0idcZV+I3kFtw+m1Pfca9P/neL15sn8UTGAuKJxJPDCC8Gly0z+JJnCj4pUUDEwVhNfai8SmCZnASodRymj3eThfElu2jPj1ep4tm1uhdpjtPlGrtTHm8Vn2hFKmRw2i9iy5EaaNorah7XOzehccuejKw+8kGu88T7D3vYWL5OXQ6UA93RRnfzsIbbsOfASw9DW+n0dl4O5uRnYDs34vPv5eeYu+vFri/ejb4I6D0EJ6fKxh99irX2q8B6xkHd3IRef7YYK9BTHoso22SPx5PEFbO+BigHe1mlHwUd+vc/NFAUHQ+Z4qQh4yoi4yo54MZrCDmYgUxwwlI6PBPSXAV8R5fklMdOkt/qxjA0UjlvBec7JhhlPaYUdol0MfQ4fnk8VEDWB9jR+VxdLoMFSC/mx6FN74xiLdzeVwzDKu57Xq2fpBTQac8r+Afe9sVrqxzOoV28I10UA+GfkjbccFpO5F+1INxzEcp1x0qhVFqwiqaH8eV1pKizGjsfYidvPYSs9s89At8u/U8WHACO3AGxvc8OsOQukdzOj8ew48zQBMR91ikA11CdI1Zb3T7PGRDo3ebRSF/ggb8/IlmPuVmCfJzsywGeV8Dfv4kXKwXnAlpNzql15WrKzwaUlSX+cciorrWPw4Ru9yCj0bxnDOr/vcogsniXVxCu+TlUkMCvw+Rl5VrWHXVf6pd9Z9mk8+VptnV9ntOZjkHRXMswqX0fSXt2kf9Cm5Kh2mf5tfl3tb6aK31EroM3+qCTU+lp+FtH108oRBLTyuF7LBN1wVcFn+3xj9htBDQSZ1AjrK6CYS5Epq5slvmxG57f/4MYy1et4o1/DxZl7Tz+3yxfD+ThqlduCCvVhYfwwm71D5gG5eIz+csPIXO34/QZT1MDPX392iapzadzxvwVdx+pl16x+v5wj8Q377GB6zovmeFEVT2r/kiiI46bq0N3qtu5WkFEeihjbQ209XtP7p/HQMKnWCa4CkdF2JwPjp4Pj3ZWtE8ugXm2ubg+3iO5iGn4xZai2+whQdLmPwHy4n8xD3c7ycfBhSzyft+6gAwCwqfOSOlWCYfphzhEn5o4z+/v6jpxh9XEbl+DmDjL3DHtl9lDdxY6mLz/mQ8WvkWyN0QKrZIfPFkJiv7+7LmbNnIn841PZbm8j1SGwaOAlpmKnZzsCoQs65LjsKZaHzbEXr6QAJFfKSoU71iUfzBufxCVLG3UOp5Pl6S4tEMXow6Rkf7zhAP9HK7TFud9P5eJrYQTNH5OeOFCC0uFGIuqwRmGPgblDwsTdjFmUDulKxz2T7Q/smCqvM8geMHghXacrUgyfmKfKYZu0pk42jrP+t8ChHNRSxyEsW0h5sIo78DY2/fU9wJnUd/rlr7C7wpdlmEAb0CNj0WsY+1YkCHIkvUFbkK4F5KU7aoNGX+5KUpS5ARdVSoMkvzIlTpqlClWwpVuk6ossUIVWCuevb/ZqHKd/eN3903fleo8t3J8d3J8V2hyneFKt8VqnxXqPJdoQq4Zer0eGCMdKX7iEhXmO9mHJj/rnTlu9KVf33piopVyKetPAGewpi2YAQsjz6+gOU82jIqRKnxGrlIu4ztzZhqFZlJuIKIiiDFbUbxCCfJUSgbl6MsyLYYfuy+H3KUNsQpbdqKPFutjf6IpqAZovv07BvQVFEQZGqHKYXW0Jy0JlsT/RZNDivJSTUZbvD7H6utuFKtt0l4KtirnzXx2b6xz5bHvpLorBp9v0arUksl/gZVP2EVGVXEOYGZqjFnzf3g+GaqLsHXqt6+Wt5nX14VgxHOPyhsG2avRlM66Vj8axD/EO1dHcdKgD9sJSCwVgJe8QibKwG1wSRSe47OYMlrT+DW+X/GMXxP1vkvYCfO9vpKo/S7Cmek8YqMxk+jLLWhtxbj97a4qO/vN8TNUOkgcgBfGqVXvrW8wSXcHouj1CZF6FOKBzwoawKssiMmFKcMUd86Fz0UoNo6RWaOFgG/dIrMvvprzo1ZMY1BPFKJmNn3hTT/6we/+fccDo7A9zlarz5LwTEHazbOtrUMSA8Pcd/wPBgUES9kgXgsquOPbfvPKs2ZQzspuCC4PeantnhOPH6uFHAEqbXV1V/YkVsuCO5APk5JxKclYjZihQL3Wy3rN5G/Ix7OOtLLKwteoCPBUQ4Exr2DmvUl1MJxcyAXczSr5KJBISU0QzNr3Evu/aAcj1ftXX8gKOaRu75RBOtr/Bb1/T4jP89y7lj0Qk6j6AXZH1StGzrHihSs5wEGqys2FWedf7AF2aHMmQ84iHQZSJrmtshHPJoYOVpYG1h0+fBa4avj58FasQhIImNLM+Zd/tpXb9BSRncwGAgU4V57kVLOY8bVIFP2M3hz/l49wBLNLeYuVXJbcT+8AEblKXmH5vK69QrVebJkyxjimX49hO3O5X6sE+M8/3YdwdKNLE8eTK6HTkX+eC41fhKujXg6+vyc5ffSHNh9nvMHJqQynOh1LGLrKS0lqcuohIfsjTzMcd+jWLTo4vNkAXtAvDnFG+vA8/4TV4pkY99nf3Lul7/3sz47cORPeGdbNLIHxNxYkz+4jz+w7ym/31N5b0HaLp1zUzBvlzSBGhvsWl1F87FxhkONqgdvTzziTFW+XxvowItDxGKapb3l0MlsbNM0T/uyhGdy5dOCSfxkJMUIBRXfqx08OuRVxt+jDGt0JuMZ9u9gzE+z/62+cChUAIYA9By/za1gyOEbz8s+aBQFaUUTkn3Tf3P29bf8/DVPyD6EpHyGQqQwdqx5FEKvMvuwfkOxi1OM0ZoyrQkGaUSLdwZe8mf5sQyuYAaNn+fHucwq6NmBBXidFtmleECtUdgGKqBbbFfg5mFdUMJioeuRx5AAtLxxaFXhA1LWyo5KN2bYCEwe47En73DSTR7SFHRdRNdy7VBwh0ddyuAeZz97j2o9t1haUVBnH0FJML6f3Y3v5Kuih1m4rCcBW31xkgR5Pdg0tGgbzSFlOy3gAUPpOW0tTfMTbztbqytI2on1nDcmd3smcMwGjtrAHZ7AZ7mf8BI6Po/yU2CaGvDaSflKnvVh76nITwNFy081PpwUaWKQiQ5vOOB4OpZNAp1mApa95bQYW6TYHpJkwvdldJo8T6NTxXUkLT8NiSH2M548juJ7CR3Tx92IwPHPKZyPTuGi1zw0Z3guKYqhbeJf3rOuKa01+FNpGYCVvnXoVJzKxfJZRz+hQp8DfLvNfG2Z72UlY9tph1mL13NPizoNLaFlEH4pocgoQ2keACLlHalimfPHnSMmpwKPwloKXpIKT2YoaSstgTncuSJjc9qJh7bgoZUxPTXPZEyLE41pcQqdcsLhLL6VYZw8hKfZITwNZZ9WDmFBy3ZuUIHOx/t11p7KDTajGSvfFGAYHdRfZKEeksduXm+lgE7ljBUPvAWTzoMe0jUN44a5PGcm72GZsrP8dpDfdAJj0tJO9B614tT5oCejvUDd7DcN7ziDTUuOx1yxhOaDlNCWFf0234H3ZYRICUIMggD8UwKwnXuVK6U7GayIySBEIQix7XgIsWwRYkee0almoi8/8hN9WTFk2yOIIYXBEMW+osSQZdoGEG+nZaBHB47QdlBnBUiPR6dEEerYqa6E36JKBlQR+g/o6awnne8MJu6ElHGqYIgWpRMc1IwBP3Get1aK3M3s7nk++g/wllvQReGY4PvWX8HeQoHP1wKy35I1w8TokpRmH9WVVSNHV1fs2TPyn9X3fhzBrgHg/Rcj5vl9PoX2aRHUZpESFtXDlrB71SaiGttKt5BjMZ4cvWtlpE8avTw5OptUSGtC1nRCXHM8jtlEZwL2zWEAt8PBJA+jw65w+2kfPrGm2EJyg5+Ny3rYkavJPZgJh3cBwg/7Hf1jtDL7E/zmoTVjx6XtQqEb+376ya+/K78+2Ws9lN97MfPsu3Gti2oMnIob6OxPpYxYudVLhKtVnZULAhbkQEJRogL3UFnNOgUqLgjAMKEjkW75MwqyT6DAC4JnmJO2QO8/BeojLCEf/Hv2SaVFYuWuSPDYq7eWTIZc4pK8AYx5Rh5rk8hn7L6FGrgc9kJ43dww/dCeamjNBtcu4v1MjJb4mAM+JVWbElr55WJ/gisW8xY6pSPyNqyOyd4BhZxhYz37lMJJ8nOL/ZUShBSvY76ZSrQKLTtxe5WAgtKhpqJJUDUUfH7NoUG4Ine9eBPbP+DztX1UvMTxWRlv404gu4Ed84dkYvx+z4ckwmDq3TMWVdVwh16H798FHR+u7ID+u//i8wNbqSONUamEow6+MYKwxj7DJKMCOY987MYrGw4T3LV3XZljt5dxmQ4PdDQE7FFlNxGBUEBwebfS/SD7M+TTivse5lL25wI6TuP+Ofj/5VQ7us7DNbJr8azLpg9O8xovjkuDIn7pMxzQFf/jDI2V7F5FZozOoaBIhEZj/WnAWQi8wWo+iBWx3MzlLRGoiL/ngBqQRTQgnRgUYXlXjPFuSGAwJTvhjSJbL++VnUhykGC6PEMaWoQUQkAzvUYcOuJAdgSRR9byENmSfEYaks9Ko/K5/jH1zzDNX8O8qq5xXB/WJP7RNU427MSijyOUrRe8ReLcg1Jcsc6lqbfaYgFLYISzGYEHcbBLiaiEqVO/JZpn6PTw0pV1f2uJURD0WLYXrpSpLTwJJuN2qJIR8SMscqtKVsAn9EC6AzWwHUQbcqttJy3npwR74dCElminLMoV5oEXzK4cgZ1Gi3lEC+IafoErlTX2NM5EEdKR9TSBA+dKsLYm6i+079MprDTWy3dhTcZB6el0OueWNz1JUNDbZ3EGp3IK8vGDfC7+GSieHdOQNi0/ywwE/DahCRgKbQWyVUeDTuNGtm648/eeu/u/3nOxfaJvpuI932OfOKE4vYz+LftE9NmI3iuyIftU8JCkXLH0zPcc+6B9upQfvzo459Vb1t9vn0hBaZzGcDitPCz+sH2iL+g+Ws1hPPAfuvCJPQc/9IV/vv2D9ild+Oi73vPBN/1d/kT7BOQQ/84fuO3A01/6hg/Zp40/NP8HW9a8f36ifdr4/+8/fGRh9SP/8cP2aeOf+kP494sX2yfitQ9QPTh7rJHXfvKP/vOFf/a5J9inFPLF28589ec/958/ZJ+28Jd8410//Fdbf/eJ9mnjP/nMj3Djzviwfdr4X7o/m56evv5i+7Txl0rjfvvD9ukaeQ7xeHpmwtgnD+b3j7PbPBqfgqebHyh2T0h8NO0GKp7OA/eHXKNv4u2Tv/l+QgEP/gCfSJ9DZxAKOoNY10c/q6SfQS2ZBrIFeAyjcJ1f0xDPs8Cp8/NMfmb8PIOfu/l5Nj+Jp10ushVhIh4je49riuj5PJ+d/ifIGut/zgwkUIRCzYb1P0+nOgvRSD7kYGaDs1TX0GBQZIN8mtPIpvF7RtvBkujp/bl4SYrHQW30PBWpol1MazuGorG7MIowV2XfS49TtdFz84iPyRPMW0s6ao50oOQq7aDzORMgcm4/Q50dnMF1KJczuG1UUAi1UVK10UgbkCeUS3MiiqTllAi1V83QCLArzlXyfa7V10zApyRlA9zGwJ5+7wIhYSr2UjiC2olWMNFULmaustjO0VaaekoeyUFZvpUiFds2dOVrCpOFVvpWFHt95PwqHGJBaqLxYMv4QrbHz4jNyvMTArprKQHHdJBfYcP7RjyN+eiAW4zwchE/T4+Yiog5mBehAOzHkMwpHPUCFNIPVvj0+zz/auH/gtXz/FXNyQdUKzjmeQ6D5DPgVCleNQxuQ7nDZV3Kd6/qAUgei68c9QWN5UgrR5qqyjbEIAAapybN5fyfQrVXLm7I0XqPa0UWhan2qwuWUb7uwXT2MygBT/eDlICneyol4MOleP60IZWifGGlvwDuQ/NfIvkhv5RZ45FXOYErAmlNkP2NfrDLvzoHVBvn+WfxAwJQfiRYmc/zL0JQjyf3SPBLCJ4rwXsR3I0g7qxjz4HgA4jdKcEDiCUJfg2xyxK8H8GuBF+LDHMSPIhgC0EIt40lh1WqC5pmX9Smoj+aiFg9fdUGTohtlDHKZyeMbBYF/zqcjIIO1yaj4jAKxhUUjCwKeoqCGGZFwcihICMfUEYHaRWZHNZ5FE3GOogDsSNxiBYKtSkRLTCIFpKniBYpogVAtMBsRMYRLdCvAhYwHRfRPEW0EOWfANECCqqI5klrvCqiBd+BiBZUEO1LjzCivf3kPSuEQ54VvE08KwSjnhWwq7lv2LPC626oelYoj6MjbDX/jXwr/NQNx/Ot8HqkPkwfBIduGPVBEFZ9EIQn6YPg6m/VB4E3rF0QWu2Cn+80fDnRD+UY0bsu4D9rnqQ2tLNWacpTVZqyT9/26tseYOmtLLvB84Jgl+yid2ETjX0ag7m6Dc9wxHtBgDXvo5iVwImbdG+qu8DYiZf1Wk18weYfpbqjpaKOx84iEVs1evYtu8QmBSgW9LCO0tNbB0XrgoBQLqWDIjWFU5PiQdEUWUxXI44UTa1yj6nxZ3WfTuYbpOKhBbepvbam36bUQEyTmoihCSW0tIRYS7BNo9SW0NISYoonlwAekbucWCGRP3S8qfIFSHe9NOWxmxoTvsAgoNgDFID1u8KeJTQlGInG5GheHXBDGwFkysg/wm2Ms59DExQHfcrWqjE1bSTk/ErjbwWw9fuUWmOftjb7tJPXSaQJU7LgTEmLi2nTZtCjp2OgfbS6js6+CLhG2ZGiNQSKmFpY6gS8RzDiawNqrVcVQlqIbq0xJpQfPlvxLj1cpGXnOUvRBAQiSoe70VzTmMkQSCsQiEYh0DwOBNDTPJF+59OpjDjDpAGYNGiaBAb2Eh1sOHIsrDoW4VOk2/Egn+ExlTkg2JTlTRWYxHh0x6ele/3wdbAp1AI0U2pS60gxO6AYRPRIMTdYu5VmiSPmiMNFax14PqCUJ5NUu0YzRxjEPBCHra4KrvkNA7dJkXRW1TcgAR1Oj0sW/ll4lV60KaA5rkB6sYahgUXcNjcmRgE8NqMjE4+NzC4L3mHtmEafANUQL6OA7wDw0DgYh/lFCvhEJbOd/h4xQ5TwJxFPoylVFwyIA4lDAmloa6yhm88Ekanp2E5rhdyOiPHfQ8ldKf5I3sIzI1R6JE9pPm+oe3wo+IEN0GnN3b56RWgTIzLPBKrrxOHncyS+jbE+UsS3lJoKQoQjKNIgfe5I0R4wyJvaqwzF8ARiJBgZ4OEBbFEbKKJ5TzDYASYbo9SaIz1zlEoEJuAoAWoehwABWjqUF+XTOswMF2FkQh3PiDkWvfKItHnqkLyKLFBZHC3wL7EMStClKD79vFm7AmE9JAEzUDiJkJsA2q2cHMq5WRcAWcdc7C0ay0uuZc1+3w+galcuxmsNp9MjeiA3ox/QIxOtxFuzW1GERqnrybEVQXNqRmhbQ2VNeQlNBe3HcamqtPFbnkhK3mDkbgom1cvJGCgt8bVGbNHyqDQorYuZT/x3Za9o6bIuoKCUI9KrtNKb4xVqyorTJkwPamNlZdzBVr0phuNQcsQoW0TmjK2Jntvtu+oZaElwcA1hwkFhDnGyB+2qb4sKZf9mrSPgQFWF8q2bq1D+q6pyvvEE7XjDI9+OjNuRjbSJqm267QRt+u3hNgUarfykVML4UVpp97PXIbXw9+2WszUlHGgtBG8/+6lT703Pmf7QmhAXOGDIIzwIPKx2KED9c3j0E+0QVAEYm/qeMPD+3mCvQJXC7BeFha8xtQ2BdcinBILPhXNM8LITFKaf8EKo5eFPgKROeWVSYI+s7x55EMmH5Cl7jNQiBqZTCPK97/0f/PSf/cW1//MJV0JYRTHjvypkiQ9fdyKLB29QUI22DHVJobroKtsTUb1SIjIoJ61toiivq84WvteeuRNfgc5DVU98aLlfH0ce7z7CKrE7GpTEDmBmIUcAlCmXCawCfvnGrFvk7BxGFeWUw0W8VkhnZRtxBAsKSJ9/i5KkOgAMPlcKpPra4HCRrOV1g9/JkSKh+CpZ3EFt9zBVanmA1p01DlKox88hBDH4u7J3QbCXMaiBIanzu3I60oAmR8Rg9JGpJmwc56MQ+/MN9A7F928EYXF7mlT3NC0zrEnRvjWfkisGqYwsSkJYuXQiTNiIoUHtI2COQpqiiENdtPRWZM9MFm5RqcOcl8GjTpQjE8LTLRRD941nHnnFG2+MlRdoKIWnaL2I0Cd0PI8BGJMCAFL50QcFDHXJrpDi7Amy10fYgDxJFZO98o4u4M9p1jLqgaDwdDh0l61rFrZ4GDaM8VqeIJmM3otpUISidMxRnkKbGrL2dKrDl0CtzQ2QG8iRTyLNOnFMtQsqW95shClFppRaJhOj/L+pUOYXvvOEMm86rlDmsApl3nvywIqqwDpa2wRY4QiwLsYR/DCsjkyGlYZ1IQTcaBLcwv0MOtFKjoX0AHIVuIXHgxuAqrAB+FoKvkQfoT4At8Fx4bb+LQiz1r6jhVkPs1NvHutUVO1UdJKduuJb6hQQcrhTke3Uj/lYHqH4Y+VjKhrXEzRdFiJpBGJ4J2z5nyda6dmAQmy8bpEmc3bHIF0plqQfioPdYIji+JtMIn+U4uBA6f7hWfSWoVnEbQcJVaHAvw29uf248wZWnx/uvDkwhmJBFcWCk0SxF50Uiv3ayQ8mDDOb0TzykZdFEwZT8wTQ63MDusZ5sVdd+4jvhvN9Q8Npd0iR7pE2GdD+vdc+V+wlfXsH9jeOO7DvV4L4A5uZF0dR6KEM5z24ywxSt4JxY1+X+FhbWrEajpxzK+kH/SDEXsCaPMcIl9PosnatPDAjnVg4FuY/VpGStcEXTooCHM1DyFk5FY9xGh6rHAofPQ2QQ2A/zt5Ek1a/Bq+oX+pdUy7gRXqQTzVZNjoIBIqR5jX7ZSuMr8xx13w+jsT8RnX8V87vxM7v7FfwufYskYKL0DVorCshGhRWG5TdoSPy5bAh26jrQhxL6N/4DnFUgy8EVBWnvRcqIGsbRd1pW+Rcv1PSyxvlG7EWZR3/502ewU4YnLcEiq1SSXVtQI31ou1EyHqZKJ+itmoD5u3sXQpDsJ2QfDXXaQr/rbEMa+oWmir3YwOwlo4Vb0O1fC7v6P4TSq5dfWQUGFasJaGuzKkpQzCzX0V1/BqwCLBo49GlttsuTR0pssER9G6qrIsjWdduvZjhrqxx21XDAhar2mMNTN1XM7ikNxisU0bZGro2vV7ZiKEDDyEzdrSpKrfRlBsioIcHQ+tQnkXy7Eq1L0j2aXaF2hrqmFDLlZ23KAUSpEZE5CxzoWBWMIUDRsC1Vt2/p+/wvNBRAXexVYVnULHN3g1I93WLE0OlL8GUbjDV3y0LNof74qihIfnFcXxGEncWNSYuHMvU0LtjHkpMIKzN3iPVeNibM9G6sBbyo4FiY+ea4NHVfTa6ZtYPr7yHPXzsk447M7BzDZ8C0D4+PSzd8KpK31gQgHFjDMzpUmKf27D2My87qFt91Hp27c38DphnG6giTT/vBaCF0bUVLVwdUZZXB0rQQ+OoQ7ZsbgI6+XBed7GJTMtIcUBJSgUBGrplLCep2YTGlAz4IcflaxVcHBzBnI7XzMaUgrEM8ilygYDkMWeCXhROZDjCw+TxxA/Gf2fdDXELkgfKEAiJByemMhzpqB8gySdxvJEVIkjzoA0hewS5XYBUFRWhqLIYdTNYjg1uslv9drM74LyOTUB5vuKGj9xGbp39mhJp1Yf3ZGh/yvcCbrn4+yj8C2sttFAdf8iqfnat1faMMa9Apd26peEZhqzSQFnDkRN7TI8LgdCQC0QolIiWr4tWoBrt3Jb3oi1aIH7Ak9pv+zV5ZL9u7uBz+Z6W721WfurckgCMrjJIzgKUdILKtD1p+l8wkLWqexR1uOIbUSNgZtZ1JCWKcOSbqnwZHhlxdWCiA5bgE05wxWP2og6MzyNTPF5XPe+lin8oj+djl2f7FzCzn3T0xidcB18vpwfJ/6/tocwnPeZaHPihLdOvQB4hMPIhYNNNpQDcgeH37HXXG9zJfkqJQPrfHg5X/IExrhisoGOL8TbCF/cn8cUFPryaeeCVh78BA/s7tP9C7UrPNUtgzpay39WJY85S7lRU+Ssv8HEh260dw/ev52Ri55HS40wd/4SIr0kK4jy9qO0hh1SlYkuwzfipgUVEyqSb3DED+izOjOeyVnKRQiJT3aq5om7diaMdeuM2EX7T1+tR5path1tXHtWNWKp6+eNCzx8W6/oKYz/7A3yqCZoqI+Tgnh58hA8c9ALxkhwncIbcK48ZftsdM6iAcPToI/DBk4/dckIFzjNRqJ2JhC2Pmbt2HHzELnuUfReOOxaO2zsOx+2BwfUcgwvSXnLWPhRNJrHTUbldjqk2sl1+qPVaOZGovumPbsDC/eJAK9RxjI0KqA4FVwvvQsn5Jn+uC051sxVKqXiE+nC7aIyHOtNFMeX2ArR2fE/9tkcUO3QttDe/MNE0wvng0hyeyQH8ccdUf3SCY6rXYXdtjSpg7Sbf3iTnxpm5i5YhcQ9+zt2Py+xWq/V33I2y0PjbUoUN5FS/whQq2oGlqKvB3yIASy+ZduEemtykxljX9c5HXDQ4t3iPqtvmeBTm4CB9tYcrn+Mn0KuXziSuOQdqkA+OWY6AgEoTqh+qWZidD4V+y13FIkf2DL3zVJwgtg8Cc+2/TppcJLgmh9OJWJ0xYy+Gz5pm3+TJ8GOxq6OYFIOEEHRSdMPcx0SBSWBsihIpo60M1pQqwEtJneqVrwylJNTBeKD+AluTPMNYZ3LvEwpYojPRxLCYnLlP2CEZ0EbUhB0FvS2moInw45egDQDTwDqLdtt1q8zRVvoqoxZVGgezSpQqqW5K86axd6JpPjLJqIlTOk63p3TYVwTl7cI7LhpIB1gC+PHHX/fsN62xe699P/+JpzzlH6b+20Xcq8xQfb27F8H2m/d8pf3vxMDg/AJ/DE5fx0/VZVWrvIiku7F0t8hUWKcP7aTpcsxkB0QJXfYNKmGehU4DNXTT6Y6TF1a1SlnVp972ybdNOOtAnjFZ1SeRl9vGj0/WnLTqY5iG3Gj+D5/Gipr91qaSqhc8t9/6dsupPn5cOdXv6U7tqVVupGr2KihPmwUrMdcdJuoRsxwfux2E2w8qSMEAaS0V53a/P9m5HaABDvXJwsWi/rBaf2jXaJA0UNgQn5QtoEjiUA1Wj024Mtcqx5a1LFf2w54/Lq9zK7j1Ys39Z9wNRvz7BcO+BZ3k7mEKeH9/jJVtVTnZ1hgju7tkZMPsD/HxifjW43Y3OfnuAvGq3f3Cv+UENOJiXTUDXVMDyEAQoSGs2BoKzVwxkzTWr/Cwb+GkwzYzc79tR24nP3PP20xc47jlSTKba1gk1c/0NLvwGbi6u4WSGkoDtIP+o/m1vztnPktV/jAkT1eU0B39pULUkZlTjL0CvjGUe/wIVnO0ItBoP709CBOjwzLOlaFZTjA0eaIA+RhcmVr7D5Sz+p/KWfV94eCedCP8HZ+PPGoOFXfl5cpShEbLJxStAFYgmao4ebXSNkXtz6A8Rb0WX7EqkK53uyLUyhQGOG9ZrboiNDQ1ZQQUnsJv8MeiH8B4DK4ei3XeIG8DYmBZ0PxL8xT1gknKY/AGCtnhC/jN9aKl4l9ZarXTav3Ep1b2+okpHkF3rsogmItXkQ5GxIn1fuhUvcGLui3Zqz1P5WlY+Hm6OpH0ADzbvh1PekPryG2/+/jBVVZZ0mY5xlkGeVgx+ESBsIpe1fBVEQ3AVALjMGvWB4UP8K8V1aK12envRLEvFiS4RY4lPBAqTyhEBWLB23/mBhELMr7eDglh9r9k7vQhaNDEVPmUA1IVeasUwsCA8ihCgX2zO8N0vbTXZoWvq/7HZ6978BefIEooalBOjtX243K5yOZw8yhvVDKOHhs0cTtxw8GP6htH7NuH14ZOAxRHpVVAUapIMkVZetxMwNrFg1EzAWtyXUA6srGO8OCI2rjASGbr4+JscFk4dZX1U0GnTeh7utqqa1Ur8AlAihrgy0LYMssz9I86yhRY2y0R8SOq2u7i/9DZ236idvCie85/ad52RxMt2UeklWaN6NFPm+7wiYJrOU1TeoSqMQPtZz4tPc1nygIvPpr9kuD1tMufsYE5zaAnA+vFNLWJ/5gfbpcJX+Pabfg/7b1SFboTzOKYpnArAwYxxJThCO5YQnggtHMqTl/jq5wjqJzYhe7EzvDEoYoBVDQQKUfomattjh/zEbeCdUgHBZk0C148PXHTfMxk2lICzYKXYOxQLtjkUC6EFAG2IPmvlCKEY4dyrmH8ibaJs7k2hSvVMzg4bL7W0BYzuMFAMRS0ZIDGVmkO4o5kf4FvB8c3+oEGPSSDrUNHFyGYws+Psqp/vQmr6qsf5g/6UWCWNW0Ym9sYsxFyoDH8fm+jD3GySOzZPTUu1DpSILsBjsWi4vNY9TeaK8aMxRq4W8QxmqylK4Rd1N0NpJb7wyIAovpsBcQZZNFFa4Q4mdc9bKQiBnWj0ghMn/kBqvc28pDqeWAXTxAlXP7cffWGoTsUViyWGH1auz8tIrVDUm2Kj0VJZ4y0CANwmx9Ccgbajoqs9ZUaeCw8AUoQXTHnmTggNXDkywQfSU3ycn/8cLUFwrJS7qBB7nyqoykpGphqA91H1LoFDBnzNG3MPhX8RFyHrGAxNfkb0ZBEyfzWPyCQ1+vmMEDMDfFxY9zH0bkaQm3jKDiBSi9jqwBCiqwyEnq4IcdkRrOGfJ05jfTGR1jCaXngfliVTt19fOnUv1IrPnuCVvzm+EQ74I3PtL3D7wefVJlpB146YaZxbDnT7v+t2qSpduB3ajrXDvxmbeJkO+BXJhttPtkOXTx4aJPtm7VrxmYbFv6x2aZLuLZlfLaRmW3v0tlW5aT80lk8TM1xaYj7ds46NHRk1sXlrIsVSWI766IJs+5obbNpF0+edoCIlAmreLTZtIvstAMs7cLdSN/teT6YYRaaefteDPO0P3mjHvvWSmNE62X4okr4sr1V/mRisLTbtc6rsXc491DR8D1VL3s7WoIhzX7Kag+tH6GafKIbAI4gT7GEE25dfyiqd/6Q6l24ieqdN6p6B22RB4ZV7/7Sbb7ddjvCNP83Ur37q+Pun+/Rhf67oDppUD0sIdbnxoRYflVL0T9JLcVrv1Xt3nBY4uerIuzD+uQlQWgXoQ2QYPS5/+NKuI27whh7TTeTReGO4SzaJUCX+kB9CBZ1OTKBdLsGgmW06AJhFUDbxUyN3izsq3j/aVVRrVq521RUC7cQwKrNZbWPbGlWd4jLUzMxqrHG44zS/1ZLN8IIfHmiL7484Ytf7kVL1wUvHpIk3Y2NTlUesOHkAbJJeAfeVRqgSbKDeA+CqX5x58gXH3Bf3Om++Kh8YdgdLNb68V0jH3/MfXyX+/gT8jFYaLkQiTJEgESYqAlCywg1EOoi1ERoDiGpMkOoJViPUBuhnRzC8yx+ypHSFNiuUkmn87wio87qfhg/nEaVy8XM8/JZGWKkz9H0/nwer7vU92mQ+8bIE86mFiii6efD+SbNPI8fM6v7xdoKv8/up/pqsQh5COjFInVoHiQv75APFPEtnyu3n82o1nAc2cWD8i3SuXypL8BC20LqrGR/Z8zpZzBPMru6QilqFPN1vqqEHUP+ooOgfFpE4N86FIFCG4NQSwCLvyrEDa2JON0dRKbUppmVvNcXtJDMmN1/j6pRrETnbaFpSCxm+6AFrvJlV3kdtbozQxj1R3sX+XHtioh1aubSHzgrZViphb9Le8iodnLrYkmZ0hUcMcoN+ynu/gzIoxnYAvazMpiaEktb26RI3IRXPgnRoVxsxAc0g09gJa/YTtsqpoGjfuZsCG+nrUNJBDhh8ArfXGCfAchmaMECLa3WiAYQzHRV7qd0Knd8FrU4QnEHPClP/bTS7KXGc5fxY5E6yC5sClnAEU0wVsemGFz8mLHW6GGqUBRMHNEltTa/aKBYPRIlquc+KaKTHrPOkG9ArXwrOTxORmyFTQH/dSIQ6Lda7FVMtxqis1ZDlKcYBrdJDcr0m4SmrXOs+X6IP+Z+m2p0vqbkoS1zVebiXF+VErcAEXF+Tv7z8obi5YxQEQaH2lzKp5Uc3TtCjj7jyNG9jhzdg2Dq8N3Xj+8f+fhL7uP73cdfk4/1ctqCfnjwpuEPH3AfapJ8eCOCaV+aBOqyaqadVCO9pgUT5+/V7i1ieQKlYcLl8zjN8cGL2B9B26UgGEgQcx4zYMrmOWAgHFGKQ3alCrIjMWq+1YGlRcyJGRXbpYhMjZEQWpRR7D9QkiilT4JueFULDSofjtAc5NQJ4mNSSgdAhWdAhblVNIOrr8MkUkoqOlK/jnukN4pv8/CkCKPbkQ7xNXUPlXMcKBlqFMDlPQeLZUwFQ7DyacQfAMyLrGxfMTsytTCQL1mR/VswQRFsuxgtDAjP3eZJ5gmjCtP4U3I2z5VnNAuMX6Z5JWeLQs5mafHE5Iwft3kMGXHC48gaZiZ/PpmmaaZsiJxl1MEWcgYXRVAeRoliLn8GU1Tnq9V46HE7IePkQkjJmIQzQ8YWtLnUdqRNwkrypkHRpmnhUnW8CXOpOG5qObBPO7BPDYMdWMu1twxFS2lZKFoFBovwcWOo2zRNjVM3f4yuTeU+zT9MusZUq0LUAMCoAsBFWuAJGAGALQCwJb0GHXdoOO/QsKU0ud/B8Zfgo4feOMD0HGCmRwCzLPiI8zG0CX+KXVNSZo+mGRKT8DTfCqC0aAp2dqfzCGIWeIOYnJdL30q+YNQ2WqTIouYMRldRiRGUkY0QUzMx2y1HoTavK/AD4QGmbDVYtF2wZRYYMltiCOjWRBjMjMBglmHwP9hB/cOZk0AW/DkWo0czmJMtLOGLhsMLwNZRZ3RW7lZvBgHhhdSjgb5k6tVAX2riEIBw7GPmZb7diK8CPWaF4F4ZDcizPUThdZQdidRTgdViwsqpwEzttNzLgNxNGt7NYaLNpusUtiVTJWKK9WKgroN4uvl0BKjnadFMx1nBtXTSrGvJPB2edRHjW4eU9BP5OvOi4Zm3OebMVhkJNF95BywGKp/KYaxP1zRBITflps3SV8fSx81FHmA/2Hf9YBbjzU2cMcOzqENGIa71EM06D2cF8bteOzdLk7+ad0BCwAaqCRu7NBpOeg59mTN7V2oii+xfS2uAf+MP3X7xJ2nGBuZATAdkSDM21EOoyzROmHxzpBO4Ix2RhTotWJXO+NiNQxzDichQimPCUhwTUc2JY2RDFmxeS6i1oE3DOq8s9vH2y2G/fBEhX0XnVS7pV3VeMWkicYKldvFDUbHXRygPpKlMxui86i1KJz6BbHqChOazEGadJKz1qLGIx6FtDyVVH/gkoK06xxgmB+vRs0IUVHf3gBJMobBSSazy2BrFUkkVvtjcK3wDhe/QYWaMphiIOiVjmG9TgZhXPkJ91MhXWZif3TemVqz3aMdA7M4uzzvpS7QVv5W19DVL8SJ0+XFvk3+dGdZhucXNIzz0a/GuPPTNjoe+CcHUaD6MfHGb++J298WbEbRyCyMiGfnwHe5DTVIRSflhKKyGlTXksZU+5PVSfJCUsolGKbloqqDDMLatUo7RLiUfU6W8o1PKQDIBJELTVdHBjHyk8os53hmhzVW+nJrUJp+mn1fMr1LKoXlmufcXC9R6XlFbVX2NaVBSWsAO3EgzuAcxUmKVL9wh64QvGyMJ1vR8qAbqJDt6VX6eczKGGug6FzgkY2jQtJj7h0Xa6T5GUr+xcoa8iSokPk9lhiK16Pbh+cU1ZItrSCz0sQZnDrJgJdQVd62bsAhLvMYewHRE4GrzvMI8L6cU0MKfTs7aiphE3KIezxaJ3+vgZFE4OkGtKqNQM4wCEhEmw4bUDJtAJlwz7EirZBKWVCSiZsmo5riEJeUbalUmwbl2FibBsZ6JgTHWfu6kMAj6cjWHyYSvEAZBw5eDQbDKzl3LIHSNs0gH76aDd2ME3gB0SnUDLbk7hX39EIPQAzUR6MWVSPSZGrlPbQAUHCxZxoDiEQa9Zxh0VCpYBTahZawYY222WiddI2LAJkVcWenMmxUteP5Iptzz8mXFK5U4csORUnte3n3osoKHISBYFqNrD1tAUKPuBAFBc0RAMA16O23PK9tuD6J+M9pK2+c40NUJX6O0HItaRSxQV7AnOpmngWjxkFigDci3afpkxAItFQvURsUC6JU0m4nSNIgQt4qmq2KBGmrRgotWRSyAlbehd7WZwGIcW9Kf8h6fEQrkXcceRg4aM0BXbMTEUg/mt2OLZ7WVE7GelrEZWzQfbXl41GaRuvgTWiNuWnl/I0hLc8rSxjK5GhSPkhlICWoqJVCiIUKylu6QdQRrTkoQl1KCpSEpgWbKaGlIStDCJnda1dl9jBnVufRpEBo9L7Z3KiKaw5A4olKrEBWQFWktbSmFBBpWIUEXW8AuNa2QoKlCgjkH/vbm4O+KHGTOEJ2UAcaPaQeB2BhDVUwfJ0YqI6hGCiHqKiHSKzzTm5OgZIQEKf1bUUIk5/Q1B76YmmAHOKN1CdwsRQR5RUww55ByUamoigmaRkxQxcwtDjTdEdBEipltEQzX8VdueGUlA4GchKkqJljEXjimrqHMUd6amHdYTCBsj+Lm9JCYgLGNpitigiXLFOhmrwrCOUqBK1sNHi0Jvqg+bokjE/s/PdL/Oi1DRNB9eDOySyn+FGRtAdi0Lv1thku59Mc0/a0s/Y1HfOnXW6Qg55xWXf9rlfV/s6mqSigWLTmg6388cSqmE6biHMVmKtbNlEs3Wf+nK5GU5jVMOWCaTDtfp11teNptjjN1nXBKlOw224kHOpTRvKwFbtuPOddwc66tPnspUTlBQ/LEIBnU1A+weKKF0zpMYPmcnKDHTdCmigB2O/VUTqBrFeQELZARCEMTbZ3alLZygqDiIOBtIZ+gB+xsbPINPyhGEHSR1MZmiMgEDsMTSozyzEr3I+ShWQ1qDNZhwTdZVzV4ZzBYgs5mY4Kbz6FEXfFXT+mPBp7dp8a+j38M/+67GB6rRVXpMh6pfV9+zl8d/LX773niVRAYxGIfr7WxfhgnPZSKS+v2xvptpblDXPWTi2kYxCmEdDpFIgaPxKe36Eyj1eJdPSYOEQcSq82VVXSkruhjHPo10ga9gKt+IKD282DPBSPqVGXVAWbRHNYg8o3a0k3WWkXnaZBBqaULtUEi9uazb1ieCpq5jChi/ZSJowyzYAFAyBEOxAn5VzEaZEyyKGpzQaVO1KBIXL3Kp6JqUHl7zf2bqA/TxURQJztwI/CDm0UPT3yE65vHE2hED0WgcXyRhhMfvWWC+Cj4NxcfVa9MR8eTbbgr0//ghSKeeKlRDwTlrUxN4cEieWZQejo9oLw+rG4JImw8cdbPFzIcGxIc8dPqmvQTuSjD/eEizoetU7t4wLyoXTzkwixEC0riRHoDP4ImlYAmXZjS/eTLVUsEePvGIgFLsxuEgRKQqN3W4HMAahpYw5g1d9/lS16gJqGsVCYodSIVy7gNoon39dJA+Nk1ko2MEqGYqYXsyfR2MdX3w4DnL1zFLhMhiLqsh2zJSLbaeLZV4J5cFwIZKKdFmP2zYJiX/Que+PgTHtDL4zbd+jKdRKOfPICs2YP4Rdqh0hDopwIfbv6t/mfk/DrWYfbmbm7+BF4iYYjfG5KnJv7V2gzV+7ug1bABBOeXO/0VVA95uiRlG9dLsynIrr9RGp69DzFU5+T7QvFOg+DdIZPK5+NmV10uwvGDq/O7NhFIjvJkHoZQl8WsexmKLAIsFdxjkRb9IG5kYFI8AB05tO+BcCW7ARkR33+tvyJpGn/0eht/YCj+DRKPHSoQl6FR454rj0YebPQCv9EevQcpsRdNitztIj9SRu6cFNmd9HlrQmQZo42s8/h9S1dM//pfUzvvvwPxoObvIWd5tcyZ6vXxDfa1G8bwtr8GFvG2H2vrBaaJ+cPx/M/MQfXSP/X84duGsXNg2j8GGmuFL8BEDqFJ9QcCdLlLMdDvF64Smr2s+WCaQvNlNl9rKB/jCxe8Aqbrtq9cf5CLh4mCGOh6I7BQbybf66khlrv5icK6FwR3cRCnaj6G60v2JeOXBzyKq5fzfj2OoH0IszBBVYzsaQ4ZG65Bb9Yc8zBBljE9stWNfb/7Gxuvi+87jy/wP1b+/enFa8YyycagzwA+9Clu83rFQTK54FW9Mv7QXnLBK3sP+EUAonNJTy5R1r6vV/joZGld2Qf1xs7OGIYKLzPjWY4mBlgsZ7yIvMmGaILnkEd4PoM88Z9ay16uNAXk8GrU+FTgnEylH9TYF5Cv5m0u1284TQ35kQefVgogNOQuL3uFUJO6Yi4SrNUj0FqU3nJGlHwgnV4hwtd3e3mipeSOM1IrFT9YvmevRAVqhAIpl2MlcvckI8xKjn6q6lapr+e18qjQrV0UuTtsVee/ah+aatpTUc/EArjv1lvw78+YN2xStD7IDkozfEUS0eO8DWgjjt88LN034snvB/D01MvYQV1UPHG2/2qUoJa5ztLbZYEuQqlGZoWCSSOlV63RKMyCDC22pA1V3VNbmRB711hsve2Z5vvGRkCqTZZbsJrzNTdqRZVNxxc8H+cvlcmvk1WWcKHB2Wvx1RIm5enB7vODm30EdYcbHNQX5VLu98xLDcuifcEaebuvn/PiseZLbDePddrfzUkwBvYZY9LlLl+sz/+3Z3/+tltuueZDa2xO8gOvuuvnf/VPbruIXBDs9TFfCcadeGISbPgVcnGPXyEXX+OX9HAUYokPq8Svqtl+du2oL2a3jPbqLU4uO2H2+VzsRyVLjRB+j4ZFuVWDotyKYNqXRDc5RZsPUbgmlJUTtKspxyRzoJN0DqRLR+91+BiASmEN7Ebn551hWATltmLfA2/98p887ceuuJjCHhLfLPiw5q8W0cYYiYuHSFzdkbh6lcTVHYmrD5M4sO8hkzh+gsRhOC2Bux8ELj4RgWOwc48A5nIMwOjhPstlbU+Y/UN+HrgbIAf+n73Z62+0FtOyQxoUI36BxPw0YvCpzoLqyFZro1AKAPWLVceaPD0ANWYeQkvqdE9hRMqhoyhginT5wmzuAnWdK08sH7rhl/HJAzcZAx3OnzGT0W3qfrWe6l0uvYskN7z56b3UuqWJSg6cIt3+x+DQ9BbD/fKEIdb6Brb1ByN+5+cBPD3Zph6KVJIgLqmaCIeqRh1ZfhU3J33QSN7BgzYaZrUFG1khk5qDqLtlGFa/6heCAvZk1DSU9Qt8o6vNkoZny7/P89sURWA08w7Glp8ZxRssUgnyGY74BFcZO1eromMiBN/USyHUK+QIhyPW/JXsp9GQoqH8LToA30NzFOEg4LaIUuJw/7aIRwgZoYIr8RoHFhdxmcZpPo07k+nTG/E46lNy5JaiifCGhudpnppX9tbE1Vz11vWVsuegpopHxNRPMaf3SSpbekEvsIMo8na/mMczKRbg0iugpitQXS8J7wahskrWwE+l+6H4LXftGzQn+t/8Gr6AtwkMV1OzaMamItWaQRGzejldUJTSFZoxLhGos5LLwcIKCsNCOsfo6hh8NA6CDXzHORT6oFGzgLEY1VvOFxEv1vWWocmoxioEZrUCNnib2GpCcsvhNi0MaH4dqDCD6qBziPpu++L1R+985dff+A2ueBMjF0GCo4ZZVBvpcgfcwKZjNOqisZjdJuYjZczOsZju2Fet0Rh5VSwBCpb7i1f7IeYp/sbtEYZPuvXdn//YLe/+/NdYCJDw68dvkXfIBLDriIDmbneq3vSznzloFiR1SujrhTcxrCFnmGqXC7rxQ1cQwdgof9QQe8/IqP7WTLZz90pJNXHxCLYkZiwbJclsYaKUtj2l7be8IcuEnbSfGZOUfvbJG40rVGua8lgcBaV/SwON3Y5keaqFou6YmU71wf/6LCesK+YqxYXymzKqsK9VJJVrgdZ3/UCZk7ozIeGmI9ozOMJmkA0leh/nDilc3SjY5Gxi1sbLLyYXZB9ZCUgZ5CJurqoHI+G+CW/LeVOnQkqemoqOKNXLYs3SNF9LGKacH2oaus3I7sbILy2dVeIozUO9IYWLT/yu3oGsQxMDBohA8ejgkeUZtZRefhWNFTF3YzAYgYExl3L63gFNrcOXotsmkl+RAaNSLBtQk5eeFqH0tEBLaRz+bAAC/ukG6zyRpzdgVVwtxEGRDn2BtzqOYysxrQ2mmwIGCtHi1f02AiY5SuMo5IJX9ZB6eLDOD5/4D/RD1RMY/jPmypc54NcVUJZxnMbURW2FpkU4Xxcq2RTaqRJ8UES92QqyqOSwyeQUTcOHJWVsUh2V6bGKqUNXciXgShu7RVvEvmhmZWOIcU+OcPvFoMoQTfd51iE/Rsd2DKsPJDln8fMsw8lzcLelLsdCv8M2Xtz9f3fN/EnX8/Pq8/0fRJn9T9TYNx7oRh6YpOx8/xJJulOTlFtk4qcOLH4w+5NXCe/ClRWxi1GhCF5l2+cEsjLEqspkfdTh5RJqAqYpYz0IkD00afc9Ro8g76hfoH6GBfyaIuuBwsGuiCpbFh28zpAHgM7yicXcLQKzAzee0+cFMABHQ1mPq8fSNfemYv6BmEkn1rYhj3stmrmFpm+h2YGlBBtsoK9l/NurfG6Wlzyao/kjnIsjoS4q9lqyNgYdo920h2i17OcAMDHS4ChfopQvz8hnMJLPU73/8lfhkuTXbhShIcL9P8Kv9LaXvVEpJYRKc9lf3igvDG/9HtHZVzWS1y1J6f/xq1Ge+a4EhX6rY2ky65c68prQ//MD7tvM4MRnzVtmafT/MKawjNCFdAvVtdszPyyFL1ll/3RuZWO1k2rSDg/AKTEcMH4G7CANsv+JlukFc/Ky31DrsbX0//G8iT7nPAiSApyYsWFpEZZYu/vLkIVKqKdSJIg6AbU7XyOfOs75+sALJtkDNvzXTTc6q2/OFUQk5wrl7vvsWgTxBDZwEZg0NWFvr14Op0sqUOUhVYH1rrMi2X8W2fW6qA90w6vKBCK5XWp2JIFeXEZZK6JjKL97nFvMXRI8d0XcHKHVWoga++4z6HdfihaUjjIj1XmK0Dh1EQeaZuRFsE0EOPvc5FvU2KGKYJA9j/hpjy097NijKmeQ/lSg1knH3Hro6SVQwxBTPT3N3qQC5X5Le1Pumsi46Mg+YIGS6DEQUmEgrK0lUiTKsyslUcID6oOe3JBo5AE14YQD9pzUdokMJ+i9sqchHh3YGlViHNiEQBM4SRPUrKO19dvCo0Vt8LBto3+GVgw7QdCNeZdx29SsW80WBtask76OYqCmUaewnEhUy0Z1ULkYXecqtZ3qa9W1CMuhgMjYk3Pjcbcf6BaSxN6/8dk8ULP/rY08Ko3U5EEJXbMy1nLHIMAqm1g8Dqz4LbDiNzVbKzezy8I4mdHCHb66hALHqfx3ZQ+4sEbRoCq1w6hb2v39e9cGggwb62tlWUelLLfZpMhm3wuZnwR+Ze/alWzeAtNmYIjn9/cR8/yizr/CgXF7aXI/J/ZRrcVV+rj39XuNJ6ebAGGPcb5CBMkbFN4RqQiDq9jqO3AMVdjfm4eW/3dlhP37vsKEXBbK6MhgLTsqop5Y81HkoFCmRQRcuOOr5jPY+OVERVnj8MVnkMH8lZ4YBLfs+09fvf83tz/vFz3sCZDKLgsH2VutUQ3il58XIxr+rQMK1rnH9nTCG1p5Oe+tmnOgUPmm56xnHvOHThdUJzhR0b+xg6Mixg2Z6qEcWDlcpSh7HxIKHSqYQeFJIoqoh9gkGxSUuYz6CuuZn+d/jOcOTsPEMaFW8jF/JfsNJ6Gp2f3C7r0WddYuGozVWoSH933twU+86Aunfo5NnUVVZC7E9vaVPRNz50Uwt7KbYu6oO4qYqVXOGz8iQp6Xev7EpU/1wkPewusaqBrjc7zLRlDlV7ogzunVx6T0R5OVKyR8MWxf6UcvJE/903zoxqHV8RFded8/WvY11cOko54rXq3V/x4OoS0NdduOvSUSK7egyZ45DgjxsTIgGHAKuGAH35/y/EAPzGSWwSIsKsEBupV9w94IVrsh6Sefbm/4RgS54UNnH5IkKeAPUED2MfxSsDEAW14x3Vhun5kYbejbsz7+8f7AkIF34TzN1wO8qqxR6yl3XfeX9OvxXJDvBGWlR6Q1WSN9I6L9apmScH4ui+XufsWymCMDJVYP8E/ejs38eF/1VAzROmyEpnoE+KveJO0RBQhOrVR3oF9TYw5DvUIEBXrmr29CMisiXY2UCZVcNjII/Y9ssIHPKFVeRRMP+Sw+S7WHCrMBec/Kh5QxKEzvCQOV3ldwzdNU3aZveBNPyXwcP3ASIXAzB3Bzc/ic7A6vCPSoxwjib/I04T2eFcMfwof311Tw+1rPSn496P5qoxVG2g18e8DLPg4oykFcHijL9N/JG0HK8/znAL5aasXrrjl6i/ToLWSXh+Lj8ipzsgdSoKd5KKJVWm6isHIK54Ee1rTH4DWHufUXmVOvUFf/lq7+sWVWVWwd83e/oEdhO/WAalkF2XP80MML47iYJHRvTc4xEPx7BFvuDAuCAhRH7rAsxGGZCvJNtYjKhqO0/WCe8Am6PHy+pu3Zhd5WT8jeDCCMxd48HlshLlH6YCjORYIJWAaCc1xMCyymBcfDtHAzTAtPBtN0jhr8+iPgl8Lkaihazeml+Qw3Yo7VntuHzgwiWtbnRPQURcGQW+IXEeNeiXnhCObpJ9HmeDd2+vtQ8c63eOc2SQ7vsNF6k8M7fwjvwoeIdz5Fw3jnj+EdIscwD+vJJPTTqfbIo5+ffsgPQjn/kcXzjzG+eQCgHfPzUJ6e6hkleMnMehmrpV6RClePzxPnAmvYk1di2dxknJVPJp6kJynZgo9dBM6mPG5UZ13r61BDLXPYDVXollFdVZ390vXsDeK+L1Hm7C63Up7DDbz1jVqeiWC5YFKuhuSCV+EMsk7cfpw9Jo8kp/MnLx/hdF7uia1ai7Wh7t4jMQVlrtzI1v7n7fTRvTg/wuxm5UL1S+Q0Ahh5Ff1ECLuq1LuTyovzgG9NlD+Ru8h6Gsb/Xdi//Q+Z60dxITKE4gFA2nEr6lQ9Sd3oB9Bn2usZM5E12MZT7prwvdUa9d2N0FK/qeq57D+g/pqeyJ5ey8Tny8uFmu2qqUSDEe7H33njk2o/0K4hyzL5JstOyeKXWS7HXjFInyNwBdwZlnhIvxFW1ryISqPwocoSOB7hAFGG+OBml3FCI9mkt8MtT78XTc8s5MivKIZqTShAQmq/0+hlAjsq1C1M/zoYVSTY7ZBtkq4A68mhMeofR5FMcEDFbohbRkjidupIQ1cUn0F1VG8B6M/ySramnIH4mzJWRkkuWCK0LBdQeduF67yX9fA2VyZmIpMoE1dBg41dNz2cZ7pUgPIcEXzV0+JsgBfRj+ufC8njuiaK4Cl7M16MtKMFGitX0LAD1xkGmFrHmb+os0As9kj+IpGjzRW0gxI58FRb8WJY7TBoiDrMgacT54QVeKpKTIXX9y7hz/iBXHVCgSuykdMzMV/1tJXKGc+Bsi6mKdrYn1OkQet+yWxEdrutxjz/uAlWy/5cCMG2SbGYkqrSt3vIua1jUTs8fCAsb9L13Elq/l/Pn+wNl8Etyxda914V98rSUXqc+HVdz4yATZdsnRnulnVVJoQhdg19W+g1rhtDYOc2zRdpna4rESON4Jq5daDyomR/0dATkWRIgbeA7jxuAMjcclYTkBpyF4nDnIoJKN57jQcbijm0Sp6+NPACvYDGNS/sxy/kIrK3WG0xQSJjJauU0Mp+uWH3hWimalvKgRGlfbnfIV+idPLZJHlP5Rr8+nQhN2LbxaMU9tXyOjU5r1kwGQ7SuPoKRS9kHPJfKF79g2twehKz6PxJHnnvfMWNOMOuencqLV+hXmvAAuXqjOwWsdmoZrknEx2YKpjLAS4R5QVGdSpT74k9foDl0Afp7cfl0mftToRO93fixFlCyyjDbLF1oeOfR61kt9vpmIk6ayaYglHQdg/NhM8+pPsG3sT7Bl71voF3ovsG1z1V7xoM+WqrU9j/xvA1g7feOH7NwPs3v2bwthsnXjPwJl0zeDvy1tI134+vK3V9dpdAdtguR04qPlakt4mhToUokLc5ihTvY8bVVQQxYaFFI9Opfg27aq7ib519U4rzhjrQ+DqK3/mKJ1338huAb77im6/4Jg9SLy3L/PAV3xBSfJOQ4ptHSrgkW48fJca989oneDVriVkpg/RBJocRabvZgmOx/4Nsprzjxu9EmynvvPHkbab8smLjL8Bmyr8BLnKGf0Vc5E9Uk++houIX/AiT1cPftZuAqavIOKe8rK+0HTfP3eVkiERY+rvCnS2Sy43CV47I+AWGf0medN21uBJ3AjBEJwbDZBDwOruRp857coA9C//AjLtcnBc/JU7TRl0DBhtuZ8fJuaqqAFQY3NSaY8jr9tSMe3ADdxFOgwQoHAUQ5UF5pTygEJcIx0B9dtWVE34E/dTzruFHqGbvU5zIEcaNI44wwuM7wvg1L5AhnnAls3Y6diZPooNvgQnjt9hN+Nm1mkp/Q4qgJWSOLjxU6WmkTD5uMvlq5Ic9yqtoFoCVHNmkz9St38iX79Yvq3cDyXt4l17ec+PopReveunFO8lLLy99WCapH1aLf+3Gf0Mj2kM+Ujxx737jiI+Ud9042UdKiFYmx7OxPeKIL7Q2tt8OnxMCD92rK+uoR8q+0nevT7w30pXq0p64ne1fJ5Prhfz0X3CNWWn455r/N/eN5epUqqZL1a51EUqkONX/f8l4TrgCW6ftunVSYULV/1H/uj4xvF54DfLrwch7HsHGooIfP5n2It+Jm2xbS7Zk1+ptOgrXfd/QCHg6AicyhP4wCNZDy32T7zedlsUxv6RHffX++FF/xRzlkxRWl11yYhSrGyL5OQpHFtix4e+ynmhyNTAwqhMKxVK11Wks+4g8yYN9zxdCq4lzcpQah7HKEE1jAkZ2DviYQv4wAcuTfVaYDy4JnxVtCvmhehbtET0LFFa0uH0oxq7HyQtlzQhV6zgs3ZpWj1w/kkTqACXiPwsbd0fXrQfHUTHOyM/+Fk3Va7DD3paKKPs7pKnMbi/2wuZq7SV8Tgmw6Ul/jFt3RZ3qFf1wYxHB37c7+ql7zvnmmWfivnkpj51840JEt84zWEJ1qOq6zGCQ1uWW/5Fi06v9qWsDNdazn3mdqMyXF/LNAX/epDqXU546XgkupDynXeN6Dt9CTb0+r6U92zWfu7VO9cMDqmNvfcQUWdFEbR5ZzxNgQqTHkbhzDOSIcG4ekn+BKOSE5lJoqLAHAzOkNfFA0BfP6TtXdOJlf4/B0FGINxhJoiq8o5ODd1SFd30I3nWKxuAdiYSb4V25598YgnezAu/EwjsZg3cD1zKG4R1V4B0B3o2BVjMR3hHDOwJDNQHeDYZ3naeseCdP1ZAgBU4XOrtPIdf/8jnYByiqq/WW7MtIMrYCdaOxVwTK4KIA0er5IKbBvtETQ102OQWOMrXMr6BMtfxwzN0tryhT1lRgHWcbkhRCqfL1r+FVUeKzW5FJRl6T1p1+JBRlztHPBIFMLlWM1J5JfP+3X+6+0QSrF8n/Wb3Iv/crUjins+40OT708gkKfg4CTocwdjqE8bgOoUuXVNDLh1gJowtkifrBh/GBnkQE3Jmj+iobLhGnW5slIsqDdDiEAJhgLUrHVDOHIoSCviAJGUM2iYtFUoVHaA4qyB/TFwy4cXcqVohXSGTnED8pGNYXjJws8oc8f5KLi76Xh+Ywy7LSeEnEK36KIGAjff/ojWNuML5THQoe+5YcCsLz9Mk7FHSGK64JPXOdzHFhoSMmqtypPJlY+6kkqCsD1GS2Z7yqDdYIfzUcHQ6YzFozWKGVGEYn8Fvy4QkD9sEtdRy4d68L+er20otjOwfvc6pE2kJjn/O1P3vcW5kR7oar1TxC+EuV8GecKU8pJdUSb6uUCFJ3CO+aTZOEe7i58sU7Rr5Yc19Ikn5xe+WLD4x8cYf7QpL0iw35QrhYmUB9aUpJU3Nr829tcjQKVayqRouOXPQC5gSLpE/Efyz1bpjJX1dr+dqevNnyjEUi3ChD8IAGW3KgAP8LKF1Nk4bi0iR5QZ71xdoyipGG5TPUwYDNIkZ6kM+ptdOmHnjOq08VNL5YRHyXFhGVoELkl5Oj/tdukiBi79VgyMHPaFDwVQ1xrQiJco6hMNv5fYH477KeBQLsiMVqQAj218V3AiRYW8SSfb5ECXUpW10Ro5TL/Ld1E/Nh28R+V0B4Tra2TrQ9z7mSLirhzu6hZb1j6hMzdtJoXEHFNhCmpcXUVwJLYBQ7S2konWJa4i/lNleO9rljBQrwWU7yzPI81ZaAB7DPYgdx+oNf9gq4AmjZy1P2WexERearPd9jn8UpXHlxapnwW/ZZnIaECAl7+VrR1y+2z2IXF8TVkKRdsfTM9xx7gn0Wp7u0H786OOfVW9Yfb5/FGZpWnElnckiLVobPPouz7OcUcQgPCbY++q73fPBNf5c/0T6LsxH7iT0HP/SFf779CfZZnKOfS0ff+QO3HXj6S9/wIfssHgUoI+XQ/B9sWfP++Yn2Wey2Kf/ff/jIwupH/uOH7bN4tE156g/h3y9ebJ/FYzQFMHoscY8qDdYmX/vJP/rPF/7Z555gn8W5UtAXbzvz1Z//3H/+kH0Wj7NVvOQb7/rhv9r6u0+0z+I8m/LJZ36EG3rGh+2zON+m/NL92fT09PUX22exx6ZcKg397Q/bZ3GBa3BEPN6eQWD7LM588PsZyT/lFRc++APF42k7PR4jcSoP1h9yeb7JZp/F4032B38gv4gieizhs4g/i/SzSvqppKgpVUcERCRBOyJFMipRikoEIosuOeWCLjQZOYhRgdzAkxlm2m2eZgipMmBoTT4yYIThITMYZEBPBtBkwEoVIOZEVIJsZ7XvJCCrAiCinEGATGdypjM1UyV9G8gziGIXZOrMgCoq155YBVUynftKo3PeyOeFiIu3gOLAHMvW58vZOrbaqiWOHXai6XM0El/AYuUTuOCCWrjJoCY06QmgNKcaY4LFdu4pj91FJIGLaJskHDIJ2yjShAhWGnWxpa3aBv4mEpoWyGoj5JybwEVvq0R/zUZHdBEGz0RjSUA013eqiaZl7COXaSscXG51jgGazBj3Qz5SQCdD8K045S2eCEIsZP5iJJyV78WD8j7NqkccIfpPYvg9qV+Hk6qL6Umr+WxZed4tm5cvlR3It9p+6oLRBGW33qzsGsNtotkVgQLWmj7xA3CeR+Y8Zign/KaedGNZCZ4A+9zPL3w+ASgKserFmLRMPsrwYTCyukDoR3D2sJVGEjOTSDzkZTlLo7nI5IIfie5IIkcmwIuij7W5La31qQBOzAPw8wbw1OSlTHLF6tce1mtld9Oj3gotrnD9Yr+W9fShJOCrWVpwFAjpspKLwndCHFKrwxhh3zCf4kMK9cSXwiogV46rnYh6EtKfRE9UBjTDQpnRNCKnqYFIx5ZU+JG9FZ6Hm71gFbh2FU/gyaH7rSZNYaNhrEb2aFa4mmJJYwpuwlYeXX7InioR9yFzigLqoFmnqH3DfEaxXEGX5swdScYsvaEK12biPSc/VZ61/ExOFJvCKIS29CPBoEIYnnyeh3sLLa1SV1FLho1n4DLFzuWIDteZwsvPgwFCRsgwjPORqIJHBXFSTNskUhHRJoFVUSSlU/NIyEICyG8BkLf0hY1Xx3Ft6iKOuTnrQUj72QVdKbtSmK7Ma1e2oJWGmesSwE+FgNy2GKbXBU8KQ+fnh9+VgFTb6dpYoD2FaeMcWMA50hEWxAVNWCkWqKFvek4pGiyw/mk5adnNTt+AnYhRJ+TNid3FXibXH8hoNfloeIFbMrpP0wtnHgXGr2UeWKeWqvCiehbm/kz6t2EUwRkCLtBXLQ1GWpcWqDXBUWLpiFj398c8vQQXTeBJmzKZI8KTzDMzz8p2UCS3sJ2ptvYTXD4RGXAo0uBQNoUMRNhyCEWGm9IUHh2Yk4BJnpq5cWRt07bNtqElsdSAJ2KxDpELvW5Qi2Pw2I/bwmpYVeoJy2IpZfFcao8RpwC3Kd1t6jFjlE/1E9e2Nk1RaiTLVxbtHpeLYjiQDrfNSfvQEulGdrjoqIAgIRz9Zr8pwrLpI8XMvp+46eKVv37U75Ncl5rmMjtrNL02oBma4ZvwHV/G4D5PhgWgGbok1dFD004pp4NIUsooY6hzZB1AUe866fDtjqBWu/qJgzVcLoRhLRGlxqJFkFGa/ZbVzwNSeCoWYbTCpcTAKmb5ZofuLDymz/ODifc1fcVlvWbU4tfAWsPRsIg5rDUcPeqCWezst/UqmtiZzOPq5Y2I4rX0rQErb+hu+GMju+GjbjcsSbobvrOyf/7MyBfH3BeapKaj5Iu+FEc1MyWyd4ioDwu4R556McK1Iom63yN+C8zbfXir2nkL1gVZcS/HjWevQH6sIFIRDn61sqIuKo0yOE6Cgitl4iJWdRCts6MEiJwYugPbdvzxMn6y1cIHfH346cOcx8J5vZwIktzs4yH+nRv1RrqAgXzTRdcmBCTN5i2bCCV38rkqVKD2x6Iyt3H1nf5aI4F+K//J9caI/8Y9s6BvuMqgA/SlkQG62w2QJOkA3VsZ0kPOvNZ9JscxLJT46Dz/6M9J1GRd2uCYphLCd1fC9yGsDfhoGQwO/jyCziDrh69jh/gSp1/dXAnfrmGIKz+mJaDdRxGrwUMuuCHBO03EnWD7pMfaNcxAveNx0EMQkwiG5PQF+FDOIlgjV1N5FwQvosANVQuqzy+gwFhjvLpyP8jgq6e8iFqKiR2SFnWmxs/pyzBQZBAkwEhLFC50BBToBYkrENQbFD9StdyX5Q1J+QxSMgRxU8Qqzt+H2ES0BHUAdStCDU3DpWjVq/1d1avlo7I8weNyLlZno7+C973lXEREw81FOK93/U3WZS6BganOxUTyA2B5HdTpKlEPjYdMjNXLWyZN42wiIf8Mv/Z+TEzndRIzMjIC+aablRmPk8xOmZOo47VDs+qAr9LOpgwG9FHR72GgwHa6R01jL16Aq2ACAHZndwrpbGn72+VknUK762h3S9VBFC4phls4ciUyyWZExt3qQJdEeHejrwtcc5VEKXwKBAe/2jtLL8zi+L0vhTsXGbTDRYznnqJxpOgMr4aSQGxKfODWKqABbHpkuB2S4TUZrK2tYc0byEEarpSgKQd9Eq6JMJBcF3qqdMlc0vArqsxqpUOBfumY/fQVD/dmst/T20UCZPx018h3dyxl7m0cLl091zbcMaO7Hkw4wdo47K5urg0qV4bX+A6qF4zrBOnhSFf17pbdNF7OPeLHnF7dyfIYjy5s/VBNtfZCIRRzElrGbNPTbxHeQl+6Bn1pMJJ6KvYH6GLVHPjn/FAo9vDxd3KcKwkNWNXicvHsYt+Fk9gES+El/IgvrF1snPdXTXSqLnhavWMUlHeM4tGr9LG9Sh+LrXdKgY2pCC8n3jEK5GxryDZnsD4QsQXgdC4/kv7FDJ09IC44JE7UhEmiYE8A9jnNnCGzniXvRlBU6c8qS9iFkNoPW9YPWqib4zLGRID4j9Fr2ZK6g8v0dYmAeZqtgVuTPIEzFC3WNcLs02I8WFYeotomRqMhNG9QHS20Cx+/eXL9r07IsWYDd9jAUQ5gabuJn1igbpMnf+Lr825ND+7Cs7rYHbMl3GsD95tPD+LTm/0Vu35RTdtk7ZFRnP2JAUT/wMt856iOt82IkGYzbPtrpP3OUzHE7N5b/L5ceW/ze1Z5n+L30L0LJx1ZLVI9W+gfoHzGnaEimfEWTBmnwJcC8hez1IA/1MIXy3XUpBTnz3+K1muf9LuATIYW3tplHiC3nJjisT+f0zOMgKaU8rbxmFc6vCBFy4a/S03Zpfu0iF07LeC3SLBN3SLb7HmJWDKiyx717HYVpjAk3xIhtYyG2COw0o95PFjMgscCLeKxSFvw2EJdiGC6NAc6SLM0gz/WQ56G2qZHgXpdV04DZWl/5rU/gTQ5MDo83ErlH0Asxf5KfGVPbQIFmMKaQi6F7DIzj8e8tUaygPm9YAQxB9TIIw/eFfDLM4OhymdIB8vK6zrlvZXO2L0VbMrK5KlJye0yuT0puVUmtyYlp2VyOpZMTQ2XuJMdUxu4dZ7wTu3og54csIZDB6yeO2BVNTdlCwLyNkTQYTS9I0g8ANChvSK2uIZaBrjxFKjpjnDjiMkzxwZW6tWz2tKrNkaK6va0ltcr58vYswe0vrCh2e+jM2vptWK3QJqDjzxGG0/QxtOT3Wo/Rmm7jUgqFNwdDQemgKoFtPL6lSwA6fM9b+ICWgNFDhl9MvKe59okxsedlruukrpedu29Tbhw44/I10XyY6OL5DVeOPlwGuOhh65MKTmAMPn6xKn8KvGPwHW1CKw2gh7X84wL9T37uNQXo/MG3unXm16v1IA8V5XL93ASJt/T1V7zcgHJaF4XDVu5jwuDnP2fJF/N1x34BhTj8xSoYq726Y2/oq0OZ1vwZ1x0sJ3L9ufT6hoiog4XhwnXps5+KGLPUgg6ALnsN2uXifw5VCX1BTDai6qp3uVqqStC8y0U6yZ0iSKtsCcqfu6SYbG8v8i4goyHZyv5q6gRRxfSh2I7dxGTS/Ui6sRitpVVyILwwnQTLyDvoGuxcMjZ06EluJ26ly2VgqNMnpmQQG5pbA3xbaMOLdEyGsjPHp7ZHxo6zjBRx3Z12rIqLUUySpuhrZSgXupA6Mtt9yh7lFdDOu8HwEC3+6HW62u1HqptGYIFYKPo6bJoGi96dvOir3VFO2qJcgX4bQJTK4OCIckUJhwDIPv7VVtlXs0XeQLGTAAa55lUuDTchSU8lihDPZnx61TX0cgwtgq6umqPJGhUQg2gSoOa/E3eNMfN0OHRr30d0mGs9R8a1mZjWNsG1kbUBrZmFWxtf5ux1f+3xdY/enjYusufiK3ht46tKHoStobfidgabo6tSnov9byXOBE8aLLnZmMRoeaQ8LA30QKjQo5uh04+P7EkQGpiSeFxS/qDwPPHrwYrQG8KZNerFwVuDqrbXs1wsJrhtUMZoHcJMxJqgLZlTUsg9j0TY2+fGHtzJfbD7kLXjV6l4oPeeMteVEm/djx5tZJ89XjyFZXkq8aTn+qcJLjIXZVvzhr/ZrmSTOPJrUpyNp5cqySHw2B2Im2+tR1Y1Tq3Nck+od53qPastmf4Cj3KiJwKrhxalJYyWLnX2VQOjE1l/kj1UoVVem8zwokQmLUh60exZZrE3XTpZVUl0NWr8OoDapA3oOTsTEZTva0peaMS3STH9xEE3z/7qVPvTc+ZfiLb7eMDlz1GW7VRNeYB4g5roEU7+zNrdQI7UUyXRtWa2lTVL5vaXhyyppZPVSQLehLC2ZyWdZHp0HRktm9kv3RANqd6dQ324FBrohiO/bTxMvNOwNJecJuWIkR9YqbSbXGv6csJ4qwWyEAE8NAZFnzlKcVqzQB+lrgu2CPm3Ng+0LTW8+fCWOdNu5zOgiTNmmp1MUA+RCSVk5/SYuoxODCWLP0N64inDiSNpQzMTllOb1fTNyKl3Svc9rL9EEMj7R1Qi+xwpNqDDtX1a+h+fAYp2Fhhq7zGH3VYx786Vik1K2PVJH4fGisTPHrRGsZNmjIizMF6XVfWV7xXXdbDKtDLZ6tSHjl1ZFEN7CkAi+UsPqC62xcdq0jmdMStBf4DP/H/1d/9pPUBnxFiX0FJPo17uzpA/Xo+bY6/+tauL1zJ1BU3L6HZDUi1dJWpW+3qphMCCgaiWIErZmVDrEufGUhjaTb7X7qG6+FfCz9ZgaoQSuROAdV5FdANVl5PkRWzTnpc0wziY/M9sGdosIjL/d8oV7WoEzw4KzK2sLrUgBGXlF2hBC5+Yr3pONQZLaAY7l6sV4LjjG+e4T1wUk1011ebzgUoQzAypAPVD+Wjmx/BhRQ9HzjuMOXpSBE05cKY20NjGFT8J8JEaHNMMLtvL+OpazCQsgl7omga4OMsKU0xfqTXn97yjf5zwlK7lphsiV4clWZbinqeYH/PNt72XmPFeBUCqfCQHrjTBAekZnWnn+rlzSbDA+e42CI/re3BFVmwIpdeUJEvwTZFqs7TxKl3TPzoqJgBurYZgp4Ep803kJxoSQjOCuQenFNtk3weDTJNEsqG0OVgOjBlPa1pgXlmnBE8EMDhMnWFY9ZLB2n2eaER86ZTKGOLGAC/lNs/Dzsr2aU27hkcl0JB6elIU75rSqtgTdUudYgfS+WCaC6ac40+/i7tWaeu2kftdPbul4/kxZztcaBX+WCaMpOxC99z4VGVly3Jy14JdwHcLi3hsUQ+5GPc0tKlLRjVLSgPy3JTDkEQWoa+MJTGmkqwDHzyrWpVeBseqlBDwd6JTgBz1qK4I6A6IbBmA4ds4IAN3OebwN02cMwGjvq0TAQwFiv5Dq5rJ4/oVrlThpe+L9plO/NTqJnvpB10Sr8uSknbOAREUq2fU2k7meBpfQ96N/hMMYcTCogaIZRk2KpCWE6nOSUgQTbkw7SSfDmdWknuQsGGgYulEmBmioqWwHFDs2xOc7PmqGFmuAqeFX2x4sTtmTlRW9AOLrSpbWEoIfvWp5ldyk7aiu0I61mWrdt54tZ9+4CVKroTj/BOg/9msJtaa97VUvk7L+9xW3ZYSFEXVQByK1XVrJ38blo5M5LUQ/2ncNk9avNkaBlAnQJAUb91KYcJ2xSiJqLmmVphjm/gTmHlLt2tTGZ2wXcy4NfB4xSqM8w2vPx0Dfj5GcHeEtEUJnSGggjB0zVooEq7aI4WDUQr4Gpiw9w0mjn9KS1NoNUslqqDpoBzAzdcMU/e0wRWrka8FHl14DTfqZRrzs1aQUtK3jB0Wo2gQlmXfAuyc4rEupjRcnocAPhOkecptCjPRcjQlUAJbsxzMLC0qtY/yI0PQHutRS2OuykQwcNrA90Ogm6ZtFA5PtFkclQ8NatRI9UNZn6mfpifxdmwPhVnc67JKxQ4yjyjs8qF6hw6k/jxKLdQLbuFassmCxWQCQsV+TnJYjV9nMWqQZ6SwM74YjWFNGwmzGI1XenmVLlYTROZxWrKLVZE009Hmo7mOUTlYvWo0cUqo1QWIMLf8Rcrl3fSYrWFljWjrk55Xi5afCDImASc09UrdxHjSxiBonH7h5awqfElbGFoCTt3eAnbpUvYsixhxbd1CVugAsCd/+4S9n/5EjbvlrD5f5MlrNAlrMASVsgShsmPJWxqo9hNu8eWsHOoA/g9Co/vLmGVJczRH7eWjSWd/KJGWNSIjLBjmoMBgkKu86ZugI+7b9p8SXJr0ZSuRR2KSFamWFem/+O3UKfoFoofS3QOHoyweJzySGyodnJg58QN1ZJcOMipZ9eoLiLsVZtTdA2jHBHja1QPD8YDPE757qbr27FifXfF+u6m6xw8dtKj8Njx73L92ivVYIFCowzJ2mlebfWaphikL1VStqPMXcnpCJvWPWl124knaIA8dxx/C4eg0bxMj0ShZ7z4jp77Odd6SV/CcD5VGmmu8Yuq3uW+vMNUTqInrwFoo5qpRgi27UUpT63eB2JFOjHqxyEhmY8mPl0pqwhQGpE8usZYIVvbUOGmPUNT7RfR7FWVuSI+UtRHVX9hStpfW4MFoDpfhPHlCApleaUycB7zWgBJr8d/Tyyjbc5eHru7OH7Lc1lxtcKpEMFSznBGqbpio+cI14/IeNjzIrpDDM9nGUfUJbADAPmuISAjjgrplmi6pVWIKOwMRIKThkjtpCFS+/ZAxJ1bjgMn3QnRwjfFdeBdyFKI750E58FfsSau0+9n1Wp3/0zwTq3t5Z7BVr0ehoP+wCqjW71APRavHoRfHwQ+HFtXDIyG2kA9yItU0+ss1aTeRVH/m9uhoNZ6oR5SoCnq4cdjWykBHIU7jjKG0XYP7nhKtik0Dimyu+V8ti6jVL+yh7zkifKb1XEJoa0Kl3x3vBxZE7WymqBVamI/QHGZFLe/vxY8l8Lsl3CWIo3GzOOHmmSVatVOvc+53mVs+0SCRaq06qMPAFPhkYYByVgvDeKwhl+L+pUFo0RAaDYHONZ8oIda+klZqx7oa1syaWr2q6gZXSsNOsfpL4ShDoFnVZmPBeXdHqgpOoBG5OxPjQVq2QfVB0X/QOHUg+tQDy4eSKExIeZeIz31rhjpMrfxOJssOELR+rucNnQAbWi+DbOJArVcqkHgZhu4nQM4BruWAmhH3+ipfez7zfNOTQ6O4lnVjt6wBRyzgbvNJ/fhecBpR2NISs11O82uwIk+IWOoVrjr0FREV0icLIi/LvKVmC/xmygTiNMJSGVQaNDvlDdsMg59LCjdfN0ZVMYBdAgzgedBUXN2pQCrO4MVrTNUHAfJpghEDMNX9ZuLbE6f1em5BowAzg/O2lwEJ1vZddudx6UDgdM58JzOgWd1DqqqBQn4K/XDSKn1Sp2CHqSir6PrbKPq7FUse8ayjsc4LVbTh77aD4Q6unEGJ3q9bQYy1+0sJ09hR0EtaYu6VCtSNbOUlgLU1opk0GQbi45MqS3atiTnCc4S7/Nl/9jh4N0azNC4GpSZhSjM6FZlVpqZzynhmlfALFAssxEPcTfeQkgGNJFQC3RBjdfze6q7Iyr3R+gLv88Q/5UmbFLcX06tCRt17j7DjJkqopvr4vGE6bJkrAHgWZuQ3suXibdeUNdCmQks1nR5oIRJXlD7YdS0FmvqVC+FA9yoES4ypUX+0qr/zpsbO2iy3irnqvDM8q2TLNZso620DEX57bR9gsUammyxJocFgWKCxZodSNg+wWLNTmM5ZPsEizWnuLQxizWnalpxGnYlKHrcYs0u+7kYw8BDguMWa05H7JjFmjOOZ7HmzE0t1py1qcWasze1WHOOs13yKOIeuQZrk8ct1uyebLHm0ZtarHnMphZrHrupxZpzN7VY8zjX4NOomGCx5jy2oLIE8yvns2WV7dSj7RiJgs6bbLFmj2aHwZXt3P1HET47jT87TT+rpBekqImqOSsBUoJ2y7RDIw1KceIpZciiy1bayiHOZJFD8QcP+e90/nMDT2aY6SzzNENIlQFDa7a6QvS/3RPM25ABNBmwUgWI3CEqQUbVvi8LyKoAOI2r20bIdB5nOk8zVdKXZCmYE7OFNMes8ajFGkNT86YS1ByG/uriLH6OEhD6lLaIxZp02DJNTdPnaCS+jr32BVCioSyvUUf9/tIFIh0WGnO3X/Rgj6ZgbJbAdlqShPtMwhKdpgmnpYa31Zq2aDNki9nTxpm388gXkl3QeMnnmSI1cJq77ZYKx2dLJUY1c9kH8S3iqIKWKlFdRJ0G3C2jdiJqiYoREdwWCF+20IzV920b8zep8KuqssViygvLleLxSDgrX8CDxP7IRdybi2D0JqPH00WruS/V5fPSkHxRmphvkR7kHawzWAyckRtdhRbEdIz2L5+jNvHjAmuZIocbtZpKCSB2lcXjApgvhQgrhgdnwJbna8cJskbWFHyUMeS20EhiZhKJ5qgsZ3E0F5lcu7mI+ZFEjsQtdLlUU6NpaW2T1BMawJsY8FIXRm7qisnSl1lYmhAjN9kKV06ptXBTM8KpZtXCzXZj4aZGHBIMbmIQm8Y9jLFw04WFGzx8jG+KqIuQfhFdqMxbizxjaKGhV5ySIpWz3lLBq3+gZOMazs6qnX/UUF/yymj1b4SlVU0xplZjm/JKZzSVv1WDqYCjVUz928CHJpUTa9StOrNqjsHwhTqXV3voevXoD8DKpGVES2L391vPLRLdiDUooQbzPH/lLlgjpbXKSWCPYKgafoeaYPc8iNY9Rng4r5L71T+xH/ehHCfaUnOZ4AR91cn0KJHmFcJkr5XXlz68Bu7fqJRm9+iN7JTqqGTzD/yhD6h1RLx491+K23ENUUTMDgvkqo1H09Onlc6B8gY09UQxM0+rfre93Jc54zvMCinhphhzMgCtqSuwKbhwaw0GNkCCGkCiupMAeBtFq2Ju2IbvYE/IrcGAwlsGcvd4o+IhOWAxwX9j1XUMGzZDd2Dyqx68mt/X/QX/UCgXyCJjkYUTxHY4P9A2ax9GnRoPqnfuqZbdLLvU60JrdkJ5cv46e73YTQ7gsE5CXkUU0TIX6sCmokk6VNEAEEEoHhyRasUnOCfHg7VKM5RPrYomXh95ibuY5vY72FL+yGYeCvRm9voDAcDA+78f5Ah+PEMfl1uRRamcHVig78W+B7eZcSikqp2w5ILvyixSsCrQXtpD2XG5fb0YriJESrBH7mtC0NKQevKm7i7ECHG2oqtn4TaTIqtqmmv2UA7nWvJA3ZKgRHP+lSAZo9yiuj054sa0ucltXlkSFTkmxMlQxdRzMNgMKJViiyZ5chBWQzflIMwjiXvG09Hnhui1Zp8BXdDLkh4DOqUk5/4qyJpKgLF7tPsfJzuV7mX/C4MkQZeiBf91VUU3K5qSpEq6yKk+MhkU2JlpBDVFUxfwhhMh9cdAES+SuMP6vKKpJoua2d+hzabB+BZN1iL0nDMhW01tgi5wBUUEQpURBq0uby2+NvRhFWrcHhQZu88xqdmpOsbJOJbkcAjXbKEZiQbAL3voe9U7pdfyAftG6dewmswj1Bgyad1wJq0b4yatXbqkYrDQAFmi7H/aokQgV22GmuYPieOB+mGKa9GuUZXMOkE8jvKdDrYkfwHJUG3P/gYhZkXhExzNh0HrozXgXgTRz57NjGMFuygiPLvmmeB6vsyExorcouVn9jkpnRoAeqO/R8RW5yIbV6h5MLrD1ro594uQ+1pdvnn2+4pwiet1tcsAgH7qjGZXjTb5tfRfzmrVVXJ3bZ0RA8jRHFZrDnK5zfxyX/SaA/0UHgPZ9pFcmY9VZqJjQjHQLm9Ur4DUcSvEjGJLpTyT1KA9oyvuPm2jd/yhHOe3gWLsg0vEaC/Xc/wptOxGDXfEEm7nBfvzDLEv8/XIHuEbNDyjufXQ3pZCymS2+QAfjKpcYGvki2iRaZN60LBErM6ZW2L/segyv2xoWAx5KtOwJaRxO9uGeC2aXqGMJUO7PFqkBdAuG6eH+HwZ8OlI40qwDZEqVvLYzQ24EhTauIC/yuG79lA7jfP6kdxYRpQcuE9maNpkjMXuJhdQ9GT7oa8v01dnSiAGiGNaABfLLbVH8nXsMJZQrEUBRFWO5IUcdRU+ciTv6ZG8Vz2SDybJkXAk/3LwIgitlaFDZehAGbrvRhu6uwwdK0M85PZoPl8Ry5I7qkfzO/q+rFM7cKab76DCnDafYk+b6+60ue6O5o3XLYNGVHfGEE+xm4fe0HGz4h7VndCrN3TeHKvJwUy2BWpyEG3B4Xy9bFB9swbhvpEHbMHeBfLKEzdo9oRtUbOPdW0LwwnZy8P5HXo4X3CCbd2OE7fu2wmu1EwBynGsamaFGfK6qTmPtWS1cnsKtt8WXipTBPyGzuF38Ltp6uxI0ilow04u/RTq5AlNGXDtLI/o6/aIHltATHus9ksbkM6OHdFn1AUUAxzC3+Dnp2voRjmPV1xzMNEDeXQJ3a2bU3kHXNpF87TFAHZI5SFjeLpjeVOoFFIkQ6On4HNDONwCUP3TFGCuVrwVlmi49mnuU6mn+TdrjhixM8imtQlquCq1eCVSWrKLdKRqtFR76r5FnjDQnlgKlvKQqMFOJWYeFKWxyFQUpT1RlPZEUdobUZROhVceiI0tR+bbZr1qcrIqSuOpitIoXBWlFeq6hrn1rEMeVKUXRT2tw6OhqtL8eNTwOobHcmUJm9UCzXIG9BpazqaPs5w17XKWjS9nXbOcNUtNadfPbrmcTZfLWbe6nDlN6Tqdo1WILZJHET+Syrq2SO3J65r02S1pLiOWNEYOOqWSe5lmNKNd0PKeWdz406ruYUI9F1FZ2xI8ErvETQ8tcd3xJW5paIk7d3iJ26VL3PIJl7j7XlYuXWXoWBk6qqGTWgqXvo1LHLfj5Gg2N+S7S9y3EVypTgm7xLnVTSvNYy3032J1m9bVrbuZynQGAD4Kj53l0qaL3IvcEqfNd0ucUn+3xGk/H8YSd8OkJc6Nnqt8fHVDhRNXNzTtW1/dTJXjdGqnW/0mpg+VP6ZdNrzeOR1qY6BaCLm7RHycTZeuVpN3XG6ZynSZOocCXa3+b9mBQY06Vv3pxOhPPzI7sp0c2DlxR3aKXcAoNvqGI1szSly8IuSkdUyVqL+7Y/vuju27O7Zv647tHDygTd1FJ767f1P9atSGgcAy5KrFm8Whqkb16L7OZdw5lnF8r4faN9GuPv6+D8FNOfMbShJVho7ZEMizLE/YLRZz/eTpQplmR64iBYyziYCiDo8hFWZEgZrwQz0fxHi04VtAPR/gsK8CWg6oCRjE0hxmNFQ1scuRqT1Lc5jaAc2CsmuNZYnq9MBamjFmZOZM7ym9AMWYZvF8SEZaCZEut0BKu7JIoDLaRoQW6Vqpfcj1NEXODyiiOfAD/D59vfN4YZVz0/R3PM+/Vk0AZV+8UVVFfWu0RbU/gmHtD19cqkNfFcLeY/90/cEaAJh9CV+T584xoUqvvn8FPqEY/9rII/WPU/3WzWpnIkTdreaxVhagFaJ+N5hQOrHfDq+qfOxcH3jW90yf+m+68YBY13/N9SL31/jsa3oKUHFQ/3p4Nhjzo2CZIQVuYF1R4qg7YmSwSQlpXHiZiYv4dbUP1+U49r6a31aM/0l1UV91P9kS5e5Pve2Tb+MTbl8MX3ovUG/axOew/U8ihSP58ckam6pUl43Zx8RCsXitCU62ztDUmYjafkXxkpVCvf4LnssFqL8C+S6ioPSVKdWoP9nkfPMV1MZFQ9KZ9PSkbDxCeSAt+zhauqQnopGocyINdVlNAudmopNmv4e4WvoKjy2bBteOmRf15YRYNAbUyTZjV0VvXFXGKcY6hlM1628/yn4eXB54PpwpZ1DtR6A7OIKOOQXydMgNf5A+xvNeSt7p6slfLPQI3KTzPr9ZaHmla9f0lZ51K++ZY5rLjU1iphJAYiYqHmYHVg6GJRLjDYrWRf1cFEetIr50U04GA+mHTonoyiKAhdeQ4Pd8BbjUK0Jjp9DX77kb6ftK5+2qmW60+APzDkQR83aevYIC/4pcbgT8MMQFrm48HTxMPGNSTR88XChb/cKgAi0p1iNr0ssnEg08CU31KUXi+iaUrwTkrlRk4YLTG70hM3vOX4XxGxkaI7A6/awVw53SALyIQq88QhykAUETPLitiqqYFy0skfWV7BagRt/7cUAtcFoWYXpTHMKxKbSoHaGJTXIMvZhd/T3ZG426/Mf+SO9aqIXvkOqbqL13jQHvXVRHEZkaCNuJh6iOk1WNiMROLYxjUwMaGdBkifqsO37FNVCdtsbiKESuiCGJkPEIG7lz6kjteauqt5Zc17KX8dMFwthKslsBC4nONUsuNy3kFsSyhIhD6AKPrCcMa82en1IdVcrdWT2rpyLF8KAXQAOnG62bHixdu6iRvRF1FhEhc9GkCBpv2C5qK6QgXm+R3OUqpJ7sNnyzVC6vDdE7cn0qItRR7r4o0o5N6kqKoNruL5OzMrmlQAauWc0K4E09+wW1DYF665JDVnYzJBqVyN2Q8hPOU34V4itFfgsqHwZOFeZFqJ2oqxL503XEQAcAamqgPYCP8a8P5GkADvB4FdlCuQlSO4IyEzHwcgssw+UxPFowq407UpkCEs2uTEhxVsOtwtSM3Vr5VCZvOtN9e3VASaCE9QjclYAZ6GNmc6xFP98Ry18NI9B5nIRHdsIfissZb+4J+ZdVZSWhxo55QQYjAqztA7B4S27BlI5uyVkf7iUyeLAHaK8nGGZEdY0KufPjLGJz8qF/NsmDQeG8u1Oy7z999f7f3P68XxRPk+XLlb31IkLMwDmqOLzGcQO3g5HkI4cHjtU0CBr0D8YrMCL30a9wndn9el2Czy9i0cEgv+rhonv2PlaBb5RWu5+xd90oVYXOhSEXCAWvhjoEA8lXz1wCIssTg9FsU1vWFAifpLNrrnVciKwC7I/pKx7uBLSAby1FXAf8anlibD5BRynBxZWRkpgIoBVYYtZRT4MTgLd6x6C/SzLBPUs8YvQuYKxQBMQCC7udjDWqKvacWwZ4XHFE8FEZGggtrJPqPug+XHK/dAVrPVy25IKta3lYDo36YcmFZSAPymd8L9ArraH7Vs0sgCwsUEvs6a9XVqmjtSFrsO5WTLtWKnD65Il6k+pvyqlT/3deBQ4V8UZ702MKpEmfRpLob+rCWJZZfn/uimZHqnGa70u06nqik6URUq+igvIJL1AVvUlLrK98OLQgA2Xi7MLJkJE2POvjH+9TkN0odDuksIy8qlc4kJILXtVjWWGUvRwfyNod9T984xOg8RmSf5V1sRdxdPzCFQxamdfm9CSnoU0h2qbMZ2XBTu+tB3WhJFTbKKDnWbVlacWaGFFu5O7op+4555tnnnll9dKTa3pQaboQF3dHE3xxyKNa6ScF67hvOsBNUlsWueBVPXas49pC8bpCuIhtlqMD9R8ItpXL2fdY+fdVXA6lwGl6cj2Hb6H6QKrR0p6NHIcddQphhZESxl5T5MC1s85XSaMU0AcgVLWSO8IR6jyA4NS+WlTOy6oQFK/wNoHoIw9JyLEYkomDZDIEybQCybqFZH0MkkDe+gkgmTDZH4Jkg2EJ+KVUnwC/xMEPcCMvBznj3VqTLPigGZZygpfq5hBKziBFw1DFnQlm7anGNM/A9btwhUapQLbwe6C8/M4BgaB3mU58cLPCNWx4vueYcqpQL3Xb5G2ALFWgakQLoSNvJXW6+8NY8jLdWyTlBc6WhJb18i/I6yuEIPkUlNtDRwt98qs00Hd98yvD9MYHgvS6TfY1Xh+G5/nBXrGKsAc/GP2r+4wHvWsKT1vj2yzXcxbPZfF616Dh4jHwzWKEVrc2EBMcRKOrNPJnATl/EuTUAZMCUIHhQDBXXmbNpPDsVYY6B2DRTR/vfjk3l8Ly5aqeQZnQwUwI/gYYpcrgHB6k59SMQOqVsqZgxyB9Iv90Xzbd/pP00ccgpecxFPFB9mrBUj/7BzVZrQymwNM4QkS/VqCEiSvw/9nzdWP+/zGhk0CTMUu3/y9AFmBYJ0UE6+oXkDiZ3V2grRHJBlrRWJG1h+UV/4iaa2mn1v9pyJqyb+hyO8OFZR8TICfZmwT0/8v3onEZk3Tj6+6mRE1apgIn6cqQFm/gtHiDcS1ely6pmDQnXTx61VnJ/hlZ7Z6+lv2LvkIJPJD9RF+19APZcmI/F2E/R2CphG4Fklm3/dDdVaeXelUecYGo1+IRYuMi/qkASg/fwXOA3HjnZr0fzaJInZMhex7wU/cnTq/Wd5j9XzC4aII0wNc+BFIn+TLvH5DOmO54gmLuVbgb7Kqq2xjggiBeml7Axfe7Bh38/k12s+/rZt/HrPiGYqETZwSQZezFfgluJTEUDyILyJt0WgdCMvvKalkcQ0oijUjS5xi0JfQGD3wk0AwVnmCEwFJLHxDB8QgzuKSJsgMX2CpLh2zStuF60u/llvYz00duUkWOpzWhAISAPbo3ViSioLLzC9O/CMLGdbGwYk5u4pV2CcBMS1EKW3478EUrRjGtChDFKKjuKSWD3lcJ9dK1cOuQn/G+4B+wTZPzKt3QwaVJbrW/G5LpzODQjUwY8yZx8OZXI2gE5y2q49EW4V6wi7zqxQyCHH+Qw9VJ89ZB3qmamvdwRycP+Zm56NQFdc/VoWyjaA/Ar3o0RQjVUNoANWIv4PGD+C7/9UaSTtwiD4GM2kco4I/XL0A78Mk04nflqWbo0vQRaq8XbZZCYRTlog6/6LYHzit01xZSs8JdNMV3TZH1n4CJ5G4ZedBw/2xNIn3ZlFnpgtmUec7yRC2d5x83BWrZn8sM3Doptt815O9xnjfmOEOdVrScz4qX6aG9m9Vn81d2VyeorVJfMjcOMIuZyzJVpK0auQrf7Yfi1sstd7JHy5l6q/e0J932xeuP3vnKr7/xGzz0pd9N3eEpz6GCbhWV252zOdAGHqskVe90iQNXqvMTOPlNIzpYA1Y+UL5ER/D+FfO+7q6hFXqhTa/OQSLjzjt0TEIOYCzr8oSfALo0962jMV9GCNQfreRBrbYtKIs2RkhQCQeSkSogW07vDEKRxzigHfPdWoVdQAWZQiNu9wWTxZ6KQMGrAiAkz3VZb3Kp8RNzlEMj/G8EeqUsmFLVVyuvIZH9DTktk/tjruICHaSQrynboje06FjYxepxUxkwZ0H7CwaZSHqK4EgRrhufieFgsG6YRu4meZCp17S3KnnWr7W/EJuJN/D6hGo8J0cqkiNFsC63dCIKKjVgbUXFLDCB5AwnuiNAOiGH5fM4ORYrYpbql4H+/reM/qGifyLoj5A4X9VZoOOaJ8OzIShnQ4JXJt6dEvtrQHuKK4d+RUMQT4wHN4+H+fY0tq6Yr4LfEcxvTMJ8FG0wH5VwoDEJ83cbnlIvq3orYKiw0nt8/aaHaO4VNm1BL3u30Jd7fC+oULTQ8XPgN7LXvHwC06VS2GiIp4scTxeN83QuHanK0z2UKnBPsrMi2V+L7IpXsI70On0Vdo18x9tFuOT7QXzt2LpI8wUlWwctLmCxYesiZesi1K+sxwS2zudW/aaUG5hDCjEUxU/yh9m60C0Av+SHML2GM5hvCY2BtYLICMju8IjB5+PjcjwZl4FYOJkGq6XUNZxMuNXgTHxS6BtuQrjDknCHQN9wEvre7fnht7zSydHaKAQ4vwrJtacxWPZJPUWtIFyh9lCv5470MJrUQxRpeojCORBN6uGbPS+scPihYnJkdxVqOEEdM0OQFqLrvtmqII73eHqb08dcjhGKhNgH2U/JVLAbnXJnEOAV6Aw2V66OV3cGygbrgYvbJ+wDD32sZpno/h2WHwp1owC/lmiBNjo7pFIFw9kC1mNbhte//N/BluGTUdAWZs1tGAJHUHEOHmrlvo6z9Bhn4sZZM+Zyf25F0NjExBxD7jJxDZ76TVKdk86SpJ1UNweSJgmClD1aTn/bqolsiByEvOwBkC9sI/qZe035NdSKoCHn97cT/13W02Rh6HHqqd6M3+G8sumhotjwmCpJfoScU2pDXz9DTjk06TA/sInqDGYjzoo4T5lMyHxkKI9OwkxtZHkUqINdeGATAc9ZcKvtvs+OWH0CNTj2czpL8Al8KMEVMIfh5NGTghz9shyAVEkzyGAm9P2e2r5y0BLTFyhnBj3MZ8BluW1UFsglbPJgpQO5psnj4V+lqZV+zDDxYFdhzzUrlJUdXaMZ1fMYsVeQVZhMLEZVnY82srRpClFTRm0b4AFkABe1yAcJppEHupimCsWyMmZso3TH6EZp26RYEA3duOyevFPCMo7NUnbT6CbpsNU4YbNfClAPM/Giquc7TT6rkrx7PJkqyTvHk+cqyd3x5KSS3Kompxxb6d8nPS+61ijOVPhxaOL4yl9WnRVXz+hcbKwekwXvK+OqOg61EheELQeVjwf8kPP/yl5jMDjCou4iXMtjYUcoGMsgnyJXHlME7tysnTGONvPY+UNO0/d4XnitOibLQKicfFmPq8o+7R2euAYSnMMcsoCO8mOAs0h+cZ8VEdpT2YFJds084K2FGqfBDsHl4GZzL5Am1JO46beaiASi9K97MYzbqr2OCBxwDVZRWYnuimFfiuh3wI97aytDYwKFZfeqh+wwiAAZb5FULK0k64NCzrdEoakhZ81Sjzi8zpsjtiXrVF8TMU5KYd5igLe56Ba1lBlrbxirOxSvbHDBCWmBIl9BU1vUxj6qTan6cAUj9xSObfKgtZ4sA/ZfdZGsEYhAn7WZLPqh006VJBSNqkg2nJoEPTahcarQr0YQoNOhRaUoq++lf+ufvFIh6hhTKixCjnVKhVzbCdQIUYFv1Qj9n6ioEX6T/3kceT8/606N8E0vd2qErpaHpDi4/5FXGTz88kkqgwB2tvbycZXBI4irpf+j6o7c6YM+6R2/+D8fvOnrd3/j8ZiXvlH22xgUvDp1naxBQmrd0ZEPvuLC0jKZ8wLbMPt7yG+xnLkTDe+R1Yi5BVgz1g/gqUXOrsCiCFZk26d8g9pECTWL4Z+t2ArrsQ0ZZauQIuQX/vfSXjZAZH+XYeO8/r12bfKUafVIT2QyhE73W+f7cwixEBLCyUrDApkDgKjtaWB6ao5uVF7eourhgxSugj1fz51qbu2oQDp9FuC8if0enVTCUIXAHGMs1Mtu1w6DrXZ4JJXYGVx4ldMdXX5JW5+9tbLDNmOqNq88K3PkD/pKRyxrbrWufFXBGzln8WFMxCfDd2ilOD1iZ47u9OgDeZSIy8PGixWn0QOxt3tgTgyCxBYr+uzLce0WNhMusoG+7EJukneOudAkibj9NgRT/eKOkS/e7L64w33xDgSxg11rqsjxQCz3yRJsaiMJNsx6B6hXpfqy2ARihN9c244Re2Cmj8bh2PyAt4ISZ1aytyMd6KS4mTOMNvKWbpxF+6AJBM7ehsRJvC+11gZqjC3h/NaOVQYAW0UxSsGvtvnhqQG4Kf7rcNHSAkqVUy8yYWLxkdZOHaMyVXilhXBwFMiBsi7BxXNxjd3nAA4owurxQa0VpHBH7qej8V7aF5BTPfuq9r4P22GIQkDSiqZw3s3s7eg4yhELfGW68CHiVN2Xmb1eHtXbAEMOXPPA6sO7TXlaMeqa6pZMKtbBmUIWwAIbHVNHU7l5YKCHZAV2xeoWxZSd5x/IaAopU4BsyRJ3UFmnnxkD3UCWsrZ8GgcxG17u6WAo5LkWrCMYIZRD4Uo56/fap+akUK8afVUvx0ByVKCRug7zmAcY8xnMzyGyXivf/9PeZ/eKWVVC0iLbQNw5Loc7ffjBOXGwfPjBwsvnbSuOXmyfFKL6YoEbACu+2nOeL9xn2bx0JmgBd8XsYWeC9dwt6ITjpjwuJDQ6OB1nv9cnH5XSFlqkKfB7q/t/nRHgwTnc0fmKx6X8rUdbOL9/Tc/cGgI/ILreFR7Ls2p3LQCLMi6eawtlcmRUzzsUIp77M7VCczwCz33jky7/dPsvL7ZPmudeF/O0QAvjpn4nGvqFGcXFcTO/iN5SGvn9sH3qlSNCipr2/aB9uhRj2Pf99qkpBZokkGhZLtw+kWEM8FIYbeE0PPS/0rTvB+0Tn45ZAeZPJ5r63czQ72Zmfjcz8uuMvS4B0CONHDfxO9HA72bmfTcz7ruZad/NDPtqvAJ+cYJZ396D3z9hHmyB1dplNki7lbq0FQZpF6k30dAvCiBkl8wLtET4DEZLF/SzSvoWQTK5NnegqcBC2cUWiTrUdOaZ9X7kgRawm+ZJM6zJN/r9HU3tlc3cxnxhWYGRYczSDP4uLeq9IlOV0+m8Mzx9p4QXmFLBPj+vW+FZKab9QkxqHNp2HZGrhYDKl2X29rRtJlrvn48QODkKxg3uBS3PzNWQJzW+ybmUspDCl9IXpSM+LlkqwXUEFP1G5eOElDqyGHeGyYcVl2TalDrsv6MdSgGthVltk33TNmqvWjd+8affPJ9+PLLPCRVjxd4oPKwRe0VfnRWt5faMV21L9vqK2+ddewdrzts0K56GOMNpAgRTciGNBUfUFOnR9Ep/L3cr0AHKfRnTqcswUDQjBkc3G7RxbH74g+jGrlkdO8O6bBku4T4v3wJduS3jwILjPIMP3YeBD92HhA+Am0CmmDLCsllIaadglGCaE3DX2RcuS9WCpnhvO053TWs6WHC1XgGDAyPxbMYM5OZw6zOwHNKxkOES2nu6qWNMnGeC1PA8lvtILKznUEUiGOkzRhr2Rzeo044vmaUg38ZnIV7fp208uXsimhT4xagIPDC66An++LCC/XyFv8NLcExw22WB0UTLkVeFowpV5aa40Qa4WO/R6GuUS6VG7kPThABn1BqsaBvQ/GaNe3Edr9r38UfV8fbh9EJy4xWwMfDUqKa+LtrR9ZED/IRhFxQVXEHlOnp73z6LBeS10R+xz2Ie5LcL+sIBkreF4WpAtF01WbUa6gqlxtcIbN6+Zv9q8J+KlcrqZf0Dx3gPpQaeS1ikYvSTCUAIXLD15Z2yhwLlkOp5c9IKlS8GezGPcZ+be9VxExm98/VV9jOJs0kNVFUGWabV1NBH+eLIXNIpkOkUoEVgvOOc+vZZjfyIfQqoFZA6awRGAKKzvI2LbWmpN5JhMmS6O5J90EvzTFqAROVc0/6BuwFHyNva2CyIHxCfsrxzHAiFBkLNSk/RFuVUu67vGGhBedINBOkc9TFHp1RSJ87JphggDhyjbLdbkQ96IuXDREI3M9vLPDPrk3ZW1vOjUb6ok0crMVPIEUscKDnXdIuaq0KMUC16MkwTfQtNKRvINS3bpk55I8cnjM5xJj11gC8dRfTct0vrjKRNC8ymaVaes7QNV1m20RyANmf8lUFsm+Utt69NlKyuKOF3knPdU2izYllGdpMn97t0gxG84PncTizvWDdBtnQLYk5yD/N2O29Vt3SQYrQgejZGbfXQ42Nj2mGTYvt7Tqgdtstph/3S6MHHhZ4/rB1mDyBUTqgJmmqskFdVxVzthWoDo1BwcdkBiAPQW4aGCsWGhDzJQxXy+DgrvRSV4BQapkq4m6J6jFnPI3fgPoYLhvAgAmssPibcBJ6YeGv6Z0nqQ2LPf7ifap+BO/13F+hUNItB1NZXNG8i2QbXKttgNAm62irR1/1tbR23UsQMCBQqk0nitzBD/NhutolZAp8OjiVu8WsbxVDb7manaEppKK4swjw9drOt9YFsZ4sm9rJNalf3smnfl9toFWa0ZXlz3cs2gLppPxRMb1CcJ5QKppqbci0Ovd7euIFbgbwpT8IU3Ffub2uH14sM1oPWimkK1EkrtY4ULbxkgyODYkaOOOHIzCvFLgBZRPwd9wB+LfhnQNP60sTL2iBv6UESUAynFMMHKNw1FJtqjhZuvA4GNHOEv2/lMyRaq9VDLznqKNoqXZHzrwfe+uU/edqPXa7nX26Mj13M50QVFKjqrraG2+BXqqBaFdbFzLpLyahiiX79CIPkAqdggkOgmfUBN3Amb5mjMm2kmLCnGgq+sqfmiXG2c7IcPXw2UCqsp+tAfZ/dR+Qt9aMnftbzpBLvcs9UPtQtGrsYgLMP+52MQYpjKLRsbU22CL28bto6pbcYeKwxMkV0y77wB/7H2//qGZ/68avaOkymGfUyAROp5d6QpfLWIlQOk81TMkNScbrlMlQwQlGdPOOoEnf0kyov7kvbBW9FD9lXEWFrvTI27uCSAvAGVdp97xjtnhTb32Wo545SRzcr7Ekm7ox4TooPcus+wMHbsA545Qw0e4+Sbj0d8/prweqKLM9Q4f81pEFzgaPFLyGeeinAqNDwM/0xH1qPaJKSvqDUrrDnyyFC8pOIKo56XMsjm4Ei43oAGkmq7GSvkwpNT88b0UtWGxAfONGq8w++F6Lr74FmtZj8UgEw8r3Hy2OJsjf1x2XOdZU5i3UrOXWMQcB5EyOIJpLmeFTSjMMUtUXNS4+pzSfcNZbWHfUKUX+hmhE0140THb3wal3AqMKbP0nInJRC5hoYm5pVSq4jhSsWgFm/i4E89JSsW6AutXSmii8KAK3S2H9J8BOXZ7uhjAvVhmPRVlexUWqvi9k6Ga2+tcjxZz/zjyEW+PfqkSHpp+Rlv46IomLbAg+DfVi8v+lzEYKeG5JTD5f4R99hWgY9gl5ETVSF+KdM0iu6u4bznnuefy5CvIndwzvYPRr7VLThqRq+5Dz/kvKAkPyho0Tv9NoPnV/7IQkFl58fXM613F1DNfzrKv4SovDrou5HFH5d1I0eovjXNRBa0d4F/AcnokjGb/Y++8XtiMJv9r+vN1HvQRR+XdRRiTpajTqGKPz2N0TCTzUx/+vh1zVIrP/it4waOyIram5AHcemI2ZYth8FmVH6YqiNPZ31Bc1UnRWwxTk2VMB+xc7FUE9yBfLuUBsvdgRgGWakdOtOxddKPDCiMAyU/YaSBW2zcIogOb97Q1Vd+P3Ik6ZPRptV7bq02yJCA09hKIeALZHk88N6EKVI4koa+D1eUFIndywJ2n/3tXpq5Kv7yDywcdAUqJ5J6g22P1KO3JCvX/Z8aIo4HczIuK9A2aGqXfp4+OrRNIHKDBZXJCbi9Fjai9SEkh9Tzc1MtTJFr5TC7CNVXcyw1MUM5VXUBKCLyY+qLiZeipDiYV3MJ/MQlQZaov7GV80CFumpdgQlPm2qtD77LVQtJ9bRZve3fvPfgzLmx8OqA52qZrttLcIoJVYdhti4TXalKPAyMk6v1VEaVDevvgYfzeGeDqxwBKulSmZoXL9kRm8y4RjRBlDNWcU5HL7rot7QPaxZ2BNdPfB5rse+mtkYnDBrRjIo/E1PclNRqrCraiCi68nHuRMWWdgzorS6wgJ1FS8DVaGsHORKvChU6V02AGLT9TUq19cA62tgl7nUXNASnLf8V2REmXPcGeP9gxrILQAKyqq0uESKoxQZSj9O2D0lziiHhboym6H0FFeE4WW56qhYU2xMn4aVIN3kczzlhNj+npPQgYSu5e+OigL2lCqQ3Yoa4vK4lmJYOINdY4KA3w4CuFMu7xrc3ajqbSlSQWFe5n72SiGhMv4++Jq7GriHU1+B+RWIllF5VH3LnG9kH76RryB/gkgtYHbgavIJzwOeBrASow7/KvJxSWJV9Wnu9vR5h6YGt+NZ9Yy8Zr/fsIE7zSd34Xmv5zwjCwVracMSUYe6q7EipK2K7RuB5ngPP7W3XDviQEsZAfqqpH1HsLJv+m/Ovv6Wn7/mCcYJfmgzKYTc8Y2CST/K/hR5VanhaLRWNSfCBbP9AqTVeM+o4DROkFOsYg2Hcdf6kI+Mqd719Yo4K8Ac5T4Yx05djKdQhw2/omzJhg3kjqeNSfbCkIEvLOAbUKkS5fb35UFVHY2C9IahK/YHZoavev+xrjGo75hvrnK4QvXVQ2qW/SmyasOwFFijC3/FlhI/4UrZkFK4nrIFFK6nH/Y8ax8nKfw1o2fIU3yjMFfNMN5HCqdoS37FHMQRtxPfLItpZVl4OF645770Jhe+WZZB+kxHAMj5y4rIv7C2yA8PynsRBVhcdOVUAwgfwC0e8dPMP4vG8VMEwvQXAs3IaZPNlMwXhdm/IDX9oO/54wufc4Gl+nyhtTDXD4USMBSGXKXqgoXNP3Ld7Vtf+Mvq4L0LwSp6AUZO1Hmkzb5QVP7p4meRG/wKNFj4Hr3SxVQdP9l+JiHPVayNdDm0apWSPSsvs/tDGoiuPZ5rj6ftqaE9tZNojG7xUZKVdYabQPSnDiLqtzwffq4EXIrVSjR9J20KLF0OzW6wcgFAlyy9PAS3iMJvov1YrEQ7JSi9uQ+qRlTS8auYaNc6NKYH6zpvykqUIvQkDUl3ecbI1ul7+ZLmevpDjBUTpAkQpBufgHxVUAmKkSjkYalMLMD4JtBrRITwV6E/5ejE3c51vzCba/UHUn6WPhiLSDfQQOg+ZxeSHYKAFyFnRpGEr5B4V1MvyzsSm30aDRChws9+6tR703Omn/hsQFuGSxMNC7HWlHHAHq8JtkC21nUVA4hDvFAVchOuGg49kSx+4imBrMmoXBGacTTQZrSQVY3Yk562N0XFaiXPTAcDSqWLljGRXvLLrZjectcmo8Bcku9IThHAUmRNzyK/RnZdpDmeudscsKjxfCMmnkKcw8Fp6VoLPDn0yGkKV2duyadT8GcUo5HSeor41IPToFCmn4jZRZqh0NSqzODdOGWjjOM4qaOdyV4nfPkMzazR9DryplYfL0JLIwaY0Xm4t2ptzQyK8l91SbOiFTKxOox3qbEXRiW3Ev6wj8vc0tEbP/3z/TxwfVbAh4PDeQRKKoVE2aekEP9ZRYz5IPY5YNTr9B95/W/+w677Lh5cJZMu/Q3PC9364hYXXKIm/1aOgr2u3qaLhy4dlXWDRaj6XXS87xSGeq0oMJUfuQX2DG+BVhysGVKohY/G208Tti0besb7Hu7hNFcqUCHk9vludh4OGbhTq8TZnwE6Ih+P0MF1We/iFbUSB0yR7XD/LkW5+r633HvJOd+ErT4MENOdaN+tt+Df1y9mf6y3J6lebdW2hOYShl/aQYxKkgD7d+GKjPL/1FHGvup2OZzjtNv9FUcWJJFnjpiTrlUTlEBAymno25a9PPoxerwmlueTfj1v6DV3W6Mc0TTVxjQ/eJJTUOUHD4jSv0yqjWLKXcIyNXwdt1/uQxt3i9uNCL/38XL8R3pZSq1uDJVIPEfr5O0vmEpQ87JegWNJgkql+HGYUm+9xdStNKXXwiheL6ZwpDJFKax1NCjBH74kfIup6OH8NNPDt3wGji9W+ebYRj7r5oMqXoS5Bx0RmRstLq+YB6cRSNnFAo45pf1KldArJUuub5JGJlrHBiYKFoEZXNCZgFjXkqhFTPxFxB6MaNHGBsSV3g/UWlDgoaLhYs0mLtNQcisaOdyEzOYFFjz0JlRHBE3BQKEppg7SiirtebDGxfL+giiFzstGMU/zgyPk0xyQY26jNIvJk2sAZOqLK3kPZNmjOerI2X8HsWDwwIo0i64sE55u9WXxp2lGBVvY/api48noyHDpLEfdkoKmzLimZGZPO6k9piEzaMAMzanNeqpRl+s7j9sCkms9MucNe4jf5k/afWvcUkm1B36LA6CosvQpFnAQYsTjZsN81WyYf5FlrP4oCptyyBtea2lDWNIGQwMO+naniW+H9Js8axag7+exNeviE/+xWeG6fqsyc3Bf1uofVDTwx5pPqi/OM6yh4pT+i4Tk6dVVStQcD7UppqkVaq5uqPpChzqruJvVHl6n80iUtKDkxB/zkKt6BiqIqZU3McsRlSrTqK3Ls88o3RuSvMCaZwft4tOp9spQV/p+9dg5gyZmZbnH9NZbtrGhbjPoBoVV9c22cCogFhlTbuMcraNGUouZSnfaFc6zTR0c/vOPquQJsDeKWT3Q5GQmQ4Nimmb47Hjfj7zpr8/de+k3/j9yQV7AprK/kbwzcAazQn71bqsSP1cff/nNDz3u2Xe+kpeu2XVuyfef+fK957zrwYupvb62dnjf//jry1/xtps/dzFGob02UPtDKNV9h95l2rxi8+8HlVYMTOjei9fWN71gG2Fw1TF+AVDogmIQ+uV+pMtewEit50Y+jgJavBbr9ICEm7xB7i4Fqp0GtyonLthQuZZzcA1r6k3jgYBj27xXkpuEvpyHNjhzS3GYWiVnxgt4Q3hVIJS23PJXCTXXYC9H2xmTh+ugavu5v6yGlCiSXfyfi3w4HsAx8xp6cHhgZXrLe9fLu6pn7F1fYw7gAc+4Sg9VqK5Eb8iycaBHeLfXGcKju6LQ9MGjEMyy4Aa6EVjq5K5nYOnPUMSv/Nzl5zzudbP/lZmauNyFdffKhVqvvLJK8REtDWeRXExdrbjVKVTsR3f5DxZ+06ELuDIKuGf4Eh0Hb12bk2hzPGj65XpkkX60XoewDaIaIEN56+2AX9I2XXfu9yb6Cwl5tbmXkwiBu2zgqA3cYQNrnnDxSl1xTKaskIZGSMoxz9LLWA9/wBsN3C1WoTHZJGqZoKVEiVSZmacADYthSumaK6VoDbDgHvMGlLpYRK15vFCluMnbT0CAlM9oY21Y8xAQnIUVKbwpIdZDUNxhx85mN6A7TKhHFXCmVJLcUZBINWIG2qGdKzDDskrY84AE8EOT8H3bKq05FRCaYoKft6zmnW5LlTm4z9PB0be7PR0hfTuGtzX7lvHLMftC/HK3fdnNL/fZaysUP82tEmDazQjH2f/S3ba+Z/9b3jQt05WhWdF1Mfd0aqKBiU4lDJ+oug60dLUQbWMd0haujatZEhXMk7wkg3K/iu1Ux3JHbd2tthV65r2L92QNX0ypj7dhfaYOa7gW/KOTBTkiq9c4rPyj0FBYY/tdabgLptLFtqhDcrFQMRoUOq7oATehy2kcPWVixrSrMiDXMWOPheeoJeV/7Pmx0bZQRThneNunQFiMUMU2eudYnT8FKk/zVYwFUipu/DnJM28UKzkXRqPhetLkweEvhASKZdkNaq7DjFTNgpdLwP3sisXuPBgxgucZg8d2U617amNdMn2LF9rNmHRKbxSKQiT3puyG1RySLrvW5olRKG6Qn6tl6wa7sjL0VNhEvcOeqjW0UJurfKWuhUi1NxkxoeTUzrW1qBurM/+kUl5U6lsX70kRVJ28l2EKfgkk2FgMg6FiwP8WC5brOC8iyvyiOlbZGAcffNI37b/aDSXN/Gbt/9fTRWrzDGUr7r8OE9nV+cyeXtY1rSp8ClQtb8BNxcst+uJXrH77EJz8TDBkRzcetr0FsUV29yTjWM6qvLO/VXf2t+rj9rdcuqQC6g+5GmimdFbKTz6LT5yN1b90drjUZ4M5E6zjzLy8a78fv1L6U1fwexF+LlnZz4ZqV/iPInHdgz5oUeJWJoKpruRStEXahbi6zFI8wqLmjrlHLbDWs19TE2B5HSOE7Hmdn6MWWGN3BPe7XqhqqVUVgVg7WkfVoVEKME4N8NakALLTb7K6ZgCjGupJBD0PQTKb0BFg6WoXyglSAFEiceztlxqIq2PqMVT/qqo3EJV6AxFe1dIs9AYiRDi9AbwUPLLDegPfj3P0g545SI/7n7CnlDEyhNJnaT4ar92STmWfK605xZtZc7rn34MCwZdiOUYtp+ia545wahM4uVjWVYAfeI3jxbNUlWUXsFNsDODgpwvoqJET/sLfR7Uq63YFjoUqYkPW2rsZnJ9fGhbZyeJpCvf/upJi0W6CVb1DaHdLgjcLINAEipzRhy9izGAw56Ryf0kNDmgfIribKBsFqA+qZ14R1KzMud6fXlxusHAg0e0NKNxQC5H77KXaQdX2y3r2t1JVHZZ5wr5PIVZb1HwuwHbcrwcFg/U5eqoltYFaUN1wX1doWPidyxWxruKu3FPTVZqDx4Z6hX7c7O37+OOve/ab1j5/8cD0S2Wdv8fvZVtDbqvemJ/jsuzVt0hLpDD7O+RSQg+QZn+Pd7MSUgLU1jVb51YLj/6joFUCPMZ+KLtPvgBeYwDgIzxcPc/fU+nd3krvMKaAnwqsKbysd56/T6rWPqGE3dmXTZkRxHDaVGndVxCvBGunHptEirWh0zrQ5G4leXk8uVVJzqrJVEIXv8/JvmpOMde8Yf0KR6OckakJsaBqJ6dg8YVRBQscyFqX+07B4qnjChYXVZL3jifXKsnhmJUo18A3eeWNi+xraIzzVBHA1YJMJpPCscAj9Z0XUlDUTCbPZXqytXVANRjWARrhC/XDkIdq5IZCzVzIaSCoHgeQf9wHwe1REF6L9a6yK6+6GCmj4Ymh9M3AhW64E0sYYDGz5h9ZRBMjqzXuqgpx69kXhRiz9hCeg31/f8E/f+NJ5/zjxWtiQ/aIO/+0HhpuzV6LnEdwmjluKTZQEBj/H26GFlHFE0hd4VtpmjDtiXjU9Ib7u2k/vWo/GzTat8Zx+9b4FvoWWd8cCbAhIe2Q881RR7Y6sMADFoz0E/y64sR3dE+xyZG+FkmvqAuV4AD6NI6pByPP2VWsLMRiOKxQ/TzME1Tmu5siVxbxhbXMwcCj6maCYtGKj8CW7+KHj9Iq1gY5HUUTpMx9j99A90Dn4U+iKyHi0BxC6nNNQnNqmkfELg9wJS/kXkC71S6u/6DyNf5QCefc2FwTaotz93i1iDdyz5hz6Qy5EPMpxti7OztDCgl62WCQ809VD4a8Z8nmV1dV2UKRVzE76GnCgLwj+37tQ1fd+eX/9rd8DvZD8u/XnB6CyDXX+YRzcRWWH54tZ46auvfWo+v7ltY8/v/7eI3m6zQiQPOr9p+1EvIsEn2ea/aP4JRzDE9sQ4G8FEJPx9NdHUbb4mQ4jpMhQQoV3jqGij7gcmVvqEGTKs4hszQ6OlVziO9X1ShlObJSBWvOQf/D2RusG1f4tnR+z2AOb8M6OtOjXwommQM6POikplC1LquZixD9Co48pIoGlXLhkzKYZGAMlSk7rFbPQkSJgUS9BuPDjDkQ3DjICNVnsDekhQlcEoW2f7QOGFt5YLRoQ2cDCzvfIBp33TVuWM5YaIt4cwzTcvUh03IcG6lpOYw11dXomxgkli2aaJwnFdG+hzMNTw+56uPm5iIYm0NJYcXYXGSNzaFwYWkOqyI2Ll03sLjJHRhXe0y+0xrfvAVRxQBdKAbo6lZXv06h09XHFkybq5scEDBq6BYotA+3SQpI/exk91Uc1tZV2SWyVsPUQ6gzPXeHequ93veaFdRwh/bmzP5+NWGvdG21iLKvSwRGxCrsLsMpKkZdd+p5orrMDdWrb6ptboh1UcjzClFWblkzAolEp1y2wDK18dgZSyZ+IhKSvdFrMkbZN9Klv6Y74UCU08QTUKnmi8jRGIeX129PUp7aVm7Wui56sRXnexUVcvQwwmMP+guR+dVyWAF0WKUQu6XsnwAcDOrQ9kR5+QR7B9xx6YuZXwxUoGrOeUOLhdzsXDGxPKc58pRjdg3FtFS9DTF9rhY72xWT1OYKEV9MWdMf3N5UtcunNvLOCP0Q2XFMGUVDFKRjCIgDt+pX8w8ATC1jbCKfwU0/NZ4+g6Gb5SGpHFuqKMhFdLh1M3C9WrkYdQQHrWt5J7U1ZdQZ4PZ7RT+cpmm2Yhk4k2O7GSTP0JQMuUC6CYNmaNoco/9oT+e5MQulaAxWn2REoucVcbXvsvGyBLTouEpd8Mpe4eBILsjLh1bVEVdgC2CBV/eDPOu+MF+UKvNIv1E2peiYm7yZ+Si6uvJFlzpoiZSpPTNezostGN8uZQDVIiC2iPgsV6P2DMa5fIa25FMBIL4okF4DpAcY7PJlTQAJuM/Y02AdhaH7mNCbUfLv67pX5UUwppnTcaq4e+N4bt86hpZb69EWaZUetnekEe5kqnq8HqPqWG/ajtQjJLZYHK1l8YitpYa3teoV4QnVHqbsyGC8QvR1jraITcVpnUVL/YgPVXqK8Ms6kWYpAL3byu1ZkrWiLraRlnDdPUKo1+eSYXmUc2yRJFqCcZlt+/PtCF2TE8EKAm735tTjUMihgvFzB//txNox4Tb6KXx3/HIKCU+sLltpBxpXRCoKCJkQEcIZh6/gfuyUfkhMcQqdAvMVp5Jktq+ncfu2cfvMJclpSrRAsQl3tci0NHwFhzNOX6IEuFlEki+WtMsln4b3Sr5ZisxRAlAM5nx2cVwyEne6UksoLUAgITu0GTotP0XlKXKl/hQ6vWrqit938TvFSLSxM2JpBkRVC1N/BSBNdGp+CgGDrbbhNnvVhDAoBRUAhnZWu8Jlan+1N/yq1nuki3m1QyfVeDSWh801/yG3PKXtOW79Mdo8Xfb7Pe5LKGMUuca7kUOc64SM/XAnepUxDGUM47Kcy7kcM7LVcnh9GCvnO3eMl5QB2IHd4w7aCavGO2mLdW69hIFvMAwWVmX2zarteuqpuRZ0m8tbVtUa0XqtmBiATUTVpeQvdB6KOi/FVbsjHbnwBGNLaluaZrhuwGZFFjZQHT1dtk1dwNsClcYs59DGNs2Bt5sbkj61Sj/YLdIjgaHktExOx5IVdoYHoWTVMB/E/AhTWcTDvTJu4s/IKApLsoJ3XvKlw9Gw5lJEMxiKxNDOFcMYaDWVGlIpLuf+b4AdqNotmAdveAXgb+Mcp0AzPV7leU2bd/6i8y5Noco8rgwJWiZWijrVNTwz63eVyLv1G4NUknyaolmcXs9Xkuctb6GXv5Xtm0Vzr5I240LcxuHsNbLYL9lFHYxDToryjGKz9mrgFktxZgEJnmOchBAI/hz/bYVcStYXrBfYG2zBSPawyZGbfaOLiqLxMrEIeicWDYXj9gB0YgctKWpvo535VKn3PosvtpUTlAGAg+BZHu0pHV1ZF6njLqWPsAMzgBdQGQCbBsCqE456iOvJtCt2aJw2UOYBLeWxNGMazZihaEW6iOe0bncimh5biIuVfI62osStRHZ2bCmRfMukOQBIaHKI5Ksmz4GzKnMgz6EIjy8MouYYihmLr1MVfJ2IqFMTEXXm24CoM0DUmRFEVVpSRVTtQij9GELUaUXUwmDotMNQMJVFiaE7qDAYutRnpOQ/shgKnmcOhc8dH0N1oLfS8kq+XQG6xXA2W2gnTVsM3f5tw9ClCoZOGwzdAQzdibidGqcNVO346XxGmrFDzzHQP6gZ7rDouSQ1oYyhmpYRs0yEUomKkoaXWDo3CUvzMjkfS568x6z1L5I9pl5BNjtNPSvSkdnJxeKTArRBDtgZvihKfZ3w/OzXeWiB0bRTVDxm3YzcxmRjStySzPY7WMpWhLZbsFAEoA9vBmHmK6pCIqEetuOzWHhnK0ucAmSnijd2orM7q1MSBdkteLuBs3f9i0Sr0JvkoAwnqs/QbZrC6VwISuvaW562jequG5718yYez8lTNazeOM6hZJP9OVRsCpnvXIxsr6viWjlgy6dKt8xTG8L8FFlFIJlPS4umhoW48NcyLMSt6j4B7DPw3sk/lfa1qSNC3BmtLm+jSxWKQh0rxO0cX4iLzR8733RC3Da1NxXidliI204pc7u1Ung7oGn9UM8P1tYoG3VbfQRbt8omcfdeSHHHe10D2c3KeL7g5Z0EPLIheMwAHlVfOpmFR3Z8eGSUnTw8MobHTEWG3CHL1iRHB2hUe0ykDPilFECJGSzi5iiop3BDKBbzQRBQPKucBSAwhEzMxlVB+lAB1/5XA1y7AjhPK6GsehrQPjIRgrahajx3rWBcAR4RP2nGngZ446cBHmU4hxg9DWBwAC5X9oYaNHHoWjzFoDU54FE/DilwZ2ptiipHahn5lUNSzN8q5mTUsY1vjzc+ozY3vr3p8dpmqFZD39aYTgrBK9WkjV53o2qPTJzzIiFao7qNzzi+6fpA0QA23LjAq8EtlbpcF4HBUEOAd9ZA9yv9lptYKorHjSal088rmEC2S32WAXeP06YoXt3v4s/R+LazzFZF3fLuDLdnTd/wT6vYc2kP54GzFDrtC2UDhtuMQOt5si2semu8O/SiyoG4r1/oMUx1qK2H/iKyx2lVch/rQcbYmZ33MM7swvEzu7AyS0M7S8Pjz1Ju7Mmf2YVyZkfRRHIfkz9E7qNxch+qz81NyL1fOZbWTI7cnxgeURUeeu4UVeARWXhEx4dHRNHJwyPCJYAhH7ZBldxPPEH0Uz1Zq6gpvO/iwbOG1EL+eTO1EKScWC0EmU5aLeSfT1It5Cbfa4wr1ug8SAprdY6ng3p3Egm9PUgzpqdi5EgIF8JxrgYrivxXnqsF1XO1ujtXSyhE9+LyErWrLOLK9pty84bei1GLS6Hy5z6c7Ikymy8HkoUeO1onrg0xwUoRMsgjlAfSzHEZWm4VSScckD1TDHJsbvPPGd7CIbU5Dwz1PDASVI7cWak7C6zY/Dvkqf9e3/hyCcTPpr7kouqABtaqLhhVD6ki6vaMF1TJq5hDnvMjqIrbLn/F8lyIx9B9myD9HumasXmkup1yHmhFR1CzkgpdxPJIRPqbQQBmPphAU4tgkqYRmh6ip95q4TF7/9ApKfaKMShHPJFyxI6S/qtQjsnaD9HD0H6AJUeL9vFxtR+iSdoPMabDyWk/VGnXs9IvNOOGWui9dsRGb1T14nTviE+mzzifTJokk+ceBM0eN+5LHut/iyXP6mvJHpuqXYp2mSGva033j9T0JVfT/a6mr0lNmCTcb9yKw6Z3lzZLz1oTuUgRws5UiD1yS65AVLcjUxRAp8AIb5LTAzo/IISMJmamYb1XA458l3/ILzIVIWSUrpi0BB4PRAG/j8ZiC/qA0ONpmoI4jQdlqjQBTmLLvEFtHGt3MCM7o0dhU+iWZ5rd7uspbpA3q1DTzlbgS5mKXZqp0vIWxqBD0QR95hmxqh0RnmSemXnK8ODm1NNRR3VvPI0LMEmeAGi4UJanYAAVdGxpg3sGiTo63cBjFhKoq0QLKwHJTtRbsrP1nkosdXBNCsIfriFF1ZRyDB774diWUrWSixptsfx3VS+fLlUEAMQGlyJyRpEcwdW6axvAPU11+fzKog4P67OI0DKqbUPL8zkAEA6mAD76FoHV/FcEVvPfAFjzFBNMGwjQ5igjMOPZb8KKTvagTgLHw8/T9JFijubKGD5qn14vN1Y0ve8/ffX+39z+vF/0uMmzAC7m3L1+KTZ0howgzRQou20Z99Wd4Yu4k2bXyhiaPbIOoIlUjKaHNxxBrXb1E5nXE29fd/rPUkKcqDpS0+AD2j9H030v+wY6xnUjD7+K+RzZ/WP5Vx8G1mc8RH/l9uPMuCcG0evX1tl3niW1obshFE7axqh3fw8+opmhuuIaHgHiMWSucUUpKjVAKJqii1Okk4oQtGgZGaJ0jqkRWmbuyKd5x5CZKSNVXIU8cUYljSz0y9Fx/1LVsuC/RbGl00U5zpXODC3Ab42ciMwL/LessJDZz0Pk5b8eV9DNlynkL31allZtpSXq9RMIjKW0fDvXRpBMy0q/jZbhn6QI9X5leCjkSLwQvxzQFz0Uvy+QFz0tvzugrVoBHD/kudHk3w4mdJmW5Wgy5/ruDpzzm1HHCYrmfU8FwNdIL4jaORciEmcw1T3qws1BSNNy21Nwq8tB7ftWvO3Pt/GH27njJD2CN6ntKw+zUz7RWKcAtYfeLyK0n2g70HW7OTynDi3KqGyvAMxVIMUvA28Q0sPi0WIXUOwCzSnEEvE6N6cQ6zCeqF8efkxRhu8y3dZL5S2YUSmsHv626rYSvC0VO2jHYF0OxbY6UnuKXoju8lFF3ha5MRCVtANcWLuNU2hcPTxSnEqnDvLT3Lc7qCt41pK1tti+QjvpNNqB3NmRYhftYppw+rAWC5dIol7AmU/lDCXJotPp9PLlyt46Pjdf0tGBEwFa00qyhdjhorkxyyDOywKLUyoJp5hjMqfh0KS6tFf88oZySKMlLnNXtqPgFojzDtkj7KjoKWoN2BdqQQ3oN8rnhX6XICJHQcVJlKBHTl3L0J0F/W5gf4P5F6UNhDki+IigL5HqBQWRCKrTIk2fo7T/nJXiDOqie3xmeCa2W08BH3fZ8/Oz1ML82ZzaXc230DSM7IdwtXOOGBvIH4VFllNfyocTQIJMhjZBWbt1tmX5o3U65Y+hmAoy0bUix8zz7cwrHou5x12YoKhzLmYiJxECxxDAt0cRwFd3uK/cPy1/zWY+5IGEMszOAi1+ND0a6jqPo8fQYxA4j87mZfVMnijnMAV+VD6r9FYA5iwEpDhtVJaPD6OFOC1bYrCMGa0ub3KZ+dsRq0EmVTqMhGG8Wydth0nVDBPgKRF7ZhAyYP7QNi1TyQkKPa8kBmSICy1rPbQdEc61D+rEF48j4oDNPJ5tGe3BnSPCWGp7pO6trj9atbbj2103bQVC8VzDYxu1gUztPsQfMmHaxl0Jzf+bgWab1pqTVAj9AkOst5ZEOs/5Y8KrlimVUl5dBch0ltBZwoNoG8gMK66pLzL1sSRzk8EQwf9TTrbH+Er7CygtUVuRUVemx8qi+Ri7QqElxn9UTtvcukSPlSaP9horx3agMz06zyEjo+1oqprG08aBCynbtsAzAEHfNM8z/s9ADvm55ilPsRWg448UQI+lZeMb1U4L/ljez6Vz0RQ0D61S0G03K+uSavONLKxb0eQ213Wfp204Ztpwh7YBtzKlS5wROCXrJEZ1wSLdPNiFeerg0aEZPGaUh5glD2syG8ESkZxcq2VqWCrFLjJYxNcGLebL4EnHyAkANZkiKeMhpE8DhuHIldmokJg2RlTxLeTgdlkW2rRs0pn4ltQmAywVbAALMf+3LAwQLC2QqORwoJsvWUpDS/kClxUWSyhKuSWtalmxTaokqfI8WrbIw/oFyK/1UjiCRSE9TrJmyKrJWZmcKUMHjCB47OOmcU+41q2CaLQw2pDQNGT5OA3pP+eRaMsywOTasgTyEzryA8noScKnbZqVPPIg0tpJa7cTy831KhHaehJEaJvyipgafr6VayLpp7qeHKlL53zOn+RLYhgm3JTqbKtQHToB1QGZGaE8SnWWEAf8XaK5Svu6yP5/FSFS9l1ITR7yw+dRhEM88qx25TJ5jIab0hJHORBIS9pQEE0PEQgy+TJLqs4FqVKaNZVvV7JAzAPKBo7xFx52oDHKVeTnSYDyHE+uKj9fAhnDcUrIEkONclFutZi/h87TgS7Ok3iJvIByjeSSHsf/PRZJe+h8k/N8vF7AsfLKhYPNxEqE+bhduV+KObt0Vzm/jJ+2f+cJQAC17SpLeJw2E8USNyApbAe0BlvOudo9nZHaZZuBg8MbPjfLdHKceKalUjc+GaZqir+688amj8cjdGzJ8gjdUMIAxPYVmYiny2OoyeXU81AJhBZIZjZsPc5scDPh0W4mjCA7jW5kOW6r5HwsQ17nyKPtHNmmc0CbR2YubD3OXNB5kFIkuwH1sqw7W305hJcMmtkQwTUuNT7CGmq8LXhhP3h+3qOUumYlzH0UqtsQEZosWVaKYKkIU8Lu6I/6lb3+MftCwAb7shsj7z/MFTxiaMQQsjgfkoInAh0EFNyUTxYR+JPkDJRPyDktixZBeVWW9JTCYvuopMKhqWKcbYAteTLKjVeWErkFd6x944Wj0pMvfXtOOs3t8ak9kEwxbx/hvnwLM1oLYGhUgaATzo3wZo2yxR8XElvVy7gvhij0ZQ0vZF4O4SUzLwfwolbZePZto95T8hBzEduD0BxjGwtBxTIelxSw1TOO1nnOXCxIAYQbuhxPwP3H5jn3NtfNPC/pKZ4FEwFQgn8CRVDarqYG7enLsixrtF2WtIoYSL2I6o7OQHkH5l9V839HhT8odyUAszEbyZ+kF3netaX1pZCCw+KFb21AEURKVxweiGMFr+BEd1A7yA7AfH36blw/9l4C2HzJ12PmxgrVIXvhKKYB/Babt3vxVjQq55brepJQp7oTkvcKfK34K5/d4+N3jUtfFWuOPswMr8jdzdr34BOqq9m498I4scT8aG+PXx5t44g4rzn79mn6L4EfOGcWdzjbiFZL8zPWlwXgkl2PnrY9MfgIR7vW34XcOa6dHhz0+QgOQR7O+5Xu6su9QpGRXQ7hIr0oHqkFaHcOhyZ2WVPgNgwBpPcwPnSzeakh/6pelb2J49AEQt9u8lfg4AKNVmNBt/vZy9BSZ4T+Bn4F3S+bi3bgGWZfhwxe2yMSfJwgEOyF3sPF/jMSCy3jo6gCH37CU/94NTXBJcbO+OWnkO6qvBFVIs35BHH1aQtCnqxJ6R/EKKJ8odQ3pL04V451qHXkVzcGA9ywubW1uiH6rTpC1zhvI+Njpa8vxytDmAfZIDwsP11LgWjRFjEeVwyKOiM7gs8YrOEzBK/mYCjNNQYhKa6orNVLFyaDinpaGV67iC2RLts2vQKNMOFXItz32JFacN2YMxXnueSgfiKOG1SDRf0g5IHeYw8r/lEwZ+HXFh+uwknx09JjjVB87jjjxvd5lTvUsBPzJU9Pru8elCfXRw8jaLzp9MVm1KE1idrEUuiapqpp0Er4KMJ6EH5TGQzu0uCQL51jla/urYTv1zAMot1mg9yaI2Xwbhd7UGJv1jR1vKMn79K1VLt5n+umtOsevEs2TdKivlT54tD60BfBwfVNQIHmutLkMzen7/XsnGaY32NeeCzLOX034pQ4emMHhgVb6PoLzoD6Yb4T8PgjPDc8JQJ3e0oEKpToDq9Kita8Ki065B2fGN0Mm4PS2c3Nw77ImIB9jnk+w9ja+q2Lc2e1Vm3ccg3DPcvrpWGuPAaQ6mJTn2L13VPUWQHockTve93f/traP/3O2hOffWHtqRRsvgywP0ckw5IYTLr/kccxF0nwLxDcI8FjCJ6LII6BYEUMwS8hdpcENxDcKcG7ESQE1SzZsgTvwmddJZN5rDVm7tM5V2PL1Zi4T8HnBowQYr8gexVmd56ovVoUx+Qmr+PxorxRXUqZ1CduKeU3WB9oHMFVIYrhQ1UBjKTCd+tqfZ1842q1uq7Guq4GZzNOKV2u0liDEczjwJuhauac4dfeP3gv1lIfi6hf8WimiHS/r7IdfCEETsGmpEQ7j25teCj4S172avTcGC3W781GHek/UuhCYmw8whp+eRHjk4mhaMEJKdqht5QT9771MYp29M3Ho2jHNJUQvrsSvg9hpRwf1aDMkl8cp2gHJE6/urkSvl3DmMEfQwkIcmskVombC25I8E6NqFI0dM3SpzXXTaW0eJdsmqRF3Vb54ujwF8GGvE+maLe70vDZvy+KJmwgMLuiwueoHIx3jtK12NG1OkAVK12rK10DVTsBEcMcUmg89f88evYaoWcxGUOaz4CelyIQfDAjICSuqCvFKxJSYncEnD8lbJ8/NvThtSipQlqGyQrm80Sy8rrjkxV19/stkpWDby9nz71vGSMrG7cfj6zcqalqVb0SvlfDmL4fKIPBgbeOk5X7K18d0nQJr2kYiPPR2x0B0VjhjlzwDgke1YgqWUHXLJG4GeEKWXmtvCObJmlRN1W+2Bj+IrhD3ieTlTVXGj7bnKx8l6x8l6z81ASyIgiEwDsQOFmy8vrjkhXM54lk5dDDJSs3xyxgiEp/laMk5Voz1Q6XE+fArRzMfhr1Lcn00EQ3PV5UmR0vGJ8cVw/NjcIfmR3hhbX/7hD/GVW8v6SK9nuOj/V7uT2wWCteIQ+9TGC2h+cVmq3TYbci26NQKCBSW1HvnFZwVL3+0xsYNC5i54YTpohRqPncTdrYCAr+DHlIfTTtcbdYitiaL7qIXBDaqV1Fw72CZY9iWP2ghP4e+Ha58QMFo6sIPYDISySYcWgfQmiFThb0HZNlGL+TMnvLFRyWBdcolg7hfpDgc73Pnx/CeOcxggckmCB4UIINdG133jQbAb8qTsNbUwxgYgvQuLKne4Hm5nuBePO9ALD4qsI3hrxCjOrNaAHenoOfq0QZM1Yh26ZkBsVcm91kpljA347x8e5C9S9Gw2as73ZOlyrzExTIc459AxFF+JtS2jXf+iexgaMcEKbYUL/b5MmFBPq8W9ODu/AcEkjYEu61gfvNpwfx6c2Bc+4rsR/wtKL36BPegvEZVgg34Q4NrTQHhlaaq48/5V5kSQBkgrstEYiVOAsRiJUIKJFWaxL83OVmTgSa7QSLNC5XXNa2ZwqrlvYsGXUMhULJDI1OC7FbZyoFlN4jCTfjN/vZEZKrZtfU9nL5tZa0S6juFeQbgqs21sYI7lkKoUjRykTe7JVw482OV7VaoBneU82wMZRBG2D9HaMfpTOlO30f9/1HDULqTbhPgqLBwcIr+QlxMJovTmu7RTSgcL2Iy3uG/PZGLEdrRf1Ka1l/Pftp3Gm5LbsJj0GRcGQ8oGSd6hVrr2uQkNR41p79Pctf/MvzltjFTTmDEe08OLpvHghYwfo8H3CP1HsKWhOSqTscrzuWa5gUj9Ydou7Q1n0xN9/VXd+87r6vxM9dX/0DP1bzhWo7wd/rPEFkNwOARUB8y8oDvcmKEKQqwm1VvWXHKv27GD78oH0PvPXLf/K0H7ucaX0DiZK1iaQuXAGBBkL+D6KI5BaWlnJ9KK0yIynhyyi9ARdzlTHKAnKKQbO5yQWv7G26tICG4jAMOupoxm6u3hYZYrLV0Zr17A2A9BsfYLLM3vqJ/y7pFS3MrxbVvw8XuWOKMD4tHK1l2etgBhJYps6ryc9+CjHiIvSLgR85me4xvu+UOCuQX+O8oMel4cYQjl3wllJi2Iid5n4AGkAa5oodIRA/n3DYU536GSUw5MSftDQk1AGEKcHcDSkBGWgQfwb5dZzdeaOxS1+V/6lpze/55jev+6a6znjAriZN8ldxBWNoVcluAXIsoUF3w9vLkJ2Atjptk1sADi/hygI/Ge6lwT5tZ4BndrjIeH4hpXu4iGFhUAwNrhFHr1HKI1eeccUcU7Gjc4Ta61xdTPzHmJDdKjNeziYOBMqmUyz1ugsZUiB+9vBlcLNqS9fXzbEW8LqmaKLOQioUKeFBPZmZ8w8PbeZ8d+b8H3lOeVMURXrN8SX/6pM+KSd9WE762viEt7M9b+mUzkPtez6lwMg7lChvkUwUCNRIKUkLbapn/wi8tgSBe5KgJ4G5fZmIPx9Fkw41V2lKIeyPbZspEL0CX6gNZqiCPaNMYgB2d8FYJdt1gL0uVvsADdzSMiH4Y8GL8f/iZusJaNMMwUZsC0SpVSFKs5YozYEotQxRmgVRwt0vmjNE6TmbEKWZUaL0T0NEqWmIUmuMKF0tpTqiJOBydKlV+pFoGT8SD4Muve7gQ6JL36VLP+XBk9EjTZXIh8IYIHOj7EeofqI9XKIbuPTTYagk5zue4ISG4LQeHsEJleB8Br2mVMCVCrhAcoTUVHmXwPEuuDjaKXkWf1XhV1f4KcnIlFjVCk9s+BnvUCdNOKa5gdk4NzNjCcdslZuZAeEQB/izJyAc06OE43+/oko4fMfNnIBwBA+Hm/kqI/qLOXWX29aLJJkmeq9SLZoa4YmMHiRg+nrQM4GbTQB7bhFVX0siB7/R05LvN887NRmOModl6hsmw322oGMmgMGBz1RpqidNfdL1/FXG8gGs03cFSHmtpmijIhO4PzSBezmQftn3wnGvAkYV5BdeMcnNXSiwHPKmFzpveuG4Nz2XLqlgHB5CBeA+4EcvexMyq2M57kt2WF/FjRKMo9tDXl8JIaYGJOssBpXfezz8PmNlv3GaGFY85vnwmNcVrzDWY56iTYxH6TEvHvOYxx3K/kQ95qlPQ2THzpRbNOQxr7rf/IYv5j0a1w6tSz/3iuF1qVVZl0ohXFEvhXBYoVSGXFmk6rKC4btGKcOzC1TRwLVEfqayHm2+VIVmqaqbdaVesfiB7Xgdc1MXIp39rbyNQFI0xJhCQuZLLDZY5BK3yLkgF5GgwWm5ug2kpWhhGzJWGMDiHEmZTkllIYTNwcQuY+ggHm1q8WN8QQsprCxoX/d88KsG6cmtHQlGeFkl37cfHj5kug3vKvfWJJmXb0Yw7SMRtb0DdUBIKRF5w3rKa6h9FaAL+Za/jqj5X3qquJDoFc5wBXwhuLzAGIdsyFkFcMpXVSu5Pa+7XCw4OLBAqCvYyGWIONQD2NkSTvbzSvCdv4ZPR7EeJqp9mcr62TyOo76UiQV88uHZpSZjMoRM4rAx+yPjJK25y4ftZQ0xSshU0TW0WVlD8T21ZA2d0xDOX+SyfA0zt49BRA1ijSH7E9mmd2CcrC6f9clezj9xqVzOEU4HuIBXaF2T40J130e+1hPzI2E/EFJTBsQDkxRQXSSXZvVNDOyh2MbfARLhXvPcbZ5kntmIsbu+uOKMc95DidGKOsy3IqT110HNAn5g1qrT/GKagTCtdivq4kfTqg6r6+aApiSWfLFb0RQwp6iLpjgGj/1id3UKC6ZWaovlPzYC0Ua5nFLRluHWy7RDo/JI2upaGIij/0AKubIIYGN2GhFaUrWFNekBzjRAKlvCbcBaX/a/AMiqq2mCs2SY8jssnMWa7DSuppYs5BcIwnngEZCK2CscEUI6g72ydh8IffD6OKVytlvwDJXNAyqiuLs8LRSxLWuAIvsNtM1ZvPAdkQ0c6RXN4yvFFJj1QFXSWHWjFVCI9IrljaBqeSPQ9a3L5FV0m0Adhi1rcBGOG+Iy19WokD/RqkYn1ROjiYkwqCUmN4yfGTUJ5JUQaWXvF9ZKOwPbsJoP9G0yJEIHiYgi6SnDw0EgPKIQOgEEqjDAMhuoTalvBRB5AKr+fM+rOOMJneUPdb3IrBF5z8NFevLg0Bm2ubpoL6gDN1yJKUJKTIF9Kzw5+CPQJVDTu4QUhI6avtn3/EnuFKlm/YV6+A5eczT2xomx99cmxX5pYuzdE2M/MTH2zomxF02K3O0ib3Es2U7dbIvTzV3VzbYZxErycjXZGYPj1PRCBpK1XjbkCTK7DVVpgqaqYRhvv3EGmZ7tecOf1vRTw495yF17mLmfoc2yzniVDYSoJhAdiNKrOYQvauKuKlfxyfvePDBfkC7X6sQ3vcFDyaUr5EA5VvCUUnKAZvjZmtWDVz4UmJgdUXiY70pnxoG8ohPcoABzo+rMGC9cSTjszPgihgVvD4xTXz7Msi5BA2TQ4w9uxboQAR+VbOa6ePCKh+66+P9B7c5oHTqE1UE+xgsaq87cPP75MX3J8JKZly5euvJydo2wiaCnCA34P88t8teSAJbgJijTA3ZqHQ2h0jqahkUS0BcKDQGDl71Vxgrb19vFfCQmOLZ3Pja0OtV9dDHB9g+O1fj5MX7Wkc5PxL+Hnw1FcJyDBCuAT1PnXhMdaQqaYmyxwKV2yTWOhsjPDgvN8KlMungkCdiO0hQfoSXD6JfgjaBzJxj0Dk/qz/7SXSkYSsvepkRIhqow0RhiIBsHDQHaW7Tw2Fe0pdVaRjEF74/6SRHRFD6D1RbXlTwljpdrUPzMPXHWH8HVkEgm0VyGt56YpsLteGDW4f+FmhT0lF8CjLQUgLyhHXq7zOAWQNCitu30vrwtzc1baHiLHkpzL/62NDfZrLmpEZgoZM/6DoBs/XiQPStvS3O/cyAbbwpZqkGloC90NXsT5gradpXennkOt8CHCCjBBSd4PyUPRTKzoQWq0wJf1XlK9bzrNPEdRgssG3EPfd+Ye+hJsVgndFGcqqkb6LeIllf6exP5G4XpPV5l9b/XG17+hQI5luJ9KqkBPZoYe3Ri7Hsmxt4+gYUCYCfF3jMx9q7axJZNjD06sYRzJ2XdNZazOhyAlIPzIIoD3obHckLhXTtxYcC6idUxe6cswNA5RGSIyEwj81D1YC6fqHYUidPzgPDcTQGWmppq1mF5ScThu4a7UPIRZTA1wi2e2ozcVExh1RFjltdEYhq45XEpS2FgblldRDSNK6SmmkkUEoJH+5l5iqn5Y23PGs41RhOb+RQ15RN126V3R1azX1bq7yqVjYLYSueWMAerRtIp7Xs/nqdWhmbaXRjRXVPXiyaaix239aYpHQSzljz9+SL6nhLrCxQD4FNUM4cN+M1+xVwVVEPCUv5FEye6L+yKtNW582pRayBtoabZ3Ld5Y9Y5zJtXu2DY5RTwcSbPsC2umjxDSZuYPAN9dAVhEBKAU716unGUMZtSc3Bq2N0BF2maUiEgQfphL7R+RYyHWV8YLlTgBebdE6vMEO+KzWZd/GMhk5Be/phe5b2av1DPqr5eWfUdsym7WE/uR2sFUlJdeJQ6qQj0mYimCL3V6imCsnEofLWxCOlKRRYu+BH33KvHPeBoqp573/uK43vu/VjgZ6ympUTzmKfSg495wrEiuIG1qSZKYPF+Mfzd96iOHWrOY8tYmDfQBiQJBsvZnxo+0GVOy6M2Zy2mwM8Z9BOvz56oWcUqHA+cPUr3KbQCR79SSTmDtmVYROOKpa2ecTNq4zGNM+4VmZ0AhnDasu7OED9Z0FJtTT5LEn10uLp8DtFjrSjmNfpjw4UUC9kdQvcWaY5smEM0b8ILNFuG5ykUof80PuY8/M2RNZo/ImJrHUTqUAN2oRJjXFQRqYXIFqXIYs1jGXY2fVUQwaJzjEkx6dSkYukcby3w7e9SUg00r5helNmSx0qhyT9yi9oaD3QiV/0DDDv4cnKtwLDPgYuTkxLLPCu5jhXd64Ju6h055snjfCfXSqJedTucuna2xAZRLPMxESYKzTWejhpqHUFM5xdqhAOyScgegU3RlcVUL+dkagvX1KYpFhupkRetM04hNgW11eOVlus4BgHQT8kzm4nqivpJzwvHt1TOGXaiPQswcyAU9dSXPNwA+FYQJomyKGW/qttcxFYdTfP3eWR3dhG2e2o6XymHbOD85HzNL3s1YyAfG7GW7isTebhdppe9W9kr8qs289+DyH8tqvVrJ6BaNzFwq9bnsTUeFIE4sV87nIco2Q0UBIKIHvbBc6WCLFgHNNaPUG1daP2wseFaRdse+dYG6y4mwOccc2SgW/+nQS6xqTeBX5c+6WEJ4kEQJdGHHAMe1ghwNPvyWvoslDbxDpBv0EhNEgJo5WTeEDSBIAGRodQijB9efLxAsJiUUpH08VKLEUIr3jExv/aa/ZzLCqvQSk1qOeEXf9th2eD1zKtn39Czq7f6Xv3kvEyIZ3bnZSKseJnwKn4mvFE/E3LDQP1MoD9uYkSoIaBY0QnjYs5RItTqqo5lxoR2xoQUmxmDZBAMH1+01OeEFFoX1NPZ41OopccAaSSzRx8hHpJmZo8SvbpMqPFpdPKg+i6o+io2NfSROUGToFifOKyvcG14WNxP0qI2/P2Bl+n3yKDys4com/2XmZZn9kYRRGf8F0rYWUSZrRzbql5744Lg0CwBCO64GgdFB2fhvmmgR9MQzIObz/5UjKinSHKukciDsMBY0yha2aeQiWJhQq/i9iJ7lH0CsXkrhc7J7U1x5xoaN5an7x1Qc53r9PRGRJs8XDaZwuOqorO/yMCIT7tTTMG110Z87YOLkZuVnpw/NtahMcOtfxEkDtz8dXXa14X9dqj3PKWYAwDB4uRTNJt3aBquNqkDkYbxXQIT+moYOhFfreAi5t3N+GWapWwFrZpSW8Vwfs/fcECoZaLCTpwvHwTVzCR4AMEWgnpwEXKwpqvcDCXZB4aO+fIFc3ckKqa0p1xdv/Vcmn66AacFckQzFQXCqtP4mVK/gVzwqt46NpkHvdKV1RP4IGhB68pNXXBuXjNCFVpQbaCOCoISauD7Ax52YwLzJsY5cx7mOf5q7fss93JVgocQfI4Dw1USvM+CIVGJQ63PLzobsg8K8zelqgWJKyR0RVezf0iyd3B4E4DxgVgB6KptRQsT6vALkLqefRi5FW0wVe8N2ZopD3adraVdU3SJRQfXD2X4GmfYQi6hK/pjoejMhaWDnK64id3lo9mL6q6ha1Crw4jllv1hnzhTgnbDcYp4Fg0d/pEnGwU/nwLhEAFdR3d/0k/8Hppd33fztNY0yCPidOEX+Sm+p1Eqs5zzwnLCvybHxIbljOEYBPWB5ZynuFd0UKsCIuPHbV+8/uidr/z6G18K1CjBcyCC3fQprajwCYOeHRUYK+rOG1Re0tOGLs/wDWdOR2xSDfIeJSKpWKYEApWtop0h5vg82RXNM6kDaxLLxqqO2PdIbIjYWcSq034OCOHAnkmii+3cJDbRDTkQtkaxRM5yTEErBXDDHrt+gzfeKhTh2m+eXSEL8Snabjd6TDRMUMFNi7Ql+4j0NobTlttnAatYPLXcPCtKbpkgRQpkPj3IOBkhY3KvpmTJtvDkG9R5BBq0zTYIIW1QoA2q2wZ1HhqY6q5VnYfbqq22VQgNtWq2Aqapk2lQ7GATb96gKdegqUqDUrhm15YgVDlb6lR9iCZVr80tF4xcsAHD76XZ/opbVFaU6hWilqL79AE2bw1+z/C+ljcoooVbsJWdoUDXpzX4KMbUkJnMy1A/tFL9Ls2bTT/NyHJaK8fFzSH+QHV8FRrogc4WnUxFPJIcUKoAK0LyAMXsNwG0w4Pst4zsICW5EzsgrLxrh3m/Y5JmIMi8K8jVCFmQ51RTWk/d7KPIUXX5SD3KoctyCy3QTIVGImmGFo64GFTnnDUO+L8iAoMBZb21Ne44JEOiVodY3J9NmKa1mIYaD8G6uEGVF7xAG2jnhlDvMgqsCxQqxRYRVHwMWZ4GPZ5WysgMld37vSWKDPP1Yq/UEIsq9wvLNo8FatkHVfFZDaflkd68LGJ3Txa7t2dMlFfXzVVvPPfohdo7PPN+1AaO2cDd7larXAn9gDz5E1+fB8z12fu9keuz95mMt/umpIM2cDM+3aio1AZWpfZgiGv4oVOpNa2KTOAOG1hDIKx4A434bqV9P7CXXPDKnltIH8C2XnucmIIyvF5Y26U+8EiE89U77Ym9064Xt9mbMnl6iA5URRCg8vue6jbBKF+0khup0Llmx1nefj4zuERtPe3JIzz25no7/KMR+Hut7lYtByCqxL6xjH2Hi5UDEMTWRmP6B8KV7GbdlcTmWqu26XLdEcg3Pzikoh0w9q2UrH5IRvvoSHosDKaBqOOCuFLaGhppa+SkrbGRttZl55f0PUpE2toQmX/eRA1IcpJWaCeOSFunsFZ3JklbY6qrtDWklrjCj0akreFkaSuU81Y0MZ9Rx9cE/1dg5/GYoWnKqtLWBEJZBCSLEjN7RcXoUEWKTzOq/TAFJJvuvzYytit+W78Qt0S6I50RIjtL/Dw63FB4lxoQUkB+O6Mpa/w7jZd5+HICpdJTE+FPpFCWzI71flhShBwAbWfTHNNYGWaQVMyg7AwQnOEf6/olxElEBm83GTXMHW0llG1EtqmFLC3rZj0dlSqmf2jdjIpAVWk7XsSl37jLUeQKxnJt6n508gcn5YoUH4YjH56EW9K/nqjcr5VJodCx/R2UCmVzq5v95dLQZbLX1rauF9TW8A6Vzgo0QnSOQ5CTBig6LMLhwqHVfKLi45HiPYJByQhAjCg0tfgt9C/MQ1FTAMBiC7CAYgVZEY9UHkE8feIGRMMNKCLoN4Ld4gAqGoXusDB6IY3MuYAnzwBPR5p27y8aNjNxm63I0DEDb3wgADCbqr/TFRsaq0XaJ46zsoL+zhVyLxdBtSDOvmq2bTGmCA4KclWAhq3ujTwsubXsDagelAxSeGpuOD0IXMHPbsGNsQucqeEmuAP+0UkiooeOlZ9lUhe8o01rXTN9nPB08rlgr23KLO7ae8/nJtAcN2kG7cFZAvSMMXFDzFpzXmnrbKHOllTIBAV+i2YBlFnC0YwTW3TUIV8hZ7tFW4UX/NBmi/QmD6WmsFoHCm/bYWxU1cd3UYNSXAprUAf3fbBygoA2oH4RqRZ6Ps+vA9Unn4PYSI4ZQWhU+qGZE35kRpt8SRQrxZcTfnZD8FHwsAq3y43rXNbL7nTalrs5pbXKPgMgIVxQjTkpjWKgQqb+YXNP/fcJxcwUGUBrZTTmBPXzFkZ+CkPiuMHFYIxdg/O+Hk1BsrRo5FeNvfAd3YLvqKpHTwVmhbdRrJkyWDOoQDmsnN+EBuZg61s0B9K7WEletKMbY3Rdd7jh033Fr2Jmfz4rwKBYkFvu52k/9SAz4zrnLG6BzvPgVwedZocQC17vsTzMIZlxDA2Y1gakqi3YVMFkU64LODaEQVpE1n+2DsGIf92Q4hH/ug4WRmQRDvKpKoSK0PjXnTIlh6P+dYOT9KwbOs+6IYXH9awbOke2pTtdo729mTfdULobMKWtylaNM90pdaZbLNLiWsWh7pQ41J0adajL/acp8G95aBzaNvVAq00N2c2omjSoxKpgv8qqNE/T5TmEPGrOYyibCnPKiVM3y1tX0CJTrWhLNVVzGj1bKSOwXdkiDdMoCdqKE9XLLpZwkQTNS1DvpFz3c64eNStZStjSBECr2zIUUiwz/pkZsMxWdvbnM+Kvo2CxNCu7UA+Iz84d8Uj0xhuw+BqufCsHdHYk5IuLj2sKYL9kLhjxeS5gDmaUSmhWfU9mqhNj/IMI+s8ytMRTfz7V8qoedB1Ch5SBEZ0SlbojGMy2Uts5Xlp4lKfWKFpz9rIpvGVAc8qrgVZnOisztGcWj1lqwoh8Uz0+UkKisTqDxwz5UPTxKcVbaiftcmVNSITh3XfDnb/33N3/9R6zviuV2UZ1Whzk20vMveOigYa1ZQVPSlJiI7pIOYVOppcX1ISMYgdneMlTxA3NSy+teEmEG0ZowyiJgso8ZAvqnyUjYyP8kuz3lHEDM5Pwmlj4DKFKEwPkutHT8edOKpFbxvsV+TQeP5jPSEl5U4dKHULw7w50nFdf2iEi+1jsAMygH21hjeHATiljPwGpDYVA0tSgHIdiDuMyyfxZqyeZBwwic/8elbV1+W5Wv0FpTvloFuSYWhilljo8EG2RRdS46G4A5dEQbqmKlq9brmEpxjQ14W+pbJlN5V71ICHijqGdgkjARmptrEubsVO8lUKjxAEhFURQU4LY3EAf2Gca3VEtTbSTKa58DUqF/ErWU8o0ZyZgpVxUcPjVwLSYurJo9fIMxRMHQsd3vEjXwFQ+1cOJVXhZhDcf4IbuoJ0QaUDsOBRjNMhDSxZapVS+qTQAtYduLG6BRaTN2alaFavB2Jpr+RSWdtkOeUXTXLEmrpxbgN3c1GEhBGsDgwbc40SZLxDYAtBaG4jYzAmzjq6BAAyGRF0DaeUa5+zC6NOaao3ni+RhbFRjQ7XQGv3dpe1Tn5UhxhU6us+9rLwsTPKOHYf4VOrBlJbuB3wVeSJkRZ4UYDIHQzai8SGTHKNfgbf9EBVH0HI7YTHP0WLMcX8HAb3wAOmuicl+X3k8jnz7J9/2yZocMLsOSfMD3ed4xH98vvw2zoda+HHGpb3sD1BA2cCH37rsY3qw+/moIWp9ZpcSV3cqB/z9RV3Bb8/OfPIHeSJEJ0IbGnjUCqhEuXlaVRiSi9Bu8LG0Wz1M8vTyxUbe0WsuGbuEyacRvtHLZ+TUXDxzzlXKg3rWU/J5FwPfYHX4VoyNgKWO8ziKcFY2yw+hBhB9NPVlDcY6BvzrVCxdkO8SpyJjhtWBlMW+cNfLf1f2HvCLBk5A+XKjls7I+etHUNbakO9ae3U3kqvpzgVNZPyMx2ghvp+hTNrNYe6nkHmtAeYSM7zq7kXLTLTMEGWSEifRRZoHgmPuaBUoXiuiiIuDxQ3XZEBCgCoOiPG6aYNpkccFewHMixG4ymUQWsAJa4vSsjaV47dGygHXLOuAPGfBa2OVEfVTPYhN+DAgT/HSUrW3VKZvUr3MKOqz/APSUiwQV8xS8cMco0J5ajnRuahED9ZgmRMtLv1ofM3zcctZxW9W85L84YMB1cAwwjlvOK2IhiVQ4dCrfnXXWImwGnArPF7pJUnNdnS8cIb/rUVE/IBgnkJ5wtYdUw1XcSXImApuv9IMDWqifruW/idjruWQUk2Quhp5VSt4MBVLPtPKGsw4Fj4Qhn8Sl0cUvai2UfBzrcDLES759sirD2uFqaDF3mwN0SvXItw99TbkWBQg0b3EwG0R8rqqWY3so3zyRvZR7tqn+uAXekR+BVd8s49KtJLcH91HRZpwkrsp3+2mfPKPu5vyU4odMSg3VAOcPLoVfW2NYtdcbcuRPJL+O0uMQKqxXgMkiWTS+Gczi3cS8IiH4JGIiKACj9jCIz4+PGKKTx4eMcMjcbtLisiiVHJ0gEb54/seXyzdDLgLhns/d68wyhuF7c/XuLm+m+woZoA2CXYD47jrMIMxkAnGhG1jPf2pR1yLMjHXBU/3Rbc34GwVfcqPn0Cf8p+CIL6ufu1mCodBqcjo9YNVcAPinZT4j08mIt05iGyvDsHI/jypnMk6ZGi6YAop9JAOL7lUStcHRdPBO61AOnWQxoUFQLpNPvHflT1ErA1g1cCCR9X5Lbs+t3fAWRprUMUSYxxryguIs0uVW4UiRXAtCXn5583QOtfkTqO5Rcw+StwUvke1xZRo82DDyUsDlpAadWxdqOFppoaEwhUxJBrzJe9spLpscnXZhq2vXdbXlvogETR1tDg2byEO1WMRxHhQWpau98lEl9Dexk1PkVuMYvDa2ODTTSLWADBtovCXvj7YTJfZ3VAOrEoypIgRc6yOL9a48DITF/Hrah+aqLiOdDW/cVDWq4oibKCKsC0fanqfYobTY/E6+XpswYkUCCf6SaRQqBwpazpGqi39J3pmIO6eTrbOUOtEe4e1rFm/0uu/4LkQfuaRnQgRcld0reWko6pr7Rlda3eHH8en+nAXdbM/lcNGvX0SCeuNNNSl189HtLA/oRzyrV4QCIdcXurFEEYIwURJhA5hYG1SHqtJD5vdKxVIcK4KxXqo7+FqFFYY0d3QvbVug8DqRXbz1sCK3TC7thjXpepAqbq56JKeV1WlFKTSLldvz49dRkidmqdsQqCm+bFRNc9PT1bz1L1MMqaO/IGT17EFeqqOraLauI4t8ug2yKnZKvIFinxOzfYPh9VsLWmODWmOQJwnKdyGOMUxeBbYY4oAlKKidhseT+025qigvF7eUu3bRB8hHpKW/dFx1W6PIfVhqp//8aj6OTpTqp/jZUT9fO8k9fMCU5QRZeVh6KCrrq8OY1XXFy1RXd+H17NPPtSe7S57Fmafwsffhp48syp++FZsRBShsRIhlkTA9PBHTnXazUnXiK5txHO9UOa7yoUDe92xvHEl9x3l6esT9oRWMQ0w42JmJwSzTQJFmEj6nv2Z6rEJcY2VutxWD1KmfHPXieU0VTp+hl4L1buzpZ9EyBopgs5EXY/lcEYou/wEwZ1qe9F4CWipOoXALaWW2QkV2IYIBQtAEkBfIV8ylzAhN4C12XyKorwjBygetWWQkWwe7AAMRrSMadopPKaoAxqqSp8h1XGMruJI9FLdDPtaJZwrwujqL1xVxJTx1qgNaYT0eYZCdcGI6ClRzhSYFHWSD2hqpUj3F0adYA4nXLylmkfGzv6VfEFMwKZ4XWRhe1eAUWzhiiUrtZg9WUI/qcPJDWxcv8G3Cq7Je9zP+f1cJvyjUx0FRPsh8geot6E/1BZHayuFgdN2G7m//5MrGtWUqFo/Nu/EBX2zdpl4dw0la1HQNBwxJHh7eq/YQXXNGhMauaQvO4V94apShVdPsbBGCUfSzNOXiHCJV4YnpfZlSzTFM0CHAM+OXCgvuB8q3PNoJzRyaRGHM7Mr2Z/rzAU8UHyXItqxioFsQGFdisVknjruYOuBassY4gd0UdbCUFnLm5d17UTEwX1Hxc6E+ymPQrmunF/qnHd7zk+eBFJuXG1aKWCZQnFTBuWUfaDEABobf114tlOEQWzQNiAC4Y2Iz3MwjMa1S6Cz81LPe4nhOwKnxWF6U0RoQEjy8NAAz150DNHJkHw0x0dJkxnT2ihjegRuaP1rnRZDVL2gfodfuNsnZwEI7mKDVU1UbZpMtTLmijr3Qz9F1Z7RfqpZZk+27f0M5oYiEHqiSA041WHa7ljtuXy/sR++ENJNiuTK/U4JncWhrhqfRAUwh6wHM4ZWgsfqYpm5W5aZRFTlICvDxlEcuhg5tCUPkZ4jouwW4BFlv4RVA7wAYlGasSnDSZ81SFyXBQEPY5EmUFsoGhZmUC5OB5SofZWG6KoHaAZxgGPNB7p90I/QvIi0YtWj4+Y5GfnxfSM/Z7JvZLWsWvU0e3URC7VznmavcJ5mX/Qte5r98rApibhqZtRA8S8n2gKtyy3VIWOjdWdstD5ubNSlSyoA+ZCrASZ3VspP/soZHmUoZPc4w6N1GVs1LIBxT7Lb1Bqo6FqigZpP9Q9hZfRuLPPgb9XM6BDORO7y1rCZ0ZCbdkQKjtQJF7LndX5SOGxmNHbKbL/SjCDdX74uqOjxem53qZ7RRsxcvsOZudxwZi7fg6CT8Ouej2WHQCqQd8MgcZ/m0LFMpiqmPMW8JMqlcR/G+pQzCEvDzDWEmpVy+aqxaYGUQyF/xZxfyjZ0KD27xkasa5SCjrRKOoPdl7rbwoeFB/GE5C3kOlMD+c+VA9U2lh+sSXqUKVUsI3m3WsGnVh5Txxg3EK4FhVt5vBJ2a4DA3cguD2TRSJTa6tdfAM1P6EbhfH2G2nqiAW0Vml5Fxr3SoHm0YFe+0PdElt/lvy1y2XpJNqUM+wOibTxP3X7M+Xtcy4ysbD0wB35eQ17+28pFL3Gr8GVHaThzCsu0tZ8Ie4DS8pirmTLH1T5tJ4/buVLAy89uvr9xFDMEL8Qvd9iXjF/W9EWvebBQeZtWIO7xSVEf59yy9Rev+ES+qGfUrGN86wZfWQF7PuJxg6cY9aQXU3KbvCanxUyIld0B39B6WrmqL3FQ+74Nb/vFZ3zMHZ+SHm2jJYpXHl6ncC1srFOA2kPvF/oETiIW7pu26/ycpS0yKnEFYK4CKR7Wt7VkFBuMFttFsV1aVIgl+RYuaVEhNst4ouoc/JimOT3VBz4WoDapTId2gC2EB5R7au4JyNt5PEEPP8+JG0hqhIxyivEsige/7FHx4D952u+csKnVmZApp+NDpxb1tYKUodD20/HCc6pQkR2ARd8zCEkCyh0cAj1iYD1fbo7sII9fBW4cAGeFDkXURkfOtZOblWzxvpehiag91OBQ9nPiqmEHjpBoB2scBamRzlFdRgVEyXMWT/6DD9sOla0WNqnV7VZIoTIQeYRXZVxWoKDvPGRU5X/puzwvqpgCjHUNqauRquhskewHQg0hjgAJbWIoq+YBm6I63vheBM+uvQPa6t/0rsGrLi38iLPPVQ0HxqXhwBivavIBhgNjRDjDgXiBNedhw4GXwerdndZwYNx/7deMsagYGUIZbjWHo3Z2pBvZX1tjooTq+BGM2RH8/MOwI/h/nK2/96YxS9nYd1zzWs/xzUe9CuPcxy4aVF04ZDYZX1VEvXr49Tma6Qpn3P0ZajNQLwqL7aY8lmeS14F8FwJFRLZwO551a40+NtboxYuA2hKEhEpvzAAUPKXl+SWPcTICN8E3j8U3qcjBxGVaBLW27G/xrclqP23YHHxDRTjbZsVieIroDYlu4fhYDxJI3ZGV5EBsPPZKvaidvA7qwe3+X1enA0Wa/R2qFsdIRbZGU/s+/vjrnv2mtc9zHdOUljbMB7J/39ATrkk6Yfu+/7IP/+492+K9fLgxk/2tXOdOtHcEU9EozDV/VnOA65jbKNom5XJmfBt6VXSDe9jGyYdIB3BvdGPfi+d++Xs/+5M3Vmst5gdrrrdtWwMry7THo3Ge69hqCnvQWILigfSNWS9uycB9lsLq9ZFigbL1N1Zq5CtkGdt7LvweiaOauY0BAz4jfp8f2I6AVbd6ZTIIuocaGhy23cWVu65DgRx/V/aepX4U/95YykLks3gFenn90mty37oe8oX7vd8bsX4Hx63iQ89TDvIB2aWo4bvsAzeaEnHysuDGgzpo/rRoesxwMLsPVUvv9LpPhpDP5eDszFfBlST2ITMCgd6H5yoHrkYAR22MX0drl6GlaDl3ts8npwcsXpy7otCwOtLr2fuQRhHS0KcvvhpyxfcIltaE/F6CPRQE0sFeJa1WHo+PsND3N16Db95V+eYZ5TeXD38jfdCW1XRD6mcb2gJ57f/Wq0fLorKs7mj9/a5a0GI927oIYbXIcLjI6x9WkQpIUe11BYLaZ698uStpd1nSrrGS4Kgxwl5B9vfZV2+UIqB1q4n9f34ZGvZGvdmuKdmXzfpXs1b+JxMX6lCQfQV5UwyCN2wt0S11zlrihFgsjipThgR6gvVn7BzFiuIXdZ/odmS/5Q194U6lPcwNMeDqzAci9ksTY+92sWp/UGI/MTH2zoklfGBi3jvG8nrZTeriznedwFR2MPgX3094oXOrN9bMYWtxRSRhJS9q81dvqJXGkvJY57nuf7Gg5ZEakS7qtpyu3TyanSNc+sD2H3nqCqlQ1spamGtoa5ooP4E6bKK1i4l9V38iFujgbQZxbR9Rwh3p5l3y62dT8kWdkDlFZih7YgMeEQcinOchAKqoZXmEZVH7Jrf5Uq3WtKeJTvJf6mpnQoduxpTkDVzJzdBlCwVwacP9StO7Ar/iBYmGXDgboZY6F644/+Ua9IqRJyyrsTvxVSDBef6PnEzer9mTmmdAPJWV/r9hpSE8zqqbO5kRDlDcPsADdatqDTkNEl+LKzVkBqWCzdq+A0vb42++/YlHRT9pk5sLWjb56hzUadmQe4XDUb3IkOhFhoqGEiWu5iOUjN5lqJNH/Mc7Cy91bZ7UmlxwIIZSVQTfKNzfH3n9b/7Drh/5ewYblJVwn4wsPfLTH5tMWsgsmtk/YAxKbu4f8YZ6R8yS1vSytd5OAKNXJUavbAdQ/Ey1HhTlxHJx/83eirJ2wujpivxPoAl5nVN1QwCOj1Ejzv5JuP9E24a9jMpCQ/zILaakNCuHiY7xcDdrYYYAKXo0BG3HlBENJ3K68UIazo4yMBMQ6IidTr09e4Ra6w8EeZZKTbhAm8mEB5mYNrXa5iZQI5c7v9PG3B9x4LIet//+0sdH0ZSSwDXZ8yXOPo0gE0dUASlQGzfo3cmD9jVD2XrIwbsm8M2IRY0KOW3KAZuA2iTtAcj1cN0jn9GmXqtbrReoh66wyLRlbRUh4qqEuZDc5Gh7E5lqkKmjhdMSiz3x3IqIPac2wHY7dwqwM9BShf623rZlhBTY31sfBb6WNgdoy4ihc7I4wwYg+VysyMaVhdaGUodBIgrqeoyG057M2jbXsOop6370Rfh5AfALfEFs+3EuB13duAEfg6btIrElSPMQPs497fnF/IW1S6C4i3OBq68p2vB9LrV3EEtzNN+Dk3SEO/vhIz3Gdei98ESWfV0niVbJA263QnOGUYxhs6m9KvLCNsNIrW6iC9TO/g5dVlXar8mNIrXbqDcN5FPFhQ7um80oLrYVM7PU3EBGQRWsIS3Mze7lleyfNWisiS0jdLofnh8QZoTiS6L4IvCELWAMkKMA5/KFQu2hFZiC+ywWq3EgTWOz/V1WxSdUe7qdpygEgKibzVXk1OmMnmM+Akft5Czm7ZSaQ4FTwNY5AQWHKrpqQ8sBqKXOebnboUgx70SzjIXr0MrCLUtF+ynGTr3SgGXXbDD0a0TLLY7MTuQZDMQMSTc75VjoliErpnTnMMtdt6aQFvBQAEyxNeAi09unM3jbg59zi3QFxEAmIGqgFOF5mUO+IT0gdzherNy3TSFRTuV6KmCHb/lhPhvLnSF3prmBTjzk3NpZleXouhDqujBh49Uwm6622XRlQES36cIcG0WkWFFT6L4yh5igw69Nfb3fvCbDr/WhV7TQLETLar7xk3hhLu7Nn7ye5f+JVOWlh+IwvC6E9beqs6pQP1XzWDJEkZmzkd3cRWZzZ7A+RE5PdujZl1+uMQcyKGscVkGXeIkBgc7Ej/3OvlnpOALCmpA4kioauSUDc9Rqy95xMdXFjIS7SytrXuS+StUL2AruQ1Q9KAzKIgbuRu2oZqHq2B8QW6i6koBVrORJjKJYP5MsOJkREgzyv2puD7ft2UeLkRIiYDVC1drIG8P2gLKJ94U7PWqs4w6U6yOqzSOcnQz3M4LIYaiT/Gmld6r0NtxJd6xCdZqCdmVWSc7Kk/7yTnqmCipzYmIWy3zpyieREE6I+Um8LrQAeTmYgnQw+5dXODeHD+iRoABDlfzauhcZctUPIrGsyYoN48n7KsmXjCfvqSRfNJ58ViV5dzWZwoqnqzd5peOa7EE0fNwuBQWachxbFC7TSdmfoFAzn4TNidujILwWgvSR40KG7dj1AOdoigvdcOryuA1hhHv/CJeD1T0BhpFiy7MH4zx7RMHgiLtOd3QwwrUHFIzz54GCwFiDcKLEIqpYuqgrfCtNk0O1RJy6ecP93bSfXrWfDRrtW+O4fWt8C31DT8gT1R3cQyXbId1+eGoUug4swP2L0X5ip6048R3dU9mRoa9FwgfPMr85gD6NY+odvhdPto7ilEbdxqdQ1Tp1CGosqtcp0hsYurqB/HJcAsYoMQp1KMyoiopeavYNJTwjVaiR8Nh6X6lrNZGeFMWWiSpgosi6gTCf6nGKX3oeyL4pFdTRiHrphXS4uqIuO0W9i+apWod6GNGTk5Y2Vdfqin2cK4X0qCabLyxXEZT6DyppZdu4esNRwMyoVe7iVCMS7fSdBh9aD+1Jp+L0Xz3/OEaeD7yyehUSex+uRjsGLkmhbcxdI8O1K4WnkpPQmH0+FHjRpFGv6tobxfRItovxkK59xEc5HAtZsdiR22/aoCeCMk9C1QNWe0RDbYhU497ZIveBq7AtbO6vlraFI2tbGJy5uEq6oVR6Hqq3fuJ6oTyElg9r3cdMvffnnhHRo0gKK/r2MZpb1bdX4V7V5HAopQpg9VGDrswNTt8+Vn37SAZKj8iCqib0PchbS1/xCF/W4cUSHaGAA9VLOj/1yuNe0nm4ivWP9rzJ+rkwIZP9jCKsKuMaFP9iKwzldkFy7URE1M1HaDhbnWAV7qrOr4mxuj+HSQTiSg0+7UBMd8X4qKc6zmdAjyiE1Qtxufjjz8/xiu2CcVFcuTOE3SULCzYX4cEx73PAU0A2YbSGcmD0yZ+4iQjInXK+iA85Ky0Y7mRoU75ZsQigV3BSts7ropqYn9VlSJWXY/K0SRSrSYqiU71+mE0049IcM+PSdA2cVmsEg5x/qudsNCXX7aa1urwpJ2GV63ZT9rrd1PGv203hHlLRdNftmtTc9LrdFF+3a6bUmXj9MJMP3fXDzvj1wynpf2fy9cOqWta0ZnLXD08Mj84QPKYBj04FHh0Lj87x4dGhzsnDo8PwmK4IYqdounr9EJ+OcQxNQSZMlbUBXEpfgeNGp9toQvv2rkHsP+BzZrbIrRfZ2la+ir6pv5SNor75FKgid8cFp75F4TfwejPh95QVfvvDwm/3Sr5lwbJxFiyrCr+zUeG3z/DlP6YwUxWYT2oNZ5ALfdIebzK32KG6Q1fYQKmw/94QVDziVNvqznirGdGAC5syjoxSYy3Uq344u+msrSkSTFPbNYjqAwcLeDVfK1+HNF4ZOXQ1rXQmb6p3MagwKbO4UdjknVI00zpftmkBgWyHMI9QsUkfboi1jIRiNaX59yq+0DuiMyDh1qUTsPDSUZuGd4deVL20bVY4LBLB6FVtWPrAJZHxq9rxQ7+qHSg7BoNiw1eTQ6ENQfWqdsWsWHlRnMLj0wZu7MlfTQ71qnY0kVbGI1e1o3FaGar5ixNf1Q4omkwrN4dHNASP4F/t6npQmbchBSdzVdu31/xLN/6DZ6WnywaZrINOda8D1vm/wT7XE3+872UvAxeUPuLObVSki2lR5fOuPz6fN+7wQhnR6k3IzyFic4cXN/le4+RuPhYhb7ecdxG/cvPR+RbxR32L4Lz1fuX/ITuuOzklbjfj1qPtObnKImHotdy8Yfn6mCLL1/vYp6L95OvNBAWM7ho8auieMEIGeYR4SFp23w3uRmMwdqPxDgXfXVlQvy4YcnQbaZ5gL46Q0TgP1+fq6jUukT0KmqqbR/3PIk/RnIrjuOb5QZhabcvCbukQTq0RXXMzumneeWpGWNS1V01+tKLJJZgv9MghUCSMTVzR1hhXTzElR/TUNhU0FUKAnv3YG2lSOtYk3UVJk7hOLaymhaG1qSa5vKb0oeYSdBFC1wL5KEwVmpWeKjZWO+m66Y11M65207QNSqe5J/y93q42dbakCZ5T90TzRc/BdUoTE5eoEU5HREqp1uCyc2finL8IKK12HIBwEA00bwJ+oByDxPWsZfuaDn+TVq6RtiaMVDAyUqAhov2vxAH3VQXU5Gc3gNK0fAxls7/4fQK3UK+kGNHyjcihReD15e6DWNXshG76eEiGV4i+jcBDzRtee83wmDbw6FTHFHVfjzM4hC3IsrHxbU5AYw/cEmDXoAyPcXjXqtXJFzqe+HDimJtYDmWSTXOPtJumKpWnOA2RZ0BJpe0OY1PM2CaSpke6FaLICd1qUmbO/LX2ZrV2+2lW6Za2PMSHk7qF2FC7Na3Z0PLRBtOUqxxcmeleQPXJ3UIjRnuUbNKjVJpAde2RfjzSo2RCjxLz4cQeJbZHyKb9R1vHe6RlYJukPdLqR3qkfRobJQX9ZOIynXcwN1IBqtaCHlexw46IX6WXaXWwUAonu/zTI6W4svlXWH1VDKnpB6mjXoDj2OxJN589tersGZ1o+HRs9mhlVJs0e9ycsqCoDc2edHhQOH919hjSU6RqmIqnjDskR4R7Qw+Y+uiOJDSU6ZUgPDkq16NGE30Q0WpzJqBIbLD6cnWhZclXk3O9Sj6OhRSFsEHm2cgnK4GXCwg8SHjiPi7GU78FlJQ9lG9zlShJK9we5s/DWM1p6x8aogJa8qtLlzEoFelymWiser8YJoGpYmGdGgKLPEFzdCkHl4RHNLzm2iLiCaTQfigmWWVMtWy3ChqKmDiWhKTprpGUSoke8oBV00zNPEmlQ8FIW+xnup23WJJMKth1xH2h1ZgPHbxcV8e+GGq8tikc+SgY+8i0KLTVBMNfaEPD4a4k2pWw0pVgpCvJcFeC8VHzR7oSVL9Qht58mKZ3ekEkeFXZxACJAw3ryqt2VCMyhwx6UIO0sKhbpEoQM1ZblPvgb1HrirUSAbEMqsl94J18hxXOx12wxlAJbcxv/kz3XnXBjQjvEWOtT7FpqIqVB14QnERPtAchGqHrYOQM0vkT4BXKhTXD99fAuCt5Keq4jYUZPNbkOkVoKj6lcKiNn/W9yLXPcPtFCH4/6vuXSFRE/P5CpmUrog2gCjYxW27q+8/NQ20LwaDcq4VshMgVlobqyROVtNcgDceaYUUbGV+ruxGdzOawzblWqo3hV0jmMlVdHwEux2SvldLRN+eBGi2XLigjHqOhQhJUzKzfZq/Dl3oNvi5Fy3Xe0ltkrNXZ8zusx7odsh2KpWzU9H04flSTjXW1dKFeUj/kB76cLqDe4d2Am22Q8kg7K8uC4ou2PC58UotQEkPIjqIcaPSevKKTpKLBw1kUKFJQTXO5zZertJKJkKJbWDGn5DangP5oRUW9WtVoBUVcqQLll5pdOtusuEIBD/KvV8bS3/MDTxxOUuD2jFXY5YwBeiAO80x1nYU4MQtk1IZQKkLtoLfGtT4Oh/VQN0AztCMuswErBkDVNCbn0p74mqto8LvihW+9ruj5kKXyBniBtjQeb+Bwc4pkuCrUAuCZOtJyQuFhwAeoamWh4m/jwlqY/mkShCIR6Ht54E/Y5E/FUTSyxfd1CPW03TbEH1t9Q2f+CyjS9zqTi6jyBuSPbH4TxLiKxCKDTkxTQ+wuAtqPw5E2RWNtwiM0bVKv2Y4TUPUeTXO5TflDDRb+IbBtcF8pdYlcZ5X1H+aBRhvreupVe6qtUx5Ij/H0UNdUqjyM5y53xI5pdd1CYuISTW4tynFZrgaXPRT6jMkZVXsOSDig+po3sUfM2l/Xs7pbxoa+ibSaUDsyPlj++GAdd58/jGKhtsIfhnpYlSEpS7A5fnlO5OFXoO2a5StAK7DWXrkkRLiRQQlj2cJUelLEliGAqFRMrSdG5z4koQgtB1BzudavroMpJrCuvcLH+Dq4gfAxwtrLd5h3AfiYaKiEtuVbAmweW8LbQirKrcBKCLrE7euk1ut+nBti5YvNNU8NBsjX6et9P9R72r4utz5YA/YFytXj1TND5KGt6oSmEJH0qJ1ekhx46SfVdZAbbzIW8XBWjXUsH6aOQkUTyxlecMM88vNA6zWtiOQtmtAK/+RakSjpt11RhjB9Y4XvCxQkFTSlwIBHWlj4Q3Q1nLBeFnXUIt3ycyMKVpM6lOQeaZHXbVpkXZZ0dXjLgff5fnS80VLL5wydPLYjh8kEKHG7yP9+o5tSB5KPQA5x3nAcH0fGqcs83LLqGLrd4egY2lWl8DCGHtoXSPsUvMBvaVVwnFYFk1rF+LtJyxp2XLU7uglMf8Fj/TTylfEFKpl9iFooqcANc1Y+5F6FxvKMAjAiwBzCVKYWeJg1hpCx0mZEJPz5MPvG440NjDCoGBizbXqqKDOlv3by5h+P1Ur7j+/5/Me2TDD/iDxj9h/fzXkZlLe8+/MtZ/3x9a+sWn+0uj6Ravts4ma9f8d1zxVLMt9ed+uHXnk8u48/jdRa+t8ejnXEN+DbqnVE9MaZR8TbqH3E/kTLj/jwWzT9iBGsmipEkdZW4d8vJW2+Dqob6vDa1nXRi61fAc9dT0RNua6geWQxAUfW2h6WQGa2T7jWTfyzzyiwFw2V3SEqTynA3Wzk0dQciou7hmLaHLOsMf14VZa6FU0SdQTEFx31e36d2ABC+T51NvJs1HXatGxIpqk25Dotc67TBEFhE0FsruuOlNqlfzQ4z1WObdbcDpmvaNKoEqWLyOSWUg2L9rwwRbjsgqsaa3mWak1oTDaAeo7qJ6uhmBmac65SaBquDayjrQ4yKPsGMeEUmrbAiDbSU7VGZBXZdNsCg0o1lfnVdyHCWFWirmWBMmDsIr+HLxwCUB2qYQZIaHrmGpdV/bw7eJMLXtXTJjm/7ACMUbdD0edOaMm0bUnnmo3NL1lwPvEIvCvfggflS5SZhN4Jq1g+ySqWUy709dp1A29fFXqLrSi+R0s0TVsGaxjGjF+20DJetiBPltfwgO3QhXyWtooJw1maFlxYAy4MOH+tfFmToQZmMOLgUWKkM2uIrorrUB3UTIa0cu2Do6crl69cGsfT9GAdI8gt92irtEpFQ5k0YjDsFMO2AFX7uq8dqYfEfPuW0Vq2HLG11PDmfCgDRuPVHqbpI4PxCtHXBdqq7kJ1nm/rRzCHpVOSdKrPAcLLec7t2SZn73U5vduGC4aCANthh8TYe94qSbQN/EuxP9+B0DX5TpqjAvXkp9B2DoUcOpVn0Gn8twtbaxB7RXP7LE5na0eXU0B4YvOd02loXGFNUl1NQWmr6gruxy7ph8QUp9PpsMB0Bklm+3omt69QHVQ465+heS2Qq6+FV8uFSw1fweGM07epg/yiJvl8Sbtc8ml4r+SbI8sRCO15cC4/C7cqR+LOpqB/Xw3QV6Vb5ngZB8/MT5dxqol9q9PpbLYhBfNRKb/5/H4Wv5OPRBs7C3h2xGu0FnYUhYF40hn56QQM5ro9uMAurNBtJwblVDoVwNDOale4TO2v9kbtVlnbWqdUO3RSjUdjedhc8x9yy1Pakc9zgxltVCC2HfdYZYxqrvFu5BDnOqHYMNSJ7W4MpRxfnQBp97kcM7LVcngFGyvnO3eMt6lM9zR+y0+jXdgQ7qKtVpC3Tc0Fb6Ou8QqJG2wC1g7AgW5zeUQdd/9yukKBYE3MONDTeVgj8aNUtT6WUQ2tnTWWynjl5roBmxVZekF19E6abWoXb11KLXIuoI1TtACebKF64UuIkFKYNtWQXBtKbpXJrbFkoWb5nFmW1ZBhiJ+amCM6nL1GVvFtsvTmO3XcGE5z9hbgVjtt5nALcIYf9RcIyVrgP5gIFi6LQPFQ8la0Zft+rP+obZQs6kAQLazku9AKtex2WgBMP4226eAUtCvvKG2CuV98UZQolmdiTHdOfMj6ik8cDUtFpZH84QVtFkR+1t2w7gyhDG1H3HZBnOI0jdMGykjSNmPBewbN4LVyRbqI54y5AkEzY0vJqbDpnKPEnHba8d1aDtPWycNUCGy3KaRPM0MxR3qvemTEihkdIB0H4r+ddiywPqlj2OOPhXYpJ4LPwlB8ReoqxO3bRTN2LHZ828ZiW2UsZsxYnIax2IW4XRqnDZTZRzP5rDTjNJVcoX+wbn2aHYhtUhPKGKqJEEO0E6Xu1BuvCiIzHAubzZpUAWp42H3FtnIebNd5UGDa7EKiWunEMt5h7J3n54yD2GlUgM68cJVmmAlETjR0PvcBOoAN8BreFeDKbq3aiXnaDiugM6BvM0OUBJ3ZpfZLd6Efu4Yc4h8oL0//tef5m23Cn1r45Xnn5eS7EjR5byV533jyuZXkPePJuyrJZ1WTsZPUG7iw/mPvjyMyWyntk/zsK50R3kpB4XBBVQ/bZ1cv59hRRrFGgi7u9OzmNf3GTNy8Ln4xW7J/MXsAs3vQtaA0cVKqR/aP8rks6THO3Z4EE9yu1mBDdKpxqv0UqCdc9vwczbqXFyx0BKth2xjj8NX4QMcwaXlGeOLuBM6FTDTPcOHtYlJObla4u3gCfzgn/GFMeOIkB9/t5ie+IJpktnOeUzLOgWetr/uMFF3MKAN/OAv+HYE5JFIrX6R23iUPJmdN3+H9FpfdPVqAGdV8iS3i5T2FkbLc2KNvoR7spGpfMHDmCXjVqAfQFb3+/YHIbKfyZVrMt1I33xbsNbS3ZyuEnJgnnVaAFzJ8AvW0AtouEV82llZB6TJ8MkvEAZt5LJs2Iu9Jmwr0StqC2rdq7Vqh1o6mfPtr553I1TBru40fsM3LUr1iWVu1jBbhG46NYMo0J9sofGEai6+WOEfdWKnllYjrmBbRAsaGcHaBr4W1r5Xty2kr3kaaCK5mex+jm3EJXs6dQyOXQYKW+4GBV1G2rGBs4OB92jjh/zB5dqOfMAnKhXlYajDM1ENteU495QodohDJ+w7agYagcWiTgFagiCxLsvcaNbG7FQ1eBlhMC46aFpC0QPrCeQBZ9KMA6AsL+sX+gWAlx24dzy5tkecWajKeB2wfBatpYNQlLrMSEk6Di+lLsZbkPWz3xyYSoDNhJqK7h3wzaQ/YwH2eCdztlRNsuV+ZX9z67bJuLPME45nnJllWTrLtAAPxiOQ9/nQ7QQWDMFYZT9YpwYOlvOASasWSWoGWbFpDT7FKaiKpaY56Fk220XZTIdVGkAUsEvJlyKfJWZmcEaFNW9EmDAKJ0LjOlW0VhKJirB01047eZu3oP+cRa0oPINKmLGHK1Swh0KaQacpWQXM008uXgr0A4ORZtq0yy+j4swxgHp1pOsuWEAcqoQa8qcFom3Ab6jlR7/+OmadGqzG/kHkBZxG9fAEac3b31qPm093qlNtJha0D2KhZYjosxry3l3NhDvwX5ZTTHLqwHUS7B8hIKjsWUdgX80LEsUxLwik0pwn5HDEAaAbJO2nW5J7F6ykcq3mwbb4adPvQdcq+Kh5UZmlPcHZay8lpdoyulvNMR31aujNnR99hHsZ066Zj6sYzGxlPN2Q0MliI2yo5Z2nWjHRmR3pbOZKewXzUP3lEdTRTioR1oVgmGmQFGq5xOBOfKXDob62erQWWLf2I58O7cL+TMxM3dCnMBUMXjER5R0xBr26QzXMF2+cdFCFccPvgkP2qe1i53X+d3nAfMhlszQU7qaG5q/Tli9cp2nfjxmP/+qt/feETBvt+8kV/9LNn/rzPlZRSW/0StiXW0t9KwuZ13kvRDWvGGWYk3BEGqfXj5TywF+TB7yLchS9ceCMw6gB6CFPHo6XX9DI5x+jfM4Cvg/vxq5e9m9kbwRnDxHMCVlMdMGOzmMPDXco+SVRjWM0PqJn7YJcJE4e7JozR4i+5ReqDsaW+LaqpE77S0vQrtSbeFgmFfpy6+5o86iwyLzoUiIQIb13qyO1KyliY31kv81Kn4mpZr74GtdrVTzSCfF/upWP17eRTehZxwOM/Tq9cWpbjSBh+rtwNZjHxlJrWZFQcMm83BRufd/pFB6JlGSuuREM7NRSVDrhb2W0AubplX6apCwLNBxcY1QuquvVoo9dcHbXR4UwOZHAJtpiqdHiq2uGp0Q6b5mifp/LOSJ+nhvuMa+uV++Hc5w622Q420uPc9JgTBSDacUGpmtPVhlXvlmKpRVAcYSc0hozHwcNaFQ8BylaJOWTCJNShVWKaqqooDlWjx7NrMYp5NenCdy7mjeMdIsWLgyESU+kfNuOQ96AJn4cm5T60qIuprqPp/v7ea4qGydygcI//noSfwQXBRqLuWe5aH3bP8jG8q3sWTZIr6J9AMO1LotAfGfn9+L3E+Bk3ZtAafY6TfEWTzR1ybRP41xTcKhqCwN02cMwGjibWonZLiV0b6zjq4rHx+3sgAGrImpLx80BjRcLTsv2rUwdruMZTneUgSCSfgwjIpWSawWPuiBxmUUBzawjNQPF4hupi5deyFw1uf43bCu8eTfN2N97W7NsxvB2yb0fxdqBJU1bLZArdmFc5cp03XzwgvB/o712pOmQx/b4jNYE1GzhkAwds4L6mBZsNHLOBo00RseVLqLRLXZZFIrQToZ7ZBU7Tstz3VN5zqwWTvm4D/BR2qcBuhmaEDdhGs8hTCyqcAEagOZRrK/XGc9X7WQWcs7SEVvXw6Nm9YCJJmcKvqWJyBS1eMvNyN17IvNyHl90KcwZb5WUNL2ReDuElMy8H8FLTIcloC89K090FbjU1pCfC2GyjGaCKhLeDf9sqpGQR2XjzAGZnVJzyYe5xsQ3ZADwDlgmIz+cp/Dn//BOYy60Ib+UwXqVuhMehBhzK51MR70NEvCjoQ128YrMJjN1C82CSDOKlFjRNM9MUNk0z3RQ4TTPnFDpNmXjUkV1Kh3x5+oK1Mdz9Wf+GbT2GUMTxsjfL0laHBJfgZ4xZTKpZurCR/SKSqVG6nPgmk/n769TAQvE1PA+wMsl9dYD/9IDODwgha8tVw2rLFWHQ4WAdNlob0H65Cb1k4oS5wSW9BxYdD2l4A+HXavgOhA9K+Dz/RjWoHSuOZ2+T1geUlC5anL+y3fjZU8TOX9ku569s77fsr+xVYeip8LBiXrtpmb/JRBPW7AnPLjUhKNMLU9kvCJDFk8ucuS0LBhBKkLjBnuVtalacfuBrnP5w+pyGGIgZqVYss2JaNmyYZ38Ca52wyZNQXT5x7vdOXCKXs87pHGwBjfQ+Ha5gGdVRrSfmR8IKM1IT80b8mTj2owaOCsT0sVV+bZSMRgua8HCphFzZAL085jsNDowvA0YqyA4DOsIE2c++B9lMnuwWTU4p0Wp5KYZJc8goW+VZHtixbE3vkHGFvF4QAVJtmjoM+yjwhtdilMHPnsEAKFqTRnkFZ0LsLrdbQPpuajpzAceACv61QAe7EQidLpOzfTEWqGUfBNhycSO64ecR8Yp+1BddJ55XN4cUTEAkuGxZ4ySK2QUbnhGFDksLG74CcOwV7HvoDuOGcP2NZeKBveSCV/Ycj/IAa6rdxvmxpe7DlirEvdKaO3HXAHXfZQP32sD9HBDmg5+gDJ+QJ3/i6/NmX9KDQ3hatPvwdecHB31TwpoN3GE+OYrnMR9tuNOTNiD2BVrPqhZ3hfnmcn3NtPKWZk0oqGI4CuiCtEnP+PfmUIxfw+wAPESgNvxmPyunEQHjQR7isTuP9ELQ8jC/qZGXa2QAOvaD1bMkTV6tJF9dTdZmZMcw/Es44Q4NMmEwj6T/sWrdvWq0Xy3vadOzg9JUdW33FbaJKzb5NFnswLz9lcPW+U7SpefHKQ0ZnTP+Cxilffxd6zvmtJE3QX5nq8ypMqV3ZcqUro0wpTc5pnTNMaW3IZjqF3eMfPFm98Ud7ot3KBt70wgbqxQNYJCUPM2OCFFw879qHWzKMqcdZU6zpxfT7ZrypTOgfWEB7bt8jjt50MPpm/Cqunaj44mGF5F3Lu/ikeRbOOXuTFOWKpVRJ++RD94N3o1pBp74NCuxzv025KdlDlrmlrkKPAjMLbgVojWEtoK53UotsAqtkrnlQOkDUCjsbFVTazuTTJzW05a8oG6+AxVPICc7wblirUZgzQYO2cABG7hvxgTutoFjNnB0hop8G+3IT+H6ToWImU4FlrWUL91pO6yvpwESyqYqFLaqRAqqANSawKbODOXaSaeM52r1MwcYKDLgMOQUPE6hU8H4nGrY1EVlU1VMpi/H8JKZl7vxQvrCXa6yqRkAVfJieFsrebEMICt5MbwdSGhBR4hyNorUE9ig26doZ4BIigM83reQYAJCayUKYPCv6mH0h4e9QFYc0ctzB+VIzWkW/CPW0735doMbLHZNUKe8aWW0FUpBUv6VxbYe4xTq4cD2kVrQhnwX2owyITCnBUHe+ZMsZ09ZDMeltAsd2U5T+IPQg2aEQ52hZXkuUwqZUko9jFaPMmVTp8pl6jkshjt82K3Cbyy2m5e9e8kFr+xpvO7DXfCq3gMBTzfvBcCj1Y38dJ4tmPa4yC/6P/tL+rGCuQZh2unO5tMgpwoxgZ4uNB6IfVt5CGLeglHYznr8zC5oAWqBnTpqrz3PwMJuZXY34eE4lq2gvvve8LKDNUWFbCDU2mW5U7PcX8myjiwIZ451P0NZ9+1mjJlUlFw7nSE8+VqCoGHKD+mLcuUH5AVs+XZmy29PlNu29K6O5WCU9+8Y3r9jef+Otg3+j6U9EYwdbOw7+3uWv/iX5y1d7OygSTvXedho+1pB2VuQGy+DC7hUn8cQeIY27OJCNwaYB4S7UDIP1rOfhorsbdlNeAyKXYQvadc60RGHE2uM+X1ZOmi7a8EDYlnzFKX2Lcw/djl7pi4d8K7OI7WfEWOF8SL7+vWlEETKKTowxN2A2grpJ8X0/lXRmvM4apoyfgth82mPw4+wQoNdkFwQqiVn0vTT1HHBsSzvVdaY+cpKsuOhFEp+vqVcXLZQkN0uA1Jw87czjKf5GV4Q3IcnT8Z78aQLgruncdSCji2pHKunVzzYWQbrqeEsOu2revryJgvIiRcHDdxhA2s2cMgGDvDZkqy5qL0L1aptCO1EyK4pO0bWlGJ8PcFKceL15MAjuZ7MK8XX9URfDul6oi9reCHzckd1PblPNT0abtm5Ql90QbpcX3Sp2itjhD0hLUMcyY/93LwEtPbSXj5LXVrG9Z5SPQ96aHg/lWvOFWwMXJy25iucsD9fKteEfJGD900zxcKRkvEVfCpt5WzFKSu0yCH+fqvKU06jOTLBsxhWPPZ57b0PzhI/vfc+yALa/8dnmrFE/OFpdNamopbTzGf8rHzWmoBcZ9FpkLKcBhHLWbQT4Z1G4tKqSFz06OoUIL/0BMIwnxelU0SXrB+6BRKoni+lKiPC8oPVapmWzOrJ8yLfhefd0znhef90DsrE8wYXUbfIYrXFThMocnfEq24xTWe6uxOZEpsZLnS8T/nOlic6ZndmObzZZkqK5Lw/rRCCokIIFicUc3Y52dNysvPBscyFs3iCtPSsGyv42flZOOLWxu0QkWabMT8/S80w70BfvgGz0tfIJbFZLGCCSpj2yPdtnfrzMvXRii6jJxhJTP3cTf3Fkam/9B0x9Yvq1C+qU7+oTv3iW5/6Ozaf+tDJPcVwey1waDSLc2F030zYVikMPWfzGbuVIXbOQ5uuE9DhnMpkPWd4sp7FP0BC3cdsA6+3DaBGq0/B4T8DV6bgjlJYegX2W7N9gsQ5lw7mZraqrDQ1uH72MK6flZ+t6hypzNUSv6Fkwu3hVOPca0ZZzITaVU5vnSKBTcXn6toAMTVqj4kFkSghHBpx5Onis+0+lrwE62wLm6a0ZGVf6XQuPKTtlVKIzIuPl13OpmulVIrAALnUezl1tCrwUWwiCpsFcHTwXwXR6V1QqAQ2gUXj4FMleBGHLpHQHg7to4TOwCmfIlH2VuXLXP1yBwebUBTKZ0NZoe5hjBxEYz+RqZGJhoklKwndnl7kedeK2DUg8RVyuIgogsAtgoRt9+EB1UTQxokVGVt2K9qRXiJKnZAQbBgJAdcC7uw9eO2kfdJ7hdkfCfkzIgPNW4PUBfk4kH7F98IJIhW1YXWsomzaNoGwCNGh0HQI/kEjnOCj/MhZ8bN34IbTJRXY9RAqgKSmA1sCf4zM1jEmy3D1FQeeIamtd9G6DqEygBNpUbZdKeUhO1f29190DfkrxrVtqN/KPUG/fz17XxXXHdIExOl9X3UnUavYCvDwXSausTNIpbI/lYboxVPJnof8LB1IYFsQVQ0LHx/mf/FthjkqOHmY3z0M889+p8D8Lx8qzNfUtk9wHaCgRzIIlUcyGtYjGS/7OsCY++qp4CJjdD873z+Xg975/lkQ818obtJUYKhmboLzkCKuWouQt9U+vBGhe+EvXIUL5StwlsVF2On8YUssD+CbrNCMdaZW2cRMEackWllYRFAux5151ASPNEzckIZ9GYDLUSAtuMRNHLisZ1zFI8HDRfH9YtvBR4K493inH3pi/ShisoTFJkCrSO13BSg74g4M7XpronM1FpWsPElC8G4MhR5xlI9GSfM1zfUPrdvgs6gj3G2giNsYh7wrTihZK5KB8bWidgfEc3ZSudzYJL/ylmqDtfq4f3v9KWobBG0hMIUJbvZKMnHxA31hrPX5tXmE6kcGtjS9jxnDPyvZljSeJfa4rvZxU5tq9qTP05M0OVyT3+46zA1gULI/ALYC3GpkpO/JIaGvdlN28de4v/9CKSboXwy5SFluuZ6m+3GC5+W+DrNbLDWsfS+CI89GFZ7eP6nasNe8nI7WaxmQIhj7HkdwlY4Xn8Pq4OfH/ICl3KqSATyADFjtJ8iHgKRqH3CaMYAW4lE/otAkHyvnmrxg2IyKV4ECFRnY2BbqcBpizjddSD6QWA3AKJ4b8zDi3hI+x7lfzyv8PhH/XdaTicbxO1dQM2yfcbK6By0ivZUe6VX5EAYHumoTaE4dn2Xi7uxcpiwkIXAByxICF9CS0G452ovVaT15ouaV/aHSUbXAozWoaSwfPa2RhsXEjRmLOtXU9kkR9HKxKU0c4FjzgRIv/UTbmGhV6icwrCjI1P/Ph9+X/23h9/f+0P2fqLoIi5+7d0xcJ2O5+zK0EMduIY7HF2KXLqlo4kOsBNSps2I+eKdbkAOqZb/sFuSYnEcpirEgu6tyVLPGTWLNHKrSPsMlwQqsSy7iYh2NWHgCtZ/lj63AATfuLaoUqR7IY0EPflIwvAJXTJG+w2OuB23QFkTaidgs+xiyAI+EfINyanNQeQtOytRDeSB2LUyoS1hb1LEdA+dXlCvQCvCdrnkhXrUzMAwmMIFRFfFXLi9FaJ2OWd9ElzKDzWq+ykUzubvdOrOPkCGUjklL0QztQfYu4bX9YTtU6V5Plgnw3V52B7LAwJLC1M5KUeA1CzTe1PqINDGB6oa6LcT44iENFrghLFO8Zt1JeYjgeIQDa/fLR2EYuoQCrUBteA7Xk34v+pyZLmPcnQk3rQkFSEhdDliLMIFEKUAZnuk768xJxDCrVPHSFG6uAqLq0UJaFGhzCoeMAfbzKjyXcQEZqJ5d7+HXP/y5Bz/4sc+88oajnAxmi4/1CY3Ofh0fip0XuHAqfGyO7pUzgxD36DYUVaAQGTuOI2aOA7swZkcqfkgS1cauqmBHLthwwSZ8S+PIV7SxE4qght1Yy5vixCoPqv4x8sipYau9HcH71PnGiPrONyLqgTyHi8wbmxWD/P1kk2a2XLAtTnFbw81sreXtEzVT6LFlvPbs5eV9b8UvYYUNiSjdWB9ywkNVJzzU0LQjRYMa4+4yGlRzxUYn48sHgzZWjtNTpyazbdQerKkCi5+9D6PvOllEZV5yQRYbAMVUZOnrIUewH5dYPEV+nwI+qhg1AYNxCjbyJpBGhsw7rp0TsJZAwyrQHSSpuUZ1PRNSSx0UGjc2OipqKsf4SJOWQgKkdoI8NYv1KPj3RkzFV2FYvSA6zz+OvtWyPxdyvW1SLCiiXhTdPdnPPhYq3HXMfk0XJkf+9xjfIeXtWt8JSkC0NNIbu8yacmyl3nf5kZqyBnVxc8Xr18c96HgD8K4VXPbcvXTk7yfVqxTepGmjJl31igXPFW/ogkW0BpYIUybcrJoSKUuspcDivkfeOO57E69k4KaEksKKMliw7ymLP/qCP37yWzjsUTxYL/0q60frb8QJ3wuOL274jW+3uOE3Hoq44f3D4oYPfKeIGz74UMUNz/Ch9yad3sg5Pa/6POr7gqAGX2lVLAWsbhyhwFijAqYxguW+dcdZM6J1Pz3oeUGFiwoUWOiN8k0RBWqiAa8Jx0gjSTXd/OxDVQ7JLzkkH68688Ah+YhwHBJe4H1qmEO6GNzCUcshBf2PWloRKIcUWA4pO1ryRcFmfNGHHwZftKOkKK1higKyo+Ti/zze6QvRFBTLrMH+WJ/4q7pyPxA7H1AYDxULSasAdZg05ImQ/Y6qAUPp2V/Jfhdv5E84nwj1lq1PCNxtA8ds4Khn5q94N4Z0ZXTNi43Kuea/w364ZgOHbOCAR3W16bnBbJUslvwL/giCozo19k9YLI/axZKSNZ1S67JCgGLciU4pAYj4UAMhMUnREnqAuLZ2nxqi7z1V8SUY4MIP7O5DfpZBcaVj9CjyaVUUJ07ApQpYP5FpjJvLKWLnadq0YY7vPYim9Lw5D6B2mQGJi8OJHo6WPZolVHhL0aXuGi0gSIv45SMMXHnEpJ6zwpIZmsWXRhGojUe7eosp71RtwqbUwEtDX1Rog6Zqb+bKjmErzTXhMc1tndVTkmExjYh58si4x1cc8F54qdIBmEObHSkfQJxFD0bEPehBgqrjEb7joxP4jvFYLuck+Y6PjvIdTyqpxM4Ki7GrymJocreSvDzGgbgWXGyokTz69RWeaIUSJ+6y6IyqKZoljpiTtSmsxGEf7AcVjeik2gscNP2epZbQYAxZg7G/R5YLb5OJu5s8wpPMMzNPIXcrw7q+PhZpNDT7fWNx01xhDZg3LPgHo4V2JBZ8Xw4imMjFXwn4Q5GTl2AfjIZG3FCKqrXtHX7NULU4JSD+uwxym4h8cNgQUjIx8POGlIZdVNVRYlOoS1qNbFkLHfhUrt9ijuWtVK8EU4sSDu2SWE7nh6iNQjINc6WVmQOhUop2pdLzJn+UN+0EyswcyHRY1WQJo1reGKV/LfR2fHxkFNoikK4by/ctqm9YurZWbgJ8CDCM+ayiCV18MVQMWPU2BpTye2XnIHQkRVNTHE+qCRaBrbY4kOYWsV52QOaQ9CXBS4Ov8+cNcxJgSEbEg2qH/P1+FJTLjqJhgtEd2nsfCIff7wx5AD31atDfmwfV4QrF/u9e4VFgBPv+ECMjPjPViHkgAuVohULiJ1J1wNTXnjA+autsqNEjg+Dgo8sR2qLUSQBZ723kIdXzwJwO+MT14ULB9ms27PISVlYcqZ90Oyz8qNKyalN8EHIljQaMtfROP8Z9BwDQHxbPTsCPImbRx26KCE8yz8w81bY1EEdXyoqjZWwrFVtwjC/dbLlk3d7XqAU4GttTWAWpjmYPabOWH1H7FrhTubSntl3VTyQcVRsvFSl/IwqdKJnfmDKhdIOKmLUAjI8zp+RpWB7gE3ZNp9KP542Szqi/VYWWtSQUlor3DGqjbE/N9M1hhLOo4LpAKY9uPyvUUu0E4faQXrPdY6K6HCVmnnEc5+FgxwNVyD75cuclHOyl0wlX36FygFOEOPV6BkQYESMSXi5nvACyDoBTKClP9NSmOiZBX8YFTTg94MbY9unpol4DRpQePWrrVAzcxEFcg/jv0p6ylzgMpOYGDsTwVm082ngJty3WxqamsaE0ca1oydFYnUIMeKiNTwdFyj9HmAwFkJqL0aUpR8OuU482/dPgmb+hVDMPMTpchFqwx7w8gqJLyslxDYy/08xwN22yLwkTPNWvE/99X6//zJXsbyQKbHXAhfZgj14tE3CNXebK+JEZ7yotOV8z52INajJfYwZM+Q4P1hfKe23nTTLWzL7/9o+ZadYFfbKF5hO4ov+7Ca7o7w8ix6Q7U80WPSsrGAocXTDALXSFP3dOUaK+jz2a43/H1gnlEMhTrleOTIREIDSXJ+pmrEEB9D2UShCyy0dNgHffX8VP+ujrvvhVJW+JpE5KYRzCbG2CVjQt4VNnsSPLZ3XhGXa2Dz4zD6Rf4eR+3fHI9evTf/j9Z7zq/tre8X65lIfTLyXrnrMbR9G3ugX/xLdvC373plvwT514C/5J3YJ/dwv+mye1BT/qH38Lri5I3RYcG6TsM8fdgrt980PccJ/k9jqYvL0+9q1ur9E1JuDR//Xb67C6vQ6HttdrD2l7TYbpppPcXK9N3FzT8N76qD+yt7574t767oe9t/7zb/ve+tahvfGaX20FrWT/q7o19rA17m6+NT7JrXCY/W+7FaYJO+E133b2t6rbIoyMNsMf3xp5w++3e33f6uPIJAn6V+B9aIPESVeAJgbkw4RddYMkcUUEJAAjBvZHN0hGVcKXloJXj/qBGJf2KHryphuko5UNUjBhg+SbDVKgGyS/3xnfIIFmSP0EHs5ukEiXU8AxGN4e6WSB65OJ2yOavDv619sN0be4GfIe4maIKnuh8MR7oW+V5firbx/L8cCmLMfnTsxy3PNdlkNZjvUowT4XtKWh18vt1DjmnYDNeGmVx7iDeYwvbsZjTGIsQsyI2708wnPNy+MRmqETDmuQ2Cnw9HnQo8SyGYzTedOQEU9EXWJogOrkMbaPsRsIWmrS2JTdUCajrT3igkKwFsJy5Ho7Pc847ZAn1pEo5MmN/B5NUYsDylRQa8OwGzA8Ci5jztyKyZSBmDXVtsY4jE6ZAYljHEYbhG2OZjblMOZG7gxP0xx/iWsZlIKM4ID4IBoPwSaJ6gaIdhNpLWHYWhyHITnoFXMUUURzV/Z0kA4hJqZYYmIKQWZDQ0uqPAQEXHx31eNnfAEPreEp5ibwFHNosfIURoLIccpTHPNGeIoHJvIUDzxsnuIL33ae4s2e7zue4lhVgoQGfMmSqQkLUGBUw/GsqRAHj8ranpR8hJ/9rfIRVtYzmd3IVio5uTXOHHnovVg3GBOb4hkrOXhm5lkbU4eqvtLE5R8rt4ok+p51CSwuMCLRw9ap6eQ8JlAzLtLjXlF387jU9Q36war9lIYzYLHmT+GVUDmAI34c605KyF1FA3OyYpiulrHwGEqNKFKi49b4VPrBS6nc52xz4hRMz7sMmcx65uqd68AO+av6BoYg4286NIUJiEk5RdNDDEFmGYIZxxA0qKHW/WMmEtavuDIBcEM/s5ZjVic6qzsyq1liSJ3R1b5jV/uOrvZp+kHfDwQPrBddbipWKKPiow5e8Qk3KFKCzu4sdqnlkgw8opBQzoZnF89wFRcYs79Xd/OIbiHaR6tBH2odY3DkzhGDIx9wBkfudAZHPqoGR5Do6ogI1n1Ws3dApFY2pc8ByXecytV19dOMfod2CIzLin5crcSXjtj+ZfepKRdz30Elc59a6mETwVj2knLv/hJgnM/hQDGPw3V5DyXd57yWGy3CPIKS9Cmw42Kt3k80V103puXxJPPMzLNmXFjjEao1/CRvSt/NIhmLAUL1cZ2CQWi3a2LBSUwqUgq1RcbJFMZtM348h9cLfhAu50K/iFe1FDJS0O6NfB5Gj+dX+snz8wWH94tc4IGL867TZ9oCu8ngFKEByFqZNEf8xxf/e/0OFMWKZXGuhfK3UgofX9vwyMS2baiViO1pIti6CPF3aY9nwAZtPzIocsqFKhBmK9EyhRgY5SFxEHdgPi/QY67BxyQq8h3obA/L905bOvSyqMB9bY2hEFdTSc1/bKP8ymJrL0f9OXEgp52i5a210E69SUlY8HfYEmlBaF1IRIXeVOBCdqKQnCM4wLFocSgXMQtck9QSipR2CBhoHo/EdLHYvpbn/eu4nhludiYA2VqcolDbWYQYrJ1awjYivKGmbcZj9CmQfJ/CNe5CfIhrKqdy1bl88Gy9QssVbJMKOmUFtlyu6TStSSrYpRUAHru0Auv2J9RkVJCHSEbZwhcL7ANqyV3407nmU4XHOZVhIN57diGKPzOxpLFnUEE7juRnUo+/y8/iR+ea/Gxaxts5lANA99efnT+KMWU3efmjBc2W6JyVYonvHMCNuErVgYIlXGfp0UCRx3DgMZf2Noag/Ni1/FwyUJ3mQHe1eBzu7mfED4X5Tk09VWFzqoIktyA5l3IDkp0ACRDl7loJ9DZD5VwHdAPUgrjanDr8zvWFsA+QUaj1zWk1c1zxqZp7kzHGjWg0J9RkHQIkoyautI2lXw6tz+PwXRLOz5eEPRq/h4NHNf4CehTWkAsVceYUzvnjBQyFFE0yp05R7ypzOMhJz+YrRqqnxym76RTsfggc4DaeFNvpTDQtKbYPisXjnOGE/TqFOMNhSgFiVeULNEChOdvZsv7evMtVCf3AtHM2z0NahvEEENUQFji2CdQYlYp84JgFmFjDSsUZttOkBKjChZaybGXwyzxN6ZR8d9p/af9aurDHwNlFu25z7vSK/Igrh7YMFZq3BWqn0SlMONBu1qaleBd3swhfwM7B8sdxndf1X8rlruSPsn1B37Zq3w40gAHL4rCJRJmQ2riw/agX0tw1aPJW6tIp9Lhr3n0TCPuH37AHcf1Q8AYPsp0C6hWnqas/heAW7sjiGlO7M4j/ruxRtSPD3XjUSLMvqjT7CSduNgYFTX8Umm478Ti0+9IexzxhuDMXnXRnMDT5A7ww931uygu0CfkKnU4J7qU8mrz9WMtR69lsJ0nG4kJZfCCMaAjXgnQYMxhrPwTFuJtPnE0KaZ/BZc6d4dduIg7W3lBMqTVEffwXNjON9mK/1IEth+fjErrkLJ5IT6SpH+1VujOHx5ztVc+tYRgeNM+n5lDz0BxtGM1xXNFe4YLzJ9Jp2moGqG0mncHr/xQWOJGOP/EmjMAKGgzzzPAozT9qIIq/ok06MWc7ERJ/NdwJThQ5dE/X3LNhieks/Jxi4H8W2EzRYwU1yPHI8osdAQH6yQyki9fU7olOZx2Dtlv98SkYXrfel4somsAodqkB2SmmWCVAe826tWnRF3PR26VwTIBdsrD1ijP4RvxeTIYjg7Xj14n7jRgI/PHttjnC0TYWI21ExvFd9pArHd+lYDjDkSw0xJEsrv4M2i4thn107XOBzm9TiT6qn0iWzDicJhJAU7eZDHlbq5k4LYFLpNXk9qrF96zZ0G8xSB7wqf0CmZJoxpH3TpiJ2qg5tGYO9T+EuefL3PsOnHWezLrv/PlWw3yrDc+3lM6j88FB7aELwF6dS49nRokekz+aTmVObSezg4/Nt9NjyEcxsh/I25a/x7267h7/WMLPLRcEd+K5eEFwNKE5aontYhH4xADCFD9zhqF0OLac8xRtlVb/qHDOaDtxABAIAQEVU8mWzbBPUhRF1hz7+ylfTx/0vOg6CsTFGXkreO6Gusx+4p9Le3jfU4Sr6n1fnL6H6i2tvh+DpF7DqI5UHFcKWHT3ehGueUvepxT1S4U1RSGUSF58UUT7gdBQ2pIdIge5iQC/D3zxMZbIYM7SEjvpbBtRqGm3XuU5CxywT2g+5zVtR0V13Y77ZsuMFktLT6Ai8pUJKiL3hGFdN59WBEbu+oXd3IfY3EeEcUCcvZJA8aU9mAce297nod386la6i1ACiEEMFlCMC13SdLmpK/n0ykKCR4KIBkItDHUToQyjjYObN6tZ4zkKED0nRlUhHjKXPgP1TiehLodCqaxBTUrfD4sCIvzPvibb/ObINr95gTgzUCHDvSNChs84IcO9TshwjwoZkOj2/3Vi5dO4KmTAxfRdWkQVDknZ/US73yi733qkuo/Ot066+2i7yjhCK+PAuJetd8KaSTKOeGgrHTgryz9c01OFEqXwFDLvWYRSYk8+ftUdnawvsnDoUoGDUDn9xIoRCPbemE1FRlAXiahEzyVCCYdWWAK9nKR/4CwIS6yZb5FqN63eqD22CotWVeOuLSa2RMgxxc/dkHXE2FNl5AnZm6ZoI5/hcg50Rawxq3QfPlwo3V8kNE38xzzqvJFciMfYeRSxSB4kF108MhF5JFqOuKhaoi4tUoI/plopSy62HBnAnrVILpYAjyVaMCJ1BXeTJRdd49x8XiUXPfFkrja6tprS+VuuqYczR42hhI8PaElOBoouWyIqFntcOIeIA23ayrUkpha1AcW5xUu6LZFm5fgl4UJ66vWbC9mKQtocwQGORYu5O5BcLKIgKaEHo3YAA83gkZguFlv49LN/HdczJcKFJdlFJ7x95dfFgmUOZRu6tIRo1NTVXS2sycE+VaLJCbaeCZJlV9sjLru7ednbK2WTLbtLZMrejrK3a9lkykayEVpEFAPsCxA25NABUWFDQVG+Q32LUs7r8KigYa4EQ0Y7xOUpB3ZC0FAFyilrvFc3fZ/iAG/82UnqNIQAijPT2o1p7sbWSjfathunUlu7AT4U3U00WbuBZAGRAUGPuEKwQttRk7gM6lCiNbW0phbXNH38wZhGTdObDMYWaXvRwia/LUbcs2LXGst6YOpeQSyDeZoCMj8DuK3/qVfi7eBcvdS+Luiyt6h4qfMps/PpdOKeyl7AzSCHlh7mwELpe9oURi2VL+Wnb1rsLi52i5rZKrpcCf/xPuBM3gcQh8/EPuD49UGm4+OPdwEt2s79YV4StftcLjFUVNt1LT+TGfOACl6SYKi30hbikvHkorlMOT1cpDOJdCp2eUewRXqPUJe28Nj0+NmdyLd3j0hrqcv8+3bw79xWlMsdCCsdaPGog1S2gjQFYiu0OhyPTUsCiibVJzyYlkgo1BJu4aIQC+JGbaEls2lpm9ainbpp0aos5BZRIyhHKs4wFFR4Q82jkMmOBxnUgxk1sf9t0//2SfVfsQUeZrQ2xRGZK02teSfIxXy+TXClZWoeAPwDobA+Lap9O4HaHjHYtnttoLi6S15pbU3yItyVmMxmSIyBtzXAb6mEnxqe3k4BqoKONf+ZODR/u4VpCw+exOjaopCWYpvA9FQ6A1QL7h8gAqV57QoiwukbsHwqf7gz30EwsbkVVhbzLbSTYlVJUpdmZo1MaRrqKDxwsgVoCtXhpy5FWIbsEtQ2i9DoEqQLEEMWpVuqZq3Xt9Of+9acud23fhLO3G56C3i+2/Frnbnd/3+7M7eJfrRO1m1b1XlW6ZvrO81722Yu207ST1tnYhcfhrs2RUF11zaGbsC0/+vctT1s3NoUs8b9s/14aYDy2FuGN3Mfxbtu5jRJNnMfQzBVpbMQPzXe9Yp5FopK5zvOMFJfShHcyx7ACPFdmIoPo6uLGI/nOB9GVzgfRi/6ln0Y3RPFntUAd4TvWO2hOzLCmDGDdbMvdxgw3nf72dcfCb9G0FI4jm+jzsP2bfSLD9G3UYZrSgnMyeiiFmf/KP2TrXaMR0v8baXikF2fu82TzDOr7AtFF1atUuVRPxE19zoUOhDS+uvQhIj4oYt+oErWbZrWlbjq6s7dYZ6SWPKfpgslwJyiLpriGDz2Q0lFnNGvaKW2WP7jadVGuZxS2SNz69voPRqVB9JW18IIPAJFUsiVRdTj0qcRoSVVW1iTHpTemYQNgZ/K7F8AyBI0xjuTzP/D4HWMd6ar8fOcid6Zrhj3zuRUjp7pVeVSkcbqpdyMHx4aFBHUFlVVMiG1MAuXOmo9MRKkg3OdCPjwIJrLQXpofnWObwj3OZsZwv0n1JZ+Pm2kMk2dgkfZq/tq+53+BtTEVqFfoooXz6EYxOoKffsRfftBfbtc3y7Rt336dpGsMnldZU6YyhCkKTvWpBjRz2AFJLG2h7VmP0P6uRwBg1CrRYrhDlah/vcCOxtjtT/SohQQCkXNoQ0LfTEBQySumGLTfMBKwhQ8S10PU5odPCgl9D/h3px0EM3UtiPLRYyNFEpzKM5eZbPOSX6JzjvWBk9WveMHsN/srWMbjI1oIj2BuGPGzdZZnDxekc+pgGe+710i9tEXdePCYz6r+2zhypmLnScf3PGckUWF1FIBWe67Mns0j4mkxPyAR1uoh0KY6VimZeZyth42uuczK9TlmHLtI7ZfXr5c2VtHflMsHR0M3MqGz0NIj1Qf/AG/2MZv2y7pVc6ZfUx2n3ruK7hEx9SvC6Oc+ynNVhJn7c5TPbSYG+oAz0V5olDyKRXRX0K+PZ+oC80URWAnykYlIQopBxFiMupwtqERLHxlohd1FDOhZovGit8lha8dUXN62pA6ZbJfCqXaIlHJGflSfZ18PBIMUQLpvZoCTJ4K7XfRr0UFjNlAzeTJxUxb7+Lw+gM5X0qImKpG1NGCuoWoboKqwLEINY/W/aBt5JJCK6RUdjC8+9KmbBOIeQjK7JhZUSV8bK+O1VbFYxAdIf7dta4IUle98rqB7xThE5pfEWrr4K3NMzu2BK1MFPrgBtW9N/zhsObmCxn+vwTJc7FNocqPEMdktA2LZ0w6XPzJWTCDKaHdEMRLCEYy5xCCYzWQVQT3qG1MHWPVH1czmTCy+GqMtYWWg9FZeWj9fusOd7hHqisZUYqupFbuoocNaHCRiCq83B0hDYvEUO+TUU9mRbF8ZVHv4SCUIzjAseYDwW/zCXouXTY2NmMhOBpzv8Zoz0ajPmGj3vcKG3X3SBTTb8tv9tJDwZC5znjUXCdF2TcmWZrS85z6kCmrujNlVR83ZeXSJRWdfcjVoPWdlfKTbzqzViHVsgMHS7NWdcK1BGuwmOrGsBWtyK5sv5xUSQUSsUsqFSNXK9D8RAcqJq4i2POkS9EQa+JK53mAR2niKhgzcRVyy38ZLSdmsrBXQPa8zk8Kh01cxU5R+12eGKB1t1Ji7WFdEMqcSgFJGoJPWCSHLHoKbW/+GE7boOdODQnu8g95QDH0IUb92fUHH75Rz/rw5ZXvx3WNOzxzXyPu3/wPqrauK3wovZPGoknaCTFPm91w0N5liTe7y/Kyg/8OLHv+ZhSAw4rchXfHOAIQd8EtpqLYIU8tfh/E07sAgy33V140rKV+9fDrczTTFfy4XkyuB88gFDhkFi+wZvGKOPu7V+Apdq7rFzC7ojxDngg/JrY7uG/XqtXWFzgeA0sZ5wHiDfbdPK2L+KBMhxFt0YvH6da+jz/+ume/ae3zFw9QrFio4R3lrbfg3++Zy3Qppq/YnvGw4KxRYljCDWO+8oY7f++5u//rPVqH2V9//2Uf/t17tsVsSzD725eLGRmKMM8u0VZfpK0+lyJqWUsSGlY79cqq78KDPNkcRMDWF+HnBVhCwDpGlJ4npycNcLJNirKvA2LIc1UR8PorG66gPNRGBbB4gPaoYfSv1eDE7LBQbj3dlo9Vvt6mVFyJKK9Y1NcKCR7UcajCVq06RGSKzP7BOOlcXsn+WYMy1XjVROh0P4SZDIFDonBAfyMw5wJns0jUtB6sW9lXtGNavkwcXZQ44sDoNRad+dVrLJNiQSv0EsmU3rfKbpKbG3LDxCX+zbCBRV+r0sMUSwoClaMxH+7/RIFjYJuUQGs+5NjLTFwk2hKeYCAoi3BSHCaZhS0fxBgV8CUEX7b/3k8UnIgMl/X634S3Io58gJ/1S3sAOLZmvwrYCPXMg81rCU0tKgGThmuzAxb57pe7BvJFhHyq1lKTIkGPT/eT803+XOztK3UBOVFak+jDUZ7s3WjVkvpaisQXPtK4YUpv/HKx6aTZe5C3lr7P9+LrHOxM6yz4FNZcqYIZxUI1RQ1q+8bKtB6oKnOYgGFK5OC5iIGhUjTGh8ISStj169ex8M5xZZuQQIco0V18XdcejJV2Ql+z1ygXV44bOuqaz0fZGEJUF1aGMLFDmB0AzmnPEim4CIcaxM2vdEWVmqoNyu654SRsnLz24LgCC4yrDBlR0UXMAt/brxOAajpN7TL7j83gFHaL67s7jMNqL3moksO7RySHn3CSQ02Scj+DoEhq0HVM73BFjXbOFXU8skI320WDYhjREd12sdPT1JOJVK8MtnRr3NaN8pTexegoBmd6T2Na+JNp9BdkA+YJMJB4nwVKowVz8joPtk0aTBm/Q+lGNyELaNfiivO9K5mKrmQrGrLZ3cKVLAKeIUTv/MVu2Q1H1FEUXcxrtMWiKUVDPD76j6zmtKwGzK0p5hqK08A2TKQTmFmL7D+NT4PAq3fzZXVjB2WCVdS7V5qzDe3YlfMBfE7GuVkhhiN2iEqLvWwPlU+xobgTzZcbpLSddsIdmZ9HyG49EsodrR04u5XyGwQPYQl0ZaXAnIe4vFga0GmcrY4baCoWD4+CluGF1CaGvohfWftSU6MXDa1AXJ7tqropSSgRR2a7KMAtUY7Cq3NmBsmVM+kl17TqeoEe4G/mnIHjrRL/DtzljmjRKpUt0g4Oat8beNsvSok17nhdetSgHVRbeZid2kL1sU4Bag+9X+gTKIUalaXTEAd1iEJGpVYBmKtAik+sazQpNhgtNkexOZFCLMkLLokUYtZpbQ9ZWD8F321V1K+BYzCISbW2l05w3bfL2Nd9qhmJbp6M5ypOz3dxu3cp0KDTimdxBtyqnQG3agKOfJe0GjMFDwywL2Y2lHGZpXkeNdjdUnmvYw3PBFz6nkHOXQLWMzFExj6fKgyoPQDAkAOwTy/w5owiNT6LzqIzjX4wjlpBIabxI8QDwguGeQsR/DyNUg1lPyeUPlQBIwgc9mAzXPqMnl8pmatRzL3oaT8Cd0X3Wz2rvfctJ3FW+9q3gzCvvd2d1cIz/CNxVvvds9rvntUqCupZ7Ri6AdO+e1b7MM5qX99IfNHi1CPNEfoQaT5z/fftI9d/8a4smSbp9V8EjZeBuI885eEOG7hR1scR1Lrhy0v8Br99r7dSnvVy1FAZ2etF3FIXps/ek7b2rCjIm9UCx75WmTIzf6kSsRStbNEkAzNtOYqMCE8yz8w8DdXqJ09HHVXDVpgYckU1kHvlIc4mrUAW/m4zUvumHZrGY4Y6NHNVeVfEqdtncjDJU1NiqQX2Qs4LdcK05GASj/35NAV6MCn1hGWx1AEOWR3eafCC02af3RFeMZ/uJ65tGU0DIeXzK4usx+WimEzLqLYNLc9nhe6rxnRE3yKwmv+KwGr+GwALgn1wAAK0Obj94BzZb+KIPPtfsvt29ghoDsRhlmbLmOPRiBl13MTua3wKzUag/PCZ3OsZgXJ1HZgZph8zNFOhHzNCtlHopqSbhyMG6RZzojGFOmubBh/Q/lkcR2WvR8e4buTh129CagR7VWJQUe2k6Y0WPYa3jMpftFS/4tqF63z+tce1Hm+Fq8TorhFi9DFHjDSpJlfolRhNYhQbgqoJ4ZlJh4OqCnoTLY9AW/CIYNWurnZn6ngTGxKyD6oTbALEgsFJfzeO9ymTPTc6hTcjqE3Bb2YwEJPJ4VdRV4MqIFi6XxVOKhLJPEXCz4nBiRmux3RPstCM7iZnd/n7aPbs2iW4xjaLIviOv29IrCqfLyhLtyjZwJR2QRKlsGILzYlP/qW8ZxzVJ3KAjCvbYEGXaJnmhVxy+wVAXYy49DECq4o6z0W6ngts4fxzq/rOIOc2Ip+IUqyyJrfD7mfrCh8tKd9K8wyVnjnp2Er14W2tnhXao6sMszMTxOnRArYSy8Cm5dJaFgAj+v7Y3uKWIuwTdMXB8/ZVpOrWluTYBFcAxPLNAoZTVObvq7l9LSmU8kXbhy20CGV+r7Jf3iq7uTq4hDwnPGt5oeXIVha9qiM+rBkYK/y22r0cz4SislFjxACJyeSDBuVDSSSQAP5Eij9Wq3zZAqKeL3N183ZHOk89Dpp2421/vogBp55pPn+28h3RAx1GWlSiMFy74pPW2kWttMC/qKReyrw1rLLwSdUsAI0WzKU8xRZ7s6CLBncFc2TvBAD5e7lenTjwEqotkNmxgGbolQ/5pNg60Wd9Q9hI7FjRC+D3JEajUO9d2g8qdOda5Nix5m7H2gBMtUeZTgIfnd8qrcU2Fk0DVm+t0DCxLe8p/Kgh4G9CbFTdrTZl85pnZmdbp0xvPDbVpMYO2kFN3a3WqKf35My8L+oreGfMWEHUHiUNAhuq2w1rdWqmNIO3GZrWN9jmkgPyKRjx6WCoOhSgRySq7E3tmNX00l7W0e2Im5dJ82T1jdBI4kDTak8ZI5pytghMKmX8TfZl6ydDxoV8k+TLsdLV56s2GyTjP3/QGE8zB05qGc9Em/O6i86zG6QfFP6fj7it1WYBp4qUYeKJmy+gLxo9YWv0HpiTpPOxDOsQCAVV2VVRF3NEcBe7BpW9SFt12F5vgxISsiWUICNy30LNW+SLUmlx4yK9eVEXhQWzYDE2AD5qyFjabkyLZj+HvlWk6+lPVlxa+GaqCYB0qolimvEvHKt/YeN9OIROWY0CUT3DMb9a53a8BsyTi3Xy7H/eKD0SVyxe9hvXG28Y/4836XJkQJ7e4sO26MJaj0O+XsfTS3hzEurJ4bUcnMKl37vQrerNuPvrzGbUWS8skD9TzW53ZOlXjT5TMDhSVJ3Y1Z21i+7Z+37wX/KvS3+yInGZ4MCuTL2qh9cBNfDfWvZ6MT63Rg0NSdqRMvNAfA+vF03naBA5bJ1c2CDn0dv3wFu//CdP+7ErLh5UPPjJWTAjgBYpO6O2u2YHERtPsikJ8xwBXQJ/6GiW0KKOWKvLOcAIh/y6spZNOHfvVe7bF97Q/to/5Dc9kVJyL1f2xMRVluISJIz6okf5DJ8D3PbF64/e+cqvv/EbwMdNXD4mQ4eos7Ly98Pn53OuoYmQZyQI4GmawuxGcD5m35yQzH8SOKzjlxLmpFv7LvmVD9z6lU+/+onPLmQ993B9JvudVymzal5/F6+lLbkpPJaLBZF9KEA0DPICgDGADNCKWO5QTFHMERwoIbhgNb+a4sG/6GJEp+QL5OWWObOlkIWg7V2YNpODCDwylZlQvkXPwYHdDXX6DRFgbD9nheUB4b7RFshVcNjFLdhwKsz8DzeTcO+tWGIMXId3WIodsnNyDIoBEUfyrGuEy/ef1baHlqIHOP03Z19/y89f/wRiT9YJkOAjv/DCDx3ddfCJVSvvCc2zKBc7H2D+ElfksNQFr2RkjrHRmoMS4zTNIvMWHjGXuVHNjMufrEJllYpglhlkrN2PvlfucJVFuVxg4Xfbmf+jrFihx1H2cMpODt+4asfYggDgZJOPyrNbrFZdmPv2mNN3x5xq6tZ4Sn+qu3FLQfbPLyu/1KNVn8tW/4PK2loD82ph0eyH8CmKSz8bep1xC4miqOpJy8nTfshbC8MzfKKsVoNDHPiDCzDrlBx56uZGpbhG0B3plKpuIX+sLf7gOU3OQfGl30ITPfJAVz9zgzu4M/0kT7S6kUUtr4E4+7YZRSTruwJawZ7wuKWmC7bc/ynlIleuufIkpUTPbvOG7UcT/eCtJP7Ya1BKDfSpuqSi4+2+aVyrYMkloICSZALjhpZuWXzqiKXcmFLwGuqmfPRwLRE4gIuMnbpnCoqBG8p6B5uadqZrJcJXOaPsNePRWhXA4hVTxek+xnGsCnDz0n0FmB5dN8xaTY3sVsVMhpjLhTwCntXsqwpF8gBZwFWV7KomNb/k+zGfC7hltjQoKxXmoZn1al1Qd6cyHjEecmbuNLdqUKrS42+8sP9mPzXyEIqUI6NAxiSQwxz7QpLMMWg21FJVfOvDR1Yop86rwvqofmUel/wWoKu1uyEvIlWIBDiBcICiGWVF9rp9i3T+6rhVuSAgcEhaiOpiQqUKDlqyPEG8qKBkHK9qDeRlf4GWAWcwK6WtSnk4TM4jycHQj4Z4z7qVaejdFYhslGfihzl+SbI/wDCmZURLYvf3W8+VM38IUsDeX9bL/upGLQvpGO9VTgJcGqLQyzdU1MW6v5/twBbpZbL6NRld9g+bHFf/tZ5YwYAJWS5LFaIwZfm/tYEzogWBzoZqXGX3oHp42qqjks0/8Ic+oNYRtSf7UnH5QnXH41Ybj6anevU0xZ6tQbExZ+2hO6r8ChwEZ6TS3upaFIjJk1R1y+3VT0ZVvZssbQWbbD3PBDaFuaDAnqc3MOWFca47H7neRtFySy/Z8B0XDajFC3F4ywAbrOoCTAFfI+qr+oSqfeC4PHsj5jKGWQfay25DROE7pUJdaVQikzxEzaJgomZRUNUsCk5Gs8i3mkX+qGaRx5H3D2sW/cLBcc2i4N9cs+hNBydqFgUTNIt0UMZdAhW14bE78DKJllJUkzJ9Fg/wZO7WSNM8pV5oh5BwN+QgNmm1VS158QVn0aVSYTR9/EQXRy+a4OJIKYdVywGr8lbfq49zF4Z8FOVdvCIQ7BEqGVkcQJW6CCAPFuYiAErAcR//lSgRWJRA+x1KRKghoNgue8IGiTYfanVVx1zs/jy0LBVkBYFiAGqFvz5hkPElQjiWPk+/lW27ku0IRLmFSpBPHiEekmawQSBl7gRMGP9XwMb++Brpm1mG4gUlQ0RBpV8Ue+f44fdb2InqGqrGgQMcHPqCCKJbgcVQ0S4b6O4b609g2cDKCpKulqb+idf5kKdg/3rvEpSp5xmsldo/egCIetsBgTNP1hDEPqyqqkM2nr0FVXXKOJxrSBxg8gtS2dtPHj/CIfzwNsGPYBQ/0P/7hvFjfQg/SjhFgNS/EYa8+bgY8otIfZjT/ZfGpntYne7hSU73q09quh+HhnnDNCy0NOwWP8BZTDh+ucJyhVOB79eEe796pYCyuLTh6W1xcAf2EEjssJ3qeDIM8C1L2L+vbX2N386gQALYBSBssj9vWLvdzZVcPqBI8/PYwtB29lZBV5Bx8A0h3MFFGgmGEhit9stFaPc2U4H7niJBeFeCi7FxiYl9O2KHbjj8iefFDixY3tAR2TlyJmhsGt6fjGaoHHXHopGIR00oAULLGGGhhXMQiERgbwOUFnMxkHiGFn4oABXkMdZjLgZAj6m2giVWVajwAXbTMSV62yiAx0E/REiuR7RSK0Guyw5D26oqnX+mnkTc2AY1Dww81WwLOloDuqtD7rkhFwR2Qz38kXurkr+O4kFi0QD+SN5R0qWaYkIEFIjlei5FlTGqW8LFFECdmAYmBWl1U9w7ZeTSD3s6C3WM1BsKQZNVYwLrPJ58wZYV20K8AEYcDSC1QtWlJH+4377Jr7lzv+UN97mGWDs8nGAgjjZIc6pF2ExaLxl1238JvabDN3cWKt58dN9O9ae20Wl98EYdShF9Lm9/3tTNWioZZeu4UrQEZzxqoLqGcWPlutivwfskY8v3g5xAvfW5RVucbSgEWtIHLaqRT1FLlYLwzm9Yn6iBhSHnuYS6M2oZ4SLPa1mShL5NA8MzmkZjimkIzACekG3VrtB0T7RXqZF3+IempLhMqUezfx2qT0wDFHgBv5AnLGGiIZWOUHJ6gDgNIa4VCiFApzK0A602+jbaLy9PuSK8Sa0NVb+dRryAsIEu1PCpTtJU97/TlxahCCKohi6gKyzZ012LKaqNqdshj9LslwVd9VS4aEA7IaL2fsgLOKq5wuua3pRX3G3QNA8JhqNFHcwOfAeFKCVPlOaeo2+yp64kQmbUyqFE5FEb50dwHhWpAU3go/sk+xUldokjdu+DdUdH4XyH2WPUzhdqFxcSHwvRC6tzJa5868vy4KPIKK8FmhOl82QHcUnMUlKnxNWHBMEK31xCs0mWroVVmvZ//sR/uT90uTF06y+pvNCwifrQtdV10dcUT1P0KxQfyaeOYgcqgvD3W8cp1sEUKkFrQj36KSsQCxZaRIAh8W05KIVw9YuFCoY8IYIiW1y1JMW77A69QpeO+IOi0KHgywPZMAOdLBuAU1lzOhxThOGLqsOnesk6fKnkyOt6zdCBLmbiyAngmWQ3qfvLjgGU2Fs0Q11zq5ZA0M61cGT0UjPkej1Sp5eKfatN9apN9cqm+mVTgQYMVnyh3L6CGhI146QnIoi1zCrMU6LS8xgVBwZhQ2QA1mrWuvYHq4X5QhO0P1EVoYVCSCNQszFb6nuNYbZHRzvEFiAqtyUxCMklvb7sTUTwqXpKOnQxLs8lgcSoT+KEVyDTr4BfsRKV+NRUfSlfyTq/+krWgTlK1jUkcYmit84yLbhO0hrGyKeKBFJ6yhQWfAWYTE4HGdcGKb4mWA7SskHpaIOSk29QwzRoBQ3SghOKwbQoMGCSV6XfeBGMWkkft9ltHKPFGGS/OuFGzpubfLDdKDWmQp7LVY2po+8sNabuNhpSHxU/iXKatCGpk0/jbkea6lahEJW/gJDsWsXZBQ7BVbwe6s4kWsV9X6MKpJuSBHk8WS4bME/XFAc5uTieIiiDb+Rt2PScsjgRQ1Ck2NHnNxEUTVWkiOmRW4opSm+BGi0UmKldSWxKYrNMzPiMFQeD5Oshc8HbvdtBpxIjTb3Rx+8BvVzvrRahyl3eAecxtwcrkMeJ2kt/QwiEynnv9bSEbhH3ZXLiZfkpPf32S5wKTVZ8i+Pv8tugqldXiL52sMkhaADbsAQMhL0VkYrf7YlQ4W61WiCtIz97t94iU8ffGVQdBwyATADjn8kfHXaWja4UgoxRQY9K0WXZJnMar1n4iD57Jd7zTLFGq9SumaHlPDSFqne7M1vKzGH26XsH3JwWn8BOlzXQdPU8j1rrh/e9eO6Xv/ezP/lmPjSfNmeL1zyBXJBPz6cB3UvIMwcyfS97v+pBmHahu9la9h5ZSjLyTfR0xbPcr+l2m9uTSXMHCq9p/nZa0OS98vEUBQTDRaKYjhxX4aiIm2kv+2LYqIPYgHT8iAvNfh1f70t/8r+3PO4Z/FvJdBBjFrfmqGWKT8CVqpgJrcdvdq4kFS+T1IRt1g3G8wLfsbr44SJz6R13WFxEvSO3OYwCzsMmUSXLlb0HgiIWYq1nI8P1ZGtv3OyjAPvGy8Qle0joQQtYnm2YPXawwVMNsdqNYD/OvNAVzaGHEypv1pMVSKOOeZgdWN++FNpTXMR/rFaNf99BG390KP43yvhzJxezayyaq2VqaBmJo54Pd4pWWuKrz0x+ZHpcqse8et7mgUZF1aOReFh1HWJLZGRm3zDGBj1hvGWgWurQP5mcJ6ZYjr7liJXitcMUSEaqscc0SV0rIsEvLCEBhUrnbw1iGFz21TeV85NqeUOlqRGFOBuek4fcnZH706GcqXGzhV/hWfSzACiWQ4oqqitxSS/IBVlJIV5/I6NFfT/sN7jsVZerQd/PeS+Z66Y01kuI6UYRDchnhWMPi1/FWwnaCSarq/bYkAp4ZB9AswZQXUpcm/VYSJQoxBS8+66I8DLXNw7eU07vFakB9BG4ZF1DWxisIEYcTE3wyDo/cEjVYo2VAHfhr8KhZRPnXk1zO67/2ZpRWENT9KSiPOGjsHrA9+oggOGLwPFI7nbrkG9AFH2eT2qU6y7vgk1VYTI9ve7vhHS1hkUklW/u9PIYXzuq6mcflMkBxAF2aq5hrZKaOhakus0NfvVcvSy6C2IAvW7EgFPzP+IJn/DDZnKb5/k7hSEKNwx138LUvbmxXvjq3w+D1aDAHeAFXM3rbUpSTTGHrhEQvgniMNQXtxh9CI08fl9iqmu2FBPFXeb/tSDC/FDnqVY3Yl9hHA/gPLoyr2XjhvOp+7znKtPy1FFnwnEgu3A9impwxtUVo18o0gBeERGRFSmla+Kqk8vL2zIJWgSUcXkGZimJuWMwFAckvYXXyNSNZlpdI9d4rNvQYoT91aqxd6tIX5c3YbH99ez1agCDAtHR982y/GfQE1PJYvZhWas+/jH8Y89v+LKGtjfJ6ZwBkQ4P1mFITsrBd0etwRVd7YoUmkH+vh/Y2PbyL/4HHjct8Wvc/LIdgEcZz0tMWuaGjliKuTiQtqpdpfQXwrolboFYkx8yOpas5z6e3Tx4aEOK25jDam4RJTKIRQgOSW4OyWLNr/dicoXKoUaQwgBwYMfgJMxT04LMYVVHkeuSUSw6PI6Za3M2xOv4ck0OYpuBFHav8Q7NQO6sr6kLFLmPh2w4eg5l1MOK5WM4VYBqntqg15EXpUJeSsppKVcAN9ZRjHPtPcg7BDssKM8jfyCchUnetXedWbxQ+6kXY+yXtScMhN4hrrnvB+/JrvnxM77wRG6wLCEKC/Ca2sZkAz1rMXllvF7TLiXUWkX0GmqkNhB6TXunvs/UsnS/IV3xyT+sTaNgoFgZgNHCcsgH5w+GiW+8NMagtM5T+AHfHU+oE02BQlF31Gpdjb8c8/IG6hnw5PVvMT4XQ3UH3vfwx9Ruqp8R/12KOz2xXF3mJoieNPwKu/t1QAsxzTi9srFWzNDMYI1njSrQJWXNJtCwga9jiszcUszyY/bKHn6Jw1cWc73yfs/aejGL6IE8cCXoIwf++z1/8EM/y5ZivvcFf/QbT/mDX/swq1bsvOWTj//M1O/C9dcP/dLNN6zt+CRit1z01H/5/Df+nmOL2SP88VxPnzPVe0UzR2iG/ErMoHDplax66yrrJ/aaFbygYtCmjWp9pM6V83njgEe21TSHTdyCoMgMsw1THDl1KSCL+ytyZ2pq40g+K/NaYUyae3GQd91knenvyqe40C7DFlzoSpEZbmGW20RmBuVcGkcXU2jPPBdEi/hvMKCZ4/bK+OjpSD/akHe0qQWGi1FCuFa0rPT0f6HnO7MX+LGOhrOPQmdUEzR12BBGepxPf/tEn77O972K3++q7Urh7kCq5QR9H3kc+mhtJfuIWThjhq1RVz5w4zl9peTi4BlfGAHcbwox10pRt7LBctjyWyXF/6hqw2sXWuac0Vo1i53xUAo6aT/JXie6Wp6YsaN69pfYRWrb+je+hs8hJSG7Fbm0KSbtlZyWvVGiPUnIPmstw2U/pUeXr/N80AAr2M3eCfgValbLgLG6FKhsi1NU26wSb6S/nuoqcYerHIiyqDiHvbTHnCjUS4D5Iy5lyUt/OfHnrgurZCgsNTUjZbx3Kxu+i0LYZSJ96+qpTKxviexpiN+cpltd9z99vo2rfB930ebXW5DIbzInTs0bTIoeHTQRsS9P8dijt+DPytt4UD6FR5J38JgTN8fTRlCXqTkTUU+ELUdRYcojgFFCs1AtttqLMHsC/oT4MU8tPBYoxQPGgyPRWllURxTTIgJdJChIxAA5aynDfbqGmHBqxEKZNDecBNJK0QavlF2eusAO1DyPB894PBZoDo85dACSyxmsSTOY2rN5lBq/GODfjHGPWbB0er+6uqFZElVSAeEKXK/EgiH5Foc7XeEGu9qNHjeIlpiDoUY+2xJBNjyeFFu0lSgAdakGGZRVzXZiFphR15MlGaeGjlNTxynVcWrpOLVL46kZLVaGRxxmUNsNRwxo8JQENJp4zFEDj4im9XRGGq1gF48ICyYEKEvEXJkUVZL0ATW5iSB32qs4g3aQZ6gjYdoaQZ21cnGdGU7YXsTqPifOF4Bpw+MRYzzqdjzmNx0PX/o1oHhj3Q0Lihwdlnkph4dlwag222Gp04JqzprNkBoU2l3ME6PaZT3ZtUFaIdxL9itCu0M9bw/tnpDqY7tEt4a8d7rZYrZlxnhO8ofv3R9K3E5eDTm8UJ1Oq/bnU4XlFYZXOFu7qyhiNLUuGgXQ9WxA3abJfkGyB0ChhcWvs0VPMJHU1KuscjCrV1n1slIHI9TZKCBKw88gd6I6rPy8JUryGblOlgGGCa6zcpimceS+usHsxMb6gHPOYMRnjF2V/qMx2Szf0DEa0krFMu7Z1+orUNBf5WBmKd8shW6/rNnuRbZqnjlXxGdG0+b55ebYUk6VGcSQ1dZFeNBTDfgIV2RxEAC3ULgx2NXPxBPwFgoh61QDSXpF1ojtQmP5CGJp6uFK11YuA46otikqz+k9wbpM0O2oCzMYevSkQM9xEx5sJNt8puUVtAonnbna9xGrOTtQDZgR0mmNQaICN92sb3qGc7e0ldSmZAXcp/qdx0ShzgpNVV3Pc+EtSOSNWw8yHA+hEvF/tKPf1ZHCyxRt13FapK2rkM7TtlUgC3zDiCr7lrJGlPwcVCM4wy9Xly9r/Pai6lsZPGyaRK5JDHapfxk3ErfTrJjzxe3AHVQHphU0D+ARzVkYAiYAE3Xklq46xQPAUVH31jzDM2Hpaz+DmZ98RiyYCnIiJdMMNU7v5okxk0WRPZRCyk7pYH4KETczF+tVU7SDPy90vyCbd5o2esRanHE+ZGBziknbWUnTNmi/88ROlzYebQb/dcrGmvnYb7FyvFy9zGcUAnW9utxWQEib5IZuW6Gr1unVSU2hHShOURRIuBkZuOhTBkfwrjXb5mgDbKu0HXKW6JrCh67wz72AQSnwKBikKWbBj5c3sUfmmtGqFysNp0JCIasi0/f/cN4nHvvkg1+4GPtiXzZNmZA83aUB4I4IfPg6YZGqRIFXW9x1kCmDwis61vlpUGjBH0uv8RRPbBGTw7yrEx5Ufxfsm4HTyZfcdq6+Ue7VGIIb6yraWoc3WHii6/FjJxyjA+0ApzOM7ZFQDCQ3BNfPHKArZyj9blkSfBadPhJzNsON+XlQKN2rSkOX6WxF87PwyJVibJHpwHQqBtqeg1vtVcH0KS6IgwvcjKnE0Pa+qPtvx8TqEHz+bNczh4LOpHNupXM4yb+mVwSD4lG35rvdpztlwueMIpS3DdFi3LcXVJW9EwpAXZ3mt1JGZ7o9Fk2xkvWPFzt6WFB2D3C+q9l1pzd9K00TJwJdO7Ifa9OjaBr5MhszjXfQDBSxk3bCbA4apiIQ6HpFT+mNzyIlYipc3Hk4z1K1NCUrZF6vgA729MiTdU3n6i1mpnKSTgU7PxxPA1sCegcaTsL52AoN7RG/nsPt3YXGy0qijihYvoP0LbQVy0pOy2IjDQ/i/P56Dvhzc7cbAnyqLmV3GN7i7PP814KbeK1jJ+issbgGaGjDbMhDmscFWBRTfjI3FjM7FpOOxjA/YvmW+8JOcK0VvuAvlKdX/lUuoa4XMqWru61Qd45PLSI8Li9i1YDxKAKw8zrv8p0T+argtSm+qhoQ2OlaluOtvp437Lpxrxz4K/EGG5TgsVykHIvSMzEahlDlei7oHKWyJZwymbCg9D2Y8lByN71RzJTiUMgRcggcuvhjsjI3qbHKUQ4LG+F3bR73QWkervguLbo93MDs9vJ5mGVAYJGTZ2lhQzY5Rxj/jHjPkjTaOxgwY9WAj0PhuNXUOoMFlFmnIJfUxkEGzXDetQJFzq8VXC2ulwrQMux+MprOOxCj2DONJuF4hDOEsLIFLW6KjThZ5aoLKmXtyniV8sK80YcxZaF8Czoy0KLVqz1SWsOdSrqhuttTWwyQa3LJwHfVQNOrrAGF5W2cLH1tLw0MvoX8TBF+sX9dUvLKUeXCGnkq1tYlJNDz8j3k928MYMTwdNwh22P5w9ANT6Q6FpJKnLVyPOVWAhP3pL1mPXB45HLLJcFKn/VaQxH013yVbPbv4sGLx2uOT1Tt3MOqdpf13EyVJU3XmYB3R5EWmdcJPlXMCy5incVg0AUKVy0tFjQVC2ROoQyZU5Vlc981P/yPr77qx7508WAdpxSQVEzhIUyaGnnDJQC9riCWy/ocgGJHv2bFqspfo0Y0soVcMirTFsW99VxO+rDjzVZB7ZtgrFss1V4tAhZMqDEXkUbuz+eROkccv6AtWZRhPhSW9l3wFpRv/TQPaDbv0oKsc0He0QHSb7gcVWwSbq7Lr4qmWshI8pRLtsNxQDG/S/PYZ0zhMaXuUwLqcIqpa0YLQjFlvfZEWWuqRKwVdaliUT+ql1IVql/ZG697hgMA2iKeMAskTyY8eMpGPoMstKUcm8p7raD3dCU4mFT3enorryNXMTsy2MWU2qiLqSNVkr7LCTqiAU8CfAJp+5VMBDkvcI8DFmUNUcKRmPQE3lzu9ioTxpHcep+qi8sWrBHoNjUVPBTJPfcL0Njh2VEHFtVHINMUesTkFG96a5ORKKrsnhUnFy1O8qQG5BbF6Y2i5CLHMU62DFIRIIoRlOCcsnFNIDswCnC8IyB/gkWYJT72XeMkQuBQQK08UIMiWpqoutvr4zQD9InRl1gnfN9jtN3w83ne00d5F41Flrmq6CcWQTnOqxgMR32BV8AIiZh1RZsX4aMpHqIueJ4udSAcMUITuxmIpL5Q0HaWggK7zaKDUpi0xfztgiQFKI7LQC06/rr36KLlKnrxpXTfdBBFIKt/Jnef8/KvbEbQIjNRqKn9qc4I2VYAIPEwBWwCj5vWiUuGtmellaF9/+PSa+//wH/+y4sHuGmoqNxS9J4fplfzll45ohetQ4YMqkOLQnG6GGW8YDe6ALSwjqmBOGIbbVEZ7xmlbLN2L18Xp20LIJbVBeLFmFCAIqbKQIAnFJ66gIYacNEDDwG+0iChIXoaGTmKEClFwPTMO5Y9NmCYxdtsfyfexGZUC7N3Xielho0uDPCkMotjMDGYxXFlFrfKRV2FcdBewzJkF+VDod7tXoQS/Qy3W8fdLM29SqYEK7f3gqLFogHCDx8fTffD4Q+WdWoClHCgLEItnW2g3/MQs4DEQiaZd7l3kJgqObKzSLamgZVcKsajC05mtQiYzQNK8/3IQEnWp2WZ1Vprpqdfm03q8Cj2iAjcYQNrNoDekuQJbB4bWAtsnkAbL2dW6Koswx2VDMyqSGBB0CjLu6bnswYvFMdogTS0ZWxhU8Kwxa5rRTQYWdoUAePhRc2aOWREwhvMkTKkL+3t50Z0BapdAzWasaR9ToyNgfTVGCJM4naTvtyBFzIva3jJzMshvNTsS8Ave202vFxuC8DLFWSKxsvV5nhPTU4pwGZTwp4bc49Fac0VFfYqDmFWYNJTIJKDeXNe3sQiSNOI69cBeQA1z3Dou39DXNLlW1n0WWyjbYN8O7U2CiIa5Llix4w5c14QpCymxdzcbHWetysLGVilyu5dxyqmORmvLTrxIgzFtvW1nN/7maKujzGa0pV7imZXRWTI4J4V39CxSkrjSTpGGPd9v+kZZxy5p/d7qk1IXBDinkrDgUeT87mgqr0X46qmFPSKHcrwdEsWB2jj+Bvavl7sPDyA95BC6Xub0HukFeJgMVZD+PyaYAvh0Q7ayYaPRlf9RVw4LJWlYb8TMzqmrdz3l73w0uf85ikXPWEgKuweKOUAngaLNa0yR4XtNa0tgnfwhF+gHiRLnFoXBOJTbMi51dvbtcKRXSAVc3xXm0SKsPz1a9b+Vsy8EpghdUwA+qpSAD1dsWKNOcrARRhKHRldCb49KITyUEUJsjchLp0Q15gQF8J4F1YmjUFqZPf/v/KdqDqpipPRRE3JO6OAj9wrTh+rRytyHquPhPzsb+V8OoTRQfKy39aNpL7LEfnvICaPyrhg32Pl319dnP0ukvhYCNIHu2E/BiVKiitOKQU8G0xBBXobRb2iLV1nXlXglt2JsvDlWmn7m/vMXnP+HJ41kYUFGxt293fOXjnP183v7+mnsLemTTQfY0MfCdcHtJvUqVSahIkPfziPEcMg/Y+0nq4WlD966GUHOZEgHtj+/PP8Z3AB9wBKFII4Zr9vN90tBc/p/lUAqaifXmXF6ZE12L7Lf05RjeG6XXMTe7tqf/YHB63zJnAPnCMpNfsq6gWJaPzyD5uwfP1roTnwNYxj/wu46dxnd7cAWv9o67LC66lSgZ6y46v+DfigjM2kBWA7OesGatLDd/tBxgsFylZVZU3r//Grq0WEK1wVA9CVIBAqvwhdEQCgJPbvfJkrItEU1XjAsFqNh3+sh02xihu+2JmqqxuA1ClUKzUBhdnHdDTUcH8ClV9oBED+kjfN/TUxew3fopi5bZm50MOCAldo7sHo503SARFZGjVhWSh7JarkFH7vSQpPNah4wRSUXhtsYb1UxwrYyNmFt8uvyA+zjnVrwIwz7mcPN9RYpTog/HYUYpvJlesFSHFKqKc92jCI7iD2KlgXKFWOvdXf/hNF8uMEMzfa4ozarsV5YnQ3dZBxZpn0pDBYjyEU0t/+wudbA+GZmhiYUlcb09TcyGfKIzucndo1UtdTLDL2mc/KxTY+Mab2ilhSnZuUiZqANBSz2MInP+Azopfzq0QwoU/kGrx1iYlGYwAu1bPEnabsAtnv88oKPmyfHCnKWAnNCks6xwvJLOeeFzhTQjPZz8MiM/qHBsD6aBd6Zg+2a0zmwyiu2yfK5xz8PVKTRjNttac69slJbKqUG64CS9NSANUIEaiN6GmaRSEJGm09h0yBZ5mihmbUPeXYyENAKxnUaEIo6Lxa2jnu13iP+CmmjfmMsROGB+O6uizt8gOWOPghLqzrcgaKWZHA2mZEyQb0MClYXdkYGHuKlzNBnlkvZipWsSuWF8v4Q3vJBfm2hF8kKO+SHvGTr3P1+F1w+uN6XR30Ea2Kx1vVJJP1DzWrM1Z3daBK/moI6o+sq0G1XoE49THqZceUkou+JH66axSVsuM1XXL2id7txudx3oY+wxTSxoh78//ieeNGhXBrSmVmoZxU9Q/+DUMcb3oZSi23ia2T7I+tvhh0H/5k1Jro+8LQE53scMK9BY8CcxHoo7x6RtmfSp9i1ZnqYv0BBxYKLUaNCHWt9/EHuDt6S0A9aWWfkAVEPUXGlxZJD2IGgqhBXPlqdboEv1Wq+6R+oMyNftUTayFqT7KNL+LsU8hlnaTEeIRq/zreqIq7QcP27Y5+6p5zvnnmmVdW+fky15BBzzwYMtMeUAOa1S4z2LV1qGfzVSDHf1NaUWY8XLRcC6i5rt4Fi+at2c8jgFvp/LlhW756Me6BuRbAECQUsZ1w49muzdyXdTVe2qLmkYGWN3BtS9lqfKAKJrHYtSjF1gPygDpUF7jper5mbNtgMHHV49MCUU8h6u5TKBbp32W9FXh5LQ2RHA3LexWiZ+9pX819zRB4cPB/M4qaQwkuFKEBov/ORK+Rd2RQ8SVwQHhGyKqMV487QvNCEMfZlwwiOfuCvdOBUMUHsFIMkRTag1ZIt0PYGIu09sJYRIPGpXflBDcGkRYDvchL89Aqt4VIktJyuB7l+nK/nwzXIZ4TTdniTl4v9HPAH64D9pgC1IGWcDlyKIeSpKUCrGe2PfMNZ9V25fiQYe6GRUxCpbd4YXCdo0/LunNEsGXdT6OEEovE+g2uBpFvvUuppcAi5nDM+217a5u0Zly/6X8DhqSu2cjDVBzc9b3nb+hGMcQhsY/7xhtQ3bRkbB8bQE3fPd1s8FalYQ6PfKY3jRd7L6m4JvVL9OFCwA3CMD44XVKbJoyF2V3ATJVGkZK5c/kB2TD09kDwdq9kf4ZMuvaEeIgVBLiZxFK2S9WyPFXLqjHPBn9+iapHNFazPxfcb5rr/MNaq6kLtlywDVrTYEDgdEX2+PwIIYyowzbmNPpxEG74UYcoZeshifHHvi+fU5uy83oOvlApeWJ9aWUPp1bwIUQyVvTURJHc+eUtGmRmoNKo1Opt5ouVbmxxwSXrGbiHD5flw579cImWWOUvhZ7C2uF8ETchdRvYQDp/LOCGBaTV3CPcl8vBNA5Vz7WhAC5oK3kb/EltI98mcF4ekq4sAp6ubm4vbcVX2/nBwhyiWa5iLodmZ6QspB5ab9HZvDTgSmrmdsS2wdp798iN/qkVqZu2cBlHNA68tWetA0QQMUbGTerWNeji0fa1HNaSaS1vwYUGThd0z29ueVuz6TG0dXvWnZ+O7bxdOr6RbykRJKI65IRdxZOp8ZzqXEJK6k2yYF/kIu5BjbtUMWWe4PSwmBbZCVRU5XrahC935DlO0cXx3U7+OwUMNwnjxuK43DPjwD1cRkc5ZkIhp+Q7UYToZdSKQI0mKCgfbPBt/M97D97jcdEBTQGoOynQ9EriTmtad1aZyB3w2ZefJtNtjroM1qdP7Plp4q3wNKptUulpdCrVxmrjOG2KqTTQSn1u2ikPfs4rdvFXpyFQ8A9LdK/gpF1U8Kf8crnm45diJ/IhcIrm22uT8LJbrxBPaPROoUjkiX8++Za/+aJHOf/kubFEIEuBM3vak5fqCNvB3ZNnOsbTEGvTTjh+hKIbzekohrmH0eGEU/jvVDuioYzohNadyvmQP0TrAb5NR/RUO6KnTBjRU4ZHlKs+jf92yIiGxxlRHnX4n9x0RHdgtMdqO22TEYXbShlR/moHAqdXR/R0N6LIh4FEPgROdSOKJDeigCMwHU1f+83qX3Hq0LieRjnK+CLPmMe/bc9l1b9iB5rNBbz0+6t/xS7Uc7/HQN8p+GdLIOQnk4pfwHcETwrC3J3DkFfgUhjBuuKPtZXhUw4vE/ws+JmRr0t265qi9vwzmPicoYZj5OX9yrPRGe+HrgoOqBZZrWuLuTRu3HPMwCnEjN0iYtXMPTyyvHQq04SmU0jz3N5sTTYZODckWat8Rt8RaZNfcfiMapN+s1QcvJ93Ru2BrAUba/t+tP6R618Xs8sjarlLW7jOvLGOFcoJ+gYDSksFC/KGko8ieW2t3FqurR0p3DJIGlT+Pf2C74UTLg7rHaHD0AUzoteKO2OZcbZv3tm1CEwILHVgsQpZpsAZrF7FcLqkAqwPoQIIWDswOLGGzDonIqplR/RVbYBEKqxRg05qKTJh37CkHFGI4whj0SrUT3wVQbGki+RWt2RDXKi8Yej85as7Yw/fZeLbPhPDlXeheeQLgynZwS0am9NiXIX7W70dnL4i4n2oKrNVthR+adPXWfQtgqobiHVwmodxaz1w9kbysER/bwXQlG0H4CxSW7wNjjgHXhES/tImlKXrlkDJjN2N+OS73Yi+6G5EX3Q3Ii9uN+LLNiJWnym2YbJTEE+vsTYPd2bxSHB1wVXtpn2sxVAduxHPKkB60iqzG/FlN8KbhaE6lJk3ZcsBscg1iQPhSB2+7Eb0bo0CUXYjvrRUYIjdiH5jdyMxdiNIrJzCY/+//8wAQGVIK105UoQO5C7IJMaMlq8V2YbKjalqmW6QXJkKLgpRSjo8VvrpoZcDq8Py5aqe2XxjXNwOSjaQhweD9NMeT/lhO11U00N0P/s7PZfszxnz5KHG4NKawkoija9oVBHgESGtf12pMxKhVK0SU3sFF0a8Feem3DqN9ioZ+A/MaqA6F85NTGglccTxegbLQ66SOBH/FLxQARoncCj+tleNmy86/hdvn/DFi/UWoL2PqDtO3+2hHr+3k5YTWdu77+++ePSCHb9/4d59v7Hxuvi+hT02cP5eu8cIn9LDOdNTemvilyEs/TKUU/6CvWvpf/Kxrxyzjms9jyrW6qCijOwdSiFh+8hX49i/L2Z1goo1WRzJrKXv9oJADq02O2cLdNxzf0wvCsG4crZWt+dm9ZFzMz1bm5hHD5fzSH004LzT2CWhQDfr2WewZx05afvPfLcVeIn56yso29rdijdCuYDl4ytsnQ9+3syu7Es3SoFOmy4BHh0wRa943iTTy2LOhB9QN7UmlyFRkm26kESVEiKkUsI+ag0hHmRO4bOy8UY5VLEYUQ/qoshMtaowL/Btn4RwnkisF1TFetGQWC+CpGVIrBdiTcGoHCmcSjrVh8R6iWsLxVasF1uxXh2KLMNiveEli+pVf0XPRroT7IXrkKIkFE8Q69VZrBcBVyLZbwv+PEtZAzXsg9t61aLyRt8TbW2v8MYB+G0AHORATJQd4JIhwKUVONQt4OoWcAnuIhwXcMlAynaAa1AAcKVUnwCuxIELYCIIuppQXmqShZaPuzKc4KXGhnfRxJHOCBChyshEGHYwm/9ewQibCgLIwu+BtPM7BwAwe00TOCi8wIkoxFseQQrxzgDnF5vzjXlQZQU9J262bGGVKYRXsbVHkukDKxZNYvpCw+iokxF1+DSJ6Qu1GIqU6dMLvZOYvmCU6ROrvabsK4sQTB9q4UAwkelT9jMPJjB9wTjTF+ZVBss6FhnnsoIhLis4EWbc/ghixo2BF4zbabWmdbO/Ojhhd+W2pm77FrntWzS+fXPpkoqJ8JCqANPXUd2Pe5Bd4cz9zj6nr+A1ImOvVFkmtZoPd4MrcgNgP353i9VHiTgLP3tW9vevvWbFkKhIy6nJrXrs68A3UiQNQlyk+7oI7ROI1ybs63xu9V+o/yyhYpIdlIGbN7yvq5iJ/aTnh8dRUXLCcSxoRj0mj8Y1l+Kq1LvugslxNZfEx11iuKvjazeJS506NJfAXFnJ9oBidb42wl49jfHYOCszrsvUKYoq/rzpVcP+ySChlUTfeXKp+ihryWfQsIFSF3YgehBEPuDzWsCnBFTB9pMabNBVbcb6aKf6saIQeOMLSYMGit7MmnSgJt/WlHygu1oGqnwI5XTS7H+N+GL53/q+tWa1gRiL/wJxVcWZZe3rp4AdTE/u+SQ6B86cYwUQSBRAfMVnI9eCAnq6EOAn5OMaIIjsrAInUhEUpmBFonXN59dpUTXhP51JuEpY4ZcicAAc0l1ZHlTqkplQl7pCKVrOGuqmrhD5ItSl/EWISTm5LgpAeMF0xBSYKpXpCPTbCExHIEwHJreyGUNtCfETS1vqqFpRI9a26MXycEWiU7SD6iDzk1rDq0AhYCEOoNbxlXvRA6+ta0jlhDg96ImtHHtGFBpJk1rwVrES+TIo2efxlYyI5BVx0F8rFujHyKwH/qG8ii8g2HvmB8RRMi06qbwUpcxIZ1kqfpr6n6mpQwxGh/f8A6MeioN6G0riiW6b8gWrGkChM8id7jVzF3Mxu1f66JEUwY+KZEv3/niExsWHNC1JX4K9lTO8Y4x+a2vV2M3+io84fz8nI6vQjr7XSXW/qNaDn0I13cXJcoaIazAuuF+ObZfZmxb6MbAmfY6MBHlisBwPqRhhlTcU6t5cuywt4HiEA45CPag3EZoOTtGTbAKZ4V6m3wtIZxbQ5Fd8NmlNKEBC6nHHunwJJKpvqFuYfi2NY1aVU9tx5fK/5g0JVLObDpbVtHhK+iSNX9YD5kK0cmQYVllNxyEif6k+2sU0cT8Tg+9gXixYxUtFnU+yEZMBkEZRFxYVE1hUzH0Iy409zp2KRssUqrJSONlRPa+xIeF5kX72VArwuNxIgqxjEGhBqgt1VSVWlTzjj1FanhtwXS4Xp7kEaCDpGbq6D8ElDR+P5Vxot4c8IfKYIv8ecJMMhQ/tuvP8XTKvnJJq3kQEqpJGXksBuviCMRF66nRj1Uak+p2TNhSxsg4ww5EECnzy7YFzXRRF0I8X5egqqBLoJ3vB+REKMLeewQ/u3g/iDT0IcB5vwUJJ38/uU6c+mAWFr/ddpUD8vEAuBSdgLM5igMpyfi++y/4Ji0rRVh+ObanUCbt9ndVK3WzJaphRKzbNaGdfRuUw2zBcpZgwXc2+rqYzZaCV2M3JKoB7XBHu6roryQNK2X6pO4mADqcDa96B4eHU8o86LEKrnprX1Kr0IY8CNzK+jAxG+3lFHQZSLwhu5gxcMf8c8layr6johzjhoKclHPA0TdXrs69qjjO55LxFAYe4CFcDmmArqZO/ur9gTehsoJdPi+YAyssBbiTfysHdRs1mD9xMKz1Be2FbfReEbBLaDUXSQEF7nn+zpKst4Zs8MTnaRdMS24OvoX1j7Sn8jfW8OW78C228uidOAznDtKq3VLfPTUVdaq4fcXDX2+ZTect6t8A1jMxgOadiYk1Ta/DePehPZFr2Dwo5GR7jN/WpOh3mLlUtUJ12sc6QGSHBMJmmy3QXOKgNVIwUK/fqFhHTRu9uuWOqGo+BLpgrqpfuY8B1IAQv6tIuZ8m1hfZPTPOludKIomZO6oD9sb3zE4hWsIyefvePpq9JJe6fTFxbJyyIjXorNYProt+g0UzTS3l6Oo+JVy7OtezPEZ9umxSL5Vzt6u3G9nBchIsdEpRNs789OOIt9Y3gSyZ4jicPA6HO2uxlCl0z9hRYpHTFu4gCd0ipyWdVkndXk6XM5RXrTVRBgUjZlqJxCgXfNY7LqfTtg2Bnxw4TnRMXSJ/y0LgUaAE7lDs0RPbsmnK66P61K9jr64cBhXgPrek6pBb1XGQ17jv1kRmK/lrfVx+sejChOw0Im3GvMlI3gfZ5ac+4sfOH3dh5bc+5sbOlpEoRWrpKKTXwE/EpjmuhmFfZN3Wnjq0Sg0792sEOmOlDDVhqfbIMGw/+ZDjk/C6y4NMtALcdAXV3ECszVgcJ/z6TUIdTjIQjisZTESUrW6IuU+B5y/oWypvqh8t4FWpSbF0Bp2DHEKN3e+VT3e3HwLMGGuHjNI9CKMKnK/t1881R6f7CGMiO1YtRbIsfKZsfmlMLTrlgy1XFsObuWV96icAPXcA7IFivVKydwKiiak57unYykMZonVadEVUjy6WVzhh7Nbi7jTqbWmdoPEB4UnGMSPTF6OemumAy7lmXlIKCaEAMjGuiNKqXjijj0hGlR/ptxUNpXYfR9Eck2LHz6qF8sW0/bjKn3HiUL9txgCJ7GbbgOCY1/iTVy5olKM6R5OEoECMW4zNTdxzZcX0I+ui5Ho+LsWPl/xSbQLDU/lXgXNeom1tfp2qgH/p8z+HCWohX8t2liQYoZOC8r4In1NkVU0McBpvuBtn96IsORCZbEvFF7KstagYcVDmzrztpVItTWqsM2UIaEGs/+KsuPBg31c9wKLat2QNI6SvGx6g0kIorflN6X4GXc+1vTFpARyrtv/2Tb/skO7ZBtxompYVtcAPNR4P6b0MOavX5cQajQUfp6j+jmcqpcHXVenTDAnCA39M2J8Cu5zxXVBga1lVJA8cnpc9JMaFBAs22lFnECKMzYnQ4MN4oW5QoxBsCZbwl+oAviX8xWNQmfK27bsBPwTQRjDqjcKarOhjipz17QPHOSrhUax3QgwjwQSRW6Z44/XQWt6/Lfd37iMD1liIsE34MCwM7u3nSN+2/2g02/E/frP1wySPdf50qZeAoUFnpim958V/3wZMpg1ubixfiyH1e4cM4PZJ6UMFwgdZe2Ddr/792bfhzCsvvcMIsEIgslxZy1E+ZqFs0yhf5qdqpgQ2z9BW+519r4ePfMhk6kxtSs+8PfFMOjLXEjgJK/SoNNTXYHEybF4ZSjgeNobHA+q4HCvgUZZj+BwYkpuMGUIGBCuDw3npiDVmy9JX/Sk3ru2tOFC7GGp/hTLgdOMrvl4u+P3m4wuIu4vnk21cKzfnHboT5dgt+dq9dYN+7+NnD73vK63rYasFWmxaB9EvyCI+91nbuJcOG5PZO2nijSitEt16MwDjFFcWfRl8teqQgWnKNJ4W3StaDaKufLRSN/mnTKn3UFpbdRMfU5DzlU9KtvIPHrjyrFuCPFuCKlNzypcJCypJyDawy6hy5AD2HKXUO7TUuH4W8qQcGpV56pSWlUGvQmtvM2PUMehCJay2sELzs4m4MtdSfJDV1VZqu6CNQk4l/PuNicImuxcVJmd8rBUwTf52A1E/DRF8LYKNI144ZyFVQgVgz7AANIQ2hzqDoiJiYOmJbyqoPKGwEagY2sdxG1K/zTIEcW2zKGBREU1ychfiURSzAaxe1sOS0jBUcxQMd5pXSrU2g6vVC7ecQbgnZLLO1CivKbYHzRRRzst+j9sJAfVDve/P5lGZxnsJFhNQSJiVQn/aicEt1+Z2HNnmK1qSKnG4oTI12LJ6CxrmxMgsEz0m7Y7jxEXZrzVqde1RRpOrU+hsncGq9uV30V5zILvrZnjf8aU0/NYdKHnLXbO5/NS/eN7zq+B1+fXDynvvBWo157kdc6Dz38/zq86Dj0LR1Nb+tnMCP/6eYFfKMH3/wSM6P/yeRQqHySs6P/42vcn78N6vzIXn177/guVzAyiPv2//lr5rk2x91KTKNuPd/JeIepvPu179q1Hl3d9U578bLiPPuvZOcdxf82dWM0SsPw4P36ZXtvEwY63/xv/Go9p/4430vOySdTm/yvcbJuXIvsF93rtzDiit358jdG3XkDhHNA7q/ErvHkGMcRhVQmMQ5ZmxJA7nKIq5svylXuOlQN54RhYabxhGpikC4fJRT1QFWxtkDViT6CPGQtOxjr3Q+24Mxn+0fR2otfXXMDhO9l7oL9ZVdvk71/ktXpnw4wS6ve8rWSutHM1q+MFkqRNGZOyQGIUO+AnfKbcvQcxAtoxpnM9V4//kketX5eJG7Q4a9lfnEcgY87XVV2SMgk3GKo9I3ddAsrTqvWoptL0TrZqGKUVZjpOWN8iv1zK4RSt1Til0laD9KcLVAQsgUJjWicY/gc4p/bFu1iRwZXGqMwQfwxdwEHjiAonfUVFP3RQpJUzImnuJP0As0R7rLwtcghaF99WYVi79NfNoSc3MJ79+HytDWt1Y4C0T+EcgOi/hhGySitlopkB2d7OiNRKlVgrAOuDQZjdFuFYGMNTFV+HmATCL9YUgIWK1UzacYDY7NzW6FTiMHoIKhstAzbmit2lDShiaGBsRQ27ENRY8gAW9RSkl2QBamSG5RIGF3KaFIj0GyuYlP4c5mLoWto1zdc8qHegFyxJlwOOJMOHKOivlTLTjAGPnytboQFurgG7KACEsWdJI778HXv2qi9+AjoHnWP20AmVAo9BEh8SPv/NPGZh5EhImlFqHrzh1sDMPtiWpV8Ytn2tkAgcJb02B1UydIXQGiUkX9WIgageCJD9rQ+qCFpHM/EBR1qmaF6TBQ1fmgTYcqrU+oNDGVrlQc36LS/YV0Cggz4mc2WEnfCoZIr64GZquDUQtLg/W+hTmS8tCOvqepyAzyjDfhmQxV9/erNgmKARvvVxb2CKhTXdjldrYS1MiYEZAibU0+0gLIJeont4LB/3DoVjCvsoJ5lTUsGF3DgIL3GRlhqMKhg7LER6ghoNg5GheGD62MUK+rPOaCte+B9j02AlRd40QqreIfDSU4g9VvobqmcIiwALRQCfLJI8RD0rJXvcotbPWxhe3V3wI/89oxfqZV5WdaY/zM7pKfCbPX4eMT8S8/POnwpMLyqm471nrYhysPOn4KZVNgxfRav+Pjhvmih93914x1P3yB6z5eRrr/+EnsHB/w738YnFwhYFB85QUxO/AyiZZGqEaEZlHevZpFhkmzHB++yUnDVxHPwfch7rK0oSqQHW5o1zb03bGbzFSyXfBBwnNTDpUul8tG/SuwYIp78obeLLD/lZ7Gm1NxHIulGiyJHq/uOms87qNOHPWQrjOrphfGVAOsK6GQQ3OwbLVCkS7xP83w4B5GSLZOvy3VUgTQkwFQLPX3rSHEtSJFqWxF6iU/e4PuSMIynrtcJv4MElvBcBqzomWGm5BBmcxmf1FPlyxboXvkn3VF4PXn3AdxHyNqGAw8JMPPa3v8lNQNDGOsso2o4XqgFolUumy6tiwAFJuUVKMJ0Zkc57joJtQC3OswDIMShoGBYWBhqCHEKa9ZqzQhNb0umqpGWo5yrRzlGrcPYzxpcHXcx8e4rRb48hjEwMDvZiQIvwZ80rhbEAdzfftz0YbVSzaRMGUK4Zhz3YpceioAoDD62kjhIXIPtgMCBjyeOB/DMOm3YCF1qybf5kqdpAlOavBsXqv7nm7AuQ32KEhDEY+bMjBitK2Typp8dk3yaAh5UHCAXGpGSu2t+fq8FEx9kP5e6NdZfcpazKvKb1UbyCrjiSE45TpiqNqEAnmsaE9FGPF8mHEJwvBLJ8doDT3oaZpz1L+oiGs/WnOjElJDS29qwb7WG2nRsZbqcalwvbFZOXJyCNzLhVEsV2+fUjxRnlaC1rvOmfZXmt73jl9JzVRSq0iEPFSiqHzSndkUJEAgV8t4V9BA1HSchpx8K47f29rxQJqqIT+DLo30Pt/3gUrOa2E0pBUfOiIRyKTdIyFM2nMRgkpEJIiDdfksCSu27UKY1edESf5i8R6Fn52undq6vI7J5eR0VMcTE0Ari7UmX2vyuEQ8UGGgFerWBhVuVo+n9QzDo6wn0HpCrcfTempaD6aL1oLJcrw6alrHyMDWFeaR87yYfjZwENfDl7gKcdBYXXOMm0EMO0Kofh/FaKd4IzAT/CIJhzKp9yDM3RD69ke1FVwQlt9zXUMF1HojKLQNxVzCE3scra6udQValw/QxHaUUaWOcoQqN6/J15qGh7esKdSaIq3J15o8rUmHV2vS4T1+TZ7WNDzAZU2BAaHW5GlNNa0JA6z1YICPX0tNaxkZ4kSHOK7I7D9R2QjtHtfrUbXTUMMYx1ymlC5ydeIq1NyTPe9P9KBbQnNYSyWUAB0lhHbvREjtmwacSRSyqDrq1CjX+Dq2P1avPxFTg7Y/oG+y3U5avqiOax2xVABAEuqRtX1ZQljbuxK6WtbxkJ85zG09akVagNaUi0YqVYrVyZQSNc+l0Ksjsk4Nhm5DgWMVfpydvV/3vehkoVpDMyIFbqzArRughkaJogRqrQRqrQRqrQRq7bhADUugRiop4nRpSAXhYy2y7mBYVrVcVtXVqua05bXNAYgoBzjhlHBwCpstmwHuFwM/MhRHQReOgK7Cq0d9X5W+Xoo75qIfJAwgxdkb0QbrDOA6rcXLYxVIKdBFooEOYS7iY123CA+FLUIK29IBo+hT6DqOlsjlJz1PdZCOZeo1ME0tZMF9mmcAY47avlQ5u5h86x5He6Q7FB8tKrldUjmmFpDdhs+Luih/2QNt5Q7qQ1QlPD2g821ol3LKdeEmMcgKxuwXtC2+VIomfF9eF4NSMPikMidIw0In3vPTd0eT8JuCsr0IB4YGdyUcPh80eE7RKuOHbq6Abrq52ikhTE3trKKVbhbIMXOqsiNEIS7gDBBCYxxWBmTqGq4GY4reGszuX4uqdBLHE+t4svQZJashxppOx8ml12VqaslzphMKYVS7afEi2YUoqVryyYGn8DYrebzguhmNDJFmr1R3+03oO3cRJ6GM4x7pjj7C3UPjjfIyMBnZlYS6VS4lz9GcCmWhenr9ENJW9yEl0oa6woWMrbrCYRKCN8Li0xXaF5qVbU5CGYcyZXyFXpS4Vee3UMgJuqJKBNWuSKHqYxkfcC+kKl/A0pXQC0wtPvrpj9dznAqerKcg4lkVuoyPaMkAv68lF3V+lwXVXF0BUCzSIYcinYZqhhQp0mnIIF1Im4G3SB5S8xTnHtHeovFAOtPNtFxE8HBoB1m29s9iH1AUmpGOcqZfC4OAlzdneLTmDI96YHXGRVJTcRSpQKqcNUk5a0I7ayLlFOAAGQ/d/khItz9Bf6fyBLvLnunioqeQUUUYHePZCjcRPAXHETz5JxI8eUMZiqgsVvIW9QqbqUe0OCZRrSilZ9rLunQvkVBooBBpz6Oy5xGSsL+Y1HcppZz1jSqTafZLtFLlM/tX6GFgpKymr1UkAlkKbNXA4LMkNAfaJqEMtK1kNbEhQzvQphFWk2P1NrKjXqpQ1U9knZeheIpqLYLvzBtUxwotnBTIjXJTQKNUNP/dZYZfCb1knPCBn1B+w1cOCnZS8RrIfU++twb9X+sJxP9+EaSgIZBdq3tqZe2VMdKRkCyxzUImi042y/3HYFrAo4aVmdbD0acrP9by47L8uFJ+oFkmcGlY7MfL1rOTYSLfUCLf1IHXIsva08p0qF/C5LMuei0AidrDgdUZBclJ9Nc1ObF0TRlqhCxDHVv6Q/iZK6ESp5UqAq0iKKsIyioaWmBTiV6IiuqwtZTXJxasTE7qiFVaJVN/4TmEoZJCKZ74z4XFK70X6BAFNESaCIyXZc1hDnCqrnfu7SzplrNkTudRJhG7cEIioZ06wWUiYm8ZCtYE/e0lWxCanhRNeIqC0jQHEsylpBy9RG6I6yFp4KwrJOmb/UmsgA4tmqtDZmaFBX2tBH2CUImQlpUJS1YmdKzMGDYC9OM8R6zoWFd1ewoK14kIQsGQ1MirNugEuBArLtQruJDk3kQ8UKdlk9FALiuXB0mQ8VpNF6qpVQDfKeZ47hhfhUMAEy5eB5WL12q7Q6/72rP53A+QrlJjvd+KzmC9zgaqsKcfI4eW7ssrKuQzYbl3UL14jRdcHxu+eH0xrgN/yV685otf9hZXgAyhWFiQNmVv1vP/yvH/2LXr9Vc95GvX/+ddfD4c+rB3Pa7g6Ea577+Qx1OvwlwjPeZXsbiZ/TGuiGZ/gl8ooPCE1pPdT0sMcu4eioHU8qKhGE/H7hmbHL1eIj7f9AN1qqhSv2pMXV6gS6R3HrJ3OH+gYZEYvQRUVVdliEiRMsRDvwPnAbpatRC45u5mFqm4S6X0MJ4eNTSfSZU4TG9O4AcqMBsMPELrSRCjal1zKC40RIWgrudy/U/UVgQ+d/KztA3prl42cPVyg5tib1vKEbO9TEmp6ttrO220WkW1lXkvsGZo64JqpfumuLwwqDFVEzV6R/LY2B3JSbGYeXqeO6Un5NntehL3Sc/zJ92Z1F6LAgdya+0eYDAaq6N5keoG1VQ467uLj5q8u5J87njyzkryrmqyVNmd1I6Wi7xfI6vXXlCY6/Ovn5HOwMqTcP7hiwP+a10XvNh2vAiENTzAF+D3XlMutqre0jdOISwuF4nxvoPUJqJaSOR+9Gtn1+595w0Ha6KE1hdHVHfL+8T5Ex7TNBj/kc/UqEDeUhRt6/3rfvJ8GPrGfd9agBVdvuI5pjYaOaIFRqxrjBLEbD4eLUbWIqPW8/NpkgbPwACMfAvPLqLXvpHPax15DBv+fevXrY10nGdMPx/35yIx6XcUJv2QcBFJxIDm4VeUP4wIHRY/hTXxL7qgzhTnmDapd9VZysQszyw46/CAl3dpBh3awg/u8BLNQXrY4wKWA6N0h3vRER7dova9E60/b8230VYYdc9JxG6gMB0s44lQYvhwXeYHeKOcIlUTyyOk/mBe4HFJvmNCscRFEhdN+VYBxpJ45aFClSUWKF+lmasBlukV42kH1tBJ38Diatwp0o0FVbzcTjvhvYfbSqcgsBUNJo0k2qaR21KjmcmVbkE/KhblA5iuZ6c8xU7aznmJOAwr05yAmC8j5j7EkGbll8ImaNZMsurHmrVGAXzNcQQ/qceT6QEEewy16368iPn9frzPEYJf46CIY2rqGBa+dVX5U1w/RtSlWExZ7+RetW648/eeu/u/3nOxfTJALKT3fI99oo2nlNG/ZZ/SdETvxX3+D9sniuCmSsoVS898z7EP2qdL+fGrg3NevWX9/fapKQXpP37jgr/COfU/fHHtJ//oP1/4Z597gn1KQ79425mv/vzn/vOH7BPgQvxLvvGuH/6rrb/7RPu08Z985ke2rHlnfNg+bfwv3Z9NT09ff7F92vhLfwj/fvvD9qnx2lL0T5euD9sn0sa8TUmPabQ7n9hz8ENf+OfbP2if8ulH3/WeD77p7/In2qdtxjt/4LYDT3/pGz5knzb+0PwfcDf++Yn2aeP/v//wkYXVj/zHD9unjX+qdOMXL7ZP153tMH3umYnllfP2we+fZOj+wU95xbYHf6A4dUIim+YHKnNpvomyT87+/YRvH/wBVArJE3CRpzChMKLTiORT2vrgH3o0mttoZ8RGebmfCRVdxsq8bB3pdpCjQ1nf54z8iLFQO2IaqyQO/PAuPLLidLHSg3mcn4GJnkA790xdL87Ch5+RD89W2ovSexTg0eavpvAl9+Ls/AyKOc8urC3nqA640RI6C3T1UdiSTLHhrXw3nU1T9KhV7MaZxnbwypOymOW4lTzj17h/IOBgi6fvo7ngx9AZ+WPpTLhONytFGw6oF/mnUO9hIA49xIGZLGP0qEStARuXpuJGoJMXlOU7qMX0/DFMzB8LKt5/aZ5TIc4iItqSL9BSPk3LUhtkbupGbSdNl+FTaKEME0VlmAkLTSPE6FST51bg1jaK5OVUWpDnaYg81/oh0/NYdmKA2MdRlwiB88pkmmUb9GWeLxv3DAiAFHOhWKcyLpTnF1NtJACluhwYR098IeV35bNDHrcQE0DrmuHaUQ5XgGiUINGuCY+j81CBfk3yMW2jcxG3TeLWuEXVEjlVMnXp1IklwrGEdgpf7+Y+STcIcSRxd3B1QyUSIRN/2HUlOs8mcmi4gMcCTeMxbedNDgFDrnOCCuElCtohzx20RZ5baEmeS7Qsz2XrZ2DKzC+alfmFR0YtPFr0GDweQ4+l3SuMq4t9fizSo/Hdo+lR36uidSOkPaf/Er7S4dX8tJwZ/r/XmfHdmfHdmRGkmAjB8/Lz8bgUywSwnEs4g0MJbt7kLYQxFToo62yu6fxVFMczQkKPZvTdwxPiUTwhdj/8CUGjE+JRec6ToeCJsIMnxBZ6NPd9t5kUM5Tn8YSJMQs2fJOJEVUmxqwy34wtkZkU05VJYQd01qABkeKzidcpZpEbmC0I/banPuPen3zvFy+2z2I7uMit/L2yKSJjsM/iXE4U7JKSFQ+BrhrbHZ8fRIKOhFLLKUZ2riC2bB4YGZ0riHZ4qL3Z6pCaCtKaT5ESdZoMIzW88NA4UiviHhe3Z/GYhccoTCjF7VxwN3+YOP4o7NkeRS3KgJWPxdtjGccz4OWj8fZo2o233YzqBFTfg8/30PmyCADVIY99DPgiIHeeVTB7STD7MatcK2Nfi/F5jvF5kfF5S7DXoCVtYaRNcpJnTZzs76A57uMS9o/crcW8AHqi8wycGYZMzmAp8gWwmhW0jKv0mmKDgpGioMMyR30rA0glKdWhs6S3OmYcjVRsG092zDBK02aUZgX6GDo8Z8ZHDWDdYUdlDpCfoyXKZOTwxvww3hZ5XDMMawsfMDnSD86ks+ic5xX8gy33S1fU5+6ZdA5NreZT2Dcy5GPaBTabnSnhIzqjZKKfkhvZRQHXd+qtF6GQQy0JwTzLY/gZvQCue3l8GUuaWO17CEP0gAPM1qopsFjM56rOfeFLqofRPoN2cG85CQ7KZji5oFnZwarYACUyIcOO1g4r1YRHKHKO2Mtjiwh8UJN30pHO5fwIMTLmeG7VVapm1uJcnrKQnqs78qspwLDrRknJET5SL1MBde0SjeUX9ESTcAYLmiJb+N22CLvD59xuc981WITZvunyDCohTq4CrI36Mcl4zagQCSfYAo6w5hgIwTQXRQuKhIQ91AG9P2oRTb3bU88qWKUYhkUMQ1skax0eiozztfKcl4SC59sOXh62qKhBfOzSEtfPq94EY3613oNz3MEdyLIsECaR7FAsa5Gu78tosS4NIv2hWCxHzPOnlvCyXIbaxJVyibakbfKtjOWpNH8r5z7N5Ab07f4xohkQ4C6hKkxku5WHLzDlV/CZgrr6WW5Woc1GxuUskPNcEIgycpamZTLjwXMZj5wKPIbo73WYqNbMlZosrul8XerLzJ7Dg2kxE4k85ocPn+GxXGg0B1CDJGmz4DS6zn+xJwLTwB5H3NfdPyQpLXCuZST35LMMSU7KYjWTmteNiV91M6lGSfS+bUOlqk0IKfV2sQgA1YZADZkpAU2AUVC1fQCJZ025bYtQUneLGhC2rzKVgPg0xcwPyYdwcgoPMFP+hjg4nKZUpv8M2siAAXAu63HoqNJktls3i7JpGh66izn1yrg7n8djZ95QxSTIwTJY8QghJaWGHFLzKEA8aFBugRYme/PWaao6hZOcjqsby3kyi8rCpBzkyyRZpAVGDH7UxOM4v0oELwE16Z6KEOFvn7iVi6gXrzX3ioZD+WPWun7ronMTJDELhlbgebl57jXP3Xou3KVMDW6JFVtALoAnckBi3Nc44yfixzyUg5zLgtyTCyHtfB4NkjY3AO3llWIr6A/3cT6v6WioWkcdxELIFXH/jTjWQFu0PHKrgOk86AIyXGJNSlwk/lJyb6UFGWEkSoE9gHlJJydczSk9kLzzmEnzajCtoXAEA99lhFjZKLbdmm9HR2wjGzT149wNKbXqsJX6nuuNaQVRIHbDGameD4s4Ock4y8EEB6Apil6oSTY3XaiL3wLC5200RY1rekQDqlmbOtpQ9ckH4S0vwWjsSt4lVblq9w/IIcSMkBGmNCArBc+bSy06de0h9e/zoB3HRP+4Lf6oaos/dsG62uI/vp39zW3xO29I5MlF4FgdHZWuf5K9AxPqskvhtSIat8v/WfTFu3bCpUuc7tw/fLrjf8md4GiSWPT/mh7m1HDSEGjvQ/U5nPTxhT1dDy6DbQ093Hunmrsnr1zlwB1J7uyX9SouBu9Or4icJxc5McNlEfR3gJtwtw5GPquaR9HK079NggzmtK+rXOMJq708+MvDvXzA9VKTpJc3IpjqF7cPfxGsyfvkU69DSJPS9LPU3DInDyZY0IpyjEpH9rv2rj0QwL+EenAHY8s659fA4DIonHjDbfY9WT9aqk9kjpHRmoxa/RakQKhamBcfa5NoGirgcc4siXmkqhL7fuKmi1f++lG/T/DIg+t9njVpydOOmrIOpSKPDSiqGh4TI70CMNgDfH72VTXYjVE5gAoQkOQiFnNQcfZ20EpUgYkfl+kknp6xdLZEqN0SfwrrdvCP2oAa8u/JQXcLRKhlT7gbxs2b0nSPE1JLN1KKEFl6FCG5OM+gbStK0Youy0k+hcecnClmVM+nwVFDFo4FDyAGkdPQDGVcPAPagnJ2ovHzOVkxQsJzt3mSeeJG54uuYTI6rS7t9ExRFKqz/RrFbZ0h/uO2JvB5AF5onk/whRgaJ+Q4O4OnJoqxELd0AZ2T4Ubvha+1a8QcwCRUMxWqqbndkmH3VHrMqkwH1QQBKXma6reglki+x/4ooEwYkCZBfLSAv0t7+8EJU8RN1U7hoALtobRcBuYcHfT6XtlQhYza3Iiry4An/mJEdskB7nNL+aEaidm1BqV2PVhEB2Z4/BekRE98OVIkbjmcTyDlE82+TjrW1D5BSZQ8Ji+6dlhTZWbtmMY1hWnKEJdRWxe+0N1gg0kK3ynbDplYxlG/OmHXt936dpY14MVRFykaBpqSieWui6BkhdDp/k6mqRpiq+HdMnVPGSKCh19x+qOE9l2giqrBdJFaHThaNvV1j6Q5MQjEOOxlv1EaD8Opae6VVsXeXybkXsUKAtnm/JoXei/1mFSXbhSNQ4jT4WcJH3bRFEZYWOHw0MYYP0Kel0WnOIURGVH/50cAU8pC0UkBsKzZuDxCnK/fGe/4NdYFVD/6R8WOl+x87xXdJBIH8bKwmyjcT/azX5UV56gf1NHol56UcQ/+/rnWusfP/9MXYH8ve7cavRg18qF5RTfWGfr4Of6Ggv4f/Mt7Qmfm4z0ooAhQVyQ+hgEA3aknFLPOO/SAFBBMJ7FCRJTodkthIF8R0EdCy2XcTlGfRSbSxzIeiIwAr7gCr4AiBY7cacx+TUdbuxRk762Y/VDzV5ubv/hvD8f8xa+Pmr/gxlTNf+BtxADGcxn9FW+VkTN4L6gl5n/6N7/0ufphkG2gfDMfJpmAUSNdFG5mAmbI2sj7TsbaiNqhUCxxZii0Y8YOxVe80Bfcm+C5q3JrQHVngQ9YK4APdTWiBFSCuitww5iz74L/VpcEsV6r6i/jLoooVzVUPdaa4U4oQmLDWvLRYhqaNwCCRFUEAXrkBk0K4wRLr7twKYBbWNF4kkyeZhrykPUjJ20k5D0vlVJ9V2rAI7pSHMdSyEuEeZHBQ2daZjJKBMhuC3G+5vBNDrzNSf6gq/nnJAKEpmvieC0Rz6Ca1zd5GZZCAPvH1HTgn0AL+uTIyH2OjLxh8FFBkA8MkxFf5RB1R0/wkdKTBARA6MlP88cMloM/PVB6Us8+OGQzyJDzSHVgjOGf7ENucuP1w5XJ7X87JvfRscl9X3Vy4+2hT+5DPLnlwyD7yCM5uX/zIUxuHbvq5L6vnNyXc5nVSRya66ahjomOSM7veBahnU9of/ZbkgOluUmUPp5njpsoKBXwLR0hM0BWCt986rs5gu6m3+d5m/iNmFsZUdlEZDI68/yTnMDhyU/giaaUqn0MbR+TE/YRxaTvCdmcYlQK/GqVa6aYsM/hB16z84MrNOYZpPhU4Lq+hFWr+nINJxRi04OrJU8VmKvTOPWMs0+KgEsNJQbQ+iSerqvw+FJukCdadd4F9fiQIjAFzI6u4ngyWX1e3rCUAjs3iDzwd1kPN4Ox/6vjJ1pd2RB2PIDyMzwpUZNC+FtoEP/JdvM6Sbjqeat4PFWs5qxm71D4U6IXs+Xah3jjzLTbzY11dXiTqgucFOWubohxYpEK6OyQ3pFfcfbKjGn2j7JtFLc7SdGqJELI0T4yKKZQ0+6iQx2aurKHirDhbMPYeJcTpwaDQdFCnl1Fm6NbyMOtgPKu1MCwqBvY4NGVxoHb50Bzte9ldwpGhNTATNKMRvIjkEJvZVy+gYlKgTMTcjys+S7WQB7wbcOa33vVvzXWPPiyk8MaJV5VrLnELuv9eBVP+Xx5FTspa+kEYxVTPft9dLOTjsX/AeLTTwW+5+wXHGDrhXV7/5hY4Hd3SPUJYglw//eGAog8Il/XuTqYtVp/A/aP+eVOfwU1MhAiSco20IvCg8VK0Y72svchBvjXv08tVSF4dwgtbuxe66rOXxczIF2bCJKO8shDZwBjrB3H7B6G1MOXiBPlChZr6uIyFtr3QMj3PJAR8f3X+iuSpvFHr7fxB4bi1c1QTSVjNVzC5J6rqQ/yVLt/F9qjo6SxF02K3O0iP1JG7pwU2Z30eWtCZBmjjazz+FkEeW3klslD8MVjr5Lhq9d6/GSScQDPGD7qEsDpIF5DllXiaez6BZiYwK0i5qmp8i9uyYtQAFgaJHMKR70AhfSDFT4VPs+/GhX1A/YeuKo5GU/lCthzKOl/BvOD4lW99GIpyLI6W9q9SpHIhmKxmJd76ofXCt+QpgY6sW0gTxonDKbOLGsjFYZv0XqPa5XSZWJpv7qFp195vcKDVSjZnvwgJaCNT6UE7tOkeP60IZWifFDV7AsgSJr/EskPbVb1bUBeZSIWgbQmyP5GP9jlX50Dqg0MGTcCSJzwl3fVxEJOooVAFJNo/ZDyIPglBHdL8F4Ez5LgjR6EOhJ8ALEkwQOIXUZQ/YV1JXg/gnMSfC0yZBI8iGCCIKiKYUVXMddwUfFjmCSuVaHG6uKlDRyPbZQxip8J453Fxq+Ek7HRod1krBzGxriCjZHFRk+xESOu2Bg5bGQ8BPboeK0ik0NAj6KJCMjjJqr7nsO5UESWJc4FBucYZIpzkeJcAJwLzE2lcZwz61HQK4Lj4pynOBei/OPjHJaJKs550hqvinPBdzbOBRWc+/gjjHOP9kpBIJDAeIFUp9BB9odm8VcKoRuc43/xRxO++JNzgm3s+CUs109f2Dd3OLQxcjj0Dnecs+EOh95TORy6c+SLD7gv7nRffLQ8C0r0drN+fNfIxx9zH9/lPv4EgmrFCGcXcRlStQPVNiC9YAjMQkg5GISkVvXygVCGULu82DWF0E7DeJ0FfO4YFSXfWEhG3PTzihmaXt2Pk5FZdes497x8XpBZLw7N7s8X8bobhXYR2oXQFpE4YYkXFTtoMslmL6MtFNHs84se9WjuefyYW92/Wiyjbo6Z38/cZNHjt/3Yik9TF5d49lMHygdw9YzYHi3RIqQa+RJN90PI6X08fIpUUiIifMUJ8fmeb8Xj3HwbHpRv18Mf6gvU1e3D0kr2d5K/QbMgFnlPeNQZhKFS0uYgJTS/ukItODnJ52ixH14KFTzY/hadL5RWTCMoBcMNNLoQyRWtaTmdwWDxVEIvIjQ54nT1SmkUWKiH0+kpmuMja9RAy7281Rfcko+5avW7KjIUeIgp8uGT0+3IxeQVg/U8LroPwcO+236idvCie85/aV7wZ6SnzEhAa6X0fMb1oeH6sKhmyMEcYreAoUfvl8W2ab5lnOXMdzBEOkYjoM8zTbjMDm3Bn3hdyDNuQoMWAZ0uZWqKY04syizSHDBtaUV7ulKwJx8/y3cSnqyCqAdIYsGqR/4KImnHg1/08h16asT6nHA0B7CqA0ZfmpFH7mhMtTl81IBLcA0famynPPh578F73MlYMU3TkvlU2llNUlUg9Zirt2qs3ue8jt8M+mObGEnlBHVFdIN544y4ZRUTEMtaHKE4o2DWwT32DomjI3d0VphbjAHtUD0X8F7XMIiez/4q3l9AS6qg/MpeXgzNAXUhlKdIfBaQg+frU9oebcMUXVQvpfmMoIrALVXtQsGhYhlY5D8v36L40hOaw0ylrt35vLkZOkLJPuMo2b2Okt2DYOqQzTeKByMff8l9rEmqeKBkcIuoOpmz/F8ZOct3H2qSnuUjmPalSTilNC6L+1KN9Jo6Js44ay+WAKUlYCkscjIRWDX4ibZLQdDchgYQ9bCJm+XAPAgCRjLJfZozM903jkR8WGPy3WxfAnL1DMOByMSi0JKeaD9QEiWlSDLR8aoOq9RbboTmIKdimg/slg6AYvdAsblVcvuxNkwbpaRiWurXkoVJ64P+oEyABnS8A+rggcxiuKe1h3UHBJxMZ3g9ABgXjbI9RTJCMWZ54P4HXEhMVr3aYVSv8LzcPC2eYx+f4U/pxhahG+LbrIm7pPOGbsxTMko3IqEbpxKe0HdVKiD+0xfz6Qo1mLZEYMfQTNfkjHbQqWVspjp3PSErdVyJ4AHtORpg1aO6tAWAhob6XpnzGt5t5nxHG0gzjg5IWOlDhumfUcd4G6kMiYM96Gen32G/SmaYoFrlxmLWjcX8yFjUdCwSIbZ1/Clk1XP8rFCxSWOUnwoxfUZzWArn84iB6BMj4+S8XPqp5AtUd9ISRUPEXMHJQ7ODDFk3MTvsHFF8lRP4YtpAdA4QO9VAc4dArS5GnCuQyucmwqA3AoM6w+AaRp6HhY/zNIc/hVoiMOsBHzNKGDSYnygWyzhNix2TIYxkFAjlYjJeiF/uti8Z7s3blxq/HMXc84GauqJGVscugl8SX3B3B6wxeYjC6+gSFhlFQOsQrm6xM7HYeQXDcTdp+HIOE22GtXMocI46Vf/eatmgTcs0pUySLuNKG5dBGzErlXvqEn9c0hCeOnN5z3QKLBxnEh93RQFhFrKVq1p+VQ8HaoZ4+av8LVZ+pnG6abNzz/BPKXAnpSlETlHL4sY7qvyTWhgAgiBappPlieb6IX/iGKEtjhGKR9AIrIq55H+tkqJkhOkBu4i/S3siDMHSRVsoFrZHeyncY48/W6aYgFIVbPlRRoP/CgrGaK4vjowp0XcMDVmGBoyzqojvIL1BNs7TYOJp0qY8TQ/g69mbwhl1NuFpAkZbUTJA2FiApaVxniZB4YwNZjhoTjdu8w7Qi5sDGmDNaF4waZm6HALkerqjkKFbJCiDVZglECuBypLVy44qqbA6SonM1EK0f4BRAnjFO9YeKtyiCSWiKi1aJh5yFScUwMwlwGrJsFvzeGH6IIBTZqtGW1UxXJmtrmO2jPU5ZbZiw2ylk5mtWcNs/cwIs4V3ZXs0SZktBFNF8CqzNfLxl9zHmqTMlnwsylD5omG2bhphttyHmqTMFoJpX5qELd6qmWdSjTJbi4gbZ7YC7KbAbDVWdSYto+1SUN4RgrKszFaHA7I7w5jM5z4t61ruzt1pzozaOLM1j8h5ewveMls/c7LMFnJuzmzNnpDZ0nGP9IzkAx6eJW8VwLjXhieVV1gxqXGLgwXghk2ntG1WFjvAvJgp21fMjW3XUr5HnGcPa7HLaBZ/l/Ys9ZqhOTWK2lHStSSka66cZpxPrxgZ1itwrBc/PuAxZPreEPvlyzasQrWUNI0zYTY2o2lhwri8DSkPq0ndMmI6Gc1mDFvOCiMWuCVNCdWiNpe6jnhJWInaLGjWLC1eau6eLj5Z+KzMgX3WgX15GOzAWq49UzMz2DMTP3oVGCyZtVLZruVx8uWPUS0mGtSZQLVURfy4RAssS5ViQV22AkCWpuRzqm5v9B0Xq+ynzkOHhpkSXWFAFR899MYBZosDzOwYAwp8BPPlWClg17KUuYVmT8CALoObmMVW6yQY0GZQYUADZUCDTFHJMaBWLbbKgCbDDCgIj2FAA2VAgS1zwJC5EkNAt8ZgMIkBnaMUTPjsw5mTQBb8KdTmATPLgM5PYkCHZmWV/Qyq7GdQZT8Dw34mNG3m5clyoArHzTnQOXt9ZL7CgQYVDjQg2my6LoPbXzaIqdOxBtR1EJ/ffDoC1B1aMtNRNzvzk2ZdJvN0eNZFjG/TwDeZeb7OvGh45m2OOXNVLoEWJzHQMTVlCXBLn065WbP0xVj6uLnKSwsGLOoHc0L9ljfjpXlOmzYWOeVUXLkZKx1Ls8zSaFlptStnfW+3NAsOXa3c/h/OjLt8p8QTA2R1K1lf80Yk6zePiGpeK+/gHjRJuYebELTXLka+uM19cbv74s0IWsm6EeKPfPgO96EmqRC//DAUIltKr2MrCs/rVjieJ6VEu1GKzpulYD1VOXxLF/d2KWafKgXznVIcn5UienXOjdBMVUg9q0LqOflWZexzrFWPTlRZFMogM6aZ5xW11fJSsQ+t/NX9hSBGPkMpcRNWqUWL1EbGFZFZp/zKGLe6P2+pyPoO2Sz7wipKsKYXj9SqWFt5flwcc2JrY8yrPSS2brBQPO9SRjO4mtmkFLQIw6afWhGbk1n3hmXW85Nk1na1lXLyZSfC3sqloNhim+QTA65de0CQT7mObXcdS9EjdyWSx2UbBNjxRFNpufA1GcX4U0/BzLpPS/O3U8p9JsoL/tsBorFENbW10phQWJHvgBd5YhihmGa5w5sxkm08VbJdM+CesZLtHJLtXK/FtVWyDciL5Q2aoqYKrkoRNS7JUinLznfYW3sdHaNpKmRfP63yEytp2jYsaN6KOmQJyY2guVYVNPdoK//XY0HzVnPxtipo7qVIFEFzBPm+T3M6BzC+xVQ5wvk2Hb+GTB+GLVJqz8tbD12k/DDkyNvEldrDliPXqDVBjhyPyJFnAIQZTDpIStOK8A5UHegAqp5xoKVykZoweGnelgnnpMdNLCjlpJtZKdrUMOQakcvWw/7MZtJjt51pt9TP8ajsGH2SRjOpmAF54DbRTHU7o0Ot25m2XYITvYtJdfzybva1br7rzs9wjRKvXKMOeyzT1k3TZTdNmyPTtEUxpun0JrwScPSQZ5D1gA1cbZ5XEEjjNP5YBlOTZk7JktoEmVsimYkYHFya1vO+ihAG9M9OShUn1FZA91COSmQwQ0AHFUQZZoPheBo0UzJPuZ1ScI5ENcc95abUUeZpuKgZwH6GWjqLp4wZFWGc9OUAXsi8XM3hTMLKXdXsgVJshy1Wzqnp4D/l4N8aJZMifGkK6PS8YEpaUiEYSgKbArGZEUJCLdm0AKe3UqO8z0ozowKXrVVMA6aDg2obU+JbwbYYPkSv/Sl58WhWT7eFvKSOvCxOJi/TD12I8jAkJ4vowdTDlpzUaHqC5GQKcWPkRe+HDm3OFoS8dJS8LAD1lUmoUVYORc3KSxx5ScbJS4ZInkCAe4dmTkZe0m55jsAg56YEZvq4BMbJS7AAtVSntEXCIrSNuKSrxgONtCSfdnxzRXq0DQgrEhOdfZB1Nt2WYbs2dBLiZ7SIjWpsLMkuPUwCFNM0/nS7tiDsQwu0Zxtsi3TM3fkObrlXN2s1EaEUhCdvvrTtuV7REfGBjmLNiVAapQglpx0VUqKZMnD/FRFKGxzFDFRWVQDQpiYsowjhUp4h02m2TAsYFkdYao6wcHhKW0tLpQRFwxnyQjUDu74pK0GZUgnKgoN/tin8QfFRu5qcALdG/JhxEDDCU0GCbAJJUgFKNVJo0bShRbUKFVKaNEyEkhEi1FEaqKSoAfDVHPgaNIU9AcC3APAt0JQ7lOo4xFxwiBkrLVUZypSRoVRRc8mBZnoENMuKmpmSZvyVEjpf9oCTZSi5bnFj6mBbN22IM+9aJufV3a5K5UC6LW7OVGQoBTG20UxFhpJbVkV3whUQghgBVwqDR7ngSxM40ixxZGL/Z0b63+T+/4+HzxNMK0+gMMsEYjOYkjHB9QlmAwrGCk7t0Um528hkECaRy2g4E9mMhiE+IaifP0IMAGYryHLTHiogrcoF1KpcwMTJ6rgAi5jWdl1j4mTsTJiMC9Qwk7FpJl1nfNLFMksrkdTJa5h0wDWZeL5OvNrwxNsca5pmyilZmnJLQ+ErOWm5+aVnBS1KsfbBlJfwpUJe9YgSE0zaMmNGpEFtJzDZypXZRol62lYVmOjaBIFJGyQDzFiq7TDGwvyK5U5tW7ksLbkD/GUSvterrETUsWsaEM3tEoaO8yN3lJ2NjMsCbcNM2G4WqcWHOSO20xL+9FAbS2ZEGWZEnbap6h5MNUyDzGIL21D+WGeEb5Ypv7JMiZZFZ2iNYqZCN6tYnbA9HVudRrUsMEI+pW5pKqG9YJembZWlya9gu4+CY20hLZZaFhrOJO8SZsMSxY5Mp5WBcsOAFTtWIo3Bc0Rah2Z686FZ0qEB5FrUxJ+CF0giwDwukV6gFJibcdc7DIalExDphu+ItBMuKEgtkXaaFlUiHY5MN95OKpFWiObqLQrQajpojfV/IpHeBi2L7GFv3FL8KcxagJgS6QVqTSLShT+ElBUy7VfItF8h076S6Y7qWJw0jQYAT0yjl6lVpdF+lUb7RJthbao+6uNhIlcDdhqhwZRStlQpG0aLYqUdStnS41A2ZCtlOL2rNiNtSmKtVMG3flTXSnXt/1Hx0xKep925IOiqwQV4vNH9RfcCWYEiM+fOrfiC26neNsgDrMvrXLik9IwioGCQ/U+5dlSDrBmGJq7XW8fp/+N5E3xHBeRZH7LeUy6s9Tjkq7OnQK6bz0kIp7MZGi5WlrJP681aZ5Tib3wvnHRbFf+VN1b1qq9e24vYSoom6VW+IuTYy0xcxFleoHeCA/j1UQNvaCo3Qxytqesj9qAIbesQcydA24jnjnho8ShU7zeX9owH7uxP9XK02A3ZvJZQa0Gb9MIBfvQyeeHth/45yRcR8ul9CDVFguGs3of2MGLGtw/gGQLOiT6c35/sE+q9z0vRILnWhjTdo4VVM02dNPuk3lx/1sO5Gv6psavhqMLeDMfLyMXwx0st9nqUDuF+tsOzn3Md/9b2+GV2vcWtQ1a9xo1GmFvcP+T5k+4kqPNFuUJ/do3feD5Zj1Q5wCMHAXrb+64J9xb+uN3w+Xwl0HOWl/Lvi0srXmuBmwSC8wcDnQyvxRPHFtK+IhSGxp0lP7OIL6y9UvJghsHP6lGPDHLD4j9CN/r4heeY4IXkmT33Rz0978Nt+0S4mA2gkLsBS4FeRKlpPuIb9wfNNMJtzecUDWnFgRvP6UNKbJupLWxcEBxCq2Jq7Puzl/z5Pxz7yocuvJLDP+3vOuuM19CTr3r+85kzuLD2YR4wXOxsUGPMcdKdHxisaSXy71lgtzjbrbfg359dPKAGVQDRg6m0O0zfdyqqhMZu42qRlP1+h6cdo+Y7KXynoQL4QuDbXGG6h9m2mySY/RkGMg/tBVj4Si5SSl+K0C4JXfsbhwfo7xVaVlMWnSbTv+yVIH05qNfQsNRPOCx3MrjrQ2NCLYpMz9938WCgQ5L9ORq3jo4/Q2VUa+8qZVRHjcj7oyAlavLsZkmdfNP4INJEmqWFWF9BrkApYmOzIoo2F3K7LeQ8/5gGq3bH7tQo4pz+J1x1WoUIz45KzZj2GFvytRPZ/0Q3wZ58FK8bor/mQX+4xIZbGCbIIPk3ihZfI94nOPPxj/fFPNpUiV/Z3gGAOVijZGNg4nbuHVyZi+NBbs8P96UbFOqI+xQ5Y299jjqE1AHGP8FP7aXvM+kXwRjc2d+z/MW/PG/pYs36qesP8vg41CYXvKpXxh/aSy54Ze8BH+YfyLukJ1d5a9/Xyz6jSxzxZP+PFABqP4RlQu6fV0F8ic7evfrYo4/d6hzuXiAghKF4Bv1XBvCZo+E9HLxPg7gw+yUNvgNLz90S1tthn9HwHYi/S8J6FfcTGv4kwsc0/GmEP6bhQ6jpTg1/2DM4rip0Mi1AAPKGNk6X+oP44iwJ3i13fV1dO8tWUtn0ZdfELoJ62U55hdeiqMzVl7imhhL8lNK4Rknl/hdgLSfEaAIfeQR6F5ETG8JngTggJ66pIwb08GwmwrogKK1eqQw5fFClmunDnmYSp3JKLs0mFQBgwb16VkFzathOoz4VYDn3b8LBBeVC3E+y12Fhy2sKampkf3mjMkQ3voaXPY3NbkUepXxIeSUWxDdKnInNPqs5GAI/pQtlP9OSLTm+KPvkjSNZ/srz/Jdi1Ra7BhTodW3//EDW7vMD5SDCJ138yiJ6OUUvga4Cv1738mthBhPR8cspfomaTfyPvfODXSTlVz/wKNj8A3V5jxw/1GYCRcFL8qClM/klBcdKSu9J3rV5kGoDd2NfL9kJH4QvwTxhOCrv8ZKC05AuH0lSeovne3zfcIL/ObGXSZ7aTlHPlrwL03USLHCS+5tm+t+vKjMFVbdwgVsHD5tguHcAY6UuofCJ36/spX/oOU73ALMQsSkkHmIH4k3ZgZ/gdadolCtPPJEhiLF84ZHgRm29D+ys42X5KT39VF3wYifgvoq0NHzGayGhxWL22rPnRmH2frVryS23nPtLPW/cKBYgZpjW7C+Ur4Jpurs1iMUaZveU5Q3P92FFUb1X4pRG8K+0U/VZ/QZMMDDNh8mKipmqSzyPTcRado+r+0s1cEBgPtCF7K8Q0XZzgwKdFBhfOykoSP/8O9jcrMSUpjkrFjj6IYrogQ5hL7kxWJ9ofvbP/cC7rvHSCfaAqKaAryngvdOZQAZ47CnEmuz/r/ek7DrsWqxx2R9CxJPCV2iuXUWIB3EDGaF+qFfUMUkjTs8TWdKya+HTUApISDKhzKLJhfHf/6/H2Tkfqs2bUq0aW8VuWm0ecga8wPDkD6NoLpGaP5S3U0mOUV2DmmVS+kN5C0lt9lGojq3ADag5x0CJm5/dC4yQ5ufafAAbnxfRpDb+sOrY5AEmkb74DgHPY/yv7mfsDkh3prqtGQN0mp5d/UzQwOyFDL3BtzX9lnN/NAx97EGcnXRyNE3xVQ9TsFY7f6Z5gCp076MonABzA4aQJrTspsgwUJ5h3/5OJpEQnTn+As8uFjcEljmQ/b3y2HjPKLywhqb7WNZhYy67D6mmyMDqYmVfdrHZV+T7yLx9Vd4C8/Y1eYvlMPNM5YCFUXTKUofuQDDEwnRZb6O05munyPfvXcOXwh/DJsXAkWG82s3K2kWDgUTI9kN7riu8a/M/KDU5jHm7toZZqUyGgQNHB9grXFn4jPvKWPiGUdgtRCJ1elMYjPphio4UUWkIWNSvYkIj1zFLRAdNBgU0IdKVMSrbL4yxdsHEcHHrWCi9UpaCFo1vzC4arKW/6sNYG4YddxIs9gVADrtRrlU3yjXdKMNztpcqDyt0SrXshpBDAJL9I6Al7yae+HkVPgaEYaoB8ZBOkbdeePseeOuX/+RpP3b5xeSCV/X2PVv+fZ73BwzQE7cLzTBFu+1W4fG3w23dhbo9q2NY2ae4ApmzszX1LsnFWfITPH94nvo6T/3sc/op4jTVTnh4mT2i8/ZEZtKOvgRm0j4/0UzawPP8TWzB3e6PGGxTP9y3+UUgrcNiueZT4PzdaoaD1QyvnZBht6YH2a0vc5G7jJxGI6vE7yFSsVc8koZwA/LssbcaOQhKC7hfcBZwlYUcsYD7dt+rn6T9x/AnrPlH5PFQ8aj52CKAPNKZjoX4UIxQ8bPujMf+zZC9R3fnQRqPlSFCva7ymAveL7gvQ4JVKVB5IeqF4Ul80cKXEkrAOeq3Ytc4VK/jMUMVlUgNCgk8kJZ90dmTVH7Rq0oLv/QtSAv/dkxaGFalheFJSguv/lalhd6wtDC00sIbPWYbq0syyBU4+7s8/B6z9vIv31tSWiagKlJ3tvTLQPZ19Be1ii19f8SWPnliTd/Hf7cONDMa/izfZ6EiN+Ms2DWTXTVJ94oIfFhM8UuJQ3skdC2CVEbuMpG+EeJl/6QrKoCtEferRdH0wk0p2LteM5mClRP2V6sTdkTaOYcZiIMHUZ5WVsEwBLjdMglhlP2CYTVMrFUKsn+2NHSXlpBpCXMogdS8LfQ8SiHA3IoicIgChLv/l+GTBJxSBK67ju4KbpMJdfU+PGxokAx4Int3Vqv1DH22vq8CcwSDTN/OspP0RwPwd/61FXvttipDIGvGYif4jgBfc2kcPozFj3kTcOSg7KhJ6CC+MxWkHwtiz14WcBvj3fuLyBI/xfsidjI3teEKlFndWFPUQDtWi7pK4ei/rvlPuqqqhJCoix31NWK3ZLgOpcidlWyPtffXeF7RfCcOrrKXvE82OVSHocPV/RLZ5ciU0gFvgFrUcs4TeiwthObuOsX8kz0AFLBz8Tro9lAEU4XpLWXkM9vVDEjOitZQMqEi4mpYHyLWY5wY/Ac2w9i6MFQT691f3dpUIKJndhHLuKy9riEhTwSrirHIePCyc6X/1tcyvUK8SnkUSJr009c7OY/Gq5gH1NFuV/8yDgPYo+axdIcRdiid54iDR5mwHQrA4KqxvjUPYVldjifQfrNHzJlDEFCVKUQUqVzwCg6scWqE1Ox3X6PtP3jQV+IKi5o3otIYcQwonIjwSw2vD6QoqI7DEi1Fxd2IBRW+36doMzOKvlpRf5HmvNrYVkdjPNhGG3aYccDTdBhLk/yX84MgbZXHXn3s0cdufnyE8+wyT9JPnqE9lCvaBlX+B1CLQWoOPzSKWVYNrjHf2eh7KvpVkfi+jz/+ume/ae0fL7Z7kL17B9Cw0M4r+6nVKApotG6/vH0Xvnb3X/7U/3jyE/XAxSe/jLnS3eDQvdgSRVhLbwNYbwt0C2ZKdnuFWPZgiH6tZxSJwDpcUcR4XFXURRELxExDIGb8yL3jErTUErRUjRxQILlk8gyRQ57gla9j/dqzX3tUN4o8mHtaACZibJRlI5g1JRmN7B7tBkVqIM3EfraMvbsS+9caK4D9sJ5lI8uNgUwITVAuGuFSrvXGdhwypayDar7U2p0tkrwBY268/uy9pmhqVmr27wvA9TwoSzCUpqJ9H/8Y/n3p4gGnfhSpWK3ed3gglMztzn72U6fem54z/cTBmspZkQM2UqMre/ysZ98QTJiCPlv2TQlHACPSmTptBNTk8jfQlfcEoLr8dicmFcMFk6r5pNu+eP3RO1/59Td+gxH69oCmmFzhpwZJYp7gY3+FM0MbdirP+hv3M/URhTMU/E1p+HR24NXaTTnkgo9OOYwDHZnFGj0DS3jFnLprmUNC6OzUM4qptrRuHyS1qMakqIJmaYpSQoPew9h7PSo0zUOVUmFHGl7MGE9UiXZmBj15Sk987wFNMngOyajOCIerhhy4WeRr0/3nrIjlizrNUwub0tQUPycAoBbHI6Wn2/is37qsjU7fEbBOndz4bmMi6EcqEy06wOBE2M02KhHxSkyz4mprBrCaxkVOjsW4XVlMYxXBCHIgNiZUzJXERCV/beK/K3vU4dcj+7pn7/vBf8kbKL+7emZw4B95dNYdJRFxQAcnl7cHMltm0etZ8nDw4FF2GcpWNrfFj6nsZYCrdK7NacAqKSKEtH0BPUNfwaYO8kXVGTTdzfQ4xXY3G+ru3EPoLo+L8dlo+xwB3bkhRb3H/fflYNoX8Q/VlBtO+p5uHvT23hT5FOtsyLs0DUOI/ioui2cMJM4sUOIPgGs8LdBGvtnMa6vBYJ7uNwAOuMvpOxAnFr7FkgXx7r1rkIAfRPRG6R+yKk7qHXkg6IcvxGZ1Fh6LqfrtmqRJ45epe9gINr7Cq0SXtlCXuszZrMHJJ7Z5ZVeNsLlm+tU/9GKcaudhim/W0RUKIdBcyEPn0TAa0OL6Gx+IkU3SM37wF0Yi8lamQz6ua+zkhSS7Eb3HukzUpDqiUXf2cp3lp0M1wkxepO3O61Kkf5atru7EAzKbhyKlFihDm3ITuaGGl7Nw3seFdSS+Jm9J31KbaWBsot4/Q8NS18vXBGtEQnU86jyXCT5o19S8iTpfbqr/C7yTNILIpw66+wr0i4klAwCSE6Qt46e7HxtCMZ2d6nT3aA4YPif38PMMlkpkOgJhmcYBzdFnQwflgAZdT0zXQXSA4ddaB9XcCAXOFNVxDlp38hbu8VS/pViqqw9ihl9TfX2ljEtDFxuQqGelbwqdB4ujzhS6M2BOasC8q29z+tZS+94y2AeVEsgLt1BvMBsbwYJ3YBFRXIzhFDEnFOIS7gZCJKe/MdySNGEZNUAHz9VT692qBnNWuXe7CCE14azTXq/HJOJ9qi4LSfYqnZEB18Y5VZwQwGTzq5Eg8cBtqWAZjXqHj9/b5UhMm3lWXkfxCLIaRKaywli02OoUZq9BQSg27t9kol6LqFQ+0UK7T1FhhojnIj3FDqUrPFbantdJe0QoFLrv9pstAKIjASoi0OwMPy1tpbBGCqCaA5ACDjWgwpB8reinUJFL0MjXl5FdF3lIIysup97ie7HFj93uVC6kADKMEKdoSalDBpzwGL74of18iTf79A1GltCXZuJUjpNx/vfm15S3oHYWsRFMoSFxVZQo9/MrycvVZN3M1vurMoEwp58joYbAKFb80L00qeEjjxrKRGJQsPJeY32QefAL/aJrVkYO3mM1LizkAbOSuYUGNnHZL75GB2936QwLInGnR1grxX6qSoimkhEDCrZ6sCbF/VL57YgAUgzKFMYHHrKzjmLpD0VkFmIAwdvs46v1YyMV6yCABhnpmcZkv2pGwKtIJF3jjTSSoQRIjUsjs3fj87JRD7VF2Xvw+YlsBv/aa8Y16b7mhZBu4M/odPrZO3Wbo5bD9WCVM08+VMXE5UzKtlbiQbjceZc/8WNc8grB02C1U7cpQBhqgK2S4NpaXqcYaWVCZhNiRUQPEBrACcHgSO7jZJBDazlcNYXitk8pQI3qmFuMg2DI/jIKmnxmV5+s2qp9tl4quOuwr2psHqmtL1kpQ1WdYK1utf5lznWV2uQR6oyynxaOuT652NpDLfYFKNYvi01soQ0tVO7vNsRTRcqilLyFR1K01dGmXPJNkT1C5g4jiduCtmlqsI5LILfkU2r8LKNE+ToIsfMZPNhTvjZWDfSItbYiwIznpsHzsHYdndKQR/y5+EecoxmSnPm86e+c2KYtYpE6B+K1As4msTc1q5y4+6T5FaetCTkQiYzEva/J5g0OQolP2tfFZ6EUl1AbyTrsugIIHD0AMbL3/1OAOBUVdTcSDTMSAUZFRqKBbA3NRpEwVtpCtD7kCZnHAi/tbv8K8UwEjZQWHqqYj10EurkmExmBoq278QTbnIAfJrWrqS1NlcIDLdORMvIpKU+blBdxJ0BUT99Y95IJTl/1pDvb7OgAILBYFStWQeZQQiZWyKgLLYFMDMjEKmIQnFf3g3bK79u7nv1txc/rY/Y6Pr1kxAtZjOCJFFWsgv/784NgPHSpe6oudfv0ba++7bHNjFwzuYhlJZshB3Akfc+hlx1UcR0UV2UBzN5gWIWP1lYkX/YziNDVk3R5jA3riKhLmHtUOyihfI+mhiIklBeSl536spOE+ciUYwCmykJtvAru5ur2mDpvkkYkzCcUkQUeEuSYFuYYfxYZsp+Tid6QWKz8Q95n1akox2a/BNZULbAsW0e4eupTpIKkFKp3nDIHNUWxR03QhyrUD6V95mSKv/h5x4xmwjyVmIA+b5Qjup693Yywjriu+VzAYalS554rBYuFtfhjCJ6K7llWKmd2/YCTMVorjPtyNC0HNhEPhLrsBSpqTv9pbU+NIcTyQZ6YbJRUvvVbipvIiJsGnrxwKIVwTPcaChJ+KJ8P0DB0NQb2+jUmNDH3mzwKsGUd05sVsQS1XOwtGuucpFIt3fBEcQR/6M/wRYrqYqvENLBOkSBEqRt5t2oMBJWs1p+++NDFsYQe7HvP5juBAmzh/CxcnoVYIUiYzZjPLP2LOAalB7aS2NyGMQYG+ODdu66/24iUw/5dEEwJSDAnQ8VIHAD9Nnqt1yeAYepELn1vFDd44Q2M8r51qRFatz1AL91OwlxoKPrWeqmZIufvGesYbmZRM59q+alugszF5BSrRUdWh4wyI47IhG4hbpqy6oY/kwt8GTb867AP1O9ck88KABuA1Wy/8xStBqMAQQmFNOM271pvR+HptvAt8tzGvY5RmsIDQso6wJRY99JNITOap6jGoE8p00byqSHgyG6VPZGEadYsqYGspxZ9moo+MK5pcOLqJ5YqNeSdXZvpwYE+deC3uElsg273c/MuzWF5mtYD6ibWZUj9dH26BSBcU4niFj6G6hjZAeuFZ6ZkYlHMwmDAUCXOcVfH6fDQrK5ntAiGrVgyKXMsaF/iUktisWaCe5/FXtpZ7ftlL7z0Ob95ykVPgMv2aRCSWVhKnJXrdowGXQxyF8io18vJExi1hoZl3ozJXPZGGYMZM+R/d/EAlITxWK+mMQsDQ455ImIBkQg4mcGhsDw2Sn/9Id2DOuo/d/QilEaG7iYUNvOiZ+KRx+GrEbFygrtRH7/l3bG5GgWGy12N+hgncNznP3ZL4C5G3fZqdzHqoVTqrkqB0P2CUq/sTXiOX2iCSEJVbkYuNR1G/lr6VCgQeOJgS9frUKvzJNyXzhkvi6Uup+5qrMqWb0eklr7LC5Ru7PvPP/bpT3f/+gX/b45sw+f6+7724Cde9IVTv34x5KXK+TJni0pkQwM2Cgy27spqbNoXZs14J6mkU24ec7SPLtY7kEqov2zMEr9kxnTLEQlmJ+DEoEO85oLkPastTX5+VVlo+KRer2iDP8lDxPCiDzbFJ49DuLeAoS38/m7iv8t6yhCYYREirXf21lTK4JR/nic6FGrn4eHAKSCztS2EYkpPOZQMVLNPeuqCD1HX6Ccne78c3+rvfC5PIHgo+6sv73l62wOKmIlGkqo4/nXBcS/7ZzzJy/5FsHQEFR9QVLwBngqD8TN2q2Q7mSPG0ghRk549JupyMNQDYOW6YoPYyo2GpV/Ruhq/lmvTMsoNs8fTgxJkbspxGklp1ICstAPneth/8c9ZqChhj2K8qoksTvfvWver8aIinZY6FAt1oiiiC8+qVeJboI2EusrdpeLbOtOtzi5IIhFCXFdD54J9qWtVwqpqVWcVLVSV2mWg7ZaBCWuOjzVnkE+RyixR7l5uUvuwGFBS3UDZqd6Cw7U1auC9M6CmrDVTw4sBlgLlSawNxhamqjqvT0DNk+owYHUbO/+vpZ/zvOZmOmZzwzpmO0sXw8BBLssikmrExMp/qb5Bnijxajj9M3wv3oabOCIVFbTf5XJ4pv7VlzeWnQKaoHAO/ivChw1xQRCXslfIZ1WXTJHcuR1WXJ/sdvgi1dsCKNAIPggxgp/nI+5oh9UKRNUrlGmEqYVNF4wpPeyP1dBbeuMjrEyovrZB76qqhA+++viqhK/3A1wMjSdJw9zt0hUunG+p0MG36LZCYIuU8C1FrNL2ughDrdhaxxbVIlfc37kq7kdFlh1l3zCSbC6Iv5g+7hc3yRffNF9oRN4YzpjH8nXe1AJntMCmGHZs8NcHXqNfV6KuR1TJwutahknwEKn05rpp6yfSTXsaVzSsVG+vVoM+H0GHzTqPeAg6JdGv8Dw+WbYg/Xu/ul44im19gWa/6LaotVI0PLyHB+sbYXsIRWkIN2K9gWDxYThdUgGyh1gJyHJnxXzwS/hABJrgCrO36CsodUxw8KwbNczyBAzaHPFPtp9gJkSPSjSzWUt4XqlBT2STuFjGBI+wCHUDrxQA3+GkXS7qQa9EN65ybIvsHOInqfAXvtu5x6CQJeF4zbdn+npPcrPYK2fxm90s9gTeI7P40CPemAyiLw5Z8yeQtVXpyu0noCvX8Dagn4mEySt8CGQ91I2FBmghXHn/0fza3517/QAnVipUf7rqCKqbTd5xcAiZOcWYteBlPvf4EazmIfh6jfbTtwRhYjQEJ9wS0k03ILcpAwMJoW7BIRAP8MYKTuZYwBcJ4pNu5NJ2S0kMBNTPW8/cM6IeXz6hCAwFBHW6g4mvtqct2Wd0Fhn96OcVSMQuKzUy+L4YabTTxqgYJvY8XYFJdf04jxT91bbMdaCJ3oaY8Qj43b9U3TDL0RP4rtSCdcMoDGzh7WVzvWhlt7yOG/XePZgb2uW36tBSK3v9xCQAnZFTai1iNN+6X40MH8GJdXSoTonOn4q89URnL29DFe7s5RGlyR999Qlo8p8GkDa9GNyvE9+tFJOs/NbFRFZMeKoXFOjYhzqA4F4f6OD3/k6RqERKJJOi/RTxGRykJiIDUlkkUQTmIIYVJ3x2Y6Z3yMTRUtsYHocWFT861BQJVsyJEOHZM4EOflKK1UpLpoxgpLb+p/Bjo9RjS4wRiq0BmlS0GUpDNA1Eqsa54d+KiN/qaJ/KJyM5yepYHiFv61g6Idu04GcHFCWFlm8+naq+zQy1wbbmGXZnK4VsF4yO6TQc4O17rPz7Kt+fGWh7MzjjyaQTJkZ8EHEjbEwsNnkpVXW+AKMRmNFIb4vqpeIwP8NrAa5untimFw28NnVvZdkRvGEg7u4UKZ73dIqKkcCjF4mtyvJGozi9m9r3d188esGO379w777f2HhdfN/CHhs43xwndfrhU3rEbOFTems8milGIFXLrDRVFla53pW3Re54oENJGVluH9DYrFcw98+gbEiuJuENbkds+z9q2n/nUPsPPXFi++d/+Xs/+5NztHffj7z+N/9h14/M28D0w2g/Woj2b9Zu/r7RP8RyEXVmzyUXaQ+yKEGcVCQtrKnq5Rk3FMGjQZ6l6CfBjiMes9D+wX4bIsVM5IruxIQi1di2+Aitw/Llyt7Y/Yg7njgok1UGuMZ7qTWugvfzsTArX1AxJXCO2nhmA86CQJdLn6IZJqil8G6NZilZZ0EdTQu+cUaMEgL7nvvb3/jVF3+FdWr5Ttt/ezjXU/7m1aPXU8CDu/speBu5oPJc5hB0G1JVyRfgi1BlP4u7nqsfBtkXUb5hGVBE1a6Pr6s9x+olZ7k3megjxAOtemx5HSbMvoTCJt6B0Ztmm12D+ZzvBZNvZovc/O8m8poRyo+GGNrIMbTROEPr0iUVBOPkq1DwG3Y2+/uSmQV4s/v0VWmn75hZ7F6xO2Rq7xjZSDMGJSMLdkfFICHiVCEFD+HnRL1/jJHFZvef0CwK9DgE2fUQ1x9iZKsX0Ps8VMP3jQZ296744mXrgm4yvrqDxsNqdSQP5/7SHSd/gy0YusHmb3KDzR+9wQabNvcP32B7+6urN9gMwx0rwx2B5Z50jY1PXOL9IheOhSbhjLJyjS083jW2mHxzVU2nitxmS/QR6gOY9I5XH+8a2zt1NH7Z80N7CKY4pZgWy+mVOp0I8OB2qG2PSJlqtZwsHELjx9ADwCy5VEMtquuGSS6OZ3fovNcK8J2OdSivaDPLzwCBsBRJd1J5KUJrWdveD78Ex197dLh57L70D+b4K1JOHIu6NBSt0A5kv4rahb5EDtXSvWafjH1v9i4VYxKKKm+lCryVs7fkTvBIWpikHzx5XOuWkqy3f/Jtn6xNwDXkUWmVQ7e3IS/jDz/OcNi2MYRtbh9Fse6uBOW6m6Fc/znPhXrHtxfx3ndcxPsNpD7ycir1TADTD9X95AdOsJ/8k1Oa4MyXrvP51lDw4qnrghdH15Xu2I85pzHSG+vQ5bZfdaakJvDwEe7XSJYaIfzAu1z4S85alJSiXGUe9xUljLwLiNuF5p8Yl094U9r3X8jOQqBwQ00+lWgylYcRUtVjuyafogQ5mtQg/uONQAsZwLm19mvmzGWepgQMeItSJKQqR52xt71Fx0jvpkhj0YJW6UViGkiT4aepR699foXcyB7gtcu0FGltpKkiBEvuRcnnRvTbFtk/JG8z3Hf81DARsg/qAulijQOYfp2bq1+IahTcQsu5jcizYbEaqkvSHfUtzyCahj7xatEUBmWOGywX2ktv5bY0nEw35duwyJBV6xQXKe1VbKc4lseDwYaqICLHFtY6nrGnoy1snFQkrs4+q31A36zeRUMmn9wwmTM+GOflEAnYsCA+ZjyxnJthjKBFj6sGcGOTULYfcUucoQfXTMFeHTD5nDBek3EyhFluPNFownioH0wD6KKmzdyqvvS2orX5Ngft7aXBz4y2UqqgxgfQdVeShulpbFMzpmY4QOIHsJil2AAwcmQ4XWtLnimCHfaeaoIvUkuytQgeUuEKZzulVqGVN3HLKFmdFCXUxE9bxxLuM8ymVhya5yTPWp6rwqa4lXBWf52LmojyEcupmF+SJyKqJmFQrFVw44x0CkVzBxiIaJVucJ1Sm5gp3eaudGTQZmCcUUO6Wzjk7k3knHWZhfrcWZ1yKLB474Oz4uCsqb1o8XBPBaojJeSB/FXKVrC3V9CgeTCEPWnwtVcFPfg5j4jd91BEC8Z2bJEjMudI7i28kdv4nYjfqZnnbOQpiDxFMwt0eGymdYCAeXC9RpzOKZ/XRMTkhLI0hgALDPi0eroXDx1qIVdzlt8S2dLst2AqGRxTYude5n6Mea6uYSUuUde1GrcI8dWi9R2oogelIafCkpi3ArCeBuhKaJeLPL2MPMNFnllGniXCsvxsbs05XN2jeFQexWO3S4m74bzrmFK78UiKR4t1jnxBThpAlh6DQ0mhg/lW9AmuF2GHPF8gjiFx+/VYKaZprPWcDfK+hTWGaAtElLPSzcfksU5+Oo3hssuYdY4xElPAcEFeACxcca8qHGoJToETLwkzbM6jqh4trTJRUv9SCM9z1OwKQtv4g+D5CG3nkC+hRQ55EsJtsK7YZO/SdsHMvC0vi/qSycuMvnTkZV5fUtrKL9v0xZeXOX1ZFvAoffNRJ1C8aMn8jmhZu4oXohQv04RXKnJqyVPwCcg0TUSRRdkOoRDKKWLkKk4RY8dUwAY40fj8EfQtzsXP4yTrmlecx3lt0S16HMm3p5BEf04ryUwl+vlO9RpYnCKVaMU7JO4OLnaotB0kmXYSom1pbZ1fuXTCug8tci3tXMSRxB3lqiql1ThVMkW005UmaMUkJVTiSFixqIuJ0jUuaPWKamx9Lm9xtuSBlY9lTw9TvlfzU0XM81nFj84HYu7hBy+SF3CxFzJ+bjf4eTpXcobBz+3fIn5eqFh3YYmfMxy1R/Czx6ELJLSFQ+dLaLbE2aTE2UaJs4/n5m0TnN1GicVMvDQsZuLl8fri48Ui8DJt5ZeevnTlZYu+xPIyqy9zeLEzYL6CzfEYNs9XsbmLF7uOzeGlLS87Fekzg+enGDzfAQw4l5CHGEun5XkeIi+yqJCZGVA8gVErR+CJdj74iqqn0A6ZD0hHQDLtLGeHQ9yIzqPHcWB8rggi4uf4M2Xn0ExJtfpz6aLqTJGMT6AnyuSbNFPwxY7xmdLRmXKK6YOZKTt1EpA238wUGpopOkUoJzrBTNmGSbHNzpTtmCnb6UJEMtJhpgQpJkbADrLxgHeFWcwK3OrbwrNizsyKM7nAs8ysmHvosyKrzootSqmxOuisYHRkjFZavUXot9JqX0IzmAE6Z4zMf4Fii9oZXixqd+RlmyPUsSXuvrwsuukQW3rereB5dwzP/SqeL1fxPBU8t6Sbpg2KT1VQ3A4XLsfmpKg2QtYVX8+TZODop9/9oxdX/zDsQIyddK4g8MXVv+IiThQ01OoEax5HNnaCGQYzbSzWKPqfYtF/xxDCnqekHXg7slDUykmn6D8BYe942Agbi46/Rdg5YNEcbUGk+jZu+UBYcN/bjQ98egzIokWubYyIYZ7jKSRoHoizDL/yhgTzSs5YgVBckla4gfUFsXy7mrflpWuxbCu/xBbL8LJssKyCPp0x9Emr6JMJ+owTw/FF362glogp6dDRG4YsR0cnB1l1N2ohuw27wG3W3/52jXwMnU2PfV7BP7iV99IV9YzwGHosgLQkRS3kNdqN3cVuejQ+MgxmKiIyOnWFHqULi662bb7Su8oQa8t+mNqcJg6fwCt1jf55e5IfD5XeLpitVAZ17vFMxcVyQplRC3UWNQNo7OeLppmnPNV0CCjH/UcfMxgvjPVU0yEg5CXLNckE5yk5JU8h80/gH+tlY4dyMMz4kE47pKm/aTJLFU+dixA4D0nqR+Nx9ATdoe3VIvSF+IVz60umJcgAY6wxTy9GMbkWc7Wma+bdo/to3TQJDggFdu+6WYIj1Ki6mXbuYNqGixL/yG4PGtgNOIeaFQ+mlUua6lHQ+C/t6r4mlH1NF/sazI1H0Tl2D3SOxEGCYDxhPEzLZL/86ofox2B35SjmV/Dxt8F5Qb9iJjARk1JCkvz+tdj5D9vkIx+il4qxQB9C2ufYEnACgocIlREOEeatcSnOtIqLZM5BQqSI+VDYq1ZLW+g7SkHSkDA4/V7IpTN7LYP8ijMKrQkFSEiFm9Z+XUBBRQ87TP808toVsag7nfIN9AVTeLx5Db7iGiMnNXc+oAVY3lHGTSxpYfZPqiWrl7e6elEk07eWvoVGam0EhLoEGPVZSsbuGeWePedyN47UyLdo0GRiD0c1mp29+TUTPGcv3zorfKw1DXPxx+e7g3kTjrxAzhLovrSozldBENHGRr/vqcYq9s6+4rAze8XNhTjN0/NdVfhIIXbkWOr0r/txWLyF0eOhu1vA/pBJLsRBzzcN8VCDeijRIyIKsre/HCkirkO8OhcU9T4I6bArVTUJz57R1o7aABNRrhkGaezVYetJrGGkEoKr1sZFAJggzRcJboYqI7lXg0a2eHxXRFPCVzgEZd1afqLlH/CRA0d3RYbSITaiDrdDlogO+cIPoNiWSo20cp8D/qU94CvMeOV1o9KLVEiLjZYUQOZuVtmLWqFc1NJEG9knp5ozzz/uqKaW/bnM7q2TYvt7hGIofZlgpxyHomIz+72gOVWV2x/c1CzosrMKer+zCppVbH7OOZOfw4Y8WzXSJj1swvr+McLarR6pd8dO1PdOMvlY8GdXMzldedh2H/XoqUpo0RJDaN968mdZ/tC5abjJuak3em4K0wwPDJ+b/tMN1ZMsOb/RA9Pw38ju5/03HO/c6vNIZc3m4KHcRGpNuIjUGrqHBKHvC/RCUOtqfjvRHaRP8bGgN/ES0ieRQqGeG7prSB+uXkPavM6T99bUf8FzIZZ/5H02HZ14xQl1ZR969fgNp4/oQeIzxm0J+32QSeUVSkYBmoY60tW5DoYhD8wXFFQMDT+86f6bY9O9VZnueDkOH/VbD5+PUrwYnt4tO72fWTXm8a2AqAgNkMQHQe6XfFa/OggPkVNTaL/F94MhC5zBuCX+YBMd2yBTCz5+9gcKQcvKqQ0NaQ0k7p+Qa0CYL6HejXRWrnx+W+eVOlHbBWTXbPJkadXyg+xjKJ80Kfs4XlQfbm7EFnTN+Fgy9zgrV4IK2MLtlEZz8VLEasiwjosncO7ZFVMs3P7I+rnbPbyYumu/bjEdiwUYDdo8bvJiKiupKFthbfy90RV1c43Xe0+g8Yp109X+A+V9lqSwaj4b+376ya+/K78+Kc0R3P1h8jAITtcOwwFIljHZn4IGM+TSvzrRvYQ/+rbfS0AlD/VewrHhewl/PHYv4UCGHejEOwhHaw/zDsLnJt1BQFXYbX7H3EX4w83vIvzbqXb9yXeoatefHlfD5hO6ML5bbRx4m6t3nRmcWL3raKfU76qJ3r2adqkjzup3ffqR0+/C9aX+0QzLz2Gj4/W1+0d0vDhxSMmLQ9mfnVjJ666HoeT1sHiAT34rspRPfVeW8kjJUn7R9yvXdmiSvTctCdzA2CLTpZokZP9b1VQhejnaQS/gvEltJ94p75gk2afwFW4jgU+5i+MrHmTZbdqxTsWAeZ9EzuiVKiBrhhH5+sWDis3kSG/K5IGthCK9VjMwtUWSwLWh62sUrbuP1y5AtOcW09xz1xGru3NfGYqvjTIU+aRYnZlGt5rRO0OmatwzZRqx3XJ1n+ZcUWAC3q1A68rLZ/WFSAxewkGV0DS8enj9K/t6IMTrPeY1/SUvUIc/Dp5+33NmWNRKochyxoD6nL3rFoCfe7UFYLAxKZ+CvoiNExpWqYfcpQLO0Fwl6n9EZglGYs19fjh9FPe5bJOOVyVC66+wOumDnrFEH8iFErNxqnRSL8JYoiO1D/Wa07Gaoj8adYg1iyJt5VBcXP3Iyfkwdb0J1lw/DPeSR4rGWvZ5gVmTQgLptxGwygWlQxhdoDr72gJs6oxqToaktMyKkGTryqZu1M+KAi895Me6WG1y1a4v00C3AphiSq/7UZ/Lyz4hkoTwguDy8hYxdOMnWM6rmsurV+LViiIOV8SiGAUqm2fME/M80PTDwqn30+CowQJK+VcNMaBugZl8qleumVFcubcS64IQr3FTAYdhbzXD99ne8PAgkvSTKkQO+N8iSAKAJBKQ1DcHSf1bBwnaeiKY/LwfOZicLETSfjYEkfRhQiQ0EAkBkTogoiJqAxEYNrQACfvNTQESAyDhMEDCyt0sbAa5kWIxBdwVAJOeCDDfmEQVjzI8ShIjzfcBa3dTE9zgkeyvDfcWaWhtAqXDwhHIREXjEmMwbKMIB3jP1oth31u2iobtOF2Oyqoex0BX1yXqSBENKpu+wxw/wJo8cIWMFlfj4tbXMLhKWNfTyz2v2nV/b2X1JW9Nm7tecJjr88b80Oiar32BVMOHero4PfRMT31HGAfiDV4AgRAXGDrPzlqgaVcnrcCk2kd+41b8kPz75MXkgleKn3gD1cEjIFa5w/N9RguqyZ1RH0++QerLJknsxOKPFcq5ChhxxUD7MAupdtzFOBnGompMNEaLWJGKv/dZjqlHG14lHcpN7tqeWPvxTEGMzoz9/C7fiDYKinmaXvClmBfOU5SXha2lCiurd9HKbQEGXCGj7mXs5KQw+1tr9dcXK2p4gokEVJQxMH7FPEnxNMW5JHP8Mdj5E7kkU874877nvVQ3l3SeTwjxUXGG82cNq7VuhMXayy4JwdrLTg2dBQM3EtoNK4VCw3bpY6c+zsIDaZ7ufvBrLHvDJcwBPw90Y/1aH0z1+f4BfuKLg74WfIhbekjDnAduziTM6ciD0pGOJ9L0ifjT/Zuk7Il7oDdrZZxFK7+Nn/jkHf75/CdhjrPxuzj/efyn4ds5fLsvhBp5ff1eK36zPpHugcPd8GGnPL0NPmLdXjbUvWyEsQrM7llvLIXKKlEgY4lbcWLiUZIpRigiEfxnX65uXYNy6xrgVTcv2Lryf9Wta2Bsk064mnRg2m1dw/6hr49Y59PBQyvQ4Oyr5a413GzX+pWHsWv9P+/U2xcns5NdaqENwwLDt78N//7GOhq792JIay7FQWuGojfbzQWV3ZxYevLUvOcSf/4Zef0TPQGSPdzBjPyJwub7O4AteMWaCs1vhM0Gft7Plv3AQw8ZaAb5cKuAT3W3/DK5KxKzgkHUqRIlGO3UnlOi2wSkhdW0emV1rleszFAwtq9TDKzu6ybFGrTVPdyjj3PyCvzN/mlUUPxmz/Mmn70CNlW+RWMBqQmxX5oYe3cl9v4y9piLVeugEvvR8byulVmNXEcf9nnuy14zKtzZWT3g2Tl2wLP/hDekf+S58lmQ3fCab/F+dFWQdONrHoYg6a3/FlLWw68Zl7LqZPg3Oghee83xxKtH1Nb7T100BWdjM7wXacn1wejFKb97fIXQL/drRZTHEFi2xDFSXcvQS4THjn+JEE66jppLhAjfUQmvaRjnElJKCg8arL1Oz88bLth0QWQ4lkB1WGxl5W1+GvuuAEw3n8KD1O7GWXmGbNEKsuA8GG+hfUMbMqyoxTR19gsC0LS5oDizv5ilWQy17JDyOYrsncN5mkaOiDrEf6zeMosMC7D/uV8zL7rMXZrGBcVZmkHCFsrAvOZL1gh2X/rP/pZoViymAT+7wIVF/Mxg1BZW+vxq7iXOI3quTNuCtDmkcVEtILDeS9xAqbZIggsju4G7g7dlPS6ogzLq/bUGqzsDKPzcaoHMep/cvgWaonCl2I47idT38hz6r+hEQUscYIMrW1byHTRNC/sRu5M/OSXYqx3Tkijijk3GhzCjGcLTGYYRPtTqs5jL/qfKxX46VS7wnQb1KeGFFuhUc0EyEndRemtPzMoTyXZilhZwZY8f9spel2aQvAAN3DnJM49LO3plb55ympVssxyGGddFmXn4yWj7KgYB2+RTRAOyK/MY5SUkRUGoIMbo56AkzoLCLN8lz1p+uoJCzNHMYMQpYh4aNc6sPNgUe8mnP/gV78H7PAOMbAWIJ3kS2lVNUqM0M+ATZ/oEaNE84v7/7H1HfBvJc/W3+gQK1OIPLjGDSISaAUEABAhQOa6W0Gbno+9HSk76+eJMZx919JE355xzvDnbe3POOefselXVMz3CUISkfxY3cLoaMz2Y7vc61JtC83MIExoUAsMh1d/1ozaHaeRejR+1BW1kF+NAPxu5t/sqDTRyz0DJmN/97zCaoEntKSqMg4CfQlBMTXmCaArza15z5h6FgGZ8KLsM0OBRXF2swbkQ1xGTM6EKHi4eUZsKujmF2GN+TjwtPKw4q0v2wYw6Ljn/77+3cw6U1lRFuYCZlkp7eXCjEV/Hf/71FSrSDOkZp/l+bKJImutHY6TH8hH+i4tp7Wu/AUC7BizSNP0YdQscyZNvH1Id501oRvPkqQ4IOSPcxHIgZHDNBtxxCngCQuhyFe06WJTe548GCMgdUAFZEdyQEdXQqDUXnHkefcs+bXmTqF2pGQOcfm1psgsMuLiKsXs3/VGgKsON7cDZAXw+ARVwANQIUNMfCQICLkjM4EDBgGRsScBvmy5El/iJLvONr/ANryiYRtrFRwWg5Lc2oqsaQyq/G3SNj/jdoOuyjIluAJWc81cb0U284yC9WHSLy6xYxOit6Aafd4uuYQS8LSVVLKrwKvpkQlRhGd1RlQ/rXxhFdIvKRA8XR/zKYdThrzbkQrp0I9qhm1E76a9iYjC1pcMCiKXJB8gD3SzH2FlY7LvNn/Tt0hJ1o7oEPO5ETS7xyyOmINd9LQqoidJ1+yrpDkZUSdIYrCtIxWMK5DgDWkAA1QUBXJdBVSaP5QLC8Vy2zvrVYjxhNNF4GfeC+niKP3t67oX4jkLWSLZHcu2cJPvvLdu/kxQxkqt/rxjP5U56+4lmXoj3MkVOSE4a0d5JRc6EWXL13xXjkRY5ReZYMy/Es0yRY8JJuNIrsgL0VSjAIUC7AK8hXDDhYg3eeapLNHOdanKsUVOOTfdSe9miHKiKKIcODh3aoeiQgdFe7GNUHOLMIVE2XvB2Gi8okNtEvKBg7a5gbfNhzPTh8YDYBBTjkPMOBYkFhSHCzzcYhn2GYYthOMzCcPh8MNwh4seLGI69qE19fpxW1AUc8fBcV6UooHZUZaA2qCt386HY8CBaTdJjD7ozKuiYFs8NthO02tSwu0dVOd5B5utZII+oiNx7NKMxEm+ksA4P47o7B7gqMirvIAHoO+AWAVwAdSLINwwuQ15QhD8zB/iJB6U6zQTphnsHpXr6He7RG5xrV/+eUWtKrwuR8gBfp6lyaEZ7+UUah7KAn8sokA/4+iqAR7+NcR+HhoN/DfCvGfxTuONYorYc29SRY4e6cuzSDkC+4+hAFAK4EQ4R9XDoUR+HPrXo7iHDdQhyDGkD123QpgsRvIoQwQMc3kcXDKBzCTc4VcQAHfWQBhsIZd0iogNmQgukkNQGI3jBnNhkTtx9fk7Qk5zYjGrMhyZzocScaNMGP/td5QU6h6iQw40Qg/UJ3Ag8boRU0G6bAuNFw+OFa9DQcDAmhbTlK8sSfAu4gelv/bTP/rMv/sG/fMMd0euiuy26uQ1ma+7IRBOIxEUtWpA4JZc7yxkVxgJIQqkJzcaOLpLrvh/dobHSZe4D0R5nYrBWpsiJs8x4kYV1BVOfZVgbdJ+GbgvxqwPddUO3derPifJNIvwsRY8i4LIFq0V9WH3agLVBd2HdZbATwL7A5Qs6cOGFV7FS6DPEBN5R5GG7I9juP9Q1VI8RvcOIHupkw4BJbYZtMRrjiI5V5hA7CK+O6gy/Gg11HoGHjwreXKLqzyUwf/A7bQPj3MA48XFmXbDfguOkO7Wms/4302YzsjG/uGqboZUa1kqh1H644lC8Q4TBt0ORtBysLg1hDamN0tvUwwXcIekFN+kq3f7cmP+4YEQszm7SbSo/lJ9RqXDNc8ArghGv0XVc5Oag4vcuRvrjcZgmn7BK/W6ovUgcu8Rjlzhak/E/GmIWR1do/9FDhoA2e1tmClchOJN6qTvvaH/EDXiDduTEmn4ZFerRXTapADSVSXwIJVtyNfgytHtN1zoV7uVc61OZ14rW/NyP8dyHjYNozEaJuSLGDP4qpAQYOE50NKvbqB3KUYZcjHN4aGY1wIGeYe6GbFyFx8dnGNMwnGOoRmJPPzvCZ1PSsZ+HNVcKrF+FxReo9dOw3Mh44mgu0+EYJ6EBkhvD+j35pfQ1HgPkoc9zbyzt3VCviq5V8GGAD2NzNGCZIniVzJFkzrzF4UwoQEWksQzk/6KxkixdDVlsZEhjXO86qSpDPirw4RxYIAs2zCp34DZQ10A9ac9Xopp6SC4wcdRpIEvshjgIAhnaEArlqBpVAIxkdONbohgK0DcFtua3GMttqquHAsXiFmu6+Gsk/oeAa4UKVrw9mvkUTi0+9e1cMN+OArFKSL2Gl9c5XUQnoffOP+mz7KQDPoqcEmglZT1BVMO6mD0EUV2cUa9GDa1X68sdsR7EbelsELSPy3mL31eFZe18lpUyLGuCXa5lVmFZyWdZ86VjmUPSxxXL2sYywnjRfkAdsRekPKhZ8zKSo2aGeHUjXrgi8WznaGNGHTisJ8SrCfFCFOsRL1ydeLnFvwDxguSkYIl4roCGV0DDCgjcZ951DbuukRI2rkiLUGWZuU3H3Jr8SMg6nOdCUTxS23grZP30xDVZ0M+GCAwI4NXaKZ3x+KXisVAX2DD2njJsng2blVWGzYtRI0O+oZxUEYZJbUedV6mj4ucrYCFvxNpGr5pMZjt8R5nL6Py6ZDJHiUL0AgWZyFPhAWbc0kJl6wqr1OTUVxzi9VPYdfhxqWkebJfbsNqpQgx4BM4Gh9RgQ/z6WuHnDlTyqqKN6xRoNh4Dz8o+a3N2B/L81qamhbRh6AN2FkUxLi0aDA67b8WogRsuPv8LRLTAN3uUQIkUSaghK+CyVnExusKFXKYPRZe0is+r4xkqJCtnXMVOdNv/6ePofvoixa665uX+InQ15BrUB53HX7s3BE1oWThsi5yJP6RvEdF92j1Og/4CCfqjgu5SGG3pa0lUBa9py9vUYNfXChyEDTtr9nrBX91ZXQ8+urisB3/N952qB/+TpwH/kZf+INWDpRToDkcQG1QPtuTFNJmc8EkjCX/wEZGE/2pVSfj3iioJo9ftoHI+bJLw0Zkk7CTho080SfiDPEn46EwSfskl4SOThNNOONYkk/cpkvAHzysJ/9UniiRsrtwTJeFKrqZQxIhhknDlOSXhx88gCT9+IUn4OE8SPn4hSfi78yTh7/6oSsKmBZsyfCYJf1xKwo+fUxJ+/EKS8HGeJHz8QpLwd+dJwt99Jgm/5JLw448PSfjx80rCx3mS8PGZJHwmCb9kkvDah1kSxpKrmm5O8FGShOGezndyw1l9spMbruvUyf3daSmotoyT++jZndy/l94YzZEjCR99hfMtYtHyNa8c6ooFZgDAmbs7ekUiwCvIIjb/n5lfIw7wx3beyDuPPxjZeSv5xOHO8P3gWHSBGuoHB0OiRkY1XvNU46PU/Q3rKe5v++FB57MEypmZ5p4+j3uAmnne73MreL+tdOd0QOmVU0tP3Luu5pNtvqp6qzSLUj1YHl8HcHRoH109uOFo5ii2uo50RrFPEIq1jWKpZAwb8HWS8VEqGcNaloxXYV0IXoTgRa5ifC5fMV6Vdbml57MuruTwDjA25jUoPaFBfr5jpCf4+tT8yAm+Z0Q9I2qqCRs9X95BsbLCoPgCau/astp77gm1d+0ktfdcVu2FnaP2nltWe88lau85lC11uaz2SvZHTO09U3v/Q6N/i/z/q/xzXSVWeflnFr9kg49r/H9W7V1fVnt/+HS195u/L1V4v9FLfwPSqvaiFJMUnNrrkhfTpJ3wbGpvzpfaREeOXy5C4vdc4ldd4qdd4rtd4tglHrvE0flEK64kWnHFtGKWfUMKTSteA04S+bdGlaxWDGZBXKTwgZ7cSE9uCnkxyOODlmnFW4lWLBUIeTBMtjVtgjwiGAeQnurQgxumFdeEWMlnLXxWXdaKj1GqK3Lx7bBEgxUFNt3WVNTgqK1ictTh8pOT9JdM2qBISwvg+8mgrVu2RHVhQ80ptqUoFGHV+pHSQ3QMIt7Wn9zl1JWG/X7k2vMxVxgy5J4htaj6ED0u58oup6HcKrBdTtHzgBmma4X4paEQsxLrqvxnSHY5pY7x6Ih/5qvraeU87vTsnSRSaIJ3ET8nOsCY71xHw/VpS14xilsQxSpUf4DcAZ+yw6emjs10SBaIvUY4nqaIj1QRH4kiPk5rezcRx+s08sXxwBfH27bLKURi6ON8MH0cFSwtgN65KufU0Dqqj9coplBOCzkdsj7eoF0qu11O+4c0RMlwYUAUD/CnmuxyWrO32puyy+lEjpCNUQEqVAaeMl6jQLc5hcKKDWtSZRw0M/F1kvmIpJExHgc2Htf4dM/VZDsbNTLK+DhVxuvYPxLKeAca5HZGGccwOlQx0ygITzG2Od3DV7fHCG1+IqRlsklhqoybNaOqVVagujfX+Z4+UDyhnhO5p94upDghStRvIpfcT/clBSDPo0i810BDGWcL6TsEM/6euZr4hIvgP38pIjjSc9kdFSZKp339aIr0NNk4NS66es/XxFEt6RmoWMBHnntwSCFAEhfgUaZ9b8NU5Exomt0wNXDzHXQjJbfK2HED9BDuNM2LIY3HtibKSOOXqOuNiR2pK0OcSeMhiIi+pQZpvCNzvB+DFg4EISN0GbYCS7sUAtpScXxNBqrL6Zh1Jc29muZeS3Ovp7k3LAm07tAF1r9f0b0o+evddkK6gC8q6DgU3XFC+s9vxHdx5B9kf12F9MiE9F/diO5BSD+WC0eoVP5/wGWOoojPG9Fd9B1vSEmBCel3MGBtQUjf4vFNhJltuheVbLZ9OQroilRbSCU0fi3Z7A8t5u395+bCOITu9Uy3I+YAt9qmAXb52xbMIk2ctXGI1BjTtkdItTFjlNQu5mqSivmr9PkrRNRPV/cwdtVoiBGrUReD1GjRiI2xGmUxemoMUT3WNZfdLDUOpa8qqgBVE2NCLRLywqR4SqEc524XtiaxWqMG5DwUQlMqMrrjfSe07DHQabJMTKFifIA/Cz13Lb7v7fAW0oLk2n267+3w1rC76OVzJ8Dsy1301nuauRYvMsXtkZw0p4VXXFVJjS8NyjuZcqrFHSBzoplr8dwrrgAWs40uxSsOyIqYPUa8EITpg6x9GihZS5i3l2gbmdu0lVXc30gVd8Hmm1Dc3wQ23+IDj/lvc7HvMETbBtGrfJNrBtH2C0L0HQXeOwlEY856SyC6zam3JbXFqTcltZHAtpLA9t0Etu/x1xsLbMdUceCE8a4DJ4z3HDhhxAZOyGe0rUZfjC01SmJsqNGD4UhAHqBLS4AmH9B9GG5Y7sGoijFX3DcM6vsG9T0g4ICqYiyoKcf7yHzfQaFhJIg/hbE1ReJTHSXKCtZ92hNK4HMk5KS5TxAH3SLdp8WJu7ZO8OfpZJlnyNLS+x/Q+xmyyJmfQp8qBMwnywHtLZOlrmTZt6dwZJkrDyb6AEaWiU8WYwleITiFLGPwYuzI0gZZ2vQOMhl3ToG/AwV+Awco8BsgBlbCW0yMnhHjOhd4w4jRe3ZivOYTY0v7a4wRSgxGJINae+wt68V3ATtJxSCB0gZyp5Cg5NDdgOHQXRdjnHbXJdfFl2E4dA/FIGOEB/X+EtTLPtSHPtQFClXXgVPTUF7zUO6aq4rJECnYsp27g+x9fJ67cSvaHdCY00HOxq3v84eCRLmfwmZBLre4jHqjjsHGGLDvGLCXgex96d8NuZnhopAQzxiQA9nj54asabsG2R5w1HObcm84Hf0OVhRtfVWD6B76RgevsezcOsVR+iECdIZEDGuFW5+IcYFUKelfe1gECbTKblSvitF3OBuxUXI4gzE0nHkAqi8BqOUDqCEAWu4Rlwf/dBx1HZn0HtZ82Zrl7OJqNWuLF6vZMVa2YyJkErU18x7doTc+N+Y//s6t/HYTKmkgRUVRge5iwXSXXsdFblKZVcYD5xkpWOK4IGNwRFhk0226ZKo3an4oo/UdqN4jlQFKqnrbTM2aADcyTz+2g0Vtw3FA4g0pQ4SxdjBXIdb91g4FarlGmbBR10ahaKr+/6oYc3j5s42jXboMafGCanK8j0yMAHAOQdRHq4BHbrza089+FZ+BFDKWLUiGuYV+9tP47IAw6KGS0lLciwJ8gVpHsBy1bJ62TGztAiZa+O+lN7YXEMRfEByKYnVcQDKuisN/ajVWE2+CuT2BXy/ES/z+0qFL5kQy5+kyEABEuog0Fnz8Hyo2E29UpSmuUw0oMFw21Tvbo5LjWQ16ja2L+VT4f/RLiQBWtdGoqRIY4UnMs24BVRm/fZONqGlDkS3kzRG8Qw0gOw0ILOiCrql8kdKDJb+9+QlOK93VqVWn57ev6a3SLKKa+u1Dffwn/PZ157dviJ7xKtwk3hzYkeVBPBQxe0glGqVidkTDfOaUM8yp4/uCPaswp+wzp37GnI89c4bGHDaIhg+oZCKYgrtuZGJ8Rq0MmRpGpupqZKoC7lUH9wYA2HBkMhGsilI9MlVXJ1N+6blkioNlOhlCbRxNT2iSl58SLQ7A3BoFy4xr+UpZi9Yt8NRe6Ta+0WhZox4SQaMO4Tyi0kvCvzP+gXK+9PwSD2HBKkPYxaiZIRTJSYGwRqXnki0BUum5j37OTRaxAoRNpHPToUkEQ6qa9NzitEnPqPuy9U41anEqlZ4b4ilumfPX5TZTWJn0HB5Sc0l6FnEM0KMGhU56dpPuoj/ptldtnI7Q97bMN+X4JlblbgkRGM5xQ5Oe/T3zU5T42vMt59q+zaXcYu35pqc9107Qnrup9tzB111dew7ztecudTztOcxqzzPTnmugMM087bnj+9lFb4uDJ7Xnb7vzIRdp/KGvOM+68/9n3fkV0Z1XiDP+q9OV59/y1OZf9NI/nirPUkoaRnxanPGjj2qc8dppccZrXpzx2klxxmt5ccaoAoszhrb6YYoz/gClSpFPjTM26Vh0zI7qmF0ImF7v0LNvTCqZRZEFJ8cWnNxPg5O3oQiZjlHD0+5YQDK6jaEEJCN3pHLZRQnViCzpdNIXD1PuUFdXt00LSe5SMz8kWVTX54tKHjwlKrmdRCWXV45KnlhU8vT0qOTpyVHJkxeJSm7CalIvJyp5D7LVMKu97sHhYfqXYJj5MBKhmXbgw9njCOUZnsKeCAJXVZw4FUQflx8hGuELpHpBuxmxIg/1tWKTCeqTJacamOtei9umgnsljggXBibCxu6CfdRBesH59AKhP0aVJ6KTd3NQlg1BniA9SaKTpzCn+tE+0vsrRyePl6OTm2R1MEHA5VMfdo7bnfR0UGcrVHXqbJXWMZSpbwpxy3xgvpc1awBxdpAXt3wpE7e8d2rc8l4mbhn2s8UtX057/Stp7tU091qaez3NveHFOLdOkmZ/fFVptveENCs9aNS2GGfEh7SjHp/X9qXZii/NbkKaxfARkcSR3ov6iTRboStSaYEqOtXEn4/mSt37S+GzGd1rB7faoB0oXBuqe3G6K6FRSA1E40JqJBoXUh1040jJTC6WyV1MI13UhmJ01KjDSJe7MLpqNKnNxkCNMgwnCayjepak2cDWVuupXjWhpupVVZNmg6w02/C9s7bmyEqzxXj2VGl2jD+7zuV/4LlwA9qlmUqzB0/KQ8ET0mwxI83OnAN+N1PczEmzu15xYZ40W3TS7NiTZi+sIs1WbDnkv2YZg6ox7ShV+5jX9tN4z6dKswtIswtgkxU7KFBvcrFvMURHiTRboWsG0dELQvQtBd5bCUSHnHVfILrBqTcltcmphaQogW2UwPbtBLbv4OdLBLYDihw4YbztwAnjHQdOGEMDJ7XZMAE2FmPT6bQwSI1tGI4EXQ/Q/SVAd31AxwJo06u2KVEl5or7ukF936A+AwLG5j7YpYYcRbF/10Gh7qTZ95zD4P2MNBswgmf50qwRxJdmD2j36dLs08ky98mi7A0giGfIIme+p3rtOJ8sY5otk6WWJ80W86TZC6voXHlkGYAXA0eWEcgyoreQybjLSLPkpFkCMSIuYpOJse2kWUQrGjG2n50Yr/nE2NT+GmOEEoMRSZGQYMQpklQHsJPUECRQ2phY06O+Q3cdhkN3TYxB2l33XRdfhuHQvS5G1xjhQT1egnrZh/q6D3WBQug6cGoYyqseyhOVM5Vmd7Odu4PswQrS7DhHmn3Xl2bHCptdevep0uzsJGkWAdE+ZA+kfwdy/eEiT5rNg+zxc0PWZAeD7DZwtE2byGRsZKTZkUqzXbqHvtHBa2DS7MCk2S6gs05dkWaRjjlrJIDqJ/3rtkmzPSq7UT0UI3Y4a6c6bU2MdcOZB6DaEoCaPoDqAqClHjFv8A9PkmZnK0qzeTVr0qzV7ACz0QF1kckVcoo0i0rakaJ6K0izqwYti1jbRYiyJ9aiLdZTsdZitvq6nLW5mzXKEy7vmsVjpWJtIyuaV3yXd9M104SNGprJE2vDJZe3NZd28jLIxbvm+j5AJsYEC8lCO/kub1zlhWRNdHTbJRn4MD5ZSBZGFnN5p6W4kCy+QK2jC8/u8k5unIZkFRGgIU7dY4vO8l3eFpzlvQWeurwtIit4MZd3aC7vBpBaMaQ2qKIRT32KP7qRx61PyMjjEvwq3qzYkeVBvC5i7TreQE3F2h6t5zOnnGFOzcSixirMKfvMqZ0x52PPnHVjDhtdWn9A/Y96QHHrkzeg+KJ71X8dX2nd+EbtZbF2nbpJQHG39JLw74x/oJwv1r7EQ1hl9R/PSAnVTeOEuyrW9m1RkMoxMfo5N1nEmhA2dXW2um6awroXJ7z+8RsnHMOwVY8v1qZxwsD5yWKtoWR1sfbEQOH/Y+8qwOM4kvUO7OzsrqQdGTdWnNTMBSQnAqPkgK2VUWQ8BR4zrI4ZJEvHPmYmR/7ehY8hzDlmZmbmC3+v/q7unVmtrMiywutk1TPVPd3V1dXV/9T0TA3ED2vbF+RF4QFqn8+Lwu1VfveZXxQOIXOr9PEf/aGHjWwwiVjVnI2w0RI3PT9sWRKt3VbR2kOXu4L4327wAhUP2imdVA75lBPEWEftqoQVvFDlW8iwJCOfP0PHftcRm1ElIlcjID7XaZf+oRzZ+kKbLHUNhINw7q+3UkeI8+9LKP+g2w4QHB2JhYTLI0w/yVlRSoGuY0DrCNUqHHODHBGKq3JFXGFLNTaq8SVpkIQkr5j/hyMGFy8ifjyXdpPxwhuY6Etg6Te9RBMrQcFf9NLqoOBaXDpINv7YEinbDg6iqGRIrpJoHD07X0pI2lWSxr09Vz5WRnkJdB+8BQOeJxuvzMYCB0tu/k7bshNdy+iuqfahAAhTHbwsEce7UR+4kY/afVO71Z5Kh8wbnsynuYiPBx3gJ3gfvlxdna9ywcY8GsIjskI5cdHLtQrCe0ap4BU4lSfTPqXlTpjZIB/K6GHW8Z/WUUqVMS/AqRT2RE95ELv60R6KuaD5EKWLxI08jLYnAbwtXBeUJniwAzhtgl+BQfJCnwGMKh76nFJaCRxqyj3PUyYe+ZdalmOETwm9km47UBmJxA7SBrsoerSEE1vpWKD4dwjPpzmxjOKLQjtwWljgBcoWvFT0jrsaWmb4OYcMM+99IOKuv3KmuOte3+zh193RyBsNHWbNUwrOlXmJ8OvubOHXPbJ1iHUVwx4KhHIqcVWCvOBVs4Zff7WEX3+LhemHIVAKlBEd9M0szHDLMO7MIapxcZTGkcd/gtehDrAv6sdJJni9zHddnTJeOM2oU/CX2dboUAYEyJ8phbw64bZ9Pa0hOz7Yzxar9P2U2PcoU7rsdg6xj+oyKOAqLTwyc28EIyrev2o2JaH9e7lOwuYbGP43qJGzCJVWDBAKKx1VvZBLoT6KWT//n6qCGc17SuSoZqsLnZU1gxt6jWoIMw5ElywsqRg6nNg4iSyuvNJgvku1ojgKXpswKJGl7CqOG2IbyhcUUqXbnsPiCe55jhrXSK2XotvJBRMti0CrDK9/lIZXVrpnYYBYH8EchG/9m8wiX62ioAXkaBqR2y9HJ4U8Y9V6ni6FTMMJVmJ28fIjAk6dx0UeAx7igWTCaEvEw9qPdmFCtoceo4L8/xjmHbXaC/50cezimOdjZYKwuEFgOo4dMXy2mmcwfJjqInZLZlXVcOd3oI+BiAy4AQVdlDctoQIcaWvHTInkQNIazjgs/6PmzGLeaWbzz5nwn+1rMxV5YYa7OemqHWZ+ZelyNjqBFjMnlsJemJnZClYKvoQ1KXQoBYRWLo09EZad5NoiC9VOSth2MLIiYRsSdiFhm1yRsK0lLE2exG2xx9wj+zH4+sXXVEM5Jq4rq6EM/gYlC7k0Y3xNuuu5IKH7OFVGge90eaMa0pTsVwAgL/Av0CsqyvTw9RQEb9ezNY/5GwCIi51s3mCj1J+dMlajs6JF2MPi6dYWa/PJVdr8A+JzyQveoepy5Dsjdhny4BQric19UlbfFT32Sz/niptp0WN0J5cw6dtMWlRKm34vZdLnQdLny/j8lsT5csx63AxW0LQsWM3MKe4SrwiPS+RgAzj/WvD0AOy1oD/4vpWoKN5ZLLmA2350PNhmEjzz1pOilQLD0TE80cKEmwq+qlg4npabrpJziDOPmzocORK9prkSCGAF+o921MeWXFqp0L6N57u6ai2bKw6j5ZWUxurIkxBLSn/LaJg2QmwmLT+LmwstWkFFbEbR79MtQh5ZutOHzppSa7XiHAMFfbDLerAKzHTiloScKdVpNOOSjfrsysPEReiJiltyguovHDhIWmgZkhMhWrXbfYXIlPk9kThZWToQeqZVapGpwM6SHFpS25NW4hi7i4jo7obnffwTj+365x9vNilnGHPfs8Wk2PIUVsg3mxRkArmX74Fuv96ksvmJVM6/rPjXD37+WpPGOU9+gtPxkuMOX21SyYkiihRnpq3vX29SzZdYA5Oqyog4j/Q/1P3lnoPX/eKOi641qbr0lvd98Np3/DbcZFK+VNEv3/e2yd0HXnOdSQ39VUs/ddwh645NJjX0p++9cdljbjznepMa+tAI/v3fZpOCLn1iZz9FNUyOfeVzf3fGN35ytklVJb9622kv+elP/u46k5rKx+9537k/WvmxTSY19K/8643M3KrrTWro77otaG5ufs5mkxp6v2Lu1utNGjMZEY+vpSeuSaOT7t5Vu/bz6HzVik6+e190ygyZp9Ip2CsX0kl3f5ZbtDXdTlRJqODufToQB+ZkWStoxH4OVBzRqRTpamrLlwJMSxeJSx4+euyVmmDQqUUZ3hZagbm0QuZmXsyCnkytlFM2Vy3NEke2TRmMcJXMr9NK4mtrd3oRG6GU5RIdtIra1T7PzpKFqQffpVh67DK2eW+umbGIMsIbUUOPOkk5FCoGkC0GxyJQpBPkWuUFXQkroT4FZ8smWdKENBMiV89ZwvKkvjad2HgIQUS28R2shFOEhaIWh5XUGDIcAN1TMvGq7FWeOqiIzkd2ZcECHidbfWWwSZ/CSUsnol7UyeYF9Z3O9bDTsB2OtXZq7tciXl65D/axqH7cIZsrDg5hhUf+sur8L0/PX1qd//3p+Uuq839dlc+0xRtsPST6tr5BjTPkTRYMMk4s/AZb4Bma0nZ4Se+UWmuvOCSE3v/sPaTMcgH6VaAAYlPqQoIZKjfc+aX8J4bpqeCbipcTZqIC2At6BdatuWcjCzfITCkHb5Wb4fiWs2zZM3sy0FfttUi6MtaVK46L20CUm51WhXAF9J1OTiy6pF+DCyQ4fY/jWBPeGENzCyuUQxaEyMsUflqIobv1bU9NHTzrx90HwvTWt7wZ/y7eDIzs9Ep5L3iF3NBMRf7Wz3wa//zef8c2Si+4FDlhlhzyZW0PXvtyUHzcMR2qYD/y3hK8ERkXbH3u0/r/56aTzzp76rAUJZeyPH4XHCLvsLl3/fcWVn1PM/OHzVORp2u6bfO/a9SXvsthBAkNtiGck6Ic2ZTrZ2So0PIVCRedP8cOTkWZ6u755E2Ra3o5xZ3MJDt5genfll5mnrxDR8V/vEmbe6JQN+vjqA28TRYevNhcSv0eFzHkjVKjhtIf2S1XaLflcaz71hWHQxegjjMdnurqpiJ4M1hUt3V88ko54UNy38KF7P6W+d0YTh3tjeGZlRtDP7L0Peto6RlPHOVS98E94hk1zjnchszuBtVeuZctpGMIjfKxFbyr4gEqdSU9Qxfei2fobzZzg/pUoyInFpz91MHGlCG7UZrgl2HqsKLyqdxdethM5PCaoUCrZT7n5+LpiSvGwCIHt8iOWmCYh9gVndZY16r+CmDyavE7a02GSyRxuStO+ZpWpZaay11czgfBe7XbwFEDLFKMOz8K79dTucMO8U87t+Adv0ucW8E7Xqz9tm7oVpiZufszchB85kVKm15k2Ry98QDZWKpD1pk2J8BFM02UpAfc7XYCThwAnGkubwcubzlq7bZbJfck3LYmPN5OUZJWIZ6U/5xl+XP0DXY91vgGv3rJV1Zhalwk3jLtIpT7ILbIsa8Q1zjQEvjh+McS/Qpfy9K/5CuXLFXOwkxwcZWnUHQZ4mdV1o6+4BKjx26I00sTPjy7yodXO53nZYAuqzFAXY+JDRBOphmgUZ5HMh3VHDLTmSxOYBJGS3seqy5zgstRt5nkKbh2fbjtmCB+OUd1iFz9UAPNqMSVpNoL9u65eMH0UyKMWrVB67r3p0QyGhiLkE85mfaU6D3IR1VH8ZRoD8zje2Z8StSnGcFaCxAnfW6txnjILiayj09m51ejiqRE9CBZpgy4gX/KeFRnMeez8CvmfMORGks+z6ltsYTLzCpjYVA+aKYSmoYKfhgE8btqJRfY5mIl9GvU/AY3z5b8gDVh8Q+pw7/0AfPKZulVFjvu9WLjoL6GklsyFh9vqtmoOUq3OanII07Ytb63JfTJhYtanWcvhO8m1/dEyoyHeU688bBByQyq20i4NmxCEoQFJMUwwAZqJUWv2zlocZrvdiaRNnQ7zwDU6XaeIMn/CPFfpMx5cskeOdspeb1SskfyuoTYKkVIiEUpwqtkH7Q2YDeWvN7VBqQ+Fi0ajxZzDv9G+FVNaiImLOkLiH/7W6Il5zem1HWfT5VJrgnGoqXj0TKmLsM1lCV1GvApX8HlqZGWMpWfao8dGIOEynplyvEBN2SNcTtL9kNp9P5dceiLyxUddNTC/milMfAHLWfKxRgorPuO4gYLP4ymUP2Y6hKAwnLpqoNnlVdCb9So4Q9fxUcY2tLkB/EaqB6u4CqZ16wX2nAmcY9VbSZcg3tOScW1pFC5rg31YyoGt750TsU+qoq9/utW84kczDg3YcMB/Oy00l6Xgxpnn+3xuT1uH0hPVL1yfENn7SvHL/vg8yuvHGN6TeJc3iOWLDX3DuIwL1O1Rz4VPLmqHPqc3sBpFudt8RvGlnnD2HzXWmc2xplNklmIM4M4s1kyF8WZi+PMJZK5NM5cFmcul8xinHlcnLlCMlvizOPjzJWSeQK6dJq4lk/EcbscE47b5DjUZeBciHQZHD+KAcmSkBEDPpx7Mt/ihaeo8ccLY/J6EF6Hg4RZpM9HIquNGuVTy0hPj9qolb2KvNatYqtB/EfJJVsOrpbFqlJFdBoOVTXR6bC60Bc1QGQ9RilLK/6G7ab+sEO/0rRKPcuAZeosPaXc5NhWysqDWgzbkJyuNmN34naewi5KY1qtRsakHa5B+nw7XDvj3ux12LzVRhnCwSFz8CpzMNlGKWMQlYmL1vdNvGAs2oCTFP4EUbei9NAG6tnfwjnrqRs/Pl5PfLa/JdxIa+FjOoM6+KK+wlh4Jq0x95LH33CIh+As6oq3jKw+fJhJZ1NnfD8GwibjIWYHFG6yL6iqYXOfArhhT18q3GCeLGjxnQY2118Y9WIirO8DyC08L+wGPXVl1LV1ze/uevMzn/vNzVNcTwlUP1xPXXzSR13UBeoW/ZHMDG3hvrVdPnbl3UuqpandrtE6WldxRU1m41e6s2pXWgd18Ni8E36U5Esyop7UBtvdwVTaTGfjhQquQSqLts4QZ28bZ9T6pKPtKL9DXoRWKxskg38/vmZirNvxhZqqpqZkVlBHmbbSjlqXdrQTjf2BGaGtOKpxOUf9xv22jkpckPpYEA1GsibVomk4dNOv7hnc+cGNJgXxT8w17eASIXf281fduOT2y9662aThOmynkhiI8CEpnyBthbDBVrjOyPNN4vU7kZQcz6JNtEMKNYgufWOzSWMn7zqCKGm7CBp9mFlEM4uTILR1zIsWEVQA1VUE0gZXbBv1KlfsBj3WvVg6+V6Rm5F5MtIScl6bc8NpfN5D/OOZ06NmdzSg3jxei5OT1BqTigYVaYgVbLiiYMMqxusaPZTD0KZd4jzdSoNhh9bhIdGzTuU2ZblOpiFYLUvqoLTKYOaVUCdld0RBIlFQJ3dVdaoDtreDq2rCy9XoIj6PrArxNeCCyDSOhmkg7EAA5vu48WFAjmHq1bMKnAxw87u5DZH7bsFHgHAdrCVylIZkD9pcidjKTspUPprRhjfPlUec0vgbDmpp71bS3sW1Dzm9GAe94GjPNw2qiNO71DhAEJPoE4owszokdVpJ5AwaYj7YOd6pSW3aVCgX9zrq1FKp/vhBvDUVEbslSAiGeA1lQ+YZ/V+r+r9WC6XUhMLM0BAYkvYT/HRyw2sorZnF2GjbVc0MeMPhrMx0GmY6Y2aG5DX8IQwW9zfeXDrANdJJuh1UrW0odWCNThD0hEWT1XtLB1AwHKDd6OduPfhn0sZzG9mRgDfoRSPVKHUIloDEMBtkPcdCgD8+rR+jjuAaXrjBO6sWW+uIw60g6aLV1PUfLdRFnS3GgEP7kHAf0XZHJWILGFpD6wGHeS3cJ+9czj75xa7g30TYA/ZHGi3IqE34xwAJ79SGy6M1EE3I6sFM9AIqENY3LsQzB1kId8SH8kSF+Ztg/hQsX6NnUSdmUSfX5k2bRXlAaRaINIwTt/kgECiYYzrvFYz4zW3V1XZ+SB12xetcG9Y55RA/HLG8iKXGjtsuSCsxYu3UtZGlveHCiOdwmXoujDqGG21apfaGdshdBWbeKOeGHWgkFXZxA/K5hbjiqEuPRNxFLep0eyoI19i93MscN6nmB4vn4QGalhwzaFoyO2iqg6Y6aKqDpjpoqoOm3AMMmvw6aKqd/HXQlJsVNOXmB5rs3ocXTArqMKkOk+owqQ6T6jDpvoZJfh0m1WHSIwYm4T/u4rOO5lHc6zRcetOR4NIOA452LCg48mYFR2fXgqNN08HR5pnBka5hzwKBo74kONpiwNFZFXB01v0CjvbQpnsHR9tnBkc7UX7bsYCjbTOAo/57A0elGBz1ARxtmQc42kbbFhYcnc0wc9scwBFESTuPERz1V4Oj0kKAI1agXaI+Mm1550UzVp4BR1R7ACqdwEwdAqP0aO6CQg0lIMoxwRNZSWsgSq1xFURnWCFaOA7CubQuC34aKyEWfGgC5+iNolySylKtpsS21cXyZj7zl5Aqt/99Sy3p6i3CYT2fd7FRmybrQVSKXRzoa1pDjiH5Xkcb2B2mNu6dHWMP9Pqnptc2Pg2qek1l1Sg6DXnpThvU4aredRoIRBo4n17DKNEDwFEMDnYBMewStMLZgxWIOnhEiPo2QFRZnzr1ItSlU9JpoNMKcPUUcMVgDOihGcTZjMBVEO9ABbjajAWzNh0TbrVT04NxAwXMhFv9Cm7lAjPiVnsW3Cq83jtunY2ZBG71Y9zqTcOtChZBjOmYHb7KCtuEFQ4uiNZj6AqF4RPSJyaANcYIDTIOUwrSRieEPGRoYRA9H1xQJLuKp+peSiPZR3tp3z+10D5GsvE2dwCHGZAsLQyQ1cwaMGsmW5uA2JkB7K/M5KrGr23Vswv9W8kljufKpYCTRK/OUaNXfL6nFr660BWqQa++Qa/OTOjVnwd6dYFe5UsSa9QoPBSRa2qhkCsQq0GvdeRaR6515FpHrnXkWkeuDwnk6j5ikGuxjlznh1yXc4llDy/k2p5a9EgFrX4dtNZBax201kFrHbTWQWsdtM4LtLr3G2hdWget8wOtS/Aa+QMCWr1ZQas3X9DKgvcexJ7W/dNB66OrQCtM6nTUCloVbAVlNtyKbADXHg1cNxrgCjBrgGu3Bq7Q+w9G+7Z8ZvGXN72OL6wg1X18soU1fR+oQKqdorphRwWxdl4+9sG7FxvBTQK19fL/CFwRz9gZEWubmlav1nNoOmLtxDKyppzEq6gKMKo2QNt2zgC5dzD5i3aiPPCqwaBrKhi091PJn4Q+/IlgUFSFniR/UUnbPd2JDt0BfHOA5fuuZ5c3TO8GwOpPNFiFYJM/LZWGf+mbakz+QPyZgNWfKrD6h98/4ezkjw306Rqsfv8OgFVYbVlXwX+4zvDw6ZRiIkKXNVRFkYZvFT6xKfkTcyqDBSkSZKah6qNwMeCnlg7GE0UqsrhhDsL4vDCiMVUniJ0asGbW2TecFm7IU48xiFiHSmPldWxmzxwJd9NG2rA/HNH3WkpVu+N7rAQsWathyVAttBrWWVixByrqN1DyEnsrB6Brg5AloKRVWZKHE2Bm1zzAzJrZ4ZUsDyxm3XQSR61NND208E0PYJkamBE+2TF8iurw6ZEDnxbNCJ8eTfsfZPAJLN33mKiZSwQVTAQgtpvvmWGQiFHaxvsLJfVolLRxwVGSnsprNAhai7QIJVM1CVBaHUOntNp+6TBvc0dJnVCFzgRKwglLea4oaY2gpDaE+O+lVWpi7k6AprUGNN12vQZN6WkAaROtjmFU1+HpoGkoCZpScwdNIw9+0LS5DpqOFTRtepCBppGZQdNINWg6R0DTuRo0jVSDJh6JtRV1WiuLCLO8thJkK9ynR13O9pasiruLea5Akt0VSAJzTmk2nFFnC3xBc4Aok9MhCmOTDlwn689arAFraURjk/Mq2OS8+wibmFdAzmN5ROcDnVjhwBERyuA0hBIcEaHwwv2k+x6hOA8oQhkAjasPh4CvkxDl/AXGJwWDT85Dv8+jkYc2PhlR+GRkvvikiUs0VuGTcww+Off+xifurPjEnRc+gXRdrP73F9qYA8z4fR1m1GFGHWbUYcaxuUCSMGOwAjPS1TCD84blbUr9KHAXpecGOFBqgTGH0IcNfRi0Bw5yDCYhx+B9CTka6pAjMQB5LpF7sEEOe6Egh5N/SL5T6td35tc3OdU3OdU3OdU3OT1iNznVn9J5j5id+S31TU7zQ68ruMRxD+zOfGuhdubb+YdJKILiMX8urjj75+Lqn4urfy6u/rm4+ufi6p+La3iAPxeXq38urnby1z8X12DAUWomcNRw1OAI/J+iQs6fQq0YlVYV7qlfZXg6ENmV2TRC2XkT3gHXhP9yVWTQyWYV/ksXVAHsLIxTBokf+XujbAsip6LNHCeTN7J8MU4NZIeNDvBGQ9SEdhskgKqn4slx4nc7JEmRPA5t549HBYSYw3FmPAoQZ84jTgJOOMeX5LZAqL8P5OKfB1Ll9zX967r45zX940EfN1q6IShTA4ydCzWjFGOgsaiZm+TcggpNVwAxRUwL+gLiH0O2QKLTeVS5qlgd0A4kP1pcFdOOryEH0emomQqVCHUuLcZBuFSFLl0KQgHzoUDBfh2nOysfPuZJGvQVwmbKhVnKh8sgROan6RyuN8uXNYcFWmbq4fHHmLuQP5+qqbGUa57gmvdsQ8Vc7UEmZqmZiVzrMnW6jAJuHV3dpwrZ1FTKM5vLqak9dc2djCkk9DBOL8NpCfaMlpPLTJIXXCtBKAEORSPCDHnhcoT0RInIBbj0UL4lXM7qsIxzi9QYZtns3MZ1UxE9QBw/lq10grn3wbyL8LX8R02NoupRkbIqzTL3v7f6Q5fTAJ1wRY0poxXD14rgiyKAfkMQqxe0xuiXVp1AqwpnflynV2j6e3VNF+maDmn6m3S5V2n6QV1uUsVARFR3Vramo1U2qA20SStrtcbFxZTugcBJoOpaci7rTIEK42HAOrdkPPRZ1WjJhZE7CoVDDG8XzCyDHHk4PyjD+UQMgLSo9JQWjYUZHrCACrS05UIs7loFfKUkCPOoVJlcHYMeg53FOBcrObSsTFnk5SmAugWi5HF3M9yPDPoBpa/Wnzw1QnJhI+VUmqO8SvMkgTMzpKxN5CrkmNam6zMuQqFXohbyI9zRSOcx62iAb7Eij7wD2nCZ0zGymQe1pGcOMMU5v9GiNBjtingwe+W4J8rCXKnj1igHo6SOKcrDWCEqePZ8/pM794lnpE5V5z7O8zg/hWzy+H4w8seC69QqmpMuc2tkaBGPOHjK8lX84xHOkk9ZhrtZ8igH8fnQL14Ufb1+NXDaxYLihCP0sXUNC8xvAzVIKFFdnDF630ToyRzW8zdLjVKG6+YWPJY5eQDzBShEwBX2SPWtUv0pqD6FWPssc64pDYl4SFojf4Qr5KPeKIukK8opQt+ECClHPn7gA3JSTaJbLNr8tH5wB5pg5YQ5X/eDRwfyVPdoYJK5Q9fGWSK8ZpQQz1AWu+B6yDFPTehDoboPzHwTFRT8JUvut/dzZoYrYW1vUOYDz/1NSM5vW44Ec9XqNGmNRi5ZCJ3qko1gqSo5j0CECeZpaI9HaQRVxbE1HnmIrOqqWKqccM5OSXqE2CU1tEoNJMSiFAmE6EsR7N/I2NwGhEUO5rCTsAqM5iAiC6c+rIdLleygOju1H9Mrk/+CbWUnasLToh23VFCYxQ49tArLQBm1cPl8zjZE2d8cpcM852FsEXOecb/VAkuBPRS5kiuTdgJzNos1P1tyxVXLBCf0+Uo/zPJZjo90nZTDPQfl0ZZeB7JYB7KqviinXQI+XFrcKGrNV2rNkRdmpS7KcQbfFwQcpztgAo5TfJzSSwfqI9QnwBxWmtll+42YYFlO+IwnILJstGWzWoxJdHQUMDHGUaAqhus6yzrAY8SrNrDCBCKeX/XOuzwVE986QKmRy8dxjGkshHMvH8u/aiFD0jtQbOAkHFV67TAsDZ1KWPob4rD0Tp44e1pY+mttKzPHoOTFSlDySzmyeAos6GjkcRDyog5CnsEMVkHIL0FZclQwchWF3MbMvbEqEHnMPHm6S2l0RAUlT4OHmBEVH/9/HlsqPoa7yXx6WIgczCZZfmwjP8Qs1UHN0Uxmg66B+bUl8ndaRf7mxEM5lbgqQV5wUyLyeaY68nkhH9z80vmHPL+lJuR5MRnyvFgT8ry3EobchzLhgMXAlz2BrFEIafaw5LWR2iUAsYxjdQDioolT/lxLheqGyAJBdaxGsDKwpuN97gtx5o/h1B8XqGv2naVCm48sWBWopnISY37ballXkbW5h+IglvDf/8/edUDHbRxtLIADcAQpQjEp06b+/y3wUuj6M12WC4mEduj03rtL9CiluNvPqnGj40anR3E5gilyeg+dJvq9FHcrcS/v/+lup/corv98M7sHkHeS3NIlW7eL2T6zMzs7M4CwQTTRU9d4g2nm8zg+4Qmbg4iY6hQiTGHGmTMHem6dxHeV663xVloUg5Uyz0zpAMMD6JHxT8NgeBviSJutzEKkezQSKjr5GrQlLhf5h4tVWJCw5jqd7etAfSlwdivmrqBxvva4onZWTBeNrIYVerAJeHbyrxEEOvvzNvSsRZgOXl/w6lsVAQ8R2MOPkcVawVbJJSxAKA+keNLrTV2Ru0atpKvjSv5X0I9v/tvnDW/ev30+7lFK2/h0pNTpgFaiIGM9tSZy3pEFS51TUAd2ozFw64zCE9YXYTs7MEnhd61L6u3R+GeLPZw/P6RqcFLCuxDls85YPs1Kqvae5+BA9qj4HgcHldTTXnLRuDGKa283b1lW51msPXHP/BBCk52mzLC+lzdBPUCDGblx1U1/2vT7Hyw9iPJnuwO773qa3v/gww/HrSda6mxU8Dv0ZXUqtdbgBuXWKvrLRnvPcd63n476s45ikgeVP4d00Qqo0fpP4M+NQ4Wu6wpi+kHWrxhcPFlkgC/nRbwii4AHF3j4gpKF6viL2v+iIM5HC8Z3zAoCPQ9qziY3ngq11Ee3u0H9gGZLiuRq5AY4t/I75xdY/9ulrxi41fFu3uuTU04UldbTc8gUbpNMFxP6wzk00qRZmJVfOFQUQqLkJkxuCgt/vfzD47/9ZvMfHp8w/9D4Dzk40AGR7+HStlLYu0HKcrVUOomlw+lv2Q6li3E8t+si66JONttOnuM2pKK1Um0eomuhgDTVdD+FvAw3bbJ0jk8gC1mvQFvtyiKSS8FauUOxVHicZsemgj1AdgP+EE5QYYIr0MbJFozwnrniivwgbNYFzd2WDBdAZtHQ0XRhYE8eLg5KVaw9TfN5Xc7L0L5Q3G1usr7hIifQLEoL0D/Cj7P6QlO+z3DRGNnj+Yt/cdtzdh7iqhPXrRsn+pQbXZfZg/ub8IlhXWYP6n/AzRQUmtF+TWnuvLA/ueVUERTE/K/VHrD2Gkoc/sf6qygeFW4elmSJJIPy7/rfoyilJncg9fJTPNptf5T8Esr+VrKDlP2lZL+gKD8r+RlIhlsk/xXAb5D8xYBfI/lrkd8k+euRv1zyExjpYslvVNjjkt+EOjMiDtK6TK6TS8bRYnfOzqLSQDnWk5uz1M2pLy6n2MfZG5Dt4ezp6Copx4vKqfqcvU5kXr0p9S7ji2gdvElTGCCJnLF5gAqJyx3ABzVq7kZXOkAgH/cgoSzHg8jusQrJp6hOLJU2KqkU7W9r+ubMAgIGSDiluHFjOg60gYLjZRyo1tQIBstIvNF0gDR1rDxKzliHOTuCbF1PboPkoacTTyNlRqDJetQR2YeSU6DmfJJhBprcKjUIB2eK+pMn0rPuSK49cV7ZlUr5zUugt9xaQHUw52QKtngyHUUiL6s3hV7Q9mwKIDmRUAd9WZgDMSEeFh/QL019HaCVg91hW9WkNzQjMQzFBk1GtTK41n7yXSwCdxyLxnhUKdJd7MGvVXI5a5+exsGDPpIrAOiqYMUzWFFaWaxoL77J93HoK9KFyhuMklGMasSKQ66w8Zr7hJV0RxQN2RwRtoVHO0cKOq0GYuSTMtLx15ANGSO2h1og7aO0QGYxZZLfyBGG50T7Sx1M2AXXqHzxWPJblEqXckBpmlty5WlNaPJ7bl8zT3/gJ888/ZGfAlLbIe/kgLFyOHORneUsLhr+i/qtG39guDC5lw430JKPn6xGcrlUCvDYMI+NfYqCAXy6y8qFgco5XyUEOx8qYqMBBVB42OCBwB6O4oMytz8LhW9dw4eDrI/GI+cc5Yzvc8dzVzMxwvN1bZJ0r6M+PDR29/9cqg8Wky0mOZXWhCjPYqJA/azJZbLWnD+fO2YJAqHupoiglsopaGgvmJjbVvUhp79oxF9z6V7MmyF17b6gJfOWEV3Vdt4URhG2mjtKziE5OMwtOiHwnC3DaEo2AYf8bOCa0oPRGHgnMvqAuySxtZrK1MgDF/zuZy9558uHdJk9uH/kUP5zFx3KhOZtzwvTMF2XOk6mqO3cuQ5gbMVEReNSOSg7JHFqR+ofhYrux1+r2hLmad04I2gcXvySVHjIcEpa015bTYkvVzBHUdj4USu0l9wHHuD5oQc09aWjmpxpGMte0pHrGZP7s48OWLL8lNfgldaGK7xAQYbQX7qXWDkyOMdyu5u3SWVBRatRtG780CWnwQhhTKzIQtFz9Nsa7vMO7nLKi1aETS43ntAIPjEYasW6T3Pn61D06fp7so4v4i6ZrLqQL1kw7Or6iuUM7CNgrOOicT704mZjcrt1FpqM1FM6oJ/kAaDLbnW2v8JLF2XxJ5rAd3RVK6A4yTrnFGsMBItu0QCf4ygP+LCE0IcVlLyIkbVJhbiShRWUiHMPtlWzGaI5p2iNiKUDPkTx8OSx/ILTcY4CzseoYEmKzl5XHqQCN+co/WdPhdsC31ujjgcxy/uf0BJ9WQ1ufMZ5Lq5RNTlCSYlWyIPFg63dGT5F1fINOPAqZydEj6heb6dMg0prKE1uPE3mPz7uigUjIzvOiRg0AIwP7tM9enDw+ECMjkLcT6UXuVEACtVys6trbe4CEbHJPVQEDfVYqfk+6gZgTEZRdzTlquK6Vkm5e7qS+i+nREOh5WRYkiWSDFJyEdUZMKmWJq+XFdKvturXcby3Jjxz2xQQCSjJNkjK1HMl2rXcOkau2HvNoec1/jxkz6FhYiw3V7J4ETYyjGwBAcsRrEaWnj5425nH7b+f3HBd7TYhB9kxHXMe76xruO6fA7Se48kxbHouz4sg+Z0Bnw7jMiQ+jHRvzwIkB2chDp6ADBlacjBpUsLmHIe8hFpBTESYjkMMocSAE1OSoGKsQzbreFwL4lZ6sK2JwyutA2mtbGuF1hxaCOaTDsCJgZiQ4OGAkg5qJHfIMujht85YE3prEzpbgd4tUEbsxnWCKno80ROGkIIJFCDf1N+erlQ7Cw4RD4raz9pYZ2b8GE59tsxw6tHf2mq1stUBIKeFuNmsxSChrn0KrKiJw4iSKAtfwWLHxkBm9c+S0SHtYI9qGlMSrEqZj31YkLrQCP4XSpK0G0lfmtDsF+IGB7fHuKI0BntQ2klOFkpCMBMnywT4dqnzemnycnkalbJhqblEygYFOCBVtAD7pIr4Zj1spoUS9ARLSPdcdz558hfM8eVnPRwBILcrLW3It9K7KltE0EVoo+uaHxN6NG7cLvi1EQEA7z/MMhKrpzsoQwOplTROD3v99UIQbKGOQDK5x2KBHlv5X93UknckyOdBKDnSzV0vwSVWoFEJ9TWU0R1lqR6dEMmF2BxMNfxQK8qBtPkM7BGWXMm1XK3q23iqU1bBwW+rojGU7OT60x5RtRu42v+WQSa1eUEm9UcYZOJLkMmM/hvHmEQC/W1kYkwiE2Ni4DeYepsM/OJIYkyif2CMiWtjTNwnPMaEburQPIy20QtLRGuMyQ+daowJHtvGmHQ8ihiT6x5HjMk+80JMZA00eV9CTFaOZfQjISZYEEJMkG49xMTsh1lOsQ8EPhNVQ0yiaoiJ7BjsFAkxMem0gX/F9LTB9NQw8I+behMGPm7qrY1siEn0OENMoicoxAT7bREkF2UyOl13mhNiUt9iiEmdQkyCdiEm2MkZkehBxx0khWlQS15TXpt8QvnE5NnFhi2xCLthJ9OBJuqP6UWPJxIlMpEokTi1kW49EuUCONfLKJTU26Jb3a241bHn2rvVg2271QnuoSXlgOkYLblLygygLYYyW58aoWWCltRbgt460FuH7Q0BJ+yap16pA0Eu9yKTpMbUAz1YB7q7RQd6slUHerzu0Tn03K07FbE6FwRq9Sn6W/QpnvjETUHe+5M5tHMq+v+mTsXPBjXc3kP627z4faVeMZXm5wRjGrbGs+X1E03XvEaA33OCLFye1w/EFMxrLX8dKogBPbuk4Qa2Y74hgNUUHAKjUIwkQnCP0S+BngUgi4mBCthA7CDmwK7Lo4fuLLGPrrVXzdLtaCEoOFkBPGnk3ji9+8GHf0N5b5Jm/kHM3NhgSYh5DQuz82xmeHUTtC6k415WO6AfZjZgE38PJLEqunsP5qm9vbwNAaUy4x7SlbKQNgZNUUajh5AeJj9BXj/Ugw1BEyQCZDoQ1NC6Rap0oH63hkWmm1d5UNbdn9Z4g1KGcIA9GRruxygE68FW7NE7AIZAsC4C47DUEWkWT2rQYgkJRZMkpw5PPeChSTg91XiAFpi7uc+RXLS22tE5ruBH6nDFdOY1sFlsu01EWDDMDlg3Zk069kLoLuRrwjlRNHQnjSxolU2yoZ6FYMmQ0JLWMLGI5huD2t1ICInSFS++C9cXXiEWwFgb+eUrpv/7pF/8lLyoZAH8bS9jpVH6wxq0o729gFGIKuyW9xHyGQ87AFM7GAkCM1mCNXfP37veUSaEWrb5c9wNQhN7dwuIFawe/QHXxR0MunAzxMXFnYhZvY+koqILvqu1wgWgjxIPKqnKHTZjo67mYlRfDJgLg4DWrtTg1rtL/QGu7+4OANcfAMyVGi7XQH9LZOxhO/aojD0sYy+RvkZk7FEuRvURwHjsUelrRFq/Wuq/XMZ+NQBc/+WAuVLD5Rrxz5SKHmGg0axTjTTqRYDK/0m4jQk4krBzEm5l5BEaSehRBIuLDT3qlcijDo48CpPZOWFHyc1i9jDuOIkVSm5loIuB8HhbJQzInRsGFG/u8GsrFUdBlBIZvA+5DXb0K15+R8PFK9btvPtFVYOlRxD3wC7VFCmpV/pPAhEbJKOrlnSaf+0QPo6TD51Bcymt9CLSGromBQVZ50e++YODL/7du35FBvjX8J9vDjV7Ert/5o3suOKiRSsuOnSotNgPr5+ZGtm5oej/Fw41isliUtemGqkXS/HsSXRLkEHg3/jNXvc99Lw976KRvclM+pBKB/cnH0Mlqcr48bXfgG3hIOt6CKaSX/DFMEz4vmu7+zN1R1xKI4frpZf1yemoMEnNPeDloP45E2o3MFVwUQJDMp+KhDhQAVuMaI6bIyYEXcXMkfQjVsyiVM0l7FyCKktQ1UJQ9S9K0I5HS8q6UBGprlsqBq1UDJiKweOnYsiYh5kP3B5rS0SX8EVPaYRqkaZwcNCgDW090EsdrZ2x7dT9Z6KuVjpi+mZxf8bRj5oyTEf1Ipy5zLEpIXG75N0uebfz5nbJ+/em7nbJ2xpK/q7HEgF/e0sE/KxTCYGnp5YY+HdzhAhuyGIxkRBYES24By7PG2veLQ295A70b1+lgGnHjZ6LXnCDpJYS/q84/F+ChiJJfEmceLAZce8nd6KzbUXYlxH1vdWAeizMRtS/nD15GOEA5iOfrYKe9uUeIreQlJ6RIrIIN1Guo5K/oj+tuERJSRzvrVzpUK5Q6BX4hZMQGCGEjGWuaepqxY20w8uN30RRbuJPxM2PhsNlTd4nzdi/zYRASbCLiyIcFSiEgwelgW2AJzYvZV7ex2N821XR436npM0Vr696w2v/ckmY3Dv3incXHrf6NklYfZsktG+ThFt/myRovk0StrxNEqIeJz4SLkt+XrlGBi1vk/xCrrcvVB6I4rJXhqowRcUIKBsd0UTagxEi+d6JsvNAcKIpjO6EnJQmA8/MY3sx5ZeP9sWUKpv8Co2f8BdRhPHLzeQKzspt7xGSyBB+JLOTC9phxnhfylpk/PxIOH3ejL2JzZ4vs65ysB8TtbzSf14pZYebccpgFtUOlTAwcbhDHyXuXojjwOuHHM6LnITzIifhvIoCAntTFxAysvdRBxG2zV6I+IBhcBCbHRSeLCTi5re8ezG6Q2PBfsR2NzvZE9xazYRSeWsE9VpQ78Cbm7qU/rZjjD0SIm184rR7SEYCnDuU5ZAXcKA/Daaj7eynHBpxT29Wx4nNR3ptubgPdQfsXo0CHow01iFZZCN4YhG2JEbETkqKSZgB41w8J0g6dRfG6NLqJSACd5/WYUSLAI+meYzpKZzdIWJ2Uw7AKlJ4RqSNx2CINaTAkhIpeLfy1Eqf0CAvSChttIOZ91u7pUOWSQT1Nc2SzcB3WHXPAipHrrgcf/44VJCFcyyn/1cellzGcVO+ib4oFQFvCvOAXbomAiIQc1EoEsEt9RXxFfhsm+QAkgznrCLqAhBNZlHRIEBUEDxKfid+z1J34aAUEuIOL/TcjsgXah+v1ij6Gx9fiegIqlJWWzOqdyQpW/k9HcbvBHJCyun68qpa1UFSoPKkI6EtT76jYNI22BV1LChKRMakOoWFAtrvmuOddQfIHvEpFhmHlQ65lkgcxDpHXW1fskgX0BRkvuhwjMyyabf0HWKwsPlBlkQrYH4hEkIw+QJ70idpj353wArbdL6Ad+hCnmQWyyd3enSS9lp5Ty52aDyVr8uQZ7NbcIB61HqR7qUSHWMKKO+1yBBUGEN6j+6lep0nXHzJuwffdseQTdFnyweqqJdsUesXpgDeEeBhuEY22lSmpbnk7Tu/4xubvm/TsuSI93l7fmCnqe/aFCXoTfN/9JTxGnrxn0x05bVXvXHpjXfua1Oe6C/O2e0Dd935xh/YlPpg+KqHvvq62//rJ/vZ1MKvfcdFOzXUrhttauGf2ZwsXLhw3ZBNLfxAVqx/tNGmApeZ9lqEzG60KcpaPrNFtbGCecu5Zsn4D+69b8P3bcpNf/jVb3z/vF+n+9nUTuOLrzxn7ctWf/AHNrXwid7LaBn37WdTCz/mFdD6X7vRphb+Yl7Gp4dsWi6nTxN9ldmFNs12evClrXuUKHOdynZ+8JVZf5vCxbofnxKj3lwDsilVf6lG2wdfaTZul15A27CPKI7edtSLifJoq3d68EqlW6ovIK5wwacRvBpVIYB3t3PFQiDQC/hrmR0Sk0fgw4iVDjdSoZP9/VSdMpAOLOB1DYLDgQumsRf9bKnjLupYTpVH1etm6pV+dFAJWlqvXLUmWCmiBlzpVUWcX2ZrEDVKRCOYGGeu25jjVC2zEU8zKnQ4CZeJvNESkeBX0jTCianrjQzHpifDSsyLjwuldrCe+GRoFWW0cyhTbq+fwZXFb31T4iDYK4RqoSkhvXF3SsJ8d9YmkNOU60MO0RHcVokSBM0z+SMfKGEzHjj+QhBYzy3S7b7b7b7bLftue7Hueb7bnsfgu3XS7nlO2965Tlssf2JR5iIdX5QtImnlHtRvXpm4ZKiw+tqztua+7QGyep5Q9+0BxKHfLrWx5PdyE2gFEXB5C7SYSibOQDe5uffn6FXhlvMX680Ug4ZKNgOQsQFCvIxItCJM4tLa9tZU9lfemtDA3JqugjT0VlZuMr7hcB/iZJAShQuLj01N/mAMxy8C+fzhCUp8uchwTi4yyMlFxuGLTA3pbG8aoKR5oVHJJ9isFMoaJnmDu8lZAFZ06Gb2Hf1FgWA37RVFo2ALRHKffNjFr9x1bv8XUfOthh/M0/CZgZP7t67i/9jzPJxhbW6gRoEWcRR4/NRJ29WDDIJsiCA4AHU0A4hV6kKKrEP7PIeiSOPm0Di2hCpF1jmpO8s5FeenER+jfhP2TtoZzWvhJHVY57XRjqH5607+5E+cPIDV0emKiizqyzYNuR3XqV5XkXXQ46A8TsrtF/3hlEOTOuX6cNZzLkHp+kyqRs2qQMMC/hKqJuEEwcuBfCGf0CJhIchZxoqwycyXiejFnS6RuFgG9UuADux9rATzsyuJIWaoZyNUFuBhAR5YgGDLBUwTkSjVi/msUk0azlasCDUw3espIR7TYjN4uVz9RynBe+m9+L2wF18VwCcRXsDWg58gOuFZTUPCIOcuBnB3zm5CdsBwpTLmhQHixoSLb3CsRWIXVyPYmTlyMnNLs/twuS0C4kcQi7nX2CEeLN8PMSv8tkvsGKxx/67syKbAHmHHRNixU9gRpGfmrLcwp2eYs84MKWRX2iuyWK7lHbSdC5oSVEvFbFvITRzbR15atc3X2/bbahpXPRCpV2Xx58hpUFrJjDFNzFlNYxk1cdjUBjMrtXsnrGwIqsnrCK4ntqfIeYBGV+AxPAyRihxu5Yj1V8NSbIIkPfCIop/msw9TCuQLTStf67/gMZsMTzr9UZoMl2/Tji/m2MxLTj79CbTin3L6IzBPLq1Y1H1rUY9Ki/oyGNRPPX2eQR0reyyWzZds0SEwjiHkU070SMlcd4BMAV1VvAFL23sDtj53cQYc4Ug4FyWy6zicSwDMXYC5UsM1NfDUKfV7pFan0AG8iWuLMCtKuUmnJIkkPfELlGo162JmNGceDnLnIeu7sCZdgVQNtj2OkBF0yp3ktNMBfL5gVkzonnE8eBRDp+lnYAy/ffh58tjy/NjDtEucIyR3LGbcOMS/EzfjxK9VqtWZgYXzcinjY77NnM8z4YfkTExGsmdJtpz3R5SLN7Rke7uYquDZ7mSHCJB6gDcp4VECRuQ2IK+8hUvMAJbE/AUgDEJrwCMEqZL6Cng0id8dC8sBhJzZxm9W1pIs33IQajNuVJNfzdfKhGGlS0cQjS5lNcn3T2FK8fXaYaTOp9XZ/0y0+nBJq4/8x9Hq6m3S6mP/TLRaX9Lqk/9xtLqtlVZ/Vspth0tNqFZ8GivIznPLI/DIzOVpYJhj8WadkzQYfVK8rFK8olrMfd7iSJ+lPAZ0U1voPu2AgyWQzkwD1O1q9rTUbFK6PK6BOYNFOdfd5AQsVQqkdI529ViVnckWZcc/slR28DBP2dm73Yf78vcdtvyxf7Nva5f++5RSx7f9ihXsihvOfj9/pwr5j1fy45X85gnkv8g7CXyK8T+Gp53lO1k3SN3qK+6bBITSiyWLvT1TZr9XZqc5+6Utde/OllXv4eyX21X9Shsg63o5IXHmz/RGaqqkE34A2nBtxgMY6FMsyuKHVTsNRCqLInKNmu9KBvTiCvQaI31+qCAjP2OeZipPaPGNskWp0eQb2kLPaQudaAs9sS10szMPSrA7lNlXVc0pcfIfAiV2rvFu2K0i5GQLNz8l4yY/Qg3CiOWfcbfE3iZVsS6BU4DlDWiQYmjZnGKYzlVyARe4Ja28nAYoaeWVtPIMrbRvsXi5ohEuV3ZlgG/YAvycLcAntgA/sT0c+GyF05qbEQPdgYJLdnVETtkOQiBaZLSo/GL2rrv5c1+UX8Rb9XOyQR50nCT1OdXwJOziDKaBlgJiQoI6OniuM0hJjR41pT6lCdMmv/zj3/yaf0B+0wlljxAruTog/8JcGD6slfsH5r86eQ64sz04ydfpFuBi1HVbwIPtwZ086oqcpjevpCdfPZZ3H9gCTkMkfeiudfC+NEKiUTrYUqrTunw06Zix/NawpfjJaQeSATROWkoHUvmIUvuBd095Jc/K920peha/HOodBnRXi9x8fA2sQ8MHttB6iaH1aFrj9PVkD5eSZUTVZZTvpvT1htqj/8/cVcY3kmN5q1xlV0ypOHZsx4n9pKR3aBlzfB7sPmYc+nDoeHtpYKHn1zvL++Ugm1lmZmY8ZmZm+HTMkNv7/9+r6tjt9DJ1/2Kx9EBSSXpPTzm396TELu/BdXZxvwb3hXDbuW7HOtynwO1M9ijJ1o1hlxv8D4aNCd92qj6Kzv9Uv6rppDv519INvldcg+7pUqzIxnn0f6un59GZlFgnbbV9gwqsb8aYZOhGDd2ah25dSPsBC/lu3QaN70t3gUStSXSH6ntIdSYrs9D9+nlSUSyQvfHunMyP5WVxlMdCJV3IBqh0AdWTvqTU0aIscQOxLBS6dM7lOkHS5XAxHEMvx9JvSG+eLvEUhUwbiDXyHvPGItSS7ocuQa8vwtuR+jG8T3GkrtQJcP9igPsG8ED6FwDGH+VMWtKgfoYL9Y8BdvkEsOsKNuud0lLExWAjej+UCXlNtTFAcyjfLtF9fZ7uP0Jha9kI370Yjy7xqAsQVTzEcYGv4SntVlp5w+bQfapMWKQ+GtlHMeIwSZZAb8+D/kLHapGvM7sE6BviCtAb1GdNGVbQDfgX5sC/1AUCQz5h+fcZxCFlz28uobE2j8ZrDQ1y4OOjMQ8/ixr8b/xswY+pbwn4bB74d84BX7sY+FoBfE2BN6hZxqB+72cUajYzlfr1k1fPxeHYulKu4jOdzJv5T4r9hM5bhM2+4RqcZr/Nor5i062tE/K4qk3FtqbI41Kbpm39kcet2BRua5U8rmbTu61r8rg6t4VfXIJp0pOW8I2jOq2QloSeH3O2/cygD8vNIv8g0W0yLg2ts2GVqrQIbIXMFK/WZlLE3Z8/90ZPzMMdTyl0xludiaw9VMUmqw+NvtRMWu2pFaroRkk4y+/tRafpuyL60odFXwNfRfWBv0US1iQPjb5DfTwM/B74Wia3KEvrrMktIvootlB7ndUc85Y1dZsp0Z6zKgDQY823a6q0qTalIiD1NQgIJB030iyEgTfbi8TAe+TDsDT4rWLxmUBnQh+mzN6jDTYRsD29WtRs2gqYkeYDDSi5tn7Jo1TCZ6jkeCgSdsPV7IGxekWacHzNXvQNBse1D1OCOb2aq8aAFPYbDbMHw4zZIpSAwEB0xyD+FDvKxSCyt9Cg8mr2O5rA1TlCMB/BY/3sXyiZNw7EirktXe05ubzHHxtZxUDTveY79Ov/3t+++xno2sxTmHq7N0kCCUaRX9yl89afPr+1WpB+GdPIxQvr/+BUxjTR/YFJMH/MBfyeDto7b5tJaUbPY2fBqY2Pslk8zd6oABT1SJy9ySh0vMV5c0JLBXdRXTI+R6FgMcJs6vklx9+fcyEFi68pffT8DVjDnL9GomFQQ7XfoRLC2k1D01ritSTKE1NCQ9Ywz7dQHwjnFJcYsSUk7k6l8Gb4Cu/Rx21SzXzplJ2KvngqEX3VyYOp3eAQ4V3+9sUivPuTBz/cxI5E30lKF/3ozaSA+YOzIqGcF6qzUFAB0ryGU3NiWk5NmjeZqvpVU6EKaS4Z0nWgXzku0sqLtMQVRVqLRfJ3KriikdaxDK8pzQsBSF1XX6EU/MDLZOUDIXs566XclrXPwaewuUvB1pTjWrKXS+sVoXlBqAl77pE1r/++h0FLpebQ9zFYJ7FnU8mk+QoY8+jwhIVUL4wrRjfMUbmevYX0tVBIs7dqKM3edhwr+oJE9naLmTh2trlR9sdP+Zij7MVmnMR650+5/BTuPqiDtsrdcT1/yy/r5NWszbIOL12pRNYBDHjLbsDyLsZbnUQca2U6t834+1gpYw9n3+ZcvJu9U6ecP9pY6Z13d6nRR+5576JFYIM2409jFsr8PI8fpb/kfhn9jSQ1Wyu0Whf/b704Z7w1JBqruaa+wriZHkBSVye6PaTYanm1jTz5X1sJqGkb2719j28g3p3WPhGfsReL8Gem5kjFJtUWfFuqKk9uIVSzEA1cmXLm/J8O0piqRbG0aSqqzR62giJ1xKRSux48QAq3YayB3wQWiK3AeRTIL0xZ/0d7tDknyVnMyn694Qzs0IGc23eBVUeR2QC8Pb2I02NfDH0eXWNVf2XU8JuCUMkPWSH/Mxi3opKL6tJhBx7I2sxvoYaBJndAiLCNhoeyBSgRU4W3M0WIX/u2bJwhDptH635EQkjXj4mK2VSSkbSPbgQhnumOXueO/tsdXXv0dct0Qhwp1Sbi7YJgYxJsTIJ1AXxHuiQW3MG+HwOIgaIaA5gBYMkJKJvShoj9HTfrU4uPWqAmiYxKz1uldSJ+7zAkyvDdn1gPgHUfGBq6gwV0BwvoLiNqaDbcRf+Odo6e7o5e4z4lrPuGdZlY9w3r/gWs+wCpwLpt1pU/HtJ8LJNMdjyIPubulqKbyWDGzB+Lk7ErfXweppfAJi54mDfG7n4bUUB8bNjFhl3Byfu5kzkZXYKTbomTW19YnIw+Y5yMjJOlkzi5OsdJOQlB/oaRyNE1MjphmeH5aL4/mgCrj4Vr9vH5rKAoV8NgkdODgs1tPoof9KjnUH+/23DHvB5k86bhAg3iSzC+9IXOePcZYjyR7iEm9GyTKtHcByGsT/2OfceGIMMu6t2RXf0QbomDj98C1J8SVH4ExsVHgMHiIzCmXu5sSkOISs3teUNhp5AXZJ3BqnJo00dYuhrskLhV2caRUP5pBfjkBtdfbErbtJOr9hTY+nG9QHLME6e+4opqO2oNr/9ef6ouWzLg0rwwqH5KlYq3ZTj12/pZ6PJpYE5sBDxTwDc+HuD9RcB7BeDEKefNBmGBr02V5SUEODEp9IsTEvqYB5dZc196ikTnk0EiUiRWiYTpShORZSQ6CvWYPu0JhpMhMTimfmgTtq7AaevA8qH8lebZnMflyggR9cUxxqF34IOM2QCYo7iEDxgunWVcBsRlID2g31NcgMkuy+4WZykVWc+RkoYfnoRYA4iFWJlA/yJqxgDNFU8RKe39sIUZj6OcwQEzxvtcBs19R6QtW4gK20BpeZ7zIw48+7Ydvdn50fL4HfH/UTNdqdUbzdYqxkeZf8gd8qQ4qVQZNZd0NASwoNO2Dvuq5H2qbDSX8RSpRu2iw5O+5P17SODuSQQeSmPq0WvpLNBZVlnTqmTsg1lhBTgxMf455058HNCp5S+15a9vAs5vBXWVrLdFTCtBnwrcopFg9fXha6ivU2hTwE/bwFzPzz8E+JwoirFVPvFpj0PnAcVSs2XCxQhbzH8pIzHvmVai2TMrlDkUkA59Bpzt9Cmi/AABuXB+GdN9pR0e21XnxsM9kLoy2qW6ObcrpuAIHPQpmVDZywX2FUlu0dvbGssiWyqoUK/cQubqm0L/B/2JH/soDm7mbTQ2VNGOk7aZfXXHhPn7apyAMEPsewjAB513F8CN5sGNCnDtTC2ik/qkGMUVc6qRQY++tSimMdCRAfmeCGsWdSovq3lJqahDWCNJ6CTLIBtM3JYKuJPcHlbUBsfE5Zd4HU/Q0U95rBUaepI/uZWmTuvQDPQtOOj1q3C+hx1TTe6tTSKdUdd1VmUlayiHyK40WQsNEePvzNBvyJp0Zr4ndWLep5PqpL7JmeG2MES+IS+a5QeVX687lm38jZbJo4uBTBugkdmxbMq6lGdTBmIKJ/h3ZiiYJiQvJCO2opUvtOLzumXogyLgUfUqh3VM6rVyXyRCPknFOs/OAUpUZUcihA4PfLVQmC1YQKLnL8RzfoglcBwH2SgEMj0ZEdxQnvLa1j0KhRiGN4doSHb2pTxVTluiRW4CetBsG9JSfmsY6sqIlY9kzSpfZ+R68RHLrwM1LM3MusqKhigpA0+BIrDQRm7kbhjcRpSNaniAyjuY+BWHaJ9lVojcSC2PEApqj458ZAYCw0i70Ji8aTELfHGIyZhVTixM1etN/KaLEjxmNsFnznvm7viApEg2fFmTA6gwBx6zpIiShK7aavAzPfOLwGB8G5iZgBYciZkAhucSAFml5WZhlEjLIkdACDlHRhM9m7ZT8vK+nq/YrMIeo2KJ+jtcxDPDpSkpsSkpsTGuBLS5yCkbORt1+NOXRLtNqNwDSJl2nr26YD9b5BhGHs19yKtIh/fQ+HBk472s56GGKLwNkLQ4CrQOSOQXB399S8UX2e+olRg3eaWeAqVqR9jVf8s5N/9Mdlq8DsLTxtOS8gPzNXDKlACkZg4S1KcEIOWlwz04VZ5+p0ufgIin4alO83BS1ey6t/oeDN/l6tuDb1d9VAYT+uxRsy31/hS9fXrtSkNHvb9UKr5helaavd+O2gD/sXFN5068YzGJWHVhl2HiWGVy9d1IzKiynBDB1E7y4zzhx/A50Me+iWViNjMTiZQHQt8VUQx5gp3In2YOPctXoZQZ/yBGIZJEeTtx2bsJr7X+LcjvICyZP+ePl875v8OUcebO+X+vxEx5SCKVGVD3Tg/yF29j/LZzyflcd0aoN/N7Ty70QvL9pqmJS6zmjzQm4nfiHDVVGmeYwmBmPgqNzSpLvjatcDKrss85gVOVCs9/WSY3Fm2Ked4Va7KUNad6b1Eq2EjrlVtfZft1e7xh8SpCFc7caavyBqYdqi6duzZbNmxNd/P+D4vuT19hItz8ZiLc/AYY/bpw2lNtRHH4yaVOsaXRWKnVSYOnFpeGhPRWfxwqYI/5S6FKhpaI1ozx36P+6ozP0ZRUplXJ3vY0s/ViBRJtP1TOUr6VVwgCnmXpxwpvHI6nk1sfZUPinKlsTiDMofIQQs+loNrmrXuHivKXLxWqKOOVcFe0Cod2Kd0n2E902gy7+ozhpzjAZT1PDZz+QS7QtBksYfmHwscObdUfuimy/XwhZPqgPgCeqzloxVO0x7duLNIWypwOdOUXEpyBIsdtePfS3rtMZky4TX8fO8v+UHt0Nc+cJyV5qsmSUaemVizVcj1WST4LVV3YmHVv9tUOiKB9KtF3FolNhnar2dM5CNRUSOGvSk1XTtkfEQZ7wPTeiLk3B5XFRIsxahxFCSsV8xkIuV2s8oV5ZRIbiXPrSQZOhw67NvxbFtU/MaPMZbzconYvhpUIL4FL9BcjzTBGYirD1VxKSHZL1XqavoTkOKerBJK0V4nhf5HySnCyUMjGofXebwj5dejjBJ/oKvwwMmS41M/+mICSBxUD/E8Yppfz2C8ycLx04mOXx4q8v2RfqOW7qpxotySe/M1fPu1/AHYf3ojsjUUbik9U4N1FLs7kVnxP4mKeFonJ346lp0hnAnrGj0GPVSWJNgfHhJ7SkoU4yihVSql/Z4aERcomGdGrqp/Ykz0fYv7FJ3s+TomfOqHE66MoxY7khEKIMtNWNrzg3KZdVsozJsRMS8/SNItVWJtJelYtMWKI2bKMHRAlrOJUY2KugaRKHaLGbCopf6/kG8QfXNrF1KV+KDGvaRZvSmcfJAYHP+rrQqh8krfFINdeCaqVsi30Uv2tq2iU4KU5MNxzKzK+UqDh0+JdBNQANCrExPbmNV+WWqEe/1uVWgUrugT0cvhrqlu+S8r5yi622cXmI0wxkwbJ5YBmRG+KBq6MUi7ffuzgGj6ddU+o2ardnJuHDHMNaM5Nw1C3hNt8gxzc900Og5lvST7f6ZV4OJnm82ugc9u86zkDGroh5HnE5dE//i/kfACN/n9Vf4mAdaYzz81QJkjq7M/8Boe00as3BbeJ4Sz0p2SWH9iIlx6WSkCthaR9vylNuHp0NZS+35Iez+EQ0m4kHW48Kl+n/YAiheTRk9JpC1FHJE/g6X++ZxhN+Ke720XtwqE3obD918q38spZsZNt7Cusdh6q6fuJoHpM20SFD+0MpkGQxI2joO0b/Bhsrh16j5jAnAIABADoPu6DizCE0dCHxWI6ekRBL7E7M1Z2ZAe7vhpjSn5HhM4uz/LUeOk2M3cI35rsys6zbPcUTsmpQ+P/h7H2P2X9gw77x4Ffq4tn4lci04H3LHlAtEps8uBZRBP04S5Fi6D18XVsg8fq42EgKJodOcUbrAamrysqVvuPoemarOM/lRbWJQG3fSJb0ueZ8kC67Abb0uPuUg+4O7IpG9xylmVIY3/DqTS+RkcQBUOhnV99rl9zxY0//GWHsn4oa9f88E/c/mWHB/Vfe6lrbedDahUC4ULRAgPtCY3z1eIk6aXVuYWbzUv8wNi+rTJjXMzo6lmfCqJnAl+Sn+hUi0c1fdWOwFfIY0aEKoKSzmhFLOZ2RCJOHKypdvX5h/EF6JroFBghFz54EcKRJPA+I2JCP2jBTuAIp+9rQoXbHXzamqKVJxyvJb1ibAOCue5N7sNlwE682PCZfQb3ZujkWpZiaHREFMcekzpP+JJm0rRAhibWFB0EwdVpKAk8Z4Yq/KjpjFhTLb5oHwPdcUiUCuF5yYTnaoyjOQ3rX68roR/DfiJ+tO/Am/HIoDb5V4edMNz3wu3B/StVyAUM7AFrdDYRm/KUMsZac2oHMrLGAxn2Q4WPlQOSlyo8L3Qyovtc90idqYsj9jikehTgwQ49KEjtoFdF95GMuRewHYS9pMLNAxcPY6ky7uQrOMWzMnxKxtYLKfcRTi/A5mpRzEGi0Mqlbe4NoIw/jVkxkqShQ3Vbz4+8jOy44yCIyIGeRuyY8IWlbsQwHs1kNRe+3EtNPc64bATHw2V0dsPlsqsEYOjB5OIVCIVEw1tGo8sRrVQKV065nvdXyS6bv/f/s/dd4W1jyZogGACbarf6ShPlaf0HlihZlExSpERZDjJtS7Kn8+bU+/UzrRvaN6dub867M7YmvmzOOeec875vzvu2+emOv7n1VxUIkqY8uW8a+xMBHAAnVP2nTp2qOgdoUGvdkoN456+gQawoHH9JaLH+k//RKPw8MSde7bF7q9LwC3EpknstmWClcjh8IUdqi5M6njQRozWUd8nLNtbQwuWh1n5jiHVsnmj97ptMlUfJKwbh6Jv6XBvxcDImoF5YIxPyJyF/Wojo+ubxQYj1/cjfj4b08e8pz0oFz8wPxFrXPJ6oraN/1qERqWK9zrbDfBYkiJ9ejKCTl5Ox6tHUvw35P9sLoLfO9ALEef0S1k9b1URniPjPjGkjLXP9kFxdGSlLoYM2uup96nmFSb0euAueJpSUHAlSI4TAWpJ8y86qUl0B3uF1LNcd1Hjbiu8qDROtQZc16KKlWg3F/ZdzA+gOCypozmFlF4D8/cqlgLxZO9jl4zRp7qDFNrZYyI75cUM0V1WYaVu6ZyOtqjyr5EjT3n4WeLqImR0jEb525HQR8eVW6bngKTt4upQ43/c1Qiev3DcfN0Ty2dBpa4XbRHufwBEYTYKHFXsWP0YOQmgMPkTT8yDUz/HTZjXa30L8xIafOMfP2RiqOOvGpRXWRjIJIk0D9fnVE8TDB2oSmT8TZpS9XXmFJp+vCWJZwhcTtvc5AFOCkl9C3wq54uOKfxUsVVsQG+2wq2gJQDIi5uOA6czrqJqFrXLsckbxAtajwzudcbj0tPie4ruTF18KqbOtYyWF6hhegOp4+YXISZSISpY0x0s6jpdeUZMea9L7FiKmVGfFPOd6PuZtKqdrABoSA/fOoPS9iBj+iIto4GUsz/8NN2FxyKYTVh6bx6qg5c+ehl3LZf5v8hnX1n4JdZQSH1tUvkWFmgKJutnGrvzuKWHSaXQJk7CNKsGFvaf/tSTRNrNBlhJkMY8TIJO7gNo7sfvkdAbOyGOrJGfcWklkTPgFf/YzpMzffJyBqYAe1k8fk5wkoUiFP/uZcJWpH7WbK3Jr3xpIFSrXAbY4+l/BGpKzRn+lwDXsyO917MvvDVyV35toPD0XXwwHJkZLvvdkmRDYNiAZvapj9EqRKrWuCbVwHTexTdnPDA7G/57+F6XlHJs4/ifp2R5uYA8HvM+n+Ot0l8zmKvL6+B/DAbadIYXKyA6oKmPBiRix8QE7uIroz5gqeDqi8r5R8SJJrKxKlFmZGRIg5tfqXOXbkP02ZH/mQFYG2/K3EfszCbHfFrIKwqZA8G8RXgLeS3l82tj8nobesQCKS6LLUPOgRYKG4WXXwOFxDQx5kZz6jGdAH/WTLBKWxLwSI01zZO9oYg79B3p/COqcbJdE5bktBMxG0h6EtcF7PKyjSaStosk4gw30GTWxiT6vll3Tp9kgxDzcImjsPy8r9uXrNZ4vZpx5SZZZDRtoIvnkErO+t6QGBeH3ss2N1af4PaGLdayiJqXJQeyrLF9+5c4KaE9qFzaKrAd9zfsJzRRSRlOe1WeyhpooqrzxatbSi44ahwSVgkCcl+Nc2LMqf1TFRjJXJuu7rvnqOzQvr4wn1NQ43NFuGrN750o3gStIAwML7Ao1PymQSBj6B4Vp6skiLV0dAezM04008kR5O0OiZIMmWNsuhpS6sdG6JbQODTOdhZoc/1VNWi33e2XjThNqfXufZng5fC+VVRbaojmuoUn6RZwa4SukRJo3nFEXbuJuDr+KLAZxiNGZmQ161NBp4ftTsVXzd8mRU8UeuJ2gEnhJCVyWpiImx7iltvVTUm6eVWizaxl/u8qans4nCwisaGpD8mPmqbPaHEAtlJ+KBAh7UsoeGmgZoZ2JYduJGDsRE5S5tTPn5CbSK/PqkIK9gsTOx5nNTHQuUvOWxt7ShJUBd5qtsQE9tnFbkdEiJFoGCdu7HCm7nJDMOj7nxT6Z7gihmcT30eGfejKLT2THPvuiXLNH/UaST7ITNfRUnYorAjwD0kXHWYgUhKFqnbym/O9r79YxJJ827RIBNTeOVLE56tKakKis0Wu3sa6ozyDAMtmt6wN9e4tP0egqM9SxLMdzi4q+2LLRF9ARqKtbR1Tl+KWIuDL2d8l+Z/Z1odx10o5lpQWzFXG1EAtTEmVwwscRK2urM/ga82PgsW/Y7D3ZY2FbSIe4hm0TBQ2MiqEtZ5TRf6UosFWdxAEPNXSYT0fZf99m6saNmnEjNW70JiUvS+woZ3+M/U2B35GsfqzAAfn6XN5FTujeNO8oUNMJ3jWe5V06wbsUqosUWY7nlo7JUdcboHpDS3kXwaR2bCYjiiHjlHBtW8j8Y4WQlasf0itEE8zhzWuojpE9nqJ5Ln55MJO8DR8eAG32JCbAEvpM6GPuNV65T4Vxe6WHoa3+nJdpv/w4B9UuvSHRaNSN3LMQNKmSdQ6nXA+RD1XoePc0E4IKqCZqqhyoAbaVu6wJqGeepRuB5cqJuGRirEjrszGhwLqo7yUwwEuT6ZkhP/gnj0RDbgiyanptBz3+yQOS3OT2tSFBHy2Qiw9U/8QqdbfloQppZ8GMhSl/wijupC703VUsa1x630CiNhdzpEmTJ9wgJY0/U0aYLkJLjor6Fh9p5VbIjkeH0v4ofltnBtrDbzY/2l8HP9pn8qP7XH70n8OP7iQ/+uTHyhQ/vjz170x+9LGi/Og+y4/3v0F+vIyPydOmwFbd25j1GM+cWNDosjzukWJBh77fambj5mgegtbTl8LerGkEymwGm970lneevoRtmWz9+dIgfvpHS9riirf4eRMAkiI2zb+ppOiJzjrgYK38HTx6X/ztciktQ5MyKUbrhFmWESvVbaVCoaIgnbCdU6kRYlA+dNSrmg2+K7uNwYlm0bMpBpW6oDnwjO5YwdoxbmuEyP13szuO1y+VmPIbS3bnU+K65PHHCtl6q44Ozr0RiJsL90OT+HqgCtAdVCXLd01D76B2HzUR0NZDHo57GNweSybQSStP2qqDIQhfvavzFAOyaaRLAXVQOwX2zgQNeg/DXYVJOETKJcSXkPLrCpflUP2+cIU8DNd1OhS2pDJH5XxucYQtVvsu7/VkXv5QdISKAqbGI/XHCjt4SCYn6jXiBz35vTYbRcXkvaqcTARFMoQLinBdAPIsnmwMORtPxUzyo2FlNL0vu0U7tkKouZ2Q+ja7KNDjM0eRBJ4Dx2hhvoqpX4KjwUWB3gp71wrnTR4rtWF0QoQN6vhkmGSUHMnNWth01bfEV+b4k55krA1XXWBDq7VKDZyvszphTSppPnjuJiIOeisuzZalOJ7NY021LPKpKa/2WT6ajlGbH/JuBf2h6Q4tU2caps50TZ1pu6erRTE5MduByGG6ywrtwzuKiDdBvbCUJ49K4Vquv+VVlneyxJW4azZ/yLZNPyD7qLcVD+xh/JYA1TiAYcaGq05XI1tquWxrHo/rBct6xU6jZZvwXEXMWnt9E1a04iEAKov8cl7LCcb3LLYvTaLHIJWeMsynheSqeSQr3yAnH/1c5eSjD5aT89Oc5AeFmXtpxMDI2cXslWNN5Yqy4cRZt0xO5Oxqz/zK3HbYo3jgW1mX7/SNpcs2823NeGUvbCuHuzM43HIO14zDvYmJYIxuqKKhuvkeRwPnryooUcHcphnzlLlIlGnXfO4kPEKqzEaetG0jRWEX5SEZi6ptoC+NqaNFPgm6jGurXozw3Rjgk+gmid4c0+g3sDnMNlxWahJHEpGLHlmT9YQONpj1xCi6OyJJz5unpEBnIgZGNR8cnYSW6TY1paGSvKrE1aj2JhqoOk3dnqT4qoUEIUTO3ep4VI8F6EGO6nlMTSXTxTdTg2qIx/QL97yip8TR+pPGHCuyNZmgaOMH7x0V0a/2WWsNtUKa47DJGgSs65i1FJp1yJtpEaLDS67Q8fidtjmSpVIGtrI+MK9P0WR6Ai2Y69fQOkE6PKGzGZc56W2OG87CtlYnZnW2pfikmJxL04yzVpWeCUOqFG2ZknEQ5XBXfkX5GaM30psbcm7KchWRgzpyTflhrucQxWdHbDkkZ6jKnIzq+553Hr5VKlQeZUuDGTQcuioU0fPJPalX4nxT+jmJ53bVtjjEwwrW5aQqj/PtJuTQU6qGPg/0YJDQYdVtS1LwaNZMmiQFabNtikMlb43kJYEbBYF5s65OdAsycYNXVMTwlNV68qdiefJvVfzqX9Xk6l9VckGplq3COkWp+9Ghykf/KsbTXyGF/SIBDX9i/pRdfrNcef1TsU/7sZgHfqyij/4JagRPuwDPFcKcdfhdsbLILj7Fi3mDSI0Sk8UuEyA1tAwgPJ/iWpYo3ziMTHKwNbEEr83Edm6eq/moTP5FaKvMVafTus0NOQRSoW0bw6rGsMQY1rAQA2MbR7eY3J1mVEJGxdgmuicZ5bbPvxUdF6z5D2TN/xqxhlf/Ib/6W7EzapyJk2OccRwxedXmD4x1Z3MtF0KsS5zXpWGLYpKpvn4pZ9ejRDjUhl38r5pcwC/+Q015V3VkFX29IcRosyZ9MrLBWXVsjGyQkYkyMrZRIGdfe8RI5Gc5c3OpWfN9sIy5TWmASnMedSKrlsUamV1DwwYMVxhcjMZDSz3EQPLALZuOiVjUeVgW2QDR1xtcXnQ0hKetMM0k80meduyyek3AxVbHLmpbuagVBtQRi6hV0CrI2q7w8ymfAuAY7TxgRgXKKmUB57CbmlVY42E+bFnoEpvXQETCroaUYn8Lm6J2YHWItROskXskyzIjAu3NRPMhdGbpITkGtw1+dvKv/ISSI4GNCGhrtU5c00j9019N1FikjQZIVQIVemBcqHnbbt8oVD32h2cBmcpVSM1sI1kzzTtfdaRcMkOXIj2h3FT36jKHLhqSS0OHnNBA7BRXc2AxhqbkTA1bWCP1ltHGZt7AxOnHHx8Va1M0iJ8lqFmlzRrtQgCxn4wpTkV1i3HSlVxvUh6nN6b+LPOBZazyzios0aKsZlU2snfjITYQe6UrX7HSeV1nVFTDtlbQV+mfxUuGW6u8DgFqidlgP9xAm4Rvgz3Dx012hdK3u8JZXeFR/JW6wvzP2q7A1v+M6Aqs6DfaFWLrCpF1BUK9qVCf7gpNo6t3lRzCSnSGonaH1sDkBIm1poGulNxWParLMnuIZNDNsZ8a9pOvE/v0qCfke3MS+2iQRka2WdP/bY01n4b7OEj9zfhZSJstYPLp3OvWCwl6bKXMLZBOQToxSCekcMq8rZZGwTRvglMwyod0r+Sz5NFq+66oIfVquTYyAUuyOrQ9OH4SlhQERExMxCRLxt5poBpM1XtubDagsmJn1moUdm0+Gg8AIWWahjmbOrNKR2qezbZIpvgW9aAj3Hk3M/+iaUOH+eLLqIgX+VelLPaVI7dUVfJYBy4TURQbZKU4RMV22szF1uRRNE8sU8oag2XI3/0l+iK6iNWNWEOsLuCOTXU9bj3rafP1XTE8nfPpJX04tvbatVqaOOgL7rgvWB9FwncLX+JZlosfm7Bc0Dfb895cOHnl0EGqiNO2ZdG459GoZyl9NdDIdZzp8bdyfqxbFETzf1vXz95+5YWS8CzgvD93x1axx+oz4D4omTl6cceXCNn6sSt/Ntv/DBMkeGnX45nfXuIpY52z7EulcGzsu2sVCodkgM3zaJLHRzQjWTWdl0S44Xi07ivrv6sLOmlWMPsBPuyTLlqK0CdS2oqGTfJVUnaNO6cl7hG6gwr6mvf832FTw1VDUFixt7JNq1jWGendTYIpq4mojGW1p5n1lgvAZLFCJjHX3PIrS3JM0B/m64lTVNX51nvDzUHmqOGsRsxCYDi7mXtosmyYI8ZcVeZclygLzryxzL/7S0PpuWaIiJ6+9KzfwRwFAjd1XxFE0Ni5Pr0fdHkxgo6OC5/hJybVaDhRUCe4oTPE60//ckkPf7H09E+XxM62VPawDzmNi9NScapcmDW3s0kmqnTBMPhOHsWe/HyPXMpFiRel73l6scSrmFexXMW8KvOqLFflMV8JPS90mcw9kgaP/7kfxeMfPI7ibHdKsfFG19xz5O6D0EWffq3EKGR+uZT5mfyXUxIqRYfyBA03TtZGcUhVgH4YtUwTfyJF3NRmYTLvW2cm0V1iW1hcM3fQ9ApHKM03tE3JBT1dvBhUiyAnZx7r0wsdyN1xO4ukmnNNpZKPa2PW5EWOVy4JzdmTuAWvM8smHLbZoTZ01HIlsj5V3LYZspG6eZuPZtVpjWq6Dsy06vLMIye0TvkceVGVTB5qkOaTRE0OEepOzVfjOxGqZoFka0znNiZWdRRQQhD6NpCzim4d2iispmc3PcobHdEZjLho1tkRICqJfYyrmku76mtEeI+Rlh5RtO5ii0ss1wyJK9r7w5b1Xpvhs6K4pJLJzQBrrupcNjXNJh+kit212MIWG7CKSHTnIXFFs1KrrgLtmyjLVF5yiU+omRiVG6E5Q7Z1tZY9bA3HJFvW/ioEW5uCrVsItuZzRFr3Z5BIk5K+2VKtjS6l2qQ4654tzprj4oy/0xJt5auXaF1ivTsl0bp8so1Ny12B0NDJgMu2xhmyrRF6kLvfgGxDA91jtA4fhuaYmOud3dc73wIxRzGujogWquOOiM5XLf0aJv26Kv3YppH0qymZUm1WzVYrFNIvnZB+KdpGit4zgrCKlnCyMxKG6VcWhtOiMGwbYTmrHmujXI8LSQexEcl38zFZWSsso6GhdeW1iTSXpjZWRbgsGW1ILusWX6EOLiqxSF2320XVot7T/3r9ZVvxsAPgKnZPP5MrsMi3nTjNAOiTby9xN7ppv6HB2wE9LtZtkm/S2aZ4WGPSmgr43DO4KR1Jp0FXZDaDwOX+5p44krYEm5DfxZWTMFApSuZICFkc7sW3+Ipki4HaIy9RjP6bUrgcu4E42zgckYYKcyS58JUfyNapqF6RbNMHUqETrD/Itig+jySWB5dxhbBoIpIbPAtDmZmNheDsfybbsQ07mNu7S9lVjam8QudXC+u+31lYQ4bjP/skZJJjoCmarZD81GLUxw6lNOdqbM+n4rCJy2osuIc2eicGzKzGNZFAhk3IVYeMwpNi5YiSgNTWhSDb6IYIayYDHFYOpCLgak2u1rGm8m9d179QHxsLQ9vfm70vAlKbtl1GG5dMFgbzeSdmVVGwJZLffgBqiLLEGmHLOjN0oOfYlQZk+9KOsOstqBwZcHlRrPXZY8TqGSFEFIctb+geruE6bkiDf8InioXu8TVEorUIQbQ0cqg6ETlEv/BV7CD6s1xtMtYDrjjq842cG5A0JQ0bwOpr5W/Knj/yh4MoeuegqBuLadrAZeFHeYdexoDia5meCWwZQYy/R1Loaoiex99b8sgWjmbEF+4/GyQ28I6KPm0PKzysoMtDN58eb2itBJv3cCn0WL0Be9U99HAo6DAN675w7xAD3OHGTuGTGIRXpMhXBiX+vbKkE7PQ9/2fPslC7uGQ6FjlsHee+KekvWQ997SUrcnloDyULQRpotCVD9wCerS4oDkdY4NL6AwSN23I2+sqDXnWU/Moz+6S3ImvuG6jat3MhzLNbnwMjdwKlvhYaoybMaKCFEICLlvwsADnJVqWK6t4PmKoBIYaHdg4CrZCm3OTQ1cBKugvhSPhwqEQkW6q+1ilPLo0+B7RYeUghTJAbx2XRsFnt0xCpdrJrqpQeucF3y+Ul3/r/bBrh1c5NpGsWaCycQVB6JtFQuGwLMTTHHj/zWxTdwjaMWUUkcmXTZaee7272AoJdgLY4flexFfytdtvZ9WlAFCuyEnXqeUjG1dzcx338oTDd01WBQYUHI3J0SumkkUc2u/cD3cHJPyPErYxoleWQt84vZmtOKfbFpfVRER38CqT9tC3MHoNCg4thYaq+QSSg4jVaoTqKJyqRqXvYRahRsNKjpJzY8bSBJHWwyFSfb6htOjoOk4lbhf3VfsNcrmRL0ZYsR55FTgNrwkJ7uDukry56e1IBrcm3NnMsDDdxrzUOqnZj2dSH0hyaZQc58m8k1gWVvn/Ol5zjb1QidxHlR7gfE1Nn8HpORFUt/DKcGLm2u/bS947CmNrVTUzGz9f+8zUKxmzyV5/jE2zSrYUzm98Rh9/HF6dxDNMIuDKkR76dqjKweIxSSoh7/0s4Q05ZwNYn9S2vPghsoICU/UiNqES9udKrss6NZMlvjD4ITnJF3a8zvJvybLVZ172clNKbdgGXVy5uG+nj+WNqdVNLC1/cH/0Ah+0B2J7wfbz3dU+9oRVsNRqnk1d72RZXjVUeflmnvWTx3nmmjXPo8EpeJ9nvJ89kdNbg8+Et+xRuQ0/vvlEs/1ff/v08dhzV5EBwGPe3sf+4yePfeuyzI7hzXxniTKHr/ItQhkZ5YI9wCE028+3MS4BeAvQh97kQ6faks885mOiaMmTX/zCx/4m7CCWUj05gB3eXnqSQZeEQg98AIYxOwgQUSgxs6oS9utT6Nr3Br1VbLX8miVBgXjgBynrzc9kGUSW/dnP4PUn2c87VbVwfsAd4yX5Nbzh5XxaN/w71fTLlPTflzXI5E00RMWjeE9oBldyVW0BdGJm65iHprI57Jgmv4/E3oh5iG3FWhX72HmCJrtjh2h5x7xt5tGIKW5fWbL1AxvQsrv6GpFrxbKfLL8hJdcmyuJ45iumsoSWfp50QqylGDC16HdcBWrKw8v5CLTD8UKw7ldUFW149ZWNOrLElA1mP9MxaNOOTzLJllkLD3fqPnpMDBvMqg5hgBDfYKMEhuhpj6la4k35v8b9uCIOdnTa6NQcvIzzS7xlTH1Tkyt5sgipT59mICDfuf17XsDP422Oy56J4Oyf/7N/dlNYjh390cfeXnKZJTOEUzgUd6jvQsAmiGCGMsWyMokt7y122CFVPE3JxcHWLznWAtLVsYHICGXHJ09s4I+gBxG+p/Of/23cG/bq4wAIJ/+syJbfov0j73mwA/sT9nH1lMvUXWD7cD328Rlp23d/x6/ZBwA9kUZmwFvst8Kbt+p469Phah3HWCd9hNjy3coUUp29uCKHXQquDea9gcs8XMYWD1tYJyvXcURm4hX6cl7BIYfBQ1dMJ30xlvQJAvIT+X72C5pIN0mSb5z6j+KybdJpUpmRvBWdXlQFiTyY059g9B2RTVVMed5GRZ3kwxOKV6qjzKFycjgex8nX7PEUNX1BHp//u5xZZ+dAb8rb8jy9mcz33Nh3jn4FezZS7uA1+LK4E8+zq7OKocJ992V7IQaHovJdOiqqND/nL8YKmXBOetlUlpHnwDt825qsWYSqrRs8RxXk3J5OtKt5dFXeNiOhxSqgMrLIvlvfspVNH53hwbz99OeLAZZ637qtw3q3/v/LlZru3lj5UaN7JSsb2Sqqck/u21k115HuSal1ZDuqGjtaphQqUZ1OmSK4H3uonM9g3JxWHostQ5nvv1CyDnOOl3Z6ngvNTZLxjHkL2pS6tjWop0AKXJJkeTfl4by6pE19SBQ//Ar2E1SMfslQbLvn7ZEHWd0malpxacpZplruHV+nrUEeE548XeC34OX3AlIx1b7om6JHeAEX8CLmaOP8iRkT2rnZE9q5MSun8PS4qDjrSIKiMiQhWNGqQYTSn18o1fltsetFYbd83zJkTtKBmE+FbFKk1H+B7zqsu2QSwpToJQmyZTGI5eS7Aq1iudOy2Pp48psvNL7nvsz6Hy5VStaHf9y6m+RVPJ5FfCFjBaxTMNqBhek4QrAwZczJXKWBYsY3Qkrq6Vetib1dEySbN/K0Wj0nQoXzu8ePme/EPhOV+i1pP2sVjeIIo/H9Fku6beGLeuobr/mV68r1f7r40uL7pfcusO/86Dlpdcw/3Qm1JmfsT3Kt2UZZmT+UOLwEL6rflakMUjuWXDCUlTcvskoqDBZ5dk6rxbPzPJvjq3X/zs48L+a4QfocjWOyI+gFlNl/X8SFB9k8wfqSfhZr8Og9vMgVhAu+Ri9bfIBFzimyD0E+9HRv6Y/zxV72YTJz8Y+/l33kD2YffcCvF93Gb/yDshKOm8SOb7Qqpf+PUraEBV+SmF3Eh0+yT+iKP8r3mHNnGutesKQAvMyvq53wu2cBS5BDhk/I6I4le/QS5MUVx/a41W7uz34ma7giN6dmuzXpdutyHnMx3Id52MBFm0HO0Za3iQ/zsMVH7ocrfOuV0MILuYGvTeJ91ALu31NtjQEAYVslMJO7JEPvz4YdNKSoXVyUHt6XTOfvhz10w1U65nwfM0bbesSAynUO1dj3AZ2n2JHR+tqXStl19xywo4QbjrmruM6eV9dFa6jjutllborkPcBSuFXWeAAOR9tW3E0ckKILhOB0SduqF3SwL6X5WtlsIIbM25LbouSzp1J9kdRnTT4mIHoFERiBft9ggI8/5MiHgXDTJnjYoFkkQsZ3FuRkQfTRCif2POefFLIgr3wYA4IrlSH1/rsqTOSRBVT14raQ8e4Mg+AhtsKCis1D9MV7lB25i8oM8Nkx7vq+QMec5qo0zY6fLtuOfTjKfVuSVBolxXlSPEoq50nlvcJk7+6nw9kS+RALlMgLFKBbQrQPY0ttc+ewgcEJFg3XIm+LtlekJzMploTFB2EBDKlZPMlFdWQsu22T7/0nUwtVKlonfIh1WiAAWbTYBXnjFg6IngPUdby8Tr3tCrq4cSTmDm7eRIhn8cNwEzdoPVTzjUDKcCVpdcPVHeX/yzNwdQeLXxeuDgxXhlfIxtJDFvS1oSsQWzfxMg9EeGQQW7jPc/ljeTdnQoyP/GyB2ME0xA6+AsQOcogdfFMgJmPtTf+klMPsRuhSAyGiiC+CqiXPEH2OHlrwBQj3QIX6RcPYIsq61viOHLnI+AaxIbVbwgEuun8kn8DiJjOpWq3v4WUawwZ51cM1fsT5cORimDOL5jVh9JHuON12i+/RbIt6O1Aba5OkclSPyaUJj8m1szwmdeogLHbBPSScaS/I+9c4s0aULRQekttS7wH0HLc5Y7yGfeka3r65C9W4VCpxYQIQY05JRKcAbj/fySCEz5tdOBKOFeWHM1B+BLEvYtMJcoxDrGMXR8/xrBzNxuTRGAE3qa9iUwl4a8KzQoitofGsZ2VuQssSnxxl14ImoW6Jy6FKFZnqzgX1lMxbA42vL5mn5Hl8/Y4QaybzeEmdPpcQn8lUNaK8KNlruUTziyISiek7OMBPkncV4HEjyVrd0owmlmZGduyNN3YuLe0xM9/laTH0mJnJdu6L9wss+GJnGZLHjNk8hmNmZmZmZual+v9SjzSeyfoYAyOpsbq4S1ARd4zszLQHrj8Icuzw23lGGKd19Qyt8Ep1peABvOtkifWbh/V91WG+8ioceeLqfVus3vjHjbE+B0pWp180TODCNI7Ml/jCY7706Y3SFw1KH12X+nwwzBRUl764zrj4dz7FPNKi/BPDzUF2gnvxQd5HEYIqPZCt0wNZnx7IMOtRPfhTrvBTPngEjjKrM748UBbrPWODHw5uZOCXYmCt0FqcI6lh9i8E7Ba6vnajrncxZrhroF2ZOVNO0DoYtP5Lo80NQwKo/bXBXMj31MCWVv9Uo/rnRqvPblTvHK2+f6P6wc1qhwROHqh7VTDpNt2ey6dcVTIGWXasMz6RlkEirTvVGx0tCjw1bfZy9EAen2r8v4lMNIYNA97oVm6Qs5ob/syCG15BblDUXt9kqjW7bqHYNjQbfNyMNnh7s8G7xzR4dbPB64ca+Cgl6pDc7PlmgRsvNA8hSS7SdM01em15ANj7I+CMrPv/Zh1D66wnmrP++xiwjjUb/FmzgY671hj3lbUUHmj0umCk05sb0vWqutPeRqefGgXlxxrVZ4+Mee96yC8f9QJ7+2bhiMDeZ70sBA12jdaxa7qxrL76mxfz12zU9VfZtSkjpHHFGBZ9QgwGi+WYvy8cYof9muzz93g3Z1iWvqNjP3B07KDsaBJOdPotYdPsdWNFfLcxtdQ2cwdr4l/eQqMe1sIOaW1r5WwHtP4GleSvC8wuQKKtQJUDk9URfuWSkMtgdtzCSPCnmZvQVhzliAu+x8CmkJNITpOrQxONrgvmucZTSFCRTvre+wrcrPRVHadl0Z6qrCWXS+XehQJ5iO+9X67kVBVDINMnnD3U2VMLRn7BPz/mdj/ZReQrQoZZqUO9bE6eLxVS9t5Xvll2v3AIgd83gTSasj38eieMqgn5goOGdXU9RNfefTIAfWXFU6uBJ04jAEd3sJ37Vb1y46QRFRyYL5WD4djkEhxYl70ZkG7V+GmLYSfUYS4ivuaGfpK9BW2D5PdpRMa//K/k0IgxBgUrpAvOZFfxbgY0btKcIuWFxUVB+JSLXVDF5DQQbioKLxZAnsg30OQ5k+hgfVpLvgzQD0rRXlcF2Y1HCfbfdlrmyBbJSxSu2osxD8PiiZ2tzjtyzvnvAJyTi6HRbo9DGeITYgD/zsr4vMEu6L07+OS/9CmXMl4ov8yoElLOBZLuFJHapeytV1VpFpHhFHDe21lfqt+1DJDN1A9b1WxSIfo9Falfk6u3a5sOMoxr42mJ98kkkKUPqN/H4GBlk5l5yOJGZbKIXGwa2wv0qZwiEoiLFB5pV2J84X8VvcW870If48tcDOROEl5kaWIGLek3pduWSPCB9MMTcsynGarLZ9D47kWM89OkCHxjl/MtLmW0LVzOZ1UhnO6s6+p7c1s1cUP3hkkmIHp3sCufl0HjPQ6B6GXcoGgDkG3udORtQkQBUf5dcrkNOdGW3ATLdi27uJqw3Hbo/PPxjQRJlZxPudPzNjXyhO4eW5pcy7XzyG3LW266eiU+8kkjfOZS3a83PmMxLVcTbppboAlE0GO3jQtH67brula195a++riBTxffcl0MVX95BFu5Gpx5PZMldfQTFELhvqB4j4zUk+MupZ3LEDKZRJI1J21iOYkZHdmFM/wXBbSZAZAt3WDMxnC7m5JZZv2C3ZzbjiCI8wGLyMmprU+NPz31s+LNL3JuH7+L3N5A4aw0S90sUZgqCtsuIeKQ9L95MyPyKHSJUiMaRqGbQuxiyr+tug3Zy7b5u2J28EUXIDTiLTzhIjVZEdUm5Yqa5tg3ZFrSMaYlHTYtsrM/oJo+3S9XG5mWN/7vG/7XjLUtb0CNFMrhDUFtXd41bF02nHNj63JgX5l+J6zLu8dbl3ScdXmPWpdjxoSeGq7pwJAOnIwgRfr1wFk5MLGzhRMjw2YkW+giTAd0YSnZe9VXEhuBx/dManTy7H2Dct7gUvBtnfP/Sx3TG008DOuGxuU0NXKGn3QJv5rWFz9UdVDQOCKlXAsp5bLPkXZU7b+lLPhLjlcrenVAr/5IzUwGG7Ok5/fWLMM8R2gO2Vv3S+vPwyxA73aqDDQullkpui01CzrkVUZnWJNjecywU1SnHOZddM4j+nShsk9bCTwiGOtaA5Z/IhM01xq7Fm+1zmEIgP53mOuEzCXL90PqtorjDRIkIzsdqLCCn6tMo+nzhyvAz/oK5Vzd5tVVm7rk7UaZmW15D9HKGX4uYIrbarQ8SqBp6n4fVsDuvW61S2VYgwQcXg9canLB8Y7QZdggX4+szApFqnvkNc2gjITdeaJbuhw7rTsPUrt3NH921xnxH/LegL3uvOTpvsQs+2DB6ssHIWpu7yK6U6H2aC9BHEPfB1xNFfZr4Jo74+y38kyKUs0y3K0SD0OekEoYY92aZ9gfzPMMwjXNszsPxCx2GcQscTEbuBZ7uC6HyD6vaX8F+HK+emAuhNB9YVDOtMQuRobtUNNKV/CBPARwQiHrKRQdBbB1KkjAfUwHiZ+e/GRfpAYaA8SXRoCQ2R0Mbx75gJwZvOKwSTkGv39mlshtS5onWfd6f2WocMtUsyCTicS/qXy5SMMjhU/IrJGHljquLcZM1idC/tNvpxrkvFC8mmea04NETU34/g004Tfl9X/w2HqvP216/enX7fWn36zXf74xR5C1P0DKehFdNHf07okNETfUplpuZVqUWW1o2UK7zWr7aW0/iwK2nybStYVli+SVxnRGA2f+OSYL+2DV8patg0UEVqOv/Gw8yJB9SM2gbovb/onXuIIOe2ch3EF9WRGqFn75DiHmu+UIBxA5zj9MtLcwXejaavwomw4oZO73jyi5MQkuP0oxwaTc9DRDPskTrYm/zvXY5nrWyHu6jiHwzcHaUui2QkC73sOvEYpPAiA8tAjWlUUo63JJbRfynK4f1tMCCDUcwjDtxTzU7wmS3V1bfRlbSQx6pMQER4TO0b5AeDU6hCTFJGjHQ8QD6rJPNdAVE11NT+bTSsI3GNNahRBq/C3M/uXqQbwjUpGho+qiPBSpYYkVZoa3HGoivAiXmZ6F2GISt0QVM6liswDGdnKI9bEj9PFbGbUlxu9o6seKWsihaumX5THmT2hHYvW5VTWE/n096+NLIZy2pADpK68VDLt2CVdL2ab2GxHCb053fGxEd7QO1LoDF0O6A7OEq+rxUUN4VUlbzqiToDX7OEatVCe6Np1aq2sMqKBVIWACHiIcAMvdBxoqyj6BwTbSSIovFfAmvrCeCl8/7kP5jPSZPBJqkHFVdCm4uVzKoYiUHmxhqhigQYWpCDUUPOz44GG6UfAQS/3mCPWZEULZJqHsCKGaKPwsOn+jSr1G6Vo0jFLrUdq8O9LZ+O4IV/9C20LeavxvbgjbKtgqVnlMByvvqCN4a+3rsFZYYTLQ9DgUFpsEiYge4fhgOYqlyeQQ641N13SuI3g7QfnyYKF2TltluMBQ0b3Vhby9epC3FgeytPQFQ31Ek6++ROR6tbWJayO8+zZGWydcmr2dZyTArfEjc8GBDHF/RCxyl75fGSnLrXL3TcWDMfUV0IBOdNfZygly7eYdgoeBvpYSpVZzVm1o5kLV5hEOdNXolmiEp6UiF6nIxSpyoVeucGwYtAiXlgoNTBjd3SRfMCY9lX2aHbZP8/u8fXrpv//FSyiOX67t7TSCdCBurNm+O6onNqnKnlBbnLikNmYYMMSeHZYipT17CQYW9Mnh1jRnSfaVhjnGw6f8nFNb3WOa5fmBWf7qsFn+2i2Y5d1BpZJVsKrQ+sMKsDLOy/5CGR3CZaqfpjTikIqiEAzin613NMn7jdl0KgxmG2Jw7fgAg6lisKMYjPLOGFRtwpOq41FFy3/0uFr+Fm2zuvIxftoDf76BsEuODyHs0uNjEfbts0rXjyi7+aZHOz/i0S7eklUKnV0sf28fu4XZDd9O23TjN2CbSMphRTrvbfkxE0IhhiMGKqI6BPtOy15J7/uErgXscYflvxPbdhFadO5g2SR2ESpBTNR2tKP6dxQFap35gaFLnN7ru4my/nsmbKr1b/6mWxHVt91cBPNoB3bgzKY5xsDkIj82wj6jYwNltQ3+9vDaZce/c7x2+fFvI69dcfyHi9euPP6DxGs5Ecs7lMN4vbfH652D8gXgQzz9vQau/FsUby1fOKYwuZ0sW1jRqIe5QBtuhGVymVCeg8caQvEKkocS8upeExpLpTPyI1u87iATusHBNB59gqMiIyQvy9sTq3YlWjUr3dVwpbI+j5bNW8sHWbn9fTi/ZviccnafEHl2afE5Zf+QixeeA5I7+b97ruiUfyT2TGNtkbgGEqO5QRZUTBDQIqHPt5OvByWLeVqB7KQaNWY57/LGiwvlZ7H8b/TVd/OOLOc9gtHCDToQ/mwvuHm/Ps1wO8e1F4rJcnVvl9l1QMEn5ZmwgcseEIJAUgcQYlb0E9o615c6F3OL7x8T7fHj3UUbtMUTj4ZD52miQEhtCB4k5tMy+Ilu0AAE6iMlBk5gFQ0IJIRV/hHul0yUsnKgTVYdYvGbpSCUpS7mky6UwXWeBbAvFp9y0fVKOXGiGdj1wcQYz+45jUVmrn2nMODi5HjyhGvrmbO8zDOVC+u/7Dcpqz/iX/3ZLKsFURchH5nedz3A3rr01CULUGIs5GhAyp+FUoMyrtP1gM2etO3iQwsp2C8lvZMz1/TPl3eUs27TorzbcOa9r3j4swar8/UdN13+wwVoYd20szvnCnDvI64606ycaa4SoO5z7iPOXL380mcJSj9weOecHP7+gt1z1TifXnVTGLiebQUN/7azGw1nd87lM4h5hPgxbqo0kjLgNKXElvJuMms+W94dh9NrumhunK1ugvfH5jS90gnl044iB29Ez7sWkLtNkYLTW7kJ8LsQpsZTYYE9Zdrqw2jKTPohypRkxRXkIqUMuFu5wafmW6Rz22Uuq1a8/6Enr7dPKvr+sjx53fUwEYzPeFZw/RPFSJdspItF02yITzrgk56Lmf+qKRXKJy39ltEtwPOckyd0cOKATAV0ESjyUOamsuO0tfUgz95x8p+qU/fsk4T9eltsf9J1QJz+BTl3F07vl6UAgttLWgYc3OkHC/k5IDtItU2zB/EtHGQZ2c54j5tqdmXily3SRKUqH4Dy7h1/gO+Ybwcrby+t1KRd47lth8sEJJTiZmJemp1dUzWlbMr/nicvLBjpWihdN1cEtWgUqknTjJXVe4/g0TiPFdg2CiAeLCgND85iK7Mo68NYiX5Oo1uPw5GaA2EYUw0jlBz0NgS1XWkUuWxTRYIFNrseaN8j7Qs+sttC0QG17LkdC7GzzYmQnNVyIp2EE0if8dRzpy1LU6ATJraJavCBm7nOtecU6RgjG2iQ3+kGNAUTsAJy4Kf3l3VlLlVCYAcuIT79msEKZGybTp9bbTYgBZGpx051THlsny9/8rYXkV65Ao3XBfxd4CgmjrZKBYf1w7W1z8q6JCjtYRSwfYptf+qmaDLYu+6K9mkkHefkQqHtgd96Y9ohfXPo0gXarK60rBQ5LO9mFLoOVXSB2WkzaSybNmbYujWuyLzdb4/l2bKB5dm8odnpymzQl67HB8x7eSrQkjvctCqXhrb7A6JcV84A2bDuor7wJMHCnjSiyqxQZ1M+JXPU7VijYeQp+js8uSn+8ZqFVwWJNhk1UMStIGBKEFANcPQCYVE5vuKwvMrbJIJtGFJnaUO1f20/bXnJBTJWgWh6+9T2UxBJxaSw8tQsAzUpZXQYybpOZZKTwDh5tN3EXDUeRmiDI2M6SzoMDSSIb6WAfA6msc3uRd+1/ejqnmU0YXWZZ6ALMHG/ObEyEwWqCbaY7hQC5QXf2WLzYgHXMwBaxrlvlrceqTbQC5z4k+MkATq7ZHYW8RC6w3IBEQa/f/gvjl4VkI0nHXxKFQxbfnpQrkKipV9ulGaD0rW/rEtnF2pZckBFF8rHq+ZYhagHIaIAjYejMUZnJB/Tp/GOcC1Vk0D1JN5PoiEQtxXtBpYl6kUmCKxJTukNa4VgswzPG6rzPAYZJLI5uSebHW5Jj6diN+oTBf+CYfDRd9cw7+mgC1CjHhfEIRCb+ZOOntTj/tZQ+iSEG7N/kL75HFDSulP4aaNG3+RWhUbkh4uE0aVcKCCpf8l1UuEoXZ0mGPP8kYdgvz+5YD0o6EFVGamqVPst10YqPMFAa79AdK2JS6wV7fWr6KT2R4hkQ2brjJpiNfQqmnl/oASltp9nlS/uGwJqohobYmlfzNCpBlOINnIzwhQn5III0mCFxfJtY1H7K3eAkBe35koKjnUb8boLGW5GFV0G5Xcb1+eILpbhb+1meOG14EwO7XgEuspCKhsOJmZtLi6u0M5tRz39DKdsKNsZP5/SiShQBirtHp1Cxx5P9jP47WCliRx1jGb/RIWHW5+cQSoiz7gzHhBmzqD2ywbcaZSAVeU/NGrlvAOCPDrytzu2l/Fy8mprwyO2+lqJgx/ogmcU9sxBGuHg0oHRvCn4FRCH1/yzemkelomUmCuK6ML/WnTRmfe5qoj+y0U/NadPMdFC8uTGvmst7m0YdBf8Zx9Wr+VoNqAgcV/rEVe48LJnaU1VWBrp+ogrPEzxpa4N432ZNnQGF86uyDkeslrM25hXuuzuGk69V85FWF0oLQam/syA4885W497GcQJCJNE0sbJMDvnQARTewAXyXA7lh/x0zdzdxXQbRxNWHe7J8k6Yxl+WF2ZmevIspUyM0MY36sdfnFihxnt5I9dOl2wzFxbhjIzMzNz7eifb1e6O7kqc3sv0d7C7OzM7MDO5qrcAFpCFCeEhATxSzkU5ivrIhdHNOW1mncBz385Ew+oLK8sWzyeVllxI/7NYy31meuYqI1Vx7/t3ByhbSAx5a67h+985msxJ0O/vavsbKnTtoJdepRLDgaptuK4b6NfpxzbCtHrLn37bHL2tQ+VO1Y4aRUkNtohQa1vp/rC18jkyIJZnqRsyzcgGu4Bj6ITbgoXRqxf7yJGMLQcGLEfhcEUb7uunpNdLKusO1Edvbo9bSuQhdJCEKVAA1TSqyWBJkPCCw3TPzLmG1med2S5HFlHI7mJqY8v0nwACio8AC/lBfCSAjCRAGAp7oNF3Tr3Y5nYFQax7rVZHJdjfxLzfh7rtF/AOsN0sWz59kkflvX8wL8OlkFTisa99fRVVi5FI3CsKxo719U+vU4b+HNPY8PqRcVv54qGVwv+MOJPxPSPrPCNLM87UnF2Ao0s6CHo/BcIOjd7LgCNG7d5AvZRPtlGLdDghEbY9I+s8I0szztSLaCWRoZ+u51K9z/ogpNahAgkrQDNQWX6UZmfINQfc9WoazCubA9MTVkBHGkFMUSXqHonZ25T6Xea9mEbSfclyokMEUYhCCQpIjgsMRTXWCzF87HOhpGVxhieH+G83uj4O2OG0DCtdK5My3LYVxHNqJvj1WqUoUTL1s0gHEEeKheERq+Nmmj7/FQt/PP0MCGSwyftF/BJM3/+TsMSQ4JwwTqlPfLZeZeFM2Mw+eiJ0WdlVhCgFVDFiHPYjrM3Xr6fQ80FSZKMpJUPXj3Bc/2J/U/CghXOmihQCCsoAIt52unLs81Txu/jUHMoB6zEmSoIbbCE/wPWwHquAaJrRTD17vTvmdIl1XSN7rBfiH8umF2P+O3Q1k2/yWzzmcyWvCZTaTQdaeK/5YKhXNw7ztxcFQzCx9NqNXh54/NcQFHSI2ZWKpVIHvW3nSvS7ISMA932CTuuCCSSj2MxRzD1OFRK1D7+4Cn7Pv16uZN497ztZr/x+imttuyQmLD2qhNf/fedvZzE42e3b2xr26ZsJ7Hqq9KysrJJMZvKBx+P/26najsakDGpdHBT6RCmxsW7+Rl1qCGSwYQWMIgaqAj7Dr85RarFPKDpoAX1A5qhLPyYA/a6x/zEDHo3qDI/6jTDj6KedEhe7CRhzU3v4DrgzWGFiDleSzhJHAPk7vXkzRzD6baIyzRi4fr3EvxvaKYxR7dvMKz9hJTdvR7VP7b3zNa3v1nT4iRuu+ralgs+iPayaUj3J1p34WFyWStjlx1zXv2RExe3dn+Eerr5RsaG/tIk+YNO0gZV2R9Jj2aaUP8rEwQIqrsfxDsz91/cX6LpOu0SFe5otDMr0yXYC1eHSRqlaHZDLn2G3EHkh/5NVrZyZ9fI7txpw/9gLgn6SZlmNiHlVqb6w4h6uQ+1D2Q3zzjKsK0Z+4Hcs03lm/kGC9GWpqw+/sa29iI1zQ0bT/Yi2HSm8FWd3xGx9E1xeYJQAGj8QAXQsn3+ylFVDnRDVIvfOyaqQ5nKS/5ZA/NlOgCieAPpSBuXGWiIxKQtzY7xn2wzirsDVENiiXB4dfyV1i1wz01GkBe0N6fZkMsqxXTBp6Y8CmDX+4XJsVhSmbtzpqQsiLLof+D6X0LKpIqm488brLBtFUB5k+a1pX4XLOkDE6iwlxNchiqMCzkWhDEiQpDECPW78I6xDxU0d8YcyB+9J47p9eI6H3eQQ/UCu3dpvwPujNkORLDwirHz/3179X2xkxusxs0PfiQm5Y/q+Tf/a2pqejrWIOXz9Uy9FYFcRiCXtkNL87AHlsR358Mdu4w3yx3bts20n8/GP4DPijng2VkXHrVu4lHJs1/F/jAIuP74e58lUAU2MRBcj0ieh38az03Fc/N35LkJnpsez12USRHvud3HZZ+uPbncAcZ24vHLmu/Zu/EWyX/bTBmGNhGMhwDoFXnYP6uiVjHpwg5NsshLHPk5Ai64XmZ9XW22vLC+7pQiHTD9CVZXnqDifCDTxNOAIGCunEV1V6jyOLQoH01tnn50XD/1pdraqCYF7XtYbVPYpdtCTyJh7Lg6k9hvWzzrjRiOFaQR93aDBA+myGxIyj8es4WRKHx+CXHj7hgSlbA1wpDM2/mFxPLND+6ITXvoii8nT7ohJjm3uvdA6Y1kqUBA04OurHq36SYCes8T2249tfrWGGwOsVQYBCsoYfUvr1xBPkvq/t4Pj1r3mOtSBIs6WCEwPCjoR3NseqTQcSmVuvwr6a0HnJbZHD+P5lXUWuHKHeAfBqrxeYGC7diVyBKJsPQa1xsZX2/UDZaeCOz9zdrKHd+gNVqGoE5rZCdNhLOQxk6ZkJINy6khKQBHlkj4bSQPEzsPvLPhxE93lAJowJDbkrQEW8uiKFF2YJ57v5uh86k7H52hs46Nc1fw9VFEPSdRpn28+TVEc6yaBLhTN5QGwx8ZbiIAdsWnxPQEWmCx6nxRj6dfTE3lMn+PmP41dmSuocQ4KXjoQaOosz8DK5t19zTAFTARWF7iCtx9C9v6y+t/Msb275Tsy42VtsVaVsvPpeq42P3Rf6stTqS8hghI5DZgqrN9O+yk4ERctJFfDmoqaR552gxW/9TxiMT5lzMvuXpKDN6TzZ8MD70UxVG3T063pB5A8cN9JDOpKBMgo1RS23xM11kdm5CJ19WXrG+1tPh/RyM55X+EliUhiz/41M1LJAlZfNlrt3/O6KO/VFx8SWMXFXV5ooirG12hQ4uC7gG46rxEHrnJD7LVNUIs43WHFDG8qi8GX/tqaimBxrGLAnIXoOPWoepDhFFnljq+lakPjTK50dUn30tQ2u/iG2ONAnn5bfU1jxLJFnfRaOn7XG3xqkDNLqnGxRbtmar5rSn6cLzREOVo5eppJMkNVq1/zB63NFYtuHjbXosbG6xgIyanjFTDEmE0LFaTAV04WfRTuhTExOwAxU1H13hdD5rqGfIpwhyp5A+bqBoWFDfreXyj0WTIwoIPHIr/bQvvkTugqZA7wOxkhJdJSeTIGxhu3mCkYDWtqsFNG9CokZibVZM53HBkjeoiNCqTxVRFWr2bKBhMZZkooCZgyNGqkgQKTI1MMFiGzBJwmSUw3CzBaGT3NLLFgwRJUfUB9AWQ6lbCVnqXvmnN8xnD9mW1OTkXrTI2c/V3Rc+LIanHxXcsm8qVQep47qm17CRpIq6+vSNNRSl90m9AsBcE8IzsT6/o1ztnI1PL0Tvv8HjpwTPa6JyW9TRobR8Dcm7mnvWUPvgzPdxshoq1k7dTrpfM39HehSDaXXrm6vANFqcxL2FHkgqEMCZG7z9ujw/3eaccPkiOQDpQB+pJPLSitWbwXgMohvl46CO3x1tuoTgqsf0LW1wx5IQy7PKGllaKbAYgiOqlYjKqTZIpc/0UYSSXC5a0/SiL7CfGlFIAZcwIVZQuwav5lorzGSla/efG+e40EPJK8sNkyO/WZuJ+XzTHCVuv2UiSaRNMPfkiOCeRjdHU2QABEFyW8sV1TiIbyUnL6Wrmemko2Q+cFAR7nhRwdVJguDIa9E4KfkGgCqx/70DVcJJylfx7InejR+TOf23kbiBypwnZX5kgQFD/IykSZe5JAcs5KWDmWzwIjYg/jPaat9OMTBcd8heE2iVUbXl5OJz5SAVaIkJHi5m0CkXh2fLGfJh+0NzkKr6zrSKh+1+La6wSTzMGCJFVasP1oeDO5Y/XXEyWYFVUz9NStKnQVkU1MO9sP0C+StrFpmjmswZNVpk7P9AszXkrkYYo2JRTGcp9jeS+mt5rnyJm5l+KW0voCx0P1epuLaEuNDxUm1mClrsE4lv+3nlI4VvSpnJwnj5l/j5sVZQBJz/hJJ1NyXXJc9sdgGQGWC4ZnvRVFwojirSdCOP8OYCfMP0U4s1wZc00L31C09V9YPP/nBk10PVE8HBr6Wdx9wp3d2nQzL7cJrn5724fu5fkw6Gjpaanoi/wng5avJ+BBuvIcvkU5/m674t88vlxD7+PJ/Xvfnnz7i2Yt39647Mz9PsV/vXm7+iKs1+75MUbTnnmzGvOf+eNGz789IcX3zxlu8Jv3eDKQFBwE0mBsofCDIQSX3CwDTsUFXDGF4xLCFAIMkMnmEjhBSqucCTB3Bq+QFowUPDYnsYyYAGTMrURpafrYMEr4IZEsATOwAIImjBGEphD9jybDtI9JGdS9xRJDotmJQkLOFFbWFx1xUzscpvNDBbVJo4CmD0Y0IVYSFaP9mKukh2L+y9+dTSTuOsN2jO7ZutSMIM4kWBvHnB7TIE7s5gsiXrQsBEws+UWFgldrBoqckoUK/duylcho4aJwNO2DG6DvkERfKHJNDeRcm9I1NA2WiTk3p13+TXLR3ewyANOZBp1QNlCSNiTXlehG5+QkdzzI3rBMgrtZjeNWmDg6CGGfiiXmhu0s2UdZbfGPnQdCWxeqGm0GgBCh1YkY7+6JsaaZEPQjTECTSQvzNZXSyrvJk5UJLSXwjyEdoBIOJGC6RVsa0HGxfSACpkz1eBj5BZmNIPCc4aQ4bIu82W009LWhBQSezoYf8/AGbArZK1CQaztXWuVanoqJSS68PYHHr79/ubBhx96+ImHH7r39ougwxDJuyN949Gy5x0IejCTVHsthhSKRX3Vlb8/jO7gwdtcLVFDIiz/wm2YQxkgkao109nn6dmOx9Jw1wjmnv6fBn1BC6X/6EPlPi9YEQ+rW2TBlRALGKmlXGwWxjpjuBMUsMC6PhbAGoAyj715lVhesOEDN8G4hcLgWo5jyuCgE057OkxyYabaV4dS7GAma0q99K85Mnv6O7qgDwGwjvBf861TrcDT3ryDEbYDKtWf+/vDEhu0Lr26KXDdXdVoxLTxePFDleaKYFYboW7MbZW3Fkvoyfh3t18hSbomy1P/G6N2ARbFGjUA2CbszktYKEiDIgwc7CYUpGExiEvYXXtJ6SUMGqUbi3Jglm5kWTABlzJhhlIsLv96d3ju9zc8xcw7cc7Z+WLi9HH+rnwf+5/uNNAo6FP/D2LPbwZ0xyZoxKePWx/lb/X72OclNCUEQxP9KGnsgdDYEyqG4GEmMU2wDDqGJvzHah/hctz6f9Z/3LE73GzPAFECa31kJvSB4OndV5gw9leZN+Cy4TnBPLxp3erHPzDBbB5xYWOigNNMSAzzXgrHryj4Zx0DceMdiy+cbyac9LKb446sErg24t9kPdOXNRPNtllRXW7vcMGojPjFC7esCpsIntb6YPvlUwoEKxFnrCj2sW4iat3275Z/OV+QN+/Lv57k4aEwpYlQn+7SO7i1RRA/G/Hd9ob7E7gEI0Tfo/yBhGD/GMSZd8Nad3GJIGZZ0wGTNQJnIi7Rnt/xoZF4KZMTKnZlrcAZiN9sm2/q1UhA1rPsBdULx+faiF989nPL+kbi/OtD61abLhLkL4H4Xfuiu5UcYorBezs8U5yuD5p/aqq5LYfoS3JRLhcXp+szhOSf8d1nKoewMZ06Upq0VrA/G3HWmY7VsQ3ErMlD10mHGQKPQbzhccga7QbihuxQVO7GPnxczkRc29JpSd4zwhMLTZU2mknXB3FGS016Xz2xOtMjImetDF0fxPuknYWk6ok5o2CgK7+Yrg/ibF0HSfM6Yrld9dPAfEm6XSAeE1YxHFBLqLhF2+lekhqf8waR+sie9SiuIQJyfBSzdJYKnI04m6lTNVhN2LDq4KhOPiY4JuJZHeL4qmriU9HOlmO+awrG5UzE9YYiTA9WEZ1NRVNecaQFzkC8QeJ4zI1KQuTHmxtEwVj9EOfNmeSVWkEY7z10mvVmnC6BHn/p+9nPywmbjoexf3bNoa8/tD6JJxVGy4jNenOit0WJjc95A0j+9zq715YRAWZCLJ82CYGzEWfWOMocKCWwi6rWRTMWa47LYxBniUn8OlVCqBtIHfC42E/3b4j3iX87eKuYEC49tVjBbzVdX8QZ8s3SOUXE7di5S+KYcuNzbfT8DVevv2ATQ2Yfbt62F9Ucl0sgznujGNhDEAPKseYG59bQ9UV8ggy/fRQSGL+hbFCR1hyX8/qR69cswMASJ6YVWhkbzfiDrj/ivL3qTkH5RGWK2QfVzWs0x+UxiMcoPt9RkkvYHZY/sP7q/PE5E3FGt3djXzbx+oxy1aY7a+n6Iy4xDYSWPyGMLMutzSaJa47LtdH4l99+seUR8Xb+99rXlhvG5xKIM2PJjccfECKxAectry6g64/6XLaCaCYR6L/RNcpEdnzO60N86anWranE/pPPuy+7rBifsxFnK301PptIkPcGVHb+2lAwLo9B/e88z6hYIuXvtV9yJn3BxuVMxCdcnBXuEk10iVy/upa5vmBczkDzaxZanneH2JzwI9jAbx3dvtD9f2UlsQOIiATu16tib/FxuQTqcxykeTeILu3XM6FjacG4fALt/+PfOJxNIe51buEcJnyQiQx1qJhD1wdxZrDxYQkWNA53TDNrGZtfoftXrVuz5y6ozDBVyo+RpuNDXPu9l8WWGDj0ot+cPXcifX2QyP5yTRk2cbBupODcmUUb6PMjzo5ekBKSBNfWmjbcukTnr416a92ZmjQQWvdy14DdMrp+qE9jK37KgCsaVbpac2cJnNeLtO+dHI07DyA8auZhC6Wx8RFxHifxS8EjeKHzJt6ykm5/DMRj7hww/fgExP6wwKbZ0/FrI87+JMqdkANKvZHJfmI9mGAl4tomFpbKefB6V4G6+dxVdH16kPjS/Sr/fArddsMyTNZ8Oj7EtfGJxjdx4KaZlnN2js0PEZcQdd1cUQi8He8y7diydHyI895sDvxAwIjoPd3nKmP9O+pSLv6Li2BASLb+IiVJt//PyPi16rpMShGohKpt90+k6xODONNjhjWnGO49/qvGMXKywJmIsxZm/TpeAl6n961Kki/HBPEhnqXsqhlYChezRwwuudL9uwTq97q6pcqg4pp99wdlOn/ep399jm+hjlE5XJTDNvg8G5s/IX7ynM+8vnJol4zo9ps79vsjrrfd3c+rAqZuCzw5x2bs/gPxCZs/ZxZWAmfDxxQDTSG6vqgPt5iaVsGJ0RjjdQNCdP+LOM8b6w2uBnvJw3rbTtP9C+8jMv8xM3qpWAMp7Wk6fqozBM5GnKeh5tlQA9nzDExK98nS8SM+p6/854laaJS5XXa6px8XxI84qylL80EdqGYtHJYelabjR/d/PzrrUD0oDG1hSM0rxgT1R3xCa1f6l3qY6//0+ELJalywDvGsR44rQp+BwtsZ1T01y+n6f/jXjQ8w1E41QKBO76I3Ed/o/h1xhrWtbGkDfPyELfJZIkVfP4h/+H19cmBFX/zRWZJ0+2Mg/i2txtyBA38tih+uCxubfyJuZ3o0lOBATsEu/d6EsfEV8dxZTjsWNMKn/J35bZ6iAue9R+rXcrWvsBGGpujt/REhTeeHOIPb3r+AC7mYJPdyB/37xiA+p/C8rQMXKi/0Z9U5z6XzQ1xB+cLBYi6YF0zLNtBYInAG4h+aVz1e2gSRPFbPxi5hOj/EK08V+51qgnPPbUXqpeTp/hE9/uIoXlUTxL0UXe4lIUe3f8Rj1IQyVjaDScWxv04WytH5v0Ouz8pDw1eagdK2IHvTxen8EWeYvC1oboaW43HC0tNFCwSvVW21BajGfxX++7nCeUJdIwoPG55RUPDPxzpvATMQvMQJlFn87PdroMUNcba/38LQSW0d+xpidangA4knQzP++WaiVm9n4+/PKNzUdcJ5Lwzhv46LzsTNZboa4Ziq8s9kza8UWLS8jJjPOIVbMy9ohfVQwLHxnHPZkoW733D+sLCTgvlfbVUPNvpiZ90XcrNeUfDD//sqZr0P3va1db1DAwXWle+sdYYZWGX4uSU7KigI5SqbdcWyMNfB8mqtQgqcrrhaJITdwWZ7fXc0fkLBL2okaNkTf2x412mZoDQKOBHyJzULtbD7HK5STywF051ZXiqT/8SXc//OtAmnYFaBvPTBw7dwfbN5DRODKTD8pONLMfXwWkVHdoE3BYuGmvNWVQXiPNnkjDAXCjINzT92cpmYvn985d3LFOwOjv+0cDkTv6J/Dcs9TYGmUpthn3gA/snPV+37nxQQh+aDr5cPdq7mxGezoxSs/Tz3fMSr23iT+RQ3nhkFDHl1reGeMCwlz07R04CCSDWPGpf3Afgfr36t1DtAgV9JwvYtJ7yx575HbmrspODalK6sqZeZ2O2Wa4F7gIKQpKTOEf/bmNqRc86X1fi+++zAEktPDBIe6tYrUjDwXvyuzC4m1nq14/gOGQoshU/Bldzb+F9Hv7S/XU2BYqqIU/uwC9beJv4lUoxff+LEsnBJTZz16nXDjSUUPBadcdplkw82fXJXgvs8CgJq6r2CFjhjh+W1kjNnUJCdmnXg3AFXbGGOoujf0yjYfzatY+JWD0zx5f5fJydSsPcb12JzawA2uujYQ+FfJEwx89dgxnrg/dFBVmVfSbDT21fbuzcIr0lW35TYT4K/rP7yb0KhuM3LqU4ZPSQ0bgzR+sA5hQ9Hd6u8eU/CwuX1j5YuDcW7k+aXyHaS4LRfOnF3tDu2UmXe/oQ2Erzt111mzAvGVzDTpux4TYKZ1+LdAYnGuLTcsKTocxKWh+2xDd9wFb+TpPfqC4eEuWnFjN6j2zBZL2uGcD0J1LFpGiI2tzGjCX/0bqkm4dLke6/ba52xBqzoyf1yEhTmzQb/0WCsjfuiT7qEhKzMy0/rWecxKemNza8JEi7wDD4X/BGMzWwdCX2I8/OJPTVBJSQAT9wQef5hHgl7YoNbats88a02z+6/zibBSm12QXnbRdxFN/KwzGMSvppf6dk5zwOfHWRRHfeAv/+LkSVTVYOx11JPNu7KJGFquLd8zt0r2EjFnaZ56SSIGKzoaD/KwtYb7G4VSiXhU/lSPfcKFSxnp4n32mQSVNnHZN4phWC7JdMXnkgkIfp8qPXeLl9cpOV8Xns8CUkHKI0yZV/c3VA963ocCRkfZbwuHnLDJUpqVXbGkmBsfPhia30wvmaloYvafRKOLb3OTJljhJ1J3t9keI+EdSstCepRMF6nccMmKoYElzwVz/R5f+LE6+nn5vGXyWSnXMr2KC6/7Dj2MJoE/Zs8A80WJu4Wov/9Gn/5mZbp9WPiF/GzVj0fzvGXs675sPeSHvjZv+J3h/GXvd8Ziikt9cCrbLce/sxf5jaJWNZEsDCwaNO15x//j/gDeS1KV3DPiZ/PLODH48C2NRjpCcGUihQm9vKXDR2fp7Z/Po4d0Xm2cZAf/9Znj+TL7t3E5y3TMpDi56uySaM/2z4Yn1+/P9SLXw+x0aXqbpZMPL1i1c5l/Ho5G51+qdcUgvcGbQ9/lUTCBO9ZZrbpLCzUxvtVRQoJjz/1Fcnn+GFvYqS3dqeRMPq+LIKRfRz33f5kkVImCdutBk1cv17BNl5YGJrxgARXTbFEcZFgvHw0cLrZYxLWizn65CZb4N1ldVmbckgwyWNd/b7KEZ99sLJmez4JKd+HVm7bFoTr6bRFuxSQsM/f5oVjtTueL1R9sp9NglR9oMyvzFMYqy/WJbCUhKdnRNtVG52wVas6lx6tJOHoyiMrp5R54se7La7Y1JLQrNjR6bHCB1OW3dsT3kDCwqc4l/M0ELdYo/VwcjMJjYpkhGItCzN+pDA/6hUJj0zPOLvZu2HEyCVDhzZ+vpH+d+reuuCXB7mEQycJnso1QReW+WLpXNPQ6A8k/HjF2RtwhYXbZPutFyJJyM9oOfyqxBD/uVA39/4gCdpfEzRnxbFwdZNuv9Pf+fUPTlcbem6H77L8OXB+lARVb2OHDjIQ3zvtnkLWVArqWq1EX4yexRqL9rHEZlCQdjfox8+CQFxE7IVZ8TwKHs3IVMhwPoNFHHRvDV9KQchItLlSpz92uWHUKlWCv72JCCeA54bt4xjJ9UtRYLtMRy2z7ij25P20ECd5CuyWBjlucLDF7FlUi8QmChqf1Lou8WbiP0osDKcDBSd+jIJFegB+1Utor+wuCvYkn1PLmMnCB7xmCnvqUpAopJngHnsW84z72bLEmILZK7UlogJd8LuuVYs6GfzzBxU165n6Y+5Kbya/s6dgn8PENBN1N4zxeOKg5BkKxLUeC0k2u+BW4VeU71yloGrmLo08aS98/b0vC3Z6UMC9qc6Ykn0W+wo+7+VYFJw6HanfU+aKue6v+KkfRkFfIDdg3nAA/poVdz8zjoJrZ1d13M3ww/tt/WV3Z1IgLJGyBS/xx6RMrcnl+RQofU4uCZFxw+7kO2ySKaOAdOcoJh/zxrR3OJudb6Cgt1OjK3+TP76gMCJ95A0FkXWBBzS8LmAvWVF/Fb2nwKuWsaVo6iGs/1SATPHgfxBvFeBt5Ew0pTRlZma4XP4F4996V6G2KTO3DicuMzMzM4apzGxvUmZmZmbmjl2Nz9b5mPT5ebLzZmfeSHE/ydv8dA7lOI7nBE7kVJya03BaTsfpeY7neYEXeRWv5jW8ltfxeoETeEEQREElqAWNoBV0gl7kRF4URFFUiWpRI2pFnahXcSpeJahElUqlVmlUWpVOpVdzal4tqEW1Sq1Wa9RatU6t13AaXiNoRI1Ko9ZoNFqNTqPXclpeK2hFrUqr1mq0Wq1Oq9dxOl4n6ESdSqfWaXRanU6n14NEPZTXQ2o93KYHV5Ne+l79u4UZTV3Cu7rV5zmjMaRfv6BgUx+e1xiNPSNNnY123p8J0MLPnYJ69vzFCIGDFKafB0FR++NA64X9mStcCJyrx89A8HynrhGmkO9PGK3XGlOXPkGdTNbgiN6d4Qmh1Sk4Pgu1ORwfbVodYo/eXaxPY2kIHfj/HKi1nCgjwt9GpyfUKm7OY9j3uCyEWiUdMsw48ukrjB3ykaFD1YsHVCXT4r3CTin9ySEhPnaw/0pyeUSlnQMemMnyTmFT/Ce3JQ0q1ZtzafRyMnTb7rljst0g2wpNXet56i35MdsAU54CVwjmHXzg+oUI9xUGX7fUG9b8NwuEdMmoKUYep6/ovyVfGxJwpvGxgj8OI5uyD9m2efQwYghZlfQgth5JF+FeTPNxCvm40b2F3/31pMC2+M2r48ykUfuuGbhhc+35Ly9ZkVjmUxVp4PEybV5D/gkr2t/b3icXqXI8YXGtqd5EW9iz3uidzcltKWnK1Jq1yCJ3VXRAmDcxJj7PLGbvTcqd1jYc1GYauc97xQ4+M5E0eew1qPOLVvb8r/yavTl1f5A0Mkcfsw/kV1ZOfb/pRXoSmtx9qHZQZXJjytBCSWt48iW1V3xAnfzk0qPTE3Z0VZPTnu/zz2xsJOcvxpw+59GZJI8qfGFAx3ZkRqP6r9ZsLU3Y+X9p3f/LWy1v+0fETPfnlD4bbjU5tn2sUqDXO3K3/F6lw6JjYccS7iq3D7e5kuAZSoqMOncseLqZzGu/afWCFm7eRRaN6dHkTQXvtiuK9D3Rorx34ZT4nKb3eVLnRUUX9f2wccfToa0OWvPXWZHhwJ3ipZXVWxI7dX4drjToyZv29JqtLE78PO5mZJyyNk/rr2sbNSX6dwPv8qWWkipHQnOUynWczD2+NaVzi3ukjmbQ0Yx1LpKMUV8/eXVdqzTYN/Vk8lG1uenjlY0eQv6v59OLad3yKhcKtkvr/qiuYjxduObJsZ2UN8XaGreEd1RuRZw8VO50TSI94ZWHOUeTBYOm+NWPTCEJTUskbF22gdS5eirHgO2LSSk+a5VudwKVExX3+FV8Ptace3Wt6VOkrZYL9beZRmV0V4ZOi0y9kSwqKbVzX4mt4q807nJUrzGqla+hK/tNGGcgW4uPuBi5tCt5GxVwJNPysaSKcqpWhWJjyalzUvX2Q0JIx3vF7o45k0/B85GzdSP000atjtr2hH63Q+gZn9qb323Fgt42elUdm03yGGmznyZtt1plkvDWaitXq6vygajefTP3pHYd2HOPnmhfge154JFZ4+s2LZLbkn6gr1trb/O664pv6T0b7ler7O7X6VmroMZ96/u50cEDBIAIUAHUAJbTOACHlrnGWB1AD/i/C64aoDrA4IKTADKAuOC8AT4AXxecH8AfUMMFVxNQCxDggqsNqAOo64KrB6gPaOCCawhoBGjsgmsCaApo5oJrDmgBaOmCawVoDWjjgmsLaAdo74IzAgIBQS64YEAIIPQ3vuf+rWscYYBwQAQgEmByYisT0TbK0eUrTRbMt44i5PAh68hPbW7qz0LwztyADoC8ABwdAZ0AnWmtLg5cV0A3QHfK9XDgegJ6AXpTro8D1xfQD9CfcgOc9F+T/4KNmnzuqdUGei99YvOv0z2yXQ/bfk+2PZWte8tqSbsfrtis+6wTtrjEQlusVpkb/NQWF77wgY2vtve6jd/8bh9aC/VbaJyF3mfBulgH89J6FqrHQnVaqC4L1WHL03HaY5uOG4PPoUW/3aIf46gf+8W62DfqstdBfVQH6sO+sU/sC/tFi/OEcXgf9oP57HVRD9ajOlAv6rHFL4m6I1NrYaz8Wzz2hXmxX6xLddh1Yd+om+nPwvSH1sLMD96H+bBP7MveL9bFelQP6mXXk/19QB79GId+rIP9YN+YH/VhXZwvnA/7ejK/3/b5YD4fFubzgeuMOrAe1sG+UQ/WdZyvvzT03s88q4yXpO4f/OrE9Wxs3jOizZJRX9qa3x4zDfeq2lxKLhHYsm95P+nS/rH5Kt2SzdraLT4EVm1k3jM+8+sZrxua241rFrjliVGaNNi9hm+JxpJXTL0rbWsEmA9XaJPppKq9RK2Z+jEO7zNjXayDeWk9ieqRqE7UhTqkecZGk4qGtZcutfJa3LxRKzO16DejRT+16Mf82A/mR10S1kF9OF84H9g39ol9Yb/Uoh/jcB6wHuaTsC7qwXpUB64P6jFbPH2Ep58CJGrNjJV+i8e+MC/2i3WpDtSFOlE325+Z6Q8t+jEO77Pnw/VFPdgv1sV6OC+ol1lPtOi3W/RjHN6HdXDdsW/Mj/qwLtWHurAv7MfeN+2T/XyYmc8H5kUdWA/roC67HqyL88Xud/7b8V/peGZhHOS/0eGhOF/nJv/NvJdWmOt/SUd+po6K0cGRf2f9BaZOLUYH+Yd0FGfq1GXqtGX4huSfWX/C1All6nRj+MC/SUdZJk97ps5Ahh/B8N3I37P+AUye/s51hk1n+FnIY8Cf1FGRqdPROQ+ZydRJIMw1w08jf279GzvnIROYPMuZOtsYfjPDR/1OHVWd45Q+ivM10++wnYzOY0ydA4yO1eR3rf+wlkydec55AtOYdbnA6LjJ1LnE6FB+QYcXs/7DneOiNjnzpS8589xz5v43TJ0njI5jhF1/PL/gPgbPH7gPwfMD7iPwXIT7IzwP474YzzO4r8HzCO5L8ByJ+0k8v+E+Ds87uO/B8w3uc/AchvsxPI/hvgzPV7jPwvMS7pvcfmHkAwwEFGD875P7hO9ovFkeJPrcOZDphNwj0XdBhYaX5c33TofH7b4pd+wRd9nf85488lZ+NVn3UF79vmD4a/0TeUi/ehU9k5/Kn+rlvPdA3ifnUq71nWTcK3/q3Xrbw4TdsqX6gWJvKuyUO+hW/LDqrkVumbbobv22m+W2FVNj1lxdJedK27T+wuGFMuoYBBgMGAKIBAx1XHbAcMAIyo104EYBRgPGUG6sAzcOMB4wgXITHbhJgMmAKZSb6sBNA0wHzKDcTAduFmA2YA7l5jpw8wDzAQsot9CBWwRYDFhCuaUOXBQgGhBDuVgHLg4QD0igXKIDlwRIBqRQbtlPFMkJb1akc37AQ7LDG4Dxe5Cs8A5g43/V7+Eijwf1uzHx6Mfh6Hf/mfud/Gv+jC787r/hR0Hot/oy/II/PeuHsRywArCSzvUqB241YA1gLeXWOXDrARsAGym3yYHbDNgC2Eq5bYBjW1Pzv1++UC5xyhtei2WPUoOepWZeKo/K7eNRZlSUPGdg0aAtidFy5P+id4x6EyMPzL+y5vUBcXJomWyt9vkkyIXHBMErSa68Knr7mBcpcknbWCnnsY01cv5qa/JVW7NOrlGoXa/j/pvk4nu7w2u7PKN8ALzS5O/f5+6Xm9nGaZn993R/xOXq0TkfVM8tvavuUSaj4aAhh6Hi+kKGrGfLGXwLCgY+u69BM6uF4fmzbobx48YZzo9fbJjktdWgn3LTUCEgr3T4UF1pWUqKBJ9qOZ11jr+/2YDGOr7r2CKH28YZau/I3aFSbLfHlsabS45+2OgcWvTLkJdqZSzzffp2wA6A2QVnASiAVBdcGmAnYJcDl44Cf0Z8hZEBbEYrvjFMVgFBGFoY/gwaW8puQholJ21fbMBCpEtyCpukoijWlLBbOkwMunGStjTYNaUb5Hr66fQPCAKhfdcxXePBoLwEzyxlaVjUhW1dHn+ci8bopAl263+R2ZjMQ5tidD3m8dzMmJWCzYh8U2ZaxDO+T/+F/J1pfNGPp2vxfkwzlbn49QBpC7wwCrLm9SkdNobqcLFTh6PWB5Dry6Z3ph6Nw2cYd1aACSotiG49ivtMd6qCNBEpk2XZ2odcdjRA6Zs1GbJ7+Pj9MUv82+jRESJiwxEG3L4x8441wlbHUR1lgf/gMlqT3ZiVVYVm53neJ05nh80phKd+4uA5B65Otua4oTMh1cPI/mmGoKAapRYSPEn4E/93O3E7lodM0XIqnAoR+VLPllAFjvoWETftNKa3GpCxfEasvgACQsNoBBlQoP6Fs2sbyQxUZ8GSQma4tXCldweLZ+oS3F5K26HpBJycjeu8AF559KOq5IeEngn3J5dQKHOJ1KICFM2MEMeKsMBlvPdW4kLJeTRsIe15AGnxZ9Ayf8Ub/W5ujJfGzHcQ+0sKeL1Jxi6gl723LZGS+EzeSgv0XtcQf0CbeXPLeH3Ej62b5sLMdNpEpyJT2cQVtWEcZ7hyztKGlIHlBAVXM8fhIepfwvmUu5OWogp2aYpgZfASycY3bNZrpPFCBM/nyCEX9oV3m80oKVVH+L0kzYFlSOWto2N6PNLN21CetIjQibaErhhB14ltpN4OZsbXdlasMmG80wuSGqq5aW2Mq00lonIxvDiXhmBcO9v9grlREIrNH4c58udf3Dq2Fc832SjF2dGZW8bxfS0syHfCvHQppTWayCU8p8DmOBOf+DF6wWQmLrtA0ZYi/i02xezuKZDq4KVJKvIrPzL0ajzkDDIjqhyvyp9M0u/iv7YQ7n0u5HGvHJECUeR766Mscg+xpR0cnniR5Fn+KN+/wvKIAvzVVRA3d8cn/iRun2eiVnaavyVXYfT3OzqbwvkSdYZ3nw5wTu0Mh3+4YW2tSebQWFacT8MpZhfePsYct1LnisQjsj6KcFxtPj27dVAVmMYY8RGsFnZG8edmliedZPfnkWS/nkdPYBweK3y4ItnCiag40k5182zjeqpE25l1VoOu1UHctXOmQd8aQ6tRHAwPxnyDPFr2ebhXj0d9hTrb/reHNd4vWbrJAzGRfBS6XJjs+ApZoUtYjV5Hml4d33yLOdQnxUq3QKbLZnDaRZ6S8hRSJ2/i5DtXDteEo+izjtExOfgJRdGh6gWDsnzzTsCxYCX2zUs40xDKDYMzmEQNMSbsGGpGjUToXKLB6xhSDz8j3KSHhNZCtodcZWtIJOMnRDDuSzW7Qm5RN7wa7ZPj2CLti22sBDZlmTwOT2e8YTbP20ezco8s3x90UzcnE9HJSYQvUME+1BcRPQ3GRk1hvW4S028UcOvHTbYvmIh7gRlKey+SZ3GGUQahiLR2s9DwGO5q59BJE0J8lgTVhdvoiiiiJHU1a0pjideq4FOiJskRUTQYOyNj14jvsRacj25gsE6Lm9eSaZJQ43eA+EAt9maO/BB4iLyDKpYWuSwf1sW1L509OR3IRTaRHKKK47FuRpdJ0D9HkJoP01lyLwbLqf+gWSHCGuOvTMqJQWPufVqTprDWIYHn+bGIGYxj218VzO3zxf/oaMKlfCiJ24inxztavsOFVZspqn1IkmMGvlVVPBs5nTttShw7l09hqh9hK2rpsbpKSUgnKa0qNPx3HoPtWTxtdOfk45ko1D3gxnxduHWe1I2RPLAcjbxSGqtDgqgVisc3aSz+W64hOVGB+odK9H8cIrzuF+E5Q3zw3YVg4iD6IV4c9JBg6NAwcvpC2DhpoCAdhln2t994usU/7h5EO+mglruNA29WoNokyWMlE+bbLOaJVyWqZY/I3TVEDNcR2PWBrQ1Xme25HNuJz0nffgAvm5W4WTRzbsMI1plrMePVQzTaipjkYY2V6gcOKicy/W4h19Q1EX4Yw7c7L5Hsmc0/Lh+QHfZDfFQIxw2VWFtxlVmx57h3/QUqVqKk9RkzobaMwJynXKjLJ1kqm9Lr+xB23Y6yuRSymBM8uZW3QmFMFrPntNFxDuU0UjukgNv8B/iHL0Kg4xfpuZdxdl3LKoUE1hZtRak3izdbz9L5OJoxZseZpRtHjKU1kw3uEKIdTfmsEXg3hPGk8QG5O7swc5jACCE3jt1O4W7eU9abr2DGwFiifQq5IahHnuFiBOv9aV5azhr5fl6X/suXDiMC7Bu5YF9NTY4aMWcK8dv8Epf3xbTWTiJD9w+WSS/DfI81z7O78IgoIUXZirGmP5imb4xN0SHkh77y+XUHcwJK8Ty1GOHmYobfHMfD9R23h0qIFM4nwGo3bql3qfC4hL6PPyUTXOmpSkT+zybuP8ngIet5d3cMuzPm8TFwJ7urjzBGQpF90uIEOUYxQl6SK3t9GRrKwWJpCzVBmvxXM4mjGekUnRlELUGWNo9Cooo1qU6wIC3hPlXlY5kYroSn5SIULcI5V/me17PScduRhL7CRSZYlzMktoq3nQOc0HPnXZgiX18eYDAtkZafz1Be/AQVHRu0Z5syteZf9g2KMrDKFZVp1WxMO8Cac8fYNKccBfN68kpeIyZzmilej3CJtmfB1p0YbPhJ8IRxdN6fwGBZF4uylH7rT75YldOwYydOJy4QodHCE6lH2Gy+wFvLLNaHllCtP54G7xUoTWvglvQ1ZisuY0vHG2r2nuXypjzWhvVjITjIx79vEj5HE+3UOThF1mP+JYn9C7Qp/XyB9WNiOKdxh8Q3Y3ERWIHD3VaCD8dz+H9n6HumyeyIe/jvX8XZqtkYXqmnfrk5b3fr4vTdmF+Xmtjx0hp/pxgyUvZi3n2dhYfnYpRhzhYPYWYrhKGzPJTw95/4ePklKwcMGbb4yrRxpRRvOUJU/0Je5BczrriKuq03WV4cxkETW2aH6aH4dxTjbQ6h8D9/QhSnYJI7kcMLTvLXH+EkFH3gY50/RboFLOj8Ro/T7x+IyMXhxkKWRN4hO0CMmPX1yDbY4fK2gfNRMiTIR+NcKYfIjzRMr8xizdlSvPbbERQwl3Hp6sR3nWCyxWdmtwlz/5ICnkFmxMqs535fMvubXnO6wQZJzZG/a14h9Po1fH64o3N8L/sfJeKmvp1lsttg0Q+e48dgpzkjtpjR/P8u7gOcqv8P4Pi5VmSPKKtb2YkrDeoc36upSerXVPk1KJJLiwbXqNBwNaVBaS+aqHM6V1JaXFLZbsvm2hlx/t9T357n9/xb57z63In7zPN5Bwkx+IvP9pTYk3EztrvAgzBx1u+9Je9F70Kmso4yanVmb8c13+3EenTkt0ns7U06Nk9MrpLmtE74CTBRTWj4u8/0yHpbvxBdaEz9eUvgZzrlUZ+yd3s3wKSLdL/pfqb3HdYdebUQOsTKaVXmJ7rwYa7qnHushaJ/Vn+in6jZO85OgMaG75TIfaLHTBs9PDkIWiQ68Ob6R7rU9MoZd09oD/ml090/0i/M4m8udYTm++dM7i6m9SrO+z/QY+fXB66dL6bne7303NDdBbDrsc7HZhbT7rYJj3xLoDPTnTubP9BVolVvySfQgvgZ+ac+0CGGpe3/nodOoQxM+R/og0tn6SwVQgtnyb7WF9Ef/GvzT6+HlvKcjE4U0cfDr301nw0dU3Y416WIjpqpNI2xgRZZWn+pL6SrqfvlozWhe9zGBpwspD9XTZgd39EJnZXk61pI862qCqaXQCfKTkiaJXReaojYhYLWKh9+JUlCx5lLc8IvQWeu96yZLYFdhWIzxRjo1gMzRzcW0KrjRhjlB0CnG+yYO7uAXjLc+UPpYmieFjHjcj69MvrhDMsp7Lx+hrpcPt3fM8z1ERe6dZf1Je/39L1Ol7LIIdCikwoc8Ts6fnDZ6viWDvj8sUutue/o+vmqKaUfWUccMYh4S4/N1hJ7U9CSD+9ef31DZ5btGGt2BVqkY8ef+YaWkyS/H30EutVk067rr2nj3dG5q3ZA89w2B6i9pr9OujMnfzW0eOZVblAezS9ekBg6i53rPYz/9Io2e8vke9lDC9bhmfgreo76xR27hkN7Tz6blPqSFjm7TM7jQKdkLHFQfUm79px8urCxHd7fbOe+bbl04Y0RckM/sn4ev6fiBW0zkHG99xk0VrTIdtYL+paR2m7jG6yjyLj0HJr3SM87+DjrOf5njHLorovLlvXtg+ZfFi05+Jymp5qcfbAJOiW0J6sjm6a64qPOL2Zta57nnU1PVX59M8MFmvtzWXi+mH7MvzGWY8POB+dU4GJ6vOu7U6HDoIXzSGoZTZ/9VWTC5UDz+aeUJz+jVd0WzOlsaoPudUk0oOjNG+M9u0qgU0oW+vY+pfeGLdMekwvtbc8NrXhC11u83b73HrTQqjZHnEU/NrRV41yAFgc/mHU1k6YEj/ekx0Fjtx9wjmTQj0mZedwu1k4z27bDvX+H+ROPbIAWHgzQWPOIrlxrKcpaBC29WOXl9pCeXzT+sgaATvFbUOr4gC7r1Qo+ZAvtndsTyr1POzxqsuIZQnPXJc7SuEenTYgu6x8CjRX5belLox/4L9Rs6WoFGH/X3CNld+j8ZJvVSt+hsf3fm8hb9KgrtutnFEGLdfixF2/Qholf914Ts5ZzXB5zjS6c9DLKPg1a+Ml3TdAV2lk3JbH8POuNc+K8UunqWs+0W4eh+cM2fJtzke63WmifvIedN0aKgy/QI+InHn7kx9rTs+2fJNq2t+lKywrWEQXriFO0yLbw/Zw50NjNw/1Wx+gbd1pfvnRi3cvd43CYvjE+VHej1e/56okjomm3bQ2WZsNZNz2X1wmhT97TU1JQZm0WqqLgTRv2WfwcKZVBi6I7ZIFge8O/z40vsiYmulYcBHZnItK11kMLn79IzT8O3t9pwbvN2XmsXnbyWVCrmyCfV98CrZ1fkn4R3Lr3NkR4F1rMkayKuwLOqp2/ZLgdWljCj/K6AR6dGRqVMIX1Mpmf5R2wNMlbRcqBFif+SNyRDhKf7vrBedMMYPrwW9fi+0A+Ya9q+zFozOlQpd1DkO/V73PbC1q87OAKpcfgfNWam7aW7Nxv4s6yDPDe1t9la3sTgJ2ghdNvZQG50GuXAp6xVn/6KuQpCFCeHGBxCJpbO153OgUUlq+mTixn51VBDkNpcDj5qeMjC2h+wthhvmIAaptaoroaAZZ+LHL/7GyQfap8x8ALaN6b91stngOruQfUTE9Ce+Re/SyfA2xdZLlfN0JrOeI51TngUMxrX7fJ0MLd/pOevABzeSaj5qlAtxZaOR/PBWGy9v115Q3Qw83e+70ElwhvB5M0aJFPUw//Fbi2/AOoiWTnhl3iYXng0DYVGX8ZtLB7iXV9HrCcd0tkYwvN75Gb9PQ1KGw/rpvCgcZsjZsPvQFGeLlZ8ud6gEk4XotWvQWie68Uze9Ci8l3vtbvgH3+6Xa7/dDebh8ndr8DO+Zdbnnixc5nTaCy3wMnt9rzLydASwsyOYfzQY2nr727OrTIQKzyTwE4/5k56llTB7DMkTpbNCRgL/YuOZ+GlhzXyAySAI2cZ2XiM9CCAxf8iyWg32DMTcvt7Hye48FJhUA56cFtzB3abYyvemIh+MdlY90cG2jhOynTUwi85TpPcpSgN63/vHZFEbBOla43/1oLsOt6KrysInDnUcWuB8+gvadrBQ//AJ6bn/a9eRZ6eFOAxa4PYJmSQfuQUGheWr/7xw9ATfdT+Zul0FL7by3ji4H/Y3cOplUD8FXTErbIheEnHy6Qx3g1wHU15tZAH8FDik+oYx41IOPKpwPXwo/idwIXDsEENWC++RL/hl//4nc1qweZ+BowoLFivmXYXpLMXT8ES68BnLIKt03ZcWR3tpcpJqkB2sfnnDcGUbhLt2IjI6sBi8d9NVQQhpHC0wc0MK1a4BmqEuTD7MF16n1/Mfa1wOwgZfEVO4z7aUdUM+61oIjTtjVBbispOueriQlqwfZzS94H/fIlJ+aF9THxtSBKoetC9rMIvOY5d5BJqwUbN7yzNggTkNhr0MwU1ALjQ3uUg4VCcqehRT0jqwV3e88HWImP4HWp5xQwrTrgOP/HoqLwWDze9rgBxqsDER28x/WDceS5bY5KmEcdICdu9KfpWPxl7DQuJqgDO/Zod2ykD5EKoV2NTHwdWPaWuLQViyWrFcjRWHodGDpP6lSN7SPjjNR+MAV1QDGZmRWExZDTjyb8YmR1wEmwW7InIgp/tbbPFNOqB/IPq3cmuMTiWXtm6WK8erBTLnHeQmE4HjikpYZxrwd265jS1rB4slAHr2IC68ETJ4tTNyMFpHrczE4mvh7Irm9IMBIeJF3sEiuZtHow+fjKOCn/IOnTPwe+f/bn92y2cj7AF51r42Kt9WDoqhjLmyCOVEqfqY1pNYClZcvPuDHb8b7up0MwXgMYHjA27tazw3ioyWktzKMB8EJDKt8MxuBudl0mmKABlN8qIXa6xpOejiuMMVED0Nn5PFqOPkrOc3G3wdIbwFrA4AoDm8lC07ufmYIG8FAg0ql1iSRDFBa1MLIGkFqlIXVR8sNXqW8sZzQbQdbQkU55SivxZW9uDjL2jcAEH7PdlBNKVjw5Wcq4N4JkmwObtJhQ8tzGC2aYoBG4uB+QzGTicL7+wV4mvhH05jw/tWtwL+7+VqGISWsEL8a2t1gy68mZXq5FTEEjGNUwtSWD2UJWq6zvYWSNwEvV7rS8awS5eOejL4xmExjhl3FiQ/Yh/NuyvjbGvgk0v+QdkQ1uIM2+0xWMexPYMbuJ3ASiyZ9ZS5qZwCbQJF3cmhoWjX+MPwO//02g7VjvEaWobXjSKPNRWHoTUNAYvuHowCby3KwTlUxBEwhueGX8LOwovvPFQAMjawKDMcl3nJ8dxcf2JOljWs0gaGXW9YR9O3CTn5rqGK8ZlL0SbBZlx+IvNEMbGPdmoDa4PHeyxnLyx8EKO0zQDGZoZi/4JAwnb0ZWjMJEzcDLa+BE/N7tZJScfwmT1gzC/h2VaxJ+GHeevcUakzSDxfeY+xc4MXiXaMYPRtYM99I8XxZhW/ET3bfeM5otoGjzOC4/KpyszPMsZ+xbwAZlozfZ2B5cpj+tnXFvAYtunUi/zgTj2mvi6phAuHf5THZvW/cyUp25oI2JWgAnT3XNEWE0OcPgSjWT1gIecad/VMJC8IvhOoaYpAUc81rq3SPnQb6Am5hYawvQrpm4egZ/Pyl3ZHcXoykDigkyZ4d+d/JV3A9TjAf3yrW3td+OiMNPTIjsYtxlYPqrz8WuIA73n3/jFxMoAztCEo075daRri96vzDxMjCvdldn4b5deNg3Kfz+y4BD6t6kEZxA8sL3XcaYRAbu3c6f1xIRhDvkSH8yMhlYeVDAmay4ldzqvbGT0WwFZUON59wJiyOX7z7Qwdi3Aun9Xzmbw0+TBuq/Bhj3VrDqxNsJg/RpPHLBe3lM0AreLv0ujsIi8bq37fDnrxUY7pj8rJoJIDeWqXGw9FbQaFFzNxwkkE4fLnMwSSv4mewW2rdPiA8MlPUxslYg9v8kUFTYRZ4aeKKKabWBdaoB0cXCo/jqzh99jH0bkE0a2NBHn8dLkz6qYx5t4K6HjmAXloQn/TNKExO0gZaqb197B47gFkssfzHxbWBb8NQKHpaAr8AJHSy9DcRw5IWh4WfwjAvWPUxBG/A9nHxrfO9GEiuO62RkbaBx1bXzdPhx/PKBQ2qYVjsYvWogwV+YjMtP3y+P8dqBI53c+Jw5jkd3kwzj3g6C7ezCajk78dJR1l1MYDv4Vy1859Nf4Tg+5bgeJmoHY13l8DdywaTu+n/0sPR2IDey3TFSeIyc6jnYyBS0g/YKd6cwJoY8dSdTFWttB7muPI9FzH4y7evufkazA5y3WhMThEWQ4Wtvw89/BxiWkQFWMwnkUt+raphHB6AiD42ODD+Jj/rZr40JOsC7j+ovnmBCPMt+Bfz6d4BF1+6POw9OkNOKKhWw9A7wxWmnwD98P77s9f0upqADOOjQWlPkduPDH6bDz18HSPe85xMQnoh3po0fhml1ArP9I9ZO7vHFrQ/NNsB4nWD6oorgGk4Uvv7hyVrGvROsjL2fuZmJxaU7FODPfydY0v787D3xSbI2O1DGxHeCYJsp7Sr8s7jCtWc/mLROMHOfOp3BnCCrLLUMMEknIPwqgjaIz5BfXVo1sdZOYLx4v2ps+Gm8cF6FDqbVBSZd9gnaqOCN77ZU1Md4XUBl/Jj8fPoUOV9Q3sS4d4HPFxUVg+ViyRtL1sqYwC6gs+G1Rg19FtfRqjHARF1AJEuLyA2LwY+5vJbH0ruAWI0equyaTJIj5phgki5gPdu83yYikYzdnVnLyLqAwuZmYUbYCXI1we6hoz5GjDMxw2BHn2c6MlaCD5bCvXQxcogVRe8srqwoQBabEtbsnno1MlZCfpuyIvGY7K9J8sBxuLfOIJfYU6njOn22a9ai57Olctg99pHIYl1CsaDhQKQ9Ms+J8mT32gGyGKN+vfs8kXJHjrEn2tg997XIUnnCLeDWPTMBssSScmL33oXIWCWJmdx2yhL99Tc85Pce/F83k96SnSp77iHzuYQjuxefjYyl4JMOMOv8ipBFFtRUdk/+K7JUjqrLSYg+2IG83IxaaAT35hXq0P0dCcMhhXeK9P5akwh7D/fozZHFoyjJtCzT+ZOQJdbEozdwr342stZsglyVbNC5DNl7NJGWAPfsNyG/GE+dTHUofROKjI2hMjfCvfs4ZKENhS0PuSw5C43e75hL7B4+spUj0Tfi0xPFZ8gPpxFR0+FefgGyxI6a76O8xk+K7MGlhoTAPf02ZCsrQsPWSjIoV//H6cbUKXZvXw9Zqkj12t9cnGOOzO/C576Ee/yTkbkGxN3EtWMz3ZAxFeotu9e/EnmTOTEqcGdSpT+yZBJlw+7570PGOFTqmN3fHeP/ehyhoAT3/lOQLztRscziBU/vI3tNJFa1sR0A5EwLIjdz3ojtn5CxJvIo2wWoQ5YYEHIdQ46s6UPm6xML2E6AWgO6fRfZnXm0ebcpslSFsLSD3QAecokNsXroLOHracithtRZtiPwD7K3KqG7rjNuri9yjBNxje0KhCJztYkjdtmLBw8hi5WIol+wM3ABOdOaygycOOpHOrJgLBHBdgdykLFSXGiJT2E+/vV3PLWI7RAgi2wp347RNfP7kT30CVEG7BJoNP5xsT1xIzZpSz4XWaBDzDOEnQJH5NkLiNrZGcOiZyE7OVG/uwUrkLFE3C+3zXrrFmTJUMKD7RiEIwur8PtzLNsPH0MWK1DybNfgCrJAnfIJTMqQZiKL1AmG7Ry8Q06RIwIvduRsrkYOGUllmsDuQTtyihZVf9/1Xyulpj/ma1PS3x0EZKkq0bKhr9R4HDJfhbJnuwh8ZIkGNWygL2T2EmQfZ+KtBHYSfJG1DKnH2TGx1/f8sXDmcsqR7SbEo7mbIVX9YtEyfioy9hY/wXYUMpD5HCJWP8BO8y0ytxXXeQG7CtXI3h341FurVg3rQBYpUSTbWRjSjN6fCtGXpzx2sRGydBi1Pw52F+yRrUwI+UtvGvKmI6dwiITfHQZkrBq/WLOubucW5BR5aiHbZRAil6hRIm8maPVJZHEnfpftNNxAFjG4edSUT3ufIQvr8Zlst+EDMreLpBWNN3ysRRaYUE1JsOPwC1lPn1qzb4S/r3bLH7upErWpsOtggZzPJ7xa9Kc6TkXepEY8ZDsPHsg8FWpTgK+Z80Zk7Ac5g+0+7EbuGUJZZLzfFRqPLOgg6353IJAlP/Dvb/Ye6MxCNtQn1DfBLkQBskcXrrd/+KWb35H5L3FdthPRhyxsIZVcHxuf05Shz28fuT4LdiPMkeHna0dwpdvrKcjYTdyM7Uh4ILd2kgMzYkLH+yAL3+BObFdiDzLZh0fiZnIlCcjexeRRtjNxDVlNldL+eGzSEwpZKiZPsN2JD38srNKiWsbY+JfWo/n0Fvz/ryt6Rq7sM1RF5j8g5dkulT6ygQ4VKTdVb9MoZP4TfAvbqbJFTpThb55q2xVPRua/ImPZbtV0ZF4J7rukO3jtQmRgSK1kO1YrkKPlqJMjcY2hG5G923DDn7BrJUA2G0aMux48tngPcko9KWE7VweR+TV43hCfbuoYcghG/e5eXUDGEkme88izr24gpzD4rxi2g4Wc10fGbfk+s02MLC7F9d1gF+sdMleRKFntPGZqCbKkj+xgO1nfkG8bEVdvVK+9IkOuU6Bai2A3qx+Zp07NG/PZijekDf08teGr2I6WLjLWhPfarLlVbopM6hMf2a6WDTK/Dt+n0K53fRKyRIOqZztb05CldbiTg/vxkwuR+Y14ENvdWonMUySqc4KWXPZBdpIntD3ZDhdysRWR/PTkgeIwZIkidZztcsUhxxhTPqsnL7c4jdyqTVxjO12pyG5axLeDuj1n0pCdZ1NLVsNu11Pk72bEdGOrk/Z5yNyh1H2241WMLPyGO/AfrqmVIosbcCe269WMLOIQP987RWf3IocYUfFHYOdLqf2PT4wjTK+HTHymg4yV4K6VsPs1EnnCWGKMbuilyrHIPSOI2n/ZDhhy3gjKUi+yf+RMZJ4cIcd2wRYhu+lS6fmmQfvXIAt0CP19sBPmjyzRJjSlJhM0QpBbHAgXthsWjSzWo3hPE3Y8SUAu0aVUqmFH7AJyujJxVqPQJ+4W8t7R1JQy2BXLRIa94l7DXc5huchCLapUDnbGipDhz0PosA0jT1UjczvJAjvYHWtCTjSjRsdQc4t6kXn6lPljtkPW8ceTxlOqV1qax+v9sbBaQGV+hl2yUWjuNpq6VH99aqYdcqI55WMAO2U4ssSUsOz75rNuDjJWQWqy3bKlyCU8Kium6pLDBuS80YTzTdgxC0L25hKD203HWIT/tT7lxHbNDiNLh1I5LkFG/CTk4BkUNwV2zq4hc5WJk1ub6PBHyEIXop3tnuX8tQwf/aV5xg8JcooB9fR3Bw2ZZ0G8W2hcLWhCvupGHQ6DXbQ+5AqceprimzNaufOPM82Jk2wnTR9ZbErMmqVi2T8G2VuX4t6A3TQH5MQxRGNWNOgDyFgfPoLtqC1EFneTnKJr07hef61K6bNdNT9koQ5l4XjIJyAEWcojMLazdgCZP45SSDv25csJZK4aEcx211KRPUwpTmZAw757yMIhxBdrtsP217rU+GyDTNf8v8aIcrbLVoEssCVO3SqJGNeILDWm5MbBTlsvMncEke0wM9xVuQu9fmXKhu226SNjfWTDIlC3zxxZeS5RthB23CYgl1hQhre7O79OQ54xnio/Abtui5BxN8Jfu75S4I2cbkZUWcPOWyDySldC48XXcsswZKk1Fch2344gK4+h5qsylsrnkJsWEJa/O3DI2Auyc/f1fu0nyMo8QpXtwr1GzrOgwNEzopklyEmziC9c2ImrReYbUW8aK7ip3cgCAyKT7cYpdv9xjwUx7Of7GpthyBiHcGA7cmbIkmHUI+sRJpWOf61D6bJduenIwgay7yg5mOWJ7G1FnXaEnbl1yINBxNHxyq+yg5C5k6kwtjsXgSyswYNOXLjXKUIOsaZQHoT+v/4CjbmKP0Qoq5bI1W3GOHUjMY6WH8bpgkcxNHuuz8U4efCcvXkxPHLQBdt/L7RVRBfaDvnPBec8vz+3U/nv7dCF7arognj2sZ3gYxejx94ArY4uoteEf9nXsxrO2dv5waOH35/zXfB8ud+f+ySy/weP2v8JYCj4YxxdeNRDyxfsfUTo/uw8E91HH92HnafAeSKal6C5wX/mj/4z70Hz4f+Zv0Rz9vzzf54Lw1bw/wcPqS2S";
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
