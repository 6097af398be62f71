// Made by `make page` with ziglang==0.17.0; SHA-256 of the sources: 85cdaa4c4bef1b7a0a2e5b2847b1ea7e25c51c36bd2a301b09147974f2f9dfb4
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
const wasmText = "eNp0VeWWHM0NLXWptrWf7NJmu+PpDZiZ7TEuJ2ZmZmZmu3c28CL5lf95w6hg8ZxPZ6ZKdaW6utJAmwef3oAxBv5H/4b7xtzHaTVzv0/X6Li8Q3zD9H2j72J6Gtr7NgR07QXYtoqFiEJFG8Nt26asHNAVFAmLnkNQ0QiEdOhFll5PfZrOlvSk+63R2j0FtFKi1y0KbZOOkNGvBz3O9RBzy5SkmHrqtjG/zU0EOS6i6sRzG+TF2q0GE1GMUrwd72O+YDJ/LoU50y0AUh9txgN3vpKFpPiUSeGofa5M1FAm3QFJBDZpswnLxVweRp5KbkzT054j+WYSWkRZqUybGkwcZeo6F5mbtablWFbfzoTa2Vnn/LlZZ3XBYrW5W2ks0KavjcYSr4sy8p4aadVSQm4oSe5PJKk73ecaybOk6EwF1t/US5bxNs20P7tt6jujfQlLH0LuVeOZLZVOuXrIdDOdJoa0py+O2uJE/WrN1VIv3+2pxdgsi3r5pv5A0vcufYHmyNP40/jyGNtUYPaboMTKhmHTM/Sgl2rErpKTNKvlD23qfhHXvtliMBXAKQWL43bZtwefXtz79PbB+0/P332+9/7jk68vnnzb5R+9fvfo1b3PL948uffsyWfT3/f63Zs3T16XmvXx85O35rcM4NMHL14btv9d+p+lxixZ6kUG/jAwOBDMoYjv7zNOkIVpoKrrwT8u04Ax6Lx0vG9QeMg5VPMNgLVFoaf8UlDUBpWGoKG0CP9piRYY+PNfBgeMphhngqUtGTfGEc4YC9FfGZjVX77Cr1y1WjFaU65dtx43bMTlm1A2b9nCodrWlbyNtzNXbse2naR67fr1VTVYVruGKmGW3Vh0dw4K7sFus5fUFARBBi2KYlwfIzvvkFE9xMYZCW/WbgLIefULtrwuOrjfDy5e1fZJB7XOfjzgRdYe7HRi7eXDGhoBxOE5LaIeClGBbMwoASNywGEXMjEBAoMRhTTgpBoDbdztYH0PJBIjewCISCEa5mZ8dePcBE7g5PDfeIKAd1V/t0SHxB12jgiAPTTaKTJ6DobSKI2+2EgwZd1oCY4QVbbcTSUcPVbXQNZad/zEyfowjJ06fWZ46KyFc+eH+IJcBP9XoerScr+WzpGIQVaDJn2J6rIW0PvAM1VH12LDl2NH5krMEa5Hg+MJx1mCCgBEa/XK9nhliZTVVQu2pLWn+NTy5VW1nK5wURSacS214q+XTHvghnj0h0Tsypu36LYXinb8zvFb4eXo+N17NYRaTMQCjajvUID3rGUeDB+IhgTvn9vj/QN6eK4qeS2wRTZzXx4hq1pu3i5KigrORwX2FD6Sx94T6wvpiRArWBA1HjwA+EhADou6fnr73jmCZzf7iGR5Nbh2bMzGbpvI5KgmYk7iGAXH3Y7aGXLzUXQ7Fh/HgMg+r+3tey/g5so0nZe5V6TavuLXNCmAcoY5tKJ41FSQLTpQQNcT84W1R6o3iG+r4eGhId7YLXnjSFlSSUR1zXzYHy4PiwBLecWglL4E4GZGuT/vmZ/ErzArM+F58KFvNvGbzijWN7Mz8cBEuQOH6h5+zExoGnYCc47a8uWd1Z0OqU0QxzHSu/r9zuPMiPVh1I0xVtiIe+q6/jD+kYZJe91+Cj6xHKALyOdDAUJVwMqqjv2s9AbYSPimIVMgUDVfHGa21IQwe4UUtBwyc9rXgElV1yJSVRWXQfK8b3kgR6sWcEbuMna76fI3aL6lcZWJH+Z6VZQNCdE4fP9BP5MQpSV6f7w+vOfDOKlBKLSf0PvZWSXmSdzza327v2QjN/ZMTu1B0DibkJH/3Raskdyox+DPs+0GoSAdCx6IEJHI61RI9NlG8XvEyhY3RgkVG2afPmi9l7QkIf+ALjaYEZrZxTj/fx6qwct2I4zPfM1kksnU7Z9S23YPi5z0brab1b0nNzWebdvvrW3btm3b9o7x09H3Nf/+qc22D+/H68tT/wkUO3DueicCRvtBfJHuwe/s3btXUvagd/Y27Nvc0ealeutycXtPy9gCZdWs3+kZeF700r3s5l+AFNXwNixD8zT+1pEgmHa7F7qGZaduqZ7Gr24Wurl1+V3z1p3oIX7M4XRFj7Bi+81SnbrN7u3iRCFY2YDYDNPmuQ6KwnzrqOqmaTdRJn7C7q1uEHYQWfhxb10z1XW6ZWpOCxVjeePf1DWbG6rAbAO/ja3Csqm5GL85VbsrqsdP7HBUh2nYdNSApV2Vbiz84vmbiYYx28yjeemmhgI5cdEdlhsK5ZvProanpZsojovbp0QuzwNG72AlB7/25utvvP3RB+++9eH773386Xr5/vKrr7/59rvvfwvAgfi4UErKSa3QJjSJeeIdOkUXaafULbVIiUqSUqvUKWfwBXwJX8GH4DAcgWNwHE7ic3ATbsMdeAAP4RH4QyAEQRhEQCTEQhzEQzKkQhpkQTbkQAEUQTGUQCmUQRVUQw00QBM0Qzt0QCf0Qh/0wzCMwChMwhRMw03hlnBb+PGuMCfsJfvIfnKQnCcXyEVymTwkj4gP8SPBJISEkjCSQrJJDskl+aSX9JF+MkgeiT6ir+gv9osD4qA4LEbSKBpNY2kGzaRZNIfW0XraQJtoL+2j/XSQHpIOS0eko9KwNCKNSuOSvxwgB8rBciyLY/EskRWwQlbESlgLa2VtrJ3NsXm2wJbYTeWWclu5q5zmZ/k5fpFf5lf4dX6T3+K+3J+zqJA15qwCvJEjS1d1dQvcltVh8N631RVmZpBb8YDDtMy8qwmML5x4Rp6x43WYk5lgq72XRYeZPGGGZWZmJ0chW/e/16D2wDEJq1+99/fjKpW2CCs14Z3ineGd5Z3tneMNeUu8pd4wJz1Sf0R6o9I7V3pj0vu89Mald5703pbejPRmpXdzt3dZxd1CWH2B2NZa9Z1l42JeRQg3QED3jq+9ERSJcG+RYLL6NGqmtLAitOgX/PhZM/IF09vVo0CXwbIzG77stty5LJiY2YQ/BnqD5YuJRbrMfWgO7aMqRbtv8RGM9mwxYc2z0MT0Z/njsN7g8ipYwEA6FBuT9T3HpiL3u9hRLLWacqnit1oKVPGwUfU9x79obCg7aJy8GYdEyWQ8FQSNYNjTTq/vuKTPw6bAkkWeLpFqeclCJllOJMu9fokkrYdNF0u68TQkrbxk19okyy772glmq+SdEuYXVmITI22FVVeXgxfOaPjdYCrzJFDTWd0dPF+c3wsmG3CDfkUX+buoXf62dVddjtVn2/yojtSH44c36nfpAqZgjR6vY07wnBw1PVoRXUGIJEx1KRiTcUGr1dnV0iHjgah7NIYaQ8jqgq6CDvbjJ4f8HjawWzu61AhWnNwwziJTCiQMAbkU1A6DRV26NDnmK90VrIIPFk2O+13dFpl+IUx3mK+vQR6tC19hhiltcQQI0i+A2JNM0JfuCYYloZjqGFQpTxpvfJR0GquLYydH/QKU9cb9HqRarNgCaNDtO7rLV5DvYjrwg6MIPqNBuUQ3RfpC0wZ0rtKsVroaYyuIxk9d1JVTTFnbQAd/zxCYCplTFAFivMSvEjM06lqieW4JfN98D2SqPnT3bWJEXOf7dh20JbC2iQHdrpfElavV0ZQwSquzTNcXg2bDwOIeWF5/VACVTe9JTFfaIb19B6h838LRuFPhLKMwX5GUE+P0MQLWoOmXu618JkK/BB+xgqtxf9zW7r3ftyiFdXkRqunxM5DHdInRAhqlJfB4VgsQMcjij1WAUEdiHV2xCAy3pY/x0TRNh1eJUZPew1iU8KJl0pqaLkZAEZHGRIurwfHOhZCApswz3W6/c8/ongc7/FUojedwie5bHDm6F9/DZ45kN4EhkE1x3P2kbAZIKKrteWSK6tPonXDIfPhKBHbDhxnkEUxb3cKFszgg7j9b0mqSg4Mm85HyWgzA7EBqeaqR5NXDeo2E8GeMqAjcRnBMAq3FIrC122owWALBoDJAaQi6DEaG7UbgnU5C4Jmsg2lk7Iu+hIKJhHWqsba1bvsuurmh/g71+KIBae9ULRrBUAMW7A0j4KcAWvSBkaeCJnWSutQdYLacMGH1298hTAlMsPJFAz6TOUBZdTH1DE+xTpDiq8Sc2Er2ikh1JL9CCwv4bbU3E3HFvghINSvAHayBCvwHJX3hanKdasQGrH4l3FOljZBxPnKYBA12EsJAVfqiagyk7yCSKmjLQcRNO/QhtdNAvxT44iqRKBKtYkmbJQHmEi80ayKKIA/0cr64vy04dDhKZ6NqaAtKXHh0kZFb8pDrDPoh3ZNMfL3pWzAwzcspH7mRXrTBBonsma5lmpYOPIqDxg7eeOWi5Tb1TTt47Effm1VHVCSGdzz5WFsdBVu4gSjG/NlsfeffTIW+1X/6gWft9df9/nCQD9vQVWitgwxqrF2k5VdApaILUXFcpQDRv+73JkTH+j4Jg1PdSO2CG0v9SiEoPEEPgAqA2i4kZ5fv8KkFG/1zLUrrvabFzeHblrHvNR01IrgXkc5UjKAjd5uUUssp/TDwm8CXrDT8UEtVVpwC9+xrdSPBuzmCMY6Fp9MyooVPLOwUgEyfyBQiVGT27N/p8fJJ986c/0jUv9+xvxl77uVXDg6j/nt/+JUbN3tpwykMz33X7GahfH8Nw3/w1sOjBWrqlVpoism4hIaqi1HLFFoJZVMKfSFqTUR+gXQntZmCntXiLKAr6BjhrS2QsrDbyMEeJSxJXsFUR/10NBWyBzLLXpn6REUyLzXGMFMwca2d7Zl8h/H3RQqBpu1FMbXA1A1AzUR1ocWAaK5RcjN4rBC2Mo5kJq8kk/MqYFuoBfgodUrze7PED2MPWLnYZMhiFWBdaluNuI5QaN3A9FZchIu3LfcPdlE2qeasIa6+c9ZSefkasnhZCV8O/1x7H8LAl/R4fapJS5/IknnCF8hkMLTjxz+3xbsripNvjtTxcTBbcwQVc1G5GhXIU6lmny1Sqaq41gYram7GKoh06shO7vDK9279/VTz/RWRKzFOlpyDHdjEfeEXj2zVwN02PJ035IUcWqbxz6740sTjAngUh3zwcNkJRysx+qdXfGlklXh3r3YmfHhCUcUNBjc+em1bIYH0WMJWHRmdysUSiXwvlZqTlTBF3cZ1VvR0v8ykvnDCOHMLMzJF7SBRjK3tyDgzG5qStmeM1CWg3PTUma+Ur328Fs1sSEz9/cce/NP1X30M9fAT9fzVn5z/NOoTvDPdt5558d88OfhC7X1XmCu3HPhGbWZazrwGuv3mNStXrvx+7Yp30ePXCd2UZqA6PmQYQsFiK4QpcxJPuD9WlkKW5Roh5dRKozIKbWbkSmNnhLntnsz8OLFoSV+2VvT+pHGwhPDY6TWdWBMYRBAOjCiG/S8c0Pz0jeFvPoJ2LLLLp94RGUnZlLumHZE3RmrfBOTsGRl1LZMxfy2UUaQJ3NyKiSFdajthaZFEONHKYCeqlNWZfvoTc7WYWE2Lif8ZLbB9Y5g8uNTZc01wMOfBcZkDhwTA4wX8G9KycuGt+ZKbxtyAiJVx1B/Or8UqePRHK9oqK/DXsCxKbXnn003YDVqs1hMnOtcwSGEFXzFqs1T/BT/efKNP66tXhd5NaHKp4Kpm1BnRz19JjohZTK5Vi4mwU0nuRZaiX8XWUNz9ZF5rK+5FA3EDgxpJl2S6ADm44tWZb1m+yrecow+JVofB3oA4nwcn+CCuTtJJh5D14fTRRJvggtY2dERZc4lHqODv/vlX3xK3UQV//5jfPvJ8/++wrHJpP/adgUM/+uobmNBbTl/+s21nab29/Dcfq/5GzdbCEFgPM/7QCH+VhqYMYVLiOS1CCMnRoGBExSzcZ2ybVgtr3Ts0dNO8cRzO0GYf9W+6U//xb/lv1NLBFDpg8129XNW9vFtlDAXhv85SNvAFsCkfRLeV9NDDKtbqzR9TSCxWIZF5oU0yPLx42D4qtzS9PhV2xrXcBgQLT2D5NlYSFlsBhJzYdCaWMUswW242rwURFe+wOCPWIin6WFL4NrNE7HBT0Mmzf5cTGjv23xVNRf3Xzvzk2J1+MkkhO/HaU2997bY7aTi48RazTw0+RMMn/rgCffhZDH1q9x2M9X5gfrn/5KUw7Y+V07c87Jwv18B9zEGvhJ+u3E7Dk/ThT744714atkfE5VsOPEbDCrfzb2PoFzpBOIK3x+pUw3EYF40dFGV7URfCCDxhSmuhz/J+6VqOaRxNnbG21lgL/mzb8U5fnrPO0qIIpvU0PNTQ8ot/m8+jLHaL90XxpQ6OdxPcaxPZYQLKV/jK3C4QOmfP/vI/z1R+fpAF4PE75Gk/++sAOeaASz5797bLv0Auf1f/eM+7Hn2WqEtO/qNa/zvfYio/ngQ1A1p++c63P3nfnQB6n7yo94TCb4jvmfPfd/2vtxd9GB620/nv2GZ/tSqck35KoxfbrPUdv3moTc7PbNU2nipKNoTFD264x9Y3X/ZQ2DLcpSV+cOBnZ8L9e3DHlb14hEs6bKUSB4KZUq6lbZAnGI3GdgjwVpgBhDlcjiV7sq+RVWNqKm8yZjZMUhjjtToRew274xTeXqRuTR2Ubi9SH6feSumpw1PXpfTU+6kfQTcF7EUijU85EYX8i/bigoN04w2uHPqPJVyWWIlzyn1aUoqvI+XmJB1zVmQWxXwHyefgTUZpRSjwpM2hxnhdnhT/i5602ZM2e7KTdZR2vOJlhvkKVi8bHv4l9cx8snGKwLjMMIzXZZj6PzKMmldmCazKtYq5nQJxcrLCIqsg6mhFa+T/9+CFUJODFh+t7S9lk8oALTmwvXFYlJxK8cGVM1a3R/dRJW7ZdMAV7Lq39QQdQgXCXSUt7ABYOj7Gknif2dhOAeGLODhbFP8hUXfGv6gtOnqzG7x6WLS9i8/grEDR2ZuVHpHR8ReIydlbME13gmRyImZp+qq6ibCae4CXgeBkay5OdoaXgfCV696RWkBP2Kvl5NJ421IBI/3kzHulIl1ar3NO4D9itFrNTz5ymxxi+5LXT3QVkVyrPnCI/YXAl2z4cBh0N6ICXcBYokYB4YYviLEu9mHGUsOAcQEz2e67JClMvv5s8E4gB7bGG4efAnZq2dAi0Zd1UOx5REVL0hI2Qk3Ytnosb5JSNeOTxH+AbyBdwbEkjXwVJKO94yk3PXJ8nRntQM+nGyWH4MGoFUjvKtbAAUazmjhNO4k8FQoCATKfyezNOES1EaoG8EYltAUHCHaDQw4FNxCactLyeN/AkXVdscUyutoWaJuKLZbzzPljtBMJhHc+5oRwB5DgSW7iiDj+KULe9a5gHUVFeivjEZ1bivUYnz/4BBrp5l07zEjz5iJZcBg3+QxJMBJjwmbBwmsgdsEQ70q6ioc38PDEOdh8miYRWRlHtoEsCcC8aNBIzPDdEzsE7n91nJ+ZJZIskatbIjNL8jp0C4YIOxeCe/qEyz1AXosP0RuR/7MFcLE3wex5mpfQLi0XqKTid3mI/v+zsj/q8OvsDJRH5xDJoSlTCJYtbuCvzQE+0i7SydrSwyrJAZEcM6V6cyg9PTr5+NwOzi9rJztBqh0Dq0v484PBHRLMJhe/G9aU6suSq+OTvwTR4jsA020BhNQeNj6aM3u8trALOgXrfYK/mlq8xPllnmy+C9fla3UZvv0i56WcT/9OaoumrMwCXZ7gAilmUhgkIqZImF5EYzDhf0bkQJGBsJcmh/oFODFVgf5GjP9zZf/9q25SwSPFAfIUm5Sfffd8CoL3hfimGP1dPNKF3H++ux4SzbltKv6zoaFYA4sofVgau7SToN/27R9c2DdkrJT3zJElSXxKQ9lKWobkTpQsYjBwTjX2Duq+i1DOxo06P6EoOwOxgxrmme7IVCLTo5Fkn7/fVGli+kJMRBrCzxBLaDxEBoGe0uVWZNYLDUjl0Li6B+FxW6FeT1d0N21PusNIM8TrGcQrDAEAD9IhHryVwV3LEaTLsSq3EVNEoy8xexSTw4y8gskp/dKMPv4v1FwFuOQ4crYl2Zat7n498F0meZf7ZIeOmWnPxy/MzMf9DveWd76ZTebthpl5Z8NwTGFmZmZm5uR9Sf1Vktpu2jd3s4Hb62lbKpWqflVJ8i/3C+V3dlMy67siajWZIskheWP6t9y06K+RTanpfxQMaAJkGUuVHF1/ij1oS0y6GLNlNFZpKKs4vD73zWVPnuSEgKPMJ+/g5l04Cs8I/FdFQ78XVwwczw8o+lmuFI9+VK4nhA+Gh3m0UPW3ScefvkqwyaXid1PFr4aKmnz++t7Quk8+lwTmq6ncEz5Mht5Pv5bvC1+96vxTH3TH+ValIwAcMn5D8El9D5ZL6uZO5FvtPkhhKuozOUNLmKqeGZtetblX/RssQQqZp+Z07dXhq+jgnfLbU3Bn7w8xPqPK6JCTKSP343luzic+2IqUz1MiPYU4FA0zdNzfZxfv4pkjyfztNZQOItUZ3pV9SRpLoQSHpM/3+A1DPuDUnrPfFXd2ePLSMpCgAhCxfG4zJN/oOc6l+3l2l/vlQuOZCP6k/zY9Gf07zskIM2FfC/Yl+7BBKO65laOu4ZssGJr+B3C+JuePr8P5mnA7eLqE2sEJm+7z4SmbWTnMwnn68EALVMuuwzL1lk4PDssMCM3hYZnmE39vcMRF/4o+FU/msJyr1UOvAo8z6b+3+dCrHBx64bm8K0aHXgUfegFzBaS4xOvLlwG5L8jku+hDBa1Oz57D8y698bwL8Tg87pId4+bTI+5Irx6F8aCmczChLB4nIaJ3nV6BvlSj0ytYQ5qQeqyrEC9Wzs+Ky6z5zkgraeY0Uj+IbOjmb3df6vUkJLD7KiasLwyDBrOFHEoonBcjB77qRz/tB+gYB4k5/0ZMNjwB6XSudQ2qdMzZb3jyBzI9CdYd/5C/A4rnMvDkylHxnVKcU4v5N6GL4Mm94u72riPsbudvxs168aul+OG0mVxjZX2OrXRscNsno4HP4y75XeLJfo9D/AzvGlj8k/UXXjH/SjRh1lfllWx6cxLCBct0mqQ6g0eZom+imn3UGU+JfAPWc1zQrL7fVYc+x/tulc8Xne1vfJ+p5rq27m/y1kMDSeG0ryvpvqT31G56RW8XJPQPmIloQ1zOv4zx12wnZ0UFq/EPQgK76IWv9331nw05R9U1agpvki94BrFgJR+tMBmUfX4toYOggkpWQGa0ms2UF9Jy0V4tsAX/Twe9K6B5S9okMC3ZT895mFbsgh/55FniW2SIfizPzcUInyL4CLwBdJ0W8FQETwE8Q1M8gTf/XD6qUABRzmX0oS8W2Gn1GWybvx6doLvwqs3AJ0M+xVKNVrlXDBI1V4tWrfukkk9q6ZNKPrnPV3kBVxTGM8d4ZjSQ+dK1zq44V2NsG2w+0tjWaWzrMLaswHZOzGb/m31+b8/ALiMcxcSbOMQlSkopNgvQzVwDL+mewk7S1Vd4XFVJrlxAyQJQCBBUXKJALTojXlKzBvLO22X85BI/RuKnlvhZDvD34YE65cf6AJtN2VHQwB/6MLAG52uHXi+wvNz9wNLRp4mlpHcwsPrkA2uGA3svCPEcJRE3fxP7/oUqha5hhZ0hJ7wJDhifyz6VPS+T51RVsD/iXSFGUjzjKZfDeOSdHntXAjQkOsQxgAXSspT7w67isYfCMuS8VwIaD/7BPl+W77NPQCTtUAExkWfeRa+jpBNKOqJUeD1M6VedeNb97k8az7rfZpnMIQC+5+hJYSvUf9ZPZ/HyD9JVzZwZXTz0WuqXMcGCHPS+9rtFLxm4eEiePYElFCRyZkooDf8we2mrWdWfVKJLi65VJRB9eVKEvbpe76oDuoPOEJxeU8sXH3KHqU6BnBJDPvunkwlf9RnlLhs6LeIv73LY3amBOXLKrTZ0pamr4qSmknpS0Ak83MlSSO3wB2RbSZ3Ie9vf9ysPgR95/71HT2LfUPgtv2+Sc4vNzkEezgGSjd6NrRsJ6R0QYOGrTgoBjEAnYsWa+7sxMjswKskKK2N+2/f/ykMSMJ/3F7+pdw97aAFogOhGaIZWr8OyG7tiB3YVWV2fGDuYiV5gzhp4u9A1J0G33IEuJsRm4b4lz/VgulHx6J18KzDDvAW3fHMoi3L8EUITZhJSGGcSeTEBZTdhG2cXsgR3YYuUyxJnCB7wtmknFLqKi0wuc6JX6XR3uRr+iM6LaK0Xa8U8mhzPgYN6jJ5zw74hyum1qHwHvMV61qsHZfMOq6TXvAQYEcuvxUunAOlxmj2D9DlfiBQTy2EY33gk09r80zDnkqpMXpXX3uBMW/OjJWvQgx7TkoZNVwlBdEsi5WEykPnuuB9RWCjOshXMhKOAIZ6P1wuWEFzV/fT8MSpL7gsY6Gf+moBA7xOUsOY6+G0c+tyETqeHtpqhrSzJ4yyuiskmmYwaFIjJvpAHYiNmh8ZgkU3mA3387dDrFP//dCroZYc0KpqEov/KiTJP7xV+b3bY6Ri1cTuR0z/ySjHWXOawchnHruh/9Rf4Lemi/0O+IN++j2skGglE9VivjyfZyv/oENip+5I3+Lbh+xwAe3z2BHw9Wj3Sa4lyYhUereZ0R0Mx4QQ0CwBEFsE2svHep/jIIWabphLKr/xZEgI0JkgRZNcz+VU/cjOMoDfu0wtVjAEwoY63OvDxpgW+y0VbCYvdn+cCC3BUACfjfZAEsq96PLyQ/4dECxfyaswFvE9vNiBRk+dnvfH4fmdvEHBP9CbS4rfljyEkCARAQMADAgMkLMIN8Cg5kqnAQmNHxYicPcUDBAVijiFMmKVGHiwthY1d4StcbzEORvlg5G7jlBhXiHEWxtmxcXbdOBgG5t/gZO0RV2CEhMouZKTzUdfnTl1KXWPMMKAw4b4zlYGUMSQiaL0z0JJLv7x84BDDgCnPXKh7hsQBT12xXSrCV9D7LPaXcGgL+h5EY+Fuz7NB2lkOLpTk1BCHWQh/TEg5PJwjpB9N0HAePJbmDdkDkWYuoKb4nnvFV3CNrvKgA3sBYPho+lKiE+sO6XPuG2HGPW2IultDqIafN9GbwgSwlu3O/S1+hsI2ymjKf0JCs/1d6Qv6QvqVMl/gRk8KJumeOZaafwq0YnxUmPfwLcMc7L03rGJFHbceNZRVSxrPUasYBR5xzSMvUHk4DW0eOCGuDKQpUJ+QP3LotOpzRPVa3qDZg7JHQSWakaYHouCRxO9OFAA1VOJkeM7KuNyXQb0vDyG3SyORhQFwK4Cj57W0cf+S53lCfAPeWcI7G+JtxnibtxbvccMrwVuwENhHkJCG7aAkMN0nquR4GZwugju+FJflNwLlM4fFyVRR+CjMvuxs6uORrAsucGqlZDKDDDOwjr17aJ9LT4pPmlNenuuyYLc0NExTrjfzuXgrub596IsNYed+Pb8qGPxfRED2UW+/fAL6yV/kLY0lKdRMsDGPZOVeFPoM3sq698EslIjcXxo2RLTn/Xn+gZzQbxdRwY8F2buzt9ctwisHPpv/KF98yNXVl7aAlSgY2/v5V9nez7/q9t5TePy/03ud6OXpWBRyMvKrSz6PRGYgB6mbaXpuxLbJpj01vvDMP2F+jZt38QkyPj4Kz0aR/3HrnSbCe0MPSnpQox4UehCGGwk96iG5dfS/4dbRPefWF2g6xC3oxVbY4vOP499IvkKe9eWgLw+v5Hc6vNaKV9zMtRCZf3Z4yNT9fW7oFRG58gL/NZ/89dfK5OtHb/NX1JQbtpYry5nROsu1S6/G7qXL7xU+NzbVHl0OXoT9OtRDQn5FgTm1ipe5L3t9Hb3r8f0084lcrMScz++i+4Wv6LV+t0Fl8YzhL74smrK8PggvAH31l4jnfMATPTFZrozz9kv3lu54G95lvUyvWu+54W3yk1AO5t4Jc0mntzLRP1ResuRFLwdsYbmbnzpKy51sPTg/0arP3Ltl6We3+MJe9bBX178APMCTX9nn89+WbenxXt4kKig9UxI7gsxvC87xtgS7w4+VerhzDTo7OyvLkvzWxnGzrubHTraza95nWsjhVuZr39DXpIhiMsdYX7OgtzjTgVyGS3wO6NZQs6Rwq5zUGtJJ6lBrAlCeS6Ao462dKKkFT4taSFvPgviw6G4DoxY96p/uYseo0FGV9LVNC0xOWrYaZCZ6bLtZiprttk/uDtzJCFy7DdwmKmuky4nYYkXkgO3dBRYa62i9xgB1buS1S3ojXA3k8KF6DSlWBUF8DqCAivHBuZ93MuqWzeZbgS38fYq3w3qFdJA/AVDT1bWYfrwOZzV2qvHki0mJgr9uuRn8IRsZH5w8FW2NFICRC1LDQa1IGrrlDzQ0vhbwwUijHV7LdUwFtbULCeB8gfvCu5acifZMDTgyMkQlAzIxIEsGuLZGZcgm5KSVDnVbA81Bj9ITtcgGXWh0EV8DQYEKk4Pp9xbz3xFmUsUj6P78K8hqX5DWtkHGU+kn5AcAIgbNYJjrYVxBpNiWtCgRBStBcNA1ooprUc63lfhoRVElDRvvRB808K30W4kAo2aGcpJtgtFk2YYkJwed4zyyXItyblH6WgagXOmyHnZpSK5MXdq1Lq1oWetyIlkTgYCQp4p9knR+QkE99cHjqUBngqtcT1pYm+iBSQ5yfgosocWyATx0K9NvDlI5Wxu/bMv4jdM5DU62Y/y4No2f89g5tipkW8fpItxkCI6DcMDQcJ90x1nKmWgRuPhDCjVK0Bt6fx/+IZ9D1mk0Q2UXKqg459TmhhluWMbGGDqADNdzTqGo1ay2dRrFWsLK0ddYe+egf6yt09AHZVFvFsJVll7IMAiW0e+5rxaj4IT2w2budyPFaNhy86DM8kM+2s9/D5VIQG9hCLknRTxttTleL9A896CA8j0ksCfMZJXndi13Ld2mQxb3B1U+uZh2CmFN7wxW9aJXfNghL9ffQCOHN8m7ss+p2NPZ/KKr6PCAd0bqJW1FsFSYH6kKunjVZQ9qOXvoKp9B9DoMPBfr6/CsgRFZdE2o6Byq4s0EGup2GmbdKcq9C1nfERucU59T1it9INajKhRv62MigRIM8hMeoRphiskGTzdcW5CX5GMHKWovbXl5ncY5mU1r2tpPxbAKby7WwaiL660lTMIcjlCdMeoKkEl3gBTgtxMC3j6zLSGkkR+zsPzjq0Lsznwl+Vbja8KHHxWGQF46haTBP7RetlVyN0w48sb8RmyrrgG2DaHaOcKVlbpeIfqK90aY+ZXRdOFSOmrg/6gzwTsMDpvr/AzhPAMvIokjEafpopsEJJRMYXs9pjHJTzZqCqMw50EfRtbEU48prJz6CZ9voO3U1/I3o+iCS7qCWlmKZFktO7NPuktyiC4qX3iLD/1KYuowp/KYtphr1XuSnfIUITHAGVr5PZlUURr/+g6XAaJDMgzJ1LBr7L9ElNjtYMI0WBWDybVkp3TcSDBV3PDiesMiBlPBgE4QwAV9KQngmfyk/p9nJY6O1AV9q7moLsjeXfavSuZhpFkODA31bwgghSm34BK8AzWYcsMf7OHKTipk9NCIR0+0dkr0prqOglL2Egb3ApWcI2bSVUGi8p9ooME47FT/bxrQ6eNTrX0qTfj0aTgbGn5tev0cpnXLsjyWTZ76vQiholWatB9/FML8+CnHP5YfT/IV2eP37qbH70jpRP/ccXza002Om/yO4/vk3h2/b4sVzdKKRqUTFVqp2Pqn83ZCtl0434mBiCJHklNbNw5/sJmflIqyOn5f6qBteCliSV/hmUtdiUd19AYdQCmUxw95+Pi3wcObdnpYw8P6JB7W8LB5X8zk7yvp7Ztbvp7DWEk4KGzxuOiwm4XAmElgNHiPvrlEQ1fjqr7UkZLcB2gdnsov9NDczfY5YvrbVJ9Rd3TH0fOvGrngFWUhuUNqjtBe9f2CZhVCcI5/TpFC/IBnoqMkIq2nedcF5gTFL+n2Dtu5TAF7fU7zYPxzdHuvak/T9RnEF8pEQF41O81/sq+61J1hn1vFoTw96SiTSuPPIOS94YGebg9bOxxUu2FQDcLWXJWw9Wf86feb5piRMYpev8+r/Jk7fHNEVao38PO0P/PU/Hx3RkZqj1Cet3vLHJ/RfgUwYaVJAFYCfQJQcsL4agXHwyvG8Qwni9maLFMky1uLK5LFXJVkWcP1gHGtj6gKs+IKrvdkbp1CIiGxGP89SbNT+4I+hi+PP7wkgVN4boUiX99MIXTN7fQLt9sv8UjCiIaN6o9o1zjDsMKUtoAlwSYT1jDDiw71RNEx0Usr1OAV1dTrRDlYJha5WI4VCs755uav7695ZWdeJbY0aB+FOgMzDMwgIwbr0QxmRKgbmIE7GMU8qDe8uKFxHlrJqznSWst+rHx8ZtwPVXl1ET9FURtYM1qTiwFnJmyB8VnYCtCVDJJmXPp8L8gpiBgs3dJAexOe33CJjzyUKhHQPtsuJ7WGdJK6EWnGJVAkPUup9G07jWphW1gSH5a9WwvFu5EBdBd7RkURVUlf27TA5qRlq0FmzXizlDXbjZ/cHbyTEbx2G7xGlHHBkDYTEaHNdqGFxkW0vsAQdeXI7TLqTXgZyOFD9QWkWBUE8TmAAirGh5QpKlMRN+35dgU30xlRzK1ggNiT+pamRrSSfjGuK0LHZtm1LwR1OpIgLcJM8zYKP2HtbWs1c+gCg6DLz+etij9WBunGGRYprPDH9MKGE6RbkR7JZU+pXNxiVljHqR9s2kuqIgvAxQutULYKhSDSYG9OQq7PufVmKl0PqPQ/ECr9r/d0ebE4r7bQ6TcJnf5CodNfvoVO12M6Hc26+gGa2SV8uec8g/n05nGaSR/6mhRRzi8lwUM53zyns/uQzHDjcc1ErYhBekVMmk6CdNeAkXpOV6OdVGZ+4nELMl1K5tJh0oTauXQokic2bkWRWCuVIjjUMd+lw24zxgqPziLrZtvdZp/bhuk5wXS+HdNza5hKO0GQMLVs6BWBFNSSYljfTcH9LfU6sWiGenKIBGcQE1UopTKHJtApWhJajXeC1ib63G6nz1Wizws0Ex8seyS/SR3w56QHQbzCnztmtYU/Dw2RypakwZ9LwKfHr4KZEruRP4cFAcVsaUERCHRJH2ShlR4zZhMGXWbSFbXI0MeJCPQ/HBHo6rr+JiHQSesagb4pVOpBrBcxS4vNEZVJ+0FYTZIarkqaKl+JJnbUDtTtcb1lFXJdxdSo1sQkawSiiTSRXlGPCq6KmkCKp1nGjjWJm9KqjIlTbu5wLu1Th046lGSxyx68k1oBRcJ5LyXFPEx8ExGTuJ/vDwQnggQiH9q5b6HOuUYiRqhzKlwfktHI1dtGLoxMtm3kpCpo2kyc0xgmFYhUDivp6zlcb9eIc5SEeEMSjJlzhLbU7KLOQ+A8Z4U6B0aCeTvRKHYCIzAbq+8m3MFIHVazDdz5TYk7hwzjYAH/Fu78j3Zx53+MSpmNmPLzORcl7rwI3HmBgnLEncuyjnZbuPNfrnSFv+m4iT/XK/y5vmr8ub6Oxx/F5roFWYNhAQMqFcKfyw1AH/PnKJcx2smfpz6qbX3IaLpoEQ/4bgJdg6aVxrywTkNQDBl0mLaFQU/N0beQnuh0G4NeC4NuMV4jBp17TVspptDRacxzu06hY3LBRPScRKEPUBAKfR3eekihC1tdJXJaKPSpHw+oNAfSQwp9E+TNAPJZb7dx6CpgUcpc5shS6pGZpCpZVVAc1NJNx6HeDFl06PJFW/HER60hAWMtxURXyKwBgcZPYXPtMUSyjpSJLW9kwDknG4aH1KE0yOYoQ1V2SOqROlVky6tR+EwFiGYcOVP4MIgcWLMaOdNR5BQBOyV0uVqhy/9pVufnNf7K3xppDjWaqdEw3ea9XSPNrZDmAs8aa24TcOu0OWBSqFyjzTGAFe4FM7A6+IK6MW2OyVNo87+rhDY/K5Q5fRyngNtGm0820GZTkMxOaPN1aoyo5wzBfnxw/D7dDCTZNJBkdJPjRkiyCZFkEzJujk3bdDNJRskPkkyscx4r83QbSSasF0t6yzz1yd2RBBDDN3QAZzZygCdw7+U73RNu9QTuyZGAA6nXRFLPEYOHQFYSCArzNxfRYhNCwkhIOFB57lLrIr3XkZLcB1yxlb7tvDBqe/scK/1thu5dIsz/tgqEuQZhTmoSYR64cvxz2rtEmIskYoymzr0xYT4/bE/JLDCPhLlD9s9f1Z6h67OBMHciIIT5mUj0nmWfW8VBPDvpEDNhfrZ1GwPW8LjPOGDr4YjWG0bUIGDNVQlYf9afiawuJlD9nD5/5av82Tu8O1oeJ53xZ0HsnpWRmhPKp9r5Mrv3MNnOhTBPAFqBfgmgFS7aruB4eMU4npVDh62ZMtucKSfAFZlirkqmrOMKUOMpxE1roN6DiXUaWYSsYvDnkmOn9wP0e5Et18yWn56qxFF3LrHlTWDLHRvVfzKxWsUzh/P/2KZ0oNMktlysWGPLdWDLYZlY5KRc2HI4592YLXdoL0KJLRczzMoylA4LXWTL7YAtvymx5dJqxJZDSWDLv73SiugzvYUx1yPGHFo1qQM7ia+C1lOmzKFQ+4K+hDLn7r1KorYr4NNzOi0PXLjxuGYmVsQgvSImTcsg3Rnwms/p1JAXKz1uuVspmkuPSRWq59KjiJ7YuhVFYq5UiuBQx3yXDrvNGLu0226w2+62+9w2VM8JqvPtqJ5bQ1UPmbESauj7ilAKakkxrO8qX4m06C3EIot6cogELcREFUoVqPNKdIqWBJfxxRiuIexiW2ihU7+1tOXudFRdJ9UymqI6ONSfC3QTkcjYzfLGqY8buFqcFDx4A94MKXK7QBasUOQFp6hQ5FoaynupNlDkBU9xWLmdUOQ1FDFF3kCo8XWrUCjvmq5Q5JdylV9U/83evwBKdlT1wnjvZ+/u3X16n3fP6TMza++ZJJMnA4RkEgKZxgETA5LrX6/c++m9wQQv35mBmyDycSWQCQkwQNARoyQhkp4+qFFBgyAe5TUgalTQUQGj4jVqwCioAVGDJvBfv7Wqdu1+nJnJA+VemeT0rl1Vux6rVq1atWrVWq8aNyngrDw9wxOqkN2iNk7V01TNmpC9Lq/pjW2glt6exgX3pGCDWDez4YeDRQjDs+LoSWNe9cqn+0laMRdA6iJsogXk640Lv2pK5SNqwMq3plSuGWt9zbZ+x2u07OyvVGhgCshrO16rtmMxWPeI0djsfsSAuJ0eiAGic31emmXsXEtM469VY6leJsUz9IyK/wesgUFYdlBLKyOmK9WHBYwa3jHIbsK3xpjILYlkrnoLIM1evvMn64PsrW8ytwU0pPb2YBMvfa3niwMfZ7+vau2wI3cW257Y22u9tvBA6ftiirOTsqub3Fc7fFjVsK3CO4yownK5rkx6hUM/Ic/aPYPjN7CM8JajqPRuL1D3XfDF4GljRs3A3pqIutJ4D8RfpV4F0QzkOVtz5Dlo4L0CDfmOv/pMXb9CPsC6ktcF1wXu+ChV87Y+bNunX/ECNNk7voMP1xrUoY5cfIFIiKp97jG8wOHiTPb39lpHHthcR63F/NJ24L4/Sn/rWf/yM2tPH+574Y8t/cqv/9oDH2SzgM8/65tvuaP9nReXFgLvgisPZ2zwnlf98u/+7hk/+7ThvrO++srfPPSOp8DY4C03XvzkBz/0bgSv+qeP//J//u+78P3/71VXzqU//iMIOhCog5HAGfobpm+I/JBXbvKytwCkRXibrBVFyDFHJCY6kscADqDyFUFtjI8mWnsFFKIa/QfnOiCUt8ECZbSex6phF6/nUaqlfAiWcpQ/GHEDkyBwMLysaABFj8ltGkbVX8Wz9Cf5hj+9+yBMePTvQjyn31um9w9/lIP9B/DLOT//3reisGaPMx2VlMGvIYUjmmkVv7zhOvdX/5MVYdcQvzSQR1cfmT4SfdQG5L5oct4hNZFVHpk+En3URobABQ3stK9oGPr665v0FfHoqzy1r78hfcXveF8lZXB32VdAXzzC3MYjS4++p9pXfNPEN4+wy/ewnywYos/jlOLbhD3Y96K3PuPyP2z/Bbu48u5YT2/zvODayjQZDhlXr/3k7/7XC//oM4zzn7v9zDd89jP/lSeKTIZXfuVd3/mXW3+DZ9Ann/9htrF5Bgxr/uSDMLJ5PXu3UWOfznZmRAGw9FK1k895xYGBWgZyRjIFlY9wc45QZPNePBwcSd+Mto2SgcJ33xXBkSJ0yWKTs3SMd3jxt7l9/8It/f/+04eXDnz4P6Olz5bCf4LnIPJIjyW07xN7Dn3wr//lzg+wh5d3vecDb/u7HDP7nd92+8HnvurN3Hc0nDGWTbymP90UHyoRfKgc3z1R6U9rYEgXT8L7YJWp0iOlapz59iJg71pVM6/qfwvQMi/n732BmEl7yOctRv/uu40XmJIu3n5DqNbgdBUpaYMNHKwQIe6PC9/+fCwqo+ZjjYewg7/8zC1Le6/KfXJvgyK04aMDBjkMYPDDxektxrI22ntlpTUUrLPTwbe9/cPf9J/+ZvEZA35lBw11POCZ4Tuf/Y/ff/VDO56BnHcmN/TZo4K4sUge/gdOXXnvG65/0hFC6sH/9wO3S6pJOfX+4hfvypBy108+fKSScv+Rn3j3h6/7pz5sqV/TvbWScvE//ME/dl/6SaQcfu/fvaaScsZ//+VXtH72nUi595pr/t9Kyi0f++4vv+zBVyKl9ort+yopz/7Swcv/+gvPlJT3H1uspHzuda/b/oz3xpJy8K/+bK9LCe95XvKO131orwBm4W2VlG976vtfccV/XdOUg5dXUqLT/mn7j7TDvRWfE3kiS/I+mzTcZz8fiIMPUwi/FRaaX9y0dqRMbzFSpvcSKdMhg5Rp0ETK9BFAyvRRQ8r0kUbKdOxAynSs0hSLhxY7BZqp2epAt6XisBLLqxq2pdLvnrET7NBb7fqOOjC5XS35VrikbO/wIfUP+yI2l+xyHykvwQ5z5wNSecSZAKqXqasLtuMfUP66FVTjsy+YWJ9jb5uW3ZvMfltec9eIhXDXhkNmH6h+G0zg34YVJKS6a2v2k7o5UevXZvZ39w7FWSZb1x2me8Vj+9m1W76IXYsnXnRhk0HfD/0x/2ZfEh2APpwpIJUfHPkWiUzTXw385Lr42r5sELDTOdSlGix4HewS5327sU1bsHgEMeQjjndcyMgvkuWh1FiWvFG+WYD8h5+8RYzw5PveMZ68Z6vjCfWmEjI49AXhF19caxq99w5mH8yUeu7edYXCvod++gu//5zvuYLHu6nHhZpdqXxzHXF1jqPmbUWqOKRH6LFEUnOQ/SDKQVQkUc4YtGZXPhrpIdJTtYp8G3hyfiC+qRnzNg5fy8rzpguK2E++pmbVx87Mvgsu23H23Bse/H5ywSt7Uii1hjiuonSYi4c26HwBrNjOWjlso8JfNczlfJZ6S5Zaet50W539Q8CC84w7ueyfNNYdF5/teaVNVw8/NeMpR1URPTFXut+YT0j/mxj3BLINxpBN3xcUU7IHFWeBSxkP9+HfOog2mN317chKqhRQeGiamp5N0+d5/pQ+1LJXv9oUd6HYg3yHKS67AfHY1JH00Nc+3ojYUY9srt13jrYb75u3+56Rdr9903a74u8aLR7vmxf/pZHi33ESxW+MFb9xXKj/drX495xE8UdHi8f75sW/Y6T4959E8XePFo/3zYu/e6T4j25a/Jk1g5CHXz1SuL4fw3fZVw2he1PAu3h4vHSkR+zgGyFVETja4xna801TaA8EWZik0RqFSlA04qiPiJ+tRNTXysWsiMxXzbWq7XdHWZC/xfkpNFRKvNtpeoWhDB3JcsRJ97Kmgs7avt3ezy3+09PvRwUUajbNJXm8CiFRCVjhc+NBSBxgQtA3AUyA5LuXuWlu2TT5nrd3vTB7aRTMpcyu6XZbI8JKTSHkeiBrh5SqjczK0cHD++aYcd8IZrwdWU80K0eLx/vmxR/82Mis3LT4l/tyEq/zcqwCfT9aG6kBS6oYf77d1EBTzruZO0/RDMKTzHO3mcIodWS+jlaL9837tTHSr/efBNjuHi0e75sX/4mR4j96EsUfGy0e75sX/8BI8R87ieLvGS0e75sXf9PHq8V/4iSKv3e0eLxvXvydI8V/+iSKv3+0eLxvXvxHR4q/7ySKf2C0eLxvXvy9I8V/ftPiAxY0/9cRNiSs2PD9eZj6yl5vRNZqnpxNO8NAL0iQLOCqcuRl16svCgqrvt0D4+ZLnZOlZzijM8msiKwlYy7Rxrz7q1X6/fJNeKO3//CrK7zR4es19paR2B82sTdOzfvg4WrsmxH76Lmrr2HuTdnDjZFu3TzegQs9f7QSXyvxsy+Dy9IETdU7JN4Ja7x3pMYfO/kaf+36E9SY1fqf58KxA7sFedMzuQnyQe4rktb09Fncw92Elt3k2Y9/z3PM5253UFOTTcku/wEUrJtF4tcv4VXVUdXtHFZe5MFJlvPEJ0QeZ+xqYQus/G6L0PBFlmRvul5x1mdgkMce+rMNRXc+bev/0ut5ykhSdtv1GrtzTZN+BXb3s7dKrMZnfygfokE/qAdIuzUJE+o90h7ghDGAfbrPixHE+voQK13pOdYj4bt0v1dm9012X7P7mv02f4Rfj3dqsCaeFHViPISHAE3BLgqlMdW0PJ0+FGc/rv3APkeV5OAoLtU5Rx6aJMqFfvY2ZGx5myZR/Ax/suAYm9mafIPIOwQ5+jUc9B9GnDbZzPvb8TCWttBY1TV5OOUCkAMFDFCAVcSJ0NxIlC1ih8Y3el4wzTy4uVcF/BdHL+YMsKsnggv8wHAz3VVMoxAoFtjxAgults3VqPYRxQq+kZUHpeE0Z2I7fS9GCOU47zdFCK0F44BcWkMhGzHmuOe0bbdhEJgitcaGHNDaQMxaYRRaQ2ENA6ssaRU+tHXWv6dqfxqHIio+hWOLwFYQaAW61UYWDme/d4OxQi0nUOo3xDXeGgEhc0NP5MFQ53iQn/VLe9m/WqrELSz1b6tN3ayNgTQgO4jqH//Rq9btRm94gtF77ePcCsVjaUdWbcf6Cdrx0/CRNMUnvtQOKmEvxslFsRCCicgNnwxGjKGQO4aMABhCqA3xXzmEgR1CCvVM/m2HZFOjty1jg/6RgBA0KUKtruqYi90vaGrQK7bohVq5eh9ftPRqoxRal06qlR1r7oFiwJQrkRoUDnggLbsDDVoRNFT7Jl7VK8DtSP13AtWdN1RBpbj27wqqn75hU1C5OfazJw+qcARU3iagCsZBJWvyKKiGN1VBZSaEAiv7dwLW+k3HA9bbkQpnZsqskqzQsuJ5uuLBaP0FwV1ITG9IGnLcz/tS75X8K38GxHcx6W1YS+nltlx8d+JbXAAcHtFLgz5vwD1qwBHFgJ+gLbd4qPlArlqzCWDRwKLKD1hgxw257CfRHHFnlZaey9J+60BRk1fsHtTFGBZbrLJu1S18NfWOvwQakGYBh2YQ13CLB49WMdWzn0IdaKVoH+HCSheS5QTYkUwrF8hjr/G0ZETxCAuzjGFtqMmcee8eXw18oVS9lWMWh4b1f/fQVyETB0RaYnJMdwEgo43+QW9N26zNBdWVBt+JLJxhyk6//XAaXs2F4XmFeV5unnoekVZtfXrfJI8Z1UmqVxJYrJ53uDOZycF90lJ2myeZZ2aeNc0Iyxe+GA6qQzJfzFFKc7CXNt8rWv2rWWlB7gBwbbGItOM1HEOcwUBckAJIH/+tVywAeA2XgRbejBjFDYld0A9naIYWvruHRLnYHFsBto+suc8tyWAwJVHzZWf4e/MZPLixojZALRk36lCKv0th9qG/95o1aWFM8aaNWyBTdT6DmoE0s9zKfNbgDrWs0aKZPT7gN8tfoecKqgUufkF6yDW8OV8Ya30H8OMxyPpsizXPyKOF90G2NpfXaR7l6vW7gzyjDFRyRjU02sHIlxuwvvTgu6Eqq432tcXV2iLMzIwfAOn75A4hT2+7Wj/f95kG4CBHeHfh2NXBje6tHYtUBHrm4q3lqghpr4NU+CS9JINalY/jZ/prceLLRZTg2kientVSO7pstwEY30Nw3S7Mjzsc87J3idOaOqtX5IkSygbyJNCNxgNs9C5xSCg3arK7kB+WzS4RQKzCHwa/sU4z8QWa5/Fm7yH0SJhv6lDnQJFlDyMmn4X6Obo9i1o4B5vGzz09awLkGOHnhmJhqnwboOtmH+Lh4VEG/j4zyNE4gMtw8B6DgktzMdTBrR4P7Xp2Udt/gKFqqHRN9Jo96vCTEWQGD+BVFogOmW1dMU/c+nkCxKzLvo7UTjUg1AwaMSONAC5Qw3SRq2Q+TYroe7pk1XTzLzf0sq8gl+3/bMUUmDxmT/fDfAHxHDjfD4G3eMTgI9+/zFW9f1llHc7jZApP0XPUZGANKTES4dP38hnmnFjI48YGqG5ea4WC6AxFeYfBPk8zim7cxjl1rogxVlUcQN5uPxCbJ6J52ZEB8zBg+ChkcMgnyfC9QmIYQgCTCKNYQ1UpdgcTHMDmGph8aKRg3BzxvMfyCyhqzygGVoFdFhTKvqrYxIANOXIViS5nvf/RGnweAEersXtc5JvLSHKR79ZIniB2+z+XHmukLMGRO10hPzGlAqzZ1zqWv66ZZWIUCXe6otrF3ZGoI5UxAHIadwz4oaK5v5/prVMPtuIoMLfh8CUCyXA4xAmBWch0PjaN+PfmG0oZIajI++Vd6MpHJXjblNNkIylGeooTV7AMKo4dK+1jrrRPSPCtm5Wmn6Z9qZ/YAZeBZe2bKeWfa/LWvjf97S8O/vnXDz8dylPlC99YbAsDIitiHexK0pdqYSgQ3OA7URIYAyAdZjJKpRnlUgwci46BJMDYoSYYijwDhyFF5bNuIZ5zwcQF53XBXsAn0oV8sZI49ZM5tJcbKIO2gNuuBQavbQdviZbKwVvUwas0CPA2VRWLCB6V4PKzii6oTd6kRZmOTSmMOiB+mH1WpRqzh3u9jGlTeiGNuB3dA2v5lpJ2obAtlJmroO/NVyimjNIDMGNUrYOLlzpo5WaesaglnKiFMkxVLqucqlmxVPECD/Tvsaf7VQLervLIJjKfOYKptkTM0Tz1aGk4YMqzgNIWqtNA9hCZLvGzeYebPwvIHBPIdJ9VLApkOhybANbdZ+EdVGgJ0dKRDi0p9HtXFsu9vIPaiAMcaz4yAPNB6TKO2zA9GFw0pA6+5NYV8/zV/BF+oCfzV/bWMRXdMRlCAWvjPJ2zJhS8AFdyS4x+fhs0MIAbcgzMoog2QjRU2Ve1UqWdmDXtIf5ENf2XVKM/4aGGykq7cqgYUMLtcAB3wSt7wyJx88sFr+LZ1ZLBcoKCX6zH2H/gr+IW7WDgCFm9/yV/zVy6yX5JJnLAgyvvw5w7LLZEeTHdABVyNiHVv02RPkuv14rpK45v2+NL4hRfmhPw0qyua+qgLQNPZ/4t/ETXD+PZYM0VPD1WaOHnBG+OTeGdyCDNZZ0WCYPHp7AcoOwfbpAegd0XpqDOmw6v8PG83UNTVXwYaedkgJTzLNvssD1v4gFRTl3WPm0kl272GH6q3UBz+/f7fIlY26ObLjG8mbe0DQ9KC76kOypZf9u4SkWcJ6SWyB1ayiD4ACF0oxrUgqHy7EvSIxRWtPS6PnN/WlrR4OwqWrD6KG3MsrapsoGCdX7VwUAe86fBtZhhyN4DLt9TqMoyZkalpaNRaSiGSQHMC8EGHFTLONyLMTkgwWO4WsJuil9IdWyyr+AHV+FfrYnId5WO++VUh7WGS/TBgFJU8+EMrU782MMP4M6FtecpaKWIPajZy/5RABMK1O+tsRqNDv2Z3BelRPf6eYimaxfwuQ6co+lQbNamCCo20Wl9HjIoeaM+FQie4p7FOsgQsn9GrVPRRe7f6yxPystHQ8x3g8Pj7UI40Gm7ueoQlhB3UvNVp1Zz/M+wDE2clLnP/sb3wmluPnWy242JFVVD2quCaXPcE6oM+DITF3GWlxonJf2aOjFXxWeIlNWZFypgGaiv3iC/H9seZDBSooAjHzJSokgYyexBEaiFkPAEm9cSai1okxo01h9IrApvfx7ZTVeEfFaYjiKxlTrdT843+cG+ijk9lKh++HCeqo8QD0nLvnyDcdGJBlmH2h6WWz1aqoqN/kplbB/wg1AIsoOfttCdARhrahJTRCiaPBhkQ8vN9dNATbfohdNEDbfEYjUE812KxhhRKJACi89ZYvO1rFD1yiGB2lnRHWVsxP6kO9GJUwBvk1OABHiB6vivlIsmU04BikS3uKFr0ERXQjQodA1yIspvcRhOpWtPCiAg6/IDu3B1rJkY2U8A7Pn563VnFpQLI3npD/mhEc1Z9n6wXCK/oxKBjgipfbuduGdbTQUwwUjEcmkmZrYnkGMozh7pYuL3N5awwAa6b85V7gkIT+7BxaPi5SjxedkvIEZElpFucW5f5i9vt9s/id9TjX5zGU3VaN3oqFdNIDFqt0Vwly1AgvQ+j/3nqlNgcLL7Lvn599/2xT/8gafv+/jH8O+Bi7PX3GC1ZrBlFyFcdn6whyRmN9XKYxBCWOgF9luKKBah4QhNMFPQnpH2AI6xeJgvwaSDm1n1WH9gDXmfrY4Bs6IOFkIktzjf+741axJSDdKUxySXuw5QuFFhWHusi/o8qqUfDQPs76ony5E9/zVrX0341DzGg/I6YvfkCeQ30pupzEkXhN7xbyD0suUEm7shsqF+V9gsdx8g7Bl+ixuBpAjOhbHxzj5tECWSr0RSXRJuQCf7U4SMp8VCQLm7MIYSSSVvegWc+KKIb5W/CIyPVQ3rUiyFZ6/GmAolQEGKshFm0Cqn82OBImwOW/IIdkmbcJTVReh0vwuJM+J2AbnKEDk1a6f6bQI79+77/H/a2Paaz/3exRRlNyhhEaG9Oq3MioZ2paumfHLfGnw8HBShCP15AwbdbCy4sCcXqn4vToahgdsFW4QFDs8jw1JHbn0AcaaZnugpNuBy0Tzu3xIwDhrBhOujguhGAVFUURRI3+DjKqglHMdqI7SIPLDLw4LL3oUBfWBRDL2Im9dgOvZo8m4KAORLKID3cm7APgndjdm/F0HBhj0IPVzz9/CHCcIC8XMrEKeQ8QwQ/k8b/8T3iSbhrmTxf7/RcPuU+3h0c72hnOPw5Zjz4sqFXXjT7r/4wf/1/U+HtuOZ/+/bTz+zdwWHvQ2+IPQI1V4GHqShr5rU6/CVYuOL7BeV9qkuTPZec6oSiKxM4iiAoAyEQmg995ilIUhQCEpueL4O7tbTBwAs6DLAjuFd7e+exVWeZTVsnBpI+pFG0y4Ms7pvurY61vWKR2XUlVUFu4GJVPyvCoYYp+Q0R2ctFbHKMtTFmCMcsvq9J+L9Cz+P8rPJz4/xM+XnnfU1MYvxQLgGf21tDn6etzozOG7nZ4efN/ssnOTngJ+z/DzEzzl+HvNgnyuf5+A9XNqCzAKstosol2OWNBOiljl4OJIqusgfspAB65xoz3oUu50igrgFpV1cuSDYqGMFO1rPeygjcLsElIiPmV7TiqZlG7LmrWa/jKd2i1azX8Fb5fuPyvdbFNRbpk4fIDzbjD3mUYjqb4+KrSzD8mjZVY/0TJPvjGgrqONGvVhx90h7IHWL7gPUriARUHGjfR5BKDqgjHtgaYOX7fdp08uDS20CvgVGzJNkx1x7PzKuSOJGfQ11IdgRIeecZoOo8wOaraY1Zx/U4iEg/VgdiFB3q0A2Ja4zJW5mIk5NJjh7DGJScYV7GKvZruGw2DaE4D1TMOUr6PK9Qc5gAxHOtyP+/jAnTHru0HXYtm6Ya9K5lk+0TX1kDIeU77vh7t980e7/ft/FlZuaRLSdtuLvst5GeWPOZvjWvQPiJlXyo4UDJ78ZcoRcM+V8uKfIzSWDVx+ysG6fx601kUcNOHqVuDebuFYl7sMmbsHFlaBMp8Q1K3EfMXGNKXFLU77tTolbnWyfzjyOj3QaaV7IxrFm1WXNAsLU3fr09CpNtudMqiA4TVNv9GwqTS+WfYhuF/9MZqn7KixqKkjxzIkQMzt6NIN0aUz6vz1RxR7XRNNm/OihUpd1QWtsibFn8o3TZPyIJRcKDhT2aP3H8NVU/ez6wyl4UMJzl3l2VcOMe4TVkwKgtopmdHYJL4hF4NuhTSsO/zdkR6iQGPhKxm/hZ/aWQwbaDrz/GvlpdfkfUZZg5r0kK8/XTTEYeKqZnhuD4L5s8wSUqsFYg6nHiALE4wRkO2tPfB9zkJcYaMfiE5siZak9HGLcohow0SZffqtghir5U2iEj1AqivHAOu8pUwdeC4QAQNeSRRCvWoh7NNdu8uyx+4Mfug5fIaNs2Py9VQUNFXPhBpl8vlM+91fBwokIq2ga89vqaRwkqGxxkUpvtZst7XTCD0Uw7a+4UMapIzi97NNgztRMZiwNIC4+mCwXsNBzsDjVcrs6Qb5d3dzH/BehZsR1neyAQfIyig6g3Uq3AUCqr3E1Ys5UD2jqAoA8kNHP28BgcFOetFEcykuT0SeEFmR5APwoFIdsLQqoDuhrP29FP/MW6roEJ9F1GLeiNpPSuh7MoceypY9EC0f6obI+W1GiJX1ZxrGBXI3qIKEu+0ECZh9fZUcBTPVPrcOrJIgzOX4wHQZeoyoumpjaAWSJq+DLKdBZHsgs7+vlnpqiOydaH+jqfjbuqywgQMJqAblHXUUX6lRNeEqYkl9VT3noKY+v931MxvKmFtri2MBuIQIrrBayJMfKgh8smEaPMhCshj1TkSD0aa/DlRCfms4aDMXYN6FrUjasknmKShHKafXFE9QalsLaJb01qjsz8tWOWpBLIVpCK+dXVfAdovyxToDQmu2NEsW+fykENtp2Q2wpUOfgFRs3QfrpmA1tNK9TUnfMq5xpVbcJOJv70U+den96ziyfzRWsfHu3TDVINyvXJOFmqpa9X3CyqYTxcnJXiTb4MCWm5mBQsHHNezzdqQyLeNRGB5hubC+4iiFJiUApU2ooPAN/jC3c0BSUciNesfBz3/znP3Az88VNIxnT5awpty031nNB/X06VfbkbTzOymfwoLyj0r0Mj4V8tj96HsjWhOaDvS4ixBEUzUGsuLBWLIrvNFWTug7jPY8RFSuDGS0wAz3yoQxQB4f1/Nma0gowVQAEzZB7GdxB7cortUbSBuRvrA/4Jbqq7dGiihlhnhX7M4w7RHz8U1LyEPZl5hkSOU6vwgEP7xzwbo48o2JlaBwURsYk36MgvNlTGB7yFIjXKhCvViA+T4F41TgQm487EOPHA4zDRwrHb6/AsQk4NkfhqA5lgeOCmD/XDFu8K4wdC3C0Vu4KHUsDmfF0cRGWkaohkDJ87t71tz4UFELV4w25Ph1CRrEHcwfrP5hBSP12c/k+h89aU2F69ufYzBd1VIlYcapnVFIQQ2syGTRGNpcLGtMP1kxkU9iAPBVmLG9Zx7bqXlS88ThP1RhGRh2cgM+Aro1ov/FAzoCVG7p7iDNYrWZG7zm6awUqhsc+Vpm2Fn8fH6Cw1AgYS4c5Y39tNIsei5ucHdearF9TrHU+NKjD+VqiEoOJMKcixA3VjOkneV3164Rsq+U2j3weIwGEYtpwkH1AKJenXk5n1siTu+7YZNdtd2MZRlWf7QCRpFbq0Bz4CSBbpy2qCB24EENb4KKIJ2CHGyMFw3AnHoucaUktu1UATQtcyRLX15H2AtXr1L7amoqekYbmnm1OnVI0rjwoID75Rl5b4l4nsljq8fCRv67W3nxgxRI6s0QdTBoASgatixhOLxZsnxYFYnCJJLyWhXj/lWr3HFpXEOzVrW5HXU5uZhgO5JdDMcyh6vRyNNqvyEa6KnDwlFFQm9ZgYJZpXrqqmJbhDLTNEZVvq4LgocldeKrgJE2ZEWhR15UEgpBgjFJuRces56M3cpddsIsuXtaWIfQgmlmCNuMB4Y/rlWyCYn5eLUTOPv2yhTaF+9eT/vLqakWZlG6sS7NpWc2KqUIVK/H0BgyyLnkDAElZQzNudWkCJqqSu0XKaPmIljKLtFkupzvIRQ7xrHwGgwCZ0YyaEZcdbqIT7bDb3y6AgpQxYCEJVKaMYYrotku/nkYtkaQF/Pd1QzH/4rFSzG9QzIUqxdTslmAujBPMwtt39jetfu4vzlu5WGzFeGXfjn5oOKx0cxFVeNnf6Y038mHIK180+l/CUKMGf3jSBXquQNHUkgI5ylLuRfKFvg95VvDv14SOLwMWOv+3TNLxZa5kS4WOdx8pHd+yCR3fMknHt6AzWybo+Bal48u2T93Hh44vTqPjC5vQ8cXHjY4vPCI6vuiCC+N0fAvN0vIEHV+YpOOLj4qOL07S8UVaAB1fOAEd71JGi+N0fOFrSsff9Hhef4NeB4e97M/eaC+7QRKXe+UtuHvLhNyTbfLYLbjf9L1wmr4LQYi/ZvVdVASi+6B3eHp5WQxL3+XJHYdsIIVphkE1w9tHMqhZEt8aJunf7EGaoAeSATSi9GpR6L7gr2ExvH85BkyadV9trFkSe894bH/3aFUL1Zq6m1Zka1mYVkkyEenkBV9P1+IXa31IAuTYDtICBNbTZ3IZWGPMtS+5ss6v+oTeqAT0QnrqriqRZxS1fl0SXuQFk4Krio6TyIz6Ly3Pk0O1gVA5ewecw/53mQEN2EtfEeDFoadTq3pDI4mu82WX6Mmf2y0ulfqX2iF5iKzrmeK9CZ4WEiGoeIvsmypQbizpOitqtKqUAr1FZ+6q5YhSW5Y+9iEACkyBUSDMQQZ34aCwLjdfZvn5MX7OTS/DLOyeeErn6tueUiOouFWvkpBRY8nnJT5fsK1MtJVOJmd8QhUgdXzqxlozC6k6i0mMRE5ryhPbZQg+SVkslSdAqSbJfkPGFbq82CMdDTAn7hCcnqdF8CAz2d3SpIYW9P4lVzA1UPDUEpHp/ZJJP7JZ3l+ttE5zSNNoq8RHs5W4N5u4zMWpOk6pxA0waouy39RDHYnKfkvIQEvUvOqaK1mbqC0BOvKPW81Ed75y/QCrCFB7Cf4k5wX48+LOHo/QjAgltCDjMbQ6WG4Y5hn5oSGtby1qqcY1hs3ou/NezSAx9qiVJZILRpa8qx0kX3abxRZ19KXlLA6Lley37YkvcZpxD9ejRf6vy8WbayhLANeKuP2yXw9ZA73o7vte+ffZi4cPBf1oLfsYSoPEuIsvuhW2Y6Wvd1jm5epYj7rKASaGP11E8RDua8TQNHtR2zfEiqz6aZAUASioQ8VDkWu5BQy11tFyu202VKJNywN4rgCqN426sYGezE4Z8FB1d9rr03T0JmbG9CmBmb1k6XsrfbbnTad8+NKHMZVAaV1Vr1Sn0xEhZlXC9lZPrHg845//8FP/fMMXfvrWo0YLQkxTuC2PCWzZS6UZf6CWM9GXfeKG8u4ortwF2V+9wRzQ+dYO7MXrDwVgJlPQXe9lrDUbUA2tBWkvM1FgrpzV0t+uxx3ea4Ly+q/w7V3be72y1+aQc5NtZoL16GAAvTvsnK4g0ZLD9dH+K9AE4WvJB6diNL2j7PPKp+DIKgOcdHrCClqEe9AxhXCLKcX0CTych8+hWw/n0Q1Aml+berIUqs3FPNX7xxxqaZP4xDTEnqKmbchnXIkd5LgxgJB2g4l5LNdVsE3TzUkscxG51Y3Vp7m2xb6XL9GCXrf9pRKQQwd3mh0Uy7R8e7HMk4y6A2ch/r0Pz8smhlsiS2WCnbU02qMmt/jhWliTyYbCt9DKw58VZ7gS//B9Xr4iamoFRkVvT/I3nCsNRaH7mtzrh7mce5CH5EVaZhx4JeMnZhPSyQfPpEIxqnOf5vKa5NVO4mPsqXWYcKkt0Luucss1wG09CTFA7a1CZ7cxA8P5PJo5gOd3rQkIA1NeR5V7H274uovT/gXSNb/G3cxX7JxaEUSodjq1MaarNdCAmq02oLbsMQJrRjKRaJ8/z+T3Cim+n6HS0dK1m/qCRkhto8XrldmeGTNPX1cBIdOYVfJxMfIa7t5L5D7tKvUQxYhWje2hddcoPPp+zsBU1zsLAFPBxbwPKDOknj6BQPYmIc2rmE5f9D6QLjJG1K4vKXpT3py96Wuy4fgbt+HoVvcbnzvBfuNH6pm9TJMYhs43794rODSV3CjrtO/bRB3vnnKCJXsHKikJsGzFTFoqtq/zSNtkpnesOgp5XekkzvCEIMCzIxxuGIJQ+QJgAUFoU7iB69obeQe3xNziXL0jV9KGeUMbFiggm+EYTIbPrBeRapHmixQZY/wRKIge1VepRmeAg/fb2fghUGCManQVA0WdrK5UYwUUMKEVpRo9M6u61APVaFQmUG+MaszzN9QT7N0CpGwYqrGFGkheoGiUatQM1VgQqhFzbxdx9DVKNRol1WisFStKNVZBK1ZANVYrVEM9ltrp21aqkVapxoqWh5s8JdXolv1bqVCNnr3K2xunGj1HNXpTqMYKNYVqrJgT/ulUo2eoRu9EVKM3jWqsmjFr6OtWQMg0Zus41dhKq1Ooxipad43CQ6jGCho5W5HQzdIcbX2f6EjSqj7Zpv6cuYRIoZIJxsM8GiEQFKW/uqkQgKmDXnS9/UcqpvVuxgvrUuGh914Ro0b3NCeux0qy7pZ/9gartIOxRVNUTalVgOI4pZgHLob2J3pP0Fd6Bz6TfLka9UIilzeZTrbsVvbOMlKNMvn6OTLkYckZOpa2DA0MgzWS6m7Ol+agIDIMVO2jashvm7HPpftpkD7d/2a/I8zk3yVN4+eyJHjhdUF5beL8ym1CyCZuP5+fEZsoOb+6uw0nd7ccP7K/1T1waEWKIeKED6j3Dy9DF/QQcVTl+Fkvf1V0bas2v3UvmoLUQNUAxp9NMpuM7fvZ7yJdi6ZwDRvMy+XObQUvm0Yxvn+QgIJKy2XjpNcXMN1cc1p6r7hdiQl0B0xtuTLMoskRSXsTvDundQ8UmdGJClUnavSWSRNbKRl62yR3vaRDzWE+63Zgc3obU5i/Yp4XWfUxPYNHh+XkcsWtXISG1FmXO3ilahdj8W4DsDruJdShQJcdUxXsPOL328/nJQgEIXDXQSmDCl3rADdMmk8hOrOoNzYW5bxjsdIfF+yIy1hxRViJpDrUqJZkTPJlW0TBBHsUKJ2iC3ajKbeMO7ptaiKmyzFHFFgvHzUJ1/fQCZR8yW20KIr6uH0o9/6IHx0o7fODMFh8P1hfUYOkV+GUyDGB2cNjZVYwWbjRmqRnv4dIPQqZEzQIUftuCi0zJO978J7we6LUEkh/i0BaDp9AAGOax8f4TlpncHfBvNes75ODe4dFk8/E1CNfJCNPkXHJ2zkCVNo4oiqzNct86f5UxjJP8AjzBji72UHesvdKG5Ts73dfZO+Upnot6XLFFt3zSPSeSuyby1iqxL5bY5l0GBrk5PqtI7em7wwC2ISeelboMXCLCOQp+5zKMdle0lIe43kIZ+FyO28VRAaXIkJQ+LPckSBO+kC2OSSXV5LyfDArQyTkLwaW4EZXqZtcskQyBe3NFbhixDWcBI/dRWOEJPguCM9ElTcXVFFvItdbmqB9IggLqAlkUd+aop6p4oVAfnQwsy8KxxoDJQjJSVGHyxvyEdMlvDCgTHE6wgmuujj5TgUi7qoLioRGv7MuXdTX9UqTTwiNHAyk7/TZW03V8TE8ulDwAXhjASM9Yq0pGX1XNy7WaV+o+rJB6UEGBUGHrfrZg+Yzk6APLSa81X05paTpLXFFnritejMyVGZ4WDhyBE3056uHPslwRDMEI8p2yFBL3wjl6Niunpm7OoRba6UDxKECM8arDmsiGrScEFKdjyob1GBowWgBHnL5CRqT2RA1yx3+PBFswUTmfNq2hlgScrKcrGav3WR/IGv9PwSxW+dD28oHzvoaXI10tt2Ddc7lAes4l6dXJqfekMyjiduTbqmvSzOkSXLtDhK5QXmNcZg3sDTq5V+oJ06RMJVxevsSDAZNRKZkv72UHfyg1Q2Kh1iFeHatDwbmvuTnL0ait+/J8u9zLH/0WrK/tSZrPo8LSJ8/y1JOxO+pRr+5jKZqtNJOvRU6caFT74Rq5PiNUI203/OQuruwt3seD7mKLgI9ws8jZyTWXMTqZxRln1R7bzUTtUcya6xuW6uZPzUts8aCkw+rhq3GWFXV0ZPbBNeK/Sxpjt6VNlekK5RW66686UArmZRb4eTLZBhmf2ikuUi+t1Zqxlc1XtE29Q66nh6YcFAQ2HaEeCivBlzXynKgeygVKvrXh9k9utxhSYFAG/MAVTsmLkBl2TqPg4+6ShX0DD9ieMHYYHwxoDLqQ0xdi66P0KLKtSbmA2oo/9IeP30c8fsH1D6vHI7V7En9EeIyvMqltYrBkeyfsM6kP+Za1yp8bZ//+DXuUbfrTZ4PSUwpaoAJvRIJPcVNql05Qpz4iDVUK7SDyrijbr/81C8/LSIhS5w9Uip2nd5Pn/genin/LAqg6VSa0jy2VNLO0h5iHpQWEfMQmI1XsSeJwJ0IjBDTyAVjrHMUjCTHltYCxxjLmIrGltYqZ9d/YZ6onWpjiHmStDYwZ8Dk9R/4V+NiLfuTismMBBdoIz0fanJpTS7X9SJxfYNlpIZSp+rpqcTucZFvLiNJIiNqUgLCTd6BDdxjGQzzumRVmqV+CrVDrut1jpaOgWykcqXTHV6qfgmKMN0O3d1FBwwVBRq7m/b2daMUIn5siQMfs4duar0Fej46aFKCWrp8SIJNaxEnsRZx7JFa01jE6fv5DLrSphn159maAFQ6BiUdS4x6AAsaDcOZfdlteKndc9fCQbSFjwf7qEetkVmMsQWUBukRKE7H17P/jQ/h6KsJzMbApsL0q0EhQPVYeZhUZ1vMevl54gqIXmTv15QzNwfwgOsSaDb48yLEAE7lqWvZP6v8VVSD1PJgUL3V4CjLf9k7HKSvDgLcMSunGY3dy01IzIlPvzMW8R2xTBUOCXoFHNy5BunQorrNQvrRRRM4ZgP32sADHOhf7z/V21h0MoG6kQno5fUFyDVlSWtaj8xqsLNVPTIXDg6x2B72289tB5gE2b16a4da2Z8rBVI+y9SAD/BswUQPLsSQbtjqqVMZgoNmTk7cPZ+wT9MM3ceycPVbauVetIH6f/RGnv+It1buY4nP/sK8xNae/U/7oao3ePBVBtnXLkDx7iag6CAkK4YuEoG70lIj+GlZpABKLpFOFmwecKkn/j6K+eSMN8LPvOZCzgRNMTCIfKs+Ud4aUmNlw7GZwUWjS+CQNAUBu404xNweKvjlRTEcgb0A1+wpvWjcum/pP//V234++P2LrgTYGKsv5JwYXWzTGYByZ0QNLBXJEIUOK6x8L/tLxXC1uxQC3GG1lw7stew+4av/3vOia+X+y2Lu43l0Ua6LMXaB28neDPDnkWEX/9Vpujmhnq6ZZcJ4oFb295qegtblJe8IOGy4/vQBcMxB0a0s/H233Yp/v3lxqTN5wd7BkKJyZg4prqqhDu9QZfhwWIjRHikKTnoH1e+H6XezoXs9a7XXS+1E8RWNgQqyo4R1HoZX1VS8786mnakesAZqWeffypr/4NDx7bD/21il/6kbjt+KLXr57pN4YUge/l3jzMhLv+hH9esCY/5Nre/Ds0DtkraaWuEZdsw7wGXdXzuAswCevrLkemJQCA8sg+Ku0ZAxlJGyQdVfcgiRffGgua0oVGdD36HlQNPyzVDM8UVnMiWDXqk2rnUboTxgMq+SQ8pYlWUGeslUV71k8iWjWCSdE42ODs1mX36jtATQNuE2zcupI5YdVyC1+I67qcO/pjfUA8r+4Dq9SCUdMbfr5vpHXwU1ylnEzZbaSf27OJbXT9xraoDevpSiZyMp/YOo6RujERH/xRwOrw11KmApmbIcyWIzOuEL70juK9UPMDoYnN28L+qP8oKQ6D8rr0+1WdkYkZWqTMtO0aNsFqSqvNoyRulapdKGzbmHHYrNKKGFAVclvmB+jMatK2PGBTMX7LjgLDA6pQ7Lq/kxM6zeJGOVGhilyHk5yJem37BwwS0uuCJM/FLR25+v0mK+lRbybVMrz5zGtTSftoHVWaJVTL2twJBtG0NoQ88ystFWqNsgFvq0s9xkmoGAeSnfRkuikyC4sijn2NzuHtBgiVFtDqfe+TJt4VCXQ11+zg9xKNphzFrhty18Kj6TI32F0XqQr1APBS7fWppZAni69rXGDlEzTPpZWO6kWaa1zQuUI8lg/ZgyjmnwxU3EzFAnexOmkiurmBGzljOcK7kALE2rxDMn2VUrvRS7pPJmcV8R/otR2BSUdsaylspb/ZvuX5S9dsdJFGWfdZw86DseOBmqP7NIQAKNIjmS8R7ad7UZBnyjyOVxVuUbuvuw/DfF5YYglg0B7D7yuzUIX+4CgPaaWVNiptZjOwEQLHwMm1pLHLh9qdTvkX1Ap7oPqLt9QGL3AXW7D+BQIqbU3T4AUkvZCXQuNSx7BEYHGj1tD85tZ07M6YO0cVxex/f41nSWZsD5a2/Xyc/+Ct+Qmk1CZFJk7j65to1xH8kcP2vjdatgL0R0MGk61f2Bl2JRQHF5VqnPAfF+AeKcnrkAa+eGowUnYwXH2A8l6IKz55xKjJNpNbAfahiZ9nEGoAJ+vwS/fGTxzsCvrjxGzHhtl9W3hBFw3hcG1yp2LFUtp35iCW6O/hotQk8owmZRz0DvxjMRg0XHlsiHpkZDBHx5U89AoNEPbQtLenHQxsW1oSqAQ5gZK3xr4GemzwFFel0UOipyzbiP0zCk7z2rl89KqV1ISzsA/SxK/2az25+z5Xt5SDOQq8oqGqp2ZwePRT0uBCrNQU13nQI9NFWLlwsUIZAgc8KanBRZnIkA6CV8MqQljSzlehEQKaJ5jPe8rqU63qjHHSKZGHeA1JQYJ8DsAAM6lOlgGjoW4E0PU7DjTZyJDYqlefYYTMlk1Y4CiouMkQwMHbg1AC/7G20AD71FjFf7gZLCkevLKi4to16A48bKdZDvhYngyXNqCJR8Qw93qfZha0S+EaqVFTuPkJe86vHXNHYCG1Qv+7xmgAGyEWNUcquq6nK7iNdzv1qlh92Dmn1/cJE4NXSnLWoy7e7Qiyv990fFo+r1u9yXfG/lIhw2PQ5IFbV1fDQs3yqKQ1LaehEcocAlD4vQwTCsbI/ugJgk+yPdzBIs4OkLigmHR/JAplB1Q8OtQ1R1r3TrC2RmTJc6AnoOdkMZks16QR7OGqIjpg/+EfJPrg+As7ZctujkaxjimqHtil91Dqu9Ik+7o2HtB0LV9oaKQtKyUNo7oNC0EE31KBpUzTdQPNK0GLtk27Q6hZhZ+qYnU2hdzK0LIR3FFvMIhYMKJMmrot56+hwoE2/qG+Nf3ljdEyrRlkTf2ZZ1+8JHeJEFe9Rr8b3YpMQN7vsX8dRt+rAIdJ8OjKIQBjIogAGAMs8xziMWTyUVwL9AZETZP4hc+u2QUIUVU5NOPUnv1lVZfq6aUbwInTT5juyHVSagDtmqO/ACkOW/K3uaB6ePDsbZw6jeXsX0x+xwoCZMcZWReSiGh901xQW1dHWUTOgkcrp2UFDJqfILNcpJEXyod/GFyywkp4zIjg7XB7eiPL+SZbI8H9YHtbxMFHVhlQY/T2BpFHKYq/o1TYSpnDMNM4MnAKDQMB6ErD8Kz5n7e9D3A8fWZuX63k/yRDBuDqwZTDrmDcRxbWBd+F2t215Del9CxD2WFf68cqUAOO4YyLqCUEiRCSVgA70U/i7faohVREn2d5aZwIRoqfdMjr7FLEKttdKV5ogaEabVAa2vhiZCiiheBHIOQGExka1q0UAjywYCbFVv/e/N/h5F2wsJEYXwHSD3NBNVZnSfQjDAi/ED+KAaGyP2C6ryQh4qDlQ5sdw5Z6XegOd5r1B5hqwrZopCdCEAB4xFhMKfEM5ogfZsHAmXBLLb8IstMvP3KnkLRpMCpSaXT5X/hqzqDwtgeL7QPF+uVOiQR6pxpxZpAwk9m1gLLvDmJj3pou5nqw2VS0CpDSEDiwfKeICbrZLULypoJX8/EcE/gFvvI8CimGR/3pCuyrXy+4VDTEruEMVrLWeJoaQZralFKWqhWFyshVwVzgz+QcDfVgc3+KTIiIufRfiF+Ry1eLstF3SwYwTbk13KZcw+9xq95wtEhPXo2Hg18EVwuiA3v3GPXKw8eFQXpwqcrbf/wFppP2uRGtJYTuBiLu2tEVuSjPlcLxBfUDc7o/sok3yzz1TkUBMs9jZsYri5BYiB9aL65Q7SNWpmX5LZsihRXEmxoGjbpvgA6sQVMOXrWzwC5XZXhyB4mTXtUgMfnv2jHrQ49Lwr9pavm9TSqIn9d+hXe6KH7UEnCrZzpR8UYiSyf0JhzojYAWUQNT958NtRxGpRjx/gUIWnC2GB4EcgYAHkYXbKRMKL/T9fX2JbqDDw1LxWTbEN5FawLShRLShbkBRieCd7ECmF8sXKJXsikKf6frXjCfvuaruNIpViNjHxwv9JITfifxY4tE9hfxnqlJf0ULuH0fRkHPOoQmaquK6I3TKI3QYCW6QOFalNZ2DnzCypitCBQ2hpdkebnaGhuI9D/HcZ73XUkdOcrvzz3OZ8QTrOIT2wXoSERibAsnRM7+JDlghpDeT3SxAFhQwKmC/4n7Swxr/cPMb1NffuUYew68LI0AKFAouQ5i/pURfU0ohMOcmTJK+a1CQY/pplMC0bfV5VJOXEIoXPK8wOMT3RJH138IXG1Zh322WkLJsb/TpdZJI4BKlRSycJ1DnKaZLqrneGPJ0mEaU6TXTijc+PGEOg0yOgBGMUlNeIUw47gh6HHfaX5PGfonoe6OCGiqLSACkdiKpugzSDbV0RG3SB1Kauhp6xgmDKALKKPyqKli++Sy3wtHIcnEVKCwVxsn/RSaD0r4UeB1DQwUAU8VoONOPHjNg30OsRpWO9DhiJAMPQRkg8Xc0gFIGCkccpRYjICKFZRP6IXC0iySoRpBkQfHPFuR6pdzqMJcSp8pyhtjzbVt+9Za8U13XwlCxLT0TkHamisXGchiUg+1cVlEg5sblDpF2PdBj1SNAC2Qyu9e3pwed7XZdRb42nAev6H7wYsDzw7h/FpFLbwR5/B+7CDVas3LjMK0E9Sgztdac289oJramJNLmzhj39/jzTydmmpgwvxgJy/pZU0qL6S4qYmsCImBqYnvymCxkoGNZPAAJLSSB7/PYB7vYsi76e2/agLKC+4OJ+xC7fQE5TyriDB2Q+GXOPc7oujTsp1DFTcOoMHFUijinQu2rgNLyqkzMMYs6DCIC3zKxMEJdYCZTyisYXxCun+YLwJ3xB+JO+ILjZVV8QaDF4veP7gvDVF4R+bXxBOE9FXMC1031B+M4XxKtvqvqCCKf4gvDGfUEElFiXHtkf3VD1BYEGha5BE10J0aDQNci50vg/FXzveeNjAt/w9Y8RfL/zOgHfT60mZ1znv4KJtfmbKd1DeVWVji/V1pSQBDLpdTNcIbGygClb9tI81hW27rQiEjwS4f6pLpYHEZFBVUdZAvEzimBbY2ZcTEdjMhczyzNvjv9QVkCxiCzn8yYFOLcTe2lKKQ3HGPX9lxWLkGIu9oMDvP4vgjFY7sNeV4rFX84PsXi0zXq8hWp88Qt3teSGUyAXv9wr2hBYP/NVF4dc6ZzcN6e5Azmv9xiXGsKruIuwhtBWDi1LaBuHFiW0HfenXoIQcciXUI7mS6jg5u2QzdwOIuGi853ykuvLKfJS6Mup8rKqL6fRPL9s1Zdd8rJNX06Xl+36coa89PTlTFBRcz/tdL2cBx1FXFLLz6IzFTB4OZt24eUceXkCnYGX3fLyRDoNL08iZKTiyRTK81y+XFY8hXbLy3l0jjzPR+Qe/uGtF9GT6Gw6CzEX0BPpCQhcqEk1OpXQDHoynfvwZzwuk9MRkExPlFtul3MNn/VQAhLOovPpPA5Mbvvwxdn4OU8+y4rz+TPbgpDOIxTD5SMaBaD2U7T2p9AelK31XaH1XUAXIu4pEscdqxSGD0xhiLaF7URhNe6K9kA+vLp4IjKeRWdr4xG3m5vpCqtxouR5Audxhcn6E5pbj4FeEdmBRWcHzSkDsQX3W7dQF5GMcRzZ8lVGIbuqV67N+F7NT8tp4h93msxwJZ3/ANPkG9PkG9MkSDErghfn2/G4tO3RdkwJ4iK2UZqfYaZExgXOmilxxiOfEll1SmwDKp9J23gG6pRgXCQS9N/Coe0S6gHhJLQK9NcJw005XdD/dIvXT8KLxeud8rLDzoV5ftli5wJeenYu4OVMMxcqSL5rAslPrSL5aRUkVzTYrfjMWIBo4PdKBb/tcO2mszBSgmcaZwY+NMh6viQDQf/w3d99cfUPww68eCI9RbD34upfsYcTBQmlOkWa88jGnjWJ72bOWKxR3H+ywf1zR9D1fHoyCgTWOgx7kqKrnXCK+1PQlR4tup4OzDzdousZ/QwkaRsiGS8MVVd9ri16CfRMSkERLWrtYDQMeXTwBPU5E2hzGjElM9R3F0dtEWQ6vaSqZ3A5pwpanUpnKFbslpddFsfm+eV0i2N4Oc3gWAV5dk4gzykV5FHQnTNJBxVE5yi1U8DsVig/oaRfSjd07EYhy9FnnRxkTwUQT7WQ3QEp4Q46E5EMEI1M4Wn3xQX/MLjYhrRKclJaAJDmhAw08wD8dnmtzrDEhsUNHPsa9l8oUIEq2jsegpJ9SSBAFO5E1PFpht4DxYXUOp/wz/t7dfHGMEP9qF8HrKFehIW8x9n4bRXroxLMXNH66vxceVL+FMXW3JD6/HydfPkeMW2yAxv8mg5vDcRjFY9TtdjT3KqIPLp8zslrgAVUMp3Bj2B00Tx1BCUoP0tJyIq8nK10VAgHY+yZdtEkRttT3KJZ4wUwxFPWv+KptFteLqJz5Pk0RD7dYI5bNC+2i+ZeiyqnK8HRJYrLZJqy6ZJoVtI9I2voRfS0kmRcOLIihnSh5tWF0tRoSdxT6en4Ttc9upj24u1CespoAZoKMucK2KXz4AJLbc4doTNPdgWAwmjqEzRaCziJBdGHiNtsAOfTv/K8+DryVHoYvEw3gz4OYoMDKsNTsZwmqOhRBeETgrhLnHRPnO7Gcv7hHLzVlHyF5ixBfI+pbCnk+7YQOzgxqIrbUeel7upyiG1uReJp9Ht8CmTaUmQVfXx87ts+qTzm5x6BH1QI/Sf8oCIurPhB7R6AgUAR+F/Nb2sn8Ir6s5/8mU/WSq+oL614Rf0ZpHAkP85wTlFvvMk5RT3ZKp2LVC4ve42CNHstnhOOTCFzzV6HpDFfpocQV0vf63s+hC9BRfgSOuGLRIdwDxtxnIIqkvFALToMyJGH2ng0238W0kWYp8LUimwlwINj+YGcVkYailRDblew3CKwFQSmAvR4QnIVbCJ6EWe0coJNgXNGO0VypQCX5labulkbg6rg6gQaD9e/bkzjwX88NR7+3PfqJ4vjOnBFfDxvv/HJe/s9ka9fFFQvDTgWCUU86pVKYhlaHDhKJVX/vhh49e+rB9ej4x+jKerRV0cbYirIyTAPAMryEeoD8I3lBlb28de5mREfz8WvE6x9j55UcloDYnAYSt57jVCaA3itX4Ovc19XQ9A3oEpQHvbQmvipHUEoNfxUsGhOFdT+Gyae2Lb5/Jsrtm28C837guoUZA8KJAXVcNvprof0ZgDDkB/3I6u1yufJQbuAolr8l0aLx/vmxX9spPgHTqL4h0aLx/vmxd8/UvyDmxa/tWYvN/GMPyh3ShAyV5ZWdZZ9ylyW+MQnrz+EIvS+xFaYmQ314+w3D459eqnnT1oagoex39KGZW9CZXKJtCbYowaEfhCxo+Z2v9XzDARuMraJsPDB/Qpe+XZWS0FQVKmEdlyyKLj046/BZRioPCjuVa+h/NCrj38Nxa+ls46S9WsX1qI0XZDJ0MIwQXXlEMoQa5Sqo6b005fmidcuRn5e0eV3j/zW8LNLgueu7c9Nn/hTw6qk9RoIzO70P2/i/LxmnW6p+2MbUoZaXrI3olUavGncp/qPiiu7VykAfUNQtSBfhuZ0X3RN7BUikB6h6OZsTZcYgFOVN6X9EoEQx6U6KELpNL+H0dEHlg1EhyYK8EBs+l084qYGBTfwRGGDTMra2OHHou9rkeq7T4rU3mS36bDK/Wa981JBzxtH0fPgidHzoEPPG/9N0fPwCdDzp7HyTSCIPQF1rtH0sCgU9rLCJgBgcoNOXVkXAdayOkXEf+VaFpR+60M1tvBjaFQRCXZTrA0Hc2GQMUKtrupYljFggmFjYruM+bpq+fiipcuVFFo/T79VR+Ghlo6lC5VIDQoHPJCWvQUNWhHkUD9lXnUFuwWp/06gevPXG6h+5LiguhmpQvReAHZuujVZY/1RNzUy+cVVCDzlSW/RirTKUrTkxcdLIWyJTneeRE+VWsxxveHU9vevvWY/56p6+tSkVunaEyxih2/iXM9rVPZVXciKyvEjb32y67Uv0gid2Y+uU7d+nXdqh9A1ta/nC0udvRW5kCkzJZ9fNimEizCsFNpbjURTZ29ETrOWZ3+ijPXTPB8W6j1pNspXzkTprSBl9uO6tqyB1KJ4S2/JS79TCr9PuqmOZ+6V8OoawFHxRinu7vCzV4Jnid87fACnoLJEsirHmv1LE1kc7609ltVx4FbHI//hVsfhxOp4Ulj0DC+Yhg2Blq+ksUAD1nRYHUoEFiWUr0key8j9pBu5n/oPN3J3PrqRG2NYf0bSn7spw0rCma7uF7aVSg52l7CuOhk35VnpsYztO93Y/tx/uLH9+cdlbN8l6d82OrZuKyJDiIFVr6zPloG9CD+XlFSW/OnD+5in7nvc8P7if7jhfe+/M9H1HsvI/Yobuff9hxu59z+qkTsZ5umDmzNP50rvLxJWaH9pA3C3jDIJl+TmKzoCu5pmpLPHMtIfdiP9kf9wI/2rX9s5uiqj150+Rx/z4vkbbuTu/g83cr/56Eauic3Ob0vs2zyWDwg4Rf+Zt+84sUEBbsMGF+4hHl118R6SOEDPY1Vc7+uVVRWq44Ui5ywa3a8LhQ5TubGNuym61Frd9vJkRbBHHLJbo/i+2fUcraUf9SLotvo8np4zJuyQRS5B7pl2h7rw+Rb1LvIIz655Jn01awq3LKg3BCqgaR6/cVwRG5SIKcJDG9ffg2b1z1UYmbzOo1toQR30X47c16oGQcW+7uUnOWfux70kuB9we8nnrW0+g7qPZQb9nptBv/8fbgb9waObQZccdxztKCZ8Kk46kiFOYL82FPAP3fjd8x9u/P7oa8al/MnmXMr57pbMVftlnsoEleBuYWDWnERHxD5r+DODHT6Wwf7fbrD/7D/cYN/76Ab7KccbbMgZsymDrIN19DGJ2+5zg/WZ/3CD9dmvLVd5lkpKp6+Jj/kY8W/cyH3uP9zIff5rO3Lqez37GglKH3Aj94X/cCP3xUc3ck8/4Wq4yz/aUWZmM0p50H8so/ZPbtT++T/cqD346EbtqTxqTtNL1O0AUKNx58OsYeFn/6KFW4mmafzLpjkRRa7+sQlb34j96NTYXdMiVyci3VD2Tbf6ePVxtHdQ9ehI2w6dOfXRJeihINNiAxw/JumvPSuBweonXtd6RXBd/IqKFcNjfDwdaT1qKAumwNDbm32KMDg38RPaDTfqMxh4FHHKjT4XfNhH+HR+wpIOogceR2cueAs3omJHCRAWj0NFfZ/4A9z4J7bDaTLs3Lvv8/8Jsb93MUWlfxneFnPdeYLnIT9voG5vTcsHvLLXSteb2evwzLFdfrCGlPoa67UWLXXac0vwoqJ9AMq4hyTbjMDHl1v4GtOhSDyLU5C9HhEwxopvgSB1imEbPOofDvQSJoI+gqL/Pk9tcaq3GIipDvxd1it4ZC6VLX7KuI6fsGDbect9D+Zdl4GdS30OqL5gP6Gwl3fFEuLis4otxrDrvFyt8RQGMECRcVswadPsDQKckHsG1dBuxWSr1JUvybNWrGCy9ogfrXzV34sAjAro1nu1X+drbrSkXlCJm1NaDRo452nO3L+UmeVbYQdUy8qK7XgsFARAcWg1z+V66mpe8HMH5wxpa74TNyHybRTmO2k7WnTKyDXVAir8p+Ka6g7WGcxPo50cYE3+XXQq7/9OxyuHAFJcRuNXpp3BAWjV40LFzvxs2pafQ3n+BMhVpDNz8Bj4BBId+2ag1wlmEQdTNBrjnAnuNteQdqj29W46nZXtz8hZbZ6vC5yZn0vn5E/hkl+Vn0dP5O48iUH25Px8OjffQ0+R2pYhrHi4FtTyC+j8Mszq72X4qRSWYRbU0vkIFU+jZTxZU/8BKOeH8rKX9sizj8hn8M/DKYYCn9OFdAFiv4kuoqcisK9M5lspxTPLPF+ALv9e6iNwITLupYivNQx8LvWLHj2Nno6Up9FT6SIOTEp/8IlUcJF+FxRP5+9sZc/k6qWcvYRolCDRrg3fRPtQgX59l4+voeT/DERerJFBsbdaJKciE5e8d2qRuKKg3cLXR33ulnTkqYh8qkYGxUXVIrl3yMRfXuSKtLdJlvFYpvPxOJ/24LEH+AB8Pw9eQs7rx9CKpyfiLgDjw5Pk+SR6sjz51o08z6WnyJNvLWIC7qYdumKcTruAuGfgcQadjcfZdCYeZ9I5fE+I0fUJsGf8BDoL3/GVstHLqae4y6l2cvjfmBzfmBz/gScHrqQWuJL6LDwuxWIBRMdNQJ0Qp+N7hBO5j3U2pgI96wCK28l1InQWY/A383w4lefFaY9+TtD4nDiHsf9UhsNZDIMzuf+ncd/PNvPimXReXpsyN3YFjMyVuVGrzI3l6twwKH8RLZt5UavMCzugoeIBhlVQ2sTrjCvxG8gtOP0zz37e/T/w3s9dbJ/F0xgLiqcTTwwgvFpgtM/iGZwo+KVFAxMFYTX2oskpgmZwEqHUcpo91U4XxJbtoz49VaeLZtboXaY7T5dq7Ux5qlZ9oRSpkaNovYsuRGnjaK2oe1zs3oXHLnomsPuZBrvPE+w971Fi+Tl0OlAPl0cZ387CG67HnwEsPQ1vp9HZeDubkZ2A7N+Mz7+ZnmUvtBa40Ho2+COg9AienysYffYBrrVfA9YzDu7kIvL8ycFeg5j0ZEbbJH8qniCsnPFJQDvazSj5BO7WufkTgaDofM4UIQ8ZUZcZUc8HM1hBzOUKYoZTkNDhn5LgKuI9tSSnOnSW/lYxgKORynkvONkxwyjtMaO0C9DH0MnzmZOjBrA+yY7KU+h0GSpAfjc9AW98hRBv5/K4ZhhWc/31bP0gp4JOeXHBP/b6K3xb53QK7eAr6qAeDP2QtuPG03Yi/agHa5lPUK47VAqj1IRd+P4O7riWFGVOYw8idvraS8xu89Av8XXX82DSCezAGRjf8+gMQ+qeyOn8eBI/zgBNRNyTkQ50CdE1Zr3R7fOQDY3ebRaF/Gka8POnm/mUmyXIz82yGOR9Dfj5M+SmPXAmpN3olN5frq7waEhRXeafjIjqWv8UROxyCz4axXPOrPrfpAgmi3dxCe2Sl0sNCfwWRF5WrmHVVf/ZdtV/jk0+V5pmV9tvOpnlHBTNsQiX0reUtGsf9Su4KR2mfZpfl3tb6xO11kvoMnyrCzY9m56Dt3108ZRCLD2tFLLDNl0XcFn83Rr/tPFCQCd1AjnK6iYQ5kpo5spumRO77YX6M4z5eN0q1vDzTF3Szu/zTfP9TBpmduHGvJpdfBIn7FKDgW3cKj6fs/AUOn8/Qpf1MDHUAeATaZHadD5vwA/gOjTt0ktfLxH+gfg6Nj5gzfc9a4ygsn/Nl0F01JNrbfhe9TNPa4hAD8tINaKu5ClH969jQKETTBM8peNCDM5HB8+nZ1qzmke3wH7bApwhL9Ai5HTcQmsCDsbxYBqT/2BKkZ+4mPut5MOiYjZ9308dAGZJ4bNgpBSr5MO2I3zEj2z8F/cXNd34424i188B2fgD7tj2q6yBG0tdbN6fiUcr3wK5G0LFFokvnslkZX9f1pwtG/lzuaYn00K+R2rDwFFAq0zFbgkOCMSsL5Oj8C4a336EnjuUQBEfKepUr5gYf3ghvxBV7C2Uep6Pl6R4IoMXo47R0b4zxAO97S7TVie9v5eJLQRTdH7OeCFCiwuFmMsqgRkG/gYlj0oTdnEmkDsl61y2D7R/pqDqIk/g+KFgjbZcLUhyviKfacauEtk42jrUOp9CRHMRy5xEMe3hJsIK8NAY4PcUd0Ln4p+r1v4Cb4pdFmFAr4BNT0bsk60Y0KHICnVFrgK4l9KULSpNWTx5acoKZEQdFarM06IIVboqVOmWQpWuE6psMUIV2K+e/79ZqPKNfeM39o3fEKp8Y3J8Y3J8Q6jyDaHKN4Qq3xCqfEOoAm6ZOj0eGCNd6T4u0hXmuxkHFr8hXfmGdOXfXrqiYhXyaStPgGcxpi0ZAcsTjy9gOY+2jAtRarxGLtMuY4wzplpFZhKuIaIiSHGbUTzCaXIUyiblKEuyLYZju2+FHKUNcUqbtiLPVmu0P6IZaIboPj37KhRpFASZGmZKoTW0IK3JBqLfoslhJTmpJsMvfv9jtTVXqnU/CdcFe/WzJj7bN/HZ6sRXEp1VotWNQ6nU4uJvVPUTVpFRRZwT2K2a8N7cD45vt+oSfK367gfKC+6rB8SChHMYCmOH2RvRlE46EX8T4h+ZAazjmQ3wR80GBNZswGsfZ/sloDaYRGrg0VkwedMJ/Dz/SRzDGWWd/wL26mzvszRKR6zwThqvyWi8GWWpUb1BjN/b46K+v98Qv0Olx8ghnGuUbvoGeYNLuDMWz6lNitCnFA+4VNYEmGlHTCheGqK+9TZ6OEC1dYrMHC0CfukUmX31B86vWTGLQTxSiZjb99dp/lcPf/XvORwc4db/CFqvTkzBMQcDG2fbWgakh4e5b3geCoqIF7JAXBjV8cfG/ueV5iygnRRcENwZ81NbvCAuQNcKeIbU2urqQOzIrRcEdyEfpyTi5BIxG7FCgfutpvabyN8Rl2cd6eWVBS/QkeAoBwLj70Ht/BJq4bgFkIsFmldy0aCQEpqjuQH3kns/LMfj9XvXHwqKReSubxTB+oDfor7fZ+TnWc4di17GaRS9NPtY1dyh87RIwXoeYLC6YmRx3jkMW5IdyoL5gINIl4GkWW6LfMSjiZGjpcHQosuHBoWvnqCHg2IZkETGlmbMu/y1r+6hpYzucDgEFMXf9jKlnMeMq0Gm7Ga8OQewHmCJ5hYLlyq5rfgjXgKj8qy8Qwt53bqJ6jxTsmUM8Uy/HsF254M/1olxnn+njmDpV5YnDybXI6civ7eQGscJ10Y8HX1+zvN7aR/sAc85CBNSGU51QxaxOZWWktRVVMJD9lYe5rjvUSxadPF5soA9JO6d4o114Hn/6WtFsrHvz39g4ee++c999ujIn/DOtmhkD4v9sSZ/8AB/YN9Tfr+v8t6CtF0656Zg3i5pAjU22Ne6iuZj4x2HGlWX3p64yJmpfD8Y6sCLh8RilqW95dDJbGzTLE/7soTnc+Wzgkn8ZCTFCAUVZ6wdPDrkVcbfowxrdCbjGfbvYsxPsz9T5zgUKgBDAHqB3xbWMORwludlHzSKgrSmCcm+2b85+/pb33LN07IPISmfoxApjB0Dj0LoVWZH9RuKXZxijNaUaU2wUCNavHNwmz/Pj1VwBXNo/CI/zmVWQc8OLMDrtMw+xgNqjcM2UAHdcrsCNw/rghIWC12PPIYEoOVNQqsKH5CyVvZh6cYcW4XJYzz25B1OutlDmoKui+harh0K7vKoSxn85exnd1KtFxUrawrq7CMoCdb4sz/Hd/JV0cMsXNWTgK2+eE2CvB5sGlq0jRaQsp2W8IDl9Jy2lrb6ibedrQNrSNqJ9Zw3Jvd6JnDMBo7awF2ewGe1n/ASOjmP8lNgqxrw2kn5Wp71YQCqyE8DRctPNU6dFGlikIkObzjgiTqWTQKdZgKWveW0GFuk2B6SZML3ZXSaPE+jU8WXJK0+B4kh9jOePI7iewkd08e9iMDxzymcj07hogcemjM6lxTF0DZxOO9ZX5XWPPyptArASt86dCpO5WL5rKOfUKHPIb7dZr62zPeqkrHttMOsxeu5p0WdhpbQqhB+lFBklKE0TwCC8o5Uscw56M4Rk1OBR2FNB69IhSczlLSVVsAc7lyTsTntxENb8NDKmJ6aZzKmxYnGtDiFTjnhcBaPZRinD+FpdghPQ9mnlUNY0KqdG1Sg8/F+nbWncoPNaMbKNwUYRgf1l1uoh+Sx39fbKKBTOWPFJW/BpPOQh3RNw7hhLi+YyXuHTNl5fjvEbzqBMWlpJ3qPWnHqfMiT0V6ibvarhnecw6Ylx2OhWEHzQUpoy5p+m+/A+ypCpAQhBkEA/ikB2M69ypXSnQxWxGQQohCE2HY8hFi1CLEjz+hUM9FXH/+JvqoYsu1xxJDCYIhiX1FiyCptA4i30yrQowPPaDuoswakx6NTogh17FRXwm9RJQOqCP0H9HTWk853BhN3Qso4VTBEi9IJDmrGgJ86z1trRe5mdvc8H/0HeMst6LJwTHCG669hb6HA52sB2UdlzTAxuiSl2a/pyqqR46sr9uwZ+S/oe9+HYNcA8MGLEfOSPp9C+7QMarNMCYvqYVzYvWoTUY1tpVvIsRhPj961NtYnjV6dHp1NK6Q1JWs6Ja45GcdsorMJ+/YwgB/iYJrL0VHfuP20DydZM2wyucHPxmU97MjVBh/shsPdAOGHHZH+PlqZ/QF+89DatePSdqHQjX0//Mwfuie/PtlrXZbffzHz7LtxrYtqDJyKX+jsE1JGrNzqJcLVqs7KBQELciChKFGBe6isZp0CFRcEYJjQkUi3/BkF2SdR4AXB88xJW6D3nwJ1GpaQD/49+5TSIjF7VyR47NVbSyZDLnFJ3gDGPC+PtUnkM3bfSg1cDnsZ3HBumH5oTzU0sMHBRbyfidESH3PAp6RqZEIrv1wMUnDFYu9Cp3RE3obVMdk7pJAzbKxnf6hwkvzcYn+tBCHF65hvphKtQstO3F4loKD0sKloElQtB59fc2gQrsldL97E9g/6fI8fFa9wfFbG27gTyW5g2PyR2Bx/0PMhiTCYeu+cRVW15KHmtfr3QMeHKzuo/x68+PzAVupIY1Qq4ajHb4wgzLPPMcmoQM4jH7vxyobDBHftXVfm2O1lXKY7hjoaAvaospuIQCgguLxX6X6Q/THyacV9D3Mp+xMBHadx/xz8/2KmHV3n4RrZtXjWZdMHL3qNV8SlhRG/dCIO6IpDcobGWvbXiswYncNBkQiNxvrTgPcQuIfVfBArYrlZyFsiUBEH0AE1IItoQDoxLMLyrhjj3YjAYEZ2whtFtl7eKzuR5CDBdHmeNLQIKYSAZnZAHDriQHYEkUcGeYhsST4nDcnnpVH5Qv+YOmyY5a9hb1XXOK4PaxL/mDWugx6z6OMIZesFb5E497AUV6xzaeq+tljCEhjhbEbgQRzsUiIqYerlb4UWGTo9vHRl3d9aYhQEPZbthW9lagtPgsm4HapkRPwIi9yqkhVwEj2U7kANbAfRhtxq20mr+SnBXng4oRXaKYtyhXngBbMrR2Cn0XIe0ZL4il/iSmWNPY0zUYR0ZD1N4MC5EqytiToQ7ft0CiuN9fJdWJNxUHo6nc655U1PEhT09lmcwamcgnz8IJ+Lfx6KZ081pE3LzzIDAUdOaAKGAq3QbNXRoNO4ka0b7v7NF+3+7/ddbJ/om6l4zzfZJ04oTi+jf9U+EX02oveKbMg+FTwkKVesPP89xz5gny7l+64OznnDlvX32SdSUBqnMRxOKw+LP2Sf6Au6j1YjzA/8hy58Ys+hD/71v9z5AfuULnz0Xe/5wNv+Ln+6fQJyiH/nt91+8LmvevMH7dPGH1787S0D71+ebp82/v/7Tx9eOvDh//wh+7Txz/4O/PuJi+0T8doHqB6cPdHIaz/5u//1wj/6zNPsUwr53O1nvuGzn/mvH7RPW/grv/Ku7/zLrb/xdPu08Z98/oe5cWd8yD5t/E8+mM3Ozl5/sX3a+Eulcb/2Ift0jTyHeDw9M2HskwfzWyfZbR6NT8H1zbcVu6ckPpF2AxVP54H7Ha7RN/H2yd98K6GAh7+NT6TPoTMIBZ1BrOujn1XSz6CWTAPZAjyJUbjOr2mI51ng1Pl5Jj8zfp7Bz938PJufxNMuF9mKMBFPkr3HNUX0Ep7PTv8TZI31P+eGEihCoWaj+p+nU52FaCQfcjCzwXmqa2g4LLJhPstpZNP4PaPtYEn09P5cvCTFU6A2ep6KVNEuprUdQ9HYfxhFmKuy76WnqNrouXnEx+QJ5q0lHTVHOlBylXbQ+ZwJEDm3n6HODs7gOpTLGdw2KiiE2iip2mikDcgTyqU5EUXSckqE2qtmaATYFecq+T7X6msm4FOSsgFuY2BPv3eBkDAVexU8Q+1EK5hoKhezUFlsF2grzTwrj+SgLN9KkYptG7ryNYXJQit9K4q9PnKOFg6zIDXReLBlfCHb42fEdub5CQHdtZSAYzrErzDqfSOexp50wC1GeLWIX6xHTEXEHMzLUQD2Y0jmFI56KQrpB2t8+n2ef7Xwf8GB8/wDmpMPqNZwzPNCBsmnwalSfMAwuA3lDld1Kd99QA9A8lic56hzaCxHWjnSVFW2IQYB0Di1cS7n/xSqAXPxS47We1wrsihMtV9dYRnxdQ+2tJ9HCXi6b6cEPN2zKRE+HMXzpw2pFOULK/034D40/yWSH/JLmTUeeZUTuCKQ1gTZ5/SDXf7VOaDaOM8/ix8QgPIjwcp8nn8Rgno8uUeCn0fwXAnej+BuBHFnHXsOBB9C7E4JHkQsSfBLiF2V4IMIdiV4EzIsSPAQgi0EIdw2lhwOUF3QNPu8NlX7g0TE6umrNnBKbKOMUT47YWSzKPhX4WYoqLg2HRXHUTCuoGBkUdBTFMQwKwpGDgUZ+YAyOkgHkMlhnUfRdKyDOBA7EodooVCbEtECg2gheYpokSJaAEQLzEZkEtEC/SpgAdNxEc1TRAtR/gkQLaCgimietMarIlrwdYhoQQXR/vZxRrSfPXlXC+GIqwVvE1cLwbirBexqHhh1tfCDN1RdLZTH0RG2mv9OzhZ+6IbjOVs4jNRH6ZTgh28Yd0oQVp0ShCfplODqx+qUwBvVLgitdsFbOg1fTvRDOUb0rgv4z5onqY3srFWa8myVpuzTt736tgdYehvLbvC8INglu+hd2ERjn8Zgrm7DMxzxXhBgzfsoZiVw4kd1b6q7wNiJl/VaTXzB5h+luqOloo7HziIRWzV69i27xCYFKBb0sI7S09uGReuCgFAupcMiNYVTk+Jh0RRZTFcjjhRNrXKPqfHHdJ9O5huk4qEFt6k9GOi3KTUQ06QmYmhKCS0tIdYSbNMotSW0tISY4uklgEfkLidWSOSPHG+qfAHSXS9NeexmJoQvsCOOn30CsH5X2LOEZgQj0ZgczasDbmgjgEwZ+Ue4jXH2FjRBcdCnbFCNqaGRKudXGn8bgK3fp9Sa+LS12aedvE4iTZiRBWdGWlzMmjaDHj0XA+2j1XV09uXANcqOFK0RUMTUwlIn4D2CER8MqbVeVQhpIbo1YEwoP/xexbv0jiItO89ZiiYgEFE62o3mQGOmQyCtQCAah0DzOBBAT/NE+p3PpjLiDJMGYNKgWRIY2Et0cFjFsTARX4TPkm7Hw3yOx1TmgGBTljdVYBLj0Z2clu71Q9fBplAL0EypSa0jxfyQYhDRI8XCcHAbzRNHLBCHi9Y68HxIKU8mqXZAc0cYxDwQd1hdFVzzGwVukyLprKpvQAI6mh6XLPwL8Cq9aFNAC1yB9GKAoYGJ3DY3JkYBPDbjIxNPjMwuC95R7ZhGnwDVEC/jgO8A8NA4mIT5RQr4RCWznf4eMUOU8CcRT6MZVRcMiAOJQwJpaGuioZvPBJGp6djOaoXcjojx30PJXSn+SN7CMyNUeiRPaTFvqL98KPiBDdBpzd2+ek1oEyMyzwSq68Th5wslvo2xPlLEt5aaCkKEIyjSIH3hSNEeMsib2qsMxfAEYiQYG+DRAWxRGyiieU8w2AEmG6PUwJGeBUoRIRNwnAA1j0OAAC0dyovyWR1mhoswMqGOZ8Qci155RNoidUheRRaoLI4W+BdYBiXoUhSfbjFrVyCsBxJkBgonEXITQLuVk0M5t+oCIOuYi71NY3nJtazZb/kBVO3KxXjQcDo9ogdyC/oBPTLRSrwteyuK0Cj1RTmxImhOzQhta6isKS+hqaD9OC5VlTZ+yxNJyRuM3E3BpHo5GQOlJb7WiC1aHpUWpnUx84n/ruwVLV3WBRSUckR6lVZ6S7xGTVlx2oTpQW2srIw72Ko3xXAcSo4YZYvInLE10XO7fVc9Ay0JHq8hTDgkzCFO9qBd9TVRoezfonUEHKiqUP7M5iqU/6aqnLefoB1vfvzbkXE7srE2UbVNP36CNv3aaJsCjVZ+Uiph/CjNtvvZm5Ba+Pt2y9maEg60FoK3H/3Uqfen58x+cADiIh4Z8ggPAg+rHQpQ/wIe/UQ7BFUAxqa+Jwy8vzfYK1ClMPtJYeFrTG1DYB3yKYHgc+EcE7zsBIXpJ7wQann4EyCpl16ZFNgj67tHHkTyIXnKHiO1iIHpFIJ873vfB/7wj/7s2j952pUQVlHM+K8KWeLU153I4sEbFFSjLdO6UKguusL2RFSvlIgMyklrmyjK66qzhe+1Z+7EV6DzSNUTH1nuH4ojj3cfYZXYHQ1KYgcws5AjAMqUywRWAb98Y9YtcnYOo4pyyh1FPCiks7KNOIIFBaTPv1VJUh0ABp8rBVJ9MLyjSAZ53eB3cqRIKL5KFndQ2z1MlVoeoHV3jYMU6vFzCEEM/q7sXRDsZQxqYEjq/K6cjjSgyRExGH1kqgkbx/koxP58A71D8f0bQVjcnibVPU3LDGtStG/LZ+SKQSoji5IQVi6dCBM2YmhQ+wiYo5BmKOJQFy29Ddkzk4VbVOow52XwqBPlyITwdAvF0H3rmUde+9YbY+UFGkrhKVovIvQJHc9jAMakAIBUfvQBAUNdsiukOHuC7PUxNiBPUsVkr7yjC/hzmrWMejAoPB0O3WXrmoUtHoYNYzzIEyST0XsxDYpQlI45ylNoU0PWnk51+BKotbkBcgM59kmkWaeOqXZBZcubjTClyJRSy2RilP93Fcq87etPKHPHcYUyAxXKvPfkgRVVgXW0tgmwwjFgXYwj+FFYDafDSsO6EAJuNA1u4X4GnWglx0J6ALkK3MLjwQ1AVdgAfC0FX6KPUB+A2/px4fb2xyDMOvJ1Lcx6lJ36iYlORdVORSfZqSseU6eAkKOdimynvsfH8gjFHysfU9G4nqDpshBJIxDDO2HL/zzdSs+GFGLjdas0mbM7BulKsST9SDzuBiMUx99kEvnjFAcHSg+OzqI7R2YRtx0kVIUC/z705qePO28OPoZ5c/0EigVVFAtOEsVeflIo9osnP5gwzGxG88iHXx1NGUzNE0Cvzw3ogPNirzr4sO+G81dGhtPukCLdI20yoP37r32R2Ev62g7s+447sO/Xgf22zcyLoyj0UIbzSx/nyQtSt4ZxY+eX+FhbWrEajpwLa+kH/CDEXsCaPMcIl9PosnatPDAjnVg4FuY/VpGStcEXTooCHM1DyFk5FY9xGh6rHAofPQeQQ2A/zt5Ek1a/Bq+oX+pdUy7g5XqQTzVZNjoIBAYj9TX7eSuMr8xx13w+jsT8RnX8V87vxM7v7C58rj1LpOAidA2a6EqIBoXVBmXv0hH5QtiQbdR1IY4l9G9yhziuwRcCqorT3ssUkLWNou60LXKu3ynp5Y3yjViLso7/8ybPYCcMzlsCxVappDoYUmO9aDsRsl4mymeordqAeTv7BYUh2E5IvprrNIP/BizDmrmVZsr92BCspWPF21AtX8g7uv+EkmtXHxkFhhVrSagrc2rGEMzs3aiOXwMWARZtPLrUdtulmSNFNjyC3s2UdXEk69qtF3PclQG3XTUsYLGqPdHA1H01h0t6w+E6ZZQN0LXZ9cpGDB14BJmxo01VuY1m3BABPTwYWofyLJLn16p9QbJP82vU1lDHhFqu7LxFKZAgNSIiZ5kLBbOCKTwyAq616v49fYfnhY4KuIutKjyDim32HkC6r1ucGCp9CaZ0g6n+blmwOdwXRw0NyS+e5DOSuLOoMXXhWKWG3h3zUGICYW32i1KNh705E60LayE/Gig2dq4JnljdZ6NrZv3wynvYo8c+6aQzAzvX8CkA7ePTO6QbXlXpGwsCMG6CgTldSuxzGwY/8upDutVHrWfX3o53hnn2y6giTT/rBaCF0bUVLVwdUZZXB0rQdYEohFREbgI6+XBed7GJTMtIcUBJSgUBGrplLCep2YTGlAz5IcflgwouDo9gTscDszGlYCIDPpVcICB5zJmgF4UTGY7wMHk88YPxP1l3Q9yC5IEyBELiwYmJDEc76gdI8kkcb2SFCNI8aEPIHkFuFyBVRUUoqixG/Q6WY4Ob7Fa/3ewOOK9jE1Cer7jhI7eRW2fvVSKt+vCeDO0P+l7ALRd/H4V/Ya2FFqrjD1nVz6612p4x5hWotFu3NDzDkFUaKGs4cmKP6XEhEBpygQiFEtHyddEKVKOd2/JLaIsWiB/wpPbbfk0e2Ya5g8/le1q+t1n5qXNLAjCWlfE7Kts4YWXanjT9bxjIWtU9ijpc8Y2oETAz6zqSEkU48k1VvgyPjLg6MNEBS/AJJ7jiMXtRB8bn8Skerwc871WKfyiP52OXZ/tfY2Y/4+iNT7sOvl5OD5L/X9tDmc940rU48ENbZl+LPEJg5EPApptKAbgDw+/Zm643uJP9oBKB9H88Gq74AxNcMVhBxxbjbYwv7k/jiwt8eDXzwGuPfgMG9ndk/4XalZ5rlsCcLWV368QxZym/qajyl17g40K2WztG718vyMTOI6XHmTr+CRFfQ4rEeXpR20MOqUrFlmCb8VMDi4iUaTe5Ywb0WZwZz1Wt5CKFRKa6VQtF3foXRzv0xm0i/Kav16PMLVsPt648qhuxVPXyx4WePyrW9RXGfvYxfKoJmioj5OCeHnqcDxz0AvGKHCdwhtwrjxl+3R0zqIBw/Ogj8MGTT9xyQgXOM1GonYmELY+Zu3YcfMQue5R9F447Fo7bOw7H7YHB9RyDC9JectY+FE2msdNRuV2OqTa2XX6k9Vo5kaq+yY9uwML94kAr1HGMjQqoDgVXC+9Cyfkmf64LTnWzFaJUeYT6cLtojId610Ux5fYCtHZyT/0zjyt26Fpob35hommE88GlOTyTA/jjjqmOneCY6k3YXVujCli7ybc3yblxZu6iZUjcg59z9+Myu9Vq/Q13oyw0/rZUYQM51dEwhYp2YCnqavC3CMDSS6ZduIcmN6kx1nW98xEXDc4t3qPqtjkehTk4SF/t4crn+An06qUziWvOgRrkg2OWIyCg0pTqR2oWZueDod9yV7HIkT1D7zwRJ6jtg8Bc+6+TJhcJrsnhdCJW78zYi+Gzptk3eTL8WOzqKCbFICEEnRTdMPcxUWASGJuiRMpoK4M1owrwUlKneuUrQykJdTAeqL/A1iTPMNaZ3PuEApboTDQxLCZn7hN2SAa0ETVhR0FviyloIvz4JWgDwDSw3qPddt0qc7SVvsqoRZXGwawSpUqqm9K8WeydaJaPTDJq4pSO0+0pHfYVQXm78K6LhtIBlgB+/KnXfe/bBuzea99bPvGsZ/3jzP+4iHuVGaqvd/ci2H7zXqK0/50YGJxf4I/B6ev4qbqsapUXkXQ3lu4WmQrr9KGdNF2OmeyAKKHLvkElzLPQaaCGbjrddfLCqlYpq/rUz3zyZ6acdSDPhKzqk8jLbePHJ2tOWvVxTENuNP+HT2NFzX5rU0nVS1/Ub32t5VS/c1w51W8psXx2lRupmr0KytNmYKXMdYeJesQsx8duB+H2gwpSMEBaS8W53W9Pd24HaIBDfSa4WKk/rNYf2jUaJA0UNsQnZQsokjhUg9VjE67MtcqxZS3LlX2n50/K69wKbt1ac/8Zd4Mx/37BqG9BJ7l7lALe355gZVtVTrY1wcjuLhnZMPtdfHx8vvUE3U1OvrtAvGp3//rfcwIacbGumoGuqQFkIIhASFdsDYVmrphJGutXeNi3cNphm5m5X9sjt5OauedtJq5x3PI0mc01LJLqZ3qaXfgMXN3dQkkNpQHaQf+J/NrfnTOfpSp/GJLnKkrojv5SIerIzCnGXgHfGMo9fgQHcrQi0Gg/vTMIE6PDMsmVoVlOMDR9ogD5GFyZWvsPlLP6tHJWfV84uGfcCH/H5yOPmkPFXXm5shRJo/EJRWuAFUimKk5erbRNUftPUZ6iXouvWBVI17tdEWplCgOct6xWXREampoyAgpP4Tf4Y9EPYDwGV4/FOm+QtwExsCxo/qV5inrBJOUxeAOF7OgF/OZ60VLxryy12mm1fuJDuXNqikfQnasyCObiVaSDEXFivR86VW/wom5L9gbPU3kaFn6erk4kPQTPtm/HM97cOnL7bzx1eJVVlrRZjnGWYR5WDD5RIKyiVzV8VURDMJXAOMya9WHhA/yDolq0Njv99Sj2xYIEt8ixhAdD5QmFqEAseOeP3CBiQcbXOyEhzP63zJ0+BA2amCqfclCqIu8AhTAwoDyKUGDf7M4wXS/ttVnh66r/9efXPfwTTxMlFDUoJ8dq+3G5XGRzuHmUNyoZx48NmriduOHgR/WNI/btQ4OR0wDFUWkVUJQqkkxRlp40EzC4eDhuJmAg1wWkIxvrCA+PqI0LjGS2PinOBpeFU1dZPxV02oS+p6utula1Ap8ApKgBviyELbM8Q/+oo0yBtd0SET+iqu0u/g+dvf37a4cuuu/8V+VtdzTRkn1EWmnWmB79rOkOnyi4ltMspUeoGjPUfuaz0tN8rizw4qPZTwpez7r8GRuY0wx6MrBezFKb+I/54XaZ8CWu3Yb/y94rVaE7wSyOaQa3MmAQQ0wZjuGOJYQHQzun4vSNvso5gsqJXehO7AxPHKoYQEUDkXKEnrna5vgxH3FrWId0UJBJs+DF0xM3zcdMpi0l0Cx4CSYO5YJNDuVCSBFgC5L/SilCOHEo5xrGn2ibOJtrU7hWPYODw+ZrDW0xgxsMFUNBS4ZobJXmIO5Idi++HR7f6Aca9IgMto4cXYRgCv9qnFW9fxNW1Vc/zB/wo8Asa9owNrcxYSPkYGP0/f5GH+Jkkdize2pcqHWkQHYDHItFxeex6m8014wZiwG4W8QxmgzSNcIu6t4GUsv9YREAUX22AuIMsuiiNUaczOseNlIRg7pRaQSmz/wA1XsbeUj1PLCLJ4gSLn/uvnrD0B0KKxZLjD6t3Z8WkdohqTbFx6KkM0ZahAG43Q8hOQNtR0XW+koNPBaeACWIrpjzTByQGjjyZYKPpCZ5uT95uNoCYVkrd9Agdz7V0ZQUDUy1ge4jat0Khox5mjZmnwp+Iq5DVrCYmvyNaEiiZH7rHxTI63VzGCDmhvi4Me7j6FwNobZxFJxApZexVQAhRVYZCT3ckGMyo1lDvs6cRnrj4yzhtDxwP6xKp/78+NKpf6NW/MUJWvGRyYl20JucaXtH3w89ozLTDr5qykzj2HKmPfirtWlT7eCv13SuHfxIbepkO+hXJhttPtkOXzx8ZJPtq7VrJmYbFv7J2aZLuLZlYraRmW3v0tlW5aT80lk8TM1xaYj7Gs46NHR81sXlrIsVSWI766Ips+5obbNpF0+fdoCIlAmreLTZtIvstAMs7cLdSN/teT6YYRaaefteAfO0P3CjHvvWSmNE62X4okr4sr1V/mRqsLTbtc6rsXdH7qGi0XuqXvazaAmGNPtBqz20foRq8oluADiCPMUSTrht/ZGo3vkjqnfhJqp33rjqHbRFHhpVvftLt/l22+0I0/zfSfXuvuPunz+jC/1JguoboHqUQqzPTgix/KqWon+SWorXPlbt3nBU4uerIuyj+uSVQWgXoQ2QYPS5/32GcKu7whh7TTeTReGO4SzaJUCX+lB9CBZ1OTKBdLsGgmW06AKwCkLbxUyN3izsq3j/OVVRrVq521RUC7cQwKrNZLWPd2lWd4jLUzMxqrHG44zS/05LN8IIfHmiL7445Yuf60Ur1wWvGJEk3YuNTlUesOHkAbJJeAfeVRqgSbKDeA+CqX5x99gX73df3O2++Kh8YdgdLNb68T1jH3/MfXyP+/gT8jFYaLkQiTJEgESYqAlCqwg1EOoi1ERoASGpMkOoJViPUBuhnRzC8yx+ypHSDNiuUkmn8+Iio86B/TB+OIsqV4u5F+fzMsRIX6DZ/fkiXnep79Mg942RJ5xNLVFEsy+B802aezE/5g7sF2sr/D6/n+oHimXIQ0AvlqlDiyB5eYd8oIhv+Vy5/WxGtYbjyC4elG+RzuUrfQEW2hZSZy37e2NOP4N5kvkDa5SiRjFf56tK2DHkLzoIyqdFBP6tQxEotDEItQKw+AeEuKE1Eae7g8iU2jS3lvf6ghaSGbP7AVSNYiU6bwtNQ2Ix3wctcJWvusrrqNWdGcKoP9q7zI9r10SsUzOX/sBZKcNKLfxd2kNGtZNbF0vKlK7hiFFu2M9w9+dAHs3AFrCflcHUlFja2iZF4ia88kmIDuViIz6gOXwCK3nFdtpWMQ0c9TNnQ3g7bR1JIsAJg1f45gL7HEA2R0sWaGm1RjSAYKarcj+lU7njs6zFEYo76El56qeV5i81nruMH4vUQXZpU8gCjmiCsTo2w+Dix5y1Rg9ThaJg4oguqbX5ZQPF6pEoUT33SRGd9Jh1jnwDauVbyeFxMmYrbAb4rxOBQL/VYq9iutUQnbcaojzFMLhNalCm3yQ0a51jLfZD/DH321Sj8zUlD22ZqzIXF/qqlLgFiIjzc/JfnDcUL+eEijA41OZSPqvk6P4xcvRpR47ud+ToPgRTh+++fvzg2Mefdx8/6D7+knysl9OW9MNDN49++JD7UJPkwxsRTPvSJFCXA2baSTXSa1oycf5e7d4ylidQGiZcPo/TAh+8iP0RtF0KgoEEMecxB6ZskQMGwhGlOGRXqiA7EqPmWx1YWsacmFOxXYrI1BgJoWUZxf5DJYlS+gR0k1e10KDy4QjNQU6dID4mpXQAVHgOVJhbRXO4+jpKIqWkoqP1y7hHeqP4dg9PijC6HekQX1P3UDnHgZKhRgFc3nOwWMVUMAQrn0X8QcC8yMr2FfNjUwsD+co12b8FUxTBtovRwoDw3G2eZJ4wqjCLPyVni1x5RvPA+FVaVHK2LORsnpZPTM74cbvHkIETHkfWZGby59NpmmbKRshZRh1sIedwUQTlYZQo5vLnMEV1vlqNhx63EzJOLoSUjEk4M2RsSZtLbUfaJKwkbxYUbZaWLlXHmzCXiuOmlgP7rAP7zCjYgbVce8tQtJRWhaJVYLAMHzeGus3SzCR18yfo2kzu0+KjpGtMtSpEDQCMKgBcpiWegBEA2AIAW9Jr0HGHhosODVtKk/sdHH8JPnrojQNMzwFmdgwwq4KPOB9Dm/Cn2DUjZfZoliExDU/zrQBKi2ZgZ3c2jyBmgTeI6Xm59K3kC0Zto2WKLGrOYXQVlRhBGdkIMTUTs91yFGrzugI/EB5gylaDRdsFW+aBIfMlhoBuTYXB3BgM5hkG/4sd1D+aOQlkwZ9jMXo0hznZwhK+bDi8AGwddcZn5W71ZhAQXkg9GuhLpl4N9KUmDgEIxz5mXubbjfgq0GNWCO6V0YA820MUXsfZkch6KlAtJqycCszUTsu9DMjdpOHdHCbabLrOYFsyUyKmWC8G6jqIp5tPR4B6kZbNdJwXXEunzbqWzNPRWRcxvnVIST+RrzMvGp15m2POfJWRQPOVd8BioPKpHMb6dE0TFHJTbtYsfXUsfdxc5AH2g33XD+Yx3tzEOTM8yzpkFOJaD9G883BWEL/rtXOzNPkH8g5ICNhANWFjl0bDSS+gLwtm70pNZJH9a2kN8G/8kdsv/jTN2MAciOmAjGjGhnoIdZnGCZNvjnQCd6QjslCnBavSGR+7cYhjOBEZSnFMWIpjIqo5cYxsyILNawm1FrRpVOeVxT7efjnsly8i5KvovMol/arOKyZNJE6w1C5+KCr2+gjlgbTsvorOq96idOITyKanSGj+HMKsk4S1HjUW8SS07aGk6gOfBLRV5xjD5GA9flaIguruHlCCKRRWKolVHlujWCqpwhebe4VvoPAdOcyM0RQDUadkDPNtKhDzykeojxr5Kgvzsy9MqBXrPdoJELuzy/NO+hJtxW9lLX3jSrwMXX7c2+RfZ4Z1VG5xyxgPfRPelYe+xfHQNyOYGs2HsS9ud1/c6b54O4JWbmFEJGMfvsN9qEkqIik/DIXVsLKGPLbSh7xeig+SUjbRKCUXTRV0GMa2Vcox2qXkY6aUd3RKGUgmgERotio6mJOPVH6xwDsjtLnKl1OT2uTT7IuLxQOUcmiRWe79xRK1XlzUDqi+xiwoKS1hB26kGdyDGCmxyhfuknXCl42RBGt6PlQDdZIdvSo/LzgZQw10nQsckTE0aFbM/cMi7WwfI6nfWDlD3kQVEp+nMkORWnT78PziGrLFNSQW+liDMwdZsBLqirvWTViEFV5jD2I6InC1eV5hnpdTCmjhTydnbU1MIm5Rj2fLxO91cLIoHJ2gVpVRqBlGAYkIk2FDaoZNIBOuGXakVTIJKyoSUbNkVHNcworyDbUqk+BcOwuT4FjPxMAYaz93UhgEfbmaw2TCVwiDoOHLwSBYZeeuZRC6xlmkg3fTwbsxBm8AOqW6gZbcncK+foRB6IGaCPTiSiT6TI3cpzYACg6WLGNA8RiD3jMMOioVrAKb0DJWjLE2W62TrhExYJMirqx05s2LFjx/JFPuxfmq4pVKHLnhSKm9OO8+clnBoxAQrIrRtUctIKhRd4qAoDkmIJgFvZ2155VttwdRvxltpe0LHOjqhK9RWo5FrSIWqCvYE53Ms0C0eEQs0Abk2zR7MmKBlooFauNiAfRKms1EaRZEiFtFs1WxQA21aMFFqyIWwMrb0LvaTGAxji3pT3mPzwgF8q5jDyMHjTmgKzZiYqkH89uxxfPayqlYT6vYjC2bj7Y8OmqzTF38Ca0RN628vxGkpQVlaWOZXA2Kx8kMpAQ1lRIo0RAhWUt3yDqCNScliEspwcqIlEAzZbQyIiVoYZM7q+rsPsaM6lz6LAiNnhfbOxURLWBIHFGpVYgKyIq0lraUQgINq5Cgiy1gl5pWSNBUIcGCA397c/B3RQ6yYIhOygDjx6yDQGyMoSqmTxIjlRFUI4UQdZUQ6RWe2c1JUDJGgpT+rQkh0nP6mgNfTE2wA5zRugRuliKCvCImWHBIuaxUVMUETSMmqGLmFgea7hhoIsXMtgiG6/grN7xYyYRATsNUFRMsYy8cU9dQ5ihvTc87IiYQtkdxc3ZETMDYRrMVMcGKZQp0s1cF4QKlwJWtBo9WBF9UH7fEkan9nx3rf51WISLoProZ2aUUfwqytgBsVpf+NsOlXPpjmn0sS3/jcV/69RYpyDmnVdf/WmX932yqqhKKRUsO6PofT52K6ZSpuECxmYp1M+XSTdb/2UokpXkNUw6YJtPO12lXG512m+NMXSecEiW7zXbigQ5ltChrgdv2Y8413Jxrq89eSlRO0JA8MUgGNfUDLJ5o4awOE1g+JyfocRO0qSKA3U49lRPoWgU5QQtkBMLQRFunNqWtnCCoOAj4mZBP0AN2Njb9hh8UIwi6SGpjM0RkAofhCSVGeWat+2Hy0KwGNYbrsOCbrKsavDMYLEFnszHBzedQoq74y2f1xwPf26fGvo9/DP8euBgeq0VV6TIeqX1feOFfHvrFB+97+lUQGMRiH6+1sX4HTnooFZfW7Y3120tzh7jqJxfTMIgzCOl0ikQMHolPb9GZRqvFu3pMHCIOJFabK6voSF3Rxzj0a6QNeilX/VBA7RfDngtG1KnKqgPMojmqQeQbtaWbrbWKznMgg1JLF2qDROzNZ1+1PBU0cxlRxPopE0cZZsECBiEiHIgT8q9iNMiYZFHU5oJKnahhkbh6lU9F1aDy9pr7wRu5PkwXE0Gd7HpEQXeaHp34CNc3jyfQiB6JQOP4Ig0nPrpzivgo+HcXH1WvTEfHk224K9P/6IUinniVUQ8E5a1MTeHBInlmUHo6PaC8PqpuCSJsPHHWzxcyHBsSHPHT6pr0E7kow/3hIs6HrVO7eMC8qF085MIsRAtK4kR6Az+CJpWAJl2Y0v3Ua1RLBHj71iIBS7MbhIESkKjd1uBzAGoaWMOYNXff5fNeoCahrFQmKHUiFcu4DaKJ9y+lgfCzayQbGSVCMVML2ZPp7WKq74cBzx+/il0mQhB1WQ/ZkrFstclsB4B7cl0IZKCcFmH2r4JhXvYQnvj4Ex7Qy+M2vfXVOonGP3kYWbOv4Bdph0tDoJ8PfLj5t32NnF/HOszePMDNn8JLJAzxB0Py1MS/Wpuhen8XtBo2gOD8cre/huohT5ekbON6aTYF2atvlIZnv4wYqnPywQjeaST4QMik8iW42VWXi3D84Or8rk0EkqM8mYch1GUx625AkUWApYJ7LNKib8eNDEyKm2BBFu27KVrLbkRGxPdv8tckTeOPXm/jD47Ev1nisUMF4jI0atxz5dFgwQN5d2n/PoycEnt3zcUeLmMvmha520V+pIzcOS2yO+3z1pTIMkabXudRfUwXT+//t9TZ+59ARyj/e8jpLpyVBnx9fIPd7oYxx+0PwDje/j1tvdY0NX84mf/5OWhh+geeP3oHMXZuTfvHQHmtSAb4ySE0qf5QgC53KQZS/vhVQslXNR8MVmi+zOZrjeRjLOKC18CK3f7F6w9x8TBcEAOJXwPc1PvK93tqnuVefqKw7gXBPRzEWZuP4fq8fcn45SGP4uqVvV+KI+gkwlhMUBUue5pDxoZr0Ps2xzxMm1VMmuzAxr7f+JWNN8UPnMfX+p8s//7g4oGxV7Ix7DOAB5/iNq9X3CaTC17VK+MP7yUXvLL3kF8EIEWX9ORqZe1beoWPTpY2l33QdJFGqLmo8DIznuVoYoDFnsbLyZtuniZ4IXmE5/PIE6+qtey1SmlAJK9Gjc8GzslU+naNfSn5avTmcv2G09S8H3nq8BkAQkPu8bLXCY2pK+YiwdpCAgVG6S1nWskH0unFInx9r5cnWkru+CW1XfHt5Xt2CBWoaQqkXI71yd2ejDArOfrZqnGlHqAH5QGiW9Eocjfbqi6B1Wo01bSnorSJZXHfbbfi3x8xx9ikaH2YvV6a4SuSiHbn7UAbcQfnYUG/EU9+P4inp77HDulS44kL/jeiBLXXdZbeOQt0aUo1MisUTBopvWqNR2EWZGixJW2o6r7a2pTYeyZi623PNN83lgNSbbLcjdWcN92oFVW2In/t+TiVqUx+nayysAsNzt6Er1YwKU8Pdp8f3OIjqPve4JB9ybA+evoi7Mn99gUr552+fs5LysCX2G4e67S/l5NgIuzTxtDLPb7YpP8f3/vZ22+99ZoPDtjI5Ptff89bfuH3b7+IXBBM9zFfCcbdeGISbPgVcnGfXyEXX+KX9I4oxMIfVolfVd/97NpRX4xxGZ3WW520dsrs87nYj0qWGiH8HgmryqsEVeUVwbQviW5yio4fonB5KCsnaFdTjknmQCfpAkiXjt4P4mMAChcXf+hG5/2dYVgE5WZj30M//YXff873XHExhT0kvl3wYeAfKKKNCRIXj5C4uiNx9SqJqzsSVx8lcSE4EiZx/ASJw3BaAvcgCFx8IgLHYOceAczlGID9wy2Xy9qebAEO+3ng7oUc/H/2ZodvtHbUsh+WoJr2CyTmzYjBpzoLqiNbrU0vwADweaya1+Tpsagx/hBaUqc7DSNoDh1FCdeyH9HlC7O5C9R1Dj6xfKgYQMYnD9xkDHQ4b7aT0TnrqKd6w0tvKMm9b356rzLoeldU8uUUqVAgBt+mdxsOyRPmWesb2Ozfgnd+HsbTk83rIFL5gjiqaiIcqnJ1ZLlY3Kf0QSOxt2faaFjYFjzAMGv4w4dQd8uwsX7VWwQF7N+oaSjrX/M9rzbLH75X/n2W32YoAvuZdzC2/Mwo3mBBS5DPccQnuMrYOWAVzRMh+KZeCqF0IQc7HDHwmdFDQ4qGcr3oADwSLVCE44F3RJQSh/vviHiEkBGKuRKvcWB8EZdV4t6scTwV/LficdSn5MitRRPhDQ0v0iI1r+wNxAFd9S72lbIToaYITdQAULGgt0wqG32gl7CDKPJOv1jEMymW4OgroKYrUB0yCe8GUbPK28BPpfuhDi438Bu0IFrh/Bq+lDcPDFdTs+jLpiLrmkMR83plXVCU0jWaM44SqLOWy3HDGgrDQrrA6OrYfjQO4g58xzkU+qBR84CxmNpbzZcRLzb3VqHfqCYsBGa1ApZ5m9iAQp7L4TYtDWlxHagwh+qgiYj6bv/c9Ufvft2X3/oVrngT0xdBggOIeVQb6XIH3MBWRKM+bKOwDxnPddFEzG4T85EyZudETHfiq9Z4jL4axOHJaafxG/wQUxd/k4YLw2fc9u7PfuzWd3/2SywtSPj147fKO4QH2IhEwHy3jVW3+9nNh8wapd4Lfb0ZJxY45LBTDXhBiX7kriJ4HWWZGmIYGhnVMZvJdu5eKakmviDBqcSMeONUmk1RlGK5Z7X9ljdiwrCT9jNju9LPPnWj8ZlqbVgei6OgdIRpoLHbUTFP1VXUbzOTrj5YYp8FinVFZiXC0JJT3hWGuIqkcn/QOrkfKr9Sd7Ym3AxFe4ZH2F6yIU6/zLlDCg9sFGybNjHL5eUXkwuyM60E1A0CFDd91dWRMOSEt9W8qbMjJU9tSkeU6q2yZmnDryU8VM4PtSHdZvx3Y+SXJtEqcZTmoV6lwg0pflc3QsbziQUDZKV4dPDI8oxaSkK/hL2ryMMbw+EYDIxdldP3DmlmHU4X3c6R/IqwGJViJYE+vfS0CKWnBVpKk/BnSxFwZDdc57k9uwHz42pKDhp36Avc2nEcm5NpbTApFTBQiBYf2G8jYLujtKJCLnhVD6l3DNf54RP/gaSoHgPDf87cDRPQaGMTtcCAY5u66LfQrEjx60I4m0JOVdQPIqlXYEEplUI2mcKiafiwJJZNqqMyc/6idejirjRdyWW3aIt8GM2s7BUx7skRbr9YXhkh8z7POuTH6NiOYUGCyOcsfp5lmHsO7rbU5Vjod9gYjDMU4O6jP+N6fl59Pm/0cILyiRo70QPdyAOTlJ3vXyJJd2uSMpBM/NTTxbdnn3q9sDNcWRG7GJWT4FV2gk5yK0OsOk/WmR1eLpHT4CIF1jPdsacr7b7H6BHkHXUg1M+wpl9TZD1QOBggUa3MooPXOfIA0Hk+2li4VWB28MZz+rwmBmByKOtx9VjNFt5WLD4UM+nEcjfimq9Fc7fS7K00P7SUYIMt+bWMI3wV5M3zKkgLtHiEc3Ek9ErFsEvWxqBjtJv2tK2WvQUAE2sOjvIlSvnyjHwGI/k81fs/9nrcpvxH0Iz+DyPcvxe/0tte9lallJAzLWR/eaO8MLz1e0RnX9JIXrckpf8Xb0B55rsSFPqtjqXJrF/qyGtC/48Pum8zgxN/Yd4yS6P/l7GZZeQwpLuqrt2x+WEpj8kqW6pzK3utnVSTdngATonhgPHzYDBpmH0aLdOb6ORlv6JmZmvp/+N5U53TeZAtBThaYwvUIj+xBvpXITSVUE8FS5CJAmofe6N86pjp6wMvmGY42LBkP3qjMw/nfEZEcgBRbsjPrkWQWGBPF4FvU1v39o7maLqkAlUeURVY7zprkv3HkF3vlfpAN32FmCCSa6hmkxLoDWeUtSbKiPK7x/nP3CXBc9fEHxJarYWoVfA+g373pWhB6VEzUuWoCI1TX3KgaUaEBCNGgLPPTb5NrSKqVAbZ84if9nzTwyY+qnIG6Q8GasZ0wv+HHnMCNQwx1WPW7G0qee63tDflRoqML4/sAxYoiZ4XIRWWxNpaIkWiZbtWEiU8oGfoyVWKRh5QE946YPhJjZzIcILeK8ca4tGBUVIlxoFNCDSBkzRB7T9ao8AtPFrUBlvbNopqaMWotwTdq3cZt03NuvtsYWDNOunrKAZqQ3UGy4lEtWxUB5WLdXauUtupTlldi7AcCoiM4Tk3Hvf6ge4qSRwDGOfOQ/UP0NrIo9KaTR6U0DUrYy13DALMt4lp5MBK5AIrkVP7tnKFuyyMkxkt3CmtSyhw7sp/V/aACwOKhlVBHkbd0u5v3TsYCjJsrA/Kso5KWW7/SZHNvhdiQAn8/N7BlWwHA9NmaIjnt/YR85Kizr/CgXF7aXo/p/ZRzcpV+rj3h/Yal083A8Ie43yFCJI3LLwjqEgGV7HVd+AYqbC/Nw8t/1+WAVNa/8CEXBbK6MhwkH1YpD+x5qPIQaFMiwi4cNR+BmPAnKgoazzD+Awy2MnSQ4Tg1n3/5R8e/Mj2F/+Ehz0BUtm34TD7aWt9g/jlDrG24d82pGCde2wPLLyRlZfz3qY5hwqVr3rOzOYxf+TAQZWHEz0NMAZzVOr4yzLVQznZcrhKUfYrSCh0qGAvhSeJaKweZttt0GTmMuprrJB+nv8xnjs4NhMPhlrJx1h28D4ntKnZ/cLuvRZ1BhcNJ2otwjv2fenhT7z8r0/9DNtEi6rIXIiR7it7Jubui2CXZTfF3FF3OjFXqxxMfkTkPq/y/KlLnyqQh7yr1zVQVcsXsPHmoIq0dEFc0DuSSem4JitXSDht2L7Wj15Gnjqy+dCNo6vj47nyvn+87Guq50tHPVe8mrX/LZxWWxrqth17SyRWbkGTPXNCEOJjZUAw4BRwwQ6+P+j5gZyh6SyD6VhUgpN2Kw6HYRKsdiMCUZ4gG76RSm74UO6HcEkK+BgKyD6OXwo2hmDLKzYey+0zE6MNfXvBxz/eHxoy8C4csfl6plcVP2o95a7rwZJ+PZUL8p3srHSdNJA10jdS238oUxLOz2WxKN535LRibafE6iH+yduxue/rq0KLIVp3GDmqngr+gjdNzUQBgoMsVTLAMqVCikqvEEGBKgfom5DMipRXI2VCJZeNDUL/wxtsCTRKlVfRxMM+S9RS7aHCbEjeC/IRrQ0K0/vCQAX6FVzzNFW36Rve1IMzHycSnEQI3MIBXPEcPTq7yysCc/qjsvmbPU14j2cl84fx4YM1lQXf5FlhsAclYW20wki7gW8PetnvAIpyNpcHyjL9T/LGkPI8/4WAr5Zacc9rTuMiPY0L2TeiOMO8yhz2gRToAR+KaJUmniisHMx5oIc17TF4zVFu/eXmICzU1b+lq39smVWVZMf83Y/r6dhOPbNaVdn2Aj/0PMN4OCYJ3V/D0YYE/x7BljvWgqAAxZE7PwtxfmZk+1otorLRKG0/mCd8gi6PHrlpe3aht9VDs7cDCBOxt0zGVohLlD4ciheSYAqWgeAcF9MCi2nB8TAt3AzTwpPBNJ2jBr+OvUbAqKe/ITyURAq/eD/rnL6oD+UaRLSsc4roWYqCIbfELyLGvRLzwjHM00+izfFu8kD4EeKdb/HObZIc3mGj9TaHd/4I3oWPEO98ikbxzp/AO0ROYB7Wk2nop1Pt8Uc/P/2gH4RyJCSL5+9jfPMAQDvm56E8PVVISvCSmfUyVpO+IhWunqgnzlfWqMuvxLK5ySQrn0w9XE9SsgUfuwicTXkCqV691tehr1rmsBuq0C2jblVVQ6fr2W3i5y9R5uwet1Keww287a2mPI1guWBSrobkglfhWLJO3H4cRyaPJ6fzB68Z43Re44lRW4u1oe7eI7EZZe7myNb+Fjt9dC/OjzC7VblQ/RI5jQBGXkWREcKuKvXupPLiXOVbW+ZP5y6y6oZxlBf2N36HuX4UFyJDKK4CpB1vRZ2qUKkb/QAqTns9Y08SfM9tyl0Tvrfqpb67OlqqPFVdnP0n1F/TQ9rTa5k4h3mNULNdNZVoMMJ93ztvfEbt29o1ZFkl32TZKVn8Msvl2CsG6QsFroA7wxIP6TfCypoXUWk9PlRZAscjHCDKEB9cATPeaiSb9Ha05ek3o+mZhRz5FQ1SrQkFSEgNfRoFTmBHhbqF6V8F47oFux2yTVMfYIU6NEYd6SiSCQ6o2A1xqwhJ3E4daSiV4jPomOp1Af1ZXcuOKGcgjqmMOVKSm5gIrcpNVd524d7vZT28LZSJmcgkysQDoMHGAJye1zNdKkB5hoKveoCcrZeay/1zIXl8uyaK4Cn7CbwYaUcLNFbuqmEHrjMMMLUeNn9SZ4GY9pH8RSKnnWtoByVyBqpG5cUC2x2gIepZBy5RnLdW4KnqNRVe37uEP+MHctUJBa7JRk7PxHxV6FYqZ1wMyrqYpmhjf0GRBq37KbMR2e22Gov84yZYLftjIQTbpsViSqqW3+4RL7iORe1g+Jiw3KHruZPU/L+eP91tLoNbli+07pdU3CtLR+maYsOsZypg0yVbZ4a7jl2VCXGGSkN/JvQa100gsPOv5ou0TteViJFGcM1cT1B5UbK/aOiJSDKi6VtAyR5XBWRuOfMKSA25i8RhTsUEFDe/xtUNxRw6QJ6+NPACVYHGNS/rxy/jIrI7rQKZIJExp1VKaGW/3LD7QjRTFTDlwIjSvlwEkS9ROvlsu7yncg1+fa6QGzEC41EKQ2x5nZqc1yyYDAdpXH2NopcxDvkvE/f/wTU4PYlZdP4Mj7x3vvZGHGtX3UCVJrJQr7V0gXJ1RnaL2GxUs9yTiQ5MFczlAJeI8gKjTZWpm8UeP8By6IP0muRq6dx2J0Kn+ztx4iyhVZRhtti60PHPE9ayn7bTMRMN1wyYIqOg7R6ZCX/+iC4meFMvJnjViwneiS4mXPdsvZQw4tStTmH/K6P3EX7mxsn7CN6/+32En71x6n0Eb9p9hHcgby0d+H58Xan+s9sBucR2OXJS8bEivU0MdSpEgbwtUKR4HzOuHkAQEzZco1CmU/0a9ulcxd86O7EULw91oPF1FL/ztc+47jU3AN98xTdf8U0epO5cVvnhK74hpPgmIcU3j5RwSbYeP0qMe+e1T/Nq1mSzUgbpg0wOI9J2swXHYv8HGVd5541fj8ZVfu7Gkzeu8vOKjT8O4yr/DrjIGf4NcZE/UeW+R4qKf+1HmKwe/q7dBExdRcYF5WV9pe24ou5uMUMkwtLfNe5skVxudMByRMYvNfxL8ozrrsXduROAIToxGKaDgNfZjTx1bpYD7Fn4B/be5Ya9ODRxmjbqQzDYcDs7Ts5VVQWgwuCm1m5DXrenZtyDG7iL8C4kQOEogCgPyrvnAYW4bTgB6rOrPp/wI+inLnoNP0I1e8XiRB4zbhzzmBEe32PGL3qBDPGUu5u107EzeQYd+inYOv4puwk/u1ZT6W9IEbSEzNGFhyo9jZTJx00mX60Bset5Fc0CsJIjm/aZ+v8b+/I9+mX1EiF5j+4ezC/eOH4Pxqveg/FO8h7Mqx6V7epH1eL33vjvaG17xJmKJ37gbxxzpvILN053phKilcnxjHGPeewLrTHun4VzCoGH7tWVddQjZV/pu9cn3hvpSnVpT/zT9q+TyfUyfvovvcasNPxzzf+b+8bEdSpV06VqALsIJVK87/+/ZFwsXIGt03bdOqkwoeooqX9dnxheL7tG8+Ng5D2PY2NRwfedTHuR78RNtq0lW7Jr9TYdheu+ZWQEPB2BE1lMfxQE65Hlvtn3m07L4phf0qO+uon8qL9mjvJJCqvLLjkxutYNkfwchccL7Njwd1lPNLkaGBjVCYViqRr1NCaARJ7kwRDoy6DVxDk5Sq3IWGWIprEVIzsHfEwhf5iA5cn+QpgPLgmfFW0K+aF6Fu0xPQsUVrS4fSjGrsfJy2TNCFUROSz9n1aPXD+cROopJeI/Cxt3mdetB5trHWNlzf4OTdX7sqNumYoo+3ukqcxuL/bC5g7uJXxOCbDpSX+Mi3hFneoVlXFjOsHftzv6wfvO+eqZZ+JieimPnX4JQ0S3zoVYQnWo6rrMYJDWxRzAkWJTGwCpawM11rO3vkm06Mub++aAP29SncspTx2vBBdSntMOuJ47bqWm3rPX0r7XNZ+7tU71O4ZUx976iCmyoonaPLKeJ8CESI8jcTkZyBHh3Dwk/wJRyAnNPdFQYQ8GZkRr4qGgLy7Wd67pxMsewGDoKMQbjCRRFd7RycE7qsK7PgLvOkUT8I5Ews3wrhgEaIzAu1mBd2LhnUzAu4GbGqPwjirwjgDvxlCrmQrviOEdgaGaAu8Gw7vOU1bcmKdqcZACpwudfUEh1//COdgHKKqrmZfsi0gyRgV1o7FXBMrgogDR6vkgpsG+8RNDXTY5BR41tcx/QJlqIuKYu4ReUaasqcA6zjYkKYRS5eCNvCpKfHYbMsnIa9J7VD/SxD5wjn4mCGRyqWKk9kzi+3yYXX6jCVYvkv+zepF/71ekcE5n3WlyfOg1UxT8HAScDmHsdAjjSR1Cly6poJePsBJGF8gS9YOj+EBPIgLuzIf1VTZcIk63xk1ElAfpcAgBMMGslI6pZg5FCAV9QRIyhmwSF4ukCo/QHFSQP6EvGHDjflOxQtxHIjuH+EnBqL5g5GSR3+H503xh9L08NIdZlpXGSyLu81MEARvp+6/dOOEv4+vV8+DvPSbPg3BRffKeB52Fi2tCz9wwc1xY6IiJKncqTyZmgSoJ6vMANZntGa9qwwHhr4ajwyGTWWsvK7QSw+gEDk6OThmwD2yp48C9e13It7lXXhHbOfiAUyXSFhpDnjf96HEvaka4Lq7m9Qjhz1fCn3Y2P6WUVEu8vVIiSN1hvGs2TRLu4ZbKF+8Y+2LgvtAk+eLOyhfvH/viLveFJskXG/KFcLEygfrSlJKm5tY44GB6NApVrKpGi45c9FLmBIukT8R/LPVumMlfV7P62p682fKM6SJcMkPwoAZbcqAARw0oXW2YhuL7JHlpnvXFLDOKkYblc9TBgM0jRnqQL6hZ1KYeeC6q8xU0vlhGfJeWEZWgQuSXk6P+l26WIGLv12DIwU9rUPBVLXatCYlyHqQw2/l9ifjvsp4FAgyOxWppCIbaxckCJFhbxOR9vkIJdSk7sCbWK1f5b+smdsa2iaGvgPCcbpadaHuecyVdVMKd3UOreu3UJ2bspNG4lYptIGxQi02wBCbDKHYm1VA6xbTCX8ptrhztc8cKFOCznOSZ5XmqLQEPYJ/FDuL0h7/gFfAZ0LKXp+yz2ImKzFd7vsk+i1O48uLUMuFX7bM4DQkREvbytaIvX2yfxS4uiKshSbti5fnvOfY0+yxOd2nfd3Vwzhu2rD/VPoszNK04k87kkBatDJ99FmfZzyniEB4SbH30Xe/5wNv+Ln+6fRZnI/YTew598K//5c6n2Wdxjn4uHX3nt91+8LmvevMH7bN4AqCMlMOLv71l4P3L0+2z2G1T/r//9OGlAx/+zx+yz+KJNuXZ34F/P3GxfRZP0hTA6MnEPao0WJt87Sd/979e+EefeZp9FudKQZ+7/cw3fPYz//WD9lk8xVbxyq+86zv/cutvPN0+i/Nsyief/2Fu6Bkfss/ifJvykw9ms7Oz119sn8Uem3KpNPTXPmSfxQWuwRHxeHsGge2zOPPhb2Uk/5RXXPjwtxVPpe30VIzEqTxYv8Pl+SabfRZPNdkf/rb8IoroyYTPIv4s0s8q6aeSoqZUHREQkQTtiBTJqEQpKhGILLrklAu60HTkIEYFcgNPZphpt3maIaTKgKE1+diAEYaHzGCQAT0ZQJMBK1WAmBNRCbKd1b6TgKwKgIhyBgEyncmZztRMlfRtIM8gil2QqTMDqqhce2I+VMl07iuNznkjnxciLt4CigMLLVtfImfr2Gqrljh22ImmL9BYfAHTlk/jggtq4SaD2tqkp4HSnGqsDhbbuac8dheRBC6ibZJw2CRso0gTIphz1MWWtmob+JtIaFogq42Qc24CF72tEv0lGx3RRRg8E40lAdFc36kmmlaxj1ylrfCEudV5EGgyY9wP+UgBnQzBt+KUt3g6CLGQ+YuRcFa+Fw/K+zSvrnOE6D+D4feMfh3erC6mZxzI58vK827ZvHyl7EC+1fZTF4wmKLt1e2XXGG4Tza8JFLDW9IkfgPMiMucxQznhN3W5G8tK8DQY8n5J4fMJQFGI+S/GpFXyUYYPy5LVBUI/gleIrTSWmJlE4iEvy1kZz0UmFxxOdMcSOTIBXhR9rM1taa1PBXBiEYBfNICnJi9lkitWB/gwcyu7mx711mh5jesXQ7espw8lAbWC6YOjQEiXlVwUvhPikJonxgj7hvkUZ1OoJ74U5gO5clztRNQzkP4MeroyoBkWyoxmETlLDUQ6tqTCj+yt8Dzc7CWrwLWreBpPDt1vNWkGGw1jXrJH88LVFCsaU3ATtvLo8kP2VIn4GVlQFFBPzjpF7RvmM4rlCrq0YO5IMmbpDVX4QBM3Ozy/8KzlZ3IijA9LIbSlHwkGFcLw5Is83Fto5QB1FbVk2HgGrlLsfJPocJ0pvPwiGCBkhAzDeCmJKnhUECfFtE0iFRFtElgVRVI6NY+ELCSA/BYAeUtf2Hj1MNemLuKYm7OuhrSfXdCVsiuF6cqidmULWmmYuS4B/FQIyG2LYaNd8KQwdH5x9F0JSLWdro0F2lOYNi6ABVwgHWFBXNCEtWKJGvqm55SiwQIzoZaTlt3s7A3YiRh1Qt6c2F3sZXL9gYxWk4+GF7glo/s0vXDmUWAcYOaB9X6pCi+qZ2Huz6R/G0YRvCbgAn3VJGGkdWmBWhM8KpYei3V/f8zTS3DRFJ60KZM5IjzJPDPzrGwHRXILI5tqlD/B5RORAYciDQ5lU8hAhHmHUGS4Kc3g0YGFCVjpqZkbR9aIbdtsG1oSSw24LBaDEbnQ6wa1OAaP/bgtrBZYpZ6wLJZSFs+l9hhxBnCb0d2mHjNG+Uw/cW1r0wylRrJ8ZdHucbkohgPpaNuctA8tkW5kdxQdFRAkhKPf7FdFWDZ7pJjb9/03X7z2V0/4LZLrUrNcZmdAs4MhzdEc34Tv+DIGD3gyLADNyCWpjh6adko5HUSSUkYZQ50j6wCKuuFJR293BLXa1U8fDnC5ELa2RJQaixZBRmn2UaufB6TwVCzCaIVLiYFVzPLNDt2Zgkxf7AdT72v6ist6zajFr4E1kKNhEXNYAzl61AX72dmv61U0MUiZx9XLGxHFg/SnA1be0N3wx8Z2w0fdbliTZDd8d2X//OmxL465LzRJrUnJF30pjmpmSmTvEFEfFnCPPHV3hGtFEvWgR/wWmLcH8FY1/RasC7LiXo4bz16B/FhBpCIc/GplRV1UGmVwnAQFV8rEl6zqIFqvSAkQOTF0B+bu+ONV/GQHCh/w9eHQD3MeC+f1ciJIcrOPh/g3btQb6QIG8k0XXZsQkDSbt2wilNzJ56pQgZoki8rcxid4+ouNBPqt/CfXGyP+m3Thgr7hKoMO0OfHBuheN0CaJAN0f2VIDzuLWw+YHMewUOKj8/yjPyZR03Vpg2OaSgjfWwk/oGE04KNlMDj0FgSd5dYPXcee8yVOv7qlEr5TwxBXfgwlaLuPaiyCh11wQ4J3m4i7wfZpj9E1mYF6x+OQhyAmkdqWwwvwoZxFMFuu1vMuCF6uyTpULag+v5QCY6Dx6sr9IIOvnvIiaikmdkha1Jkav7Avw0CRQZAAIy1RuNARUKAXJK5AUG9QfFfVmF+WNyTl00jJEMRNEas4/wBiE9ES1AHUrQg1NA2XolWv9m7Vq+WjsjzB43IuVmejv4b3veVcRETDzUV4uXf9TdZlLoGBqc7FBPkFYHkd1OkqUQ+NR6yO1ctbJk3jlSIh/wy/9j5MTOeeEjMyMgL5ppuVGY+TzE6Zk6jjppFZddBXaWdTBgP6qOj3KFBgZN2jpjEsL8BVMAEAu7PfFNLZ0va3y8k6g3bX0e6WqoMoXFIMt3DkSmSSzYiMu9WBLonw7kZfF7jmARKl8BkQHPxq7yy9MIvjN78Kfl9k0O4oYjz3FI0jRWd0NZQEYpvjQ7dWAQ1g0yPD7ZAMr8lwMBhgzRvKQRqulKAph3wSrokwkFwXeqp0yVzS8CuqzGqlQ4F+6YSh9TUP92ay39LbRQJk/HQH5Ls7ljL3Nu4ofULXNtwxo7seTDjB2rjDXd0cDCtXhgd8B9ULJnWC9HCkq3p3q24ar+Ye8WNBr+5keYxHF7Z+qKZae6EQigUJrWK26em3CG+hL12DvrRaBBb7F+hi1W74Z/xQKPbo8XdynCsJDRja4nLx7GLfhZPYBEvhJfyIL6xdbLz8V612qi54Wr1jFJR3jOLxq/SxvUofi1F4SoGNqQgvp94xCuRsa8RcZ7A+FLEF4HQuP5L+xQydPSAuOCRO1IRJomBPAPYFzZwhs54l75YgVOnPKkvYhZDaD1vVD1qom+MyxkSA+PfRa9mSuoPL9E2JgHmWzYZbkzyBsygt1jXC7B6xJywrD1FtE+vSEJo3qI4W2oWP3zy5/lcn5BjYwF02cJQDWNpu5icWqNvlyZ/4+rxX04N78KwudsdsCffbwIP6KWZfHZbV7PpFNW2TtUdGcfYHBhD9g6/2nUc73jYjQpt9Lh/ZkvY7T8U2s3tv8ftq5b3N71nlfYbfQ/cunHRktUj1bKF/kPI5d4aKZMZbMGWcAqcLyF/MUwOOUwtfjNlRk1KcP38Crdc+6XcBmQwtvLXLPEBuOTHFY3++oGcYAc0o5W3jsah0eEmKlg1/l5qyS/dpGbt2WsJvkWCbukW22YsSsWJElz3q2e0qTGFIvhVCahkNsUdgpR+LeLCYBY8lWsZjmbbgsYW6EMGwKAF0kOZpDn+shzwLtU2PAnXPrpwGytL+LGp/AmlyYHR4uJXKP4BYiv2V+Mqe2gQKMIU1hVwK2WVmEY9Fa41kCfN7yQhiDqrdRx68K+DAZw5Dlc+RDpaV13XKeyudiXsr2JSVyTPTkttlcntacqtMbk1LTsvkdCKZmmVYcSf7PTWLW+cJ79SOPuDJAWs4csDquQNWVXNTtiAgb0MEHUbTO4LEAwAd2Stii2uoZYAbT4Ga7gg3jpg8C2xgpV49qy3db2OkqG5Pa3m9ck6PPXtA6wsbmv02OjNIrxW7BdIcfOQx2niCNp6e7Fb7MU7bbURSoeDuaDgwBVQtoJXXr2QBSF/ieVMX0Boocsjok5H3YtcmsUfutNx1ldT1smvvbcLXG39Evi6SHx9fJK/xwumH0xgPPXRlSskBhMnXJ07lDxD/CFwPFIHVRtDjep5xob5nvyP1xei8gXf65abXKzUgz1Xl8j2chMn3XDXhvFpAMprXRcNW7uPCRmf/B8hX83UHvwLF+DwFqpirfXrjr2irZ9oWHB8XHWznsv35rPqQiKjDxWHCtamzH4rY8xSCDkAu+9XaZSJ/DlVJfQmM9rJqqne5WuqK0JzFbroJXaFIK+yJip+7ZFis7i8yriDj4dlK/gHUiKML6UOxHV3kyaV6EXViMdvaAciC8MJ0Ey8g76BrsXDI2XOhJbidupetlIKjTJ6ZkEBuaWwN8W2jDq3QKhrIzx6e2e8aOs4wUQ94ddpyQFqKZJQ2R1spQb3UgdCX2+5R9gSvhnTeD4CBbvdDrdfXaj1U2zIEC8BG0bNl0TRZ9PzmRV/rinbUEuUK8NsEplYGBUOSKUw4BkD296u2yqKaL/IEjJkANM4zqXBltAsreKxQhnoy4wCqrqOR6dgCdHXVHknQqIQaQJUGNfmbvGmOm6HDo1/7OqSjWOs/MqzNJrC2DayNqA1szSrY2v4aY6v/74utxx4dtu7yp2Jr+JixFUVPxdbw6xFbw82xVUnvpZ73SieCB0323GwsItQcEh72JlpgVMjR7dDJ56eWBEhNLSk8bkm/HXj+5NVgBejNgex69aLALUF126sZDlUz3DSSAXqXMCOhBmhb1rQEYt8zNfbOqbG3VGKPugtdN3qVig95ky17eSX92snkA5XkqyeTr6gkXzWZ/GznN8FF7qp8c9bkN6uVZJpMblWSs8nkWiU5HAWzE2nzre3Aqta5rUn2SXXTQ7UXtD3DV+hRRuRUcOXQorSUwcq9zqZyYGwq80eqlyqs0nubEU6EwKyNWD+KLdMkfqlLd6wqga5ehVdnUcO8ASVnZzKa6m1NyRuV6CY5vo8g+P7RT516f3rO7NPZbh8fuOwx2qqNqjEPEHdYAy3a2R9bqxPYiWK6NKrW1GaqDtzU9uKINbV8piJZ0JMQzua0rItMh6Yjs30j+8mDsjnVq2uwB4daE8Vw7KeN45l3Apb2gtusFCHqE3OVbosfTl9OEOe1QAYigIfOsOArTylWawZwyMR1wR4x58b2gWa1nj8Rxjpv2uV0HiRp3lSriwHyISKpnPyUFlOPiadjZOlvWN88dSBpLGVgdspyeqeavhEp7V7htlfthzI0aO+QWmSHI9UedKiuX0P340+Rgo0VtsoD/qjDOv7VsUqpWRmrJvH7yFiZ4NGLBhg3acqYMAfrdV1ZX3FzdVkPq0Avn69KeeTUkYUssKcALJaz+IDqbl90rCKZ0xG3RvkPfv//V3/3M9aHfEaIfQUl+Szu7eoA9ev5rDn+6lu7vvAuU1fcvITmNyDV0lWmbrWrm04IKBiIYgWumJUNsS59ZiCNpfnsf+sarod/LfxkBapCKJE7BVTnVUA3WHk9RVbMOulxTTOIM873wJ6hwSIu989QrmpRJ3hwVmRsYXWpASMuKbtCCbz+xHrTcaQzWkAx2r1YrwTH2Zevl/fASTXRXV9tOhegDMHYkA5VP5SPbr4LF1L0fOC4w5SnY0XQjAtjbo+MYVBxtAgToc0Jwey+vYynrsFAyibsiaJpgI+zpDTD+JFef3rLN/rPCUvtWmKyJXpFVJptKep5gv0923jbe40V41UIpMDD9UBPExyQmtWdfqqXN5sMD5zjYov8nLYH12/Bmlx6QUW+BNsUqTpPE6feMfGjo2IG6NpmCHoSnDXfQHKiJSE4L5B7eEG1TfJFNMg0SSgbQpeD6cCU9bSmJeaZcUbwUADPzNQVjlkvHaTZXwmNWDSdQhlbxAD4pdz+RdhZyS61cc/juBQKSs9FmvJdM1oFa6p2qUP8WCkXRHPRnGv08Xdpz3p/1T5qp7P3vGYsL+ZsjwO9ygezlJmMXTipC4+qvGxFXvZKuAvgdmkFjxXyIR/jlpa+b8GobkF5WJabcgiC0Cr0haE01lSCZeCTb1WrwtvwUIUaCvZO9RaYsxbFXQHVCYGBDRy2gYM28IBvAvfawDEbOOrTKhHAWKzlO7iunTyiW+VOGV76vmiX7cxPoWa+k3bQKf26KCVt4xAQSbV+TqXtZIKn9T3o3eAzxRxOKCBqhFCSYasKYTmd5pSABNmQD9NK8uV0aiW5CwUbBi6WSoCZKSpaAscNzbI5zc2ao4aZ4VN4XvTFihO3Z+5EbUE7uNCmtoWhhOxbn2N2KTtpK7YjrGdZtm7nCVr3NQVWquhOPMI7Df6bwW5qrXlXS+XvvLzHbdlhIUVdVAHIrVVVs3byu2nl3FhSD/WfwmX3qM2ToWUAdQoARf3WpRwmbFOImohaZGqFOb6BO4WVu3S3MZnZBSfLgF8Hj1OozjDb8PLTNeDnZwR7FdFKmNAZCiIET9eggSrtogVaNhCtgKuJDXPTaOb0Z6Q0hVazWKkOmgLODdxoxTx5TxNYuRrxUuTVgdN8p1KuOTdrBa0oecPQaTWCCmVd+FbIzikS62LGy+lxAOA7RZ6n0LI8lyFDVwIluLHIwcDSqlr/EDc+AO21FrU47uZABA83BbodBN0yaaFyfKLJ5Kh4alajRqobzPxM/TA/i7NhfSrO5lzTVyhwlHlGZ5UL1Tl0JvHjCW6hWnUL1ZZNFiogExYq8nOSxWr2OItVgzwlgZ3JxWoGadhMmMVqttLNmXKxmiUyi9WMW6yIZp+LNB3Nc4jKxeoJ44tVRqksQIS/4y9WLu+0xWoLrWpGXZ3yvFy0+ECQMQk4p6tX7iImlzACReP2jyxhM5NL2NLIEnbu6BK2S5ewVVnCiq/pErZEBYC7+H/5EvaNJWzRLWGL/y5LWKFLWIElrJAlDJMfS9jMRrGbdk8sYedQB/B7Ah6VJewbS5ijP24tm0w66UWNsKgRGWHHLAcDBIVc503dAB9337T5kuTWohldizoUkaxMsa5M/8dvoU7RLRQ/VugcfgBh8Tjl8dhQ7eTAzqkbqhW5cJBTz65RXUTYqzan6BpGOSIm16geP4AHeJzyjU3X12LF+saK9Y1N1zl47KQn4LHjP+T6tVeqwQKFRhmStdO8avU2TTFIX6qkbEeZu5LTETate9rqthNP0AB57jj+Fg5Bo3mZHolCzzj2HT/3c671kr6E4XyqNNJc4xdVvct9eYepnERPXgPQRjVTjRBs24tSnlq9D8SKdGLUj0PiZBxN3FMpqwhQGpE8usZYIVvbUOGmPUNT7RfR7FWVuSI+UtTHVX9hStofDGABqM4XYXw5gkJZXqkMnMe8FkDS6/Hf08tom7OXx+4ujt/yXFZcrXAqRLCUM5pRqq7Y6DnC9SMyHvW8iO4Qw/MFxjd1CewAQP6jESAjjgrplmi6pVWIKOwMRIKThkjtpCFS+9pAxJ1bTgIn3QnRwlfFdeA9yFLA946eoX3RmrhOv5VVq939M8E7tbaXewZb9XoYDvoDq4xu9QL1WLx6EH59EPjwdV0xMBpqA/UgL1JNr7NUk3oXRf2vboeCWutlekiBpqiHH49tpQTwHe44yhhG2z244ynZptA4pMj+XM5n6zJK9St7yEueKL9ZHZcQ2qo+sTW/1yBrolZWE7RKTewHKC6T4vb3B8GLKMx+Emcp0mjMPH6oSVapVu3U+5zrF4xtn0iwSJVWffQBYCo80jAgGeulQRzW8GtRv7JglAgIzeYAx5oP9FBLPylr1QN9bUsmTc3ejZrRtdKgc5z+eBjqEHhWlflYUN7tgZqiA2hEzv7URKCWfVB9UPQPFk49uA714IK1g7knYu41qpx6q5EucxuPs8mCIxStv8tpQwfQhubbMJsoUMulGgRusYE7OYBjsGspgHb0jZ7ax37QPO/W5OAonlXt6A1bwDEbuNd88gCeB512NIak1Fy30+wKnOgTMoZqhbsOTUV0hcTJgvjrIl+J+Qq/iTKBOJ2AVAaFBv1OecMm49DHgtLN191BZRxAhzATeB4UNWdXCrC6O1jTOkPFcZBsikDEMHxVv7nI5vRZnZ5rwAjg/OAMFiI42cqu2+48Lh0MnM6B53QOPKtzUFUtSMBfqR9GSq1X6hT0IBV9HV1nG1Vnr2LZM5Z1PMZpsZo+9NV+INTRjTM40ettM5C5bmc5eQY7CmpJW9SlWpGqmaW0FKC21iSDJttYdGRGbdG2JTlPcJb4gC/7xw4H79VghsbVoMwsRGFOtyrz0sx8QQnXogJmiWKZjXiIu/GWhDCgiYRaoAtqvJ7fU90dUbk/Ql/4fY74rzRhk+L+cqombKy/9zlmzFQR3VwXj6dMlxVjDQDP2pT0Xr5KvPWCuhbKTGCxpssDJUzyktoPo6a1WFOneikc4EaNcZEpLfOXVv130dzYQZP1VjlXhWeWb51msWYbbaVVKMpvp+1TLNbQdIs1OSwIFFMs1uxAwvYpFmt2Gssh26dYrDnFpU1YrDlV04rTsCtB0ZMWa3bZz8UYBh4SnLRYczpiJyzWnHE8izVnbmqx5qxNLdacvanFmnOc7ZInEPfINVibPGmxZvd0izVP3NRizZM2tVjz5E0t1py7qcWap7gGn0bFFIs157EFlRWYXzmfLatspx5tx0gUdN50izV7kF0Nrmzn7j+B8Nlp/Nlp+lklvSBFTVTNWQmQErRbpR0aaVCKE08pQxZdttJWDnEmixyKP3jIf6fznxt4MsNMZ5mnGUKqDBhas9UVov/tnmLehgygyYCVKkDkDlEJMqr2fVVAVgXAaVzdNkKm8zjTeZqpkr4iS8GCmC2kBWaNxy3WGJqaN5Wg5jD0Vxdn8QugOAmltEUs1qSjlmlqmr5AY/F17LUvgBINZXmNOur3ly4Q6bDQmHv9ogd7NAVjswS204okPGASVug0TTgtNbyt1rRFmqFbzJ42zrydR76Q7IImSz7PFKmB09xtt1Q4PlsqMaqZyz6IbxFHFbRSieoi6jTgbhm1E1ErVIyJ4LZA+LKF5qy+b9uYv0mFX1WVLRZTXliuFE9Fwln5Eh4k9kcu4t5cBKM3GT2VLjqQ+1JdvigNyZelifkW6UHewTqDxcAZudFVaElMx2j/8gVqEz8usJYpcrhRq6mUAGJXWTwugPlSiLBieHAGbHm+dpwga2xNwUcZQ24LjSVmJpFogcpylsdzkcm1m4tYHEvkSNxCl0s1NZqV1jZJPaEBvIkBL3Vh5KaumCx9mYelCTFyk61x5ZRaCzc1I5xqVi3cbDcWbmrEIcHgJgaxadzDGAs3XVi4wcPH+KaIugjpF9GFyry1yDOGFhp6xSkpUjnrLRW8+gdLNq7h7Kza+UcN9SWvjFb/R2FpVVOMqdXYprzOGU3lb9VgKuBoFVP/NvCdJhXEGnWrzqyaYzB8oc7l1R66Xj36GFiZtIxoSez+futFRaIbsQYl1GCe5z53wRoprQOcBPYIhqrhd6gJds+DaN1jhIfzKrlf/f37cR/KcaItNZcJTtBXnUyPEmleIUz2oLy+9KEBuH+jUpp9Rm9kp1RHJZt/4I98QK0j4sW7/yrcjmuIImJ2h0Cu2ng0PX1O6Rwob0BTTxQz87Tqd9vLfZkzvsOskBJuijEnA9CaugKbggu31mBgAySoASSqOwmAt1G0KuaGbfgu9oTcGg4pvHUod483Kh6SAxYT/A9WXcewYTN0Fya/6sGr+X3dX/APhXKBLDIWWThBbIfzA22z9mHUqfGweueeatmtsku9LrRmJ5Qn56+zt4jd5IBDRyTkVUQRLXOhDmwqmqRDFQ0BEYTi4RGpVnyCc3I8HFSaoXxqVTTxQ5GXuItpbr+DLeV3beahQG9mrz8UAAy8//t2juDH8/RxuRVZlMrZgQX6Xux7cJsZh0Kq2glLLviuzCIFqwLtpT2UHZfb14vhKkKkBHvkviYELQ2pJ2/q7kKMEGdrunoWbjMpsqqmuWYP5XCuJQ/ULQlKNOdfCZIxyi2q25Mjbkybm9zmlSVRkWNCnAxVTD0Hg82AUim2aJInB2E1dFMOwjySuOc9F31uiF5r9qegC3pZ0mNAp5Tk3F8FWVMJMHaPdv/jZKfoHn8ug4SgS9GC76+q6GZFU5JUSRc51UcmgwI7M42gpmjqAt5wIqT+GCjiRRJ3WF9cNNVkUTP7e7TZNBjfoslahJ5zJmSrqU3RBa6giECoMsKg1eWtxZtCH1ahJu1BkbH7HJOanapjnIxjSQ6HcM0WmpFoAPyyh/5r9U7ptXzAvlH6Nawm8wg1RkxaN5xJ68akSWuXLqkyWGgMlij7n7YoEchVm6Gm+UPieKB+mOJatGtUJbNOEI+jfKeDLcl/g2SotmefQ4hZUfgER/Nh0PpoDbgXQfSzZzPjWMEuigjPrnkmuJ4vM6GxJrdo+Zl9VkqnBoDe6O8RsdW5yMYVah6M7qi1bs79cuS+Vpdvnv2+Ilziel3tMgCgn1aNZjujTX4t/dezWnWV3F1bZ8QAcjRH1ZqDXG4zv8YXveZAP4XHQLZ9JFfmY5WZ6JhQDLTLG9UrIHXcCjGj2FIpzzQ1aM/oirtP2+gdfyjH+W2gGPvgEjHaa/QcfwYtu1HDHbGE23np/jxD7Kt9PbJH+AYNz2luPbS3pZAymW0c4DOjKhfYGvkyWmTapB40LBGrc+aW2H8suswvGxoWQ57KNGwFadzOtiFey6ZXKGPF0C6PlmkJtEvj7CE+XwZ8LtK4EmxDpIq1PHZzA64EhTYu4a9y+K491E7jvH4sN5YRJQfukzmaNRljsbvJBRQ92X7o66v11ZkSiAHimJbAxXJL7ZF8HTuMFRRrUQBRlSN5IUddhY8cyXt6JO9Vj+SDaXIkHMm/BrwIQoMydLgMHSxDD9xoQ/eWoWNliIfcHs3na2JZckf1aH5H35d1agfOdPMdVJjT5lPsaXPdnTbX3dG88bpl0IjqzhjiKXbz0Bs5blbco7oTevVGzptjNTmYybZATQ6iLTicr5cNqm/WINw38oAt2LtAXnniBs2fsC1q9rGubWE4IXt5OL9DD+cLTrCt23GC1n2NwZWaKUA5jlXNrDBDXjc157GWrFZuT8H228JLZYqA38g5/A5+N02dH0s6BW3YyaWfQp08oRkDrp3lEX3dHtFjC4hpj9V+ZQPS2Ykj+oy6gGKAQ/gb/Px0Dd0o5/GKaw4meiCPLqG7dXMq74BLu2iRthjAjqg8ZAxPdyxvCpVCimRk9BR8bghHWwCqf5oCzNWKt8ISDdc+zX0q9TT/Zs0RI3YG2bQ2QQ1XpRavREpLdpGOVI2Xak/dt+ApBtoTS8FSHhI12KnEzIOiNBaZiqK0J4rSnihKe2OK0qnwykOxseXIfNusV01OVkVpPFVRGoWrorRCXdcwt551yIOq9LKop3V4NFRVmh9PGF3H8FitLGHzpkBdzoBeI8vZ7HGWs6ZdzrLJ5axrlrNmqSnt+tktl7PZcjnrVpczpyldp3O0CrFF8gTiR1JZ15apPX1dkz67Jc1lxJLGyEGnVHKv0pxmtAta3jOLG39a1T1MqOciKmtbgkdil7jZkSWuO7nErYwsceeOLnG7dIlbPeES98Cry6WrDB0rQ0c1dFJL4crXcInjdpwczeaGfGOJ+xqCK9UpYZc4t7pppXmshf57rG6zurp1N1OZzgDAJ+Cxs1zadJF7uVvitPluiXPUX5c47eejWOJumLbEudFzlU+ubqhw6uqGpj321c1UOUmndrrVb1r6aPkT2mWj653ToTYGqoWQu0vEx9l06Wo1fcfllqlMl6lzKNDV6v+WHRjUqGPVn06M/vTjsyPbyYGdU3dkp9gFjGKjbzi2NaPExStCTlvHVIn6a7pj+8aO7Rs7tm/s2M7BA9rUXXTiG/s31a9GbRgILEOuWrxZHKpqVI/v61zGnRMZJ/d6qH0z7erj7fsQ3Jwzv6EkUWXoWBli4GJ5kt1isdBPniuUaX7sKlLAOJsIKOrwGFJhRhSoCT/U80GMRxu+BdTzAQ77KqDlgJqAQSwtYEZDVRO7HJna87SAqR3QPCi71liWaJweqCETa0ZmwfSe0gtQjGkWz4dkrJUQ6XILpLQriwQqo21EaJGuldqHXE9T5PyAIloAP8Dvs9c7jxdWOTdNf93z/GvVBFD2+RtVVdS3RltU+yMY1f7wxaU69FUh7D32z9cfqgGA2d/ia/LcOSZU6dX3r8AnFONfG3mk/nGq37pZ7UyEqLvVPNbKArRC1O+GU0on9tvhVZWPnesDz/qe6VP/5288KNb133i9yP01PvtHPQWoOKj/IXg2mPCjYJkhBW5gXVHiqDtiZLBJCWlceJmJi/j1QB+uy3HsfTW/rRn/k+qivup+siXK3Z/6mU/+DJ9w+2L40nupetMmPoftfxIpHMmPT9bYVKW6bMw+LhaKxWtNcLJ1hqbORNT2K4qXrBTq9V/6Ii5A/RXIdxEFpa9MqUb9ySbnm6+gNi4aks6kpydl4xHKA2nZ76ClK3oiGok6J9JQl9UkcG4mOmn2W+r38rUeWzYNrp0wL+rLCbFoDKiTbcauit64qoxTjHUMp2rW336U3QIuDzwfzpQzqPYj0B0eQcecAnk64oY/SJ/kea8i73T15C8WegRu0nmf3yy0vNK1a/o6z7qV98wxzeXGJjFTCSAxExUPswMrB8MSifEGReuifi6Ko1YRX7opJ4OB9EOnRHRlEcDCa0jwe74GXOoVobFT6Ov33I30l0vn7aqZbrT4A/MORBHzdp69ggL/ilxuBPwwxAWubjwdPEw8Y1JNHzxcKFv9wmgFKCnWI2vSyycSDTwJTfUpReL6JpSvBOSuVGThgtMbvREze85fhfEbGRojsDr9rBXDndIAvIhCrzxCHKQBQRM8uK2KqpgXLSyRddaaAWr0ve8D1AKnZRGmN8chHJtCi9oRmtgkx9CL2dXfk73VqMt/+nf1roVa+A6pvonae9cY8N5FdRSRqYGwnXiI6jhZ1YhI7NTCODY1oJEBTZaoz7rjV1wD1WlrLI5C5IoYkggZj7CRO6eO1J63qnpryXUtexU/XSCMrSR7K2Ah0blmyeWmhdyCWJUQcQhd4JH1hGGt2fNTqqNKuTurZ/VUpBge9AJo4HSjddODpWsXNbLbUWcRETIXTYqg8YbtorZCCsqhPMCvXIXUk/04vlkpl9eG6B25PhUR6ih3XxRpx6Z1JUVQbfeXyVmZ3FIgA9esZgXwpp69TW1DoN665JCV3QyJRiVyN6T8hPOUX4X4SpHfgsqHgVOFeRFqJ+qqRP5cHTHQAYCaGmgP4GP86wN5GoADPF5FtlBugtSOoMxEDLzcAstweQyPFsxq445UpoBEsysTUpzVcKswNWO3Vj6byZvOdN9eHVASKGE9AnclcBTuT8miYNHPd8TyF8IIdB4n4ZGd8Ifjcsabe0L+ZVVZSaixE16QwYgAa/sALN6SWzGlo1tz1od7pQwe7AHa6wmGGVFdo0Lu/DiL2Jx8+F9M8nBYOO/ulOz7L//w4Ee2v/gnxNNk+XJlb72IEDN0jiruGHDc0O1gJPnIHUPHahoEDfqH4jUYkfvoF7nO7Mt6XYLPL2LRwSC/6uGie/Y+VoFvlFa7n7d33ShVhc6FIRcIBa+GOgQDyVfPXAIiyxOD0WxTW9YUCJ+kswPXOi5EVgH2x/RFD3cCWsC3liKuA361PDE2n6CjlODiylhJTATQCiwx66inwQnAW71j0N+FTOKeJR4zehcwVigCYoGF3U7GGlUVe+GtQzyuOCL4qAwNhBbWSXUfdB8uuV+1hrUeLltywdZBHpZDo35YcmEZyIPyGd8L9Epr6L5VMwsgCwvUEnv6S5VV6mhtxBqsuxXTrpUKnD55ot6k+pty6tT/w9eDQ0W80d70mAJp0v1IUv1NWRjLMsvvz13T7Eg1TvN9iVZdT3SyNELqVVRQPuEFqqI3bYn1lQ+HFmSgTJxdOBky0oYXfPzjfQqy1wjdDiksI6/qFQ6k5IJX9VhWGGWvxQeydkf9D934NGh8huRfZV3sRRwdv2wNg1bmtTk9yWloU4i2KfNZWbDT++tBXSgJ1TYK6HlWbVlasSZGlBu5O/rB+8756plnXlm99OSaHlSaLsTF3dEEXxzyqFb6ScE67psOcZPUlkUueFWPHeu4tlC8rhAuYpvl6FD9B4Jt5XL2PVn+/QMuh1LgND25njtupfpQq5HSvhc57nDUKYQVRkoYe02RQ9fOOl8ljVJAH4BQ1UruCEeo8wCCU/tqUTkvq0JQvMLbBKKPPyQhx2JIJg6SyQgk0wok6xaS9QlIAnnrJ4BkwmR/BJINhiXgx7RwCvwSBz/AjbycyRl2a02y4INmWMoJXqqbQyg5gxSNQhV3Jpi1pxrTvG/A1cAVGqUC2cLvgfLyOwcEgt5lOvHBzQrXsOH5nmPKqUK91G2TtwGyVIGqES2EjryV1OneD2HJy3RvkZQXOFsSWtXLvyCvrxOC5FNQbg8dLfTJr9JA3/XNrwzTWx8K0us22dd4fRie5wd7xSrCHvxg9K/uMx70rik8bY1vs1zPWTyXxetdg4aLx8C3ixFa3dpATPB6NLpKI38UkPOnQU4dMCkAFRgOBAvlZdZMCs/eYKhzABbd9PHe13BzKSxfruoZlAkdzITgb4BRqgzOHcP0nJoRSB2SNQU7BukT+af7sun2n6GPPgYpPY+hiA+yNwuW+tk/qclqZTAFnsYRIvq1BiVMXIH/r56vG/P/jwmdBJqMWbr9fymyAMM6KSJYV7+AxMns7gJpjUo20IrGmqw9LK/4Z9RcSzu1/hCypuyrutzOcWHZxwTISfY2Af2f+l40KWOSbvyLuylRk5apwEm6MqLFGzgt3mBSi9elSyomzUkXj1511rJ/RVa7p69lD+krlMAD2U/0VUs/kC0n9nMR9nMElkroVqCZZdsP3V11eqlX5REXiHotHiE2LuKfCqD08B08B8iNd27W+9EsitQ5GbLnAT91f+L0an2H2f8Ng4smSAN87UMgdZIv8/5h6Yzpjico5l6Fu8GuqrqNAS4I4qXpBVx8v2vQwe+/3W72fd3s+5gVX1UsdOKMALKMvdgvwa0khuIryALyJp3WgZDMvrJaFseQkkgjkvSFBm0JvcEDHwk0Q4UnGCGw1NIHRHA8hwEuaaLswAW2ytIhm7RttJ70m7ml/cz0kZtUkeNpTSgAIWCP7o0ViSio7PzC9M+CsHFdLKyYk5t4pV0CMNNSlMKW3w5+zopRTKsCRDEKqntKyaD3VUK9dC3cOuRnvC/4R2zT5LxKN3RwaZJb7e+GZDozOHwjE8a8SRy85Q0IGsF5i+p4tEW4F+wir3oxgyDHH+ZwddK8bZh3qqbmPdzRyUN+Zi46dUHdc3Uo2yjaQ/CrHs0QQjWUNkSN2At4/CC+y3+9kaQTt8hDIKP2EQr44/UL0A58Mov4XXmqGbo0e4Ta60WbpVAYRbmowy+67YHzCt21hdSscBdN8V1TZP2nYSK5W0YeNNz/XIV+vmzKrHTBbMo8Z3mili7yj5sCteyPZQZunRbb7xry9xTPm3CcoU4rWs5nxQ16aO9m9dn8ld3VCWqr1JfMjQPMYuayTBVpq0auwnf7obj1csud7NFypt7qPe0Zt3/u+qN3v+7Lb/0KD33pd1N3eMpzqKBbReV252wOtIHHKknVO13iwJXq/AROftWIDgbAyofKl+gI3r9o3tfdNbRCL7Tp1TlIZNx5h45JyAGMZV2e8BNAl+a+dTTmywiB+qOVPKjVtgVl0cYICSrhQDJWBWTL6d1BKPIYB7RjvlursAuoIFNoxO2+YLLYUxEoeFUAhOS5LutNLjV+Yo5yaIz/jUCvlAVTqvpG5TUksr8hp2Vyf8xVXKCDFPI1ZVv0hhYdC7tYPW4qA+YsaH/BIBNJTxEcKcJ14zMxHA7XDdPI3SQPMvWa9lYlz/q19hdisysRVZ9SjefkSEVypAjW5ZZOREGlBqytqJgFJpCc4UR3DEgn5LB8HifHYkXMUv0c0N9/zOgfKvongv4IifNVnQU6rnkyOhuCcjYkeGXi3Smxvwa0p7hy6Fc0BPHEeHDzeJhvT2Privkq+B3D/MY0zEfRBvNRCQca0zB/t+Ep9bKqtwaGCiu9x9dveojmXmHTFvSydwt9uc/3ggpFCx0/B34ju+k1U5gulcJGIzxd5Hi6aJKnc+lIVZ7ukVSBe5KdNcn+JmRXvIJ1pB/UV2HXyHe8XYRLvh/E146tizRfULJ10OICFhu2LlK2LkL9ynpMYet8btWvSrmBOaQQQ1H8JH+UrQvdAvCTfgjTaziDeUxoDKwVREZAdodHDD4fH5fj6bgMxMLJNFgtpa7hdMKtBmfik0LfcBPCHZaEOwT6htPQ917PDx/zSidHa+MQ4PwqJNeexmDZp/UUtYJwhdpDvZ471sNoWg9RpOkhCudANK2Hb/e8sMLhh4rJkd1VqOEEdcwMQVqIrvtmq4I43uPpbU4fczlGKBJiH2Q/JFPBbnTKnUGAV6Az2Fy5Ol7dGSgbrAcubp+wDzz0sZplovtHLT8U6kYBfi3RAm109sNGqqCcLWA9sWU4/Jr/AFuGT0ZBW5g1t2EIHEHFOXiolfs6ztJjnIkbZ82Yy/2FNUFjExNzDLnLxDV46jdJdU46S5J2Ut0cSJokCFL2aDn9bQdMZEPkIORlD4N8YRvRz9xryq+hVgQNOb+/nfjvsp4mC0OPU0/1ZvxO55VNDxXFhsdMSfIj5JxRG/r6GXLKoUmH+YFNVGcwG3FWxHnKZELmIyN5dBJmaiPLo0Ad7IoHNgh4zoJbbfd9dsTqE6jBsbfoLMEn8KEEV8AchpNHDwVV6ZfhAKRKmkMGM6Ef9NT2lYOWmL5AOXPoYT4HLstto7JALmGTBysdyDVLHg//AZpZ68cMEw92FfZcs0ZZ2dEBzamex5i9gqzCZGIxqup8tJGlTTOImjFq2wAPIAO4qEU+SDCNPNDFNFUolpUxExulo+MbpW3TYkE0dOOye/pOCcs4NkvZj45vku6wGids9ksB6mEmXlT1fKfJZ1WSd08mUyV552TyQiW5O5mcVJJb1eSUYyv9+6TnRdcaxZkKPw5NHF/5y6qz4uoZnYuN1WOy4H1lXFXHoVbigrDloPLxkB9y/l/ZawyHR1jUXYSDPBZ2hIKJDPIpcuUxReDOzdoZ42gzj50/5DR9j+eF16pjsgyEysmX9biq7NPe0YlrIME5zCEL6Cg/hjiL5Bf3WRGhPZUdmGTXzEPeWqhxGuwQXA5uNvcCaUI9iZt+m4lIIEr/shfDuK3a64jAAddgFZWV6K4Y9aWIfgf8uL+2NjImUFh2r3rIDoMIkPEWScXSSrI+LOR8SxSaGnLWLPWIw+u8OWZbsk71gYhxUgrzFgO8zUW3qKXMWHvDWN2heG2DC05ICxT5Cpraojb2UW1K1YcrGLlncWyTB631TBmw/66LZI1ABPqszWTRD512qiShaFRFsuHUJOixCY1ThX41ggCdDi0qRVl9L/1b/+SVClHHhFJhEXKsUyrk2k6gRogKfKtG6H9/RY3wq/zP48gH+Vl3aoR3vMapEbpaHpHi4P7HX2Vw8JppKoMAdnbkNZMqg0PE1dL/VXVH7vRBn/GOn/iTh2/+8r1feSrmpW+U/TaGBa9OXSdrkJBad3Tkg6+4sLRM5rzANswegPwWy5k70fAeX42YW4E1E/0Anlrk7AosimBNtn3KN6hNlFCzGP7Ziq2wHtuQUbYKKUJ+4X8v7WXriOzvMmyc13/Qrk2eMq0e6YlMhtDpfut8fwEhFkJCOFlpWCBzABC1PQ1MT83RjcrLW1Q9fJDCVbDn67lTza0dFUinLwCcN7Hfo5NKGKoQmGOMhXrZT2uHwVY7PJJK7AwuvMrpji6/pK3PfqaywzZjqjavPCtz5A/6Skcsa261rnxVwRs7Z/FhTMQnw3dopTg9evD6yunR+/MoEZeHjVcoTqMHYm/34IIYBIktVvTZl+PgVjYTLrKBvuxCbpZ3jrnQJIm4/XYEU/3irrEv3u6+uMt98Q4EsYMdNFXkeDCW+2QJNrWRBBtmvQPUq1J9WWwCMcJvrm3HiD0410fjcGx+0FtDiXNr2TuQDnRS3MwZRht5SzfOon3QBAJnP4vEabwvtQZDNcaWcH5rxyoDgK2iGKXgV9v88NQA3Az/dbhoaQGlyqkXmTCx+Ehrp45RmSq80kI4OArkQFmX4OK5uMbucwAHFGH1+KDWClK4I/fT8Xgv7QvIqZ59SXvfh+0wRCEgaUVTOO9m9g50HOWIBb4yXfgQcaruy8xeL4/qbYAhB655aPXh3aY8rRh1TXVLJhXr4MwgC2CBjY6po6ncPDDQQ7ICu2J1i2LKzvMPZjSDlBlAtmSJO6is08+MgW4gS1lbPouDmA0v93QwFPJcC9YRjBDKoXCtnPV77VNzUqhXjf5BL8dAclSgkboO85gHGPM5zM8Rsl4r3//L3u/tFfOqhKRFtoG4C1wOd/qOhxfEwfIdDxdevmhbcfRi+6QQ1RdL3ABY8dWe83zhPsvmpTNFC7grZg87U6znbkEnHDflcSGh0cHpOPu9PvmolLbQMs2A3zuw/5cYAR5ewB2dL3pcyt96tIXz+9f0zK0h8AOi613hsTyrdtcCsCjj4rm2UCZHRvW8QyHHoz8za7TAI/Citz7j8j9s/8XF9kmL3OtikZZoadLU71RDvzCjuDxp5hfRW0ojvx+yT71yREhR074fsE+XYgz7vs8+NaVAkwQSLcuF2ycyTABeCqMtnIaH/lea9v2AfeLTCSvA/OlUU7+bGfrdzMzvZkZ+nbHXFQB6opHjJn6nGvjdzLzvZsZ9NzPtu5lhX41XwC9PMevbe/hbp8yDLbBau8oGabdSl7bCIO0y9aYa+kUBhOySeYlWCJ/BaOmSflZJ3yJIJtfmDjYVWCi72CJRh5vOPLPejzzYAnbTImmGgXyj39/V1F7ZzG3MF5YVGBnGPM3h79Ki3isyVTmdzTuj03dGeIEZFezz87o1npVi2i/EpMahbdcRuVoIqHxBZm/PtE2j9f75GIGTo2Dc4F4y5elcDXlS45ucSykLKXwpfVk64uOSpRJcR0DRb1Q+SUipI4txZ5R8WHFJpk2pw/472qEU0FqY1TbZN22j9qp14+d++O2L6ccj+5xSMVbsjcLDGrFX9NVZ0Vpuz3jVtmQ/VHH7vGvvcOC8TbPiaYgznCZAMCMX0lhwRE2RHs2u9fdytwIdoNyXMZ25DANFc2JwdLNBm8TmRz+Ibuya1bEzrMuW0RIe8PIt0JXbMgksOM4z+NB9FPjQfUT4ALgJZIoZIyybh5R2BkYJZjkBd5194bJULWiG97aTdNe0poMFV+sVMDgwEs9mzEBuDrc+A8shHQsZLqG9p5s6xsR5Jkgtz2O4j8TCegFVJIKRPmOkYX90gzrr+JJ5CvJtfBbi9X3axpO7J6JJgV+MisADo4ue4I8PK9gvUfg7vATHBLddFhhNtBx5VTiqUFVuihttgIv1Ho2+RrlUauQ+NE0IcEatwZq2Ac1v1rgX1/Gq/QB/VB1vH04vJDdeARsDT41q6uuyHV0fOcBPGHZBUcEVVK6jd/bts1hCXhv9YfssFkF+u6AvHCB5WxqtBkTbVZNVq6GuUGp8jcDm7Wv2rwb/qViprF7WP3yM91Bq4LmERSpGP5kAhMAFW1/eKXsoUA6pnjenrVD5crAX8xj3ublXHTeR0TtfX2U/kzib1EBVZZBlWs2MfJQvj80lnQKZTgFaBsY7zqlvn9XID9ungFoBqbNGYAQgOsvbuNiWlnojGSZDprsj2Qe9Ks+kBUhUzjXtH74XcIS8rY3NgvgB8SnLO8eBUGgg1Kz0FG1RTrXr+o6BFpQn3UCQzlEfc3RGJXXinGyGAeLAMc52uxX5kCdSPkwkdDOzvcwzsz5pZ2U9Pxrlyzp5tBIzhRyxxIGSc023rLkqxAjVoiejNNG30JSygVyzsm3qlDdyfMLoHGfSUwf40lFEz327tM5J2qzAbJbm5TlP23CVZRstAGgLxl8ZxLZZ3nL72kTJ6poSfic51z2FNiuWZWQ3eXK/SzcYwUtfwu3E8o51E2RLtyDmJPcOag3yVnVLBylGC6JnNWprDj0+PUU7bDK2v+eE2mG7nHbYT40ffFzo+aPaYfYAQuWEmqCpxgp5VVXM1V6oNjAKBReXXQ9xAHrL0FCh2IiQJ3mkQh4fZ6WXohKcQsNUCXdTVI8x63nkDj/AcMEQ3oLAgMXHhJvAUxNvS/8oSX1I7PkP91PtM3Cn/+4CnYpmMYja+ormTSTb4FplG4wmQVdbJfq6v62t41YKzICIQmUyTfwWZoif2M02MUvg08GxxC1+baMYatvd7AzNKA3FlUWYp8dutrU+lO1s0cRetknt6l427ftyG63CjLYsb6572QZQN+2HgukNivOEUsFUc1OuxaG32Bs3cCuQN+VJmIL7yv1t7Y71IoP1oEExS4E6aaXWkaKFl2x4ZFjMyREnHJl5pdgFIIuIv+MewK8F/wxpVl+aeBkM85YeJAHFcEoxeoDCXUOxqeZo4cbrcEhzR/j7Vj5HorVaPfSSo46irdIVOf966Ke/8PvP+Z7L9fzLjfGxi/mcqIICVd3V1mgb/EoVVKvCuphbdykZVSzRrx9hkFzgFExwCDS3PuQGzuUtc1SmjRQT9lRDwVf21DwxznZOlqOHzwZKhfV0Hajvs/uIvKV+9MTPep5U4l3uucqHukVjFwNw9mG/kzFIcQyFlg0GskXo5XXT1hm9xcBjjZEpolv3hd/2v372L5/3qe+7qq3DZJpRLxMwkVruDVkqby1C5TDZPCMzJBWnWy5DBSMU1ckzjipxRz+p8uK+tF3wVvSQfRURttbd2FQOLikAb1Cl3Q9Ood2Tsf1dhnruKHV0s8KeZOLOiOek+CC37gMcvI3qgFfOQLNfVNKtp2NefxAcWMPyLCr870UaNBc4WvwS4qmXAowKDT/T7/Gh9YgmKekLrHZFeb4cIiQ/iajiqMe1PLIZKDKuB6CRpMpO9jqp0PT0vDG9ZLUB8YETrTr/6Hshuv4eaFaLyS8VACPfe7w8lih7U39S5lwXmbNat5JTxxgEnDcxgmgiaY7HJc04TFFb1Lz0mNp8wl1jad1RrxD1F6oZQXPdONHRC6/WBYwqvPnThMxJKWSugbGpWaXkOqegYgGY9bsYyENPyboF6lJLZ6r4ogDQKo39lwQ/cXm2G8q4UG00Fm11FRul9rqYrZPR6luLHH/0I/8UYoH/JT0yJP2UvGwDEUXFtgUeBvuweH/V5yIEPX9ZcurhEv/gXU3LoEfQi6iJqhD/lEl6RXfXaN5zz/PPRYg3sXt4B7tHY5+NNjxbw5ec519SHhCSP3KU6J1e+47za98hoeDy84PLuZZ7a1wNfl3Fn0cUfl3Ug4jCr4u60eMo/LoGQivau4D/OPkWJOM3+xX7xZ2Iwm/2Z9ebqPcgCr8u6qhEHa1GHUMUfvsbIuHnKJj/9fBb1q7Wf/FbRk0ckRU1N6COY9MRMyzbd4PMKH0x1MaezvqCZqrOCtjiHBsqYHfZuRjqSa5A3h1q48WOACzDjJVu3an4WokHRhSGgbL3KVnQNgunCJJz9w1VdeH3I0+aPhNtVrXr0m6LCA08haEcArZEks8P60GUIokraeA3eYGjTuWxJGj/vdfqqZGv7iPzwMZBU6B6Jqk32H5XOXJDvn7O86Ep4nQwI+O+AmWHqnbp4+GrR9MEKjNYXJGYiNNjaS9SE0q+RzU3M9XKFL1SCrOPVHUxw1IXM5RXUROALiY/qrqYeClCikd1MZ/JQ1QaaIn6d/+DWcAiPdWOoMQnTdXWZx9F1XJiHW12f+tX/yMoY348rDrQqWq229ZqOCxi1WGIjdtkV4oCLyPj9FodpUF18+pr8NEC7unACkdwoFTJDI3rl8zoTSYcI9oAqjmrOIfDd13UG7qHNQt7oqsHPs/12FczG4MTZs1IhoW/6UluKkoVdlUNRHQ9/Th3yiILe0aUVldYoK7iZaAqlJWDXIkXhSq9ywZAbLq+RuX6GmB9Dewyl5oLWoLzlv+KjChzgTtjvH9QA7kFQEFZlRaXSHGUIkPpxwm7p8QZ5bBQV2YzlJ7iijC8LFcdFWuKjenTqBKkm3yOp5wSy7P1xDqQ0LW8e1wUsKdUgexW1BBXJ7UUw8IZ7JoQBPxaEMCdcnnX4N5GVW9LkQoK8zL3s0NCQmX8ffA19zRwD6e+BvMrEC2j8qj6ljnfyD58I19B/hSRWsDswNXkE54HPQ1gJUYd/lXk45LEAdWnudfT512aGtyJZ9Uz8sB+v2EDd5tP7sHzfs95RhYK1tKGJaIOdU9jTUhbFds3As3xHn5qb7l2xIGWMgL0VUn7rmBt3+zfnH39rW+55mnGCX6omSyE3PGNgkk/yj6BvKrUcDQaVM2JcMFsvwBpNd4zKjiNE+QUq1jDYdy1PuQjE6p3fb0izgowR7kPxrFTV8YT1GHDryhbsmEDueNpY5K9MGTgCwv4I6hUiXL7W/Kgqo5GQXrDyBX7g3OjV71/X9cY1HfMN1c5XKH66iE1yz6BrNowLAXW6MJfsqXET7pSNqQUrqdsAYXr6Yc8z9rHSQp/YPQMeYpvFOaqGcb7SOEUbcmvmIM44nbim2UxrSwLDycL99yX3vTCN8syTJ/vCAA5f1kR+RfWlvnhQXkvogCLi66cagDh/bjFI36a+WfZOH6KQJjuFWhGTptsrmS+KMweQmr6Ad/zJxc+5wJL9flCa2GuHwolYCiMuErVBQubf+S617e+8FfVwXsXglX0AoycqPNIm32hqPzTxc8yN/i1aLDwPXqli6k6frL9TEJepFgb6XJo1Sole1ZeZvdHNBBdezzXHk/bU0N7aifRGN3ioyQr6ww3gegPHULUr3o+/FwJuBSrlWj6TtoUWLocmt1g5QKALll6eQhuEYXfRPuxWIl2SlB6cx9Wjaikk1cx0a51aEwP13XelJUoRehJGpLu8YyRrdP38iXN9fQ7GCumSBMgSDc+AfmqoBIUI1HIw1KZWIBxEOAbEyH8ZejPODpxr3PdL8zmoP5Qys/SB2MR6QYaCN3n7EKyQxDwIuTMKJLwFRLvaepleUdis3uA3yJU+NFPnXp/es7s078X0Jbh0kTDQgyaMg7Y4zXBFsjWuq5iAHGIF6pCbsJVw6EnksVPPCWQNRmVK0IzjgbajBayqhF70tP2pqhYreWZ6WBAqXTRMibSS365DdNb7tpkFJhL8h3JKQJYiqzpWeTXyK6LNMcz99oDFhjPt2LiGcQ5HJyVrrXAk0OPnGZwdebWfDYFf0axNBKtp4hPPTgNCmX6iZhdpDkKTa3KDN6LUzbKOI6TOtqZ7E3Cl8/R3IBm15E3tfp4EVoaMcCMzsP9VWtrZlCU/6pLmhWtkInVYfwjNfbCqORWwu/0cZlbOnrjH76lnweuzwr4cHhHHoGSSiFR9odSiP+CIsZ8EPscMOp1+nf90Ef+cdcDFw+vkkmX/ornhW59cYsLLlGTfxtHwV5Xb9PFQ5eOyrrBIlT9LjredwpDvVYUmMqP3Ap7hrdCKw7WDCnUwsfj7acJ25YNPeN9j9gTanOtAhVCbp/vZufhiIE7tUqc/TGgI/LxCB1cl/UuXlMrccAU2Q7371GUq+/7qfsvOeersNWHAWK6E+277Vb8+/LF7I/1ziTVq63altBcwvBLO4hRSRJg/y5ck1H+tI4y9lV3yuEcp93przmyIIk8c/aqYLeSoAQCUk5D37bs5dGP0eOBWJ5P+vW8odfcbY1yRNNUG9P84ElOQZUfPChK/zKpNooZdwnL1PBl3H55AG3cLW43Ivw+wMvxMb0spVY3RkoknqN18vYXTCWoeVmvwLEkQaVS/DjMqLfeYuY2mtFrYRSvFzM4UpmhFNY6GpTgD18SvsVU9HB+munhWz4HxxcH+ObYRj7v5oMqXoS5Bx0RmRstLq9YBKcRSNnFEo45pf1KldArJUuub5JGJlrHBiYKloEZXNCZgFjXkqhlTPxlxB6KaNnGBsSVPgjUWlLgoaLRYs0mLtNQchsaOdqEzOYFFjzyJlRHBE3BQKEppg7SiirtebjGxfL+giiFzstGsUiLwyPk0wKQY2GjNIvJk2sIZMIhXhNbOCzoC9S5VKg0YsHggRVpFl1ZJjzd6sviT7OMCrawB1XFxpPRkeHSWY66kSJNmXNNycyedlp7TEPm0IA5WlCb9VSjLtd3HrcFJNd6ZM4b9hC/zZ+0+9a4pZJqD/wWB0BRZelTLOAgxIjHzYb5qtkw/yLLWP1uFDblkDe81tKGsKQNhgYc8u1OE9+O6Dd51ixA389ja9bFJ/5js8J1/VZl5uC+rNU/qGjgjzWfVF+cZ1hDxSn9lwvJ06urlKg5HmpTTDNr1DywoeoLHeocwN2s9ug6nUeipAUlJ/6Yh1zVM1BBTK28iVmOqFSZRm1dnv2p0r0RyQuseXa4XbiW1l4b6Urfrx47Z9DErCz3mN56yzY21G0O3aCwqr7ZFk4FxCJjym2co3XUSGoxV+lOu8J5tqmDw3/+UZU8AfZGMa8HmpzMZGhYzNIcnx3v+663/dW5ey/9yv9HLsgL2Ez2N5J3Ds5g1siv3m1V4ufq4y+/+sGnfO/dr+Ola36dW/KtZ75m7znvevhiaq8PBnfs+19/dflrf+aWz1yMUWgPhmp/CKW679C7TJtXbP79sNKKoQndf/FgfdMLthEGVx3jFwCFLigGoV/jR7rsBYzUem7k4yigxWuxTg9IuMkb5u5SoNppcKty4oINlWs5B9ewpt40Hgg4tn2ZcO4p+XIe2uDMLcVhapWcGS/gDeFVgVDacstfJdQcwF6OtjMmD9dB1fZzf1UNKVEku/g/EflwPIRj5gF6cMfQyvRW966Xd1XP2Ls+YA7gIc+4Sg9VqK5Eb8SycaBHeHfWGcLju6LQ9MGjEMwycEO6EVjq5K5nYOnPUMTP/9jl5zzlTfP/nZmauNyFdffKhVqvvLJK8REtDWeRXExdrbjVKVTsR3f5DxZ+05ELuDIKuGf4Sh0Hb12bk2hzPGj65XpkkX60XoewDaIaIEN56+2gX9I2XXce9Kb6Cwl5tbmfkwiBe2zgqA3cZQMDT7h4pa44JlNWSENjJOWYZ+llrIc/4I2G7har0JhsGrVM0FKiRKrMzFOAhsUwpXTgSilaQyy4x7whpS4WUQOPF6oUN3n7CQiQ8hltrA0DDwHBWViRwpsSYj0ExR127Gx2A7qjhHpcAWdGJckdBYlUI2agHdq5AjMsq4Q9D0gAPzQJ37et0ppTAaEZJvh5y2re6bZUmYMHPB0cfbvX0xHSt2N4G9i3jF+O2Rfil3vty25+ecBeW6H4OW6VANNuRjjO/rcKzvQ9+zN507RMV4ZmRdfF3NOpiQYmOpUwfKLqOtDS1UK0jXVIW7g2rmZJVDBP8pIMy/0qtlMdyx21dbfaVuiZ9y7ekwG+mFEfb6P6TB3WcC34RycLckRWr3FU+UehobDG9rvScBdMpYttUYfkYqFiNCx0XNEDbkKX0zh6xsRMaFdlQK5jxh4Lz1FLyn/P82OjbaGKcM7wtk+BsBihim30zrE6fwpUnuarGAukVNz4c5Jn3igWcq6MRsP1pMmDw18ICRTLshvUXIcZqZoFL5eA+9kVi915MGYEzzMGj+2mWvfUxrpk+lNeaDdj0im9USgKkdybshtWc0i67FqbJ0ahuEF+rpatG+zKytBTYRP1Dnuq1tBCba7ylboWItXeZMSEklM719aibqzO/LNKeVGpb128J0VQdfJehin4SZBgYzEMhooB/1stWK7jvIgo84vqWGVjHHzgGV+1/2o3lDTzq7X/X08Xqc0zlK148DpMZFfn83t6Wde0qvApULW8ITcVL0f0xa9Y/fYhOPmRYMSObjxqewtii+zPpxnHclblnf2turO/VZ+0v+XSJRVQf8TVQDOls1Z+8hf4xNlY/Utnh0t9NpgzwTrOzMu79vvxK6U/ew2/F+HnkrX9bKh2jf8oEtc96IMWJW5lIpjqSi5FW6RdiKvLLMUjLGrumHvcAms9e6+aAMvrGCFkz+v8HLfAGrsjuN/wQlVLraoIxNrROqoOjVKAcWqAtyYFkJ1+ldU1AxjVUE8i6HkIktmEjgBLV7tQTpACiBKJY2+/1EBcHVOPoXpfVW8gKvUGIryqpVnoDUSIcHoDeCl4ZEf1Br4V5+iHPHOQHvfvs6eUMTKE0mdpPhqv3ZJOZZ8trTnFm1lz+sx/BAWCz8dyjFpO0YHnjnBqUzi5GOuqgB94jePFs1SVZRewU2wM4OCnC+iokRP+wt9HtSrrdgWOhSpiQ9bauwWcn18aFtnJ4mkK9/+SkmLRboJVvcNod0uCtwgg0ASKnNGHz2PMYDDnpHL/rRoc0D5EcDdRNgpQH1bPvCKoWZlzvT+4uNxg4UCi2xtSuKEWIvfZS7XDqu2X9ezvpKo6LPOEfZ9CrLao+VyA7bhfDwsG6wv1VEtqA7WguuG+rpCw8juXK2JdxV25r6arNAePjfQK/bjF2/fxp173vW8bfPbioemXyjp/k9/LtobcVr0xv8Bl2atvkZZIYfb3yKWEHiDNHsC7WQkpAWrrmq1zq4VH/wnQKgEeYz+UfQFfCF5jAOAjPDxwnr+n0ru9ld5hTAE/FVhTeFnvPH+fVK19Qgm7sy+aMiOI4aSp2rp/QLwSrJ16bBIp1oZO60CTu5Xk1cnkViU5qyZTCV38vjD7kjnFHHij+hWORjkjU1NiQdVOTsHib8YVLHAga13uOwWLZ08qWFxUSd47mVyrJIcTVqJcA9/mlTcusn9EY5ynigCuFmQymRSOBR6p77yQgqJmMnku0zOtrQOqwbAO0AhfqB+GPFQjNxRq5kJOA0H1OID8kz4I7oyC8Fqsd5VdedXFSBkNTwylbwYudMOdWMIAi5k1/8QimhhZrXFXVYhbzz6ndrGzn8VzuO/vL/iXrzzjnH+6eCA2ZI+480/roeG27CbkPILTzElLsYGCwPj/cDO0iCqeQOoK30rThGlPxKOmN9rfTfvpVfvZoPG+NY7bt8Zj6FtkfXMkwIaEtEPON0cd2erAAg9YMNZP8OuKE1/XPcUmR/paJL2iLlSCA+jTJKYeijxnV7GyEIvhsEL18zBPUJnvbopcWcQX1jIHA4+qmwmKRSs+Alu+ix8+SqtYG+R0FE2QMvc9fgPdA52HP4muhIhDCxJSn2sILahpHhG7PMSVvIx7Ae1Wu7j+k8rX+EMlnAsTc02oLc7d4wNFvJF7xpxLZ8SFmE8xxt7d2RlRSNDLBsOcf6p6MORx8SlueZVbKPIqZgc9TRiSd2TfL37wqru/8D/+ls/BvkP+/aLTQxC55jqfcC4fgOWH75UzR03de9vR9X0rA4///xZeo/k6jQjQ/Kr9Z62EPItEn+Wa/SM45ZzAE9tQIC+F0NPxdFeH0bY4GU7iZEiQQoW3TaCiD7hc2Rtp0LSKc8gsjY5O1Rzi+1Q1SlmOrFTBWnDQ/1D2ZuvGFb4tnd8zmMPbsI7O9OiXgmnmgO4YdlJTqFqX1cxFiH4FRx5RRcNKufBJGUwzMIbKlB1Wq2chosRAol6D8WHGHAhuHGSE6jPYG9HCBC6JQts/WweMrTwwWrShs4GFnW8QTbrumjQsZyy0Rbw5hmm5+ohpOY6N1LQcxprqavRNDBLLFk00zpOKaN/DmYanh1z1SXNzEYzNoaSwYmwussbmULiwNHeoIjYuXTewuMkdGFd7TL7TGt+8BVHFAF0oBujqVle/TqHT1ccWTJurmxwQMGroFii0D7dJCkj97GRfqDisrauyS2SthqmHUGd67l3qrfZ632s61Kgc2psz+y+rCXulaweKKPsXicCIWIXdVThFxajrTj1PVJe5oXr1TbXNDbEuCnlxIcrKLWtGIJHolMsWWKY2HjtjycRPREKyN35Nxij7Rrr013QnHIhymngCKtV8ETke4/Dy+u1JylPbys1a10WvsOJ8r6JCjh5GeOxBfyEyv1oOK4AOByjEbil7EMDBoI5sT5SXT2TvcC8E+dk9OlCBqjnnDS0WcrNzxcTygubIU47ZNRLTUvU2xPS5Wuxs10xSmytEfDFjTX9we1PVLp/ZyDtj9ENkxzFlFI1QkI4hIA7cql/NPwAwtYyxiXwON/3UePochm6eh6RybKmiIBfR4dbNwfVq5WLUERy0DvJOamvKqDPE7feKfjjN0nzFMnAmx3ZzSJ6jGRlygXQTBs3QtAVG//GeLnJjlkrRGKw+yYhELy7iat9l42UJaNFxlbrglb3CwZFckJcPraojrsCWwAIf2A/yrPvCfFmqzCP9RtmUomNu8mbmo+jqyhdd6khLUKb2zHg5L7ZgfLuUAVTLgNgy4rNcjdozGBfyOdqSzwSA+LJAegBIDzHY5ctAAAm4z9nTYB2FkfuY0JtR8u/rulflRTCmmdNxqrh743hu3zqGllvr0RZplR62d6QR7mSqerweo+pYb9qO1SMktlger2X5iK2lhrdB9YrwlGrvoOzIcLJC9HWBtohNxVmdRSv9iA9VeorwqzqR5ikAvdvK7VmRtaIutpFWcN09QqjX55JheZRzbJEkWoFxmW378+0IXZMTwQoCbvfm1ONQyKGC8XMH/+3E2jHlNvopfHf8cgoJT6wuW2kHGldEKgoImRARwhmHr+B+7JR+SExxCp0C8xWnkmS2r6dx+7Zx+8wlyVlKtECxCXe1yLQ0fAWHM05foQS4WUSSL5a0yyWfhvdKvnmKzFECUAzmfHZxXDIWd7pSSygtQCAhO7Q5Oi0/ReUpcqX+FDq9auqK33fxO8VItLFzYmlGiSoKU38FIE10an4KAYOttuE2e9WEMCgFFQCGdla7wmVqf7U3/KrWe6SLebVDJ9V4NJaHzTX/Ebc8pe05bv0x2jxX9vs97ksoYxS5xruRQ5zrhGLDSCd6lTEMZQzjspzLuRwzstVyeH2YLOfrdoxXlAHYgd3jDtoJq8Y7aYt1br2CgW8wDJYOyOybV9v11FNzLeg2l7eqqjWi9VoxMQCbiKpLyV/oPBR1Xoqrdkc6cuEJxpbUtjTNcd2AzRoWNqE6erpsm7qEtyUqjVkuoI1tWgBvtzAifWqVfrBbpEcCI8lpmZxOJCvsDA9CyQHDfBDzI0xlEQ/3yriJPyejKCzJGt55yZcOR6OaSxHNYSgSQzvXDGOg1VRqSKW4nPu/AXagardgEbzhFYC/jXOcAs31eJXnNW3R+YvOuzSDKvO4MiRomVgp6lTX8Mys31Ui79ZvDFJJ8mmG5nF6vVhJXrS8hV7+VrZvHs29StqMC3Ebd2RvlMV+xS7qYBxyUpRnFJu3VwO3WIozD0jwHOMkhEDwF/hvK+RSsr5gvcDeYAtGsodNjtzsG19UFI1XiUXQO7FoKBy3B6ATO2hFUXsb7cxnSr33eXyxrZygDAAcBM/zaM/o6Mq6SB13KX2MHZgDvIDKANgsAFadcNRDXE+mXbFD46SBOg9oJY+lGbNoxhxFa9JFPGd1uxPR7MRCXKzlC7QVJW4lsrNjS4nkW6bNAUBCk0MkXzV9DpxVmQN5DkV4fGEQNcdQzFl8nang61REnZmKqHNfA0SdA6LOjSGq0pIqomoXQunHCKLOKqIWBkNnHYaCqSxKDN1BhcHQlT4jJf+RxVDwPAsofOH4GKoDvZVW1/LtCtAthrPZQjtp1mLo9q8Zhq5UMHTWYOgOYOhOxO3UOG2gasfP5nPSjB16joH+Qc1wh0XPFakJZYzUtIqYVSKUSlSUNLzE0oVpWJqXyflE8vQ9Zq1/kewx9Qqy2WnqWZGOzE4uFp8UQhtwwM7wRVHq64TnZ7/OQwuMpp2i4jHvZuQ2Jhsz4pZkvt/BUrYmtN2ChSIAfXQzCDNfURUSCfWwHZ/HwjtfWeIUIDtVvLETnd1ZnZIoyG7B2w2cvetfJFqF3jQHZThRfZ5u0xRO50JQWtfe8rRtVHfd8KyfN/F4YZ6qYfXGcQ4lm+zPoWJTyHznYmR7XRXXygFbPlO6ZZ7ZEOanyCoCyXxWWjQzKsSFv5ZRIW5V9wlgn4P3Tv6ptK9NHRHizml1eRtdqlAU6lghbuf4Qlxs/tj5phPitqm9qRC3w0LcdkqZ262VwtshzeqHen4wGFA27rb6CLZulU3i7r2Q4k72ugaym5XxfMHLOwl4ZCPwmAM8qr50MguP7PjwyCg7eXhkDI+5igy5Q5atSY4O0aj2hEgZ8EspgBIzWMTNUVBP4UZQLMZBEKN4VjkLQGAEmZiNq4D0EQOu/W8GuHYFcJ5WQln1NKB9ZCoEbUPVeO6gYFwBHhE/ac6eBniTpwEeZTiHGD8NYHAALlf2Rho0dehaPMWgNTnkUT8OKXBnam2KKkdqGfmVQ1LM3yrmZNSxjW9PNj6jNje+venx2maoVkPfBkwnheCVatJGr7tRtUcmznmREA2obuMzjm+6PlA0hA03LvBqcEulLtdF+1UMD1MINdD9Sr/lJpaK4nGjSen0iwsmkO1Sn2XI3eO0GYoP7Hfx52h821lmq6JueXeG2zPAm/7TKvZc2sN54DyFTvtC2YDRNiPQerFsC6veGu8NvahyIO7rF3oMUx1q66G/iOxxWpXcx3qQMXFm5z2KM7tw8swurMzS0M7S8PizlBt78md2oZzZUTSV3Mfkj5D7aJLch+pzcxNy71eOpTWTI/cnhkdUhYeeO0UVeEQWHtHx4RFRdPLwiHAJYMSHbVAl91NPEP1UT9Yqagq/fPHwBSNqIf+6mVoIUk6oFoJMJ68W8q8nqRZys+81JhVrdB4khbU6x9NBvTuJhN4epBnTUzFyJIQL4ThXgxVF/ivP1YLquVrdnaslFKJ7cXmJ2lUWcWX7Tbl5Q+/FqMWlUPlzH072RJnNlwPJQo8drRPXhphgpQgZ5BHKA2nmuAwtt4qkUw7Ini8GOTa3+ecMb+GQ2pwHhnoeGAkqR+6stHIW6Gz+HfbUf69vfLkE4mdTX3JRdUADa1UXjKqHVBF1e8YLquRVzCHP+RFUxW2Xv2J5LsRj5L5NkH6TdM3YPFLdTjkPtKIjqFlJhS5idSwi/UgQgJkPptDUIpimaYSmh+ipd6DwmL1/5JQUe8UYlCOeSjliR0n/TSjHdO2H6FFoP8CSo0X7+LjaD9E07YcY0+HktB+qtOsF6V8344Za6L12zEZvVPXidP+YT6ZPO59MmiST5z4EzR437kse63+LJc/qa8kem6pdinaZIa9rTQ+O1fR5V9ODrqYvSU2YJNxv3IrDpneXNkvPWpO8KffDccCKPXKL6nhUtiMzFECnwAhvktMDOj8ghIwmZqZhvVcDjnyXf9gvMhUhZJSumbQEHg9EAb+PxmIL+rDQ41magTiNB2WmNAFOYsu8QW0ca3cwIzvjR2Ez6JZnmt3u6ylukDerUNPOVuBLmYpdmqnS8hbGoEPRFH3mObGqHRGeZJ6Zecrw4ObUc1FHdW88iwswSZ4AaLhQlqfKAAJIbGmDewaJOjrdwGMeEqirRAsrAclO1Fuys/WeSix1cE0Kwh+uIUXVlHIMHvvh2JZStZKLGm2x/HdVL58tVQQAxAaXInJGVBjB1bprG8A9S3X5/MqiDg/r84jQMqptQ8vzBQAQDqYAPnqMwGr+GwKr+e8ArEWKYW6YBGgLlBGY8exXYUUn+4pOAsfDL9LskWKBFsoYPmqfXS83VjS777/8w4Mf2f7in/C4yfMALubc/X4pNnSGjCDNFCi7bRn31Z3hi7iT5gdlDM0fWRegQSpGs6MbjqBWu/rpzOuJt6+7/RcoIU5UHalp8AHtX6DZvpd9FR3jupGHX8V8juz+sfyrDwPrMx6iv3L7cWbcE4Po9Wvr7DvPktrQ3RAKp21j1Lu/Bx/RzFBdcQ2PAPEYMte4phSVGiAUTdHFKdJpRQhatIwMUTrH1AgtM3fk07xjyMyMkSoegDxxTiWNLPTL0XH/UtWy4L9lsaXTRTnOlc4cLcFvjZyILAr8t6yxkNnPQ+Tlvx5X0M1XKeQvfVqVVm2lFer1EwiMpbR8O9dGkEzLSr+NVuGfpAj1fmV4OORIvBC/HNQXPRR/INAXOS2/N6CtWgEcP+S50eTfDiZ0lVblaDLn+u4NnPObcccJiuZ9TwXA10gviNo5FyISZzDVPerCzUFIs3LbU3Cry0Ht+1a87c+38YfbueMkPYI3qe1rj7JTPtFEpwC1R94vIrSfaDvQdbs5PKcOLcuobK8AzFUgxa8CbxDSw+LxYpdQ7BItKMQS8Tq3oBDrMJ6oXx5+zFCG7zLd1kvlLZhRKawe/rbqthK8LRU7aMdwXQ7FtjpSe4peiO7yUUXeFrkxEJW0A1xYu41TaFw9PFKcSqcO89PctzuoK3jWkrW22L5GO+k02oHc2ZFiF+1imnD6qBYLl0iiXsCZT+UMJcmi0+n08uXK3jo+N1/S0aETAVrTSrKF2OGiuTGrIM6rAotTKgmnmGMyp+HQpLq0V/zyhnJIoyWucle2o+AWiPMO2SPsqOgpag3YF2pBDeg3yueFfpcgIkdBxUmUoEdOXcvQnQX9bmB/g/kXpQ2EOQJ8lKAvkeoFBZEIqtMiTV+gtP/CteIM6qJ7fGZ4JrZbzwIfd9lL8rPUwvzZnNo9kG+hWRjZD+Fq5xwxNpA/AYssp76KDyeABJkMbYKydutsy/In6nTKn0QxFWSia0WOmefbmVc8GXOPuzBFUedczEROIgSOIYBvjyKAr+5yX7l/Wv7AZj7sgYQyzM4CLX4iPRHqOk+hJ9GTEDiPzuZl9UyeKOcwBX5CPq/0VgDmLASkOG1Ulo8Po4U4rVpisIoZrS5vcpn52xGrQSZVOoyEYbxXJ22HSdUcE+AZEXtmEDJg/tA2LVPJCQo9ryQGZIgLrWo9tB0RzrUP6sQXTyHigM08mW0V7cGdI8JYanuk7q2uP1q1tuNrXTdtBULxXMNjG7WBTO0+xB8yYdrGXQkt/ruBZpvWmpNUCP0CQ6y3lkQ6z/ljwquUqZVSXl0FyHSW0FnCg2gbyAwrrqkvMvGxpHOTwRDB/1NOtsf4SvsLKK1QW5FRV6Yny6L5JLtCoSXGf1RO29y6RE+WJo/3GivHdqAzPTHPISOj7WiqmsbTxoELKdu2hBnAQd80zzP+z0AO+TnwlKfYCtDxRwqgJ9Oq8Y1qpwV/LO/n0rloCpqHVinotpuVdUW1+cYW1q1ocpvresDTNhwzbbhL24BbmdIlzgicknUSo7pkkW4R7MIidfDo0Bwec8pDzJOHNZmNYIlITq7VMjUslWKXGSzia4OW81XwpBPkBICaTpGU8RDSZwLKcOTKbFRITBsjqvgWcnC7LAttWjXpTHxLapMBlgo2gIWY/1sVBgiWFkhUcjjQzVcspaGVfInLCosVFKXckla1qtgmVZJUeR6tWuRh/QLk13opHMOikJ4iWTNk1eSsTM6UoQNGEDz2cdO4J1zrVkE0WhpvSGgasnqchvRf+Hi0ZRVgcm1ZAfkJHfmBZPQk4dM2zUoefxBp7aS124nl5nqVCG09CSK0TXlFTA0/38o1kfRTXU+O1aVzPudP8hUxDBNuSnW2VagOnYDqgMyMUR6lOiuIA/6u0EKlfV1k/7+KECn7LqQmD/nh8yjCIR55VrtylTxGw01piaMcCKQlbSiIZkcIBJl8mSVV5yqpAs2aybcrWSDmAWUDx/gLDzvQGOUq8vMkQHmOJ1eVny+BjOE4I2SJoUa5KLdazN9D5+lAF+dJvEReQLlGcklP4f+ejKQ9dL7JeT5eL+BYeeXCwWZiJcJ83K7cL8WcXbqrnF/GT9u/8wQggNp2lSU8RZuJYokbkBS2A1qDLedc7Z7OSO2yzcDB0Q2fm2U6OU4801KpG5+MUjXFX915Y9PH4xE6tmR1jG4oYQBi+4pMxNPlSdTkcup5qARCCyQzG7YeZza4mfDEsZngkJ3GN7Ict1VyPpkhr3PkiXaObNM5oM0jMxe2Hmcu6DxIKZLdgHpZ1p2tvhzGSwbNbIjgGpcaH2ENNd4WvKwfvCTvUUpdsxLmPgrVbYgITVYsK0WwVIQpYXf0R/3KXv+YfSFgg33ZjZH3H+UKHjE0YghZnA9JwROBDgIKbsqniwj8aXIGyqfknJVFi6C8Kkt6SmGxfVxS4dBUMc42wJY8HeUmK0uJ3II70b7JwlHpyZe+PSed5vb41B5Ippi3j3NfHsOM1gIYGlUg6IRzI7xZo2zxx4XEVvUy7oshCn0Z4IXMy2G8ZOblIF7UKhvPvm3Ue1YeYi5iexCaY2xjIahYxeOSArZ6JtE6z8HFMimAcEOX4ym4/+Q8597mupnnJT3FswARYErwz6AIStvV1KA9fVmVZY22y5JWEQOpF1Hd0Rko78D8q2r+76jwB+WuBGA2ZiP5k/Qiz7u2tL4UUnCHeOEbDCmCSOmKO4biWMErONEd1A6z60WA/G5cP/ZeCdh83tdj5sYa1Vn2giimAfwWm7f78VY0KueW63qSUKe6E5L3Cnyt+Cuf3efjd8ClHxBrjj7MDK/J3c3aN+ETqqvZuPfCOLHEfHdvj2+PtnFEzLmdffs0/dfAD5wzi7ucbUSrpflp68sCcMlejZ62PTH4CEe71t+F3DmunR4c8nEEx0EezgeV7urL/XhRRQUcwkV6UTxSC9DuHA5N7LKmwO0YAkjvYXzoFvNSQ/4DelX2Zo5DEwh9u9lfg4MLNFqNBd3pZzegpc4I/Y14ZbpfNhftwDPM/gUyeG2PSPBxgkA+zJtwsf+KxELL+DVUgQ8/4al/vJqa4BJjZ/zyQ0h3Vb4GVSLN+QRx9WkLQp6sSekfxCii/HWpb0h7ca4c61DryB/YGA5xw+a21oEN0W/VEbrGeRuZHCt9fa055eBBNggPy0/XUiBatEWMxxXDog5k5+DzhgN8huDVHAylucYgJMUVlbV66cJkWFFPK8ODi9gS6apt0+vQCBM+hHDfY0dqwXUTzlSc55LX6yfiuEE1WNQPQh7oPfaw4h8FcxZ+bfHhATgpfk56rBGKzx1n3PgBr3KHGnZiPu/pyfW9w/Lk+ugdCBpvOn2xGXV4IFGbWAodaKqaBq2Ej2oYB+E3l8HgHg2O+NI5Vvnq/kr4QQ3DINrtNsitOVIG73WxhyT2Fk1Txzty8q5dS7WbD7huSrvuw7tm0yQp6vOVLw6vj3wRHFrfBBRoritNPnNz+n7PzmmG+X3mhceynNP3ahyIozdxYFiwha4/4wyoH+Y7AY/fxXPDUyJwr6dEoEKJ7vKqpGjgVWnRYe/4xOgW2ByUzm5uHvblxgTsC83zecbW1q9enDurtWrjlmsY7VleLw1z5TGAVBeb+hSr756izgpAlyN635v+9hcH//zrg6d/74W1Z1Ow+TLA/hyRDEtiMOn+ux7HXCTBP0NwjwSPIXgugjgGghUxBD+P2F0S3EBwpwTvRZAQVLNkqxK8B591lUzmsdaYuU8XXI0tV2PiPgWfGzBCiP2C7A2Y3Xmi9mpRHJObvI7Hy/NGdSllUp+4pZTfYH2gcQRXhShWH6oAMJIK362r9XXyjavV6roa67oanM04pXS5SmMNRjCPA2+Gqplzhl973/C9WEt9LKJ+xaOZItKDvsp28IUQOAWbkhLtPLq14aHgz3vZG9FzY7RYvzcbdaR/V6ELibHxCGv45UWMTyaGogUnpGiHf6qcuA+sT1C0o28/HkU7pqmE8L2V8AMaBuX4qAZllvzEJEU7KHH61S2V8J0axgz+GEpAkFsjsUrcXHBDgndrRJWioWuWPg1cN5XS4l2zaZIUdXvli6OjXwQb8j6dot3pSsNn/7EomrCBwOyKCp+jcjDeOU7XYkfX6gBVrHStrnQNVO0ERAxzSKHx7P/z6NlNQs9iMoY0nwc9L0Ug+GBGQEhcUVeKVySkxO4IOH9K2D5/bOjDm1BShbSMkhXM56lk5QePT1bU3e9jJCuHfracPff/1ARZ2bjzeGTlbk1Vq+qV8P0I6/R9fxkMDv70JFl5sPLVYU2X8EDDQJyP3ukIiMQqd+SCd0nwqEZUyQq6ZonELQhXyMpNeNdsmiRF3Vz5YmP0i+AueZ9OVgauNHz2DbLyDbKyOVn5oSlkRRAIgXcgcLJk5fDxyQrm8zSy8sOPlqzcErOAISr9VY6TlGvNVLujnDgHb+Ng9mbUt6LTQxLd9Hh5ZXa8dHJyXD0yNwp/bHaEF9b+p0P851Xx/pIq2u85Ptbv5fbAYq14hTz8aoHZHp5XaLZOh92KbE9AoYBIbU29c1rBUfX6T29o0LiInRtOmCJGoeZzN2ljIyj4I+Qh9dG0x91iKWJrvugickFop3YVDfcKlj2BYfXtEvp74Nvlxg8UjK4i9BAiL5FgxqF9CKEVOlnQd0yWUfxOyuwtV3BYFlyjWDsUZDcLPtf7/PlhjHceI3hQggmChyTYQNd2502zEfCr4jS8NcUAJrYAjSt7uhdobr4XiDffCwCLryp8Y8grxKjeghbg7YX4uUqUMWMVsm1KZlDMtdmPmikW8LcTfLy7UP0T0agZ63ud06XK/AQF8pxj30BEEf6mlHbgW/8kNnCUA8IUG+p3uzy5kECf92p6cA+eIwIJW8L9NvCg+fQQPr0lcM59Jfb9nlb0HjzVWzA+wwrhJtzhkZXm4MhKc/Xxp9zLLQmATHC3JQKxEGclArESASXSak2Cn7vczIlAs51gkSbliqva9kxh1dKeJeOOoVAomaHRaSF260ylgNJ7JOEW/GY/NkZy1eya2l7Wr8uSdgnVvYJ8JbjGxtoEwT1LIRQZtNLIW7wSbrzZ8apWCzTDe6oZNkYyaAOsv2P0o3SmdLfv477/uEFIvQn3KbUnmd3yOn5CHIzmi9PabhENKVwv4vKeIb+9FcvRoKhfaS3rr2e34k7L7dnteAyLhCPjISXrVK9Yex1AQlLjWXv2N61+7i/OW2EXN+UMRrTz4Oi+eShgBevzfMA9Uu8paE1Ipu5wsu5YrmFSPF53iLpDW/fF3HxXd33zuvu+Ej93ffW3/VjNF6rtBH+v8wSR3QoAFgHxLSsP9CYrQpCqCLdV9ZYdq/TvYvjwg/Y99NNf+P3nfM/lTOsbSJSsTSR14QoINBDyfxBFJLewtJTrQ2mVGUkJX0bpDbmYq4xRFpBTDJrNTS54ZW/TpQU0FIdh0FFHM3Zz9bbIEJOtjtasZ7cB0m99iMkye+sn/rukV7Qwv1pU/xZc5I4pwvi0cLSWZW+CGUhgmTqvJj/7QcSIi9DPBX7kZLrH+L5T4qxAfonzgh6XhhtDOHbBW0qJYSN2mvsBaABpmCt2hED8fMJhT3XqZ5TAkBN/0tKQUAcQpgRzN6QEZKBB/Bnk13H2mzcau/RV+Z+a1vymr371uq+q64yH7GrSJP8ArmCMrCrZbUCOFTToXnh7GbET0FanbXILwOElXFngJ8O9NNin7QzxzO4oMp5fSOneUcSwMDgQgxjE0QNKeeTKM66YYyp2dI5Qe52ri4n/GBOyt8qMl7OJg4Gy6RRLve5ChhSInz18Gdys2tL1dXOsBbyuKZqos5AKRUp4UE9m5vzTN2bOI5o5/2eeU94cRZFec3zlv/mkT8pJH5aTvjY54e1sz1s6pfNQ+57PKDDyDiXKWyRTBQI1UkrSQpvq2T8Dry1B4J4k6Elgbl8m4s9H0aRDzQM0oxD2J7bNFIhegS/URmcowJ5RJjEAu7tgrJLtOsBeF6t9gAZuaZkQ/LHgxfh/cbP1BLRpjmAjtgWi1KoQpXlLlBZAlFqGKM2DKOHuFy0YovTCTYjS3DhRenCEKDUNUWpNEKWrpVRHlARcji61Sj8SLeNH4lHQpR889Ijo0jfo0g968GT0eFMl8qEwBsjcKPsRqp9oD5foBi79wzBUkvN1T3BCQ3Baj47ghEpw/hS9plTAlQJcQnKE1FR5l8DxLrg42il5Fv+Awq+u8FOSkSmxqhWe2PAz3qFOmnDMcgOzSW5mzhKO+So3MwfCIQ7w509AOGbHCcefvbZKOHzHzZyAcASPhpv5B0b0V3DqLretF0kyTfVepVo0NcITGT1IwPT1kGcCt5gA9twiqr6WRA5+o6clP2ied2syHGWOytQ3TIYHbEHHTACDA5+p0lRPmvqM6/mrjOUDWKfvCZByk6ZooyITeDA0gfs5kH7B98JJrwJGFeRtr53m5i4UWI540wudN71w0pueS5dUMA6PoAJwH501eAtEZnUsFxGPoL6KGyUYR7eHvL4SQkwNSNZZDCq/93n4fd7afuM0Max4zPPhMa8rXmGsxzxFmxiP0mNePOExL+Jm/oF6zFOfhsiOnSm3aMRjXnW/+RVfzHs0rh1Zl97y2tF1qVVZl0ohXFEvhXBYoVSGXFmk6rKC4btGKcOzC1TRwLVEfqayHm2+VIVmqaqbdaVesfiB7Xgdc1MXIp39rbyNQFI0xJhCQuZLLDZY5BK3yLkgF5GgwWm5ug2lpWhhGzJWGMDiHEmZTkllIYTNwcQuY+ggHm1qXTltQQsprCxoX/Z88KsG6cmtHQlGeFUl33feMXrIdDveVe6tSTIv345g2kciansH6oCQUiLyhvWU11D7KkAX8i1/HVHzv/VUcSHRK5zhGvhCcHmBMQ7ZkLMK4JSvqlZye153uVhwcGCBUFewkcsQcagHsLMlnOwWJfjOX8MfRrEeJqp9mcr62TyOo76UiQV88uHZpSZjMoRM4rAxO2acpDV3+bC9rCFGCZkquoY2K2sovqeWrKELGsL5i1yWr2Hm9jGIqEGsMWR/INv0DoyT1eWzPtnL+Sculcs5wukAF/AKrWtyXKju+8jXemJ+JOwHQmrKgHhgkgKqi+TSrL6JgT0U2/g7QCLca567zZPMMxszdtcXV5xxznsoMVpRh/lWhLT+OqhZwA/MWnWaX8wyEGbVbkVd/Gha1WF13RzQjMSSL3YrmgLmFHXRDMfgsV/srs5gwdRKbbH8x0Yg2iiXUyraMtx6mXZoVB5JW10LA3H0H0ghVxYBbMzOIkJLqrawJj3AmQZIZUu4DVjry/43AFl1NU1wlgxTfncIZzGQncbV1JKF/AJBOA88AlIRe4UjQkhnsFfW7oOhD14fp1TOdgueobJ5QEUUd4+nhSK2ZQ1QZO9D25zFC98R2cCRXtE8vlJMgVkPVCWNVTdaAYVIr1jeCKqWNwJd37pMXkW3CdRh1LIGF+G4IS5zXY0K+VOtanRSPTGamgiDWmJyw/iZUZNAXgmRVvZ+Ya20M7ANq/lA36ZDInSQiCiSnjI8HATCIwqhE0CgCgMss4HalHosgMgDUPWXeF7FGU/oLH+o60Vmjch7MS7SkweHzrDN1UV7QR244UpMEVJiCuxb48nBH4EugZr+kZCC0FHTt/ueP82dItWsv1AP38FrjsbeODX2wdq02M9Pjb13auwnpsbePTX2ommRu13kbY4l26mbbXG6uau62TaDWElerSY7Y3Ccml7IQLLWy0Y8QWY/jqo0QVPVMIy33ziDTM/2vNFPa/qp4cc85K49ytzP02ZZZ7zKBkJUE4gOROnVHMIXNXFXlav45H1zHpgvSJdrdeKb3uCh5NIVcqAcK3hKKTlAM/zsiNWDVz4UmJgNFR7mu9KZcSCv6AQ3KMDcqDozxgtXEo46M76IYcHbA+PUl483v6QuQfUoUI8/uBVvFyLgo5LNXBevv/aRuy7+f1C7M1qHDmF1kI/xgsaqMzePf75HXzK8ZOali5euvJxdI2wi6FlCA/7Pc4v8pSSAJbgpyvSAnVpHQ6i0jqZhkQT0hUJDwOBlPyNjhe3rnWI+EhMc2zsfG1qd6j66mGD7B8dq/PwYP+tI5yfi38PPhiI4zkGCNcCnqXOviY40BU0xtljgUrvkGkdD2IQJzfCpTLp4LAnYjtIUH6Elw+iX4I2gcycY9A5P6s/+wl0pGEnLflaJkAxVYaIxxEA2DhoCtLdo4bGvaGurpYxiBt4f9ZMiohl8Bqstrit5Shwv16D4mXvirD+CqyFIJqW5DG89MU2F2/HArMP/CzUp6Cm/BBhpKQB5Qzv0DpnBLYCgRW3b6X15W5qbt9DwFj2S5l78NWlusllzUyMwUcie9XUA2frxIHtW3pbmfv1ANt4UslSDSkFf6Gr2NswVtO0qvT3zQm6BDxFQggtO8H5KHopkZkMLVKcFvqrzlOp512niO40WWDbqHtpRfeceekos1gldFGdq6gb6TtHySn9zKn+jML3Pq6z+93ujy79QIMdS/IpKakCPpsYenRr7nqmxd05hoQDYabH3TY29pza1ZVNjj04t4dxpWXdN5KwOByDl4DyM4oC34bGcUHjXTl0YsG5idcx+ThZg6BwiMkRkppF5qHowl09VO4rE6XlAeO6mAEtNTTXrsLwk4vBdw10o+YgymBrhFk9tRm4qprDqiDHLayIxDdzyuJSlMDC3rC4imsYVUlPNJAoJwaP9/DzF1PyetmcM51qjic18hpryibrt0rsjB7KfV+rvKpWNgthK55YwB6tG0inte9+Xp1aGZtpdGNFdU9eLJpqLHbf1pikdBLOWPPclIvqeEesLFAPgM1Qzhw34ze4yVwXVkLCUf9HUie4LuyJtde68WtQaSluoaTb3bd6Yde7gzatdMOxyCvg4k2fYFldNnqGkTUyegT66gjAICcCpXj3dOMqYzag5ODXs7oCLNE2pEJAg/ZAXWr8iysySLwwXKvAC8+6JVWaId8Vmsy7+sZBJSC+/R6/yXs1fqGdVX6+s+o7ZlF2sJ/ejtQIpqS48Sp1UBPp8RFOE3mr1FEHZOBS+2liEdKUiCxf8uHvu1eMecDRVz72/9Nrje+79WOBnrKalRPOYp9KDj3nCsSK4gbWpJkpg8X4x/N33qI4das5jy1iYN9AGJAkGy9mfGj7QZU7LozZnLWbAzxn0E6/PnqhZxSocD5w9SvcptALHv1JJOYO2ZVhE44qlrZ5xM2rjMYsz7jWZnQCGcNqy7s4RP1nQUm1NPk8SfXS0unwB0ROtKBY1+mOjhRRL2buE7i3TAtkwh2jRhJdovgwvUihC/1l8zHn4myMDWjwiYmsdROpQA3ahEmNcVBGphcgWpchizWMZdjZ9fRDBonOMSTHt1KRi6RxvLfDtv6CkGmheMb0osyWPlUKTf+RWtTUe6ESu+gcYdfDl5FqBYZ8DFycnJZZ5VnIdK7rXBd3UO3LMk8f5Tq6VRL3qdjh17WyJDaJY5mMiTBSaazwdNdQ6gpjOL9QIB2STkD0Cm6Iri5lezsnUFq6pTTMsNlIjL1pnnEJsCmqrxyst13EMAqCfkmc2E9UV9ZOeF05uqZwz7ER7FmDmQCjqqS95uAHwrSBMEmVRyt6t21zEVh1N8/d5ZHd2EbZ7ajpfKYds4PzkfM0vezVjIB8bsZbuKxN5uF2ml71H2SvyqzbzfxGR/1ZU670noFo3M3Cr1uexNR4WgTixH9yRhyjZDRQEgoge9cFzpYIsWAc01o9QbV1o/aix4VpF2x75BsN1FxPgc445MtSt/3Mgl9jUm8CG9EkPSxAPgiiJPuQY8LBGgKPZl9fSF6C0qXeAfINGapIQQCsn8y8LmkCQgMhQahHGDy8+XiBYTEqpSPpUqcUIoRXvmJhfe81+zmWFVWilJrWc8Iu/7bBs8Hrm1bOv6tnVT/te/eS8TIhndudlIqx4mfAqfia8cT8TcsNA/UygP25iRKghoFjRCeNizlEi1OqqjmXGhHbGhBSbGYNkEAwfX7TU54QUWhfU09njU6ilxwBppLNHHiEekmZmjxK9ukyoyWl08qD6Bqj6KjY19JE5QZOgWJ84rK9wbXhY3E/Sojb6/fWv1u+RQeVnj1A2+69zLc/sjSKIzvgvlLCziDJfObZVvfbGBcHheQIQ3HE1DooOzcN901CPpiGYBzeffUKMqKdIcq6RyIOwwFjTKFrZHyITxcKEXsXtRfYo+yRi81YKnZM7m+LONTRuLE/fO6TmOtfp6Y2INnm4bDKDx1VFZ3+RgRGfdaeYgms3RXztg4uRm5WenD821qExw61/OSQO3Px1ddrXhf12qPc8q1gAAMHi5DM0n3doFq42qQORhvFdAhP6ahg6EV+t4CIW3c34VZqnbA2tmlFbxXB+z99wQKhlosJOnC8fAtXMJHgQwRaCenARcrCmq9wcJdkHRo758iVzdyQqZrSnXF2/9SKafa4BpwVyRHMVBcKq0/i5Ur+BXPCq3jo2mYe8ga3raXwQtKR15aYuODevGaEKLak2UEcFQQk18P1BD7sxgXkT45w5D/Mcf7X2fZ57eUCChxF8oQPDVRJ8wIIhUYlDrc8vOhuyDwrzN6OqBYkrJHRFV7N/SLJ3cHgTgPGBWAHoqm1FCxPq4IWRup4dRW5FG0zV+0O2ZsqDXWdradcUXR6Md14/kuFLnGELuYSu6I+FojMXlg5yuuImdpePZi+ru4auQa0OI5Zb9kd94swI2o3GKeJZNHT4R55sFPx8BoRDBHQd3f1JP/F7eH593y2zWtMwj4jThV/kp/ieRqnMci4Kywn/mhwTG5YzhmMQ1AeWc5HiXtFBrQqIjB+3f+76o3e/7stvfRVQowTPwQh202e0osInDHr2YYGxou6iQeUVPW3o8gzfcOZ0xCbVMO9RIpKKVUogUNkq2hlijs+TXdEikzqwJrFsrOqIfY/EhoidR6w67eeAEA7smSS62M5NYhPdkANhaxRL5DzHFLRWADfssetXeOOtQhGu/Zb5NbIQn6HtdqPHRMMEFdy0TFuyj0hvYzhtuXMesIrFU8st86LklglSpEDm04MMyRwyJvdqSpZsC0++QZ3HoUHbbIMQ0gYF2qC6bVDnkYGp7lrVebSt2mpbhdBIq+YrYJo5mQbFDjbx5g2acQ2aqTQohWt2bQlClbOlTtWHaFL12txywcgFGzD8Xprtr7hFZUWpXqFqKbJPH2Lz1uD3DO+DvEERLd2KrewcBbo+DeCjGFNDZjIvQ/3QSvW7tGg2/TQny2mtHBc3h/gD1fFVaKAHOlt0MhXxWHJAqQKsCMkDFLNfBdDuGGYfNbKDlORO7JCw8g7u4P2OSZqDIPOeIFcjZEGeU01pPXWzX0OOqstH6lEOXZZbaYnmKjQSSXO0dMTFoDrnrHHI/xURGAwo6w0G3HFIhkStDrG4P5swTWsxDTUegnVxgyoveIG2oJ0bLL3LCFgXKFSKLSKo+BiyPAt6PKuUkRkqu/f7qSgyzNcrvFJDLKrcLyzbPBGoZR9UxWc1nJZHevOyiN09WezenjdVXl03V73x3KMXau/yzPtRGzhmA/e6W61yJfT98uRPfH0eNNdnH/TGrs8+YDLe6ZuSDtnALfh0o6JSG1iV2kMhruGHTqXWtCoygbtsYIBAWPEGGvHdSvt+cC+54JU9t5A+hG299jgxBWV4vbC2S33gkQjnq3faE3unXS9uszdl8vQQHaiKIEDl973sfSbbIFrLjVToXLPjLG8/nxlcorae9uQRHntzvR3+0Qj8vVb3Vi0HIKrE3l7GvsPF6gEIBFPjMf2D4Vp2q+5KYnOtVdt0uewI9JtvH1HRDhj71kpWPySjfXQkPRYGs0DUSUFcKW0NjbQ1ctLW2Ehb67LzS/oeJSJtbYjMP2+iBiQ5SSu0E8ekrTNYqzvTpK0x1VXaGlJLXOFHY9LWcLq0Fcp5a5qYz6nja4L/K7DzeMzRLGVVaWsCoSwCkkWJmb2iYnSoIsWnOdV+mAGSzfZvioztil/XL8Qtke5I54TIzhM/j442FN6lhoQUkN/OeMqAf2fxsghfTqBUemoi/IkUypLZid6PSoqQA6DtbJpjFivDHJKKOZSdAYJz/GNdv4Q4icjg7SajhrmjrYSyjcg2tZClZd2sp+NSxfR3rJtREagqbceLuPSbdDmKXMFErs3dj0794KRckeLDcOzDk3BL+ldTlfu1MikUOra/gVKhbG51s79QGrpM9tra1vWC2gDvUOmsQCNE5zgEOWmAosMiHC0cWs0nKj4eK94jGJSMAMSIQlOL30L/wjwUNQUALLYACyhWkBXxWOURxNMnbkA02oAign4j2C0OoKJR6I4Lo5fSyJwLePIM8HSkaff+omEzE7fZigwdM/DWhwIAs6n6O12xoXGgSPvEcVZW0N+5Ru7lIqgWxNmXzLYtxhTBQUGuCtCw1b2RhyW3lr0Z1YOSQQpPzQ2nB4Er+NkR3Bi7wJkaboI74B+dJCJ66Fj5WSZ1wTvarNY118cJTydfCPbapszjrr33Em4CLXCT5tAenCVAzxgTN8SsNeeVts4W6mxJhUxQ4LdoHkCZJxzNOLFFRx3yFXK2W7RVeMEPbbZIb/JQagqrdaDwth3GRlV9fBc1KMWlsAZ1cN8HKycIaAPqF5FqoeeL/DpUffIFiI3kmBGERqUfmjnhR2a0yVdEsVJ8OeFnNwQfBQ+rcLvcuM5lvew3nbblbk5pHWCfAZAQLqnGnJRGMVAhU/+wuaf++4RiZoIMoLU6GguC+nkLIz+DIXHc4HIwwa7BeV+PZiBZWjbyq8Ze+I5uwXdU1aOnAlN5mwrWzBisGVagHFbOb0IDc7D1LVoA6V2uJC/b0Y0xuq473PDZvuJXMbc/nxdgUCzILffztJ96kJlxnQsWt0DnefCrg07zI4gFr/dYHhaQzDiGBsxqA1LVFmyqYLIp1wUcG8IgLSLrP1uHYMy/bkjxmH9dBwsjsgiH+UwVQkVo/OvOmJLDcf+6wUl61g2dZ92QwuN61g2dI9vSna7R3t7Mm24o3Q2Y0lZlq8aZ7ow60y2WaXlQcag7Iw51Z8Yd6nL/aQb8Wx4ah7ZNPdBqU0N2M6omDSpxQLBfZVWap+nyHEYeNecxkk2FOeXEqZvlrStokalWtKWaqjmNnq2VEdiubJGGaZQEbcWJ6mUXK7hIguYlqHdargc5V4+alSwlbGkKoNVtGQopVhn/zAxYZSs7+/M58ddRsFialV2oB8Rn5454JHrjDVh8DVe+lQM6OxLyxcXHNYVgPzIXjPg8FzAHM0olNK++JzPViTH+QQT95xla4qk/n2l5VQ+6DqFDysCIzohK3REMZlup7QIvLTzKMwOKBs5eNoW3DmlBeTXQ6kxnZYb2zOMxT00YkW+qx0dKSDRW5/CYIx+KPj6leEvtpF2trAmJMLz7brj7N1+0+7/fp+u7oTLbqE7Lw3x7ibl3XTTUsLas4ElJSmxEFymn0Mn08oKakFHs4AyvfJa4oXnVpRUviXDDCG0YJVFQmYdsQf2zZGRshF+S/ZYybmBmEl4TC58hVGligFw3ejr+3Eklcqt4vyKfxePb8zkpKW/qUKlDCP7dgY7z6ks7RGQfix2AOfSjLawxHNgpZewnILWhEEiaGZbjUCxgXKaZP2v1JPOQQWTu36Oyti7fzeo3KM0pH82DHFMLo9RShweiLbKMGpfdDaA8GsEtVdHydcs1KsWYpSb8LZUts6ncqx4kRNwxtFMQCdhIrY11aTN2irdRaJQ4IKSCCGpGEJsb6AP7TKM7qqWJdjLFla9BqZBfyXpKmebMBKyUiwoOvxqYFjNXFq1enqF44kDo+I6X6xqYyqd6OHEAXhbhzQe4oTtoJ0QaEjsOxRgN89CShVYplW8qDUDtoRuLW2ERaXN2qlbFajC25lo+haVdtsNe0TRXrIkr5xZgNzdzhxCCwdCgAfc4UeYLBLYAtAZDEZs5YdbRAQjAcETUNZRWDjhnF0afBqo1zjyAh7FRjQ3VQmv0d5e2T31WhphU6Oi+6LLysjDJO3Yc4lOpB1Nauh/wVeSJkBV5UoDJHIzYiMaHTHKMfgXe9kNUHEHL7YTFvFCLMcf9HQT0wgOkuyYm+23l8TjyZz/5M5+syQGz65A0P9B9jkf8x+fLP8P5UAs/zri0l30MBZQNfPStyz6uB7ufjRqi1md2KXF1p3LQ31/UFfz27Mwnf5gnQnQitKGBR62ASpSbp1WFIbkI7QYfS7vVwyRPL19s5B295pKxS5h8FuEbvXxOTs3FM+dCpTyoZz0rX3Qx8A1Wh2/F2AhY6jiPowhnZfP8EGoA0UdTXwYw1jHkX6di6YJ8lziFjFmsDqQs9oW7Xv67sveQXzRwAsqXG7V0Rs5fOoKyBiO+a+3V3UiupjsXNJHxMx6jhfh+jjJpN4e5n0LmtQaYS8zwqrsXLTPRMkOUSUqcRBdpEQiOuaNVoHitiCIuDhY3XJMBCQGqOCDG66YNpmUeF+wFMC/G4CqXQWgJJ6wtSsvaVI7fGisHXLOsA/KcB6+NVUbUT/UgNuHDgDzFS0vV3lKZvkn1MqOoz/IPSEuxRFwxS8Xv4BgVylPLic5FJXo4gGVOtLj0o/Elz8ctZxW/Wc1L8kcPBlQDwwjnvNG0IhqVQIUjr/rVPRMlwmrAbfB4pZckNdvRycIZ/rcVEfEDgnkK5Qlbd0w1XMWVIGMquP1KMzSoifrtIP0vxlzLYaWaIHU18qpW8GAqlnymlTWYcSx8IAz/JC6PKHpRbaPg56DAyxEu+c7Iq49qhamgxd5sDdEr1yLcPfU25FgUING9xNBtEfK6qlmN7aN88sb2Ue7ap/rgF3pEfgVXfLOPSrSS3B/fR0WacJK7Kd/tpnzyj7ub8lOKHTEoN1RDnDy6FX0woNg1V9tyJI+k/84SI5BqotcASaKZJP57mcU7CXjEI/BIRERQgUds4REfHx4xxScPj5jhkbjdJUVkUSo5OkSj/Ml9jy+WbobcBcO9n7tXGOWNwvbnS9xc3012FDNEmwS7gXHcdZjBGMoEY8K2sZ7+4OOuRZmY64Kn+6LbG3C2ij7l75xAn/KfgyC+rn7tZgqHQanI6PWDA+AGxDsp8R+fTES6cxDZXh2Ckf15UjmTdcjQdMEUUugRHV5yqZSuD4umg3dagXTqII0LC4B0m3zivyt7iBgMYdXAgkfV+S27vrB3yFkaA6hiiTGOgfIC4uxS5VYhpAhVpU9e/nkztM41udNobhGzjxI3g+9RbTEj2jzYcPLSgCWkRh1bF2p4jqkhoXBNDInGfMk7G6sum15dtmHra5f1taU+SARNHS2OzVuIQ/VYBDEelJal630y0SW0t3HTU+QWoxi8Njb4dJOINQBMmyj8pT8UbKbL7G4oB1YlGVLEiDlWxxdrXHiZiYv49UAfmqi4jnQ1v3FQ1quKImygirAtH2p6n2KG02PxOvl6bMGJFAgn+kmkUKgcKWs6Rqot/Qd6ZiDunk62zlDrRHtHtaxZv9Lrv/RFEH7mkZ0IEXJXdK3lpKOqa+0ZXWt3hx/Hp/pwF3WzT8hho94+iYT1Rhrq0uvnY1rYn1QO+TYvCIRDLi/1YggjhGCiJEKHMLA2KY/VpIfN7pUKJDhXhWI91PdwNQorjOhu6N5at0Fg9SK7eWtgxW6YXVuM61J1oFTdXHRJz6uqUgpSaZert+cnLiOkTs1TNiFQ0/z4uJrnPdPVPHUvk0yoI7//5HVsgZ6qY6uoNqljizy6DXJqtop8gSKfU7P93VE1W0uaY0OaIxDnaQq3IU5xDJ4F9pgiAKWoqN2Gx1O7jTkqKK+Xt1T7NtFHiIekZceOq3b7e0h9lOrnvz+ufo7OlOrneBlTP987Tf28wBRlRFl7FDroquurw1jV9UVLVNf30fXsU4+0Z7vLnoXZH+Ljr0FPnl8VPzwWGxFFaKxEiCURMD38kVOddnPSNaJrG/EiL5T5rnLhwF53LG9cyX1Hefr6hD2hA5gGmHExsxOC2SaBIkwkfc/+WPXYhLjGSl1urwcpU76F68RymiodP0+vherd2dJPImSNFEFnoq7HcjgjlF1+guBOtb1ovAS0VJ1C4JZSy+yECmxDhIIFIAmgr5AvmUuYkBvA2mw+Q1HekQMUj9oyyEg2D3YABiNaxjTtDB4z1AENVaXPkOo4RldxJHqpboZ9rRLOFWF09cevKmLKeGvUhjRC+jxHobpgRPSMKGcKTIo6yQc0s1ak+wujTrCAEy7eUi0iY2f/Wr4kJmBTvC6zsL0rwCi2cMWSlVrMnqygn9Th5AY2rl/hWwXX5D3u5+J+LhP+0amOAqL9EPkD1NvQH2qLo7W1wsBpu43c3/+BNY1qSlStH5t34oK+WrtMvLuGkrUoaBaOGBK8PbdX7KC6Zo0JjVzRl53CvnBVqcKrp1hYo4Qjae65K0S4xCvDk1L7shWa4RmgQ4BnRy6UF9wPFe55tBMaubSMw5n5texPdOYCHii+SxHtOICBbEBhXYrFZJ457mDrgWrLGOIHdFHW0khZq5uXde1UxMF9R8XOhPspj0K5rpxf6px3e85PngRSblxtWilgmUFxMwbllH2gxAAaG39deLZThEFs0DYgAuGNiM9zMIzGtUugs/NSz3ul4TsCp8VhelNEaEBI8vDQAM9edAzRyZB8NMdHSdMZ09o4Y3oEbmj9a50WQ1S9oH6XX7jbJ2cBCO5ig1VNVG2aTLUyFoo690M/RdWe0X6qWWZPtu39DOaGIhB6okgNONVh2u5Y7UV8v7EfvgzSTYrkyv1OCZ3Foa4an0QFMIesBzOGVoLH6mKZ+XNZZhJRlYOsDBtHcehi5NCWPER6joiyW4BHlP0kVg3wAohFacamDCf9hUHiuiwIeBiLNIHaQtGwMINycTqgRO2rNERXPUAziAMcaz7Q7YN+hOZFpBWrHh03z8nIj+8b+YXTfSOrZdWqp9mri1ionfM0e4XzNPvyx+xp9gujpiTiqplRA8W/nGoLtC63VEeMjdadsdH6pLFRly6pAOQjrgaY3FkrP7nPGR5lKGSfcYZH6zK2algA455kP67WQEXXEg3UfKp/CCuj92KZB3+rZkZHcCZyl7dGzYyG3LShFBypEy5kz+v8pHDUzGjslNl+vhlBur96XVDR4/Xc7lI9o42ZuXyHM3O54cxcvgdBJ+HXPR/LDoFUIO+GQeI+LaBjmUxVTHmKeUmUS+M+jPUpZxCWhplrCDUr5fJVY9MCKYdC/oo5v5Rt6FB6do2NWNcoBR1plXQGuy91t4UPCw/iCclbyHWmBvKfKweqbSw/WJP0KFOqWEXybrWCT608po4xbiBcCwpXebwl7NYAgbuRXR7IopEotdWvvxSan9CNwvn6HLX1RAPaKjR7ABn3SoMW0YJd+VLfE1l+l/+2yGXrFdmUMuwPirbxInX7MefvcS1zsrL1wBz4eQ15+W8rF73CrcKXHaXhzCms0tZ+IuwBSstjrmbGHFf7tJ08budaAS8/u/n+xlHMELwQv9xlXzJ+GeiLXvNgofI2rUDc45OiPs65ZesvXvGJfFHPqFnH+NYNvrIC9nzE4wbPMOpJL2bkNnlNTouZECu7A76h9ZxyVV/hoPZ9G972i8/4mDs+Iz3aRisUrz26TuFa2ESnALVH3i/0CZxELNw3bdf5OU9bZFTiCsBcBShPrG9rySg2GC+2i2K7tKwQS/ItXNKyQmye8UTVOfgxSwt6qg98LEBtUpkO7QBbCA8o9+zcE5C383iKHn6eEzeQ1AgZ5RTjWRQPf8Gj4uF/9rTfOWFTqzMhU07Hh04t6msFKUOh7aeThedUoSI7AIu+ZxCSBJQ7OAR6xMB6idwc2UEevwrcOADOCh2KqI2OnGsnNyvZ4n0vQxNRe6jBoewt4qphB46QaAdrHAWpkc5RXUYFRMlzFk/+kw/bDpWtFjap1e1WSKEyEHmEV2Vc1qCg7zxkVOV/6bs8L6qYAox1DamrkarobJHsB0INIY4ACW1iKKvmAZuiOt74ZgTPrr0D2upf9a7Bqy4t/Iizz1YNB6pEBK8xXtXkAwwHxohwhgPxAmvOo4YDL4PVu7ut4cC4f7s1FhUjQyjDreZw1M6OdCO73xoTJVTHj2DCjuBfPQo7gv/H2fp7bxqzlI19xzWv9RzffNSrMM597KJB1YVDZpPxVUXUq0dfX6iZrnDG3Z+nNgPlorDabspjeSZ5Hch3IVBEZAt34lm31uhjY41evAioLUFIqPTGDEDBU1qen/cYJyNwE3zzWHyTihxMXKZFUGvL/g7fmqz204bNwTdUhLNtViyGp4jekOgWjo/1IIHUHVlJDsTGY6/Ui9rJ66Ae3O7/JXU6UKTZ36NqcYxUZAOa2ffxp173vW8bfJbrmKW0tGE+lP37hp5wTdMJ2/etl33oN+7bFu/lw4257O/kOneivSOYikZhrvnzmgNcx8JG0TYplzPj29CrohvcwzZOPiAdkHujG/tesfBz3/znP3BjtdZicThwvW3bGlhZpj0ZjfNcx1ZT2IPGEhQPpG/MenFLhu6zFFavjxRLlK2/tVIjXyHL2N5z4fdIHNUsbAwZ8Bnx++LQdgSsutUrk0HAHmpscNh2F1fuug4Fcvxd2XuB+lF8wFjKQuQLeAV6Tf3Sa3Lfuh7yhft90BuzfgfHreJDz1MO8iHZpajhu+wDN5oScfKy5MaDOmj+rGh6zHEw+wKqlt7pdZ8MIZ/LwdmZr4IrSexDZgQCvQ/PAxy4GgEctTF+Ha1dhpai5dzZfpL9yEGLF+euKTSsjvR69stIowhp6NNDb4Bc8T2CpTUhv5dgDwWBdLBXSauVx+MjLPT933wjvnlX5Zvnld9cPvqN9EFbVtMNqZ9taAvktf+JN4yXRWVZ3fH6+121oMV6tnUVwkqR4WiRb35URSogRbXXFQhqnx16jStpd1nSromS4Kgxwl5B9vfZl26UIqB1q4n9X74BDXur3mzXlOyLZv2rWSv/04kLdSjI/gF5UwyCN2Yt8fYJa4nTYrE4QqasEugp1p+xcxQrip/XfaLbkf2qN/KFO5X2MDfEgKszH4jYz0+NvdfFqv1Bif3E1Ni7p5bw/ql575rI62U/qi7ufNcJTGUHg3/1/YQXOrd6Y80ctRZXRBJW8qI2f/WGWmksKY91nuv+FwtaHqkR6aJuy+nazaPZOcKlD2z/kaeukAplrayFuYa2ponyE6jDJlK7mth39SdigQ7eZhDX9hEl3JFu3iW/fjYjX9QJmVNkhrInNuARcSDCeR4CoIpalkdYFrVvcpsvNdVqe5roJP+lrnYmdOhmTEnewJXcDF22UACXNtqvNL0n8CtekGjEhbMRaqlz4YrzX65Brxh5wrIauxNfAhKc53/XyeT9R3tS8zyIp7LS/zesNITHWXVzJzPCAYrbB3igblWtIadB4mtxpYbMsFSwGew7uLI9/urPPv2o6CdtcnNByybfOQdVLRtyr3A4qhcZEr3IUNFQosTVfISS8bsMdfKI/3hn4aWuzdNakwsOxFCqiuAbhfv7XT/0kX/c9V1/z2CDshLuk5GlR376PdNJC5lFM/snjEHJzf0z3lDvmFnSml621tsJYPSqxOh17QCKn6nWg6KcWC7uv91bU9ZOGD1dkR8ETcjrnKobAnB8jBpx9qBw/4m2DXsZlYWG+JFbTElpVg4THePhbtbyXwcpejQEbceUEQ0ncrrxQhrOjjIwExDoiJ1OvT17hFrrDwV5lkpNuECbyYQHmZg1tdrmJlAjlzu/s8bcH3Hgsh63/8uWgxDfbnhk1LbnS5x9FkEmjqgCUqA2btC7kwfta4ay9ZAj5lvia9IKrVEgp005aBNQm6Q9DLkernvkc9rUa3Wr9VL10BUWmbasrSJEXJUwF5KbHG1vIlMNMnW0cFZisSdeWBOx58wG2G7nTgF2Blqq0N/W27aMkAL7++vjwNfSFgBtGTF0ThZn2AAkn4sV2biy0NpQ6jBIREFdj9Fw2pNZ2+YaVj1l3Y++HD8vBX6BL4htP87loKsbN+Bj0LRdJLYEaRHCx4XnvKRYvLB2CRR3cS5w9TVFG77PpfYOYmmBFntwko5wZz98pMe4Dr0Xnsiyf9FJolXygNut0IJhFGPYbGofEHlhm2GkVjfRBWpnf48uqyrtl+RGkdpt1JsG8qniQgf3zeYUF9uKmVlqbiCjoArWkBbmZvfqWvavGjTWxFYROt0Pzw8IM0LxJVF8EXjCFjAGyFGAc/lCofbQCkzBfRbL1TiQponZ/gtWxSdUe7qdZykEgKibzVXk1OmMnmM+Akft5CwW7ZRaQIEzwNYFAQWHKrpqI8sBqKXOebnboUix6ESzjIXr0MrCLUtF+xnGTr3SgGXXbDD0a0TLLY7MTuQ5DMQcSTc75VjoliErZnTnMM9dt6aQlvBQAMywNeAi09unc3jbg59zi3QNxEAmIGqgFOFFmUO+IT0gdzherNy3TSFRTuV6KmCHb/lhPpvInSF3prmBTjzk3Np5leXouhDqujBl49Uwm6622XRlQES36cIcG0ekWFFT6L4yh5igo69Nff2yeU1GX+sjr2ihWYhW1XzjJ/HCXNx7Pnk9y/8TqcpLD8dheF0I629VZ1WhfirmsXSIIjNnI7u5i8zmzmB9iJye7NCzL75GYw5mUNa4QwVd4iUGBDoTP/Y7+2al4wgIa0LiSKpo5JYMzNGL7b2yi6kuZiTcXVpZ8yL3VapewNZwH6LqQWFYFjF0N2rHNQtVx/6g2ELVlQSsYiVPYhTF+plkwcmMkGCQ/wPm9nDbnn20GCkhAlYjVK2NvDFqDyibel+406PGOu5AuT6i2jzC2cloPyOIHEY6yZ9WeqdKb6OddMcqVKcZaFdmleSsPOkv76RnqqCyICZmscyXrnwShOSEmJ/E60ILkJeDKUgHs4de69wcPqxHggIMVfJr615kxFU/iMSqJis2TCbvqyRfMpm8p5J80WTyWZXk3dVkCiuert7mlY5rsq+g4ZN2KSjQlOPYonCZTsr+BIWa+SRsTtwZBeG1EKSPHRcybCeuBzhHU1zohlOXx20II9z7J7gcrO4JMIwUW549mOTZIwqGR9x1uqPDMa49oGCSPw8UBMYahBMlFlHF0kVd4VtpmhyqJeLUzRvt76b99Kr9bNB43xrH7VvjMfQNPSEPqjtyD5Vsh3T74alR6DqwAPcvxvuJnbbixNd1T7Ejk74WCR88y/zmAPo0ial3+V483TqKUxp1G59CVevUIaixqF6nSG9g6OoG8stxCRijxCjUoTCjKip6qdlXlfCMVaFGwmPrfaWu1UR6UhRbJqqAiSLrBsJ8qscpful5IDsop151NKJeeiEdra6oy05R76J5qtahHkb05KSlTdW1umIf50olPaLJ5gvLVQSl/oNKWtk2rt5wFDAzapW7ONWIRDt9p8GH1kN70qk4/XfPP46R5+tfV70Kib0PV6MdA5cEaDtz1+Sx2lPhqeQkNGafDwdeVB31abr2RjE9ku1iPKJrH/FRDsdCVix25PZrG8yJoMyTUPWA1R7RSBsi1bh3tsh94CpsC5v7q6Vt4ai0LRyrxv1f3lAqPY/UWz9xvVAeQstHte5jpt77c8+I6FEkhRV9+xjNrerbq3CvanI4lFIFsPqoQVfmBqdvH6u+fSQDpUdkQVUT+jPIW0tf+zhf1uHFEh2hgAPVSzo/9LrjX9J5lIr1T/S86fq5MCGT3awIq8q4BsU/1wpDuV2QXDsVEXXzERrOVidYhbuq82tirO4vYBKBuFKDTzsQ010zPuqpjvMZ0CMKYfVCXC5+30tyvGK7YFwUV+4MYXfJwoLNRXhwzPtC8BSQTRitoRwYffInbiICcqecL+dDzkoLRjsZ2pSvViwC6BWclK3zuqgm5md1GVLl5Zg8bRLFapKi6FSvH2ZTzbg0J8y4NF0DZ9UawTDnn+o5G83IdbtZrS5vyklY5brdjL1uN3P863YzuIdUNN11uyY1N71uN8PX7ZopdaZeP8zkQ3f9sDN5/XBG+t+Zfv2wqpY1q5nc9cMTw6MzAo9ZwKNTgUfHwqNzfHh0qHPy8OgwPGYrgtgZmq1eP8SnExxDU5AJU2UwhEvpK3Dc6HQbTWjf3gHE/kM+Z2aL3HqRrW3lq+ib+kvZKOqbT4EqcndccOYxCr+B15sJv2es8NsfFX67V/ItC5ZNsmBZVfidjQu/fYYv/zGFmanCfEprOINc6JP2eNO5xQ7VHbrCBkqF/fdGoOIRp9pWdyZbzYgGXNiUcWSUmmihXvXD2U1nMFAkmKW2axDVhw4W8Go+KF9HNF4ZOXQ1rXQmb6p3MagwKbO4UdjknVI00zpftmkBgWyHMI9QsUkfboi1jIRiNaX5gIov9I7oHEi4dekELLx03KbhvaEXVS9tmxUOi0QwflUblj5wSWTyqnb8yK9qB8qOwaDY6NXkUGhDUL2qXTErVl4Up/D4tIEbe/JXk0O9qh1NpZXx2FXtaJJWhmr+4sRXtQPN5GjlieERjcAj+De7uh5U5m1Iwclc1fbtNf/Sjf/wBenpskEm66BT3euAdf4fsM/19O/re9kN4ILSx925jYp0MS2qfN6rj8/nTTq8UEa0ehPys4jY3OHFzb7XOLmbj0XI2y3nXcR3Nx8rvkX8cd8iOG99UPl/yI7rTk6J28249Wh7Tq6ySBh6LTdvWL4+psjy9T72qWg/+XozQQGjuwaPGronjJBBHiEekpZ94QZ3ozGYuNH4LgXfPVlQvy4YcXQbaZ5gL46Q0TgP1+fq6jUukT0KmqqbR/3PIk/RnInjuOb5QZhabcvCbukQTq0RXXMzumneeWpGWNS1V01+tKLpJZgv9MghUCSMTVzR1hhXTzEjR/TUNhU0FUKAnv3YG2tSOtEk2UVpk7hOLayGwrS1qSa5vKb0keYSdBFC1wL5KEwVmpWeKjZWO+m66U10M65207QNSqe5J/y93q42dbakCZ5T90TzRc/BdUoTE5eoEU5HREpxNVSzc2finL8IKK12HIBwEA00bwJ+oByDxPWsZfuajn6TVq6RtqaMVDA2UkJDoP2vxAH3VQXU5Gc3gtK0fAxls7/8LQK3UK+kGNHya5ADRejra90HsajZKd308ZAMrxN9G4GHmje89prRMW3g0amOKeq+HmdwCFuQZRPj25yCxh64JcCuoQfnk/CuVauTL3Q88eHUMTexHMokm+YeazfNVCpPcRoiz4AS1/YKxqaYsU0kzY51K0SRU7rVpMyc+WvtzWrt9tOs0i1teYgPp3ULsaF2a1azoeXjDaYZVzm4MtO9gOrTu4VGjPco2aRHqTSB6toj/XisR8mUHiXmw6k9SmyPkE37j7ZO9kjLwDZJe6TVj/VI+zQxSgr66cRlNu9gbqQKVKkFPa5ihx0Rv0ov0+pgoRROdvlnx0pxZfOvsPqqGFLTD1JHvQDHidmTbj57atXZMz7R8OnE7NHKqDZt9rg5ZUFRG5k96eigcP7q7DGkp0jVMBVPGXdIjgj3hh4w9dEdSWgo0yEQnhyV61GjiX49otXmTECR2GD15epCy5KvJud6g3wcCykKYYPMs5HPVAIvFxB4kPDEfVyMp34LKCl7KN/mIlHSVrg9zB+HsZrT1j80RAW05FeXLmNQKtLlMtFY9X4xSgJTxcI6NQQWeYLm6FIOLgmPaHTNtUXEU0ih/VBMsuqYStluFTQUMXEsCUnTXSMplRI95AGrppmaeZJKh4KxttjPdDtvsSSZVrDriPtCqzEfOni5rk58MdJ4bVM49lEw8ZFpUWirCUa/0IaGo11JtCthpSvBWFeS0a4Ek6Pmj3UlqH6hDL35ME3v9oJI8KqyiQESBxrWlVftqEZkDhn0oAZpYVG3SJUgZqK2KPfB36LWNWslAmIZVJP7wDv5Diucj7tgjZES2pjf/JnuveqCGxHeI8Zan2LTUBUrD70gOImeaA9CNELXwcgZpPOnwCuUC2uG76+BcVfyUtRxGwszeKLJdYrQVHxK4Ugb/9z3Itc+w+0XIfj9qO9fIlER8fvLmJatiTaAKtjEbLmp778oD7UtEH5nbxSyESJXWBqqJ09U0m5CGo41w4o2Mr5WdyM6mc1hm3OtVJvAr5DMZaq6PgJcjsneJKWjb84DNVouXVBGPEZDhSSomFm/zX4QX+o1+LoULdd5S2+RsVZnz++wHut2yHYolrJR07fg+FFNNtbV0oV6Sf2gH/hyuoB6R3cDbrZByiPtrCwLii/a8rjwSS1CSQwhO4pyoNF78oJOmooGj2ZRoEhBNc3lNl+u0komQopuYcWcktucAvrjFRX1alXjFRRxpQqUX2p26Wyz4goFPMi/XhlLf9MPPHE4SYHbM1ZhlzMG6IE4zDPVdRbixCyQURtBqQi1g94a1/o4HNZD3UCbgY64zAasGABV05ieS3via66iwe+KF771uqLnQ5bKG+AF2tJ4soGjzSmS0apQC4Bn6kjLCYWHAR+gqpWFir+NC2th+gdJEIpEoO/lgT9lkz8TR9HYFt/XIdTTdtsQf2L1DZ35L6BI3+tML6LKG5A/tvlNEOMqEosMOjFNDbG7CGg/DsfaFE20CY/QtEm9ZjtOQNV7NM3lNuWPNFj4h8C2wX2l1CVynVXWf5QHco0d76lX7am2TnkgPcbTQ12t1PAwnrvcETum1XULiYlLNLm1KMdluRpc9lDoMyZnVO05IOGA6mvexB4xa39dz+puGRv5JtJqQu3I5GD5k4N13H3+KIqF2gp/FOphVYakLMHm+OU5kYdfgbZrlq8ArcBae+WSEOFGBiVMZAtT6UkRW4YAolIxtZ4YnfuQhCK0HEDN5Vq/ug6mmMC69gof4+vgBsLHCGsv32HeBeBjopES2pZvCbB5bAlvC6kotwIrIegSt6+TWq/7cW6IlS821zw1GCBfpz/k+6He0/Z1ufWZNYAvUK4er54ZIg9tVSc0hYikx+30kuTASz+proPceJOxiEezaqxj+TB1FCqaWM7wghvmkZ8Hpl5tRSRv0ZRW+CfXikRJv+2KMoTpWyt8X6AgqaApBQY80sLCH6Gr4ZT1sqijFumWnxtRsJrUoST3SIu8btMi67Kkq8NbDvyy70fHGy21fM7QyWM7cphMgBK3i/xvNbopdSD5GOQQ543G8XFknLrMoy1zY1jdHY6PoV1VCg9j6KF9gbRPwQv8llYFx2lVMK1VjL+btKxhx1W7o5vA9Mc91k8jXxlfoJLZh6iFkgrcMGflQ+5VaCzPKAAjAswhTGVqgYdZYwgZK21GRMKfj7JvPN7YwAiDioEx26ZnizJT+osnb/7xWK20//iez35syxTzj8gzYf/x3ZyXQXnruz/bctYfD7+uav3R6vpEqu2ziZv1/l3XvUgsyXxt3a3/8OuOZ/fxzUitpf/j0VhH/BF8W7WOiN4484h4G7eP2J9q+REfPkbTjxjBqqlCFGltFf79StLm66C6oQ6vbV0XvcL6FfDc9UTUlOsKmkcWE3Bkre1hCWRm+4Rr3cQ/+4wCe9FQ2R2i8pQC3M1GHk3Nobi4aySmzTGrGtOPD8hSt4YkVY+Q+KKjfs+vExtAKN+nzkaejbtOm5UNySzVRlynZc51miAobCKIzXXdkVK79I8G57nKsc2b2yGLFU0aVaJ0EZncUqph0V4UpgiXXXBVY5BnqdaExmRDqOeofrIaipmjBecqhWbh2sA62uogg7JvEBPOoGlLjGhjPVVrRFaRTbctMKhUU5lffRcijFUl6loWKAPGLvN7+LIRANWhGmaAhKZnrnFZ1c+7gze54FU9bZLzyw7AGHU7FH3ulJbM2pZ0rtnY/JIF5xOPwLvyLXhQvkKZSeidsIrVk6xiNeVC36JdN/D2VaG32Irie7TCg7hlOMAwZvyyhVbxsgV5sryGB2yHLuXztFVMGM7TrODCALgw5Py18mUgQw3MYMTBo8RIZ9YQXRXXoTqomQxp5doHR89WLl+5NI6n2eE6RpBb7tFWaZWKhjJpxHDUKYZtAar2dV87Vg+J+fYt47VsOWJrqeHN+VAGjCarvYNmjwwnK0Rfl2irugvVeb6tH8Eclk5J0qm+AAiv5jm3Z5ucvdfl9G4bLhgKAmyHHRJj73mrJNE28C/F/nwHQtfkO2mBCtSTn0LbORRy6FSeQafx3y5srZXYA83tszidrR1dTgHhic13TqehcYU1SXU1BaWtqiu4H7ukHxJTnE6nwwLTGSSZ7euZ3L5CdVDhrH+OFrVArr4WXi0XLjV8BYczTt+mDvKLmuTzJe1yyafhvZJvgSxHILTn4YX8LNyqHIs7m4L+AzVAX5VumeNlHDwzP13GqSb2rU6ns9mGFMxHpfzm8/tZ/E4+Em3sPODZEa/RWthRFAbiSWfkpxMwmOv24AK7sEK3nRiUU+lUAEM7q13hMrW/2hu1W2Vta51S7dBJNR6N5WFzzX/ELU9pR77IDWa0UYHYdtxjlTGquca7kUOc64SM/WgntrsxlHJ8dQKk3edyzMhWy+EVbKKcr98x3qYy3dP4LT+NdmFDuIu2WkHeNjUXvI26xiskbrAJWDsAB7rN5RF13P3L2QoFgjUxdaBn5mGNxI9S1fpYRjW0dt5YKuOVm+sGbNZk6QXV0TtptqldvHUptci5hDbO0BJ4sqXqhS8hQkph2lRDcm0kuVUmtyaShZrlC2ZZVkOGIX5qYo7ojuyNsopvk6U336njxnBasLcAt9pps4BbgHP8qL9USNYS/8FEsHBZBIqHkreiLdv3Y/1HbeNkUQeCaGkt34VWqGW30wJg+mm0TQenoF15R2kTzP3ii6JEsTwTY7oL4kPWV3ziaFgqKo3kjy5o8yDy8+6GdWcEZWg74rYL4hSnaZw0UEeSthkL3nNoBq+Va9JFPOfMFQiam1hKToVN5xwl5rTTju/Wcpi2Th+mQmC7TSF9mhmKBdJ71WMjVszpAOk4EP/ttGOB9Ukdwx5/LLRLORF8FobiK1JXIW7fLpqzY7HjazYW2ypjMWfG4jSMxS7E7dI4aaDOPprL56UZp6nkCv2DdevT7EBsk5pQxkhNhBiinSh1p954VRCZ4VjabNakClDDw+4rtpXzYLvOgwLTZhcS1UonlvEOY+8iP+ccxE6jAnTmZQdojplA5ERDF3MfoAPYAK/RXQGu7NaqnVik7bACOgf6NjdCSdCZXWq/dBf6sWvEIf7B8vL0X3mev9km/NmFX553Xk6+K0GT91aS900mn1tJ3jOZvKuSfFY1GTtJvYEL6z/2/jgis7XSPsmPva5isN8VFI4WVPWwfXb1co4dZRRrJOjiTs9uXtOvzMXN6+JXsCX7V7AHMLsHHQSliZNSPbJ/lM9lSY9x7vUkmOB2tQYbolONU+1nQT3hspfkaNb9vGChI1gN28YYh6/GBzqGScszwhN3J3AuZKJ5hgtvF5NycvPC3cVT+MMF4Q9jwhMnOfhuNz/xBdE0s52LnJJxDjxrfd1npOhiRhn4w3nw7wgsIJFa+TK18y55MDlr+g7vt7js7tESzKjmK2wRL+8pjJTlxh59C/VgJ1X7goEzT8CrRj2Aruj1HwxEZjuTr9JyvpW6+bZgr6G9PVsh5MQ86bQCvJDhE6inFdB2ifiCsbQKSpfhk3kiDtjME9m0EXlP2lSgV9IW1L5Va9cKtXY05WtfO+9EroZZ2214sG1eluoVq9qqVbQI33BsBFOmOdlG4QvTWHy1wjnqxkotr0RcxyxECzI2hLMLfC2sfa1sX05b8TbWRHA12/sY3YxL8HLuHBq5ChK02g8MvIqyZQVjAwcf0MYJ/4fJsxv9hElQLszDUoNhph5qy3PqKVfoEIVI3nfQDjQEjUObBLQCRWRZkb3XuIndrWjwKsBiWnDUtICkBdIXzgPIoh8FQF9Y0C/3DwZrOXbreHZpizy3UJPxPGD7KFhNA6MucZmVkHAaXExfirUk72G7PzGRAJ0pMxHdPeybSXvQBh7wTOBer5xgq/3K/OLWb5d1Y5UnGM88N8mycpJtBxiIRyTv8afbCSoYhLHKeLLOCB6s5AWXUCtW1Aq0ZNMaeoJVWhNJTQvUs2iyjbabCqk2hixgkZAvQz5NzsrkjAht2oo2YRBIhMZ1rmyrIBQVE+2omXb0NmtH/4WPW1N6AJE2ZQVTrmYJgTaFTFO2CpqjmV6+EuwFAKfPsm2VWUbHn2UA8/hM01m2gjhQCTXgTQ1G24TbUM+Jev93zDw1Wo35hcxLOIvo5UvQmLO7tx41n+tWp9xOKmwdwEbNE9NhMea9vZwLC+C/KKecFtCF7SDaPUBGUtmxiMK+WBQijmVaEk6hBU3IF4gBQHNI3knzJvc8Xk/hWM2DbfPVoNuHr1P2VfGgMkt7grOzWk5O8xN0tZxnOuqz0p0FO/oO8zCmWzcdUzeemRvPsSGjscFC3FbJOU/zZqQzO9LbypH0DOaj/ukjqqOZUiSsC8Uy0SAr0HCNw5n4TIFDf2v1bBBYtvTDng/vwv1OzkzcyKUwFwxdMBLlHTEFfWCDbJ4r2D7vsAjhgtsHh+xX3cPK7f7r9Ib7iMlgay7YSQ3NXaUvXLxO0b4bN578V//wVxc+bbjvB17+uz965lt8rqSU2uqXsC0xSH81CZvXea9CN6wZZ5iRcEcYpNaPV/PAXpAHv4twF75w4Y3AqAPoIUwdj5Ze08vkHKN/3xC+Dh7Er172bma3gzOGiecErKY6YMZmMYeHu5R9kqjGsJofUDP3wS4TJg53TZhHC19yi9QHY0t9W1RTp3ylpelXak28LRIK/Th19zV51FlkXnQoEAkR3rrUkduVlLEwv7Ne5qVOxdWyXn0NarWrn24E+b7cS8fq28ln9CzioMd/nF65tCzHkTD8XLkbzGLiGTWtyag4Yt5uBjY+7/aLDkTLMlZciYZ2aigqHXC3sh8HyNUt+yrNXBBoPrjAqF5Q1a1HG73m6qiNDmdyIINLsMVMpcMz1Q7PjHdYm2P6PJN3xvo8M9pnXFuv3A/nPnewzXawkR7npsecKADRjgtK1ZyuNqx6txRLLYLiCDuhCWQ8Dh7WqngIULZKzCETJqEOrRLTVFVFcagaPZldi1HMq0kXvn4xbxLvECleHAyRmEl/pxmHvAdN+Dw0KfehRV1MdR1N9/f3XlM0TOYGhXv89yT8DC4INhJ1z3LP+qh7lo/hXd2zaJJcQf8EgmlfEoX+yMjvx+8lxs+4MYPW6HOc5CuabO6Qa5vCv6bgVtEQBO61gWM2cDSxFrVbSuzaWMdRF4+N398DAVBD1pSMnwcbaxKele1fnTpYwzWe6iwHQSL5HERALiXTHB4LR+QwiwJaGCA0B8XjOaqLlV/LXjS4/TVuK7x7NM3bvXgb2LdjeDts347i7WCTZqyWyQy6sahy5DpvvnhAeD/Q37tWdchi+n1XagIDGzhsAwdt4IGmBZsNHLOBo00RseUrqLRLXZZFIrQToZ7ZBc7Sqtz3VN5zqwWTvm4D/BR2qcBujuaEDdhG88hTCyqcAEagOZJrK/Umc9X7WQWc87SCVvXw6Nm9YCJJmcKvqWJyBS1eMvNyL17IvDyAl90KcwZb5WWAFzIvh/GSmZeDeKnpkGS0hWel6e4St5oa0hNhbLbRHFBFwtvBv20VUrKMbLx5ALMzLk75EPe42IZsAJ4ByxTE5/MU/px//hnM5VaEt3IYr1I3wpNQAw7li6mI9yEiXhb0oS5esdkExm6hRTBJBvFSC5qmmWkKm6aZbgqcpplzCp2mTDzqyC6lQ748fcHaGO7+rH/Dth5DKOJ42U/I0laHBJfgZ4xZTKpZurCR/SSSqVG6nPgqk/kH69TAQvElPA+yMskDdYD/9IDODwgha8tVw2rLFWHQ4WAdNlob0H65Gb1k4oS5wSW9BxYdD2t4A+GbNHwXwockfJ5/oxrUjhXHs5+V1geUlC5anL+y3fjZU8TOX9ku569s72P2V/b6MPRUeFgxr920zN90oglr9oRnl5oQlOmFqextAmTx5LJgbsuCAYQSJG6wZ3mbmhWnH/gapz+cvqAhBmJGqhXLrJiWDRvm2R/AWids8iRUl0+c+70Tl8jlrHM6B1tAI71PhytYRnVU64nFK3F2j9TEvBF/Jo79qIGjAjF9bJVfGyWj0YImPFwqIVc2RC+P+U6DA+PLgJEKsgGgI0yQ/eybkM3kyW7T5JQSrZaXYpg0h4yyVZ7lgR3LjugdMq6Q1wsiQKpNM3fAPgq84bWAMvyzZzgEitakUV7BmRC7y+0WkL6bms5cwDGggn8t0MFuBEKny+RsX0wEatkHAbZc3Ihu+HlEvKIf9UXXiefVLSEFUxAJLlsGnEQxu2DDM6LQYWlhw1cAjr2CfQ/dZdwQrr+1TDy4l1zwyp7jUR5iTbXbOT+21H3YUoW4V1pzN+4aoO57bOB+G3iQA8J88BOU4RPy5E98fd7iS3pwGE+Ldh+67vzgkG9KGNjAXeaTo3ge89GGuz1pA2JfqvUc0OKuMN9crq+ZVt7SrAkFVQxHAV2QNukZ/94SivHrPpr6eYk5ht/sx+Q0ImA8yEM8dueRXghaHeU3NfJyjQxAx769epakyQcqyVdXk7UZ2e9h+Fdwwh0aZMJgHkn/c9W6e9Vov1re06Znr5emqmu7L7JNXLHJJ8lqB+Ydrxu1zneSLj0/TmnI6JzxX8Ao7ePvWt8xp428CfI7X2VOlSm9J1OmdDDGlN7smNKBY0pvRzDVL+4a++Lt7ou73BfvUDb25jE2VikawCApeZoNhSi4+V+1DjZjmdOOMqfZc4vZdk350jnQvrCA9l2+wJ085OH0TXhVXbvR8UTDy8i7kHfxSPItnHJvpikrlcqok/fIB+8G78Y0B098mpVY534b8tMqBy1zy1wFHgTmFtwK0QChrWBut1ILrEKrZG45UPoAFAo7X9XU2s4kE6f1tCUvqJvvQMVTyMlOcK5YqxEY2MBhGzhoAw/MmcC9NnDMBo7OUZFvox35KVzfqRAx06nAspbypTtth/X1NEBC2VSFwlaVSEEVgFpT2NS5kVw76ZTJXK1+5gADRQYchpyCxyl0KhifUw2buqxsqorJ9OUYXjLzci9eSF+4y1U2NQOgSl4Mb4OSF8Pb4ZIXw9vBhJZ0hChno0g9wEa6fYp2BoikOMDjfSsJJiA0KFEAg39VD6M/OuwFsuKIXp47KEdqTvPgH7Ge7s23G9xgsWuCOvVNKqOtUAqS8q8stvUYp1APB7aP1YI25LvQZpQJgTktCfIunmQ5e8piOC6lXejIdprBH4QeNCcc6hytynOVUsiUUuphtHqUKZs6Uy5TL2Qx3B13uFX4rcV287J3L7nglT2N1324C17Veyjg6ea9FHh0YCM/nWcLpj0u8ov+z/6SfqxhrkGYdrqz+TTMqUJMoKcLjQdi31Yegpi3YBS2sx4/swtagFpgp47aa88zsLBbmd1NeDiOZWuo74E3v/pQTVEhWxdq7bLcrVkerGR5O7IgnDnW/Qxl3bebMWZSUXLtdIbw5IMEQcOUH9YX5coPygvY8u3Mlt+ZKLdt6V0dy8E4798xvH/H8v4SgLwo+ylpTwRjBxv7zv6m1c/9xXkrFzs7aNLOdR422j4oKLsTufEyvIBL9XkMgWdowy4udGOIeUC4CyXzYD27FSqyt2e34zEsdhG+pF3rREccTgwY8/uydNB214KHxLLmKUrtW5h/7HL2TF064F2dR2o/I8Ya40X2L9eXQhApp+jAEHcDaiuknxSz+w+I1pzHUbOU8VsIm097HH6EFRrsguSCUC05k2afo44LjmV5r7LGLFZWkh2PpFDy8y3l4rKFguynZUAKbv52hvEsP8MLggfw5Ml4P550QXDvLI5a0LEVlWP19IoHO8tgPTWcRad9VU9f3WQBOfHioIG7bGBgA4dt4CCfLcmai9q7UK3ahtBOhOyasmNsTSkm1xOsFCdeTw4+nuvJolJ8XU/05bCuJ/oywAuZl7uq68kDqunRcMvOFfqiC9Ll+qJL1V4ZI+wJaRXiSH7s5+YloLWX9vJ56tIqrveU6nnQQ8P7qVxzrmBj4OK0NV/jhP35Srkm5MscfGCWKRaOlIyv4FNpK2crTlmjZQ7x91tVnnIaLZAJnsWw4rHPa+99eJ746b33YRbQ/j8+04wV4g9Po7M2FbWcZj7jZ+Wz1hTkOotOg5TlNIhYzqKdCO80EpeWSlwqR1enAPmlJxCG+bwonSK6ZP3QLZBA9XwlVRkRlh+sVqu0YlZPnhf5Ljzvnc0Jzwdnc1Amnje4iLpFFqstdppAkbsjXnWLWTrT3Z3IlNjMcaGTfcp3tjzRMbs7y+HNNlNSJOf9aYUQFBVCsDylmLPLyZ6Wk50PjmUunMUTpKVn3VjBz87PwhG3Nm6HiDTbjPn5WWqGeQf68hWYlb5GLonNYwETVMK0R76v6dRflKmPVnQZPcFIYurnbuovj039la+LqV9Up35RnfpFdeoXj33q79h86kMn9xTD7bXAodE8zoXRfTNhW6Uw9JzNZ+xWhtg5j2y6TkGHcyqT9ZzRyXoW/wAJdR+zDbzeNoAarT4Fh/8MXJmCO0ph6RXYb833CRLnXDqYm9mqstLU4PrZo7h+Vn62qnOkMldL/IaSCbeHU41zrzllMRNqVzm9dYoENhWfq4MhYmrUnhALIlFCODTiyNPFZ9sDLHkJ1tkWNs1oycq+0ulceEjbK6UQmRcfL7ucTddKqRSBAXKp93PqeFXgo9hEFDYL4Ojgvwqi03ugUAlsAovGwWdL8CIOXSKhPRzaRwmdgVM+RaLsZ5Qvc/XLHRxsQlEonw1lhbqHMXIQjf1EpkYmGiaWrCR0e3qR510rYteAxFfIHUVEEQRuESRsu+8YUk0EbZxYkbFlb0U70kug1CkSgg0jIeBawJ29B6+dtE96rzA7JuTPiAw0bw1SF+TjQPpF3wuniFTUhtXvVZRN2yYQFiE6FJoOwT9ohBN8lB85K372DtxouqQCux5BBZDUdGBL4PeR2TrGZBkuXvXAMyS19S5a1yFUBuREGsq2a6U8ZOfa/v7LryF/zbi2DfVbuSfo969n76viukOagDi976vuJGoVWwEevsvENXYGqVT2CWmIXjyV7HnIz9KBBLYFUdWw8PFhfu/XGub3PhKY//kozP/i6wXmf/lIYT5Q2z7BdYCCHskgVB7JaFiPZLzsXwDG3FdPBRcZo/vZ+f65HPTO98+CmP9CcZOmAkM1cxOchxRx1VqEvK324Y0I3Qt//CpcKF+Dsywuwk7nD1lieRDfZIVmrDO1yqZmijgl0crCIoJyOe7MoyZ4pGHihjTsywBcjgJpwSVu4sBlPeMqHgkeLorvF9sOPhLEvcc7/dAT60cRkyUsNgFaRWq/K0DZEXdgZNdbE52riahk7RkIiXdjKPSIo3w0Spqvaa5/aN0Gn0Ud4W4DRdzGOORdcULJoEiGxteK2h0Qz9lJ5XJjk/zKW6oN1urj/p31Z6ltELSFwBQmuNkrycTFD/WFsdbn1+YRqh8Z2tL0PmYM/6xkW9J4gdjjutrHTW2q2ZM+T0/S5HBNfrvrMDeAQck+BmwFuNXISN+TQ0Jf7abs4q9xf/9lUkzQvxhykbLccj1N9+MEz8t9HWa3WGpY+14ER74XVXh6/6Rqw17zcjpar2VAimDsexzBVTpefO5QBz/f4wcs5VaVDOABZMBqP0E+BCRV+4DTjAG0EI/6EYUm+Vg5B/KCYTMqXgUKVGRgY1uow2mIOd90IflAYjUAo3huzMOIe0v4HOd+vbjw+0T8d1lPJhrH71xDzbB9xsnqHrSI9FZ6pFflQxgc6KpNoAV1fJaJu7NzmbIQQsIFrCIkXEBLQrvlaC9Wp/XkiZpX9rtKR9UCj9agprF89LRGGhYTN2Ys6lRT2ydF0MvFpjRxgGPNB0q89BNtY6JVqZ/AsKIgU/8/H35f/PeF39/7I/d/ouoiLH7u3jl1nYzl7svIQhy7hTieXIhduqSiiY+sEpAuLMb6wc+5BTmgWvbzbkGOyXmUohgLsrsqRzVr3CTWzKEq7TNcEqzAuuQiLtbRiIUnUPtZ/sQKHHDj7lSlSPVAHgt68JOC0RW4Yor0HR5zPWiDtiDSTsRm2ceQBXgk5BuUU5uDyltwUqYeygOxa2FCXcLaoo7tGDh3KVegFeA7XfNCvGpnYBhMYAKjKuKvXF6K0Dods76JLmUGm9V8lYtmcrdhndlHyBBKx6SlaIb2IPsF4bX9UTtU6V5Plgnw3V72LmSBgSWFqZ2VosBrFmi8qfURaWIC1Q11W4jxxUMaLHBDWKZ4zbqT8hDB8QgH1u6Xj8IwdAkFWoHa8BytJ/1m9DkzXca4OxNuWhMKkJC6HLAWYQKJUoAyPNN31pmTiGFWqeKlKdxcBUTVo5W0CNAWFA4ZA+wWFZ7LuIAMVM+u9/Dr7/zYwx/42Kdfd8NRTgazxcf6hEZnG/hQ7LzAhVPhY3N0v5wZhLhH98uKKlCIjB3HETPHgV0YsyMVPySJamNXVbAjF2y4YBO+pXHkK9rYCUVQw24M8qY4scqDqn+MPHJq2GpvR/A+db4xor7zjYh6IM/hIvPGZsUgfz/ZpJktF2yLU9zWaDNbg7x9omYKPbaM1569vLzvrfglrLAhEaUb6yNOeKjqhIcamnakaFBj0l1Gg2qu2OhkfPlg0CbKcXrq1GS2jdrDgSqw+NmvYPRdJ4uozEsuCLEBo5iKLH095Aj24xKLp8jvU8BHFeMmYDBOwUbeBNLIkHnHtXMC1hJoWAW6gyQ1B1TXMyG11EGhurExo2JM5aiPNGkpJEBqJ8hTs1hPgH9vxFR8FYbVC6KL/OPoWy37YyHX26bFgiLqRdHd0/3sY6HCXcfsvbowOfK/x/gOKW/X+k5QAqKlkd7EZdaUYyv1vsuP1JQ1qIubK16/PulBxxuCd63gsufupSN/P6lepfCmTRs16apXLHiueCMXLKIBWCJMmXCzakqkLLGWAov7HnmTuO9NvZKBmxJKCivKYMG+Zy1/90t/75k/xWGP4uF66VdZP1p/K074Xnp8ccP7vtbihvc9EnHD+0fFDR/4ehE3fPCRihue50PvTTq9kXN6XvV51PcFQX2NogNiKeDAxhEKjDUqYBojWO5bd5w1I1r300OeF1S4qECBhd4o3xRRoCYa8JpwjDSSVNPNzz5U5ZD8kkPy8aozDxySjwjHIeEF3qdGOaSLwS0ctRxS0P+EpRWBckiB5ZCyD5d8UbAZX3T0UfBFO0qK0hqlKCA7Si7+z+Od/jqagWKZNdgf46l/VVfuB2PnAwrjoWIhaRWgDpOGPBGy31A1YCg9+2vZ3Xgjf8r5RKi3bH1C4F4bOGYDRz0zf8W7MaQr42tebFTONf9d9sOBDRy2gYMe1dWm5wazVbJY8i/4IwiO6tTYP2WxPGoXS0oGOqXWZYUAxfhNdEoJQMSHGgiJSYqW0APEtbX71BB975mKL8EAF35gdx/yswyKKx2jR5HPqqI4cQIuVYj1E0xj3FxOEbtIs6YNC3zvQTSlF815ALXLDEhcHk30cLTs0TyhwluLLnUHtIQgLeOXjzBw5RGTesEKS+ZoHl8aRaA2Hu3qLaa8U7UJm1IDLw19UaENmqq9WSg7hq0014THLLd1Xk9JRsU0IubJI+MeX3HAe9mlSgdgDm1+rHwAcR49GBP3oAcJqo7H+I5PTPAd02K5nJPkO35tnO94RkkldlZYjF1VFkOTu5Xk1QkOxLXgYkON5NGvr/FEK5Q4cZdFZ1RN0axwxIKsTWElDvtgP6hoRCfVXuCg6bcstYQGY8gajP09slx4m0zc3eQRnmSemXkKuVsb1fX1sUijodlvG4ub5gprwLxhwT8YLbQjseD7QhDBRC7+SsAfjpy8BPtgNDTihlJUrW3v6GuGqsUpAfHfZZDbROSDw4aQkomBnzekNOyiqo4Sm0Jd0mpky1rowKdy/RZzLG+leiWYWpRwaJfEcjo/oDYqkmmYK63MHAiVUrQrlZ43+aO8aSdQZuZApsOqJksY1fLGOP1robeT4yOj0BaBdN1Yvm9RfcPStUG5CfAhwDDms4omdPHFUDFg1dsYUsrvlZ2D0JEUTU1xPKkmWAS22uJAmlvEetkBmUPSlwQvDb7OnzfMSYAhGREPqh3y9/lRUC47ioYJRndk730wHH2/O+QB9NSrQX9vHlSHKxT7v3uFR4ER7AdDjIz4zFQj5oEIlKM1ComfSNUBU197wviorbORRo8NgoOPLkdoi1InAWS9t5GHVM8DczrgE9eHCwXbr9mwy0tYWXGkftLtsPCjSsuqTfFByJU0GjDW0rv9GPcdAEB/VDw7BT+KmEUfuykiPMk8M/NU29ZAHF0pK46Wsa1UbMExvnSz5ZJ1e1+jFuBobE9hFaQ6mj2izVp+RO1b4U7l0p7adlU/kXBUbbxUpPyNKHSiZH5jyoTSDSpi1gIwPs6ckudgeYBP2IFOpe/LGyWdUX+rCi1rSSgsFe8Z1EbZnprp28MIZ1HBdYFSHt1+Vqil2gnC7SG9ZrvHRHU5Ssw84zjOw8GOB6qQfeo1zks42EunE66+Q+UApwhx6vU8iDAiRiS8XM54AWQdAqdQUp7oqU11TIK+jAuacHrAjdH22dNFvQaMKD161NapGLiJg7gG8d+lPWUvcRhIzQ0ciOGt2ni08RJuW6yNTU1jQ2nioGjJ0VidQgx4qI1Ph0XKP0eYDAWQmovRpRlHw65Tjzb90+CZv6FUMw8xOlyEWrDHvDyCokvKyXENjL/TzHA3bbLPCxM8068T/31Lr//8texvJApsdcCF9mCPXi0TcI1d5sr4kRnvKi05XzPnYg1qMl9jBkz5Dg/WF8p7bedNM9bMvv/2T5hp1gV9uoXmE7ii//sprugfDCLHpDtTzRY9KysYChxfMMAtdIU/d05Ror6PPZrjfyfWCeUQyFOuV45MhEQgtJAn6masQQH0PZRKELLLR02Ad99fxs/46Js+9w9K3hJJnZbCOITZ2gStaFrCp85ix5bP6sIz6mwffGYeSL/C6f266/Hr1x/+zree8foHa3sn++VSHk2/lKx7zm4cRY91C/7Jr90W/IFNt+B/eOIt+Ke+sQXXLfhHTmoLftQ//hZcXZC6LTg2SNmfHncL7vbNJ7/hfiTb62D69vrYY91eo2tMwKP/67fXYXV7HY5srwePaHtNhummk9xcD6Zurml0b33UH9tbPzB1b/3Ao95b/8nXfG9928jeeOBXW0Fr2f+ubo09bI27m26NT3YrHGZ/ZrfCNGUnPPBtZ3+1ui3CyGgz/MmtkTf6fqfX960+jkySoH8F3kc2SJx0BWhiQL6YsKtukBBXREACMGJgf8wGSVUlfGkpePWoH4hxaY+iZ266QTpa2SAFUzZIvtkgBbpB8vudyQ0SaIbUT+Dh7AaJdDkFHIPR7ZFOFrg+mbo9oum7o3+73RA9xs2Q9wg3Q1TZC4Un3gs9Vpbjvq8dy3HTP27Gcnz2xCzHZ5Tl+AbLsR4l2OeCtjT0ermdGse8E7AZr6ryGHcxj/H5zXiMaYxFiBlxp5dHeA68PB6jGTrhsAaJnQJPn4c8SiybwTidNw0Z8UTUJYYGqE4eY/sEu4GgpSaNTdkNZTLa2iMuKARrISxHrrfT84zTDntiHYlCntzI79EMtTigTAW1Ngy7AcOj4DIWzK2YTBmIeVNta4LD6JQZkDjBYbRB2BZoblMOY2HszvAsLfCXuJZBKcgIDogPofEQbBJUK4RoN5HWEoatxXEYkkNesUARRbRwZU8H6TBiYoolJqYQZDY0tKTKQ0DAxXdXPX7GF/DQGp5iYQpPsYAWG55CJYgcpzzFMW+Up8B8n+ApEPtoeYq/+ZrzFG/3fN/xFMeqEiQ04G8tmZqyAAVGNRzPmgpx8Kis7UnJR/jZ3ykfYWU909mNbK2Sk1vjzJGH3it0gzG1KZ6xkoNnZp61SXWoyitNXf6xcqtIou9Zl8DiAiMSPWydmk7OYwI14yI97hV1N49LXd+gHxywn9JoBizW/Cm8EioHcMSPY91JCbmraGBOVwzT1TIWHkOpEUVKdNwan0o/eCmV+5xtTpyB6XmXIZNZz1y9cx3YIf8A3pQhyPibDs1gAmJSztDsCEOQWYZgzjEEDWqodf+YiYT6FbdMANzQzw1yzOpEZ3VHZjVLDKkzvtp37Grf0dU+TT/g+4HggfWiy03FCmVUfNTBKz7hBkVK0NmdxS61XJKBRxQSytnw7OIZHsAFxuwBdTeP6BaifbQa9KHWMQZH7h4zOPJ+Z3Dkbmdw5KNqcASJro6IYN3nQPYOiNTKpvQ5IPmOU7m6rn6O0e/QDoFxWdOPq5X40hHbv+wLasrF3HdQydynVnrYRDCWvbLcu78SGOdzOFDM43Bd3kNJ9zmv5UaLMI+gJH0K7LhYq/dTzVXXjWl5PMk8M/OUFgNZMWBqDT/Jm9J3s0jGYoBQfVynYBDa7ZpYcBKTipRCbZFxMoVx24wfL+T1gh+Ey7nQL+JVLYWMFLR7I1+E0ePFtX7yknzJ4f0yF3jw4rzr9Jm2wG4yOEVoALJWJi0Q//HF/16/A0WxYlWca6H8rZTCx9c2PDKxbRtqJWJ7mgi2LkL8XdrjGbBB248Mi5xyoQqE2Uq0SiEGRnlIHMQdXMwL9Jhr8DGJinwHOtvD8r3Tlg69LCpwX1tjKMTVVFLzH9sov7LY2stRf04cyGmnaHlrLbRTb1ISFvwdtkRaEloXElGhNxW4kJ0oJOcIDnAsWhzKRcwC1yS1hCKlHQIGWsQjMV0stg/yvH8d1zPHzc4EIFuLUxRqO4sQg7VTS9hGhDfUtM14jD4Fku9TuMZdiA9xTeVUrjqXD75Xr9ByBdukgk5ZgS2XazpNa5IKdmkFgMcurcC6/Qk1GRXkIZJRtvDFAvuAWnIX/nSu+VThcU5lGIj3nl2I4s9MLGnsGVTQjiP5mdTj7/Kz+NG5Jj+bVvF2DuUA0IP1782fwJiym7z8iYJmK3TOWrHCdw7gRlyl6kDBEq7z9ESgyJM48KRLexsjUH7yID+XDFRnOdA9UDwFd/cz4ofCfKemnqqwOVVBkluQnEu5AclOgASIcm+tBHqboXKuA7oBakFcbU4dfuf6QtgHyCjU+ha0mgWu+FTNvckY40Y0mhNqsg4BklETV9rG0i+H1udx+B4J5+dLwh6N38PBoxp/AT0Ba8iFijgLCuf8qQKGQoommVOnqHeVBRzkpGfzFSPV0+OU3XQKdj8EDnAbT4rtdCaalhTbh8Xycc5wwn6dQpzhMKUAsaryBRqg0JztbFl/b97lqoR+YNo5m+chrcJ4AohqCAsc2wRqjEpFPnTMAkysYaXiDNtpWgJU4UJLWbYy+GWepnRKvjvtv6p/LV3YY+Dsol23O3d6RX7ElUNbRgrN2wK10+gUJhxoN2vTUryLu1mEL2XnYPlTuM7r+q/ictfyJ9i+oG9btW8HG8CAVXHYRKJMSG1c2H7Cy2jhGjR5K3XpFHrKNe++GYT9Q2/eg7h+KHiDB9lOAfWK09TVn0JwC3dkecDU7gzivyt7VO3IaDeeMNbsiyrNftqJm41BQdOfgKbbTjwF7b60xzFPG+3MRSfdGQxN/hAvzH2fm/JSbUK+RqdTgnspTyRvP9Zy1Ho220mSsbhQFh8IIxrCtSAdxgwm2g9BMe7mE2eTQtpncJkLZ/i1m4mDtTcXM2oNUR//jc1Mo73YL3Vgy+EluIQuOYun09Np5rt7le4s4LFge9VzaxiGB83zqTnSPDRHG0YLHFe017jg/Ol0mraaAWqbSWfw+j+DBU6k40+/GSOwhgbDPDM8SvOPGojir2iTTizYToTEX412ghNFDt3TNfdsWGI6Cz+nGPifBTZT9FhBDXI8svxiR0AE/TAD6eKB2j3R6axj0HarPz4Fw+vW+3IRRRMYxS41IDtFizUEaK9ZtzYt+mIuersUjgmwSxa2XnEG34jfi8lwZDg4fp2434iBwB/fblsgHG1jMdJGZBzfZQ+50vFdCoYzHMlCQxzJ4urPoO3SYthH1z4X6Pw2leij+qlkyYzDaSIBNHWbyZC3tZqp0xK4RIZJsVctvmlgQ7/KIHnIp/ZLZUqiGUfeO2UmaqMW0JoF1P8I5p4vc+/rcNZ5Muu+/udbDfOtNjrfUjqPzgcHtYcuAHt1Lj2VGSV6Uv5EOpU5tZ3MDj45305PIh/FyH4gb1v+Hvfqunv8Ywk/t1wQ3I3n8gXB0YQWqCW2i0XgEwMIM/zMGYbS4dhyzjO0VVr93cI5o+3EAUAgBARUTCVbNsM+SVEUWXPs76N8PX3Y86LrKBAXZ+St4bkb6jL7iX8u7eF9TxEeUO/74vQ9VG9p9f0YJPUaRnWk4rhSwKK714twzVvyPquoXyqsKQqhRPLiiyLaD4SG0pbsEDnITQT4feCLj7FEBnOWlthJZ9uIQk279SrPWeCAfULzOa9pOyqq63bcN1tmtFhaegIVkX+YoiJyXxjWdfNpRWBUdeWtm/sQm/uIMA6Is1cSKL60B/PAE9v7PLSbX91KdxFKADGIwQKKcaFLmi43dTWfXFlI8EgQ0UCohaFuIpRhtHFw83Y1a7xAAaIXxKgqxEPm0meg3ukk1OVQKJU1qEnp+2BRQIT/2T/KNr85ts1vXiDODFTIcP+YkOHTTshwvxMy3KdCBiS6/X+dWPk0rgoZcDF9lxZRhUNSdj/R7jfK7rcer+6j862T7j7arjKO0Mo4MO5l652wZpqMIx7ZSgfOyvJ31vRUoUQpPIXMexahlNiTj191RyfriywculTgIFROP7FiBIK9N2YzkRHURSIq0XOJUMKhFZZALyfpHzwLwhJr5luk2k2rN2qPrcKiVdW4a4uJLRFyzPBzN2QdMfZUGXlC9mYp2sjnuJyDXRFrzCvdhw8XSvcXCc0S/zGPumgkF+IxdhFFLJMHyUUXj0xEHomWIy6qVqhLy5Tgj6lWypKLLUeGsGctkosVwGOFloxIXcHdZMlF1zg3X1TJRU88mauNrq2mdP6Wa+rhzFFjKOHjA1qRk4Giy5aIiuUeF84h4kCbtnItialFbUBxbvGSbkukeTl+SbiQnnr95kK2opA2R3CAY9Fi7g4kF8soSErowagdwEBzeCSmi8UWPv3sX8f1zIhwYUV20QlvX/l1uWCZQ9mGLq0gGjV1dVcLa3KwT5VocoKtZ4Jk2dX2iMvubl729krZZMvuEpmyt6Ps7Vo2mbKRbIQWEcUA+xKEDTl0QFTYUFCU71DfopTzOjwuaFgowZDRDnF5yoGdEDRUgXLKgPfqpu8zHOCNPztJnYUQQHFmVrsxy93YWulG23bjVGprN8CHoruJJms3kCwgMiDoEVcIVmg7ahKXQR1KtKaW1tTimmaPPxizqGl2k8HYIm0vWtjkt8WIe1bsGrCsB6buBcQ6mKcpIPMzgNv6n3ol3g7O1Uvt65Iue8uKlzqfMjufTifuqewF3AxyaOlhDiyVvqdNYdRS+VJ++qbF7uJit6iZraLLlfAf7wPO5H0AcfhM7AOOXx9kOj7+eBfQou3cH+YlUbvP5RJDRbVdB/mZzJgHVPCSBEO9lbYQl4wnF81lyunhMp1JpFOxyzuCLdJ7hLq0hcemx8/uVL69e0RaS13m37eDf+e2olzuQFjpQItHHaSyFaQpEFuh1eF4bFoSUDSpPuHBtERCoZZwC5eFWBA3agutmE1L27QW7dRNi1ZlIbeMGkE5UnGGoaDCG2oeh0x2PMgogaL21P63Tf/bJ9V/xRZ4mNHaFEdkrjS15p0gF4v5NsGVlql5CPAPhcL6tKz27QRqe8Rg2+7BUHF1l7zSYCB5Ee5KTGYzJMbA2wDwWynhp4ant1OAqqBjzX8mDs3fbmHawoMnMbq2LKSl2CYwPZXOANWC+weIQGlRu4KIcPYGLJ/KH+7MdxBMbG6FlcV8C7F0XFWS1KWZWSNTmoU6Cg+cbAGaQnX4qUsRliG7BLXNIjS+BOkCxJBF6ZaqWev17fTHHpsztwfWT8KZ280/BZ7vTvxaZ25f/r/dmdtUP1on67at6jyr9M319ea9bTOXbSfpp60ztYuPwl2boqC6a5tAN2Da/3Xu2h41bm2KWZP+2b6vNEB57KdGN3Mfxbtu5jRJNnMfQzBVpbMQPzXe9Yp5Foqc853SMFJfShHcyx7GCPFdmIoPo6uLGI8XOh9GVzgfRi9/zD6M7otiz2qAO8J3rPbIHRnxmIHBusWXOwwY73v97F8eD79G0FI4jm+jzqP2bfQTj9C3UYZrSgnMyeiiFmf/LP2TrXaMR0v8baXikF2fu82TzDOr7AtFF1atUuVRPxE19zoUOhDS+uvQhIj4oYt+oErWbZrVlbjq6s7dYZ6RWPKfowslwJyiLprhGDz2Q0lFnNGvaaW2WP7jadVGuZxS2SNz69voPRqVB9JW18IIPAJFUsiVRdTj0mcRoSVVW1iTHpTemYQNgZ/K7CEAsgSN8c4k8/8O8DrGO9PV+HnhVO9MV0x6Z3IqR8/3qnKpSGP1Um7GDw8Nighqi6oqmZBamIVLHbWeGAnSwblOBHz4CprLQXpkfnWObwj3hZsZwn0QtaWfTRupTFOn4FH26oHafqe/ATWxA9AvUcWLF1IMYnWFvn2Xvn27vl2ub5fo2z59u0hWmbyuMidMZQjSlB1rUozo57ECkljbw1qznyH9Io6AQagDRYrhDg5A/e+ldjbGan+kRSkgFIqaQxsW+mIChkhcMcOm+YCVhCl4lroepjR7/SEpof8J9+akg2imth1ZLmJspFCaQ3H2Bpt1QfJLdN6xNniy6h0/gP0Wbx3bYGxEE+kJxB1zbrbO4+TxinxBBTyLfe8SsY++rBsXHvN53WcLV85c7CL54I4XjCwqpJYKyHLfldmjRUwkJeYHPdpCPRTCTMcqrTKXs/UOo3s+t0ZdjinXPmL75eXLlb115DfF0tHh0K1s+DyE9Ej1wR/yi238tu2SXuWc2cdk96nnvoJLdEz9ujDKuZ/SfCVx3u481UOLuaEO8FyUJwoln1IR/SXk2/OJutBMUQR2omxUEqKQchAhJqMOZxsZwcJXJnpZRzETarZsrPhdUvjaETWnpw2pUyb7pVCqLRKVnJEv1dfJxyPBECWQ3qspwOTZ0H4X/VpUAMxm1EyeWcy19S4Orz+Q86WEiJlqRB0tqFuI6iaoChyLUIto3bfbRq4otEJKZQfDuy9tyjaBmIegzI65NVXCx/bqWO2AeAyiI8S/u9YVQeqqV1438J0hfEKLa0JtHby1eWbHlqCViUIf3KC694Y/HNbcfBnD/ycheS62KVT5EeKYjLZh8YxJh4s/OUvMYCK0G4J4hMRI5gJCcKwGsorgHrWNqWOs+uNqJhNGFt+IsbbQcjA6S9AoQlbd4Y72SHUlI0rRldTKXfSwAQ0uElGFl7sjpGGRGOp9MurJrChWryzqPRyEcgQHONZ8IPhtPkHPpcvGxmYsBEdjvqwx2rPxqE/YqF95rY26dyyK6bflN3vp4WDEXGc8bq6Touyr0yxN6XlOfcSUVd2ZsqpPmrJy6ZKKzj7iatD6zlr5yUEMo7mzQbXserwq718nXEuwBoupbgxb0ZrsyvbLSZVUIBG7pFIxcrUGzU90oGLiKoI9T7oUDbEmrnSeB3iUJq6CCRNXIbf859FyYiYLewVkz+v8pHDUxFXsFLXf5YkBWncrJdYe1gWhzKkUkKQh+IRFcsSip9D25vfgtA167tSQ4C7/sAcUQx9i1J+9+tCjN+pZH7288q24rnGXp/c1YBraqK3rCh9K76SxaJJ2QszTZjcesndZ4s3ustxw6D+AZc+PRAE4rMhdeHeMIwBxD9xiKood9tTi9yE8vQsw2HJ/5eWjWupXj76+UDNdwY/rxeR68DxCgSNm8QJrFq+Is79/LZ5i57p+AbMryjPkifBjYruD+3atWm19qeMxsJRxHiDecN8ts7qID8t0MaINvXicbu37+FOv+963DT578RDFioUa3lHediv+/aa5TJdi+ortGQ8LzoASwxJuGPOVN9z9my/a/d/vM3Xo/vpbL/vQb9y3LWZbgtnfvUbMyFCEeXaJtvoibfW5FFHLWpLQsNqpV1Z9Fx7kyeYgAra+HD8vxRIC1jGi9Dw5PWmAk21SlP0LIIY8VxUBr7+y4QrKQ21UAIsHaI8aRv9SDU7M7hDKrafb8rHK19uUiisR5RWL+qCQ4CEdhyps1apDRKbI7J+Mk87VtexfJahTDasmh073Q5jJEDgkCgf0NwJzLnA2i0RN68G6lf2DdkzLl4mjixJHHBy/xnLntGssE7GgFXqJZEbvW2U/Kjc35IaJS/ybUQOLvlalhymWFAQqR2M+3P/+AsfANimB1nzIsZeZuEi0JTzBQFAW4aQ4TDILWz6IMSrgSwi+bP+97y84ERku6/W/Cm9FHPkQP+uX9gBwbM3eDdgI9cyDzWsJTS0qAZOGa7MDFvnul7sG8kWEfKrWUpMiQY9P95PzTf5c7O0rdQE5UVqT6MNRnuw9aNWK+lqKxBc+0rhhSm/8crHppNkvIm8t/WXfi69zsDOts+BTWHOlCmYUC9UUNajtGyvTeqCqzGEChimRg+ciBoZK0RgfCksoYdevX8fCO8eVbUICHaJEd/F1XXswVtoJfc1uUi7OjRs6Wjafj7IxhKgurAxhYocwux44pz1LpOAiHGkQN7/SFVVqqjYo+8wNJ2Hj5E2HJhVYYFxlxIiKLmIW+N5+nQBU02lql9l/agansFtc391hHFV7yUOVHN47Jjn8hJMcapKU+2kERVKDrmN6h2tqtHOhqOORFbrZLhoUw4iO6LaLnZ6mnkykemWwpVvjtm6UZ/QuRkcxONN7GrPCn8yivyAbME+AgcT7PFAaLViQ10WwbdJgyvgdSje6CVlCu5bXnO9dyVR0JVvRkM3uFq5kGfAMIXrnL3bLbjiijqLocl6jLRZNKRrh8dF/ZDWnZTVgbk0x11CcBrZhIp3AzFpm/2l8GgRevZuvqhs7KBMcQL17pTnb0I5dOR/A52ScmxViOGKHqLTYy/ZQ+RQbijvRfLlBSttpJ9yR+XmE7NYjodzR2oGzWym/QfAQlkBXVgrMeYjLi6UBncbZ6riBpmLx8ChoGV5IbWLoi/iVtS81NXrR0ArE5dmuqpuShBJxZLaLAtwS5Si8OmdmkFw5k15yTauuF+gB/mbOGTjeKvHvwF3uiJatUtky7eCg9r2Bt/2ilFjjjtelRw3aQbW1R9mpLVSf6BSg9sj7hT6BUqhRWToNcVCHKGRUahWAuQqk+MS6RpNig/FicxSbEynEkrzgkkghZp3W9pCF9VPw3VZF/Ro4BoOYVGt76RTXfbuMfd1nm5Ho5slkruL0fBe3e5cCDTqteBZnwK3aGXCrJuDId0mrMVPwwAD7YmZDGZd5WuRRg90tlfc61vBMwKXvGeTcJWA9E0Nk7POpwoDaAwAMOQD79AJvzihS47PoLDrT6AfjqBUUYhY/QjwgvGCYtxDBz9Mo1VD2FqH0oQoYQeCwB5vj0uf0/ErJXI1i7kVP+xG4K7qP9az2/p86ibPam34WhHmAX3NWq57hv3FW+42z2sd+VqsoqGe1E+gGTHsUZ7XfOKv9oUbiixanHmmO0YdI85nrvz87dv0X78qSaZJe/0XQeBmI+8hTHu6wgRtlfRxBrRu+vMRv8Nv3e2vlWS9HjZSRHRZxS12YPntP2tqzoiBvVguc+Fplysz8pUrEUrSyRdMMzLTlKDIiPMk8M/M0VKufPBd1VA1bYWLIFdVA7pWHOJu0Aln4u81I7Zt2aBaPOerQ3FXlXRGnbp/JwSRPTYmlFtgLOS/UCdOSg0k89uezFOjBpNQT2mL5DzhkdXhnwQvOmn12R3hFvs2euLZlNAuElM+vLLIel4tiMi2j2ja0PJ8Xuq8a0xE9RmA1/w2B1fx3ABYE++AABGgLcPvBObJfxRF59r9l9+3sEdACiMM8zZcxx6MRc+q4id3XYLevG4Hyw+dzr+cEytV1YG6UfszRXIV+zAnZRqGbkm4ejhikW8yJxhTqrG0afED753EclR1Gx7hu5OHXg3iFvSoxqKh20vRGix7DW0blz1qqX3Ht0nU+/9rjWo+3wlVidM8YMfqYI0aaVJMr9EqMpjGKDUHVhPDMpMNBVQW9iZZHoC14RLBqV1e7M3W8iQ0J2QfVCTYBYsHgpL8bx/uUyZ4bncKbEdSm4DczGIjJ5PCrqKtBFSFY2K8qJxWJZJ4i4efE4MQc12O6J1loTneT87v8fTR/du0SXGObRxF8x983JFaVz5eUpVuWbGBKuyCJUlixhRbEJ/9K3jOO6hM5QMaVbbCgK7RKi0Iuuf0CoC5GXPoYgVVFneciXc8FtnD+hQP6ziDnNiKfiFKssia3w+5n6wofLSnfSosMlZ456dhK9dFtrZ4V2qOrDLMzE8Tp0RK2EqvAptXSWhYAI/r+2N7iliLsE3TFwfP2A0jVrS3JsQmuAIjlmyUZTqjMP1Bz+1pSKOXLtg9baBnK/F5lv7xVdnN1cAl5TnjW8kLLwVZWelVHfFgzMFb4bbV7OZ4JRWWjxogBEpPJBw3KR5JIIAH8iRR/rFb5qgVEPV/l6hbtjnSRehw07cbb/nwZA04903z+bO3rogc6jLSsRGG0dsUnrbWLWmmJf1FJvZR5a1hl4dOqWQIaLZlLeYot9mZBFw3uCubI3gkA8vdyvTpx4CVUWqCzYwnN0Csf8kmxdarP+oawkdixoheC31MIUaHeu7QfVOjOtcixY83djrUBmGqPMp0EPjq/VVqLbSyaBqzeWqFhYlveU/hRQ8DfhNioulttyuY1z8zOtk6Z3nhsqkmNHbSDmrpbrVFP78mZeV/U1/DOmLGGqD1KGgQ2VLcb1urUTGkOb3M0q2+wzSUH5DMw4tPBUHUoQI9IVNmb2jGr6aW9rKPbETcvk+bJ6huhkcSBptGeskY05WwRmFTK+Jvsy9ZPRowL+SbJl2Olq89XbTZIxm85ZIynmQMntYxnos153UXn2Q3Stwv/z0fc1mozwKkiZTHxxM0X0BeNnrA1eg/MSdL5WIZ1CISCquyqqIs5IriLHUBlL9JW3WGvt0EJCdkSSpARuW+l5q3yRam0uHGR3ryoi8KCWbAYGwAfNWQsbTemRbO3oG8V6Xr6AxWXFr6ZagIgnWqimGb8C8fqX9h4Hw6hU1ajQFTPcMyv1rkdrwHz5GKdPPv0jdIjccXiZb9yvfGG8f940y5HBuTpLT5siy6s9Tjk63U8vYS3IKGeHF7LwSlc+v0CulW9GfdgndmMOuuFBfJnqtntjiz9qtFnCoZHiqoTu7qzdtE9e9+3/2v+ZelPViQuExzYlalX9fA6pAb+G2RvEeNzA2poSNKOlJmH4nt4vWg6R4PIYevkwoY5j96+h376C7//nO+54uJhxYOfnAUzAmiRsjNqu2t2ELHxJJuRMM8R0CWmUo5mKC3qiLW6nAOMcMivK2vZhHP3XuW+fdkN7S/9Y37z0ykl93JlT0xcZSkuQcKoL3qUz/E5wO2fu/7o3a/78lu/AnzcxOVjMnKIOi8rfz98Sb7gGpoIeUYCAA+GPMxeA87H7JsTkvlPAod1/FLCnHRr3yU///7bvviHb3j69xaynnu4PpP91uuVWTWvv43X0pbcDB6rxZLIPhQgGgZ5AcAYQAZoRSx3KGYo5ggOlBBcsppfTfHgX3QxojPyBfJyy5zZUshC0PYuTJvJQQQemcpMKN+i5+DA7oY6/YYIMLafs8LykHDfaAvkKjjs4hZsOBVm/oebSbj3VqwwBq7DOyzFDtk5OQbFgIgjecE1wuX7L2jbQ0vRA5z9m7Ovv/Ut1z+N2JN1AiT48I+/7INHdx16etXKe0KLLMrFzgeYv8IVOSx1wSsZmWNstBagxDhL88i8hUfMZW5UM+PyJ6tQWaUimGUGGWv3o2+WO1xlUS4XWPjdduZ/NytW6HGUPZyyk8M3rtoxtiAAONnko/LsNqtVF+a+Peb03TGnmro1ntKf7W7cUpD966vLL/Vo1eey1f+gsrbWwLxaWDT7IXyK4tI/D73OpIVEUVT1pOXkaT/krYXhGT1RVqvBIQ78wQWYdUqPPGVzo1JcI+iOdEpVt5Df0xZ/8Jwm56D40m+hiR55oKt/eoM7uDP9JE+0upFFLa+BOPu2GUUk67sCWsGe8Lilpgu23E+jXMmVa648SSnRs9u8YfvRRD94K4k/9hqUUgN9qi6p6Hi7bxrXKlhyCSigJJnAuKGlWxafOmIpN6YUvIa6KR8/XEsEDuAiY6fumYJi4Iay3sGmpp3pWonwVc4oe814tFYFsHjNVHG6j3GcqALcvHRfAaZH1w2zVsNTqmImQ8zlQh4Bz4HsSwpF8gBZwFWV7KomNT/v+zGfC7hltjQoKxXmoZn1al1Qdqc6HjEecmbuNLdqUKrS42+8sP9mPzXyEIqUI6NAxiSQwxz7QpLMMWg21FJVfOvDR1Yop84HlPUR/co8LvktQFdrd0NeRKoQCXAC4QBFM8qK7HX7Fun81XGrckFA4JC0ENXFhEoVHLRkeYJ4UUHJOF7VGsjL7kXLgDOYldJWpTwcJueR5FDoRyO8Z93KNPTuCkQ2yjPxwxy/JNnHMIxpGdGS2P391ovkzB+CFLD3l/Wy+27UspCO8T7ASYBLQxR6+YaKulj397Md2CK9TFa/JqPL/lGT4+q/1hMrGDAhy2WpQhSmLP83GDojWhDobKjGVfYZVA9PW3VUsvkH/sgH1Dqi9mRfJS5fqO543Grj0fRUr56m2LM1KDbmrD10R5VfgYPgjFTaW12LAjF5kqpuub36yaiqd5OlrWCTreeZwKYwFxTY8/QGprwwznXnI9fbKFpu6SUbvuuiIbV4IQ5vHWKDVV2AKeBrRH1Vn1C1DxyXZ7djLmOYdaC97McRUfhOqVBXGpXIJI9QsyiYqlkUVDWLgpPRLPKtZpE/rlnkceSDo5pFbzs0qVkU/LtrFt1xaKpmUTBFs0gHZdIlUFEbHbvrXy3RUopqUqYv4AGezt0aaZqn1AvtEBLuhhzEJq22qiUvvuAsulQqjKZPneri6OVTXBwp5bBqOWBVftr36pPchSEfRXkXrwgEe4RKRhYHUKUuAsiDhbkIgBJw3Md/JUoEFiXQfocSEWoIKLbLnrBB6FiEWl3VMRe7Pw8tSwVZQaAYgFrhr08YZHyJEI6lz9NvZduuZDsCUW6hEuSTR4iHpBlsEEiZOwFTxv+1sLE/uUb6ZpaheEHJEFFQ6RfF3gV++P0WdqK6hqpx4AAHh74ggqq8YDEUtMvWdfeN9SewbGBlBUkPlKb+idf5kKdg/3rvEpSp5xmsldo/ehCIevtBgTNP1hDEPqyqqkM2nt2JqjplHM41JA4w+XGp7GdPHj/CEfzwNsGPYBw/0P8HRvHj7SP4UcIpAqT+nTDkJ46LIT+J1Ec53X9qYrqH1ekenuR0v/okpvtxaZg3SsNCS8Nu9QOcxYSTlyssVzgT+H5NuPer1wooi0sbntsWB3dgD4HEDtupjifDAN+yhP1b2tbX+E8zKJAAdgEIm+zPG9Zud3Mtlw8o0vw8tjC0nf2MoCvIOPiGEO7gIo0EQwmMVvvlIrT7WVOB+54iQXhXgouxcYmJfQdiR244/L7nxQ4sWN7QEdk5ciZobBren4xmqBx1x6KRiEdNKAFCqxhhoYULEIhEYG8DEadxMZB4hhZ+KAAV5DHWYy4GQI+ptoYlVlWo8AF20zEletsogMdBP0RIrke0UitBrssOQ9uqKp1/pJ5E3NgGNQ8MPNVsCzpaA7qrQ+65IRcEdkM9+pF7q5K/juJBYtEA/kjeWdKlmmJCBBSI5XouRZUxqlvCxRRAnZgGJgVpdVPcz8nIpR/ydBbqGKk3FIImq8YE1nk8+YIta7aFeAGMOBpAaoWqS0n+aL99k19z537LG+1zDbF2eDjBQBxtkOZUi7CZtF4y6rb/GnpNh2/uLFS8+ei+nerPbqPT+uCNOpQi+lze/rypm7VUMsrWca1oCc541EB1DePGynWxX4P3ScaWbwU5gXrri4q2ONtQCLSkD1pUI5+hlioF4Z3fsD5RAwtDznMJdWfUMsJFnteyJAl9mwWGZzSLxhSzEJgBPCHbql2j2Z5or1Ij7/APzUhxmVKPZv86VJ+YBijwAn4hT1jCREMqHaHk9ABxGkJcKxRCgE5laAdabfRttF9ennJFeJNaG6p+O4t4AWEDXajhU52kqe5/Zy8tQhFEUA1dQFdYsqe7FlNUG1O3Qx6l2c8LuuqpcNGAdkJE7f2QF3BUc43XNb0pr7jboFkeEgxHizqYHfgOClFKnijNPUffZE9dSYTMqJVDicijNs6P4DwqUgOawEf3SXaXErvEEbtfhnVHR+F8h9kT1M4XahcXEh8L0QurcyWufOvL8uCjyCivBZoTpfNkB3FJdCmBxperDwmCFb65hGaTLF0LqzTt//yJ/xp/5HJj6NZfUnmhYRP1oWur66KvKZ6m6FcoPpJPHcUOVATh77eOU6yDKVSC1oR69FNWIBYstIgAQ+LbclAK4eoXCxUMeUIERba4akmKd9m79ApdOuYPikKHgq8JZMMMdLJsAE5lzelwTBGGL6oOn+ol6/ClkiOv6zVDB7qYiSMngGeS3aTuLzsGUGJv0Qx1za1aAkE718Kx0UvNkOv1SJ1eKvatNtWrNtUrm+qXTQUaMFjxhXL7CmpI1IyTnogg1jKrME+JSs9jVBwYhA2RAVirWevaH6wW+oVJ0P5EVYQWCiGNQM3GbKnvNUbZHh3tEFuAqNyWxCAkl/T6sjcRwafqKenQxbg8lwQSoz6JE16BTL8CfsVKVOJTU/WlfCXr/OorWQfmKFnXkMQlit46y7TgOklrGCOfLRJI6SlTWPAVYDI5HWRcG6T4mmA5SMsGpeMNSk6+QQ3ToDU0SAtOKAbTosCASV6VfuNFMGotfcpmt3GMFmOQvXvKjZy3N/lgu1FqTIU8l6saU0ffWWpM3Ws0pD4qfhLlNGlDUqefxt2JNNWtQiEqfwEh2XUAZxc4BFfxeqg7k+gA7vsaVSDdlCTI48ly2YB5uqY4yMnF8RRBGXwjb8Om54zFiRiCIsWOPr+JoGimIkVMj9xazFB6K9RoocBM7UpiUxKbZWLGZ6w4GCRfD5kL3u7dCTqVGGnqjT5+D+rleu9AEarc5R1wHnNnsAZ5nKi99DeEQKic935PS+gWcV8mJ15Wn9XTbz/PqdBkxbc4/i6/Dap6dYXoawebHIIGsA1LwEDYWxGp+L2eCBXuFasF2jrys/foLTJ1/J1B1XHIAMgEMP6Z/NEdzrLRlUKQMSroUSm6LNtkTuM1Cx/RZ4fwnmeKNVqlds0MLeehGVS9253ZUmYOs0/fO+TmtPgEdrasgWar53nUWr9j3ysWfu6b//wH3s6H5rPmbPGap5EL8un5LKB7CXnmQKbvZe9TPQjTLnQ3G2S/CEiIBziNnq14lnuvbre5PZk0d6jwmuVvZwVNfkk+nqGAYLgIiumS4yocFXEz7WVfDBt1EBuQjh9xodkGvt6X/sD/bHncM/i3kukgxixuy1HLDJ+AK1UxE1qP3+xcSSpeJqkJ26wbjOcFvmN18TuKzKV33GFxEfWO3O4wCjgPm0SVLFf2HgqKWIi1no2M1pMN3rrZRwH2jZeJS/aQ0IMWsDz7ZbPHDjZ4qiFWuxHsx5kXuqI59HBC5c16sgJp1DEPswPr2+dDe4qL+I/VqvG/csjGHx2Jf18Zf+70YnZNRHO1TA0tI3HU8+FO0UpLfPWZyY9Mj0v1mFfP2zzQqKh6NBKPqq5DbImMzOwbxtigJ4y3DFVLHfon0/PEFMvRtxyxUjy4gwLJSDX2mCapgyIS/MISElCodP62IIbBZV99Uzk/qZY3VJoaUYiz4QV5yN0ZuT8dypkaN1v4FZ5FPwaAYjmkqKK6Epf0glyQlRTi9bcyWtT3w36Dy151uRr0/Zz3krluSmO9hJhuFNGQfFY49rD4VbyVoJ1gsrpqjw2pgEf2ATRrCNWlxLVZj4VEiUJMwbvviggvC33j4D3l9F6RGkAfgUvWAdrCYAUx4mBqgkfW+YFDqhZrrAS4C38VDi2bOPdqmttx/T+vGYU1NEVPKsoTPgqrB3xvCAIYvggcj+Rut474BkTR5/mkRrnu8S7YVBUm09Pr/k5IV2tYRFL55m4vj/G1o6p+9kGZHEAcYKfmGtUqqaljQarb3OBXz9XLorsgBtDrRgw4Nf8jnvAJP2wmt3mev1MYonDDUPctTN2bG+uFr/79MFgNCtwBXsDVvMWmJNUUc+gaAeGbIA4jfXGL0YfQyOP3Jaa6ZksxUdxl/l8MIswPdZ5qdSP2FcbxAM6jK/NaNm44n3rAe5EyLc8edyYcB7IL16OoBmc8sGb0C0UawCsiIrIipXSQt2TYorwtk6BFQBmXZ2iWkpg7BkNxQNJbeY1M3Wim1TVywGPdhhYj7K9Wjb1bRfq6vAmL7a9nP6QGMCgQHX3fLMt/BD0xlSxmR2Wt+vjH8I89v+HLGtreJKdzBkS6Y7gOQ3IoR777sDW4oqtdkUIzyN/3bRvbXvO5/8TjpiV+iZtftgPwKON5iUnL3NARSzEXh9JWtauU/nhYt8QtEGvyI0bHkvXcx7ObB49sSHEbc1TNLaJEBrEIwSHJzSFZrPn1fkyuUDnUCFIYAA7sGJyEeWpakDms6ihyXTKKRYfHMXNtzkZ4HV+uyUFsM5TC7jfeoRnInfWBukCR+3jIhqPnUEY9rFg+hlMFqOapDXodeVEq5KWknJZyBXBjHcU4197DvEOww4LyPPKHwlmY5F1715nFC7WfejHGfll72lDoHeKa+779vuya7zvjr5/ODZYlRGEBXlPbmGygZy0mr4zXA+1SQq0DiB6gRmoDoQfaO/V9ppal+w3pik/+Hdo0CoaKlQEYLSyHfHD+cJj4xktjDErrPIUf9N3xhDrRFCgUdUet1tX4yzEvb6CeIU9e/1bjczFUd+B9D39M7Wb6GfHfpbjTE8vVZW4C9KTFr7C7XydoAdOMs2sbg2KO5oYDnjWqQJeUNZtAwwa+jCkyd2sxz4/5K3v4JQ5fWSz0yvs9g/UCkfNDeeBK0IcP/s/7fvs7fpQtxXzzS3/3V57127/4IVat2HnrJ5/66ZnfgOuv7/jJW24Y7PgkYrdc9Ox//exX/p5ji/kj/PFCT59z1XtFc0dojvxKzLBw6ZWseusq6yf2mhW8oGLQZo1qfaTOlfNF44BHttW0gE3ckqDIHLMNMxw5cykgi/srcmdqZuNIPi/zWmFMmnt5mHfdZJ3r78pnuNAuwxZc6FqRGW5hnttEZgblXBpHFzNozyIXRMv4bzikueP2yvjo6Ug/2pB3tKkFhotRQrhWtKz09H+h5zuzF/ixjoazu6EzqgmaOmoIIz3Op795ok/f5Ptexe931XalcHcg1XKCvo88Dn20tpZ9xCycMcPWqCsfvPGcvlJycfCML4wA7leFmGulqFvZYDls+WhJ8X9NteG1Cy1zzmitmsXOeCgFnbSfZG8SXS1PzNhRPftL7CK1bf0ffSOfQ0pCdhtyaVNM2us4LXurRHuSkP2FtQyX/aAeXb7J80EDrGA3exfgV6hZLQPG6lKgsi1OUW2zSryR/nqqq8QdrnIgyqLiHPbSHnOiUC8B5o+5lCUv/bnEX7gurJKhsNTUjJTx3q1s+C4KYZeJ9K2rpzKxviWypyF+c5pudd3/9Pk2rvJ93EWbX29BIr/JnDg1bzApenTQRMS+PMVjj96CPytv40H5DB5J3sFjQdwczxpBXabmTEQ9UWw5QoUpjwBGCc1DtdhqL8LsCfgT4scitfBYohQPGA+ORGtlWR1RzIoIdJmgIBED5KylDPfpGmLCqRFLZdLCaBJIK0UbvFJ2eeoCO1DzIh484/FYogU8FtABSC7nsCbNYWrP51Fq/GKAfzPGPebB0un96uqGZkVUSQWEa3C9EguG5Fsc7nSFG+xqN3rcIFphDoYa+XwLgmzxeFJs0VaiANSlGmRQVjXbiXlgRl1OlnScGjpOTR2nVMeppePULo2nZrRcGR5xmEFtNxwxoMFTEtBo4rFADTwimtXTGWm0gl08IiyZEKAsEQtlUlRJ0gfU5KaC3Gmv4gzaQZ6hjoRZawR13srFdWY4YXsRq/ucOF8Cpo2OR4zxqNvxWNx0PHxaVLveG+tuWFDk+LAsSjk8LEtGtdkOS52WjOasbobUoNDuYpEY1S7rya4N0grhXrJ3C+0O9bw9tHtCqk/sEt0a8t7ZZovZljnjOckfvXd/OHE7eTXk8DJ1Oq3an88WllcYXuFs7a6iiNHUumgUQNezAXWbJvsFyR4GhRYWv84WPcFEUlOusurBrF5l1ctKHYxQZ6OAKA0/w9yJ6rDy85YoyefkOlkGGCa4zsphmsWR+4ENZic21oeccw4jPmfsqvSfiMlm+YaO0ZBWKpZxz75UX4OC/gEOZpbyzVPo9sua7X5kq+ZZcEV8ejxtkV9uiS3lVJlBDFltXYQHPdWAj3BFFgcBcAuFG4Nd/Uw8AW+hELJONZCkV2SN2C40lo8glqYernRt5TLgiGqbovKC3hOsywTdjrowg6FHTwr0HDfhwUayzWdaXUOrcNKZq30fsZqzA9WAGSGd1hgkKnDTzfqmZzh3S1tJbUrWwH2q33lMFOqs0UzV9TwX3oJE3rj1IMPxECoR/0c7+l0dKbzM0HYdp2XaegDSedp2AMgC3zCiyr6lrBElvxDVCM7wy9Xly4DfXl59K4N3mCaRaxKDXepfxY3E7TQv5nxxO3AH1YFpBS0CeEQLFoaACcBEHbmlq07xAHBU1L0tz/BMWPraz2DmJ58TC6aCnEjJNEON07t5YsxkUWQPpZCyUzqYn0LEzczFetUM7eDPC90vyOadZo0esRZnnA8Z2Jxi0nZW0rQN2u88sdOljUebwX+dsrFmPvZbrBwvVy/zOYVAXa8utwUQ2ia5odtW6Kp1enVSU2gHilMUBRJuRgYu+pThEbxrzbY52gDbKm2HnCW6pvChK/xzL2FQCjwKBmmKWfB95U3ssblmtOrFSsOpkFDIqsj0/T+d94knP/PQX1+MfbEvm6ZMSJ7u0gBwRwQ+dJ2wSFWigLsf/vfrlEHhFR3r/DQotOCPpdd4iie2iMlh3tUJD6q/C/bNwOnkK247V98o92oMwY11FW2twxssPNH1+LETjtGBdoDTGcb2SCgGkhuC62cO0ZUzlH63LAk+i04fizmb4cb8PCiUpBTS0FU6W9H8LDxypRhbZDownYqBtufgVntVMH2KC+LgAjdjKjG0vS/q/tsxsToEnz/b9cyhoDPpnNvoHE7yr+kVwbB4wm35bvfpTpnwOaMI5W1DtBj37QVVZe+EAlBXp/ltlNGZbo9FM6xk/X3Fjh4WlN1DnO9qdt3pzd5Gs4RERteO7Mfa9ASaRb7MxsziHTQDRewEAl/ZQ8NUBAJdr+hZvclZpERMhYs778izVC1NyQqZ1yuggz098mRd07l6q5mpnKRTwc4Px9PAloDegYaTcD62QkN7xK/ncHt3ofGykqgjCpbvIH0LbcWyktOq2EjDgzi/v54D/tzc7YYAn6pL2XsMb3H2ef5N4CZucuwEnTUR1wANbZgNeUiLuACLYspPFiZi5idi0vEY5kcs3/JA2AmutcIX/IXy9Mq/yiXU9UKmdHW3FerO8dlFhMflRawaMB5FAHZe512+cyJfFbw2xVdVAwI7XctyvNXX84ZdN+6XA38l3mCDEjxWi5RjUXomRsMQqlzPBZ2jVLaEMyYTFpS+B1MeSu5mN4q5UhwKOUIOgUMXf0xWFqY1VjnKUWEj/K4t4j4oLcIV36VFt4cbmN1evgizDAgsc/I8LW3IJucI458R71mSRnuHQ2asGvBxKBy3mlpnsIAy6xTkkto4yKA5zjsoUOTioOBqcb1UgJZh95PRbN6BGMWeaTQJxyOcIYSVLWhxU2zEySpXXVIpa1fGq5QX5o0+jCkL5VvSkYEWrV7tkdIa7lTSDdW9ntpigFyTSwa+qwaaXmUNKCxv42TpTb00MPgW8jNF+BX+dUnJK0eVC2vkqVhbl5BAz8v3kN+/MYARw9Nxh2yP5Q9DNzyR6lhIKnHWyvGUWwlM3DP2mvXA4ZHLLZcEK33Waw1F0B/4Ktns38ODF0/WHJ+o2oVHVe0u67mZKkuarjMB744iLTKvE3yqmBdcxDqLwaALFK5aWixoChbonEIZMqcqy+a+a77zn95w1fd8/uLhOk4pIKmYwUOYNDXyhksAel1BLJf1OQDFjn5NxaqWv0aNaGQLuWRUZi2Ke+u5nPRhx5sdALVvgrFusVT7QBGwYEKNuYg0cn++iNQF4vglbcmyDPPhsLTvgregfOuneUDzeZeWZJ0L8o4OkH7D5ahik3BzXX5VNNVCxpJnXLIdjoOK+V1axD5jBo8ZdZ8SUIdTTF1zWhCKsfWWJ8paUyViUNSlimX9qF5KVah+ZW+y7jkOAGjLeMIskDyZ8OApG/kMstCWcmwq77WC3tOV4GBS3e/prbyOXMXsyGAXM2qjLqaOVEn6LifoiAY8CfAJpO1XMhHkvMA9DliUNUQJR2LSE3hzuderTBhHcut9qi4uW7BGoNvUVPBQJPfcL0BjR2dHHVhUH4NMU+gRk1O86a1NRqKosntWnFy2OMmTGpBbFqc3ipLLHMc42TJIRYCojCCCC8rGNYHswCjA8a6A/CkWYVb42HfASYTA4YBaeaAGRbQ0UXW318dpDugToy+xTvi+x2i74eeLvKeP8i4aiywLVdFPLIJynFcxGI76Aq+AERIx64o2L8dHMzxEXfA8XepAOGKEJnYzEEl9oaDtPAUFdptFB6UwaYv52yVJClAcl4FadPx179FFy1X04kvpvukgikBW/0zuPuflX2xGpEVmolBT+1OdEbKtAEDiUQrYBB43rROXDG3PSitD+/7Xpdc++P7/+hcXD3HTUFG5pei9OEqvFi29ckQvWocMGVSHloXidDHKeMFudAloYR1TC+LANtqyMt5zStnm7V6+Lk7blkAsqwvEKzChAEVMlaEATyg8dQENNeCiBx4CfKVBQkP0NDJyFCFSioDpmXcse2zAMI+3+f5OvInNqBZm76JOSg0bXRjgSWUWx2BiMIvjyixulYu6CuOgvYZlyC7Kh0O9270MJfo5breOu1mae5VMCVZu76VFi0UDhB8+Pprth6MfrOrUBCjhQFmEWjrbQL8XIWYBiYVMMu9y7yAxVXJkZ5FsTQMruVSMRxeczGoZMFsElBb7kYGSrE+rMqu11kxPvzab1OFR7BERuMsGBjaA3pLkCWweGxgENk+gjZczK3RVluGOSgbmVSSwJGiU5V3T83mDF4pjtEQa2jKxsClh2GLXtSIaji1tioDx6KJmzRwyIuEN5kgZ0pf29nMjugLVroEazVnSviDGxkD6agwRJnG7SV/uwguZlwFeMvNyGC81+xLwy16bDS+X2wLwcgWZovFytTneU5NTCrD5lLDnxtxjUVpzTYW9ikOYFZj0FIjkYNGclzexCNIs4vp1QB5AzTMc+u7fEJd0+VYWfRbbaNsw306tjYKIhnmu2DFnzpyXBCmLWTE3N1+d5+3KQgZWqbJ717GKaUHGa4tOvAhDsW19kPN7P1PU9TFGM7pyz9D8AREZMrjnxTd0rJLSeJqOEcZ930c844wj9/R+T7UJiQtC3FNpOPBoej4XVLX3YlLVlIJesUMZnm7J4gBtHH9D29eLnXcM4T2kUPreJvQeaYU4WIzVED6/JthCeLSDdrLho/FVfxkXDktladjvxIyOaSv3/dUvu/SFHznloqcNRYXdA6UcwtNgMdAqc1TYHmhtEbyDJ/wC9SBZ4tS6IBCfYkPOrd7erjWO7AKpmOO72iRShOWvX7P2t2LmlcAMqWMC0FeVAujpihVrLFAGLsJQ6sjoSvDtQSGUhytKkL0pcemUuMaUuBDGu7AyaQxSI7v///mvR9VJVZyMpmpK3h/5kdMPeaB6sKKnsfJIyM/+Tk6nQ5gcJC/7dd1G6rsckP8GYvKojAv2PVn+/eXF2d1IwqGQOcytlQJa2FkLp064KyCosHv7Y2oqzG3tIHYcQsKxUTQrKtVNZmhx3IvDiew3USs+G5Q2whk27F3nj+GBE01hAciG3SWes1fP/WWT/Fv6KeyyaWfMx9j4R0DPBtBzWvdT7ZyH1vcPPkkMiPQ/3HquWlr+6OFXH+JEghhh+0vO879dm0ocA5du2W/bzXlLAXm6f4WKdOFr04rdI2vYHT6IqjFct2tuYm9h7c8+dsg6eWIuAzmSUgOwooYAsO3UE7v+4CZoGPwjRrz/17gR3WfdBACtf7R1WeH1VPlApL3yVf9mfFDGtqQFYE8568ZBjbxozeZv8XqiyASlf0nq/8UbKgVwLQw797EAx+bWbxVwmtK/+9XuYx191YiQ4bQaEf9UD5tiNTd8hTNlVzeAqFOoVmwCruDjOgpq2D+BSjA0BiCfyZvmfpuYxYbvUczstsxs6GlBwSs092T08ybpQIisjZqwPJS9DlVyCr/3JIWnIlTA1FQUrhW2sJ6q4wVs9OzC3OVX5IfZx7o1cMYZ97MHHGockLvK2TtQiG0mV64XJMVpoZ4GacMg2oNYrGBdoVQ5+lZ/+/cXyfcRzOBoizNquxbnidHt1MHFmWbSk8JgXYZQSH/7y15iDYhnaoJgRl1xzFJzI58rj/RwtmrXUJ3+WITsM5+Xi298okztNbG0ujAtEzUBaShusQVQfsCnRC/nV4nIFyiRa/LWZSYajQG4VM8ad5qyC2R/wCsr+JB9cqQoayU0LyzrAi8085x7UeBMCc1lt8DPF/qHBsA6aRd6aA+3a54fhFFct0+Uzzn4e6QmjWbaas907JOT2JQpN1wFmqalAKoRMlAb0bM0j0ISNNp6FpkBTzNDDc2oe86JkYcAVzKoUYVQ0PlAaQe5z7LEwaeYJuZzxo4YHozr6tK0yw9Y6uCHuLiuyxkpZkUCa5wRU2LoaVJwYG1jaOwtXs60eG69mKtYza5YZizjD+8lF+TbFH6RoLxLesRPvu7V43fB6d/R6+ygi2hVPNmqJpmsv6tZnTG7qwO9BKCGoo5ZV4Rq3QJx6oPUy35PKbjoU+KnO6ColC0P5IuNfaKXu/FZnMehzzCVtDHm/vy/ed6k0SHcqlKZWignWf1Df8MQx5teljKW3XwQx9+3+mTQjfiDcWujvxyGnuhsh1PuNXgUmItCH+UlM8o+IX2KVaeqi3UHHFooxxeoEaGu9U7+EHdHbxGop63sk7JwqCfJ+NIi6UEMQRBFiKtfrU5X35+W6j6lHyjzo1/1xJqI2pts44s4+0PkUuAbbiBU+9jxRlUcDhq2b3f0g/ed89Uzz7yyyu+XuUYMfubBiBn3gBrQvHaZwc6tQ32brwo5/pzSirLjHUXLtYCa6+p9sGjelt2BAG6t8+eGsfmHi3FPzLUAhiKhqO2EH9/r2sx9WVfjpi1qHhlqeUPXtpStygeqgBKL3YtSrD0kD6hDdYGbruMDY/sGg4mrIPcIRD2FqLtvoVikf5f11uAFtjRUcjQs712IHr6nfTX3OUPgwaH/zShqDi24UISGiP47Ez0g78iw4mvgoPCUkGUZrx93heaFIK6zLxlEdvYFrN7BUMULsGIMkRXag1ZIt0PYIIu09sJYTINGpnflFDcHkRYDvclL89Aqv4VIktJyuCbl+nK/n4zWIZ4VTdnibl4v/HPAH60D9poC1IGWcDlyaIeSpKUCrOe3PfMNZ9V25fiQYe6GRUxGpc+A83ZwnH+EEdzA4A7l/Y/xzvR1Q04jMuEJcW9Yslhys48Nmaa/vdBu8pYjMYdAPtMFX1yVJK/wXmkGe+CVhEgkgz7vusTMPfhRUgsljDPZn6BWlS0RBh0cqi+SXniOBHmC78hPWxNMu2BVhQp1xFbgwi5sT9Yrq0gtx0c3Q5UWXvoaFApTdCD7U8HYyja5NXWrPyPqqzCpiPtGsltXsUITCgqz6MMhONRHuS0VGqpYa17YY/Ws3soXpYX50vQ6Ko2o7MbUnj3EQcYenhobktu7vNmC9AvLFCq1Gpj5cqVDW1xwxfr47eHDVfmwZz9coRVW3kuhcTC4I1/GnUbd0DWQzh8LOGHL6AADEzffcrB3I9VzbSiAC9pK3gZ/UtvItwnNXR2RkyyDyrq6ub20FV9t5weLZYjmuYqFnIGdR6oiocfPW3TerQy5kpq557BtOHjvHl+sA69J3bSFyziiceCCPXvPP4KwMDJSl60DcMm0fZBDIZMGeRsq6mvCts1i9673tcvrOrhocUmx4og0Ii4vtrmIlxRLqt+5Qtv0GvMkWmDSD4stWik/2noS3tQbcgv5ql03vpJvkbvveU4z5Sy7svBYd0dyFuzT4JuvyQtOXXv/S3+kG1b93pLXe+/D8/kOg6vAeeCqoGygeLmzUlFg7QgVxpnhLmTs0U7K+XvRtIOK66zwoDvyU6Dfn9emCE5PzU+jU/NdNAsLzgfwbbEgW9CeStR7AC/HTPl0F3/KhYpDOAjNOjC6oAP4cINv83/We/g+cQZHAYbyNIo0vZJ4mjXNOy9MJrfkdOC7SGMKWA+c5oMOng6h67NJhafTqVSbqInjtBmmwkgr9LlZux7+jFecwV+djsCZ/MPSYPFsewadyd/y29WakV+K05ARgV2a8QqbhJfL9f7xZKuV/JEnvv2K0/hTOu3hz3l0Cv/kpxgrBnaZMLz86qWqyYvxo1XA4tmn/WRS/cvPQBom5jgGFLHBgT35nKLC4rTPjUR9UUTexSzVFQOS3Ds+ulj8SAQ/NscN4pK+FviR/Jvjx5kWP86q4MeZdNYjxI+phxencQosfeC5Gxik2CJTy4fcA9fy+bqoiJCAQChj8JHqH1dbE9TaRaeg3s/xhH3qz+y5rPpXnIq+8qev+tbqX3E62vYgEHKiadJ3WyLhezK58StdMlZ47HV09UUhRwR7efjw3C34IoR2F3DxebC0JIgGI2xq+OWzQITTZEGw76elPP9YMIuMGCjiDKhSx+sMe/SwivqsNRGfTkGTMHX5mfHT48/7rWuK2kvO8KERKKZ15OV9yrXS2e+DNg+O8JZZ8W3LaD9yuM3IVc1NZlk3N24io+pqr9074SqSL1tpgt7vSdXyICZ+NpAdGg5lSRZ9nyft2C0gvz8oPW3gCkWz1Ml8kDeVM0PxUbIx2Pfd9Q9f/6aYvUlR292Hw0q6sY4zFCcYHQ6pVequUG0k+SiSB4NyVz4AgAaDI4VjTkiDuv9J/9r3wikXs/UO1jp07Yxou+IuWhYv2z3v7FqE3QQsoURYvVkmwxms3spouqRiUB5BBRBgd2DQ4+3IrDM9olr2E/qqNlYiFXapwSy1xJmw712CrJaLxHGPsRgW6ie+ivBYUkhya16yIS6UnSweodoZ9tVdtIfv4GYJwgcYBv0jNI98NV+J7LANZGx6i/Ea7m/19nX62oj38aosWNmS+aXNZGcxuQiqbjbWcQnrDlgFCJw9lzwsJ4+3BmjKtg1wFmk33oZHnIO0CAl/YRPK0nVLpcTT7uZ88t1uTl90N6cvupuTF7eb82UbFqtPGtsw2WmJJ91Ym4c7yXgkuBriqnZLaKzFUB27Oc8qmHrSKrOb8zElufPJaB0xcS2mbDmArxFq4UA4Vocvuzm9u6RAlN2cLy0VGGI3p9/Y3VyM3RwSK1oOkJ/sPzMAUBnSSpWOFKEDuQsygTKj5WtFtqGyGLsyq4PkylRwUYhS0tGx0k8PvwZYHZYvV/WM8ALj4nagsgG/YzhM/9DjKT9qB41qqqTgZ3+v5779BWP+PdQYXApUWEmkYV9RRYBHhLT+daVOToRStUpM7TVcyPHWnBt465Tbq2TgP2whAtVpcW54QivJJI7XM24ecpVkivis4NUW0DiBw/afe/2keajjf/HzU754hd6ytPc91T+d725WPnVvJy0nsrZ339997ugFO37rwr37fmXjTfEDS3ts4Py9ducXPquHc7xn9Qbi9yIs/V6UU/6CvYP0v/jY709YH7aeXRVrdVBRRnaXUkjYlvLV+Phvi9mioGKtF0dZg/TdXhCo/vIm55iBjnvuT+idIRhXzi7r9lyyPnYuqWeXU/Po4X0eqQ8MnCcbuy8UqNuE7M8gPRg7yfyvfHcYeIn56yso29rdirdHueDm4yvwZ4c+a2ZX9rc3SoGltiLwH9REi17zvGmmrcVcDD+gzmtNWkMiJ4ITIYkqZUVIpax91BpCvMrMwn0iAkE5VLHIUQ/qoihOtaowNPBtn4RwnkgsGlTFotGIWDSCpGpELBpiTcGoHCmcyj/VR8SiiWsLxVYsGluxaB2KQqNi0dEli+pVf1Dfi3QnGA3XcZUhoXiKWLTOYtEIuBKJFETw5wXKGqjhJNyGrBaVN/qeaMN7hTcJwK8B4HAUz0TZAS4ZAVxagUPdAq5uAZfgrsdxAZcMpWwHuAYFAFdK9SngShy4ACbyIMrBrrBJFlo+7iJxgpcaG+lFE0diY0CEqigTYdgZbf5HBaPYrAAgC78H0s7vHADA7DVY4KDwAieiED/1OFKIdwY4/9mcb8yDKivoOXG9ZQurTCG8tg0eT6YPrFg0jekLDaOjTlzUodY0pi/UYihSpk8vTE9j+oJxpk+sIpuyryxCMH2ohQPBVKZP2c88mML0BZNMX5hXGSzruGWSywpGuKzgRJhx5+OIGf8z8LFqVw8fp+uygbmRHntGkxEVaiiCOysG7TerhrDwXtbjz2o/7IsF5Of3DjDmp3d5fljlQJgn9Jzxi9A569XjEV27CzF8DoN5aoa43CJt3tbQtDU0/INvQnW0NURba3jIiKIoMbCnerHRAWwWY6o/v8eyF9hmDSYtBVvjztlnD03ZfzoVG7fBjdwGN5rc4Lp0SUWTHlEV6A23Gtn/CtkVExkzsvv1FeCNyHeb3AhH23+intTszjbSfEG5swXnDDmd2dlGurONjHuOkIIpO1ufW3WvlBsIHZfsoI1c/ejOtmKI+JPAi82V4JxcBUu6UazKo0nduLh6GlN3weS4unHiRTEx/OXx9edECFkf3KFQsScuQ4rVvd8Yg/kcnsnGHZ5xjqdud1RlbPj6UQ94kN9Kou98BVW94LXkM+hmQW0QezDFdPIBn5sAnxJQfLTWb7DJYLVK7KOd6imNQuCFL0QdOkx692/akax8W1MCiu5qGajyEZTTSbN7x7z9/Lm+b61ZPTLG0r9AXFX1alX7+ilgB1PUL30SncPehGMNIPRwO/2iz2bUle33BDHxE/LRIRBE9paBEyoBGSHwlWjlevh1VpSV+E9nCi6rVjjGCDwQh3RfmgeVumQm1KWuUIqWM7C6qStEvgh1KYeF+RJNrQtzpSZnP1iJtEpluzCJTDvFGdClShqV0RppS4ifWNpSR9WKGrG2BYowGDKJTtEOqoPATmsNr4OFgIU4gFoneZdlOYPWVbSiY5D+hudFm5hVVwqkdEnvqOrg1IUSbarTiVFIyAeGZX+NitQ/PkrjR5T9jSKOFo+SVMskkleQKKaT6C1Gqq9etwIlSeWFTDMzR+jRK6aYh8d1NnXhUkT9j/4jozLqivBxaBBtk06o2XR1BpB93qqyUOQMzFfr3muIBohA9jkBrkdSFz8qQkUVu+ARGu810sEkfb9X2sRqGZLfSe0+VzazUIvU20k+nt9ThG2PfCyLER7w1RapeF0nDwiB4Jghz/sr7hOj/QxFECEhen2vkwYixda59izhQORNn8+6BggF0wvKp+nGWT8Guqcv1MZ7YssfD6kYYYVyYTz/h+fZFoRkFqMQKT4qT2QxApOvknYF8giU0m9mOPczM6IM0Io7M60JBUhInVFZb0iBRPUNWQ7TH27VWfTxCpXMho6ZGngj7EL2o+qESf0qi+RKVTgKXwTCaPgBqKchQXQ5cl+x6yxRiY+wjOzUmFVkBws4zfU5vAGdq5oyeSL5g+dhvkNDmp8JPy9RK0E4tgwUMWQFl1kkCz37fDZ+RUIcSamaqSQrzclyXy3MXg4KiaJkqRKnVWIaIJKLSXis5n4KuCJPhDymyC+ii5JBPXCe5++SaesUruFFXarS1l6rSs0vdWcbvp5tpE7JW+2i5jJW0gbVtBX9XtBvJRyBVc0Q5Scf/Xh5jq4aNK+x56fvIkGJ5/EDOi36djns6tTWLFig15b9gzqyCiBzC1TxVgrEz0vlInycitdcqKfB4A6+yx7EMqeOowOakUqVN/NBGFGX85qoJRtruVqxNmMm+5JR1muMVomuLxzI/gWVKPCezXUjUtZA3F2EVlnLXcMfUso2e90RUd7RVAVrnsHYdmo5Vh2WANU9WxAh5cuEHoVuZAIZGYz2iwuxD3xBcAtn4Iph+8Bby/7RGLvmhEOelnDQ0zRYZeIc/6Q5zuQP8yaeh7285WpAE0wloKEHeOeyweYu9MJ1MUet24Z5i5owL9BU5paVQpyAQE0YXF61fQtWFfXspVb2z6hcrvFDoV+auZsf8LKxB+7ZET492AWhqYR2i8EkHZbzfHTV2t6+GWEmWQyfWDQnwR9ZKDyIaqZYx6vZ7hXB1T3RJtpYz+cq4OVX7ZVfFYs0Ff2puX7EjZ1aaejgAq2SVGi+zpqZwqnoJYNr+N49aGPDtOzLCn0ZYhFeMwrplFq4VLVsdOq2dZbNK9W4D1sJxHSBx9pAxWrVkOH5oVNPbbu4M0ifx1GmZoPXiHBjSAGQRgdTcKum7bJ2jqmF9k9NU1m7NKLwpa3Uxgxq07yZQRRDGxm91e/+xfQ1rsT9q4mb0UkPgqVefs0gu+g3a3TljDZKF5mQOBahlv0x4tNt02LBVKg9yt3Y9k+K5rGvw1F79sChMS/Dv+KNcCnOf6KHgVAnh/YSklL45xWBWscMQOACd/6syXsqyRdNJp9VSd5dTZYqV9esk16FlHIoLdVPViD5ru1cTqXrHwAPP3GG7HwjQeiYywmrXnQJdLdaM3T87Jqy94DOtWsQ8eiHAYV4D+0lIqQW9VxEdO47dT0bitpn31fXxnoepdsrTgwuAXqr9037vLRnvEP6o94hvbbnvEPaUlLlTlr88JQvCeDoRCRs4k2RguwGbAfzGvaHDDp1F9nyU9uHGpDYujoatcn9yXDEp2RUYbtDuWqNgHoRiXWFq2OV+BaTUIevmYQjisazESXMXKKeiODQzrrsypvq3s4462pSbD1sp2DlJEbYe/1URBgx0LCBRvhg2ynE/ZF0bb+KhTkq3V8Yu/OxOgeLbfFjZfNDc2rBKRdsObIYThI866IyEfihC3gHBOuVirUTGFVUzWnP1U4G0hit02oBo2pkubTSGaPjCJMIqLOpdYbGsYonFceIRF+MWnsKaGPDXLeeXgUFKVX1V3SL+K/07xqX/l090m8rjn/rOoymP3JwETtnOcK8u/a/nNvPjUf5IoMAKLLXCqJ5VDduWtV5oaU3zj/rHVEgtmEmZ6ZumbLjuub0hTXHIxQb4noADGzSSyVqVi5wHqHUe7SvUzXQD32+HnRhLcQr+e6uUQMENHBOjcF26uyKqSF+uE13g+whvdzhVKLFxbevJt5jDBa7+H7YidhanNI6wJAtpAGx9oO/6sIxeFPdd4diMp4d65QumHyMSgOpuDk7o9d8eLXX/sakBXSk0v7PfvJnPsn+otCthklpYe/fQPPRoP7PIAe1+vw4g9Ggo3T1K8LttXQHklTr0c0OwIEFVtucALte+CLRXGlYD0ANnJqVrlzFMg0JNNtSZhEjjM6ILe/AOHltUaIQbwiU8ZboAyvxVw0WtQlfq6gB8FMwTQWjzijId1X1xm/xe3bw9YJ3Vqynlz0APcg1r0dile6JL11nyP663FdBg8jZby3CMuF7sDCwD6lnfNX+q91gw//81dp3lizUg9eJLo4eeEOS4y5hcxlYcj5wMmVwa3Nx7h25zytsGrZ1Ug8qGC3QmuH7au3/166Nfk5h+R0D42eV0bBMXMhRP2iijmiUL0JhNf8E04Dpa33Pv9bCx791OnSmN6Rm3x/6au38ssSOAkrdlY00NdgcTJsXhlKOA43RscD6rudI+BRlmP4HBiSm4wZQgYEK4PCjAV9fjuwRxG5H04IRq4i78O6sIpK18a+XKsEe6LWTur1jG/QJio1n6q47r6tnOsfi1pnFjZirbWhb8iZ4AWpoe4t0iAVLbyPXoK3e4pxYXzQ+HQ6PIP4Szlg0j+DYJ4D1Ng4lGoLoFaHbJLJLKbXGdRJrVZ3E6kWKBvqB3b6J+vajFKiJPXhKUu8VGn+lObOC6bE6Vse6GjwFaRA1fmCi7h0ilZ0CXIVZQet5ZI3qZPqVu3P33npizfbySQD/lTdR7q05OUoo0gxnsPLgUX5nThyw93AhT5lxlbb59pVCPY3UPRzu6vHPboaYee/iZw+/79GzRLvJ5tbZIhj0ue4OraXwS0bNZu7dRPa32x7YWJ9t4Gdjp4YnwG/yXypMbRODDd+8Ld6xqFdBFI3+adMqfdQWlt1Ex9TBBuUz0q28g8euPKsW4I8X4IqU3PKlwkLKknINrDLqMHJxz+E4gkN7jYNbQlPV34wuKnpBL6VQa9Ca28xv98ysJRJHgli4mRsSIW9LvedSU5mF2Yp2EDV5Tc7nXMwMdulcnJT5zVLALPHXCVbgWRgkbQFsFOmSPgfJIyoQ260doQ4hNagzLDpyZEEdsaRnlXkUNgI1A5tY7lbr13mmQI4tNmUMCqIZLs5CfMYiFuC1i1rgBFrG5pfigQ7zmnXipQLkeV2EFxBuyWpWZmsV9lihhQ0JoniD8U1qHRGLAup9b76YwqLpWcRFhNQC74giwV2p5nVdfhcxVVO0JlXkdENharRj8Sw0zo2VthXiNDtvb3ycnfizhvYeVduquvB/9eunu/A/sQOJN5zIC8TZnjf6aU0/rRk9OOSulblf+zh31znw7mfVDr/uBB3+oWBE69ofcSDvmdZop0LheKPnCAdjuq9x4WUmLuLXA30edKgwtK7mNw7qouZOIgPS8xMfJ7ifYg7V4zMqiP3BunIiMjDr+kmkUKgsLPOukW5eDqFDRQjYBCdbZ6h1or2G0w+1SwHLR/ovfREXsCZ8mnwXIbewtjoE4nsWu2zzlVyFi4x4X28yYy+uDyf6z16Plq6oH91IzkCRhroUmdKKHIM3S29UpvUFjEbH3Q95oGrKv9X0Vr2X/YgCBW55tRYw62gaXny8FGiiPeWxZ0O6lffMOAMW3asZowGpEpMViUH9HK5T5RT2q3rOenpFyiITxnqb/R88qv2nf1/fy26WTqc3+15jUj6Fr1VdHvhpxgZiFFn9ZbsLVNcFQbdJxDkCXO2EgTP+M9te2LN7SLe9YuUd4qU7UEWRkAjAY0sayFUWcWX7TbkqX1d5QESh2eTguF5QyArSqxr5up/xgBWJPkI8JC37+OtEsK++YSWqOuy/g9Ra+obY52u0r3LcZEX4olO9/6q1GR8u/8vL67Lj1frRjJYvvK/KtnTmjkinSMmXtrymLdcytLmBllGNs5lqLBZ4Br3+fLzI/Uqz65D5xOIfPPXyvTYIYjDrAgzAiq07erTqvGoptr1iuEQXqhhlNcZa3ii/EoFIoBFK3VOKXSVoP0pwteCEmilMahRWPIKHPf6xbdUmcmRgL8wF8DzfBB44gKJ31NSrcUUKAWAyITXkT9ALNEe6m7dwSAy3InkDzRLvwvi0JcY1ExarjJShrW+tQVCXyCkCw71oYxMRUVttrshGWwQtRtDXKkFYB1yajMZot0qmJpqYKvw8QCaR/jAkBKxW2OmL1UdrKilQ6DRyACoYKQs944bWqg0lbWhiaECMw1nbUPQI5xYtSinJbkScivg9JFgGnrz0GOTRm3hQ72zmQN26BVdRAD5UaW005jo9HHOdHjm37PypFhxgjHz5Wh2mC3XwDVlAhCULOsmdr/TXvH6qr/QjoHnWG3cAUV0o9BGhCOyl88Ydm3kQESaW2r+vO+fXjDc8cKrjyC+eaWcDBApvTYPVTZ0gdQWICnv1YyFqBIInHrdD63EbAuj9QFDUqVo+psNAVedxOx2ptD6l0sRUulZx841K9xfSKSDMmFftYC39aTBEen0/MFsdjFpYuufwDcx1CQjt6Huaiswgz3gTnslQdX+/ajahGLDxfmVhj4A61YVdbE0oQY2MURQp0tbkIy2AuKh+cisYvK2HbgXzKiuYV1nDgvE1DCj4gBHdhiqzuwmYJZopWMJKdi8Shg+tjFCvqzzmgrXvgfY9NnJtXePksEClchpKYCxFv4UiqcIholiVDALkk0eIh6Rlb3q9W9jqEwvbDz4GfubwBD/TqvIzrQl+ZnfJz4TZD+PjE/Ev3zntyKvC8qpmEdZ6WMN0508qPLSnJ1q/4+NG+aJH3f0fmuh++FLXfbyMdf+p09g51jrd/yg4uULAoPjKC2J2/aslWhqhSi6aRXn3ahYZJs1yfPgmJw1fRTwH30e4y9KGqpx8tKFd29B3x24yU8l2weMSz00567tcrv71r2C6y4+rRQiuRNptk2SmN2fiOBa7W1gSPV7dddZ43EedOPi88HRm1VRbR7URuxIKObQA+3xrFOkS/6MMD+5hhGSd80HNUi1FAD2wAcU6PUCchhDXihSlsjWpl/zsx3RHEpbx3OUy8S1IbAWjacyKlhluQQZlMpv9ZT30s2yF7pFvdUXg9Tb3QdzHiBoGAw/J8FZtjyyXTb2jrmwjargeqEVyWFA2XVsWAIpNSqrRhOhMTtlcNESjqXsdhWFQwjAwMAwsDDWEOOU1a5UmpKbXRbMto1iOcq0c5Rq3D2M8bXB13CfHuK32RvMYxMDA73YkCL8GfNK4H0ccjJPuV60ovfIWCVOmEI4519uQSw9rABRGXxspPETuwZhewIDHE8eWGCb9FiykbtXk21yokzbBSQ2+l9dqo3CPSWhP6DQE0wfKwDxXVQZlTT67pnkQkjwoOEAuNYqnViN9fV4Kpj5IfzP062xPyFoIrcpvVQ8sNJewVb/Kk12AKlkB8ljRno0w4vmM6RLVwdqnp5sNPX9rmuPtP6uIaz9ac6MSUkNLb1a1tyjSomMt1eNS4Whos3LkQBe4lwujWK7ePqV4ojytBK13nTPtrzS97x2/kpqppFaRCHmoRFH5pDuzOUiAL66Wia6ggajpOA05+VYcv7e144E0VXOkBl0a6QO+7wOVnI/WaOQGRuiIRCCTdg9CMmnPRQiaKqpjinX5LAkrtu1SHcqdciHjYvGVh5+drp3auryOyeXkdFTHExNAK4u1Jl9r8kRHU9E70Ap1a4MKN6vH03pG4VHWE2g9odbjaT01rQfTRWvBZDleHTWtY2xg6wrzyPmZTf88UIi7w5e4CnHQWF1zjFNVDDtCqH4fxWin+F4xE/wiCYcyqfcgzN0Q+va7oj95VH7PdQ1VUMv9vNA2FHMJT+xxtLq61hVoXT5AE9tRRpU6yhGq3LwmX2saHd6yplBrirQmX2vytCYdXq1Jh/f4NXla0+gAlzUFBoRak6c11bQmHWDUgwE+fi01rWVsiBMd4rgis/9EZSO0e4q6VU1vWSGsN7pkSukiVyeuQm9nWTWMRPUPJLQgaylCiaAjQmj3TlUXIOxrOBMF/KDqqFOjXOPr2P7YOyaJGE61/VFldDQBC19AkdYRSwUAJKEeWdtXEZK1vSuhq2UdD/mZw3jgE9akBWhNuWikUqXY0E0pURVqhV4dkXVqMHQbChzldKsnmL/ke9HJQrWGZkQK3FiBWzdADY1uSwnUWgnUWgnUWgnU2nGBGpZAjVRSxOnSkArCx1pkfQSGWtVqWVVXq1rQltc2ByCiHOCEU8LBKe7bbQa4n8CJvFcxsRyOga7Cq0d9X3XxXgWLD6K2JQwgxdkdaIN1fXKd1uLlsQqkFOiQaEiHMBfxsa5bhIfCFiGFbeluVtRcdB1HS+SinZ6nOkjHMvUamKYWsuA+zTOA8r62L1XOLibfGqvTHukOxUeLSm6XVI6pBWQDfF7URSdPD7Qtd1CvUhVoI9P5NrRLOeW6cJMYZAVjdkTb4kulaMK35HUxFQRPPipzErV9J97z03dH0/CbgrK9CAeGBnclHL4ENHhB0SrjBzZXim66udqJkExN7ayilW4WyDFzqkklRCEu4PoUQmMcVgZk6hqtBmOK3hrM7l+LqnQSx1PreKb0GSWrWVnVh9ik9LpMTS15wXRCIYxqNy1eJLsQJVVLPjnwFN5mJU8WXDejkSHS7JXqlf1mcHrQRZyEMo57vDv6OHcPjTcq58BkZFcS6la5lDxHcyqUherp9VWkHdmHlEgb6goXMrbqCodJCN4Ii09XaF9oVrYFCWUcyoTxVXpR4lad30IhJ+iKKhFUuyKFqkd5fMC9kKp8AUtXQi81tfjopz9Rz/EqeKaegogfaaiYPq4lA/y+llzU+V0WVFHrly4kFumQQ5FOQzVDihTpNGSQLqTNwFskj6h5inOPa2/ReCCd6WZaLiJ4OLSDLFv7Z7EPKAqFVUc50y+FQcDLmzOjXHNmlD2wOpMiqZk4ilQgVc6apJw1oZ01kXIKcPeOh25/JKTbnwDOGQLMh7JnurjoKWRUEUbHeLbCTQRPwXEET/6JBE/eSIYiKouVvEW9wmbqES2OSVQrSumZ9rIu3UskFBooRNrzqOx5hCTsL6b1XUopZ32jymSa/RKtVfnM/hV6GBgpq+lrFYlAlgJbNTD4LIQEg3dJKANtK1lNbMjQDrRpjNXkWL0Z76iXKlT1E1nnZSiepcqk4DuhdZdHSoNDkBvlpoBGqRrEtvQt/fnQSyYJH/gJ5Td85aAKrhuvgdw97nsvgUKj9Xvkf6sIUtAQyK7VGb+y9soY6UhIlthmIZNFJ5vl/mMwLeBRw8pM6+Ho05Ufa/lxWX5cKT/QLFO4NCz2k2Xr2ckokW8okW/qwGuRZe1pZTrUL2HyWRe9FoBErVPBBpSC5CT665qcWLqmDDVClqGOLf0h/CyUUInTShWBVhGUVQRlFQ0tsKlEL0RFdVjfyOtTC1YmJ3XEKq2SqT/zHMJQSaEUT/wX5aHqs1LkEAU0RJoIjMey5jBHUKyu9h/sLOmWs2RB51EmEbvkhAShnTrBZSJibxkK1gT97SVbEJqeFE34xYMuOwcSzKWkHL0kxwjqIWngbJ0k6dv9aayADi2aq0NmZoUFfa0EfYJQiZCWlQlLViZ0rMwENgL0kzxHrOhYt3ZVCteJCEJBNAg8uTboBLgQKy7UK7iQ5N5UPFAXjZugQV8PavQgCTJeq+lCNbVQ4TvFHM8d46twSC5WH8KJsLvzr5Z09Aa3PZvX24FWaizmXNAZrNfZT6rCnn6MHFq6L6+okM+E5TpIeQm7k8qLXiKvXOhPL8YN78/XzBXvoH+vvXsXIEMo1j6kTdmdev4/evw/ehP/p17/iG/i/593l/2O0G/AStSEgqMb5b7/Mh5PvaF0jfSYX8V6bvb7uByc/QF+oYDCE1pPdu+RGOTcPRIDqeVFIzGejt3zNjl6vUQ8XOoH6kJWpX7VmLq8QJdIr6Jk73Tej8MiMXoJqKquyhCRImWIh34HzgN0tWqvc+Bu1BapOIem9A48PWpoPpMqcZjenMAPVGA2GHiE1m8qRtU6GlJcaIgKQV3P5eCkCvCBpQZnqdXdJmjgwuwGN8Xeka3J5LnDOqbTawXaTo22lpptZd5LranruqBa6awuLu9xakzVYJTebL132s3WiVjMPD3PndET8uwdehL3Sc/zp9101V6LAgdya+0eYDAeq6N5keoG1VQ467v7qJq8u5J87mTyzkryrmqyVNmd1o6Wi/yyRlZvI6Ew1+dfOiOdE5tr4PzDVwT817oueIXteBEIa3jQ39/fe0252Kp6S3/M4V2RGF9iSG0iqoVE7ke/dnbt/nfecKgmSmh9cbx3r7xPnT/hMU2DoSn5jEcf1uNbiqJtdebYT16Sz6i3jFqAFV2+4jmmFlM5ogVGrGvsosXstgAtRtYio9ZL8lmSBs/h5ol8Cz9Vote+kS9KHRAle3JEqV4s20jHecbsS3CtMRIDmx+GgU0kXEQSMaRFeFHmDyNCh8Ura028KS+p69gFpk3qS3qeMjERNQ/OOjzo5V2aQ4e28IM7vEILkB72uIDVwCjdiT8SPLpF7ZunWpjfmm+jrXB8kZOI3UBhOljGE6HE8Fi9yg/wRjlFqiaWR0j99rzA45J8x5RiiYskLpryrQKMFfExRoUqSyxRfoDmrgZYZteM37B8J+0gfQOLq3GnSDeWVPFyO+2ELzJuK52CwFY0mDSSaJtGbkuNZiZXugX9qHjdCODeg12MFTtpO+cl4jDM1HMCYr6AmAcQQ5qVXwpNsFkzyaofa9YaBfCsyRH8pB5PpocQ7DHUrvu+Iub3B/G+QAh+iYMijqmpG2x4ElflT3F0G1GXYrF8v5N71brh7t980e7/ft/F9skAsZDe8032iTaeUkb/qn1K0xG9F8YVPmSfKIKbKilXrDz/Pcc+YJ8u5fuuDs55w5b199mnphSk//iNC/4i59T/8MW1n/zd/3rhH33mafYpDf3c7We+4bOf+a8ftE+AC/Gv/Mq7vvMvt/7G0+3Txn/y+R/eMvDO+JB92viffDCbnZ29/mL7tPGXfgf+/dqH7FPjtaXony5dH7JPpE34zpMe03h3PrHn0Af/+l/u/IB9yqcffdd7PvC2v8ufbp+2Ge/8ttsPPvdVb/6gfdr4w4u/zd34l6fbp43///7Th5cOfPg/f8g+bfyzpRs/cbF9uu5sJx5fz0wsr5y3D3/r5LTjkfmUV2x7+NuKUycT4c0BqMyl+SbKPjn7txK+ffjbUCkkT8BFnsKEwohOI5JPaevDv+PReG6jnREb5WVzD24VK/OqdRveQY4OZX2fM/IjxkLtiGmskjjww7vwyIrTxfAS5nF+hrjrgXbumbpenIUPPy0fnq20F6X3KMCjzV/N4Evuxdn5GRRznl1YW84xOuCqJXQW6OoTsCWZYSNw+W46m2boCQewG2ca28ErT8pinuPW8oxf4/7BgIMtnr5P5IKfRGfkT6Yz8+Vgr1kp2nC3v8w/hfpCBHHoIQ7MZBmjRyVqm9s4cIbnEurkBWX5DmoxPX8SE/Mng4r3X5XnVDAQduQRbcmXaCWfpVWpDTI3dQq5k2bL8Cm0VIaJojLMhIVmEWJ0qslzK3BrG0XyciotyfM0RJ5rvSrqeewpQmGLp1CXCIHzymSaXyvmbB6lq6fSaQiAFHOhWKcyLpTnF1NtJACluhyYRE98IeV35bPDHrcQE0DrmuPaUQ5XgGiUINGuCU+h81CBfk3yMW2jcxG3TeIG3KJqiZwqmbp06vQSd9Ip2il8vZv7JN0gxJHE3cXVjZRIhEz8YdeV6Lw/yaHhEh5LNIvHrJ03OQQMuc4JKoSXKGiHPHfQFnluoRV5rtCqPFetz5AZM79oXuYXHhm18GjRk/B4Ej2Zdq8xri73+bFMT8R3T6QnfLOK1o2Q9pz+K/lKh1fz03Jm+P9RZ8Y3ZsY3ZkaQYiIEL87Px+NSLBPAci7hDA4l4pSqhTCmQgdlnc01nX8AxfGMkNATGX338IR4Ak+I3Y9+QtD4hHhCnvNkKHgi7OAJsYWeyH3fbSbFHOV5PGVizIMN32RiRJWJMa/MN2NLZCbFbGVS2AGdN2hApPhs4nWKWeQGZgtC/8yzn3f/D7z3cxfbZ7EdXORW/l7ZFJEx2GdxLicKdmnJwENBV43tTs4PIkFHQqnlFCM7VxBbNg+MjM4VRDs81N5sdUhNBWnNp0iJOk1GkbrGc5smkVoR97i4PY/HPM0Bt+cMbueCu/mjxPEnYM/2BGpRBqx8Mt6ezDieAS+fiLcn0m687WZUJ6D6Hny+h86XRQCoDnnsk8AXAbnzrILZK4LZTzrAtTL2tRifF+gMLuJM8dynaElbGGmTnPAETeWMO2iB+7iC/SN3azkvgJ7oPANnjiGTM1iKfAmsZgUt4yq9ptigYKQo6LDMUd/KAFJJSnXoLOmtjhlHIxXbxpMdM4zSrBmleUBfhg7PuclRA1h32FFZAOQXaIUyGTm8MT+Mt2Ue1wzD2sIHTI7kA/hgo3NeXPAPttyvWlMP4mfSOTRzIJ/BvpEhH9MusNm76HR8RGeUTPSzciO7KDrUML7HEQo51EJIrOY8iZ/RS+GInMeXsaSJ1b6HMEQPOMBsHTAFFsv5QtVV+Q7rKo9d9XFvOQnuFOc4uaB52cGq2AAlMiHDjtYOK9WERyhyjtjLY4sIfFCTd9KRzuX8CDEy5nhu1VWqZtbiXJ6ykGL9Em91AYZdN0pKjvCROqgLqGuXaCy/oCeahDNY0BTZwu+2RdgdPud2m/uuwSLM9k2XZ1AJ8Y8XYG3Uj0nGa06FSDjBFnCENcdACKa5KFpSJCTsoQ7q/VGLaPPAk3nqWQWrFMOwjGFoi2Stw0ORcb5WnvOSUPB828HLwxYVNYjHcFrh+nnVm2aZsffwAndwB7KsCoRJJDsUy1qk6/sqWqxLg0h/1CxMscifWsLLchlqE1fKJdqStsm3Mpan0uJtnPs0kxvQt/vHiOZAgLuEqjCR7VaeSzxV+RV8pqCufpabVWizkXE5C+Q8FwSijJynWZnMePBcxiOnAo8R+nsdJqq1Pqbms43d0pW+zOwFPJgWM5HgLDPY4s5QLBcazQHUMEnaLDiNxKQuBKaBPY54oLt/RFJa4FzLSO7JZxmSnJTFaslfjWAn5KsrXjVKovdtGypVbUJIqbeLRQCoNgRqyEwJaAIPTl1tH0DiWbPctiKU1N2iBoTtB5hKQHyaYuaH5EM4OYMHmCl/I89gzoRSmf5zaCMDBsC5rMeho0qT2ZzgPMqmWRYbXloscBXcwN35Ih47rYkeyMEyWPEIISWlhhxS8yhAPGhQbomWMJgta2HGPs00tUY5JyU86up3kcyisjQtB/kySZZpCZi2LBKCXs6vEsFLQE26hxFHU5M14lYuo1681twrGg7lj3nrxrGLzk2RxCwZWoHn5ea51zx367lwlzK1gyZejgE5qFN0BRLtpNFMW+2Zjn0yfkq8qNdEcd0+Qc5lQe7JhZB2vqjQhrVfQHt1rdgK+sN9XMxrOhqq1lEv/XMS99+IYw20RcsjtwqYzh84IMMl1qTEZeIvJfdWWpIRRqIU2AOYV1CYgHuL0gPJu4iZtKh27BqAozLwXUaItY1i2235dnTENrJBM9/H3ZBSq06tqe+53phWEAViw56R6iWwiJOTjLMcTHAAmqLohVrKc9OFuvgtIHzeRjPUuKZHNKSatamjDVX/mhDe8hKMxsJfrapctfsH5RBiTsgIUxqQlYLnzaUWnbr2kPq3eNCO4y5i0i9EVPULEbtgXf1CHN/nw+Z+IZxvMvLkInCsbsdKR1zJ3qEJddnx+qCIJn1E/Dn64l075dIlTnceHD3d8T/vTnA0SbxLfEkPc2o4aQi096H6ZE/6+MKergeXwbaGHu69U10vkFeucuCOJHf2C3oVF4N3t1dEVSvJ/Im6NKZoiJtwtw0rn42bR9HK079Nguw6j8/AKtd4wmovD/3caC8fcr3UJOnljQim+sWdo18EA7xvcup1GGlSmn6Wmlvm5OHOLlpRjtFwYIK79g4eCuDrhOJLe0UdjC3rnF8D026gcOAZ82bfk/WjpfpE5hgZrcmo1W9BCoSqhXnxsTaJpqECHufMkphHqiqx7/tvvnjtr57wWwT/WLje51lLozztqCnrUCry2ICiquExaNj1BWAw0/iS7Etqqh2jchAVICDJRSzmoOLsHaCVqAITPy7TSYzDYelsiVC7Jb491u3gH7UBdSrRk4PuFohQy55wN4zTRaXpHieklm6k6lCg9F5DcnGeQdtWlKI1XZaTfAaPBTlTzKiez4KjhiwcCx5ADCKnoTnKuHgGtAXl/DQbbMWCrBgh4bnbPMk8caPz5dcwGZ1VB5N6pigK1dl+jeK2zhH/cVsT+N8AL7TIJ/hCDH05wBTz/PCbRjEW4pYuoAsy3NZUINk1YgFgEqqZCtXU3G7JsHsqPWZVpoNqgoCUPEf1W1BLJN9jfxRQJgxIkyA+WsLfpb394IQp4qZqp3BQgfZQWi4DC44Oen2vbKhCRm1uxNVlwBPfRCK75AD3uaX8UI3E7FqDUrseLKMDczz+S1KiJ55VKRIXMc5Dl+ETdV8nHWtqn6AkSh6TF107rKkys3bM4prCLGWIy6hdMYuvJAUmKXynbDtiGFuO+vVulbzt1rezrAEvjrpI0TDQlEwsd10EJSuETvd3Mk3VENt875ape8oQQUPnUnHBpYT2F0EVVYPpIrU6cLRs6pseT3NiEIhx2Ms+WBoPw6lp7pVWxT5UJuRexQoC2eb8ohd6r/KYVJdOTXUN9U+H1zN82EVTGGGTXN0rFjF+hDyvik5xKkZkoP7Pj0AsXIOikwJgVbNxeYQ4X77TlQpMxi4GGf/0j4odL9n53i+6SagrKWRhN1G4n+xn75UV56gf1NHoV52UcQ/+/kXWusdb/vmvE+i4/VLV8qwz8qF5RTfWGfr4Mf6Ggv5v/+t7QmfmYwMFFAHqikDbuwBAbHxwxKzzDj0gBQTTSawQESW63VIYyFcE9JHQahm3U9RnkYn0sYoHIiPAK67AK6BIgSN3GrNf1tHWLgXZr1TMfqj5q83NX/yPR2P+4n3j5i+4MRXzH3gbN4DxIkZ/xVtl5AzeC2qJ+Z/+La96kX4YZO9H+WY+TDMBo0a6KNzMBMyItZEPnIy1EbVDoVjizFBox4wdii96oS+4N8VLXOXWgOrOAh+wVgAf6mpECagEdVfghlymVEXZOlAEEp5UGMZV3EUR5aqGqsda6+gJRUhsWEs+WkxD8wZAkKiKIECP3KBJYRyy6XUXLgVwCysaT5LJ00wj3pG+66SNhLznVVKq70oNeETXiuNYCnmlMC8yeOhMy0xGiQDZbSHO1xy+yYG3BckfdDX/gkSA0HRNHK8l4qdX8/omL8NSCGD/mJoO/H1oQZ8cGXnAkZE3Dz8qCHJ0lIz4KoeoO3qCj5SeJCAAQk9+mD9msBz64aHSk3r24RGbQYacR6oDYwz/ZB9xkxuvv1qZ3P7XYnJ/dGJyP1Cd3Hh75JP7ME9u+TDIfu3xnNy//ggmt45ddXI/UE7uy7nM6iQOzXXTUMdERyTndzyL0M4ntD/7DcmB0twkSp/KM8dNFJQK+JZuyRkga4VvPvXdHEF302/xvE28fSysjalsIjIZn3n+SU7g8JFN4AlTStU+hraPyQn7iGLS94R+4oxzP1CrXDPFhH0hP/CanR9coTHPI8WnAtf1NSxa1ZdrOKEQmx5cLXm2wFwdGHInxKAIioCnEyUG0Poknq4HOLlbbpCnWnXeBfX4kCIwBcyOHsDxZHLgxXnDUgrs3CDywN9lPdwMxv6vjp/owNqGsOMBlJ+DXdzWJoVwg9Eg/pPt5nWScNWLD+DxbLGacyB7h8KfEr2YLdc+xDdupt1ubqzDTHMAZ0q78EC5BzbEOLFIBXR2SO/Ir7heZsY0+2fZNopD86RoVRIh5GgfGRYzqGl30aEOzVzZQ0XYcLZhA77LiTPD4bBoIc+uos3RLeThVkB5V2pgWNQNbPDoSuPA7XOgeaDPfi0FI0JqYCZpRiP5EUihtzIuX1Xnos5MyDew5nhYA3nA1wxrPv76f2+s+cqrTw5rlHhVseYSu6z34wN4yuerB7CTspZOMFYx1bPfQTc76UT87yI+/Xzge85+wWG2Xli394+JBX4PhFSfIpYA9/9gKICAF0Rd5+pg1mr9Ddg/5pe7/TXUyECIJCnbQC+gw5+9WrSjveyXEQP86x+McLVKgg+E0OLG7rWu6vx1MQPStYkg6SiPPHQGMMba8Qm7hyFuCT9EnMjdxNp7EzqM9t0UrWWfREbE92/y1yRN449eb+MPjsS/WeeESsZquITJPefuq53LW5B3l/bvw6YEDwhQxh4uYy+aFrnbRX6kjNw5LbI77fPWlMgyRpte51G1aHNT5BbPw3CcZC+Y4aubPH4yITmIZwyfhQmgdwivIUsw8VRrf+IiTzCuiF+s+FdgAF+OAsDoIJlTOOqlKKQfrPFZ8Xn+1aioH7CnyAOak7FXLoa9kJL+pzFrKD6gV2EsXVlVz1i7D1AkEqNY7OjBMRXWZCuSQ5qa7cRmgjxpnLCdMt+c5dQYV1vUy5qUrtMtUU8Pnn7l9cALPo+bJM4TE1DMZ1MCl3hSPH/akEpRPmht9jcgU5r/EskPHVf1eEBeZXoWgbQmyD6nH+zyr84B1QYPGRoB1E4ogbMOyHISLQQCmkTrh+wHwc8juFuC9yN4lgRv9CDqkeBDiCUJHkTsKoLq+60rwQcRXJDgTciQSfAQggmCoDWGQT2AGYjri8cwdVyrQo3VJU0bOBnbKGMUPxPGO4uNXwynY6NDu+lYOYqNcQUbI4uNnmIjRlyxMXLYyHgI7NHxOoBMDgE9iqYiII+bKPR7DudCEWSWOBcYnGOQKc5FinMBcC4w95cmcc6sUkGvCI6Lc57iXIjyT4BzAQVVnPOkNV4V54Kvb5wLKjj3e48zzj3RK8WDQALjFVTdlgfZ7ytLYCiEbnuO/8UfTPni988JtrE7mNCsqrgoVQTVI6ONsSOjd7hDng13ZPSeypHR3WNfvN99cbf74qPlCVGid57143vGPv6Y+/ge9/EnEFTbRjjRiMuQKiOoDgLptUNgFkLK1yAktarvD4QyhNrlda8ZhHYaduws4HPHKC75xm4y4mZfXMzR7AHWIYDWcYgJvfDifFGQWa8Tze/Pl/G6G4V2EdqF0BaRQ2HhF8U76DfJFjCjLRTR/EuKHvVo4cX8WDiw/0Cxiro5ZnE/85hFj9/2Y4M+S11c7dlPHagkwBk5Ynu0QsuQdeQrNNsPIb338fCNkyAV7CtOoEF78q14nJtvw4Py7XokRH2BujqDWFnL/l7yN2gexCLvCec6hzAUTdocpIQWD6xRC65P8gVa7oeX5qvq71g0wVBaMYugFFywIzJ0IZKLW7NyZoPBEr/M6sA6jwhthyVto9ZCPZxZz9ACH2SjBlrt5a2+4JZ8zFWrH15IVsRvTJGPnqduRy4mrxisF3PRfYgj9t3+/bVDF913/qvygj8jPXtGAlorpedzrg8N14dlNU4OlhF7CAw9er8qFk/zLZOMaL6DIdIxegJ9nmnCe3ZoC/7EF0Oe+fAEvQzodClTAx0LYmdmmRaAaStr2tO1gv37+Fm+k/BkxUQ9VhK7Vj3y1xBJOx7+nJfv0LMk1vKEV0CAVb1l+tKMPHIHZqrj4aMGXI1r+FBuO+Xhz3oP3+fOy4pZmpXMp9LOahJQ2ph89PWujdUGXdTxm0N/bBMjqZygxIhuMMecEbesYhhiVYsjFGfUzjq43d4hcX/kDtQKc7cxoB2q/QLe6xoG0UvYi8X7CuhOFZRf2cuLkTmgjoXyFIkvAHIsEbvW9Wgb9x4nfTjlyucEVQRuqeocCg4Vq8Ai/8X5FsWXntAcZip17c4XzX3RMUr2aUfJ7neU7D4EU4dsvlFHGPv48+5jTVJ1BCWDW0QBypzw//zYCb/7UJP0hB/BtC9NwtmlcWHdl2qk19Q5YKeTdm8FUFoBlsJOJxOBAwY/0XYpCPrc0AuiHrZ28xxYBEHASCa5TwtmpvvGvYgPG02+m+0rQK6eYTgQmVgUWtFz7odKoiQUSSc6XtWNlXo+jtAc5FRM84Hd0gFQ7B4oNrdK7kTWRmmjlFTMSv1asjBpfdAflAnQgI53QB08kFkM96z2sO6AgPPqDK8HAeOiUbanSMYoxjwP3P+CY4npClk7jEIWnpebp8Vz7O4z/Cnd2CJ0QzyeNXHDdNHQjUVKxulGJHTjVMITWrBKBZh8+LScz1aowawlAjtGZromZ7SDTi1jM9XE6wlZqeOiBA9oz9EAqzTVpS0ANPTW9+qcl/BuM+c72kCac3RAwkofMkz/jDrGB0llSBzsQT87/Q57WzLDBIUrNxbzbiwWx8aipmORCLGt408huyCoMC9UbNoY5adCeJ/RApbCxTxiIPrEyDg9L5d+KvkC1Z20QtEIMVdw8tDsIEPWTcwOO0cUX+Vcvpg1EF0AxE410NwhUFN/gRVI5QtTYdAbg0GdYXANI8+jwsdFWsCfQi0RmPXUCXrCoMH8RLFYxmlWrJuMYCSjQCjXlfFC/HKvfclwm96+1PjlKOaeD9TUFTWymncRvJX4grs7YKPJQxRex5ewyKoHGjdxdYudicXOKxiOu0nDl3OYaDOsXUCBC9RRsqFEQ+0dtGmVZpRJ0mVcaeMqaCNmpXJPXeKPSxrCU2ch75lOMQuHTOL5rigg4kK2clXLr2IJXun90T/A32LlZxqnmzY79wz/lAJ3UppB5Ay1LG68o8o/qd0BIAiiZTpZnmihH/InjhHa4hiheAyNwKqYq//XKilKxpgesIv4u7QnwhAsXbSFYmV7pJfCPfb4s1WKCShVwZbvZjT476BgjOb64siYEn3H0JBlaMA4q+L4DtJ7ZZM8DSaeJm3K0/QAvp69P8zUaBOeJmC0FdUDhI1dWFqZ5GkSFM7YYIaDFnTjtugAvbw5oAHWjBYFk1apyyFArqc7Chm6ZYKKWIVZArESqKxYbe2okgpbpJTITC1EJwgYpYAXvGOdosItmlAtqtKiVeIhV3FCAcxcAaxWDLu1iBemDwI4ZbZqtFXVxZXZ6jpmS23SGWYrNsxWOp3ZmjfM1o+MMVt4V7ZHk5TZQjBVBK8yW2Mff959rEnKbMnHoiKVLxtm6+YxZst9qEnKbCGY9qVJ2OIdMPNMqlFmaxlxk8xWgN0UmK3GAZ1Jq2i7FJR3hKCsKrPV4YDszjAmi7lPq7qWu9N4WjCjNslsLSJy0d6Nt8zWj5w0s4WcmzJb8ydktnTcIz05eb+HZ8lbBTD5teFJ5RVWTGrc4mABuGHTKW2bl8UOMC/myvYVCxPbtZRvF+fZo1rsMprH36U9S73maEFNpXaUdK0I6Voopxnn04tHhvUKHOvFj/d7DJm+N8J++bINq1AtJU2TTJiNzWhWmDAubwPlyWpSt4yYTkazGcOWs8KIBW5JU0K1rM2lriNeElaiNg+aNU/Ll5obqcvPFD4rc2Cfd2BfHQU7sJZrz9T4DPbMxI9eBQYrulYatmt1knz5E1SLiQZ1plAtVRw/LtECy1KlWFCirQCQpSn5girhGy3I5Sr7qfPQoWGmRFcZUMFHD71xgNniADM/wYACH8F8OVYK2LUqZW6h+RMwoKvgJuax1ToxAwqMcgxooAxokCkqWQbUKctWGdBklAEF4TEMaKAMKLBlARiyUGII6NYUGEwyoAuUggmffzRzEsiCP4XaImBmGdDFaQzoyKyssp9Blf0MquxnYNjPhGbNvDxZDlThuDkHumAvlSxWONCgwoEGRJtN11Vw+6sGMXU61oC6DuKLm09HgLpDK2Y66mZncdqsy2Sejs66iPFtFvgmM8/XmReNzrzNMWehyiXQ8jQGOqamLAG69LkpN2+WvhhLHzdXeWnBgGX9YEGo3+pmvDTPadPGIqeciis3Y6VjaZZdGpWVttbmjEfulmbBUayV2//jmXGXb5p4YpasbiXrA29Msn7LmKjmJrwr9yBJyj3cjKC9jDH2xe3uizvdF29H0ErWjRB/7MN3uA81SYX45YehENlSeh1bUXhet8LxPCkl2o1SdN4sBeupyuFburi3SzH7TCmY75Ti+KwU0avLboTmqkLqeRVSL8i3KmNfYF17dKLKolAGmTHNvbioHSivGvvQ1T+wvxDEyOcoJW7CAWrRMrWRcU1k1im/MsYd2J+3VGR9l2yWfWEVJVjT60hqa6ytPD+ukzmxtTHx1R4RWzdYKJ53KaM5XNhsUgpahGHTT53E2sqse6My68VpMmu72ko5+aoTYW/lUlBssU3yiVnXrj0gyGdcx7a7jqXokbsoyeOyDQLseKoBtVz4moxi/Kn/YGbdZ6X52ynlPhPlBf/tANFYoZpaYGlMKazId8C3PDGMUEyz3OHNGck2nirZrhlwz1nJdg7Jdq6X5doq2QbkxR4HzVBTBVeliBpXZ6mUZec77F2+jo7RLBWyr59V+YmVNG0bFTRvRR2yhORG0FyrCpp7tJX/67Ggeau5jlsVNPdSJIqgOYJ836cFnQMY32KmHOF8m45fQ6YPwxYptRfnrUcuUn4UcuRt4mDtUcuRa9SaIkeOx+TIcwDCHCYdJKVpRXgHqg50AFXPONBSuUhNGLw0b8uEc9LjJhaUctLNrRVtahhyjchV63d/bjPpsdvOtFvq/Xhcdow+SaOZVMyBPHCbaK66ndGh1u1M2y7Bid7QpDp+eTd7k5vvuvMzXKPEK9eowx7LtHXTdNVN0+bYNG1RjGk6uwmvBBw97BlkPWgDV5vnFQTSOIs/lsHUpJkzsqQ2QeZWSGYiBgdXqfW8ryKEAf2zk1LFCbU10D2UoxIZzBDQQQVRhtlgOJ4GzZXMU26nFFwmUc1xT7kpdZx5Gi1qDrCfo5bO4hljXEUYJ305iBcyL1dzOJOwclc1e6AU22GLlXNqOvjPOPi3xsmkCF+aAjo9L5iRllQIhpLApkBsboyQUAubFsHprdQob7nS3LjAZWsV04Dp4KDaxsD4VrAthg/Ry4BKXjyal9NtJS+pIy/L08nL7CMXojwKyckyejDzqCUnNZqdIjmZQdwEedFboyObsyUhLx0lL0tAfWUSapSVQ1Gz8hJHXpJJ8pIhkicQ4N6huZORl7RbniMwyLkpgZk9LoFx8hIsQC3VNG2RsAhtIy7pGpOCKi3JZx3fXJEebQPCisREZx9knU23ZdiuDZ2G+BktY6MaG/uyK4+SAMU0iz/dri0J+9AC7dkGiyMdc6O+g7vv1c1aTUQoBeHJmy9te64Xd0R8oKNYcyKURilCyWlHhZRopgzcf0WE0gZHMQdFVhUAtKkJeylCuJRnyHSardIShsURlpojLBye0dbSSilB0XCGvFDNwK5vxkpQZlSCsuTgn20Kf1B81K6GKMCtET/mHASM8FSQIJtCklSAUo0UWjRraFGtQoWUJo0SoWSMCHWUBiopagB8NQe+Bs1gTwDwLQF8SzTjDqU6DjGXHGLGSktVhjJjZChV1FxxoJkdA82qomampBl/pYTOlz3gdBlKrlvcmDrY1s0a4sy7lul5dberUjmQboubcxUZSkGMbTRXkaHkllXRnXAFhCBGwJXC4FEu+NIEjjRLHJna/7mx/je5///r0fMEs8oTKMwygdgcpmRMcIiC2YCCsYJTe3xS7jYyGYRJ5TISziCb0bCITwhK6Y8TA4DZCrLctIcKSKtyAbUqF7DZZFUuoERMa9GuMXUydqZMxiVqmMnYNJOuMznpYpmllUjq5DVMOuCaTDxfJ15tdOJtjjVNnXKGLM24paHwlZy0dH65s4IWpVj7tlBL+VIhr3pEiQkmbZkzI9KgthOYbOXKbKNEPW2rCkx0bYLApA2SAWYs1XYYE2J+xZ6ntq1cllbcAf4qCd/rVVYi6tg1DYjmdgkjx/mRO8rOxsZlibZhJmw3i9Tyo5wR22kFf3qojSUzogwzok7bVHUPBhxmQWaxhW0of6wzwjfLlF9ZpkTLojOyRjFTgc2qrk7Ynk6uTmNaFhghn1K3NJXQXrJL07bK0uRXsN1HwbG2kJZLLQsNZ5J3BbNhhWJHptPKQLlhwIodK5HWwQORdkMzu/nQrOjQAHItauJPwStIAmAel0gvUQrMzbjrHQbDygmIdMN3RNoJFxSklkg7TYsqkQ7HptsqpUqkFaK5+pACtJoOWtP6P0mkt0HLInvUG7cUfwqzFiCmRHqJWtOIdOGPIGWFTPsVMu1XyLSvZLqjOhYnTaMBwBPT6FVqVWm0X6XRPtFmWJuq5/q4SuSUTKdGaDCjlC1VyobRolhph1K29DiUDdlKGU7vqs1Im5JYK1XwrXfVQamu/b8q3lvC87Q7FwRdNcMAPzi6v+heICtQZObcuRUPcTvVBwd5gHV5yQtXl55XBBQMs0/LZSRoaUNL/leu17vI6f/jeVM8SgXkWc+y3rMurPU45KsLqEAuoS9ICKezGRoutpeyP9H7ts5Uxd/4XjjtDiv+K++x6gVgvcwXse0UTdILfkXIsZeZuIizvFRvCgfw9qNm39BUboa4X1OHSOxXEdrWIeZOgLYRzx3x2+JRqD5xLu0Zv9zZH+qVabEmsnktodaCNumFA/3BFfPC2w/9c5IvIuTT+xBqoATDWb0l7WHEjMcfwDMEnBN9OG9A2T3q089L0SC57IY03aOFVeNNnTT7I73P/oJHc2H8j8cujKMKd18cL2PXxZ8qtdjrUTqE+9k6z37Odfy73JNX3PVutw5Z9XI3GmHudn+H50+7k6AuGeVi/dk1fuP5ZP1U5QCPHgTIHfBPT7m38Hvths/nK4Ges7yKf19R2vYaBG4SCM4fCnQy3IQnji2kfUUoDI07S35+EV9Yex3yYIaJ99WjHhnkhh8AhG708Qt/MsHLyDN77o96et6HO/iJcDEbQCF3L5YCvYhS03wUZB85ZKYR7nC+sGhIKw7eeE4fUmLbTG1h44LgMFoVU2PfH73yj//x2Bc/eOGVHP5hf9dZZ7yRnnnVS17CnMGFtQ/xgOG6Z4MaE+6U7n7/cKCVyL8XgN3ibLfdin9/dPGQGlQBRA8G1O4yfd+pqBIaa44HiqTs9zs87Rg130nhOw0VwBcC3+Ya0z3Mtt0kwexPMZB5aK/FwoNykVL6KoR2SejaX7ljiP5eoWU1ZdFpMv3LDoH05aBeI8NSP+Gw3M3gro+MCbUoMj3/5YuHQx2S7H+jcevo+PNURjV4VymjOmpE3h8FKVFDaLdI6vT7x4eQptIsKcR6EHIFShEbmxVRtLmQO20h5/nHNFi1Rna3RhHn9D/hqtMqRHh2VGrGtMfYkq+dyP4M3QR78lG8boj+mgf94RIbbmWYIIPk3yhafLl4n+DMxz/eF6NpMyV+ZXuHAOZwQMnG0MTt3Du8Mhd3hNye7+xLNyjUEfcpcibg+hx1GKlDjH+Cn9qrftmkXwQTcWd/0+rn/uK8lYsl6+BT1x/i8XGoTS54Va+MP7yXXPDK3kM+jEKQd0lPLvjWvqWX3atLHPFk/88UAGrfgWVCbqVXQXyJzt69+tijj93qMu5+ICCEoXgG/dcF8KSj4T0cfECDuDD7eQ2+A0vPvRqW22Gf1vBdiL9Hw3IV9xMa/iTCxzT8hwh/TMOHUdPdGv6QZ3BcVehkWoAA5A1tnC71h/DFWRK8V+76urp2lq2ksumrroldBPWynfIKN6GozNWXuKaGEvyU0rhGSeX+HLCWE2I0gY88Ar2LyIkN4bNAHJATl9cRA3p4NhNhXRCUVq9VhhyeqVLN9CFPM4mrOSWXZpMKALDgXv2toDk1bKdRnwqwnFM44eCCciHuJ9mbsLDlNQU1NbK/vFEZoh99Iy97GpvdhjxK+ZDyOiyIb5U4E5v9heZgCPygLpT9TEu25Pii7FM3jmX5S8/zX4VVW6wdUKCXuP3zA1m7zw+UgwifcfHriug1FL0Sugr8et1rroVxTETHr6H4lWpM8T/3zg92kZRf/cCjYPMP1BE+cnxHmwkUBa/Mg5bO5FcWHCspvWd41+ZBqg3cjX29ZCd8EL4S84ThqLzHKwtOQ7p8JEnprZ7v8X3DKV7pxIomeWpRRf1d8i5M10mwwEnub5rpL15fZgqqzuICtw7eYYLh3iFMmLqEwid+v7KX/o7nON2DzELEppB4hB2IN2UHvp/XnaJRrjzxVIYgxvKFR4IbtfU+sLOOl9Vn9fRTdcyLnYD7KtLS8BmvhYQWizFsz54bhdn71Nolt9xy7q/yvElTWYCYYVqzv1S+Cgbr7tMgFmsY41OWNzzfh21F9WmJUxrBv9J61Wf0GzDBwDQfhiwqxqsu8Tw2HGvZPa7us2r2gMB8oAvZXyGi7eYGBTopML52UlCQ/vHXsRFaiSkNdlbscvRDFNEDHcJecmO4PtUo7R/7gXdd41VTrARRTQFfU8B7pzOBDPDYU4iN2f9f7xnZddi1WJOz34GIZ4Sv1Vy7ihAP4gYyQn1Hr6hjkkacnieypGXXwtOhFJCQZEKZRZML47//X4+zcz5UmzelWjXBit20WkLkDHiBOcrvRNFcIjW/I2+nkhyjugY1y6T0O/IWktrsuVDdXYEbUCOPgRI3P/u8oBSan2vzAWx8XkTT2vidqmOTB5hE+uI7BDyP8b+6n7E7IN2Z6rZmAtBpenb1M0EDsxcy9Abf1vRbzv3RMPSxB3HW08nRNMVXPUzBWu28nOYBqtC9j6JwAswNGEKa0LKbIsNAeYZ9+6JMIiE6C/wFnl0sbgisciD7B+Wx8Z5ReGENTfexrMPyXPYlpJoiA6uLlf2ji83+Sb6PzNs/y1tg3h6Ut1gOM89UDlgYRacsdfguBEMsTJf1Nkobv3aKfOveAb4U/hg2KYaODOPVblYGFw2HEiHbD+25rvCuzV9WanIH5u1ggFmpTIaBA0cH2CtcWfiM+8pY+IZR2C1EInV6UxiM+h0UHSmi0jywqF/FhEauyyyBDpoMCmhCpCtjVLZfGGPTBY3h4taxUHqlLAUtmtyYXTQcpL/gw4Qbhh13Eiz2BUAOu1GuVTfKNd0ow5+2lyoPK3RKtexGkEMAkv0LoCXvJp74eRU+BoRhqgHxkE6Rt154+x766S/8/nO+5/KLyQWv6u37Xvn32YuH4KVO3C40wxTttluFx9+OtnUX6vasjmFln+IKZM7O1tS7JBcXyk/z/NF56us89bO/1k8Rp6l2wsP37BGdtycynnb0lTCe9jdTjacNPc/fxELcnf6YGTf1zn27XwTSOiyWA58C5wVXMxyqZrhpSobdmh5kb321i9xl5DQaWSV+j5CKvfbxNI8bkGePvdXIQVDaxf1bZxdXWcgxu7g/63v1k7QKGX6/NQqJPB4qHjcqWwSQRzqDshAfimkqftadSdm/G7EC6e48SOOxMkSo11Uec8H7BfdlSLAqBSovRL0wR4kvWvhSQgk4R/1WrB2H6os8ZqiiEqlBIYEH0rK/d1YmlV/0qtLCBx6DtPALE9LCsCotDE9SWnj1Y5UWeqPSwtBKC2/0mG2sLskgV+Ds7/Hwe8xa0b98b0lpmYCqSN1Z2C8D2cPoL2oVC/v+mIV98sTGvo//bhtqZjT8Bb7PQkVuxlmwdia7apLuFRH4sJjiVxGH9kjoWgSpjNxlIn0jxMv+VVdUAFsjHlI7o+mFm1KwX3zjdApWTthfqE7YMWnnAmagHDxAeVpZBcMQ4HbLNIRR9gvm1jCxDlCQfcXS0F1aQqYlLKAEUqO30PMohQALa4rAIQoQ7v6roycJOKUIXHcd3RXcJhPq6n142NAgGfBE9u6sVusZ+mw9YgXmCAaZvpZlJ+l3B+Dv/GsrVtxtVYZA1owdT/AdAb7m0jh8BxY/5k3AkYOyoyahg/jOVJB+LIg9e1nAbYx37y8iS/wU74vYydzUsitQ5sDGQFED7ThQ1FUKR/994D/jqqoSQqKOd9QDid2S4TqUIndWsj3WCmDjxUXznTi4yl75y7LJoTrMHx7YL5FdjkwpHfIGqEUt51Khx9JCaO6uU8w/2cE3OInHA9dBt4ciGDBMby0jn9+uZkByVrRGkgkVEVfD+hCxHuPE4D+wGcbWhaGaWJ//6uymAhE9s4tYxmXtdY0IeSLYWoxFxoOXnWv9X7mJ6RXiVcqjQNKkH77eyXk0XsU8oI52u/oXcRiwiUKMpTuMsEPp/EkcOsqE7XAABldN+A08hGV1OZ5A++0eMWcOQUBVphBRpHLBKzgw4NQIqdlvv1Hbf+iQr8QVdjZvRKUx4hhQOBHhlxpeWbCNhRKHJVqKirsRCyr8oE/RJsYV7/fVtvrLNefVxuI6GuPBNtqoG42DnqbDWJrkv5wfBGmrPPbqY48+dvPjw5xnl3mSfvI87aFc0Tao8r+AWgxSc/ihUcyyanDAfGej76noV0Xi+z7+1Ou+922Df7rY7kH27h1Cw0I7r+ynVqMooNG6/fL2XXjT7r/4wf/1zKfrgYtPfhlzpbvBoXuxFYqwlt4OsN4emC2Yluz2CjH2YBJ9k2cUicA6XFHEeFxV1EURC8RMQyBm/Mi94xK01BK0VI0cUCC5ZPKMkEOe4JWvY/3as197VDeKPJh7WgAmYmyUZSMYOyUZjex+7QZFaiDNxH6mjL23Evs5jRXAfkjPspHlxkAnhCQoF41wKdd6azsOmVLWQTVfZa3RFknegDE3Xn/2XlM0NSs1+w8E4HquByHKoTQV7fv4x/Dv8xcPOfWjSMVq9ct3DIWSud3Zj37q1PvTc2afPhyonBU5YDk1urLHz3r2ahQJUwrUzm6QcAQwIp2p00ZATS5/A115TwCqy293Y1IxXDCpms+4/XPXH737dV9+61cYoe8MaIbJFX5qkCTmCT721zgztGFn8qx/94NMfaBwJgV/VRo+m92ImrVo+Mea08M40JF5rNFzsIRXLKgTlwUkhM56PaOYakvr9kFSi2pMiiponmYoJTToPYy9r0GFpnmoUirsSMOLOeOfKtHOzKEnz+qJRz6gSQZ/IhnVGeFw1ZADt4h8bbb/wjWxfFGnRWphU5qa4hcEANTieKT0dBuf9VuXtdHpuwLWqZMb321MBP1IZaJFBxicCLvZRiUiXolpXhxwzQFWs7jIybEYtyuLWawiGEEOxMaEirmSmKjkr038d2WPOvx6ZF/37H3f/q95A+V3DzDh+ScenXVHSUQc0MHJ5Z2BzJZ59HqePBw8eJRdhrKVzW3xYyZ7LeAqnWtzGrBKigghbV9Cz9BXsKnDfNnoDGp3Mz1Osd3NRrq78Ai6y+NiPDnaPkdAd25IUe9x/305mPZF/EM15YaTvqebB729N0M+xTob8i7NwhCifwCXxTMGEmcWKPEHwDWeFmgj32zmtdVgME/31+Fj3OX0HYgTC99ixYJ4994BJOC3IHqj9BpZFSf1jjwU9MOXYbM6Dz/GVP12IGnS+FXq3mEEG1/kVaJLW6hLXeZsBnD9iW1e2VUjbK6ZfvUPvwKn2nmY4pt1dIVCCDSX8tD5OYyGtLz+1odiZJP0jB/8hZGI/DTTIR/XNXbyQpIdQu+xLhM1qY5o1J29Xmf56VCNMJMXabvzuhTpn2WrqzvxgMzmkUipBcrQptxEbqjh5Syc93FhHYmvyVvSt9RmFhibqE/Q0LDU9fI1wRqRUB2POs9lgmfagZo3UZfMTfWKgXeSRhD51EF334B+MbFkAEBygrRV/HT3Y0MoBrVTne4eLQDDF+Qefp6JpRJMRyAs0zigOfps6KAc0KDriek6iA4w/FrrtpobocCZoTrOQetO3sI9num3FEt19UHM6Guqr2+UcWnoYgMS9YL0baHza3HUGUh3Zs1JzZp39W1B31pq9VsG+yalBPLCLdQbzMZGsOAdWEQUF2M4RcwJhbgE3eAQyelvDGclTVhGDdDBc/XUereqwZxV7t0uQkhNOOu01+sxifikqstCkr1JZ2TAtXFOFScEMNn8g0iQeOC2VLCKRr3Dx++dciSmzTwrr6N4BFkNIlNZYSxabHUKsx9CQSg27t9sog4jKtVPpNDus1SYIeK5SE+xQ+kKj5W254elPSIUCt13+80WANGRABURaHaGn5a2UlgjBVDNAUgBhxpQYUi+VvRmVOQSNPJHysiui7xZIyuOqH7K92KLH7vdqVxIAWQYIU7RklKHDDjhMXzxQ/v5Em92zw1GltCXZuJUjpNx/nfnG8tbUDuL2Aim0JC4KkqU+/mV5NVqsm5m6/0DMoEwp18ooYbAKFb80L00qeEjjxrKRGJQsPJeYz2TefAW/fJr1sYO3mM1LizkAbOSuYUGNnHZT79RB2936SILInGnR1grxX6qSoimkhEDCrZ6sCbF/VL57ZgAUgzKFMYzHrKzjmLpJUVkFmIAwdvs46v1YyMV6yCABhnpmcZk7zUj4FUkkq7xRhrJUAKkJqWR2S/h87JRj7RF2QY+P5HN4F9+46Qm3Ze8ENIN/BmdTj97l25z1HK4Hqxy5umHqpi4nEnZ1ko8CJc77/KnfoxLXiF4Gqx26kwFCEMNsFUSHAzyOsVIKxMymxArInqA0BCuCYZHch8ngxwa5HDgFIozP6UANapjbjEOgiH7iyho8pldfbpqq/bZ+q7grsO+qrF5pLa+ZKUMVXWCtbrV+pc511Vqk0eoM8p+VNih+vRia4+02JeiWL8sNrGFNrRQub/bEP8VKYtS8hYeSdFW95tyyTdF9giZO4wkbgvappnhOi6B3JrPqPGzjBLl6yDEzufwYP/52lg10CPW2ooAM56bBn/E2nV0SkMe8efiNXGB5khy5oumvwtim7aIReociC8LuKDE3tSscuIElBbXnLYm5EAkMhL3PpDNG9yGEp+0r4snQykuoTaSddh1BRA4egBiZO//pwBxKirqbiQaZiQCjIqMRAPZGpqNImGstIVofcgTMo8FXtrd/hXirwgaKS08VDEfuwh0cyATGYGirbvxBNucgB8mtaupLU2VwgMt05Ey8ikpT5uUF3EnQFRP31r3kimuYPWkO9vs6AAgsFgVK1ZB5lBCJlbIqGMtgUwMyMQqYhCcV6eEdsrv27ue/W3F++uT9jo+vWTECyxG4p8UVRwA//enh8B46FL3bF3q9unbXn3bY5sZuWZyEatKNkMO4Ej6vsOvPqTiOiiuygKY/ZhhFT5aW5N82VsQoasn6fIYG9YRUZcw96h2UEL5Hk0NRUgoLyQvO/VlJwnzkSnHAEyVhdr4GtzN1e0xdd4ijUiYTygiCzwkyDEtzDHeigzZbTLRGxKLlX/EJ626GuXY7CfBmqoFllXrHldPfYpUkJRC9ZlT5qCmKPaoCfpQhfqhtM+cTPEXb3XMaCbMU4kJ6PNGOaLr2c/qCJsR1zWfC7hDqtS550rBYmEt/hiCp6J7lpXKmV0/4GSM1hrjvhxNy4FNxAOhjnyBiprTf07bU2MIsXyQJyYbJZVv/ZbiJjLipoEnLxxKIRzTvYaChB/K5wM0DF2NUXv9iAlNzJc1jwHYqo7p7YpYglou9sc11rlOpVq64YniCP7Qn9GLFNXFVolpYF0lQYhSN/Ju1RgIKlmtl33xrItjCT3Y976X7wQKsIXzs3B5AWKFIGE2Yz6z9C/iGJQe2EpicxvGGBjgg3fvuv5uI1IO+/dDMAWQyJwMFSNxAPSb6LVenwCGqWu59L1R3OCFNzDK+9alRmid+QC9dDsJc6Gh6FvrpWaKnBdorGO4mUXNfKblp7oJMheTU6wWHVkdMsqMOCITuoW4WcqqG/5MLvBl2PCvwz5Qv3NNPi8AbABW8/3Os7QajAIEJRTSnNu8a70dhafbwrfIcxv3OkZpBg8IKesAU2KdTjeFzGieohqDPqVMG8mnhoAje5vsiSRM82ZJDWQ9tejTVPSBcU2DE1c/vVSpIe/s2lwPbvWpA2/GTWIbdLtflHdpAcvTrB5QN7EuQ+qn69OtAOFAJYpb+BiqY2QHrBeemZKJRTFLwyFDlTjHPR2nw0Pzup7RMhi2YsWkLLCgfYVLLYnFwAT3voB9t7Pa96tfdukLP3LKRU+DI/dZEJJ5WEqcl+t2jAZdDHIXyKjXy8kTGLVGhmXRjMlCdoeMwZwZ8r+7eAhKwnisV9OYhYEhxzwRsYBIBJzM4HBYHhulv/SI7kEd9V80fhFKI0N3EwqbedEz8cjj8NWIWDvB3aiP3/ru2FyNAsPlrkZ9jBM47rMfuzVwF6MGb3AXox5Jpe6qFAjdEaVe2RDPyQtNEEmoys3YpaZ15K+lz4YCgSdut3S9DrU6T8J96ZzxvVjqcuquxqps+XZEaum7vEDpxr7/+j1/+Ifdv3rp/5sj2+i5/r4vPfyJl//1qV++GPJS5XyZs0UlsqEBGwUGW3dlNTbtC7NmvJNU0ik3jznaRxfrHUgl1Is2ZolfMmO65YgEsxNwYtAhHrggeS9oS5NfUlUWGj2p1yva4E/yEDG86INN8cnjEO4tYGgLv7+b+O+ynjIEZliESOudvberlMEp/7xYdCjUzsOjgVNAZmtbCMWUnnIoGapmn/TUBR+hrtEPTPeJObnV3/kinkDwUPaXX9jz3LYHFDETjSRVcfxhwXH2T4cnedlXBUvHUPGgbo5vgP/CYPKM3SrZTueIsTRC1KRnj4k6Igz1AFi5rtggtnKjYelttK7Gr+XatIxyw+zx9KAEmZtynEZSGjUgK+3A5R72X/xzFipK2KMYr2oii9P9u9b9g3hRkU5LHYqFOlEU0YVn1SrxLdBGQl3l7lLxeJ3pVmcXJJEIIa6roXPBvtS1KmFVtaqzihaqSu0y0HbLwJQ1x8eaM8xnSGWWKHcvN6l9hxhQUt1A2aneisO1ATXw3hlSU9aamdHFAEuB8iTWBmMLU1Vd2ieg5kl1GLC6TZz/19LPeF5zMx2zhVEds52l42HgIJdlEUk1YmLlv1TfIE+UeDWc/hm+Fx/ETRyRigrab3A5PFP/8gsbq04BTVA4B/8V4cOGuCCIS9kr5LOqS6ZI7pwRK65Pd0Z8keptARRoBB+EGMHPSxB3tMNqBaLqFco0wtTCpgvGlB71x2roLb3xcVYmVA/coHdVVcLr33h8VcIf8gNcDI2nScPc7dI1LpxvqdChn9JthcAWKeFPFbFK2+siDLViax1bVItccX/nAXFKKrLsKHs1GtUSTpu/mD3uFzfLFzeYLzQib4xmzGP5Om9qgXNaYFMMOzb46xvt1y7qNYgqWXhdyzAJHiGV3lw37adOpJv2HK5oVKneXq0Gff4JQWFd5xEPQack+hWexyfLFqR/71fXC0exrYfQ7KfdFrVWioZH9/BgfSNsD6EoDeFGrDcQLD6MpksqQPYIKwFZ7qyZD34GH4hAE1xh9rP6CkodE9w+60YNszwBg7ZA/JPtJ5gJ0aMSzWzWEp5XatAT2SQuljHBIyxC3cArBcB3OGnXi3px9kXduMqxLbJziJ+kwl94dOceg0KWhOONX5vp6z3DzWKvnMV3vqGcxZ7Ae2wWH37cG5NB9MUha/4EsrYqXXnHG45PV67hbUA/EwmTV/gQyHqoGwsN0EK48v4T+bW/O/f6AU6sVKj+XNURVDebvOPgEDJzijFrwct87vEjOJCH4Os12k9/KggToyE45ZaQbroBuU0ZGEgIQyXWIdDR50f2aXMs4IsE8Rk3cmm7pSQGAurnrWfuGVGPL59QBIYCgjrdwcRX29OW7E91Fhn96BcXSMQuKzUy+L4YabTTxqgYJvY8XYFJdf04jxT91bbMdaCJ3oaY8Qj43b9UnTPL0RP4rtSCdcMoDGzh7WVzvWhlR97EjXrvHswN7fI7dWiplb1lahKAzsgptRYxmm/dr0aGj+DEOjpUp0TnT0XeeqKzl59DFe7s5XGlyXe/4QQ0+Q8CSJteAe7Xie/WimlWfutiIismPNULCnTsQx1AcK8PdfD7YKdIVCIlkknRfor4DA5SE5EBqSySKAJzEMOKEz67MdM7ZOJoqW0Mj0OLih8daooEK+ZEiPDsmUAHPynFaqUlU0YwUlv/M/jRKOuxJcYIxdYATSraDKUhmgYiVePc8G9FxG91tE/lk5GcZHUsj5C3dSydkG1W8LMDipJCyzefTVXfZo7aYFvzDLuztUK2C0bHdBYO8PY9Wf79A9+fGWp7MzjjyaQTJkZ8EHEjbEwsNnkpVXW+AKMRmNFIb4/qpeIwP8NrAa5untimFw28qjKhZ9kRvGEg7u0UKZ73dYqKkcCjF4mtyvJGozi9m9n3d587esGO37pw775f2XhT/MDSHhs43xwndfrhs3rEbOGzegMezRQjkKplVpopC6tc78rbInc82KGkjCy3D2hs1iuY+2dQNiRXk/AGtyO2/R817b97pP2Hnz61/Ys/981//gMLtHffd/3QR/5x13ct2sDso2g/Woj2b9Zu/r7RP8xyEXVxzyUXaQ+yKEGcVCQtrNDk5Rk3FMGjQZ6l6CfBjiMe89D+wX4bIsVM5IruxIQi1di2+Aitw/Llyt7E/Yi7nj4sk1UGOOC91ICr4P18LMzK36qYEjhHbTyzIWdBoMulz9AcE9RSeDegeUrWWVBHs4JvnBGjhMC+F/3aV37hFV9knVq+0/Y/Hs31lL97w/j1FPDg7n4K3sYuqLyIOQTdhlRV8gX4IlTZz+KuF+mHQfb3KN+wDCiiatfH19WeY/WSs9ybTPQR4oFWPbm8DhNmD6CwqXdg9KbZZtdgPuN7wfSb2SI3/+JUXjNC+dEIQxs5hjaaZGhduqSCYDySKgBww85m/1AyswBv9iV9VdrpO2YWu1fsDpnaO0Y20oxByciC3VExSIg4VUjBQ/g5Ue+fYGSx2X0QzaJAj0OQXQ9x/RFGtnoBvc9DNXrf6CfRcHRN8cXLfkrQTcZXd9B4WK2O5NHcX7rr5G+wBSM32PxNbrD54zfYYNPmwdEbbD//huoNNsNwx8pwR2C5p11j4xOXeL/IhWOhSTijrFxjC493jS0m31xV06kit9kSfYT6ACbd9YbjXWN7l47Gz3l+aA/BFKcU02I5vVKnEwEe3A617REpU62Wk4VDaHwPegCYJZdqqEV13TDJxfHsPTrvtQJ8p2MdyivazPIzQCAsRdKdVF6K0FrWtvfDL8Hx1x4dbh67h/7RHH9FyoljUZeGohXagey9qF3oS+RQLd1r9snY92a/qGJMQlHlrVSBt3L2ltwJHkkLk/QDJ49r3VKS9bOf/JlP1qbgGvKotMqh288gL+MPP85w2Pb+EWxz+yiKdXclKNfdDOX6L3wR1Du+toj3geMi3geR+vjLqdQzAUw/VPeTR0+wn/z9U5rgzFeu8/nWUPCKmeuCV0TXle7YjzmnMdIb69Dl9l9wpqSm8PAR7tdIlhoh/NC7XPjzzlqUlKJcZR73FSWMvAuI24XmH4zLQ1zN1hRfxs5CoHBDTT6VaDKVhxFS1WO7Jp+hBDma1CD+441ACxnAubX2a+bMZZ6lBAx4i1IkpCpHnbO3vUXHSO+mSGPRglbpRWIWSJPhp6lHr31+hdzIHuC1y7QUaW2kqSIES+5FyedG9NsW2T8sb3Pcd/zUMBGyD+sC6WKNA5h+nZurX4hqFNxCy7mNyLNhsRqqS9Id9S3PIJqFPvGBoikMygI3WC60l97KbWk4mW7Kt2GRIavWKS5S2gewneJYHg8GG6qCiBxbWOt4xp6OtrBxUpG4Ovus9gF9s3oXDZl8csNkwfhgXJRDJGDDkviY8cRyboYxghY9rhrAjU1C2X7ErXCGHlwzBXt1wORzwnhNx8kQZrnxRKMJ46F+MA2gi5o2c6v60tuK1ubbHLS3lwY/M9pKqYIaH0DXXUkapqexTc2YmuEAiR/AYpZiA8DIkeF0rS15Zgh22HuqCb5MLcnWInhIhSuc7ZRahVbexK2iZHVSlFATP20dS46dMZtacWiekzxrea4Km+JWwln9dS5qIsrHLKdifkmeiKiahEGxVsGNM9IZFM0dYCCiVbrBFaU2Z6Z0m7vSkUGbgXFGDelu4ZC7N5Fz1lUW6nNndcqhwOK9D8+Lg7Om9qLFwz0TqI6UkAfyD1C2hr29ggbNgyHsaYOvvSro4c94ROy+hyJaMrZjixyROUdyb+GN3MbvRPxOzbxgI09B5CmaWaDDYzOrAwTMg+s14nRO+awmIiYnlKUxBFhgwGfV07146FALuZqz/JbIlma/BVPJ4JgRO/cy92PMc3UNK3GJuq7VuGWIr5at70AVPSgNORWWxLw1gPU0QFdCu1zk6WXkGS7yzDLyLBGW5Wdza87h6p7Ao/IEHrtdStwN513HlNqNR1I8Uaxz5Ety0gCy9CQcSgodzLeiT3C9CDvk+RJxDInbrydLMU1jredskPctrDFEWyCinJduPimPdfLTaQyXXcasc4yRmAGGC/ICYOGae1XhUEtwCpx4SZhhcx5V9WjlABMl9S+F8CJHza8htI0/CF6C0HYO+RJa5pAnIdwG64pN9i5tF8zM2/KyrC+ZvMzpS0deFvUlpa38sk1ffHlZ0JdVAY/SNx91AsWLlszviFa1q3ghSvEyS3ilIqeWPAWfgEyzRBRZlO0QCqGcIkau4hQxdkwFbIATTc4fQd/iXPw8RbIOvOI8zmuLbtFTSL49hST6M1pJZirRz3eq18DiFKlEK94hcXdxsSOl7SDJtJMQbUtr6/zKpRPWfWiRa2nnIo4k7ihXVSmtxqmSKaKdrjRBKyYpoRJHwopFXUyUrnFBq1dUY+tzeYuzJQ+sfDJ7epjxvZqfKmKezyp+dD4Qcw8/eJG8gIu9kPFzu8HP07mSMwx+bn+M+HmhYt2FJX7OcdQewc8ehy6Q0BYOnS+h+RJnkxJnGyXOPpWbt01wdhslFjPx0rCYiZen6ouPF4vAq7SVX3r60pWXLfoSy8u8vizgxc6AxQo2xxPYvFjF5i5e7Dq2gJe2vOxUpM8Mnp9i8HwHMOBcQh5iLJ2V53mIvMiiQmZmQPE0Rq0cgafb+eArqp5CO2Q+IB0BybTTzY4ScSM6j57Cgcm5IoiIn+PPlJ0jMyXV6s+li6ozRTI+jZ4uk2/aTMEXOyZnSkdnyimmD2am7NRJQNp8M1NoZKboFKGc6AQzZRsmxTY7U7ZjpmynCxHJSIeZEqSYGAE7yMYD3hXmMStwq28Lz4oFMyvO5ALPMrNi4ZHPiqw6K7YopcbqoLOC0ZExWmn1FqXfQqt9Cc1hBuicMTL/JYotamd4sajdkZdtjlDHlrj78rLspkNs6Xm3gufdCTz3q3i+WsXzVPDckm6aNSg+U0FxO1y4HJuTotoYWVd8PU+SgaN/+O7vvrj6h2EHYuykcwWBL67+FRdxoqChVgesYay1sVPMMJhpY7FG0f8Ui/47RhD2PCXtircjC0WtnHSK/lMQ9q5HjbCx6PhbhF0AFi3QFkSqb+OWD4QF973d+MCnJ4EsWuTaxogY5rk8QYIWgTir8CtvSDCv5IwVCMUlaYUbWF8Qy7ereVteuhbLtvJLbLEML6sGyyro05lAn7SKPpmgzyQxnFz03QpqiZiSDh29UchydHRykFV3oxay27AL3Gb97W/XyCfR2fTkFxf8g1t5r1pTzwhPoicDSCtS1FJeo93YXeymJ+Ijw2CmIiKjU9foCbqw6Grb5iu9BxhibdkPU5vTxOETeKWu0T9vT/PjodLbJbOVyqDOPZmpuFhOKDNqoc6iZgCN/XzRNPOUp5oOAeW4/+hjBuOFsZ5qOgSEvGS5JpngPCVn5Clk/mn8Y71s7FAOhhkf0mmHNPU3TWap4qlzEQLnIUn9aDyFnqY7tL1ahL4Qv3Bufcm0BBlgjDUH6GIUk2sxV2u6Zt49vo/WTZPggFBg966bJThCjaqbaecOpm24KPGP7Paggd2Ac6hZ8WBauaSpHgWN/9Ku7mtC2dd0sa/B3HgCnWP3QOdIHCQIxhPGo7RM9gtveIR+DHZXjmLejY+/Bs4L+hUzgYmYlAJ2c3Ouxc5/1CYf+RC9VIwF+hDSvtCWgBMQPESojHCIMG+NrTizVFwkcw4SIkXMh8JetVraQt9RCpJGhMHpN0MundlrGeRXnFFoTShAQirctPbrAgoqethh+geR13Zi0crplG+gL5jC481r8BXXGDmpufMBLcDyjjJuYkkLswdVS1Yvb3X1okimby19C43U2ggIdQkw6rOUTNwzyj17zuVuHKmRb9GgycQejmo0O3vzAxM8Zy/fOit8rDUNc/HH57uDeROOvEDOEui+tKjOV0EQ0cZGv++pxir2zr7isDN7xc2FOM3T811V+EghduRY6vSv+z5YvIXR45G7W8D+kEkuxEEvMQ3xUIN6KNEjIgqyd7wGKSKuQ7w6FxT1PgjpsCtVNQnPntHWjtoAE1GuGQZp7NVh60msYaQSgqvWxkUAmCDNFwluhiojuVeDRrZ4fNdEU8JXOARl3Vp+ouUf9JEDR3dFhtIhNqIOt0OWiA75wg+g2JZKjbRynwP+pT3gK8x45XWj0otUSIuNlhRA5m5W2YtaoVzU0kQb2SenmrPIP+6oppb9sczurdNi+3uUYgh9mWKnHIeiYjP7V0Bzqiq3376pWdBVZxX0y84qaFax+bngTH6OGvJs1Uib9KgJ64cmCGu3eqTenThR3zvN5GPBn13N5HTtUdt91KOnKqFFSwyh/emTP8vyR85Nw03OTb3xc1OYZnho9Nz0wRuqJ1lyfqMHpuG/k93PL99wvHOrv0IqazYHj+QmUmvKRaTWyD0kCH1fqheCWlfz24nuIH2KjwW9qZeQPokUCvXc0F1D+tXqNaTN6zx5b039l74IYvnH32fTR6decUJd2UfeMHnD6df0IPF5k7aE/T7IpPIKJaMATUMd6epcB8OQB+YLCiqGhh/ddP/1ieneqkx3vByHj/qNR89HKV6MTu+Wnd7PrxrzeCwgKkIDJPFBkPsln9WvDsIj5NQU2j/l+8GIBc5g0hJ/sImObZCpBR8/+12FoGXl1IaGtAYS90/INSDMl1DvRjorVz6/rfNKnajtArJrNnmytGr5QXYM5ZMmZb+HF9WHWxizBV0zPpbMPc7KlaACtnA7pdFcvBSxGjKs4+IJnHt2xRQLtz+yfu52jy6m7tqvW0wnYgFGgzZPmb6YykoqylZYGz8+vqJurvH6+RNovGLddLV/W3mfJSmsms/Gvh9+5g/dk1+flOYI7v0QeRgEp2uH4QAky5jsE6DBDLn0L090L+EPvvb3ElDJI7yX8InRewmfnLiXcDDDDnTqHYSjtUd5B+Gz0+4goCrsNr9u7iL8/uZ3Ef79VLs+9XWq2vWHx9WwuUcXxnerjQNvc/WuM4MTq3cd7ZT6XTXRu1fTLnXEWf2uP3n89Ltwfal/NMPyc4fR8brxy2M6Xpw4ouTFoexPT6zk9elHoeT1qHiAP3osspQ//oYs5fGSpfyE71eu7dA0e29aEriBiUWmi+ESM9OqpgrRy9EOegHnTWo78W55xyTJ/hBf4TYS+JR7OL7iQZbdph3rVAyY90nkjF6pAjIwjMiXLx5WbCZHelMmD2wlFOm1mqGpLZIErg1dH1C07j4eXIBozy2mueeuI1Z3574yFDrJKgxFPi1WZ6bRrWb0zpCpGvd8mUZst1zdpzlXFJiA9ynQuvLyGX0hEoOXcFAlNA2vHl7/yr4eDPF6v3lNf9IL1OGPg6ff95wZFrVSKLKcCaC+cO+6BeBfv8ECMNiYlk9BX8TGCQ2r1EPuUgFnaK4S9T8sswQjMXCf35E+gftctknHqxKh9VdYnfRhz1iiD+RCidk4VTqpF2Es0ZHaR3rN6VhN0R+NOsyaRZG2ciQurn7k5HyYut4Ua64fgnvJI0VjkP2NwKxJIYH02whY5YLSIYwuUJ19bQE2dUY1J0NSWmZFSLJ1ZVM36mdFgZce9mNdrDa5ateXaaBbAUwxpdf9qM/lZZ8USUJ4QXB5eYsYuvFTLOdVzeXVK/FqRRGHK2JRjAKVzTPmiXkeaPph4dT7aXDUYAGl/KuGGFC3wkw+1SvXzCiu3FuJdUGIB9xUwGHUW83ofbY3PzqIJP2kCpGD/mMESQCQRAKS+uYgqT92kKCtJ4LJW/zIweRkIZL2sxGIpI8SIqGBSAiI1AERFVEbiMCwoQVI2G9uCpAYAAlHARJW7mZhM8iNFIsp4K4AmPREgPnKNKp4lOFRkhhpvg9Yu5ua4AaPZJ8z3FukocEUSoeFI1AqB0skxmDYRhEO8Z6tF6O+t2wVDdtxuhyVVT2Oga6uS9SRIhpWNn13cPwQa/LQFTJeXI2LWx9gcJWwrqeXe1616/7eyupL3kCbu15wmOvzJvzQ6JqvfYFUwxf1dDg99ExPfUcYh+INXgCBEBcYOs/OWqBpVyetwKTaR37jVnyH/PvkxeSCV4qfeAPV4eMgVrnL831GC6rJnVEfT75B6ssmSezE4o8VyrkKGHHFQPswC6l23MU4Gcaiakw0RotYkYq/9y9rm6MNr5IO5SZ3bU+s/XimIEZnxn5+l29EGwXFPEcv+FLMC+cpysvC1lKFldW7aOW2AAOukFH3MnZyUph9wVr99cWKGp5gIgEVZQyMXzFPUjxNcS7JHH8Mdv5ELsmUM/6s73mv0s0lnecTQnxUnOH8WcNqrRthsfayS0Kw9rJTQ2fBwI2EdsNKodCwXfrYqY+z8ECap7sf/BrL3nAJc9DPA91Y3+SDqT7fP8hPfHHI14IPc0sPa5jzwM2ZhDkdebT0w/JEGp4af7p/s5Q9dQ/0dq2Ms2jlt/MTn7zDP5//JMxxNn4X5z+P/zR8J4fv9EGoJa+v32vFb9cn0j1wuBs+7JSnt8NHrNvLhrqXjTBWgdk9642lUFklCmQscStOTDxKMsUIRSSC/+wfq1vXoNy6BnjVzQu2rvxfdesaGNukU64mHZx1W9ewP/jymHU+HTy0Ag3O/rnctYab7Vr/6RHuWv/PPPX2xcnsdJdaaMOowPBnfwb//sY6Grv/YkhrLsVBa4aiN9vNBZXdnFh68tS85wp//ml5/QM5AdI93KGM/KnC5gc7gC14xZoKzW+EzQZ+PsiW/cBDjxhoBvlwq4BPdbf8MrkrErOCQdSpEiUY7dSeU6LbBKSF1bR6ZXWuV6zMUDCxrxtM29dNxCramj3cE49z8gr8zf51XFD8ds/zpp+9AjZVvkVjAakpsZ+fGntvJfbLZewxFyvWQTX2o5N5XSuzGrmOPurz3Ne+cVy4s7N6wLNz4oBn/wlvSH/Xi+SzIHvdGx/j/eiqIOnQGx+FIOmn/z2krOtvnJSy6mT4dzoIfvsbjyde/Qm1QvaDF83A2dgc70Vacn0wekXK7x5fIfTL/VoR5TEEli1xjFTXMvQS4bHjXyKEk66j5hIhwndVwgMN41xCSknhQYO11+klecMFmy6IDMcSqA6Lray8zU9j3xWA6eYzeJDa3Tgrz5AtWkMWnAfjLbRvaEOGFbWYpc5+QQCaNRcU5/YX8zSPoZYdUr5Akb1zuEizyBFRh/iP1VvmkWEJ9j/3a+Zll7lLs7igOE9zSNhCGZjXfMUawe5L/9nfEs2LxTTgZxe4sIyfOYza0lqfX829xEVEL5RpW5C2gDQuqgUE1nuJGyjVFklwYWQ3cHfxtqzHBXVQRr0/aLC6M4DCz60WyKz3ye1bohkK14rtuJNIfS/Pof+KThS0wgE2uLJlLd9Bs7S0H7E7+ZNTgr3aMS2JIu7YdHwIM5ojPJ1hGOFDrT6Luex/qlzsp1PlAt9pUJ8SXmiJTjUXJCNxF6W39sSsPJFsJ+ZpCVf2+GGv7HVpDslL0MBdkDyLuLSjV/YWKad5yTbPYZhxXZaZh5+Mth/AIGCbfIpoQHZlHqO8hKQoCBXEGP0ClMRZUJjlu+RZy09XUIg5mjmMOEXMQ6PGubWHm2Iv+fSHv+g9/IBngJGtAfEkT0K7qklqlOb/z951hLeNROfYMSXKy6UsohCkWN6AothJuRd5bdHbN/WY+1F2mr9c0pWeo4856pbee6+39GRv6b333jP/mzfAwIQkWt5ubRHmDYEBMfP/U96Px6lgnliZE2qLAuQFFDETIvKBYZ+qb7pRm700ci/Uj1qHNjLEONDJRu4NX6KuidwTUCqfhv/jqxGaVJ6ionHg6adgFFONn0CNYX7tJWtOyAc0433eZYC6j+NgvgLnQlxFTM6IKni4uE8NKpjNKdge4Dn108LDirNaJB9MqWmTs//5Bzlnz9CaApQLmJlSaZIHN+rr6/SffztHRZoiPdVpfT9tokiamY8GSA/4I/wXF9PaN/0GAG0bsEjj9GPULXDET761T1WcN6IpzZKn2iPk9HETyYGQoQrk6Y6TweMRQpcDtGt3Xnpbf9RFQG6XCshScEMqCtGooQ3OvIC+ZYc2nUnUkGtGAGe+NjfZqgZcHGDsHqY/ChTML8H2rO3B5+NRAQdAjQA18yNBQMAqxwx2DRiQjCUJ+G3Rqro8P4eAQHVV3/CqAVPfdPGqAJT89rq6ZmJI+XeDrusjfjfoBi9j1E2NSuT89bq6hXccuBdTt3WZFYkYva1u6vNu03WMgHe4pIpEFV5Dn0yIKiyjOwr0Ye2LlKLbVCZ6ND/Qrxyqpv5qPV1Ii26qbbqlGkl/FZMGU4OAJICYm7yLPNBNcoSdhfmO3fzJvF1aopaqcsDjtqrpEr9CaQqqCoXKoxpKN9tXcXfQp0qSxmBdQSoekMfHKdACAhhdEMC1GRRo8iBXIBzPeOusXyvGI40mGizinlEfj/FnYs5djXcNZIVkE+JrZ8TZ/yDZ7p24iD5f/fvFeMZ3MrcfmczVeJIpckR8Up8mRxU5ZWbx1X9fjPumyDEyByZzNZ5mihwQTsKVTpEVoK9CHg4e2gV49eGC8efwtSBkFtHMVQr5GFKNjzX7UntZohwoQJRDE4cmbZPa18BozHcwKvZwZo8oGy94J40XZMhtIF6QsXaXsbbxKNb00eMBaRNQjH2dt89ILBgYIvx8XcOwo2FY1zDsZWHYOx0Mt4lUjZSGY1s1qKOaVFctwBEPrypUUh41VKCBGlELd8tAMXIgGiTpgQPdKRXMmBbPBLYjtNpYsDuhgI+7yHwlC+Q+FZF7j6Y0QOJ+Cmt/P67ac4CrIk1oFwlA3wK3COACqCNGvmBwEfKMIvyZWsCPHChVacpIF9xbKFXT73CP7utcufr3hVpjeoWJlAf4Ko0Nh6Y0yS9SOJQF/IxHgXzAV5cBfIBDQBEOkYV/CPiHAv8U7jiWqMHHBjX52KQWH1u0DZBvWzoQ+QCuwkFRG4c2dXDoUJ3u7mu49kCOHq3junXasCGC1xAiuIfD2+iCAXSl6KZOFTFAqzbSYAOhrNtEtKeZUAcpOLWuETzXnNjQnLh7ek7Q05zYUKHmQ01zoUQd1aB11aS7wosqhaqQww0fg/UR3PAcbvhUMN02ecKLyOGFbVBfcDAgA2nJNyxL8A1wM6a/7dM/58+/5If+6r49otdFd1vE3MbO1uxRE40hEhdN0YzEMdncac6oMGBAEkpNaDawdOFc+/1olwaGLjMXiPI4I4G1YQqfOM2MF1lYVzD1WYC1QPdYdEuIXxXorgq6pVM/Jco3iPCzFG1SwGUdVp06sDq0Dmud7sK6q8FOAPscl89pz4YXXsNKoaMhxvBWysF2k7HdeWTWUG2N6G2N6J6ZbAgwqaFhW1QDHNGx8hxiG+HVqqrhF1LPzCPw8KrgzCUCzCXc+YPbaQsYZwLGkYsz6YLdFhwk3ak0nfS/mTabkoz5xWXbDK0USSv5XPv+kkPxNhEG3yYpbjlYLerB6lEDpTeojQva1DEX3KJrdOfzYv3HBiNicXaL7lD5kSrz9PemKtB1BCNepxu4yM5B2e9dVObH4zBNPmKV+j1Qe5E4tIknNnGwwuO/6mEWR1dp5/EjDQHT7A2eKVyD4EzGS918w/RHugFv0jafGJovY4R6dJc1KgBNZWIfQkmWXJG+DO0emrVORfdytvWprNeK0vwFqum5jzb21EAbJc0VNqbwVyEFYPBxZEazqozaPh95yMU4h4fWrAY40DPM7JCNq/D4+AxjGoZzDNVITMxnB/hsTGbs18OaLQXWr8HSFxjrZ2DZkfHI0ZynwzFOQgMkN4b1+/xL6St6DOCHvqB7Y27vyHhVzFoFH3r4MBZHA5YpjFfO7HPm1FkcTpkCVEQay0D9nxoYkqWrIYmN9GmA620nFWjIq4I+nAcLeMGGWeU23AbGNVBN2vOcCo2HZFUTxzgNeIkdsYPA46ENoVCWqqoCYCSjm74liiEPfZMna36JsdyiqvFQoFjcYsUs/qLE/+DpWqGCFC+PJj6FE4tPfTur4tsxQAwIqUv88npARXQS5t75J322nLRHgZFTPFNJWU8QhVgXaw+BqrIz6iUVmXqVvtwS62Hc4M4GQfu4XG/x+xKzrJHPslKGZTWwy7bMMiwruSyrvXAss0j6SLGsISwjjBeNh9Rke06GB6E0r0ayqmWIVxXi+UsST3aOFmZUgcNqQryQieejWId4/vLEyy/+9MTzkpO8BeLZAiKngEgK8OxnznWRXBelhI0r3CJUWWRuzTI35B8JWYPznCmKR2oIb5msn5G4Jgvmsx4CAzx4tbZLLxSPz3gM6jI2hL0nDJtnw2ZlmWHzoooy5OvxSRVmGNe2ar5ETSN+ngML9UasDfSqyWS2qe/Icxkzvy6JzFEiH71AgSfyVHiIGTe3UFm6woBqFGqnNV4/hV2FH5dq4sG2uZHUTgAx4DE46+1TpA3265sKP79nJK8AbVwlz2TjMfCs2mctzm6Pn1/aVLSQBgzzgM15kY3L80iDQ+5bEWrghvMv+EIWLfDNHidQIoMk1JAUcMVUcVFd1YVcoZfVZVPFF4zjGSqkVs50FVvRbednDtWD9EWKoXHN8/1Z6Ir4GtQHXcBfuTcETWhZOGyxnIk/ZN4iogc0PEyD/jwO+qOC2aVQbZrXkigAr2nT2dRg6GoFFsKCnRV5veCvd5fXgw8uLurBX/v9J+rB/+xowH/spN9N9WCUwrrDAcQGowdL8mKaTE74xEjC774vkvBfLysJ/37RSMLodZuonPdMEj44k4StJHzwcZOE382ThA/OJOEXXBI+SCVh6YRjk9TkPUYSfve0kvBff1wkYXHlHikJV3I1hSJGDJGEK6eUhJ88gyT85Lkk4cM8SfjwuSTh78mThL/ng5SERQsWZfijKQmfScJPTikJP3kuSfgwTxI+fC5J+HvyJOHvOZOEX3BJ+MlHQxJ+clpJ+DBPEj48k4TPJOEXTBJeeY8lYSy5gnRzgg9IEoZ7Ot/JDWd1vpPbuq5TJ/f3pKWg2jJO7oNnd3L/fnpjNEeOJHzwlda3iEXL157bNysWmB4AJ+5udY4jwCvIIm1+iphfyw7wJ3Je3zlPf9CX85byicOd4frBsegCNYwfHAxRUUY1XnFU44PU/Q3rGPe3/PCg9VkC5ZqZ4p6+gHuAmnne7/NLeL+ldOt0QOmVE0u37t2k5pNtvgJzqzSLUj2YH98M4OjQPlg9OLI0sxRbXkc6o9jHhGINoVgqGcMGfK1kfJBKxrAWJOOlWOeDFz54kasYn89TjJdnXW7p+ayLKzm8A4yFeRGlJ0Tk5ltGuoKvS833S/A9I+oZUVNNWOj5Ag+KlWUGxdOrvSuLau/5p9TelaPU3vNZtRd2jtp7flHtPZ+ovedRNtflotrL2Wdq7/um9v6nif4t6v9f0j/XVdIqr/6ZxS9d18cV/X9W7V1bVHt/5GS191u+P1V4v8lJfyPSRu1FKVZSsGqvJC+mSTnh2dTenC+1gY4cv1yExO/bxK/ZxM/YxPfYxKFNPLGJgwuJVlxJtOKKaMVa9vXJF614BThJ5N+QKlmtGMyCuEj+Q3NylJ5cM+T1ycMHddGKNxOtmCsQ8qCfbGtaA3lYMPYgPVWhB0eiFYdMrOSzOj4LFrXiQ5Rqi5x/ByzWYFmBTbc1ZTVYNYyYrJq6/OQk80smDVCkbgrQ9+NB22zZoqrMhtAqtiXls7Aq/UjpEToGFm+rT+9yakvDfj987YU4Ioi+5p4+1Sl4hB5X5/Iupz7fyrO7nGIEUAWra/n4pSEfsxLpqtxnSHY5pabw6ED/zFfL0cr1uNOWd5LIQBO8U/o50QHG+s5VNFyHNvkVo7gOUaxC1YfI7epTtqE/uRq5DMkMsUuE40mKeN8o4n1WxAdpbQ8TcbxKfVcc91xxvCG7nEIkhj6uD6KPo4K5BdA7B3xOiNYx+nhIMfl8mq/TvtbHIxpS2e5y2tmnHkqGCwOiuIc/QbLLaShvtdd4l9MRHyEbowKMUOk5ynhIntnmFAorNqxJlXHQTMTXUeYj4kbGeOzJeBzq01NXk93ZKMoo44NUGa9i/0go401okFsZZRzDaM+ImUJBeIqxzekEX10ew5f5CZNWk40LM8q4WFMKpLI8o3vHNZqYB4pH1LYi99jZhRQnqET9JrLJnXRfUgDyAorEew3U43G2kL5DMNXfM1cTH+ki9J+/YhEc6RnvjgoTpdOO+WiM9DjZODUu2nrP18RRLekZqFjAh5+7u08+QBIX4FGmHWfDVOSMaJzdMNWz8x10IyW7yti2A3QP7jSTF0Maj2VNlJHGL1PLGRObXFeCOJHGfRARfUsIabzJc7wfhxYOBCHDtxmyAku7FALaUnF8hQeqK+mYdTXNvZbmXk9zb6S5NyUJtG7Tqta/z5m9KPXXu2OFdAafKphxSO1aIf0X1uO7OOofZH/FCOlKhPRfW1f3IKQf8oV9VKr+v6vL7Culz+vTXfQd97kkT4T0XQxYmxDSN/X4xsLMFt1TJZltX1EeXeVq86mExg+Tzf7QYs7ef3YujINvX8+0O2J2cast6mKXvy3GLNKks9b3kRpg2vYYqQZmjJwaYq7GqVh/lY7+Coo66eoextAYERuxMapskDHq1NfGwBhlNtrG6KF6pGsu21lq7HNfVTQCVMjGiOrE5IVJ8Zh8Ps7sLmw1GlHRGJDzUAiNqYi9vHas0DLRQKfRIjGZivEe/szNuSvxA2eHN5/mxNfu0ANnh7dI7mIun1kBZofvYm49MZkr8TxT3IT4pBnNneICQ2p8aVDeypRjU9weMkcmcyWeOcUVwGJto0txigOylGaPEA8DMHVA1g51DVlLmLeXaAuZW7SZVdzvp4o7Y/NVKO6vApuv6YMe81/Xxb6hIdoQiF5THl0XiDaeE6JvGOC9kUA01lmvMUS3dOp1Tm3q1KucWk9gW0lg+2YC27f01xswbAdUseCE8aYFJ4y3LDhhxAJOyGe0ZYwOG5vGKLGxbow2DEsCcgBdWgA0uYDuwLDDchtGwMbM4D4SqO8I1CdAwB4FbMypxscHyHzbQiESEsTv0IzGSHyapUTZgHWHJkwJfI4EnzRzCWKhW6QHND9y19YR/hxPllmGLHVz/z16O0MWPvMd+jQmYD5Z9miySJaqIcuOPIUly8zwYGQeQMgycskiLMErBCeQZQBeDCxZGiBLg95ApsadVeB3ocCv4wAFfh3EwEp4UxOjLcS4oQu8KcRoPzsxLrnE2DT9NcYIQwyNSA1q02NvSi8+BOw4FYMEhjaQO5kEJYvuCIZFd5WNQdpdl6hhGQFD0N1jg4QRDtQ7C1Avu1DvuVBnKAS2A6eaoDx0UG6bK8BkiAzYsp27hewDfJ67cSvaHdCY0V7Oxq1v6w8ZiXw/A5s52dziIuqFOgIbYcCOZcAkA9kH3L8LcjPDRSEhnjAgB7KHp4asaLsC2TZw1Labcq9bHX0XK4qGeVWD6B76RguvAe/cOsaR+yECdHpEGtYGbh0iajCgSkn/2jaLIFJUtqN6wEbH4qyvjZLFGYye4MwBUHUBQHUXQBEDaLFHXBz803HUdmTce0jzZWtWZxeXq1lZvEjNDrCyHRAhk6hhMu/RLt3/vFj/cXduvUf3UUldLkqpAt3FgukuvYKL7KQyq4x71jNSkMRhgcdgRVhk0x26LKo3ar7Ho/UuVO++kQFKRvWWmZo0AW4knn5sB4vahuOA2BtShggj7SCuQqz7pR0KVLeNMtJG1TQKqbHx/wdszODlzzaO6dJ5SIvnFPLxATIxAsA5BFEfrQIe2fFqYj77NXwGUvBYNice5ubms5/BZ3uEQQ+VlJZiXxTQFxjrAJallszTFoltuoCRKfz30xvLCwjsL/D2WbE6LCAZB+zwH0uNhexNELcn8OuEeLHfnzt0zhxx5ixdBgKASBeRxoJP/4eKzcQbBTTGdUYD8gSXNeOdbVPJ8iwUvQbrYn0q/D/8pYwAFshoVDMSGOFJxLMuAVUZv31NG6omQ5Es5MURvE0RkJ0GBBbMgq5m+MKlewt+e/ETnFS6rVNbnanfPjS3SrOIQuO3983jP+W3r1q/fcR6xktwkzhzYEuWh3GPxewelaifitmKevnMKWeYU8X3BXuWYU7ZZU71jDkfPnN6whxtEPUeUklEMAPuqpBJ41PVM2SKhEzBcmQKAPfAwj0CACNLJhHBApTqkClYnkz5peeSKfYW6SQIlXE0PaFGTn5KtNgDc0PyFhlXd5WyOq1J4Km80i18o/6iRt0jgkbtw3lEpTP+vSD8A+Vc6fkFHsK8ZYawi6qWIRTxSR6zxkjPJVkCpNJzB/2cnSxiBQibyMxNeyIR9CgQ6blOPSs9o+7L0juFVKeqIz1H7Cmui/PX5tZSWIn07O9TbUF6hjjG0KOIfCs920l30Z10y6s2VkfoOFvmi3J8C6tyu4TwBOe4oUjP2T3zLUpc7fm2dW3f0aXc1trzLUd7Do/Qnlup9tzE111ee/bztecWNR3t2c9qz1PRnkNQmKaO9tzM+Nmht8Xe09rzt+++bCONX/7KC1p3/lStO59j3XmJOOO/Pll5/m1Hbf4lJ/0TqfLMpaRhxCfFGT/+QOOMV06KM15J44yRzo8zXsmLM0YVSJwxtNX3KM74XZTKRR4bZyzSMeuYTaNjtiBgOr1DW74xGclMKQlOjiU4uZMGJ29BERIdI8TTbktAMrqNHgckI7dv5LKLHKqhJGl10ucPU25Sy6xuaxKS3KJafkgyq66ni0ruHhOV3EiikstLRyWPJCp5fHJU8vjoqOTR80Ql12DVqJ0TlTyBbNXLaq8TODxE/2IMaz70WWimbfhwJjpCeYqnkCeCwBWwE6eC6OPyY0QjfCFXL2g3pS2qQH2tyGSCOiTJsQnMta/FbVHBvhJHhAs9EWFje8EO6iC94EJ6AdMfo8pT0cnDHJRlQ5BHSI+S6OQxzLH5aAfpnaWjkweL0ck1kjoYIeDy2Ied4Xb5T2fU2QoFVp0NaA1DmfFNcdxyGTOSssnqQpzt5sUtX87ELU9OjFueZOKWYT9b3PKVtNe/muZeS3Ovp7k30tybToxz/Shp9ieWlWbbT0mz3IOqhsQ4Iz6kodr6vIYrzVZcaXYD0iyGD0UcR3pPdRJptkJXudI8o+gEiT8fzZW69xfCZzO61zZutU7bULjWecaEdItDo5DqssaFVJ81LqSa6MaR4plczJO7mPpmUeuz0TRGFUa63IXRMkaNGtroGqMMw0oCa6ieBWnWk7XVWqpXjahm9KpApFkvK81GrndW1hxZabYYT4+VZgf4M7Qu/z3HhevRkKZGmt17Wh7ynpJmixlpdmod8MNMcVMrzQ6d4vw8abZopdmBI82uLiPNVtzlkLxmGYOqMW0bqnYwr+2k8Z7HSrNzSLNzYFMrdlCgXtXFvqYh2k+k2QpdF4j2nxOirxngvZZAtKezHjBE13XqVU5t6NScU5TAViWwfT2B7Rv88yWAbZeUBSeM1y04YbxhwQmjJ+CkhjZEgI3Z2LA6LQwyxhYMS4KWA+jOAqBbLqBjBrToVVuUqBIzg/uqQH1HoD4FAgbiPhhSxEdW7N+0UKhaafYt6zB4OyPNerRD03xpVgjiSrN7NDxWmj2BLDOXLIa9HgTxDFn4zLeMXjvIJ8uApotkCfOk2WKeNLu6jM6VR5YueNG1ZOmDLH16DZkadxlplqw0SyCG0kVsaGJsWWkW0YpCjK1nJ8Yllxgbpr/GGGGIoRFJiknQ1yniVBOw41QPJDC0EbGmTR2L7ioMi+6QjW7aXXeobxkBo2kZAaMljHCgHi9AvexCfc2FOkPBtx04RYLywEF5onKm0uww27lbyO4tIc0OcqTZN11pdmBgM6Q3j5Vmp0dJswiIdiG7x/07kOsOF3nSbB5kD08NWZEdBLJbwNEWbSBzgygjzfaNNNuie+gbLby6Is12RZptATpr1GJpFulYZ/UZUJ2kf90SabZNZTuq+2zEFmeNVKcN2VgTnDkAChcAVHMBVGUA5fSIi4O/f5Q0O82XZpeqWZFmpWa7mI12qYVMXSEnSLOopG0uqr2ENLts0DKLtS2EKDtiLdpiLRVrJWarY5azMneTRnnK5R1KPFYq1kZZ0bziurxrtplG2gjRTI5Y6y+4vKW5TCfPg1w8FNf3HjIxJtiQLLST6/LGVWlI1siMbkPaQwLjk4RkYWQRl3daig3J0hcY62D12V3eyY3TkKwiAjTYqXso0Vmuy1uCs5y3wFOXt0Rkec/n8vbF5R0BqRVBakQVE/HUofiDjTyufywjj0vwqzizYkuWh/Eai7Vr1KFGKta2aS2fOeUMc0IRi6JlmFN2mROeMefDZ86aMEcbLVp7SJ0PPKC4/skNKL5oX/Vfw1daE75RY1GsXaNWElDcKp3x7wXhHyjnirUv8BBWWf7HM1JCtdI44ZYRazuyKEjlmBj9nJ0sYk0Im1pmtrommsKaEye89tGNE45hyKrHirXZOGHg/GixVlCyhFh7UqDwO6lYO3lPAoXfoclpAoUnGb97fqDw/7P3HvBxHNf9+G25vb07lIUIgBBB2W83jAKwgJBEkSAtETgKkthJUaYlO00y5UQfkIp7BwnIlZbohO42rX90PCZWT3Wh7EikHBc6sWwm7k6ju/x3k1JpRXR+7/vezN0eAHaqH6XDzL7pb968+c6b2Z0YPHdKB773yAAr2ehG3FXNwbg2Wu9NL65xHL2t3ZXb2mOfm4L7v/3oHXIftFeaNRLzIzu4Yx25SwwnuknCHQQ4GlAsLrF3v+uNzcgSN1fjQnzO0y391kjimoQuOZJG750Pi+9zMke55z/Uq/yjRW6Ey9HhOHA4Pq7pJ33q0lhKB9NCc0O1XMfcpD6S6IjXhRSuZuMim1CdJnVIw7qKv3XUy8W7cH88x/bT94U3MTHUi6VvuckQq5eC33xz/aXgll16STb+uHpTthvtQFQN0FDhaO327GIpxWlfOI21PWc+OoL4etF99GF0eJFcvDJbYziq5Bf/13XcVNNypmlSPgQA11RHO1P3eDcbj5+EyD20uTvzMtmY64ad+SxHCbHRgfpEf4UvV9eHSyiqcQoFYYusdSSV6F1GBGE9o0z0bn3EznRIWV0JczUohDAGGHX8p2czZUYwLlBTjRyonHIn9q9AeYjmgxaClT4cPwnQ24Fe4O0gXVQa486OYLSJfooKUhCHDGAkehyyS1lhOMSUW16kXK3nb3YczzKf0nIlzfYgMnoTO0gL3S6Vo3Z2XJGxSOrvEfan2XGs4KtAezBaOKgLhC36I/BFBkLs2O7nELKV+Ysn497190x173qw7NjXr/ubk2Bz7HHVAhFwzixIXb/uH+v69YBcc8W63GEPAUI8cXw4Eha995jXr79Pr1/f5cjwc4dUgHIqg6EdhTkuGcqda4hsfPiy8AX8J/og8hDBltTs5KIP6Xg32YnywmNOHlG/3KXNHuVAAP+Z0lqUBy47NMMavGPPlayxSocyqt+TXOlvfslX7CO7HCL4IoVHr9yHURG571+KzejV/kOcJ+HwDRT/Luk5hyRTq4AQWWRUWqFJIT5S2bD4EslgSvWeUT7KaPUhszpncEHvl4Iw4kD0ycGUiq7Dg4uHxOHMqwUW+6UUqVH0gZRCSRzRq/A31XQoJ2jNlA7fyOyJ/u9G6ddE5kuV7fSEiZKVoXWKNzxZxSsz3RvQQSyPqByY77xYR1EosyhoEXmGRuSvUN+smEeszOfZUsw0PGAmZhMvbxGw6/1BEjDgIe5IJmzuTrhbV0i53JuXxQGjguL1tvKezPaKP334fV2iZasDhNkNAtPh91TxuTLORPGFUDsSTUZVfXcXL0cbI2UZcAMi+ohvS0IG8Bltx5VSzoFkJLxIfvF7bblpfNLM5Z83Fr4xNGoqCeIcN3PclxNmYXXq8hZ7kWEzO45gL4zMfBUrRV/FnBR7lAFCGymNvhyanTRtFzPVTXPY9dCzymEXHPbBYZd85bBrOKxFzuKy2GIekLsFX7/4phRUYOKCEenKiEWNKRybMb4hHYGcxGg+HkUp8EqXD6rBzeh5BQDyVv5FZkZFnAFOT1G024zWIsZvBCCuerJtoYtY/+mNYDa6KDkLZ1gCU9o0oz45S5d/QHw+BVFF8vL0OyPuCPjBLmYSl9skWt9XOQ5LD3HGbXTWFtPIdib9M5POKmVtuzuYdBAk89zJz59JPU/HqMdisIqmdcJq45pilbg3PjsVggPg/OvG7gGq14324PtWKqJ4Z7HkA26HyUxUm0mwzDuvSM5RGI6GYUcLA64SfUOqMJOm26aSV+bAsyt7Ek9vr2mrXgQwA+1HOfKxJZ/OEbTvYn/XZG14s3cPSj5HtiRKPAgxpazo3hxnLRPbyPDP4eJih2ZQFw6jmPfpzkIYOabR5YsqMldLzdFRkAd3xHRWK1c6tSQhryKNRjE+ucjPrW4mnoWWyL0lz5H2woADp1s4Kcd4Z8hp9xnKU67vc4mdc0rb4sCWSt06FNhYUkBJcjzpHPhxuoiIjjS9+cAXbuj/3e8PWpcDrLofuMS6OPIUV8l/a12QCeQhXgP9cp919fATScg1M6796MH7rFsLeeXLvL6bzt7zKetqSJJQIjWzZR3aZ12tl9EG1pXMiDiMzD/k/dWB7ff/+NHb77OuJP3MX370vj/+ebzUupxU6PdsuGV83bZ3329dS9/Z8fdnl51Hl1rX0l97xQOdWx54wT7rWvrqjfj3p4PWVTraxMZ+SiZVcvRrX37Rkm/94GLrSiY/uWXOTT/8wYvut67NfOuv/vKq753z+aXWtfSvXfsAV272Puta+kcOR21tbTcOWtfSV0jlPrvPuqBbxnP/OmbgWjeZdWTt5Lmfe+frTvLrRzYk504R+Bt0Ls7KxTTryJe4RNfQ3VSWhAyObDAXcWBMjhgBTdjOgYz5jBIlJpvJ8UsRhqUPx6cAHz0OSi2yIdAtirebZmAszdCxWVS1YAZTDxVE58rUrPfI9orCiGfr+JpTUlvbPG8IdyOU8hyjj2bTPDnnOb/kYOjBdqmaHqeMXT6ba0csbhnhg6g8BHnbXJJYBcgag+8iENJzNK1YQXFw3JVPwbl6SJYMIcuExDdjljA9ydemUwcPwYjEtbaDc2AUYabI5HAONccMB0APhCdBnb4qUh91ofGJW52wgMfJla8MtphHGGnpucgXebJ6QX5zOR82Gs6DYW0eta0wLJ5eXQeHmFQPeORyxlEZMzzCO+vDvzoxvKM+/NDE8Pb68J/WhTNt2kJXu8Qu65ukn8FvcqCQ8eDgt6oblqGK0cPtQxWZa/eWlTD0kqGyqOVWyFcrRWCbiAspZqguuIsd/KcG0zPRt6Uuz5mKCmAv6BVYd/KajRwskJkyEt2qi+HaknPEcae2ZKCt1mpRM2UwaqkaLn4Joi52ehThCuibS16NdWm7BkdI1fTPPc8ZC0adMVklxR45c2T0OfgZJsb+8C2vzmy/6PuLtsXZ4V0fwr87BoGRvSGNH0R/qAuaShIOP/hF/AuHNuEYZRDdhZA4Tx6FOrdHH34nKCFWTOUq9qNgV3QrAnYPv+k1K67/9K9fdHFlj0Yln/Lcf7vLFOyxa9dN3Sz6ganMI4OVJDA5HR7cZFBf9jGPESQk2AVzZiUFcqnAp/xdQct7Uya68AQbWEly9c0LKaiQb1tZIY9y6Ubutu27ZIgrT0H5pOpfO6TNLXFGdBm12QXeJgcbL1gJyu8PEoa8SWazpaxI3O69xmx5Nsu+s3dP7Auoc8njoS6Limg3qqjLOl6S6QN7yd/FkdwV3ae2MPzIyS4Mn1ddGIaJY9asm0uve/lmjvU4rBGXTDLOYRlyPDOoWOV2nEnDEAplvxPdWbUAlfrTlqG7jmMZ+h+XayP5oVDlEzPOffWq5owl+0mWYJdh6hqh8qOuLgMcJvJ4zhDQ6tjP+fnYPfFVGTjkYYnsyQTDdaiZorMG6zr1XwFMpzZ2Z5VkmERSyX01yk8qVXOZlNxHcvZEHzVmA086WLlYa/xmWL9ezQ32iH/GuAXr+GNq3Ioq7zB2Wz/2q5WZsvlT1yD60ttFmt7uuHx74zZy5U0Pj9xeL0KiKQdKygLuL/IidjwAnAkmbw8mb/X1LHJ7NHQWlq0pi7fXpU6PEmcVv+w44QnaBvtvsLbBr9/5tdkYGnertcyYCHUdxBrZ2go1jQcpgR0uFHPh1zgtc//Or93ZIcbCXHRPnaVQZRnsZ1E2hr7oz6wc+zEe/zxlw3PrbHiTh/MpKaC/mKSA+rfUFBAeJiigzTyOZDjqGLLDmRx2oBI2l9bfIMm86C+Rtx3kGZh2QzbbgaB2OU8apDZMR00d4vjq1FvB/upErGBmlwi9Vq/Q+o+/S6S9gb6I+ZGdCbtEf41wZHUSu0TroR6RcPIu0TJTEcy1ulkCek89xkNwVyp4Zjq4eB6ySHPEdJJj4zBFN4SMRfW46nzq+oo6X3i0wtL7OZNLLCGZnWUcdMpeO5RUipzokyCo3dUIuZQOMwjnNEnM9/tF1uTbnDGHf3A9/mW32Vc2SzsdNtybycZDfk0lv2Q1Pt5Uc5Fzku31MklA7IRJ7oruOCQfJmp5zt8G201h2csptzUushNsjZuEZxDdZkLauAVOFLfC6YojHKAWLgaLvO0Ou8VF3jjcpkXe69jJLfJeps71SrxG41ytSdbr03ING9KYAxrWr8QejUJK7NIoPEsug9RGbMbS17t6gdRHk7O2JtM4hH8b+VVNaiEmtC+LiH9XdiftL2zOSLqDmRHSNNFo0rE16WRqJ9JQnuQx4kdOwfGpmTqYyrvao9tGwaERMzMV2MMFOaNcTvuVEBpzflcN+mpyRQM9mdifLxIDe9B0ptyBjsK870ltMPFDaSo1rFF9AlCYrk31sFd5H+RGeg1/OBX70LWl8Y/iNVDTXdH9ZlzvdIziTOMep15N+Bb3nJup5ZJB5iY35C/bml+4+YSi/Z1Ee983nbbn8mXGhTEXBuA3ZkV6fb7UOP/GgJ/dre627FjdK8f7509+5XjHR99iXzmW4TWOZ32PWINk7G2Ht6hDdUA/FTw+eyQO2d3Pbh7PvbU3jB3x6pZe3FQLbK4Ftmhgay0wqgW2aeBZtcBptcB2DeyoBXbWAqdrYFct8Oxa4AwN7K4FzqwFnqOBz0GT5qhp+bnwz1M/wd+r/tjEgXEhMXHg/zUGJO0xIwZ8OPfXeYkXnyv9jxfG9PUgvA4HDjNL3wJHZxvp5d8YgTs36aUetiryXDebtQbxH+FLfiTap5NVNYtkDrySTTIXWhfyIh1EzhYRlh78jefZ/OM+80rTbNnLgGaaX3rVSIvnOhmnCGpX3AtnrhzGno/lPMX9lMWwOg8B4258Pty3uPEFU57NXoDDW72UI3jK1rPTesZ7KWMVoqi45MJlY28dTRbiISO6L1kklAFaSANXdnPIhbQIP/ZfSPx0ZXe8mC6AjWkJ9XGiZa2j8fPofLuWnLm/zF1wEfXXjoyct2cPky6m+bX1GAhLrYWYDVBYZO+uy2FwmQDceGBZJl5odxYM++agmhfelgxhIFy4DCC39c3xItAz9yb9w+f/4rEPvf5N3x6scD4lUMP4Qurnh2XUT/2gXmI+kpmjS7htvfeM3nukvZ6bxuyaLKAFVVPUeL72SndeTqX1UR/3za2wo6RfklHxpF7o7j6m0iBdjBcqOAfNLBme4p69Szlgsk06uQzxL9cXoWVmA2fw7/t/Mza6yAuVmqmnZnRUUN8IDdPlk03ayXIU9ghXhIbhm2RyTlZY89sCKnFEWsaMaLKcta5hTVP50z/51arlH11sXRD/g2tNl3OMmBt78JMPtP/y7g8PWjdeUArNVwMOwoYkNkEaBrNRrXiB5ecH1er3XBI+XkRL6XKN1KSy9K1B61ojL/oMrCRh3LC0YWoWTc1OAtMWcF0MiyACyK7KkF6YYntpSEyxC01fD2Hq5LUiF6PjZGN3zGG93v45/DxA/OORMyCjO1kpbx5fgIdZMsdkklVCWs0CtqYqYGvkjtfzTVeugTStVePpMK2K+4wMr1Y5my9mU+breBaMNbykPspKAFdemDqupyNa9SYKms9NlUb1Qff2cVYteLkaTcTnkSUSp0EtiGzhKJhWxn24gPlxLnwNIMcaGjKjCjVZycWv4zKU7+sUHwHC9bGUqC8Lzm53ORPRlThHW/1oRi/ePBeLOGXxN15luL1OuL2Wc1/tDaEfdMKxlm9aJTdOr5V+ACPG0SZE4cqaK6mzwpEltJrrsQVWdCX1GlVxJCPDab7hysSPH9ijqZxZVi8JQRefT/mY64z2XyDtv8AwpdSCyFyh1aiQlp+qz3wu+HzKamXRN1Z31VcGdYP3mJWZbyszv1aZ1foa/mp0Fre3drh0JedIs0w5yNroUOrDHJ0imAGLIuvPlq5kD/czrUM715nOfx4tvqqZDQn6Bj0kUnqpT7EEOIbRoPM5JgLR+3ThKPVF+3niRt1ZtFhbJ3zdCpx+Oo/6r+smPiXdbRU4pI8dtBFl99kbW6RC59OFgMM8F27Qdy6PPfhVr+DfWDyA6m9sdooYOlp/dJDWXYbQSHI+WBOzeHAlhgAVCPMbR+KRgyBcd8Re3VHh+o1x/QSWn29G0XyMovmcWzBhFBUBpZkhWjAe/LbtQKCoHNP5rGDCb25LU+fxJnXcr11pqpeVXWR3T8L8IuYaG277wa1aj+EL34uZ2wtvS3gMj9DAbUnfmmaXZsvZ0D5dVWDkbebQuA+FZOJ+LkA/t1DLOOmv9YRtorI6Oy8Txee7Q9zKAhcp44PZ88wATe2nDZraG6CpAZoaoKkBmhqg6digqfAkg6awAZomD/4GaCocEzQVTg00uUPPLJgUNWBSAyY1YFIDJjVg0uMNk8JnDUxqwKQGTMJ/3MQ3nMxW3HsNXPrg0eDS5RYcXX5GwVFwTHB08WRwtHQiOBqcGhyZHNafIXC0LA2OLrHg6KIqOLroCQFH62np8cHRZVODo+WIf+npgKNLpwBHK44Hjko1cLQM4OiSUwBHl3LRZxQcXUyDdOkJgCOwkpafJjhaUQ+OSmcCHLEArVXx0WHLJy/aMPOs9FS0V0KkU5ipz8Ao7c21EKjVKYhyevBEZtJJEGWyclVEZ6tCdOZqEJ9I6TrhZzETYsKHJHCIOSjKMWlEs1VKSrf6mN7sZ/7SXM2WDjkypctbhGvMeF7LSm0Cr1chU5ziQFuzBnKs1u919KK6a6iXW+cq9rCt/qFttYtPg0qraUQKRaPBL9togzp8ad18C4HIAOe5kypK9CTUqAYO1gIxrFW0wsGrqhB11VEh6i2AqDo/zTeTUL9xybiRcavANQBwlc5YKV2D/IOpgatBvCurwNVlLJh36bRwq5uZeBk3UMBUuDWs4laOMCVudY+BW7Wux8Otx65MCreGNdwaTMCtAovAxmytOpzKwfhFVfhyQZRuoasKDD+QebAXWKOPUCDjMBGQXnpOzF2GElah5avOKJKdzUP1CsrC2UBX0Ibf6aYNjGRrx9wBHKZAsnRmgKyprAWzdrD1KoidGsD+xA6uevzaWz+60L5zOMZMzlwjeGn06p00esXneybDVx+yQpPQa2jRqzcVeg1PAb36QK/6JYnzpReejsg1c6aQKxCrRa9PC+TaQK4N5NpArg3k2kCuDeTqP2uQa9epIdcGcp3OMTqfWch1XuasZytoDU8JtDZAawO0NkBrA7Q2QGsDtDZAq/+EgdaOUwOtDdDajtfInxTQGhwTtAanClqZ8cFT2NJ65UTQ+vw60AqVOhG1glYPW0E5Bm5FMIDrgAGuiy1wBZi1wHWRAa6Q+48mGy55cNpXl76XE1aR6gZ+uIQlfQOoQKrzVXTjvipinX/P6EePTLOMGwdqG+L/5eIKO2KnRqy9MqzeZcbQRMQ6H9PI+SNpvCpZJcNTXNB2GQeAPLQq/UuWIz7wqsWg51cx6NDfp3969eEPFIMiK7Qk/UtKRu+ZRvSZBuCbA8zfj7xxZOHEZgCs/sCAVTA2/TNcabpmWaU5/QPxRwpWfyhg9ZGHX3Zx+scKeq4Bqw8/CrAKra3zKuqPEa91+KKezEnQZANVEaXpn1q/sDT9U3WqnQUuEnhmoOqvITHgp+EO+hNRqrzYfwLMOKgVMZhqPojzDWDNLXD3z4kXFmnAKkTMQ6XRkQWsZp+3MV5Hi2nhlfFGs9YSUV1UXWOlYckFBpasngyt1pggzNgrq+K3shRUz1biyQXAAi8ZzDjVKXlNCsysPQUwc/6x4ZVOD8xmU3QaR12QKnr1mS96JaaplVPCJ7cGn5JnD3xqwKezpoRPz6crn2LwCVV6/DFRG8eIqpgIQGwdr5mhkIhR2uInCiUNGJS0+IyjJDOUzzcg6AK4XRAyyUmB0nk16JSV45ce1+3EUdJ8iML8FErCA3P5RFHS+YqSenHF/xDNloG5LgWaLrCg6fA+A5qyEwDSUjqvBqP690wETavToClz4qBp41MfNA2eLmhqgKalTzHQtHFq0LSxHjS9QEHTVQY0bawHTdwTF1TF6QKdRLjKF1Qv2Yo3mF7XpytKTtXcxXWuQpJ1VUgCdU5ZVpzJ/G7Ygk4AooxPhCglH1oXc6DMwJgDLqCNBptcXcUmVz9O2MS+AnI18yN5IdCJE688KkJZNQGhREdFKDxxv+LxRyjek4pQVoLG2cu7SyvTEOWFZxiftFp8cjXafTVtfHrjk42CTzaeKj5p4RjNdfjkBRafXPVE4xP/mPjEPyV8Au76mP2fMLRxfJjxcANmNGBGA2Y0YMbpmUDSMGNVFWZk62EGh63RtynNVuBa9p0Q4ECsM405hL7G0teA9uRBjlVpyLHq8YQcTQ3IkeqAIscoPNUgh3umIIdXfFq+Uxo2TuY3Djk1Djk1Djk1Djk1Djk9a3fpgmfNyfzuxiGnU0OvMzjG2U/uyXznTJ3Md4vPkKsIuk77c3Fdjc/FNT4X1/hcXONzcY3PxR37c3FNT/Ln4gqNz8VNHvyNz8U1WXCUmQocNZ00OEL9z5Ur58+lHvRKj1z3tEICAnMR2b35LK6yC8aCbb69/suXm0HH2+T6LxNRLrBz0E85OGESXpHku3FzKsossDP+APMX/dREbtzsAW80JS0ot0kvUA3kPjl2wkUeqdNFAV9tF25NWnHFHPy5rUmEe+YCYidih0NCdQ5HSn040sQPRZrlIUP/pol+0NAPRMu40NL+aISaoOx8iBllGAONJm1cJIe2ytV0rSBmiGnRsogiuZ0u0tvpAqqm6qq/0A6kMJlWd6cdpyEPt9NRG7VWb6jzaRo8cYdcXdoBQivGQytFV5p7uvP64WMepNGy1riNCnGeinEnmMj1aXkB55vnZG1xK3XafLj/0ec++M+PMjQ6OOcxznn9pciYs93OxDy1MZFz7ZTHToq4dDR1g0RyqaVU5GpOp5Z5mS/+L2MKvXoYj3+DxxL0GU0nnytJQfSAXkIJcKgSEecoiKfjSk/ESHyAywDxu+PpLA6dHNpFzXGe1c5hzpu6pAW4x88f0UZw7UNU3sf1tfxHhkaXtKiL8uLmufYPOytin90IjfBVjClnBCM0ghCqIIC+P0qJF6TGypeKTmREhQMPGHevof+Fyel2k1PZ0D9o4u009O0m3rjcgYhb3VnYWk5W2CA2kCYV1nqJS0UT2QOBnUjyar+KZaaVWrfGEctc+9Y4ZFGj9tsSfzPXQe7w9lGZTuYjuvMz2p0vRwdoiSKndNZonOMOi6iVOrpvw+RuRCAUIeFsciLK5Js76NHZefRzVzWEOkcoj7AiRRC3yAq5bW6O25FDOyD09fJTpGZwLm6mgrgFKopbJL04M0eibRJfkGPWqK4HfVyFXr21kLdwNycmjKuOAniJlQQUbDOKyz6Okst1kCk9t40p3gubHcqiov0Jd+aQ+geSPNSV+HuSApSS+CkpQlllOXX+hfyncNXLl2R+Q55DPBfxfC65FPB6MAlHo0/LLFrQJnNpZGkJ9zjqlEdWlOMezlNIeYa7eQqoAPaFkC+eFEMzfzWx28+MYodv6GPtGrdyfZuoSa8SNdEZoy8biwMdw2b85qlZ43DeXELAPKcAYL4VAhFxhgOafY9mfy6yz+CufeY555QFRwI4PUm4kTNk31CSh9OfFISwbEyZVKAQP9QDfJIi0SxmbXFCO7gBLdByWrnQtIN7B/yUNRoqybVD07YyR3jOKOE+Q53sor8FH4vUgja01reBK99CrQJ/ydH19pUcmONMWNqbRH1g399eyfnPjqeXuRpxGnc2Jz45uDrVJxeXpYpzNYEIFczD0N2aZHGpKvzO1iTAzaq+3KXKDocsV2dAif2aQ4/mQErs0iiREkONgvMbOZfLALPIwxj2UlqB0RxY5OAxhPbwqRoc1QdnrsTwyhX/wXXyY5Oup0U5fqlVMIsbBygVmoFyMnGF/JwnT/RvgbJxkcPQt0Uuj3G/0w1NgTMUhZKvg3YMYzaPOT9f8tVUywQvDjllGMMKUGCfyZMKWHNQEWWZeSCPeSAv+SUFYxIIYdLiQpFrsZprgYI4r3lRgQN4XRDxPd0RE+DPsD9jpg7kR8jPnIIIZMXI+ht3guXZ4ScegAhyUZbLYjGqt6Mjgr1jHBHq7nBd4DjbuI941gZWGMON55+89bFA7sR3tlFm4z1b4ccwVsJV94wWd57JK+k9CDZwEnzVVnsMS2Ovei39Z2rX0ntF4uAJ19Lf5zq5E7yUvKt6KfldfLN4BlXQ28hTl5B3mUvIcxjBcgn5nYhLnlxGLreQuxi5n627iLxWeQpMk7LSEFzAm9U62IrI/fjX31Dq2sLN5HoGmIg8jCadflzDP6RrQnrxhUluocmB6+vqzd9ZufmbnQDxxPHFQVj0udTN57n6m89bi9Hnbz71K88PTLryvCt95XnXpCvPh6QU6RIIEzzMBk72MnI2g0nHvpZ88k3tegGx9mP9BcRd9p7yNzlyVTdYFimqYzGCloE23brMfxuewlE8hlsV6tpzZ5nYZZ8DrQLRFCMxxrcr07rcrM0tVAOxXv8NASHuT8qKgJGvt5u/+czVASqmrgohqrA/U1cHfp5ciU85rjfmjVoWYyglnqnSZWYMIEfhPxeD4u0RRxY261WV7nFJiJgpjSEtj3Kj/xJGIxVW1hKnaeo4gC8VzN2OjK6gfCt5EpEyW/ZWykkWLfRgE/Bs5TcqAzOXihh61iLME6+vfPUtRMBDiOHhyxhCWzGsogdFgbAfTPE01283h+6YM8pLx1G5Bf2N1bvPy96Eu8+3e+RBjHfA5Ux7yFGAjPZkq8y5NgmWZN6OOLAbjWC07nfwhPaF5t7jt4ieHHcZ3r4G1xZ7mH8+w9GwSYndhZCvUR4p7RWQSt6yjFx1zsEPZTBRaTzyok9vN0Zx8uZ41yd5qcX4W/pKL2E22WpqDfOLvZ2cAxDM8Le2fvu/Dv77/Us2sf9dbs/c2TfTpde94hVY9YRLMvsc7Dt0JXkOtdbgMvvGHf6J0d7LZF62lMLupFDZbQrFv5c0cws40a4P4d+3BiuUpxRjutGtf2F4MUt1gK/zRXFLEoIPLvhwt6MNpeI95N9TvW1+lvK7KACBn/tJvNG/vAOw1Ee2cwA/gGwZSG6Dr0d8o5+8tYL2X6N5FcFbKs7xro62v0UhrUd13ZQ7bjcdYPbn6vqIGFmYlt87WKloF0X/isrtQcOv1ovHH/5Y9eLxneai8c/I4cAMOvkhCZ1SC3vfRJheUS6ZFDXDvR+3GWoW2/E8VRZJM2dy2Gay0C1rRGulOjzIy0IlEcd0/wR+LQ5FmBvRd8ILXe+gb8nVRkRfulkwGJ+lwuNe2dh0YA9QacA/5gkiSPy9LDhJy7DIzIMPljZBWFuq0hYNVcDMSpnCvRVDmzVU2RQ7uP+e63NVSZpBvva4WxWyrqFKiUmHEFpB/4f4k9l2rwm/aKhSHp53ycyffHfhjEGJWv76jdu5f2qCTjXvdd1V+s4hqnk3dT/mJg4AzfJuYreUWdkdHXqHKgoe/C8gD1zbyE5GLutPs3i5juYhdQbU6dd7/R9y2OUk34frld7usbT9p/oH2PuwevvZ+1P13u2w/5D690Mz/LP6/wL0b6r/AOhfVf/X4D+o/m/A/0X170RJB9S/z1EZh/8g4uxXdRDntXJNErIdKeaK9xAi9dTKmlWtJVWrPrNWxS7xfhPedvHuQFZRrbywVlVfvF9XnZevar0vy0I0LxfHY97Y4SViHuBAHuUZ0PsJMefwkg4U6Md5rJR1elDdPZLq8j0cp6iR9jkaKbzUxvTNnAUG9LByirHiRnUyQAMVOS+TAbTmRDBYhrobzRNIFWOVwuidgCscRZhN+eh7rHnw9L6bGcwoNdqFOKr7EPJ2wJwPC81Qo+9qDObBHyr8KUWaMxWir79lQtiXHMevLgK9zdYCSkHdzBQcdWZ6Nau8JF9VesGUc1MAzQmHM+hKciUwJoeHmZd1a1KfAqTKQDpsqqzmhmSshgFskGQ5OYbX5EefkmYFXHML8Jc7DmMXO/GTEx0U9OkRJh7kEf0DCM0prniGKw45livkFb/t+5j0HcZCtRWMWS8YaCTAoeRA8KpyIiA9o0BDhSOEWHgsORrQZBGI0U+O0Y7/Dt2QCGPbOQXcLnYr8MxkT/QfOoXhOSJ/SQYVdjFqnNLMkeg/EapZ6gRFXLfoH2+uUqP/lvRZ8/Q/8uSZp8PyFDBsh77TCcbq4cSF95B4sdDwV3XbbfyeIat61w6VkVKmnyTLerkGCvBYNo/liyoVIcjsri3XAVSr81e0w24FRCyXAQB1DBs+MNnDVLwpcbuTnI5b14zDfsGjxeFbXp3ZftH3F22TzsjdStndjL1e/d7BkR/N/zu6Tk22qOSeOKudskA6BfAzq4vJbLX+Mu+YJiiFs9vDHWp7OUYf2gUm6nZMPJTprpSLf+XyuliEIXatXHCTITIGq9rMq8oohKi5y3FcRiYOs4qOmFwnMsKm6KvgoTwbOrF7HRKD79yNPugua2xy9iTO8GN3PPKPa168fpCqXp7Yhn9P/v2QJ2Vm8/HrhWqYrGsYJ3E4bX1de1C2I53KlDQ4qGbI6tSW1L0cEN0v/lWdLaEedWOO4HKk8QOxjiEzUuIseVMiJVlcwRzFx8ZfvYW86FcYA1I/zSFCDsgoq3MayrKLdPjaR3T97CMD0SxfkzZ4NWvDg17gsA7Bj9clVo/011lu53gHnSRIoRqH240/vMgpC0OEE1uSnOIc+t2yu+y65kxtoRVCyHXFkzOKTw2G5Aj2qUo+5RRP5/8gKdyDtWS09V5ZZMGwS/ktm4XYxcQiFSvlW4GLq4l5262pQkVq2kMB/4nGb+JirKiL/RW7dGFS/FCVeG1zOgKCo6SpLphQECy6lTLGuQ9sJJMllD6soLyLGFqbVA5LslyKJSuMWbPfDr6wbhbNcmdRIJMoHmaNlD65A/Mo6JhGDZc06F03pidS0M08yv/ZWeG7ge+NOW9EZ9bWf7YvKWsR3Pb9mUVYRmV1CmUQ7cCPIR4ca83wJxytdDsmvNTcCdWj0Osa9pQ5NIvQ6F9u1vpv3+6qBSNhO85bUGgAmkzcOzx+yODxsaLYmLE+1Vx0RQEqoOVhl7JTrAVCHiYPcRAQ6us05ss4G5BRGYez4yqngeu4o+HuDkfjr2eHAGjFGVJnQJ1+dh7gOD3GJU1ytbaQ/5KFX6+HbDFLzWpTSaygzKTCWobNsIquddUx/ODzxn7vj8v/PWjnoSEeWG7J0cYbZWOLCUeUbKZgZ3jJjv7v/uHrL10qkBbTfJWyyZaZMfPxDMpiuX8L2HqLh2nY5pyCjkH0X4a8A8ZlaHwY6a5JAjjXJTlMPAEbMkh9MGmyI+acDO8SkgM1EaI6GR4QjhpwiuxEiFiknJh1PIm12LM52NQ8wlOpA03t2NQO5czJbQw+zQAjMVATEnY4ANLRG9FD2gy86JgZqVJ/UKUeSlF/Aqph7L4blVX8+BZPB4QG7EQA/FX8dp7jTGXB4c4ToDaFdWa/X8SmvlhmxPX4l93mjE7eANDZQrfZrMUg4qx9PliR1Q0jdsIkd4WoHXsGMsnfxkaHuCA7qnGRnWBrLOPYhwWpmZA2boETxa1wuuKIa9+GFRy2PbY77BYxPNhtwiaLRzkMJnGuV+I1GudqTbJen5Zr2JDGHNCwfiX2aBRSYpdG0b1ZD8LUpoeeYAlprd/OT6ZRS91eftIuJwB0dUWaJhpNOrYmnUztRBrKkzxG/Gi2cZuxr40TANj9h1lGz+pRgT1ckDPK5bTLrj+1ocPaKDSC6suSlzyx8j+/ipKnM+UudJRO6WatF2ERq9SwRvUJYHS6NtXjGSK6D8IhvcZ/kIp96NrSftgjbHdF30K0ur2NczO1KJj4bVQkBsiO/unmE4r2zxLtX2uHTLITDpnkT/CQia+HTPbT43zGJFTqw6E5YxKaMyaG/k0T76ChHwj1jEn4JJ4xce0ZE/eMnzHhlTqQh0EbHbBETD5j8plM+owJHqc8Y1I4iTMm3z6NMyYXTThiom3gyvt6xGR0JOE/esQEDcIRE7jHPmJi5OGQcSEHoO8P00dMwvQRE5UYlRQcMTHuXkP/C5PT7SansqF/0MTbaejbTbzx0B4xCU/ziEl4ho6YQN46obnYk/DsenbdEZP8UY+Y5PmISTDVERNIcsJddCTj9jNg6if1E/vJ+CP2R8YvW2wQiU5Iw9kmA+LeH6HO0zmJEpqTKKE5iRIe7yTKHXZzXU+hxN5Rt9Xd1LY6ZG7qbfXg+NvqTPeQkn3gdBEpJUv29CAtijKiz4mQMkJKzi1CbgXkVqjmlucBVJB6eJyBYS5y0UpyYs6BH+wGunvUDfTomBvoxRtPbkPPPfamIlrnooMm7yn6R91TfMuZqwJeiLN1mGpT0X+GbireFmSxes/xr7rw+4t8ylRauiUYIdga362vnxAv88oB/t4SJLnNpfwKVMG81vLLwQoPQM82aagMcSzdHsBqihECo1ARTojDPQZfgj0t6BZzBirAkhBjjLK2XR4/tCaRfXStveoQr47a0IO7U4Szhn9cjH905P9+wX5vN9f8Pai5scFSG3llS7P1rHqkdTu5XXC3e0n2sm6Y2cBN/FawWlXs3o56krfYuz1gV2vczlgpybFgcBW1NH7I8cPuD/GuH+JxSEhMCUHZGyhr4qzRKgXEbyVYZFqllZuS1u44KwLKHuYBZDJnRj9KYVo7RLGdpoGGg2DNTMZkSSEji7PK3FhmQqXaJe8Y2vOYhyS5vXvKj3EDSwzI5CQXty37Gg6h7Ksot2Vv4pUhLDbdQe5YDJhpaDdqzRi7Ddhljvcw5olKmZq4ZLDVCsnt+SSHIZljtsRZVCzk+hbR261wmImalTS+GcsXaSEaIFwb/ukVe5/z1p/8w2CF2rmYDuFKubYfVmaJ9haDo1BVkJaXMfOFD9PAqWlGg8BMFqHNrRNl13u1OUKtYr7QvV37xK7dAh4KFkff5LpYgwELV4+4uFgTyVDvin1yeIHvEjlYAHSx4wGSOqWMmLERlyQY0WeC5sIgQOSaGEg9V+P3SHx3rhAQvwc0V2O4EgP5DWjZQ7bs5Vr2kJY9oHkNa9nLJRjRh0GTspdrXsOa+vkaf72W/XwhIP560FyN4UqM4j86TniCB40OZdInjTpwQOV7etzGHDjSY+es3OzJI02kR49CWFzs0aMOPXlUkJNHuej7dceOon9Ts4dux5mzQtEPhOiiIDz+MHUMyK0/BlQ8XPCzo46cgqhpZIx96G0MRz+1y58hbPGqdbvUuiptsPSY4q5odqoqJa7ZzONA1Qbr6LQlneuf5TyL3IoPv5PrkrbSQ6WVKasBFbbOD3/s/usOPPL7P2MD/Eb597HBak5q90+84elbHujc8sDvDdYs9kO79u8ZnlF2+P+Vg+XK7spuyu4px15Rgw+9dYh8LQT7G79Y/OivlvX9kEv2difIw0a6rju6FZE0qvDHJ78M28Imu/UQ7Il+IgvDXCTrXZvdf3N2PEq55NwuzWVXtAMRdnNyD3zZ1F1XoakK5gguQmBIllmRGYdegIhxn2PliAoBq5g6Mj4SYBbGTn3H1neoYzvUmdShztO0Qwsn25V57UW4lLe9GEzuxUB6MTj9XswJ52Hmw2gvku1El/nFT3GIaCHxcXD0wRR966G/nNdQZqTRu0+l3iWHQunfpNidyOlHYo/0o7MKc66M2JiZ2NC8Dc3bGJsNzfuE925D8046Sv77p3IC/keTTsAfyqSPwONpwhn4G+SECON+YzGB4yeqWrAO3Fwqj92gCb3oIeRvX6WAaccNFyEXrCBdfQuCqXL8Xw8Nher4cFCr/uqJez/6MTI73gn72on6jvSBejTMnqhfLzt5KOEyGUe+WAU98nUdoquQmJ/h4mQRVqISx4keRX7kSIijIcXi8xxXM9QlFHIFf7FJCI4wQ0YS1yR1yZFElJHmFn/T8cd0PxErPy4OizV9nzSR/W3pCIQEvS6CMFUgEBs8CA1sAjyJeSnxSl1SxidcJzy9d0qmXuJ1pVd4U79ckot+Vr/E+//xeMy3SXLpt0ly9m2S3LHfJgmqb5PkJr1NkkM8cXw4Ehb9PLWMDCa9TfILXd6udDx0iiu7MhxFelQgjRF0nCYiD0aI6L63qOShw7lPYXRn5sRcGezMnNqLKQ+f7Isp6WHyCBKf+RdRMPBTwuQqz2pi7zGT2BD+KhlOLvoONcb7UtYi45dehU2f34JsQthL19utcgw/6dTakv4ux3Fscftrr5SSMxUrYWCS4w5d7LiLcY4Drx/iOC985jgvfHqc1+EDgR2xCwob2bs4AwiKvxgnPmAY7Iewo4d3V/TEzX+K9KL0DJcl9iPY3Wxl3+xms+YolTemrCdlfQa7ubHL7sOFEexIGG3j80h7iHUkyKUMe+XIC0agvxeDjsXZj0PCmceOJI8ZW6b07GbdPqQC7F58BjGP/QfKxU0UYicWx5bUiNjETmX3Yg8gQXdO4DRRM8poJmcNOkGyj/MwooWgh3uljL17MHfncGY3lgNYlbhAoUnjCRlqDS645KgW/JHjOaM+s0FfkHDIoIP9b7J2ywxbJnGor2qWrB58h1X3j8DK4Qe/iH//OVhhC+dIif8ffXn0RTk35ZvTFzUg4O1BPWCXzqqCCOD4UAUywVh0YvcKfLFNygGSJAQa5t4FIdydhJUyE8IK08Pov3Tfs4Zd5FDKGDdAGvr/FUJfe/uNzpjDv+IbUyc6grSWJWtG9V7FYKv0UMHsO5mPPeYovzkNqwqsBVJPFGrfSuULFenasmxFvY57FJ2MSjXpEApY3knOO1MB3R7KLBaaDSvKSSzVODjrHDZP+ZJF3MJV0PoiwxE2y8atmncOheWqH2SJyAHn2+Awg8nn71KdRR7/nYYWTpF5i0hom1QyKeond9opijusvuctdiCe1Ndl4k5qVR4gHqfupA4OoSKqgPAOywxlhTGkt1MHx2t684Ev3ND/u98ftC7ynPSBKs4l6Zz8hSmQp4M8hK2RfdbVapGEXDPj2o8evM+6tZBXvszru+nsPZ+yLkKQG8l//JRIGzr0P1R09GtfftGSb/3gYutKRX9yy5ybfviDF91vXc5D6Ft/9ZdXfe+czy+1rqV/7doHzi47s/dZ19I/cjhqa2u7cdC6lr5CgPVn91kXdFNT1Mng8n3WRdikz2yhxR00sTlfHdh+/48fvf0+60rSz/zlR+/745/HS61rq3HPhlvG12179/3WtfSdHX/PzXh0qXUt/bVXAPW/YJ91LX21NONPB61ba04Xcf86Rgqtm5x9ZO1kGeWe+bqTzDiyIemeInAmdeNTYpyba0jW5ehrCWmPbDCC20wtLIZd3OPIbTrNpOmSls4+8iWHJkVv4VHhYpyG2NVIKwG8u11yRAkE1CJfyyzomTwmv5yH0iuMVmiS/X6Ozh5oB1HwlIXiyGALpryY/xwt42bOWGaVk8v1MOfKfyhIHVra5bjOWDCqqgaj0kurOL/mzULVOKoaMYgx57rluk3VmjeUaoYVyu3Glom+0RKy4nc0aYgZk/LlBNOmp8XqmRcfC0rKoD3Ft6VQRT9DTq3y1PgMW1ny1jc7jK0jdhhaEDuMG+eykyvNBZoQH7GvCz45HYG0joIgIM/oMCYUjtVveXR3ENidW7iNvdvG3u3R92470O4Je7ftp7B3m4lbJ2zadtRv2qL5OzsTF+72zqSTtZW7qdu8MvGFwYrFawuOtX3bDma1n9Ht28t4hH6ihsaif9eVwGQSEzdPolb2RB98J7IpmXV/Cbk6WOX8r93NVIOGEz0GQiIGCN1lhEMOcxKL1qlXTSa/9KoJCcyq6cvQht5oaiXjmxHuQ530s+NgweJDqHk/GMXJi0C+fHiCHV8XMvDpQgY+s5DJyEImC/dQRxwgpLqgcaLdYlbKaRt2i4C70QdATGHoqvfa7koFh93I41ehKmKBiH6lH3bxU2ud7z1NYL5F+MEEhI8BzB14bIj/Oc/zMIdNsQI1AFrVUeDJUxOLqwcdBN0QQnGAmiEh8FDJa1ckBfKlDpVKXKwWjWlLe6WSNO2mplqdKrfGoUyjfpX2YpaM6rJwN2eYl7axxHD9qUk++VOMxtn4iDN5iCiqvpamrKvjPMdrriQFfuzXx92y+kV+7CNJkmdfF+Z68UUI3ZVo1LAaFWxokS+hEisnUbw4yJeTGVo1rChy6FhVNon5MhG/uNNMrUrIowpMKED20RLUz7akCDXDORul0oKHFjyIAoHIBdInqlHSC/NDjlPtw0MpK0IWg+5qdniMkdoM1uvSfzk7eC+9A3/v7cBXBfBJhMvFevB5nE5YUDUk9IvvAIhzxXsQ3h4zKh1jXujh0RhJ8Dcz1iLR6xIOO8uI3J24NbP7UOrlDB6P6CwZvcYOceMO+xaHbeEnXB6OwZj7hA5HMQW263CMdDg26XBE18vgzE8anJ4ZnHkZkNrtDnmVhLsXpAKLc4WrBGjpyLCt6Eoc4qMvrdrku2z64yUtpncgYi89xBdiNkhbyYwxTc1ZVWMZJ8mIqQ1mVk734gzC15NbyvNKG+iVT86DtHwLHnMvl5OKOG6VUesvwVJsDkl6GCMO/6k++yOoFSQ24Xey/MtP2WT4jh0naTLcfFw7vppjEy+6accZtOLfvOMEzJNLUhZ131rUw5pF/XoY1N+5Y4JBHS07FcvmmqNuCOz4f+y9B3xcR3In/F7Pm3kPmAEwBIYkSIBE9QPABFCIJMEgkkNKDAqrTbZ1tiTrbHktD0ayqKXW9E9cUfLqtPJ32rOWwTlo5Rw2yj5nW3ufs2V/us8553DZ2RsE6+pf1T3vYWZAarVax6WE6dxdXVVd3V1d3Q9N6FNOHGSn7ThAQEBVudOAA9c4DegKux4GvDVQcy52hOvUnEsjZHQhzmgO43IgVNH8Nc1VUTpgbGLbooMVqVKkok5VnVr5ZBh2qnUBGcMszUHuvOzPLrxKV2PyCttaoGQEnepB9StEcB9XzKoKHTgTTTHb0BH/7Gjgdxg/E43l+rkzZBrW8WHgMWPKMb4T93xQ/sww7DzMkI6ju+yJBF7viwQSCVQvAhj1XlJvBveV0OCGlrK3AaiKZ8/JARPAFhDfokRhnw5EKQPy6i3cwOIAVuDXCB0g3AcEI/CE5g+BR+dEA2UdcoiCz7HxHaHXJOtbDkJtxU3YGq/utTIdsFploIhGldqb6o+9UyhlQ8AhSG2n1ZV/TrT66oxWX/Nvjla/fE1afd0/J1p9Y0arb/o3R6s/6qTV34Wh6YZLCvAEouATsvM92RR4NjUCBpo5h5t1QfUZQZ8m35tLbuaTpc7fDrTOTB4j9sWusYe6Rc5mkR99zEdSt5y19pwZpbPpGphzWNR53VTfia5qgvy0ra5e5WLnWzsWO9HZbLGDQNti52C3h/vqD5xZvvabfa9m0/+xMAwf7vqKFfSK3/HuL5N3quD/6pz/yZz/I0/D/17hJIxTtP9VCG3Wd7J+XfPmr7i/iChN/Rn1grefz7w/knl/QLzvW6t68/tZ1j8X7/u7Zf1Al0hZ6+Fdluf/jm+k2lArQUDQhm0zAhhA3yGirPxy2G0Fopl1IfLLYftRMmJ/Jhf72076/EQIGfldLvR8LoQS35sroayN2O/oGvv1XWOf7hr7eNfYjwRtsRz3x6Hjq/zKqcpPHgAlHtbyFLhVhZyycOspGVP9Bc7BGDd+/DxpMuy9GOa0SxgpwPL3oIBF08qcqpiuh9X3SoLJaFWocwMZrQoZrQqOVhR5LL4QcgsvhL5nkeKxa/zXrxH/9Brxj3ePBz4747nPLYuBgVKII9lHEj6U7WUEokTKneIdOk7XTX3fzfUPC6u+TxlkJQiqNhKXcJKwM5i1JZIECCCODai0L5hlp8hBgnhhtyq0qb/w1d/3oehE/X+8I6sRYqVeOFFnU598HB7Wqken6//wxKroSvfoav0x6ogcRV7TET3bPboirTbrDF5bSq3+SKM+cLoj2sZwhlFdZ+PDNoFDSJ3tSCXbo48mfUmj/gdxR/KE7YWzA4WrHak7rD6i1L3haSs9Waxf35G0KJdDC2fqYb6PoPKTF6AdOnq6g9ZLjtanbFHc2+0Aacq9TNV72T/A7u2O2qcctZcoAMtbpjpY3K6jACxtB51txxC7j7Nbqy/hJFs2huuxwf+RdEMd33aKz8D5eHxTX0jr638TnLQb/TXojbIU89kgR1+KT+W7Uw9QJ95qe70cWN/FYxKhOyR0twvdvSrtXg3Z9WUdNHaYm8ujqL9u3ib2HhQ3qaeZrr8tjyocC1S/5zGH5nO4LM7leaGSrMoGcxQ0uJGGKREbrTqf1nMsCqXr4Zx3NkG0HsNF+5hudL20G2hjHi9RgwupNRBqxD3mDauhpmQ5XQ/Qy6vhrVE5g/fxENilMgAebgd4WAHeRMMtgPkP50xSUqF+MkzLVwG70AXssoCNenG3vtAONkcvpwVA3ivWGIxzNr7twPtQHu9P47C1oIhf396P9ehHmbij0g8KscCXcAPvVmp57c3l8FUSoQ373MgyF0Mf6oV2kGgwD/rXh6iW8xXXAn0DhR70CuxZE4QFdACPGhT4Z8IUwIBOvPx7DfuQgPP7OiiwLt+N79BugALX7kYefhRV+L/nUwU/i74O4Kt54L83B3xvO/C9HvheAR5QaxmF+gdeU6jRTIPKJ+rfn4tjtXWpEPM0Xcw/8++V84HILcCmcziCeFgKRW1Jxa2uE1xcrKJY1xQuLlExresPF9ejIlzXKi6uV8W7rmtcXBnbwgPB74fUbQlf4a3Ji5xE8Dwf6vazyvaw2Czij090+xCXpP33pwNsSovAaFpVw6t1TfJxs/iZZk504ZrFKXQVtzqLtG6vHJsM7DWH9EmrJXmFytxBRUj5pSVzCr6d5tA+cwv7SmIP/GYqoibaa26HT5SB97CvX88tCtR/v55bGPhwbCHvdcau5/3a1Fk1oj2vVTBA59Q3oaa0iTQlR0DiqwAQPum4A89CKHjNJUMK3gP7zATWq7r4LLLNBBWhMPghabCPA7qnx2qd+nQFjEj1MQ5wcq18CVUq4NOuuH5IJ/SGq74Hhuql04DjliXzeoXjhn2CsFCu5spjQAL7HdqzRX7GbDWUDIGCGGYg/gQYpR1EcAseVB6o/i6CHPplhPj5CKj1q3+Dk3mlQKQ9l6Wrfk7OcXz2yCoPNNlr/meuiqv9lceeZNZGHv/U27QoDvoCn5/CtfOW37lqa5U//VKigYqt9X8ayhlTXfYHeoL5fJjy76lUuPNsk4ImPOeaaYhTDuSBZUj1AwKAr4ei6gcVQ9kW51uKeKng7TCXjM7jUNCPMBU9L4T4/ZkwTZjEx4OXL5zkNcyF42RGUnmo9nY5Iey9c0StlnAtCeeJCaABaZDnzbAHYj3FGiM24MSJBnlvlWfhJfiwTepVX9IAU8EXNVTtE9cXYd0QcoQN3bcvVsO7XF+8T48d0f2QEri/HFY/BAyoPw21SFpwhcoolMoBUt7Cqa+uVk59eN6kIeZXfQJVmriTIVkH2p6sSL8r0k+hL9K/uoj7TgVWNNSfneH1UV8rwKeuA98sGPzh91DPD6fVZ1Evzm1Rew4+gS1cC7Y+ymqpPkv935z2tQ41+T13I83rv3sQRKpaDr0FwTKQ3WxQlfq+mR/zqEHDAqz7xxXNyRyWy9XnFL8IVb8381MESVj9PjcQQ7BYbmz978evOra+UZ8kUZ78idDp3nZzHXihPMzq+TPMp/XvR22adWTtSsko2RVkza7Apkb8BiOsQAYjDL/nqMA7N52R3aFu9ftF0Pz2hp6NF8K346lH2em+He8AK7RV/FSaaQGT8tgZ+QXNC8xlQKS+sIK36qKXyl67eHdalFjJ1bAlxDVF7QgLHfMQE7fAxn/gx/pLOv/Lgza6Z7vHVjg+PCWcEJ3W7xTxnz4wByz2wVjBDlIsp8j9MFvXEJ61UpPM/J8MzQgGRREN4oGoQfBVDxcpc0xCvSeYBpyCzRdqwEyAApEWuMAF9JqU43puDy/NUfF+lsV2qBIq2GmNT7fteu5VTTqzgeHdKNdvNoID02EorHktv8tU7GbiUGBHUCH+QzDqN0FoylQD226idU07yjVskuQaIyLdwg2P0ChDyTExe2sNDmGOH6QNp9GHzStDdisQQevtGLqiLynRVhpcuYMR8eXhyneGKx8LV25YeV0nnjgOmBpExwc9wsaAsDHuPFe5CQbQQBa7m5btGAOxSboaMTCbGBaHQNpMg3yw/txd8oHFMzlsKpK50gtaaRkdn05HuMvwzaLXm7jXw9xD7e6mfHc5lO9uZ0e1m5Ww7d/K+Mo7w5VvD19Vr4e11wX0elh7Pdzq9TCD5Hs9qG8qX6vT+EQmiBxC/ZxRd1S6W6VNTWS+GiWjMLg2DZM1ehN5GrrGwO5n0QWOj7R3kfbOU3Im7E5JswYlww5Kjv7zoqR5zShplJJBN0oO5ChJ3TqI33Qr0cpx2tplcWHxqXy7UudeXa2v1WvSWUERqqabVlN6kyfzID6Fn4qC57L8fo72neV6SpvvHMnjAE5Xwgf/3AkfvkaER6c3cky6UbemZHITQjrUsOM6j40wGia43nGakIlwlEL2YS7g+jGBoRk71poEomwSGIM1LvMPnj8ENrfknweb5LyM1ia/pZwOwgdY1kuwBuTGtIUVQW5qZfBBDay60JS0qfqqwcbugOPKvpNj0DMNS1+52hqWnzT8A3ayTKO0CQty/4z6pJgSb6GRht0i08J6fBBYBdsYVQXwDdcCfHg14Bs94OiTo80GwMK+QRgqd3QAggnQtwkk5jHLVEbNw7RROlH7RDphpBMD6IRaSKMjnZ2oCdRj8AknaJ+0E5sy7KeD8rQmsTMoA8umhaPq2Zzvyy7DEeXVYwxD76JNaQwNMHGkL+kPa19qnX3ZhL5soo3c/Y3oC9h0AmUnvAalREOuU1SxI906VuGOpZEyVqW9a0oAyRU1OJIGl9NRlngY5QhuQsZoGcug3DzCY32Uo9It3KVOOWe3YuDp3LbyvtBu7Ry/W/HfSl/S01uu9PUP8Pgo4I9zpy4pKpZiROWSVkYYWMbTFhn2MTmeKijOaazBqYptz/DAL2j//UDw+m4IHiE2t8JKp9KGZxpATQNUBQ9W/du/RT28Px+GXT8JGMp7X/KCPwyyxfeREL9/E8oqWe6IqC0CO6Y+Kk8DwzfMvor4at6GggxUAD+C9Xz+83+b8Zr7j3Es3B937vNwy8+FBntnXbL/SJhGTklXxPrefSbARk7zKjYKzLePHsFerIafYSoy116+mJau8D4XaRfktcJSdmoAtQTnkdyXYZJ/+YqNIS5jsVKEXgDpCBRB9aK3XDRwjN8gRxC7kSBzVNR41V9F51LWrWFfxJWILUX5l8MwzH8uNnG4TrDrPkUJUH4LOwVowhJ5Fo2dIjRhCS7fLLETQwuUdNCCK5hFNPCeUCIWDtPiWxTTXPiW2DcBnxhFEHz6cZ9R8f4EvMPwqmlvTbwvBJ6qojOo/qjQKGH4s0fmwrCrrXHdoGp/P7ku7FI89hgnVmG6J6q2RDVakUvgh/qh70M/FlW7BQNjIzQg+HaaiPVqqpk6hRyi0xLlrF6CR49SQ0WhbT2s/iDg1dbfzPlDVhrm9V1Rh77rdj2Uzum7fj1AJhciI7oz2KBAodVmlfwrYVi84M6QCefHv/EOfz7qVmBqLkmRPAOCGIw0Fkk4sa2cRgqCVfXh8ERfJ3DSuoRFUgwODImdmErQg6BM69HUEIwaeimVoOZE7u9QiZeWcvXMxmi/rI+YrzbJjdnJaR2ENuXy/+zNXpidzR5vFxum2X1mFj7/VK7z61O5QQYY/CJKlsQqh0L+cdrXSNPwaJ/WiYf/NC5Ji8C3+KO0xORRf5DGIGiAbjURf4/44yY+yxCIbrdU/dATsMzwBYrSflq6H3peVyEj8H6UPke4eTPWqN99RofEeTVdquMXh+gBXse3CQiI1WRJbah+m+Ni1Y+Kkv0H2IVi/XvYLUuVIcOBUy9049FQmgXrM5iPh/xmv+NDo9GouvqHqu53cq2IWvayD2yORlW7X6z+V1XBusM/Kd/g1vAFCI3UiQTCAaFTaZF1BJzj7F4+I8NrMAwEEqDdhGqz+kfC3z0us0sq+lQ9YYklNR+lPTqFH0HNITTYTIvS0GWAIvWVtAwVMcux9Af1vjokzPjSEEdjMJ7F0Wz1Y6hYxf4HQneeVFIpx2qXvkBHTV1eXDfMPCW9UWmgtOEQGT9aevQJfOqRi18lTO7PX8j/CV+WMFJKFGOkxLpa7sGkjJ0nJxScfPmHWOVLhBpLkPilnNZFu2n0FDhuYi2iUME6RZe4qKkAclJc/Tkge8lUMMYhVd+Lb7e4Kx1tVaVFmffB1KiIm1LikGmmzPqxvHSkTw33sFNjDpSGivp5thJmhF5u8klIIst9a/lj3/ofu/Nv7uE0x0xDsmmMaYspMoTCzVRSn4KgeKBCS7jXI+Vs95SLglODA/nC/lGNGu6akXIZd2jURDus6HAHuOh+WySGvi2q/WIMLP4NiErMyzrc5bMsISZWOQ4By0MCKBMKosHMhNEzoiLk9am7m5kl2CJQXr/s5xXm2uqfAFAgv6SA/ynC8GIy+SWdTMBFRX1cYjazKnxBlwmdF+cw240yW/7pHz3x8ZiRx14DKkc670fdrAmBOaB2UYsvUeQnS6II9K1pesLpSGDOeJ6N6uRYQydCWFSpEjcfhwMTOTKRv9MjgIUKqrDVe3Ov6PshP/FUx/dDrlHihS4l/jI0ES8VOy1QVYgCyPYFUwEYC3XxGnqjf7CQmvV+GK10LD0LuvQs6NIT65IJ5i1gRVegmETlA4NpacmZcZao+Lnypo/Eosjo3QiLlz63L8SwgXh5JyP+ZaZQ7uVuCKZCbnWZNzN+qVgYulDgkyXhUZUZYdOq2LAFOIBeBbLUQJxc1MjfF0z8NsRqGotMpViAqrMHenIYJTdtQpDjtsdb4UF6W7l6h+ktYXkNVTgi5XP3deQonV22A+IrsK9arzideBkVCBZpHfaOgjTiDg7pbrOmRy8akJcxKGEB78KyAcXF3DsQxat8/Pw474zO4VHx1XZEI7AAYn3KRVvL19Z7q6h1BnjDyJd2u1a3sX7v2tVdsjWpR+6fD1FtCZRy+q0hEGyIyu7QRhdP67ANW4eDHey5+pHS7xZW8ryaaaQVIAWoTmNBLoN24a1NILSq15j7KEaoiKMF0IZpSFGzXmTU4thhUFCbZKjtB2EUtesAkfL/AJUso9P2tvCrDjo0qK8gDmGDXyvjcECWhBdTdFDSN94qHa4CZ8BFLNhI17t0RYjWeCcgKbtN1QCPDuD18OW7JLqdy/VTAB53MRymEli1V/DXD8Th1ncRaHSb4IoO+F+KoyIP+BE+FUIf/zy0YWuwmvxgNX6wqp2BgZPYokdESZ3Y6NhV4udN13Tg2li4BK/UF3VvaKgkju4DdVXQOWAVpv8ZpgkW9cWH0h6Zreuhe9goFGshPlzF+rSiyLu7YfvYuZf7zg6vXwbYuQcsxLkiZgMj+qYh0TmhknVcjiPXUx9qKTBF+O/0iN3AqKs17UYqo+fDcBJReW2mGl4xG+F8I3h8wxlv3CbnOVv4b2sHelRVWpUGwJBjtJmGmG8bCEQw2MIfzwKsRCFXiLaiFal8VSvW1U0jNpUOWK56gKsm2YH0O58hkmm1pKJz/CLWaDRORjb1Nl69Fc/mUhjrjmHrk4JjUtrgjdQ20laAmxYaXE/pikDhlQGpGQE5h6nQEEprokZuZugZZ1vqj4gmDqH1tBWVb6V1WvkQIoe8ik+fSFBW9Z+6oB4/8BOmKXeReyGNsASiROWOjlb2cFeeQ+KRy9y+CAt0juQ1RkCBG3VkjT6anpKw0Ab9ggM7iWpIQjJIEOoUMQlYi1QeAzqpQqjngSgSlL4kVURpen86xss7xEVNZ/QwRmlzmWnKyjKnFSk7zvdEsPlZmYihZgKRdtxtcQBfYVmPmFVQMQlh83Stef+/dJn3v2XTumE+EC5cKPDBcOlhf0Ts/wocU3y4Y9/qLz5EsrgjwyJV9ihNvQ4TIy24X175M2isp0lIu19ei8XsqoO3BGM0mdYi2W1lcy22pDwxYiAnVFn2J8TwVqmCUbEOqYOcum4ZI5mdFIeyzFil1rlsJBufXrhszTisxyO0Ee5mIDuBOlwa/+rQdvta4AgP6NAPaBJdHm2FFeNW/tLhCp/hA86xZSoqgTn2cReLNrYuywEQEdHIyvGV29hnmAWCRit/QzJYsi6DXfnjME05cAMR2ZX/EYrz38OVPwkpXfkzPhrhODsK5T8rYEXWQJ8qOlTeNft6uZObWbOKyi0RiGTHqUDr9BvVNSxciahbfwEF4k8dz//xOZUl1fRzIg/u/F/KwBPRmOwnWHqB9lsBhqgtjhMp1nynNXbl9StvtCzrsEXZIhpWdGCcNjSh1+fBmEeTdmeDdGeCs42B/uMdGbZKhlQyFJrtyZI4yd0fxXtF4qL/P57/Y+yvVF544ZbD+T9Ge9oNV6Mg0srr0m2CksP5v5Rwske0jYl3PN2+8kayNClVPJ//k+bwHcf8H5qbJK6cS7yOSZ/uWKnsvOMrrs//ce3MB+lO7gnRzpWxwO4S7PUxP6ftaJnSnkuGYTyzYNoyTEuGbZyhE+m7Je06SWsvNyNps7SVKuD2OUXxPIerCC9oeJE2kEvaw14Xu1e32yz0ZNWPAAXMCmRoF23BbLXvznTLiDW0DxEj3MEAvBK4p3T20F4eE4LSI/k/OVNNl2iJHVqkeYyn/QRycHaOZ7xy2uvoOprlCJLcVhwm1iRyH2jlJnIk5mh7kPbSHvbQBE0g25LmEEKnwgFH838KxyHajyK2vUKuayJfnhZz2WheqruQ/0uJC84TycC5DXJhj9awh/ZoDfP5GhYJ+Rfz+WfpOuQQsOdpHoUO0YFcIc00kUtPaVu+0kmpdDJf6XVt+Sfz+bdJ/m25/HYyP2PKknaSZhxLpIu02zFKmoG6jbYpqNMuG8dM+Wzoc1sPFhWiSZrs0oN56kDjdW3556/eA5pptc3QesA9tFqNQqvZOGaqBXgntPOfGP5o8ROiD2fEo4ceu7yYxbAMHIo7gd7q806yN+gKdDorLDzLLKywcL2Lrwz26/L5rw27SJxhGmK53yZ2jPZHMgxC4A23ZdiyVgchAdtrG9MeS1p7RcW16Pap7rvJqLaF1ibYWEawIrL9k0EbZNCuvwq0QQbt+tcaWojlVwIthoWlebKEaXkH2JlXIpO4MZNK5lQzE9HBlcpX/JeHrs//oYmd6JBAPaKlYZsSVY2oaGjjSV3N4pqDrnShwi5DaZJTgtbFnvv0iKglDBW8qmqLLItlZ8NPpx2+k+vaSgYs2W1fDcvGjWQa1f8XC3uI0y2qccHtZvZHXKHThPmFuChPKMKuQcDDg0pu8b4BrA++l4WlAoR3rEE4TuHDfYZli+glDNQb787t3vVt+fwOcqB+HvvujZi0N9IGWeiLdQP2BrrmxhNzG6AQ0AeEGUS/TUDGvEa3/LVxqYdVdYaVFSX+0/2IqugO6QH2Uas6fVtS3YWNVY2XcDW0zFoDd4zSu5zKd7c4AupfNg2H/rZHn0LpEbN2TYs0TecqqNLQhYTCppyx6E3xMht64oPyqrkZSfvY8/TRy7ZfdjaWf0ByirCpWW7aAX3DmStmpBSgipAzDmhOVO8AzVc9ONUn0RRAv1WVMLbbr2OnSgkccGuigAT4tcWy7mSXXXmMyeU1yooakn/AsNq5Yls3KtR3l9r3Vqj/LtUgolHGJRpdBi6X0S7KraN1rhz1XUEIWjt4K+T+u6z/RCtwV19YMWW0H+ISXZUG9DMR+o3l+9JB0eQBEUMAPiRWczY5ljFR04ghKt3GTg29CaEv9JgYFJLUXF/u6Au5/iEY7DGi24YO8IukmAq4fBRq5RqNFnnSQYsbFX81tAhrqgQODEdcixsE90MMAzBfa5EvQh184xB1DGpEjDoQn8DhFykjRerQahSm6qE8Me6SByyBVeWuHEFqHpL1nhrDNOypUbmCEA2j5FrUsENgnGq9eDOYgoWUe3QR34plCpUBKQ68ObJwq5BsoKwfGIjqpF8eLT/9E+HGLTwoQ/5bdyGEbTkUB2+PHq5yTPIwBm4oNzjityO+5A9mnolz5+B5bQID4FUJiI7vtwmJkoF9RXckAA2xPhASq41dD8BEhGgfGDF4nDzCYUVLgKa9xy7sQ0SvSjzDufjoynDYyIHykwYJw6kUrKUVHvDw3ZKWYD3Ch1R9hMo5Lw/xQF4ug6hU1cV0hx4DDZ9eRnCpaZ3ogxDg8dMPBjG4SsXTQZX6NFDlJtZJdzjImqpGKiP59IhYV/bKYW6v6DQMizE9dQi8dX6g1vnyxmcfjx9mVny5lM0zogdtTcX5euqV0zuWx3LSvpHdP8Y9X9Wxs0k6nM0cy8oVHEj9MieKTpPWQQXC1W8V+LhyQPKMwPP1Icf2QonygMwh3oYvSkWvPmaZHKJrS9SSTO4GQBOSwGis5D/QKrYYRZlwYsR1f9nDqbnxhVqda0AaHDZzwUBPQN2UZzAbGVWdKUBV/FSa/kyEwDLraIuoYC1tVY3hxZSI2CiPARp31p0DzqZzEuxVQiV3pNtoa7MJdTtTPN0OZyLdQROCAIQWQcWddXC0hEcVRzs4WrCU7mrAPMJO0QSan6ZJbIh3s8Pm/9fRJHhF2PF2OwP4V/+HdG9IamDHMrsqdRt3vd+EAafO9EFbOVOJGAscCFzA8e0MLGbgmeJqZhpcEyg7S9tphnY2pC+7GrSDppsCLQx6uSRnBeVw3CQlJd8smcbqKwjlbIGQmQbM4D2cqCwFA1cwaOAuAdYTnIrRj0dxGEhAHwrABs3OsYFoaOe5wJwYjS6gE3WFYoHwZL1EhFi1YF7QeplZOEq/r+HWW8I28wgDN/NUQjLieGspIMUfAjBzAGWOZpzNqLsxNUsJyDff4MoiGysMaLKTX8msjEKuQiGYx837ZH1Li90tHjVpDYvHbLGlj+or1PMNMgDZL6UAMlZQokl4Of+nyq9uQyt6PmoxRdQ6N9xTKaGegFPtonhYeYOhlhodZXsdA+iCfh+2+XtpX2cDopCBJmVR3oWjmVsZq8WysK9Qc+7VcjBkylpMOUcGleNCxSvmSJQKUGomfAVMOcvl5mgWLLHELAkGzbOl1tTJmVo/mDPHmODTqzHnkufMWcAz286Zc5CsZz9BvvToee2ZEsPkU8iXhU8hXxrHl0b58tVLVtrekp/E84DF/mZbk0xjWWzjqmuybloEGxYF+lfGtqkRdscG7ZpMuyDcsiDcMq8IpXqoXMpJ86gQjJTjWqKixmLvZykTqbF0QEBKPNcmea5dED4gALUAkBbyfDsvkMzLSjrxkOi32hOxTERhx82RAyTOAyLdzM/27jPt+DK+ysas+XmkzH9yXNjBh+Gnjg+5Zo5D2+zZq8DtMtzSnrIeqhOgoYCzwlkW/Ey1sAPNN/HfXSMZmvbrDSDac9HuyXCGhvYsGbSjmCpkqnkKxJwVeJc670xj6OVRN3totV7eAKr9wJSjJQimy1AKhGJtJfxiZpq7QP4kFRzEDUzyjuZu7BRplKCTHKv+pD7QICswu62MHFXaxiPquct2v1ZV/SmvDMHaCWamIbLVLLmBWdJFKK0MMar38+9eYeBSx+SRFmmRRAeohw1/usb8UcJANOLmKcCpijNG+iUcQ7dzKkaAAhkDXABJKSLe/NwVsabhlShiicTZcfniZSYacMRzyHNX7AHEDmviBCcd1A5igezXdLuxmruOhVC81mpOMLCP9vDvITrIv9fTAf49zEquHjNqjyijhu6DJQXQdFEHvOKrmMNXiUqCrX1QvR2iw8y7H+tyRsNMDlxW0MX8H8ene+l6HjFHVMHmfhXvXFkl4uL5P9wmWfQEyTYEMQgS5iZ0bK6UDrSHDlDwIV3oX25h+aBicRQoFlLFmfQsl2EeVKxEnx6Nnx6Nnx6N/wxGI6ukCp8ejJ8ejJ8ejP8cpkZlwilmwZ8Ge3EUjT9ox/291EzthlOdnGngOG8WMEigKLRJGepAv1IH7xOMOeuhXSpA57hE5WYaMFUMh6A7nfJqSG65QkvLkt4gbKjQNRpsOBUloRqOW+ZjrUfgbKcpMNs2dti4bgctwR5wFzscGtcNvWjzrIFzFHyj/yEY1UMonsfgr6VQXHCVTN0d3Gh80wiqPjUier6U0aB6Irk59YCdY17bRiVujR02ikb7/MspEwQ172ymOkwXCMX8UIH2kNuY4rySJ50UzWERCbekMxKYF50tMyYsbnrZrdi9CvKwCI0YIjOmObejkjIJR0zkI0py8DcvI9VghOvGMpa9CzYoeykhDVHJeTJmVAmAQ0MnxqT1ND6t47m9k4qewPfTxoI2kgjt26hNsPlUXM/Ajn5S5aUtsftiiXvN6QsFpc4UiVL8Ak5G2Xmr1c/Y0MwpSBCJaljIJHAwo5KSVsflmVyDPk81XkEVdcNAzXetBjvcM3J4+gGjYD7D7jy23ISPhwiCeY5wswcZUAyzV3aSWgUIsxhdSt85Ic0C1EY5FpiQ2EmuD5UnjtRq9zmT24fuhYmNIlqJCLGgSDQOiTEV8CE3qJBUqkdV+QILaRGK1Z8nNiqRzX7J9dS4nsYAhvBdqRI6AK0spmnoI8ASM8oSyWmVHRhyjDId+KL+Up3ZPCMaUShP8/jDVSHEOOWG0V09u0XN6hNir0uLRVNcdFicYMZTRhp1fGYDYUJb1EFeEvovyeiWacTbYO8HB5ScNrFIu1pDWiJikTUSVrpYsddHaalkf1kyLGkp5LIBRKbJVZmvLcjG4oxOwEQyCc3JQ7FFdl8KwFdK/jmQ3xH7EGPuEHCHtpKM2MJxJWuYKLEQOEZ2MkLaYhe6GpzcG/95Nh3JzkJzhpIG7VPLDDBWqxmoHn1FWA+Us+ve7m7gPOqZF/Kf1ncklBolpUai1FhYLXnR4rxQ9jzGmzD+PFd1PuMD0PWqtONMykrttINATVbRbrKTdskq2iV6xyerMl9bkpOjbulAsnSYEdoFpFLbqGYYYkgpxVRbZDSfz4Qsh85JiII8cfDL2C/m0G7yOM+JXziBv4msOMeAU7UxIkgjlhCxRJVbJaRHnTBPDx+0swYwbsUByGbOTHM4pAxas27gDvysREXp/I1tJ4KBm6p0pHqjv88RATVFJVkcyAnOjGqvsUClpCMvTvfQLnv4pNTQBPc+zQkFwCJHonaJa5BoHJiCHvjjLEEDz/9uw8oPiQv44wwcPYWPVTGPLzGbgYrLsgSlbRybjqvtiydB54M071OMK6pzS95tNI4VFldq9GBTawGfhI1Vp5Oh3LIXQuhaBKpSEfUzyDLjlebzeu9BjhnYPMcRg2YbrzU9Zl8FPWbXpMfcVemxdBV6zK2mxxLoMdFGj5fb/q1JjyWaEHrMddLjwidJj620iXPrAnbBGQGkjN6G7Fq48Bj00Hof3srU95Tq2KdaWxGaWVln93bbSVAB3UDXp1zPk5V1tMj7re8L62blu0PpceR6fNU9wHndyWK2ElTM85qVobR6Y67+6AW+qMfBIhYYcpBAM01UWSCjWJcXSrIlChXzRz2ixsdyRhgrBWatFazCtx1cUA9O0lbIj3kxhkjr96fH4Dt7+kx63DHqSyFingxJUp5mUwK45zOherTMSfWmrse5DyWgr8QiWMaAbNgWbAm967nNJuz0n7ZT4L5lMbFCO+wsKGWwIIJvuzecoAWMAY69tcXAk1SyMyiC/cackovj9KjFcllBD4MwByrNgsSzItqNMmkXHf++zusTsB7M+FYFeMa+GPNCsxnCSg2Lubb20Z4MT9laCWOPLOXZGjTzT2EuOO6m5EF7gxyU2Bvlxqm9Th4PsLvZKZ61O2me+fKQ7NvsNNP3RMFvgk7QNHZANyBtkQ08Huwz8DJnl+BioRtB7OiZTWb0UQKj0wL/7luD3Q0l2caZQWZ257UGszsdYk7uZHzF1dqMn+16hy1PG04VUXBnW0YbAXWbYCLdBuXYXHe5LLJcDbyYABOJPL2dTtRHeYxMQAxMyG0nXXrv8HgyGLE7WFL2JyH+Ge5vuV6yu9w63aBYBT9JMwVEuPxIOwS0bdguoDhAkpfT1I4HDx0zr2qTSTrOTcJXpTFZEoJWU1x0SYT3lBtXuplFakRLDV3ozOjaa1LXXnO69pp1p8gzkOmrtmbEkwbOxLOlkp7ppWDzp3GeBc+jod3nF5seZFWQ6Ypzn2520kW/XYwgQ6pZhr2UTzJUVCpQI0XHZQFaAmlKXhBPncwvYsYlBAWMti2SfhsZQO3gjQFo5MyIZMi5YBXt+OGSmvqwtLYAQ7eF/JoVVAU7888nSclH/61S8tF/XEpW2yl5W1+hgtrDFgFDRy5ULxSbEqoIGZqOdOOghCfXbF+3x90X7V6ICJRK51BmSUk6rtv0mS5F9tpFofBcFwrPOAqXlMILq3athuaYyyZlttmLvaSnL1ZTQUbcKUFWIsSlWIi2z230mEaUCLHJRy22Txpw4twbG5PMd7CVnwGdmLuUattcM0x3JYDb8U8B6VMO6UaQXmwhPXhVo+aZf6uj5pl/3FFT65R/aGkH68jTHW7CkygsB/iqtDOvTLG60nXIAmvh97fwv+gxCbzT/CpDSFln04mmndGVdEkIJmOmqLeEQckpJkJRB4XXXurZBDOotYEbnsVVpp2BnAOxK2c9iW4A5O77qgUSNuXZatbbj9CC4FPgxyDBhJ/ygn5OOl9/5ISexWjDWF2IvS0lXpBMAQJL22XhMWKnysQlk8xOE8GIG3VGnLM8kaiRi0qLgmSoSi7o6JskDeMdAF6dU9JQw+/dWLZP5dW0dlHAMQBnEccbmSqIu6ZDU0HBlgVIwC4Oq15Z5wb1ws1CT0MLrV3aJPt1a6YaYX3+R/dlD3ozM4ihtc12vUzp3JgFHIPyvm5vwxtmuzIhyyQqmHSyB/1liHVaFuyF0G6woAbyVIvPEYWzdoK2s6fI2VF6ithZEKzaJUGpLQmi7TanyeSGWzoa4CTOUJviwFGWtHojAAiezBCMxLLYRKkFnlOvBpnJaUF0dR8wem6poRdLHHox8mNW9KiZLhQCYLghQ9V9cXnlDm7sM5lp8GPwU1BRIu1y8adRHB2gmrcm3MbIXmpSCcwzmzHPTrA5YHjGCIk08DQCVWWREmQtmh0Hg5RoRhkE/jaqpTHophJtFQVnchePVANlZ70yuKRHA0K/gNMwadZBke2qiYA0xq5kVglWVILFSrBJNVZTskHQGlC3nVAxCGVoEdy9mlBO0/58cDIjze+DNH/RIg1Cv+9DzxtHqDwR28StUJwMaDWLH1LSrU01L4QAi/GwTOrTcnHbWL/Ok+vRmCk0Sxr4ixIHyAV+H4GqBoSz/FjHzdtZQLIEQk5Ch2OUkJMgZCyENDqpKfnQA+8j7/PE9VKztOq5ninugEhzcaE2ET12CcQu0aROGG7uUjHKPdTYG6nOddBR1QGwWJTNfxroBLGkCY+zFG6Qi5vQOEjmpo876WT1GDMXem2cqJ3xopYJwCMUa3YwrTDZrO7aNJfu4+gkzXr7RxEo2xg9gNXukqrsGJyqnVaLUHRvUi0NttkEYn+advHihbY1aKxJY6Ae0DIOA3YtGUs9YJ1uC0nPg/D8vnqU87zFQ0w6I9CsgNWUWVFnxJIc7ZbQpM4GlEAC5ZYkJltxLKqiIrfqwHjoZMiEQzZRJSFXjTg3+IqtdQ4qdFJkgTHXNrzmUMMcTXItkzLlsCw2DuOifM7m0ASUKTEOx4C9ce7jLt/B2OEPP25WLLXhwHQiVM9A9OzDn2kZ58mtfPPg+nlS11u+S96IObf8GUeGcdqGlG2kkWo02w3YQMsaGBoYB3R0LaAzWDsBFSvcCVoS6Z+aEeVbBV6mANH77cA43MFpEbT/GBk6b8pQCD89FNYaCo+aaw2F6r/aoYDe/wsZCgD0kxsKRocCaO6eipsCq3cMhSnFqxsqnoUF6bDqn2toB2Oeu7U3kzTHLc/KOmoObfIqhCddz/uJ8n78Knkf9hsx6D6Vpzv4CjhStHXbifJA4GAHu+flipY0nSztt6X53P6Md4F7soBe8t6CkjaWjpWlY2A4Qd0KpWIw8V1wGAz8lO6A7ESPgK1f3EKPFSyv5s6zJUhtZ/1drjxbiiAAxxhwTDyi5G1nVGVTsdVQMoNRFbA1oWrd5dETQWduBMxMKc/p1hkgnRAdezoNNJmjWAedoONnUj3N1tXQjf7RrCCzTnoxTI1eH9Rl0HlnWSMHFkHreIOboyD7VCNqwbZV7VpW3VVlm6Ix4r/TIzj5wmEZDq3lJeBADVgSEadJ9rSPlGUdSI/bXuLEUJ/S1VWt6KhKMJVxlgeSlWKUzU6u11I9nV+lesIByIIbzS2TAjjzlAjHSd/SIH/OrdjTmCXRBnHYpOI+hf2xPPsdVH9GnkU7drPcGLfU6/Kd4kr8leCzeE8uJTVcO+Xuieol4p3PpQevIIKt5fbTfnf7Gl5Yl6bpS6E9qeQ7rQDZ4+55hadMA+cqtBHx3NrNviWwG51sXf5Nl87wUKs0oVZQ/QFtoKB12EZL4JRZ4YZdoCvH7FXqfH2IL1Ht4V4uSd3Vn0VX7QHlIDuhpdJdClg631p3T4GZUt68MovUA9UwjWcMkxphmVgPgsf5IBj6pCUmlTSDtxzkqHfhNqcO0mM/7GpYLUS4lKPqHmjPJvX0T3hsSk052KYHO28ax9/pkUbDH78FK+s6D4/0tCfQY7gpMBGJseYSjrBwwAqTTTl90h1+rFINihNh6piulx3ioZUfDMX5/nDlgyErSkcKzsiIvSbzhplXqNBtb6ebTCriHA3WnpyV9vLPAxzkQIhA+MDKaIiQQchwyCBUQKjAoULuwAvHZzj3qjzKHc7/6WGYt7ZxVjtrn4llj9nP6WEwqLvM430J56SxYkhPgRPUp/KfvUBUQvOQJzTplKClltVbkUgO06AkBf+dHvGqNjXKuqCDWZCuEluNMKf8KdtCduwO9Q10UxwociwC9WLOpA4gKTwLPPo5Na9n4Vh5GFgsIf281q7YdJJQT+xip8Gb7wu6LT0woHZg1vKLyHJbc4uqU6VENa2SNS12rKjaYEClRS/P1E5HYPJ75JosMuGUiLsPFE2pkc4CTflXFB0SiqqBRG90za1ELMosIIgA6+tEDhCddmhHpjVdu+uB73QA0wMyWbfWtjcCaN7Er6gGFEV35w5psOt19mvQzMG9Dp+dUU6ckNFvp3X06g4fgNJ1Os2pGmDMLXV26zJNNx+KFaSqJesMOsArUV47N8BXUCvNlEWgvXayTOUlLirakopRTrBTXWTbnEC5QNONnGRLZ1+BYJuFYJvLBNvUVUTa3L8gkcYtvdZSjRd6kGqrxdnc2uJsKi/O8Nsu0SZeuUTDEtPOtUm0OeTkfZvWLowwic2Al22Ta8i2SR41nPpJyDbizcdJmrnxQTuVE3MLa4/1+U+BmIMYl4OIGWplRuXzr1j6Tar0mxPphz61pF9J0JRIt0qCzFIm/ZJV0i+hWUXFQocgZNHElJxvCcPk2sIwLwq164pY7KpzfeRwXkgqE3sk6ccZVFaWMs2onRRYEXYiTaWpzlUB7eaKdnAt29VIRg64sIilxK3t9lNR71gkf3Joq16x2UNEB2j/5St+AavOXSMXL6ecJDnvHMEXnjoOfsHenqHzYl03+SqddYvnP2EGAe9PBnfxQJJt0E7ezZA9I6ryJ7Hq5b5Y3ZCfpp1Ne5NIUZgyY2VubzZHUYSrpZugj8T7o3hr3+7mBF2q7rixhRosmAOuBUXelm7HQnUnV5ssM0BN2r6cTkN8nmADMtpN8iALD3pOgM82eGeWs546eCXdo89Go7YzI+kBseDdicOvGS6iX0WxY5TSyecu2ZRrtFBFoxdiSmegrN4DKY29GhWwk7C7aLcoC26mWV74KmOmJdwYI65oF3FoAYSiS9lVJUEBsC03jxZZrvM85mTAYt5iLDPvGxObsDHIP3Zx4QrrsZzR48Gl7o/jYLCgpd14JVRloVWjhVi1KsJsMdd30BLucqWxdkIv0qVytuIuc11MD3I/7H7Xg+iEMq4G/OWyvWof3dUODOJwxnWUL8rTIbqeO/xxt1HMrT1eud3jDFiQZsT8q5g3/5Jz4QM8QILncL0pNwJ25l5PMCJ3OE5Qgw4AfAH+ML/iy3/Elnx3H8lgQzNTOnGpDZkf0ON0E8TXuLyGNK0IUfqe4Ea32eBq9D3KWabpRIc1KwjbYcd6kxuotATdwwScCZqDM+e3xzsEKrrOzjN/3gzwbsKoghmnnWRmnafjzCS60LqFiXgr3USnoPywr6ObLXfF3satyzbTYuBjS8kygU7Jwkk/0GNfzwE8x7edK7yVq4Ihr1igP23SJcjgG7jdMfbUCw3+VJeqLWCayx8alPsNC9gWthtO0Q28Ko5V3YHSsyIh4TskKlP4bgEJYveWxCzWLc1setPqcvNq4DRjsZ9flZidsywBaxSrOaYzFVD60ozWChB7A9i/kNo2zJ2wgTcl5v4h6231EH/83tdcl9nmDRg96MOOdAbT0d3Hnu3L//EAeoNd5L9DmJY437SiqbOq9BCvFw/ZRUWD2L/qPgHKOgxqWRi3oSfdJyZB9jDnd4perH6hMWMOnpReN5X3nNo83Ut7s2UATcpuIP/iZBH4KpZ5LO9DJoaJDsNzSCoTPVFM3Iw/SAxFVcYhFMGzm51IECOmMkEzwOW30+uwaFiiRVnv6rOiM8/xOMWNCjydXjYVRasym7zhwSh8I/+9qcuLy2+2hznlekYw5FcXzO4TGc9rZvsZXYoftm+mw/YzOfWz+O9N/PdG/nsD/+Gizg0tdawRrr2ddKmCl0xl9AukBksKuw803kefiXsi/Jr47StvTD+T3sy93Mehvfx46Zs7ges0M6bPELwc59KHCKU+gwxjJz1Cn0Wo8rPojYhmKI/Qm2gvZ+18W/t2fbe9G7q48sN0iGu6AT7O97oVre8w1/cG+NB37sB/Zysp0HRR2cALcWYE5ZacLPAL6IiKI/ZGSuhW0an/O9pGLEQ+m26B8zm0VK807B3s8HcW7Z3sPsUMdRdzwpsYkU8Z9ryRPS+E7HkDYuA5TG9mSBCN9OtzjTJOlFluoRsA2zQ7D/BGE/Xz5P65qJ/duxHmdv49s8B2usFe51aPn6Prih0yNZIsJe7WfeMFuZ/8/AV7UJ3PU+fzQd07SArYe+hO5/s8+mzn2093Od8eGuM73faAQGtPZBLRQCKewIS+i/a8FKZfABBOYt1sT1tsd0/WH8Y0xB4WOBO0n15PBy5f5qpPcKftcR0Ui+mSk6FLYpAH5QyE/TZEsaKco2TyYGjsjAhdkR3uNSGVpzF0vi07uhJG9IPccAlqTC9genJHE7HabRgnfItXP5bIplUOozEVTu6lnznaBvgW9JhlSblnF1k6OsJFiBfA9i10nElsj8uQS+uuT3H9aGa8wRCg8uzQxCAo8EHhLj6IFo4OW9HGRyMFfdIyGM/5XgDKCTsHZBJe3PRbLI40SJAlyZyYrWkSByaW3b7zTp4q2u+qyJ5IV65vudJWJEU16RdepLruf+8VlvyiK5L9ov18z4zKmmqCOke7TogzoU6RHbA1YuRay+nUIIH96AD6laj+55xubc4LoxK6ENkDYG2xR1KjJjIjKFA/xx5/ge8LAcZRsGJ7YW1X7XdILuZdxiX1A+q9yCWkUht4kye05jNqLhRARmTImVZhZ7Zf9k6XAILGxr6asqSkBz1oFCPY8FVfuugrR9XiD+qXCenwIf3gJfYerV+xqWblZHJu45JU+xcfvnwxl2+PXLKni0g+QAcuXrqoe5D0oLq24R/GKmAlzWyCLd1B7gRpBixe0wP+Vf2QE1MiydRApsvSkysXkY0OXEkP8OPSm36c1LlrRMNHSJ07Ry6lpB/zEgcZSHlMHWZEwgpNGbobKPZAuY27DrgOLWcv/79Fo+jztW51uK3mlfQ++jz6wkvp/ZdTHKdU63cj/356C32Ra+PdQNzRyxL/uaTCNpVO0n1XiHn+fqCZ/zmHq/1inM7wsL8nfYCl3nCzQTIgLqdn6B5CVM1HXXKYJHUEPwsLbwV+4PDZzoNA1I9dPP4LL7xw+Epnbu2QOMj9VvacOgYaPHMUdGrcbXn9Cil6lu5W4FlD+BD9+5b/bcz5Ke2XJ8CZZy6m98hXwVJqSI+P4+dtkNBH6SF2cFvTQi6r6nyXm4p2EWZQdh7Cy710lnbpI8EBaXVt04dejw3qReI/1oJ+Sb3cSM+dtl9KX8Kzh93GNXafH3bo/LBNrbLWnBgm/skmhglgZqJtYjhB5+hLeWLgbuPcjOrczfxkAC3SazUZTHefC3Rw7AfuCPcmXViblm0J1CwY8ZLFisClo/z6tZNRrNQh/uMBub/curVkuTLSxzk4OcUfZ0jL7BXOS4X8oQThcv+xbjiuaJHtF9HccxcFsCY1ZXAUzvrxIkHjg7SszK65Ih/Ns9G7L6cEyYOVOt0vyZVs0JGMncspSzv5kWysg9LJiccURKYOo0sYMixVePg3qHGZtVj3SAqEiGDmeMvmWx1MO84HZuL9rcke3DnAW32eFf6je94klRRSB6e1lF6m++gLdXbIJ+NQ93L1mXfhQ6spRByErH+xJ7u4hx1zehyo5E598eA7kI3Ew71Lie7h/4jpcU9ZUDLqUWLvczfXuUNn6QsYlWkR8QzKGYIEofrl4295y7cdEUkv43e3mjx8AQ5L38aM6yqgk8K/2s0URCDhAHLGEWrxdV5gRsMpg/4AKuLZ6k5VU3CdyEkPgeNOKl9NozWpGFABgpBMZxvgwvyBkNajuluhz/N4U+atMvNcVmpjVTuBV83dFKKMA1xJj8BL9EWX0z30xRfpQQj5I1qQHrwERuGZ+otpzyXV2wUEB6QEY+0B7oS/aA8LYkyz7FLjCpP4Pp6BOWYPqPFunqH224Nl+ne0HUycBvR5+LJwQJ+/ZBLiSpdM5NUs0+jhNO2Gs5uug8OvCKGj2+lGkTfj6Pw43QYk30a3QuzcqvoY1bGo5lK1JE33bTJ5DzaN5btVdIo3v9DaiJQ17vNkk/o1M3kIhFNn5dVc+CZaapkl1bWI2mQGTdUh7ETrkwYcwg0H/WgAomN5FD8AjRdwvUKEsJrELYhCM8WMgM3/JLvcu9mmJM+f5vTZXH7cG+ZHdTS1dPoM6paobbgwgchxFFHvGOVzTGihHUifyFWZ+FxYktIpBppx2mQUn9aIppDJ1isQXS4rE4Hjpk9TkMVAd7b7NFlcZNmZiz7XSK9DdMSVuOgiMZRjNO8CDFLSCnCzu1oBacEHuPKdrQCqdIExrWBcA1qBC2gFPoAKfEAr0ECiZXZoQMv4AMr4gJbRwAJN0jbgkFEIrc5Noq9m26YZO6+W+mocL26VdQd9eMK3um5wCC7+JIXSfeLOpoc0h/5pTo3BM8DDmzaPjG7ZOuZuEy0S14dXgxHXqm8f5erwqWvUUUId+vow4rvX4VPXqCMh9+EYp5DqQ47a+g0bc7Xt0+/RHJJ0H+/zda03s4vWQ5y2t02cTeg8uG0eEuAmKJtxH12HTsB8TjNqUcOlOTpgOhECRQnMaiCRwJQGShi3cv2BAwGqXBYqlvR6QcXvoBIJu0BRExOfGGs4QljEKiKz0/rOM0y18sQDPNqV8mqjKV0kbMGyZIv/gOeQRGIbFfvPtfyMKRTlixD+u+5JGrW+5w5HrXP5N9avWk6r/jaBf5YisWaFijGW80zUEDVvzF+4QjHNzjBLAc5e/XmonNMegtkT5kiYHaLeHn3Zz72hF0L44GX4OsZGL2YygGgjfK7lRF+BClxzdL++cwfE9biCRj9h28MnAm1VBq4GpKC0dlmqsEWdmHuwSO1ZkhOxor8G4fumKFSjYopaphNnyrv1wYvhLiq+Yytv4qkfpN+hz3OcKf9tISrJlzaihxXvUVpQtEVeAez/g8WkcqQoCgRG9KMIlqACPrESQmebIIbZLpep4Nc8jmcKuUsgVED5vlBXXD0IqrcX74+prhc+1M3DRbDLaWErhrjBEY7msgmcXrEdVW1DLPxDvdRziSLFX9xgI4xezbKcluVERQHnrqxlU1HhHpbl0xPg/B4+f+mjXv7txxMb8qnnBD2mPuqnAapwEZw/dZw8VbqfPFVy5ghM05MZ4IARCKWoAUQA0KKyCKQzvjckB1HZe4jZ4LygFaImHkCoJwKZhFPKb3ZffZVvmoCFYTgYYkXBtZBhz/0Wx9feujD75Pzqb5w3kOqMDsvfGUahjuG363BDXa3saYACKQDQQQGzZDQme00wC2Jy1qBFnCR2+ShyqIsRjDMZ7Yjgam7zcaWyR4J8ROfiRWkp/wJhVP7TMDL4yAyDK0iwBYUxAnsVqXhZn/dS6CMBPKijCQeGnO1jz+ojRMxGYlfqqqDixbR4WT+gzKD4DyjzkM9UIaqJkx8yYjBalPoo9Aajhee8pWgP9bhNBbxUvGsErfynSyla0iqKl3SdK59avnT50pXy0VC/VR+0LjYF+a+AhPIVjQHx6ucFfMipEMs/X1tXuxA+0g8Z8XAPo8vg72HD4RL7IDc47L7tW8APJCuChEDx/lRkrRyscwC6OSSOAqQEvhp8PQIWfL3wVVC0zPhAoIpApcndrOC0vg8fdC9ATg1Q/3JaxaDEt+2hlniEBvCAzpB7oiatLVMNu+t0Pa2vB6dG3ouCi+kGoL/23kfSjd+eDi/bTbTxGD357fzijN1Mhfznf+Qj5+kIDbkXedJR2tBMt0AIGsxjBgd3WKD2aZQl2orvtDfToYa1NELspLSF98I0olnHiQtOuDE8mTMjqDx3Jd3m9FsVsSPYzuJlB/sN3lbZAGcXjaoSpQLjgmmOZGc3spy216HUzXaG+rzFwSyQNwzkGTxXOacMZucRnSB6AWhYfI53MtvkgH0UD61wpdXTdokW7H45q9PNEV6hdBx5WdlRtuDKjrpbYnY8yAcJh/T4ehECwV7veG4/HYKEKctTKFSmQ3pCfJhnmCM0Yo8WxEBZTpK1OT4CAkaHwILtLc3fBXeODnBrAbswd66zZcWxun5bf6kvgA/YBySbmIlupoCGsYdRNqDND2KGpzpT0z1ougt7koBSlBliz9DNIxjLx7GGljA3MsRFNlAdzJXw0kHWz4Y4yxAVJXCM0XhDFwuFG2m3HZLp4Ubax+Zs6QlnM6cWQelJusG9jHsSGh+ZNdKT/I1eEet0whvbcVTYijI+yrSiCj6qgChVL/h1541dZx4GbQgzzxDLIgayxv3bLcvQHmL9VpNqytcs5rK+RzySEWU4orZshwg2/rWmn5ICJdkxURWILqbzaaEirQdMQ2BANM2GCkg4SkfAPUeoLOuCQ9BRXUcLdP2JB7HbfauweGoetIfpeo42I/JCZuj4iuPKylfHhf5bu/DVcaq9Kr46onyl/EpbqNZAQ58Yd1nw1mHaCgccHiiLDZ2GH3/c3uGuLIYs/1pY7Eg7ix25Bosd8Sx25DVhsXrI3FMDm9Ucm11vFzCbg6PAX2CqGc4D7vPcc5AOMSOckvfoBpTHamJ4FtrjcJ/hc2nwBkM3Qkdo1Bls2aKTf4dRSVGhPiVfyk3rHnR7kDP0OWM99lYyE64TYp8168xNTnQ38ZnlUJ978atPTbjGX5kJVxlrLTQ7pCZbGC80JCZbB4DldCgz2TrGcNdJ/HRMTbYO8NBw/av0F00YhgGDQGSoIijCy9d07OpWT4x4321Zh6OMPSlcfmMXLj9BrGmnaYeQk8zrO2gvnbiKqdeJ7jx5IofAaazLaVoQeHSVqRezGFRSnaZeldxqEoV2QnYNSZQyFSzritgKYLnTL6ZbVe2g0nUdVzJpg6vRddAaqaRK68QKbfxa5lsDXL20C24eYJEInj7O7BjJzlgKHwW2aQD9E8IdcQtaPXit+bfuOSwhlZV0QHiXuIvZUyiZoedqvvIifMPJ/P401l3HD5rQ+E85VpfTUPf+BO3y38CGukIhaymqv/iUj/3zXOz/14r97Vzsy1/mY1/sGvsTXWN/IBf7IurFCla/kuhea92LDyfi7Kb6jOgnNMMz+QzfsioDBWLVZuSLguzjApq1/vXY5FT/K5opa6+CrPUfesLDdKgDUGYJh6GgfIAx55fZIX6k8pAr/v9RsSZoKvwJhcvVbxTArlL0N69VdHcYri4aaFH52C17kDto5b4UavaQM8HB0am2BXTdm8eWJt+eS76jM/mWXPLrO5OP5pJvyCcz5v4i8EAtOJhUt2FOyB0+HWb1oPpLggFDobIr18Y9K09luyaNCjw1TfWXUaJ+2fj6vzIKoy48HcBc0XED+zJueNqAG37lqYypXsoz1aOmk+v+PJ/hf3Zhy9/OZ/j9LhlezGf45VUZ1JwR2bA1KWDAyC5Oz3t/hnk3kquBWQkufRbYuxc4E9b9nrCNoa85WjTDU/kMT+czaL2P5ur91WyYns2VOtdR6Ndzo+vXskKOmYJOZtJdfi75ho46F7MqP/qYH7A78pEdA3Zv+1gIcuwatbHrU4VrD9Zff/Xj/DeuVfRzQtM2SITIjjMMykArKPMfFcAPhQx+PQ0ssHOPvOreNpg+lXUf6Khb7YsKPMZR6G7m0+pvdR3jN4VhbtgapRty1WtM14QLJyqINTIRYptMOpsWsT9BKXknw0wBvh4eqHRI0AOBX9mkIN0g7i2LE9Y8VX/jHY58kTWOpUhwIde0JSsGSsTe8pcXwqizX5jsMzwVFFRWay3el8IizCclpHHRzS6uyMFm/ZZGGjIKFh/gEHtVMnC/5BFc9mvrFQNO/slv+OB2frqPDEV4G5fTkM5bnZ/gBI77w1/8dd5LY3kJ/P6eaN8jKMILr7TBSBsEsNwZ6ZH2R9B1y31cgay8FU/FHJ6kGQY42mmSfa6UDYkziYQD81XYCVG3OJE4SKv+PiDdrFrnoiixkIa2gPgcNwyUq3+AvEH5C2QW6f62mZJD9eyoNJDzGQqrT4u5AERuOd9ERQIGgVTgUy6mwGn49PggdBReToE8Ht9Ak+dMoEPTK9nI5woGgvpHHnv0yaD68mMC9o8kxfCRDfxV7sIF8zDakcOEshl2/oT90v5O8JBwMTA3rbJzB0LQABag8oPCjtNmdRSIGQvnWSLQs4Cnu5G6iL59u9rS1uNG/SOiv9prDukRGli9Wf2dJxk4LDhhsyu6WvzM+oQSDoZU+PuWXEqig6ypQ+4eDv2x5kmYOQuauYgdKBmMtf+lq0xRSirmZnHew3UwA/bCyKK8TGUqqzoxUCPgtMCgpxUsgvtYrRh9e9q/bAco8mrFKpVAgXWqYzZcD87Rudyg7pQKjImGZf0Su7YmC327HpmX0hL8GzgKzGXO2I1UEQVf4YwdVqmxiXqpD6fb+hVunh37WJE3wpX+fnDajnKl8c1yTHUGZz9FALKFUKgHSgwcoJzm4BYq0WBT41jvQCXXYH3L2x58EO/EbaV1dpA2uTsBPYISEUdb5QioQFusoRrO6EAw/w1S/YZ4wWsKSlh3yWc+ahzqoZrTBJhlW2IQ0HHkLlIfsxAXUDEuJ5OoKpKqqE+ruqBVyYd/MnBG1cddit1hVYEGGMU3c0397J5W2lEVWpp1HLmZOE+JPSVRyJyGD38spYZE57KxL+iyFx2THdqw7zCN0Bj0LuR1JAVir8m8ofeufV82f/VvrPvGdSyHwmHZiQ4LCiuKwiKVBXEFGnTINAqeRyGVlRrRahTSINQlg35Xt4U24LTW2eL0+qtIPVyjztXQH+u8VhDZqoML4ui/m09k/oke6ph/0ohjs/mH+foaMw4aCP2UU3gom3LUWIUj/wICJZt0/qxz0tFWXvk0s/zaTzB/3nWCYcC6TDD/TSeYp8Kw4HFN+TWMYhmN6RmzvsY/TAaNsXzBOoarrQpRChShOaAGXan+d10u8TSBy0ghIELj1f/RirehX0VxCvlV0EeSsN9DM7ucFjQaExwy12sidKv4qTTxKwwU4UcEWQ0nPLLpAxvzWKx+XOgk0vtuZbDbSULnNXRWQ/dSIDWnjOSm+hfT0l6IeqlXmHiveQBKBpX8s2nivhRMMbeqH9VRya9VPhlqC4+yi7shAimfLOkxkASnpR2Wlg03BW0W4DFDteUGLF8vTJDva8xBnFGPoAqA/tVo6xlui7vvq9StldRX/dATGgPdBahwnn8Y0FzWn1idAE7WR2JGsjwvujwuRpUpwszIq4evhn34OdeUzmptNirjFNOVU9WMoKCtt816wYOkOHwJuLywD6dq3ddCj2OT/BJD0aNQQJbr3g+HgTyJNWxZZ3aL3dY0BFSoZgQhZGUfO0sN299ir+mmp7s8Bj0AFlTrEZ3vd1CEFZUGqswFGI4FXwZcLQLqDnDNNHx32ypHVbC4KVDfXkPsFDGeCiwvUNeE+BL2jYoPg6smvunWMIupimFWZg8yUFFKUJ9UUX1JmK/AwNdHG3q8XMCgW2nF2xiDjkG6Q8F7PHTwgTwCYK9C1q9QJApgcU1IYlkLqCjv55/qP4gE6gLEyx1AcOsU8bRqI6/hC1uXuHuUY/D7dNgUbmtWP/aYbsQNlGQiarHn/TpV//GiiOWcW69FqiORjRQoreqHoi5ei6o4AVyz2Vb7K15LOSjtQvJyzgCRcECjnCj8n9cQha9q5f+/n2pb+TNOspU/Am0r/4PdVv71B84sv4pF/4Nh+AiZndx1Hgg8bJGdCljcCyJ4qCG1ovGGW0Sc0YzG5UBoWPPXNP8wIiR/TfCtOYzkKP9iGCadijNv/MVluNc639aLD6WRfqGdszwP64/q/9EpUHfFJdmt25hiBx22zgWsLiDm+U8XA0ewJnZrgYji6l8Ixou6FSjpxCfjklQDwOz2l0ppNILgX+kQAWqx2cmrfMr/2YTxK+yPyffnUbCd70ce/PChbJbQDQOD9pKHXxUUfweAYFYIruVOKNeiS1jSip8jI+lPUUHwcPBSq7RsC/paunA6lXQdY9xgQYmKYgI1Qt5oWSDc1x6BRbkR5BMnEgdp1b/PoSvOoUtXMR9REv5KGBYvYPyp/q1QffbLW+qOyC0bjbxsZws8YCTGMDNjHcyS9DRSEKyqD1sxxa3aQaQlfY0bjE3sxGqrhTJ+k6LzSEgRnCizxUJH+OxF1mQ2RvtlmUPi1RsS9xqJ8eqlAhZs5RSkd6tTMOxjXya9lWGtgq9jEL4qsfHXHWKjmBcbxQ6x8QUsLHW1JxLCS0ldjUHpxGit/g1qdVITRfMLWqN95Fglvmg0E3UiOIBltiWcourforJrSSSPLx3geXwVPb5u9ap8UfSFNmJqCOPq0JWBaznIThopPSRH6FSAIRJCR6hVusPE6w4r19IdoquvjlAf7SCUyRPKdBAqj8KPofAnKtRzLBitRqnxKM2fjiTXPB3R3v+UKYasHsJffqtX0oGtw8rGsriyiS4CJ7Qsoa+YgIWBat1QmPYwEqFLYhc6HqxjquzEekpK+YU1VzWqCqFsYVrE9eQEKntdPu7Q1eMELx7rRtaBBbVrlRtlkXC9KtjKVIJ297dF2dpLlervwKcEmMDPKH54CYjzkSZremTdpyIggilg5N52QJ36wI3qr6DL0AUQlfInBPeDvkZGlM6awzqHVqmg0jyCg2WarkhUiVTUIRfpkIt1yBW8cCUDYQ0x2GymqnIIdWdT/tswrKw1Pw2vnp9G7/Pz0899y8WfleH46Lta8y0reeBUbSwsaNV22dnw2V6di8tU9pOZVliAOhgzRUXms59FxYw+diZkOitXH3tXNh1DPSWP1ZZ0aSzT8mhrWv4yZM2m5XcguMa0fFPgRLIOLKdZvz8FK8NfH2jUo7chWJFDeBHQLCgYg/jfZLuZ8h+HYc9aGKxeE4NPKgYVZyXFWaw4S7qgqgfmvV1RpTP/l6M6K3amKJnIHIufUmstn0PY/7MaYf+xO8Jeu1np8Q419mhejT3aocZevsqsBHG8XL/nPilWqP6Hd72Gc9MT73rFc5OSMi9I0SsnSJ8KCxCIhY4JKhJxCPat8T5Jj30KVPTK0dZXMEoUIUey00iWmCIkgphITbSgru8wFFTqjLYmujLpUd870Z/yPWEhL9Zf/ZlbGmWnbhRhejSteeBYfjpGxcJFvm6ofDrrBsqyOfi14bWnPoW89q7Xktf+078yXvuKf1G8ZhWxOKBcjddFj9fpoP6T4EOYkj8KrvwqRG+u/1SXyPJ27jazYqgrzIbM4SGzjOUG2agefSjwqqB8WCB39h/IzIkU8g9v8fqMN6AK4YQ5OyosVLiG8s/bUu8Fcz66EJ7vu1A472afD/DmregVrLL9fbs8DvTh+vB9TOTh5vKH6wNvo7jxYZCc+O+mkTSp39sko3q2iJcGbKCxwh1KewXQtCxrvlNyp6q8bCsOZOJkpPARUJ88kUgF/lmu/wDKYjvF1uVnbL+AUay/GAjhb/AD1w5k3ioOanDYsq5+4ZY+QHUeFPx+W2U2oOr+AgjEaQAhloQBTsAwHeA0inWL785H+uXTRGkJtIX5ZChV20pZgeDUAnhQzRPrwev6ghwgEB8VwcAH0IscBKy+qt+Lk5BeHPcBbdzrAjo/xBEF7uqy5UMjrlzbaYB90fkKOp3rqTRc1rMotXKMYQhIqoesUmmqEEjn2H32GSqpj4wEbVXHhfHXBddx7x/x96WGuLcg6jLGRxUjBH1Fae16hcoNCDFEam1AytMFTkGc9JP6gc1+ztt3AsdIYL+K0Lt87FH995Ej9WHqWeaLEscWn3j7j7d659MTqtW/9hxyGKqROTWSgnvf++Sx8Pyx8EkGas+J9x678B/e8eOM0j/5klMj7HzNuZtGXD1/cYEGUXHW2nlk/KrkJmQcPjVi10PnUcBPSIN8fDliNyglNtZnuFU7XJ+Fsymji36+VQ9BG3ZEuLUuFMaWQJCDV2dGqQjkblGkwLuVesHvTJgMT6kB9pRp3bPPykz6zH5FyIoQxkVFxgBtpdaHtIpC5xJVqep6/MDhZ18y358O+GD92fe8hClC9DOeFWjgmbSjSLWjiEHW6io+ScAn/RTLozv5UaF8UtSXWq8Cz4effUYrVxyAqYAuBQo8VKXB6hWI/ByEzx959uudl55/VmB/yaRj3/8eIE7/AzlvSknPyioAQraXMjPAoU0PpfxzlneQOjcNP2QtGTzJPCb6HhpcVRRH7hs5i44q2wLl94+8BV9pGgMrj9UNp1T6Qs9tR6jKICEWh4a2Hp5i3GhWGZv81+/JixlM6JoqXYccQQ0yMVFVA+Y6F4M3oGiysQJbQgSGh0TUQ3HIYCvDilnhI315I+3L1YOa8hWhmtBVw5RslQ4F1JKTKBwsiYgECwxRP2jfL7RPxf63iKizOrNb0xViMvmGcFfNKJjaCBrgMt2pRxvOcFagE1NsHtXgA1r/HiqNKNJRR7UlQT5PTncr1ItZgB35sNgZ7RlVlBDYgbOKjw+CoY7AGNuizVvjszlSCDLVTZxbEbf0IP+zJT9E+hlwHqN9gL8POIoFR5s5Qar11ZW0zPm2TzyWVqMA+TlwAWJzUKcMlM6KIn8l4oIjHFBo+8Fv/V3ylQknNpWGzFl9nNMJcsy8Q4ikRER0Kq1japTJMj/HrJ7dciFh3r7XZubZeI2ZZ+ia004ftwZ5Sf1ird5vKwytcAfVVLjkpN1bFOXSc1GQrZZdKi8cSdCx7+8QZYap02MHuY0sn6SoGnlQ1jvieTm+NWPhC4xEU+6coAS3jIBBRoCr4LFzzKLs/sKX8P3nPBFMbiIlo3OolPfRMDH8snNcVwptemnt+ZMRKYJJYRVveAaoqWCMtiFZ+6lM8iwwLjxaymPO1YcaSuDIWBZLWg0kvhDfcAT4XO1b8sXTASr52nV5VpUpLBenDISqSjSQb1iZSQdUDmyeuisYUH7gk0mHltOAvQHQ0m35ZuTYUcQGSoETb+s2EiCz6/LtSV4h9K0eFxjC4PePXHzsyUDYeB1hTSnsC5OrSz5eB4nGPpmLrbZin87FDjeysURARR+EjxfNsQ6ifhlEGEDd4cjVkXR8bfYvcLE6G1XrgOp1uOwkEwEvW5GvNbNE/VEYBCYsr7ka1gTGZr1wclWa5zGMQUG2a1zJZtpyYsXj2E3kiYJ/bjX4KHu6nfdQaQNi1OFCcQjEVr0nUU9W792rPg4LdWP1a7msHQFKilOFvwh10g+t0UHD40c6iUlXxoUCUvE3ZtcpHHVyizgHyr0egge851w7KCghojJSUanzN4exMfQEA619B7OiSWaJ1d6LpGL+DZFs1bQ1nlEsg16Hph1oCUFOHeB6dS3uMwJqQTU2xJw/XS+LajAFSyNaz0zxDAcEQaqsMOi+yXXqAW83Z1B+QnqSSl2TvOpOubr1qA49ZegnaUBqpJirn6D1GnBScD2MPyH0WKRiVOYWmGg137nYoV22HVnz66XJnLBd79tTOgkKQEM0cbM2oXV3J/s4Vz3uaMKu1pEvX9bBI1sfK0oqII+d8f2FKoVI/UgI7gyVgC6R3VYq+xMQ5AORP+4Yq8dnyi8aU3jEuCdeCOtACn40Ncde9v+Cd7QmzZeDzwZxENZ/F95hC/Uyx4RPpNGXfvsym9fueZJtbSl6/YhaMOkMCc8/DFBx+ZbchE7Btw1g1iuSTBsQkDjXeu8TVHj8xzXFRdZDLvreJzxM8TuohMn7cc1IIQJkzrMfBlYwuuR2uchNfaE0fQv7ebBSgXN44FmjJvWPkMnqfRzDCQhr8FECcTWnRkCE8P9ydxSAjePI2JKdNC4uw4PiY2a+rps2e8zMzJwu75aWGZvd3/bI8eIx87UpHDMzMzNf2/zMKLGdXo756oIsGI1mRpoZjaJ6FsB4AGfFL9tXmgEwhAjuEAISwC9pUBiv9MVYHNCU1yje4Tv/sUt8kMoMDyObPEqdx00t+s1jLQ2Zg/6Ya8Wj33auia5tIDb5rrvP3PTo1ywnQ79tq+xsqtM29S41womDOuRWHPBt5OuUY5tBeN3s+OOGHHvtQ+WOGUqaBbFBG8Wg9O3U8WhrZGJkepYnKdv0NYiEesED74QbwoVhnTC8iAEMJQeG9aMwmORt19Wzs4NllfUHy61Xt6ZtBrJQWgAiCTSCSnq5INCgSHihZvhbWr6W5XlbllPLemjJDez6wCLFB6CgwgPwUl4AL0kAdQAAh+I+OKhb53xMgV2hAetem8nxEOxPYt7PY53yC1inGS6WLd8+6cOyge/818FSN0g07m3gOxVxEo3A/q5obFpf83SfNuTPPYnGVQuL384VDS8X+cOAP2HD37LC17I8b0vJ2VpoWdBL0PkvEHRu9B4AFg5u8wTso7yy/ZEcAAc0Qoa/ZYWvZXnelnIANdAy+NvNVDj/AQec5CBEIGkGoA9Iwx8Z+dFx+WPuMuoqjCvbA1NSZgC3tHRsohKq3s6ZW1T6naLt2CAyXyIcyBBm4IKgJIUFR02MC9dYHIpnYx2LShaVMVl+gHO/0dF3xpwGzZTSBIVlOepXEcksNwfK0UhFiSXrNiPhAPLpNCAs9MqgCKbPT12Ff946DIjk8En5BXxSjJ8/03CIQQG44DhJH/n0vMvCGRaqfKyJrY/JjCAAI4CMEeewjWcNXraDA8UFSZCMpJkPXgPAc+2JHQ/BAUucFVEgESYoBBb7ad9VrNU8ecJ2DhQHc8ASzpABaCNL+D9gDKz3GFB0zTB2vSV8UildEodjdHv8QvxzwWy+12+Htmr4VWabT2W25FWZckVTMUz8txwwLi7u8WZurNR1tPGUGgWtvAl5DqBI6REzKuWSCBb1t53L0+ygjAHd9gk7oAhJRI9jMkcw+TiQitU8/uBh2z/9erkTe/e8DWa98fphrTZViNX2XHXwq/++c5gTe/zY9sG2sn7KdmIrvyotKyubaNmQ3vVA/Lodsu1IgHxSMnBT6SB2jQfvlmSWQwU9GezQRAwiGmaEfJvfHDzVYk43axrYN6IZzMK3HGSvu82PzAgIDTLzow49/CjqSQfkxU4C1tzwNq4DXh9mEJjjlYSSxDER6O5HJ3M0p9sELkOLBf3vBfjfQE9j9m0fcEb7QSm7ux/kP7btjNa3v1nd4sRuu+ralgs+iAyzoUn3J0p34R40rBXWZfud17B33aLW7o8wH06+gbKBXwqRX3eSNlKV/ZH0aIYO1b8yQRBBefYDeGfkfuL+EkVVYZZId0eBmVmZLsG5cHUIpJFEsxvl0qfIHfT8sH6Tmc3c1FWym3baaH8wlwQnkEwzG5ByM1Mn0l2gnvbM4sdsTzmS29aM8wHMs6H0ZrzBgjClIaqPv3Fae56a4rqNh3oebDqT+Kreb4iY6lA8PAEoIGj8g0sADNtnr+xT5eDaEFGi946JqLiY0iH/rIL5Mh1AongNYUsbDzNAE8KkLc328+9sM/C7A5ADYonu8KroK61r4Tk38iAvaG9Os9MuqxTTBJ+S8iiAs94vTI7JklLdnTM5ZaIoixN37v8lShkt0bD9eYMZss0CXLxh5bVpfRcs6QMTqLCXAVyGWdgu6JgojGERREkMQ70L7xj7UEFzp+Wg/MF7bL9hL/b5uAMMqhfYvUtO2OlOy3ZQBAuvGDvv37fH77MObTQTa+76iEXyB/n8m/81NTU9bTWSfL6eyTfDKJdhlEvbgaF52COWwHfnw427tDfLHdu2jbSfz9o/gM+SOcizYy7cp2/sUeLZr2J/CAnYf8K9zwKoAhsYiFwPE89DP43nhuS58Tvy3ECeGy7PPZRhId56g4/LPu05tNxBjO3Y45c137Nt4hbiv22kNE2pQ8ajAKgVedg/s6JGMunCDoVY5AWO/BxBLrhWZkN9TTa9oKH+sCIVYfoDrK484RLnA5kGngYEAHPlLKK6QpXHoMX0vlDmrY+Oa6e+VFMTUUjQvofVNrhdqi3UJAaMHXfNBPbbJs9aI5pj6tDi3m4kwYMpUBtE+cctW2ixwucXAzfutjBQibpGaMS8TV+ILVtz1w5r6kNXfDlp4g0WcW7V8JPJGslSAYCmT7my6t2mmwDoPU+sv+6U+K0W6hxgqdAAlk6wTiyvXA42S+r+4Q+P6rvfdSmABRXMIDJcF/BHcWx4SOg4SaVKv5LeeJDTFM3x82huRY0ZqtwI7cNAHD9gXLABa8MokQiR1dhvZLTfqBtMNRbY9pueyo3fgDGamoBKN1IlRYSykMZOrk1RwTIoSAqEQykQfhuDh7FNT76z8eBPNyYB1FCR20RagK1kUSSUHVTPw9/N0PnwTffN0FnFiXOX/voooJ4TK1M+XvMaoDmOGgS4U9XkCoY/5G6iA+yKT4nhCbTAwcr9RTWafjE1hVP8Hn3619jeuYoS25HgYQ1oBZX9EVgqVt3dAFfARGBZiStw9y1oO5GO/5GP7Z8p2ZcbK22Ttayiu1dVPNj90X/jJgdSXgMEpFt6PWV+Y4edFFDWhmVglyM1pTSPPGI6a3jqQPTE+ZczLrl6soXWk82fDJ1+KSZH3T4p3ZJ6AJMfbkfMhCQFQEbJoLbxmKoyuG8446/L679vNZXof0djcMr/CCVLQhZ98KmbFxMJWXTpa7d/zuCmZEguuiTRBUmVdhTx6EZXcPci3d0Al5UX05Yb3e5Wn0CxjNbvVsTwVV6zfO2rqSUAGrddJJC7EDqeOpR1gDByz1LFizfV0yOMJrr8/xslmNrh4hutBH1wZX31xkeBZIu6oDXZPlebvCpQvVkqsciEOVM1rzW1VcLUGiMcS7l8EiC5elX//ba6JVE1/+L1hy1KNJp6Qv7/Dr1xsdAaF8nOEF3aqRBwSRISE3tHUNxw8LKBXjRVM+SThNmbpIsmURw1KJ6s59FBo0GRhQQ/+XT8P4G8V+wAusLYAfYOSngpSSLHuIHmxg1GClbdKgvcsAG0Gol9sziow4Ejq2UVoUAaNKZMwujdQMGpkKZAARQhhhxLZZBAgqmmAIOpUZSAU5RAc6MEozG6p4AuPkWAFMV3grs94q2ALVmXvm6N8xnD6ctqcmIuSqU1Y9V3Rc/zIaHGxXcsncKlQup47qkedgipiKtv70hDkqSP7AZ09nQEnpH9aRUnDM+ZyFCy76YbPV666/Q22KdlvRVa28cIOTdyz3pLH9kzuWY2w4yeSRtI04vidzB3URDtLjVzdPgGk0Obl3BGwhKIwhgbveO4rT7c7p1ytEFyBNKh5YCe2EPLW6tP3eYk8GE+Pv2R26Mtt4AfFdvwhbWuOO2gMpzljS2t4NmclILkMOmTQW4SVJlrpwgtuUywpO1HWWSvGJOLAlLGCENG6fn4arwl/XwGC636c/18txsU8kqww8jld3Mzfr/Pm+OArVesJUG1CSaffB6cE8v6aHJvAAAITql8fp0Ty3pypDndlbmBFCX7gZ0CvfdOAZc7BZoro7q3U/ALHFXE+vd2VDUnSaPk3+O5a708d/5rPXeNPHdWyP7KBEEE1T+SIhHm7hSwnJ0CZrzFdVwR8YfBXPNmmpapoqL86bjsAqo2HR4OZS6owJKwULHESJqFovBYOjEfgj9Y3OQufMeaRUL1vxZXmyXeyhgARFbKCXccOHcuf7ziYtAEKyNqnpKioUJZGVGQecf6AfKVpBebIpkbDZrMMrd/RLM0562EFJHelJMZzH0N574a3utxRczIPxQ3F9AXKj6Qq7q5gLpQ8IHczBCU3CEA3/LXzkMK35CGUuM8dcr8ddjKCEOc/IQjOhvEdeK57TbAYAaynBie9GUXCi2CYTsRwv3nAP7BsEchvmmurBnGrU8oqjwPbDz0f86sGup2Iggvbi39Gdy9wt1dGjRnbnY22fNWwuzm5gano6Wmp6IvkL6ggxbvz4EG695ONs/1l2s78n2jV38858Vv8ILuq58fPPQTzBf/fPrDZenP9fz/g3/QbVd+fNN791301uV3Xfvlp/d99/1f73120bCeP79P5Z4g48ZRAgoacoxAyG5WMNgduQQ44SxWTIDlGiIYRl/MZ8oqR0eMoRV5Bl8kBezAYcTcYxavBdYhd3QPFHkB3RAzZhsDRAaE5NEVJJhs0HFaMNJhYQyU1BvEwRbkRGzLcUttjqxqKEJx2LpwBpCsNm4s0EEvB2NdJl4jOpxz9TQFaC9xGZqIpSTpGJhoCluUSsG2UC0YBlz0ntw9kHBLQuwBO7RB3buAHSaoxb55ibdYMnaSQGwPJAERv5Vw7cHKKwS2AGsacq82qBtkxrkJNDWOQrcIk22blNmGTl1z613lxhzd9b7QCWLqkQewvjCne+rp/td4JPXuiJoxj0yHyu3HlKGPThfyrs83Sxi0G2IqNmuJtTWGGDZzrevSFASD0jUxv7OmKlOzITCjc0Al7XmSQSvFeZKip8y2vRmm3rZ9gSlxpgWXsa0dGgt1j6mgBKrJu1IymFAIOU4BbIBbTIi30K6lQZwS+Kjp6Py7CAULTV5mhyzLHqhWat90lLP1dP2jz7346LPN8y++8OJrL77w9KM3gEHrSKvjBkmjVE8rYNQglFSHz1lvs2R9x+3Ln+gVPP+Iqi1qiDnyWYQNk809eEpJxuPKa9KVqtSgiaZhDB3tDyHNKZPfYwzV+horTTwWrviCytblRdVSyDLdY1063NkEmGF9PrFpGQAKcewkKh95lm0EtYVxgBxBtdGNPoACw9EfwbASDFOdq2NKrGAiGcp086ktQtR0Oj2jthawLuWp7dY9TRC3hzd4UQw9JqoPjzyhSGFtqs+CdfdxfTKrpA79RuONL1SdyowhyQqZMSzjXkfM40FG7QIsijVqADAmYXcTFgrSoAgDB7sJBWlYDOISdtdKSi9h0CjdWJSzzNKNwIIJuJQJM4CBxeVf7w7P/f5mn2LmnTjnMOebPPLPSDM6HPKr63yKLtaRo3Ynj/JX5fvo3/SggURB7/p/Egd+G9AjnaCJTx61Ocxf6s+2z0pqSQrxf6OPlkYfEI0+sWIIHm4SkwXToGtkyn/M9gEuxq/9Z/6HbTsjzHcNEiWw2ldWqB8ET/O+gdDorzJ/0HXdM4J5cMOalY9+YoKre8RFTAh2YwshOcR7IZKwlP3PPAbiJtsWnDvbQjjr57TEH1ohcB3Ev8t5ZSxuIVrssqO73d/igrM04ufP3bQubCZ42mtDHJZMZAtmIs5YWuxr00zUuu/dqfBijiBv3td/PdnTU3FiM6ExxbXv8+ZWQfwcxHc6GO1N5BKMUAPP8vuSgvVjEWfeCW/bwSWCmWXN+0xXCZyJuGRHQef7JuKFbG6Y+KXVAmcgfqN9jpl3EwHZT3PmVs8bm+sgfv7pr01rm4izrw6sWWk2X5C/JOJ3HIruVDYSEw3f2eNZEnR90PzT0izsGon+ZFeVcgkJuj5fkPwzf/hOaiRszSYNlyavFqzPQZx1qnNlXAMxfcKXq6TjVIHHIt7wKHSVTgNxTe5LdN76fnxMzkRcx8p5Yf5TwgsLS5MxnkbXB3FGa01Gfz2xMsszMne1LF0fxPtlXISl64mZI2Cop7CArg/iHD1HKYs6Yol99ZOgAim6LxCPDa8YCqwlVN1j7PUuSI/NeZ+R+sid9iyuIQJzfZWydRcJnIM4h6lb9bmasGXVwWHdAkywTcSzOyXwFdXEx6LtrUf8VrHH5EzE9b9Emu2vIrqaiya+bJSh+w/xBsmjsdcqCdGfr68R7NH6Ic6bOd47rYIw2X3gJOv1GF0S3f6idzOelRO2nQ/i/uqeSR9/aH2SjiuOlBEb9WfGbIkWH5vzBpH873b1rC4jAs2FWb7tkgLnIM6scZLdV0pg59VsiqYu0BqTxyLOEpf8faKE0DCU3ud5foAe3xDvl/i+/2YxIVJ6YoGi/0q6vogzFFpkcouIW3GzFsYz5cfmOuj+Gy5ffc4hvpi/v3HLQUxrTC6JOO+1UlAvQQyqxFkYnllF1xdxIVl+fxQSGL9R1qnKaI3JeQPI8WseaGiFE5MLrU2Mpy6j6484b7eGc3ABUZlq/l5t4yqtMXks4rFKz7aV5BH2BxX2rb08Z2zORJzR49PUn0O8OqVSteH2arr+iEtOBuEljwljq3Ib8/ESWmNyHTT+Jbeeb3pIvJnzo/aV1bqxuSTizDhy/dH7hGhc4Fmry3Pp+qM+i6MolkUEBax3izaVG5vz+hFfdKJtcxqx9/iznouuS8fmHMQ5yt9MTicR5N1B1e2/17HH5LGo/53vFR1HpP69+mvu+K/YmJyJuND56RGuMUS36NXLq5lr2WNyBppfi/CS/NvExsSfIYb+a+j+Qtf/nZ3MCSQiE7nfLou/wcfkkqjPdJThXSO6dV5Ng85F7DG5EO3/w29MzqEQ9z4zbyYT3stGhTlWzKTrgzgzxOSgJAuahjonm7eOXl+h61etWbXrDqhONVMuiJWh40Nc55235aZYOPB8wIIzaxx9fJDI+vLNmbbxsGaYfebU/HX0/hHnxMxNDU2GK6vNGm5eoPPXQb2t7lRNOgivebFj0H4xXT/UJ3OUPmbCJc0qPe1Z0wXO60P6e3uj5u37EBE97aCl8uj5EXFeY9JX9kN4rvs6waqS7j8G4rG395l9eAziyyyxyQ50/DqIcz6KcYVyQbkvKsVfvBcTzERcx9TSSiUfXu1ga1jMWkHXpxeJL8O/8q8n0GM/JMtkzaHjQ1wHH2dyAwduull54/bR60PEJcXcNlYUAm/b2yx7jhwdH+K81xuD3hMwLHZX75nq6PiOurRrwIIiGBSWqz9PSdH9/wk5f624KptaBKph6lsDkuj6xCLO9Jxq01gMdx9dr3GKmiBwJuKsedm/j5aA98k9K5IVyjFBfIhnq7hpBZXC+Zxhwwtu9Pguifrd7h7pMqi44tDzXoXOn/fxX5/pV6hrXA7n5bF1vk9Hr58QP37Gd3Z/OXRIRfb4zxr9/yOuv9XD37sCJm0JOj7TdvT+A3GhjZ+yCiuhcd2HVEMtYbq+qA+1mplVwbGRWJM1g8L0+Is4zwfrC6kGB6mD+ltO0uML7wNy/WNu/EKpBlI70nX91aYKnIM4T1Pdq6EGcmYbmpbukaPjR3xmf/mvY7XQJHur7GTvAC6IH3FWc7bW/TpQy543JDMiQ8ePrv9uZPqBelD8sokhPbsYE9QfcaG27oyv9TAr4MnReVLVuGAe4tkPnZaGPQXFN1Ore2uW0PV//6+b7GOon2iAIN2++a8jv9PjO+IMGzu50gb48BGb77tQmj5+EH//5/hshKX9CYenS9H9x0D8e3qNhWMjXJ+fMFQXPnr9ibi92eEwohFy2TsM+hJHz6+I50133ja3CT4WbC9o9xITOO8dUr/Wy/2FTfBlov7un5EydH6IM7gdA3O5kIdJcS920v/fWMRnFp61c+RC5bmB7DqXWXR+iCuqnNtfzAUL9uQcQ82FdH8j/r5lxaNFzRDFY/Wu7xah80O88kSx/4lmOPPMTrReWoEeH9HtL4jmVTVD/AuxJd6S8nT/Ix6rLpy5vAVMK45cP14oT+f/Fjk+Kw8MXWoBSseS7MuQoPNHnGH6ht3SAq1H40VkpoixBa9Z7XQEqM5/Nf7nucJZQkMzGg8fmspm//PxzhvADAUvdYJkFzz981poQUO83Z+3MnRSm0e/jlhZKvhg4vGXqf98Q1Grv73pz2cV7hq6EbznRvBfz4suxI3FepoRmJrKrxStbxRYtr6InMM4gdswz2mH91LQaOs186IVC/e45vJ+XhcFc77Zqe1v8sNOe8zjZr+k4GfAjxXMel+8/VvbWscGCmwq39roDjGwyogzC7dVUBDGVTHvjmNhbp/Lq7ULKXC+5GaZGH4bm+H9w8nkMQW/qeHgxY8DsKEdJ2WD0/n7i1Q4rlWojd1r5Cr3xlEwxYXlrTrhL3wJ9+8s2wgKprMVZPYfvIkbmM9uGBdCgdFHXT+KqY/XKjlx2D4UzP/Skr+iKgjnyaVkhrtSkGVk8aGLy8QMAhIq71ykYGdIwsd5S5j4JYMrWN5JCrSU2436JQLxj/5+6j/+ooA4MAf8vH2xMzXHPpkfpmD1p1lnI1/ewpstJrrzzClgKGhoD/WGY6n59kpehhREqXvWuL4LxJe9/L1cfx8F/iWJWzcd88Ge+R26obmdgisTu7MnXWRit1qvBO0CCkKTk7uGA25h6ofOuFxU5/vO04MLrbwwSHygV69EweA7iTuyO5hY2+XOo9tkKbASOQGX8m7h1w9/7XizkgKlNFHnjiFXrKNd4muUOL/+xLHFEVJaOOvlq4ZrCyl4JDb1pOsGX2zKhO5Ej9kUBNbUewfPdcEOKminZE2lICcte9+ZfW7YvFwlsb8nU7D3dHrnuM2emNKLvb+Pj6Ng93eu5ca2QGxk/pEHIr9JmGgeoMmM88QHYoKty76RYK+/p7ZvdzBek6KxIWmAhAA5gyXfhcNw2xeTnDN7SWhaH6r9vvEEPhTTo/r6HQnzltQ/XLQoDO9JnlMi10WC816ZpJ0xHthy1dl7E9tJ8HFYc5ExOwRfykyfuO0VCebeC3YGJpngMvJDUmLPSFgSvssuYt1l/Hay/suvjSTMSi9m9B3egsl52zBE6kmgjkzWFLW9hRkLLevbVE3ChQl3X3XUumANWNHje+UkKM6eAQEjIVg793m/TAkJ2VkXn9SzzmLSMutbXhEknOMZfmIvC8GmtQ2HPcD5+cSdEFINDcST1kWdfZBPwq64kNbadi98s+3Te69ySLBWn8Eubz+Pu+pFHZR9RMI3i0u922d74jOCLavj7/PXfz68cJJaCPZK+vH6HVkkTIrwUci9cwkbrrjdPDuDBFHDpZ0dh1nYWsOdbcJpJHwsX6TvUaGK5W439VmdQoIa54jsW+VQbKdUxrxjSSTEnA2z2d3th4u2ns3vSCAheR+lWabih3sYaWRfjSch84Os9/kD7rhkSa3q9jgSTEwOnm+rD8FXLTdyVb9HwpFFV5mpM42xUyl7m43ukrBmuRVBPQzB6zSv2UbHkuCar+qVMfsvnHg15cxs/jSZ4pxH2R3GFRYfxR7EkGBwg2eo1crE3UMNflzhTz/VNrt6ROI8ftq69/0Z/nT2FV/ObtITP309YWc4f9rnrZG48iJPvMpu88FP/Glus6hVTSQLA8t2PQf+9pcl7MtvVb6Ee437dGouPx5Hjp3hcG8oplykOK6PP23k9Cyt49NR7JDu0/Wf+fFvfvpQoezuDXz2Ym1DaX6+qhs0B3IcQvA59XvDvPn1EB9ZpOFuxcQzKlZsX8yvl4vxyRf6zaF4X/DWiJfJJAj5TDe3y2BhYbY+LytSSXj0sb9IIdcfex0rs7knnYSRd2WRjJyjuN/Wx/OVs0jYav3Z1O3bJWz9uXlhmfdJcNMST5IQDcHLR4KmmD8iYa24k29eiiXeU1aXvSGXBNN81uUfK5zwGfsra7YWkJD648vyLVuCcX3d9hhXNgl7AmyfO1V74AXC1ccHOCRI1wfJ/s46gbH641yDSkl4ckqsQ63JGVuxomvR4UoSDi8/tHximRd+tMfykm0tCS1KnV2eS30xFbndvRENJMx7gnMbnwThlqu0H0xoIaFJiYxUqmVhJg8V50S/JOGh2SkXdwd3jBi+YOTYzs83KuB23RtX/OJnLuHI7z8vlZrgc4v9sAyuWVjMexJ+vmzcHXiJhdvm+K8VJkkoyGw9+LLECP81Ty/v3mcSdL4lak2PZ+Eapj3+J3/w6x+Sof7lmT2+w+rX4NkREtR8TBw7ySB89+S7itmTKKhrsxZ7PnIaayrawxKfSkH6neCfv9hBuKj4c/Pi2RQ8nJqlmOlyCovc79EWsYiC0OEYC+WuAOxiw4h1miR/eVPRxkCeO7an0Vh+QJoCu8W66ll1h7HH7yaHOitQYL8o2Gmdox3mwKJaJTdQ0PS41m2hDxP/WWJpNAUoOPZzBCwzAvHL3sK75XZQsCvljHrmNBY+6D1NxEuPgiRhrUSPuNOYV/yv1oUmFMxYriMZHeSK33Grmt/F4O8/uKhF3ywA81B+PeGtAwV7HMelm2q4Y4xH4z5LnaJAQvuRsFSLK24dcUnl9mUKqqbt0MyX8cbX3v06d7snBdwbGoyJOaexb+D7Tp5FwYmTUQa9ZW6Y296KXwbhFPQHcQNnDwXir1jx97LiKbhyekXnnUx/fMAuQG5nFgUikqmb8JIATNrMhlxSQIHyp5SSUFl37HaB4wbZMgpIj0allCM+mM42F/OzDRT0dWl2F2wIwOcWRmYMv6Ygqi5on6b3OewFK/p60TsKvGsZm4omHcAG/oN4qwBvY2e2KaUpMzPjn7dgfK13FWqbMnPrcOIyMzMzY5jKzPYmZWZmZmbu2NH42rq+TPp8PNk5szNnpLif5G16Tq+W+vqncyjHcTwncCKn4tSchtNyOk7PczzPC7zIq3g1r+G1vI7XC5zAC4IgCipBLWgEraAT9CIn8qIgiqJKVIsaUSvqRL2KU/EqQSWqVCq1SqPSqnQqvZpT82pBLapVarVao9aqdWq9htPwGkEjalQatUaj0Wp0Gr2W0/JaQStqVVq1VqPVanVavY7T8TpBJ+pUOrVOo9PqdDq9HiTqobweUuvhNj24mvXR9xnYI9Ro6hbW3a0hzxmNwQMGBAaZ+vG8xmjsHWHqarTzfkyAFn7uEti79y9GCBykMP08CIranwZaL+yPXOFC4Fw9fQaC57t0DzcFpz1gtF5rTN36BXYxWYPD+3aFB4RWp+D4KNTmcHyyaXWIvfp2sz6MpSF04P97oNZyqowIfyudnlCruDmPEWlxWQi1SjpkmHHsy3cYu+Rjw4erlw6qSmbEeYaeUQaSI0JczFC/1eTqqEq7Bz0yk5VdQqf5TW1PGlVqMO/K2JVk+I6988dlu0V2FJq+vvqZ9+R/2QaZ8hS4RjDv0EM3L4W7rzL4uKXcsua/XSC4W0ZNMfI0fUW/bfnaEf9zTU8U/N8IsiX7sB1bx44ghuA1iY9iGpB04e7FNJ+nkc+b3Vv5PtxICuyI27o21kyadOyegRsx357/6rJVCWW+VJEGnyzT7i3kn7Sq44Od/XKRKifjl9aZ7kW0has3GLu7JbkrJU6bXrsOWeKuivIP9SLGhJeZxex9Sbmz2sZD2s0gD3nPmKHnJpNmTz2HdH3Vxp7/jW+Ld2ceDpFG5+hn9ob8yurpH7e8Sk9CknoO1w6pTG5NG14ocR1PvqX0ifOvl59ceXJ20q7uanK2+sf8s5saycXL0WcveHQlSWMKXxrUuQOZ1aThm3XbSxN2/l9b9//ydsv7geHRM/04pd+mO81O7ByvFOjzgdwvv1/ptORE6In4+8rdo+2uxVcPIUXGXDgRNNNMFnTcsnZRKzevIkvG9Wr2roJX+1VF+p9qVd6rcHJcTtPHPCkLIqOK+nzavOv58DaHrfnrrcpw6F7x0srabQldur4NUxr15k37+sxVliZ8nXA7IlZZn6ft9/VNmhP9h8H3+VLLSZVjITlK5TpJ5p/cnty11QNSTzPkeMZ6l0nGyO9fPLuvVxodmH466bja3Pzp6iaPIf/3i+nF1B55lUsFO6T2fFJfMZ4tXPv0+C7Ku2LtjdvCOit3wk8fKXe2NpGe8crjnGPJoiHTfBtGJJP45iXit6/YROpdP5Nj0M6lpBSftUqPewHKqYr7fCu+HG/OvbbOzGnSdsulhjtMYzK6K8NnRKTcShKV5Lq5r8VU8VOadjuu1xjVyveQ1QMmTTCQ7cVHXY5Y3p28j/Q/lmnleFJFOVOnQrHx5MwFqWbHYcGk84Ni98edy6fg+cjZuhH6aaNWR21HQr/bIfSMT+3tNFuxoJeNXlPPZhM9Rtvslyk7rVaZIry32so16qu8Iapv/8y9qd0A9sKTZ9o3YHsfemLW+LjNiOC2pR/s49bWy7zhpuJTet+mhzUqu/t2edEmsGn/hr5udPAAASACVAA1gOU0DsChZa4xVgfQA/7fBVcDUBNgcMFJABlAXHBeAG+AjwvOF+AHqOWCqw2oA/B3wdUF1APUd8E1ADQENHLBNQY0ATR1wTUDNAe0cMG1BLQCtHbBtQG0BbRzwbUHdAB0dMEZAQGAQBdcECAYEPIb33P/1jWOUEAYIBwQATA5sZWJaBvl6PKVJosWWkcRcvSIdeSnNjf1ZyF4Z25AJ0BeAI7OgC6ArrRWNweuO6AHoCflejlwvQF9AH0p18+B6w8YABhIuUFO+m/If8FGTr3w3GoDvJY/s/k36J7YrkfsfGC1pV/Xv2O1pEO1azbrPueULS6h0DarVeYHPbfFhS1+ZONr7L9p47d+OIDWQv0WGmeh91mwLtahebGeheqxUJ0WqstCddjydJ7x1Kbj1tALaNFvt+jHOOrHfrEu9o267HVQH9WB+rBv7BP7wn7R4jxhHN6H/WA+e13Ug/WoDtSLemzxyyLvydRaGCv/Fo99YV7sF+tSHXZd2DfqZvqzMP2htTDzg/dhPuwT+7L3i3WxHtWDetn1ZH8fkEc/xqEf62A/2DfmR31YF+cL58O+nszvt30+mM+Hhfl84DqjDqyHdbBv1ONQF+frrw2914vqVSZKUs9PvvViezc17xvVbtmYb+3N70+YRnpWbSkllQho3b+8r3Tl4Ph8le7IZm3dVp8CqjYx75uY+e2st43NHSa0CNj2zChNGepey6dEU8kzusG19rX8zUcrtMt0WtVRotZM/RiH95mxLtbBvLSeRPVIVCfqQh3SAmOTKUVDO0pX2ngubdmkjZla9JvRop9a9GN+7Afzoy4J66A+nC+cD+wb+8S+sF9q0Y9xOA9YD/NJWBf1YD2qA9cH9Zgt1b2F51/8JWrNjJV+i8e+aF6sg32iDtSFOlE325+Z6Q8t+jEO77Pnw/VFPdgv1sV6OC+ol1lPtOi3W/RjHN6HdXDdsW/Mj/qwLtWHurAv7MfeN+2T/XyYmc8H5kUdWA/roC67HqyL88Xsd/6z8d/qeGFhHOS/0eGhOF/nJv/NvJdWmOt/SUd+po6K0cGRf2f9BaZOHUYH+Yd0FGfq1GfqtGf4xuSfWX/C1Alh6vRg+IC/SUdZJk9Hps5ghh/F8D3I37P+/kyegc51Rsxk+DnIY8Cf1FGRqdPZOQ+ZzdSJJ8w1w88gf279mzrnIZOYPCuZOjsYfivDR/5OHVWd45R+ivM10++I3YzOE0ydQ4yOteR3rf+I1kydBc55AlKZdbnE6LjN1LnC6FB+QYcns/4jneMitzjzpa8489xL5v53TJ1njI4ThF1/PL/gPgbPH7gPwfMD7iPwXIT7IzwP474YzzO4r8HzCO5L8ByJ+0k8v+E+Ds87uO/B8w3uc/AchvsxPI/hvgzPV7jPwvMS7pvcfmHkAwwGFGD8H5P6he1qulUeInrfO5TplNwrwWdRhcZX5a0PzobF7r0td+4Ve9Wv+gN59J38arLhsbz2Y8Gwt/pn8rABDSpWT3ouf2mQ88Ej+YCcS7nRf4pxv/ylb9sdj+P3ypaah4q9q7Bb7qRbVW3NfYvcOnXJ/Ybtt8rtK6ZEr7u+Rs6VumXjpaOLZdQxBDAUMAwQARjuuOyAkYBRlBvtwI0BjAWMo9x4B24CYCJgEuUmO3BTAFMB0yg33YGbAZgJmEW52Q7cHMBcwDzKzXfgFgAWAhZRbrEDtwSwFLCMcssduEhAFCCacjEOXCwgDhBPuQQHLhGQBEim3IqfKJIT3qxI5/yAh2SHNwDj9yBZ4R3Axv+q38NFHg/qd2Pi0e840O/+M/cH+df8GV343X/Dj4LQb/Vl+AV/etYPYyVgFWA1nes1DtxawDrAesptcOA2AjYBNlNuiwO3FbANsJ1yOwAntqfk/7hysVzijBe8lsoepYa8SMm8XB6T29ujzJhIed7gooHbEqLkiP+L2jXmXbQ8OP/q2jcHxcohZbK1OeAdLxceFwivRLnymqid414lyyVtY7WcxzbWyflrrMtXY90GuVahDn1O+m2Ri+/vCa+d8qzy/vBKldO+zz0ot7CNszL77+nB8Ks1o3I+qplb+lDTo0xGw2FDDkPFjYUMWc+XM/gUFAx8dh+DZk4rw8sXPQwTJ0wwXJy41DDFc7tBP+22oYJ/XunokfrSiuRkCT7VcjrrHKe92YDGOtJ0bJPDbOMctffknlAppsdTS9OtJcc+bnIBLfplyEu1Mpb5Pn0nYBfA7IKzABRAigsuFbAbsMeBS0eBPyO+w8jwg2WyDAjC0Pb4z6JtKbsJaZSctD1swEKkSzCmsEkqimJNCbulw6S7naQtDXZN6QZ5vnvv6U+n/8DI/6kAENB7C5PV7gzIifPUQob6hZ3Y1Oby28UwDM8YY7vuJxkNcaRYF6HjPpdnpkasEGhC+KsSU4Of8m3aT+TuT+WzXhSdiw5hkqHElS+HSZy/G0NfK16d1WZDgDZXOrQ5YXUY2d4sembo0jB0nrEXRjFeuRmRLSdwm+FGpa8GwqUyLF2TwjUHfRS/WpEus58P3x6x2KuVbm1Bgtcfp9/1KzPuWyFkeQqVEeZ4DSylJc6VmZmVaHRc4l3MNLZbn0VoykeOXLTnxiQrThk44V81hMwfpggIqFJiLs7j6D/wersD15O5SBcuo9yxAOHPdWwOkOeERyGRU89hcrceaYunROiNYpTgEOq++uSrfebCmgYyfNSYv7iA6a7NXO/ZzqIZOvi1ldB6dBreZ2bhMtebl+59qCh6Iq5rTNKkYgqkr5JQmI+CqSFiWBLos5R3exS5XHwJdRtIfOZNYtR5NM1e8lqvi9vjpDD1GMDuqjy7X8dh693DgXsWSIp/IneFObqvqok6rMXcOaW8Ou7Jlo1zYEYarSJTkK5o5LrqEA7TXbhoYU18/zJ8/aqYbZ+C2ucgPubsoLmwnJ0awljqv0Ci4TWbdBtouBzMs9myyAZ+5u0mU4pL1BB6J0GTTymSuWtpnxaFVNNWlCYuJGCCDQHLh9F5eisJ9/yY/qWN5SuNGef4nNj6Ku5YGeFiXYGIbDjPLyYiENnGNk8/bucHYP3bMY7/8Sd3T25h1+ssFCNt6cgp5dTBZubnOWJWsoSSag1ko5+Rb32KCY89GTl/EhOWXqZwcyH/FJlg+uAsSLbzwjgBuRUfGHw5DrIHmB5axu6KH0zU6+TfVn8efirgUY8sIaNCydujh5LwQ0SXtHNswhXiZnqhlHSdZcH5eKkpI2bmxt6oM7h+moFq6Tn+kliJ4V9v6WgM4nPoed5+PMxF1fMc++6KlZUGGYNjWH4pEcfwnezZa8QpSzWui6eS+UGYU6rz6N6njcqoqYwWG8YqIScUfmxiWewZ9n0aTtaruXT7ROK+fC/XJZo5HRpJ4tkunm5YR6VIGzMvqNO5ypcHtk7U61lhYDmCI0F+mK2XQ9MuF7eqcagtV2Pr7/tZvecFSza6Iyqch3ynM5McXiIjeBXLkWtJ1K3lq0cRR3slWeHqwzSZdM45y1FcFk/CpI2ceevCseogFPauZWR4Np6CobSr7IYBGb7uicYhfwV2TYs5Xx/Abf3zGIcOMjrwJKqGDQRrX6V+90kkUz4h1KiLuOYCtvnfYIt/COPGBzP2cxU7/e9SO7QKrTNj2SzlgU2EONalGTwKSmOcQRbP2kayYr8M35K7qJ2dgcikWILmK2MX4IGwrjpjQiezTieWabfzufv9DtvmT8At3xTFA1fINT/PCP0AhFu6WGBwEjfVi2gnCiI2U5yqgq10BhdSnLCK1SURRGmW8zFGg7jgUOqNnJC2bcDjZDNOJ9YzUKvJnZtxNIqr8itArL8GO1MHvo9KQc5eBQvzHJYN6eDSm8b+7HZkQxqJ81fB4WQXI0vF6ZstQPX7aSx+GI7FlL/RKBdmtdEXJmaHoz4niZbYyayxj+ZZXgSi+mPZ+mc5c3o98DoxkiDJvRRHbmCX+1uav8HllZsorEkh1iEdj8pKng6fxv1WRU5ezKMgwZPA5TV0W96g2L+D+BZl6v+9hP62TJ40uHHm0Qzka5O5PU8H7l4iYUMIyRYjkVNMZJW/LzWCUXjEjsFr800kJshTl6JI34dBgmp/EpQ9yHuPnQjEDKDnv5sj7uIMHh1CVk8Qa0d15KUCMc36+gtPd/nbzZ0wR21Uc7Zy+PVyVBoleKRozDzrRTzeXYFKaSo5OwcJ5xajdr5nS/0NZu1ahs2EZ6RtO8xu6xW4mjdxcf0w1pppMv1lCuqthUx0t8JS5T1HlGKY9qCAm2oaCKWE8/X+CyS6Z/G383tkhjwRG+HPKQNF1pTfYGbERR7eeo6ypQiJvUaMrynFJ/sJl2vziJPMouTWQYRctqFkJokMZvhNauGNYCCTRO04Z3iKo9kN1AzK4zovGa+ghYxq/0lazjWcXNawUj6aNYVbUOzJ5PWWC3Q8CmO06Slm6kQSbmHFJP37+GuFUTZzGHvqA3nckEzOjk5M7cczTNCVk/fieZD7hHVmy5neP4awvQXcFtAl12ARAnVeNC0pY7VcH69K/uFzuyHedg1ctquiOluV8PMFeG56gfO7IlpqJpKu8xtLpZZitt+KZ1mduAcXE69kyRiT70zVM8K68Chyg1/49Kqd2d4l7Dq7CKGmIoZen8Ld5S33BosJEcrD23IfrgkPKHe/it5eL4rHu9BdGYPcH40kPU4nhXW8fTCafelz+eCzg31VxxktrsBBKTF8HUIZJifB9QMeDA5mY76kmWpfDf6tnsiJ9DQKzw+gGi1Dq3sBoUUaVEWbkxidRGXZGCYEKbLLYiEK5kFcrHjHq5lpuG6PRU/+CuOtyhgUXcmbjn5O67rxNlCBLy8OM5AYQ/OPpygteoyytjVas0yYUv0PBwdE6F/pgvLUKjYkHmb1xZNsnF2GvFkducWvEJU+x+TdqTiH2TF/yw701//Ab/xYOpLGM1DaycJMxV/6g8+WZdRv34Hj6csEqzfzWDIV602XeWORybqAYqr0xlG/ZzmKU+u5K3WTWQpL2dz+muoDF7i2MZc1gX2YCwzw4a87BM3WQCthNo4hdZh9juXQfC1KPl1m3ehwLqrfJ+b1GJxHLcf+QQt+x6I49vt5ep9qMCv4IV6HVnKhchYG1+uoW2bGm306OH4z4ufVRra/sMLLMZz0+AOYdd1iwbE5GKabsdldiFnygWgvCyDo3Uc+XHvBin4Dhsy/MHVsCUWbjxPat4DneUWMLaqkdssdlhUFcsTYhlmBuij8Fco466PI/+6Fv8JkjHMmcGz+Gf78LYjowvd8qPWiUCef+R1f6Xb89QPBOdjfXsDikPtkeYsSvq4OmXpbnN/UcylUmmi5MJwqZBH+nojJ9ZmsvlDC7kO2+HrPYWyaGlGdp5lk/olZrUIkXZVnl68pEdLrSOqN41DjK87VWyOhMfxXzesE3LrJ3u9uaJ86wKHUGFzVtrFUZiss/M4zPBnoMGPYZlOa9vgD/B8HdwHX1NrHAfwZIBYxQa+t2MUVbLwe+Q8TrIkdqBiIijE6ZSMMyg1pELFbATsOPKMbBjYgcPFKs43BaDjvs/dT53w/v//pTo7q/0qqlr/XOZn+/67Shm6KNK0tC91Wqew3Ub5SVWcwy8NE5em+v5er6ie3n16WUFWTIV/aBUhU584v/I6nNhqecdMnRtrp0gvf8a03vcOsFZ2Aaiz1f+t/xxeD9ac+KCV2m2ty8P03XPo6a6RFssoC0e5D3/BHLaMlG0OJ0TgXido3PGPN9HEJ9sQi0eX8R1/xzyn3Y7g7iLer71nL/YozZwqf7FlCzLHLWNH5BY+ujLd7NVqVPxp4GP8Fb7HK3nGiUwnoUcDK6+u/YK5h6BvbH8Tvk1Z2tH7GVaKDBfRHYp5wXXHkZ+w24afiaDzxrZSxUzif8ZU9G/T2CIgFG2S1jWX4s119cdRx4hpjk4nhZTiM/7B21kbiq+XBWaZl2G+95hpmPrFozrx/G0txdcrLium6xN3mC85FlOLvVUs3Cts7iD/E2pqVYs7cqpK1P4ijZeGSVgnOvesmNk0hZleMux8rwYGzajL4d4jfH99Rt1GCl/p/mTnkKrH88vrpzSV45N/jJxafI04a67xpYwneNW7l5587iY3Zq9fdK8YH/F+vm/OPKm9cp61WjPu6x5i9MSCWu867Y12EkztMy32HEosiNFjiQiwc3HtIKG0nww/YM8+gEDduGXnr51eVfULG+hTgBWlssXUKseRzYV5tPn5f7rxg5n1ikd5Czvp8rCZJKJoeQiyffMr1UR6e5OGfddCZ2Nj89DmtPFy7/LlF8SFi8foHBva5mPNla7T7BlU++rXwWw6eWcAUWxkR845R76kcbKF929l1HLH1irjYu9lYtNJ0RS6L+Na7XYtGZmOz7ohP25oVpPuZLhcds3Dp4/FqI76qnC70rMzE8wfePepJJUZlloYbMvHTiVoekx6r7EcHJmVg4zejrR3CVLawi5mYgZW39+7tvUjMuSfadSUd41WT416dIr7l3v2hPQ2nKIV+8TtVNpyVa52GVw3Le/LOlNigay+/WIzfch4vYM1X5YMWlZQYLzYrjHQfQyzYTKfsxTiuv2yyAYuYw4kctiIVjzTfatHR0kbcYxo9NgWfthHuUP4gvvVjm23PJ+zlvXfUjCxiayMD98qPuHF2gZNXMrFgbn2G+AN+O8FQi3WTWOzwasOD9ziF99YzKZAYPXvFCnmH39KyWYGuKpusb3N6i8sXbVkWcoJYcOWczuE3+NeROaIPlsQ1t6uszF/jLWWL7+kA8a0zW38ueYXLe9gOQYbE1lnd7gYv8aI3LXONJxAbHIveoJOME5f6l/cNJUZlZ872JuJXdtt0pUo5II7rppDy57g4Yf4hzf+I0aX/WuineNp9w+PryojFepyA24/xhOhar4dildWW7Lv6EJcuz/YzSiQWfLM9bH8fr9S/FV0Rr7KNRaDVXVxdvyPxaTAxZ8yJ3xa3cd/cbUYJnqq82VfscBOPFy4LfnNG5R072nbHYsOelvvS/Sr7lBxbHYlFhqVFFhbE6Elw39zr+PFzeXa2ico9Bp6LgvHjxe76NnP/nx9aNt4fmzs2zZk5TuWWdHU9NxyRPFpTY5jKM92Ha1jjCb2zu6bWyIhF/u2yC+DUdDR90m2VVy8zq7wCC2N8ktjHiQXpmXeLw6DouZTqnKXKA0anJcRBvX6oem6jlHhU8Y+k2/A0ucBN8IJYzJIcDLwPcVrxdyY4EQt+cPysHsObmBF+of+ovFd2Zs5z2BNrPbyGRSyO/hPtnATRn1z/sPJbARlo/1bufAnqoV4jFdeJkUnQr4Wvodiq7+QzK2Lx3iv7Nd9CfNXhJ4ZzVPmZZS7l76DI0M70vKIFkPWkbWuffgA194d3zqWqrP0px+0TnBu24tzsIGKD+sX6a1NAY9+hlPB9qrzKftEIDMEJn5a8mU3MCV0wxlYMUN8i9VM2A0q67ntpYxqkRVY4D2QSG+cXnZ+dDnM3XdaaEkG8PevBd/UMMDSVZdXaELOXUBnVGRB0Nc/WfAWxwMNu+cdM2GQ8edrm4cTy0rkrw7LAW6a41FDRRDxuZtGZbLiz2nrR5ERi0cmWbk4OPNz3Gep8VfkEpXhMLgQ5Dpdx9hILOnfNa8yFOZufiuYbEnO61ZZ/yoNSRZj+LRYxMpzUGpQPE6mKmQnfGwFJWFaWBwtAlJwzZNYLYjFdaDuvEIyKoxQLLxFbm39d1lkIzpvvST9aqfINS1PSisDEvD4+eylxTcl7VnAx1O2wNeJqE4vGiofvLoH478y1HXUNgN5P1TurIwEvVJhQjIklYTrv7SWgk5FaLo4h5l2+afdFAn1jZzyZ46TKNy+5srwUhsW+eoa4xOYzbLWjS2G3qU2DxXxiQWEN010K1modESxN4lPHvx/ZXwbz7tYcn1VbD+jR6OHGH8rg+ZtK11epxNZr2Q7jPkP6rCjbJ3HE41rOzXb9DHs1xyqGuhMbJ/Zxv34GLf1vFfl7iGuMfksXfwG7t1wWYtcBdXBN6Fk1byri9VZ1ZFwHZoeQeRMOody+hGuj7XXw7v63yw/516jnF7YNRbw62DJrl11T/1HqhW71ICOsgwGd/VvmeHvRdNbxoSipDljllean0gLpzjSrKUhSB6PCLOIngR9l2jmkmZHVwc6/aydoCLxpQdRlHcSuhx3uw+1PMp6UXqNtP2NUDzOvpMyuRcHUmVE+1Qy3HspYbedD1c7Tohu2uohXD043dhXZ99vSy3K9exlhPfhpKG+mpfpQdekGg0xiPdicKJw31ptHozxoZUrqYVKQ5zAHgYB2mTC7kZHVw4ue+HNzxSFUw90bGojdAEu2/LEs4wdQQsOwsci4AXzajd82DgbSNxyXaKLtDUAvs7HDOIDKDlhjgHgN4Ow5qt0GB9Ea7spmRtgAewtW3zmPAuhqDXo6SmqAEZtrTKrRRTpwotYfpqQBhiQwG+zRVXrttdB+RtYAJjwPiaePH5VzpHcKYjeC+utql1DTAOqD5wZ9ZNwILmrRm7cJ+NSFodI6htsIC48xP+XeQrpUj6piLjTCR5PZkU98ebR24PoORtgIskcnQicKrtCmC6N/MYmNsCLsQGAN5wp9ss+CTL9q/Y1LG1YMlOWNNgMkb4QRB6/OeQKBtGbS+lGI3QR7yvfFmDNOVG/np6HIuAnGnVsQ+DQ1mHKfHMVG25vA2N3tV/7gVcp8oXIy4jVBxdMfq13MhPSOJfsnIVET6Lmk+6vha/RmU+58lNQER4ChNAZO06VTXnxnSprgNU+kV2/qS7tpWEoZWRPcrdKpMdU8Qx3UtqlgdJvhw4ipJrmaB6i9+U8GGaNmmEzNcJrCcqcrP0b8ZLjNkDD/8ik2407fsLk5E/GawZR7WbKeCaQ4f13pYYTN0JORHuk66EVxCzTKmMRmyFygkM5hjtPrrczKmJJmmNa0SvqOOUtXDz/ezciawWrkwih1Mx96p8ubfxndFhh/5l34ibQg6vfe3jbGqAVas41DZIMn6Jn/4UqG2wLOG1voU+BPd33Y1cpcaIGWmp3yu97+1FdhDFn+LdB2vSdE08+Rip02axpKagENnXEnrg2com9sCP/FlLSAQ1POpFTva5RL5kATI2uBwasJz1emXqMWdMf+hditYH/gw6PQi87U5C5dbWTcCuU5vNOitAAqU9e9ieG2gtbgvqwVOvvoP1cqFyJeK6zTTdv6TcCnn/hWTkOiVrCyGggXejnRfmp2P5jEVvA+Oi1rMj+YWrnx7DwkaYWdyczLm6yrlFK07g8ja4WAwh3ZZeg8Fd75tIjRlULZ6b8NOH58+lfujgrGSAonhk3MT0OelOyvNQqGKwXLp+FJjxgHatThwAbmghT2p8qSHTv30trMzVFIJAVW7sjDIQJ/et3Y+9VMohTeGKz9qoncqNt8vQlIIoXrVnusu9W205nkS0wkl8KoumWH1nEu0WohHkpGVwZDQmUrF/Vx6ZzAP1OQsQx2j3JUPPMJpMKX+ioZrgzW5nz/YgaBlN2Wx/3MBRk4u0VP6lA7Rptl9vzLCGWwud61o/SiK+X9u4YsfxksuusVO551gb75n+skJJFB8rPizVIfe2pRRk0XI5PBgSs81ooh5+nz1jYdjK4cykdMsnjuHUjv87jczhjJoeZlf8ZpfhQ9Vrt/gOHK4WB4wdJBHEX5bi1SRzw5FOz5T+yHfKmGAgVZ/+QwwXlFajVzjrYp12KhJDk0z657wYdQ2uTzPRaSyKErwdy996KAGhgo72VkchDbfeMN0XClIwc+jkTsNjg28pz/F8E16lDHn17GqA1kywdO9OJ46mfsV7L/bYMX2/V4riiWit09jez/2kBa9bu2ZyCEmr1rTj8jbANHh1WVxiiU2k+t1kNJbXCVpS5w58dQ727O62ZK2sA2OOHp4h4bGn0J7GBkbdB88GE85odR9y4HaSG2AqYfHAi1EyRQ6msvkf2/ApbghOZ0Jozy76QZhqsAh4ULvetZLtTPafOUzAUFHNXiu3zq51PUP2GjkUgBC8zUqHw1B1r/+O7RKEkBalMVS3wF1+lVOwabmRIFKCq5Jt7MVTry+fuRSK6ALDPj7ZbMJTqx1qOP0W2H+LmHr9ojH5p/5BnZ/tthzLt3cIgJpffYPtBC29shxTdoui8/gprW1TcK8dqh8Kt25kckoD4Y7Sfzvx0sH778Ox7C6TVlvzRQUjv8a+LCs+NfovbmvVQyJe2wSA+z/1HzoMa9TiLbXzsk7Ug+eY4fTXUkLh6D2B0w89L4Iyu6bal5QRvJ/r8D1lpWOtSx/KjjryPqGW4HHAh4+f40E0DVOGuQ9b8DdinS45LFEXR92gUZI+wAh/n/KIZz4iiNh6l/mMQOWH9RG79jwumqOeyxSNIBq89U2p8Qx9C1pnJdJO+ASTsvjQzgR1Glmyv1EFsJy++dtLfRsKY85gz5CxkrYfjiGcXFOJLewqtoYbhK+H57yBAHtQD68a4jMuaCEvRO5OnU4ThKj103FomUIJIl+mR5X6Wum+apoyQliLXwiGFmCTQ93mIykihh3sZZffN9oukAj/91cRdQUaX/H8fvkIN0DUsP3W0Q91kGu3t7Vda/C1jr4BZhjI2Nncdl7frv2g5yHx2O3WMPFmMStiKroyu/54HPnMNZBe59ne/k6Xi+b21N04u3mVYjn2kOTloqDSF8Dx19jJI00tnrV9PAXbBgED9Vsb10HVwQSY/8dvXO7YuwLoBE8T31algwSA/Sv1m5+IXZkjRzCdtbb4INCXRDXEPOL841eL9YepTvsQfCOndifbF+5tQEODGVDuR77ZnmuUA/nrvRjvaDSxLIK77nPgw2WpLuY3fsDlXD+giayvfeNbBwRxL8d6aWl5r9QCxo3oM3+5mUrf/Nrng3rFKSFL4XXwkLZWL7mU3DR12GS8NpBt+Tvw8bLWjt0UXTZ72Bvw6lfX3Z3rxVLZ6fQnxsL/3/ZQ+zncmk82yPPgzWBVF9x/KA3u1hfRTZf4bt1XeDXboR6bs/vBq+grODyd+L2J59HnwsmS7bkFR1phAWQqj2R7Z3PwfWRFPh64KN+jXM+L4h6/kePhyZQkze1w9ZH4b3dSTTOrG9/IuwPp72zpEPHWWE+yupbQHb038FR0YSp9hI/ScL9HZ2+dHlfG/fAzZa0/cJ2wcdDYNVb8WeJ9gefwdY6UX+WjksRtsdFuzoWb7X/y2cF0aCxv22+s5oWN+eRvM9/4mwIKMbQooepiw0O45Y2bC9/zJ4Yyqd3TSoT8Ue+Pt25LtXvAMAa8PJcW0v71+uw8JTaQHvAtTCei9i8cZ2/lATrFKQPrwT4GDuJ72VGrULnhUFwEY7EhHPugGJsCGaDGnTVXO6I/zSh67hHYEv4Gx74j68YU7PXLgklWzhXYFCWOlK5sdXDvo0F9bZkMsfWWdgHayNotpx7YIe7YLVMWQK7w4chYUqURMhpjddM/uhuOEy7xDApbE0903w494f4P4KUnqQdQmc0Le6mkC2zV495oISVruRXj6sU5ACd+tDarod9JzeFU5Npc3dgm9gYaU46virqJ/GwPo2pD/vGEyGNXfFPT0iXs9bDOusqCXvGmyC1Y40Z9zqg0YtXOpImnjn4BxcZkHG/fnm6MhquCCQav1Z9+C1ee5C6/Zk/RBpg56YypUamzsIsNGePB9hqvKLg1V2NIF3EVSw3ol6/msq6DYYzkkjZ/Wsk5ALu/jQA5Uls7cWt1jT5WuawrsJCzHv7kOrjw34SrUBFs6KS3lH4SCskpHZirHxzmdh5UvR7RjrKlTD2W/EjB3ffef5Bi61oRLvLNg+w/ezI6ZT8phBvrDRk86Yw7oLCXCkP7Fcf6b+VCe4TEYWNXcYYKFa/PPx8NrfxpjnlrQv7zJoYIMDLc1uyh+yDNY1iH/xTsM2uLRJDJuWfn3CYVhTJ3bh3YYrsPKtdMTab8S1GljtT5+uZh2Hj7CHgg6d6D061xW9vO72pGYD6zqEwxdU5PvnioyUDDjPgezjnYf+cKIdzRubG5r2Iyw8kjrz7kMR/M6Whh88/3vhQlj9Rqpt7kDA+kfiwzMTZjaUwz4K4pjHuhAX4f5vRY8Zn63f/hBWnRDdeSfCBGueSzZZB/zWOqPzUGKS/q+cdSPC4NJY+uv4O91Pp8PCdjGUdyT6wy8bpH87lxQm58CaM2Iq70oUw5JJnCqGWhgWwdlXpQW8M7EFdrCnrtcWtz9EYaNOWsq7E1darLnrQp+HRI+uqsO803Pxv+eKDkvfmnzsYdVeyZJ3qRSwlxudapHhkRcEqw6JY3inKhZe+UI8U+Eaf7UDrDopzebdqk5wokHMHdw4flhfONOHfss7Vt/A0y3oskDRqc2PcPYr0ecf1rVSw6GeJG7r+JirxXBZnaTnnatZsOqxeMo2p5EuhgsE2ty9WgcLK6XEtMA1J7fBZU3ixxLewYJPmaQ5Yx52eaWDdVWiojvrYp2DldbEMCQtJMMA603SG97JegDv9CWbt1UP2/QCrrWiLy+zbtYHONGR9gq5EZloi95p/1fid7yj5Q4LT8X30UN33AqAJQW5xrta0bCqVpxo9dpja3tY70TreGerI2ysFVOT+i1Z1hdWPRHzeXfrWzjRmlQfzR+8MQdOtSSuA3mHC74aSf6oWDbz6iRYb02X8C7XHLjEj+YM6fB1+Ar4pSvZwjtdG+DuLuTBLPd3q/6G07rRwUNYt6sCfhhKOvlFLks4BSvb0D2843UV1jwQk1T7htYYYV29mMq7Xs/gUhn553zq9Mr3cIEvXTifdb5s0PddGkcCtha0O+wGCwYx6w7rfgXCbWNIiHvh+jsx8DtvUvMD74DBp7xphMfUD4Fd4EQLYsG7YAPg7u5014WA/BlDYbUbUUxknbDRsN6VOBv92zoVwM+TyOe8GzYd1nnQxIpFvx5aBBvcqV0164itg3fJyRqnSzlzdsATgmn6TdYV08KsV/ze5/e0ScdhjQutsmCdscuw3okWeo4IXF4NKxuki/GsO/YUXhlKg0toz8vv4UQFDTvAO2ToU7dPpvabnj9L9mixplpNtTdYlywI8+7BdH3d1gxtPLwyjOZ4sU6ZCOsDSITpQc7wHrBwW3Lm3bIvYUMiLS+5uz5pBHwqmKRtZx2zfDhbST79EhASPtlsBU3lXbN5sLENPfp5vq9qNTy+M1WWsc7ZFlgpJ8t+enpk8n5Y8zl5zbtnR81+IQbfe9b5kR4u86IVzR00ODGcnOvrV61+Cm/uTudNYl00E3xbpBVluUeD5eila8PIMt5JU8C6ANK1q13EhxA4250qt7FuWhK8MoQ8KZ+eacqEBZPozTtqfWFdoyS7vKWj8nuz7amCd9VGwRo3Gp4yN2dsAWxMJALvrM2EVXHU6u/F9+4thZUOZDzvrm2A+wdQmXZs/cTdsMaW3IviHTaz3WlypZc264LZArnFu2y3YXUsWb7DMCXuCWz0oxZxrNP2HlZ6k8qkLpOz5G/x+eU0mnfbFLBgkuoHZNZODIPlPcnNvqzj1hY2hFOfnY0N9zvCnZPpraWs6zYAFruT0a51d9TZ8K5QcjeKdd7Gwd9mEadj929FTIKNUXQc777Nh+UhtLd9U4R8Lfy0D4lo7sDBwjGpoWjrB9dDsDyR2PMu3Gn4VDjNXLCqtIsBXt2V3FOyTlwNrPKlZ57cVm5ohNVeRMu7cdaNLX4XTjz/Of842hMWZCSJd+RCYb0n3R/l7X8nxWw36s67cp1gTb1kWiB9Kh8IZ0fSFSmsMzcc/pRPFiTLT1bmw8oOdBLvzk2BNY/F/KXrdjeUwgVRFHmQI//pLxwRsvRXpsjtDRbvRgqyd4GCTDlKkFkrBZmemd+Hs3sDu+cPf8iuMhzYNh+0tcZBW9tWB85Vo1oeZ9f6cTjYbo8D8fy1u7PXfojX/oXZEYfondkv/zxjlS2foYhds0e13M9i93mjWp6zlV15AMO1VQDDY7Qgc+dXLF/w55Th+Xx+Cs9R8OdgvovNt2Jei7lXq/nxVnP56Jb5Z63m1zHn9zWt3oulSVT/A/YQD+I=";
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
