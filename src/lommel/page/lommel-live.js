// Made by `make page` with ziglang==0.17.0; SHA-256 of the sources: fd27adb3df362e4315a783e86dda9e1d2682cb2ef568e01e9fd9a2e8ef515e29
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
{ name: "book", surface: book, half: [38, 66], distances: [1.62], at: () => [64, 140] },
{ name: "ball", surface: football, half: [32, 32], round: true, distances: [1.33], at: (n) => [178 + Math.round(96 * swing(n, 300)), 92] },
{ name: "card", surface: card, half: [25, 34], distances: LEVELS, at: (n) => [212 + Math.round(50 * swing(n, 420)), 176], level: (n) => Math.round(4 - 4 * Math.cos((2 * Math.PI * n) / 360)) },
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
function football(x, y) {
const [p, q] = [x / 32, y / 32];
const r = Math.sqrt(Math.max(0, 1 - p * p - q * q));
const [u, v] = [0.9 * p - 0.44 * q, 0.44 * p + 0.9 * q];
const along = PATCHES.map(([a, b, c]) => a * u + b * v + c * r).sort((one, other) => other - one);
const seam = along[0] - along[1] > 0.02 && along[1] - along[2] > 0.02 ? 1.6 : 0.7;
return (along[0] > 0.92 ? 0.2 : seam) * (0.55 + 0.5 * Math.max(0, r - 0.4 * p - 0.5 * q));
}
function card(x, y) {
const pips = [[-12, -20], [12, -20], [0, 0], [-12, 20], [12, 20]];
if (Math.abs(x) > 23 || Math.abs(y) > 32) return 0.9;
return pips.some(([a, b]) => Math.abs(x - a) / 6 + Math.abs(y - b) / 9 < 1) ? 0.35 : 1.6;
}
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
layers({ surface, half, round }, index) {
const [across, down] = half.map((size) => 2 * (size + BESIDE));
const light = this.paint(surface, across, down, 60 * (index + 1), (x, y) => covers(x, y, half, round));
return { light, cover: light.map((value) => (value ? 1 : 0)), across, down };
}
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
if (late(stated, quality)) throw new RangeError(`it would take too long: ${advice(stated, (given) => !late(given, "settled"))}`);
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
const refused = `No MTF: it would take too long: ${advice(stated, cheap, 1)}`;
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
return found.join(", or ") || "reduce the aberrations";
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
...(state.vanes ? { spider: { name: "Spider", width: float(state.vane_width), angles: vanesOf(state).map(float) } } : {}),
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
const GERMAN = {
"Point spread function, live": "Punktbild\u00adfunktion, live",
"Point spread functions, live": "Punktbildfunktionen, live",
"Point spread function": "Punktbildfunktion (PSF)",
"Drag a slider or type a number; double-click for the default. {0}": "Regler ziehen oder Zahl tippen; Doppelklick: Anfangswert. Klick auf ein Wort oder „?“: Bedeutung.",
"Presets …": "Beispiele …",
Preset: "Beispiel",
"Open …": "Öffnen …",
"A lens file (TOML) or Zernike coefficients {0}": "Eine Linsendatei (TOML) oder Zernike-Koeffizienten (CSV, TXT, INT, TOML, JSON). Oder irgendwo ablegen; sie bleibt in diesem Browser",
File: "Datei",
"Hold as A": "Als A merken",
"Keep this lens to compare others with; {0}": "Diese Linse zum Vergleich behalten; Abtastung, Fenster und Pixel sind die von B",
Compare: "Vergleich",
"How to compare": "Art des Vergleichs",
"side by side": "nebeneinander",
"in turn": "abwechselnd",
"difference, B − A": "Differenz, B − A",
"Scale of A and B": "Skala von A und B",
"one scale": "eine Skala",
"each its own scale": "je eigene Skala",
"Show A": "A zeigen",
"Show B": "B zeigen",
"Change between A and B by hand": "Von Hand zwischen A und B wechseln",
"Exchange: go back to A, and hold what is here now": "Tauschen: zurück zu A; was jetzt da ist, wird gemerkt",
Exchange: "Tauschen",
"Let go: forget A": "Loslassen: A vergessen",
"Let go": "Loslassen",
Save: "Sichern",
"Copy link": "Link",
Copied: "Kopiert",
"To copy": "Zum Kopieren",
"The clipboard is refused here; copy this:": "Die Zwischenablage ist hier gesperrt; bitte kopieren:",
"An address that restores this setting; {0}": "Eine Adresse, die diese Einstellung wiederherstellt; weder A noch ein eigenes Bild sind darin",
"Copy as Python": "Python kopieren",
"The call of lommel that makes the same array": "Der Aufruf von lommel, der dieselben Werte ergibt",
"The point spread function as it is seen": "Die Punktbildfunktion, wie man sie sieht",
"Profile, encircled energy and MTF": "Profil, eingeschlossene Energie und MTF",
"The values, float32, with their description; {0}": "Die Werte, float32, mit ihrer Beschreibung; lm.PSF.load liest sie",
"What every word means": "Was jedes Wort bedeutet",
Help: "Hilfe",
Changes: "Änderungen",
Settings: "Einstellungen",
"Undo (Ctrl+Z)": "Rückgängig (Strg+Z)",
Undo: "Rückgängig",
"Redo (Ctrl+Shift+Z)": "Wiederholen (Strg+Umschalt+Z)",
Redo: "Wiederholen",
Reset: "Zurück",
"All settings as at the start": "Alle Einstellungen wie am Anfang",
"▶ Move {0}": "▶ {0}",
"▶ Step: {0}": "▶ Schritt: {0}",
"❚❚ Pause {0}": "❚❚ {0}",
"Move {0} (Escape stops): run the slider used last through its range": "{0} bewegen (Esc hält an): der zuletzt benutzte Regler läuft durch seinen Bereich",
"Pause {0} (Escape stops): run the slider used last through its range": "{0} anhalten (Esc): der zuletzt benutzte Regler läuft durch seinen Bereich",
"Step: one step each time, since your system asks for reduced motion": "Schritt: jedes Mal ein Schritt, da Ihr System weniger Bewegung wünscht",
"Move {0}": "{0} bewegen",
"Pause {0}": "{0} anhalten",
"Step {0}": "Schritt: {0}",
"As Python": "Als Python",
Stop: "Anhalten",
"Stop computing": "Rechnung anhalten",
Compute: "Rechnen",
"Computing: {0} …": "Rechnet: {0} …",
"averages over pixels": "Mittel über Pixel",
"white light, seven wavelengths": "weißes Licht, sieben Wellenlängen",
"large aberrations": "große Aberrationen",
"Stopped: nothing is computed for this setting.": "Angehalten: für diese Einstellung ist nichts berechnet.",
"Still computing: possible when it is done.": "Rechnet noch: möglich, wenn es fertig ist.",
"Changed from: {0}": "Geändert aus: {0}",
"Left out here: {0}. All that is shown is of the rest.": "Hier weggelassen: {0}. Alles Gezeigte gilt für den Rest.",
"Left out here: {0}. All that is shown is of the rest. {1}": "Hier weggelassen: {0}. Alles Gezeigte gilt für den Rest. {1}",
"Not as in the address: {0}.": "Nicht wie in der Adresse: {0}.",
"{0} is not understood": "{0} wird nicht verstanden",
"{0} is unknown": "{0} ist unbekannt",
"This setting cannot be computed: {0}": "Diese Einstellung lässt sich nicht berechnen: {0}",
"tolerance not met": "die Toleranz ist nicht erreichbar",
"there is not enough memory for {0} MB": "der Speicher reicht nicht für {0} MB",
"the computation stopped": "die Rechnung brach ab",
"the computation was stopped": "die Rechnung wurde angehalten",
"This cannot be computed: {0}": "Das lässt sich nicht berechnen: {0}",
"This cannot be drawn: {0}": "Das lässt sich nicht zeichnen: {0}",
"The picture through A cannot be computed: {0}": "Das Bild durch A lässt sich nicht berechnen: {0}",
"it would take too long": "es würde zu lange dauern",
"choose one wavelength": "wählen Sie eine Wellenlänge",
"choose one wavelength and {0}": "wählen Sie eine Wellenlänge und {0}",
"remove the vanes": "entfernen Sie die Streben",
"remove the vanes and {0}": "entfernen Sie die Streben und {0}",
"choose “finely sampled”": "wählen Sie „fein abgetastet“",
"choose “finely sampled” and {0}": "wählen Sie „fein abgetastet“ und {0}",
"reduce the pixel to {0}": "verkleinern Sie das Pixel auf {0}",
"stop down to {0}": "blenden Sie ab auf {0}",
"set the object distance to the focus distance": "stellen Sie die Gegenstandsweite auf die Einstellentfernung",
"reduce the defocus to {0}": "verringern Sie den Defokus auf {0}",
"reduce the aberrations to {0}": "verringern Sie die Aberrationen auf {0}",
"reduce the aberrations": "verringern Sie die Aberrationen",
"reduce defocus and aberrations to {0}": "verringern Sie Defokus und Aberrationen auf {0}",
"remove the further Zernike terms": "entfernen Sie die weiteren Zernike-Terme",
"or {0}": "oder {0}",
"This cannot be saved: {0}": "Das lässt sich nicht sichern: {0}",
"nothing is computed yet": "es ist noch nichts berechnet",
"Not in the link: {0}.": "Nicht im Link: {0}.",
"The link has {0} characters: some programs cut addresses after {1}": "Der Link hat {0} Zeichen: manche Programme kürzen Adressen nach {1}",
"A lens file holds all of it": "Eine Linsendatei enthält alles",
"your own picture": "Ihr eigenes Bild",
"A was let go, for with this sampling it cannot be computed: {0}": "A wurde losgelassen, denn mit dieser Abtastung ist es nicht berechenbar: {0}",
Sampling: "Abtastung",
"finely sampled": "fein abgetastet",
"at the pixels’ centres": "in den Pixelmitten",
"averaged by pixels": "über Pixel gemittelt",
Stretch: "Helligkeitsskala",
linear: "linear",
"square root": "Wurzel",
logarithm: "Logarithmus",
Colours: "Farben",
automatic: "automatisch",
"true colour": "Echtfarben",
grey: "Grau",
"Colours from nothing to the brightest value": "Farben von nichts bis zum hellsten Wert",
"The held setting A": "Die gemerkte Einstellung A",
"of the brightest point": "des hellsten Punktes",
"of the brightest point of each": "des jeweils hellsten Punktes",
"of the brightest point of A and B, for equal light; {0}": "des hellsten Punktes von A und B, bei gleichem Licht; die Zahlen gelten je für den eigenen",
"B minus A, of the brightest point of both": "B minus A, des hellsten Punktes beider",
"electrons per pixel": "Elektronen pro Pixel",
"without noise: that is of the sensor's pixels": "ohne Rauschen: dieses haben die Pixel des Sensors",
"rays (geometrical optics)": "Strahlen (geometrische Optik)",
"beyond the window of B": "außerhalb des Fensters von B",
"computed: {0} × {1} of {2} × {3} pixels": "berechnet: {0} × {1} von {2} × {3} Pixeln",
"while it moves {0} × {1} samples": "in Bewegung {0} × {1} Werte",
"On the sensor": "Auf dem Sensor",
Picture: "Bild",
"Open a picture": "Ein Bild öffnen",
"A picture of your own; {0}": "Ein eigenes Bild; es bleibt in diesem Browser. Oder hier ablegen",
"without lens": "ohne Linse",
"through A": "durch A",
"Test picture": "Testbild",
"Siemens star": "Siemensstern",
Bars: "Balken",
Text: "Text",
"Stars at night": "Sternenhimmel",
"Own picture …": "Eigenes Bild …",
"Reduced to {0} × {1} pixels, of {2} µm each": "Verkleinert auf {0} × {1} Pixel von je {2} µm",
"{0}, blurred as a sensor with pixels of {1} micrometres records it.": "{0}, unscharf wie auf einem Sensor mit Pixeln von {1} Mikrometern.",
"{0}: not computed for this setting.": "{0}: für diese Einstellung nicht berechnet.",
"Pupil, one fringe per wave": "Pupille, ein Streifen je Wellenlänge",
"Wavefront over the pupil": "Wellenfront über der Pupille",
"no central obscuration": "ohne zentrale Abschattung",
"inner {0} of the radius obscured": "innere {0} des Radius abgeschattet",
"grey: too many fringes to draw": "grau: zu viele Streifen",
"{0} P–V, {1} rms": "{0} P–V, {1} rms",
Profile: "Profil",
"Encircled energy": "Eingeschlossene Energie",
"mean over angle": "Mittel über alle Richtungen",
"share of light": "Anteil des Lichts",
unaberrated: "ohne Aberration",
"with pixel": "mit Pixel",
limit: "Grenze",
mean: "Mittel",
light: "Licht",
"radius ({0})": "Radius ({0})",
"cycles/mm": "Perioden/mm",
"cycles/{0}": "Perioden/{0}",
"80 % about the axis: {0}": "80 % um die Achse: {0}",
"Nyquist {0} cycles/{1}: beyond the diffraction limit": "Nyquist {0} Perioden/{1}: jenseits der Beugungsgrenze",
"Nyquist {0} cycles/{1}: MTF {2}; with pixel {3}": "Nyquist {0} Perioden/{1}: MTF {2}; mit Pixel {3}",
"{0} cycles/{1}: {2}": "{0} Perioden/{1}: {2}",
"Difference, B minus A. B: {0}": "Differenz, B minus A. B: {0}",
"No MTF: {0}": "Keine MTF: {0}",
"x, y with pixel {0}": "x, y mit Pixel {0}",
"x with pixel": "x mit Pixel",
"y with pixel": "y mit Pixel",
"{0} cycles/{1}": "{0} Perioden/{1}",
"{0} waves rms": "{0} Wellenlängen rms",
"waves rms": "Wellenlängen rms",
"x with pixel {0}": "x mit Pixel {0}",
"y with pixel {0}": "y mit Pixel {0}",
"B x with pixel {0}": "B x mit Pixel {0}",
"limit {0}": "Grenze {0}",
"mean {0}": "Mittel {0}",
"light {0}": "Licht {0}",
"unaberrated {0}": "ohne Aberration {0}",
"{0} passes half its value on the axis at {1}": "{0} erreicht den halben Wert der Achse bei {1}",
"{0} passes one half at {1}": "{0} erreicht ein Halb bei {1}",
"Strehl on the axis": "Strehl auf der Achse",
"Strehl ratio: the intensity {0}": "Strehl-Zahl: die Intensität auf der Achse, geteilt durch die derselben Öffnung ohne Aberrationen.",
"Largest value": "Größter Wert",
"The brightest value of the image over the unaberrated peak. {0}": "Der hellste Wert des Bildes, geteilt durch das Maximum ohne Aberrationen. Mittel über Pixel sind kleiner als die Intensität in einem Punkt; mit „über Pixel gemittelt“ kann er also unter der Strehl-Zahl liegen.",
"80 % diameter": "80-%-Durchmesser",
"Diameter of the circle around the centroid {0}": "Durchmesser des Kreises um den Schwerpunkt des Lichts, der 80 % davon enthält, wie bei `lommel info`. Die Kurve der eingeschlossenen Energie gilt um die Achse.",
FWHM: "Halbwertsbreite",
"Full width at half maximum of the optics, {0}": "Halbwertsbreite (FWHM) der Optik, ohne Pixel: die Ausdehnung dessen, was heller ist als die Hälfte des hellsten Punktes, Mittel aus x und y, wie bei `lommel info`.",
"Light in the window": "Licht im Fenster",
"Share of all light that falls into the window, {0}": "Anteil allen Lichts, der in das Fenster fällt, gleich wie es abgetastet ist; auf weniger als die letzte Stelle genau.",
"Proven error": "Bewiesener Fehler",
"Upper bound on the error {0}": "Obere Schranke für den Fehler jedes gezeigten Wertes, geteilt durch das Maximum ohne Aberrationen: mathematisch bewiesen, nicht geschätzt.",
Time: "Zeit",
"Computing time of the last {0}": "Rechenzeit der letzten Punktbildfunktion auf diesem Rechner.",
none: "keiner",
"more than {0}": "mehr als {0}",
"as A": "wie A",
"{0} points from A": "{0} Punkte gegen A",
"{0} from A": "{0} gegen A",
"Why no error is proven": "Warum kein Fehler bewiesen ist",
"No bound is proven {0}: the page integrates along rows of the aperture. The call “As Python” states one.": "{0} ist keine Schranke bewiesen: die Seite integriert entlang von Zeilen der Öffnung. Der Aufruf „Als Python“ nennt eine.",
"with vanes": "Mit Streben",
"with aberrations this large": "Bei so großen Aberrationen",
"Point spread function over {0}: {1} of the light within {2} across; Strehl ratio on the axis {3}, brightest point {4}.": "Punktbildfunktion über {0}: {1} des Lichts in einem Kreis von {2} Durchmesser; Strehl-Zahl auf der Achse {3}, hellster Punkt {4}.",
"{0} micrometres": "{0} Mikrometer",
"{0} arcseconds": "{0} Bogensekunden",
"{0} lambda N": "{0} Lambda N",
"less than {0}": "weniger als {0}",
"x, y = {0}, {1}: {2}": "x; y = {0}; {1}: {2}",
"{0} electrons": "{0} Elektronen",
"{0} of the brightest": "{0} des hellsten",
"{0} of the unaberrated peak": "{0} des Maximums ohne Aberrationen",
"{0} of the unaberrated peak ± {1}": "{0} ± {1} des Maximums ohne Aberrationen",
"{0} of the radius": "{0} des Radius",
"no light": "kein Licht",
Wavefront: "Wellenfront",
"Lens and light": "Linse und Licht",
Sensor: "Sensor",
Focus: "Fokus",
"defocus in waves": "Defokus in Wellenlängen",
"by distances": "aus Entfernungen",
Rays: "Strahlen",
"not shown": "nicht gezeigt",
"over the image": "über dem Bild",
Noise: "Rauschen",
"photons and read noise": "Photonen und Ausleserauschen",
"at the edge, in": "am Rand, in",
"Unit of the wavefront": "Einheit der Wellenfront",
waves: "Wellen",
"{0} waves": "{0} Wellen",
"{0} wave": "{0} Welle",
"{0} nm": "{0} nm",
radians: "Radiant",
"{0} rad": "{0} rad",
nanometres: "Nanometern",
Light: "Licht",
"one wavelength": "eine Wellenlänge",
"white light": "weißes Licht",
"lengths in": "Längen in",
"Unit of lengths": "Einheit der Längen",
micrometres: "Mikrometern",
arcseconds: "Bogensekunden",
metres: "Meter",
"{0} metres": "{0} Meter",
millimetres: "Millimeter",
"{0} millimetres": "{0} Millimeter",
degrees: "Grad",
"{0} degrees": "{0} Grad",
"{0} nanometres": "{0} Nanometer",
Remove: "Entfernen",
"Further Zernike terms: {0} waves rms": "Weitere Zernike-Terme: {0} Wellenlängen rms",
"Further Zernike terms": "Weitere Zernike-Terme",
"tilt x {0}": "Kippung x {0}",
"tilt y {0}": "Kippung y {0}",
"tetrafoil {0}": "Vierblatt {0}",
"second spherical {0}": "sekundäre sphärische Aberration {0}",
"and {0} smaller": "und {0} kleinere",
"{0} Double click, or Delete, for the default": "{0} Doppelklick oder Entf: Anfangswert",
"Still {0}": "Weiterhin {0}",
Defocus: "Defokus",
"Seidel term W020 ρ², {0}": "Seidel-Term W020 ρ², in Wellenlängen am Rand der Pupille; positiv: der Sensor liegt zwischen Linse und Fokus.",
"Focused at": "Scharf bei",
"Focus distance": "Einstellentfernung",
"Distance from the lens to objects in focus, {0}": "Entfernung von der Linse zu scharf abgebildeten Gegenständen, Meter, größer als die Brennweite; inf für unendlich.",
"Object at": "Gegenstand bei",
"Object distance": "Gegenstandsweite",
"Distance from the lens to the point object, {0}": "Entfernung von der Linse zum Gegenstandspunkt, Meter, inf für unendlich; näher als die Einstellentfernung ist positiver Defokus.",
Spherical: "Sphärisch",
"Seidel term W040 ρ⁴, {0}": "Seidel-Term W040 ρ⁴ (Öffnungsfehler), in Wellenlängen am Rand der Pupille, anders als der Zernike-Term (4, 0) ohne Defokus; positiv: Randstrahlen vereinigen sich hinter den paraxialen.",
Coma: "Koma",
coma: "Koma",
"Zernike term (3, 1), {0}": "Zernike-Term (3, 1), (3ρ³ − 2ρ) cos θ, in Wellenlängen am Rand der Pupille: ein Drittel von Seidels W131; W131 = 0,75 ist hier also 0,25.",
angle: "Winkel",
width: "Breite",
"Direction of coma": "Richtung der Koma",
"Direction in which the tail of the image points, {0}": "Richtung, in die der Schweif des Bildes zeigt, Grad von rechts, im Uhrzeigersinn.",
Astigmatism: "Astigmat.",
astigmatism: "Astigmatismus",
"Zernike term (2, 2), {0}": "Zernike-Term (2, 2), ρ² cos 2θ, in Wellenlängen am Rand der Pupille: die Hälfte von Seidels W222, dessen andere Hälfte Defokus ist.",
"Direction of astigmatism": "Richtung des Astigmatismus",
"Direction in which the image is wide {0}": "Richtung, in der das Bild bei positivem Defokus breit ist, Grad von rechts, im Uhrzeigersinn.",
Trefoil: "Dreiblatt",
"Zernike term (3, 3), {0}": "Zernike-Term (3, 3), ρ³ cos 3θ, in Wellenlängen am Rand der Pupille.",
"Direction of trefoil": "Richtung des Dreiblatts",
"Direction in which the first ring {0}": "Richtung, in der der erste Ring bei kleinem Dreiblatt am hellsten ist, Grad von rechts, im Uhrzeigersinn.",
"Focal length": "Brennweite",
"Focal length of the lens, {0}": "Brennweite der Linse, Millimeter; rechnet Längen auf dem Sensor in Winkel um.",
"f-number": "Blendenzahl",
"Sensor distance divided by {0}": "Bildweite durch Durchmesser der Öffnung; bei Entfernungen Brennweite durch diesen.",
Obscuration: "Abschattung",
"of the radius": "des Radius",
"Radius of the central obscuration {0}": "Radius der zentralen Abschattung, geteilt durch den Radius der Öffnung.",
Vanes: "Streben",
"Number of vanes": "Zahl der Streben",
"Number of straight vanes {0}": "Zahl gerader Streben von der Achse zum Rand der Öffnung, unter gleichen Winkeln; eine logarithmische Skala zeigt ihre Strahlen.",
"Vane width": "Breite der Streben",
"Width of each vane {0}": "Breite jeder Strebe, geteilt durch den Radius der Öffnung.",
"Direction of the first vane": "Richtung der ersten Strebe",
"Direction of the first vane, degrees {0}": "Richtung der ersten Strebe, Grad von rechts, im Uhrzeigersinn.",
Wavelength: "Wellenlänge",
"Wavelength of the light, {0}": "Wellenlänge des Lichts, Nanometer; in weißem Licht die, bei der die Wellenfront in Wellenlängen angegeben ist.",
"Pixel of the sensor": "Pixel des Sensors",
"Pitch of the square pixels {0}": "Abstand der quadratischen Pixel des Sensors, Mikrometer.",
Window: "Fenster",
"pixels wide": "Pixel breit",
"{0} pixels wide": "{0} Pixel breit",
"Height and width of the computed image, pixels.": "Höhe und Breite des berechneten Bildes, Pixel.",
Photons: "Photonen",
electrons: "Elektronen",
"Expected number of detected photons: {0}": "Erwartete Zahl nachgewiesener Photonen: der ganzen PSF, und in einem weißen Pixel des Bildes.",
"Read noise": "Ausleserauschen",
"electrons rms": "Elektronen rms",
"{0} electrons rms": "{0} Elektronen rms",
"Standard deviation of the read noise {0}": "Standardabweichung des Ausleserauschens jedes Pixels, Elektronen.",
"Input of defocus: {0}": "Eingabe des Defokus: in Wellenlängen, oder durch Brennweite, Blendenzahl, Einstellentfernung und Gegenstandsweite.",
"Zernike terms without a slider, {0}": "Zernike-Terme ohne Regler, aus einer geöffneten Datei oder der Adresse (zernike=4,2:0.05;6,0:-0.01): n,m:Wellenlängen rms.",
"One wavelength, or seven lines {0}": "Eine Wellenlänge, oder sieben Linien gleicher Energie, 450 bis 650 nm, mit denselben optischen Wegen.",
"A fine grid over the whole image, {0}": "Ein feines Gitter über das ganze Bild, oder die Pixel des Sensors: Werte in ihren Mitten, oder Mittel.",
"Photon noise and read noise {0}": "Photonenrauschen und Ausleserauschen des Sensors in den gezeigten Bildern.",
"Points where rays through the pupil {0}": "Punkte, in denen Strahlen durch die Pupille den Sensor treffen, ohne Beugung.",
"Brightness scale of the PSF: {0}": "Helligkeitsskala der PSF: Wurzel, linear oder logarithmisch.",
"Colours of the PSF; automatic: {0}": "Farben der PSF; automatisch: Echtfarben in weißem Licht, inferno bei einer Wellenlänge.",
"Unit of the wavefront: {0}": "Einheit der Wellenfront: Wellenlängen, Radiant oder Nanometer des Weges.",
"Unit of lengths on the sensor: {0}": "Einheit der Längen auf dem Sensor: Mikrometer, Bogensekunden, Wellenlänge mal Blendenzahl.",
"Picture that the sensor records through the lens.": "Bild, das der Sensor durch die Linse aufnimmt.",
"Notes on wavefronts": "Zur Wellenfront",
Numbers: "Zahlen",
"Pictures and curves": "Bilder und Kurven",
Choices: "Auswahl",
"Image of a point of light on the sensor. {0}": "Bild eines Lichtpunktes auf dem Sensor. Sein hellster Wert hat die letzte Farbe des Balkens.",
"Intensity over the distance from the axis, {0}": "Intensität über dem Abstand von der Achse, gemittelt über alle Richtungen, als Anteil des Maximums ohne Aberrationen.",
"Share of the light within a circle {0}": "Anteil des Lichts in einem Kreis um die Achse, über dessen Radius.",
"Modulation transfer function: {0}": "Modulationsübertragungsfunktion: Kontrast eines Sinusmusters im Bild, über dessen Frequenz, längs x und längs y.",
"A picture as the pixels of the sensor {0}": "Ein Bild, wie es die Pixel des Sensors durch diese Linse aufnehmen.",
"Optical path difference over the pupil, {0}": "Optischer Wegunterschied über der Pupille, rot über, blau unter null: P–V vom tiefsten zum höchsten, rms um das Mittel.",
"Interferogram of the pupil: {0}": "Interferogramm der Pupille: von einem hellen Streifen zum nächsten ändert sich die Wellenfront um eine Wellenlänge.",
"At the edge": "Am Rand",
"Coefficients are given at the edge {0}": "Koeffizienten gelten am Rand der Pupille (Radius 1), in Wellenlängen. Defokus und sphärische Aberration sind die Seidel-Koeffizienten W020 und W040, von ρ² und ρ⁴. Koma, Astigmatismus und Dreiblatt sind die Zernike-Terme (3, 1), (2, 2) und (3, 3), die am Rand 1 sind. Der Zernike-Term (4, 0), 6ρ⁴ − 6ρ² + 1, enthält Defokus: eine Wellenlänge davon ist W040 = 6 und W020 = −6.",
Signs: "Vorzeichen",
"Positive defocus: the sensor lies between {0}": "Positiver Defokus: der Sensor liegt zwischen Linse und Fokus. Man sieht das Bild wie auf dem Sensor, x nach rechts, y nach unten.",
"A lens without aberration": "Linse ohne Aberration",
"35 mm f/2 camera lens at full aperture, over a full-frame sensor": "Kameraobjektiv 35 mm f/2 bei voller Öffnung, über einem Vollformatsensor",
"85 mm f/1.4 portrait lens": "Porträtobjektiv 85 mm f/1,4",
"Hubble Space Telescope before its 1993 repair, at its best focus": "Hubble-Weltraumteleskop vor der Reparatur 1993, im besten Fokus",
"20x/0.75 microscope objective, quarter wave of spherical aberration": "Mikroskopobjektiv 20x/0,75, eine Viertelwelle sphärische Aberration",
"200 mm f/4 Newtonian telescope, a star 0.25 degrees off the axis": "Newton-Teleskop 200 mm f/4, ein Stern 0,25 Grad neben der Achse",
"50 mm f/1.8 camera lens": "Kameraobjektiv 50 mm f/1,8",
"Phone camera, 3.99 mm f/1.8": "Telefonkamera, 3,99 mm f/1,8",
"linear scale": "lineare Skala",
"square-root scale": "Wurzelskala",
"logarithmic scale": "logarithmische Skala",
"Strehl ratio on the axis {0}": "Strehl-Zahl auf der Achse {0}",
"80 % of the light within {0}": "80 % des Lichts in {0}",
"defocus {0}": "Defokus {0}",
"spherical {0}": "sphärische Aberration {0}",
"coma {0}": "Koma {0}",
"astigmatism {0}": "Astigmatismus {0}",
"trefoil {0}": "Dreiblatt {0}",
"direction of coma {0}": "Richtung der Koma {0}",
"direction of astigmatism {0}": "Richtung des Astigmatismus {0}",
"direction of trefoil {0}": "Richtung des Dreiblatts {0}",
"obscuration {0}": "zentrale Abschattung {0}",
"pixel of the sensor {0}": "Pixel des Sensors {0}",
"number of vanes {0}": "Zahl der Streben {0}",
"vane width {0}": "Breite der Streben {0}",
"direction of the first vane {0}": "Richtung der ersten Strebe {0}",
"focal length {0}": "Brennweite {0}",
"photons {0}": "Photonen {0}",
"read noise {0}": "Ausleserauschen {0}",
"A: {0}. B: {1}. Both: {2}": "A: {0}. B: {1}. Beide: {2}",
"no other": "nichts weiter",
"focus distance {0}": "Einstellentfernung {0}",
"object distance {0}": "Gegenstandsweite {0}",
"{0} is {1} to {2}": "{0} geht von {1} bis {2}",
"{0} is a whole number, {1} to {2}": "{0} ist eine ganze Zahl von {1} bis {2}",
"∞ (or inf) {0}": "∞ (oder inf) {0}",
"for the other sign turn its angle by {0}°": "für das andere Vorzeichen den Winkel um {0}° drehen",
"{0} is {1} to {2}, so {3} is shown instead of {4}": "{0!} geht von {1} bis {2}; gezeigt ist {3} statt {4!}",
"of its {0} characters the first {1} are read": "von {0} Zeichen werden die ersten {1} gelesen",
"and {0} more": "und {0} weitere",
"the focus distance must exceed the focal length of {0} mm, and is {1} m": "die Einstellentfernung muss größer sein als die Brennweite von {0} mm, und ist {1} m",
"the computation stopped for want of memory ({0})": "die Rechnung endete aus Mangel an Speicher ({0})",
"{0} is not a picture that the browser reads": "{0!} ist kein Bild, das der Browser liest",
"line {0}": "Zeile {0}",
"{0} (line {1})": "{0!} (Zeile {1})",
"must be {0}, got {1}": "muss {0} sein, nicht {1!}",
"a number": "eine Zahl",
"a positive number": "eine positive Zahl",
"a finite number": "eine endliche Zahl",
"a finite length": "eine endliche Länge",
"a positive length": "eine positive Länge",
"a whole number from {0} to {1}": "eine ganze Zahl von {0} bis {1}",
"a list of {0} to {1}": "eine Liste von {0} bis {1}",
"one of {0}": "eines von {0!}",
"a text in quotes": "ein Text in Anführungszeichen",
"true or false": "true oder false",
"from {0} to {1}": "von {0} bis {1}",
"from {0} to {1} on this page": "auf dieser Seite von {0} bis {1}",
"from {0} to below {1}": "von {0} bis unter {1}",
"at most {0}": "höchstens {0}",
"at least 0.5, the limit in air": "mindestens 0,5 (die Grenze in Luft)",
"an angle, a number of radians or a text such as {0}": "ein Winkel, eine Zahl in Radiant oder ein Text wie {0!}",
"within two turns, in radians or a text such as {0}": "innerhalb von zwei Umdrehungen, in Radiant oder ein Text wie {0!},",
"one length on this page, whose pixels are square": "auf dieser Seite eine Länge (ihre Pixel sind quadratisch)",
"1 on this page, whose pixels are active all over": "auf dieser Seite 1 (ihre Pixel sind ganz aktiv)",
"a length with a unit, such as {0}": "eine Länge mit Einheit wie {0!}",
"a wavelength from 1e-12 m to 1e-2 m": "eine Wellenlänge von 1e-12 m bis 1e-2 m",
"must have a unit, one of {0}, got {1}": "braucht eine Einheit, eine von {0!}, nicht {1!}",
"{0} must be {1} on this page, got {2}": "{0} muss auf dieser Seite {1} sein, nicht {2!}",
"unknown key": "unbekannter Schlüssel",
"it is in {0}": "er gehört in {0}",
"there are {0}": "es gibt {0!}",
"there are order, unit, normalization, wavelength and terms": "es gibt order, unit, normalization, wavelength und terms",
"must be a section": "muss ein Abschnitt sein",
"is missing": "fehlt",
"width is missing": "width fehlt",
"it is one of {0}": "möglich sind {0!}",
"is missing or empty": "fehlt oder ist leer",
"it has the coefficients by index": "er hat die Koeffizienten nach ihrem Index",
"needs vanes or angles": "braucht vanes oder angles",
"one of the two": "eines von beiden",
"give exactly one of {0} and {1}": "genau eines von {0!} und {1!} angeben",
"give at most one of {0} and {1}": "höchstens eines von {0!} und {1!} angeben",
"must exceed the focal length": "muss größer sein als die Brennweite",
"must be below the diameter of the aperture": "muss kleiner sein als der Durchmesser der Öffnung",
"aplanatic is not possible with this aperture and these distances": "aplanatic ist mit dieser Öffnung und diesen Entfernungen nicht möglich",
"the sensor lies inside the focal plane, and no object is in focus": "der Sensor liegt vor der Brennebene, und kein Gegenstand ist scharf",
"has no sections": "hat keine Abschnitte",
"expected are {0}, each on a line of its own before its keys, such as {1} above {2}": "erwartet sind {0}, jeder in einer eigenen Zeile vor seinen Schlüsseln, so {1!} über {2!}",
"[lens] and [sensor]": "[lens] und [sensor]",
"describes a microscope, [objective]": "beschreibt ein Mikroskop, [objective]",
"this page takes lenses, [lens]": "diese Seite nimmt Linsen, [lens]",
"must hold an object": "muss ein Objekt enthalten",
"{0} has {1} bytes": "{0!} hat {1} Bytes",
"has {0} characters": "hat {0} Zeichen",
"the limit is {0}": "die Grenze ist {0}",
"must end in {0}": "muss auf {0!} enden",
"a lens file or a Zernike table": "eine Linsendatei oder eine Zernike-Tabelle",
"the Zernike table {0}, which can be opened after this file": "die Zernike-Tabelle {0!}, die nach dieser Datei geöffnet werden kann",
"the spider": "die Streben",
"the vignetting": "die Vignettierung",
"the stop": "die Blende",
"the mask": "die Maske",
"the apodization": "die Apodisation",
"colour aberrations": "Farbfehler",
"aberrations of the field": "Bildfeldfehler",
"further Zernike terms": "weitere Zernike-Terme",
"there is no Zernike term {0} in the order {1}": "es gibt keinen Zernike-Term {0!} in der Ordnung {1}",
"it is written {0}": "man schreibt ihn {0!}",
"it is a whole number from {0}": "er ist eine ganze Zahl ab {0}",
"it ends with {0}": "sie endet mit {0}",
"m must be from -n to n, and n - m even": "m muss von -n bis n gehen, und n - m gerade sein",
"n must be at most {0}": "n darf höchstens {0} sein",
"the term {0} is given twice": "der Term {0} ist doppelt angegeben",
"the term {0}": "der Term {0}",
"the term {0} has no value (NDA)": "der Term {0} hat keinen Wert (NDA)",
"the columns say the {0} {1}, line {2} {3}": "die Spalten nennen für {0!} {1!}, Zeile {2} {3!}",
"the columns must be \"n,m,value\" or \"index,value\", got {0}": "die Spalten müssen \"n,m,value\" oder \"index,value\" sein, nicht {0!}",
"must have {0} cells, got {1}": "muss {0} Zellen haben, nicht {1}",
"the line {0}: is missing": "die Zeile {0!} fehlt",
"{0}: the line {1}: is missing": "{0!}: die Zeile {1!} fehlt",
"the terms must be Standard or Fringe, which the line 'Listing of Zernike ...' states": "die Terme müssen Standard oder Fringe sein, was die Zeile 'Listing of Zernike ...' angibt",
"annular terms are not read here": "ringförmige Terme werden hier nicht gelesen",
"lommel.load_zernike reads them, and saves them as a table": "lommel.load_zernike liest sie und sichert sie als Tabelle",
"the unit is not stated": "die Einheit ist nicht angegeben",
"listings have 'Peak to Valley ... waves'": "Listen haben 'Peak to Valley ... waves'",
"a term must have a number and a value, got {0}": "ein Term braucht eine Nummer und einen Wert, nicht {0!}",
"the term {0} is missing, got {1}": "der Term {0} fehlt, es folgt {1}",
"a listing has all terms from 1": "eine Liste hat alle Terme ab 1",
"the term {0} is cut off, without the formula that the others have": "der Term {0} ist abgeschnitten, ohne die Formel, die die anderen haben",
"the second line must begin with ZRN or ZFR and have WFR": "die zweite Zeile muss mit ZRN oder ZFR beginnen und WFR haben",
"Zernike terms of a wavefront": "Zernike-Terme einer Wellenfront",
"the second line must have WVL and SSZ, the wavelength in um and the value of one wave": "die zweite Zeile muss WVL und SSZ haben, die Wellenlänge in um und den Wert einer Wellenlänge",
"the second line says {0} values, got {1}": "die zweite Zeile nennt {0} Werte, nicht {1}",
"{0} is missing before {1}": "{0!} fehlt vor {1!}",
"a key is missing before {0}": "ein Schlüssel fehlt vor {0!}",
"a comma or {0} is missing before {1}": "ein Komma oder {0!} fehlt vor {1!}",
"a text has no closing quote": "ein Text endet ohne Anführungszeichen",
"{0} is not an escape of TOML": "{0!} ist keine Escape-Folge von TOML",
"{0} is given twice": "{0!} ist doppelt angegeben",
"the table {0} is given twice": "die Tabelle {0!} ist doppelt angegeben",
"{0} has a value and is no table": "{0!} hat einen Wert und ist keine Tabelle",
"{0} has a value and is no array of tables": "{0!} hat einen Wert und ist keine Liste von Tabellen",
"{0} adds to a table that is complete": "{0!} ergänzt eine Tabelle, die schon vollständig ist",
"brackets are nested too deeply": "Klammern sind zu tief verschachtelt",
"{0} is not a text in quotes, a decimal number, true, false, a list or a table": "{0!} ist weder Text in Anführungszeichen noch Dezimalzahl, true, false, Liste oder Tabelle",
"only one entry may stand in a line, got {0} behind it": "in einer Zeile steht nur ein Eintrag, nicht {0!} dahinter",
"Illustrative: Seidel coefficients {0}": "Zur Anschauung: Seidel-Koeffizienten, wie sie ein klassisches lichtstarkes Doppel-Gauß-Objektiv hat, nicht die eines gebauten.",
"Nominal figures of the 85 mm f/1.4 class; {0}": "Nennwerte der Klasse 85 mm f/1,4; Farbfehler wie bei einem Achromaten mit einem sekundären Spektrum von f/2000.",
"2.4 m aperture, f/24, obscuration 0.33: STScI, Hubble Space Telescope Primer. Spherical aberration {0}": "2,4 m Öffnung, f/24, Abschattung 0,33: STScI, Hubble Space Telescope Primer. Sphärische Aberration von etwa 0,265 µm rms: C. J. Burrows et al., Astrophys. J. 369, L21 (1991), doi:10.1086/185950.",
"Magnification and aperture as of {0}": "Vergrößerung und Öffnung wie beim Nikon CFI Plan Apochromat 20x/0,75 (Tubuslinse 200 mm); Kamera mit Pixeln von 6,5 µm. Die Aberration ist die eines Deckglases, dessen Dicke um einige hundertstel Millimeter abweicht.",
"Invented telescope. Its coma {0}": "Erfundenes Teleskop. Koma und Astigmatismus sind die eines Paraboloids mit der Blende am Spiegel, W131 = a theta / (16 N^2) und W222 = -a^2 theta^2 / (2 f): D. J. Schroeder, Astronomical Optics, 2. Aufl. (2000), Kapitel 6. Streben und Formfehler des Spiegels sind erfunden, in einer für Amateurspiegel üblichen Größe.",
"Nominal figures of the 50 mm f/1.8 class; {0}": "Nennwerte der Klasse 50 mm f/1,8; das Pixel ist das des Sensors Sony IMX250.",
"Focal length and f-number as in the EXIF data {0}": "Brennweite und Blendenzahl wie in den EXIF-Daten der Hauptkamera des Apple iPhone 8; ihre Pixel haben 1,22 µm.",
"Lessons …": "Lektionen …",
Lessons: "Lektionen",
Lesson: "Lektion",
"Previous lesson": "Vorige Lektion",
"Next lesson": "Nächste Lektion",
"Close the lesson": "Lektion schließen",
"Show everything": "Alles zeigen",
Answer: "Antwort",
"Source: {0}": "Quelle: {0}",
"(done)": "(erledigt)",
"{0} of {1}: {2}": "{0} von {1}: {2}",
"Airy pattern": "Airy-Muster",
"Rayleigh’s quarter wave": "Rayleighs Viertelwelle",
"The zero on the axis": "Die Nullstelle auf der Achse",
"Contrast reversal": "Kontrastumkehr",
"Hubble, 1990": "Hubble, 1990",
"Coma against astigmatism": "Koma oder Astigmatismus",
"Depth from two pictures": "Tiefe aus zwei Bildern",
"A lens without aberration images a star {0}": "Eine Linse ohne Aberration bildet einen Stern nicht als Punkt ab, sondern als helles Scheibchen mit dunklen Ringen: Licht aus allen Teilen ihrer runden Öffnung interferiert (Beugung). Längen sind in λN angegeben, Wellenlänge mal Blendenzahl.",
"Above the picture, set “square root” to {0}": "Stellen Sie über dem Bild „Wurzel“ auf „Logarithmus“ und zählen Sie die Ringe. Zeigen Sie auf das Profil: wo ist die erste Nullstelle?",
"Set lengths to micrometres and drag {0}": "Stellen Sie die Längen auf Mikrometer und ziehen Sie die Blendenzahl über 8. Das Fenster folgt dem Muster: achten Sie auf den Maßstab, nicht auf die Größe des Scheibchens.",
"Drag the obscuration to 0.33, {0}": "Ziehen Sie die zentrale Abschattung auf 0,33, wie bei einem Spiegelteleskop. Was geschieht mit Scheibchen und Ringen?",
"How wide is the first dark ring {0}": "Wie groß ist der erste dunkle Ring bei f/4 und 550 nm? Hängt der Anteil des Lichts außerhalb von der Blendenzahl ab?",
"The diameter is 2.44 λN, {0}": "Der Durchmesser ist 2,44 λN, hier 5,4 µm. Der Ring umschließt 83,8 % des Lichts; 16,2 % liegen außerhalb, bei jeder Blendenzahl und Wellenlänge, denn diese ändern nur den Maßstab des Musters. Mit einer Abschattung von 0,33 ist der erste dunkle Ring kleiner, bei 1,10 λN, umschließt aber nur 65,4 %: ein schmaleres Scheibchen, hellere Ringe, weniger Kontrast.",
"How good is good enough? {0}": "Wie gut ist gut genug? Die Strehl-Zahl ist die Intensität auf der Achse, geteilt durch die einer vollkommenen Linse. Rayleighs Regel: eine Wellenfront, die um höchstens eine Viertelwelle von einer Kugel abweicht, gibt ein kaum schlechteres Bild als eine vollkommene.",
"Drag defocus (arrow keys {0}": "Ziehen Sie den Defokus (fein mit den Pfeiltasten), bis die Strehl-Zahl 0,8 ist. Wie viele Wellenlängen sind das?",
"Set defocus to 0, and drag spherical {0}": "Stellen Sie den Defokus auf 0 und ziehen Sie die sphärische Aberration, bis die Strehl-Zahl wieder 0,8 ist.",
"Set spherical to 1 wave. {0}": "Stellen Sie die sphärische Aberration auf 1 Wellenlänge. Ziehen Sie nun den Defokus dorthin, wo die Strehl-Zahl am größten ist.",
"Read P–V below the wavefront: {0}": "Lesen Sie P–V unter der Wellenfront ab: warum lässt die vierfache sphärische Aberration dieselbe Strehl-Zahl übrig?",
"With −1 wave of defocus the wavefront {0}": "Mit −1 Wellenlänge Defokus ist die Wellenfront ρ⁴ − ρ²: sie bleibt wieder innerhalb einer Viertelwelle, und ihr rms σ ist 0,075 Wellenlängen, also 1/13,4; Maréchals Näherung gibt S = 0,803, genau ist es 0,800. Eine Viertelwelle Defokus lässt 0,811 übrig, eine von sphärischer Aberration allein 0,800. Auf dem Sensor ist eine Viertelwelle Defokus eine Verschiebung um 2 λN²; die Schärfentiefe im Bildraum ist hier also ±18 µm, zu beiden Seiten des Fokus.",
"Out of focus, rays fill a disk evenly, {0}": "Außerhalb des Fokus füllen Strahlen einen Zerstreuungskreis gleichmäßig, auch seine Mitte. Doch bei einer Wellenlänge Defokus ist die Achse dunkel.",
"Drag defocus from 0 to 1 wave. {0}": "Ziehen Sie den Defokus von 0 auf 1 Wellenlänge. Achten Sie auf die Bildmitte und die Strehl-Zahl.",
"Go on to 2 waves: {0}": "Weiter bis 2 Wellenlängen: die Mitte wird hell, dann wieder dunkel.",
"Go back to 1 wave and drag {0}": "Gehen Sie auf 1 Wellenlänge zurück und ziehen Sie die Abschattung auf 0,5: die Mitte ist hell. Bei welchem Defokus ist sie jetzt dunkel?",
"No ray is missing on the axis. {0}": "Auf der Achse fehlt kein Strahl. Warum ist sie dunkel, und warum verschiebt eine zentrale Abschattung die Nullstellen?",
"Defocus is W₀₂₀ρ², and rings {0}": "Defokus ist W₀₂₀ρ², und Ringe gleicher Breite in ρ² haben gleiche Fläche: über eine Wellenlänge kommt jede Phase gleich oft vor, und alle Beiträge heben sich auf. (Die Pupille enthält zwei Fresnel-Zonen.) Dasselbe geschieht bei 2, 3, … Wellenlängen; dazwischen, bei 1,5, ist die Strehl-Zahl 0,045. Hinter einer Abschattung ε = 0,5 durchläuft die Phase nur 1 − ε² = 0,75 des Defokus; die erste Nullstelle liegt also bei 1/0,75 = 1,33 Wellenlängen; bei 1 Wellenlänge ist die Strehl-Zahl 0,090. Das Licht ist nicht verloren: es ist in den Ringen.",
"In focus, a Siemens star is grey {0}": "Im Fokus ist ein Siemensstern nur nahe der Mitte grau, wo die Speichen zu fein sind. Außerhalb hat er graue Ringe, und weiter innen erscheinen die Speichen wieder, Schwarz und Weiß vertauscht. Die MTF zeigt, wie viel Kontrast bleibt, nicht sein Vorzeichen.",
"Drag defocus to 2 waves and follow {0}": "Ziehen Sie den Defokus auf 2 Wellenlängen und folgen Sie einer weißen Speiche des Sterns nach innen, durch den ersten grauen Ring.",
"Set lengths to λN and point at the MTF: {0}": "Stellen Sie die Längen auf λN und zeigen Sie auf die MTF: wo sind ihre ersten Minima? Es sind Nullstellen: graue Ringe. Marken auf dem Stern geben die Frequenz an, die nach innen steigt.",
"Drag defocus to 3 waves. {0}": "Ziehen Sie den Defokus auf 3 Wellenlängen. Wohin wandern die grauen Ringe?",
"Between the first two grey rings {0}": "Zwischen den ersten zwei grauen Ringen lassen sich die Speichen zählen. Hat die Linse sie aufgelöst?",
"Not truly: the transfer function {0}": "Nicht wirklich: die Übertragungsfunktion (OTF) ist dort negativ, und weiße Speichen erscheinen schwarz: Scheinauflösung. Mit 2 Wellenlängen wechselt das Vorzeichen bei ν = 0,084 und 0,167 Perioden/λN, hier 38 und 76 Perioden/mm. Die Formel, die der Strahlen, ist null bei a = 3,83: sie gibt 0,076 für 2 Wellenlängen und 0,051 für 3, wo Wellen 0,054 geben. Zwischen den ersten zwei Nullstellen erreicht der umgekehrte Kontrast bei 2 Wellenlängen 11 %. Kein Schärfen, das vom Vorzeichen absieht, stellt ein solches Bild wieder her.",
"The mirror of the Hubble Space Telescope {0}": "Der Spiegel des Hubble-Weltraumteleskops war falsch geschliffen: 8 Wellenlängen sphärische Aberration. Vom Boden aus ließ sich nur der Fokus ändern. Hier beginnt er dort, wo das meiste Licht in einen Radius von 0,1″ fällt.",
"Point at the curve of encircled energy: {0}": "Zeigen Sie auf die Kurve der eingeschlossenen Energie: welcher Anteil des Lichts liegt in einem Radius von 0,1″?",
"Drag defocus from −1 to −10. {0}": "Ziehen Sie den Defokus von −1 bis −10. Bekommen Sie mehr Licht in diesen Radius, oder eine Strehl-Zahl von 0,2?",
"Set spherical and defocus to 0: {0}": "Stellen Sie sphärische Aberration und Defokus auf 0: der Spiegel wie entworfen, und die Wirkung der Korrekturoptik von 1993.",
"Why could no focus repair the image?": "Warum konnte kein Fokus das Bild reparieren?",
"A term in ρ² cannot cancel {0}": "Ein Term in ρ² kann keinen in ρ⁴ aufheben. Der kleinste rms-Wellenfrontfehler, bei −9,0 Wellenlängen Defokus, ist noch σ = 0,48 Wellenlängen; für eine Strehl-Zahl von 0,8 braucht es 0,075. Der Fokus tauscht nur: bestenfalls 16 % des Lichts liegen in einem Radius von 0,1″, wie entworfen 89 %. Etwas Licht bildet immer einen scharfen Kern; darum ließen sich helle Sterne noch messen und Bilder entfalten. 1993 wurden Spiegel mit dem entgegengesetzten Fehler eingebaut.",
"Off the axis, stars become {0}": "Abseits der Achse werden Sterne zu Kometen oder kurzen Strichen. Ein einziges Bild kann täuschen; erst der Gang durch den Fokus unterscheidet beide.",
"Drag defocus from −1 to 1: {0}": "Ziehen Sie den Defokus von −1 bis 1: wie unterscheiden sich die zwei Seiten des Fokus?",
"Set coma to 0, astigmatism to 0.6, {0}": "Stellen Sie Koma auf 0, Astigmatismus auf 0,6, und ziehen Sie den Defokus wieder von −1 bis 1. Wo ist der Stern ein Strich?",
"Mix them: coma 0.4, {0}": "Mischen Sie: Koma 0,4, Astigmatismus 0,4. Ziehen Sie den Defokus: welche von beiden sehen Sie wo?",
"A star in your telescope is elongated. {0}": "Ein Stern in Ihrem Teleskop ist länglich. Wie finden Sie heraus, ob durch Koma oder durch Astigmatismus?",
"Focus in and out. {0}": "Stellen Sie vor und hinter den Fokus. Bei Koma sind beide Seiten gleich, und der Schweif zeigt in jedem Fokus in eine Richtung: eine Wellenfront, die bei Drehung um 180° das Vorzeichen wechselt, hat dieselbe PSF für +d und −d Wellenlängen Defokus. Bei Astigmatismus dreht sich der Strich um 90°; am schärfsten sind die Striche bei einem Defokus von plus und minus dem Koeffizienten. In der Mitte füllen Strahlen einen Kreis, den Kreis kleinster Verwirrung; Wellen so kleiner Aberration bilden dort ein Kreuz. Eine Strehl-Zahl von 0,8 lassen 0,21 Wellenlängen Koma oder 0,18 Wellenlängen Astigmatismus übrig (Zernike-Terme, am Rand der Pupille).",
"A lens blurs what is out of focus, {0}": "Eine Linse macht unscharf, was außerhalb des Fokus liegt, je nach Entfernung verschieden stark. Ein unscharfes Bild verrät die Entfernung nicht, denn der Gegenstand selbst kann glatt sein. Zwei Bilder mit verschiedenem Fokus verraten sie: das Verhältnis ihrer Kontraste hängt von der Entfernung ab, nicht von der Textur. Hier sieht man eine Wand mit Bild, ein Buch, einen Ball und eine bewegte Karte durch ein Objektiv von 35 mm, mit dem Rauschen des Lichts.",
"Point at the card in the map of depth, {0}": "Zeigen Sie in der Tiefenkarte auf die Karte, oder gehen Sie mit den Pfeiltasten dorthin. Liegt die wahre Entfernung innerhalb des Standardfehlers, der Zahl nach ±? Das sollte in zwei von drei Fällen so sein.",
"Set the f-number to 5.6, then to 16. {0}": "Stellen Sie die Blendenzahl auf 5,6, dann auf 16. Was geschieht mit dem Standardfehler?",
"Reduce the light to 300 electrons per pixel. {0}": "Verringern Sie das Licht auf 300 Elektronen pro Pixel. Wo geht die Tiefe zuerst verloren?",
"Exchange the two pictures. Depth is wrong now: {0}": "Vertauschen Sie die zwei Bilder. Die Tiefe ist nun falsch: sagt das die Abweichung?",
"At which distances is depth most exact, {0}": "Bei welchen Entfernungen ist die Tiefe am genauesten, und was kann kein Bildpaar verraten?",
"Between the two foci, where one picture {0}": "Zwischen den beiden Fokuslagen, wo ein Bild schärfer wird, während das andere verschwimmt. In einem Fokus ändert sich der Kontrast kaum mit der Entfernung, so dass nur das andere Bild etwas aussagt, und jenseits beider verschwimmen beide gleich: bei f/8 und 3000 Elektronen ist der Standardfehler 5 mm bei 1,5 m, aber 13 mm bei 1,8 m und 17 mm bei 1,9 m. Er wächst mit dem Rauschen, und wo Textur darin untergeht, ist die Tiefe unbekannt. Kein Paar verrät, welches Bild näher fokussiert ist: vertauschte passen ebenso gut, Abweichung etwa 1, mit um etwa 1,54 m gespiegelten Entfernungen. Auch nicht den Maßstab, der aus Blendenzahl, Brennweite und Pixeln folgt, wie sie angegeben sind. Eine Ebene bekannter Entfernung prüft beides.",
Pictures: "Bilder",
"Two pictures (computed clip)": "Zwei Bilder (berechnete Szene)",
"Camera, one picture": "Kamera, ein Bild",
Pause: "Pause",
Play: "Abspielen",
"Exchange the two pictures": "Die zwei Bilder vertauschen",
"f-number (defocus)": "Blendenzahl (Defokus)",
"Light (noise)": "Licht (Rauschen)",
"Radius of the blur": "Radius der Unschärfe",
"{0} pixels": "{0} Pixel",
First: "Erstes Bild",
Second: "Zweites Bild",
"First picture": "Erstes Bild",
"Second picture": "Zweites Bild",
Depth: "Tiefe",
"Sharp picture of both": "Scharfes Bild aus beiden",
"As taken": "Wie aufgenommen",
Sharpened: "Geschärft",
"focused at {0}": "scharf bei {0}",
"stated focus {0}": "angegebener Fokus {0}",
"grey: not known": "grau: unbekannt",
"Colours of distances from {0} to {1}; grey: not known": "Farben der Entfernungen von {0} bis {1}; grau: unbekannt",
"Rendering the scene at {0} …": "Die Szene bei {0} wird berechnet …",
"{0} frames/s": "{0} Bilder/s",
"depth known at {0} %": "Tiefe bekannt bei {0} %",
"misfit {0}": "Abweichung {0}",
"depth and sharp picture take {0} ms": "Tiefe und scharfes Bild dauern {0} ms",
"sharpened in {0} ms": "geschärft in {0} ms",
"brightness only": "nur die Helligkeit",
"true {0}": "wahr {0}",
"found {0}": "gefunden {0}",
"not known": "unbekannt",
"No picture leaves this page: frames are filtered here and forgotten.": "Kein Bild verlässt diese Seite: Bilder werden hier gefiltert und vergessen.",
"The browser asks for the camera": "Der Browser fragt nach der Kamera",
"The browser was not allowed to use a camera. {0}": "Der Browser durfte keine Kamera benutzen. Erlauben Sie es für diese Seite, neben der Adresse, und wählen Sie sie noch einmal.",
"There is no camera here.": "Hier ist keine Kamera.",
"The camera is in use by another program.": "Ein anderes Programm benutzt die Kamera.",
"There is no picture of a camera: {0}": "Es gibt kein Kamerabild: {0}",
"The browser gives the camera only to pages {0}": "Der Browser gibt die Kamera nur Seiten über https oder von diesem Rechner.",
};
const ATTRIBUTES = ["title", "aria-label", "aria-valuetext"];
const SEPARATORS = [/(?<=[^.]\.) (?=\p{Lu})/u, "; ", " — ", ": ", ", "];
let german = isIt(globalThis.navigator?.language);
const known = new Map(); // what was looked up
const written = new WeakMap(); // node -> {attribute or "data": [English, as shown]}
const followed = new Map(); // root -> what to call when the language changes
const plain = (text) => text.replace(/\s+/g, " ").trim();
const own = (key) => key.replace(/\{\d\}/g, "").length;
const patterns = Object.keys(GERMAN)
.filter((key) => key.includes("{0}"))
.sort((a, b) => own(b) - own(a))
.map((key) => {
const number = /^\{0\} [^\s{]+$/.test(key) && "([-−\\d.e∞<> ]*[\\d∞])"; // before a unit
const any = /^\{|^[^\p{Lu}:.,;]+ \{0\}$/u.test(key) ? "(?!; )." : ".";
const part = (name) => number || `((?:${name === "{0}" && any !== "." ? "(?![;:] )." : any})*?[^\\s,;:])`;
return [new RegExp(`^${key.replace(/[.*+?^$()|[\]\\]/g, "\\$&").replace(/\{\d\}/g, part)}$`, "u"), GERMAN[key]];
});
const numbers = (text) => (/doi:/.test(text) ? text : text.replace(/(\d)\.(?=\d)/g, "$1,"));
function translated(text) {
if (Object.hasOwn(GERMAN, text)) return GERMAN[text];
for (const [pattern, to] of patterns) {
const parts = pattern.exec(text);
if (parts) return to.replace(/\{(\d)(!?)\}/g, (_, k, kept) => (kept ? parts[Number(k) + 1] : translated(parts[Number(k) + 1])));
}
if (/[^.]\.$/.test(text)) return `${translated(text.slice(0, -1))}.`;
const between = /\p{L}{2}/u.test(text) && SEPARATORS.find((separator) => text.split(separator).length > 1);
const sign = typeof between === "string" ? between : " ";
return between ? text.split(between).map(translated).join(sign) : numbers(text);
}
function inLanguage(text) {
if (!german) return text;
const key = plain(text);
if (!key) return text;
if (known.size > 5000) known.clear();
if (!known.has(key)) known.set(key, translated(key));
return text.replace(/\S.*\S|\S/s, () => known.get(key));
}
function write(node, name) {
const now = name === "data" ? node.data : node.getAttribute(name);
if (now === null || (node.parentElement ?? node).closest?.("[translate=no]")) return;
const of = written.get(node) ?? {};
const text = of[name]?.[1] === now ? of[name][0] : now;
const said = inLanguage(text);
written.set(node, { ...of, [name]: [text, said] });
if (said === now) return;
if (name === "data") node.data = said;
else node.setAttribute(name, said);
}
function writeAll(node) {
if (node.nodeType === 3) write(node, "data");
if (node.nodeType !== 1 || node.localName === "style") return;
for (const name of ATTRIBUTES) write(node, name);
node.childNodes.forEach(writeAll);
}
function follow(node, changed) {
const watch = new MutationObserver((changes) => {
for (const { type, target, attributeName, addedNodes } of german ? changes : []) {
if (type === "childList") addedNodes.forEach(writeAll);
else write(target, attributeName ?? "data");
}
});
watch.observe(node, { subtree: true, childList: true, characterData: true, attributeFilter: ATTRIBUTES });
followed.set(node, changed);
if (german) writeAll(node);
return () => {
watch.disconnect();
followed.delete(node);
};
}
const english = (node) => written.get(node.firstChild)?.data?.[0] ?? node.textContent;
function tell(node, text) {
if (english(node) !== text) node.textContent = text;
}
function isIt(language) {
return /^de\b/i.test(language ?? "");
}
const isGerman = () => german;
function speak(language) {
german = isIt(language);
known.clear();
followed.forEach((changed, node) => {
writeAll(node);
changed();
});
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
for (const word of inLanguage(text).split(" ")) {
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
label(context, inLanguage(text), left + 18, bottom - 54);
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
for (const [at, tick] of drawn.ticks) {
const word = inLanguage(tick);
const x = PADDING + at * width;
context.fillRect(Math.min(x, PADDING + width - 1), y + 26, 2, 7);
const wide = context.measureText(word).width;
context.fillText(word, Math.min(PADDING + width - wide, Math.max(PADDING, x - wide / 2)), y + 36);
}
const rays = state.rays === "on" && !drawn.signed && panels.some((panel) => panel.shown.rays);
context.fillText(inLanguage(`${drawn.label}, ${STRETCHED[state.stretch]}`), PADDING, y + 70);
context.textAlign = "right";
const made = "lommel";
context.fillStyle = "#666";
context.fillText(made, PADDING + width, y + 70);
if (rays) {
const right = PADDING + width - context.measureText(made).width - 40;
context.fillStyle = "#111";
const said = inLanguage(RAYS_SAID);
context.fillText(said, right, y + 70);
dot(context, right - context.measureText(said).width - 16, y + 82, 7);
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
const names = head.map((name) => name.toLowerCase());
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
let [last, formulas] = [0, false];
text.split("\n").forEach((line, index) => {
const entry = /^\s*Z\s*(\d{1,4})\s*[:=]?\s*([+-]?[\d.,]+(?:[eE][+-]?\d+)?)\s*(:.*)?$/.exec(line);
if (entry) {
const number = Number(entry[1]);
if (number > last + 1) faults.push(`line ${index + 1}: the term ${last + 1} is missing, got ${number}; a listing has all terms from 1`);
if (formulas && !entry[3]) faults.push(`line ${index + 1}: the term ${number} is cut off, without the formula that the others have`);
[last, formulas] = [number, Boolean(entry[3])];
terms.push([entry[1], numberOf(entry[2]), `line ${index + 1}`]);
} else if (/^\s*Z\s*\d/.test(line)) faults.push(`line ${index + 1}: a term must have a number and a value, got ${shownValue(line.trim())}`);
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
real(value) >= from && value <= to && !(open && value === to) ? value : refuse(`from ${from} ${open ? "to below" : "to"} ${to}`, value);
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
return Math.abs(radians) <= TWO_TURNS ? radians : refuse('within two turns, in radians or a text such as "45 deg"', value);
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
if (got > 1 || got < least) faults.push(`${where("lens")}: ${least ? "give exactly" : "give at most"} one of ${one} and ${other}`);
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
const SHIPPED = [{"name": "35 mm f/2 camera lens at full aperture, over a full-frame sensor", "source": "Illustrative: Seidel coefficients of the size that a classic fast double Gauss lens has, not those of a lens that was made.", "state": {"spherical": 0.4, "defocus": -0.4, "f_number": 2.0, "pixel": 0.5, "focal_length": 35.0}, "left_out": "aberrations of the field but those on the axis"}, {"name": "85 mm f/1.4 portrait lens", "source": "Nominal figures of the 85 mm f/1.4 class; colours as of an achromat with a secondary spectrum of f/2000.", "state": {"focus": "distances", "object_distance": 1.98, "f_number": 1.4, "pixel": 3.76, "focal_length": 85.0}, "left_out": "colour aberrations"}, {"name": "Hubble Space Telescope before its 1993 repair, at its best focus", "source": "2.4 m aperture, f/24, obscuration 0.33: STScI, Hubble Space Telescope Primer. Spherical aberration of about 0.265 um rms: C. J. Burrows et al., Astrophys. J. 369, L21 (1991), doi:10.1086/185950.", "state": {"spherical": 8.14078996, "defocus": -5.33032199, "f_number": 24.0, "obscuration": 0.33, "pixel": 2.5, "focal_length": 57600.0}, "left_out": ""}, {"name": "20x/0.75 microscope objective, quarter wave of spherical aberration", "source": "Magnification and aperture as of the Nikon CFI Plan Apochromat 20x/0.75 (tube lens 200 mm); camera with 6.5 um pixels. The aberration is that of a cover glass a few hundredths of a millimetre off.", "state": {"spherical": -0.0131582802, "defocus": -1.29051883, "f_number": 13.3333333, "wavelength": 515.0, "pixel": 6.5, "focal_length": 10.0, "zernike": "6,0:-0.00201597229;8,0:-0.000257895849;10,0:-3.68843058e-05;12,0:-5.64687297e-06"}, "left_out": "further Zernike terms, 9e-07 waves rms"}, {"name": "200 mm f/4 Newtonian telescope, a star 0.25 degrees off the axis", "source": "Invented telescope. Its coma and astigmatism are those of a paraboloid with the stop at the mirror, W131 = a theta / (16 N^2) and W222 = -a^2 theta^2 / (2 f): D. J. Schroeder, Astronomical Optics, 2nd ed. (2000), chapter 6. The vanes and the figure errors of the mirror are invented, of a size usual for amateurs' mirrors.", "state": {"spherical": -0.439082439, "defocus": 0.425407938, "coma": 1.033, "coma_angle": 53.1301024, "astigmatism": 0.123945095, "astigmatism_angle": -61.5530158, "trefoil": 0.154277843, "trefoil_angle": 30.0, "obscuration": 0.25, "pixel": 1.1, "focal_length": 800.0, "zernike": "1,-1:0.8264;1,1:0.6198", "vanes": 4, "vane_width": 0.01}, "left_out": ""}, {"name": "50 mm f/1.8 camera lens", "source": "Nominal figures of the 50 mm f/1.8 class; the pixel is that of the Sony IMX250 sensor.", "state": {"focus": "distances", "object_distance": 1.5, "f_number": 1.8, "pixel": 3.45}, "left_out": ""}, {"name": "Phone camera, 3.99 mm f/1.8", "source": "Focal length and f-number as in the EXIF data of the Apple iPhone 8 main camera; its pixels are 1.22 um.", "state": {"focus": "distances", "focus_distance": 0.5, "object_distance": 2.0, "f_number": 1.8, "wavelength": 530.0, "pixel": 1.22, "focal_length": 3.99}, "left_out": ""}];
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
const before = (button.dataset.text ??= english(button));
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
const wasmText = "eNp0VWV3JMsNLXWp3PKTt+S4O2/agWXm3Vk0J2+ZmZmZedvjwB/Jp3zPP4wKjOc8nZkq1ZXq6koDbe5/fA3GGPgf/RvuGXMPZ9TMvT5do+PyDvENM/eMvouZGWjv2RDQtRdg2yoWIgoVbQy3bZuzUkBXUESXcA5BRSMQ0qEXWXo99WkmW9KT7rdGa/cU0EqJXrcotE06Qka/HvQ430PMLVOSYuqp28b8NjcR5LiIqhPPbZAXa7caTEQxSvF2vI/5gsn8uRTmTLcISH20GQ/c+UoSkuPTJoWj9vkyUUOZdAckEdikzSYsF3N5GHkquTFNT3uO5JtJaBFlpTJtajBxlKnrXGR+1pqWY1l9Oxtq52ad8+dnndUFi9Xmb6WxQJu+NhpLvC7KyHtqpFVLCbmhJLk/kaTudJ9vJM+SojMdWH9RL1vC2zTT/uy2qe+M9iUsfQi5V41ntlQ65eoh0812mhjSnr44aksT9as1X0u9fLenFmNzLOrlm/oDSd+79AWaJ0/jT+PLY2xTgblvghIrG+oWztCDXqoRu0pO0qyWP7Tpe0Vc++aKwXQApxUsjtlfv97/+Pzuxzf333189vbT3XcfHn95/vjrLv/w1duHL+9+ev768d2njz+Z/r5Xb1+/fvyq1KwPnx6/Mb9kAJ/cf/7KsP3vsv8sM2ZgmRcZ/MPg0GAwhyK+v884QRamwaquh/74qwaMQeel432DwsPOoZpvAKwtCj3ll4KiNqQ0BA2lRfhPA1pg8M9/GRo0mmKcCZa2ZNwYRzhrLER/ZWBWf/kKv3LVasVoTbl23XrcsBGXb0LZvGULh2pbV/I23s5cuR3bdpLqtevXV9VQWe0aroRZdmPR3TkkuAe7zV5SUxAEGbQoinF9jOy8Q0b1EBtnJLxZuwkg59Uv2vK65OB+P7h0VdsnHdQ6+/GAF1l7sNOJtZePaGgUEEfmtYh6KEQFsjFjBIzIAYddyMQECAxGFNKAk2octHG3g/U9mEiM7AEgIoVohJuJ1Y1zkziJUyN/40kC3lX93RL9Ju6Qc0QA7KHRTpHRczCURmn0xUaCKetGS3CYqLLlbirhyNG6BrLWumPHT9SHYPzkqdMjw2csnD03zOflAvi/ClUXl/u1dJZEDLIaNOlLVJe1gN4Hnq06thYbvhQ7MpdjjnA9FhxPOMESVAAgWqtXtscrA1JWVyzYktae5JPLl1fVcrrMRVFoxtXUir9WMu2B6+LR/yZiV964Sbe8ULRjt4/dDC9Hx+7crSHUYiIWaER9hwK8Zy3zUPhANCR47+we7+/Tg7NVyWuBLbKZ//IIWdVy41ZRUlRwLiqwJ/GhPPKeWF9Ij4VYwYKo8eABwEcCcljU9ZNbd88SPL3RRyTLq6G14+M2dttEJkc1EXMSxyg44XbUzpBbiKLbsfQ4DkT2WW1v3X0ON1am6bzIvSLV9iW/oikBlNPMoRXFo6aCbNGBArqemM+vPVy9RnxTjYwMD/PGbskbR8uSSiKqa+ZD/lB5SARYyssGpfQlADezyv05z/w4foVZmQnPgQ99s4nfdEaxvpmbiQcmyh04VPfQI2ZC07ATmHfUli/vrO50SG2SOI6R3tbvdh5jRqwPoW6MscJG3FPX9fuJDzRC2uv2k/CR5QCdRz4XChCqAlZWdewnpTfARsI3DZkCgar57DCzpSaE2SukoOWQmdO+BEyquhaRqqq4DJIXfMsDOVq1gDNyl7HbTZe/QvM1jatM/DDfq6JsSIgm4Nt3+pGEKC3Ru2P1oT3vJ0gNQqH9hN7PzSoxT+Gen+vb/SUbub5nanoPgsbZhIz877ZojeRGPQZ/jm03CAXpWPBAhIhEXqdCos82it8jVra4MUqo2DD79EHrvaQlCfkHdLHBjNDsLsb5cwOX/k+LVYC3jeT7AYFt2bGOwfe+N9IxM4MjrxeyPWbu5dr0GpeTtEtp7TZpNstQ7pLsLO8rLLaLSZnhYEvLzMyQ+P1mJCta6McnfbFm/qTfHzWtra65dB7Fjz1bM+l0ugW3rlEyjxnfMsvUq1QqCatMvMqhuepJ1Ob2YLMwfA6tD4Q27sPePIt9wJjSNmVaxwmMWGPbp7Z3tbdObj+xDR3dMW3aFLKMJjvbusZObv/HxC5yfrCZ1Tq1rZNcTPn0zgnkEmqNm9k1trNt3LSp4zvJSmpJkXHtHeMmQ+g6mg6WY9s6OqZ1kA20adrUsVCIJDbSzNS21o6xUO/qaO3sIrtoUvI72lrHTST/oinIN2T/Q5MdrePbZ3aOnTaBHKRNDR187tvHtZFDNBFZeYhqf588s4M8RVMKT+uUto5WclVaH982vWsiWZVW5Antk7vaOsjatBGubk4nX2OUeNTaTL//ox/8sPnoIwv5o4pHHHMsxvdPf/bzX/zyV7+eeSW9ip6q7dH/qe/X7tXuNLYaF5kvmm+YDyQeStyduNm6xdpvHbDOogvoIrqEzmd97GR2CjuVnU7PYeezC9lFbIBdzC5hV7Cr2P+x1ewadi1bw9ayG9mtbJANsY1sE9vMtrOdbBfbzfawvew/7Ha2jx1id7K72H3sfvYAe4Q9yh5jT7Gn2TPsBfYie4mdr12gXaj92dde1Sr6XH2e3qufqy/QF+qL9Yv1S/RL9cv1FfpKfZW+Wr9N36Rv1rfo2/RH9Ef1x/Qn9EuMS43LjCuMx4zHjSeMp4xrzevM68015npzg7nR3GweMA+ah8w7zUfMR83HzCfM+Ym+xMmJ/sRTiacTzySeS1yRvDJ5VXJFck1qberG1M2p7akdqZ2p3am7U/ek7k3dl3o19Vrq9dSbqfOtC6wLLd86M312+pz0wvTi9JL08vT56QvSl6WvSKfWr/y4n8kTu9M+zj7BPtE+ye62Z9tz7IoqepR+D7V7qT2f2n3UPpna/dQ+hdpvUnuY2iPUvjRtn5OxPk5Ys0c+w4b2ze0nR2YIsTwk9FvB3u5BkxBrJYUQaxbomcQxGSJIkajr3nLNIYpez/4MdOrNPb7k0DSz3ioCxvCH1E9Lzps3XYpQS0kfG7P2N96wtnb6T5S1bWYoGheRjGcnqp8xOe/cLEQgIDGYpRWFb/QN1qz9CZPOYWU6h6s/PgdWya0uL3yj/zJXA9gZrh5344hayAxYnlfyKrbQc45uSTy3uobSNBU7IaHFNY1IMxlqJnNOQmqyW92U0rQCNjRZXDP1bppJaEJX90ayMjoJ8I/JBC7WBPOzlkh6O48rOWkIJRUTVhtckfZ2mEflIKTB3AwnI0z1NIWlnppIFWhfYaSurmxPoRJcdq+TEgZY8Eb0F8Ajikd73SbBJZ1LJWi42TkQDNeG4G8X53O6XRtE0SSwFFhCVxgiCzrEf72i22lSDqaFLhIlb+m0kqtPchMehSMgJ7z8GHiUEokVfQ4XKW8IMZi0ot9JpZl0/XS4riu55pKMaIE4HBxFqZOfgEAdA8SmkCEfosmrUGnFzfYBSnKFa/f3Skx9BfLLFb2OAbB2v9OEUguAHQ0EaUcXKYdDPwW6su/9TJqPaAAXYuMSL5CWgDkruYKLbGCbQzW4hSkynW5SaLAO+aZuCBlRULg0iPVsJyuFgSg1WyjebMS+/DvoZB1gdzQpiLwe5WgF0GbD27Jc4HU5qc4twX+OgoF1foKbuswrl1x43ATPC+sIrCrXm0LXudAlbkeHVfVe4+d4k3GCy8HPUOjQfvnTA1Gv7CTTLF6JwBfaR64Qarwfr9VyNzpMlrBITkI3bTgOdSy3WB0tV40W2BD1AlRcIlhrBhYKKKyfZ5g0htfKn/7eRplWhkiv23iHy2TBk6rb6KlnzRqskJoAo6q6QbfnQ4kAKWQgUK//7zdqN9w8Kp8FaNyVhHyv2fPzHJ6V43tGX+Iw6DbsWN+ltOyhoGRvHyld4c0CsxMBOQqxIp5WcuCGjAjYLE0sBEslxHqFUVaWAfbKSk6CF6QFbntU0C6XyqiOybkUyv9wSYbgNUTlxBOCTIJYvc5neLOh6GVaZBmCTr2eilby7FlSCTIrChDq6bvMoQAYarAul32Grd6Pae7K+Q54alOCtt0lSMnrLsGDb8EJxMkDimYIKpZXlpOkQEVkOPBc2oTXb+6TNilsQlRtSogZjRmkWQusrYqlMEFL7UJ3Ai9VVEgDo4wrUDDYr/NvKSJ2KhaehMY8vIG1ZBA/gHSIJWToeClw4O07YnVRDSlT9ajSROTii4S4gCofshs96ujIJPfqdAbyJnT5Q4VewrwkeKguoWgSwQNNTWnCmCVlgayMLILcklP1Yj1i6PI/R+X/jfLuj1dwIaKTXPoJtVR9Bnwo97ASXy07DA426nLQYYI0NnWIQSN2B98yIT8duMwZrua9tveMeZqcm5q3/s4DI/wnGYrlNZvW1/nP4IsaIFzZvHek8KWHB32HFWf94IRvPvPdx3/owDdMFfmtgw56rG7Kzy8BJNOCKvlVxoDqM999Hap9zePhcAObhG1YgdaDHEkBI7hglMCoZkFzZN7n247+wCv5WqPf84Jc6r/JXG2NOwqjhvAi0xHEGjCqadOg5GOgb4X9MuxTBRpxyDcgc1UCN3yHpVHgaZXBwA7DrVddUsUvPuwyARGemmvU0JHRXfzihuTUNcOn3lYrfveXD/dt37P3R36tuOaOKy/8yO73D2I5/zcjH/HpH/NYvmi/B1cV1EZU8r5rhusEBqowa1XXqIaUD8vUG7XqQM0xJHYJW1Ews6qqCuQOGGv4EwykKO0aarCJE0YZZMAahd9YIa8yApFnewfHZaiSlYPRjwCGodWiM5OjK/vfQQmBJrRJAdVQ1PeBGqkKo6oMYrjWwpchYoZfjSRCThykIsch4FgoCORk6SSOykWF7wcRYLHcRJbJEMxacmyVgj5Co6Vh0156BjZvMutxzaRl2XOsW3XfSe/WebEeYgVJ9Pf4T+X/gDRgG1yvDpblp49ExTzgEFQyBOrB9Uqd/DbDg+KLa/06SGb1LYo8kEK7utyjXbJnt5myVXnQazMy/K0Vy6Ey2kda+Ia9B1Y9Nlj+Y4bEWkwVSyzAOnxSc+H+2z5ZwtveP0sdyI2YtQjxvQsuH9hAYE/mIZ48bEfTUQ2dvmfB5T1D5Lc5oQ84iASXHTfDu3Dd8jpHAYm+UCzb0zsYyyUKeY1sNT1qYZl1Dfuo6f1YH5Jmf8DV39qYNdcUOgrF1YRWc/Xh97sJoQ27VCRg5aLNx+9NLt+Qrw2/XwoVi7/80T3vfW49+uFuvmPx+KO2oD8hO5xedfyZ/7Npxs78Hxa4Cz/R8q/88LN0+HnQtdeXLFu27GB+wW/k9VBIdxPDgI4f6vsAaFZ9uPKWwiPWXZxxVFlsEMqaWubyiCIPM3SZq8UJsXEv3fy7FBFUPjTB5d94V8+BJ9d6zh3NtTQGFaQDK5nD4s7vlydc6D88FuOYRNvNH6u5VFZTbC9PRHafhH0RLEd3zeXLFRn85QDDJRKEuRoQfbkVWihSlRr+QDUyO5CVVR3hE+PeimLgbSgG/jsocHxTZuLGqYjudxqHcNw4tjHj0IDx4AP+L8pYLL15hwZDI54QpDvI+q3xbzH31t25tM6jBn8en0UqmH2qfElwPCVvm4kDo3s4xPEFX9qrKa3iaXd99AMTxOIh374IQ66hOFSuja4citKEHgtE3NioJgP+aCdZZzBO5zAMx2D60ThqFsyilmCAAUY4JRWdgOwteG74P8zh8ZHz8yNqbzeDs4GU3AFJyEGdTxXhhKCFSuMqY0yohhYaMKKtVYvX0MH7n3rwP2S17OCDv3jkth3FR/FZVa29fl/LsX977jUwxCeePffez4yAUTz34dbsw3wk7/uwdauy392jHonuQVfalIWnV6UFXwYaFKxkMxNrq6bJrwU7/AkN0zTunEqnr6kYFT/8xeKv33BeyzcWg5iA5d/kVFfnwpM7bHAoPzMiq0FtYFvWA0mzcIaOybC3D3+wUFgKQqizsy511PLMivaz2Kfp1UF/dJ2PHUDw4fGYo+FLotSWwkJM7dlILRKmEGZWxBdEErk6YamKiGvGxjWEiKMpEZXGmmuI8C5+eXLpC8XraoO14vLhu3/5xbtXyJRNWd616vnV18rljA9+fGTzjFvkcuMTSzGHt2HpyHE/auM9h9wHvrfibLj2RGbWJ8acdEUe0r/44V5/QuZquZwqfrxp15Fr5LLeQ879RMt6ucyocX47lo4xmoSfqOMx73JVHvpJ6fNcVrspDL8GGb9Bq2LOqvPS8iCnKpsiEq2+41vwlKYFJ3160mFbS2aw0U+V7pKgl3XE6yjK3fTvoPnCNQlOE2rWhroVaSje4ctip0Bgju5i8pXhzH0/ZDDcfw2dee8zLTIw3z9r4vWfmXexDPlviv1Nv1m3TVJnT3uCv3fffxRVXZtAjQzNO/dLV29aey0M/YGekZtsPCzltp76h/Mf+hxpxnLMF0/92Ke/x4f8t5QfF5jFmkJ9zcO31GXwI1+FhpvXwgOh+ef3f/1Tl55zi1911ZSm+AdHLmuF0o9BOujs6T3/T81VQEeSHNmqzCzq7JZq4PnmTj5fdh2Z2ctUhvHT0cIxg7llWEbdzKxHZma2Ndq7W3geM+MxMzMzmlnPFz8iM7tK3a3VmL2zra7KjIyM+BEJ9bMkHtKbJ0KLc0gYKXfCGSq+ibXh2myS8hObUcFmR6/EEkheMImjMbjKm4ztg5LCUDQPROw1TARFthcB1gBQ2F4EjANaoTwAHqAL5QH9gCOVNzntRbYc/Uxv2trkJ9pn5xnSDRvcdP3UEi4mlgenInYTKb4g5XpJx5KjNEaxO4N0c/A1jXYaWghJAxRxvQjJ5EuIpGEkDSM5zTqkHa940bGxJq9vPHbsnzBndpMNKQLnomN0vcgx/WVyDJNX9AReTaeK/kxBccriwIJX1DRzGmvkV3rwaHzL3CHU2llEyjHfVU9aUz+VPPKsFBNX2ZMfaDZO1yVP2SC42nufpn4ZJFSb2J9PFXYAaC00Vkqfayd30aThZiLO1uRA4oHZU292CtSbmfDqobC9Ew5OtRrcmwoUGegvpwL31n4APVFLz4gph69l6xvrPoEXlRCzJXpmOLygRO6sfVPwAP/IX5eePCLbFmzI8cjZRQVUVTI2HRD4IMbpPk5gTTQAMcza6ZZmlcTfaxzQJGclBC8oMQKMbAdhaS0JlqvyLEM8qAZwyeksWE5AcD6UhYz9XqZCgfWj228gza1x9CHyMyE/XTpxibeXbdCMPEXFpbCSfCQzybedsXxNmuqjwiR+hJlEPSJaEldj3fqr06TKBsrxEyxoWncYHXkSvN1QbVq/iC3IRuTesgfNZb49BgoFgoqZkzmN9aDUUKgmpG8jJWsRKkMZg2jBwAOYQfAoILtNRNba5BtvpDsyBS8wfeMTuebpT8ZOpE3qp1NdkthVSnCfm0QRy6MI0K1fAHHCPq1fJlfgLZN9rJ9/CAO9bOuXH2NND+lrUgAMk3zUlECT6AQ1y41nNA5AurwQd3L5Kr58XE83s2lpa/BBZCeUJS0Jr13WpKhB796PhPp/seRn9CRlBnanJ2n0pGvDMGEVm9ObhOf0m6w8Xr8cE8HKFvCPC+Cl9U0Q75XVvuy5VY4hJZ9qHed/Kh7U0dMZHUCZKYmUoarJ2xsvndDR5ipT2gWYtSPfPhKCCKdn5QOPrgf26Anf09nBjSuXRQbp/IvJ65IOP1h5hoax8tLvw2HgA2/0d9/jjwSxJYgyH/hsQhqCP+z8Vq/2e5yiXdAVtN57/X2zZIkbV6jEYp+46uWuImxv5rxMD+N00ilUqeiBq2i3AKdjKzgtTZoCOustXJMQnTNSDhSsqHA5AB3nBGIwAceIcuYq+O0Gk27fV6wCKXapW/t9hxGE+mekU7r6WblyeefM99707NrtNjT/+/V1sUCh5AJaGgcu89rf8Cd/+cwL1hsVZK89/tM+PuV6XEkrankPJEtyWZtd2Zi76Xc8i4ZzY7emj1DIzja5mz7GNcOtZrTVLDlKsqe8s1lGxQeeSRVbjhr/OkQ2m5oiQ4F+v6tObDX7NhsqqjYb65YoPJa42H1u5IbYngxp584qPhFV/D6rIAU1td6k/3grQ71WW9S6ElPeAKEtXN3C4ltSvBmLX8rFofy5sfypvnyzGZFZ7w2oVWSKDA4ZN6Z9+7WT9nzZlJr218GARkCmuVTI0fXTytVxjkkXMZtmYxFDWYTwutQNTjjyJCUELI18eEdubuEoPCHwTwZDfx5XDBzPDyj6fa4Uj35droeED8LDPJqv+kDU8e8nBZtUKv4+Vvy5r6jI55tbQ+s++ZwTmK+jckf4MBl6F/0Gvs9ccXL9gfd48vpYxSMAHDLe4n1S78dySd1sYrxV9nsVpqI2kTO0iKlqwdjgQT91qn1zSZBC5oEpXTu1dhKH9kfXHSV3cgnE+IwqoUNOpozsb6apWY98cClSLo0D6QLiUDTM0GF/nxzd4pkjynzgfBoOItUY3pW9LMZSKMEu6fN+NyfkHU7tYStNttnkjjRJIEEFIGP53KZLvtFznI33dbJl/zTTeCaCP/HfvCejT+GcjDAT9jVjX5If7KQiod8/6uq+yYLQtL+E8zU5f3wjzteE20lxTJb0Tth0m3ZP2Uz/MAv1RzsHWqBadj0sU29vdOewzIDQ7B6WYS8M4hhHXPRT9KlwMoflXO089MrwOBP/fd6HXnnn0AvP5U3WO/TK+NALmCsgxSVOnzgByF1GJm/RhwrGOj57ds+79NzzLuRj97hLdozzT4+4I73zKIyDGs/BhLI4U1JE73Z6BfpS9U+vSBdpwtBjXZl40T8/Ax0JzZuBVtLMacR+kNnQzd/2ztTrXkhg+xomrI90kyZw1i9rFM6LMQZe8+vP+CU6xsHArG/FZMMTkI7nWuejSocxe8t538P0JFh3/CB/OxTPCeDJlb3iTSlOqUV9G7rwntwh7G63NrC7rd+Gm9ni10nxfWkzOcPKuhRb6dDg2FPRwKVhl/zN4WS/xSF+gncNSvxI2iOX1a9GE2Z9VVrIpjclIVywTKNJqjF4lMnaQVCzgjrjaCBfjfUcFzSrrzTFmksvxHrk0klTttdcONJcN67aa13poIGkcNrX5HSf03tq117WlhMS+jBmItoQ5/UrGH/NdvKoKGA1fiAlsIueuGrFFZ8ZkHNUXaEmcyb6gmeQEqzkacrQV96mlxM6SCqoZAVkxlizmfJCWiraiwm24J+x0LsDNFeSNknMkuw/i/qmBuWEH/nkWeK1EqLfSFNzNMCnCD4CrwNdowU8FcBTAM/QFE/g1c/nowoFEOVcRq+5bIKdVpvAtvpN6ATd+VdtOj4Z8imUarRKnWKQqLmajNWsTyr6pKY+qeiTfaFKM7iiEM8U8UwokOnUtabc4VyF2A6w+YixrWJsKx9bVlA2Vsxm/wcr/N6egV1GOIqhMyHEOUpyKTYT0M1cAy/pntIOziF+eFxVUS6fQMkEUAgQVJyjQE0aI15SswHkrSun+ZNK/hjJn0ryZxrgX8ADdRwfswE280ZHRoFfcz6wBudra05PsLzcfmDp6NOEUtLbCazee2BNN7B3gBDPUZJx9VvZ9xermLqGFTaGnHDGO2BcKvtU9jyPnlNVxv6Id5kYSflMDVpO4553uu9dDtAw0CGOAGYYlrncrzUFxx4Kcz/mnRLQOPirK3yZX7hCQETtUAExlhfeRc+ipCNKOqCUOd0d0if3POu+7yn9WfedJZM5BMD7N871W6H2Ob+bhMt/ilcVc2Z0ce/LqV/GBAuy1/uG94leMnByrzQ5myUUJFJmSmgY/nPy+LFmVf9WiC4ddPWVQPTSqAh7dT3bVQN0O50hOZ2mlo9d4w5jnQI5JYY893ejCa95Vr6bDY0W8UubFHY3qmOOnHKrOV1p6irbq6mknhQ0Ag93MhVSu/gDsi2nTuS97V/4s3vBj7T9+Y1z4RsXvvYfTXRuMt85yMM5QDLXu751PSG9CwRY+Iq9QgAj0Ak667m/F4zMLhjlZEUpMT/2i392rwjMC/7rr/Xthh0tAA0QnQtN1+pZWHbHLtsFu4KsrvaMHcxEL2JnH7xd0TV7QTffBV1MiIOJfW2a6s50o8LRO/mWYYZ5O275Zk0W5fBLCAM/k5DCMJPIiwkouxbbuHIiS3Djt0ipLHGG4AFvG3dCvquwyKQyJzoVTnc7q+Gv6TQL1rpgLURpcjwEDup0XXPDdkCU0xtQ+XV4i/WgU/dI6garpNO8BBgRSy/HS6cA6UzNnpE0acpEiollH8a3bMi0Vj8Dcy6pSuRVee0MzrQ1P1qyBt3pMS5p2HTlEES3JJKvRQOZ7w77EYWF4iBbwUw4Chjiur9esITgqu6i69NVEt0XMNBP/XqPQOsilLDmSvhtLPqch06ju7aarq0syXEWV8VkE01GDQrEZJfJA7ERs0PjxFqTOE8fvwt6reL/98eCVnZIvaKhL/psSpR5fK/w55O1RoesDduJlH7IK8VYc5nDSiWOTdb++R/xW9JZ+898Qb79AtdINhKI6gynt4fJjv/oENiqO5M3+C799yEAdlZyNr5OU/d3WrKcWIXTVE13FIohD0AzAUBkEWwjG++478ZIqwNIKqHxlT5UUoBigiGC0XWYX/UjN30EnbHPzFTWB8D4ugTuw8drJ/jOJ+NCWOx2nQtKgKM8OAnvgySRXdHi4YX8XyNaOJNXY47gfXozB4mKPD/ojMP3NzmDhDvHmUCLH0tPJyQIBEBAwAMCAyRKpBvgUXIkU4CFbhMGhjze98SAiJhjCBNmqTEOppbCxiZzBa4XGAejnDdyd+OUGJeJcSWMK/vGlbPGwTAw/wYna/c7BSMkVXZDRjrvdX1o3/HYNWKGgMKEOy+pBKSMIRFB65uAlly66eXdOxgGTDFzcd1DJA946grtYhG+vN6Hsr+Ewzij7042ZvZJadIZdiUnF0pSaojDLKQ/JqQUHtZI6dMImhT1Z9C8IXsg0swF1BTftVN8BdfoKvU6sBcAhqfRlxKdWHdIn7W3wowvtiHqdg2hGn7eRG8KE8DMaLf2A/g1FLYR0Yz/hISG/U3uMvrC8MtlvsCNHmZM0h3uS9VPg1bER/l5D98SZm/vHWEVK2q4da+hrFrSuEatYhQ44pojL1A5OA1tDjghrwykKVHPTu/fdVq1KbJ6Ztyg2T2SB0AlmpGmu6Pg/sTvDhUANVRiJTwHJS53ZlDvjEskYScSiQ+A3Qm49NwfNvbjaZr2Ee/jnUS8ky7epo+3+Vzx7jc8FbwFC4G9BwlpWAxKBNM+UUXHc+905t1xObwU7CklDneLo6mi8AGYfcXZ0Mf9WRdckKEVBpPpjDAD69i7e7ep9KT4pDmOy0NNInb7hoZpytlmLhVvZawvDn02J+3sX6ZfEAy+EhGQfdTXTp+AfvuPeUtTkhRqcBDfBrJyOQg9i7ey9kLMQpHI/ZNuQ2R72q7zL8gJ/XYUFfxYkHwbe3vlxL9y4JL61/ni+7+w+uIWsBAFfXtf+AW294VfcHu/aHh8tem9UvTydCwKeTDyq0suDUSmJwepm1F8bsS2qYx7anzhmX/I/Bo3b8ITZHh8FJ6NMv8nZzuNhPecHpT0oHo9KPQgDDcGdK+H6NbGl8OtjS+eWy/SdIib0YutsMWlP8m/I3kZCct7Lij1r+Q3OrzWqm5uzOUQqZ/rHzJ1e6erW0VErrzAf/5Tb75cJl/Xe5u/oKbccFxyZb5ktE5SbeOrscvx8ueFzw1NtUOXnRdhfw71kJDfosCcWoTL1OWtvpLe9fhFmvlELlRizkeTY27iCnqt385RmT2k+xtfJTeFvF71LwDd9DLxnA94gicmSZWxrnz58tQdV/p3WU/Qq9bLtnsb/SSUvbmbMJd0ulIm+nvzS5ay6KWAzS939b6NuNzJ1oPHJ1q1if3WJP7aLb6wV11r1VWPAg9w3hVtWv+tbEu3l9NBpILiMyWxIxj544zH+DgHu8OPlbqzcw06m3Ipz3PyWxvLzZqKHzvlsXRw4SiTw63EVW5AX8MsiMkcU7qKBV2JMx3IJbjEZ5VuDTWLChfKSa0hnaQOtcYD5bgEihLZ2rGSSvAsUQvp0rEgPiy6u4FBi+71T3ehY1TooEr6WqQFJkctCw0yQ9233UxFzWLbh7cH7rAHbrkI3EFQNpAuh2JLKSJQVLrdwEJjHazXCFBje17boDfCNYAcPlSvIcWqIIjPKhRQMT4496OyKsBWOr4V2Pzfp/garFcYDvInACq6uhzTj9P+rKYcaTz5YlKi5K/G3Az+kI2MD06esnGFIQAjJ6SGk1qRNHTLH2gYuErAByPN7eg8yzIVNK6sDAC6z3CfOTsmZ4I9IwOOjAxR0YBEDEiiAXZcodKPJozJUjrU4wpodnqUnqhF0ulCo4vwGggKlJ8cTLs8qf9OmEkVjqDb9cvIapeR1vEAI55Kb0xXAURImk6Yq25eQSRbNGhRIgp2JMFqMxBVXItyvi3Ex1IUFfgC0lb0QQPfSr8FCwhqJsrF0SYYDadtSHK42lgeRyXXopxb5K6SAOQ7uqy6XRqSy2OX5UyXpWiZ6XIooyYAASFHFSskad2QknrkvMcjgc54V7metIg26GGTLOTcCFhCS8kGcOh2TL8pSOVkJn7Jgvj1h3MMTrJL/KQ2xM867BzHyo+2hoeLcJM+OVb9AcOA+6Q7HqU8EkskLv6QQoUS9IbeaSxQmlqMOo1mqGx8BRWnPLS5YYIblilDDq1ChutL1KNorFnt2GoUa0krS1997Y2F/r62RkMflAW9iU9XWXohwyCUjH7LfY0RBSu0HzZzfx8oRsOWm3skJT/ko339D6jEAHQlDCH3pIinrXGK1ws0zz0osKRaBrAjzGSV53Zj7lq6jYcs9p+KdHg07hT8mt4YrOpZq+Swg1+uv5oihzfJm7xNqdjR2fykKejwgHdG6nHjgmApMD9SFXTxqsseVHL20BQugeiVHHgU6yvxrIGITJqBr2gsqsLNEBqq8cjPuiOUO+tHfUNscEp9jliv9IFcD6pQvKiPoSSKN8gNOUIV0hSTDZ5uuDYjL8nHBlLUntvK8joKczKbNhhXbiSGFXhzsfJGHZ1tLWni53Ck6hKjrgCZdAdIAf54SMCXh8c5hDTGx5Jf/vFVIHeXXCHjrcLXkA8/CoRAXjqFpMEPWi/HRXRXDEF02mQ+tkUzALYDQrWxhCsrta1C9mXfhTRzO6Jp/aV0NID/vc483hIcNte6JaTzEngRGTiScZoumqFHQskUttxiGpPxyUaNYBTmPOhDZE049RjBypEb8vkG2o5cJX8zii64pMmoVUmZLKtlY1ZId04O0UXhMkfoYzcyHlnMqRzTMeZa9R1kpzxFSA5ghNL1skyqKA1/fYfLANEaGYbBNGDX2H/JKLHbwoSRtyokkx2TndLxQJKp4IZHZxtmIZkyBnSIBM7oS0kCL8mv1H9sKcfRkTqibzBH1ZFAYWH/qmQexjBLgaGh/g0BpDDlZlzitMs6U67/gz1c2UiFRI8bIXqitVGiN9Y1lJSylzC4F6jkHDGRrjISlX+igYKx1qj2kxrQ6e194/KBNOHTZ6AhM+DXpmfPYcZ2WpaGsuEDfx4plI2VJu3bP4o0375g+zfS7WG6Q3b7u5rR9tfTcKIfT97e7+gmxU365O07pc5uXzTGilbSikalQ+VbqdD6d9PxkGw7st6IgcgiS5KjshpY/MFmflLK8mL7IupgPOClCJIYMOuk9VQ8qoI36ABKoTx8yMOzPg8Pr93VwwoeVnvxsIKHg4swk18kw9sNrr+Z01hJOihs8bhorVnyibEkiTHAe/SD4xS6ClfV8YaUpM5Da/FUfqSF5mZphTOmPabahLqjO86eT2iMBadoFJI7pGYD7VXbTmhWIQRr/NhHCvELPEMdJJFpLc271jMnKH5cs7w2rmUKWG5TmgfDn6NbPjneT9cHkF8oEwF51Ww//8m+4nhzAA4CU6TyaK9RJpXGHUDKO8OBHi1O27Ib1HJOUA3S1nxB0tYdcPsvHqWYkRFFpy886Q482Q02qEq1Bn7udwcemK43ByRSy4RyPV6ejvEl2q8AJqw0EcBCoI8AypgwrtiB49op43iAB4tZOFhGGCyfK64YLOYLMlhmcF1lXKsNqlLAoo/rF3Ns7cNAwsBi/JdlmO1bEfQRvjT84iUJ7MNzKxS56jpKofOfRL/h9qTjHEkYMWCj2g3aNS4hrDBlnMESb5Pxa5jhRYd6ouwY6qkVqvOKaux1qCwsE4tsKMcKBefc4Lqb2/OvaMxJsWWA9kGoMTDDwAwyorMeLcGMAPUAZuAORjEP6gwvbmic+lbyao601rIfy89KjP2VIi2O4ldR1BzWjNbkrMOZCVtgXOK3AnQlQdKMS5suezkFEYOlWxpoZ/zzGy7xkYdSJQLaJYvlpNaQTlLXI824BIqkZymVvstGo1rYFpbEh2Vv10LxrmcA3YWeUZEFVdLXIi2wOWpZaJCZMd5MZc1i44e3B++wB2+5CF4jyrigR5txidBmu6GFxlmwPkOImrzndh70RrwM5PCh+gxSrAqC+KxCARXjQ8oUlamAm3Z828MNlhlRzK1ggNgT+5amRrSSfjGuyXzHZtq1ywR1OpIgLcJM8zYKv8LaluNSM4cuMAi6/Hw+VuGXlZl0wwgLFJb/Y3p+wwnSLYuP5LKnVDZsMQus49QPNu05VZEF4OKFVsjHCoUg0mBvSkK2Tbn1fCpdd6j0fxIq/X+XdX40W1cL6PRrhU5/tNDply6g03WfTkezprqbZnYJX/ZhD2E+fXCmZtKHvoZZkHNTSfBQ1g0e1pQrkExw43DNRC2LiXRfTJoOvXQzACP1sKZCO6lM3NDhVsh0lNTSYdSE2lo6FMk9G7dDkVgrlSLY1VHvpqNcZEwpPDpE5phd7m72oUWYHhJM68WYHprBVNoJgoRpyYaeCkhBLSmG9c0I3N9UrxWLllBPDpHgEsREFZWizKIJdEYtMIIJUEFrHn1eLqbPVaTPMzQTH0r2SH4ntcOfkx4kcZ8/R7+MOoayb4ihXJK08OdI+Pj4lTFTUs7y52JBQDGZWpAJge6HD0ZhKT0mzCZ0ukykK2qRoI89Eej/3CPQ1ZXttUKgk9YZAn1eqlSdXM/CKM3mZ1Qi7TtpNYxquCpoAiMumtjRsqNumetLViHXRRgaxYyYjBqBaChNpFfUo4KrgiaQ4nGWKfuaxE1plYeBk8/vsJb2sUMrHcpgKac9OCu1Aoqk83IcFLWf+IYiJnlfr3QEh4IEMh/auW+hzrlGMkaocyqcDUkvctWCyIXIJIsiJ1VB01zinGIYVSBTOa2kr4dxfTlDnKPE5xsGQZ85R2pLzW7UORIHQjuoc2AkmI+HGsVWYARmffXNkDvoqcNqNoc7vzZy55BhHErAv4A7/5fduPN/RaXMRkz5uVSKAneeee48Q0He485lWUe7Bdz5nxa6wN90nMef6x38uf6C8ef6So4/is2VE7IGYQEDKhXCn8sNQO/z5yiXGO3Kn8c+ikV9SDRtsIgDvjuBrkHTcmNZWEcxKboMOqmZz6DH5uhbSE90uohBr4RBLxGvHoPOvcatFFPo6DSM83KWQsfkgonoYZFC76AgFPosvFWk0CNbXURyWij0kesHVJoD6S6FPg/yQQfypbZcxKErj0Uuc5klS6lHZpKKaFVGeVA5wZdTfdBl0aHLZeOCJz5qDQkYW1JONJnMGhAYuBFsrhxCJOtIHtnygQQcYxLzq8yjKPWyKcpQlayRegydIrDlRS99RgLEoJ85I/gwzRxYM5M5o17mZB47JXS52kGXf3SpStc1/srfDGkONZqpUT/dpm05Q5qXQpoLPDOseRmBm6XNAZNC5QxtjgAWuBfMwOrgC+r6tDkmT6HNP1gIbX5QKHP6WA0Zu4g2H86hzUYgma3Q5rPUGFHPCZJ9e3X7wmYJJNnIk2R0k+JGSLIhkWRDMq7Gpm00nySjwQ+STKyzDivzaBFJJqwXS7qSeeq9uyMDQAyf0wGcmccB7sW9S3d1T7jVPbgnRwIWpN4gkHqWGDwkspJEUJi/uYgWG58SRlLCgsqzx8c20HsNKUmdxxVb6WPrwqgtr3CutMcM3dtImH+g8IS5BmFOaiJh7rly/NjvbCTMRRI5RlPncp8wr9fG+2QWqANhbjH665PjA3R90BPmVgSEMD8QiN6DcBCYIomX9hpiJswPju3chDUc9yVO2Kob0WpORA0S1nxBEtYddAcCq4sJVD+sTa846Q4+2dmN6XHSAXcQxO5BiVRNKO8b19PRvYzJthbCPAJYCvRTAEvhossdOK6dMo4H5dBh4UhZmj9S9oArRor5goyUWVwBajiFuHYG1C/iwNqPUYRRxeDXMsb2r3jolwNbrpkt3z9SkaNubGTLB54tt2xU+1RitbLD3fm/b1M80BlEtlysmGHLtWfLYZlYZKVc2HI452yfLbdoL0KRLRczzI5lKB4W2sCWlx22/NrIlkurHltOt4Etf1ehFdFnegFjrnuMObRqUgd2El8ZradMmUOhdhl9CWXO3TsVRcsmg08Pa7Q8cOHG4ZqZWBYT6b6YNM29dGPAaz6sUV1eLHe45W6lqJYeoypU19KjiO7Zuh2KxFypFMGujno3HeUiY8qp3eUcu8vd7T60CNVDgmq9GNVDM6jqLjOWQw19nwpKQS0phvVN4QqRFr2ZWFSinhwiwRJioopKUZahCXSKlgiXcVkfrh7ssC200LHfwKqhOx1UV1G1RFNUe4faQ55uIhIZu1neOLVhA1eJk4IHb8AHXYq8nPAo6FPkGQ9Roci1NJT3UktPkWfo2GLltkKRV1QlFPn/s/cvgJIdVb0w3vvZu3t3n97n3XP6zMzaeybJ5MkAIZmEQKZxwMSA5PrXK/d+em8wwct3ZuAmiHxcCWRCAgwQdMQoSYikpw9qVNAgiEd5DYgaFXRUwKh4jRowCmpA1KAJ/Ndvrapdux9nZvJAuVcmOb1rV9Wux6pVq1atWrVWk0M4I8x9RKqu6ZiI/AbP95hJHjcp4Kw8PcMTqpDdojZO1dNUzZqQvS6v6Y1toJbensYF96Rgg1g3s+GHg0UIw7Pi6EljXvXKp/tJWjEXQOoibKIF5OuNC79qSuUjasDKt6ZUrhlrfc22fsdrtOzsr1RoYArIazteq7ZjMVj3iNHY7H7EgLidHogBonN9Xppl7FxLTOOvVWOpXibFM/SMiv8HrIFBWHZQSysjpivVhwWMGt4xyG7Ct8aYyC2JZK56CyDNXr7zJ+uD7K1vMrcFNKT29mATL32t54sDH2e/r2rtsCN3Ftue2NtrvbbwQOn7Yoqzk7Krm9xXO3xY1bCtwjuMqMJyua5MeoVDPyHP2j2D4zewjPCWo6j0bi9Q913wxeBpY0bNwN6aiLrSeA/EX6VeBdEM5Dlbc+Q5aOC9Ag35jr/6TB1faT7AupLXBdcBd/koVfO2Pmzbp1/xAjTZO76DD9ca1KGOXHyBSIiqfe4xvMDh4kz29/ZaRx7YXEetxfzSduC+P0p/61n/8jNrTx/ue+GPLf3Kr//aAx9ks4DPP+ubb7mj/Z0XlxYC74IrD2ds8J5X/fLv/u4ZP/u04b6zvvrK3zz0jqfA2OAtN1785Ac/9G4Er/qnj//yf/7vu/D9/+9VV86lP/4jCDoQqIORwBn6G6ZviPyQV27ysrcApEV4m6wVRcgxRyQmOpLHAA6g8hWgtoyPJlp7BRSiGv0H5zoglLfBAmW0nseqYRev51GqpXwIlnKUPxhxA5MgcDC8rGgARY/JbRpG1V/Fs/Qn+YY/vfsgTHj070I8p99bpvcPf5SD/Qfwyzk//963orBmjzMdlZTBryGFI5ppFb+84Tr3V/+TFWHXEL80kEdXH5k+En3UBuS+aHLeITUlKx6ZPhJ91EaGwAUN7LSvaBj6+uub9BXx6Ks8ta+/IX3F73hfJWVwd9lXQF88wtzGI0uPvqfaV3zTxDePsMv3sJ8sGKLP45Ti24Q92Peitz7j8j9s/wW7uPLuWE9v87zg2so0GQ4ZV6/95O/+1wv/6DOM85+7/cw3fPYz/5UnikyGV37lXd/5l1t/g2fQJ5//YbaxeQYMa/7kgzCyeT17t1Fjn852ZkQBsPRStZPPecWBgVoGckYyBZWPcHOOUGTzXjwcHEnfjLaNkoHCd98VwZEidMlik7N0jHd48be5ff/CLf3//tOHlw58+D+jpc+Wwn+C5yDySI8ltO8Tew598K//5c4PsIeXd73nA2/7uxwz+53fdvvB577qzdx3NJwxlk28pj/dFB8qEXyoHN89UelPa2BIF0/C+2CVqdIjpWqc+fYiYO9aVTOv6n8L0DIv5+99gZhJe8jnLUb/7ruNF5iSLt5+Q6jW4HQVKWmDDRysECHujwvf/nwsKqPmY42HsIO//MwtS3uvyn1yb4MitOGjAwY5DGDww8XpLcayNtp7ZaU1FKyz08G3vf3D3/Sf/mbxGQN+ZQcNdTzgmeE7n/2P33/1QzuegZx3Jjf02aOCuLFIHv4HTl157xuuf9IRQurB//cDt0uqSTn1/uIX78qQctdPPnykknL/kZ9494ev+6c+bKlf0721knLxP/zBP3Zf+kmkHH7v372mknLGf//lV7R+9p1Iufeaa/7fSsotH/vuL7/swVcipfaK7fsqKc/+0sHL//oLz5SU9x9brKR87nWv2/6M98aScvCv/myvSwnveV7yjtd9aK8AZuFtlZRve+r7X3HFf13TlIOXV1Ki0/5p+4+0w70VnxN5IkvyPps03Gc/H4iDD1MIvxUWml/ctHakTG8xUqb3EinTIYOUadBEyvQRQMr0UUPK9JFGynTsQMp0rNIUi4cWOwWaqdnqQLel4rASy6satqXS756xE+zQW+36jjowuV0t+Va4pGzv8CH1D/siNpfsch8pL8EOc+cDUnnEmQCql6mrC7bjH1D+uhVU47MvmFifY2+blt2bzH5bXnPXiIVw14ZDZh+ofhtM4N+GFSSkumtr9pO6OVHr12b2d/cOxVkmW9cdpnvFY/vZtVu+iF2LJ150YZNB3w/9Mf9mXxIdgD6cKSCVHxz5FolM018N/OS6+Nq+bBCw0znUpRoseB3sEud9u7FNW7B4BDHkI453XMjIL5LlodRYlrxRvllgUQuevEWM8OT73jGevGer4wn1phIyOPQF4RdfXGsavfcOZh/MlHru3nWFwr6HfvoLv/+c77mCx7upx4WaXal8cx1xdY6j5m1FqjikR+ixRFJzkP0gykFUJFHOGLRmBx+t6SHSU7WKfBvz5HggvqkZ8zYOX8vK86YLithPvqZm1cfOzL4LLttx9twbHvx+csEre1IotYY4rqJ0mIuHNuh8AazYzlo5bKPCXzXM5XyWekuWWnredFud/UPAgvOMO7nsnzTWHRef7XmlTVcPPzXjKUdVET0xV7rfmE9I/xuMewqyDcaQTd8XFFOyBxVngUsZD/fh3zqINpjd9e3ISqoUUHhompqeTdPnef6UPtSyV7/aFHeh2IN8hykuuwHx2NSR9NDXPt6I2FGPbK7dd462G++bt/uekXa/fdN2u+LvGi0e75sX/6WR4t9xEsVvjBW/cVyo/3a1+PecRPFHR4vH++bFv2Ok+PefRPF3jxaP982Lv3uk+I9uWvyZNYOQh189Uri+H8N32VcNoXtTwLt4eLx0pEfs4BshVRE42uMZ2vNNU2gPBFmYpNEahUpQNOKoj4ifrUTU18rFrIjMV821qu13R1mQv8X5KTRUSrzbaXqFoQwdyXLESfeypoLO2r7d3s8t/tPT70cFFGo2zSV5vAohUQlY4XPjQUgcYELQNwFMgOS7l7lpbtk0+Z63d70we2kUzKXMrul2WyPCSk0h5Hoga4eUqo3MytHBw/vmmHHfCGa8HVlPNCtHi8f75sUf/NjIrNy0+Jf7chKv83KsAn0/WhupAUuqGH++3dRAU867mTtP0QzCk8xzt5nCKHVkvo5Wi/fN+7Ux0q/3nwTY7h4tHu+bF/+JkeI/ehLFHxstHu+bF//ASPEfO4ni7xktHu+bF3/Tx6vFf+Ikir93tHi8b178nSPFf/okir9/tHi8b178R0eKv+8kin9gtHi8b178vSPFf37T4gMWNP/XETYkrNjw/XmY+speryJrY56cTTvDQC9IkCzgqnLkZderLwoKq77dA+PmS52TpWc4ozPJrIisJWMu0ca8+6tV+v3yTXijt//wqyu80eHrNfaWkdgfNrE3Ts374OFq7JsR++i5q69l7s3Yw42Rbt083oELPX+0El8r8bMvg8vSBE3VOyTeCWu8d6TGHzv5Gn/t+hPUmNX6n+fCsQO7BXnTM7kJ8kHuK5LW9PRZ3MPdhJbd5NmPf89zzOdud1BTk03JLv8BFKybReLXL+FV1VHV7RxWXuTBSZbzxCdEHmfsamELrPxui9DwRZZkb7pecdZnYJDHHvqzDUV3Pm3r/9LrecpIUnbb9Rq7c02TfgV297O3SqzGZ38oH6JBP6gHSLs1CRPqPdIe4IQxgH26z4sRxPr6ECtd6TnWI+G7dL9XZvdNdl+z+5r9Nn+EX493arAmnhR1YjyEhwBNwS4KpTHVtDydPhRnP679wD5HleTgKC7VOUcemiTKhX72NmRseZsmUfwMf7LgGJvZmnyDyDsEOfo1HPQfRpw22cz72/EwlrbQWNU1eTjlApADBQxQgFXEidDcSJQtYofGN3peMM08uLlXBfwXRy/mDLCrJ4IL/MBwM91VTKMQKBbY8QILpbbN1aj2EcUKvpGVB6XhNGdiO30vRgjlOO83RQitBeOAXFpDIRsx5rjntG23YRCYIrXGhhzQ2kDMWmEUWkNhDQOrLGkVPrR11r+nan8ahyIqPoVji8BWEGgFutVGFg5nv3eDsUItJ1DqN8Q13hoBIXNDT+TBUOd4kJ/1S3vZv1qqxC0s9W+rTd2sjYE0IDuI6h//0XN1V0dveILRe+3j3ArFY2lHVm3H+gna8dPwkTTFJ77UDiphL8bJRbEQgonIDZ8MRoyhkDuGjAAYQqgN8V85hIEdQgr1TP5th2RTo7ctY4P+kYAQNClCra7qmIvdL2hq0Cu26IVauXofX7T0aqMUWpdOqpUda+6BYsCUK5EaFA54IC27Aw1aETRU+yZe1SvA7Uj9dwLVnTdUQaW49u8Kqp++YVNQuTn2sycPqnAEVN4moArGQSVr8iiohjdVQaUTwgAr+3cC1vpNxwPW25EKZ2bKrJKs0LLiebriwWj9BcFdSExvSBpy3M/7Uu+V/Ct/BsR3MeltWEvp5bZcfHfiW1wAHB7RS4M+b8A9asARxQBPpi23eKj5QK5aswlg0cCiyg9YYMcNuewn0RxxZ5WWnsvSfutAUZNX7B7UxRgWW6yybtUtfDX1jr8EGpBmAYdmENdwiwePVjHVs59CHWilaB/hwkoXkuUE2JFMKxfIY6/xtGRE8QgLs4xhbajJnHnvHl8NfKFUvZVjFoeG9X/30FchEwdEWmJyTHcBIKON/kFvTduszQXVlQbfiSycYcpOv/1wGl7NheF5hXlebp56HpFWbX163ySPGdVJqlcSWKyed7gzmcnBfdJSdpsnmWdmnjXNCMsXvhgOqkMyX8xRSnOwlzbfK1r9q1lpQe4AcG2xiLTjNRxDnMFAXJACSB//rVcsAHgNl4EW3owYxQ2JXdAPZ2iGFr67h0S52BxbAbaPrLnPLclgMCVR82Vn+HvzGTy4saI2QC0ZN+pQir9LYfahv/eaNWlhTPGmjVsgU3U+g5qBNLPcynzW4A61rNGimT0+4DfLX6HnCqoFLn5Besg1vDlfGGt9B/DjMcj6bIs1z8ijhfdBtjaX12ke5er1u4M8owxUckY1NNrByJcbsL704LuhKquN9rXF1doizMyMHwDp++QOIU9vu1o/3/eZBuAgR3h34djVwY3urR2LVAR65uKt5aoIaa+DVPgkvSSDWpWP42f6a3Hiy0WU4NpInp7VUju6bLcBGN9DcN0uzI87HPOyd4nTmjqrV+SJEsoG8iTQjcYDbPQucUgoN2qyu5Afls0uEUCswh8Gv7FOM/EFmufxZu8h9EiYb+pQ50CRZQ8jJp+F+jm6PYtaOAebxs89PWsC5Bjh54ZiYap8G6DrZh/i4eFRBv4+M8jROIDLcPAeg4JLczHUwa0eD+16dlHbf4Chaqh0TfSaPerwkxFkBg/gVRaIDpltXTFP3Pp5AsSsy76O1E41INQMGjGDRgguUMN0katkPk2K6Hu6ZNV08y839LKvIJft/2zFFJg8Zk/3w3wB8Rw43w+Bt3jE4CPfv8xVvX9ZZR3O42QKT9Fz1GRgDSkxEuHT9/IZ5pxYyOPGBqhuXmuFgugMRXmHwT5PM4pu3MY5da6IMVZVHEDebj8QmyeiedmRAfMwYPgoZHDIJ8nwvUJiGEIAkwijWENVKXYHExzA5hqYfGikYNwc8bzH8gsoas8oBlaBXRYUyr6q2MSADTlyFYkuZ73/0Rp8HgBHq7F7XOSby0hyke/WSJ4gdvs/lx5rpCzBkTtdIT8xpQKs2dc6lr+umWViFAl3uqLaxd2RqCOVMQByGncM+KGiub+f6a1TD7biKDC34fAlAslwOMQJgVnIdD42jfj35htKGSGoyPvlXejKRyV425TTZCMpRnqKE1ewDCqOHSvtY660T0jwrZuVpp+mfamf2AGXgWXtmynln2vy1r43/e0vDv751w8/HcpT5QvfWGwLAyIrYh3sStKXamEoENzgO1ESGAMgHWYySqUZ5VIMHIuOgSTA2KEmGIo8A4chReWzbiGec8HEBed1wV7AJ9KFfLGSOPWTObSXGyiDtoDbrgUGr20Hb4mWysFb1MGrNAjwNlUViwgeleDys4ouqE3epEWZjk0pjDogfph9VqUas4d7vYxpU3ohjbgd3QNr+ZaSdqGwLZSZq6DvzVcopozSAzBjVK2Di5c6aOVmnrGoJZyohTJMVS6rnKpZsVTxAg/077Gn+1UC3q7yyCYynzmCqbZEzNE89WhpOGDKs4DSFqrTQPYQmS7xs3mHmz8LyBwTyHSfVSwKZDocmwDW3WfhHVRoCdHSkQ4tKfR7VxbLvbyD2ogDHGs+MgDzQekyjtswPRhcNKQOvuTWFfP81fwRfqAn81f21jEV3TEZQgFr4zydsyYUvABXckuMfn4bNDCAG3IMzKKINkI0VNlXtVKlnZg17SH+RDX9l1SjP+GhhspKu3KoGFDC7XAAd8Ere8MicfPLBa/i2dWSwXKCgl+sx9h/4K/iFu1g4AhZvf8lf81cusl+SSZywIMr78OcOyy2RHkx3QAVcjYh1b9NkT5Lr9eK6SuOb9vjS+IUX5oT8NKsrmvqoC0DT2f+LfxE1w/j2WDNFTw9Vmjh5wRvjk3hncggzWWdFgmDx6ewHKDsH26QHoHdF6agzpsOr/DxvN1DU1V8GGnnZICU8yzb7LA9b+IBUU5d1j5tJJdu9hh+qt1Ac/v3+3yJWNujmy4xvJm3tA0PSgu+JDsqXX/buEpFnCeklsgdWsog+AAhdKMa1IKh8uxL0iMUVrT0uj5zf1pa0eDsKlqw+ihtzLK2qbKBgnV+1cFAHvOnwbWYYcjeAy7fU6jKMmZGpaWjUWmoDhMAzAvBBhxUyzjcizE5IMFjuFrCbopfSHVssq/gB1fhX62JyHeVjvvlVIe1hkv0wYBSVPPhDK1O/NjDD+DOhbXnKWiliD2o2cv+UQATCtTvrbEajQ79mdwXpUT3+nmIpmsX8LkOnKPpUGyWpigqNtFpfR4yKHmjPhUInuKexTrIELJ/Rq1T0UXu3+ssT8rLR0PMd4PD4+1CONBpu7nqEJYQd1LzVadWc/zPsAxNnJS5z/7G98Jpbj51stuNiRVVQ9qrgmlz3BOqDPgyExdxlpcaJyX9mjoxV8VniJTVmRcqYBmor94gvx/bHmQwUqKAIx8yUqJIGMnsQRGohZDwBJvXEmotaJMaNNYfSKwKb38e2U1XhHxWmI4isZU63U/ON/nBvoo5PZSofvhwnqqPUB5Iy758g3HRiQZZh9oells9WqqKjf5KZWwf8INQCLKDn7bQnQEYa2oSU0QomjwYZEPLzfXTQE236IXTRA23xGI1BPNdisYYUSiQAovPWWLztaxQ9cohgdpZ0R1lbMT+pDvRiVMAb5NTgAR4ger4r5SLJlNOAYpEt7iha9BEV0I0KHQNciLKb3EYTqVrTwogIOvyA7twdayZGNlPAOz5+et1ZxaUCyN56Q/5oRHNWfZ+sFwiv6MSgY4IqX27nbhnW00FMMFIxHJpJma2J5BjKM4e6WLi9zeWsMAGum/OVe4JCE/uwcWj4uUo8XnZLyBGRJaRbnFuX+Yvb7fbP4nfU41+cxlN1Wjd6KhXTSAxardFcJctQIL0Po/956pTYHCy+y75+fff9sU//IGn7/v4x/DvgYuz19xgtWawZRchXHZ+sIckZjfVymMQkjDoBfZbiigWoeEITTBT0J6R9gCOsXiYL8Gkg5tZ9Vh/YA15n62OAbOiDhZCJLc43/u+NWsSUg3SlMckl7sOULhRYVh7rIv6PKqlHw0D7O+qJ8uRPf81a19N+NQ8xoPyOmL35InIb9CbqcxJF4Te8W8g9LLlBJu7IbKhflfYLHcfIOwZfosbgaQIzoWx8c4+bRAlkq9EUl0SbkAn+1OEjKfFQkC5uzCGEkklb3oFnPiiiG+VvwiMj1UN61IshWevxpgKJUBBirIRZtAqp/NjgSJsDlvyCHZJm3CU1UXodL8LiTPidgG5yhA5NWun+m0CO/fu+/x/2tj2ms/93sUUZTcoYRGhvTqtzIqGdqWrpnxy3xp8PBwUoQj9eQMG3WwsuLAnF6p+L06GoYHbBVuEBQ7PI8NSR259AHGmmZ7oKTbgctE87t8SMA4awYTro4LoRgFRVFEUSN/g4yqoJRzHaiO0iDywy8OCy96FAX1gUQy9iJvXYDr2aPJuCgDkSyiA93JuwD4J3Y3ZvxdBwYY9CD1c8/fwhwnCAvFzKxCnkPEMEP5PG//E94km4a5k8X+/0XD7lPt4dHO9oZzj8OWY8+LKhV140+6/+MH/9f1Ph7bjmf/v208/s3cFh70NviD0CNVeBh6koa+a1OvwlWLji+wXlfapLkz2XnOqEoisTOIogKAMhEJoPfeYpSGaAAhKbni+Du7W0wcALOgywI7hXe3vnsVVnmU1bJwaSPqRRtMuDLO6b7q2Otb1ikdl1JVVBbuBiVT8rwqGGKfkNEdnLRWxyjLUxZgjHLL6vSfi/Qs/j/Kzyc+P8TPl5531NTGL8UC4Bn9tbQ5+nrc6Mzhu52eHnzf7LJzk54Cfs/w8xM85fh7zYJ8rn+fgPVzagswCrLaLKJdjljQTopY5eDiSKrrIH7KQAeucaM96FLudIoK4BaVdXLkg2KhjBTtaz3soI3C7BJSIj5le04qmZRuy5q1mv4yndotWs1/BW+X7j8r3WxTUW6ZOHyA824w95lGI6m+Piq0sw/Jo2VWP9EyT74xoK6jjRr1YcfdIeyB1i+4D1K4gEVBxo30eQSg6oIx72NIGlu33adPLg0ttAr4FRsyTZMdcez8yrkjiRn0NdSHYESHnnGaDqPMDmq2mNWcf1OIhIP1YHYhQd6tANiWuMyVuZiJOTSY4ewxiUnGFexir2a7hsNg2hOA9UzDlK+jyvUHOYAMRzrcj/v4wJ0x67tB12LZumGvSuZZPtE19ZAyHlO+74e7ffNHu/37fxZWbmkS0nbbi77LeRnljzmb41r0D4iZV8qOFAye/GXKEXDPlfLinyM0lg1cfsrBun8etNZFHDTh6lbg3m7hWJe7DJm6hjHOgTKfENStxHzFxjSlxS1O+7U6JW51sn848jo90GmleyMaxZtVlzQLC1N369PQqTbbnTKogOE1Tb/RsKk0vln2Ibhf/TGap+yosaipI8cyJEDM7ejSDdGlM+r89UcUe10TTZvzooVKXdUFrbImxZ/KN02T8iCUXCg4U9mj9x/DVVP3s+sMpeFDCc5d5dlXDjHuE1ZMCoLaKZnR2CS+IReDboU0rDv83ZEeokBj4SsZv4Wf2lkMG2g68/xr56ejyX1GWYOa9JCvP100xGHiqmZ4bg+C+bPMElKrBWIOpx4gCxOMEZDtrT3wfc5CXGGjH4hObImWpPRxi3KIaMNEmX36rYIYq+VNohI9QKorxwDrvKVMHXguEQICOklUQr1qIezTXbvLssfuDH7oOXyGjbNj8vVUFDRFz4QaZfr5TPvdXwcKJCKtoqvlt46IcJKhscZFKb7WbLe10wg9FMO2vuFDGqSM4vezTYM7UTGYsDSAuPpgsF7DQc7A41XK7OkG+Xd3cx/wXoWbEdZ3sgEHyMooOoN1KtwFAqq9xNWLOVA9o6gKAPJDRz9vAYHBTnrRRHMpLk9EnhBawPAj8KBSHbC0KqK7QRz9vRT/zFuq6BCfRdRi3ojaT0roezKHHsqWPRAtH+qGyPltRoiV9WcaxgVyN6iChLvtBAmYfX2VHAUz1T63DqySIMzl+MB0GXmNSXFSZ2gFkiavgyynQWR7ILO/r5Z6aojsnWh/o6n427qssIEDCagG5R11FF+pUTXhKmJJfVU953FOMr/d9TMbyphba4tjAbiECK6wWsiTHyoIfLJhGjzIQrIY9U5Eg9Gmvw5UQn5rOGgzF2Deha1I2rJJ5ikoRymn1xRPUGpbC2iW9Nao7M/LVjlqQSyFaQivnV1XwHaL8sU6A0JrtjRLFvn8pBDam7UpsKVDn4BUbN0H66ZgNbTSvU1J3zKucaVW3CTib+9FPnXp/es4sn80VrHx7t0w1SDcr1yThZqqWvV9wsqmE8XJyV4k2+DAlpuZgULBxzXs83akMi3jURgeYbmwvuIohSYlAKVNqKDwDf4wt3NAUlHIjXrHwc9/85z9wM/PFTSMZ0+WsKbctN9ZzQf19OlX25G08zspn8KC8o9K9DI+FfLY/eh7I1oTmg70uIsQRFM1BrLiwViyK7zRVk7oO4z2PERUrgxktMAM98qEMUAeH9fzZmtIKMFUABM2QexncQe3KK7VG0gbkb6wP+CW6qu3RoooZYZ4V+zOMO0R8/FNS8hD2ZeYZEjlOr8IBD+8c8G6OPKNiZWgcFEZGJd9jILzZUxge8hSI1yoQr1YgPk+BeNU4EJuPOxDjxwOMw0cKx2+vwLEJODZH4agOZYHjgpg/1wxbvCuMHQtwtFbuCh1LA5nxdHERlpGqIZAyfO7e9bc+FBRC1eMNuT4dQkaxB3MH6z+YQUj9dnP5PofPWlNhevbn2MwXdVSJWHGqZ1RSEENrMhk0RjaXCxrTD9ZMZFPYgDwVZixvWce26l5UvPE4T9UYRkYdnIDPgK6NaL/xQM6AlRu6e4gzWK1mRu85umsFKobHPlaZthZ/Hx+gsNQIGEuHOWN/bTSLHoubnB3XmqxfU6x1PjSow/laohKDiTCnIsQN1YzpJ3ld9euEbKvlNo98HiMBhGLacJB9QCiXp15OZ9bIk7vu2GTXbXdjGUZVn+0AkaRW6tAc+AkgW6ctqggduBBDW+CiiCdghxuDgsVwJx6LnGlJLbtVAE0LXMkS19eR9gLV69S+2pqKnpGG5p5tTp1SNK48KCA++UZeW+JeJ7JY6vHwkb+u1t58YMUSOrNEHUwaAEoGrYsYTi8WbJ8WBWJwiSS8loV4/5Vq9xxaVxDs1a1uR11ObmYYDuSXQzHMoer0cjTar8hGuipw8JRRUJvWYGCWaV66qpiW4Qy0zRGVb6uC4KHJXXiq4CRNmRFoUdeVBIKQYIxSbkXHrOejN3KXXbCLLl7WliH0IJpZgjbjAeGP65VsgmJ+Xi1Ezj79soU2hfvXk/7y6mpFmZRurEuzaVnNiqlCFSvx9AYMsi55AwBJWUMzbnVpAiaqkrtFymj5iJYyi7RZLqc7yEUO8ax8BoMAmdGMmhGXHW6iE+2w298ugIKUMWAhCVSmjGGK6LZLv55GLZGkBfz3dUMx/+KxUsxvUMyFKsXU7JZgLowTzMLbd/Y3rX7uL85buVhsxXhl345+aDisdHMRVXjZ3+mNN/JhyCtfNPpfwlCjBn940gV6rkDR1JICOcpS7kXyhb4PeVbw79eEji8DFjr/t0zS8WWuZEuFjncfKR3fsgkd3zJJx7egM1sm6PgWpePLtk/dx4eOL06j4wub0PHFx42OLzwiOr7oggvjdHwLzdLyBB1fmKTji4+Kji9O0vFFWgAdXzgBHe9SRovjdHzha0rH3/R4Xn+DXgeHvezP3mgvu0ESl3vlLbh7y4Tck23y2C243/S9cJq+C0GIv2b1XVQEovugd3h6eVkMS9/lyR2HbCCFaYZBNcPbRzKoWRLfGibp3+xBmqAHkgE0ovRqUei+4K9hMbx/OQZMmnVfbaxZEnvPeGx/92hVC9WauptWZGtZmFZJMhHp5AVfT9fiF2t9SALk2A7SAgTW02dyGVhjzLUvubLOr/qE3qgE9EJ66q4qkWcUtX5dEl7kBZOCq4qOk8iM+i8tz5NDtYFQOXsHnMP+d5kBDdhLXxHgxaGnU6t6QyOJrvNll+jJn9stLpX6l9oheYis65nivQmeFhIhqHiL7JsqUG4s6TorarSqlAK9RWfuquWIUluWPvYhAApMgVEgzEEGd+GgsC43X2b5+TF+zk0vwyzsnnhK5+rbnlIjqLhVr5KQUWPJ5yU+X7CtTLSVTiZnfEIVIHV86sZaMwupOotJjEROa8oT22UIPklZLJUnQKkmyX5DxhW6vNgjHQ0wJ+4QnJ6nRfAgM9nd0qSGFvT+JVcwNVDw1BKR6f2SST+yWd5frbROc0jTaKvER7OVuDebuMzFqTpOqcQNMGqLst/UQx2Jyn5LyEBL1LzqmitZm6gtATryj1vNRHe+cv0AqwhQewn+JOcF+PPizh6P0IwIJbQg4zG0OlhuGOYZ+aEhrW8taqnGNYbN6LvzXs0gMfaolSWSC0aWvKsdJF92m8UWdfSl5SwOi5Xst+2JL3GacQ/Xo0X+r8vFm2soSwDXirj9sl8PWQO96O77Xvn32YuHDwX9aC37GEqDxLiLL7oVtmOlr3dY5uXqWI+6ygEmhj9dRPEQ7mvE0DR7Uds3xIqs+mmQFAEoqEPFQ5FruQUMtdbRcrttNlSiTcsDeK4AqjeNurGBnsxOGfBQdXfa69N09CZmxvQpgZm9ZOl7K322502nfPjShzGVQGldVa9Up9MRIWZVwvZWT6x4POOf//BT/3zDF3761qNGC0JMU7gtjwls2UulGX+gljPRl33ihvLuKK7cBdlfvcEc0PnWDuzF6w8FYCZT0F3vZaw1G1ANrQVpLzNRYK6c1dLfrscd3muC8vqv8O1d23u9stfmkHOTbWaC9ehgAL077JyuINGSw/XR/ivQBOFryQenYjS9o+zzyqfgyCoDnHR6wgpahHvQMYVwiynF9Ak8nIfPoVsP59ENQJpfm3qyFKrNxTzV+8ccammT+MQ0xJ6ipm3IZ1yJHeS4MYCQdoOJeSzXVbBN081JLHMRudWN1ae5tsW+ly/Rgl63/aUSkEMHd5odFMu0fHuxzJOMugNnIf69D8/LJoZbIktlgp21NNqjJrf44VpYk8mGwrfQysOfFWe4Ev/wfV6+ImpqBUZFb0/yN5wrDUWh+5rc64e5nHuQh+RFWmYceCXjJ2YT0skHz6RCMapzn+bymubVTuJj7KllmHCpLdC7rnLLNcBtPQkxQO2tQme3MQPD+TyaOYDnd60JCANTXkeVex9u+LqL0/4F0jW/xt3MV+ycWhFEqHY6NTG2qzXQgJqtNqC27DECa0YykWifP8/k9wopvp+h0tHStZv6gkZIbaPF65XZnhkzT19XASHTmFXycTHyGu7eS+Q+7Sr1EMWIVo3toXXXKDz6fs7AVNc7CwBTwcW8DygzpJ4+gUD2JiHNq5hOX/Q+kC4yRtSuLyl6U96cvelrsuH4G7fh6Fb3G587wX7jR+qZvUyTGIbON+/eKzg0ldwo67Tv20Qd755ygiV7ByopCbBsxUxaKrav80jbZKZ3rDoKeV3pJM7whCDAsyMcbhiCUPkCYAFBaFO4gevaG3kHt8Tc4ly9I1fShnlDGxYoIJvhGEyGz6wXkWqR5osUGWP8ESiIHtVXqUZngIP329n4IVBgjGp0FQNFnayuVGMFFDChFaUaPTOrutQD1WhUJlBvjGrM8zfUE+zdAqRsGKqxhRpIXqBolGrUDNVYEKoRc28XcfQ1SjUaJdVorBUrSjVWQStWQDVWK1RDPZba6dtWqpFWqcaKloebPCXV6Jb9W6lQjZ69ytsbpxo9RzV6U6jGCjWFaqyYE/7pVKNnqEbvRFSjN41qrJoxa+jrVkDINGbrONXYSqtTqMYqWneNwkOoxgoaOVuR0M3SHG19n+hI0qo+2ab+nLmESKGSCcbDPBohEBSlv7qpEICpg150vf1HKqb1bsYL61LhofdeEaNG9zQnrsdKsu6Wf/YGq7SDsUVTVE2pVYDiOKWYBy6G9id6T9BXegc+k3y5GvVCIpc3mU627Fb2zjJSjTL5+jky5GHJGTqWtgwNDIM1klrenHfmoCAyDFTto2rIb5va5zL7apA+3f9mvyPM5N8lTePnsiR44XVBeW3i/MptQsgmbj+fnxGbKDm/ursNJ3e3HD+yv9U9cGhFiiHihA+o9w8vQxf0EHFU5fhZL39VdG2rNr91L5qC1EDVAMafTTKbjO372e8iXYumcA0bzMvlzm0FL5tGMb5/kICCSstl46TXFzDdXHNaeq+4XYkJdAdMbbkyzKLJEUl7E7w7p3UPFJnRiQpVJ2r0lkkTWykZetcke72kQ81hPut2YHN6G1OYv2KeF1n1MT2DR4fl5HLFrVyEhtRZlzt4pWoXY/FuA7A67iXUoUCXHVMV7Dzi99vP5yUIBCFw10Epgwpd6wA3TJpPITqzqDc2FuW8Y7HSHxfsiMtYcUVYiaQ61KiWZEzyZVtEwQR7FCidogt2oym3jDu6bWoipssxRxRYLx81Cdf30AmUfMlttCiK+rh9KPf+iB8dKO3zgzBYfD9YX1GDpFfhlMgxgdnDY2VWMFm40ZqkZ7+HSD0KmRM0CFH7bgotMyTve/Ce8Hui1BJIf4tAWg6fQABjmsfH+E5aZ3B3wbzXrO+Tg3uHRZPPxNQjXyQjT5Fxyds5AlTaOKIqszXLfOn+VMYyT/AI8wY4u9lB3rL3ShuU7O93X2TvlKZ6LelyxRbd80j0nkrsm8tYqsS+W2OZdBga5OT6rSO3pu8MAtiEnnpW6DFwiwjkKfucyjHZXtJSHuN5CGfhcjtvFUQGlyJCUPiz3JEgTvpAtjkkl1eS8nwwK0Mk5C8GluBGV6mbXLJEMgXtzRW4YsQ1nASP3UVjhCT4LgjPRJU3F1RRbyLXW5qgfSIIC6gJZFHfmqqeKeKFQH50MLMvCscaAyUIyUlRh8sb8hHTJbwwoExxOsIJrro4+U4FIu6qC4qERr+zLl3U1/VKk08IjRwMpO/02VtN1fExPLpQ8AF4YwEjPWKtKRl9Vzcu1mlfqPqyQelBBgVBh6362YPmM5OgDy0mvNV9OaWk6S1xRZ64rXozMlRmeFg4cgRN9Oerhz7JcEQzBCPKdshQS98I5ejYrp6ZuzqEW2ulA8ShAjPGqw5rIhq0nBBSnY8qG9RgaMFoAR5y+Qkak9kQNcsd/jwRbMFE5nzatoZYEnKynKxmr91kfyBr/T8EsVvnQ9vKB876GlyNdLbdg3XO5QHrOJenVyan3pDMo4nbk26pr0szpEly7Q4SuUF5jXGYN7A06uVfqCdOkTCVcXr7EgwGTUSmZL+9lB38oNUNiodYhXh2rQ8G5r7k5y9GorfvyfLvcyx/9Fqyv7Umaz6PC0ifP8tSTsTvqUa/uYymarTSTr0VOnGhU++EauT4jVCNtN/zkLq7sLd7Hg+5ii4CPcLPI2ck1lzE6mcUZZ9Ue281E7VHMmusblurmT81LbPGgpMPq4atxlhV1dGT2wTXiv0saY7elTZXpCuUVuuuvOlAC5nUu+fky2QYZn9opLlIvrdWasZXNV7RNvUOup4emHBQENh2hHgorwZc18pyoHsoFSr614fZPbrcYUmBQBvzAFU7Ji5AZdk6j4OPukoV9Aw/YnjB2GB8MaAy6kNMXYuuj9CiyrUm5gNqKP/SHj99HPH7B9Q+rxyO1exJ/RHiMrzKpbWKwZHsn7DOpD/mWtcqfG2f/zg27tG2602eD0lMKWqACb0SCT3FTapdOUKc+Ig1VCu0g8q4o26//NQvPy0iIUucPVIqdp3eT5/4Hp4p/ywKoOlUmtI8tlTSztIeYh6UFhHzEJiNV7EnicCdCIwQ08gFY6xzFIwkx5bWMo4By5iKxpbWKmfXf2GeqJ1qY4h5krQ2MGfA5PUf+FfjYi37k4rJjAQXaCM9H2pyaU0u1/UicX2DZaSGUqfq6anE7nGRby4jSSIjalICwk3egQ3cYxkM87pmFZqlfgq1Q67rdY6WjoFspHKl0x1eqn4JijDdDt3dRQcMFQUau5v29nWjFCJ+bIkDH7OHbmq9BXo+OmhSglq6fEiCTWsRJ7EWceyRWtNYxOn7+Qy60qYZ9efZmgBUOgYlHUuMegALGg3DmX3ZbXip3XPXwkG0hY8H+6hHrZFZjLEFlAbpEShOx9ez/40P4eirCczGwKbC9KtBIUD1WHmYVGdbzHr5eeIKiF5k79eUMzcH8IDrEmg2+PMixABO5alr2T+r/FVUg9TyYFC91eAoy3/ZOxykrw4C3DErpxmN3ctNSMyJT78zFvEdsUwVDgl6BRzcuQbp0KK6zUL60UUTOGYD99rAAxzoX+8/1dtYdDKBupEJ6OX1Bcg1ZUlrWo/MarCzVT0yFw4Osdge9tvPbQeYBNm9emuHWtmfKwVSPsvUgA/wbMFEDy7EkG7Y6qlTGYKDZk5O3D2fsE/TDN3HsnD1W2rlXrSB+n/0Rp7/iLdW7mOJz/7CvMTWnv1P+6GqN3jwVQbZ1y5A8e4moOggJCuGLhKBu9JSI/hpWaQASi6RThZsHnCpJ/4+ivnkjDfCz7zmQs4ETTEwiHyrPlHeGlJjZcOxmcFFo0vgkDQFAbuNOMTcHir45UUxHIG9ANfsKb1o3Lpv6T//1dt+Pvj9i64E2BirL+ScGF1s0xmAcmdEDSwVyRCFDiusfC/7S8VwtbsUAtxhtZcO7LXsPuGr/97zomvl/sti7uN5dFGuizF2gdvJ3gzw55FhF//Vabo5oZ6umWXCeKBW9veanoLW5SXvCDhsuP70AXDMQdGtLPx9t92Kf795cakzecHewZCicmYOKa6qoQ7vUGX4cFiI0R4pCk56B9Xvh+l3s6F7PWu110vtRPEVjYEKsqOEdR6GV9VUvO/Opp2pHrAGalnn38qa/+DQ8e2w/9tYpf+pG47fii16+e6TeGFIHv5d48zIS7/oR/XrAmP+Ta3vw7NA7ZK2mlrhGXbMO8Bl3V87gLMAnr6y5HpiUAgPLIPirtGQMZSRskHVX3IIkX3xoLmtKFRnQ9+h5UDT8s1QzPFFZzIlg16pNq51G6E8YDKvkkPKWJVlBnrJVFe9ZPIlo1gknRONjg7NZl9+o7QE0DbhNs3LqSOWHVcgtfiOu6nDv6Y31APK/uA6vUglHTG36+b6R18FNcpZxM2W2kn9uziW10/ca2qA3r6UomcjKf2DqOkboxER/8UcDq8NdSpgKZmyHMliMzrhC+9I7ivVDzA6GJzdvC/qj/KCkOg/K69PtVnZGJGVqkzLTtGjbBakqrzaMkbpWqXShs25hx2KzSihhQFXJb5gfozGrStjxgUzF+y44CwwOqUOy6v5MTOs3iRjlRoYpch5OciXpt+wcMEtLrgiTPxS0dufr9JivpUW8m1TK8+cxrU0n7aB1VmiVUy9rcCQbRtDaEPPMrLRVqjbIBb6tLPcZJqBgHkp30ZLopMguLIo59jc7h7QYIlRbQ6n3vkybeFQl0Ndfs4PcSjaYcxa4bctfCo+kyN9hdF6kK9QDwUu31qaWQJ4uva1xg5RM0z6WVjupFmmtc0LlCPJYP2YMo5p8MVNxMxQJ3sTppIrq5gRs5YznCu5ACxNq8QzJ9lVK70Uu6TyZnFfEf6LUdgUlHbGspbKW/2b7l+UvXbHSRRln3WcPOg7HjgZqj+zSEACjSI5kvEe2ne1GQZ8o8jlcVblG3b3ofw3xeWGIJYNAew+8rs1CF/uAoD2mllTYqbWYzsBECx8DJtaSxy4fanU75F9QKe6D6i7fUBi9wF1uw/gUCKm1N0+AFJL2Ql0LjUsewRGBxo9bQ/ObWdOzOmDtHFcXsf3+NZ0lmbA+Wtv18nP/grfkJpNQmRSZO4+ubaNcR/JHD9r43WrYC9EdDBpOtX9gZdiUUBxeVapzwHxfgHinJ65AGvnhqMFJ2MFx9gPJeiCs+ecSoyTaTWwH2oYmfZxBqACfr8Ev3xk8c7Ar648Rsx4bZfVt4QRcN4XBtcqdixVLad+Yglujv4aLUJPKMJmUc9A78YzEYNFx5bIh6ZGQwR8eVPPQKDRD20LS3px0MbFtaEqgEOYGSt8a+Bnps8BRXpdFDoqcs24j9MwpO89q5fPSqldSEs7AP0sSv9ms9ufs+V7eUgzkKvKKhqqdmcHj0U9LgQqzUFNd50CPTRVi5cLFCGQIHPCmpwUWZyJAOglfDKkJY0s5XoRECmieYz3vK6lOt6oxx0imRh3gNSUGCfA7AADOpTpYBo6FuBND1Ow402ciQ2KpXn2GEzJZNWOAoqLjJEMDB24NQAv+xttAA+9RYxX+4GSwpHryyouLaNegOPGynWQ74WJ4MlzagiUfEMPd6n2YWtEvhGqlRU7j5CXvOrx1zR2AhtUL/u8ZoABshFjVHKrqupyu4jXc79apYfdg5p9f3CRODV0py1qMu3u0Isr/fdHxaPq9bvcl3xv5SIcNj0OSBW1dXw0LN8qikNS2noRHKHAJQ+L0MEwrGyP7oCYJPsj3cwSLODpC4oJh0fyQKZQdUPDrUNUda906wtkZkyXOgJ6DnZDGZLNekEezhqiI6YP/hHyT64PgLO2XLbo5GsY4pqh7YpfdQ6rvSJPu6Nh7QdC1faGikLSslDaO6DQtBBN9SgaVM03UDzStBi7ZNu0OoWYWfqmJ1NoXcytCyEdxRbzCIWDCiTJq6LeevocKBNv6hvjX95Y3RMq0ZZE39mWdfvCR3iRBXvUa/G92KTEDe77F/HUbfqwCHSfDoyiEAYyKIABgDLPMc4jFk8lFcC/QGRE2T+IXPrtkFCFFVOTTj1J79ZVWX6umlG8CJ00+Y7sh1UmoA7ZqjvwApDlvyt7mgenjw7G2cOo3l7F9MfscKAmTHGVkXkohofdNcUFtXR1lEzoJHK6dlBQyanyCzXKSRF8qHfxhcssJKeMyI4O1we3ojy/kmWyPB/WB7W8TBR1YZUGP09gaRRymKv6NU2EqZwzDTODJwCg0DAehKw/Cs+Z+3vQ9wPH1mbl+t5P8kQwbg6sGUw65g3EcW1gXfhdrdteQ3pfQsQ9lhX+vHKlADjuGGBdkVBIkQklYAO9FP4u32qIVURJ9neWmcCEaKn3TI6+xSxCrbXSleaIGhGm1QGtr4YmQoooXgRyDkBhMZGtatFAI8sGAmxVb/3vzf4eRdsLCRGF8B0g9zQTVWZ0n0IwwIvxA/igGhsj9guq8kIeKg5UObHcOWel3oDnea9QeYasK2aKQnQhAAeMRYTCnxDOaIH2bBwJlwSy2/CLLTLz9yp5C0aTAqUml0+V/4as6g8LYHi+0DxfrlTokEeqcacWaQMJPZtYCy7w5iY96aLuZ6sNlUtAqQ0hA4sHyniAm62S1C8qaCV/PxHBP4Bb7yPAophkf96Qrsq18vuFQ0xK7hDFay1niaGkGa2pRSlqoVhcrIWois8M/kHA31YHN/ikyIiLn0X4hfkctXi7LRd0sGME25NdymXMPvcavecLRIT16Nh4NfBFcLogN79xj1ysPHhUF6cKnK23/8BaaT9rkRrSWE7gYi7trRFbkoz5XC8QX1A3O6P7KJN8s89U5FATLPY2bGK4uQWIgfWi+uUO0jVqZl+S2bIoUVxJsaBo26b4AOrEFTDl61s8AuV2V4cgeJk17VIDH579ox60OPS8K/aWr5vU0qiJ/XfoV3uih+1BJwq2c6UfFGIksn9CYc6I2AFlEDU/efDbUcRqUY8f4FCFpwthgeBHIGAB5GF2ykTCi/0/X19iW6gw8NS8Vk2xDeRWsC0oUS0oW5AUYngnexAphfLFyiV7IpCn+n614wn77mq7jSKVYjYx8cL/SSE34n8WOLRPYX8Z6pSX9FC7h9H0ZBzzqEJmqriuiN0yiN0GAlukDhWpTWdg58wsqYrQgUNoaXZHm52hobiPQ/x3Ge911JHTnK7889zmfEE6ziE9sF6EhEYmwLJ0TO/iQ5YIaQ3k90sQBYUMCpgv+J+0sMa/3DzG9TX37lGHsOvCyNAChQKLkOYv6VEX1NKITDnJkySvmtQkGP6aZTAtG31eVSTlxCKFzyvMDjE90SR9d/CFxtWYd9tlpCybG/06XWSSOASpUUsnCdQ5ymmS6q53hjydJhGlOk104o3PjxhDoNMjoARjFJTXiFMOO4Iehx32l+Txn6J6Hujghoqi0gApHYiqboM0g21dERt0gdSmroaesYJgygCyij8qipYvvkst8LRyHJxFSgsFcbJ/0Umg9K+FHgdQ0MFAFPFaDjTjx4zYN9DrEaVjvQ4YiQDD0EZIPF3NIBSBgpHHKUWIyAihWUT+iFwtIskqEaQZEHxzxbkeqXc6jCXEqfKcobY821bfvWWvFNd18IQsa09E5B2porFxnIYlIPtXFZRIObG5Q6Rdj3QYzZGgAtkOrvXt6cHne12XUW+NpwHr+h+8GLA88O4fxaRS28Eefwfuwg1WrNy4zCtBPUoM7XWnNvPaCa2piTS5s4Y9/f4808nZpqYML8YCcv6WVNKi+kuKmJrAiJgamJ78pgsZKBjWTwACS0kge/z2Ae72LIu+ntv2oCygvuDifsQu30BOU8q4gwdkPhlzj3O6Lo07KdQxU3DqDBxVIo4p0Ltq4DS8qpMzDGLOgwiAt8ysTBCXWAmU8orGF8Qrp/mC8Cd8QfiTviC42VVfEGgxeL3j+4Lw1ReEfm18QThPRVzAtdN9QfjOF8Srb6r6ggin+ILwxn1BBJRYlx7ZH91Q9QWBBoWuQRNdCdGg0DXIudL4PxV873njYwLf8PWPEXy/8zoB30+tJmdc57+CibX5myndQ3lVlY4v1daUkAQy6XUzXCGxsoApW/bSPNYVtu60IhI8EuH+qS6WBxGRQVVHWAL1M4pgW2NmXExHYzIXM8szb47/UFZAsYgs5/MmBTi3E3tpSikNxxj1/ZcVi5BiLvaDA7z+L4IxWO7DXleKxV/OD7F4tM16vIVqfPELd7XkhlMgF7/cK9oQWD/zVReHXOmc3DenuQM5r/cYlxrCq7iLsIbQVg4tS2gbhxYltB33p16CEHHIl1CO5kuo4ObtkM3cDiLhovOd8pLryynyUujLqfKyqi+n0Ty/bNWXXfKyTV9Ol5ft+nKGvPT05UxQUXM/7XS9nAcdRVxSy8+iMxUweDmbduHlHHl5Ap2Bl93y8kQ6DS9PImSk4skUyvNcvlxWPIV2y8t5dI48z0fkHv7hrRfRk+hsOgsxF9AT6QkIXKhJNTqV0Ax6Mp378Gc8LhPpHJBMT5RbbpdzDZ/1UAISzqLz6TwOTG778MXZ+DlPPsuK8/kz24KQziMUw+UjGgWg9lO09qfQHpSt9V2h9V1AFyLuKRLHHasUhg9MYYi2he1EYTXuivZAPry6eCIynkVna+MRt5ub6QqrcaLkeQLncYXJ+hOaW4+BXhHZgUVnB80pA7EF91u3UBeRjHEc2fJVRiG7qleuzfhezU/LaeIfd5rMcCWdb0yTb0yT/wDTJEgxK4IX59vxuLTt0XZMCeIitlGan2GmRMYFzpopccYjnxJZdUpsAyqfSdt4BuqUYFwkEvTfwqHtEuoB4SS0CvTXCcNNOV3Q/3SL10/Ci8XrnfKyw86FeX7ZYucCXnp2LuDlTDMXKki+awLJT60i+WkVJFc02K34zFiAaOD3SgW/7XDtprMwUoJnGmcGPjTIer4kA0H/8N3ffXH1D8MOvHgiPUWw9+LqX7GHEwUJpTpFmvPIxp41ie9mzlisUdx/ssH9c0fQ9Xx6MgoE1joMe5Kiq51wivtT0JUeLbqeDsw83aLrGf0MJGkbIhkvDFVXfa4tegn0TEpBES1q7WA0DHl08AT1ORNocxoxJTPUdxdHbRFkOr2kqmdwOacKWp1KZyhW7JaXXRbH5vnldItjeDnN4FgFeXZOIM8pFeRR0J0zSQcVROcotVPA7FYoP6GkX0o3dOxGIcvRZ50cZE8FEE+1kN0BKeEOOhORDBCNTOFp98UF/zC42Ia0SnJSWgCQ5oQMNPMA/HZ5rc6wxIbFDRz7GvZfKFCBKto7HoKSfUkgQBTuRNTxaYbeA8WF1Dqf8M/7e3XxxjBD/ahfB6yhXoSFvMfZ+G0V66MSzFzR+ur8XHlS/hTF1tyQ+vx8nXz5HjFtsgMb/JoObw3EYxWPU7XY09yqiDy6fM7Ja4AFVDKdwY9gdNE8dQQlKD9LSciKvJytdFQIB2PsmXbRJEbbU9yiWeMFMMRT1r/iqbRbXi6ic+T5NEQ+3WCOWzQvtovmXosqpyvB0SWKy2SasumSaFbSPSNr6EX0tJJkXDiyIoZ0oebVhdLWaEjcU+np+E7XPbqY9uLtQnrKaAGaCjLnCtil8+ACS23OHaEzT3YFgMJo6hM0Wgs4iQXRh4jbbADn07/yvPg68lR6GLxMN4M+DmKDAyrDU7GcJqjoUQXhE4K4S5x0T5zuxnL+4Ry81ZR8heYsQXyPqWwp5Pu2EDs4MaiK21Hnpe7qcohtbkXiafR7fApk2lJkFX18fO7bPqk85ucegR9UCP0n/KAiLqz4Qe0egIFAEfhfzW9rJ/CK+rOf/JlP1kqvqC+teEX9GaRwJD/OcE5Rb7zJOUU92Sqdi1QuL3uNgjR7LZ4Tjkwhc81eh6QxX6aHEFdL3+t7PoQvQUX4Ejrhi0SHcA8bcZyCKpLxQC06DMiRh9p4NNt/FtJFmKfC1IpsJcCDY/mBnFZGGopUQ25XsNwisBUEpgL0eEJyFWwiehFntHKCTYFzRjtFcqUAl+ZWm7pZG4Oq4OoEGg/Xv25M48F/PDUe/tz36ieL4zpwRXw8b7/xyXv7PZGvXxRULw04FglFPOqVSmIZWhw4SiVV/74YePXvqwfXo+Mfoynq0VdHG2IqyMkwDwDK8hHqA/CN5QZW9vHXuZkRH8/FrxOsfY+eVHJaA2JwGEree41QmgN4rV+Dr3NfV0PQN6BKUB720Jr4qR1BKDX8VLBoThXU/ptMPNi2+fybK7ZtvAvN+4LqFGQPCiQF1XDb6a6H9GYAw5Af9yOrtcrnyUG7gKJa/JdGi8f75sV/bKT4B06i+IdGi8f75sXfP1L8g5sWv7VmLzfxjD8od0oQMleWVnWWfcpclvjEJ68/hCL0vsRWmJkN9ePsNw+OfXqp509aGoKHsd/ShmVvQmVyibQm2KMGhH4QsaPmdr/V8wwEbjK2ibDwwf0KXvl2VktBUFSphHZcsii49OOvwWUYqDwo7lWvofzQq49/DcWvpbOOkvVrF9aiNF2QydDCMEF15RDKEGuUqqOm9NOX5onXLkZ+XtHld4/81vCzS4Lnru3PTZ/4U8OqpPUaCMzu9D9v4vy8Zp1uqftjG1KGWl6yN6JVGrxp3Kf6j4oru1cpAH1DULUgX4bmdF90TewVIpAeoejmbE2XGIBTlTel/RKBEMelOihC6TS/h9HRB5YNRIcmCvBAbPpdPOKmBgU38ERhg0zK2tjhx6Lva5Hqu0+K1N5kt+mwyv1mvfNSQc8bR9Hz4InR86BDzxv/TdHz8AnQ86ex8k0giD0Bda7R9LAoFPaywiYAYHKDTl1ZFwHWsjpFxH/lWhaUfutDNbbwY2hUEQl2U6wNB3NhkDFCra7qWJYxYIJhY2K7jPm6avn4oqXLlRRaP0+/VUfhoZaOpQuVSA0KBzyQlr0FDVoR5FA/ZV51BbsFqf9OoHrz1xuofuS4oLoZqUL0XgB2bro1WWP9UTc1MvnFVQg85Ulv0Yq0ylK05MXHSyFsiU53nkRPlVrMcb3h1Pb3r71mP+eqevrUpFbp2hMsYodv4lzPa1T2VV3IisrxI299suu1L9IIndmPrlO3fp13aofQNbWv5wtLnb0VuZApMyWfXzYphIswrBTaW41EU2dvRE6zlmd/ooz10zwfFuo9NFvKV85E6a0gZfbjurasgdSieEtvyUu/Uwq/T7qpjmfulfDqGsBR8UYp7u7ws1eCZ4nfO3wAp6CyRLIqx5r9SxNZHO+tPZbVceBWxyP/4VbH4cTqeFJY9AwvmIYNgZavpLFAA9Z0WB1KBBYllK9JHsvI/aQbuZ/6Dzdydz6qkRtnWH9G0p+7KcNKwpmu7he2lUoOdpewrjoZN+VZ6bGM7Tvd2P7cf7ix/fnHZWzfJenfNjq2bisiQ4iBVa+sz5aBvQg/l5RUlvzpw/uYp+573PD+4n+44X3vvzPR9R7LyP2KG7n3/Ycbufc/qpE7Gebpg5szT+dK7y8SVmh/aQNwt4wyCZfk5is6AruaZqSzxzLSH3Yj/ZH/cCP9q1/bOboqo9edPkcf8+L5G27k7v4PN3K/+ehGronNzm9L7Ns8lg8IOEX/mbfvOLFBAW7DBhfuIR5ddfEekjhAz2NVXO/rlVUVquOFIucsGt2vC4UOU7mxjbsputRa3fbyZEWwRxyyW6P4vtn1HK2lH/Ui6Lb6PJ6eMybskEUuQe6Zdoe68PkW9S7yCM+ueSZ9NWsKtyyoNwQqoGkev3FcERuUiCnCQxvX34Nm9c9VGJm8zqNbaEEd9F+O3NeqBkHFvu7lJzln7se9JLgfcHvJ561tPoO6j2UG/Z6bQb//H24G/cGjm0GXHHcc7SgmfCpOOpIhTmC/NhTwD9343fMfbvz+6GvGpfzJ5lzK+e6WzFX7ZZ7KBJXgbmFg1pxER8Q+a/gzgx0+lsH+326w/+w/3GDf++gG+ynHG2zIGbMpg6yDdfQxidvuc4P1mf9wg/XZry1XeZZKSqeviY/5GPFv3Mh97j/cyH3+azty6ns9+xoJSh9wI/eF/3Aj98VHN3JPP+FquMs/2lFmZjNKedB/LKP2T27U/vk/3Kg9+OhG7ak8ak7TS9TtAFCjcefDrGHhZ/+ihVuJpmn8y6Y5EUWu/rEJW9+I/ejU2F3TIlcnIt1Q9k23+nj1cbR3UPXoSNsOnTn10SXooSDTYgMcPybprz0rgcHqJ17XekVwXfyKihXDY3w8HWk9aigLpsDQ25t9ijA4N/ET2g036jMYeBRxyo0+F3zYR/h0fsKSDqIHHkdnLngLN6JiRwkQFo9DRX2f+APc+Ce2w2ky7Ny77/P/CbG/dzFFpX8Z3hZz3XmC5yE/b6Bub03LB7yy10rXm9nr8MyxXX6whpT6Guu1Fi112nNL8KKifQDKuIck24zAx5db+BrToUg8i1OQvR4RMMaKb4EgdYphGzzqHw70EiaCPoKi/z5PbXGqtxiIqQ78XdYreGQulS1+yriOn7Bg23nLfQ/mXZeBnUt9Dqi+YD+hsJd3xRLi4rOKLcaw67xcrfEUBjBAkXFbMGnT7A0CnJB7BtXQbsVkq9SVL8mzVqxgsvaIH6181d+LAIwK6NZ7tV/na260pF5QiZtTWg0aOOdpzty/lJnlW2EHVMvKiu14LBQEQHFoNc/leupqXvBzB+cMaWu+Ezch8m0U5jtpO1p0ysg11QIq/KfimuoO1hnMT6OdHGBN/l10Ku//TscrhwBSXEbjV6adwQFo1eNCxc78bNqWn0N5/gTIVaQzc/AY+AQSHftmoNcJZhEHUzQa45wJ7jbXkHao9vVuOp2V7c/IWW2erwucmZ9L5+RP4ZJflZ9HT+TuPIlB9uT8fDo330NPkdqWIax4uBbU8gvo/DLM6u9l+KkUlmEW1NL5CBVPo2U8WVP/ASjnh/Kyl/bIs4/IZ/DPwymGAp/ThXQBYr+JLqKnIrCvTOZbKcUzyzxfgC7/XuojcCEy7qWIrzUMfC71ix49jZ6OlKfRU+kiDkxKf/CJVHCRfhcUT+fvbGXP5OqlnL2EaJQg0a4N30T7UIF+fZePr6Hk/wxEXqyRQbG3WiSnIhOXvHdqkbiioN3C10d97pZ05KmIfKpGBsVF1SK5d8jEX17kirS3SZbxWKbz8Tif9uCxB/gAfD8PXkLO68fQiqcn4i4A48OT5PkkerI8+daNPM+lp8iTby1iAu6mHbpinE67gLhn4HEGnY3H2XQmHmfSOXxPiNH1CbBn/AQ6C9/xlbLRy6mnuMupdnL435gc35gc/4EnB66kFriS+iw8LsViAUTHTUCdEKfje4QTuY91NqYCPesAitvJdSJ0FmPwN/N8OJXnxWmPfk7Q+Jw4h7H/VIbDWQyDM7n/p3Hfzzbz4pl0Xl6bMjd2BYzMlblRq8yN5ercMCh/ES2beVGrzAs7oKHiAYZVUNrE64wr8RvILTj9M89+3v0/8N7PXWyfxdMYC4qnE08MILxaYLTP4hmcKPilRQMTBWE19qLJKYJmcBKh1HKaPdVOF8SW7aM+PVWni2bW6F2mO0+Xau1MeapWfaEUqZGjaL2LLkRp42itqHtc7N6Fxy56JrD7mQa7zxPsPe9RYvk5dDpQD5dHGd/Owhuux58BLD0Nb6fR2Xg7m5GdgOzfjM+/mZ5lL7QWuNB6NvgjoPQInp8rGH32Aa61XwPWMw7u5CLy/MnBXoOY9GRG2yR/Kp4grJzxSUA72s0o+QTu1rn5E4Gg6HzOFCEPGVGXGVHPBzNYQczlCmKGU5DQ4Z+S4CriPbUkpzp0lv5WMYCjkcp5LzjZMcMo7TGjtAvQx9DJ85mTowawPsmOylPodBkqQH43PQFvfIUQb+fyuGYYVnP99Wz9IKeCTnlxwT/2+it8W+d0Cu3gK+qgHgz9kLbjxtN2Iv2oB2uZT1CuO1QKo9SEXfj+Du64lhRlTmMPInb62kvMbvPQL/F11/Ng0gnswBkY3/PoDEPqnsjp/HgSP84ATUTck5EOdAnRNWa90e3zkA2N3m0WhfxpGvDzp5v5lJslyM/NshjkfQ34+TPkpj1wJqTd6JTeX66u8GhIUV3mn4yI6lr/FETscgs+GsVzzqz636QIJot3cQntkpdLDQn8FkReVq5h1VX/2XbVf45NPleaZlfbbzqZ5RwUzbEIl9K3lLRrH/UruCkdpn2aX5d7W+sTtdZL6DJ8qws2PZueg7d9dPGUQiw9rRSywzZdF3BZ/N0a/7TxQkAndQI5yuomEOZKaObKbpkTu+2F+jOM+XjdKtbw80xd0s7v803z/UwaZnbhxryaXXwSJ+xSg4Ft3Co+n7PwFDp/P0KX9TAx1AHgE2mR2nQ+b8AP4Do07dJLXy8R/oH4OjY+YM33PWuMoLJ/zZdBdNSTa234XvUzT2uIQA/LSDWiruQpR/evY0ChE0wTPKXjQgzORwfPp2das5pHt8B+2wKcIS/QIuR03EJrAg7G8WAak/9gSpGfuJj7reTDomI2fd9PHQBmSeGzYKQUq+TDtiN8xI9s/Bf3FzXd+ONuItfPAdn4A+7Y9qusgRtLXWzen4lHK98CuRtCxRaJL57JZGV/X9acLRv5c7mmJ9NCvkdqw8BRQKtMxW4JDgjErC+To/AuGt9+hJ47lEARHynqVK+YGH94Ib8QVewtlHqej5ekeCKDF6OO0dG+M8QDve0u01Ynvb+XiS0EU3R+znghQosLhZjLKoEZBv4GJY9KE3ZxJpA7Jetctg+0f6ag6iJP4PihYI22XC1Icr4in2nGrhLZONo61DqfQkRzEcucRDHt4SbCCvDQGOD3FHdC5+Kfq9b+Am+KXRZhQK+ATU9G7JOtGNChyAp1Ra4CuJfSlC0qTVk8eWnKCmREHRWqzNOiCFW6KlTplkKVrhOqbDFCFdivnv+/WajyjX3jN/aN3xCqfGNyfGNyfEOo8g2hyjeEKt8QqnxDqAJumTo9HhgjXek+LtIV5rsZBxa/IV35hnTl3166omIV8mkrT4BnMaYtGQHLE48vYDmPtowLUWq8Ri7TLmOMM6ZaRWYSriGiIkhxm1E8wmlyFMom5ShLKCKHY7tvhRylDXFKm7Yiz1ZrtD+iGWiG6D49+yoUaRQEmRpmSqE1tCCtyQai36LJYSU5qSbDL37/Y7U1V6p1PwnXBXv1syY+2zfx2erEVxKdVaLVjUOp1OLib1T1E1aRUUWcE9itmvDe3A+Ob7fqEnyt+u4HygvuqwfEgoRzGApjh9kb0ZROOhF/E+IfmQGs45kN8EfNBgTWbMBrH2f7JaA2mERq4NFZMHnTCfw8/0kcwxllnf8C9ups77M0Skes8E4ar8lovBllqVG9QYzf2+Oivr/fEL9DpcfIIZxrlG76BnmDS7gzFs+pTYrQpxQPuFTWBJhpR0woXhqivvU2ejhAtXWKzBwtAn7pFJl99QfOr1kxi0E8UomY2/fXaf5XD3/17zkcHOHW/whar05MwTEHAxtn21oGpIeHuW94HgqKiBeyQFwY1fHHxv7nleYsoJ0UXBDcGfNTW7wgLkDXCniG1Nrq6kDsyK0XBHchH6ck4uQSMRuxQoH7rab2m8jfEZdnHenllQUv0JHgKAcC4+9B7fwSauG4BZCLBZpXctGgkBKao7kB95J7PyzH4/V71x8KikXkrm8UwfqA36K+32fk51nOHYtexmkUvTT7WNXcofO0SMF6HmCwumJkcd45DFuSHcqC+YCDSJeBpFlui3zEo4mRo6XB0KLLhwaFr56gh4NiGZBExpZmzLv8ta/uoaWM7nA4BBTF3/YypZzHjKtBpuxmvDkHsB5gieYWC5cqua34I14Co/KsvEMLed26ieo8U7JlDPFMvx7BdueDP9aJcZ5/p45g6VeWJw8m1yOnIr+3kBrHCddGPB19fs7ze2kf7AHPOQgTUhlOdUMWsTmVlpLUVVTCQ/ZWHua471EsWnTxebKAPSTuneKNdeB5/+lrRbKx789/YOHnvvnPffboyJ/wzrZoZA+L/bEmf/AAf2DfU36/r/LegrRdOuemYN4uaQI1NtjXuormY+MdhxpVl96euMiZqXw/GOrAi4fEYpalveXQyWxs0yxP+7KE53Pls4JJ/GQkxQgFFWesHTw65FXG36MMa3Qm4xn272LMT7M/U+c4FCoAQwB6gd8W1jDkcJbnZR80ioK0pgnJvtm/Ofv6W99yzdOyDyEpn6MQKYwdA49C6FVmR/Ubil2cYozWlGlNsFAjWrxzcJs/z49VcAVzaPwiP85lVkHPDizA67TMPsYDao3DNlAB3XK7AjcP64ISFgtdjzyGBKDlTUKrCh+Qslb2YenGHFuFyWM89uQdTrrZQ5qCrovoWq4dCu7yqEsZ/OXsZ3dSrRcVK2sK6uwjKAnW+LM/x3fyVdHDLFzVk4CtvnhNgrwebBpatI0WkLKdlvCA5fSctpa2+om3na0Da0jaifWcNyb3eiZwzAaO2sBdnsBntZ/wEjo5j/JTYKsa8NpJ+Vqe9WEAqshPA0XLTzVOnRRpYpCJDm844Ik6lk0CnWYClr3ltBhbpNgekmTC92V0mjxPo1PFlyStPgeJIfYznjyO4nsJHdPHvYjA8c8pnI9O4aIHHpozOpcUxdA2cTjvWV+V1jz8qbQKwErfOnQqTuVi+ayjn1ChzyG+3Wa+tsz3qpKx7bTDrMXruadFnYaW0CoIv5RQZJShNA8AkfKOVLHMOejOEZNTgUdhTQevSIUnM5S0lVbAHO5ck7E57cRDW/DQypiemmcypsWJxrQ4hU454XAWj2UYpw/haXYIT0PZp5VDWNCqnRtUoPPxfp21p3KDzWjGyjcFGEYH9ZdbqIfksd/X2yigUzljxSVvwaTzkId0TcO4YS4vmMl7h0zZeX47xG86gTFpaSd6j1px6nzIk9Feom72q4Z3nMOmJcdjoVhB80FKaMuafpvvwPsqQqQEIQZBAP4pAdjOvcqV0p0MVsRkEKIQhNh2PIRYtQixI8/oVDPRVx//ib6qGLLtccSQwmCIYl9RYsgqbQOIt9Mq0KMDz2g7qLMGpMejU6IIdexUV8JvUSUDqgj9B/R01pPOdwYTd0LKOFUwRIvSCQ5qxoCfOs9ba0XuZnb3PB/9B3jLLeiycExwhuuvYW+hwOdrAdlHZc0wMbokpdmv6cqqkeOrK/bsGfkv6Hvfh2DXAPDBixHzkj6fQvu0DGqzTAmL6mFc2L1qE1GNbaVbyLEYT4/etTbWJ41enR6dTSukNSVrOiWuORnHbKKzCfv2MIAf4mCay9FR37j9tA8nWTNsMrnBz8ZlPezI1QYf7IbD3QDhhx2R/j5amf0BfvPQ2rXj0nah0I19P/zMH7onvz7Za12W338x8+y7ca2Lagycil/o7BNSRqzc6iXC1arOygUBC3IgoShRgXuorGadAhUXBGCY0JFIt/wZBdknUeAFwfPMSVug958CdRqWkA/+PfuU0iIxe1ckeOzVW0smQy5xSd4Axjwvj7VJ5DN230oNXA57Gdxwbph+aE81NLDBwUW8n4nREh9zwKekamRCK79cDFJwxWLvQqd0RN6G1THZO6SQM2ysZ3+ocJL83GJ/rQQhxeuYb6YSrULLTtxeJaCg9LCpaBJULQefX3NoEK7JXS/exPYP+nyPHxWvcHxWxtu4E8luYNj8kdgcf9DzIYkwmHrvnEVVteSh5rX690DHhys7qP8evPj8wFbqSGNUKuGox2+MIMyzzzHJqEDOIx+78cqGwwR37V1X5tjtZVymO4Y6GgL2qLKbiEAoILi8V+l+kP0x8mnFfQ9zKfsTAR2ncf8c/P9iph1d5+Ea2bV41mXTBy96jVfEpYURv3QiDuiKQ3KGxlr214rMGJ3DQZEIjcb604D3ELiH1XwQK2K5WchbIlARB9ABNSCLaEA6MSzC8q4Y492IwGBGdsIbRbZe3is7keQgwXR5njS0CCmEgGZ2QBw64kB2BJFHBnmIbEk+Jw3J56VR+UL/mDpsmOWvYW9V1ziuD2sS/5g1roMes+jjCGXrBW+ROPewFFesc2nqvrZYwhIY4WxG4EEc7FIiKmHq5W+FFhk6Pbx0Zd3fWmIUBD2W7YVvZWoLT4LJuB2qZET8CIvcqpIVcBI9lO5ADWwH0YbcattJq/kpwV54OKEV2imLcoV54AWzK0dgp9FyHtGS+Ipf4kpljT2NM1GEdGQ9TeDAuRKsrYk6EO37dAorjfXyXViTcVB6Op3OueVNTxIU9PZZnMGpnIJ8/CCfi38eimdPNaRNy88yAwFHTmgChgKt0GzV0aDTuJGtG+7+zRft/u/3XWyf6JupeM832SdOKE4vo3/VPhF9NqL3imzIPhU8JClXrDz/Pcc+YJ8u5fuuDs55w5b199knUlAapzEcTisPiz9kn+gLuo9WI8wP/IcufGLPoQ/+9b/c+QH7lC589F3v+cDb/i5/un0Ccoh/57fdfvC5r3rzB+3Txh9e/O0tA+9fnm6fNv7/+08fXjrw4f/8Ifu08c/+Dvz7iYvtE/HaB6genD3RyGs/+bv/9cI/+szT7FMK+dztZ77hs5/5rx+0T1v4K7/yru/8y62/8XT7tPGffP6HuXFnfMg+bfxPPpjNzs5ef7F92vhLpXG/9iH7dI08h3g8PTNh7JMH81sn2W0ejU/B9c23FbunJD6RdgMVT+eB+x2u0Tfx9snffCuhgIe/jU+kz6EzCAWdQazro59V0s+glkwD2QI8iVG4zq9piOdZ4NT5eSY/M36ewc/d/Dybn8TTLhfZijART5K9xzVF9BKez07/E2SN9T/nhhIoQqFmo/qfp1OdhWgkH3Iws8F5qmtoOCyyYT7LaWTT+D2j7WBJ9PT+XLwkxVOgNnqeilTRLqa1HUPR2H8YRTJXse+lp6ja6Ll5xMfkCeatJR01RzpQcpV20PmcCRA5t5+hzg7O4DqUyxncNioohNooqdpopA3IE8qlORFF0nJKhNqrZmgE2BXnKvk+1+prJuBTkrIBbmNgT793gZAwFXsVPEPtRCuYaCoXs1BZbBdoK808K4/koCzfSpGKbRu68jWFyUIrfSuKvT5yjhYOsyA10XiwZXwh2+NnxHbm+QkB3bWUgGM6xK8w6n0jnsaedMAtRni1iF+sR0xFxBzMy1EA9mNI5hSOeikK6QdrfPp9nn+18H/BgfP8A5qTD6jWcMzzQgbJp8GpUnzAMLgN5Q5XdSnffUAPQPJYnOeoc2gsR1o50lRVtiEGAdA4tXEu5/8UqgFz8UuO1ntcK7IoTLVfXWEZ8XUPtrSfRwl4um+nBDzdsykBHy7F86cNqRTlCyv9N+A+NP8lkh/yS5k1HnmVE7gikNYE2ef0g13+1Tmg2jjPP4sfEIDyI8HKfJ5/EYJ6PLlHgp9H8FwJ3o/gbgRxZx17DgQfQuxOCR5ELEnwS4hdleCDCHYleBMyLEjwEIItBCHcNpYcDlBd0DT7vDZV+4NExOrpqzZwSmyjjFE+O2Fksyj4V+FmKKi4Nh0Vx1EwrqBgZFHQUxTEMCsKRg4FGfmAMjpIB5DJYZ1H0XSsgzgQOxKHaKFQmxLRAoNoIXmKaJEiWgBEC8xGZBLRAv0qYAHTcRHNU0QLUf4JEC2goIponrTGqyJa8HWIaEEF0f72cUa0nz15VwvhiKsFbxNXC8G4qwXsah4YdbXwgzdUXS2Ux9ERtpr/Ts4WfuiG4zlbOIzUR+mU4IdvGHdKEFadEoQn6ZTg6sfqlMAb1S4IrXbBWzoNX070QzlG9K4L+M+aJ6mN7KxVmvJslabs07e9+rYHWHoby27wvCDYJbvoXdhEY5/GYK5uwzMc8V4QYM37KGYlcOJHdW+qu8DYiZf1Wk18weYfpbqjpaKOx84iEVs1evYtu8QmBSgW9LCO0tPbhkXrgoBQLqXDIjWFU5PiYdEUWUxXI44UTa1yj6nxx3SfTuYbpOKhBbepPRjotyk1ENOkJmJoSgktLSHWEmzTKLUltLSEmOLpJYBH5C4nVkjkjxxvqnwB0l0vTXnsZiaEL7Ajjp99ArB+V9izhGYEI9GYHM2rA25oI4BMGflHuI1x9hY0QXHQp2xQjamhkSrnVxp/G4Ct36fUmvi0tdmnnbxOIk2YkQVnRlpczJo2gx49FwPto9V1dPblwDXKjhStEVDE1MJSJ+A9ghEfDKm1XlUIaSG6NWBMKD/8XsW79I4iLTvPWYomIBBROtqN5kBjpkMgrUAgGodA8zgQQE/zRPqdz6Yy4gyTBmDSoFkSGNhLdHBYxbEwEV+Ez5Jux8N8jsdU5oBgU5Y3VWAS49GdnJbu9UPXwaZQC9BMqUmtI8X8kGIQ0SPFwnBwG80TRywQh4vWOvB8SClPJql2QHNHGMQ8EHdYXRVc8xsFbpMi6ayqb0ACOpoelyz8C/AqvWhTQAtcgfRigKGBidw2NyZGATw24yMTT4zMLgveUe2YRp8A1RAv44DvAPDQOJiE+UUK+EQls53+HjFDlPAnEU+jGVUXDIgDiUMCaWhroqGbzwSRqenYzmqF3I6I8d9DyV0p/kjewjMjVHokT2kxb6i/fCj4gQ3Qac3dvnpNaBMjMs8EquvE4ecLJb6NsT5SxLeWmgpChCMo0iB94UjRHjLIm9qrDMXwBGIkGBvg0QFsURsoonlPMNgBJhuj1MCRngVKESETcJwANY9DgAAtHcqL8lkdZoaLMDKhjmfEHIteeUTaInVIXkUWqCyOFvgXWAYl6FIUn24xa1cgrAcSZAYKJxFyE0C7lZNDObfqAiDrmIu9TWN5ybWs2W/5AVTtysV40HA6PaIHcgv6AT0y0Uq8LXsritAo9UU5sSJoTs0IbWuorCkvoamg/TguVZU2fssTSckbjNxNwaR6ORkDpSW+1ogtWh6VFqZ1MfOJ/67sFS1d1gUUlHJEepVWeku8Rk1ZcdqE6UFtrKyMO9iqN8VwHEqOGGWLyJyxNdFzu31XPQMtCR6vIUw4JMwhTvagXfU1UaHs36J1BByoqlD+zOYqlP+mqpy3n6Adb37825FxO7KxNlG1TT9+gjb92mibAo1WflIqYfwozbb72ZuQWvj7dsvZmhIOtBaCtx/91Kn3p+fMfnAA4iIeGfIIDwIPqx0KUP8CHv1EOwRVAMamvicMvL832CtQpTD7SWHha0xtQ2Ad8imB4HPhHBO87ASF6Se8EGp5+BMgqZdemRTYI+u7Rx5E8iF5yh4jtYiB6RSCfO973wf+8I/+7No/edqVEFZRzPivClni1NedyOLBGxRUoy1DXVKoLrrK9kRUr5SIDMpJa5soyuuqs4XvtWfuxFeg8wjVEx9h7h+KI493H2GV2B0NSmIHMLOQIwDKlMsEVgG/fGPWLXJ2DqOKcsodRTwopLOyjTiCBQWkz79VSVIdAAafKwVSfTC8o0gGed3gd3KkSCi+ShZ3UNs9TJVaHqB1d42DFOrxcwhBDP6u7F0Q7GUMamBI6vyunI40oMkRMRh9ZKoJG8f5KMT+fAO9Q/H9G0FY3J4m1T1NywxrUrRvy2fkikEqI4uSEFYunQgTNmJoUPsImKOQZijiUBctvQ3ZM5OFW1TqMOdl8KgT5ciE8HQLxdB965lHXvvWG2PlBRpK4SlaLyL0CR3PYwDGpACAVH70AQFDXbIrpDh7guz1MTYgT1LFZK+8owv4c5q1jHowKDwdDt1l65qFLR6GDWM8yBMkk9F7MQ2KUJSOOcpTaFND1p5OdfgSqLW5AXIDOfZJpFmnjql2QWXLm40wpciUUstkYpT/dxXKvO3rTyhzx3GFMgMVyrz35IEVVYF1tLYJsMIxYF2MI/hRWA2nw0rDuhACbjQNbuF+Bp1oJcdCegC5CtzC48ENQFXYAHwtBV+ij1AfgNv6ceH29scgzDrydS3MepSd+omJTkXVTkUn2akrHlOngJCjnYpsp77Hx/IIxR8rH1PRuJ6g6bIQSSMQwzthy/883UrPhhRi43WrNJmzOwbpSrEk/Ug87gYjFMffZBL54xQHB0oPjs6iO0dmEbcdJFSFAv8+9OanjztvDj6GeXP9BIoFVRQLThLFXn5SKPaLJz+YMMxsRvPIh18dTRlMzRNAr88N6IDzYq86+LDvhvNXRobT7pAi3SNtMqD9+699kdhL+toO7PuOO7Dv14H9ts3Mi6Mo9FCG80sf58kLUreGcWPnl/hYW1qxGo6cC2vpB/wgxF7AmjzHCJfT6LJ2rTwwI51YOBbmP1aRkrXBF06KAhzNQ8hZORWPcRoeqxwKHz0HkENgP87eRJNWvwavqF/qXVMu4OV6kE81WTY6CAQGI/U1+3krjK/Mcdd8Po7E/EZ1/FfO78TO7+wufK49S6TgInQNmuhKiAaF1QZl79IR+ULYkG3UdaEeS+Bvcoc4rsEXAqqK097LFJC1jaLutC1yrt8p6eWN8o1Yi7KO//Mmz2AnDM5bAsVWqaQ6GFJjvWg7EbJeJspnqK3agHk7+wWFIdhOSL6a6zSD/wYsw5q5lWbK/dgQrKVjxdtQLV/IO7r/hJJrVx8ZBYYVa0moK3NqxhDM7N2ojl8DFgEWbTy61HbbpZkjRTY8gt7NlHVxJOvarRdz3JUBt101LGCxqj3RwNR9NYdLesPhOmWUDdC12fXKRgwdeASZsaNNVbmNZtwQAT08GFqH8iyS59eqfUGyT/Nr1NZQx4Raruy8RSmQIDUiImeZCwWzgik8MgKuter+PX2H54WOCriLrSo8g4pt9h5Auq9bnBgqfQmmdIOp/m5ZsDncF0cNDckvnuQzkrizqDF14Vilht4d81BiAmFt9otSjYe9OROtC2shPxooNnauCZ5Y3Weja2b98Mp72KPHPumkMwM71/ApAO3j0zukG15V6RsLAjBugoE5XUrscxsGP/LqQ7rVR61n196Od4Z59suoIk0/6wWghdG1FS1cHVGWVwdK0HWBKIRURG4COvlwXnexiUzLSHFASUoFARq6ZSwnqdmExpQM+SHH5YMKLg6PYE7HA7MxpWAiAz6VXCAgecyZoBeFExmO8DB5PPGD8T9Zd0PcguSBMgRC4sGJiQxHO+oHSPJJHG9khQjSPGhDyB5BbhcgFaIiLaosRv0OlmODm+xWv93sDjivYxNQnq+44SO3kVtn71UirfrwngztD/pewC0Xfx+Ff2GthRaq4w9Z1c+utdqeMeYVqLRbtzQ8w5BVGihrOHJij+lxIRAacoEIhRLR8nXRClSjndvyS2iLFogf8KT2235NHtmGuYPP5XtavrdZ+alzSwIwlpXxOyrbOGFl2p40/W8YyFrVPYo6XPGNqBEwM+s6khJFOPJNVb4Mj4y4OjDRAUvwCSe44jF7UQfG5/EpHq8HPO9Vin8oj+djl2f7X2NmP+PojU+7Dr5eTg+S/1/bQ5nPeNK1OPBDW2ZfizxCYORDwKabSgG4A8Pv2ZuuN7iT/aASgfR/PBqu+AMTXDFYQccW422ML+5P44sLfHg188Brj34DBvZ3ZP+F2pWea5bAnC1ld+vEMWcpv6mo8pde4ONCtls7Ru9fL8jEziOlx5k6/gkRX0OKxHl6UdtDDqlKxZZgm/FTA4uIlGk3uWMG9FmcGc9VreQihUSmulULRd36F0c79MZtIvymr9ejzC1bD7euPKobsVT18seFnj8q1vUVxn72MXyqCZoqI+Tgnh56nA8c9ALxihwncIbcK48Zft0dM6iAcPzoI/DBk0/cckIFzjNRqJ2JhC2Pmbt2HHzELnuUfReOOxaO2zsOx+2BwfUcgwvSXnLWPhRNprHTUbldjqk2tl1+pPVaOZGqvsmPbsDC/eJAK9RxjI0KqA4FVwvvQsn5Jn+uC051sxWiVHmE+nC7aIyHetdFMeX2ArR2ck/9M48rduhaaG9+YaJphPPBpTk8kwP4446pjp3gmOpN2F1bowpYu8m3N8m5cWbuomVI3IOfc/fjMrvVav0Nd6MsNP62VGEDOdXRMIWKdmAp6mrwtwjA0kumXbiHJjepMdZ1vfMRFw3OLd6j6rY5HoU5OEhf7eHK5/gJ9OqlM4lrzoEa5INjliMgoNKU6kdqFmbng6HfclexyJE9Q+88ESeo7YPAXPuvkyYXCa7J4XQiVu/M2Ivhs6bZN3ky/Fjs6igmxSAhBJ0U3TD3MVFgEhibokTKaCuDNaMK8FJSp3rlK0MpCXUwHqi/wNYkzzDWmdz7hAKW6Ew0MSwmZ+4TdkgGtBE1YUdBb4spaCL8+CVoA8A0sN6j3XbdKnO0lb7KqEWVxsGsEqVKqpvSvFnsnWiWj0wyauKUjtPtKR32FUF5u/Cui4bSAZYAfvyp133v2wbs3mvfWz7xrGf948z/uIh7lRmqr3f3Ith+816itP+dGBicX+CPwenr+Km6rGqVF5F0N5buFpkK6/ShnTRdjpnsgCihy75BJcyz0Gmghm463XXywqpWKav61M988memnHUgz4Ss6pPIy23jxydrTlr1cUxDbjT/h09jRc1+a1NJ1Utf1G99reVUv3NcOdVvKbF8dpUbqZq9CsrTZmClzHWHiXrELMfHbgfh9oMKUjBAWkvFud1vT3duB2iAQ30muFipP6zWH9o1GiQNFDbEJ2ULKJI4VIPVYxOuzLXKsWUty5V9p+dPyuvcCm7dWnP/GXeDMf9+wahvQSe5e5QC3t+eYGVbVU62NcHI7i4Z2TD7XXx8Ar71+N1NTr67QLxqd//633MCGnGxrpqBrqkBZCCIQEhXbA2FZq6YSRrrV3jYt3DaYZuZuV/bI7eTmrnnbSaucdzyNJnNNSyS6md6ml34DFzd3UJJDaUB2kH/ifza350zn6UqfxiS5ypK6I7+UiHqyMwpxl4B3xjKPX4EB3K0ItBoP70zCBOjwzLJlaFZTjA0faIA+RhcmVr7D5Sz+rRyVn1fOLhn3Ah/x+cjj5pDxV15ubIUSaPxCUVrgBVIpipOXq20TVH7T1Geol6Lr1gVSNe7XRFqZQoDnLesVl0RGpqaMgIKT+E3+GPRD2A8BlePxTpvkLcBMbAsaP6leYp6wSTlMXgDhezoBfzmetFS8a8stdpptX7iQ7lzaopH0J2rMgjm4lWkgxFxYr0fOlVv8KJuS/YGz1N5GhZ+nq5OJD0Ez7ZvxzPe3Dpy+288dXiVVZa0WY5xlmEeVgw+USCsolc1fFVEQzCVwDjMmvVh4QP8g6JatDY7/fUo9sWCBLfIsYQHQ+UJhahALHjnj9wgYkHG1zshIcz+t8ydPgQNmpgqn3JQqiLvAIUwMKA8ilBg3+zOMF0v7bVZ4euq//Xn1z38E08TJRQ1KCfHavtxuVxkc7h5lDcqGcePDZq4nbjh4Ef1jSP27UODkdMAxVFpFVCUKpJMUZaeNBMwuHg4biZgINcFpCMb6wgPj6iNC4xktj4pzgaXhVNXWT8VdNqEvqerrbpWtQKfAKSoAb4shC2zPEP/qKNMgbXdEhE/oqrtLv4Pnb39+2uHLrrv/FflbXc00ZJ9RFpp1pge/azpDp8ouJbTLKVHqBoz1H7ms9LTfK4s8OKj2U8KXs+6/BkbmNMMejKwXsxSm/iP+eF2mfAlrt2G/8veK1WhO8EsjmkGtzJgEENMGY7hjiWEB0M7p+L0jb7KOYLKiV3oTuwMTxyqGEBFA5FyhJ652ub4MR9xa1iHdFCQSbPgxdMTN83HTKYtJdAseAkmDuWCTQ7lQkgRYAuS/0opQjhxKOcaxp9omziba1O4Vj2Dg8Pmaw1tMYMbDBVDQUuGaGyV5iDuSHYvvh0e3+gHGvRIDLaOHl2EYAr/apxVvX8TVtVXP8wf8KPALGvaMDa3MWEj5GBj9P3+Rh/iZJHYs3tqXKh1pEB2AxyLRcXnsepvNNeMGYsBuFvEMZoM0jXCLureBlLL/WERAFF9tgLiDLLoojVGnMzrHjZSEYO6UWkEps/8ANV7G3lI9TywiyeIEi5/7r56w9AdCisWS4w+rd2fFpHaIak2xceipDNGWoQBuN0PITkDbUdF1vpKDTwWngAliK6Y80wckBo48mWCj6Qmebk/ebjaAmFZK3fQIHc+1dGUFA1MtYHuI2rdCoaMeZo2Zp8KfiKuQ1awmJr8jWhIomR+6x8UyOt1cxgg5ob4uDHu4+hcDaG2cRScQKWXsVUAIUVWGQk93JBjMqNZQ77OnEZ64+Ms4bQ8cD+sSqf+/PjSqX+jVvzFCVrxkcmJdtCbnGl7R98PPaMy0w6+aspM49hypj34q7VpU+3gr9d0rh38SG3qZDvoVyYbbT7ZDl88fGST7au1ayZmGxb+ydmmS7i2ZWK2kZlt79LZVuWk/NJZPEzNcWmI+1rOOjR0bNbF5ayLFUliO+uiKbPuaG2zaRdPn3aAiJQJq3i02bSL7LQDLO3C3Ujf7Xk+mGEWmnn7XgHztD9wox771kpjROtl+KJK+LK9Vf5karC027XOq7F3R+6hotF7ql72s2gJhjT7Qas9tH6EavKJbgA4gjzFEk64bf2RqN75I6p34Saqd9646h20RR4aVb37S7f5dtvtCNP830n17r7j7p8/owv9SYPqG6B6VEKsz04IsfyqlqJ/klqK1z5W7d5wVOLnqyLso/rklUFoF6ENkGD0uf99SriNu8IYe003k0XhjuEs2iVAl/pQfQgWdTkygXS7BoJltOgCYRVA28VMjd4s7Kt4/zlVUa1audtUVAu3EMCqzWW1j29pVneIy1MzMaqxxuOM0v9OSzfCCHx5oi++OOWLn+tFK9cFrxiRJN2LjU5VHrDh5AGySXgH3lUaoEmyg3gPgql+cffYF+93X9ztvviofGHYHSzW+vE9Yx9/zH18j/v4E/IxWGi5EIkyRIBEmKgJQqsINRDqItREaAEhqTJDqCVYj1AboZ0cwvMsfsqR0gzYrlJJp/PiIqPOgf0wfjiLKleLuRfn8zLESF+g2f35Il53qe/TIPeNkSecTS1RRLMvgfNNmnsxP+YO7BdrK/w+v5/qB4plyENAL5apQ4sgeXmHfKCIb/lcuf1sRrWG48guHpRvkc7lK30BFtoWUmct+3tjTj+DeZL5A2uUokYxX+erStgx5C86CMqnRQT+rUMRKLQxCLUCsPgHhLihNRGnu4PIlNo0t5b3+oIWkhmz+wFUjWIlOm8LTUNiMd8HLXCVr7rK66jVnRnCqD/au8yPa9dErFMzl/7AWSnDSi38XdpDRrWTWxdLypSuyREjbtjPcPfnQB7NwBawn5XB1JRY2tomReImvPJJiA7lYiM+oDl8Ait5xXbaVjENHPUzZ0N4O20dSSLACYNX+OYC+xxANkdLFmhptUY0gGCmq3I/pVO547OsxRGKO+hJeeqnleYvNZ67jB+L1EF2aVPIAo5ogrE6NsPg4sectUYPU4WiYOKILqm1+WUDxeqRKFE990kRnfSYdY58A2rlW8nhcTJmK2wG+K8TgUC/1WKvYrrVEJ23GqI8xTC4TWpQpt8kNGudYy32Q/wx99tUo/M1JQ9tmasyFxf6qpS4BYiI83PyX5w3FC/nhIowONTmUj6r5Oj+MXL0aUeO7nfk6D4EU4fvvn784NjHn3cfP+g+/pJ8rJfTlvTDQzePfviQ+1CT5MMbEUz70iRQlwNm2kk10mtaMnH+Xu3eMpYnUBomXD6P0wIfvIj9EbRdCoKBBDHnMQembJEDBsIRpThkV6ogOxKj5lsdWFrGnJhTsV2KyNQYCaFlGcX+QyWJUvoEdJNXtdCg8uEIzUFOnSA+JqV0AFR4DlSYW0VzuPo6SiKlpKKj9cu4R3qj+HYPT4owuh3pEF9T91A5x4GSoUYBXN5zsFjFVDAEK59F/EHAvMjK9hXzY1MLA/nKNdm/BVMUwbaL0cKA8NxtnmSeMKowiz8lZ4tceUbzwPhVWlRytizkbJ6WT0zO+HG7x5CBEx5H1mRm8ufTaZpmykbIWUYdbCHncFEE5WGUKOby5zBFdb5ajYcetxMyTi6ElIxJODNkbEmbS21H2iSsJG8WFG2Wli5Vx5swl4rjppYD+6wD+8wo2IG1XHvLULSUVoWiVWCwDB83hrrN0swkdfMn6NpM7tPio6RrTLUqRA0AjCoAXKYlnoARANgCAFvSa9Bxh4aLDg1bSpP7HRx/CT566I0DTM8BZnYMMKuCjzgfQ5vwp9g1I2X2aJYhMQ1P860ASotmYGd3No8gZoE3iOl5ufSt5AtGbaNliixqzmF0FZUYQRnZCDE1E7PdchRq87oCPxAeYMpWg0XbBVvmgSHzJYaAbk2FwdwYDOYZBv+LHdQ/mjkJZMGfYzF6NIc52cISvmw4vABsHXXGZ+Vu9WYQEF5IPRroS6ZeDfSlJg4BCMc+Zl7m2434KtBjVgjuldGAPNtDFF7H2ZHIeipQLSasnArM1E7LvQzI3aTh3Rwm2my6zmBbMlMiplgvBuo6iKebT0eAepGWzXScF1xLp826lszT0VkXMb51SEk/ka8zLxqdeZtjznyVkUDzlXfAYqDyqRzG+nRNExRyU27WLH11LH3cXOQB9oN91w/mMd7cxDkzPMs6ZBTiWg/RvPNwVhC/67VzszT5B/IOSAjYQDVhY5dGw0kvoC8LZu9KTWSR/WtpDfBv/JHbL/40zdjAHIjpgIxoxoZ6CHWZxgmTb450AnekI7JQpwWr0hkfu3GIYzgRGUpxTFiKYyKqOXGMbMiCzWsJtRa0aVTnlcU+3n457JcvIuSr6LzKJf2qzismTSROsNQufigq9voI5YG07L6KzqveonTiE8imp0ho/hzCrJOEtR41FvEktO2hpOoDnwS0VecYw+RgPX5WiILq7h5QgikUViqJVR5bo1gqqcIXm3uFb6DwHTnMjNEUA1GnZAzzbSoQ88pHqI8a+SoL87MvTKgV6z3aCRC7s8vzTvoSbcVvZS1940q8DF1+3NvkX2eGdVRuccsYD30T3pWHvsXx0DcjmBrNh7Evbndf3Om+eDuCVm5hRCRjH77DfahJKiIpPwyF1bCyhjy20oe8XooPklI20SglF00VdBjGtlXKMdql5GOmlHd0ShlIJoBEaLYqOpiTj1R+scA7I7S5ypdTk9rk0+yLi8UDlHJokVnu/cUStV5c1A6ovsYsKCktYQdupBncgxgpscoX7pJ1wpeNkQRrej5UA3WSHb0qPy84GUMNdJ0LHJExNGhWzP3DIu1sHyOp31g5Q95EFRKfpzJDkVp0+/D84hqyxTUkFvpYgzMHWbAS6oq71k1YhBVeYw9iOiJwtXleYZ6XUwpo4U8nZ21NTCJuUY9ny8TvdXCyKBydoFaVUagZRgGJCJNhQ2qGTSATrhl2pFUyCSsqElGzZFRzXMKK8g21KpPgXDsLk+BYz8TAGGs/d1IYBH25msNkwlcIg6Dhy8EgWGXnrmUQusZZpIN308G7MQZvADqluoGW3J3Cvn6EQeiBmgj04kok+kyN3Kc2AAoOlixjQPEYg94zDDoqFawCm9AyVoyxNlutk64RMWCTIq6sdObNixY8fyRT7sX5quKVShy54UipvTjvPnJZwaMQEKyK0bVHLSCoUXeKgKA5JiCYBb2dteeVbbcHUb8ZbaXtCxzo6oSvUVqORa0iFqgr2BOdzLNAtHhELNAG5Ns0ezJigZaKBWrjYgH0SprNRGkWRIhbRbNVsUANtWjBRasiFsDK29C72kxgMY4t6U95j88IBfKuYw8jB405oCs2YmKpB/PbscXz2sqpWE+r2Iwtm4+2PDpqs0xd/AmtETetvL8RpKUFZWljmVwNisfJDKQENZUSKNEQIVlLd8g6gjUnJYhLKcHKiJRAM2W0MiIlaGGTO6vq7D7GjOpc+iwIjZ4X2zsVES1gSBxRqVWICsiKtJa2lEICDauQoIstYJeaVkjQVCHBggN/e3Pwd0UOsmCITsoA48esg0BsjKEqpk8SI5URVCOFEHWVEOkVntnNSVAyRoKU/q0pIZJz+poDX0xNsAOc0boEbpYigrwiJlhwSLmsVFTFBE0jJqhi5hYHmu4YaCLFzLYIhuv4Kze8spKBQE7DVBUTLGMvHFPXUOYob03NOyomELZHcXN2REzA2EazFTHBimUKdLNXBeECpcCVrQaPVgRfVB+3xJGp/Z8d63+dViEi6D66GdmlFH8KsrYAbFaX/jbDpVz6Y5p9LEt/43Ff+vUWKcg5p1XX/1pl/d9sqqoSikVLDuj6H0+diumUqbhAsZmKdTPl0k3W/9lKJKV5DVMOmCbTztdpVxuddpvjTF0nnBIlu8124oEOZbQoa4Hb9mPONdyca6vPXkpUTtCQPDFIBjX1AyyeaOGsDhNYPicn6HETtKkigN1OPZUT6FoFOUELZATC0ERbpzalrZwgqDgI+JmQT9ADdjY2/YYfFCMIukhqYzNEZAKH4QklRnlmrfth8tCsBjWG67Dgm6yrGrwzGCxBZ7Mxwc3nUKKu+Mtn9ccD39unxr6Pfwz/HrgYHqtFVekyHql9X3jhXx76xQfve/pVEBjEYh+vtbF+B056KBWX1u2N9dtLc4e46icX0zCIMwjpdIpEDB6JT2/RmUarxbt6TBwiDiRWmyur6Ehd0cc49GukDXopV/1QQO0Xw54LRtSpyqoDzKI5qkHkG7Wlm621is5zIINSSxdqg0TszWdftTwVNHMZUcT6KRNHGWbBAoCQIxyIE/KvYjTImGRR1OaCSp2oYZG4epVPRdWg8vaa+8EbuT5MFxNBnex6REF3mh6d+AjXN48n0IgeiUDj+CINJz66c4r4KPh3Fx9Vr0xHx5NtuCvT/+iFIp54lVEPBOWtTE3hwSJ5ZlB6Oj2gvD6qbgkibDxx1s8XMhwbEhzx0+qa9BO5KMP94SLOh61Tu3jAvKhdPOTCLEQLSuJEegM/giaVgCZdmNL91GtUSwR4+9YiAUuzG4SBEpCo3dbgcwBqGljDmDV33+XzXqAmoaxUJih1IhXLuA2iifcvpYHws2skGxklQjFTC9mT6e1iqu+HAc8fv4pdJkIQdVkP2ZKxbLXJbAeAe3JdCGSgnBZh9q+CYV72EJ74+BMe0MvjNr311TqJxj95GFmzr+AXaYdLQ6CfD3y4+bd9jZxfxzrM3jzAzZ/CSyQM8QdD8tTEv1qboXp/F7QaNoDg/HK3v4bqIU+XpGzjemk2Bdmrb5SGZ7+MGKpz8sEI3mkk+EDIpPIluNlVl4tw/ODq/K5NBJKjPJmHIdRlMetuQJFFgKWCeyzSom/HjQxMiptgQRbtuylay25ERsT3b/LXJE3jj15v4w+OxL9Z4rFDBeIyNGrcc+XRYMEDeXdp/z6MnBJ7d83FHi5jL5oWudtFfqSM3Dktsjvt89aUyDJGm17nUX1MF0/v/7fU2fufQEco/3vI6S6clQZ8fXyD3e6GMcftD8A43v49bb3WNDV/OJn/+TloYfoHnj96BzF2bk37x0B5rUgG+MkhNKn+UIAudykGUv74VULJVzUfDFZovszma43kYyzigtfAit3+xesPcfEwXBADiV8D3NT7yvd7ap7lXn6isO4FwT0I8lmbj+H6vH3J+OUhj+Lqlb1fiiPoJMJYTFAVLnuaQ8aGa9D7Nsc8TJtVTJrswMa+3/iVjTfFD5zH1/qfLP/+4OKBsVeyMewzgAef4javV9wmkwte1SvjD+8lF7yy95BfBCBFl/TkamXtW3qFj06WNpd90HSRRqi5qPAyM57laGKAxZ7Gy8mbbp4meCF5hOfzyBOvqrXstUppQCSvRo3PBs7JVPp2jX0p+Wr05nL9htPUvB956vAZAEJD7vGy1wmNqSvmIsHaQgIFRuktZ1rJB9LpxSJ8fa+XJ1pK7vgltV3x7eV7dggVqGkKpFyO9cndnowwKzn62apxpR6gB+4AsVzRKHI326ougdVqNNW0p6K0iWVx32234t8fMcfYpGh9mL1emuErkoh25+1AG3EH52FBvxFPfj+Ip6e+xw7pUuOJC/43ogS113WW3jkLdGlKNTIrFEwaKb1qjUdhFmRosSVtqOq+2tqU2HsmYuttzzTfN5YDUm2y3I3VnDfdqBVVtiJ/7fk4lalMfp2ssrALDc7ehK9WMClPD3afH9ziI6j73uCQfcmwPnr6IuzJ/fYFK+edvn7OS8rAl9huHuu0v5eTYCLs08bQyz2+2KT/H9/72dtvvfWaDw7YyOT7X3/PW37h92+/iFwQTPcxXwnG3XhiEmz4FXJxn18hF1/il/SOKMTCH1aJX1Xf/ezaUV+McRmd1ludtHbK7PO52I9Klhoh/B4Jq8qrBFXlFcG0L4lucoqOH6JweSgrJ2hXU45J5kAn6QJIl47eD+JjAAoXF3/oRuf9nWFYBOVmY99DP/2F33/O91xxMYU9JL5d8GHgHyiijQkSF4+QuLojcfUqias7ElcfJXEhOBImcfwEicNwWgL3IAhcfCICx2DnHgHM5RiA/cMtl8vanmwBDvt54O6FHPx/9maHb7R21LIflqCa9gsk5s2Iwac6C6ojW61NL8AA8Hmsmtfk6bGoMf4QWlKnOw0jaA4dRQnXsh/R5QuzuQvUdQ4+sXyoGEDGJw/cZAx0OG+2k9E566inesNLbyjJvW9+eq8y6HpXVPLlFKlQIAbfpncbDskT5lnrG9js34J3fh7G05PN6yBS+YI4qmoiHKpydWS5WNyn9EEjsbdn2mhY2BY8wDBr+MOHUHfLsLF+1VsEBezfqGko61/zPa82yx++V/59lt9mKAL7mXcwtvzMKN5gQUuQz3HEJ7jK2DlgFc0TIfimXgqhdCEHOxwx8JnRQ0OKhnK96AA8Ei1QhOOBd0SUEof774h4hJARirkSr3FgfBGXVeLerHE8Ffy34nHUp+TIrUUT4Q0NL9IiNa/sDcQBXfUu9pWyE6GmCE3UAFCxoLdMKht9oJewgyjyTr9YxDMpluDoK6CmK1AdMgnvBlGzytvAT6X7oQ4uN/AbtCBa4fwavpQ3DwxXU7Poy6Yi65pDEfN6ZV1QlNI1mjOOEqizlstxwxoKw0K6wOjq2H40DuIOfMc5FPqgUfOAsZjaW82XES8291ah36gmLARmtQKWeZvYgEKey+E2LQ1pcR2oMIfqoImI+m7/3PVH737dl9/6Fa54E9MXQYIDiHlUG+lyB9zAVkSjPmyjsA8Zz3XRRMxuE/ORMmbnREx34qvWeIy+GsThyWmn8Rv8EFMXf5OGC8Nn3Pbuz37s1nd/9kssLUj49eO3yjuEB9iIRMB8t41Vt/vZzYfMGqXeC329GScWOOSwUw14QYl+5K4ieB1lmRpiGBoZ1TGbyXbuXimpJr4gwanEjHjjVJpNUZRiuWe1/ZY3YsKwk/YzY7vSzz51o/GZam1YHoujoHSEaaCx21ExT9VV1G8zk64+WGKfBYp1RWYlwtCSU94VhriKpHJ/0Dq5Hyq/Une2JtwMRXuGR9hesiFOv8y5QwoPbBRsmzYxy+XlF5MLsjOtBNQNAhQ3fdXVkTDkhLfVvKmzIyVPbUpHlOqtsmZpw68lPFTOD7Uh3Wb8d2PklybRKnGU5qFepcINKX5XN0LW84kBA2SleHTwyPKMWkpCv4S9q8jDG8PhGAyMXZXT9w5pZh1OF93OkfyKsBiVYiWBPr30tAilpwVaSpPwZ0sRcGQ3XOe5PbsB8+NqSg4ad+gL3NpxHJuTaW0wKRUwUIgWH9hvI2C7o7SiQi54VQ+pdwzX+eET/4GkqB4Dw3/O3A0T0GhjE7XAgGObuui30KxI8etCOJtCTlXUDyKpV2BBKZVCNpnComn4sCSWTaqjMnP+onXo4q40Xcllt2iLfBjNrOwVMe7JEW6/WF4ZIfM+zzrkx+jYjmFBgsjnLH6eZZh7Du621OVY6HfYGIwzFODuoz/jen5efT5v9HCC8okaO9ED3cgDk5Sd718iSXdrkjKQTPzU08W3Z596vbAzXFkRuxiVk+BVdoJOcitDrDpP1pkdXi6R0+AiBdYz3bGnK+2+x+gR5B11INTPsKZfU2Q9UDgYIFGtzKKD1znyANB5PtpYuFVgdvDGc/q8JgZgcijrcfVYzRbeViw+FDPpxHI34pqvRXO30uytND+0lGCDLfm1jCN8FeTN8ypIC7R4hHNxJPRKxbBL1sagY7Sb9rStlr0FABNrDo7yJUr58ox8BiP5PNX7P/Z63Kb8R9CM/g8j3L8Xv9LbXvZWpZSQMy1kf3mjvDC89XtEZ1/SSF63JKX/F29Aeea7EhT6rY6lyaxf6shrQv+PD7pvM4MTf2HeMkuj/5exmWXkMKS7qq7dsflhKY/JKluqcyt7rZ1Uk3Z4AE6J4YDx82AwaZh9Gi3Tm+jkZb+iZmZr6f/jeVOd03mQLQU4WmML1CI/sQb6VyE0lVBPBUuQiQJqH3ujfOqY6esDL5hmONiwZD96ozMP53xGRHIAUW7Iz65FkFhgTxeBb1Nb9/aO5mi6pAJVHlEVWO86a5L9x5Bd75X6QDd9hZggkmuoZpMS6A1nlLUmyojyu8f5z9wlwXPXxB8SWq2FqFXwPoN+96VoQelRM1LlqAiNU19yoGlGhAQjRoCzz02+Ta0iqlQG2fOIn/Z808MmPqpyBukPBmrGdML/hx5zAjUMMdVj1uxtKnnut7Q35UaKjC+P7AMWKImeFyEVlsTaWiJFomW7VhIlPKBn6MlVikYeUBPeOmD4SY2cyHCC3ivHGuLRgVFSJcaBTQg0gZM0Qe0/WqPALTxa1AZb2zaKamjFqLcE3at3GbdNzbr7bGFgzTrp6ygGakN1BsuJRLVsVAeVi3V2rlLbqU5ZXYuwHAqIjOE5Nx73+oHuKkkcAxjnzkP1D9DayKPSmk0elNA1K2MtdwwCzLeJaeTASuQCK5FT+7ZyhbssjJMZLdwprUsocO7Kf1f2gAsDioZVQR5G3dLub907GAoybKwPyrKOSllu/0mRzb4XYkAJ/PzewZVsBwPTZmiI57f2EfOSos6/woFxe2l6P6f2Uc3KVfq494f2GpdPNwPCHuN8hQiSNyy8I6hIBlex1XfgGKmwvzcPLf9flgFTWv/AhFwWyujIcJB9WKQ/seajyEGhTIsIuHDUfgZjwJyoKGs8w/gMMtjJ0kOE4NZ9/+UfHvzI9hf/hIc9AVLZt+Ew+2lrfYP45Q6xtuHfNqRgnXtsDyy8kZWX896mOYcKla96zszmMX/kwEGVhxM9DTAGc1Tq+Msy1UM52XK4SlH2K0godKhgL4UniWisHmbbbdBk5jLqa6yQfp7/MZ47ODYTD4Zaycf8tex9TmhTs/uF3Xst6gwuGk7UWoR37PvSw594+V+f+hm2iRZVkbkQI91X9kzM3RfBLstuirmj7nRirlY5mPyIyH1e5flTlz5VIA95V69roKqWL2DjzUEVaemCuKB3JJPScU1WrpBw2rB9rR+9jDx1ZPOhG0dXx8dz5X3/eNnXVM+XjnqueDVr/1s4rbY01G079pZIrNyCJnvmhCDEx8qAYMAp4IIdfH/Q8wM5Q9NZBtOxqAQn7VYcDsMkWO1GBKI8QTZ8I5Xc8KHcD+GSFPAxFJB9HL8UbAzBlldsPJbbZyZGG/r2go9/vD80ZOBdOGLz9UyvKn7Uespd14Ml/XoqF+Q72VnpOmkga6RvpLb/UKYknJ/LYlG878hpxdpOidVD/JO3Y3Pf11eFFkO07jByVD0V/AVvmpqJAgQHWapkgGVKhRSVXiGCAlUO0DchmRUpr0bKhEouGxuE/oc32BJolCqvoomHfZaopdpDhdmQvBfkI1obFKb3hYEK9Cu45mmqbtM3vKkHZz5OJDiJELiFA7jiOXp0dpdXBOb0R2XzN3ua8B7PSuYP48MHayoLvsmzwmAPSsLaaIWRdgPfHvSy3wEU5WwuD5Rl+p/kjSHlef4LAV8tteKe15zGRXoaF7JvRHGGeZU57AMp0AM+FNEqTTxRWDmY80APa9pj8Jqj3PrLzUFYqKt/S1f/2DKrKsmO+bsf19OxnXpmtaqy7QV+mPMM9XBMErq/hqMNCf49gi13rAVBAYojd34W4vzMyPa1WkRlo1HafjBP+ARdHj1y0/bsQm+rh2ZvBxAmYm+ZjK0Qlyh9OBQvJMEULAPBOS6mBRbTguNhWrgZpoUng2k6Rw1+HXuNgFFPf0N4KIkUfvF+1jl9UR/KNYhoWecU0bMUBUNuiV9EjHsl5oVjmKefRJvj3eSB8CPEO9/indskObzDRuttDu/8EbwLHyHe+RSN4p0/gXeInMA8rCfT0E+n2uOPfn76QT8I5UhIFs/fx/jmAYB2zM9DeXqqkJTgJTPrZawmfUUqXD1RT5yvrFGXX4llc5NJVj6Zerie8MDYJfEicDblCaR69Vpfh75qmcNuqEK3jOqq6gydrme3iZ+/RJmze9xKeQ438La3mvI0guWCSbkakgtehWPJOnH7cRyZPJ6czh+8ZozTeY0nRm0t1oa6e4/EZpS5myNb+1vs9NG9OD/C7FblQvVL5DQCGHkVRUYIu6rUu5PKi3OVb22ZP527yKobxlFe2N/4Heb6UVyIDKG4CpB2vBV1qkKlbvQDqDjt9Yw9SfA9tyl3Tfjeqpf67upoqfJUdXH2n1B/TQ9pT69l4hzmNULNdtVUosEI933vvPEZtW9r15BllXyTZadk8cssl2OvGKQvFLgC7gxLPKTfCCtrXkSl9fhQZQkcj3CAKEN8cAXMeKuRbNLb0Zan34ymZxZy5Fc0SLUmFCAhNfRpFDiBHRXqFqZ/FYzrFux2yDZNfYAV6tAYdaSjSCY4oGI3xK0iJHE7daShVIrPoGOq1wX0Z3UtO6KcgTimMuZISW5iIrQqN1V524V7v5f18LZQJmYikygTD4AGGwNwel7PdKkA5RkKvuoBcrZeai73z4Xk8e2aKIKn7CfwYqQdLdBYuauGHbjOMMDUetj8SZ0FYtpH8heJnHauoR2UyBmoGpUXC2x3gIaoZx24RHHeWoGnqtdUeH3vEv6MH8hVJxS4Jhs5PRPzVaHbUDl1MSjrYpqijf0FRRq07qfMRmS322os8o+bYLXsj4UQbJsWiympWn67R7zgOha1w8MHwnKHrudOUvP/ev50t7kMblm+0LpfUnGvLB2la4oNs56pgE2XbJ0Z7jp2VSbEGSoN/ZnQa1w3gcDOv5ov0jpdVyJGGsE1cz1B5UXJ/qKhJyLJiKZvASV7XBWQueXMKyA15C4ShzkVE1Dc/BpXNxRz6AB5+tLAC1QFGte8rB+/jIvI7rQKZIJExpxWKaGV/XLD7gvRTFXAlAMjSvtyEUS+ROnks+3ynso1+PW5Qm7ECIxHKQyx5XVqcl6zYDIcpHH1NYpexjjkv0zc/wfX4PQkZtH5Mzzy3vnaG3GsXXUDVZrIQr3W0gXK1RnZLWKzUc1yTyY6MFUwlwNcIsoLjDZVpm4We/wAy6EP0muSq6Vz250Ine7vxImzhFZRhtli60LHP09Yy37aTsdMNFwzYIqMgrZ7ZCb8+SO6mOBNvZjgVS8meCe6mHDds/VSwohTtzqF/a+M3kf4mRsn7yN4/+73EX72xqn3Ebxp9xHegby1dOD78XWl+s9uB+QS2+XIScXHivQ2MdSpEAXytkCR4n3MuHoAQUzYcI1CmU71a9incxV/6+zEUrw81IHG11H8ztc+47rX3AB88xXffMU3eZC6c1nlh6/4hpDim4QU3zxSwiXZevwoMe6d1z7Nq1mTzUoZpA8yOYxI280WHIv9H2Rc5Z03fj0aV/m5G0/euMrPKzb+OIyr/DvgImf4N8RF/kSV+x4pKv61H2Gyevi7dhMwdRUZF5SX9ZW244q6u8UMkQhLf9e4s0VyudEByxEZv9TwL8kzrrsWd+dOAIboxGCYDgJeZzfy1LlZDrBn4R/Ye5cb9uLQxGnaqA/BYMPt7Dg5V1UVgAqDm1q7DXndnppxD27gLsK7kACFowCiPCjvngcU4rbhBKjPrvp8wo+gn7roNfwI1ewVixN5zLhxzGNGeHyPGb/oBTLEU+5u1k7HzuQZdOinYOv4p+wm/OxaTaW/IUXQEjJHFx6q9DRSJh83mXy1BsSu51U0C8BKjmzaZ+r/b+zL9+iX1UuE5D26ezC/eOP4PRiveg/GO8l7MK96VLarH1WL33vjv6O17RFnKp74gb9xzJnKL9w43ZlKiFYmxzPGPeaxL7TGuH8WzikEHrpXV9ZRj5R9pe9en3hvpCvVpT3xT9u/TibXy/jpv/Qas9LwzzX/b+4bE9epVE2XqgHsIpRI8b7//5JxsXAFtk7bdeukwoSqo6T+dX1ieL3sGs2Pg5H3PI6NRQXfdzLtRb4TN9m2lmzJrtXbdBSu+5aREfB0BE5kMf1REKxHlvtm3286LYtjfkmP+uom8qP+mjnKJymsLrvkxOhaN0TycxQeL7Bjw99lPdHkamBgVCcUiqVq1NOYABJ5kgdDoC+DVhPn5Ci1ImOVIZrGVozsHPAxhfxhApYn+wthPrgkfFa0KeSH6lm0x/QsUFjR4vahGLseJy+TNSNUReSw9H9aPXL9cBKpp5SI/yxs3GVetx5srnWMlTX7OzRV78uOumUqouzvkaYyu73YC5s7uJfwOSXApif9MS7iFXWqV1TGjekEf9/u6AfvO+erZ56Ji+mlPHb6JQwR3ToXYgnVoarrMoNBWhdzAEeKTW0ApK4N1FjP3vom0aIvb+6bA/68SXUupzx1vBJcSHlOO+B67riVmnrPXkv7Xtd87tY61e8YUh176yOmyIomavPIep4AEyI9jsTlZCBHhHPzkPwLRCEnNPdEQ4U9GJgRrYmHgr64WN+5phMvewCDoaMQbzCSRFV4RycH76gK7/oIvOsUTcA7Egk3w7tiEKAxAu9mBd6JhXcyAe8GbmqMwjuqwDsCvBtDrWYqvCOGdwSGagq8GwzvOk9ZcWOeqsVBCpwudPYFhVz/C+dgH6CormZesi8iyRgV1I3GXhEog4sCRKvng5gG+8ZPDHXZ5BR41NQy/wFlqomIY+4SekWZsqYC6zjbkKQQSpWDN/KqKPHZbcgkI69J71H9SBP7wDn6mSCQyaWKkdozie/zYXb5jSZYvUj+z+pF/r1fkcI5nXWnyfGh10xR8HMQcDqEsdMhjCd1CF26pIJePsJKGF0gS9QPjuIDPYkIuDMf1lfZcIk43Ro3EVEepMMhBMAEs1I6ppo5FCEU9AVJyBiySVwskio8QnNQQf6EvmDAjftNxQpxH4nsHOInBaP6gpGTRX6H50/zhdH38tAcZllWGi+JuM9PEQRspO+/duOEv4yvV8+Dv/eYPA/CRfXJex50Fi6uCT1zw8xxYaEjJqrcqTyZmAWqJKjPA9Rktme8qg0HhL8ajg6HTGatvazQSgyjEzg4OTplwD6wpY4D9+51Id/mXnlFbOfgA06VSFtoDHne9KPHvagZ4bq4mtcjhD9fCX/a2fyUUlIt8fZKiSB1h/Gu2TRJuIdbKl+8Y+yLgftCk+SLOytfvH/si7vcF5okX2zIF8LFygTqS1NKmppb44CD6dEoVLGqGi06ctFLmRMskj4R/7HUu2Emf13N6mt78mbLM6aLcMkMwYMabFEAqpm3dXWYkbrF90ny0jzri1lmFCMNy+eogwGbR4z0IF9Qs6hNPfBcVOcraHyxjPguLSMqQYXILydH/S/dLEHE3q/BkIOf1qDgq1rsWhMS5TxIYbbz+xLx32U9CwQYHIvV0hAMtYuTBUiwtojJ+3yFEupSdmBNrFeu8t/WTeyMbRNDXwHhOd0sO9H2POdKuqiEO7uHVvXaqU/M2EmjcSsV20DYoBabYAlMhlHsTKqhdIpphb+U21w52ueOFSjAZznJM8vzVFsCHsA+ix3E6Q9/wSvgM6BlL0/ZZ7ETFZmv9nyTfRancOXFqWXCr9pncRoSIiTs5WtFX77YPotdXBBXQ5J2xcrz33PsafZZnO7Svu/q4Jw3bFl/qn0WZ2hacSadySEtWhk++yzOsp9TxCE8JNj66Lve84G3/V3+dPsszkbsJ/Yc+uBf/8udT7PP4hz9XDr6zm+7/eBzX/XmD9pn8QRAGSmHF397y8D7l6fbZ7Hbpvx//+nDSwc+/J8/ZJ/FE23Ks78D/37iYvssnqQpgNGTiXtUabA2+dpP/u5/vfCPPvM0+yzOlYI+d/uZb/jsZ/7rB+2zeIqt4pVfedd3/uXW33i6fRbn2ZRPPv/D3NAzPmSfxfk25ScfzGZnZ6+/2D6LPTblUmnor33IPosLXIMj4vH2DALbZ3Hmw9/KSP4pr7jw4W8rnkrb6akYiVN5sH6Hy/NNNvssnmqyP/xt+UUU0ZMJn0X8WaSfVdJPJUVNqToiICIJ2hEpklGJUlQiEFl0ySkXdKHpyEGMCuQGnsww027zNENIlQFDa/KxASMMD5nBIAN6MoAmA1aqADEnohJkO6t9JwFZFQAR5QwCZDqTM52pmSrp20CeQRS7IFNnBlRRufbEfKiS6dxXGp3zRj4vRFy8BRQHFlq2vkTO1rHVVi1x7LATTV+gsfgCpi2fxgUX1MJNBrW1SU8DpTnVWB0stnNPeewuIglcRNsk4bBJ2EaRJkQw56iLLW3VNvA3kdC0QFYbIefcBC56WyX6SzY6oosweCYaSwKiub5TTTStYh+5SlvhCXOr8yDQZMa4H/KRAjoZgm/FKW/xdBBiIfMXI+GsfC8elPdpXl3nCNF/BsPvGf06vFldTM84kM+Xlefdsnn5StmBfKvtpy4YTVB26/bKrjHcJppfEyhgrekTPwDnRWTOY4Zywm/qcjeWleBpMOT9ksLnE4CiEPNfjEmr5KMMH5YlqwuEfgSvEFtpLDEzicRDXpazMp6LTC44nOiOJXJkArwo+lib29JanwrgxCIAv2gAT01eyiRXrA7wYeZWdjc96q3R8hrXL4ZuWU8fSgK+2q8FR4GQLiu5KHwnxCE1T4wR9g3zKc6mUE98KcwHcuW42omoZyD9GfR0ZUAzLJQZzSJylhqIdGxJhR/ZW+F5uNlLVoFrV/E0nhy632rSDDYaxrxkj+aFqylWNKbgJmzl0eWH7KkS8TOyoCignpx1ito3zGcUyxV0acHckWTM0huq8IEmbnbyU+VZy8/kRBgflkJoSz8SDCqE4ckXebi30MoB6ipqybDxDFyl2Pkm0eE6U3j5RTBAyAgZhvFSElXwqCBOimmbRCoi2iSwKoqkdGoeCVlIAPktAPKWvrDx6mGuTV3EMTdnXQ1pP7ugK2VXCtOVRe3KFrTSMHNdAvipEJDbFsNGu+BJYej84ui7EpBqO10bC7SnMG1cAAu4QDrCgrigCWvFEjX0Tc8pRYMFZkItJy272dkbsBMx6oS8ObG72Mvk+gMZrSYfDS9wS0b3aXrhzKPAOMDMA+v9UhVeVM/C3J9J/zaMInhNwAX6qknCSOvSArUmeFQsPRbr/v6Yp5fgoik8aVMmc0R4knlm5lnZDorkFkY21Sh/gssnIgMORRocyqaQgQjzDqHIcFOawaMDCxOw0lMzN46sEdu22Ta0JJYacFksBiNyodcNanEMHvtxW1gtsEo9YVkspSyeS+0x4gzgNqO7TT1mjPKZfuLa1qYZSo1k+cqi3eNyO4jQMlzbKtI+tES6kd1RdFRAkBCOfrNfFWHZ7JFibt/333zx2l894bdIrkvNcpmdAc0OhjRHc3wTvuPLGDzgybAANCOXpDp6aNop5XQQSUoZZQx1jqwDKOqGJx293RHUalc/fTjA5ULY2hJRaixaBBml2Uetfh6QwlOxCKMVLiUGVjHLNzt0ZwoyfbEfTL2v6Ssu6zWjFr8G1kCOhkXMYQ3k6FEX7Gdnv65X0cQgZR5XL29EFA/Snw5YeUN3wx8b2w0fdbthTZLd8N2V/fOnx7445r7QJLUmJV/0pTiqmSmRvUNEfVjAPfLU3RGuFUnUgx7xW2DeHsBb1fRbsC7Iins5bjx7BfJjBZGKcPCrlRV1UWmUwXESFFwpE1+yqoNovSIlQOTE0B2Yu+OPV/GTHSh8wNeHQz/MeSyc18uJIMnNPh7i37hRb6QLGMg3XXRtQkDSbN6yiVByJ5+rQgVqkiwqcxuf4OkvNhLot/KfXG+M+G/ShQv6hqsMOkCfHxuge90AaZIM0P2VIT3sLG49YHIcw0KJj87zj/6YRE3XpQ2OaSohfG8l/ICG0YCPlsHg0FsQdJZbP3Qde86XOP3qlkr4Tg1DXPkxLQHtPqqxCB52wQ0J3m0i7gbbpz1G12QG6h2PQx6CmERqWw4vwIdyFsFsuVrPuyB4uSbrULWg+vxSCoyBxqsr94MMvnrKi6ilmNghaVFnavzCvgwDRQZBAoy0ROFCR0CBXpC4AkG9QfFdVWN+Wd6QlE8jJUMQN0Ws4vwDiE1ES1AHULci1NA0XIpWvdq7Va+Wj8ryBI/LuVidjf4a3veWcxERDTcX4eXe9TdZl7kEBqY6FxPJD4DldVCnq0Q9NB6xOlYvb5k0jVeKhPwz/Nr7MDGde0rMyMgI5JtuVmY8TjI7ZU6ijptGZtVBX6WdTRkM6KOi36NAgZF1j5rGsLwAV8EEAOzOflNIZ0vb3y4n6wzaXUe7W6oOonBJMdzCkSuRSTYjMu5WB7okwrsbfV3gmgdIlMJnQHDwq72z9MIsjt/8Kvh9kUG7o4jx3FM0jhSd0dVQEohtjg/dWgU0gE2PDLdDMrwmw8FggDVvKAdpuFKCphzySbgmwkByXeip0iVzScOvqDKrlQ4F+qUThtbXPNybyX5LbxcJkPHTHZDv7ljK3Nu4o/QJXdtwx4zuejDhBGvjDnd1czCsXBke8B1UL5jUCdLDka7q3a26abyae8SPBb26k+UxHl3Y+qGaau2FQigWJLSK2aan3yK8hb50DfrSahFY7F+gi1W74Z/xQ6HYo8ffyXGuJDRgaIvLxbOLfRdOYhMshZfwI76wdrHx8l+12qm64Gn1jlFQ3jGKx6/Sx/YqfSxG4SkFNqYivJx6xyiQs60Rc53B+lDEFoDTufxI+hczdPaAuOCQOFETJomCPQHYFzRzhsx6lrxbglClP6ssYRdCaj9sVT9ooW6OyxgTAeLfR69lS+oOLtM3JQLmWTYbbk3yBM6itFjXCLN7xJ6wrDxEtU2sS0No3qA6WmgXPn7z5PpfnZBjYAN32cBRDmBpu5mfWKBulyd/4uvzXk0P7sGzutgdsyXcbwMP6qeYfXVYVrPrF9W0TdYeGcXZHxhA9A++2nce7XjbjAht9rl8ZEva7zwV28zuvcXvq5X3Nr9nlfcZfg/du3DSkdUi1bOF/kHK59wZKpIZb8GUcQqcLiB/MU8NOE4tfDFmR01Kcf78CbRe+6TfBWQytPDWLvMAueXEFI/9+YKeYQQ0o5S3jcei0uElKVo2/F1qyi7dp2Xs2mkJv0WCbeoW2WYvSsSKEV32qGe3qzCFIflWCKllNMQegZV+LOLBYhY8lmgZj2XagscW6kIEw6IE0EGapzn8sR7yLNQ2PQrUPbtyGihL+7Oo/QmkyYHR4eFWKv8AYin2V+Ire2oTKMAU1hRyKWSXmUU8Fq01kiXM7yUjiDmodh958K6AA585DFU+RzpYVl7XKe+tdCburWBTVibPTEtul8ntacmtMrk1LTktk9OJZGqWYcWd7PfULG6dJ7xTO/qAJwes4cgBq+cOWFXNTdmCgLwNEXQYTe8IEg8AdGSviC2uoZYBbjwFaroj3Dhi8iywgZV69ay2dL+NkaK6Pa3l9co5PfbsAa0vbGj22+jMIL1W7BZIc/CRx2jjCdp4erJb7cc4bbcRSYWCu6PhwBRQtYBWXr+SBSB9iedNXUBroMgho09G3otdm8QeudNy11VS18uuvbcJX2/8Efm6SH58fJG8xgunH05jPPTQlSklBxAmX584lT9A/CNwPVAEVhtBj+t5xoX6nv2O1Bej8wbe6ZebXq/UgDxXlcv3cBIm33PVhPNqAcloXhcNW7mPCxud/R8gX83XHfwKFOPzFKhirvbpjb+irZ5pW3B8XHSwncv257PqQyKiDheHCdemzn4oYs9TCDoAuexXa5eJ/DlUJfUlMNrLqqne5WqpK0JzFrvpJnSFIq2wJyp+7pJhsbq/yLiCjIdnK/kHUCOOLqQPxXZ0kSeX6kXUicVsawcgC8IL0028gLyDrsXCIWfPhZbgdupetlIKjjJ5ZkICuaWxNcS3jTq0QqtoID97eGa/a+g4w0Q94NVpywFpKZJR2hxtpQT1UgdCX267R9kTvBrSeT8ABrrdD7VeX6v1UG3LECwAG0XPlkXTZNHzmxd9rSvaUUuUK8BvE5haGRQMSaYw4RgA2d+v2iqLar7IEzBmAtA4z6TCldEurOCxQhnqyYwDqLqORqZjC9DVVXskQaMSagBVGtTkb/KmOW6GDo9+7euQjmKt/8iwNpvA2jawNqI2sDWrYGv7a4yt/r8vth57dNi6y5+KreFjxlYUPRVbw69HbA03x1YlvZd63iudCB402XOzsYhQc0h42JtogVEhR7dDJ5+fWhIgNbWk8Lgl/Xbg+ZNXgxWgNwey69WLArcE1W2vZjhUzXDTSAboXcKMhBqgbVnTEoh9z9TYO6fG3lKJPeoudN3oVSo+5E227OWV9Gsnkw9Ukq+eTL6iknzVZPKznd8EF7mr8s1Zk9+sVpJpMrlVSc4mk2uV5HAUzE6kzbe2A6ta57Ym2SfVTQ/VXtD2DF+hRxmRU8GVQ4vSUgYr9zqbyoGxqcwfqV6qsErvbUY4EQKzNmL9KLZMk/ilLt2xqgS6ehVenUUN8waUnJ3JaKq3NSVvVKKb5Pg+guD7Rz916v3pObNPZ7t9fOCyx2irNqrGPEDcYQ20aGd/bK1OYCeK6dKoWlObqTpwU9uLI9bU8pmKZEFPQjib07IuMh2ajsz2jewnD8rmVK+uwR4cak0Uw7GfNo5n3glY2gtus1KEqE/MVbotfjh9OUGc1wIZiAAeOsOCrzylWK0ZwCET1wV7xJwb2wea1Xr+RBjrvGmX03mQpHlTrS4GyIeIpHLyU1pMPQZPx5Klv2F989SBpLGUgdkpy+mdavpGpLR7hdtetR/K0KC9Q2qRHY5Ue9Chun4N3Y8/RQo2VtgqD/ijDuv4V8cqpWZlrJrE7yNjZYJHLxpg3KQpY8IcrNd1ZX3FzdVlPawCvXy+KuWRU0cWssCeArBYzuIDqrt90bGKZE5H3BrlP/j9/1/93c9YH/IZIfYVlOSzuLerA9Sv57Pm+Ktv7frCu0xdcfMSmt+AVEtXmbrVrm46IaBgIIoVuGJWNsS69JmBNJbms/+ta7ge/rXwkxWoCqFE7hRQnVcB3WDl9RRZMeukxzXNIM443wN7hgaLuNw/Q7mqRZ3gwVmRsYXVpQaMuKTsCiXw+hPrTceRzmgBxWj3Yr0SHGdfvl7eAyfVRHd9telcgDIEY0M6VP1QPrr5LlxI0fOB4w5Tno4VQTMujLk9MoZBxdEiTIQ2JwSz+/YynroGAymbsCeKpgE+zpLSDONHev3pLd/oPycstWuJyZboFVFptqWo5wn292zjbe81VoxXIZACD9cDPU1wQGpWd/qpXt5sMjxwjost8nPaHly/BWty6QUV+RJsU6TqPE2cesfEj46KGaBrmyHoSXDWfAPJiZaE4LxA7uEF1TbJF9Eg0yShbAhdDqYDU9bTmpaYZ8YZwUMBPDNTVzhmvXSQZn8lNGLRdAplbBED4Jdy+xdhZyW71MY9j+NSKCg9F2nKd81oFayp2qUO8WOlXBDNRXOu0cffpT3r/VX7qJ3O3vOasbyYsz0O9CofzFJmMnbhpC48qvKyFXnZK+EugNulFTxWyId8jFta+r4Fo7oF5WFZbsohCEKr0BeG0lhTCZaBT75VrQpvw0MVaijYO9VbYM5aFHcFVCcEBjZw2AYO2sADvgncawPHbOCoT6tEAGOxlu/gunbyiG6VO2V46fuiXbYzP4Wa+U7aQaf066KUtI1DQCTV+jmVtpMJntb3oHeDzxRzOKGAqBFCSYatKoTldJpTAhJkQz5MK8mX06mV5C4UbBi4WCoBZqaoaAkcNzTL5jQ3a44aZoZP4XnRFytO3J65E7UF7eBCm9oWhhKyb32O2aXspK3YjrCeZdm6nSdo3dcUWKmiO/EI7zT4bwa7qbXmXS2Vv/PyHrdlh4UUdVEFILdWVc3aye+mlXNjST3UfwqX3aM2T4aWAdQpABT1W5dymLBNIWoiahHUiuf4Bu4UVu7S3cZkZhecLAN+HTxOoTrDbMPLT9eAn58R7FVEK2FCZyiIEDxdgwaqtIsWaNlAtAKuJjbMTaOZ05+R0hRazWKlOmgKODdwoxXz5D1NYOVqxEuRVwdO851KuebcrBW0ouQNQ6fVCCqUdeFbITunSKyLGS+nxwGA7xR5nkLL8lyGDF0JlODGIgcDS6tq/UPc+AC011rU4ribAxE83BTodhB0y6SFyvGJJpOj4qlZjRqpbjDzM/XD/CzOhvWpOJtzTV+hwFHmGZ1VLlTn0JnEjye4hWrVLVRbNlmogExYqMjPSRar2eMsVg3ylAR2JherGaRhM2EWq9lKN2fKxWqWyCxWM26xIpp9LtJ0NM8hKherJ4wvVhmlsgAR/o6/WLm80xarLbSqGXV1yvNy0eIDQcYk4JyuXrmLmFzCCBSN2z+yhM1MLmFLI0vYuaNL2C5dwlZlCSu+pkvYEhUA7uL/5UvYN5awRbeELf67LGGFLmEFlrBCljBMfixhMxvFbto9sYSdQx3A7wl4VJawbyxhjv5MrGUu6eQXNcKiRmSEHbMcDBAUcp03dQN83H3T5kuSW4tmdC3qUESyMsW6Mv0fv4U6RbdQ/Fihc/gBhMXjlMdjQ7WTAzunbqhW5MJBTj27RnURYa/anKJrGOWImFyjevwAHuBxyjc2XV+LFesbK9Y3Nl3n4LGTnoDHjv+Q69deqQYLFBplSNZO86rV2zTFIH2pkrIdZe5KTkfYtO5pq9tOPEED5Lnj+Fs4BI3mZXokCj3j2Hf83M+51kv6EobzqdJIc41fVPUu9+UdpnISPXkNQBvVTDVCsG0vSnlq9T4QK9KJUT8OiZNxNHFPpawiQGlE8ugaY4VsbUOFm/YMTbVfRLNXVeaK+EhRH1f9hSlpfzCABaA6X4Tx5QgKZXmlMnAe81oASa/Hf08vo23OXh67uzh+y3NZcbXCqRDBUs5oRqm6YqPnCNePyHjU8yK6QwzPFxjf1CWwAwD5j0aAjDgqpFui6ZZWIaKwMxAJThoitZOGSO1rAxF3bjkJnHQnRAtfFdeB9yBLAd87eob2RWviOv1WVq12988E79TaXu4ZbNXrYTjoD6wyutUL1GPx6kH49UHgw9d1xcBoqA3Ug7xINb3OUk3qXRT1v7odCmqtl+khBZqiHn48tpUSwHe44yhjGG334I6nZJtC45Ai+3M5n63LKNWv7CEveaL8ZnVcQmir+sTW/F6DrIlaWU3QKjWxH6C4TIrb3x8EL6Iw+0mcpUijMfP4oSZZpVq1U+9zrl8wtn0iwSJVWvXRB4Cp8EjDgGSslwZxWMOvRf3KglEiIDSbAxxrPtBDLf2krFUP9LUtmTQ1ezdqRtdKg85x+uNhqEPgWVXmY0F5twdqig6gETn7UxOBWvZB9UHRP1g49eA61IML1g7mnoi516hy6q1GusxtPM4mC45QtP4upw0dQBuab8NsokAtl2oQuMUG7uQAjsGupQDa0Td6ah/7QfO8W5ODo3hWtaM3bAHHbOBe88kDeB502tEYklJz3U6zK3CiT8gYqhXuOjQV0RUSJwvir4t8JeYr/CbKBOJ0AlIZFBr0O+UNm4xDHwtKN193B5VxAB3CTOB5UNScXSnA6u5gTesMFcdBsikCEcPwVf3mIpvTZ3V6rgEjgPODM1iI4GQru26787h0MHA6B57TOfCszkFVtSABf6V+GCm1XqlT0INU9HV0nW1Unb2KZc9Y1vEYp8Vq+tBX+4FQRzfO4ESvt81A5rqd5eQZ7CioJW1Rl2pFqmaW0lKA2lqTDJpsY9GRGbVF25bkPMFZ4gO+7B87HLxXgxkaV4MysxCFOd2qzEsz8wUlXIsKmCWKZTbiIe7GWxLCgCYSaoEuqPF6fk91d0Tl/gh94fc54r/ShE2K+8upmrCx/t7nmDFTRXRzXTyeMl1WjDUAPGtT0nv5KvHWC+paKDOBxZouD5QwyUtqP4ya1mJNneqlcIAbNcZFprTMX1r130VzYwdN1lvlXBWeWb51msWabbSVVqEov522T7FYQ9Mt1uSwIFBMsVizAwnbp1is2Wksh2yfYrHmFJc2YbHmVE0rTsOuBEVPWqzZZT8XYxh4SHDSYs3piJ2wWHPG8SzWnLmpxZqzNrVYc/amFmvOcbZLnkDcI9dgbfKkxZrd0y3WPHFTizVP2tRizZM3tVhz7qYWa57iGnwaFVMs1pzHFlRWYH7lfLassp16tB0jUdB50y3W7EF2Nbiynbv/BMJnp/Fnp+lnlfSCFDVRNWclQErQbpV2aKRBKU48pQxZdNlKWznEmSxyKP7gIf+dzn9u4MkMM51lnmYIqTJgaM1WV4j+t3uKeRsygCYDVqoAkTtEJcio2vdVAVkVAKdxddsImc7jTOdppkr6iiwFC2K2kBaYNR63WGNoat5UgprD0F9dnMUvgOIklNIWsViTjlqmqWn6Ao3F17HXvgBKNJTlNeqo31+6QKTDQmPu9Yse7NEUjM0S2E4rkvCASVih0zThtNTwtlrTFmmGbjF72jjzdh75QrILmiz5PFOkBk5zt91S4fhsqcSoZi77IL5FHFXQSiWqi6jTgLtl1E5ErVAxJoLbAuHLFpqz+r5tY/4mFX5VVbZYTHlhuVI8FQln5Ut4kNgfuYh7cxGM3mT0VLroQO5LdfmiNCRflibmW6QHeQfrDBYDZ+RGV6ElMR2j/csXqE38uMBapsjhRq2mUgKIXWXxuADmSyHCiuHBGbDl+dpxgqyxNQUfZQy5LTSWmJlEogUqy1kez0Um124uYnEskSNxC10u1dRoVlrbJPWEBvAmBrzUhZGbumKy9GUelibEyE22xpVTai3c1Ixwqlm1cLPdWLipEYcEg5sYxKZxD2Ms3HRh4QYPH+ObIuoipF9EFyrz1iLPGFpo6BWnpEjlrLdU8OofLNm4hrOzaucfNdSXvDJa/R+FpVVNMaZWY5vyOmc0lb9Vg6mAo1VM/dvAhyaVE2vUrTqzao7B8IU6l1d76Hr16GNgZdIyoiWx+/utFxWJbsQalFCDeZ773AVrpLQOcBLYIxiqht+hJtg9D6J1jxEezqvkfvX378d9KMeJttRcJjhBX3UyPUqkeYUw2YPy+tKHBuD+jUpp9hm9kZ1SHZVs/oE/8gG1jogX7/6rcDuuIYqI2R0CuWrj0fT0OaVzoLwBTT1RzMzTqt9tL/dlzvgOs0JKuCnGnAxAa+oKbAou3FqDgQ2QoAaQqO4kAN5G0aqYG7bhu9gTcms4pPDWodw93qh4SA5YTPA/WHUdw4bN0F2Y/KoHr+b3dX/BPxTKBbLIWGThBLEdzg+0zdqHUafGw+qde6plt8ou9brQmp1Qnpy/zt4idpMDDh2RkFcRRbTMhTqwqWiSDlU0BEQQiodHpFrxCc7J8XBQaYbyqVXRxA9FXuIuprn9DraU37WZhwK9mb3+UAAw8P7v2zmCH8/Tx+VWZFEqZwcW6Hux78FtZhwKqWonLLnguzKLFKwKtJf2UHZcbl8vhqsIkRLskfuaELQ0pJ68qbsLMUKcrenqWbjNpMiqmuaaPZTDuZY8ULckKNGcfyVIxii3qG5PjrgxbW5ym1eWREWOCXEyVDH1HAw2A0ql2KJJnhyE1dBNOQjzSOKe91z0uSF6rdmfgi7oZUmPAZ1SknN/FWRNJcDYPdr9j5Odonv8uQwSgi5FC76/qqKbFU1JUiVd5FQfmQwK7Mw0gpqiqQt4w4mQ+mOgiBdJ3GF9cdFUk0XN7O/RZtNgfIsmaxF6zpmQraY2RRe4giICocoIg1aXtxZvCn1YhZq0B0XG7nNManaqjnEyjiU5HMI1W2hGogHwyx76r9U7pdfyAftG6dewmswj1Bgxad1wJq0bkyatXbqkymChMVii7H/aokQgV22GmuYPieOB+mGKa9GuUZXMOkE8jvKdDrYk/w2SodqefQ4hZkXhExzNh0HrozXgXgTRz57NjGMFuygiPLvmmeB6vsyExprcouVn9lkpnRoAeqO/R8RW5yIbV6h5MLqj1ro598uR+1pdvnn2+4pwiet1tcsAgH5aNZrtjDb5tfRfz2rVVXJ3bZ0RA8jRHFVrDnK5zfwaX/SaA/0UHgPZ9pFcmY9VZqJjQjHQLm9Ur4DUcSvEjGJLpTzT1KA9oyvuPm2jd/yhHOe3gWLsg0vEaK/Rc/wZtOxGDXfEEm7npfvzDLGv9vXIHuEbNDynufXQ3pZCymS2cYDPjKpcYGvky2iRaZN60LBErM6ZW2L/segyv2xoWAx5KtOwFaRxO9uGeC2bXqGMFUO7PFqmJdAujbOH+HwZ8LlI40qwDZEq1vLYzQ24EhTauIS/yuG79lA7jfP6sdxYRpQcuE/maNZkjMXuJhdQ9GT7oa+v1ldnSiAGiGNaAhfLLbVH8nXsMFZQrEUBRFWO5IUcdRU+ciTv6ZG8Vz2SD6bJkXAk/xrwIggNytDhMnSwDD1wow3dW4aOlSEecns0n6+JZckd1aP5HX1f1qkdONPNd1BhTptPsafNdXfaXHdH88brlkEjqjtjiKfYzUNv5LhZcY/qTujVGzlvjtXkYCbbAjU5iLbgcL5eNqi+WYNw38gDtmDvAnnliRs0f8K2qNnHuraF4YTs5eH8Dj2cLzjBtm7HCVr3NQZXaqYA5ThWNbPCDHnd1JzHWrJauT0F228LL5UpAn4j5/A7+N00dX4s6RS0YSeXfgp18oRmDLh2lkf0dXtEjy0gpj1W+5UNSGcnjugz6gKKAQ7hb/Dz0zV0o5zHK645mOiBPLqE7tbNqbwDLu2iRdpiADui8pAxPN2xvClUCimSkdFT8LkhHG0BqP5pCjBXK94KSzRc+zT3qdTT/Js1R4zYGWTT2gQ1XJVavBIpLdlFOlI1Xqo9dd+CpxhoTywFS3lI1GCnEjMPitJYZCqK0p4oSnuiKO2NKUqnwisPxcaWI/Nts141OVkVpfFURWkUrorSCnVdw9x61iEPqtLLop7W4dFQVWl+PGF0HcNjtbKEzZsCdTkDeo0sZ7PHWc6adjnLJpezrlnOmqWmtOtnt1zOZsvlrFtdzpymdJ3O0SrEFskTiB9JZV1bpvb0dU367JY0lxFLGiMHnVLJvUpzmtEuaHnPLG78aVX3MKGei6isbQkeiV3iZkeWuO7kErcyssSdO7rE7dIlbvWES9wDry6XrjJ0rAwd1dBJLYUrX8MljttxcjSbG/KNJe5rCK5Up4Rd4tzqppXmsRb677G6zerq1t1MZToDAJ+Ax85yadNF7uVuidPmuyXOUX9d4rSfj2KJu2HaEudGz1U+ubqhwqmrG5r22Fc3U+UkndrpVr9p6aPlT2iXja53TofaGKgWQu4uER9n06Wr1fQdl1umMl2mzqFAV6v/W3ZgUKOOVX86MfrTj8+ObCcHdk7dkZ1iFzCKjb7h2NaMEhevCDltHVMl6q/pju0bO7Zv7Ni+sWM7Bw9oU3fRiW/s31S/GrVhILAMuWrxZnGoqlE9vq9zGXdOZJzc66H2zbSrj7fvQ3BzzvyGkkSVoWM2BPKM5Ul2i8VCP3muUKb5satIAeNsIqCow2NIhRlRoCb8UM8HMR5t+BZQzwc47KuAlgNqAgaxtIAZDVVN7HJkas/TAqZ2QPOg7FpjWaI6PbCWZowZmQXTe0ovQDGmWTwfkrFWQqTLLZDSriwSqIy2EaFFulZqH3I9TZHzA4poAfwAv89e7zxeWOXcNP11z/OvVRNA2edvVFVR3xptUe2PYFT7wxeX6tBXhbD32D9ff6gGAGZ/i6/Jc+eYUKVX378Cn1CMf23kkfrHqX7rZrUzEaLuVvNYKwvQClG/G04pndhvh1dVPnauDzzre6ZP/Z+/8aBY13/j9SL31/jsH/UUoOKg/ofg2WDCj4JlhhS4gXVFiaPuiJHBJiWkceFlJi7i1wN9uC7HsffV/LZm/E+qi/qq+8mWKHd/6mc++TN8wu2L4UvvpepNm/gctv9JpHAkPz5ZY1OV6rIx+7hYKBavNcHJ1hmaOhNR268oXrJSqNd/6Yu4APVXIN9FFJS+MqUa9SebnG++gtq4aEg6k56elI1HKA+kZb+Dlq7oiWgk6pxIQ11Wk8C5meik2W+p38vXemzZNLh2wryoLyfEojGgTrYZuyp646oyTjHWMZyqWX/7UXYLuDzwfDhTzqDaj0B3eAQdcwrk6Ygb/iB9kue9irzT1ZO/WOgRuEnnfX6z0PJK167p6zzrVt4zxzSXG5vETCWAxExUPMwOrBwMSyTGGxSti/q5KI5aRXzpppwMBtIPnRLRlUUAC68hwe/5GnCpV4TGTqGv33M30l8unberZrrR4g/MOxBFzNt59goK/CtyuRHwwxAXuLrxdPAw8YxJNX3wcKFs9QujFaCkWI+sSS+fSDTwJDTVpxSJ65tQvhKQu1KRhQtOb/RGzOw5fxXGb2RojMDq9LNWDHdKA/AiCr3yCHGQBgRN8OC2KqpiXrSwRNZZawao0fe+D1ALnJZFmN4ch3BsCi1qR2hikxxDL2ZXf0/2VqMu/+nf1bsWauE7pPomau9dY8B7F9VRRKYGwnbiIarjZFUjIrFTC+PY1IBGBjRZoj7rjl9xDVSnrbE4CpErYkgiZDzCRu6cOlJ73qrqrSXXtexV/HSBMLaS7K2AhUTnmiWXmxZyC2JVQsQhdIFH1hOGtWbPT6mOKuXurJ7VU5FieNALoIHTjdZND5auXdTIbkedRUTIXDQpgsYbtovaCikoh/IAv3IVUk/24/hmpVxeG6J35PpURKij3H1RpB2b1pUUQbXdXyZnZXJLgQxcs5oVwJt69ja1DYF665JDVnYzJBqVyN2Q8hPOU34V4itFfgsqHwZOFeZFqJ2oqxL5c3XEQAcAamqgPYCP8a8P5GkADvB4FdlCuQlSO4IyEzHwcgssw+UxPFowq407UpkCEs2uTEhxVsOtwtSM3Vr5bCZvOtN9e3XAs7ICdwSuJSix9DGzOdain++I5S+EEeg8TsIjO+EPx+WMN/eE/MuqspJQYye8IIMRAdb2AVi8JbdiSke35qwP90oZPNgDtNcTDDOiukaF3PlxFrE5+fC/mOThsHDe3SnZ91/+4cGPbH/xT4inyfLlyt56ESFm6BxV3DHguKHbwUjykTuGjtU0CBr0D8VrMCL30S9yndmX9boEn1/EooNBftXDRffsfawC3yitdj9v77pRqgqdC0MuEApeDXUIBpKvnrkERJYnBqPZprasKRA+SWcHrnVciKwC7I/pix7uBLSAby1FXAf8anlibD5BRynBxZWxkpgIoBVYYtZRT4MTgLd6x6C/SzLBPUs8ZvQuYKxQBMQCC7udjDWqKvbCW4d4XHFE8FEZGggtrJPqPug+XHK/ag1rPVy25IKtgzwsh0b9sOTCMpAH5TO+F+iV1tB9q2YWQBYWqCX29Jcqq9TR2og1WHcrpl0rFTh98kS9SfU35dSp/4evB4eKeKO96TEF0qT7kaT6m7IwlmWW35+7ptmRapzm+xKtup7oZGmE1KuooHzCC1RFb9oS6ysfDi3IQJk4u3AyZKQNL/j4x/sUZK8Ruh1SWEZe1SscSMkFr+qxrDDKXosPZO2O+h+68WnQ+AzJv8q62Is4On7ZGgatzGtzepLT0KYQbVPms7Jgp/fXg7pQEqptFNDzrNqytGJNjCg3cnf0g/ed89Uzz7yyeunJNT2oNF2Ii7ujCb445FGt9JOCddw3HeImqS2LXPCqHjvWcW2heF0hXMQ2y9Gh+g8E28rl7Huy/PsHXA6lwGl6cj133Er1oVYjpX0vctzhqFMIK4yUMPaaIoeunXW+ShqlgD4AoaqV3BGOUOcBBKf21aJyXlaFoHiFtwlEH39IQo7FkEwcJJMRSKYVSNYtJOsTkATy1k8AyYTJ/ggkGwxLwI9p4RT4JQ5+gBt5OcgZ79aaZMEHzbCUE7xUN4dQcgYpGoUq7kwwa081pnnfgKuBKzRKBbKF3wPl5XcOCAS9y3Tig5sVrmHD8z3HlFOFeqnbJm8DZKkCVSNaCB15K6nTvR/Ckpfp3iIpL3C2JLSql39BXl8nBMmnoNweOlrok1+lgb7rm18Zprc+FKTXbbKv8fowPM8P9opVhD34wehf3Wc86F1TeNoa32a5nrN4LovXuwYNF4+BbxcjtLq1gZjg9Wh0lUb+KCDnT4OcOmBSACowHAgWysusmRSevcFQ5wAsuunjva/h5lJYvlzVMygTOpgJwd8Ao1QZnDuG6Tk1I5A6JGsKdgzSJ/JP92XT7T9DH30MUnoeQxEfZG8WLPWzf1KT1cpgCjyNI0T0aw1KmLgC/189Xzfm/x8TOgk0GbN0+/9SZAGGdVJEsK5+AYmT2d0F0hqVbKAVjTVZe1he8c+ouZZ2av0hZE3ZV3W5nePCso8JkJPsbQL6P/W9aFLGJN34F3dToiYtU4GTdGVEizdwWrzBpBavS5dUTJqTLh696qxl/4qsdk9fyx7SVyiBB7Kf6KuWfiBbTuznIuznCCyV0K1AMuu2H7q76vRSr8ojLhD1WjxCbFzEPxVA6eE7eA6QG+/crPejWRSpczJkzwN+6v7E6dX6DrP/GwYXTZAG+NqHQOokX+b9w9IZ0x1PUMy9CneDXVV1GwNcEMRL0wu4+H7XoIPff7vd7Pu62fcxK76qWOjEGQFkGXuxX4JbSQzFV5AF5E06rQMhmX1ltSyOISWRRiTpCw3aEnqDBz4SaIYKTzBCYKmlD4jgeA4DXNJE2YELbJWlQzZp22g96TdzS/uZ6SM3qSLH05pQAELAHt0bKxJRUNn5hemfBWHjulhYMSc38Uq7BGCmpSiFLb8d/JwVo5hWBYhiFFT3lJJB76uEeulauHXIz3hf8I/Ypsl5lW7o4NIkt9rfDcl0ZnD4RiaMeZM4eMsbEDSC8xbV8WiLcC/YRV71YgZBjj/M4eqkedsw71RNzXu4o5OH/MxcdOqCuufqULZRtIfgVz2aIYRqKG2IGrEX8PhBfJf/eiNJJ26Rh0BG7SMU8MfrF6Ad+GQW8bvyVDN0afYItdeLNkuhMIpyUYdfdNsD5xW6awupWeEumuK7psj6T8NEcreMPGi4/7kK/XzZlFnpgtmUec7yRC1d5B83BWrZH8sM3Dottt815O8pnjfhOEOdVrScz4ob9NDezeqz+Su7qxPUVqkvmRsHmMXMZZkq0laNXIXv9kNx6yXLnduj5Uy91XvaM27/3PVH737dl9/6FR760u+m7vCU51BBt4rK7c7ZHGgDj1WSqne6xIEr1fkJnPyqER0MgJUPlS/REbx/0byvu2tohV5o06tzkMi48w4dk5ADGMu6POEngC7NfetozJcRAvVHK3lQq20LyqKNERJUwoFkrArIltO7g1DkMQ5ox3y3VmEXUEGm0IjbfcFksaciUPAqAAABcV3Wm1xq/MQc5dAY/xuBXikLplT1jcprSGR/Q07L5P6Yq7hABynka8q26A0tOhZ2sXrcVAbMWdD+gkEmkp4iOFKE68ZnYjgcrhumkbtJHmTqNe2tSp71a+0vxGZXIqo+pRrPyZGK5EgRrMstnYiCSg1YW1ExC0wgOcOJ7hiQTshh+TxOjsWKmKX6OaC//5jRP1T0TwT9ERLnqzoLdFzzZHQ2BOVsSPDKxLtTYn8NaE9x5dCvaAjiifHg5vEw357G1hXzVfA7hvmNaZiPog3moxIONKZh/m7DU+plVW8NDBVWeo+v3/QQzb3Cpi3oZe8W+nKf7wUVihY6fg78RnbTa6YwXSqFjUZ4usjxdNEkT+fSkao83SOpAvckO2uS/U3IrngF60g/qK/CrpHveLsIl3w/iK8dWxdpvqBk66DFBSw2bF2kbF2E+pX1mMLW+dyqX5VyA3NIIYai+En+KFsXugXgJ/0QptdwBvOY0BhYK4iMgOwOjxh8Pj4ux9NxGYiFk2mwWkpdw+mEWw3OxCeFvuEmhDssCXcI9A2noe+9nh8+5pVOjtbGIcD5VUiuPY3Bsk/rKWoF4Qq1h3o9d6yH0bQeokjTQxTOgWhaD9/ueWGFww8VkyO7q1DDCeqYGYK0EF33zVYFcbzH09ucPuZyjFAkxD7Ifkimgt3olDuDAK9AZ7C5cnW8ujNQNlgPXNw+YR946GM1y0T3j1p+KNSNAvxaogXa6OyHjVRBOVvAemLLcPg1/wG2DJ+MgrYwa27DEDiCinPwUCv3dZylxzgTN86aMZf7C2uCxiYm5hhyl4lr8NRvkuqcdJYk7aS6OZA0SRCk7NFy+tsOmMiGyEHIyx4G+cI2op+515RfQ60IGnJ+fzvx32U9TQZDL6ee6s34nc4rmx4qig2PmZLkR8g5ozb09TPklEOTDvMDm6jOYDbirIjzlMmEzEdG8ugkzNRGlkeBOtgVD2wQ8JwFt9ru++yI1SdQg2Nv0VmCT+BDCa6AOQwnj54U5OiX5QCkSppDBjOhH/TU9pWDlpi+QDlz6GE+By7LbaOyQC5hkwcrHcg1Sx4P/wGaWevHDBMPdhX2XLNGWdnRAc2pnseYvYKswmRiMarqfLSRpU0ziJoxatsADyADuKhFPkgwjTzQxTRVKJaVMRMbpaPjG6Vt02JBNHTjsnv6TgnLODZL2Y+Ob5LusBonbPZLAephJl5U9XynyWdVkndPJlMleedk8kIluTuZnFSSW9XklGMr/fuk50XXGsWZCj8OTRxf+cuqs+LqGZ2LjdVjsuB9ZVxVx6FW4gLYcqHy8ZAfcv5f2WsMh0dY1F2EgzwWdoSCiQz4VHLlMUXgzs3aGeNoM4+dP+Q0fY/nhdeqY7IMhMrJl/W4quzT3tGJayDBOcwhC+goP4Y4i+QX91kRoT2VHZhk18xD3lqocRrsEFwObjb3AmlCPYmbfpuJSCBK/7IXw7it2uuIwAHXYBWVleiuGPWliH4H/Li/tjYyJlBYdq96yA6DCJDxFknF0kqyPizkfEsUmhpy1iz1iMPrvDlmW7JO9YGIcVIK8xYDvM1Ft6ilzFh7w1jdoXhtgwtOSAsU+Qqa2qI29lFtStWHKxi5Z3Fskwet9UwZsP+ui2SNQAT6rM1k0Q+ddqokoWhURbLh1CTosQmNU4V+NYIAnQ4tKkVZfS/9W//klQpRx4RSYRFyrFMq5NpOoEaICnyrRuh/f0WN8Kv8z+PIB/lZd2qEd7zGqRG6Wh6R4uD+x19lcPCaaSqDAHZ25DWTKoNDxNXS/1V1R+70QZ/xjp/4k4dv/vK9X3kq5qVvlP02hgWvTl0na5CQWnd05IOvuLC0TOa8wDbMHoD8FsuZO9HwHl+NmFuBNRP9AJ5a5OwKLIpgTbZ9yjeoTZRQsxj+2YqtsB7bkFG2CilCfuF/L+1l64js7zJsnNd/0K5NnjKtHumJTIbQ6X7rfH8BIRZCQjhZaVggcwAQtT0NTE/N0Y3Ky1tUPXyQwlWw5+u5U82tHRVIpy8AnDex36OTShiqEJhjjIV62U9rh8FWOzySSuwMLrzK6Y4uv6Stz36mssM2Y6o2rzwrc+QP+kpHLGtuta58VcEbO2fxYUzEJ8N3aKU4PXrw+srp0fvzKBGXh41XKE6jB2Jv9+CCGASJLVb02Zfj4FY2Ey6ygb7sQm6Wd4650CSJuP12BFP94q6xL97uvrjLffEOBLGDHTRV5HgwlvtkCTa1kQQbZr0D1KtSfVlsAjHCb65tx4g9ONdH43BsftBbQ4lza9k7kA50UtzMGUYbeUs3zqJ90AQCZz+LxGm8L7UGQzXGlnB+a8cqA4Ctohil4Ffb/PDUANwM/3W4aGkBpcqpF5kwsfhIa6eOUZkqvNJCODgK5EBZl+DiubjG7nMABxRh9fig1gpSuCP30/F4L+0LyKmefUl734ftMEQhIGlFUzjvZvYOdBzliAW+Ml34EHGq7svMXi+P6m2AIQeueWj14d2mPK0YdU11SyYV6+DMIAtggY2OqaOp3Dww0EOyArtidYtiys7zD2Y0g5QZQLZkiTuorNPPjIFuIEtZWz6Lg5gNL/d0MBTyXAvWEYwQyqFwrZz1e+1Tc1KoV43+QS/HQHJUoJG6DvOYBxjzOczPEbJeK9//y97v7RXzqoSkRbaBuAtcDnf6jocXxMHyHQ8XXr5oW3H0YvukENUXS9wAWPHVnvN84T7L5qUzRQu4K2YPO1Os525BJxw35XEhodHB6Tj7vT75qJS20DLNgN87sP+XGAEeXsAdnS96XMrferSF8/vX9MytIfADoutd4bE8q3bXArAo4+K5tlAmR0b1vEMhx6M/M2u0wCPworc+4/I/bP/FxfZJi9zrYpGWaGnS1O9UQ78wo7g8aeYX0VtKI78fsk+9ckRIUdO+H7BPl2IM+77PPjWlQJMEEi3LhdsnMkwAXgqjLZyGh/5Xmvb9gH3i0wkrwPzpVFO/mxn63czM72ZGfp2x1xUAeqKR4yZ+pxr43cy872bGfTcz7buZYV+NV8AvTzHr23v4W6fMgy2wWrvKBmm3Upe2wiDtMvWmGvpFAYTsknmJVgifwWjpkn5WSd8iSCbX5g42FVgou9giUYebzjyz3o882AJ20yJphoF8o9/f1dRe2cxtzBeWFRgZxjzN4e/Sot4rMlU5nc07o9N3RniBGRXs8/O6NZ6VYtovxKTGoW3XEblaCKh8QWZvz7RNo/X++RiBk6Ng3OBeMuXpXA15UuObnEspCyl8KX1ZOuLjkqUSXEdA0W9UPklIqSOLcWeUfFhxSaZNqcP+O9qhFNBamNU22Tdto/aqdePnfvjti+nHI/ucUjFW7I3CwxqxV/TVWdFabs941bZkP1Rx+7xr73DgvE2z4mmIM5wmQDAjF9JYcERNkR7NrvX3crcCHaDclzGduQwDRXNicHSzQZvE5kc/iG7smtWxM6zLltESHvDyLdCV2zIJLDjOM/jQfRT40H1E+AC4CWSKGSMsm4eUdgZGCWY5AXedfeGyVC1ohve2k3TXtKaDBVfrFTA4MBLPZsxAbg63PgPLIR0LGS6hvaebOsbEeSZILc9juI/EwnoBVSSCkT5jpGF/dIM66/iSeQrybXwW4vV92saTuyeiSYFfjIrAA6OLnuCPDyvYL1H4O7wExwS3XRYYTbQceVU4qlBVboobbYCL9R6Nvka5VGrkPjRNCHBGrcGatgHNb9a4F9fxqv0Af1Qdbx9OLyQ3XgEbA0+Naurrsh1dHznATxh2QVHBFVSuo3f27bNYQl4b/WH7LBZBfrugLxwgeVsarQZE21WTVauhrlBqfI3A5u1r9q8G/6lYqaxe1j98jPdQauC5hEUqRj+ZAITABVtf3il7KFAOqZ43p61Q+XKwF/MY97m5Vx03kdE7X19lP5M4m9RAVWWQZVrNjHyUL4/NJZ0CmU4BWgbGO86pb5/VyA/bp4BaAamzRmAEIDrL27jYlpZ6IxkmQ6a7I9kHvSrPpAVIVM417R++F3CEvK2NzYL4AfEpyzvHgVBoINSs9BRtUU616/qOgRaUJ91AkM5RH3N0RiV14pxshgHiwDHOdrsV+ZAnUj5MJHQzs73MM7M+aWdlPT8a5cs6ebQSM4UcscSBknNNt6y5KsQI1aInozTRt9CUsoFcs7Jt6pQ3cnzC6Bxn0lMH+NJRRM99u7TOSdqswGyW5uU5T9twlWUbLQBoC8ZfGcS2Wd5y+9pEyeqaEn4nOdc9hTYrlmVkN3lyv0s3GMFLX8LtxPKOdRNkS7cg5iT3DmoN8lZ1SwcpRguiZzVqaw49Pj1FO2wytr/nhNphu5x22E+NH3xc6Pmj2mH2AELlhJqgqcYKeVVVzNVeqDYwCgUXl10PcQB6y9BQodiIkCd5pEIeH2ell6ISnELDVAl3U1SPMet55A4/wHDBEN6CwIDFx4SbwFMTb0v/KEl9SOz5D/dT7TNwp//uAp2KZjGI2vqK5k0k2+BaZRuMJkFXWyX6ur+treNWCsyAiEJlMk38FmaIn9jNNjFL4NPBscQtfm2jGGrb3ewMzSgNxZVFmKfHbra1PpTtbNHEXrZJ7epeNu37chutwoy2LG+ue9kGUDfth4LpDYrzhFLBVHNTrsWht9gbN3ArkDflSZiC+8r9be2O9SKD9aBBMUuBOmml1pGihZdseGRYzMkRJxyZeaXYBSCLiL/jHsCvBf8MaVZfmngZDPOWHiQBxXBKMXqAwl1DsanmaOHG63BIc0f4+1Y+R6K1Wj30kqOOoq3SFTn/euinv/D7z/mey/X8y43xsYv5nKiCAlXd1dZoG/xKFVSrwrqYW3cpGVUs0a8fYZBc4BRMcAg0tz7kBs7lLXNUpo0UE/ZUQ8FX9tQ8Mc52Tpajh88GSoX1dB2o77P7iLylfvTEz3qeVOJd7rnKh7pFYxcDcPZhv5MxSHEMhZYNBrJF6OV109YZvcXAY42RKaJb94Xf9r9+9i+f96nvu6qtw2SaUS8TMJFa7g1ZKm8tQuUw2TwjMyQVp1suQwUjFNXJM44qcUc/qfLivrRd8Fb0kH0VEbbW3dhUDi4pAG9Qpd0PTqHdk7H9XYZ67ih1dLPCnmTizojnpPggt+4DHLyN6oBXzkCzX1TSradjXn8QHFjD8iwq/O9FGjQXOFr8EuKplwKMCg0/0+/xofWIJinpC6x2RXm+HCIkP4mo4qjHtTyyGSgyrgegkaTKTvY6qdD09LwxvWS1AfGBE606/+h7Ibr+HmhWi8kvFQAj33u8PJYoe1N/UuZcF5mzWreSU8cYBJw3MYJoImmOxyXNOExRW9S89JjafMJdY2ndUa8Q9ReqGUFz3TjR0Quv1gWMKrz504TMSSlkroGxqVml5DqnoGIBmPW7GMhDT8m6BepSS2eq+KIA0CqN/ZcEP3F5thvKuFBtNBZtdRUbpfa6mK2T0epbixx/9CP/FGKB/yU9MiT9lLxsAxFFxbYFHgb7sHh/1eciBD1/WXLq4RL/4F1Ny6BH0IuoiaoQ/5RJekV312jec8/zz0WIN7F7eAe7R2OfjTY8W8OXnOdfUh4Qkj9ylOidXvuO82vfIaHg8vODy7mWe2tcDX5dxZ9HFH5d1IOIwq+LutHjKPy6BkIr2ruA/zj5FiTjN/sV+8WdiMJv9mfXm6j3IAq/LuqoRB2tRh1DFH77GyLh5yiY//XwW9au1n/xW0ZNHJEVNTegjmPTETMs23eDzCh9MdTGns76gmaqzgrY4hwbKmB32bkY6kmuQN4dauPFjgAsw4yVbt2p+FqJB0YUhoGy9ylZ0DYLpwiSc/cNVXXh9yNPmj4TbVa169JuiwgNPIWhHAK2RJLPD+tBlCKJK2ngN3mBo07lsSRo/73X6qmRr+4j88DGQVOgeiapN9h+VzlyQ75+zvOhKeJ0MCPjvgJlh6p26ePhq0fTBCozWFyRmIjTY2kvUhNKvkc1NzPVyhS9Ugqzj1R1McNSFzOUV1ETgC4mP6q6mHgpQopHdTGfyUNUGmiJ+nf/g1nAIj3VjqDEJ03V1mcfRdVyYh1tdn/rV/8jKGN+PKw60KlqttvWajgsYtVhiI3bZFeKAi8j4/RaHaVBdfPqa/DRAu7pwApHcKBUyQyN65fM6E0mHCPaAKo5qziHw3dd1Bu6hzULe6KrBz7P9dhXMxuDE2bNSIaFv+lJbipKFXZVDUR0Pf04d8oiC3tGlFZXWKCu4mWgKpSVg1yJF4UqvcsGQGy6vkbl+hpgfQ3sMpeaC1qC85b/iowoc4E7Y7x/UAO5BUBBWZUWl0hxlCJD6ccJu6fEGeWwUFdmM5Se4oowvCxXHRVrio3p06gSpJt8jqecEsuz9cQ6kNC1vHtcFLCnVIHsVtQQVye1FMPCGeyaEAT8WhDAnXJ51+DeRlVvS5EKCvMy97NDQkJl/H3wNfc0cA+nvgbzKxAto/Ko+pY538g+fCNfQf4UkVrA7MDV5BOeBz0NYCVGHf5V5OOSxAHVp7nX0+ddmhrciWfVM/LAfr9hA3ebT+7B837PeUYWCtbShiWiDnVPY01IWxXbNwLN8R5+am+5dsSBljIC9FVJ+65gbd/s35x9/a1vueZpxgl+qJkshNzxjYJJP8o+gbyq1HA0GlTNiXDBbL8AaTXeMyo4jRPkFKtYw2HctT7kIxOqd329Is4KMEe5D8axU1fGE9Rhw68oW7JhA7njaWOSvTBk4AsL+COoVIly+1vyoKqORkF6w8gV+4Nzo1e9f1/XGNR3zDdXOVyh+uohNcs+gazaMCwF1ujCX7KlxE+6UjakFK6nbAGF6+mHPM/ax0kKf2D0DHmKbxTmqhnG+0jhFG3Jr5iDOOJ24ptlMa0sCw8nC/fcl970wjfLMkyf7wgAOX9ZEfkX1pb54UF5L6IAi4uunGoA4f24xSN+mvln2Th+ikCY7hVoRk6bbK5kvijMHkJq+gHf8ycXPucCS/X5Qmthrh8KJWAojLhK1QULm3/kute3vvBX1cF7F4JV9AKMnKjzSJt9oaj808XPMjf4tWiw8D16pYupOn6y/UxCXqRYG+lyaNUqJXtWXmb3RzQQXXs81x5P21NDe2on0Rjd4qMkK+sMN4HoDx1C1K96PvxcCbgUq5Vo+k7aFFi6HJrdYOUCgC5ZenkIbhGF30T7sViJdkpQenMfVo2opJNXMdGudWhMD9d13pSVKEXoSRqS7vGMka3T9/IlzfX0OxgrpkgTIEg3PgH5qqASFCNRyMNSmViAcRDgGxMh/GXozzg6ca9z3S/M5qD+UMrP0gdjEekGGgjd5+xCskMQ8CLkzCiS8BUS72nqZXlHYrN7gN8iVPjRT516f3rO7NO/F9CW4dJEw0IMmjIO2OM1wRbI1rquYgBxiBeqQm7CVcOhJ5LFTzwlkDUZlStCM44G2owWsqoRe9LT9qaoWK3lmelgQKl00TIm0kt+uQ3TW+7aZBSYS/IdySkCWIqs6Vnk18iuizTHM/faAxYYz7di4hnEORycla61wJNDj5xmcHXm1nw2BX9GsTQSraeITz04DQpl+omYXaQ5Ck2tygzei1M2yjiOkzramexNwpfP0dyAZteRN7X6eBFaGjHAjM7D/VVra2ZQlP+qS5oVrZCJ1WH8IzX2wqjkVsLv9HGZWzp64x++pZ8Hrs8K+HB4Rx6BkkohUfaHUoj/giLGfBD7HDDqdfp3/dBH/nHXAxcPr5JJl/6K54VufXGLCy5Rk38bR8FeV2/TxUOXjsq6wSJU/S463ncKQ71WFJjKj9wKe4a3QisO1gwp1MLH4+2nCduWDT3jfY/YE2pzrQIVQm6f72bn4YiBO7VKnP0xoCPy8QgdXJf1Ll5TK3HAFNkO9+9RlKvv+6n7Lznnq7DVhwFiuhPtu+1W/PvyxeyP9c4k1aut2pbQXMLwSzuIUUkSYP8uXJNR/rSOMvZVd8rhHKfd6a85siCJPHP2qmC3kqAEAlJOQ9+27OXRj9HjgVieT/r1vKHX3G2NckTTVBvT/OBJTkGVHzwoSv8yqTaKGXcJy9TwZdx+eQBt3C1uNyL8PsDL8TG9LKVWN0ZKJJ6jdfL2F0wlqHlZr8CxJEGlUvw4zKi33mLmNprRa2EUrxczOFKZoRTWOhqU4A9fEr7FVPRwfprp4Vs+B8cXB/jm2EY+7+aDKl6EuQcdEZkbLS6vWASnEUjZxRKOOaX9SpXQKyVLrm+SRiZaxwYmCpaBGVzQmYBY15KoZUz8ZcQeimjZxgbElT4I1FpS4KGi0WLNJi7TUHIbGjnahMzmBRY88iZURwRNwUChKaYO0ooq7Xm4xsXy/oIohc7LRrFIi8Mj5NMCkGNhozSLyZNrCGTqiyt5D2TZowXqXCpUGrFg8MCKNIuuLBOebvVl8adZRgVb2IOqYuPJ6Mhw6SxH3UiRpsy5pmRmTzutPaYhc2jAHC2ozXqqUZfrO4/bApJrPTLnDXuI3+ZP2n1r3FJJtQd+iwOgqLL0KRZwEGLE42bDfNVsmH+RZax+NwqbcsgbXmtpQ1jSBkMDDvl2p4lvR/SbPGsWoO/nsTXr4hP/sVnhun6rMnNwX9bqH1Q08MeaT6ovzjOsoeKU/suF5OnVVUrUHA+1KaaZNWoe2FD1hQ51DuBuVnt0nc4jUdKCkhN/zEOu6hmoIKZW3sQsR1SqTKO2Ls/+VOneiOQF1jw73C5cS2uvjXSl71ePnTNoYlaWe0xvvWUbG+o2h25QWFXfbAunAmKRMeU2ztE6aiS1mKt0p13hPNvUweE//6hKngB7o5jXA01OZjI0LGZpjs+O933X2/7q3L2XfuX/IxfkBWwm+xvJOwdnMGvkV++2KvFz9fGXX/3gU7737tfx0jW/zi351jNfs/ecdz18MbXXB4M79v2vv7r8tT9zy2cuxii0B0O1P4RS3XfoXabNKzb/flhpxdCE7r94sL7pBdsIg6uO8QuAQhcUg9Cv8SNd9gJGaj038nEU0OK1WKcHJNzkDXN3KVDtNLhVOXHBhsq1nINrWFNvGg8EHNu+TDj3lHw5D21w5pbiMLVKzowX8AZ4VUF0bbnlrxJqDmAvR9sZk4froGr7ub+qhpQokl38n4h8OB7CMfMAPbhjaGV6q3vXy7uqZ+xdHzAH8JBnXKWHKlRXojdi2TjQI7w76wzh8V1RaPrgUQhmGbgh3QgsdXLXM7D0Zyji53/s8nOe8qb5/85MTVzuwrp75UKtV15ZpfiIloazSC6mrlbc6hQq9qO7/AcLv+nIBVwZBdwzfKWOg7euzUm0OR40/XI9skg/Wq9D2AZRDZChvPV20C9pm647D3pT/YWEvNrcz0mEwD02cNQG7rKBgSdcvFJXHJMpK6ShMZJyzLP0MtbDH/BGQ3eLVWhMNo1aJmgpUSJVZuYpQMNimFI6cKUUrSEW3GPekFIXi6iBxwtVipu8/QQESPmMNtaGgYeA4CysSOFNCbEeguIOO3Y2uwHdUUI9roAzo5LkjoJEqhEz0A7tXIEZllXCngckgB+ahO/bVmnNqYDQDBP8vGU173RbqszBA54Ojr7d6+kI6dsxvA3sW8Yvx+wL8cu99mU3vzxgr61Q/By3SoBpNyMcZ/9bBWf6nv2ZvGlapitDs6LrYu7p1EQDE51KGD5RdR1o6Woh2sY6pC1cG1ezJCqYJ3lJhuV+FdupjuWO2rpbbSv0zHsX78kAX8yoj7dRfaYOa7gW/KOTBTkiq9c4qvyj0FBYY/tdabgLptLFtqhDcrFQMRoWOq7oATehy2kcPWNiJrSrMiDXMWOPheeoJeW/5/mx0bZQRThneNunQFiMUMU2eudYnT8FKk/zVYwFUipu/DnJM28UCzlXRqPhetLkweEvhASKZdkNaq7DjFTNgpdLwP3sisXuPBgzgucZg8d2U617amNdMv0pL7SbMemU3igUhUjuTdkNqzkkXXatzROjUNwgP1fL1g12ZWXoqbCJeoc9VWtooTZX+UpdC5FqbzJiQsmpnWtrUTdWZ/5Zpbyo1Lcu3pMiqDp5L8MU/CRIsLEYBkPFgP+tFizXcV5ElPlFdayyMQ4+8Iyv2n+1G0qa+dXa/6+ni9TmGcpWPHgdJrKr8/k9vaxrWlX4FKha3pCbipcj+uJXrH77EJz8SDBiRzcetb0FsUX259OMYzmr8s7+Vt3Z36pP2t9y6ZIKqD/iaqCZ0lkrP/kLfOJsrP6ls8OlPhvMmWAdZ+blXfv9+JXSn72G34vwc8nafjZUu8Z/FInrHvRBixK3MhFMdSWXoi3SLsTVZZbiERY1d8w9boG1nr1XTYDldYwQsud1fo5bYI3dEdxveKGqpVZVBGLtaB1Vh0YpwDg1wFuTAshOv8rqmgGMaqgnEfQ8BMlsQkeApatdKCdIAUSJxLG3X2ogro6px1C9r6o3EJV6AxFe1dIs9AYiRDi9AbwUPLKjegPfinP0Q545SI/799lTyhgZQumzNB+N125Jp7LPltac4s2sOX3mP4ICwedjOUYtp+jAc0c4tSmcXIx1VcAPvMbx4lmqyrIL2Ck2BnDw0wV01MgJf+Hvo1qVdbsCx0IVsSFr7d0Czs8vDYvsZPE0hft/SUmxaDfBqt5htLslwVsEEGgCRc7ow+cxZjCYc1K5/1YNDmgfIribKBsFqA+rZ14R1KzMud4fXFxusHAg0e0NKdxQC5H77KXaYdX2y3r2d1JVHZZ5wr5PIVZb1HwuwHbcr4cFg/WFeqoltYFaUN1wX1dIWPmdyxWxruKu3FfTVZqDx0Z6hX7c4u37+FOv+963DT578dD0S2Wdv8nvZVtDbqvemF/gsuzVt0hLpDD7e+RSQg+QZg/g3ayElAC1dc3WudXCo/8EaJUAj7Efyr6ALwSvMQDwER4eOM/fU+nd3krvMKaAnwqsKbysd56/T6rWPqGE3dkXTZkRxHDSVG3dPyBeCdZOPTaJFGtDp3Wgyd1K8upkcquSnFWTqYQufl+YfcmcYg68Uf0KR6OckakpsaBqJ6dg8TfjChY4kLUu952CxbMnFSwuqiTvnUyuVZLDCStRroFv88obF9k/ojHOU0UAVwsymUwKxwKP1HdeSEFRM5k8l+mZ1tYB1WBYB2iEL9QPQx6qkRsKNXMhp4GgehxA/kkfBHdGQXgt1rvKrrzqYqSMhieG0jcDF7rhTixhgMXMmn9iEU2MrNa4qyrErWefU7vY2c/iOdz39xf8y1eecc4/XTwQG7JH3Pmn9dBwW3YTch7BaeakpdhAQWD8f7gZWkQVTyB1hW+lacK0J+JR0xvt76b99Kr9bNB43xrH7VvjMfQtsr45EmBDQtoh55ujjmx1YIEHLBjrJ/h1xYmv655ikyN9LZJeURcqwQH0aRJTD0Wes6tYWYjFcFih+nmYJ6jMdzdFriziC2uZg4FH1c0ExaIVH4Et38UPH6VVrA1yOoomSJn7Hr+B7oHOw59EV0LEoQUJqc81hBbUNI+IXR7iSl7GvYB2q11c/0nla/yhEs6Fibkm1Bbn7vGBIt7IPWPOpTPiQsynGGPv7uyMKCToZYNhzj9VPRjyuPgUt7zKLRR5FbODniYMyTuy7xc/eNXdX/gff8vnYN8h/37R6SGIXHOdTziXD8Dyw/fKmaOm7r3t6Pq+lYHH/38Lr9F8nUYEaH7V/rNWQp5Fos9yzf4RnHJO4IltKJCXQujpeLqrw2hbnAwncTIkSKHC2yZQ0QdcruyNNGhaxTlklkZHp2oO8X2qGqUsR1aqYC046H8oe7N14wrfls7vGczhbVhHZ3r0S8E0c0B3DDupKVSty2rmIkS/giOPqKJhpVz4pAymGRhDZcoOq9WzEFFiIFGvwfgwYw4ENw4yQvUZ7I1oYQKXRKHtn60DxlYeGC3a0NnAws43iCZdd00aljMW2iLeHMO0XH3EtBzHRmpaDmNNdTX6JgaJZYsmGudJRbTv4UzD00Ou+qS5uQjG5lBSWDE2F1ljcyhcWJo7VBEbl64bWNzkDoyrPSbfaY1v3oKoYoAuFAN0daurX6fQ6epjC6bN1U0OCBg1dAsU2ofbJAWkfnayL1Qc1tZV2SWyVsPUQ6gzPfcu9VZ7ve81HWpUDu3Nmf2X1YS90rUDRZT9i0RgRKzC7iqcomLUdaeeJ6rL3FC9+qba5oZYF4W8uBBl5ZY1I5BIdMplCyxTG4+dsWTiJyIh2Ru/JmOUfSNd+mu6Ew5EOU08AZVqvogcj3F4ef32JOWpbeVmreuiV1hxvldRIUcPIzz2oL8QmV8thxVAhwMUYreUPQjgYFBHtifKyyeyd7gXgvzsHh2oQNWc84YWC7nZuWJieUFz5CnH7BqJaal6G2L6XC12tmsmqc0VIr6YsaY/uL2papfPbOSdMfohsuOYMopGKEjHEBAHbtWv5h8AmFrG2EQ+h5t+ajx9DkM3z0NSObZUUZCL6HDr5uB6tXIx6ggOWgd5J7U1ZdQZ4vZ7RT+cZmm+Yhk4k2O7OSTP0YwMuUC6CYNmaNoCo/94Txe5MUulaAxWn2REohcXcbXvsvGyBLTouEpd8Mpe4eBILsjLh1bVEVdgS2CBD+wHedZ9Yb4sVeaRfqNsStExN3kz81F0deWLLnWkJShTe2a8nBdbML5dygCqZUBsGfFZrkbtGYwL+RxtyWcCQHxZID0ApIcY7PJlIIAE3OfsabCOwsh9TOjNKPn3dd2r8iIY08zpOFXcvXE8t28dQ8ut9WiLtEoP2zvSCHcyVT1ej1F1rDdtx+oRElssj9eyfMTWUsPboHpFeEq1d1B2ZDhZIfq6QFvEpuKszqKVfsSHKj1F+FWdSPMUgN5t5fasyFpRF9tIK7juHiHU63PJsDzKObZIEq3AuMy2/fl2hK7JiWAFAbd7c+pxKORQwfi5g/92Yu2Ychv9FL47fjmFhCdWl620A40rIhUFhEyICOGMw1dwP3ZKPySmOIVOgfmKU0ky29fTuH3buH3mkuQsJVqg2IS7WmRaGr6Cwxmnr1AC3CwiyRdL2uWST8N7Jd88ReYoASgGcz67OC4ZiztdqSWUFiCQkB3aHJ2Wn6LyFLlSfwqdXjV1xe+7+J1iJNrYObE0A6Kqham/ApAmOjU/hYDBVttwm71qQhiUggoAQzurXeEytb/aG35V6z3SxbzaoZNqPBrLw+aa/4hbntL2HLf+GG2eK/v9HvcllDGKXOPdyCHOdUKxYaQTvcoYhjKGcVnO5VyOGdlqObw+TJbzdTvGK8oA7MDucQfthFXjnbTFOrdewcA3GAZLB2T2zavteuqpuRZ0m8tbVdUa0XqtmBiATUTVpeQvdB6KOi/FVbsjHbnwBGNLalua5rhuwGYNC5tQHT1dtk1dwtsSlcYsF9DGNi2At1sYkT61Sj/YLdIjgZHktExOJ5IVdoYHoeSAYT6I+RGmsoiHe2XcxJ+TURSWZA3vvORLh6NRzaWI5jAUiaGda4Yx0GoqNaRSXM793wA7ULVbsAje8ArA38Y5ToHmerzK85q26PxF512aQZV5XBkStEysFHWqa3hm1u8qkXfrNwapJPk0Q/M4vV6sJC9a3kIvfyvbN4/mXiVtxoW4jTuyN8piv2IXdTAOOSnKM4rN26uBWyzFmQckeI5xEkIg+Av8txVyKVlfsF5gb7AFI9nDJkdu9o0vKorGq8Qi6J1YNBSO2wPQiR20oqi9jXbmM6Xe+zy+2FZOUAYADoLnebRndHRlXaSOu5Q+xg7MAV5AZQBsFgCrTjjqIa4n067YoXHSQJ0HtJLH0oxZNGOOojXpIp6zut2JaHZiIS7W8gXaihK3EtnZsaVE8i3T5gAgockhkq+aPgfOqsyBPIciPL4wiJpjKOYsvs5U8HUqos5MRdS5rwGizgFR58YQVWlJFVG1C6H0YwRRZxVRC4Ohsw5DwVQWJYbuoMJg6EqfkZL/yGIoeJ4FFL5wfAzVgd5Kq2v5dgXoFsPZbKGdNGsxdPvXDENXKhg6azB0BzB0J+J2apw2ULXjZ/M5acYOPcdA/6BmuMOi54rUhDJGalpFzCoRSiUqShpeYunCNCzNy+R8Inn6HrPWv0j2mHoF2ew09axIR2YnF4tPCtAGOWBn+KIo9XXC87Nf56EFRtNOUfGYdzNyG5ONGXFLMt/vYClbE9puwUIRgD66GYSZr6gKiYR62I7PY+GdryxxCpCdKt7Yic7urE5JFGS34O0Gzt71LxKtQm+agzKcqD5Pt2kKp3MhKK1rb3naNqq7bnjWz5t4vDBP1bB64ziHkk3251CxKWS+czGyva6Ka+WALZ8p3TLPbAjzU2QVgWQ+Ky2aGRXiwl/LqBC3qvsEsM/Beyf/VNrXpo4Icee0uryNLlUoCnWsELdzfCEuNn/sfNMJcdvU3lSI22EhbjulzO3WSuHtkGb1Qz0/GAwoG3dbfQRbt8omcfdeSHEne10D2c3KeL7g5Z0EPLIReMwBHlVfOpmFR3Z8eGSUnTw8MobHXEWG3CHL1iRHh2hUe0KkDPilFECJGSzi5iiop3AjKBbjIIhRPKucBSAwgkzMxlVA+ogB1/43A1y7AjhPK6GsehrQPjIVgrahajx3UDCuAI+InzRnTwO8ydMAjzKcQ4yfBjA4AJcreyMNmjp0LZ5i0Joc8qgfhxS4M7U2RZUjtYz8yiEp5m8VczLq2Ma3JxufUZsb3970eG0zVKuhbwOmk0LwSjVpo9fdqNojE+e8SIgGVLfxGcc3XR8oGsKGGxd4NbilUpfrov0qhocphBrofqXfchNLRfG40aR0+sUFE8h2qc8y5O5x2gzFB/a7+HM0vu0ss1VRt7w7w+0Z4E3/aRV7Lu3hPHCeQqd9oWzAaJsRaL1YtoVVb433hl5UORD39Qs9hqkOtfXQX0T2OK1K7mM9yJg4s/MexZldOHlmF1ZmaWhnaXj8WcqNPfkzu1DO7CiaSu5j8kfIfTRJ7kP1ubkJufcrx9KayZH7E8MjqsJDz52iCjwiC4/o+PCIKDp5eES4BDDiwzaokvupJ4h+qidrFTWFX754+IIRtZB/3UwtBCknVAtBppNXC/nXk1QLudn3GpOKNToPksJanePpoN6dREJvD9KM6akYORLChXCcq8GKIv+V52pB9Vyt7s7VEgrRvbi8RO0qi7iy/abcvKH3YtTiUqj8uQ8ne6LM5suBZKHHjtaJa0NMsFKEDPII5YE0c1yGlltF0ikHZM8Xgxyb2/xzhrdwSG3OA0M9D4wElSN3Vlo5C3Q2/w576r/XN75cAvGzqS+5qDqggbWqC0bVQ6qIuj3jBVXyKuaQ5/wIquK2y1+xPBfiMXLfJki/SbpmbB6pbqecB1rREdSspEIXsToWkX4kCMDMB1NoahFM0zRC00P01DtQeMzeP3JKir1iDMoRT6UcsaOk/yaUY7r2Q/QotB9gydGifXxc7YdomvZDjOlwctoPVdr1gvSvm3FDLfReO2ajN6p6cbp/zCfTp51PJk2SyXMfgmaPG/clj/W/xZJn9bVkj03VLkW7zJDXtaYHx2r6vKvpQVfTl6QmTBLuN27FYdO7S5ulZ61J3pT74ThgxR65RXU8KtuRGQqgU2CEN8npAZ0fEEJGEzPTsN6rAUe+yz/sF5mKEDJK10xaAo8HooDfR2OxBX1Y6PEszUCcxoMyU5oAJ7Fl3qA2jrU7mJGd8aOwGXTLM81u9/UUN8ibVahpZyvwpUzFLs1UaXkLY9ChaIo+85xY1Y4ITzLPzDxleHBz6rmoo7o3nsUFmCRPADRcKMtTMIAKOra0wT2DRB2dbuAxDwnUVaKFlYBkJ+ot2dl6TyWWOrgmBeEP15Ciako5Bo/9cGxLqVrJRY22WP67qpfPlioCAGKDSxE5IyqM4GrdtQ3gnqW6fH5lUYeH9XlEaBnVtqHl+QIACAdTAB89RmA1/w2B1fx3ANYixTA3TAK0BcoIzHj2q7Cik31FJ4Hj4Rdp9kixQAtlDB+1z66XGyua3fdf/uHBj2x/8U943OR5ABdz7n6/FBs6Q0aQZgqU3baM++rO8EXcSfODMobmj6wL0CAVo9nRDUdQq139dOb1xNvX3f4LlBAnqo7UNPiA9i/QbN/LvoqOcd3Iw69iPkd2/1j+1YeB9RkP0V+5/Tgz7olB9Pq1dfadZ0lt6G4IhdO2Merd34OPaGaorriGR4B4DJlrXFOKSg0Qiqbo4hTptCIELVpGhiidY2qElpk78mneMWRmxkgVD0CeOKeSRhb65ei4f6lqWfDfstjS6aIc50pnjpbgt0ZORBYF/lvWWMjs5yHy8l+PK+jmqxTylz6tSqu20gr1+gkExlJavp1rI0imZaXfRqvwT1KEer8yPBxyJF6IXw7qix6KPxDoi5yW3xvQVq0Ajh/y3GjybwcTukqrcjSZc333Bs75zbjjBEXzvqcC4GukF0TtnAsRiTOY6h514eYgpFm57Sm41eWg9n0r3vbn2/jD7dxxkh7Bm9T2tUfZKZ9oolOA2iPvFxHaT7Qd6LrdHJ5Th5ZlVLZXAOYqkOJXgTcI6WHxeLFLKHaJFhRiiXidW1CIdRhP1C8PP2Yow3eZbuul8hbMqBRWD39bdVsJ3paKHbRjuC6HYlsdqT1FL0R3+agib4vcGIhK2gEurN3GKTSuHh4pTqVTh/lp7tsd1BU8a8laW2xfo510Gu1A7uxIsYt2MU04fVSLhUskUS/gzKdyhpJk0el0evlyZW8dn5sv6ejQiQCtaSXZQuxw0dyYVRDnVYHFKZWEU8wxmdNwaFJd2it+eUM5pNESV7kr21FwC8R5h+wRdlT0FLUG7Au1oAb0G+XzQr9LEJGjoOIkStAjp65l6M6Cfjewv8H8i9IGwhwBPkrQl0j1goJIBNVpkaYvUNp/4VpxBnXRPT4zPBPbrWeBj7vsJflZamH+bE7tHsi30CyM7IdwtXOOGBvIn4BFllNfxYcTQIJMhjZBWbt1tmX5E3U65U+imAoy0bUix8zz7cwrnoy5x12YoqhzLmYiJxECxxDAt0cRwFd3ua/cPy1/YDMf9kBCGWZngRY/kZ4IdZ2n0JPoSQicR2fzsnomT5RzmAI/IZ9XeisAcxYCUpw2KsvHh9FCnFYtMVjFjFaXN7nM/O2I1SCTKh1GwjDeq5O2w6RqjgnwjIg9MwgZMH9om5ap5ASFnlcSAzLEhVa1HtqOCOfaB3Xii6cQccBmnsy2ivbgzhFhLLU9UvdW1x+tWtvxta6btgKheK7hsY3aQKZ2H+IPmTBt466EFv/dQLNNa81JKoR+gSHWW0sinef8MeFVytRKKa+uAmQ6S+gs4UG0DWSGFdfUF5n6WJK5yWCI4P8pJ9tjfKX9BZRWqK3IqCvTk2XRfJJdodAS4z8qp21uXaInS5PHe42VYzvQmZ6Y55CR0XY0VU3jaePAhZRtW8IM4KBvmucZ/2cgh/wceMpTbAXo+CMF0JNp1fhGtdOCP5b3c+lcNAXNQ6sUdNvNyrqi2nxjC+tWNLnNdT3gaRuOmTbcpW3ArUzpEmcETsk6iVFdski3CHZhkTp4dGgOjznlIebJw5rMRrBEJCfXapkalkqxywwW8bVBy/kqeNIJcgJATadIyngI6TMBZThyZTYqJKaNEVV8Czm4XZaFNq2adCa+JbXJAEsFG8BCzP+tCgMESwskKjkc6OYrltLQSr7EZYXFCopSbkmrWlVskypJqjyPVi3ysH4B8mu9FI5hUUhPkawZsmpyViZnytABIwge+7hp3BOudasgGi2NNyQ0DVk9TkP6L3w82rIKMLm2rID8hI78QDJ6kvBpm2Yljz+ItHbS2u3EcnO9SoS2ngQR2qa8IqaGn2/lmkj6qa4nx+rSOZ/zJ/mKGIYJN6U62ypUh05AdUBmxiiPUp0VxAF/V2ih0r4usv9fRYiUfRdSk4f88HkU4RCPPKtduUoeo+GmtMRRDgTSkjYURLMjBIJMvsySqnNBqpRmzeTblSwQ84CygWP8hYcdaIxyFfl5EqA8x5Orys+XQMZwnBGyxFCjXJRbLebvofN0oIvzJF4iL6BcI7mkp/B/T0bSHjrf5DwfrxdwrLxy4WAzsRJhPm5X7pdizi7dVc4v46ft33kCEEBtu8oSnqLNRLHEDUgK2wGtwZZzrnZPZ6R22Wbg4OiGz80ynRwnnmmp1I1PRqma4q/uvLHp4/EIHVuyOkY3lDAAsX1FJuLp8iRqcjn1PFQCoQWSmQ1bjzMb3Ex44thMcMhO4xtZjtsqOZ/MkNc58kQ7R7bpHNDmkZkLW48zF3QepBTJbkC9LOvOVl8O4yWDZjZEcI1LjY+whhpvC17WD16S9yilrlkJcx+F6jZEhCYrlpUiWCrClLA7+qN+Za9/zL4QsMG+7MbI+49yBY8YGjGELM6HpOCJQAcBBTfl00UE/jQ5A+VTcs7KokVQXpUlPaWw2D4uqXBoqhhnG2BLno5yk5WlRG7BnWjfZOGo9ORL356TTnN7fGoPJFPM28e5L49hRmsBDI0qEHTCuRHerFG2+ONCYqt6GffFEIW+DPBC5uUwXjLzchAvapWNZ9826j0rDzEXsT0IzTG2sRBUrOJxSQFbPZNonefgYpkUQLihy/EU3H9ynnNvc93M85Ke4lmACDAl+GdQBKXtamrQnr6syrJG22VJq4iB1Iuo7ugMlHdg/lU1/3dU+INyVwIwG7OR/El6keddW1pfCim4Q7zwDYYUQaR0xR1DcazgFZzoDmqH2fUiQH43rh97rwRsPu/rMXNjjeqQvXAU0wB+i83b/XgrGpVzy3U9SahT3QnJewW+VvyVz+7z8Tvg0g+INUcfZobX5O5m7ZvwCdXVbNx7YZxYYr67t8e3R9s4Iubczr59mv5r4AfOmcVdzjai1dL8tPVlAbhkr0ZP254YfISjXevvQu4c104PDvk4guMgD+eDSnf15X68qKICDuEivSgeqQVodw6HJnZZU+B2DAGk9zA+dIt5qSH/Ab0qezPHoQmEvt3sr8HBBRqtxoLu9LMb0FJnhP5GfgXdL5uLduAZZv8CGby2RyT4OEEgH+ZNuNh/RWKhZfwaqsCHn/DUP15NTXCJsTN++SGkuypfgyqR5nyCuPq0BSFP1qT0D2IUUf661DekvThXjnWodeQPbAyHuGFzW+vAhui36ghd47yNTI6Vvr7WnHLwIBuEh+WnaykQLdoixuOKYVEHsnPwecMBPkPwag6G0lxjEJLiispavXRhMqyop5XhwUVsiXTVtul1aIQJH0K477EjteC6CWcqznPJ6/UTcdygGizqByEP9B57WPGPgjkLv7b48ACcFD8nPdYIxeeOM278gFe5Qw07MZ/39OT63mF5cn30DgSNN52+2Iw6PJCoTSyFDjRVTYNWwkc1jIPwm8tgcI8GR3zpHKt8dX8l/KCGYRDtdhvk1hwpg/e62EMSe4umqeMdOXnXrqXazQdcN6Vd9+FdsmmSFvX5yheH10e+CA6tbwIKNNeVJp+5OX2/Z+c0w/w+88JjWc7pezUOxNGbODAs2ELXn3lqsRXmOwGP38Vzw1MicK+nRKBCie7yqqRo4FVp0WHv+MToFtgclM5ubh725cYE7AvN83nG1tavXpw7q7Vq45ZrGO1ZXi8Nc+UxgFQXm/oUq++eos4KQJcjet+b/vYXB//864Onf++FtWdTsPkywP4ckQxLYjDp/rsex1wkwT9DcI8EjyF4LoI4BoIVMQQ/j9hdEtxAcKcE70WQEFSzZKsSvAefdZVM5rHWmLlPF1yNLVdj4j4FnxswQoj9guwNmN15ovZqURyTm7yOx8vzRnUpZVKfuKWU32B9oHEEV4UoVh+qADCSCt+tq/V18o2r1eq6Guu6GpzNOKV0uUpjDUYwjwNvhqqZc4Zfe9/wvVhLfSyifsWjmSLSg77KdvCFEDgFm5IS7Ty6teGh4M972RvRc2O0WL83G3Wkf1ehC4mx8Qhr+OVFjE8mhqIFJ6Roh3+qnLgPrE9QtKNvPx5FO6aphPC9lfADGgbl+KgGZZb8xCRFOyhx+tUtlfCdGsYM/hhKQJBbI7FK3FxwQ4J3a0SVoqFrlj4NXDeV0uJdsmmSFnV75Yujo18EG/I+naLd6UrDZ/+xKJqwgcDsigqfo3Iw3jlO12JH1+oAVax0ra50DVTtBEQMc0ih8ez/8+jZTULPYjKGNJ8HPS9FIPhgRkBIXFFXilckpMTuCDh/Stg+f2zow5tQUoW0jJIVzOepZOUHj09W1N3vYyQrh362nD33/9QEWdm483hk5W5NVavqlfD9COv0fX8ZDA7+9CRZebDy1WFNl/BAw0Ccj97pCIjEKnfkgndJ8KhGVMkKumaJxC0IV8jKTXjXbJokRd1c+WJj9IvgLnmfTlYGrjR89g2y8g2ysjlZ+aEpZEUQCIF3IHCyZOXw8ckK5vM0svLDj5as3BKzgCEq/VWOk5RrzVS7o5w4B2/jYPZm1Lei00MS3fR4eWV2vHRyclw9MjcKf2x2hBfW/qdD/OdV8f6SKtrvOT7W7+X2wGKteIU8/GqB2R6eV2i2TofdimxPQKGASG1NvXNawVH1+k9vaNC4iJ0bTpgiRqHmczdpYyMo+CPkIfXRtMfdYilia77oInJBaKd2FQ33CpY9gWH17RL6e+Db5cYPFIyuIvQQIi+RYMahfQihFTpZ0HdMllH8TsrsLVdwWBZco1g7FGQ3Cz7X+/z5YYx3HiN4UIIJgock2EDXdudNsxHwq+I0vDXFACa2AI0re7oXaG6+F4g33wsAi68qfGPIK8So3oIW4O2F+LlKlDFjFbJtSmZQzLXZj5opFvC3E3y8u1D9E9GoGet7ndOlyvwEBfKcY99ARBH+ppR24Fv/JDZwlAPCFBvqd7s8uZBAn/dqenAPniMCCVvC/TbwoPn0ED69JXDOfSX2/Z5W9B481VswPsMK4Sbc4ZGV5uDISnP18afcyy0JgExwtyUCsRBnJQKxEgEl0mpNgp+73MyJQLOdYJEm5Yqr2vZMYdXSniXjjqFQKJmh0WkhdutMpYDSeyThFvxmPzZGctXsmtpe1q/LknYJ1b2CfCW4xsbaBME9SyEUGbTSyFu8Em682fGqVgs0w3uqGTZGMmgDrL9j9KN0pnS37+O+/7hBSL0J9ym1J5nd8jp+QhyM5ovT2m4RDSlcL+LyniG/vRXL0aCoX2kt669nt+JOy+3Z7XgMi4Qj4yEl61SvWHsdQEJS41l79jetfu4vzlthFzflDEa08+DovnkoYAXr83zAPVLvKWhNSKbucLLuWK5hUjxed4i6Q1v3xdx8V3d987r7vhI/d331t/1YzReq7QR/r/MEkd0KABYB8S0rD/QmK0KQqgi3VfWWHav072L48IP2PfTTX/j953zP5UzrG0iUrE0kdeEKCDQQ8n8QRSS3sLSU60NplRlJCV9G6Q25mKuMURaQUwyazU0ueGVv06UFNBSHYdBRRzN2c/W2yBCTrY7WrGe3AdJvfYjJMnvrJ/67pFe0ML9aVP8WXOSOKcL4tHC0lmVvghlIYJk6ryY/+0HEiIvQzwV+5GS6x/i+U+KsQH6J84Iel4YbQzh2wVtKiWEjdpr7AWgAaZgrdoRA/HzCYU916meUwJATf9LSkFAHEKYEczekBGSgQfwZ5Ndx9ps3Grv0Vfmfmtb8pq9+9bqvquuMh+xq0iT/AK5gjKwq2W1AjhU06F54exmxE9BWp21yC8DhJVxZ4CfDvTTYp+0M8czuKDKeX0jp3lHEsDA4EIMYxNEDSnnkyjOumGMqdnSOUHudq4uJ/xgTsrfKjJeziYOBsukUS73uQoYUiJ89fBncrNrS9XVzrAW8rimaqLOQCkVKeFBPZub80zdmziOaOf9nnlPeHEWRXnN85b/5pE/KSR+Wk742OeHtbM9bOqXzUPuezygw8g4lylskUwUCNVJK0kKb6tk/A68tQeCeJOhJYG5fJuLPR9GkQ80DNKMQ9ie2zRSIXoEv1EZnKMCeUSYxALu7YKyS7TrAXherfYAGbmmZEPyx4MX4f3Gz9QS0aY5gI7YFotSqEKV5S5QWQJRahijNgyjh7hctGKL0wk2I0tw4UXpwhCg1DVFqTRClq6VUR5QEXI4utUo/Ei3jR+JR0KUfPPSI6NI36NIPevBk9HhTJfKhMAbI3Cj7EaqfaA+X6AYu/cMwVJLzdU9wQkNwWo+O4IRKcP4UvaZUwJUCXEJyhNRUeZfA8S64ONopeRb/gMKvrvBTkpEpsaoVntjwM96hTppwzHIDs0luZs4SjvkqNzMHwiEO8OdPQDhmxwnHn722Sjh8x82cgHAEj4ab+QdG9Fdw6i63rRdJMk31XqVaNDXCExk9SMD09ZBnAreYAPbcIqq+lkQOfqOnJT9onndrMhxljsrUN0yGB2xBx0wAgwOfqdJUT5r6jOv5q4zlA1in7wmQcpOmaKMiE3gwNIH7OZB+wffCSa8CRhXkba+d5uYuFFiOeNMLnTe9cNKbnkuXVDAOj6ACcB+dNXgLRGZ1LBcRj6C+ihslGEe3h7y+EkJMDUjWWQwqv/d5+H3e2n7jNDGseMzz4TGvK15hrMc8RZsYj9JjXjzhMS/iZv6BesxTn4bIjp0pt2jEY151v/kVX8x7NK4dWZfe8trRdalVWZdKIVxRL4VwWKFUhlxZpOqyguG7RinDswtU0cC1RH6msh5tvlSFZqmqm3WlXrH4ge14HXNTFyKd/a28jUBSNMSYQkLmSyw2WOQSt8i5IBeRoMFpuboNpaVoYRsyVhjA4hxJmU5JZSGEzcHELmPoIB5tal05bUELKawsaF/2fPCrBunJrR0JRnhVJd933jF6yHQ73lXurUkyL9+OYNpHImp7B+qAkFIi8ob1lNdQ+ypAF/Itfx1R87/1VHEh0Suc4Rr4QnB5gTEO2ZCzCuCUr6pWcnted7lYcHBggVBXsJHLEHGoB7CzJZzsFiX4zl/DH0axHiaqfZnK+tk8jqO+lIkFfPLh2aUmYzKETOKwMTtmnKQ1d/mwvawhRgmZKrqGNitrKL6nlqyhCxrC+Ytclq9h5vYxiKhBrDFkfyDb9A6Mk9Xlsz7Zy/knLpXLOcLpABfwCq1rclyo7vvI13pifiTsB0JqyoB4YJICqovk0qy+iYE9FNv4O0Ai3Gueu82TzDMbM3bXF1eccc57KDFaUYf5VoS0/jqoWcAPzFp1ml/MMhBm1W5FXfxoWtVhdd0c0IzEki92K5oC5hR10QzH4LFf7K7OYMHUSm2x/MdGINool1Mq2jLcepl2aFQeSVtdCwNx9B9IIVcWAWzMziJCS6q2sCY9wJkGSGVLuA1Y68v+NwBZdTVNcJYMU353CGcxkJ3G1dSShfwCQTgPPAJSEXuFI0JIZ7BX1u6DoQ9eH6dUznYLnqGyeUBFFHePp4UitmUNUGTvQ9ucxQvfEdnAkV7RPL5STIFZD1QljVU3WgGFSK9Y3giqljcCXd+6TF5FtwnUYdSyBhfhuCEuc12NCvlTrWp0Uj0xmpoIg1picsP4mVGTQF4JkVb2fmGttDOwDav5QN+mQyJ0kIgokp4yPBwEwiMKoRNAoAoDLLOB2pR6LIDIA1D1l3hexRlP6Cx/qOtFZo3IezEu0pMHh86wzdVFe0EduOFKTBFSYgrsW+PJwR+BLoGa/pGQgtBR07f7nj/NnSLVrL9QD9/Ba47G3jg19sHatNjPT429d2rsJ6bG3j019qJpkbtd5G2OJdupm21xurmrutk2g1hJXq0mO2NwnJpeyECy1stGPEFmP46qNEFT1TCMt984g0zP9rzRT2v6qeHHPOSuPcrcz9NmWWe8ygZCVBOIDkTp1RzCFzVxV5Wr+OR9cx6YL0iXa3Xim97goeTSFXKgHCt4Sik5QDP87IjVg1c+FJiYDRUe5rvSmXEgr+gENyjA3Kg6M8YLVxKOOjO+iGHB2wPj1JePN7+kLkH1KFCPP7gVbxci4KOSzVwXr7/2kbsu/n9QuzNahw5hdZCP8YLGqjM3j3++R18yvGTmpYuXrrycXSNsIuhZQgP+z3OL/KUkgCW4Kcr0gJ1aR0OotI6mYZEE9IVCQ8DgZT8jY4Xt651iPhITHNs7Hxtaneo+uphg+wfHavz8GD/rSOcn4t/Dz4YiOM5BgjXAp6lzr4mONAVNMbZY4FK75BpHQ9iECc3wqUy6eCwJ2I7SFB+hJcPol+CNoHMnGPQOT+rP/sJdKRhJy35WiZAMVWGiMcRANg4aArS3aOGxr2hrq6WMYgbeH/WTIqIZfAarLa4reUocL9eg+Jl74qw/gqshSCaluQxvPTFNhdvxwKzD/ws1KegpvwQYaSkAeUM79A6ZwS2AoEVt2+l9eVuam7fQ8BY9kuZe/DVpbrJZc1MjMFHInvV1ANn68SB7Vt6W5n79QDbeFLJUg0pBX+hq9jbMFbTtKr0980JugQ8RUIILTvB+Sh6KZGZDC1SnBb6q85Tqeddp4juNFlg26h7aUX3nHnpKLNYJXRRnauoG+k7R8kp/cyp/ozC9z6us/vd7o8u/UCDHUvyKSmpAj6bGHp0a+56psXdOYaEA2Gmx902Nvac2tWVTY49OLeHcaVl3TeSsDgcg5eA8jOKAt+GxnFB4105dGLBuYnXMfk4WYOgcIjJEZKaReah6MJdPVTuKxOl5QHjupgBLTU0167C8JOLwXcNdKPmIMpga4RZPbUZuKqaw6ogxy2siMQ3c8riUpTAwt6wuIprGFVJTzSQKCcGj/fw8xdT8nrZnDOdao4nNfIaa8om67dK7Iweyn1fq7yqVjYLYSueWMAerRtIp7Xvfl6dWhmbaXRjRXVPXiyaaix239aYpHQSzljz3JSL6nhHrCxQD4DNUM4cN+M3uMlcF1ZCwlH/R1InuC7sibXXuvFrUGkpbqGk2923emHXu4M2rXTDscgr4OJNn2BZXTZ6hpE1MnoE+uoIwCAnAqV493TjKmM2oOTg17O6AizRNqRCQIP2QF1q/IsrMki8MFyrwAvPuiVVmiHfFZrMu/rGQSUgvv0ev8l7NX6hnVV+vrPqO2ZRdrCf3o7UCKakuPEqdVAT6fERThN5q9RRB2TgUvtpYhHSlIgsX/Lh77tXjHnA0Vc+9v/Ta43vu/VjgZ6ympUTzmKfSg495wrEiuIG1qSZKYPF+Mfzd96iOHWrOY8tYmDfQBiQJBsvZnxo+0GVOy6M2Zy1mwM8Z9BOvz56oWcUqHA+cPUr3KbQCx79SSTmDtmVYROOKpa2ecTNq4zGLM+41mZ0AhnDasu7OET9Z0FJtTT5PEn10tLp8AdETrSgWNfpjo4UUS9m7hO4t0wLZMIdo0YSXaL4ML1IoQv9ZfMx5+JsjA1o8ImJrHUTqUAN2oRJjXFQRqYXIFqXIYs1jGXY2fX0QwaJzjEkx7dSkYukcby3w7b+gpBpoXjG9KLMlj5VCk3/kVrU1HuhErvoHGHXw5eRagWGfAxcnJyWWeVZyHSu61wXd1DtyzJPH+U6ulUS96nY4de1siQ2iWOZjIkwUmms8HTXUOoKYzi/UCAdkk5A9ApuiK4uZXs7J1BauqU0zLDZSIy9aZ5xCbApqq8crLddxDAKgn5JnNhPVFfWTnhdObqmcM+xEexZg5kAo6qkvebgB8K0gTBJlUcrerdtcxFYdTfP3eWR3dhG2e2o6XymHbOD85HzNL3s1YyAfG7GW7isTebhdppe9R9kr8qs2838Rkf9WVOu9J6BaNzNwq9bnsTUeFoE4sR/ckYco2Q0UBIKIHvXBc6WCLFgHNNaPUG1daP2oseFaRdse+QbDdRcT4HOOOTLUrf9zIJfY1JvAhvRJD0sQD4IoiT7kGPCwRoCj2ZfX0hegtKl3gHyDRmqSEEArJ/MvC5pAkIDIUGoRxg8vPl4gWExKqUj6VKnFCKEV75iYX3vNfs5lhVVopSa1nPCLv+2wbPB65tWzr+rZ1U/7Xv3kvEyIZ3bnZSKseJnwKn4mvHE/E3LDQP1MoD9uYkSoIaBY0QnjYs5RItTqqo5lxoR2xoQUmxmDZBAMH1+01OeEFFoX1NPZ41OopccAaaSzRx4hHpJmZo8SvbpMqMlpdPKg+gao+io2NfSROUGToFifOKyvcG14WNxP0qI2+v31r9bvkUHlZ49QNvuvcy3P7I0iiM74L5Sws4gyXzm2Vb32xgXB4XkCENxxNQ6KDs3DfdNQj6YhmAc3n31CjKinSHKukciDsMBY0yha2R8iE8XChF7F7UX2KPskYvNWCp2TO5vizjU0bixP3zuk5jrX6emNiDZ5uGwyg8dVRWd/kYERn3WnmIJrN0V87YOLkZuVnpw/NtahMcOtfzkkDtz8dXXa14X9dqj3PKtYAADB4uQzNJ93aBauNqkDkYbxXQIT+moYOhFfreAiFt3N+FWap2wNrZpRW8Vwfs/fcECoZaLCTpwvHwLVzCR4EMEWgnpwEXKwpqvcHCXZB0aO+fIlc3ckKma0p1xdv/Uimn2uAacFckRzFQXCqtP4uVK/gVzwqt46NpmHvIGt62l8ELSkdeWmLjg3rxmhCi2pNlBHBUEJNfD9QQ+7MYF5E+OcOQ/zHH+19n2ee3lAgocRfKEDw1USfMCCIVGJQ63PLzobsg8K8zejqgWJKyR0RVezf0iyd3B4E4DxgVgB6KptRQsT6uCFkbqeHUVuRRtM1ftDtmbKg11na2nXFF0ejHdeP5LhS5xhC7mEruiPhaIzF5YOcrriJnaXj2Yvq7uGrkGtDiOWW/ZHfeLMCNqNxiniWTR0+EeebBT8fAaEQwR0Hd39ST/xe3h+fd8ts1rTMI+I04Vf5Kf4nkapzHIuCssJ/5ocExuWM4ZjENQHlnOR4l7RQa0KiIwft3/u+qN3v+7Lb30VUKMEz8EIdtNntKLCJwx69mGBsaLuokHlFT1t6PIM33DmdMQm1TDvUSKSilVKIFDZKtoZYo7Pk13RIpM6sCaxbKzqiH2PxIaInUesOu3ngBAO7JkkutjOTWIT3ZADYWsUS+Q8xxS0VgA37LHrV3jjrUIRrv2W+TWyEJ+h7Xajx0TDBBXctExbso9Ib2M4bblzHrCKxVPLLfOi5JYJUqRA5tODDMkcMib3akqWbAtPvkGdx6FB22yDENIGBdqgum1Q55GBqe5a1Xm0rdpqW4XQSKvmK2CaOZkGxQ428eYNmnENmqk0KIVrdm0JQpWzpU7Vh2hS9drccsHIBRsw/F6a7a+4RWVFqV4haim6Tx9i89bg9wzvg7xBES3diq3sHAW6Pg3goxhTQ2YyL0P90Er1u7RoNv00J8tprRwXN4f4A9XxVWigBzpbdDIV8VhyQKkCrAjJAxSzXwXQ7hhmHzWyg5TkTuyQsPIO7uD9jkmagyDzniBXI2RBnlNNaT11s19DjqrLR+pRDl2WW2mJ5io0EklztHTExaA656xxyP8VERgMKOsNBtxxSIZErQ6xuD+bME1rMQ01HoJ1cYMqL3iBtqCdGyy9ywhYFyhUii0iqPgYsjwLejyrlJEZKrv3+6koMszXK7xSQyyq3C8s2zwRqGUfVMVnNZyWR3rzsojdPVns3p43VV5dN1e98dyjF2rv8sz7URs4ZgP3ulutciX0/fLkT3x9HjTXZx/0xq7PPmAy3umbkg7ZwC34dKOiUhtYldpDIa7hh06l1rQqMoG7bGCAQFjxBhrx3Ur7fnAvueCVPbeQPoRtvfY4MQVleL2wtkt94JEI56t32hN7p10vbrM3ZfL0EB2oiiBA5fe97H0m2yBay41U6Fyz4yxvP58ZXKK2nvbkER57c70d/tEI/L1W91YtByCqxN5exr7DxeoBCART4zH9g+FadqvuSmJzrVXbdLnsCPSbbx9R0Q4Y+9ZKVj8ko310JD0WBrNA1ElBXCltDY20NXLS1thIW+uy80v6HiUibW2IzD9vogYkOUkrtBPHpK0zWKs706StMdVV2hpSS1zhR2PS1nC6tBXKeWuamM+p42uC/yuw83jM0SxlVWlrAqEsApJFiZm9omJ0qCLFpznVfpgBks32b4qM7Ypf1y/ELZHuSOeEyM4TP4+ONhTepYaEFJDfznjKgH9n8bIIX06gVHpqIvyJFMqS2Ynej0qKkAOg7WyaYxYrwxySijmUnQGCc/xjXb+EOInI4O0mo4a5o62Eso3INrWQpWXdrKfjUsX0d6ybURGoKm3Hi7j0m3Q5ilzBRK7N3Y9O/eCkXJHiw3Dsw5NwS/pXU5X7tTIpFDq2v4FSoWxudbO/UBq6TPba2tb1gtoA71DprEAjROc4BDlpgKLDIhwtHFrNJyo+HiveIxiUjADEiEJTi99C/8I8FDUFACy2AAsoVpAV8VjlEcTTJ25ANNqAIoJ+I9gtDqCiUeiOC6OX0sicC3jyDPB0pGn3/qJhMxO32YoMHTPw1ocCALOp+jtdsaFxoEj7xHFWVtDfuUbu5SKoFsTZl8y2LcYUwUFBrgrQsNW9kYclt5a9GdWDkkEKT80NpweBK/jZEdwYu8CZGm6CO+AfnSQieuhY+VkmdcE72qzWNdfHCU8nXwj22qbM46699xJuAi1wk+bQHpwlQM8YEzfErDXnlbbOFupsSYVMUOC3aB5AmScczTixRUcd8hVytlu0VXjBD222SG/yUGoKq3Wg8LYdxkZVfXwXNSjFpbAGdXDfBysnCGgD6heRaqHni/w6VH3yBYiN5JgRhEalH5o54UdmtMlXRLFSfDnhZzcEHwUPq3C73LjOZb3sN5225W5OaR1gnwGQEC6pxpyURjFQIVP/sLmn/vuEYmaCDKC1OhoLgvp5CyM/gyFx3OByMMGuwXlfj2YgWVo28qvGXviObsF3VNWjpwJTeZsK1swYrBlWoBxWzm9CA3Ow9S1aAOldriQv29GNMbquO9zw2b7iVzG3P58XYFAsyC3387SfepCZcZ0LFrdA53nwq4NO8yOIBa/3WB4WkMw4hgbMagNS1RZsqmCyKdcFHBvCIC0i6z9bh2DMv25I8Zh/XQcLI7IIh/lMFUJFaPzrzpiSw3H/usFJetYNnWfdkMLjetYNnSPb0p2u0d7ezJtuKN0NmNJWZavGme6MOtMtlml5UHGoOyMOdWfGHepy/2kG/FseGoe2TT3QalNDdjOqJg0qcUCwX2VVmqfp8hxGHjXnMZJNhTnlxKmb5a0raJGpVrSlmqo5jZ6tlRHYrmyRhmmUBG3FieplFyu4SILmJah3Wq4HOVePmpUsJWxpCqDVbRkKKVYZ/8wMWGUrO/vzOfHXUbBYmpVdqAfEZ+eOeCR64w1YfA1XvpUDOjsS8sXFxzWFYD8yF4z4PBcwBzNKJTSvvicz1Ykx/kEE/ecZWuKpP59peVUPug6hQ8rAiM6ISt0RDGZbqe0CLy08yjMDigbOXjaFtw5pQXk10OpMZ2WG9szjMU9NGJFvqsdHSkg0VufwmCMfij4+pXhL7aRdrawJiTC8+264+zdftPu/36fru6Ey26hOy8N8e4m5d1001LC2rOBJSUpsRBcpp9DJ9PKCmpBR7OAMr3yWuKF51aUVL4lwwwhtGCVRUJmHbEH9s2RkbIRfkv2WMm5gZhJeEwufIVRpYoBcN3o6/txJJXKreL8in8Xj2/M5KSlv6lCpQwj+3YGO8+pLO0RkH4sdgDn0oy2sMRzYKWXsJyC1oRBImhmW41AsYFymmT9r9STzkEFk7t+jsrYu383qNyjNKR/NgxxTC6PUUocHoi2yjBqX3Q2gPBrBLVXR8nXLNSrFmKUm/C2VLbOp3KseJETcMbRTEAnYSK2NdWkzdoq3UWiUOCCkgghqRhCbG+gD+0yjO6qliXYyxZWvQamQX8l6SpnmzASslIsKDr8amBYzVxatXp6heOJA6PiOl+samMqnejhxAF4W4c0HuKE7aCdEGhI7DsUYDfPQkoVWKZVvKg1A7aEbi1thEWlzdqpWxWowtuZaPoWlXbbDXtE0V6yJK+cWYDc3c4cQgsHQoAH3OFHmCwS2ALQGQxGbOWHW0QEIwHBE1DWUVg44ZxdGnwaqNc48gIexUY0N1UJr9HeXtk99VoaYVOjovuiy8rIwyTt2HOJTqQdTWrof8FXkiZAVeVKAyRyM2IjGh0xyjH4F3vZDVBxBy+2ExbxQizHH/R0E9MIDpLsmJvtt5fE48mc/+TOfrMkBs+uQND/QfY5H/Mfnyz/D+VALP864tJd9DAWUDXz0rcs+rge7n40aotZndilxdady0N9f1BX89uzMJ3+YJ0J0IrShgUetgEqUm6dVhSG5CO0GH0u71cMkTy9fbOQdveaSsUuYfBbhG718Tk7NxTPnQqU8qGc9K190MfANVodvxdgIWOo4j6MIZ2Xz/BBqANFHU18GMNYx5F+nYumCfJc4hYxZrA6kLPaFu17+u7L3kF80cALKlxu1dEbOXzqCsgYjvmvt1d1IrqY7FzSR8TMeo4X4fo4yaTeHuZ9C5rUGmEvM8Kq7Fy0z0TJDlElKnEQXaREIjrmjVaB4rYgiLg4WN1yTAQkBqjggxuumDaZlHhfsBTAvxuAql0FoCSesLUrL2lSO3xorB1yzrAPynAevjVVG1E/1IDbhw4A8xUtL1d5Smb5J9TKjqM/yD0hLsURcMUvF7+AYFcpTy4nORSV6OIBlTrS49KPxJc/HLWcVv1nNS/JHDwZUA8MI57zRtCIalUCFI6/61T0TJcJqwG3weKWXJDXb0cnCGf63FRHxA4J5CuUJW3dMNVzFlSBjKrj9SjM0qIn67SD9L8Zcy2GlmiB1NfKqVvBgKpZ8ppU1mHEsfCAM/yQujyh6UW2j4OegwMsRLvnOyKuPaoWpoMXebA3RK9ci3D31NuRYFCDRvcTQbRHyuqpZje2jfPLG9lHu2qf64Bd6RH4FV3yzj0q0ktwf30dFmnCSuynf7aZ88o+7m/JTih0xKDdUQ5w8uhV9MKDYNVfbciSPpP/OEiOQaqLXAEmimST+e5nFOwl4xCPwSEREUIFHbOERHx8eMcUnD4+Y4ZG43SVFZFEqOTpEo/zJfY8vlm6G3AXDvZ+7VxjljcL250vcXN9NdhQzRJsEu4Fx3HWYwRjKBGPCtrGe/uDjrkWZmOuCp/ui2xtwtoo+5e+cQJ/yn4Mgvq5+7WYKh0GpyOj1gwPgBsQ7KfEfn0xEunMQ2V4dgpH9eVI5k3XI0HTBFFLoER1ecqmUrg+LpoN3WoF06iCNCwuAdJt84r8re4gYDGHVwIJH1fktu76wd8hZGgOoYokxjoHyAuLsUuVWIaQIVaVPXv55M7TONbnTaG4Rs48SN4PvUW0xI9o82HDy0oAlpEYdWxdqeI6pIaFwTQyJxnzJOxurLpteXbZh62uX9bWlPkgETR0tjs1biEP1WAQxHpSWpet9MtEltLdx01PkFqMYvDY2+HSTiDUATJso/KU/FGymy+xuKAdWJRlSxIg5VscXa1x4mYmL+PVAH5qouI50Nb9xUNariiJsoIqwLR9qep9ihtNj8Tr5emzBiRQIJ/pJpFCoHClrOkaqLf0HemYg7p5Ots5Q60R7R7WsWb/S67/0RRB+5pGdCBFyV3St5aSjqmvtGV1rd4cfx6f6cBd1s0/IYaPePomE9UYa6tLr52Na2J9UDvk2LwiEQy4v9WIII4RgoiRChzCwNimP1aSHze6VCiQ4V4ViPdT3cDUKK4zobujeWrdBYPUiu3lrYMVumF1bjOtSdaBU3Vx0Sc+rqlIKUmmXq7fnJy4jpE7NUzYhUNP8+Lia5z3T1Tx1L5NMqCO//+R1bIGeqmOrqDapY4s8ug1yaraKfIEin1Oz/d1RNVtLmmNDmiMQ52kKtyFOcQyeBfaYIgClqKjdhsdTu405Kiivl7dU+zbRR4iHpGXHjqt2+3tIfZTq578/rn6OzpTq53gZUz/fO039vMAUZURZexQ66Krrq8NY1fVFS1TX99H17FOPtGe7y56F2R/i469BT55fFT88FhsRRWisRIglETA9/JFTnXZz0jWiaxvxIi+U+a5y4cBedyxvXMl9R3n6+oQ9oQOYBphxMbMTgtkmgSJMJH3P/lj12IS4xkpdbq8HKVO+hevEcpoqHT9Pr4Xq3dnSTyJkjRRBZ6Kux3I4I5RdfoLgTrW9aLwEtFSdQuCWUsvshApsQ4SCBSAJoK+QL5lLmJAbwNpsPkNR3pEDFI/aMshINg92AAYjWsY07QweM9QBDVWlz5DqOEZXcSR6qW6Gfa0SzhVhdPXHrypiynhr1IY0Qvo8R6G6YET0jChnCkyKOskHNLNWpPsLo06wgBMu3lItImNn/1q+JCZgU7wus7C9K8AotnDFnBV/zJ6soJ/U4eQGNq5f4VsF1+Q97ufifi4T/tGpjgKi/RD5A9Tb0B9qi6O1tcLAabuN3N//gTWNakpUrR+bd+KCvlq7TLy7hpK1KGgWjhgSvD23V+ygumaNCY1c0Zedwr5wVanCq6dYWKOEI2nuuStEuMQrw5NS+7IVmuEZoEOAZ0culBfcDxXuebQTGrm0jMOZ+bXsT3TmAh4ovksR7TiAgWxAYV2KxWSeOe5g64FqyxjiB3RR1tJIWaubl3XtVMTBfUfFzoT7KY9Cua6cX+qcd3vOT54EUm5cbVopYJlBcTMG5ZR9oMQAGht/XXi2U4RBbNA2IALhjYjPczCMxrVLoLPzUs97peE7AqfFYXpTRGhASPLw0ADPXnQM0cmQfDTHR0nTGdPaOGN6BG5o/WudFkNUvaB+l1+42ydnAQjuYoNVTVRtmky1MhaKOvdDP0XVntF+qllmT7bt/QzmhiIQeqJIDTjVYdruWO1FfL+xH74M0k2K5Mr9TgmdxaGuGp9EBTCHrAczhlaCx+pimflzWWYSUZWDrAwbR3HoYuTQljxEeo6IsluAR5T9JFYN8AKIRWnGpgwn/YVB4rosCHgYizSB2kLRsDCDcnE6oETtqzREVz1AM4gDHGs+0O2DfoTmRaQVqx4dN8/JyI/vG/mF030jq2XVqqfZq4tYqJ3zNHuF8zT78sfsafYLo6Yk4qqZUQPFv5xqC7Qut1RHjI3WnbHR+qSxUZcuqQDkI64GmNxZKz+5zxkeZShkn3GGR+sytmpYAOOeZD+u1kBF1xIN1Hyqfwgro/dimQd/q2ZGR3Amcpe3Rs2Mhty0oRQcqRMuZM/r/KRw1Mxo7JTZfr4ZQbq/el1Q0eP13O5SPaONmbl8hzNzueHMXL4HQSfh1z0fyw6BVCDvhkHiPi2gY5lMVUx5inlJlEvjPoz1KWcQloaZawg1K+XyVWPTAimHQv6KOb+UbehQenaNjVjXKAUdaZV0BrsvdbeFDwsP4gnJW8h1pgbynysHqm0sP1iT9ChTqlhF8m61gk+tPKaOMW4gXAsKV3m8JezWAIG7kV0eyKKRKLXVr78Ump/QjcL5+hy19UQD2io0ewAZ90qDFtGCXflS3xNZfpf/tshl6xXZlDLsD4q28SJ1+zHn73Etc7Ky9cAc+HkNeflvKxe9wq3Clx2l4cwprNLWfiLsAUrLY65mxhxX+7SdPG7nWgEvP7v5/sZRzBC8EL/cZV8yfhnoi17zYKHyNq1A3OOToj7OuWXrL17xiXxRz6hZx/jWDb6yAvZ8xOMGzzDqSS9m5DZ5TU6LmRAruwO+ofWcclVf4aD2fRve9ovP+Jg7PiM92kYrFK89uk7hWthEpwC1R94v9AmcRCzcN23X+TlPW2RU4grAXAUoT6xva8koNhgvtotiu7SsEEvyLVzSskJsnvFE1Tn4MUsLeqoPfCxAbVKZDu0AWwgPKPfs3BOQt/N4ih5+nhM3kNQIGeUU41kUD3/Bo+Lhf/a03zlhU6szIVNOx4dOLeprBSlDoe2nk4XnVKEiOwCLvmcQkgSUOzgEesTAeoncHNlBHr8K3DgAzgodiqiNjpxrJzcr2eJ9L6DKUXuowaHsLeKqYQeOkGgHaxwFqZHOUV1GBUTJcxZP/pMP2w6VrRY2qdXtVkihMhB5hFdlXNagoO88ZFTlf+m7PC+qmAKMdQ2pq5Gq6GyR7AdCDSGOAAltYiir5gGbojre+GYEz669A9rqX/WuwasuLfyIs89WDQeqRASvMV7V5AMMB8aIcIYD8QJrzqOGAy+D1bu7reHAuH+7NRYVI0Mow63mcNTOjnQju98aEyVUx49gwo7gXz0KO4L/x9n6e28as5SNfcc1r/Uc33zUqzDOfeyiQdWFQ2aT8VVF1KtHX1+oma5wxt2fpzYD5aKw2m7KY3kmeR3IdyFQRGQLd+JZt9boY2ONXrwIqC1BSKj0xgxAwVNanp/3GCcjcBN881h8k4ocTFymRVBry/4O35qs9tOGzcE3VISzbVYshqeI3pDoFo6P9SCB1B1ZSQ7ExmOv1IvayeugHtzu/yV1OlCk2d+janGMVGQDmtn38ade971vG3yW65iltLRhPpT9+4aecE3TCdv3rZd96Dfu2xbv5cONuezv5Dp3or0jmIpGYa7585oDXMfCRtE2KZcz49vQq6Ib3MM2Tj4gHZB7oxv7XrHwc9/85z9wY7XWYnE4cL1t2xpYWaY9GY3zXMdWU9iDxhIUD6RvzHpxS4busxRWr48US5Stv7VSI18hy9jec+H3SBzVLGwMGfAZ8fvi0HYErLrVK5NBwB5qbHDYdhdX7roOBXL8Xdl7gfpRfMBYykLkC3gFek390mty37oe8oX7fdAbs34Hx63iQ89TDvIh2aWo4bvsAzeaEnHysuTGgzpo/qxoesxxMPsCqpbe6XWfDCGfy8HZma+CK0nsQ2YEAr0PzwMcuBoBHLUxfh2tXYaWouXc2X6S/chBixfnrik0rI70evbLSKMIaejTQ2+AXPE9gqU1Ib+XYA8FgXSwV0mrlcfjIyz0/d98I755V+Wb55XfXD76jfRBW1bTDamfbWgL5LX/iTeMl0VlWd3x+vtdtaDFerZ1FcJKkeFokW9+VEUqIEW11xUIap8deo0raXdZ0q6JkuCoMcJeQfb32ZdulCKgdauJ/V++AQ17q95s15Tsi2b9q1kr/9OJC3UoyP4BeVMMgjdmLfH2CWuJ02KxOEKmrBLoKdafsXMUK4qf132i25H9qjfyhTuV9jA3xICrMx+I2M9Pjb3Xxar9QYn9xNTYu6eW8P6pee+ayOtlP6ou7nzXCUxlB4N/9f2EFzq3emPNHLUWV0QSVvKiNn/1hlppLCmPdZ7r/hcLWh6pEemibsvp2s2j2TnCpQ9s/5GnrpAKZa2shbmGtqaJ8hOowyZSu5rYd/UnYoEO3mYQ1/YRJdyRbt4lv342I1/UCZlTZIayJzbgEXEgwnkeAqCKWpZHWBa1b3KbLzXVanua6CT/pa52JnToZkxJ3sCV3AxdtlAAlzbarzS9J/ArXpBoxIWzEWqpc+GK81+uQa8YecKyGrsTXwISnOd/18nk/Ud7UvM8iKey0v83rDSEx1l1cyczwgGK2wd4oG5VrSGnQeJrcaWGzLBUsBnsO7iyPf7qzz79qOgnbXJzQcsm3zkHVS0bcq9wOKoXGRK9yFDRUKLE1XyEkvG7DHXyiP94Z+Glrs3TWpMLDsRQqorgG4X7+10/9JF/3PVdf89gg7IS7pORpUd++j3TSQuZRTP7J4xByc39M95Q75hZ0ppettbbCWD0qsTode0Aip+p1oOinFgu7r/dW1PWThg9XZEfBE3I65yqGwJwfIwacfagcP+Jtg17GZWFhviRW0xJaVYOEx3j4W7W8l8HKXo0BG3HlBENJ3K68UIazo4yMBMQ6IidTr09e4Ra6w8FeZZKTbhAm8mEB5mYNbXa5iZQI5c7v7PG3B9x4LIet//LloMQ3254ZNS250ucfRZBJo6oAlKgNm7Qu5MH7WuGsvWQI+Zb4mvSCq1RIKdNOWgTUJukPQy5Hq575HPa1Gt1q/VS9dAVFpm2rK0iRFyVMBeSmxxtbyJTDTJ1tHBWYrEnXlgTsefMBthu504BdgZaqtDf1tu2jJAC+/vr48DX0hYAbRkxdE4WZ9gAJJ+LFdm4stDaUOowSERBXY/RcNqTWdvmGlY9Zd2Pvhw/LwV+gS+IbT/O5aCrGzfgY9C0XSS2BGkRwseF57ykWLywdgkUd3EucPU1RRu+z6X2DmJpgRZ7cJKOcGc/fKTHuA69F57Isn/RSaJV8oDbrdCCYRRj2GxqHxB5YZthpFY30QVqZ3+PLqsq7ZfkRpHabdSbBvKp4kIH983mFBfbiplZam4go6AK1pAW5mb36lr2rxo01sRWETrdD88PCDNC8SVRfBF4whYwBshRgHP5QqH20ApMwX0Wy9U4kKaJ2f4LVsUnVHu6nWcpBICom81V5NTpjJ5jPgJH7eQsFu2UWkCBM8DWBQEFhyq6aiPLAailznm526FIsehEs4yF69DKwi1LRfsZxk690oBl12ww9GtEyy2OzE7kOQzEHEk3O+VY6JYhK2Z05zDPXbemkJbwUADMsDXgItPbp3N424Ofc4t0DcRAJiBqoBThRZlDviE9IHc4Xqzct00hUU7leipgh2/5YT6byJ0hd6a5gU485NzaeZXl6LoQ6rowZePVMJuuttl0ZUBEt+nCHBtHpFhRU+i+MoeYoKOvTX39snlNRl/rI69ooVmIVtV84yfxwlzcez55Pcv/E6nKSw/HYXhdCOtvVWdVoX4q5rF0iCIzZyO7uYvM5s5gfYicnuzQsy++RmMOZlDWuEMFXeIlBgQ6Ez/2O/tmpeMICGtC4kiqaOSWDMzRi+29soupLmYk3F1aWfMi91WqXsDWcB+i6kFhWBYxdDdqxzULVcf+oNhC1ZUErGIlT2IUxfqZZMHJjJBgkP8D5vZw2559tBgpIQJWI1Stjbwxag8om3pfuNOjxjruQLk+oto8wtnJaD8jiBxGOsmfVnqnSm+jnXTHKlSnGWhXZpXkrDzpL++kZ6qgsiAmZrHMl658EoTkhJifxOtCC5CXgylIB7OHXuvcHD6sR4ICDFXya+teZMRVP4jEqiYrNkwm76skXzKZvKeSfNFk8lmV5N3VZAornq7e5pWOa7KvoOGTdiko0JTj2KJwmU7K/gSFmvkkbE7cGQXhtRCkjx0XMmwnrgc4R1Nc6IZTl8dtCCPc+ye4HKzuCTCMFFuePZjk2SMKhkfcdbqjwzGuPaBgkj8PFATGGoQTJRZRxdJFXeFbaZocqiXi1M0b7e+m/fSq/WzQeN8ax+1b4zH0DT0hT1R3cA+VbId0++GpUeg6sAD3L8b7iZ224sTXdU+xI5O+FgkfPMv85gD6NImpd/lePN06ilMadRufQlXr1CGosahep0hvYOjqBvLLcQkYo8Qo1KEwoyoqeqnZV5XwjFWhRsJj632lrtVEelIUWyaqgIki6wbCfKrHKX7peSA7KKdedTSiXnohHa2uqMtOUe+iearWoR5G9OSkpU3VtbpiH+dKJT2iyeYLy1UEpf6DSlrZNq7ecBQwM2qVuzjViEQ7fafBh9ZDe9KpOP13zz+OkefrX1e9Com9D1ejHQOXBGg7c9fksdpT4ankJDRmnw8HXlQd9Wm69kYxPZLtYjyiax/xUQ7HQlYsduT2axvMiaDMk1D1gNUe0UgbItW4d7bIfeAqbAub+6ulbeGotC0cq8b9X95QKj2P1Fs/cb1QHkLLR7XuY6be+3PPiOhRJIUVffsYza3q26twr2pyOJRSBbD6qEFX5ganbx+rvn0kA6VHZEFVE/ozyFtLX/s4X9bhxRIdoYAD1Us6P/S641/SeZSK9U/0vOn6uTAhk92sCKvKuAbFP9cKQ7ldkFw7FRF18xEazlYnWIW7qvNrYqzuL2ASgbhSg087ENNdMz7qqY7zGdAjCmH1Qlwuft9Lcrxiu2BcFFfuDGF3ycKCzUV4cMz7QvAUkE0YraEcGH3yJ24iAnKnnC/nQ85KC0Y7GdqUr1YsAugVnJSt87qoJuZndRlS5eWYPG0SxWqSouhUrx9mU824NCfMuDRdA2fVGsEw55/qORvNyHW7Wa0ub8pJWOW63Yy9bjdz/Ot2M7iHVDTddbsmNTe9bjfD1+2aKXWmXj/M5EN3/bAzef1wRvrfmX79sKqWNauZ3PXDE8OjMwKPWcCjU4FHx8Kjc3x4dKhz8vDoMDxmK4LYGZqtXj/EpxMcQ1OQCVNlMIRL6Stw3Oh0G01o394BxP5DPmdmi9x6ka1t5avom/pL2Sjqm0+BKnJ3XHDmMQq/gdebCb9nrPDbHxV+u1fyLQuWTbJgWVX4nY0Lv32GL/8xhZmpwnxKaziDXOiT9njTucUO1R26wgZKhf33RqDiEafaVncmW82IBlzYlHFklJpooV71w9lNZzBQJJiltmsQ1YcOFvBqPihfRzReGTl0Na10Jm+qdzGoMCmzuFHY5J1SNNM6X7ZpAYFshzCPULFJH26ItYyEYjWl+YCKL/SO6BxIuHXpBCy8dNym4b2hF1UvbZsVDotEMH5VG5Y+cElk8qp2/MivagfKjsGg2OjV5FBoQ1C9ql0xK1ZeFKfw+LSBG3vyV5NDvaodTaWV8dhV7WiSVoZq/uLEV7UDzeRo5YnhEY3AI/g3u7oeVOZtSMHJXNX27TX/0o3/8AXp6bJBJuugU93rgHX+H7DP9fTv63vZDeCC0sfduY2KdDEtqnzeq4/P5006vFBGtHoT8rOI2Nzhxc2+1zi5m49FyNst513EdzcfK75F/HHfIjhvfVD5f8iO605OidvNuPVoe06uskgYei03b1i+PqbI8vU+9qloP/l6M0EBo7sGjxq6J4yQQR4hHpKWfeEGd6MxmLjR+C4F3z1ZUL8uGHF0G2meYC+OkNE4D9fn6uo1LpE9Cpqqm0f9zyJP0ZyJ47jm+UGYWm3Lwm7pEE6tEV1zM7pp3nlqRljUtVdNfrSi6SWYL/TIIVAkjE1c0dYYV08xI0f01DYVNBVCgJ792BtrUjrRJNlFaZO4Ti2shsK0takmubym9JHmEnQRQtcC+ShMFZqVnio2VjvpuulNdDOudtO0DUqnuSf8vd6uNnW2pAmeU/dE80XPwXVKExOXqBFOR0RKcTVUs3Nn4py/CCitdhyAcBANNG8CfqAcg8T1rGX7mo5+k1aukbamjFQwNlKgIaL9r8QB91UF1ORnN4LStHwMZbO//C0Ct1CvpBjR8muQA0Xo62vdB7Go2Snd9PGQDK8TfRuBh5o3vPaa0TFt4NGpjinqvh5ncAhbkGUT49ucgsYeuCXArqEH55PwrlWrky90PPHh1DE3sRzKJJvmHms3zVQqT3EaIs+AEtf2CsammLFNJM2OdStEkVO61aTMnPlr7c1q7fbTrNItbXmID6d1C7GhdmtWs6Hl4w2mGVc5uDLTvYDq07uFRoz3KNmkR6k0geraI/14rEfJlB4l5sOpPUpsj5BN+4+2TvZIy8A2SXuk1Y/1SPs0MUoK+unEZTbvYG6kClSpBT2uYocdEb9KL9PqYKEUTnb5Z8dKcWXzr7D6qhhS0w9SR70Ax4nZk24+e2rV2TM+0fDpxOzRyqg2bfa4OWVBURuZPenooHD+6uwxpKdI1TAVTxl3SI4I94YeMPXRHUloKNMhEJ4cletRo4l+PaLV5kxAkdhg9eXqQsuSrybneoN8HAspCmGDzLORz1QCLxcQeJDwxH1cjKd+Cygpeyjf5iJR0la4Pcwfh7Ga09Y/NEQFtORXly5jUCrS5TLRWPV+MUoCU8XCOjUEFnmC5uhSDi4Jj2h0zbVFxFNIof1QTLLqmErZbhU0FDFxLAlJ010jKZUSPeQBq6aZmnmSSoeCsbbYz3Q7b7EkmVaw64j7QqsxHzp4ua5OfDHSeG1TOPZRMPGRaVFoqwlGv9CGhqNdSbQrYaUrwVhXktGuBJOj5o91Jah+oQy9+TBN7/aCSPCqsokBEgca1pVX7ahGZA4Z9KAGaWFRt0iVIGaitij3wd+i1jVrJQJiGVST+8A7+Q4rnI+7YI2REtqY3/yZ7r3qghsR3iPGWp9i01AVKw+9IDiJnmgPQjRC18HIGaTzp8ArlAtrhu+vgXFX8lLUcRsLM3iiyXWK0FR8SuFIG//c9yLXPsPtFyH4/ajvXyJREfH7y5iWrYk2gCrYxGy5qe+/KA+1LRB+Z28UshEiV1gaqidPVNJuQhqONcOKNjK+VncjOpnNYZtzrVSbwK+QzGWquj4CXI7J3iSlo2/OAzVaLl1QRjxGQ4UkqJhZv81+EF/qNfi6FC3XeUtvkbFWZ8/vsB7rdsh2KJayUdO34PhRTTbW1dKFekn9oB/4crqAekd3A262Qcoj7awsC4ov2vK48EktQkkMITuKcqDRe/KCTpqKBo9mUaBIQTXN5TZfrtJKJkKKbmHFnJLbnAL64xUV9WpV4xUUcaUKlF9qdulss+IKBTzIv14ZS3/TDzxxOEmB2zNWYZczBuiBOMwz1XUW4sQskFEbQakItYPeGtf6OBzWQ91Am4GOuMwGrBgAVdOYnkt74muuosHvihe+9bqi50OWyhvgBdrSeLKBo80pktGqUAuAZ+pIywmFhwEfoKqVhYq/jQtrYfoHSRCKRKDv5YE/ZZM/E0fR2Bbf1yHU03bbEH9i9Q2d+S+gSN/rTC+iyhuQP7b5TRDjKhKLDDoxTQ2xuwhoPw7H2hRNtAmP0LRJvWY7TkDVezTN5TbljzRY+IfAtsF9pdQlcp1V1n+UB3KNHe+pV+2ptk55ID3G00NdrdTwMJ673BE7ptV1C4mJSzS5tSjHZbkaXPZQ6DMmZ1TtOSDhgOpr3sQeMWt/Xc/qbhkb+SbSakLtyORg+ZODddx9/iiKhdoKfxTqYVWGpCzB5vjlOZGHX4G2a5avAK3AWnvlkhDhRgYlTGQLU+lJEVuGAKJSMbWeGJ37kIQitBxAzeVav7oOppjAuvYKH+Pr4AbCxwhrL99h3gXgY6KREtqWbwmweWwJbwupKLcCKyHoErevk1qv+3FuiJUvNtc8NRggX6c/5Puh3tP2dbn1mTWAL1CuHq+eGSIPbVUnNIWIpMft9JLkwEs/qa6D3HiTsYhHs2qsY/kwdRQqmljO8IIb5pGfB6ZebUUkb9GUVvgn14pESb/tijKE6VsrfF+gIKmgKQUGPNLCwh+hq+GU9bKooxbplp8bUbCa1KEk90iLvG7TIuuypKvDWw78su9HxxsttXzO0MljO3KYTIASt4v8bzW6KXUg+RjkEOeNxvFxZJy6zKMtc2NY3R2Oj6FdVQoPY+ihfYG0T8EL/JZWBcdpVTCtVYy/m7SsYcdVu6ObwPTHPdZPI18ZX6CS2YeohZIK3DBn5UPuVWgszygAIwLMIUxlaoGHWWMIGSttRkTCn4+ybzze2MAIg4qBMdumZ4syU/qLJ2/+8VittP/4ns9+bMsU84/IM2H/8d2cl0F567s/23LWHw+/rmr90er6RKrts4mb9f5d171ILMl8bd2t//Drjmf38c1IraX/49FYR/wRfFu1jojeOPOIeBu3j9ifavkRHz5G048YwaqpQhRpbRX+/UrS5uuguqEOr21dF73C+hXw3PVE1JTrCppHFhNwZK3tYQlkZvuEa93EP/uMAnvRUNkdovKUAtzNRh5NzaG4uGskps0xqxrTjw/IUremSaKOgPiio37PrxMbQCjfp85Gno27TpuVDcks1UZcp2XOdZogKGwiiM113ZFSu/SPBue5yrHNm9shixVNGlWidBGZ3FKqYdFeFKYIl11wVWOQZ6nWhMZkQ6jnqH6yGoqZowXnKoVm4drAOtrqIIOybxATzqBpS4xoYz1Va0RWkU23LTCoVFOZX30XIoxVJepaFigDxi7ze/iyEQDVoRpmgISmZ65xWdXPu4M3ueBVPW2S88sOwBh1OxR97pSWzNqWdK7Z2PySBecTj8C78i14UL5CmUnonbCK1ZOsYjXlQt+iXTfw9lWht9iK4nu0woO4ZTjAMGb8soVW8bIFebK8hgdshy7l87RVTBjO06zgwgC4MOT8tfJlIEMNzGDEwaPESGfWEF0V16E6qJkMaeXaB0fPVi5fuTSOp9nhOkaQW+7RVmmVioYyacRw1CmGbQGq9nVfO1YPifn2LeO1bDlia6nhzflQBowmq72DZo8MJytEX5doq7oL1Xm+rR/BHJZOSdKpvgAIr+Y5t2ebnL3X5fRuGy4YCgJshx0SY+95qyTRNvAvxf58B0LX5DtpgQrUk59C2zkUcuhUnkGn8d8ubK2V2APN7bM4na0dXU4B4YnNd06noXGFNUl1NQWlraoruB+7pB8SU5xOp8MC0xkkme3rmdy+QnVQ4ax/jha1QK6+Fl4tFy41fAWHM07fpg7yi5rk8yXtcsmn4b2Sb4EsRyC05+GF/CzcqhyLO5uC/gM1QF+VbpnjZRw8Mz9dxqkm9q1Op7PZhhTMR6X85vP7WfxOPhJt7Dzg2RGv0VrYURQG4kln5KcTMJjr9uACu7BCt50YlFPpVABDO6td4TK1v9obtVtlbWudUu3QSTUejeVhc81/xC1PaUe+yA1mtFGB2HbcY5UxqrnGu5FDnOuEjP1oJ7a7MZRyfHUCpN3ncszIVsvhFWyinK/fMd6mMt3T+C0/jXZhQ7iLtlpB3jY1F7yNusYrJG6wCVg7AAe6zeURddz9y9kKBYI1MXWgZ+ZhjcSPUtX6WEY1tHbeWCrjlZvrBmzWZOkF1dE7abapXbx1KbXIuYQ2ztASeLKl6oUvIUJKYdpUQ3JtJLlVJrcmkoWa5QtmWVZDhiF+amKO6I7sjbKKb5OlN9+p48ZwWrC3ALfaabOAW4Bz/Ki/VEjWEv/BRLBwWQSKh5K3oi3b92P9R23jZFEHgmhpLd+FVqhlt9MCYPpptE0Hp6BdeUdpE8z94ouiRLE8E2O6C+JD1ld84mhYKiqN5I8uaPMg8vPuhnVnBGVoO+K2C+IUp2mcNFBHkrYZC95zaAavlWvSRTznzBUImptYSk6FTeccJea0047v1nKYtk4fpkJgu00hfZoZigXSe9VjI1bM6QDpOBD/7bRjgfVJHcMefyy0SzkRfBaG4itSVyFu3y6as2Ox42s2FtsqYzFnxuI0jMUuxO3SOGmgzj6ay+elGaep5Ar9g3Xr0+xAbJOaUMZITYQYop0odafeeFUQmeFY2mzWpApQw8PuK7aV82C7zoMC02YXEtVKJ5bxDmPvIj/nHMROowJ05mUHaI6ZQOREQxdzH6AD2ACv0V0BruzWqp1YpO2wAjoH+jY3QknQmV1qv3QX+rFrxCH+wfLy9F95nr/ZJvzZhV+ed15OvitBk/dWkvdNJp9bSd4zmbyrknxWNRk7Sb2BC+s/9v44IrO10j7Jj72uYrDfFRSOFlT1sH129XKOHWUUayTo4k7Pbl7Tr8zFzeviV7Al+1ewBzC7Bx0EpYmTUj2yf5TPZUmPce71JJjgdrUGG6JTjVPtZ0E94bKX5GjW/bxgoSNYDdvGGIevxgc6hknLM8ITdydwLmSieYYLbxeTcnLzwt3FU/jDBeEPY8ITJzn4bjc/8QXRNLOdi5yScQ48a33dZ6ToYkYZ+MN58O8ILCCRWvkytfMueTA5a/oO77e47O7REsyo5itsES/vKYyU5cYefQv1YCdV+4KBM0/Aq0Y9gK7o9R8MRGY7k6/Scr6Vuvm2YK+hvT1bIeTEPOm0AryQ4ROopxXQdon4grG0CkqX4ZN5Ig7YzBPZtBF5T9pUoFfSFtS+VWvXCrV2NOVrXzvvRK6GWdtteLBtXpbqFavaqlW0CN9wbARTpjnZRuEL01h8tcI56sZKLa9EXMcsRAsyNoSzC3wtrH2tbF9OW/E21kRwNdv7GN2MS/By7hwauQoStNoPDLyKsmUFYwMHH9DGCf+HybMb/YRJUC7Mw1KDYaYeastz6ilX6BCFSN530A40BI1DmwS0AkVkWZG917iJ3a1o8CrAYlpw1LSApAXSF84DyKIfBUBfWNAv9w8Gazl263h2aYs8t1CT8Txg+yhYTQOjLnGZlZBwGlxMX4q1JO9huz8xkQCdKTMR3T3sm0l70AYe8EzgXq+cYKv9yvzi1m+XdWOVJxjPPDfJsnKSbQcYiEck7/Gn2wkqGISxyniyzggerOQFl1ArVtQKtGTTGnqCVVoTSU0L1LNoso22mwqpNoYsYJGQL0M+Tc7K5IwIbdqKNmEQSITGda5sqyAUFRPtqJl29DZrR/+Fj1tTegCRNmUFU65mCYE2hUxTtgqao5levhLsBQCnz7JtlVlGx59lAPP4TNNZtoI4UAk14E0NRtuE21DPiXr/d8w8NVqN+YXMSziL6OVL0Jizu7ceNZ/rVqfcTipsHcBGzRPTYTHmvb2cCwvgvyinnBbQhe0g2j1ARlLZsYjCvlgUIo5lWhJOoQVNyBeIAUBzSN5J8yb3PF5P4VjNg23z1aDbh69T9lXxoDJLe4Kzs1pOTvMTdLWcZzrqs9KdBTv6DvMwpls3HVM3npkbz7Eho7HBQtxWyTlP82akMzvS28qR9Azmo/7pI6qjmVIkrAvFMtEgK9BwjcOZ+EyBQ39r9WwQWLb0w54P78L9Ts5M3MilMBcMXTAS5R0xBX1gg2yeK9g+77AI4YLbB4fsV93Dyu3+6/SG+4jJYGsu2EkNzV2lL1y8TtG+Gzee/Ff/8FcXPm247wde/rs/euZbfK6klNrql7AtMUh/NQmb13mvQjesGWeYkXBHGKTWj1fzwF6QB7+LcBe+cOGNwKgD6CFMHY+WXtPL5Byjf98Qvg4exK9e9m5mt4MzhonnBKymOmDGZjGHh7uUfZKoxrCaH1Az98EuEyYOd02YRwtfcovUB2NLfVtUU6d8paXpV2pNvC0SCv04dfc1edRZZF50KBAJEd661JHblZSxML+zXualTsXVsl59DWq1q59uBPm+3EvH6tvJZ/Qs4qDHf5xeubQsx5Ew/Fy5G8xi4hk1rcmoOGLebgY2Pu/2iw5EyzJWXImGdmooKh1wt7IfB8jVLfsqzVwQaD64wKheUNWtRxu95uqojQ5nciCDS7DFTKXDM9UOz4x3WJtj+jyTd8b6PDPaZ1xbr9wP5z53sM12sJEe56bHnCgA0Y4LStWcrjasercUSy2C4gg7oQlkPA4e1qp4CFC2SswhEyahDq0S01RVRXGoGj2ZXYtRzKtJF75+MW8S7xApXhwMkZhJf6cZh7wHTfg8NCn3oUVdTHUdTff3915TNEzmBoV7/Pck/AwuCDYSdc9yz/qoe5aP4V3ds2iSXEH/BIJpXxKF/sjI78fvJcbPuDGD1uhznOQrmmzukGubwr+m4FbREATutYFjNnA0sRa1W0rs2ljHURePjd/fAwFQQ9aUjJ8HG2sSnpXtX506WMM1nuosB0Ei+RxEQC4l0xweC0fkMIsCWhggNAfF4zmqi5Vfy140uP01biu8ezTN2714G9i3Y3g7bN+O4u1gk2aslskMurGocuQ6b754QHg/0N+7VnXIYvp9V2oCAxs4bAMHbeCBpgWbDRyzgaNNEbHlK6i0S12WRSK0E6Ge2QXO0qrc91Tec6sFk75uA/wUdqnAbo7mhA3YRvPIUwsqnABGoDmSayv1JnPV+1kFnPO0glb18OjZvWAiSZnCr6licgUtXjLzci9eyLw8gJfdCnMGW+VlgBcyL4fxkpmXg3ip6ZBktIVnpenuEreaGtITYWy20RxQRcLbwb9tFVKyzDmweQCzMy5O+RD3uNiGbACeAcsUxOfzFP6cf/4ZzOVWhLdyGK9SN8KTUAMO5YupiPchIl4W9KEuXrHZBMZuoUUwSQbxUguapplpCpummW4KnKaZcwqdpkw86sgupUO+PH3B2hju/qx/w7YeQyjieNlPyNJWhwSX4GeMWUyqWbqwkf0kkqlRupz4KpP5B+vUwELxJTwPsjLJA3WA//SAzg8IIWvLVcNqyxVh0OFgHTZaG9B+uRm9ZOKEucElvQcWHQ9reAPhmzR8F8KHJHyef6Ma1I4Vx7OfldYHlJQuWpy/st342VPEzl/ZLuevbO9j9lf2+jD0VHhYMa/dtMzfdKIJa/aEZ5eaEJTphansbQJk8eSyYG7LggGEEiRusGd5m5oVpx/4Gqc/nL6gIQZiRqoVy6yYlg0b5tkfwFonbPIkVJdPnPu9E5fI5axzOgdbQCO9T4crWEZ1VOuJxStxdo/UxLwRfyaO/aiBowIxfWyVXxslo9GCJjxcKiFXNkQvj/lOgwPjy4CRCrIBoCNMkP3sm5DN5Mlu0+SUEq2Wl2KYNIeMslWe5YEdy47oHTKukNcLIkCqTTN3wD4KvOG1gDL8s2c4BIrWpFFewZkQu8vtFpC+m5rOXMAxoIJ/LdDBbgRCp8vkbF9MBGrZBwG2XNyIbvh5RLyiH/VF14nn1S0hBVMQCS5bBpxEMbtgwzOi0GFpYcNXAI69gn0P3WXcEK6/tUw8uJdc8Mqe41EeYk212zk/ttR92FKFuFdaczfuGqDue2zgfht4kAPCfPATlOET8uRPfH3e4kt6cBhPi3Yfuu784JBvShjYwF3mk6N4HvPRhrs9aQNiX6r1HNDirjDfXK6vmVbe0qwJBVUMRwFdkDbpGf/eEorx6z6a+nmJOYbf7MfkNCJgPMhDPHbnkV4IWh3lNzXyco0MQMe+vXqWpMkHKslXV5O1GdnvYfhXcMIdGmTCYB5J/3PVunvVaL9a3tOmZ6+Xpqpruy+yTVyxySfJagfmHa8btc53ki49P05pyOic8V/AKO3j71rfMaeNvAnyO19lTpUpvSdTpnQwxpTe7JjSgWNKb0cw1S/uGvvi7e6Lu9wX71A29uYxNlYpGsAgKXmaDYUouPlftQ42Y5nTjjKn2XOL2XZN+dI50L6wgPZdvsCdPOTh9E14VV270fFEw8vIu5B38UjyLZxyb6YpK5XKqJP3yAfvBu/GNAdPfJqVWOd+G/LTKgctc8tcBR4E5hbcCtEAoa1gbrdSC6xCq2RuOVD6ABQKO1/V1NrOJBOn9bQlL6ib70DFU8jJTnCuWKsRGNjAYRs4aAMPzJnAvTZwzAaOzlGRb6Md+Slc36kQMdOpwLKW8qU7bYf19TRAQtlUhcJWlUhBFYBaU9jUuZFcO+mUyVytfuYAA0UGHIacgscpdCoYn1MNm7qsbKqKyfTlGF4y83IvXkhfuMtVNjUDoEpeDG+DkhfD2+GSF8PbwYSWdIQoZ6NIPcBGun2KdgaIpDjA430rCSYgNChRAIN/VQ+jPzrsBbLiiF6eOyhHak7z4B+xnu7NtxvcYLFrgjr1TSqjrVAKkvKvLLb1GKdQDwe2j9WCNuS70GaUCYE5LQnyLp5kOXvKYjgupV3oyHaawR+EHjQnHOocrcpzlVLIlFLqYbR6lCmbOlMuUy9kMdwdd7hV+K3FdvOydy+54JU9jdd9uAte1Xso4OnmvRR4dGAjP51nC6Y9LvKL/s/+kn6sYa5BmHa6s/k0zKlCTKCnC40HYt9WHoKYt2AUtrMeP7MLWoBaYKeO2mvPM7CwW5ndTXg4jmVrqO+BN7/6UE1RIVsXau2y3K1ZHqxkeTuyIJw51v0MZd23mzFmUlFy7XSG8OSDBEHDlB/WF+XKD8oL2PLtzJbfmSi3beldHcvBOO/fMbx/x/L+EoC8KPspaU8EYwcb+87+ptXP/cV5Kxc7O2jSznUeNto+KCi7E7nxMryAS/V5DIFnaMMuLnRjiHlAuAsl82A9uxUqsrdnt+MxLHYRvqRd60RHHE4MGPP7snTQdteCh8Sy5ilK7VuYf+xy9kxdOuBdnUdqPyPGGuNF9i/Xl0IQKafowBB3A2orpJ8Us/sPiNacx1GzlPFbCJtPexx+hBUa7ILkglAtOZNmn6OOC45lea+yxixWVpIdj6RQ8vMt5eKyhYLsp2VACm7+dobxLD/DC4IH8OTJeD+edEFw7yyOWtCxFZVj9fSKBzvLYD01nEWnfVVPX91kATnx4qCBu2xgYAOHbeAgny3Jmovau1Ct2obQToTsmrJjbE0pJtcTrBQnXk8OPp7ryaJSfF1P9OWwrif6MsALmZe7quvJA6rp0XDLzhX6ogvS5fqiS9VeGSPsCWkV4kh+7OfmJaC1l/byeerSKq73lOp50EPD+6lcc65gY+DitDVf44T9+Uq5JuTLHHxglikWjpSMr+BTaStnK05Zo2UO8fdbVZ5yGi2QCZ7FsOKxz2vvfXie+Om992EW0P4/PtOMFeIPT6OzNhW1nGY+42fls9YU5DqLToOU5TSIWM6inQjvNBKXlkpcKkdXpwD5pScQhvm8KJ0iumT90C2QQPV8JVUZEZYfrFartGJWT54X+S48753NCc8HZ3NQJp43uIi6RRarLXaaQJG7I151i1k6092dyJTYzHGhk33Kd7Y80TG7O8vhzTZTUiTn/WmFEBQVQrA8pZizy8melpOdD45lLpzFE6SlZ91Ywc/Oz8IRtzZuh4g024z5+VlqhnkH+vIVmJW+Ri6JzWMBE1TCtEe+r+nUX5Spj1Z0GT3BSGLq527qL49N/ZWvi6lfVKd+UZ36RXXqF4996u/YfOpDJ/cUw+21wKHRPM6F0X0zYVulMPSczWfsVobYOY9suk5Bh3Mqk/Wc0cl6Fv8ACXUfsw283jaAGq0+BYf/DFyZgjtKYekV2G/N9wkS51w6mJvZqrLS1OD62aO4flZ+tqpzpDJXS/yGkgm3h1ONc685ZTETalc5vXWKBDYVn6uDIWJq1J4QCyJRQjg04sjTxWfbAyx5CdbZFjbNaMnKvtLpXHhI2yulEJkXHy+7nE3XSqkUgQFyqfdz6nhV4KPYRBQ2C+Do4L8KotN7oFAJbAKLxsFnS/AiDl0ioT0c2kcJnYFTPkWi7GeUL3P1yx0cbEJRKJ8NZYW6hzFyEI39RKZGJhomlqwkdHt6keddK2LXgMRXyB1FRBEEbhEkbLvvGFJNBG2cWJGxZW9FO9JLRKkTEoINIyHgWsCdvQevnbRPeq8wOybkz4gMNG8NUhfk40D6Rd8Lp4hU1IbV71WUTdsmEBYhOhSaDsE/aIQTfJQfOSt+9g7caLqkArseQQWQ1HRgS+D3kdk6xmQZLl71wDMktfUuWtchVAZwIi3KtmulPGTn2v7+y68hf824tg31W7kn6PevZ++r4rpDmoA4ve+r7iRqFVsBHr7LxDV2BqlU9glpiF48lex5yM/SgQS2BVHVsPDxYX7v1xrm9z4SmP/5KMz/4usF5n/5SGE+UNs+wXWAgh7JIFQeyWhYj2S87F8AxtxXTwUXGaP72fn+uRz0zvfPgpj/QnGTpgJDNXMTnIcUcdVahLyt9uGNCN0Lf/wqXChfg7MsLsJO5w9ZYnkQ32SFZqwztcqmZoo4JdHKwiKCcjnuzKMmeKRh4oY07MsAXI4CacElbuLAZT3jKh4JHi6K7xfbDj4SxL3HO/3QE+tHEZMlLDYBWkVqvytA2RF3YGTXWxOdq4moZO0ZCIl3Yyj0iKN8NEqar2muf2jdBp9FHeFuA0XcxjjkXXFCyaBIhsbXitodEM/ZSeVyY5P8yluqDdbq4/6d9WepbRC0hcAUJrjZK8nExQ/1hbHW59fmEaofGdrS9D5mDP+sZFvSeIHY47rax01tqtmTPk9P0uRwTX676zA3gEHJPgZsBbjVyEjfk0NCX+2m7OKvcX//ZVJM0L8YcpGy3HI9TffjBM/LfR1mt1hqWPteBEe+F1V4ev+kasNe83I6Wq9lQIpg7HscwVU6XnzuUAc/3+MHLOVWlQzgAWTAaj9BPgQkVfuA04wBtBCP+hGFJvlYOQfygmEzKl4FClRkYGNbqMNpiDnfdCH5QGI1AKN4bszDiHtL+Bznfr248PtE/HdZTyYax+9cQ82wfcbJ6h60iPRWeqRX5UMYHOiqTaAFdXyWibuzc5myEELCBawiJFxAS0K75WgvVqf15ImaV/a7SkfVAo/WoKaxfPS0RhoWEzdmLOpUU9snRdDLxaY0cYBjzQdKvPQTbWOiVamfwLCiIFP/Px9+X/z3hd/f+yP3f6LqIix+7t45dZ2M5e7LyEIcu4U4nlyIXbqkoomPrBKQLizG+sHPuQU5oFr2825Bjsl5lKIYC7K7Kkc1a9wk1syhKu0zXBKswLrkIi7W0YiFJ1D7Wf7EChxw4+5UpUj1QB4LevCTgtEVuGKK9B0ecz1og7Yg0k7EZtnHkAV4JOQblFObg8pbcFKmHsoDsWthQl3C2qKO7Rg4dylXoBXgO13zQrxqZ2AYTGACoyrir1xeitA6HbO+iS5lBpvVfJWLZnK3YZ3ZR8gQSsekpWiG9iD7BeG1/VE7VOleT5YJ8N1e9i5kgYElhamdlaLAaxZovKn1EWliAtUNdVuI8cVDGixwQ1imeM26k/IQwfEIB9bul4/CMHQJBVqB2vAcrSf9ZvQ5M13GuDsTbloTCpCQuhywFmECiVKAMjzTd9aZk4hhVqnipSncXAVE1aOVtAjQFhQOGQPsFhWey7iADFTPrvfw6+/82MMf+NinX3fDUU4Gs8XH+oRGZxv4UOy8wIVT4WNzdL+cGYS4R/fLiipQiIwdxxEzx4FdGLMjFT8kiWpjV1WwIxdsuGATvqVx5Cva2AlFUMNuDPKmOLHKg6p/jDxyathqb0fwPnW+MaK+842IeiDP4SLzxmbFIH8/2aSZLRdsi1Pc1mgzW4O8faJmCj22jNeevby87634JaywIRGlG+sjTnio6oSHGpp2pGhQY9JdRoNqrtjoZHz5YNAmynF66tRkto3aw4EqsPjZr2D0XSeLqMxLLgixAaOYiix9PeQI9uMSi6fI71PARxXjJmAwTsFG3gTSyJB5x7VzAtYSaFgFuoMkNQdU1zMhtdRBoXFjo6NiTOWojzRpKSRAaifIU7NYT4B/b8RUfBWG1Quii/zj6Fst+2Mh19umxYIi6kXR3dP97GOhwl3H7L26MDnyv8f4Dilv1/pOUAKipZHexGXWlGMr9b7Lj9SUNaiLmytevz7pQccbgnet4LLn7qUjfz+pXqXwpk0bNemqVyx4rngjFyyiAVgiTJlws2pKpCyxlgKL+x55k7jvTb2SgZsSSgorymDBvmctf/dLf++ZP8Vhj+LheulXWT9afytO+F56fHHD+77W4ob3PRJxw/tHxQ0f+HoRN3zwkYobnudD7006vZFzel71edT3BUF9jaIDYingwMYRCow1KmAaI1juW3ecNSNa99NDnhdUuKhAgYXeKN8UUaAmGvCacIw0klTTzc8+VOWQ/JJD8vGqMw8cko8IxyHhBd6nRjmki8EtHLUcUtD/hKUVgXJIgeWQsg+XfFGwGV909FHwRTtKitIapSggO0ou/s/jnf46moFimTXYH+Opf1VX7gdj5wMK46FiIWkVoA6ThjwRst9QNWAoPftr2d14I3/K+USot2x9QuBeGzhmA0c9M3/FuzGkK+NrXmxUzjX/XfbDgQ0ctoGDHtXVpucGs1WyWPIv+CMIjurU2D9lsTxqF0tKBjql1mWFAMX4TXRKCUDEhxoIiUmKltADxLW1+9QQfe+Zii/BABd+YHcf8rMMiisdo0eRz6qiOHECLlWI9RNMY9xcThG7SLOmDQt870E0pRfNeQC1ywxIXB5N9HC07NE8ocJbiy51B7SEIC3jl48wcOURk3rBCkvmaB5fGkWgNh7t6i2mvFO1CZtSAy8NfVGhDZqqvVkoO4atNNeExyy3dV5PSUbFNCLmySPjHl9xwHvZpUoHYA5tfqx8AHEePRgT96AHCaqOx/iOT0zwHdNiuZyT5Dt+bZzveEZJJXZWWIxdVRZDk7uV5NUJDsS14GJDjeTRr6/xRCuUOHGXRWdUTdGscMSCrE1hJQ77YD+oaEQn1V7goOm3LLWEBmPIGoz9PbJceJtM3N3kEZ5knpl5CrlbG9X19bFIo6HZbxuLm+YKa8C8YcE/GC20I7Hg+0IQwUQu/krAH46cvAT7YDQ04oZSVK1t7+hrhqrFKQHx32WQ20Tkg8OGkJKJgZ83pDTsoqqOEptCXdJqZMta6MCncv0WcyxvpXolmFqUcGiXxHI6P0RtFJJpmCutzBwIlVK0K5WeN/mjvGknUGbmQKbDqiZLGNXyxjj9a6G3k+Mjo9AWgXTdWL5vUX3D0rVBuQnwIcAw5rOKJnTxxVAxYNXbGFLK75Wdg9CRFE1NcTypJlgEttriQJpbxHrZAZlD0pcELw2+zp83zEmAIRkRD6od8vf5UVAuO4qGCUZ3ZO99MBx9vzvkAfTUq0F/bx5UhysU+797hUeBEewHQ4yM+MxUI+aBCJSjNQqJn0jVAVNfe8L4qK2zkUaPDYKDjy5HaItSJwFkvbeRh1TPA3M64BPXhwsF26/ZsMtLWFlxpH7S7bDwo0rLqk3xQciVNBow1tK7/Rj3HQBAf1Q8OwU/iphFH7spIjzJPDPzVNvWQBxdKSuOlrGtVGzBMb50s+WSdXtfoxbgaGxPYRWkOpo9os1afkTtW+FO5dKe2nZVP5FwVG28VKT8jSh0omR+Y8qE0g0qYtYCMD7OnJLnYHmAT9iBTqXvyxslnVF/qwota0koLBXvGdRG2Z6a6dvDCGdRwXWBUh7dflaopdoJwu0hvWa7x0R1OUrMPOM4zsPBjgeqkH3qNc5LONhLpxOuvkPlAKcIcer1PIgwIkYkvFzOeAFkHQKnUFKe6KlNdUyCvowLmnB6wI3R9tnTRb0GjCg9etTWqRi4iYO4BvHfpT1lL3EYSM0NHIjhrdp4tPESblusjU1NY0Np4qBoydFYnUIMeKiNT4dFyj9HmAwFkJqL0aUZR8OuU482/dPgmb+hVDMPMTpchFqwx7w8gqJLyslxDYy/08xwN22yzwsTPNOvE/99S6///LXsbyQKbHXAhfZgj14tE3CNXebK+JEZ7yotOV8z52INajJfYwZM+Q4P1hfKe23nTTPWzL7/9k+YadYFfbqF5hO4ov/7Ka7oHwwix6Q7U80WPSsrGAocXzDALXSFP3dOUaK+jz2a438n1gnlEMhTrleOTIREILSQJ+pmrEEB9D2UShCyy0dNgHffX8bP+OibPvcPSt4SSZ2WwjiE2doErWhawqfOYseWz+rCM+psH3xmHki/wun9uuvx69cf/s63nvH6B2t7J/vlUh5Nv5Sse85uHEWPdQv+ya/dFvyBTbfgf3jiLfinvrEF1y34R05qC37UP/4WXF2Qui04NkjZnx53C+72zSe/4X4k2+tg+vb62GPdXqNrTMCj/+u312F1ex2ObK8Hj2h7TYbpppPcXA+mbq5pdG991B/bWz8wdW/9wKPeW//J13xvfdvI3njgV1tBa9n/rm6NPWyNu5tujU92Kxxmf2a3wjRlJzzwbWd/tbotwshoM/zJrZE3+n6n1/etPo5MkqB/Bd5HNkicdAVoYkC+mLCrbpAQV0RAAjBiYH/MBklVJXxpKXj1qB+IcWmPomduukE6WtkgBVM2SL7ZIAW6QfL7nckNEmiG1E/g4ewGiXQ5BRyD0e2RTha4Ppm6PaLpu6N/u90QPcbNkPcIN0NU2QuFJ94LPVaW476vHctx0z9uxnJ89sQsx2eU5fgGy7EeJdjngrY09Hq5nRrHvBOwGa+q8hh3MY/x+c14jGmMRYgZcaeXR3gOvDweoxk64bAGiZ0CT5+HPEosm8E4nTcNGfFE1CWGBqhOHmP7BLuBoKUmjU3ZDWUy2tojLigEayEsR6630/OM0w57Yh2JQp7cyO/RDLU4oEwFtTYMuwHDo+AyFsytmEwZiHlTbWuCw+iUGZA4wWG0QdgWaG5TDmNh7M7wLC3wl7iWQSnICA6ID6HxEGySqG6AaDeR1hKGrcVxGJJDXrFAEUW0cGVPB+kwYmKKJSamEGQ2NLSkykNAwMV3Vz1+xhfw0BqeYmEKT7GAFhueQiWIHKc8xTFvlKfAfJ/gKRD7aHmKv/ma8xRv93zf8RTHqhIkNOBvLZmasgAFRjUcz5oKcfCorO1JyUf42d8pH2FlPdPZjWytkpNb48yRh94rdIMxtSmesZKDZ2aetUl1qMorTV3+sXKrSKLvWZfA4gIjEj1snZpOzmMCNeMiPe4VdTePS13foB8csJ/SaAYs1vwpvBIqB3DEj2PdSQm5q2hgTlcM09UyFh5DqRFFSnTcGp9KP3gplfucbU6cgel5lyGTWc9cvXMd2CH/AN6UIcj4mw7NYAJiUs7Q7AhDkFmGYM4xBA1qqHX/mImE+hW3TADc0M8NcszqRGd1R2Y1SwypM77ad+xq39HVPk0/4PuB4IH1ostNxQplVHzUwSs+4QZFStDZncUutVySgUcUEsrZ8OziGR7ABcbsAXU3j+gWon20GvSh1jEGR+4eMzjyfmdw5G5ncOSjanAEia6OiGDd50D2DojUyqb0OSD5jlO5uq5+jtHv0A6BcVnTj6uV+NIR27/sC2rKxdx3UMncp1Z62EQwlr2y3Lu/EhjnczhQzONwXd5DSfc5r+VGizCPoCR9Cuy4WKv3U81V141peTzJPDPzlBYDWTFgag0/yZvSd7NIxmKAUH1cp2AQ2u2aWHASk4qUQm2RcTKFcduMHy/k9YIfhMu50C/iVS2FjBS0eyNfhNHjxbV+8pJ8yeH9Mhd48OK86/SZtsBuMjhFaACyViYtEP/xxf9evwNFsWJVnGuh/K2UwsfXNjwysW0baiVie5oIti5C/F3a4xmwQduPDIuccqEKhNlKtEohBkZ5SBzEHVzMC/SYa/AxiYp8Bzrbw/K905YOvSwqcF9bYyjE1VRS8x/bKL+y2NrLUX9OHMhpp2h5ay20U29SEhb8HbZEWhJaFxJRoTcVuJCdKCTnCA5wLFocykXMAtcktYQipR0CBlrEIzFdLLYP8rx/Hdczx83OBCBbi1MUajuLEIO1U0vYRoQ31LTNeIw+BZLvU7jGXYgPcU3lVK46lw++V6/QcgXbpIJOWYEtl2s6TWuSCnZpBYDHLq3Auv0JNRkV5CGSUbbwxQL7gFpyF/50rvlU4XFOZRiI955diOLPTCxp7BlU0I4j+ZnU4+/ys/jRuSY/m1bxdg7lANCD9e/Nn8CYspu8/ImCZit0zlqxwncO4EZcpepAwRKu8/REoMiTOPCkS3sbI1B+8iA/lwxUZznQPVA8BXf3M+KHwnynpp6qsDlVQZJbkJxLuQHJToAEiHJvrQR6m6FyrgO6AWpBXG1OHX7n+kLYB8go1PoWtJoFrvhUzb3JGONGNJoTarIOAZJRE1faxtIvh9bncfgeCefnS8Iejd/DwaMafwE9AWvIhYo4Cwrn/KkChkKKJplTp6h3lQUc5KRn8xUj1dPjlN10CnY/BA5wG0+K7XQmmpYU24fF8nHOcMJ+nUKc4TClALGq8gUaoNCc7WxZf2/e5aqEfmDaOZvnIa3CeAKIaggLHNsEaoxKRT50zAJMrGGl4gzbaVoCVOFCS1m2MvhlnqZ0Sr477b+qfy1d2GPg7KJdtzt3ekV+xJVDW0YKzdsCtdPoFCYcaDdr01K8i7tZhC9l52D5U7jO6/qv4nLX8ifYvqBvW7VvBxvAgFVx2ESiTEhtXNh+wsto4Ro0eSt16RR6yjXvvhmE/UNv3oO4fih4gwfZTgH1itPU1Z9CcAt3ZHnA1O4M4r8re1TtyGg3njDW7IsqzX7aiZuNQUHTn4Cm2048Be2+tMcxTxvtzEUn3RkMTf4QL8x9n5vyUm1CvkanU4J7KU8kbz/WctR6NttJkrG4UBYfCCMawrUgHcYMJtoPQTHu5hNnk0LaZ3CZC2f4tZuJg7U3FzNqDVEf/43NTKO92C91YMvhJbiELjmLp9PTaea7e5XuLOCxYHvVc2sYhgfN86k50jw0RxtGCxxXtNe44PzpdJq2mgFqm0ln8Po/gwVOpONPvxkjsIYGwzwzPErzjxqI4q9ok04s2E6ExF+NdoITRQ7d0zX3bFhiOgs/pxj4nwU2U/RYQQ1yPLL8YkdABP0wA+nigdo90emsY9B2qz8+BcPr1vtyEUUTGMUuNSA7RYs1BGivWbc2LfpiLnq7FI4JsEsWtl5xBt+I34vJcGQ4OH6duN+IgcAf325bIBxtYzHSRmQc32UPudLxXQqGMxzJQkMcyeLqz6Dt0mLYR9c+F+j8NpXoo/qpZMmMw2kiATR1m8mQt7WaqdMSuESGSbFXLb5pYEO/yiB5yKf2S2VKohlH3jtlJmqjFtCaBdT/COaeL3Pv63DWeTLrvv7nWw3zrTY631I6j84HB7WHLgB7dS49lRklelL+RDqVObWdzA4+Od9OTyIfxch+IG9b/h736rp7/GMJP7dcENyN5/IFwdGEFqgltotF4BMDCDP8zBmG0uHYcs4ztFVa/d3COaPtxAFAIAQEVEwlWzbDPklRFFlz7O+jfD192POi6ygQF2fkreG5G+oy+4l/Lu3hfU8RHlDv++L0PVRvafX9GCT1GkZ1pOK4UsCiu9eLcM1b8j6rqF8qrCkKoUTy4osi2g+EhtKW7BA5yE0E+H3gi4+xRAZzlpbYSWfbiEJNu/Uqz1nggH1C8zmvaTsqqut23DdbZrRYWnoCFZF/mKIicl8Y1nXzaUVgVHXlrZv7EJv7iDAOiLNXEii+tAfzwBPb+zy0m1/dSncRSgAxiMECinGhS5ouN3U1n1xZSPBIENFAqIWhbiKUYbRxcPN2NWu8QAGiF8SoKsRD5tJnoN7pJNTlUCiVNahJ6ftgUUCE/9k/yja/ObbNb14gzgxUyHD/mJDh007IcL8TMtynQgYkuv1/nVj5NK4KGXAxfZcWUYVDUnY/0e43yu63Hq/uo/Otk+4+2q4yjtDKODDuZeudsGaajCMe2UoHzsryd9b0VKFEKTyFzHsWoZTYk49fdUcn64ssHLpU4CBUTj+xYgSCvTdmM5ER1EUiKtFziVDCoRWWQC8n6R88C8ISa+ZbpNpNqzdqj63ColXVuGuLiS0RcszwczdkHTH2VBl5QvZmKdrI57icg10Ra8wr3YcPF0r3FwnNEv8xj7poJBfiMXYRRSyTB8lFF49MRB6JliMuqlaoS8uU4I+pVsqSiy1HhrBnLZKLFcBjhZaMSF3B3WTJRdc4N19UyUVPPJmrja6tpnT+lmvq4cxRYyjh4wNakZOBosuWiIrlHhfOIeJAm7ZyLYmpRW1AcW7xkm5LpHk5fkm4kJ56/eZCtqKQNkdwgGPRYu4OJBfLKEhK6MGoHcBAc3gkpovFFj797F/H9cyIcGFFdtEJb1/5dblgmUPZhi6tIBo1dXVXC2tysE+VaHKCrWeCZNnV9ojL7m5e9vZK2WTL7hKZsrej7O1aNpmykWyEFhHFAPsShA05dEBU2FBQlO9Q36KU8zo8LmhYKMGQ0Q5xecqBnRA0VIFyyoD36qbvMxzgjT87SZ2FEEBxZla7Mcvd2FrpRtt241RqazfAh6K7iSZrN5AsIDIg6BFXCFZoO2oSl0EdSrSmltbU4ppmjz8Ys6hpdpPB2CJtL1rY5LfFiHtW7BqwrAem7gXEOpinKSDzM4Db+p96Jd4OztVL7euSLnvLipc6nzI7n04n7qnsBdwMcmjpYQ4slb6nTWHUUvlSfvqmxe7iYreoma2iy5XwH+8DzuR9AHH4TOwDjl8fZDo+/ngX0KLt3B/mJVG7z+USQ0W1XQf5mcyYB1TwkgRDvZW2EJeMJxfNZcrp4TKdSaRTscs7gi3Se4S6tIXHpsfP7lS+vXtEWktd5t+3g3/ntqJc7kBY6UCLRx2kshWkKRBbodXheGxaElA0qT7hwbREQqGWcAuXhVgQN2oLrZhNS9u0Fu3UTYtWZSG3jBpBOVJxhqGgwhtqHodMdjzIKIGi9tT+t03/2yfVf8UWeJjR2hRHZK40teadIBeL+TbBlZapeQjwD4XC+rSs9u0EanvEYNvuwVBxdZe80mAgeRHuSkxmMyTGwNsA8Fsp4aeGp7dTgKqgY81/Jg7N325h2sKDJzG6tiykpdgmMD2VzgDVgvsHiEBpUbuCiHD2Biyfyh/uzHcQTGxuhZXFfAuxdFxVktSlmVkjU5qFOgoPnGwBmkJ1+KlLEZYhuwS1zSI0vgTpAsSQRemWqlnr9e30xx6bM7cH1k/CmdvNPwWe7078WmduX/6/3ZnbVD9aJ+u2reo8q/TN9fXmvW0zl20n6aetM7WLj8Jdm6KgumubQDdg2v917toeNW5tilmT/tm+rzRAeeynRjdzH8W7buY0STZzH0MwVaWzED813vWKeRaKnPOd0jBSX0oR3MsexgjxXZiKD6OrixiPFzofRlc4H0Yvf8w+jO6LYs9qgDvCd6z2yB0Z8ZiBwbrFlzsMGO97/exfHg+/RtBSOI5vo86j9m30E4/Qt1GGa0oJzMnoohZn/yz9k612jEdL/G2l4pBdn7vNk8wzq+wLRRdWrVLlUT8RNfc6FDoQ0vrr0ISI+KGLfqBK1m2a1ZW46urO3WGekVjyn6MLJcCcoi6a4Rg89kNJRZzRr2mltlj+42nVRrmcUtkjc+vb6D0alQfSVtfCCDwCRVLIlUXU49JnEaElVVtYkx6U3pmEDYGfyuwhALIEjfHOJPP/DvA6xjvT1fh54VTvTFdMemdyKkfP96pyqUhj9VJuxg8PDYoIaouqKpmQWpiFSx21nhgJ0sG5TgR8+Aqay0F6ZH51jm8I94WbGcJ9ELWln00bqUxTp+BR9uqB2n6nvwE1sQPQL1HFixdSDGJ1hb59l759u75drm+X6Ns+fbtIVpm8rjInTGUI0pQda1KM6OexApJY28Nas58h/SKOgEGoA0WK4Q4OQP3vpXY2xmp/pEUpIBSKmkMbFvpiAoZIXDHDpvmAlYQpeJa6HqY0e/0hKaH/CffmpINoprYdWS5ibKRQmkNx9gabdUHyS3TesTZ4suodP4D9Fm8d22BsRBPpCcQdc262zuPk8Yp8QQU8i33vErGPvqwbFx7zed1nC1fOXOwi+eCOF4wsKqSWCshy35XZo0VMJCXmBz3aQj0UwkzHKq0yl7P1DqN7PrdGXY4p1z5i++Xly5W9deQ3xdLR4dCtbPg8hPRI9cEf8ott/Lbtkl7lnNnHZPep576CS3RM/bowyrmf0nwlcd7uPNVDi7mhDvBclCcKJZ9SEf0l5NvzibrQTFEEdqJsVBKikHIQISajDmcbGcHCVyZ6WUcxE2q2bKz4XVL42hE1p6cNqVMm+6VQqi0SlZyRL9XXyccjwRAlkN6rKcDk2dB+F/1aVADMZtRMnlnMtfUuDq8/kPOlhIiZakQdLahbiOomqAoci1CLaN2320auKLRCSmUHw7svbco2gZiHoMyOuTVVwsf26ljtgHgMoiPEv7vWFUHqqldeN/CdIXxCi2tCbR28tXlmx5aglYlCH9yguveGPxzW3HwZw/8nIXkutilU+RHimIy2YfGMSYeLPzlLzGAitBuCeITESOYCQnCsBrKK4B61jaljrPrjaiYTRhbfiLG20HIwOkvQKEJW3eGO9kh1JSNK0ZXUyl30sAENLhJRhZe7I6RhkRjqfTLqyawoVq8s6j0chHIEBzjWfCD4bT5Bz6XLxsZmLARHY76sMdqz8ahP2Khfea2Nuncsium35Td76eFgxFxnPG6uk6Lsq9MsTel5Tn3ElFXdmbKqT5qycumSis4+4mrQ+s5a+clBDKO5s0G17Hq8Ku9fJ1xLsAaLqW4MW9Ga7Mr2y0mVVCARu6RSMXK1Bs1PdKBi4iqCPU+6FA2xJq50ngd4lCauggkTVyG3/OfRcmImC3sFZM/r/KRw1MRV7BS13+WJAVp3KyXWHtYFocypFJCkIfiERXLEoqfQ9ub34LQNeu7UkOAu/7AHFEMfYtSfvfrQozfqWR+9vPKtuK5xl6f3NWAa2qit6wofSu+ksWiSdkLM02Y3HrJ3WeLN7rLccOg/gGXPj0QBOKzIXXh3jCMAcQ/cYiqKHfbU4vchPL0LMNhyf+Xlo1rqV4++vlAzXcGP68XkevA8QoEjZvECaxaviLO/fy2eYue6fgGzK8oz5InwY2K7g/t2rVptfanjMbCUcR4g3nDfLbO6iA/LdBjRFr14nG7t+/hTr/vetw0+e/EQxYqFGt5R3nYr/v2muUyXYvqK7RkPC86AEsMSbhjzlTfc/Zsv2v3f7zN16P76Wy/70G/cty1mW4LZ371GzMhQhHl2ibb6Im31uRRRy1qS0LDaqVdWfRce5MnmIAK2vhw/L8USAtYxovQ8OT1pgJNtUpT9CyCGPFcVAa+/suEKykNtVACLB2iPGkb/Ug1OzO4Qyq2n2/KxytfblIorEeUVi/qgkOAhHYcqbNWqQ0SmyOyfjJPO1bXsXyWoUw2rJodO90OYyRA4JAoH9DcCcy5wNotETevBupX9g3ZMy5eJo4sSRxwcv8Zy57RrLBOxoBV6iWRG71tlPyo3N+SGiUv8m1EDi75WpYcplhQEKkdjPtz//gLHwDYpgdZ8yLGXmbhItCU8wUBQFuGkOEwyC1s+iDEq4EsIvmz/ve8vOBEZLuv1vwpvRRz5ED/rl/YAcGzN3g3YCPXMg81rCU0tKgGThmuzAxb57pe7BvJFhHyq1lKTIkGPT/eT803+XOztK3UBOVFak+jDUZ7sPWjVivpaisQXPtK4YUpv/HKx6aTZLyJvLf1l34uvc7AzrbPgU1hzpQpmFAvVFDWo7Rsr03qgqsxhAoYpkYPnIgaGStEYHwpLKGHXr1/HwjvHlW1CAh2iRHfxdV17MFbaCX3NblIuzo0bOlo2n4+yMYSoLqwMYWKHMLseOKc9S6TgIhxpEDe/0hVVaqo2KPvMDSdh4+RNhyYVWGBcZcSIii5iFvjefp0AVNNpapfZf2oGp7BbXN/dYRxVe8lDlRzeOyY5/ISTHGqSlPtpBEVSg65jeodrarRzoajjkRW62S4aFMOIjui2i52epp5MpHplsKVb47ZulGf0LkZHMTjTexqzwp/Mor8gGzBPgIHE+zxQGi1YkNdFsG3SYMr4HUo3uglZQruW15zvXclUdCVb0ZDN7hauZBnwDCF65y92y244oo6i6HJeoy0WTSka4fHRf2Q1p2U1YG5NMddQnAa2YSKdwMxaZv9pfBoEXr2br6obOygTHEC9e6U529COXTkfwOdknJsVYjhih6i02Mv2UPkUG4o70Xy5QUrbaSfckfl5hOzWI6Hc0dqBs1spv0HwEJZAV1YKzHmIy4ulAZ3G2eq4gaZi8fAoaBleSG1i6Iv4lbUvNTV60dAKxOXZrqqbkoQScWS2iwLcEuUovDpnZpBcOZNeck2rrhfoAf5mzhk43irx78Bd7oiWrVLZMu3goPa9gbf9opRY447XpUcN2kG1tUfZqS1Un+gUoPbI+4U+gVKoUVk6DXFQhyhkVGoVgLkKpPjEukaTYoPxYnMUmxMpxJK84JJIIWad1vaQhfVT8N1WRf0aOAaDmFRre+kU1327jH3dZ5uR6ObJZK7i9HwXt3uXAg06rXgWZ8Ct2hlwqybgyHdJqzFT8MAA+2JmQxmXeVrkUYPdLZX3OtbwTMCl7xnk3CVgPRNDZOzzqcKA2gMADDkA+/QCb84oUuOz6Cw60+gH46gVFGIWP0I8ILxgmLcQwc/TKNVQ9hah9KEKGEHgsAeb49Ln9PxKyVyNYu5FT/sRuCu6j/Ws9v6fOomz2pt+FoR5gF9zVque4b9xVvuNs9rHflarKKhntRPoBkx7FGe13zir/aFG4osWpx5pjtGHSPOZ678/O3b9F+/KkmmSXv9F0HgZiPvIUx7usIEbZX0cQa0bvrzEb/Db93tr5VkvR42UkR0WcUtdmD57T9ras6Igb1YLnPhaZcrM/KVKxFK0skXTDMy05SgyIjzJPDPzNFSrnzwXdVQNW2FiyBXVQO6VhzibtAJZ+LvNSO2bdmgWjznq0NxV5V0Rp26fycEkT02JpRbYCzkv1AnTkoNJPPbnsxTowaTUE9pi+Q84ZHV4Z8ELzpp9dkd4Rb7Nnri2ZTQLhJTPryyyHpeLYjIto9o2tDyfF7qvGtMRPUZgNf8NgdX8dwAWBPvgAARoC3D7wTmyX8URefa/Zfft7BHQAojDPM2XMcejEXPquInd12C3rxuB8sPnc6/nBMrVdWBulH7M0VyFfswJ2Uahm5JuHo4YpFvMicYU6qxtGnxA++dxHJUdRse4buTh14N4hb0qMaiodtL0Rosew1tG5c9aql9x7dJ1Pv/a41qPt8JVYnTPGDH6mCNGmlSTK/RKjKYxig1B1YTwzKTDQVUFvYmWR6AteESwaldXuzN1vIkNCdkH1Qk2AWLB4KS/G8f7lMmeG53CmxHUpuA3MxiIyeTwq6irQRUhWNivKicViWSeIuHnxODEHNdjuidZaE53k/O7/H00f3btElxjm0cRfMffNyRWlc+XlKVblmxgSrsgiVJYsYUWxCf/St4zjuoTOUDGlW2woCu0SotCLrn9AqAuRlz6GIFVRZ3nIl3PBbZw/oUD+s4g5zYin4hSrLImt8PuZ+sKHy0p30qLDJWeOenYSvXRba2eFdqjqwyzMxPE6dESthKrwKbV0loWACP6/tje4pYi7BN0xcHz9gNI1a0tybEJrgCI5ZslDKeozD9Qc/taUijly7YPW2gZyvxeZb+8VXZzdXAJeU541vJCy8FWVnpVR3xYMzBW+G21ezmeCUVlo8aIARKTyQcNykeSSCAB/IkUf6xW+aoFRD1f5eoW7Y50kXocNO3G2/58GQNOPdN8/mzt66IHOoy0rERhtHbFJ621i1ppiX9RSb2UeWtYZeHTqlkCGi2ZS3mKLfZmQRcN7grmyN4JAPL3cr06ceAlVFqgs2MJzdArH/JJsXWqz/qGsJHYsaIXgt9TCFGh3ru0H1TozrXIsWPN3Y61AZhqjzKdBD46v1Vai20smgas3lqhYWJb3lP4UUPA34TYqLpbbcrmNc/MzrZOmd54bKpJjR20g5q6W61RT+/JmXlf1Nfwzpixhqg9ShoENlS3G9bq1ExpDm9zNKtvsM0lB+QzMOLTwVB1KECPSFTZm9oxq+mlvayj2xE3L5PmyeoboZHEgabRnrJGNOVsEZhUyvib7MvWT0aMC/kmyZdjpavPV202SMZvOWSMp5kDJ7WMZ6LNed1F59kN0rcL/89H3NZqM8CpImUx8cTNF9AXjZ6wNXoPzEnS+ViGdQiEgqrsqqiLOSK4ix1AZS/SVt1hr7dBCQnZEkqQEblvpeat8kWptLhxkd68qIvCglmwGBsAHzVkLG03pkWzt6BvFel6+gMVlxa+mWoCIJ1qophm/AvH6l/YeB8OoVNWo0BUz3DMr9a5Ha8B8+RinTz79I3SI3HF4mW/cr3xhvH/eNMuRwbk6S0+bIsurPU45Ot1PL2EtyChnhxey8EpXPr9ArpVvRn3YJ3ZjDrrhQXyZ6rZ7Y4s/arRZwqGR4qqE7u6s3bRPXvft/9r/mXpT1YkLhMc2JWpV/XwOqQG/htkbxHjcwNqaEjSjpSZh+J7eL1oOkeDyGHr5MKGOY/evod++gu//5zvueLiYcWDn5wFMwJokbIzartrdhCx8SSbkTDPEdAlplKOZigt6oi1upwDjHDIrytr2YRz917lvn3ZDe0v/WN+89MpJfdyZU9MXGUpLkHCqC96lM/xOcDtn7v+6N2v+/JbvwJ83MTlYzJyiDovK38/fEm+4BqaCHlGAgAPhjzMXgPOx+ybE5L5TwKHdfxSwpx0a98lP//+2774h294+vcWsp57uD6T/dbrlVk1r7+N19KW3Aweq8WSyD4UIBoGeQHAGEAGaEUsdyhmKOYIDpQQXLKaX03x4F90MaIz8gXycsuc2VLIQtD2LkybyUEEHpnKTCjfoufgwO6GOv2GCDC2n7PC8pBw32gL5Co47OIWbDgVZv6Hm0m491asMAauwzssxQ7ZOTkGxYCII3nBNcLl+y9o20NL0QOc/Zuzr7/1Ldc/jdiTdQIk+PCPv+yDR3cdenrVyntCiyzKxc4HmL/CFTksdcErGZljbLQWoMQ4S/PIvIVHzGVuVDPj8ierUFmlIphlBhlr96NvljtcZVEuF1j43XbmfzcrVuhxlD2cspPDN67aMbYgADjZ5KPy7DarVRfmvj3m9N0xp5q6NZ7Sn+1u3FKQ/euryy/1aNXnstX/oLK21sC8Wlg0+yF8iuLSPw+9zqSFRFFU9aTl5Gk/5K2F4Rk9UVarwSEO/MEFmHVKjzxlc6NSXCPojnRKVbeQ39MWf/CcJueg+NJvoYkeeaCrf3qDO7gz/SRPtLqRRS2vgTj7thlFJOu7AlrBnvC4paYLttxPo1zJlWuuPEkp0bPbvGH70UQ/eCuJP/YalFIDfaouqeh4u28a1ypYcgkooCSZwLihpVsWnzpiKTemFLyGuikfP1xLBA7gImOn7pmCYuCGst7Bpqad6VqJ8FXOKHvNeLRWBbB4zVRxuo9xnKgC3Lx0XwGmR9cNs1bDU6piJkPM5UIeAc+B7EsKRfIAWcBVleyqJjU/7/sxnwu4ZbY0KCsV5qGZ9WpdUHanOh4xHnJm7jS3alCq0uNvvLD/Zj818hCKlCOjQMYkkMMc+0KSzDFoNtRSVXzrw0dWKKfOB5T1Ef3KPC75LUBXa3dDXkSqEAlwAuEARTPKiux1+xbp/NVxq3JBQOCQtBDVxYRKFRy0ZHmCeFFByThe1RrIy+5Fy4AzmJXSVqU8HCbnkeRQ6EcjvGfdyjT07gpENsoz8cMcvyTZxzCMaRnRktj9/daL5MwfghSw95f1svtu1LKQjvE+wEmAS0MUevmGirpY9/ezHdgivUxWvyajy/5Rk+Pqv9YTKxgwIctlqUIUpiz/Nxg6I1oQ6GyoxlX2GVQPT1t1VLL5B/7IB9Q6ovZkXyUuX6jueNxq49H0VK+eptizNSg25qw9dEeVX4GD4IxU2ltdiwIxeZKqbrm9+smoqneTpa1gk63nmcCmMBcU2PP0Bqa8MM515yPX2yhabuklG77roiG1eCEObx1ig1VdgCnga0R9VZ9QtQ8cl2e3Yy5jmHWgvezHEVH4TqlQVxqVyCSPULMomKpZFFQ1i4KT0SzyrWaRP65Z5HHkg6OaRW87NKlZFPy7axbdcWiqZlEwRbNIB2XSJVBRGx27618t0VKKalKmL+ABns7dGmmap9QL7RAS7oYcxCattqolL77gLLpUKoymT53q4ujlU1wcKeWwajlgVX7a9+qT3IUhH0V5F68IBHuESkYWB1ClLgLIg4W5CIAScNzHfyVKBBYl0H6HEhFqCCi2y56wQaLNh1pd1TEXuz8PLUsFWUGgGIBa4a9PGGR8iRCOpc/Tb2XbrmQ7AlFuoRLkk0eIh6QZbBBImTsBU8b/tbCxP7lG+maWoXhByRBRUOkXxd4Ffvj9FnaiuoaqceAAB4e+IILoVuhiCLTL1nX3jfUnsGxgZQVJD5Sm/onX+ZCnYP967xKUqecZrJXaP3oQiHr7QYEzT9YQxD6sqqpDNp7diao6ZRzONSQOMPlxqexnTx4/whH88DbBj2AcP9D/B0bx4+0j+FHCKQKk/p0w5CeOiyE/idRHOd1/amK6h9XpHp7kdL/6JKb7cWmYN0rDQkvDbvUDnMWEk5crLFc4E/h+Tbj3q9cKKItLG57bFgd3YA+BxA7bqY4nwwDfsoT9W9rW1/hPMyiQAHYBCJvszxvWbndzLZcPKNL8PLYwtJ39jKAryDj4hhDu4CKNBEMJjFb75SK0+1lTgfueIkF4V4KLsXGJiX0HYkduOPy+58UOLFje0BHZOXImaGwa3p+MZqgcdceikYhHTSgBQqsYYaGFCxCIRGBvAxGncTGQeIYWfigAFeQx1mMuBkCPqbaGJVZVqPABdtMxJXrbKIDHQT9ESK5HtFIrQa7LDkPbqiqdf6SeRNzYBjUPDDzVbAs6WgO6q0PuuSEXBHZDPfqRe6uSv47iQWLRAP5I3lnSpZpiQgQUiOV6LkWVMapbwsUUQJ2YBiYFaXVT3M/JyKUf8nQW6hipNxSCJqvGBNZ5PPmCLWu2hXgBjDgaQGqFqktJ/mi/fZNfc+d+yxvtcw2xdng4wUAcbZDmVIuwmbReMuq2/xp6TYdv7ixUvPnovp3qz26j0/rgjTqUIvpc3v68qZu1VDLK1nGtaAnOeNRAdQ3jxsp1sV+D90nGlm8FOYF664uKtjjbUAi0pA9aVCOfoZYqBeGd37A+UQMLQ85zCXVn1DLCRZ7XsiQJfZsFhmc0i8YUsxCYATwh26pdo9meaK9SI+/wD81IcZlSj2b/OlSfmAYo8AJ+IU9YwkRDKh2h5PQAcRpCXCsUQoBOZWgHWm30bbRfXp5yRXiTWhuqfjuLeAFhA12o4VOdpKnuf2cvLUIRRFANXUBXWLKnuxZTVBtTt0MepdnPC7rqqXDRgHZCRO39kBdwVHON1zW9Ka+426BZHhIMR4s6mB34DgpRSp4ozT1H32RPXUmEzKiVQ4nIozbOj+A8KlIDmsBH90l2lxK7xBG7X4Z1R0fhfIfZE9TOF2oXFxIfC9ELq3Mlrnzry/Lgo8gorwWaE6XzZAdxSXQpgcaXqw8JghW+uYRmkyxdC6s07f/8if8af+RyY+jWX1J5oWET9aFrq+uirymepuhXKD6STx3FDlQE4e+3jlOsgylUgtaEevRTViAWLLSIAEPi23JQCuHqFwsVDHlCBEW2uGpJinfZu/QKXTrmD4pCh4KvCWTDDHSybABOZc3pcEwRhi+qDp/qJevwpZIjr+s1Qwe6mIkjJ4Bnkt2k7i87BlBib9EMdc2tWgJBO9fCsdFLzZDr9UidXir2rTbVqzbVK5vql00FGjBY8YVy+wpqSNSMk56IINYyqzBPiUrPY1QcGIQNkQFYq1nr2h+sFvqFSdD+RFWEFgohjUDNxmyp7zVG2R4d7RBbgKjclsQgJJf0+rI3EcGn6inp0MW4PJcEEqM+iRNegUy/An7FSlTiU1P1pXwl6/zqK1kH5ihZ15DEJYreOsu04DpJaxgjny0SSOkpU1jwFWAyOR1kXBuk+JpgOUjLBqXjDUpOvkEN06A1NEgLTigG06LAgElelX7jRTBqLX3KZrdxjBZjkL17yo2ctzf5YLtRakyFPJerGlNH31lqTN1rNKQ+Kn4S5TRpQ1Knn8bdiTTVrUIhKn8BIdl1AGcXOARX8XqoO5PoAO77GlUg3ZQkyOPJctmAebqmOMjJxfEUQRl8I2/DpueMxYkYgiLFjj6/iaBopiJFTI/cWsxQeivUaKHATO1KYlMSm2VixmesOBgkXw+ZC97u3Qk6lRhp6o0+fg/q5XrvQBGq3OUdcB5zZ7AGeZyovfQ3hEConPd+T0voFnFfJideVp/V028/z6nQZMW3OP4uvw2qenWF6GsHmxyCBrANS8BA2FsRqfi9nggV7hWrBdo68rP36C0ydfydQdVxyADIBDD+mfzRHc6y0ZVCkDEq6FEpuizbZE7jNQsf0WeH8J5nijVapXbNDC3noRlUvdud2VJmDrNP3zvk5rT4BHa2rIFmq+d51Fq/Y98rFn7um//8B97Oh+az5mzxmqeRC/Lp+Sygewl55kCm72XvUz0I0y50NxtkvwhIiAc4jZ6teJZ7r263uT2ZNHeo8Jrlb2cFTX5JPp6hgGC4SBTTkeMqHBVxM+1lXwwbdRAbkI4fcaHZBr7el/7A/2x53DP4t5LpIMYsbstRywyfgCtVMRNaj9/sXEkqXiapCdusG4znBb5jdfE7isyld9xhcRH1jtzuMAo4D5tElSxX9h4KiliItZ6NjNaTDd662UcB9o2XiUv2kNCDFrA8+2Wzxw42eKohVrsR7MeZF7qiOfRwQuXNerICadQxD7MD69vnQ3uKi/iP1arxv3LIxh8diX9fGX/u9GJ2TURztUwNLSNx1PPhTtFKS3z1mcmPTI9L9ZhXz9s80KioejQSj6quQ2yJjMzsG8bYoCeMtwxVSx36J9PzxBTL0bccsVI8uIMCyUg19pgmqYMiEvzCEhJQqHT+tiCGwWVffVM5P6mWN1SaGlGIs+EFecjdGbk/HcqZGjdb+BWeRT8GgGI5pKiiuhKX9IJckJUU4vW3MlrU98N+g8tedbka9P2c95K5bkpjvYSYbhTRkHxWOPaw+FW8laCdYLK6ao8NqYBH9gE0awjVpcS1WY+FRIlCTMG774oILwt94+A95fRekRpAH4FL1gHawmAFMeJgaoJH1vmBQ6oWa6wEuAt/FQ4tmzj3aprbcf0/rxmFNTRFTyrKEz4Kqwd8bwgCGL4IHI/kbreO+AZE0ef5pEa57vEu2FQVJtPT6/5OSFdrWERS+eZuL4/xtaOqfvZBmRxAHGCn5hrVKqmpY0Gq29zgV8/Vy6K7IAbQ60YMODX/I57wCT9sJrd5nr9TGKJww1D3LUzdmxvrha/+/TBYDQrcAV7A1bzFpiTVFHPoGgHhmyAOI31xi9GH0Mjj9yWmumZLMVHcZf5fDCLMD3WeanUj9hXG8QDOoyvzWjZuOJ96wHuRMi3PHncmHAeyC9ejqAZnPLBm9AtFGsArIiKyIqV0kLdk2KK8LZOgRUAZl2dolpKYOwZDcUDSW3mNTN1optU1csBj3YYWI+yvVo29W0X6urwJi+2vZz+kBjAoEB193yzLfwQ9MZUsZkdlrfr4x/CPPb/hyxra3iSncwZEumO4DkNyKEe++7A1uKKrXZFCM8jf920b217zuf/E46YlfombX7YD8CjjeYlJy9zQEUsxF4fSVrWrlP54WLfELRBr8iNGx5L13MezmwePbEhxG3NUzS2iRAaxCMEhyc0hWaz59X5MrlA51AhSGAAO7BichHlqWpA5rOoocl0yikWHxzFzbc5GeB1frslBbDOUwu433qEZyJ31gbpAkft4yIaj51BGPaxYPoZTBajmqQ16HXlRKuSlpJyWcgVwYx3FONfew7xDsMOC8jzyh8JZmORde9eZxQu1n3oxxn5Ze9pQ6B3imvu+/b7smu8746+fzg2WJURhAV5T25hsoGctJq+M1wPtUkKtA4geoEZqA6EH2jv1faaWpfsN6YpP/h3aNAqGipUBGC0sh3xw/nCY+MZLYwxK6zyFH/Td8YQ60RQoFHVHrdbV+MsxL2+gniFPXv9W43MxVHfgfQ9/TO1m+hnx36W40xPL1WVuAvSkxa+wu18naAHTjLNrG4NijuaGA541qkCXlDWbQMMGvowpMndrMc+P+St7+CUOX1ks9Mr7PYP1ApHzQ3ngStCHD/7P+377O36ULcV880t/91ee9du/+CFWrdh56yef+umZ34Drr+/4yVtuGOz4JGK3XPTsf/3sV/6eY4v5I/zxQk+fc9V7RXNHaI78SsywcOmVrHrrKusn9poVvKBi0GaNan2kzpXzReOAR7bVtIBN3JKgyByzDTMcOXMpIIv7K3JnambjSD4v81phTJp7eZh33WSd6+/KZ7jQLsMWXOhakRluYZ7bRGYG5VwaRxczaM8iF0TL+G84pLnj9sr46OlIP9qQd7SpBYaLUUK4VrSs9PR/oec7sxf4sY6Gs7uhM6oJmjpqCCM9zqe/eaJP3+T7XsXvd9V2pXB3INVygr6PPA59tLaWfcQsnDHD1qgrH7zxnL5ScnHwjC+MAO5XhZhrpahb2WA5bPloSfF/TbXhtQstc85orZrFzngoBZ20n2RvEl0tT8zYUT37S+witW39H30jn0NKQnYbcmlTTNrrOC17q0R7kpD9hbUMl/2gHl2+yfNBA6xgN3sX4FeoWS0DxupSoLItTlFts0q8kf56qqvEHa5yIMqi4hz20h5zolAvAeaPuZQlL/25xF+4LqySobDU1IyU8d6tbPguCmGXifStq6cysb4lsqchfnOabnXd//T5Nq7yfdxFm19vQSK/yZw4NW8wKXp00ETEvjzFY4/egj8rb+NB+QweSd7BY0HcHM8aQV2m5kxEPRG2HEWFKY8ARgnNQ7XYai/C7An4E+LHIrXwWKIUDxgPjkRrZVkdUcyKCHSZoCARA+SspQz36RpiwqkRS2XSwmgSSCtFG7xSdnnqAjtQ8yIePOPxWKIFPBbQAUgu57AmzWFqz+dRavxigH8zxj3mwdLp/erqhmZFVEkFhGtwvRILhuRbHO50hRvsajd63CBaYQ6GGvl8C4Js8XhSbNFWogDUpRpkUFY124l5YEZdTpZ0nBo6Tk0dp1THqaXj1C6Np2a0XBkecZhBbTccMaDBUxLQaOKxQA08IprV0xlptIJdPCIsmRCgLBELZVJUSdIH1OSmgtxpr+IM2kGeoY6EWWsEdd7KxXVmOGF7Eav7nDhfAqaNjkeM8ajb8VjcdDx8WlS73hvrblhQ5PiwLEo5PCxLRrXZDkudlozmrG6G1KDQ7mKRGNUu68muDdIK4V6ydwvtDvW8PbR7QqpP7BLdGvLe2WaL2ZY54znJH713fzhxO3k15PAydTqt2p/PFpZXGF7hbO2uoojR1LpoFEDXswF1myb7BckeBoUWFr/OFj3BRFJTrrLqwaxeZdXLSh2MUGejgCgNP8Pcieqw8vOWKMnn5DpZBhgmuM7KYZrFkfuBDWYnNtaHnHMOIz5n7Kr0n4jJZvmGjtGQViqWcc++VF+Dgv4BDmaW8s1T6PbLmu1+ZKvmWXBFfHo8bZFfbokt5VSZQQxZbV2EBz3VgI9wRRYHAXALhRuDXf1MPAFvoRCyTjWQpFdkjdguNJaPIJamHq50beUy4Ihqm6Lygt4TrMsE3Y66MIOhR08K9Bw34cFGss1nWl1Dq3DSmat9H7GaswPVgBkhndYYJCpw0836pmc4d0tbSW1K1sB9qt95TBTqrNFM1fU8F96CRN649SDD8RAqEf9HO/pdHSm8zNB2Hadl2noA0nnadgDIAt8wosq+pawRJb8Q1QjO8MvV5cuA315efSuDd5gmkWsSg13qX8WNxO00L+Z8cTtwB9WBaQUtAnhECxaGgAnARB25patO8QBwVNS9Lc/wTFj62s9g5iefEwumgpxIyTRDjdO7eWLMZFFkD6WQslM6mJ9CxM3MxXrVDO3gzwvdL8jmnWaNHrEWZ5wPGdicYtJ2VtK0DdrvPLHTpY1Hm8F/nbKxZj72W6wcL1cvOY9AoK5Xl9sCCG2T3NBtK3TVOr06qSm0A8UpigIJNyMDF33K8AjetWbbHG2AbZW2Q84SXVP40BX+uZcwKAUeBYM0xSz4vvIm9thcM1r1YqXhVEgoZFVk+v6fzvvEk5956K8vxr7Yl01TJiRPd2kAuCMCH7pOWKQqUcDdD//7dcqg8IqOdX4aFFrwx9JrPMUTW8TkMO/qhAfV3wX7ZuB08hW3natvlHs1huDGuoq21uENFp7oevzYCcfoQDvA6QxjeyQUA8kNwfUzh+jKGUq/W5YEn0Wnj8WczXBjfh4USlIKaegqna1ofhYeuVKMLTIdmE7FQNtzcKu9Kpg+xQVxcIGbMZUY2t4Xdf/tmFgdgs+f7XrmUNCZdM5tdA4n+df0imBYPOG2fLf7dKdM+JxRhPK2IVqM+/aCqrJ3QgGoq9P8NsroTLfHohlWsv6+YkcPC8ruIc53Nbvu9GZvo1lCIqNrR/ZjbXoCzSJfZmNm8Q6agSJ2AoGv7KFhKgKBrlf0rN7kLFIipsLFnXfkWaqWpmSFzOsV0MGeHnmyrulcvdXMVE7SqWDnh+NpYEtA70DDSTgfW6GhPeLXc7i9u9B4WUnUEQXLd5C+hbZiWclpVWyk4UGc31/PAX9u7nZDgE/Vpew9hrc4+zz/JnATNzl2gs6aiGuAhjbMhjykRVyARTHlJwsTMfMTMel4DPMjlm95IOwE11rhC/5CeXrlX+US6nohU7q62wp15/jsIsLj8iJWDRiPIgA7r/Mu3zmRrwpem+KrqgGBna5lOd7q63nDrhv3y4G/Em+wQQkeq0XKsSg9E6NhCFWu54LOUSpbwhmTCQtK34MpDyV3sxvFXCkOhRwhh8Chiz8mKwvTGqsc5aiwEX7XFnEflBbhiu/SotvDDcxuL1+EWQYEljl5npY2ZJNzhPHPiPcsSaO9wyEzVg34OBSOW02tM1hAmXUKckltHGTQHOcdFChycVBwtbheKkDLsPvJaDbvQIxizzSahOMRzhDCyha0uCk24mSVqy6plLUr41XKC/NGH8aUhfIt6chAi1av9khpDXcq6YbqXk9tMUCuySUD31UDTa+yBhSWt3Gy9KZeGhh8C/mZIvwK/7qk5JWjyoU18lSsrUtIoOfle8jv3xjAiOHpuEO2x/KHoRueSHUsJJU4a+V4yq0EJu4Ze8164PDI5ZZLgpU+67WGIugPfJVs9u/hwYsna45PVO3Co6p2l/XcTJUlTdeZgHdHkRaZ1wk+VcwLLmKdxWDQBQpXLS0WNAULdE6hDJlTlWVz3zXf+U9vuOp7Pn/xcB2nFJBUzOAhTJoaecMlAL2uIJbL+hyAYke/pmJVy1+jRjSyhVwyKrMWxb31XE76sOPNDoDaN8FYt1iqfaAIWDChxlxEGrk/X0TqAnH8krZkWYb5cFjad8FbUL710zyg+bxLS7LOBXlHB0i/4XJUsUm4uS6/KppqIWPJMy7ZDsdBxfwuLWKfMYPHjLpPCajDKaauOS0Ixdh6yxNlrakSMSjqUsWyflQvpSpUv7I3WfccBwC0ZTxhFkieTHjwlI18BlloSzk2lfdaQe/pSnAwqe739FZeR65idmSwixm1URdTR6okfZcTdEQDngT4BNL2K5kIcl7gHgcsyhqihCMx6Qm8udzrVSaMI7n1PlUXly1YI9Btaip4KJJ77hegsaOzow4sqo9Bpin0iMkp3vTWJiNRVNk9K04uW5zkSQ3ILYvTG0XJZY5jnGwZpCJAVEYQwQVl45pAdmAU4HhXQP4UizArfOw74CRC4HBArTxQgyJamqi62+vjNAf0idGXWCd832O03fDzRd7TR3kXjUWWharoJxZBOc6rGAxHfYFXwAiJmHVFm5fjoxkeoi54ni51IBwxQhO7GYikvlDQdp6CArvNooNSmLTF/O2SJAUojstALTr+uvfoouUqevGldN90EEUgq38md5/z8i82I9IiM1Goqf2pzgjZVgAg8SgFbAKPm9aJS4a2Z6WVoX3/69JrH3z/f/2Li4e4aaio3FL0XhylV4uWXjmiF61DhgyqQ8tCcboYZbxgN7oEtLCOqQVxYBttWRnvOaVs83YvXxenbUsgltUF4hWYUIAipspQgCcUnrqAhhpw0QMPAb7SIKEhehoZOYoQKUXA9Mw7lj02YJjH23x/J97EZlQLs3dRJ6WGjS4M8KQyi2MwMZjFcWUWt8pFXYVx0F7DMmQX5cOh3u1ehhL9HLdbx90szb1KpgQrt/fSosWiAcIPHx/N9sPRD1Z1agKUcKAsQi2dbaDfixCzgMRCJpl3uXeQmCo5srNItqaBlVwqxqMLTma1DJgtAkqL/chASdanVZnVWmump1+bTerwKPaICNxlAwMbQG9J8gQ2jw0MApsn0MbLmRW6KstwRyUD8yoSWBI0yvKu6fm8wQvFMVoiDW2ZWNiUMGyx61oRDceWNkXAeHRRs2YOGZHwBnOkDOlLe/u5EV2BatdAjeYsaV8QY2MgfTWGCJO43aQvd+GFzMsAL5l5OYyXmn0J+GWvzYaXy20BeLmCTNF4udoc76nJKQXYfErYc2PusSituabCXsUhzApMegpEcrBozsubWARpFnH9OiAPoOYZDn33b4hLunwriz6LbbRtmG+n1kZBRMM8V+yYM2fOS4KUxayYm5uvzvN2ZSEDq1TZvetYxbQg47VFJ16Eodi2Psj5vZ8p6voYoxlduWdo/oCIDBnc8+IbOlZJaTxNxwjjvu8jnnHGkXt6v6fahMQFIe6pNBx4ND2fC6raezGpakpBr9ihDE+3ZHGANo6/oe3rxc47hvAeUih9bxN6j7RCHCzGagifXxNsITzaQTvZ8NH4qr+MC4elsjTsd2JGx7SV+/7ql136wo+cctHThqLC7oFSDuFpsBholTkqbA+0tgjewRN+gXqQLHFqXRCIT7Eh51Zvb9caR3aBVMzxXW0SKcLy169Z+1sx80pghtQxAeirSgH0dMWKNRYoAxdhKHVkdCX49qAQysMVJcjelLh0SlxjSlwI411YmTQGqZHd///816PqpCpORlM1Je+P/MjphzxQPVjR01h5JORnfyen0yFMDpKX/bpuI/VdDsh/AzF5VMYF+54s//7y4uxuJOFQyBzm1koBLeyshVMn3BUQVNi9/TE1Fea2dhA7DiHh2CiaFZXqJjO0OO7F4UT2m6gVnw1KG+EMG/au88fwwImmsABkw+4Sz9mr5/6ySf4t/RR22bQz5mNs/COgZwPoOa37qXbOQ+v7B58kBkT6H249Vy0tf/Twqw9xIkGMsP0l5/nfrk0ljoFLt+y37ea8pYA83b9CRbrwtWnF7pE17A4fRNUYrts1N7G3sPZnHztknTwxl4EcSakBWFFDANh26oldf3ATNAz+ESPe/2vciO6zbgKA1j/auqzweqp8INJe+ap/Mz4oY1vSArCnnHXjoEZetGbzt3g9UWSC0r8k9f/iDZUCuBaGnftYgGNz67cKOE3p3/1q97GOvmpEyHBajYh/qodNsZobvsKZsqsbQNQpVCs2AVfwcR0FNeyfQCUYGgOQz+RNc79NzGLD9yhmdltmNvS0oOAVmnsy+nmTdCBE1kZNWB7KXocqOYXfe5LCUxEqYGoqCtcKW1hP1fECNnp2Ye7yK/LD7GPdGjjjjPvZAw41Dshd5ewdKMQ2kyvXC5LitFBPg7RhEO1BLFawrlCqHH2rv/37i+T7CGZwtMUZtV2L88Todurg4kwz6UlhsC5DKKS//WUvsQbEMzVBMKOuOGapuZHPlUd6OFu1a6hOfyxC9pnPy8U3PlGm9ppYWl2YlomagDQUt9gCKD/gU6KX86tE5AuUyDV56zITjcYAXKpnjTtN2QWyP+CVFXzIPjlSlLUSmheWdYEXmnnOvShwpoTmslvg5wv9QwNgnbQLPbSH2zXPD8Iortsnyucc/D1Sk0YzbbVnOvbJSWzKlBuuAk3TUgDVCBmojehZmkchCRptPYvMgKeZoYZm1D3nxMhDgCsZ1KhCKOh8oLSD3GdZ4uBTTBPzOWNHDA/GdXVp2uUHLHXwQ1xc1+WMFLMigTXOiCkx9DQpOLC2MTT2Fi9nWjy3XsxVrGZXLDOW8Yf3kgvybQq/SFDeJT3iJ1/36vG74PTv6HV20EW0Kp5sVZNM1t/VrM6Y3dWBXgJQQ1HHrCtCtW6BOPVB6mW/pxRc9Cnx0x1QVMqWB/LFxj7Ry934LM7j0GeYStoYc3/+3zxv0ugQblWpTC2Uk6z+ob9hiONNL0sZy24+iOPvW30y6Eb8wbi10V8OQ090tsMp9xo8CsxFoY/ykhlln5A+xapT1cW6Aw4tlOML1IhQ13onf4i7o7cI1NNW9klZONSTZHxpkfQghiCIIsTVr1anq+9PS3Wf0g+U+dGvemJNRO1NtvFFnP0hcinwDTcQqn3seKMqDgcN27c7+sH7zvnqmWdeWeX3y1wjBj/zYMSMe0ANaF67zGDn1qG+zVeFHH9OaUXZ8Y6i5VpAzXX1Plg0b8vuQAC31vlzw9j8w8W4J+ZaAEORUNR2wo/vdW3mvqyrcdMWNY8Mtbyha1vKVuUDVUCJxe5FKdYekgfUobrATdfxgbF9g8HEVZB7BKKeQtTdt1As0r/LemvwAlsaKjkalvcuRA/f076a+5wh8ODQ/2YUNYcWXChCQ0T/nYkekHdkWPE1cFB4SsiyjNePu0LzQhDX2ZcMIjv7AlbvYKjiBVgxhsgK7UErpNshbJBFWnthLKZBI9O7coqbg0iLgd7kpXlold9CJElpOVyTcn25309G6xDPiqZscTevF/454I/WAXtNAepAS7gcObRDSdJSAdbz2575hrNqu3J8yDB3wyImo9JnwHk7OM4/wghuYHCH8v7HeGf6uiGnEZnwhLg3LFksudnHhkzT315oN3nLkZhDIJ/pgi+uSpJXeK80gz3wSkIkkkGfd11i5h78KKmFEsaZ7E9Qq8qWCIMODtUXSS88R4I8wXfkp60Jpl2wqkKFOmIrcGEXtifrlVWkluOjm6FKCy99DQqFKTqQ/algbGWb3Jq61Z8R9VWYVMR9I9mtq1ihCQWFWfThEBzqo9yWCg1VrDUv7LF6Vm/li9LCfGl6HZVGVHZjas8e4iBjD0+NDcntXd5sQfqFZQqVWg3MfLnSoS0uuGJ9/Pbw4ap82LMfrtAKK++l0DgY3JEv406jbugaSOePBZywZXSAgYmbbznYu5HquTYUwAVtJW+DP6lt5NuE5q6OyEmWQWVd3dxe2oqvtvODxTJE81zFQs7AziNVkdDj5y0671aGXEnN3HPYNhy8d48v1oHXpG7awmUc0ThwwZ695x9BWBgZqcvWAbhk2j7IoZBJg7wNFfU1YdtmsXvX+9rldR1ctLikWHFEGhGXF9tcxEuKJdXvXKFteo15Ei0w6YfFFq2UH209CW/qDbmFfNWuG1/Jt8jd9zynmXKWXVl4rLsjOQv2afDN1+QFp669/6U/0g2rfm/J67334fl8h8FV4DxwVVA2ULzcWakosHaECuPMcBcy9mgn5fy9aNpBxXVWeNAd+SnQ789rUwSnp+an0an5LpqFBecD+LZYkC1oTyXqPYCXY6Z8uos/5ULFIRyEZh0YXdABfLjBt/k/6z18nziDowBDeRpFml5JPM2a5p0XJpNbcjrwXaQxBawHTvNBB0+H0PXZpMLT6VSqTdTEcdoMU2GkFfrcrF0Pf8YrzuCvTkfgTP5habB4tj2DzuRv+e1qzcgvxWnIiMAuzXiFTcLL5Xr/eLLVSv7IE99+xWn8KZ328Oc8OoV/8lOMFQO7TBhefvVS1eTF+NEqYPHs034yqf7lZyANE3McA4rY4MCefE5RYXHa50aivigi72KW6ooBSe4dH10sfiSCH5vjBnFJXwv8SP7N8eNMix9nVfDjTDrrEeLH1MOL0zgFlj7w3A0MUmyRqeVD7oFr+XxdVERIQCCUMfhI9Y+rrQlq7aJTUO/neMI+9Wf2XFb9K05FX/nTV31r9a84HW17EAg50TTpuy2R8D2Z3PiVLhkrPPY6uvqikCOCvTx8eO4WfBFCuwu4+DxYWhJEgxE2NfzyWSDCabIg2PfTUp5/LJhFRgwUcQZUqeN1hj16WEV91pqIT6egSZi6/Mz46fHn/dY1Re0lZ/jQCBTTOvLyPuVa6ez3QZsHR3jLrPi2ZbQfOdxm5KrmJrOsmxs3kVF1tdfunXAVyZetNEHv96RqeRATPxvIDg2HsiSLvs+TduwWkN8flJ42cIWiWepkPsibypmh+CjZGOz77vqHr39TzN6kqO3uw2El3VjHGYoTjA6H1Cp1V6g2knwUyYNBuSsfAECDwZHCMSekQd3/pH/te+GUi9l6B2sdunZGtF1xFy2Ll+2ed3Ytwm4CllAirN4sk+EMVm9lNF1SMSiPoAIIsDsw6PF2ZNaZHlEt+wl9VRsrkQq71GCWWuJM2PcuQVbLReK4x1gMC/UTX0V4LCkkuTUv2RAXyk4Wj1DtDPvqLtrDd3CzBOEDDIP+EZpHvpqvRHbYBjI2vcV4Dfe3evs6fW3E+3hVFqxsyfzSZrKzmFwEVTcb67iEdQesAgTOnkselpPHWwM0ZdsGOIu0G2/DI85BWoSEv7AJZem6pVLiaXdzPvluN6cvupvTF93NyYvbzfmyDYvVJ41tmOy0xJNurM3DnWQ8ElwNcVW7JTTWYqiO3ZxnFUw9aZXZzfmYktz5ZLSOmLgWU7YcwNcItXAgHKvDl92c3l1SIMpuzpeWCgyxm9Nv7G4uxm4OiRUtB8hP9p8ZAKgMaaVKR4rQgdwFmUCZ0fK1IttQWYxdmdVBcmUquChEKenoWOmnh18DrA7Ll6t6RniBcXE7UNmA3zEcpn/o8ZQftYNGNVVS8LO/13Pf/oIx/x5qDC4FKqwk0rCvqCLAI0Ja/7pSJydCqVolpvYaLuR4a84NvHXK7VUy8B+2EIHqtDg3PKGVZBLH6xk3D7lKMkV8VvBqC2icwGH7z71+0jzU8b/4+SlfvEJvWdr7nuqfznc3K5+6t5OWE1nbu+/vPnf0gh2/deHefb+y8ab4gaU9NnD+XrvzC5/Vwznes3oD8XsRln4vyil/wd5B+l987PcnrA9bz66KtTqoKCO7SykkbEv5anz8t8VsUVCx1oujrEH6bi8IVH95k3PMQMc99yf0zhCMK2eXdXsuWR87l9Szy6l59PA+j9QHBs6Tjd0XCtRtQvZnkB6MnWT+V747DLzE/PUVlG3tbsXbo1xw8/EV+LNDnzWzK/vbG6XAUlsR+A9qokWved4009ZiLoYfUOe1Jq0hkRPBiZBElbIipFLWPmoNIV5lZuE+EYGgHKpY5KgHdVEUp1pVGBr4tk9COE8kFg2qYtFoRCwaQVI1IhYNsaZgVI4UTuWf6iNi0cS1hWIrFo2tWLQORaFRsejokkX1qj+o70W6E4yG67jKkFA8RSxaZ7FoBFyJRAoi+PMCZQ3UcBJuQ1aLyht9T7ThvcKbBODXAHA4imei7ACXjAAurcChbgFXt4BLcNfjuIBLhlK2A1yDAoArpfoUcCUOXAATeRDlYFfYJAstH3eROMFLjY30ookjsTEgQlWUiTDsjDb/o4JRbFYAkIXfA2nndw4AYPYaLHBQeIETUYifehwpxDsDnP9szjfmQZUV9Jy43rKFVaYQXtsGjyfTB1Ysmsb0hYbRUScu6lBrGtMXajEUKdOnF6anMX3BONMnVpFN2VcWIZg+1MKBYCrTp+xnHkxh+oJJpi/MqwyWddwyyWUFI1xWcCLMuPNxxIz/GfhYtauHj9N12cDcSI89o8mICjUUwZ0Vg/abVUNYeC/r8We1H/bFAvLzewcY89O7PD+sciDME3rO+EXonPXq8Yiu3YUYPofBPDVDXG6RNm9raNoaGv7BN6E62hqirTU8ZERRlBjYU73Y6AA2izHVn99j2QtsswaTloKtcefss4em7D+dio3b4EZugxtNbnBduqSiSY+oCvSGW43sf4XsiomMGdn9+grwRuS7TW6Eo+0/UU9qdmcbab6g3NmCc4aczuxsI93ZRsY9R0jBlJ2tz626V8oNhI5LdtBGrn50Z1sxRPxJ4MXmSnBOroIl3ShW5dGkblxcPY2pu2ByXN048aKYGP7y+PpzIoSsD+5QqNgTlyHF6t5vjMF8Ds9k4w7POMdTtzuqMjZ8/agHPMhvJdF3voKqXvBa8hl0s6A2iD2YYjr5gM9NgE8JKD5a6zfYZLBaJfbRTvWURiHwwheiDh0mvfs37UhWvq0pAUV3tQxU+QjK6aTZvWPefv5c37fWrB4ZY+lfIK6qerWqff0UsIMp6pc+ic5hb8KxBhB6uJ1+0Wcz6sr2e4KY+An56BAIInvLwAmVgIwQ+Eq0cj38OivKSvynMwWXVSscYwQeiEO6L82DSl0yE+pSVyhFyxlY3dQVIl+EupTDwnyJptaFuVKTsx+sRFqlsl2YRKad4gzoUiWNymiNtCXETyxtqaNqRY1Y2wJFGAyZRKdoB9VBYKe1htfBQsBCHECtk7zLspxB6ypa0TFIf8Pzok3MqisFUrqkd1R1cOpCiTbV6cQoJOQDw7K/RkXqHx+l8SPK/kYRR4tHSaplEskrSBTTSfQWI9VXr1uBkqTyQqaZmSP06BVTzMPjOpu6cCmi/kf/kVEZdUX4ODSItkkn1Gy6OgPIPm9VWShyBuarde81RANEIPucANcjqYsfFaGiil3wCI33Gulgkr7fK21itQzJ76R2nyubWahF6u0kH8/vKcK2Rz6WxQgP+GqLVLyukweEQHDMkOf9FfeJ0X6GIoiQEL2+10kDkWLrXHuWcCDyps9nXQOEgukF5dN046wfA93TF2rjPbHlj4dUjLBCuTCe/8PzbAtCMotRiBQflSeyGIHJV0m7AnkESuk3M5z7mRlRBmjFnZnWhAIkpM6orDekQKL6hiyH6Q+36iz6eIVKZkPHTA28EXYh+1F1wqR+lUVypSochS8CYTT8ANTTkCC6HLmv2HWWqMRHWEZ2aswqsoMFnOb6HN6AzlVNmTyR/MHzMN+hIc3PhJ+XqJUgHFsGihiygssskoWefT4bvyIhjqRUzVSSleZkua8WZi8HhURRslSJ0yoxDRDJxSQ8VnM/BVyRJ0IeU+QX0UXJoB44z/N3ybR1Ctfwoi5VaWuvVaXml7qzDV/PNlKn5K12UXMZK2mDaNqqfi/otxKOwKpmiPKTj368PEdXDZrX2PPTd5GgxPP4AZ0WfbscdnVqaxYs0GvL/kEdWQWQuQWqeCsF4uelchE+TsVrLtTTYHAH32UPYplTx9EBzUilypv5IIyoy3lN1JKNtVytWJsxk33JKOs1RqtE1xcOZP+CShR4z+a6ESlrIO4uQqus5a7hDyllm73uiCjvaKqCNc9gbDu1HKsOS4Dqni2IkPJlQo9CNzKBjAxG+8WF2Ae+ILiFM3DFsH3grWX/aIxdc8IhT0s46GkarDJxjn/SHGfyh3kTz8Ne3nI1oAmmEtDQA7xz2WBzF3rhupij1m3DvEVNmBdoKnPLSiFOQKAmDC6v2r4Fq4p69lIr+2dULtf4RaEfzdzND3jZ2AP37AifHuyC0FRCu8Vgkg7LeT66am1v34wwkyyGTyyak+CPLBQeRDVTrOPVbPeK4OqeaBNtrOdzFfDyq/bKr4pFmor+1Fw/4sZOrTR0cIFWSSo0X2fNTOFU9JLBNXzvHrSxYVr2ZYW+DLEIrxmFdEotXKpaNjp12zrL5pVq3IetBGK6wGNtoGK1asjw/NCpp7Zd3Bmkz+MoU7PBa0S4MaQASKODKbhV03ZZO8fUQvunpqmsXRpR+NJWamMGtWnezCCKoY2M3up3/2L6Glfi/tXEzeikB8FSL79mkF30mzW6ckYbpYtMSByLUMv+GPHptmmxYCrUHuVubPsnRfPY1+GoPXvg0JiX4V/xRrgU5z/Rw0Cok0N7CUkp/POKQK1jBiBwgTt/1uQ9leSLJpPPqiTvriZLlatr1kmvQko5lJbqJyuQfNd2LqfS9Q+Ah584Q3a+kSB0zOWEVS+6BLpbrRk6fnZN2XtA59o1iHj0w4BCvIf2EhFSi3ouIjr3nbqeDUXts++ra2M9j9LtFScGlwC91fumfV7aM94h/VHvkF7bc94hbSmpcictfnjKlwRwdCISNvGmSEF2A7aDeQ37Qwaduots+antQw1IbF0djdrk/mQ44lMyqrDdoVy1RkC9iMS6wtWxSnyLSajD10zCEUXj2YgSZi5RT0RwaGddduVNdW9nnHU1KbYetlOwchIj7L1+KiKMGGjYQCN8sO0U4v5IurZfxcIcle4vjN35WJ2Dxbb4sbL5oTm14JQLthxZDCcJnnVRmQj80AW8A4L1SsXaCYwqqua052onA2mM1mm1gFE1slxa6YzRcYRJBNTZ1DpD41jFk4pjRKIvRq09BbSxYa5bT6+CgpSq+iu6RfxX+neNS/+uHum3Fce/dR1G0x85uIidsxxh3l37X87t58ajfJFBABTZawXRPKobN63qvNDSG+ef9Y4oENswkzNTt0zZcV1z+sKa4xGKDXE9AAY26aUSNSsXOI9Q6j3a16ka6Ic+Xw+6sBbilXx316gBAho4p8ZgO3V2xdQQP9ymu0H2kF7ucCrR4uLbVxPvMQaLXXw/7ERsLU5pHWDIFtKAWPvBX3XhGLyp7rtDMRnPjnVKF0w+RqWBVNycndFrPrzaa39j0gI6Umn/Zz/5M59kf1HoVsOktLD3b6D5aFD/Z5CDWn1+nMFo0FG6+hXh9lq6A0mq9ehmB+DAAqttToBdL3yRaK40rAegBk7NSleuYpmGBJptKbOIEUZnxJZ3YJy8tihRiDcEynhL9IGV+KsGi9qEr1XUAPgpmKaCUWcU5LuqeuO3+D07+HrBOyvW08segB7kmtcjsUr3xJeuM2R/Xe6roEHk7LcWYZnwPVgY2IfUM75q/9VusOF//mrtO0sW6sHrRBdHD7whyXGXsLkMLDkfOJkyuLW5OPeO3OcVNg3bOqkHFYwWaM3wfbX2/2vXRj+nsPyOgfGzymhYJi7kqB80UUc0yhehsJp/gmnA9LW+519r4ePfOh060xtSs+8PfbV2flliRwGl7spGmhpsDqbNC0Mpx4HG6FhgfddzJHyKMkz/AwMS03EDqMBABXD40YCvL0f2CGK3o2nBiFXEXXh3VhHJ2vjXS5VgD/TaSd3esQ36BMXGM3XXndfVM51jcevM4kbM1Ta0LXkTvAA1tL1FOsSCpbeRa9BWb3FOrC8anw6HRxB/CWcsmkdw7BPAehuHEg1B9IrQbRLZpZRa4zqJtapOYvUiRQP9wG7fRH37UQrUxB48Jan3Co2/0pxZwfRYHatjXQ2egjSIGj8wUfcOkcpOAa7CrKD1PLJGdTL9yt25e289sWZ7+SSA/8qbKPfWnBwlFGmGM1h58Ci/MycO2Hu4kKfMuErbfPtKoZ5G6h4Od/X4ZzdDzLx38bOH3/foWaLdZHPrbBEM+lx3h9ZS+CWjZjP3biL7220PbKzPNvCzsVPDE+A3+S8VpraJwYZv3hbvWNSrIIpG/7RplT5qC8tuomPqYIPyGelW3sFjV55VC/DHC3BFSm75UmEhZUm5BlYZdRi5uOdwHMGhvcbBLaGp6m9GFxW9oJdSqDVozW3mt3tm1hKJI0Es3MwNiZC3pd5zqanMwmxFO4iavCbncy5mBrt0Lk7K/GYpYJb46wQr8CwMkrYANop0SZ+D5BEViO3WjlCHkBrUGRYdObKgjljSs8o8ChuBmoFNLHer9es8UyDHFpsyBgXRDBdnIT5jEQvw2kUtcAItY/NL8UCHec068VIB8rwuwgsIt2Q1K7O1Cnus0MKGBFG8wfgmtY6IRQH1vjdfTGHR9CziIkJqgXdEkeCuVPO6Lr+LmKopWpMqcrqhMDXasXgWGufGStsKcZqdtzc+zk78WUN7j6ptVV34v/r10134n9iBxBtO5AXibM8b/bSmn9aMHhxy18rcr32cu+scePezaodfd4IO/1AwonXtjziQ90xrtFOhcLzRc4SDMd3XuPAyExfx64E+DzpUGFpX8xsHdVFzJ5EB6fmJjxPcTzGH6vEZFcT+YF05ERmYdf0kUihUFpZ510g3L4fQoSIEbIKTrTPUOtFew+mH2qWA5SP9l76IC1gTPk2+i5BbWFsdAvE9i122+UquwkVGvK83mbEX14cT/WevR0tX1I9uJGegSENdikxpRY7Bm6U3KtP6Akaj4+6HPFA15d9qeqvey35EgQK3vFoLmHU0DS8+Xgo00Z7y2LMh3cp7ZpwBi+7VjNGAVInJisSgfg7XqXIK+1U9Zz29ImWRCWO9zf4PHtX+07+v72U3S6fTm32vMSmfwteqLg/8NGMDMYqs/rLdBarrgqDbJOIcAa52wsAZ/5ltL+zZPaTbXrHyDvHSHaiiSEgE4LElDeQqi7iy/aZcla+rPCCi0GxycFwvKGQF6VWNfN3PeMCKRB8hHpKWffx1IthX37ASVR3230FqLX1D7PM12lc5brIifNGp3n/V2owPl//l5XXZ8Wr9aEbLF95XZVs6c0ekU6TkS1te05ZrGdrcQMuoxtlMNRYLPINefz5e5H6l2XXIfGLxD556+V4bBDGYdQEGYMXWHT1adV61FNteMVyiC1WMshpjLW+UX4lAJNAIpe4pxa4StB8luFpwQs0UJjUKKx7Bwx7/2LZqEzkysBfmAniebwIPHEDRO2rq1bgihQAwmZAa8ifoBZoj3c1bOCSGW5G8gWaJd2F82hLjmgmLVUbK0Na31iCoS+QUgeFetLGJiKitNldkoy2CFiPoa5UgrAMuTUZjtFslUxNNTBV+HiCTSH8YEgJWK+z0xeqjNZUUKHQaOQAVjJSFnnFDa9WGkjY0MTQgxuGsbSh6hHOLFqWUZDciTkX8HhIsA09eegzy6E08qHc2c6Bu3YKrKAAfqrQ2GnOdHo65To+cW3b+VAsOMEa+fK0O04U6+IYsIMKSBZ3kzlf6a14/1Vf6EdA86407gKguFPqIUAT20nnjjs08iAgTS+3f153za8YbHjjVceQXz7SzAQKFt6bB6qZOkLoCRIW9+rEQNQLBE4/bofW4DQH0fiAo6lQtH9NhoKrzuJ2OVFqfUmliKl2ruPlGpfsL6RQQZsyrdrCW/jQYIr2+H5itDkYtLN1z+AbmugSEdvQ9TUVmkGe8Cc9kqLq/XzWbUAzYeL+ysEdAnerCLrYmlKBGxiiKFGlr8pEWQFxUP7kVDN7WQ7eCeZUVzKusYcH4GgYUfMCIbkOV2d0EzBLNFCxhJbsXCcOHVkao11Uec8Ha90D7Hhu5tq5xcligUjkNJTCWot9CkVThEFGsSgYB8skjxEPSsje93i1s9YmF7QcfAz9zeIKfaVX5mdYEP7O75GfC7Ifx8Yn4l++cduRVYXlVswhrPaxhuvMnFR7a0xOt3/Fxo3zRo+7+D010P3yp6z5exrr/1GnsHGud7n8UnFwhYFB85QUxu/7VEi2NUCUXzaK8ezWLDJNmOT58k5OGryKeg+8j3GVpQ1VOPtrQrm3ou2M3malku+BxieemnPVdLlf/+lcw3eXH1SIEVyLttkky05szcRyL3S0siR6v7jprPO6jThx8Xng6s2qqraPaiF0JhRxagH2+NYp0if9Rhgf3MEKyzvmgZqmWIoAe2IBinR4gTkOIa0WKUtma1Et+9mO6IwnLeO5ymfgWJLaC0TRmRcsMtyCDMpnN/rIe+lm2QvfIt7oi8Hqb+yDuY0QNg4GHZHirtkeWy6beUVe2ETVcD9QiOSwom64tCwDFJiXVaEJ0JqdsLhqi0dS9jsIwKGEYGBgGFoYaQpzymrVKE1LT66LZllEsR7lWjnKN24cxnja4Ou6TY9xWe6N5DGJg4Hc7EoRfAz5p3I8jDsZJ96tWlF55i4QpUwjHnOttyKWHNQAKo6+NFB4i92BML2DA44ljSwyTfgsWUrdq8m0u1Emb4KQG38trtVG4xyS0J3QagukDZWCeqyqDsiafXdM8CEkeFBwglxrFU6uRvj4vBVMfpL8Z+nW2J2QthFblt6oHFppL2Kpf5ckuQJWsAHmsaM9GGPF8xnSJ6mDt09PNhp6/Nc3x9p9VxLUfrblRCamhpTer2lsUadGxlupxqXA0tFk5cqAL3MuFUSxXb59SPFGeVoLWu86Z9lea3veOX0nNVFKrSIQ8VKKofNKd2RwkwBdXy0RX0EDUdJyGnHwrjt/b2vFAmqo5UoMujfQB3/eBSs5HazRyAyN0RCKQSbsHIZm05yIETRXVMcW6fJaEFdt2qQ7lTrmQcbH4ysPPTtdObV1ex+Rycjqq44kJoJXFWpOvNXmio6noHWiFurVBhZvV42k9o/Ao6wm0nlDr8bSemtaD6aK1YLIcr46a1jE2sHWFeeT8zKZ/HijE3eFLXIU4aKyuOcapKoYdIVS/j2K0U3yvmAl+kYRDmdR7EOZuCH37XdGfPCq/57qGKqjlfl5oG4q5hCf2OFpdXesKtC4foIntKKNKHeUIVW5ek681jQ5vWVOoNUVak681eVqTDq/WpMN7/Jo8rWl0gMuaAgNCrcnTmmpakw4w6sEAH7+WmtYyNsSJDnFckdl/orIR2j1F3aqmt6wQ1htdMqV0kasTV6G3s6waRqL6BxJakLUUoUTQESG0e6eqCxD2NZyJAn5QddSpUa7xdWx/7B2TRAyn2v6oMjqagIUvoEjriKUCAJJQj6ztqwjJ2t6V0NWyjof8zGE88Alr0gK0plw0UqlSbOimlKgKtUKvjsg6NRi6DQWOcrrVE8xf8r3oZKFaQzMiBW6swK0boIZGt6UEaq0Eaq0Eaq0Eau24QA1LoEYqKeJ0aUgF4WMtsj4CQ61qtayqq1UtaMtrmwMQUQ5wwinh4BT37TYD3E/gRN6rmFgOx0BX4dWjvq+6eK+CxQdR2xIGkOLsDrTBuj65Tmvx8lgFUgp0SDSkQ5iL+FjXLcJDYYuQwrZ0NytqLrqOoyVy0U7PUx2kY5l6DUxTC1lwn+YZQHlf25cqZxeTb43VaY90h+KjRSW3SyrH1AKyAT4v6qKTpwfaljuoV6kKtJHpfBvapZxyXbhJDLKCMTuibfGlUjThW/K6mAqCJx+VOYnavhPv+em7o2n4TUHZXoQDQ4O7Eg5fAhq8oGiV8QObK0U33VztREimpnZW0Uo3C+SYOdWkEqIQF3B9CqExDisDMnWNVoMxRW8NZvevRVU6ieOpdTxT+oyS1ays6kNsUnpdpqaWvGA6oRBGtZsWL5JdiJKqJZ8ceApvs5InC66b0cgQafZK9cp+Mzg96CJOQhnHPd4dfZy7h8YblXNgMrIrCXWrXEqeozkVykL19Poq0o7sQ0qkDXWFCxlbdYXDJARvhMWnK7QvNCvbgoQyDmXC+Cq9KHGrzm+hkBN0RZUIql2RQtWjPD7gXkhVvoClK6GXmlp89NOfqOd4FTxTT0HEjzRUTB/XkgF+X0su6vwuC6qo9UsXEot0yKFIp6GaIUWKdBoySBfSZuAtkkfUPMW5x7W3aDyQznQzLRcRPBzaQZat/bPYBxSFwqqjnOmXwiDg5c2ZUa45M8oeWJ1JkdRMHEUqkCpnTVLOmtDOmkg5Bbh7x0O3PxLS7U8A5wwB5kPZM11c9BQyqgijYzxb4SaCp+A4gif/RIInbyRDEZXFSt6iXmEz9YgWxySqFaX0THtZl+4lEgoNFCLteVT2PEIS9hfT+i6llLO+UWUyzX6J1qp8Zv8KPQyMlNX0tYpEIEuBrRoYfBZCgsG7JJSBtpWsJjZkaAfaNMZqcqzejHfUSxWq+oms8zIUz1JlUvCd0LrLI6XBIciNclNAo1QNYlv6lv586CWThA/8hPIbvnJQBdeN10DuHve9l0Ch0fo98r9VBCloCGTX6oxfWXtljHQkJEtss5DJopPNcv8xmBbwqGFlpvVw9OnKj7X8uCw/rpQfaJYpXBoW+8my9exklMg3lMg3deC1yLL2tDId6pcw+ayLXgtAotapYANKQXIS/XVNTixdU4YaIctQx5b+EH4WSqjEaaWKQKsIyiqCsoqGFthUoheiojqsb+T1qQUrk5M6YpVWydSfeQ5hqKRQiif+i/JQ9VkpcogCGiJNBMZjWXOYIyhWV/sPdpZ0y1myoPMok4hdckKC0E6d4DIRsbcMBWuC/vaSLQhNT4om/OJBl50DCeZSUo5ekmME9ZA0cLZOkvTt/jRWQIcWzdUhM7PCgr5Wgj5BqERIy8qEJSsTOlZmAhsB+kmeI1Z0rFu7KoXrRAShIBoEnlwbdAJciBUX6hVcSHJvKh6oi8ZN0KCvBzV6kAQZr9V0oZpaqPCdYo7njvFVOCQXqw/hRNjd+VdLOnqD257N6+1AKzUWcy7oDNbr7CdVYU8/Rg4t3ZdXVMhnwnIdpLyE3UnlRS+RVy70pxfjhvfna+aKd9C/1969C5AhFGsf0qbsTj3/Hz3+H72J/1Ovf8Q38f/Pu8t+R+g3YCVqQsHRjXLffxmPp95QukZ6zK9iPTf7fVwOzv4Av1BA4QmtJ7v3SAxy7h6JgdTyopEYT8fueZscvV4iHi71A3Uhq1K/akxdXqBLpFdRsnc678dhkRi9BFRVV2WISJEyxEO/A+cBulq11zlwN2qLVJxDU3oHnh41NJ9JlThMb07gByowGww8Qus3FaNqHQ0pLjREhaCu53JwUgX4wFKDs9TqbhM0cGF2g5ti78jWZPLcYR3T6bUCbadGW0vNtjLvpdbUdV1QrXRWF5f3ODWmajBKb7beO+1m60QsZp6e587oCXn2Dj2J+6Tn+dNuumqvRYEDubV2DzAYj9XRvEh1g2oqnPXdfVRN3l1JPncyeWcleVc1WarsTmtHy0V+WSOrt5FQmOvzL52RzonNNXD+4SsC/mtdF7zCdrwIhDU86O/v772mXGxVvaU/5vCuSIwvMaQ2EdVCIvejXzu7dv87bzhUEyW0vjjeu1fep86f8JimwdCUfMajD+vxLUXRtjpz7CcvyWfUW0YtwIouX/EcU4upHNECI9Y1dtFidluAFiNrkVHrJfksSYPncPNEvoWfKtFr38gXpQ6Ikj05olQvlm2k4zxj9iW41hiJgc0Pw8AmEi4iiRjSIrwo84cRocPilbUm3pSX1HXsAtMm9SU9T5mYiJoHZx0e9PIuzaFDW/jBHV6hBUgPe1zAamCU7sQfCR7dovbNUy3Mb8230VY4vshJxG6gMB0s44lQYnisXuUHeKOcIlUTyyOkfnte4HFJvmNKscRFEhdN+VYBxor4GKNClSWWKD9Ac1cDLLNrxm9YvpN2kL6BxdW4U6QbS6p4uZ12whcZt5VOQWArGkwaSbRNI7elRjOTK92CflS8bgRw78EuxoqdtJ3zEnEYZuo5ATFfQMwDiCHNyi+FJtismWTVjzVrjQJ41uQIflKPJ9NDCPYYatd9XxHz+4N4XyAEv8RBEcfU1A02PImr8qc4uo2oS7FYvt/JvWrdcPdvvmj3f7/vYvtkgFhI7/km+0QbTymjf9U+pemI3gvjCh+yTxTBTZWUK1ae/55jH7BPl/J9VwfnvGHL+vvsU1MK0n/8xgV/kXPqf/ji2k/+7n+98I8+8zT7lIZ+7vYz3/DZz/zXD9onwIX4V37lXd/5l1t/4+n2aeM/+fwPbxl4Z3zIPm38Tz6Yzc7OXn+xfdr4S78D/37tQ/ap8dpS9E+Xrg/ZJ9ImfOdJj2m8O5/Yc+iDf/0vd37APuXTj77rPR9429/lT7dP24x3ftvtB5/7qjd/0D5t/OHF3+Zu/MvT7dPG/3//6cNLBz78nz9knzb+2dKNn7jYPl13thOPr2cmllfO24e/dXLa8ch8yiu2PfxtxamTifDmAFTm0nwTZZ+c/VsJ3z78bagUkifgIk9hQmFEpxHJp7T14d/xaDy30c6IjfKyuQe3ipV51boN7yBHh7K+zxn5EWOhdsQ0Vkkc+OFdeGTF6WJ4CfM4P0Pc9UA790xdL87Ch5+WD89W2ovSexTg0eavZvAl9+Ls/AyKOc8urC3nGB1w1RI6C3T1CdiSzLARuHw3nU0z9IQD2I0zje3glSdlMc9xa3nGr3H/YMDBFk/fJ3LBT6Iz8ifTmflysNesFG2421/mn0J9IYI49BAHZrKM0aMStc1tHDjDcwl18oKyfAe1mJ4/iYn5k0HF+6/KcyoYCDvyiLbkS7SSz9Kq1AaZmzqF3EmzZfgUWirDRFEZZsJCswgxOtXkuRW4tY0ieTmVluR5GiLPtV4V9Tz2FKGwxVOoS4TAeWUyza8VczaP0tVT6TQEQIq5UKxTGRfK84upNhKAUl0OTKInvpDyu/LZYY9biAmgdc1x7SiHK0A0SpBo14Sn0HmoQL8m+Zi20bmI2yZxA25RtUROlUxdOnV6iTvpFO0Uvt7NfZJuEOJI4u7i6kZKJEIm/rDrSnTen+TQcAmPJZrFY9bOmxwChlznBBXCSxS0Q547aIs8t9CKPFdoVZ6r1mfIjJlfNC/zC4+MWni06El4PImeTLvXGFeX+/xYpifiuyfSE75ZRetGSHtO/5V8pcOr+Wk5M/z/qDPjGzPjGzMjSDERghfn5+NxKZYJYDmXcAaHEnFK1UIYU6GDss7mms4/gOJ4RkjoiYy+e3hCPIEnxO5HPyFofEI8Ic95MhQ8EXbwhNhCT+S+7zaTYo7yPJ4yMebBhm8yMaLKxJhX5puxJTKTYrYyKeyAzhs0IFJ8NvE6xSxyA7MFoX/m2c+7/wfe+7mL7bPYDi5yK3+vbIrIGOyzOJcTBbu0ZOChoKvGdifnB5GgI6HUcoqRnSuILZsHRkbnCqIdHmpvtjqkpoK05lOkRJ0mo0hd47lNk0itiHtc3J7HY57mgNtzBrdzwd38UeL4E7BnewK1KANWPhlvT2Ycz4CXT8TbE2k33nYzqhNQfQ8+30PnyyIAVIc89kngi4DceVbB7BXB7Ccd4FoZ+1qMzwt0BhdxpnjuU7SkLYy0SU54gqZyxh20wH1cwf6Ru7WcF0BPdJ6BM8eQyRksRb4EVrOClnGVXlNsUDBSFHRY5qhvZQCpJKU6dJb0VseMo5GKbePJjhlGadaM0jygL0OH59zkqAGsO+yoLADyC7RCmYwc3pgfxtsyj2uGYW3hAyZH8gF8sNE5Ly74B1vuV62pB/Ez6RyaOZDPYN/IkI9pF9jsXXQ6PqIzSib6WbmRXRQdahjf4wiFHGohJFZznsTP6KVwRM7jy1jSxGrfQxiiBxxgtg6YAovlfKHqqnyHdZXHrvq4t5wEd4pznFzQvOxgVWyAEpmQYUdrh5VqwiMUOUfs5bFFBD6oyTvpSOdyfoQYGXM8t+oqVTNrcS5PWUixfom3ugDDrhslJUf4SB3UBdS1SzSWX9ATTcIZLGiKbOF32yLsDp9zu81912ARZvumyzOohPjHC7A26sck4zWnQiScYAs4wppjIATTXBQtKRIS9lAH9f6oRbR54Mk89ayCVYphWMYwtEWy1uGhyDhfK895SSh4vu3g5WGLihrEYzitcP286k2zzNh7eIE7uANZVgXCJJIdimUt0vV9FS3WpUGkP2oWpljkTy3hZbkMtYkr5RJtSdvkWxnLU2nxNs59mskN6Nv9Y0RzIMBdQlWYyHYrzyWeqvwKPlNQVz/LzSq02ci4nAVyngsCUUbO06xMZjx4LuORU4HHCP29DhPVWh9T89nGbulKX2b2Ah5Mi5lIcJYZbHFnKJYLjeYAapgkbRacRmJSFwLTwB5HPNDdPyIpLXCuZST35LMMSU7KYrXkr0awE/LVFa8aJdH7tg2VqjYhpNTbxSIAVBsCNWSmBDSBB6eutg8g8axZblsRSupuUQPC9gNMJSA+TTHzQ/IhnJzBA8yUv5FnMGdCqUz/ObSRAQPgXNbj0FGlyWxOcB5l0yyLDS8tFrgKbuDufBGPndZED+RgGax4hJCSUkMOqXkUIB40KLdESxjMlrUwY59mmlqjnJMSHnX1u0hmUVmaloN8mSTLtARMWxYJQS/nV4ngJaAm3cOIo6nJGnErl1EvXmvuFQ2H8se8dePYReemSGKWDK3A83Lz3Gueu/VcuEuZ2kETL8eAHNQpugKJdtJopq32TMc+GT8lXtRrorhunyDnsiD35EJIO19UaMPaL6C9ulZsBf3hPi7mNR0NVeuol/45iftvxLEG2qLlkVsFTOcPHJDhEmtS4jLxl5J7Ky3JCCNRCuwBzCsoTMC9RemB5F3ETFpUO3YNwFEZ+C4jxNpGse22fDs6YhvZoJnv425IqVWn1tT3XG9MK4gCsWHPSPUSWMTJScZZDiY4AE1R9EIt5bnpQl38FhA+b6MZalzTIxpSzdrU0Yaqf00Ib3kJRmPhr1ZVrtr9g3IIMSdkhCkNyErB8+ZSi05de0j9Wzxox3EXMekXIqr6hYhdsK5+IY7v82FzvxDONxl5chE4VrdjpSOuZO/QhLrseH1QRJM+Iv4cffGunXLpEqc7D46e7vifdyc4miTeJb6khzk1nDQE2vtQfbInfXxhT9eDy2BbQw/33qmuF8grVzlwR5I7+wW9iovBu9sroqqVZP5EXRpTNMRNuNuGlc/GzaNo5enfJkF2ncdnYJVrPGG1l4d+brSXD7leapL08kYEU/3iztEvggHeNzn1Oow0KU0/S80tc/JwZxetKMdoODDBXXsHDwXwdULxpb2iDsaWdc6vgWk3UDjwjHmz78n60VJ9InOMjNZk1Oq3IAVC1cK8+FibRNNQAY9zZknMI1WV2Pf9N1+89ldP+C2Cfyxc7/OspVGedtSUdSgVeWxAUdXwGDTs+gIwmGl8SfYlNdWOUTmIChCQ5CIWc1Bx9g7QSlSBiR+X6STG4bB0tkSo3RLfHut28I/agDqV6MlBdwtEqGVPuBvG6aLSdI8TUks3UnUoUHqvIbk4z6BtK0rRmi7LST6Dx4KcKWZUz2fBUUMWjgUPIAaR09AcZVw8A9qCcn6aDbZiQVaMkPDcbZ5knrjR+fJrmIzOqoNJPVMUhepsv0ZxW+eI/7itCfxvgBda5BN8IYa+HGCKeX74TaMYC3FLF9AFGW5rKpDsGrEAMAnVTIVqam63ZNg9lR6zKtNBNUFASp6j+i2oJZLvsT8KKBMGpEkQHy3h79LefnDCFHFTtVM4qEB7KC2XgQVHB72+VzZUIaM2N+LqMuCJbyKRXXKA+9xSfqhGYnatQaldD5bRgTke/yUp0RPPqhSJixjnocvwibqvk441tU9QEiWPyYuuHdZUmVk7ZnFNYZYyxGXUrpjFV5ICkxS+U7YdMYwtR/16t0reduvbWdaAF0ddpGgYaEomlrsugpIVQqf7O5mmaohtvnfL1D1liKChc6m44FJC+4ugiqrBdJFaHThaNvVNj6c5MQjEOOxlHyyNh+HUNPdKq2IfKhNyr2IFgWxzftELvVd5TKpLp6a6hvqnw+sZPuyiKYywSa7uFYsYP0KeV0WnOIURGVH/50cgFq5B0UkBsKrZuDxCnC/f6UoFJmMXg4x/+kfFjpfsfO8X3STUlRSysJso3E/2s/fKinPUD+po9KtOyrgHf/8ia93jLf/81wl03H6pannWGfnQvKIb6wx9/Bh/Q0H/t//1PaEz87GBAooAdUWg7V0AIDY+OGLWeYcekAKC6SRWiIgS3W4pDOQrAvpIaLWM2ynqs8hE+ljFA5ER4BVX4BVQpMCRO43ZL+toa5eC7FcqZj/U/NXm5i/+x6Mxf/G+cfMX3JiK+Q+8jRvAeBGjv+KtMnIG7wW1xPxP/5ZXvUg/DLL3o3wzH6aZgFEjXRRuZgJmxNrIB07G2ojaoVAscWYotGPGDsUXvdAX3JviJa5ya0B1Z4EPWCuAD3U1ogRUgrorcEMuU6qibB0oAglPKgzjKu6iiHJVQ9VjrXX0hCIkNqwlHy2moXkDIEhURRCgR27QpDAO2fS6C5cCuIUVjSfJ5GmmEe9I33XSRkLe8yop1XelBjyia8VxLIW8UpgXGTx0pmUmo0SA7LYQ52sO3+TA24LkD7qaf0EiQGi6Jo7XEvHTq3l9k5dhKQSwf0xNB/4+tKBPjow84MjIm4cfFQQ5OkpGfJVD1B09wUdKTxIQAKEnP8wfM1gO/fBQ6Uk9+/CIzSBDziPVgTGGf7KPuMmN11+tTG7/azG5PzoxuR+oTm68PfLJfZgnt3wYZL/2eE7uX38Ek1vHrjq5Hygn9+VcZnUSh+a6aahjoiOS8zueRWjnE9qf/YbkQGluEqVP5ZnjJgpKBXxLt+QMkLXCN5/6bo6gu+m3eN4m3j4W1sZUNhGZjM88/yQncPjIJvCEKaVqH0Pbx+SEfUQx6XtCP3HGuR+oVa6ZYsK+kB94zc4PrtCY55HiU4Hr+hoWrerLNZxQiE0PrpY8W2CuDgy5E2JQBEXA04kSA2h9Ek/XA5zcLTfIU60674J6fEgRmAJmRw/geDI58OK8YSkFdm4QeeDvsh5uBmP/V8dPdGBtQ9jxAMrPwS5ua5NCuMFoEP/JdvM6SbjqxQfweLZYzTmQvUPhT4lezJZrH+IbN9NuNzfWYaY5gDOlXXig3AMbYpxYpAI6O6R35FdcLzNjmv2zbBvFoXlStCqJEHK0jwyLGdS0u+hQh2au7KEibDjbsAHf5cSZ4XBYtJBnV9Hm6BbnQSugvCs1MCzqBjZ4dKVx4PY50DzQZ7+WghEhNTCTNKOR/Aik0FsZl6+qc1FnJuQbWHM8rIE84GuGNR9//b831nzl1SeHNUq8qlhziV3W+/EBPOXz1QPYSVlLJxirmOrZ76CbnXQi/ncRn34+8D1nv+AwWy+s2/vHxAK/B0KqTxFLgPt/MBRAwAuirnN1MGu1/gbsH/PL3f4aamQgRJKUbaAX0OHPXi3a0V72y4gB/vUPRrhaJcEHQmhxY/daV3X+upgB6dpEkHSURx46Axhj7fiE3cMQt4QfIk7kbmLtvQkdRvtuitayTyIj4vs3+WuSpvFHr7fxB0fi36xzQiVjNVzC5J5z99XO5S3Iu0v792FTggcEKGMPl7EXTYvc7SI/UkbunBbZnfZ5a0pkGaNNr/OoWrS5KXKL52E4TrIXzPDVTR4/mZAcxDOGz8IE0DuE15AlmHiqtT9xkScYV8QvVvwrMIAvRwFgdJDMKRz1UhTSD9b4rPg8/2pU1A/YU+QBzcnYKxfDXkhJ/9OYNRQf0Kswlq6sqmes3QcoEolRLHb04JgKa7IVySFNzXZiM0GeNE7YTplvznJqjKst6mVNStfplqinB0+/8nrgBZ/HTRLniQko5rMpgUs8KZ4/bUilKB+0NvsbkCnNf4nkh46rejwgrzI9i0BaE2Sf0w92+VfngGqDhwyNAGonlMBZB2Q5iRYCAU2i9UP2g+DnEdwtwfsRPEuCN3oQ9UjwIcSSBA8idhVB9f3WleCDCC5I8CZkyCR4CMEEQdAaw6AewAzE9cVjmDquVaHG6pKmDZyMbZQxip8J453Fxi+G07HRod10rBzFxriCjZHFRk+xESOu2Bg5bGQ8BPboeB1AJoeAHkVTEZDHTRT6PYdzoQgyS5wLDM4xyBTnIsW5ADgXmPtLkzhnVqmgVwTHxTlPcS5E+SfAuYCCKs550hqvinPB1zfOBRWc+73HGeee6JXiQSCB8QqqbsuD7PeVJTAUQrc9x//iD6Z88fvnBNvYHUxoVlVclCqC6pHRxtiR0TvcIc+GOzJ6T+XI6O6xL97vvrjbffHR8oQo0TvP+vE9Yx9/zH18j/v4EwiqbSOcaMRlSJURVAeB9NohMAsh5WsQklrV9wdCGULt8rrXDEI7DTt2FvC5YxSXfGM3GXGzLy7maPYA6xBA6zjEhF54cb4oyKzXieb358t43Y1CuwjtQmiLyKGw8IviHfSbZAuY0RaKaP4lRY96tPBifiwc2H+gWEXdHLO4n3nMosdv+7FBn6Uurvbspw5UEuCMHLE9WqFlyDryFZrth5De+3j4xkmQCvYVJ9CgPflWPM7Nt+FB+XY9EqK+QF2dQaysZX8v+Rs0D2KR94RznUMYiiZtDlJCiwfWqAXXJ/kCLffDS/NV9XcsmmAorZhFUAou2BEZuhDJxa1ZObPBYIlfZnVgnUeEtsOStlFroR7OrGdogQ+yUQOt9vJWX3BLPuaq1Q8vJCviN6bIR89Tt3MukFcM1ou56D7EEftu//7aoYvuO/9VecGfkZ49IwGtldLzOdeHhuvDshonB8uIPQSGHr1fFYun+ZZJRjTfwRDpGD2BPs804T07tAV/4oshz3x4gl4GdLqUqYGOBbEzs0wLwLSVNe3pWsH+ffws30l4smKiHiuJXase+WuIpB0Pf87Ld+hZEmt5wisgwKreMn1pRh65AzPV8fBRA67GNXwot53y8Ge9h+9z52XFLM1K5lNpZzUJKG1MPvp618Zqgy7q+M2hP7aJkVROUGJEN5hjzohbVjEMsarFEYozamcd3G7vkLg/cgdqhbnbGNAO1X4B73UNg+gl7MXifQV0pwrKr+zlxcgcUMdCeYrEFwA5lohd63q0jXuPkz6ccuVzgioCt1R1DgWHilVgkf/ifIviS09oDjOVunbni+a+6Bgl+7SjZPc7SnYfgqlDNt+oI4x9/Hn3sSapOoKSwS2iAGVO+H9+7ITffahJesKPYNqXJuHs0riw7ks10mvqHLDTSbu3AiitAEthp5OJwAGDn2i7FAR9bugFUQ9bu3kOLIIgYCST3KcFM9N9417Eh40m3832FSBXzzAciEwsCq3oOfdDJVESiqQTHa/qxko9H0doDnIqpvnAbukAKHYPFJtbJXcia6O0UUoqZqV+LVmYtD7oD8oEaEDHO6AOHsgshntWe1h3QMB5dYbXg4Bx0SjbUyRjFGOeB+5/wbHEdIWsHUYhC8/LzdPiOXb3Gf6UbmwRuiEez5q4Ybpo6MYiJeN0IxK6cSrhCS1YpQJMPnxazmcr1GDWEoEdIzNdkzPaQaeWsZlq4vWErNRxUYIHtOdogFWa6tIWABp663t1zkt4t5nzHW0gzTk6IGGlDxmmf0Yd44OkMiQO9qCfnX6HvS2ZYYLClRuLeTcWi2NjUdOxSITY1vGnkF0QVJgXKjZtjPJTIbzPaAFL4WIeMRB9YmScnpdLP5V8gepOWqFohJgrOHlodpAh6yZmh50jiq9yLl/MGoguAGKnGmjuEKipv8AKpPKFqTDojcGgzjC4hpHnUeHjIi3gT6GWCMx66gQ9YdBgfqJYLOM0K9ZNRjCSUSCU68p4IX65175kuE1vX2r8chRzzwdq6ooaWc27CN5KfMHdHbDR5CEKr+NLWGTVA42buLrFzsRi5xUMx92k4cs5TLQZ1i6gwAXqKNlQoqH2Dtq0SjPKJOkyrrRxFbQRs1K5py7xxyUN4amzkPdMp5iFQybxfFcUEHEhW7mq5VexBK/0/ugf4G+x8jON002bnXuGf0qBOynNIHKGWhY33lHln9TuABAE0TKdLE+00A/5E8cIbXGMUDyGRmBVzNX/a5UUJWNMD9hF/F3aE2EIli7aQrGyPdJL4R57/NkqxQSUqmDLdzMa/HdQMEZzfXFkTIm+Y2jIMjRgnFVxfAfpvbJJngYTT5M25Wl6AF/P3h9marQJTxMw2orqAcLGLiytTPI0CQpnbDDDQQu6cVt0gF7eHNAAa0aLgkmr1OUQINfTHYUM3TJBRazCLIFYCVRWrLZ2VEmFLVJKZKYWohMEjFLAC96xTlHhFk2oFlVp0SrxkKs4oQBmrgBWK4bdWsQL0wcBnDJbNdqq6uLKbHUds6U26QyzFRtmK53ObM0bZutHxpgtvCvbo0nKbCGYKoJXma2xjz/vPtYkZbbkY1GRypcNs3XzGLPlPtQkZbYQTPvSJGzxDph5JtUos7WMuElmK8BuCsxW44DOpFW0XQrKO0JQVpXZ6nBAdmcYk8Xcp1Vdy91pPC2YUZtkthYRuWjvxltm60dOmtlCzk2ZrfkTMls67pGenLzfw7PkrQKY/NrwpPIKKyY1bnGwANyw6ZS2zctiB5gXc2X7ioWJ7VrKt4vz7FEtdhnN4+/SnqVec7SgplI7SrpWhHQtlNOM8+nFI8N6BY714sf7PYZM3xthv3zZhlWolpKmSSbMxmY0K0wYl7eB8mQ1qVtGTCej2Yxhy1lhxAK3pCmhWtbmUtcRLwkrUZsHzZqn5UvNjdTlZwqflTmwzzuwr46CHVjLtWdqfAZ7ZuJHrwKDFV0rDdu1Okm+/AmqxUSDOlOoliqOH5dogWWpUiwo0VYAyNKUfEGV8I0W5HKV/dR56NAwU6KrDKjgo4feOMBscYCZn2BAgY9gvhwrBexalTK30PwJGNBVcBPz2GqdmAEFRjkGNFAGNMgUlSwD6pRlqwxoMsqAgvAYBjRQBhTYsgAMWSgxBHRrCgwmGdAFSsGEzz+aOQlkwZ9CbREwswzo4jQGdGRWVtnPoMp+BlX2MzDsZ0KzZl6eLAeqcNycA12wl0oWKxxoUOFAA6LNpusquP1Vg5g6HWtAXQfxxc2nI0DdoRUzHXWzszht1mUyT0dnXcT4Ngt8k5nn68yLRmfe5pizUOUSaHkaAx1TU5YAXfrclJs3S1+MpY+bq7y0YMCyfrAg1G91M16a57RpY5FTTsWVm7HSsTTLLo3KSltrc8Yjd0uz4CjWyu3/8cy4yzdNPDFLVreS9YE3Jlm/ZUxUcxPelXuQJOUebkbQXsYY++J298Wd7ou3I2gl60aIP/bhO9yHmqRC/PLDUIhsKb2OrSg8r1vheJ6UEu1GKTpvloL1VOXwLV3c26WYfaYUzHdKcXxWiujVZTdCc1Uh9bwKqRfkW5WxL7CuPTpRZVEog8yY5l5c1A6UV4196Oof2F8IYuRzlBI34QC1aJnayLgmMuuUXxnjDuzPWyqyvks2y76wihKs6XUktTXWVp4f18mc2NqY+GqPiK0bLBTPu5TRHC5sNikFLcKw6adOYm1l1r1RmfXiNJm1XW2lnHzVibC3cikottgm+cSsa9ceEOQzrmPbXcdS9MhdlORx2QYBdjzVgFoufE1GMf7UfzCz7rPS/O2Ucp+J8oL/doBorFBNLbA0phRW5DvgW54YRiimWe7w5oxkG0+VbNcMuOesZDuHZDvXy3JtlWwD8mKPg2aoqYKrUkSNq7NUyrLzHfYuX0fHaJYK2dfPqvzESpq2jQqat6IOWUJyI2iuVQXNPdrK//VY0LzVXMetCpp7KRJF0BxBvu/Tgs4BjG8xU45wvk3HryHTh2GLlNqL89YjFyk/CjnyNnGw9qjlyDVqTZEjx2Ny5DkAYQ6TDpLStCK8A1UHOoCqZxxoqVykJgxemrdlwjnpcRMLSjnp5taKNjUMuUbkqvW7P7eZ9NhtZ9ot9X48LjtGn6TRTCrmQB64TTRX3c7oUOt2pm2X4ERvaFIdv7ybvcnNd935Ga5R4pVr1GGPZdq6abrqpmlzbJq2KMY0nd2EVwKOHvYMsh60gavN8woCaZzFH8tgatLMGVlSmyBzKyQzEYODq9R63lcRwoD+2Ump4oTaGugeylGJDGYI6KCCKMNsMBxPg+ZK5im3Uwouk6jmuKfclDrOPI0WNQfYz1FLZ/GMMa4ijJO+HMQLmZerOZxJWLmrmj1Qiu2wxco5NR38Zxz8W+NkUoQvTQGdnhfMSEsqBENJYFMgNjdGSKiFTYvg9FZqlLdcaW5c4LK1imnAdHBQbWNgfCvYFsOH6GVAJS8ezcvptpKX1JGX5enkZfaRC1EeheRkGT2YedSSkxrNTpGczCBugrzordGRzdmSkJeOkpcloL4yCTXKyqGoWXmJIy/JJHnJEMkTCHDv0NzJyEvaLc8RGOTclMDMHpfAOHkJFqCWapq2SFiEthGXdI1JQZWW5LOOb65Ij7YBYUViorMPss6m2zJs14ZOQ/yMlrFRjY192ZVHSYBimsWfbteWhH1ogfZsg8WRjrlR38Hd9+pmrSYilILw5M2Xtj3XizsiPtBRrDkRSqMUoeS0o0JKNFMG7r8iQmmDo5iDIqsKANrUhL0UIVzKM2Q6zVZpCcPiCEvNERYOz2hraaWUoGg4Q16oZmDXN2MlKDMqQVly8M82hT8oPmpXQxTg1ogfcw4CRngqSJBNIUkqQKlGCi2aNbSoVqFCSpNGiVAyRoQ6SgOVFDUAvpoDX4NmsCcA+JYAviWacYdSHYeYSw4xY6WlKkOZMTKUKmquONDMjoFmVVEzU9KMv1JC58secLoMJdctbkwdbOtmDXHmXcv0vLrbVakcSLfFzbmKDKUgxjaaq8hQcsuq6E64AkIQI+BKYfAoF3xpAkeaJY5M7f/cWP+b3P//9eh5glnlCRRmmUBsDlMyJjhEwWxAwVjBqT0+KXcbmQzCpHIZCWeQzWhYxCcEpfTHiQHAbAVZbtpDBaRVuYBalQvYbLIqF1AiprVo15g6GTtTJuMSNcxkbJpJ15mcdLHM0kokdfIaJh1wTSaerxOvNjrxNseapk45Q5Zm3NJQ+EpOWjq/3FlBi1KsfVuopXypkFc9osQEk7bMmRFpUNsJTLZyZbZRop62VQUmujZBYNIGyQAzlmo7jAkxv2LPU9tWLksr7gB/lYTv9SorEXXsmgZEc7uEkeP8yB1lZ2PjskTbMBO2m0Vq+VHOiO20gj891MaSGVGGGVGnbaq6BwMOsyCz2MI2lD/WGeGbZcqvLFOiZdEZWaOYqcBmVVcnbE8nV6cxLQuMkE+pW5pKaC/ZpWlbZWnyK9juo+BYW0jLpZaFhjPJu4LZsEKxI9NpZaDcMGDFjpVI6+CBSLuhmd18aFZ0aAC5FjXxp+AVJAEwj0uklygF5mbc9Q6DYeUERLrhOyLthAsKUkuknaZFlUiHY9NtlVIl0grRXH1IAVpNB61p/Z8k0tugZZE96o1bij+FWQsQUyK9RK1pRLrwR5CyQqb9Cpn2K2TaVzLdUR2Lk6bRAOCJafQqtao02q/SaJ9oM6xN1XN9XCVySqZTIzSYUcqWKmXDaFGstEMpW3ocyoZspQynd9VmpE1JrJUq+Na76qBU1/5fFe8t4XnanQuCrpphgB8c3V90L5AVKDJz7tyKh7id6oODPMC6vOSFq0vPKwIKhtmn5TIStLShJf8r1+td5PT/8bwpHqUC8qxnWe9ZF9Z6HPLVBVQgl9AXJITT2QwNF9tL2Z/ofVtnquJvfC+cdocV/5X3WPUCsF7mi9h2iibpBb8i5NjLTFzEWV6qN4UDePtRs29oKjdD3K+pQyT2qwht6xBzJ0DbiOeO+G3xKFSfOJf2jF/u7A/1yrRYE9m8llBrQZv0woH+4Ip54e2H/jnJFxHy6X0INVCC4azekvYwYsbjD+AZAs6JPpw3oOwe9ennpWiQXHZDmu7Rwqrxpk6a/ZHeZ3/Bo7kw/sdjF8ZRhbsvjpex6+JPlVrs9Sgdwv1snWc/5zr+Xe7JK+56t1uHrHq5G40wd7u/w/On3UlQl4xysf7sGr/xfLJ+qnKARw8C5A74p6fcW/i9dsPn85VAz1lexb+vKG17DQI3CQTnDwU6GW7CE8cW0r4iFIbGnSU/v4gvrL0OeTDDxPvqUY8McsMPAEI3+viFP5ngZeSZPfdHPT3vwx38RLiYDaCQuxdLgV5EqWk+CrKPHDLTCHc4X1g0pBUHbzynDymxbaa2sHFBcBitiqmx749e+cf/eOyLH7zwSg7/sL/rrDPeSM+86iUvYc7gwtqHeMBw3bNBjQl3Sne/fzjQSuTfC8BucbbbbsW/P7p4SA2qAKIHA2p3mb7vVFQJjTXHA0VS9vsdnnaMmu+k8J2GCuALgW9zjekeZttukmD2pxjIPLTXYuFBuUgpfRVCuyR07a/cMUR/r9CymrLoNJn+ZYdA+nJQr5FhqZ9wWO5mcNdHxoRaFJme//LFw6EOSfa/0bh1dPx5KqMavKuUUR01Iu+PgpSoIbRbJHX6/eNDSFNplhRiPQi5AqWIjc2KKNpcyJ22kPP8YxqsWiO7W6OIc/qfcNVpFSI8Oyo1Y9pjbMnXTmR/hm6CPfkoXjdEf82D/nCJDbcyTJBB8m8ULb5cvE9w5uMf74vRtJkSv7K9QwBzOKBkY2jidu4dXpmLO0Juz3f2pRsU6oj7FDkTcH2OOozUIcY/wU/tVb9s0i+Cibizv2n1c39x3srFknXwqesP8fg41CYXvKpXxh/eSy54Ze8hH0YhyLukJxd8a9/Sy+7VJY54sv9nCgC178AyIbfSqyC+RGfvXn3s0cdudRl3PxAQwlA8g/7rAnjS0fAeDj6gQVyY/bwG34Gl514Ny+2wT2v4LsTfo2G5ivsJDX8S4WMa/kOEP6bhw6jpbg1/yDM4rip0Mi1AAPKGNk6X+kP44iwJ3it3fV1dO8tWUtn0VdfELoJ62U55hZtQVObqS1xTQwl+Smlco6Ryfw5YywkxmsBHHoHeReTEhvBZIA7IicvriAE9PJuJsC4ISqvXKkMOz1SpZvqQp5nE1ZySS7NJBQBYcK/+VtCcGrbTqE8FWM4pnHBwQbkQ95PsTVjY8pqCmhrZX96oDNGPvpGXPY3NbkMepXxIeR0WxLdKnInN/kJzMAR+UBfKfqYlW3J8UfapG8ey/KXn+a/Cqi3WDijQS9z++YGs3ecHykGEz7j4dUX0GopeCV0Ffr3uNdfCOCai49dQ/Eo1pvife+cHu0jKr37gUbD5B+oIHzm+o80EioJX5kFLZ/IrC46VlN4zvGvzINUG7sa+XrITPghfiXnCcFTe45UFpyFdPpKk9FbP9/i+4RSvdGJFkzy1qKL+LnkXpuskWOAk9zfN9BevLzMFVWdxgVsH7zDBcO8QJkxdQuETv1/ZS3/Hc5zuQWYhYlNIPMIOxJuyA9/P607RKFeeeCpDEGP5wiPBjdp6H9hZx8vqs3r6qTrmxU7AfRVpafiM10JCi8UYtmfPjcLsfWrtkltuOfdXed6kqSxAzDCt2V8qXwWDdfdpEIs1jPEpyxue78O2ovq0xCmN4F9pveoz+g2YYGCaD0MWFeNVl3geG4617B5X91k1e0BgPtCF7K8Q0XZzgwKdFBhfOykoSP/469gIrcSUBjsrdjn6IYrogQ5hL7kxXJ9qlPaP/cC7rvGqKVaCqKaAryngvdOZQAZ47CnExuz/r/eM7DrsWqzJ2e9AxDPC12quXUWIB3EDGaG+o1fUMUkjTs8TWdKya+HpUApISDKhzKLJhfHf/6/H2Tkfqs2bUq2aYMVuWi0hcga8wBzld6JoLpGa35G3U0mOUV2DmmVS+h15C0lt9lyo7q7ADaiRx0CJm599XlAKzc+1+QA2Pi+iaW38TtWxyQNMIn3xHQKex/hf3c/YHZDuTHVbMwHoND27+pmggdkLGXqDb2v6Lef+aBj62IM46+nkaJriqx6mYK12Xk7zAFXo3kdROAHmBgwhTWjZTZFhoDzDvn1RJpEQnQX+As8uFjcEVjmQ/YPy2HjPKLywhqb7WNZheS77ElJNkYHVxcr+0cVm/yTfR+btn+UtMG8Pylssh5lnKgcsjKJTljp8F4IhFqbLehuljV87Rb517wBfCn8MmxRDR4bxajcrg4uGQ4mQ7Yf2XFd41+YvKzW5A/N2MMCsVCbDwIGjA+wVrix8xn1lLHzDKOwWIpE6vSkMRv0Oio4UUWkeWNSvYkIj1zFLRAdNBgU0IdKVMSrbL4yx6YLGcHHrWCi9UpaCFk1uzC4aDtJf8GHCDcOOOwkW+wIgh90o16ob5ZpulOFP20uVhxU6pVp2I8ghAMn+BdCSdxNP/LwKHwPCMNWAeEinyFsvvH0P/fQXfv8533P5xeSCV/X2fa/8++zFQ/BSJ24XmmGKdtutwuNvR9u6C3V7Vsewsk9xBTJnZ2vqXZKLC+Wnef7oPPV1nvrZX+uniNNUO+Hhe/aIztsTGU87+koYT/ubqcbThp7nb2Ih7k5/zIybeue+3S8CaR0Wy4FPgfOCqxkOVTPcNCXDbk0Psre+2kXuMnIajawSv0dIxV77eJrHDcizx95q5CAo7eL+rbOLqyzkmF3cn/W9+klahQy/3xqFRB4PFY8blS0CyCOdQVmID8U0FT/rzqTs341YgXR3HqTxWBki1Osqj7ng/YL7MiRYlQKVF6JemKPEFy18KaEEnKN+K9aOQ/VFHjNUUYnUoJDAA2nZ3zsrk8ovelVp4QOPQVr4hQlpYViVFoYnKS28+rFKC71RaWFopYU3esw2VpdkkCtw9vd4+D1mrehfvrektExAVaTuLOyXgexh9Be1ioV9f8zCPnliY9/Hf7cNNTMa/gLfZ6EiN+MsWDuTXTVJ94oIfFhM8auIQ3skdC2CVEbuMpG+EeJl/6orKoCtEQ+pndH0wk0p2C++cToFKyfsL1Qn7Ji0cwEzEAcPojytrIJhCHC7ZRrCKPsFc2uYWAcoyL5iaeguLSHTEhZQAqnRW+h5lEKAhTVF4BAFCHf/1dGTBJxSBK67ju4KbpMJdfU+PGxokAx4Int3Vqv1DH22HrECcwSDTF/LspP0uwPwd/61FSvutipDIGvGjif4jgBfc2kcvgOLH/Mm4MhB2VGT0EF8ZypIPxbEnr0s4DbGu/cXkSV+ivdF7GRuatkVKHNgY6CogXYcKOoqhaP/PvCfcVVVCSFRxzvqgcRuyXAdSpE7K9keawWw8eKi+U4cXGWv/GXZ5FAd5g8P7JfILkemlA55A9SilnOp0GNpITR31ynmn+zgG5zE44HroNtDEQwYpreWkc9vVzMgOStaI8mEioirYX2IWI9xYvAf2Axj68JQTazPf3V2U4GIntlFLOOy9rpGhDwRbC3GIuPBy861/q/cxPQK8SrlUSBp0g9f7+Q8Gq9iHlBHu139izgM2EQhxtIdRtihdP4kDh1lwnY4AIOrJvwGHsKyuhxPoP12j5gzhyCgKlOIKFK54BUcGHBqhNTst9+o7T90yFfiCjubN6LSGHEMKJyI8EsNryzYxkKJwxItRcXdiAUVftCnaBPjivf7alv95ZrzamNxHY3xYBtt1I3GQU/TYSxN8l/OD4K0VR579bFHH7v58WHOs8s8ST95nvZQrmgbVPlfQC0GqTn80ChmWTU4YL6z0fdU9Ksi8X0ff+p13/u2wT9dbPcge/cOoWGhnVf2U6tRFNBo3X55+y68afdf/OD/eubT9cDFJ7+MudLd4NC92ApFWEtvB1hvD8wWTEt2e4UYezCJvskzikRgHa4oYjyuKuqiiAVipiEQM37k3nEJWmoJWqpGDiiQXDJ5RsghT/DK17F+7dmvPaobRR7MPS0AEzE2yrIRjJ2SjEZ2v3aDIjWQZmI/U8beW4n9nMYKYD+kZ9nIcmOgE0ISlItGuJRrvbUdh0wp66Car7LWaIskb8CYG68/e68pmpqVmv0HAnA914MQ5VCaivZ9/GP49/mLh5z6UaRitfrlO4ZCydzu7Ec/der96TmzTx8OVM6KHLCcGl3Z42c9ezWKhCkFamc3SDgCGJHO1GkjoCaXv4GuvCcA1eW3uzGpGC6YVM1n3P6564/e/bovv/UrjNB3BjTD5Ao/NUgS8wQf+2ucGdqwM3nWv/tBpj6icIaCvyoNn81uRM1aNPxjzelhHOjIPNboOVjCKxbUicsCEkJnvZ5RTLWldfsgqUU1JkUVNE8zlBIa9B7G3tegQtM8VCkVdqThxZzxT5VoZ+bQk2f1xCMf0CSDP5GM6oxwuGrIgVtEvjbbf+GaWL6o0yK1sClNTfELAgBqcTxSerqNz/qty9ro9F0B69TJje82JoJ+pDLRogMMToTdbKMSEa/ENC8OuOYAq1lc5ORYjNuVxSxWEYwgB2JjQsVcSUxU8tcm/ruyRx1+PbKve/a+b//XvIHyuweY8PwTj866oyQiDujg5PLOQGbLPHo9Tx4OHjzKLkPZyua2+DGTvRZwlc61OQ1YJUWEkLYvoWfoK9jUYb5sdAa1u5kep9juZiPdXXgE3eVxMZ4cbZ8joDs3pKj3uP++HEz7Iv6hmnLDSd/TzYPe3pshn2KdDXmXZmEI0T+Ay+IZA4kzC5T4A+AaTwu0kW8289pqMJin++vwMe5y+g7EiYVvsWJBvHvvABLwWxC9UXqNrIqTekceCvrhy7BZnYcfY6p+O5A0afwqde8wgo0v8irRpS3UpS5zNgO4/sQ2r+yqETbXTL/6h1+BU+08TPHNOrpCIQSaS3no/BxGQ1pef+tDMbJJesYP/sJIRH6a6ZCP6xo7eSHJDqH3WJeJmlRHNOrOXq+z/HSoRpjJi7TdeV2K9M+y1dWdeEBm80ik1AJlaFNuIjfU8HIWzvu4sI7E1+Qt6VtqMwuMTdQnaGhY6nr5mmCNSKiOR53nMsEz7UDNm6hL5qZ6xcA7SSOIfOqgu29Av5hYMgAgOUHaKn66+7EhFIPaqU53jxaA4QtyDz/PxFIJpiMQlmkc0Bx9NnRQDmjQ9cR0HUQHGH6tdVvNjVDgzFAd56B1J2/hHs/0W4qluvogZvQ11dc3yrg0dLEBiXpB+rbQ+bU46gykO7PmpGbNu/q2oG8ttfotg32TUgJ54RbqDWZjI1jwDiwiiosxnCLmhEJcgm5wiOT0N4azkiYsowbo4Ll6ar1b1WDOKvduFyGkJpx12uv1mER8UtVlIcnepDMy4No4p4oTAphs/kEkSDxwWypYRaPe4eP3TjkS02aelddRPIKsBpGprDAWLbY6hdkPoSAUG/dvNlGHEZXqJ1Jo91kqzBDxXKSn2KF0hcdK2/PD0h4RCoXuu/1mC4DoSICKCDQ7w09LWymskQKo5gCkgEMNqDAkXyt6MypyCRr5I2Vk10XerJEVR1Q/5XuxxY/d7lQupAAyjBCnaEmpQwac8Bi++KH9fIk3u+cGI0voSzNxKsfJOP+7843lLaidRWwEU2hIXBUlyv38SvJqNVk3s/X+AZlAmNMvlFBDYBQrfuhemtTwkUcNZSIxKFh5r7GeyTx4i375NWtjB++xGhcW8oBZydxCA5u47KffqIO3u3SRBZG40yOslWI/VSVEU8mIAQVbPViT4n6p/HZMACkGZQrjGQ/ZWUex9JIiMgsxgOBt9vHV+rGRinUQQIOM9ExjsveaEfAqEknXeCONZCgBUpPSyOyX8HnZqEfaomwDn5/IZvAvv3FSk+5LXgjpBv6MTqefvUu3OWo5XA9WOfP0Q1VMXM6kbGslHoTLnXf5Uz/GJa8QPA1WO3WmAoShBtgqCQ4GeZ1ipJUJmU2IFRE9QGgI1wTDI7mPk0EODXI4cArFmZ9SgBrVMbcYB8GQ/UUUNPnMrj5dtVX7bH1XcNdhX9XYPFJbX7JShqo6wVrdav3LnOsqtckj1BllPyrsUH16sbVHWuxLUaxfFpvYQhtaqNzfbYj/ipRFKXkLj6Roq/tNueSbInuEzB1GErcFbdPMcB2XQG7NZ9T4WUaJ8nUQYudzeLD/fG2sGugRa21FgBnPTYM/Yu06OqUhj/hz8Zq4QHMkOfNF098FsU1bxCJ1DsSXBVxQYm9qVjlxAkqLa05bE3IgEhmJex/I5g1uQ4lP2tfFk6EUl1AbyTrsugIIHD0AMbL3/1OAOBUVdTcSDTMSAUZFRqKBbA3NRpEwVtpCtD7kCZnHAi/tbv8K8VcEjZQWHqqYj10EujmQiYxA0dbdeIJtTsAPk9rV1JamSuGBlulIGfmUlKdNyou4EyCqp2+te8kUV7B60p1tdnQAEFisihWrIHMoIRMrZNSxlkAmBmRiFTEIzqtTQjvl9+1dz/624v31SXsdn14y4gUWI/FPiioOgP/700NgPHSpe7Yudfv0ba++7bHNjFwzuYhVJZshB3Akfd/hVx9ScR0UV2UBzH7MsAofra1JvuwtiNDVk3R5jA3riKhLmHtUOyihfI+mhiIklBeSl536spOE+ciUYwCmykJtfA3u5ur2mDpvkUYkzCcUkQUeEuSYFuYYb0WG7DaZ6A2Jxco/4pNWXY1ybPaTYE3VAsuqdY+rpz5FKkhKofrMKXNQUxR71AR9qEL9UNpnTqb4i7c6ZjQT5qnEBPR5oxzR9exndYTNiOuazwXcIVXq3HOlYLGwFn8MwVPRPctK5cyuH3AyRmuNcV+OpuXAJuKBUEe+QEXN6T+n7akxhFg+yBOTjZLKt35LcRMZcdPAkxcOpRCO6V5DQcIP5fMBGoauxqi9fsSEJubLmscAbFXH9HZFLEEtF/vjGutcp1It3fBEcQR/6M/oRYrqYqvENLCukiBEqRt5t2oMBJWs1su+eNbFsYQe7Hvfy3cCBdjC+Vm4vACxQpAwmzGfWfoXcQxKD2wlsbkNYwwM8MG7d11/txEph/37IZgCSGROhoqROAD6TfRar08Aw9S1XPreKG7wwhsY5X3rUiO0znyAXrqdhLnQUPSt9VIzRc4LNNYx3MyiZj7T8lPdBJmLySlWi46sDhllRhyRCd1C3Cxl1Q1/Jhf4Mmz412EfqN+5Jp8XADYAq/l+51laDUYBghIKac5t3rXejsLTbeFb5LmNex2jNIMHhJR1gCmxTqebQmY0T1GNQZ9Spo3kU0PAkb1N9kQSpnmzpAaynlr0aSr6wLimwYmrn16q1JB3dm2uB7f61IE34yaxDbrdL8q7tIDlaVYPqJtYlyH10/XpVoBwoBLFLXwM1TGyA9YLz0zJxKKYpeGQoUqc456O0+GheV3PaBkMW7FiUhZY0L7CpZbEYmCCe1/AvttZ7fvVL7v0hR855aKnwZH7LAjJPCwlzst1O0aDLga5C2TU6+XkCYxaI8OyaMZkIbtDxmDODPnfXTwEJWE81qtpzMLAkGOeiFhAJAJOZnA4LI+N0l96RPegjvovGr8IpZGhuwmFzbzomXjkcfhqRKyd4G7Ux299d2yuRoHhclejPsYJHPfZj90auItRgze4i1GPpFJ3VQqE7ohSr2yI5+SFJogkVOVm7FLTOvLX0mdDgcATt1u6XodanSfhvnTO+F4sdTl1V2NVtnw7IrX0XV6gdGPff/2eP/zD7l+99P/NkW30XH/flx7+xMv/+tQvXwx5qXK+zNmiEtnQgI0Cg627shqb9oVZM95JKumUm8cc7aOL9Q6kEupFG7PEL5kx3XJEgtkJODHoEA9ckLwXtKXJL6kqC42e1OsVbfAneYgYXvTBpvjkcQj3FjC0hd/fTfx3WU8ZAjMsQqT1zt7bVcrglH9eLDoUaufh0cApILO1LYRiSk85lAxVs0966oKPUNfoB6b7xJzc6u98EU8geCj7yy/seW7bA4qYiUaSqjj+sOA4+6fDk7zsq4KlY6h4UDfHN8B/YTB5xm6VbKdzxFgaIWrSs8dEHRGGegCsXFdsEFu50bD0NlpX49dybVpGuWH2eHpQgsxNOU4jKY0akJV24HIP+y/+OQsVJexRjFc1kcXp/l3r/kG8qEinpQ7FQp0oiujCs2qV+BZoI6GucnepeLzOdKuzC5JIhBDX1dC5YF/qWpWwqlrVWUULVaV2GWi7ZWDKmuNjzRnmM6QyS5S7l5vUvkMMKKluoOxUb8Xh2oAaeO8MqSlrzczoYoClQHkSa4OxhamqLu0TUPOkOgxY3SbO/2vpZzyvuZmO2cKojtnO0vEwcJDLsoikGjGx8l+qb5AnSrwaTv8M34sP4iaOSEUF7Te4HJ6pf/mFjVWngCYonIP/ivBhQ1wQxKXsFfJZ1SVTJHfOiBXXpzsjvkj1tgAKNIIPQozg5yWIO9phtQJR9QplGmFqYdMFY0qP+mM19Jbe+DgrE6oHbtC7qirh9W88virhD/kBLobG06Rh7nbpGhfOt1To0E/ptkJgi5Twp4pYpe11EYZasbWOLapFrri/84A4JRVZdpS9Go1qCafNX8we94ub5YsbzBcakTdGM+axfJ03tcA5LbAphh0b/PWN9msX9RpElSy8rmWYBI+QSm+um/ZTJ9JNew5XNKpUb69Wgz7/hKCwrvOIh6BTEv0Kz+OTZQvSv/er64Wj2NZDaPbTbotaK0XDo3t4sL4RtodQlIZwI9YbCBYfRtMlFSB7hJWALHfWzAc/gw9EoAmuMPtZfQWljglun3WjhlmegEFbIP7J9hPMhOhRiWY2awnPKzXoiWwSF8uY4BEWoW7glQLgO5y060W9OPuiblzl2BbZOcRPUuEvPLpzj0EhS8Lxxq/N9PWe4WaxV87iO99QzmJP4D02iw8/7o3JIPrikDV/Allbla684w3HpyvX8Dagn4mEySt8CGQ91I2FBmghXHn/ifza3517/QAnVipUf67qCKqbTd5xcAiZOcWYteBlPvf4ERzIQ/D1Gu2nPxWEidEQnHJLSDfdgNymDAwkhKES6xDo6PMj+7Q5FvBFgviMG7m03VISAwH189Yz94yox5dPKAJDAUGd7mDiq+1pS/anOouMfvSLCyRil5UaGXxfjDTaaWNUDBN7nq7ApLp+nEeK/mpb5jrQRG9DzHgE/O5fqs6Z5egJfFdqwbphFAa28PayuV60siNv4ka9dw/mhnb5nTq01MreMjUJQGfklFqLGM237lcjw0dwYh0dqlOi86cibz3R2cvPoQp39vK40uS733ACmvwHAaRNrwD368R3a8U0K791MZEVE57qBQU69qEOILjXhzr4fbBTJCqREsmkaD9FfAYHqYnIgFQWSRSBOYhhxQmf3ZjpHTJxtNQ2hsehRcWPDjVFghVzIkR49kygg5+UYrXSkikjGKmt/xn8aJT12BJjhGJrgCYVbYbSEE0Dkapxbvi3IuK3Otqn8slITrI6lkfI2zqWTsg2K/jZAUVJoeWbz6aqbzNHbbCteYbd2Voh2wWjYzoLB3j7niz//oHvzwy1vRmc8WTSCRMjPoi4ETYmFpu8lKo6X4DRCMxopLdH9VJxmJ/htQBXN09s04sGXlWZ0LPsCN4wEPd2ihTP+zpFxUjg0YvEVmV5o1Gc3s3s+7vPHb1gx29duHffr2y8KX5gaY8NnG+Okzr98Fk9YrbwWb0Bj2aKEUjVMivNlIVVrnflbZE7HuxQUkaW2wc0NusVzP0zKBuSq0l4g9sR2/6PmvbfPdL+w0+f2v7Fn/vmP/+BBdq777t+6CP/uOu7Fm1g9lG0Hy1E+zdrN3/f6B9muYi6uOeSi7QHWZQgTiqSFlZo8vKMG4rg0SDPUvSTYMcRj3lo/2C/DZFiJnJFd2JCkWpsW3yE1mH5cmVv4n7EXU8flskqAxzwXmrAVfB+PhZm5W9VTAmcozae2ZCzINDl0mdojglqKbwb0Dwl6yyoo1nBN86IUUJg34t+7Su/8Iovsk4t32n7H4/mesrfvWH8egp4cHc/BW9jF1RexByCbkOqKvkCfBGq7Gdx14v0wyD7e5RvWAYUUbXr4+tqz7F6yVnuTSb6CPFAq55cXocJswdQ2NQ7MHrTbLNrMJ/xvWD6zWyRm39xKq8ZofxohKGNHEMbTTK0Ll1SQTAeSRUAuGFns38omVmAN/uSvirt9B0zi90rdodM7R0jG2nGoGRkwe6oGCREnCqk4CH8nKj3TzCy2Ow+iGZRoMchyK6HuP4II1u9gN7noRq9b/STaDi6pvjiZT8l6CbjqztoPKxWR/Jo7i/ddfI32IKRG2z+JjfY/PEbbLBp8+DoDbaff0P1BpthuGNluCOw3NOusfGJS7xf5MKx0CScUVausYXHu8YWk2+uqulUkdtsiT5CfQCT7nrD8a6xvUtH4+c8P7SHYIpTimmxnF6p04kAD26H2vaIlKlWy8nCITS+Bz0AzJJLNdSium6Y5OJ49h6d91oBvtOxDuUVbWb5GSAQliLpTiovRWgta9v74Zfg+GuPDjeP3UP/aI6/IuXEsahLQ9EK7UD2XtQu9CVyqJbuNftk7HuzX1QxJqGo8laqwFs5e0vuBI+khUn6gZPHtW4pyfrZT/7MJ2tTcA15VFrl0O1nkJfxhx9nOGx7/wi2uX0Uxbq7EpTrboZy/Re+COodX1vE+8BxEe+DSH385VTqmQCmH6r7yaMn2E/+/ilNcOYr1/l8ayh4xcx1wSui60p37Mec0xjpjXXocvsvOFNSU3j4CPdrJEuNEH7oXS78eWctSkpRrjKP+4oSRt4FxO1C8w/G5SGuZmuKL2NnIVC4oSafSjSZysMIqeqxXZPPUIIcTWoQ//FGoIUM4Nxa+zVz5jLPUgIGvEUpElKVo87Z296iY6R3U6SxaEGr9CIxC6TJ8NPUo9c+v0JuZA/w2mVairQ20lQRgiX3ouRzI/pti+wflrc57jt+apgI2Yd1gXSxxgFMv87N1S9ENQpuoeXcRuTZsFgN1SXpjvqWZxDNQp/4QNEUBmWBGywX2ktv5bY0nEw35duwyJBV6xQXKe0D2E5xLI8Hgw1VQUSOLax1PGNPR1vYOKlIXJ19VvuAvlm9i4ZMPrlhsmB8MC7KIRKwYUl8zHhiOTfDGEGLHlcN4MYmoWw/4lY4Qw+umYK9OmDyOWG8puNkCLPceKLRhPFQP5gG0EVNm7lVfeltRWvzbQ7a20uDnxltpVRBjQ+g664kDdPT2KZmTM1wgMQPYDFLsQFg5MhwutaWPDMEO+w91QRfppZkaxE8pMIVznZKrUIrb+JWUbI6KUqoiZ+2jiXHzphNrTg0z0metTxXhU1xK+Gs/joXNRHlY5ZTMb8kT0RUTcKgWKvgxhnpDIrmDjAQ0Srd4IpSmzNTus1d6cigzcA4o4Z0t3DI3ZvIOesqC/W5szrlUGDx3ofnxcFZU3vR4uGeCVRHSsgD+QcoW8PeXkGD5sEQ9rTB114V9PBnPCJ230MRLRnbsUWOyJwjubfwRm7jdyJ+p2ZesJGnIPIUzSzQ4bGZ1QEC5sH1GnE6p3xWExGTE8rSGAIsMOCz6ulePHSohVzNWX5LZEuz34KpZHDMiJ17mfsx5rm6hpW4RF3XatwyxFfL1negih6UhpwKS2LeGsB6GqAroV0u8vQy8gwXeWYZeZYIy/KzuTXncHVP4FF5Ao/dLiXuhvOuY0rtxiMpnijWOfIlOWkAWXoSDiWFDuZb0Se4XoQd8nyJOIbE7deTpZimsdZzNsj7FtYYoi0QUc5LN5+Uxzr56TSGyy5j1jnGSMwAwwV5AbBwzb2qcKglOAVOvCTMsDmPqnq0coCJkvqXQniRo+bXENrGHwQvQWg7h3wJLXPIkxBug3XFJnuXtgtm5m15WdaXTF7m9KUjL4v6ktJWftmmL768LOjLqoBH6ZuPOoHiRUvmd0Sr2lW8EKV4mSW8UpFTS56CT0CmWSKKLMp2CIVQThEjV3GKGDumAjbAiSbnj6BvcS5+niJZB15xHue1RbfoKSTfnkIS/RmtJDOV6Oc71WtgcYpUohXvkLi7uNiR0naQZNpJiLaltXV+5dIJ6z60yLW0cxFHEneUq6qUVuNUyRTRTleaoBWTlFCJI2HFoi4mSte4oNUrqrH1ubzF2ZIHVj6ZPT3M+F7NTxUxz2cVPzofiLmHH7xIXsDFXsj4ud3g5+lcyRkGP7c/Rvy8ULHuwhI/5zhqj+Bnj0MXSGgLh86X0HyJs0mJs40SZ5/KzdsmOLuNEouZeGlYzMTLU/XFx4tF4FXayi89fenKyxZ9ieVlXl8W8GJnwGIFm+MJbF6sYnMXL3YdW8BLW152KtJnBs9PMXi+AxhwLiEPMZbOyvM8RF5kUSEzM6B4GqNWjsDT7XzwFVVPoR0yH5COgGTa6WZHibgRnUdP4cDkXBFExM/xZ8rOkZmSavXn0kXVmSIZn0ZPl8k3babgix2TM6WjM+UU0wczU3bqJCBtvpkpNDJTdIpQTnSCmbINk2KbnSnbMVO204WIZKTDTAlSTIyAHWTjAe8K85gVuNW3hWfFgpkVZ3KBZ5lZsfDIZ0VWnRVblFJjddBZwejIGK20eovSb6HVvoTmMAN0zhiZ/xLFFrUzvFjU7sjLNkeoY0vcfXlZdtMhtvS8W8Hz7gSe+1U8X63ieSp4bkk3zRoUn6mguB0uXI7NSVFtjKwrvp4nycDRP3z3d19c/cOwAzF20rmCwBdX/4qLOFHQUKsD1jDW2tgpZhjMtLFYo+h/ikX/HSMIe56SdsXbkYWiVk46Rf8pCHvXo0bYWHT8LcIuAIsWaAsi1bdxywfCgvvebnzg05NAFi1ybWNEDPNcniBBi0CcVfiVNySYV3LGCoTikrTCDawviOXb1bwtL12LZVv5JbZYhpdVg2UV9OlMoE9aRZ9M0GeSGE4u+m4FtURMSYeO3ihkOTo6Ociqu1EL2W3YBW6z/va3a+ST6Gx68osL/sGtvFetqWeEJ9GTAaQVKWopr9Fu7C520xPxkWEwUxGR0alr9ARdWHS1bfOV3gMMsbbsh6nNaeLwCbxS1+ift6f58VDp7ZLZSmVQ557MVFwsJ5QZtVBnUTOAxn6+aJp5ylNNh4By3H/0MYPxwlhPNR0CQl6yXJNMcJ6SM/IUMv80/rFeNnYoB8OMD+m0Q5r6myazVPHUuQiB85CkfjSeQk/THdpeLUJfiF84t75kWoIMMMaaA3Qxism1mKs1XTPvHt9H66ZJcEAosHvXzRIcoUbVzbRzB9M2XJT4R3Z70MBuwDnUrHgwrVzSVI+Cxn9pV/c1oexrutjXYG48gc6xe6BzJA4SBOMJ41FaJvuFNzxCPwa7K0cx78bHXwPnBf2KmcBETEoBu7k512LnP2qTj3yIXirGAn0IaV9oS8AJCB4iVEY4RJi3xlacWSoukjkHCZEi5kNhr1otbaHvKAVJI8Lg9Jshl87stQzyK84otCYUICEVblr7dQEFFT3sMP2DyGs7sWjldMo30BdM4fHmNfiKa4yc1Nz5gBZgeUcZN7GkhdmDqiWrl7e6elEk07eWvoVGam0EhLoEGPVZSibuGeWePedyN47UyLdo0GRiD0c1mp29+YEJnrOXb50VPtaahrn44/PdwbwJR14gZwl0X1pU56sgiGhjo9/3VGMVe2dfcdiZveLmQpzm6fmuKnykEDtyLHX6130fLN7C6PHI3S1gf8gkF+Kgl5iGeKhBPZToEREF2TtegxQR1yFenQuKeh+EdNiVqpqEZ89oa0dtgIko1wyDNPbqsPUk1jBSCcFVa+MiAEyQ5osEN0OVkdyrQSNbPL5roinhKxyCsm4tP9HyD/rIgaO7IkPpEBtRh9shS0SHfOEHUGxLpUZauc8B/9Ie8BVmvPK6UelFKqTFRksKIHM3q+xFrVAuammijeyTU81Z5B93VFPL/lhm99Zpsf09SjGEvkyxU45DUbGZ/SugOVWV22/f1CzoqrMK+mVnFTSr2PxccCY/Rw15tmqkTXrUhPVDE4S1Wz1S706cqO+dZvKx4M+uZnK69qjtPurRU5XQoiWG0P70yZ9l+SPnpuEm56be+LkpTDM8NHpu+uAN1ZMsOb/RA9Pw38nu55dvON651V8hlTWbg0dyE6k15SJSa+QeEoS+L9ULQa2r+e1Ed5A+xceC3tRLSJ9ECoV6buiuIf1q9RrS5nWevLem/ktfBLH84++z6aNTrzihruwjb5i84fRrepD4vElbwn4fZFJ5hZJRgKahjnR1roNhyAPzBQUVQ8OPbrr/+sR0b1WmO16Ow0f9xqPnoxQvRqd3y07v51eNeTwWEBWhAZL4IMj9ks/qVwfhEXJqCu2f8v1gxAJnMGmJP9hExzbI1IKPn/2uQtCycmpDQ1oDifsn5BoQ5kuodyOdlSuf39Z5pU7UdgHZNZs8WVq1/CA7hvJJk7Lfw4vqwy2M2YKuGR9L5h5n5UpQAVu4ndJoLl6KWA0Z1nHxBM49u2KKhdsfWT93u0cXU3ft1y2mE7EAo0Gbp0xfTGUlFWUrrI0fH19RN9d4/fwJNF6xbrrav628z5IUVs1nY98PP/OH7smvT0pzBPd+iDwMgtO1w3AAkmVM9gnQYIZc+pcnupfwB1/7ewmo5BHeS/jE6L2ET07cSziYYQc69Q7C0dqjvIPw2Wl3EFAVdptfN3cRfn/zuwj/fqpdn/o6Ve36w+Nq2NyjC+O71caBt7l615nBidW7jnZK/a6a6N2raZc64qx+1588fvpduL7UP5ph+bnD6Hjd+OUxHS9OHFHy4lD2pydW8vr0o1DyelQ8wB89FlnKH39DlvJ4yVJ+wvcr13Zomr03LQncwMQi08VwiZlpVVOF6OVoB72A8ya1nXi3vGOSZH+Ir3AbCXzKPRxf8SDLbtOOdSoGzPskckavVAEZGEbkyxcPKzaTI70pkwe2Eor0Ws3Q1BZJAteGrg8oWncfDy5AtOcW09xz1xGru3NfGQqdZBWGIp8WqzPT6FYzemfIVI17vkwjtluu7tOcKwpMwPsUaF15+Yy+EInBSzioEpqGVw+vf2VfD4Z4vd+8pj/pBerwx8HT73vODItaKRRZzgRQX7h33QLwr99gARhsTMunoC9i44SGVeohd6mAMzRXifofllmCkRi4z+9In8B9Ltuk41WJ0PorrE76sGcs0QdyocRsnCqd1IswluhI7SO95nSspuiPRh1mzaJIWzkSF1c/cnI+TF1vijXXD8G95JGiMcj+RmDWpJBA+m0ErHJB6RBGF6jOvrYAmzqjmpMhKS2zIiTZurKpG/WzosBLD/uxLlabXLXryzTQrQCmmNLrftTn8rJPiiQhvCC4vLxFDN34KZbzquby6pV4taKIwxWxKEaByuYZ88Q8DzT9sHDq/TQ4arCAUv5VQwyoW2Emn+qVa2YUV+6txLogxANuKuAw6q1m9D7bmx8dRJJ+UoXIQf8xgiQASCIBSX1zkNQfO0jQ1hPB5C1+5GByshBJ+9kIRNJHCZHQQCQEROqAiIqoDURg2NACJOw3NwVIDICEowAJK3ezsBnkRorFFHBXAEx6IsB8ZRpVPMrwKEmMNN8HrN1NTXCDR7LPGe4t0tBgCqXDwhEolYMlEmMwbKMIh3jP1otR31u2iobtOF2Oyqoex0BX1yXqSBENK5u+Ozh+iDV56AoZL67Gxa0PMLhKWNfTyz2v2nV/b2X1JW+gzV0vOMz1eRN+aHTN175AquGLejqcHnqmp74jjEPxBi+AQIgLDJ1nZy3QtKuTVmBS7SO/cSu+Q/598mJywSvFT7yB6vBxEKvc5fk+owXV5M6ojyffIPVlkyR2YvHHCuVcBYy4YqB9mIVUO+5inAxjUTUmGqNFrEjF3/uXtc3RhldJh3KTu7Yn1n48UxCjM2M/v8s3oo2CYp6jF3wp5oXzFOVlYWupwsrqXbRyW4ABV8ioexk7OSnMvmCt/vpiRQ1PMJGAijIGxq+YJymepjiXZI4/Bjt/Ipdkyhl/1ve8V+nmks7zCSE+Ks5w/qxhtdaNsFh72SUhWHvZqaGzYOBGQrthpVBo2C597NTHWXggzdPdD36NZW+4hDno54FurG/ywVSf7x/kJ7445GvBh7mlhzXMeeDmTMKcjjxa+mF5Ig1PjT/dv1nKnroHertWxlm08tv5iU/e4Z/PfxLmOBu/i/Ofx38avpPDd/og1JLX1++14rfrE+keONwNH3bK09vhI9btZUPdy0YYq8DsnvXGUqisEgUylrgVJyYeJZlihCISwX/2j9Wta1BuXQO86uYFW1f+r7p1DYxt0ilXkw7Ouq1r2B98ecw6nw4eWoEGZ/9c7lrDzXat//QId63/Z556++JkdrpLLbRhVGD4sz+Df39jHY3dfzGkNZfioDVD0Zvt5oLKbk4sPXlq3nOFP/+0vP6BnADpHu5QRv5UYfODHcAWvGJNheY3wmYDPx9ky37goUcMNIN8uFXAp7pbfpncFYlZwSDqVIkSjHZqzynRbQLSwmpavbI61ytWZiiY2NcNpu3rJmIVbc0e7onHOXkF/mb/Oi4ofrvnedPPXgGbKt+isYDUlNjPT429txL75TL2mIsV66Aa+9HJvK6VWY1cRx/1ee5r3zgu3NlZPeDZOXHAs/+EN6S/60XyWZC97o2P8X50VZB06I2PQpD00/8eUtb1N05KWXUy/DsdBL/9jccTr/6EWiH7wYtm4GxsjvciLbk+GL0i5XePrxD65X6tiPIYAsuWOEaqaxl6ifDY8S8RwknXUXOJEOG7KuGBhnEuIaWk8KDB2uv0krzhgk0XRIZjCVSHxVZW3uanse8KwHTzGTxI7W6clWfIFq0hC86D8RbaN7Qhw4pazFJnvyAAzZoLinP7i3max1DLDilfoMjeOVykWeSIqEP8x+ot88iwBPuf+zXzssvcpVlcUJynOSRsoQzMa75ijWD3pf/sb4nmxWIa8LMLXFjGzxxGbWmtz6/mXuIiohfKtC1IW0AaF9UCAuu9xA2UaoskuDCyG7i7eFvW44I6KKPeHzRY3RlA4edWC2TW++T2LdEMhWvFdtxJpL6X59B/RScKWuEAG1zZspbvoFla2o/YnfzJKcFe7ZiWRBF3bDo+hBnNEZ7OMIzwoVafxVz2P1Uu9tOpcoHvNKhPCS+0RKeaC5KRuIvSW3tiVp5IthPztIQre/ywV/a6NIfkJWjgLkieRVza0St7i5TTvGSb5zDMuC7LzMNPRtsPYBCwTT5FNCC7Mo9RXkJSFIQKYox+AUriLCjM8l3yrOWnKyjEHM0cRpwi5qFR49zaw02xl3z6w1/0Hn7AM8DI1oB4kiehXdUkNUoz9/9n7zrC20aic+yYEuXlUhZRCFIsb0BR7KTci7y26O2besz9KDvNXy7pSs/Rxxx1S++911t6srf03nvvmf/NG2BgQhItb7e2CPOGwICY+f8p78fjYJ5YmRNqiwLkBRQxEyLygWGfqm+6UZu9NHIv1I9ahzYyxDjQyUbuDV+irkTuGVAqn4b/46sRmlSeoqJx4OmnYBRTjZ9AjWF+7SVrTsgHNON93mWAuo/jYL4C50JcRUzOiCp4uLhPDSqYzSnYHujnxNPCw4qzWiQfTKlpk7P/+Qc5Z8/QmgKUC5iZUmmSBzfq6+v0n387R0WaIj3VaX0/baJImpmPBkgP+CP8FxfT2jf9BgBtG7BI4/Rj1C1wxE++tU9VnDeiKc2Sp9oj5PRxE8mBkKEK5OmOk8HjEUKXA7Rrd156W3/URUBulwrIUnBDKgrRqKENzryAvmWHNp1J1JBrRgBnvjY32aoGXBxg7B6mPwoUzC/B9qztwefjUQEHQI0ANfMjQUDAKscMdg0YkIwlCfht0aq6PD+HgEB1Vd/wqgFT33TxqgCU/Pa6umZiSPl3g67rI3436AYvY9RNjUrk/PW6uoV3HLgXU7d1mRWJGL2tburzbtN1jIB3uKSKRBVeQ59MiCosozsK9GHti5Si21QmejQ/0K8cqqb+aj1dSItuqm26pRpJfxWTBlODgCSAmJu8izzQTXKEnYX5jt38ybxdWqKWqnLA47aq6RK/QmkKqgqFyqMaSjfbV3F30KdKksZgXUEqHpDHxynQAgIYXRDAtRkUaPJILiAcz3jrrF8rxiONJhos4p5RH4/xZ2LOXY13BbKGZBPia2fE2f8g2e6duIg+X/37xXjGdzK3H5nM1XiSKXJEfFKfJkcVOWVm8dV/X4z7psgxMgcmczWeZoocEE7ClU6RFaCvQh4OHtoFePXhgvHn8LUgZBbRzFUK+RhSjY81+1J7WaIcKECUQxOHJm2T2tfAaMx3MCr2cGaPKBsveCeNF2TIbSBekLF2l7G28SjW9NHjAcHUUIx9nbfPSCwYGCL8fF3DsKNhWNcw7GVh2DsdDLeJVI2UhmNbNaijmlRXLcARD68qVFIeNVSggRpRC3fLQDFyIBok6YED3SkVzJgWzwS2I7TaWLA7oYCPu8h8JQvkPhWRe4+mNEDifgprfz+u2nOAqyJNaBcJQN8CtwjgAqgjRr5gcBHyjCL8mVrAjxwoVWnKSBfcWyhV0+9wj+7rXLn694VaY3qFiZQH+CqNDYemNMkvUjiUBfyMR4F8wFeXAXyAQ0ARDpGFfwj4hwL/FO44lqjBxwY1+dikFh9btA2Qb1s6EPkArsJBURuHNnVw6FCd7u5ruPZAjh6t47p12rAhgtcQIriHw9voggF0peimThUxQKs20mADoazbRLSnmVAHKTi1rhE815zY0Jy4e3pO0NOc2FCh5kNNc6FEHdWgddWku8KLKoWqkMMNH4P1EdzwHG74VDDdNnnCi8jhhW1QX3AwIANpyTcsS/DN4Aamv+3TP+fPv+SH/uq+PaLXRXdbtHMbzNbsURONIRIXuWiDxDHZ3GnOqDBgQBJKTWg2sHThXPv9aJcGhi4zF4jyOCOBtWEKnzjNjBdZWFcw9VmEtUD3OHRLiF8V6K4KuqVTPyXKN4jwsxRtUsBlHVadOrA6tA5rne7CuqvBTgD7HJfPac+GF17DSqGjIcbwVsrBdpOx3Xlk1lBtjehtjeiemWwIMKmhYVtUAxzRsfIcYhvh1aqq4RdSz8wj8PCq4MwlAncugfmD22kLGGcCxpGLM+mC3RYcJN2pNJ30v5k2m5KM+cVl2wytFEkr+Vz7/pJD8TYRBt8mKW45WC3qwepRA6U3qI0L2tQxF9yia3Tn82L9xwYjYnF2i+5Q+ZEq8/T3pirQdQQjXqcbuMjOQdnvXVTmx+MwTT5ilfo9UHuROLSJJzZxsMLjv+phFkdXaefxIw0B0+wNnilcg+BMxkvdfMP0R7oBb9I2nxiaL2OEenSXNSoATWViH0JJllyRvgztHpq1TkX3crb1qazXitL8BarpuY829tRAGyXNFTam8FchxcDAcWRGs6qM2j4fecjFOIeH1qwGONAzzOyQjavw+PgMYxqGcwzVSEzMZwf4bExm7NfDmi0F1q/B0hcY62dg2ZHxyNE85qkiTkIDJDeG9fv8S+kregzgh76ge2Nu78h4VcxaBR96+DAWRwOWKYxXzuxz5tRZHE6ZAlREGstA/Z8aGJKlqyGJjfRpgOttJxVoyKuCPpwHC3jBhlnlNtwGxjVQTdrznAqNh2RVE8c4DXiJHbGDwOOhDaFQlqqqAmAko5u+JYohD32TJ2t+ibHcoqrxUKBY3GLFLP6ixP/g6VqhghQvjyY+hROLT307q8a3I0AMCKlL/PJ6QEV0Eube+Sd9tpy0R4GRUzxTSVlPEIVYF2sPgaqyM+olFZl6lb7cEuth3ODOBkH7uFxv8fsSs6yRz7JShmU1sMu2zDIsK7ksq71wLLNI+kixrCEsI4wXjYfUZHtOhgehNK9GsqpliFcV4vlLEk92jhZmVIHDakK8kInno1iHeP7yxMsv/vTE85KTvAXi2QIip4BICvDsZ851kVwXpYSNK9wiVFlkbs0yN+QfCVmD85wpikdqCG+ZrJ+RuCYL5rMeAgM8eLW2S2c8fqF4zNQFNoS9Z8PmCcNmZZlh86KKMuTr8UkVZhjXtmq+RE0jfp4DC/VGrA30qslktqnvyHMZM78uicxRIh+9QIEn8lR4yDNutFBZusKAahRqpzVeP4VdhR+XauLBtrmR1E4AMeAxOOvtU6QN9uubCj+/ZySvAG1cJc9k4zHwrNpnLc5uj59f2lS0kAYM84DNeZGNy/NIg0PuWxFq4IbzL/hCFi3wzR4nUCKDJNSQFHDFVHFRXdWFXKGX1WVTxReM4xkqpFbOdBVb0W3nZw7Vg/RFiqFxzfP9WeiK+BrUB13AX7k3BE1oWThssZyJP2TeIqIHNDxMg/48DvqjgtmlUG2a15IoAK9p09nUYOhqBRbCgp0Veb3gr3eX14MPLi7qwV/7/Sfqwf/saMB/7KTfTfVglMK6wwHEBqMHS/JimkxO+MRIwu++L5LwXy8rCf9+0UjC6HWbqJz3TBI+OJOErSR88HGThN/Nk4QPXnBJ+EwSPkglYemEY5PU5D1GEn73tJLwX39cJGFx5R4pCVdyNYUiRgyRhCunlISfPIMk/OS5JOHDPEn48Lkk4e/Jk4S/54OUhEULFmX4oykJn0nCT04pCT95Lkn4ME8SPnwuSfh78iTh73nBJeEzSfjJR0MSfnJaSfgwTxI+fMEk4TNJ+EwSXnmPJWEsuYJ0c4IPSBKGezrfyQ1ndb6T27quUyf396SloNoyTu6DZ3dy/356YzRHjiR88JXWt4hFy9ee2zcrFpgeACfubnWOI8AryCJtfoqYX8sO8CdyXt85T3/Ql/OW8onDneH6wbHoAjWMHxwMUVFGNV5xVOOD1P0N6xj3t/zwoPVZAuWameKevoB7gJp53u/zS3i/pXTrdEDplRNLT9y7tuaTbb4Cc6s0i1I9mB/fDODo0D5YPTiyNLMUW15HOqPYx4RiDaFYKhnDBnytZHyQSsawFiXjZVjngxc+eJGrGJ/PV4yXZV1u6fmsiys5vAOMhXkRpSdE5OZbRrqCr0vN90vwPSPqGVFTTVjo+QIPipVlBsXTq70ri2rv+afU3pWj1N7zWbUXdo7ae35R7T2fqL3nUTbX5aLay9lnau/7pvb+p4n+Ler/X9I/11XSKq/+mcUvXdfHFf1/Vu1dW1R7f+Rktfdbvj9VeL/JSX8j0kbtRSlWUhC11yYvpkk54dnU3pwvtYGOHL9chMTv28Sv2cTP2MT32MShTTyxiYMLiVZcSbTiimjFWvb1yReteAU4SeTfkCpZrRjMgrhI/kNzcpSeXDPk9cnDB3XRijcTrZgrEPKgn2xrWgN5WDD2ID1VoQdHohWHTKzkszo+Cxa14kOUaoucfwcs1mBZgU23NWU1WDWMmKyauvzkJPNLJg1QpG4K0PfjQdts2aKqzIbQKrYl5bOwKv1I6RE6BhZvq0/vcmpLw34/fO2FOCKIvuaePtUpeIQeV+fyLqc+38qzu5xiBFAFq2v5+KUhH7MS6arcZ0h2OaWm8OhA/8xXy9HK9bjTlneSyEATvFP6OdEBxvrOVTRchzb5FaO4DlGsQtWHyO3qU7ahP7kauQzJDLFLhONJinjfKOJ9VsQHaW0PE3G8Sn1XHPdccbwhu5xCJIY+rg+ij6OCuQXQOwd8TojWMfp4SDH5fJqv077WxyMaUtnuctrZpx5KhgsDoriHP0Gyy2kob7XXeJfTER8hG6MCjFDpOcp4SJ7Z5hQKKzasSZVx0EzE11HmI+JGxnjsyXgc6tNTV5Pd2SjKKOODVBmvYv9IKONNaJBbGWUcw2jPiJlCQXiKsc3pBF9dHsOX+QmTVpONCzPKuFhTCqSyPKN7xzWamAeKR9S2IvfY2YUUJ6hE/SayyZ10X1IA8gKKxHsN1ONxtpC+QzDV3zNXEx/pIvSfv2IRHOkZ744KE6XTjvlojPQ42Tg1Ltp6z9fEUS3pGahYwIefu7tPPkASF+BRph1nw1TkjGic3TDVs/MddCMlu8rYtgN0D+40kxdDGo9lTZSRxi9TyxkTm1xXgjiRxn0QEX1LCGm8yXO8H4cWDgQhw7cZsgJLuxQC2lJxfIUHqivpmHU1zb2W5l5Pc2+kuTclCbRu06rWv8+ZvSj117tjhXQGnyqYcUjtWiH9F9bjuzjqH2R/xQjpSoT0X1tX9yCkH/KFfVSq/r+ry+wrpc/r0130Hfe5JE+E9F0MWJsQ0jf1+MbCzBbdUyWZbV9RHl3lavOphMYPk83+0GLO3n92LoyDb1/PtDtidnGrLepil78txizSpLPW95EaYNr2GKkGZoycGmKuxqlYf5WO/gqKOunqHsbQGBEbsTGqbJAx6tTXxsAYZTbaxuiheqRrLttZauxzX1U0AlTIxojqxOSFSfGYfD7O7C5sNRpR0RiQ81AIjamIvbx2rNAy0UCn0SIxmYrxHv7Mzbkr8QNnhzef5sTX7tADZ4e3SO5iLp9ZAWaH72JuPTGZK/E8U9yE+KQZzZ3iAkNqfGlQ3sqUY1PcHjJHJnMlnjnFFcBibaNLcYoDspRmjxAPAzB1QNYOdQ1ZS5i3l2gLmVu0mVXc76eKO2PzVSjurwKbr+mDHvNf18W+oSHaEIheUx5dF4g2nhOibxjgvZFANNZZrzFEt3TqdU5t6tSrnFpPYFtJYPtmAtu39NcbMGwHVLHghPGmBSeMtyw4YcQCTshntGWMDhubxiixsW6MNgxLAnIAXVoANLmA7sCww3IbRsDGzOA+EqjvCNQnQMAeBWzMqcbHB8h820IhEhLE79CMxkh8mqVE2YB1hyZMCXyOBJ80cwlioVukBzQ/ctfWEf4cT5ZZhix1c/89ejtDFj7zHfo0JmA+WfZoskiWqiHLjjyFJcvM8GBkHkDIMnLJIizBKwQnkGUAXgwsWRogS4PeQKbGnVXgd6HAr+MABX4dxMBKeFMToy3EuKELvCnEaD87MS65xNg0/TXGCEMMjUgNatNjb0ovPgTsOBWDBIY2kDuZBCWL7giGRXeVjUHaXZeoYRkBQ9DdY4OEEQ7UOwtQL7tQ77lQZygEtgOnmqA8dFBumyvAZIgM2LKdu4XsA3yeu3Er2h3QmNFezsatb+sPGYl8PwObOdnc4iLqhToCG2HAjmXAJAPZB9y/C3Izw0UhIZ4wIAeyh6eGrGi7Atk2cNS2m3KvWx19FyuKhnlVg+ge+kYLrwHv3DrGkfshAnR6RBrWBm4dImowoEpJ/9o2iyBSVLajesBGx+Ksr42SxRmMnuDMAVB1AUB1F0ARA2ixR1wc/NNx1HZk3HtI82VrVmcXl6tZWbxIzQ6wsh0QIZOoYTLv0S7d/7xY/3F3br1H91FJXS5KqQLdxYLpLr2Ci+ykMquMe9YzUpDEYYHHYEVYZNMduiyqN2q+x6P1LlTvvpEBSkb1lpmaNAFuJJ5+bAeL2objgNgbUoYII+0grkKs+6UdClS3jTLSRtU0Cqmx8f8HbMzg5c82junSeUiL5xTy8QEyMQLAOQRRH60CHtnxamI++zV8BlLwWDYnHubm5rOfwWd7hEEPlZSWYl8U0BcY6wCWpZbM0xaJbbqAkSn899MbywsI7C/w9lmxOiwgGQfs8B9LjYXsTRC3J/DrhHix3587dM4cceYsXQYCgEgXkcaCT/+His3EGwU0xnVGA/IElzXjnW1TyfIsFL0G62J9Kvw//KWMABbIaFQzEhjhScSzLgFVGb99TRuqJkORLOTFEbxNEZCdBgQWzIKuZvjCpXsLfnvxE5xUuq1TW52p3z40t0qziELjt/fN4z/lt69av33EesZLcJM4c2BLlodxj8XsHpWon4rZinr5zClnmFPF9wV7lmFO2WVO9Yw5Hz5zesIcbRD1HlJJRDAD7qqQSeNT1TNkioRMwXJkCgD3wMI9AgAjSyYRwQKU6pApWJ5M+aXnkin2FukkCJVxND2hRk5+SrTYA3ND8hYZV3eVsjqtSeCpvNItfKP+okbdI4JG7cN5RKUXhH9n/APlXOn5BR7CvGWGsIuqliEU8Ukes8ZIzyVZAqTScwf9nJ0sYgUIm8jMTXsiEfQoEOm5Tj0rPaPuy9I7hVSnqiM9R+wprovz1+bWUliJ9OzvU21BeoY4xtCjiHwrPdtJd9GddNsXeURH6Dhb5otyfAurcruE8ATnuKFIz+6e+RYlWe35tnVt39Gl3Nba8y1Hew6P0J5bqfbcxNddXnv287XnFjUd7dnPas9T0Z5DUJimjvbczPjZobfF3tPa87fvvmwjjV/+ygtad/5UrTufY915iTjjvz5Zef5tR23+JSf9E6nyzKWkYcQnxRk//kDjjFdOijNeSeOMkc6PM17JizNGFUicMbTV9yjO+F2UykUeG2cs0jHrmE2jY7YgYDq9Q1u+MRnJTCkJTo4lOLmTBidvQRESHSPE025LQDK6jR4HJCO3b+SyixyqoSRpddLnD1NuUsusbmsSktyiWn5IMquup4tK7h4TldxIopLLS0cljyQqeXxyVPL46Kjk0fNEJddg1aidE5U8gWzVy2qvEzg8RP9iDGs+9Flopm34cCY6QnmKp5AngsAVsBOngujj8mNEI3whVy9oN6UtqkB9rchkgjokybEJzLWvxW1Rwb4SR4QLPRFhY3vBDuogveBCegHTH6PKU9HJwxyUZUOQR0iPkujkMcyx+WgH6Z2lo5MHi9HJNZI6GCHg8tiHneF2+U9n1NkKBVadDWgNQ5nxTXHcchkzkrLJ6kKc7ebFLV/OxC1PToxbnmTilmE/W9zylbTXv5rmXktzr6e5N9Lcm06Mc/0oafYnlpVm209Js9yDqobEOCM+pKHa+ryGK81WXGl2A9Ishg9FHEd6T3USabZCV7nSPKPoBIk/H82VuvcXwmczutc2brVO21C41nnGhHSLQ6OQ6rLGhVSfNS6kmujGOYWZXMyTu5j6ZlHrs9E0RhVGutyF0TJGjRra6BqjDMNKAmuongVp1pO11VqqV42oZvSqQKRZLyvNRq53VtYcWWm2GE+PlWYH+DO0Lv89x4Xr0ZCmRprde1oe8p6SZosZaXZqHfDDTHFTK80OneL8PGm2aKXZgSPNri4jzVZkOeS+ZhmDqjFtG6p2MK/tpPGex0qzc0izc2BTK3ZQoF7Vxb6mIdpPpNkKXReI9p8Toq8Z4L2WQLSnsx4wRNd16lVObejUnFOUwFYlsH09ge0b+PkShm2XlAUnjNctOGG8YcEJoyfgpIY2RICN2diwOi0MMsYWDEuClgPozgKgWy6gYwa06FVblKgSM4P7qkB9R6A+BQIG4j4YUsRHVuzftFCoWmn2LesweDsjzXq0Q9N8aVYI4kqzezQ8Vpo9gSwzlyyGvR4E8QxZ+My3jF47yCfLgKaLZAnzpNlinjS7uozOlUeWLnjRtWTpgyx9eg2ZGncZaZasNEsghtJFbGhibFlpFtGKQoytZyfGJZcYG6a/xhhhiKERSYpJ0Ncp4lQTsONUDyQwtBGxpk0di+4qDIvukI1u2l13qG8ZAaNpGQGjJYxwoB4vQL3sQn3NhTpDwbcdOEWC8sBBeaJyptLsMNu5W8juLSHNDnKk2TddaXZgYDOkN4+VZqdHSbMIiHYhu8f9O5DrDhd50mweZA9PDVmRHQSyW8DRFm0gc4MoI832jTTbonvoGy28uiLNdkWabQE6a9RiaRbpWGf1GVCdpH/dEmm2TWU7qvtsxBZnjVSnDdlYE5w5AAoXAFRzAVRlAOX0iIuDv3+UNDvNl2aXqlmRZqVmu5iNdqmFTF0hJ0izqKRtLqq9lDS7XNAyi7UthCg7Yi3aYi0VayVmq2OWszJ3k0Z5yuUdSjxWKtZGWdG84rq8a7aZRtoI0UyOWOsvuLyluUwnz4NcPBTX9x4yMSbYkCy0k+vyxlVpSNbIjG5D2kMC45OEZGFkEZd3WooNydIXGOtg9dld3smN05CsIgI02Kl7KNFZrstbgrOct8BTl7dEZHnP5/L2xeUdAakVQWpEFRPx1KH4g408rn8sI49L8Ks4s2JLlofxGou1a9ShRirWtmktnznlDHNCEYuiZZhTdpkTnjHnw2fOmjBHGy1ae0idDzyguP7JDSi+aF/1X8NXWhO+UWNRrF2jVhJQ3Cq9IPw74x8o54q1L/AQVln+xzNSQrXSOOGWEWs7sihI5ZgY/ZydLGJNCJtaZra6JprCmhMnvPbRjROOYciqx4q12Thh4PxosVZQsoRYe1Kg8DupWDt5TwKF36HJaQKFJxm/e36g8P+z9yVwchTX3VPdPT09O3v0ol1pYcF+3VHIikNaC6EDg7QtBOhAB8Iy2LmwwQm/lZwf+HZYaYVNYhnkRHYujPWZ1SgxvvD14S/yARKODzkBW8kHvnLJN/584fiSMbK/93+varpnZ3Qg5HsFO1X96n716tW/XlV3JeC5yfZ/8TsLWcnGN+Ouag7GtdF6b3pttTF6W7snt7UnATcF938H8avlPmg/mzma8CM7uGMduUsME98q4QYBRgNqtQvc3e96YzOyxM3VuBCf8/Sy3xtNPZvQIyNp9N75qPY3pnSEe/4jvco/XuDFuBwdjoHD8XFNP+nTgMZSOpgW2Ruq5TrmTvWRREe8AaTwNBsP2UTqdKpDGjZQ+70jXi4+gPvjOXZQvC+8k4mRXiy981ZLbFwKftttzZeCO3bpJdn48fSmbC/ejqgaoKHC0fz27FpW4HQgnJa1vZeNjSK+XnQfvwEdXiMPr8zmDEeVgtqPPeMVmlaxTZPyIQC4pjreUbjHu8t6gjRC7pHL3ZxbKidcN+zMlzlKhI0O1Cd+D75c3RwuoajGCRSELbKe0UKi11oRhPWMSvHr9BE70xGVdSXM1aAIwhhi1PHP0EYqjWJcoKYaOVQ55U4cXoHyEC0ALQIrAzhBGqK3Q73A2yBdnI1zZ8cw2sTfQAUpTCIGMBI9idilsjAcYsotr1El7/nbjPEd86koV9JsHyKjN7GDNN8bUDnqY8cTGYul/j5hf5od4wRfBdqH0cKgLhC2+C+FLxgIiXHdzyHkKvOuX8S963/V7t71cOnRr18PNqbhxsTnqoUi4MRdUrh+PTja9eshefaKdbnDHgKEeOIEcCQs/uujXr/+N3r9+h0Gww9dIAJUURmM3CiscMlQ7lxDZBPAV4Yv5J/4duQhgi2p2anEr9fxbrMT5YXHijyifpVLunyqgAD+M6WnJg9cdmSHNXjHnitZY2UHS6rf00r2wR/xFfvIroIIgUjhkSv3BlRE7vuXYkt6tf8I50k4fAPFf4f0nCHJ1CkgRBYZlVZoUoiPVDaqPU8yaKveS8pHGa0BZFbnDC7ob6UgjDgQAzKYUtF1ePDwkBrOvFFgbVhKkRrFf1dQKKkRvQp/Z65DOUFPKTt0M7Mn/unN0q8pUhiV7eKEiZKVoU2KN3qiildmuj9FB7E8onJgvnmujqJIZlHQYvItjShYob6ZCY9Ymc/LWcI0PGAmZhMvbxGw6/9JGjLgIe5IJmwcTLlb9VMI3JuXJiGjgtr1rvK+zPaKPwP4A12ilRsDhNkNAtPh91XxeTLOoPgw1JXtRkZVc3fXLkMbY2UZcAMiBojvSkIG8Fltx5VSzoFkJbxGQe2LvZVpfNLM4z9/PLopsmoqDZMKN3NrICfMosbU5S/yY8tmdoxgL4zMagMrxQ9hTkp8KgGhjWZjN0Kzk6YdYKZ6RQ57PnpWOeyBwwE47FGgHPYsh7XImVwWW8xD8jbh6xefkYI6mDhvVLoyZlFjCsdmjG9Jh18BEpqPR1EKvNLlg2pwS3peAYC8h/9iO6MizkJOT3G8y47WGsZvDCCuerJ3vodY3/NHMRtdmJ6CMyyhLW2aVZ+cJWMdID6o0bguefn6nRFvFPxgFzOJx20SrR+oHEfZI5xxL52yyTayj0n/waRTsrJrdz+TDoBkn6fz84cLzzMw6rEYzNG0TFi9XFOsEvckpxZCcACc/waxe4DqDaI9+L6ViijeWcwCwO0oPR3VZhIs8+YF6RkKw9Ew7GhhwNXjT0sVTqcZrqnkT3DgqfXdqa+31/Q2LgI4De1HOfKxpYDOELTvYX/XZm15s2c3Sj5DtiQyHoSYUlYMbkzKjom9ZPlnuLjE0Gk0gMMo9n26UxBGxjZ64sK6zNVSc3QU5MEbtZ3Vw5UuLEnIr0ujUUxAHvLzGpuJp6Alcm/JU6S9MODAGRROyjHe0+S0+2nKU67vU4mdM7ItSehKpUEdCmws6UBJcjzpDPhxuoiIDne+cv/Hnz/8h19a4lwOcOp+4cXOxZGnpEH+J+eCTCCP8BroR3udq4efSEKuOe059xy417l5yAtv8GffeuruDzhXQ9KUUqmZK+vgXudqvaw2cK5kRsRhZP8h74cWbrvva4+9+V7nStIPv/uee9/4rWSxczmp0O9ev3Pr2i2vu8+5jr6j/19OnTCPLXauo7/0ivunb7r/mXud6+iXb8C/f1jiXNC1TWzsp7SlkmMPf/LZF3z2yxc5VzL5+s6zb/3Kl599n3Nd5pt/8u6rvnjGxxY719Effs79XLmz9jrX0d90KO7t7b15iXMdfYVU7iN7nat0ZTz3r7ED17npzMNrWud+7p1PmfS3D69Pz2wT+Dt0Js7KJTTz8Ce4RM/SvUKWhAwOr7cXcWBMjloBTdnOgYz5jBKlNpvW+FmMYRnACSjER4/DrFs2BAZF8Q7SaRhLp+nYrKlasINpiDpE58rUrPfIstVQPuKj4+vsTG1t5/ojuBshq3KM2XQWnSvnPOdkBkMPtkvV9Dhl7PHZXDdiccsIH0TlIcjb5pLEKUDWGHwXgZCeomnFCoqD4558Cs7TQ7JkCWUmpIEds4TpSb42XTh4CEaknrMdnAGjCDNFJoczqCthOAB6KDwJm/RVjWbTABqfeo0JC3icPPnKYLd9hJGWnop8kSerF+R3DufDRsNzYVg7l3pXWBbPaKyDI0yq+33yOON4AjM8wqc3hz80Oby/Ofzg5PC+5vBvNIUzbdp8T7vELes7pZ/BbzJQyHgw+Fs1CMtQ3erhvpG6zLV7JpQw8ryRCVHLPZCvHorBNhEXUszQWHDX+vknh+ml+HNSl6e0owLYA70K1m1ds5HBApkpo/GduhjOl5yjxmtvyUBbrdWiaMqYN9owXPwIRF3sDAnCVdB3Dvk564p2DY5QqOk7fd+Mh2NmXFZJiU/mbBl9Bn+WiUmwbOeLS9su/NKCLUl52R2vx7+3LAFG9kc0fhj/hS5o6mm07MEH8C8auRbHKMP4bQhJquRTpHN7/IbXgBJhxTTRwH4U3hHfiYBdy17xkhXXf+i3L7yovlujUkBV7r9dExTudmvXawdZ9ENbme8sqaehzenQkmst6is/7jOChAR7YM7MtIM86ljByFDQ8p6CiS46zgbW00pz8yIK6xS4VtbJp0qxkbtc+y4e4cpTOPGE6p8f0uaWmFFdRm30gLfJYOMFK0H5+5OUIW9a2ugoK1JvcI81W57Ksm/27E4CAXUe+TzUZVER70IVdVnHSzJ9YC8Fd3Akb8XgiS0M3/REF4ZPl1J0yWbsmnVj9rIbN3Ksn8Ea8YIW4xyWIccyg4pVbvvJNAyhUPab+K0NC1A2XLQMve0YlqEfelwbyQ+FKp+Ycd6LV3WVHDlIywS7DFNXC5UfdXUZ4jCRz3OGgFbjPucXYPckUGVgyMcS2ZcJhuuQm6LLFuua5q8AFlOr3dlKMkwiheSBGuVbStVcWpIHSM6e+B5rNvClg5WLeeM3wvr1Ym6wT/xnjVuwjj+uxq24/mprtw2SoFGZ9s1vW4P4E68SaXqV8cxNZgt58qaHT94sP0aitgOlYAEPFvgxOz4AziSTtw+Tt/qGFnhDGjoTy9aCxdsfUGdIiTNrnzQmOk7b4PDznW3wU299+CwMjbertcyaCHUdxBo5txUijQ8pgR0uEnPhw5yWuf/Wh9/aL8bCSnx3k6VQZRnsZ1G2hr74HSrHKAaP7yzY8LwmG17LcD4xBfSuFgU0vClXQHiYpIA28jiS4ahjyA1nMuxAJWzM1j1fkvnxu5G3G+QlmHYjNtuBoHY5XxqkNkwjpg51AnWarWDvOR4rmN0lQq81K7ThY+8SaW+gLxJ+ZGfSLtH/RjiyegK7ROugHpGwdZdoqa0I5lrdLAF9qBnjIXigEHx6Mbj2NGRR5IjtJOPiMEU3hKxF9ZjqvH19RZ3PP1Jh+X5OuxIzTaazjEGn7HFDSaXIxO8HQe2uVsildJhBOKcWMd8X1FiTbzHjhv/g+vxX3uJe2cx2GDbc28nGR36dWZA5jY831TzknJZn+aU0JHaitHLFYBJRABO1PFfvgu2mY+mNVNmc1NgJNyedwjOIbhchbdINJ0564AwkMQ5QCxfDBf42w25tgb8VbucC/2XsVBb4N6hzvRKv0ThXa5J1+rRcw0Y05kING1bikEYhJQ5oFJ4ll0JqYzZj6etds4DUx9JTNqfTOIT/NvCrmtRNTOhbGhP/XTmY9j2rqyTpDpRGSdPEY2n/5nQ6U6cjDVVJHmN+5BQcn7qon6m8qz22ZQwcGrUzUwd7uCAzhm8BXwmhsed31aCvJlc00JeJ/RkiMbAHzWDKW9BRmPd9qQ0mfihNpUY5NSAAhRnaVB97lfdCbqTX+Aep2Ieuzbbeg9dAbXfF99lxvcNYxVnEPaZZTQQO95xZynMpIXObG/KXbc2P33Zc0f5Zov3NZ0zvU/ky445xDwbgm8oivQFfaly9KeRnb7O3pTze9Mrxvjmtrxxvv+cW98qxDK+teNb3iDVIxt42eGs6VBfqp4K3njWaROzuY7eK51n5G8ZGvLqll3TmgV15YLcG9uSBcR7Yq4Gn5IHT8sA+DezPA6fngTM0cCAPPDUPPE0DB/PA0/PAMzTwKWjS2Wpafir856qf4J+l/sTGgXEhtXHg/y0GJH0JIwZ8OPe3eYmXnCn9jxfG9PUgvA4HDjNLb4Gjs4308u+Mwj0nnUVDbFXkue4s1hrEP8KX6mi8VyerRhbp2fBKNuk50LqQF+kgMptEWIbwm5zr8k9m21eazpK9DGimOdmLRrt9z5RMDdSBZBacc+Qw9hws5ykZpjKG1dMQsNVL5sK9xUvOa3s2ex4Ob82iCsEz4Tw7nGfrLCo5hSgqLj1/6fifjaXz8VDCT5wuEMpCmk8LrxzkkPNpAf7Yfz7x05WDySI6DzamC2g2J1raM5Y8nea6teTp+ya4Cy6k4fzIyNN272bSRTQnX4+BsNhZiNkAhUX2rqYcliwVgJssXFpK5rudBcu+s1HN8+9KRzAQzl8KkNvzymQB6KX3pcPL5n778de//BWfW1LnfDJQo+R8GuaHpTRMw6BebD+SWaGLuW2z7h573+G+Zm5as2s6j+Y1TFFbq/kr3VU5lTabZnPf3Ak7SvElGRVPmgXdPZuptIQuwgsVnINmli5rc8/eJRzQapNOL0X8y/RFaJnZwBn8+9IHx8cW+JFSS83Uko4Kmj1Ky+iyVpN2uhyFfYcrQsvgazE5pyuc+W0eZRyRljIjOh1nnWtZ0znxoa//ZNXyexY5F8Tvcq3pMo6RcGMPvP/+vh+9/Q1LnJvMyyL71YADsCGJTZCWgdmoVjLP8fN2tfo9lYSPF9JiukwjdaosfXaJc9XIq30GVpIwbpm0oT2L2rOTwLR5XBfLIogAsmswZBZMsbNoREyx821fj2Dq5LUiF6PjZMNgwmGz/H1n8/NC4j8eOQtldKcr5c3j8/AwU+aYUrpKSJezgK1uCNhqueN1ru3K1ZCmNWo8XUarktlWhi9XOZsjZlPm69YyGGt5SbOpLAFceWHqVj0d0aM3UdAcbqo0ajZ072zOqhsvV6OJ+DyyROI0qAWRKxwF08pkNi5g/hkXvhqQYzWN2FGFmqzk4tdyGcr3tYqPAOFms5SorwzObvM4E9GVOEfb+GjGLLx5LhZxKuM3WWW5vVa4vYZzv9wfQT/ohOMs37RKbpxeI/0ARmxFmxCFK2uvpC4LRy6gy7kem2BFV9IsqyoOl2Q4zbFcmfzxA3c0lTMr6yUh6OK5VE24zmj/edL+8yxTsm5E5gpdjgpp+YX6zOGC51JZK4u+cbqruTKoG7xHrcwcV5k5eWUu19fwL0dncXvzw6UrOUeaactB1laH0mzM0QWCHbAosvls6Ur2cD/TWrRzre38p9Oiq7rYkKBv0EMipZdmK5YAxzAadD7HRCB6n84fo9nxPkzcXHcWLdbWKV+3AmeYnkbD1w0Sn5IedAoc0geH24iyZ7sbW6RCc+l8wGGeC9frO5dHH/yqV/BvPFmI6m/oMjUMHa0/OkjrLkNoNJ0L1iQsHlyJEUAFwvzGkXjkIAjXHbFXd1S4fuNcP4Hlc+0omoNRNIdzCyeNohqgNDNEC8ZD0LsNCBSVYzqfFUz5zW1p6rm8SZ0Ma1fa6pVlF9nbnTK/iLnGhtthcCvvMXzhexFze/5dKY/hUVp4Vzp7dZdHZ8nZ0Nm6qsDI28ihyWwUUkqGuQD93EKecTqc94RrorK6fG4pTuZ6I9zKDi5Sxgez59cDNPU9adDUNwWapkDTFGiaAk1ToOnooKnjFwyaoinQ1Dr4p0BTx1FBU8eJgSZv5NcLJsU/a5g0BZOmYNIUTJqCSVMwKfqNgUlTMGkKJuE/buKfPpGtuL+2cOn2I8Glyxw4uuykgqPwqODoolZwtHgyOFrSHhzZHNadJHC0tAiOLnbg6MIGOLrw5wKO1tHiY4OjS9uDo+WIf8mTAUeXtAFHK44FjrIcHC0FOLr4BMDRJVz0SQVHFzHMvOQ4wBFYScufJDha0QyOspMBjliA1qj46LDlkxe9mHlW+iraKyHSBcw028Io7c01EKjLCxDlycETmUlbIEqrclVE56pCdPJqkBxP6TrhlzETYsKHJHCIPSjKMWlUs7WUXLcGmN7cZ/6KXC1nB41M6fIW4Wo7ntewUpvE61XIFKc40NayhRyX6/c6ZqG6q2kWt87LsQda/RXXag+fBpVW06gUikaDX67RFnUE0ro5DgKRBc7ntFSU6BdQoxwcrAFiWKNohYNXNSDqqiNC1J2AqDo/zbGT0LB1ybqxdRvANQRwlc5YKV2D/MP2wNUi3pUN4OoxFqx69KRwq1eafBk3UEA73Bo1cCtHaItbvaPgVq3rsXFr28q04tYox63hJNwqsAhsLOfV4VQG4xdV4csFUXoOXSEw/ED2QS+w1j5CgYzDICBc4FMS7jKUsAotX3VSkexZPFSvoDKc9XQFrf+DQVrPSDY/5g7g0AbJ0skBsrayDsy6wTZLQWx7APt1N7ia8eus5tGF9p3BMU7nzDWCX0Sv/hNGr/h8Tyt8DSAr1IJeI4de/XboNToB9BoAveqXJOZKL/wqItfSyUKuQKwOvU4h1ynkOoVcp5DrFHKdQq6/Esg1+I1BrgNTyPXEkOsMjjH91wu5nls65TcVtEZToHUKtE6B1inQOgVap0DrFGg9IdAa/NxAa/8UaD0x0NqH18h/IaA1PCpoDU8UtDLjw19iS+uVk0HrM5pAK6vUFtQKWjNsBeUouBXBAK4LLXBd5IArwKwDrgsscIXc35Ouv/jBaQ8t/mtO2ECq6/nhYpb09aBeCGFR0U1mNxDrnLvH7jk8zTFuK1DbCP+PiyvyEdsWsc6SYfVaO4YmI9Y5mEbmjhbxqmSVLmtzQdulHADyyKriX7oc8YFXHQad28CgI/9S/NOrD7+sGBRZoSXFvzSzes82YrZtAL45wPx9002j8yc3A2D1yxasgrHFP8uVzmuW1ruKfyB+VcHqVwSsfufRGy4q/rGCPseC1UcfA1iF1tZ5FfXHiNc6PKAnc1I02UJVROn8956PLy7+qTrVzgIXCTyzUPW3kBjw03IH/YkoDV7sOw5mHNCKWEw1B8Q5FrBW5nn7zk7m12ihU4iYh7Kx0XmsZp++IVlLi2j+lckGu9YSUV2Qr7EKsOQ8C0sub4VWq20QZuyVDfFbmYWNs5V48gCwwEsGM6YxJa8ugJk1JwBm5h4dXun0wGy2RRdx1HmFoi8/+UWvxDS1si188nL4lP7mwKcp+HRKW/j0DLrylww+oUo/e0zUyzHiBiYCEFvLa2YoJGKUtujnhZIWWpS06KSjJDuU5yoI0lXeAIRMclKg9LQcOpXl+KXPdTt+lDQHojCngJLwwFw+XpQ0V1HSLFzxP0JnycBcWwBN5znQdGivBU3lSQBpMT0th1HDuyeDpsuLoKl0/KBpwy8/aFryZEHTFGha/EsGmja0B00bmkHTMxU0XWVB04Zm0MQ9cV5DnM7TSYSrfF7jkq1kve11fboiMw1zF9e5AUnWNiAJ1DmVWXGmcwbFFnRsiLJ1MkTJAmhdzIEyA2MOOI82WGxydQObXP0zwibuFZCrmR/ps4BOTLLyiAhl1SSEEh8RofDE/YKfPULxf6EIZSVonL28u7SyCFGedZLxSY/DJ1ej3VfThl9tfLJB8MmGE8Un3RyjqwmfPNPhk6t+3vgkOCo+CU4In4C7AWb/nxvaODbMeHQKZkzBjCmYMQUznpwJpAgzVjVgRrkZZnDYan2b0m4FrmHfcQEOxDrZmEPoqx19NWi/OMixqgg5Vv0sIUfnFOQodECNY3T8skEO72RBDr/2K/lOaTR1Mn/qkNPUIaepQ05Th5ymDjn9xu7Shb8xJ/MHpw45nRh6PY1jnPqLPZlvTtbJfK/2a3IVwcCT/lzcwNE/Fzf1ubipz8VNfS5u6nNxU5+L6/wFfy6uY+pzca2Df+pzcZ0OHJXagaPOJwyOUP8z5cr5M2kIvTIk1z2tkIDQXkT2vmoZV9mF4+GWwF3/FcjNoFt75fovG1EusDPopwqcKI2uSKuDuDkVZXaws/V+5i/6qZO8pMsH3uhMu1Fup16gGsp9cuxEC3xSZ4BCvtou2pz24Io5+Cub0xj3zIXETswOh0TqHIqV+misiR+JNcuDlv4ZG/2Ape+Pl3Kh2b54lDqh7AKIGZUYA42lvVwkh/bI1XQ9IJaIafHSmGK5nS7W2+lCaqQaaL7QDqQondZ0px2nIR+301Ev9TRuqAtoGjxJv1xd2g9CD8ZDD8VX2nu6q/rhYx6k8dKepJc6kirVkulgIten+5mcb5WT9SY9NN3lw/2PPg/Af36UodHPOY9zzusuQcac7TYmVqmXiZzrdHmcTjGXjqaul0gedWc1ruYM6j639MCPGVPo1cN4/CAeM+gzmkEBV5LC+H69hBLgUCUiqVCYzMCVnoiRBgCXIeIPJjNYHKZz6AB1JVVWO4c4bxqQFuAev2BUG8G1j1D5ANfX8o8MjQFp0QBVxa1y7R81K5KA3RiNCFB57ehDViAOWheCAPq+OBcvSI2TLys6sRUVDtxv3T2W/i6b05ttThOWfruNt8PSt9l4W+UORNzqzsLW/USFDWIDabLC2ixxeTSRPRDYiSWvvqtYZnqoZ3MSs8z1bU4iFjXquysNNnId5A7vAJWZDj5yd35Yu/NGdICWKHJKp4wlFe6wmHqof/AuTO5WBCIREs6mIqJMgb2DHp1dRT8PNEJo+ihVEVajGOIWq5Dnza1wOypoB4S+WX5q1AXOJV3UIW4H1cStkV6cWSHRNmkgyLFsVdeDAa5Cb9xayFu4G1MbxlVHAbzESkMKt1jF5R7HyOM6yJRe2cIU/1ldhsqo6HDKnTmi/oVpFepK/ENpB5SS+CmtQVmVOXX1WfzTcdWNF5R+R54jPNfwfCZ5FPJ6MI3G4g/JLNqhTebSyNFS7nHUqYqsqMI9XKWIqgx3qxRSB9gXQb54Uozs/NXJ7jAzih2+oY+1a9LD9e2kTr1K1EZnjL50PAl1DNvxW6UujcN5cwkh85xCgPkeCETMGS7U7Ic0+zORfQl37TPPOacyOBLCGUqjDZwh+0bSKpzhtEMIS8eVSR0U4Q/1AJ+kSDSLWVub1A5uQDe0nFYusu3g3gE/ZY2GSnLt0LTNzBGeMzLcZ6iTXfxP4GONutGGnuY2ZLgftUfgLxldb1/JgRXOhKW9U9QH9v3dlZz/YXy9zNWK01azMQ3I4OrUgDxclirO1QQiVDAPQ29zWsalqvCbzSlX9XoOZmcdOxyyXJ2FShzWHIY0B1LigEaJlRhpFJzfqHhcBphFPsawX9AKjObAIoPHCNojoEZw3BxcuhLDq1L7V89Ux1uup0U5QdYjmMVLQpQKzUAVmbgifq6SL/q3g8pJjcPQtzUuj3G/GYSmwBmKjizQQTuOMVvFnF/NAjXVMsFPIk4ZJbACdLDP5kkdWHNQDWXZeaCKeaAq+aUd1iQQwaTFhSLXWiPXDgqTquZFHRzA64KY7+mOmQB/if0lO3UgP0J+9hREKCtG1t+4E6zKDj/xAESQh7I8FosxvR0dEewd4xqheIfrPGO2cB/xrA2sMI4bz99/5+Oh3IlvtlBpw92b4ccwVsJVd4/VdpzMK+l9CDZwEnyNVvsMSxO/cS39h/Nr6f0acfCka+nv9UzlOC8lH2hcSv42vlm8hCrY28jzS8gH7CXkFYxguYT8rYhLvlxGLreQexi5H2m6iDyvPIW2SWVpCC7gLaMOeUXkfvzrn58NbOJmcj1DTEQ+RpNOP57lH9J1Ir34orQy3+bA9fX05u+y3PzNToh44gRwJCz+aOHm80rzzec9tfhjt534lef7W648HyheeT7QcuX5iJSiXWLIwMNs4GQ3kNkIJh39WvLWm9r1AmLtx+YLiAfcPeWvMHJVN1gWK6pjMYKWgTbdvDT4czxFY3iMNivUdefOSonHPgOtAtEUIzHGtyfTutyszS1UA7Fe/w0BIe5PKouAUaC3m7/y5NUBKqapChGqsK/UVAd+bq3EB4znj/tjjsUYSqlvq3SpHQPIUfjPxaB4d8SRhS33QqX7XBIilrJxTotRbvVfymikzspa4nS2jwP4UsfcbWR0hRN3ki8RqbRpT30iLaOFPmwCvqv8BmVg6RIRQ99ZhDMDiCejykEEPEQYHoGMIbQVwyp+UBQI+8EUX3P9XFfkjZsxXjqOyS3oNzXuPp/wJ919vs1nl8V4O1zOdIiMAmS0p9xgznPS8ILSqxAHdqNRjNZ9Bk9oX2TvPb7Fw+9Wj+HtS3BtsY/558McDZuU2F2I+Brl0WyPgFTyl5bkqnMOfqSEiUrjkR9/aJs1ipN/tn99WpVabL1ldvY8iJitptawusjfwTkAwSz77ObPff/A/9x3wbXsf603dM5Zt9El173gBVj1RBeU9hrsOwykVQ511uAJ9m01/CdGe79UumExRYNpR32XLRT/ntfFLeBEd7we/z67pE5VKjBmEN36LsuLmaoDAp0vapvSCHzwwIe3G20o1e6m4O7GbfMzld81AQj8PEzijf/z1YClAbI9G/ADyJaB5Bb4hsQ39v4762j/NZpXDbyl2tn+1fG2WxTS+tTUTZVjdtN+Zn+lqY+IkYVt+fuW1OvaRfF/oXK70fCr9eLxR9/buHh8h71o/MNyOLCETn5EQttqYf8zGoYryiWTmma45/+4DDWLbXhul0XaxZkccpnM9yY0orNSHVrCy0IlEcf0/l79KA5F2BvRd8ALXW/Qt+RpI+JP3CYYjM9S4XGPbGwa2ANUGvCPeYIIEn8PC07avUxk5sEHs2shrN0NaYtH6mBmfYKiPXVLmzlSvzYxuP+e63NVJs2gQHvcawjZwEg9Y9JBhNbR/xF+SlveZ8MvHKlPLDv34tO//oX5py2RqBOfunkb908u6JR7rxts0HeMUO69dvBxLzUANMsHid2stHIwPvhqVRQ8+J9JPri2gZ2SXNZfZPFyHc0j6ixUZ1jv9X/EsMtJvgTXz17ls7R9T/0L2fuoeofZ+w31vt2w/6D690Ez/If63wX6Z9S/H/SH1P8w/AfU/2n4H1D/DpS0X/17DWRc/QcQZ5+qg6SqleuUkG1IcY54DyLSUF7WzEYtqVH10/MqDoj3M/D2iXc7sorz8qK8qoF4P6U6r9rQep+UhWhVLo7HvLHdT8U8wIE8ykugDxNins1LOlCgH89lpazTg+ru0UKX7+Y4NY2012ik6BIXM7BzFhgwxMopwYob1SkBDdTlvEwJ0JoTwWAZ6W40TyANjJVF8WsAV5KSMpuq8RdZ8+Dpb25jMKPU+A7EUd2HkFcB5rxBaJYaf0FjMA/+QuFPFmvO1BF/6pZJYZ8wJmgsAv2NzgJKYdPMFB5xZnoxq7y02lB6Ydu5KYTmhMMZDKSVDIyp4OH0Swc1aUAhUpUgHS5VWXNDMlbDADZIspyM5TUF8QekWSHX3AH85cYwdnETP5n4gKBPnzDxII/4X0HoKnDFt1wxZBxXyK99Lggw6RvGQvkKxmgpFhoJcMgMBK8hJwLSSwo0VDgiiIXPkqMBnQ6BWP1krHb8H+iGVBjbxyngDrBbh+d09sTf1SkMzzEFF5RQYQ+jxmSnj8bfQ6hmqRMUcd3if7utQY1/IOnL9umH8uTbp0PyFDJsh77TCcbp4dSD96B4sdAIVg26bfyhEad614xMIKVMP2mZ9XIOCvA4YR8nLqzXhSCzu7ZcB1Be5/+rHXYnIOLEBACgjmHLByb7mIqvTb3BtKLj1rPjcFjwaG3ZzheXtl34pQVbpDMqd1J5F2OvF//1ktGvzvlnuk5Ntqjk7qSsnTJPOgXws6yLyXKj/jLvaBMshbPbzR3qejlBH7oFJup2VDxUGqxP1N7j8bpYhCHxnFxwkyEyDqvazBvKKIKoectxXEYmDruKjpncJDLCpvgh8FCeLZ3YvQ6JwXfuxgB0jzU2md2pWfb4W77zb6ufu24JNbw8sS37I/n3FZ6Umc3HrheqYbPOMU5qOG1zXYdQtpFOZUoBHOQZsjp1JQ0uB0QPau9ptiU0oW7MEVyONH5homPIjpSkTH5bpCSLK5ij+Nj4izeRH/8EY0DqpznEyAEZlXVOQ1lukQ5f36iunwNkIJrlYWmDn1sbHvRDwzoEf7wucXpkuMlye7Z/wKRhAdUYbjd+eJEzIQwRTmxKK4pz6A8nvKXXdZXyhVYEIdcVT8UqPjUYkhHs05B8qiierv5J2nE31pLx5vfJIguGXapu2ijEASbWqFafuBO4uJGYt90661Sjzt0U8k+89VYuxom62F+xSxeltdc3iM/pKkZAcJx2NgUTCoJFtz6BcR4AG8lkCaUPKyjvIkbOJlXBkqxSYMkKa9YcdoMvappFy9xZFMokioeZo9n7t2MeBR3TqOWSBr325uJECrqdR/k/Nyt8IQz8cXMTOjNf/7m+pLJDcNv2lRZgGVXWKZRBtIEfQzw82prh7zla9mZMeIW5E6pHodc17Jng0DJC4/+8Teu/bZunFoyU7Ti3oNAQNJm4t/v8UMLj4zWxMWN9qrnoigJUQMtDHpXbrAUiHiaPcBAQ6ss05g2cDciojOHsuMpF4LrVaLi33Wj8dewQAK04I+osVGeYnfs5zpB1SZNcrS3kX3Lw6+WQLWaprjYtiRWUeidYy7AZVtG1rjqWPfj08T9648QPlrh5aIQHlpcZbbwqG1sMulrJdgo2yy7YPvyFv3j5JYsF0mKab1CudWWW7Hx8GpWx3N8Jtu70dRrWnAvQMYy/b8nbYVyGxoeR7po0hHNdWsHEE7Ihg9QHkyY7Ys4p8S4hGaiJCNUp8YAwasCpsRMjYo0qYtbxJdYi3+XgUvMIL6QONbVxqQ1V7MltDD7NACMxVBMSdjgA0tEb8SPaDLzoWBptUL/coB4sUL8OqmXs3puVVfx4i68DQgN2IAD+Bn57mjHtLDjceQLU2lhn9gU1bOqLZUZcn//KW8xY6waAzha6zeYsBjFnHfDBirJuGLETpZUrRO24M5Bp9S42OiQdsqOa1NgJNycyjgNYkLoIaZNuOHHSA2cgibn2vVjBYdtjm2G3huHBbidvsrBTwWAS53olXqNxrtYk6/RpuYaNaMyFGjasxCGNQkoc0Ci6N+tDmHr10BMsIT3N2/npNOpu2stP++QEgK6uSNPEY2n/5nQ6U6cjDVVJHmN+tNu4XdjXxgkA7P7DLKNn9aiDPVyQGeNy+mTXn3rRYb0UWUENZMlLvlj5n9FAyTOY8jZ0lE7pdq0XYxGr1CinBgQwOkOb6vMMEd8rwoFeww+nYh+6NtsHe4TrrviziNa0t3FmKY+Cid9FRWKA7PjfbzuuaP8h0f4rP2RSnnTIpHqch0wCPWSyj37GZ0wipT4a2TMmkT1jYumfsfEOWPr+SM+YRL/AMyaeO2PinfQzJrxSB/KwaKMflojWMyYfLhXPmOCx7RmTjidwxuRzT+KMyYWTjphoG7jygR4xGRtN+UePmKBBOGIC9+hHTKw8HLQu5AD0fVHxiElUPGKiEgNJ0SMm1t1j6e+yOb3Z5jRh6bfbeDssfZuNtzVyR0yiJ3nEJDpJR0wgb9OhudiT8ux6atMRk+oRj5hU+YhJ2O6ICSQ55S46XPKGGTANk/qJ/WT9Mftj65ctNojEdEjDqTYD4t4fpelP5iRKZE+iRPYkSnSskyhvweZ6fgol8Y+4re4VttUhc+231cNjb6sz3UdK9oHTNaSULNkzhLQoyoo+J0LKGCk5txi5dSC3jkZuVR5AHVIPnzOwzEUuWklOzDnwg9tA9464gR4fdQO9dvMT29Dzjr6piNZ56KDWPcXgiHuKt5y8Kuh7f1qHdpuKwa/ppuJdYRmr9wr/NRZ+76oWTKXZznCUYGt8nb5+QrzMmwjxuzNMKxuz6gpUwb7W8qMldR6AvmvSyATEMXtzCKspRgiMQjU4EQ73WHwJ9nSjW+wZqBBLQowxKrt2+fzQk8bu0XP2qoO8OupFD+4qEE5Z9rVa8tXDP/02+/1dXPO/Qs2tDZZ6yZ9wNFfPhkdat4PbBXebn5YvHYSZDdzE3wpWq4rd+1BP8hf5bw7Z1Rr3MVZKKywYXEUtjR8q/LDr9bzrh3gcEhFTIlD2hMqapGy1Sgfi9xAsMj3SymvTnsGkLALKHuYBZLJiRz9KYVofRLGPpoGGg2BdTMZkSREji1MmuLHMhHqjS149svtxH0kqe3ZPPM4NzBiQyUkublv5JRxC5RdRZdOe1J+AsLh0B7hjMWCmod2oNWPsXmCXs/1HMU/UJ6iTS1a2qpC8uZpWMCQrzJakjIpFXN8aersHDjNRs5LGd2H5Ii1EA4Rry75xxZ6n/NnX/5V3Ufu4mH7hykS+HzbBEu0vAkehqiAtNzDzhQ/TwKlpVoPATBajzT2TZdd/sT1CrWI+33uz9olbu4U8FByOvtXzsAYDFm4ccfGwJpKhPpAEZHiB7xEZLAAG2PEBSU1WEjM24pIEI/rpoHkwCBB5NgZSn6PxhyS+dw4IEn8INE9jeBID+S3Uskdc2cu17BEte6HmtUzLXi7BiL4MNCl7uea1TFM/Q+Ov07KfAYLEXweapzE8iVH7N2Oi4zxodLBUPGnUjwMqX9TjNvbAkR47Z+WWnzxCIj16FMHi4o4e9evJow45eVSJv9R07Cj+bzV76HacPSsUf1mIHgrC41cKx4C85mNAtUMdQXnMyCmIXCNj7ENvYzgGhV3+EmGLV63bWc+qosHSZ4q3oss0VEqS28yTUNUG6+iiJZ3rX+Y8a9yKN7yG61K00kOlTVBZA+psnV/23vuu2/+dP/4mG+A3yL/3LmnkpHb/1F82Y9P90zfd/0dLcov9yB37di87bcLw/yuXTNR31XdRefdE4tc0+OCfjVCghWB/49uLHvvJ0tlf4ZL9XanmoZGuG4zvRCSJqvwJKJiAbeFat/UQ7o6/LgvDSizrXZfdDzg7HqVccuUOzeWOeDsi7OLkPvhy7WBThdoVzBE8hMCQLLMiMw69ABHjPsfKERUCVrF1ZHwkwCxKTHPHNneocR1qWjrU/Ip2aMcT7cqq9iJcqrpeDFt7MZReDJ98L1aE8zDzYbTXyHWix/zipyRCtIj4ODj6oE3f+ugv8xIqjf4y9e5U75KhSPo3rQ2mcvqR2CP9aFZhzpURmzATpzTvlOadGptTmneqd3/umrflKPkfn8gJ+K+2nIA/WCocgeenljPwz5cTIoz7rcUETpCqasE6cGM2Mf58TejHjyB/9yoFTDtetAC5YAXp6VsQTJXj/3poKFIngINaDTdO3Afx15DZsU7Y5yfq+4sH6tEwd6J+nezkoYRLZRwFYhX0KdB1iK5CEn6Gi5NFWIlKHBM/hvzISIjRkFrt6cbTDHUJhVzBX2wSgiPMkNHUs0k9MpKIStLc2u+aYFz3E7Hy4+KwWNP3SVPZ35aOQEg4y0MQpgoEYoMHoaFLIE8wL6V+NiBl/KNnoif3Tkn7Jd5AcYXX/uWSSvzN5iXe/8PjUd8mqRTfJqm4t0kqR3+bJGy8TVJpeZukgnjiBOIgLP5WYRkZtrxN8m1d3q40PjrFk10ZjiI9KpDGCjpOE5EPI0R87y2QKe1w7lMY3Zk5CVcGOzMn9mLKo0/0xZTiMPkOEp/8F1Ew8AvC5CnPcrH3mUlsCH+RDCcPfSc19rJOZ5EJshdh0+f3IJsQ9ux6t1WO4Sedmi/p32aMccXty18pJdOOlTAwyXGHAXa8RTjHgdcPcZwXPnucFz49zmv4QGB/4oHCRvYBzgCCEizCiQ8YBoch7OjhXXU9cfM9kV6UXuKyxH4Eu5ur7Cu9ctkepfLHlfWkrC9hNzfx2H20YxQ7ElbbBDzSHmEdCXJWYq8cecEIDPZg0LE4B0lEOPPYn1YxY8uUXt6o24fUAbsXn0GsYv+BKkknRdiJxbElNSJ2slPfBTNgLdOdEzid1IUyusisRidI9kkVRrQI9GiPlLFnN+buCs7sJnIAq550UGTT+EKGWoMLLhnVgl81vhkLmA36goQhiw72vcLZLUtsmcShvoZZsnHwHVbdvwQrlz34AP59b0mdLZyjGf8/dmP8gJybCuzpixwI+LtRD9ily6ogQjgBVIFMMDle0b2CQGyTcoAkxTxruHdBiHalUX2CCVGd6VH8fd33zLGLHEoZ5wZIQ/9XRxRob99kxg3/1W4qnOgIi1qWnBnVfxGDreyRDrvvZD/2WKHqxiKs6mAtUHiiSPtWKt9Rl66dkK2ol6FHuZNRqU4dQiHLO8l5Z+pAt0cyi0V2w4oqEks1Ds46R11tX7JIurkKWl9kOMpm2aRH866gsErjgywxGXC+Fw4zmAL+LtUp5PPvNLSwTebdIqG9Usm0pp/c6aM46Xf6nrfYgXgKX5dJplOP8gDxOPV06ucQqqEKCO93zFBWWEN6H/VzvM5X7v/484f/8EtLnIs8Wz5Qxbmk01u/MAXyDJBHsDWy17laLZKQa057zj0H7nVuHvLCG/zZt566+wPORQhyI/mPn1JpQ7/+h4qOPfzJZ1/w2S9f5Fyp6Nd3nn3rV7787Pucy3kIffNP3n3VF8/42GLnOvrDz7n/1Alz1l7nOvqbDsW9vb03L3Guo68QYP2Rvc61dNQUdbK4fK9zEdbymS20uJ8mN+ehhdvu+9pjb77XuZL0w+++5943fitZ7FxXjbvX79y6dsvr7nOuo+/o/xduxmOLnevoL70CqP+Ze53r6JdLM/5hiXPz5gwQ96+xUujc9NTDa1pllHvmUyY97fD6dLBN4Ok0iE+JcW6eJTmXo68hpD283gpuF3WzGA5wjyO3GXQ6zZC0dOrhTxhqid7No8LDOI2wq1FUAnh3OzOiBELqlq9lduiZPCbfyEPpBVYrdMp+P0dnD7SDKHgqQ3GUsAUzsYh/jpRxF2css8oTy/UQ58o/FBYOLd1hPDMejqmqwaj0iyouyL1lqBqjqhGDGHOuN9G0qZp7I6lmVKfKLmyZ6BstESt+o0kjzJhUnUgxbfparJ55CbCgpBLaU/vzAqoYZsipVW6Pz7CVJW99s1PCYa8KoAWxw7jxHHYq2TlAE+Ij9g3Ah9MRktYoCALyjA9hQuFYw45Hbw9Dt3ML98h7t1N7t1N7t/1o96S9274T2LstJT2TNm37mzdt0fwd01MP7rbp6XTWVt61g/aViY8vqTu8Nu9o27d9YFbfSd2+vZRH6D/maCz+H10JtJKYuLGFWt8d3/4aZJPZdX+GXA1WOT92u5lq0DDx4yCkYoDQXUY4ZJiTWLS2XzXZ/IqrJiSwq6ZPQhv6Y4WVTGBHeAB1MsyOwYIlgFDzfjCKkxeBAvnwBDuBLmTg04UMfHYhU5KFTBnuwf4kREhjQWPiXWJWqmgbdomAe/HfgVjA0A3vcwbrdRx2I59fhaqLBSL+iX7YJSisdb74KwLzHcIPJyF8DGDuwKND/I/6vo85rM0K1AJoVUehL0+dLK4+dBB0QwTFAWqJhMBDpapdkXZQIHWo15Nao2hMW9or9bRzF3XmdarfmUQyjQYN2nNZMhrLwl2cYVXaxhLD9adO+eRPLd7KxkecyUNEUfV5mgldHVc5Xlc97eDHYX3cJatf5Mc+kiRV9g1grhdfjNA7Uo0aNaKCDd3yJVRi5QTFKwf5KjJDq4YVRQ4dq8omtV8m4hd3uqhHCVVUgQkdkH20BPVzLalBzXDOVql046FbHqBAIHKh9IlqlOLC/KAxjT48mPchlTHormaHxxipzWCdLv2Xs4P30vvx+75+fFUAn0S4TKwHH8PphHkNQ8Kw+PaDeI54D8A7ZEelseaFIfkgDoI/U3IWiVke4bCzjMhdqZeb3UdysQh5PKKzZPRaO8TN291bHK6F/+jxcAzHvZ/rcBRTYJ8Ox1iHY6cOR3S9DM5qy+D07eCsyoDUbjesbFLuXpA6WJzrXCVASyPDtq4rcYiPvrTqkt/h0h8raa24A5H4xSE+H7NB0UqmxjRrzmoYyzhJSUxtMLNyuueWEL6OvKz6olFBr3xyHqTlm/BYuREnFeW4VUmtvwRLsT0k6WOMGP5pPAejqBUkNi1lW4PLTthk+OrtT9BkuPGYdnw1x6Z+fOv2k2jFv237cZgnLyhY1ANnUY9yi/r1MKi/ZvskgzpadiKWzdVH3BDYjiLsp5woYKd5O0CrgKwKuwEXHH03oH3ddTPghSU9zsWOSJ0e51KCjC7QPI3h2Rh46tT4fRqrU/sBYxPLFh2sCJUknerE6vTVLjOm1ayLmnGdpTjonZ+6vQtn0lVK0WDbV9JuRD9lpfgvRXFfbAcZGbEOW0sxn6Ej/hkaxe8AfmaObsxediN5o4mVw5LjjFer4J64faXaM41p3cyQhqO5wFxSX+cLpCbyEL8OlVHvX6k3r/ffAKCZLSreHqqqfHaSXOIOSHzQGz3hs4OBKGlEc5QEKibYgJX6K0EHCLcBjwFkQuMb8NE6QU9NhxxI8Fkx/j0enrYEUU7a28Ib0xiv9mtlOmA1y5IyGllqa+L7XiU9lRjUQ5g6ua/+5pepr27P++r1v3F99dAx++oNv0x99ca8r+78jeurL7b21Q8AN9vwkpjVZlT4Cd25K58CX5R6Ug0U8zLyGAjEE8I+Db6+ELypGCx5/kdJ88z1MagH2lIvbEcczok/utkRqV3MvpaYjZ7Op2twznJR53UvfhWaqgEa2oSuThTs/EML2AlelIMdPEwCO09v9+G+7IYbN574N/uOtuh/zBhzU9uvWMGu+ObXvkK+UwX/7QX/toL/0A747xZJwjhF+X+Hp9P0O1mf0bjFV9wPKAmh+9UL2d6Xez+Ye/eI9x1Hyt47mEd9RLzvbBf1XW2IgvUyZuK+H/AbqYnRTPAgbMOyGQ8YQG8WVVb7qWmHQDSyApGHzOStZFD3F6j/YbXPhw105Fvt077CE1Lck6fIEU325rbUnW2pO9pSb2lLPVSaRGXal4yVqyJyivmTB2CJq2vtbEirQ9cQ4canZLz4QcTItnpu/Gzzcu4dMAXrEkYKuPx2JEhQtAqnGqYzE98tAV7eV37GBeR95ed95du+osBx8QHDJTxgXMsC4WN7+s4j0HccgX5Lezr42UrnNjdODPSEBluyWyLelO1gBiJFyo3K9svuupctWJXdL6L6DhWQw6VSnATiEnYSZpWGk5A0gAchU0sULigNs1PmR2I3YDeWvskeuP297wkuzb7+ykaOoAeZf2nGR32KNHxYKwtWZD/58yZyZ3tynN1MLcTTEddrIQ+3J3dKqZsyrt6kkL5sy2jWs6KFnFTgDCC71sIHkggOIXS4JZSSqn406aWj2ecrLcEzkw44Q0gct4QOJfoRpfYFn5NIS+ZlF7UEzZOXQ/0bM9PcRi/bNg7r0MiKlr5eaPt6eVIW9+qkx3b29dyr17O/h92rbW8vt73NBhiIfBKz+2Z2e9ndye4p9mzHNHZvYbcvW4idbFkY9mOB/8F0eoa7nSo3wvlxZWWXof7se6XLkhnuNegZAsVcNOjRxyvLi83JSsgT32pbJxvWf8BjEk+/J0/X2KdrmsKu16ekv6aDJhmg/iYWdWfeS+S8B+83UHVT2r+2iVU+9cdvv/n/s/cf8HEcV544Pt3TM9PADIAhAJIgARKvG4EBoBBJgkEkh5QYFJw3WtLqvHLYwUgnypSXn49pUw7n1f5PvpVJ8HLQavdy8jpt/Jzl+2/OOeecc3AQzr/v972qmcbMgJRleaNFYbpyvVSvql69rnZkvsyXxVEfC5V4QzG6o7DD7TIisfpo1XBaj1RWSrfyccX5BMlWDhfDMd3usEy2yfYWXUgPVDJvILbI95i3bYRa4tV0K0Evb4R3WMoteN8dkLpSJsAj7QCPGMA7ZKQJMP54zqQ1Deong7R8E7DzXcAuK9hsl+/W59vBRvJqmifkveqNAZrD+baD7kNZuj/Nw9a8EX5rOx5biUdZgKjiIQEX+Bqv895Kq2/YrAUvkglt1Ecnq6hGHGr5dpBkMAv6vw3YLMoVNgN9mwQe9Ar9WWPGFXQCzxYM+GeClMCQT1j+vYQ4xJT8vg4ObMmi8V8MDXLg1mhk4WdVg/9/fK7gh+rrAL6aBf5DGeB724Hv9cD3KvCE2uoY1N/0kkLNbupSPlv7xkwazNbFfAnTdCF7zX/B7ydUbxE2m8MZ5cVSrJoUTd3aOsGllUwV25rCpcWmpm394dJ6TIXbWsWl9Zp6t3WNSytzW3g098uBdFvCV7A1+WFkCQPPBbb9rMIflptF/uFEt49pcdr/SDpAV1pExtKqOV5taYhPm+fPLCTRxYcTnkJX+VZnQbYc0mOTgUPhcbvSakVvoQrvkwK1/MpKeJ6hfeHxw+E9CBXVH/g1UmBLcij8Yg3RGPgQQv12bpGX/kfs3CJkiMcWel9nyWHeb11dMifaK9YEALpsoUlzpY21Kz0C0lCFgOCk4z5eC2HgNVZCMfAePRxOcr1qi88CfCakQIPBt2iHfYjYnp6rdemzFTATLQQa8OTa5JKmVMJnqDg8FAl7w9XuA2PzRFrhuGclfIXBccdhJVigr+bqZUAK+32G2TKuMdsIJSAwEIMWiN9OQWkHkdLCC5UHqr/IKGI/zhiuj6BZv/rnPJk3DkSGuS1d9XNyTuJbl6xioOle8yNoCs3+xDuehGizjL/qbZYkwQmGLy/B5mXLX5XdWm04/TKmkYvN9X8KRGlj0v2BnmBCulP8nk9VOi81JNdg4HIjDXjKwTL0DKm+XwHw7UhU/QajUGuL8/UF3lTwNrpLRld4KOhHmKme7w/4+91BGoPFZ3KfvnoOa5irZyQcTfWi2i/WE8Le+0fptWSvJfE8MSY0ZA3LvIb+QLBTbDJic8icrIsPVjELrzDEbVKvheI6hYqhqG5mn1Jtmd4NARKSwH37YiO8q7Xlh+3YkegHEvP540H1A6SAhdPAqqR5V6nMSqkeIGU9nPpq5uXUx+tN6up+1adQpbE7GdJ1YNLTqtLvqvRL4Kv0b6zivlPBFY30t87w+qSvGcGp68DXKQW/9Wul51vT6rNsl+e2bD0Dn8IWbAZbn7RaqT4r/V+X9jUPNXGfe6jd238PMWq59Bx6A6NlErtRl6r0fR0u8ximhYVU95crhucyVC5XP2j0Zaz6oVZYImrC6ofdQAwoYpmx9YfvvunY+vc03/np8NsDZ3s7gDZ4Q3nQaue3OJ/WvpGtWdHRzRuV0NhuIFtxAzYNNRxyhOUl5Ajj72XJY+dmM7I71K1+oyqan9/Ws/1q8DZe9ag73bfxHmCDtsqfSiPNc1Iev6i/5HkeUkZC2g0rvKsuer7srYsPpgVN1VL1pMi0hpod6aETPg7m5uH8R3msPW/zv15oY3u2h5IK0oPzKgnRBftOEf7sgjlSsY/OCsmglPQUuZ9u6xbjtVbmkpn906EZ0aEokkFeEDVIuepBlTJSYuk9Cx4gh5svtsCZgBUiq3AVFew1KSf16I83zUnhEejiZKgSGNjpME63k63AaliR2QZ4t+vrN9spgekIDdZYy+8PK8lOQSyXjLJB/mM06g9zQViWYYrtDtnSSMbQwg7NHgYh0l3oeFTGACVSSggO1xHjHD8o2y4Qh53rQ8luEkK2JuNExW5Skt0yuH4fCPHVwfp/DdY/Gazfsf6yTjohjZQaJOKDnmDjJNg4kEeTO+gATWLhuWM1GQcQOxTVCMDsACyOgLJTBnGw/sEH9AOLFzPUNCKj0avWaJmIz6ajQJmheWK9A1iPAENDd0cWXcSy6HYiamhWgrb/1ifWvypY/8/Bi8J6xLDOE+sRw3qkifUIQPJYD9qdyrdCmp/IJJMDmp9b3B1TdKuyo8HCN+NkFORuzcN4E2wiz0PXGcX9ElFAemTYRYad5+Rc0J2T4SacDDo4Ofa3i5PhS8bJ0DiZ68bJgQwnpRuC/E13i6yfkd1dFhcJP5WfrNeA1c1wrd6SzwaKcjXdsZHTOzybB/kp/FQNPGv6+1rDHXo9lZ33j26gQbQJ43N/2xkfvESMJ9LbkZJut62phJkJIR2qJxM2j42CDJNod0ImdSIckwAhzgVonxMYu0nGm5NA1JoExumNC/nh9Yek5q7s9WBTKAuyNnCXcjrIEGHZqtFhErcku2AIclMrwCc3uOpiV9qn2asG6wdySCt7JMdpZxpRXNHsMJefMvJNyVRZxmQHF+T+GvUpdSXeJaP1ZJdOC1v5QWBTbONSVcC33QrwkY2Ab/eAEyfHm22EBaFBOip3IEDFROjbFBJkLAGX2fKIbFckhj8TJEJFYoBImIc0EelEYlihHmdIJcFwMiR2tKifDurVmoLHoA6sJM2fssDOLC77QySUN44xDr1rSSrj7ADMUVzSbzVchjtx2UFcdsh2oL+duFBMJ1l30ltQijLkkJJKMtoNsQoQSyMTrEo7asYALRXVkSiDq+kYNB5HOaM7WDBa5TIoM49grI8hKd0FlDr1XLKbA8/mtvX/FSS7O8fvbv5b74t7esuVvv4BjI88/1A6dVlRoVhiUiZrfRTAgk67dNiXxMlU3mgu43XkemqbwJO+5P03ksBbuxF4VOBuxZVOpY3OMsCWBqRKGaz6u38Ldnh/JQi6fhIw0Pu+9AZ/OmRr6OMBf/880FWyviNivgj6gcAxXg2soRGEKhoa9j4UEtIE8G1cz2c//7eTt7n/H6bi+VH3fI7P8geDkHtnW7J/W5BGzkhX4PrefSYgiZzlVX0UILdPnORebJg/I1KA1K5dS4s3sM9l3lW9rbDYOjWgWQJltPQaXfLXbiQlqsuSeinSLsB8RgrkesF7LoZ8hH6DHFHtRkrMMTXjVX+SyKWwrXFfhEbUl6L845gnsp+LjR2tY+66z0tMkt+DR56WsFivRcOjQEtYzJdvVvAo0QoUd/ACDcwzmXSPJVYPh1kNLdM1V0MrCE1qiE4RwpB93GdMg9/O4AiD5to7rMHvz3mu0maAO52VRzHgb10yFwRdfY1rIZv27yfXVFwKp9+BzCpd99TUFptFK3IZuKif9j7isWzWLToYh8oDYWhfGMGuZpap81aCLtg0ztpL8MQoDaWgvMVp7zcTXuv9NSgfwGiYtXdFHfauL7ZDaW/vMvdlb/MiCGo7ow8KDVptXsk/EQSFq+4MWXh+/DPv8uejbgVm7pIS6TUgTOFIg0riiW3lAnMYrVqIhyd2O4HT1kUukkqUwEDwKEmRdhDWaV6aGlBQA6+lYrYc6/s7UsTSUl89S0rsv2yXmG90yS3hkbE6KG/K5d/vbd0wO9+6vF19mOYPh/MM+atyLWxX5VrYAGNYVcmKeuVIgB9nfY0sj5f2WZu8+M/S4rRAems4Sotgj7+QoESG5ohWg+kPabjU4GcZcmrbLVY/8B56ZvgKBe0/LT5CO69rEAR8hLUvC9+8Ga/XHrxoQ+KKuS7V+AvDAWLP8MCGDORqsmg+VD+PtJLZR9XI/k140rD+P/Asa5MB4OCpF9F4ItBuKfoA890B7ux3chhaMpuu/qoz95teK7CVQwhRzK1TWvcL1R9xJlg7wtP6dfTGL0BYok0kVA6MnU8LsBGgxKVDOCPjbTAAghm0btK0Wf01le8eV9hlFXyunbCUNDebZBid54+S5jg7bKQF7WhNQWF7RasjBc5y0P7k3r8MhDO+doRkDsZLPJqtfpINm9p/f+DOk4qm5WB26cvZqKnpjeshhKdob1SGMNowJqEfLT12Bb706ItfRU7uz13N/qlcFjlSilLiSCnZarmHkzJ3nsjIO/3y/0qmXyK2WKTGL2asLoZmaKfApQbXIgYVvVNsicuW8mSnlKrfS2KvhBWOcWrV/8lvt7hXOtqaSgs671Oo2RC6MuZICLlvpCW96ciuGu7BYxgSqB0V7PNsRc4IvejySWqiBLg1wyXf+6+7829gOIuUWdNsTAnbUgqAUKVZihYyEIwOkm8q91pkku2ucjFwhvmgfkF4zJJGuhaUTMG9ljTZDisR7gCX6LclcugnBfNfLJGKf06mCmTZhrt+liXgxKrHIRR5agATQiU0hVk4ekZNhbwide9mtjKSAkleW/PzCqS2+hsElMQvGuC/yTiDnEx+zCYTSlHBLpeYb3kVfr8tEzpfnONsNwax/M1fe8+nSiAegiG5HNm8H3XzJiTlSNplq74ikZ8sRSLyd9jyY+QzA5LxHJzq9FjDJkJ6VJkRN5vGAxM9MtG/C6OERfJmsLX35l7Q90O+/amO74fcosb3d6nxJ0EYYanY6YFqSpRAti+Y8qRYYIvXwDv9U4TMrfdj7KVj6Zm3pWfelp5cl0xCtkgVW4FyEtUPDKbFFefGWZTCl+mdPprKKmMPMq5B+bK+gMOG6uWrQPhPg0OZm7upmPKZ1WXWzfj5Qn7oah4nSyqjpjOCRmJqI8nzQehNIWsLguyCJf6yUuLnqVbTkupUKSlQNQRoJ6dTciOJhXo86fFeeNTeib56x+kthr6mKZyJ+rn7GksUL60mAxrKI1StVZxNvMwGlIqyhXtHJZoAwSHbbQ7b0YtF9GYMiaHgXVw3oHwx9z4kcZXPn49iZ3SZl4pv9CMahQcQ7SnXkuFsa733qllnABtGvLTbtbnttTdt3tz1ZFjb0ffPh2QYDC57+9YQGTYkZXdoY4unLdyGbeHBDvdc/czpdwsrvV4trKcVEoWkTktKXIB29c0NErRqrzH3SYmxAo8WyBvwUKJGrQDS8thhUEkbt0jbT8YYabcQIpP/ASkmIGfS26SvPYjQoN2COMQN/jA3osO6JLyWEkHN336vIlwlzUiLklIj3eryjSDW4v2EpOw2VQMYHaTribUHNLldyu1TAJ52JT7AJYpqr9Kvn4TjW98FktFtgis24H+sFBUw4EdxKkQcfztIguZgDbODNfSD1fwMQj7ipOAJUbSHXWIfZZlvPh42cFFApYS31BdsbxhKUR+2D7RVQeeANZh+P0hjLuoLj3NFckFdTOxio0C9hXC4yvVpxYj3YD3pw+NNwB0PrF8G8HiIIoRSEcQgVHvTkNqc2MgW1EPiVuljK3lwBH8XRpNtIN1wI9kuZWI+wkesJq+dMsxbzEZRbpSXbzjnjZfrec4u/O3uII+ZSqvaAQVyXHbKEOS2zkhEhy3+YRaAEUVcJdnNXrTxDb0krm0ZTVJFIEHTA2hadAfS70KhiE6rRVOdE9e4RpMJCXVTn5Q2bsVbcymddce59UkpMals805q22U3wU3zdbRTvKFQeGNAGo6SnSOSryunLdMSdwJ60GxX7e1qiWNsq+xm47tlizU+xMQhb+KzKxJMVP2nLqTHD/wYPAWKwEI7gQaS2PSOjVYEgMoHmXlyDf2rsiByorcxEgq+USdJaJemp6IitM2+4IBHbBaSQEJmKHcKnASShLkYAzapUqlngSgIjb6iTURp+kg6juUd06KGc3oYl7SxCp7CWOasImUn+Z4JSXZWFgHUYJA4xG2LQ/jyq3bEbIoKLKTP063m/f/bZd7/+h1bRnAgnL+ax8Fw8a3+iNj/5ZFSeGvHvtW/+BDp4k5CqFTdo3Cvwz0h83KP6C1/ITvraQjzHtHbYjm72uAt0hlNp7VId1utuZZbUkyMHMixVFb9CTGDValwVGxh7iByt6xyJOOR8lAWglVsnstGuvHp5RPejCN2PCLb+dxJYsc0h7Nz7KSSbl8LHMWADvyAFrXlyW56Me7Glw7XeYYPOMdXpWAMRuq7LRVxFFrVAyARkdH1M+svRyiECOTqzfJ1LZBI4gok678epCkid4hIsv57gT5+N1j/jUDS9d/C0QjSkjEa/2GAVV1De6raULFr9u0CyZ2wrLLxRIRMSiYkL1vsG9XDXLiKSDd8CQXTz5/J/uGcKhGz9CMTgzv7lwJ4ERnX/QS0F3m/m2Co2eKMiFHNkPap669Yf1UCXcctyi61sBKBCdnWoF0fg9HIlEVnm6IziWLj5P9ER4HdWiDVAvlGe7ZmTgH9Mb2viE/i/9HsH6i/Xvn+77/nRPYPZE+70WqMTFp/WTqtJDmR/UuFJ3si02DemXTP+qskkSlt4rnsn3bH7zhm/9jdlKBx1HgZWJ/uXa/su+9rbs/+oXXIQboPmIjsWx/PJfuVen2Q57SdLDOGuRYY4TULYVuBWS0wjQKdRD+gebdpXnu9Oc2bl91SobQvGIkXEa8yvmTxZdkmLusggi71kG23ofR01c+I5CAKEsp+2cXZ6vD96a7RJJTDTBgFgjnKSs5dpXNQDmFMKElPZv/0TDVdkRU8ZFkWOZ6OCNmB4kgHXZH3MrlN5pEgWjrRB5g1xdJHm6VFHIuRnByTQ3IQAZmUSRZbsRLK6FQl4FT2z+A4LkdYJWlvEG1NZuvLcqaYLGpzV7N/qaDioogOnJdTLxy0Fg7KQWthMdvCsrD8crb8vNzGEgr2oiyy0nE5mqlkhSYz+alMZxud0kanso3e1lZ+Klt+WstPZ8onU9kZU5e0UzLnRCJdlgNOUNIWqNMybaDOumJImfHFiHMbBssG0ZRMdcFgUTrIeFtb+cWbYwBofd+A1gPuobVmDForhpSZJuCd0C5+ZvST5c+IPyjISw89dbGY5bDMeRJ3AL3bl51CMNcV6HReRXgeImywoN3lFwb7bdnyt4ZdNc6IDEHvt6md0PDRAoNUeCNtBXZthiA1YHtr44ax5rU3VNiMb59r3MMW13bJ5gwbbzGswGJ/Y9DmWtBuvQm0uRa0W19qaKmWXwi0HBaJLEoinJb3UpyxEpniGzOpFk6tsIgcW698zf99/PbsH7vYR4QU6lGrTd+UqBqqiUa2n7PVLF9zsJUuTdhlGk0yRtCa+nNfGFWzRCh5b6rapcti3dng6rQT96Ot3RJSJLvtq+nZuF3CevX/z4U91ekus7jw7WaEIzToLWFuIa7GE4l010DweKGSW7xvo+hT7nVhaQDxHmsyDjk43Acsu9QuEdK88b7M7t3uls/uIAf4AcEB2c5Je7ts04W+ejdwb2Brbl4xt40GAbtAGCD6bQILZi265X9dKvbAVBfCWFHEn+1HzER33A6wTyVm00+KZrtISmbGi9GMrMJq4I5ReldT/e4WEmj+hWs47bc9dhVKj7q1W15keTZX0ZRGFGIJGnrGYm+Kl+HoyQ/Km+VmNO1D4OlTa0m/7mwS/JDlEnFTs9pIBuwOZzQMouRpitAzDlpOzO5Ay1ctd96OPiRH+1ZV49xuvwyPqsR8UFpjAyTH36RQtp3sqqvPMbm6SV01Q+KHAmvIFdrQqEjfA+bfW5H+B8yCyE5BS3a6Slqusl/W2yJbXD3pu8EYrXYMVsT9W7P/1CrwQF9QCcvsP+BLdFUZsM9E2DeWH04H1ZJHQgwR+EBg5mwgFZQYtoQhKb4cj2FiE9Be6CkxqCwZdrjc1xeg/SE67IHQbUOH9GVWSfJ8+Siwxi2ZPWLSYY/bjX7D7JHeVDEfdBxxPW5T2g8BBlJ+uMm+iG3gjUO2MWgJJbbB9JgP3EgZGVGHNpIwtYBkmfGAXmBJqpp0ZRgy7CHZ6rkxIiOeG5UbjMkIa27GjWSIglOtFe6mUEBJuUsX+a1YcKhMSHngjcT8vcqygbJ9YCCyS9RqcH3/9mD7LgzKAH9brgb0Lafh4G3RW6tIid/KgRvoGxzFtzG96A9mnillzsGz1gQA4E0JTC49ksSiRgaECu5IgBZiuyCkZD52PQSTCWp9AGF4OXnEw4qmAk17T189zIRe03ghSuHoKkQ81APlJ0NmjKRacTitcMAjdE9apPcIDqn6hI2jLIZ4Tm8uo6o008Vshx2DHV9YZXSlkTjVRyWA8dNPAQn5KhWmg6r0WaSKLrYoOojCUlVPdSRjnqB3Za8e5vaqTSOEGrNTh5z3zs+Zd77e8dmH8QNh5ZdL4Z4RPZYMmzrfKr16egd9rCft2/H8db7nazZ2uKTzsROpMK7wQOrHkak2TdlCEwia363wsXFA8gzgocUNqb00ojyqc4j34YtStauPJ2CH2tpi8yTTdwNoCYnpNFb0H2hVX4yCTjglpnW/2cOZufmFWptryBoeNqNizk5A3ZQXcjYKzXRmAFX5U2n4MxGhyGyRXWqCTWS3WQyvpSICpzwANOG8OwecT+cUxavIRu5Lp2V3o0FzOzie7uFjMt0rk0oAxpbJxX01SrTGx4xGe5GsVEr31+kekczIJLuflSluiA/gAff/22SKsqLi+MXJHOHf+I/53pE0pB/L/IbcaaDeHwY55M710Vo5V4lABURyLuLkdo4eMwzMoJm5OloiZ+dlj8zJvrrisr8ue2W2odDCoZc1UZSc43GT1tRy81B3G19BKLcWCC3XgDnehxOVtWLOVczV+S4B1hPM5ejnpTgAktAHCnDIbhfgIBoki6iwoE6jS0SiZlAsCa+s14SAqxbOC9YuhAVJ9n0Nt95SsVlknLRZlCKzmYatpYJU+gCBWSAoCzLnfEbdG1PzEpN9i3U0FiUlg4FddsqrhOtj1Ks0CGZp8790fSvLXT0eLWszj8fWYssu1TeoF+sSEmS/lCLIXEGpJeHT2T8zfnUbWtFzUVMooua54cFKke3kkJssawDGGw61NLRRdsgJgC3oD3Obf0gOd3agBhlaUpb1XjiZuxdULZRVfJWbCy9WgqlTNhPKBQnZOF+oeMESyVo51poLXoBQzqPegsxTJFYokhDQrFhaS52Sae1TODOCSTm9mXCueMmcJzzz7ZK5QM166TOUS0+el14oOUw+h3KZ/xzKZejkMjS5fPGaVfY09adgHki4v5luQFOuqm9cdVPRTQsUw4JC/8LENg1V3LlBu6XQLqm0LKm0LBpBpRaYlCJrkQ1SkDJSK1KwVO79Emmp1JIioCDFXmrjrNQuqRwIgVoiSEtZuV1USBZ1JR17SOxb7bF6JrKyk+bIAVLKAqJoZmd795l2fhnfdGOr+0XmLH52Utghh8HnTg7RMtLYNwKHDLj9IXo6WLZDdSE0kkNRPlaVPjNN6tDyLfh7YLRFpiP2BpAcvJYcbNGMHR1cCdmPUSrfMs1LTt1ZSXdt8/60RLs820ZANtrlQ0J1hJRyvCTDbBkqOc+xbA2/mJkFCuJPUilB6GAKO5oHuVOUMaFNcrz6HXZBg67AkukyS1RlGiPqg2vJEWuq+p3eGMK1E91MAxYbTsQNzKItQmV9CKQ+gt9DKsDFjskjLciyqA3QDht+c5P5o8iBGOozywHkGs1A9Os8hm6XVI4AA7JEcAmkpEx4zQdvqDcNVqJMFdHH3rVra2AaaYQ55IM3kqNMHbHMSWQdMwS5QPZrugNczd0GJVTabDWnFDgsB/F7XI7h93Y5it8TMHL1hGPJSRPUwH2wJE+eLtuAN3oVMvQqSlGpdZimt+NyArL7yS5nNBBy0rJCFLN/SE8Pye0YMSfNwOZ+je5orBKhevaPb5Mse4a0NgQlMiTITOjcXBkf5KAcldwHbKG/1qTyMaPiGEmsrCq1tGe5TPegQiX6/Gj8/Gj8/Gj8WzAaYZLKf34wfn4wfn4w/m2YGk0IZyCC30XxQpJMPJZM+PdSW2Y3nupkXAMnsFngIKGhMInLNAf6lTplX+jMiV3GSp42xxUpN9IcuBIiRtvpjDdDoueKrKxqfl24oSJqMlh3JkphM0hbxbHW2/nYIzMUtmk84Fy3V1boD7gfD8QmbEOv1rwk5OMU5cb+MRrVAhqexxkeTmm4QJPg7l50WrprlE2fH1U7XwoymJ1I35x6NFmArE1LEb3hAado9o9f5EwKzbzzLdNhuiSs5ocKrYfoYwZltUw6pZbDAjPuSec0sqg2WwgmPW568awkhwzkEVUaJarMkiy4HZXWiZEwmU0ocpjIoo7UkCPcNpYl3btwg3JIYrGYFF2gJYymAXho6NSY9p6WLth4bkfSyJPzeCYlJZtoguE2lsTcfBqt5+hHP2X6Mini+cNFYI38pbxxZ0bUKH6VJ6N4vDmxz9jI3HlqEE2qJ9RJlGCQUuIm4npNbkicZ+ovoIlaCKAWuzbDHe5FPTx9f2hgPoPnIrfcwo+HKIExR7jZQ0JyjLNX6yS1ShDmObqMvwvKmiWajTIiMKmpU2iPjceO1eb3OZfZhx6ii40R2phItWBEDB0RS5Lnh9xoQjKtHlX1CyxiVaRk4Syz2Yhu9osO09BhWiIwwu9KFYkArbKcpmmPoEjMmUjEF0x3cMiBZDbw1fxlNrNFEJpJrC+L/OOrQkxxxo3QdvV4Fqyozyh5W1pJLcUFR8VJCJ4J0piTsySnQpgUbJAXlf8rOrp1GvE+2EcoAUVnTSzI/uaQ1oSS6hqNG18S9ddnbW3kSFkLrLCWlUpyVJlhpslsa7nWWJyzCVhEJ6EFvSi2gOfzOcqVsX+B7HfMPg7KHSft2FfcYrZKXDEJwZSSMrjE4hIqawtd+Bry5D70n2ezkew8NOckrsth88ygYDW7oenRN8T1QLn1urd7N3CR7Swq+y/YPRLGjaJxIzZuLG3UvOxxUTl7heNNBX8RTV1pyQH5elPeoZCJUjvvqFDjDbyb6uRdvIF3sb3j02oy21qc0aNu6SC6dJhT3uXEtHZolmGqIeMUuLYMMl9pKVnELmtMclnm8BfUL2TIHmZonlW/fOT8m8ikuQ04MxszQSxhhQkrUrlXY3bUSff04LFkPiSMu3kAshOFZYGHlLnmrJtzB36JJkXp4p1tJ4I5N1XZSPVOf69VBTUjRV0c6AnOnFmvuUCVuKMsT/fYLwI4KQ1lEtinGaVAWPRINFlBC5rMA1Pyg38okqvz+t9prvyYucQ/FEDyDD9WBRlfgZiRi6u6BJVppKYT5vviWdB5Ic3/MoobqTNL3mmZ4AoLjYZ2sGmtUE6C+obTyUDfsldG2FqEplJV9XMsMueN5ov23oMeM8A9xzFD5usvNT/mXwQ/5jflx8JN+bFyE34sbOTHCvkx2caPT7f9tyk/VmRS+bHQyY+rnyU/dssOlLYF7JJzAkhB3rruWlB5nHZoex8+0anvKbOxzzS3IjK3viU51G0nIXmiQdRnHObx+hZZxn7rw0EtXP/vgWIceYxvtge4YjtZzlZKikWsWQFlYm/M1Z64ihf1EC1wgaEHCTLXYJN5CZXqdkNJa4kihexRj5rxuZxRwUpJ2SRRqjK0h1JQy52T3dQfi+oMkdYeSU8zdOnCxfSME9TnA6Y8GYjmPA1XAj6vtJTqqTKyag1bjwOHIslXhArWMaAbtqWkSOx6Xp7EePRfSGYofavqYsV+8FgyznBBxNAe7zghSxwDSL23KcBTUkzmWIX7jQVjF9LsqCVBXSUPQFggl+bJ4nlV7aEJaRcb/+HO1yfoPdiSW1PgLfHlmFeezQlXalzMtfXP/nR46tZKBXt0JSvW5Jm/CnPJSbfEjyV36EFJcqe+cZrcppcHJAfwKFxK9ski5PK47tuSWfD3bN5vgs7KLHdAdzBvGQ4ej/WFDEKyi3xyoRtR7diZTcvpo0hBlyX8Ht5E3EOJWxtngAxxx1oD4i7HIcmdgm+02lzwW7vekQTThjNF5N3ZVmidkLsNCpFtgzJibrtcqCzXAhcTECLVp18sZ2tjGCOTVAOT+raTLb33ejqFHLF7oSn744D/hcC3XCsm+906PWS1Cn/iRkqI+PKj7FXQprldYHWCpDenmR8PLzqGrFqXcTqBLhmqyrguCcmrGVRdIQwy48aVbWaZG+H82BY6c7b2mrK114KtveZN78scdfqGrZlg0uCZeGupZGd6KcX8aZ5nMfBEkBz2i00PshnIbMV52DY76bLfLkbUIdVWgUOSzQqlYFyQekrEdQFaJGuKXhHPnMsuYiYYM+8U9m2aflpCQu3gLRHQyLkR6ZBz0Sr78cMlDWsj2tsSHd2WsmtWcpXijJ/PkpNP/EPl5BN/vZystnPy5X35ClsPmgwMHLvYvHJsRrmibGg41k2QE55d833dLndfTg5RRbBWusA6K8bSCdumz3WpcihZVg4vdOHwnONw0Ti8tGHXGsoCpGxKZ5tD3Et6/nI1lWsxd0aJFStzpaRMO+w2euCRxMps8UnL7ZMGH6XMHRtTkDv6ys+RT5Au49q06wZ8Nwa4Hf8MiT7jiB4q0QtNoude1Kh55h/qqHnmr3fUDHfqP/a0FzbydK+b8DSJywG8Ku3cK1OurmwdsgQr/JEm/Zc9JUl3WdzgCKnrbDnbSOZsJV1UhumYKdhbwuTkDJhQ8IPCrJd2NgEBTYiqDs/CBtfOnJ4D4alnPbFtAPTd9w0LJG7KW6tZ7z8iS0pPhZ+DhBN+igX9giJfezuwVoGxjmPRXVheYq9IZghBInt04TGazJQFNeOWnyajETp1TpzzmEjMycW0RV4LVLUUbfQN0Y55DwBW5xLXzfH7AJftM1kzbbKs4IQEZ5nHGy1TEFCzoWmgcMtCInAXx1Uv17nALH+38jOUpeYubQph25qZRdiu/7F92WPezYxqaHO3Xa9TOjdmNH2wvm/b+/AGrV2ZsmWKDUw53UN8AbFNy0q9gNYNKGoSz6z4SMhfSiZlDwIFFGftGcFjSamarChJk6ISOpl2lkx03LTRkCalFmlTHjjqktbeCCCBp1oEZmZZfaLMA8+ZV3Mtl9O82ureH9q5pcV+uIjYD0d+zKodtWULpQIYqetQdV9cXr8PnX0hhIY/IX/ypkq0X1R/mtWJgAx7b8JpEHulIUUKz3xLePZRzAnDM6GyyCJPM1I1ESlS17LbCQpIUeZMQBhu41paMr5Ro23g4FzmxSOzQCXz3hhc9EcD8xzi8zpp1siRPWaJoDbmrmTeGFYwhpWMYVPmrGZso6INyd12RpXIqFCWKd0bGWWWduzNz7VY88tkzR83WcPYL/vYc6FjVJaJbepWOS4heTXPHzHWbc41r4QIS+hhmbKr5UptY/02z64nSuDQvFjkj4uICCOEn5GqRVSy/Fjnm7fzhGSFjJyiDSc0Rk6RkSVlZGiTmrGPGPiQ+JBnrteaxQ3X9cwAAdXm+qTZRO3YRTK7KFM2Ybi5y9QoMLTUO6WGNuSU2QCgFnXzn5rRKlmxjHdDC9fFpU1aGjVzw6edc7p6HMJFrEOnaue8qgUDMEK5ZqfQqpDN267NStk+Ts7JvPd/VIUyDfIQ1mS/NpWM81FNZs0jlOhNmafBdBJT7c/KfixeZLou4w0ZJ/dIlgk6sFvNkrZD0em2kPQyyMAvW8Akz3s8lMRmBJlXsBo2K+qMWNSj3SK7tNlAYmqgzJIkbK04ls1QkVl1cDx0CmSMWBKbkRBNM80NvkJzncMGnRZZAuXahtcCW1iQKbQypVMOdHHoKK7G59YcGpMzRdBwnNSbAI77PYIlRz/+uFmx2EaDsJOgdgZiZx/+TCt0gczKNwuunydtveVR8k7MmeXPBAtMyDRzpsUSzWm2G7A5qxvS0SB0QEe3BNrD2gVQ9cKdlBXV/mk4anJrwHMKMBfcvRyHe5EX0frPkWHzpg6F4PNDYbOh8ER4q6FQ/Xs7FIj934mhQEA/26EQ2lAgz91VcTMU9Y6hMGN0dUPFi7ASnV79C3VDsIS527CZkgX0PK/rqAX2iVUIJl0v+7HJfulFyj79N0rk+8xG2Zcp0sjI1m0nioGAaIe4Z/WK1Qw7RdpvS7Ol/RnvEjBZIpbYW0jcJtIlE+kSKRyzbYPSKBh7FBwFc35K90B2kMc7nMSUuphgZczcWbGcZ4F5/y5XVixVEVBiQkpMadTY2y6oJqbqq2FspqAaYJtC1XyXx04EnbsRKTNjMmdbZ4J0Vm3s6SzJFJ7iOuisnLmY2mm2rYbu9Jdm5VreST8cpKG9PmjLoCvOs0YPLHLN4w10J7nWpxrZCret5tey4V1V+BSNC/4ujPLki4dlPLTWm4Bz5sASqzqNW1f7aF3YQHrc9pInhnaVrq1q1UZVpKuM8zzQolLSuv7kelPT05UNpicegCy50dxyKcBjUWKVOMUtzWXPuY16lrKi1iDEw1SfT3F/rNd+56rfrdeinb5b3xhPpNeVO49G/CvBl3ifXCrmuHbevSdqLxHv+2B67AYT4C13RI7417aPmHdpmj4fJOeMfRcMoOSMu17hqbDOcxXZznT0drfvieIm55ov/6YrFzHUKg2aFcx+INsk1zxskxVKyrxKw37yFSn6XRMe+/JLVAeB5Yq2Xf0eopocNQlKJq1Wut8ASxeb6+4ZClOKzStEpJYzC9NES2DSUEWmZAfBEzgIpj1pBazSbvQuBx71Lr3cmYPs2I+7GpiFhC/lmLmH1rMpO/1TGZsxVw749HDnLRP8uzBar/vjt9z6ls7DIzvtydkx3AyFSNRZc0WPsHjASpdNnj7ZDr9kWo2GExXqktyuO8Tj698c6OMbg/VvCGAoHc07JyMEw1YwaAWVC932drbJlALP0ejtiaJyCD+PIopIwEjw6PpYwFjIWIhYyFiesTxi+cyBF4/P8FivPAGEs392GOa9bbzXzqZnYq3L7BfsMJjcXcV4X+E5ackoZKfAMdsz/Y8gCRXLIvWJTDkjaLHp9VYQ0cM0GkkpfxdGvanNnLKu2mBWopvGNifMGX/KttQ6dqf5hrYpRApIZaRWyLjUESSDZwmjH7lZOwtS9WJg9YT081q7YdNpQjuxKzkL3mI3o36yzAG1l7OWX0SW27pbNpuqxGZp1aJpoWNF1QYDGy2YPvN+OgqT3yMP6yKTj6IAfZJoxpx0lmTG36LoiFAwCySxsTW3MbFgNmwSgqJvEzlBdNahvS2r6eao5zzSOboeSNhCa3N/I4LmXfwK5kBRcO/cMY9+vc5/jZY5Pm/jZ2dMEid19CezNnpth09A5Tab5swMMO6WOgdsmWabD1LFcs2TdY4IYCWKtXOdckWz0lxZFdpLp8tMX/JFxaRoahQZyUwX3bagUC7JbD2j2dL5F6DY5qnYFlqKbeYmKm3h75BKQ08vtVbDQo9abaM6W9hcnc1k1Rl/2zXa5AvXaFxiJgttGm2BJbFvs9ZVEKa4GfC6bWoT3TaFUYPcz0K3CTYf52TuzseSmYyaW9p8rC9+DtQc1bgeRMxJszAbX3zB2m/KtN+Caj/i1NR+RSVTrGgVlZjFlvaLN2i/WOaNFEsdihCqCZxcbCrD+NbK0FRhFnUjLHfVGRwRzypJE2JPJPs4g+nKosebHt0KK+Om0pw2tbkqJwfQ0F60ssecZPSAi4tYid3a7ogU7B2L+DeO77ZXbA6KyFE5snbDL2Dt8cDotbVURLTk/aP8wlPHwS/F2wt0Vq3bJt+0s23x/CfMqOD9yeB+DCTdBu3DbkaSi2oqf5KrXuCS2Ib8guxrJHepFqUrM1fmyd1AHVXQrNxFeyTvH+Vd+8kBZNhSdS8F3CDigjmHVljlLekeLlT3odl4FQA1ZM9qOkv1eRYOZHJA9EIWDHpkMJTUsTPLeE8du5EetGuj2drF0fSoevDu4+HXHKrYV1GScUnl3AevJylaTGiKJhbqShfSWH2QWpp7NclzJ5HslwNqLLhb5rHwNcFMi2BNKmhovyC2REbJ9darSkoCUlvfPFqGXsc8piPRi5UJUsa9b1x9wsap//DkC1dcj2WcHo+tdL8ch4OFPR3gLaGmCxNzWiiZVUWFrYT2jiXCd7nSkiFhL9KlerbiXua6lh4DHskRh0F01gTXIv7lskP0j97ED4zqcM4hihfl5bjcDoQ/5TaKmbXHC/d7nKMIypy6fxWy7l96LnwUAyT3Qb7elBkB+zK3J4Sqd5CmpCECBF+BP4FbfPEn8OR78GQLNnYzYxOX+ZD5AT0hd1F9TehtSLNGEOPvWXQ6neRuxt9TKDIrZ70362aMNT/Wu9xAlRXaHib5mJQFPhb89nivQiW3JYuQz7sJ3l0cVXTjTKYgrItyBkJiC617wMR75S45T+NH8jK5OwEqycvRu24zEw58bimhE+S8LpzsAz3JKxjBdXx70OC9aIqOvOqB/nSYrlAH34F+xxGo5ev4VJeZLeCay48P6vsNS9wWtjtOyR1YFZdo7rDa86ohGTquJlOG7iELSu4uiXmuWxqt6c2aa82rNrtRgfv51ZjZOcsKqSYlc8c0VwHHX5mzVglib47+L2K+DQtnk5x3JSZ+KPryWsA/3Pe10GW2eSVHD3HYm85xOnrw9LN92T8MoFcmy/g7zmkJ5WaNTJ1NpcexXjyeLBsZ1P/V9gk01nFQ68K4jTzpYXUJSk6gvDP0cvVLixkkeEqxbpjsObN5ekgOtZYBMqW7geyNkwXSq1DGWD6MQoRJTjBwXBtTO1FJ0I0/SAzUVIYYq/DazU4iqBNTWWgZQP098jIuGlZkWde7dq3o3AcxTvlGBa9OL4cVI6sJm97hARK+Cn+v7nLj8muSE8i5HQSm/upC2cOq47FmTr6gS/UTyWvkRPKFyP0i/L0af6/C3yvxxxd17miaY0OV2i8WW6rwJlMd/QppyCVFcpg8PixfyPdEcJv4F6+/Kv1CeQ2wPIzYIVxe+ppO4DrdjOULlC5nUPu4sNYXSAjqpCfli4RNfpG8ismA8qS8Wg6haOfd2l9s97Z3IxcaPyHH0dIdDKHcy9atvRNo75UMEXcg8LvwkiJPl00MvBKHIJi0ZHSBX0BHUhhN7pRY7lWb+pfItECJfKncw8drsV+s1JP78MB3FpP78XwKAvUAJOHVIORTIQKvQuD7AwReyRQGTshrAAmTmX97plPQxITlHrmDsM3i8Sg2mmwfk/uXsX08H2Qc/fwjiMAeuSO5za0eX2vrir06NYouJR60feNVfT/5uavJMXu8zh5fTu7eJ1oheUjud6HXyZe60BF5wIUOyjje6U6OKrTJ2ZZGDKkRz3JC3y8Hnw/S1xOEc1w3JxcSbnfP1d7KaQgBKJxJOSKvkKNra2j6LJBOztigWE5XnA5dUYc8Gmeo7KeZBEM5knTyADTJnCpd1R1U0V49JyXafJt+dEWO6MfQcZFmTK9gejJHEyXz2wid8i3c/FiiNa0izs5MOdmBtCzINOFbsmOWFZOe/ZLIqVFUESyAkzfIGbA4OaNDLq05nEq1Uy3nDUDAxluHJiGjCp8a3BmiakFy0EwOfTJziJPV4XjOYkEoJ5MFElN446bfYiExZIYuSRbUbc2yEJlcdfvO+zFVtL+ronsiW7m+4UZblZTNpG+8JjXb/75JRfIrbmjxa8mXe2E00TQX1AXZf1Yfk/Yo4EGxZoq+1nIhDZmBMBEgXrHZfy7b1uaKCqoQhSg5StFWfyRzapJwlBVqlxHwL/C9kWCcoii2V7Z+zX9H9MW8Nb6kftSC11BDG01y3uWJvfmCLGUVWJAFMq5V3Jkd0b3TdYJgqSXfTFlz0mMeNCkxWvdNX7/mG2fTGs7V1oT5DDH/2HUET9VuJKkVRba4Z/26NvvHH1u7lil3UF+yl2vMPipHr12/ZnuQ9Jg9k7q/GCvPlTTEhFu6Y0BCrAAXr+lRf6t+ICKpiBaqs9CaYnLjGovJ0RvpUVwuveOjYo8HRi1+Uuxx/+j1VOxjXvpgATEZswcEUbhCM4HuBkpytNwmXUcdQqutm//fYEny5da2PdBX40b6sLxO3ng9fWQt5XFKtfYgyx+RN8hXuD7eR8KdWtP0LxNTtqkiKQ/fEMj8IyQz/uPDtrrpEQ76h9J/DJ030qiLDoe19FF5SJg07JOuOzqKPZQ6S0tvJnX4wMnORZLp/1w78wPf//0nbnSWNnT0wdKPIXD+NDnwzClyqf5gwtUrdOib5UEDHfbBS/KPmuHHIfepHNELwCEx19KH9JtgqdQV3zP8eZz6+ZRcwoPvaiamlWk43+8mov3yODQgHpd4b6+8WfbbFcE5sebaJg97OTZXKwj+YAN9S61cT7/yQnJZ3oK5I5lGi91nh702O0ybT9am08Lk39i0MEnKTLZNC2flK+UypgWgzVMzqQHN7FRAG9JLNRXMdp8JbGgcIe2Eb026uHXNTYmdG1P/skii6lZO4e5rp6Fg0hH8YTgeKTffWUrQmNjVHMhO+YcCaRlBlbxU2R9olE/ij1XDGSOLbr5EFj54TQFrSEMHR/6SHy8aDX1UVk3YrVTkkzEXvW8tFeodrtPlEc2utAad6NhZS6Hr9EeLwQJlUxPGFBWmDaPrHDLQKRj8damvwYb1kOZQhShlzjQ9vu3BSceFKEzY3Yat63aOYqOPOeGfustNUs0Re/CsVtI1eVjeaHNDNptHumvVZ97Lz6ymVHBUsf6+ntZre9wvp2dISiD1jwffxWKiAWCXijyEfwJ+PFRWkox5kiQPu/fWgdCb5fUgZVpgOkB5VKhBpLZ25g1v+E8nVc/r+D1gDg+v51Hp4xBc14CcU/k1NFMyQVQCxLlGmL/XFYWZHacA/VE2hLnqfjNSoE2WlEuUuHMmV7PsTRsmVIQAYt/ZB6Uwexxk7ZjlVvnzHG+UeUznnTXjNte0k7zT3E0gJjjpQXnIdPcpSpN8hZOn//Yn6ak1UOWNa9fe5yZJuWiicvE6BYfztsj1dksnBU1IS5U38gDRY3xK/QZY/jDmY0Xk4P2j78N8dSQ5VpYvkT0U6jQnr+N3hnPy5SthjAdug4q80WWWGM/KAT4OyG184E4hIr5H7lT9M0FiTMjLSfSXy71UQ/eadcYsLmbHNJtJw32pTG+HTUv6FSs5j60wbTiqdUP3sbIp+7aZXguC3Hmxq2io6byRZsUsL2pEmWNXNSo/2oCI0l0U1ZJ9QoDJJb0in85JPGGUKVXK5iC3pObNdL+9SyRTeAK7+YZmL15A/nymPN8ixhU7llu8cJFta9I0X59g4gSrWHBcsiUmrdJe5k9mmox9KS5Q5TyABk0bIPEFS2gom5JaharMFQUTkDZ7QXKtFFrSDlyQhK+17MskX66ntzE5QiMuuSCAclwWXQQgxc0Iut3fjGgPPoLG9zUjbNJFxq2BCYtYAy5iDfgIG/ARa8AisdXZaxGr4yOs4yNWxyJLMiXTpCFISBvPXWq9hqfTXLJofvvmKq/PKiwJfbzQt7plcIhP/mmOpIf1OZ8etxL2ZyUthZcCj+zYOTq2a/e4e7doWdAe7xBmWrO9w5Jpw+du0kaRbdhdxEzv3obP3aSNWNxnZJx5qo8lhrdu255p7bB9nea45vt0X26Tdr2XtB3ptN104jxEFylti9QAd9H0zLfTbejkIOcyZ/41rA2bIPgkjBQ0Mm+RWCMzFily3OrLEIjk2OSqcrFoLxtU/H4q1riLFCwz9pkli0eMqz5lYuvsvvNE03w+eR2PoVLe6EJli4ZdXKbs8p/zHNJEbqpK/uMt3x3mC/p9CP+V9ziNml9358N8dfFbsm9czpo1N2Z4XiL1baXBsaSnm2whatyZff2K1aw4YNYKKF79Phqg0x6hExTnTDohst0eu+fP3agXUPnwnvgax0YvZzaCmET8eMvZvrzk0XL0iN16R8L1uIqhfdC2B+cDbU3mXAvMYW1DWZtICjZR93DR2rOi52MF/1KEx81IaC7GEjUdKS6WD9j1FyNdDH6n11+NpQBZv9cu67hY/ot8VNTvbkRvNbpHad7IFnlzsP9H/0mVSDMbKIzEo0CRkDw/uBLQghszBWKXKZR3ayAvM/nMKyGSZ/2+wFZgPYxasJe3kZnllyG2jeGi1EVe0EwRdDiKZNSN+ehVT1KzPZRUfqRXeq5LZPQr1eGS0WtFVtOynq8Y4EBlMw+LCjAs64coKPk9OI3pk1789vPCDf3wc0yMpU/6ZUAqqMLTqI5zqEr3c6hKxjkBPD3XApwwkqAS1UkIAlowEaF25teH9FiqdTtia3BetQbZEgYQ24nIJpWU8mvcN2D1CycUYboRBlxRoBUJEXgk4WG29zVsfYB+4xfP68x1Lojl/xpEgY3ht9lwQ1ut4mmOFVICYIOCTsrsjHtPFRamZHxDCzxX7PKJ5MAWIxxnOtqZgGZe7tOKZU8E/aTOtWvaU/Y+wqj8m0EU4jMzBFeJkOQNxojiVZDCml32ZdBHCniuxi4cGHrSzz2sT1A1G6mXqWtCCtfSwpp9Thmg+M8pY8i3DCNml9MfCdV9tKDtSeDdR/Mf9H6jPdLjNhkMSuGBUfbyz66n7MmaKFy3BbN+ePn62vUb5VPgM5HINV9zymW/CRLoNzUGNOg+NuBjZlAsf9/wluGrwdv7qSPe2gNyhfx7a4h4ESHqDcTdl37z/KFmZVQYKTySqq7VY3ZEaKlj5hhBihkaZqhHwWKol6EKq5ZBD0aqjFQaQLPCs/s+ft49Tz01IP2raZWDkl+6p5ni7TLA63SG3IU16fCqDHO3nW6VrfjE0uj/ZMXldBvJP/w/355u/8/pyGqyQ7aflif/M+6fSXZKPvsxIP3keToqQ+5+nnRMtjXSXVSCIeexkMd4XKD2WVIisptfbW+kQ/UkkVHBI5Vd2BvLqBWdEFScdGN4KuNUUPngjXTabVYq6lWwB+plL8Ihb1rZxsd+GTOjSoWuBrNIxOMAi1xIbmOtu5M56fP+B/Mk3giJF/LyygUTsGSRyTGTl0iG5Q9iJzOtx+1jvHYFjVYvJCuylBzRk7uDJo/TUnQSuWbiqFtyE0cG5SDE8RiOFY7bYfYyFUJyu5O5I3KcGqasF6NIWY7befEJzDAnZTQ5lVd3ZT1Xtu5wIESKDlEE23tafIDPBTmK3nJ40vm5Bj+L0zX70v5KX44hUp+Q7IAQ3S05GeEexsRAdj7GGV5q4Ka73nQ/9yQ5SVlnCIGhu0c5ls9wDa1xdDKEKtukRuGKsXTQ9XMoKDIkBY2cBhnv6OKvcKccSIZ0erhTDsO5LT3rPOjMPyg9J3e4e3LP0QKks0Z6Dl/sVbUuZ73rHZKCZlLok8JmUt4n5Zlk5ga/7ryz68wD0IY48wxBFwHIYeB3QJehPQJ7V0OGTa6h5lq4RxjJTAqRMLyaDAk9/ocbfkrKGctOq+lAbTOdFw0VZCthGqIAsmu4LTDjlJyk9JyUsq4LjtNmdZssye1nH+Nu980q4mn4WHJCbkdyOKr3ZQZOrpBWNrk6o/zf3UWuzsjwi5KrkyZXJq+yS4braOYzlK6EsnVCdvNBCc+ZiA1dYBh/7O9EVxFjkb8vInayXcRO3kLETnoRO/mSiFgtgPQMU8yGnZjdnixxNqdEUb4oVHMoQ+nz0nNMjkMQzgs3DgMmY8PqhhYkZ/h8BqfUlA1ANyonZczct9C/038n2EjBoD6v381Nax705BgK9DnXPQQrLYeus+qtNe+cT852d/iZR6zP3f/VZw5dEy/MoavMtRa7HTIHLo4XGVIHrqOkcjrUcuA6DbhromE5bQ5cRzE0HH6V/kIYBAHfmxYJpaIk4j3YcvrmPlAgvEdb1+Gsk5xTKb+zi5SfFVjeZdYR5Bxkfa8ckrM3cfw6210mz2YIOMt1ucwqAU9tcPyiiMEk1en4VcmsJllpH3XXkCaZUNHPrsCtAJc7/erIVTUEja9b0MhUkrsZXweTUBupyhb1SZu4lTPXAJrXfinNA1CJlOkzEMdId8Za+RSpLQPETxl30i1o7Rh22N98j7jFVFfKUZVdAYqti1Fabp8b5cqr8G3nsvvTku06vjkMQv9hx+pqGtjeX2ht/nN6VFckgJWi+oNP+dTfzqT+UDP15zOpn36nT/3hrqnf3jX1mzKpP8x2uYK1bya6u1sP8TOKPMupPqP2CSvwTLbA128oIDn1cQv1+4IIoYIVrf1bbnKqP8JuyoZVrtX7t7zHw3S8A1CIhKNQrnwUlPPL7IA/2niAhn+UDVuG5TIcS7Ba/fcK2E2q/uytqh4Igo1Vc1ZVP32LAEvnmqWvB1Y8QCE+eJRqfZFcb8pSy7K/OJN9X2f2PZnsV3Rmn8pk35HNBuX+OOeBWnIwmW0jPKtv9Nkwq+WqP6YUCCUwcUVrwKw809o1WVLOczOs/jhr1NZC3/4/j4Koi0zn6LzopAGhljQ8HVIafuKpllA9nxWqJ8JOqfvtbIHf7yKWP58t8MtdCvxwtsCPbyhgzo0sxq1JngNGd3F2/vvdkN1IXxRs1UDtS6Tem0gzFd3/EbQJ9C1HixV4Klvg6WwBa/eJTLs/2RqmlzK1LndU+unM6PqpViUnTLlOYbJdfib7jo42l1tNfuIdfsDuzSZ2DNhD7WMhlxHXqE1cn8rferD+9Isf5z9zq6qvtaqZQaJMdpIRsg6tgjr/SZ7ykG/Bb6eDeTwe0jve2wbT57Ltox1tm7dRHmOclR6EnFZ/rusYvysIMsM2VL6ZEWwYfI1ROTZFbImxMjtsaeewyezPUEveD5glx2+J50w7xMRA4TcxySsaAmyhTmB5qv7Muxz7oiR0IiVKC31pW4tyoEQIlr86H0SdeHn7tzPwGqgway0/nNI/zGfFYmnR3S6tgGijdk89DUCC5UcRQ9A0A/DSK3ERtt4rISX5O/7dN+zBRX4SSsSbcpHHfGx1vh0ZSPvVH/xp7KW5vCR9f0mt7xEN4fkX2mFkHRJYIKMYGT5KrnseRgO68jY6FTJ00m4AcLQvjA+7WkkgKKQajsJXwSPQtvmI+NC86i8T0p1mdS6oEYt57IuEz0jDQLn6KyybK79eZ5HuN50ZO8zOrrZEPZ+RoPq0ug9Q5ZazXVQ0EjKSKnwmxZJzFj47Pggch1dTEg/jm2TykklyWH6lNfLRwECu9vF3PPFkrvrpdyjY3xYXgrdvwze681fDt7IfPUwohyMuHCOs/e+jDKkUk3Kzpjv3MkYLYJ4mPxrskDdvo0DdWlBmRcjPPC/yZu4ycfvP5llbK9VrH1f71aHwuB2hUdQb1V94EsBxwUkPXrXV8mfeZxR5MGTK3/fkcmIbZA0bcg8h9utWJoZw5q1wgTtQCTnW/sBWmWqUNMrN87wHbUAAe+l0UV6VspTNnJgzl+A0D9DTChfBfTArRv857V9NBiTyZsWqFMmBLWZjDtEOz9FRb9B2SnlQop7AvoRnMqwL/WQrC6+kRYa3IYnCFV5MtktFDXz5i8mIaY0d0it9PN22b3JjduyDIW8Ujf5y7kIyhkZLd+sx1UWe/RQIyC5hpR4aMXiAcgHRXVKUwYalwe4gRddhbddbHnuMt8btli3JoOxwbwj0KElUHe3WI6C87EpCGeYZHRnmv0hqXxTPe0tBkesu/ejHMGI9MuwsAeFqUgQIRJylC9IHEUIFU+M8mdSmIm1K+qypq9aUfgaoBc6YhYBSyR1W5WUAJL4bLfXjecF4J1VaabYgcaegTBGBohpkLjDEP2ipIbW5bO/LddmLjusObcQjLKMyTruLeBtJXhAMW8HABzd/ezb7IuB4943reIaEI7oTHVESVoyEBSkr4fIy6IgZGniehFI2bkQbSSiDNJcM+l3dLtnG01rnm9PrX0zqQYs2V9N+bPNa3nSrDi6qo98NP5P5J3q8Y/5JI6S25h/I9S1mHHYQ+Ckn/3hryjFnFST+MRVKa9L5rc5Jx3p54dPM6ks/wfx21wkGgHWZYH7HJpingiDvaS3ZNYxRmZ3ZGbPdzT8iITuDfuE6Bs1WlSl5idgdSUNUqr9ryyVME3w1KSBE7Lz6e830JPCrKOSIXwV9PA76PTTzq2nekjnBsXBtWJVulT+VBn9VgCL+qCIb5gmPbvooxhiL1U8pn1R7P2gC9sWisSsWu2SxN4m2VE1B5IaFl9PiIap6bVeF+FD4KI0Mpvnn09h9N1hK6NU+sWOa35p8MrAensCTb4oopDhZsmMgjc5qP9CWdTcF7VTgOUO1lSYs/1aFIItrCVGeUY+yCYL+L9nXM+gL6PsmbWul7VU/8B6mmO2CXLiCHwCaKfrtGzMoyXZlzGirzA+7Mi7FjCkUZiurh68hQvy53FBkrbUkKvMU09Uz04ySoA3bRi3vQTIaPk9aXj3MU7Xua6F3c5P8PKDoMSioy23vx8NATGL1pGwze8Ld1iwVVGBuBAF1ZR8eK/Wkvylesw3Pd70aeoAiaN4jNt/vlYgrKotUIQUcjnlfh1KtCuo+Ss0sQw8mVSRVuLjJS9+hUPAocDzloS/Y1qSGYoTGGNLBNayh2eYwK0mVw6yMAAtIQWtInzZRfV6FLw/ga2N1O17Oc9CtN9OTEgcdQLrPwHt34OAjexTAXoOs36CIDcDCppCUdC1gqrwfP9X/pxqoCxCf7gACvUuEaTWJvIUvaL7S3WMSw9+ng4ZKW6P6Sa4tdbuHsaCqlnvef2PmPyyKoOfcei0yG4lupMhpMz8UbPFaMMMJ4ZpvbbW/5qXUg9ovNS9K5pjIB3mUUYW/fwtV+KJW/n/4VNvKHzRprfwZaVv5H+u28q89enH1RSz6HwuCt0u4D6hjIGDYsrjkubhXQmCoMbdi6SF6ZFpoBUNXgrERKz9s5UeYoOWHld5WItQS5R8MgrjTcOadv1AHWNt8Wys8nkb2vXYUeY7eH9U/sinQdsVF3a0nJSk56Lh1znN1QTWPP1sMnOSa2K0FIilV/1gpXrCtQNEmPh2XYhYAiNufGKfZCaN/akOEpOVmJ2vyKX8kDEovEJ8wi88TFDuPRxb84PHWLGEbBoD2vIffDBR/SYDoVkipBRImtUSJS1oNIzFSfAoGgocDS63iapK3u9NV0qVo65jQDRbWqBgl2CL1jdUlwX3rEUUUnbCcPiI+NK/6VxlylYxcmVXMx42FPxEEhascf2Z/y1ef/eqmuSNyy8ZQ77lL8hgwmhJCmLkOhia9wBxGqxbiVsxoa34QadHu5qZgCx4l89ViHb9JsXkkkIiPqOWLRURw9qJrsqTE/ss6h5Q2bEj83SShNy/luWArp2S9W51SYN/xTsVWh7Upvo5B+KLUxp91qI1CVm0UOtTG66EsbbWnGsJrSVuN0egEslb/nK06rcmq2QVtaDgiVZlvFs3YHhEfhGW+qZyi6l+wsVtpJKOXH+BZehU8ve71pnw19AVJBG6o4NrQ1YGbIIpHGhk/tETgTIABMwLHqA22w9jbDiu3sh0S1RfHqE90MCrMMirsYFSWhJ9k5c9QqWdFMNpI0tCTNHs6Et/ydMSw/86wEMA8xL/sVq9oA9uGVVLSxVUS2yJw0uoKceUErAI03I2EaQ+ISFsSn7DxcB1TxaNkp6SSXVijqTEzCLUWpgW+rBzTZG/Lx722epzE4rEW6jowb36t+oZZpFJvBrayFGnd/Xk1tvZKpfoLDBkDJvkzxh8sAXk+0oClR9d9pgIiugJG7qYHtmnX3Zj9irYMWwBJMXtC8Aj5G+qIsllzxObQquRNm0d82DKNKxIzIhVsyEU25Eo25PJeuUpIZU012GikZnIIbGdT/osgqGw2P41snJ/GHvbz0/d+/bXv0eH4xHub8y2MPHxUk5KKYGK+y86HL+m1ubgsZT+ZWYN5moM5U1R0PvseNgzy4TGp01m5+o73tqZjmqf06tqiLY11Wh5rTsvvZNHWtPwuRjeZlu/KOZVsA8tZ1h9JKcoM1wbqtegtjFb0EF4VNBQFKMj/w9ZupvzrQdCzGQWrt6Tgk0ZBo1nRaFYymsVdSNVD996upLKZ/6vZXKJ+pqwZ6xzLn2JzLZ8h2P9vI8H+aXeCvXSz0rs7zNhjWTP2WIcZe/UmsxLV8WrtoYe1Wr76T977Es5N73nvC5+bjJUZRUqsnCJ9KshTIeY7JqhI1SHFdxj7JDv2yUvBG0f9NzHoPcwS8b5Qi5QkYiaZydzYKtr6TocC9QMefqIrix31fRXxKT8U5LNq/cWfuaVR69RNIk6PYXMeOJ2djrVhSpFvmyafzrZJstYc/NLI2lOfQ1l770spa//s75msfc3fKVlLjLA8oNxI12VP19lc7Tsoh3Qlf4JS+S+YvLP2nV0Sy3uANkQxsBUmYJWACj+foEM41ROHPFYF5RMKufP/YGFkSoAfbPH6Qu9AFfARZPyouFBBC+XvS4q9V8Mr0dXgSt/V/BU3+7wfm7eCN7Dq9vdtelXQx2ojD4PJI43Vj9UG3iKl+sfIcsHfXaNpXHtTQ0Kzs0VYGsBBYx0Ipb0KaFrWNd95faeqvJpUHMiCbOTwCKhPL0yUPH5Wa9/EutxOwbv8YtKvYBRqP5xTxt/hB24y0ApWeVDDw5Yttav39BGqK+TgNyZViIFUj+TJIOQRhJJmDCCDw3QAeVKyLb47H+nXDxWlRfKW7pOBNp1UygYEcvOUQXNPrOVe1pfLAEL1UVEKvJ9YZCCA+ar2Jp6E9PK4j2QD1nkiP4SEPFBdTXBohMatnzrFl8hXMkgTU+24bGdR5uVYoiOgmB2yKsUZoETk8Hz2GSlaSEKNJlUbF6F/XXALsH+7f19qCNiSqascH1WOEOLK2oZ6Rcp1KjFLZGskytN55DBN8ZR+UrMfZfvO8hiJ4ldRfpdPP2H/ffxkbUR6VvGixOnl97zto03sfH4sw7V/fZklQhmW8PxoSun9n0+eDq6cDp4EUAfP/s/TV//Juz4Kkv7GV54fxeNfXb5r1LXzx1dlkA23ervCgv8ivosFR86PJltp88jzJ5BBHF+OJtuME9trc+g1GanN87GjxRf7mKsdgtaTUZXW2vtNTmMjDu+gGZMCibvLiMLgbumlvIMxLTqlIalnQusugTZhskv3K8pWxjguKjoGZLc0P6tVUD4XpSpVh/GjJ559PvzGdMBHa89+7fOcItQ+40VBBp5JO6pUO6qELFrdICcx5aRfSnoFT3ZUmJwU7N7Wm8DzsWefscaNBhQqksuAogxVZbB6gyo/A+FzJ5/9ty4ozz2rsD8fpuPf+LUknP0jO+9Kxc7KKgRCt5c6M/AhOx5P8XMJO0ibm0YeTxIJeUHzuNp7ZHBDVR65b0cRG1VJE5RfPvkGfrNpnKI8XguRU+kLvLSdlCpAYioPDZNacB60saI6NvHX79nLGUz5mhpfhxxDQxYCU80C5pArUTZoaEpKBmyRCRwemlAL9CEhtzIwzKoc2U0caV+mHbaUbYjNBK4ZcNLXZnPUtE6jIFpUFUkRGJJ+8r5feZ+q/2+BSZdsZk/CrhBLmO2oiI5CA9M6YQeo0517su0iipKcnGKzpKYcyNavleKoEZ1tVJsa5HV6uluRXswCfOhnxi4aZlIxRnAHDhMfDoJpjuAY22XdJ6Er5lmhxLRn7J4VfRYfw39J0Q+RfgCOMdpH+PtIo5LSaKf0W7O+uaLVudL2wcfiRhKwPCJXqTYHbcpg7VZVlq9EqDiKiEHbT3nr71KuLDyxqdR1zupDSafIOfMOMVFiVdEpe9c5UyfL7ByzcXbLxFR4+16amWf7LWaeoVtOO33ojfpS+tVbvT+pAFqVDhk25ZLRdm8wkivmaiDbqLtMXziWELFv7FBlIbjTkwyij1Y5zTEz8qCudzTw6dK9LRG+CiKG5c4JSmkLAgyCAK6Bd1yGiOL5A1+J95+zTAgzE6mEOodafZ9MF8N3XkZbKa3pxc3nTxBSFZPBajrqIklT4RhtI7LhaULyLCmuMlrMUs61xxaKlMiSLpasGWp8ZX6IBMq5+bdkq6cDUvSt2/KsqlNYJs0EiE0VZSDbsQmTDagM2Ji6KxxQfuBLmA6tplx65kiWbsu3UI8dVW2wFiXx5d1GAnV2jYhewQqhb+O44BCmvH/82juezKkYbxGuKVV86XJ13afbILHUJzOp1Wbq05nUkXprLAlJ0Ufl41VzyQZRvw4iDqDucGTaiDu+PfvHfLG6Naq2kNRb+LKTTgRYtrJcc2aJ+qMglwuD8qarYcsANWv5cxvyvIxxDCqxrXPHtrCtJFc8TtxUnxj4lzeCz7oX2mWPjdapRh0tjIYkbNUHYgu02n1ww6diaW6s/mvUTUZJksJM/o8Dm/SDJLRBg/GjSHLS1XFhgFT8G7NbDI6auEWcA+VNHoJHfeByOyisoaoyMlVp8zfi3Bh6hpHXHsFW1bjlidWORVwJ/wGxbMO0NdHiWAt6G5rJQFMJIncA7dpa3Bck1CS1bohRPt2qi2oKBbSRbIVQPIOIEsiMFSHRDzNIPer95kLWn1RMUm1rCqvuFM1tZXPEFNBPyYC2KCU0PylbLeK04FY6f1LpQaVyVGYWmOw1i1zJkV23Ha3ut2qXGWW71fdnfCIJyEPt4m7rgm1vxvYJND3heIKntZGtX7bBo1ufRI1UJB4eE0fyVQmY+/GA0hkYA10mns1chGMy5P2RP+4Yr/1/3F0FfOPG0pe0ku1EwTJ833trlZm5OceOr8zMzPD7NceQu+SalLnx9TUpybq+pMzcJs7dlZmZmZkvid/8Z21JTl3mRoHF2dmZ2Z2ZnbUSbbYfNgwx3Si84kXCDpRan2Ok8sUvrd1XmnltNzAHefXV2k6hG5tK9GMdc3Lv4dJMrXW8Y/ZKc5vF1Q0mpSGRGK6V1uFbhBS61HpqofUsyWoDGyTiWpcfK0VHTtUUCpM6db382CJO0XYZgfLuUA2ljow0WiiNC1a4dEnjUpfNqnUeegtK02KVglr4qj6lMfzFpRHA7cByAsEOo1CCJDCbLA4m6IEFMIXAJZov31aZATSFOE4ICQnilzIo7FfnRyyOaGq26MHlu/C1SzygssBlZMdM5lVU3Ep++3hfW+GiP0oTzcl5c5eEa6ul2+++58hV93494RXot26TW0zNdZ3IoBE3mYMRKm3cYV78m5znOlHKrrb/fovte93DDZ4TyzoV6UVWSlPtO7n9YWsUYmSRIk9yrhPqEI+NgEfeiWlLH0bigNHVgmDoJTASPwpDKN4OXnNScbIi1bqzOnr1W7qOVoTSRxBZoAEqG5SSQJMiMassO9wzEerZULZnA/dspZ6mjaF3rNZDACoaAwAvlwXwsgIwnQBgKv6DSd128icc2JUWse71E0xcgv1JzPt5rNN/Aess28eyb95TISzbzI3/OlhGbBaN+9rMjapNFg1te180Vm1teWa+AfDn3kxn7xk175SKRlAK/gjiT6Ud7tkY6tlQtqfi7DTqWTFC0M1fIOimPXICqFx0IBCwj8vK9sdqAiahEbPDPRtDPRvK9lQTaKGe0d9updL9D7rgpCYhtayj0RiUpj8q8hPB9if8bdRXGFfN1jpyjoYjrQi6GIxqcHLmV9V9p2o9sQibL3GTyFApyAWBJFVKE5oYG9ckTCWwsfaFkmVlDMuPcF5gQvLdiYdRN70uw2FZE/pVIuKg1jzPRilK1CzbDcIR5MN5QqgM6qiKls9P3YV/3j5MiJTwSf8FfNLtn7/SMMWoJFwwT9ZHIT3vs/D4BFQ+WqL3PoUZaDQDKhh7lFj5xEVnbeBRdUWWJCPrlIPXRvB8e2LDXTBhhbMuKxTCCgrAYpzZm8qlutunrudRdbQELONMBYQ2WGL+A+YgRs4BoutUYug16ZNK+dpmuka3xS/EvxTM6lv9dmgbdlhlDoRUZl9Zlal2NANh4r/lhG1pBNebTbsnEoGNp7fosPKmlrmAoqRHHp9SWyJZ1PPmXpgXOxUM6IFPxQ7VIBE/niM8KdTjUSrd8sRDu63/zBsNXvq9c1c48c03dut3uUF62vDVO7/2/3eN8tJP7Dt7UVdfPud66Z6v6+rr62ckXEpvuiO+7qBiN66xT8oGbi4fxdC4eHdWYTvU4clgQAcYxC0UxEKH3yZ5qjUmv1nTxthAM1qEn/DAXv+YH8zQpEWF5VGnEX4U9axH8uJmCWvTDg6utWAMJ0rMCWpiWeaY1IYW4Js5ljfkEJepx+kL3kfwv6WRJm47e6EjZu+Uc4cWoPLH1z2+/51vL+rz0rdffV3f+R/GR7nUZehTfahqC57WfxOXb3du29bTz+wf+hjldPONlA390pn8ES/rgqrij6RHNw1o/JUJAgTV3Q/inV36iftLdcOgVaLcHZ1WZipfi7VwTYykkUVzCHIZUuQePD+073KKhav6SnbVuS7sD+GT4ACWaUFMkX5h7kAo0SD2odYBNwuUI7tt3VgPZJ4tzjn7TRGlJU1RffzGsg48Nd13G3cNPNh8IfF1a9gQcYzFcXmCUABo/MEWQNMO2SvbNHnYG+J68r6JcQObKV/yLyqYr/IaiBJ0pCNtXGagLozJQF5sFz7ZFuR3a1RCYgl3uDf5av9SuOfGHuT5s7vz4rDLU/JYaXbkAgpg1YeFyXNEVqm7o9pzDkRZHrjxgl9ByniLpuPPG52Y61Rg86ad1+X9XYpsCIzW6M4iuAJF6Bf1HAhjpYxCEiup3QV3Tnq4ontuwoP8UT693aiX5vtkDhlUL4r7zjpgo7sSrgcRrLpy0qn/f0fz/YldO53Mkps+mmD5o3Lz2/90dXU9k+hk+XyjUO5UQi4rIZeuR1MLsAeWxHfvo5UHrbcaPNd17XyYz9Y/gM+KOeDZPhdsM3/6MebZr2J/DARccOp9zxGoCpcYCK5XMs9jP43ntuK5/Tvy3AbP7YDnPsq0Ea+9wif1nw3v2uABYzf9xOXd966buZX579o5y9Kng/EQAKOxDPtPaGxRTLpgjs4sCgJHYY6AC76V2dbaUkyf3ta6W7UBmOEAqy9P2OJCIPPEU00SMF/O4oYvVGUMWqS3pbpgf/R8O/Xllpa4zoL2Pax2ye0yXGlkETD2/D2T2O86ZtEasTwnQj3uGwIJHsqR2mDKP5FwpZWuemEmceOeBAKV0DXSYuat+mJ61pKbzkkc8/CVXx0948YEc6539MFsjRSpQEDzh1zV9F7XzQT03ieXX7aj+bYEdA6xVFoEK8KwDmxIXUg2S+6B0Y+Mn3+763MEixo4UTA8IumP7rn0sNCZLJUG/8oG8wGnOZoT5tEpjS1OLLUS7EOtGR8wrlhBDCBKJGNsNS4wLrnA+BsdI62t++1wauU3aY6OJanRTdxIl7EipEnt03JcMYsqshJwOEXC7yJ4mF714Ls6d/5sZRZAC4rcZdISbL2IIqPsQT2Pfq9A591X3bZAZwML5+7IG+OJel66Xv9kyWuJ5pg1CfBcw1I7GH7Y3YQD7ItPrR0ItMRk1fmikcy/lOswOX4Pn/51sXWpokQ/Fjy0oF7UOByB5WrDPw3wBUxqs2p9gbv/9IED+fof+9jhlVLM3JRyHdHXy+9eNXCx++N/NzsmkfJaIiC/pTdQ5jfNcbOS6gZQR3Y5qKmkedwex4m2p3eEJ25+dfyl17QnYD255lOxwy9DcvwdR+f7cg8i+dF6zExKcgBkvApq248bhmgV0wr+unr9922Onvz3BASnwo/UiyQUyYeevmUmk1Akz379ji8EvSmZkmdemhmkpMEniri6MRjdvDriH4CrxjP5yI3f7taagVgmWzerFsiq1yxf91ruLAKNYxcF5G5Ax61D1YYIo84sDbx40zg8Lnihq//HUYvUBpfclMhIxOWXN256jEh25iD1ZtvnGsds0saslsuc6dCaaTq1P7dWxrE64yZqTfVkSHIjTQtut9atmabTLll+1JmZTieSweAUkeqcKa3OM9VgQJdPKiS9JAnExOgAZdoeXjYwgqZGgXyKMFsr+cMiaoYGxc16M7nIBFJkMWkefDj+a6A5InZAQyF2gNFJCZ/NkmgibmD5cYNxUozpVxV+2IB6jcPYopnU4cLjxqgmUqc0aUyVpNn7gYJDKc2BAqoChiZqVZBAgRnDAQbH4iiByVECy48STEB0TyddfIgkKWreiN7t0dxP2LJ1GRrWPk8ILF/RUhJz0VOJ43u/K3qBD0ktLrnz7A5TKaQ5zz89LHZhFXHNHXPylGTpY7sBzl4EwAuyf2zjAaNLFjLVbLvqSk/UbXrcAJ3TipEKbeATQC6N3IuR0gd7ZoSZLVAwfPQKyvTi+B2tXQiiO2gUrg7f6JjU52WsSNoCIYzpCRtOXuuj9d5tgA1SIpAetgP1pB++sH/MoescRD7MJ4c/ekey79Z+WtorvrjUlYftVI9V3tnXT57NQTlKjlI+GZVmSZX5doq0srOkyLphlGXxFWNqUwBl7EoqqDsPWftt5ecL2miNn+vn+8NAyFNkh7HL75cW/P6QN2cStkG1lSXVJoV6ynlwXrroo6mzAQIgTU6V8+u8dNGTgw4JDJM2VpTiB04KIiNPCkx1UmD5MhoJTgp+gaMKrH9vR9XysjxL83s8d2uE527+Ws/dgudOA4q/MkGAoPFHUiQu/JMCUXJSIOy3zQh2RPwIWmvBSrMKTQzIXwTbLqHq8uXhWOEFFaiplAZq7KxTJav25RvzMfqD6i5/49vXqZZGOFszxqkNdkaNEOlRC24/cu58/gTVNaQJeuJGmZrqxaXeE9fBvH3DAM0e1otd6vKtFF1OvT8+0KwrydWyIop0lRRGS7OVpVk7yO5XLezyUwlKjR5p4KFSIyjVe6SOh0oLU9BLp0B8K9+6DClCU1qcO5dpUx9uI3riAjiFCcd0tpnrzHPX74BgBljODM+GiqukFUfYTsZw/qzhD8IeVchZvqzZ9m1P6oa6D2w//Ji+9a37Wgdf9kKiGII558sZj9pjP+I8wsmvHriK07rClA2jeyywxtI9Mzbsu+/jKf/jxJrjJ8eheM+2/da2bdve+WWmr9N8tk3mksx0zrZt2za6tnfPtm1f0vS32zPGk+/j9+GPnLxVKf1/TndH+QiK5AOUgMwFxTkgEcEhDpRoFQMJJCKHGCmBQPSbcfAECbX4IagcxQMUhBXMuYJQn2hjszZYVD5RRisxGxBRxK6gz7XRPApBFOUMuAACMiSBtgQRZS6PEhtywyFnKJ2pKBjVliUKqv9WsKC4cNJQjItU2vhkYLLKB2VtmrnJH48GCkUaUSZno+lpQ/8lLg8jFIYS+Rsz3NPeuGEKKtpVYsODgIchBl1BkgoaxyGQIqHM6WaJSh2kZDdP4tWSghRNArwwSxojRi91mNYg9WscUG3YxZLynTxxc0THf0iOYZQLkBWTQ0kLOakEZUWnQct2+sPLVt0nlcSi9IkoAQ21Z9nV/usxXpTRObhMXM1JWWAt3WFZKvB54GrnRV81N2FgtcSllkkpdqnnoYD8IZbXpCgEPGKqZsTb2lRN1+QRvHIQAOq0D4lMo2lyBiEPUcdcaA6RTwu+NqPjlIldQQq2QmXt2idSW2Fokw80ZRAR41DwiAFl0MJjvAVWC1gySjp47mI2/yIHbYt4KukdpMLMgVMw3OeKqBQNsXG/4aP6DcuNGDVy1PhRI4f0a6IToQG6zu8aySWGPdcBQVwwLtE2X0BDqkzWbVonD4M7MKKvY0uUQyG4+BdhQ0SVD6Em1LRH3QayrqM5yHEvJwgr4v+zIA+RCsP/GIOVbkBNEX9rTuuCo2igEqiAzPBaKtuhI1UqgShI9wmVSQMg4+WiiSrk4hAzjeBUoFwCxcEp8KAcMnDAEzzcaIOaYASmw56l2IEITVPK5n8twXQef4cL4lIKxA7lX8ulcyqBVzZMcAKUfCLR/ty4UAyxVNotaGef2GVmBTUQ5l3SdKTFHCUIk2aEvDJL2t22WEhcNPK161ChCGVKlotFgVrV4OnvdGlko7Cu/wyhDEi66ewQCyQFLWVsV6AHOOaRXi3VXhDV3ljV2MvNeEv7v9fICVP0Ndt7vQ69vkly/t6AwZdNG/J5PK9Xw9OaOZ/2srd5X9tv81j8yOfHNn86Pnpip8b17/++e3J2dAbfenL8xJqnYvjm1We3vmH/J5Kzmgw+ecBeUeWpOBz94FPX5+tZvHcG/7bFSXfs+1T8VPHuK988/u3HkzPI4NXogtyT6+NXezY5j+63udV3MnjN/nNPI+vj5ccPH9zq2d1s3q9+tRG/+cQTW2++Pu663bEffdH3RRv/7Aw+mE4YfuO6uOb8MScuvAes/tUZ/OiLL31p0Lr43KMXrB8xpYHFj87g8Nqjr7+7Nn622UOXHHhYQ4vXZPCTX95t6ilr4153r3pw96V7/Du8dwavrvqhT5O1ceX5cY3rT93T5g8Z/GI65+LFa+LNx7/jP37XQSk/2fxvu216cU386c3Htlt40EEpP19m8r/zu9O2WBN7U7f4af7NDa3+7Ax+tny9/nWr4x03+/LIj2dtb/GrM/jq+89v0Ht1fFSLL698uOOnj/8r/OgM3ntmuPcjq+KTul9yW9NJO6T8ZPCaF5fd8enKuP5dJ17+UMNmKT8Z/NOmbKtGK+Odf+k1flSrvVJ+fmXcLqCieLsGgGMiWISFGCCvonSZDFwTm1CQElyL+BO2Yq+k9BIGDdKNLTjL0A0CS5ekCTM0Fn8+fBnO95z31O7JZ38b994nphHP0rISP1lOiFqUvPfJEKfnBeLhgYVj3mWEimOYhdZNSe68fQipj+xV55xSwvutu2KapsiUZyGexdQsHiohzFjlcFYzA5v6TcTTOtfiEiXEt2yNlnMe69lcORNx7eFgo2PFRFdN9uzGKil6/iFeKXY+/H4Rwfer+T7Bnq4f4u0CM10TCwmDQ8cvs5q5dDH090U+L64rIMw6X0T+0y1Ajz+0PrEXFSbyie3aAmF7Qtdw5+2DSP4RXT0b8glvY16We5sYPT4RZ5ZaSx/NIzC7zaezFyxX48rDEWetEftzKZfYoSt51NlugF7fEO9f++PYoxxiXt6l5Qqe/6HrizhDvlbqbTbxOFJwRRRTjjvfiTir8s69+ixi2PjLw8eW/GpcuRji7c2KPr0EMagceVL32nq6vojzSE/Oj0wCm5woMipSalx5+wAyfo29dU1xYm7mKQP9Bavp+iPefmiHjW8GUZRg/GXz9vVqXHk44uGKdfty3xEWJ+SPbrojzJ0zEWf0uFX3vyGarigXb32yga4/4mJzgVf0NaFvWnDaeOZaNa58Jxq/6OP6XS+Jj8I/y5pMZbhzMcSZkeSW888Jvkjv66Z3ltD1R10wS4E/lfDx2uIQaijLnbf3Iy5yqXV3InHkYl3PLftV3HkW4llKowZXYwkyYlBF448MmysPR/3fdJfQSCLh3w0jb2eOYFw5E3Eeu0VB9mFEN9+9OxuYm9hcOQPNr5ZXNP0JsT3ml5+u50Z6fqHf/5MWl+VNBMdwRu+s+Yhz5WKoC1hJtd8nunc2LYROETZXzoP4/7y48iwKcddrSwWY8EU6JMCqUICuD+JMP4MTYiyoHuuca9wyvX+Ffr944/qDT0FlgZFSRrgUHR/iOz+7muwKh+P1AyezBGfQ44NEvi9Xk2IWBRvH2deuLKP7n4l4VtiSBP84uLvBqPLRTTr/nai3ll8pTQLejQ37By1W0vVDfW6W4rcUuK1arKUuuIhe//uQ+a1RpfrkOQSFLjxhojS9fUS8vSp2hP0S6jWbo02L6PnHQDz8yVGjr69hzWoTbK4lHf9OxLO+8XN43oJSX0i855pebOpNxHcampgqp0PTfvaOk4ISdH16kfiSPYv+eQ89FmPSTJYwHR/iO/EZBg9x4CQZFVRpTO8fIi7G77C9MBPa931KtciSpeNDvL15u88XAsb5I7TqVKbXd9Ql7b2WZ8Mgr2yFHSVOz//vyPZL4p50QjaoBGzb6xVL1ycccabzgtNVORDx6kGpdcgsen1FnLU07c/5XHC9fFgiTr4Am4oP8TRlBzWfPLB7M65704Fe38VQj+jukcyHwruWPV+U6fzbv/2/C3hkauoXgJ0cJuP+YXr/CfGL19yF+gugQzy4x1Nwuv8R197r5OlaCHP2+FwUMJs+/kCcZ/v31MwiqJL5mqCrxkvXF/WxFiOjYrgwEW6wcZCXXn8Rb3fD+vxKwFL8hPaey/T60v4V2f8x1m9QLIWEjiRNz80L6PUT8XbVbS6VpfBGSNcw77AsHT/iAv0Fvy+UQbX04/zLvQP4VPyIs2rS1J6Xw+a0pWNSE1J0/Oj3P08sOl4BCsO7GJJCOdhU/RHnae1OHqkAQa/355eKl+BT7yGe9tJ6VcAHUPi4oKS3VJSu/xfk+O0oY9ulSvDR7FvWHPyDXt8RZ5w2l82rhK/fsGXuKyTp8YP4l7/jswpW9UefXSROzz8G4j+SSk9aVcGDZdFj5YHT+5+IWxidDSCq4C17v05fzPT2FfF3i2z2LamGbxkaGW0u/PT4+ozUr+VOf2Y1DM/WPvQrWIrOD3EGp2NgCQfeYeKcW510/4YjLpB53dyKA0U3BtLKbQXp/BBXUL5xLIcDJ9lz3+iqrqDnN+JfaiVeidRASDurd0v3PDo/xIsu5XheqoFrdeZ8FZLy9PqI/v7y0PbiGohq4Bd1FZOj5z/i4dt4U9bVgmHhuQcXM+Xo/D8h47Po+NjtWqB2mpB9yWvp/BFnGH5k19ZCy/moeVLz+dlTl1nNd04/iMDD8/e8wnVih2ooHji2gM3+7807HwHTnbqo4yO9/MPfy0LLK6PM/16VoZPaPX13xH/ypm6YeD284L/3UJRpa1T/va3CcYdmUHu9HvzvdtGWeLhSSzUI26z8O15tlAKTloZgYcYl/DTzhnpgLwVVZi4Ct0xZuNN92y9LuygQHjXffKzaA7vqtJST1kjBL6+fEswKd7xttHWTVSUFp4s+ndYcY2BFQddW7CukIICjbNwdycIchgpK1DMpsLntYBIT+ARb7PrT2uA1BX+ocd+Vr72wsf2XpX2TKKgKlr+olqmOPaviKPVGUjDfluWqMusfXJTzb6pZEAWL2PJSx048wnWMhSpn+FGg903Tg2Jq42WK1llsNwqWDdemSxT74O2y8SmB9hSk6p382sVhYjpe0UVPb1FwwC/621JRJn5b5y727jIFakptev1rvfFvnh7bfv5DAXFcGDxc3bFrpRe+G5+lYMN3wevBjY/xmpOzHduNKWDI71Af6w3EEtItFF10KQjZ5lxq/9kbX934Z532UQo8c2P27rrghtV5nHmoqkHB3dndaXNuMbHHLXd9DgIF/nFxXeNej7FtZ67Z3to26QeuDq4wdcEg5oVWhSIFg5/XPpXez8Ra73Se3ydNgem8S3D73WP8wdmRjo//oUAxkc+mY8we62hbOxKyZrL+xIWVQeJqOKuxqfL+Cgpe8S+4bL/VHZs/qzvGSYgC79IKV98lttgJefX41AUUvElMO3rtqAO29K0i/79zKThyNalzxm5nTLHhyJ+LMyg49INjsr3VG5tYdu7FvD8kzDb2UmVGOuMDYb6n8kdJsNA+XNZ3yBcvjd+xNXaABC9ZHdEfvAG4WcMcm5ReEqq3+Kt/qbqEj4X1qDR/JmGpaMVLEZEAvCdOOFe2iwSbI1KxB8KcsHUqQkdi2khws9x4iyHkh69iJs3e10SCsevyA96xBriU3Jg4fx0JooEHzYNk7uBP4rQbR6pIEEzKYfSd3YPJup5mzKsggTo3V5XP7DGmz7O6b1cJCTdnRTR1lNlilVj262cFJCgILQavCT+sjVPfL5VLQlrqrfcVrOuYpNSW2iaChBvtut/Zq/2wha3jAS/wyXwiL/Go+HvjsTIh11+kk3Aw0q+lrM0F32324VnTGxJObVvMLmizw+21Qk5IvyJh9OTtXg0hZ3yxr0lJ1PPJ79ePr5iz2Q9rkny9ZX8qCXOC3OTfPr2NjRc+qRFKJoFPd1Vnx1kWtkn3QCtvIgnfCkS0nQpVsLcahm4b4knYnHVO+pOSP3ZAPHnphVgSwq4HnD7U7YHztVxP74gmIe4opZqv7IE76e1IuxdFQspXaVe74464WG6ZikYkCQYGJ+xaK/zw9ev07Lc9I+GcyD1mgoA+diX+SI1eBAkb15kS1Es/vFz1vlloOAn26SouyUL/4ETT/GtCk20y3uYdZX4Wl195HnsRRoLOw3ZdtRYm7uiv8/PuZPuDutG9c2vt8Kuner9cm2yn3XXPOkQ641cfRB8InGy7fdJboyTijBeb7z7xfbLNqeEzLQ1mYWDSpmUZTsLq6KPpLUq3cZcZ368smYzHKstcd7zXH1PKVpjRN9nWs65L7Ph+Hjuj+WHL0GT8uz+8lM+PeIgLrVTXlZzMV2Wr6sAbSz9cuOJIgOtkPdZMiOxwNGXiyYUSGisn62Wrf7lBu8Yf7/PdG9QYRwKP2yJj82QWFmDm1liYQMKrb/3Z8m89seZwqd09SSRMfM4PZrw5j3vsfb1MKZWEvaeGDB1Gb2NbbiwNSHlOgoPamti1fH54wYTPfONXJGxaY+3+Lt4E78kvT9v6lgTDdNadnxLW+OJjRaV7M0hI+Dm8bs8eX1xbsy3Mnk3CYS+zeusSJzyDt+TiQBYJkhU+0n9SL2Gs/kh7nzwS3l/h79hcbYNJSHSJnC0i4ey6M+tm57vg53tMbpuVkVCr2NnlvModU5Y91BtUScLS9zin6r0PbrJe/cWsWhKqFclgxTIWZvBSQTi0kYSXRldsHS0dMWL8pp5V22S+IV5Pyj/a47eGOIRVFwkuyqW+N1Z6YMkco4CwLyT8aqw65H2bhZu98dzES5KQkdJyojFXD/+9VOvdsyESdo7GqC2KYuE7DHs8L/+crL9f8rbhOgt8v+nvwesTJGx2M7DqJH3wQ3MjFNLmUFDeeoq/fuIqVp19mLVmAQVJT31//Wb74Hxr6o1zhCh4uSBVIcX2ChZ8zKk1SIQC//Gwk0pdXtityolTiWIUJBnyVXm3O2KHq/TlBiQpMF+puS21/Cz2+vNcfxt5CixEfK1lrMwxSxbVIraVgurXZQ4r3Jj4r1wTvflAwYVfE2CS7I3fceU9JLufgoPx17alLGThg64L57loURDLqxbjFHkVc4n63bLCgILF63aKhfrY408dipd1MShI8s2u1TbywpyUmmd9sqTgsNWMJMMdjhjj1Ywh8SsUrFV/xStea4+fCrqt/OQOBcUL96umS7nimyJGlmg4U8B5uIMx+81VbBTcP8uxKLh0OUSnN98BczhS+FsnkIJ+H4630Jg33sSKepYaRcHdqxKdT1M88QFzL9kDqRTME0vYhed6YZJGp0nRDAqUvsfn+ks7Yk8yrLZK51NAOlUpxp9zw3buszW+XklBX5dqd8ZWL3xJZnDyeDMFIeU+R1Vdb2ANrNAH2Z8pcC1j7MqecxwbuPR/xFsFeBs7s00pTZmZGf+8BeNrvatQ25SZW4cTl5mZmRnDVGa2NykzMzMzc8eOxtfW9WXS5+PJzpmdOSPF/SRvM71a6uufzqEcx/GcwImcilNzGk7L6Tg9z/E8L/Air+LVvIbX8jpeL3ACLwiCKKgEtaARtIJO0IucyIuCKIoqUS1qRK2oE/UqTsWrBJWoUqnUKo1Kq9Kp9GpOzasFtahWqdVqjVqr1qn1Gk7DawSNqFFp1BqNRqvRafRaTstrBa2oVWnVWo1Wq9Vp9TpOx+sEnahT6dQ6jU6r0+n0epCoh/J6SK2H2/TgatZH32dgj1CjqVtYd7eGPGc0Bg8YEBhk6sfzGqOxd4Spq9HO+zEBWvi5S2Dv3r8YIXCQwvTzIChqfxpovbA/coULgXP19BkInu/SPdwUnPaA0XqtMXXrF9jFZA0O79sVHhBanYLjo1Cbw/HJptUh9urbzfowlobQgf/vgVrLqTIi/K10ekKt4uY8RqTFZSHUKumQYcaxL99h7JKPDR+uXjqoKpkR5xl6RhlIjghxMUP9VpOroyrtHvTITFZ2CZ3mN7U9aVSpwbwrY1eS4Tv2zh+X7RbZUWj6+upn3pP/ZRtkylPgGsG8Qw/dvBTuvsrg45Zyy5r/doHgbhk1xcjT9BX9tuVrR/zPNT1R8H8jyJbsw3ZsHTuCGILXJD6KaUDShbsX03yeRj5vdm/l+3AjKbAjbuvaWDNp0rF7Bm7EfHv+q8tWJZT5UkUafLJMu7eQf9Kqjg929stFqpyMX1pnuhfRFq7eYOzuluSulDhteu06ZIm7Kso/1IsYE15mFrP3JeXOahsPaTeDPOQ9Y4aem0yaPfUc0vVVG3v+N74t3p15OEQanaOf2RvyK6unf9zyKj0JSeo5XDukMrk1bXihxHU8+ZbSJ86/Xn5y5cnZSbu6q8nZ6h/zz25qJBcvR5+94NGVJI0pfGlQ5w5kVpOGb9ZtL03Y+X9t3f/L2y3vB4ZHz/TjlH6b7jQ7sXO8UqDPB3K//H6l05IToSfi7yt3j7a7Fl89hBQZc+FE0EwzWdBxy9pFrdy8iiwZ16vZuwpe7VcV6X+qVXmvwslxOU0f86QsiIwq6vNp867nw9sctuavtyrDoXvFSytrtyV06fo2TGnUmzft6zNXWZrwdcLtiFhlfZ6239c3aU70Hwbf50stJ1WOheQoleskmX9ye3LXVg9IPc2Q4xnrXSYZI79/8ey+Xml0YPrppONqc/Onq5s8hvzfL6YXU3vkVS4V7JDa80l9xXi2cO3T47so74q1N24L66zcCT99pNzZ2kR6xiuPc44li4ZM820YkUzim5eI375iE6l3/UyOQTuXklJ81io97gUopyru8634crw599o6M6dJ2y2XGu4wjcnorgyfEZFyK0lUkuvmvhZTxU9p2u24XmNUK99DVg+YNMFAthcfdTlieXfyPtL/WKaV40kV5UydCsXGkzMXpJodhwWTzg+K3R93Lp+C5yNn60bop41aHbUdCf1uh9AzPrW302zFgl42ek09m030GG2zX6bstFplivDeaivXqK/yhqi+/TP3pnYD2AtPnmnfgO196IlZ4+M2I4Lbln6wj1tbL/OGm4pP6X2bHtao7O7b5UWbwKb9G/q60cEDBIAIUAHUAJbTOACHlrnGWB1AD/h/F1wNQE2AwQUnAWQAccF5AbwBPi44X4AfoJYLrjagDsDfBVcXUA9Q3wXXANAQ0MgF1xjQBNDUBdcM0BzQwgXXEtAK0NoF1wbQFtDOBdce0AHQ0QVnBAQAAl1wQYBgQMhvfc/9G9c4QgFhgHBABMDkxFYmom2Uo8tXmixaaB1FyNEj1pGf2tzUn4XgnbkBnQB5ATg6A7oAutJa3Ry47oAegJ6U6+XA9Qb0AfSlXD8Hrj9gAGAg5QY56b8h/wUbOfXCc6sN8Fr+zObfoHtiux6x84HVln5d/47Vkg7Vrtms+5xTtriEQtusVpkf9NwWF7b4kY2vsf+mjd/64QBaC/VbaJyF3mehdbEO5sV6FqrHQnVaqC4L1WHL03nGU5uOW0MvoEW/3aIf46gf+8W62DfqstdBfVQH6sO+sU/sC/tFi/OEcXgf9oP57HVRD9ajOlAv6rHFL4u8J1NrYaz8Wzz2hXmxX6xLddh1Yd+om+nPwvSH1sLMD96H+bBP7MveL9al9VAP6mXXk/19QB79GId+rIP9YN+YH/VhXZwvnA/7ejK/3/b5YD4fFubzgeuMOrAe1sG+UQ/WdZyvvzT0Xi+qV5koST0/+daL7d3UvG9Uu2VjvrU3vz9hGulZtaWUVCKgdf/yvtKVg+PzVbojm7V1W30KqNrEvG9i5rez3jY2d5jQImDbM6M0Zah7LZ8STSXP6AbX2tfyNx+t0C7TaVVHiVoz9WMc3mfGulgH89J6EtUjUZ2oC3VIC4xNphQN7ShdaeO5tGWTNmZq0W9Gi35q0Y/5sR/Mj7okrIP6cL5wPrBv7BP7wn6pRT/G4TxgPcwnYV3UQ+uhDlwf1GO2VPcWnn/xl6g1M1b6LR77wry0DvaJOlAX6kTdbH9mpj+06Mc4vM+eD9cX9WC/WBfr4bygXmY90aLfbtGPcXgf1sF1x74xP+qjdVEf6rL3i/1g37RP9vNhZj4fmBd1YD2sg7rserAuzhe73/mvxn+r44WFcZD/RoeH4nydm/w3815aYa7/JR35mToqRgdH/p31F5g6dRgd5B/SUZypU5+p057hG5N/Zv0JUyeEqdOD4QP+Jh1lmTwdmTqDGX4Uw/cgf8/6+zN5BjrXGTGT4ecgjwF/UkdFpk5n5zxkNlMnnjDXDD+D/Ln1b+qch0xi8qxk6uxg+K0MH/k7dVR1jlP6Kc7XTL8jdjM6TzB1DjE61pLftf4jWjN1FjjnCUhl1uUSo+M2U+cKo0P5BR2ezPqPdI6L3OLMl77izHMvmfvfMXWeMTpOEHb98fyC+xg8f+A+BM8PuI/AcxHuj/A8jPtiPM/gvgbPI7gvwXMk7ifx/Ib7ODzv4L4Hzze4z8FzGO7H8DyG+zI8X+E+C89LuG9y+4WRDzAYUIDxf0zqF7ar6VZ5iOh971CmU3KvBJ9FFRpflbc+OBsWu/e23LlX7FW/6g/k0Xfyq8mGx/LajwXD3uqfycMGNKhYPem5/KVBzgeP5ANyLuVG/ynG/fKXvm13PI7fK1tqHir2rsJuuZNuVbU19y1y69Ql9xu23yq3r5gSve76GjlX6paNl44ullHHEMBQwDBABGC447IDRgJGUW60AzcGMBYwjnLjHbgJgImASZSb7MBNAUwFTKPcdAduBmAmYBblZjtwcwBzAfMoN9+BWwBYCFhEucUO3BLAUsAyyi134CIBUYBoysU4cLGAOEA85RIcuERAEiCZcit+okhOeLMinfMDHpId3gCM34NkhXcAG/+rfg8XeTyo342JRz8OR7/7z9wf5F/zZ3Thd/8NPwpCv9WX4Rf86Vk/jJWAVYDVdK7XOHBrAesA6ym3wYHbCNgE2Ey5LQ7cVsA2wHbK7QCc2J6S/+PKxXKJM17wWip7lBryIiXzcnlMbm+PMmMi5XmDiwZuS4iSI/4vateYd9Hy4Pyra98cFCuHlMnW5oB3vFx4XCC8EuXKa6J2jnuVLJe0jdVyHttYJ+evsS5fjXUb5FqFOvQ56bdFLr6/J7x2yrPK+8MrVU77Pveg3MI2zsrsv6cHw6/WjMr5qGZu6UNNjzIZDYcNOQwVNxYyZD1fzuBTUDDw2X0MmjmtDC9f9DBMnDDBcHHiUsMUz+0G/bTbhgr+eaWjR+pLK5KTJfhUy+msc5z2ZgMa60jTsU0Os41z1N6Te0KlmB5PLU23lhz7uMkFtOiXIS/Vyljm+/SdgF0AswvOAlAAKS64VMBuwB4HLh0F/oz4DiMD2IwU7oDRPxgmq4AgDC0MfwaNLWU3IY2Sk7YvNmAh0iU5hU1SURRrStgtHSYG3ThJWxrsmtINcj39dPrvu47pGg8G5SV4ZilLw6IubOvy+ONcNEYnTbBb/4vMxmQe2hSj6zGP52bGrBRsRuSbMtMinvF9+i/k70zji348XYv3Y5qpzMWvB0hb4IVRkDWvT+mwMVSHi506HLU+gFxfNr0z9WgcPsO4swJMUGlBdOtR3Ge6UxWkiUiZLMvWPuSyowFK36zJkN3Dx++PWeLfRo+OEBEbjjDg9o2Zd6wRtjqO6igL/AeX0ZrsxqysKjQ7z/M+cTo7bE4hPPUTB885cHWyNccNnQmpHkb2TzMEBdUotZDgScKf+L/biduxPGSKllPhVIjIl3q2hCpw1LeIuGmnMb3VgIzlM2L1BRAQGkYjyIAC9S+cXdtIZqA6C5YUMsOthSu9O1g8U5fg9lLaDk0n4ORsXOcF8MqjH1UlPyT0TLg/uYRCmUukFhWgaGaEOFaEBS7jvbcSF0rOo2ELac8DSIs/g5b5K97od3NjvDRmvoPYX1LA600ydgG97L1tiZTEZ/JWWqD3uob4A9rMm1vG6yN+bN00F2am0yY6FZnKJq6oDeM4w5VzljakDCwnKLiaOQ4PUf8SzqfcnbQUVbBLUwQrg5dINr5hs14jjRcieD5HDrmwL7zbbEZJqTrC7yVpDixDKm8dHdPjkW7ehvKkRYROtCV0xQi6Tmwj9XYwM762s2KVCeOdXpDUUM1Na2NcbSoRlYvhxbk0BOPa2e4XzI2CUGz+OMyRP//i1rGteL7JRinOjs7cMo7va2FBvhPmpUsprdFELuE5BTbHmfjEj9ELJjNx2QWKthTxb7EpZndPgVQHL01SkV/5kaFX4yFnkBlR5XhV/mSSfhf/tYVw73Mhj3vliBSIIt9bH2WRe4gt7eDwxIskz/JH+f4VlkcU4K+ugri5Oz7xJ3H7PBO1stP8LbkKo7/f0dkUzpeoM7z7dIBzamc4/MMNa2tNMofGsuJ8Gk4xu/D2Mea4lTpXJB6R9VGE42rz6dmtg6rANMaIj2C1sDOKPzezPOkkuz+PJPv1PHoC4/BY4cMVyRZORMWRdqqbZxvXUyXazqyzGnStDuKunTMN+tYYWo3iYHgw5hvk0bLPw716POor1Nn2vz2s8X7J0k0eiInko9DlwmTHV8gKXcJq9DrS9Or45lvMoT4pVroFMl02g9Mu8pSUp5A6eRMn37lyuCYcRZ91jI7JwU8oig5VLxiU5Zt3Ao4FK7FvXsKZhlBuGJzBJGqIMWHHUDNqJELnEg1ex5B6+BnhJj0ktBayPeQqW0MiGT8hgnFfqtkVcou64dVonxzHFmlfbGMlsCnL5HF4OuMNs3nePpqVe2T5/qCbujmZiE5OInyBCvahvojoaTA2agrrdZOYfqOAWz9usn3BRNwLzFDae5E8izOMMghFpLWbhYbHcFc7h06aEOKzJKgu3EZXRBElqatZUxpLvFYFnxI1SY6IosHYGRm7RnyPteB8dAODdVrcvJZMk4QavwPEB2qxN3Pkh8BD5B1UsbTIZfmwLq596ezJ6UAusonkEFUcj3UzukyC/jmC1HyYzpJ7MVhO/QfNChHWGH9lUk4MGnPv05o0hbUOCTzPj0XMYBzb/qpgbp8v/kdHEy7lQ0ncRjw93tHyHS6s2kxR7UOSHDPwrari2cjp3GlT4ti5fApT/QhbUUuP1VVKQjpJaVWh4b/zGGzP4mmjOycfz0Sh7gE35uvCrfOkbozkgeVo5JXSWB0SRK1QPL5JY/Hfcg3JiQrUP1Si/+MQ4XW/CM8Z4oPvLgQTB9EP8eKghwRDh4aR0xfCxkkDBekwzLK//cbTLf5x9yDaSQe13G0ceLMC1SZJHiuZMN9mMU+8KlEte0TuriFiuI7Arg9sbbjKbM/l2E58Tvr2A3jZrMTNoplzG0awzlyLGa8eotFWxCQPa6xUP3BQOZHpdwu5pq6J8MMYvt15iWTPbP5x+YDssB/io0I4bqjE2oqrzIo9x73rL1CxEiWtz5gJtWUE5jzlQl0+yVLZlF7fh7DrdpTNpZDFnODJrbwVCmOymD2njY5zKKeR2iEF3OY/wD98EQIdv0jPvYyz61pWKSSwtmgrSr1ZvNl6ls7H0YwxO84s3ThiLK2ZbHCHEO1oymeNwLshjCeND8jd2YWZwwRGCLlx7HYKd/Oest58BTMGxhLtU8gNQT3yDBcjWO9P89Jy1sj387r0X750GBFg38gF+2pqctSIOVOI3+aXuLwvprV2Ehm6f7BMehnme6x5nt2FR0QJKcpWjDX9wTR9Y2yKDiE/9JXPrzuYE1CK56nFCDcXM/zmOB6u77g9VEKkcD4BVrtxS71Lhccl9H38KZngSk9VIvJ/NnH/SQYPWc+7u2PYnTGPj4E72V19hDESiuyTFifIMYoR8pJc2evL0FAOFktbqAnS5L+aSRzNSKfozCBqCbK0eRQSVaxJdYIFaQn3qSofy8RwJTwtF6FoEc65yve8npWO244k9BUuMsG6nCGxVbztHOCEnjvvwhT5+vIAg2mJtPx8hvLiJ6jo2KA925SpNf+yb1CUgVWuqEyrZmPaAdacO8amOeUomNeTV/IaMZnTTPF6hEu0PQu27sRgw0+CJ4yj8/4EBsu6WJSl9Ft/8sWqnIYdO3E6cYEIjRaeSD3CZvMF3lpmsT60hGr98TR4r0BpWgO3pK8xW3EZWzreULP3LJc35bE2rB8LwUE+/n2T8DmaaKfOwSmyHvMvSexfoE3p5wusHxPDOY07JL4Zi4vAChzuthJ8OJ7D/ztD3zNNZkfcw3//Ks5WzcbwSj31y815u1sXp+/G/LrUxI6X1vg7xZCRshfz7ussPDwXowxztngIM1shDJ3loYS//8THyy9ZOWDIsMVXpo0rpXjLEaL6F/Iiv5hxxVXUbb3J8uIwDprYMjtMD8W/oxhvcwiF//kTojgFk9yJHF5wkr/+CCeh6AMf6/wp0i1gQec3epx+/0BELg43FrIk8g7ZAWLErK9HtsEOl7cNnI+SIUE+GudKOUR+pGF6ZRZrzpbitd+OoIC5jEtXJ77rBJMtPjO7TZj7lxTwDDIjVmY99/uS2d/0mtMNNkhqjvxd8wqh16/h88MdneN72f8oETf17SyT3QaLfvAcPwY7zRmxxYzm/1NwF1BtZFEYgJO6G/TgbbbFCe5byksdZ6vUN1Vs6wJUU/clVJGDO1Rxv8E9jrM0Vdwd1u74fOe/4zPv+DvHoeHAovpXojb0N1+0xRUncOuEDa7Z22t811G+ozJgTdUxNK5YUV5z+5sFVa827Gke3iYrHjAbJzTuT7+bNQ2wupPp5SuHpi0u6jvTABHpU/PYQ2OEJtsu902uAa4/lVsdJ0L7alsdyKoHUVrpQvtPlDnc3YfqIWeRoem2ADRN8bJwRj2s3bhGMfwcmsu9X5VQB02rYoNcd6B/m7lnk2sdlKj7J+0xRbO8iy3HpCDfGuqdKk/lCf/Eh0rB6WDZjuNjo4SW8Mj6+RYpuDID0t0b0VkfrUd6JdDGPVCdl4M+67+Z/1oCvspNQ0dC0RH5CqtYEniwZ+uKPRw0Z2v/104xSLzb+W+OoWVGViovxfDiZvxXjW3oh81PS23FcGfLnI3/6aK5WjpfOkXwOT+lZc1S9ISd3qlXImhoM9vmPzyCzg523yAClnabYFMjOrD/pbBXCBXRvjzbfPSyFsXYYCE81pAV34xCZx3b8XObEMzuStVnP0QP3N+yplsAC/WVVPin0B8VLjlsE8AuRWtJ00600bL1m2P4sP9u2matX6m8c/PiGXyYnli5IZ2BHvDRiWLXwqcR2+bbc9HcV7PovBrw/9ftkH/fMJ7/0R4dRg10Oi2MaKqjfOuZwq1q0CtcxmPno4WSmsqvVZDVfElPPRbNXWHA2lIFM4ThtWueoQfUPHwSKkH1yt3SA5fQRnaepxZVwleLd/b8Q2jeljjGuQpgSZ0D/bZSuXyaf305qFf/xz9oiD571CbLphzsF0de8lFEsy1DgqPLgGtta1lBR0dk7jJeWAYbJl7lunQP4f7ql69fKAVRotKMBXWUi/yvtpaA7j+ZCZMFaJp4O3NrCSSrLLqimkj5Tt7jj8VglC7PPv+Csr13kEoxjEa6uU1dR7NiuLseFAGsUwtJ9UBH+E1kDxdC/qj/ndCdlJkaFexCWDevMinTFs0Yd7vJ50EGK1GPrkvl/9q32vDAZEPNa7+VaI5jXr4bQMjfYjUGHc1ivZ5nWQAL7ZztR3oG0ZO2gQr54HnCf8doIzqi0cV9Mheu3XBbvrYUzTZk+LXmQKdm9cVrn9Ac7fZiXjZkKDMX0cPQvPOpW+OyIP9sxtWPj9G0t6n0Z5mQkdev8diHstWWwYsZ0GzsZP7sOJrz4NSSw+nw1+9a3OztaFlk20G7NHASm8QsIegIL+cm01Ronlx2/gkTzS6d8GOkgHF6j7aRMppxNHDrkk/wwexu8/RcNE3s9cfUB0j1dlnaNzqA9+Pj8Kz5HfDDdQ/N+Y6m3fvek5cMv8Qyj20Wo3krWI8iE0E58Ou1eB7lGaZ7H8aDyKLsjuEHNKfe/fC5WLCWiwhsCaV8wv7xwWj43L7jQ/JTNGvl8W/2kTCt7WIYfpXKu2/zzoeBkr/503Qvyjt2DO4OBuZkT2zfPsq3BEfXvwYuU1Rrb4+mJT2d1n4Oie8GysqsKE8yrho/hUQTP7kT2pSTDpkr3QW7C11a6oqUe4pmrvCFV5/k58yaR1ndb/4sNihPaY6vlvWjuXeH+8+Qi11HilQjKa8339D6gBgE3fq47BiaU1QSzX9Bat/12YxpUPkj+cLwENIuFzCzorMPvZzf+DGSJH+q9uW8R/PowgOPY0nIotAo5YtoTiPrzsFEkh604E7Ar5Td+r203pE9wez5MjqaF/gj8NJHEpjr84Ne1YvvZ/G30Z0pZGbAtYVDz9E0qyd/GaQR/sHpk28PonluD/bNySChbYeTmFpU7mV+uTmT1DK9bU8P9eD7VnXZlJxNZvjFR50qoLw4t9w3l5yaZ3lK8wma0W4itymfzNp7KP/lXipvO2e8AMjT8FzTdE00K0BvpTuPkPaevjuj3dj+PL99b1shKXzdcumfErRRVe1pzSKi7XB/0apX6N9K4xpmFhOmbX/p1xPoZaY2xZ+LyZOHle52lmjOFW+LnBLiYKT2i+N89IBI2/pFKbnRP3Svo6ULrahe61VGotazjdU+oLkneyZY5SR+r4T8vE3lyqO8lRXkyYX5/Sw3NGdsl05nBdFyTObqMtGsiRkWuZVENPRCLoKOpjFVe59UERWbFvXwhk5s7+gHtx+oJtxP5bM13qN5eTXuOjXEkP9myOAemm1XZz5WQy45xvTlHKTyrWb5hbXEyq49tMwMLRNk0Z/yyc8d7oaui9FcBd783QIS2vDfnzt+dmD7vnrFH0uE5BqtJpwPaOGLJVnnhGRJcUEzLwh99n6Yt1RIphXWJmldpHJH0wcWIjIvOPUtzRVtt9Z9caCI7LY90WGvi+bUyP6bEBH2jJFX9Dloj2MNv+8TE51o2TGNr+2EliA/3yhbTN6lt/qkFqDZm5adV5SQIo037kkhaMWeU5o+EuI2R2Forh/a6MO0a52ELJKrb6nag5YZfuszkRLvDFc6bdlPYnPgfwrKgqHto4/jl+AamdTdPZ1WrvzqMkPqbjgrBFq8TYJDKASK+9w30k5qNwJ1L2VbFavFk38UD/fwvIOvflYXf84W4bI/PnVCAiWs2os2ahUFOOnfUh8UoISz3z7M/l5ciH+N+cwNCZXwyYwtUdqhg/g3TtcwlSnB4bvzk1mi44RcPeyG5EpgPW3fGN4iJT0teyaiViXwSjbVjYcM7NfjoqOMEjYveDHWWSIikopsX8RVQVCyR2woTcV8TdgQXaSC6Tl/z3yBTuJIXloX9VdBG8scXcyOJkW1YRwkVMGx2i13Y4fCyPs3RANUpoIMZ3t9S1MaVl6aPEwbVRASfGfOKJGQoJtgoPdVMD4/1T1OIiEJY2dqKKOC3/rrjsxuLsDqr2udEVcN737yOrBNnIdl80tGIYEa0qyCvzTDUlJ79F1XFKAG8n5IlEKRh6/lrZ6MhGqIT+VZQxT5xDnZrqMyNWy/veKraJRHupzJVCRXg+fH3Uu60AkiHef9mt5Xg0sDXR+LcsmawuIhyqhhiTClNTUtA1/fPzARcTXg9EdXQrFfHj6fuv4NJNBAArvy488kYhzjZlRSfw0sPESfmEQy8oCPO2mMBi4smVn+U7qQ+EjX2ahMA8wPwcXjJDnEb2FlB23UwIclu6TdK3NI6OCmEf//329Ni/s9wIG15snIpAHP3bmzfgIpcZWv4yGuFrY93VG1kR7DAz0X3ZBAC6OPzJP+3HQSJ0+o4KIALQiSkzpuDefijQvtE5BQC89+frwiYZWMBL27czwq0gI/4VImW1FIPvbzn4vkWtgPFDs7IsiDib89ove18IewiK/ySydJzoFGymjh607fbj/XSLzbJ+QZ5ejgvOekJTdcd+Htt34apot0MAFPOzaRlUzaL5Q9of46aJibHc6lyaQ2pH46EurAzz+7dR2V4pVv5/RTmQ76L18qTxw+jv1vO7fRRh1cmWcxzqKHybo9q9rofR1M0S43nqWfky6Pw32U0cEer4UVTqvSyOaEP59Tjh7GRJ4tDW7Jxy+3D5jpIj0YrgkKmOFgMv2Vop366yF+g56EQybpPb/FQGP0oO/ebPpalIn/k1WN9K8H86n+AteMo7h6yowpSK4HZ9/RwYWOcFK7vrSD3tdDnPb6+CZRIU644tBSRg/DuQ2/Lm0qxPP6qt9GXAPE7jr/Q/GJeDyhl+ODBAZ4el0YUdSSh69wkrXU3wDewzuufui7g7zOaV+IhAZYy2n59KFETH5Kb5+CigywZ4+jVHb8GMlgRz2mjQYQHZxydYL4JF664fM5qNUAm0/TM/WsXGwvWvuaMgbIuxN0rQ1F49Ken+9SjhHaIhZMXpkhJh03gp7RRUYIdh93qwWlYubt1Rbqb4TAn0vlP9A4zNsnVdMYI+xsYk4f7dlOfGg9DxUZgXXDa1+BJJOsHfVtF200wp+T1/znipLwl2L+WNRqhFN7th3oYweQK+SCGzIZgad8f+/alVmEXZBipxwGXIqZpYsH/cl16euJSMDAVt5Ryy9pUlz6Xrqd+jOw5vqjf1eBFEd98uMQjWEgPqlyvI19iKy60v+cyhj4WJVoe3AiEYtedo/0z8Dir49Xj2HFkPpXieNRKwOnf7n3sTEtFi++3N1LGQZ25QhZH7pEk+gDITbKMcFTz/GbfhVJyY6UbCtdZILuM0OXI8QVZJTPkIP6m2B36e33hhUVOP3Tu05IaILb2141Z6B0rL5tGdmfCcbGf9jURY+QkKfeLCQ3gW6m8jcxFJMl/3zDQq0m6G3YmDxwQoIdjqcDlDFBc9RDoYtzIil3XPBCXDMc8jqS+a+kEO+1vR6gi8zAfOAIHlDU4SfV/43w1wy/BfCFiagaV2+dwkFCMxg7X77odxTgmVtmDVGZGY7GLW8XoGK8E6/gI7kZcllOkmRxFT5bP6eP3jdD2MmGn9/pDyHoX6mNMmbQ7f6+TiEuwd9k53sjrgWm7nYUR0kasNOaLCcksMC7igbdJVqCM3sIpf4WiFu4UKRiJeAnU+bYaYwFDnqLEy4OiTFeVvImKrLAvFVsfIsdR944vPVNJLcAe5Ll3XTJKbI8aFhH71vA0u6/RERzSfmv57yQyQJXVwkCAmkWaXyRMkg5VqibvS83FqUR8f5fRv5vhbfOnoW9tJhsC/vOGwVY4e/0/Knp4jI8pXeQh4RWuPOfz5ULSILPL9o5kr8VAr8/s6AOSsnqtg5nJLfC8yUJwihxFt5+84yd3rfCYr6Cu4ydgkf/IddSxgryoNOhR8SV2Nb4zluIa4PpWWP2f9gXhufkbxiFBDZYE9gep2Rl4MN/lKmovw125Z05F0HzcHe888j+bbDFcqnmdHMZUbXEMFRmg7i5yyweK2uw8/dNr2mjDdad8FGcpaWkcxZ3FGq1wYrI9tjg5iryws/EQSYbjN+c5ZUnrsAPPm7nI64dPvgmNDbE+QBOmeXyNhLYweOdaffuKcrJJ8Jneupvh0dfurjEsfPIj1v2MzTGDvzgm75KRQ3mc5WjUJEdipjGtKuiXHzK76YTktuh2Vvh6b6qgZAxmyagVjvM2TBjcG5aJflfF3cBFVX6/3H8DjlI17D00N0GcZ9lsLu3V2X9u4C1Dm4RxtjY2Hlc1q7/ru0g99Hh2D32YDEmYSuyOrryex74zDmcVeDe1/lOno7n+55dpK1pevE202rkM83BSUulIYTvoaOPUZJGOnv9ahq4CxYM4qcqtpeugwsi6ZHfrt65fRHWBZAovqdeDQsG6UH6NysXvzBbkmYuYXvrTbAhgW6Ia8j5xbkG7xdLj/I99kBY506sL9bPnJoAJ6bSgXyvPdM8F+jHczfa0X5wSQJ5xffch8FGS9J97I7doWpYH0FT+d67BhbuSIL/ztTyUrMfiAXNe/BmP5Oy9b/ZFe+GVUqSwvfiK2GhTGw/s2n4qMtwaTjN4Hvy92GjBa09umj6rDfw16G0ry/bm7eqxfNTiI/tpf+/7GG2M5l0nu3Rh8G6IKrvWB7Quz2sjyL7z7C9+m6wSzciffeHV8NXcHYw+XsR27PPg48l02UbkqrOFMJCCNX+yPbu58CaaCp8XbBRvwZm3zdkPd/DhyNTiMn7+iHrw/C+jmRaJ7aXfxHWx9PeOfKho4xwfyW1LWB7+q/gyEjiFBup/2SB3s4uP7qc7+17wEZr+j5h+6CjYbDqrdjzBNvj7wArvchfK4fFaLvDgh09y/f6v4XzwkjQuN9W3xkN69vTaL7nPxEWZHRDSNHDlIVmxxErG7b3XwZvTKWzmwb1qdgDf9+OfPeKdwBgbTg5ru3l/ct1WHgqLeBdgFpY70Us3tjOH2qCVQrSh3cCHMz9pLdSo3bBs6IA2GhHIuJZNyARNkSTIW26ak53hF/60DW8I/AFnG1P3Ic3zOmZC5ekki28K1AIK13J/PjKQZ/mwjobcvkj6wysg7VRVDuuXdCjXbA6hkzh3YGjsFAlaiLE9KZrZj8UN1zmHQK4NJbmvgl+3PsD3F9BSg+yLoET+lZXE8i22avHXFDCajfSy4d1ClLgbn1ITbeDntO7wqmptLlb8A0srBRHHX8V9dMYWN+G9Ocdg8mw5q64p0fE63mLYZ0VteRdg02w2pHmjFt90KiFSx1JE+8cnIPLLMi4P98cHVkNFwRSrT/rHrw2z11o3Z6sHyJt0BNTuVJjcwcBNtqT5yNMVX5xsMqOJvAuggrWO1HPf00F3QbDOWnkrJ51EnJhFx96oLJk9tbiFmu6fE1TeDdhIebdfWj1sQFfqTbAwllxKe8oHIRVMjJbMTbe+SysfCm6HWNdhWo4+42YseO77zzfwKU2VOKdBdtn+H52xHRKHjPIFzZ60hlzWHchAY70J5brz9Sf6gSXycii5g4DLFSLfz4eXvvbGPPckvblXQYNbHCgpdlN+UOWwboG8S/eadgGlzaJYdPSr084DGvqxC6823AFVr6Vjlj7jbhWA6v96dPVrOPwEfZQ0KETvUfnuqKX192e1GxgXYdw+IKKfP9ckZGSAec5kH2889AfTrSjeWNzQ9N+hIVHUmfefSiC39nS8IPnfy9cCKvfSLXNHQhY/0h8eGbCzIZy2EdBHPNYF+Ii3P+t6DHjs/XbH8KqE6I770SYYM1zySbrgN9aZ3QeSkzS/5WzbkQYXBpLfx1/p/vpdFjYLobyjkR/+GWD9G/nksLkHFhzRkzlXYliWDKJU8VQC8MiOPuqtIB3JrbADvbU9dri9ocobNRJS3l34kqLNXdd6POQ6NFVdZh3ei7+91zRYelbk489rNorWfIulQL2cqNTLTI88oJg1SFxDO9UxcIrX4hnKlzjr3aAVSel2bxb1QlONIi5gxvHD+sLZ/rQb3nH6ht4ugVdFig6tfkRzn4l+vzDulZqONSTxG0dH3O1GC6rk/S8czULVj0WT9nmNNLFcIFAm7tX62BhpZSYFrjm5Da4rEn8WMI7WPApkzRnzMMur3SwrkpUdGddrHOw0poYhqSFZBhgvUl6wztZD+CdvmTztuphm17AtVb05WXWzfoAJzrSXiE3IhNt0Tvt/0r8jne03GHhqfg+euiOWwGwpCDXeFcrGlbVihOtXntsbQ/rnWgd72x1hI21YmpSvyXL+sKqJ2I+7259Cydak+qj+YM35sCplsR1IO9wwVcjyR8Vy2ZenQTrrekS3uWaA5f40ZwhHb4OXwG/dCVbeKdrA9zdhTyY5f5u1d9wWjc6eAjrdlXAD0NJJ7/IZQmnYGUbuod3vK7Cmgdikmrf0BojrKsXU3nX6xlcKiP/nE+dXvkeLvClC+ezzpcN+r5L40jA1oJ2h91gwSBm3WHdr0C4bQwJcS9cfycGfudNan7gHTD4lDeN8Jj6IbALnGhBLHgXbADc3Z3uuhCQP2MorHYjiomsEzYa1rsSZ6N/W6cC+HkS+Zx3w6bDOg+aWLHo10OLYIM7tatmHbF18C45WeN0KWfODnhCME2/ybpiWpj1it/7/J426TiscaFVFqwzdhnWO9FCzxGBy6thZYN0MZ51x57CK0NpcAntefk9nKigYQd4hwx96vbJ1H7T82fJHi3WVKup9gbrkgVh3j2Yrq/bmqGNh1eG0Rwv1ikTYX0AiTA9yBneAxZuS868W/YlbEik5SV31yeNgE8Fk7TtrGOWD2cryadfAkLCJ5utoKm8azYPNrahRz/P91Wthsd3psoy1jnbAivlZNlPT49M3g9rPieveffsqNkvxOB7zzo/0sNlXrSiuYMGJ4aTc339qtVP4c3d6bxJrItmgm+LtKIs92iwHL10bRhZxjtpClgXQLp2tYv4EAJnu1PlNtZNS4JXhpAn5dMzTZmwYBK9eUetL6xrlGSXt3RUfm+2PVXwrtooWONGw1Pm5owtgI2JROCdtZmwKo5a/b343r2lsNKBjOfdtQ1w/wAq046tn7gb1tiSe1G8w2a2O02u9NJmXTBbILd4l+02rI4ly3cYpsQ9gY1+1CKOddrew0pvUpnUZXKW/C0+v5xG826bAhZMUv2AzNqJYbC8J7nZl3Xc2sKGcOqzs7Hhfke4czK9tZR13QbAYncy2rXujjob3hVK7kaxzts4+Nss4nTs/q2ISbAxio7j3bf5sDyE9rZvipCvhZ/2IRHNHThYOCY1FG394HoIlicSe96FOw2fCqeZC1aVdjHAq7uSe0rWiauBVb70zJPbyg2NsNqLaHk3zrqxxe/Ciec/5x9He8KCjCTxjlworPek+6O8/e+kmO1G3XlXrhOsqZdMC6RP5QPh7Ei6IoV15obDn/LJgmT5ycp8WNmBTuLduSmw5rGYv3Td7oZSuCCKIg9y5D/9hSNClv7KFLm9weLdSEH2LlCQKUcJMmulINMz8/twdm9g9/zhD9lVhgPb5oO21jhoa9vqwLlqVMvj7Fo/Dgfb7XEgnr92d/baD/HavzA74hC9M/vln2essuUzFLFr9qiW+1nsPm9Uy3O2sisPYLi2CmB4jBZk7vyK5Qv+nDI8n89P4TkKPIfPd7H5VsxrMfdqNT/eai4f3TL/rNX8Oub8vqbVe7E0iep/q4AUPQ==";
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
if (row.kept === undefined) box.value = inLanguage(textOf(row, row.before, 12));
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
if (this.edited !== box && row.kept === undefined) box.value = inLanguage(box.matches(":focus") ? textOf(row, value, 12) : text);
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
const range = `${whole ? "a whole number, " : ""}${least} to ${infinite ? "∞ (or inf)" : most} ${spec.waves ? english(unit) : spec.said}`.trim();
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
);
this.pictures.append(this.scale, this.numbers);
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
title("first", paired ? `First, ${near}` : "As taken");
title("second", `Second, ${far}`);
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
tell(this.message, text);
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
page.hint = el("p", { class: "note" }, "Drag a slider or type a number; double-click for the default. Click any word, or “?”, for its meaning.");
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
shows("presets") ? button("open", "Open …", opened, () => choose(SUFFIXES.join())) : null,
page.file,
shows("lessons") ? lessons.menu : null,
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
button("language", "DE", "Deutsch / English", actions.language, { translate: "no", "aria-label": "Deutsch / English" }),
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
page.code = el("pre", { translate: "no", tabindex: 0, "aria-label": "The call of lommel that makes the same array" });
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
not on the texture. Here a wall with a picture, a book, a ball and a card, which moves, are seen through a 35 mm lens, with the noise of light.`,
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
if (address.search !== location.search) goTo(address, { begun: true, further: true });
}
const BEGUN = "lommelBegun";
const begun = (state) => state?.[BEGUN];
function goTo(address, { begun, further = false } = {}) {
const state = begun === undefined ? history.state : { ...history.state, [BEGUN]: begun };
try {
history[further ? "pushState" : "replaceState"](state, "", address);
} catch {
}
}
class Lessons {
constructor(set, level = 2, turn = () => {}) {
Object.assign(this, { set, turn });
const titles = NAMES.map((name, index) => [name, `${index + 1}: ${LESSONS[name].title}`]);
this.menu = menu("Lessons", { "": "Lessons …", ...Object.fromEntries(titles) }, "", (name) => this.open(name), { class: "lessons" });
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
const styleText = ":host { display: block; container-type: inline-size; }\n:host([data-large]) { zoom: 1.3; }\n:host([data-large]) .lommel-live { --screen: calc(100vh / 1.3); }\n:host([data-large]) :is(.files, .under, .numbers > :has([data-number=\"time\"])) { display: none; }\n.lommel-live {\n--back: #ffffff;\n--text: #1b1f24;\n--muted: #57606a;\n--line: #d5dbe1;\n--soft: #f3f5f7;\n--accent: #1d5fb0;\n--second: #b04a12;\n--held: #7b4ba0;\n--bad: #a4161a;\ncolor-scheme: light;\n--screen: var(--lommel-screen, 100vh);\n--psf: max(200px, min(340px, 0.72 * var(--screen)), min(0.6 * var(--screen), var(--screen) - 316px));\nposition: relative;\ndisplay: flex;\nflex-direction: column;\ngap: 14px;\nmax-width: 2000px;\nmargin: 0 auto;\npadding: 16px;\nbox-sizing: border-box;\nbackground: var(--back);\ncolor: var(--text);\naccent-color: var(--accent);\nfont: 14px/1.4 system-ui, sans-serif;\nfont-variant-numeric: tabular-nums;\ntext-align: start;\n}\n@media screen {\n.lommel-live[data-theme=\"dark\"] {\n--back: #14171c;\n--text: #e7e9ec;\n--muted: #a3abb5;\n--line: #343b44;\n--soft: #1d2127;\n--accent: #7db4f8;\n--second: #f2a56a;\n--held: #cda3ee;\n--bad: #ff9c97;\ncolor-scheme: dark;\n}\n}\n.lommel-live *, .lommel-live *::before, .lommel-live *::after { box-sizing: border-box; }\n[hidden], .idle { display: none !important; }\n.unseen { position: absolute; width: 1px; height: 1px; margin: 0; overflow: hidden; clip-path: inset(50%); white-space: nowrap; }\n.title, .help :is(h2, h3) { margin: 0; font-size: 13px; font-weight: 600; white-space: nowrap; }\n[data-word] { cursor: help; }\n[data-word]:hover { text-decoration: underline dotted; text-underline-offset: 3px; }\nfigure { margin: 0; min-width: 0; }\nfigcaption {\ndisplay: flex;\nflex-wrap: wrap;\nalign-items: center;\njustify-content: space-between;\ngap: 4px 12px;\nmin-height: 28px;\nmargin-bottom: 6px;\n}\n.note, .unit, .legend, .tick, .inline, .readout { color: var(--muted); font-size: 12px; }\n.note { margin: 4px 0 0; }\nselect,\nbutton,\n.line input,\ntextarea {\nfont: inherit;\nfont-size: 13px;\ncolor: inherit;\nbackground: var(--back);\nborder: 1px solid var(--line);\nborder-radius: 6px;\npadding: 3px 8px;\nmin-height: 28px;\nmax-width: 100%;\n}\nselect { padding: 3px 4px; text-overflow: ellipsis; }\nbutton { cursor: pointer; }\nbutton:hover, select:hover, .line input:hover { border-color: var(--muted); }\n:focus-visible { outline: 2px solid var(--accent); outline-offset: 1px; }\n.menus, .group, .tools, .inline, .tick { display: flex; flex-wrap: wrap; align-items: center; gap: 6px; }\n.menus select, .menus button, .inline select { min-height: 26px; font-size: 12px; padding: 1px 4px; color: var(--text); }\n.header { display: flex; align-items: center; gap: 4px 12px; min-width: 0; }\n.name { display: -webkit-box; -webkit-box-orient: vertical; -webkit-line-clamp: 2; margin: 0; min-width: 0; font-size: 15px; line-height: 17px; font-weight: 600; overflow: hidden; overflow-wrap: anywhere; }\n.header { min-height: 34px; }\n.brand { color: var(--muted); }\na.brand { color: var(--accent); }\n.header > :not(.name) { flex: none; }\n.header button { min-width: 28px; padding: 3px 0; border-radius: 50%; font-weight: 600; }\n.bar, .top { display: flex; flex-wrap: wrap; gap: 6px 16px; align-items: center; }\n.top { flex: 1; justify-content: flex-end; }\n.top:not(:has(button, select)) { display: none; }\n.tools { flex: 1; justify-content: flex-end; }\n.tools > select { flex: 0 5 15em; min-width: 7.4em; }\n.tools > .lessons { flex: 0 0.1 auto; field-sizing: content; }\n.under { position: relative; height: 18px; min-width: 0; }\n.under .note, .source summary { margin: 0; overflow: hidden; text-overflow: ellipsis; white-space: nowrap; }\n.under .source:not([hidden]) + .note, .under .note:has(+ .source:not([hidden])) { display: none; }\n.source summary { cursor: pointer; }\n.source.warns { color: var(--bad); }\n.source[open] summary { position: absolute; inset: 0 0 auto; z-index: 4; white-space: normal; }\n.source[open] summary, .tip { padding: 6px 10px; border: 1px solid var(--line); border-radius: 6px; background: var(--back); color: var(--text); box-shadow: 0 3px 14px rgb(0 0 0 / 25%); }\n.tip { position: absolute; z-index: 5; max-width: min(320px, calc(100% - 16px)); font-size: 13px; }\n.help { columns: 300px; column-gap: 28px; padding: 12px 14px; border-radius: 8px; background: var(--soft); font-size: 12.5px; }\n.help details { break-inside: avoid; margin-bottom: 12px; }\n.help :is(h2, h3, h4) { display: inline; }\n.help summary { cursor: pointer; }\n.help dl { margin: 4px 0 0; }\n.help dl > div { break-inside: avoid; margin-bottom: 5px; }\n.help dt { font-weight: 600; }\n.help dd { margin: 0; color: var(--muted); }\n.notice { margin: 0; padding: 8px 12px; border: 1px solid var(--bad); border-radius: 6px; color: var(--bad); }\n.notice textarea { display: block; width: 100%; margin-top: 6px; font: 12px/1.4 ui-monospace, monospace; color: var(--text); }\n.side { min-width: 0; }\n.hands { display: flex; flex-wrap: wrap; gap: 5px; padding-bottom: 10px; }\n.hands button { padding: 3px 6px; }\n.controls, .section { display: flex; flex-direction: column; gap: 4px; min-width: 0; }\n.controls { gap: 14px; }\n[aria-disabled=\"true\"] { opacity: 0.5; cursor: default; }\n.head { display: flex; align-items: center; justify-content: space-between; gap: 8px; min-height: 26px; }\n.pair { display: grid; grid-template-columns: 1.3fr 1fr; gap: 8px; }\n.pair:not(:has(> .row:not([hidden]))) { display: none; }\n.choice > [data-word] { overflow-wrap: anywhere; min-width: 0; }\n.choice { display: flex; align-items: center; justify-content: space-between; gap: 8px; min-height: 28px; }\n.choice select, .choice button { min-height: 26px; font-size: 12px; padding: 1px 4px; min-width: 0; }\n.choice button { flex: none; }\n.row { min-width: 0; }\n.line { display: flex; align-items: center; gap: 6px; }\n.line label { flex: 1; min-width: 0; overflow: hidden; text-overflow: ellipsis; white-space: nowrap; }\n.pair .row + .row label, .pair .row + .row .unit { color: var(--muted); }\n.line input { width: 5.6em; padding: 1px 5px; min-height: 25px; text-align: end; appearance: textfield; -moz-appearance: textfield; }\n.line input[aria-invalid=\"true\"] { border-color: var(--bad); }\n.fault { margin: 3px 0 0; color: var(--bad); font-size: 12px; line-height: 1.3; }\n.line input::-webkit-inner-spin-button { display: none; }\n.pair .line { gap: 3px; }\n.pair .line label { font-size: 12.5px; }\n.pair .line input { width: 60px; padding: 1px 2px; font-size: 12.5px; }\n.pair .row + .row .line input { width: 53px; }\n.head .inline { flex-wrap: nowrap; min-width: 0; }\n.head .inline select { min-width: 0; }\n.head .inline span { white-space: nowrap; }\n.pair .row:first-child .unit { display: none; }\ninput[type=\"range\"] {\n--track: linear-gradient(to right, var(--line) calc(8px + (100% - 16px) * var(--from)), var(--accent) 0 calc(8px + (100% - 16px) * var(--to)), var(--line) 0);\ndisplay: block;\nwidth: 100%;\nheight: 24px;\nmargin: 0;\nappearance: none;\nbackground: none;\ncursor: pointer;\ntouch-action: pan-y;\n}\ninput[type=\"range\"]::-webkit-slider-runnable-track { height: 5px; border-radius: 3px; background: var(--track); }\ninput[type=\"range\"]::-moz-range-track { height: 5px; border-radius: 3px; background: var(--track); }\ninput[type=\"range\"]::-webkit-slider-thumb { appearance: none; width: 16px; height: 16px; margin-top: -5.5px; border-radius: 50%; background: var(--accent); border: 2px solid var(--back); }\ninput[type=\"range\"]::-moz-range-thumb { box-sizing: border-box; width: 16px; height: 16px; border-radius: 50%; background: var(--accent); border: 2px solid var(--back); }\ninput[type=\"range\"]:hover { filter: brightness(1.1); }\n.hands [data-action=\"play\"] { flex: 1; min-width: 0; font-size: 12px; overflow: hidden; text-overflow: ellipsis; white-space: nowrap; }\n.lesson { margin-bottom: 12px; padding: 8px 12px; border-radius: 8px; background: var(--soft); font-size: 13px; }\n.lesson p, .lesson ol { margin: 5px 0; }\n.lesson ol { padding-left: 20px; }\n.lesson li { margin-bottom: 3px; }\n.lesson li.done { color: var(--muted); list-style-type: \"\u2713 \"; }\n.lesson .question, .lesson summary { font-weight: 600; }\n.lesson .title { min-width: 0; white-space: normal; }\n.lesson .head .inline { flex: none; }\n.lesson math { display: block; margin: 6px 0; font-size: 15px; }\n.lesson button { min-height: 24px; padding: 1px 8px; font-size: 12px; }\n.more::after {\n--under: var(--back);\ncontent: \"\u25be more below\" / \"\";\nposition: sticky;\nbottom: -8px;\nz-index: 2;\ndisplay: block;\nheight: 26px;\nmargin-top: -26px;\npadding-top: 9px;\nline-height: 17px;\ntext-align: center;\nfont-size: 12px;\ncolor: var(--muted);\nbackground: linear-gradient(transparent, var(--under) 40%);\npointer-events: none;\n}\n.more:lang(de)::after { content: \"\u25be weiter unten\" / \"\"; }\n.lesson .more::after { --under: var(--soft); bottom: 0; }\n.stage { position: relative; display: grid; gap: 8px; }\n.frame { position: relative; aspect-ratio: 1; min-width: 0; border-radius: 6px; background: var(--soft); }\ncanvas { display: block; width: 100%; border-radius: 6px; }\n.frame canvas { height: 100%; }\n.stage[data-view=\"sampled\"] canvas, .stage[data-view=\"averaged\"] canvas { image-rendering: pixelated; }\n.stage[data-mode=\"beside\"] { grid-template-columns: 1fr 1fr; }\n.stage[data-mode=\"flicker\"] .frame { grid-area: 1 / 1; }\n.stage[data-mode=\"flicker\"][data-turn=\"a\"] .now, .stage[data-mode=\"flicker\"][data-turn=\"b\"] .held { visibility: hidden; }\n.tag,\n.ruler {\nposition: absolute;\ncolor: #fff;\nbackground: rgb(0 0 0 / 62%);\nborder-radius: 5px;\nfont-size: 12px;\nline-height: 1.3;\npointer-events: none;\n}\n.tag { top: 8px; left: 8px; padding: 2px 7px; }\n.ruler { inset: auto 8px 8px; background: none; }\n.ruler span { display: inline-block; padding: 1px 5px; margin-bottom: 4px; border-radius: 5px; background: rgb(0 0 0 / 62%); }\n.ruler i { display: block; height: 3px; background: #fff; box-shadow: 0 0 0 1px rgb(0 0 0 / 60%); }\n.ruler:has(span:empty) { display: none; }\n.scale { margin-top: 6px; }\n.frame canvas, .numbers dd, .plot, .small canvas, .picture canvas, .code pre { transition: opacity 0.15s; }\n.late :is(canvas, dd, .plot, pre), dd.late { opacity: 0.3; }\n.progress { height: 2px; margin-top: 3px; overflow: hidden; border-radius: 1px; }\n.working .progress::before { content: \"\"; display: block; width: 30%; height: 100%; background: var(--accent); animation: run 1.2s linear infinite; }\n@keyframes run { from { transform: translateX(-100%); } to { transform: translateX(340%); } }\n.work { position: absolute; inset: auto 8px 8px; z-index: 1; display: flex; flex-wrap: wrap; gap: 6px 10px; align-items: center; justify-content: space-between; padding: 6px 10px; border-radius: 6px; background: var(--back); color: var(--text); border: 1px solid var(--line); }\n.work:not(.shown) { display: none; }\n.scale canvas { height: 8px; border-radius: 4px; }\n.ticks { position: relative; height: 16px; font-size: 11px; color: var(--muted); }\n.ticks span { position: absolute; }\n.beside { display: flex; flex-direction: column; gap: 16px; min-width: 0; }\n.pupils { display: grid; grid-template-columns: 1fr 1fr; gap: 18px; }\n.small canvas { max-width: 240px; aspect-ratio: 1; margin: 0 auto; }\n.small canvas { border-radius: 50%; }\n.small .note { text-align: center; }\n.small .title, .curve .title { white-space: normal; }\n.rays { position: absolute; inset: 0; width: 100%; height: 100%; pointer-events: none; }\n.rays path { fill: none; stroke: #000; stroke-linecap: round; stroke-width: 4px; vector-effect: non-scaling-stroke; opacity: 0.6; }\n.rays path + path { stroke: #5ee0ff; stroke-width: 2.5px; opacity: 1; }\n.place, .dots {\nposition: absolute;\nz-index: 1;\npadding: 2px 7px;\nborder-radius: 5px;\ncolor: #fff;\nbackground: rgb(0 0 0 / 72%);\nfont-size: 12px;\nline-height: 1.35;\npointer-events: none;\n}\n.computed { position: absolute; inset: auto 8px 34px auto; max-width: 60%; margin: 0; padding: 1px 6px; border-radius: 5px; color: #fff; background: rgb(0 0 0 / 72%); font-size: 11px; text-align: end; pointer-events: none; }\n.place { inset: 8px 8px auto auto; max-width: calc(100% - 60px); }\n.place.below { inset: auto 8px 40px auto; }\n.small .place { inset: auto 0 100%; }\n.small .place.below { inset: 100% 0 auto; }\n.spot { position: relative; max-width: 240px; margin: 0 auto; }\n.dots { z-index: 0; top: 8px; right: 8px; max-width: calc(100% - 52px); }\n.dots::before { content: \"\"; display: inline-block; width: 7px; height: 7px; margin-right: 6px; border-radius: 50%; background: var(--rays); }\n.cross { position: absolute; width: 15px; height: 15px; margin: -7.5px 0 0 -7.5px; pointer-events: none; }\n.cross { background: linear-gradient(#fff, #fff) 50% / 1px 100%, linear-gradient(#fff, #fff) 50% / 100% 1px; background-repeat: no-repeat; mix-blend-mode: difference; }\n.scale { display: grid; grid-template-columns: minmax(0, 1fr) auto; gap: 0 12px; align-items: start; }\n.scale .ticks { grid-row: 2; }\n.of { grid-area: 1 / 2 / span 2; max-width: 22em; margin-top: -4px; font-size: 12px; line-height: 1.25; color: var(--muted); }\n.lommel-live.over { outline: 3px dashed var(--accent); outline-offset: -6px; }\n.numbers {\ndisplay: grid;\ngap: 4px 6px;\nmargin: 0;\npadding: 6px 10px;\nborder-radius: 8px;\nbackground: var(--soft);\n}\n.numbers > div { display: flex; flex-direction: column; justify-content: space-between; }\n.numbers dt { color: var(--muted); font-size: 11.5px; }\n.numbers dd { margin: 0; font-size: 16px; white-space: nowrap; }\n.numbers .why { grid-column: 1 / -1; }\n.numbers .why dd { font-size: 12px; white-space: normal; color: var(--muted); }\n.numbers small { display: block; white-space: normal; font-size: 12px; color: var(--held); }\n.plots { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(100%, 230px), 1fr)); gap: 14px; }\n.curve { display: flex; flex-direction: column; }\n.curve figcaption { margin: 0; }\n.plot { display: block; width: 100%; height: 200px; overflow: visible; }\n.axes line { stroke: var(--line); stroke-width: 1; shape-rendering: crispEdges; }\n:is(.axes, .mark, .rings) text { fill: var(--muted); font: 11px system-ui, sans-serif; }\n:host([data-large]) .axes text { font-size: 14px; }\n.mark line { stroke: var(--muted); stroke-dasharray: 2 3; }\n.rings { position: absolute; inset: 0; width: 100%; height: 100%; pointer-events: none; }\n.rings path { fill: none; stroke: #e8590c; stroke-width: 2; }\n.rings text { fill: #fff; stroke: #6b2500; stroke-width: 3px; paint-order: stroke; }\npath.curve { fill: none; stroke: var(--accent); stroke-width: 1.8; stroke-linejoin: round; }\npath.second { stroke: var(--second); stroke-dasharray: 7 4; }\npath.held { stroke: var(--held); stroke-width: 1.4; }\npath.pixel { stroke-width: 1.2; stroke-dasharray: 1.5 2.5; }\npath.held.second { stroke: var(--held); stroke-dasharray: 3 3; }\npath.limit { stroke: var(--muted); stroke-width: 1.2; stroke-dasharray: 5 4; }\n.cursor { stroke: var(--text); stroke-width: 1; }\n.legend { display: flex; flex-wrap: wrap; gap: 2px 12px; }\n.key::before { content: \"\"; display: inline-block; width: 16px; margin-right: 5px; border-top: 2px solid var(--accent); vertical-align: 3px; }\n.lommel-live[data-compare=\"one\"] :is(.key.held, .b), .lommel-live:not([data-compare]) :is(.key.held, .b) { display: none; }\n.key.second::before { border-top: 2px dashed var(--second); }\n.key.held::before { border-color: var(--held); }\n.key.limit::before { border-top: 2px dashed var(--muted); }\n.key.pixel::before { border-top-style: dotted; }\n.curve { --lines: 17px; position: relative; padding-bottom: var(--lines); }\n.curve.mtf { --lines: 34px; }\n.readout { position: absolute; inset: calc(100% - var(--lines)) 0 auto; z-index: 2; background: var(--back); }\n.code { min-width: 0; }\n.code summary { cursor: pointer; font-size: 13px; font-weight: 600; }\n.code pre { margin: 8px 0 0; padding: 10px 12px; white-space: pre-wrap; overflow-wrap: anywhere; border-radius: 8px; background: var(--soft); font: 11.5px/1.5 ui-monospace, monospace; }\n@container (width < 640px) {\n.lommel-live { padding: 10px; }\n.bar, .top, .panels { display: contents; }\n.files { order: 9; }\n.header, .under, .notice, .help { order: -1; }\n.under { height: auto; }\n.under .note { white-space: normal; }\n.tools > :is(select, .lessons) { flex: 1 1 60%; }\n.psf { position: sticky; top: 0; z-index: 2; margin: 0 -10px; padding: 6px 10px; background: var(--back); border-bottom: 1px solid var(--line); }\n.psf .title { display: none; }\n.psf .scale { grid-template-columns: minmax(0, 1fr); }\n.psf .of { display: none; }\n.side { display: contents; }\n.lesson { margin: 0; }\n.hands { padding: 0; }\n.hands, .controls, .plots, .beside, .code { order: 1; }\n.psf figcaption { margin-bottom: 4px; justify-content: center; }\n.psf .menus { min-width: 0; }\n.psf .menus select { flex: 1 1 auto; }\n.psf .frame { height: min(calc(0.45 * var(--screen) - 84px), calc(100cqw - 20px)); justify-self: center; max-width: 100%; }\n.psf .stage[data-mode=\"beside\"] .frame { height: auto; width: min(100%, calc(0.45 * var(--screen) - 84px)); }\n.numbers dd { white-space: normal; }\n}\n@container (width < 880px) {\n.lommel-live .numbers { grid-template-columns: repeat(3, auto); gap: 4px 12px; }\n.numbers > :has([data-number=\"time\"]) { display: none; }\n}\n@container (width >= 640px) {\n.lommel-live { gap: 8px; padding: 10px 22px 18px; }\n.header { flex: 1 0 240px; }\n.top, .files { flex: 1 1 100%; min-width: 0; justify-content: flex-end; }\n.tools { flex-wrap: nowrap; min-width: 0; }\n.tools > select { min-width: 4.4em; }\n.tools .group { flex-wrap: nowrap; min-width: 0; }\n.tools .group select { flex: 0 1 8.4em; min-width: 4em; }\n.tools button { flex: none; }\n.panels {\ndisplay: grid;\ngrid-template: \"side psf\" \"side numbers\" \"side plots\" \"side beside\" \"side code\" 1fr / var(--side, 270px) minmax(0, 1fr);\ngap: 10px 22px;\n}\n.side {\ngrid-area: side;\nalign-self: start;\nposition: sticky;\ntop: calc(var(--pst-header-height, 0px) + 8px); \nmax-height: calc(var(--screen) - 92px);\noverflow-y: auto;\nscrollbar-width: thin;\npadding: 0 10px 8px 2px;\n}\n.hands { position: sticky; top: 0; z-index: 1; background: var(--back); }\n.psf { grid-area: psf; }\n.numbers { grid-area: numbers; }\n.plots { grid-area: plots; grid-template-columns: repeat(3, minmax(0, 1fr)); }\n.beside { grid-area: beside; }\n.code { grid-area: code; }\n.psf > :not(figcaption) { max-width: var(--psf); }\n}\n@container (880px <= width < 1180px) {\n.curve.mtf { --lines: 51px; }\n}\n@container (640px <= width < 880px) {\n.lommel-live .plots { grid-template-columns: repeat(2, minmax(0, 1fr)); }\n.curve.mtf { grid-column: 1 / -1; }\n}\n@container (width < 640px) {\n:host([data-large]) .tools > .lessons { flex-basis: 100%; }\n:host([data-large]) .plots { order: 0; }\n:host([data-large]) .plot { height: 120px; }\n}\n@container (700px <= width < 880px) {\n:host([data-large]) .lommel-live:not([data-lesson], [data-compare=\"beside\"]) { --psf: 206px; --side: 280px; }\n:host([data-large]) .lommel-live:not([data-lesson], [data-compare=\"beside\"]) .panels {\ngrid-template: \"side psf plots\" \"side numbers plots\" 1fr \"side beside beside\" \"side code code\" / var(--side) var(--psf) minmax(0, 1fr);\n}\n:host([data-large]) .lommel-live:not([data-lesson], [data-compare=\"beside\"]) .plots { grid-template: none / 1fr; }\n:host([data-large]) .lommel-live:not([data-lesson], [data-compare=\"beside\"]) .plot { height: 110px; }\n:host([data-large]) .lommel-live:not([data-lesson], [data-compare=\"beside\"]) .numbers { grid-template-columns: 1fr 1fr; align-self: start; }\n:host([data-large]) .lommel-live:not([data-lesson], [data-compare=\"beside\"]) .scale { grid-template-columns: 1fr; }\n:host([data-large]) .lommel-live:not([data-lesson], [data-compare=\"beside\"]) .of { display: none; }\n}\n@container (width >= 880px) {\n.panels {\ngrid-template: \"side psf plots\" \"side numbers plots\" \"side picture pupil\" \"side code code\" 1fr / var(--side, 270px) minmax(0, var(--psf)) minmax(200px, 1fr);\n}\n.plots { grid-template: repeat(3, minmax(0, 1fr)) / 1fr; }\n.plot { flex: 1 1 98px; height: auto; min-height: 98px; }\n.numbers { grid-template-columns: repeat(4, auto); }\n.beside { display: contents; }\n.picture { grid-area: picture; }\n.pupils { grid-area: pupil; align-content: start; }\n.panels:has(.plots[hidden]) { grid-template: \"side psf numbers\" \"side picture pupil\" \"side code code\" 1fr / var(--side, 270px) minmax(0, var(--psf)) minmax(200px, 1fr); }\n.panels:has(.plots[hidden]) .numbers { align-self: start; grid-template-columns: 1fr; }\n}\n@container (width >= 940px) {\n.top { flex-wrap: nowrap; }\n.files { flex: none; flex-wrap: nowrap; }\n}\n@container (width >= 1180px) {\n.top { flex-basis: 790px; }\n.panels {\ngrid-template: \"side psf plots pupil\" \"side numbers plots pupil\" \"side picture code code\" 1fr / var(--side, 280px) minmax(0, var(--psf)) minmax(200px, 1fr) 180px;\n}\n.pupils { grid-template-columns: 1fr; }\n.panels:has(.pupils[hidden]) { grid-template-areas: \"side psf plots plots\" \"side numbers plots plots\" \"side picture code code\"; }\n.panels:has(.plots[hidden]) { grid-template: \"side psf numbers pupil\" \"side picture code code\" 1fr / var(--side, 280px) minmax(0, var(--psf)) minmax(200px, 1fr) 180px; }\n}\n@container (1180px <= width < 1560px) {\n[data-lesson] .top { flex-basis: 830px; }\n}\n@container (width >= 1560px) {\n.top { flex: 0 1 960px; }\n.panels {\ngrid-template: \"side psf plots beside\" \"side numbers plots beside\" \"side code code code\" 1fr / var(--side, 290px) minmax(0, var(--psf)) minmax(200px, 1fr) minmax(200px, 1fr);\n}\n.beside { display: flex; }\n.pupils { grid-template-columns: 1fr 1fr; }\n.panels:has(.plots[hidden]) { grid-template: \"side psf numbers beside\" \"side code code code\" 1fr / var(--side, 290px) minmax(0, var(--psf)) minmax(200px, 1fr) minmax(200px, 1fr); }\n}\n@media (500px < height < 940px) {\n@container (width >= 1180px) {\n.lommel-live:not([data-lesson]) { --side: 364px; }\n.controls { gap: 8px; }\n.section > .row:not(.choice) { display: grid; grid-template: \"name slider number unit\" \"fault fault fault fault\" / 120px minmax(0, 1fr) 58px minmax(42px, auto); gap: 0 6px; align-items: center; }\n.section > .row > .line { display: contents; }\n.section > .row > .fault { grid-area: fault; margin: 0 0 3px; }\n.section > .row { font-size: 13px; }\n.section > .row > .line input { grid-area: number; width: auto; }\n.section > .row > input[type=\"range\"] { grid-area: slider; }\n.section > :is([data-row=\"obscuration\"], [data-row=\"side\"], [data-row=\"vane_width\"]) .unit { display: none; }\n}\n}\n@media (max-height: 500px) {\n.lommel-live .under, .lommel-live .psf .title { display: none; }\n@container (width >= 640px) {\n.lommel-live .side { display: flex; flex-direction: column; max-height: calc(var(--screen) - 16px); }\n.lommel-live .lesson { order: 1; margin-top: 12px; }\n}\n}\n[data-lesson] .numbers > :has([data-number=\"time\"]) { display: none; }\n.lommel-live:has(.lesson:not([hidden])) .under { display: none; }\n[data-lesson] .plots { grid-template-columns: repeat(auto-fit, minmax(200px, 1fr)); }\n:host([data-large]) [data-lesson] :is(.files, [data-key=\"preset\"], [data-action=\"open\"]) { display: none; }\n:host([data-large]) [data-lesson] .top { flex: 0 1 auto; }\n@container (width >= 640px) {\n[data-lesson] { --side: clamp(250px, 43cqw, 340px); }\n[data-lesson] .psf .title { display: none; }\n[data-lesson] .numbers { grid-template-columns: repeat(3, auto); gap: 8px 10px; }\n:host([data-large]) [data-lesson] { --side: clamp(250px, 46cqw, 364px); }\n:host([data-large]) [data-lesson] .side { max-height: calc(var(--screen) - 54px); }\n:host([data-large]) .lesson { line-height: 1.3; }\n:host([data-large]) .lesson .body :is(p, ol, li) { margin-block: 3px; }\n@media (min-height: 501px) {\n[data-lesson] .side { display: flex; flex-direction: column; overflow: hidden auto; }\n[data-lesson] .side > * { flex: none; }\n[data-lesson] .lesson { display: flex; flex-direction: column; flex: 0 1 auto; min-height: 190px; }\n[data-lesson] .lesson > * { flex: none; align-self: stretch; }\n[data-lesson] .lesson > .body { flex: 0 1 auto; min-height: 0; overflow-y: auto; scrollbar-width: thin; }\n}\n}\n@container (width >= 880px) {\n[data-lesson] { --side: clamp(250px, 30cqw, 340px); --psf: max(200px, min(0.6 * var(--screen), var(--screen) - 290px, 33cqw)); }\n[data-lesson]:not([data-compare=\"beside\"]) .panels {\ngrid-template: \"side psf above\" \"side psf plots\" \"side numbers plots\" 1fr \"side code code\" / var(--side) minmax(0, var(--psf)) minmax(200px, 1fr);\n}\n[data-lesson]:not([data-compare=\"beside\"]) .beside { display: contents; }\n[data-lesson]:not([data-compare=\"beside\"]) :is(.picture, .pupils) { grid-area: above; }\n[data-lesson]:not([data-compare=\"beside\"]) .plots { grid-template: none; grid-auto-rows: minmax(0, 1fr); }\n[data-lesson]:not([data-compare=\"beside\"]) .panels:has(.picture.idle + .pupils.idle) .plots { grid-row: psf-start / numbers-end; }\n[data-lesson] .pupils { grid-template-columns: 1fr 1fr; }\n[data-lesson] .numbers { align-self: start; }\n}\n@container (width >= 880px) {\n[data-compare=\"beside\"] { --psf: max(200px, min(0.4 * var(--screen), var(--screen) - 430px)); }\n[data-compare=\"beside\"] .panels {\ngrid-template: \"side psf psf\" \"side numbers numbers\" \"side plots plots\" \"side picture pupil\" \"side code code\" 1fr / var(--side, 280px) minmax(0, 1fr) minmax(0, 1fr);\n}\n[data-compare=\"beside\"] .psf > :not(figcaption) { max-width: calc(2 * var(--psf) + 8px); }\n[data-compare=\"beside\"] .plots { grid-template: auto / repeat(3, minmax(0, 1fr)); }\n[data-compare=\"beside\"] .numbers { grid-template-columns: repeat(4, 1fr); }\n[data-compare=\"beside\"] .plot { flex: none; height: 150px; }\n[data-compare=\"beside\"] .beside { display: contents; }\n[data-compare=\"beside\"] .pupils { grid-template-columns: 1fr 1fr; }\n}\n@container (width >= 1180px) {\n[data-compare=\"beside\"] { --psf: max(200px, min(0.6 * var(--screen), var(--screen) - 316px, (100cqw - 590px) / 2)); }\n[data-compare=\"beside\"][data-lesson] { --psf: max(200px, min(0.6 * var(--screen), var(--screen) - 316px, (100cqw - 650px) / 2)); }\n[data-compare=\"beside\"] .panels {\ngrid-template: \"side psf plots\" \"side numbers plots\" 1fr \"side picture pupil\" \"side code code\" / var(--side, 280px) calc(2 * var(--psf) + 8px) minmax(200px, 1fr);\n}\n[data-compare=\"beside\"] .numbers { align-self: start; }\n[data-compare=\"beside\"] .curve.mtf { --lines: 51px; }\n[data-compare=\"beside\"] .plots { grid-template: none / 1fr; grid-auto-rows: minmax(0, 1fr); }\n[data-compare=\"beside\"] .plot { flex: 1 1 110px; height: auto; }\n}\n@media (pointer: coarse) {\ninput[type=\"range\"] { height: 30px; }\n}\n@media (forced-colors: active) {\ninput[type=\"range\"] { forced-color-adjust: none; --line: GrayText; --accent: Highlight; --back: Canvas; }\npath.curve, .cursor { stroke: CanvasText; }\npath.second, .key.second::before { stroke: LinkText; border-color: LinkText; }\npath.limit { stroke: GrayText; }\n.axes text { fill: CanvasText; }\n.tag, .ruler span, .ruler i { forced-color-adjust: none; }\n}\n@media print {\n.lommel-live { --psf: 90mm; }\n.top, .hands, .under > .note:not(.source), .tip, .menus button, .menus .tick, .header button, .choice button, input[type=\"range\"], .more::after { display: none !important; }\n.lommel-live :is(select, input) { appearance: none; border: 0; background: none; outline: none; }\n.lommel-live .numbers { grid-template-columns: repeat(4, auto); }\n.lommel-live .lesson > .body { overflow: visible; }\n.ruler *, .tag, .dots, .key::before { print-color-adjust: exact; -webkit-print-color-adjust: exact; }\n.lommel-live .panels { display: grid; grid-template: none / 1fr 1fr; gap: 14px 20px; }\n.lommel-live :is(.panels, .beside) > * { grid-area: auto; break-inside: avoid; }\n.lommel-live :is(.code, .plots, .numbers) { grid-column: 1 / -1; }\n.lommel-live .plots { grid-template: auto / repeat(3, minmax(0, 1fr)); }\n.lommel-live .plot { flex: none; height: 130px; }\n.lommel-live .side { position: static; max-height: none; overflow: visible; }\n.lommel-live .psf { position: static; border: 0; }\n.lommel-live .beside { display: contents; }\n.lommel-live .pupils { grid-template-columns: 1fr 1fr; align-content: start; }\n.section { break-inside: avoid; }\n.lesson button { display: none; }\n}\n[data-depth] :is(.panels > :not(.side, .depth), .side > :not(.lesson), .files, .tools > :not(.lessons), .under) { display: none; }\n.depth { min-width: 0; container-type: inline-size; }\n.depth .group { gap: 6px 12px; }\n.depth .sliders { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(100%, 200px), 1fr)); gap: 0 24px; margin-top: 8px; }\n.pictures { display: grid; grid-template: \"depth depth\" \"scale scale\" \"numbers numbers\" \"first second\" \"sharp .\" / 1fr 1fr; gap: 4px 12px; margin-top: 8px; }\n.pictures:has([data-picture=\"depth\"][hidden]) { grid-template: \"first sharp\" \"numbers numbers\" / 1fr 1fr; }\n.pictures > .scale { grid-area: scale; }\n.pictures > .note { grid-area: numbers; margin: 0; }\n[data-picture=\"first\"] { grid-area: first; }\n[data-picture=\"second\"] { grid-area: second; }\n[data-picture=\"depth\"] { grid-area: depth; }\n[data-picture=\"sharp\"] { grid-area: sharp; }\n.pictures figcaption { margin: 0; }\n.pictures .title { white-space: normal; }\n.pictures .frame { aspect-ratio: 4 / 3; }\n.pictures [data-picture=\"depth\"] canvas { image-rendering: pixelated; }\n.depth .scale .ticks { grid-row: auto; white-space: nowrap; }\n.lommel-live[data-depth] { min-height: var(--screen); }\n.depth .note { min-height: 17px; }\n@container (width < 640px) {\n.depth { order: 0; }\n.pictures { gap: 4px 8px; }\n}\n@container (width >= 640px) {\n.lommel-live[data-depth] .panels { grid-template: \"side depth\" 1fr / var(--side) minmax(0, 1fr); }\n.depth { grid-area: depth; max-width: max(400px, 16 / 9 * (var(--screen) - 282px)); }\n.pictures:not(:has([data-picture=\"depth\"][hidden])) { grid-template: \"depth first\" \"depth second\" \"depth sharp\" \"scale sharp\" \"numbers sharp\" / 3fr 1fr; }\n}\n";
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
constructor(element, { state, onchange, url = false, controls = [], theme = "auto", lesson = "", name = "", left_out = "", heading = 2, docs = "", language = "" } = {}) {
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
const spokenAs = (url && new URLSearchParams(location.search).get("lang")) || language;
if (spokenAs) speak(spokenAs);
const touched = (key) => key !== this.play.key && this.play.choose(key);
this.controls = new Controls({ state: this.state, set, touched, only, level });
const does = {
...actions(this),
undo: () => this.travel(this.history.undo(this.state)),
redo: () => this.travel(this.history.redo(this.state)),
stop: () => (this.stopped ? this.settle() : this.stop()),
play: () => this.play.press(),
language: () => this.speak(isGerman() ? "en" : "de"),
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
const { node, language: button } = this.page;
const unfollow = [followTheme(node, theme)];
const spoken = () => {
node.lang = isGerman() ? "de" : "en";
button.textContent = isGerman() ? "EN" : "DE";
this.controls.forget();
};
unfollow.push(follow(node, spoken));
spoken();
this.unfollow = () => unfollow.forEach((stop) => stop());
this.fromLink = () => {
const change = fromText(location.hash), said = refused(change, location.hash);
if (!Object.keys(change).length && !said) return; // it leads to a heading of the page
this.set({ ...this.start, ...withSpikes(change, this.start) });
this.remark(said);
this.nameFromLink();
};
if (url) addEventListener("hashchange", this.fromLink);
this.fromHistory = ({ state }) => {
const name = askedLesson();
if (name === this.lessons.name && begun(state) === undefined) return;
if (name !== this.lessons.name) this.lessons.show(name);
this.start = lessonState(name) ?? this.given;
this.set({ ...this.start, ...withSpikes(fromText(location.hash), this.start) });
clearTimeout(this.linking); // the address stays as it was
};
if (url) addEventListener("popstate", this.fromHistory);
if (url && begun(history.state) === undefined) goTo(location.href, { begun: true });
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
tell(page.working, said);
page.work.classList.toggle("shown", Boolean(said));
tell(page.stop, this.stopped ? "Compute" : "Stop");
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
page.name.title = english(page.name); // the heading is cut where there is no room
page.preset.value = String(PRESETS.findIndex(({ name }) => name === exact?.name)).replace("-1", "");
page.preset.title = english(page.preset.selectedOptions[0]);
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
this.remark(`A was let go, for with this sampling it cannot be computed: ${error.message}.`);
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
tell(this.page.computed, said);
}
figure() {
const { settled, compare, page } = this;
const looks = Object.fromEntries([...LOOKS].map((key) => [key, this.state[key]]));
const name = english(page.name) === UNNAMED ? "" : english(page.name);
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
const high = niceTop(Math.max(...profile.mean, ...(held?.profile.mean ?? [])));
const top = high < 0.2 ? high : Math.max(1, high);
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
const [picked] = page.selects.picture.selectedOptions;
const name = picked ? english(picked) : "Picture";
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
speak(language) {
speak(language);
if (!this.url) return;
const address = new URL(location.href);
address.searchParams.set("lang", language);
goTo(address);
}
tell(text) {
this.said = text;
const whole = [this.remarked, text].filter(Boolean).join(" ");
this.page.notice.hidden = !whole;
tell(this.page.notice, whole);
}
remark(text) {
if (text === (this.remarked ?? "")) return;
this.remarked = text;
this.tell(this.said);
}
linkText() {
const { name, state, left_out } = this.exact ?? (this.lens?.left_out ? { ...this.lens, name: english(this.page.name) } : {});
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
if (location.hash.slice(1) !== text) goTo(text ? `#${text}` : location.pathname + location.search, { begun: false, further: begun(history.state) });
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
language: script.dataset.lommelLanguage,
});
});
}
if (typeof document !== "undefined") mountScripts();
