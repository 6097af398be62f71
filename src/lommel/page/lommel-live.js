// Made by `make page` with ziglang==0.17.0; SHA-256 of the sources: d48004504b7896b5b951406d8d6a25ebc6fdbc2070ea93ec1faff1019110830d
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
const wasmText = "eNq0V3VgHMfVH9rbvZu73at1qeWqqfc2cZitkEk65UxxXStcllVbjiWDbEmh5qRTLEdRmMEu3Z3KbbhtOIYwMzOXQ+VW1vebWbhTCv99c9bumzfvvfk9mh2T9t41lBBCH7KG6VJClooiBlkaw1MTRvCm+o8WlxL8sWKRFpZytYDngGLzAnhYUSxW0MuFQkFLhQt4UsXBA3O1CK5mKHE6oK0MDIC2isFQeEL9AsHeA2BgJ988Xj4+EBpxwQekROOYYFrrDIRMXwg8UCALWr4QeKNwGZoLQs8LCqcGUcCib0ivWlpb64tAgWj70VbCl9RvLRXZh3ywvx/AaL2f+MsKcq11pWf6cDVHG+B4+nEPtINoqHkYjNAfiOt3sBJo+viYhqW3CSKPwFUjVAw3iUIMsXCt6MMIl1QcI6BVpk5JNVd6t6oWSF0Yumw04IIfEG1fT0M+hlaOHNJG4r6RQhS2yJEglpYm+pW1RDEaJMyhIuM+qcXNiBvzeX4SAl/1urZGC5GanvjmQk+1Bf8d1gvGREFdUdFeoALdAYww5VHdojN0HKIS00ajsAs/3/pd8A1HFQCDOqB4YU4HdBdBsdoZRd/FKG5VSNrjqNYNTYT11o+I6BfTT9qvyH6QbAH/9CntvZ1tvWvb1/Wu7O5rW9fTcXJnxykH2stWdy9b1dbXuaaj7cSOPhKPre5es6ZjtQmpnr6OtSQRMMSK9s7VRPIL7I02IcmU7TjpT6UnpdUwhOPEY8RwhHSkla7LZCbt9Om0nU4TIgzbmWzb9cKRUwxDYNj1lHLOGGbBPzAdjEkwY9F6y3848jNJbJBu+OykNBGCxGRMEkIcUh2GsTMxNCXriWGJcEjHsj4nqZSgp7p21tsFPGtXc9puu4s99hRT9xLO3vvsI7Hvvlm5n9xfyjpj5/0OsICc7757Xd0ks+7AKXWOlM5Bgk0/YJIjGsX0+oMtDDApvKQEnjlESMM2hBQY9QZx1J9UHkksKMdCUj/t2tfEpf8g9j+fGIc4kwV2O1QchkRMO3zyZI1g6gwszaRCzKgickAJRIQJxG+WRQFXKj49EEGRFhUU7jhgYcFw6mZTeG7sLPGX9o0Qp5FS+A6WNUPWz9ml3jCaRJNonpGTTbB3YF2LtI5wjLxhWBal0qb1cAI4bamGcOphBf8kcdQQglv1e3KLzrXquHmQZdJ58zMZanHOjQULj8zk6exFn188Y8oXOF3SOkUe5RxN7c85Vt0xU+1p1hLLUWHHoPV+OWXMjEOhT2W47axpol4eqz0ic7SMIzOzFGFbYo50FAxKAYNDZX+tknTMuuM45aY1bZFcNHVqXd1U63jJGIPECb4v9hdNaTXSLzm2sI9wHJ798lesr9qOpceCry34ivpnWAu+3pahai+JgDm03gGN8FPZOE3KSSohqj7F0iWNtt1ufWNJnSmpRGaqBeRYHEi+/FVmWnr/Vr0/XySWOctt25L4J6wOx5JgMsuqt6lNKbW1AcsQLJNZ8dW2JRY98csx1Gtm0rTZs7l2tV4bMqyMSqWPDMkRBrEMWssSxs6fnM6GAF+Z4V9t66Rfzvpx6Qq8FFaGr5KrrWaHCmexlMoN8DUeZnE2mTI6HaDlUdPm1q2Bztq6GTOmTJF7TjflnjMzpmUigJmMlHk7b5p5Kh3zeDSXPaGSWlFLunJV6VqildrKYUl0gcMLbteHwcBPxT4MPcj8cgk8pF4aDq0SGFOnTt5l8mQLo8mSOn5Wd2YdWyCdA5xpjZlMRsDTTF4FYcZ63QFSuyVp1Ypw9l9Ee6RzmHWUbFW7WQJwJBZB8F5IEYqYqGpDVHzt+j7tlZrAI82TylEwIQXJQOwkxXNwnKJi6+rqpKnw11S6Mi44huLD/HQppk/3lU+m9Sf7oTP1HCVmwb059JRTrdP8rbWhbr3txHS1ttLpzMaYomLAreMt+c06C4NaefhUW3WcV+nTW2FDV+8hKi6FuiBa/f2WtW5BY8a3QGkjtyTn/f2HWuiqKCs+7GbROLB78VATEftSY/MgbRQUAphBJDgbJzz9AwqUpHar5NNVPQpgACLrDIpwW84GOkQtXasSlvQLSVPb2Yi6ekOFOgEQjeL06aI+qpfw7RDDbk0em9ZjIz2T4pEepMKk6+iT+BmCkg0sdohZpLnBwUFLFknuT8+dod9EPT542p9sfMZ/f7DNF7r7WczNC9lOsTUda7p7TmNEtnWu7ezrbF/d+c0OIkRPd/caMkrjvR19bas7T1zZR37oT05uX9vRS66hfF3vCnItlctO6mvr7VjWvXZ5L7mZSiWyrLNn2WoI3UmTPtnW0dPT3UMepnb32jYoRBKP0NTajvaeNqj39bT39pFnaVyt93S0L1tJXqIJyIeyr9B4T/vyzpN627pXkDepHergWtG5rIO8Ra3Iyh+p+Mbqk3rIX2hC42lf09HTTq5IGcs71vWtJJtTmr2ic3VfRw8ZTcUC6oep+IWckhyVT9CZc2bNbp4/t6VpXv6IBUfi4/CFJa1HHX3MsX2/oL+k28ULxkvGG+K34u3YE7EfmX8zx82XrVesN63b5O2ylCwnb0venrwneW9yE/0O/R4t03PZeex8diG7iF1BL2clVmYV9kP2Y/YT9lP2c3Y1u57dwG5kN7Fb2K3sTraVbWP3sPvY/exh9gh7lD3JnmJPs+fZC+xF9ip7nb3B3mHvsvfY79jv2R/Yh+wj9jH7K/sb+zsbYzvYOPuB+KH4kfjqT8QG4xzjXOM84wLj28Z3jO8aJeMa41rjOuMG4ybjZuMW41bjfuMx43HjCeMp40PjI+Nj48/GtbHrYtfHbox9GPso9nHsz7FbzdvM2807zQfMB82HzEfMl81XzFfN183fmb83/2C+b55tnWOda51nvW99YH1ofWz9NP6z+M/j18TvSdybuC/xQOL5xAuJFxMvJ36f+EPij4n3E8PyLDkiz5E/lT+TP5fXyMfk4/IJ+ZT8e/KfyX8lx5NnpDakzkydlRpJXZK6LJXY8vK0jfZiku5Nn5w+PV1I96eL6ID0GTS9gaaHdEOgLYZp+iyaHqHps2n6fJq+kKYvoumLafoSmr4UAiw9zNJnsfTFqfSfU3IXwppzZA+29dkzRsjcFCEyh6Qf4s/TQ2gkIq+hEGLNLvrKWpAiLskTPV4vVrJE88edJeDT3BmndmVpksmJIlgYm6wfCxtyG9YpESq19JE11pby0NrN6xZraw+YvuhEESx8sFI/FjXkLnEgAgGFwey6uqVxeEtFPmeZdIAV6QDXf3wAVskdHm9pHPmRJwB2vWfUunFEJVj0l3K5rtxg2jUasoZUeO7wYlrT1MuWglarGYs044FmvCFrKU12h5fQmtJfhiar1Uz8J8241LE2cjscFR0L6wtSvosVl5Uc6cZzD5/SlU1CKK4XYTVcdZO5h8x5DRASMLc+m3JN/TZdqd/CTbTQ4ZYd43o4Qy2D/khvzCbcGJbgjTvSgjWi1+hGz3a54nOlBA3PGYBgQMew9glxPlDw0mC6tgvSBQldN+Y64EP82KsLWVs7mHQN1+rKXdXd5RmrPCtH4QjYVq5pETxKuNbVw1nuJnJbEYNVV49kE0mmXD8PrhtarrlLRbSFZDlWNGecLAaDZmNg2sGCerl2bpAqK54zDCjxq730yEaFabiFHH31xmwMYNMjWRul5gObDwTJrOEmshz6CfC1/dwSZT7iAVyAjSu8QNoFzI5adbnr+LY5VP2fa7qpXi/uCliHvF2AUCwKClcGQfdnHS1su4l+V6/1I/bFE6DjZIE9K5Qg8jovK1rA64e3RRBquwalzqXLW1EwsM5P8xI/yhW7PHhsw/OWbQRWtet24Dp3DYU7a8Cq3jfWip1ip3kc6ykKHTqiHkMQzRWz8SSrrUTgC+wjVwg19se2ouGWLFMl7MZXoZvuOgV1jKmi5isqbIG7ol6AiocqbsfWvAWF1Zpiyhi2VY+Rjagtf2wlG71wD4+pgidlL+ypD8wKrBBgc1lZd4ORPhNKBEi1zAfj41MbK7+6rSrvADR+g5ba1xxqbcB78NSh6iZZBt3Qjjyc0mIOBaV6e65yhTe7ODsRkHmIFcmJrizcUBHBMksSiWDphMi/MsqKKsC5opZT4F2yEG7nqEv7PKqiuqjBo1A+0SMpgm2IzknOdckqiI2P8/W5fijmUgtVGYJPc0ODoiuXPlkpQebqFggNDf8oSwEw0GB9HtuDXfccTnOPADPg6UkXtNN9LunKFbrgwSFwAnHKAUUzBPVSrqhOkhbqVg1rz5VNeP2vZ5VNCpsQ1ZMuxIzWGKSOxNL9ekljgpaeBe74XuqokBCjiitQMNgf54doJmY6FjkFjeWwA1uYQvwAMkukq0LHu3wHPjkjso8KpEzXo04TUcS+hHiAql6qG3M0ayCTPDdO1yNvrqEe1DW6cF4SvHSXUDSJy31NoTVhTCpZICsii2AvbND1It+LGbRIC3SAFnlhF1W4iOgqj+6qSd1nwIdyDyrxb8Usg4NhXW7JojbCyTjEoBH9wm+Zqz4dGOZ6fNL+/vj5G4Q6N0Vu+8vP7+CLUxTkDfdsH+dL4Is+QLi2+fqOlv3e3VLKsvzJs047+P3Dfzs7C99wqqhvHXTQY+Om+vwSQDIlVMkxqRhU3z/8H1Adbl4Oh0NsCnZM+lpvcyQFC/6AUQKjQkJzx4a9O+bv9NemStjvTS75YelfzBM3eVUYFYQXmY4gVoBRnzYhp6kG9B2wX4R9qkEjDk0hZK5L4FeHsSQKPKkz6Nth+Bllj5TxzBpSJSDCU/FiFXRk9Mvve1d87U1j59xZyR9+9LvDDz72+JxSJX/TSz/97pRHM1tAnnncjikl+uUmkH9KfwqjDG4YlaaSZwa0hQPVNStlL1YOOPUq9bFKebSSjSnsCrbm4Mwq6ypQM2Cs4M9lYEVpF6hBmxNGVVSwVIUfUiqviEDk2eNblqWollUHY6kK0A+JiO5MWUPbPwwlBJ4rVvncmObWgRupurGyNojDtRJshojFSuVIIliZCBLsWgi4FroEcqp0rHkNUeGX/AiwmtxElslWmJXq2Ory+wiNloTN9L/Ox+RfTP5WmLSoeo4VdPed/h87r9pDTH9WSo+V/tD0JaQBU3/8bUsRn74QAsZolqCSITDuj7+Ok+NT3C++Wq1j/WSWJyhyXwrt6vEc7VM9+4CpWpX7vbY+xSdWLIdKtY9EsMPjz1/7my3FL6dITYvpYqkJsAGf9Lnw5p3TurBb5mR9IY/VWIsQv37pj0fvIrCn8lCbPEyr6SgHTr926Y+HtpLjG1xjNItIcNVx63Pf3bZ5nKOA3OFAzBnauKUmlyjkm1SrGVELq6wLzKOmx37VQDeXRj1jYmNWPNM1UCiecEXFM8YynuWKMY+6Fqx8795TH49vvqupMpZRQvn80XNem/ThdvTDq/yhK5bPuw/9Cdmx5LWnXrDzPesfbvrSpd5luy58smnsAzr2EfjiH1du2rTphaZLj1PjnYDvWWOAjgctlQDQLJfgyoTCI/IVzjiqrOYgVDW1yeMRR11m6CZPRIyJx71y8xtKxKXqJVyu/pZ7Bj4hmjYavGqulTGoIB2gVA7zD88srvhu6d02HMckmt772YpHVTVV5/pGlB5WsL8Hy9Gv4vHNmo31zQDDFRKEuewzS2rqikCkrDRKo+XI7KijqjrC5y6biGL0EyhG/39QVBypzdQap270+3fjEK41jmmNcWjAuP8Bf5IyVpPepizVh8bEhJBNftbvqP0W89y2l68a51GDf4TPInVZ+hy1iQ4DrEw8E0erczjE8QW/aqPQWvlzX/nMTivcK7aW0kMXQD8Q3FqsVKkslfqixXwRr2rdJaOlaifJ8xmnAwyHo3/60VrUzD+LFvoHGGAEp6TmE7Bzl3449jTL8tojp/WIyifN4G6gJB+CJOSgzte6wQlBWwbDUcQxoRvaFcCIttYtXkEHP/eHt58m16kOfuGo9+58KP9rfFZ1a29/duGRSz/8OxbcXT+45PU9dmAhf8m77c67fEdTqQRbd2j7hSH9sgpbPGVTFZ5RVhZKKtDggFLNTOT9QqivBfvvNzScprXO6XSWhI5Rvn7f/LH/zP69KSS24AQsHtegu7pB31a1DQ7l93eoatAT2Fb1QJIsOEMXpdgnD38sobA0hEDn4XGlo8kLBsWSmk/T37aUqnRTzQUEH54cw/2IS612lbJAq4UXqUXCFMJMRusuUUwOJpW6Iv6DJmnWmiQrtIhOIy5SbvDL77+6a5/8LypbKvnNY68eve+rV6uUrdncd+1H192oyPWf3mXHvetvV+Tdv7sK5/ADILPquK/a+NSL3lszrr4Irv0udfKui07/SROkj5r9eGlF6npFrnU/f88jc29S5PgQuWTXhdsVmdLH+TMgs7FqEhbr6zHv83QeRkjX3lxVu4nLSwUypZBXxjmr70ub/ZzqbLqRaPnfvgV/EMK/6dPT/2trqQyG/TRY6HLpj3pq6yjK3brD0HxhgP3bhD5rA91BZai2wzfV3AKBOfrl438dS70xm8HwyA30pNffX6gCM/PClb/cY8P3VciPy4/Yx217QHH7u3/HJz37tObqcQ+4kaENl+x3/T033whDX6LnN6yOvavk7j/nS99+Zy/SDHLRvud8dvcZfGtpQvlxF2ex0KhvePf2cQS/6qsr8OOV4EJofjUzfbcfXnx7qezpU5riPxwNjgykfwNpv7PXDemWLpVDjVkQViVXdgXYo9qaokUJxsulyECpatfPpY5kc1fUjaGr+pIxlglKGPR/DCLuGqIaFH29CMMaBii8XoQxDqMV8sOAh6EL+WH0wziC78VwF6m4eNLRivo8EHlBzKAD/gWX/h913wEmt3GkC3QDM5jBzC4Y7EcfHRpwUnymk+KzSVDpWyeFyznw3oXZC0r2KazJpUhRtJz4WQ4kzTN3l8oi/eisLMo556DzJef8+VF0onWk9OqvaqAx2Jld7rPEuxM1C6C7urqqujr93WhMLMzhSseyxmkRugkXH+hyNadjyq7vSrHSglR9cGemjQYXsmQAK+J+mCW9o2jJgC0ZsCWd18HtuMcrFUs1ab1+cvKbaDOds4mLQLlSMbofppj+T1IMjVepCbRyTUWtpdiZha5iaVQZExqNPvK/euFR/Za2Q6C10wiUY7wr6eVBspk0sqgUA1fhptXBxpN1xE02AK58xUnqgwChci/e5yuMAJBaYCyffpf1jtXE4SYCzsZlQWJ1uPkmowC9BT3uPRSGd4LBqVwDe1MFRAb4y6gCe8v3IydKaRExZXAZjW1i7QC8PiaEbAmfOobnmPBTHL+z0AD/SF/j71krwxYMyDHlrFoFUJWXBhUj8EKM0TU7pYHRMEjAqJ3OqVXx7LPGAo13mkfmBSRGBiPZAVjGMRFGYzKXIRxUw3DeyUwY9QBwnsNEQfybDIXC1n+VP4U454GhH4GfHulp/J7xrLwsg2bLU6kYH1KSjiQm6VYvyyWooBhpy2AOhotj76nr8UTWj5d5T72KYz5yNTr63EveSHGeF4+R/9iiJwRWRvoQPrkO5KSan2yVO8CC3iLmz38E4B2Nk22TzOmsfk5Kc7kYVXLyhBN4AvnkxLM4tj1DsuFJbnfw7d/28WawyifD+WK4HhVCTsTjF2U+YpC71cOj/N8sxV9q4kMTv66J7zSpyNDxmMVO9+Bxk7krltnrdtSz5TOwf9m/XJjMMHk1LLFhW1oNeKz8WhNYXlPlOhhNfmh9J3AYTYiorJGvv7BHK4djjBg3AVytfXFX8BcsTkWr100U4MzfEwrj5m0tE5YAzcrzSeuI1haYeYiEZeSFv4W1ttXr7dNv2BU39Lglzf5HPOJQ6MPKz/TF/oZRNMi4hLpTy78mFvcgaQuR6Es909puWmTbG9kv/bOx+GcUopRrt1vUGUPpMhXd2CRZEzyTadwTES3jkQ80mVHTNGDQtEFGtCLwKp0saYr95jKTzu9tjsFSrFI19rfORiEkuyRTurte7kyjsqS6gqaG1WyL5F+bmBAJFEJWUc/TNqHlvvdLX33NqolMFbSXbXilLZ9oouyoWpTyRDiLd1EeXpoFx+v9r6HqnMUzboYC78y94/XtHNOZyboz2YghJ7vmjmwUETcjYsZQ4snX0t1UllDJUEHfZ1rTM9miqYyCWlNZbEaoeGKCOheZrumg9+/QwJhZ7C1ZbGYWxCCh1FP0H48UKNfWDKVuiSjfY3LcfQ13xIWDHyiDP8vBRfhHy/B9Nnwq65JY9xRWa5EoUjmk3gT5+y7r5StlzBfkHwXAWBrE+VJTVoZfFY2lDXQEKDPnjc2yKJtF8RrftKcNaeKTBWKq+dCO1JzBSrNHxt9dCHoQd2w4bh8QtHkPIkWjSbnvkH1QPAxT2aibOQp3U3vENr5EbC0jttiIFul8Ux5Qt0o6N8iYCDdkH8Yaj9Xf4+fQNPdMrD5x00SqSoQda3g3WZ3UfeiNKJsp1LdW/JsKTVHuyRJVaVOVAxDBPNo3Kn9XRCYFzWqf7o0a34M18XUThpzbuwBkvATk0RoiIzLxx30/mCjh1kioHApycBVBFBpi6GL47K2bQcvhaPavpOogVFnAg55tZVkK4lbFVO4zg4rcjfnXLM/CqQwTGy0FiZk2PJaXRarYFk2T4vI58WbiL4caUw7o4/4NmHg8hGUospmAmyHr4v1uxRVH49pKUnWjCIom/wCWr2R57x1YvhLoBJM3sK0sYOncry5iBfW1IixXu/UiivfnXItS78u0g6V54U+7tSgZagKXxQoS/RV+yi58cXeu6mtKIWYL5b9feU2pUVlTwrQ3C/vWlEJeU4LNFSzFIUZPT4/GuCWRZ+hHAakup3bV5SQ9cDkJ/lhdTeIB2ZDFGc5I11eaUKhumUkQgVPFRfRci0NAB1X/4hDxIk6oeswrFC1qy1PhNHOeKlAbDcjA5QPPBm++xjt9X6+T1eeDvPqsqSJPPkB35D727iSJIkMI4SEmDHJzNmxhN07kG8mayZu4Uw6Jx7pRO9A2oU2PyRUN3imY1/FOEj4oGBre94jfRr9nfKKggKCHET4GtceQWY4EBCZNAFivrXp1gVlvyxTWi1FJd3701R+gZRy0HMnNEJZbSF2ua61ElC4alZtf+BsMTwJ1xx8qkArEM40C58i+4CkJ9ilFciuysKZ+fDH8/vcNGH4n78XD7OC3S/BzaLQ7C5U1PpvFJrjnGiQwfjGMf3qxsp9jEd/DXoMIf7x87UXJPyIJo77Kb8qo3Cci3DBNpokqCzCVCfN2wWY54gKjc/8VGHDghrqd5Vlz3PjY79Y0fi+L8n84t6s5Lm3ll5nIgANRYbUva9Bzg/apXXZRHvWI6CdoKmnE3ki2s/01y8nVtgmp8Qc+i2F+z7SWm+ahNilH0S2KgbuUusCfIqCSJ6mALo3cv5isA68HS2ZAYqSaxZQNab5wb/YwRzgUg2/NaCYiblJzIpKf5nlo96IeT/lksrNbiuhjvh+sK8ynyHxkvIrpMi3GU9Z4uCELUx9Exkt+jiXbTMGIsi6jx03Yw1Aw9yBb8k5kguzsVpuKTgHpVIRqpPKNYiNRctVL1WydVKmTcjqpUqf4jcoPoYpCefooT48K0neqZVFNuRbKto3RUVm2rbJsW7ZsmUGUxSI2699ezvv2AsjFf3zTMUFRxA2ENCQ46AFu5hhoSc/kdlAO5YemR5V0jR6Y9GAKawjfNBCgqF0RLSlZG/SxiZz/+OI/gfhPS/zHFfD90ji6+lGzQTCodoRU8OPGFmyA9bVxo3vo/+YvWFr6DIpQ4lspWH3kBRtUC/bxIOI2SjwueQ/r/mZVum7ADLOAlDCBVSAwPgbSVvNGqTlFhayPaBeKkOTPmIazG/dpp/u1a8BoqOggRwGGqJYNeR7Pmlz2YNiwdd4oazQU/thyvm2cu5wMIdwtC5AJPeMueraVdGklba2Ezqhapfcccav7H5v6W907IgZzyAD3bXyBHavlr/+0V9x+s7xrMWZGNysupnzZJhgxWL5fu0f4koC9Z/ne6UyhQOEzlEPV8Fve30E7CvhuU3hp4VVnAtILS0aYTOjZWWWwrsuMndNoSvk345xhGacATokgWz5dirDztY25ZMi0kF+Y+ZA7U04cu8qtBmSlKavwSEUl9sQgE/NwJo5IzaEPwLYGZSL7tu//yrOgh5/v2/gC6MaBu78RlMr1BisHeigHkwzUriZdlUjPYQJ0fM0jNQGEQCbIrK7+vDYK5rBRg6SIpMwn3/+VZ5WGue6H/6LnLXakgGlg0YGmcVLXzTK/7cI5bNckqVtHbDuIiVxEzqrx5rFucCTWbcxhXTSI7V68G/2La25UsfROuoVoYd6HR34Yt52yfQmhbVsSYli0JLIxAWGXYRgX9aQLzuwQyZcuLiDzYAzuRkKSVdHJ+NImGlWu7rre8CPaDwtpTSEtSKlxXAaQ7GSdcMK8nXvJXkT+GnaxLjXqRC/J0EsazV1AIGT+xdh0CiOdqlkzUC8zoVDxJMEW44MbpFlL3rSedco92SqvTYA1bc1zX+agXY6uS8OgqwFCZEskjfFSQJ67FOMRhY5iKUvBsxoEsImT/v6CKcSu6lidnKw8pz6Mwfkk/8daIDelKSHNpdA7iJHnIOtkuiprUJWVKVHOVlUROShFRgwCRGQTyow9ELFtYsDcgWcsvn0n+MaK/19cBuR2hFQN6tigR3zC9Mt9hfu88UwXXlsMJ3z6I1uK0ecyyOZLOWZh/tEv8C7pMP8i35Bu97vlKk1GVKcYfbjj1f6jReBYHUPa4BrZ6zIY7DTvdFxOUs8zWrycYI+TVEJPVBQdroBBDwYiiSAbyfjERetL3B+GpBCqX/454gJUJqgiqF1n81Y/UtOWoAni14Qq7DdAYOM8qA8dL+vh2uilTfseywQHRDCOssbxeBzEjgzAGpMX0n+ccOtQtsasxX76YIAlWqT5UhMYXJ9mAjjc/zJBgdtP+ieTJcgIMAEZHiYIYIkI7gbzKJleNwGT5x4bhjRedFVhEREnIJswjI564CSFjFlomrgfIhyEMiLkPMIpES4U4SIIF/ULF9WFE8GwNBFgZe25CxBCXGW4ZVzmlayXLdpQZo0yQ4FChGNGlAfUKCASsdbTYC25Ne72hKoNrU255ULcWeIH3HQV6cogXCzfc1hfskMa0rXijWF8te9Vql3EzoUQnxJitQ3ujwbJh4YJXPokMo2P+FOo3ZAxEHHmAEqKa2IU30E1uvMtD4wFYMOT6KKEJ/od4hfHt0CMx1oQNa8gFMPzTZnxaDzUansc78drKCwjStP9Y5Qc8mcNE9IF1a8h7QUedCdkFPHsfqrkVeCK8lG23cNVitnK+0RIxYwyTt2XUHotSZwgVrEVuMQ1l7yYykBpcDOwE/wqADU56un+86pKq9yHV8+qN0h2ovd8sEQy4nQCAp5HAHRHwaABhcRSPEulXI5hox6DW3ZCVxKeLYC4bnDkXK828S98369avG5vr7S3V7V30G/v4P/X3rWEC7E3bGHN3mcS4jDcKKUx46tUqXjDKh1adUxDVJZ3BBpnu+Cqjszw+Wh9rbI2j+eBF6uAquUqU+BqGNo7a5wVMI4vrQwpXNbLZZln5ZaEAcOUs5MZX7SVuj686MMBbhd/1X9UbPBf0QIyjnqCmwHd/UUe0kREhZgOBuYFWDlaEH2ch7LxuWiFirD9LqH1dj+f4BfkBH5bhwieFngvYm0v7dk9EcZLPso3v/2o8nNDwKYw6Jd345ceXXnB79GV97Gyx387vpcKX26OLUNURkqDxZYCyLTgIGXTLeeNGDZFdkwtF8z5O4yvcfKsmEHa6aPF2cjz/3RWpg7wHpCDkhxUXw4KOQjCjQpdy8GqtfE/Q62Nj51ab9K0yhzSxlbIYvw/5XckLyJi2YiDULslP9N2Wyu2uAW8kzrZYieZOn/yK3JFQK5s4F+5+aaLpfE1fbv5m5SUE6YRRzZGAq09X8fl1tjR8naf4LlFUm2QZWUj7I2IB4W8RYE2tWlvMY7K9aW0YeR+avksnY1Em48kk6ZnmrStPx7AMjyr+sZXhKRMr8fsDqVd20RzXuApNAk8XwWxibaPOnVMZPeyTtNW69G4+ljqSVa24n4W4hJPE0lDv8JuskSn58NstrtLFm0suzsZenD9RKrci5/pla/d4oKx6niuXv6XwAFeeEnuJ/8mw9LDo37bQUHFnJLQEdT8NOQ6njaA7vC0UldHrpZnFo00Gg3SWwcxJ8taPO2UaWn73G4oi1ueaZk2XTphQSZtTGRaTGgirOmAzsMtfmP0GFAyx3AYncQGxJPYITawhjIcAkYeD+2ESUvsGSEW1JEBIT8y6XwCChfdlz89FRkjQhesJK8hXCCy4zJUoKCj+2UPHGkwXPbOfMbt9Bk3GmbctmWGAMR2RJZISMZY3uHGksS6kF6jgLK4T+vY8W1ZSUCHH8VrUDErEOI3BgYUjB/W/SisJWaD2PwoZrPnU/wP9FeoDnIEQIvuLkbzY7Rdq4m6GjNfNErk/K2Uk5E+UITtg5WnMG2hCkDIHrFhp1ZEDd5yQEPbtMT4QKSRDttyY4aC0lYsFYCeQzyHJk5JmUKebgCMjARRpQCeCOCVAsRpC5G2NqFORpKhTluwZiVHyYlSeJUsNLIo9qkgQNnGIchHe8m/CzKpiiXofOIiktqExDVto8ZT6Hp/DIYonKZSzK2qX4EkHFZpESIMak4wlrUtK8QinB+bomMkjJq4wNKx8AMHfpR8m0wgVguErlrbxEYdl4YoO2NZzPUo4liEc4qGaUkBNGpZtqpZBkTXKLOMZmUZCZdZWXZsrbGGAJGhiOVEGZsOOXXXWI27YrrAqsrxxIW5CR+IFIPOdGFLcIlYAC66WvPrxzJlqpWfN6T86tXZFo43R/kh1pVfzOdypMrWtoyri2CT1jnG7AJDm/OkJ66lXBMjOC4OUmghBLkh93P5Rb4YtU4jGSIzG0HBPldtTujhgWmiwofGQMPxEeIRlGpmm8YawVrcKqZLP/csBv9+bpkGPzAr+HrWXaXrBQ0bIWLr55xXilKIBfbDYO5rBcQYQHIcchFhNsjpk68jEhXQRBCE1JMgbrZSH9sLNLc9FID6biuwIZtJL8/pUs5asi0XWeJvNv3OunKkYPv0LECvHuZKFjt4o9QrqOSw1T1r8HFBhtbme1mTFg94ZKT+Nm2SWZpoHykKvLjXZQ1asvaQNY0H0ktR8BysL8VcAyXSy9o2Ios5yj50wKGVdm2r20W4iW2tzwgN9inPLvjaPODrBSsED8ujI45iBTIdLqEW3BSNDWY3HBuSlqRjBipKL2m5e+0WbTKL1qZmsiuCNbG1smWFWjc7tbiJbcPhqiNsdQWTITsxKYyfdsjw0dlpA0SaTyay3T8uTfjuCLYgsTFx6fDiRxNFILtiQRngD/WXabNU1zY4sqV/oG2bWRu2bWOvTUx2ZaZxruB94cvgZqZWmrG9lYzaVn+XmdjbFg6LG5sRuPMIcBGpOOJxmm6yjrWEkiZsNOdmDPVThOpCKLR54IeSDeyqB/Sg0jEdXt9A2q5pyZlRdMMhWUipIvJk6S1pkY54N0ghusE7sGR9jEbSbow2lcs0RVurXkJyyixCfAA1lO5HpVFFaHH6DofBROMkGCpTm1WD/tajRO4YInStVIUzxSnJKRm3xZmanHDd7IRh4UwhG7QDBw7posSBR+SV+p+PNLB0pNbqK4N1aq2M3WX8qkgP2+T6sGFA+QdkIIUmN+QQ7IGqNLn2wB6OzCTClh4SofSEa6aYr4vLyCllLBHguXwtK8BFBkTuwC7mQIUxnqn8lxqm04cXpdFqavDp19agafO+7tnrMGnswvwirLN6H1woTDG6Uof/EG5+eNXhj/mHO36N9vDLsu7hJ1F1oj+bDi829ODjwd90+Mm+iQ+fl6JHi6hHo9COsqlUkfrTftoh2ejQNREQXhQTZTdqtWMcHs0zpbDRPHweZZC2uStiStPEnEstRKNWoQ0yAFMwL36k4Wm/goaXzalhCxq2jkTDFjRsn4eW/Dyp3qZ9xU3sxkrcQWGIx0Hj2Yh1jBFxjDY2+rc3UNG1cNfakBET31jTxpiVr83BORtZzh6TT6rco+zoib3noEZdMIpqIalDbDYivcrzHrUqZMEEfxYRQ7xh1NEFJTwtp3Y3tsgJgv82Gx1PE2kCRnOf2sHiOLrRPeliul8C/0KYEMhWs8V8ZF9zQ7YECsKmcOXukZYysQzMEri8Cbigu8PdNqoWajSgUAO4bfCouK1ZYhaf3/XRIqMUjT53j1myybQ3UpTKA+i52CxZ7U9kS6SkRsnKSTrq6vgIxiujGE74zoBNMb0zINeJwDRrdhxfsB2XcGUJhlaWrqssC7crKkvwqFSWWXYdg13JbSkKrWLdro9h3VqEioSKxfYflWq2aLlYH8Xn20300H0R5q1gZFqXkwutvJpewbt6A5ckhGizUPlGGjWOoFghShpCEitTYPuwgDsdyom8o6OdFMptUXW5dlQMyUSiuAhHDwXlTPvym/KVl2TBHpGljfRu3z/ECCAGCVHpj0ZYDGvqNsTAE4RiHNQE3LkhsW9TydYcSa1lPNY4zQviDzX95jq8K6MGoGbUJ4cOM7NoQWA8OxSgOykkzXbJ/VFLp0ASoOuWBNoEdv6GW/xkUqqEQBtvOJ3EBsST2PWBZhwCRpKzhEreUaYRbdEW3OLHtPNKKNr1CUBPRc6ICAtWktcwLpDZcRkmUDBL+MDRBsOF78xn3k6feaNh5g0sMwRUYTMhEdhsuLUkcVhIH6KIskaf2g3HV1lJQIcfxYegsv5omHgMDCgYP2KmKEwVdtOGH2t2C7JAGHMqCCDyMDuXNBCurDOEy0KbceCyNqFYnZYkiIsg0zyMwju2eZRGmjF0MYNYl+fnqSrepmbQDTWsgLDsYXp2wAnQLXRTch5TUrQdYjbRj1M+GLQ3KIokABYvsEIjVQgEkAZ5fSKKc59TD4bSdQVK/6ZA6T8e1Y114YQaAqdfJnD6XwmcfuEQOF33w+lIlrWO14wu4RKvOYvx9PapmkEfunTCgs44SuBQsWmvyaLloPTwYHDPQK2QgbpGJkk7ljprA5Fak7WQTiI90zF4BJguIQln6DghNpEMhfKIhasxEmklUgirPJK5eETDhIkERwfJALGjucVeNsymy8SmyXCbLptlU0knFiSbRizogoxk2RJjSJ91gf05vrFINIJ4UogIR0AmrCgUYTGSgGfJBUIwACrWGgSfR8Phc1XC5yGSiQ4RayQvzVbwc+IDJ67h5zFQbYuf24SoyhFRAz8Xhy+nXyEjJdFA/BwSWCt6ToLQAuhSfVALI8nRYzShkqUnWVEKz+YxP4D+rSqAjjNILhMAnbjOAtAHuUqr4uthUUvDwR7lSfqKW3UcG0RZToyIMydRNKqwG+X4iFnIfbOoGs06ma01YqKOJJFcEY8Ijio4ARQvW5nIcXJqSqpGUXEagzNMOL3LMLYZIsJELgcTS6wYRdx5tKwUiW34OkImfp8srxB2xBLwfHDnvAU6R4z1GIHOKXBAkVRLrjWs5GzJeMNKTqIsp8HAOZWhsLCeym4lea3h+KgOnHOI9TdUghpyDte2McOhc+s4a2rQOWwkNk87GsGxmBE2q7KHupxBhZ30ZgOwc0RKXwsatkME8w/Bzr89F3b+HURKa8SQn/ER5LDz0GLnIQIafdi5dOtINwQ7/3JTN3Gm4yD8XNfwc/2o4ef6UpQ/Bwc0oUrwtAYIqEQIfo4HMXo/fo5wlNHc+LnLozksDynNuJAIBT4PgK4B00pi7li7pVM4BB2iDUHQJbnNW0BPZDoMQW8Jgh6hvPoQdM7VDaXQFXKmtp5HdQhdGj00RGsKCL1qBUDog8zbqkLoglY3HTjNEHrX1AoUydnSVQh9kMnbFZOP5NEwDF1ZWzSkLeOjbAyDp6ZZShWSH7SM2JddvV1F0cHLhGmTGz5KDQoIG5FPZKG0GiBomy5kbhkUkfQjjRItb0uBo06ifZV2FKGW1kcYorxxYo+q02QloH7VfcRlKGW/53Shg/MclqbuOd0+zwmt7ZTA5aoGl/9spOVPaJzyNws0BxvN0Khtbv08mgWaRxY0F/PUUfPIGW4WbA4zKUTOgs1RgE08i82A6uACdv2wORpPgc0fbApsvlQgc/rFGjTxMNi8MwA26wJkjgU2nw2NEfTswdkPjx0+NxsBSNa1IBk9+HgQkKxDIFmHhEswaOsOBsmo8gMkE+lig565OwwkE9SLKU3EOPVC1EEFEMEHZABlBmGAR6LehXOqJ9jq/OrZJYEYoF67APViQvDgyEocQaH95iDqbKxLBOISMaC8eEMaF/BeRkx8Y+2KofTkhCBqo8vZV/LJgJ7jEjDf37SAuQZgTmwcYC5YOf4sNrEDzJkSPkZN52g/YJ6Mp4ukFUgKwDxG7U/2pEvofqkFzGMhEMB8SQH0LoWCsCmceORIi5gB86VpPNBhAy73EXbYVrVEWwNKNIDDBo+Kw5qlZkmB6qIB1Wty/5I9ZukmE290y0lLzFIAu0ulpBKy8qI0cbV7FI1twoC5M2AkpncGjASLjmp2HF+wHZfKosPQmjIypKbMb1fUlOBRqSmz7cpGtasQl9WN+lhWrMWoRahVbPxE6tji5db0oxYtp0fovrirSow6i0u0vG3R8piFyjcTqhWeXW3/+2UqF3TagpY7KepoubZoOSQTiWIJF7Qcypm4Hy2PkV6ISrRcxAhq3VC5WBgXaHlUQcsvc2i5pKqi5WBi0fI7m1oRfKaHIOa6DzEHV03sgE7iElJ/ypA5GGoT0sVC5sjeqJI0ykLotCbTMuHCg8E9I7FCBuoamSRtWGo+oLWxJlNVXKxh8MjZSlDCOTpWiE4kRyE9YulqjERciRTCKo9kLh7RMGEiJ3c0QO5obrmXDbPqMrFqMtyqy2ZZVVeRsQbY0HVBVrJsiTGkz5rY2+H4hiJRhHhSiAgjkAkrCkVYiCTgyVycuQIT1s3lzC6y2RTa5utQNWSnC9Yty9qVJlhbhfJlFm7y8gSjWR445cUAriVKij14AN6uQuRRD7WgBpGHqKIWIteSUPalRhYiD7mJQ88dC0TeoiiByNsgaptWqhAoe01rEPkGX/k0SK4fKeBOeVrtc6uQvKU4ztXLSbbiCNl1PKcnBeFa9u1pdSzZkg7EeiMd/DCZBTh4lj/0JCFrX/lCFcWV4wKMfCJslgRGyRsXqnqUyiNygJUqjlK5qCa9V0j/1KuFd/JdAQ0sg9R76iY53BaF9aZN4JZ8DyFo3I7VfADR81SUKi47J4kVfkJOc/UTZk/Ws1v87ylOQMTJDnLSSv/Zmji0kE9d3DmVvAZp7WEiWyMQI6akN0JePlOSXVPJI6+1bwvInRwIiEP74k2+wkGDlQMGq8cxjqIFV10fua3ubMp8tPQ5nxU6GtOnblIlBwWiV8O0ip99osP5ltwzySsckoTi8IQAOrQRQ0ZiIY4Yv8vX8vkufIvBF2H6z6ndFvF2pboGqV+8MT4pBMZ3h+EZ31kDzxVrcDpK9e0mUgkdbF2hdbe72O5IFMv5uwpn28cP+xoi+3N/4MNJgzzkQy6KLRIga0Ua5yQBXpxJ/u+kLahUF1T7NKhYvOJgw3+KP372Q7f2Xjhz5l+9+fF3fvhD+++lcwv/9IRztu7s/vbKqULdvfiUhzsN8YG1d3zmM8fd9oKZM0945JUf27z7+TgNcevGlc89eN+7cPvnP//UHb/1x8cg/a+vXbM4/sfrcOtMIB8Y0e4kwpn42lAF1HNTofwHTJoF27mvyAL4+OsQEk6nDRgHVnmYXRvlI5HFeQUmQDbyH39cp2mIUTidhbvShuywa+xKw1i43BcQF07o930GJsLNZPDirMUu+n68TePle3F135O89l8/OokjPPKv2fgtHyji8324zac+SH+J8kfvfSuYtZcT0X6O+SzHUEA7rvqXP7OL9LX/0BUcM4O/Zoovy+SSyCWSizdlXIo20c7QX5DiksglkovXVwTu1tpOdP2Q1RXXQbra+C0fdrriNp/6yABdOeaziBFdYX3+Isx2Klnzq2gKXZGmjTQLVPmBlVMGB9Gnjdg0tvPw4My/fevq877S/cbKGePv3BVv9309UakmMzPkqxNf+szvnfZP3yaf/+GO46/9zrd/jyoKV4ZXPvyO3/7mkz5CNehLf3o/HQJ6HE7+vPEgTgFdT1+3kdNI3eGeodHw0jE5J59o+QMGoDG+O8WTXXmaxJk2YUG7cmZqOn4DZOtvBjLl0mV6OgtcNB8aWn4Yb8vjPkHyPUSS/sP59z/+b+7/LUj6EmZ+A9VB0LDGM0z9xVM23/v9h26+h77w8o533/O2H6eo2Xsu2DF57to3kO4QnDyWzqCNb2kHaLtC+YbK8NbLtYjrpmzTRZXwW7rvDFBPWjUi3pFp+rpW/Rzag+tgLftw8qr/jVruHVI0xcgPwtWAq5Xt4o4NwZhlgV7EpvLKm0mjKzb33P2OP0Wn0n++rf1C2OQdZz3h8av+PFXGPU3B6HK/b4pMjgMw6OLC5C3GMjezak1FGqN3Zc0z33b9/Wec/4PHrZ6ix8NLTRMXfJnht1/ys5dfeOipq0F5c7Qhpy8q8GcsosM/odhfe++1658zbRA7+df37OBYG/OM72Xv2ZsgZu+Nh6crMd+bvuFd96/7eY7D3i9atq0Ss/InX/jZsku/hJgt7/3x1ZWY4/74jis7t+3JYY2LLvrrSszWT/7hL19x8JWI8a58ypmVmJf8dPK87z94Fsfc/dnHVWJ+eM01T1n93gbHTH7331e5mOCB34l2X3PfKjbM0rdVYi44/e4r/+T3ehIzeV4lJnzmz59yXTeQGPnmRBpxl3xmETVzZpF8ij/wYZnQU1ZY88DQ3A8MlfjAUC0PDLXMgaHWPDC0BA4MLbUDQ0v6wFDvODDEqySm8MPCO9masZ3qYG9L5YOV6F7lYFtTfnfPHmTs3FsOHu7/gMkOOWq4MkpKVs0cAu4HzE+9z1FPly/B8hfG7T8ZI45obL2MK3nlXrJfxtcdXQ1PHrShikK3DyL3Z5NvTz33GjE33N7MDA0fTHM7ad7Yjh4kME0na3KDTE7keG5b+5etmuGPZdLpujPxv2ul1zUIPoUuOZ30uPUApi8+f04XB3Ft5mcKOc1GeZjObLG3k9fbs2czmpJYUuMjuJcpIcMzEx6KEUmhr0FoqVqqMc2j5rLoNlbtXFVWiHNX7RIdzjx0y4Off+mf/QmVFk0FN38VfFWlX9lFgf/GgeQBWSg+kDUo9Bs21ARTyevAisK+Y8PcedOSIHmNJfiBEITJzWx3GVZvp4gfs4oppZUUabMUIg3cbah5/a7HZ2VXPC0689QXP/XExdcefLlxt2vs7oJghnelhuSv6CwCMiHshlmprMr4RleGSZrP6slwchZI8m1yspJ8jyy5hTduxPFJg4/hzLmwTrJfikt+JqFuJfjE8hVtKlr88exHcDDztCcEeOP2ZAQc36vXDZhswqGmnEPBi+zz0sJt8oMfm4QgXvILdnwF7pCLbiDZQYTKV2JCuvxLQf3LKnUEakzGHxIbIGxH4Xt8SBIbMFN2Io4Ufr5PeKG+OsVfxopD8OvfehULjnEo2WEKjzQz7FjJKRBsUEmUTP2FRLREYgqLN8IyA076s1skIQ+f2Wyn88tkcr+ULoq0J9HtUXwBNifo8nUcnQdyTKGcj/fGq5gpba60MxnGB3IzW6nd/UrdPL9SNzuldh9Vpa6bR6m5nO7mmtPdfJSc7vp5nW7zxwc43fs0wTW60gpPbrmqKr88uybT5yZzLzLruUbTt43mGQMaTSUo3N5fIIlR0hJK2P6f2rDbKmG/lDDbmWbaJj+EYNfs6mnbMtpUD0sqo2xTi8G7xSQqw1rlml3XvjL1tM1m/VXIZoX/9sf9/IXfQzZGCaUQMplfaQp9Lgg0hbxrwBlK5QcvTz22FkwI4Vz3bcl+Z9WuzM7pJfuDrwKlzPwlTFXykkKXj1TFp9jy2lwrLzzj9oMeuxz69YdxPUltREwc3+0rRWvxs8E9r+6bWipRx9CN801PfNOr+6aljkBd+qbU5451W0p0vXVCM2DRPAv4rD/P4Po0e31ePy5ZqL2lpvaWutp+ofZrEDN3R7G1xgzPR6POvhH5zN1RDKqzc/Z5NVXwfFT6vHlV+ZeFqnJzTRU8H5WWdF5VDi5Ulb01VfYeJVV2z6vKGz+xQFVur6ly+1FS5d3zqrJ3oarsq6my7yipcve8qnxyoap8tKbKR4+SKh+cV5XvLVSVz9ZU+exRUuWT86qy8ZMLVOWBmioPHCVVvjivKlODVDneiv21N/aLLc9fA9Pk2vUyufu6rwPs6CtUn2yVUzxMUjET93vJq0GN6SJv6/MHdPnh4Ti4kOTC9U/s9Tx7pRQ4J9cA0ey5L/dh9VJLVM7KJa9hoUyAr8Hx3t8GcWj27L6KBijThmnCDE2es7rNHrK/Ko8QBqFbbqhxlwpl4yJ+hue30aGYYqqiTAb9zx8N+ENrHvb45auAMLghYcALaqvkxFLdyw8GEDEDPpAGMYdlYb4vxInhdEWsDDg1JNeQULEuyp5xJ2KXq5LJGyC5fdy7ckbMAVlyHrjzFtzm8tsx18eHoezB7WEPyD99wvT2GRmLuqWjfStnOH984qPYbykGrIqigA+4N8LsB4oa2PEJA+Jb/ZWTtsPBB4PrFSY0uBp7TezV4/JPmyRvRL+Wsyd2VLXITxFNhcdqdlx0l6Kx7bcDO/IKP610dLHNBmJ3oEzHKlMmMt1tJsKbfrwPOpJ5YkR5pEp2OFEa0wE/4kxPwEqYMcwUY2sBDKOwOSB6KTHG1tyRqbQNOS9JW8ZjozHLXhaJtcoP6TASVXw4yZ4q2C5r5fe29tdKef4e6mbyOlsrr9Awtz/hjOCjNtrdDDhuUPVo+vL2c75+xdK3f2VlcWLeE8oZyRRQLjf70CYQl5g97VHcqBBDKfA528H9NdHxfDTawR9tna8dvHuhTfrBmioHj5IqP51XlQcWqsrktj5V8HxUVDk0ryo/Xagqm2uqbD5KqmzcNp8qWz61QFW21FTZcpRUec28quwepIr2vPj3+oDeoPIBlB9tACD8KtnvY7/tlDd7+LoJ2g+wR7sMqZL1VsKgsskH7OUjF9dxbse5EzujRVcjiAlTDrbfxrpKtg5dNgR9/iD0LNHn7esl9Pa+0Lfa0OsH0m7tC92x/lfCrx876uEA/AN9CrytrsBpvurPREkmKtmwAaQcIbG4J9eYN8fJ7dUcp448x0+vnyfHxMtfA+a5l8yANj6eRABR6ezwROankleTgxC9XyT+nO+XA9gVVSBMX4ojJLaAsay0GXp8Ix7lXT77UXFyZqahntV9Z53BLWxQluOJMR5YUTg0AO8oect68VmAamSGpa9Ibhd3p62K+U83U5XhqOT69RL6tJ5E/WITatMNHCrhyVc4IQTaKrvvVkgUKtS7WR74hP160LEK2LrxV8uFAff4fxbfm38Hk6uSXFlyJeRKyLcrX1WKuCGK5Qzp24qxAxcYzZrdjsg94SfVxzSSm0QPDMPlDSN8BjyWOocGSIb9gF9B2PGHRpnGajWbcQNLiJ5N0/h/7P0LgGVXVSeM3/O8595zb91TVbeqbtet7l7ndCfpvBsISScE0hcbTAxIxr9+w8znfBNNcPiqCyYB5GOGQDokQPOSVlGTEEn1LdTwUKMglgLSKGpU1FYBo4Nj0IhRUAOiBk3gv35r7X32uY/q7jwYmZFO6p599t5nP9Zee+211157rexdghyDGrSk70acNtnM+w/hYcwUo7GqqA/mE5RBCng3CrC3GCI0NxL+LnZo/EQfTijAwP1XDyfec9OJDyc+gBFCOc51aBFC5Vs0vDQ6pJAZcY5jHtV0m0LsupTpRA7sVhCzWpjbgKEclwb2ppndQGnrdL3wzNU5441RdU/gFTCwFQRagTpGRBYOZ/8DZEX2RuiBOl10jbcWFMmYNxFlGujCP8TP+hX97LX4XNsclJcXq03dqo2BNCB7I75/wkdP654YvfeeZPRe9wS3QvFY2pFV2/GTJ2nHu3yvPknKrels/s5aFRErGyG2M5EbPhmMGEMhBloYATCEuHPBf+UQBnYIKdQjg+Fh0W5UUzWxQf9IQAiaFKFWV3XMxR4UNDXoFVv0Qq1cvY8vWsruSKF16aSaKLW28igGTLkSqUHhgAfSsg00aFnQUI1DelWXautI/VcC1c/eXAWV4tq/Kqjed/OWoHJz7D2nDqpwBFTeFqAKxkEFRH9wFFRveUsVVGZCKLCyfyVgfd9bTgSstyIVnqCVWSVZoWXF83TFgzLLxcFxJKY3Jw1IqHCk572Kf+XPgPhuJr0N62aq3L0PamfrEgjrKcOjanHF5/MVjxrw4reOJ9OWWz3UvJbrlcMEsGhgUeWHiOVSamR3ozniCzgt3T7zmf5aUZNXnOOrf2Ystlhl3apb+OonC38JhCtmAce1Cq7hVg/ugGOqZz+DOtBKuboBeV4P4jwVoUwrF8hjbSC0ZETxCAtdxvRQVubMB/b5ah0ZpapJA7M4NKxM7+Gvco8PASItsdesuwCQ0QYknNpmbS6orjT4Z5GFM0wRdLVF3NkgPK82z6vMU5W50qqjBO+b5DGjFzrqlQSWReYd7kxmcnCftJS95knmmZlnTTPOUiY2MOow9sg9nqOU5mBser7P0rDrWONbLlBzbbEIB+NV6HCdxUDsSgGkj/+nX3QBvIbLQN0fQIzghsZ29cMZmqHuf+ojUaxCxeMSxDouwNcpUdvPZ/n78xk8uLGic00tGTfqUIq/K2Azb7D/+lVpYUzxlo3rkqk6n0HNQJpZbmU+a3CHWtbi68w+H/Cb5a/QcwVVl4vvSg+5hh/Iu2Ot7wB+PAbZ4BCt5tgzdz8IwdhcXqd5lKu2Sw7xjDJQyRnV0GgHI1/MB/nSg/+Ee4baaF9bXK0twszM+AGQflAMsPD0tqv1d/mQ+tGIDo16BxXaUWGRikBIScECXb1FZu/SO17FWBhArcrH8TP91ThBFdAVieTp2Ss+x5bsNgDje9gTQyJcsNMs9LIPisfPOuum54kSygbyJLhYigfY6D3izV3MEWS/iPwwC325AGIFzgT5jS+EElsfeD5v9l6HHgnzTR3qrBVZ9nrE5LO4u4tuz6IWzsF+xVRphTxAjhF+bijmee2bym51H2KV3TLw95lBjsYaLInA9SYKLm1tUgcmETy06zlF7eAaQ9VQ6ZpcCvWow09GkBk8gFdZIBdwbOuKeeLWzxMgZv2dd6R2qgGhZtCIGWkEcIEapotcJfNpUsTA0yVLRpkDEDNnh5HL9n+2YkdZHrNn+mHeRTwHLvJD4C0esZxMLnFVH1pSWYdz159Sa8igajKwhpQYofGZ+1kBdE7Mi3NjA1Q3r7VCDj9DUd5hsM/TjKIbt3FOPdNjjPUeAyBvtx+IFQE/g1YGzMOA4aOQwSGfJMMPCInxGG5O8aanFLuDCQ5gcw1MPjRSMG6OeN5j+QUUtWcUA6vALgsKZW9QbGLAhhy5gkSXs85KJXAYBxytxu5zkXeUkeQiP6yRPEHs9n8uPd5IWYIjBjFCfmJKBVizb3Asf10zy8QoEu505V4Md0eijlbGAMhpfNnhh4rmwUGmJns8GNqmwJgSwZcIJEMexTB7n1nIdD42zSHDHTdXdXD9T8u70JX7JXj7FFVPFVTKpzjvaIJlUGH5WGmfd6V9SYJv36o0/TQdSP2UZh8wsKx9M6X8cz2f87zlb35u/Z9+7cgzcPOkfGFzL21hQGRFrINd4Zs4WogcAGY/j5LAGADpMJNRKs0ol2LgWHQMJAHGDjXBUOQZOAwpKp91C/GcCyYuOK8LdhefSBfyhUri1E/m0F5uoAxaF6aCCgxe2w7eIi2Wg7egg1dpEOBtqioWELxPgkvPLnqgNnmTFmQ6NqUw6oD4YfbZ+6iYPdzrJWv5Jta77t1Bb20131bSLhS2jTJjR+cD+TLFlFG6Bhuw1Tq4eKmDlt/GMxa1hBO1UIapymWVUzUrFh2u14H+/aPDYoWAtys8sonMZ45gqi0RczRPfVrkY7156qK0bnUayB4i0yV+Nu9w82cBmQcFMr1nFwsCmQ7HJoB179l4BxVaRLR0pEOLCv3+NcVSP++gNuIAx5qPDMB8ULqM4zbtQdqlQ+rgS25dMc9fzR/lB3oyf01/A1PRnaYhFPBVhmdw1oSCF8CeUYnR39UGDQz4Cp/cQFsQ0UaIhir7qiZ+tROzpj3En+g16UW9Dp3wUEPfv13RhQwo4XY4gLvgNf1hkbj55YLX8uxqyWA5QcHP1WPPnJJXfEofChwhqw++5K8aiwXZR2UiBzy48j7MucPiiIEX001QIWdQX52DFumz1TaR2A3m+LY9eyRO8aU5AS/N6vezDtqy7unMv5Wf6PoRPBt8S4CfWOUO8XOCN8em8C5kkOby0Y6EweNTWA5Q9ogsFHWw+8IU1Fnq6RU+nnd4aKqKDyPtnAyQcp5lmx225008IMqpy9qnjeTSzR7DT7UbaO7gAR/KDtIe3XSJ14K8pW14SFrwJbOj8gd6+J0S5wmpJXKHljIIPkCIiyUNasHLU/YV6REKK1pq64y5Py2N8/hWicIYVWljlrVNlQ0UrPOrDgbyuD8NrsUMQ/ZecPmeQlWWMTMqLR2NSkN1mABgXgg2PabLMg73YUzWJHgc9/JfcqH/Qqpjk301P7gK/zpNRL5rddyvojpM3V2uDwaUopoPT9J14sc+fgB3Lqk9X0ErRexDzXwjWgATCtTvq61mh26RoT+b+6KU6D4/D9F0dEE/14FzNB23QqUpiopN7TSehw1K3qJPBYKnuGexDjKE7CbUOhVdxHiZzvKktNwwxHw3ODzeLoQDM223PKnBEuJOasAXITY72WdYhiZOytxnf+174aQ5ATvZ7cbEiqoh7VXBtDnuCVUGfKWJizjLy4yHR5x0YO0m1VJRL2Xk6UVwmBDzMYTfi20PMhgpUcCRDxspUaRHoa8BoIsQEp5g61pCrQVtUm8w+FGJVeEdzCO76YqQzwrTUSS2Umf6yUUmP9hXsUWOEtWJOc5l9RHqo4abPmjVMqMRGiQyMKRhudWjparY6AsqY/uwH4RCkB38tIXuDMCYopaYIkLR5MGaNVpubPcEavdSrfUkavUyFpOLmO9SNMaIQoEUWHzOEpuvZYWqu0MCY6RSd5SxEfuT7kQnTgG8LU4BEuAFquO/Ui6aTDkFKBLd4oauQRNdCdGg0DXIiSi/xfMq8vfAYHgAAVmPAt2FB6LobmQ/AbDnF4DxuCVVLozkpW/1QyOas+z9+pJF/uotNB0RUuPgu2GkqJoKYIKRiMXiQMxsTyDHUJw90sXEH2wuYoENdN+cq9wTEJ7cg4s7+qtQ4vOzDyFGRJaRbnHuWOIv77DbP4nfV42+o4ymavSHTXQou6cEtZdFcJctQIL0fs+L+HBW9/m8sbn8pz90+xf/8L8/48Bvfxz/Hrwse6uIteX6336jWJddFOwjidlLtfIYhCQMeoH9liKKRWh4kRbMFLRnpF3DMRYP8+WYdMxoYNLxY20VeZ+jXtWzog4WQiS3ON976aq1p6/WPMtjkqtcByjcrDCsfb4J+HyqpR8LA+zvqifLkT3/NWtfTfjUPMaDclkR9+UJ5DfSm6nMSQ+E3vFvIPSy5QSbuymyoUFP2CynzBb2Db/FjeAkCKu5FLBhf2EQJZKvRFJdEm5AJ/ssQsZNfSGg3FsYK/Okkje1n0V8y963CmMExscqjPUolsKzN2NMhRKgIEXZCDNohdP50aVIL4ngEeyRNuEoq4fQmX4PEmfE7QFylSFyd1TdvVkT2L3/wOf/3eaO137u9y6jKHuLEhYR2qvH/6xoaFd6agc19621/CNBYXTxwpfhYisW3GCg6qs+ph+F0LvsgS3CAofn0WF5sWdjHeJMMz3RU2zAxUpXPLg1YBw0ggnXRwXR9wmIooqiQPpG3/ec4uTx2ggtIg/sstyt2oMBfXAhD5UqXUrBdOzR5L0UAMiXg5ZwbRf6ByR0D2b/fgkCG/Yh9EjN38cfJggLxC+oQJxCxjNA+N9t/iMbY5iEu5LF33iz4fYp9/Ho5WreKY8o4D7Z3kZc2CVv3vtn3/ffvvcZQ2a3z/5/33nm2f2rOextsnWFR6n2si4XnF49qdfhK8XGF9lHlPapLkx2zJyqBCIrkzgKICgDoRBazz1maYgmqGYBcgRMnB7Q0wcALOgxwB7EuzovOYerPMdq2Dg1kPTXG027MGT8B2pRGetDSalEpXQvqwp2AxOp+F8VDDFOyWmOzloqYpVlqH9mRzhk9ftSxPsXfh6KeV/OzzfzM+Xn3dEq46WYFfw8b3HaOGbn5ww/3+azfI2f6/zM+HmYn7P8PO7BqHE+x8FbuZR5wX6ssl0OPcD1LGgmRC0iqFUsoQhO7WF9YzuZoE+x2yEiCNMR2rVtFwcP1LFyPVjPlzn7kcDtDlAiPl4eeLRN07JflrWun/0Kntot6mcfw1vl+y/J972p84W/ApTv4iZU1bvXx95vRROXL/SPexSifZ+OihXWv/do0bUP6ZkmPxDRCpNN7kyxzVnn6YMGdt0HaJ7CTGDJvfJ5aNXVC+83ARpez39V+1aeaKIJ+i1QZY4kOybhrxnteAxHfRV1IdgR6eesZoMM9Nc1W01rzu4xxWessFkHu1x3y0NnStzMlLj2RJwaonNW7tCXYhv3MFZjyMNhsX0IiXymYMq3ocv3BTmDDdQ534H4u6J8p3ACg80bsZ/dNManSMsn2q6eB4dDogM33/MbL9r7n++/rGL/hnbSDlrB35V9u4JTqQP9rfvXiZtUyY8WrjvBzpAjxHgP52PrL2guGcT7DQvr1oXcWhP5mwYcy5W4O0zcfBnnwJZOiWtW4n7LxDWmxC1M+XZpSlx/si06DSfyxljMYqrLwgWSkbhF6hlVwmwPm1RLcJq63ugBVZpeJpsR3TM+IFPWfRUWNZWmeOZYCDcRrApPTRqT/o7n45LBhDqaNOO2w+W18m55DZVr4uJUsoQfsYVJwVphz9dvx1dTL6fWH0nBiBKee8yzp2pm3CMsoRQAjVU+ozNJGEKsBN9ONQgRKMIcb9agsPf2wwa6Dpz/Evlpdc0f0ZBgjr0kGd+lO2Fw7VQzPTUulHzZ2wnoVG2xBuP4EQWIx7HHTlaZeCmzjZcb6MZYpzyKlI/25DhD1V6iLb78VgDfXEqh0EgcoUkU44HF3VNODgwWJjmArCWL9F1VD/dprr3klQT1IzfiK2SUXRq3v6KVobKtBtqMz3fL5/4K+DaRWxVNdVikLF4I8lK2uEilt9rNlnY64YcilPYXzJiHo0awd9ln9UQIEIilAcTFB5PlAhZ6+BWnWm5PJ8S3w84Bx5prNoLTPScwYJC8nKI1tFtpMgBI9VWuRhxA6KlMXQCQBzL6eRsYCxbKkzaqojaajD4h1BXSD/hRKC6scXW7DuhrP38U/cxFg+xyHD/XYQ6Y2kwm63oahx7LPj4S1Rvphwr4tCItHtISsZDQQK5GdZBQl/0gAYePr7LfBDBVkVyHV0kOZ3JMYDoMvMakjKgylQMIEFfAjFOgszqQWc0xntovEFSV0VBLvwEYDXsnLEDCSgFhR13lFeqGWhhJON9aUd/i3FOMr/dSJlt5UwttcWxg9w2BlVALGZKzZMEPlkajRxkIVMMepEgQSrQ3XiT6Qk1nPxPGUbMfQ9ekbNhx9hSVIpTTGojv3FUsc7XL+6tUd463qh21IJdCtIRWzq+q1fvjKH+sEyCsZk+jRHDgXwEpjbbdEFewBaJf6AhUkP5tzKYJmzcqaTvkVw6yqnsDHMj90KdOfyA9b5YP5GDB4SGPJHpYNNyqylJQX1oZUuTYU7jLIeYCBVUD5XWvQoUmy+alQyhkra8XKYtVfRxRj9o5BO+NXQZXOiQpDEhmCgyFQ+DvqEHh0JSRcv2v7OJS1Ntwac4IyHRBi+Wq3eZGLpPhgE6efXkbj3PyGTwo76iQL8Ojm88ORo8F2SLr/Pg1wFmag3Sxu1osiP9p1Za6ERgwjzEWS+0ZdZmLHvlQhqyDM3v+bFWpB1gowJZmyL2s30ntyiu1RtLWyd/cWOeX6Nq2RwsqbYSLC2zTgAmQ9PFPSdtD2OicH3jg7xPcV2QOE5g4R57RtDJUr/Aqwis1NDkKwrd5CsPDngLxBgXidQrE5ysQrx0HYvyEA7HxRIBx+Gjh+O0VOMaAYzwKR/F9lFC8vi6I+VPNsMWbw7h6g7LcHDqmBqLj6VIjLCxVY4pl+IL9G29/OCiEzsebGyKrhahiH+YOOIKQQhH+7eXyfQ6fs6oy9ezj2NMXdVSJWHFMbjRTEEOrMhk0RvaYXY0ZBKsmsimMQZ4KOyZHWAnmWxuPmng0LQUqMoyMOjgInwGly+ujtmhmwMwN3SXFGaxfM6N3Fd3tApXGYzurbFuLv4/XKCwVA8bS4RLGXx3NoqfjJmfHtSYb1BRrnR9C6nC+lmjGYCLMqSRxUxVkBkleVzU7IeRq/dojf4ilExF1vVma/bJQLo8aiJxZJQ/9rGPPXbfdjWUYVYu2A0SSWqlDc+AwgGydtmgkdOCGGW2Bm1eegB1uDAoW5wd4LHCmRbWOXQE0dbmSRa6vI+0FqtepfZ11tzOjd2s925w6pWhceV5AfACOvLbE/U5ysdjn4SN/Q+/P+sCKRXRmkTqYNACUDFoPMZxedG2fFgRicCsr3JeF+OBVcl4syleQ79WtikddDnBmGA7kl0MxzKHx9Ao02q+ISHoqf/CUdVC/QGBplmheuqqYluEotM0RlW+r8uChyV14quckTZkRaFHPlQSCkGCMUm5Fx6zwo8aEllywhy5e2ZYhFAnNIpQa14RjrleyCYr5ebUQOQJ1BoVsCvevL/0dUmwlmpRubkizaUlNM6teFevy9NcZZD3y1gEkZRbNuNWlCZioSu4WKKOlo1rKLNJmuZzeep5BOPHsfAaDALnRjHjv0T1uohPtdrfD7YKClDFgKglUpoxhiug2UL+WRi0RqAX893VDMX/78VLMb1DMbpVianZLMLvjBLPwDpz7TSuf+7MLly8Te5te2bdjHxkOK91cQBVe9rd68Y18GEPOF4wamLDYqMEfnnKBnitQFLakQI6ylHuBfKHvQ54V/Ps1oeNLgIXO/22TdHyJK9lWoeO9R0vHt21Bx7dN0vFt6My2CTq+Ten4ku1T74mh4wvT6Hh3Czq+8ITR8e6jouMLLtgdp+PbaJaWJuh4d5KOLzwmOr4wSccXqAs63j0JHe9RRgvjdLz7NaXjb3kib8FBvYPDXvabb7Z33iCLy73yMtxvlQm5JxvnsctwRwMvnKb2wkU/4Kn0Re7rvs7Gfnpq7HEXqwIUif1YJfbYYRu7OZ5X91fv9fRutFizvduTKxTZndJIzbBezfDOkQwDPecsbYG8zYPcQs87Ayhc6c2l0H3BX8Ob0+AqIII06/7atC7cOx472DtaVbdaU2/Limwt3WmVJBORTjLxtb11v1AbQJyAcz0E5MBvI30Wl4HVyNwTkzvu/KpPKJpKQG+wp+5uE3lGs+t3JeFFXjAp9KooRYm8afCy8gA6VKMJlcN6QC4cfKcZooB9ohcBXhwiOz2sNzaS6EZf9pOe/Ll95WKpsKkdkofIyZ4lvnLh1y4R0ou3yL6pxuXmoq7IonerWixQdCxJ1IhZHlkkYQ5nBj0yGoc5COYenCzW5arMLD8/zs+56WUYFsDDjn8PV9/2lG5BJ65694SM3ks+L/F517Yy0VY6eZ7xwFuAKHZpgdVsuqm65kyMNE9ryhPbZQhNSZkxlTxACyfJjsu4QvkXu6ljAbD8HYKl87QAbmUm+z1pUkML+tCiK5gaKHhqicj0IcmkH9ksH6pWWqc5pGm01fqj2UrcHSYuc3Gqv1NqfQOM2qLs9yVzLFHZH+Bl0BK9sLrmSlYnakuAjvzj1j1Rtq/cV8B6A9RehPf+eQH+PKZggkdoRoQS6sp4DK3SlhuGeUZ+qFTrW4taqqKNYTMK8ryrM0iM3WxlMeWCkSXvaQfJl31psU3dKms5C8NiOfuEjBCukHKaccbdpwX+r8fFm3sriwDXsjhZtl8PWWW96B34Hvn32cuGDweDaDX7JEqDtLmHL3oVBmVZrVoBDtTlGnrKKyaGk11A8TgY0IihafaCtm+ItVsV2iBTAlBQhwqSItdyCxhqbaDldoNtqESblmAWqwlUbxr9ZAM9mZ0y4KEq+7Q3JpT6ps2M6VMCM3vRUuxW+hzPm0758KUPc3uB0rqqIqpOp3UhZlXC9nZPzH4885/+8FP/dPMX3nXbMaM2IbYs3OaotHdFpdM0oJazbZ79T1Skl01xRy/I/uGNchbmeMOHLtt4OADbmYLuei9nNduAamgtSHuZiQJzR62W/lY97vCuFJTXf6VvL+fe55W9NgeiW2xIE6xHhwIo6mGPdTWJWh3umw5eKU0AB0w+eBqjGh5lf6gcDY67MsBJpydMDEW4OB1TyH5JtZgBgdvz8DmU8Qc3QDPEEyIspLylhskC2X4COTnU0ibx6WqI3UdN25DPuBI7yHFLAHHuJhPzWO63YEOn25gYc1Fzi8n5T3NtCwMvX6Su3s/9+RKQQwd3ml0vlmjpjmKJJxn1nH+u9Q88Mi/bHW6JLJUJ9uDSaI+a3OJHamENk00K30bLj3zWwxIr8Y/c7+XLotdWYFTMdUsezmVcm6UQ1t+8QZjLmQl5SF6gJcaBVzF+YjYhnXxwQSo+ozr3aS6vaV7tZE1N8Okw4RZcoJdj+/uM+XHqu8vI5pjb3v3MwJo+n2bW8PzOVQFhYMrrqDbwIw1f93vav0C65te4m/mynVPLggjVTqcmRruK2jNn1Z8LactuJBixNkg+f57J79VS/CBDpaOlazf1BY2Q2kaL1zu2fTNmnr6uAEKmMStipCq4nrv3ErmAu0J9RDGiVWP7aN31Co+BnzMw1dFpF2AquJgPAmWG1NcnEMhePaR5Fejpi14g0kXGCOX1JUVvyqu2b/6abE0+6bYmverO5FMn2Zn8YD2zt28Sw9D55h3GOb2p5EZZpwPfJvp795YTLNm/rjKVAMtWzKSl4mkoj7RNZnrHqs+Q15VO4vxPCAL86Ku1QyEIlS8AFhCENoWbuN+9mXdwrcwtztVLdSVtmDe0oUsB2QzH4aBpZqOIVO00X6DIuD6LQEH0mL9KNTrrOLS/o4iOAgXGqEbPYOA2sDVKNZZBARNaVqrRN7OqR31QjUZlAvXHqMY8f0N9wd5tQMqGoRrbqIHkLkWjVKNmqEZXqEbMvV3AIdko1WiUVKOxWiwr1VgBrVgG1VhxVEMdSjbs9G0r1UirVGNZy8PVn5Jq9Mr+LVeoRt/e/e2PU42+oxr9KVRjmZpCNZaNdsB0qtE3VKN/MqrRn0Y1VsyYNfR1OyBkGrN9nGpsp5UpVGNFDIcqPIRqLKORsxVZ3izN0fYPilIlrehzfT2fM7cWKVQywXiYRyMEgqL0V/ytxAVMHfRm7IfeXrHy93688HYeD70oixi1/6c5cZ9WknX/+3M3W4UfjC2aoipNrQIUxynUPAhbudJ7gm7TB/CZ5MvVChgSubzJdLJlt7KfLyPVipOvnyNDHpacoWNpy9C6YbBGUt1V+9J+FISLgaqMVC3/7VCDXmZfDdKn+9/sD4WZ/NukaY3z+uYZ3hiU9ywuqlw/hLThjov4GbFNk4uqu9twcnfL8SP7W90Dh1b4GCJO+ID64MgSlEgPE0dVrnzpbbGKcm7Vw5LuRVOQGiglwCG8SWZPGQM/uxfpWjSFq9hgXiWXdCt42TSa9INDBBRUWi4bJ73vgOnmmtPSi8jtSkygO2Bqyx1jFmKOyOSb4N05rbdWZEafKlR9qtFrKU1spWToXZPMfRTcmB7ms24HNqfXN4X5K+Z5kcUi06QZPDosUZc7ceUiNKTOhlzaq+rZ7jUAq+MiQx3Kdtkfqc52HvH7HRfxEgSCELj7o5RB3a61xg2T5lOIzizoFY8FORlZqPTHBTtY6SJx/F6JpDpUsBZlTPIlW0TBBHsUKJ2iB3ajKdeSO7ptaiKmxzFHFVivGLUhN/DQCZR8+e20IJr9uK4oFwWJHx1o+fODMFh8oVhfUYOkV+GUyIGC2cNjZVYwWbjRqqRnf4xIPTSZEzQIUfteCi0zJO/78J7we6LUMsS9TIG0HFOBAMY0j4/xnbTO4G7XvNesp8lD+1mxh0/P1P95JCMv9qSRsXMUqLR5VFVpa5b50v2pjGWe4BHmDXB2s+t5y15EbVBycNB7kb2Emuo9pqsUW3TPI9H7KrF3lLFUif2wxjLpUBrkJjC1jt6W/mQQwI711FNFj4FbRCBP2ZdQCtRVjyzmMZ6HcWou1/lWQGRwiyIEhT/HHR7iTJDJNkJy2yUpTxKzMkRC/mJgCa6AlTrLJUskU9BedYFFadzbSfDYWzRGSII/qp5TeXNBFd4mch+mCdongrCAmkAWQfNQVDtVvBDIjw5m9ifCscZACUJyUtThYJR8xPQILwwoU5yOcIK7MU6+U4GIuxuDInEVwPnQKeobegfKJ4RGjhDSn/TZN6iSAlXXgf9MCj4M35dgpEfMOyWj79ZpprHNrrq2QemvEwVB/6362UPmM5OgDy0mvM19Oa2k6S1xRZ68raJaZ4x2DwtHjqCh/l3qD90a8kaGYERRDxlq6ZugSB3b1TNzd41wza10Nz9UYMZ41WFNRPuWE0Kq86FmgxoMLVg5wENuS0HbMnsdapZL/3ki2IKJzPm0bQ0xPeRkOVnN3tPJPi1r/d8HsVvnQ9vKB8/5GtylrPgB3MAFGmAd5/L0juXUK5V55K5bTiz1dWmGNEnu6UEit17eexzmDSyNelt4WMTTJExlnLmuCY3GiciU7LdXsDtVtLpB8RCrEM+ujfV1c8Hy85ch0TvwFPn3OZY/ei3Z31obN58/B0abz7GUE/H7qtF3lNFUjVbaqddIJ26A4hKpi6xcIXWR5nseUnd59g7P4yFX0QVYFrkP5KzKmptbg4yi7H+qgbiaidonmTVWt63VzH86LbPGgpMPq5awxlhV1eaTmwc3iMEtaY5erjZ3qiuUVuuuvOlAC5nUy+rky2QYZvcZaS6S76uVWvVVtVi0LZJ7MxvpWqBOFSbQvqZor7wacF0ry4HuoVYo6F8fZp/R5Q5LCgTamAeo2jFxASrLNngcfNRVqq9n+BFLDcZo44sBlVGPzTUhnRsjtKhy3Yn5gBrKv6LPT/WWsKYGfeVwrGbP9I8Sl+FVbrlVLJRkn8E6k/6wa12r8LV9/hPXuMfcrrd4PiQxpagBNvdKJPQUN6l2zQhx4kPTUM3WrlfGHXX75ad++WkRCVni7JFSsRv1QvvE9yn56Z9GAXSiStubxxdL2lkaUMyD0oRiHgKz8SoGKBG4B4ERYhq5YIx1joKR5NjSWuAYYxlT0djSWuXsBi/MEzVsbSw3T5LWBuYMmLzBvf9iHFpn91dsbCS4cRvp+VCTS2tyua4XiesbTCk1lDpVT08ldp+LvKOMJImMqEkJCDd5a5u4A7M+zOua9cPGfJZ2fWTe1zlaOgaykcodUHd4qZooKMJ0O3SXHh0wVBRoDXWa69qNUoj48UUOfNweuqm5F2gE6aBJCWoa8w4JNq0JncSa0LFHak1jQmfg5zPoSptmrhBpQmsCUOkYlHQsMeoBTG40DGf2ZbfhpXbf3SMH0RY+XtjHRBgKsxjLFhAN0iNQnI5vZH+JD+FWuQnMxsCmwvSrBSJA9Xh5mFRn4816W3ri+ojefB/UlDM3B/A18Oeg2eDPixADOJWnrmV/pvJXUSJSU4VB9UaEoyz/Yf9wPX1NEOA+WjnNaFTzUDkxEYFM94QUZKqaSNAr4OBuCBjetiBOhwjpxxZM4LgN3GcDD3JgcJP/NG9zwckE6kYmoLfdu5BrypLWVM0w31j4bFWPzIWDQyy2h4P289oBJkH2VwK/BrWyv1YKpHyWqQEf4NmCTR9cpiHdsNXTUrkIGzaxhuPuCIUDmmYZP5aFa9BSs/iiNzT44Tfx/Ee8NYsfS3z2OfMSWwP47/JDVW/w4NQUsq89gOI9TUDRQUhWDF0kAncdpkbwcLdAAdRWIp0s2DzgQlD8Uor55AwebK+/hDNBpwwMIl/DT5S3htRY2XBsZnBJ6fKi2c9TELDbiUPM7aGCX1gQSxPYC3DNntKLxm0HFv+vv3zHTwe/f+k1ABtj9SWcE6OLbToDUG6XqEWmIhmi0GGFle9nn1cMV0NNIcAdVnvpwF7L/kb46r/zvOgGTIJ7FnIfz2MLctWMsQvcjrqTyiPDLv6L04lToZ5bM8uE8UCt7O/1fQWty0veUeGw/WHhA+CYg6KFyd64b78N/37jslK78uL960OKypk5pLiqsDq8U9Xmw2EhVn6kKI+89fXq98P0P7FlfD1rtVdR7UTxFY2BCrKjhDkfhlfVtrzvzqadbR+wBmqK53+V+f93Hj6R4fb/VWbsf+bmE7dim17c+6RxWnPf7xivr176RT+q3xgYe3Fqrh+uCGqXt9U2C8+w494al/VAbQ1nATx9Zcn1xAIRHlgGxTm+IWMoI2ULrD/vECL74iFz01Gozqa+Q8uBpuWboZjji85kSgYNVG1c63ZCecBkXiWHlLEqyww0mKmuGszkS0YxYTonGh0dms3uf7O0BNA24TbNy6kjlh1XILX47rupw7++P9QDysH6jXLlSjtibubNDY69GgqXs4ibLbWTBndzLK+fuAHVAL19GUXPQVL6B1HTN1YmIv6LORzeEOpUwFIyZTmSxWZ0whfe0dxXqh9gdDA4e3lfNBjlBSHRf3Zen2rkctR5m8q0Kr7m1qtqri1jxa414aRsH7tNnlFCC4uvSnzB/BjdXFfGjAtmLthxwVlgdEodllfzY2ZYvXPGKjWwYZHzcpAvTr+L4YLbXHBZmPjFon8wX6GFfDt18x1TK8+cbrY0n3aA1VmkFUy97cCQHZtD6E3PMrLRdqjbIBaat7PcZJqBgHkx30GLopMguLIg59jc7j7QYJHmaQ6n3vkSbeNQj0M9fs4PcSjaYcxa5rdtfCo+kyN9mdF6PV+mPgpcuq20ywTw9Oxrbf8wzzDpZ2Hqk2aZ1jYvVo4kg7lkyjiGhTr3IGaGOtlbMJVcWcWM2MGc4VzJxWBpWiWeOcmumvWl2CWVt5IHivBfjMKmoLSzrrVYWgDYcv+i7LU7TqIo+zvHyYO+44GTofqzigQk0KicIxnvoX1XI2PAN4pcHmeGvmF3H8p/U1xuCGLZEMBQJL9bC/LlLgBor5k1JWZqPbITUIKFj2GEa5EDdyyW+j2yD+hU9wF1tw9I7D6gXu4D1CkmJW4fAKml7AQ6VxiWPQKjA42ettcKeJacnNMHaeO4vI7v8a3pLM2A89febpCfPYhvSO0sITIpMncXXdvGuI9kjp+18XaroFcnOpg0ner+wEuxKKC4PKvU54D4BQHinJ65AGvnhqMFJ2MFx9gPJeiCMwCdSoyTaTWwH2oYmfYJBqACfr8Ev3xk8c7Ar648Rsx4bZfVHwkj4LwvDK5V7Fismlr9xCL8In0RLUJPKMJmUc9A78EzEQtHxxfJh6ZGQwR8eVPPQKD7D20LS3px0MbFtaEqgEOYGSt8a+BnZsABRXpdFDoqcs24j9MwZOA9u5/PSqk9SEs7AP0sSv9ms9ufs+V7eUgzkKvKKhqqdmcHjwU9LgQqzUFNd4MCPTRVE5ldihBIkDlhTU6KDM6o79JFfDKkRY0s5XoRECmieYz3vK6lOt6oxx0imRh3gNSUGCfA7AADOpTpYBo6FuBND1Ow402ceQ6KpXn2GEzJZNUGA4qLjIENDB24NQAv+3ttAA+9RYzX+IGSwpGLziouLaNegOPGysWR74FN4clzagiUfEMP96j2YWtEvhGqRRY7j5CXvOrx1yQ7oRtUL/sHzQCLZSPWq+T+1fBo5XQn3sj9apUedg9qJ/6hBeLU0J22qI21e0IvrvTfHxOPUm29KDux/3sqV+aw6XFAqqit46Nh+VZRHJLSNorgKAUueViEDoZhZXt0J8Qk2R/pZpZgMk9fUEw4PJoHMoWqGxpuHaKqe6XbXiAzY7rUEdBzsBvKkGzVC/Jw1hAdNX3wj5J/an0AnLXlskUnX8MQ1wxtV/y0MmbaK/K0OxrWfiBUbW8oKKQtC6W96xSaFqKpHkXctNg1LR5pWoxdsm1anULMLH3Tkym0LubWhZCOYot5lML1CiTJq6LeRvpcKBNv6UzjL95c3RMq0ZZE3xmjdfvCR3k1BXvUG/C9GrH02PDZAp66TR8Wge7TgVEUwrgGBUzK7i3zHOc8YiJVUgH8i0VGlP1PkUu/ExKqsGKb0qkn6S28KsvPVTOKF6GTJt+Zfb/KBNSDW3UHXgCy/HdNX/Pg9NHBOHsA1dtLm/6IxQ6tCVNcZWQeiuFhd01xQVt6wac0hE4ip2sHBZWcKr9QK54UXcMHnT184TILySkjsmPDjfXbUJ5fyTJZng9zhVpeJoq6sGiDn/NXsz9DDnOpv6aJMLNztmFm8AQAFBrG5ZB1YOE5+4AP+X7g2NqsXN8HSZ4Ixs2BNYMNyLyBOK4NrAu/qznc60nvS4i4x7LC4iazwNKtdwywriAUUmRCCdhAL4WDzNsNsYooyf7JMhOYEK2BlMPRQ7MItVZL35sjakSYVmtaXw1NhBRR3A7kHIDCYiJb1aKBRpYNHKGD1Nz4QPYQirYXEiIK4Wwg96w38MD1jSAY4MX4y/igGhsj9p9V5YU8VByocmK5c85KvQHP816p8gxZV8wUhehCAA4YiwiFPyGc0QLtV7OfwCWB7C78YovM/L1K3oLRpECpyVVT5b8hq/rDWhieLzTPVygVOuyRatypCdtAQs8h1oILvLlJ17uo+zlqbeVyUGpDyMDigTKucbNVkvovClrJP0hE8A/g1gccgCgmOZg3pKtyAf0B4RCTkjtE8VrLOWJkaUZralGKWigWn2whV4Uzg4cF/G31iINPioy4+FmEX5jPUYu323JBBztGsD3ZFVzG7POu1xvBQESYm46NGwRfBKdduSOOG+diD8Kjunhh4Gz9g2urpe2tBWpIYzmBi7miv0rR6iDmc71AnEe9zVnpR5nkm32mIocaa7H3Zq3D9i7EwHql/SoH6Ro1s0dktixIFFdSdBVt2xSvoU5cAVO+Hg7oy+2uDkHwcmsEpgY+PPuKHrQ49Lw79pZunNTSqInBeOhXe6KH7UEnCsZ2pR8UYiSyr6IwZ4BsTRlEzU8eHH0UsVrf4wc4VOHpQtgq+CeIWgB5mKwykasUZodeU2JbqDDw1DRXTbEN5FawLShRLShbkBRioie7CYUUyhcrl+yJQJ7qB9UAKAzCq903ilSK2cTEC/8rhdyI/1rg0D6FwWaoU17eR+0eRtOTccyjCpmp4roidssgdhsIbJE6VKQ2nYGNNLOkKkIHDqGl2R1tdoaG4j4O8d+VvNdRz09zuvLPc5vzrnScQ3pgvQAJjUyAJemY3tqHLBHSGsjvFyEKChkUMHTwX6m7yr95iMvcq+7dow5h14WRoS6FAouQ5i/vUw/U0ohMOcmTJK+a1CQYDZtlMC0ZfV5VJOXEIoWTLMwOMVLRJH138IXG1Zg73CWkLJm7/zpdZJI4BKlRSycJ1DnKaZLqrneGPJ0mEaU6TXTijc+PGEOg0yOgBGMUlBeDUw47gh6HHXaw5PGfonoe6OCGiqLSACkdiKp+hjSDbV0RG3SB1KaulqGxgmDKALKKPyqKli++U231tHIcnEVKCwVxspv1IrfSP3FAFEBBBwNRxKs50IwfM2IJQa9HlJ74OmAkAgxDGyFxjTWDUAQKRh6nFCEiI4RmEfmDcrWIJKtEkGZA8Acq3vhI3dlhLCFOlecMteXZtvruLXuluK6DJ2RZeyIi70gVjY2nNSwB2S1CHWIpJzZ3iLTrkQ6jORJUINvBtc5APTiJr+sy6q3yNGBd/0OXAZZr7/uhfE5n7zx5/B24CzdYsXLjMq8E9SgxtNed2sxrJ7SmJtLkzhr29AfzTCdnm5oyvBgLyPlbUkmL6i8pYmoCI2JqYHrymy5koGBYPwEILCWB7PHba9ztWRZ9Pa/tQVlAncfFg4h9xIGcppRxB9dkPhlTkXO6Lo17NdQxU3DqDBxVIo4p0Ltq4DS8qlc0DGLOgwiAt8ysTBCXWAmU8orGecSrpjmP8CecR/iTziO42VXnEWgxeL0TO4/w1XmE+VqdRzjXRlzADdOdR/jOecTf6PbCOf6YcB7hjTuPCCixPkCyPx9xHoEGha5BE10J0aDQNcj53vjfFXxvfePjAt/GGx4n+H7v9QK+n1hJzrrRfyUTa/M3U/qT8qoqHV+qrSohCWTS62a4QmJlAVO27GV5rCts3WlFJHgkwv1TXZz0ICITVR2wBOqYFMG2xsy4mI7GZC5mlmfeHP+hrIBiEVnO500KcG4nltWUUhqOMRr4Ly8WIMVcGARrvP4vgDFYGsCyV4rFX84PsXi0zXq8jWp88Qt3teSGUyAXv9wr2hBYx/RVn4hc6ZzcN6e5tZzXe4xLDeEV3EVYRWg7h5YktINDCxLaiftTL0GIOORLKEfzJVRw83bJZm4XkXDR+W55yfXlNHkp9OV0eVnRlzNonl+268seedmhL2fKy059OUte+vpyNqiouZ92pl7Og44iLqnl59DZChi8nEt78HKevJxPZ+Flr7w8ic7Ay5MJGal4CoXyvIAvlxVPpb3yciGdJ8+LELmPf3jrRfRkOpfOQczF9CQ6H4FLNKlGpxOaQU+hCx75C4/L5HQEJNOT5JbbVVzDZz2UgIRz6CK6kAOT2z58cS5+LpTPsuIi/sy2IKQLCcVw+YhGAaj9NK39qbQPZWt9V2t9F9MliHuqxHHHKoXhA1MYom1hu1FYjbuiPZAPryuehIzn0LnaeMTt5Wa6wmqcKHnO5zyuMFl/QnPrMdArIruw6OyiOWUgtuF+6zbqIZIxjiNbvsooZFf1qtUZ36v5aTlN/BNOkxmupPNvYJp8Y5p8Y5oEKWZF8OJ8Jx5XtD3aiSlBXMQOSvOzzJTIuMBZMyXOevRTIqtOiR1A5bNpB89AnRKMi0SC/ts4tFNCfSCchFaA/jphuClnCvqfafH6yXixeL1bXnbZuTDPL9vsXMBL384FvJxt5kIFyfdMIPnpVSQ/o4LkigZ7DT4/iRAN/F6u4Lcdrr10jowU8EzjzMCHBlkvkmQg6B++7z9dVv3DsAMvnkRPFey9rPpX7ONEQUKtTpDmQrKx50ziu5kzFmsU959icP+CEXS9iJ7C74K1DsOerOhqJ5zi/hR0pceKrmcCM8+06HrWIANJ2oFIxgtD1VWfa5teAj2bUlBEi1q7GA1DHh08QX3OBtqcQUzJDPXdw1HbBJnOLKnqWVzO6YJWp9NZihV75WWPxbF5fjnT4hhezjA4VkGe3RPIc1oFeRR0503SQQXReUrtFDB7Fcrnl/RL6YaO3ShkOfqcU4Ps6QDi6RayuyAl3EVnI5IBopEpXPO+uOAfBhdbm1ZJTkpdAGlOyEAzD8Bvl9fqDEtsWNzAsa/h4IWAiqii3fEwlOxLAgGicCuiTkwzUHosF1LrfMI/7+/XxRvDDPWjQR2whnoRFvI+Z+O3FayPSjBzRevr8gvkSflTFVtzQ+rzi3Ty5fvEtMkubPBrOrw1EI8VPE7XYs9wqyLy6PI5J68BFlDJdBY/gtFF8/QRlKD8HCUhy/JyrtJRIRyMsWfbRZMYbU9zi2aNF8AQT1n/iqfRXnm5lM6T59MR+QyDOW7RvMwumvstqpypBEeXKC6TacqWS6JZSfeNrKGX0tNLknHJyIoY0iWaVxdKU6MlcU+jZ+A7XffoMtqPt0voqaMFaCrInCtgj86Diy21uWCEzjzFFQAKo6nna7QWcAoLog8Rt9kAzqd/6XnxjeSp9DB4uW4GfRzEBmsqw1OxnCao6FEF4ROCuMuddE+89MZy/uE8wtWUfIXmLEGclalsKVzN/hZiBycGVXE76rzCXV0Osc2tSDyNfo9PgUxbiqyij4/Pfdsnlcf81KNwnAqh/4TjVMSFFcepvTUYCBSB/3X8tnoSN6rv+eS7P1kr3ai+rOJG9d1I4Uh+nOW8qP7dm50X1VOt0vlU5fKyBxWk2RfwnPB8Cplr9kUkjTk//XvE1dIP+J4P4UtQEb6ETvgi0SH8yUYcp6CKZDxQiw4DcuShNh7N9p+NdBHmqTC1IlsJ8OBYfiCnlZGGItWQ2xUstwhsBYGpAD2ekFwFW4hexHutnGBT4LzXTpFcCcC1udWmbtXGoCq4OonGwxteP6bx4D+RGg+f8b36qeK4DlwRn8g9cHzq7oFP5hwYBdVLA45FQhGPeqWSWIYWB45SSdUhMAZeHQLrwfXo+MdoiroA1tGGmApyMswDgLJ8hPoAfGO5gZUdf72bGfGJfAI7wdp360klpzUgBodJ5f3XC6VZw2v9emEgfF0NQd+AKkF52EOr4th2BKHU8FPBojlVUPsNb8SSaU2boNZu3ly1duNdYt672e3mesBDv6HXA7J/QkQul7Skr2LvPHvIWFmoXVKL4KLa5v5yNXciuXHQL02QuMOoBx9aV0lwwa7Oknx1ZbT+sJSFUSnBdsKuvG2sK/r+te/KkZN25UOPtit3jHVF37/2Xbn1pF25d1pXttfsBTGqZW8QMS9C5trXilKqT5m2f+yTNx1GvXrnZDtM9Yb6cfYbh8Y+5XpmHbmT/qRpV2ZMC42Hfsv3oT4xWamKbEpkfZm64hZslfj3HPndJ781/OyR4AWrB3Nz/4Y/NfxMWq+BCu1N/68tXKrXFCSeOlUuQ8p1y0v2/WiVBn9Agw5cPyS+8V6txMU3VFcLEijXzvRFIcXeMwJ9ErJvDuB0HQL8VMNT2q8RoG9yrxivQg41v4fR1QfWFkSHJgrwQGz6nYyPpgYDbjRGYINMyv/Yq0rgDHwtUp0BSpHam+wd0mMf9zKtP8B3YSWZgKWprnBuygI9qRd2rbLsomy5kaa+pIsAa0OdIuK/cm0ISsfxoTFzgHYUkSCCMIxocESBGbcItbqqY1kWADTDFsR2WfB1FfDxRUtnjhRav1C/VU/doZaOpQCVIJ88QjwkLXs7GrQscKS6QK+6ItyB1Nq/Dqh++OsNVD9yQlDdilShDy8AezTdOquxpqibBJknQh7htU56i1ak1SW6JS8+XgqhkDozqJY+TWoxx9+G8zk4uOH6g5yr6mVTk1qlW02wXJ3agP288t2Gw9roonKcx1uJ7I0aLY1QCv/YOvWjX+ed2iUkWu3V+cKiZnciFzJlpuSLyiaFcM4Foqq91Ug0dfYW5DTnjdn/UEb1mUy7oOOAZkv5xnpw6acUfUSpq8q7gzShDr80ZWWIvvd4iP6GI/rv/DdH9H9sguif0og3MYo/IbHv8JjwDVq5B4xWnjfQ25toiRaAaywhHqR+JEMSL4t5rIIBTAp8INw3Xihy/ufQ/bqMfpjK1Y48kv0ezobNFl+RwVr55TaIJ1e1uZsmgiHHaunHvAiH4HBl7jmrYw5ZRFt637TLFoUvLmo9wrNnnol2FBsh+N8uQqACmoZWEHzTG5SIKcJD3bsO9qFZgwsURiavc+YQWlAHg1cg9w0qaqwY4nq650+bMzqyMmOy9ygWr7rpUrPT5d8L3t0vpEHdJN0n4ZVVkJCKN1Vxzoif/RI8R7w04gM4tRUOjNWJVu2fAfJ9tcczD3/KzcOf/jc3D+9+bPPwCaOgyeMZufe7kfu5f3Mj94HHNnJj+6FNSX/elvshko3PykHZFVG5QdojOyOdjFtuiejxjO0H3dh+6N/c2H74CRnbj0j6t42OrdvpyhBiYNWr8HNkYC/Fz+UllSV/6vA+/qn7y254f+Xf3PB+7DEM76ktwb+29RJ8gfT+UllQD5bWDPcKgSZZa92ooyOwEGpGOns8I/0bbqR/89/cSP/W13Z5XZHR601fXh83Cf5dN3LH/82N3O89tpG76hRHjt3NyRWDVccXP39163HsPZ5x/KQbx0/9mxvHP3xs43j5CcfRjmLCp8ykIxniRPNrMw//hxu/T/+bG78/eUJYoT89CZt7uTA/B4Qb2it80GrJ8e7DHvUEbG74eMb2z9zY/vm/ubG9/7GN7VNPxAdBrJhN4X90sI49LknBA26w/urf3GD99deWlTlHhTxTl8DHf8D2t27k/u7f3Mg9+LUdOXVynn2NZDxfciP3D//mRu4fH9vIPeOkG8U9/rGO8i5bUcpD/uMZtX92o/Yv/+ZG7eGv7XzbrVv2r9Fm4dDN5cjdhOC/qZF7zc2PaeSexvPNqbiJniEAalQNfdhzLPzsFi3cso+m8S+f9J6quQbHJ42c43xpauyeaZErE5FuKAemWwO8+nIGqwqEpG1nYLxJnZMJegjI8BCdMyBP+qvPTmCp+0k3tl4Z3Bi/smK+8XjA2n1aj1oIgw009PZtPkUYnDfzE7qJt+gzWPco4pRbfC74iI/wmfyECSFEr3scnbngrdyIigEpQFhcLRX1A+IIcfMf2QCpybB7/4HP/zvE/t5lFJWOdSjaw3XnCZ6H/byBur1VLR/wyo5I15vZ9+OZ4/jvoRpS6qus0Fu01FvRrcGLivYatJB/QLLNCHx8MT+gMR2KxEk6BdkPIgJWaPEtEKROMYyiR4Mjgd4+RdCXIBT/56kt3gQXArFRgr8r+wWPzBVyZJkyruMnLNho4NLAg13bJWDn4oADqig5SCjs5z0xAbnw7GKbsWg7L3eKPIUBLG9k3BZM2jR7mwAn5J5BJ7ZXsVUrdeWL8qwVy5isfeJHK1/x9yMAawp6lLgyqPP9PlpU96/EzSnNJa07r3HOz4GUmeXbYQBVy8qKnXh0CwKgOLSS53IvdyUv+LmLc4a0Pd+NKyD5Dgrz3bQTLTpt5H5ugbsLp+N+7i5WlszPoN0c4CsMe+h03qifiVcOAaS4hcevTDsDTjmboXQOF3wu7cjPozw/X86J0Zk5uEo8n+RyQTPQexSziIMNHo1xXhT3mvtXu1TtfC+dybcMzsr5vgDfkzg7v4DOy5/KJb86v5CexN15MoPsKflFdEG+j54qtS0NjsGBYlDLL6aLyjDr/Zfhp1FYhlmuSxchVDydlvDkKwoP4lZCKC/7aZ88B4h8Jv88kmIo8DldQhcj9pvoUnoaAgfKZL6OUzyrzPMFXGLYTwMELkHG/RTxfY51n0v9okdPp2cg5en0NLqUA5On2fhEKrhUvwuKZ/B3trJncfVSzn5CNEqQaNeGb6IDqEC/vtuXr+kyeiYiL9PIoNg/UuRlUhaXvH9qkbibod3C18d87pZ05GmIfJpGBsWl1SK5d8jEX17qirTXaJbwWKKL8LiI9uGxD/gAfL8Q7lEuHMS4DkBPwiUIxocny/PJ9BR58nUjeV5AT5UnX9fEBNxLu3TFOJP2AHHPwuMsOhePc+lsPM6m8/iCFKPr+TDkfD6dg+/4Lt3ordzT3K1cOzn8f8OT4xuT4xuTA3dxC9zFfTYeV2CxAKLjCqROiDPxPcKJXEQ7F1OBnr2G4nZznQidwxj8zTwfTud5ccZjnxM0PifOY+w/neFwDsPgbO7/Gdz3c828eBZdmNemzI09ASNzZW7UKnNjqTo3DMpfSktmXtQq88IOaKh4IMMKlDbxOuNK/AZyC06/+znPf+C/f+Bzl9ln8XTGguIZxBNDER6mJ+2zeCYnCn5p0YKJQFiNvXRyiqAZnEQotZxmT7PTBbFl+2hAT9Ppopk1eo/pzjOkWjtTnqZVXyJFauQoWu+hS7S0UbRW1D0hdu/BYw89C9j9LIPdFwr2XvgYsfw8OhOoh1uzjG/n4A12Ac4Clp6BtzPoXLydy8hOQPZvxuffTM+2N3kL3OQ9F/wRUHoEzy8QjD53jWsd1ID1jIO7uYg8f0qw3yAmPYXRNsmfhicIK2d8MtCO9jJKns/duiB/EhAUnc+ZIuQhI+oSI+pFYAYriLlUQcxwChI6/FMSXEW8p5XkVIfO0t8qBnA0Ujnvxac6ZhilfWaU9gD6GDp5Pmty1ADWJ9tReSqdKUMFyO+l8/HGdyfxdgGPa4ZhNfd+z9UPcirotBcX/GPv/cKpd06n0S6+mw/qwdAPaSeueu0k0o/6MBN6vnLdoVIYpSbsAu+3cbm3pChzGnscsdPXXmJ2m4d+ke/5XghbVmAHzsL4XkhnGVL3JE7nx5P5cRZoIuKegnSgS4iuMeuNbl+IbGj0XrMo5E/XgJ8/w8yn3CxBfm6WxSAfaMDPnwkTA4IzIe1Fp/TidnWFR0OK6jL/FERU1/qnImKPW/DRKJ5zZtX/JkUwWbyLy2mPvFxhSOC3IPLKcg2rrvrPsav+c23yBdI0u9p+06ks56BojkW4gr6lpF0HaFDBTekwHdD8utzbWp+ktV5OV+JbXbDpOfRcvB2gy6YUYulppZBdtum6gMvi79b4p08UAjopE8hRVjeBMFdCM1f2ypzYay0JnGXs5utWsYafZ+mSdtGAr9gfZNIwswemAtTe5JM5YY9aSmzjOvVFnIWn0EUHEbqyj4mhng+fRAvUpot4A76Ge+C0R2+7vUT4B+J76PiAryjsW2UElf1rvgSioy5sa8MPqIN9WkUEelhGqvV4JU85un8jAwqdYJrgKR0XYnAROngRPcvaEz22DYbruvAC3aUFyOq4hdb2HawCwiYo/8GGJD9xI/lbyYcpyWz6vp86AMyiwqdrpBQr5MOoJZzjj2z8F/gWmG78cSmT6+cANv4Cd2z7VdbAjaUeNu/PwqOVb4PcDaFim8QXz2KycnAga862zfx5XNNTqJvvk9owcBTQClOxW4M1gZh14nIMblXjO47S84YSKOKjRZ3qFdvqj3TzS1DF/kKp50V4SYonMXgx6hgd7TtDPNBr/jJtddJz7U8aQDBFF+WMFyK0uESIuawSmGHgb1DyqDRhD2cCuVOyzmX7QPtnCaou8ASOHw5Wadt1giQXKfKZZuwpkY2jrSexiyhENBexxEkU0z5uIswfD43nAU9wB5QaCCTE9SLtr+BNscciDOgVsOkpiH2KFQM6FFmmnshVAPdSmrJNpSkLpy5NWYaMqKNClXlaEKFKT4UqvVKo0nNClW1GqALD3fPfEKp8Y9/4jX3jN4Qq35gc/ydPjm8IVb4hVPmGUOUbQpVvCFXALVOnzwNjpCu9J0S6wnw348DCN6Qr35Cu/K+XrqhYhXzazhPg2Yxpi0bA8qQTC1gupG3jQpQar5FLtMdYIY2pVpGZhKuIqAhS3GYUj3CaHIWySTnKomyL4dHvWyFHaUOc0qbtyLPdeiuIaEY1Q7BPz94ANQUFQaYWqVJoDXWlNdmdot+iyWElOakko8Tm4OO1VVeq9bsJnw379bMmPjsw8dnKxFcSnblo47/CKbWU8d+HpnP4eKCKOCcx2DXhtnoQnNhg1+X4Wi8mrJW3qlfWxNSH85QKK4/ZD6HoTjoR/8OIf5SWv05g38Efte8QWPsOr3uC3VuD2mASqWVL5+D6R07i4Pp/xDG8cNb5L2B31vZ+fqP0QAu3rPGqjMYdKEutCa7H+L0jLuoHBw1xuFS6yhzCq0jpn3A9b3AJd8XiMrZJEfqU4gFf0poA+/SICcU9RTSwblaPBKi2TpGZo0XAL50is6/+unPoVsxiEI9WIuYO/FWa/+UjX/07DgdHYfEDrVfvreCYg3UbZ9taBqSHR7hveB4OiogXskB8N9Xxx14O5pXmdNFOCi4O7mJwmBZ3xffpagGXmFpbXT2nHb3t4uBu5OOURLx7ImYzVihwv9XHQBP5O+LrrSO9vKbgBToSHOVAYBxdqIFjQi0c1wW56NK8kosGhZTQHM2tcy+598NyPN6wf+PhoFhA7vpmEWys81s08AchRTzLuWPRyzmNopdln6zaeXQuJinYyAMMVk+sS847T2mLskPpmg84iHQZSJrltshHPJoYOVpcH1p0+ch64asL7OF6sQRIImNLM+Y9/tpXv9hSRm84HAoU4Wh8iVLOY8bVIFP2Drw5z7ceYInmFt0rlNxWHDEvglF5dt6hbl63/rE6z5JsGUM806/HsD34Xi0o1olxoX+XjmDpUJcnDybXo6civ9dNjceIGyKejj4/5/m99HH4oOc8owmpDKf6X4vY7k1LSeoKKuEhezsPczzwKBYtuvhCWcAeFr9W8eYG8HzwjNUi2Tzwmf/e/alv/ozPriz5E97ZFo3s9aK51+QPHuQP7HvK7/dX3luQtkvn3BTM2yVNoMYmO5lX0Xxs3AJRo+rL3BPfQDOV79eHOvDiGrKYZWlvOXQyG9s0y9O+LOG7uPJZwSR+MpJihIKKF9oOHh3yKuPvUYY1OpPxDAd3M+an2QPqFYhCBWAIQHf5rbuKIYeXQC+7xygK0qomJAdm//rcm277keufnv2GgGOOQqQwdqx7HFj3+PKvfkOxi1OM0ZoyrQmmhESLd26wh9GRHyvgCubQ+AV+XMCsgp4dWIDXaYmdqwfUGodtoAK6pXYFbh7WBSUsFroeeQwJQMubhFYVPiBlrey3pBtzbIokj/HYl3c46W0e0hR0PUTXcu1QcLdHPcrgKOgg+9FqvahYXlVQZx9HSXBDkP01vpOvij5m4YqeBGz3xV0U5PVg09CiHdRFyk5axIMYEjltL50UEG87W2urSNqN9Zw3Jvd5JnDcBo7ZwN2ewGdlkPASOjmP8tNgpBvw2k35ap4NYKmryM8ARctPN96sFGlikIkObzjggjuWTQKdYQKWveW0GFuk2B6SZML3ZXSGPM+g08WJJq08F4kh9jOePI7hewkd18d9iMDxz2mcj07jotc9NGd0LimKoW3iad+zTjqtXfzTaQWAlb516HScysXyWUc/oUKfQ3y7w3xtme8VJWM7aZdZizdyT4s6Ay2hFSH8KKHIKENpngAE5R2tYpnzTJ4jJqcCj8LaTF6WCk9lKGk7LYM53L0qY3PGyYe24KGVMT09z2RMi5ONaXEanXbS4SwezzBOH8Iz7BCegbLPKIewoBU7N6hA5+ODOmtP5wab0YyVbwowjA7qr7BQD8ljh7e3U0Cnc8aKL+KCSedhD+lI03HDXO6ayfsumbLz/HaY33QCY9LSbvQeteLU+bAno71Ivey3De84h01Ljke3WEbzQUpo26p+m+/C+wpCpAQhBkEA/ikB2Mm9ypXSnQpWxGQQohCE2HEihFixCLErz+h0M9FXnviJvqIYsuMJxJDCYIhiX1FiyArtAIh30grQowOXcLuoswqkx6NTogh17FRXwm9RJQOqCP0H9HTWk853BhN3Qso4XTBEi9IJDmrGgJ82z2GzK3czu3ehj/4DvOUWdEk4JngB9lext1Dg87WA7Hd0P6gxuiSl2e/qyqqR46sr9uwZ+S8YeC9FsGcA+NBliHnJgE+hfVoCtVmihEX1sKrsXrWJqMa10i7kWIynR+9ZHeuTRq9Mj86mFdKakjWdEtecjBs8WNqXZzfZYQAHzMGkr9Vxp8CDdADvYDNsK7rBz8aVfezI1VgiDKbDzwLhhz2wfhqtzP4Ev3loDRByaXtQ6OaB73/WW+/Nb0r2W1/tD1zGPPteXO2iGgOn4hA7+59SRqzc6uXC1arOysUBC3IgoShRwVs1rGadAhUXBGCY0JFIt/wZBdmfIsvFwfPNSVug958C9ZaWkA/+PbtPaZHYWisSPPbrrSWTIZe4JG8AY56fx9ok8hm7b6MGLoe9HP5HN00/tKcaWrfB9Ut5PxOjJT7mgE+J8Rxp1lC1Yw0De+IkNveN08mIvE2rY7J/SCFn2NzIPqNwkvzcYn+1BCHFG5hvWompQstO3F4loMC6FlU04WDmsOSimkODcFXuevEmdnDI5/v5qHiZ47My3sadRHYDi+6Pytj6Q54PSYTB1PvmLKqqZUI1ZDC4Fzo+XNkh/ffQZRcFtlJHGqNSCUddnWMEYZd+jklGBXIe+diNVzYcJrhn/4Yyx24v4zLdOdTRELBHld1EBEIBweV9xgRidj/yacUDMdOY/YWAjtO4fw7+fzbTjm70cI3sBjzr2PSJ+8DGK+PSYqJfek8HdMUTO0NjNft7RWaMzpGgSIRGY/1pwG0K/OJqPogVsdx085YIVMTzdUANyCIakE4Mi7C8K8Z4NyIwmJGd8GaRbZT3yk4mOUgwXZ4vDS1CCiGgmV0nDh11IDuKyKPreYhsST4nDcnnpVF5d3BcPVXM8tcwjKtrHNeHNYl/zBrXQY9Z9HGUso2Ct0ice1iKKza4NPXbWyxiCYxwNiPwIA72KBGVMHVvuEwLDJ0+Xnqy7m8vMQqCHsv2wqk0tYUnwWTcCVUyIn6ERW5VyQp4xx5Kd6AGtotoU2617aaV/LRgP1y70DLtlkW5wjzwgtmTI7AzaCmPaFGc5C9ypbLGnsGZKEI6sp4hcOBcCdbWRD2nDnw6jZXG+vkerMk4KD2TzuTc8qYnCQp6+yzO4lROQT5+kM/FPx/Fs4se0qbl55iBgAcrNAFDoa1Atupo0BncyNbN9/zGi/b+5/svs0/0zVS875vsEycUZ5bRv2KfiD4X0ftFNmSfCh6SlKuXv+v9xz9sny7lpdcF571x28YH7RMpKI3TGA5nlIfFH7FP9AXdR6s5jAf+Qxc+se/wL/3VP9/1YfuULnzsZ97/4Xf8bf4M+wTkEP+T33bHoee9+gd+yT5t/JGF39q27v3zM+zTxv9//+6ji2sf/b8+Yp82/jnfgX8/dpl9Il77ANWDcycaecMnf/c/XvJHf/F0+5RCPnfH2W/87F/8x1+yT1v4q77yM//+z7f/+jPs08Z/8rs+yo076yP2aeN//KFsdnb2psvs08ZfIY371Y/Yp2vkecTj6ZkJY588mN86yW7zaHwKPn++rdg7JfFJtBeoeCYP3O9wjb6Jt0/+5lsJBTzybXwifR6dRSjoLGJdH/2skn4WtWQayBbgyYzCdX5NQzzPAafOz7P5mfHzLH7u5ee5/CSedrnIVoSJeLLsPa4vopfwfHb6nyBrrP85N5RAEQo1G9X/PJPqLEQj+ZCDmQ3OU11Dw2GRDfNZTiObxu8Z7QRLoqf3F+AlKZ4KtdELVaSKdjGt7RiKxo7TKJK5in0vPVXVRi/IIz4mTzBvLemoOdKBkqu0gy7iTIDIBYMMdXZwBtehXM7gdlBBIdRGSdVGI21AnlAuzYkokpZTItReNUMjwK64QMn3BVZfMwGfkpQNcBsDe/q9B4SEqdir4RJrN1rBRFO5mG5lse3Sdpp5dh7JQVm+nSIV2zZ05WsKk4VW+lYUe1PklYLUIyxITTQebBlfyPYogQuTQ/yEgO4GSsAxHeZXWF+/BU9j+DvgFiO8UsQv1iOmImIO5hUoAPsxJHMKR70MhQyCVT79vtC/Tvi/YO1Cf01z8gHVKo55Xsgg+TQ4VYrXDIPbUO5wRZfyvWt6AJLH4jUo96yhZ60caaoq2xCDAGicGqOX838KxdK8OmRH6z2uFVkUptqvnrCM+LoPo+fPpwQ83bdTAp7uOZQIH47i+dOGVIryhZX+Elqs+S+X/JBfyqzxyKucwBWBtCbI/kE/2ONflwOqjQv9c/gBASg/EqzMF/qXIqjHk/sk+HkEL5DgAwjuRRB31rHnQPBhxO6W4CHEkgS/hNgVCT6EYE+Cb0aGrgQPI9hCEMJtY8lhjeqCptk/alO1P0hErJ6+agOnxDbKGOWzE0Y2i4J/GU5HQYdr01FxFAXjCgpGFgU9RUEMs6Jg5FCQkQ8oo4O0hkwO6zyKpmMdxIHYkThEC4XalIgWGEQLyVNEM16nAiBaYDYik4gW6FcBC5hOiGieIlqI8k+CaAEFVUTzpDVeFdGCr0NECyqI9k9PMKK959R9YoQjPjG8LXxiBOM+MbCreXDUJ8atN1d9YpTH0RG2mv9KXjFuu/lEXjFuR+pj9B7x9pvHvUeEVe8R4Sl6j7ju8XqP8Ea1C0KrXfAjnYYvJ/qhHCN6Nwb8Z82T1EZ21ipNeY5KUw7o23592wcsvZ1lN3heHOyRXfQebKKxT2MwV7fhGY54Lw6w5n0MsxI4cafuTXUXGDvxsl6riS/e+qNUd7RU1PHYXSRqq0bOvmWX2KQAxYIe1lF6evuwaF0cEMqldFikpnBqUjwsmiKL6WnE0aKpVe4zNa7rPp3MN0jFQwtuU3t9Xb9NqYGYJjURQ1NKaGkJsZZgm0apLaGlJcQUTy8BPCJ3ObFCIn/keFPlC5DuemnKYzczIXyBKUex5CgAG/SEPUtoRjASjcnRvDrghjYCyJSRf5TbGGdH0QTFQZ+y9WpMTRsJOb/S+NsBbP0+pdbEp62tPu3kdRJpwowsODPS4mLWtBn06HkYaB+trqOzrwCuUXa0aI2AIqYWljoB71GM+PqQWhtVhZAWolvrjAnlh9+jeJfeWaRl5zlL0QQEIkpHu9Fc15jpEEgrEIjGIdA8AQTQ0zyRfuezqYw4w6QBmDRolgQG9hIdrG9yLOxxFuGzpdvxMJ/jMZU5INiU5U0VmMR49CanpXv9yI2wKdSiDOPdpNbRYn5IMYjo0aI7XL+d5okjusThorUBPB9SypNJql2nuaMMYh6IO62uCq75jQK3SZF0VtU3IAEdTY9LFv4FeJVetCmgLlcgvVjH0MDlR5sbE6MAHpvxkYknRmaPBe+odkxjQIBqiJdxwHcAeGgcTML8UgV8opLZzmCfmCFK+JOIp9GMqgsGxIHEIYE0tDXR0K1ngsjUdGxntUJuR8T476HknhR/NG/hmREqPZqntJA3eA6FehcSbIBOa+72datCmxiReSZQXScOP18o8W2M9dEivq3UVBAiHEGRBundo0V7yCBvaq8yFMMTiJFgbIBHB7BFbaCI5j3JYAeYbIxS6470dClFhEzAcQLUPAEBArR0KC/NZ3WYGS7CyIQ6nhFzLHrlEWkL1CF5FVmgsjha4J9hGZSgS1F8Gpq1KxDWQxIwA4WTCLkJQrtBfKWcDV0AZB1zse/UWF5yLWv2m34AVbtyMV5vOJ0e0QO5Ff2AHploJd6e/RiK0Ch1wjmxImhOzQhta6isKS+hqaD9OC5VlTZ+yxNJyRuM3E3BpHo5GQOlJb7WiC1aHpUec3Qx84n/rukXLV3WBRSUckR6rVZ6a7xKTVlx2oTpQW2srIw72Ko3xXAcSo4YZYvInLE10XO7fVc9Ay0Jrr4hTDgszCFO9qBd9TVRoRzcqnUEHKiqUL5/axXK/6WqnD9+knb8wBPfjozbkY21iapt+omTtOlXR9sUaLTyk1IJ44e6oQIaZ29BauEf2Ctna0o40FoI3n7oU6c/kJ43+0vrQlxgCDKP8CDwsNqhAPV38Rgk2iGoAjA2DTxh4P39wX6BKoXZ3cLC15jahsA65FMCwefCOSZ42QkK0094IdTy8CdAUvfEMimwR9Z3jzyI5EPylD1GahED0ykE+T7wwQ//4R/96Q3/4+nXQFhFMeO/KmSJN2N3IosHb1BQjbZM60KhuugK2xNRvVIiMignrW2iKK+rzha+1565E1+BzqNUT3yUud8aRx7vPsIqsTsWlMQOYGYhRwCUKZcJrAJ++casW+TsHEYV5ZQ7i3i9kM7KNuIoFhSQPv82JUl1ABh8rhRI9fXhnUWyntcNfidHi4Tia2VxB7Xdx1Sp5QFa99Q4SKEeP4cQxODvmv7FwX7GoAaGpM7vyulIA5ocEYPRR6aasHGcj0LszzfROxQ/uAWExe1pUt3TtMywJkX79nxGrhikMrIoCWHl0okwYSOGBrWPgjkKaYYiDvXQ0tuRPTNZuEWlDnNeBo85UY5MCE+3UAzdt5999HVvvyVWXqChFJ6ijSJCn9DxPAZgTAoASOVHHxYw1CW7QoqzJ8heH2MD8iRVTPbKO7qAP6dZy6iHgsLT4dBdtq5Z2OJh2DDG63mCZDJ6L6ZBEYrSMUd5Cm1qyNrTqQ5fArU2O0BuICc+iTTr1DHVLqhseasRphSZUmqZTIzy/6pCmbu+/oQy7zqhUObdKpT5wKkDK6oC61htC2CFY8C6DEfwo7B673RYaVgXQsCNpsEtPMigE63kWEgPIFeBW3giuAGoChuAr6XgS/QR4qFw+8kTwu2nHocw6z1f18Ksx9ipn57oVFTtVHSKnbr6cXUKCDnaqch26rt9LI9Q/LHyMRWN6wmaLguRNAIxvBO2/M8zrPRsSCE2XrdJkzm7Y5CuEUvSj8Y1cjBCcfwtJpE/TnFwoPTQ6Cz62ZFZxG0HCVWhwL8OvXnfCefNGx/HvHnTBIoFVRQLThHFXnFKKPZzpz6YMMxsRvPoR18TTRlMzRNAr88N6DrnxV51/aO+G86PjQyn3SFFukfaYkAHD9zwIrGX9LUd2F894cD+mg7st21lXlxqk20/VAVxlxmkbhXjtppt4mNtacVqOHJ2V9MP+0GIvYA1eY4RLqfRle1aeWBGOrFwLMx/rCIla4MvnBQFOJqHkLNyKh7jNDxWORQ+ei4gh8BBnL2JJq1+DV5RvzR3TRNo4SRtQUQsGx0EAoOR+pr9ghXGV+a4az4fR2J+ozr+K+d3Yud39ov4XHuWSMFF6Bo00ZUQDQqrDco+qCPyhbAh26gbQxxL6N/kDnFcgy8EVBWnvZcrIGubRd1pW+Rcv1PSyxvlG7EWZR3/502ewU4YnLcEiq1SSXV9SI2Nou1EyHqZKJ+htmoD5u3sQwpDsJ2QfDU3aAb/rbMMa+Y2min3Y0Owlo4Vb0O1vJt3dP8JJdeePjIKDCvWklBP5tSMIZjZh1EdvwYsAizaePSo7bZLM0eLbHgUvZsp6+JI1rXbKOa4K+vcdtWwgMWq9kQDU/fVHC7pDYcblFG2jq7NblQ2YujAo8iMHW2qym0044YI6OHB0DqUZ5E8v1rtC5J9ml+ltoY6JtRyZectSoEEqREROctcKJgVTOHAEXCtVffv6Xs9L3RUwF1sVeEZVGyzXwKkB7rFiaHSl2BKN5jq75UFm8MDcdTQkPzi8j8jiTuHGlMXjhVq6N0xDyUmENZmH5FqvLyOeVG/pBbyo4FiY+ea4EnVfTa6ZtYPr7yHPXrsk046M7BzDZ8C0D4+fYd0w6sqfWNBAMZNMDBnSokDbsOxt7/msG71Ueu5tY/xO2Ce/QqqSNPPegFoYXSD08I1I8ry6kAJemgcdciWzU1AJx/O6y42kWkZKQ4oSakgQEO3jOUkNZvQmJIhP+S4fL2Ci8OjmNPxutmYUjCRQT5FLhCQPOZM0IvCiQxHeJg8nvjB+K+suyFuQfJAGQIh8eDEVIYjHfXVATuJ442sEEGaB20I2SPI7QKkQlSkRZXFpEKwy7HBTXaj3253B5zXsQmli3dORm4jt86OKZFWfXhPhvb7fC/glou/j8K/pNZCC9Xxh6zq59Zabc8Y8wpU2q1bGp5hyCoNlDUcObHH9LgQCA25QIRCiWj5umgFqtHObfko2qIF4gc8qf12UJNH9svmDj6X72n53lblp84tCcDoKoPkLEBJJ6lM25Om/w8GslZ1j6IOV3wjagTMzLqOpEQRjnxTlS/DIyOuDkx0wBJ8wgmueMxe1IHxeWKKx+ua571a8Q/l8Xzs8Wz/K8zsZx675ek3wtfLmUHy/2t7KPOZT74BB35oy+zrkEcIjHwI2PRSKQB3YPg9+5GbDO5ktyLEoPovj4Ur/vUJrhisoGOL8TbGFw+m8cUFPryOeeDVx74BA/s7sv9C7UrPNUtgzpay3zcTR89S/kBR5c+9wMeFbLd2jN6/7srEziOlx5k6/gkRX5MUxHnICCjwm1SlYkuwzfipgUVEyrSb3DED+hzOjOeKVnKpQiJT3apuUbdOrdEOvXGbCL/p6/Uoc8vWw60rj+pGLFW9/HGJ54+KdX2FsZ99Cp9qgqbKCDm4p4ef4AMHvUC8LMcJnCH3ymOG4+6YQQWE40cfgQ+efOKWEypwnolC7UwkbHnM3LXj4CN22aPsu3DcsXDc3gk4bg8MrucYXJD2krP2oWgyjZ2Oyu1yTLWx7fKjrdfKiVT1TX9kAxYeFCdaoY5jbFRAdSi4WngXSi4y+XNdcKqbrRClyiPUh9tF62FFrFuHqNxegNZO7qnf/YRih66F9uYXJppGOB9cmsMzOYA/7pjqj09yTPUW7K6tUQWs3eTbm+TcODN30TIk7sPPBQdxmd1qtf6eu1EWGn9bqrCBnJiYWPYV7cBS1NXgbxGApZdMe3APTW5SY6zreucjLhqcW7xH1W1zPApzcJC+2sOVz/ET6NVLZxLXnAM1yAfHLEdAQKUp1Y/ULMzOL4V+y13FIkf2DL3zVJwgtg8Cc+2/TppcJLgmh9OJmGSmYS+Gz5pm3+TJ8GOxq6OYFIOEEHRSdMM8wESBSWBsihIpo60M1owqwEtJneqVrwylJNTBeKD+AluTPMNYZ3LvEwpYojPRxLCYnLlP2CEZ0EbUhB0FvS2moInw45egDQDTgCI8IrddL5U52kpfZdSiSuNgVolSJdVNad4s9k40y0cmGTVxSsfp9pQO+4qgvF1496VD6QBLAH/7aTd+zzvW2b3XgR/5xLOf/Q8z/+VS7lVmqL7e3Ytg+817idL+n8fA4PyCGgJOX8dP1WVVq7yIpLuxdLfIVFinD+2k6XLMZAdECV32DSphnoVOAzV00+nuUxdWtUpZ1afe/cl3TznrQJ4JWdUnkZfbxo9P1py06g9Fkxna6RE+jRU1B60tJVUve9Gg9bWWU917QjnVJ5RYPqfKjVTNXgXlabNgJea6w0Q9YpbjY7eDcPtBBSkYoE+MO7f75HTndoAGONRnCReL+sNq/aFdo0HSQGFDfFK2gCKJQzVYPbbgylyrHFvWslzZv/f8SXmdW8Gt/3HuP+NuMObfLxj1Legkd49RwPvJCVa2VeVkWxOM7N6SkQ2zP8LHJ+ZbT9Ld5NS7C8Srdvev/jUnoBEX66oZ6JoaQAaCCA1hxdZQaOaKmaSxfoWHfQunHbaZmfs1O3I79Zl74VbiGsctT5PZXM8iqUGmp9mFz8DV3S2U1FAaoB0MnsSvg70581mq8ocheZ6ihO7orxCijsycYuwV8I2h3ONHsJajFYFG++ldQZgYHZZJrgzNcoKh6RMFyMfgytTaf6Cc1WeVsxr4wsE98xZ4qr4IedQcKu7Ky5WlSBqNTyhaBaxAMlVx8jqlbYraf4nyFPVafMWqQLre7YpQK1MY4LxlteqK0NDUlBFQeAq/wR+LfgDjMbh6LNZ5g7xNiIFlQfOvyFPUCyYpj8EbKGRHL+A3N4qWin9lqdVOq/UTn1oqIp5I8Uh05xyDYC9eRToYESfWB6FT9Xa8KLZkb/Q8ladh4efp6kTSQ/BsB3Y98wdaR+/49acNr7XKkjbLcc4yzMOKwScKhFX0qoavimgIphIYh1mzMSx8gH+9qBatzU5/LYp9sSDBLXIs4aFQeEIlKhAL3vP2m0UsyPh6DySE2QMydwYQNGhiqnzKIamKvDUKYWBAeBSlwIZtjshnMPXbrPB17X/7zI2P/NjTRQlFDcrJsdpBXC4X2RxuHuWNSsbxY4MmbiduOvhRffOoffvI+shpgOKotAooShVJpihLT5oJWL9sOG4mYF2uC0hHNjcQHh5VGxcYyWxjUpwNLgunrrJ+Kui0CQNPVtu/UteqVuATgBQ1wJeFsGWWZ+gfdZQpsLZbIuJHVLXdxf+hs3d8b+3wpfdf9Oq87Y4mWrKPSCvNGtOjnzXd4RMF13KapfQoVWOG2s98Vnqaz5UFXnYs+zHB61mXP2MDc9RyJwMbxSy1if+YH26XCV/i2m34P+y/RhW6E8zimGZwKwMGMcSU4RjuWEJ4KLRzKk7f5KucI6ic2IXuxM7wxKGKAVQ0EClH6JmrbY4f8xG3inVIBwWZNAtePD1x03zMZNpSAs2Cl2DiUC7Y4lAuhBQBtiD5r5QihBOHcq5h/Im2ibO5NoWr1TM4OGy+wdAWM7jBUDEUtGSIxlZpDuKOZn+Nb4cnMfrxi4/OYOvo0UUIpvAL46zqF7dgVX31w/xhPwrMsqYNY3MbEzZCDjVG3x9oDCBOFok9u6fGhVpHCmQ3wLFYVHweq8Fmc9WYsVgHd4s4RpP1dJWwi7qvgdRyf1gEQFSfrYA4gyy6aI0RJ/O6j41UxKBuVBqBGTA/QPX+Zh5SPQ/s4gmihMufe6/bNHSHworFEqNPa/enRaR2SKpN8bEo6YyRFmEA7vBDSM5A21GRtb5SA4+FJ0AJoivmPBMHpAaOfJngI6lJXu5PHq62QFhWyx00yJ1PdTQlRQNTbaD7iFq3gSFjnqaN2aeCn4jrkBUspiZ/IxqSKJnfBocE8nrdHAaIuSE+boz7ODpXQ6htHAUnUOllbBVASJFVRkIPN+SYzGjWkK8zp5He8gRLOC0PPAir0qnPnVg69b+oFZ8/SSt+eXKiHfImZ9r+0ffDz6zMtEOvnjLTOLacaQ/9Sm3aVDv0azWda4d+uTZ1sh3yK5ONtp5sRy4bPrrJ9tXa9ROzDQv/xGzTJVzbMjnbyMy2n9HZVuWk/NJZvJhOjAaI+1rOOm3oyKyLy1kXK5LEdtZFU2bdsdpW0y6ePu0AESkTVvFoq2kX2WkHWNqFu5G+z/N8MMMsNPMOvBLmaf/7LXrsWyuNEW2U4Usr4Sv3V/mTqcHSbtcGr8benbmHikbuqUI/Ei3BkGbfZ7WHNo5STT7RDQBHkKdYwgm3bzwa1Tt/RPUu3EL1zhtXvYO2yMOjqnd/4zbfbrsdYZr/K6ne/e0J989/pwv9KYPqG6B6TEKsByeEWH5VS9E/RS3FGx6vdm84KvHzVRH2MX3yqiC0i9AmSDD6PHipEm7jrjDGXtPNZFG4YziLdgnQpT5UH4JFXY5MIN2ugWAZLboArILQdjFTozcLByref+6IqPbPTyiqhVsIYNXWstontjSrO8TlqZkY1VjjcUbpD2npRhiBL0/2xcNTvvipfrR8Y/DKEUnSfdjoVOUB9zp5gGwSPo53lQZokuwgPoFgql88MPbFp90XD7gv7pcvDLuDxVo/fmjs48+7jx9yH39JPgYLLRciUYYIkAgTNUFoBaEGQj2Emgh1EZIqM4RagvUItRHazSE8z+GnHCnNgO0qlXQ6Ly4y6qwdhPHDWVS5Usy9OJ+XIUZ6l2YP5gt43aO+T4PcN0aecDa1SBHNvgTON2nuxfyYWzso1lb4ff4g1deKJchDQC+WqEMLIHl5h3ygiG/5XLn9bEa1huPIHh6Ub5PO5csDARbaFlJnNfuyMaefwTzJ/NoqpahRzNf5qhL2IPIXHQTl0yIC/9ahCBTaGIRaBlj8NSFuaE3E6e4gMqU2za3m/YGghWTG7P5nVI1iJTpvC01DYjE/AC1wla+4yuuo1Z0Zwqg/2rvEjxtWRaxTM5f+wFkpw0ot/F3RR0a1k1sXS8qUruKIUW7Yz1Cd5kAezcAWsJ+VwdSUWNraIUXiJrzySYgO5WIjPqA5fAIrecVO2lExDRwNMmdDeCdtH0kiwAmDV/jmAvscQDZHixZoabVGNIBgpqtyP6VTueOzpMURijvkSXnqp5XmrzCeu4wfi9RBdnFLyAKOaIKxOjbD4OLHnLVGD1OFomDiiC6ptfklA8XqkShRPfdJEZ30mHWOfANq5VvJ4XEyZitsBvivE4FAv9Vir2K61RCdtxqiPMUwuE1qUKbfJDRrnWMtDEL8MffbVKPzNSUPbZmrMhe7A1VK3AZExPk5+S/OG4qXc0JFGBxqcymfVXJ0+I5RcvSwI0eSpOToFgRTh+++fnzr2Mdvxrt+fKv7+G3ysV5OW9QP7xr78A734V3uw3dqrdIkUJc1M+2kGuk1LSJOSLl2bwnLEygNEy6fx6nLBy9ifwRtl4JgIEHMecyBKVvggIFwRCkO2ZUqyI7EqPlWB5aWMCfmVGyXIjI1RkJoSUZxgK4oiVL6JOiGV7XQoPLhCM1BTp0gPialdABUeA5UmFtFc7j6OkoipaSiI/XruEd6o/gOD0+KMLod6RBfU/dQOceBkqFGAVzed7BYwVQwBCufRfw6shRZ2b5ifmxqYSBftSr7t2CKIthOMVoYEJ57zZPME0YVZvGn5GyBK89oHhi/QgtKzpaEnM3T0snJGT/u8BgycMLjyJrMTP58Ok3TTNkIOcuogy3kHC6KoDyMEsVc/hymqM5Xq/HQ53ZCxsmFkJAxDWeGjC1qc6ntSJuEleTNgqLN0uIV6ngT5lJx3NRyYJ91YJ8ZBTuwlmtvGYqW0opQtAoMluDjxlC3WZqZpG7+BF2byX1aeIx0jalWhagBgFEFgEu0yBMwAgBbAGALvRY67tBwwaFhS2nyoIPjL8FHD71xgOk7wMyOAWZF8BHnY2gT/hS7ZqTMPs0yJKbhab4dQGnRDOzszuYRxCzwBjE9L5e+nXzBqB20RJFFzTmMrqISIygjGyGmZmJ2Go7C2rx28APhAaZsN1i0U7BlHhgyX2II6NZUGMyNwWCeYfDf2EH9Y5mTQBb8ORajT3OYky0s4UuGwwvA1lFnfFbuVW8GAeGF1KOBvmTq1UBfauIQgHDsY+ZlvtOIrwI9ZoXgXhkNyLM9ROF1nB2JrKcC1WLCyqnATO203M+A3Esa3sthoq2m6wy2JTMlYor1YqCug3i69XQEqBdoyUzHecG1dNqsa8k8HZ11EeNbh5T0E/k686LRmbc15sxXGQk0X3kHLAYqn8phrE/XNEEhN+VmzdJXx9LHzUUeYD/Yd/1gHuPNTZwzw7OkQ0YhrvUQzTsPZwXxu147N0uTv5Z3QELABqoJG7s0Gk66i750zd6Vmsgi+9fSGuBf+yO3X/xpmrGBORDTARnRjA31EOpKjRMm3xzpBO5IR2ShTgtWpTM+duMQx3AiMpTimLAUxzCBcOIY2ZAFW9cSai1o06jOK4t9vINy2C9fRMhX0XmVS/pVnVdMmkicYKld/FBU7PURygNpRiajOq96i9KJTyCbniKh+QyEWacK6yKa1EMGtMtDSdUHPgVoq84xhsnCevKsEAXV3T2gBFMorFQSqzy2RrFUUoUvNvcK30DhO3KYGaMpBqJOyRjm21Qg5pWPUB818lUWxo7fJtSK9R7tBIjd2eWFp3yJtuK3spa+aTlegi4/7m3yrzPDOiq32Bzjod/reOhNx0O/H8HUaD6MffEh98U97ouPIWjlFkZEMvbhx92HmqQikvLDUFgNK2vIYyt9yOul+CApZRONUnLRVEGHYWxbpRyjXUo+Zkp5R6eUgWQCSIRmq6KDOflI5Rdd3hl9fIwvpya1yafZFxcLa5RyaIFZ7oPFIrVeXNTWVF9jFpSUFrEDN9IM7kGMlFjlC8dlcfBlYyTBmp4P1UCdZEevys9dJ2Ooga5zgSMyhgbNirl/WKSdHWAk9RsrZ8ibqELi81RmKFKL3gCeX1xDtrmGxEIfa3DmIAtWQj1x17oFi7DMa+whTEcErjPPq83zKkoBLfzp5KytiknEberxbIn4vQ5OFoWjE9SqMgo1wyggEWEybEjNsAlkwjXDjrRKJmFZRSJqloxqjktYVr6hVmUSnGtnYRIc65kYGGPt504Kg6Av13GYTPhqYRA0fBUYBKvs3LMMQs84i3Twbjp4N8bgDUCnVDfQkrtT2NePMAh9UBOBXlyJRJ+pkfvUBkDBwZJlDCgeY9D7hkFHpYJVYBNaxoox1marddIzIgZsUtSVlcy8edGC549kyr04X1G8UokjNxwptRfnvUcvK3gMAoIVMbr2mAUENepNERA0xwQEs6C3s/a8su32IOo3o620vcuBnk74GqXlWNQqYoG6gj3RyTwLRItHxAJtQL5Ns6ciFmipWKA2LhZAr6TZTJRmQYS4VTRbFQvUUIsWXLQqYgGsvA29q80EFuPYkv6U9/iMUCDvOfYwctCYA7piIyaWejC/HVs8r62civW0gs3Ykvlo22OjNkvUw5/QGnHTyvsbQVrqKksby+RqUDxKZlRKUFMpgRINEZK1dIesI1hzUoK4lBIsj0gJNFNGyyNSghY2ubOqzu5jzKjOpc+C0Oh5sb1TEVEXQ+KISq1CVEBWpLW0rRQSaDiTvD1sAXvUtEKCpgoJug787a3B3xM5SNcQnZQBxo9ZB4HYGENVTJ8kRiojqEYKIeopIdIrPLNbk6BkjAQp/VtVQiTn9DUHvpiaYAc4o3UJ3CxFBHlFTNB1SLmkVFTFBE0jJqhi5jYHmt4YaCLFzLYIhuv4Kze8WMmEQE7DVBUTLGEvHFPPUOYob03NOyomELZHcXN2REzA2EazFTHBsmUKdLNXBWGXUuDKdoNHy4Ivqo9b4sjU/s+O9b9OKxAR9B7bjOxRij8FWVsANqtLf5vhUi79Mc0+nqW/8YQv/XqLFOSc06rrf62y/m81VVUJxaIlB3T9j6dOxXTKVOxSbKZi3Uy5dIv1f7YSSWlew5QDpsm083Xa1Uan3dY4U9cJp0TJbrOdeKBDGS3IWuC2/ZhzDTfn2uqzlxKVEzQkTwySQU35AJNOWjirwwSWz8kJ+twEbaoIYHdSX+UEulZBTtACGYEwNNHWGZvShhsOKg4C3h3yCXrAzsam3/CDYgRBF0ltbIaITOAwPKHEKM+s9j5KHprVoMZwAxZ8kw1Vg3cGg11QbDYmuPkcStTVf/7swXjgewbUOPDbH8e/By+Dx2pRVbqSR+rAF17454d/7qH7n3EtBAax2MdrbW7ciZMeSsWldXtz447S3CGu+snFNAziDEI6nSIRg0fi01t0ptFq8a4eE4eIA4nV5soqOlJXDzAOgxppg17GVT8cUPvFsOeCEXWqsuoAs2iOahD5Rm3pbdZaRee5kEHhUMka8BV789kbbjE8FTRzGVHE+ikTRxlmwQIGISIciBPyr2U0yJhkUdTmgkqdqGGRuHoNn1onUPnymvsbUR+mi4mgTvYmREF3mh6b+AjXN08k0IgejUDjZCINiuwl6knxUfCvLj6qXpmOTiTbcFem/8ELRTzxaqMeCMpbmZrCg0XyzKD0dGZAeX1U3RJE2HjirF8kZDg2JDjip9U1GSRyUYb7w0VcBFundvGAeVG7eMiFWYgWlMSJ9AZ+BE0qAU16MKV732tVSwR4+/YiAUuzF4SBEpCovdbgcwBqGljDmDV33+XzXqAmoaxUJih1IhXLuA2iiXfLLdZA+Lk1ko2MEqGYqYXsyfR2MdUPwoDnj157EBdsqH5lH9mSsWy1yWxrwD1cFxIyUE6LMHstKi687HV44uNPeEAvj9t052t0Eo1/8npkzQ7rfIq4T6UJ8MDZJLsvdF4d6zB6c4wbP03BK7gnJE/N+6ulGaoPetBo2ARy88tdvhgChyxdkrJfvkmaTEH2Zm109iuIoTonHw/hmUaCx0Imky/Bra66XoIzkUBslCNzL4SKLGbaWwQOAZYH7qVIiL4dtzAwET4NvTi069PhavZ9UmcdmnfeqqRp/G9qG7CVGYm/Q+KxKwWyMgxq3GPlyxh97lGnOmiP3n2U2EunRe51kb9VRu6eFtmb9nlrSmQZo42s86g9rmulX/xfqZH3X31MLag6I6e7Tlaa5/XxDfaym8bYtr8OtvCO727rpaWp+cPJ/N+Vg9Klf+D5ozcMY+e0dHAcdNUKXBgDEUKT6jwxBcwx0O9HrxU6vaL5YI5C82U2X2skH+MLF7wqXOMXbzrMxcMsQQx0fSuwUG8jP+Cp8ZX78OTCehcH93pCFms+huvz9iXjl4c9iqsX8r4aRdA4hCmYoFTc9kplVRkbrkFv0xz3MEFWMD2ytc0Dv/6Lm2+JH7yQL+0/Rf79wWXrxhrJ5nDAAD7yKW7zRsUpMrngtf0y/sh+csFr+g/7RQBCc3lfLk7WvqVf+OhkaVHZB8VWWYMYgwqvNONZjiYGWKxlvIK86cZngheSR/yEH1fxmVrLjigtAQm8DjU+BzgnU+nbNfZl5KtJm6v0G05T433kwY+VAggNudfLvl+oSV0xFwnW0hHoK0pvOcNJPpDOXhs6m4cxT7SU3HFDapni28v37AdQgRqeQMpVWH3c3ciIZyWin6P6VOrfed0dD5brFUXu3lrV4a8wTrJv0r6KUiaWvQO334Z/f8QcYZOijWH2g9JTP3sbnmpV6xy9GRboApJqZFZodzVSWtcajwI2Z6jXkiiPX+6vrU6JvXcitt72FFdz39zvT9W0lNxg1Zw/hEYKI+aV98k9H2cnlUmsk06WX6Gl2Q/jq2VMrjODvRcFt/oI6u40OKwvymE85OmLMBEP2JeEX+7y9XNeBNZ9ie3lsU7f+zgJhrw+bcyx3OuL5fj/8j2fveO2267/pXU2BfmhN9z7Iz/7+3dcSi4I1vi4rxP/HjyBzJt+Zdrf71em/Zf4Jb0zgqn/V4ZVIlbVSj+3dswXk1lG8/Sok6lOmUU+6pAsNUL4E0edYupRp5iKYDqQRDfJRBMPUbjik5UTracpD0rmQCdbFyRIR+9H8DEAlcKS1y3ORzvDsAjKLcGBh9/1hd9/7ndffRmFfSS+U/Bh3V8ros0JUhWPkKq6I1X1KqmqO1JVHyVVIXgIJlX8BKnCcFpC9RAIVXwyQsVg5x4BzOUYgEnDXZQr254w6kf8PHC3Nw793/uz25RbBERv16AY4Ask5u2I0U8xC6ojW62NQikAVCxW/Wjy9PDSmGgILcnS/YARB4eOLoC50WUIs7kH1HVuOLEMyGZdxycP3GQMdDh/1ExGtyH72Xqq97D0HpHczuan92rrUiYquWeKdOvODX7Y2DV4SJ4wolrfxJb8cMTv/DyEpydbzCORSgHEnVQT4VBVoCPLb+LWo8+UDrtvUDjDbLZg3ypkAnJYVIgNw+lXfTpQwF6ImoY+/hXfxmqzlOB75N9n+W2GS3izL5eY5dZQRvEmi0OCfI4jPsFVxs5NquiHCOE29VII1Qg5fuGIdZ9pEhpSNJRPRQfgN6hLEYT4d0SUEocHd0Q8aZAR6rOI1zhhVRGXuTjlAKHWte6/HY9jPiVHbyuaCG9qeIEWqHlNf13cxFVvTF8j+wVqqmhDzPQUXb0LUtmOC3qBrUORd/nFAp5JsQh3XAE1XYHqNkl4MAiEVSoGvig9CKVtuSffELE1Ay+FP//kJQxXU7NotaYikZpDEfN6sVxQlNJVmjPuDKizmsuhwCoKw4LYZXR1jDoaB6EEvuMcCn3QqHnAWAzireRLiBfLeCvQQlRDEwKzWgH7uU1sEyF15XCbFoe0sAFUmEN10BdEfXd87qZj97z+y2//Cle8hYGKIMExwTyqjXS5A25g8zAedelEzF4T81tlzO6JmN7EV63xGH01WMIz0c7ZN/oh5in+Jm0Jhs+8/X2f/fht7/vsl3gDn/Drb98m79jPY/cQAc3dzlI94We3HjYLkjoU9PWymhjFkPNHtakFvfaR64NgT5TPaYitZmRUX2km2wX7paSauGcEWxIzlo2TZLYOUUrKnt32W96IVcFOOsiMOUk/u+8W48bUmpU8HkdB6ZvSQGOvI1meapCoK2WmUwPwsT7L+OqKuUpxobimDCdsYxVJ5Uqf9Ts/VOak7sw/uOmI9gyPsgljQ4l+gXOHFK5tFmwuNjFr41WXkQuyf6sEpAwyDTdX1fuQcNGEt5W8qVMhJU/NPEeU6kWvZmlWryUMU84PNevcZmR3Y+SXVsoqcZTmod5uwqUlflfPPsYZiQUDxJd4dPDI8oxaSi+/AnopIurGcDgGA2Pq5Mz9Q5rZgB9Et90jvyK/RaVYNqDiLj0tQulpgZbSJPzZeAN8yw03eCLPbsIiuFp3gxIc+gJPcxzHFl5am0w3BQwUosVrB20EzGmUhk3IBa/tI/XO4QY/fOI/0A9VLWD4z5nrWuZwXldAWcZxklIXlROaFcF6XahkU2inSt9BEfVWKsiiksMmk1M0DR+WlLFJdVSmRyJah67khoArbewVbRHZopmVDR7GPTnK7RdjKCM03edZh/wYHdsxrD6QyJzDz3MMJ8/BvZa6HA/9DttncXf33RXxZ97Ez+su4t0ZDjU+UeMlDHQjD0xSdpF/uSTdo0nKLTLxU+cT35794RuEd+HKitjFqHADr7J9c8JUGWJVQ7L+5fByuRzQFiljPQiQPfDg03xGjyDvqE+fQYYF/Poi64PCwSaIKkoWHbzOkQeAzvNpQ/c2gdmhW84b8AIYgKOhrM/VY+nqvqNYeDhm0om1bcRbXovmbqPZ22h+aCnBJhvXaxnf9Cpfm+clj7q0cJRzcSRUPcXWStbGoGO0m+YADEwkACYGFhzlS5Ty5Rn5DEbyIab7g8O44PhV0IzB7yA8+NE38K/0tp/9mFJKCIe62d/cIi8Mb/0e0dlXNJLXLUkZ3PlGlGe+K0Gh3+pYmsz6pY68Jgz++JD7NjM48TnzllkavWbMWBnhCekWqme3Z35YClGyymZqN9XgTMkDPEqkBlifD7NFw+yzygdD9Ede9jE19lpL/2/Pm+oizoMMKMABF9uBFjmHNZO/AvGlhPoqAIKUEoB635vlU8cs3xR4wTTzvYblesctzkib89wQyTGA2XBD1hxBsoA9WwS+TC3O25uSo+mSCux4VFVgieusSvY7kV1vd/qMYev6CjFAJJdBzSYk0HvGKGtVVALld5/zYrlHghesilcitFoLUdvcAwb93ivQgtKvZaQqShEapx7dQMaMqAemhABnn5v8DjSZaio9QfY84qc9ZfSwSY+qzED6fYEaE53wwqGHjUANQz/1sDO7S2XBg5b2ptwokfGokd1jgZLoqQ1SYc+rrSVSJLquqyUdwgPafp5caGjkATXhMwPml9TUiAwnSLxypCEeHZgGVfob2IRAEzhJE9QKozXN28KjRW2wrW2jLoZWjPos0L14j3Hb1Ky7yxYG1iyNvo5ioJZMZ7CCSFTLRnVQudhI5yq1neoa1bUIK6CAyJh/c+Nxnx/orpHEPL9xsTxUK/2tzTwqbcrkQQldsxjWcscTwIiaGCgOrOQssJIztTIrF6nLwjiZ0cKdlbqEAqef/HdNH7iwTtGwKnDDqFty/a3714eCDJsb62VZx6Qst7+kyGbfD3GdBH56//o1bI0C02Zo6OW3DhDzkqLOv8J0cXtpej+n9tEYd3N93P/W/cbx0tsAYY9xvkIEyRsW3lGpCIOr2Oo7cIxUONifh5bld2WEg+NfZNota2N0dLie/ZZId2LNR5GDQpkWEXDhyN+bz2CSlxMVZY1/Fp9BBmtVKuwPbjvwH/7+oV/e+eIf87ANQCp7GBxmd1kbGMQvN4s5FP/2IQUb3GN7sOCNLLac93bNOVSofNVzxi6P+yMHA6rCm6jU3pitUanix2Sqh3LW5HAV3n+QUOhQwWoJ/Ihyjg8dYQtq0CfmMuqrrBZ+of9xiAyZHIofQa3k4/5q9mtOKFOzW4S9+y3qrF86nKi1CO888KVHPvGKvzr9L9gyWVRF5kJMZV/TNzH3XArrKHsp5o66U4T3VgCw15FBFccCr+7AuxrukVMOdReg01zprxBxtCh8GdhBvEPzu4sTX08bm9f08558l/F3uyW0h0MkoXM4BHPyO1cH0cuB2QD0r1i+Q9v7hK7Kv37L2Kp8ffWM6JjnilfD85/AebKlr24Xsr9EcOUkNNkzUv4QHys/AmSggAt2sP8+zw/kHExnIIy7ohKchVtROEyHYCUcEYbyQfWmbySSmz7U7yFYkgI+hQKyP8QvBZtDcOkVK4zlbpoJ1aa+veC3f3swNCTiZ3BM5uu5XFX0qPWUm7CHStr2NC7Id3Kz0rnRuqyfvpHY/n2ZknB+LovF8L4jtRV7OCXGD/FP3o7PvXSgKieGoN1pZKh6svez3jRFEAUIDqNUDQBLmMosKr1CBAV6fK9vQk6dhNdEymRLrhwbhMFHN9lWZ5QqH6OJR3yWpqXaQ4XZkLwX5CN6FRSmm1GgwnxLd9yhne7a7/bImy62D9Y5iRA4wgEoT40ef93lQSx/i1fK5d/sacJ7PSuVP8zvUNklVHaLp4JghB9AHBqtMNJu4NtXZPcCiAi+MA+Vm/ov5I2AA9VeDfBqoeSsfeqBmvKW3Ah2XijeKr+TPCnQsnNahDVngwnrztYgaEZ7tcPeCBd/nR5jjXEFsTKxVoId86dy+Awy4Yk/ZrRfJeYqLFfq5Ok+AYQCwb9EMJTgpxGUHlSI3cc9jVBqd4+EldxpLZtI10P9j2nwHvTomIY/jvCHvJLooZWbnqF6AATO4/SswHQHUdlolAIFzBo+UThWj/C0nyQgdIdwuEs8JfbIZCwO1KzcPv29SHyPBFMwF0TshNgbWOwNToS94VbYG54K9uq8V5z9Y+CsguSFUMPq6pX6DPdljtdeNIBGDSJa1iNF9GxBa8Td7RcR4/OW2KyfRCfA5VH/Pf6jw2UfzZ7ckCkuY1P3DofL/uPBZX8cl/0KLvsVXPYfLS5HY7jsT+AyIiewGeveNJRWu2xPPEr76S/5QSjHVrLIfxpIk4tho+N+HsrTU/WmBC+ZWddjNQ4swuzq6X3ivG6NOg9LLKueTG5HkqkH+QkPuF26LwXHXJ6Sqn+wjQ1ovpY57KYwdMu9rv7OZOpG9hXxHZgog3mvW9HP4wbe/nYtz0SwODMpV21ywWtxdFonbj+OTJMnkiP7k9eOcWSvBW8KSKuYIFQJRCTWp8wtHxFPHLVzUuUJ/AizoXLS+iVyGrmRvIpKJGR0/CinZieVF+d031pFfwZ3kdVEjMu9cHD4d3jnguJCZAjF6YC04526EhlPA2r/qpbu94xlSvBnG7pDIHxvFVV9dwm1VK+qOkv7d6hfV7jambVM3My8VijknppKZRjhXvqTtzyz9m3tGrKskG+y7JYsfpnlKux3g/SFAlfAnWGJh/QbYd1eFFFphz5UeQjHIxwgylA0XCYzfm8km/R2tOXpN6PpmYUc+U4X1dSEAiSkJkOnL/9h+pfBuP7DXods01QcWE0PjVGXPIpkggMqLUTcCkISt1tHGuqp+AzaqnrxQH9WVrN3KwsjLq6MYVOSO50Ircid14M47qL4yj7eumViJnKVMnENtN2YkoNOgWwCC1Ce9wi+6iF39t5SB3pwAQSmP6mJIjzLfgovRmLTAlmTW2+QIugMA0ytr86f1lkgRoIkf5HIieyqrDGJnNOqeXqx5XYnaIj66IFzFef3FXiqOlSFN/Au58/4gVx1QoGrshnVozxfVcMNlVNnhbLYpinaOOgCM7R1d5sN0163JVrgHzfBatkfCyHYMS0WU1I1CveO+NN1rHSHhw+E5S7lEZy06f/1/OkOeBncsrlF647dYiJ5iEonFx/V9cwICZUP0JnhLnZX5VoYYtfQd4de48YJBHae2oCPmCay9jPSCK6Ziw7KESQHi4Ye5CQjOsMF1PVx6UDmljPUgNSQu0gc5lRMQHEYbJzmUMyhNfL0pYEXqDM0rn/5IH45F5H9jFVWEyQyhrlKKbPwBw27f0UzVdlTzrkoHciVEvkSpZPPVtD7Kpvh1+cJuRFzMh6lMOmW16nJec2CyXCQxtVXKXo545D/8sGDsNRwPQ59Ypb4P9Mj7ydfdwuO3qsOpUpjW6jX2sxAuToje0VsNtRZ7slEB6YK5nKAS0R5gdH4ytRhY199fO3RB+mFy5XSTe5uhM70d+OgXEIrKENFAWah45/z+U6AnY6ZaNNmwBQZBW33yEz4zKO64uBNveLgVa84eCe74nDjc/R6w4h7uDqFg6+M3mx43y2TNxu8f/WbDe+/ZerNBm/azYafQ95auu778Y3eqyekXw7bRQylInBFepsY6lSIAnnrUqR4HzOuriGICQvlH5lO9evZO3QVf+vsDlP8RdSBxjdS/JOve+aNr70Z+OYrvvmCb/ogdQyzMio7U3zTkOCbR0q4JFufHyXG/eQNT/dq1vizUgbpg0wOI5Z3swXytv+NzLR84JavRzMtP3/LqZtp2VRs/FGYaflXwEXO8L8QF3XnOQgfNSr+lR9hsnr4u2ELMPUUGbvKy/pK23HZ3d2HhnoH73dXubNFcpXRU8sRGb/M8C/JM2+8AbfwTgKG6ORgmA4CXmc389Q5bIZECfwuLMfLXX1xjeIUhNQbYbDpdnacnKuGDUCFwU2tBYi8bk/+uAc3cxfhp0iAwlEAUR6Ut9gDCnFvcQLU51a9R+FH0E+d/Rp+hGr2OsdJfG/8wi1jvjfCE/ve+DkvkCGecgu0diZ2Js+kwz8Bq8k/YTfh59ZqKqUOKYJykzl+8VClp5Ey+bjJ5KtdodXsQypCBmAlRzbtM/UkOPblh/XL6nVE8h7bnZtfumX8zo1XvXPjneKdm1c/JivYj6nFH7nlX89u96hbFvHV94u3jLll+eAt092yhGhlciKz3mO+/0Jr1vs9cHMh8NC9urKOeizuK333BsR7I12pruiLp9vBjTK5Xs5P/2XXm5WGf67/f3PfGMtOpWq6Qk1pF6FEih///5eMs4arsXXaeaUzpl3OrEBuRw2I4fXy65FfD3De/wQ2FhW89OTt1Xwnb7JtLdmSXat36Cjc+C0jI+DpCJzM9vpjIFiPLvdcrXJ/8uPAr5OYJ//NWybNk7/N95tO3eS4XxK1gXqt/Ji/ak4vdGdZl612YpTKGyI+OgYHHNj24e/KvmixNTC6qg8LpVq1MWosEolQyoNd0pdDo4tzcpQatbFaIU1jukYaiY8p5A8T8E3Z54WD4ZLwWdGmkB+qcNIeUTjRwooWtw/F2EU9ebksPKFqXIelO9bq2fNHk0gdt0T8Z2Hj7ha7ReUE6tUZ+dlDaKpe3x31ElVE2ZeRpoK//dhQmyvBl/OhLMCmKg8xbg4WdapXdOONJQf/wN7o++4/76tnn4178qVQd/ptE5H/Oo9mCdWhpuwyg8vaEOsER4stTRKkrg3U2Mi+Cplt0SgNCRhNh7xJdS6nPGK9BqxMeSi9zvXceRs19dq/lvY9rvncrQ2q3zmkOjboR02RFS3c5tGNPAEmRHL2CkmYIEcEBYKQ/ItFMykUDfU9CAH24IJG1EceDgbi8X33qs7e7J8xGDoK8WYRUVSFd3Rq8I6q8K6PwLtO0QS8IxGTM7wr9gkaI/BuVuCdWHgnE/Bu4ErKKLyjCrwjwLsx1GqmwjtieEfgyqbAu8HwrvOUFa/qQmnhzsPpgWf/opAbfOE8bCYU1dXqTPYwkoyNQ92t7BepNFgxQLR6IIppcGD8iJQ8a8mPia6W+QjKVIsVx92d+IoiaU2l3nG2KUkhFEr/BAqgEp+9E5lk5DXpC29Q/U6NffA8/UwQyORSpVDtmcQPfvC17htNsDqh/J/VCf07vyLKc/r6jmL/xmunaDo6CDhlytgpU8aTypQuXVJBLx9lJYwuEEjqB7+JD/Q4I+DO/Ja+yq5NZPLW1orIAyFiDiFFJli50jHVzKFIsqA4SULGkE3iYhF34RGa0w7yJxQnA27c7ylWiDdLZOcQPykYVZyMnEDzOzx/2to38PLQnIhZfhwviXjzTxEEbKTvvzu5Pn69OkL8H4/PEeJrH6UjRGNw4/rQM1fpHCsXOmKiWq7K2ImVokqCumBATWaPx6vacJ3wV8P545DJrDXfFVqxY5R+eFsd5/q9G0O+TL78ytjOqAedFpTWZ6yEvvdHT3i/NOI9xB2SpUYIv7kSftiZ95NSUi3xQ5USQbjuxrtm0yThBTYrX3x87Itj7gtNki/uqXzx6bEvjrsvNEkv8coXwtjKdBhIU0oKmVvLg8emR6NQxZFqtKj+RS9jvq5IBkT8x4LwhpnKdbXZr+3Jmy3P2EXC3TgED2mwRQFoYN5WWj8jdYtjleRleTYQm88oRhqWz1EHAzaPGOlB3lWbq009A11Qzy5ofLGE+B4tIQrM3zryy2HS4G0aROxhDYYc5EFEULBPzYGtCsFx7qkwd/l9kfjvyr4FAqyZxWrGCFbgxYMDhFrbxJ5+vkwJ9ShbWxXTmCv8t30LI2Y7xIpYQHhOt/lOtDPPuZIeKuHO7qMVvS3rE7Np0mhcpsXOEAauxeBYAntkFDt7bSidYlrmL+VeWo72uZMGCvBZTvLM8jxFS3RFt89iF3H6I1/wCjgkaNlrYPZZ7EZF5qt932SfxWlceXF6mfAr9lmcgYQICfv5gtSXL7PPYg8XxNWQpF29/F3vP/50+yzOdGkvvS44743bNp5mn8VZmlacTWdzSItW9s0+i3Ps5xRxCA8Jtj72M+//8Dv+Nn+GfRbnIvYT+w7/0l/9811Pt8/iPP1cOvqT33bHoee9+gd+yT6L8wFlpBxZ+K1t694/P8M+i7025f/7dx9dXPvo//UR+yyeZFOe8x3492OX2WfxZE0BjJ5C3CPTYNfkGz75u//xkj/6i6fbZ3GBFPS5O85+42f/4j/+kn0WT7VVvOorP/Pv/3z7rz/DPosLbconv+uj3NCzPmKfxUU25ccfymZnZ2+6zD6LfTblCmnor37EPouLXYMj4vH2DALbZ3H2I9/KSP4pr7jkkW8rnkY76WkYidN5sH6Hy/NNNvssnmayP/Jt+aUU0VMIn0X8WaSfVdJPJ0FNrToiICIJ2hEpklGJUlQiEFl0ySkXdKHpyEGMCuQGnsww017zNENIlQFDa/KxASMMD5nBIAN6MoAmA1aqADEnohJku6t9JwFZFQAR5QwCZDqbM52tmSrpO0CeQRR7IFNnB1TRJPfENqmS6dxXGp3ztjwvRIK8DRQHBmK2v0SO27FxVuV37JcTTe/SWHwBu5lP54ILauGChhrypKeD0pxuTBoWO7mnPHaXkgQupR2ScMQk7KBIEyLYitTFlrZrG/ibSGhaIKuNkHNuAhe9oxL9Nhsd0aUYPBO9bqN30OkmmlawK1yh7XCzud25J2gymzsI+ZQBnQzBheLgt3gGCLGQ+cuQcE6+Hw/KBzSvfnmE6D+T4ffMQR2usi6jZ67l82Xlea9sXr5cdiDfbvupC0YTlN361LJrDLeJ5lcFClhrBsQPwHkBmfOYoZwY+90xxbISPB1Wwl9S+HwoUBRiW6yIaIV8lOHDbGV1gdCP4HJiO40lZiaReMjLcpbHc5HJBW8WvbFEjkyAF8UAa3NbWutTAZxYAOAXDOCpyUuZ5IrVuz5s6MpepU/9VVpa5frFii5fP4DegK/GccFRIKTLSi666glxSG0fY4R9w0qKJyvUE18B24RcOS6pIuqZSH8mPUPZyQwLZUaziJylBiIdW1LhR/ZXeB5u9qLV6dpTPJ0nh+6emjSDbYOxXdmneeFqimXEyFDk23l0+SE7pEScmHQVBdRNtE5R+4b5jGK5gh51zW1Pxiy9awsHa+LDJz9dnrX8bE4Uy8YohLYNIsGgQhiefIGHexstr1FPUUuGjWfgCsXO8YkO19nCmS+AAUJGSCSMC5SogkcFcVJMOyRSEdEmgVVRJKXT80jIQgLIbwOQtw1kF6Xu69rUQxxzc9aPkfazB7pSdqUwXVnQrmxDKw0z1yOAnwoBuW0xDMALnhSGzi+MvisBqbbTtbFAewrTxi5YwC7pCAvigiasFovU0Dc9uhSlFtggtZy07E1nb8ZORLcjsNVm96RXys0NMopOPhpe4PKP7rpkJ48dnvGumQfWtabqwEi1gbkWlP5NGEVwyQBTAM7eYSlZ0AK1JrhrLN0h6279uKd3+6IpPGlTJnNEeJJ5ZuZZ2dyJHBYWPNXiPxxoByLRDUW2G8oWj4EIqxShSGRTmsGjA8MYMC5UMxeprIXcttk2tCSWGvCHLHYucqHXDWpxDB4Hce9ZzbtKPWFZLKUsbEvtyeIM4Daje0c9eYzymUHi2tamGUqNnPiaot3nclEMB9LRtjnZHVoi3cjuLDq63U8Ip8HZb4voa/ZoMXfge9922epfnv+bJLfAZrnMzjrNrg9pjub4Tn/HlzF40JNhAWhG7n519By1U0rdIGCUMsoY6hzdAFDUx086ejElqNWue8ZwHXcmYepLBKOxKBZklGa/Y1X2gBSeCjkYrXDXMrC6Wr7Zbzs7k+mL/WDqNVTfHMMMeqp7RoG166NhEVqUdn2woxfj3NlxvWEn1i7zuHrvJKJ4PX1XwPocuhv+/Nhu+D63G9Yk2Q0/UNk/Pzz2xYPui4fdFw/JFwMpjmpmSmQfgLgOr1/yyFNfSrgRJVEPecRvgXl7EG9Vy3PBBpBVruS68ewXyI8VRCrCWbBWVtRFy1EGx8lDcFNOHNWqWqJ1uZQAkRNDd2Btjz9ewU/GGvyArw9vgZjzWDhvkkNCkguLPMS/d4verRcwkG+66NqEgKTZvGUTofdOPleFCtSSWlTmNg7H059rJFB55T+5tRnx36R/GPQN1yR0gN78jtEBOoR3HSBNkgE6jKAZ0rudobAjJsdxLJT4iA1iadR09drgQU0lhA/d6cJHENYG3I8sEgzuklhnFvYjN7I9tcpXm5XwPRqG8PHzrt33IVaDd7vgvRJ8wETcA7ZPe4yuyQzUqySHPSNcxOnwLfoCfChnEWyiq/G+i4NXUOCGqgVt6JdRYOxDXkeBw03FV095EbV5EzskLepMjV84kGGgyCBIgJFGFJd1LbQD1Uze1RJ8AMHvrNoSzPIGUvTORibBN3ugCRJ8ELGJKA7qAOpWhBqahrveqmr7+6pqywdfeYLHVVyszkZ/Fe/7y7mIiIabi3Ch7/qbbMhcAgNTnYsJ8gvA8jqo07WiMRqPGEurCySFqTMuLxLyz/JrH8TEdL4vMSMjI15vulmZ8TjJ7JQ5iTrePDKrDvkqkG7KYEBFFf0eBQo2Ch41jdV6Aa6CCQDYm/2BkM6Wtr9dTtYZtLuOdrdUQ0ThkmK4hSNXIpNsRWTcRQ90SYR3t/i6wDXXSPTEZ0Bw8Ku9s/TCLI7f/Go4lZFBu7OI8dxXNI4WndHVUBKIDZoP3VoFNIB1kgwXRjK8JsP19XWseUM5FpNbJthK+SRcE2EguS70VOmSubfhO+1mY29EgX7FhBX3VQ9XabJP6EUmATJ+euvku+uhMvc27ywdTtc2J67g70UuPo/avNPdOl0fVm5Cr/P1WS+YVBPSo46equKtuGm8ksuVpq7e5snyGI8erBbp5amQQiEUXQmtYLbpWbYIb6FCXYMKNRhJPeP6FLpYNUr+F34oFHv0MDs5wS2FBuyDcbl49rDvwrlqgqXwcn7El9QuQyM5omo0VNXD0+q1o6C8dhSPWwiIrYWAWCzOUwpsTEV4OfXaUSAnVSO2QoONoYgtAKcL+JEMLmPo7ANxwZFvosZYEgV7ArB3NXOGzHoyvBdB0a4/pyxhD0JqCW1FP2ihbo7LGBMB4k+j17IldceQ6VsSAfMs2yS3xoUCZ7BajIaE2Z+JOWNZeWgq6GHaE0LzBtXRQrvw8Ru3/4hcbNALixq42waOcQBL29v4iQXqDnnyJ74+79P04F48q4vdcVvCAzbwkPn0MD691V+16xfVtE3WshrF2Z8YQAwOvcZ37vJ424wIaTbDdrBO2u885fc9lfcWv69U3tv8nlXeZ/g9dO/CSUdWsVTPFgaHKJ9zJ6JIZrwFU8Yp8OiA/MU8NeCVtfDFBh81KcVp8v9E67VP+l1AJkMLb+0yD5Bbzj/xOJh39QwjoBmlvG08FpQOL0rRsuHvUVN26T4tYddOi/gtEmxTt8k2e0Eilo3osk99u12FhQ/Jt0xILaMh9gis9GMBDxaz4LFIS3gs0TY8tlEPIpgedUEHaZ7m8MeqybPQ5PQoUN/vymmgLO3PgvYnkCYHRiOHW6n8A4ilmJWJr+mrdaMAU1hTyKWQXWYW8FiwRlYWMb8XjSDmkJqr5MG7Gt6B5jBU+RzpYFl5Xae8ytKZuMqCTVmZPDMtuV0mt6clt8rk1rTktExOJ5KpWYYVd7L/odZ86zzhnRLRhz05Lg1Hjks9d1yqmm/KFgTkbYqgwyh/R5B4AKAje0VscQ21DHAJKlCLJOHmUZOny3Zj6tWT19K3N0aK6vbsldcr51HZs8etvrCh2SfRmfX0BjG5IM3BRx6jjSdo4+k5bbUf47TdRiQVCu4OegNTQNWWW3kjSxaA9CWeN3UBlbvFIaNPRt6LXZvEHLpTfNdVUtfLnr3KCUdy/BH5ukj+4fgieb0XTtedw3jooStTSg4gTL4+cca+RvwjcF0rAqtboIfvPONCfc/ulfpidN7AO/1y0+uXSpEXqL75Pk7C5HueWp5eKSAZzeuidCtXdGFadPDfyVdDfIe+Al35PAWqmNt+egmwaKvb2xa8KhcdbOeyg/msOqiIqMPFYcK1qXMQutnzFIIOQC771dqVIn8OVW99EYz2kiqv97ha6onQfBvFugldpkgr7IvCnrt3WKwcLDKuIOPh2U7+GmrE0YX0odjJXcTkUi2HOrGYbXUNsiC8MN3EC8g76FosHHL2POj87aTelcul4CiTZyYkkFsaW5OCO6hDy7SCBvKzj2f2R4aOM0zUvV6dtq1JS5GM0uZoOyWolzoQ+nLbPcrO92pI5/0AGOj2INR6fa3WQ7UtQ7AAbBQ9WxZNk0XPb130Da5oRy1RrgC/TWBqZVAwJJnChGMAZP+g6p4sqFUmT8CYCUDjPJMKl0e7sIzHMmWoJzPepeo6GhnGVkFXV12QBI1KqAFUaVCTv8mb5rgZGjn6ta9DOoq1/qPD2mwCa9vA2ojawNasgq3trzG2+v+62PrHjw1b9/hTsTV8/NiqRU9ia/j1iK3hibAVpPcKz3uVE8GDJntuNhYRag4JD3s5LTBa5eh26OTzU0sCpKaWFJ6wpN8KPH/ytrAC9G2B7Hr17sCtQXXbqxkOVzO8eSQDtChh3UlN6bastQnEvn9q7F1TY2+txP6mu+N1i1ep+LA32bJXVNJvmExeqyRfN5l8dSX52snk5zh3Dy5yT+Wbcya/Wakk02Ryq5KcTSbXKsnhKJidSJsvcgdWUc5tTbI/VX9AVHtB2zN8hR5lRE6hVg4tSuMZrKrrrEMHxjo0f6RapsIqfaAZ4UQIzJq5EYnRdgbjQnF6Xfp6VQl09Xa8eqIa5g2oLDvj11Rva0reqEQ3yfF9BMH3D33q9AfS82afweYI+cBln9E9bVTte4C4w+BL0c7ut4YosBPFdGlUjcTNVL3DqUnJESNx+UxFsqAnIZzN6UwXmQ5NR2b7ZvZjh2RzqrfZYOYOtSaK4dhPG783Pw9Y2jtvs1KEqE/MVbotTj59OUGc1wIZiCJpE9nsvjylWA0cwPMT1wXLypwb2wea1Xr+QhjrvGmX03mQpHlTrS4GyIeIpHLyUxqCPQ43ypJlsGldA9WBpLGUoZ5+arBWJAbwREq7X7jtFfshhkbaO6QW2eFItQcdquvX0P34S6RgY4Wt8jp/1GGN/epYpdSsjFWT+H1krEzw2KXrGDdpypgwB+t1XVnfBAh5ZR+rQD+fr0p55NQxGazDxAKwWM7iA6q7fdHximROR9z6Ejj0vf9f/X3P3BjyGSH2FZTks7jKqwM0qOez5vhrYC0Uw7lNXXHzcprfFFlxXaaL1ZVuOiGgYCCKFbhiVjbETvbZgTSW5rMHdA3Xw78WfrICVSGUyA0BqvMqoBusvJ4iK2ad9LimGeIBaCzMNBos4nL/CuWqTnSCB2dFxhZWlxow4vKyK5TA6VCslx9HOqMFFKPdi/WWcJy9Rt8DJ9VEd321Tl2AMgRjQzoU/VBYaPtOXC/R84ETDlOejhVBMy6MuT0yhkHFiyMsnzYnBLMH9jOeugYDKZswk4qmAT7OwOEM40d605kt32gzJyy1a4kVl+iVUWnJpajnCfb3bJ5u//VWjFchkAoP6YE7TXBAalZ3+qne52wyPHCOiy3yc9uQsh0KVuUKCyryJdimSNV5mjj1jokfHRUzQNc2Q9CT4Kz5BpITLQnBeYHcI13VNskX0CDTJKFsCF0FpgNT1tOaFplnxhnBwwHcPlNPOGa9QpBmXxAasWA6hTK2iSnzK7j9CzC9kl1h457PcSkUlJ6HNOW7ZrQK1lTtUYf4sVwuiObuOdfo4++KvnUtq300spVfeu1YXszZPgf6lQ9mKTMZe/CGFx5TedmyvOyXcA/A7dEyHsvkQz7GLS0d6zL7S9tQHpblphyCILQCfWEojTWVYBn45NvVWPIOPFShhhje9Sny3Jy1KO4OqE4IrNvAERs4ZAMP+iZwnw0ct4FjPq0QAYzFar6L69rNI7pdbojhZeCLdtnu/DRq5rtpF502qItS0g4OAZFU6+d02kkmeMbAg94NPlPM4YQCokYIJRm2qhCW0xlOCUiQDfkwrSRfTqdXkntQsGHgYqkEmJmioiVwQdEsm9PcqjlqbxoOi+dFX6w4eXvmTtYWtIMLbWpbGErIvv25Zpeym7bzdgR6lmXrdp+8dV87YKWK7sQjvNvgvxnsptaa97RU/s7L+9yWXRZS1JMq5qUpTjVrN7+bVs6NJfVR/2lcdp/aPBlaBlCnAVA0aF3BYcI2haiJqAWmVpjjm7ghWLkZdzuTmT3w4Az4dfA4jeoMs00vP1MDfn5WsL9ENIUJnaUgQvBMDRqo0h7q0pKBaAVcTWyYm0YzZzCjpQm0msVyddAUcG7gRivmyXuGwMrViJcirw6c5judcs25VStoWckbhk6rEVQo68K3QnZOk1gXM15OnwMA32nyPI2W5LkkMnQlUMCNBQ4GhlbB4hQ3PgDttUa2OO5tHAfv2YFuB0G3TFqoHJ9oMjkqnprVqJHqBjM/Wz/Mz+FsWJ+KcznX9BUKHGWe0TnlQnUenU38ON8tVCtuodq2xUIFZMJCRX5OsljNnmCxapCnJLAzuVjNIA2bCbNYzVa6OVMuVrNEZrGacYsV0ezzkKajeR5RuVidP75YZZTKAkT4O/Fi5fJOW6y20Ypm1NUpz8tFiw8EGZOAc7p65S5icgkjUDRu/8gSNjO5hC2OLGEXjC5he3QJW5ElrPiaLmGLVAC4C/+HL2HfWMIW3BK28K+yhBW6hBVYwgpZwjD5sYTNbBZ7ae/EEnYedQC/8/GoLGHfWMIc/XFr2UTSqS9qhEWNyAg7ZjkYICjkOm/qBviE+6atlyS3Fs3oWtShiGRlinVl+t9+C3WabqH4sUzn4QGE5cdpT8SGajcHdk/dUC3LhYOc+naN6iHCXrU5TdcwyhExuUb18QAe8OO0b2y6vhYr1jdWrG9sus7DYzedj8euf5Pr135UIwsUGmVI1m7zqtWblxKD9MWRsl1l7kpOR9i07mmr2248QQPkuevEWzgEE6NycjQKPeOPePzczzkJTAYShk+t0m5zjV9U9S735R2GbxI9eQ1AG9VyNUKwdy8HVGqHPxDD0olRPw4JyXw08WeVsooApRHJo2fsF7LtDBVu2jM01X4RzV5VmSvio0V9XPUX1qX99XXY86nzRRhfjqBQllcqA+cxrwWQ9Hr894wy2ubs57G7i+O3PJcVVyucChHs3oxmlKorFneOcv2IjEd9SKI7xPB8gXGpXQI7AJD/fATIiKNCuiWabmkVIgo7A5HglCFSO2WI1L42EHHnlpPASXdDtPBVcYJ4L7IU4jYo4ciHvmCtXqffyqrV7v6Z4J0a4Ms9g616PQwH/YFVRrd6gXosXj0IvykIfLjortgcDbWBepAXqabXOapJvYeiwVd3QkGt9XI9pEBT1DmRx5ZPArg8dxxlDDvuHjwJlWxTONijPoo+J+ezdRml+jV95CVPlN+sjksIbVV4Gvzga5E1UcOrCVqlVvcDFJdJcQcH68GLKMzuxvGiNBozjx9qpVWqVdP1Puf6kLHUEwkWqdKqjz4ATIVHGgYkY700iMMafi3q1xSMEgGh2RzgWPOBHmrpJ2WteqCvbcmkqdmHUTO6Vtp4jtMfDUMdAs+qMh8Pyrs9UFN0AI3IWZOaCNSy31C3FINDhVMPrkM9uGDtYO6JWICN3Km3MbllbuNxNllwhKIN9jht6ADa0HwbZgsFarlUg8CtNnAXB3AMdgMF0I7GRRu5FGae92hycAzPqnb0pi3guA3cZz55EM9DTjsaQ1JqrttpdjVO9AkZQzXMXYemIrpC4neBcJGOfCXmy/y2br2aBZDKoNBg0Clv2GQc+jgH5DNudVAZB9AhzASeB0XNWYkCrO4JVrXOUHEcJJsiEDEMX9UDMLI5fVan5xowAjh3O+vdCP7Bsht3OmdRhwKnc+A5nQPP6hxUVQsS8FfqXpJS6187BT1IRV9H19lG1W2tGPuMZR2PcVqs1hB9tQYIdXTj4070etsMZK7bGVOewY6CWtIW9StTpGo0KS0FqK1VyaDJNhYdmVHztG1JzhOcJT7oy/6xw8H7NJihcTUoMwtRmNOtyrw0M+8q4VpQwCxSLLMRD3Gc3kJIBjSRUAt0Qe3Z83uquyMq90foC7/PEf+VJmxS3F9OrQkbdVM/x4yZKqKb6+LxlOmybKwB4Fmbkt7PV4i3XlDXQpkJLNb0eKCESV5Ua2DUtBZr6lQvhQPcqDEuMqUl/tKq/y6YGztost4q56rwzPLt0yzW7KDttAJF+Z20c4rFGppusSaHBYFiisWaXUjYOcVizW5jOWTnFIs1p7m0CYs1p2tacQZ2JSh60mLNHvu5GMPAQ4KTFmvOROyExZqzTmSx5uwtLdacs6XFmnO3tFhznrNdcj5xj1yDtcmTFmv2TrdY86QtLdY8eUuLNU/Z0mLNBVtarHmqa/AZVEyxWHMhW1BZhvmVi9iyyk7q006MREEXTrdYsw/Z1eDKTu7++YTPzuDPztDPKukFKWqias5KgJSg3Qrt0kiDUpx4Whmy6LKdtnOIM1nkUPzBQ/47k//cwJMZZjKDSmYIqTJgaM12V4j+t3eKeRsygCYDVqoAkTtEJcio2vcVAVkVAGdwdTsImS7kTBdqpkr6siwFXTFCSF1mjcct1hiamjeVoOYw21cXt/ddSkDoU9omFmvSUcs0NU3v0lh8HXvti6FEQ1leo466M6aLRTosNOY+v+jDHk3B2CyBnbQsCQ+ahGU6QxPOSA1vqzVtk2boFrNvGqdvF5IvJLugyZIvNEVq4Ax32y0Vjs+WSoxq5rIP4lvEUQUtV6J6iDoDuFtG7UbUMhVjIrhtEL5sozmr79s25m9S4VdVZYvFlJeUK8XTkHBOvogHif2RS7k3l8LoTUZPo0vXcl+qyxekIfmSNDHfJj3IO1hnsBg4Ize6Ci2K6RjtX96lNvHjYmuZIodntZpKCSB2lcXjYhgjhQgrhmNqwJbna8cJskbWFP0oY8hto7HEzCQSdaksZ2k8F5lce7mIhbFEjsQtdLlUU6NZaW2T1DkawJsY8FIPRm7qisnSl3lYmhAjN9kqV06ptXBTM8KpZtXCzU5j4aZGHBIMbmIQm8ZjjLFw04OFGzx8jG+KqEuRfildosxbizxjaKGhV5ySIpWz3lLBa3CoZOMazmqqnX/UUK/4ymgNfh92UzXFGE6NbcrrnAlU/lbNnwKOVjH1bwIfmlROrFG36syqOQbDF+omX02k69WjT4GVScuIlsQeHLReVCS6EWtQQg3mef7WXbBGSmuNk8Aewew0XBE1we55EK17jPDwZyX3q7/3IO5DOU60pcYvwQn6qpPpUSLNK4TJXi+vL31kHdy/USnN/k5vZKdURyVbf+CPfECto+KcfPBq3I5riCJi9i6BXLXxaHoqElMZ/bwBTT1RzMzTqjtxL/dlzvgOs0JKuCnGnAxAa+oKbAou3FqDgQ2QoAaQqO4kAN5m0aoYD7bhu9nBc2s4pPC2odw93qw4fg5YTPBfWHUdw4bN0N2Y/KoHrxb5dX/BPxTKBbLIWGThBLEEzg+0zdqHyWVLPKzeuadatiG71BtDa3ZCeXL+OvsX8R0YcOi1Yg/Zq4giWuZCHdhUNEmHKhoCIgjFw6NSrbg65+R4uO6aYfjUqmjirZGXuItpbr+DLeV3buW0QG9mbzwcAAy8//t2juDH8/VxlRVZlMrZgQX6fux7cJsZh0Kq2glLLviuzCIFqwLtFX2UHZfb18vgPUKkBPvkviYELQ2pJ2/q7kJMCmerunoWbjMpsqqmuWYP5XCuJQ/UUwlKNOdfCZIxyi2q25Mjbkybm9zmlSVRkWNCnAxVTD0Hg82AUim2aJInB2E1dFMOwjySuOc/D31uiF5r9pegC3pZ0mNAp5Tk3F8FWVMJMHaPdv/jZKfSvexPMEgSdCla8BerKrpZ0ZQkVdJFTnWbyaDAzkwjqCmauoA3/AqpiwaKeJHEHdYXF001WdTMvow2mwbjWzRZi9BzzoRsNbUpusAVFBEIVUYYtLq8tfjm0IdVqEl7UIS6WzDbpWan6hgn42uSwyG8tYVmJBoAv+yh/14dVnotH7BvlK4Oq8k8Qo0RA9UNZ6C6MWmg2qVLKgYLDZAlyv6nLUoEctVmqKH9kDgeqB+muBbtGlXJrBPE4yjf6WBL8peQDNX27B8QWoZMIvsJNB/mqY/VgHsRRD/7tjKOFeyhiPDsmWeC6/kyExqrcouWn9mDUjo1gIeNwT4RW12AbFyh5sHojtre5tyvQO4bdPnm2e8rwiWu19UuAwD6adUEtjPa5NfSfzmnVVfJ3Q11RgwgR3NUrTnI5Tbza33Raw70UzgRZNtHcmU+VpmJjgnFQLu8Ub0CUsetEDOKLZXyTFOD9oyuuPu0jd7xh3Kc3waKsVsuEaO9Vs/xZ9CyWzTcEUu4nZcdzDPEvsbXI3uEb9bwnObWQ3tbCimT2cYBPjOqcoGtkS+hRaZN6lTDErE6Z26J/ceix/yyoWGQMcVMw5aRxu1sG+K1ZHqFMpYN7fJoiRZBuzTOHuLzZcDnIY0rwTZEqljNYzc34F1QaOMi/tzhu+mhdlrP60dyYxlRcuA+maNZkzEWu5tcQNGX7Ye+vkZfnSmBGCCOaRFcLLdUj+RlTImWUaxFAURVjuSFHPUUPnIk7+mRvFc9kg+myZFwJP9a8CIIrZehI2XoUBl68BYbuq8MHS9DPOT2aD5fFcuSu6pH87sGvqxTu3Cmm++iwpw2n2ZPm+vutLnujuaNIy6DRlR3xhBPs5uH/shxs+Ie1Z3Qqz9y3hyrycFMtgVqchBtweF8vWxQfasG4b6RB2zB3gXyypM3aP6kbVGzj3VtC8MJ2cvD+V16OF9wgm3drpO37msJrtRMAcpxrGpmhRnyuqk5j7VktXJ7GrbfFl4qUwT8Rs7hd/G7aer8WNJpaMNuLv006uQJzRhw7S6P6Ov2iB5bQEx7rPbLm5DOThzRZ9QDFAMcwt/s52dq6BY9jxdcczDRA3l0Cd2tm1N5B1zaQwu0zQB2ROUhY3i6Y3lTqBRSJCOjp+BzQzjaAlD9MxRgrla8FZZouPZp7tOpr/m3ao4YsTPIprUJamiVrnglUlqyi3SkarxUe+q+TZ4w0J5YCpbykKjBTiVmHhSlschUFKU9UZT2RFHaG1OUToVXHoqNLUfm22a9anKyUZT2rKI0CldFaYW6rmFuPeuQB1XpJVFP6/BoqKo0P84fXcfwWKksYfNaoFnOgF4jy9nsCZazpl3OssnlrGeWs2apKe362SuXs9lyOetVlzOnKV2n87QKsUVyPvEjqaxrS9Sevq5Jn92S5jJiSWPkoNMquVdoTjPaBS3vm8WNP63qHibUr0S4tS3BI7FL3OzIEtebXOKWR5a4C0aXuD26xK2cdIl78DXl0lWGjpehYxo6paVw+Wu4xHE7To1mc0O+scR9DcGVumUNS5xb3bTSPNZC/zVWt1ld3XpbqUyLSuf5eOwulzZd5F7hljhtvlviHPXXJU77+RiWuJunLXFu9Fzlk6sbKpy+uqFpj3t1M1VO0qndbvWbmj5S/oR22eh653SojYFqIeTuEvEJNl26Wk3fcbllKtNl6jwKdLX6P2UHBjXqWPWnE6M//cTsyHZzYPfUHdlpdgGj2Ogbjm3NKHHxipDT1jFVov7Gju0bO7Zv7Ni+pju28/CANnUPnfjG/k31q1EbBgLLkKsWbxaHqhrV4/s6l3H3ZMaJvR5q30K7+oT7PgS35sxvLklUGTpehhi4WJ5kt1h0B8nzhDLNj11FChhnEwFFHR5DHDNigJrwQz0fxHi04VtAPR/gsK8CWg6oCRjEUhczGqqa2OXI1J6nLqZ2QPOg7FpjWaJxeqCGTKwZma7pPaUXoxjTLJ4PyVgrIdLlFkhp1xQJVEbbiNAiXSu1D7mepsj5AUXUBT/A77M3OY8XVjk3TX/N8/wb1ARQ9o+3qKqob422qPZHMKr94YuXdeirQth79z/ddLgmmhz/hK/Jc+eYUKVXT74Cn1CMf23mkfrHqX7rZrUzEaLOU/NYKwvQClG/G04pndhvh1dVPnauDzzre2ZAg8/ffEis6//QTSL31/jsq3oKUPFZ/1Z4Npjwo2CZIQVuYB1L4qg7YmSwSQlpXHiliYv4dW0Ab+Y43rmO31aNN0n1Wl91JtkS5e5PvfuT7+YTbl8MX3ovUwfbxOewg08ihSP58ckam6pUB4zZH4qFYvFaE5xqnaGpMxG1/YriJSuFeoOXvYgLUH8F8l1EQen5UqpR77DJReYrqI2LhqQz6elJ2XiE8kBadi9auqwnopGocyINdVlNAudmopNmn1Avlq/z2LJpcMOEeVFfTohFY0D9bjN2VfTGVWWcYqxjOFWzLvijbAguDzwfzpQzqPYj0BseRcecAnk64pk/SJ/sea8m70x17i8WegRu0nmf3yy0vNJRa/p6z3qa98wxzVXGJjFTCSAxExUPswMrB8MSifEmRRuifi6Ko1YRX7opJ4OB9EOnRHRNEcDCa0hwhb4KXOoXobFT6Ov33I30F0p/7kYzXbX4A/MORIF5O+UxI0ktYi43An4Y4gJXN54OHiaeMammDx4ulI0uhVKBlhTrkTXp5ROJBp6EpvqUInF9E8pXAnJXKrJwwekt3oiZPeevwviNDI0RWJ1+1orhOdIAvIhCrzxCHKQBQRM8uK2KqpgXLSyRddaaAWoMvJcCaoHTsgjTD8UhHJtCi9oRmtgkx9CL2cNUWL3IF2K3GzfR3vu75s4FYsDob6H+TsaQ916qo6hMDYXtxkNUyMmqSERirxZGsqkBzQxotEQD1iG/+nqoUFujcRQiV8QQRcj4eY3ceTW+Y4qnKt9acl3L3o0fAuLYSrIfA0wkOtcsudy4kNsQKxIiDvVQAmOSMK41e45KdVQpd2j1zJ6KFMOEXgAdnI60bn6whO2hRvbjqLOICJmLJkXQfMO20bQixiNNkUxchdST/QS+WS6X2YboH7k+FRHqKHdhFGnHpnXFGNZqIUZN+Ze5sjJXorAG6llFC0zMenaXFFtH9XXJIQu9GRmNSuSqSPkJ5ym/CvGVzgULMZ/RuVDQY54gqq465c/TgQNZAMSpgfYATMZ5Pi7dNAAOOMCKbKHcBKkdQZmYGH+5FJbhLhkeLVjZxpWpTBN6mtBzCT0FNPpTmbji1IbbiSkcuzX1OUwGlSL49oqBkkoJ61G5K4GjcM9KFg+Lnr4jqj8bRlgPcGIeWcJwJC4pg7lP5F9ZlamEGjvh+xgMC7B6AIjjLbkNUz+6LWe9uVfJqMJuoL3GYJgW1Ukq5G6Qs5zNyQ9+2SQPh4Xz6U7Jgf/w9w/98s4X/5h4pCxfrulvFBFihs6hxZ3rHDd0Ox1JPnrn0LGkisBwoxuvwtjcO7/IdWY3q+Cdzzli0dUgv+oJo3fuAVaVb5TWvZ+/f8MoX4XO1SEXCEWwhjoOw9KgHrwERJZ3BkPaprasPRBSSWfXXeu4EFkt0sGxL3q4O9ACIrYUox3wq+WJUfoEHaUEF1zGSmIigVZgKdpAPQ1OAELrXYTBHmQSNy7xmHG8gLFCERALMdv3BNaoStkLbxvicfVRwUdlfCDcsL7EB1gf4Ij71avgCeDaJRdsXc/DcmjUX0surAV5UFLj+4NeaTXdt+poAWRmgVpsT3++spodq41YjXW3Z9q1UtHTJ0/UoFTPU06nBm+DD3zEWy1Pj0mTJv2Yc48vC2hZZvn9BauaHanGVb4v0aoTik6Wxkq9iqrKJ7xAVfmmLcW+8uvQlgyU2bMLLENG2vCC3/7tAQXZW4WuhxSWkdf2CwdScsFr+yxTjLIj+EDW+GjwkVueDs3QkPxrrSu+iKPjl69i0Mq8NqcnOQ1tCtE2w6S6hT19oB7UhZJQbbOAPmjV5qUVf2JEuZF7o++7/7yvnn32NdXLUa7pQaXpQlzcXU7wzyGPaqWfFGzgXuoQN05tWeSC1/bZAY9rC8UbCuEitlmODdXPINhbLufAU+Tf3+MSKQVOI5TrufM2qg+lGi3te5DjTkedQlhrpISx1xQ5dO2s85XTKAX0AQhVweSOcIQ6GSC4sq8WlfOyKwTFK7wtIPrEQxLyLoZk4iCZjEAyrUCybiFZn4AkkLd+EkgmTPZHINlgWDL8QAunwC9x8APcyMtBznhX1yQLPmiQpZzgpbqJhDI0SNEoVHG3grcAVGOaZ+D6DbhC81QgW/h9UF5+54BA0LtSJz64XeEaNj3fc8w7VaiXunfyNkGWKlA1IojQkbeSOt33ESx5me5BkvKiZ0tCK3pJGOT1+4Ug+RSU20hHC33yqzTQd33zK8P09oeD9MYt9j/eAAbq+cHes4qwD38Zg+sGjAf96wtPW+PbLDdxFs9l8frXo+HiWfD9YqxWt0AQJ/wgGl2lkT8EyPnTIKeOmhSACgwHgm556TWTwrO3GeociB649vG+13JzKSxfru0blAkdzITgb4JRqgzOncP0vJoRXP2ArCnYUUifyD/Tl825/0x9DDBI6YUMRXyQ/aNgqZ8dwmelY1f0wjhMRL9WoayJq/L/0fN1A///MaGTQJMxS8UEL0MWYFgnRQTr9BeQTJlNYCCtUQkIWtFYlbWH5Ro3oeZa2qkN/hQyqezwa+R9jgvLPi5ATrIfFdD/ie9Fk7Io6cYtKMQwL9IyFUxJV0a0fQOn7RtMavu6dEnFpDnl4tGrzmr2WmS1e/9a9jp9hbJ4IBuNgWrzB7IlxX4vwn6PwFIJ3Qoks4oHoOOrzjH1Sj3iAlHDxSPEjkb8WAGUHr6DhwG5Gc/N+jE0iyJ1YobsecBP3Z84/VvfYfb/g8FFE6QBvvYhkDrJl3n/eumM6Y4nKOZehbvBdqu6jQEuCOKl6cVc/KBn0MEffAkqzvjeV2GAj1nxBsVCJ/YIIPPYj/0S3E9iKA4jC8ibdloGQjL7ympZHENKIo1I0hcatCX0Bg98JNAMFZ5ghMBSSx8QwfEIM7ikibJDF9gqS4ds0rbRetJv5pYOMtNHbpKT95maUECo9UM0iPHW6RZUdn5h+qdB2LgxFlbMyVe80n4BmGkpSmHLb4c+t8/UaloVIIpRUN1YSga91xLK5Wzl1iFnY0+NX8I2Tc61dEMH1ye51RJvSKazgwdvZsKYN4mDD70BQSNgb1Edj7YIAYM95FUvcBDk/cMcLlGatw/zTtUkvYe7PHnIz8xFpy6oe64OZZtFewh+1aMZQqiG0oaoEXsBjx/EHkduMhJ34hZ5CGTUPkoBf7xxMdqBT2YRvydPNUOPZo9Se6Nos7QKoygXevhFtz1wcqG7tpCaFe6iKT5uimzwdEwkdxvJgyb8Z2oS6cumzIodzKbMcxYqaukC/7gpUMv+WGbg9mmxg54hf0/1vAkHG+rcouV8W7xF6Y2b1efyV3ZXJ6it0mEyNxMwi5nLMlWkrRq5Ct/nh+L+S5Y7t0fLmXqrl7Vn3vG5m47d8/ovv/0rPPSlf07d4SnPoQJxFanbnbM5+AYeq8RV736Jo1eq8xM4+RUjOlgHVj5cvkRH8f5F877hrqsVevFNr9hBIuPORXRMQg5gLOvyhD8BuiL3rUMyX0YI1B+t5EGtti0oizbGSlAJB5KxKiCDTu8JQpHHOKAd991ahV1ABZlCI5b3BZPF7opAwasCICTPdVlvfKmRFHPkQ2P8bwR6pSyYUtUfUl5DIgebcqom98xcxQU6SCFfZ7ZFb2rRsbCL1WOpMmDOjA4WDDKR9BTB0SLcML4Vw+FwwzCN3E3yIHuvaW9VQq1fa38hNhOv4fUp1XhOjlQkR4tgQ27zRBRUasDaiopZYALJGU5+x4B0Ug7L53FyLFbELNVPAf39x43+oaJ/IuiPkDhp1Vmg45ono7MhKGdDglcm3p0S+2tAe4orh4NFQxBPjAw3T4T59tS2rpivguExzG9MYr4WbTAflXCgMQ3z9xqeUi+1eqtgqLDSe3xNp49o7hU2bUE/e5/Ql/t9L6hQtNDxc+A3sh+exnSpeDYa4ekix9NFkzydS0eq8nSPpgrcp+ysSvYfcbwdrCjd6ni7iHzH20W4DPxr+NqxdZHmC0q2DtpewGLD1kXK1kWoX1mPKWydz636LSk3MIcYYlCKn+SPsnWhWwB+3A9hog1nNY8LjYG1gsgIyO7wqMHnE+NyPB2XgVg4wQarpdQ1nE641TBNfEroG25BuMOScIdA33Aa+t7n+eHjXunkCG4cApxfheTa0xgs+7SeolYQrlB7qNd4x3oYTfZQizQ9ROEciKb18J2eF1Y4/FAxObK7CjWwoA6cIUgL0XXfbFUQx3s8vfXpYy7HCEVC7IPsturOAB8YLhSvQGewuXLFvLozUDZYT2LcPuEAeOjjNctED47YU8NQNwrwf4kWaKOzt6tUwXC2gPXEluH2fwtbhk9GQVuYNbdhCBxBxXl5qJX7Os7SY5y3GafOmMuD7qqgsYmJOYbcpeMaPPqbpDonnSNJu6luDixNEgQp+7ScwY41E9kQOQh52evltcmvmXtN+TXUiqBJ5w92Ev9d2ddkYehxKqpej3/eeW/T00ax9TFTkvwIOWfU1r5+hpxyaNJhfmALFRvMRpwVcZ4ymZD56EgenYSZ2tLyKDAu3XGyCAHPOXC/7b7Pjlq9AzVMdlRnCT6BryW4DOYwnEF6UpCjX5YDkCppDhnMhH7IUxtZDlpiIgPlzKGH+Ry4LLeNygK5rE0erHkg1yx5PPxrNLM6iBkmHuwv7Lt+lbKyo+s0p/ogY3YNsgqTicWoqhvSRpY2zSBqxqh3AzyADOBiLPcFlBp5oItpqlAsK2MmNkqGBLiN0o5psSAaunHZO32nhGUcm6XszvFN0p1WM4XNgylAPczES6se8jT5nEry3slkqiTvnkzuVpJ7k8lJJblVTU45ttK/T3pedINRsKnw49DY8ZW/rDo1rp7RudhYPSsL3rtxNToQtRIXhC0HlY+H/BD9gMpeYzg8SvWNIlzPY2FHKJjIgE8lVx5TBO7crJ0xjjbz2PlNTtP3e154gzowy0ConHxZj6vKPu0fnbgGEpzDHLKAjvJjiLNIfnGfFRHaU9mBSXbNPOSthRqxCSms5OBmcy+QJtSTuOm3m4gEovQvezGM4KpdjwgccA3WU1nZ7upRn4vod8CPB2qrI2MCxWb3qofsMJwAGW+RVCyyJBvDQs63RPGpIWfNUo84xs6bYzYo61RfFzFOSmHeYoC3uegWtZQZa28a6zwUr25ywQlpgSJfQVNb1MY+qk2p+noFI/dsjm3yoLWeJQP2n3WRrBGIwIC1niz6odNO1SQUzatINpyaBH03oXGq+K/GEqDsoUWlKGvgpX/jn7ryIeqYUD4sQo51yodc20nUDVGBb9UN/e+tqBt+lf95HPkQP+tO3fBdr3Xqhq6WR6VgePCJVy1892unqRYC2Nl7XjupWvheFcH/t6rbcqc3+sz3/tj/eORtX77vK0/DvPSNUuDmsODVqedkDRJSK5COfPBVGJaWyZwX2IbZP+OQHcuZO9HwnliNmHf6XjTZD+CpRU4SWBQBUK9tCgytFwLZzmlO1WYAKpkNPMDJmSVktLJCikWUTyEcpmc/icjBXsPPcTdZUTwTnTZvcI9dsDzlZNWLKlY/D8c04UV+t9rGQKYDgGs7HWinMW+qovPqOQT5pYzPNzI+t4xUgJ6+ACDfwuSPzi/hrUIgkbEv6mXv0y6Dw3YohbHHi1pq8SoHPboSk7Y+e39ls22HF9Amz4of+YOBkhTLpVvNLF+19caOXHzYH/FJWRBTKQ6Sfu2mykHSX+5KYtZV9MVTYvJKJ5grIixJg0OLzkMi2jdgJ5DHjrJ9cREWDGRb8n5555hLTJLI3z+EYKpfHB/74mPui+Pui48jCFWx9ZZuZQ/FchGtAbFkJMEmhPNV+X5QmzZMRcpIhcVKeMCWuQJeR/5D3QHaCzJ+yFtFJd3V7ANIx0KnaMtkPdjMZ4w0tIWFQaQLP4fEafwxzawP3dJgJdtqr1U2ibhqDp62I0iBXBnTNI6rfTNfs6E2No+8SM1y9+bUDa22jNrK5RddUc1EYdoqvTuA3a1fWiG/RjQnUdjlXF9HSOaAA0JkE6wiUfX4AUaXBjISNJt9RSGAQ957EIWApBUtNa+bfQCdp7ZuKlplOmWrIgTQ7Tv5G+WRvg0w9MBdD/XsANkpAgQiahuNr6riPwrWAZpDFul3i0JTR0u5fiCmh2QFeFVtqk7dC/1DczSHFHH8MmdZZ71MMciMwW+gUllbvoCTmk0v9xXwCmWuBesNRgPlULRa4tp++zTjEenVpb/XyzYRrrqgkcbC9SyFZogXMV9HVgDHuv2H/d/TFz/HgS11Fvjb4aK433c+0hVj/Hc+Unj5km3IscvskyK0oOhxG/Jtg5p2nmcSd1u83cxvaSB4fopB3j764Rgvf+AJL9ZCQdSyJoEDCszlsW00B55s7eDPMw480sW1ny96XMrfeNTn/P71fVwDUtj4GDq/wo75BhEGggrU5eK5tlDmQpcSuA3mePQn410cD8KL3v7Mq/6w/WeX2Sctca+LJepRb9J68FTbwbDMuG3ScjCi+6Xd4I/Yp95ion5pNfjD9ulSjK3gD9qnphRokkCiZRl2+0SGCcCjML02hYf+V1oL/rB94tMJw8L86VTrwVvZDt7KcvBWdoOd/dgVAHqikeNWg6faDN7KYvBW9oK3sha8la1g10jGySmWgntsuTaF2dvtbNF2By3TDli03Ua9aZaCXXbJ3KcVwmd9/qxvPnPpfUEpuU15qKWgQdmcG1FHWs6+s3HKMgNcpiXSDOvyjX5/d0v7YDPPYnbMDhJdUHDbGX9XFLP9oqu6qB5f6eDtDAIxW9WaG5m5WE/k3pmHC5LzPLtIXCgsMJU8dOP1oKDzlKzyJM0Dc/rdYoJGy47sgbJIl/sU9E3jNVpvuI+RPHFHgTviPS3PTN2I5zi+yZkklIUUgZS+TW8xAqZKgh1JBWBQ+SRppTlZoudGqUl5bU6bMgsL82iHEkRrw1bbZN+0jdqr1i2f+/53LqS/HdnnZMV2yd4sfCwc+4sZmhGb+z7oe7U52VsrvqX37B+uO5fW0FrFARCAXYg9XQxjkRAiIIASuj0HahjIsM9Bn2iOFp+Hh45mYIeya4dyzgzlfGUoJ0n/1KGdP5WhdSPaqo6oYXNGS2Aczvu4SN+fNnYAnmDJ8mPAkuVHgSXdwX7YLZgDmzBn+oBzxEzvhPG0ybCNLeYOci7MCly51kkT0hyDeZJOm4YFWKC1CRYizszRg5jDWI771MUcU70S6mOlDhS6VV4GrWsJxjKTwvVbBfPEgr2DKhJBWd8gcLN8M/yT7oQXHGOTGe45e0m+SB7Y2jDfyYcw3sCnnUw8+rkHhk7Z7TzS3HmgVANCSuq8RAeqongogpBF1fknn9nf0ZSMWgLCACWjzyhnteTdMsu6FS0zQuAshDAp+0tNHEdxJgwWWhSsavvQVWbIGNWZP3iQP6oijXjskNx4BVTNSGhUS1+3WRQJkAOci2FMFJ9cQeWKfdfAPose8troj9pnkYL0L4N0cYDkrTdazTKSymrmqtXQsqwS+BqBrdvXGlyH+a2orXxld3Afts0iyGqXsGiLxVImLBjIsr58vuyhQDmiJG9Nu08NdxJg2nAZnXs176gBehfoq2ygEmdQG0iu3LjMzbmRj/JtYxNSJ09XJw9tw1xxPNrAPquRH7VPAbUCUuebwEiAaAHVxq28dnkm2sU06up2TDZYr8670gIkKo/cHtz3p4DjLPd8FjsT7gYETN18/gQQigyEWpWeoi3KEy+7vmOgBeVJdit44Pa3j+3IjIgP1bPaHAPEgmOSwXfcwGHsFamt3jETPLSXoHHo7Jx2Vr06RrkyFcejvK+zSGszc8lwm1Ua3FQarP3SzI6sITOwlR8VjE7MJ8uSrl9qsqPFvh0AaQXwcQHbOtBFQycCwoCegE7gUr1SRtDMwPSWNG1BwLxAmTwz2okrOTupAzh3KAScRV2nlxMeWZ6D1pRdngc2zq3qyuOOAnTno+2ryzq2l3y5EqnboOBlL8GRvSq0GQZKyBn2owY0k6XOmGyuVCIIHIj7Xy11RipRQoqGaKkzdxKt50T+nZSv53l1ZwtJD4lJaMrldqhKbvSo6L0TR0XTYnnanFSpbq9TqvuZ8fOiSzx/VKnOntuoeFUTNBXhRERc7iTHVV+oFjVKBZObvVFlViJDURniiEQsebQSMR9nzFegEpzewxQM91NUtoEKjCL3/R1DBrjyAALrLHYn3LSemnh7+kdJCjmax3+4/2ufQUVrwl08JE8lKaG2vqKxFIlMoFaRCaBJQjRiROpmn+091cVkhSeKqMk0WWWYIX5ia9/ErOTv3JUMwa02iqG22dqDoVVfBrgDCvP/2Nq3Noayty+a2Ng3qV3d2KcDX27xOV4AxyRAzbbZ2DeAy+kgFNW+BsV5QqmgrLlh2OKQmnyvCxHdmzflSXmHWepys1+7c6PIwBuuF7MUqBNcah0tWnjJhkeHxZzqATJr7JViKIAsAmvCPYDfEP4Z0qy+NPGyPsxbegAHFMPpzujBE3cNxaaao4WbxMMhzR3l71tM1ISJqh4WyhFR0VZpk5wbPvyuL/z+c7/7Kj03dGN8/DI+X6ugQFXntzXaBr9SBdWqsC7mNlxKRhVL/xtHGSQXO8UcHJ7NbQy5gXN5yxwxaiPFRQDVUPA1fTX/jDOxU93MwCcGpYw61buz9QN2F5W31E+h+LHPk0q8yz1X+VBm8gy7cIAzFfudjAHEfHW0bH2dZiBczOumrTN6+4PHGiNTRLcdCL/tv73nz5//qZde29ZhMs2olwmYSC33hiyVtxahcpjEnpEZkopTM5fBYYRBdfKMI1AmNrBaBPDOSIwvbRe8Fbrvk3823jfc2FQOfCkA+1Kl3veMU+/t02IHew313FXqNmeFPQHGXRvPHXlAo9l9gAPLEd356tlx9hGl3Xqq6A3Wg7VVKHPJ1YdjSIPGB0eL30c89TKFUT3iZ/rdPrRF0SQlfUGplWLP5UOE5CcRFSb1aJdHNgNFxrUDNLlUScxewxWanl44ps+tNjZ+/WTLzj/4Xoiuvx9yezGpZgTi2EV5eSxRBsfG5O2IqovEXa2HyWltDALOezJBtGfBEE48LnnHOqe2vnnpseJ3glRdWnfMK0RtiGpG8F43Tor0orB1sUO1LYXuSSl0r4GRqlll7jqnoGIBmPVrGchDTxd7BepSS3KqMKQA0CqNfZ0EP3F5Jh7KuFBtNBZtdRWbywB1MQsoozWwFk/+6Af/McQC/1E9aiX9lLzslxFRVGyH4GGwD4v3V30uQtDzVySnnsTxj77DdA96BH2SmqhY8U+ZpFeb94zmveBC/wKEeIe+j7fn+zT2OWjDczR8+YX+5eXBKvkjR7DembXvuKj2HRIKrroouIprua+GavjXVfx5ROHXRT2EKPy6qFs8RPFvGQUFqyPexfzHybciGb/Zx+wXdyEKv9kDN5mo9yMKvy7qmEQdq0YdRxR+B5ty4kE1Ma/s4dc1SKwr47eMmjhPLGpuQB3HpiNmWLb/BDKj9MVQG3uq7QuaqRowYIvzf6jO/aKdi6GegAvknTIAXuwIwPLOWOnWXY2vlXjgRGF4KftVJQvaZuEUQXJ+/+aqmvWvIU+aPgttlgYov6aMJs54FYZ5JJqXuZgoKj20UiRxJQ38Ji9w1Kk8wwXtv++GVTV1pe4588DGQcOieoCrN/9+V1lyQ75+yvOhYeN0VyPVXY1Rdqjqqj4evnqMTaBqpMItMM0BJ0l7kZpQ8t2q8ZqpNqvo41KYfbyqwxqWOqyhvIp6BXRY+VHVYcULdABGdVifBaVOeyMrGtz692YBi5Aeyr6PtKnS+ux3yntv0Vb33n7734IS62+HVQdF1RsBtrUaDotYdT9i45balaLAy8g4FVdHdFB5ve56fNTF/SZYLwnWSlXW0LjWyYy+acIxcntXNY4V56CpoIt6Q42EmIU90dUDn+d6FK6ZjaEOs2Ykw2LKqprqqpqKMopdVQNeVccX0yCldPoiK/aiKK2usEBdxctAVU91fUUJNYnHKmVPQeITHGpH44faZplLzfG/4LzlvyIjme1yZ4x3FWogtwAoKKvS4hIpjlJkKP1kYfeUOGMmFurKbIbSU1ythhfrqiNoTbExAxpVHsXkm+ApJ2N5tp5cdxQ6qr8/LgvYV6qO9irqmyuT2p1h4QyiGc7UVfurQQB31eUdjfsaVX03RSpcNJC5n/2AkFAZfx98zb0N3F+qr8JsDSTlqDyqvmXO97QP39NXkz9F6hcwO3Ad+YTnIU8DWIlRh38t+bhcsqbKR/d5+rxbU4O78Kx6nl6332/awD3mk3vxfMBznqeFgrW0YYmokd3bWBXSVsX2zUBzvJ+f2luuHXGgpYwAA1VuvztYPTD71+fedNuPXP909Uttbr6VEPLcJlLApB9l/xN5KcSO5Vi0XjXDwgWz3Qek1XjPqOA0TqZTrGINh3E3+JCPTKgsDvRqPTSLuA/GcVYP4ynUYdOvKKmyQQi5GxuWtpRgAMIXFvAOVKpEuf0teVBV46MgvXnENMGhudEr8p/WNQb1HffNFRhXqL56SM2y/4ms2jAsBdZYxZ+zJco/daVsSilcT9kCCjfSj3ietSuUFP660c/kKb5ZmCt6GO+jhVNQJr9iRuOo24lvlcW0siw8nCzcc1960wvfKssw/S5HAMj5I4vIv6S2xA8PkseIAiwuunKq4Yj3iuEI+MHmnyXjWCsCYfprgWbkVO/mSuaLwux1r0PUh33Pn1z4nIsx1YMMrQW/QSiUgKEw4opWFyxs/pHrPl/sJgZCM8FY9KCig16AkUOb3yZt9oWi8k8PP0vMM6NJyvfoVTim6vjJDjIJeZFibaTLoVVHlexZaQTAH9HcdO3xXHs8bU8N7amdQmN0i4+SrKwz3AKiP3gYUb/i+fAjJuBSrFai6TtpU2Dpcmh2g5WLE7pk6aUruJ0UfhPtx2IVypWq0lv+sGp8Jp28wop2bUCRaLih86asRClCX9KQdK9njJOduZ8vt26k38FYMSlNAH0Ijc9FvmKpBMVIFPKwVMIWYLwR4BsTIfx56M84OnFf4G4Kgdlcrz+c8rP0cVlEuoEGQg84u5DsEAS8CDkziiR8hcR7m2pkwJHY7M+A/SJU+KFPnf5Aet7sM74H0Jbh0kTDQqw3ZRywx2uCLZCtdV3FAOJwMFRF5oSrhsNUJIsffhzyyZW7NkTIaMaxQJvRkqz5jMTnHfHI3IboN89MBwNKpYuWMZFe8svtmN5yRymjwBgX6EhOEcBSZE37Ir9G9lwkGMoiZFAJcDrqnMCIiWcQ53BwVrrWAk8O/XuawZWj2/JZ1eaItZEDkrOnDrY2c75CA+JmHN1TqLUaZvA+riSjjOM4qaOdyd4ifPkcza3T7AbypvZKjx5cMcCMmboHqlbqzKAo/1WXNCtaIROrw/jnaiSHUcmthP/exyV46egtf/gjgzxwfVbAh8M78wiUVAqJss9IIf4LihjzQeyawBjamd/51l/+hz0PXja8ViZd+oueF7r1xS0uuHxO/u0cBTtn/S0XD106KusGi1D1u+hE3ykM9TpWYCo/ehvsQN4GzQFYgaRQCp+It58mbLs39Ix3Q2JPs4zmDiqE3D7fac/DEcOAavU5ux/QEfl4hA5uyHoXr6p1PWCKbIcH95rD5wM/8cDl530VNg4xQEx3ogO334Z/X76M/d3elaR6JVjbEprLK35pPzIqSQLsBoarMsqf1VHGvuouf6BWie7yVx1ZkESeOftVsFtNAIFQlUilb9v28+jHokIllv2TQT1vqHkAW6Mc0TTVhjc/Epw3VvnBQ3JZQibVZjHjLq+ZGr6MW0MPoo17xa1JhN8HeTn+I71kptZKRkokqBWQd7BgKkFNVpZpQtrfxOSFn4wZ9YZczNxOM3qdjuKNYgZHKjOUwspJgxL84UvCt5iKco6d6eFbPgfHImt8424zn3fzQd1yh6Kl0tUzYi6vWACnEUjZxSIOOqX9SpXQKyVLrm+SRiZax4YYOkvADC7obECsZ0nUEib+EmIPR7RkYwPiSh8Cai0q8FDRaLFmE5dpKLkdjRxtQmbzAgsefROqI4KmYKDQFFMHaUVlHTg942LlikVK88T24BZoYXiUfKMVsVmaE+XJNQQyDcRVvwey7FGXOlcIlUYsGDwYEW0WPVkmPN3qy+JPs4wKtrCHVAvIk9GR4dJZjrqRIk2Zc03JzJ52WntMQ+bQgDnqqk8AqlGP67uQ2yIkVz1eY3McIntIbf6kPbBGQZVUe+C3OACKKkufYgEHIUY8YTbMV82G+RdZxup3o7Aph7zhDZY2hCVtMDTgsO92mtjZV9S1PGtOYeDnsb004BP/sbnmun6rMnNwX6W1xOaA8HdFH6OFzreooeKUwSuE5OmVX0qMulmbYppZpebapl5A7VBnDXfa2iPrNOhPEzBsUoc/5iFX+wKoIKZW3sQsR1SqTKO2Ls/+UuneiOQFVlA73C5c52uvjnRl4FePnTPu0kxlucf01tvJsaFuc+gGhXnH5WoLpwJikTHlNs7nOmpctpirdKdd4Tzb1MHhP/+gDwqIaLOY1wNNTmYyNCxmaY7Pjg985zv+8oL9V3zl/yMX5AVsJvtryTsHZzur5FfvBCvxc/Xxl1/9pad+zz2v56VrfoNb8q1nv3b/eT/zyGXU3lhfv/PAf/vLq1737lv/4jKMQnt9qJdHUKr7Dr3LtHnF1t8PK60YmtADl61vbHkxOcLgytXGQQFQ6IJiEPq1fqTLXsBIredGPo4CWrwW6/SAhJu8Ye4uU6p9C7cqJy7YULmWcyAOa/VNo6jIsW3eK8kNTF/OQxucuaU4TK2SM+MFvCG8KhBKW275q4Sa67AzpO2MycM1WjWmPVhRA1QUyS7+L0Q+HA/h+HodPbhzaGV6K/s3yju+Z+3fWGcO4GHPuKIPVaiuRG/EInSgR3h31RnC47ui0PTBoxDMMnBDuhFY6uSczmPpz1DET//wVec99S3z/5mZmrjchfX2y0Vkr7zqS/FRLS2vi5JLXa3f1SlU7Ed3+Q+WkdORi8syCrif+SodB29Dm5Noczzcnc/1yCL9WL3umSthQIbyjukhv6Rtuu485E31xxLyavMAJxEC99rAMRu42wbWPeHilbrimExZIQ2NkZTjnqWXItP2hTcautu/QmOyadQyQUuJEqkyM08BGhbDlNJ1V0rRGmLBPe4NKXWxiFr3eKFKcQN6kIAAKZ/Rxtqw7iEgOMtvx/GmhFgPQXH3HzubvYDuKKEeV8CZUUlyR0Ei1Yj5bId2rsAMyyphzwMSYOm4agRiZ4NinAoIzTDBz1vGAMFA6LhhDh70dHD07T5PR0jfjuNt3b5l/HLcvhC/3Gdf9vLLg54VTMfPdasEmHYzwnH2gArO9D37K3nTtExXBmdJTtjeTPbYmfAabUoYPlF1HWjpaiGq1DqkLVy3V3MuKpgneUmG5X4V26mO5Y7aulttG+jpew/vyTq+mFEfeqP6TB1Wwi34ByC0KooZFslsTPlHoaGwxva70nAXTKWLbQxKxsVCxWhYYFy1B9yEHqdx9IyJmdCuyoBcx40dG56jlpT/nufHRtvCKcKpPrlPgbAYoYpt9K62OtcKVJ7mqxirLqwVUzpO8swbxULOldFouJ40eXD4CyGBYpF3k5obML9Vs+DlEnCvvWLpPA/GjAd6xlC03VTrntpY5Ux/wgvtZkx3tiJkEX8n3JuyG1ZzCF12rVUd6ZDqMM+Vq0XwBrsKM/RU2ES9+5+qFblQm6t8pa6FSG1SKPViQsmpnWtrUTfWev5Jpbyo1Lcu9JMiqDrRL8MU/DhIsLG0BgPPgP9tFiw3cl5ElPlFdayyMQ4+/Myv2n+1m0ua+dXa/6+vi9TWGcpWPHQjJrKr87v6erPZtKrwKVC1vCGaSgG09fDiV6yl+xCc/GAwYn84HrVZBrFF9rlpRsWcNX5nt6zu7JbVJ+2WuXRJBdQfdTXQTOmslp98ftQ27d84+2XqBMPqR+PMvLRRcBC/UvpzVvF7KX4uXz3IBn5X+Y+iVXtrV4sStz0RTJwlV6At0i7E1WWW4hEWNXvMPWm5tp59TE2n5XWMELLndX6OW66N3RHcr3uhqqVWVQRi7WgdVYdGKcA4g8BbkwLITr8K1WMYI1EPLeh5CJLZhI4AS1d7UE6QAogSiWNvytRAXB1Tj6H6t1W9gajUG4jwqhZ6oTcQIcLpDeCl4JEd1Rv4VpyjH/bMQXo8eL89pYyRIZQ+S/PReO2WdCp7sLSCFW9lBevv/i0oEHw+lmPUcoque+4IZ9ot+hjrqoAfeI3jxXNUlWUPsBOGY2s4+OkBOmochr/wD1CtyrpdjWOhitiQtfZu9cRMb2Rid7N4msKDP6+kWLSbYI3wCNrdkuCtAgg0gSJnLOMfMWYwNHRKuf9JrTNoHyK46SgbBagPq2deEdSszLneH1xWbrBwINHrDyncVMuaB+wN42HVZs5G9pBUVYdFo3DgU4jVFjVfALCd8OthwWB9oZ5qSW2gFlQ33NfVElZ+5ypFrGu5K/fXdJXm4PGRXqEft3oHfvtpN37PO9Y/e9nQ9Etlnb/B72VbQ24rVCzCQZfLSo38P9ISKcy+jFxK6AHS7J/xblZCSoDaumbr3GrhMTgfWiXAY+yHsn+RL9TfFn4uKMK1C/19ld7tr/QOYwr4qcCawiv7F/oHpGrtE0rYmz1syowghtOmSuseQbwSrN16bBIp1oZO60CTe5XklcnkViU5qyZTCV38vjD7ijnFXPdG9StAoyZuXEzGgqqdmoLFl8YVLHAgazwvVxQsnjOpYHFpJXn/ZHKtkhxOWNdyDXyHV964yL6KxjgPHwFcVMhkMikcCzwS2wegfUXNZPJcJrGVBIIFbxahXGbGF+q/Ig/VOBCFmrmQ00BQPQ4g/6TvhruiILwB611lV151zVJGw4NF6dOCC910J5awV2NmzT9eNhQvJs5CrijEbWSfU3vi2XvwHB74u4v/+SvPPO8fL1sX27tH3fmn9Wxxe/Zm5DyK08xJC7uBgsD4TXEztIgqHlTqCt9K04RpT8RjqTfa3y376VX72aDxvjVO2LfG4+hbZH2aJMCGhLRDzqdJHdnqwAIPWDDWT/DrihNf1z3FJkf6WiT9oi5UggPo0ySmHo68ij1KtxCLwbVC9fMwT1CZ726KXFPEl9QyBwOPqpsJikUrPgJbvocfPkqrWGnkdBRNkDIPPH4D3QOdhx+OnoSIQ12E1ImdhLpqx0jELg9zJS/nXkC71S6uh3CQLhqESji7E3NNqC3O3eO1It7MPaxw4L9HXK/5FGPs3Z2dEYUEvWwwzPmnqgdD3gtk8yurqm6hyKuYa/Q0YUje0QM/90vX3vOF//I3fA72HfLv55wegsg1N/iEc2kNZjC+5zJ3jX//7cc2Diyve/z/t/AazddpRIDmV+1mayXkWST6LNfsH8Up5wSe2IYCeSmEno6nuzqMtsXJcBInQ4IUKrx9HBUxxGp7oNKgaRXnkFkaHZ2qGckPqmqUshxZqYLVddD/SPYD1k0ufIc6f3EwI7hpHcTp0S8F00wk3TnspKZQtcqrmYsQ/QqOPqqKhpVy4fMzmGaYDZUpO6zW4kJEiWFJvQbjw/w7ENw4FgnVJ7M3ooUJXBKFtpteJ4XiTkRgtGhDZzAMO98gmnR5NmmQz1i2i3hzDJN89RGTfBwbqUk+jDXV1VieGHKWLZponCcV0b6HMw1PD7nqk2b6IhjpQ0lhxUhfZI30oXBhad6hitgUQtARUSx3YFztMflOa3zrFkQVw32hGO6rW139OoVOV1+3YGiubnJAwKihW6DQPNwmSfdFLQggKg6B66rsElkTa84Dq5rs+6B6A77J95oONSqH9ubM/mYMah4qXVsrouwWicCIWIXdFTidxajrTj1PVJe5oXr1TbVpDrEuCnlxIcrKpaWDRKJTLltgmdp47IwlEz8RqZK90WsyRtk30qW/pjvhQJTTxINSqeaLyPEYh5c37UxSntpWbta6MXqlFed7FRVy9DDCYx/6C5H5dXJYAXRYoxC7pew1AA4GdWR7orx8gr0D7rgMxDwyBipQNee8ocVCbnaBmKbuao485Zg9IzEtqLdpzICrxc521SS1uULEFzMYGFyq4/amql0+s5l3xuiHyI5jyigaoSAdQ0AcuFW/mn8AYDEzrEbYcNNPjc7PYejmeUgqx5YqCnIRHW7dHFzaVi5GHcVB63reSW1NGXWGeUYzFf1wmqX5ikXlDMd29k77jAy5QLoJ83FoWpfRf7ynC9yYxVI0tkCLOiLRi4u42nfZeFkCWnRcpS54Tb9wcCQX5OVDq+pg08MVxLDzBfKs+8J8SarkAek4NqXomJu8mfkouq7yRY86aImUqT0zXuSLbRjfHmUA1RIgtoT4LFdnAAzGbj5H2/KZABBfEkivA9JDDLZ90ZMXNQFnT4N1FEbuY0JvRsm/r+telRfBmGZOx6niJo/juX0bGFpurUfbpFV62N6RRriTqerxeoyqY71pO1aPkNhiabyWpaO2lhre1qtXhKdUeydlR4eTFaKvXdomBihndRYtDyI+VOkrwq/oRJqnAPRuO7dnWdaKOoSuHIaRDoT6Ay4ZxgQ5xzZJomWYTt9xMN+J0PU50TztQD15DutXcnJTMH7u4r/dWDum3EY/je+OX0Uh4YnVZTvtQuOKSEUBIRMiQjjj8NXcj93SD4kpTqPTYGHjdJLM9vUMbt8Obp+5JDlLiRbI1dfC60SmpeGr5UhwlvuRADeLSPLFknaV5NPwfsk3T5E5SgCKwWzRHo5LxuLOVGoJpQUIJGSHNkdn5KepPEWu1J9GZ1YsgcX8voffKUaiiVWrTzMgqlqY+nkAaaLT89MIGGy1DXfYqyaEQSmoADC0s9oVLlP7q73hVzVNJF3Mqx06pcajsTxsrvmPuuUp7cxx64/RhldysaWSiEYbKikb70YOca4TMvajnehXxjCUMYzLcq7icszIVsvh9WGynK/bMV5WBmAXdo+7aDesQe+mbdZb+DIGvsEwWFxDU8X014yAdQbgQLe5vBVVrRGt16qJgY5aOJFNts5DUeeluGqIhCmMMc+kNrnVNBPMxmFhE6qjp8u2qYt4W6SmRc4u2timLni77oj0qVU6Fm+RHgmMJKdlcjqRrLAzPAgla4b5IOZHmMoiHiaqcBN/TkZRWJJVvPOSjw6PmUSlSM2OJoZ2ripjYKqp1JBKcTn3fxPsQNVuwQJ4w6sBfxvnOAWa6/Mqz2vagvOznfdoBlXmcWVIBJNgz7JTXcMzs35XibxbvzFIJcmnGZrH6fVCJXnB8hZ6+VvZvnk091ppMy7Ebd6ZvUkW+2W7qINxyElRnlFs3l4N3GYpzjwgwXOMkxACwe/y33bIpWR9wXqBvcE2jGQfmxy52TexqAgarxCLoHdj0VA47gxAJ3bRsqL2Dtqdz5R67/P4Ykc5QRkAOAie59Ge0dGVdZE67lL6KDvgTMIBYLMAWHXCUR9xfZl2xS6N0waqAa3lPJZmzKIZMHklXcRzVrc7Ec1OLMQFzDRtR4nbiezs2FYi+bZpcwCQ0OQQyddOnwPnVOZAnkMRHl8YRM0xFHMWX2cq+DoVUWemIurc1wBR54Coc2OIqrSkiqjahVD6MYKos4qohcHQWYehYCqLEkN3UaEYKqauVviPLIaC5+mi8O6JMVQHejutwK6UAHSb4Wy20W6atRi682uGocsVDJ01GLoLGLobcbs1Thuo2vGz+Zw0Y5eeY6B/UDPcZdFzWWpCGSM1rSBmhQilEhUlDS+xtDsNS/MyOZ9Inr7HrA0ulT2mXkHWnaY5K9KR2c3F4pMCtEEO2Bm+KEp9xPD8HNR5aIHRtFtUPObdjNzBZGNG3LnMDzpYylaFtluwUCRAr24G1RRjFRIJ9bEdn8fCO++WOAOQ3Sre2I3O7q5OSRRkt+DtBs7e9S8SrUJv0rGbnqg+X7dpCqcLICita2952jZGdt1nB1fnTTxemKdqhb5xgkPJJvvBqNgUMt+5GNleV8W1csCWz5TurGc2hfkpsopAMp+VFs2MCXHbHDMqxHW6TwL2OXg95Z9K+9rUESHunFaXt9GlCkWhjhXidk4sxMXmj52WOiFum9pbCnE7LMRtp5S53VopvB3SrH6o5wfr65SNu/s+iq1bZZO4dz+kuJO9roHsZmU8X/DyTgEe2Qg85gCPqg+izMIjOzE8MspOHR4Zw2OuIkPukGVrkmNDNKo9IVIG/FIKoMQMFnFrFNRTuBEUi/kgCCieVc4CEBhBJmbjqiB9tIBr/y8DXLsCOM/Mmqx6GtA+OhWCtqEAD3nrBeMK8Ij4SXP2NMCbPA3wKMM5xPhpAIMDcLmmP9KgqUPX4ikGrckhj/oJSIE7U2tTVDlSy8ivHJJi/lYxJ6OObXx7svEZtbnx7S2P17ZCtRr6ts50UgheqSZt9LobVXtk4tQYCdE61W18xvFN1weKhrDhxgVeB26p1OW69KCK4WFeqwa6X+m33MRSUXyDEkOnX1wwgWyX+ixD7h6nzVC8dtDFn6fxbWeZrYq65d0Zbs+6vuGfVrHvij7OA+cpdNoXygaMthmB1otlW1j1cnlf6EWVA3Ffv9BjmJEp6anvyiKyx2lVch/rQcbEmZ33GM7swskzu7AyS0M7S8MTz1Ju7Kmf2YVyZkfRVHIfkz9C7qNJch+qr9ItyL2bM3BwMUruTw6PqAoPPXeKKvCILDyiE8MjoujU4RHhEsCI79+gSu6nniD6qTlZc2oKv3DZ8AUjaiGvfd0WaiFIOblaCDKdsloIMp+KWsjbfK8xqViDJhr/naH6BgrUK5bexdKDNOsDKUaOhHAhHOdqsKLIf+W5WlA9V6u7c7WEQnQvLi9Ru8oiruygKTdv2HsxMaSTyp/7cE4oymy+HEgWeuxond82xAYrRcggj1AeSDPHZWi5VSSdckD2XWKQY2ubf87wFg6pzXlgqOeBkaBy5M5KK2eBzubfEU/9HvvGj00g/kn1JRdVBzSwVnVdqXpIFVG3Z7zHSl7FHPKc/0VV3Hb5K5bnQjxG7tsE6TdJ14zNI9XtlPNAKzqCmpVU6CJWxiLSXw4CMPPBFJpaBNM0jdD0ED311gqP2ftHT0mxV4xBOeKplCN2lPR/CeWYrv0QPQbtB1hytGgfn1D7IZqm/RBjOpya9kOVdr0g/atm3FALvTeM2eiNqs6uDg9HXVc97FxXaZJMnlsQNHvceCB5rLMyljyr/yl7bKp2KdplhryuNd06VtObh7YmTdKa3iY1YZJwv3ErDpvePdosPWtN5CJFCDtTIfbILbkCUd2OzFAAnQIjvEnODOiigBAympiZhvVeDTjyPf4Rv8hUhJBRumrSkpSaJAr4AzQWW9DXCz2epRmI03hQcNkwg9UEnHhzpQ1q41i7gxnZGT8Km0G3PNPs9kBPcYO8WYWa6ayDL2UqdmmmSstbGIMORVP0mefEeHdEeJJ5ZuYpw4ObU89DHdW98SwuwCR5AqDhQlmeKgMIILGlDe4ZJOrodAOPeUigrhUtrAQkO7FeprEmAASpxFIH16Qg/OEaUlRNKcfgcRAOgSlVK7mosSyWZq/t57OligCA2OBSRM4okiO4qHdtA7hnqS6fX1PU4Zl+HhFaRrVtaHku/vUyBinAR48TWM3/hcBq/isAa4FigmkDAVqXMgIznv02rOhkh3USOB5+gWaPFl3qljF81D67UW6saPbAf/j7h35554t/zOMmzwO4mHMP+KXY0BkygjRToOy2ZdxXd4Yv4k6aXy9jaP7oBoAmUjGaHd1wBLXadc9gXm8W/Mk9/guUEKtHR2pafIB3Gfggyt6AjnHdyMOvYj5Hdv9Y/jMwTZn1tQ/RX7n9ODvui0H0+g31GxuvtKQ2dDeEwmnbGFGHxU9tjRmqq6/nESAeQ+YaV5WiUgOEoim6OEU6rQhBi5aRIUrnmBqhZeaOfJp3DJmZMVLFNcgT56QY8ZyGjvtXqJYF/y2JLZ2elqOug8QjD7xFy4nIgsB/2yoLmf08RF7+63MFvXyFQv7SpxVp1Xb4ShgkIjBGaflOro0gmZaVfgetwIVKEer9yvBIyJF4IX45pC96KP5goC9yWn5fQNu1AvimyHOjyb8TTOgKrcjRZE4xjNFwFF6dHwdrmUfRfOCpAPh66QVRO+dCROIMprpPPbhVCGlWbnsKbvU4qH3fjreD+Q7+cCd3nKRH26lHO1cfY6d8oolOAWqPvl9EaD/RTqDrTnN4Th1aklHZWQGYq0CKXwHelH4tgvFiF1HsInUVYkm+hGMwhVhHxModkR4z0mX4LtNtvVTeghmVwurh76huK8HbUrGLdg035FBsuyO1p+mF6B4fVeRtkRsDUUk7AD+QbZxC4+rh0eJ0On2Yn+G+3UU9wbOWrLXFzlXaTWfQLuTOjhZ7aA/ThDNHtVi4RBL1As58OmcoSRadSWeWL9f0N/C5+ZKODZ0I0JpWki3ELhfNjVkBcV4RWJxWSTjNHJM5DYcm1aW94s84lEMaLXGFu7ITBbdAnHfJHmGX01M0Nei+EAU1oN8onxf6XYKIHAUVp1CCHjn1LEN3DvS7gf0N5l+UNhDmCPBRgr5EYpbXNRLBJgcPaXqX0sELV4uzqIfu8Znh2dhuPRt83JUvyc9RC/PncmpvLd9GszCyH8Ib0HlibCA/H4ssp76aDyeABJkMbYKy9upsy/In6XTKn0wxFWSia0WOmefbmVc8BXOPuzBFUecCzEROIgSOI4BvjyGAr+52X7l/Wv66zXzEAwllmJ0DWvwkehLUdZ5KT6YnI3AhncvL6tk8Uc5jCnx+Pq/0VgDmLASkOG1Ulo8Po4U4rVhisIIZHYJISL012olYDTKp0mEkDON9Omk7TKrmmADPiNgzg5AB84d2aJlKTlDohSUxIENcaEXroZ2IcN6HUCe+eCoRB2zmyWwraA/uHBHGUtsjdW93/dGqtR1f67ppOxCK5xoeO6gNZGoP/OfphLGOX0Na+FcDzQ6tNSepEPoFhlhvL4l0nvPHhFcpUyulvLoKkOksobOEB9EOkJkdA7UAqK60dG4yGCKWUSGP6TG+0v4CSsvUVmTUlekpsmg+uVyhCMZ38T3ltMOtS/QUafJ4r7Fy7AQ605PyHDIy2ommqmk8bRy4kLJti5gBHPRN80BY+XkM5JCf657yFNsBOv5IAfQUYsAiVNhpwR/L+wV0AZqC5qFVCrqdZmVdVm2+sYV1O5rc5roe9LQNx00b7tY24FamdIkzAqdkncSoLlqkWwC7sEAdPDo0h8ec8hDz5GFNZiNYIpKTa7VMDUul2CUGi/jaoKV8BTzpBDkBoKZTJGU8hPSZgDIcuTIbFRLTxogqvoUc3CnLQptWTDoT35LaZIClgg1gIeb/VoQBgqUFEpUcDvTyZUtpaDlf5LLCYhlFKbekVa0ItmmVJFVeSCsWeVi/APnNFAvHsCikp0rWDFk1OSuTM2XogBFEfh5y07gnXOt2QTRaHG9IaBqycoKGDF74RLRlBWBybVkG+Qkd+YFk9BTh0zbNSp54EGntpLXbieXmepUIbT8FIrRDeUVMDT/fzjUR+qkkKByrS+d8zp/ky2IYJtyS6uyoUB06CdUBmRmjPEp1lhEH/F2mbqV9PWT/P4oQKfsupCYP+eHzKOZLEDFb7coV8hgNt6QljnIgkJa0oSCaHSEQZPJlllRdAFKlNGsm36lkgZgHpBV1Eg8PO9AY5SryCyVAeY4nV5VfJIGM4TgjZImhRrkot1rM30cX6kAXF0q8RF5MuUZySU/l/56CpH10kcl5EV4v5lh55cLBZmIlwnzcqdwvxZxduqucX8ZP278LBSCA2k6VJTxVm4liiRuQFLYDWoMt5wLtns5I7bLNwMHRDZ+bZTo5Tj7TUqkbn4xSNcVf3Xlj08fjETq2ZGWMbihhAGL7ikzE0+XJ1ORy6nmoBEILJDMbtp9gNriZ8KSxmeCQncY3shy3XXI+hSGvc+RJZo4oNWmb5pGZC9tPMBd0HqQUyW5AoL6uO1t9OYKXDJrZEME1rjA+whpqvC14+SB4Sd6nlHpmJcx9FKrbEBGaLFtWilrUlilhd/TH/Mpe/7h9IWCDfdmLkfcf4woeMTRiCFlKzDkkeCLQQUDBTfl0EYE/Tc5A+ZScs7JoEZRXZUlPKSx2TkoqLJoqxtkG2JKno9xkZSmRW3An2jdZOCo99dJ35qTT3B6f2gPJFPP2Ce7L45jRWgBDowoEnXBuhLdqlC3+hJDYLuh/ty+GKPRlHS9kXo7gJTMvh/CiVtl49u2g/rPzEHMR24PQHGMbC0HFCh6XF7DVM4nWec5cLEgBhBu6HE/B/afkOfc21808L+kpngUTAVCCfwJFUNqupgbt6cuKLGu0U5a0ihgIwBt4uqMzUN6F+VfV/N9V4Q/KXQnAbMxG8ifppZ53Q2l9KaTgTvHCtz6kCCKlq+8cimMFr+BEd1A7zN4kAuT34fqx9yrA5vO+HjM3VqnOshdEMQ3gt9i8PYC3olE5t9zQk4Q61Z2QvF/g64pH7Pt9/K5z6WtizdGHmeFVubtZ+yZ1h65m4z4A48QS85/6+/zyaBtHxHnN2bdP038J/MA5s7jb2Ua0Wpqftr4sAJfszaL54InBR58Hxvq7kDvHtTODwz4fwSHIw/mQ0l19eUAoMrLLIVykF8UjtQDtzuHQxB5rCtyBIYD0HsaHbjUvNeQXnoTPDzkOTSD07W3+KhxcoNFqLOguP3sLWuqM0H8fv4Lul81FO/AMs1vwpbZHJPg4QSDYC72fi30tEgst43cRxoef8NQ/Xk1NcImxM365FemuyreaU4aKTxBXn7Yg5MmalP5BjCLKX5X6hrQf58qxDrWO/NrmcIgbNre31jZFv1VH6HrnbWRyrPT1iDnl4EE2CA/LTzdQIFq0RYzH1cOizsiO4POH6/gMwes4GEpzjUFIiisqa/XShcmwop5WhtcvZUukK7ZN349GmPAPIDzw2JFacOOEMxXnueQH9RNx3KAaLOoHIQ/0HntY8Y+COQu/tvhwDS6Ln5seb4Tic8cZN37Qq9yhhp2Yz3t6cv3Qu8uT63t/AkHjTWcgNqPuukuitrAUuqmphPA9lfC9COtB+HvLYPCgBkd86TxQ+erQu1z4iIZhEO39yIIgtwaxGnzIxa5L7N2apo539ORdupYaVYD3jKkCIE2zaZKqAiBovrhr9ItgHe/TQIHmahpKk8/cnH7As3OaYX6/eeGxLOe0GOJU4uhNHBgWbKHrTzkD6of5TsDjd/Hc9JQI3OcZIuAo0d1elRSte1VadMQ7MTG61Uu1ssNbm4d9hTEB+0LzfL6xtfUrl+XOaq3auOUaRnuW10vDXHkMINXFpj7F6runqLMC0FWIPvCWv/m59X/6tfVnfM8ltedQsPUywP4ckQxLYjDp/rsex1wqwT9FcJ8EjyN4AYI4BoIVMQQ/j9g9EtxEcLcE70OQEFSzZCsSvBef9ZRM5rHWmLlPu67GlqsxcZ+Czw0YIcR+QfY2uY2fqL1aFMfkJq/j8Yq8UV1KmdQnbinlN1gfaBzFVSGK4UNVAYykwnfran2DfONqtbquxrquBucyTildrtJYgxHM48CboWrmnOXXPjj8ANZSH4uoX/Fopoj0kK+yHXwhBE7BpqREO49ubXoo+PNe9kPouTFarN+bjTrSv7PQhcTYeIQ1/PIixicTQ9GCk1K0u366nLiH3ztB0e7VqK1sH2sqIfxQJXz4J0uK9mmNFpKA2DGKdqvGqbnkSviYhjGD79cSxGOYxgpxc8HjErxPI6oUDV2z9GnTdVMpLd4lmyZpUe+vfHFv9QtQFHmfTtGOudLw2b8tiiZsIDC7osLnqByMd47TtdjRtTpAFStdqytdA1U7CRHDHFJoPOd/P3r2w0LPYjKGNJ8PPS9BIAQ+joCQuKKuFK9ISIndUXD+lLB9/tjQhx9BSRXSMkpWMJ+nkpVbT0xW1N3v4yQr6+8rZ8+huyfIyvG7T0RW7tNUQvjBSvjQz5Rk5RMaDVS9FbFjZOWIxslXd1XCmxoG4nz6bkdAEKvBdRe8R4L3akSVrKBrlkjcjXCFrLwT75JNk7So91a+OD76RXCPvE8nK5uuNHy2NVn5Bln5Blm5bQpZUQSCq3UETpWs3H5CsoL5PJWsvP2xkpV/jFg5Pyr9VY6TlBvMVPuJcuKsDzmY3YH6lmV6aKKbHq+ozI6XTU6O60bmRuGPzo5Lav/Vof3zq1h/eRXp95U4HyrOhyM4v59bA3u1An24NOTXfavZj6LROhn2Kqqdj0IBj9qq+uY06FpEzt0mTA7jc5PRTU7rzutdyEPqi2lfEVnjRJeSC0L3tKdItl9w6HyGxLdL6O+ATVcZL08wqYrQw4i8XIIZhw4ghLp1KqBvMhUUeyMtOCmzt1zBYVlwjSLtRpC9Q7F1wJ/fjdHMIwTXJVhH8C4Elevfa9h85elHOPyGuAExCKyY3Nia048Mpx9RVOX09WYHm4YofGOmK5TJgxbg7YX4uVZULSMVoW1JRFDMDdmdZgIF/O0El+6uS/9YNGqk+j7nUqky+0BfPOe2N8D6ecTfko6u+9b7iA0c8wXfRB4GhLtDnlxIoM/7ND24F8/qKnrclvCADTxkPj2MT28NnOteif2QpxW9X5/wBYzPQP/dhDoyso4cGllHrjvxMvIKO8Eh8dtrp3gspFeneKxTXEmw2org557KfAFFdmJDmpQarmjbM4VVS3uWjPpo0ULJDI1OC7FKZyoFlN4vCbfiN1sfI6hqVE0tK5dfa0l7hKZeTb4hp2pBbYKcnqMQigxaaeStnsZKN+/wqjYJNMP7qxk2RzJoA6w3Y/SjdJV0j+/jNv+EuUe5wnafemvM1l/PTwh70XxxSdsroiGFG0Vc3iLkt7djiq4X9Wus3fyN7BFckrkjOyRGNIqEI+MhJRtUr9hyXc9jMah44NxvWvncn124/JH1stgaop1/RvfNwwGrT1/oA+6R+kZBa0IydYeTdcdyyZLi8bpD1B3aui/j5ru661vXPfCV+LnLqb/lx2qcUC0j+Pudn4fsKABYBMR3qDzQm6wIhVThLqreoWOF/T0MH37QgYff9YXff+53X8W3kRtIlKxNJPXg6Iea14jrQdBCJLewoJR3GEuby0hK+KpJf8jFXGtMruCqLwbN5iYXvKbPMHJLiwteK9ISHHVBAx3N2MvV2yJDTLY6WrORfQUAf/vDTJbZFz/x3+X9ooX51aL6t+CadkwRxqeFg7Ms+xEYeQSWqWtq8rNbESMOQD8X+JGT2B7n20yJs/H4Jc4LelyaZQzhtgVvKSWGSdhttP/RANIwV+wIgXjxhDue6tTPKIGZJv6kpSGhDiBMCeZuyI8VLEv8GaTTcfYHtxir81XpnhrO/KavfvXGr6pjjIftatIkfw0XLEZWlWwI5FhGg+6DL5cRKwBtdckmOv4OL+GoAj8Zbp3B+mxniGd2Z5FhfnFK784ihv1AMSO4Thy9TimPXHmCFXNMxUrOUWpvcHUx8R9jQrYhM15OHg4FyoRTLPW66xZSIH728VVvs2pL1zfMoRXwuqZooq5AKhQp4UE9lZnzz49q5nxj5vzveQr5tiiK9BLjq/6XT/qknPRhOelrkxPezva8pVM6D7Xv+YwCI+9QorxFMnW7XyOlJC20qZ79C/DaEgTuSYKeBOZuZSLeehRNOtRcoxmFsD+xKaZAtAZ8pTaYoQL2jDKJAdjd9WGVW9cB9rrY5AM0cAfLhOBtBS/Gu4ubrSehTXMEC7AtEKVWhSjNW6LUBVFqGaI0D6KEm13UNUTphVsQpblxovTwCFFqGqLUmiBK10mpjigJuBxdapVeIlrGS8RjoEs/cPgbdOlR0aXv8+Cn6ImmSuRDHQyQuUX2I1Q/2R4u0Q1c+odhqCTn657ghIbgtB4bwQmV4PwFek2pgCsFuITkCKmp8i6B411wLbRT8iz+msKvrvBTkpEpsaoVnljoM76fTplwzHIDs0luZs4SjvkqNzMHwiHu7edPQjhmxwnHX76uSjh8x82chHAEj4Wb+XtG9Fdy6h63rRc5MU31TaU6MjXCExk9yLf09bBnAreaAPbcIoi+gUTKzWOoCgDmeY8mww3mqMR802R40BZ03AQwOPCIKk3FXp8/vIm/ylg+gHX63gApt2iKfHAoMoEHQ1sEB9Iv+F446TPAKHrc9bppTuxCgeWIr7zQ+coLJ33luXRJBePwKCoA9wEvedm7kFndxnFfsnfrqzhJgulze4TrKyHE1IDcnIWc8nu/h9/nrx40LhHDij88H/7weuLzxfrDU7SJ8Sj94cUT/vC4Q9kfqj889ViI7NiZcotG/OFV95tf8cV4R+OG0Z3m60bXpVZlXSqFcIUTwhWlgK2ySNVlBcN3jVKGZxeoooFLh/xMZT3aeqkKzVJVN+tKvWLPA9vxOuamLkQ6+1t5G4GkaIiphITMl1hssMglbpFzQS4iQYPTcnUboqXSwjYkqzBvxTmSMp2SykIIi4KJXcbQQTza1OLH5IIWUlhZ0L7s+eBXDdKTWzsSjPCKyrWP/cToEdL78a5SbU2qiWwNwXSARNT2AdQBIaVE5A3rB6+h1lOALuRb/jqi5v/TV7WERC9ohqvgC8HlBcb0Y0NOIoBTvipSyd143eViwcFxBEI9wUYuQ8ShHsA+aPEGVQm+88bwh1GsR4VqPaayfjZP4IYvZWIBj3t49qjJmAwhk7hjzP7YuEBr7vFhWVlDjBIyVXQNbVbWUHxPLVlDuxrC6Ypcha9h5g4wiKhBbC1kfyLb9A5Mj9XlswHZq/cnL5XLOcrpABfwCq1rclyozvnI13pifiTs5UFqyoB4YJICqovk0qy+iYE91Nb4O0Ai3G+ee82TzDMbM2U3EEebcc57KDFJUYdxVoS0/jqoWcAPzFp1iV/MMhBm1SpFXbxkWsVgdcwc0IzEki9WKZoC5hR10QzH4HFQrKrOYMHUSstiqc0mHtool1MqujDcekw7aVQeSVtdCwNx4x9IIdcUASzIziJCS6q2sCY9wJkGSGVLuA3Y4ss+C0BWHUkTXCHDUN+dwlmsy07jOmrJQn6xIJwHHgGpiL3aESGkM9gra/eh0AevjzMoZ5kFz1DZPKAiirvX00IR27LmJbJfRducPQvfEdnAkV7RK75GDH1Z/1IljVUnWQGFSK/Y1QiqdjUCXd96TF5FcwnUYdRuBhfhuCEuc0NNBvlTbWZ0Uj0xmpoIc1liUMN4kVGDP14JkVb2a8JaaWdg+VXzgb5Nh0ToIBFRJD1leDgIhEcVQieBQBUGWGYDtRj1eACRB6DqL/G8iqud0Nn1UMeKzBqR92JckycP7ppheauH9oI6cMOVmCKkxBTYt8qTgz8CXQI1/YyQgtBR03f6nj/NWSLcFer5sIfv4BNHYx+uTYt9cGrs/VNj750a+/Gpscemxl4wLXKPi3ynY8lWZLOtLjWputnW5KyS3K0mO1NvnJpewkCytslG/DxmP4GqNEFT1eyLd9C4ekzP9bzRT2v6qeHHPOSuPcbcz9dmWVe7ygZCVBOIhkPpsxzCFzVgV5Wr+OR9cx6YL0iXa3XRm97soeTS0XGgHCt4Sik5QDP87D1Wy135UGBi9l6Fh/mudFUcyCs6wQ0KMDeqrorxwpWEo66KL2VY8PbAuOxlJQXr8DNABj3+4Fb8lBABH5Vs5Zj4J1/36B0T/9+o3ZmkQ4ewOsjHeEFj1VWbxz/frS8ZXjLz0sNLT17OrRE2EfRsoQH/+zk9/lISwM7bpKq8wE5tnyFU2j7TsEgCBkKhIWDwsvdbZ2GDu3D4iENe2aP6bqr76GICMgG3aSAM/KwjnZ+Ifz8/G4rgOAcJVgGfps69JjrSFDTF2GKBS+2Sa9wIYRMmNMOnMumysSRgO0pTfIQODKNfgjdA9y7BoPd65AvT5S4MjKRlP6dESIaqMNEYYiAbBw0B2l+08DhQtKXVWkYxA9+O+kkR0Qw+g00W15U8JY6XS078zD1xxR/BkRAkk9JchreemKbC7Xhg1uHdhZoU9JVfAoy0FIC8oR36gMzgFkDQorbt9IG8Lc3NW2h4ix5Ncy/7mjQ32aq5qRGYKGTP+TqAbP1EkD0nb0tzv34gG28JWV3pB0JXs7swV9C2a/VuzAu5BT5EQAmWfvg2JQ9FMrOhBapLAl/VeUrluxs18eeNjlc25vz5+DTnzxOxWCd0UZypqZPnnxUdrvQ3pvI3CtP7vcrq/4A3uvwLBXIsxcdQnDIqU2OPTY19/2Ss0r4nkIWqtGwk9pRZKJd1z0TO6nAAUg7OwygOeBseywmFd8PUhQHrJlbHbFMWYGgUIjJEZKaReah6MFdNVTuKxKV5QHjupQBLTU0157C8JOLOXcM9KPmIMpia2BY/bEZuKoau6ogxy2siMQ2odF3BUhgYU1YHEE3j6KipRhCFhODR/q48xdT87rZnzeIak4jNfIaa8ok65dKbIWvZLyj1d5XKRkEsodf5eemqmkCndOC9NE+tDM20uzCiu6auF000Fztu6ytTOghmLXneS0T0PSO2FSgGwGeoZg4b8Jv9ojU36KNoKf/SqRPdF3ZF2uqcdbWoNZS2UNNs7tu8MevcyZtXu2DY5RTwcQbNsC2uGjRDSVsYNAN9dAVhEBKAU312unGUMZtRY29qtt0BF2maUiEgQfoRL7ReQ5SZJV8YLlTgBebdE5vLEO+KRWZd/GMhk5Befrde1L2Ov1C/qb5eSPUdsym7WE9uP0sFWlJdeJQ6qQj0uxBNEXqr1VMEVeJQ+Gpj79GViixc8BPul1ePe8DRVP3yfvQkfnk/HvgZq2kp0TzuqfTg455wrAhuYm2qiRJYfFDMeg88qmOHmvPYMhbmDbQBSYLBcvanZg10mdPyqM1Zixnwcwb9xKezJ2pWsQrHA2dt0n0KrcCJr0RSzqBtGRbROFppq9/bjNp4zOKMe1VmJ4AhnLasu3PETxa0VFuTz5NEHxutLu8ieqIVxYJGf3y0kGIx+6DQvSXqkg1ziBZMeJHmy/AChSL0n8XHnIe/ObpOC0dFbK2DSB1qwOpTYkyHKiK1ENmiFFms8SvDzqZvCCLYa44xKaacmlTtmOOtBb79Q0qqgeYVw4oyW/JYKTT5R29TS+KBTuSq9f9R911OrhUY9jlwcXJSYplnJdexontd0E19H8c8eZxn5FpJ1KtOhVPXzpZYGIplPibCRKG5xo9RQ20fiGH8Qk1sQDYJ2SOwKbqmmOnnnExt4ZraNMNiIzXhonXGEDymoLZ6vNJyHccgAPopeWYzUV1RP+l54eSWyrm6TrRnAWYOhKKeeoqHkX/fCsIkURal7MO6zUVs1Y00f59HdmcXYbunhvGVcsgGzk8u0vyyVzPm77ERa+m+MpGH22V62S8pe0V+1SL+RxD5v4pqHTsJ1XobA7dqWx5b42ERiIv69TvzECW7gYJAENGjHnauUZAFG4DGxlGqbQitHzUl7K6RqE399eGGiwnwOcccHerW/7mQS2zpK+CXpU96WIJ4EERJ9CHHgP80AhzNvryWvgClTb3h4xs0UoODAFo5mX9F0ASCBESGUoswfnjx8QLBYlJKRdKnSS1GCK14x8T8husPci4rrEIrNanlhF/8bac2+LWbmFfPDr9GcONdvlc/NR8S4nfd+ZAIKz4kvIoXCW/ci4TcMFAvEuiPmxgRagiESbIXBvQcJUKtrupYZkxoZ0xIsZkxSAbB8PFFSz1KSKF1QT2dPT6FWnoMkEY6e+QR4iFpZvYo0avLhJqcRqcOqm+AaqBiU0MfmRM0CYr1icP6CteGh8X9JC1qo9+/UdFVMqj87FHKZodzDc84jI/4GfBf6Tzl7vnKga1qtDcuDo7ME7rvDqpxRHSYI3E3Cux79j+xgYa2lHhCyf4Ur7kcnt3VFIeroXE0eaZ6cxoWrQ0uwtOrDW3ycGtkBo9ri87BIgNHPeuOIwVpbon4Ekak2j2HPFHjaWxA9YUb8wqKwFoMN9S3Xg9m1qGn8+yiC0iAV8lnaD7v0Cw8YlIHsgnjYgSW7tV+cyIuVcEOLLgL7Cs0T9kqWjWjJoXho56/4QDInqr3AFqJnktkEjyEYEuCD+mFIB4CXa7mKMl+feS8Ll+Uqrh3xYz2lKsbtF5Es5gvgGqafQYghYH+iiZg1bf7XKmoQC54bX8Du8XDXulx6ul8orOodeWmLvggrxnpCC2qWk9HJToJNfD9IQ/bKoF5CwOc8dt10rcj89y3NdfjFyocEHutBB+0nU9UYFAb8Isic3aPYTcT4Zzcl9U8vyF5ZuCqK1gt5iEKEIzTZqExCc1IH+epnv0mciuG1AiXi3COu4SdDOfJfv6mkdTPc2qPXIL4ub8vFGW8sPRXsyQe60EWZqiu3hOWDAp1GIHcOj3qomZG0Gs0ThHMopvDM0Ib62xj7frsK6qvIpy+n89g5ouErSPbN+00fo/Mbxy4dVZrHuYRcbowfPwU19BcC3jGBeEZ4f6SY2LDM8bw24H6wTMuUNwvOtIKVZvjxx2fu+nYPa//8ttfDZQowfUQgyujGa2o8AnDnv2WAFxRdsGg8DY9Lljimb3prN2IyaghTHGLqGGZEkhE+qJeIRaqPNnWLDCtAm8Ry85oO2LfL7EhYpuIVZ/6HBCCgU2PRBc7uElsQRuCHOxtYhW/cwwbQC+AKPbc9Cu8c1apBtd+6/wqzRuIz9AOu1OD7ESDCm6qUy/7uPQ2hk+Vu+YBq1gcqdw6L1pqmSBJCnQ+M8iQzCFjEa+m5Mi28NQb1HkCGrRiG4SQNijQBm23Deo8OjBtd63qPNZW9ctW9cda1ayAaeZUGhQ72MRbN2jGNWjGNQjGUGlGW4JQ5XCoU3XxmVSdKkcuGLhgI6joHHyk4rWUNZ2gGIb5LxttnKpTg98zvK/nuNG5eBv2onOU6rq0DhfCmBoyk3n5GYRWLN+jBbNr5+xYRuGWQTurMwU/7KwEnb5zmP0Onlya5nFjqFPHzKyqHCCldEgz1fk4mb5eFpzKbdgAi4rSeFrKfhcpVT+MFNLiOp4pq69XuAgKbkOX1ytR2O8AHqxTt77O3YMAR7TfEItrrglTrhZTTtrmDmUDaNxipW8DuaoDBWmMQLRAoVIs7r5mlhjPggrPKv1j7sdu0W6NIvBHos5VOo+KnCzCefGaCNSy31D9ZLVelkd6bbyI3XXWrcXKdSNWrqtYWQxseeZ90wbusYF7OSCGXfgphrDkyZ/4+nxI04MH8RwxqmUyrvumpEM2cASf3l3RfA2s5ushCEAOh07zVT+4OzKB9cgWgUBYcckZ8RVI+35oP7ngNX23fD4M5lp7bItO8HpJjdQRXQ83RatXy/VeuUjWIY3ZQ54edNegiKQa0LiZr/pHuMcfsXTcXiXVXWF5Q/nsYL+9dx3hsS/XG9zvj1alPdmPSSGIustG/XgZdYeNwtkEomojr4OHgtVsQ3cLsbluqu24XDh1/eA5VBu9mhqtlox4SEYr6Gh6PAxmgZmTArJSChoaKWjkpKCxkYLWZUeWDDxKRAraEFl83kQNSHISUGgNjklBZ7AEd6ZJQWOqqxQ0pJY4oI/GpKDhdCkolOZWNTGfU3fTBK9T4M7xmKNZyqpS0ATCUgQki9I4e3XE6DZFqnowp1oJM+DCZwe3RMZixHH9QpwB6U5xTujhPPHz2GhD4dNpSEgBJeyMp6zz7yxeFuBBSW7gt6ysdl4KZYnpRO9HJTjIAdB2tswxC4I/h6RiDmVngOAc/1iHKyFOCDL4mMmoYe5OK2VsI7JNLWRpWefm6bi0L/0d69xTBJ1KvPEijvQmHX0iVzCRa2unn1M/OCUHoPgwHPvwFJyB/mMjiG5Qz5ebuRbDXxr/rrVRr4zYLo55ZYzGvTJG8MroYsV97ohXxsjp2MnJd+ldl4ITemUE7RjyAld6ZcQs39IrY7DBDIJzgli6YqToKHjrrTwxRtLpgAFcaeLQOGKM1RGjXFCvOGOMKeAK40lnjBHFWITzSDQZyippWv1DM2ZZUa9gUQKk4JAwSwm8ZQZTvWVG5P2fPy7eycalSc2vwbhgPMjLa9TAbG2QHRboiqackKCUBDPTszPT05n5RI/XN8aLPEpOZcSKRr8QwTdxACMzSfc+3Etjc3wG+V7zxkCe1QOPRqkBEQ98K1l3vXn7wwHmaFPV3DLo4cRrRTogjrOSuMEKlG7c6wUQ38UquAAnoG74bsQ5uTLjFG/mYbkryn4ADYBvUr1Gt+mGG7YqsteiwxVhSRP8Of/oqgW92DyzguZZrSuARz+pa16csmUQz9imdGGUwnvJprg2atI82iPHu009QwuxjJqDfVtnG3Wq8Xw+KoUDGy5lFau9VeIyTiFTWZZFCaIUDmI4VPFCFh2pKazWgcJn7Og1Ru9ZNCjFcVODMsgRwb6Co2nIjQ29rpEv8utQL16EkKTKuRRPZb244mnmhBp652JZBWZQ5sLPHkgVC3gm80SNkJgHzH7f6STv4ZTWGjvlwS5ySfVKIdMFGsyqg2SAH8CFZx6aVTTAvJVxWNDdfRtj3sFgOALRC9xWyc3cbp86kNn2jHi4sR/O09twnlbdxikYzb7C4UvH4MuwAt+wcsQZGmir+5sFMEO9SnLPjmuMcXXd4YbPDRSzivmDeVcgQbGgtVxhtf2c5WbNcp0LJVbxyPOwV4ebuiMoBdelq/ksLSCZsQsNmNMGpCrUagJtM2rKjRq3I2CQFpF1IK9DMEaCQ4rHSLCDhUy4DoXDvFOFUBEaB9MdU3I47mA6OEXX0qEjviGFJ3QtHU4jvnrBYSviG6K7SnyjCeLbMcS3R70q8e2IR+nOOPHl/gMQTHxD49G5qWe+M9QQUafeJCi2gUKsUUOFw5qlWWaBqL9YpqaavHG5bPIxLqFvyaIqwIlHhWC1jIJMYLu0QKMkWK3ifs6wA5eqtBXTsjzIWXZS06a7ZWQaLOHQUEoo5mCPScglzbGtqYN5JjsMpvSveGme0E7gNtEOPJgCiUuCeTgJaBJxQCeAT7m4sbm+AIJL5mKWMkZ3TLNZSiTUpXnGSUwUY8OBRS0kGK53fJj+5h3GOYfFHYezIef24LyzzXmPYrxmlJQu8LqhFlyidWcTnsLbhrRgdkYQrunEy9CeLh5dasJRAq8CcrPLpxTXCzI8Msqh7pZTgrcE3V3FnrBC8JOikA3mgZvv+Y0X7f3P9182rDq5hJxxmO8u0fPuS4ca1rYVPPNOEyDnvhKWBKpdp9MK4JYhvEKhk5bnZ6hgfA8t62DImCzrmJxJ2/GYp214bKM+Hjkt4dGnFh4truRVzxb/MK++Ij+rQoaNl6YW7aBYiVmXdoAPXOJlstjJcHXdUkJT0vtMDwiyLe7Vb+Mi57RIqCxyRQvgIwG0nDEtkdOyvhDNLi2YzS4GmYcpz5vlutyUddmIQausgFLUKilNhJRirBaUhtomyFXZ7VzzHqGmAw5I9TyruXWUSc0Qc0jNKxB1oBqUE2oDOsMSjRivZ6uHOY72tfvUlGYWwEv1o2jPfpDivkFpToNQFgyj/STNPkt86/ZQY89d48uj0akhepa+ymZGZZzz3C8uumyZTeVe9UU4UGBi8PRQkfNRam9uSJshVrqdQiMdgKAaYuiOzEuovWHyaKOhh422op3glfE1aCny68KTUldzdnVgTxew8quBadG5pmj38y6KJw6Ejid6ha7SKVh5Jzge0m7apZSiPlwfysGPoV1dYyiVGM/Il7E9M18QSHQdagHOKVcw92hRi+lbhe+b035zjmXOrIV13CDfNgSwtuQhGZfcxIZwTkChixDaQOrRjk6junZ4kf+r3ynEcX0I8w6hZltSdhMM3hkYg/Wh7HxKiNWOraPcYUXCTuFQmriu90jynnGGSYVyHA2nlfRJn3WjJvW7ei+6srQdQPLODfPEgVpfLOuJvNrXAxSE7AEKBSBgwYhBeHzItNeoW+HtIA6eIii9nrSYF2oxRvung4Def8JZkYnJ/kCZWY58zyff/cma6Ju4DknzA1C7CDqvYH8H70Y+roUfZ13Rzz6BAsoGPvbWZZ9UPY/jkWhb+GY3prsza/bVP1jUFfz2BN4nf5gnQnIjtKGBR62AhqSb8VX9QbGL4Aacp2vDqmWTp3exmBfXW28Z+3/KZxG+IWems9wyVYqDsuaz8wUXAz+AdfhRjY1Yt46TfopwCj/PDyErELg29WVdz4eK1ClcuyBbFkhxYAXiR+mdwwKrO/9d03/YLxrYx/BVZy2dcfPnj6Ks9RE/1fYifySGKpy7qQhf1jgFLcT3c5RJuznM/ZRlSWuIsb3Cq27RtMxEywxRJhnXX5H6e+cCo3xJq9DiURFFXBzs77gmAxICVJmoeN2ywbSEHXJES5gWY3DVI7ZFqGm0KC1r00PB1lg5TaRiXytP0L4EBEuU0VWbI+GTxVyoUEuVYFOZvUn1arMo0/MPqEkB6tO6pl+e8MEQLxpXusf5kufDvIHK963KNfmjp4SqemWk/95oWhGNirjDkVf96t6JEmEu5HY4stPb0Zrt2GThDOrbCyNg4WcoTxi5ZPrgKq4EGSmxh6k0Q4OaqN+up//B2GmCzpJOK7g/qpq/hAVo8pkq1mC/tfCBG/yTuDyi4Um1zYKf6wVejnLJfx16yag6qMq6ofDqZNdS6yjwRIy3KVZ+oD5nhGVuC5QnU0V1/oSozt38FrFsAzSIfyoI4lMs+8SGVqLXyuPKPjE2tVN84t0iN5Z3i77bLfrkb7lbjHm36PMUcBSg3DCC5viOU1hfp7prrrblqLlvUy+NsQK9JnuNk3vJpPHfw4dTpwCP+gg8GoBHvQKPuoVH/cTwqFP91OFRZ3g03O4ZpMyUlBwbolH+xKYP8AtlFz/kXqTf94QrQCfmpu+ZvqjlB5ytogr9qZOoQp8m91DFILmxogiNOzVNh3VWVDbTtwZbaaO7O+aBVSqHhCtiJsOxMhoXXmniIn5dG0CXGBfKruM3DgrhqagyB6rK3PKhaPkp5hE8lo+TrwdcnEiBMA+fRAqFykSwrmqk+u7/QxWZAcngVOsMtU60d1RPPoC092UvgmBO1iT5LkLuira8nIlVteU9oy3vrDB4UjYe7qp19mk5ltb7Q5FwS0hDXWpAYEyP/k+UqbmwqnAqA6fFVm0MTFzZSJ0yrPBmUGb95Lgy7H3TlWGVxUsmlLY/dOqayEAB1UTW4ZzUREYe5Q6dMrIOcKAD7JSR/3BUGdnOgtjMggjzYEItWe88xHYsgRmxNaMfV5STwxMpJ8ccFZSX8Fuqo5zoI8RD0rJ7T6ic/EdIfYxK+n88rqSPzpRK+ngZU9LfP01Jv8A0YERZfQya+qoRrcNY1YhGS1Qj+rH17H8+2p7tLXsWZn+Kj78GPfmu6q7s8VjSKEJjS0PsrWBd4I+cgrmbk64RPduIF3mhzHfdewf2Umh5L01uhcrT1yfO9tYwDTDj+PAgEMw2CRRhIul79meqLCgETMXg6R31IOVtUlf4re9Uje7n62KuclPrKxLTx6MIGix1VdWGepxsfhIEd6uFyr0q4m2pcovALaWWYRsL8GxCwQJRPAEsm5SYq6rYTsEmbz5DkTm08qgtg4xk82AnaDA1Zgz4zuAxQx2wiKpZG1IdSg0tAKOFXqqrZV+rhINJmKb90WuLmDLmI9vYpEmf5yhUN5SIFvWbeYFJUSf5gGZWi/RgYZQ7utSiLvOfC8jYObiaL4qsO8XrEgtjewKMYhtXLFmpxZZ6ltFP6nByA1z+V/juxfV5n/u5cJDLhI94qqOA6GC+nZYB6h3oD7XFMcVqYeC000YeHPz3VY1qSlRtEJt34oK+WrtSxMmhZC0KmoW7igRvz+sXLEXVrDGhkcv6sltYBK4qVXj1FQtrlHAkzT1vmQgiHBmelNpXshInzwAdAjw7cpZZcD/0Iq5Hu6H2TEvcfj6Myf5cZy7ggeJ7FNGuNQxkA7cBpFhM5pkTDzZ0NKll3BUAuihrcaSsla3LumEq4kCgqNiZcD/lUShnk/NLnfPuzPnJk0DKjatNKzeeegSmKKfojd2fAhq7JF14dlKEQWzQDiAC4Q0m17ZjGI17m0Bn5xWe9yqMiBH9oD+uN0WEBoQkDw8N8Ox10BCdDMlHc3yUNJ35q40zf0fhite3Sph7DxZR9Rr/3X7h7uicAyC4WyNWM1R1m7IixqNb1Lkf+imq9owuWs0yVHICNsjgTiMCoSeK1MxVHQYAj9dexLdAB+HLIfShSAwT7JbQORzqqYlOVACj0YylnqWVYMfEykD2V7LMJKKsKGqtCeSAGeoHoPG1jpWe8qDsFuARZXfjkAe8AGJRmrG8w0l/bZC4LgsCHsZuT6AWYzSMvWQi18sDStQKTUMuBARoBnGAY80HKiDUj9C8iLRi1WoEjPYahuIk/qFfON0/tNqfrXrbva6Ihdo5b7tXO2+7r3jc3na/MGpwI64aYzVQ/NxUi6l1ucs7YpK17kyy1idNsrp0SQUgH3U1wOTOavnJ5515VoZC9jfOPGtdxlbNL2Dck+w9ajNVtF3RQM2n2qCwxXoflnnwt2qMdQRnInfFbdQYa8hNu1sKjtQRGbLndX5SOGqMNXaqhT/djCD0XLkxcGrUxz23g1PvcGPGQD/mjIFqkuwiPo6gE3zqvooFLUAqkHfDIHGfuuhYJlMVU55iXhLlar0Pk4bKGYSl+eoaQs1KuXwh27RAyqGQv2LOL2VLQ5SeW2NT3zVKQUdaJZ3BgZO6HMOHhQfTlJK3kLtiDeS/QA7G2lh+sCZhjUAaV7GC5L3qK4BaeUwdYwJCuBYUrnJKS9itmQZ3b708pUMjUWprUH+Z6OHOgs+5AvoxKunlcjOaXUPG/XqQixbsyRcHHmSccjy4Ta6kL8vGj2F/SJS9F6g3iDl/H0cwsrL1wRz4eQ15+W87F73MrcKXHaXhzCms0PZBIuwBSstjrmZGqSL5tJOz1ZkxhS+kvXxJ5hhmCF6IX+62Lxm/rOuL3qU54tEOreCRJtMzMqjPtEO21/D9T0Q+7iZyFF7VbT6u4RhWwMqNPW4wDr2kFzNy577G8dxob1XZHfANreeWq/oyB7XvO/B2UPzmxzgWkh7toGWKVx9bp3CiNNEpQO3R98tqIcXCfdNOnZ98XiyjElcA5iqQ4mGjXEtGscF4sT0U26MlhViSb+OSlhRi84wnEEDPIsssdfFdV/CxALVJZTq0A2whPKDcc3JPQN7O4ynXIPKcuIGkptoopxjPonjkCx4Vj/yTp/3OCZtanQmZcjo+NJxRXytIGQptP50sPKcKFdkFWAw8g5AkoNzFIdAjBtZL5HrOLvL4VeDGAXBW6FBEbXTkAju5WeUZ7/sBVY7aRw0OZXeKQ4tdEK3Trmv6kIKJFCKkuowKiJLn7ML8Ox+Ky5WtFjap1e1WSKEyEHmEV2VcVnE/wvkRMTUou/YznhdVDCbGuobU1ZRXdG5N/M0JNYQ4AiS0iaGsGlFsiiJ/45sRPLf2Xtwd+Kp3PV51aeFHnP1t1bxiXJpXjPGqhjFgXjFGhDOviBfYvB41r3glbAPeY80rxoPPW5NaMTKEMtxqNEitEUk3sgetyVWS6hgcE9YW/+4xWFv8384i4gfSmKVs7GGviSve5eUlr8I4D7CLBlUXDpkN61e1EK8bfX2hZrramcB/vlpW1FvYYuEqj+WZ5HUg3yVAEZEt3IVn3drsj43NfvhasBYXl1VEeLcIoHlKy/PzXp5QBG6Cr3WLf1aRg4ljuQjXqbN/xLcmq/20oTkwBz8knG2zYlc9RfSmRLdwrAYz6NRWI8hO4UIsYfaLGROxm9dBPeU6+PPqmqFIs39C1aJ8VGTrNHPgt5924/e8Y/2zXMcspaWl96Hs3zf1EGCaxtCBb73yI79+/454P0v/57KH5L58or0jGNRGYa7585oDXEd3s2iblKtwl17v425yD9vDoq3SAVzO3Tzwyu5PffNn/vst1VqLheG6623b1sB6A+3JaBx+ObaaQtYMmSEcyErfmPXilgzdZylsgx8tFinbeHulxuZGkVGb3Uz2Sdz5dDeHDPiM+H1haDsCVj1vKhMjg4A91NjgsIUzrtx1XS6KzsBJzAvU2+RDxp4YIl/AK9Br61dcn/vWQZPflkvM3piNQDivFU+DnnKQD8suRc0DZvfcYkqEWZ5FNx7UQfNn5QR8joPZl1G19E4vX2UI+ZAa8h0rXwVXkjiAzAgE+gCeaxy4DgGm1rjvfqx2JVqKlnNnB0n2g4csXlywCmg4NdmN7BeQRhHS0KdfeCPkiu8XLK0J+b0ceygIpIP9SlqtPB4fYaEfvO5N+OZnKt88v/zmqtFvpA/asppuSP1sU1sgr4Pvf+N4WVSW1Ruvf9BTO2N8lbCuQlgpMhwt8nff8FiKVECKdqcrENQ++4HXupL2liXtmSgJ7iwj7BVkf599BVjAwc8jAomDe16Dhv2YmhPQlOyfzfpXs74QphMX6lCQ/YtsfDEI3phNyc9Psyk5EYvFETJllUBPsZGNnaPYmvyS7hPdjuxXvJEv3AGgh7khZm6dkUXEfn5q7H0uVq00SuwnpsbeM7WED03Ne/dEXi/7UXUE6LtOYCo7GPyL7ye80LnVG2vmqE29IpKwkhe1jKz3BUuTUnms81z3v1jQ5HIG2Ni6LadnN49m5wjHR7CQSJ46jCqUtbJ2+BramibKF23PRGpXRwSu/kTs9MEnD+LavkSBO9LNu+TXz2bkizohc4rMRaufYwMeEQdgZaWJAKiiluURlkXtm9ytTE212p4mOsl/qaudCR26GVOSN3AjOkOXLRTApY32K03vDfyKrygacWNthFpydbfqIplr0BsmnrCsxtLHw0CCC/3vPJW8j9iTmudDPJWVPtBhCiM8waqbO5kRDlDcPsADdasqVrhDdl+LK5UIhqUOwvqBQ8s746++5xnHRJljC+V1LZv89WJUEYHcK9yyqi57orrsFSUOSlzNRykZV2evk0f8xzsLL3VtntaaXHAghgZKBA8y3N/vfOsv/8Oe7/w7Bpte/QrKg3ny0++eTlpIF00mixiDkpv7Kt5Q76jxVhBVjJKqroPRqxKj17cD6MOlWg+KcmK5ePBOb1VZO2H0dEW+CRKovM6puiEAx8eoEWeHxAleom3DXkZloSF+5BZLUhrfw0THeLh7zrD1gBQ9GoIWWMqIhhM53XghDWdHGZgJCHTEmqneZT5KrY2HgzxLpSZcZ85kwoNMzJpabXMTmqWm3MCeNUYRiQNX4qLATWi/ZC+aUhK4Jnu+BAVkBEEcuQpIgdpQNHUnD9rXDGXrIUc8eDP4ZsSiRoWcNuWQTUBtkvZ6dDKfxb0XbeoNutV6mfoxC4tM8oq9allXIExS5V6OtvfCqQaZOlo4K7HYE3dXRew5swm2e91NRNZWaRmNab37zAgpsH+gPg58La0LaMuISeewOMNSIvlcrMjGlYXWhlKHQaIXkeQYDac9mbUAr2FV39T96Cvw8zLgF/iC2PbjAg66uuFSJQZN28OPENeJIHzsPvclxcIltcuh0IhzgeuuL9rwEC+1dxALXfc+XMkj3DkIT/IxLqdDUznOXiPDXtMqecDtVqhrGMUYBrHaa3nH6JarbVJ0gdrZl9FlVTH8EsMjNtYtVa1cPlVc6OAS25ziYlsxM0uNxjcKqmANaWFudq+sZjdrG43NtRWEzvTDiwLCjFB8SRRfBJ4wbSEDpBRArwguag9VYGruxyxV40CaJmb7h6waTahWhzvPVggAUbeaq5JTp7NcHVlVHDWTs1iwU6qLAmeArV0BBYcqarAjywGopc55UZ5XpFhwolnGwo28laLhFyjazzB2qtMXLLtmg6FfIzrD1M3sRDZ3wKSbHTsWpReQGd05zGPqLSlWLeIhAMBB4qVFplcP5/C2Dz8XFOkqiAEmoNRAKcILMod8Q3qEc2kDo4EyCfKlkCincjcRsMO3/DCfTeTOkDvT3IxOGHJu7bzKcnRdCHVdmLLxaphNV9tsujIgott0YY6NI1KsqCl0X5lDTNDR16a+vuY1+pqMvtZHXtFCsxCtqJHLT+KFubh3fvImlv8nUpWXHonDkFmc8Eav6tIr1E/1fqUMUWTmbGQ3d5HZ3BmsD5HTkx169vBrNeZQBmWNd6igS3zpgEBn4u1/98CsdBwBYU1IHEkOSZOSgTlmFQrvZoVCMerhrlPKmhe5r1K9i70KNfGqn4lhWcSwcqkyrfBOqdU9PiQWY3UlAatYyZPgwAsOqzLJgpMZIcEg/2vmAmnbnn20cG4yo1d369TazBujRpeyqVdGO31qbORNylwfUW0e4exktJ8RRA4jneRPXe+kP3k02kl3rEJ1moFN9KySnJUn/ZULyZGMvxjixTJfOjxKJIQTYn4SrwstQF4OpiAdzG55vXMG+VqEQeRFpAjotM1epOoYCERiRZMVGyaTD1SSL59M3ldJvnQy+ZxK8t5qMoUVf2Dv8Er3Ptnr0PBJKyEUaMoJLIO4TKdkDYRCzXwKFkDuioJQLICMHRca741hldF37ri40E2nUQzVcSPc+0c4ZhzZE8gNfsuzB5M8e4SL/+4m07HhGNceUDDJnwcKAmPpxIkSi6hiP6Ou8K00TQ7VEnF95432d8t+etV+Nmi8b40T9q3xOPoWWcsTCbAhIe2QszxRR7a6szwx2k9nh+LruqfYkUlfi4QPnmV+J1vZbLjb9+KplpwCpzTqNj6Fqtap21Rjd75OkYx+oqsbyC/HJWCMEqNQh8KMqqjopWavV8IzVoWaUo+tj5q6VhPpSVFsmagCBqOsswzzqR6n+KV/huywVFBHI+qlr9bR6oq67BT1jo6nah3GD0ugmq1oqq7VVWtF1wjpUU02X1iuIij1H1TSyhaE9eKXgJlRq9zFqUYk2uk7DT60HtqTTsXpP3v+CUxhv+H11Rti2PtwNdoxcEmAtjMKTh6rPRWeSk5CYxz7SOBF1VGfps9ulL8j2S7GI/rsER/lcOyV6t8MWknaBj0RlHkSqh6wWocaaUOkWu3OYrsPXIUFZnOtr7TAHJUWmGPVav+bm0ul55F66yevF8pDaPmoZnvM1Ptg7hkRPYqksKLTHqO5VZ12Fe5VDTOHUqoAFg9Jy/72ZqfTHqtOeyQDpUdkQVUT+u+Qt5a+7gm+F8GLJTpCAQeq9yF+5PUnvg/xGBXrn+R50/VzYT8ku0MRVpVxDYp/rhWGci0xuWEqIurmIzScrU6wCndV59fE+CboYhKBuFKDTzsQ01s1nvypjvMZ0CMKYfZVHFO+9CU5XrFdMI6c3XUb0XtiYcHWIjy4L34heArIJozWUA6MPvUTNxEBuVPOV/AhZ6UFo50MbcpX87ZLaaGdKRtBdlFNzM/qMiSMPgTJ2iR0a4Zm+IZu9YZWNtWSR3PCkkfTNVCMjlBzmPNP9ZyNZuRG0qxWlzflJKxyI2nG3kiaOfGNJG4kn0k23Y2kJjW3vJE0wzeSmil1pt7QyuRDd0OrM3lDa0b635l+Q6uqljWrmdwNrZPDozMCj1nAo1OBR8fCo3NieHSoc+rw6DA8ZiuC2Bmard7QwqcTHENTkAlTZX0Ix9tX47jR6Taa0IH96xD7D/mcmc2dq5P1tpWvom/qVWazqJ9A/D1pZwPBmccp/AZebyX8nrHCb39U+O1eybcsWDbJgmVV4Xc2Lvz2Gb78xxRmpgLzaa3hDJQyYkt7vOncYofqDl3hF6XC/nsjUPGIU22rO5OtZkQDLmzJODJKTbZQLrTj7Kazvq5IMEtt1yCqDx0s4Pt9vXwd0Xhl5NDVtNKZvKkmaPLYkO1ks7DJu6VopnW+bNMCAtkOcWvcZHgIVgQ2h2hUIgxkwgIN4dNUzWig1hHU8ZVg4RXjFibvC72oesPVrHBYJILx26whhWIZbvI2a/zob7MGyo7BptTo7c1QaENQvc0aVmhDaGlDeGLawI099dubod5mjabSynjsNms0SStDtQpw8tusgWZytPLk8IhG4BGMW4GKNOFUbEGdOjxgCyqozNuQglO5zao8mdsh/8JlwxekZ8oGmawbU3VCBNb5v8BC0zNeOvCyN4ELSp9wF0Aq0sW0qPJ5bzwxnzfpFkQZ0epNyAcRsbVbkLf5XuPUbj4WIW+3nA8W3918rHhg8cc9sHiwW6z8P2THdSenTCiECCe2PSdXWSQMvZabNyxfH1Nk+Xof+1S0n3y9maCA0V2DRw3dE0bIII8QD0nL/uVmd6MxmLjR+EEF371ZUL8xGHEHHGmeYD+OkNE4D9fn6upbL5E9Cpqqm0e3B5N9V3MmjuOa5wdharUtC7ulQzi1Jo3N7eOmeeepGWFR1141+dGKppdgvtAjh0CRMDZxRVtjXD3FjBzRU9tU0FQIAXr2Y2+sSelEk2QXpU3iOrWwGgrT1qaa5PKa0keaS9BFCF0L5KMwVWhWeqrYWO2k66Y30c242k3TNiid5p7w93qD2dTZkiZ4aJ/TRxA9B9cpTUxcokY4HREpxdVQzc6diXP+IqC02nEAwkE00LwJ+IFyDBLXs5btazr6TVq5RtqaMlLB2EgJDYH2vxAHva8KUJOfvRmUpuVjKJuDpW8RuIV6JcWIlt+CHFoEXr/PfRCrmp3QTR8PyfBW0bcReKiBuxuuHx3TBh6d6pii7ptwBoewBVk2Mb7NKWjsgVtSC5YZHpPwrlWrky90PPHh1DE3sRzKJJvmHms3zVQqT3EaIs+AEtf2CsammLFNJM2OdSvUIie61aTMnPlr7c1q7fbTrNItbXmoH052C7GhdmtWs6Hl4w2mGVc5uDLTvYDq07uFRoz3KNmiR6k0geraI/14rEfJlB4l5sOpPUpsj5BN+4+2TvZIy8A2SXuk1Y/1SPs0MUoK+unEZTbvYG6kAlStBT2uYocdEb9KL9PqYKEUTnb5ZydKsWXzr7D6qhhS0w9SR70Ax4nZk249e2rV2TM+0fDpxOzRyvDhJJq5OWVBURuZPenooHD+6uwxpKdIhTXCrVZ3SI4I94YeMPXRHUloKNMR0eFB5XrUaKK/H9Gwx3oQnK3Y4fTl6kLLkq8m5/oB+TgWUhTCNpNnI5+lBF4uIPAg4Yn7uBhP/RZQUvZQvs1VoiStcHuYPw5j9Zqmf2iICmjJry5deV25dF0uE41V5yOjJDBVLKxTQ2CRJ2iOLuXgkvCIRtdcW0Q8SQrLD4FViY6plO1WQUMRE8eSkDTdNZJSKdFDHrBqmqmp5sAjCsbaYj/T7bzFkmRawa4j7gutxnzo4OW6OvHFSOO1TeHYR8HER6ZFoa0mGP1CGxqOdiXRroSVrgRjXUlGuxJMjpo/1pWg+oVh6PXDNL3HCyLBq8omBkgcaFhXXjVYGZE5ZBBUV9MiRd0iVYKYidqi3Ad/i1pXrZUIiGVQTe4D7+Q7rHA+7oI1RkoQM0f8me696oIbEd4jisWYqTZUxcpDLwhOoSfagxCN0HUwcta7/CnwCuXCmuH7a2DclbwUddzGwgyeaHKdIjQVn1I40sbP+F7k2me4/SIEvx8N/MslKiJ+fznTslXRBlAFm5jN5w38F+WhtgXC7+wHhWyEyBWWVsrJE5W0tyENx5phRRsZX6vzF53M5rDN+a+qTeBXSOYyVV0fAS7HZD8kpaNvzk83Wi5dUEY8RkOFJKiYWb/Nfhhf6jX4uhQt13lLn5qxrU7P77Ae63bIdiiWslHTt+D4UU3Z1dXShfqS/SU/8OV0AfWO7gbcbIOUR9pZWRYUX7TlceGTWl2SGEJ2FOVAo/fkFZ0kFQ0ezaJAkYJqmsttvlyllUyEFN3Ciqd0tzkF9McrKurVqsYrKOJKFSi/1OzS2WbFFQp4kH+9Mpb+hh9gkQlvpMDtGauwyxkDBEjwc5fXdRbixCyQURtBqQi1g96uqggNh8N6qBugGdoRl9mAFQOgahrTc2lPfM1VNPhd8cK3PnDM+ZBSeQu8QFsaTzZwtDlFMloVagHwTB1pOaHwMOADVLWyUPG3cUktTP8gCUKRCAy8PPCnbPJn4iga2+L7OoR62m4b4k+svqEzsQUUGXid6UVUeQPyxza/icS4imCRQSemqSF2FwHtx+FYm6KJNuERmjapb3HHCah6j6a53Kb8kQYL/xDYNrivlLpErrPK+o/yQOONdT31qj3V1ikPpMd4eqhrKlUexnOXO2LHtLpuITFxiSa3FuW4LFeDyx4KfcbkjKo9ByQcUH3Nm9gjZu2v61ndLWMj30RaTagdmRwsf3KwTrjPH0WxUFvhj0I9rMqQlCXYGr88J/LwK9B2zfIVoA7WrlcmCRFuZFDCRLYwlZ4UsWUIICoVW9aJ0bkPSShCywHUXK71q+tgigmsa6/wMb4ObiB8jLD28h3mXQA+JhopoW35lgCbx5bwtpCKciuwEoIucfsYvikyQfpjiJUvNtc8NRggX6dv9f1Q72n7utz6zBrA4SpXj1fPDJGHtqoHkkJE0uNGTUly4GWQVNdBbrzJWMSjWTXWsXyYOgoVTSxneMEN88jPA1OvtiKSt2hKK/xTa0WipN92RRnC9O0Vvi9QkFTQlAIDHmlh4Y/Q1XDKelnUUYt0y8+NKFhN6lCSe6RF3rhlkXVZ0tWvMAd+wfejE42WGoRm6OSxHTlMJkCJ20X+txrdlDqQfAxyiPNG4/g4Mk5d5tGWVcfQ7Q7Hx9CuKoWHMfTQvkDap+AFfkurghO0KpjWKsbfLVrW0HG13dFNYPqjHuunka+ML1DJ7EPUQkkFbpiz8iH3KjSWZxSAEQHmEKaCWvDDrDGEjJU2IyLhz0fZNx5vbGCEQcXAmG3Tc0SZKf25Uzf/eLxW2n98/2c/vm3S/KPkmbD/+D7Oy6C87X2fbTnrj7e+vmr90er6RKrts4Uz+sHdN75ILMl8bZ3S3/b6E9l9vB2ptfS/PBbriG/Ht1XriOiNM4+It3H7iIOplh/x4eM0/YgRrJoqRJHWVuHfLSdt49reY7X91o3RK625dc9dT0RNua6geWQxAUfW2h6WQGa2T7jWTfxzwCiwFw2V3SEqTynA3Wzk0dS8JX5KqzFtjlnRmEG8JkvdqiSpegTii446lb9RbADJFpk6m3k27jdrVjYks1Qb8ZuVOb9ZgqCwiSAGqnVHqhr2c/D4As8fyrHNm9shCxVNGlWidBGZ3FKqYdFeEKYIl11wVWM9z1KtCY3JhlDPUf1kNRQzR13ni4Jm1UexulTpIIOybxATzqBpi4xoYz1Va0RWkU23LTCoVFOZX30PIoxVJepZFigDxi7xe/jyEQDVoRpmgISmZ65xWdWJvoM3ueC1fW2SiTh+2RCAMep2KPqCKS2ZtS3pXL+59SULzpfCLfOefBselC9TZhL6J61i5RSrWEm50H+Rg/3MwNtXhd5iO4rv0zLN0rbhOoYx45dttIKXbciT5TU8YDt0MZ+n7WLCcJ5mBRfWgQtDzl8rX9ZlqIEZjDh4lBjpzBqiq+LIVQc1kyGtXPvg6NnK5SuXxvE0O9zACHLLPdourVLRUCaNGI46C7AtQNW+7mvH6iGxqb5tvJZtR20tNbw5B9WA0WS1d9Ls0eFkhejrIm1X5606z3cMIpjD0ilJOtW7gPBKnnN7dsjZe11O73bggqEgwE7YIYGRaDi1kSTaAf6lOJjvQuj6fDd1qUA9+Wm0k0Mhh07nGXQG/+3B1hrEXtHcPosz2drRVRQQnpyDcjoDjSusSarrKChtVV3N/dgj/ZCY4kw6ExaYziLJbF/P5vYVqoMKVyxztKAFcvW18Dq5cKnhqzmccfoOznHjSzmH5PMl7SrJp+H9kq9LliMQ2vNINz8HtyrH4s6lAP6wcqt0yxwv4+DZ+ZkyTjWxb3Umncs2pGA+KuU3n9/P4XfykWhi1dNVhwu5zxR2DIWBeNJZ+ZkEDLYuhwordNuNQTmdTgcwtLPaFS5T+6u9UbtV1rbWadUOnVLj0VgeNtf8R93ylHaJVyZGGxWI7ZR7rBijmmu8GznEuU7I2I92YqcbQynHV98o2n0ux4xstRxewSbK+fod4x0q0z2D3/IzaA82hHtouxXk7VBzwTuoZ3xp4QabgLUDcKDbXB5Rx92/nK1QIFgTG9hbA2dK08S9TNX6WEY1tHbeWCrjlZvrBmxWsfQK1dE7abapPbz1KLXIuag+qRbBky1WL3wJEVIK06aasGwjya0yuTWRLNQs75plWQ0ZhvipiTmiO7M3ySq+Q5befLeOG8Opa28BbrfTpqsOPLswWQiStWg8zgmXRaB4KHk72rLzINZ/1DZBFmUgiBbhMi3Cl7tA/QJg+hm0QwenoD1yMVjdg3bxReEckWViTLfLKNCRARHDzBgPv/QWNbqgzYPIz7sb1p0RlKGdiNspiFOcoXHSQB1J2oFKjD8rMFmr0kU858wVCJqbWEpOh03nHCXmtNuO7/ZymLZPH6ZCYLtDIX2GGYou6b3qsREr5nSAdByI/3bbsciBS/hm8cRjoV3KiVbzXVJ+vt2sQttpD83Zsdj1NRuLHZWxmDNjcQbGYg/i9micNFBnH83l89KMM1Ryhf7BuvUZdiB2SE0oY6QmQgzRbpS6W2+8KojMcCxuNWtSBajhYQ8UO8p5sFPnQYFpsweJaqUTy3iHsXeBn3MOYmdQATrz8jWaYyYQOdHQhdwH6AA2wGt0V4Aru7VqJxZop3VEms+NUBJ0Zo/aL92Dfuyp9CNAQeZk/C89z99qE/6cwi/PO68i35WgyfsryQcmky+oJO+bTN5TST6nmoydpN7AFes/en9cIrPV0j7JO15fMdjvCgpHCxpkzkLTudXLOXaUUayRoIuXMbt5Tb8yFzdvjF/Jluxfye6S7B50PShNnJTqkYNjfC5LeoxznyfBRG9XI9gQnWqcaj8b6glXviRHsx7gBQsdwWrYNsY4fDU+0DFMWp4Rnrg7gXMhE80zXHi7mJSTmxfuLp7CH3aFP4wJT5zk4Lu9/MQXRNPMdi5wSsY58KwNdJ+RqjvbDPzhPPh3BLpIpFa+RO28Rx5Mzpq+1wb3gYyQR4swo5ovs0W8vK8wUpYbe/Rt1IedVO0LBs48Aa8a9QG6oj94KBCZ7Uy+Qkv5durB8aWhvX1bIYkH1a5WgBcyfAL1tQLaKRFfMJZWQekyfDJPxAGbeSKbNiLvS5sK9Eragtq3o3ZXIWpHU772tfNO5DqYtd2BB9vmZalesaKtWkGL8A3HRjBlmpNtFL4wjcVXy5yjbqzU8krEdcxCtCBjQzi7wNfC2tfK9uW0HW9jTQRXs3OA0c24BC/nzqGRKyBBK4PAwKsoW1YwNnDwQW2c8H+YPHvRT7EAu5ML2W78m/ZRW55TX7lChyhE8r6LdqEhaBzaJKAVKCLLsuy9xk3sbkeDVwAW04JjpgUkLZC+cB5AFv0oAPrCgn5pcChYzbFbx7NH2+QJJ8OLg4Dto2A1DYy6xJVWQsJp3O/mFVhL8j62+xMTCdCZmIna3SO+mbSHbOBBzwTu88oJtjKozC9u/U5ZN1Z4gvHMc5MsKyfZToCBeETyPn+6k6CCQRirjCfrjODBcl5wCbViWa1ASzatoa9YJTWR1NSlvkWTHbTTVEi1MWQBi4R8GfJpclYmZ0Ro03a0CYNAIjSuc2XbBaGomGhHzbSjv1U7Bi98wprSB4i0KcuYcjVLCLQpZJqyXdAczfTy5WA/ADh9lu2ozDI6ySzjT8dnms6yZcSBSqgBb2ow2ibchnpO1P8/Y+ap0WrML2RexFlEP1+ExpzdvfWp+Ty3OuV2UmHrADZqnpgOizHvneVc6IL/opxy6qILO0G0+4CMpLJjEYV9sSBEHMu0JJxGXU3Iu8QAoDkk76Z5k3ser6dxrObBtvk60O0jNyr7qnhQmaV9wdlZLSen+Qm6Ws4zHfVZ6U7Xjr7DPIzp9i3H1I1n5sZzbMhobLAQt11yztO8GenMjvSOciQ9g/mof/qI6mimFAnrQjEmmsgKNFzjcCY+U4oZCq3Vs/XAsqUf9Xw4XR10cmbiRi6FuWDogpEo74gp6LVNsnmuZvu8wyKEj2MfHLJfdZspt/tv1BvuIyaDrblgJzU0d5W+cNkGRQdu2XzKX/79X17y9OGB//6K3/2hs3/E50pKqa1+CdsS6+mvJGHzRu/V6IY14wwzEu4Ig9T68Uoe2Avy4HcR7hXR4F54IzDqAHoIU8ejpdf0MjnHGDz8bvg6OPIek7VbNLN3gjOGiecErKb6pcVmMYcXuZR9kqjGsJofUDP3wR4TJg73TJhHC19yi9RNbUt9W1RTp3ylpelXak28LRIK/Th19zV51FlkXnQoEAkR3nrUkduVlLEwv7NR5qVOxQWtXn0NarXrnmEE+b7cS8fq28ln9CzikMd/nF65tCzHkTD8XLkbzGLiGTWtyag4Yt5uBjY+7/GLDkTLMlZciYZ2aygq/RK3sh8T7eUZGUyauTjQfHCBUb2gqluPNnrN1VEbHc7kQAaXYIuZSodnqh2eGe+waY72eSbvjPV5ZrTPuLZeuR/Ofe5gmy2wcT3OTY85UQAiHVeUqjldbVj1bimWWgTFEXZCE8h4AjysVfEQoGyVmEMmTEIdWiWmqaqK4lA1ejK7FqOYV5MufP1i3iTeIVK8OBgiMZM+2KqHvAdN+Dw04X1oZEhJURdjXYfmDg72X180TPYGhfv892f8DC4ONjN10PLge0YdtNyPd3XQoklyCf3zCKYDSRQKJGN/EL+XGw/MxhBaY8Bxkq9ossFDrm0KB5uCX0VDELjPBo7bwLHM2tRuKblrYyVHXTw6/mAfRECNwbH6qqws/JU8Z2UDWKeOrOINqrMUBAnkk+aUK8k0h0f3qBxlUUDddYTmoHY8R3Wx8WuZiwa3vcbthG+PWfN2H97W7dtxvB2xb8fwdmiWZqyOyQy6sKBS5DpvvXgweDcw2L9adcdi+nzEdv6QDTzYsQDq2JhZG2MDx23g2KwI2PJlVNqjHksiEdqNUN/sAWdpRW57Kue5HSDS4A7ADS0Z3NdZBdzmaE4YgB00jzy1oMIDANqzI7m2U38yV32QVUA5T8toUR+Pvt0FJpKUKexmVUCuYMVLZl7uwwuZlwfxslfhzSADTOr6xnADYMwbAw/QMW8MQYDIDElG23hOmi4vcssVl6RHwtrsoDmgi4R3goPbLsRkCVl5+wB2Z1yg8hHuebED2biwQwY8UxCfT1T4c/75J7CX2xHezmG8St0IT0IPeJQvpCLgh5B4SVCIenjFdhNYu40WwCYZ5DPIy3irM03f1mfNdFPwzZo5p+CblYlHHdmndMiXpy+YG8Phn/Vw2NaDCMUVL/tJ0HGcB+OEu6vG8vqWLuQrFrMEIKXria+K87M57uREVLKKtQAQ6AkE6joVNbJBK5sFwVZBw7JfHyGi/maRD3lGg2x0ne2J7sbbhdUqgmHFt1hRiEuBoHLqu4uo8rZb26wtmBvcxe5UPO2AmLPaTQFUHiRZnKrryx687DpK+VGiYdk4JS55nbpkW1K8QOFH82cGdFEgGDtvVqzj9gX87zF5werT5Qof4LfBgwZZRSWpMQK7TZBEXn/fj+chj0lvB5/jdntDLRc2OOH9kJFmEtxEsCXBuxFkmErZYtFwXuyJNbKfldENKCmd2DiPbnvxs6+InUe3Pc6j2/7H7dHtDWHoqXi1YoC8adnj6YsK7P0Tnj1qQpSoV8qyHzc2kpqMnOidhLICaqK445/lbWpW3KLga2qJrlZXQzUATfWGmVnVsmHlPfsT2DMt2sDIunziHBSevEQuZwO94WHANNMbh7ikZpRrtZ6YHwmrFElNzD3yZ5gMPIg4TBHj0FY9uFGyYrh3XIfTKeTKhujlcd/puGBsGTBSQXYXoCNsov3sm5DN5MmGmpxSotUyswKj75DitsrTTjCs2bv0lh1XyGhPBEi1aeZOWJCBv8AWowx+9g15ymCg0CivQCaO3eNmINL3UtMZVDgOVPBvADrYrVLotL2cdZCJQC37DYAtF0erm34eEXM8x3zRBuMpcmtIwRREglObdU6i+JLaJp4RhQ5LCxu+GnDsF+yd6W7jqJHpjU08tJ9c8Jq+4+IeZl2+Ozg/hA4DWJuFQFxacw9uY6Due23gARt4iANgzj7OT0zyT8iTP/H1easv6cERPC3afeTGi4LDvilh3QbuNp8cw/O4jzbc40kbEPsyrWdNi7vafHOVvmZaeUuzJhRUMZwLAEGsac/499ZQzIMP0NTPS8xx/Gbrcl4TMB7kIR5780ivTK2McuQaeZVGBiBh3149bdPktUryddVkbUb2PzD8y9ABCA0yYTCPpv9X1f591a2B2ibUpmc/KE0V5393HHnNYXWAL8lqKed9rx+1X3iKTk8/uqsdMjpn/BcwSvv4uwF0zh0lFY28CTo+X2XglXG/1zDum2OM+3sd477pGPf3I5jqF/eMffEh98U97ouPKauP4qqsvlI1gEJS8jR7txAGRwOqNtRmLAPfUQY+e14x264p7z4H+hcW0FHMu9zJwx7OKIWHV/4GHU80vIS83byHR5JvA9eRacpypTLq5H3ywePCBzTNwV+hZiW+mbAD+WmFg3YTwJwXHoRNADg6Ilmnt2MTsJ1aYKda5SaAA6WnRKGy81V9tp1MNqHTQNvygnr5LlQ8haTsxh4C6y4C6zZwxAYO2cCDcyZwnw0ct4Fjc1TkO2hXfhrXdzoE8XQ6MK2lPPxu22F9PUO9YQOUCoXtKreDwgS/TrL0cyO5dtNpk7lag8wBBuoeODI6DY/T6HQwh6cbln5JWXoVJurLcbxk5uU+vJC+cJcdS88wAqASy6/ibT2psvtHkiq7fyihRR0hytl0VB+wkW6fpp0BIikO8HjfRoIJCK2XKIDBv7aP0R8d9gJZocggz12UIzWnefDYWFP35zsNbrBwOpE68aaV0XaoTkn51xQ7+oxTqIcDO8dqQRvyPWgzysSxAi0K8i6cYjn7ymI4LqU96MhOmsEfREM0J1z8HK3Ic4VSSN5S6mO0+pQpKz9TLlUvZGHlnXe6lfjtxU7zsn8/ueA1fY1XaYULXttnT+anQceedRjXNvMzebZg2sPcgWhJHSzpxyrmGkSOZzrLWMOcKsQE2szQCyFm1z0EMW/BLOzk2w7MMmgBaqeeOmrVPs/AWO+40D+UKFAHx7NV1Hnk7SDfgg7Ze0C3bDaOu0ez3FrJ8l5kQThzW5yzdItDusU5vTrg28d2MdsnNzbby41NC9uK1sjGZj9as1nw6F1e3djsodM3ixAbm6sYkOQ2NrTBA0M7GYtHNjZny8ZmZ2Urcw7tqbydq5NDW7BdNzauE2Bd6Vzaic2NZCGuYqgve/ByzlFeOWnP2OZmO4OZyLbmbLu5OUs2N+sJgmZzc0RfdHNzSF6wuaGNYufFwV0J9iHJqrZn+hbnIbPF+ZLd4rCEJOI2Yu5sJvK4NdnId6q9JzOUPyU3G85mrBFtl4GH71u+bJD3cAncb+/lUlRrcBmwqCzb4eLZyJ1tHjj3m1Y+92cXLl/mrPMBJ8rRoOynpTKBG7fW5zmDRqFvqGpzCLpDuKEndGcjewSK23dkh8RofbFHIE57NoiOumFbZ0ozkKWadroWPCz2Xrfr6toiXrXYEfJ5ulTD5z/PjIM8EVd5HmY3v6YUzEk5RQfm4RvUYTKpnxSzB9dEl9PjqFnK+C2EJbJ9DgZhZc1zQXJBKDydR7PPVXcax7O8X1nTFyor965HUyj5+bZyMd9GQXa3TMaCm7+TYQzxV3hxAMEYiN8DeLJ84L5ZHACiY8sqXe3rxSN24cLak9CQSAd6aWJliwX75IuxBu62gXUbOGIDh/jEU3gc1N6Dwt8OhHYjZNfwXWNreDG5fmNlPvn6feiJXL8XdIXV9Vtfjuj6rS/reCHzcnd1/X5Q9Y8abpm/Wl+UAbhKX5Q1wBztyz6cViAk58dBbl5C/HdFP5+nHq3g0lmpNArtSLyfzjXnCjYGLnQA8lVOOJgvl9QsX4K0ZJZXCBx0Gg/Wp9N2zlactkpLHOLvt6uM7wzqkgmez7Disc9rH3hknvjpfeARPjb4v32mRcvEH55B528p/jvDfMbPymetKch1Pp0Byd8ZEPudT7sR3m2kgC0nBTQHqqcB+aUnENT6zAScJhqOg9AxJED1fDlVuSWWe3AHK7RsuBWeF/kePO+bzQnPh2ZzUCaeN7gevU2Yg212muB6QUd8PRezdJ670ZMpsZnjQif7lO9ueaL5eE+Ww8dypqRItFDSCiEoKoRgaUoxe8vJnpaTndUZZC6czxOkpRoYWNz35udD8UIbt0tE7W3G/Px8NQ6+C335CoydXy9XF+fBMAgqYdoj39d06i/I1EcreoyeYNwx9XM39ZfGpv7y18XUL6pTv6hO/aI69YvHP/V3bT31oSl+muGuW+CIaR7aCui+mbCtUkD/pK1n7HaG2JMe3XSdgg5PqkzWJ41O1vP5B0io+8Yd4K13ANRo9WlQSWHgyhTcVQrwr8b+dn5AOA3JpYO5ma0qv08Nru8dxfXz872qZJTKXC3xG6pP3B5ONS7n5pSlT6hd5aw36GyBTcUT8PoQMTVqT4hikSghHGVy5JniSfBBlnYFG2yhnWa0ZN0u0JlceEg7K6WUnKqPlz3O0nClVGKGjMilPsCp41WBj2LDZdicgVeEVzVIqO+FsBrYBP6Og8+R4KUculxC+zh0gBI6C2fPikTZzyhf5uqXm2HgX33Rf/94VqjTIiN70thPZGr6pGFiyUqfd6aXet4NIuoOSDzY3FlEFEHIGUGqufdO5stFuMmJFblmtoF2pJdD1VgkMseNREauVXEz8NpJB6S3XbM/EPJnRDSatwZJF/JxIP2i74VTxFhqWe2TFRXotgmERYgOhaZD8FobQa8E5UfOtqS9mTmaLqnArkdRAaRjHVi4+BQyW3ettewP9RXH8CGJBwK9KBNCkQV6EqICvlrKn3avHhy84nryV43D5VC/ldur/uAm9gksDmWkCYjTW+jq5KRWsWDh4btMHLZnkARm90pD9Dq0ZM9DfpZuTbDdiKrmrk8M8/u/1jC//9HA/C9GYf7ZrxeY/+Wjhfm6WpwKbgQUZGNJCJVOHzWsTh+97BYR+fvqP+NS4woiu8i/gIPeRf45OFq5RJz3qZBWjS8FFyJFHAgXIYsxfPjIQvfCH70WZg5W4cKNiyh3v5ZYHsI3WaEZ60ytsqmZIk5JtLKwiHDlAZYcUBP8JIG4cRr2ZQAuR4G0wLQAceDKvto88pDgwXzBQbE44iNBnM68M4z8GyOGEITIBjvvq414djUQ2qPKNvtMVI+jxNgDuu+JEzvxynffawXRLIb5TuapFsTluK8I0ffnD0H8hnmMl6soHAIWw7xONZSkXpUfrOcNV4DYh0G1VDszgFAEoXI0VRkIUTrU2jrBf2qi4w3ivyvQdfIE+NTcxOkv3qqNRxsv57bF2tjUNDaUJq4XLYhLMAbreZtCbXw6LFL+Ocr7wyD3KZGrFzNl2x+8Ue3aDc64UoQJe+RCUyjX7SgUCYNg8lEU7SRkwoPXhm4ldKdJ2edF3D8zqBP/fUt/8F2r2V9LFM6UAi60nwep1U9swH/zDD8yY2OtpfIWgXDRoCZbvDEDpjqTHnQwy7Pbgzi79XJfkc0t2RrWRaoIjn4P+uHp3ayqfwfNy+koWsuALMPYvjmKa6a8BN6pzq++2w9uRG3C4wTkQfKvtkXkQyZJRjeH04xxwBCPut61jsjH+r0uLxBwGfXHwrNMbI0N0aEOpz3p/DaG5GMqqXEknW2hgQsmMfzxc79eXPgDIv67si/TneN3r6Jm2AXkZHWdW0RqsSFSMxIhjHH01F5WV50CZuIK8AKmbyQh8CIrEgIv0pLQXjnUjcnHfTzyRAUy+31DzVFDoTWo2TgfPa2RhsX8kxkLnlRqF6gI+sBPjuAAx5oPlITqJ9rGRKtSH5phRXms/r8//P7xXxd+f+eP3I2LqqyA+IB8/9TVOpZ7YSPsQOzYgXiSHXDpkoomPspKeD6BJdAPfs6xBQHVsg84tiAm522NYrAF7hop1azhn1gzh3qhheGSgA/QhR9xsY5GLJyJ2pbzJ/iAgBv3AVUYVu/8saAHPykY4QOqZnrf6zHvhTZoCyLtRGyYDwxZgEdCvkE5tcepHA4nZeq9PxCbLybUozpC4vSRgfPzAg0DD3ynK2+IV+0MjOYJTGBwSHz5y0sRWod81m/XFczmM/lVXp7J3eEvsa0bFBchQygdQ0ulGdqD7BeE4/dHbbSl+7kkwjYA7M0mssD4mMLUzkpRbjdsgnyKlESamEBpR116YnzxkAYL3BCWKV6zrtY8RHA8woG1ieejMAxdQoFWoPZtR+tJvxl9zkyXMe7OvKHWhAIkpO44rLWkQKIUoAzP9CfrrPERw+RYxYNZuLXyj14dENKiQOsqHDIG2LrANJJxARmoai3s49ff+eFHPvzxT7/+5mOcDJaPFToIjc4+gg/FBhLcmxU+tmiH5ZQoxB3TY4oqUBaO3YFAzKcB2AsW9WHFR0+iNxWq1xMiF2y4INiiJg765aZCQhGuKDTW86Y4eMuDqu+YPHJXFNQWleB96vzGRAP4DXX1QKoEVq2xVTHIP0i2aGbLBdviMLo12swWGKmTNFPocWIS9+3n5X1/xWdnhQ2JKN3cGHFQRVUHVdTQtKNFgxqTrmQaVHPFRqfi5wqDNlGOu8NBzSGDrj1cV9UlP/soRt91sojKvOSCEF4wiqng1NejluAgLnh5ivw+BXxgMm4eCeMUbOZNII0MmXdCG0ARhYKGVaA7SFJznep6MqVWbChUF09mVIwZKfUfKC0F66g2tDw1GXc+fN8jpuLHM6xenl7gH0ffatkfC7neMS0WFFEvUe+t6uC4nQoWKtwDzj6sC5Mj//uMX53y5rnvxDUgWhrpTVz0Tjm2Uu/P+JGaeQd1cXPFG9QnvUt5Q/CuFVz2nM0G5B8k1WtG3rRpo+aO9foRzxVv5PJRtA6WCFMm3KqaEilLrKXA4r5H3iTue1OvK+EWkZLCihpgcODZS//pZb/3rJ/gsEfxcKP0Oa4fbbwd54wvO7HQ45e/1kKPX340Qo9fGRV6fOzrRejxq49W6PF8H0ph0unNnNPzqj+wgS8IavCV1sSKxtrmUQqMpTZgGiNY7ltXtTUj4PfTw54XVLioQIGF3ijfFFGg5kvwmnCMNJJUx9HPfq3KIfklh+TjVWceOCQfEY5Dwgs8s41ySJeBWzhmOaRg8E5LKwLlkALLIWX3lHxRsBVf9OuPgS/aVVKU1ihFAdlRcvG/H+/0w0kLmrKhUjihdHU8HS91JHW+0TAWKpiSFgHiMPXJkyD7HTE3iZsA/mr2u3ghf8oBSaCXz31C4D4bOG4Dx7zSrIaYZbUXx3A+FsmUy2OZfnDbtZlDcacxviCCK9LS7rbFrtvAERs45FFDDeFu5qmeofEvKOmRWDT4Iqi5+lX271g8+n4kFq3rOrUOTllxj9kVl9J1Sjag9r0ZQyVpHfyQ1gPJxgyEUFB9VvnQ0B2r0Ay/Q+tQRG0MkLtDYwmhw2t9VvbyUKyl5TOcNKtSEzie2bRlrZeLfxvjg3qNWSncyuFKpCZqD6B/6/U3h45rUAs7s5TxjSk0kSvBx2hNphQCm1w1auWtgl07FOMLn/TtsLxlfNk9z4xJGSUtiijUkusisIPUdRK/BarncxRLF+epi7LxIdq4YNRf8kUU4AkEl7ABb6PfxvrJHGJnadE0bkYkRr0hzZpjHMrKDCZxWyXRowjHZG3q3Ubbblsn1Htb0aMe7tRhnBIMmpErLRGPq95E4SZneGS0UFmbF6iLXne11+ZajL7oSKGRnmJC2SU0iWvCY5EW7bHWqESrzgE1FINnTA2U3CiJJuwqtqs1aLGCfuOyMfQhAQ6lY0zaO6cxaROxXM4pMmkfH2fSnlmS1N0VfmxPlR/T5F4leWWCXXMtuMyQbnkM6qtMmQql5NxlUa1Wm1bLHNGVhTysxEFo4AeViwNJtRc4G3zTTWZpAYkImUQM9sna6k0hdaGcd3uEJ5lnZp6yNqyOqsT7mFloaPbmm7Q55i58wIx0wT8YLbQjcT7Cp1jVZSdtByfs6SrAppvSPYnP8L+f4jP8O6YONBrf04WgqFnrSgwof0DZJxCrEdkgHGQ2oroxeF3csGtQZNagUmR2JC639IMO+Qc3Kdgsoo0DvXMPfPu/5F+2FE7tYmPpqI8I1eONPNGjEk5EBlb/bSiAAnGnrkQGO2dFiTxVyY8niqeDI96qmkUf0VsfX3lgxgxEC/ndIhKOLCLe6PsRfsfVm6qN2sjYpy1iXjNgqCVez2e1UKZxPgRuGCfXkFgF8C5izi73+BZCV1la8jmQXSw3czDbahacdTXmW7ENFjv6BcJSGXlZiXLPsI26BMBWIq9HXfR7chbIUovWUjv3DDvdoWDK2hRDUgww27XJmHrz8BPL2uRPWZsC6KUEtmF6GqYNUwGsmjf2VymEzjS+CEnfDstbF2tT19gkLgmzrxOBmsibmJICwEuVXE10JcqnFLBTV6aWtDb5DZch8WhVr2fnM1YHo64EO8QKrvj9eHnuP/ra8dzHtuS5/8fJee4//gbPrTz339ZPxnMfr5+E54YvTsdzY33PPnNCntuxwk8Mh33q/PRxfwt++lAw+n7cF346mM5PH5/kpx/yHT+Nep4gfvqYr6WdIj99zP+a8tPH/Co/fY+/NT8NJq81iP6N8NNhlZ8OR/jp9UfFT5Oy09bsIp2UmV6fykzTKC99vD7GSx+byksfe8y89J9+zXnp20d44XW/2griO8aW4tv7boPelqzwqbK+YfbnQtI4SFM433XfdvZX/CgofXBiZLQZPohMbYTIeKPvd4GBMsoKMleCwdWjvJPqbFyN9SMgH7bvBH9CqH6EqcQVkSBBSBE0JirckwphhRzk0SAQq9QeRQzuca8GTkogjk/r8FukGCZUo97fzEOqCx8SiXA5wuVuHxb+LR0MK6TR0gicY4o00+BjMCDljnzMwTrQuq6zRXymxFiHAvXPV7k4H00ZwljUbSLCU10E5XVuXHV9qOnK0FBiCL1TaX/LJetJUI1aAJox4QsiSnW0XK+pacvLb6h9GzitK/rqIUO97ScAsPr6S/kTufCFgvkNU740DZxCvRa00YeOVPJcmc5NmuEjMjTzpXnDYloC0CQKGmuONbR3cwF+cx+Xmo+XPXvga8eefXpL9uyvT86e/dU32DNlz/6gyp4FpZ/fyNmWuC8+CXv26gpvdjfzZg9uzZs9RpYMk+cuL2/iue7l4+RF1MJ9ueXv6fMwl523HZMG5qZTMmn3eVswaUf80XcR2baow5NngklD0BKnGWHSsothVEDdxKBBqEd4BWHSMpqdZNJmt2LS2LA1TFk7ibGUJgxa16zNLepOYdLEfY9XYdIW1IcNaqJsSyaN94TYGKKJ+ew0Jm3OMWnHvSqTdq+8zYNJm6c5fDinTJpigzoEEGEBduHY1fPuU+xQ4SaNcmfawk3Hns2LNXR8A2szBB6o5MhmZYVaGlLXMl1xmcEk9jSxypFltHQb9ZgjWxCObImWwJFhUBKMUGmMKeNvuH2z6Mr1gi2H0WQMCXnqCq9DbUnjuLbEiezXKzLYKIEhNEXUI4hJKZUY8FyZ8lzZOM+FjQBf8wSupRczfhseLJvCgwG1QIHd6HCc8mD3xWM82KcneTDEPmYe7G+/5jzYOz3fdzzY8aqSLhrwBUvWp1IW1XbGs6Z6snhU5nJS8l1+9kUlV1addjp7lq1WcnJrnN33kG3v3ACKObUpnjG2g2dmnrVJ3ZrKK01ll8DpqGhm4Fnfy+JrJAJVMIyRk/pZqmJ80cf9ou4IVak4GgyCNfspjWYApeVP4f5ROaajfhyLN15dEirqfFtpGel+AjyZsksU5Q0usel4olT6wayHXFHkeaSk2WUA5cyoTR3no7FD/pp5w5SVGTiDGQhqOEOzIwxUZhmoOcdANaihbhRi5sVKB+5C+DA/59ZzTOuEmigUlKpJ9bxBnXHuqGO5o45yR2n6Yd8PBA+su2JuKlZ0oy+innTxCTco0nWP/Ybs0SUvA08tax9nw7OHZ7iGO3nZl9SvP6JbiBZ5LOGAqWNsltw3ZrPkE85myX3OZsmn1WYJEl0dEcFI0Fr2AYjey6YMOCD5TlC5+gh/rlEW0A6JjFE/rlbiS0ds/7J/UIswRmipkvVPLfex6WIse1VsNzivAsap0RcrM6rLeyjpPue13HsR5hHkqKfBFIx1LzDVLnjd2PDHk8wzM09pMZAVA6Zy8iRvSt9VuEMxAPmJRJ23gaFqt2tiCEpsV1IKHTjGyRRWhDN+vBBraIrJMAdlFSyMqSj6d8HRLMC69MLqIHlJvujwfokLPHRZ3nPKMdtgoBqcNdTJ+DyAusR/fJe9P+hA66hYES9mKH87pXCmtgOPTIwIh1qJGPkmgrmMEH9X9HkGbNLOo8Mip1yoAmG2Eq1QiIExPHfM4uOFvECPuQYfk6jId6GzffBpu23pUPKhAleQNYZC3LYktSCyg/Jriu39HPXnxIGcdovKsNZCu/VyIGGt32VLpEWhdSERFar2zoXsRiE5R3CgkCLyUO4WFrj5pyUUKe0SMNACHonpYrFzPc8HN3I9c9zsTACyvThNoba7CDFYu7WEHUR4Q007jGtuttiBe6Ah2CLiR4+vg3LVuXzwPXorlCvYIRV0bAWu3O3FGVKTVrBHKwA89mgF1r9SqMmoIA+RjLJlHyGwD6gl17vP5JpPB+mi0xkG4iZpD6L4MxNLGnsWFWxxLz+b+vxdfg4/Otfn59IK3s6jHAB6qP49+fmMKXvJy58kaLZM560Wy6zADn/teioGFCzhOk9PAoo8mQNPvqK/OQLlp6znF5CB6iwHemvFU3EdPSN+KMx3a+rpCpvTFSS5BckFlBuQ7AZIgCj31UqgtxkqFzigG6AWxNXm1OF3ri8EA5tRqPV1tZouV3y65t5ijHHJF80JNVmHAMmoiSttY+mXA6ULOXyvhPOLJGGfxu/j4DGNv5jOxxpyiSJOV+GcP03AUEjRJHPqNHVj08VdmfTc2pfqqvTFKXvpNOwWCRzgDp4UO+lsNC1hEyLF0gmuyYSDOoW4JsOUAsSqyhdogEJzfWbbxgfyHlcF+lFOOz1ZD2kF9gBAVEMYldghUGNUKvKhYxZgqQ0rFWfYSdMSoFcVWsqyncEv8zSl0/K96eDVgxvokj4DZw/tucP5LSzyo64c2jZSaN4WqJ1BpzHhQLtZNZPiPdzNInwZe2HLn8p13jh4NZe7mp9v+4K+bde+HWoAA1bEMxaJZhq1cQf5/JdT93o0eTv16DR66vXvexsI+0d+YB/iBqHgDR5kOwXUK85Qn4oKwW3ckaV1pnZnEf9d06dqR0a7cf5Ysy+tNPvpJ282BgVNPx9Nt514Ktp9RZ9jnj7amUtPuTMYmvxhXpgHPjflZdqEfJXOpASXHJ5E3kGs5aj1XDa1JGNxiSw+EN40hGtBOu7nT7QfR6W4bk6cTQppn8Vlds/ya28jDtZ+oJhRo4r6+H/YnjfaiwPSDswTvATCbMlZPIOeQTP/qV/pThePru1V361hGB40z6fmSPPQHG0YdTmuaK9ywfkz6AxtNQPUNpPO4vV/Bgsc7rnRM96GEVhFg2EHG667+UdtTPFXtEUnurYTIfFXY51Q4T71dc09F8aczsHPaQb+54DNFKVIUIMcjyy/zBEQQT/MQLpsXU156HTWMWi71R+fguF1671bRMVWzsoVBmSnmWKVAO0369aWRV/GRe+UwjEB9sjC1i/O4kve+zEZjg7XT1wnLsthIPDHV6W6hNuDWIy0ERnH99gVsXR8j4LhLEey0BBHsrj6s2intBiG6LXPBTq/Q49AUP1UsmTG4QyRmJq6zWTI21rN1GkJXCLDpFi9/W9at6FfYZA87FP7ZTIl0YyjH5gyE7VRXbSmi/ofxdzzZe59Hc46T2bd1/98q2G+1UbnW0oX0kXgoPbRxWCvLqCnMaNET86fRKczp7ab2cGn5DvpySR7GNkP5G3L3+OSVm+ffzzh57aLg3vwXLo4OJZQl1piIhpITzGAMMPPnGEoHY4t5zxD26XV/0k4Z7SdOAAIhICAyqlky2bYJymKImv3/oOUb6SPeF50IwXiS468VTz34kbyQeKfK/p431eEa0UEyIsWUahu6eoHMUjqno3qSIVlXwGL7l4vLRJKJO+zi/oVwpqiEEokL74oooNAaB9iN1/mpc9NBPh94IuPsUQGPZ6hxE4620YUatqt90LOAQfsE5rPeU3bUVFdt+O+2TKjxdLSk6h4/dMUFa/7w7Cum08rAiOny2839yE29xEGSqBl9dspvqIPK8MT2/s8tJtfI9FGKAHEIAYLKMbtIGm6XPuUfKr/nuCRIKKBUAtD3UQow2jjoOudah25SwGiu2KbFeIhc4MwUDeAEupxKJTKGtSk9IO4JC+HJdmXZZvfHN3mQxaJRUeFDIfeOypk+JITMkiSChkeViEDEt3+v04R+/yrChlwy3mPFlGFQ1J2P9HuN8rut56o7qPzrVPuPtquMo7Qyjgw7mXrnbBmmowjHtlKB85Y87+v6SlMiVJ4Cpn3LEIpsScfv+r3T9YXWTh0qcDBsZwWY8UIBHtvyWYiEdQ5VcJA3hEOrbAkYbgmg0PniLCkqU0aAJxNHIYkxoarWmFoVY0atMVqlAg5Zvi5F7KOmGuHKFrI3ixFm/kcl3OoB7GGamTIKt4i1qdPaJb4j3nUBSO5ENe8CyhiiTxILnp4ZCLySLQc8QW2TD1aogR/TLVSllxsOzqEWWyRXCwDHsu0aI4zFdxNllz0jBf5BZVc9MVlvJqd2m5K52+5pj7OaDWGEtYF4QqX5PyAtSaKpT4XziHiQJu2cy2JqUXNGnFucUdvS6T5POHSEi6kr+7VuZDtKKTNERzgWLSYuwPJxRIKkhL6Ka0IGGgOj8R0sdjGp8WDG7meGREuLMsuOsH2dTstFSxzKNvQo2VEo6ae2dXuYJjAt5kmJ9h6JkiWXW2fuOze1mXvrJRNtuwekSl7J8reqWWTKRvJRmgRUQywL0LYkHOdngobCoryXerElXJeh8cFDd0SDBntEt+yHNgNQUMVKKet817d9H2GA7zxZ2+0sxACKM7MajdmuRvbK91o226cTm3tBvhQdDfRZO0GkgVEBgR94grBCu1ETaLY2KFEa2ppTS2uafbEgzGLmma3GIxt0vaihU1+W2zBZ8WedZb1wOyogFgH8wwFZH4WcFv/U/fPO8G5eql9XdRlb0nxUudTZufTmcQ9lb2Am0EOLT3MgcXSybcWpiZP0ZAztyx2Dxe7TS1HFT2uhP94H3A27wOIw2djH3Di+iDT8fkPu4AW7eT+MC+J2n0ul4YwtKqSrbOZMQ+o4CUJtn4rbSEuGU8umsuUI+ElOptIp2KPdwTbpPcI9Wgbj02fn72pfHsPZ7KgPsy/7wT/zm1FudyBsNKBFo86SGUrSFMgtkKrQy3ZtCSgaFJ9woNpiYRCLeEWLgmxIG7UNlo2m5a2aS3aqZsWrcpCbgk1gnKoMpiCCm+oeRwy2YkgowSK2lP73zb9b59S/xVb1JkPalMckbnS1Jp3g1ws5DsEV1qm5iHAPxQK69OSmmwTqO0TG2R714eKq3vkldbXJS/CPYnJbIbE2CxbB/yWS/ip7eqdFKAqmLHhPxOH5u+0MDX6ykvo2pKQlmKHwPR0OgtUC14kIAKlBe0KIsLZm7F8Kn+4O99FsBq5HYYD823E0nFV4VLfcWaNTGkW6js8cLIFaArV4acuRViG7BLUNovQ+BKkCxBDFqVbqmYN4LfTH358XvMOv/cUvOa996fB8x3Dr/Wa98j/6V7zpjosO1X/eFU1+NIJ2tebm7ytfOOdokO8ztQuPga/eIqC6hdvAt2Aaf+n+cV77Li1JWZNOsJ7aWlT8YGfHt3MfVresZnTJN3M3Y9gqkp6IX5qvOsVWx8UlT58nJWdgZQiuJfddJiT2NxYxRXSdUWMxwudK6SrnSukVzxuV0j3R7G6QlL1Nac68qj9IWHMPDaT7otjJIz3fX72lSfCPRK0FE7gIqnzmF0k/dijdJGUwRJcAtskuqjF2b9I/2SrHePRErdmqXi+1+de8yTzzCr7QtEdVhNHeTRI1DUYFDoQ0vrr0ISI+KGLfoDHLANhVlfiUa+CkRyARDQjseQ/VxdKgDlFXTTDMXgchJKKeP1f1UrLYqnN06qNcjmlskfm1rfRezQqD6StroUReASKpJBriqjPpc8iQkuqtrAmPSidPAkbAoeg2SFgfgka4+RJ5v+d4HWMk6fr8PPCqU6erp508uRUjr7Lq8qlotJdj48uReShQRFBzVNVSxP1zPNO8cwTDXogrhl+WvwDfHgNmstBenTueU5s2/WFW9l2fVhsu342baQyTZ2CR9mrB2sHnf4G1MTWoF+iihcvpBjE6mp9+059+3Z9u0rfLte3A/p2qfqhqKvMCVMZgjRlx5oUI/r5rIAkptuw1hxkSL+II2BdaK1IMdzBGqXwEWBmY6zGLFqUAkKhqDm0Ye4tJmCIxBUzsPPGWEmYgueoj2dKs7cA1Pz2CffmpINoprYdWS5lbKRQmkNx9n02a1fyS3TesQZdsuqNT4D9Vm8D22BsRBPpCcQdc262zuPk8eq8qwKehYF3uZj8XtKNC4/5vO6zhStnLnaBfHDHXSOLCqll7oT6rsw+LWAiKTE/5NE26qMQZjpWaIW5nO13Gl39uVXqcUy59hGb5C5frulvIL8plo4Nh25lw+chpEeqP/+wX+zgtx2X9905s73I2Xdfwfc8pn5dGOXcT2m+kjhvd56ZseBOqQi8WbqdJwoln1IR/SXk2/OJutBMUZx2omxUEqKQchAhJpO7SiMjWPjKRC/pKGZCzZaMSbjLC187orbZtCF1ymS/FEq1RaKSM/Kl+jr5eCQYogTSe7UrlzwHtwUw7p5UkBwEaibPKubAEhO0nglyvpQQMVONqKMFdQtR3QRVgWMRagGt+3bbyGWFVkip7GB496VN2SEQ8xCU2TG3qpcWsL06XlsTp0N0lPh3z4YiSF318OsGvjOET2hhVaitg7c2z+zYErQyUeiDG1Q/6nCpw5qbL2f43w3Jc7FDocqPEMdkcG6T8UOHiz85BzYVJbQXgngJweJiFyH4ZwNZRXCfGlrUMVZ9e7W5CIt9b8VYW2g5GJ2Th9bBuu5wR3ukupIRpehKauUuetiABheJXB2QuzakYZEYypwLqS+zoli5pqj3cRDKERzgWPOB4Lf5BD2XLhuDjbEQHI15jbDB2rOJqE/YqI+9zkbdNxY1eLDkN/vpkWDE9mM8bvuRouzmw1PMFul5Tn3ELlLd2UWqT9pFcumSis4+6mrQ+s5q+ckt+MTccaFa9lp9Be9fp1BtJKnH/LqxkkSrsis7KCdVUoFE7JFKxWLSKjQ/0YGKvaQIxiHpCjTE2kvSeR7gUdpLCibsJYXc8g/L0DCThb0Csud1flI4ai8pdoraP+OJNVN3iyfWHtZL85CJ8DV60aKGRXLEPKTQ9uZ347QNiu7UkCC7jvKAYuhDjPqz1x1+7BYi66OXfb4V11vu9sz9lnjwkFFb1xU+lN6hsdIk7YTYOs0OH7Z3f+Kt7v68/vC/ATORvxwF4LAiOxMPeY5xBCDuFe+aQDEMYw2s5GE8vYsx2HLP5xWjWurXjb6+UDNdzY+bxIp48HxCgSM21gJrY62Is396HZ5iNLl+MbMryjPkifBjsIuIFfQGNQH6MsdjYCnjPEC84YFbZ3URd3doYJFZ9OJxunXgt5924/e8Y/2zlw1RLKMIUPnA7bfh32+Yy4cppq/cyPGw4KxTYljCTWML8eZ7fuNFe//z/aYO3V9/65Uf+fX7d8RsmC576LVy44gizLPLtdWXaqsvoIhapbFuDdc4bFj1PXiQJ5uDCNj6Cvy8DEsIWMeI0gvl9KQBTrZJUfYa8M3Ic20R8PorG66gPNRGBRRkX0Z7RL1/8CXuVJS9S8i7nm7Lxypfb1Mq3jGUVyzq64UED+s4VGGrhrMjMkVmXzG+PldWs5ulRTrVsGpy6Ew/hCVygUOicEB/IzDnAmezSNS0Hqxb2b9ITKTly8Qxi1LEeDp2jeWhaddYJmJBK/QSyYzeS8t+VG5uyA0Tl/jXo9b6fK1KD1MsKQhUjsZ8uP+9BY6BbVICrfmQY680cZFoS3iCgaAswklxmGQWtnwQY1TAlxB82f5731twIjJc2R98FQ54OPJhftav6APg2Jp9GLAR6pkHW9cSmlpUAiYN12YHLPI9KHcN5IsI+VStpSZFgh6f6ScXmfy5hzFU6gJyorQm0YejPNkvoVXL6j4owukePoA1NKU3frnYdNLsI8hbS3/B9+IbHexM6yz4FNZcqYIZxUI1Ra0z+8ZksR6oKnOYgGFK5OC5iIGhUjTGh8ISStj169ex8M5xZZuQQIco0V18HWuPjpV2Ql+zI8oxuHFDR8vm81E2hhDVhZUhTOwQZm/Q6SGMmxRchCMN4uZXuqJKTdUGZX938ynYKPr+w5MKLDCONGIESRcxC3zvoE4Aquk0tcvsPzaD09izrjPF4Y2qveShSg4fGpMcft5JDjVJyv0SgiKpQdcxvcNVtQDZLep4ZIVutosGxfBTILrt4gqhqScTqd78bOnWuK0b5Rm9i9FRDM70nsas8Cez6C/IBq4dYiDxPg+URgu68roAtk0aTBm/Q+lGNyGLaNfSqnPfK5mKnmQrGrLZ3caVLAGeIUTv/MVe2Q1H1FEUXcprtM2iKUUjPD76j6zmtKwGzK0p5hqK08A2TKQTmFlL7BKMT4PAq/fyFfXMBmWCNdS7X5qzA+3Yk/MBfE7GX1ch11p3QaWldMYLlU+xNbcbzR/4V8gp8W542PLzCNmtkz25o7ULZ7dSfoPg9CqBrqwUmPMQ61UuuZZ/Bmer4waaisXDY6BleCE1uqIv4prWvtTUbkpDKlAvXnuUicYorUKdTHxz7aEAl0M5Cq/OP5dIropIBXB6TauuBgcA/mbOGTjeKvHvwt33iJasUtkS7eKg9r2Bt4OilFjjjtelRw3aRbXVx9ipbVSf6BSg9uj7hT6BUqipKToDcVCHKGRUahWAuQqk+MR6+5Jig/FicxSbEynEkrzgkkghZv3e9pGF9VPw3XZF/Ro4BoOYVGt76RRvdHuMsdbnmJHo5clkruLMfA+3e48CDTqteBZnwVPYWfAUJuDI90irMVPwwAD7kLdIM3And4FHjRpG/FSvOB8FXAaeQc49AtazMUTm7rMqDKj9BMCQA7hiLvDmjCI1PofOobONfjCOWkEhZvEjxAPCC4Z5CxH8PINSDWV3CqUPVcAIAoc92ByXPqfnV0rmahRzL/rSDxA6y9s83rPaQ3efwlntO98HwryJX3tWu/66J+Ss9htntd84q1UU1LPaCXQDpj2Gs9pvnNW+tZH4osWpR5pj9CHSfOb67/vGrv/iXVkyTdLrvwgak/XxAHnKwx02CKSsjyOodcOXl/gNfvsBb7U86+WokTKyt4m4pS5Mn70nrTY7QJPzZrXAia9VpszMX6pELEUrWzTNIE9bjiIjwpPMMzNPQ7UGCbOTOGt1/cHEkCuqgVqqxNmkFcjChlfGD6BBh2bxmKMOzV1b3hVx6vaZHEzy1JRYaoG9kPNCnTAtOZjE42A+S4EeTEo9YVksdYBDVod3FrzgrNlnd4RXzGcHiWtbRrNASPn8miLrwyAFIrSMatvQ8nxe6L5qTEf0OIHV/F8IrOa/ArAg2AcHIEDrwocE58h+G0fk2Wdl9+3sEVAXxGGe5suYE9GIOQAXYv8HfArNRqD88Lu413MC5eo6MDdKP+ZorkI/5oRso9AtSTcPRwzSLR7bYgp11jYtPsCwC46jstvRMa4befj1jXiFfS+GcGCtkfjKdkaOJKV/2lL9ihsWb/T51x7XerwVrhKjB8eI0f2OGD3oiNHnlRhNYxQbgqoJ4ZlJh4OqCnoTLY9AW/CIXpa3hPXG+TzenHmfOoV5ZKz/JYO9ON6nTPbc6BTejKA2Bb+ZURuYWsc+ta4GVYRgYb+qnFQkknmKhJ8TgxNzXI/pnmShOd1Nzu9hqd38ubXLcY1tXnwuw/W2klhVPl9Ulm5JsoEp7YEkSmHFNuqKm/nlvG98rydygIwr22BBl2mFFoRccvsFQD2MuPQxAquKOi9Aup4LbOP83TV9Z5BzG5FPRClWWZPbYfezdYWPlpRvpwWGSt+cdGyn+ui2Vs8K7dFVhtmZCeL0aRFbiRVg00ppXQyAEX1/bG9xSxH2CXris3jnGlJ1a0tybJJvMxaOFmU4oTL/YM3ta0mhlC/ZPmyjJSjze5X98nbZzdXBJeQ54VnLCy0HW1npVR3xYc3AWOG33e7leCYUbqMmhnvAmMkHDcpHkkggAfyJFH+sVvmKBUQ9X+HqFuyOdIH6HDTtxtvBfAkDTn3TfP5s9euiBzqMtKREYbR2xSettYdaaRG/sPBbyrw1rLLwadUsAo0WRy1cmpsFPTS4J5gjeycAyN/P9WLigP3ytAU6OxbRDL3yIZ8U26e6YW8IG4kdK3oh+D2FEBXqCkr7QYXuXIscO9bc7VgbgKn2KNNJ4KPz26W12MaiacDq7RUaBvI08BR+1BDwNyE2qu5Wm7J5zTOzs61TJiNCTTWpsYt2UVN3qzXq6z05M++L+ireGTNWEbVPSYPAhup2w1qdmqmx1kWz+hZSS6650gyM+HQwVB0K0CMSVfamdsxqemkv6+h2BLNX0jxZfSM0kjjQtNpThBqUB2gCk0oZfzP9Sd9PRowL+SbJl2Ol6y5SbTZIxu8QXjMwKdlFaknQRJvzuksvtBukbxf+f3ApGizSVwGnipRh4ombL6AvGn1ha/QemJOk87EM6xAIBVXZVVE3Brp7G+tQ2YukVXrcgi+ghIRsCSXIiNy3UfM2+aJUWty8VG9e1EVhwSxYjA1yKxTDEUvbFY9q2dvRt4p0Pf3vFZP/vplqAiCdaqKYZlzmxuoy1zjUDaFTVqNAVM9wzK8OUB2vAQ+w4gA2++wt0iNxWeFlHzPm+dP/25t2OTIgT2/xYVt0Sa3PIV+v4+klvK6E+nJ4LQen8A/3AXSrejPuoTqzGXXWCwvkz1Sz1x1Z+uQ79oeC4dGi6hGtXqaVJvLV9XDiMsEbWpl6bR+vQ2rgv/XsX3DwN1ynhoYk7aiztk88pMONoum81iGHrZMLG+Y8egceftcXfv+53331ZcOKOzg5C2YE0CJlZ9R21+wgYuNJNiNhniOgS+APHc0CLVIjwus5BxjhkF9X1rIJF+y/1n378pvbX/qH/G3PoJTcCyzQMf5nKS5BDvNZ6VE+x+cAd3zupmP3vP7Lb/8K8HEL/4HJyCHqvKz8g/AlVavLiZBnJAjgaZbC7K3gfMy+OSGZ/yRw2MAvJcxJtw5c/tMfuv2Lf/jGZ3xPIeu5h+sz2W+9wTCr+vpxvJa25GbwWCkWRfahANEwyAsAxgAyQCtiuUMxQzFHcKCE4KLV/GqKU/qihxGdkS+Ql1vmzLxCFoK292DaTA4i8MhUZkL5Nj0HB3Y31I81RICx/ZwVloeE+0bbIFfBYRe3YNOpMPM/3EzCvbdimTFwA65Gq04JOFndykDd9AXXC5fvv6BtDy1FD3D2r8+96bYfuenp1NvIEyDBR3/05b90bM/hZ+RxZYhogUW52PkA85e5IoelLngNI3OMjVYXSoyzNI/M23jEXObGSOZZiliFyioV5Sm1Qcbag+ib5Q5XWZTLBRZ+r535/4kVK/Q4yh5O2cnhG+/jGFsQAJxs8lF59g6rVRfmvj3m9N0xp1qmNM6/n+Nu3FKQvfbm8ks9WvW5bHVmZ1jbADytsXHrmf0QPkVx6WdCrzNpIVEUVT1pOXnSD31rYXhGT5TVynKIA39wAWadkiNP3dyoFNcIuiOdUtUt5He3xcU5p8k5KL70W2iiRx7o6l/e7A7uTD9FGAYNSOsuAsTZt80oIlnfFdAK9oTHLTVdsOV+FuVKrlxz5UlKiZ7d5g3bjyb6wVtJ/F0Jk5cN9Km6pKLj7YFpXKtgySWggJJkAuOGlm5ZfOqIZeGYUvAa6vN6/HAtETiAi4ydumcKioEbynoHm5oyhmUlg5qyA6qjruMCUwUCknjVVHGmj3GcqALcvHRfAaZH1w2zVlMju1MxkyHmciGPgGct+4pCkTzrLUaV7KomNT/v+zGfC5TLrDO8KxXmoZn1al1Qdqc6HjEecmbuNLdqUKrS42+8sDNgPzXyEIqUI6NAxiSQwxz7QpLMMWg21FJVfOvDh1Aop85rwvqofmUeO34LQyu1uyEvIlWIBDiBcICiGWVF9rp9i3T+6rhVuSAgcEhaiOpiQqUKPvCzPEG8qKBkHK9qDTDvjJYBZzArpa1KeThMzun74dCPRnjPupVp6N0ViGyUZ+KHOX5Jsk9hGNMyoiWxBwetF8mZPwQpYO+v7Gd/e4uWhXSM9xonAS4NUejlGyrqr9s/CDvI6ZWy+jUZXQ6OmmhXZ6ieWMGAZXMuSxWiMGX5v/WhM6IFgc6malxlf4fq8xboPVey9Qf+yAfUOqr2ZF8tXvWp7njcauPR9FSvnqbYszUoNua/PXRHlV+Bg+CMVNpbXYsCMXmSqm65vfrJqKp3k6WtYJOtc//ApjAXFNjz9AamvDDOdedXydssWm7pJRu++9IhtXghDm8bYoNVXYAp4GtEA1WfULUPHJdn65jLGGYdaC87iojCd0qFutKoRCZ5lJpFwVTNoqCqWRScimaRbzWL/HHNIo8jHxrVLBoentQsCv7VNYs2Dk/VLAqmaBbpoEy69Cpqo2P3Ro2WUlSTMn0BD/B07tZI0zylXmiHkHA35CA2abVVLXnxBWfRpVJhNH3aVBdlr5jiokwph1XLAavyLt+rT3IXhnwU5V28IhDsESoZWRxAlboIIA8W5iIAStTF2ElUokRgUQLtdygRoYaAYrvsCRsk2nyo1VUdc7EH89CyVJAVBIoBqJWr94VBxpcI4Vj6Qv1Wtu1KtiMQ5RYqQT55hHhImsEGgZS5EzBl/F8HnwSTa6RvZhmKF5QMEQWVflHs7fLDH7SwE9U1VI0DBzg49AURVOUFi6GgXfYTuvvG+hNYNrCygqRrpWsE4nU+5Ck4uMm7HGXqeQZrpQ6OHQKivl0d3bcxVWH0vqqqDtl49l5U1SnjcK4hcYDJHVLZe04dP8IR/PC2wI9gHD/Q/wdH8eOuEfwo4RQBUv9KGPKuE2LIu5H6GKf7eyame1id7uEpTvfrTmm6n4CGeaM0LLQ07DY/UFcNE5crLFc4E/h+Tbj361bh6k/5xue1uX6MXV4HEjtspzqeDAN8yxL2b2lbx9U/CVAAOIH6F0wO5g1rt7u5mssHFGl+HlsY2s5+StAVZBx8Q0hNRkCNBEMJjFb75SK0+2lTgfueIkF4V4KLsXGJib0bsSM3HH7f82IHFixv6IjsHDkTNDYN709GM1SOumPRSMSjJpQAoRWMsNDCLgQiEdjbQMRpXAwknqGFHwpABXmM9ZiLAdBjqq1iiVUVKnyA3XRMid42Cs4McH0BIbke0UqtBLkuOwxtq6p0/pF6XnFjG9Q8MPBUsy3oaA3org6554ZcENgN9ehH7q1K/jqKB4lFA/hv+ZmSLtUUEyKgQCzXcymqjFHdEi6mAJj3qxSYFKTVTXE/KyOXfsTTWahjpN5jCJqsGhNYT+TkC7as2hbiBTDiaACpFaouJfmj/fZNfs2d+y1vtM81xNrh4QQDcbRBmlMtwmbSesmo2/5L6DUdvrmzUPF+pPt2qj+njU7rgzfqUIoYcHkH86Zu1lLJKFvH1aIlOIO9cwZuugn63XRd5A+bBwvGlm8FOYF664uKtnjWUAi0pA9aVCOfoZYqBeGd37A+UQMLQ85zCXVn1DLCRZ7XsiQJfZsFhmc0i8YUsxCYATwh26pdpdm+aK9SI+/wD81IcZlSj+bgRlSfmAYo8AJ+IU9YwkRDKh2h5MwAcRpCXCsUQoBOZWgHWm30bbRfXp5yRXiTWhuqfjuLeAFhA12o4VOdpKnuf2evKEIRRFANXUBXWLKnuxZTVBtTt0Mepdn7BF31VLhoQDshovZByAs4qrnK65relFfcbdAsDwmGo0UdzA58B4UoJU+U5p6jb7KnriRCZtTKoUTkURvnR3C2FakBTeCj+yR7vxK7xBG7X4B1R0fhfIfZE9TOF2oXFxIfC9ELq3Mlrnzry/Lgo8gIpuc0pw+CVgdxScxSUqfE1YcEwQrfXEKzSZauhVWa9r//xH+tP3K5MXTrL6m80LCJ+tC11XXR1xRPU/QrFB/Jp45iByqC8A9axynWIRcqQWtCPfopKxALFlpEgCHxbTkohXD1i4UKhjwhgiJbXLUkxbvs5/QKXTrmP4tCh4KvDWTDDHSybABOZc3pcEwRhi+qDp/qJevwpZIjr+s1Qwe6mIkjJ4Bnkt2k7i87BlBib9EMdc2tWgJBO9fCsdFLzZDr9UidXir2rTbVqzbVK5vql00FGjBY8YVy+wpqSNSMk56IINYyqzBPiUrPY1QcGIQNkQFYq1nr2h+sFvqFSdD+RFWEFgohjUDNxmyp7zVG2R4d7RBbgKjclsQgJJf3B7I3EcGn6inp0MW4PJcEEiNXY6ET1DD9CtT7UrPEp6bqS/lK1vnVV7IOzFGyriGJSxS9dZZpwXWS1jBGPkckkNJTprDgK8BkcjrIuDZI8TXBcpCWDUrHG5SceoMapkGraJAWnFAMpkWBAZO8Kv3Gi2DUavrUrW7jGC3GIPv5KTdyfrPJB9uNUmMq5Llc1Zi69QOlxtRDRkPqS+JXcvoR3IM/J3nEx5l8OXIX8/Bk1CGNggYWqlIpDcjNnjWccOCoXIXwoe5fojXcCjYKQ7p1SZDHk0W1ASN2TXGjk4t7KoLK+GbehuXPGYs5McRJikMDfhNx0kxF1pgeva2YofQ2KNtCzZnalcSmJDbLxOwt6mWcfD2KLnhTeBeoWWJkrrf4+D2kV/C9tSJU6cx74WLmrmAVUjtRjhlsChlRafADnpbQK+KBTGG8rDy7r99+nlOh74pvcUhefhtUte8K0eoOtjgqDWBBloCnsMoC2bm4kVMHbkxHtXXkZ5v2djqO/jIoRA4ZAJkAxj+bP7rT2T+6Rsg2RgU9KgWcZZvMmb1m4YP87AfwnmeKW1qlds0MLeehGVS9153sUmaOvM/cP+TmtPicdrasgWarp37U2rjzwCu7P/XNn/nv7+Sj9VlzAnn908kF+Yx9FtC9nDxzbDPwsl9VbQnTLnQ3W89+4bD1XKfRsxUHe7+om3JuTybNHSq8ZvnbWUGTD8rHMxQQzBtBfV1yXIsDJW6mvRKMYaMOYgPS8SMuNPuQ2O1J//t/bXncM3jBkukgJi9uz1HLDJ+TK+0x014P6excSSq+O6kJC66bjOcFvmOl8juLzKV33JFyEfWP3uEwCjgPy0WVLNf0Hw6KWEi6nqCM1pOtv32rjwLsLvn8LQDvgx60gOXZh81OPNjkqYZY7UZwECdj6IrJob7/BAp6/gKZ1XEPswOr4OdDe9aL+I/XqvG/dNjGHxuJ/0gZf8H0YvZMRHO1TDMtu3EMBgyCG6xMxVdPpPzI9FBVD4P1VM4DjYqqByjxqII7hJvIyFsCwz4b9ISJl6HqskNLZXqemGI5IJeDWIrX76RAMlKN/apJ6noRCX5hoQko1NXg9iCGWWZfPVg577OWg1SaGlGIE+SuPOSGjdyyDuXkjZstXA2UeQHQgdygrii4xCW9IBdkVYZ44+2MFvWDsPLgslcd2QYDP+cdZ65b11ivKqabRTQkn9WSPSyRFZ8maCdYsZ5abUMq4JH9Mpo1hIJT4tqsh0eiaiEG4913RYSX7kD2jdizseCxSA2gj8LR7TrawmAFMeJgaoJHN/iBo6wW67UEuDF/LY42mzgda5o7dIPP1IxaG5qi5xnlOSCF1WPANwYBzGMEjpNyd2BHPAii6At9opoairt4S4WZTM+4B7shg61hEUnlm4e8PMbXjqr62a/I5ADiADs116juSU3dD1Ld5gZXe4FeKd0DYYFeSmLAGfPaTZ5/hB82ptu80N8tbFO4aaj7Nqbuzc2NwlcvgBisBgXlSGHHoGpQSEmqKeZoNgLCN0EcRvriFqOPoZEn7ktMdc2WYqK4K/8/F0SYH5jtZoNRg0ancU+AU+vKvJbtHU6xHvRepEzLc8ZdNMeB7NX1wKrBGddWjRaiyAwGD0hEVqSUructGbYob8skaBFQxuUZmqUk5o7BnByQ9DZeI1M3mml1jVznsW5D1xFWWqsm4a26fV3ehBH3N7K3qpkMCkST3zfL8h9Bm0zlj9mvylr12x/HP/YPhy9raHuTnGYaEOnO4QbMzUk5+O7XrFkWXe2KFPpD/oFv29zx2s/9Ox43LfFL3PyyHYBHGc9LTFrmhiZZirk4lLaq9aX0R8O6JW6B2JwfMU2WbOQ+nr08eHRDijubo8pwESUyiEUIDknuF8liza8PYHKFyqFGkNUAcGDH4ErMuMVnDqs6ilyXjGLR4XHMXJuzEV7Hl8t0EO4MpbAHjM9tBnJnY10dpcitPWTDAXUoox5W7CPD9QIU+NRSvY68qB7yUlJOS7kouLmBYpzD9GHeIVhrQXke+UPhLEzynv0bzOKF2k+9PmO/rD19KPQOcc0D335/dv1Lz/qrZ3CDZQlRWIDX1DYmm+hZi8kr4/W6dimh1hqi11EjtYHQ69o79ZCm9qcHDePB1r9Tm0bBULEyAKOF5ZCP1x8JE9/4coxBaZ3/9UO+O8RQV5sChaLuqNWGmog57uUN1DOEd93bjGfGUJ2sDzz8MbWbGWTEf1fg5k8sF5y5CaUjYXcLT9ACBhxnVzfXizmaG67zrFE1u6Ss2QQaNvBlTJG524p5fsxf08cvcfiaotsvbwGtbxSInB/KAxeHPnrov97/W9/xQ2xP5ptf9ru/+Ozf+rmPsALG7ts++bRPz/w6HIR9x4/fevP6rk8idtulz/mXz37l7zi2mD/KH3f7+pyr3j6aO0pz5FdihoVLr2TVu1nZIDGXsQALGKKHkNdo/7SEhV0wbnpk801dbOIWBUXmmG2Y4ciZKwBZ3HKRm1Uzm0fzeZnXCmPS3EvDvOcm69xgTz7DhfYYtuBCV4vMcAvz3CYyMyjn0ji6mEF7FrggWsJ/wyHNnbBXxpNPR/rRhlSkTS0wXIwSwrWiZb5lHy/xfGccAz/WHXH2G9As1QRNHTWXkZ7g09882afnet7opzX9tGaEgMhdK3O/xfcrTnaPV+1hCi8Iwi6n8gfI49DHaqvZr5tlNuaRMCrQh245b6B0X5xG4wsj1LtHSL82EW1SplkOcH6jXB9+UzXstdUtc3ZpLaXFziApBZ10kGQ/IvpfnpjGo3r2N9hzatsGv/9GPtuUhOydyKVNMWmv47TsxyTak4Tsc9YkXXYrQrX0LZ4PimGFxdnPAtqFmuoyQK8uHCov4xTVYKvEG4myp/pP3OEqv6IMLc52r+gz3wqVFcyTMTe15KU/lfjdG8Mq0QpL7c9I2fS9yrTjujxzhqRvPT3pifUtkR0Q8ZvTnqvrbmnAN3yVS+Qu2vw1ZJT8JnPiVMfB0uhxRBMRB/IUj316s/6cvI0H5TN4JHkHj664Tp41wr9MTaSIyiPsQ4paVB4BjBKah7qy1YiEKRVwM8SPBWrhsUgpHjBIHIkmzJI6t5gVseoSQekiBshZ83lICybEZFYjFsuk7mgSCDFFm7yu9jDRGTtQ8wIeTB/wWKQuHl10ANLQOaxgc+K9PY9S42sD3J4xGDIPBlDvbFe3P8uiniogXIU7l1gwJN/mcKcnvGNPu9HnBtEy8zvUyOdbEI6LF5Vim7YSBaAu1UqDAqzZfMwDM+pyWqXj1NBxauo4pTpOLR2ndmmQNaOlyvCIEw5qu+GIAQ2ekoBGE48uNfCIaFZPfKTRAnb1srBoQoCyRHTLpMglmYeo3k0HOR6RcWLvIA+oJ4C6Maw6b2XtOjOcAL+I1SVPnC8C00bHI8Z41O14LGw5Hr70a0jx5oYbFhQ5PiwLUg4Py6JRl7bDUqdF1cY1Wyc1UrS3WCBGtSv7sseDbEN4nez9QulDPcMP7Q6S6hN7SrfifGC22WImZ854Y/JH7/IfSdy+X41DvFwdWatG6XOEQRb2WPhguwcpYjS1LloK0B9tQIWnyb5GstejL7IhqLOVULCc1NTrsXLYq9dj9QJUByPU2SwgeMPPMHeCPfAJvIFK8jm5opYBhgmuyHKYZnGMv7bJzMfmxpBzzmHE54ytlsGTMNksl9ExWtdKxTLu2Zfqq1D6XwP3aSnfPIVud63ZHkC2ap6uK+LT42kL/HJrbCmnShhiSHbrImroY9LIXeFFOVyAqyncQuzpZ+JdeBuFkIyq0SW9dmuEfKGxpgQhNvVxTWw7lwHnVjsUlbt697AuE3Qn6sIMhm4+KdBz3K4H08l2pGllFa3C6WmuNoPEEs8uqYZHiXRaY5CowO056++e4dwr7S+1KVkFr6q+7DFRqLNKM1V39lx4C/J74yqEDH9EqER8Ku0a9HSk8DJDO3Wclmj7GmT5tGMNyAJ/M6Iev62sESW/ENUIzvDLdeXLOr+9ovpWBu80TSLXJAa71L+CW447aV5MBOPG4S6qA9MKWgDwiLoWhoAJwEQdufmrjvYAcFTUuz3P8ExYVjvIYDoonxOrqIKcSMk0Q43Te3liTG9RZA+6kLJbOpifRsTNzMUi1gzt4s8L3V3IVp9mjW6yFmccGhnYnGbSdlfStA3a7zyx06WNR5vBf6NhenU+DlqscC/XOTmPQKCu16HbAghtk9z6bSt01eK9Or4ptAPFaYoCCTcjA8992vAo3rVm2xxtgG2VtkPOJ11T+CAXPr8XMSgFHgWDNMUseGl5u3tsrhlNfbH8cDrkGbIqMn3/dxd+4inPOvxXl2EX7csWKxOSp3s6ANwRgY/cKCxSlSjwaov7EzJlUHhFbzs/A0oy+GNZN57i3S1icpj3ZMKD6kM+tkM4nXzZbf7qm+XOjiG4uaGCsA14mIV3uz4/dsPZOtAOcDrL2DMJxehyQ3D97CG6cpbS75YlwefQmWMx5zLcmJ8HhZKUQhq6Qucqmp+DR64UY5tMB6ZTMdD2PNyUr4qxT3NBHHPgtk0lhnYO5ArBTkysDsGP0E49oSjobDrvdjqPk/zr+0UwLM6/Pd/rPt0tEz5nFKG8bYgW47699KrsnVAA6uk0v50yOtvtyGiGFbdfWuzqY0HZO8SZsWbXfeHs7TRLSGR07cjurU3n0yzyZTZmFu+gGShiN+2GKR40TAUm0B+Lnt2fnEVKxFQUufvOPEvVepWskHm9AjrY6CNP1jWdq7eZmcpJOhXs/HA8DewT6L1qOB7nQy40tE/8eh63dw8aLyuJOrdgaRDSt9F2LCs5rYjdNTyI8/sbOeDPzd1pCPDpupT9nOEtzr3QfzO4iTc7doLOmYhrgIY2zPY9pAVcqkUx5SfdiZj5iZh0PIb5Ecu3PBh2ghusqAZ/oTy98q9ysXWjkCld3W2FunN8ThHhcVURq1aNRxGAnddZJuAc01fFtE3xf9WAeE/Xshxv9Y28YdeNBzx0Wok32KAEj5Ui5ViUnokhMoQqV35B5yiVLeGMyYQFZeDBPIiSu9nNYq4UnkLqkEM80cMfk5XutMYqRzkqmoQvtwXcMaUFuPe7ouj1cauz188XYOoBgSVOnqfFTdnkHGX8M8JAS9Jo/3DIjFUDfhOF41bz7QwWUGYzBZeojWMPmuO86wWKXFgvuFpcWRWgZdj9ZDSbdyB0sScgTcJhCmcIKYL4kscnNsJnlcIuqky2J+NVShfzxgAGmoXyLerIQDNXrwtJaQ13humG6j5P7TtACsolA99Vq02vxwYUljd8svTN/TQw+BbyM0X4lf6NSckrR5VLcOSpEFyXkEBP1/eRP7glgGHEM3EvbZ/lD0M3PJHqbUgqcdbKYZZbCUzcM/eb9cDhkcstFw8rfdarEkUwWPdVDjq4lwcvnqw5Plm13cdU7R7rDZoqS5quMwHvjiItMq8T/LSYF1zuOofBoAsUrm9aLGgqFmBOSRkypyrL5oHr//0/vvHa7/78ZcMNnGlAUjGDhzBpajgOFwv0CoRYQxtwAGogg5oKYS1/jRrRyBZyyajMWhT3NnI5F8SON1sDtW+CsW6xDHytCFgwoQZiRHZ5MF9Aapc4flFbsiTDfCQsbcbgLSjfBmke0Hzeo0VZ54K8owOk33A5qiwl3FyPXxVNtZCx5BmXbIfjkGJ+jxawz5jBY0ZdsgTU4RRT15wWhGJsveX5s6nJRawXdaliST+ql1IVql/Tn6x7jgMA2hKeMDUkTyY8eMpGPoPktKUcm0qHrVj4TCU4mFQPeHrTryPXOzsy2MWM2r2LqSNVkr7LeTuiAU8CfAJp+zVMBDkvcI8DFmUNUcIBmvQEHmLu8yoTxpHc+oCqi8s2rBHoNjUVPBTJ3fmL0djR2VEHFtXHINMUesTkFG96E5SRKHK7Z4OTSxYneVIDckviSEdRconjGCdbBqkIEJURRLCrbFwTyA6MAhzvDsifYmVmmQ+J1zmJEDgSUCsP1EiJlibq8/ZKOs0BfWL0JdYJP/AYbTf9fIH39FHeQ2ORpVsV/cQiVsfpFoPhmC/wChghEbOhaPMKfDTDQ9QDz9OjDoQjRmhiNwOR1BcK2s5TUGC3WXS4FJC2mL9dlKQAxXEZqEXHX/cePbRcRS++lO6bDqIIZPXP5u5zXv7FZkRaZCYKNbU/1Rkh2woAJB6lgE3gcdM6hsnQ9qy0XHTgv11xw0Mf+o9/dtkQtxcVlVuK3guj9GrB0itH9KINyJBBdWhJKE4Po4wX7EYXgRbW2bUgDuytLSnjPaeUbd7u5eviCG4RxLK6QLwSEwpQxFQZCvCEwlMP0FCjMHo8IsBXGiQ0RM8uI0cRIqUImJ55x7DHFgzzeJsf7Mab2KFqYfYu6KTUsNGcAZ5UZnEMJgazOK7M4la5qKswDrpuWIbsonwk1PviS1DMn+N267ibpblfyZRg5fZeVrRYNED44cOm2UE4+sGKTk2AEk6ZRailsw30ewFiFpBYyCTzHvcOElMlR3YWydY0UMmlxXh0wcmslgCzBUBpYRAZKMn6tCKzWmvN9Kxsq0kdHsMeEYG7bWDdBtBbkjyBzWMD64HNE2jj5YQLXZVluKOSgXkVCSwKGmV5z/R83uCF4hgtkoa2TSxsShi22XWtiIZjS5siYDy6qFnTiYxIeIOJU4b0Ff2D3IieQLVnoEZzlrR3xYAZSF+NIcIkbi/py914IfOyjpfMvBzBS82+BPyy32bDy1W2ALxcTaZovFxnDgPVjJUCbD4l7Lkx91iU1lxVYa/iEGYFJj0FIjlYMKfrTSyCNIu4QR2QB1DzDEfEBzfFzV2+nUWfxQ7aMcx3UmuzIKJhnit2zJkT6kVBymJWTNjNV+d5u7KQgVWq7N51rGLqynht04kXYSh2bKzn/D7IFHV9jNGMrtwzNL8mIkMG97z4m45VUhpP00jCuB/4Zc84+Mg9vTNUbULighD3VBoOPJqezwVVlb6YVEyloF/sUoanV7I4QBvH39DOjWL3nUN4JCmUvrcJvUdaIU4bYzWuz68JthAe7aLdbExpfNVfwiXGUgEbNkExo2Pazn1/zcuveOEvn3bp04eiFu+BUg7hvbBY1ypzVNhe19oieBxP+AXKRLLEGYuFAXF5hpxbLb89qxzZA1Ixx3edSaQIy9+gZm16xcwrgRlSZwegryoF0NMVK9boUgYuwlDqyGhW8I1EIZRHKiqT/Slx6ZS4xpS4EAbBsDJpDFIju///6a9HRUtVs4ym6lXeEwV8QF9xJFk9WpHzWH0k5GcPyfl0CEOG5GW/pRtJfZcj8o8jJo/KuODAU+Tfn1+W/TaS+FgI0ge7YT8OlUuKK44uBTybTEEFeptFvaJbXWdeVeCW/Q7KwpfrpT1x7jN74vnjmw7XkAVGQjft7u+8/XKer5vf39VPYcNNm2g+XgW5EK4PaDetU6k0CRMftrufLMZGBh9tPU+tMn8cjkJzjyAe2PmSC/3ncwH3A0oUgjhmx+2mu6XgOdO/FiAVZdVrrTg9UkUBcEQvLKoxXLdrbmJvbB3Mfu+wdQjF3ANyJKUeYEW9IBH9YP5hs5h/8iZoDnwV4zj4edyeHqzfwr8wot26svD6qlSgp+z4avB7+KCMzaQFYDs56yZq0sN3+0HGCwXKVsVmTRvc+cZqEeEqV8UAdCUIhMovQlcEACiJgx9+jSsi0RTVeMCwWo2Hf6yHTbG0G77Smb+rG4DUKVTLNwGF2e/raKgzgAQKwtAIgPwlb5o7cWJKG/5KMXPbMnOhtQV1r9DcrdHPm6QDIrI0asJaUfZ6VMkp/N6XFJ5qUAiDeSm9itjCeqnOGrCRswtvj1+RH6Yi69YoGmc8yF5zqLFGdUD4AyjENpMr10uV4uhQT3u0YRDdQexVsOZQqhx7a7Dze4vkpQTTOdrijNquxXliND11kHFmmfSlMFikIRQy2Pnyl1ij45maLZhR9x2z1NzM58ojO5yd2jUS66kuMvaZz8tlOT4xpvaqWGftTstETUAaalxsNZQf8EPRz/lVIpjQJ3K13rrZRKMxAFfoWeJuU3aB7A96ZQUfsU+OFNWthOaFJe3yQjLPuRcEzpTQXDaEbzD0Dw2ARdMetNIeadeYzIdRXLdPLgo5+HukJo1m2mrPdOyTk9j8KTdcBZampQCqESJQG9GzNI9CEjTaeiOZAc8yQw3NqHvKiZGHgFYyqCGGUNB5rbSdPKjxHvFTTBvzOWN7DA/GdXWD2uMHrHvwQ9xi1+UMFLMigQXPiJJNaG1SsLa6OTQ2Gq9igjy3UcxVLG1XrDmW8Uf2kwvy3Qq/SFDe5X3iJ18R6/O74PQf6BV40Ee0Kp5sVZNM1k9oVmcA77pArwSocalPWveFahEDceq31Ms+pZRctCvx01unqJQdr+uSc0C0dDc/i/M29BnmlTbHXKb/P543aagId6xUZhbKSdXg8F8zxPGmV6fUGpzYT8n+0OqLQffh3nELpXeHoSca3OGUWw4eBeba0Md49YyyP5I+xaoz1cP6Aw4sFFqMGhHqWY/mD3N39E6BeufK/lgWEPU+GV9RJH2IGQiiBnEPrNXpEvwuqe5/6AfK3OhXfbFAojYq2/gizj6NXNbxSoxHqDa1482quBs07MDe6PvuP++rZ599TZWfL3ONGAnNgxHT7wE1oIftMoNd24AyN18ccvw3pRXVxzuLlmsBNTfUY2HRvD27WUS7omc8NGzL31+GW2OuBTAuCbVtJ9z4Htdm7suGGkRtUfPoUMsburalbIk+UAWTWGxllGLrITi07E8As3VjJgdjiPsg/1MA6Skg3aULRR79u7K/CoexpU2TY2F5+UKU8T3torn6GWL4D/9PxkxzFsGFIjRE9N+a6HXyjg4rbgkOCasIEZVxEHJ3aF4IUjj7kkESZ1+wZToUqtQABo8hiVLjdthjqANw8BFSe2GMq0HR0rtmikeESIuBOuQVeWh12kIkSWk5vJhyfbk/SEbrECeMpmzxTK+2ATjgj9YB004B6kBLuBw5i0NJ0lIB1ne1PfMNZ9V25fiQYe6GRaxLpbd5YXCjI0srumFEsGU9WaOEEnnEkA7uD5EvW0F1faaTrEYxb7PtBXDSmnFHZ/AV2KS6fjMPU/GVN/Besqn7wxBnwz6uLm9CY9NSrwNsSzV932yzwTuUhjkz8pnMNF7pvari5dQv0YcLARMItyPiCV/NozAWZn+qVAs8Cil1u4AfEAlDXQ90bu9qdh8y6ZIT4iEGFeCxEivYHtXG8lQbq8asGlwDJqoV0VjLPiO43zSWAUaVVVMXbLlgGySmwYDAoYps7fkRQgZRh5nNWfTj8BcZyVGHam7L2Yhx7X4g76p52gU9/l6slDy1vrSydVOD+pAdGYN8au1ILgbzzgyiMhBnVGrVNfOlSje2ueCydTLcx4cr8mHffrhMy6zpl0I9Yf3OfAnXJXX310A6fyzghjGltdwjXKrLwSuOVM+1cQEoaDt5m/xJbTPfIXBeGRGqLAGerm5uL23HVzv5wTIconmuoptDoTNSzlHPqrfpbF4eciU1c4Vix3D9A/vEOMDMqtRN27iMoxoHltqzhgYiSBYj43F1+zpU8Gjneg7Dy7Set+CNA4cKZquvF8atBfYYSrp96xlQx3bBrhhfybeVCBJRHeLBnuLJzGRO9VMhJfWnGcMvckh5pMY9qo+yQPCfWMyKyASaqXKHbcqXu/Ich+fiQ283/50GPpuEX2MpXO6ZceAerqCjHDOlkNPy3ShC1DFqRaD2FxSUjzT4Yv9nvUfu97jogGYA1N0UaHolcbe10juvvOMuuP/Lz5Dp1qUeg/V5U3t+hjg+PINqW1R6Bp1OtYnaOE6bYioNtFKfm3baI3/hFXv4qzMQKPiHBblXc9IeKvhTfrlK8/FLsRv5EDhN8+23SXjZq/eMpzR6t1Ak8sTVn3zL33zOo5x/8twYNZClwFlQ7ctLdYTt4O7LMx3jWUizaTd8SEK/jbo6imHuYXQ44TT+O92OaCgjOqV1p3M+5A/ReoBvyxE93Y7oaVNG9LTREeWqz+C/XTKi4QlGlEcdriy3HNFdGO2J2s7YYkThAVNGlL/ahcCZ1RE9040o8mEgkQ+B092IIsmNKOAITEfT13+5+lecPjKuZ1COMj7HM+Zp7953ZfWv2IVmcwGv/tbqX7EH9TzkMdB3C/7ZEgj5yaTiF/Adw5OCMHe7GPIKXAojT1f8sWY3fMrhsIKfBT8z8nXJbl1f1F5yFhOfs9QGjbx8UHk2OuuDUFHBudQSa3NtMzfLB6E5pw6hWqo7Q1k1cw+PLC/90zSh4BTSArc3u1P2FjguJFmrfEbfMSGTX/EdjWqTQbPUF3yIN0TtoawFm+sH/lP9oze9JWbvSdRyN7tw53lzAyuUk+8Nh5SWehXkjSQfQ/L6ermjXF8/WrhlkDSobHv6V6PGYYMKF+xn74QKmJG4Vjwjy4yzffPOrUVgQmDOA4tVyKIEzmDVKUbTJRVgfRQVQK7agVWKH0NmzAlhPrMf11c1FBKpjEZtQ6nRyYTdzJJyRCFOIYxxrFA/8VXyxAIukqvfkg1xofKGoXO9r56RPXyXiZv8TGxg/gmaR74wmJId3KIxXy12Wri/1SvE6esi3n6qDltlS+GX5oGdceAiqHqU2ACneSeutgfOKEkelujvrQKasu0AnEVYi7fhUecLLELCn9mEsnTdEiiZsbsRn3y3G9EX3Y3oi+5G5MXtRnzZRsTqfsU2THYK4jQ21ubhYi0eCW4suKrdtI+1GKpjN+JZvUdPWmV2I77sRnizMFKHMvOmbDkXFnEmcSAcq8OX3YheqVEgym7El5YKDLEb0W/sbiTGbgSJlcN3bPsPnh0AqAxppStHi9CB3AWZxJjR8rUi21C5KOXKrA6SK1PBRSFKSUfHSj898lpgdVi+XNs3e26Mi9tByQbyzuEw/UOPp/yoyS+q6dm5n31ZjyMHXWPpPNQY3FVTWEmkcTuNKgI8IqQNbixVRSItFVViaq/inoi36jyeW//TXiUD/4FZDVTVwnmcCa0Ajjhej155yFUAJ1KfghcqQOMkvsl/+g2TlpBO/MXdU754pV7+s9cQdcfpuz3U0/Z30nIia3sP/O3njl286zcv2X/gFzffEj+4uM8GLtpv9xjhs/s4Xnp2f11cPISli4dyyl+8fz39Dz72lROGdq0TU8VaHVSUkf2MUkgYSPLVzvYnxfZOUDFMi5OY9fR9XhDIWdVWx2uBjnvuT6hDIRhXjtTq9risPnpc5o7UJvPomXIeqbsHHHMa4yUU6GY9+3PsWccO2P4jX4AFXmL++grKtna34thQ7l35+Apb58OfNbMr+6dbpMBSiQ74D2qiRa963jQrzmLzhB8/jldjvRkSJdmmC0lU4SBCKhwcoNYQUkHmFP5SNt4ohypmJepBXfSXqVaV4QW+7ZMQzpNJ84KqNC8akeZFkLSMSPNCrCkYlaOF00Sn+og0L3FtodhK82IrzatDf2VUmje6ZFG96vroe5Du5HnhBqQoCcVTpHl1luZFwJVI9tuCPy9Q1kCt/+CSXrWovDHwREnbK7xJAH4NAAc5EBNlB7hkBHBpBQ51C7i6BVyCKwgnBFwylLId4BoUAFwp1aeAK3HgApgIgq4mdJaaZKHlyxUZL/dSYw68aOIkZwyI0GBkIgyTms1/q2AkBpoAsvD7IO38zgEBmN7OFBwUXuBkFOInnkAK8ZMBji225hvzoMoKek7cbNnCKlMIB2XrTyTTB1Ysmsb0hYbRUX8l6jtqGtMXajEUKdOn93inMX3BONMnBoBN2dcUIZg+1MKBYCrTp+xnHkxh+oJJpi/MqwyW9VEyyWUFI1xWkG4GoV5TmTpcNelSgGELzYbFJ+gfVIYtIDN8lWELddiUUas9/mHzymGrlSCt6TJZM7x6oKANMWyuagtST4vRYSsdEtXcsAWOVx+tQ3yBSNng1T2MFmrhQOjqqAybJy1RcOmwSUtLXl2/scPm5YEbNu3DKTHH4frJ5vRdT+CcviXwgkljvda+cvbA4Sn7YidUcBvvyG28o8mNt0uXVJCwR1UF2PWOKuv8FbLrDOF+Z3+tr+ASI2O0VplddZ0An5OrcmXjIH73ilFPiTgHP/tWDw5uuH7VLC6RllMTMwjYkYPjp0gahLhId+QR2qcWSqbsyH1u9f1oNdVk/ZHsoOncvJEdedVW8Cc9PzyBTpk71gArYvSZ8mhS1SyunlfUXTA5oaqZODpMDF98YnU08atUh6oZ2GJ7JjGkWD3wjTHGz2U8Nh7rjP869Yyjmlobbxh1UgfZuiT6zp1P1VFdSz6DShS08LB31CM88gGfNwM+JaAKNo/VYKu+ajjYRzvVmRmFwBtfFiOoDOlVumlHofKtUkmUEWgZqPJRlNNJs/vHHPL8hb5vr1n1LWKX6oirajqtaF8/JWpG3uD+T6Jz2FNxbPpFn42by6jrUVCAn5DP1oATsg0OnPxLsJaCVYlWBo1fZ0UdiP908uC6Z4W5jcCucUi30HlQqUuQvy51hVK0HAzVTV0h8kWoS5nBEPNwel0UYJUEhxhTYKpUDjEwjCQ4xEA4RMxn5QlH2hLiJ5a21FG1YkOsbdHL/+GqRKdoB9WxJk9rDS/ZhYCFOIBaJ9msw55YObIHd6ER/6mFdpX1kS/Azz6HwRTIS16R0X1eB1g/RmZVvgjlVXw9wZ43PyAjFIzvpPJSlII8nUCp+OEafLqmDk942N/2D4xVKA6qhiiJ57Btyt9aNQ0KncH1dL+Zlphm2d8gS+GRFMEPJ240Ahk8QuPCRZqWpK/ChtcZQTJG3bW1anjoYMUHoH+Qk5FVyMLA66S6iVfr0M+mmm6tZaVCxPWAP+76Yy9sBAaFfgzsSF8oI0GeGKTHQypGWIVAhbqvly5rCzge4YCjUA/qTYRcg333JJtAZrSX6TcD0pkFNPnOJ5epCQVISD0qWZc+gUQNDOEK0y+lccxqi2r1r1zZ170RKXd22+GymhZPPZ+k8St66l+IhpQMwxqrTDlE5C/VB78YlR5kYtBfWRMFp3ghqbN6AWIyANIoTcMWZgJbmLmPEwxjSXW3otEKhao4Nu14k/1y8/IZEp6X6mfPoQCPq4x4zjp+gUaqushXtW5VjzT+NqXluQHXVXKJnUuANpgqNqh7GFyY8fFYyYUse8gTIo8p8kuAm2QofGg6XujvkXnlFIbzJiJQlTTyBgrQxZdNnGukTk9ZrXuqX0FpQxErVwCTKEmgwCffagHURXsH/XhFjq6C+oBOspej7wQXDXXhgLh734439CCAkoQFCyUDP/sHddqEWVD4evdYCsTPy+SCdgKe4RwGqKzUD+C77CawGkVbfXS2pVJ3AuHrrFYqZktWk5qmYm1GO/tHVA4TGqNVivHZtexmVKLAe44Su65Qe9ypi3Bv2l0PH1LKlmfd8RD0aR1Y8w5MRqeWNdRhEVr1nLym9sCPeBS4kfFlZDDaLy7qMG17cXArZ5A7yoMj3mr2TyqPI0447GkJhzxN06sO2UOa42wuOW9RwCEuwtWAJthK6uSvHSxYKz0b6kXgojmEInmA2+G3c3Cv0X3aBzfiSk/QXtjO3wPJp4T2Qqk3UNBe6N8q6WoF+m2eGIvtoWmJ7cGX0b6J9hT+5kbenDTEhjZe1xenkJxhVnWOqjKNpqIuNTeOOrjrzf+ZvGW9l+BKTGawnFMxsWapNfzAPvQnMi37Z4WcDI/xi/scnQ7dK1QjV6ddrDNkTkgwzNfpctwDDmoDFSPFiwHcXuq00Xt07uywxmOgC+aq3hHwMeA6EIIXdWmXs8HbQvunpvnSXGlEUTPHp8D+2N6/CkRDW0dPvvsX09ekEvewiWtjwiqxUW+0ZnBd9B3aIqbp5T4uXcDEKxfnWvbHiE93TIvFcq42Dvdi5zcpV8fmB4q/2RcPj3nDfTv4kklVVZ88DIQ647MXW3TN2FdgkdIV71IK3MmxJp9TSd5bTZYyV1att1gFBSJlx4nGKRR81zgup9K3D4NtnTjhdU56IBLMQ+MyogXsUC7QENlza8rRovs38GY80A/BNuE9tGYEkVrUcxGgue/UB2ooSoUDX33s6mmRbiI4McAd10jdQNrnFX3jptAfdVPotT3nptCWkipFaOkqpdTAT8RnPK7oYl5lt7xBNuHYBTHo1G8hbLKZPtSApdbnzqjZ50+GI84NIws+ZfW57QgI/2KOq4o6SPi3mIQ6nJ4kHFE0noMoWdkSdYkDz2rWd1TeVD9rxmtUk2Lr6jkFO4YYvWetn8pGPgaeNdAIH0esFOJSQrp60OyrY0oPFsa0eaxeqmJb/FjZ/NCcWnDKBVuuKoYdfs/6SkwEfugC3gHBuqvYdAKjiqo57XnayUAao3VaHVNUjSxXVDpjbAfhHj3qbGqdofHd4UnFMSLRF6MrneqCybhnXY4KCqIBMTCuidKoXjoajUtHox7ptxUPtHUdRtMfOVaIndcW4Ytd+1/B7Rf8pqbstAGK7PWCaB7Vjb9Q9aJnCYpzFHpnFIhBkcmZqTuO7IQ+In1hr/EIxUy18n+KTSBYaosscK6J1I2xr1M10A99vnNySS3EK/nuAksDFDJw3nXBE+rsiqkhDqFNd1m6iL7oQGSyJRFf075aEWfAQb82+4oTNLU4pbXGkC2kAbH2g7/qwUN1U/1Ih2KVnH23lL6AfIxKA6m4bjmjd0d4Odf+xqQFdKTSwXs++e5PsuMidKthUlrY7jbQfDRo8G7koNaAH2cxGnSUrn4VzVROhasbqUeICsABfk/bnAC7Xvgi0StpWCczDZxplT5FxZwJCTTbUmYRI4zOiLnowHgbbVGiEG8IlPGW6ANeQA69QbGoTfhad9eAn4JpKhh1RuGgXRVjxA9/dhMK0stQobnFof4fId17DRKrdE+cujpb6Tfmvu59RAp+WxGWCd+NhYGdGT3zq/Zf7WYb/qev1v59ySM9dKNqyuB8VlnpUk7GZWDJ+fCplMGtzcXLdFT93Fnm8CmSelDBaIHWdttXa/+/dm30cwrL7xgY7xEIRJZLCznq+zRKmaKhOiAL1WYQ7Mmlr/M9/wYLH/+26dCZ3pCafX/4q7WLyhI7Cij1mzXS1GBrMG1dGEo5ATRGxwLrux4X4FOUYfofGJCYjhtABQYqgMMH6ok1KsqCVf4r1d/vqzkptxjOfL4zp3foGL9fJZcwINTN/thdivTJt68UmtONvQjzTSP87F2/2L738LOP3/fZq5PgEcVunhaB9MvzCI/91o7x5aNG/fZP23ijSisft/6nwDjFFW2sxkCtq6QgWnKlKoU3UlZOaasfNRSN/mnTKn3UFpbdRMfUWQDlM9KtvIPHnjyrFuCPF+CKlNzypcJCypJyDawy6hy9GD2HEXwO7TcuPYW8qe8MpV56vSilUGvQmtvM2PUNehCJ6zSsELzs4p4StdRfKDV1VZqtKIlQk4l/PudicKGxxcVJmd8sBcwSf52A1M/CXGILYKNI1445yFVQgViW7AANIQ2hzrDoiASYOmLny+p0KGwEagY2sdwM1a/zTIEcW2zKGBREM1ychfiMRSzAaw+1sOS0jEUixQMd5tXSIVGgdx6E2ncRbgnZLLO1CiuybYHzRRRzst+ktttAfVDvB/KFlOZxVMJFhNQCk4IisYyLFjTV5XcBKv4pWpMqcrqhMDXasXg2GufGyiwQPCftjuGWJ9htOava7lPtnarT8pvfMN1p+cmN4b/pibVo/7/KS/vhk3T4rcGI8q0/4jLbM63RToXCWkXPlaXSdF/jwitNXMSvawMedJxkt67jNw6KYLRysBPowQ5WUG/wKWaFPJb/Q7oAHokTkYF5pE8ihULllZhJipRLfgM6JIL0PDjVOkOtE+1VlhI/6g6+8AYvexEXoLI1+S5CbuWh0EcVomM7Z76SuzeRkQXrPUxs+vTh5MTZG4VvUs+hkRwpIQ11KTLJCDnn7G9G3GN0zv62N4w7Z++tOefseBlzzr5/mnP2gj+7jjF69TF4aD+zsp2XCWP9a/4XHtXBM1468LIfkk6nb/O9xqm56i+wX3eu+sOKq37nqN8bd9QPEc3Dur8SG9SQY7wDVUCLFUeUsSUN5CqLuLKDplzhpkPdeEYUGm4ap58qAuHyUU5VMVsYZwwzMsgjxEPSsuOvdz75gwmf/L+H1Fr6xpgdYnqvdsYNoupMFLHvq1dnfDg5L6/eytZK60czWr4wWSpE0Zk7IgYhQ74Cd4Bty9BzEC2jGmcz1Xj/+Ux6w0V4kQtdhr2V+cRyBjzt1WHZIyCTcWek0jd1wC2turBaim0vROtmoYpRVmOs5Y3yK/W8rxFK3VOKXSVoP0pwtUBCyBQmVdG4aJdQnX9sW7WJEIlfYQzzB/C13QQeOICid9RUtwNFCklTMiGe4k/QCzRHusvC1yCF0wP1QxaLP1V82hLTfwnv30fK0Na3VjkLRP4RyA6L+GGnJaK2WoyQHZ3s6I1EqVWCsA64NBmN0W4VgUw0MVX4eYBMIv1hSAhYrVTNpxgNjs0te4VOIweggpGy0DNuaK3aUNKGJoYGxKKUow2VHkEC3qKUkuy1iKNIrrYgYW8poUiPQ7K5hc/ozlYuo60jZNlz6od6K3XMWXQ45iw6co6o+VMtOMAY+fK1uogW6uAbsoAISxZ0kjvv0K97w1Tv0EdB86z/4QAyoVDoI0IR2Evnfzg28yAiTCy1zl137n5jGNFPVNWNXzzTzgYIFN6aBqubOkHqChCVKurHQtQIBE98DIfWxzAknQeBoKhTlSZMh4GqzsdwOlJpfUqlial0teLYGJUeLKRTQJgxP8LBavouMER6nzgwWx2MWlg6D/ANzHUJCO3oe5qKzCDPeBOeyVB1/6AqiqAYsPF+ZWGPgDrVhV2uzCtBjYxJBynS1uQLzYFcon5qKxj8S4duBfMqK5hXWcOC8TUMKPigkRGGKhx6iyzxEWoIKHaO5IXhQysj1Osqj7lg7XugfY+NAFXXOJFKq/hHQwnOYPVb6M0pHCIsAC1UgnzyCPGQtOz73uAWtvrEwvbWx8HPfP8EP9Oq8jOtCX5mb8nPhNkP4OOT8S//ftrhSYXl1QsHWOthq6886PhBlVJZMb3W7/i4Ub7oMXf/yET3w5e57uNlrPtPm8bO8QH/wcfAyRUCBsVXXhCzN2q0NEI1IjSL8u7VLDJMmuXE8E1OGb6KeA6+j3KXpQ1VgexoQ3u2oe+L3WSmku2CPxiem3KodJXcABtcjQVT3M839LqH/a/0JN+cieNYrAZhSfR4dddZ43EfdeKoB3ydWTW9xafKXT0JhRzqwsrYKkW6xP8ww4N7GCHZOnW3VEsRACcDSrHUn7uGENeKFKWyVamX/OxHdEcSlvHc5TLxViS2gtE0ZkXLDLchgzKZzcGSni5ZtkL3yLe7IvD6dvdBPMCIGgYDD8lwh7bHT0ld8jDGKtuIGm4CapFIpcuma8sCQLFJSTWaEJ3JcY6LbkItwL2OwjAoYRgYGAYWhhpCnPKatUoTUtProqkaouUo18pRrnH7dIwnB1fHfXKM22oNMY9BDAz8fhQJwq8BnzTuHYiD6cSDuSi66s2nSJgyhXDMue5ELj0VAFAYfW2k8BC5B4MOAQDPT5yPYZj0W7CQulWTb3OhTtoEJzX4Hl6rBx6GSpgsexSkoYjHTRkYMaDXSWVNPrcmeTSEPCg4QC416aW273x9XgGmPkh/I/TrrD5lrRdW5bdWG0iV8cQon3IdMVRtjBZ3HWoLerQKU3CXIwwfgXKM1tCDnqY5R/1TJ67F+Xk5KiE1tPSmFuxrvZEWHWupHpcKNyhblSMnh8C9XBjFcvX2KcVTy0MlaL3rnGl/pekD78SV1EwltYpEyEMlisqn3JktQQIEcrVMdgUNRE0naMipt+LEva2dCKSpGlU06NJIH/R936ESPEhGIwrvoSMSgUzafRLCpL0AIahERII4WJfPkbBi2x6EWX1O9N8vE09e+Nnt2qmty+uYXE5OR3U8MQG0slhr8rUmj0vEAxUGWqFubVDhVvV4Ws8oPMp6Aq0n1Ho8raem9SihOscQqhPVUdM6xga2rjCPnBfM9DOBg7gevsRViIPG6ppjXD5i2BFC9QcoRjvFM4SZ4JdKOJRJvQ9h7obQt9+trcqtbfxe4BoqoNZrWqFtKOYSntjjaHV1rSvQunyAJrajjCp1lCNUuXVNvtY0OrxlTaHWFGlNvtbkaU06vFqTDu+Ja/K0ptEBLmsKDAi1Jk9rqmlNOsCoBwN84lpqWsvYECc6xHFFZv+JykZo76Rej6qdhhrGOOY6pWSRqxNXoTa47Hl/ogfdEupiLZVQAnRESNq9GyG1NRtwJlHIouqoU6Nc4+vY/liV/UTMPtr+gL7Jdjtp+aIirnXEUgEASVIj1vYVCWFt70noOlnHQ37msIF2/qq0AK0pF41UqhQLoCklajNNoVdHZJ0aDN2GAscq/Dibhz/ve9GpQrWGZkQK3FiBWzdADY0SRQnUWgnUWgnUWgnU2gmBGpZAjVRSxOnSkArCx1pk3cGwrGqlrKqnVXW15bWtAShRDnDglHBwyp+EWwHuxwI/MhRHQReOga7Cq0cDX5W+Xo2L/6IfJAwgxdk62mAdM9yotXh5rAIpBTokGtIhzEV8rOsW4aGwRUhhWzrDVH0KWcfRErnXpOepDtKxTL0GpqmFLLhP8wxgWFPblypnF5NvXRVpj3SH4qNFJbdLKsfUArKj+Lyoi/KXPdBW7qA+QlXCMwO6yIb2KKdcF24Sg6xgzIbaFl8qRRO+Ja+LlS9Y4VKZE6RhoRPv+en7omn4TUHZXoQDQ4N7Eg5fAhrcVbTK+IHNlaKbbq52SwhTUzuraIUp7zDZ2vmNhSjEBRwzQmiMw8qATF2j1WBM0VuD2YMbUJVO4nhqHc+SPqNkNYpZ0+k4vfS6TE0tuWs6oRBGtVsWL5JdiJKqJZ8aeApvq5InC66b0cgQafZKdbffhL5zD3ESyjjuie7oE9w9NN4oLwOTkV1JqFvlUvIczalQFqqnN1WRdmQfUiJtqCtcyNiqKxwmIXgjLD49oX2hWdm6Eso4lAnjq/SixK06v4VCTtAVVSKodkUKVX/X+IB7IVX5ApaehF5mavHRT3+ynhNU8Cw9BREvt9BlfEJLBvh9Lbmo87ssqObqCoBikQ45FOk0VDOkSJFOQwbpQtoKvEXyqJqnOPeE9haNB9KZbqblIoKHQzvIsrV/FvuAotCMdJQz/VIYBLy8OWuwNWcN1gOrMymSmomjSAVS5axJylkT2lkTKacAZ9R46PZHQrr9CQa7lSfYW/ZMFxc9hYwqwugYz1a4heApOIHgyT+Z4MkbyVBEZbGSt6hX2Ew9osUxiWpFKT3TXtale4mEQgOFSHselT2PkIT9xbS+SynlrG9UmUyzX6LVKp85uFoPAyNlNX2tIhHIUmCrBgafI6Gu0DaEMtA2x2petirtQJvGWE2O1YvGjnqpQtUgkXVehuLZqrUIvjNvUB0rtHBSIDfKTQGNUtH8d5cZfjr0kknCB35C+Q1fOSgYr8VrIPc6+d4a9H+tVxb/W0WQgoZAdq2uwg1rnyCkIyFZYpuFTBadbJb7j8G0gEcNKzOtj6NPV36s5cdl+XGl/ECzTHJputhPlK1nJ6NEvqFEvqkDr0WWtaeV6VC/nMlnXfRaABI1UgRTQAqSk/fXNRlZumWWFYRKhjq29Ifw0y2hEqeVKgKtIiirCMoqGlpgU4leiIrqMImQ16cWrExO6ohVWiVTf+o5hKGSQime+C+CDQW9F+gQBTREmgiMx7LmMEdQrK7X6e0s6ZWzpKvzKJOIPXJCgtBuneAyEbG3DAVrgsHOki0ITU+KJrx2QWmaAwnmUlKOXiKXv/WQNHCGE5L0nf40VkCHFs3VITOzwoK+VoI+QcgiZMnKhCUrEzpWZgIbAfpJniNWdKyruj0FhetEBKEgGgSeXBt0ElyIFRfqFVxIcm8qHqgDueloIJeVy4MkyHitpgvV9MK/7xRzPHeMr8IhgAkXr4PKxWs1qKLXfe3ZfO4HSFepsd5vRWewXmc/oQp7+jFyaOm+vHKFOBOWewfVi9d4wfWx0YvXl+E68OftxetgcLe9xRUgQyjGE6RN2bv0/L9y/D9x7fquNzz6a9f/2118vjP0YYR8UsHRjfLAfzmPp16FuV56zK9iBjX7NK6IZn+CXyigYAmWk90/kxjk3DsSA6nlpSMxno7d87c4er1c/O/pB+rgUqV+1Zi6vFAsp9sY259HtNXCToxeAqqqqzJEpEgZ4qHfgfMAXa2abVx3dzOLVFzXUnonnh41NJ9JlThMb07AgyswGww8QuvVEaNq3aQoLjREhaCu53KDT9RWBT738LM02OmuXjZw9XKTm2JvW8oRs71MSanq22s7bbSaqrWVeS+ztoHrgmqlK624vDCoMVXrM3pH8u5pdyQnYjHz9Dx3Rk/Is5/Uk7hPep4/7c6k9loUOJBba/cAg/FYHc1LVTcIkxXExF181OS9leQLJpN3V5L3VJOlyt60drRcpN6l9KrXXlCY6/PPn5XOwfSWcP7hKwP+a90YvNJ2vAiENTzEF+D3X18utqreMjAOOiwuF4nxhITUJqJaSOR+DGrn1jY/cPPhmiihDWrinFXep86fcF3TYNdHPlOjAnlLUbSt968HyUtgfR33fWsBVnT5iueYGs7kiBYYsZ4xShCzTX+0GFmLjFovyWdJGjwH2y7yLbzsiF77Zr6gdeQxHCsMrI+9NtJxnjH7Etyfi8TO4m/BziISLiWJGNICfLzyhxGhw+Izsia+XhfVsWWXaZN6up2nTCzuzIOzDg95eY/m0KFt/OAOL1MX0sM+F7ASGKU73IuO8OgVtW+eapJ7e76DtsPSfk4idgOF6WAZT4QSw5/uCj/AG+UUqZpYHiH12/MCj8vzXVOKJS6SuGjKtwswlsVDEhWqLLFI+RrNXQewzK4ar0cwUU/6BhZX406Tbiyq4uVO2g1PStxWOg2B7WgwaSTRDo3ckRrNTK50G/pRMfMfwJ8AO0gqdtNOzkvEYZj+5gTEfAExDyKGNCu/FDZBs2aSVT/WrDUK4PePI/hJfZ5MDyPYZ6jd+NIi5veH8N4lBL/EQRHH1NRJL/wcq/KnuOGMqEex2Bffzb1q3XzPb7xo73++/zL7ZIBYSO/7JvtEG08ro3/FPqXpiN6P+/wfsU8uAm2XlKuXv+v9xz9sny7lpdcF571x28YH7VNTCtJ//MYFf5Fz6n/44oZP/u5/vOSP/uLp9ikN/dwdZ7/xs3/xH3/JPgEuxL/qKz/z7/98+68/wz5t/Ce/66Pb1r2zPmKfNv7HH8pmZ2dvusw+bfwV34F/v/oR+9R4bSn6p0vXR+wTaROev6THNN6dT+w7/Et/9c93fdg+5dOP/cz7P/yOv82fYZ+2GT/5bXccet6rf+CX7NPGH1n4Le7GPz/DPm38//fvPrq49tH/6yP2aeOfI934scvs03VnJ+zRe2ZieeW8feRbp3kfeORTXrHjkW8rTp+SyP4SGItRmm+i7JOzfyvh20e+DZVC8gRc5ClMKIzoDCL5lLY/8jsejec22hmxUV4eZEJFV7Ayr1inxh3k6FA28DkjP2Is1I6YxiqJAz+8B4+sOFOs9GAe52dhoifQzj1b14tz8OF75cNzlfai9D4FeLT5qxl8yb04Nz+LYs6zB2vLeUYHXLWEzgFdPR9bkhm2qZXvpXNphs5fw26caWwHrzwpi3mOW80zfo0HhwIOtnj6PokLfjKdlT+FzoYbe7NStOEMfIl/CvXkBuLQRxyYyTJGj0rURLNxLyu+HTp5QVm+i1pMz5/MxPwpoOKDV+c5FeLBI6Jt+SIt57O0IrVB5qYu7XbTbBk+jRbLMFFUhpmw0CxCjE41eW4Hbu2gSF5Op0V5noHIC6xPOD2PZc8SiH0q9YgQuLBMpnl2DFDm+YLxmYEASDEXinUq40J5fjHVRgJQqseBSfTEF1J+Tz474nELMQG0rjmuHeVwBYhGCRLtmvBUuhAV6NckH9MOugBxOyRunVtULZFTJVOPTp9aIrx9aKfw9V7uk3SDEEcSdzdXN1IiETLxhz1XonM3I4eGi3gs0iwes3be5BAw5DonqBBeoqBd8txF2+S5jZbluUwr8lyxzh9mzPyieZlfeGTUwqNFT8bjyfQU2rvKuLo04McSPQnfPYnO/2YVrRsh7XmDV/GVDq/mp+XM8L8xM74xM/6tzowgxUQIXpxfhMcVWCaA5VzCWRxKcPMmbyGMqdBBWedyTRetcXGYERJ6EqPvPp4Q5/OE2PvYJwSNT4jz85wnQ8ETYRdPiG30JO77XjMp5ijP4ykTYx5s+BYTI6pMjHllvhlbIjMpZiuTwg7ovEEDIsVnE69TzCK3YDYQ+t3Pef4D//0Dn7vMPoud4CK38/fCpqiMwT6LCzhRsEtKVjzcQTa2Nzk/iAQdCaWWU4zsXEFs2TwwMjpXEO3wUHuz3SE1FaQ1nyYl6jQZRWq4RqJJpFbEPSFuz+MxDzdemFCK27ngbv4Ycfx87NnOpxZlwMqn4O0pjOMZ8PJJeHsS7cXbXkZ1Aqrvw+f76CJZBIDqkMc+GXwRkDvPKpi9LJj95DWulbGvxfjcZXxeYnzeFuw3aEnbGGmTnPAETeWMu6jLfVzG/pG7tZQXQE90noEzx5DJGSxFvghWs4KWcZVeU2xQMFIUdFjmqG9lAKkkpTp0lvRWx4yjkYpt46mOGUZp1ozSvEAfQ4fn3OSoAay77Kh0AfkuLVMmI4c35ofxtsTjmmFYW/iAyZF+cDadQ+e9uOAfbLlfvar+j8+m82hmLZ/BvpEhH9MesNns4Qof0VklE/3s3MguCvgjVM/JCIUcakkI5lmezM/oZXCjzOPLWNLEat9HGKIHHGC21kyBxVLerTpahoOvPkb7LNrFveUkeI2b4+SC5mUHq2IDlMiEDDtaO6xUEx6hyDliP48tIvBBTd5JRzqX8yPEyJjjuV1XqZpZi3N5ykJ6ge7Ir6MAw64bJSVH+EhdfwXUs0s0ll/QE03CGSxoimzh99oi7A6fc7vNfc9gEWb7lsszqIR4HguwNurHJOM1p0IknGALOMKaYyAE01wULSoSklg01/ujFtHmgSfz1LcKVimGYQnD0BbJWoeHIuN8rTznJaHg+baLl4dtKmoQf8e0zPXzqjfFmF+t/0iXO7gLWVYEwiSSHYplLdL1fQUt1qVBpD8Ui+WIBf7UEl6Wy1CbuFIu0Za0Q76VsTydFm7n3GeY3IC+3T9GNAcC3CNUhYlst/Jw0Kb8Cj5TUFc/y80qtNXIuJwFcl4AAlFGztOsTGY8eC7jkVOBxwj9vRET1Zq5UtPENZ2vywOZ2V08mBYzkchjfvjw3x7LhUZzADVMkjYLTqMb/Vd6IjAN7HHEg72DI5LSAudaRnJPPsuQ5KQsVjOped2Y+FXfn2qURO/bNlSq2oSQUm8XiwBQbQiIiIkS0AQYBVXbB5B41iy3rQgldbeoAWH7GlMJiE9TzPyQfAgnZ/AAM+VvitfJWUpl+s+hjQwYAOfKvhisJ/yw3bp5lE2z8JZedNVV5t58AY/deUMVkyAHy2DFI4SUlBpySM2jAPGgQblFWpzuWV2nqeoUTnMAr75FF8gsKovTcpAvk2SJFhkx+FET7+/8KhG8BNSkexhxNDVZJW7lEurFa829ouFQ/pi3/vh66NwUScyioRV4XmWe+81zr54L9yhTg1tixRaQC+AVHpCY9PvO+In4CW/xIOeyIPflQkg7X0CDpM0NQHtltdgO+sN9XMhrOhqq1lEHsRByRdx/I4410BYtj9wqYDq3xoAMl1iTEpeIv5Tc22lRRhiJUmAfYF7WyQn/f0oPJO8CZtKCGkxrKBzBwPcYIVY3ix235zvREdvIBs28lLshpVa96NLAc70xrSAKxD44I9VLYBEnJxlnOZjgADRF0Qs1yeamC/XwW0D4vINmqHF9n2hINWtTRxuqjhIhvOUlGI1dzXukKlftwSE5hJgTMsKUBmSl4HlzhUWnnj2k/k0etBNY3580sx9VzezHLlhXM/snNqG/tZl956KKPLkIHKv3qdIfU7J/aEI99vO8XkSTJvc/g754N0xcutTTnXtGT3f8D7kTHE0SY/0f08OcGk4aAu19qI6gkwG+sKfrwZWwraGHez+vluzJK1c5cEeSO3ufXsXF4D3kFZFzryMnZrgsgv4OcRPu9mH1szHzKFp5+jdJkMGc9o2VazxhtZf3jvXy466X97pefkIK0y8eGv0iePAEp173udLks9TcMheLYW9FK8oxGq6b4J796w8HcB2h3vTB2LLO+fUwuAwKJy6KmwNP1o+W6hOZY2S0JqPWoAUpkFQN5sXH2iSahgp4nDNLYh6pqsSB733bZat/ef5vEtwk4XqfZ01a8rSjpqxDqchjA4qqhsfESK8ADPYAX5J9RQ12Y1SOIxYBSS5iMQcVZx8ArUQVmPhxmU7ifhtLZ0uE2i1xlbBhB/+YDajB/r4cdLdAhFr2hLthfO8pTfc4IbV0I6UIkaWzEJKL8wzatqIUreqynOQzeHTlTDGjej4LjhqycCx4ADGInIbmKOPiGdAWlPNTjZ93ZcUICc+95knmiRudr7ieyeis+hnUM0VRqM4OahS3dY74j9uawLcBeKEFPsEXYmg8w+PsDO6zKMZC3NIFtCvDLb0HX2vXiC7AJFQzFaqpud2SYfdUesyqTAfVBAEpea7qt6CWSL7H/iigTBiQJkF8tIi/K/oHwQlTxE3VTuGgAu2htFwGuo4OegOvbKhCRm1uxNVlwBNXMCK75AD3uaX8UI3E7FqDUrseLKEDczz+i1KiJw42KRKPG85Rk+ETdV8nHWtqn6AkSh6TF7t2qKkys3bM4prCLGWIy6itC1/obrDBJIXvlG1HTCzjqF894+vbXn07xxrw4qhLFQ0DTcnEctelULJC6Ex/N9NUDbHV8F6Zuq8MEcHtsvjzUUL7AVBF1WC6VK0OHCub+pYn0pwYBGIc9rKPlMbDcGqae6VVsWNlQu45KwjufvDPeaH3ao9Jdenb0jiEOBPOr/BhD01hhE1y9bJXxPgR8rwiOsUpjMiI+j8/AphSFopOCoAVzcblEeJ8/U5WKjAZexhk/DM4Jna8ZOf7gOgmkXjtl4XdROF+sp/9vKw4x/ygjka/+pSMe/D3L7LWPX7kn/4qgY7bZtXEqTPyoXlFN9YZ+vhh/oaCwW/9y/tDZ+bjF1BAEaCuSBw/AwC6U08oZp136AEpIJhOYoWIKNHtlsJAviKgj4RWyrjdoj6LTKSPFTwQGQFecQVeAUUKHLnTmP2ijrZ2Kcg+6Mx+GPNXW5u/+C+PxfzFh8bNX3BjquY/8DZmAONFjP6Kt8rIGbwX1BLzP4NbX/0i/TDIPozyzXyYZgJGjXRRuJUJmBFrI790KtZG1A6FYokzQ6EdM3YovuiFvuDeFKdclVsDqjsLfMBaAXyoqxEloBLUXYEbxpx9D/y3uiSI9VrVgPcKCQYdVDZCfmuGO6EIiQ1ryUeLaWjeAAgSVREE6JEbNCmMfyu97sKlAG5hReNJMnmaacT51XeespGQ979aSvVdqQGP6GpxAkshrxLmRQYPnWmZySgRILstxPmawzc58NaV/EFP83clAoSmZ+J4LRF3rZrXN3kZlkIAB8fVdODvQwv61MjIg46M/MDwY4IgHx0lI77KIeqOnuAjpScJCIDQk+/njxksh79/qPSknv3yiM0gQ84j1YExhn+yX3GTG68fq0xu/2sxuX91YnI/WJ3ceHv0k/sIT275MMh+7Ymc3L/+KCa3jl11cj9YTu6ruMzqJA7NddNQx0RHJOd3PIvQzie0P7tHcqA0N4nSp/HMcRMFpQK+pXdqBshq4ZtPfTdH0N30WzxvC78R3dURlU2NTMZnnn+KEzh8VBN40pRStY+h7WNy0j6imPT9IZtTjEqBX61yzRQT9oX8wGt2UXC1xjyfFJ8KXNfXsGhVX6XhhEJsenC15DkCc/UHp55xDkgRcKmhxABan8TTdQ0eX8oN8lSrznugHh9SBKaA2dE1HE8may/OG5ZSYOcGkQf+ruzjZjD2f3X8RGurm8KOB1B+hiclalIIfwsN4j/Zbt4oCde+eA2P54jVnLXsAwp/SuRitl77EBepmXa7ubmhDm9SdYGToty1TTFOLFIBnR3SO/IrHniZMc1uEm1LcbuTFK1KIoQc7aPDYgY17S061KGZa/qoCBvONoyN9zhxZjgcFi3k2VO0ObqFPNwKKO9KDQyLuoENHj1pHLh9DjTXBl7224IRITUwkzSjkfwIpKS3GJc3yAY3cGZCToA138AayAO+dljzO2/418aawzefGtYo8apizeV2WR/Ea3jK5ytr2ElZSycYq5jq2e+im510Iv444tPfDBxlvo+HpG5vHxOL+46FVJ+KDPeEAoQ80lsxvty2ZinVJmwf88td/ipqYwBEkpT9MnoA/f3szTJXvexXEAPcGxxXK1UIHguhwY2da11V+TVSyDjKIQ8dAFzFrb/dt5B69RIRIncN6+2ncQEL7fp0uJp9ChkRP3jYW5U0jf9NbQMgOxJ/h84DlYbVcPGSe6zmPcjD8GJk6m5kEHvptMi9LvK3ysjd0yJ70z5vTYksY7SRdR41ixRvjtzSeAT+d+z1MXz1Zo+fTCYO4RnDL10COB3GK1OSW/A0tvwCTEbgUxHzdFSZF7fkFSgAbAySOYWjXoZCBsEqnwRf6F+HigYBewxc05yMm3Lt64WUDD6NOUHxml50sVRjRR0s7V2jSORBsVjJyz11q2sFbkhTo5zYKpAnjROmUmaTs4sai9dksLWBlK6TSfrVKzz9yusXHixByZbk2ykBPXwOJXCZJsXzpw2pFOWDkmZfQos1/+WSHxqs6s+AvMrkKwJpTZD9g36wx78uB1QbENxwI4DECX95b02s4iRaCMQvidYPyQ6Cn0dwrwQfQPAcCd7iQZAjwYcRSxI8hNgVCX5J8RLBhxDsSvDNyJBJ8DCCCYKgJIb9XKO63OrMfg+TxLUq1FhdsLSBk7GNMkbxM2G8s9j4xXA6Njq0m46Vo9gYV7AxstjoKTZixBUbI4eNjIfAHh2vNWRyCOhRNBUBedxEXd9zOBeKmLLEuUCaIHsHxblIcS4AzgXmdtIkzpk1KOgXwQlxzlOcC1H+SXAuoKCKc560xqviXPD1jXNBBed+/wnGuSd5pfAPSGA8P6qP5yD7A7PgK4UQ3v0kX3xiyhe/f16wg529hMbmD65BFUH1QOjwz48eCD3sjnA0SSSOtyCY6he3jn3xZrzrF7e6L94mX8i00BvN+vFdYx/f4T6+y338TgTVchHOK+IypKoGqmFAeqkQmIWQci0ISa3q2QOhDKF2eZlrBqHdhtk6B/jcMWpJvrGKjLjZFxdzNLt2EKch8+rKsfvifEGQWS8LzR/Ml/C6F4X2ENqD0DaRMmGJF7U6aC/JBi+jbRTR/EuKPvWp+2J+dNcOrhUrqJtjFg4yB1n0+e0gtt+z1MPFnYPUgcIB3Dgjtk/LtARJRr5Ms4MQsnkfD58ilY6I2F5xQly459vxuCDfgQflO/XAhwYCdXX1sMxeNiV/g+ZBLPK+8KVzCEONpM1BSmhhbZVacGySd2lpEF4BtTvY+xY9L5RWzCIoBcP1M7oQybWsWTmRwWDxVEIvIjQ54nT1RGmUVqiPE+kZ6vIxNWqglX7eGghuycdctfpahdxEvMIU+ehp6U7kYvKKwXoxFz2AsOHAHd9bO3zp/Re9Oi/4M9KTZSSgtVJ6Puf60HB9WFLT42AKsUPA0KP3K2LPNN82yWjmuxgiHaMFMOCZJtxlh7bhTzwt5Bk3oUFLgE6PMjW/0RUrMkvUBaYtr2pPVwv23uNn+W7Ck9UOzaGRz5n75K8iknY98jkv36UnRazDCedyAKs6XfSlGXnkjsNUg8NHDbj41vChunbaI5/1HrnfnYYVszQrmU+n3dUkVf9RL7l6k8bqei7o+M2hP7aJkVROUFFEN1jalRG3rGL2YUWLIxRnlMo6uLveIXFu5I7LCnNzMaBdqtsC3ut6BtFL2EfFBwtoRhWUX9PPi5E5oG6D8hSJLwBy8Hx9dtujHZiiS+qZNJ8TVBG4papRKDhUrACL/Bfn2xRf+kJzmKnUtTtfMLdBxyjZex0l23SU7P0Ipg7ZfKNsMPbxh9zHmqTKBkoGt4l6kzm/H/vw4+5DTdLze61VmoSTSeOmeCDVSK+pY+KMg/ZiGVBaFlv65BMTgTWDn2i7FARtbWj9UB8bt3kOLIAgYCST3Keumem+cR7iwwKT72b7MpCrbxgORCYWhZb1FPvjJVESiqQTHa/qpEo95EZoDnIqpvnAbukAKHYfFJtbJTcea6O0UUoqZqV+LVmYtAHoD8oEaEDHO6AOHsgshntWe1h3QMBpdCZH/o5iSHuKZIxizPPA/Te4jZiubrXLqFvheZV5WjzH3j3Dn9KNbUI3xJ9ZE/dHFwzdWKBknG5EQjdOJzyh46pUQHymL+WzFWowa4nArpGZrskZ7aLTy9hM9ez6QlbquAbBA9p3NMCqRPVoGwANrfT9Muc1vNfM+Y42kOYcHZCw0ocM0z+jjvEwUhkSB3vQz86gw76UzDBBncqNxbwbi4WxsajpWCRCbOv4U8iqt/h5oWLTxig/HaL5jLpYChfyiIHoEyPj9Lxc+unkC1R30zJFI8RcwclDs4sMWTcxu+wcUXyVU/di1kC0C4idbqC5S6BWF8PNFUjl3akw6I/BoM4wuJ6R5zHh4wJ18adQSwRmfeBjRgmDBvMTxWIZp1mxXTKCkYwCoVxGxgtBUci+ZPxy3L7U+OUY5p4P1NQVNbJ6dRF8kfiCu7tggclDFF7Hl7DIKv8ZJ3B1i52Jxc6rGY57ScNXcZhoK6ztosAudao+vdWaQZtWaEaZJF3GlTaugDZiVir31CP+uKQhPHW6ed90ilk4ZBK/dkUBERaylatafm0fh2iGePlr/C1WfqZxummzc8/wTylwJ6UZRM5Qy+IGuHnHP4lVASCIRGM6WZ6oOwj5E8cIbXOMUDyGRmBVzMX+G5QUJWNMD9hF/F3RF2EIli7aRrGwPdpL4R77/NkKxQSUqmDLf2I0+M+gYIzm+uLImBJ9x9CQZWjAOKta+C7SW2OTPA0mniZtydP0Ab6+vR3M1GgLniZgtBXFAoSN1VdanuRpEhTO2GCGg7q6cVtwgF7aGtAAa0YLgkkr1OMQINfXHYUM3RJBAazCLIFYCVSWrS52VEmFpVFKZKYWovEDjBLAK96xxlDhFk0oDlVp0QrxkKs4oQBmLgNWy4bdWsAL0wcBnDJbNdquyuDKbPUMs+UszimzFRtmK53ObM2bXeodY7vUt7td6h1ul4pg6hDcNxvWsY/fjHf9WJN0wyofiwJUvmQ2q2Mf3uE+1CTdrGqt0iRs8dbMPJNqlNlaQtwksxVgNwVmq7GmM2lF2o6C8o4QlBVltjockN0ZxmQh92lF13J31k5dM2qTzNYCIhfMzXfLbKErp8ZsIefWzNb8SZktHfdIz0U+5OFZ8lYBDHptelK5Y8UEcPk2BwvADZtOadu8TB5kKebK9hXdie1ayneH8+wxLXYZzePvir6lXnPUVUOoHSVdy0K6uuU043x6rciwXoFjvfjxIY8hM/BG2C9ftmEVqqWkaZIJs7EZzQoTxuVtSnlYTeqWEdPJaDZj2HJWGLHALWlKqJa0udRzxEvCStTmQbPmaekKc9906VnCZ2UO7PMO7CujYAfWcu2ZmpbBnpn40a/AYFnXSsN2rUySL3+CajHRoM4UqqVq4SckWmBZqhQLKrIVALI0Je+qir3RcVwylNqhYcehYaZEVxhQxUcPvVHAuFVTYTTBgAIfwXw5VgrYtSJlbqP5kzCgK+Am5rHVOjkDCoxyDGigDGiQKSpZBtSpwlYZ0GSUAQXhMQxooAwosKULDOmWGKJ0axIGEwxol1Iw4fOPZU4CWfCnUFsAzCwDujDJgI7Nyir7GVTZz6DKfgaG/Uxo1szLU+ZAAccTcKBde2VkocKBBhUONCDaarqugNtfMYip07EG1HUQX9h6OgLUHVrW6Wg2OwvTZl0m83R01kWMb7PAN5l5vs68aHTmbY053SqXgOZPMtAxNXVNk6XPTbl5s/TFWPq4ucpLCwYs6QddoX4rW/HSPKdNG4ucciqu2YqVjqVZdmk0rLTakrP+tluaBQbErNz+H86Oe3yPxBOjY3UrWV/3xiTrD4yJaj7tRDWSpNzD/RXJ+kNjX3zeffGQ++JLVcm6YY82x9gj96EmKXu0aT8MhciW0uvYisLzuhWO50kp0W6UovNmKVhPVQ7f0sW9XYrZZ0rBfKcUx2eliF4dciM0VxVSz6uQuivfqoy9y5r0D4/JgyiDzJjmXlzU1sqLxD408dcOFoIY+RylxE1YoxYtURsZV0VmnfIrY9zawbylIutDAEXhIyjVFDVz2UhE1m3l+XFZzImtjQGv9ojYusFC8bxHGc3hOmaTUtAiDJt+6iTWVmbdH5VZL0yTWdvVVsrJV5wIezuXgmKLHZJPjLb27AFBPuM6ttN1LEWP3DVIHpcdEGDHU82j5cLXZBTjT70DM+s+K83fSSn3mSgv+G8XiMYy1dS+SmNKYUW+C57jiWGEYprlDm/OSLbxVMl2zYB7zkq2c0i2c70K11bJNiAv1jZ4fJsquCpF1LgYS6UsO99lb+p1dIxmqZB9/azKT6ykaceooHk76pAlJDeC5lpV0Nyn7fxfnwXN281l26qguZ8iUQTNEeT7PnV1DmB8i5lyhPMdOn4NmT4MW6TUXpy3Hr1I+THIkXeI+7THLEeuUWuKHDkekyPPAQhzmHSQlKYV4R2oOtABVD3jQEvlIjVh8NK8LRPOSY+bWFDKSTe3WrSpYcg1IlesV/25raTHbjvTbqlv43HZMfokjWZSMQfywG2iuep2RodatzNtuwQnev+S6vjl3eyn3XzXnZ/hGiVeuUYd9limrZumK26aNsemaYtiTNPZLXgl4OgRzyDrIRu4zjyvJpDGWfyxDKYmzZyRJbUJMrdMMhMxOLgored9FSEM6J+dlCpOqK2C7qEclchghoAOKogyzAbD8TRormSecjul4BCJao57yk2p48zTaFFzgP0ctXQWzxjTKcI46cshvJB5uU44Jw2Du6rZA6XYDlusnFPTwX/Gwb81TiZF+NIU0Ol5wYy0pEIwlAQ2BWJzY4SEWrJpAU5vp0Z5h5XmxgUu26uYBkwHB9U25sO3g20xfIhe9VPy4tG8nG4reUkdeVmaTl5mH70Q5TFITpbQg5nHLDmp0ewUyckM4ibIi94JHdmcLQp56Sh5WQTqK5NQo6wcipqTl1jykkySlwyRPIEA9w7NnYq8pN3ySgKDnFsTmNkTEhgnL8EC1FI90hYJi9A24pKeGgw00pJ81vHNFenRDiCsSEx09kHW2XRbhp3a0GmIn9ESNqqxsR67/BgJUEyz+NPt2qKwDy3Qnh2wJ9Ix9+U7uNle3azVRIRSEJ68+dK253otR8QHOoo1J0JplCKUnHZVSIlmysD9V0QobXAUc1BTVQFAm5qwhiKES3mGTKfZCi1iWBxhqTnCwuEZbS0tlxIUDWfIC9UM7PpmrARlRiUoiw7+2ZbwB8VH7WpmAtwa8WPOQcAITwUJsikkSQUo1UihRbOGFtUqVEhp0igRSsaIUEdpoJKiBsBXc+Br0Az2BADfIsC3SDPuUKrjEHPRIWastFRlKDNGhlJFzWUHmtkx0KwoamZKmvFXSuh82QNOl6HkusWNqYNt3awhzrxrmZ5Xd7sqlQPptrg5V5GhFMTYRnMVGUpuWBW7E3YgBDECrhQGj3LBlyZwpFniyNT+z431v8n9/2+PnSeYVZ5AYZYJxOYwJWOCuxPMBhSMFZza45Nyr5HJIEwil9FwBtmMhkV8QlA5f4IYAMxWkOWmPVRAWpULqFW5gKmT1XEBFjGtvbrG1MnYmTIZF6lhJmPTTLrO5KSLZZZWIqmT1zDpgGsy8XydeLXRibc11jTNlFOyNOOWhsJXctJy80vPClqUYu2D+S7hS4W86hElJpi0Zc6MSIPaTmCynSuzjRL1tO0qMNG1CQKTNkgGmLFU22EMhPkVa53atnJZWnYH+CskfK9XWYmoY9c0IJrbJYwc50fuKDsbG5dF2oGZsNMsUkuPcUbspGX8yUZXlsyIMsyIOu1Q1T2YZ5gFmcUWtqH8sc4I3yxTfmWZEi2LzsgaxUwFNqu6OmF7Ork6jWlZYIR8St3SVEJ70S5NOypLk1/Bdh8Fx9pCWiq1LDScSd5lzIZlih2ZTisD5YYBK3asRFoHD0TaDc3s1kOzrEMDyLWoiT8FL5BEgHlCIr1IKTA34653GAzLJyHSDd8RaSdcEJA6Iu00LSpEOhybbiuUKpFWiObqIQrQajpoTfR/KpHeAS2L7DFv3FL8KcxagJgS6UVqTSPShT+ClBUy7VfItF8h076S6Y7qWJwyjQYAT06jV6hVpdF+lUb7RFthbap+6eMqkVMynRqhwYxStlQpG0aLYqUdStnSE1A2ZCtlOP1rtyJtSmKtVMG3vlPXS3XttYpvlvBC7c7FQU+NLMDLje4vehcHWcXn226ua98qeQBveWsL95GeXwQUDLPP6m1AMbrvZR+7SS8Xp/+3501xERWQZ13Fes++pNbnkK8+nQK5Vd6VEA5kM7RVjClln9YLtM72xF/7XjjtUir+Ky+m6o1evZ0XsTEUTdIbe0XIsVeauIizvEyv/gZw36N23NBUbob4U1MPR+woEQrWIaZLgLYRTxdxxOJRqE5urugbR9vZvXoHWsyDbF1LqLWgTXrHAD96Z7zwDkLlnOSLCPn0CoRaHMEIVq89exgw48IH8AwB50Qfzr1P9kfqpM9L0SC5vYY03ZaFVWtMnTT7Y72g/oLHcgP8f7gb4K6K8gI4Xsbufz9NarE3onQID7K5nYOc68SXsyfvrOtlbR2y6m1tNMJc1v4Oz592DUF9LMpN+XNr/MZTyDqeygEekf3rpe4/mXJV4W9nEk+OVXzx5cJ/1srI3aGbAoLxd3k6Fd6LJ84pyLP8S1gyYd91Se0nJB1zC3dOH/QpcGbMEPqSwONB3GJ5ud6VgT8MH1fsfNhnIl9Ylk1j00Gcvngyx+4G3l2uGfUSZfbrh61cIDibsxVq/OzQLecNIBgu5z7OWHAlM6Z4wuXRPR8arut38u8FYJo42+234d8fXTakmCr9K/x+EV8c3OqpncFRQMDhX0D1i4MjBka77V34RGd4Y63wTY/f7Bmh8C86qc2UtavJDPURc5zEwL9bg1ULWXe5w6Z1CW6aiC/xhOUnoYi7UYvaEjuuwWoR90xGHdMokU0jqJNYu5E3UgU/NX6Skp/U4U2ktyAY6SqTZuL3vSTB7H8C8fRbKO/ehw+ZFmc/cAvi4bh5BFEap4goBQQZVVShejluv3DZcKgZsz9F7RsYNKzM/NinSLXXuBcX1LoLqHWOBPeJ8zmE3qt3m8x14uTMgHCL99UI7ZHQDb9457CoYz06eRe+l7tQeGUnxtuO7wXN+dMe2HCQO7ysPLuvH73fkymAnmN5s5/qcGtfJYMCF7DA55dTCszE5de72MyFXhPGqC7pY1GhsB64Ht+h4Z9A+FYN45bq2ySoN7eOaPgIwm+WsF7POhyUILxFg7ciyyEN9+ATx5cgwR2OBhcBEA0urQoQcTCKa5rnMi3JG5jZt3oQjjGj7EGXBKE3ewovpB7xLg42EUYnOf6YB+ApySYLoATwUABJh7L7gBdAC9DeWOgDjgeFNccXeUOWctnx3fYaKSEB7NVlP+7XfgYlyJ5W8mPQArHgcocOiZpvkUYVCTU2D/zzq1c/9LIffCHTFH+TDQtyyz9102HgpmNSXPDafhl/ZD+54DX9h/2iQVzg5X3i56D2Lf08ERw1kp4IvaCkpBZAeqESWPCi7E4sLtMzoLGZepFLNF8qgMljO66qTaYYAZjrECt26ghiWDyKqxiZ/RkgxZBO5fhbRxKkAmOBC/Q6CjriuoYpXV2tAGZDchGYVEUAdfmvQ1cbIs2I0nxsMXzDS94dlvzBIMl+BBMgN2qscfY3oEBKywa//0ZekCUheydyadNt4uuwWv+YxJuU7HOai4LsVoRYqJ5p+XZhuTS775axLH/uef6rwVKIbQUK9Pq4f1EgjMVFgbI34TMve30RvZaiV0F3gl9vfO0NWLsQHb+W4lep6cb/q39RsIek/OoHHgUn+ICAIsjxHW1eDih4VR6oG1PvVQXHSkr/md4NeZBqA/dCziDZCR+Er7qIKShDUxmjVxWcJun4SJLS2zwfDMUUH3his5M8td+i3jUHoVnFwZ8nub9lpj9/Q5kpqLqmC9yKfqcJhvuHMJjqEgqf+P2afvoLUYSmgdOp+oGsa1nu1D9RuzjZ/da9aQQTEI0Df/SqP/6H41/8pUuuwbXfA9/v7znnrDfRs65tG/WT9Q+O2e3E0rnlun6fXWOZcH5wYgU+pFFYvv03axgEW6rQ5f4hfJ8OpBjydZWKMIFTgOmQL0ZANp31zyE2TYnsnF79Cyb6UhgFPfebVj73ZxcuX1alSYmbekmVJiWOJiWjNKmF82WmSfwETcr+wthU8LLPIpTDZqYbE4AYlkVN84GByTD7S4W3p7ECdVF/yh6QwmKNz/7K0BPz+tdSfnt0+GCU8U6T4XPIcLRolGZIQekhKKLGcENueocY0DzBVGiUbYSxUuRZd7BoHN3IkxRrwSQjeSkzkokymo0XtH0u6Hvk32eZ4Cf8mQqbPBE2eSBPlQanVKcU+8w6byqzz6O9HFV18PsP/ohZo1gTqkY7sr+pGIZqm0CoDu3rlpx759ainAcFuITNWl29YNn9xGi6pKKlj7oajFVntfzkb/GJcZVLtezv9BWGjesEm8bOPH1SROAk+YcOQsCr3H1dM0dqbolpae8K1IZs+JzqsgPFI8Sug6s0JrXwXSYuZjMxPvYa6ST3ECON7Hmdn9a1Lo8N9zql2Nl7eo8XQOWM//Y7GGUPqmERwnZhIPy5bMEY5dyYIybB0pR9QfBTbavBOMlLL6khPzpUYlHJuFLYV1uiut7ZhX/90mvbbomhwKwtPvl2baEg/eOvY8vRElNa2a0Y0xmEKKKPRR0ios3hxlRL0m/FqhLcgNmD/oHAGYnJ5rDc9cmM9UDlPKFyRejonDGLsFlEFZK4DpJ3K0jegd/+OP596TLXNDEQ7ZTH+jAKHQ6H1+R+Sn766hGLZaGbj0aakf29brhhmvRLGhRj/kBFkYWEF/mwoqvei8Esytpf2in8B/0GiIxV3ofJotAh5i2e591ANf1cVhupnHvjK/k3Db9qf0m+mECpoMxZxS4D2T+aWe2h04U/ZhWbPLGL7eO/24fIrJKM/9eHzEAOx88Ru2kAGonEowjPDPbCSsqriUP7JHQDglRG7jGRvvB72T+pDAYVSkmIe0hrCtOfrRqTHZNNdJEf+zDRbfRVmzHEI8ujaTJhPT8GbwUpV/i9axRkX0ZNUqmWkGkJXZSgfrHtJiaRUHdVCU2IAsQk6T+PS/3+b26ynYxVi3FgX8iEenpdFVfcyRP+Rhha1nrzjGU5644msBJSZEr/U6Bym4qZ43Lea1U1Y+gO0zHA11waFkVYEVlfH8poeRRITZCj4TtTwdew5bX0Es93ZUt7VUzmZ7/1JgBQElzNiROdpR/xGN/CVzv/67EuKnW0KIId3wR4JZs3PJrk45FSDOuGVqEFGSn9Nv0koaYJZdQwoR4lCNVF2zPMPq7NMmtQ6bQ9kldBArFbjgjntD1Uey31Uaft3wpX5ses0/Z48LZ/MW6lY2QIZeWRNkv70RftV/Y7aAMQk+KtfLj/9psevQ/3n4rCAP5IHL9+KHAMO3ZrILdmtFjC2K7pcie7Bo1WwaNZXlpYVUKpXZdydBKywLrZl8eICjgjQl+Sd5WPCPSQyDY5Giry+Bg2AcdU5BFUxSUe1bWPAaQl9QG4tDpeSmlJKHhB8YSgRArElxCShITRVPkIzOhYlbFIla9VXpLaHutTSAMygTZgnUagx4GN7HMWfUPwEViR8bJiMhNK/LxkCbK/wVMJzG4K1dN6kP2tjCC/HjNzeQ9Ajvx/J/mbjmMs/XwLn0vh0SIc5W6bWEyYu8X5im2zJPhW81wnV6wgyR5EDem0qkJTFSrCDD7mHS3S8cq4FlTmmq0okaqYPR3hqZG5wlOnzFOHcmQRGMKJpk/lr9OfAQEAhzNG6wI9Aq+JTJ+b6DsXFXlovOAoKcSS40hhTDGTQvLQCzmMDtFAKSlI1Vw3hlLvmDJiCIXT3fQ1fcOz/Ya4xYdSNb7YCzqq4nXRpk7P9bxRclczpwJmc4tBqJUU7hf90LsxfjVW1Ynjoupq78tajRU2wGNfIT4w/n/9Z2Y3PjN8XREhco+mkaZ9BwuUsIuPQAqZ4chuyOv8Emi3OSWQAilP7H1R0EstJ+VkxFBdKvv3+oY9G0oMuCxpy3fkzVQ+0mjCZ/rJ3n9fybfvO/IG8jWp8RLdfmD5VNPzofIxfHyqCz86hZrQ3ICaAtZ6HoI2/3u8VG2zXliFNEo1FK+yjEyCMX2UA/QTvhdbPmSv4/sYxOCtQvBpSXl8JRYJRTKO/QxfGcj+TIyLRcr3nSN8HyfjpOvmN1qdS8xqNCGkGLxfPOLcX2iqS16pJpud2GBNmPKE6oMXSqgBAgvpIMSGuniTXrP2qGHkaFjAPKjft/A1sngv4+Os1THhWmxMmSmC1wd87AthZJzdguZzt/ba0fhMKwnMlZ0Ez1eHZokp6jmadogZp/3XO3uSgwcDHMQdQTk56HlkWPLPXzbk1I8hFQjyCyx0b3KF34+MRQrUQVSLmtkPcBRauxmIXcjNAJLJAJ4f+O0eXkhgP1UMUD7zjs/ddOye13/57V+p8REKYyoDDj81gVQbH/urMHSWz2iYP4QS5UyeDW59iNds6ClJJV+Vds1mP4i6tRpYPp3Dx7ovnQcqzMGAWtFVzx5dJISIrtuprEq2un2W1KIak6IKmocqP6Fx7w9Ws7ehQthv4uqoI40v5sxJfFs7NIfePLsvVA9jiJ1wnqma+7yom9wq+7ZZxhPjkTGi1rVtD/pFEiw6QhezQevKNnp3d8A6V3IDsw1jeAobPQArZoAhbTnJbKPUtuwwqSteMuYAlFlu2Kw4i6PommK2z63nEHFA/WUUsbmy1lZC3ST+u6ZPM/x69EDv3APsu76B8ntrZwf3/QMPg3Xgsn//UFYWHq2zeTxF1txFN7vkQRzsUXYlyta53+LHTPZDMmLZoI2uMfpIASFkn4voF3qK7c4wXyo7mqnU2nY0G+no/KPoKA+B8eCH3mrOJvHfNUXcLxjycrGllUeyoOl+Cnof0na91wUfVZGifN4jrnFwzF/DJdGMwcOZBT78AdCJZwHa6DNMdq8aJOU1/4fx8TJ1qeWA27aQLbZZ4O7dv07tPf4DiN4svQUOK/LV5aMPB4Pw5bD0BzeXEVW/XZc0afwK9e40EpIvXjYs4PGjR73h+p3rcPmonIZ21TKUNdOvwZFX4jAxD1N8s4GuUIglY1G+EoK4QAtDWtp4+8Mxskl6Jh5pfLNSv4spSYu6wsv0sh9B72EGmbCaIBp1Z7fqRD4TJ+hmfiJtbx5Lkf45trrYzE1+lwk7Eim1yA0QLTeRu0t4OQdnZXAPKPE1eWsPLEGZBa621RdkaPZbcfnaFr/21k3p7IDgkXTdU+NgKInqxhtCio6jOoJGIrp7G/rFtJEhB/O7SFvBT4/3ry9TQ8qpTnSP5oHh8/zmgV5EeUsmIhCWyRjQHH02pA50py3yVNN10Bdg+A3WoyA3QoHDSThRra5YdfjVUSwtTdimo68NfT0mpwTWSGiHxWjpO0Lnz+CYM4ztzFmTnsL19K1bnslhXZbBvl0XXXlRxi8y3q4o0vkUiyqF+CqRs2rsMooE3eAQYaNJMZxUNGEzM6A67GUGEOPsVX2Jc0qxwaUS2o3zZZn2iV6cwFkH+Jkm9gdv1xkZcG2cU5lnOLrI7kCCxAO3pYIVNOq9Pn7v8kHptZnn5HUpPpYdW6bnaTHu0spm9kdREIrlzaeJegeiUv1ECu2pSBZ8opxM79EKzxF5n7bnTrPcwzOA++6gKnTptV8BKiLQ7Aw/LW1lqpCRE3gHIAUcakCFIfla0ToqcgkaebSM7LnIoUZWHBD9nO8FziOB1VMahKpIpcpL8l6EMggezOcwGqgtf3vRQM1KMiCwkBhHX8jOGlql0weRAsmNb2+rj6/Tjw1T2jFknd/gssrEZB/A5qtUBvJU4ck2HhguumGQqpaqXHL4r6pc2c/j87JRj7ZF2SY+P5mR1F9404Qe0Um9Ihx7FbwiPDzVK8LQ8/zprh9Apkb9M6jY5w6/CIRFh2x03afA0RPNcLia4c1TMuzV9EAploncY/S1NHJkZ/G6J9CTFZB/bCxKF1ZfcS6s9Px1zIXVe3yvfooOXIDUMg0dJo35f1Jscr6fRrHJeX/66ojDFmfARBqPjVSEel3lMRd8UFblwGxTKNAlCfXCc4wIWPClhBIIh/RbcUwmjHGEpaKFSpAPD3eqE2WH3ugcwqgoqKoHeNMbH7se4GveOK4HGFb1AMNT1AO87vHqAXqjeoCh1QN889fEp9pr31j6VNtbdan2ujee2KXaPxkCG1QILPfeNwQ20FZBRl7EHKs6rfwqe1CK4SooWFW/fCIb/gDuIYfQFFcBHtSAwEwEIFMxt8H5q4EYw33mbNxWvnbunThVKJz7PFQ7rRO1aikTn4eWQL/VMAyBjFI4TqAx50CgA+CqmVJwSPCwIdAbMsHVh2nZmKndn96C7PdeLyjxes+HWy6l6pg1LL7GR1OxnchTLshTlpiBihmM2tUrm/UlhSwI7bnI34OQ8c/mKyulXqX0sUcjd6e/e+oupfaWHqU+9e5PngX8fv0bT+ZRau+EQ6lP8rcM/Xd/8t0LxqHU4TdW6ZPistqOK/1JvQFxzp/UG/F6cn9Sj52KvGmCiuytuJPCyxgVOXhSb1JXvUg+Y/8Yb3wCfUm9BYWdjEzlSpZ01BxVQqcMVXruVq6kdDTULhe/8mPMkdT3IR1FVfxIXXISP1JXgZnAh5NupJ5pGsKYWx4riVvMcQ6gV0leqSaD+5kuRdQ8UwSIfxYFTRZK16cr+Otxu3XJAzm1J9t6s9eIjGOSUKXKfJ1FUdecfCsznUdCw7IN2e3Xpxdbe7TFvgzF+mWxiS20oYWK4YJGjpFKoV3YwiMp2upVGHtbFTpFyNyp6ltTm2aGG7j9dls+o1YfM0pUbBEBcefw6Obz2li1TMb5fCwHnA0zHuce6Lp0SkMe8efiDLZLcyQ58wXT364Y5S5iWaFFLRTCIMi6emYTJ76NaUG8yYeio9Ci1pBiYLt7XxdRIrwhE+sibIiDVikuoTaSId21do0Ejh6AGFnDJylAnMrdHDcSDTMSZlHIOQbZGpqNItGc0Rai9SEz5nks8NLuDq6WyQPVtxYeeiMpprZ0c134MASKNloL+RK1RH3DpPY0tSWpWnigZbotDfmUlLy2brUd/0v19O11L5ni4VrnQLYVgQQILFbFilU4qi0hEytklLwLZGJAJqZ6Zd2W6z4Gtw7s38j+puLU+sn7nRiqlDMVkIuL22VUsQbm6TPo0bJK3Z+jUvcD+rZf3/bZZkaumVzEim6fQg7IhepboQkcYWkGVRXVtHeanfDHaquSL/sxJ8inUaEQoi5nfkYNQIXyPZrKIR4keSF52a0vu0n21pluiIGpcmZgXKju5er2mTp/XBqR8Da4iCzwkCCHk7BD+xPIkN2lwnWJBa804mpbPShzbHY39lpqemrFev1WGlykgqQUqiuwMgc1RYtFfW+EegQdSvsMF89fvMutNZksMiUmoM+b5YhuZO/RETYjrscPKECq1LnnSoFMwZo6MwRPaffBIpL9zSDgZIzWKuM+6IIvZ5YRxMORaiGSyek/t+2peDyWD/LEZKOk8q3fUtxERty38uSFQzhqrasoTUHCD924AjQMXY2BoxKNCU3Ma4AeJcBWdEzfrYglqOVi36OxziM01dJNuGlVNTX0Z/Q6WfXmtBLTwHqAw3FAnUKwXaHAMg8qWc2xqerf1YRpBgS872EFTQG27O4sXF6AWCFImM2Yz6wIEnEMSg9sJbG5Bmgsq6RPhz7EXqMOEQ42H1J1CJ2ToWIkVGv+UBA3MHyw4XLSD0RxgxdeHDPhz/oScl7KBjU5asrETnIo92H0aJMi59we6xiupFIzn2n5qcr4jEWGFKtFR1aHjDIjbc+EbiFulrKqPDuTm8sZ5NkbMIw26FyfzwsAG4DV/KDzbK1GtA9Bp0Oac7Jprbej8HQS6hZ5Fbk0RmkGjyRvqHg6sb70m+74qFVUY9CnlGkj+dQQcGTvFZGfhGneLKmBrKcWfZqKPrAqbHDiumeUuohQE53DnfAF6sBJe5PmwavnPepieZrVzXwT6zLOrXR9ug0gXKcmit12dnC8Q/MqAt8sMlMy8UnD4nDIUCXOcW+nrHAIkbQAZkl0I5dNSpf1+pa51JJYrJvg/hfsXx+ybvNrXn7FC3/5tEufvs7KubMgJPNgReflnjGjQQ+D3AMyql0N8gRGrZFhWTBj0s1+UsZgzgz53142BCVhPNY7uczCwIJtnmB2zMhxlIV/nbHS6fL+/KO6DXrMf9HEdVCJDN19UMiqRcomKjP+dYhYPckN0d++7X2xuSAKhstdEP04J3DcZz9+W+Cuh/7UG9310EdTqbswCkL30ygFKwyek9c6IXHP/gV75LGrnT+jO8XnYOviyU5H1+vQblq8UvfK7AVKbVdl36H9gZx+qaHMuiSB0o0D//G7//APe3/5sv83R7ZR1ccDX3rkE6/4q9O/fBkkKMr5DkVdRSUbYKPAYOvmn0fzm3HXkIVvSjrF5AJH++hivZMKcwYuR0/jLDNG/pBCo/WbgBPDZYV1FyTvBW1p8kuqotJRHUixTXELbirlIWJ40Qeb4pPHIeytMLQF7z2J/67sK0NghkWItN5c/lndr7n98ItFzVQN3DwWOAVkRNyFUEzpKYeSYREC86SnLpj+9+nOeyeF+LtfxFMCzhb//Av7ntf2MOhm6pCkKta+SXXisjfjSV72FjyXx5Dr+1TsfTMcrQY3ON2OqMrjbuH2FMJJPRuJ9OKKeEwNhUc0fFRsUFX5y7DcztbVjj/G7UvgK/OG2bWpIhoyNxlQ0PtFaQT7qMc68A2KHRX/nIOKEhELpHJ4pJJ5rfsOPUlQLcVQlmpFfUVd4UK1SnwLRJBQT/m1VEQ/mW5e9kCAiBDiehq6QC4rSFXKfGpV5xQtVJVawt52hH3KKuJjFRnmM6SHbCh3PzepfafYgguV38De8zbct1ynBt47Q2rK6jEzSt5B3JXLsOZkW5h8LfV+A/qcVIcB65U9rdrrWKm/8LzmVvKs7qg8a3cpzwIOclkWkVR7OFaOqj56dbYi29ptZFui5SCyrV/ncnju/fkXNlec+F1QOI9UvzQRbZs6xeVh4WC3lXIpkjspl+L6dCnXpSoDAijQCD65N0c6L0HcsQ7fuRURVSjTCFML2yjYhXvsH98s2HfLE3yUcqaPyQkKVj1IeeubTnyQ8lY/8FjFLp52zuVuza9y4XzBjQ7/hG4UBLZICX+iiPV4WDR8EnvOqmOLapErHuxeE+/JcvgaZUfQKNWb5S9mT/jF2+SL7zdfaETeGM2Yx/J13tQC57TApmgtN6AbYr92UT+IqJIp19UJk+BRKsFtrcL9cydT4YaocFKR0cjZsvdZ4WaoKzyOMCXRr3AxPtmFPv270VtR0eitKGxT3zjlspLblbs7UbG7ExVP3oly6ZIKkD3KSkCW7Y2obBMfqIifRyH7BX1VhfbA3YeKGXRgubrEP1nlPlSsmcPyPpTaJkY2iYtlTPAIi1C35P7EfSgIy/9RN555LBoBIobnJwWj96EiRzje9LWZvt4z3Sx2x08fOMnx05EnvDEZhFkcspacID2r0pVffOOJ6cr1zNgPMpEZeYUPEauHurHQAC2Ezx48iV8He3NvEJhbCZzneXpXQz0G8x6CQ8jMKcZCDy/zucePYE306wON9tOfCMLEqFlOURjWbTQgtyUDA5lfqMQ6BDr6/Mg+aw78fZEJPvMWLm2vlMRAQP28mcw9I7zx5ROKhGOJuSLpUXyd1aPI/lJnkTkdfnGBxGeZpTfE+in2ZsuLhMZkhlUAU2BSXT/OI0V/NZN1I2iitykWiQJ+969QL/LQaxW+K7Vg3TQabtt4w9jcKFrZa7+PG8UHbpgb0uUP6tBSK/uXt0xLAtAZOaVWVVS0nqQjw0dwYh0dqlOi86ciQT2ZVsWHUIXTqnhCafKn3ngSmvwHQQjzL+B+nUButZhmsLwu1v5iwlMdOkHDIDQDGLCItIPfhzpFojIm9XMcUcxg6heQg4hUR6WLRBGYgxgG6fDZLVneMga3EmobHwoz1CJ+dKgJmRROiyGUK6X8HWESKVaDU5kygpG6LZnBj0ZZ51MxRii2trRSUb8rbWo1EKnn7YZ/KyJ+q6N9KnGM0Ku8Y3kE0dwLqrcoZwU/O6AoKa4Y5LMpJRzI56gNtjXPsN9iqKlQFYJfGByj7MBT5N/fs+mSobY3g1+xTDphYsSdGjfCxsRiXpx7kQgAMRqBGY30jqhuHSb4/AxvALh6eWKbXjTw2tS9lWVH8IaBuK9TyIDc3ykq9k6PXSpmd8tbnOK/c+bA337u2MW7fvOS/Qd+cfMt8YOL+2zgInNA1BmEz+4Ts4XP7q/zaKYYgVSNTNNMWdi6E/bkbZEkHupQUkaW2wc0NusXzP0zKBuSq0l4gwcl2/6PmfbfM9L+I8+Y2v6Fn/rmz/z3Lu0/8J1v/eV/2POdCzYw+xjajxai/Vu1m79vDI6wpCOQ+cslF2kf0iVBnBTTQ0ya5Bk3FMFjQZ6l6Cflc3gnCK+ojh00hISZSArdGYheUclKfKSY4vLlmv7EpdC7nzEsk1Wqt857qXWugnfosTAr/6KCR+ActfHMhpwFgR6XPkNzTFBLcdw6zVOywaI3mhV844wYJQQOvOhXv/Kzr/ziPzKCr6f/5bEcqz88cax+zK+cq+Nt/GD9RSc7WGcB1ov0Q7as+niP1p9SOVr/ytZH6zhJXt9KCegvfC+YfrFYJOGH3jSN14xQfjTC0EaOoY0mGVqXLqkgGI+mCgDcsLPZTcguzCzAm71GX5V2+o6Zxe4Vu0Om9o6RjTRjUDKyYHdUDBIiTm+74CH8HIYsnmBksdl9GM2iQA84kF2PZf1RRrZyf3rAQzWqbfV+q42i+OJlPyfo5rv7lnhYjbDksWhv3X3q+nvBiP6ev4X+nj+uvweFqYdG9fc+PKIfowy33jdVNZlkmhIfNLYO5oHVdQ9w6lhR4gtPpMQXk28U9XSqiC5foo9QH8CkXzqhEt9HdDR+yvNDe6ylOKWYFst5lPrPCfBIQAhFoFW96iscQuO70QPALLlCQy2qIxSjMRRmv6zzXivAdzrWIV51+4QLvvyYcsE3Hr3gezkOtPbpcPPYfRx3JqS7yoljUUdDpRXagexjqF3oS7TV1d5feeOjv9r74VPHtV4pyXoPq1fVJnFN8qi0yqHbu5GXAtHIctj2myPY5vZRFOvuSlCutxXKDV74IihsfG0R77dOiHgfR+oTL6dSJyswd1HdT/7OSfaTv39aE5z58o3+K/ms4pUzNwavjG4Mrf+r487/lfTG+qb6xAdPaFQw4hH5mDEvhPD7K+F3OlNDUopylXk8UJQw8i4gbg/XCsVPRsKb0oH/cvZ7BBUaavI5Q5OpPOwpq07x9fkMJcjRpAbxH28EWsgAzq11UDNnLvMsJWDAW5QiIVU56pyAG52E1pAaHpDGogWt0iHOLJAmw09TD1MH/Aq5kT2Sa5dpKdLaSFPVBpbci9rOh1CqLXJwj7zNyXU6/goTIftdXdpdrPFlNahzc/ULUXaCh3s5iRF5NozvQxlJuiPYkzGIZjm2tVY0hUHpcoP5S+697VBZWjFLTfk2LDJk1TrF21N7DdspjuXxYLBJVU1RJ3U+tMx5ZwsbJxWJq9/iah/QN6tJ0ZDJJ7ceu8ad7IIcCwEbFsVdlicX4zKMUY/m5W4cPHIllB1E3DJn6MPLXLBfB0w+J4zXdJwM4WEATzSaMB7q0tcAuqhpM7erW9DtaG2+w0F7Z2m7OKPtlCqo8QEPNiahwtc3ZvYZUzMcIPEDWMxSbAAYOTKcl7UlzwzBpURfLxYuUUuytQjOnuHVayel9rYsb+JWULL6W0uoiZ+2jiXHzphN7axYMSd51vJc1f/lLrUzYO68bUWUjxmBxvySPBFRNQmDYh0cGL/KMyiaO8BARKt0g+vU1MTi8g53BzGDfgLjjNoE38Yhd9Ev56wrLNTnzuqUQ4HFBx6ZF1+NTe1Fi4d7JlCtJyEP5K9Rtoq9vYIGzYNN/2mDr70q6JG/8IjYExlFtGjMYBc5InOO5N5y/IKN34343Zq5ayNPQ+Rpklmhw2MzqwMEzIMXSaLTkPJZTURMTihLYwiwwIDLV8ur4mxIjX1rzvJbIlua/RZMJYNjRlx2yNyPMc/Vy7XEJeqFW+OWIL5asm5QVfSgNOR0Na4JsJ4h0EVoj4s8s4w8y0WeXUaeI8Ky/FxuzXlc3fk8Kufz2O1R4q6ct15Z3Ksmt54kJhfzRWMUK8ufLGYwJfd29AleZOFSIV8kjiHxYPgUKaZpLvCfC/K+jXWAaBtElPPSzSfnsU5+OoPhssdYqI8xEjPAcEFeACxcda8qHGoJToETLwkz3Gegqj4trzFRUld5CC9w1PwqQjv4g+AlCO3kkC+hJQ55CMnF5Z64l+jRTsHMvC0vS/qSycucvnTkZUFfUtrOLzv0xZeXrr6sCHiUvvmoEyhetGR+R7SiXcULUYqXWcIrFTm15Cn4BGSaJaLIomyHUAjlFDFyFaeJ3XYq4M6AaHL+CPoWF+DnqZJ13SsutORBLoA+leTb00ii/0IryUwl+vludYBanCaVaMW7JO5uLnaktF0kmXYTom1pbZ1fuXTCekIuci3tAsSRxB3jqiql1YhIMkW025UmaMUkJVTiSFixqIeJ0jPetCmGYD627uO3ObcYwMqnsNOaGd+r+aki5kWstEcXATH38YMXyYu52EsYP3ca/DyTKznL4OfOx4mflyjWXVLi5xxH7RP87HPoYglt49BFEpovcTYpcbZR4uzTuHk7BGd3UGIxEy8Ni5l4eZq++HixCLxC2/mlry89edmmL7G8zOtLFy92BixUsDmewOaFKjb38GLXsS5e2vKyW5E+M3h+msHzXcCACwh5iLF0Vp4XIvJSiwqZmQHF0xm1cgSeYeeDr6h6Gu2S+YB0BCTTbjc7SsSN6EJ6Kgcm54ogIn5OPFN2j8yUVKu/gC6tzhTJ+HR6hky+aTMFX+yanCkdnSmnmT6YmbJbJwFp881MoZGZolOEcqKTzJQdmBQ77EzZiZmyky5BJCMdZkqQYmIE7OsfDziKmcesgOWXbTwrumZWnM0FnmNmRffRz4qsOiu2KaXG6qCzgtGRMVpp9Tah30qrfQnNYQbonDEy/0WKLWpneLGo3ZGXHY5Qx5a4+/Ky5KZDbOl5r4LnvQk896t4vlLF81Tw3JJumjUoPlNBcTtcbYooJ0W1MbKu+HqhJANH//B9/+my6h+GHYixmy4QBL6s+ldcyomChlqdYM1TycZGkyhvpo3FGkX/0yz67xpB2AuVtCvejiwUtXLSKfpPQdi7HzPCxqK1bxG2Cyzq0jZEMmYIaQfCgvveqcdnC/RkkEWLXDsYEcM8x1NI0AIQZ4WYnBkSzCs5YwVCcUla4dHaF8Ty7WrelpeexbLt/BJbLMPLisGyCvp0JtAnraJPJugzSQwnF323gloipqRDR28UshwdnRpk1XOyhewO7AJ30AIiGSAa+WQ6l57y4oJ/YPLn1avq5OXJ9BQAaVmKWsxrtBe7i730JHxkGMxURGR0+iqdrwuLrrZsscNbY4i1ZT9MbU4T33XglXpGo7w9zSWRSm8XzVYqg4L2ZKbiMjmhzKiFOouaATT280XTzFOeajoElMO4ko8ZjBfGeqrpEBDykuWaZILzlJyRp5D5p/OPdRi0SzkYZnxIp52mwXU+maWKp86lCFyoSXAJ9FR6uu7Q9msR+kL8wrn1JdMSZIAx1hygy1BMrsVcp+maee/EPlo2TYIDQoHdu26W4NM5qm6mnWertuGixNW724MGdgPOoWbFGbOzAGWcoxpXzD3d14Syr+lhX4O5cT6dZ/dA50kcJAjGqc9jvFF57I2P0j9L9ZbjR/Hx18Apy2DioqKamRvcgJ3/qI0B8iF6Gb+v+EJbAk5A8BChMsIhwrw1LsWZVnGRzDlIiBRfpKJyDpJQIH1HKUgaEQan3wy5dGYvWpBfcbKjNaEACalw097eDyioaFaH6R9EXtuJRSunU76BvmAKjzevwVdfb+Sk5hYHtABLA2i4WyUtzG4CfPJYr2P19OpHpm8tfQuN1NoICHUJMOqzlEzcHMo9e87l7hCplwDRoMnEXKnqKDtTwOsmeN5+vkdW+FhrGuYqj8+3AfMmfBKCnCXQfWlRnS93IKKNjf7AU41V7J19xeHSQKJaEeedsZ7vqsJHCrEjx1JncONLYQSv7ZE/chsL2I+r4BAHvcQ0xEMN6nlJj4goyD7wWqSIuA7x6idV1PsgpMOuVNUkPHtGWztmA0xEueb+8GJnFMQ4RWwYqYTgqjXKFAAmSPNFgpuhykhuyqCRLR7fVdGU8BUOQVm3lp9o+Yd85MDRXZGhdIiNqMPtkCWiQ77wAyi2pVIjrdzngH9FX0wBQemhblR6kQppsdGSAsjcXSl79SqUq1eaaCMH5FRzFvjHHdXUsj+W2b19Wuxgn1AMpS9TXBzgUFRMPt8DmlNVuf32Lc2crDgrJ3IRTI+6sooNk64zYTJqmKRVI23SYyasvz1BWHvVI/XexIn6/mkGLwr+7Domp6uP2eqFHj2NEtqevV/+rlM/y/JHzk3DLc5NvfFzU9gSenj03PQ1t1RPsvT8Rk6vwn8lqyc333Kic6svgESwZnPwaO4WtaZcLWqN3CyC0PdlesWndR2/neRWEawEvNubeq3ok0ihUM8N3cWi36teLNq6zlP3Qjd42Ysgln/ifdH9/tRLS6grO/7GyTtLf6AHic+ftI3kD0AmlVcoGQVoGupIV+c6GIY8MF9QUDGc9Nim+ycmpnurMt3xcgI+6pOPnY9SvBid3i07vb+raqbr8YCoCA2QxIR+7pd81qA6CI+SU1No/4TvcyMrt4OCSaO8wRY6tkGmJuf87E8UgoaVwyMUrxZ6Dejzcg0I8yXU247OLKMPC9O8UidqjYDsmk2eLK1afpD9T5RPmpT9KV5UH647Ztuqpu5iQnMz010JEscQ93RKTwF4KdQ9Fvw+UAw/xT1rySOyLjv3ji6m7iKvW0wnYgFGgzZPnb6YykoqylZYG//H+Iq6tcbrP59E4xXrpqv928r7LElh1Xw2D3z/s956b35TUhoYuO8j5GEQnK4dhgOQLGOy/wkazJBL//xk9xI+87W/l4BKHuW9hD8bvZfw5xP3Eg5l2IFOvYNwrPYY7yD89bQ7CKgKu82vm7sI9219F+FfT7Xr/q9T1a6/OKGGzWd1YXyfWi3wtlbvOjs4uXrXsU6p31UTvXs11lJHnNXv+qsnTr/rueLAIcPy8w6j4/WJh8Z0vDhxRMmLQ9nnTq7k9dePQcnrMfEAf/l4ZCkPfEOW8kTJUn7M9yvXdmiaMXktCdzAxCLTo5okZA+qmipELzwZfKBL9gU19nuPvGOSZJ/BV7mn5tvu5fiKZ+yNi/liQsWRzIBEzuiVKiDrhhH5cmn1eZ3NXUR6UyYPbCUU6bWaoaktkgSuDV1fp2jDfbx+MaI9t5jmnruOWN2d+8pQfGKcocinxZqZqbrVjN4ZMlXjvkumERvLU8+LzhAnJuAXFWg9efl7fSEUUMOs+ZLQNLx6eP0H+3ooxOs/mtf0x2FVAJ6qHDz9gVc1rKLG0TwKJ4D6wv0bFoD/9EYLwGBzWj4FfRELjYuGrFIPuUsFnKG5SjT4qMwSjMS6+/zO9Hzuc9kmHa9KhNZfYXXSR7xYXUUHcqHEbJwqndSLMJboSO0jveZ0rKboj0YdYc2iSFs5EhdXP3JyPkxdb4r58Y+sU7LJzv3Ws4cEZnB8AtJvI2BnC0qHMKNAdfYvBtjUGdWcDElpmRUhydaVjdeo3VgFXnrEj3Wx2uKqHXqvNhETmWJKrwfRgMvL/vRm49flqvIWMXTjpdaqeR5hgdBNuWRUr8SrPT0croiNMApUNs+YJwZ3oOlnDWbGAzi12nQOUMoQA+o27n1M9co1M4or91ZiXRDidW4q4DBqfXf0PtsPPDaIJIOkCpFD/uMESQCQRAKS+tYgqT9+kKCtJ4PJj/iRg8mpQiQdZCMQSR8jREIDkRAQqQMiKqJWiKg7QQOQcNDcEiAxABKOAiSs3M3CZpAbKTZQwF0BMOnJAPOVaVTxGMOjJDHSfB+wdjc1wQ0ezb5suLdIQ+vTKN2NaiNW3aAmxgTYZhEO8Z5twOmP8zhUVtGwHaerpLJo6PLEvFxJ1NEiGlY2fXdy/FB8K7lCxourcXEb6xhcJawb6VWeV+26v7+y+pK3rs3dKDjM9XkTzvd0zde+qPdBqKfD0aNneuo7wgjPboF0PJHQ0YqDfriVcO3qpBWYVPvIb9yK75B/n7yMXJCJaEC+gerwCRCr3K0Onagmd0Z9fuIGqS+bJHFCgz9WKOcqYJ4dAw03qupKXa53FBiL3HnSVHsrrEjF3/tXts3RhldJh3KTu7Yn9ns8UxCjM2M/v8s3oo2CYp6rF3wp5oXzNPCyaj2pwsrqXbRyW4AB38Ii6letmXpf7KLhOWYTVe2ko8CKUdSnncQo6nQT68oZf9b3vFePmvvlo+IM588aVvcSCMPaS9X4r4bOgYEbCe2F3UGhYdYEsD7OwQNpnu5+8GtcUcCi8CE/D3Rj/WYfTPVF/iF+4ovDvhZ8hFt6RMOcR8y2I8zpyKOlH9En0uSJ+DP9t0nZU/dA79TKOItWfgc/8cl7/Yv4T8IcZ+P3cP4L5RuE7+LwXb4QauT19Xut+J36RLoHDnfTh2ON9A6PZe9uL6tGnNVrbWB2z3pjKVRWiQIZS9yKE6ONkkwxQhGJ4D+7uep7MCi3rgFedfOCrSv/V926Bsba6JSrSYdm3dY1HDw4YW8Pg4dWSIOz15ZeB8Otdq23PAavg//7nXr74lh3uvtRtGFUYPied+PfX1vvqg9cBmnNFThozVD0Vru5oLKbE0tPnhrsXObPPy2vf4LMy7qHO5yRP1XY/FAHsAWvWFOh+S2w2cDPhzpi2nxzxNMvyIdbBXyqu+UXTvcTs4JB1KkSJZjh1J5TotsEpIXVtHplda5XrMxQMLGve3BiXzctVtHW7OGedIKTV+Bv9oY3jQmK3+l53vSzV8CmyrdoLCA1JfbzU2Pv64we32rscRcr9j419mOTeV0rsxq5jj7m89y3vWlcuLO7esCz+zGYHv/OF8lnQfZDb3oCTY//8JsegyDpXf8aUtafedOklFUnw7/SQfDPvulE4tX3qRWy77t0JuCrg3O8F2nJ9cHolSm/e3yF0C/3a0WUxxBYtqq++PQS4eEPnfASYcJY+JC5OIjwA5Xwve4SoZSSwi0Va6/TS/KGCzZdEBmOJ1AdFltZcMBnLbYCML18Bg9Suxvn5BmyRavIgvNgvIX2DW3IsKIWs9Q5KAhAs+aC4tzBYp7mMdSyQ8q7FNk7hws0ixwRdYj/WL1lHhkWYdHzoGZecpl7NIsLivM0h4RtlIF5zZetWeuB9J99ANK8WEwDfvaAC0v4mcOoLa4O+NXcS1xAdLdM24a0LtK4qBYQWO8lPohSbZHUYeyzG7i7eVvW54I6KKM+WG+wujOAws/tFsis98ntW6QZCleLnbiTSAMvz6H/ik4UtEyLMLiybTXfRbO0eBCxu/mT04L92jEtiSLu2HR8CDOaIzydYRjhQ60+i7nsf7pc7KfT5QLfGVCfEl5okU7XC5LqNnhOb+2JoXgi2U7M0yKu7PHDXtnr0RySF6GB25U8C7i0o1f2Fiineck2z2EYZl2SmYefjHauYRCwTT5NNCB7Mo9RXkJSFIQKYl6+CyVxFhRm+R551vIzFRRijmYOI04ReGiuZW71kaZYQD7zkS96jzzoGWBkq0A8yZPQnmqSGqWZA584NyBAi/7/7F1HeBvJcrZkgQS1eOASM4NEhOoBQQBEonKgViK0edfp6PuRkpM+X5zpcHN66eZEh4uzLs4vON2/vTnnnHOO/VdXzfQIoAiFF8UNnK7GTA+m+/871D+FjpBnn4OZUKUQGA6p8qYftdlLI/fK9lHr0EZ2MA50spF7Oy9R10XuCShNSDv/E5ohmlSeomRxENinYBRTjZ/AjGB+y8tqjikENOMD3jeAug/iaLYC50JcQUzOkEp4uLhPDcq5bafYHtjnxNPCw4qzWiQfTKipyen//IOcs+9oTRHKBcxcqTReBDfq2+vsn387Q3maID2xaXs/a6JImrqPBkgP+CP8F+fT2nf9BgCtDZinUfox6hY44iffOqAKzhvShKbJU+0Tcvq4ieRAyMBekLbjZPAEhNDlCO3anRXeth91EZDbpRyyDNyQhspo1LIGZ55D37JLm94kaodrRgDnvjY32aoFXBxh7N5JfxQosnCzdqC2bOaXwwFQI0DN/UgQELDKMYNdBwYkY0kCflu0ai7YJ7pob3zJ3vCSA1PfdfEmB5T89rq57GJI+XeDrtgjfjfoKi9jzDWg0ub89bq5jnccuBczN2yZJYkYvWGu2fNu0BWMgDe5pJJEFV5Gn0yIKiyiO4rsYe0rjaEbVCS6bzeMvm97OPvVeraQFl0z23TdNJL+KiYLpgYBSQAxN3kXeaAbclJ25ma70lMV3dulBWqZCgc8bpuaLfHrjaWgKVHZBFTj0gPMNbk76FMpSWOwLiEVDyjg4wRoAQGcLgjgagZFljzIFQjHU1q1OHwvHw8tmmgwj3tGfTzCn7E7dzXeY8gqycbE106Js/9Bs9M7uSL6fPXv5+Mp38ndfugyV+Nxpsgh8Ul9Gh9X5ISZxVf/fT7uuyJHyBy4zNV4kilyQDgJV3pFloC+EgU4BGgX4DWECyacwdeCkFlEM1eozMcy1fhY05faixLlQBGiHJo4NGmbzIEFRmO2i1GxhzN7RNl4wZtpvCBDbgPxgoy1W4y1jfuxpY8dDwimhWIc2rwDRmLOwRDh5+sWhh0Lw7qFYS8Lw97TwXCbyNTIWDi2TYM69nHqpgU44uFNiQomoIaJLFCr1MLdMlCsehCNkvTAg+6Ecm5Mi6cC2yFabSTYHVPExz1kvpIFcp/yyL1NExogcSeFdXgQV/Qc4CpPY9pDAtBX4OYBXAB1yMgXDM5DnlGEPxMF/NCDUoUmjHTBvUKpkn6H23QHN5go4JkeI3qFibQI8BUaOQ5NaLy4SOFQFvBTHgUWA76yDOAjHCKq4lBV+JcB/7LAP4U7jgVq8LFBTT42qcXHFm0D5NtKB6IQwDU4GGrj0KYODh2q060DC9ceyNGjdVy3ThsaIngZIYL7OLyNLhhAtyVcs6k8BmjTRhpsIJR1g4j2LRPqIAWn1i2CZ5YTG5YTt56eE/QoJzZM2fKhZrlQsJxo0Lp99lvCiwqVTW4BN0IM1sdwI/C4EVLOddsUCC+qHi+0QUPBwYAcpDWfWZbgG+BmTP/I533xn3/1T//VHT2i10V3m9e5DWZrerREY4jEeS7aIXFEmjtZMCoMGJCEUhOaDZQunKvfj/Zo4Ogy9YEojzPk2ypT+MRJZrzIwrqEqc8crAW6j0W3hPhVgO6KoFs69adE+QYRfpaiTQa4rMOqUwdWh9ZhrdMtWLcs2Algn+HyGe1reOFlrBQ6FmIMb2M8bDcZ2537bg3VtojetojuucmGAJMaFrZ5M8ARHSvPIbYRXm0qFn5l6rl5BB7e5Ly5RKRzCZ0/+J22gHEqYBz6OJMu2G/BQdKdStNJ/5tpswnJmJ9fts3QSlVppZBrP1xyKN4mwuDbJMMtB6tFPVg9aqD0BrVxQZs67oLrdJlufmls/2gwIhZn1+kmFe+bIk9/r5kcXUEw4hW6iot0Dsp+77xxPx6HafIxq9SHUHuRONLE+zVxuMLjv+lhFkeXaPfBfQsB1+wNnilchuBMuIX7JRr0R7YBr9E2n1h2X8YJ9egua5QDmorEPoSCLLmq9jK0e9mtdUq2l9PWp6JdK0rz56hm5z7W2DcDaxQsV9iYwF+FFIDBx6EbzSoyaod85CEX4xwe2rIa4EDPMNUhG1fh8fEZxjQM5xiqkRi7zw7x2Yjc2G+HNS0F1nuw7AXO+kVYOjIeO5rzdDjGSWiA5Mawfp9/KX3FjgH80Odsb8ztXXVeFbdWwYcBPozF0YBlCuOVM/ucOfEWhxOmAOWRxjLQ/mcGTDJ/NSRbqNMA12snFVnIm5w9nAULeMGGWeU23AbONVBJ2vOMKTsPyaoljnMa8BK7yg6CgIc2hEIpVU0JwEhGN3tLFEMB+qZA1vwSY7lFFeehQLG4xYpb/FUT/0Nga4VyUnz6aPApnFh86ttZdb4dAWJESL3ML69HlEcn4e69+KQvkpP2KXJySuAqKesJojLWxdZDYCrsjHrJVLletS9XYt2LG9zZIGgfl9s96V9iljUWs6yQYVkN7NKWWYZlBZ9ltReOZYqkTyuWNYRlhPGicY+abM/I8aAszWuRbGoZ4lWEeOGSxAtnKEaZUQEOKwnxyky8EMV6xAuXJ97i4p+eeEFyUjBHPC2g6hVQlQIC/cy7rirXVVPCxiVuESrNM7emzC3zj4SswXnOFMUjNYS3TNbPT1yTOfdZD4EBAbxa24VTHr9QPAZ1GRvC3hOGzdNhs7TMsHneVDPk6/FJJWYY17ZpvkRNJ36eAQvt1qoN9KrJZLZp78hzGTe/LojMUaAQvUCOJ/KUu4cZN7dQUbrCiGpUtk5rvH4KuwI/LtXEg625VamdCGLAA3A2OKCqNdiv7yr87L6TvCK0cYUCl43HwLNan7U4uwN+fmlT0UIaMNwDNmd5Ni7MqhYcct+SUAM3tFvxs2iBb/YggRI5JKGGpICLrorz5pIt5CK9z1xwVXzOOZ6hQlrlzFaxim67v3hk7qYvUuw417xuK4/TcQ3qg87hr9wbgia0LBy2WM7EH3JvEdFd2jlKg/4CDvqjnNt30Gy615IoAq9p09vUYMfXCgTCip0Veb3gr/eW14MPz8/rwR85WQ/+sY+kGvB3e+lvQ9rpwR9RPfgQYgPrwZo8nyaTEz5rJGFUwfOXhH/oI0tKwr+fd5Iwet0mKue5ScKHp5KwSsKHn2GSMEA5LwkfnkrCL7gkfCiScNoJxy5pyfsYSRhoeipJGL3YZ4QkLK7cYyXh0kJNIY8RQyTh0lNKwu9/Akn4/c8kCR8tkoSPnkkSfrhIEn74SZWERQsWZfhUEv60lITf/5SS8PufSRI+WiQJHz2TJPxwkST88FQSfsEl4fd/ekjC739aSfhokSR8dCoJn0rCL5gkvPKcJWEsuaJ0c4JPkiQM9/RiJzec1cc7ueG6Tp3cD9NSUG0ZJ/fhkzu5fz+9MZpjgSR8+A3qW8Si5VvOHLgVC8wAgBN3tznDEeAlZJE1P0fMb2EH+PvlvL53nv2gL+ct5ROHO8P3g2PRBWo4PzgYYqoZ1XjFU40PU/c3rMe4v+WHB9VnCZRbZop7+hzuAWou8n6fXcL7LaWr0wGll04sXd27Sc0n23xF7lZpFqV6MD++G8DRoX1y9eCq0kwptryO9BlCsVOKNYRiqWQMG/BVyfgwlYxhzUvGy7AuBC9C8GKhYnx2sWK8LOsWl76QdXFpnneAsTKvSukJVfLzlZGp4DtPzecv+J4S9ZSoviYs9HyBB8XS3KD4XNXelXm19+wjau/KcWrv2azaC3uB2nt2Xu09m6i9Z1E21+W82svZp2rvJ0zt/U8X/Zu3/79kf66rYFVe+zOLX7Nujyv2/6zauzav9v79yWrv73sK73te+hdTtRelqKSgaq8kz6dJOeHJ1N4FX2oDHTl+uQiJ39fEe5r4RU081MSRJt6vicNziVZcSrTikmjFVvYNKRSteAU4SeTfMpWyWjGYBXGRwnvu5Gp6co3Ji0EeH9RFK95MtGKuQMiDYbKtaQ3kYcE4gPRUgR5cFa24zMRKPqvjs2heK/51lKpFzv6YLWiwrMCm25qyGmwaTkw2TVt+cpL7JZMGKFJ3Bdj78aDttmwxFWZDWRXbgglZWJV+pHAfHQOLt5VHdznV0rDfD197Lq4SRF93z5DqFN1Hj2tzeZfTkG8V6C6nGAFMTnWtEL80FGJWIl2V/wzJLqfUFB4d2p/5anlauR132vJOEjlognfGPic6wNjeuYKG69Amv2IU1yGKlahyD7lde8q2PTV1bKZDMkPsZcLxJEW87xTxPivig7S2dxJxvEJ9XxwPfHG8IbucQiSGPm4Pqo/XgBJro3eO+JwyWsfp42WKKeTTQpsOrT5epR0q6i6nnQPqoWS4MCCKB/gTJbucluWt9hrvcjrkI2RjVIATKgNPGS9T4LY5hcKKDWtSZRw0E/F1mPmIuJExHgcyHpft6amrSXc2qmaU8UGqjFewfySU8SY0yK2MMo5htCfKuKMgPMXY5nSMry6PEcr8hElrycaFOWVcrAlFUlmB073jGo3dA8VDaqvIPfJ2IcUJJlG/iTS5m+5LCkCeQ5F4r4F6PM7m0ncIJvZ7LtTEh7YI++evWARHesq7o8JE6bTrPhohPUo2To3zWu+LNXFUS3oGKhbw4efuHlAIkMQ5eJRp19swFTlDGmU3TA10voNupKCrjG0doHtwp7m8GNJ4LGuijDR+gVremNjkuhLEiTQegojoW8qQxps8x/sFaOFAEDJCzZAVWNqlENCWiuMrPFBdTMesS2nu5TT3Spp7Nc29JkmgdZtWrf59xu1Fab/eTRXSf1GFdIxDZk+F9F9dj2/haH+Q/RUnpBsR0t9bN7chpHMXb/qoVPt/15bZN8ae16db6DvucEmBCOl7GLA2IaRv2vGNhZktum0KMtu+aAK6xNUWUgGNX042+0OLeXv/6VwYh1Bfz9QdMbu41RZ1scvfFmMWabJZ6wdIDTBte4BUAzNGTu1grsap2H6Vjv0Khjrp6h7GjjOqbMTOqLBBzqhT3xoDZxTZaDujh+qRrrmos9Q45L4q7wSoMhtDqhOTFybFIwr5ONVd2Go0pLwzIOehEBpR3qI73lWhZWyBTsN5YjIV4338mblzV+K73g5vIc2Ir92lu94Ob1W9C18+VQFml+/ibj12mSvxLFPcmPikKc284iJHanxpUF5lypErbh+ZQ5e5Ek+94nJgsbXRpXjFAVnGskeIhwGYOiBrh7qOrAXM2wu0hcwt2swq7ndSxZ2x+SoU91eBzdfswY75r9ti37AQbQhEL5uArghEG88I0Tcc8N5IIBrbrNcYols29TqnNm3qVU6tJ7AtJbB9M4HtW/brDRi2AyopOGG8qeCE8ZaCE0Ys4IR8RlvO6LCx6YwCG+vOaMNQEpAH6MIcoMkHdAeGDsttGBEbU4f7qkB9V6A+BgL2KWJjRjU+3kXm2wqFqpAgfoemNELiXaVE0YF1l8ZMCXyOBJ809Qmi0M3TXZodu2vrEH8eT5Zphix1d/99ejtDFj7zHXqXCbiYLPs0nidLxZFlV55CyTJ1PBjyAyhZhj5ZhCV4heAEsgzAi4GSpQGyNOgNZFrcqQK/BwV+HQco8OsgBlbCm5YYbSHGVVvgNSFG+8mJ8bJPjE3XX2OMcMSwiLSgdj32pvTiO4Adp2KQwNEGcieToKDorsJQdFfYGKTddUG7+CIMRXePDRJGeFDvzEG96EO950OdoRBpB041QXnZQ7k2V4TJEDmwZTt3hexdfL5w41a0O6Axpf0FG7e+bT9kJLr7MWxmpLn5edQLdQQ2woBdZcA4A9m73L8LcjPDRS4hnjJgHrJHTw1Z0XYFsm3gqK2bcq+rjr6HFUXDvapBdBt9o8JrwDu3jviIfogAnR6RhbWDW4fI4gKpQtK/tt0iiAwVdVSP2OgozvrWKCjOYPQEZx6AKnMAqvsAqjKA5nvE+cE/HUe1I+PeQ3u+bM1OKb9czcriRWp2gJXtgAiZRA2XeZv26M6XxvaPv3PrbbqDSupyUcbk6BYWTLfoFVykk8qsMh6oZyQniaMcj8GGsMimm3RBVG/UfI9H6z2o3n0nAxRY9daZmjQBbiSefmwHi9qG44DYG1KECCPtIK5CrPulHXJU10YZWqPiGoXMyPn/Izam8PJnG8d16TykxTMq8/EuMjECwDkEUR+tAh7peDV2n72Hz0AKHstmxMPczH32i/hsnzDooZLSUvRFAXuBsw5hKbVknjZPbNcF4CQ4qtIbywsI7C8IDlixOsohGUfs8B9JjZXZmyBuT+DXC/Fivz936Jw55MxpugwEAJHOI40Fn/0PFZuJN4pohOucBhQILmvOO9umgvKsLHoN1sX2VPh/+Es5ASyS0ajmJDDCk4hnXQKqMn77mjVMTYYiWciLI3ibqkB2GhCYcwu6muMLlx7M+e3FT3BS6VqnWp2p377sbpVmEZWd3z50j/+I376ifvsq6xkvwU3izYGVLPfiHovZPSpQPxWzDfUWM6eYYU4F3xfsWYY5RZ85lVPmfOqZ0xPmWIOod48KKoIxuCtCJotPU8+QqSpkipYjUwS4Rwr3KgBYVTKJCBahVI9M0dJkWlz6YjLFwTydBKEyjqYn1MjLT4kWB2BumYJ5xtV9paxOaxJ4Kq90C9+oP69R94igUYdwHlHhBeHfKf9AOV96foGHsGCZIey8qWUIRXxSwKxx0nNBlgCp9NxBP6eTRawAYRO5uWlPJIIeRSI916mn0jPqvii9U5nqVPGk5yp7iuvi/NXcWgorkZ7DA6rNSc8sjgF6VKVQpWeddOf9Sbe+yCM6QsfbMl+U4+tYlesSIhCc44YiPWf3zFeU+NrzDXVt37Sl3LDa83VPey4foz23Uu25ia+7vPYcLtaeW9T0tOcwqz1PRHsug8I08bTnZsbPDr0tDh7Vnn90730aafy+bzhndefPtbrzGdadl4gz/qGPnqg8f/ijqdr8LV76n1PlmUtJw4hPijN+8EmNM145Kc54JY0zRnpxnPHKojjjf07jjKGtPqc4429DbUqRx8cZq3TMOmbT6ZgtCJhe79CWb0xOMjNGgpNjCU7upMHJW1CERMco42m3JSAZ3UaPA5KR23dy2XkO1TCaFJ302cOUm9Ryq9uahCS3qLY4JJlV16eLSu4+Jiq5kUQlF5eOSh5KVPLo5Kjk0fFRycNniUquwapRe0FU8hiyVS+rvY7h8BD9izFs+dBnoZm24cMZ2wjlCZ5CnggCV8ROnBKij4sP4iqij1G9oN2EtqgE9bUkkwnqkCRHLjBXX4vbopy+EkeECwMRYWO9YBd1kF5wLr2A6Y9R5ZHo5J1FKMuEIA+RHibRySOYI/fRLtK7S0cnD+ajk2skdTBEwOVjH3aK2x33dFBnSxSpOhvRGoYy55viuOUiZiRFl9WFONtdFLd8IRO3PD4xbnmciVuG/WRxyxfTXv9Smns5zb2S5l5Nc695Mc7146TZf15Wmm0/Is1yD2oaEuOM+JCGadvzGr40W/Kl2Q1Isxg+DHEc6W3TSaTZEl3iSgucohMl/nw0V+renwufzehe27jVOm1D4VrnGRPSLQ6NQqrLGhdSfda4kGqiG+cUZnIxT+5i6rtFbchG0xkVGOlyF0bLGTVqWKPrjCIMlQTWUD1z0mwga6u1VK8aUs3pVZFIs0FWmq363llZc2Sl2Xw8eaw0O8CfHXX573su3IB2aOKk2f1H5aHgEWk2n5FmJ+qA38kUN1FpdscrLlwkzeZVmh140uzqMtJsyV8OyWuWMaga07ajagfz2k4a7/lYaXYGaXYGbFrFDgrUq7bY1yxE+4k0W6IrAtH+M0L0NQe81xKI9mzWXYbouk29yqkNm5pxihLYmgS2ryewfYN/vgSw7ZJRcMJ4XcEJ4w0FJ4yegJMa1hABNmZjQ3VaGOSMLRhKgpYH6M4coFs+oGMGtOhVW5SoElOH+4pAfVegPgECBuI+2KEqH1mxf1OhUFFp9i11GLydkWYD2qXJsdKsEkSl2X3aeZw0exJZpj5ZHHsDCOIZsvCZbzm9drCYLAOazJOlvEiazS+SZleX0LkWkqULXnSVLH2QpU+vIdPiLiPNkkqzBGIYW8SGJcaWSrOIVhRibD05MV72ibHh+muMEY4YFpFkmAR9myJONQE7TvVAAkcbEWva1FF0V2AoustsdNPuukN9ZQSMZsqIjvbqsQf1eA7qRR/qaz7UGQqhduBUFZRHHsoTlTOVZneynbtCdn8JaXawQJp905dmBw42O/TmY6XZyXHSLAKifcjuc/8O5GaHi3lpdhFkj54asiI7CGS3gKMt2kCmxUZGmu07abZFt9E3Kry6Is12RZptATpr1GJpFunYZvUZUJ2kf90SabZNRR3VQzZixVkj1WnLbKwJzjwAlecAVPMBVGEAzfWIiwb/8DhpdrKkNDtfsyrNas12MRvtUguZtkJOkGZRSdtcVHspaXa5oGUWa1sIUfbEWrTFWirWSsxWh5ezOneTRnnE5V2WeKxUrK1mRfOS7/KuaTMNrVFGM3libTjn8tbm4k6eB7l4R1zf+8jEmKAhWWgn3+WNq9KQrKEb3XZoHwmMTxKShZFFXN5pKRqSZS9w1uHqk7u80xtrSBY8CwifgytQo7PU5Z0GZ3lvgacub4nICp7N5R2Ky7sKpJYEqVUquYinDsWf3Mjj+mdk5HEBfhVvVqxkuRevsVi7Rh1qpGJtm9YWM6eYYU5ZxKLqMswp+swpnzLnU8+cNWGONVq0do86n/SA4vpnb0DxeX3Vfw1faU34Ro15sXaNWklAcavwgvDvlH+gnC/WvsBDWGn5H89ICdVK44RbTqztyKIglWNi9HM6WcSaEDa13Gx1TTSFNS9OeO3TN044hiGrHhVrs3HCwPnxYq2gZHmx9thA4XdSsXb8XAKF36Hx0wQKjzN+98WBwv/P3lkAxK2se3wjuwQWSqjSUvmSyutWdilQoApLFWtv28ux5/7e9roLlevu7hyu29Mrx9tz3d3d3d2OfP/5ZrJZ2HJaSj202UlmJjPffGO/mUwyAXRuFT/w7V92cyPrP1X2WVbbRsu+6dlhy5Ld2m21W3vgclKw/7frv0jtB+0UV5QCvmQDe6wjdOXD8l+s3C04WOKQzW42e7/Ljs0IEjtXY0N8DtMu/k0ptPWNNlnqHigH27m/wEqdYp9/T7by97tsH5ujw7BgsH9s009y1Sy+xB5K8zhUOauXLauhcvYu/ppxhy3B2AjGE6NeDBK35uzfnHJz8WbsH8++3fh+4fVs6cnG0m96qraMNgV/ydMqNwU36pJNsvFjy07Ztv9SeBUHcVUaLe+enS3GNO0qTWNsz4GPluBfNrr3X/VYeCYbr8yWFQ6R3OyfbcuOJa1GJ03FjwKAbar9V8b28W7QJ27oIXTPhG6tT6UDlg1P5tPsxcODDsjj34IvV1e6K1eIMY2I8IissRS76VW6CGL2jHhjdVzKk2mP0jISZjHIQ2HMoNbxz+rDlCqhXkBS8ZyRcsqZ2NqP+ODNhZ0HVbow3DCD3M7IBt4W7vOLxzizfeIk+b+AgJQJPAYY5T3w2KS0KJyLKac8SzXlnH+aZTlG+RQrV5JsB0VGdmKHVSeKKjJtLtkoSYgW8kMP+5HPZEnBN/XCwaSFBVlQ2PxXSLnjpAaWyX52ISPM/1yIfdevr7bveqZv6u3X3cO8A3vgsGgZlAyUg0xs+3V3qu3XM2TrLdZlD3suQOxPDFcMdvPHp9x+/dWy/fpLLVQ/zgIpQDVSBj1TC2s4ZjTuLCGCcXGWxlmGf/zXIQyIL8WPjRr/9VLfdXCq8cJlDV9KEmp2NThUAwvon20as+qC4/Z0tYbu+OQQt1jFb6SkfQ9rik//I2+xj+Bq4MFVpfDUwr0RggQ24ka0Kdnav5fDJCy+QcP/BnhBi4RATQPEnqWMqlTIrSg+Slgv+68qgKrNe0r0qGqrizIrfQZH9BoVEWocLF2y0KUi63Bh4yK0OPAowmwrYpES6b8WN0eNK6tbRK0vt6F8Q2Oq+L7HsHr8J0vPGOIOS8p2vMNEzKLQiobXO8OGV3q6RyGDuDxCOCjf+iepRZ7qRWHnk6PtiNx+OVsRcI0NIF+6GLAdLtAT8xQvPyJg07lfmGHgIc5ItjjcEnK29iNeNCG7gwxTQfY/jPCO6u2FP12cuzJES0cVhNUNC7bHuSMNn63qGRo+VHVRuyW1qiK7s3uQRl9UBm6ARxf+TUzsC2emtWOhRHOw0iWcOSz77aaaObzSzObDOeY92tPNVJgJajiZx121wsyLui5nk+NrNbNhKfZCzayNWMn/GvokJpoUCK1UHH0gWnaSe5tZqXZcwzZr2NYatqFhFxq2yRUN21rDEuUKjotnzDNk3wdfv/iWiqiOLTtK0A35j3ksbNg3M762epLyhOTjUjUKPNLlhWowU7JeAUDeyIdvelR26+b7yff/W9fWLOqvDxCXdrKp04av3zgl9EZbw9lYw5LRsc3RzScHyawD4kMz6v+PCsuR74zYJeiDTfQkNvo9tPqulGOv+AMOuIlm30cnci5bfYWtZhfTJt3z2OoTsNLX8/n6PbHrBaj1GAxGNC0dVhNLilHiDcHCmAsWgPPRgqcHEK8F6cH3raSI4p3Fogvc9sLFEJutMDNvPShcIhiOhOGJFircuP9NJcJiWmCSSs4YOy4cf3WIVLNgTdFGAIuQfsQTLIWyaImifRvPd3XQWjc3vBoxL6E0ekeuhOhS+lsOB2mjxCbS+rM4usCiRcTjl0XmfbrZcCNLJ3qMV96hKVSSI6NQHuySzqxGFjo2JCFnXCUa0bhkIzw7epg4m1Mi+5YsVenFBA6MFpoPYxlUi9EvLRKdsrzLiI0lxaNBxsRKLVIVeLKkDjFhWoCW4Byri4jojvrHfeCD9239++/0GJMdTHPfvcOYWPIURNbvNiasCda9PAb64wljyuInUi7/sOgf3/aJW41ZdnnwA5z8Uxe++mZjiksYUqgkM3F944QxI7nQGhhTBUbEbqT/EPZnup982w//9IZbjalufc//vu3WV/4s2G5MvlXZv/Xgy4/vP/rc24xp7J8978MLx6w/bTemsX/4gdvn3+f2q04Y09gPjeDvtT3GFHukaTlxqiYJOfrZj1+3+Yvf3WZMFciPX772qd/77nW3GdMEfuTO/73620vev92Yxv6z/3g7C7fmhDGN/ev+4Dc1NT2mx5jGvl8J994TxoS9UTznr6UrrjHDFXfsm9z3c+58zgpX3nEwXFXF8a9oFdbKBbTijo9xjLa2t2NBEgK446DeiAN1sqQLaEjLCQHzGiUKJZgq/os+qqULw6UMPnqcKc5Cg04tquFtoUWoS4ukbqIyNUWVaTXVqTZXdc2yj2xONRjBGqlfa4sy17be6cXeCMVa9pGnNbQerUZQKFqoepi7lJYeq4xtXptraix2GeGFqFwFC9SMW6IGkFsM3otAWS2VezELioXjqo4uJVsWyZK2SLNF6Oo6S5SBe8pJxRYeQhGhbeYOlmBShJWiOocl1BAwDsA+o3SSqWivspSnZiQ+tKMOCzxOHJqNNa1yiUlaWoZwESY3LwhvHYcTrKP1mFhbT039WsULonGwh071Aw7ZHLD/KvTwcJ9f6f6Zie7zKt2/MdF9bqX7Tyrc2W5Opy1ZYob19SqfoW+y0CDjwsIx2IKZoXHdDs/tHVd97Q1jYtH7r71jqlluRPlqJB9qU8WFhBmiAXd2Hv+UMT3lf0nJsrSaLcBe6BWsO2nMRhYGyGxT8t8qg+HykLNk2dVnMpBWM2tRnspgaokmLh4LcJHBzmohXAV968iJqc4uR8UeYpL+t+NYxzKjjOYWeijGRlYiuikcWomBu/PlD009eet3uo4G6Z0vfQn+3tgDRnZ6xX/Gf6YMaMZDb+dHP4I/r/efeRklu7wZLkEtOeRJ3+7f9QzYeBgxjUXsR5mX+o/jUFLX73zsw/r/410rt24bf7V4JZdqOf+uH6PMq83Y9Z9buOhntDC/7BkPMzqkP/T8s6a+9F8cJkiUYBvKWRHWkU11/UyGipZviE3ReaeZwPGwpjJ5HmXGyTWpHOdE1sQTeb1J345eFp4yY2ckf3mRNqfEKskw6rAN3iYLD15ssC2O+4WMvGHqsLHpD+2WG/S05UIu+9YNrw5cQB07OlzV1aDCfwKnSYZ1fPFnlSngenJfyp7s/pbpDQzfdqYDwy3RwNALLT1mPVx8xAMPs69zMEbcPGlyDsOQKadBzaxcJ0sal8ikoXICkK1lztIM+ou4zYhlQawbEDwSgKihtJtgEdrlUT0MssDNHNKkZJ50s84x+6h1zOIDpsNH+qh5x4c/LMszPVLfkSbWfpEBVAR38WqDjZDDdM7h0RqxwXMxB1oCj9ixPlTXta8H7Nf1PZBqjgRZNjJHgnqlM3SgDYR7g1kw/KARRnPgY8Wd0mKmy3myxWa2yzkOs77LeQTqRpfzADH+Qyz/QfxcI7fcS672iluv+OwWt1axXC1eSCybxYtv9/ZxOjF10iTvA+TQtI+Gs4+Ec9iFjxF+t4dmEVvM7fOJj0Mt4dxrG1Lqvk+kSiT3+KPhvCPhfLadj3uoltSlz5d8B/unBprHtvwYZPToKDRU0s8X6viEI7JG8fHIQyg0esGXzADJGB0JdNQU4b1VicEAYgHbvBEZhRlER0nD7j6fvElsvbKtixpECySpDia3b0W5UbmGH76Lz5C1xZNY9W6yy79NeXO4XJheIFZRrMqK4pqKsipVDiWFwHVoCF/Ng3/waafl7UPK2wu+YDUt490v647ZmDF4dFqVXpd3wax9dIav7SP20fSxinfUThYmv6P2kVsfH72jhup1Etfy4pk4qbr3AZxmpap2y7clj68pBR6bJ9msxXWu/EqaZV5JMx9C1Y4NZcdZ4thYdvTLjk3iOLvsOKfsOFcc55Ud55cdF4hjc9lxYdlxkTi2lB0Xlx2XiONSJGkt0E5/OnO9nBPOc3IeaD+g0VD7wflysvndnhVk40uLK5kJglUq//GGgawnx/sT0DCr9D0wpAFGLvPqVZjrwhyt5mEov5W1hlsN4h+ll9qSf0Lm+KIgwrV8KsGE69Dq8pX66SbrPqqwrMZvsN6EH+T1Gvg1avILLVOh+JDSLMe2UlYWts1BDsY6tXqvAP6joJXSqFYb4HDcDtpgPt4O2qsu5uvA0/4c1RBOxszJs83J8RylTIOomrhwY9+xJ4yGnbhI4ccPu5RNN3VS96EWdtlIXTj4fCPx1aGWYBO1Y1CymfJ8U1/jaLCF2gx8LD45xlmwlVrLzxg3vPrVbLWNCuUOHBbbzZQCj1hAZddXhNDThzriBt19qaDTTEVp9a2FmBtfH/aiImzsw5R/4+OCLtinbgxbd7b9/C8veeRjv9QzzuEUYesFG6mVL/qolVphu0N/Va2GdnDacm8dvfGOuRO0KeP0sIM6orHL8dryO4C1aGHDPOU5b14F8I6vqpbiSTm03Xm2pR7ahhW4HIIEFu6ssjHTLnaYPIkR7ob/PfLmHCHjoBn8feeWY6Ndjie2qUrblNQKypdoJ+2ZPAcS7kVkv2RBaCfOJs1RhP1mvNZBRfZIfayIeqNZY2rV1I+968d3Du592yZjwvLXLDXtYR8BJ/YTN90+949veVmPMYOOoqdfMx3DoEMNImknlA2xgg6jzxfLMHEZKT1upe20RzzVS1n6Yo8xy7MCHQRV0m5RNNJQXUXV1UlQWgfLolWEIoDgIoXkMHbPUa8au3fqvO5F18nz7xyN1JORloDdcs7JtXzdTXxwzelWtTscUK+qteNihepjUuGgshriAjYcFbBhtSlgm87KYZSmfTLa3kmDQV6X4SEpZwU1zma9Hk9DsVqXlKe0cmDhlVKPy+O0Rvl0ORU4qbJzO9rePAc1C2/jIYn4nqbyxPdACiITOSKmgSCPHTvPceTDQI5h6tW1CpIMcPT7OQ7R+37hIyBcnkuJnKWh2SfbHIi0lQX2bN6yzuFVRTWFQmn8BoNa2/uVtvdx6ENOL/JBOhwzVcIaxxal+1Q+QBHHkSZ4YWH1HqZppZHNNMRy8GxKQVvldFPBDQCqU8FoZcLbsmYtEweWlq/KI4vbqDZgmZH+dpX+dq2U4ix4ZoGGIJDEH5OnwBG3UVqERd6YtqtSGMiG0ymFKRhhCmVhhuS9zSFkFqe3vBppgEOkFToeBK3bUMqjj45ZSIVFlBMWIw3AYzBA+5HO/Trzt9Cmqxss7g026nLQpnIpLywBjaE2SH+OjgA/Hm0cpbx/kjtuyM5Fi1vrcAOlYbTSBmr9lxZqpUKLacBR+thAGhF3PvrEPwRqo43AYe4LD8pLOlNXfmlX8Hcs6Ib4Iw0WdJQT+ZFBIjvlcHvYBtUEXDxYiF6gAqF/Y09cc+CE/TH4VKbgWL5jLJ/C8jZdiwqoRQUOLTOhFmWB0qwQiRgXbtOTQaAQju15cUnIr/qppK5fy71lK7IyEk9ts0/2q0PWF7HWeKTfCm3Fcmw9tW5ibXe+PuQ6XKLu14f54Qabax8WE+VlVIGad5hdgzwiSQWtHIG8n1sOOGw1OVFOoqg6vT7lB212L6eyjqNU9YPVc3lA09yzhqa5U0NTAk0JNCXQlEBTAk11FxiavMnQlEBTAk11U0JT3fSgye69vDDJP9eYlGBSgkkJJiWYlGCSl2BSgklXDCbhHyfxUWfyKO75GpdefCpc2mPgaM+MwlFmSjjaNhmOtk+Eo56qcGRCuNcMwVFfHI52GDjaGsHR1vMCR/ei7fcMR7urw9Fe+N91NnC0qwoc9d8THBXLcNQHONoxDTjaRbtmFo62MWbuOg04gipp71nCUX8lHBVnAo64AO2T4iPVlldeNKHnGXCkaA+gSMeYKS8YpXNzHwrUUAxRzgpPpCedhCiTG1chOiMK0cxJEJxO7NLhp9ETosNHSWAXvU8q+6SSBGtsorbVRfdmvgsV0yrH/w0LXTo37mwO6/q8jxu1CboeRKBYxYG0pjVyDMkL3jmIO0w5Tp0t7GFS/T2Tapu/JSepppKKFImGvkyiNXW4KnUFg0AEKaDzSYISXQCJynCwD8SwT2iFnQcjRB08JaK+XBAV/VNBd0Kt2iRt+tqMwDUDcMVvMKCzZhBXVcFViHfAgCurAd+bo7PiVjs1cfdWUEA1bvUibmUPVbnVnoJbRdZ74tYphYlzq1fm1swEbhUsYjWmy+LwXVaQE1F4NyrEbtBVCgxfkL4wO54ijxAhcxgKCEe4NOAsQwyDSPngjJLsGq6qBygN4yAdoIN/10IHmWTLuyMDHKqQLM0MyGphDcyaypYTiK0OsD82lauSX3OVtQvpW8I+FnPg4sGJ06tzxvSK7z1MxlcXZYUm0atn6NWpRq/eNOjVBb3Kq8dtKhcuRXJNzRS5glgNvSbkmpBrQq4JuSbkmpDrJUGu7hVDrs0JuU6PXBewj/mXF7muT82+UqHVS6A1gdYEWhNoTaA1gdYEWqcFre55g9Z5CbROD1rn4jXyCwKtmSmhNTNdaGXFZy7imdZDE6H13hXQiiZ1IrXCrgJbYTMVt8IZ4NqtwXWTAVfArAHXLg2uKPdvCw/u+Oicz2x/Pt8YkepBvtjBJf0gbEGqBSm6QT4i1sJbR992xxyjuOOgtl7+jy+dRzW2OrHmVLV6jqlDE4i1gG6krRTnVQQFjJq8o89udoB172D8CPfCP3jVMGhbxKC9H44fslfWd4VBERRSEj/Com73dCLyOgH45gDr93WPLnVOTAZg9bsaVqHY+KG1Uv8PfeMN8QOW31ewyj4Aq7/8xQO2xQ9uoNdpWD35J8AqWm3pVyF/0GFk+IiszAmRZI2q8FL/5cYPbo8f0pxKZkGLBJ1pVF2Om4GfWjvIT3iJdHHyNJTxCRFEM1UBlgUNrDUd9sm1QWeWuk2DiH6Iv5vZwc3slpFgP22izkPBCHBUt2/UFY2x4ljSrrFkaDJaDWsn9NgDUfEbKGZiaysHUNYGoUugpBV1ycMxmNk3DZhpmxqvpHtgNZuoYxzVHot6aOajHkA3NVAVn+wyPoUJPl05+DS7Kj7dmw5dZPgEkc49EzWxDz9iIoDYfh4zo0EiprRN54uSujUlbZpxStJVuU1DUDvMZhQyFZKA0oYyOqXV8kuHZTt9SiqgKBRilIQL1vLpUlKbUFIOe0L30hpVMffHoKndQNMfTmhoSk8ApO20oYxRra+eCE1DcWhKnT40jVz80NRzttCUQNP2iwyaRqpD00glNF0l0HS1hqaRSmjinGiPilO7dCIscnu0K0twUOe6XB0oWtF0F8scIcn+CEnQnFOaG86w0IK5oNNAlOMTEYXZJI/7pP9pRx/QTiOaTa6J2OSac8Qm5hWQa1gf4bWgEysYOCWhDE4gFP+UhMId94POPaE4F5RQBmDHwQdD4Os4olw7w3zSaPjkGqT7Ghq5tPlkRPHJyHT5ZBb7aKjgk6sMn1x9vvnEnZJP3GnxCbTrovc/X7RxGpjxiwQzEsxIMCPBjLObAoljxmCEGelKzGC3YXmbUj8K3Efp0wMO+Jph5hD7YWM/DLsLhxyDceQYPJfIUZ8gRywDsuyj7mJDDnumkANqvAQXOXnJyvxkkVOyyClZ5JQsckoWOV2xT+kyV8zK/JZkkdP06HUR+1h4YVfmWzO1Mt/OXiZbETSf9efimqf+XFzyubjkc3HJ5+KSz8Uln4urv8Cfi6tLPhc3ufInn4urN3CUqgZH9WcMR5B/ldqjeBWtRq6sRiZ3yw6bGb0R2Y21aWxllzmWOeqa7b9cDsMtHm9S239pj2oDOwv5VAPDC70DYe3dtF1FmCS50c1MKTOVUJUa6J7+/qVQ/mZmpmoz89L9sN+018zumjEzM9snM93MzMzM7OPezPCeQpVTPdPLu4duSSEpFAo9RYRyIE5jSmWu2aJ4+mehX55TL0WYxcTv/Tjnur3YB2JTVcwnh8Ixg1wstqRCaju3HAemmGO9Xo6eeeYqQeFRoMdp8Tev1Iu8Tv6LV5a/SfSfpOHfSfSv+G3me/+MPyo9jZ0lzCRDDLQ7HsCS6B1iarqBxExA89tefMxO5zU7XSXTrK29Ce1IcuOhPTntMEcMs9PJARmmDHVWDrESNmJ+6g0SBt6HQfxDU2LXhv/xMRcMfnsIB6QNjXRhk0qEPPOzwbfBtANhkM0VH5z/WmbrjXg1NsD5ODg/6O5kDLbPB7GRAyCC62Zsborn6tjmQ1IG/Pmig5hHZH7D7CP/REyhuSrZfBebC9ozOSIWQkrlP0ujEDEQFBFMNx+OMAklR4yWwWXF8aeFI4DDJnq3ZBYamJ2/gbdscQfM4wfd6iYgvaPwFqZgxK94Nba4I8xsYtlA+ovyeweL0nMTVmEsdQKGS0BwCgTSP+MneBE1E74SdHyCykCoaPmRRP9Q4vSuxOntif76NO7lif78NO7pMQci0wADbPPLCzbChmhSsJ6MuGlYxB4JKHzkdfgcYGaQYRk8MHd4GRygJoffOdodAq4RI5bCbEKPPM4P6XE+hgegK0acysHdUOPAvAyycdo76dwTBBxBQkzXEcpiU9JiHnbDc96aemTzqDTs68QTbj6BfNpujX3U3AdBvxc/ncyouTCTNpatdLHsRBNn1hKtzWhj5Fgm0/VNy9y5U9ZC/BHuzpj6IDoXwBNrrKQ6lgzXqrkrBWSILr0+Boo5b5ZLSUFvMjpmvoz124wNzVWsX2dsaZRiXcaOxqrE7OY8/GrPecztsmvHtmO7Y/taUkiF9+Dodv3nohdtdctYTVa00UlFmRqykhon3IiTBuFuI5W0VJ8jvuAUXfJfPcqbQFEokKEP1jUMkLeXXlOJpuGI0bePh0rvcLq/jcx0DHhjhQo6lwoDZSAgPBjeRtlfR9lfi+wzJmfWXPklNVKxuM7oHg6GqN0FApfUWhsJ28dVSa04/lAO6ikuyW1Btd1J+8AG5rRyKpxL+8DpUJ/xjUYhIR23toRG4DMWzGeozs5/nnrsZM49DHv3AOHnMsTwV3J9bz8UnTWYAO19NB8lE3smOP0iN5rMVeEEpO+MVnKmTrVSMFlqLM4VEmmCcQ2L5VgyqSrr+XKsmFnVai5VK+i5lxa3UeJNlMN1lIMocUuHeCU6HZJB+LrAGlSWGN5hs2YVEM1RRTmbjtbDytTt93ZnD+X1qrvvFnlz/JT0tFzHLoYYsxSh4qq0DFJHx+XQbsRE+9tKGTr08Ww7sYK4Pz+NloJ/h6JdWL20x3lnG/r8ZmHTp9pOTHCY6UKDVota4ikt3xzSca3kBxr6gSbyG9v0ScDxkxYWJddu4tpKFRrlJS068C7wyFzvQWA9Q53sKDr5CflpYE4rDXErqZkTrEGBVi0NuwquVQAWu4yjrA6wHGB1wHoO11vk+TGcEbw2Y4XjQyfZx972ryomUc6PSfbw9y9Z5zVWwjnv3+1enudmdQ6ylmpc0yEbpApmzQVL0q2KLRQ5U9MWUsTMtT7aZaMRlSGwGSexNu3aICwNps817bj/guZSRngfDEQUrGG50dU2Plnk9anZ0rEI5Rgxz3JyNpqdxdaF8M7xKfreH77nhxlFoNjQZc4xTnSMWeSPXyXaRg7z93AspEJxvXufJhoy+i9GC1hyDSPVJDzqaUslNxKTr5dJhiSI3RmrxQUXLrbwUjSQs6IjMrxN6n6KpD/O6zkfNS5T3ypxgLwF1UAjY6FxFBXHxcKyiH3+SxTx/zRRKiavZ4wfOv9l9mZXLEn3V05O0s3NTEm62TgpSfdd9kvSPWLaoyXfOXqFM3XrOa4nIKYkKQHxM/OYqpsq8xrVAUa0MrSmy237XLbcLptuqaFult4/WShQy2lVCM34kZj3u4huPWbWxg71A7Gm/yZAhAnwywgwsezqumdddTLQxOwRwVGEz2R7ZED7VCEuLWX5g5iy/KUv3C9l+QWrqYazUJCDZd2yjgswwRAoIAF01g1J5Ec0w65qImryJBd2KRoWObu67p4AyMLHkyOPggMtx69WIgPWkpWhEdF7Q1LkwuTz3fOrZpXSnD8Fk0SvWQfGV1OK9evEFOtGiFo6MnDjxc3owSJ2GV5AjO07P2+sngP/PfLi2fiZvJaa5Po5jMjrs4OjJKQ0z5FmObbcZRzYSHOC3J0del4q9j1c04cvQ8OrZeh/QY09p9HHN/F1IO40hpXSSX9aaONcu5prl6HjXEs/Dip7dG5HF+Ok5C4tqliUjoU/DzttnAs54udshPNnEw2ErieNI84eDyC+Yk1QqTmQFTgCmS/DQZm/MxyK7OfBMo4YjXTniZHZOY8Jh1E2bLRobOgzjKrgD+JDy4AfwIbU6NmQw2A8UcRS9EIOit0NVsw7w6YcCn2MZ3s1c5tEgdfQ6Qe0QaA5Yt1hn4z3F5qPfG33+gcIjMRzxlaW70uEOw9JL9fDsgEZNMQspOYPHiaFVLTkKjNjQ6qY0qF8J7hQtqtRLjG6lpGBbV6UawTHQkLfSQkWNt6oXpwu+kNddLLvknUbPNdX88UUb5v/GendmftRYTWSpb1lnp/qS2k5EO1yqznsv/8eF1tzJt0NMWsy4PyVJSsejb+ABOFXxrxD19qKz76qA4oCad1pCd16EPGjSwkiHgEhyIhC4+35BMQAz8jvRY6KcVjmxWeeTv/zJs0wPytAzJ842pW1pJVmxnP/cy41TDQaR6VJ6d8cF3v3ZY5YKEmKWDim2C9igajFE9bCFf6pWA5Z/oayPhGv/HhPvJK0VFJP+8UoFdjuBLuyspZ3YS06qS4pOjEgWXULlV4Pw3GxsFpQFz+5xOjkp1ciOvnZydEJ/eoUnbBxUnRy+/2ik8WTH7NzhQMTPa71wIRCpMDkS0VBr0T5FbxzUxQZocqFiljw0K1q5ckaJtpkQ7AD3t2V/cj1L3LrdwKzqu1KdovCKjGbiOfP+KZiAMkrsLopUqEYaAz5rLkPIUZ0+V8kIBsxRHq9E1x6Wo0Nn0uA9n3IUNpoOa3/JSawRdzTWTfAbSJaGi36b2qfHtb/ivQO7Kf5wMTP93KYKCtanai/jpO/WZgy+niekeSruGY0sU5YiIZSJlTpRolJuiXiMK1eKdWsKxUd5S2KfnTijklF9bG2S6JVYpmI1GkWr9PYfEG7mm15nnZBR5b/2tZQvBJyQbiV2rkE5Q1lX+jBM6RIwnU8eMODp+PuVjLWew6+ZD8/VhhFgK7eT4I9jJ6D68aP6vQaDdbtVh9cK8ytkrY0THxrYXKES8UeYJosLzAnwoYwOQWk5R6QlvuCFB2XD6YETFLUtLYb1uSY+l0Crku45Q33v5lMcKbYLQna+ugYrdUartzKRsPcgVzjeFIP+1xi91tSuu4ZRVFQP3eZ4GZYxXzoTykGoCvoL6SIKD+q0rJKVYNIXfe262g043YvBo/Vuv7Ijzwm+BUnMJlNxOzE0Y/Vaboy112A22l8MqSTz+CmHEljlo6ee4jb4UJpYhqscotRiDzHGgsVmDXv5SbvVcJCEuz0RPebUXVa3H0G4fmxQ18MrbRrMF/Hd3syZri1XvpjrGWscb8IfVYtyVKNaJ++vqS3kOWfItlZTm1r3CzlAxJIcgC1uHBsoy+ghXNIZ+R/F/3GTBr63RiWc1aMDdVs9pyc9JNLjwLMxaX3SS9Q9e1okuloyL+J/GcMWchSHP2TW3RH/e/jUp3SQ0smM8zr/B9S9Njwq1C+IxafMdFsdwJx28Ani6OTHVK0MtctzWQQw0l8M6h5lAFK6EKObaAznjFVsDZgFnJpwfd/7HwFlOQ4sm0KDGlnVrmqe2pq4Pwj+zMvM3T+MzzzmR/DYs0s826f7WVm5q5X/Zj5DTxmZsZlZuZd3biS5XS7qnse00Cl05ZCEaGIUOgqnHOc6LS6dhkLkiBlat68jRhlmfK992uTn1JrgVdHz2QItjEEZ8DlYFhtwem3zobpLzn9ZZx+u2byuUwmnc3HYpjNE12B+cbVSYRly5t5vMlYzOQGiYnkL7nT4C8DF+SgdnXgYMEtau75RQDDWr+I3NRDbqZZsIxpvF8mLsT2y6COHGdCufce8FPDKeQBjyDilzoefc6B67UI9VQi3e4fI0/9P3sMwzePWbqgI6KAGOS9qmWRxaw274TheoZaOBRc/tQj9vzonWLOXl9Jmpqn7eB4nYrkRk417050dKCSgY4OdH5TaVk4wZ7mjCDV5Qczq36qNB+o8AB9ZKrRkcEFGQMEuL4DY1yCJPUGdWgko/WAqu9KwgZWpqW3CA/s//pWI36BiAaZSCT0p48374JwcH4yTRZn9Y9qpQdRvqDnxziKxTYXRmmO+OJm2CpheeU8RpO2Q1N2uUyFxmjN2zE0OYGPEvdCiz1wGSwYl6Dgb2oWA4HPhTTDVsMLDsOnbYgqXH7FMkFnCtagoB4kK5E1l18ZSjkM0yi0gNFBOiDre7ho3sFjrmjSXgrgMYqjSuLgv2M/ReGKFCJ/RNFlJxwWjMrkYrAZJ3fzb5db1l8tFi07H7CFvRHZMmTLRLZmQ7bIkHWWDOHKM6T6m6q/+b/qr+AIt4b8JKWJMUH+G9ISRXcwspfu9/eSBV7lgZ+rMAoWB7Ftfxu2jSCAo6SQ1WDN5HGSEgNVwdfm2KbgWxWUW7k5Pgo6NXXJzjlII8+018GIrazLq5kgC9hY5azY4qB02sL52anDoPXaoMXEoGUYdA+DsnOBQa/vKFTtsha+tprhi/j73l/1LLzI5p7+SXgCPhFPBG1aw3n+rdntDMuTrQe6umy4VcAup98Y3Hz64K7mLkxNPBbW2X7zYNfb3AYwuY5oMlEj6+/IdsU529f2aedvXDpq/c+Grf/duLVUIbmIRxGIuguAKFwRJsMVz35WLuIvH0IokdtO/1tzG/y5S/MSgO6tWaNYenX/Kwlal8UK4YMD7Fyd2XfqzGkgFPsdMVV1sH96/0wc4sNhiH/mZz7CFpY4WhYW2ZUDZXABvd+oO+XvNTjHvPGgKxHe9snUxDCs1rkNgnkWF+8C/Mrgr3kyBqfg45t+xmNcfMQa2md4Fyx5VWKsu5pdakMT6AL/XNWoG4ARx6FtucJQC/Gr1W0eBLvAoB8RNZgE7n2pHzPqY3gIorwwjlc4eJckwJsbBPbFcFDQ7GsR7TEfmCSc+AuvlB6N/gppz+ovN+qkB1ZPXhZRr1bFoTSHmnFatW8tFgKloy4d/re/D6tRQN4xktgm+oUB6m8sM++XT4Bf5nFKPpilI5Is1jE+68dnvuIIG2ffQBEtJBe591lcfVQk/yA2M4926oYIt2HdRoaSr94421vdKJU3Al6/U/vn322lgf/z3Xav+ehzOeZP+LHeiCzrWc+KHulBxN/G6DnuCXT3xxrLIb7CKzNkU7/vW0y8FlH4Q1nPLkQvfY+PKnbA7W/2PXD88/M6ifrJe/uqq9H3G/XKC/e8Vz/lWV7/KFt8p27nvonzZVaWnx/UIcF8o97jX5EKfz+o95o3PZvgvELwyByTkOO+K3ORML2PwxHNvP9yn0vC5f69D7r5XY0j8loRxK7xYdsF0RgF5bdLpzAVsl9UmKluk1rmwRz6uQ23lJ3oAncWN3RLztX3WzKM+dDrs+VpQDwMtOvLIbHV3MCXS6+4hH0/qikm+sLWY9dyqAOY6P/z0v3K3U/d7w37H7/3QRDuxIkDV3mLBcWr3CKUUsgGrfkZBA/aCNaI5j3Pjd8viy8ruLx5L+4SryIQXeFj0UlaWsELeQUv9B+tjp6onR54oqYn5tETc2ZCbGN8m/sgX/vzUjHSCgGUFGLvylWD3hV769hbozd35NWADcTkiuSQCEJ9clk2vwCNXUxF7PIQZtacfgrhQmiObkeP+zCsUm7/tqZT9xEbc5bF6PlzttCnGIjsqeIJw12BSScXlxNwTaEqi+/uOM0kkqV8+Z5YrucZRxb9Crc/MPbytCvF2GEJxdcdHOx3BVQHA8bKWDTfC9a7OTygcv5jxrrdNHgR0jmvuKuXE8cH7RLbjoVA2b50452vgHNvOLl+Ga43z34xpm1c3c4nYsyy3XLLdtucgHfhtRdfVOsaT6yKpf44V/WrbLrRbrstNPEaH7XaHbby1Y1C0RNuwi0APbh2x/C2DEi4vW4uYtZ+2G082nJbsTX0Ml+p9rgc9S+lXNxIua6X/eGYhdIVSBa9+RXuuNRW+i7+op27C0BzsfonKCJaoKp8wSIiTujC+bmUicl6f9yX/R6OLuI6Y9KW6Nu3C3PKnMSCs/DGpJ4QDOmNPh20/bn8T0vlAq58aVuXwzc+qZqP8cjxste8Gv/cdO+DtkizXfaXAIy4MlbMoCvPzI1n2ho3L2sXUkDeLvHx79oNJhqbPF9s8HG83fLSbw/orU61x8yJ9RV4y23jneHje90FCKM7GGoHtWOVO+YvlBQjN+74Xnt8raPBHnXTVe6477bHwlZMwa7bPfBTnL7sn3ZLN3i2WHu27y688cy+/1LfZ6ncBa4CinXh6okYdReQHoBP/4cTAG0AYDzmNeEtc+7Uvp/ObUzSNs2mps7+l+gM+n6WTr+S1dZJixeh2csU1fgsRT2epB4fSj3+P+rxPmM9ln/peqz/MjR5EFV50Xmq8n8NVFlCleW6Kr3178qBywY213K1iXyj+bjALArqfRXQmLkr9/f3oVLoW+JXtdr/VVSv70BCr56qW8rb0MHo5ydahbOiJUav3M6/NaC3gyF2XN3vFn69X1tvc6L5BjgVhEV8fdKjHlN83386c9mv/DL+KU8cHLjiPhQMefeLgChc5Or0/PxpHuzf1YsFWfyLqrtEcu/h7ESwvNhnXv/KN/hl1IW6XafOfNZAgU3ziXBQaL2W76Sv4tV/647dSV/G6+u6LfykmhD/X84ie7rOWdLCFg+qb57yFC5IEja6KMAM6yZiyjvVnlPk8wAfL9Icv/nNZ2D0LXcMyYJ0biWpfadqL8Dne30MddYvPyv7cO8AWxLvLcpH/KstD4KZ7HjC23LAcePBZ013odtxF159SedLQ67z/OCpuFG3659eS0AI0vhIhD++BplpykkpKt35r0ssUBSueQfW0UO5gmranRol7NAkBnQ7Q85wdrpLnirw9J9l0rdXFnZ7TGybnNxG2Lne1xPgFRB87t2IYX5bBv11dT1e142msL+6j4D299hDfel2r5xjnhHM8m74LGVi2h2iTReuVFsNvBlahIyrp73Ir7ur5+EvFPWw7oJLJEd1SxmD2ITe8xBt866nQR07tInjd4K6JMjx1n8DiknrgBNh3ismQfI0hJmYFh33mWW7GwxmZC60UnAA2Vw+5uBCjOpnGYjndYIP0iY5wqFjYjb2WwWPd5t4baXd4VI7Y3RgSAgeRlXf44Abrh03AzlIWl17ibel0GAXzup2E2AQrv7Lif2D/eicqz+GdbgGtk7GTuCEGgujFwHba9SG07lQ0YQa8O070cdkp/1lXtRKrEMHw/wkfPYQ5WGJlQm5DUZxOckfI0GOQofkSLAODOFlO3uIerXg20TSzMdwKGM4tbXbAcS7szoJcx603j1368AVx2MAoeSjW9gXxfqUVdm8EplyMGtGlOYmPOQS4KPZs3iU0Xw9GpIUn71Y6kW+QW7vhDHew0bONq/C1az+XqVsQkomUu30bjw3gZnk2D5l8rbq35oQJDwjUJID4zI4YLHYeJrVt4EWtugGCRqLM1ffzps23iRO7li10Bw8D4oTAAigDOLKjBleAlpuURoZXg9SYB9mQu3rFbF0SXM7qrB+ZcOUIE+XBc/0ZeL8UOGAkbtDKZTw+R/P/RfTbYAFHuAlESV1UbnPA0zAOG+40W8oMuStkLIzsUr2IMvMKSXp6TztcWJmyv125hQ+8omljeXf2PJBaSjEUo/0s/kpmG+fHzcvBC2IJ4S60s9l/9AVZ9q5U6jFrIh61WhVtgt8HJc3QhSXDRwW9z9tiGr1DQGa1J7AyrzadLjAr5Y0bhHej94iCdc4hRCb+3iObBvvYuLoGIXbAHV4oOa2JLPa7nXuBO9J3/dPd0C6n/gwt+nTw32oVGiVbo6neDF0A5QCEu6DHXhzZVxxzHrEMFE7Tp+tG+MpQj3GmQMc+6xpSVNL+q9BS+bPpaeDv4CinE1bqE9oWwYbnSiZ9O2gEUKmfq1+FJaqJyN4QWNuFsqmQ5V2hIVXM9gztsxwFHh9DsXkrkCCUCSsl/WWlwJu9deX7jWfjtALiZUkPfftkydXnnwBbXtZEdc5Wwuo2eLRoKWbyxk9FgvoFpPSQefQVLO/3y2cui/QDz8fYG/he9SugNYK0VrdFrhZswxw7h9pnORKIU+OsZvPsLQnoJYNpfgsUXNnIJvcYbxP1aGuqn/ZqB4kvU3CrWcrAvZE8lRf38AwiocNPxb8KHncDOKn+LtcSAMgtUWsLPzxh/N/nBxul6LaXCbAKS9xGezWlZipG9Ou21lg+Qf42D3TfI7H1ZD66ksAQV0N+NcANsyl0Fz4wAOUkzIMMsXkuYrtUGCLK77uZwFbmlAp+s9wJYbg+nXi0h6V3w1VKTkoq0NipEKVzL9yirX3wlmJ/J08Ymi5aqA8wOiU2iC7/zyhffi51L0r0TMYVZQMipbOMIscFHKnrw7r1G2iG92W9cphJTUJqVohCp3GSge9gEYoP/gBrUz/DkXJ5c3AxXwmHyAHh+88YrTQeYeTQ75hMXi1qZHXM7B6ZoyCaI5X5lnujG+eDGJWqw7r/FB2DvWrrHOTYIRAFe40X4Cq+lJUTnViPpyHCmrtVKgaxhAfZNVw8304BOqZurUcNd+P7rP6X8/6A3AWFUGBcMX7+3C8utcjVqp5kuQV9XM1izHMQMEWLalgQxXjMNPf8/qKJ7MWErCyAS2kCFHj3p7vzqJdg0Zsgi+KKurPhSMVwyb4YnotvuhZ1KIRLdqxFlGcDS2iEMAELeKd5c8GLT77mdRiYsx3wYAy0YknywGbDzz1fNX2fKrtBpVq8dJKgPcFhqeKOMETBBWet+EsT1ARZPytTUD+Gx75BcXWshdXk0DO8sy8frpR88Pq1pv1uvXb9G/a/a5/a07UJvGHWFtBlZR9ETs68LW7OWrfkD7J63bO4O27C1IV+2uFyYw1cNYV+Chcjo+c8L85JOoYRh0jUYc58S6yCp47WoSKDDHisGr41X970Oo2N+z91dbEv+55R9XEvx5PZ/Wdhm9bgBN6XYxNLE4fL051/VONKXxyPvE2lDmxUn4O2twPhxIEFsOUUrPbzolGxX+jJXbVRp7nM6WNjYAwg6L06mpcV1jCJdF3Cku4M4FpuW9w3+D+116+zNyM4FsNWWaL7FCi+Yhou+jDQ6dHz7olnkyx0m187XKGrT3H5ouTtZQ+RWL1reKeU+D5J/eeJxKfgTgFq/iIkqJtGK2eouo2fGcb6YbOFp1RACtFlqIUp5snwywWZv0ZcqDY4CnSQIOpanXhNRI8LX+xI5T6PzWRwNen9R2QC/Y1hhof0uDpYqcLPZqlOT42RZIaktScIEiMwHXyYXutpylsPBmFJbiOCmikW4Vu1frcbQ2ejOdOcGCoce6agTY3R10OIyUUZqRQuy3oWIHDNHt8yNdLmtTMQdipgTYGTNVuLo2lwHgsI1UTNQDzrtBkW5psosnmUA2WvKcnIzVU5K502+ROiI27RFLN6D7VAF4tCE2pAXct1bDNZpAsCTYaaGPAVO3KXg3FVOukBjB3mAbKc2igFhZdQQ2Q2CEaKI/QQBkITWqgjBpAM+oLMh2uAdKqXRE1QLamNUAdHGoFVTK4LTzZ6nVANqGM7XYTblzLJHF0aGholXGG9TBI4VGcfFLRdWq/PaKSaPu/7WbNfXiVPKmKJgR9H+rd9bm9ezby7tm0d0+TGgo9m/TuOnp3VNVszburUSijBhjAk3eHaNpVS+GQCP64J1kfLx3LuNkGoBeC7zMkxQFTrAoPt5+J26jcvB4ZNxIODJz9+9kiRujat3qWdM7lrQqLg2EVb4q4rcKvDRhMbo4b8xZ2wL6wMGbj6Mv30C25SADE02wOkEyH/51N4d8GGHKV4ZS/KyBlASnDRja8H17g+Xxtxmtn0yrdLfa6JZ4th+ZdulqUhcqbtgDPymWs3i/wEYgvx5YRCGfTcX+JrpFQZC68+MFBg+tn/RpQsEvFQXWSKHHd24mS1lCtNF945iviltaZQ9j1dOb4Pg9sQsIlTbIYjDmXnknHUQFm/T4pKDenqsxAVYW01Giph6piDmVx30YKSW4NgepvxW44veDKDATWmKwhcxYf+ZjPjJKXU3wal5PBEh+hZTHiB+ATKU/wSWsIhGJLO06tsqSB/n7SlU1mFVvqsynQ5KcoMK8LhOr6Lcpk8Ja1lxRtfEkx5U/EwzLH1ziM+DD3IGcx2pXRDMz6JJKBrNXhnUONozkXqnk1Rm41fEf6I+XQbubtjZRGHrJEgEMc0HXQRh1/OjpvtYBw6dXBm5S2EPKcIopoGURjJpKPRSvwJDE0w5NZEo2lUzTkGXYpDLjtzKGjmdQJgYmcEviW2RrrH9UqS3MTNjidxRYnW+mriDQ4//3RPsbvAbjJWTSe+zIB/5KXyMQ3RWzzbDhCePOsrxpwSpzkOTxAUa2VQVgbit5YJZPjeDLJOEtIUUIKT36WHCfH/TyqhR7TeymY8dBi81wOaCGudTqi7pSKm7scvMsemlgj+zbPQ88O8LMrhSYBXGyzMUAexylBukQSyE1hlDEX2hjpmrYUtAtbdoLZYk/1p7TB+sGX7tc3EfSs0SQKxqK4tI7nl+ZGYfJOA9bUThMkRjdQnwg3qKujt7EVZGHTsYKpNyEM84usdGqi9Vpjp0S3hABKg9uMozJfo4Gn57YeD9gVE0NivL6Uh64dwSPOWd0HtvrTVL09NbQ6E8DrEegef1ILSxnmMPzWlBEfSiynDi4Xdtgcc4suLFI25Gs8G+zE+aCw2tc+nLM1RNVs3c0lNMDmNAxVtF0JqUpEjtom2102tQCR8XU2u2p6aIwKbYcx696f8RH1zWUgwj4zN7/bzNYvKPDGujf7lWqNnoBVNvIsOxtU0Zx+i+tsNP1+BMaNs5cCGzIXnr7PVmpzmuqEUSFnI2XbqdGzbo4nU7x0FZyxdPMweJF+xScSs7eKffCND0v2oWlS74OddVl4RmEJmVDxU3Rd5XubQDn1PhxYwcOjkZWxXi23mOORodK08BXjADdPuWp6Mlaqothl5L8UcVQSPWewTnriozI9Sm2hP1IYNbM8QuuK9JsK8ltU9apsF4ZCFMxfb1VisriViUlGShPhLouJCXPj8Nt6WLAkRHm+/ZQs0GjhilbzKNNI5Io/bm1qZ+pf1sbKeSrY4Lqosazjh12cwVeV5hVqNsCx1MM7QeTR5ZETK5JjS/w0dDm1YHnJQscun+7Kp2cbSemlpwrZKCbMWed5V063JvBFLjP5FgcbhWq2HHHJx9Ncpn2JKxmCowqYHtY/qJI2DbW57hbOBOUK852ejGf2iLWuw8DUgG7zuHUzcircKschTk0MMWZfuM8D3x/XJjvaCuRoIvMqxaApnS2YTnlmncZ7+Aok4UOHaBzP1PQzX3+d16kz2R4B0MXQNsoxoj0f20YM/Z2CbSiIYEQETo93CHJtzoNrcxTXqjUjzsf72jntJYrvStH7dytVnHI65NGG2ZINxRdqoHJvCOzYlfBpL2ZUfOZkunI5I6YN9Hl0yRxlPPl4UHpK06meK1tsMxTmAnSYrhl5aXNW/3ajln8F5ydpHVZh83O1v2c8pOQMPvKrUXVyBX6mjGcNnFnDA4Xh4Qi6W3TPB90VuqsrLgEv/YGIH8FVeGpxZa+4BHDQ2mEIyJPe+XFl0urLE5D5kccfpF9T6iqQNs6z4/+Q6vmdf7xg/fyjW8jTbs5FrIotkpooz6KXJ3cmKCKPI2tXUctBDRW7zUXJPa956GYG3SjunL2VWwRlGyo7x1UeGlMV5fD87ujGScFHnua8cP0050XnOs15cTzNoXwLP3ZbDw9tzPDQxi0CeHW1QzE67AFXlbevDVZdUY4a5lHj+SauNsXCNvj60oI6IrAlQqc+6LGQjhhi4ZZUAGFXIvsDJHeDYi/65GaZ2rg5SSeqnhP/JxI0PY5by2cp4LIzsJNlYGdzwE6F3pCzkaFrOscC0i3wfANXGyJnAzmXhJ5LMrPs5bRjOdfZChO9XJOz6Q+jLOWspQ01WZL0IlCtnefE/4kEl0HO0i3kswhykpNzilgeIaIRjlwhvJJixT7nFrHkNNmzRSyDiGyzkBGOFBFTyXMWikhOICLsOYi4ISKAsQ1XexG3MCoPA4Lf1STe4KqBkHhJRRLXCu5EViiz59NVoNTIn3WT4swHn9uCWOSP90lP16nx4mh6cUgUBlZ1LHocu4OXY3a4X/pRzNFeOVvzyhn1bY72yiTx7GyvNL1XmkBz4JUGXmm4mpCTZBsmeWU6Xak9RUB97Ez2AgVD9vAV4k4dqrxk+lDlpWcdqlSjQxUsHy/rD1Wq/lCFNyFmNX2owr6YHtbquOrQQ5VvMJIHETZXYYnJIFLBJaa8Gq/ocQFHFO/FL4M34KoOBjvHJgiwW5uvnZPk+FATwTbjtBZ+TFeMgq2SSSBvYKUt4xTPxycjpM9ubA+DJv8uckjiCo3TwUjtua3aHFNtyF/eu3kJGy7ZcRY7GA5G0KzXWElrkhFp5rGbcuVYB6WbDbv5RzQhDBG7zdgtcFv/tFLlCMWf/KlBHoRYlM6GrKmgEoxoG5rI4hDD3wfklnj804CeCtajLCH1IGACtyW4jVA9f+WPUD1QX/7K3wiqf51S2bQUwr0N1YwYMIyWDXKkGXKkWeL+UDg+cyZ0Dz0LXBVklmZTo7+za9z9qVb5Xxoa//Ij0PhXHIHGEzii/EU0YU7iHCqf9/JHIDwf4u6vvBW4e7mGu78KPaWaGf4ePKtIuHsP84M0wIyCmwlIM8bdi4i7F0Pc/c3ULzScCqtwZUMshXKZ1GZIatexdUts3RJbN1QU48Y4ghBeDyc+QRcxslGjuEJ2G/F1G/H1CHZPN0+te4A9ByPEqW0MQ5iY0dBkb0CLjNaHDlniqqTJ2iHAbsUjCbBnAfCNRXy2fqNGOBda0GWbscQbcQSbw5zawxwKV872AYKxgQOidTSPCKEnZDpHL+oFvfyfpHYIVBJFP7pDgtHLHkYvYUJZD6PnQovRNuqUpz6J93WiUOg0pxXaVD2nNUaFTsOYhNFFqyppNSDY2RqMvl+q8jwgdLQY7K0jaO1jfGA5xaW039QjVDkZBpFb9LeD/hr9tV+bS/h4v6pgQSF1DerQLBFty60e6beGNM+LNfQhhwkM5yJs0zKFBz1unkZRVAAYo5cPfdWQqE0kDt9np4fcYQNJ4UY7j02S2lWv9kUvW0HZYDhx1+yHpdoHasnZlWaWuE6xKXUNOLaOXbWbJz+eyGwgZBlEDh1m5+wwVHzA96M5sI/tzcE6zVQtGQQkCE6OqzKiLWodd4cw6F/KnzR+MQb3Q/JVjJH9Ik37FC32GcP85QDmN/IeetnODbin9rmS6+DpGefCQEUmkp23JkKPksZopjEGZFvDNAbbamTu0RtBQI8iO5cWU8dqlwrAfkVgv4zAPnOduStbw1ik29LpdWD/9VznpuHcNRw/ofjyJcH2yR01pxZfEb32ugR0rqH1IVUaz/Q0KpsQ+wFej7kb0k7wfNoTjNbDNW4iC3NM+zxM+wRS/2ql8gFKn4B5i0ZdNii6zoNoZpAFKaxTisQpXeanIA8LIMwa5fBMvc6iSlrgUYFHxSXdlYG1n8HqeT5AfIKAgWJDGUMIuhiqsgy2W7hyuJ0CeI0+k7M577dg89Tn8NksMJvFF8m7qvA2kiQ8Hk2iSBo7Suw1yVA9kS1rZJKZEy179+j9O+bz5pjZx8zMWnw9vvPjMTMzKj6Gt2Oov6vbM1akxEqW199nTzXXdFfX/FXjqT4odwnLXXMzVrhLqsR+Di1baaxwev8KJzVLKT2N1ba2VMy3XhEk5sWd6iTL4mkwacFovV8dxqrm/ogE8kxZy1N0njU/PRhbQQYHauI0OCaS4A7EkYw1pJKA+8aXnswsIqH1o0/uDiV2bqS2nSo58imbE/uUzUG1zRw43sxlHoSoaBJaUwKkmg+JbQDXtngA10MSJxgH5YFyQHGMwIfbaK5tOpprWxTN9QKPHHjvq+uPHJiOH4g0feADkaYv9EAkpa0l/bnN/mMHpu15SB9MeX0c8I2tPxt5Zzs6SE0zwOPZkJ+RVvQq/mlEX5WHng4GcdgGg8j+03yBrvODpJQgAp45iwgfiMFa5UsKPWRVWuBABh/w+nZU8+FtuxyidMi0JXOEn/ma16Wjlif93sCDM7odwRk9juqGcJoIiMT9S3SjLX0jRJ6h1TFyIB/HcYR9JzroIoc7DFxd2oWcI6QT+rRTCahccegYD4U/+iOoivc0Hv34dRAkcq7NcaKL+Hczp7qJBZknCz3gmNQepKHWnSgTJ4mSq0+o7GPK0VQ/D5VjAcYYiCrbIGzKAEduegIlCNcHm+v9zPWUuU6bK5lr1lwh551bhHBtweCWGuLRhhGRpAL0jUTFxZ3SsCJy1TANEWm2FPUSoZErB0kH1EOGPMFT7cgEyVpxAWZEny2tUMtJMNN0Ina6dEKiF7u6zgAFsSKsmOLgufq/DBxtsYIL/YDeY8VtwgrYADs6/paLLxXPz8uh8/ECPrhTV3jhGUL17nsbC3CYumF8DnGB5W74/NzdNhOVoX7iVR2mPjKL68pIinvium1K8dhDdmbIQbeYqS0QuuOEQ8OcNlwdqitSGJO4X0Upxc9AMzGEicnhhEGXcgBkOXKRlUV13leaxSw5yINWQButJcxxqdyCveHAd0dx7BIsN/ud7nbb3sFCWh9F4egdHTpO1KZRVj4+C/zgq1up/SFd+3X3TR/SsR4Sz+nhcGRHWDF6z87UnSHdET9DGu+k975cZgVdcSacn/BZnlgV7CTOdr+h0w4qSpH+Cu8HTEIZQwEmpeEf6xr+Imr4x6jhb6XhYcQxRHBAIDA88Qh99eJP13XZG+X1Jl5iPwOfeeLZKc/RG63HmAN0BR5AtHSVrGg+szfpluglSOsegwzcBoexBNDZLsh2TfpRbnuU2wHS1+RRJj+RYrT6JJVFrpDHkJvR5HFK7gSd1FmNhYvrQszLKpTtmEyd6kYDD9qTry4rTIQP5XQfrglWlrhyfk74QVAWNcB0lesM4splQyjj9LCps815JDR+lTI3gF0SoE37ljph8tBfnkV3RFtAI5i6R+PPw69DQDIoghEJi2ziIaNqBu9ZtJuS+HczF4zC9VbQAodHkD5nQo0BNeCu0luqiNEyWyrkvVTi/RnSGBXIw+8mFLU2kryPYzWL4mbzPn75U998cus3U18i8nIoKGGnjaMj0+Hf+RryIFzAA41j5+kl4QTWAxxhMVBZuAgNF2gwLqdyU8g7Bqt0A5VATdAE4nxM3kBd12PQAnVGQTkmb+QC4XGChBoHU2OGqVAzhf4dZvQ4j3uMecgyP2OaOVYz26lgiqZY1+jUJzLBNKu7oEycyQRNE9Ic6jCYoRmuxQk1S6C5sExlKVRz0jqlZkTcJ5wHM2xqEMNxvkEsyAXmbpG61RLPgMgAkBFDCpEYWtRKftlF6TSS/mljw45JuIQVwJ0lmM+rXKoXZUGt0bwqaxkaQx1PggHMapZpjtaCddHrXHFOZ3LZurmdsnFaQx9qoVlSBWHOx/HaVMCzRT8QClqeC4gRwvXNaZCQKVpVIdALNw73NQ6K0pxmqAg1L1w074xC3FhIJajqkj7TFjwVZapEtHxuxYOGWoQ89EplKuAarMf6z1MRDyHwIGPTmq5FwUZUiydsHJD3BHgtcA30IJ3ZfgIUeTwEmpEXK8KtFynEGkDmQjqqCjimkEq4k1WtFFZpSV+XaAwGzRitiP20bBZfTginaZqHsEESQXB6wazOPCFzwSzfAi1iZhbtyb6YEZlH8AJYRZ7cNfhUM6TIkGU6bCZpjchkBuuQ9VkaMmkaNASy5/BngwZs3Snqt+Q0iuap1zbriTVbYDaDk0zxDP2V1Tht0EmZr18gNUtzqDBLCzRvRkHZN6IyTn0CKawF11yjMs2AmEF1zMU0UuuUs6P3GUL3i0qmlw+glzKZEarSp3RF6zQLoixlr0fZDJWl3bZfSfJCFrGuIaYYApiwft8Q4oK1g3iLONppEUUhws1uCTiibMWgRCXUadjAboj2NlMcFw3/EMRM80DtqoBOmTNoVWwc5VFBa38f77NaUEGrrIJKTVTQqlZBK1YFrZ6lgpagglat7tlg3bPeQPesi+7ZCMpGeDc4hUwus6p0PaZ7qMSaYhsqCgRLbOWIdiOUMH9Wi9i+yqI/TO6a1W7m/A8uMvsjtJqDJ7EQ0xjrVG6kBUIdfcmjDSo32u0hFXDXRe6YlQUz4SuPitjtJf3YL9ldviS7fOVCd/kqdvnq7bbL9/Zq/Tbd25rn3pV7u61+o+1trqb7qqVd1d62txdclvlEqxvMabTBEufYUWZHoJWtrx3UlKbRiiulyPCOvQiY3QRwAm7DP4LJC7IIyprtBnIpyq1EuasRwF2JKlwaVViMci+LcrNRs2MxsHk0Rp+I8PJQhJeHI7xMBgm3GyR8uUHCVxgkfKVBwlfFkPDVBgn3GiTcZ5BwfwwJ52JIeCDG0HFDE0BxBIbHJPqc4jXeZEGHlYAQtbQZXIMtsUkS2o+SxCQp6s6+49U6MiJbykiiVL+k+URarI4YpMZ7fDaPNWALvNxTKglxKaEFbJad5cR2iulrmPhEpqIBdg5n58uELbgv5snRM8b0druVDfCevRlccC88rhqN7Ise5gpjBwLtg4wJTPhil0aNn0YNUo/K870O0gi8QamniCNqubF2Vj7grQFbotuKBtYjgOthbh0Sou6MPwnIXmvSGeOQLQrKgYKA1gw5WQfK6pGdJ7i/AJxPJxSjOR2lWxhh+N2xCeyPaN3jBCVuBspzz9HWlPEK3Gvc1K8DfnkUqzx16L47aBnLvUxpXTgCr/EIZbRWlQigVTeYjEf0M/+wsO1Hy/VqP1qulxs6jWX0pe4nUlHdr6Siul9IRXU/k9JhqF38fb1rY9x6NAn7lw2Izj0eqshhA2PiRhrdqSIArjax2FVX2DPD5IHm6ZC6Ia5/5JWDymbG01SgEoV2iDBm+lSJOy3i2JQqeQh+it49CmG+XQvUoPc/7rJd6HRMWFNnC+stVli3DySsr48Lq8w9bLZ33vCfLlW+qwjv0ZaEVwZiIS2fS4wx9kUKM41yESRkjEUQ7xYmQH5Bk51MsgCqIq5sbnp4JBnvivg2uLZHydN0zZak46HLO3k1e7C438HiBiEWs0ffYCfBUfWOquo0cIlC4SXF5reapK64ywQPW5kYiwcxFXgEFsz/lBTQc5GTz5Ak6Gtzqoj3qz4mZRq9u2gPnxEPX7TRBLOnoqM5qvs09VN3qlHJ5Q9IfvIFrzn8hA2cztCpPVKP4DGVDlyNT8U0c5kG3pNMvfeE77KbVNx7Mrjfe6K098Q/p/fEv1N4TyabeE8uaeg9ueRGLrDeE1DGe+I39J4QjzvMPAwxP/7t6T2JftR8A3MGpkuaxbijiemS1qbLiBXVdGS6+GK6LENYO+BkyFPaWjBlmldrWob8yIIxbhMxV1rwnnQ09558wmnsPcm37j1BZ+fznhy5CO/JWCvek6C59+T4wb0nK6pAq9Z7ktfgERoU1w7yoah8WhZFNVJvVy1YuwqEsbOwOgtkjS0s37z5F4+mdlV/nV010MiuytXZVdb/QL1ne0+ujrwnV9Z5Ty63zdrvCO/JVXb0K+4x3pPKAb0nB1BBeepp6j3Jxx24SNaroA6ooLzVPeusezYa6J6NwCqaFrwnpw7uPPmE08x5wkUX4jwJWnaeLEXOE2zCkt3kHcZFeqGbPI9Nnr8dNvld1nly6o51nigabOo8UYBtjOys86SNAPgE3VDnw4CmKvrtJfVQSCH14P8ksi9GBGABhA4wr66hRhtjQ5exoXdObOhBRCw2DOuw4bjFhgalAa0VtYEyDqsEvwYXlgwuhGUHBVCK4cKSxoVFlngYJrgUzGFWIrj1AwgGF1CIZZ6kwh76K9ajv48tuY7gRlStR4GmdFtKJ8jk1POCB7e8gRHEltbor9YmWDDNz7Fdi/52sR2R/s8Zjf64FicM+tsV9KcLLfrLHAz9bZ+M/xr0N3rR6M+L0B+QHxDgWRp4VrMsIBC81yz62xWljNs5CPpLuRb9UevgD60t+BMmmvYF7XtR2A/dnx/7oVYz7LdrsV+tHvuhyJOixtjPvqm12K/NWs8Hwn675rEgcjhv1sY+FsDybYD9zjR8LCB7Dn+aYb8zDbEfsheYzeAkU3HsV9uH/WoG+9lR4tivtg/71cxjBsQMqgv2qzXGfuhX+qztw35n9mG/msF+IMooi2G/2kVjv91WsR/W9aDY77JWsV9zBZSn0dsD+0VqpmaxH7KsIq3HfimX1Jq+Avt5EfazOqRsuipr7WEy16xms+qeDoD80KQ58ott9ebIbzFCfp9wmiK/1re4IL/bbYs3RH61Zsjv/+x9B5Qcx5FlZVZ1d3VXT3cNMDNocnh3UfXw9oESqDf3jk8YcrnCFIgjIe+18t7wBsN95Mre08CJIAVqoXsjT/Gw0kxjtYQ85EdHN5SFvLcng5X3wuphdRAFShc/IqurerpBt1wPkNOZlZUmMiMyKzMiMmJwSg7u/PD2ntv5/Whw57flzu78MKT36M7P5ju/wL21Azu/IN/5YSeWJBHd33E7NQns7B94YGcbrUJ9p2TrdWfkuJPl99e5O5lMnPwjn8mKU/Z7re+bFwfz0IuGrf6pYUrYaYV5u0QeIYxd6ImNe38bB6gp3mQvkBR7Lhk4VEtE954MfIsiZcGSXe7ikuhSWvggoiLKvpf/m/z70mb40PbiQ4Ba3NBu0yqdT8Y38/sq+aiKTeGEZMSZo6+NiONV65w5+lTnRg8OOFSk3KEiD9aiph3+/szBLoXwrmfFUEC2m0OymEmW4zIjVRO93+2aaPNaglb+2NyDR/RGkLTcuAstL6KTjcQ6E3Yz0WdxWYTkDtk0fs7tie3MOd4UxHZlTXBkSCuSOa3y2poL7fQakfqX+JbJFaXVLGJIFSeqUMVWTrKyTNSzEx5s+iS+WuYjM6vejsUbDQYaftz4R/24SZmA6nChjNHi7ssLNftHVb1j/FOYewrYCF9JC96u17gnN5g5LeRPCMemUZ/puf7qd1LW85IavxKFpSuwJoS7SVQrfBvnI76yuRtf+b84pyg9Fiz9RXEtdbDkdLWBUehlwG0sgkU0qqPrDap3E3f3DtBLF3FvKTsK74mz6gyZB23ExzGrCSGOQjWSeGpdSV0NAg43pMA6pzm9YYOqTV71CC52j1ATI9rUbSzVCuiBWbzy3Stb0t99eVAJd2FK26HDvXqo3T1FDz8iilPBnBPAKQpCdSLShBMRPIWCHpSoL+NygT4sJ1GBqOZqRMFHWMst2BXirt0OroqO9jJ10zbBMusi1YA3ikoyQEMVOP+huli+zTcjYpyKwUIuaiMq5RFpShVVB/ZilxpLXH17sUQNcUEJbcWfoI3awFlM7W7S7kdZRK2CHNQVL/nwvwuXuzk5tGltYtxsM3KgpzaorCAHI+RgVlHaWpDDWuf21uG8WSKHJrXwqjWEHM4peS5RTLvLLc6wkfjVye+4RL8JKkYMldp5O+iQr0BvRats6o3MOK3x0Jfe+vktzJ5XMfhJM/GbZU3P7SNUdamIxJWPLZb/Z6Yhf4pUZfvkKpXtY4XK9slCZfsEopG0qKQaMKkGojKeSQnc6Hfe2dRB5Af2yNK5qht1ufNdQK7G8HLAy05UxXAGL8UZEKQFcBMtC/q6muA8vEGBTptUAz8ERjKA6nwM6nqDvMiYNIt5hMvwk4nBu+NSSQ2UUIXNHfFX1lTPzAmTQ1rDJcAaJm1Tl0RDVc0dkVmEvbxnuQN6VR36wgyDdlsHoalXiM7llUe348UluJBqD8VLCuO3oGPinzVwLsx0bWhKXUldtvi4R4cdjnoE4xjVqVncNyjc61EUPdSY+a2Pf/rXvtb58fP+Bz7e1O/WdOvx2778op/+ye82Y8qov8LuQTGtgAU17KYGodhWJfuMyWh2qH8mm/tg85wlMTmVCOLUSCo6H6j0FvdZUZuPr67eKLMgmrdK123JNL8p2qJSW1qlL0WxYAbqCrCjUIz1HPvFzgFFoINrzrZM4vmHFgsY2orfps1ikP0oN/pmCxegb7amdiofUWHZRxRIJvcRhTwWzXqCrsItVOozmnBlnPjP+dcyDNIJDmuFV6i3A6hU3T9R1QFeAein8ua0/Z/Wj9M7bteP0zvx9m5eNDw8cNHQf15x0RAPqy4a/umwi4bZiy7ffjfuGKaFQzlbvmQIINwlw6uCmtlV22l3mR12p9lh5ouvvrtfavtWZ+kcJrx3th/y5Oegkza27LpyPo2oQfz3yMk0QjIWLQ7idETetmiE+I/ftmAI7JGTSVvu5KoDetKBUVeeF0pTa/D50+TUO9dCmSPc4hFHgzTakbY2+S+ikDi4jINok3+JBk+VXGt3pGOb/MdyEgcP42AtzhsSzGjitD5N6dMGfSKtsaNVxfoU6pOHba1+fx07hr/Ij5SL7rgn5s1yl6kxn0QUuocR9rWP8erPkEZbvEeKo5P64zgoMqctfdGiJr/AYS3ieH3n/HUYAxDrvRj349eL5sE4rcHfkyeTNfgGwq9f/t0HN7OwKKRuSslK2prrYXNI5idWvQmaoIoIBKKXBFV8vEEJducdUUG9nwoaSgWR4LnJUPMf47mpVDCiVNCSt23uURvY51iT2kwFsWyFk9EyFawBFZSaY5ytOQUlNHekbaWEtlJCUymheQ9QAtfY0apifQr1aZAS4kFKiOaTZg+5rfmkvZoSIh4rRXiTGmVKaPEw6Ys2jSglYKyoUaIEYG/cEUIdf8+cTOoghNFhhBCuJgTQQF1pYByllQYebewwN5uZGl3Cgsx+qp1hL72ilxR2z/Elit87xBXnyVZoxKGGP8/hiy1fBXfUdTgorjP7OLseMuoU9G0IudINinSAGfTI4Wlp5XzvOsmRHdM9wjGLp9yFNWLHDX6PGf5qvYDMnC66xy0cZloYaCALXdls2YnUsNs7jCr97LDhnNs0I/8e8Wbjj+/r+c29N2dL9TC1e+99smeVfR4nodzkw3XRvkPIbsN/90OS73mX3Y8qk2m9uyS16L9njaDpmuNRfGNzl7FT7q+dBCfjGqPTsH9gkhBYD8/zF9yYrSejH4+KbiQac6mdyyz6v9/ovvjISrEvHsKyiZhFs/sm3R8zMhY1ClYN/p3YvMm/Bkm6e16Q6CGXcJwPTxwSqliUVoTTs7IyUMXyYNLhlXx7rhDq9ke7kTQiRQY13k6VtyuyK+gtBiJtysTh5ymSaPydq9XvpORrANewbPzY+JV7kQ4rlX1k07iTZMOLWaOPcCjs4e2Dm7tdzRh/F60fBNKwQeNgWklsCu3lnngPgdA2SnR6NnfZ+zajPntBSTFVzvYpbVFrJ2IbEGNbCOycmtHduRNdeD53ITW9TqyGHeWF6Bu4SFrN5EoqHs66aFILvdfohFAz+tN5UUW39lUy6OBiLFB8GzVBmeAfHTLxR/fI9AZW12kwoaOw6Bc9PqDx6xC/RuNTHH21RvcjeUHjC4jv1/iKB4VdvzeEezV6DbLs1niHoyetRImjJzQ6gQHR6LpZDCKGbGNicCq7ziQNzPNrjLLA3mZgOg2x/UbHC28XzHn+MuLoJKevGAyebucoH6AKxkMHSDoUvw/LI8gC+7KarBbPlMWWm0EJtMzbRjzvf/1LUIMYv+SfGD+d2fjvQFl4vyD5gTT/bNvcZPfjWajMNhWotMJsxK237py94XmvumRzFyzUzGPIv7pnH2izkGgX0WdO9tIXZqiIPmPypIU5MGpsmyQOM+8Bk0lFaDT3RINeUKW3WhAWLESFkxK/ERvP4RkAbCy+l6mi+SIZmKTWw+sNpkcRGHNFsVKnYhBoMVQrU2T8fow1vmrA7ZRiUicD8DflsKAY129asa6WXfxLRrFcojSgJhSBPd6NXS9yfzW5p07C1SwJYAh6B4gsjF+HWcBZQIZUi3+JZUgXtOyLL9u9T1/Ef4NcCn/+8ips598k6e5N/HPNRX58DWJelMVaP9Xjo3tXvftEpQJuHr67tuSDvuaYMgee7+274AebdiahmlWMfwACE2TcG/v7rd/Y8c1/+PxvbjofPi3qW19hN2y811/Rf2fWtX5KFm7pY7H4R7FwD/2qNPiT8Pl8heeZOLj+H9Mk4pz2ZPEt0Cb0dj1So0yqIevWSJBPBH7YbiusxVwzujPD67Hl/Sl+vJ0fdMkXzHQXt55z4Vk//959z9xcnhFhgfWwPCPCYkaEfTNCt7o8IzjEjIh/iLEb/OCDmz4CMwDxj5AhgTzP9lrQ/bU/43olX/Nu/GNFg9FUIEN57vEH9OKBpsc/vVqJ3D3+TOpvlbGqHO43ugw/R4altN5TosHyg0MG1btie4AC4FmsxlK9ByMM7ffzwKm+dBBbj5BGSqO1yMrlbhNUf9aI5RqeLf9+xMtPyPnJQgRnROphME9KkEZqlPosqsGl/y8AKCcVPv3D6K3Gd54MZ3oe4E28LGuqT9hFZbJtIat2JEqNW2XgduO/lxFS5gCUhZ57vof8sHfX60Xve86IowqKpVXhubkcixcw+ReTzneTzpLNJx350bvL3J1V29wxDgw+4R4LXRKLYEwFLXFSoVM5xEYLAVXAiZzjRn+HnsialVgtGmhFFf28er3vX+jc/SvHI0AFZLmGDwop+QUv6MeVAM4iK8VKsdvvsYRkGU1szxYpHwVGPB1wYTdpsp4Q5NaLssqToLcfFV6ObNlr+QcTST5nROw4nvONS8XJCMK5tK57kY8Y8Ld1L+KX9zEm99HlYxtTy0CpNTz0tjEMAkpVB3YwUiFK8u4FY6tUgrJ8QnQbbKTCKYBuZKK8xxrKwCMTRh6UgkgHEoL453+VW2mCcBQ0gYezXGZCjbcoAuJfIquibz0Fwsnn1F8hNeXHFaNjuwFDjvy/lvyNYvK4wV+fylynYCkN+md4A+oHPMOjiKIcZnmhOx/HyAypqkMSfwiQRb2mRHrp2kALWG1XzEArkWsl6EFreotgEjVtNLg25jknk2ItAAetyCqdC4qlaMTrz4g2i3WJ+87tR2B6+YU7fM5UXqOi/2rMsIMu2QzD+3+GHGJXgsgHY4QPr0ZCn/8qBaNkwaya480syELKJWMxWdHvqIAhUiUOwrT2cEigA1l78Fy/DtywxpbLqbYjiTio7igMbiUjKMRrO4I4aSPoJDFDPypnjOomf58hH3yq3Qib4In4VANPRIJLNPGpmuexWuRh+rRN381ozml9N6WJGzQLaWJHszDreYsnVsJoFMevihy/2vPpmh3pWn7Df4+eTNdSizhhbEtM/Mcsn7HHjXhS7vPeLGmZeD4d35FOcOoEylCd5DGmCZTg/DQiHI41tHYe7A8+xzoJUYMj3JCZ53bGHimbrlEgbJRUjuWD74sO+sItf5QQOBYknELeDkTpQgxowE3nyDs0NSxSAzBpaZ121YfQ4kaZ1sAa/6AUx0Rws4JtSo6u+Ea3ti70ZGl/4hVZMAPzrCgsO6+b99+pbCuS7Tv1Cuixuqu6s7LKBFK9bAJJqNCA6moIwjR8eFqH1T/xt9jgYIVyAbTNRTepCASbKlmoCk1wEIIKJOhQlckzFM7bFMdBsWkMWqkSBzEHYJZpcCLU1GOhFv5JqFUedelfd/k+79KPhFtE8ZYX7CZoKwCdCAtxPh3lJvltW8irjUSPOC1meomFwmKlsCr1SnX6iRJJYbq2RJdKZT4ojEap3aOygNYikoyrnR0ktEFtbYpBbWLVFV5c0GASb2kno9RI6hQlExhEhqf1GNlKBTTK03Uir4cPDTgxOObsuEhsx7nmXVzzw9TpUj37CCfWaZQTudYJeZygmFtHVx8hmSy1sgaDuY5a53jLv+dTQhJgjcbjITzqmWadOGOganwTyEZIIFGCgGXrZB0WUOQQzTmqIv9ksi4Ts06wfQfea3YBQ9pBB2QqBrOuD+Pow7ga1+YfmXUd6VCH6hLWGfhjhu+IchijD0Hux8vRRejoIAQdaPpKWFAXiKYgL6Gc2FFKG5Si4bJLP+xqOuRqWnTp17h8Cy59n8u3O8QyBj0nprXWXaU1UA2ISWl1FcEV2YT0kMBBLHWN/TmTTJvaO5KYeOnakYRMaTR2XRpsB72BOxJwJO2wNQBg87Bi83KgQlpUMqU184zCddAnoPrkdXLzVykgFBrBSi2UnI5Dm9BO8alqijROHCcXjzkeu7iIskASE6CGM1wFxNifpQkVucUgylinQjEqNe5uDd3F1OijMjUeF0IhpSFhgyIJI9JPZI1kSVINNaoUYsl6vn3+vLddDaJmbVn7be7lNDehmoT8XBeGEOqv4MaCWjMVB91kJjE6ap84UAh2AYA6lrl6ruvI6T5KZipwiFBSquSI2KtAU470uRBKqmp/BNqOVitH13kCNQQOnyvQwZVaFEgujBqURQ8atCKah32+eu62tY5XFrVbdV2K9R0Z8uUDGaI9Rtn2FgdhmcaenHhl/HdsCa7CUzgvWNmha5uXOQusie3pp/hk8t5ZQZAlg14a1WhVHoceF+B7BZ1lcHR3tPceAwE77veXYVA9GR2nAgh+HoTiuXfuxEV6Xgp0m+rpeal8Sop7J6emHrimLgVwEFx/ePWR6W/DimWhBgQc1bzxY5Wepzmq5AyOfSser2CMR5VaoL3c+Pzt8Z6bwgDU00tx5hG+4E8sGF+B4xCC3xR/ZL+2eQs4MaCZffusynkhJfkyWq8iTWTO37L84OHxZIQaOenrnGMI66bG508GlxlwaShMfi2A5ENcAnyfIwhLvJyVVc/LtsfUTAwO1T+xSZ2zEC/bgYbHAB6/g40U+dVe4feYdZxPYJxZ5ei/aA2MSevWo/z0/j9nwKfoPTxz0kUXWQmMlfFIVQYaqhARIQiw8xGhOgaflykDVCQtACOH1baOMtJVvgQxthxSm0hhY7sjjlseKMAD4qUKcR3SPYsjaivzRBZuS0fU41a7ibKmOKdSWB4Dsjin1rd+5k93PfsNi7/dXNz875I4b7TCfM8PrlHv1Ko0Ar6MHEv1uTgzVeNfIFUPeapB0UDQVKfUDSgFawxKfxzAjqz4jyELmEJU7bFCrRWbl0mVgylkrKqRd83j65nT3u1afMmF47HWkJduUKNUuqGlbV7aUs+7SaMEhsg9tDp8JTB8Eg3jT2DEztSB6KjGm5czppUfLwShM+43QpVI/rLVSY1l4lo36Mcqbp0AOygYXJyKM2igZ1BJsk625RF0vLgz7txPFV2bquCS+byk2gAzwM/eqeeWpqxbMcAAp1gTg16iGjX3hX8Sd53PG4xRQB4Y1x4W0fLadr2xPgttAWRO+qnv1viLcuUfq/MiN+pdCO3LirdcBdpFRm4KZYEeJVOIS7tJLZI8zeF5oPLcFc+lIlOpLr6RfMlI3twy8xwrIAr0MvXdx+BO25b9+F2yRHtEcr/034DOzGmdGVvWmYGc5p5Xmrni34TSzGmlGVtWmgEl3JNaM9dVK5Ct1cpqz4fr23tGqKvZgar4L4wPFMb3F6v4PVBNa9uzOuzi262dc7Y+6vfJ7zZ3k7C42jKziINEdqg6C3D0q5xECMKkiUA4g1iIW9hQZwbW97nAgs9NgmbzFdTnh3Ya54+2rB0/ilVvqZSwZutPo+THt/3x1xz3lxjyvwbk5Hw0jJK/mKflcPYi0rsF7hfCfX7K/lcSHx9TnUD35wOxfvHGACf55/mHqhwqxGO4W1ZTh9XaGj9gvJdef55/GPlEEMYpIVKWqzo0ScWdBxvI3waqqS29fEbahqDaIoHhoBpQXHPnNrTCaWPA8BitVQyP0IhetICz/jW0ZpE7y4PQ7aHk6pmDJ30UqS0fXDzpw81dht3Aisd9q7yA31DleVSbW0590dT2i4s8OOpAq1+hphaNgut0b//rOOF3FwnyEh1WJZJDdehli/u45yUVAAYXOhGw3UbAg6hVSedHsCeQHqIDMmpbf/Hw5f985c+/wBIwlk4cG5dR6V2ZWD8DeZ1/HkYUh0xQy2U8+DIOazFSa93ZD2KpWE2/r6Jd3yllV5XMWYVLcZLvgao8FfL9xMusBfecDEzl+yrUsuBm+7IvxmTDZp7IgHXb4cDHImIyDxseg7ykr7FzRprl/NjTSw4tvVHzb5D8diMSJP8GpFnNYSUH6pvWtmfytrdp2zPa9rTWtVXb3iavkX0r0qxeYbOSQ0s/SvM/TNt+FBIk/8OQZjWHlRzRF40J76Ta9VHv0lzv+q1fecs49Hg/qwrJufq1zUJgr1boYUsh8b2DY2Youthv4cLkZ195y1caooldiz/Xp4Ydf1JPjypdc9rU8eeRqOckPH6hpCht+xWloxONoIKrQ/xXfIZ8vWLm9evwwfaYt5xUVKqUtR9Y/lD65MHVhektKYlfSMurumx0udtFKlMxVbhOqJr88eUMiyrAV4prQlTRF12qLG19303PPPL3z/klK+c9Wv69b3OvJmzluwdTf+u6uVsm5m559mby83Zmrl05uPXMRcP/P4ClSEvdJaocXEz8SF8fvXKGAm2Eq9j66/Nu/cOW+/yIW/aXUq1DMz1zMr4C95Q0K8ZHJFiQComYnUOqsvhQTu21+K0I8+p+y9XxLOWWa9dqLdfG+5FhSW418h8fgMoADWuYM1i8MbrHTWs8cMACSEzcEHoCELhMDsZGZoSlFiamH7H9CDU5Qs0AQs2/UYQ27ioq64pFhFTPsVgdxGJVsFj9x2OxJiOfeBRhtkeUI9GK02KThMiGW1qp4GAQt7gChJtN3uxp7P5rwi6cIAt+02gSSjX8zBHBo+HxjyKZsQkP4umV9/TKe3punl55T2P3n33lHbhx95y7c0fwiwN3BI96ZW+EeFp1S/BSlnWps1/lzepdD11ayId7rsVdl2pBP/4S6s8vk0IoZ8NN1km/rHMHrwefJgcWDUkQaOBFU9IraSP+Miq7o4uIevFQzyvle4eAyF08fBjXucqVO0ChQM8hegpJ+Blh7pdd8ph4L87IUlvBm+GLk1Yr1CMUasX45qYoskUoZ7uilnpOONHd6AnMnVdNMJz8uDmVKok1xwpObIIIvCluq1bxMshdvecF8CSM7NTPOtLGB+ydPup1yie9r3j4IJz6iNcZPOGhkB7x7uWOeF/vP+J9pXfE6wy7aRuwYnh2yaVZZ25WZp1wH3xUVLpvGwzet6327tvWMEo9B+BNDmrIJ0EgAd7F3ygdI6sD922/qcfbBzCNq89CvXktGFVxgxJ6CvUsuZgcH9mrlAeEe6pm7EPNWq4MR3fv6u7/HZiWnfKs7AxMyvI0+RYK3737uor8/nnTyafNpcMuqBdk74sRgux5mE4qywDEuDEuHJnClM8TQZsg9uySXMlRV4KwfEf9rcaYvLkVrxBrm2FDCQaTiJE7HFhceoJcbAMuNElsimMkselZ4dcw52s8sUhh9YiOCpmh/8ryXTAGp0DswPBSV8Vq3xXqResetwX+kfDdcmCvsBU4CLRivESHnnTooZ+pIsFjDfWZratNkLIYnddIJGceR0WwLSYklzHpYAhCb/X9ZDyt44stn/TKdlX8InFssQjjLn4SUQ28a2fEJVImYpODrlgSjzLVeUHQpBG0MUIGDiq1evChqxQiPVyWNpYP4ttdY6gw88WITINCV8aXZCxrCDFKRlfBH0NJPuBhyO8Cut3ByktyvqXHnMmDqRmwL9SZWcxNJGz9zKfx7/jmLnM4ZzP+f/7y+CtyhSVwMstiI+AfTHyVp1d6F/LFiIauCLbYr6iWRyC8SbmWkOI7axi7SAiX0rC7KNcfOD2Mj6rGWslSiSkJKqO/boSBYhvaF/wXvbiki1str7KUs1H95xFL5X/ScBpDKokAU397eVvV4FWg9ESh4laAb3QFtYucHME+RgQkA6imTiGIa6mupjqA9lC+YqFTNaJayRYUpMvhMMOd6YiKwACvVDjLbNmkrXXX0Fit59ohJoORH0UglpduG4PtGP5dix4OqbwlFDoqQKYR/JmCjRwn4/l6vxZiI9I3ziDwBLV1DJCPS0/QOL+hCCDg/Xg+GDoUjpE+RuOcr3nFkU9cOvWUH2zOQ9TpwJq+MA9hrXeil/zhPETyOiTPQDRycx4qWCRvnnrm0977+RvzsHjz3Mv8+7zsjIPX5yHeoDaS//gplT6M4z8FdP4rn3v8+d/44Z/loQD68wP3ftmPfvj4m/KQ65D0HX94159//z99/H55mKd/5Wm3nLFo7nVzHubpf3siHh0d3bM5D/P0+8vG+qM356GmC6SAye3Lb85DvBswqI0ej9Pq7nx5et9NP7310I15KEU/8q733viGXyX3y8McjLc/4sDuh+585U15mKcvjH+Ku3Hr/fIwT3/hw7Hrf8zNeZinP0i68abNeVh0p0OMX+OoMA/TM257yCCNMma+atIzb3tEOjnMtTJNstFn1GZdUh5y9ocQyt72CEe4EJ+PUYcxjtrW0Vm0TsrSGbd91tBA9hbPCot5GkKqUV4EMr221ZRDVQvOmrH4Qys8Uu/Vf+lWhaZoanJ2jmB1kAWeKlg4PIhgFs/jn1NVPMIV61flLtV6gmvlH6qW1M2vNdbsqs7rUoNZ6ZeXuGCVdoLRpRGTGN9cuzhgN02joYAZdqm2BJGJs50GQ19aNMQXk+qLKT6bvjar2soBDpTkoT/RVaVdxVTvLuLw/RlEWWr3pgYtvZgDCz2uGvaNGzmoZRtlN4EYcayDmOq1+oVCR4Vq8ffxQeFcU/kYva1azSW3CE8tuz0tuz0tux1Hv1fJbsfuhuzWS9qrhLbj/UJbdH9hIrUI901A3QSWqdylxE9s7ub7tXNvT3w7hsEau0fFtxd55H2g2I3Fv9GTwGASJ24fSO0ejE++HNVk7tyfcaoaj/9RLs1UhoaJf4yEVBgQKmVEQIZHEofW27NyZPpPTUFu5ehzWA39+dJJJsgvh2E5meLA4MASgKhZHozm5EpbIKa3OAj0IIOYHmQkpgcZTw4yFYRHx5Mq3vQONEatEiY17cOSELiNf4+xKO2he9GnTXa7uKZAPntq6qq9uZ/mynrFWef7/0a2+fkOv7pqhy8TOP7Z7W/xP+b7Pr5hQ06gbgOty1HVl6emGGBIa2oWBQsHUj2SBJ4qdUVF2qBAYOh2k6joX0B1xUo3bS6VDSR23+i0uYJe2tOZMnrHwiWusC59E7VSj5oUQqsv/jl61zQRMspSX5RZ1NNxnfONdNMGP07p45KcflEfx0iK1DmGE3VDYjHeXptq1rCX1VMLmVSBfYEWFl65glGTL7SusFjIZY3VxSZtCJjhMybTEWprQh0gcEIDtI+eAL68J5EsM2nNLSotPLT0IXLW+gQnuqKUD+ZHjenh8GiBQ6pg0j2WA9hEUZ7Bw/Tovw2JfK9pHL8fHP9L3FCqnu9dLNyDj0M74dweI2FKYkeQuFGin0d0g5uVxrEXNsD+sLz+Ol6vVxVygnqazMil1BZs95mSbjTPRyBLZq/jQ/xCuWjcl7yHH7A+LgDYf9bpKKzAMZ2OsU7Hpk5HoF4mZ31gcvpuctZlQiraDfndNNJjeYPJucsgYWtpZNp29SQO8lFF5Lz4tXn5OyoalSUQiV+e4vctWxgVolNmmrKzeswyEvMPoVqJ5nJP9/D+YWRhg1h2r3znEUnb5vBYuzyzhW1ioJfAKdbrLWqDw/BP7zlQ9b8VT8ymBhffbZbh8bvKMtx+h3x8ZcemfvwP9yQX/7d3hj15fomjHuQc9bDgqF8ChvqJ/asY6ujZ3eFsPviUAoH/5wQCHZUHdFaJAxQEVFWSBpx/+9KA4bCrMOC5nqpzcSBUp+pcmiCzC2lWc1iXA09NzT+muZqKB8xNHFt0suKtFGlqEGswFl1szHC7owyzNId15+pcdpGzdDWlzLAd8xSNwFPmxbfK9LtQR1ZZ6L4TPMBAAvHPhln8dvCzfhaGJsnOJo4OvXxkbFTzeIO14kWPMWZQmIGOS3c5EgDeXiwQSOQhvg3AaPQPGi3gfo2xuFuv5G0Bqo5zTskeIyDxkd7DhM9BbpUgBHrV6oWXQAAr8GuCThCcQZ3ZWqP5DcbRBUE70imHJMQcGT/R5JzkUBYnxbaMjenNV2evVSesVunpQKNK7U380ZcKpuR47cmgrsbV7pf/K8LVFQBGo3sR/Q+Fq6/fIa6u+teEq6sLXL3sPxyufjyIq98aY4eNJXkwbS7jibVzP8ZKgXheagUMNPMi2ETgC18yfPr6ktLrufJrqfNbXlGnrsdI/fzQ1AuGJU4VifDGoYk0LOfY6pwFpovPdWGtHVAD0fFvsNzqC/np313d3c3OwstXb3aCsmnj4E6aNr7s7ps2vv1D/63GmBcPtUUGvuIR3EXNPEJ8uRQ/VIpfI/F3CSVhnqL9N+PpTLV2dgLvVxkxc0m47atR0PbRIvqtIvp1ib77VNXb3df2su6T6HuGZX3vkETZ6+HG7cqeK3HjVirRBwwbjs14wAR6lSxl0R/NsB2IZtaNyJfNalEyUo+UUldQlbhtwRr5Gve0UjxJifcWJYodTXZoaOqBoakLQ1P3Dk094a1K5bQfGEdX5Z1T7GUfwZDksEb3BrXqIqckjNGwMhrxu5CDRySfP/tsMXqfNyXuEmYKRvl1KJCgaSVOZUxnJr5GXtgCV37GDRS48gtc+Q5XFOSj+GnDLXza5D1D+qFTpB84RfrCKdL3Dk/HeA6mc597GgPtqoFIdmfIQtkGDyBKpNyp7IhI12226YHZLUKqr1cCuc3z4iSQkCBJONubSqqEF7IAcapH1U3elDoP8ojDgMNYcJN9+pr3vTu4KDt0RVGj2NwyF2W3vqQvLeRTJ7ukzK6/qi+5OTw5zvbQQOJZyGsHkqeGJ6v9/rmMwVv1ZizbOZu1BwqMqY+UDqobbLyThAgIb6cG3lJSR7A+e+Fs9ne1gdfr1dXKBhSOB95uSCIEG4c3vFHNUJ2b/dnAq3PFrId/OYa7/Mpm+3aBOzRz/wFcTztcb0sqEj42aZO+uYSxegnH2xw+1mF7m8P2NHkgeVx8BYnj5iNIOlnjdDvWcriXw7FsGpJsORiO44B/QzohXghqlyP4fe0BI4bGs+Pexcm63IDNOtmK5dmwjp6sbSt3J/NQJwx+PkwE1k/mOYmnJ8rTU93TU/veXaJPyXikkybp0HjfELXYPYToe1Btjupz6fhDy0MFsUD8/j1umF8EMz80DqswYV82qKOgwXXUoRA6WpAlTnAqCqXjCOadThCNY7poH9N1rpfJBK0rj0sAazGqDYQaYYFmoh9qCren4wA96od3jKIC3r0Go0sRAO6sBrijAJ9BnR7AmYGcSUsq1PtMGt0O2P4QsCMBG/XCKpK/GmxO5nv3gLwh2hg85qx8OzDua8vjvgBhq68DP766H+Nq8o47Kv0ggw2+PM8mRnuz4HrzanN3kdA/+tzIdi6GPmSVAdDXlEE/YFCteBY7BegTZHLQ4SoKBnsc6Ar8AQf8okkBDPDUNNE92IcQlD8y0I3RcjcOaTeAgTvuRj/8hxz8b/ungp+XvgHg4zLw7y0B31gNfCMHviHAK9Qoo1Av36NQo5lZii7Kjl9ZpDHbuurX+DNdKVx9Fcx5T9YtwKbfcF3G4ltQNKnqcqv7BJdW06VY9xQuLdRlWvcfLq2uS7juVVxaQ5d33de4tEjdCh41Q/0KNvlo8nl+RYisGD1+xqwPi8Mi/liiO4K0MG39RdqGKi0/nJXGqng1Okd52hR+NjIluucxWFekmG91cjCKy6Biv+UCtT0zrRZnnkgVrPLT03YbYmfbCzbZB3GsKvrAj1JzMXRf+1iJgRn4TI61VG7hU+svVG5hEYPYAmp8VHM9b2lTz1Ml2nmtIsbRVGLrVZU2lKZEBCSxJgBhSccTYdBLwZubtqTgXbaJtwZfzjefFdaZECd78ZukwRF+0DO9GEQd0R0wEjVmZ0RyrXQJVirg0664fkgn9IarVPUiVI9OCxwPmrYPUzi2bpIBM3I1V8w4CuwYTjgivK99aj+UmedANAWI4hVyNYigliP8oh1/SImb6+EnNvwFtn78B2xUFQOB9vxqTSm8nVHJUnf2GTlrLsnXf/kre/YxaSNPbuB3ozAORrw8P5lT541eWj5a9Um/FGnAYm//nxq1+CTnA5Vgrhgc57elQp3PmyNvDpEXwbS/hTVzNfIQ/28A0KuHgviAjlBxxPlYrcpslx1Qlwzm7Y4Ba+CZTFiddLoafdrg94gR52YXen/cdTFva3ZdSJZlhEDsY9WAyZMm1YSkj4saIRSojOrFI8+jxNrZ2OwwRUfwF/jl+lnKo/EsNaYRw8kp0lg4CzpTq2vKCQrhaCwUnldinKfDfni3Z+deqpJIjIihOkIc2DAoGk+NFkl9V6iJQqnIlJKwEJm1VFdUNhF1iE4XRVEM/XTCItkalj28tV2RNpm8SLu/iHPeJW7T2oVYr0Wt3gMLYuODMoLXL1Hj+nS0K/WGaqKuBJ/AZk4FW4uKWka71D6YtnpyTvZfYnvNe2qeqdVTJno2HpsYbJaqjVLrIJvOGAPTRUY9dNfWLi5GGabrqCnaWFiUplUbqy54qWOI4cUtddpcdUzFmpj7Vr2umtpck9hYzu0UW3jxGxRrMhfq8RvlqR4v6tqUp2OOoB3METOHCOZIvh9P1iB4ZrIWL/7GCHqCC+GTWjRe63xWePUr08ZrmOSQukvsDjeKPf0aIT/kgsGpV78mgZBbKbSKEcernHALC30VBBWqIqiqIp7JrxBhmhUWzsurz1v33u7q82Hf1ErGEQtmjY7FR5iipdfncAOwzW+Kmn+MPUh2HKdlzTp56mbIyrxgdD0Ii5Hgc5vEgE+/h88An0pOBu7gnO7THtTwEFWp/JhEP4JoTIHwBpuKUgdD4usRteI2TVWHUTn51PCwTY31PS8JFajDDqiAwjkFqkbBnMCBzw5E3FV8si1sZk1zIJ+rQdA9fL4K0IUVu1Fi54oOAWLToi6AGLi3hJh6HjlL+zWstzoGMZid2tuuOxZ/vqcy8K2J+jo2IOXzYiwMkx1q2Z5yo79sV87H3u6/XC6/6l6x/jxMPphYVGPVwckoZ1I/Na1IquSa1TGcU+51Tfoa8jldJmiYndRtpFi01KP/MxPMc7MtGeEguD/WPFls1MI0CGsEOi88iWqijNDip4Y+YR6pZm/5D8t57tZ6DSzErsFaVOciEaeE1LiIyZLf4AyPGrChQIFAC+ziAv+fve+MbyNZ8psZYDAjgZIgESuRAkVUN0mQIigBJCCByoIkUuLb7Bx2fc4BhNe7upfDap3TixTl9OVyzidnX3DOOX1xDhe+OGd76Xf1r+oGBiSoly9LP6J7enq6q6uqq6urOrjddiopuT4cNU3xGzykm8mJUMG2ZV4kwXP4hMrSmNMM7xnZxXUGUstOwe/BU8LlaMKcJX4KTAUF4j8e88ejIIyKVIaom6aTfTPDJUzL6zIjwp7jiis0w1BySsLRco+fXhaBcHoLbTi7N2lmgQh6zlT9Re/cllk6tfcaI+L3h3vfFu7933Dv3t5LB/HEacDUKTT8lEdYFQircuO5yGmsoweyOJzeNlVKaNodUFyhaYbFIZDO0ilen/H0VxH2pL01gk0gmQt9pIUW0fAVW+EmI9ZEq6e51VPcQm3u9Ehzp7PNPdhQbSa3bN+/vbm93xvufUv4RbV6SludQ6untNVTg1ZP0bRvtbSZrU+fo9G4a12IHMKLMaTujDS3RNN9ZH4WJfNh8LlpmB7SmrynoasM7P5eNIHT89q6vLbOU7IRjqdkdAglwwOUnPnpRcnoy0bJSCkZjKPkiQwlaVwD8Wtnifbu0uwYhdTwpf1k9rrcqme1tfS56SygCFXt9Cilpz2ZT+FoOisaxq78/kptO8t1S2dfr4zgIH8I4YOf7oQPv0yER6PPQOU8oxYOijIDgp3smTkdxyqMhnkud47mZSCcoZBjGAu4fAxgqMZUB4NAfjgIVLGom/kH558Dm+ey51kucN4K05RP57WnEAMsz8ljGchN6BzbE93QyuCDGtDUUZXUqWbPUzjN01SLvpFVmCun3O3cVMaUhab+tFko0gxNy+F9eZKjKBdkRfo5qvTMORkWnsOF3SrYqlQSwE9/LsCnRgE/4wFHmxxtTgMWd5xgeX8DIJgA/X6BxDxmmMoomTfbSCPKX0gjImnECTRCF9qjIQcbURaoq4gJJ2ibtBHTQ+zbU3K2PnFwSs/FtLnbGjmbbctyxAnF0T6GrrdjLFVRARNH2mL/nLalfLAt02jLNJ3h5p9BW8Cm8/h23hviCjTpGkUTpjKuYRPcMJtXxprY3zQlgOTK9ziRTm3bGZZ46OV4nEbG/DbUID+OSGtohpPsOW7SQTlnZtHxdGzb++7QzB7sv7P4v3csPXK0OHHs+AnuHzn8cW7rXuXjQoKkzKu9CgPLeDon3T4hx1M5xTlVe/xWse0ZHvgF7f8UEPzcOARXiOdTzLUIRvBMJ1DSCSqBB0v+8o9YkP45bnj5tk8cvOHlD0dR/lHGKJK992gXO8nDrIFBNOoc5gBIUA38OhJZWOk6VD3Bzi/fkaltWWIz/ohxXcjxLYBlYLHOI/xGdRfo5vaJ34od98s6PcLMR5e0ctspwABSWHdLNAoUf5Xs15dUfDIjrimJ0leBIjmsVPj/vGLmz3+WTXXZ89QnZGklJG1eCBIOjwH+j0k+ZsRUeLICAH4gNOEA3CgLbuTBVStqhCA1se96BQ2SSKFnhtjnmFPQTSKTclPA9DrhxmEuJwFgjdyM+iDIAztASkyd+H32iJy60g3dtu0QPhNmrqIc2i2+m+6vxrUERV4Lao5zwKx6goNfD26SQxZPdiMRg5PovFLISfBTxPONYygFl4bw31bFnKaT3IfNGSqi5VMIUpHEZ9Gd32srnK+CrYXONP2yTDPO8d/sGPRgBC9JBTjrt0pnaZJy/R4e8nBH4W+rQty3yX1Es6hFCh+pxbiyqWKsNMDA3CRHSwN7x10sIgKdqKDMM7fDXyQ0R5EYRUzilkgPSfDI7zNikYHebNGRLJ32LrgzNAtwba6HjXpPBAoqqDHFRhWQc4pyPaG0vtTEs+jLZ3lAelsGCDw9R7MofJZOauGTSJx0I4/fADah7/QKBjoiT/CNMk25idwKqeQ1TGGZ2pykvZoj3JSneHlrl+vHN0fQuFk5awZQYL3wrIn0SEg7KyxUBW2OI0tVTqEAYWDpi/BWNrRhICZBuEzViccmY5C7bCy/iui0yclry1jIgIcsKSdRjFBO5zByeS9FTGAW6MgMQD1F8njBBHc+HzqBW1YISUTHNXGWG8Q5ZxUn4o1Qv0huW1eIiVQBx4gjqjgjvp/SP0XnZxPzN4phCIeec+rnkKvfO0au/oEoDMdu/uhGEJ/+wIguBzjN/7fzy1JH7OL57E398oLvUIADhgJxPuhhnrFwqTo69Ej0eXUVPEAOcTKIt0xPJZE1/szBIkZ4+c03AmKt/Rdx/pC9OFkHRP6AA+KX6Soh74DQ/STeCQEQxJmBRYHwMOzbJvJPwjAG+sQ8B4T9O8mit1FEKqVASsq7K/V0J9o2RmUWeFt4g8eSxuDNBqZjr/cU0OcSUDskDrjrwVqMbwb3j4QY6EM/3qcoOZUNlVTgSZrsBTYJ6i/qfWCjeyQSDmwysPkKbfjMiWR4wk1zePOGLCptdqImYv7WGY27W2eCIWCIi4VxXZZJUsg/zh2W13c4RVXLlJNYA2XiGPiWeN4WmDz+hJgEBA3QrD7Sf73Ekz47mCgQZ1uh9AO/B0vl/Aex1G8Lb8Dx5gpkBL6Brz9I2ApZ7XV/9Vtq+vuoriXtspdJVjUFuJFW71DFvKwg9MVlreIV/UYOj0gRIdeLZQcA+51QqgGr9/H8u0KGSzlPTl79q87TqvpHjO8vcwwMrcXvhj3O9ie89+sHQmwydusvpGBmcFyQHGqiKmHQUURBscz0z3OO9/LVynCPxAwGBepgguW89NeEoxOX2b2K3Vt1cnOZ8ragbzXXBwXlfZvI+KsXxoBXy4wE4alYripAa0pcb1LaQSeQM0x8XK9NnuDz9t1aGKbmCqesaKdCSrQvJea2CmKpoDEFQU2IlBvIlW5eUeyOdVJwygjA2hyf0aSpsRkpk3FJk+b3w4oG7wcXzd+fCK4zsa5lTpz7EuSmRDkNLPzxEKskxDUK3Isr83dipasgHCQkkLGi3PuKdfu0hy9MLMribjRYdhiU/gYABQ0KCvjfxDOikGN/Cg/DEZ6Tm8MVxv8kN1xZ/ensMkcI2iUWKj/6737P/0uAk7xKd799duzK4qYel3VbP79HeS+nVygP+pK+L/N7vGCk/XleYCuuUpHBhiuW7UCCJ9Gc14Xd8/s1de1eCs0L+EivFP9lEv19iP4iRHXRIzzVMdY3Bs5JMVJhN9QqEKJIyGf8bVXQo7XdH4RshhhBmWUFD9EUkmMMdPzJm1ng/jNETF+i/x3R34yorrz89RJ9F9FfjaiuaH9NoR/bpo9rmyKKXJvUFZHPnBXx7VGUsnY/Zlz3t5HkVQZw8F7pV6yOUuSvaH3DyoWronv1KX1DzrFkOaAqDnoJf6EFp6oTYc5ACVZgTfR7lOJ3GTdU/MCBGUGRiruUh1eZIr2Lo/StgH/nM6ZIgMrEri48Qo+JuVjKqdKU4ld9dOqtdMDIpB6NMQXfDJP6+8C4BG5GAS3ZUq3S5Oio31zwjwtHCzwbihlfIf8dkzD3Mcq5mVBeRaAKTZaD3QmgK+RmRojCMbscpdD3/vwO/96+/cSqk9H7Git4hldSg9crtqgv3msmoGRtm2Poq31znJxQlgMFOChJPlwH4s0ek44AEzK5woSc7zh6l31/DBri/13iAQAr9/oGE4sSRHx5u29OQ+4ovs70mNpoYd9O9UAsM61iic6wPsdNO86vtllvP8ah2G7YwGdm6AwMUfwkbERlKPGFl4QPYFOPH3aDB/qEFTbuBczfTv+e7eJPZoqjazMrBpq6/y+Fz7jCUXBI51hH19JhVXqAqS9jPY+TnXyM8myBtMSvMAkjrvu+qYpn1xhOschJDAAxADIn+oFRGOxsxdjRz6T3kIAegJ2RSnM0xzOoo0gJzBwRgnkYs+To13PIXAZ8J2me5h7rTMQu0MKu0v+H2Ce9oPyBAPyxY04WyeDlbc60Ywy+3BEHNqrceYxmMn6g8csnXHt1A3XArlytWIAi2TknGYVVwTRFaYqW/ufhDqdJ/n+U13dMUszUNjHNwGA5Q2y6AxucozOYqYmFt0xn6TSmbzmq4KjESo8mXkCngWcE/jzS6/Lunn/tUzd2aXKXTt791F98343dneLf/9rw+DnXpU6wRzRyy1S4o31k4lHirTJfm2S0S5VLGAV1DlSAaqIiKXnDpMTJfeJY7KwjCdeu+6AS9P3hhSypTfiR0j7OYMtDKmMWLTNH3NLTwc1sR0lEYCT+5o9H/BxRzNHfF+HFlJUPyxY9HLEXbIFSKvD4e4yk8Bj9NZAN2tohkGuFqY8QD2o9QsVb23hc7zOTy7fww3axhBWefqwY4+G+RMf0ocRVnJTm8CNTtWcD4shWRaz/R0UiHpU1kNG2DdjBCxx473Gg3mM5yuRYz06+LOran+dJT/6hKXO0hOn3Ub7wjWeVHP5pDs9w+O9lOTPDAA44ieAsp6Yw0+VZIe6pcYNOwrgBPhT4uHBA8rWAh9eW0izCPxK+KZLa25jzNpVptWFyyKQ7VUun+K4jqmLCotMcvUEQMxxoOFVKkDZ+A5O/ThFXKKpSk2KyI6sqA1XunB0sgtoT6URZASrhZ6LvexJNSFc9J7YYQ7NqOtixRLQjM/s59T7gq9e4G8/yMkPnfaiB0Qp96LZMcbuIYN4u0bwgAE9tUPF8FxwtzzOKoyVOFizZ5R6Ge1OneVS/QjWo1hc4YPf0RaqBV4Qdf5lpAP7R/3jvHR0RZofNzLsFbvjxKAz4XYNngSkHG8c8pzYw80SkThE1evwtaNmkRWrQ+Z5Av9yjJVrpC3xbKlM5K2glR0/gS8nXpKg36hQvDi17CeiTgD4NCuD7RbhtIvk+cN8HPTi514VmYZZmcIQA6oKqGZw1Bc5WYZDJa6/Tw0QPMglFezMByQyrnwEPtu414v/jzeDy6lAzeOThSwCftKpOqz2Kvj+jjTTU9wF0tXikDM0qg90S90tbARbstQlnCEpCKOhIKFVEMFtzkjvwNBasC4Ov4jni51Uq4LVW3xIcJgJBCxC0AAFzO8T9Z70x8RIqGuIcw8plIuI/vjeLfLMu0WVkh3nwEjXQxgYquaSOTBNMxMJm0pbW4ZwWC83yntOktx/GPC2KUBxc8V8457QowMeN8JnMk3PM05Lr/79A1vHAffn5Bpx8OOs0BeAmuL0DxmE2GmUeAHaQfxQdYKEM+4CbnsVCHc8/TYDR/AryT6T8E3n+OZyH8kq6EWlFiwOZRCxNDfT5hT5FvW2x25QOZTPI3hZ/ArvUF8RiNsGHCdr7DAYThIJejN88qKI4I3cbbioGK2m0sl1eaiBKBsjcMbS/8KK7CFfvHoacEX4hwLGKN6tZdmlL9W3h71VffWhSR7ZVrcnEGX4hirP1D0VOIkgUtKSeX9Isv7SHkLQBSfsryDFhEYC5kot+zFsRSheIqMaLwH51N/xqCrAkkmaoRrNULX272tlkyGYvJLKVaIG55emuuayllL4DeZy29sugo4TIVha6BUM1hXjZyRpd5t91QUx6QIjZmNYoBnPR+t6PhLzcZDyTpWCyCOEIk/FbIjHK0uXHu2P4DDRWIDHjFiDJIuEXPX0CzPzwjiWkEkmwtLsDdAKFLBWePjFXkDqlL+f51VVtIFQorwNcwOh/kRYpOWz0Fwxco0v8e52u8u8NusK/N6m2dySaMbdUjIbu5M4cWGBNGUnxFWfwlVIq2LrG2KLrdJPWIPtRwK3s396/F1xOoInZP06363SD1ukW3iOX/CreubCJPH+e/YM/fM0RZKgyogNCZcxQIqJI6cCceYWC71dVcHeA5auKxRmgWEiVCLGsGhKIbcTxRP7nWfbnWfZnDsvyYJv7eY79eY79mSRkhQnrzILfCfZi5p3zC7Qy83sYejOLEeZYl6kYwrs8DMNVp4GTWyOA5SNcUgdrA6hDxb4NmCQRnthIUx/YO+o0QZ1ted8j6JxoFy9Lc7YQQjGctm0Wu28jWKI6OG2BA/bZL1MHKxBWOOCnqmr6YjYwEYLbYBr9j0d2SdyH4ot42WLmxUXaAi1zpcl7Kij6QUUMCkzvqs6NxfH5pmkxay1QgWvjgO2rqJ9/+c28HHzYHNoobJvwme8nMFNwHXXOK3lsTUwUMV68YBvysCrGIeZK5kA6yuGEWVeQp0RsJBM5kL7lNF/5Bubl+WxCQYzDq9JNI3Rvr3SDcZnTCBcS6xMVXGTIidr9S3oHRJ7ZQ2qHI0A68/5GKnoC306TCNpIErRtMyaFbqy4bjCuTU1NZ6bA4d8vcKv5fTun1KmTWN8ewQzPwVdDWUWlDZjjapIk9wkVwL6MSkp9w7Hswpm4673Po4huxECtji2G2tDQA1wNHymYX8shpoptwmGMguCKIDjHTaUIFMOB5OinirkSQGiiayl9W0KaNuaTGRaYl9Qal4fCU0dqdQA1KLfHEsCscy3rDHdDEa1EhExQJEYOiQnlcDA25uQq0vMlcUiRfkKJxrPERiEyFym4lkaupQmAIZzTW0AD2mjjmnBGAyzRUJbQk98pRZdjlGnHl3mxTqZXGdFIwve0ij+4W5HiJn6Rzr44jDWrf5H4SXYihp7YYXGeGU8ZacbxmQmECU2snbwg9O9I75YxxE+bLoMDCs44EtPKoEtLQiKyRp6VLmZefAaGtJDLRcnQ0a+QC0ZXnqFmisyWFgz7YkNHXyIZgVpy8EbM4bsB+ErJ3wL5HbGvM+auA3eoKx0SWziuYCImSiIETpCdIiFtPIauEY8UJvLHXWtPdotBG5T26BqtqSio0aAa2HIGBf2IigLsiQUfICjQKspZFfJv6UxdqVFQaqRKjfao5EWNq0LZj6K/CeOvclEfHfIB6PpM2nEmZaX9tINATUdoVztIu3SEdilBF8kUmS0tzchRpzeQ6A0NoV1AKrUjNRlBDCmlmGprFHCbBkKWnz4oTxSMEAcvr1GcQXu0D+de/CJQk7wOH24FsNqTkECa0EFChyZelCf1qWANXPjQNMWfMwv75VnOTC14Q4LBqBs4z4KRpLxd3djnegjcUCUMCXqpCUEEVJ0KohyIAbbhXdZgqAN54UZAvRxhl0xE89x6mxEKgEV8Lwar0CQZnhnQA3+cJejhOJUFqH142cYfZ+DkOg7/NQl1qEGg4rbon7QA3a3aEyHtSXBwZ8Z3K8YV1Rl9d4GqsjC7o0wiNhd1pHGTR9wgoSySE0KoLgJLjoj6BrI0vBVyVVdaiv2R/baOGNTsfbnp0fwi6NE8lB6tZ9Kj8wx6tEbp0QE95vfR47P7/h1Kjw7NCz1aB+nx6EukxyxNc25VYGPnbbRtrA0WMRF3q5zdLWczMvR9XM3G9cE8hBp7J836uGkE5dAMNL3uWr66d5LWeLL1J8JutPcdobQ471r8rAkAUBGp5l8XVLRZZ+1isBb6dt95xP52fuSWUR0yKaJGH0XmKFKsy+mTQxWF0hHbOZQaIIPlw6p4VW33DXuHun0poq1TDCh1RkpADO5Y5rX7dEdWiGy9Ze86fn03RMrvC/XNp9l1ifCjQ9l6u8hgHnnZgG+Ob5k6+GtbFKC7FHORb6mGvkqFLSqwgNYe8jDrYXD2WBABTlrOqSv4ewT2lbcyT1FGVo20YqhI0E6J1g9lGmo/NPeETcwGpdhDO0cp7qY4z0H8XnMRNDTXZTpkLjAwmzk/t9ikCwD7Ht61eV7+8FiEKDNMASH0xzw6uElGJ+oF8A+1+ffaeC4aTt5joWTCXMRDOHMRXWcGOchPOoYczk/DmeSUmR9M73PSYz27JNDc+sC+zi6y3CMzR5YErgSM0Ux8EVO/jDa7M8x68+hd85g3ubVSy4onCmgZOj4IxgUlm/yyYFac6hvikwn8pH0LaLCDgZYFrAVo4Pgc4JhFBlJ98DiLhR30Wl1qq1wdYiVaFC0LdKrzpx2Rh3XHozo/xNs8dXqqOzRUnampOtNSdabpPF0NiMmR2Q6xHIa7bKh9uI7C4o25nkmKyDuhueb1Nw8yf2MTp8Rd0/mDXVP9AOSD3jbMsE7ZV8yoSgHqWTQccsyfmuBkW/1+Vi+oyhM6jdStwnOBIkDt4E0AaN4tARBZ5B5LUo9RuttI7+nkj1L4J7waGOmWEvVI5r9ESr7zc5WS7/zkUrK0n5K4jhmlhwMCBo5cKF4oVheqCBn6jnRVUMKTqzn2jr41sw7xgK9sC990lKRVnfk2xnyybtaEwq0xFG44CheUwu2RiWBELeaymujm6xgNPH0x0ARD4tbVmCfEpUSIds3NnZhGlAqxySet6UgxtIsiSDJLf2vU4cbwRAd0Yu5Sqi24apjuSgA3ia4D6fWMRr9MKz277GSlJGEkYbnoVtbYNuNBB7M2G0UvD1DS9s0DKmh1ZA2MaD602TcN1W0KgkNBeSzIlaX3dYY9Vpx6e5LwV4HbZ0zgqBtnV/XoAj3iUDyPqapksv9p36BqoqF+4T2v1BbkCPzAMcYKu8gTFGl89+3N4epXvRRcllpR6vmwDggMLcmYVTH1IvGX6XCJDh6x1c2t32mqI5mBUmbLSYaS5ILJtE9SMfaCsb5Eaa8PZzOdx6S3njWcmTUBJwI4a1x9Mpycc9OUsgpKW4VhD3o1T8kwiGK4yz0v9IyoPdCbaxxXZVltdLqoXTXlh17PARcfvmLLs+RBVRmTUXzvy/bLt8KhyiNkqaGAmmNdtJch1sm9YC/EfJP7OZDn7KpNdoibeVriSMzZ8XWdOGgLVk0HATwYQLRZcLYlrngwawZOkiFq7RrEoaC3APQCwbUhgvGyqE50WWTiDF7BcA1PTqwn3xtxzj+fd09/v8BPfz/vBaVYtobWKUjdqZ7IR3enyN5rXNkvYabBT4SfnMpvqZc//3Tkpv1U9gs/FqhDnT4VwDzNIfNcBJsDhq+NhET68Gk8lJRFCpCYqLYKBilQQxkE8X1Us4nQDcPIKAUbI9vZmkhsevNcQUdloV9ATZG54nRa0rkhhkAotE0lWKwES5RgNV1ioGTD6BaBuvsJlYBQEa2Bu0cJ5Wyffz64PyTNvwZp/vOANHj61/7pz0dCqFEijo5xSnGKQKsmfkhJdzjVvBACLJGHpaY7d5J9fX3Ok+udRLZa6MN/LvAD4QHw46EkD8pZvq/XInQHhqQDQtYwq46UkDUQMhFCRjoKKPnQAh8jH/PE9VKzALZj2itx69wAkeYSYiIrlsUCiF2gmg4YTmFQMcot1NQN6nIZdFunYywWZR5m1YxgOnghe6A2e+TS5pGmkrnv0+47Wb3IzIVWR07UNryoZQJwD2VRK0wrTNZUhV9z6RSA7lPTL5gRgbIAWYA57IoUZRYRlMwFXbqE5tUoAGIXTAqxf4FWWO2ghR4t9mkR1ANaqlgRqF8mUg5YZ5we4nlwTdlPI39fIio5EtIRgZoCVt9pGin6jnjaCqhSRwNKvYBWPqVoqOatqX0jo+qhPxxkyJSfTOpuBNMlSa7zxQPlEgU6KdJmzO3rXi2U0KIal1KTIcfUKHIYF3PgcAxNQZkC43AR2KtyG1d8AxOHP/y4UbGwDwfRQYSqVVqt0d7LELmIV5z2gevHSVVyfZP8Or2M+lNFhiot4M0CaaKushoHbKDfRuz6pcgBnf+cQHtYxwAqy7bmqSPS30YV5VsFXoYAscQsox8uUxOIbxJ6ho6b0hXCw7rCz3eFd6LP1RVKP2u7Alr/M6QrANAvrStE2hUC7Qpg9TpY/UBXqCteXVfxLCxIx1LUVk8bmPQp0dbUqMU1N0WPaqHONgU86HreT5X3ky+S9+FRT0D3+ijvUw04UrSNm/5zR+DH/eyeZVL3ZXSQpdUWMJrbe93a3JI2WslzC0r3sXSiLJ0AwynKVigVg6lvgsNg4Id0B+RB9PglACm4LvVgqTYywpYgtWm6xfGjbAlBAI6JwDFJRcm7n1GVTcV7rmQGoypgh0I1WHatPhq3AASYqSvP6dQZIG2KedZeAJqi29CDNunuW1b9i6oNbfjNl8FwvcjfD23kdo7cFlXJrXXANhHhYmVZro6C4WHkKEX35EE0j2xT4lUeVeK/rQp8ES2KxI1YoAguYPX6Q5yqOaotzZdv2fB0xE0v4cPRDeKq1cLEIb7gVecLlqyUyLfel3io5eKjI5YL+GbbrjcPnLwIVikVjpO22SDreVTsaUpHDDT8HFkJP475sZyjEJS+S3bP3nn+WMg0M3TU5burW+0j8RngTBGrjl6667YI6f6xi0/t1SdI4MVLl9165tcriGKts7Xvhua+ku+eAmQ2QACd58EkT2ekIN7a7WsCu9H9wb4v23lLNnTCrKD2AzrtJl2wFFEHnNIUblgBXTnlslJnN8QhmZcoTx0pu/TdaKq5ohxk5vUru6KA2dWB3l0HM9kCi8qId3uqWa86ZBgbCcsk6pqrPl/hMKFOz+8nTikW51v7ZWcOUkcNZjVsFiIsZ1dzD0yWNXXEqKtKneu8ygIzb6rib6vS456rhohg7+RBv4M6CpjdxH0FJiJZO9eB9wMuL6ygE8eFzvATlWownAhTJ3RDZojX9/5MKMGfCve+L2Q7WyXnln1wNBpGw2FUqDBubqeTTIrhgsHiO85K6/zzJj/yQ4iH8M29mRBPEZ4iforwlMNTjp9yGV8JPC9wmUy8ww3O/jk/il//oOsoDnenDE8Haal7DtTdNi3qwK+VKIbUL5eiPJX/HAWiUlqFPKGaM04WBuuQYiLxw8AyDf7bqnhTmy6TeaSdWZCuEluXxdW9g6Y9dITCfAPbFD/A04WHbpxd5ASQBJ42935+m7WzcKo61yBq/LiWsSaXMV45SajOnsRZ8FbH2YTNGjrUMkYtr0QW91W3poZsStW8LVltvF+j2g8DCo1VnvmVEwKTnyOXRclEUCBuPlBUxxAh7lS/G98hIVYLJFqjOrcSMZZRQBAB1teBHCA669Dy0Gp6eNMD3+gAzmCKhs06fAUIQPOLrmJ1acdujwjeYaWlW1G0pAJItlguKifOS+83F7T36gwfgNKcDnNqBlh0qs55VdN08qFYwVtdW9hAA1gTZd25B76CWalRFIH2ZZRlIi+xxccUVIzyC1MfI9taAmWbLvQyks02Pw/B1oRgaw0FW/0ZIq31M0ikcU1fbqnGih6k2qg4ax0uzupZcYbf/RJt/vOXaC3wemufRGshJ8/btHRhhBomA1621Q6RbTXTJn77Jcg24snHfWpsPDT1jJhrH97XV78CYg5iXBwRDYqzjojVz1v61VT6tUT6oU0D6VcQNKXSrILuVhhKv3RE+qXUVFS0DwhCFk1MydWBMEw/tzAcFYVouiIWs+pMG/k5KySViT2S9MghlZWFoWXU1ARWPDuRptJUx6qAznNBy1zKkq6vEAcXlFhKnW53mWJd9Z7+yPVZ3fFwiYiu0OXdJ16BJX/sxK4lIsn5egW3JBzwG4K9PUNnxbpO8lU66xSPFpG0KALeewZXuCPJNOgiz2bIYLu/uic2uS1GJ+T36GLfdEWKgji8hCwyD6Lb+ISLpa7YI+cgRv95aM7zC1VVlzcGqJGb57kUfPJ+uwRF9SIXm24zQH1a2rYXID43eS0PnaeLYAvu9PwCMdPjmVlmCc7VJ/aSHtiB0t6q2CuypvIinF8N/kQPZTOLZOn+08fGcokGpmi0gssTi1GHLkFKY66G9nw6Mit0XowFD6hJ7b4ypi1gTySRpRXip1UQih4Pd44ICoBt2QiyRi3D45jKAGUrz0jDBVeL/LREi5B/HGL/C/SxzDK0q+vjz0WgVKdt5xm+OZWFRn3eiVpVhNkSLu+qISpQYBNthG7rtLRKEqfL3AB7ldthLrsW5DeVcfXB7/VZx4rVQ5YQQRw2XEPX6Rpdpxvc4P/nJopD3eMLWInWAAtSQ1YOxSMrh+AXvkKXKHiK3SaZHnDRcb0/ybhGnCaoQQMAvgB/k8/84T/ivTS/+tYQNlRT14FLlx/5Dl2lLsRXVQ7CuKAIUfpucqULJngWfW9zlgu0OWZ94dWDi8S6rqNSB7aHeQTz1ELQ8tPjZYGKefMBzZk2wOuiVz2gNm0wd6iGtcXUY6ME3cXBTuY91DXPc5XPd0P8PV+RiZnpuPOf3oNKHtAGuGMBw95R8D8k7Zz23N3QLvJjN9fjcw7FRIFtDjgDebC5oL5/jQ3N8Uw/caYN/npJpCFibTGPInYP6E7cjmt4xtDN/FCmxQ3HUB3JIKz9WKqEOziiEjDE2bBtwS8LUFpSQ0sFiEcDLJWgnqwOrG0a3aGNucmGUwHy1KmYTabCBiMRbqotWoA8muu+yTosB1wpFugt0dxg8dltlVCpdLIrIpR+9TF3jw0e//wjc1mDFzA2Aa3WQNm4SIbxawPGsKky8qQEvH/FrsgJQZdUGaVA5csKavde7xZd4KZeMoQOj+8CfOL3br9u44ohglzhSMtjS0c27ObGPu7qiMN3kXcFGhpSNAJFL6pKFmBov7tl7nWB+I+AbSO2j1ZMRym9YucdpZu6LosFN9zBC0hap44uo5dFwaYhrCFqPhjJMRHAqpl4sJyqAKXvoQ2oAMOK55IjGWNpQoHA4VgkfrahdNjR+RmVqV3c7dqvgco1vxlhXnvkFaJd8yKj4C7dq/CXK9IOcO/tEXc2ChyabiM8Ckxi9kOM4SFODgfJkU/Gm0SLUOB/JAu5rL0QidyhGB5gv6emg8XpHgmiWzhgMDFz2u/rFe0dGWNrLJqZjp8vPtn3iUUx9qUdjHIgeUPY+eUnkn3HvDDKz6QSgS5uStDRIOZA12MCVYzeLZvgBcfRAMCT6pEXHwQpIDBFL0IT8ubqRKi6rMdmUsEH3Q9yxG/seAn13+Ztqwc+dvWmkNqkB3Rh5+JVje7wF/t2N6E2n/Hq4ANk1AyR58siRXRZ+thjgKCpsS+mKG+s9aBRjMdXfNGPd3zhKFrifHgo4T1ieG8fc/R294l5VbPya3LhK4+l2P/8F3Z3MvmukCUi2sHrq3R15/GOO7rMamhe8SdL5EyE+3jBymQhFzQDhlB71V+vFRLRq0SS6RVk2pWWPNlBNla0OOcf+6PTP0wasKVUIrdIg9crjy3JllCSABlIeUwDZkQaKjHjQDFXi/u466pr0KvDK8Be1CR6QcvWgOt65Ym1xLLs6RN66bH9BbuiFpa6OH2dk1+kl109n5ED/3Yl/Twk/XttDUReoRqreBDvCczggq5YN0AnaraOENSFzCw0IwRXKdEvIgSR7liLmRiXHlMd3XEV3PKr1dumHo0I4vb5iu4fWCapuyWfgXO1WvST6stccyFbF8Yzv2PKJrD0I7JqIqlFGVOq/tVOBapz5qofgS5hvGBe90+Bnhvixq6IZGSJIBvUfiZj0IqGjy0Xi6KZhpeKfvTIDhsoqkhMAEa+so0gmFhP24FqSa/w/0WcxxVgsIPTRqbmhMfIP9KrStRXJDnvk1lIfWbXEhjyV9/5+mP0C+T1RN8Xwnz2d/72377JJKdL8iPZXq84mcUzhF1yrHgJ+i4xszFHoECeYmmd4C3XWzS4BKz4NKAr4j+fRY5j4a7OiAoUURo+fqwDf0ASsPDdLf2uT+IA2ys4MoYp+ZRlyx+U/uF7HmmA/sQovrKLbepeYOtwnbl9hdv22079zquAXSLcSMu9Fv2WafNqkV79jLlSpPu0BPwwsvnWz5QYnPUoz8FlCK5llL1M5xGcpwsILtASSLlEmyAmPQ9fzvO0gWFwwymmo74YTToHhjznz4aflES4SRJ/qOlfj3J6SKe/Fi+1eZlexMyJCNTpD2Z0xzarqpgi3qS8OMl7fYhXqKMoId/fyK7jxGeaPaWCfMDZS9+DmbU9QvCmvM754c2U0+QzF/28hp5NKU7w6n6W3YlH0dUBosnjDHs+XgiLQyn/hoyKIs2PuA8jYRlzhHvZviIDVwLe4GtpshZhYt03eAQqyJF1mWjHfnWVb5uiUNcqUH5gkX2reEF3Nk2N8WDe2fuFcL+w3rek+7DeKv6PXL4gpzfmP6J4z9ucoi0vKvfouZ2xuo7kTEqBEe2IZe1oDlIohDqdIoX5PpMp52cwzpyWy6wtoxy+PxZqhzmCR40exUZzlWSIoWzmNsEuvwsHKcQVVjiZv00RHBWXtKoPifAP7hB/THnFX9Jj2+5RzbJtizJRU8C5KYeZanHAfRG2Bs7GNNmbxE36/HucUjbVnnAntwd0jI7TCZqAjfP/jZnQToyf0E5krJxM0/tDwAEjEEo4/h4lhEKDHigD5qCjMr8dnnoxtFs+0gJREncglJMHmYRTir/IXQwgp2SChSHRQ15ki2oo4sgbBlYx77Qcnps8en8KjO/el1n8tjAfah/+mHY3lDXIbgN8YAGAdgqsdkBlGEeEWZCScTLHMFCMuW8jFE+/aE3o7ZLAxbzs0wpFj4Q85nc7Oyh35JyJfPE2tx9QBYN1hEH2vMVQji08IVF38Jp/Ul25+LfKJ8uPwrePo+985Ai3OsKfnIRa4Bj6kx7RLBeD4AcSB4+Eh/gNKzJI7Fj8gKWseDkDkFLEyogdEbAQO4rYBD4tujtrSniYwCnuEzCO8YmgxymH/nuCjm/bEpj1ZM+cwsTsbTqBHYSTbo+eLW9TGXMK+xw9x+fuVr4LH7btaRCz/F1v2zPfYqe2cX3PHfp934Izc89SLnvQKtf+46Gt0KTbkmhn6HTfnpMdf5DvEebOMNYd0yRDNIvrxfq4+MtQhTiwdA73gVU06xzxh/PC26NWu4mnT2zNKXITYrZb5G63xPEIm+FOI1imGZ1BTsCWt0KnEVxAli1zEV89bxp0zBv4mkDelC64f1u0NSwAMGsigZHcAhraT3lsrXFVl2mGe3iHCy1tmXVqmStwzOk5ZrLa1q0Y2NV1Ahia3YCOKF3i0frau6G97jwH6CjmhuO5K3QdPa8om9aoSNfVLnOTJe8tqpjbOVkPgOFoTau7SbeA0Umw4P6a1kQvWKWrXJvbK2u7bMi8w6WVuZx1keplYB+QTDMTPU8BTXG4pWxAZx9i5KMuU1MneLQMs0hAFt9McmSS9dE8JvaI448rmeRPTlMXzJXykLr1lggTzjJJsTzcYTTeG2MQ3KALZlLE5gZ12HtkN52LSg3w9j7dc+cC3cc0V6Spvb9X1RP7aNP7tjgpHCRFPikaJOV8Um59aLJ37qeN8RJ5gyYhkSchQC+YMrfvgtjmjtAydftUVr6GvB20Pc89GUkRJ5S3zSRhSU2570V1oCS7o5Pvq4/3bVTJC0z0HGCaBAOiarYL4sVtugXuuUVFGS+vs94GMwvd2GRzBw5vAovb6KG5STc4ORLzDbOU8hWnFZWv7gr9Z8fw1V0qf1F8dUv5SvmVzlG5h4q+MO4y4K2bNIsAHB4oi01uIY4/ru/mWBZDlp8tLHZrP4vd+hwsdsuz2K0vC4vxWHvTX8+kbHbDtKCBgKPAX2CqBucB9znugQWfGeGBbMg/oTxWppzsNb6LkDcZ3wBvMHQVukUzzj/iJ7B0E4XECvUDmoUxrOtBN9dwi/HGwMUwoRbNa0zoTTlxuuksvptjLer8GtpYU1B6TD0mcyMek2uHeUyK0EFQ7aTzkGCmPcnfX8PMmgI7OfSQ3GG4uyRxuoMZ4zUG3txx7Zs4HkdhGGJjAlFEE4IiOAXozrOdDIx43+yhI+G+cPnGT5B3FdBxI0l7uqWBeDQe2XE23ti5lLS8e8x8p8XQz8xMtnMv3re8vvCfd8yM2RwzMzMzMzMzLdX3lXqkyUziYwyMpMbq4q6eUY3h8nNF44ty3RIh5ymvn6rxknOPcbJy7niePLeGwOvCX5XrEoF3HDpZAYudIiePnqwkQ16WnslBd61lkTFVVynXhIsMd2eSJyVpEVd0nbKTkmPRdTrzHCSVKR76qOdwVKIyiNLX4TkvuLmvKhE8fZayY8wdIzsz7YH0B0GOO4TtPCOMM7Z6hlb4ZLpS8QDeFV1i9cvD6lx1mK+CCkfOtWrf1jZv/KuuStSSVqkMHbPMMMk+cw8++56h9KW10ucMSp9ZlYakNUxnVJU+N2QvhGyW6cSQu+URjlnS00dzLz7IoahCUOYw8lUOIx9yGDmmZqoGf+3BMOVtR+Ao0iotza11scEzdvjg4E4Hfj4GtgqrxT0SBKaPJGDH6Pry1bpez7nhrg3rqitkxiq0bgxa399Zc6eNcEE8KsyFXC41bFn1n9aq/3K0+uxa9ebR6lvWqm9brxZkmQpA3aSEybbp/lx+y9UkY5AKyIsL2b4csn2dUW10rKgRqOnTF6IHkg2V4z8odvEYNmzwoNu4Qe8qbriPBze8iNxgqL2yzlR7/BELtW1D1eCrbrTBR+sNPjmmwTvrDd471CBEKVGHDGyvdQvceKF5BEmS2PIVV+j1xQXA3v8CZ2Tdp7ojGNpmPVSf9bFjwLpHvcF96g1s3D21cV9cSeEFtV6XjHT6YE26XlJ12l7r9KejoNyxVn32yJg3rYbcty8I7Kn1whGBvdmwLNTlDsIzzK7J6rL60p9fzF+2Wtd/YNe6jJDGJWN49IkwGCyWRMwUNsQOOy1x5n/yNGdYln6lY996ZGyc4VpCS3T6V2XT9BVjRXyrczWp9SQbWzGZVYdHaNTDVtghrX2lnP2A1j+jkvwnhVkayAbWMOXAjHqE37gk4jKYaTZ3GvypJ1D0xlGsFR60d9kUchLrbfeukYtH1wXzXOEpIqjIp3zTHTkOK0NVR6ws3laWNfVxqdi+kCOn70136pPemmJo6PRdzh7Z7IkHI7/ukc865U96TMSFbK1ah3rdnLxWK7Ts02//oO5+4RACv68BaSxnefTTThjbhABWF8MV2XqIru07dAD6yoanZg1PnEYBjk/znVuUvTIn2ogKDsyX6MVxbHIJL6hLXwtIN1j8tMmwE+owFxFfcUO/m74ObRvd/6IRGf/jfyOHRYwxKFghWRCXftcwopN261MkfPB4yAmfcbE0ypicBcJdSeHFHMhT+QaaAmcSHaxPKsnXAfqN4vV7NUVWepd9BPvBnabbtV7zEkW7/eWYh2Hxrp8t7zt6z/lPA87BxdSZp+JSRHiFGMC/rjE+D9gVvTcEnzzBvuVStBeKHzKqhAynjeKWC4jULqWfukuZC7J4bQOxOq30oZTvtdSad2pNOWxZs8aE6D9NpP5Rnz5qbTpIsW2NZzTep5NAlt5lfh+Dg6VNZuYhj4PK7iJysTG2R5wpvHmsEOcJPNKexviiJ+STi1lfohDjS6UN5E4RXmRpYgYt7Tdt25ZY8YFUvhN6zWYYqsvWofEN8zbuj9Mi8I1fztZLwmhbtJzNmkI4Xrz07HdzGyxxQ++qKSYg+mRjSzavg7a3CQLRyzigaAGQjXI88jYxoqA+zhZ93IicaEsywbIty9IuJyw2XnT++XhHgqYdzqbl+KxFjTxhu8emJdeSVhbLxqwpM+VP4uOQNCKkV7X9eu01FjP6NCEz3AJNIILelo1cOFq3pCfNcu+tfe3rBiFfelN6GKp68wi2chU483anS+rYKyiUwn1F8TYdaVKvW4x2kiJkMoUka6Jt2nrTZnRkC+7wXxXQWgZA1vcaYzaGm2RaZ5kNC5Y52YQgiISARSx666tbF26P/l3x+hs5N43fRW6qoXBWmyUySxQmhsKWdIm4WKaHDjPigELpGjXiYRTKNGIX0+HXqhuRvWxjOBXzgze6AKExj/CUi8xkxVSblCtqmnv8TKYlGWNakmHTojv7C0zTJzv1aTXT8v4nv+/JbqxteR9qtFAv72tU1uUtw9Zl9TlXtS4X7CiSX4V1eet465KMsy5vM+tyD+eiQA2pOzCkAyYLh63e8pN6YfZpDydGh01JtkhiTAd0YSnp281XUhuBr++5xNnk6TsG5TzgMvB9lT//Bx03OZodGdYNjYsZauQUH8kSPi33MD6o6qCgcUVKuSZSyqWfIO2o2v/VWPBvhU8r9nSBPf2vmZkUNmbJ7m8aUiFjXJ6XIvNoA1lGeeqdd8oMNNLWWSm6TTMLNuRdHGdg6mIkFiWkVV5knqJzHtWnC6V92kDgmb94uDVgeQSZoL7WtjR51DqHIQD6QzDXIZ1Llx+GtG0VxxtkcUZ2OlBhBR93cbWmrx2uAD/bTyjnqjbvLNtUJR91ZGa2tTNEr3f4uIR5eMvRsrgLTVP1+6IBdtMjVrtURBVIwOGVwKUlFxzvCB3ABvlKpI42KBLbI++xNM/IKp51bUuXYad1Xeg2Z6fhTPLdE6f+QzY5YK/rLgW6LzFjPViwfPNBhJpTJaY7xYdUuQDiGIU+4GqqsH8E11wXd/+apVqUWCrkXpkdGfKEfMcY60TccX8wjzsK1wzvrjsQs7akELOutNlAmuwhPQ6RftJyEyvwxXz5hbmIDs6gnLmTpY0kuJHlvi7hA3kI4IRBNmlQdAzA5tEgAfcxHSQ+JvUj/TQ10BggPjMKBFMC92nNLSDnBj9xWGMcg8/7uCVy25Ilc7a93gMcFW6RWKpmMpH6N6UvF1t4JA9Zoy3y0DTHtVnGTIazNd/7l6kGOS8UryXD5vQgUV0TvnMVTfhzef3vHvH6k7rXn/zUXn/y83r95zu3S7y69Mirr6KL5kLvnthQcUNtYuVep0WZt4aeLazbrLWfsfazKGD7GSLdWni26L7duc5o4Cx8j8nDPnizvEXzwjwGq9FXfiW+yJC+x8ygbYtb4Ruv7RI67J2VcBfajxWhauGX30GJ+Um9wgFEIvb3Eu1NTBdJy4wfZVOAQiaof5+RG5Pg8f0UE0zKTU895NN9vnftn3I9vr6ePeQ9W8cQ+O7CylLYtkJBuzLAbxGKDwOgrEnnP9NFGOtySS2JeA/Xj+tpAoQKDmWY1mIW2fsEye7SMl/GlxKDHgkxwRGhc6wvEF6ODiFJMAna8RLzgrr0IzV0tYmuuifzUSPh+5xr7oYQWvwtSh9z10G8IzaRoaMqcRap1LDEKzPDW44sEV6Mx9TuImwxiVuiiplUsVkAY4te2va1I/QJWxmzJS7saKqvFTWRQ9XTL8vamL9LO9I2n9tUQxR+r+dDfCmC09bNQfrSawXD3s0EjbJN7TcqhD+X7vjAiO5oXlDpDjwM6Q7MEu02j48aIqhK2nJGnRSt6Qcxaqk60bXu1HpbY8MUNBUCJuAlxgWw3HCgoeL0QxhsNY1k+DIBr+ML6ynx9UchlM9In8tipQYZ10SXgpvpo17y2OjBFq6MATpUuJJQQ8HDTggeJqsFD7HUn49QHxshlK8Tyo8Qqo7Cj6Pzz6rUK5TuiYdR6gNK66cjndVPR7j61/sm8lbjf31D2DLBNrHK2nSwso45gidaX8FaYYXJQDPjUJivUSQieoTrbfWqlibVS9sONqXuXMfwdhpI+F85p00N2jBUdFNzIU81D/JEdSALT18wsq9o8qcvMbnebG1XWgjvfp7R1glJ0i/wjgQ4ER86FxzICOcjapF79P2K2FhuN3ffVDwY034C2qAT3RNfOkHSqp8Q3An09ZQos5qzZkNTiUybx7jQVaNbYhGepolcbCLXNpGLgnKFY8OgRbS0lFtgwtnupvs955Kj2afZYfs0vyPYpzc/9n5vojh+trK3MwjSgbhty/bdMT2xxlT2hNnirnQrY4YBI+zZYSkS2rM3YWBFn15OpDnrpp+rm+MJWcPXObXoHptZnh+Y5c8Pm+UvHMMsb22UKtkEqwyt3ykHK+O+6C8U8UV4THhujv3FBaooFIP456sdTfezzq05GgbTVTH41QqDiWGwYxiMs84YVK3BN1XHo4qW/2ul5W/SNpsr38ZHa+DP1xD29WGEfWM8wn55VumLI8puvu7Rzo94tIvHskqR+MXiP3ewW5R+6Zdpm778M9gmknJYkc4HW34PF0EhRiMGKqY6BPvO6F7Jzn0iaQJ73GGF98S2JEaLzmmeTdoSoxLERG3HOpp/R1Gg1pkfGLqu2FnfVyjr/+miulr/+Q/d8rg6dpMY5tEP7MCZdXPMgcFFYWyEfUbHBsoqG/zL4bVv/gp57Vu/TF779u8Zr33nd4rXMiKWJ5TDeL1pwOt1NUa2l3FL9ZnAlU9C8YbiXWMKu6fospUVnXmYC7ThTlkm0wn1e/BYQ6ReQff2hLw8a0JjrRSnH7rF6w0yoTtcXO2rT3BUdITuW7LWxG6/Eu92K73d0UppfZ6pm7dmCLJy+3tnvs3wVcXsDiXy7NLiq4r+RdJeeBVILvp/61zeKf5X7ZnF2mJ1DTRGc5UuKJ8goHmXPt9m/jyou5glJcii1ahxy1mPBy8S6cdi8UT0td/m7VrOJglGEwd0IPzZQXCzfnWb4jhHWgv5VLF7e4/ZdUDBF2SpsoGkt4pAIK3bjDpW9Lu0ddLXOmlzix++JjrJl3fnLdAW33h0HDpLugaE1kbgQWI+KRp/3GvUAIH6SIiBQ1hFDQINYRX/i/OSiUJXDrTpqiMsfq0WRLrUxWxKIh3c5lkA+2LxCRddrZQTdy0Du30xsY3v7onFIlNpnRE1uDi9Hj4kLbsTz8csNbnw4c1+U7r6XeGnP2t1tSDqIuQjtXPXC9jblp5IdwFKjIUcDUi5T6Q1KOM6ZRLYnNS2PbxoIQH7JaR398w99ueHdyhmZc2i/rbhzJsevPMrBqsL9R2ZKR52CVp4mRG/eS4H9z7tLme6lTPdXRSom537tDN3///+VyhKP3fx5jm9PPSSrXPlON/cLdMYuJptBQ0f3NmKhrOb57J1iHlE+HAyXThNGXCcUWJ9cQOdNZstbojL8RVdLDfOBpng+dicpVc6ZHzaMeTgF9Hz0gRyNxpScHsdmQC/K2EqPOUe2MvS6gyyXTITFJQkJCueIBcJZUCuI4NXzTdJ55akkpYr3nn7w1f6F+T98FgcvuJKmAjGZwIrSP9QPtIlHeni0TQd4pMO+GRS2sx/VZcK45OmvcvoGPC86vAhDm44IFMBXQSKPJTKdPoj2tpqkFfe4fAjylt55WHCfqXPN73gCiDO/oKcW3Ox87IEQHB7ScuAixx/Ya4fF+gO0mzT7IVZJh5ZRjYx3iPT9a5M/LJem5hUZQNQPnmH/8Z7zDeBlTcVXmuSngvcdgdJFSSU4jAxK9zmniubUjb1/2QgLywY6ZobXdeWBPVoFJlJs4yV5e8ewaPtrG3AtlAA8WBB4XgRj63Moq4PY3VpC/NeNQ5Hqg+EYVw5jFJy0NsR1FapUfSxRRUJFlgrk6D9JGmf8yu7TRRdYJY982MhFl9NZMlZPSeySTiB9hlPPTluWZsCnTCxdVSDD2TdFdKaM6RjjHSgQf6dZ8CJTMAK6IWv3l+2lUlihMAOXEN89jaDFcjYRps+89ZsQAoi066d8prw2jpf/2hTExFFxQo0Xg/w94CjNnG0QSs4bBiuZX1WjkiC0hpGAdsnWp0lMk2Twd5VV7RPYu04pw8G7ST4bXJMu67g1CZZoM3qactSkcPyrkWhdKiic84O00hjWbcxw9at9kTm7f1yLM/6VSzP2lXNTk9ng77U3HEYcDJLFFpyh8yYcqlpu/8mym3lDJAN6y7qi0ASLOwFI6rMK3XWZNM6R9WONRZGnqa/w5tr2n9UsfBuRaLvjhoo4lYRMK0IKAfYe4myqF7fdrH+lLdOBF8zpOLNhrJ/ZT99se8SHStHNL11dPupiKRiMlh565aBmoQyOoxkW6cxyWFgnDzaqmOuHA8jtMCRbTpLNgwNJIjvtQB8Tqbx9e55X1phdHPPUpqwqiww0CWYuF+f2JiJAlUHW013AoEKgi8+X7uYw/VsAC3j3DfPo0eqDfQCJ/7JOEmAzi6YnUU9hN6wXECEwe9fvN/euzTIxlMCn9IEwxffDOVBSFj6w1ppOijdc/+qdHahkiUBKnpQPkE1t02IJilEEKDxcNTG6IzkY/omfiNcSdUUUD3F3yfBEKjbinYDyxJPxq7R8K57VG/YKhSbRXTeUF3gMcggkc3JA9n8cEt6PCW7UZ8Y+JcMg4++W4Z5zwZdgBoNuCAOgdg03HTsphr3X4fSJyHcmD5M+2ZzQEnzjOibzoy+y7wJjcoPFwmjS7kwQJLwI9cpg6OQKk0w5vnfAMHOcHPJkaCgB1VlbKrS7Lc+O60IBAOtwwKrriQusJa3jlxFJ/F/QCQbMlsnVBSroDfRzPoDJai1fR3XfPHQEFAD1dwQa/t8HZ1qMIVqI1mnTHFIH4ggC1Z4LN/XFrXTFuUJeX4iV5JzrJPU6851uHWm6FIov5OkzxGlrcOfKOv4ELTgugzacRd0lYdU1hxMzFpfXLtEO7cd1fTrOGVN2a4L8xmdiAJjoMJvsyls7PFkP4HvDjaa6NXGqPfvmvBw65MxSEXkOTnhVlEqDrU/dOBOZwQsKx9Wq9X7DgjyzDgcd2wq2svdd3of7fLl20oEfqA0Xpb7MwdphBv7B0bzmsbfgzh85p/d+7Oo6GqJO5jHlz5hUeIzb3aXPH6CxH86Z99iooXkzdV9aS5urxl0aTy+D6vXFJgNKkjx4p52UKIDr7CasrBw2vVpBwNM7f3SgvE+YA3F4UH8it4XuuzFrIV5tcvWnuPU2/VehVUibTEw9Wc2OP6c+GrcAxAnIEwTSTvRYTbPgQiu8gAuu5a7qwBs41iih5LsC5bhw+rKzFxHBqXMzK1sn23VFEsKtU6NZa5Ddul0wTJzbTlJmZmZmbl19N/sSqeTv8pcny3d0uzszOzOzM5mA3Chlsv2FmYAhhCkHUIgAX4Jg8J4ZVmKxYGmWqvsHsDLP5yJh6jMjywjKJEWUXG97JvH+tszxzEpN9RS9u2S1cm1lcJdd93duPGRr4WcDP22rrCzb0ts0/cdAmmcgz7klu73bfDrFFw/P5KbVFWuErn2oRLHDCTNovBKG4RR+naqimyNTIzMl+VJCpByDYKBYfDgnWgGc2GEqsePVAFDzoMR+lEYquDtd1efmh2sWt52oNh6dWvappSF0g+IQqABKpnLhUBDkWgjdMPbMuRpWVKwZQlv2YaWmkFd7z9S9gAoKs0BeKkgAOQSgOMAgIbiPjSoW0/7mAd2mQ7WvXayhsOxP415P4918i9gnW64WPZ/+6QHy3Ztx78Olj6Di8a97biVVeOiIe3risbGba1PLzNI/Llnes+Cs0e9PUw03Fzijwr+FBvelqWeliUFWwrOTkPLomGCrv0CQdeM4QOgwpUHcwL2UUHZRi6hoQGNgOFtWeppWVKwpRhAK1r6f7uZivMfOOAkBsGkpCmhD7zjS0R+fLT8qe4y6iqMKxdJ3SlToi0tHzVRBKruzplbNGZ4EZyWlch8Ab4gQ7EKF4QkqZhppIlp4ZpCQ8nZWBEoSaGMyfIDzstNKntn8tFoJo/5iodlNdKvLJhZbvYXoxGKkkrW7iPCAXK9GBAKc2UowvT5qavwz1uHgUgen+RfwCfZ+PkzjYboZ8CFxsn1kUfPuyw8KUQqn2pS66MyI5AwAmTEJ6gbnrLynO0cFBclIRlJsxC8dsBz7YntD6IBC5xlViQQFlAILPWzCDfP9nUdu42DYn8eWI4zMoA2sUT7B4xBHT4GEl2zmLreHP+eKT26BcfodvuF+OeD2XSP3w5txfCqzEGPyuwvqDLFiqZQmPhvOWBaXNwzzpox3+cjG09ulcnKO7bAARQhPeykcrEkwqL+dsnctHpAxoAe/ETdjy7fE49jqg5TxePgLdz6+IOHbPv06yVO+N3z1jvljdcPGbB5hfC0pVcd+Oq/7xznhB+PLFrZltdN2U54/ldjxo4d2xGy8b7z/vRzO7LtoCS2v8nATaX91DUdvPsmsxzK5MlQhyZhENQpI+DZ/NbgqY7SJFkhWqAeoenPwg85xF53mx/MQFpHZmHU0cOPop50IC92ElhrRm7jWnL7QO9gjlsCvhDHAHloOTqZg96HTHAZLc5a/l7A/wY9Td570QoNiw5I2UPLIf+xrU8aePubhf1O+Larru2/4IPgOBtNhj6Rh0bsxoc1L3TZPue173ncOQNDH1E+Tr5B2eBD5uT3OUmbqKr+kfToQ4fKX5kghKA4+wHeGfn/4v4SWVEwS4S7I2NmlqdH01y4OgBp5KI5RHLpUeQOeX5Uv9fMZm7sKtmNl9hkf6guCarF+WQwhbmZKYuUqJTTngI/qpZTjoSp1EfzAebZqjxlvKH6MaUR1adPmtY5T0123caDcx5sOvPyVZvXEDGVVenwBFAg0PRFSwCG7bFX9qpwaG0IymX3Tg4qtJiKQ/5p8fNlWiKi5BpiS5sOM6AJYQJrTN3Hu7Otwu+WkAOxJHd4QdkrA2vgnJvwIC9Y1Id//HpZOTuBad2pHAVo1nuFCWtQUqi7CV0pk0SZWTsu/yVJGV+isf15gxmwzSJavLHy2nx9Z2rSA0YqtecArkpZ1M7vmCSMxcxPkliMehfeMeWhor4lIYfkD+nwPuNeXObjxTCoXlDvnVm9w50hG1IL+btiyhn/vr3lvtDBPeb01Xd+JMTlD/naN7N6e3ufDvVw+Xw9k28Wk1ziQ8bEwdBy2BOW4Lvz4Ybf6W+WOLZtG2kvn/V/AJ8Fc4hnR12417LhRwXPfg37aVVhyx9777MAVWSDgcT1Ys7zwE/juSF4bvyOPDeI54bL8xzKWIi3XO/jsZ8uPbjEIYzt8OOX9d2z9fRbOP9tI6Xr8nHEeBIApbQA+08ubRVMunCxLFjkBo68HCEuuFZme1tr9v2s9rZDRioE0xtgdeWJljgPyDR4KjEAc+UsqLhCVcigxfveKMutj45rp77U2hqUuaB9D6ttuF2KzZQkBYwdd80E+21Ty1ojumP60OLeISLBgymoDU75x0M208Mjnp8BbtwdokAl6Rqmc+Zt/EJ4zuo7Lw4d/9AVX3Z23BDinFswvpZbI1kqAGi67sqKd3tvAtB7nlh37e6WW0Okc8BSpgOWj8OySsrnwmZJ3T/+4YnL7nNdCrBQwfQTw30MX7Jj4+FCp3GpVPhHMjce4jSP5nh5dHppqxko34DsQ6mFrhcoWk+9kqJELMCtxuUSZctNvMFUwtLW3ywt3/ANjNHUGSot5JVkVMtAmtI1LcUL5qAgyQgOf4Pw2xQ8DG9ce2fPgZ9uyAVQJ0VuC9IqYTmLIkfZIfU8/t0MnQ/deO8MnRWaOHf5Xp8I6jnhsfLHq18DmtOoIcBLFF2sYPRHYsbIAXbFB/LlCjSjwYr9RaUs/WKqWxPxe6wur6l75itKaicEDzXQCpW9EVherLi7Aa6AMWnOaFfg7jtr0OLH/7iP7Z0p2cSN5bap9i/g16UqdLD7o/+2mBpIeQ0ICHLrpKqzdRfbSYayK6kMdjlRU0hz4rAT1fan9idPXPvypEuu7gqR9WRrTwbqL6XXibd3pvtTD9Drh9twZuKVB0AmiqC28ZiiqG3qtIy/Lm6yvtWUy/47iYJT3ofJWRKqZQ8+dfMMTkK1bPZrt3+u4tJfvJ5zyfTv8KrwHUU6uvGdf9eRPncDXFSewbfc+IVsbdNJLMvadhmpUlLcGHztq6mZAE3bLgLIXQSdTh2KOiCM2LNU6K5MpT6o8okurnwfTW/bXXxjaDqjuPy6ysJHQbJzvkNrbvtcbWoVUmyTFK72w5ypOGMghYvj9Z6gRqWaeKZDcn0Vy++zxS3TK868eN1x50zvMX3TqXNEpHpmML3nHNEZoUtGFr7GdNJl79Q7gdIMR5G1tmE0VTLkE4TZU8gfTaIW0qB0sl4rW2kSFFmAabX19N+2aMNiB+iKYgfUO5TwbC6JGsUNdDdukGBqbEAUuGEDtEpQ32oL1OGKiZiowmS8Q2OKV4zeDRREmSYCBSgiDDUqFUECASbGAwzoVWYAzqMEuhslmETRPRm6uI5Bilp2wA0gLQPAVoQIct0a56sqTV+1NS/mIpeHTlrw/6KX8yFR4+I7ZndrQiEtfu6ppepBXEVcffviNF659Am7AUa1j4BnZP+E0urxeRMZJXtvvMHjY3Y+cRD7tOpwhTb4MUHOj9yrw6WP7JlhZrZKGUs718uYXhS/w9wlQcThj8zR4RtMDW1eohmJJZCEMTxp+6lbfLjNOyVkg+QJJDQRyzzhh+YOxKJb1cCH+bj+kdvL+m+BHxVe/4U1rjj6gLE0y3v6B+DZ1JATNU74ZMhNQpW5dgrTk3OYmrS9KLPsFWNiUSDKGMXIGNNBYm28Jfx8FQut8nP9fLcbEvJy2GHc5XdzM36/x5vTgK1bDGSh2pgqnkIenBPO+mhibwAAmMbfCvh1qJ315EiH5AyTdq4o1R/YKfAN3ynQxE6B7sqoL7dT8AscVWD9uzuqupPko9S+x3PXh3nu2q/13HXy3NGh+lcmCCGo/JEUCaruToGat1OgGm9pPloR6U/FXMvNND1TRSH589GyC1Rtfng4kLmkgkqKmUIlRtIcwUZE+In5AL6ouNdd+CLmSKZ4k6Ni5mh3ZcQPU+eLCVcJ587lT654FDTB/KBSoGTkqkyeH5SJeREvQG0+14u9wcy1Br3mWLd/QnNMXmo0V0S+3rxMf36yOD9p5JKVI1Xjh4aCH6DPFHqQq7i5QJ3J9CA3MwQ5fwjgW+HaBUjhGdKqvHGBOmM9dYBpUCWc8ghHdDY41znPbbcBBTOI5ZzhSU/2CKYHKWzHArT/LNEXhT1GUEp3Zc0wrn1CVsR5YGPwUXnPWyJ67aXPh7IhmHO/6HjEiH8o0ggnv2JtZLatd8z2/sOW22zN+R3b99/70TEn+Sdk0mdvLyXqLJaIVDZYcWY1VbNEczOzIrGGqRKbEJ1iNcRZZHJkKtWKWSyCv6ZmVhOLNKL6VCshJZobrFikqYryE6wROQBWb7HG5hjA1kWa2CZsx2g5a65hVc1WTU20Kmo1JeLSIVasKYp6cSsWteLSJKsq0RyTMoCpm3hjpAGgBQzCsbJhYoxFgCElaqINCSsWp9IE84yAWtYA0LYMKSQrrVgskog2N7FmNHaBTo42VTdPJkzRpsaabMWk7SiV61aMfX3eYWQShlhLGDRX1cdpKOixkUgS93aMAlRvJkoxtIijV8pqaG5stBp4bZeAmUZUGp1ksWprQqJOqoxUHxkBulOPbLImH9lgNdXyzHi06sh4IhZtqpXW2HAzfNR4WVYH5AhivO5/xJsFXBTb3//xqmB359pK6AYpA2fspGxpJPfSjb2XlAaxE6WxMAkHZtErDZImeikVFXcxMS//s+wcn+M+3N+fp+flh8Oc95nzjRPM7KxWHm4svjP003Oh9Exng4e3rZy7t5UNTIG3hy3KrrO3pxfLwdXJBhq3d/BSlrhh6+fm6gnbMBm14dvZwSi2be9Ko3QMrFh2VpJBkjTnShMjGfJtMOHeTk4sWxjydl/JLIGpXGHr6mwLfbZWZvk68K0dYDfQT8+ufj1gL12p8YamHaw8YS8uttLgnWCCWb5WEoMerr4uLL4LS8XOxVXF1s8aZgheBJ13tbHF47d3ZcG+rOy8oLuwmu8hmcRy1pKRsrC39fLiO9vOXbLWYMkaCz0DfYMNBvqrlsyDgfCdbG3kZOaNjRXMHqxmeVjZsCQmbaVzzYnvzPeSRM1hdx2Qw0Z6i+WkQ2QBp5irRw/chrPOy4HlDBMqmUzTZ3lOl4M5sHC1s4ALCNb8p3rw3O7pZev8H/RB2noWXzKIv3YHr2XJecHF1YWs4VKVrAVv6Rqz8uPDTHmxmM0AnsAJAPPt6m0v8Qou+e2SxceS82F5u8GNhCVn7erk7ezCkoM7hqvzzz7gldj+gKcYtvS1lUxKT+V/buEC4/hXHA4PH4YmXcL/3I5Z1XAV+vxc713ADU5KW+mv/7Z/SBIL3Xay8rC3le4UVl17F9MQAudtNlaK+lIm5wWH1BMuIbg2XLqmu3SKOVvZdG0TaPeD2XX2ZJJlY2vvYQsvhRz9zmwamBfINO6ZdI9Ce1rX+vWwtbKGl0q69WHpsOTggT4SQh/soE+aLKUfStLy0nOgv3Er/HjsJdiROK+r/uWylcdNVr2jb4PZ4Upy7UD6KdwnWDJHUfY7f+V7tGCTxtyZ174SXXUCjPfbQudW1dGsjoYH/ZIm5XbVWWJ8y7Kxvj51tLPhjbrEbTOknMT4Z5WQCxPq6Dr7jFMtgc+prjoWxv18D1rk1dINuvPi+BP75EorMW456Va4VS1dFrh25YIHI3WkYX78N54aHMzuU0svHOj/5v3ieqn/Qoyv5G9cm1xDWx4wCi64zNKRxo9xwZFjT1bU0PsFd2r1ts6ScgHGWY05Ta3V9AOlzKNTds6WckuM73s60ji0mgYZd2+MKhndM05i3O/ut0XzqmmfR+vnzjQekyu1ifEj/PwjRVV0nw0vHKhLU5n84PGfO2dqX0W3p/rzCqZOZfLzAYv/4pfwvlW0nXHfH3+mzpZeL8R4jGfTzIRKekjvD3tEjoOkPB7jldcOzCIr6b0qH05lqbdTPeICjJPmzuOy79IhxNFzipsHM/nBuGV96YX2CnrmpeATmbOVmPxgvF3RRWFOBT2sE2wwWDCWyQ/GhQaO00zL6YkOJTdjc6Yx6wLj8ccKO6LLaNXA0w4G2+f0jDe8x/Kj4hV8q5SOzgznZOiPl3IhxoUC/eL3JbRdTDmw1s8hpH1iPKNpKjWjhH6Vv7zeJmJWbo+4AOOGH04Yryumm2vz+zysUmTWH8YrWbbxe4vo/l8f76VzUf4w3jDst9BzhfSW1es9Yh73kLPw/se/GHqvgLZrupLwe8swZv7h+UlxY3feobUMh51ecmpKz3jDOyz+M83PZt+ho00UYsKfspj5iXFBqZOS3p804admlT9orE6PeDzGY6awvrvfphdumKMX7PeW2d8w3j7187qDt+h+f7qPZUfOZPKLccsFdYqZ+fShhOHjEgXze8ZJ3H7lrj33hfQHk9Z9h/gDdHrEWRhveMyJbaPpd7wE0w3es5j8YlxOCa6PPJqAC0VZVVGnR7zhLTZ/TaI3mFO0fJ7Fls2DJjP5x3jD6oXO+3PoonSTVjWtWTo94vEYj+fcW3Y7i3bYtEBv3q6RPeMCjFs+C6tuv0E/8uQVaxyezeQf4yx5oDDxOr3ZvMDK5LepOj3iJO7/xEP3F12l/xr5peyRuXLPOAvjggSRuu1lun9CtI/5rlFM/nE+XMgecImOjVIPOLVVpWe8oR3j492fLD5Hr3W792yH/6SecSHGhdxPW7xSaNGZd6rLvyvn9ojH4/zv7JBTCXT637M/Zv72kegRF2Bczm/Icf/TdEv/PbtmC+bl9ohb4vHVKUzMPkxrJX+N2xA5l1lf+PXfM1KF0fSJ5JpPu6b8RfWIs3A+zFGxYS/dQj4aDJrG5/aIy2Fc5ugRF4oxHuo9epgAtCqdPOpYOIzJD8YFcVs2sWJAdUeTvEk9ur/Cry+eO2vVEaA6yJibE6/I+Idx8kWo2aJ4sP7+W1Ph8F7M/BBh18+vvWiXCOb+yPX2HKPM2Me48PSo9AOpYPds48qD25n4SZw/KfcsPQ8U5j5Y8c5hApM/nMsLOa8ugp3axQa6w4cw+/8bbH0vr9I+fBkcPzV4kxkX/X3EeENVysfcq+C+/uMk8yJm/VliPP6wnvHL62DKZDNCns/4T2Jc+GpAjVwm4L45mRY5pY2QVmKc3GpmzssGj1bkLjQdPoPJTxvm34XIot9vgmcOHUqCmJGMfxgnqV5b9lGg5rxxQdVydH+IcdaAAK3CPNCw7PklB6EK4x/GGx5rxbbS4MeAMwb3VNH+jvM5/lFj88E7BZUKP/E0Zv2/xv5+zdijlJ4PVI9qLo1KYfITj3FB8CCrqlvgzLU/Sp1O9pZyAcZjRmd8t70NQj3WzEhdUEBI/cN4Bi9AJ/ZP4Hfjx4btAcz+zsL5mZZnc+6Awt38Z6282Yx/r/6ND4vI099cAPzmE8rhd9H9E8bdvMNHtBeAxmknnkUOR+OPccOlQZGhhaDvkli3YXbo+QPjclqvL+UVgSrll+kbdBSY/OK8o97YuBi4dsZvmftOgdl/Md4QRryJKwH8aZsMl3jMZebnS+z+x2TzA04pSG88rx+pxtwfCzHeoK0ZUlkKbozYsPXPNSqM/xgf1l7wzbUMVCsduuPR9paS+o/xmNoMncvlQC1jdIdipyLjP379i84h6ysA+8MiyzkjbhHS/GNc7knLhY8VYHjUTdvR00ooaR3GM646TTp6F7D/GlTSVjqRyX8r9vymZ6npXgli9d+MeXziM7O/Y9zSyl7lz0rw8hUxJnzcHGb+YLxVMj+rwKT2JOsh05j1Z4nxz+dLTR2rwB9jkjrKj6H7T4w7GFsfpatAZu4KozfJ6O8rxrOGOC8bVQ1e5SzPeRoygJlfL7D81e9qz6sGH/oYrv56QpGJD+OWNY1vR9WALGJazY4mZnzjMT4sz8fesQYU+b7NKHcZzsSHcTbPd92tGmCaK39jg/Y4Zn1jvLVuxrXxteBkQ0ybeks/Jj6MF7nfinSvBd737PtXzFnA7I94/2NPNRTXgsQHAyaGsuYz6x/j8ZoKF6fXga2FNn+45c1n4n+Ozc+i9R0764CYNBO9uTCViR/jllv/yq2rA/W2if0UBw7Ilb4etSfRfyCQk5N8ruBDL9Q+RR3rGJSb2/Wlm78AsUH6MiZWaexdyeucsZWJ9pK3KUxQi9G3Gmb+Kf2iw/UPg7q++1BmuLxa8nWIwIX6xxvubwSyfxdd6H0TDLSPE2q8b2k6n8TArP7BiZGW7pSVwFf3WJsYVNmFDNthHkMF7XVpHd0sBiM/2autq44gvIJG12Q8FIOvUV9mCCrCqaefnsxzrBQDq6LnVvodlkTRce9xywrF4GgNz6QlIYYIeF9QopsnBs47A8ySjx0mhoZ+cdpyXQy+i3/sn3A9iuhY4aG0/zy0d2KBm06eLnG2qobbliAGA11iQlV7/05NrPn7kt1xMRiSu0Bx3aaDlJHJiMpecWKw8ZV+hFhgSJVxnIS5YWIw5kNd9oziWKpBJe3iMX8xuLTR9GVzjYAwikoqOrJDDFbGJb0aPVFA7TTaTWR5iIEO9+nG9qnR1KvICM0vv4sBvX4kiAgNJ7xLXV+bWIvB7NfDfU48PETVmvYJbDARA8sFC3U72o4R6dkOnJANYnBSM7jU/0U0Nfnh9+mGemIQeTt56SLXMOJexLZ92svFYHefloy+OwTEofrdsauAGBxITW3+EXWI0Nzm7bJDE/KVXu/GmYcQIPmKQQVHDN69mHpEaYWAeLKryXaZkhiY93MHO7MOUX9Yf2z8a6YYcM71d27s8Ccan079eHIKzD/tOuH4NB0q5uGjyr3jxODagEEe/hrhxMDeLclBI8QgurQidP8oF2LTAt20S4PE4Ma5DD1vvQBidCZnwN/yYrDW63xTr8XBBOfB2u9uvcRg9ecaM60n0UTnGJsr/b6LQB+TKG1BQjD19vR+izufRMDBcE3Zm9X7qdK0hRopb0UgSsVo4meFo5Tdg77OF9tEoFr9gG5rlTvVcfqZ6uMXIjB6YsXV8eOPUs9SR95WaRYB57WKKStPBxHTVUesTX4qAmH8uTssR8RRkwTn+yx7JAImoWNXRqdsoRTnd0wbcE8EJh5bZX9ceRd1ONXw4ccqERh+/pblG+slhEqolWW/ChEQ28hr97c7RGyWm/xmUYkIbO995lFjmQtRSeRfP1sgAuwRQ0FUZxzxtOZ+u+JtEci4tONmRYwPMUdRve4RLQK+DRte506OIwY/+XH0CgXjSXCXUz0QTaUon/S5ki0CqxLi6suehlCL7e6efXRDBCw0h+YWPPWj/A1OblK6JgKfTHe2LR8RTA3db1aSeBlef//HuL5qccSjOdfVV1wSgb7HwxZkHtlJ/Cg8XDviggj03zCpqdE6hpi3YeUThXMi8KpgvGFQoSqRuXxr2Ow0EVAT2ig95x4gVk67MNo1RQRO+xy1Wt0SQfWv98luTBKBVD2x9h1eBBW0cWHGnkQRuPhSKdRvfSDFul2mujxBBLZs2eT3pCKOmjV9o7/mWRGwGb9HkD5sM+GZtrZ24xkRmDvdnBZfjaPKtffanYoXAf9s1ZALI36n6EcDvUfAc1Gac5bY3ppaMMGWuHJaBIz2NWzQqRdQgQeMvuyG53d1jffYTPWjvCzaWr3hecbucOFqUTDl9UfSymPwPOz5xinc8cFUsf3iTa/heU1tf/PSEzEEMHtqwIf9T07Sy67n7qRCer32HAX9cRTab/jRdoDg5rN7vYHnG53unWt8bUts07+r/h76v/ju1QV3zuyjRkzQ3TAHxquqof32Bj+OGlmx9mgozMeUzvELA80F1IXCGcsnwHy5bPZ4YFh7gHqzf+nxh6kiIBc2xMT+Qgxx1C7sYWG6CFx71Z6/IDOSeByvuPjZeRHofHHnhOUNWypi6fUxXDheSy3ebw34tJNQ9x199CIczwCdKSlT+8dRBZ2xA03geM+b4hSelWZGPbtTnqGRKQJbs2N2fZnhRA1dV1S6NEcE0r98mL5kyX7KUP/paf9cEVgTZXffqSSIylEocXsrFIE5FbFK3y+5EzHtCf6xf4rATc8BjWrVzsSMGc3jrYtEwHr6tul97oRQts/MdtqViUAdp6k5eFI4wVNZ3Xa8Eq6nm1RN1c1YymyW7pXedXC9cUQnOGUxxJar7JGnHorAVWNPl0B+IEH/2L7R8SmM92TU4fK//Kkd72toR7j+Qnil+30nRBAXaoyPnm4Vga8Pq1ZH74yh7G5EzlMQiUDOxfpND29vpL6NNsg6+14EyE/JOkMSY6iFW59FenyB+Y+7oPnhngO1wvzbO59OOF/Dtjg2iWKp1fJn2Bl9xaD8icWA+51eRHX+mpgpcL85f2T/12+5sVT/KfdNbsH96OqgS+yLLp7EiXVBT46Ph/vhj9Om3OYoYkdlp8U5Fmy/tX9VdEMgsaZq8/y3c8TAfoK+5qVya+L6C/kDzgvEwGH8fidlR3uCHyOuZ2mIQfX1soBxYQLq622zjQOBGLh+7QRmF6KpXaEKq1VWiMGqNG/Ni4NjqHehg/uFGIhBioJOclCCFxGS+K1+3BYxGDqdZJ2K9aeOBBSPabaE9vfn1xkaRxFB3Me9n/PFYI1jr/NbFwYSltd6vZ/mKQZTda8pTKvzpyyO7+Qd3iUGxYNXaGcrhlLzznwctTxYDGr2LbTsc8OL+ATCX8yPEQN3j5NGbXcCiIC1hd+MjolBe2xN9IiOaOpRTOLZS4lw//ea0XTkYiT11j5KZeUlMejHSl9E3Y4i5hhbiSbmiAH3ddrtA0qBxOEcRw2lO2IgCqripNmEEeQyFxOfSjF406zdkqMRRY3KO3Hhx2MxOFkeq6cd6ks8iDn1R/4LMQgts1yU33c98dY9WunWezFgs9kcNpfNY6uy1djqbA22JluLw+ZwOFwOj6PKUeOoczQ4mhwtLpvL4XK5PK4qV42rztXganK1eGweh8fl8XiqPDWeOk+Dp8nTUmWrclS5qjxVVVU1VXVVDVVNVS01thpHjavGU1NVU1NTV9NQ01TTUmerc9S56jx1VXU1dXV1DXVNdS0NtgZHg6vB01DVUNNQ19DQ0NTQ0mRrcjS5mjxNVU01TXVNDU1NTS0t6KIWNK8Fu9aCl2nBqvVeWl7b3Wwt+C52rnL6HLaFhbWfn9U2vg+Ho25h4enAd7b4yZfJNNCAvztZeXr+YwsuG3bB//eNoNGfLwAlJz/fssITLru7F84QcDhOrvZ8a+k7Rcm5Ot/Fx8qJL2ls7+0M3wlKKrn428+uCvxlpqSC5+HtInn/yjRhDvQ9Baakq6fx4P9t/o1kSqHcr4dA2q4/yZTCXnLdHxXfO+GRCyr27lU7uUORjEmab1sr3E6WcZMSdi+7SD7xn3N7x6s88ryTbdSySFPSYI7eofqg8+Tem3cOBw9sIm+Ojb6iXNtBqgzcwR8++imJ+t1d0vjIXv6CzhK5/CZJ/82jrV36qE8k3/w2e1n2SBNy1b11lWNUBGTmoD03s4IEpI71pdRXCXpkL3v5ierfoshvN+Q3L315jRx9MykrIzGPNDJ37c0WHP7Z/5NTF1KmfZ+nu7NqmslH2H/YBfNWymcoOa8q+eTK6EWkxjhlvaDbm8hnuqlR0StWkifkVc+ssl1EWqS8VeAN8iZn1GkY7jKJIV9y5ifsvhdOrn8zf5fzu60/+/+wdOOn2pe7dAMG++Qthv0LL0Z/yXz3G2mT5r5XY9dcsilq79jUyxzy73yvpFVrRpH1bXVhua5qZJ3yl1Fx6yzIh4/P1j3o50ymBY57tMPRjNxvpP/hcg6LlM3/e8l9P8ihO7bbn41dxhb6XG9ZX0mFCEd7fSZfzCwU/n6i0rYy+YXwWbnJ02RlG3J84IPKbbF55BHzzIxjm+UWjT8R7LH+06xFphfG+1ZvnrloXHrSEP6X4flH4s9MWPL1Rq5479ZSSf9rLvQueT6JJczITnFy/mgnNPDk8Au8DgpPpvzY1+yQKLwy3LjzitEGUuvzzhecqafJeRU2g6cOrSIPV+WkO29uJdeo77rbZ81jsk985/f5rleEBkXRNWl31fI2vLlo9Br23/nwN94ttxHCR2PMbrm3rRVa1I1bURPiJPw00dQi285R2GJfUzajbgWpK+IIXw8JIo/tilqq75BOJm+YnJxz7jq55q/awTuok+RUzoB5bs8thdWzC5bOfhuSNyxjZWyUbg79SP8mP7CPvHBvjEN+UxpPmL562NOEecuE61zuaqlbqAk7bS76he3TIXMm+T92OO1KdsSvquh7PoScJ6xdOWtiCFn7QJcw32NNOrZOfBF8b6QQPRfhJTxIZrUxpSZTmktLQTDJPNszZbO0nD1mURe+tKarTO0X0FV+j6AkpTCC2yEp52qvVV0MW3n7Kngy5VVYPmgTaXyApWdJW576ErkYB3b2bzuXyBkvyrvaKFzCKrj+Unuu/FKn9q1W63z1l6J5owalDqUBpQmlBSXLFiJhTBudy7QloHSgdLthgEnMom7YYqglUEu7YcuglkOt6IathFoFtbobtgZqLZReN0wfygDKsBtmBLUOan03bAPURqhN3bDNUFugtnbDjKFMoEy7YWZQ5lAW3TBLKCuobd0waygbKNtumB2UPZRDN4wP9TuUY48+/+7BOTycoJyhXKBcodx+oXNJXtcxg1kHLPLYUckxniwvkxyjmHIYU9+fRFcOg3KHGoH15gHlCeXF2PLGmA+UL5Qfw7ZjbAfUTqhdDNuNsT1Qe6EEDPvjF/8bwH+hjI98IJaUlotOi7rqr2q2dZ0LqFZJyXq/tkVSkmZKT7tK+QPVXe1SxmZLSuHhbeKudnbHX3Vx7cLGLp71uQiVNFNPM+1o5jqasYvsoH6RPZrxh2b8pBm/aMaPrn4cY950+dG0+wEqUT1WMvVMO6YexYvsoriRX7gd5J/ED+QfihvFieJC8aIS5Qm1Q9eheFB/mF3GH8Ye4wfyF/nT1f5U/HPAlLRMCXrAmbiYfpl4kV3GD9wvFDfyG4+PlokPjxPPD7oO9YfiRHHh8SK7yB7KC/IXH0/Z+YA4Xo/PB2QHxYPiRv0j/3C7KO9o3qJ48fmN5wNfH7TM+kDjjPxA9pAdFDfyB9nF8vVfO7QWtSvPC9XVdf+6dE2i57q8An+TU4F/m+Z1VPL/mK+4STdtsuUW35lLdeuLQ0bOaQF5Gqs3f7VUNMorCFX4uP+jYZ7Zvo2W2SIL3Yjd8suXTF6nO/+s3lPT5avyymeZ9K1RNddlyjymHrVD1+Uhu8gO6pexp8v4o8v4ifxCfugesTCKmGBrrlu/df7JTUZb85gS1eehEtUzJapH/aN4UP/IL11kB/mH8oXygeJGcaK4ULxMiepRO5SHn3lG8SK7yB9kD+Wd8Rf5k0crL+aKv6/SZUp0jtf/S47iYvpFdlCcyA/kF/IT+S0bX55MfKjMk8kPuu5nf2h8kT8oXmQX2UN5Qf7KjCcqUf3PEtXLzAc0j1A8yA+UD+Qfmh/IP+TXz3hl5rcuE6fs+siTWR+oX+QHsofsIL9++oPsonzh9zv/98f/lR/ttEwF+X/jRz/hr+fDyP+bvLOEMuf/S36MkrGjKuMHm/zfGX+ujJ2VMn6Q/0N+TJKxs1bGjqkMNyT/Z8aflLFjI2PHTYZb/jf5MV2mH3MZOztluL8MdyP/e8Z/lUw/23+1I4iV4Qdk/BD8J/2YLWPH8dd+yDgZO8mkzLkMjyH/c+O/7td+yDCZfs7L2Lkpw7NkeHwP/VD8tZ3QR/jruUy8gtsyflbK2CmR8SOD7NH4C7bI2Dnyaz+Wt2TG5ZGMH80ydupl/BD+gx/zZcb/D/LXNGb+yln1v3L2W5nrP8nYEcn4UUnKjj96fkH3Mej5A92HoOcHdB+BnovQ/RF6Hkb3xeh5Bt3XoOcRdF+CniPR/SR6fkP3ceh5B933oOcbdJ+DnsPQ/Rh6HkP3Zej5Ct1noecldN/0TzNxJJQ/1GiZ+i9pPna567LALt7i5yV9q4FHypJjswyfgKzWOrvEO83A0SPxyTLlVhDQMkqNvPoaZHwZY/dRSwT2+OnNVk4Tg+96Q1pfgSIwVNjgG2FRCL57G998nXwH0ETJxE+zboPfNS8oXXpBgy23TrzQN80CprPzz17+6xIYeivz2qPy4wD5EQAVCBXEfJ4TjPkYArUPKpRhYRgLh4qAimRYFMaioWKgYhm2H2NxUAegDjLsEMYOQx2BOsqwYxg7DnUC6iTDTmHsNFQ81BmGncVYAlQiVBLDkjGWApUKlcawdIydgzoPdYFhFzF2CSoD6jLDrmArdgj8IVGvXr+u5EHwB5RMfT9yAPwJJdv+X9b366affky9nEx7VI8fqF7+31V/Bv+qvk839fL/3/pev9RL6nr/Q/1vqB47rkJdg7rO5PoGxjKhsqCyGZaDsZtQFFQuw/AFSkMJofIZdguqMid/1Jfzx8Hk2kXw30nQb+qu9nyF0yBw2OJ+0wLjwaGdE6yyU84AhwVncgM/nQU7R11c0bgjEdhMG7i1aHEyGBdsBf+lgrmXzlDB79LBlK7jIhjedVwGo7Qvj9S+fBUsH2vmVbUsE0wqdIf/KLB/5ir47xaQfp5bDDZ2HXVAdj8ttn9CnBnyihim+5noN62PTqnOYJ3Z18bqDLg/Q2fJGK4OZ9ASHfUDm3XetrvphO7bp/Mw9KROxPwcHa2oZp1Zq0bolpet1T2Xng73LcHPPm9D/Ql1h8lDQVf2e6EfXUKF1L9sYNd13GPK58AdepDg9oZelzUl6LXRA1Si+p+2kF3ZUvYz90KoIqjiblgJVClUWTesHKoC6i7GejFCvyN1wqM3LPswkocK+HJWbqm+y/9jmCwDsjC0MPwYNLaU3YQ0Sk7avraAhUiX5BQ2SQURrCEdtnSYdLeTtKU+sHN2K8j19K/TLwOKUtywkkew4DN2PTX8kRyPSbQZ9ut+Ud6XS7FtI/qec7i5ypTlwvcRe6nKlJgbvJr6C8VLU3humMnnhfswL1fl+ItwCuZ5YxJsw91jemwI0+P4Jz0O2YSj8L2Sb9MN6BtKZEySEOPU3iK+5RAe0z3oCNZGrEWeJWuKOelkhMpLG8rkd/Pk1VUWBbznq54IMesP8tP9JdMv2SBqfQT1EZYEDCzhXa47Myo60P6UwqPsqWy3PYbo5KfsT3bk9EQbjhi7ENo5hPyfqxAW1qDZUoprWX8S8HAH7odrkGtYSptzPWLPe9kcpsQhvwYypiRgfkGAnNUN0g2FEBIZQivYiDrN5ySt6aM8SJN5i+qZ5v6WU9+2s3C6PiEfmnl/YCqB0TNxmxPIHc8fqKv4I2VgRuHEJurlTpDfUIfyKhMksSYiaAmPfFRIbUpByw4KbgZSkJmIjsUd7hl+4dxYWVb5DeBwQgnve7nYB35jz0UrZKSeUbPcEoO7XWSG6zJndgt3D/qzZeNsmF7Ke/HJyLX3c0pjCKdpbiRb2ZL3cynBIZ3McixG83kUT6t38LahjZ3aYlgb3Ua67x6bDProS43h5iwFFCKe83DTKpqaNRF9JM39oBZkatbycWomsve3ojphAWHj7QhbNozPR7eSfzGEaS8+sGyFGWOdb5Ej6OS8jSlutu2IK6RxK7kA4YwPbPMP4VxdGLZ/RHLwz7+4cHgLXvcqUcmw51N1C0f2vmVerTMWzYtp7tJGIesmdbZHGH/Nn5HzJjJ+SSoNmxv4t9GcVZePgcxHbpvlo7j8CYN3xkLVANPiWvFuf8MEw8/89z6UK8/qufpNgVihOGp9DFEVu4LE4o9Ejj9O7owAVAtPsTSmjgBNNSQtPPDNjMb92XQ0WhL4W3oFJn8/5FN/FM/jEnn4NJxkjUQiX7tjY6NN+eBolqUU4Jy2Ex9fU45Ya3JKqoSKJ2Ic0ZjL1116qAtNYZTkMFaKuqD8ZhNLc6LZ9Ww4lXfn8DUoA89lvpySfsvRuAwKjn3hxoZ1dIh/YEaSFp9XBnPZ3gWBoQ3G1iPYHxWCxXpFdBxq8Ogci+YyTbb+bzerfW6zeKMnEmK1KH12ZaLTHeRFTmA9ci0FBj289GvkwHcZlrsHMVW+jARXRZpa88ifuJHoh25EdkWh7LuWkWlV+IvE8VHdGwbkeemThVPdchzuLyJREMY5o0TM4gYZFXEYDZM+YvROIPA+jEzxM0T7DZDSmc+20NNsCY1l7LgYxjzvZGfoBXqGVqIbPYbNsn7YpUth21LO1ahSxhpXcvPDSJbvludV0Rd6ZpUjPjGHqHlqOIT5IWagxei4SazTz2HquTouvD7Ptnnj8ahbhcqe49RYJjLCKAyxd1+Yb3wYD41k9ApEkJwhRWf9Vj7HNNCUv5LVzelk6rTxNFub3Jg4BKYuyNn34Xf4LS6H1jPQo8P5M7n0S2nwO0DyZzcOq5x4LVSMoqM6VpbVLB3Sx+17KburPqIQ209uqDpOh78wskWKH7OE6Xo8lUVX0rCa/A/abWKsNn3BhKo0tGYX8i5nEmscs7hZm46E0Ri2/tXG7O9+BBwaSZSML00ZG/DyfMjbV5C6YhMN3cXkOJXh19HBjeFTufRehcPJtdTn+xOxrJuv1qdpCv1E3js1BP+lYLStgut9HkRfnY5STxHn5urDhRTyN8RSZDUSRZUCVoYG0y2SiV/OaAI2n0F6vBK9xSr8eDJIVM8voqoGeey3E+HsAQxDvdnvKcXggSEUDEWwddZCSTaCVZUvf+PpAv94eBLvrIdG9VbC7y1DvV+aqypmzLVdyDXvdtRbSqjeOUgaZxHa+ZgtgtPM9FqK3fiblG4Lx9t2Oe6W90leP4y1FjpMu1OM1vsGJnjaYK3+mP2q2Uy9XM8ZTW1Ei9N4eek20l9n8o/rY+SH/JEcEcoRYxXWtJ1mRnoyV87eQs1anILvpozrbiGo6jqpPbXkylTSfHYvom7bULWQQR4LQia+44FIBBMlHEgwOcKBqj66B5Vwn1tEQNQChD7+orT6JC5ua1ihlMWahi2ofKvg3pYkPl2NZ9SqI8zQzyDNyoaJRpcI1Y2ndcYwfAQRXOsronrHZ1Y5jmOYiDuHL+ZxueY66yyWMe3naOJ96zknbECN8UKEewO4v7iV1Yo/uNv8L88/mhDo0EeqQyddVRqkJdbjv+k2ro8aedc9gTL9P1giuwSL3TbcrPyMZ0wTearWjDZ/zRRDU2wbDqA4+IJndz8yK7AZr2MLEb3fyNC9I3i6PeTiYBOxorUEWu/CPf8ybZ4nMPQNoGmcG187slH8s5/Ca2UUs46Hl0exq2wOT4J2sKvzIKOklNkrK0mwUxzDFKU5tcePwcEqLBe/pStYm/+6JnCorJSGxAE0suR571lPXKM2nVmWFGQV0tE6mvFRKnhZLUDZMork9kfcnVGK+/YcDJWOM86mlUGJFTz49JOjBh48jFDmxe1wBgqyefvmBqoLr6GmZ4vuTHMmd/3L3gFxfq5wQ21KJxsKwlmdfJiNs1pRsuilpukuEnIJTPIuwTXegXlbdmC0/g0h48bwqXAcAy2fWVCh8lvf8Ny6FcH2HTgfTSVG6y3XZEqw3ZTKA6sK1oU10Wk4FoHPMlSmCLgge4aZykvY/PEeXXuSOLmxhjURP7AUHuDJ3+eJmqWNbv4snGN7sXiew755ujQ/S2XdqDSStS6RfW80rkLLcLz8jpDITCL/l8j3G9rMjLlCwL4VJHXMxPhUL71LLXiwSx/nV6b8OtHP9ts2BDinUZa3B4svZ5kfORuTMgs2e4oyUykCvaVhRD16ypOTt1n+05ghyxdMGdNM4+aDxP2Yz63aRsY0dtCz5TxLGyPYb2bHzAgDlP+OY6ztAZT+F0Co8iTMqscTOS+av/6IIqvhMU96AmjQr2Pep5d8df79AzHVOJ6bz6LYS1QGSpC2rhd5gT2uDwSkxMmRpRiPS7sCYq8LMD81g9VJzXjvsyc4cDZjSjXJ/HyUiZbPmPlelMITSngFryJdbh2F33PZ13+XBIEt0trDf9c8RdjZM/i+9kDvyB72lWTjrvn/Lu4DnKr/D+D4uVZkjyirW9mJKw3qHN+rqUnapfJrUEkuLRpco0LD1ZQGpb1oos7pXKG0uLRst2Vz7Yw4/+/p9/U8v+ffOufV507cZ57P2wubZbkawyY0YUXYHuxPx1KMs3IBJg0UYvAXn+0psSfjZux0gQdhwqy/+07ei94HT2UdadTizN6Oa77XifXoiB+T2NubtG+ZmFQpzW6Z8BtgouqQsPdf6ZF1tluDdaEx9ZfNAV/p5Ce9yt5tXQCTLtL9ofuVPnBUd+T1QuhgK6fVGV/owse5qnMesBaKlq75Qj9Ts3ecHQ+NDd8tkftCj5k2enhSILRIdOjtzc90iem1c+6e0B7yy6a7f6ZzzOJuL3OE5vtlT+76ROuVX/R7pMfOb/bfuPiJnu/1ynNjVyfAbsY4n5j5iXa3jX/iWwydkebc0fSRrhStfkc+gxbEzcg/85EONixp++cidDJlYMr/SB9eNktnmRBaOEv2va6I/uhXk392A7SU52R0qog+GXbju/ls6OjSo7kuRXTkTKVpjA20yNL6W10hXUU9LButCd3tNtb/dCH9tXLC7Lj2DujMRF/XQppvVVkwvRg6QXZK0iSh81KCxS4UtFbZ8GuJEjrWXJoddgU6Y4Nn9WwJ7DF8MlOMhm45NHN0QwGtOm6EUb4/dJrBrrmzC+glw50/liyG5mkRM67m06uiHs+wnMLO62aoy+XTfd3DXJ9w2fvvsb7i/YF+0OFSGjEEWnRagSN+T8cNLF8T19wOnz9mmTX3PV03XzW55DPr8GMG4e/osVlaYm8KWvLx/Zvvb+mM0l1jza5Bi3Ts+DPf0nKSpA+jj0G3mGzec/MNbbw3Knf1Lmie2xZ/tTf090n35uSvgRbPvM4NzKP5nxYkhMxi53qP4768ps3eMfle9tCC9XgG/pqeo355157h0N6TzyemvKJFzi6T8zjQyelLHFRf0a7dp58vbGiD9zfbfWBHLl14a4Tc0M+sX8btK8+hbfrTb/a8gMaKFtnOyqHvGKntNb7FOpKMTcumeU/0vINOsp7jd84om+68vHx57wFo/lXRksMvaXqqyflHm6GTQ7oz27NoqjMu8uJi1rbmed5Z9FTlN7fTXaC5v5eH5Yvpp/xbYzk27HxgTjkupse7vj8TMgxaOI+kltP0+T9FJlwONJ9/RnnyC1rVbcGcjsZW6B6XBAOK3rIpzrOzGDq5eKFvz3N6f+hy7TG50N723JDyZ3Sdxbud+x9AC61qssWZ9FNDWzXOJWhx0KNZ1zNoSvB0X1osNHb3EedYOv2UlJnH7mHtNLN1J+wFOMyfeGwjtPCwv8baJ3TFOktR5iJo6eVKL7fH9Pyi8Vc1AHTy1gUljo/o0h6toCO20N653SHch7TDk0YrniE0d33CLI0HdOqEqNK+IdBY0dZtvan0I7+Fms2dLQDj75l7rPQenZ9ks0bpJzR28GcjeYcedc12w4wiaLEOP+byLdow4fv+G2LWco4rom/QhZNeRdqnQgu/+K4NvEY76yYnlF1kvWlOrFcKXVXjmXrnKDR/2MYfcy7TfVYL7ZP2sfOGCHHQJXpE3MSjT7ay9vRsXZpI2/Y0XmteyTq8YD1xhhbZFn6YMwcau320z+oEfetey6tXTqx7uPscjtK3xofobrL6O18zcUQU7baj3tJsOOvGl/I6wfTpB3pKCsqszUJUFLxpw16L3yOlMmhRVLssAOys/+el8WXWxETX8sPA7lx4mtYGaOHLnJT8k+DDvWa8y5ydx+hlJZ0HNbrx8nl1zdDa+cVpl8GdB++ChfehxRzJ6thr4LzaxSuGO6GFxfxIr1vgybmhkfFTWC+XbbW8B5YleqtIOdDihF8Ju9JAwvM9vzhvmwBMH/7oXPwQyMfvV207AY05Hamwewzyvfp87npBi5cfXqn0FFysXHvb1pKdb524uzQdfLD1c9ne1ghgX2jh9DuZQC7kxhX/F6zVn78Ofg78lSf7WxyB5taM151OAYUVa6hTK9h5ZaDDUBocTXru+MQCmh8/dpivGICaxubIzgaApZ2IODg7C2SdKdvVnwPNe/thu8VLYDX3kJrpaWiP3Otf5bOBrYss9/smaC1HPLsqGxyJfuPrNhlauNdv0rMcMJdnMmqeCnRLoZXzyVwQKms7WFtWDz3c7MPWV+AK4e1gkgot8mns5r8GN1Z8BNUR7NywUzwsDxzZoSLjL4cWdi2xrssDlvPuiGxsofndcpOevwGFbSd1kznQmK1x05G3wAgvM0v6WgcwCcdr0ep3QPTgtaL5fWgx+d7X+j2wzz/bZncQ2tvt88Su92DXvKvNz7zY+awJVNYH4ORWc/HVBGhpQQbnaD6o9vS1d1eHFhmIVZYWgItfmeOe1bUAyxips01DAvZj75PyaWjJSY2MQAnQyH5RKj4HLTh0ye+TBPQZjLltuZOdz3M8PKkQKCc+uou5Q7uN8VVPKARLXTbVzrGBFr6XMt2FwFuu4zRHCXrzhq/rVhYB6xTpBvPvNQC7qafCyywC956U73n0Atp7ulbQ8I/gpflZ39vnoYc3+lvs+QiWKxm0DQmB5qX2uX/+CNR0v5S9XQYttf/RPP4T8HvqzsG0qgG+elr8NrlQ/PTjBfIYrxq4rsHc6uljePCnU+qYRzVIv/bl0I2w4/i9gIVDMEE1mG++xK/+zz/4fc2qASauGvRrrJxvGbqfJHM3DMHSqgGntNxtc1Ys2ZXlZYpJqoH2yTkXjUEk7tKl2MDIqsHicd8NFYShpPDsIQ1MqwZ4hqgE+jD7cJ063z+MfQ0wO0xZfMeO4lu1w6sY9xpQxGndHi+3nRRd8NXEBDVg54UlHwL/+JIT80J7mbgaEKnQeSnrRThe/ZI7wKTWgE0b31sbhApI7A1oYgpqgPGRfcpBQiG529CijpHVgPs9F/2txMfw2pQLCphWLXCc/2tRUVgMHmd70gDj1YLwdt7TuoFY8sIORyXMoxaQEzf50XQM/ipmGkyx1YJd+7TbN9FHSIWQzgYmrhYsf0dc2Y7FkFUK5GgsrRYMnSd1qsIOkLFGar+YglqgmMTMCsSiyenH4/8wslrgJNgr2Rceib9e12uKadUB+cdVu+NdYvDMfbN0MV4d2C2XMG+hMAwPGNJczbjXAbv1TElLaBxZqINXMgF14JmTxZnbEQJSPXZmBxNXB2Q3N8YbCQ+TLnYJFUxqHZh8clWslH+Y9OmbA98/+/N7Pks5H+CLLrRysZY6MHR1tOVtEEsqpc3UxrTqwbLSFefcmJ14b9fzIRivHgz3Hxt758VRPMTkrBbmUQ94IcEVbweicTe7ThNMUA/K7hQTu13jSE/HlcaYqB7o7H4ZJUcfJ+e5uNtgafVgHWBwhf4tZKHp/a9MQT14LBDp1LhEkMEKi5oZWT1IqdSQuihtxVerbypjNBtA5tCRTnlKq/Dlb28PMPYNwAQfs9OUE0KWPztdwrg3gCSbQ5u1mBDywqZLZpigAbi4H5LMZGJxvv7hHiauAfRkvzyzZ2A/7v5OoYhJbQA5Y9uaLZkN5Ewv1yKmoAGMqp/anM5sI6tUNnQzsgbgpWp3Vt41nFy8+8k3RrMRjNiafmpj1hH8x/LeVsa+ETS94h2TDWwkzX7S5Yx7I9g1u5HcDKLI35lLmpiARtAoXdySEhqFf447B7//jaD1RM8xpcgdeOIo81FYWiNQ0Bi+8Xj/ZvLCrFMVTEEjCKp/bfwi9Di+O6e/npE1goHopHvOL47jY7sT9TGtJhC4KvNm/IFduMlvTXWM1wRKXwu2iLJi8BzNkHrGvQmoDazInayxgvx1uNwOEzSBGZpZC74Iw8jbEeWjMFET8PLqPxW3fycZKedXzKQ2gdB/RuWahB3FnWdvs8YkTWDxA+bhJU403ima8YuRNYGY956virDt+KmuOx8YzWZQtGUclx8ZRlbkeZYx9s1go7LR2yxsHy7Tn9bGuDeDRXdOpd1kgnDttbG1TEAzWPlC9mBH13JSnbmkjYmaASdPde0xYRQ5w+BaFZPaDJ5wp39WwoLxy2E6hpikGZzwWubdLedB5sANTqylGWhXT1wzg3+QlDu2t5PRlAHFeJmzQ587+Tr2lynGk4Gl2jva7obH4qcmRHQy7jIw/fXXT64gFvebf+sPEyADu4ITjDvk1pOuOT3fmDgZmFezp6PwwB489IcUfv9lwCFlf+IITgB56eceY0wiAw/u5s9rDg/EHbKlvxmZDKw6LOBMVtxObvfe1MFotoDSocZz7oXGkiv2Hmpn7FuA9OGf7C1hZ0kD9T/9jHsLWH3q3YQB+iweseCDPCZoAe+W/RRHYhF47bs2+PPXAgx3TX5RxfiTm0rVOFhaC2iwqL4fBuJJp49XOZikBfxOcgvpPSDE+/tLexlZCxD7fREoKuwhz/Q/U8W0WsF6Vf+oT8Lj+JqOX72MfSuQTerf2EtfxEsSP6tjHq3gvoeOYA+WiCcuHaWJCVpBc+WP7z39x3CLJZZ/mLhWsCNoajkPi8dX4oQOltYKojnywpCwc3j6JetupqAV+B5NujO+ZxOJfYrtYGStoGH1jYt02En86qEjaphWGxi9uj/eT5iEy08/KI/x2oAjndTwkjmJR3WRDOPeBoLs7EJrOLvxklHWnUxAG/hHLWz38z9hOD7lpB4magNjXeXwt3JBpO6GpXpYWhuQG9nmGCE8QU71HGhgCtpAW7m7UygTTZ65l6GKtbSBXFeexyLmIJn6fW8fo9kOLlqtjQ7EwsmwdXfh578dDEtPB2uYeHKZ73U1zKMdUBFHRkeEncZH/e7TxgTt4P1n9ZxnmBDPtF8Jv/7tYNGNh+MuglPktKIKBSytHXxz2i3wCzuIL3/zsJMpaAcOOrTWFLm9+PDHafDz1w7SPB/4+Icl4B2p44dhWh3A7OCIdZO7fXHrI7MNMF4HmL6oPKiaE4lveHy6hnHvAKtiHmZsYWJw6S4F+PPfAZa0vTz/QHyarMkKkDFxHSDIZkqbCv88rnDjxS8mtQPMPKBOpzOnyEpLLQNM0gGIreWBG8XnyO8uLZpYSwcwXnxQNSbsLF44r1wH0+oEk676BG5S8Mb3WirqY7xOoDJ+TH4+fYacLyhrZNw7wdfLiopBcjHkrSXrZExAJ9DZ+Eajmj6P62hVG2CiTiCSpYbnhkbjJ1zeyGNpnUCsRg9Vdk0iyRFzTDBJJ7Cebd5nE55AxuzNqGFknUBhS5MwPfQUuYZg99dRVyPamZhhsKvXMw0ZK8YHSuA+uxg52Iqid3+qKC9AFpsS1ux+exUyVkz+mLIy4YRs0CR56CTcd2eQi+2plHEdPjs1a9Dz2VLZ7P77SGSxLqFYUH8owh6Z50R5svvwAFmMUX/ef51IuSNH2xOt7H78OmSpPOHmf+eBmQBZYkk5sfvyQmSsgsRM7jpligb9Aw/+uz8/6CbSW7JbZd8DZD6XcGT36bOQsWR80iFm/dYiZJEFNZXdr/+OLJWjarPjow63I68woxYawX17hcHuiyNhOKTwXpHeoDWJ0A9w/94cWTyKkkzLNJ0/CVliTTx5C/fxZyNrzSbI1UkGHcuRvUcTqfFwP38zcs546nSKQ8nbEGRsDJWxCe7rxyILbShsRfBVyXlk+H7HXGH395GtHIneEV+eKb5AfjyNiJwO9/kLkCV21Hwf5bVbpcgeXGpIMNzvb0W2siI0bK0kA3Ko05NmTJ1h9/31kKWKVI/97cXZ5sj8TnzuK7j/PxmZa0DcT1g3NsMNGVOh3rE9gFXIm82JUQG7Eyv8kCWTKBu2D3AAGeNQKWP2/nSMG/Q4QkEJ9gKSka86UTHM4gXPHyJ7TSRWt7L9AOQMCyI3Y96InV+QsUbyONsTqEWWGBBy7UOOre1F5usTC9i+gNpgd6mT7Mo43rTXFFmqQljawd4AD7nYhlgzdJbwzTTkFkPqPNsfWIrsrUroru+IneuLHO1E3GB7BCHIXG3imF3W4oEjyGIlougP7BNcQs6wpjICJo76lYYsGEuEs72CbGSsBBda4lOYz4P+iacUsf0CZJEt5ds+unp+H7KHPiFKhz0DDdTF+mRP3IpJ3JbPRRboEPMMYd/AEXn2AqJmdvqwqFnITk7U397BSmQsAd+a22q9fRuyZCjhwfYPwpCFlfjDOZZtR08gixUoebaHcA1ZoE75BCSmSzOQReoEw/YR3iMnyxEBl9uzt1QhB4+kMkxgL6FtcK5F1T10/cdKCXXI+NqU9G8/AVmqSjRv7C0xHofMV6Hs2Z4CH1miQQ3r7w2evQTZx5l4J4F9BV9kLUPqaVZ0zM19/1o4cwXlyPYW4tDczZCqylm0nJ+CjL3DT7H9hXRkPoeI0fe303yHzG3BdXJgj6EK2bsdn3pn9eph7cgiJYpk+wxDmtD7UyF685THLjZClg6jDsbCXoM9spUJIX/lbX3edORkDhH/t9+AjFXhl6vX1+7eNjiXpxayPQchcrEaJfJmAtecRhZ34PfZvsMtZBGDm0dO+bL/BbKwDp/J9h4+InM7SVrReOPnGmSBCdWYCPsPf5D19Km1B0b4+Wqjzp6bKlGTAnsQFsj5fMKrWX+q41TkzWrEY7YP4YHMU6E2+/uaOW9Cxn6RM9hexF7k7iGURfqHPSFxyIJ2svZvPwJZ8gv/+Xb/oY5MZEN9Qn0z7EkUIHt04noHh1+5/ROZ/wrXZfsSvcjCZlLJ9anxBU0Z+vz2khsyYW/CHBl+vnYFVbi9mYKM3cbN2P6EB3JLB9k/IzpkvA+y8C3uxPYo9iGTvXgEbiZXHI/s/Yk8zvYpbiCrqVLan09MekYhS8XkKbZX8fFfCyu1qOYxNn4ldWg+vRn//+uOXpCreg1VkfmPSHm2Z6WPbKBDRchN1ds8Cpn/DN/G9q1skRNk+Nvn2nafJiPzX5MxbO9qOjKvGPdd0hW0biEyMKRWsf2rlchRctTpkbjG0E3I3q244W/YwxIgmw0jxt0MGvtpH3JyHSlh+1iHkfnVeN4Qny7qBHIwRv3tZV1CxhJInvPI869vIScz+J9otp+FnNdLxm77ObNVjCwuwfXdYE/rPTJXkShe4zxmajGypJdsZ/taP5DvGhHXb1WtuyZDrlWgWopgb6sPmadOzRvz1Yo3pBX9PLXiq9n+li4y1oj32Ky9U2aKTOoTn9kelw0yvxY/oNCmd3MSskSDqmP7XNOQpbW4k4P7ydMLkfkNeCDb61qFzFMkqrIDl1z1QXaSJ7Q92X4X8icrIun56UOfQpElitRJtucVixxtTPmsmbzC4ixyizZxg+17pSC7aRE/Dut2n0tFdp5NLVkDe1/PkX+aEdONrU7b5yFzh1IP2f7XJ2ThD9yB/3htjRRZXI87sT2wJmQRh/j9wSkqqwc52IiKOwb7YEqoC3xqHGF6M3jiCx1krBh3rYC9sJHIE8YSY3RDrlSMRe4eQdT8w/bDkPNGUJZ6EX0jZyLz5Ag5tie2CNlNl0rLNw08uBZZoEPoH4B9MT9kiTahKTWZoBGM3OxAuLC9sShksR7Fex6/61k8crEupVIF+2OXkNOUifMahT6xd5D3j6amlMIeWQYy7Bz3GO5xDs1FFmpRJXKwT1aEDH8eQoZtHHmmCpnbQRbYwV5ZI3KCGTU6mppb1IPM06fMn7L9MtS1njSeUr3W3DRe718LqwRUxlfYMxuF5m6jqSt1N6dm2CEnmFM+BrBvhiNLTAnL3h8+6+cgY+WkJts7W4ZczKMyoyuvOGxEzhtNON+G/bNAZG8uMbDTdIxF2KD1KSe2h3YUWTqUynYJNOInIgfNoLjJsI92A5mrTJze3kiHPUEWuhBtbC8te9AyfPS3phm/JMjJBtTzv/00ZJ4F8X6hcZWgEfm6G3U0FPbUepHLcep5sm/2aGXUWc8wJ06zfTV9ZLEpMWuWimXfGGRvXYp7C/bWHJATxhANmVGgFyBjvfgItr+2EFncRXKKbkzjeg1aldJne2xbkYU6lIXjER//YGQpj8DYPtshZP44SiH1xLdvp5C5akQQ22tLQfYwpTgZ/vUHHiALhxDfrNl+26B1qfFZBhmu+YPGiDK251aOLLAlztwpDh/XgCw1puTGwb5bDzJ3BJHlMDPMVbkTvX5lyobtvekjY71k/SJQe8AcWXkuUboQ9t8mIBdbUIZ3uzq+T0OeMZ4qOwV7cIuQcTfCT7uuQuCNnGZGVFrDPlwA8ipXQiPne5llKLLUmgpge3HHkJXHUPNVGUvlC8iNCwjLv/04ZCyH7Nh7s0/7GbIyj1Ble3JvkPMsKHD8nGhmMXLiLOIbF/blapD5RtTbhnJuSheywIDIYHtzil3/utuCGPb7Q7XNMGSMQziw/TkzZMkw6on1CJMKx0HrULpsj246srCe7D1ODmR6IntbUWcdYZ9uPfJAIHF8vPLrrEBk7mQqlO3VhSMLq/HAU5cedIiQg60plB+h/6/PQGOu4o/hyqpSudotGOfmSIyjtRXjPIFHMTR7/gWe58Fz9uaf4JGDLugevNBWEV1oO+Q/F6Tztv57O5X/3g5d+K6KLphnH7sbPvYn9NgbodXRRfaa8C/7eky4/74GG3j0gEf2fDI8XwGP7H0S2P+DR+3/BDIU/DCOLjzqoeUM9j4e6P7sPAPdR5+9D5p7w3kCmhejucF/5rv+M+9G8+H/mR9Cc/b87H+eC8MGQ0gt4H8JmBEv";
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
