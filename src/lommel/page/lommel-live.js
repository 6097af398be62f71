// Made by `make page` with ziglang==0.17.0; SHA-256 of the sources: 0974ae2b76f48245b7b341e58e9e9a6e4491994cd6ade777b2b1e00bbc331901
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
const wasmText = "eNrMeQd8E0f2/8zsrHalkbQKVg5zvuNWGy6X3iCNZq9jWrgcJIFcP+DABEQ3TrsIy2DiOL0XSJPltCvp/fM/YtJ777333iv4/32zq7VMyr/+ysjeffPavDq7GrFZyxdxxhi/wu7gMxmbKYsYbGYMVw2Y4Z3rf16cyfAvikVemGkQAdc2QhsF4EAhlChocqFQCLkCAq4cGLpgTkRgNYLYeZvW0tYG2C6Gg+ypyBcY1m4DAisF6nHThhYCO4gjjgmm1T6AyQqYgAMEsKD5C6ETZI6psQD0vEDm6bULIAaKNNXW0lpehgJM64+WkiGnOQBB7NFCEGSRCAyJ6CtYQCbbq5chOSuwmzCBAiOwzQhw4WJmGIwwKqFjYA/uISWUDAwVZFawTBh5imAUqmJlkSjWYKvQiqEZIakQxTrkj2IdWYehV4ukwrDwQlA2oAV6TVopugMPACNgiBwiJfFASSEKW+RIGEtbAytIa6IYDeBDMYDxECR2K8LGAlyY68BX0ENtvBCJ0SRUV/FUawjvYeFgDGTUpRWtBSiUbcPQtEgLoFASDaLrLiqgSHkQfgpfJYyFYIGoEqBY1wpumKPh2oI1tFdRYQeBDpO2AvVB11i0GF9ByBVAionGTw6ZtXz+jOWLZy1dPm9J64ylLc0Hz28+ZOf07IVLZi+Y0Tp/UfOMA5tbWTy2cMmiRc0LLXC1tDYvZokQIefOmr+QKaOUWptiLJlKO05ms8ygDA1TOk46HmOmI5Wj7ExNNjto85+AwJg0087gdLpWOmqIaUqMdC3nhiEEZuEfkA7GIKixea0dXBz10yQWyNT9bFCGgYWZjAZu0VC1zLRlZSjHtn+uuFKAh/4i7eY84OwtrGG/3FL+ais5dGvpbLPttopW285V26sdlKoxd9x+Jxv2GltuWVMzyKrZeUiNo5SzixTDdxrkyBFyeO2uNgaQHL5xBoccZsaUVGbalEoCkrLWZA79K3hDSBVe0wNu4XWTyfcJ/MAVYzdnsMQ6u8s9EP5hew4erNceOhKkUVzKkf22OIAkIiKkYmy0zWGnIjzfGUFRNpcc3jhAgWA6NWM4HDd3VPjPBEqYM4JzuA6UPVLVjvVqTbNe1suGkb6qh76daxoN297LMZtM07Y5V2leC/thaFrRkE4t1OBPMYcGtG5l2HycbdcY1i62xcdPyGa5bRiGOXHS3tkmPmbyr/cZOeQ3Bp8ydYja19mPp3/u2DX7D00Ps6egHJgOAK8NiihrZR0Oea4qq44eJmvVNO0Rm655HJUdTUDalmOVQ1ZwxMgwILKDFkk6Vs0BBjcse9hkNXno0JqaofZ0JYQAx28DV9K/s5Q9gv/eScv0Xo5juH/4o/2ntGPrMfHPE/9If6Y98S8zspzWUgiYw2sdwAg/VyOGKTWIEkL1KWdOGZFOz7L/OqXGUsO4MpCb/uJxEAtu/OFPwrK1BVO1BcZkOduZk07bCn/SbnZsBaSw7do0T3PO01qBbUqRzc7904wpNj/wDzEU7NCaQcPGjDG0t7Vak2lnKZuBcUiPHGvumDWZbVZjpbnjptMxqAJjXtb404z5/A9uEJ186Ku0s8YCtdBucLh09lGKXAFe2yRsQwzmgg+H4WrfYeNqFkm5uGbkyCFD1FbDLbXVqKxlW4hiNqtUU7rJauLKsaajv6y0NaCcpqKgdP1SAdtyKk+T04rpMocjRrq2EhB8KAOVBABsmqNgD6tVpsP7AYyhQwd7gwfbGPW20jG0l2SX7jSR9o9sExbD0nqFreSIbDa7bGyLPdKGoztM5suVs4e9r1RTsQB0wgIFrQCMVqhnHGGgMkMgSAGsOciUoTbo1ThFvgEJLnCGbAcTzsHmiVKtqalRFplcVeKkXBoYhIf64UoOHx4IH8JrDwmiZQX6eb+vEh9mw7+x/NDD7L8FhnAK1NKJ2aYRy8baGJwW2t1GxUexCjQ3yBGHb1nY3YJTvx/RsGKE5KBjAo5wwxpw1coZLcnTU5UxnAyV3BlsIDVYpg0hsZ22oq0LCGEDNdgtaLVaxCVIMkRCO7QR7Xy4rJUVlF25YytOT01Oy+ixkq/iuGRWSIsv5XfgY0rOVonYblaR++3t7bYqMr/96ZX6zvTksWByanhff3PAdOvjmFsniM1ji5oXLWk5TDA1Y/7i+a3zZy2c/7dm9HLLkiWL2BoeX97cOmPh/APntbKzg8nBsxY3L2fnc2Pp8rnsAq5mH9Q6Y3nz7CWL5yxnl3JFLLPnt8xeCKareTIAZzS3tCxpYbfw9JLFMyAQcdzKU4ubZ7XMgHhry6zlrew+Hid6S/Os2fPYwzwB/grvozzeMmvO/IOWz1gylz3F0xUZPOjnz25mT3M70vIal39deFALe48ntD2zFjW3zGIXJ805zUtb57F/JTV67vyFrc0t7NpkLIRuSMa/Epz5XN3OR40dPaZhwrjG+vFNe03cGxv3b6ZM3Xe//acd9A/+T360fMB8yHxCviifjd0ZO8/61PrGesl+xX7Wvl7doB5Vj6kT+Cn8NH4GP0J0iiPFUeJocSw/SZwtzhXniR5xvrhA/F38U/xLXC6uFFeJ68T14gaxTvSK9eJWcZu4Xdwt7hX3ifvFA+JB8ah4TDwunhbPiufES+Jl8Yp4Q7wp3hLviffFB+IT8an4TJwtz5Hnyj+V5Jey3VxprjJXmyebp5inmqeb55sXmBeaF5uXmJeal5mXmzeat5m3m3eYd5lvmG+ab5nvmBfELoxdFPt77K3Y27F3Yu/FrrKutq6xrrNutm6xbrVut560nrKetp613rDetN6y3rGOsDvtI+0u+x37Xfs9+wP7wvhF8Yvj/4hfnbgmcW3i+sQdiTsTdyXuSTyTeDbxXOL5xGeJzxNfJL5KrFFr1VnqHHVM8rjk8cmTkqckT02ekVyTXJs8P3lhMnHbV97aVD3LLM8ckjks87fM4ZlCZkWmLdOuix6l38Ezq3nmCJ7p5JkjeaaLZ47imW95ZgPPbOSZnmTmmJTagokGn20l1j++souNSzGmfCR0t2Ce6UCTMHUpB5NocNEz9sQUc1kT0+PFYjnHNL7PmQI891cems/xpFADWUDYMFhfJtX5q5YSC1eae+8qbTONirbrl+6jtd1lBawDWUD4cJ6+TK7zT3bAAgaywcpf0jiis7esnrAt3iaKvM3Q/0YbtLJ1ntE4ousiT8LYZZ5Z7cZe5ZAYkHw/77dnXLMuZyqyZ50X05KWJttkWrVkLJKMh5LxupxNkmKdl9CSKiBDUlRLJr5PMq50rE1/o0PRsUGfmApcLLui5Cg37t97SD6XBFNcE6G1QnWT/j3W+DowSahblku5lr5brtJ36SYaeWfjxj49nI7G9mBkVucSbgwkeON2NYLGNI2v9tKuQXiDhCDhOW1gDOEYaJuwG20FLwOkm3YBugAh68ZcB3iwT7ukkEtrB5Ou6dp5/8wlec9c4Nk+hyNA2379ZHiUcO1LOnOGm/DXIwYLLunKJZKCXD8WrpuaryFPEW1kOQMUjelj+wDBczEg0yGBbm7ab+ekxXM6YUr8Ei/TtZps6mxk+12yOheDsZmuXBqlFhg2ARYkc6abyBmQT2g89PtTSH2Eg3GhbQbZC0vzsNkhqmu4TqDbgGjwcS03tdyLuxLawZ8ugCkWBcUghYBX5BxihkWJFa6mrUDsi7+FjJOD7TlJjMjr+JxsBG4FvC0CoOXqSNxQrjEVBQPtxmFe4iK/mPfgcRqeN97EoFW7ng5dN1yT7M6Z0KrXjU3FSrHDPAP0FIcM76JLB1j9Yi6eFNWVCPtC/cgVQo31saysuyEnqITd+AJ00y2HoI5pCmgCQZUWuCXqBYh4qOJZWNpoRGFNTQlShmXp0rU6KFOM9QwVFq7hCSp41u1VeupDqwwtrOyC0K27wcwcASEGS8EDhr6+X4woX/s/+vkdGI1Pu03rWh1T63BvP7QDi0SOQLaiR+3JedFHQVFvjyNXjAYXeycCMh6xYr7M5+AGRQRkkWQKwdIJUV8ILooUYL+o+ch4l02C2z53eavHKaqT6zwO4QM9lmJYhumc+K7LFoCtr89Y5q+AoJ+aRGUIPPc72mXezxxMQuC5pBFMHZ0X5TgMDCVEqye2Epc/gd3cw/5O5ulJHtKZVpfl/UIeHuwGJxAnH1Y0gFGT/CLtJI3cjRQHnpNOeP3t46STQydY9SSPmPEqhdxRIN2pSdomSOlZ6E7gpY4Kq9hIcYUVAvr7jN00EjMdC59MEz5WEJNSiB+MzDHlUuiMfODApjOmWrlEynQ96jQxArZnzIOpdKNu9HnORCYNv48vQ95cky7cNfPYLxluuks4msQ1AkmpJaFMES8sKyKLQE+q0/Wi3oiZdCxKp6JGYQsqXER0gceHaVD3GexDuYeV+GUxJ+BgpS57c6iNyqQPbJCIPpVnmUuPDgxrmSf9rx48bpWkfVP6Nz/75EZjnxQHeOVtN/cZU+CL3kAMrfPFjY07vN5byommg0cftusHe749JgffsKvQsw4y6LE+ix6/DCZZCqJs/1QMoh/s+TVEOxvmwOGKbWR2TAVSrxpISkDAgFIGpVJBcuOqbZsnbP5FfbnS7/Uuu7D0rfDkdV6/GWWEF5mOTCzDRr3bVDD1VUavg/4i9HNtNOJQXzHZ0CVw7R4iiQJP6gwGegQ+ZrfHunHNmYoSENlT9mJldGT0adr+lvji6zYcfWO5ac/9Xu+8+4EHx5bKTdc9849zh9yf7QV4xPSNQ0r8D/UAP81shtENbCUq9SXPCmEbG6prlbu9WHeIqaXUx8rdPeVcjGwnszUGe1a3rgKawcYy/l0BVJR2iRpMG0xwigpI/eZXIOSVIhB59mDv7BTXvLQxliIDw9DK6J0pZ2r9e6CEgHPlggAb09gaYCNRN9atFWJzLYeLIWKxUnfEEVIGGgl0tQl4LXQZ+Kh07PF1UeGXggiIqtxEmtl6qFW0beWDPkKjJaEzc/JxmHwr1NvS4kXqOVHQ3Xf493Zefw+JRkKWHii9V/97pCGYYnzZW6RHH4uKuSfHUMlg6AvGF33sgJQRFF+11LQgmd0DBI2AC+3qGT5vpZ69y6JWNYJeW5YyBlasAZH+PpLhCg8+edlbvcU/pFhVi+liqQqwCZ/0vvDyjb/MY7XswfqFPFalLbL4xVMu7rmFQR/loTp5mPanozt0+oVTLu5Yzw6oc82eHCJhUMct88+9aW2fgQJyO0M2p2N1b1UuUcjXUauZUQtT1iXmUdPTepFLDaUezxzYmGXPck0UiiddWfbMDVnPduUGj7s2tJx3+6EPxtfeUl/ekCWmpqb9xr4w6KOb0Q/PG/ecPmf8HehP8G5IXnbo8T+/bdm99b8/xTt12KSH6zd8yDd8DLz8+ow1a9Y8VX/KdBqvhXjP3gDTceGlEgy0uktwZUDhMfWcIQxUWdVGSDW1xjMiDL3M8DWejBADt3ty86/E4nK6Sdeg/zmeWQcawWad159rUgYRpAMQ5bDp3lHFueeWXp+B7ZhF09t/VvY4VVM0D96IMp1k9nnQHH3KnrFWo0FfC2MMsgRh7g6QJZq6MmTpJolST3ektsehqo7sc2cPtKJnEyt6/mOsKDtKq6lWzt3o813lYK5WjmmVckhAefAAf5gLUZXe+hzXm8bAhLA1QdbXVT+LDf+mZ8/sM6IG/xiPRe6KzNG0SPB6yjbZE3v653DIwBP8zNVSSzUd89xPN5/rnr6+lFmDTa4iuL5Y7ofo6y+nQAQsXtVWzXpK/Z2kjhMGfSsWhWD349VWi2AvmhRsYDAj3CU1ngHtn/LRhkdFzqjecqbuVd5UDd4NiPMecIIP4sZiN9wheGN7ZRSxTeiGdiVsRFvrFi+jg59479VH2eXUwU/t+8aN9zS9iceqbu2bH5+098yPvgLBHfbhyS9utRGEppNfn+W8bmysL5Wga53WX+jQN7vQ65FOKjyzmzSUKNDAAKJmZupOKelpIX74DQ276cDMIhYlqWPUVLt907Rvcl/VV4Be7IDF6XW6q+vCN3foMCD8wUaqBj2BbqoHlhThHjo5JTbd/EFCYWkTQpl7+0hGg8e3yylVj6Yve0v9cH3VCwgePL7A+5GhtNiZ0BCJgSESi5g5mIWK6C4jpAEkV7oivkeSNWhJlpOaRacRL1Ju+GnacWF+u6ary73lprUbnt9v++cvoZQtWtt62ceXX0Xgsp9ssfH2Zf8m8NZ3zsQ+fBfAHG33/To2e9p7ZeQlJ8K1d1IHD5t8+N/rwb3vmAdLc1NXELjY/fVt9427jsC+DnbysEk3E5iaTuMxgLlYfxL20a/HRqun84CvJNsaVO0WXl7K4ClVcN3YZ/X70lqd0yCbbsTa/Z1nwXtSBm/6/PAfbC3KYKWf2gt5l1/UUl1HUe6W7oHmqwQ4eJvQe20o206Kqjt8TdVbIGyOPk3xLzakXhojoLjrSn7Qix9MosCMOmHeNVutOp9CPr2pKz39prsIu2LJO8agxx/VWD1uAzZStOrkHa647fqroOj3/Li6hbHXie/Oo39/9mvbsAaAk7c/+me/GmmsLw0oP8PFXiy11Ve+/u8+Cn7kqyvxMcrhC6H1p+zwLS886d8lxJx2aY4vHHWOCrnfAnfQ2Us7dEuXuisSo8FMJdftSqB7tDaCZQnKu0uRglKV3iCXFMmGfNSNFVf1S8aGbFjCgL83iHjXkFFQgteLSlgrAaq8XlRiXIlWBV8JeCV0EX8Y/UocgfdieBcpu7jynnJJf6M9PmbytuAFlxf+zwouKqwwOPEGl1OJ/0DJDSg6zZniURard5DqGjzPM1yDtCCSkqJI8A9Fkv0nRlLqSEodyf6qQ9kFT7zIsZwBr1e2t78Cr3lUbJUSgXORY4B/yDHjv8gx2rwiT+BV1VYxcKdAnsyoscgriJquQc/I/+7JQ38He0dwtDaS8yK1AbZkX2a64FF4KqUPrszORrl6d8PWWzYdcPk77SZupUMon6n1XPA2oaWDYyyO/0PzWxvQcFGrJxYEP0g0ml0XuYKO3mRePz3EZHAHZ3DCN+jsTVSOyOj4C8jw7M3/kFaCZHgiJly6OSoUNgYe4EVKcLI1UE90hhcp0TOlrqx4QB/46/JL2oLXFlgo8JVzQFRSXNHzuioItB1y19gkTjnUNgVE5rh+fmJXYeHcaAAHG8kYbjyfQ8BgOx1YKgVGmzYKCOdzjBgb2e6a0c57YJygmaSazslgivU8/xfQ7EsX/zj8ZPDT5XmXhfZqGwwdeWTF5WQlfISZ8G3TXJ7HuVEMThI/RWwgncKxJEE5ww+h3QKSqhw5fqkZpe+Op4XCQ3B/tfB55jRtgQkdRScMmmuG8tQoSATQ+kxmt0APsBKpykPfag5rwQGEhDuAYGANc6kmRSZ426TMKsW2WEkzlIeqZVus0pSjO+lNxGeZo0FjTE1CgYe1iSPi4KsIRTdzCrEj9jyzJoDo3JJtpvXrS3AC7ajM2natadxATcIoBpt8pIlBU6gTPjMt/B2NCTiSOZVmAXiOBhcN0K1P0zgyy4PM5lElPpgXLPM4KHr10A+G9U8P6jPyhJMnfFNPeORJtQ1JplWU+idM7+k9Kvh6vRYXVlem+EcPwKWZHmIfgMuEuBPjMWqp4D9eoN//RPRDHb6dHYL26D9EMonkxfyVS/P4aRPlj7hZdLLWNjkVHhDxTs9uLBYqp0dLplW9weXirhmdINXvC6/tqSmhlZskGBGXHgBv7MaV4Wxa+JMgtvh+BR/2MWio+KOdLw+gToM1bP/leN6H+geaFTzicnFNLE7HPL7WjSO2F+m65OPp10moAElEHrjxHt0gViQFIBTxLNKZKRMMJvzOiBqwtCLLjVFAczEEMTQBg3UEv7nq+P1omAz/RmsSRUq7VE09YDwlIXN+sCigCwLIjVX95rvTXuUBy1bEXywUAgsEYRrwaEy4Zqj98seePrah4IkK76EdK8L82IXoSRqH5PZULGyZb7Z6clvj+uPQzp4q93+Four02bZGu6Yky16q7KUhN+LIGzyHCB8eC0LZhfCdxFLyMsgMEt3rxrvL3mYlD6h4yVNuGulROIvdzE25SXo9SeLNXav4MlLxoFYBBRlIlzAAMherxsuQjgemXE5MZYIu1uzlAF2K0GdqdAV/YoTvCvElLwWz1lWiFocpaI6ob6R/3aF5vx79obN7p1WV3d7+WrKCn66PsiflYrTpUs76q9GKUmlV0osaT3S78IQjAv+Tmq+AkxzHzrcl2ZYtV3UN/O4///TlfrJDx8zs4wkz83H14d7yzkIyvRtm5oVwckxhZmZmZuakf8n73pPUdtH23M0Gbq+mbOnpwacn8CdXOxr5iI7CvBNH4RmB/+ro6PfgioHj+QFFP8OVEtGPyHVL+KB7mEcLVX+TdPzJqwWbXCp+J1X8SqioKeavGwyt+xRzSWC+hso94cNk6P306/i+8NWrLzztQbdd6FQ6AsAh49eHmNR3Y7kkM7djvNXugxSmoiGTM7SEqRrA2OBBP/dqeKMlSCHztJyuvTp4NR280/j2lNzZ+0OMz6gyOuRkysj9WJ6bC4kPtiLl8zSQnkocioYbOu7vs5vv5JkjyfzNU2g4iFRveFf2JakvhRIckz7f7Td0+YhTe+5+X9ze48lLS0eCCkDG8rnNmHyj5ziX7hfZne6XCo1nIsST/tv0ZPRvOCcjzIR9LTiW7MNGqbjnVo66xm+yoGuG78f5mpw/vh7na8Lt4OkSakcnbHrIx6dsZuUwC+fpowMtUC07D8vUW3s9OiwzIDTHh2XYC4M4xhEX/Sv6VDyZw3KuVg+9CjzOpP/e7kOvcnTohefyvpgcehV86AXMFZDiEq/vuAOQ+4JcvpM+VNDp9Ow5Pu/SG8+7kI/j4y7ZMW4+PWJDevUojDs1nYMJZfE4SRG96/QK9KWanF7BG9KEoce6Colien4GOhKab4+0kmZOI9lBZkM3f7v7ktWTkMDuq5iwvmmcNJGz/pJe4bwYY+CrfuTTvp+OcTAwF9+AyYYnIJ3OtZ6CKh3H7Nc/+QOZngTrjn8o3hHFcwfw5MpJ8e1SnFOLxTfCRIjkXnF3e+chdreLt+Bmvfg1Uvxw2kyusbI+x1Y6Nrjlk9HA53GX/C7xZH/AIX6Gdw0s/smGm165+Eo0YdZX5ZVsenMSwgXL9JqkeoNHmWJoopp91BlPA/lqrOe4oFl9v68OfI733SqfL3s7XPM+M811XT1c662HBpLCaV9f0n1J76ld+8rBLkno7zET0Ya4XHwZ46/ZTx4VFbzGP0gJ7KKXvt731X80FBxV16gpvEmx4BnEgpV8tMJkUA75FYQOkgoqWQG50Wl2U15Iy0V7tcQW/D8c9K6A5i1pk8S05D8952FasUt+5JNniW+WLvrRPDc3R/gUwUfgjaDrtYCnIngK4Bma4gm8xafzUYUCiHIuow98scROa8jg2+INMAJz4VWbUUyGYoqlGq1yrxgkaq6WnVqPSaWY1HFMKsXkPl/lBUJR6M8c/ZlRR+bHofV2Jbgafdtg85H6tk59W4e+ZQW2d+y2xN/s83t7Bn4Z4Shab2IXlygppdgsQTdzDaKke0o7Ga6+wuOqSnLlEkqWgEKAoOISBWrZG4mSmjWQd94e508u+WMkf2rOn1EHfy8eqNP4WO9gs2l0FNTxBz50rMH52oHXSywvd9+xdPRpYinpHXWsPnnHmnHH3gtCPEdJxi3ezLF/oUqpa1hhbygIb0IAxueyT+XIyxQ5VRUcj0RXiJOUzwaUCJycRKen0ZUADQMd4ujAAsOylPuDvuK+h8IyjHmvBDTu/PP7fFm+zz4BkbRDBcREnnkXvY6STijpiFLh9XhIv/rEs+53fdJ01v1Wy2QOAfDdh08KW6Hhs34qi5e/n65q5szo4qFXkF3GBAty0Pu67xK95ODyIXn2BJZQkMiZKaFh+AfZyzrNqv64El1adK0qgegrkiLs1fW6qR7ojowhOb2mli85YIOpToGcEkc++6eSC1/1GeUuH3ot4q/oc/jdq5E7csqtNpjSZKo4qauknhT0Ag8bORZSO+IB2VaSEXlv+3t/+SGIIx++5/BJiI0Lv/n3TApuuTk4yCM4QLIxuql3EyG9AwIsfNVJIYATMCJerIe/EyOzA6OSvLDS57d83y8/JAHzeX/+G/puux0tAA0Q3QjN2Ot1WHZjV+zAriKv6xNjBzdhBe6sg7cDXXMSdMsd6GJCbJbum/Ncj6YbFY/eKbYCM8xbccs3B7Ioxx8hNNIFmCviTCIvJqDsWmzj7FKW4D5skXJZ4gzBA9427YSCqbjI5DInehVPd0er4Q/rvIje+ugtRGlyPAcO6jF6wQ2Hhiin16HyHfAW61mvHpQteqySXvMSYEQsvwIvnQKkx2mODNLnfCFSTCyHbnzToUxri0/DnEuqMnlVXnuDM23Nj5asQY8spiUNm64SgjBLIuVBcpD57rgfUVgozrIXzISjgCFeTNcLlhBc1f304jEqS+ELGLCzeG1AYPAJSnhzJeI2DjY3odPrsa9m7CtLcj9LqOKySS6jBgXisi/kgdiI26ExWGST+UAffxv0OsX/P50KBtkhTYraUPSfOVHm6b3C78kOeh2zNm4ncvpHXinGmsscVi792BfDr/w8vyVdDH/AFxTb93KNZCOBqB7r9VGbrfyPDoGdui9Fg28bvs8BsMdnT8DXo9UjvZYsJ1bh0WrhNRbtlgegWQIg8gi+kY/3PsVHDnG0aSqh8ZU/W1KA+gRDBKPrWfyqH4UZetAb9+mFKqYAmFDHWx3EeO0S3+Wyq4TFltfBewtwVAAn432QJLKvBjy8UPwHRAsX8mrMTXif3mxAoqbIz3rj8f3O3iDhnuhNpMVvyR9DSBAIgICABwQGSFikG+BRciRTgYUmmwCGIj7FHQQF4o4hTJilxjg49hQ+9oWvcL3FOTjlg5O7nVPiXCHOWThnp87ZdefgGJh/g5O1R1yCE5Iqu5AR4xPT505dTKbRZ+hQuHDfucpAyhgSEbTeGWjJpT++fOAYw4Apz1yoe6bkAU9dsV0qwlfQ+2yOl3DoCvoeZWPhbs2z0bCzklyY3KkhDrOQ/piQckS4QEo/mqDJUf9YmjdkD0SauYCa4nvhFV8hNLrKgw7sBYDho+lLiU6sO6TPuW+AG/e0I+puHaEaft6ENYUJYG20O/c3+BkK+4jeTP8JCQ3/+9IX9IXhV8p8gRvdFkzSPWsqtfgUaEX/qDDv4Vu6Ofh7b3jFinpuPWkoq5Y0XqBWMQrc45p7XqDyCBraPHBCXhlIU6I+IX/kOGg15MjqtXGDZg/KHgWVaEaaHoiCRxK/2yoAaqjESfeclX65L4N6X1wiCUc9kYUOcCuAw/LasHH/nOd5QnwD3lnCOxvjbaZ4m7cV72nDS8FbsBDYJ5CQhu2gJDDdJ6oUeBmCLkI4vpSQ5TcC5bPGxclVUfgozL4SbLTxSOjiEGRoxcFkRiPMwDuO7qFDLpYUnzSncXmuz4Lf0tAwTbnezOcSrYz17V1fbEg792v5ZcHgfyMCso/6/8dPQD/xC7ylsSSFmhYb80hW7kWhz+CtrHsfzEKJyP3FcUNkez5c4B/ICf12Myr4sSB7d472ymV45cBnix/hiw+5vPrSFrASBVN/P/8y+/v5l93fewqP/3N6rxS9PB2LQh6M/OqSzyORGchBMjNLz43YNtm0p8YXnvlb5te4eR+fIOPjo/BslPkft240Ed4bLCixoCYWFCwIw40BPbGQwjr8nwjr8J4L6ws0HeIW9GIrfPH5x/FvJF9JwvKeC0rDK/m9Dq+14hU3cwVEFp8dHjL1cJ+rB0VErrzA/5RP/rorZPL1k7f5K2rKDTvLleXcaJ3l2qVXY/fS5fcInxubag+Toxdhvxb1kJBfUWBOreJl7stBX0nvenwfzXwiFysx56PJLX7pK3qt321QWTxz/Isvi6Ysr8+HF4Du+hKJnA94YiQmy5Vx3n7p3nE43oZ3We+gV6333Pg2xUkoB3dvJ3eh01uZ6B8qL1nyopcDtrDcLU4dpuVOth48PtFqyNy7Zelnt/jCXvVgUFe9EDzAk1815Ivfkm3p0V7eJCooPVMSO4KR3xU8xrsS7A4/VurxzjXo7O28LEuKWxvHzfqaHzvlsbR5n1khh1uZr31DX20RxWSOsb5mQW9xpgO5DJf4nKdbQ82Swq1yUmtIJ6lDrQlAeS6Boky2dqykFjwtaiFtPQviw6K7HYxa9MQ+3UXDqNBRldjapgUuJy1bHTKtnvpujkXNdt/buwO3nYBrt4HbRGWNmGzFFysiUGT9LrDQWEfvNTqod5OoXdSb4Goghw/Va0ixKgjicx4KqBgfnPtRWR1hs55vBbbw9yn+H9YrDAf5EwA1XV2B6cfrcFZjZxpPvpiUKPnrjpshHvKR8cHJU9HVGAJwcklqOKkVSUO3/IGGxtcCPhhptMNruY6poK52MgDovsB94V1HwUR/ZgYcGTmikgOZOJAlB1xXozKMJoxJKwZ1VwPNkUWxRC2ykQkNE/E1EBSoMDmYYW+5+G1hJlU8gh4uvJK89gVp7RqMeCr9hPw8gIhJM+rmepxXECm2DVqUiIKVJDjfN6KKa1HOt5XEaEVRhS8g7UQfNPCt2K1YQFAzYzkZbYJRe9yGJNvzveNxZLkW5dyi9LV0QLlish6bNCRXJpN2zaQVLWsmWxk1EQgIearYJ0nnW0rqmQ8RzwQ6E0LletLC2qBHXHKQ8zNgCS2WHeCuW5l+c5DK2Vr/ZVv6bzqcU+dkO/pPamP/OY+dY6fCaOt5uAg3GZLjfDhgaNgm3fEo5ZFokbj4Qwo1SmAN1t+Hf8jnMOo0mqGyDxVUnPPQ5oYZbljGxhw6Dxmut6hHUadZbec0irWklaOvqfbeQf9UW6+hD8qi3iykqyy9kGEQLKM/sK0OveCE9sNm7ncixWjYc/OgzOJpkNsvfheVGIDewhEKT4p42upyvF6gee5BgSPVMoA9YSarPLfr2LSYTYcs7vervL057RTCmt4brOrFoOSwg1+uv5p6Dm+S9+WQU7Gns/llX9HhAe+M1Eu7imCpMD9SFXTxqssR1HL20Fc+g+iV6Hgu1lfiWQM9suybUNE7VMWbFhrqbhZm3RnKvQujvic2OCebM9YrNpDrURWKt9loJVGCQ77lHqqRpphs8HTDtQVFSTH2kKL23FaW11mck9m1pqv9TByr8OZiHZy6eb21pEmYw5Gqc0ZdATIxB0gBftcS8PZZXQkhjfExD8s/virk7txXMt5qfLV8+FGhC+SlU0ga/EPrZVelcMUR9M6Qbca26htg2xCqvSNcWakbFLKveG+kmV/pTRcuxVCD+CfGAt7SOeyu83Ok8xy8iAwcyThNF30bkFAyhe0NmMZ4fIpTMziFOQ/60LMmnnrM4OXMt3y+gbYzX8vfjKILLukLamUpk2W17M0+6S4pILqofOEtPvQriZnDnMp92mGuVe9JfspThOQARihd78mkitL413e4DBAdkGMYTA2HxvFLRonfDi7MglcxmVxHforhRpKp4oY3rzcsYjIVDGiLBC7oS0kCz+Un9f80L3F0pG7SN5ib1U2yd5f9q5J5GMMsB4aG7BsCSGHKLbgE70CNptzwB3u4spcK6T004t4Trb0Svamup6SUvYTBvUAl54iZmCpIVP4TDdQZB70a/lUDOn10qrNPowmfPo2GTMOvTa+fw3TuuCyPZe3TvgcpVHRKk/ajj0KaHz316EfzozZfkT1673529I40nOif245Oe7rJcZPfdnSf3Luj9+2wolla0ai0VaGViq1/Ku9a8u2mC704iCxyJDmzdePwp5r5Sakoq6P3JQNdw0sRS/oKz1zqUiKqYzQwAKVQHj8U4ePfjgiv3RlhjQjrk0RYI8LmfTGTv68Mb99c/3WcxkrSQWGLx0UH/TwkxlwSo8F79M1F6roaV/XFnpTkPkDr8FR+0wDN/XyfM2a4RQ0ZmaM7zp5/0RgLXtEopHBIzSHaq2FY0qxCCC7wzylSiB/wtDpKItMGmnddYE5Q/NJ+76BbyBSwN+Q0D8Y/R7f36u40XZ9BfqFMBORVs9P8J/uqi/0ZBAhMkcqzk/YyqTT+DFLeG+7o2fa0teNOtRs61SBtzWVJW3/Gn36/WY4ZGb3o9fu82p+5zTeHVKUGgzhP+zNPyy/0Z6Sn9gjlRbd3PMbntF8BTFhpEoCVQJ8AlDFhfLWC48El43iGB4vZOlhmGCxvK64YLOayDJY1XM8zrvUhVWFWXMH1nhxbpzCQMLAY/z0ZZqf2BX10Xx5/eEkCp/DcCkW+vo5S6Cm30i/cbr3IPQknGnZqOKRd4xzdCle6Ap4En0xYwwwvOmSJsqPVx16o0SuqyWqrHDwTj1wsxwqF4Hxz3dcNT3lVb14tvjRoH4V6AzcM3CAnRuvRHG5EqBu4gTs4xTyoN7y4oXEeWsmrOdJay36sfHxm3A9WeXUzfoqiNrBmtCYXI85M2AJs1mQrQFfSSZpxGfK9IKcgYrB0SwPtTXh+wyU+8lCqREBDfJuc1BrSSeompBmXQJFYllKxbXuNamFbWBIflr1bDyW6iQN0Fy2jooiqxNY2LfA5adnqkFlz3hzLmu3Ot3cHbzuB126D14gyLhjTZiIitNkutNC4iN4X6KK+nIRdJr0RLwM5fKi+gBSrgiA+56GAivEhZYrKVMRNe75dwc30RhRzKzgg/ojt1NSIVtIvzvVFMGyOTftCUKcjCdIizDRvo/AT1sF2VjOHLjAIuvx83qn4Y2Um3TDCIoUV/phe2HCCdCvSI7nsKZWLW8wK6zjZwaa9pCryAFy80Aplp1AIIg3+5iTkhpxbb6bS9YhK/32h0v9qT5c3FxfUFjr9WqHTXyR0+iu20Ol6SqejWV8/QDO7hC/33Gcyn948TjPpQ19tEeX8sSR4KOeb5/Z2H5IZbjyumagVMUiviEnTNkj3DRip5/Y12kll5luPW5DpUrIQg0kTahdiUCRP7NyKIvFWKkVwrGOxS4fd5owVHh0iG9y2u90+tw3Tc4LpYjum59YwlXaCIGFq2dFLAimoJcXwvp+B+zvW68SjOeopIBKcQ0xUoZTKHJpAZ9IiaDXeCVqb6HO7nT5XiT4v0ExisByR/CZ1xJ+THiTxlD+HXUYdQzk0xFC2JA3+XBI+PX4VzJTYdf5cPIgoZsceFIFAl+GDUWjFYsZswshkJqaoRQYbJyLQ/2BCoKsrh2uFQCetawT6plSpR7lexFFabM6oTNqP0qpNargqagIjLpo4UDtSt8f1llXIdRWHRrUmJqNGIGqliVhFPSq4KmoCKZ5mGTvVJGFKqzIOnHKzwYW0TwadGJTBYo8teCe1Aoqk814aFIsw8bUiJnm/2B8JtoIEMh/a2bZQ51wjGSPUORWud8mk5+ptPRd6JtvWc1IVNG0mzqkPkwpkKqeV2Hou19s14hwlId8wCKbMOVJbanZR50gcCK1Q58BIMO9ajWInMAKzqfq+ZQMTdVjNNnDn1ybuHDKMgwX8W7jzP9zFnf8RKmU2YsrP51IUufMicOcFCsoJdy7LOtpt4c5/qdIV/qbjJv5cr/Dn+rLx5/pK9D8XmyuX5A26BQyoVAh/jhsBfcqfo1z6aCd/nmxU22xIb7roETp8N4EOqb6RxrywzkJSjBl0uLaFQU/NYVtITxjdxqDXwqBb9NeEQWeraSvFFDqMxnFu1yl0TC6YiJ6bKPQRCkKhr8Nbjyl0YaurRE4LhT7z0w6V5kB6TKFvgrwZQT4f7DYOXQUsSpnLHHlKFplJqpJXBeVBLWZ6TvVmzKJDly+6iic+ag0JOGspJ/pCZg0INH4Gn2uPLpJ1pExseSMdjjGJ+VXmUZQG2RxlqMoOSD2GThXZ8mqSPjMBoplmzgwxjDIH3qxmzmySOUXATgldrlbo8n+c1/kFjb/yt0aaQ41majRMt/lg10hzK6S5wLPGmtsE3DptDpgUKtdoc3RghXvBDKwOvqBuSptj8hTa/G8roc3PCmVOH6ch47bR5u0G2mwGktkJbb5OjRH1nCHZj84fvU8/B0k2CyQZ3eS4EZKsJZKsJecW2LTNNpNkNPhBkol3zmNlnm0jyYT1Yklvmac+eTgyAMTxDQYQzEYO8AThvWJneMKtniA8ORJwIPWaSOo5YvCQyEoSQWH+5iJabEJKGEkJByrPXexcpPd6UpL7gCu20rdcEEZtb59zZbjF0L1LhPnfVIEw1yDMSU0izANXjn9Oe5cIc5FEjtHUuTclzBcH3SmZBRaRMHcY/YtXd2fo+mwgzJ0ICGF+JhK9ZxEgMEUSz0/axUyYn+3cxoQ13O9zTth63KP1hh41SFhzWRLWn/VnIquLCVQ/d8hf9Wp/9jbvDo+Pk874syB2z0pPLQjlU+G8Qc4cMNkuhDBPAFqB/hhAK1y0XcHx4JJxPCuHDltHynzzSDkBrhgp5rKMlHVcAWo8hbh2DdR7cGCdxijCqGLwFzLGTu8H6PciW66ZLT89U4mj7l1iy5vAljt2avhkYrWKZ43n/6lP6UCnSWy5eLHGluvAlsMz8chJubDlCM67KVvu0F6EElsubpiVZSgdFrrIltsRW35tYsul1YQth5LAln9bpRXRZ3oLY64njDm0alIHdhJfBa2nTJlDofYFfQllzua9SqK2LxDTc3stD1y48bhmJlbEIL0iJk3LIN0b8JrP7dWYFys9bmE2EWPinKgS6YVYFNETe7eiSNyVShEc61js0mG3OWOP/bYb/La7/T63DdVzgupiO6rn1lDVY2ashBr6viSUglpSDO/7ylciLXoL8ciingIiQQsxUYVSBeq8Ep1Ji8BlfDGFawI7fIstdLSbWDWY01F1nVRLb4rqENBwLtBNRCJjN8sbpyFu4GoJUvDgDXgzpsjtEqNghSIveIgKRa6lobyXagNFXsCww8rthCKvqUoo8gZCja87hUJ513SFIr+Yq5w2yf/F3r8ASnZVdcJ4nWedqlN169x39a3b3euc7iSdJw2EpBMC6cIGEwOS8a8jM58zE01w+G43TILIx0ggHRKggaAtRk1CJNV1UaOCBkG8yKtB1KigrfKIyowRA0ZBDYgaNIH/+q2199mnHre780CZkU5unX323mc/1l577bXXXnutcZMCzsrTMzyhCtktauNUPU3VrAnZ6/Ka3tgGauntaVxwTwo2iHUzG344WIQwPCuOnjTmla94up+kFXMBpC7CJlpAvt648KumVD6sBqx8a0rlmrHW12zrd7xay87+0ggNtIC8tuM1ajsWg3WPGI3N7kcMiNvpgRggOtfnpVnGzrXENP5aNZbqZVI8Q8+o+L/fGhiEZQe1tDJiulJ9WMCo4R2D7CZ8a4yJ3JJI5qq3ANLs5Tt/sj7IfvyN5raAhmBvT23ipa/xfHHg4+z3Va0dduTOYtsTe3ut1xQeKH1fTHF2UnZ1k/tqhw+rGrZVeIcRVVgu15VJr3DoJ+RZu2dw/AaWEd5yFJXe6QXqvgu+GDxtzKgZ2FsTUVca74H4q9SrIJqBPGdrjjwHDbxXoCHf8VefretXyAdYV/K64LrAHR+lat7Wh2379KtegCZ7x3fw4VqDOtSRiy8QCVG1zz2GFzhcnMn+zl7ryAOb66i1mF/aDtz3x+nvPOuff37t6cN9L/iJpV/7zd944ANsFvB7z/rWW+5of/fFpYXAu+DKwxkbvOeV7/n93z/jF5423HfW117x24fe9hQYG7zlxouf/OAH34ngVf/4sff8x/+2C9///1555Vz6Uz+GoAOBOhgJnKG/Yfr6yA955SYv+1GAtAhvk7WiCDnmzRITHcljAAdQ+aqgNsZHE629AgpRjf6Dcx0QyttggTJaz2PVsIvX8yjVUj4ISznKH4y4gUkQOBheVjSAosfkNg2j6q/jWfqTfP3/uvsgTHj070I8p99bpvcPf4SD/Qfwyzm/8O43o7BmjzMdlZTBbyCFI5ppFb+84Tr3V/+TFWHXEL80kEdXH5k+En3UBuS+aHLeITUlKx6ZPhJ91EaGwAUN7LSvaBj6+pub9BXx6Ks8ta+/JX3F73hfJWVwd9lXQF88wtzGI0uPvqfaV3zTxDePsMv3sJ8sGKLP45Ti24Q92PfCNz/j8k+1P8Murrw71tPbPC+4tjJNhkPG1Ws/8fv/+cI//izj/OdvP/P1n/vsf+aJIpPhFV99x3f/xdbf4hn0ie/9ENvYPAOGNX/mQRjZvJ6926ixT2c7M6IAWHqp2snnvOLAQC0DOSOZgspHuDlHKLJ5Lx4OjqRvQttGyUDhu++K4EgRumSxyVk6xju8+Lvcvn/mlv5//+FDSwc+9B/R0mdL4T/NcxB5pMcS2vfxPYc+8Ff/fOf72cPLO971/rf8bY6Z/fbvuP3gc1/5Ju47Gs4YyyZe059rig+VCD5Uju+eqPSnNTCkiyfhfbDKVOmRUjXOfHsRsHetqplX9b8FaJmX8/c+X8ykPeTzFqN/993GC0xJF2+/IVRrcLqKlLTBBg5WiBD3x4Vv/14sKqPmY42HsIPveeaWpb1X5T65t0ER2vDRAYMcBjD44eL0FmNZG+29stIaCtbZ6eBb3vqhb/kPf734jAG/soOGOh7wzPDdz/6HH7z6oR3PQM47kxv67FFB3FgkD/89p668+/XXP+kIIfXg//v+2yXVpJx6f/Erd2VIuetnHj5SSbn/yE+/80PX/WMfttSv6d5aSbn47//oH7ov+QRSDr/7b19dSTnjv73n5a1feDtS7r3mmv+3knLLR//LV1764CuQUnv59n2VlGd/+eDlf/XFZ0rK+44tVlI+/9rXbn/Gu2NJOfiXf7bXpYT3PC9522s/uFcAs/CWSsp3PPV9L7/iP69pysHLKynRaf+4/cfa4d6Kz4k8kSV5n00a7rOfD8TBhymE3woLzS9tWjtSprcYKdN7iZTpkEHKNGgiZfoIIGX6qCFl+kgjZTp2IGU6VmmKxUOLnQLN1Gx1oNtScViJ5VUN21Lpd8/YCXborXZ9Rx2Y3K6WfCtcUrZ3+JD6h30hm0t2uY+Ul2CHufMBqTziTADVy9TVBdvxDyh/3Qqq8dkXTazPsbdNy+5NZr8tr7lrxEK4a8Mhsw9Uvw0m8G/DChJS3bU1+xndnKj1azP7u3uH4iyTresO073isf3s2i1fwq7FEy+6sMmg74f+hH+zL4sOQB/OFJDKD478SYlM018P/OS6+Nq+bBCw0znUpRoseB3sEud9a2zucrN4BDHkI453XMjIL5LlodRYlrxRvlmA/IefvEWM8OT73jGevGer4wn1phIyOPQF4RdfXGsavfcOZh/MlHru3nWFwr6Hfu6Lf/ic77uCx7upx4WaXal8cx1xdY6j5m1FqjikR+ixRFJzkP0wykFUJFHOGLRmVz4a6SHSU7WKfBt4cn4gvqkZ8zYOX8vK86YLithPvqZm1cfOzL4LLttx9tzrH/xBcsEre1IotYY4rqJ0mIuHNuh8AazYzlo5bKPCXzXM5XyWekuWWnredFud/UPAgvOMO7nsHzXWHRef7XmlTVcPPzXjKUdVET0xV7rfmE9I/6sY9wSyDcaQTd8XFFOyBxVngUsZD/fh3zmINpjd9e3ISqoUUHhompqeTdPnef6UPtSyV73KFHeh2IN8mykuuwHx2NSR9NDXPt6I2FGPbK7dd462G++bt/uekXa/ddN2u+LvGi0e75sX/+WR4t92EsVvjBW/cVyo/261+HedRPFHR4vH++bFv22k+PedRPF3jxaP982Lv3uk+I9sWvyZNYOQh181Uri+H8N32dcMoXtjwLt4eLx0pEfs4BshVRE42uMZ2vMtU2gPBFmYpNEahUpQNOKoj4hfqETU18rFrIjMV821qu13R1mQv8X5KTRUSrzbaXqFoQwdyXLESfeypoLO2r7d3i8u/uPT70cFFGo2zSV5vAohUQlY4XPjQUgcYELQNwFMgOS7l7lpbtk0+Z63d70we2kUzKXMrul2WyPCSk0h5Hoga4eUqo3MytHBw/vmmHHfCGa8FVlPNCtHi8f75sUf/OjIrNy0+Jf5chKv83KsAn0/WhupAUuqGH++3dRAU867mTtP0QzCk8xzt5nCKHVkvo5Wi/fN+7Ux0q/3nQTY7h4tHu+bF//xkeI/chLFHxstHu+bF//ASPEfPYni7xktHu+bF3/Tx6rFf/wkir93tHi8b178nSPFf/okir9/tHi8b178R0aKv+8kin9gtHi8b178vSPFf2HT4gMWNP/nETYkrNjw/SWY+spepyJrY56cTTvDQC9IkCzgqnLkZderLwoKq77dA+PmS52TpWc4ozPJrIisJWMu0ca8+6tU+v2yTXijt/7oqyq80eHrNfaWkdgfNbE3Ts374OFq7JsQ+6i5q69n7k3Zw42Rbt083oELPX+0El8r8bOvgMvSBE3VOyTeCWu8d6TGnzj5Gn/j+hPUmNX6X+DCsQO7BXnTM7kJ8kHuK5LW7Omzn/3UTWjZTZ79+A88x3zudgc1NdmU7PIfQMG6WSR+/TJeVR1V3c5h5UUenGQ5T3xC5HHGrha2wMrvtggNX2RJ9sbrFWd9BgZ57KE/21B059O2/q++jqeMJGW3Xa+xO9c06ddgdz97s8RqfPYp+RAN+mE9QNqtSZhQ75L2ACeMAezTfV6MINbXh1jpSs+xHgnfofu9Mrtvsvua3dfst/kj/Hq8U4M18aSoE+MhPARoCnZRKI2ppuXp9KE4+yntB/Y5qiQHR3Gpzjny0CRRLvSztyBjy9s0ieJn+JMFx9jM1vCNRN4hyNGv4aD/MOK0yWbe346HsbSFxqquycMpF4AcKGCAAqwiToTmRqJsETs0vtHzgmnmwc29KuC/OHoxZ4BdPRFc4AeGm+muYhqFQLHAjhdYKLVtrka1jyhW8I2sPCgNpzkT2+m7MUIox3m/KUJoLRgH5NIaCtmIMcc9p227DYPAFKk1NuSA1gZi1gqj0BoKaxhYZUmr8KGts/49VfvTOBRR8SkcWwS2gkAr0K02snA4+4MbjBVqOYFSvyGu8dYICJkbeiIPhjrHg/ysX9rL/sVSJW5hqX9bbepmbQykAdlBVP/4j161bjd6wxOM3mse51YoHks7smo71k/Qjp+Dj6QpPvGldlAJezFOLoqFEExEbvhkMGIMhdwxZATAEEJtiP/KIQzsEFKoZ/JvOSSbGr1tGRv0jwSEoEkRanVVx1zsfkFTg16xRS/UytX7+KKlVxul0Lp0Uq3sWHMPFAOmXInUoHDAA2nZHWjQiqCh2jfxql4BbkfqvxGo7ryhCirFtX9TUP3cDZuCys2xXzh5UIUjoPI2AVUwDipZk0dBdcdNVVCZCaHAyv6NgDW46XjAOoJUODNTZpVkhZYVz9MVD0brLwjuQmJ6Q9KQ437el3qv4F/5MyC+i0lvw1pKL7fl4rsT3+IC4PCIXhr0eQPuUQOOKAZ4Mm25xUPNB3LVmk0AiwYWVX7AAjtuyGU/g+aIO6u09FyW9lsHipq8YvegLsaw2GKVdatu4aupd/wl0IA0Czg0g7iGWzx4tIqpnv0s6kArRfsIF1a6kCwnwI5kWrlAHnuNpyUjikdYmGUMa0NN5sy79/hq4Aul6q0cszg0rP+7h74GmTgg0hKTY7oLABlt9A96a9pmbS6orjT4TmThDFN2+u2H0/BqLgzPK8zzcvPU84i0auvT+xZ5zKhOUr2SwGL1vMOdyUwO7pOWsts8yTwz86xpRli+8MVwUB2S+WKOUpqDvbR5vnnWv5qVFuQOANcWi0g7XsMxxBkMxAUpgPTxX3vFAoDXcBlo4U0SA9zQ2AX9cIZmaOG/9JAoF5tjK8D2kTX3uSUZDKYkar7sDH9vPoMHN1bUBqgl40YdSvF3Kcw+9PdesyYtjCnetHELZKrOZ1AzkGaWW5nPGtyhljVaNLPHB/xm+Sv0XEG1wMUvSA+5hjflC2Ot7wB+PAZZ/yCt5Rl5tPBeyNbm8jrNo1y9fneQZ5SBSs6ohkY7GPlyA9aXHvwXqMpqo31tcbW2CDMz4wdA+l65Q8jT267W3+v7TAPkIAdck3Ds6uBG99aORSoCPXPx1nJVhLTXQSp8kl6SQa3Kx/Ez/Y048eUiSnBtJE/PaqkdXbbbAIzvIbhuF+bHHY552TvEaU2d1SvyRAllA3kS6EbjATZ6lzgklBs12V3ID8tmlwggVuEPg99Yp5n4As3zeLP3kPQIzDd1qHOgyLKHEZPPQv0c3Z5FLZyDTePnnp41AXKM8HNDsTBVvg3QdbMP8fDwKAN/nxnkaBzAZTh4j0HBpbkY6uBWj4d2Pbuo7T/AUDVUuiZ6zR51+MkIMoMH8CoLRIfMtq6YJ279PAFi1mVfR2qnGhBqBo2YkUYAF6hhushVMp8mRfQ9XbJquvmXG3rZV5HL9n+2YgpMHrOn+2G+gHgOnO+HwFs8YvCR71vmqt63rLIO53EyhafoOWoysIaUGInw6Xv5DHNOLORxYwNUN6+1QkF0hqK8w2CfpxlFN27jnDpXxBirKg4gb7cfiM0T0bzsyIB5GDB8FDI45JNk+G4hMQwhgEmEUayhqhS7gwkOYHMNTD40UjBujnjeY/kFFLVnFAOrwC4LCmVfU2xiwIYcuYpEl7Pe/0gNPg+Ao9XYPS7yTWUkuch3aiRPELv9n0uPNVKW4MidrpCfmFIB1uxrHctf18wyMYqEO11R7eLuSNSRyhgAOY07BvxQ0dzfz/TWqQdbcRSY23D4EoFkOBzihMAsZDofm0b8e/MNpYwQVOR98i505SMSvG3KabKRFCM9xYkrWAYVx46V9lFX2scl+ObNStNP077UT+yAy8Cy9q2U8s81eWvfG//mVwb/9JuHnw7lqfKFbyy2hQGRFbEOdiXpS7UwFAhu8O0oCYwBkA4zGaXSjHIpBo5Fx0ASYOxQEwxFnoHDkKLyWbcQz7lg4oLzumAv4BPpQr5YSZz6yRzayw2UQVvAbdcCg9e2g7dES+XgLergVRoEeJuqikUEj0pw+VlFF9Qmb9KiTMemFEYdED/MPqtSjdnDvV7GtCm9kEbcju6BtXxLSbtQ2BbKzFXQd+crFFNG6QGYMarWwcVLHbRyM2Ys1xJO1EIZpiqXVU7VrFiqeIEH+vfY0/0qAW9XeWQTmc8cwVRbIuZonnq0NBww5VlAaQvVaSB7iEyX+Nm8w82fBWSOCWS6zyoWBTIdjk0A6+6z8A4qtIRo6UiHlhT6vSuL5V7eQW3EAY41HxmA+aB0GcdtmB4MLhpSB19y64p5/mr+CD/Qk/kre+uYiu6YDKGAtXGezlkTCp6PK7klRn9vGzQwgBtyDMyiiDZCNFTZV7VSpZ2YNe0h/kQ1/ZdUoz/hoYbKSrtyqBhQwu1wAHfBK3vDInHzywWv4tnVksFygoJfqcfYf+Cv4hbtYOAIWb3/ZX/NXLrJflUmcsCDK+/DnDsstkR5Md0AFXI2IdW/TZE+S6/Xiukrjm/b40viFF+aE/DSrK5r6qAtA09n/i38RNcP49lgzRU8PVZo4ecEb45N4Z3IIM1lnRYJg8ensByg7O9vkB6B3RemoM6bDq/w8bzdQ1NVfBhp52SAlPMs2+ywPW/iAVFOXdY+bSSXbvYYfqrdQHP79/t8iVjbo5suMbyZt7QND0oLviw7Kl1/27hKRZwnpJbIHVrKIPgAIXSjGtSCofLsy9IjFFa09Lo+c39aWtHg7CpasPoobcyytqmygYJ1ftXBQB7zp8G1mGHI3gMu31OoyjJmRqWlo1FpKIZJAcwLwQYcVMs43IsxOSDBY7hawm6KX0B1bLKv4AdX4V+tich3lY775VSHtYZL9MGAUlTz4QytTvzYww/gzoW15ylopYg9qNnL/kEAEwrU762xGo0O/ZncF6VE9/p5iKajC/q5Dpyj6VBs1qYIKja103geMih5oz4VCJ7insU6yBCyf0KtU9FF7t/rLE/Ky0dDzHeDw+PtQjjQabu56hCWEHdS8zWnVnPcz7DETp6Uuc/+2vfCaW4+dbLbjYkVVUPaq4Jpc9wTqgz4MhMXcZaXGCcl/Zo6MVfFZ4iU1ZkXKmAZqK/eIH8Q2x5kMFKigCMfMlKiSBjJ7EERqIWQ8ASb1xJqLWiTGjTGj0qsCm9/HtlNV4R8VpiOIrGVOt1Pzjf5wb6KOT2UqH74cJ6qjxAPScu+coNx0YkGWYfaHpZbPVqqio3+UmVs7/eDUAiyg5+20J0BGGtqElNEKJo8GGRDy83100BNt+iF00QNt8RiNQTzXYrGGFEokAKLz1li87WsUPXKIYHaWdEdZWzE/qQ70YlTAG+TU4AEeIHq+K+UiyZTTgGKRLe4oWvQRFdCNCh0DXIiym9zGE6la08KICDr8gO7cHWsmRjZTwDs+aXrdWcWlAsjeemP+KERzVn2frBcIr+jEoGOCKl9u524Z1tNBTDBSMRyaSZmtieQYygY2NPFxO9vLGGBDXTfnKvcExCe3IOLR8XLUeLzsl9GjIgsI93i3L7MX95ut38Sv6ca/aYymqrRutFRr5pAYtRui+AuW4AE6X0e+89Vp8DgZPdd8kvvu+1Ln/qhp+/72Efx74GLs1ffYLVmsGUXIVx2frCHJGY31cpjEJIw6AX2W4ooFqHhCE0wU9CekfYAjrF4mC/BpIObWfVYf2ANeZ+tjgGzog4WQiS3ON/7gTVrElIN0pTHJJe7DlC4UWFYe6yL+jyqpR8JA+zvqifLkT3/NWtfTfjUPMaD8jpi9+SJyG/Qm6nMSReE3vFvIPSy5QSbuyGyoX5X2Cx3HyDsGX6LG4GkCM6FsfHOPm0QJZKvRFJdEm5AJ/tfCBlPi4WAcndhDCWSSt70CjjxRRHfKn8RGB+rGtalWArPXoUxFUqAghRlI8ygVU7nxwJF2By25BHskjbhKKuL0Ol+FxJnxO0CcpUhcmrWTvXbBHbu3feF/7Cx7dWf/4OLKcpuUMIiQnt1WpkVDe1KV0355L41+Hg4KEIR+vMGDLrZWHBhTy5U/V6cDEMDtwu2CAscnkeGpY7c+gDiTDM90VNswOWiedy/JWAcNIIJ10cF0Y0CoqiiKJC+3sdVUEs4jtVGaBF5YJeHBZe9CwP6wKIYehE3r8F07NHk3RQAyJdQAO/l3IB9Erobs3+vBIENexB6uObv4Q8ThAXi51YgTiHjGSD8Hzb+ke8TTcJdyeKfvsFw+5T7eHRzvaGc4/DlmPPiyoVdeNPuz/zw//zBp0Pb8cz/962nn9m7gsPeBl8QeoRqLwMP0tBXTup1+Eqx8UX2K0r7VBcme7c5VQlEViZxFEBQBkIhtJ57zNIQJCgEJTc8Xwd36+kDABZ0GWDH8K72d8/iKs+yGjZODST9cKNpF4ZZ3TddWx3resWjMurKqoLdwEQq/lcFQ4xTcpqjs5aKWGUZ6mLMEQ5Z/d4V8f6Fn0f52eTnR/mZ8vPO+pqYxXggXIO/tjYHv8BbnRkct/Ozw8+b/bU84+eAn7P8PMTPOX4e82CfK5/n4D1c2oLMAqy2iyiXY5Y0E6KWOXg4kiq6yB+ykAHrnGjPehS7nSKCuAWlXVy5INioYwU7Ws97KCNwuwSUiI+ZXtOKpmUbsuatZu/BU7tFq9mv4a3y/Ufk+y0K6i1Tpw8Qnm3GHvMoRPW3R8VWlmF5tOyqR3qmyXdGtBXUcaNerLh7pD2QukX3AWpXkAiouNE+jyAUHVDGPWxpA8v2e7Xp5cElmqDfAiPmSbJjrr0PGVckcaO+hroQ7IiQc06zQdT5fs1W05qzD2jxEJB+tA5EqLtVIJsS15kSNzMRpyYTnD0GMam4wj2M1WzXcFhsG0LwnimY8hV0+d4gZ7CBCOfbEX9/mBMmPXfoOmxbN8w16VzLJ9qmPjKGQ8r33XD3b79w93+77+LKTU0i2k5b8XdZb6O8MWczfPveAXGTKvnRwoGT3ww5Qq6Zcj7cU+TmksGrD1pYt8/j1prIowYcvUrcm0xcqxL3IRO3UMY5UKZT4pqVuA+buMaUuKUp33anxK1Otk9nHsdHOo00L2TjWLPqsmYBYepufXp6lSbbcyZVEJymqTd6NpWmF8s+RLeLfyaz1H0VFjUVpHjmRIiZHT2aQbo0Jv3fnqhiT2iikdzHP1Tqsi5ojS0x9ky+cZqMH7HkQsGBwh6t/wS+mqqfXX84BQ9KeO4yz65qmHGPsHpSANRW0YzOLuEFsQh8J7RpxeH/huwIFRIDX8n4LfzMfvKQgbYD779Efjq6/FeUJZh5L8nK9+qmGAw81UzPjUFwX7Z5AkrVYKzB1GNEAeJxArKdtSd+gDnISwy0Y/GJTZGy1B4OMW5RDZhoky+/XTBDlfwpNMJHKBXFeGCd95SpA68FQiBAR8kqiFctxD2aazd59tj9wQ9eh6+QUTZs/t6qgoaIuXCDTD/fKZ/7q2DhRIRVNI35bfU0DhJUtrhIpbfazZZ2OuGHIpj2V1wo49QRnF72aTBnaiYzlgYQFx9MlgtY6DlYnGq5XZ0g36lu7mP+i1Az4rpOdsAgeSlFB9BupdsAINXXuBoxZ6oHNHUBQB7I6OdtYDC4KU/aKA7lpcnoE0ILWB4EfhSKQ7YWBVRX6KOft6KfeQt1XYKT6DqMW1GbSWldD+bQY9nSR6KFI/1QWZ+tKNGSviLj2ECuRnWQUJf9IAGzj6+yowCm+qfW4VUSxJkcP5gOA68xKS6qTO0AssRV8OUU6CwPZJb39XJPTdGdE60PdHU/G/dVFhAgYbWA3KOuogt1qiY8JUzJr6qnPO4pxtf7ASZjeVMLbXFsYLcQgRVWC1mSY2XBDxZMo0cZCFbDnqlIEPq01+FKiE9NZw0Gpn6yI+ialA2rZJ6iUoRyWn3xBLWGpbB2SW+N6s6MfLWjFuRSiJbQyvlVFXyHKH+sEyC0ZnujRLHvXwqBjWm7ElsK1Dl4xcZNkH46ZkMbzeuU1B3zKmda1W0CzuZ+/JOn3p+eM8tncwUr394tUw3Szco1SbiZqmXvE5xsKmG8nNxVog0+TImpORgUbFzzHk93KsMiHrXRAaYb2wuuYkhSIlDKlBoKz8AfYws3NAWl3IiXL/zit/75D93MfHHTSMZ0OWvKbcuN9VxQf59OlT15G4+z8hk8KO+odC/DYyGf7Y+eB7I1oflgr4sIcQRFcxArLqwVi+I7TdWkrsN4z2NExcpgRgvMQI98KAPUwWE9f7amtAJMFQBBM+ReBndQu/JKrZG0Afkb6wN+ia5qe7SoYkaYZ8X+DOMOER//lJQ8hH2ZeYZEjtOrcMDDOwe8myPPqFgZGgeFkVHJ9xgIb/YUhoc8BeK1CsSrFYjPUyBeNQ7E5uMOxPjxAOPwkcLxOytwbAKOzVE4qkNZ4Lgg5i82wxbvCmPHAhytuV1hydJAZjxdXIRlpGoIpAyfu3f9zQ8FhVD1eEOuT4eQUezB3MH6H1IoUr/dXL7P4bPWVJie/W9s5os6qkSsONUzKimIoTWZDBojm8sFjekHayayKWxAngozlresY1t1LyreeJynagwjow5OwGdA10a033ggZ8DKDd09xBmsVjOj9xzdtQIVw2Mfq0xbi7+PD1BYagSMpcOcsb82mkWPxU3OjmtN1q8p1jofGtThfC1RicFEmFMR4oZqxvSTvK76dUK21XKbRz6PkQBCMW04yN4vlMtTL6cza+TJXXdssuu2u7EMo6rPdoBIUit1aA78BJCt0xZVhA5ciKEtcFHEE7DDjZGCYbgTj0XOtKSW3SqApgWuZInr60h7gep1al9tTUXPSENzzzanTikaVx4UEJ98I68tca8TWSz1ePjIX1drbz6wYgmdWaIOJg0AJYPWRQynFwu2T4sCMbhEEl7LQrz/CrV7Dq0rCPbqVrejLic3MwwH8suhGOZQdXoZGu1XZCNdFTh4yiioTWswMMs0L11VTMtwBtrmiMq3VUHw0OQuPFVwkqbMCLSo60oCQUgwRim3omPW89Ebucsu2EUXL2vLEHoQzSxBm/GA8Mf1SjZBMT+vFiJnn37ZQpvC/etJf3l1taJMSjfWpdm0rGbFVKGKlXh6AwZZl7wBgKSsoRm3ujQBE1XJ3SJltHxES5lF2iyX0x3kIod4Vj6DQYDMaEYsT+sON9GJdtjtbxdAQcoYsJAEKlPGMEV026XfTKOWSNIC/vuGoZh/9lgp5jcp5kKVYmp2SzAXxglm4e07+1tWP/+Z81YuFlsxXtm3ox8cDivdXEQVXva3euONfBjyyheN/pcw1KjBH550gZ4rUDS1pECOspR7kXyh70OeFfz7daHjy4CFzv8tk3R8mSvZUqHj3UdKx7dsQse3TNLxLejMlgk6vkXp+LLtU/fxoeOL0+j4wiZ0fPFxo+MLj4iOL7rgwjgd30KztDxBxxcm6fjio6Lji5N0fJEWQMcXTkDHu5TR4jgdX/i60vE3Pp7X36DXwWEv+/Qb7GU3SOJyr7wF97/KhNyTbfLYLbjf9r1wmr4LQYi/ZvVdVASi+6C3eXJ5WQ1L3+XJHYdsIIVphkE1w1tHMqhZEt8aJunf7EGaoAeSATSi9GpR6L7gr2ExvH85BkyadV9trFkSe894bH/3aFUL1Zq6m1Zka1mYVkkyEenkBd9I1+IXa31IAuTYDtICBNbTZ3IZWGPMtS+5ss6v+oTeqAT0QnrqriqRZxS1flMSXugFk4Krio6TyIz6LynPk0O1gVA5ewecw/73mAEN2EtfEeDFoadTq3p9I4mu82WX6Mmf2y0ulfqX2iF5iKzrmeK9CZ4WEiGoeIvsmypQbizpOitqtKqUAr1FZ+6q5YhSW5Y+9iEACkyBUSDMQQZ34aCwLjdfZvn5UX7OTS/DLOyeeErn6tueUiOouFWvkpBRY8nnJT5fsK1MtJVOJmd8QhUgdXzqxlozC6k6i0mMRE5ryhPbZQg+SVkslSdAqSbJfkvGFbq82CMdDTAn7hCcnqdF8CAz2d3SpIYW9L4lVzA1UPDUEpHpfZJJP7JZ3lettE5zSNNoq8RHs5W4N5m4zMWpOk6pxA0waouy39ZDHYnKfkfIQEvUvOqaK1mbqC0BOvKPW81Ed75y/QCrCFB7Cf4k5wX48+LOHo/QjAgltCDjMbQ6WG4Y5hn5oSGtby1qqcY1hs3ou/NezSAx9qiVJZILRpa8qx0kX3abxRZ19KXlLA6Llex37YkvcZpxD9ejRf6vy8WbayhLANeKuP2yXw9ZA73o7vt++fe5i4cPBf1oLfsoSoPEuIsvuhW2Y6Wvd1jm5epYj7rKASaGP11E8RDua8TQNHtR2zfEiqz6aZAUASioQ8VDkWu5BQy11tFyu202VKJNywN4rgCqN426sYGezE4Z8FB1d9rrEzp602bG9CmBmb1k6XsrfbbnTad8+NKHMZVAaV1Vr1Sn0xEhZlXC9mZPrHg8458+9cl/uuGLP3frUaMFIaYp3JbHBLbspdKMP1DLmejLPn5DeXcUV+6C7L7Xy3mW4/gevHj9oQDMZAq6672UtWYDqqG1IO1lJgrMlbNa+rv1uMN7TVBe/+W+vWt7r1f22hxybrLNTLAeHQygd4ed0xUkWnK4Ptp/OZogfC354FSMpneU/ZXyKTiyygAnnZ6wghbhHnRMIdxiSjF9Ag/n4XPo1sN5dAOQ5temniyFanMxT/X+MYda2iQ+MQ2xp6hpG/IZV2IHOW4MIKTdYGIey3UVbNN0cxJjLkpudWP1aa5tse/lS7Sg121/tQTk0MGdZgfFMi3fXizzJKOusxg/ePfD87KJ4ZbIUplgZy2N9qjJLX64FtZksqHwLbTy8OfEGa7EP3yfl6+ImlqBUdHbk/wN50pDUei+Jvf6YS7nHuQheZGWGQdewfiJ2YR08sEzqVCM6tynubwmebWT+Bh7ah0mXGoL9K6r3HINcFtPQgxQe6vQ2W3MwHA+j2YO4Pk9awLCwJTXUeXehxu+7uK0f4F0za9xN/MVO6dWBBGqnU5NjO1qDTSgZqsNqC17jMCakUwk2ufPM/m9QorvZ6h0tHTtpr6gEVLbaPF6ZbZnxszT11VAyDRmlXxcjLyGu/diuU+7Sj1EMaJVY3to3TUKj76fMzDV9c4CwFRwMe8Fygypp08gkL1JSPMqptMXvQ+ki4wRtetLit6UN2dv+rpsOP7SbTi61f3G/SfYb/xYPbOXaRLD0Pnm3Xs5h6aSG2Wd9n2HqOPdU06wZO9AJSUBlq2YSUvF9nUeaZvM9I5VRyGvK53EGZ4QBHh2hMMNQxAqXwAsIAhtCjdwXXsj7+CWmFucq3fkStowb2jDAgVkMxyDyfCZ9SJSLdJ8kSJjjD8CBdGj+irV6Axw8H47Gz8ECoxRja5ioKiT1ZVqrIACJrSiVKNnZlWXeqAajcoE6o1RjXn+hnqCvVuAlA1DNbZQA8kLFI1SjZqhGgtCNWLu7SKOvkapRqOkGo21YkWpxipoxQqoxmqFaqjHUjt920o10irVWNHycJOnpBrdsn8rFarRs1d5e+NUo+eoRm8K1VihplCNFXPCP51q9AzV6J2IavSmUY1VM2YNfd0KCJnGbB2nGltpdQrVWEXrrlF4CNVYQSNnKxK6WZqjre8VHUla1Sfb1J8zlxApVDLBeJhHIwSCovTXNxUCMHXQi663/1jFtN7NeGFdKjz03iti1Oie5sT1WEnW3fIv3GCVdjC2aIqqKbUKUBynFPPAxdD+RO8J+kpvw2eSL1ejXkjk8ibTyZbdyt5eRqpRJl8/R4Y8LDlDx9KWoYFhsEZS3c350hwURIaBqn1UDfltM/a5dD8N0qf73+z3hJn826Rp/FyWBC+8LiivTZxfuU0I2cTt5/MzYhMl51d3t+Hk7pbjR/a3ugcOrUgxRJzwAfX+4WXogh4ijqocP+vlr4qubdXmt+5FU5AaqBrA+LNJZpOxfT/7faRr0RSuYYN5udy5reBl0yjG9w8SUFBpuWyc9PoCpptrTkvvFbcrMYHugKktV4ZZNDkiaW+Cd+e07oEiMzpRoepEjd4yaWIrJUNvm+Sul3SoOcxn3Q5sTm9jCvNXzPMiqz6mZ/DosJxcrriVi9CQOutyB69U7WIs3m0AVse9hDoU6LJjqoKdR/x++/m8BIEgBO46KGVQoWsd4IZJ8ylEZxb1xsainHcsVvrjgh1xGSuuCCuRVIca1ZKMSb5siyiYYI8CpVN0wW405ZZxR7dNTcR0OeaIAutloybh+h46gZIvuY0WRVFfbh/ith7xowOlfX4QBovvB+srapD0KpwSOSYwe3iszAomCzdak/TsDxCpRyFzggYhat9NoWWG5H0P3hN+T5RaAulvEUjL4RMIYEzz+BjfSesM7i6Y95r1fXJw77Bo8pmYeuSLZOQpMi55O0eAShtHVGW2Zpkv3Z/KWOYJHmHeAGc3O8hb9l5pg5L9/e4L7Z3SVK8lXa7Yonseid5TiX1TGUuV2HdqLJMOQ4OcXL915Nb07UEAm9BTzwo9Bm4RgTxln1c5JttLWspjPA/hLFxu562CyOBSRAgKf5Y7EsRJH5NthOTySlKeD2ZliIT8xcAS3OgqdZNLlkimoL25AleMuIaT4LG7aIyQBN8F4Zmo8uaCKupN5HpLE7RPBGEBNYEs6ltT1DNVvBDIjw5m9nfCscZACUJyUtTh8oZ8xHQJLwwoU5yOcIKrLk6+U4GIu+qCIqHR76xLF/V1vdLkE0IjBwPp2332VlN1fAyPLhS8H95YwEiPWGtKRt+tGxf1jxeqvmxQepBBQdBhq372oPnMJOhDiwlvdV9OK2l6S1yRJ2yr3owMlRkeFo4cQRP9e9VDn2R4s2YIRpTtkKGWvgHK0bFdPTN3dQi31koHiEMFZoxXHdZENGg5IaQ6H1U2qMHQgtECPOTyEzQms9tRs9zhzxPBFkxkzqdta4glISfLyWr22k32R7LW/30Qu3U+tK184Kyvw9VIZ9s9WMd9GGAd5/L0yuTUG5J55G5PTiz1dWmGNEmu3UEiNyivMQ7zBpZGvfwL9cQpEqYyTm9fgsGgiciU7LeXsoMftLpB8RCrEM+u9cHA3Jf8wsVI9PY9Wf59nuWPXkv2t9ZkzRdwAekLZ1nKifg91eg3ldFUjVbaqbdCJy506p1QjRy/EaqR9nseUncX9nbP4yFX0UWgR/h55IzEmotY/Yyi7BNq761movZIZo3VbWs18yenZdZYcPJh1bDVGKuqOnpym+BasZ8lzdG70uaKdIXSat2VNxloJZN695x8mQzD7FNGmovke2ulZnxV4xVtU++g6+mBCQcFgW1HiIfyasB1rSwHuodSoaJ/fZjdo8sdlhQItDEPULVj4gJUlq3zOPioq1RBz/AjhheMDcYXASqjPsTUtej6CC2qXGtiPqCG8i/t8dPHEb9/QO3zyuFYzZ7UHyEuw6tcWqsYHMn+HutM+hOuda3C1/b5j2PjHm273uj5kMSUogaY0CuR0FPcpNqVI8SJj1hDtUI7qIw76vbLT/3y0yISsgRLbErFrtP76RPfwzPln0UBNJ1KU5rHlkraWdpDzIPSImIeArPxKvYkEbgTgRFiGrlgLL6fg5Hk2NJaxjFgGVPR2NJa5ez6L8gTtVNtDDFPktYG5gyYvP4D/2JcrGV/WjGZkeACbaTnQ00urcnlul4krm+wjNRQ6lQ9PZXYPS7yTWUkSWRETUpAuMk7sIF7LINhXpesSrPUT6F2yHW9ztHSMZCNVK50usNL1S9BEabbobu76IChokBrd9Pcvm6UQsSPLnHgo/bQTa23QM9HB01KUEuXD0mwaS3iJNYijj1SaxqLOH0/n0FX2jSj/jxbE4BKx6CkY4lRD2BBo2E4s6+4DS+1e+5aOIi28PHCPibCUJjFGFtAaZAegeJ0fD373/gQjr6awGwMbCpMvxoUAlSPlYdJdbbFrJefJ66A6EX2fs1w5noAD7gugWaDPxfPl8FUnppdYqn8VVSD1PJgUL3V4CjLf9o7HKSvCgLcMSunGY3dy01IzIlPvzMW8R2xTBUOCXoFHNy5BunQorrNQvrRRRM4ZgP32sADHOhf7z/V21h0MoG6kQno5fUFyDVlSWtaj8xqsLNVPTIXDg6x2B72289tB5gE2b16a4da2Z8rBVI+y9SAD/BswUQPLsSQbtjqqVMZgoNmTk7cPZ+wT9MM3ceycPVbauVetIH6f/wGnv+It1buY4nPPmNeYmvP/uf8UNUbPPgqg+xrF6B4dxNQdBCSFUMXicBdaakR/LQsUgAll0gnCzYPuNQT/wDFfHLGG+FnXnMhZ4KmGBhEvlWfKG8NqbGy4djM4KLRJXBImoKA3UYcYm4PFbxnEYYjZC/ANXtKLxq37lv6j3/5ll8K/vCiKwE2xuoLOSdGF9t0BqDcGVEDS0UyRKHDCivfy/5CMVztLoUAd1jtpQN7LbtP+Oq/87zoWrn/spj7eB5dlOtijF3gdrI3Afx5ZNjFf3Gabk6op2tmmTAeqJX9vaanoHV5yTsCDhuuP30AHHNQdCsLf99tt+Lfb19c6kxesHcwpKicmUOKq2qowztUGT4cFmK0R4qCk95B9fth+l/Y0L09a9XrpXai+IrGQAXZUcI6D8Oraired2fTzlQPWAO1rPOvZc1/cOj4dtj/dazS/+wNx2/FFr189wm8MCQP/75xZuSlX/Kj+nWBMf+m1vfhWaB2SVtNrfAMO+Yd4LLurx3AWQBPX1lyPTEohAeWQXHXaMgYykjZoOqvOoTIvnTQ3FYUqrOh79ByoGn5Zijm+KIzmZJBr1Qb17qNuDxgMlbJIWWsyjIDvWSqq14y+ZJRLJLOiUZHh2azf3yDtATQNuE2zcupI5YdVyC1+I67qcO/pjfUA8r+4Dq5SKUdMbfr5vpHXwk1ylnEzZbaSf27OJbXT9xraoDevoSiZyMp/aOo6RujERH/xRwOrw11KmApmbIcyWIzOuEL70juK9UPMDoYnN28L+qP8oKQ6D8rr0+1WdkYkZWqTMtO0aNsFqSqvNoyRulapdKGzbmHHYrNKKGFAVclvmB+jMatK2PGBTMX7LjgLDA6pQ7Lq/kxM6zeJGOVGhilyHk5yJem37BwwS0uuCJM/FLR25+v0mK+lRbybVMrz5zGtTSftoHVWaJVTL2twJBtG0NoQ88ystFWqNsgFvq0s9xkmoGAeSnfRkuikyC4sijn2NzuHtBgiVFtDqfe+TJt4VCXQ11+zg9xKNphzFrhty18Kj6TI32F0XqQr1APBS7fWppZAni69rXGDlEzTPpZWO6kWaa1zQuUI8lg/ZgyjmnwxU3EzFAneyOmkiurmBGzljOcK7kALE2rxDMn2VUrvRS7pPJmcV8R/ktR2BSUdsaylspb/ZvuX5S9dsdJFGWfc5w86DseOBmqP7NIQAKNIjmS8R7ad7UZBnyjyOVxVuUbdveh/DfF5YYglg0B7D7yuzUIX+4CgPaaWVNiptZjOwEQLHwMm1pLHLh9qdTvkX1Ap7oPqLt9QGL3AXW7D+BQIqbU3T4AUkvZCXQuNSx7BEYHGj1tD85tZ07M6YO0cVxex/f41nSWZsD5a2/Xyc/+Et+Qmk1CZFJk7j65to1xH8kcP2vj7VZBL0R0MGk61f2Bl2JRQHF5VqnPAfF+AeKcnrkAa+eGowUnYwXH2A8l6IKz55xKjJNpNbAfahiZ9nEGoAJ+vwS/fGTxzsCvrjxGzHhtl9WfDCPgvC8MrlXsWKpaTv34Etwc/RVahJ5QhM2inoHejWciBouOLZEPTY2GCPjypp6BQKMf2haW9OKgjYtrQ1UAhzAzVvjWwM9MnwOK9LoodFTkmnEfp2FI33tWL5+VUruQlnYA+lmU/q1mtz9ny/fykGYgV5VVNFTtzg4ei3pcCFSag5ruOgV6aKoWLxcoQiBB5oQ1OSmyOBMB0Ev4ZEhLGlnK9SIgUkTzGO95XUt1vFGPO0QyMe4AqSkxToDZAQZ0KNPBNHQswJsepmDHmzgTGxRL8+wxmJLJqh0FFBcZIxkYOnBrAF7219oAHnqLGK/yAyWFI9eXVVxaRj0fx42V6yDfDxPBk+fUECj5hh7uUu3D1oh8I1QrK3YeIS951eOvaewENqhe9gXNAANkI8ao5FZV1eV2Ea/nfrVKD7sHNfv+4CJxauhOW9Rk2t2hF1f674+KR9Xrd7kv+f7KRThsehyQKmrr+GhYvlUUh6S09SI4QoFLHhahg2FY2R7dATFJ9se6mSVYwNMXFBMOj+SBTKHqhoZbh6jqXunW58vMmC51BPQc7IYyJJv1gjycNURHTB/8I+SfXB8AZ225bNHJ1zDENUPbFb/qHFZ7RZ52R8PaD4Sq7Q0FhbRlobR3QKFpIZrqUTSomm+geKRpMXbJtml1CjGz9E1PptC6mFsXQjqKLeYRCgcVSJJXRb319DlQJt7UN8Y/vaG6J1SiLYm+sy3r9oWP8CIL9qjX4nuxSYkb3Pcv4qnb9GER6D4dGEUhDGRQAAMAZZ5jnEcsnkoqgH+ByIiyB0Qu/VZIqMKKqUmnnqR366osP1fNKF6ETpp8R/ajKhNQh2zVHXgByPLflT3Ng9NHB+Psn1G9vYrpj9nhQE2Y4ioj81AMD7trigtq6eoomdBJ5HTtoKCSU+UXapSTIvhQ7+ILl1lIThmRHR2uD25FeX4ly2R5PqwPanmZKOrCKg1+nsDSKOQwV/VrmghTOWcaZgZPAEChYTwIWX8UnjP396DvB46tzcr1vZ/kiWDcHFgzmHTMG4jj2sC68Ltat72G9L6EiHssK/wF5UoBcLljgHUFoZAiE0rABnop/F2+2RCriJLsby0zgQnRUu+ZHH2LWYRaa6UrzRE1IkyrA1pfDU2EFFG8COQcgMJiIlvVooFGlg0E2Kre+t+d/R2KthcSIgrhO0DuaSaqzOg+hWCAF+MH8EE1NkbsF1XlhTxUHKhyYrlzzkq9Ac/zXq7yDFlXzBSF6EIADhiLCIU/IZzRAu3ZQSkuCWQ/iV9skZm/V8lbMJoUKDW5fKr8N2RVf1gAw/MF5vkypUKHPFKNO7VIG0jo2cRacIE3N+lJF3U/W22oXAJKbQgZWDxQxgPcbJWkfklBK/n7iQj+Adx6HwEWxST784Z0Va6V3y8cYlJyhyheazlLDCXNaE0tSlELxeJiLeSqcGbw9wL+tjq4wSdFRlz8LMIvyOeoxdttuaCDHSPYnuxSLmP2udfoPV8gIqxHx8argS+C0wW5+Y175GLlwaO6OFXgbL39B9ZK+1mL1JDGcgIXc2lvjdiSZMzneoH4grrZGd1HmeSbfaYih5pgsbdhE8PNLUAMrBfVL3eQrlEz+7LMlkWJ4kqKBUXbNsUHUCeugClf3+IRKLe7OgTBS61plxr48Owf9KDFoeddsbd83aSWRg0220W/2hM9bA86UbCdK/2gECOR/SMKc0bEDiiDqPnJg9+OIlaLevwAhyo8XQgLBG+EgAWQh9kpEwkv9v90fYltocLAU/NaNcU2kFvBtqBEtaBsQVKI4Z3sQaQUyhcrl+yJQJ7q+9WOJ+y7q+02ilSK2cTEC/8HhdyI/1Hg0D6F/WWoU17SQ+0eRtOTccyjCpmp4roidssgdhsIbJE6VKQ2nYGdM7OkKkIHDqGl2R1tdoaG4j4O8d9lvNdRR05zuvLPc5vzBek4h/TAehESGpkAy9IxvYsPWSKkNZDfL0EUFDIoYL7gf9DCGv/mIa5or7l3jzqEXRdGhhYoFFiENH9Jj7qglkZkykmeJHnVpCbB8Ncsg2nZ6POqIiknFil8XmF2iOmJJum7gy80rsa82y4jZdnc6NfpIpPEIUiNWjpJoM5RTpNUd70z5Ok0iSjVaaITb3x+xBgCnR4BJRijoLxGnHLYEfQ47LC/JI//FNXzQAc3VBSVBkjpQFR1G6QZbOuK2KALpDZ1NfSMFQRTBpBV/FFRtHzxPWqBp5Xj4CxSWiiIk/2zTgKlfy30OICCDgaiiNdyoBk/ZsS+gV6PKB3rdcBIBBiGNkLi6WoGoQgUjDxOKUJERgjNIvLH5GoRSVaJIM2A4JsqzvVIvdNhLCFOlecMteXZtvruLXuluK6Dp2RZeiIi70gVjY3jNCwB2b+ooETKic0dIu16pMOoR4IGyHZwrW9PDz7f67qMems8DVjX/+DFgOWBd/44JpXaDvb4O3AXbrBi5cZlXgnqUWJorzu1mddOaE1NpMmdNezp9+eZTs42NWV4MRaQ87ekkhbVX1zE1ARGxNTA9OQ3XchAwbB+AhBYSgLZ47cPcLdnWfT13LYHZQH1BRf3I3b5BnKaUsYdPCDzyZh7nNN1adxJoY6ZglNn4KgScUyB3lUDp+FVnZxhEHMeRAC8ZWZlgrjESqCUVzS+IF4xzReEP+ELwp/0BcHNrvqCQIvB6x3fF4RvfEHo1+oLwnkq4gKune4Lwne+IL6m2wvnx2PCF4Q37gsioMS69Mj++IaqLwg0KHQNmuhKiAaFrkHOlcb/qeB7x2MD3x2ve4zg+73XCvh+djU54zr/5Uyszd9M6R7Kq6p0fLm2poQk0Ekvm+EKiZUFTNmyl+SxrrB1pxWR4JEI9091sTyIiExUdcASqJ9RBNsaM+NiOhqTuZhZnnlz/IeyAopFZDmfNynAuZ3YS1NKaTjGqO+/tFiEFHOxHxzg9X8RjMFyH/a6Uiz+cn6IxaNt1uMtVOOLX7irJTecArn45V7RhsD6ma+6OORK5+S+Oc0dyHm9x7jUEF7FXYQ1hLZyaFlC2zi0KKHtuD/1YoSIQ76EcjRfQgU3b4ds5nYQCRed75SXXF9OkZdCX06Vl1V9OY3m+WWrvuySl236crq8bNeXM+Slpy9ngoqa+2mn6+U86Cjiklp+Fp2pgMHL2bQLL+fIyxPoDLzslpcn0ml4eRIhIxVPplCe5/LlsuIptFtezqNz5Hk+IvfwD2+9iJ5EZ9NZiLmAnkhPQOBCTarRqYRm0JPp3Ic/63GZnI6AZHqi3HK7nGv4nIcSkHAWnU/ncWBy24cvzsbPefJZVpzPn9kWhHQeoRguH9EoALWforU/hfagbK3vCq3vAroQcU+ROO5YpTB8YApDtC1sJwqrcVe0B/Lh1cUTkfEsOlsbj7jd3ExXWI0TJc8TOI8rTNaf0Nx6DPSKyA4sOjtoThmILbjfuoW6iGSM48iWrzIK2VW9Ym3G92p+Wk4T/7jTZIYr6fw7mCbfnCbfnCZBilkRvCjfjselbY+2Y0oQF7GN0vwMMyUyLnDWTIkzHvmUyKpTYhtQ+UzaxjNQpwTjIpGg/xYObZdQDwgnoVWgv04Ybsrpgv6nW7x+El4sXu+Ulx12LszzyxY7F/DSs3MBL2eauVBB8l0TSH5qFclPqyC5osFuxWfGAkQDv1cq+G2HazedJSMFPNM4M/ChQdbzkSwI+ql3/peLq38YduDFE+kpgr0XV/+KPZwoSCjVKdKcRzb2rEl8N3PGYo3i/pMN7p87gq7n05NRILDWYdiTFF3thFPcn4Ku9GjR9XRg5ukWXc/oZyBJ2xDJeGGouupzbdFLoGdSCopoUWsHo2HIo4MnqM+ZQJvTiCmZob67OGqLINPpJVU9g8s5VdDqVDpDsWK3vOyyODbPL6dbHMPLaQbHKsizcwJ5Tqkgj4LunEk6qCA6R6mdAma3QvkJJf1SuqFjNwpZjj7r5CB7KoB4qoXsDkgJd9CZiGSAaGQKT7svKviHwcU2pFWSk9ICgDQnZKCZB+C3y2t1hiU2LG7g2New/wKBClTR3vYQlOxLAgGicCeijk8z9B4oLqTW+YR/3t+rizeGGepH/TpgDfUiLOQ9zsZvq1gflWDmitZX5+fKk/KnKLbmhtTn5+vky/eIaZMd2ODXdHhrIB6reJyqxZ7mVkXk0eVzTl4DLKCS6Qx+BKOL5qkjKEH5WUpCVuTlbKWjQjgYY8+0iyYx2p7iFs0aL4ChPLH+FU+l3fJyEZ0jz6ch8ukGc9yiebFdNPdaVDldCY4uUVwm05RNl0Szku4ZWUMvoqeVJOPCkRUxpAs1ry6UpkZL4p5KT8d3uu7RxbQXbxfSU0YL0FSQOVfALp0HF1hqc+4InXmyKwAURlOfoNFawEksiD5E3GYDOJ/+pefF15Gn0sPgpboZ9HEQGxxQGZ6K5TRBRY8qCJ8QxF3ipHvidDeW8w/n4K2m5Cs0Zwnie0xlS+FadvAmVOXEoBC3S52XuqvLIba5FYmn0e/xKZBpS5FV9PHxuW/7pPKYX3wEflAh9J/wg4q4sOIHtXsABgJF4H81v62dwCvqL3zi5z9RK72ivqTiFfXnkcKR/DjDOUW9/ibnFPVkq3QuUrm87FUK0uwGPCccmULmmt2IpDFfpq9GXC19t+/5EL4EFeFL6IQvEh3CPWzEcQqqSMYDtegwIEceauPRbP9ZSBdhngpTK7KVAA+O5QdyWhlpKFINuV3BcovAVhCYCtDjCclVsInoRZzRygk2Bc4Z7RTJlQBcm1tt6mZtDKqCqxNoPFz/2jGNB//x1Hj4c9+rnyyO68AV8fG8/cYn7+33RL5+UVC9NOBYJBTxqFcqiWVoceAolVT9+2Lg1b+vHlyPjn+MpqhHXx1tiKkgJ8M8ACjLR6gPwDeWG1jZx17rZkZ8PBe/TrD2fXpSyWkNiMFhKHnvNUJpDuC1fo0wEL6uhqBvQJWgPOyhNfFTO4JQavipYNGcKqj9V5l4sG3zhTdVbNt4F5r3BdUpyB4USAqq4bbTXQ/pzQCGIT/uR1Zrlc+Tg3YBRbX4L48Wj/fNi//oSPEPnETxD40Wj/fNi79/pPgHNy1+a81ebuIZf1DulCBkriyt6iz7pLks8fFPXH8IReh9ia0wMxvqx9lvHxz79FLPn7Q0BA9jv6MNy96IyuQSaU2wRw0I/TBiR83tfrvnGQjcZGwTYeGD+xW88u2sloKgqFIJ7bhkUXDpx1+HyzBQeVDcq15D+ZFXHf8ail9LZx0l69curEVpuiCToYVhgurKIZQh1ihVR03ppy/NE69djPy8osvvHvmt4WeXBM9d25+bPvGnhlVJ6zUQmN3pf9zE+XnNOt1S98c2pAy1vGRvQKs0eNO4T/UfF1d2r1QA+oagakG+DM3pvuia2CtEID1C0c3Zmi4xAKcqb0r7JQIhjkt1UITSaX4Po6MPLBuIDk0U4IHY9Ht4xE0NBtzSGMAGmZS1scOPRd/XItV3nxSpvclu02GV+81656WCnjeOoufBE6PnQYeeN/6roufhE6Dnz2Hlm0AQewLqXKPpYVEo7GWFTQDA5AadurIuAqxldYqI/8q1LCj91quX7+wn0KgiEuymWBsO5sIgY4RaXdWxLGPABMPGxHYZ83XV8vFFS5crKbR+nn6rjsJDLR1LFyqRGhQOeCAt+0k0aEWQQ/2UedUV7Bak/huB6k3faKD6seOC6makCtF7Pti56dZkjfVH3dTI5BdXIfCUJ71FK9IqS9GSFx8vhbAlOt15Ej1VajHH9YZT29+/9pr9nKvq6VOTWqVrT7CInVqfFX8OMf+rC1lROX7krU92vfZFGqEz+9F16tZv8E7tELqm9vVw9wHu0JELmTJT8vllk0K4CMNKob3VSDR19kbkNGt59qfKWD/N82Gh3pNmo3zlTJTeClJmP6VryxpILYq39Ja89Lul8Pukm+p45l4Jr64BHBVvlOLuDj97JXiW+L3DB3AKKkskq3Ks2b80kcXx3tpjWR0HbnU88u9udRxOro4ng0XP8IJp2BBo+UoaCzRgTYfVoURgUUL5muSxjNzPuJH72X93I3fnoxu5MYb15yX9uZsyrCSc6ep+YVup5GB3Ceuqk3FTnpUey9i+3Y3tL/67G9tfelzG9h2S/h2jY+u2IjKEGFj1yvpsGdiL8HNJSWXJnz68j3nqvssN76/8uxved/8bE13vsYzcr7mRe++/u5F736MbuZNgnj6wOfN0rvT+ImGF9pc2AHfLKJNwSW6+oiOwq2lGOnssI/0hN9If/nc30r/+9Z2jqzJ63elz9DEvnr/lRu7uf3cj99uPbuSa2Oz8rsS+xWP5gIBT9J95+44TGxTgNmxw4R7i0VUX7yGJA/Q8VsX1vl5ZVaE6XihyzqLR/bpQ6DCVG9u4m6JLrdVtL09WBHvEIbs1iu+bXc/RWvoRL4Juq8/j6Tljwg5Z5BLknml3qAufb1HvIo/w7Jpn0lezpnDLgnpDoAKa5vEbxxWxQYmYIjy0cf09aFb/XAMjzes8uoUW1EH/Zch9rWoQVOzrXn6Sc+Z+3EuC+wG3l3ze2uYzqPtYZtAfuBn0h//uZtAfPboZdMlxx9GOYsKn4qQjGeIE9utDAT/lxu+ef3fj98ePy/bhT0+wNbxENgz7ZAexW/YOerihZxuQ62y+dwgfy9j+bze2f/bvbmzvfXRj+5TjcaAQK2ZTOE8drKOPSbp2nxusz/67G6zPfX2ZyLNUMDp1CXzsp4Z/7Ubu8//uRu4LX9+RU1fr2ddJLvqAG7kv/rsbuS89upF7+gm36Lv8ox3lXTajlAf9xzJq/+hG7Z/+3Y3ag49u1J7Ko+YUu0S7DgA1CnY+rBgWfvbPWrhlQkzjXzrNZyhy9Y9NmPZG7Eemxu6aFrk6EemGsm+61cerj5O8g6o2R9p2qMipSy5BDwWZFhvgtDFJf+NZCexTP/G61suD6+KXV4wWHuPT6EjrUbtYsPyF3t7sU4TBuYmfUGa4UZ/BwKOIU270ueDDPsKn8xOGcxA98Dg6c8FbuBEVs0kCYTgYKur7xP3fxj+y2U2TYefefV/4D4j9g4spKt3J8C6Y684TPA/5eQN1e2taPuCVvUa63sxei2eO3fGDNaTU11iNtWipj55bghcW7QPQvT0k2WYEPr5cuteYDkXiSJyC7HWIgO1VfAsEqVMMU+BR/3Cgdy4R9CUIdfd5aosPvcVALHPg77JewSNzqezoUxz6p+JzeH+x3PdgzXUZ2LnU54CqB/YTCnt5VwwfLj6r2GLsuM7LTRpPYQB7Exm3BZM2zV4vwAm5Z9AE7VYstEpd+ZI8a8UKJmuP+NHKV/29CMCGgO60V/t1vtVGS+r0lLg5pZGggfOV5qz7S5lZvhVmP7WsrNiOx0JBABSHVvNcbqOu5gU/d3DOkLbmO3HxId9GYb6TtqNFp4zcSi2gsX8qbqXuYBXB/DTayQFW3N9Fp/J273S8cgggxd0zfmXaGRyAEj3uT+zMz6Zt+TmU50+AGEU6MwcHgU8gUalvBnp7YBZxsDyjMc534G5z62iHKlvvptNZt/6MnLXk+XbAmfm5dE7+FC75lfl59ETuzpMYZE/Oz6dz8z30FKltGbKJh2tBLb+Azi/DrO1ehp9KYRlmuSydj1DxNFrGkxXzH4Aufigve2mPPPuIfAb/PJxiKPA5XUgXIPZb6CJ6KgL7ymS+hFI8s8zzRaju76U+Ahci416K+BbDwOdSv+TR0+jpSHkaPZUu4sCksAefSAUX6XdB8XT+zlb2TK5eytlLiEYJEu3a8C20DxXo13f5+Bo6/c9A5MUaGRR7q0VyKjJxyXunFokbCdotfH3U525JR56KyKdqZFBcVC2Se4dM/OVFrkh7eWQZj2U6H4/zaQ8ee4APwPfz4BTkvH4MJXh6IlT/GR+eJM8n0ZPlyZds5HkuPUWefEkRE3A37dAV43TaBcQ9A48z6Gw8zqYz8TiTzuFrQYyuT4D54ifQWfiOb5CN3kU9xd1FtZPD/+bk+Obk+Hc8OXADtcAN1GfhcSkWCyA6Lv7phDgd3yOcyPWrszEV6FkHUNxOrhOhsxiDv5Xnw6k8L0579HOCxufEOYz9pzIczmIYnMn9P437fraZF8+k8/LalLmxK2BkrsyNWmVuLFfnhkH5i2jZzItaZV7YAQ0VD2RYgdImXmdcid+C3MDpn3/28+7/oXd//mL7LJ7GWFA8nXhiAOHV4KJ9Fs/gRMEvLVowEQirsRdNThE0g5MIpZbT7Kl2uiC2bB/16ak6XTSzRu8y3Xm6VGtnylO16gulSI0cRetddCFKG0NrRd3jY/cuPHbRM4HdzzTYfZ5g73mPEsvPodOBergryvh2Ft5wG/4MYOlpeDuNzsbb2YzsBGT/Vnz+rfQse3+1wP3Vs8EfAaVH8PxcweizD3Ct/RqwnnFwJxeR508O9hrEpCcz2ib5U/EEYeWMTwLa0W5GySdwt87NnwgERedzpgh5yIi6zIh6PpjBCmIuVxAznIKEin+OBFcR76klOdWhs/S3igEcjVTOe8HJjhlGaY8ZpV0CfQwdns+cHDWA9Ul2VJ5Cp8tQAfK76Ql44xuDeDuXxzXDsJrbrmfrBzkVdMqLCv6xt13hyjqnU2gH30gH9WDoh7QdF5y2E+lHPR46Lle47lApjFIT9tj7e7jSWlKUOY09iNjpay8xu81Dv8S3W8+DBSewA2dgfM+jMwypeyKn8+NJ/DgDNBFxT0Y60CVE15j1RrfPQzY0erdZFPKnacDPn27mU26WID83y2KQ9zXg58+Qi/XAmZB2o1N6Xbm6wqMhRXWZfzIiqmv9UxCxyy34aBTPObPqf4simCzexSW0S14uNSTw2xB5WbmGVVf9Z9tV/zk2+Vxpml1tv+VklnNQNMciXErfVtKufdSv4KZ0mPZpfl3uba1P1FovocvwrS7Y9Gx6Dt720cVTCrH0tFLIDtt0XcBl8Xdr/NPGCwGd1AnkKKubQJgroZkru2VO7Lb3588w1uJ1q1jDzzN1STu/zxfL9zNpmNmFC/JqZfFJnLBL7QO2cYn4fM7CU+j8/Qhd1sPEUH9/T6RFatP5vAE/gNvPtEvveL1Y+Afi29f4gBXd96wxgsr+NV8G0VHHrbXhu9WtPK0hAj20kdZmurr9R/evY0ChE0wTPKXjQgzORwfPp2daK5pHt8Bc2wJ8Hy/QIuR03EJr8Q228GAJk/9gORFPvof77eTDgGI2fd9PHQBmSeGzYKQUq+TDlCNcwo9s/Bf3FzXd+OMqItfPAdn4A+7Y9qusgRtLXWzen4lHK98CuRtCxRaJL57JZGV/X9acLRv5c7mmJ9NCvkdqw8BRQKtMxW4JDgjErOuSo3AmGt9+hJ47lEARHynqVK9YFH94Ib8QVewtlHqej5ekeCKDF6OO0dG+M8QDvdwu01Ynvb+XiS0EU3R+znghQosLhZjLKoEZBv4GJY9KE3ZxJpA7Jetctg+0f6ag6iJP4PihYI22XC1Icr4in2nGrhLZONr6zzqfQkRzEcucRDHt4SbC6O/Q2Nv3FHdC59Gfq9b+Am+KXRZhQK+ATU9G7JOtGNChyAp1Ra4CuJfSlC0qTVk8eWnKCmREHRWqzNOiCFW6KlTplkKVrhOqbDFCFZirnv+mUOWb+8Zv7hu/KVT55uT4v3lyfFOo8k2hyjeFKt8UqnxTqAJumTo9HhgjXek+LtIV5rsZBxb/9aUr35SufFO6omIV8mkrT4BnMaYtGQHLE48vYDmPtowLUWq8Ri7TLmN7M6ZaRWYSriGiIkhxm1E8wmlyFMom5ShLsi2GH7tvhxylDXFKm7Yiz1Zroz+iGdUMwT49+xoUaRQEmdphSqE1tCCtyQai36LJYSU5qSbDDX7/o7U1V6r1NglPBXv1syY+2zfx2erEVxKdVaLVa4NTainjb1T1E1aRUUWcE5ipmnDW3A+Ob6bqEnyt6u0HyvvsqwfEYITzDwrbhtkb0JROOhF/E+Ifob2r41gJ8EetBATWSsBrHmdzJaA2mERqz9EZLHnjCdw6/2kcw/dknf8CduJsr680Sr+rcEYar8lovAllqQ29QYzf2+Oivr/fEDdDpYPIIXxplF75BnmDS7gzFkepTYrQpxQPeFBGglplR0woThmivnUuejhAtXWKzBwtAn7pFJl99QfOjVkxi0E8UomY2/dXaf6XD3/t7zgcHOHW/xharz5LwTEHAxtn21oGpIeHuW94HgqKiBeyQDwW1fHHtv3nleYsoJ0UXBDcGfNTW7wgHj/XCjiC1Nrq6i/syK0XBHchH6ck4tMSMRuxQoH7rZb1m8jfEQ9nHenllQUv0JHgKAcC495BzfoSauG4BZCLBZpXctGgkBKao7kB95J7PyzH43V71x8KikXkrm8UwfqA36K+32fk51nOHYteymkUvST7aNW6oXOsSMF6HmCwumJTcd75B1uSHcqC+YCDSJeBpFlui3zEo4mRo6XB0KLLBweFr46fh4NiGZBExpZmzLv8ta/eoKWM7nA4FCjCvfYypZzHjKtBpuxmvDl/rx5gieYWC5cqua24H14Co/KsvEMLed16heo8U7JlDPFMvx7BdudyP9aJcZ5/p45g6UaWJw8m1yOnIn+wkBo/CddGPB19fs7ze2kO7AHP+QMTUhlO9ToWsfWUlpLUVVTCQ/ZmHua471EsWnTxebKAPSTenOKNdeB5/+lrRbKx789/aOEXv/XPfXbgyJ/wzrZoZA+LubEmf/AAf2DfU36/r/LegrRdOuemYN4uaQI1Nti1uormY+MMhxpVD96eeMSZqXw/GOrAi0PEYpalveXQyWxs0yxP+7KE7+XKZwWT+MlIihEKKr5XO3h0yKuMv0cZ1uhMxjPs38WYn2Z/pr5wKFQAhgD0Ar8trGHI4RvPyz5gFAVpTROSfbN/ffb1t/7kNU/LPoikfI5CpDB2DDwKoVeZHdVvKHZxijFaU6Y1wSCNaPHOwUv+PD9WwRXMofGL/DiXWQU9O7AAr9MyuxQPqDUO20AFdMvtCtw8rAtKWCx0PfIYEoCWNwmtKnxAylrZh6Qbc2wEJo/x2JN3OOlmD2kKui6ia7l2KLjLoy5lcI+zn71HtV5YrKwpqLMPoyQY38/+HN/JV0UPs3BVTwK2+uIkCfJ6sGlo0TZaQMp2WsIDhtJz2lqa5ifedrYOrCFpJ9Zz3pjc65nAMRs4agN3eQKf1X7CS+jkPMpPgWlqwGsn5Wt51oe9pyI/DRQtP9X4cFKkiUEmOrzhgOPpWDYJdJoJWPaW02JskWJ7SJIJ35fRafI8jU4V15G0+hwkhtjPePI4iu8ldEwf9yICxz+ncD46hYseeGjO6FxSFEPbxL+8Z11TWmvwp9IqACt969CpOJWL5bOOfkKFPof4dpv52jLfq0rGttMOsxav554WdRpaQqtC+FFCkVGG0jwBCMo74rCs6o87R0xOBR6FtRS8IhWezFDSVloBc7hzTcbmtBMPbcFDK2N6ap7JmBYnGtPiFDrlhMNZPJZhnD6Ep9khPA1ln1YOYUGrdm5Qgc7H+3XWnsoNNqMZK98UYBgd1F9moR6Sx25eb6OATuWMFQ+8BZPOQx7SNQ3jhrm8YCbvHTJl5/ntEL/pBMakpZ3oPWrFqfMhT0Z7ibrZrxvecQ6blhyPhWIFzQcpoS1r+m2+A++rCJEShBgEAfinBGA79ypXSncyWBGTQYhCEGLb8RBi1SLEjjyjU81EX338J/qqYsi2xxFDCoMhin1FiSGrtA0g3k6rQI8OHKHtoM4akB6PToki1LFTXQm/RZUMqCL0H9DTWU863xlM3Akp41TBEC1KJzioGQN+6jxvrRW5m9nd83z0H+Att6DLwjHB962/hr2FAp+vBWQfkTXDxOiSlGa/oSurRo6vrtizZ+Q/v+/9AIJdA8AHL0bMi/t8Cu3TMqjNMiUsqoctYfeqTUQ1tpVuIcdiPD1619pYnzR6dXp0Nq2Q1pSs6ZS45mQcs4nOBOxbwwBuh4NpHkZHXeH20z58Ys2wheQGPxuX9bAjV5N7MBMO7wKEH/Y7+odoZfZH+M1Da8aOS9uFQjf2/egzf+Se/Ppkr/VQfv/FzLPvxrUuqjFwKm6gs49LGbFyq5cIV6s6KxcELMiBhKJEBe6hspp1ClRcEIBhQkci3fJnFGSfQIEXBM8zJ22B3n8K1EdYQj749+yTSovEyl2R4LFXby2ZDLnEJXkDGPO8PNYmkc/YfSs1cDnspfC6uWH6oT3V0MAGBxfxfiZGS3zMAZ+Sqk0JrfxysT/BFYt5C53SEXkbVsdk75BCzrCxnn1K4ST5ucX+WglCitcx37QSU4WWnbi9SkBB6VBT0SSoGgo+v+bQIFyTu168ie0f9PnaPipe4fisjLdxJ5LdwI75IzEx/qDnQxJhMPXeOYuqarhDr8P374GOD1d2UP89ePH5ga3UkcaoVMJRB98YQVhjn2OSUYGcRz5245UNhwnu2ruuzLHby7hMdwx1NATsUWU3EYFQQHB5r9L9IPsT5NOK+x7mUvanAjpO4/45+H9mph1d5+Ea2bV41mXTB6d5jZfHpUERv/QZDuiK/3GGxlr2V4rMGJ3DQZEIjcb604CzEHiD1XwQK2K5WchbIlARf88BNSCLaEA6MSzC8q4Y492IwGBGdsIbRbZe3is7keQgwXR5njS0CCmEgGZ2QBw64kB2BJFHBnmIbEk+Jw3J56VR+UL/mPpnmOWvYV5V1ziuD2sS/5g1roMes+jjCGXrBW+ROPewFFesc2nqrbZYwhIY4WxG4EEc7FIiKmHq1G+FFhk6Pbx0Zd3fWmIUBD2W7YUrZWoLT4LJuB2qZET8CIvcqpIV8Ak9lO5ADWwH0YbcattJq/kpwV44NKEV2imLcoV54AWzK0dgp9FyHtGSuIZf4kpljT2NM1GEdGQ9TeDAuRKsrYn6C+37dAorjfXyXViTcVB6Op3OueVNTxIU9PZZnMGpnIJ8/CCfi38eimfHNKRNy88yAwG/TWgChkJbgWzV0aDTuJGtG+7+7Rfu/m/3XWyf6JupeM+32CdOKE4vo3/dPhF9NqL3imzIPhU8JClXrHzvu4693z5dyg9cHZzz+i3r77VPpKA0TmM4nFYeFn/QPtEXdB+t5jAe+A9d+PieQx/4q3++8/32KV34yDve9f63/G3+dPsE5BD/9u+4/eBzX/mmD9injT+8+LtbBt4/P90+bfz/9x8+tHTgQ//xg/Zp45/9Xfj30xfbp8ajD1A9OHuikdd+4vf/84V//Nmn2acU8vnbz3z95z77nz9gn7bwV3z1Hd/9F1t/6+n2aeM/8b0f4sad8UH7tPE/82A2Ozt7/cX2aeMvlcb9xgft0zXyHOLx9MyEsU8ezG+fZLd5ND4JTzffUeyekvhE2g1UPJ0H7ve4Rt/E2yd/8+2EAh7+Dj6RPofOIBR0BrGuj35WST+DWjINZAvwJEbhOr+mIZ5ngVPn55n8zPh5Bj938/NsfhJPu1xkK8JEPEn2HtcU0Yt5Pjv9T5A11v+cG0qgCIWajep/nk51FqKRfMjBzAbnqa6h4bDIhvksp5FN4/eMtoMl0dP7c/GSFE+B2uh5KlJFu5jWdgxFY3dhFMlcxb6XnqJqo+fmER+TJ5i3lnTUHOlAyVXaQedzJkDk3H6GOjs4g+tQLmdw26igEGqjpGqjkTYgTyiX5kQUScspEWqvmqERYFecq+T7XKuvmYBPScoGuI2BPf3eBULCVOyVcAS1E61goqlczEJlsV2grTTzrDySg7J8K0Uqtm3oytcUJgut9K0o9vrI+VU4zILUROPBlvGFbI+fEZuV5ycEdNdSAo7pEL/ChveNeBrz0QG3GOHVIn6RHjEVEXMwL0MB2I8hmVM46iUopB+s8en3ef7Vwv8FB87zD2hOPqBawzHPCxgknwanSvEBw+A2lDtc1aV89wE9AMlj8ZWjvqCxHGnlSFNV2YYYBEDj1KS5nP9TqPbKxQ05Wu9xrciiMNV+dcEyytc9mM5+HiXg6b6TEvB0z6YEfLgUz582pFKUL6z0X4P70PyXSH7IL2XWeORVTuCKQFoTZJ/XD3b5V+eAauM8/yx+QADKjwQr83n+RQjq8eQeCX4BwXMleD+CuxHEnXXsORB8CLE7JXgQsSTBLyN2VYIPItiV4E3IsCDBQwi2EIRw21hyOEB1QdPsC9pU9EcTEaunr9rAKbGNMkb57ISRzaLgX4bTUdDh2nRUHEXBuIKCkUVBT1EQw6woGDkUZOQDyuggHUAmh3UeRdOxDuJA7EgcooVCbUpECwyiheQpohlfSwEQLTAbkUlEC/SrgAVMx0U0TxEtRPknQLSAgiqiedIar4powTcgogUVRPubxxnRfuHkPSuEI54VvE08KwTjnhWwq3lg1LPCD99Q9axQHkdH2Gr+G/lW+JEbjudb4TBSH6UPgh+9YdwHQVj1QRCepA+Cqx+rDwJvVLsgtNoFP9lp+HKiH8oxonddwH/WPEltZGet0pRnqzRln77t1bc9wNLbWHaD5wXBLtlF78ImGvs0BnN1G57hiPeCAGveRzArgRM/rntT3QXGTrys12riCzb/KNUdLRV1PHYWidqqkbNv2SU2KUCxoId1lJ7eNixaFwSEcikdFqkpnJoUD4umyGK6GnGkaGqVe0yNP6H7dDLfIBUPLbhN7cFAv02pgZgmNRFDU0poaQmxlmCbRqktoaUlxBRPLwE8Inc5sUIif+R4U+ULkO56acpjNzMhfIFBQLEHKADrd4U9S2hGMBKNydG8OuCGNgLIlJF/hNsYZz+JJigO+pQNqjE1NFLl/ErjbwOw9fuUWhOftjb7tJPXSaQJM7LgzEiLi1nTZtCj52KgfbS6js6+DLhG2ZGiNQKKmFpY6gS8RzDigyG11qsKIS1EtwaMCeWH3694l95RpGXnOUvRBAQiSke70RxozHQIpBUIROMQaB4HAuhpnki/89lURpxh0gBMGjRLAgN7iQ42HDkWVh2L8FnS7XiYz/GYyhwQbMrypgpMYjy6k9PSvX7wOtgUagGaKTWpdaSYH1IMInqkWBgObqN54ogF4nDRWgeeDynlySTVDmjuCIOYB+IOq6uCa36jwG1SJJ1V9Q1IQEfT45KFfz5epRdtCmiBK5BeDDA0sIjb5sbEKIDHZnxk4omR2WXBO6od0+gToBriZRzwHQAeGgeTML9IAZ+oZLbT3yNmiBL+JOJpNKPqggFxIHFIIA1tTTR085kgMjUd21mtkNsRMf57KLkrxR/JW3hmhEqP5Ckt5g11jw8FP7ABOq2521evCW1iROaZQHWdOPx8gcS3MdZHivjWUlNBiHAERRqkLxwp2kMGeVN7laEYnkCMBGMDPDqALWoDRTTvCQY7wGRjlBo40rNAKSJkAo4ToOZxCBCgpUN5UT6rw8xwEUYm1PGMmGPRK49IW6QOyavIApXF0QI/g2VQgi5F8ekWs3YFwnogQWagcBIhNwG0Wzk5lHOrLgCyjrnY2zSWl1zLmv2OH0DVrlyMBw2n0yN6ILegH9AjE63E27I3owiNUteTEyuC5tSM0LaGypryEpoK2o/jUlVp47c8kZS8wcjdFEyql5MxUFria43YouVRaVBaFzOf+O/KXtHSZV1AQSlHpFdppbfEa9SUFadNmB7UxsrKuIOtelMMx6HkiFG2iMwZWxM9t9t31TPQkuDgGsKEQ8Ic4mQP2lVfFxXK/i1aR8CBqgrlz2+uQvmvqsp5+wna8abHvx0ZtyMbaxNV2/RTJ2jTb4y2KdBo5SelEsaP0kq7n70RqYW/b7ecrSnhQGshePvxT556f3rO7AcGQlzggCGP8CDwsNqhAPUv4NFPtENQBWBs6nvCwPt7g70CVQqznxEWvsbUNgTWIZ8SCD4XzjHBy05QmH7cC6GWhz8BkjrllUmBPbK+e+RBJB+Sp+wxUosYmE4hyPe+977/U3/8Z9f+6dOuhLCKYsZ/VcgSH77uRBYP3qCgGmmZ1oVCddFVtieieqVEZFBOWttEUV5XnS18rz1zJ74CnUeonvgIc/9IHHm8+wirxO5oUBI7gJmFHAFQplwmsAr45RuzbpGzcxhVlFPuKOJBIZ2VbcQRLCggff6tSpLqADD4XCmQ6oPhHUUyyOsGv5MjRULxVbK4g9ruYarU8gCtu2scpFCPn0MIYvB3Ze+CYC9jUANDUud35XSkAU2OiMHoI1NN2DjORyH25xvoHYrv3wjC4vY0qe5pWmZYk6J9Wz4jVwxSGVmUhLBy6USYsBFDg9pHwByFNEMRh7po6W3Inpks3KJShzkvg0edKEcmhKdbKIbum8888po33xgrL9BQCk/RehGhT+h4HgMwJgUApPKj9wsY6pJdIcXZE2Svj7EBeZIqJnvlHV3An9OsZdSDQeHpcOguW9csbPEwbBjjQZ4gmYzei2lQhKJ0zFGeQpsasvZ0qsOXQK3NDZAbyLFPIs06dUy1Cypb3myEKUWmlFomE6P8v6lQ5i3feEKZO44rlBmoUObdJw+sqAqso7VNgBWOAetiHMGPwmo4HVYa1oUQcKNpcAv3M+hEKzkW0gPIVeAWHg9uAKrCBuBrKfgSfYT6ANzWjwu3tz4GYdaRb3Bh1qPq1E9PdCqqdio6yU5d8Zg6BYQc7VRkO/V9PpZHKP5Y+ZiKxvUETZeFSBqBGN4JW/7n6VZ6NqQQG69bpcmc3TFIV4ol6UfiYDcYoTj+JpPIH6c4OFB6cHQW3Tkyi7jtIKEqFPi3oTc/d9x5c/AxzJvrJ1AsqKJYcJIo9rKTQrFfOfnBhGFmM5pHPvSqaMpgap4Aen1uQAecF3vVwYd8N5y/NjKcdocU6R5pkwHt33/tC8Ve0td3YN973IF9nw7sd2xmXhxFoYcynF/+GE9ekLo1jBv7usTH2tKK1XDkXFhL3+8HIfYC1uQ5RricRpe1a+WBGenEwrEw/7GKlKwNvnBSFOBoHkLOyql4jNPwWOVQ+Og5gBwC+3H2Jpq0+jV4Rf1S75pyAS/Tg3yqybLRQSAwGKmv2S9ZYXxljrvm83Ek5jeq479yfid2fmd34XPtWSIFF6Fr0ERXQjQorDYoe4eOyBfDhmyjrgv1WAJ/kzvEcQ2+EFBVnPZeqoCsbRR1p22Rc/1OSS9vlG/EWpR1/J83eQY7YXDeEii2SiXVwZAa60XbiZD1MlE+Q23VBszb2S8rDMF2QvLVXKcZ/DdgGdbMrTRT7seGYC0dK96GavlC3tH9J5Rcu/rIKDCsWEtCXZlTM4ZgZu9EdfwasAiwaOPRpbbbLs0cKbLhEfRupqyLI1nXbr2Y464MuO2qYQGLVe2JBqbuqzlc0hsO1ymjbICuza5XNmLowCPIjB1tqsptNOOGCOjhwdA6lGeRPL9W7QuSfZpfo7aGOibUcmXnLUqBBKkRETnLXCiYFUzhgBFwrVX37+nbPC90VMBdbFXhGVRss3cB0n3d4sRQ6UswpRtM9XfLgs3hvjhqaEh+cRyfkcSdRY2pC8cqNfTumIcSEwhrs1+RajzszZloXVgL+dFAsbFzTfDE6j4bXTPrh1fewx499kknnRnYuYZPAWgfn94h3fCqSt9YEIBxEwzM6VJin9sw+LFXHdKtPmo9u/ZWvDPMs/egijT9nBeAFkbXVrRwdURZXh0oQQ+Now7ZsrkJ6OTDed3FJjItI8UBJSkVBGjolrGcpGYTGlMy5Icclw8quDg8gjkdD8zGlIKJDPIpcoGA5DFngl4UTmQ4wsPk8cQPxv9g3Q1xC5IHyhAIiQcnpjIc6agfIMkncbyRFSJI86ANIXsEuV2AVBUVoaiyGHUzWI4NbrJb/XazO+C8jk1Aeb7iho/cRm6dvVuJtOrDezK0P+x7Abdc/H0U/oW1Flqojj9kVT+71mp7xphXoNJu3dLwDENWaaCs4ciJPabHhUBoyAUiFEpEy9dFK1CNdm7Lr6ItWiB+wJPab/s1eWQb5g4+l+9p+d5m5afOLQnAWFbG76hs44SVaXvS9L9iIGtV9yjqcMU3okbAzKzrSEoU4cg3VfkyPDLi6sBEByzBJ5zgisfsRR0Yn8eneLwe8LxXKv6hPJ6PXZ7tf4WZ/YyjNz7tOvh6OT1I/n9tD2U+40nX4sAPbZl9DfIIgZEPAZtuKgXgDgy/Z2+83uBO9sNKBNL//mi44vdPcMVgBR1bjLcxvrg/jS8u8OHVzAOvPfoNGNjfkf0Xald6rlkCc7aU3W0mjp6l/Laiyl94gY8L2W7tGL1/vSATO4+UHmfq+CdEfE1SEOfpRW0POaQqFVuCbcZPDSwiUqbd5I4Z0GdxZjxXtZKLFBKZ6lYtFHXrThzt0Bu3ifCbvl6PMrdsPdy68qhuxFLVyx8Xev6oWNdXGPvZR/GpJmiqjJCDe3rocT5w0AvEK3KcwBlyrzxm+E13zKACwvGjj8AHTz5xywkVOM9EoXYmErY8Zu7acfARu+xR9l047lg4bu84HLcHBtdzDC5Ie8lZ+1A0mcZOR+V2Oaba2Hb5kdZr5USq+qY/sgEL94sDrVDHMTYqoDoUXC28CyXnm/y5LjjVzVYopeIR6sPtojEe6kwXxZTbC9DayT31zz+u2KFrob35hYmmEc4Hl+bwTA7gjzumOnaCY6o3YndtjSpg7Sbf3iTnxpm5i5YhcQ9+zt2Py+xWq/W33I2y0PjbUoUN5FS/whQq2oGlqKvB3yIASy+ZduEemtykxljX9c5HXDQ4t3iPqtvmeBTm4CB9tYcrn+Mn0KuXziSuOQdqkA+OWY6AgEpTqh+pWZidD4R+y13FIkf2DL3zVJwgtg8Cc+2/TppcJLgmh9OJWJ0xYy+Gz5pm3+TJ8GOxq6OYFIOEEHRSdMPcx0SBSWBsihIpo60M1owqwEtJneqVrwylJNTBeKD+AluTPMNYZ3LvEwpYojPRxLCYnLlP2CEZ0EbUhB0FvS2moInw45egDQDTwDqLdtt1q8zRVvoqoxZVGgezSpQqqW5K82axd6JZPjLJqIlTOk63p3TYVwTl7cK7LhpKB1gC+LGnXvf9bxmwe699P/nxZz3rH2b++0Xcq8xQfb27F8H2m/dipf1vx8Dg/IL/AE5fx0/VZVWrvIiku7F0t8hUWKcP7aTpcsxkB0QJXfYNKmGehU4DNXTT6a6TF1a1SlnVJ3/+Ez8/5awDeSZkVZ9AXm4bPz5Rc9Kqj2EacqP5P3waK2r2W5tKql7ywn7r6y2n+r3jyql+R4nls6vcSNXsVVCeNgMrZa47TNQjZjk+djsItx9UkIIB0loqzu1+d7pzO0ADHOozwcVK/WG1/tCu0SBpoLAhPilbQJHEoRqsHptwZa5Vji1rWa7suz1/Ul7nVnDrxZr7z7gbjPn3C0Z9CzrJ3aMU8P7uBCvbqnKyrQlGdnfJyIbZ7+PjE/Ctx+9ucvLdBeJVu/tX/5YT0IiLddUMdE0NIANBBEK6YmsoNHPFTNJYv8LDvoXTDtvMzP26Hbmd/Mw9bzNxjeOWp8lsrmGRVD/T0+zCZ+Dq7hZKaigN0A76T+TX/u6c+SxV+cOQPFdRQnf0lwpRR2ZOMfYK+MZQ7vEjOJCjFYFG++mdQZgYHZZJrgzNcoKh6RMFyMfgytTaf6Cc1aeVs+r7wsE940b4Oz4fedQcKu7Ky5WlCI2WTyhaA6xAMlVx8mqlbYra/wvlKeq1+IpVgXS92xWhVqYwwHnLatUVoaGpKSOg8BR+gz8W/QDGY3D1WKzzBnkbEAPLguZfmqeoF0xSHoM3UMiOXsBvrhctFf/KUqudVusnPrWyH52a4pHozjkGwV68inQwIk6s90On6g1e1G3JXu95Kk/Dws/T1Ymkh+DZ9u14xptaR27/racOr7LKkjbLMc4yzMOKwScKhFX0qoavimgIphIYh1mzPix8gH9QVIvWZqe/GcW+WJDgFjmW8GCoPKEQFYgF7/yxG0QsyPh6JySE2f+WudOHoEETU+VTDkpV5B2gEAYGlEcRCuyb3Rmm66W9Nit8XfU///y6h3/6aaKEogbl5FhtPy6Xi2wON4/yRiXj+LFBE7cTNxz8qL5xxL59cDByGqA4Kq0CilJFkinK0pNmAgYXD8fNBAzkuoB0ZGMd4eERtXGBkczWJ8XZ4LJw6irrp4JOm9D3dLVV16pW4BOAFDXAl4WwZZZn6B91lCmwtlsi4kdUtd3F/6Gzt/9g7dBF953/yrztjiZaso9IK80a06OfNd3hEwXXcpql9AhVY4baz3xWeprPlQVefDT7GcHrWZc/YwNzmkFPBtaLWWoT/zE/3C4Tvsy12/B/2nulKnQnmMUxzeBWBgxiiCnDMdyxhPBgaOdUnL7BVzlHUDmxC92JneGJQxUDqGggUo7QM1fbHD/mI24N65AOCjJpFrx4euKm+ZjJtKUEmgUvwcShXLDJoVwIKQJsQfJfKUUIJw7lXMP4E20TZ3NtCteqZ3Bw2HytoS1mcIOhYihoyRCNrdIcxB3J7sW3w+Mb/UCDHonB1tGjixBM4V+Os6r3b8Kq+uqH+f1+FJhlTRvG5jYmbIQcbIy+39/oQ5wsEnt2T40LtY4UyG6AY7Go+DxW/Y3mmjFjMQB3izhGk0G6RthF3dtAark/LAIgqs9WQJxBFl20xoiTed3DRipiUDcqjcD0mR+gem8jD6meB3bxBFHC5c/dV28YukNhxWKJ0ae1+9MiUjsk1ab4WJR0xkiLMAC3+yEkZ6DtqMhaX6mBx8IToATRFXOeiQNSA0e+TPCR1CQv9ycPV1sgLGvlDhrkzqc6mpKigak20H1ErVvBkDFP08bsU8FPxHXIChZTk78RDUmUzG/9gwJ5vW4OA8TcEB83xn0cnash1DaOghOo9DK2CiCkyCojoYcbckxmNGvI15nTSG98nCWclgfuh1Xp1J8fXzr1r9SKz5ygFR+enGgHvcmZtnf0/dAzKjPt4CunzDSOLWfag79emzbVDv5mTefawQ/Xpk62g35lstHmk+3wxcNHNtm+VrtmYrZh4Z+cbbqEa1smZhuZ2fYOnW1VTsovncXD1ByXhriv46xDQ8dnXVzOuliRJLazLpoy647WNpt28fRpB4hImbCKR5tNu8hOO8DSLtyN9J2e54MZZqGZt+/lME/7QzfqsW+tNEa0XoYvqoQv21vlT6YGS7td67wae3fkHioavafqZb+AlmBIsx+22kPrR6gmn+gGgCPIUyzhhNvWH4nqnT+iehduonrnjaveQVvkoVHVu79wm2+33Y4wzf+NVO/uO+7++bO60J80qL4JqkclxPrchBDLr2op+ieppXjtY9XuDUclfr4qwj6qT14RhHYR2gAJRp/7P2AIt7orjLHXdDNZFO4YzqJdAnSpD9WHYFGXIxNIt2sgWEaLLgCrILRdzNTozcK+ivefUxXVqpW7TUW1cAsBrNpMVvt4l2Z1h7g8NROjGms8zij9b7V0I4zAlyf64ktTvvjFXrRyXfDyEUnSvdjoVOUBG04eIJuEt+FdpQGaJDuIdyGY6hd3j33xPvfF3e6Lj8gXht3BYq0f3zP28Ufdx/e4jz8uH4OFlguRKEMESISJmiC0ilADoS5CTYQWEJIqM4RagvUItRHaySE8z+KnHCnNgO0qlXQ6Lyoy6hzYD+OHs6hytZh7UT4vQ4z0BZrdny/idZf6Pg1y3xh5wtnUEkU0+2I436S5F/Fj7sB+sbbC7/P7qX6gWIY8BPRimTq0CJKXd8gHiviWz5Xbz2ZUaziO7OJB+RbpXL7SF2ChbSF11rK/M+b0M5gnmT+wRilqFPN1vqqEHUP+ooOgfFpE4N86FIFCG4NQKwCLf0CIG1oTcbo7iEypTXNrea8vaCGZMbsfQNUoVqLzNmiaJBbzfdACV/mqq7yOWt2ZIYz6o73L/Lh2TcQ6NXPpD5yVMqzUwt+lPWRUO7l1saRM6ZocMeKG/Qx3fw7k0QxsAftZGUxNiaWtbVIkbsIrn4ToUC424gOawyewkldsp20V08BRP3M2hLfT1pEkApwweIVvLrDPAWRztGSBllZrRAMIZroq91M6lTs+y1ocobiDnpSnflpp/lLjucv4sUgdZJc2hSzgiCYYq2MzDC5+zFlr9DBVKAomjuiSWptfNlCsHokS1XOfFNFJj1nnyDegVr6VHB4nY7bCZoD/OhEI9Fst9iqmWw3ReashylMMg9ukBmX6TUKz1jnWYj/kP3C/TTU6X1Py0Ja5KnNxoa9KiVuAiDg/J/9FeUPxck6oCINDbS7ls0qO7h8jR5925Oh+R47uQzB1+O7rxw+OffwF9/GD7uMvy8d6OW1JPzx08+iHD7kPJUk/vBHBtC9NAnU5YKadVCO9piUT5+/V7i1jeQKlYcLl8zgt8MGL2B9B26UgGEgQcx5zYMoWOWAgHFGKQ3alCrIjMWq+1YGlZcyJORXbpYhMjZEQWpZR7D9UkiilT4JueFULDSofjtAc5NQJ4mNSSgdAhedAhblVNIerr6MkUkoqOlq/jHukN4pv9/CkCKPbkQ7xNXUPlXMcKBlqFMDlPQeLVUwFQ7DyWcQfBMyLrGxfMT82tTCQr1iT/VswRRFsuxgtDAjP3eZJ5gmjCrP4U3K2yJVnNA+MX6VFJWfLQs7mafnE5Iwft3sMGTjhcWRNZiZ/Pp2maaZshJxl1MEWcg4XRVAeRoliLn8OU1Tnq9V46HE7IePkQkjImIYzQ8aWtLnUdqRNwkryZkHRZmnpUnW8CXOpOG5qObDPOrDPjIIdWMu1twxFS2lVKFoFBsvwcWOo2yzNTFI3f4KuzeQ+LT5KusZUq0LUAMCoAsBlWuIJGAGALQCwhV4LHXdouOjQsKU0ud/B8Zfgo4feOMD0HGBmxwCzKviI8zG0CX+KXTNSZo9mGRLT8DTfCqC0aAZ2dmfzCGIWeIOYnpdL30q+YNQ2WqbIouYcRldRiRGUkY0QUzMx2y1HoTavK/AD4QGmbDVYtF2wZR4YMl9iCOjWVBjMjcFgnmHwP9lB/aOZk0AW/DkWo0dzmJMtLOHLhsMLwNZRZ3xW7lZvBgHhhdSjgb5k6tVAX2riEIBw7GPmZb7diK8CPWaF4F4ZDcizPUThdZwdiaynAtVi0pUTwEzttNzLgNxNGt7NYaLNpusMtiUzJWKK9WKgroN4uvl0BKgXadlMx3nBtXTarGvJPB2ddRHjW4eU9BP5OvOi0Zm3OebMVxkJNF95BywGKp/KYaxP1zRBITflZs3SV8fSx81FHmA/2Hf9YB7jzU2cM8OzrENGIa71EM07D2cF8bteOzdLk38g74CEgA1UEzZ2aTSc9AL6smD2rtSULNi/ltYA/9ofuf3iT9OMDcyBmA7IiGZsqIdQl2mcMPnmSCdwRzoiC3VasCqd8bEbhziGE5GhFMeEpTiGCYQTx8iGLNi8llBrQZtGdV5Z7OPtl8N++SJCvorOq1zSr+q8YtJE4gRL7eKHomKvjxAPScvuq+i86i1KJz6BbHqKhObPIcw6SVjrUWMRT0LbHkqqPvBJQFt1jjFMDtbjZ4UoqO7uASWYQmGlkljlsTWKpZIqfLG5V/gGCt+Rw8wYTTEQdUrGMN+mAjGvfIT6qJGvsjA/++KEWrHeo50AsTu7PO+kL9FW/FbW0jesxMvQ5ce9Tf51ZlhH5Ra3jPHQN+FdeehbHA99M4Kp0XwY++J298Wd7ou3ImjlFkZEMvbh29yHmqQikvLDUFgNK2vIYyt9yOul+CApZRONUnLRVEGHYWxbpRyjXUo+Zkp5R6eUgWQCSIRmq6KDOflI5RcLvDNCm6t8OTWpTT7NvqhYPEAphxaZ5d5fLFHrRUXtgOprzIKS0hJ24EaawT2IkRKrfOEuWSd82RhJsKbnQzVQJ9nRq/LzgpMx1EDXucARGUODZsXcPyzSzvYxkvqNlTPkTVQh8XmKGSqpRbcPzy+uIVtcQ2KhjzU4c5AFK6GuuGvdhEVY4TX2IKYjAleb5xXmeTmlgBb+dHLW1sQk4hb1eLZM/F4HJ4vC0QlqVRmFmmEUkIgwGTakZtgEMuGaYUdaJZOwoiIRNUtGNcclrCjfUKsyCc61szAJjvVMDIyx9nMnhUHQl6s5TCZ8hTAIGr4cDIJVdu5aBqFrnEU6eDcdvBtj8AagU6obaMndKezrRxiEHqiJQC+uRKLP1Mh9agOg4GDJMgYUjzHoPcOgo1LBKrAJLWPFGGuz1TrpGhEDNiniykpn3rxowfNHMuVelK8qXqnEkRuOlNqL8u4jlxU8CgHBqhhde9QCghp1pwgImmMCglnQ21l7Xtl2exD1m9FW2r7Aga5O+Bql5VjUKmKBuoI90ck8C0SLR8QCbUC+TbMnIxZoqVigNi4WQK+k2UyUZkGEuFU0WxUL1FCLFly0KmIBrLwNvavNBBbj2JL+lPf4jFAg7zr2MHLQmAO6YiMmlnowvx1bPK+tnIr1tIrN2LL5aMujozbL1MWf0Bpx08r7G0FaWlCWNpbJ1aB4nMxASlBTKYESDRGStXSHrCNYc1KCuJQSrIxICTRTRisjUoIWNrmzqs7uY8yozqXPgtDoebG9UxHRAobEEZVahaiArEhraUspJNBwJnm72AJ2qWmFBE0VEiw48Lc3B39X5CALhuikDDB+zDoIxMYYqmL6JDFSGUE1UghRVwmRXuGZ3ZwEJWMkSOnfmhIiOaevOfDF1AQ7wBmtS+BmKSLIK2KCBYeUy0pFVUzQNGKCKmZucaDpjoEmUsxsi2C4jr9yw4uVTAjkNExVMcEy9sIxdQ1ljvLW9LwjYgJhexQ3Z0fEBIxtNFsRE6xYpkA3e1UQLlAKXNlq8GhF8EX1cUscmdr/2bH+12kVIoLuo5uRXUrxpyBrC8BmdelvM1zKpT+m2cey9Dce96Vfb5GCnHNadf2vVdb/zaaqKqFYtOSArv/x1KmYTpmKCxSbqVg3Uy7dZP2frURSmtcw5YBpMu18nXa10Wm3Oc7UdcIpUbLbbCce6FBGi7IWuG0/5lzDzbm2+uylROUEDckTg2RQUz/A4okWzuowgeVzcoIeN0GbKgLY7dRTOYGuVZATtEBGIAxNtHVqU9rKCYKKg4CfD/kEPWBnY9Nv+EExgqCLpDY2Q0QmcBieUGKUZ9a6HyIPzWpQY7gOC77JuqrBO4PBLig2GxPcfA4l6oq/eFZ/PPD9fWrs+9hH8e+Bi8VjNVSVLuOR2vfFF/zFoV958L6nXwWBQSz28Vob63fgpIdScWnd3li/vTR3iKt+cjENgziDkE6nSMTgkfj0Fp1ptFq8q8fEIeJAYrW5soqO1BV9jEO/Rtqgl3DVDwXUfhHsuWBEnaqsOsAsmqMaRL5RW7rZWqvoPAcyKLV0oTZIxN589jXLU0EzlxFFrJ8ycZRhFixgECLCgTgh/ypGg4xJFkVtLqjUiRoWiatX+VRUDSpvr7kfvJHrw3QxEdTJrkcUdKfp0YmPcH3zeAKN6JEINI4v0nDiozuniI+Cf3PxUfXKdHQ82Ya7Mv0PXijiiVca9UBQ3srUFB4skmcGpafTA8rro+qWIMLGE2f9fCHDsSHBET+trkk/kYsy3B8u4nzYOrWLB8yL2sVDLsxCtKAkTqQ38CNoUglo0oUp3U++WrVEgLdvLhKwNLtBGCgBidptDT4HoKaBNYxZc/ddvuAFahLKSmWCUidSsYzbIJp4/1waCD+7RrKRUSIUM7WQPZneLqb6fhjw/Kmr2GUiBFGX9ZAtGctWm8x2ALiH60JCBsppEWb/IhjmZQ/hiY8/7gG9PGj9vUon0fgnDyNr9lX8Iu1waQj0C4EPN/+2r5Hz61iH2ZsHuPlTeImEIf5gSJ6a+FdrM1Tv74JWwwYQnF/u9tdQPeTpkpRtXC/NpiB71Y3S8Ow9iKE6Jx+MxDsNgg+ETCpfjJtddbkIxw+uzu/aRCA5ypN5GEJdFrPuBhRZBFgquMciLfpO3MjApLgJFmTRvpuitexGZER8/yZ/TdI0/uj1Nv7gSPybJB47VCAuQ6PGPVceDRY8kHeX9u9DkhOxd9dc7OEy9qJpkbtd5IfLyJ3TIrvTPm9NiSxjtOl1HtXHdPH0/n9Nnb3/AXSE8r+HnO7CWWnA18c32O1uGHPc/gCM4+3f19ZrTVPzh5P5vzcHLUz/yPNH7yDGzq1p/xgorxXJAD85hCbVHwrQ5S7FQMqfukoo+armg8EKzZfZfK2RfIxFXPAaWLHbv3T9IS4ehgtiIPGrgZt6X/l+T82z3IsnF9a9ILjHE8JZ8zFcX7AvGb885FFcvbL3q3EEnUQYiwmqwmVPc8jYcA163+aYh2mzikmTHdjY91u/tvHG+IHz+Fr/k+XfH108MPZKNoZ9BvDgk9zm9YrbZHLBq3pl/OG95IJX9h7yiwCk6JKeXK2sfVuv8NHJ0uayD5qO/Z4xFxVeZsazHE0MsNjTeBl5083TBC8gj/B8HnniVbWWvUYpDYjk1ajx2cA5mUrfqbEvIV+N3lyu33CamvcjD56uFEBoyD1e9lqhMXXFXCRYW0igwCi95Uwr+UA6vViEr+/18kRLyR2/pLYrvrN8zw6hAjVNgZTLsT6525MRz0pEP1s1rtQD9KA8QHQrGkXuZlvVJbBajaaa9lSUNrEs7rvtVvz7Y+YYmxStD7PXSTN8RRLR7rwdaCPu4Dws6Dfiye8H8fTU99ghXWo8ccH/BpSg9rrO0jtngS5NqUZmhYJJI6VXrfEozIIMLbakDVXdV1ubEnvPRGy97Znm+8ZyQKpNlruxmvOmG7WiylbkrzwfpzKVya+TVRZ2ocHZG/HVCibl6cHu84NbfAR13xscsi8Z1kdPXpQ9ud++YOW809fPeUkZ+BLbzWOd9vdyEkyEfdoYernHF5v0//37P3f7rbde84EBG5l83+vu+clf/sPbLyIXBNN9zFeCcTeemAQbfoVc3OdXyMWX+SW9Iwqx8IdV4lfVdz+7dtQXY1xGp/VWJ62dMvt8LvYjkqVGCL9Lw6LyqkFReUUw7Uuim5yi44coXB7Kygna1ZRjkjnQSboA0qWj98P4GIDCxcUfudF5f2cYFkG52dj30M998Q+f831XXExhD4lvFXwY+AeKaGOCxMUjJK7uSFy9SuLqjsTVR0kcmPqQSRw/QeIwnJbAPQgCF5+IwDHYuUcAczkGYP9wy+WytidbgMN+Hrh7IQf/n73Z4RutHbXsRzUopv0CiXkTYvCpzoLqyFZro1AKAPWLVfOaPD0WNcYfQkvqdKdhBM2hoyjhWvZjunxhNneBus7BJ5YPFQPI+OSBm4yBDufNdjI6Zx31VG946Q0luffNT++VBl3vikq+nCIVCsTg2/RuwyF5wjxrfQOb/Vvwzs/DeHqyeR1EKl8QR1VNhENVro4sF4v7lD7TSOzrQRsNC9uCBxhmDX/0EOpuGTbWr3qLoID9GzUNZf0rvufVZvnD98u/z/HbDEVgP/MOxpafGcUbLGgJ8jmO+DhXGTsHrKJ5IgTf1EshlC7kYIcjBj4zemhI0VCuFx2AR6IFinA88LaIUuJw/20RjxAyQjEX8RonjC/iskrcmzSOp4L/ZjyO+pQcubVoIryh4UVapOaVvYE4oKvexb5SdiLUVKGJGAAqFvSWSWWjD/QSdhBF3ukXi3gmxRIcfQXUdAWqQybh3SBqVnkb+Kl0P9TB5QZ+gxZEK5xfw5fw5oHhamoWfdlUZF1zKGJer6wLilK6RnPGUQJ11nI5blhDYVhIFxhdHduPxkHcge84h0IfNGoeMBZTe6v5MuLF5t4q9BvVhIXArFbAMm8TG1DIczncpqUhLa4DFeZQHTQRUd/tn7/+6N2v/cqbv8oVb2L6IkhwADGPaiNd7oAbuhVB1IdsFPYh47kumojZbWI+XMbsnIjpTnzVGo/RV4M4PDntNH69H2Lq4m/ScGH4jNve+bmP3vrOz32ZpQUJv37sVnmH8AAbkQiY77ax6nY/u/mQWaPUe6GvN+PEAoccdqoBLyjRj9xVBK+jLFNDDEMjozpmM9nO3Ssl1cQXJDiVmBFvnEqzKYpSLPestt/yRkwYdtJ+ZmxX+tknbzQ+U60Ny2NxFJSOMA00djsq5qm6ivptZtLVB0vss0CxrsisRBhacsq7whBXkVTuD1on90PlV+rO1oSboWjP8AjbSzbE6T2cO6TwwEbBtmkTs1xefjG5IDvTSkDdIEBx01ddHQlDTnhbzZs6O1Ly1KZ0RKneKmuWNvxawkPl/FAb0m3GfzdGfmkSrRJHaR7qVSrckOJ340ZIPZ9YMEBWikcHjyzPqKUk9MvYu4o8vDEcjsHA2FU5fe+QZtbhdNHtHMmvCItRKVYS6NNLT4tQelqgpTQJf7YUAUd2w3We27MbMD+upuSgcYe+wK0dx7E5mdYGk1IBA4Vo8YH9NgK2O0orKuSCV/WQesdwnR8+8R9IiuoxMPznzN0wAY02NlELDDi2qYt+C82KFL8uhLMp5FRF/SCSegUWlFIpZJMpLJqGD0ti2aQ6KtPzF61DF3dD05Vcdou2yIfRzMpeEeOeHOH2i+WVETLv86xDfoyO7RgWJIh8zuLnWYa55+BuS12OhX6HjcE4QwHuPvozrufn1ef734ky+x+vsRM90I08MEnZ+f4lknS3JikDycRPPV18Z/ZHrxN2hisrYhejchK8yk7QSW5liFXnyTqzw8slchpcpIz1IED2dKXd9xg9gryjDoT6Gdb0a4qsBwoHAySqlVl08DpHHgA6z0cbC7cKzA7eeE6f18QATA5lPa4eq9nCW4rFh2ImnVjuRlzztWjuVpq9leaHlhJssCW/lnGEr4K8eV4FaYEWj3AujoReqRh2ydoYdIx205621bKfBMDEmoOjfIlSvjwjn8FIPk/1/k+8Drcp/wE0o/+jCPfvxa/0tpe9WSkl5EwL2V/cKC8Mb/0e0dmXNZLXLUnpf+b1KM98V4JCv9WxNJn1Sx15Tej/yUH3bWZw4jPmLbM0+n8am1lGDkO6q+raHZsflvKYrLKlOrey19pJNWmHB+CUGA4YPw8Gk4bZp9EyvYlOXvZrama2lv4/njfVOZ0H2VKAozW2QC3yE2ugf1WEpgj1VLAEmSig9ttvkE8dM3194AXTDAcbluzHb3Tm4ZzPiEgOIMoN+dm1CBIL7Oki8G1q697e0RxNl1SgyiOqAutdZ02y/wSy671SH+iGVxUTRHIN1WxSAr3hjLLWRBlRfvc4/5m7JHjumvhDQqu1ELUK3mfQ774ULSg9akaqHBWhcepLDjTNiJBgxAhw9rnJt6lVRJXKIHse8dOeb3rYxEdVziD94UDNmE74/9BjTqCGIaZ6zJq9RSXP/Zb2ptxIkfHlkb3fAiXR8yKkwpJYW0ukSLRs10qihAf0DD25StHIA2rCWwcMP6mRExlO0HvlWEM8OjBKqsQ4sAmBJnCSJqj9R2sUuIVHi9pga9tGUQ2tGPWWoHv1LuO21mx2ny0MrFknfR3FQG2ozmA5kaiWjeqgcrHOzlVqO9Upq2sRlkMBkTE858bjXj/QXSWJYwDj3Hmo/gFaG3lUWrPJgxK6ZmWs5Y5BgPk2MY0cWIlcYCVyat9WrnCXhXEyo4U7pXUJBc5d+e/KHnBhQNGwKsjDqFva/e17B0NBho31QVnWUSnL7T8pstn3ihgQgV/aO7iS7WBg2gwN8fz2PmJeXNT5Vzgwbi9N7+fUPqpZuUof9/7IXuPy6WZA2GOcrxBB8oaFd0QqwuAqtvoOHCMV9vfmoeX/yzJgSuvvmZDLQhkdGQ6yD4n0J9Z8FDkolGkRAReO2s9gDJgTDcqqZxifQQY7WXqIENy67z/9/YMf3v6in/awJ0Aq+zYcZj9nrW8Qv9wq1jb824YUrHOP7YGFN7Lyct7bNOdQofI1z5nZPOaPHDio8nCipwHGYI5KHd8jUz2Uky2HqxRlv4aEQocK9lJ4kojG6mG23QZNZi6jvsYK6ef5H+W5g2Mz8WColXzUX8ve64Q2Nbtf2L3Xos7gouFErUV4x74vP/zxl/3VqZ9lm2hRFZkLMdJ9Zc/E3H0R7LLsppg76k4n5mqVg8kPi9znlZ4/delTBfKQd/W6Bqpq+QJvvBFUkZYuiAt6RzIpHddk5QoJpw3b1/rRS8lTRzYfvHF0dXw8V973jZd9TfV86ajnilez9r+D02pLQ922Y2+JxMotaLJnTghCfKwMCAacAi7YwfeHPT/QMzSZZTAdi0pw0m7F4TBMgtVuRCDKE2TDN1LJDR/K/RAuSQEfRQHZx/BLwcYQbHnFxmO5fWZitKFvz//Yx/pDQwbegSM2X8/0quJHrafcdT1Y0q+nckG+k52VrpMGskb6Rmr792VKwvm5LBbF+xUTZI4MlFg9xD95Ozb3A31VaDFE6w4jR9VTwV/2pqmZKEBwkKVKBlimVEhR6RUiKFDlAH0TklmR8mqkTKjksrFB6H9ogy2BRqnyKpp42GeJWqo9VJgNyXt+PqK1QWF6XxioQL+Ca56m6jZ9w5t6cObjRIKTCIFbOIArnqNHZ3d5RaCnP0Y2f7OnCe/yrGT+MD58sKay4Js8Kwz2oCSsjVYYaTfw7UEv+z1AUc7m8kBZpv9B3hhSnue/APDVUivuec1pXKSncSH7RhRnmFeZwz6QAj3gQxGt0sQThZWDOQ/0sKY9Bq85yq2/zByEhbr6t3T1j5VZtZLsmL/7KT0d26lnVqsq217ghznPUA/HJKH7a3K0geDfIdhyx1oQFKA4cudnIc7PjGxfq0VUNhql7QfzhE/Q5dEjN23PLvS2emj2VgBhIvaWydgKcYnSh0PxQhJMwTIQnONiWmAxLTgepoWbYVp4Mpimc9Tg17FXKxjl9DeEh5JI4RfvZ53TF/ahXIOIlnVOET1LUTDklvhFxLhXYl44hnn6SbQ53k0eCD9CvPMt3rlNksM7bLTe4vDOH8G78BHinU/RKN75E3iHyAnMw3oyDf10qj3+6OenH/CDUI6EZPH8Q4xvHgBox/w8lKenCkkJXjKzXsZq0lekwtUT9cT5yhp1+ZVYNjeZZOWTqYfrSUq24GMXgbMpTyDVq9f6OvRVyxx2QxW6ZdStqmrodD27Wfz8Jcqc3eNWynO4gbe9WcszESwXTMrVkFzwKhxL1onbj+PI5PHkdP7o1WOczqs9MWprsTbU3XskNqPM3RzZ2t9ip4/uxfkRZrcqF6pfIqcRwMirKDJC2FWl3p1UXpyrfGvL/OncRVbdMI7ywv7G7zHXj+JCZAjFVYC0482oUxUqdaMfQMVpr2fsSYLvuU25a8L3Vr3Ud1dHS5Wnqouz/4D6a3pIe3otE+cwrxZqtqumEg1GuB94+43PqH1Hu4Ysq+SbLDsli19muRx7xSB9gcAVcGdY4iH9RlhZ8yIqrceHKkvgeIQDRBnigytgxluNZJPejrY8/VY0PbOQI7+iQao1oQAJqaFPo8AJ7KhQtzD9y2Bct2C3Q7Zp6gOsUIfGqCMdRTLBARW7IW4VIYnbqSMNpVJ8Bh1TvS6gP6tr2RHlDMQxlTFHSnITE6FVuanK2y7c+72sh7eFMjETmUSZeAA02BiA0/N6pksFKM9Q8FUPkLP1UnO5fy4kj2/VRBE8ZT+NFyPtaIHGyl017MB1hgGm1sPmz+gsENM+kr9I5LRzDe2gRM5A1ai8WGC7AzREPevAJYrz1go8Vb2mwut7l/Bn/ECuOqHANd3IyZmYrwrdhsqpi0FZF9MUbewvKNKgdT9rNiK73VZjkX/cBKtlfyKEYNu0WExJ1fLbPeIF17GoHQwfE5Y7dD13kpr/1/Onu81lcMvyhdb9qop7ZekoXVNs6HpmBGy6ZOvMcNexqzIhzlBp6M+HXuO6CQR2/tV8kdbpuhIx0giumesJKi9K9hcNPRFJRjR9CyjZ46qAzC1nXgGpIXeROMypMgHh5te4uqGYQwfI05cGXqAq0Ljmpf34pVxEdqdVIBMkMua0Sgmt7Jcbdl+IZqoCphwYUdqXiyDyJUonn22X91Suwa/PFXIjRmA8SmGILa9Tk/OaBZPhII2rr1H0UsYh/6Xi/j+4BqcnMYvOn+GR9/bX3Ihj7aobqNJEFuq1li5Qrs7IbhGbjWqWezLRgamCuRzgElFeYLSpMnWz2OMHWA59kF6TXC2d2+5E6HR/J06cJbSKMswWWxc6/nnCWvZzdjpmouGaCaZgFLTdIzPhzx/RxQRv6sUEr3oxwTvRxYTrnq2XEkacutUp7H919D7Cz984eR/B+ze/j/ALN069j+BNu4/wNuStpQPfj68r1X92l0B22C5HTio+tkiviaFOhSiQtwWARjZ0jKsHEMSEDdcolOlUv4Z9Olfxt85OLMXLQx1ofB3Fb3/NM6579Q3AN1/xzVd8kwepO5dVfviKbwgpvmlI8M0jJVySrcePEuPefu3TvJo12ayUQfogk8OItN1swbHY/0HGVd5+4zeicZVfvPHkjav8kmLjT8G4yr8BLnKGf0Vc5E9Uue+RouJf+REmq4e/azcBU1eRcUF5WV9pO66ou1vMEImw9HeNO1sklxsdsByR8UsM/5I847prcXfuBGCITgyG6SDgdXYjT52b5QB7Fv6BvXe5YS8OTZymjfoQDDbczo6Tc1VVAagwuKm125DX7akZ9+AG7iK8CwlQOAogyoPy7nlAIW4bToD67KrPJ/wI+qmLXsOPUM1esTiRx4wbxzxmhMf3mPErXiBDPOXuZu107EyeQYd+FraOf9Zuws+u1VT6G1IELSFzdOGhSk8jZfJxk8lXa0Dsel5FswCs5Mimfab+/8a+fJd+Wb1ESN6juwfzKzeO34PxqvdgvJO8B/PKR2W7+lG1+N03/ttZ2x51puKJH/gbx5yp/PKN052phGhlcjxj3GMe+0JrjPsX4JxC4KF7dWUd9UjZV/ru9Yn3RrpSXdoT/7T962RyvZSf/kuuMSsN/1zz/+a+MXGdStV0qRrALkKJFO/7/y8ZFwtXYOu0/TJnArucWYHcWOoTw+ul12h+HIy863FsLCr4gZNpL/KduMm2tWRLdq3epqNw3beNjICnI3Aii+mPgmA9stw3+37TaVkc80t61Fc3kR/x18xRPklhddklJ0bXuiGSn6PweIEdG/4u64kmVwMDozqhUCxVo57GBJDIkzwYAn0ptJo4J0epFRmrDNE0tmJk54CPKeQPE7A82WeE+eCS8FnRppAfqmfRHtOzQGFFi9uHYux6nLxU1oxQFZHD0v9p9cj1Q0mknlIi/rOwcZd53XpwHK3jjPzsb9FUvS876papiLK/Q5rK7PZiL2zu4F7C55QAm570x7iIV9SpXlEZN6YT/H27ox++75yvnXkmLqaX8tjplzBEdOtciCVUh6quywwGaV3MARwpNrUBkLo2UGM9+/E3ihZ9eXPfHPDnTapzOeWp45XgQspz2gHXc8et1NR79lra97vmc7fWqX7HkOrYWx8xRVY0UZtH1vMEmBDpcSQuJwM5Ipybh+RfIAo5obknGirswcCMaE08FPTFxfrONZ142QMYDB2FeIORJKrCOzo5eEdVeNdH4F2naALekUi4Gd4VgwCNEXg3K/BOLLyTCXg3cFNjFN5RBd4R4N0YajVT4R0xvCMwVFPg3WB413nKihtzIZLwn+F0obMvKuT6XzwH+wBFdTXzkn0JScaooG409opAGVwUIFo9H8Q02Dd+YqjLJqfAo6aW+fcoU01EHHOX0CvKlDUVWMfZhiSFUKocvIFXRYnPbkMmGXlNepfqR5rYB87RzwSBTC5VjNSeSXyfD7PLbzTB6kXyf1Yv8u/8ihTO6aw7TY4PvnqKgp+DgNMhjJ0OYTypQ+jSJRX08hFWwugCWaJ+cBQf6ElEwJ35kL7KhkvE6da4iYjyIB0OIQAmmJXSMdXMoQihoC9IQsaQTeJikVThEZqDCvIn9AUDbtxvK1aI+0hk5xA/KRjVF4ycLPK7PH+aL4y+l4fmMMuy0nhJxH1+iiBgI33/jRsn/GV8o3oe/IPH5nkQLqpP2vOgs3BxTeiZG2aOCwsdMVHlTuXJxCxQJUF9HqAmsz3jVW04IPzVcHQ4ZDJr7WWFVmIYncDBydEpA/b+LXUcuHevC/k298rLYzsHH3CqRNpCY8jzph8/7kXNCNfF1bweIfyFSvjTzuanlJJqibdXSgSpO4x3zaZJwj3cUvnibWNfDNwXkqRf3Fn54n1jX9zlvpAk/WJDvhAuViZQX5pS0tTcGgccTI9GoYpV1WjRkYtewpxgkfSJ+I+l3g0z+etqVl/bkzdbnjFdhEtmCB7UYEsOFOCoAaWrDdNQfJ8kL8mzvphlRjHSsHyOOhiwecRID/IFNYva1APPRXW+gsYXy4jv0jKiElSI/HJy1P/yzRJE7P0aDDn4aQ0KvqrFrjUhUc6DFGY7vy8R/13Ws0CAwbFYLQ3BULs4WYAEa4uYvM9XKKEuZQfWxHrlKv9t3cTO2DYx9BUQntPNshNtz3OupItKuLN7aFWvnfrEjJ00GrdSsQ2EDWqxCZbAZBjFzqQaSqeYVvhLuc2Vo33uWIECfJaTPLM8T7Ul4AHss9hBnP7wF70CPgNa9vKUfRY7UZH5as+32GdxCldenFom/Lp9FqchIULCXr5W9JWL7bPYxQVxNSRpV6x877uOPc0+i9Nd2g9cHZzz+i3rT7XP4gxNK86kMzmkRSvDZ5/FWfZzijiEhwRbH3nHu97/lr/Nn26fxdmI/fieQx/4q3++82n2WZyjn0tH3/4dtx987ivf9AH7LJ4AKCPl8OLvbhl4//x0+yx225T/7z98aOnAh/7jB+2zeKJNefZ34d9PX2yfxZM0BTB6MnGPKg3WJl/7id//zxf+8WefZp/FuVLQ528/8/Wf++x//oB9Fk+xVbziq+/47r/Y+ltPt8/iPJvyie/9EDf0jA/aZ3G+TfmZB7PZ2dnrL7bPYo9NuVQa+hsftM/iAtfgiHi8PYPA9lmc+fC3M5J/0isufPg7iqfSdnoqRuJUHqzf4/J8k80+i6ea7A9/R34RRfRkwmcRfxbpZ5X0U0lRU6qOCIhIgnZEimRUohSVCEQWXXLKBV1oOnIQowK5gSczzLTbPM0QUmXA0Jp8bMAIw0NmMMiAngygyYCVKkDMiagE2c5q30lAVgVARDmDAJnO5ExnaqZK+jaQZxDFLsjUmQFVVK49MR+qZDr3lUbnvJHPCxEXbwHFgYWWrS+Ws3VstVVLHDvsRNMXaCy+gGnLp3HBBbVwk0FtbdLTQGlONVYHi+3cUx67i0gCF9E2SThsErZRpAkRzDnqYktbtQ38TSQ0LZDVRsg5N4GL3laJ/rKNjugiDJ6JxpKAaK7vVBNNq9hHrtJWeMLc6jwINJkx7od8pIBOhuBbccpbPB2EWMj8xUg4K9+LB+V9mlfXOUL0n8Hwe0a/Dm9WF9MzDuTzZeV5t2xevlJ2IN9q+6kLRhOU3bq9smsMt4nm1wQKWGv6xA/AeRGZ85ihnPCbutyNZSV4Ggx5v7jw+QSgKMT8F2PSKvkow4dlyeoCoR/BK8RWGkvMTCLxkJflrIznIpMLDie6Y4kcmQAvij7W5ra01qcCOLEIwC8awFOTlzLJFasDfJi5ld1Nj3prtLzG9YuhW9bTh5KAr/ZrwVEgpMtKLgrfCXFIzRNjhH3DfIqzKdQTXwrzgVw5rnYi6hlIfwY9XRnQDAtlRrOInKUGIh1bUuFH9lZ4Hm72klXg2lU8jSeH7reaNIONhjEv2aN54WqKFY0puAlbeXT5IXuqRPyMLCgKqCdnnaL2DfMZxXIFXVowdyQZs/SGKnygiZud/FR51vIzOVGMD6MQ2tKPBIMKYXjyRR7uLbRygLqKWjJsPANXKXa+SXS4zhRefhEMEDJChmG8lEQVPCqIk2LaJpGKiDYJrIoiKZ2aR0IWEkB+C4C8pS9svHqYa1MXcczNWVdD2s8u6ErZlcJ0ZVG7sgWtNMxclwB+KgTktsWw0S54Uhg6vzj6rgSk2k7XxgLtKUwbF8ACLpCOsCAuaMJasUQNfdNzStFggZlQy0nLbnb2BuxEjDohb07sLvYyuf5ARqvJR8ML3JLRfZrs/bEnNA4w88B6v1SFF9WzMPdn0r8JowheE3CBvmqSMNK6tECtCR4VS4/Fur8/5ukluGgKT9qUyRwRnmSemXlWtoMiuYWRTTXKn+DyiciAQ5EGh7IpZCDCvEMoMtyUZvDowMIErPTUzI0ja8S2bbYNLYmlBlwWi8GIXOh1g1ocg8d+3BZWC6xST1gWSymL51J7jDgDuM3oblOPGaN8pp+4trVphlIjWb6yaPe4XBTDgXS0bU7ah5ZIN7I7io4KCBLC0W/26yIsmz1SzO37wZsvXvvLJ/wOyXWpWS6zM6DZwZDmaI5vwnd8GYMHPBkWgGbkklRHD007pZwOIkkpo4yhzpF1AEXd8KSjtzuCWu3qpw8HuFwIW1siSo1FiyCjNPuI1c8DUngqFmG0wqXEwCpm+WaH7kxBpi/yg6n3NX3FZb1m1OLXwBrI0bCIOayBHD3qgv3s7Df1KpoYpMzj6uWNiOJB+nMBK2/obvijY7vho243LEm6G767sn/+9NgXx9wXmqTWpOSLvhRHNTMlsreJqA8LuEeeujvCtSKJetAjfgvM2wN4q5p+C9YFWXEvx41nr0B+rCBSEQ5+tbKiLiqNMjhOgoIrZeJLVnUQrVekBIicGLoDc3f88Sp+sgOFD/j6cOiHOY+F83o5ESS52cdD/Fs36o10AQP5pouuTQhIms1bNhFK7uRzVahATZJFZW7jEzz9lUYC/Vb+k+uNEf9NunBB33CVQQfoC2MDdK8bIEnSAbq/MqSHncWtB0yOY1go8dF5/tGfkKjpurTBMU0lhO+thB9AWBvwkTIYHPpJBJ3l1g9ex57zNU6+uqUSvlPDEFd+FCVou49qLIKHXXBDgnebiLvB9kmPtWuYgXrH45CHICYRbMvpC/ChnEUwW67W8y4IXkaBG6oWVJ9fQoEx0Hh15X6QwVdPeRG1FBM7JC3qTI1f0JdhoMggSICRlihc6Ago0AsSVyCoNyi+p2rML8sbkvJppGQI4qaIVZx/ALGJaAnqAOpWhBqahkvRqld7t+rV8lFZnuBxORers9Ffw/veci4iouHmIrzcu/4m6zKXwMBU52Ii+QGwvA7qdJWoh8YjVsfq5S2TpvFKkZB/hl97Lyamc0+JGRkZgXzTzcqMx0lmp8xJ1HHTyKw66Ku0symDAX1U9HsUKDCy7lHTGJYX4CqYAIDd2W8L6Wxp+9vlZJ1Bu+tod0vVQRQuKYZbOHIlMslmRMbd6kCXRHh3o68LXPMAiVL4DAgOfrV3ll6YxfFbXwm/LzJodxQxnnuKxpGiM7oaSgKxzfGhW6uABrDpkeF2SIbXZDgYDLDmDeUgDVdK0JRDPgnXRBhIrgs9VbpkLmn4FVVmtdKhQL90wtD6mod7M9nv6O0iATJ+ugPy3R1LmXsbd5Q+oWsb7pjRXQ8mnGBt3OGubg6GlSvDA76D6gWTOkF6ONJVvbtVN41Xc4/4saBXd7I8xqMLWz9UU629UAjFgoRWMdv09FuEt9CXrkFfGoyknop9FF2s2g3/rB8KxR49/k6OcyWhAUNbXC6eXey7cBKbYCm8hB/xhbWLjZf/qtVO1QVPq3eMgvKOUTx+lT62V+ljMQpPKbAxFeHl1DtGgZxtjZjrDNaHIrYAnM7lR9K/mKGzB8QFh8SJmjBJFOwJwL6gmTNk1rPk3QiKKv1ZZQm7EFL7Yav6QQt1c1zGmAgQ/yF6LVtSd3CZvjERMM+y2XBrkidwFqXFukaY3SP2hGXlIaptYl0aQvMG1dFCu/DxmyfX/+qEHAMbuMsGjnIAS9vN/MQCdbs8+RNfn/dqenAPntXF7pgt4X4beFA/xeyrw7KaXb+opm2y9sgozv7IAKJ/8FW+82jH22ZEaLPP5SNb0n7nqdhmdu8tfl+tvLf5Pau8z/B76N6Fk46sFqmeLfQPUj7nzlCRzHgLpoxT4HQB+Yt5asBxauGLMTtqUorz54+j9don/S4gk6GFt3aZB8gtJ6Z47M8X9AwjoBmlvG08FpUOL0nRsuHvUlN26T4tY9dOS/gtEmxTt8g2e1EiVozoskc9u12FKQzJt0JILaMh9gis9GMRDxaz4LFEy3gs0xY8tlAXIpguLYAO0jzN4Y/1kGehtulRoO7ZldNAWdqfRe1PIE0OjA4Pt1L5BxBLsb8SX9lTm0ABprCmkEshu8ws4rForZEsYX4vGUHMQbX7yIN3BRz4zGGo8jnSwbLyuk55b6UzcW8Fm7IyeWZacrtMbk9LbpXJrWnJaZmcTiRTU8Ml7mR/oGZx6zzhndrR+z05YA1HDlg9d8Cqam7KFgTkbYigw2h6R5B4AKAje0VscQ21DHDjKVDTHeHGEZNngQ2s1KtntaX7bYwU1e1pLa9XzumxZw9ofWFDs99FZwbptWK3QJqDjzxGG0/QxtOT3Wo/xmm7jUgqFNwdDQemgKoFtPL6lSwA6Ys9b+oCWgNFDhl9MvJe5Nok9sidlruukrpedu29Tfh644/I10XyY+OL5DVeOP1wGuOhh65MKTmAMPn6xKn8AeIfgeuBIrDaCHpczzMu1Pfs96S+GJ038E6/0vR6pQbkuapcvoeTMPmeqyacVwtIRvO6aNjKfVzY6Oz/EPlqvu7gV6EYn6dAFXO1T2/8FW31TNuC4+Oig+1ctj+fVR8SEXW4OEy4NnX2QxF7nkLQAchlv1a7TOTPoSqpL4HRXlZN9S5XS10Rmm+hWDehKxRphT1R8XOXDIvV/UXGFWQ8PFvJP4AacXQhfSi2o4s8uVQvok4sZls7AFkQXphu4gXkHXQtFg45ey60BLdT97KVUnCUyTMTEsgtja0hvm3UoRVaRQP52cMz+31Dxxkm6gGvTlsOSEuRjNLmaCslqJc6EPpy2z3KnuDVkM77ATDQ7X6o9fparYdqW4ZgAdgoerYsmiaLnt+86Gtd0Y5aolwBfpvA1MqgYEgyhQnHAMj+ftVWWVTzRZ6AMROAxnkmFa6MdmEFjxXKUE9mHEDVdTQyjK2Crq7aIwkalVADqNKgJn+TN81xM3R49Gtfh3QUa/1HhrXZBNa2gbURtYGtWQVb219nbPX/bbH12KPD1l3+VGwNHzO2ouip2Bp+I2JruDm2Kum91PNe4UTwoMmem41FhJpDwsPeRAuMCjm6HTr5/NSSAKmpJYXHLel3A8+fvBqsAL05kF2vXhS4JahuezXDoWqGm0YyQO8SZiTUAG3LmpZA7Lumxt45NfaWSuxRd6HrRq9S8SFvsmUvq6RfO5l8oJJ89WTyFZXkqyaTn+38JrjIXZVvzpr8ZrWSTJPJrUpyNplcqySHo2B2Im2+tR1Y1Tq3Nck+oW56qPb8tmf4Cj3KiJwKrhxalJYyWLnX2VQOjE1l/kj1UoVVenczwokQmLUR60exZZrEL3XpjlUl0NWr8Oosapg3oOTsTEZTva0peaMS3STH9xEE3z/+yVPvT8+ZfTrb7eMDlz1GW7VRNeYB4g5roEU7+xNrdQI7UUyXRtWa2kzVgZvaXhyxppbPVCQLehLC2ZyWdZHp0HRktm9kP3NQNqd6dQ324FBrohguF9AolluZgKW94DYrRYj6xFyl2+KH05cTxHktkIEI4KEzLPjKU4rVmgEcMnFdsEfMubF9oFmt50+Fsc6bdjmdB0maN9XqYoB8iEgqJz+lxdRj8HQsWfob1jdPHUgaSxmYnbKc3qmmb0RKu1e47VX7IYZG2jukFtnhSLUHHarr19D9+F9IwcYKW+UBf9RhHf/qWKXUrIxVk/h9ZKxM8OhFA4ybNGVMmIP1uq6sr7i5uqyHVaCXz1elPHLqyEIW2FMAFstZfEB1ty86VpHM6Yhbo/wHf/D/q7/zGetDPiPEvoKSfBb3dnWA+vV81hx/9a1dX3iXqStuXkLzG5Bq6SpTt9rVTScEFAxEsQJXzMqGWJc+M5DG0nz2v3UN18O/Fn6yAlUhlMidAqrzKqAbrLyeIitmnfS4phnEGee7YM/QYBGX+2coV7WoEzw4KzK2sLrUgBGXlF2hBF5/Yr3pONIZLaAY7V6sV4Lj7CvXy3vgpJrorq82nQtQhmBsSIeqH8pHN9+DCyl6PnDcYcrTsSJoxoUxt0fGMKg4WoSJ0OaEYHbfXsZT12AgZRP2RNE0wMdZUpph/EivP73lG/3nhKV2LTHZEr08Ks22FPU8wf6ebbztvcaK8SoEUuHheiCnCQ5IzepOP9XLm02GB85xsUV+TtuD67dgTS69oCJfgm2KVJ2niVPvmPjRUTEDdG0zBD0JzppvIDnRkhCcF8g9vKDaJvkiGmSaJJQNocvBdGDKelrTEvPMOCN4KIBnZuoKx6yXDtLsL4VGLJpOoYwtYgD8Um7/IuysZJfauOdxXAoFpeciTfmuGa2CNVW71CF+rJQLorlozjX6+Lu0Z72/ah+109m7Xj2WF3O2x4Fe5YNZykzGLpzUhUdVXrYiL3sl3AVwu7SCxwr5kI9xS0vft2BUt6A8LMtNOQRBaBX6wlAaayrBMvDJt6pV4W14qEINBXunegvMWYviroDqhMDABg7bwEEbeMA3gXtt4JgNHPVplQhgLNbyHVzXTh7RrXKnDC99X7TLduanUDPfSTvolH5dlJK2cQiIpFo/p9J2MsHT+h70bvCZYg4nFBA1QijJsFWFsJxOc0pAgmzIh2kl+XI6tZLchYINAxdLJcDMFBUtgeOGZtmc5mbNUcPM8Ck8L/pixYnbM3eitqAdXGhT28JQQvatzzG7lJ20lbcj0LMsW7fzxK37+gErVXQnHuGdBv/NYDe11ryrpfJ3Xt7jtuywkKIuqgDk1qqqWTv53bRybiyph/pP4bJ71ObJ0DKAOgWAon7rUg4TtilETUQtglrxHN/AncLKXbrbmMzsgpNlwK+DxylUZ5htePnpGvDzM4K9JaIpTOgMBRGCp2vQQJV20QItG4hWwNXEhrlpNHP6M1KaQqtZrFQHTQHnBm60Yp68pwmsXI14KfLqwGm+UynXnJu1glaUvGHotBpBhbIu+RZk5xSJdTHj5fQ4APCdIs9TaFmeyyJDVwIF3FjkYGBpVa1/iBsfgPZai1ocd3MggoebAt0Ogm6ZtFA5PtFkclQ8NatRI9UNZn6mfpifxdmwPhVnc67pKxQ4yjyjs8qF6hw6k/jxBLdQrbqFassmCxWQCQsV+TnJYjV7nMWqQZ6SwM7kYjWDNGwmzGI1W+nmTLlYzRKZxWrGLVZEs89Fmo7mOUTlYvWE8cUqo1QWIMLf8Rcrl3faYrWFVjWjrk55Xi5afCDImASc09UrdxGTSxiBonH7R5awmcklbGlkCTt3dAnbpUvYqixhxdd1CVuiAsBd/L98CfvmErbolrDFf5MlrNAlrMASVsgShsmPJWxmo9hNuyeWsHOoA/g9AY/KEvbNJczRH7eWTSSd/KJGWNSIjLBjloMBgkKu86ZugI+7b9p8SXJr0YyuRR2KSFamWFem/+O3UKfoFoofK3QOHoyweJzyeGyodnJg59QN1YpcOMipZ9eoLiLsVZtTdA2jHBGTa1QPD8YDPE755qbr67FifXPF+uam6xw8dtIT8Njx73L92otqZIFCowzJ2mleTfX6UmKQvjhStqPMXcnpCJvWPW1124knaIA8dxx/C4eg0bxMj0ShZxz7jp/7Odd6SV/CcD5VGmmu8Yuq3uW+vMNUTqInrwFoo5qpRgi27UUpT63eB2JFOjHqxyEhmY8m7qmUVQQojUgeXWOskK1tqHDTnqGp9oto9qrKXBEfKerjqr8wJe0PBrAAVOeLML4cQaEsr1QGzmNeCyDp9fjv6WW0zdnLY3cXx295LiuuVjgVIljKGc0oVVds9Bzh+hEZj3peRHeI4fl845u6BHYAIP/xCJARR4V0SzTd0ipEFHYGIsFJQ6R20hCpfX0g4s4tJ4GT7oRo4WviOvAeZCnge0fP0L5kTVyn386q1e7+meCdWtvLPYOtej0MB/2BVUa3eoF6LF49CL8+CHz4uq4YGA21gXqQF6mm11mqSb2Lov7XtkNBrfVSPaRAU9TDj8e2UgL4DnccZQyj7R7c8ZRsU2gcUmR/LuezdRml+pU95CVPlN+sjksIbVWf2Jrfq5E1USurCVqlJvYDFJdJcfv7g+CFFGY/g7MUaTRmHj/UJKtUq3bqfc71y8a2TyRYpEqrPvoAMBUeaRiQjPXSIA5r+LWoX1kwSgSEZnOAY80Heqiln5S16oG+tiWTpmbvRM3oWmnQOU5/Kgx1CDyrynwsKO/2QE3RATQiZ39qIlDLPqA+KPoHC6ceXId6cMHawdwTMfca6al3xUiXuY3H2WTBEYrW3+W0oQNoQ/NtmE0UqOVSDQK32MCdHMAx2LUUQDv6Rk/tYz9onndrcnAUz6p29IYt4JgN3Gs+eQDPg047GkNSaq7baXYFTvQJGUO1wl2HpiK6QuJkQfx1ka/EfIXfRJlAnE5AKoNCg36nvGGTceijQenm6+6gMg6gQ5gJPA+KmrMrBVjdHaxpnaHiOEg2RSBiGL6q31xkc/qsTs81YARwfnAGCxGcbGXXbXcelw4GTufAczoHntU5qKoWJOCv1A8jpdYrdQp6kIq+jq6zjaqzV7HsGcs6HuO0WE0f+mo/EOroxhmc6PW2Gchct7OcPIMdBbWkLepSrUjVzFJaClBba5JBk20sOjKjtmjbkpwnOEt8wJf9Y4eD92owQ+NqUGYWojCnW5V5aWa+oIRrUQGzRLHMRjzE3XgLIRnQREIt0AU1Xs/vqe6OqNwfoS/8Pkf8V5qwSXF/ObUmbNTf+xwzZqqIbq6Lx1Omy4qxBoBnbUp6L18l3npBXQtlJrBY0+WBEiZ5Se2HUdNarKlTvRQOcKPGuMiUlvlLq/67aG7soMl6q5yrwjPLt06zWLONttIqFOW30/YpFmtousWaHBYEiikWa3YgYfsUizU7jeWQ7VMs1pzi0iYs1pyqacVp2JWg6EmLNbvs5zCGIQ8JTlqsOR2xExZrzjiexZozN7VYc9amFmvO3tRizTnOdskTiHvkGqxNnrRYs3u6xZonbmqx5kmbWqx58qYWa87d1GLNU1yDT6NiisWa89iCygrMr5zPllW2U4+2YyQKOm+6xZo9mh0GV7Zz959A+Ow0/uw0/aySXpCiJqrmrARICdqt0g6NNCjFiaeUIYsuW2krhziTRQ7FHzzkv9P5zw08mWGms8zTDCFVBgyt2eoK0f92TzFvQwbQZMBKFSByh6gEGVX7viogqwLgNK5uGyHTeZzpPM1USV+RpWBBzBbSArPG4xZrDE3Nm0pQcxj6q4uz+AVKQOhT2iIWa9JRyzQ1TV+gsfg69toXQImGsrxGHfX7SxeIdFhozL1+0YM9moKxWQLbaUUSHjAJK3SaJpyWGt5Wa9qizZAtZs80Tt/OI19IdkGTJZ9nitTAae62Wyocny2VGNXMZR/Et4ijClqpRHURdRpwt4zaiagVKsZEcFsgfNlCc1bft23M36TCr6rKFospLyxXiqci4ax8CQ8S+yMXcW8ugtGbjJ5KFx3IfakuX5SG5MvSxHyL9CDvYJ3BYuCM3OgqtCSmY7R/+QK1iR8XWMsUOdyo1VRKALGrLB4XwHwpRFgxPDgDtjxfO06QNbam4KOMIbeFxhIzk0i0QGU5y+O5yOTazUUsjiVyJG6hy6WaGs1Ka5ukntAA3sSAl7owclNXTJa+zMPShBi5yda4ckqthZuaEU41qxZuthsLNzXikGBwE4PYNO5hjIWbLizc4OFjfFNEXYT0i+hCZd5a5BlDCw294pQUqZz1lgpe/YMlG9dwdlbt/KOG+pJXRqv/47C0qinG1GpsU17rjKbyt2owFXC0iql/E/jQpHJijbpVZ1bNMRi+UOfyag9drx59FKxMWka0JHZ/v/XCItGNWIMSajDPc5+7YI2U1gFOAnsEQ9XwO9QEu+dBtO4xwsN5ldyv/sH9uA/lONGWmssEJ+irTqZHiTSvECZ7UF5f+uAA3L9RKc0+qzeyU6qjks0/8Ec+oNYR8eLdfyVuxzVEETG7QyBXbTyanj6ndA6UN6CpJ4qZeVr1u+3lvswZ32FWSAk3xZiTAWhNXYFNwYVbazCwARLUABLVnQTA2yhaFXPDNnwXe0JuDYcU3jqUu8cbFQ/JAYsJ/jurrmPYsBm6C5Nf9eDV/L7uL/iHQrlAFhmLLJwgtsP5gbZZ+zDq1HhYvXNPtexW2aVeF1qzE8qT89fZj4rd5IBDb5aQVxFFtMyFOrCpaJIOVTQERBCKh0ekWvEJzsnxcFBphvKpVdHEj0Re4i6muf0OtpTfs5mHAr2Zvf5QADDw/u87OYIfz9PH5VZkUSpnBxboe7HvwW1mHAqpaicsueC7MosUrAq0l/ZQdlxuXy+GqwiREuyR+5oQtDSknrypuwsxQpyt6epZuM2kyKqa5po9lMO5ljxQtyQo0Zx/JUjGKLeobk+OuDFtbnKbV5ZERY4JcTJUMfUcDDYDSqXYokmeHITV0E05CPNI4p73XPS5IXqt2f8CXdDLkh4DOqUk5/4qyJpKgLF7tPsfJztF9/hzDJIEXYoWfH9VRTcrmpKkSrrIqT4yGRTYmWkENUVTF/CGEyH1x0ARL5K4w/qioqkmi5rZ36HNpsH4Fk3WIvScMyFbTW2KLnAFRQRClREGrS5vLd4U+rAKNWkPiozd55jU7FQd42QcS3I4hGu20IxEA+CXPfRfqXdKr+UD9o3Sr2E1mUeoMWLSuuFMWjcmTVq7dEnFYKEBskTZ/7RFiUCu2gw1zR8SxwP1wxTXol2jKpl1gngc5TsdbEn+ayRDtT37PELMisInOJoPg9ZHa8C9CKKfPZsZxwp2UUR4ds0zwfV8mQmNNblFy8/sc1I6NQD0Rn+PiK3ORTauUPNgdEetdXPulyH3tbp88+z3FeES1+tqlwEA/dQZza4abfJr6b+c1aqr5O7aOiMGkKM5qtYc5HKb+dW+6DUH+ik8BrLtI7kyH6vMRMeEYqBd3qheAanjVogZxZZKeaapQXtGV9x92kbv+EM5zm8DxdgHl4jRXq3n+DNo2Y0a7ogl3M5L9ucZYl/l65E9wjdoeE5z66G9LYWUyWzzAT4YVbnA1siX0SLTJvWgYYlYnTO3xP5j0WV+2dCwGPJUpmErSON2tg3xWja9QhkrhnZ5tExLoF0aZw/x+TLgc5HGlWAbIlWs5bGbG3AlKLRxCX+Vw3ftoXYa5/VjubGMKDlwn8zRrMkYi91NLqDoyfZDX1+lr86UQAwQx7QELpZbao/k69hhrKBYiwKIqhzJCznqKnzkSN7TI3mveiQfTJMj4Uj+1eBFEBqUocNl6GAZeuBGG7q3DB0rQzzk9mg+XxPLkjuqR/M7+r6sUztwppvvoMKcNp9iT5vr7rS57o7mjdctg0ZUd8YQT7Gbh97IcbPiHtWd0Ks3ct4cq8nBTLYFanIQbcHhfL1sUH2zBuG+kQdswd4F8soTN2j+hG1Rs491bQvDCdnLw/kdejhfcIJt3Y4Tt+7rCa7UTAHKcaxqZoUZ8rqpOY+1ZLVyewq23xZeKlME/EbO4Xfwu2nq/FjSKWjDTi79FOrkCc0YcO0sj+jr9ogeW0BMe6z2KxuQzk4c0WfUBRQDHMLf4Oena+hGPY8XXHMw0QN5dAndrZtTeQdc2kWLtMUAdkTlIWN4umN5U6gUUiQjo6fgc0M42gJQ/dMUYK5WvBWWaLj2ae5Tqaf5N2uOGLEzyKa1CWq4KrV4JVJasot0pGq8VHvqvgVPMdCeWAqW8pCowU4lZh4UpbHIVBSlPVGU9kRR2htTlE6FVx6KjS1H5ttmvWpysipK46mK0ihcFaUV6rqGufWsQx5UpZdFPa3Do6Gq0vx4wug6hsdqZQmbNwXqcgb0GlnOZo+znDXtcpZNLmdds5w1S01p189uuZzNlstZt7qcOU3pOp2jVYgtkicQP5LKurZM7enrmvTZLWnI6JY0Rg46pZJ7leY0o13Q8p5Z3PjTqu5hQj0XUVnbEjwSu8TNjixx3cklbmVkiTt3dInbpUvc6gmXuAdeVS5dZehYGTqqoZNaCle+jksct+PkaDY35JtL3NcRXKlOCbvEudVNK81jLfTfYnWb1dWtu5nKdAYAPgGPneXSpovcy9wSp813S5xSf7fEaT8fxRJ3w7Qlzo2eq3xydUOF01c3NO0xr26mykk6tdOtflPTR8qf0C4bXe+cDrUxUC2E3F0iPs6mS1er6Tsut0xlukydQ4GuVv+37MCgRh2r/nRi9Kcfnx3ZTg7snLojO8UuYBQbfcOxrRklLl4Rcto6pkrU39yxfXPH9s0d29d1x3YOHtCm7qIT39y/qX41asNAYBly1eLN4lBVo3p8X+cy7pzMOLHXQ+2baFcff9+H4Kac+Q0liSpDx8oQA1eWJ+wWi4V+8lyhTPNjV5ECxtlEQFGHx5AKM6JATfihng9iPNrwLaCeD3DYVwEtB9QEDGJpATMaqprY5cjUnqcFTO2A5kHZtcayRHV6YC3NGDMyC6b3lF6AYkyzeD4kY62ESJdbIKVdWSRQGW0jQot0rdQ+5HqaIucHFNEC+AF+n73eebywyrlp+pue51+rJoCyL9yoqqK+Ndqi2h/BqPaHLy7Voa8KYe+xf7r+UA0AzP4GX5PnzjGhSq++fwU+oRj/2sgj9Y9T/dbNamciRN2t5rFWFqAVon43nFI6sd8Or6p87FwfeNb3TJ/6v3TjQbGu/4brRe6v8dk/6ClAxUH9j8CzwYQfBcsMKXAD64oSR90RI4NNSkjjwstMXMSvB/pwXY5j76v5bc34n1QX9VX3ky1R7v7kz3/i5/mE2xfDl95L1Js28Tls/xNI4Uh+fKLGpirVZWP2MbFQLF5rgpOtMzR1JqK2X1G8ZKVQr/+SF3IB6q9AvosoKH1lSjXqTzY533wFtXHRkHQmPT2ULY8QD0nLfg8tXdET0UjUOZGGuqwmgXMz0Umz31G/l6/x2LJpcO2EeVFfTohFY0CdbDN2VfTGVWWcYqxjOFWz/vaj7BZweeD5cKacQbUfge7wCDrmFMjTETf8Qfokz3sleaerJ3+x0CNwk877/Gah5ZWuXdPXetatvGeOaS43NomZSgCJmah4mB1YORiWSIw3KFoX9XNRHLWK+NJNORkMtB8yJaIriwAWXkOC3/M14FKvCI2dQl+/526k7ymdtxvNdNXiD8w7EEXM23n2Cgr8K3K5EfDDEBe4uvF08DDxjEk1ffBwoWz1C6MVoKRYj6xJL59INPAkNNWnFInrm1C+EpC7UpGFC05v9EbM7Dl/FcZvZGiMwOr0s1YMd0oD8CIKvfIIcZAGBE3w4LYqqmJetLBE1llrBqjR934AUAuclkWY3hyHcGwKLWpHaGKTHEMvZld/T/Zmoy7/6d/XuxZq4Tuk+iZq711jwHsX1VFEpgbCduIhquNkVSMisVML49jUgEYGNFmiPuuOX3ENVKetsTgKkStiSCJkPMJG7pw6UnvequqtJde17FX8dIEwtpLszYCFROeaJZebFnILYlVCxCF0gUfWE4a1Zs9PqY4q5e6sntVTkWJ40AuggdON1k0Plq5d1MhuR51FRMhcNCmCxhu2i9oKKSiH8gC/chVST/ZT+GalXF4bonfk+lREqKPcfVGkHZvWlRRBtd1fJmdlckuBDFyzmhXAm3r2FrUNgXrrkkNWdjMkGpXI3ZDyE85TfhXiK0V+CyofBk4V5kWonairEvlzdcRABwBqaqA9gI/xrw/kaQAO8HgV2UK5CVI7gjITMfByCyzD5TE8WjCrjTtSmQISza5MSHFWw63C1IzdWvlsJm860317dUBJoIT1CNyVwFG4PyWLgkU/3xHLXw4j0HmchEd2wh+Oyxlv7gn5l1VlJaHGTnhBBiMCrO0DsHhLbsWUjm7NWR/uFTJ4sAdorycYZkR1jQq58+MsYnPy4X82ycNh4by7U7LvP/39gx/e/qKfFk+T5cuVvfUiQszQOaq4Y8BxQ7eDkeQjdwwdq2kQNOgfitdgRO4jX+I6s6/odQk+v4hFB4P8qoeL7tn7WAW+UVrtft7edaNUFToXhlwgFLwa6hAMJF89cwmILE8MRrNNbVlTIHySzg5c67gQWQXYH9OXPNwJaAHfWoq4DvjV8sTYfIKOUoKLK2MlMRFAK7DErKOeBicAb/WOQX+XZIJ7lnjM6F3AWKEIiAUWdjsZa1RV7AW3DvG44ojgozI0EFpYJ9V90H245H7lGtZ6uGzJBVsHeVgOjfphyYVlIA/KZ3wv0CutoftWzSyALCxQS+zpr1ZWqaO1EWuw7lZMu1YqcPrkiXqT6m/KqVP/U68Dh4p4o73pMQXSpPuRpPqbsjCWZZbfn7um2ZFqnOb7Eq26nuhkaYTUq6igfNwLVEVv2hLrKx8OLchAmTi7cDJkpA3P/9jH+hRkrxa6HVJYRl7VKxxIyQWv6rGsMMpegw9k7Y76H7zxadD4DMm/yrrYizg6fukaBq3Ma3N6ktPQphBtU+azsmCn99eDulASqm0U0POs2rK0Yk2MKDdyd/TD953ztTPPvLJ66ck1Pag0XYiLu6MJvjjkUa30k4J13Dcd4iapLYtc8KoeO9ZxbaF4XSFcxDbL0aH6DwTbyuXse7L8+3tcDqXAaXpyPXfcSvWhVKOlfT9y3OGoUwgrjJQw9poih66ddb5KGqWAPgChqpXcEY5Q5wEEp/bVonJeVoWgeIW3CUQff0hCjsWQTBwkkxFIphVI1i0k6xOQBPLWTwDJhMn+CCQbDEvAL6X6FPglDn6AG3k5kzPs1ppkwQfNsJQTvFQ3h1ByBikahSruTDBrTzWmeQau34QrNEoFsoXfA+Xldw4IBL3LdOKDmxWuYcPzPceUU4V6qdsmbwNkqQJVI1oIHXkrqdO9H8SSl+neIikvcLYktKqXf0FeXysEyaeg3B46WuiTX6WBvuubXxmmNz8UpNdtsq/x+jA8zw/2ilWEPfjB6F/dZzzoXVN42hrfZrmes3gui9e7Bg0Xj4FvFSO0urWBmOB1aHSVRv44IOdPg5w6YFIAKjAcCBbKy6yZFJ693lDnACy66eO9r+bmUli+XNUzKBM6mAnB3wCjVBmcO4bpOTUjkDokawp2DNIn8k/3ZdPtP0MffQxSeh5DER9kNwmW+tk/qslqZTAFnsYRIvq1BiVMXIH/z56vG/P/jwmdBJqMWbr9fwmyAMM6KSJYV7+AxMns7gJtjUg20IrGmqw9LK/4J9RcSzu1/hCypuxrutzOcWHZRwXISfYWAf3/8r1oUsYk3fhnd1OiJi1TgZN0ZUSLN3BavMGkFq9Ll1RMmpMuHr3qrGX/gqx2T1/LHtJXKIEHsp/oq5Z+IFtO7Oci7OcILJXQrUAzy7Yfurvq9FKvyiMuEPVaPEJsXMQ/FUDp4Tt4DpAb79ys96FZFKlzMmTPA37q/sTp1foOs/8rBhdNkAb42odA6iRf5v3D0hnTHU9QzL0Kd4NdVXUbA1wQxEvTC7j4ftegg99/q93s+7rZ9zErvqZY6MQZAWQZe7FfgltJDMVXkQXkTTstAyGZfWW1LI4hJZFGJOkLDNoSeoMHPhJohgpPMEJgqaUPiOB4hBlc0kTZgQtslaVDNmnbaD3pt3JL+5npIzepIsfTmlAAQsAe3RsrElFQ2fmF6Z8FYeO6WFgxJzfxSrsEYKalKIUtvx38vBWjmFYFiGIUVPeUkkHvq4R66Vq4dcjPeF/wD9imyXmVbujg0iS32t8NyXRmcPhGJox5kzh4y+sRNILzFtXxaItwL9hFXvViBkGOP8zh6qR52zDvVE3Ne7ijk4f8zFx06oK65+pQtlG0h+BXPZohhGoobYgasRfw+EF8l/96I0knbpGHQEbtIxTwx+sXoB34ZBbxu/JUM3Rp9gi114s2S6EwinJRh1902wPnFbprC6lZ4S6a4rumyPpPw0Ryt4w8aLj/eU0ifdmUWemC2ZR5zvJELV3kHzcFatmfyAzcOi223zXk7ymeN+E4Q51WtJzPihv00N7N6rP5K7urE9RWqS+ZGweYxcxlmSrSVo1che/0Q3Hr5ZY72aPlTL3Ve9ozbv/89Ufvfu1X3vxVHvrS76bu8JTnUEG3isrNztkeaAOPVZKqd7rEgSvV+Qmc/JoRHQyAlQ+VL9ERvH/JvK+7a2iFXmjTq3OQyLjzDh2TkAMYy7o84SeALs1962jMlxEC9UcreVCrbQvKoo0RElTCgWSsCsiW07uDUOQxDmjHfLdWYRdQQabQiNt9wWSxpyJQ8KoACMlzXdabXGr8xBzl0Bj/G4FeKQumVPUNymtIZH9DTsvk/piruEAHKeRryrboDS06FnaxetxUBsxZ0P6CQSaSniI4UoTrxmdiOByuG6aRu0keZOo17a1KnvVr7S/EZuINvD6lGs/JkYrkSBGsyy2diIJKDVhbUTELTCA5w4nuGJBOyGH5PE6OxYqYpfpFoL//mNE/VPRPBP0REuerOgt0XPNkdDYE5WxI8MrEu1Nifw1oT3Hl0K9oCOKJ8eDm8TDfnsbWFfNV8DuG+Y1pmI+iDeajEg40pmH+bsNT6mVVbw0MFVZ6j6/f9BDNvcKmLehl7xT6cp/vBRWKFjp+DvxGdtOrpzBdKoWNRni6yPF00SRP59KRqjzdI6kC9yQ7a5L9jciueAXrSD8sr8quke94uwiXfD+Arx1bF2m+oGTroMUFLDZsXaRsXYT6lfWYwtb53Kpfl3IDc0ghhqL4Sf4oWxe6BeBn/BCm13AG85jQGFgriIyA7A6PGHw+Pi7H03EZiIWTabBaSl3D6YRbDc7EJ4W+4SaEOywJdwj0Daeh772eHz7mlU6O1sYhwPlVSK49jcGyT+spagXhCrWHej13rIfRtB6iSNNDFM6BaFoP3+p5YYXDDxWTI7urUMMJ6pgZgrQQXffNVgVxvMfT25w+5nKMUCTEPsh+RKaC3eiUO4MAr0BnsLlydby6M1A2WA9c3D5hH3joYzXLRPePWn4o1I0C/FqiBdro7EeNVEE5W8B6Ystw+NX/DrYMn4iCtjBrbsMQOIKKc/BQK/d1nKXHOBM3zpoxl/sLa4LGJibmGHKXiWvw1G+S6px0liTtpLo5kDRJEKTs0XL62w6YyIbIQcjLHgb5wjain7nXlF9DrQgacn5/O/HfZT1NFoYep57qzfjtziubHiqKDY+ZkuRHyDmjNvT1M+SUQ5MO8wObqM5gNuKsiPOUyYTMR0by6CTM1EaWR4E62IUHNhHwnAW32u777IjVJ1CDYz+pswSfwIcSXAFzGE4ePSnI0S/LAUiVNIcMZkI/6KntKwctMX2BcubQw3wOXJbbRmWBXMImD1Y6kGuWPB7+AzSz1o8ZJh7sKuy5Zo2ysqMDmlM9jzF7BVmFycRiVNX5aCNLm2YQNWPUtgEeQAZwMRb5AkqNPNDFNFUolpUxExulo+MbpW3TYkE0dOOye/pOCcs4NkvZj49vku6wGids9ksB6mEmXlT1fKfJZ1WSd08mUyV552TyQiW5O5mcVJJb1eSUYyv9+4TnRdcaxZkKPw5NHF/5y6qz4uoZnYuN1WOy4H1lXFXHoVbigrDloPLxkB9y/l/ZawyHR6i+XoSDPBZ2hIKJDPIpcuUxReDOzdoZ42gzj50/5DR9l+eF16pjsgyEysmX9biq7NPe0YlrIME5zCEL6Cg/hjiL5Bf3WRGhPZUdmGTXzEPeWqhxGuwQXA5uNvcCaUI9iZt+m4lIIEr/ihfDuK3a64jAAddgFZWV6K4Y9aWIfgf8uL+2NjImUFh2r3rIDoMIkPEWScXSSrI+LOR8SxSaGnLWLPWIw+u8OWZbsk71gYhxUgrzFgO8zUW3qKXMWHvDWN2heG2DC05ICxT5Cpraojb2UW1K1YcrGLlncWyTB631TBmw/6aLZI1ABPqszWTRD512qiShaFRFsuHUJOixCY1ThX41ggCdDi0qRVl9L/0b/+SVClHHhFJhEXKsUyrk2k6gRogKfKtG6P9gRY3wa/zP48gH+Vl3aoR3vNqpEbpaHpHi4P7HX2Vw8OppKoMAdnbk1ZMqg0PE1dL/WXVH7vRBn/G2n/7Th2/+yr1ffSrmpW+U/TaGBa9OXSdrkJBad3Tkg6+4sLRM5rzANswegPwWy5k70fAeX42YW4E1E/0Anlrk7AosimBNtn3KN6hNlFCzGP7Ziq2wHtuQUbYKKUJ+4X8v7WXriOzvMmyc13/Qrk2eMq0e6YlMhtDpfut8fwEhFkJCOFlpWCBzABC1PQ1MT83RjcrLW1Q9fJDCVbDn67lTza0dFUinzwecN7Hfo5NKGKoQmGOMhXrZz2mHwVY7PJJK7AwuvMrpji6/pK3Pfr6ywzZjqjavPCtz5A/6Skcsa261rnxVwRs7Z/FhTMQnw3dopTg9evD6yunR+/IoEZeHjZcrTqMHYm/34IIYBIktVvTZl+PgVjYTLrKBvuxCbpZ3jrnQJIm4/XYEU/3irrEv3uq+uMt98TYEsYMdNFXkeDCW+2QJNrWRBBtmvQPUq1J9WWwCMcJvrm3HiD0415fGUZOtz62hxLm17G1IBzopbuYMo428pRtn0T5oAoGzX0DiNN6XWoOhGmNLOL+1Y5UBwFZRjFLwq21+eGoAbob/Oly0tIBS5dSLTJhYfKS1U8eoTBVeaSEcHAVyoKxLcPFcXGP3OYADirB6fFBrBSnckfvpeLyX9gXkVM++rL3vw3YYohCQtKIpnHczexs6jnLEAl+ZLnyIOFX3ZWavl0f1NsCQA9c8tPrwblOeVoy6prolk4p1cGaQBbDARsfU0VRuHhjoIVmBXbG6RTFl5/kHM5pBygwgW7LEHVTW6WfGQDeQpawtn8VBzIaXezoYCnmuBesIRgjlULhWzvq99qk5KdSrRn+vl2MgOSrQSF2HecwDjPkc5ucIWa+V7/9p7/f3inlVQtIi20DcBS6HO33HwwviYPmOhwsvX7StOHqxfVKI6oslbgCs+GrPeb5wn2Xz0pmiBdwVs4edKdZzt6ATjpvyuJDQ6OB0nP1en3xUSltomWbA7x3Y/6uMAA8v4I7Olzwu5W882sL5/Wt65tYQ+AHR9a7wWJ5Vu2sBWJRx8VxbKJMjo3reoZDj0Z+ZNVrgEXjhm59x+afan7nYPmmRe10s0hItTZr6nWroF2YUlyfN/CJ6S2nk94P2qVeOCClq2vf99ulSjGHf99qnphRokkCiZblw+0SGCcBLYbSF0/DQ/0rTvu+3T3w6YQWYP51q6nczQ7+bmfndzMivM/a6AkBPNHLcxO9UA7+bmffdzLjvZqZ9NzPsq/EK+OUpZn17D3/7lHmwBVZrV9kg7Vbq0lYYpF2m3lRDvyiAkF0yL9EK4TMYLV3SzyrpWwTJ5NrcwaYCC2UXWyTqcNOZZ9b7kQdbwG5aJM0wkG/0+7ua2iubuY35wrICI8OYpzn8XVrUe0WmKqezeWd0+s4ILzCjgn1+XrfGs1JM+4WY1Di07ToiVwsBlS/K7O1p20y03j8fI3ByFIwb3EtanpmrIU9qfJNzKWUhhS+lL0tHfFyyVILrCCj6jconCSl1ZDHujJIPKy7JtCl12H9HO5QCWguz2ib7pm3UXrVu/PyPvnUx/Vhkn1Mqxoq9UXhYI/aKvjorWsvtGa/aluxHKm6fd+0dDpy3aVY8DXGG0wQIZuRCGguOqCnSo9m1/l7uVqADlPsypjOXYaBoTgyObjZok9j86AfRjV2zOnaGddkyWsIDXr4FunJbJoEFx3kGH7qPAh+6jwgfADeBTDFjhGXzkNLOwCjBLCfgrrMvXJaqBc3w3naS7prWdLDgar0CBgdG4tmMGcjN4dZnYDmkYyHDJbT3dFPHmDjPBKnleQz3kVhYL6CKRDDSZ4w07I9uUGcdXzJPQb6Nz0K8vk/beHL3RDQp8ItREXhgdNET/PFhBfvFCn+Hl+CY4LbLAqOJliOvCkcVqspNcaMNcLHeo9HXKJdKjdyHpgkBzqg1WNM2oPnNGvfiOl61H+CPquPtw+mF5MYrYKPwNFFNfV22o+sjB/gJwy4oKriCynX0zr59FkvIa6M/ZJ/FIshvF/SFAyRvS6PVgGi7arJqNdQVSo2vEdi8fc3+1eA/FSuV1cv6h4/xHkoNPJewSMXoJxOAELhg68s7ZQ8FyiHV8+a0FSpfDvZiHuM+N/eq4yYyeufrq+xnEmeTGqiqDLJMq5mRj/LlsbmkUyDTKUDLwHjHOfXtsxr5IfsUUCsgddYIjABEZ3kbF9vSUm8kw2TIdHck+6BX5pm0AInKuab9w/cCjpC3tbFZED8gPmV55zgQCg2EmpWeoi3KqXZd3zHQgvKkGwjSOepjjs6opE6ck80wQMbB4dhutyIf8kTKh4mEbma2l3lm1iftrKznR6N8WSePVmKmkCOWOFByrumWNVeFGKFa9GSUJvoWmlI2kGtWtk2d8kaOTxid40x66gBfOorouW+X1jlJmxWYzdK8POdpG66ybKMFAG3B+CuD2DbLW25fmyhZXVPC7yTnuqfQZsWyjOwmT+536QYjeMmLuZ1Y3rFugmzpFsSc5N5BrUHeqm7pIMVoQfSsRm3NocenJ7XDpsT295xQO2yX0w772fGDjws9f1Q7zB5AqJxQEzTVWCGvqoq52gvVBkah4OKy6yEOQG8ZGioUGxHyJI9UyOPjrPRSVIJTaJgq4W6K6jFmPY/c4QcYLhjCWxAYsPiYcBN4auJt6R8nqQ+JPf/hfqp9Bu70312gU9EsBlFbX9G8iWQbXKtsg9Ek6GqrRF/3t2yPqC4mFTxRqEymid/CDPETu9kmZgl8OjiWuMWvbRRDbbubnaEZpaG4sgjz9NjNttaHsp0tmtjLNqld3cumfV9uo1WY0ZblzXUv2wDqpv1QML1BcZ5QKphqbsq1OPSj9sYN3ArkTXkSpuC+cn9bu2O9yGA9aFDMUqBOWql1pGjhJRseGRZzcsQJR2ZeKXYByCLi77gH8GvBP0Oa1ZcmXgbDvKUHSUAxnFKMHqBw11BsqjlauPE6HNLcEf6+lc+RaK1WD73kqKNoq3RFzr8e+rkv/uFzvu9yPf9yY3zsYj4nqqBAVXe1NdoGv1IF1aqwLubWXUpGFUv060cYJBc4BRMcAs2tD7mBc3nLHJVpI8WEPdVQ8JU9NU+Ms52T5ejhs4FSYT1dB+r77D4ib6kfPfGznieVeJd7rvKhbtHYxQCcfdjvZAxSHEOhZYOBbBF6ed20dUZvMfBYY2SK6NZ94Xf8z1/4i+d98geuauswmWbUywRMpJZ7Q5bKW4tQOUw2z8gMScXplstQwQhFdfKMo0rc0U+qvLgvbRe8FT1kX0WErfXK2LiDSwrAG1Rp94OTtHtKbH+XoZ47Sh3drLAnmbgz4jkpPsit+wAHb6M64JUz0OxXlHTr6ZjXHwQH1mR5hgr/u5EGzQWOFr+EeOqlAKNCw8/0+3xoPaJJSvoCq11Rni+HCMlPIqo46nEtj2wGiozrAWgkqbKTvU4qND09b0wvWW1AvP9Eq84/+F6Irr8LmtVi8ksFwMj3Li+PJcre1J+UOddV5izWreTUMQYB502MIJpImuNxSTMOU9QWNS89pjafcNdYWnfUK0T9hWpG0Fw3TnT0wqt1AaMKb/40IXNSCplrYGxqVim5jhSuWABm/S4G8tBTsm6ButTSmSq+KAC0SmP/JcFPXJ7thjIuVBuNRVtdxUapvS5m62S0+tYixx//2D+GWOB/VY8MST8lL9tARFGxbYGHwT4s3l/zuQhBz/dITj1c4h+8q2kZ9Ah6ETVRFeKfMkmv6O4azXvuef65CPEmdg/vYPdo7LPRhmdr+JLz/EvKA0LyR44SvdNr33V+7bskFFx+fnA513JvDdXwr6v4C4jCr4t6EFH4dVE3ehyFX9dAaEV7F/AfJ9+CZPxmv2a/uBNR+M3+7HoT9S5E4ddFHZWoo9WoY4jCb39DJPxUE/O/Hn5dg8T6L37LqIkjsqLmBtRxbDpihmX7LyAzSl8MtbGns76gmaqzArY4x4YK2F12LoZ6kiuQd4faeLEjAMswY6Vbdyq+VuKBEYVhoOy9Sha0zcIpguTcfUNVXfh9yJOmz0SbVe26tNsiQgNPYSiHgC2R5PPDehClSOJKGvgtXlBSJ3csCdp/77V6auSr+8g8sHHQFKieSeoNtt9XjtyQr1/0fGiKOB3MyLivQNmhql36ePjq0TSBygwWVyQm4vRY2ovUhJLvU83NTLUyRa+UwuzDVV3MsNTFDOVV1ASgi8mPqi4mXoqQ4lFdzGfyEJUGWqL+3X9vFrBIT7UjKPFJU7X12UdQtZxYR5vd3/r1fw/KmB8Lqw50qprttrUIo5RYdRhi4zbZlaLAy8g4vVZHaVDdvPoafLSAezqwwhEcKFUyQ+P6JTN6kwnHiDaAas4qzuHwXRf1hu5hzcKe6OqBz3M99tXMxuCEWTOSYeFvepKbilKFXVUDEV1POc6dvsjCnhGl1RUWqKt4GagKZeUgV+JFoUrvsgEQm66vUbm+BlhfA7vMpeaCluC85b8iI8pc4M4Y7x/UQG4BUFBWpcUlUhylyFD6ccLuKXFGOSzUldkMpae4Igwvy1VHxZpiY/o0qgTpJp/jKafE8mw9sQ4kdC3vHhcF7ClVILsVNcTVSS3FsHAGuyYEAb8RBHCnXN41uLdR1dtSpILCvMz97JCQUBl/H3zNPQ3cw6mvwfwKRMuoPKq+Zc43sg/fyFeQP0WkFjA7cDX5hOdBTwNYiVGHfxX5uCRxQPVp7vX0eZemBnfiWfWMPLDfb9jA3eaTe/C833OekYWCtbRhiahD3dNYE9JWxfaNQHO8i5/aW64dcaCljAB9VdK+K1jbN/vXZ19/609e8zTjBD+0mRRC7vhGwaQfZR9HXlVqOBoNquZEuGC2X4C0Gu8ZFZzGCXKKVazhMO5aH/KRCdW7vl4RZwWYo9wH49ipi/EU6rDhV5Qt2bCB3PG0McleGDLwhQX8MVSqRLn9bXlQVUejIL1h5Ir9wbnRq95/qGsM6jvmm6scrlB99ZCaZR9HVm0YlgJrdOEv2FLiJ1wpG1IK11O2gML19IOeZ+3jJIU/MHqGPMU3CnPVDON9pHCKtuRXzEEccTvxzbKYVpaFh5OFe+5Lb3rhm2UZpt/rCAA5f1kR+RfWlvnhQXkvogCLi66cagDhfbjFI36a+WfZOH6KQJjuFWhGTptsrmS+KMweQmr6ft/zJxc+5wJL9flCa2GuHwolYCiMuErVBQubf+S617e+8FfVwXsXglX0AoycqPNIm32hqPzTxc8yN/g1aLDwPXqli6k6frL9TEJeqFgb6XJo1Sole1ZeZvdHNBBdezzXHk/bU0N7aifRGN3ioyQr6ww3geiPHELUr3s+/FwJuBSrlWj6TtoUWLocmt1g5QKALll6eQhuEYXfRPuxWIl2SlB6cx9Wjaikk1cx0a51aEwP13XelJUoRehJGpLu8YyRrdP38iXN9fS7GCumSBMgSDc+AfmqoBIUI1HIw1KZWIBxEOAbEyH8RejPODpxr3PdL8zmoP5Qys/SB2MR6QYaCN3n7EKyQxDwIuTMKJLwFRLvaepleUdis3uA3yJU+PFPnnp/es7s078f0Jbh0kTDQgyaMg7Y4zXBFsjWuq5iAHGIF6pCbsJVw6EnksVPPCWQNRmVK0IzjgbajBayqhF70tP2pqhYreWZ6WBAqXTRMibSS365DdNb7tpkFJhL8h3JKQJYiqzpWeTXyK6JdKfs95oDFjWeb8TEM4hzODgrXWuBJ4ceOc3g6syt+WwK/oxiaSRaTxGfenAaFMr0EzG7SHMUmlqVGbwXp2yUcRwndbQz2RuFL5+juQHNriNvavXxIrQ0YoAZnYf7q9bWzKAo/1WXNCtaIROrw/jHauyFUcmthN/t4zK3dPTGT/1kPw9cnxXw4fCOPAIllUKi7FNSiP/8IsZ8EPscMOp1+vf8yIf/YdcDFw+vkkmX/prnhW59cYsLLlGTfxtHwV5Xb9PFQ5eOyrrBIlT9LjredwpDvVYUmMqP3Ap7hrdCKw7WDCnUwsfj7acJ25YNPeN9j9gTanOtAhVCbp/vZufhiIE7tUqc/QmgI/LxCB1cl/UuXlMrccAU2Q7371GUq+/72fsvOedrsNWHAWK6E+277Vb8+8rF7I/1ziTVq63altBcwvBLO4hRSRJg/y5ck1H+tI4y9lV3yuEcp93przmyIIk8c8ScdK2aoAQCUk5D37bs5dGP0eOBWJ5P+vW8odfcbY1yRNNUG9P84ElOQZUfPChK/zKpNooZdwnL1PAV3H55AG3cLW43Ivw+wMvxMb0spVY3RkoknqN18vYXTCWoeVmvwLEkQaVS/DjMqLfeYuY2mtFrYRSvFzM4UpmhFNY6GpTgD18SvsVU9HB+munhWz4HxxcH+ObYRj7v5oMqXoS5Bx0RmRstLq9YBKcRSNnFEo45pf1KldArJUuub5JGJlrHBiYKloEZXNCZgFjXkqhlTPxlxB6KaNnGBsSVPgjUWlLgoaLRYs0mLtNQchsaOdqEzOYFFjzyJlRHBE3BQKEppg7SiirtebjGxfL+giiFzstGsUiLwyPk0wKQY2GjNIvJk2sIZOqLK3kPZNmjBerI2X8HsWDwwIo0i64sE55u9WXxp1lGBVvYg6pi48noyHDpLEfdkoKmzLmmZGZPO609piFzaMAcLajNeqpRl+s7j9sCkms9MucNe4jf5k/afWvcUkm1B36LA6CosvQpFnAQYsTjZsN81WyYf5FlrH4/CptyyBtea2lDWNIGQwMO+XaniW9H9Js8axag7+exNeviE/+xWeG6fqsyc3Bf1uofVDTwx5pPqi/OM6yh4pT+y4Tk6dVVStQcD7Upppk1ah7YUPWFDnUO4G5We3SdziNR0oKSE3/MQ67qGaggplbexCxHVKpMo7Yuz/6X0r0RyQuseXa4XbiW1l4b6Urfrx47Z9DErCz3mN56yzY21G0O3aCwqr7ZFk4FxCJjym2co3XUSGoxV+lOu8J5tqmDw3/+UZU8AfZGMa8HmpzMZGhYzNIcnx3v+563/OW5ey/96v9HLsgL2Ez215J3Ds5g1siv3m1V4ufq4y+/9oGnfP/dr+Wla36dW/LtZ7567znvePhiaq8PBnfs+59/eflrfv6Wz16MUWgPhmp/CKW679C7TJtXbP79sNKKoQndf/FgfdMLthEGVx3jFwCFLigGoV/tR7rsBYzUem7k4yigxWuxTg9IuMkb5u5SoNppcKty4oINlWs5B9ewpt40Hgg4ts17JblJ6Mt5aIMztxSHqVVyZryAN4RXBUJpyy1/lVBzAHs52s6YPFwHVdvP/VU1pESR7OL/VOTD8RCOmQfowR1DK9Nb3bte3lU9Y+/6gDmAhzzjKj1UoboSvRHLxoEe4d1ZZwiP74pC0wePQjDLghvoRmCpk7uegaU/QxG/9BOXn/OUN87/N2Zq4nIX1t0rF2q98soqxUe0NJxFcjF1teJWp1CxH93lP1j4TUcu4Moo4J7hK3QcvHVtTqLN8aDpl+uRRfqReh3CNohqgAzlrbeDfknbdN150JvqLyTk1eZ+TiIE7rGBozZwlw0MPOHilbrimExZIQ2NkZRjnqWXsR7+gDcaulusQmOyadQyQUuJEqkyM08BGhbDlNKBK6VoDbHgHvOGlLpYRA08XqhS3OTtJyBAyme0sTYMPAQEZ2FFCm9KiPUQFHfYsbPZDeiOEupxBZwZlSR3FCRSjZiBdmjnCsywrBL2PCAB/NAkfN+2SmtOBYRmmODnLat5p9tSZQ4e8HRw9O1eT0dI347hbWDfMn45Zl+IX+61L7v55QF7bYXi57hVAky7GeE4+98qONP37M/kTdMyXRmaFV0Xc0+nJhqY6FTC8Imq60BLVwvRNtYhbeHauJolUcE8yUsyLPer2E51LHfU1t1q20BP37t4Twb4YkZ9vI3qM3VYw7XgH50syBFZvcZR5R+FhsIa2+9Kw10wlS62RR2Si4WK0bDAuGoPuAldTuPoGRMzoV2VAbmOGXssPEctKf8Dz4+NtoUqwjnD2z4FwmKEKrbRO8fq/ClQeZqvYiyQUnHjz0meeaNYybkwGg3XkyYPDn8hJFAsy25Qcx1mpGoWvFwC7mdXLHbnwZgRPM8YPLabat1TG+uS6c96od2MSaf0RqEoRHJvym5YzSHpsmttnhiF4gb5uVq2brArK0NPhU3UO+ypWkMLtbnKV+paiFR7kxETSk7tXFuLurE6808q5UWlvnXxnhRB1cl7GabgZ0CCjcUwGCoG/G+1YLmO8yKizC+qY5WNcfD+Z3zN/qvdUNLMr9X+fz1dpDbPULbiweswkV2d39vTy7qmVYVPgarlDdFU6FPqi1+x+u1DcPJjwYgd3XjU9hbEFtmfTzOO5azKO/tbdWd/qz5pf8ulSyqg/oirgWZKZ6385DP4xNlY/Qtnh0t9NpgzwTrOzMu79vvxK6U/ew2/F+HnkrX9bKh2jf8oEtc96IMWJW5lIpjqSi5FW6RdiKvLLMUjLGrumHvcAms9e7eaAMvrGCFkz+v8HLfAGrsjuN/yQlVLraoIxNrROqoOjVKAcWqAtyYFkJ1+jdU1AxjVUE8i6HkIktmEjgBLV7tQTpACiBKJY2+/1EBcHVOPoXpfVW8gKvUGIryqpVnoDUSIcHoDeCl4ZEf1Br4d5+iHPHOQHvfvs6eUMTKE0mdpPhqv3ZJOZZ8rrTnFm1lz+uy/BwWCL8RyjFpO0YHnjnBqUzi5WNZVgB94jePFs1SVZRewU2wM4OCnC+iokRP+wt9HtSrrdgWOhSpiQ9bauwWcn18aFtnJ4mkK9/+qkmLRboJVvcNod0uCtwgg0ASKnNGHL2DMYDDnpHL/jRoc0D5EcDdRNgpQH1bPvCKoWZlzvT+6uNxg4UCi2xtSuKEWIvfZS7XDqu2X9exvpao6LPOEfZ9CrLao+VyA7bhfDwsG6wv0VEtqA7WguuG+rtCw8DuXK2JdxV25r6arNAePjfQK/bjF2/exp173/W8ZfO7iofbLyDp/m9/LtobcVr0xv8Bl2atvkZZIYfZ3yKWEHiDNHsC7WQkpAWrrmq1zq4VH/wnQKgEeYz+UfVG+AF5jAOAjPDxwnr+n0ru9ld5hTAE/FVhTeFnvPH+fVK19Qgm7sy+ZMiOI4aSp2rq/R7wSrJ16bBIp1oZO60CTu5Xk1cnkViU5qyZTCV38viD7sjnFHHij+hWORjkjU1NiQdVOTsHir8cVLHAga13uOwWLZ08qWFxUSd47mVyrJIcTVqJcA9/ilTcusn9AY5ynigCuFmQymRSOBR6p77yQgqJmMnku0zOtrQOqwbAO0AhfqB+GPFQjNxRq5kJOA0H1OID8kz4I7oyC8Fqsd5VdedXFSBkNTwylbwYudMOdWMIAi5k1/8gimhhZrXFXVYhbzz6vdrGzX8BzuO/vLvjnrz7jnH+8eCA2ZI+480/roeG27CbkPILTzElLsYGCwPj/cDO0iCqeQOoK30rThGlPxKOmN9rfTfvpVfvZoPG+NY7bt8Zj6FtkfXMkwIaEtEPON0cd2erAAg9YMNZP8OuKE9/QPcUmR/paJL2iLlSCA+jTJKYeijxnV7GyEIvhsEL18zBPUJnvbopcWcQX1jIHA4+qmwmKRSs+Alu+ix8+SqtYG+R0FE2QMvc9fgPdA52HP4muhIhDCwipzzUJLahpHhG7PMSVvJR7Ae1Wu7j+o8rX+EMlnAsTc02oLc7d4wNFvJF7xpxLZ8SFmE8xxt7d2RlRSNDLBsOcf6p6MOQ9Xza/sqrqFoq8itlBTxOG5B3Z9ysfuOruL/73v+FzsO+Sf7/i9BBErrnOJ5zLB2D54fvlzFFT9952dH3fysDj/7+N12i+TiMCNL9q/1krIc8i0ee4Zv8ITjkn8MQ2FMhLIfR0PN3VYbQtToaTOBkSpFDhbROo6AMuV/ZGGjSt4hwyS6OjUzWH+F5VjVKWIytVsBYc9D+Yvcm6cYVvS+f3DObwNqyjMz36pWCaOaA7hp3UFKrWZTVzEaJfwZFHVNGwUi58UgbTDIyhMmWH1epZiCgxkKjXYHyYMQeCGwcZofoM9ka0MIFLotD2T9YBYysPjBZt6GxgYecbRJOuuyYNyxkLbRFvjmFarj5iWo5jIzUth7Gmuhp9E4PEskUTjfOkItr3cKbh6SFXfdLcXARjcygprBibi6yxORQuLM0dqoiNS9cNLG5yB8bVHpPvtMY3b0FUMUAXigG6utXVr1PodPV1C4bm6iYHBIwaugUK7cNtkgJSPzvZFysOa+uq7BJZq2HqIdSZnnuHequ93veaFdRwh/bmzP4rasJe6dqBIsr+WSIwIlZhdxVOUTHqulPPE9VlbqhefVNtc0Osi0JeVIiycsuaEUgkOuWyBZapjcfOWDLxE5GQ7I1fkzHKvpEu/TXdCQeinCaegEo1X0SOxzi8vH57kvLUtnKz1nXRy60436uokKOHER570F+IzK+WwwqgwwEKsVvKHgRwMKgj2xPl5RPZO9wLQX52jw5UoGrOeUOLhdzsXDGxvKA58pRjdo3EtKDepjF9rhY72zWT1OYKEV/MWNMf3N5UtctnNvLOGP0Q2XFMGUUjFKRjCIgDt+pX8w8ATC1jbCKfw00/NZ4+h6Gb5yGpHFuqKMhFdLh1c3C9WrkYdQQHrYO8k9qaMuoMcfu9oh9OszRfsQycybHdHJLnaEaGXCDdhEEzNG2B0X+8p4vcmKVSNAarTzIi0YuKuNp32XhZAlp0XKUueGWvcHAkF+TlQ6vqiCuwJbDAB/aDPOu+MF+WKnlAOo5NKTrmJm9mPoqurnzRpY60BGVqz4yX82ILxrdLGUC1DIgtIz7L1ag9g3Ehn6Mt+UwAiC8LpAeA9BCDXb4MBJCA+5w9DdZRGLmPCb0ZJf++rntVXgRjmjkdp4q7N47n9q1jaLm1Hm2RVulhe0ca4U6mqsfrMaqO9abtWD1CYovl8VqWj9haangbVK8IT6n2DsqODCcrRF8XaIvYVJzVWbTSj/hQpacIv6oTaZ4C0Lut3J4VWSvqYhtpBdfdI4R6fS4Zlkc5xxZJohUYl9m2P9+O0DU5Eawg4HZvTj0OhRwqGD938N9OrB1TbqOfwnfHL6eQ8MTqspV2oHFFpKKAkAkRIZxx+Arux07ph8QUp9ApMF9xKklm+3oat28bt89ckpylRAsUm3BXi0xLw1fIkeAs9yMBbhaR5Isl7XLJp+G9km+eInOUABSDOZ9dHJeMxZ2u1BJKCxBIyA5tjk7LT1F5ilypP4VOr5q64vdd/E4xEm3snFiaUaKKwtRfAUgTnZqfQsBgq224zV41IQxKQQWAoZ3VrnCZ2l/tDb+q9R7pYl7t0Ek1Ho3lYXPNf8QtT2l7jlt/jDbPlf1+j/sSyhhFrvFu5BDnOiFjP9qJXmUMQxnDuCznci7HjGy1HF4fJsr5xh3jFWUAdmD3uIN2wqrxTtpinVuvYOAbDIOlAzL75tV2PfXUXAu6zeWtqmqNaL1WTAzAJqLqUvIXOg9FnZfiqt2Rjlx4grEltS1Nc1w3YLMmCxuojp4u26Yu4W2JSmOWC2hjmxbA2y2MSJ9apR/sFumRwEhyWianE8kKO8ODUHLAMB/E/AhTWcTDvTJu4s/JKApLsoZ3XvKlw9Go5lJEcxiKxNDONcMYaDWVGlIpLuf+b4AdqNotWARveAXgb+Mcp0BzPV7leU1bdP6i8y7NoMo8rgwJWiZWijrVNTwz63eVyLv1G4NUknyaoXmcXi9Wkhctb6GXv5Xtm0dzr5I240Lcxh3ZG2SxX7GLOhiHnBTlGcXm7dXALZbizAMSPMc4CSEQ/AX+2wq5lKwvWC+wN9iCkexhkyM3+8YXFUXjVWIR9E4sGgrH7QHoxA5aUdTeRjvzmVLvfR5fbCsnKAMAB8HzPNozOrqyLlLHXUofYwfmAC+gMgA2C4BVJxz1ENeTaVfs0DhtoMwDWsljacYsmjFH0Zp0Ec9Z3e5ENDuxEBdr+QJtRYlbiezs2FIi+ZZpcwCQ0OQQyVdNnwNnVeZAnkMRHl8YRM0xFHMWX2cq+DoVUWemIurc1wFR54Coc2OIqrSkiqjahVD6MYKos4qohcHQWYehYCqLEkN3UGEwdKXPSMl/ZDEUPM8CCl84PobqQG+l1bV8uwJ0i+FsttBOmrUYuv3rhqErFQydNRi6Axi6E3E7NU4bqNrxs/mcNGOHnmOgf1Az3GHRc0VqQhkjNa0iZpUIpRIVJQ0vsXRhGpbmZXI+kTx9j1nrXyR7TL2CrDtNc1akI7OTi8UnhdAGHLAzfFGU+jrh+dmv89ACo2mnqHjMuxm5jcnGjLglme93sJStCW23YKEIQB/dDMLMV1SFREI9bMfnsfDOV5Y4BchOFW/sRGd3VqckCrJb8HYDZ+/6F4lWoTfNQRlOVJ+n2zSF07kQlNa1tzxtG9VdNzzr5008XpCnali9cZxDySb7c6jYFDLfuRjZXlfFtXLAls+UbplnNoT5KbKKQDKflRbNjApx4a9lVIhb1X0C2OfgvZN/Ku1rU0eEuHNaXd5GlyoUhTpWiNs5vhAXmz92vumEuG1qbyrE7bAQt51S5nZrpfB2SLP6oZ4fDAaUjbutPoKtW2WTuHsvpLiTva6B7GZlPF/w8k4CHtkIPOYAj6ovnczCIzs+PDLKTh4eGcNjriJD7pBla5KjQzSqPSFSBvxSCqDEDBZxcxTUU7gRFIv5IAgonlXOAhAYQSZm4yogfcSAa/+rAa5dAZxnZk1WPQ1oH5kKQdtQNZ47KBhXgEfET5qzpwHe5GmARxnOIcZPAxgcgMuVvZEGTR26Fk8xaE0OedSPQwrcmVqbosqRWkZ+5ZAU87eKORl1bOPbk43PqM2Nb292vLYpqtXQtwHTSSF4pZq00etuVO2RiXNeJEQDqtv4jOObrg8UDWHDjQu8GtxSqct10X4Vw8MUQg10v9JvuYmlonjcaFI6/aKCCWS71GcZcvc4bYbiA/td/Dka33aW2aqoW96d4fYM8Kb/tIo9l/ZwHjhPodO+UDZgtM0ItF4k28Kqt8Z7Qy+qHIj7+oUew1SH2nroLyJ7nFYl97EeZEyc2XmP4swunDyzCyuzNLSzNDz+LOXGnvyZXShndhRNJfcx+SPkPpok96H63NyE3PuVY2nN5Mj9ieERVeGh505RBR6RhUd0fHhEFJ08PCJcAhjxYRtUyf3UE0Q/1ZO1iprCey4ePn9ELeRfNlULQcoJ1UKQ6aTVQv7lJNVCbva9xqRijc6DpLBW53g6qHcnkdDbgzRjeipGjoRwIRznarCiyH/luVpQPVeru3O1hEJ0Ly4vUbvKIq5svyk3b9h7MTGkk8qf+3CyJ8psvhxIFnrsaJ24NsQEK0XIII8QD0kzx2VouVUknXJA9r1ikGNzm3/O8BYOqc15YKjngZGgcuTOSt1ZYMXm32FP/ff6xpdLIH429SUXVQc0sFZ1wah6SBVRt2e8oEpexRzynB9BVdx2+SuW50I8Ru7bBOm3SNeMzSPV7ZTzQCs6gpqVVOgiVsci0g8HAZj5YApNLYJpmkZoeoieegcKj9n7R05JsVeMQTniqZQjdpT0X4lyTNN+iB6F9gMsOVq0j4+r/RBN036IMR1OTvuhSruen/5VM26ohd5rx2z0RlUvTveP+WT6tPPJpEkyee5D0Oxx477ksf63WPKsvpbssanapWiXGfK61vTgWE1fcDU96Gr6stSEScL9xq04bHp3abP0rDWRixQh7EyF2CO35ApEdTsyQwF0CozwJjk9oPMDQshoYmYa1ns14Mh3+Yf9IlMRQkbpmklL4PFAFPD7aCy2oA8LPZ6lGYjTeFBmShPgJLbMG9TGsXYHM7IzfhQ2g255ptntvp7iBnmzCjXtbAW+lKnYpZkqLW9hDDoUTdFnnhOr2hHhSeaZmacMD25OPRd1VPfGs7gAk+QJgIYLZXkKBlBBx5Y2uGeQqKPTDTzmIYG6SrSwEpDsRL0lO1vvqcRSB9ekIPzhGlJUTSnH4LEfjm0pVSu5qNEWy39X9fLZUkUAQGxwKSJnFMkRXK27tgHcs1SXz68s6vCwPo8ILaPaNrQ8XwAA4WAK4KPHCKzmvyKwmv8GwFqkmGDaQIC2QBmBGc9+HVZ0sq/qJHA8/CLNHikWaKGM4aP22fVyY0Wz+/7T3z/44e0v+mmPmzwP4GLO3e+XYkNnyAjSTIGy25ZxX90Zvog7aX5QxtD8kXUATaRiNDu64QhqtaufzryeePu623++EuJE1ZGaBh/Q/gWa7XvZ19Axrht5+FXM58juH8u/+jCwPuMh+iu3H2fGPTGIXr+2zr7zLKkN3Q2hcNo2Rr37e/ARzQzVFdfwCBCPIXONa0pRqQFC0RRdnCKdVoSgRcvIEKVzTI3QMnNHPs07hszMGKniAcgT51TSyEK/HB33L1UtC/5bFls6XZTjXOnM0RL81siJyKLAf8saC5n9PERe/utxBd18lUL+0qdVadVWWqFePxGBMUrLt3NtBMm0rPTbaBX+SYpQ71eGh0OOxAvxy0F90UPxBwJ50dPyewPaqhXA8UOeG03+7WBCV2lVjiZzimGMxvhPmHScoGje91QAfI30gqidcyEicQZT3aMu3ByENCu3PQW3uhzUvm/F2/58G3+4nTtO0iN4k9q+9ig75RNNdApQe+T9IkL7ibYDXbebw3Pq0LKMyvYKwFwFUvwq8AYhPSweL3YJxS7RgkIsEa9zCwqxDuOJ+uXhxwxl+C7Tbb1U3oIZlcLq4W+rbivB21Kxg3YM1+VQbKsjtafoheguH1XkbZEbA1FJO8CFtds4hcbVwyPFqXTqMD/NfbuDuoJnLVlri+1rtJNOox3InR0pdtEupgmnj2qxcIkk6gWc+VTOUJIsOp1OL1+u7K3jc/MlHR06EaA1rSRbiB0umhuzCuK8KrA4pZJwijkmcxoOTapLe8Uvb6iHNFLiKndlOwpugTjvkD3Cjoqeotag+0IU1IB+o3xe6HcJInIUVJxECXrk1LUM3VnQ7wb2N5h/UdpAmCOCjwj6GgkvKBqJoDgt0vQFSvsvWCvOoC66x2eGZ2K79SzwcZe9OD9LLcyfzandA/kWmoWR/RCuds4RYwP5E7DIcuor+XACSJDJ0CYoa7fOtix/ok6n/EkUU0EmulbkmHm+nXnFkzH3uAtTFHXOxUzkJELgGAL49igC+Oou95X7p+UPbObDHkgow+ws0OIn0hOhrvMUehI9CYHz6GxeVs/kiXIOU+An5PNKbwVgzkJAitNGZfn4MFqI06olBquY0eryJpeZvx2xGmRSpcNIGMZ7ddJ2mFTNMQGeEbFnBiED5g9t0zKVnKDQ80piQIa40KrWQ9sR4Vz7oE588RQiDtjMk9lW0R7cOSKMpbZH6t7q+qNVazu+3nXTViAUzzU8tlEbyNTuQ/whE6Zt3JXQ4r8ZaLZprTlJhdAvMMR6a0mk85w/JrxKmVop5dVVgExnCZ0lPIi2gcyw4pr6IlMfSzI3GQwR/D/lZHuMr7S/gNIKtRUZdWV6siyaT7IrFFpi/EfltM2tS/RkafJ4r7FybAc60xPzHDIy2o6mqmk8bRy4kLJtSzwDEPRN8zzj/wzkkJ8DT3mKrQAdf6QAejKtGt+odlrwx/J+Lp2LpqB5aJWCbrtZWVdUm29sYd2KJre5rgc8bcMx04a7tA24lSld4ozAKVknMapLFukWwS4sUgePDs3hMac8xDx5WJPZCJaI5ORaLVPDUil2mcEivjZoOV8FTzpBTgCo6RRJGQ8hfSagDEeuzEaFxLQxoopvIQe3y7LQplWTzsS3pDYZYKlgA1iI+b9VYYBgaYFEJYcD3XzFUhpayZe4rLBYQVHKLWlVq4ptUiVJlefRqkUe1i9AfjPFwjEsCukpkjVDVk3OyuRMGTpgBMFjHzeNe8K1bhVEo6XxhoSmIavHaUj/BY9HW1YBJteWFZCf0JEfSEZPEj5t06zk8QeR1k5au51Ybq5XidDWkyBC25RXxNTw861cE0k/1fXkWF0653P+JF8RwzDhplRnW4Xq0AmoDsjMGOVRqrOCOODvCi1U2tdF9v+rCJGy70Jq8pAfPo8iHOKRZ7UrV8ljNNyUljjKgUBa0oaCaHaEQJDJl1lSda6SKtCsmXy7kgViHlA2cIy/8LADjVGuIj9PApTneHJV+fkSyBiOM0KWGGqUi3Krxfw9dJ4OdHGexEvkBZRrJJf0FP7vyUjaQ+ebnOfj9QKOlVcuHGwmViLMx+3K/VLM2bW7wvll/LT9O08AAqhtV1nCU7SZKJa4AUlhO6A12HLO1e7pjNQu2wwcHN3wuVmmk+PEMy2VuvHJKFVT/NWdNzZ9PB6hY0tWx+iGEgYgtq/IRDxdnkRNLqeeh0ogtEAys2HrcWaDmwlPHJsJDtlpfCPLcVsl55MZ8jpHnmjmiFKTtmkembmw9ThzQedBSpHsBtTLsu5s9eUwXjJoZkME17jU+AhrqPG24KX94MV5j1LqmpUw91GobkNEaLJiWSmCpSJMCbujP+pX9vrH7AsBG+zLboy8/yhX8IihEUPI4nxICp4IdBBQcFM+XUTgT5MzUD4l56wsWgTlVVnSUwqL7eOSCoeminG2Abbk6Sg3WVlK5BbcifZNFo5KT7707TnpNLfHp/ZAMsW8fZz78hhmtBbA0KgCQSecG+HNGmWLPy4ktqqXcV8MUejLAC9kXg7jJTMvB/GiVtl49m2j3rPyEHMR24PQHGMbC0HFKh6XFLDVM4nWeQ4ulkkBhBu6HE/B/SfnOfc21808L+kpngUTAVCCfwJFUNqupgbt6cuqLGu0XZa0ihhIvYjqjs5AeQfmX1Xzf0eFPyh3JQCzMRvJn6QXed61pfWlkII7xAvfYEgRREpX3DEUxwpewYnuoHaYXS8C5Hfi+rH3CsDmC74eMzfWqM6yF0QxDeC32Lzdj7eiUTm3XNeThDrVnZC8V+BrxV/57D4fvwMu/YBYc/RhZnhN7m7WvgWfUF3Nxr0bxokl5r/09vjl0TaOiPOas2+fpv8S+IFzZnGXs41otTQ/bX1ZAC7Zq9DTticGH+Fo1/q7kDvHtdODQz4fwSHIw/mg0l19uV8oMrLLIVykF8UjtQDtzuHQxC5rCtyOIYD0HsaHbjEvNeQ/oFdlb+Y4NIHQt5v9NTi4QKPVWNCdfnYDWuqM0N+IV6b7ZXPRDjzD7J8hg9f2iAQfJwjkw7wJF/svSCy0jN9AFfjw4576x6upCS4xdsYvP4J0V+WrUSXSnE8QV5+2IOTJmpT+QYwiyl+V+oa0F+fKsQ61jvyBjeEQN2xuax3YEP1WHaFrnLeRybHS19eYUw4eZIPwsPx0LQWiRVvEeFwxLOqM7Ag+bzjAZwhezcFQmmsMQlJcUVmrly5MhhX1tDI8uIgtka7aNr0WjTDhQwj3PXakFlw34UzFeS55nX4ijhtUg0X9IOSB3mMPK/5RMGfh1xYfHoCT4uekxxqh+Nxxxo0f8Cp3qGEn5guenlzfOyxPro/egaDxptMXm1GHBxK1iaXQgaaqadBK+CjCehB+cxkM7tHgiC+dY5Wv7q+EH9QwDKLdboPcmiNl8F4Xe0hib9E0dbwjJ+/atVS7+YDrprTrPrxrNknSor5Q+eLw+sgXwaH1TUCB5rrS5DM3p+/37JxmmN9nXngsyzl9r8aBOHoTB4YFW+j6M86A+mG+E/D4fTw3PCUC93pKBCqU6C6vSooGXpUWHfaOT4xugc1B6ezm5mFfZkzAvsA8n2dsbf36xbmzWqs2brmG0Z7l9dIwVx4DSHWxqU+x+u4p6qwAdDmi973xb35l8E+/OXj6919YezYFmy8D7M8RybAkBpPuv+9xzEUS/DME90jwGILnIohjIFgRQ/ALiN0lwQ0Ed0rwXgQJQTVLtirBe/BZV8lkHmuNmft0wdXYcjUm7lPwuQEjhNgvyF6P2Z0naq8WxTG5yet4vCxvVJdSJvWJW0r5DdYHGkdwVYhi+FBVACOp8N26Wl8n37hara6rsa6rwdmMU0qXqzTWYATzOPBmqJo5Z/i19w7fjbXUxyLqVzyaKSI96KtsB18IgVOwKSnRzqNbGx4K/oKXvQE9N0aL9XuzUUf69xS6kBgbj7CGX17E+ERiKFpwQop2+GfLifvA+gRFO/rW41G0Y5pKCN9bCT+AsFKOj2hQZslPT1K0gxonX91SCd+pYczgj6IEBLk1GivEzQU3JHi3RlQpGrpm6dPAdVMpLd41myRpUbdXvjg6+kWwIe/TKdqdrjR89u+LogkbCMyuqPA5KgfjneN0LXZ0rQ5QxUrX6krXQNVOQMQwhxQaz/4/j57dJPQsJmNI83nQ81IEgg9mBITEFXWleEVCSuyOgPOnhO3zx4Y+vBElVUjLKFnBfJ5KVn74+GRF3f0+RrJy6BfK2XP/z06QlY07j0dW7tZUtapeCd+vYUzf95XB4ODPTZKVBytfHZZ0DQ80DMT5yJ2OgEisckcueJcEj2pElayga5ZI3IJwhazcJO/Ipkla1M2VLzZGvwjukvfpZGXgSsNn3yQr3yQrm5OVH5lCVgSBEHgbAidLVg4fl6xgPk8lKz/6aMnKLTELGKLSX+U4SbnWTLU7yolz8DYOZm9CfSsyPTTRTY+XVWbHSyYnx9Ujc6Pwx2ZHeGHtfzjEf14V7y+pov2e42P9Xm4PLNaKV8jDrxKY7eF5hWbrdNityPYEFAqI1NbUO6cVHFWv//SGBo2L2LnhhCliFGo+d5M2NoKCP0YeUh9Ne9wtliK25osuIheEdmpX0XCvYNkTGFbfKaG/A75dbvxAwegqQg8h8hIJZhzahxBaoZMFfcdkGcXvpMzecgWHZcE1irVDQXaz4HO9z58fxnjnMYIHJZggeEiCDXRtd940GwG/Kk7DW1MMYGIL0Liyp3uB5uZ7gXjzvQCw+KrCN4a8QozqLWgB3l6An6tEGTNWIdumZAbFXJv9uJliAX87wce7C9U/HY2asb7XOV2qzE9QIM859g1EFOFvSmkHvvVPYgNHOSBMsaF+t8uTCwn0ea+mB/fgOSKQsCXcbwMPmk8P4dNbAufcV2Lf52lF79InvAXjM6wQbsIdHllpDo6sNFcff8q9zJIAyAR3WyIQC3FWIhArEVAirdYk+LnLzZwINNsJFmlSrriqbc8UVi3tWTLuGAqFkhkanRZit85UCii9SxJuwW/2E2MkV82uqe1l/bosaZdQ3SvINwRXbaxNENyzFEKRQSuNvMUr4cabHa9qtUAzvKuaYWMkgzbA+jtGP0pnSnf7Pu77jxuE1Jtwn1R7ktktr+UnxMFovjit7RbRkML1Ii7vGfLbm7EcDYr6lday/nr2Y7jTcnv2E3gMi4Qj4yEl61SvWHsdQEJS41l79resfv4z562wi5tyBiPaeXB03zwUsIL1eT7gHqn3FLQmJFN3OFl3LNcwKR6vO0Tdoa37Ym6+q7u+ed19X4mfu776u36s5gvVdoK/13mCyG4FAIuA+JaVB3qTFSFIVYTbqnrLjlX6dzF8+EH7Hvq5L/7hc77vcqb1DSRK1iaSunAFBBoI+T+IIpJbWFrK9aG0yoykhC+j9IZczFXGKAvIKQbN5iYXvLK36dICGorDMOiooxm7uXpbZIjJVkdr1rObAek3P8Rkmb31E/9d0itamF8tqn8bLnLHFGF8Wjhay7I3wgwksEydV5Of/TBixEXo5wM/cjLdY3zfKXFWIL/MeUGPS8ONIRy74C2lxLARO839ADSANMwVO0Igfj7hsKc69TNKYMiJP2lpSKgDCFOCuRtSAjLQIP4M8us4++0bjV36qvxPTWt+y9e+dt3X1HXGQ3Y1aZJ/AFcwRlaV7DYgxwoadC+8vYzYCWir0za5BeDwEq4s8JPhXhrs03aGeGZ3FBnPL6R07yhiWBgciEEM4ugBpTxy5RlXzDEVOzpHqL3O1cXEf4wJ2ZtlxsvZxMFA2XSKpV53IUMKxM8evgxuVm3p+ro51gJe1xRN1FlIhSIlPKgnM3P+8ZHNnG/OnP8jzylvjqJIrzm+4l990iflpA/LSV+bnPB2tuctndJ5qH3PZxQYeYcS5S2SqQKBGiklaaFN9eyfgNeWIHBPEvQkMLcvE/Hno2jSoeYBmlEI+xPbZgpEr8AXaoMZqmDPKJMYgN1dMFbJdh1gr4vVPkADt7RMCP5Y8GL8v7jZegLaNEewEdsCUWpViNK8JUoLIEotQ5TmQZRw94sWDFF6wSZEaW6cKD04QpSahii1JojS1VKqI0oCLkeXWqUfiZbxI/Eo6NIPH3pEdOmbdOmHPXgyerypEvlQGANkbpT9CNVPtIdLdAOXfioMleR8wxOc0BCc1qMjOKESnP+FXlMq4EoBLiE5QmqqvEvgeBdcHO2UPIt/QOFXV/gpyciUWNUKT2z4Ge9QJ004ZrmB2SQ3M2cJx3yVm5kD4RAH+PMnIByz44Tjz15TJRy+42ZOQDiCR8PN/D0j+ss5dZfb1oskmaZ6r1ItmhrhiYweJGD6esgzgVtMAHtuEVVfSyIHv9HTkh80z7s1GY4yR2XqGybDA7agYyaAwYHPVGmqJ019xvX8VcbyAazT9wRIuUlTtFGRCTwYmsD9HEi/6HvhpFcBowryltdMc3MXCixHvOmFzpteOOlNz6VLKhiHR1ABuA/40cvuQGZ1LBcRj6C+ihslGEe3h7y+EkJMDUjWWQwqv/d5+H3e2n7jNDGseMzz4TGvK15hrMc8RZsYj9JjXjzhMY87lP2ResxTn4bIjp0pt2jEY151v/lVX8x7NK4dWZd+8jWj61Krsi6VQriiXgrhsEKpDLmySNVlBcN3jVKGZxeoooFrifxMZT3afKkKzVJVN+tKvWLxA9vxOuamLkQ6+1t5G4GkaIgxhYTMl1hssMglbpFzQS4iQYPTcnUbSkvRwjZkrDCAxTmSMp2SykIIm4OJXcbQQTza1OLH5IIWUlhZ0L7i+eBXDdKTWzsSjPCqSr7vvGP0kOl2vKvcW5NkXr4VwbSPRNT2NtQBIaVE5A3rKa+h9lWALuRb/jqi5n/tqeJColc4wzXwheDyAmMcsiFnFcApX1Wt5Pa87nKx4ODAAqGuYCOXIeJQD2BnSzjZLUrwnb+GT0WxHiaqfZnK+tk8jqO+lIkFfPLh2aUmYzKETOKwMTtmnKQ1d/mwvawhRgmZKrqGNitrKL6nlqyhCxrC+Ytclq9h5vYxiFIDrDFkfyTb9A6Mk9Xlsz7Zy/knLpXLOcLpABfwCq1rclyo7vvI13pifiTsB0JqyoB4YJICqovk0qy+iYE9FNv4O0Ai3Gueu82TzDMbM3bXF1eccc57KDFaUYf5VoS0/jqoWcAPzFp1ml/MMhBm1W5FXfxoWtVhdd0c0IzEki92K5oC5hR10QzH4LFf7K7OYMHUSstiqc1GINool1Mq2jLcepl2aFQeSVtdCwNx9B9IIVcWAWzMziJCS6q2sCY9wJkGSGVLuA1Y68v+NwBZdTVNcJYMU353CGcxkJ3G1dSShfwCQTgPPAJSEXuFI0JIZ7BX1u6DoQ9eH6dUznYLnqGyeUBFFHePp4UitmUNUGTvRducxQvfEdnAkV7RPL5STIFZD1QljVU3WgGFSK9Y3giqljcCXd+6TF5FtwnUYdSyBhfhuCEuc12NCvlTrWp0Uj0xmpoIg1picsP4mVGTQF4JkVb2PmGttDOwDav5QN+mQyJ0kIgokp4yPBwEwiMKoRNAoAoDLLOB2pR6LIDIA1D1F3texRlP6Cx/qOtFZo3IexEu0pMHh86wzdVFe0EduOFKTBFSYgrsW+PJwR+BLoGa/rGQgtBR07f6nj/NnSLVrL9QD9+p1xzE3jg19sHatNgvTI29d2rsx6fG3j019qJpkbtd5G2OJdspm211urmrutk2g1hJXq0mO2NwnJpeyECy1stGPEFmP4WqNEFT1TCMt984g0zP9rzRT2v6qeHHPOSuPcrcz9NmWWe8ygZCVBOIDkTp1RzCFzVxV5Wr+OR9ax6YL0iXa3Xim97goeTSFXKgHCt4Sik5QDP87IjVg1c+FJiYDRUe5rvSmXEgr+gENyjA3Kg6M8YLVxKOOjO+iGHB2wPj1JePN7+sLkH1KFCPP7gVbxUi4KOSzVwXr7/mkbsu/n9QuzNahw5hdZCP8YLGqjM3j3++T18yvGTmpYuXrrycXSNsIuhZQgP+z3OL/OUkgCW4Kcr0gJ1aR0OotI6mYZEE9IVCQ8DgZT8vY4Xt651iPhITHNs7Hxtaneo+uphg+wfHavz8KD/rSOcn4t/Fz4YiOM5BgjXAp6lzr4mONAVNMbZY4FK75BpHQ9iECc3wqUy6eCwJ2I7SFB+hJcPol+CNoHMnGPQ2T+rPPuOuFIykZb+gREiGqjDRGGIgGwcNAdpbtPDYV7S11VJGMQPvj/pJEdEMPoPVFteVPCWOl2tQ/Mw9cdYfwdWQSCbRXIa3npimwu14YNbh/4WaFPSUXwKMtBSAvKEdepvM4BZA0KK27fS+vC3NzVtoeIseSXMv/ro0N9msuakRmChkz/oGgGz9eJA9K29Lc79xIBtvClmqQaWgL3Q1ewvmCtp2ld6eeQG3wIcIKMEFJ3g/JQ9FMrOhBarTAl/VeUr1vOs08e1GCywbdQ/tqL5zDz0lFuuELoozNXUDfadoeaW/PZW/UZje51VW//u90eVfKJBjKX5NJTWgR1Njj06NfdfU2DunsVAA7JTY+6bG3lOb2rKpsUenlnDutKy7JnJWhwOQcnAeRnHA2/BYTii8a6cuDFg3sTpmvygLMHQOERkiMtPIPFQ9mMunqh1F4vQ8IDx3U4ClpqaadVheEnH4ruEulHxEGUyNcIunNiM3FVNYdcSY5TWRmAZueVzKUhiYW1YXEU3jCqmpZhKFhODR/t48xdT8vrZnDecao4nNfIaa8om67dK7IweyX1Lq7yqVjYLYSueWMAerRtIp7Xs/kKdWhmbaXRjRXVPXiyaaix239aYpHQSzljz3xSL6nhHrCxQD4DNUM4cN+M3uMlcFxZCwln/R1InuC7sibXXuvFrUGkpbqGk2923emHXu4M2rXTDscgr4OJNn2BZXTZ6hpE1MnoE+uoIwCAnAqV493TjKmM2oOTg17O6AizRNqRCQIP2gF1q/IsbDrC8MFyrwAvPuiVVmiHfFZrMu/rGQSUgvv0+v8l7NX6hnVV+vrPqO2ZRdrCf3o6UCLakuPEqdVAT6vYimCL3V6imCsnEofLWxCOlKRRYu+HH33KvHPeBoqp57f/U1x/fc+9HAz1hNS4nmMU+lBx/1hGNFcANrU02UwOL9Yvi771EdO9Scx5axMG+gDUgSDJazPzV8oMuclkdtzlrMgJ8z6Cdenz1Rs4pVOB44e5TuU2gFjn+lknIGbcuwiMYVS1s942bUxmMWZ9xrMjsBDOG0Zd2dI36yoKXamnyeJProaHX5AqInWlEsavRHRwsplrJ3CN1bpgWyYQ7Rogkv0XwZXqRQhP6z+Jjz8DdHBrR4RMTWOojUoQbsQiXGuKgiUguRLUqRxZrHMuxs+roggkXnGJNiyqlJ1dI53lrg239ZSTXQvGJ6UWZLHiuFJv/IrWprPNCJXPUPMOrgy8m1AsM+By5OTkos86zkOlZ0rwu6qXfkmCeP851cK4l61e1w6trZEhtEsczHRJgoNNd4OmqodQQxnV+oEQ7IJiF7BDZFVxYzvZyTqS1cU5tmWGykRl60zjiF2BTUVo9XWq7jGARAPyXPbCaqK+onPC+c3FI5Z9iJ9izAzIFQ1FNf8nAD4FtBmCTKopS9U7e5iK06mubv88ju7CJs99R0vlIO2cD5yfmaX/ZqxkA+NmIt3Vcm8nC7TC97l7JX5Fdt5v8KIv+1qNa7T0C1bmbgVq3PY2s8LAJxYj+4Iw9RshsoCAQRPeqD50oFWbAOaKwfodq60PpRY8O1irY98g2G6y4mwOccc2SoW//nQC6xqTeBDemTHpYgHgRREn3IMeBhjQBHsy+vpc9HaVPvAPkGjdQkIYBWTub3CJpAkIDIUGoB4ycvPl4gWExKqUj6VKnFCKEV75iYX3vNfs5lhVVopSa1nPCLv+2wbPB65tWzr+nZ1c/5Xv3kvEyIZ3bnZSKseJnwKn4mvHE/E3LDQP1MoD9uYkSoIaBY0QnjYs5RItTqqo5lxoR2xoQUmxmDZBAMH1+01OeEFFoX1NPZ41OopccAaSSzRx+hPJBmZo8SvbpMqMlp9E1QnTyo+io2NfSROUGToFifOKyvcG14WNxP0qI2+v31r9LvkUHlZ49QNvsvcy3P7I0iiM74L5Sws4gyXzm2Vb32xgXB4XkCENxxNQ6KDs3DfdNQj6YhmAc3n31cjKinSHKukciDsMBY0yha2aeQiWJhQq/i9iJ7lH0CsXkrhc7JnU1x5xoaN5an7x1Sc53r9PRGRJs8XDaZweOqorO/yMCIz7pTTMG1myK+9sHFyM1KT84fG+vQmOHWvwwSB27+ujrt68J+O9R7nlUsAIBgcfIZms87NAtXm9SBSMP4LoEJfTUMnYivVnARi+5m/CrNU7aGVs2orWJ2fo9vOCDUMlFhJ86XD4FqZhI8iGALQT24CDlY01VujpLs/SPHfPmSuTsSFTPaU66u33ohzT7XgNMCOaK5igJh1Wn8XKnfQC54VW8dm8xDXunK6ml8ELSkdeWmLjg3rxmhCi2pNlBHBUEJNfD9QQ+7MYF5E+OcOQ/zHH+19n2ee3lAgocRfIEDw1USfMCCIVGJQ63PLzobsg8I8zejqgWJKyR0RVezf1Cyd3B4E4DxgVgB6KptRQsT6vALkLqeHUVuRRtM1ftDtmbKg11na2nXFF0ejLdfP5Lhy5xhC7mEruiPhaIzF5YOcrriJnaXj2Yvq7uGrkGtDiOWW/ZHfeLMCNqNxiniWTR0+EeebBT8fAaEQwR0Hdn9aT/xe3h+fd8ts1rTMI+I04Vf5Kf4nkapzHIuCssJ/5ocExuWM4ZjENQHlnOR4l7RkVpV644ft3/++qN3v/Yrb34lUKMEz8EIdtNntKLCJwx69iGBsaLuokHlFT1t6PIM33DmdMQm1TDvUSKSilVKIFDZKtoZYo7Pk13RIpM6sCaxbKzqiH2XxIaInUesOu3ngBAO7JkkutjOTWIT3ZADYWsUS+Q8xxS0VgA37LHrV3njrUIRrv2W+TWyEJ+h7Xajx0TDBBXctExbsg9Lb2M4bblzHrCKxVPLLfOi5JYJUqRA5tODjJMRMib3akqWbAtPvkGdx6FB22yDENIGBdqgum1Q55GBqe5a1Xm0rdpqW4XQSKvmK2CaOZkGxQ428eYNmnENmqk0KIVrdm0JQpWzpU7Vh2hS9drccsHIBRsw/F6a7a+4RWVFqV6haimyTx9i89bg9wzvg7xBES3diq3sHAW6Pg3goxhTQ2YyL0P90Er1u7RoNv00J8tprRwXN4f4A9XxVWigBzpbdDIV8VhyQKkCrAjJAxSzXwfQ7hhmHzGyg5TkTuyQsPIO7uD9jkmagyDzniBXI2RBnlNNaT11s99AjqrLR+pRDl2WW2mJ5io0EklztHTExaA656xxyP8VERgMKOsNBtxxSIZErQ6xuD+bME1rMQ1VD8FmcYMqL3iBNtDODaHeZRRYFyhUii0iqPgYsjwLejyrlJEZKrv3+9koMszXy71SQyyq3C8s2zwRqGUfUMVnNZyWR3rzsojdPVns3p43VV5dN1e98dyjF2rv8sz7URs4ZgP3ulutciX0ffLkT3x9HjTXZx/0xq7PPmAy3umbkg7ZwC34dKOiUhtYldpDIa7hh06l1rQqMoG7bGCAQFjxBhrx3Ur7fnAvueCVPbeQPoRtvfY4MQVleL2wtkt94JEI56t32hN7p10vbrM3ZfL0EB2oiiBA5fe97L0m2yBay41U6Fyz4yxvP58ZXKK2nvbkER57c70d/pEI/L1W92YtByCqxN5exr7NxcoBCGJr4zH9g+FadqvuSmJzrVXbdLnsCPSb7xxR0Q4Y+9ZKVj8ko310JD0WBrNA1ElBXCltDY20NXLS1thIW+uy80v6HiUibW2IzD9vogYkOUkrtBPHpK0zWKs706StMdVV2hpSS1zhR2PS1nC6tBXKeWuamM+p42uC/yuw83jM0SxlVWlrAqEsApJFiZm9omJ0qCLFpznVfpgBks32b4qM7Yrf1C/ELZHuSOeEyM4TP4+ONhTepYaEFJDfznjKgH9n8bIIX06gVHpqIvyJFMqS2Ynej0qKkAOg7WyaYxYrwxySijmUnQGCc/xjXb+EOInI4O0mo4a5o62Eso3INrWQpWXdrKfjUsX096ybURGoKm3Hi7j0m3Q5ilzBRK7N3Y9O/eCkXJHiw3Dsw5NwS/qXU5X7tTIpFDq2v4VSoWxudbO/WBq6TPba2tb1gtoA71DprEAjROc4BDlpgKLDIhwtHFrNJyo+HiveIxiUjADEiEJTi99C/8I8FDUFACy2AAsoVpAV8VjlEcTTJ25ANNqAIoJ+I9gtDqCiUeiOC6OX0sicC3jyDPB0pGn3/qJhMxO32YoMHTPw5ocCALOp+jtdsaFxoEj7xHFWVtDfuUbu5SKoFsTZl822LcYUwUFBrgrQsNW9kYclt5a9CdWDkkEKT80NpweBK/jZm3Fj7AJnargJ7oB/ZJKo6KFj5WeZ1AXvaLNa11wfJzydfCHYa5syj7v23ou5CbTATZpDe3CWAD1jTNwQs9acV9o6W6izJRUyQYHfonkAZZ5wNOPEFh11yFfI2W7RVuEFP7TZIr3JQ6kprNaBwtt2GBtV9fFd1KAUl8Ia1MF9H6ycIKANqF9EqoWeL/LrUPXJFyA2kmNGEBqVfmjmhB+Z0SZfEcVK8eWEn90QfBQ8rMLtcuM6l/Wy33balrs5pXWAfQZAQrikGnNSGsVAhUz9w+ae+u8TipkJMoDW6mgsCOrnLYz8DIbEcYPLwQS7Bud9PZqBZGnZyK8ae+E7ugXfUVWPngpM5W0qWDNjsGZYgXJYOb8JDczB1rdoAaR3uZK8bEc3xui67nDDZ/uKX8Xc/nxegEGxILfcz9N+6kFmxnUuWNwCnefBrw46zY8gFrzeY3lYQDLjGBowqw1IpdCiqYLJplwXcGwIg7SIrP9sHYIx/7ohxWP+dR0sjMgiHOYzVQgVofGvO2NKDsf96wYn6Vk3dJ51QwqP61k3dI5sS3e6Rnt7M2+6oXQ3YEpbla0aZ7oz6ky3WKblQcWh7ow41J0Zd6jL/acZ8G95aBzaNvVAq00N2c2omjSoxAHBfpVVaZ6my3MYedScx0g2FeaUE6dulreuoEWmWtGWaqrmNHq2VkZgu7JFGqZRErQVJ6qXXazgIgmal6Deabke5Fw9alaylLClKYBWt2UopFhl/DMzYJWt7OzP58RfR8FiaVZ2oR4Qn5074pHojTdg8TVc+VYO6OxIyBcXH9cUgv3IXDDi81zAHMwoldC8+p7MVCfG+AcR9J9naImn/nym5VU96DqEDikDIzojKnVHMJhtpbYLvLTwKM8MKBo4e9kU3jqkBeXVQKsznZUZ2jOPxzw1YUS+qR4fKSHRWJ3DY458KPr4lOIttZN2tbImJMLw7rvh7t9+4e7/dp+u74bKbKM6LQ/z7SXm3nXRUMPasoInJSmxEV2knEIn08sLakJGsYMzvOJZ4obmlZdWvCTCDSO0YZREQWUesgX1z5KRsRF+SfY7yriBmUl4TSx8hlCliQFy3ejp+HMnlcit4v2KfBaP78znpKS8qUOlDiH4dwc6zqsv7RCRfSx2AObQj7awxnBgp5Sxn4DUhkIgaWZYjkOxgHGZZv6s1ZPMQwaRuX+Pytq6fDer36A0p3w0D3JMLYxSSx0eiLbIMmpcdjeA8mgEt1RFy9ct16gUY5aa8LdUtsymcq96kBBxx9BOQSRgI7U21qXN2CneRqFR4oCQCiKoGUFsbqAP7DON7qiWJtrJFFe+BqVCfiXrKWWaMxOwUi4qOPxqYFrMXFm0enmG4okDoeM7XqZrYKqfyuHEAXhZhDcf4IbuoJ0QaUjsOBRjNMxDSxZapVS+qTQAtYduLG6FRaTN2alaFavB2Jpr+RSWdtkOe0XTXLEmrpxbgN3czB1CCAZDgwbc40SZLxDYAtAaDEVs5oRZRwcgAMMRUddQWjngnF0YfRqo1ni+TB7GRjU2VAut0d9d2j71WRliUqGj+8LLysvCJO/YcYhPpR5Mael+wFeRJ0JW5EkBJnMwYiMaHzLJMfoVeNsPUXEELbcTFvMCLcYc93cQ0AsPkO6amOx3lcfjyF/4xM9/oiYHzK5D0vxA9zke8R+fL/888nEt/Djj0l72URRQNvDRty77mB7sfi5qiFqf2aXE1Z3KQX9/UVfw27Mzn/xhngjRidCGBh61AipRbp5WFYbkIrQbfCztVg+TPL18sZF39JpLxi5h8lmEb/TyOTk1F8+cC5XyoJ71rHzRxcA3WB2+FWMjYKnjPI4inJXN80OoAUQfTX0ZwFjHkH+diqUL8l3iVGTMsDqQstgX7nr578reQ37RwAkoX27U0hk5f/UIyhqM+K61V3cjuZruXNBExs94jBbi+znKpN0c5n4KmdcaYC4xw6vuXrTMRMsMUSYpcRJdpEUgOOaOVqHFoyKKuDhY3HBNBiQEqOKAGK+bNpiWeVywF8C8GIOrXAahJZywtigta1M5fmusHHDNsg7Icx68NlYZUT/Vg9iEDwPyFC8tVXtLZfom1cuMoj7LPyAtxRJxxSwVv4NjVChPLSc6F5Xo4QCWOdHi0o/Glz0ft5xV/GY1L8kfPRhQDQwjnPNG04poVAIVjrzqV/dMlAirAbfB45VektRsRycLZ/jfVkTEDwjmKZQnbN0x1XAVV4KMqeD2K83QoCbqt4P0PxlzLYeVaoLU1cirWsGDqVjymVbWYMax8IEw/JO4PKLoRbWNgp+DAi9HuOQ7I68+qhWmghZ7szVEr1yLcPfU25BjUYBE9xJDt0XI66pmNbaP8skb20e5a5/qg1/oEfkVXPHNPirRSnJ/fB8VacJJ7qZ8t5vyyT/ubspPKXbEoNxQDXHy6Fb0wYBi11xty5E8kv47S4xAqoleAySJZpL472cW7yTgEY/AIxERQQUesYVHfHx4xBSfPDxihkfidpcUkUWp5OgQjfIn9z2+WLoZchcM937uXmGUNwrbny9zc3032VHMEG0S7AbGcddhBmMoE4wJ28Z6+sOPuxZlYq4Lnu6Lbm/A2Sr6lL93An3KfwqC+Lr6tZspHAalIqPXDw6AGxDvpMR/fDIR6c5BZHt1CEb250nlTNYhQ9MFU0ihR3R4yaVSuj4smg7eaQXSqYM0LiwA0m3yif+u7CFiMIRVAwseVee37PrC3iFnaQygiiXGOAbKC4izS5VbhSJFcC0JefnnzdA61+ROo7lFzD5K3Ay+R7XFjGjzYMPJSwOWkBp1bF2o4TmmhoTCNTEkGvMl72ysumx6ddmGra9d1teW+iARNHW0ODZvIQ7VYxHEeFBalq73yUSX0N7GTU+RW4xi8NrY4NNNItYAMG2i8Jf+SLCZLrO7oRxYlWRIESPmWB1frHHhZSYu4tcDfWii4jrS1fzGQVmvKoqwgSrCtnyo6X2SGU6Pxevk67EFJ1IgnOgnkEKhcqSs6RiptvQf6ZmBuHs62TpDrRPtHdWyZv1Kr/+SF0L4mUd2IkTIXdG1lpOOqq61Z3St3R1+HJ/qw13UzT4uh416+yQS1htpqEuvn49pYX9COeTbvCAQDrm81IshjBCCiZIIHcLA2qQ8VpMeNrtXKpDgXBWK9VDfw9UorDCiu6F7a90GgdWL7OatgRW7YXZtMa5L1YFSdXPRJT2vqkopSKVdrt6en7iMkDo1T9mEQE3zY+NqnvdMV/PUvUwyoY78vpPXsQV6qo6totqkji3y6DbIqdkq8gWKfE7N9vdH1WwtaY4NaY5AnKcp3IY4xTF4FthjigCUoqJ2Gx5P7TbmqKC8Xt5S7dtEH6E8kJYdO67a7R8g9VGqn//huPo5OlOqn+NlTP187zT18wJTlBFl7VHooKuurw5jVdcXLVFd30fXs08+0p7tLnsWZp/Cx1+HnnxvVfzwWGxEFKGxEiGWRMD08EdOddrNSdeIrm3EC71Q5rvKhQN73bG8cSX3HeXp6xP2hA5gGmDGxcxOCGabBIowkfQ9+xPVYxPiGit1ub0epEz5Fq4Ty2mqdPw8vRaqd2dLP4mQNVIEnYm6HsvhjFB2+QmCO9X2ovES0FJ1CoFbSi2zEyqwDREKFoAkgL5CvmQuYUJuAGuz+QxFeUcOUDxqyyAj2TzYARiMaBnTtDN4zFAHNFSVPkOq4xhdxZHopboZ9rVKOFeE0dWfuqqIKeOtURvSCOnzHIXqghHRM6KcKTAp6iQf0Mxake4vjDrBAk64eEu1iIyd/Wv5kpiATfG6zML2rgCj2MIVS1ZqMXuygn5Sh5Mb2Lh+lW8VXJP3uJ+L+7lM+EenOgqI9kPkD1BvQ3+oLY7W1goDp+02cn//h9Y0qilRtX5s3okL+lrtMvHuGkrWoqBZOGJI8PbcXrGD6po1JjRyRV92CvvCVaUKr55iYY0SjqS5564Q4RKvDE9K7ctWaIZngA4Bnh25UF5wP1S459FOaOTSMg5n5teyP9WZC3ig+C5FtOMABrIBhXUpFpN55riDrQeqLWOIH9BFWUsjZa1uXta1UxEH9x0VOxPupzwK5bpyfqlz3u05P3kSSLlxtWmlgGUGxc0YlFP2gRIDaGz8deHZThEGsUHbgAiENyI+z8EwGtcugc7OSz3vFYbvCJwWh+lNEaEBIcnDQwM8e9ExRCdD8tEcHyVNZ0xr44zpEbih9a91WgxR9YL6XX7hbp+cBSC4iw1WNVG1aTLVylgo6twP/RRVe0b7qWaZPdm29zOYG4pA6IkiNeBUh2m7Y7UX8v3GfvhSSDcpkiv3OyV0Foe6anwSFcAcsh7MGFoJHquLZebPZZlJRFUOsjJsHMWhi5FDW/IQ6Tkiym4BHlH2M1g1wAsgFqUZmzKc9BmDxHVZEPAwFmkCtYWiYWEG5eJ0QInaV2mIrnqAZhAHOFY/MNsH/QjNi0grVj06bp6TkR/fN/ILpvtGVsuqVU+zVxexUDvnafYK52n2ZY/Z0+wXR01JxFUzowaKfzHVFmhdbqmOGButO2Oj9Uljoy5dUgHIR1wNMLmzVn5ynzM8ylDIPusMj9ZlbNWwAMY9yX5KrYGKriUaqPlU/xBWRu/FMg/+Vs2MjuBM5C5vjZoZDblpQyk4UidcyJ7X+UnhqJnR2Cmz/VIzgnR/9bqgosfrud2lekYbM3P5NmfmcsOZuXwXgk7Cr3s+lh0CqUDeDYPEfVpAxzKZqpjyFPOSKJfGfRjrU84gLA0z1xBqVsrlq8amBVIOhfwVc34p29Ch9OwaG7GuUQo60irpDHZf6m4LHxYexBOSt5DrTA3kP1cOVNtYfrAm6VGmVLGK5N1qBZ9aeUwdY9xAuBYUrvJ4S9itAQJ3I7s8kEUjUWqrX38JND+hG4Xz9Tlq64kGtFVo9gAy7pUGLaIFu/Klviey/C7/bZHL1iuyKWXYHxRt40Xq9mPO3+Na5mRl64E58PMa8vLfVi56hVuFLztKw5lTWKWt/UTYA5SWx1zNjDmu9mk7edzOtQJefnbz/Y2jmCF4IX65y75k/DLQF73mwULlbVqBuMcnRX2cc8vWX7ziE/minlGzjvGtG3xlBez5iMcNnmHUk17MyG3ympwWg/URdgd8Q+s55aq+wkHt+za87Ref8TF3fEZ6tI1WKF57dJ3CtbCJTgFqj7xf6BM4iVi4b9qu83OetsioxBWAuQpQnljf1pJRbDBebBfFdmlZIZbkW7ikZYXYPOOJqnPwY5YW9FQf+FiA2qQyHdoBthAeUO7ZuScgb+fxFD38PCduIKkRMsopxrMoHv6iR8XD/+Rpv3PCplZnQqacjg+dWtTXClKGQttPJwvPqUJFdgAWfc8gJAkod3AI9IiB9WK5ObKDPH4VuHEAnBU6FFEbHTnXTm5WssX7XoYmovZQg0PZT4qrhh04QqIdrHEUpEY6R3UZFRAlz1k8+Q8+bDtUtlrYpFa3WyGFykDkEV6VcVmDgr7zkFGV/6Xv8LyoYgow1jWkrkaqorNFsh8INYQ4AiS0iaGsmgdsiup441sRPLv2Nmirf827Bq+6tPAjzj5XNRwYl4YDY7yqyQcYDowR4QwH4gXWnEcNB14Gq3d3W8OBcf92aywqRoZQhlvN4aidHelGdr81JkpSHYNjwo7gXz4KO4L/x9n6e3cas5SNfcc1r/Uc33zUqzDOfeyiQdWFQ2aT8VVF1KtHX1+gma5wxt2fpzYD5aKw2m7KY3kmeR3IdyFQRGQLd+JZt9boY2ONXrwIqC1BSKj0xgxAwVNanl/wGCcjcBN881h8k4ocTFymRVBry/4W35qs9tOGzcE3VISzbVYshqeI3pDoFo6P9SCB1B1ZSQ7ExmOv1IvayeugHtzu/1V1OlCk2d+hanGMVGQDmtn3sade9/1vGXyO65iltLRhPpT9+4aecE3TCdv37Zd98Lfu2xbv5cONuexv5Tp3or0jmIpGYa7585oDXMfCRtE2KZcz49vQq6Ib3MM2Tj5EOoB7oxv7Xr7wi9/65z90Y7XWYnE4cL1t2xpYWaY9GY3zXMdWU9iDxhIUD6RvzHpxS4busxRWr48US5Stv7lSI18hy9jec+H3SBzVLGwMGfAZ8fvi0HYErLrVK5NBwB5qbHDYdhdX7roOBXL8Xdl7vvpRfMBYykLk83kFenX90mty37oe8oX7fdAbs34Hx63iQ89TDvIh2aWo4bvs/TeaEnHysuTGgzpo/qxoesxxMPsiqpbe6XWfDCGfy8HZma+CK0nsQ2YEAr0PzwMcuBoBHLUxfh2tXYaWouXc2X6S/dhBixfnrik0rI70evYepFGENPTpoddDrvguwdKakN9LsIeCQDrYq6TVyuPxERb6/m+/Ad+8o/LN88pvLh/9RvqgLavphtTPNrQF8tr/+OvHy6KyrO54/f2uWtBiPdu6CGG1yHC0yDc9qiIVkKLa6woEtc8OvdqVtLssaddESXDUGGGvIPv77Ms3ShHQutXE/ntuQMPerDfbNSX7kln/atbK/3TiQh0Ksr+XjS8GwRuzlnj7NGuJE7FYHFWmDAn0FOvP2DmKFcUv6D7R7ch+3Rv5wp1Ke5gbYsDVmQ9E7Bemxt7rYtX+oMR+fGrs3VNLeN/UvHdN5PWyH1cXd77rBKayg8G/+H7CC51bvbFmjlqLKyIJK3lRm796Q600lpTHOs91/4sFLY/UiHRRt+V07ebR7Bzh0ge2/8hTV0iFslbWwlxDW9NE+QnUYROpXU3su/oTsUAHbzOIa/uIEu5IN++aXz6bkS/qhMwpMkPZExvwiDgQ4TwPAVBFLcsjLIvaN7nNl2q1pj1NdJL/Ulc7Ezp0M6Ykb+BKboYuWyiASxvtV5reE/gVL0g04sLZCLXUuXDF+S/XoFeMPGFZjd2JLwMJzvO/52Ty/oM9qXkexFNZ6f8bVhrC46y6uZMZ4QDF7QM8ULeq1pDTIPG1uFJDZlgq2Az2HVzZHn/tF55+VPSTNrm5oGWTr85BnZYNuVc4HNWLDIleZKhoKFHiaj5Cyfhdhjp5xH+8s/BS1+ZprckFB2IoVUXwjcL9/Z4f+fA/7Pqev2OwQVkJ98nI0iM//b7ppIXMopn9I8ag5Ob+CW+od8wsaU0vW+vtBDB6VWL02nYAxc9U60FRTiwX99/qrSlrp4yerMgPgibkdU7VDQE4PkaNOHtQuP9E24a9jMpCQ/zILaakNCuHiY7xcDdrYYYAKXo0BG3HlBENJ3K68UIazo4yMBMQ6IidTr09e4Ra6w8FeZZKTbhAm8mEB5mYNbXa5iZQI5c7v7PG3B9x4LIet/8rpY+PoiklgWuy50ucfRZBEEeuAlKgNm7Qu5MH7WuGsvWQI+Zb4mvSCqlRIadNOWgTUJukPQy5Hq575HPa1Gt1q/US9dAVFpm2rK0iRFyVMBeSmxxtbyJTDTJ1tHBWYrEnXlgTsefMBthu504BdgZaqtDf1tu2jJAC+/vr48DX0hYAbRkxdA6Ls9gAJJ+LFdm4stDaUOowSERBXY/RcNqTWdvmGlY9Zd2Pvgw/LwF+gS+IbT/O5aCrGzfgY9C0XSS2BGkRwseF57y4WLywdgkUd3EucPU1RRu+z6X2DmJpgRZ7cJKOcGc/fKTHuA69F57Isn/WSaJV8oDbrdCCYRRj2GxqHxB5YZthpFY30QVqZ3+HLqsq7ZflRpHabdSbBvKp4kIH983mFBfbiplZam4go6AK1pAW5mb36lr2Lxo01sRWETrdD88PCDNC8SVRfBF4whYwBshRgHP5QqH20ApMwX0Wy9U4kKaJ2f7LVsUnVHu6nWcpBICom81V5NTpjJ5jPgJH7eQsFu2UWkCBM8DWBQEFhyq6aiPLAailznm526FIsehEs4yF69DKwi1LRfsZxk690oBl12ww9GtEyy2OzE7kOQzEHEk3O+VY6JYhK2Z05zDPXbemkJbwUADMsDXgItPbp3N424Ofc4t0DcRAJiBqoBThRZlDviE9IHc4Xqzct00hUU7leipgh2/5YT6byJ0hd6a5gU485NzaeZXl6LoQ6rowZePVMJuuttl0ZUBEt+nCHBtHpFhRU+i+MoeYoKOvTX39inlNRl/rI69ooVmIVtV84yfwwlzcuz5xPcv/E6nKSw/HYXhdCOtvVWdVoX4q5rF0iCIzZyO7uYvM5s5gfYicnuzQsy+9WmMOZlDWuEMFXeIlBgQ6Ez/2O/tmpeMICGtC4kiqaOSWDMzRi+29soupLmYk3F1aWfMi91WqXsDWcB+i6kFhWBYxdDdqxzULVcf+oNhC1ZUErGIlT2IUxfoZssjJjJBgkP8D5vZw2559tBgpIQJWI1Stjbwxag8om3pfuNOjxjruQLk+oto8wtnJaD8jiBxGOsmfVnqnSm+jnXTHKlSnGWhXZpXkrDzpL++kZ6qgsiAmZrHMl658EoTkhJifxOtCC5CXgylIB7OHXuPcHD6sR4ICDFXya+teZMRVP4jEqiYrNkwm76skXzKZvKeSfNFk8lmV5N3VZAornq7e4pWOa7KvouGTdiko0JTj2KJwmU7K/gSFmvkkbE7cGQXhtRCkjx0XMmwnrgc4R1Nc6IZTl8dtCCPc+0e4HKzuCTCMFFuePZjk2SMKhkfcdbqjwzGuPaBgkj8PFATGGoQTJRZRxdJFXeFbaZocqiXi1M0b7e+m/fSq/WzQeN8ax+1b4zH0DT0hD6o7cg+VbId0++GpUeg6sAD3L8b7iZ224sQ3dE9lR4a+FgkfPMv85gD6NImpd/lePN06ilMadRufQlXr1CGosahep0hvYOjqBvLLcQkYo8Qo1KEwoyoqeqnZ15TwjFWhRsJj632lrtVEelIUWyaqgIki6wbCfKrHKX7peSA7KKdedTSiXnohHa2uqMtOUe+iearWoR5G9OSkpU3VtbpiH+dKIT2qyeYLy1UEpf6DSlrZNq7ccFQwM2qVuzjViEQ7fafBh9ZDe9KpOP03zz+OkefrX1u9Com9D1ejHQOXpNA25q6R4dq1wlPJSWjMPh8OvGjaqFd17Y1ieiTbxXhE1z7ioxyOhaxY7Mjt1zaYE0GZJ6HqAas9opE2RKpx72yR+8BV2BY291dL28JRaVs4Vo37v7ihVHoeqbd+4nqhPISWj2rdx0y99+eeEdGjSAor+vYxmlvVt1fhXtXkcCilCmD1UYOuzA1O3z5WfftIBkqPyIKqJvRnkbeWvuZxvqzDiyU6QgEHqpd0fuS1x7+k8ygV65/oedP1c2FCJrtZEVaVcQ2Kf74VhnK7ILl2KiLq5iM0nK1OsAp3VefXxFjdX8AkAnGlBp92IKa7ZnzUUx3nM6BHFMLqhbhc/IEX53jFdsG4KK7cGcLukoUFm4vw4Jj3BeApIJswWkM5MPrkT9xEBOROOV/Gh5yVFox2MrQpX6tYBNArOClb53VRTczP6jKkyssxedokitUkRdGpXj/MpppxaU6YcWm6Bs6qNYJhzj/Vczaaket2s1pd3pSTsMp1uxl73W7m+NftZnAPqWi663ZNam563W6Gr9s1U+pMvX6YyYfu+mFn8vrhjPS/M/36YVUta1YzueuHJ4ZHZwQes4BHpwKPjoVH5/jw6FDn5OHRYXjMVgSxMzRbvX6ITyc4hqYgE6bKYAiX0lfguNHpNprQvr0DiP2HfM7MFrn1IlvbylfRN/WXslHUN58CVeTuuODMYxR+A683E37PWOG3Pyr8dq/kWxYsm2TBsqrwOxsXfvsMX/5jCjNThfmU1nAGudAn7fGmc4sdqjt0hQ2UCvvvjUDFI061re5MtpoRDbiwKePIKDXRQr3qh7ObzmCgSDBLbdcgqg8dLODVfFC+jmi8MnLoalrpTN5U72JQYVJmcaOwyTulaKZ1vmzTAgLZDmEeoWKTPtwQaxkJxWpK8wEVX+gd0TmQcOvSCVh46bhNw3tDL6pe2jYrHBaJYPyqNix94JLI5FXt+JFf1Q6UHYNBsdGryaHQhqByVbtqVqy8KE7h8WkDN/bkryaHelU7mkor47Gr2tEkrQzV/MWJr2oHmsnRyhPDIxqBR/CvdnU9qMzbkIKTuart22v+pRv/4fPT02WDTNZBp7rXAev832Gf6+k/0PeyG8AFpY+7cxsV6WJaVPm8Vx2fz5t0eKGMaPUm5OcQsbnDi5t9r3FyNx+LkLdbzruIX7n56HyL+OO+RXDe+qDy/5Ad152cErebcevR9pxcZZEw9Fpu3rB8fUyR5et97FPRfvL1ZoICRncNHjV0TxghgzxCeSAt++IN7kZjMHGj8R0KvnuyoH5dMOLoNtI8wV4cIaNxHq7P1dVrXCJ7FDRVN4/6n0WeojkTx3HN84MwtdqWhd3SIZxaI7rmZnTTvPPUjLCoa6+a/GhF00swX+iRQ6BIGJu4oq0xrp5iRo7oqW0qaCqEAD37sTfWpHSiSbKL0iZxnVpYTQtDa1NNcnlN6SPNJegihK4F8lGYKjQrPVVsrHbSddOb6GZc7aZpG5ROc0/4e71dbepsSRM8p+6J5oueg+uUJiYuUSOcjoiU4mqoZufOxDl/EVBa7TgA4SAaaN4E/EA5BonrWcv2NR39Jq1cI21NGalgbKSEhkD7X4kD7qsKqMnPbgSlafkYymZ/+dsEbqFeSTGi5VcjhxaB19e4D2JVsxO66eMhGV4r+jYKDzFveO01o2PawKNTHVPUfT3O4BC2IMsmxrc5BY09cEuAXYMyPCbhXatWJ1/oeOLDqWNuYjmUaTbJPdZumqlUnuI0RJ4BJZW2O4xNMWObSJod61aIIqd0q0mZOfPX2pvV2u2nWaVb2vIQH07rFmJD7dasZkPLxxtMM65ycGWmewHVp3cLjRjvUbJJj1JpAtW1R/rxWI+SKT1KzIdTe5TYHiGb9h9tneyRloFtkvZIqx/rkfZpYpQU9NOJy2zewdxIFahSC3pcxQ47In6VXqbVwUIpnOzyz46V4srmX2H1VTGkph+kjnoBjhOzJ9189tSqs2d8ouHTidlj5kNt2uxxc8qCojYye9LRQeH81dljSE+RqmEqnjLukBwR7g09YOqjO5LQUKZDIDw5KtejRhP9OkSrzZmAIrHB6svVhZYlX03O9Xr5OBZSFMIGmWcjn6kEXi4g8CDhifu4GE/9FlBS9lC+zUWipK1we5g/CWM1p61/aIgKaMmvLl3GoFSky2Wiser9YpQEpoqFdWoILPIEzdGlHFwSHtHommuLiCdJYfmhmGSVMdWy3SpoKGLiWBKSprtGUiolesgDVk0zNfMklQ4FY22xn+l23mJJMq1g1xH3hVZjPnTwcl2d+GKk8dqmcOyjYOIj06LQVhOMfqENDUe7kmhXwkpXgrGuJKNdCSZHzR/rSlD9Qhl682Ga3u0FkeBVZRMDJA40rCuv2lGNyBwy6EEN0sKibpEqQcxEbVHug79FrWvWSgTEMqgm94F38h1WOB93wRojJbQxv/kz3XvVBTcivEeMtT7FpqEqVh56QXASPdEehGiEroORM0jnT4FXKBfWDN9fA+Ou5KWo4zYWZvBEk+sUoan4lMKRNv6570WufYbbL0Lw+1Hfv0SiIuL3lzItWxNtAFWwidlyU99/YR5qWwgG5d4gZCNErrA0VE+eqKTdhDQca4YVbWR8re5GdDKbwzbnWqk2gV8hmctUdX0EuByTvVFKR9+cB2q0XLqgjHiMhgpJUDGzfpv9ML7Ua/B1KVqu85beImNbnZ7fYT3W7ZDtUCxlo6Zvw/Gjmmysq6UL9ZL6AT/w5XQB9Y7uBtxsg5RH2llZFhRftOVx4ZNahJIYQnYU5UCj9+QFnTQVDR7NokCRgmqay22+XKWVTIQU3cKKOSW3OQX0xysq6tWqxiso4koVKL/U7NLZZsUVCniQf70ylv62H3jicJICt2eswi5nDNADcZhnqussxIlZIKM2glIRage9Na71cTish7qBNgMdcZkNWDEAqqYxPZf2xNdcRYPfFS9863VFz4cMlbfAC7Sl8WQDR5tTJKNVoRYAz9SRlhMKDwM+QFUrCxV/GxfWwvSPkiAUiUDfywN/yiZ/Jo6isS2+r0Oop+22If7E6hs6819Akb7XmV5ElTcgf2zzmyDGVSQWGXRimhpidxHQfhyOtSmaaBMeoWmTes12nICq92iay23KH2mw8A+Ba4P9SqlL5DqrrP8oDzTeWNdTr9pTbZ3yQHqMp4e6WqnhYTx3uSN2TKvrFhITl2hya1GOy3I1uOyh0GdMzqjac0DCAdXXvIk9Ytb+up7V3TI28k2k1YTakcnB8icG6/j7/FEUC7UV/ijUw6oMSVmCzfHLcyIPvwJt1yxfAVqBtfbKJSHCjQxKmMgWptKTIrYMAUSlYmo9MTr3IQlFaDmAmsu1fnUdTDGBde0VPsbXwQ2EjxHWXr7DvAvAx0QjJbQt3xJg89gS3hZSUW4FVkLQJW5fJ7Ve9+PcECtfbK55ajBAvk5/xPdDvaft63LrgzVgX6BcPV49M0Qe2qpOaAoRSY/b6SXJgZd+Ul0HufEmYxGPZtVYx/Jh6ihUNLGc4QU3zCM/D7Re04pI3qIprfBPrhWJkn7bFWUI0zdX+L5AQVJBUwoMeKSFhT9CV8Mp62VRRy3SLT83omA1qUNJ7pEWed2mRdZlSVeHtxx4j+9HxxsttXzO0MljO3KYTIASt4v8bze6KXUg+RjkEOeNxvFxZJy6zKMtq46h2x2Oj6FdVQoPY+ihfYG0T8EL/JZWBcdpVTCtVYy/m7SsYcdVu6ObwPSnPNZPI18ZX6CS2YeohZIK3DBn5UPuVWgszygAIwLMIUwFteCHWWMIGSttRkTCn4+ybzze2MAIg4qBMdumZ4syU/orJ2/+8VittP/4rs99dMsU84/IM2H/8Z2cl0F56zs/13LWHw+/tmr90er6RKrts4mb9f5d171QLMl8fd2t/+hrj2f38U1IraX//dFYR/wxfFu1jojeOPOIeBu3j9ifavkRHz5G048YwaqpQhRpbRX+3UrS5uuguqEOr21dF73c+hXw3PVE1JTrCppHFhNwZK3tYQlkZvuEa93EP/uMAnvRUNkdovKUAtzNRh5NzaG4uGskps0xqxrTjw/IUrcmSaoegfiio37PrxMbQLJFps5Gno27TpuVDcks1UZcp2XOdZogKGwiiM113ZFSu/SPBue5yrHNm9shixVNGlWidBGZ3FKqYdFeFKYIl11wVWOQZ6nWhMZkQ6jnqH6yGoqZowXnKoVm4drAOtrqIIOybxATzqBpS4xoYz1Va0RWkU23LTCoVFOZX30XIoxVJepaFigDxi7ze/jSEQDVoRpmgISmZ65xWdXPu4M3ueBVPW2S88sOwBh1OxR97pSWzNqWdK7Z2PySBecTj8C78i14UL5CmUnonbCK1ZOsYjXlQn9Uu27g7atCb7EVxfdohQdxy3CAYcz4ZQut4mUL8mR5DQ/YDl3K52mrmDCcp1nBhQFwYcj5a+XLQIYamMGIg0eJkc6sIboqrkN1UDMZ0sq1D46erVy+cmkcT7PDdYwgt9yjrdIqFQ1l0ojhqFMM2wJU7eu+dqweEvPtW8Zr2XLE1lLDm/OhDBhNVnsHzR4ZTlaIvi7RVnUXqvN8Wz+COSydkqRTfQEQXs1zbs82OXuvy+ndNlwwFATYDjskxt7zVkmibeBfiv35DoSuyXfSAhWoJz+FtnMo5NCpPINO479d2ForsQea22dxOls7upwCwhOb75xOQ+MKa5LqagpKW1VXcD92ST8kpjidTocFpjNIMtvXM7l9heqgwln/HC1qgVx9LbxaLlxq+AoOZ5y+TR3kFzXJ50va5ZJPw3sl3wJZjkBoz8ML+Vm4VTkWdzYF/QdqgL4q3TLHyzh4Zn66jFNN7FudTmezDSmYj0r5zef3s/idfCTa2HnAsyNeo7WwoygMxJPOyE8nYDDX7cEFdmGFbjsxKKfSqQCGdla7wmVqf7U3arfK2tY6pdqhk2o8GsvD5pr/iFue0o58kRvMaKMCse24xypjVHONdyOHONcJGfvRTmx3Yyjl+OoESLvP5ZiRrZbDK9hEOd+4Y7xNZbqn8Vt+Gu3ChnAXbbWCvG1qLngbdY1XSNxgE7B2AA50m8sj6rj7l7MVCgRrYupAz8zDGokfpar1sYxqaO28sVTGKzfXDdisYekVqqN30mxTu3jrUmqRcwltnKEl8GRL1QtfQoSUwrSphuTaSHKrTG5NJAs1yxfMsqyGDEP81MQc0R3ZG2QV3yZLb75Tx43htGBvAW6102YBtwDn+FF/iZCsJf6DiWDhsggUDyVvRVu278f6j9rGyaIOBNHSWr4LrVDLbqcFwPTTaJsOTkG78o7SJpj7xRdFiWJ5JsZ0F8SHrK/4xNGwVFQayR9d0OZB5OfdDevOCMrQdsRtF8QpTtM4baCMJG0zFrzn0AxeK9eki3jOmSsQNDexlJwKm845Ssxppx3freUwbZ0+TIXAdptC+jQzFAuk96rHRqyY0wHScSD+22nHAuuTOoY9/lhol3Ii+CwMxVekWYW20i6as2Ox4+s2FtsqYzFnxuI0jMUuxO3SOG2gzD6ay+elGaep5Ar9g3Xr0+xAbJOaUMZITYQYop0odafeeFUQmeFY2mzWpApQw8PuK7aV82C7zoMC02YXEtVKJ5bxDmPvIj/nHMROowJ05qUHaI6ZQOREQxdzH6AD2ACv0V0BruzWqp1YpO2wAjoH+jY3QknQmV1qv3QX+rFrxCH+wfLy9F96nr/ZJvzZhV+ed15OvitBk/dWkvdNJp9bSd4zmbyrknxWNRk7Sb2BC+s/9v44IrO10j7JT7y2YrDfFRSOFlT1sH129XKOHWUUayTo4k7Pbl7Tr87Fzevil7Ml+5ezBzC7Bx0EpYmTUj2yf5TPZUmPce71JJjgdrUGG6JTjVPtZ0E94bIX52jW/bxgoSNYDdvGGIevxgc6hknLM8ITdydwLmSieYYLbxeTcnLzwt3FU/jDBeEPY8ITJzn4bjc/8QXRNLOdi5yScQ48a33dZ6ToYkYZ+MN58O8ILCCRWvkytfMueTA5a/oO77e47O7REsyo5itsES/vKYyU5cYefQv1YCdV+4KBM0/Aq0Y9gK7o9R8MRGY7k6/Scr6Vuvm2YK+hvT1bIeTEPOm0AryQ4ROopxXQdon4orG0CkqX4ZN5Ig7YzBPZtBF5T9pUoFdoi9S+VWvXCrV2NOXrXzvvRK6GWdtt/IBtXpbqFavaqlW0CN9wbARTpjnZRuEL01h8tcI56sZKLa9EXMesiBYwNoSzC3wtrH2tbF9OW/E21kRwNdv7GN2MS/By7hwauQoStNoPDLyKsmUFYwMHH9DGCf+HybMb/YRJUC7Mw1KDYaYeastz6ilX6BCFSN530A40BI1DmwS0AkVkWZG917iJ3a1o8CrAYlpw1LSApAXSF84DyKIfBUBfWNAv9w8Gazl263h2aYs8t1CT8Txg+yhYTQOjLnGZlZBwGlxMX4q1JO9huz8xkQCdKTMR3T3sm0l70AYe8EzgXq+cYKv9yvzi1m+XdWOVJxjPPDfJsnKSbQcYiEck7/Gn2wkqGISxyniyzggerOQFl1ArVtQKtGTTGnqCVVoTSU0L1LNoso22mwqpNoYsYJGQL0M+Tc7K5IwIbdqKNmEQSITGda5sqyAUFRPtqJl29DZrR/8Fj1tTegCRNmUFU65mCYE2hUxTtgqao5levhLsBQCnz7JtlVlGx59lAPP4TNNZtoI4UAk14E0NRtuE21DPiXr/d8w8NVqN+YXMSziL6OVL0Jizu7ceNZ/rVqfcTipsHcBGzRPTYTHmvb2cCwvgvyinnBbQhe0g2j1ARlLZsYjCvlgUIo5lWhJOoQVNyBeIAUBzSN5J8yb3PF5P4VjNg23z1aDbh69T9lXxoDJLe4Kzs1pOTvMTdLWcZzrqs9KdBTv6DvMwpls3HVM3ntnYeLoho7HBQtxWyTlP82akMzvS28qR9Azmo/7pI6qjmVIkrAvFMtEgK9BwjcOZ+EyBQ39r9WwQWLb0Q54P78L9Ts5M3MilMBcMXTAS5R0xBX1gg2yeK9g+77AI4YLbB4fsV93Dyu3+6/SG+4jJYGsu2EkNzV2lL168TtG+Gzee/Jd//5cXPm2474de9vs/fuZP+lxJKbXVL2FbYpD+ehI2r/NeiW5YM84wI+GOMEitH6/mgb0gD34X4S584cIbgVEH0EOYujryTvDI5Byjf98Qvg4exK9e9m5mt4MzhonnBKymOmDGZjGHh7uUfZKoxrCaH1Az98EuEyYOd02YRwtfcovUB2NLfVtUU6d8paXpV2pNvC0SCv04dfc1edRZZF50KBAJEd661JHblZSxML+zXualTsXVsl59DWq1q59uBPm+3EvH6tvJZ/Qs4qDHf5xeubQsx5Ew/Fy5G8xi4hk1rcmoOGLebgY2Pu/2iw5EyzJWXImGdmooKh1wt7KfAsjVLfsqzVwQaD64wKheUNWtRxu95uqojQ5nciCDS7DFTKXDM9UOz4x32DRH+zyTd8b6PDPaZ1xbr9wP5z53sM12sJEe56bHnCgA0Y4LStWcrjasercUSy2C4gg7oQlkPA4e1qp4CFC2SswhEyahDq0S01RVRXGoGj2ZXYtRzKtJF75xMW8S7xApXhwMkZhJf68Zh7wHTfg8NCn3oUVdTHUdTff3915TNEzmBoV7/Hcl/AwuCDYSdc9yz/qoe5aP4l3ds2iSXEH/OIJpXxKF/sjI78fvJcbPuDGD1uhznOQrmmzukGubwr+m4FbREATutYFjNnA0sRa1W0rs2ljHURePjd/fAwFQQ9aUjJ8HG2sSnpXtX506WMM1nuosB0Ei+RxEQC4l0xweC0fkMIsCWhggNAfF4zmqi5Vfy140uP01biu8ezTN2714G9i3Y3g7bN+O4u1gk2aslskMurGocuQ6b754QHg/0N+7VnXIYvp9V2oCAxs4bAMHbeCBpgWbDRyzgaNNEbHlK6i0S12WRSK0E6Ge2QXO0qrc91Tec6sFk75uA/wUdqnAbo7mhA3YRvPIUwsqnABGoDmSayv1JnPV+1kFnPO0glb18OjZvWAiSZnCr6licgUtXjLzci9eyLw8gJfdCnMGW+VlgBcyL4fxkpmXg3ip6ZBktIVnpenuEreaGtITYWy20RxQRcLbwb9tFVKyjGy8eQCzMy5O+SD3uNiGbACeAcsUxOfzFP6cf/4JzOVWhLdyGK9SN8KTUAMO5YupiPchIl4W9KEuXrHZBMZuoUUwSQbxUguapplpCpummW4KnKaZcwqdpkw86sgupUO+PH3B2hju/qx/w7YeQyjieNlPy9JWhwSX4GeMWUyqWbqwkf0MkqlRupz4GpP5B+vUwELxZTwPsjLJA3WA//SAzg8IIWvLVcNqyxVh0OFgHTZaG9B+uRm9ZOKEucElvQsWHQ9reAPhmzR8F8KHJHyef6Ma1I4Vx7NfkNYHlJQuWpy/st342VPEzl/ZLuevbO9j9lf2ujD0VHhYMa/dtMzfdKIJa/aEZ5eaEJTphansLQJk8eSyYG7LggGEEiRusGd5m5oVpx/4Gqc/nL6gIQZiRqoVy6yYlg0b5tkfwVonbPIkVJdPnPu9E5fI5axzOgdbQCO9T4crWEZ1VOuJxStxdo/UxLwRfyaO/aiBowIxfWyVXxslo9GCJjxcKiFXNkQvj/lOgwPjy4CRCrIBoCNMkP3sW5DN5Mlu0+SUEq2Wl2KYNIeMslWe5YEdy47oHTKukNcLIkCqTTN3wD4KvOG1GGXws2c4BIrWpFFewZkQu8vtFpC+m5rOXMAxoIJ/LdDBbgRCp8vkbF9MBGrZBwC2XNyIbvh5RLyiH/VF14nn1S0hBVMQCS5bBpxEMbtgwzOi0GFpYcNXAI69gn0P3WXcEK6/uUw8uJdc8Mqe41EeYk212zk/ttR92FKFuFdaczfuGqDue2zgfht4kAPCfPATlOHj8uRPfH3e4kt6cBhPi3YfvO784JBvShjYwF3mk6N4HvPRhrs9tEFiX6L1HNDirjDfXK6vmVbe0qwJBVUMRwFdkDbpGf/eEorx6z6a+gWJOYbf7CfkNCJgPMhDPHbnkV4IWh3lNzXyco0MQMe+s3qWpMkHKslXV5O1GdkfYPhXcMIdGmTCYB5J/2PVunvVaL9a3tOmZ6+Tpqpruy+xTVyxySfJagfmba8dtc53ki49P0ZpyOic8V/AKO3j71rfMaeNvAnyO19lTpUpvSdTpnQwxpTe7JjSgWNKb0cw1S/uGvvire6Lu9wXb1M29uYxNlYpGsAgKXmaDYUouPlftQ42Y5nTjjKn2XOL2XZN+dI50L6wgPZdvsCdPOTh9E14VV270fFEw8vIu5B38UjyLZxyb6YpK5XKqJP3yAfvBu/GNAdPfJqVWOd+G/LTKgctc8tcBR4E5hbcCtEAoa1gbrdSC6xCq2RuOVD6ABQKO1/V1NrOJBOn9bQlL6ib70DFU8jJTnCuWKsRGNjAYRs4aAMPzJnAvTZwzAaOzlGRb6Md+Slc36kQMdOpwLKW8qU7bYf19TRAQtlUhcJWlUhBFYBfJ9nUuZFcO+mUyVytfuYAA0UGHIacgscpdCoYn1MNm7qsbKqKyfTlGF4y83IvXkhfuMtVNjUDoEpeDG+DkhfLALKSF8PbwYSWdIQoZ6NIPcBGun2KdgaIpDjA430rCSYgNChRAIN/VQ+jPzrsBbLiiF6eOyhHak7z4B+xnu7NtxvcYLFrInXiTSujrVAKkvKvLLb1GKdQDwe2j9WCNuS70GaUCYE5LQnyLp5kOXvKYjgupV3oyHaawR+EHjQnHOocrcpzlVLIlFLqYbR6lCmbOlMuUy9gMdwdd7hV+M3FdvOydy+54JU9jdd9uAte1Xso4OnmvQR4dGAjP51nC6Y9LvKL/s/+kn6sYa5BmHa6s/k0zKlCTKCnC40HYt9WHoKYt2AUtrMeP7MLWoBaYKeO2mvPM7CwW5ndTXg4jmVrqO+BN73qUE1RIVsXau2y3K1ZHqxkeSuyIJw51v0MZd23mzFmUlFy7XSG8OSDBEHDlB/WF+XKD8oL2PLtzJbfmSi3beldHcvBOO/fMbx/x/L+EoC8KPtZaU8EYwcb+87+ltXPf+a8lYudHTRp5zoPG20fFJTdidx4GV7Apfo8hsAztGEXF7oxxDwg3IWSebCe/RhUZG/PfgKPYbGL8CXtWic64nBiwJjfl6WDtrsWPCSWNU9Rat/C/GOXs2fq0gHv6jxS+xkx1hgvsn++vhSCSDlFB4a4G1BbIf2kmN1/QLTmPI6apYzfQth82uPwI6zQYBckF4RqyZk0+xx1XHAsy3uVNWaxspLseCSFkp9vKReXLRRkPycDUnDztzOMZ/kZXhA8wE9MxvvxpAuCe2dx1IKOragcq6dXPNhZBuup4Sw67at6+uomC8iJFwcN3GUDAxs4bAMH+WxJ1lzU3oVq1TaEdiJk15QdY2tKMbmeYKU48Xpy8PFcTxaV4ut6oi+HdT3RlwFeyLzcVV1PHlBNj4Zbdq7QF12QLtcXXar2yhhhT0irEEfyYz83LwGtvbSXz1OXVnG9p1TPgx4a3k/lmnMFGwMXp635Gifsz1fKNSFf5uADs0yxcKRkfAWfSls5W3HKGi1ziL/fqvKU02iBTPAshhWPfV5798PzxE/v3Q+zgPb/8ZlmrBB/eBqdtamo5TTzGT8rn7WmINdZdBqkLKdBxHIW7UR4p5G4tFTiUjm6OgXILz2BMMznRekU0SXrh26BBKrnK6nKiLD8YLVapRWzevK8yHfhee9sTng+OJuDMvG8wUXULbJYbbHTBIrcHfGqW8zSme7uRKbEZo4LnexTvrPliY7Z3VkOb7aZkiI5708rhKCoEILlKcWcXU72tJzsfHAsc+EsniAtPevGCn52fhaOuLVxO0Sk2WbMz89SM8w70Jevwqz0NXJJbB4LmKASpj3yfV2n/qJMfbSiy+gJRhJTP3dTf3ls6q98Q0z9ojr1i+rUL6pTv3jsU3/H5lMfOrmnGG6vBQ6N5nEujO6bCdsqhaHnbD5jtzLEznlk03UKOpxTmaznjE7Ws/gHSKj7mG3g9bYB1Gj1KTj8Z+DKFNxRCkuvwH5rvk+QOOfSwdzMVpWVpgbXzx7F9bPys1WdI5W5WuI3lEy4PZxqnHvNKYuZULvK6a1TJLCp+FwdDBFTo/aEWBCJEsKhEUeeLj7bHmDJS7DOtrBpRktW9pVO58JD2l4phci8+HjZ5Wy6VkqlCAyQS72fU8erAh/FJqKwWQBHB/9VEJ3eA4VKYBNYNA4+W4IXcegSCe3h0D5K6Ayc8ikSZT+vfJmrX+7gYBOKQvlsKCvUPYyRg2jsxzM1MtEwsWQlodvTizzvWhG7BiS+Qu4oIoogcIsgYdt9x5BqImjjxIqMLXsz2pFeAqVOkRBsGAkB1wLu7F147aR90nuF2TEhfyoyMHlrkLogHwfSL/leOEWkojas/qCibNo2gbAI0aHQdAj+QSOc4KP8yFnxs3fgRtMlFdj1CCqApKYDWwJ/iMzWMSbLcPUVB54hqa130boOoTIgJ9JQtl0r5SE71/b3X3YN+WvGtW2o38o9Qb9/PXtfFdcd0gTE6X1fdSdRq9gK8PBdJq6xM0ilso9LQ/TiqWTPQ36WDiSwLYiqhoWPD/N7v94wv/eRwPzPR2H+mW8UmP/FI4X5QG37BNcBCnokg1B5JKNhPZLxsn8GGHNfPRVcZIzuZ+f753LQO98/C2L+C8VNmgoM1cxNcJ6kwFVrEfK22oc3InQv/KmrcKF8jZ1loQg7nT9oieVBfJMVmrHO1CqbminilEQrC4sIyuW4M4+a4JEGxI3TsC8DcDkKpAWXuIkDl/WMq3gkeLgovl9sO/hIEPceb/dDT6wfRUyWsNgEaBWp/a4AZUfcgZFdb010riaikrVnICTejaHQI47y0Shpvqa5/qF1G3wWdYS7DRRxG+OQd8UJJYMiGRpfK2p3QDxnJ5XLjU3yK2+pNlirj/t31p+ltkHQFgJTmOBmryQTFz/UF8Zan1+bR6h+ZFg2boDEGP5Zybak8Xyxx3W1j5vaVLMnfZ6epMnhmvx212FuAIOSfRTYCnCrkZG+J4eEvtpN2cVf4/7+S6WYoH8x5CJlueV6mu7HCZ6X+zrMbrHUsPa9CI58P6rw9P5J1Ya95uV0tF7LgBTB2Pc4gqt0vPjcoQ5+vs8PWMqtKhnAA8iA1X6CfAhIqvYBpxkDaCEe9SMKTfKxcg7kBcNmVLwKFKjIwMa2UIfTEHO+6ULygcRqAEbx3JiHEfeW8DnO/XpR4feJ+O+ynkw0jt+5hpph+4yT1T1oEemt9EivyocwONBVm0AL6vgsE3dn5zJlIYSEC1hFSLiAloR2y9FerE7ryRM1r+z3DR1FDYXWoKaxfPS0RhoWEzdmLOpUU9snRdDLxaY0cYBjzQdKvPQTbWOiVamfwLCiIFP/Px9+X/q3hd/f+SP3f6LqIix+7t4+dZ2M5e7LyEIcu4U4nlyIXbqkoomPsBJQp86a+eAX3YIcUC37Jbcgx+Q8SlGMBdldlaOaNW4Sa+ZQlfYZLglWYF1yERfraMTCE6j9LH9iBQ64cXeqUqR6II8FPfhJQXUFHjFF+jaPuR60QVsQaSdis+xjyAI8EvINyqnNQeUtOClTD+WB2LUwoS5hbVHHdgycu5Qr0Arwna55IV61MzAMJjCBURXxVy4vRWidjlnfRJcyg81qvspFM7nbsM7sI2QIpWPSUjRDe5D9svDa/qgdqnSvJ8sE+G4veweywMCSwtTOSlHgNQs03tT6iDQxgeqGui3E+OIhDRa4ISxTvGbdSXmI4HiEA2v3y0dhGLqEAq1AbXiO1pN+K/qcmS5j3J0JN60JBUhIXQ5YizCBRClAGZ7p2+vMScQwq1Tx0hRurgKi6tFCWhRoCwqHjAF2iwrPZVxABqpn13v49fd+4uH3f/TTr73hKCeD2eJjfUKjsw18KHZe4MKp8LE5ul/ODELco3uPogoUImPHccTMcWAXxuxIxQ9JotrYVRXsyAUbLtiEb2kc+Yo2dkIR1LAbg7wpTqzyoOofI4+cGrba2xG8T51vjKjvfCOiHshzuMi8sVkxyN9PNmlmywXb4hS3NdrM1iBvn6iZQo8t47VnLy/veyt+CStsSETpxvqIEx6qOuGhhqYdKRrUmHSX0aCaKzY6GV8+GLSJcpyeOjWZbaP2cKAKLH72axh918kiKvOSC7LYACimIktfDzmC/bjE4iny+xTwUcW4CRiMU7CRN4E0MmTece2cgLUEGlaB7iBJzQHV9UxILXVQaNzY6KgYUznqI01aCgmQ2gny1CzWE+DfGzEVX4Vh9YLoIv84+lbL/kTI9bZpsaCIelF093Q/+1iocNcxe7cuTI787zG+Q8rbtb4TlIBoaaQ3cZk15dhKve/wIzVlDeri5orXr0960PGG4F0ruOy5e+nI30+qVym8adNGTbrqFQueK97IBYtoAJYIUybcrJoSKUuspcDivkfeJO57U69k4KaEksKKMliw71nL/+Ulf/DMn+WwR/FwvfSrrB+tvxknfC85vrjhvV9vccN7H4m44X2j4ob3f6OIGz7wSMUNz/Oh9yad3sg5Pa/6POr7gqAGX+mAWAo4sHGEAmONCpjGCJb71h1nzYjW/fSQ5wUVLipQYKE3yjdFFKiJBrwmHCONJNV087MPVjkkv+SQfLzqzAOH5CPCcUh4gfepUQ7pYnALRy2HFPQ/bmlFoBxSYDmk7EMlXxRsxhcdfRR80Y6SorRGKQrIjpKL//N4p7+KZqBYZg32x/rEX9WV+8HY+YDCeKhYSFoFqMOkIU+E7LdUDRhKz/5adjfeyJ9yPhHqLVufELjXBo7ZwFHPzF/xbgzpyviaF6vKucl/l/1wYAOHbeCgR3W16bnBbJUslvwL/giCozo19k9ZLI/axZKSgU6pdVkhQDF+G51SAhDhUINDYpKiJfQAcW3tPjVE33um4kswwIUf2N2H/CyD4krH6FHks6ooTpyASxVi/QTTGDeXU8Qu0qxpwwLfexBN6UVzHkDtMgMSl0cTPRwtezRPqPDWokvdAS0hSMv45SMMXHnEpF6wwpI5mseXRhGojUe7eosp71RtwqbUwEtDX1Rog6ZqbxbKjmErzTXhMcttnddTklExjYh58si4x1cc8F56qdIBmEObHysfQJxHD8bEPehBgqrjMb7j45N8x5RYLuck+Y7fGOc7nlFSiZ0VFmNXlcXQ5G4leXWCA3EtuNhQI3n062s80QolTtxl0RlVUzQrHLEga1NYicM+2A8qGtFJtRc4aPodSy2hwRiyBmN/jywX3iYTdzd5hCeZZ2aeQu7WRnV9fSzSaGj2u8biprnCGjBvWPAPRgvtSCz4vhhEMJGLvxLwhyMnL8E+GA2NuKEUVWvbO/qaoWpxSkD8dxnkNhH54LAhpGRi4OcNKQ27qKqjxKZQl7Qa2bIWOvCpXL/FHMtbqV4JphYlHNolsZzOD6iNimQa5korMwdCpRTtSqXnTf4ob9oJlJk5kOmwqskSRrW8MU7/Wujt5PjIKLRFIF03lu9bVN+wdG1QbgJ8CDCM+ayiCV18MVQMWPU2hpTye2XnIHQkRVNTHE+KCRaFrbY4kOYWsV52QOaQ9CXBS4Ov8+cNcxJgSEbEg2qH/L1+FJTLjqJhgtEd2XsfDEff7w55AD31atDfmwfV4QrF/u9e4VFgBPvBECMjPjPViHkgAuVojULiJ1J1wNTXnjA+autspNFjg+Dgo8sR2qLUSQBZ723kIdXzwJwO+MT14ULB9ms27PISVlYcqZ90Oyz8qNKyalN8EHIljQaMtfRuP8Z9BwDQHxXPTsGPImbRx26KCE8yz8w81bY1EEdXyoqjZWwrFVtwjC/dbLlk3d7XqAU4GttTWAWpjmaPaLOWH1H7VrhTubSntl3VTyQcVRsvFSl/IwqdKJnfmDKhdIOKmLUAjI8zp+Q5WB7gE3agU+kH8kZJZ9TfqkLLWhIKS8V7BrVRtqdm+tYwwllUcF2glEe3nxVqqXaCcHtIr9nuMVFdjhIzzziO83Cw44EqZJ98tfMSDvbS6YSr71A5wClCnHo9DyKMiBEJL5czXgBZh8AplJQnempTHZOgL+OCJpwecGO0ffZ0Ua8BI0qPHrV1KgZu4iCuQfx3aU/ZSxwGUnMDB2J4qzYebbyE2xZrY1PT2FCaOChacjRWpxADHmrj02GR8s8RJkMBpOZidGnG0bDr1KNN/zR45m8o1cxDjA4XoRbsMS+PoOiScnJcA+PvNDPcTZvsC8IEz/TrxH/f1ut/71r21xIVgt3lQnuwR6+WCbjGLnNl/MiMd5WWnK+Zc7EGNZmvMQOmfIcH6wvlvbbzphlrZt9/+yfMNOuCPt1C8wlc0f/dFFf0DwaRY9KdqWaLnpUVDAWOLxjgFrrCnzunKFHfxx7N8b8T64RyCOQp1ytHJkIiEFrIE3Uz1qAA+h5KJQjZ5aMmwLvvL+JnfOSNn/97JW+JpE5LYRzCbG2CVjQt4VNnsWPLZ3XhGXW2Dz4zD6Rf4fR+3fX49etTv/ftZ7zuwdreyX65lEfTLyXrnrMbR9Fj3YJ/4uu3BX9g0y34p068Bf+kbsG/uQX/8EltwY/6x9+CqwtStwXHBin7X8fdgrt988luuB/Z9jqYvr0+9li31+gaE/Do//rtdVjdXocj2+vBI9pek2G66SQ314Opm2sa3Vsf9cf21g9M3Vs/8Kj31n/6dd9b3zayNx741VbQWva/q1tjD1vj7qZb45PdCofZn9mtME3ZCQ9829lfr26LMDLaDH9ya+SNvt/p9X2rjyOTJOhfgfeRDRInXQGaGJAvJuyqGyTEFRGQAIwY2B+zQVJVCV9aCl496gdiXNqj6JmbbpCOVjZIwZQNkm82SIFukPx+Z3KDBJoh9RN4OLtBIl1OAcdgdHukkwWuT6Zuj2j67uhfbzdEj3Ez5D3CzRBV9kLhifdCj5XluO/rx3Lc9A+bsRyfOzHL8VllOb7JcqxHCfa5oC0NvV5up8Yx7wRsxiurPMZdzGN8YTMeYxpjEWJG3OnlEZ4DL4/HaIZOOKxBYqfA0+chjxLLZjBO501DRjwRdYmhAaqTx9g+wW4gaKlJY1N2Q5mMtvQInQzBWgjLkevt9DzjtMOeWEeikCc38ns0Qy0OKFNBrQ3DbsDwKLiMBXMrJlMGYt5U25rgMDplBiROcBhtELYFmtuUw1gYuzM8Swv8Ja5lUAoyggPiQ2g8BJsE1Qoh2k2ktYRha3EchuSQVyxQRBEtXNnTQTqMmJhiiYkpBJkNDS2p8hAQcPHdVY+f8QU8tIanWJjCUyygxcpTGAkixylPccwb5Skw3yd5CsQ+Sp7ir7/uPMVbPd93PMWxqgQJDfgbS6amLECBUQ3Hs6ZCHDwqa3tS8hF+9rfKR1hZz3R2I1ur5OTWOHPkofdy3WBMbYpnrOTgmZlnbUIdqvpKU5d/rNwqkuh71iWwuMCIRA9bp6aT85hAzbhIj3tF3c3jUtc36AcH7Kc0mgGLNX8Kr4TKARzx41h3UkLuKhqY0xXDdLWMhcdQakSREh23xqfSD15K5T5nmxNnYHreZchk1jNX71wHdsg/gDdlCDL+pkMzmICYlDM0O8IQZJYhmHMMQYMaat0/ZiJh/YorEwA39HODHLM60VndkVnNEkPqjK/2Hbvad3S1T9P3+34geGC96HJTsUIZFR918IpPuEGREnR2Z7FLLZdk4BGFhHI2PLt4hgdwgTF7QN3NI7qFaB+tBn2odYzBkbvHDI68zxkcudsZHPmIGhxBoqsjIlj3OZC9DSK1sil9Dki+41SurqufY/Q7tENgXNb042olvnTE9i/7oppyMfcdVDL3yZUeNhGMZa8o9+6vAMb5HA4U8zhcl/dQ0n3Oa7nRIswjKEmfAjsu1ur9VHPVdWNaHk8yz8w8a8aFNR6hWsNP8qb03SySsRggVB/XKRiEdrsmFpzEpCKlUFtknExh3Dbjxwt4veAH4XIu9It4VUshIwXt3sgXYfR4ca2fvDhfcni/zAUevDjvOn2mLbCbDE4RGoCslUkLxH988b/X70BRrFgV51oofyul8PG1DY9MbNuGWonYniaCrYsQf5f2eAZs0PYjwyKnXKgCYbYSrVKIgVEeEgdxBxfzAj3mGnxMoiLfgc72sHzvtKVDL4sK3NfWGApxNZXU/Mc2yq8stvZy1J8TB3LaKVreWgvt1JuUhAV/hy2RloTWhURU6E0FLmQnCsk5ggMcixaHchGzwDVJLaFIaYeAgRbxSEwXi+2DPO9fx/XMcbMzAcjW4hSF2s4ixGDt1BK2EeENNW0zHqNPgeT7FK5xF+JDXFM5lavO5YPv1yu0XME2qaBjK3Dlbi1Ok5q0gl1aAeCxSyuwbn9CTUYFeYhklC18scA+oJbchT+daz5VeJxTGQbivWcXovgzE0saewYVtONIfib1+Lv8LH50rsnPplW8nUM5APRg/fvzJzCm7CYvf6Kg2Qqds1as8J0DuBFXqTpQsITrPD0RKPIkDjzp0t7GCJSfPMjPJQPVWQ50DxRPwd39jPihMN+pqacqbE5VkOQWJOdSbkCyEyABotxbK4HeZqic64BugFoQV5tTh9+5vhD2ATIKtb4FrWaBKz5Vc28yxrgRjeaEmqxDgGTUxJW2sfTLofV5HL5Hwvn5krBH4/dw8KjGX0BPwBpyoSLOgsI5f6qAoZCiSebUKepdZQEHOenZfMVI9fQ4ZTedgt0PgQPcxpNiO52JpiXF9mGxfJwznLBfpxBnOEwpQKyqfIEGKDRnO1vW3513uSqhH5h2zuZ5SKswngCiGsICxzaBGqNSkQ8dswATa1ipOMN2mpYAVbjQUpatDH6Zpymdku9O+6/sX0sX9hg4u2jX7c6dXpEfceXQlpFC87ZA7TQ6hQkH2s3atBTv4m4W4UvYOVj+FK7zuv4rudy1/Am2L+jbVu3bwQYwYFUcNpEoE1IbF7af8FJauAZN3kpdOoWecs07bwZh/+Cb9iCuHwre4EG2U0C94jR19acQ3MIdWR4wtTuD+O/KHlU7MtqNJ4w1+6JKs5924mZjUND0J6DpthNPQbsv7XHM00Y7c9FJdwZDkz/EC3Pf56a8RJuQr9HplOBeyhPJ24+1HLWezXaSZCwulMUHwoiGcC1IhzGDifZDUIy7+cTZpJD2GVzmwhl+7WbiYO1NxYxaQ9THf2Uz02gv9ksd2HJ4sVxCR87i6fR0mvkvvUp3FvBYsL3quTUMw4Pm+dQcaR6aow2jBY4r2mtccP50Ok1bzQC1zaQzeP2fwQIn0vGn34wRWEODYZ4ZHqX5Rw1E8Ve0SScWbCdC4q9GO8GJIofu6Zp7NiwxnYWfUwz8zwKbKXqsoAY5Hll+sSMgQD+ZgXTxQO2e6HTWMWi71R+fguF16325iKIJjGKXGpCdosUaArTXrFubFn0xF71dCscE2CULW684g2/E78VkODIcHL9O3G/EQOCPb7ctEI62sRhpIzKO77KHXOn4LgXDGY5koSGOZHH1Z9B2aTHso2ufC3R+m0r0Uf1UsmTG4TSRAJq6zWTI21rN1GkJXCLDpNirFt8ysKFfZ5A85FP7JTIl0Ywj754yE7VRC2jNAup/BHPPl7n3DTjrPJl13/jzrYb5VhudbymdR+eDg9pDF4C9OpeeyowSPSl/Ip3KnNpOZgefnG+nJ5HsYWQ/kLctf497dd09/rGEn1suCO7Gc/mC4GhCC9QS28Ui8IkBhBl+5gxD6XBsOecZ2iqt/i/COaPtxAFAIAQEVEwlWzbDPklRFFlz7O+lfD192POi6ygQF2fkreG5G+oy+4l/Lu3hfU8RHlDv++L0PVRvafX9GCT1GkZ1pOK4UsCiu9eLcM1b8j6rqF8qrCkKoQR55Ysi2g+EhtKW7BA5yE0E+H3gi4+xRAZzlpbYSWfbiEJNu/Uqz1nggH1C8zmvaTsqqut23DdbZrRYWnoCFZG/n6Iicl8Y1nXzaUVg5K5f2M19iM19RBgHxNkrCRRf2oN54IntfR7aza9upbsIJYAYxGABxbjQJU2Xm7qaT64sJHgkiGgg1MJQNxHKMNo4uHmrmjVeoADRC2JUFeIhc+kzUO90EupyKJTKGtSk9L2wKCDC/+wfZJvfHNvmNy8QZwYqZLh/TMjwaSdkuN8JGe5TIQMS3f6/Tqx8GleFDLiYvkuLqMIhKbufaPcbZfdbj1f30fnWSXcfbVcZR2hlHBj3svVOWDNNxhGPbKUDZ2X5u2t6qlCiFJ5C5j2LUErsycevuqOT9UUWDl0qcBAqp59YMQLB3huzmcgI6iIRlei5RCjh0ApLoJeT9A+eBWGJNfMtUu2m1Ru1x1Zh0apq3LXFxJYIOWb4uRuyjhh7qow8IXuzFG3kc1zOwa6INeaV7sOHC6X7i4Rmif+YR100kgvxGLuIIpbJg+Sii0cmIo9EyxEXVSvUpWVK8MdUK2XJxZYjQ9izFsnFCuCxQktGpK7gbrLkomucmy+q5KInnszVRtdWUzp/yzX1cOaoMZTw8QGtyMlA0WVLRMVyjwvnEHGgTVu5lsTUojagOLd4Sbcl0rwcvyRcSE+9fnMhW1FImyM4wLFoMXcHkotlFCQl9GDUDmCgOTwS08ViC59+9q/jemZEuLAiu+iEt6/8ulywzKFsQ5dWEI2aurqrhTU52KdKNDnB1jNBsuxqe8Rldzcve3ulbLJld4lM2dtR9nYtm0zZSDZCi4higH0JwoYcOiAqbCgoyneob1HKeR0eFzQslGDIaIe4POXATggaqkA5ZcB7ddP3GQ7wxp+dpM5CCKA4M6vdmOVubK10o227cSq1tRvgQ9HdRJO1G0gWEBkQ9IgrBCu0HTWJy6AOJVpTS2tqcU2zxx+MWdQ0u8lgbJG2Fy1s8ttixD0rdg1Y1gNT9wpiGczTFJD5GcBt/U+9Em8H5+ql9nVJl71lxUudT5mdT6cT91T2Am4GObT0MAeWSt/TpjBqqXwpP33TYndxsVvUzFbR5Ur4j/cBZ/I+gDh8JvYBx68PMh0ff7wLaNF27g/zkqjd53KJoaLaroP8TGbMAyp4SYKh3kpbCCXzk4vmMuX0cJnOJNKp2OUdwRbpPUJd2sJj0+Nndyrf3j0iraUu8+/bwb9zW1EudyCsdKDFow5S2QrSFIit0OpwPDYtCSiaVJ/wYFoioVBLuIXLQiyIG7WFVsympW1ai3bqpkWrspBbRo2gHKk4w1BQ4Q01j0MmOx5kUA9m1NT+t03/2yfVf8UW9TCD2hRHZK40teadIBeL+TbBlZapeQjwD4XC+rSs9u0EanvEYNvuwVBxdZe80mAgeRHuSkxmMyTGwNsA8Fsp4aeGp7dTgKqgY81/Jg7N325h2uIHJjG6tiykpdgmMD2VzgDVgvsHiEBpUbuCiHD2Biyfyh/uzHcQTGxuhZXFfAvtpFhVktSlmVkjU5qFOgoPnGwBmkJ1+KlLEZYhuwS1zSI0vgTpAsSQRemWqlnr9e30Jx6bM7cH1k/CmdvNPwue7078WmduX/m/3ZnbVD9aJ+u2reo8q/TN9Y3mvW0zl20n6aetM6WLj8pdm6KgumubQDdg2v917toeNW5tilmT/tl+oDRAeexnRzdzH5F3bOY0STdzH0UwVaWzED813vWKeRaKnPOd0jBSX0oR3MsexgjxXZiKD6OrixiPFzgfRlc4H0Yve8w+jO6LYs9qgDvCd6z2yB0Z8ZiBwbrFlzsMGO97/eyfHw+/RtBSOI5vo86j9m3004/Qt1GGa0oJzMnoohZn/yT9k612jEdL/G2l4pBdn7vNk8wzq+wLRRdWrVLlUT8RNfc6FDoQ0vrr0ISI+KGLfqBK1m2a1ZW46urO3WGekVjyn6MLJcCcoi6a4Rg89kNJRZzRr2mlZbHU5mnVRrmcUtkjc+vb6D0alQfSVtfCCDwCRVLIlUXU49JnEaElVVtYkx6U3pmEDYGfyuwhALIEjfHOJPP/DvA6xjvT1fh5wVTvTFdMemdyKkff61XlUpHG6qXcjB8eGhQR1BZVVTIhtTALlzpqPTESpINznQj48FU0l4P0yPzqHN8Q7gs2M4T7IGpLP5c2UpmmTsGj7NUDtf1OfwNqYgegX6KKFy+gGMTqCn37Hn37Tn27XN8u0bd9+naRrDJ5XWVOmMoQpCk71qQY0c9jBSSxtoe1Zj9D+oUcAYNQB4oUwx0cgPrfS+xsjNX+SItSQCgUNYc2LPTFBAyRuGKGTfMBKwlT8Cx1PUxp9rpDUkL/4+7NSQfRTG07slzE2EihNIfi7PU264Lkl+i8Y23wZNU7fgD7Ld46tsHYiCbSE4g75txsncfJ4xX5ggp4FvveJWIffVk3Ljzm87rPFq6cudhF8sEdLxhZVEgtFZDlviuzR4uYSErMD3q0hXoohJmOVVplLmfrHUb3fG6NuhxTrn3E9svLlyt768hviqWjw6Fb2fB5COmR6oM/5Bfb+G3bJb3KObOPye5Tz30Fl+iY+nVhlHM/pflK4rzdeaqHFnNDHeC5KE8USj6lIvpLyLfnE3WhmaII7ETZqCREIeUgQkxGHc42MoKFr0z0so5iJtRs2Vjxu6TwtSNqTk8bUqdM9kuhVFskKjkjX6qvk49HgiFKIL1XU4DJs6H9Lvq1UkGyH6iZPLOYa+tdHF5/IOdLCREz1Yg6WlC3ENVNUBU4FqEW0brvtI1cUWiFlMoOhndf2pRtAjEPQZkdc2uqhI/t1bHaAfEYREeIf3etK4LUVa+8buA7Q/iEFteE2jp4a/PMji1BKxOFPrhBde8NfzisuflShv/PQPJcbFOo8iPEMRltw+IZkw4Xf3KWmMFEaLcI4hGCkcwFhOBYDWQVwT1qG1PHWPXH1UwmjCy+AWNtoeVgdFYeWr/fusMd7ZHqSkaUoiuplbvoYQMaXCSiCi93R0jDIjHU+2TUk1lRrF5Z1Hs4COUIDnCs+UDw23yCnkuXjY3NWAiOxnxFY7Rn41Eft1G/9hobde9YVP+Bkt/spYeDEXOd8bi5Toqyr02zNKXnOfURU1Z1Z8qqPmnKyqVLKjr7iKtB6ztr5ScHMYzmzgbVsuvxqrx/nXAtwRosproxbEVrsivbLydVUoFE7JJKxcjVGjQ/0YGKiasI9jzpUjTEmrjSeR7gUZq4CiZMXIXc8l9Cy4mZLOwVkD2v85PCURNXsVPUfocnBmjdrZRYe1gXhDKnUkCShuATFskRi55C25vfh9M26LlTQ4K7/MMeUAx9iFF/9qpDj96oZ3308sq347rGXZ7e14BpaKO2rit8KL2TxqJJ2gkxT5vdeMjeZYk3u8tyw6F/B5Y9PxwF4LAid+HdMY4AxD3iFhMohmEUi9+H8PQuwGDL/ZWXjWqpXz36+gLNdAU/rheT68HzCAWOmMULrFm8Is7+7jV4ip3r+gXMrijPkCfCj4ntDu7btWq19SWOx8BSxnmAeMN9t8zqIj4s08WINvTicbq172NPve773zL43MVDFCsWanhHedut+Pfb5jJdiukrtmc8LDgDSgxLuGHMV95w92+/cPd/u0/rMPvrb7/sg79137aYbQlmf/tqMSNDEebZJdrqi7TV51JErdKShIZrHDas+i48yJPNQQRsfRl+XoIlBKxjROl5cnrSACfbpCj7Z0AMea4qAl5/ZcMVlIfaqAAWD9AeNYz+5RqcmN0hlFtPt+Vjla+3KRVXIsorFvVBIcFDOg5V2KpVh4hMkdk/Giedq2vZv2hQphpWTQ6d7ocwkyFwSBQO6G8E5lzgbBaJmtaDdSv7e+2Yli8TRxcljjg4fo3lzmnXWCZiQSv0EsmM3rfKflxubsgNE5f416MGFn2tSg9TLCkIVI7GfLj/gwWOgW1SAq35kGMvM3GRaEt4goGgLMJJcZhkFrZ8EGNUwJcQfNn+ez9YcCIyXNbrfw3eijjyIX7WL+0B4NiavROwEeqZB5vXEppaVAImDddmByzy3S93DeSLCPlUraUmRYIen+4n55v8udjbV+oCcqK0JtGHozzZu9CqFfW1FIkvfKRxw5Te+OVi00mzX0HeWvoe34uvc7AzrbPgU1hzpQpmFAvVFDWo7Rsr03qgqsxhAoYpkYPnIgaGStEYHwpLKGHXr1/HwjvHlW1CAh2iRHfxdV17MFbaCX3NblIurhw3dNQ1n4+yMYSoLqwMYWKHMLseOKc9S6TgIhxpEDe/0hVVaqo2KPvsDSdh4+SNhyYVWGBcZcSIii5iFvjefp0AVNNpapfZf2wGp7BbXN/dYRxVe8lDlRzeOyY5/LiTHGqSlPtpBEVSg65jeodrarRzoajjkRW62S4aFMOIjui2i52epp5MpHplsKVb47ZulGf0LkZHMTjTexqzwp/Mor8gGzBPgIHE+zxQGi1YkNdFsG3SYMr4HUo3uglZQruW15zvXclUdCVb0ZDN7hauZBnwDCF65y92y244oo6i6HJeoy0WTSka4fHRf2Q1p2U1YG5NMddQnAa2YSKdwMxaZv9pfBoEXr2br6obOygTHEC9e6U529COXTkfwOdknJsVYjhih6i02Mv2UPkUG4o70Xy5QUrbaSfckfl5hOzWI6Hc0dqBs1spv0HwEJZAV1YKzHmIy4ulAZ3G2eq4gaZi8fAoaBleSG1i6Iv4lbUvNTV60ZAK1OXZrqqbkoQScWS2iwLcEuUovDpnZpBcOZNeck2rrhfoAf5mzhk43irx78Bd7oiWrVLZMu3goPa9gbf9opRY447XpUcN2kG1tUfZqS1Un+gUoPbI+4U+gVKoUVk6DXFQhyhkVGoVgLkKpPjEukaTYoPxYnMUmxMpxJK84JJIIWad1vaQhfVT8N1WRf0aOAaDmFRre+kU1327jH3dZ5uR6ObJZK7i9HwXt3uXAg06rXgWZ8Ct2hlwqybgyHeh1TJT8MAA+2JmQxmXeVrkUYPdLZX3OtbwTMCl7xnk3CVgPRNDZOzzqcKA2gMADDkA+/QCb84oUuOz6Cw60+gH46gVFGIWP0I8ILxgmLcQwc/TKNVQ9pNC6UMVMILAYQ82x6XP6fmVkrkaxdyLnvYjcFd0H+tZ7f0/exJntTf9AgjzAL/mrFY9w3/zrPabZ7WP/axWUVDPaifQDZj2KM5qv3lW+yONxBctTj3SHKMPkeYz139/Yez6L96VJdMkvf6LoPEyEPeRpzzcYQM3yvo4glo3fHmJ3+C37/fWyrNejhopIzss4pa6MH32nrS1Z0VB3qwWOPG1ypSZ+UuViKVoZYumGZhpy1FkRHiSeWbmaahWP3ku6qgatsLEkCuqgdwrD3E2aQWy8Hebkdo37dAsHnPUobmryrsiTt0+k4NJnpoSSy2wF3JeqBOmJQeTeOzPZynQg0mpJyyLpQ5wyOrwzoIXnDX77I7wivlsP3Fty2gWCCmfX1lkPS4XxWRaRrVtaHk+L3RfNaYjeozAav4rAqv5bwAsCPbBAQjQFuD2g3Nkv44j8ux/y+7b2SOgBRCHeZovY45HI+bUcRO7r/EpNBuB8sPv5V7PCZSr68DcKP2Yo7kK/ZgTso1CNyXdPBwxSLeYE40p1FnbNPiA9s/jOCo7jI5x3cjDrwfxCntVYlBR7aSRr2xn5EhS+mct1a+4duk6n3/tca3HW+EqMbpnjBh91BEjTarJFXolRtMYxYagakJ4ZtLhoKqC3kTLI9AWPCJYtaur3Zk63sSGhOyD6gSbALFgcNLfjeN9ymTPjU7hzQhqU/CbGQzEZHL4VdTVoIoQLOxXlZOKRDJPkfBzYnBijusx3ZMsNKe7yfld/j6aP7t2Ca6xzaMIvuPvGxKryudLytItSzYwpV2QRCms2EIL4pN/Je8ZR/WJHCDjyjZY0BVapUUhl9x+AVAXIy59jMCqos5zka7nAls4/8IBfWeQcxuRT0QpVlmT22H3s3WFj5aUb6VFhkrPnHRspfrotlbPCu3RVYbZmQni9GgJW4lVYNNqaS0LgBF9f2xvcUsR9gm64uB5+wGk6taW5NgEVwDE8s2SDCdU5h+ouX0tKZTyZduHLbQMZX6vsl/eKru5OriEPCc8a3mh5chWFr2qIz6sKYwN/LbavRzPhKKyUWPEAInJ5IMG5SNJJJAA/kSKP1arfNUCop6vcnWLdke6SD0OmnbjbX++jAGnnmk+f7b2DdEDHUZaVqIwWrvik9baRa20hF+upF7KvDWssvBp1SwBjZbMpTzFFnuzoIsGdwVzZO8EAPl7uV6dOPASqi2Q2bGEZuiVD/mk2DrVZ31D2EjsWNELwe8phKhQ713aDyp051rk2LHmbsfaAEy1R5lOAh+d3yqtxTYWTQNWb63QMLEt7yn8qCHgb0JsVN2tNmXzmmdmZ1unTEaEmmpSYwftoKbuVmvU03tyZt4X9TW8M2asIWqPkgaBDdXthrU6NVOaw9sczeobbHPJAfkMjPh0MFQdCtAjElX2pnbManppL+vodsTNy6R5svpGaCRxoGm1p4wRTTlbBCaVMv4m+7L1kxHjQr5J8uVY6erzVZsNkvFbDhnjaebASS3jmWhzXnfReXaD9J3C//MRt7XaDHCqSFlMPHHzBfRFoydsjd4Dc5J0PpZhHQKhoCq7KupijgjuYgdQ2Yu0VXfY621QQkK2hBJkRO5bqXmrfFEqLW5cpDcv6qKwYBYsxgbARw0ZS9uNadHsJ9G3inQ9/aGKSwvfTDUBkE41UUwz/oVj9S9svA+H0CmrUSCqZzjmV+vcjteAeXKxTp59+kbpkbhi8bJfu954w/h/vGmXIwPy9BYftkUX1noc8vU6nl7CW5BQTw6v5eAULv1+Gd2q3ox7sM5sRp31wgL5M9XsdkeWftXoMwXDI0XViV3dWbvonr3vO/8l/4r0JysSlwkO7MrUq3p4HVID/w2yHxXjcwNqaEjSjpSZh+J7eL1oOkeDyGHr5MKGOY/evod+7ot/+Jzvu+LiYcWDn5wFMwJokbIzartrdhCx8SSbkTDPEdAl8IeOZgkt6oi1upwDjHDIrytr2YRz917lvn3pDe0v/0N+89MpJfdyZU9MXGUpLkHCqC96lM/xOcDtn7/+6N2v/cqbvwp83MTlYzJyiDovK38/fHG+4BqaCHlGggCeZinMXg3Ox+ybE5L5TwKHdfxSwpx0a98lv/S+2770qdc//fsLWc89XJ/Jfut1hlnV17vxWtqSm8FjtVgS2YcCRMMgLwAYA8gArYjlDsUMxRzBgRKCS1bzqyke/IsuRnRGvkBebpkzWwpZCNrehWkzOYjAI1OZCeVb9Bwc2N1Qp98QAcb2c1ZYHhLuG22BXAWHXdyCDafCzP9wMwn33ooVxsB1eIel2CE7J8egGBBxJM+/Rrh8//lte2gpeoCzf3329bf+5PVPI/ZknQAJPvRTL/3A0V2Hnl618p7QIotysfMB5q9wRQ5LXfBKRuYYG60FKDHO0jwyb+ERc5kb1cy4/MkqVFapCGaZQcba/ehb5Q5XWZTLBRZ+t535/4UVK/Q4yh5O2cnhG1ftGFsQAJxs8lF5dpvVqgtz3x5z+u6YU03dGk/pz3Y3binI/uVV5Zd6tOpz2ep/UFlba2BeLSya/RA+RXHpn4deZ9JCoiiqetJy8qQf+tbC8IyeKKvV4BAH/uACzDolR566uVEprhF0RzqlqlvI72uLP3hOk3NQfOm30ESPPNDV/3WDO7gz/SRPtLqRRS2vgTj7thlFJOu7AlrBnvC4paYLttxPS7nIlWuuPEkp0bPbvGH70UQ/eCuJP/YalFIDfaouqeh4u28a1ypYcgkooCSZwLihpVsWnzpiKTemFLyGuikfP1xLBA7gImOn7pmCYuCGst7BpqbOdFuJ8FXOKHvNeLRWBbB4zVRxuo9xnKgC3Lx0XwGmR9cNs1ZTI3uzYiZDzOVCHgHPgezLCkXyAFnAVZXsqiY1v+D7MZ8LuGW2NCgrFeahmfVqXVB2pzoeMR5yZu40t2pQqtLjb7yw/2Y/NfIQipQjo0DGJJDDHPtCkswxaDbUUlV868NHViinzgeU9RH9yjwu+S1AV2t3Q15EqhAJcALhAEUzyorsdfsW6fzVcatyQUDgkLQQ1cWEShUctGR5gnhRQck4XtUayMvuRcuAM5iV0lalPBwm55HkUOhHI7xn3co09O4KRDbKM/HDHL8k2UcxjGkZ0ZLY/f3WC+XMH4IUsPeX9bL7btSykI7xPsBJgEtDFHr5hoq6WPf3sx3YIr1MVr8mo8v+UZPj6r/WEysYMCHLZalCFKYs/zcYOiNaEOhsqMZV9llUD09bdVSy+Qf+yAfUOqL2ZF8pLl+o7njcauPR9FSvnqbYszUoNuasPXRHlV+Bg+CMVNpbXYsCMXmSqm65vfrJqKp3k6WtYJOt55nApjAXFNjz9AamvDDOdecj19soWm7pJRu+66IhtXghDm8dYoNVXYAp4GtEfVWfULUPHJdnt2MuY5h1oL3spxBR+E6pUFcalcgkj1CzKJiqWRRUNYuCk9Es8q1mkT+uWeRx5IOjmkVvOTSpWRT8m2sW3XFoqmZRMEWzSAdl0iVQURsdu+tfJdFSimpSps/nAZ7O3RppmqfUC+0QEu6GHMQmrbaqJS++4Cy6VCqMpk+d6uLoZVNcHCnlsGo5YFV+zvfqk9yFIR9FeRevCAR7hEpGFgdQpS4CyIOFuQiAEnDcx38lSgQWJdB+hxIRaggotsuesEGizYdaXdUxF7s/Dy1LBVlBoBiAWuGvTxhkfIkQjqXP029l265kOwJRbqES5JNHKA+kGWwQSJk7AVPG/zWwsT+5RvpmlqF4QckQUVDpF8XeBX74/RZ2orqGqnHgAAeHviCCqrxgMRS0y9Z19431J7BsYGUFSQ+Upv6J1/mQp2D/eu8SlKnnGayV2j96EIh6+0GBM0/WEMQ+rKqqQzae3YmqOmUczjUkDjD5KansF04eP8IR/PA2wY9gHD/Q/wdG8eOtI/hRwikCpP6NMOSnj4shP4PURzndf3ZiuofV6R6e5HS/+qSm+3FomDdKw0JLw271A5zFhJOXKyxXOBP4fk2496vXCiiLSxue2xYHd2APgcQO26mOJ8MA37KE/dva1tf4zwEUnAB2AQib7M8b1m53cy2XDyjS/Dy2MLSd/bygK8g4+IYQ7uAijQRDCYxW++UitPsFU4H7niJBeFeCi7FxiYl9G2JHbjj8oefFDixY3tAR2TlyJmhsGt6fjGaoHHXHopGIR00oAUKrGGGhhQsQiERgbwMRp3ExkHiGFn4oABXkMdZjLgZAj6m2hiVWVajwAXbTMSV62yiAx0E/REiuR7RSK0Guyw5D26oqnX+snkTc2AY1Dww81WwLOloDuqtD7rkhFwR2Qz36kXurkr+O4kFi0QD+SN5e0qWaYkIEFIjlei5FlTGqW8LFFECdmAYmBWl1U9wvysilH/R0FuoYqTcUgiarxgTWeTz5gi1rtoV4AYw4GkBqhapLSf5ov32TX3Pnfssb7XMNsXZ4OMFAHG2Q5lSLsJm0XjLqtv8Sek2Hb+4sVLz56L6d6s9uo9P64I06lCL6XN7+vKmbtVQyytZxrWgJznjUQHUN48bKdbFfg/dJxpZvBzmBeusLi7Y421AItKQPWlQjn6GWKgXhnd+wPlEDC0POcwl1Z9QywkWe17IkCX2bBYZnNIvGFLMQmAE8IduqXaPZnmivUiPv8A/NSHGZUo9m/zpUn5gGKPACfiFPWMJEQyodoeT0AHEaQlwrFEKATmVoB1pt9G20X16eckV4k1obqn47i3gBYQNdqOFTnaSp7n9nLy1CEURQDV1AV1iyp7sWU1QbU7dDHqXZLwm66qlw0YB2QkTt/ZAXcFRzjdc1vSmvuNugWR4SDEeLOpgd+A4KUUqeKM09R99kT11JhMyolUOJyKM2zo/gPCpSA5rAR/dJdpcSu8QRu/fAuqOjcL7D7Alq5wu1iwuJj4XohdW5Ele+9WV58FFklNcCzYnSebKDuCRmKalT4upDgmCFby6h2SRL18IqTfs/f+K/2h+53Bi69ZdUXmjYRH3o2uq66GuKpyn6FYqP5FNHsQMVQfj7reMU62AKlaA1oR79lBWIBQstIsCQ+LYclEK4+sVCBUOeEEGRLa5akuJd9g69QpeO+YOi0KHgqwPZMAOdLBuAU1lzOhxThOGLqsOnesk6fKnkyOt6zdCBLmbiyAngmWQ3qfvLjgGU2Fs0Q11zq5ZA0M61cGz0UjPkej1Sp5eKfatN9apN9cqm+mVTgQYMVnyh3L6CGhI146QnIoi1zCrMU6LS8xgVBwZhQ2QA1mrWuvYHq4X5QhO0P1EVoYVCSCNQszFb6nuNUbZHRzvEFiAqtyUxCMklvb7sTUTwqXpKOnQxLs8lgcSoT+KEVyDTr4BfsRKV+NRUfSlfyTq/+krWgTlK1jUkcYmit84yLbhO0hrGyGeLBFJ6yhQWfAWYTE4HGdcGKb4mWA7SskHpeIOSk29QwzRoDQ3SghOKwbQoMGCSV6XfeBGMWkufstltHKPFGGTvnHIj561NPthulBpTIc/lqsbU0beXGlP3Gg2pj4ifRDlN2pDU6adxdyJNdatQiMpfQEh2HcDZBQ7BVbwe6s4kOoD7vkYVSDclCfJ4slw2YJ6uKQ5ycnE8RVAG38jbsOk5Y3EihqBIsaPPbyIomqlIEdMjtxYzlN4KNVooMFO7ktiUxGaZmPEZKw4GyddD5oK3e3eCTiVGmnqjj9+DerneO1CEKnd5G5zH3BmsQR4nai/9DSEQKue939MSukXcl8mJl9Vn9fTbL3AqNFnxLY6/y2+Dql5dIfrawSaHoAFswxIwEPZWRCp+rydChXvFaoG2jvzsXXqLTB1/Z1B1HDIAMgGMfyZ/dIezbHSlEGSMCnpUii7LNulpvMnCR/TZIbznmWKNVqldM0PLeWgGVe92Z7aUmcPs0/cOuTktPoGdLWug2ep5HrXW79j38oVf/NY//6G38qH5rDlbvOZp5IJ8ej4L6F5CnjmQ6XvZe1UPwrQL3c0G2a8AEuIBTqNnK57l3q3bbW5PJs0dKrxm+dtZQZNflY9nKCAYLhLFdOS4CkdF3Ex72RfDRh3EBqTjR1xotoGv96U/9D9aHvcM/q1kOogxi9ty1DLDJ+BKVcyE1uM3O1eSipdJasI26wbjeYHvWF38jiJz6R13WFxEvSO3O4wCzsMmUSXLlb2HgiIWYq1nI6P1ZIM3b/ZRgH3jZeKSPST0oAUsz95j9tjBBk81xGo3gv0480JXNIceTqi8WU9WII065mF2YH37QmhPcRH/0Vo1/tcO2fijI/HvLePPnV7MrolorpapoWUkjno+3ClaaYmvPjP5kelxqR7z6nmbBxoVVY9G4lHVdYgtkZGZfcMYG/SE8ZahaqlD/2R6nphiOfqWI1aKB3dQIBmpxh7TJHVQRIJfWEICCpXO3xbEMLjsq28q5yfV8oZKUyMKcTa8IA+5OyP3p0M5U+NmC7/Cs+gnAFAshxRVVFfikl6QC7KSQrz+ZkaL+n7Yb3DZqy5Xg76f814y101prJcQ040iGpLPCsceFr+KtxK0E0xWV+2xIRXwyN6PZg2hupS4NuuxkChRiCl4910R4WWhbxy8p5zeK1ID6CNwyTpAWxisIEYcTE3wyDo/cEjVYo2VAHfhr8KhZRPnXk1zO67/5zWjsIam6ElFecJHYfWA7/VBEMAYtuOR3O3WEd+AKPo8n9Qo1z3eBZuqwmR6et3fCelqDYtIKt/c7eUxvnZU1c8+IJMDiAPs1FyjWiU1dSxIdZsb/Oq5ell0F8QAet2IAafmf8QTPuGHzeQ2z/N3CkMUbhjqvoWpe3NjvfDVvx8Gq0FBOVLYC6iCE1KSaoo5dI2A8E0Qh5G+lIHsg2jk8fsSU12zpZgo7jL/rwQR5oc6T7W6EfsK43gA59GVeS0bN5xPPeC9UJmWZ487E44D2YXrUVSDMx5YM/qFIg3o3y8RWZFSOhBXnVxe3pZJ0CKgjMszNEtJzB2DoTgg6a28RqZuNNPqGjngsW5DixH2V6vG3q0ifV3ehMX217MfUQMYFIiOvm+W5T+GnphKFrOjslZ97KP4x57f8GUNbW+S0zkDIt0xXIchOZQj333IGlzR1a5IoRnk7/uOjW2v/vx/4HHTEr/MzS/bAXiU8bzEpGVu6IilmItDaavaVUp/Kqxb4haINfkRo2PJeu7j2c2DRzakuI05quYWUSKDWITgkOTmkCzW/Ho/JleoHGoEKQwAB3YMTsI8NS3IHFZ1FLkuGcWiw+OYuTZnI7yOL9fkILYZSmH3G+/QDOTO+kBdoMh9PGTD0XMoox5WLB/DqQJU89QGvY68KBXyUlJOS7kCuLGOYpxr72HeIdhhQXke+UPhLEzyrr3rzOKF2k+9GGO/rD1tKPQOcc1933lfds0PnPFXT+cGyxKisACvqW1MNtCzFpNXxuuBdimh1gFED1AjtYHQA+2d+j5Ty9L9hnTFJ/8ObRoFQ8XKAIwWlkM+OH84THzjpTEGpXWewg/67nhCnWgKFIq6o1bravzlmJc3UM+QJ69/q/G5GKo78L6HP6Z2M/2M+O9S3OmJ5eoyNwF60uJX2N2vA1qIacbZtY1BMUdzwwHPGlWgS8qaTaBhA1/BFJm7tZjnx/yVPfwSh68sFnrl/Z7BejGP6KE8cCXoQwf/x32/+10/zpZivvUlv/9rz/rdX/kgq1bsvPUTT/30zG/B9dd3/cwtNwx2fAKxWy569r987qt/x7HF/BH+eKGnz7nqvaK5IzRHfiVmWLj0Sla9dZX1E3vNCl5QMWizRrU+UufK+aJxwCPbalrAJm5JUGSO2YYZjpy5FJDF/RW5MzWzcSSfl3mtMCbNvTzMu26yzvV35TNcaJdhCy50rcgMtzDPbSIzg3IujaOLGbRnkQuiZfw3HNLccXtlfPR0pB9tyDva1ALDxSghXCtaVnr6v9DzndkL/FhHw9lvQGdUEzR11BBGepxPf/NEn77R972K3++q7Urh7kCq5QR9H3kc+khtLfuwWThjhq1RVz544zl9peTi4BlfGAHcrwsx10pRt7LBctjykZLi/4Zqw2sXWuac0Vo1i53xUAo6aT/J3ii6Wp6YsaN69hfYRWrb+j/+Bj6HlITsNuTSppi013Ja9maJ9iQh+4y1DJf9sB5dvtHzQQOsYDf7RcCvULNaBozVpUBlW5yi2maVeCP99VRXiTtc5UCURcU57KU95kShXgLMH3MpS176i4m/cF1YJUNhqakZKeO9W9nwXRTCLhPpW1dPZWJ9S2RPQ/zmNN3quv/p821c5fu4izZ/TTIiv8mcODVvMCl6dNBExL48xWOP3oI/K2/jQfkMHknewWNB3BzPGkFdpuZMRD1RbDlChSmPAEYJzUO12GovwuwJ+BPixyK18FiiFA8YD45Ea2VZHVHMigh0maAgEQPkrKUM9+kaYsKpEUtl0sJoEkgrRRu8UnZ56gI7UPMiHjzj8ViiBTwW0AFILuewJs1has/nUWr8YoB/M8Y95sHS6f3q6oZmRVRJBYRrcL0SC4bkWxzudIUb7Go3etwgWmEOhhr5fEsE2fB4UmzRVqIA1KUaZFBWNduJeWBGXU6WdJwaOk5NHadUx6ml49QujadmtFwZHnGYQW03HDGgwVMS0GjisUANPCKa1dMZabSCXTwiLJkQoCwRC2VSVEnSB9TkpoLcaa/iDNpBHlDnhFlrBHXeysV1ZjhhexGr+5w4XwKmjY5HjPGo2/FY3HQ8fOnXkOKNdTcsKHJ8WBalHB6WJaPabIelTkuqOWs2Q2pQaHexSIxql/Vk1wZphXAv2V1Cu0M9bw/tnpDqE7tEt4a8e7bZYrZlznhO8kfv3R9O3E5eDTm8VJ1Oq/bns4XlFYZXOFu7qyhiNLUuGgXQ9WxA3abJfkGyh0GhhcWvs0VPMJHUlKusejCrV1n1slIHI9TZKCBKw88wd6I6rPy8JUryOblOlgGGCa6zcphmceR+YIPZiY31Ieecw4jPGbsq/Sdislm+oWM0pJWKZdyzL9fXoKB/gIOZpXzzFLr9sma7H9mqeRZcEZ8eT1vkl1tiSzlVZhBDVlsX4UFPNeAjXJHFQQDcQuHGYFc/E0/AWyiErFMNJOkVWSO2C43lI4ilqYcrXVu5DDii2qaovKD3BOsyQbejLsxg6NGTAj3HTXiwkWzzmVbX0CqcdOZq30es5uyQaniUSKc1BokK3HSzvukZzt3SVlKbkjVwn+p3HhOFOms0U3U9z4W3IJE3bj3IcDyESsT/0Y5+V0cKLzO0XcdpmbYegHSeth0AssA3jKiybylrRMkvQDWCM/xydfky4LeXVd/K4B2mSeSaxGCX+ldxI3E7zYs5X9wO3EF1YFpBiwAe0YKFIWACMFFHbumqUzwAHBV1b8szPBOWvvYzmPnJ58SCqSAnUjLNUOP0bp4YM1kU2UMppOyUDuanEHEzc7FeNUM7+PNC9wuyeadZo0esxRnnQwY2p5i0nZU0bYP2O0/sdGnj0WbwX6dsrJmP/RYrx8vVS84jEKjr1eW2AkLaJDd02wpdtU6vTmoK7UBxiqJAws3IwEWfMjyCd63ZNkcbYFul7ZCzRNcUPnSFf+4lDEqBR8EgTTELfqC8iT0214xWvVhpOBUSClkVmb7/h/M+/uRnHvqri7Ev9mXTlAnJ010aAO6IwAevExapShR4tcVdB5kyKLyiY52fBoUW/LH0Gk/xxBYxOcy7MuFB9SHx2iacTr7itnP1jXKvxhDcWFfR1jq8wcITXY8fO+EYHWgHOJ1hbI+EYiC5Ibh+5hBdOUPpd8uS4LPo9LGYsxluzM+DQklKIQ1dpbMVzc/CI1eKsUWmA9OpGGh7Dm61VwXTp7ggDi5wM6YSQ9v7ou6/HROrQ/D5s13PHAo6k865jc7hJP+aXhEMiyfclu92n+6UCZ8zilDeNkSLcd9eUFX2TigAdXWa30YZnen2WDTDStY/UOzoYUHZPcT5rmbXnd7sbTRLnAh07ch+rE1PoFnky2zMLN5BM1DETiDwlT00TEUg0PWKntWbnEVKxFS4uPOOPEvV0pSskHm9AjrY0yNP1jWdq7eamcpJOhXs/HA8DWwJ6B1oOAnnYys0tEf8eg63dxcaLyuJOqJg+Q7St9BWLCs5rYqNNDyI8/vrOeDPzd1uCPCpupS9w/AWZ5/n3wRu4ibHTtBZE3EN0NCG2ZCHtIgLsCim/GRhImZ+IiYdj2F+xPItD4Sd4ForfMFfKE+v/KtcQl0vZEpXd1uh7hyfXUR4XF7EqgHjUQRg53Xe5Tsn8lXBa1N8VTUgsNO1LMdbfT1v2HXjfjnwV+INNijBY7VIORalZ2I0DKHK9VzQOUplSzhjMmFB6Xsw5aHkbnajmCvFoZAj5BA4dPHHZGVhWmOVoxwVNsLv2iLug9IiXPFdWnR7uIHZ7eWLMMuAwDInz9PShmxyjjD+GfGeJWm0dzhkxqoBH4fCcaupdQYLKLNOQS6pjYMMmuO8gwJFLg4KrhbXSwVoGXY/Gc3mHYhR7JlGk3A8whlCWNmCFjfFRpysctUllbJ2ZbxKeWHe6MOYslC+JR0ZaNHq1R4preFOJd1Q3eupLQbINblk4LtqoOlV1oDC8jZOlt7USwODbyE/U4Rf7l+XlLxyVLmwRp6KtXUJCfS8fA/5/RsDGDE8HXfI9lj+MHTDE6mOhaQSZ60cT7mVwMQ9Y69ZDxweudxySbDSZ73WUAT9ga+Szf49PHjxZM3xiapdeFTV7rKem6mypOk6E/DuKNIi8zrBp4p5wUWssxgMukDhqqXFgqZggc4plCFzqrJs7rvmu//x9Vd93xcuHq7jlAKSihk8hElTI2+4BKDXFcRyWZ8DUOzo11Ssavlr1IhGtpBLRmXWori3nstJH3a82QFQ+yYY6xZLtQ8UAQsm1JiLSCP354tIXSCOX9KWLMswHw5L+y54C8q3fpoHNJ93aUnWuSDv6ADpN1yOKjYJN9flV0VTLWQsecYl2+E4qJjfpUXsM2bwmFH3KQF1OMXUNacFoRhbb3mirDVVIgZFXapY1o/qpVSF6lf2Juue4wCAtownzALJkwmPPLGRzyALbSnHpvJeK+g9XQkOJtX9nt7K68hVzI4MdjGjNupi6kiVpO9ygo5owJMAn0DafiUTQc4L3OOARVlDlHAkJj2BN5d7vcqEcSS33qfq4rIFawS6TU0FD0Vyz/0CNHZ0dtSBRfUxyDSFHjE5xZve2mQkiiq7Z8XJZYuTPKkBuWVxeqMoucxxjJMtg1QEiMoIIrigbFwTyA6MAhzvCsifYhFmhY99B5xECBwOqJUHalBESxNVd3t9nOaAPjH6EuuE73uMtht+vsh7+ijvorHIslAV/cQiKMd5FYPhqC/wChghEbOuaPMyfDTDQ9QFz9OlDoQjRmhiNwOR1BcK2s5TUGC3WXRQCpO2mL9dkqQAxXEZqEXHX/ceXbRcRS++lO6bDqIIZPXP5O5zXv6VzQhaZCYKNbU/1Rkh2woAJB6lgE3gcdM6ccnQ9qy0MrTvf1567YPv+8+fuXiIm4aKyi1F78VRerVo6ZUjetE6ZMigOrQsFKeLUcYLdqNLQAvrmBqII7bRlpXxnlPKNm/38nVx2rYEYlldIF6OCQUoYqoMBXhC4akLaKgBFz3wEOArDRIaoqeRkaMIkVIETM+8Y9hjC4Z5vM33d+JNbEa1MHsXdVJq2OjCAE8qszgGE4NZHFdmcatc1FUYB+01LEN2UT4c6t3uZSjRz3G7ddzN0tyrZEqwcnsvKVosGiD88PHRbD8c/WBVpyZACQfKItTS2Qb6vQgxC0gsZJJ5l3sHiamSIzuLZGsaqOTSYjy64GRWy4DZIqC02I8MlGR9WpVZrbVmevq12aQOj2KPiMBdNjCwAfSWJE9g89jAILB5Am28nFmhq7IMd1QyMK8igSVBoyzvmp7PG7xQHKMl0tCWiYVNCcMWu64V0XBsaVMEjEcXNWvmkBEJbzBHypC+tLefG9EVqHYN1GjOkvYFMTYG0ldjiDCJ2036chdeyLwM8JKZl8N4qdmXgF/22mx4udwWgJcryBSNl6vN8Z6anFKAzaeEPTfmHovSmmsq7FUcwqzApKdAJAeL5ry8iUWQZhHXrwPyAGqe4dB3/4a4pMu3suiz2Ebbhvl2am0URDTMc8WOOXPmvCRIWcyKubn56jxvVxYysEqV3buOVUwLMl5bdOJFGIpt64Oc3/uZoq6PMZrRlXuG5g+IyJDBPS++oWOVlMbTdIww7vs+7BlnHLmn93uqTUhcEOKeSsOBR9PzuaCqvReTqqYU9IodyvB0SxYHaOP4G9q+Xuy8YwjvIYXS9zah90grxMFirIbw+TXBFsKjHbSTDR+Nr/rLuHBYKkvDfidmdExbue+veumlL/jwKRc9bSgq7B4o5RCeBouBVpmjwvZAa4vgHTzhF6gHyRKn1gWB+BQbcm719natcWQXSMUc39UmkSIsf/2atb8VM68EZkgdE4C+qhRAT1esWGOBMnARhlJHRleCbw8KoTxcUYLsTYlLp8Q1psSFMN6FlUljkBrZ/f8vfSOqTqriZDRVU/LuKOAj94rTx+rRipzH6iMhP/tbOZ8OYXSQvOw3dSOp73JE/luIyaMyLtj3ZPn3FxdndyOJj4UgfbAb9mNQoqS44pRSwLPBFFSgt1HUK9rSdeZVBW7Zb6MsfDkobX9zn9lrzp/AsyaysGBjw+7+ztkr5/m6+f0d/RT21rSJ5mNs6CPh+oB20zqVSpMw8eEP50liGKT/odZz1YLyRw6/6hAnEsQD2198nv88LuA+QIlCEMfsd+2mu6XgOd2/CiAV9dOrrDg9sgbbd/kvKKoxXLdrbmJvV+3PPnrIOm8C98A5klKzr6JekIjGL/+sMkN+EzQH/gHj2P8r3HTus84BgNY/2rqs8HqqVKCn7PiqfzM+KGMzaQHYTs66gZr08N1+kPFCgbJVVVnT+p95fbWIcI2rYgC6EgRC5RehKwIAlMT+3a9yRSSaohoPGFar8fCP9bApVnHDlztTdXUDkDqFaqUmoDD7mI6GGu5PoPILjQDIX/Kmub8mZq/hWxQzty0zF3pYUOAKzT0Y/bxJOiAiS6MmLAtlr0WVnMLvPUnhqQYVLzUFhWuDLayX6lgBGzm78Hb5Fflh1rFuDZhxxv3s4YYaB6gOCL8NhdhmcuV6AVKcEuppjzYMojuIvQrWBUqVY2/1t/9gkfwAwcyNtjijtmtxnhjdTR1knFkmPSkM1mMIhfS3v/TF1kB4piYGZtTVxiw1N/K58sgOZ6d2jcR6qouMfebzcrGNT4ypvSaWVBemZaImIA3FLLbwyQ/4jOjl/CoRTOgTuQZvXWKi0RiAS/Uscacpu0D2B7yygg/aJ0eKMlZC88KSLvBCMs+5FwXOlNBcdgv8eKF/aACsj3ahZ/Zwu8ZkPoziun2ifM7B3yM1aTTTVnumY5+cxKZKueEqsDQtBVCNEIHaiJ6leRSSoNHWc8gMeJYZamhG3VNOjDwEtJpBjCaEgs4HSjvHfZYVDj7JtDGfM3bC8GBcV5elXX7AEgc/xIV1Xc5AMSsSWNuMKNmAHiYFB9Y2hsae4uVMkOfWi7mKVeyK5cUy/vBeckG+LeEXCcq7pEf85OtcPX4XnP49va4O+ohWxZOtapLJ+vua1RmruzpQJX81BHXMuhpU6xWIUx+jXvYHSslFXxI/3QFFpex4oEvOPtG73fgcztvQZ5hC2hhzb/5fPW/SqBBuTanMLJSTqv6hv2aI400vQ6nlNrF1kv2h1ReD7sMfjVsTfU8YeqKTHU65t+BRYC4CfYRXzyj7uPQpVp2pLtYfcGCh0GLUiFDXeh9/iLujtwTUk1b2CVlA1FNkfGmR9CBmIIgaxJWvVqdL8M9JdZ/UD5S50a96Yi1E7Um28UWcfQq5rJOUGI9Q7V/HG1VxN2jYvt3RD993ztfOPPPKKj9f5hox6JkHI2baA2pAs9plBru2DvVsvgrk+G9KK8qMdxQt1wJqrqt3waJ5W3YrAriVzp8btuXvL8Y9MNcCGIKEInZaxny/azP3ZV2Nl7aoeWSo5Q1d21K2Gh+ogkksdi1KsfWQPKAO1RVusp4PjG0bDCauetwjEPUUou4+hWKR/l3WW4OX19IQydGwvFchevae9tXc1wyBB4f+N6OoOZTgQhEaIvpvTfSAvCPDii+Bg8IzQlZlvHrcFZoXgjjOvmQQydkX7J0Ohio+gJViiKTQHrRCuh3CxliktRfGIho0Lr0rp7gxiLQY6EVemodWuS1EkpSWw/Uo15f7/WS0DvGcaMoWd/J6oZ8D/mgdsMcUoA60hMuRQzmUJC0VYH1v2zPfcFZtV44PGeZuWMQkVHqrFwbXOfq0qjtHBFvW/TRKKLFIrN/gahD5sidUf2U622oU837b3tomrRnXb/pfhSGpazbyMBUHd33vxRu6UQxxSOzjvvEGVDctGdvHBlDTd842G7xVaZjDI5/pTePl3isqrkn9En24EHCDMIwPTpfUpgljYfbHwEyVRpGSuXP5Adkw9PZA8HavZX+CTLr2hHiIFQS4mcRStkvVsjxVy6oxzwZ/fomqRzQOZH8quN801/lHtVZTF2y5YBu0psGAwOmK7PH5EUIYUYdtzFn04xDc8KMOVcqWQxLjj31fvqA2ZRf1HHypUvLU+tLKHk6t4EOIZKzoqYkiufPLWzTIzEClUanV28yXK93Y4oIr1jNwDx+uyoc9++EKrbDKXwo9hcEd+TJuQuo2sIF0/ljADQtIB3KPcF8uB9M4Uj3XhgK4oK3kbfAntY18m8B5dUS6sgx4urq5vbQVX23nBwtziOa5ioUcmp2RspB6aL1FZ/PKkCupmdsR24aDd++RG/0za1I3beEyjmgceGvPWgeIIGKMjJvUrQPo4tH2QQ5ryTTIW3ChgdMFs+fXW97WbHoMbd2edeenY7tol46v5ltKBImoDjlhV/FkZjKnOpeQknrTLNgXuYh7UOMuVUxZJDg9LGZFdgIVVbmeNuXLHXmOU3RxfLeT/04Bw03CuLE4LvfMOHAPV9FRjplSyCn5ThQhehm1IlCjCQrKhxt8G/9z3sP3eVx0QDMA6k4KNL2SuNOa1p1XJnIHfPblp8l0W6Aug/W5U3t+mngrPI1qm1R6Gp1KtYnaOE6bYioNtFKfm3bKw5/1il381WkIFPzDEt0rOGkXFfwpv1yu+fil2Il8CJyi+fbaJLzs1ivEUxq9UygSeeKfT77lbz7vUc4/eW4sEchS4Mye9uSlOsJ2cPfkmY7xLMTatBOOH6HoRgs6imHuYXQ44RT+O9WOaCgjOqV1p3I+5A/ReoBv0xE91Y7oKVNG9JTREeWqT+O/HTKi4XFGlEcd/ic3HdEdGO2J2k7bZEThtlJGlL/agcDp1RE93Y0o8mEgkQ+BU92IIsmNKOAITEfTBx+u/hWnjozraZSjjM/zjHnqz++5rPpX7ECzuYBXfnv1r9iFeh70GOg7Bf9sCYT8ZFLxC/iO4UlBmLsLGPIKXAojWFf8sbYyfMrhZYKfBT8z8nXJbl1T1F58BhOfM9RwjLy8V3k2OuO90FXBAdUyq3VtMZfGjXuOOTiFmLNbRKyauYdHlpdOZZrQdAppkdubDWSTgXNDkrXKZ/Qdkzb5FYfPqDbpN0vFwQd5Z9QeylqwMdj3X+ofuv6NMbs8opa7tIXrzBvrWKGcoG84pLRUsCBvJPkokgeDcms5GBwp3DJIGlT+Pf0r3wunXBzWO0ID6IIZ0WvFnbHMONs37+xaBCYEljqwWIUsU+AMVq9iNF1SAdZHUAEErB0YnDiCzDInwHxmQ31VGyCRCmvUoJNaikzYNywpRxTiOMJYtAr1E19FUCzpIrnVLdkQFypvGDp/+erO2MN3mfi2z8Rw5R+jeeQLgynZwS0am9NiXIX7W70dnL4m4n2oKrNVthR+adPXWfQtgqobiHVwmnfg1nrg7I3kYYn+3hqgKdsOwFmktngbHnEOvCIkfMYmlKXrlkDJjN2N+OS73Yi+6G5EX3Q3Ii9uN+LLNiJWnym2YbJTEE+vsTYPd2bxSHB1wVXtpn2sxVAduxHPKkB60iqzG/FlN8KbhZE6lJk3ZcsBscg1iQPhWB2+7Eb0bo0CUXYjvrRUYIjdiH5jdyMxdiNIrJzCY/+//8wAQGVIK105UoQO5C7IJMaMlq8V2YbKjSlXZnWQXJkKLgpRSjo6Vvrp4VcDq8Py5aqe2XxjXNwOSjaQdwyH6ac8nvKjdrqopofofvZ3ei7ZXzDmyUONwaU1hZVEGl/RqCLAI0Ja/7pSZyTSUlElpvYaLox4a85NuXUa7VUy8B+Y1UB1LpybmNBK4ojj9QyWh1wlcSL+KXihAjRO4FD8F143ab7o+F+8bcoXL9dbgPY+ou44fbeHeureTlpOZG3vvr/9/NELdvzOhXv3/drGG+MHlvbYwPl77R4jfFYP50zP6g3EL0NY+mUop/wFewfpf/Kxr5ywjms9jyrW6qCijOztSiFh+8hX49i/K2Z1goo1WRzJDNJ3ekEgh1abnbMFOu65P6EXhWBcOVur23Oz+ti5mZ6tTc2jh8t5pD4acN5p7JJQoJv17H9hzzp20vaf+W4r8BLz11dQtrW7FW+EcgHLx1fYOh/6nJld2d/cKAU6bboEeHTQFL3medNML4s5E35A3dSaXIZESbbpQhJVSoiQSgn7qDWEeJA5hc/IxhvlUMViRD2oiyIz1arCvMC3fRLCeSKxXlAV60UjYr0IkpYRsV6INQWjcqRwKulUHxHrJa4tFFuxXmzFenUosoyK9UaXLKpX/RV9v0uHYC9chxQloXiKWK/OYr0IuBLJflvw5/nKGqhhH9zWqxaVN/qeaGt7hTcJwK8D4CAHYqLsAJeMAC6twKFuAVe3gEtwF+G4gEuGUrYDXIMCgCul+hRwJQ5cABNB0NWE8lKTLLR83JXhBC81NryLJo50xoAIVUYmwrCD2fz3CkaxqQBAFn4PpJ3fOQCA2WuawEHhBU5EIX72caQQbw9wfrE535gHVVbQc+JmyxZWmUJ4FRs8nkwfWLFoGtMXGkZHnYyow6dpTF+oxVCkTJ9e6J3G9AXjTJ9Y7TVlX1mEYPpQCweCqUyfsp95MIXpCyaZvjCvMljWscgklxWMcFnBiTDjzscRM24MvGDSTqs1rZvdd2jK7sptTd32LXLbt2hy++bSJRUT4RFVAaavo7ofn0V2hTP3O/ucvoLXiIy9UmWZ1Go+3A2uyQ2A/fjdLVYfJeIs/OxZ29+/9po1Q6IiLacmt+qxrwPfSJE0CHGR7usitE8gXpuyr/O51feq/yyhYpIdlIGbV93XjZiJ/YTnh8dRUXLCcSxoRj0mjyY1l+Kq1LvugslxNZfEx11iuKvjazeJS506NJfAXFnJ9pBidb42xl49h/HYOCszrsvUKYoq/tzxulH/ZJDQSqLvPLlUfZS15DNo2ECpCzsQPQgiH/C5CfApAVWw/aQGG3RVm7E+2ql+rCgE3vhC0qCBojezph2oybc1JR/orpaBKh9BOZ00+99jvlj+TN+31qw2EGPxvYirKs6sal8/CexgevLlT6Bz4Mw51gBCjybTL/ls5FpQQE8XAvyEfFwDBJGdVeBEKoLCFKxJtK75/Dorqib8pzMJVwkr/FIEDoBDuivLg0pdMhPqUlcoRctZQ93UFSJfhLqUvwgxKafXRQEIL5iOmAKt0jAdgX4bgekIhOnA5FY2Y6QtIX5iaUsdVStqxNoWvVgerkl0inZQHWR+Wmt4FSgELMQB1Dq5ci974LV1DamcEKeHPLGVY8+IQiNpUgveKlYiXwYl+0t8JSMieUUcdL9igX6MzHrgH8qr+AKCvWd+QBwl06KTyktRyox0lqXip6n/6Zo6xGB0+Mg/MOqhOKi3oSSe6LYpf21VAyh0BrnTvWbuYi5mfyV99EiK4EdFsqV7fzxC4+JDmpakr8DeyhneMUa/tbVq7GZ/xUecv5+TkVVoR9/rpLpfVOvBz6Ka7uJkOUPENRgX3C/HtsvsTQv9GFiTvkBGgjwxWI6HVIywyhsKdW8uXdYWcDzCAaK4HtSbCE0Hp+hJNoHMaC/TbwWkMwto8is+m7QmFCAh9bhjXb4EEtU31C1Mv5zGMavKqe24cvkfeCMC1ezHD5XVtHhK+iSNX9UD5kK0cmQYDrCajkNE/lJ9tItp4n4mBt/BvFiwipeKOp9kIyYDII2iLiwqJrComPsQlht7nDsVjVYpVGWlcLqjel5jQ8LzIv3s2RTgcbmRBFnHINCCVBfqqkqsKnnGH6O0PDfgulwuTnMJ0EDSM3R1H4JLGj4eq7nQbg95QuQxRT4AuEmGwod23Xn+LplXTkk1byJCqkIjr6UAXXzJhAg9dbqxaiNS/c5JG4pYWQeY4UgCBT759sC5Looi6MfLcnQVVAn0k73gfA8FmFvP4wd37zvxhh4EOI+3YKGk72dfVKc+mAWFr/ddpUD8vEQuBSdgLM5igMpyfj++yx7EolK01YdjWyp1wm5fZ7VSN1uyGmbUik0z2tmXUDnMNoxWKSZMD2T/rKYzZaCV2C3IKoB7XBHu6roryUNK2X6pO4mADqcDa96B4eHU8o86LEKrnp3X1Kr0YY8CNzK+jAxG+0VFHQZSLwhu4QxcMf8c9tayv1fRD3HCIU9LOOhpmqrXZ1/WHGdyyXmLAg5xEa4GNMFWUif/wP6CNaGzoV4+LZpDKC8HuJF8Gwd3GzWbPXAzrfQE7YVt9V0QskloNxRJAwXtef4tkq62hG/2xORoF01LbA/+Ae2baE/hb6znzUnjX2jj1T1xGsgZZlW9pbp9birqUnP9iIO73jafyVvWuwWuYWQGyzkVE2uWWsN370F/ItOyf1TIyfAYv6nP1umwcKlqgeq0i3WGzAkJhsk0Xaa7wEFtoGKkWLlXt4iYNnp3yx1T1XgMdMFcU710HwOuAyF4UZd2OUuuLbR/apovzZVGFDVzUgfsj+2dn0C0gmX09Lt/Mn1NKnEPmri2TlgQG/VWagbXRb9Jo5mml/L0dBETr1yca9mfID7dNi0Wy7na1duN7eGkCBc7JCibZn97aMxb6pvBl0zxHE8eBkKdtdnLFLpm7CmwSOmKdxEF7pBSk8+qJO+uJkuZq2vWm6iCApGyLUXjFAq+axyXU+nb+8HOThwmOicukD7loXEp0AJ2KHdoiOzZNeV00f1r17DX1w8DCvEeWtN1SC3quchq3HfqIzMU/bW+rz5Y9WBCdxoQNuNeZaRuAu3z0p5xY+ePurHz2p5zY2dLSZUitHSVUmrgJ+JTHNdCMa+yg6+TnTq2Sgw69WvX8lPbhxqw1PpkGTUe/IlwxPldZMGnWwBuOwLq7iBWZqwOEv5tJqEOpxgJRxSNZyNKVrZEXabA85b1LZQ31Q+X8SrUpNi6Ak7BjiFG7/bqp7Lbj4FnDTTCx2kehVCET9f2m813TOn+whjIjtWLUWyLHyubH5pTC065YMtVxbDm7llfeonAD13AOyBYr1SsncCoompOe652MpDGaJ1WnRFVI8ullc4YezW4u406m1pnaDxAeFJxjEj0xejnprpgMu5Zl5SCgmhADIxrojSql44o49IRpUf6bcVDaV2H0fRHJNix8+qhfLFtP24yp9x4lC/bcYAiu0EQzaO68SepXtYsQXGOJO+IAjFiMTkzdceRHdeHoI+e6/G4GDtW/k+xCQRL7V8FznWNurn1daoG+qHP9xwurIV4Jd9dmmiAQgbO+yp4Qp1dMTXEYbDpbpB9BX3RgchkSyK+iH21Rc2Agypn9s9OGtXilNYBhmwhDYi1H/xVFx6Mm+pnOBTb1uwBpPQV42NUGkjFFb8Zva/Ay7n2NyYtoCOV9n/hEz//CXZsg241TEoL2+AGmo8G9X8eOajV58cZjAYdpav/gmYqp8LVjdQjRAXgAL+nbU6AXS94oagwNKyrkgaOT0qfk2JCgwSabSmziBFGZ8TocGC8UbYoUYg3BMp4S/QBXxIPGSxqE77WXTfgp2CaCkadUTjTVR0M8dOePax4ZyVcqrUO6EEE+FUkVumeOP10Frevy33d+4jA9dYiLBO+DwsDO7t5xtfsv9oNNvxPX6t9d8kjPXidKmXgKFBZ6YpvefFf9/6TKYNbm4sX4sh9XuHDOD2SelDBaIHWXtjXav+/dm30cwrL73AmLRCILJcWctQPm6g3a5Qv8lO1UwMbZulrfM+/1sLHv3U6dKY3pGbfH/qaHBhriR0FlPpVGmlqsDmYNi8MpRwPGiNjgfVdDxTwKcow/Q8MSEzHDaACAxXA4d31xBqyZOkr/5Wa1vfWnChcjDU+z5lwO3iU3y8XfX/ycIXFXcTzybevFJrzj90I8+0W/OweXGDfu/jZw+977HU98Ihiq02LQPoleYTHXms795JRQ3J7p228UaUVolsvRmCc4oriT6OvFj1SEC25xpPCWyXrQbTVzxaKRv+0aZU+agvLbqJjanKe8hnpVt7BY1eeVQvwxwtwRUpu+VJhIWVJuQZWGXWOXICew5Q6h/Yal49C3tQDg1IvvdKSUqg1aM1tZux6Bj2IxLUWVghednE3hlrqT5KauirNVvQRqMnEP59zMbhE1+LipMxvlQJmib9OQOpnYaKvBbBRpGvHHOQqqECsGXaAhpCGUGdYdERMTB2xLaXqAxY2AjUDm1huI+rXeaZAji02ZQwKohkuzkJ8xiIW4LWLWlhyWsYKjuKBDvNa6dYmUPV6ofYLCLeEbJbZWoUV5bbA+SKKOdlvUXthoD6o9935YkrzOE/hIkJqCZMSqE97UbiluvwuQps8RWtSRU43FKZGOxbPQuPcWJkFguek3THc+Di7tWatzj2qKFJ1av21Ezi13twu+mtPZBf9bM8b/bSmn5pDJQ+5azb3v5oX7xtfd/wO/0hw8p77wVpNeO5HXOg89/P86vOg49C0dTW/rZ3Aj/8nmRXyjB9/8EjOj/8nkEKh8krOj/+rX+f8+G9W5yPy6t9/yQu5gLXH37f/a143zbc/6lJkGnPvfwhxj9J59+HXjTvv7h5wzrvxMua8e+80590Ff3Y1Y/Tao/DgfXplOy8Txvpf/O88qv2n/0Dfy35UOp3e7HuNk3PlXmC/7ly5hxVX7s6RuzfuyB0imod0fyV2jyHHuANVQGES55ixJQ3kKou4sv2mXOGmQ914RhQabhpHpCoC4fJRTlUHWBhnDDMyyCOUB9Kyj73W+WwPJny2/x5Sa+nrY3aY6L3SXaiv7PJ1qvdfuTbjwwl2ed1TtlZaP5rR8oXJUiGKztwRMQjVDNK7U25bhp6DaBnVOJupxvvPZ9DrzseL3B0y7K3MJ5Yz4Gmvq8oeAZmMUxyVvqmDZmnVedVSbHshWjcLVYyyGmMtb5RfqWd2jVDqnlLsKkH7UYKrBRJCpjCpEY17BJ9T/GPbqk2ESPxSYww+gC/mJvDAARS9o6aaui9SSJqSCfEUf4JeoDnSXRa+BikM7as3q1j8beLTlpibS3j/PlKGtr61xlkg8o9AdljED9sgEbXVSoHs6GRHbyRKrRKEdcClyWiMdqsIZKKJqcLPA2QS6Q9DQsBqpWo+xWhwbG52K3QaOQAVjJSFnnFDa9WGkjY0MTQghtqObSh6BAl4i1JKsusRR5HcokDC7lJCkR6DZHMTn8KdzVwKW0e5sufUD/UC5Jgz4XDMmXDkHBXzp1pwgDHy5Wt1ISzUwTdkARGWLOgkd96DX/W6qd6Dj4DmWf+0AWRCodBHhMSPvPNPG5t5EBEmllqErjt3sDEMtyeqVcUvnmlnAwQKb02D1U2dIHUFiEoV9WMhagSCJz5oQ+uDFpLO/UBQ1KmaFabDQFXngzYdqbQ+pdLEVLpWcXyLSvcX0ikgzJif2WAt/TkwRHp1NTBbHYxaWBqs9w3MdQkI7eh7morMIM94E57JUHV/v2qToBiw8X5lYY+AOtWFXW5nK0GNjBkBKdLW5AvNgVyifnIrGPwPh24F8yormFdZw4LxNQwo+ICREYYqHHqdLPHQf8IS5hyNC8OHVkao11Uec8Ha90D7HhsBqq5xIpVW8Y+GEpzB6rdQXVM4RFgAWqgE+eQRygNp2etf5xa2+sTC9obHwM+8cYKfaVX5mdYEP7O75GfC7Ifx8Yn4l++ednhSYXlVtx1rPezDlQcdP4KyKbBieq3f8XGjfNGj7v5NE90PX+K6j5ex7j91GjvHB/z7HwUnVwgYFF95Qcyuf5VESyNUI0KzKO9ezSLDpFmOD9/kpOGriOfg+wh3WdpQFciONrRrG/rO2E1mKtku+CDhuSmHSpfLZaP+FVgwxT15Q28W2P9KT+PNmTiOxVINlkSPV3edNR73USeOekjXmVXTC2OqAdaVUMihBVi2WqNIl/g3MTy4hxGSrdNvS7UUAfRkABRL/X1rCHGtSFEqW5N6yc9+THckYRnPXS4Tb0ZiKxhNY1a0zPDjyKBMZrO/rKdLlq3QPfJPuCLw+pPug7iPETUMBh6S4RZtj5+SuoFhjFW2ETVcD9QikUqXTdeWBYBik5JqNCE6k+McF92EWoB7HYVhUMIwMDAMLAw1hDjlNWuVJqSm10VT1UjLUa6Vo1zj9mGMpw2ujvvkGLfVAl8egxgY+N2KBOHXgE8adxviYK5vfy7asHrJJhKmTCEcc643I5eeCgAojL42UniI3IPtgACA5yfOxzBM+i1YSN2qybe5UCdtgpMafD+v1X1PN+DcBnsUpKGIx00ZGDHa1kllTT67pnkkhDwoOEAuNSOl9tZ8fV4Kpj5Ifzv066w+ZS3mVeW3qg1klfHEEJxyHTFUbUKBPFa0ZyOMeD7MuARh+KWTY7SGHvQ0zTnqn1XEtR+puVEJqaGlN7VgX+uNtOhYS/W4VLje2KwcOTkE7uXCKJart08pnloeKkHrXedM+ytN73vHr6RmKqlVJEKeVgJUPunObA4S4IurZaIraCBqOk5DTr4Vx+9t7XggTdWQn0GXRvqA7/sOleC1MBrRig8dkQhk0u5BSCbtuQhBJSISxMG6fJaEFdt2Iczqc6Ikf7F4j8LPTtdObV1ex+Rycjqq44kJoJXFWpOvNXlcIh6oMNAKdWuDCjerx9N6RuFR1hNoPaHW42k9Na0H00VrwWQ5Xh01rWNsYOsK88h5Xkz/PFCIu8OXuApx0Fhdc4ybQQw7Qqh+H8Vop3gjMBP8IgmHMqn3IMzdEPr2+7U1XBCW33NdQxXUciMotA3FXMITexytrq51BVqXD9DEdpRRpY5yhCo3r8nXmkaHt6wp1JoircnXmjytSYdXa9LhPX5NntY0OsBlTYEBodbkaU01rUkHGPVggI9fS01rGRviRIc4rsjsP17ZCO2e1OtRtdNQwxjHXKaULnJ14irU3JM970/0oFtCC1hLJZQAHSWEdu9ESO2bBpxJFLKoOurUKNf4OrY/Vq8/EVODtj+gb7LdTlq+qI5rHbFUAECS1Ii1fRUhWdu7Erpa1vGQnznMbT1hTVqA1pSLRipVitXJlBI1z6XQqyOyTg2GbkOBYxV+nJ29X/W96GShWkMzIgVurMCtG6CGRomiBGqtBGqtBGqtBGrtuEANS6BGKinidGlIBeFjLbLuYFhWtVpW1dWqFrTltc0BiCgHOOGUcHDKn4SbAe6nAz8yFEdBF46BrsKrR31flb5eiTvmoh8kDCDF2e1og3UGcJ3W4uWxCqQU6CLRQIcwF/GxrluEh8IWIYVt6YBR9SlkHUdL5PKTnqc6SMcy9RqYphay4D7NM4AxR21fqpxdTL51j6M90h2KjxaV3C6pHFMLyH4Knxd1Uf7SA23LHdRHqEp4ekDn29Au5ZTrwk1ikBWM2Vu0Lb5UiiZ8W14Xg1Iw+KQyJ0jDQife89N3RtPwm4KyvQgHhgZ3JRy+GDR4QdEq44duroBuurnaiZBMTe2sohWmvMNka1s2FqIQF3AGCKExDisDMnWNVoMxRW8NZvevRVU6ieOpdTxT+oyS1RBjTafj9NLrMjW15AXTCYUwqt20eJHsQpRULfnkwFN4m5U8WXDdjEaGSLNXqrv9JvSdu4iTUMZxj3dHH+fuofFGeRmYjOxKQt0ql5LnaE6FslA9vX4Eaav7kBJpQ13hQsZWXeEwCcEbYfHpCu0Lzcq2IKGMQ5kyvkIvStyq81so5ARdUSWCalekUPWxjA+4F1KVL2DpSuglphYf/fQn6zlOBc/UUxDxrApdxse1ZIDf15KLOr/LgmqurgAoFumQQ5FOQzVDihTpNGSQLqTNwFskj6h5inOPa2/ReCCd6WZaLiJ4OLSDLFv7Z7EPKArNSEc50y+HQcDLmzM8WnOGRz2wOpMiqZk4ilQgVc6apJw1oZ01kXIKcICMh25/JKTbn6C/U3mC3WXPdHHRU8ioIoyO8WyFmwieguMInvwTCZ68kQxFVBYreYt6hc3UI1ock6hWlNIz7WVdupdIKDRQiLTnUdnzCEnYX0zru5RSzvpGlck0+yVaq/KZ/Sv0MDBSVtPXKhKBLAW2amDwWRJaENqGUAbaVrKa2JChHWjTGKvJsXob2VEvVajqJ7LOy1A8S7UWwXfmDapjhRZOCuRGuSmgUSqa/+4ywy+FXjJJ+MBPKL/hKwcFO6l4DeS+J99bg/6v9QTif7sIUtAQyK7VPbWy9soY6UhIlthmIZNFJ5vl/mMwLeBRw8pM6+Ho05Ufa/lxWX5cKT/QLFO4NCz2k2Xr2ckokW8okW/qwGuRZe1pZTrUL2HyWRe9FoBE7eHA6oyC5CT665qcWLqmDDVClqGOLf0h/CyUUInTShWBVhGUVQRlFQ0tsKlEL0RFddhayutTC1YmJ3XEKq2SqT/zHMJQSaEUT/wXwuKV3gt0iAIaIk0ExmNZc5gjKFbXO/d2lnTLWbKg8yiTiF1yQoLQTp3gMhGxtwwFa4L+9pItCE1PiiY8RUFpmgMJ5lJSjl4iN8T1kDRw1hWS9K3+NFZAhxbN1SEzs8KCvlaCPkHIImTJyoQlKxM6VmYCGwH6SZ4jVnSsq7o9BYXrRAShYEhq5FUbdAJciBUX6hVcSHJvKh6o07LpaCCXlcuDJMh4raYL1dQqgO8Uczx3jK/CIYAJF6+DysVrtd2h133t2XzuB0hXqbHeb0VnsF5n66qwpx8jh5buyytXiDNhuXdQvXiNF1wfG714fTGuA3/BXrzmq6D2FleADKFYWJA2ZT+t5/+V4/+Ja9dvfd0jvnb9f97F5ztCH/auJxUc3Sj3/ZfyeOpVmGukx/wqFjezP8QV0eyP8AsFFJ7QerJ7j8Qg5+6RGEgtLxqJ8XTsnrfJ0esl4vNNP1Cniir1q8bU5QW6RHrnIXu78wcaFonRS0BVdVWGiBQpQzz0O3AeoKtVC4EDdzezSMVdKqV34OlRw+TTVInD9OYEfqACs8HAI7SeBDGq1jWH4kJDVAjqei7X/3htTeBzNz9L25Du6mUDVy83uCn2tqUcMdvLlJSqvr2200arVVRbmfcSa4a2LqhWum+KywuDGlM1UaN3JO+ddkdyIhYzT89zZ/SEPPs5PYn7hOf50+5Maq9FgQO5tXYPMBiP1dG8SHWDaiqc9d3FR03eXUk+dzJ5ZyV5VzVZquxOa0fLRX5FI6vXXlCY6/OvnpHOiZUncP7hywP+a10XvNx2vAiENTzIF+D3XlMutqre0jdOISwuF4nxvoPUJqJaSOR+9Gtn1+5/+w2HaqKE1hdHVPfK+9T5Ex7TNBj/kc/UqEDeUhRt6/3rfvJiGPrGfd9agBVdvuI5pjYaOaIFRqxrjBLEbD4eLUbWIqPWi/NZkgbPwQCMfAvPLqLXvpEvah15DBv+fevXrY10nGfMvhj35yIx6fchmPRDwkUkEUNahF9R/jAidFj8FNbEv+iSOlNcYNqk3lXnKROzPPPgrMODXt6lOXRoCz+4wyu0AOlhjwtYDYzSHe5FR3h0i9q3TrX+vDXfRlth1D0nEbuBwnSwjCdCieHDdZUf4I1yilRNLI+Q+p15gccl+Y4pxRIXSVw05VsFGCvilYcKVZZYovwAzV0NsMyuGU87sIZO+gYWV+NOkW4sqeLldtrJHnLQVjoFga1oMGkk0TaN3JYazUyudAv6UbEoH8B0PTvlKXbSds5LxGFYmeYExHwRMQ8ghjQrvxQ2QbNmmlU/lqw1CuBrjiP4ST2eTA8h2GOoXfcDRczvD+J9gRD8MgdFHFNTx7DwravKn+L6MaIuxWLKeif3qnXD3b/9wt3/7b6L7ZMBYiG951vsE208pYz+dfuUpiN6L+7zf9A+UQQ3VVKuWPnedx17v326lB+4Ojjn9VvW32ufmlKQ/uM3LvhLnFP/wxfXfuL3//OFf/zZp9mnNPTzt5/5+s999j9/wD4BLsS/4qvv+O6/2PpbT7dPG/+J7/3QloF3xgft08b/zIPZ7Ozs9Rfbp42/9Lvw7zc+aJ8ary1F/3Tp+qB9Im3C25T0mMa78/E9hz7wV/985/vtUz79yDve9f63/G3+dPu0zXj7d9x+8LmvfNMH7NPGH178Xe7GPz/dPm38//cfPrR04EP/8YP2aeOfLd346Yvt03VnO0yfe2ZieeW8ffjbpxm6f/iTXrHt4e8oTp2SyKb5gcpcmm+i7JOzfzvh24e/A5VC8gRc5ClMKIzoNCL5lLY+/Hsejec22hmxUV7uZ0JFV7Eyr1pHuh3k6FDW9zkjP2Is1I6YxiqJAz+8C4+sOF2s9GAe52dgoifQzj1T14uz8OGn5cOzlfai9B4FeLT5qxl8yb04Oz+DYs6zC2vLOaoDbrSEzgJdfQK2JDNseCvfTWfTDD3hAHbjTGM7eOVJWcxz3Fqe8WvcPxhwsMXT94lc8JPojPzJdCZcp5uVog0H1Mv8U6j3MBCHHuLATJYxelSi1oCNS1NxI9DJC8ryHdRiev4kJuZPBhXvvzLPqRBnERFtyZdoJZ+lVakNMjd1o7aTZsvwKbRUhomiMsyEhWYRYnSqyXMrcGsbRfJyKi3J8zREnmv9kOl5LDsxQOxTqEuEwHllMs2zDfoyzxeNewYEQIq5UKxTGRfK84upNhKAUl0OTKInvpDyu/LZYY9biAmgdc1x7SiHK0A0SpBo14Sn0HmoQL8m+Zi20bmI2yZxA25RtUROlUxdOnVqiXAsoZ3C17u5T9INQhxJ3F1c3UiJRMjEH3Zdic6ziRwaLuGxRLN4zNp5k0PAkOucoEJ4iYJ2yHMHbZHnFlqR5wqtynPV+hmYMfOL5mV+4ZFRC48WPQmPJ9GTafca4+pynx/L9ER890R6wreqaN0Iac/pv4KvdHg1Py1nhv/vdWZ8c2Z8c2YEKSZC8KL8fDwuxTIBLOcSzuBQgps3eQthTIUOyjqbazr/AIrjGSGhJzL67uEJ8QSeELsf/YSg8QnxhDznyVDwRNjBE2ILPZH7vttMijnK83jKxJgHG77JxIgqE2NemW/GlshMitnKpLADOm/QgEjx2cTrFLPIDcwWhP75Zz/v/h969+cvts9iO7jIrfy9sikiY7DP4lxOFOzSkoGHgq4a252cH0SCjoRSyylGdq4gtmweGBmdK4h2eKi92eqQmgrSmk+REnWajCI1vPDQJFIr4h4Xt+fxmIfHKEwoxe1ccDd/lDj+BOzZnkAtyoCVT8bbkxnHM+DlE/H2RNqNt92M6gRU34PP99D5sggA1SGPfRL4IiB3nlUwe0Uw+0kHuFbGvhbj8wLj8zLj85Zgr0FL2sJIm+Qkz5o42d9BC9zHFewfuVvLeQH0ROcZOHMMmZzBUuRLYDUraBlX6TXFBgUjRUGHZY76VgaQSlKqQ2dJb3XMOBqp2Dae7JhhlGbNKM0D+jJ0eM5NjhrAusOOygIgv0ArlMnI4Y35Ybwt87hmGNYWPmBypB+cSWfROS8q+Adb7leuqc/dM+kcmjmQz2DfyJCPaRfYbHamhI/ojJKJflZuZBcFXN+pt16EQg61EBLzLE/iZ/QSuO7l8WUsaWK17yEM0QMOMFsHTIHFcr5Qde4LX1I9jPYZtIN7y0lwUDbHyQXNyw5WxQYokQkZdrR2WKkmPEKRc8ReHltE4IOavJOOdC7nR4iRMcdzq65SNbMW5/KUhfRc3ZFfTQGGXTdKSo7wkXqZCqhrl2gsv6AnmoQzWNAU2cLvtkXYHT7ndpv7rsEizPZNl2dQCXFyFWBt1I9JxmtOhUg4wRZwhDXHQAimuShaUiQk7KEO6v1Ri2jq3Z56VsEqxTAsYxjaIlnr8FBknK+V57wkFDzfdvDysEVFDeJjl1a4fl71phjzq/UeXuAO7kCWVYEwiWSHYlmLdH1fRYt1aRDpD8ViOWKRP7WEl+Uy1CaulEu0JW2Tb2UsT6XF2zj3aSY3oG/3jxHNgQB3CVVhItutPHyBKb+CzxTU1c9yswptNjIuZ4Gc54JAlJHzNCuTmR+Yy3jkVOAxQn+vw0S1Zq7UZHFN5+tKX2b2Ah5Mi5lI5DE/fPgMj+VCozmAGiZJmwWn0XX+yz0RmAb2OOKB7v4RSWmBcy0juSefZUhyUharmdS8bkz8qptJNUqi920bKlVtQkipt4tFAKg2BGrITAloAoyCqu0DSDxrym1bhJK6W9SAsP0AUwmIT1PM/JB8CCdn8AAz5W+Ig8NZSmX6z6GNDBgA57Ieh44qTWa7dfMom2bhobtYUK+Mu/NFPHbmDVVMghwsgxWPEFJSasghNY8CxIMG5ZZoabo3b52mqlM4zem4urFcJLOoLE3LQb5MkmVaYsTgR008jvOrRPASUJPuqQgR/vaJW7mMevFac69oOJQ/5q3rty46N0USs2RoBZ6Xm+de89yt58JdysTgllqxBeQCeCIHJCZ9jTN+In7CQznIuSzIPbkQ0s4X0SBpcwPQXl0rtoL+cB8X85qOhqp11EEshFwR99+IYw20RcsjtwqYzoMuIMMl1qTEZeIvJfdWWpIRRqIU2AOYV3RywtWc0gPJu4iZtKgG0xqAozLwXUaItY1i2235dnTENrJBMz/A3ZBSqw5bqe+53phWEAViN5yR6sWwiJOTjLMcTHAAmqLohZpkc9OFuvgtIHzeRjPUuKZHNKSatamjDVWffBDe8hKMxq7lXVKVq3b/oBxCzAkZYUoDslLwvLnUolPXHlL/Dg/acUz0T9rij6q2+GMXrKst/uPb2d/cFr/zhkSeXASO1dFR6fon2Ts0oS67FB4U0aRd/j9HX7xrp1y6xOnOg6OnO/4X3AmOJolF/y/rYU4NJw2B9j5Un8NJH1/Y0/XgMtjW0MO9t6u5e/LKVQ7ckeTOfkmv4mLw7vaKyHlykRMzXBZBf4e4CXfbcOyzqnkUrTz9myTIYE77uso1nrDay0O/ONrLh1wvJUl7eSOCqX5x5+gXwUDep596HZY0lKafpeaWuVgM+xG0ohyj0pH9rr2DhwL4l1AP7mBsWef8GhhcBoUTb7jNvifrR0v1icwxMlqTUavfghRIqgbz4mNtEk1DBTzOmSUxj1RVYt8P3nzx2l8+4XcIHnlwvc+zJi152lFT1qFU5LEBRVXDY2KkVwAGe4Avzr6sBrsxKgdRAQKSXMRiDirO3gZaiSow8eMyncTTM5bOlgi1W+JPYd0O/lEbUEP+PTnoboEItewJd8O4eVOa7nFCaulGShEiS48iJBfnGbRtRSla02U5yWfwWJAzxYzq+Sw4asjCseABxCByGpqjjItnQFtQzk81fr4gK0ZIeO42TzJP3Oh82TVMRmfVpZ2eKYpCdbZfo7itc8R/3NYEPg/ACy3yCb4QQ+OEHGdn8NREMRbili6gCzLc6L3wtXaNWACYhGqmQjU1t1sy7J5Kj1mV6aCaICAlz1H9FtQSyffYHwWUCQPSJIiPlvB3aW8/OGGKuKnaKRxUoD2UlsvAgqODXt8rG6qQUZsbcXUZ8MRfjMguOcB9bik/VCMxu9ag1K4Hy+jAHI//kpToiS9HisQth/MJpHyi2ddJx5raJyiJksfkRdcOa6rMrB2zuKYwSxniMmrrwhe6G2wwSeE7ZdsRE8s46lcn7Pq2W9/Osga8OOoiRcNAUzKx3HURlKwQOt3fyTRVQ2w1vFum7ilDRPDwK05/lND+MqiiajBdpFYHjpZNfePjaU4MAjEOe9l7S+NhODXNvdKq2PvKhNyrWEEg25xf8ULvlR6T6tKNonEIcTr8LOHDLprCCJvk6tCtiPEj5HlVdIpTMSID9X9+BGJKGRSdFACrmo3LI8T5+p3xjl9jXUD1o39U7HjJzvd+0U0icRAvC7uJwv1kP3unrDhH/aCORr/ypIx78PcvtNY9fvKf/iqBjtu71OjFuJEPzSu6sc7Qx0/wNxT0f/df3hU6Mx+/ggKKAHVF4mMYANCdekIx67xDD0gBwXQSKwTPZt1uKQzkKwL6SGi1jNsp6rPIRPpYxQOREeAVV+AVUKTAkTuN2bt1tLVLQfarFbMfav5qc/MX//3RmL/YGDd/wY2pmv/A25gBjBcy+iveKiNn8F5QS8z/9G955Qv1wyB7D8o382GaCRg10kXhJiZgRq2N/NrJWBtROxSKJc4MhXbM2KH4khf6gntTPHdVbg2o7izwAWsF8KGuRpSASlB3BW4Yc/Zd8N/qkiDWa1X9VdxFEeWqhqrHWjPcCUVIbFhLPlpMQ/MGQJCoiiBAj9ygSWGcYOl1Fy4FcAsrGk+SydNMIx6yvuekjYS865VSqu9KDXhE14rjWAp5hTAvMnjoTMtMRokA2W0hztccvsmBtwXJH3Q1/4JEgNB0TRyvJeIZVPP6Ji/DUghg/5iaDvxDaEGfHBl5wJGRNw0/Igjy/lEy4qscou7oCT5SepKAAAg9+VH+mMFy6EeHSk/q2QdGbAYZch6pDowx/JN90E1uvB6tTG7/6zG5PzQxuR+oTm68PfLJfZgnt3wYZB9+PCf3rz+Cya1jV53cD5ST+3IuszqJQ3PdNNQx0RHJ+R3PIrTzCe3PPiI5UJqbROlTeea4iYJSAd/SETIDZK3wzae+myPobvptnreJ34iFtTGVTUQm4zPPP8kJHJ70BJ5uSqnax9D2MTlhH1FM+q6QzSlGpcCvVrlmign7An7gNTs/uEJjnkeKTwWu62tYtKov13BCITY9uFrybIG5Oo1Tzzj7pAi41FBiAK1P4ul6AB5fyg3yVKvOu6AeH1IEpoDZ0QM4nkwOvChvWEqBnRtEHvi7rIebwdj/1fETHVjbEHY8gPIzPClRk0L4W2gQ/8l28zpJuOpFB/B4tljNOZC9TeFPiVzM1msf4o0z0243N9bV4U2qLnBSlHtgQ4wTi1RAZ4f0jvyKs1dmTLN/km2juN1JilYlEUKO9pFhMYOadhcd6tDMlT1UhA1nG8bGu5w4MxwOixby7CraHN1CHm4FlHelBoZF3cAGj640Dtw+B5oH+l7224IRITUwkzSjkfwIpNBbGZevYaJS4MyEfBNrjoc1kAd83bDmd173b401X33VyWGNEq8q1lxil/V+fABP+Xz1AHZS1tIJxiqmeva76GYnnYj/KOLTLwS+5+wXHGbrhXV7/5hY4PdASPUpYglw/w+GAog8Il/XuTqYtVp/A/aP+eVufw01MhAiSco20IvCg8VK0Y72svcgBvjXPxjhapUEHwihxY3da13V+etiBqRrE0HSUR556AxgjLXjD+wehtTDl4gTuZtYe29Ch9G+myK+54GMiO/f5K9JmsYfvd7GHxyJVzdDNZWM1XAJk3vO3Vc7l7cg7y7t34dMCR4QoIw9XMZeNC1yt4v8cBm5c1pkd9rnrSmRZYw2vc6jatHmpsgtnofhocdeMMNXN3n8ZEJyEM8YnusSQO8QXkOWYOJprP0FmK7AuCJ+keJfgQF8GQoAo4NkTuGol6CQfrDGZ8Xn+Vejon7APgUPaE7GXrkY9gJK+p/GrKH4gF6FsXRlVV0w7T5AkUiMYrGjl3vqndeK5JCmZjuxmSBPGidsp843azkV5nDReo9rldJlumm/uoWnX3m9woOtKNm0fCcloJjPpgRO1aR4/rQhlaJ80Nrsr0GmNP8lkh86rurxgLzK9CwCaU2QfV4/2OVfnQOqDR4yNAKonfCX99TEbk6ihUBAk2j9kP0g+AUEd0vwfgTPkuCNnoh6EHwIsSTBg4hdRVC9iHUl+CCCCxK8CRkyCR5CMEEQtMYwqAcwA3F98WOYOq5VocbqkqYNnIxtlDGKnwnjncXGL4XTsdGh3XSsHMXGuIKNkcVGT7ERI67YGDlsZDwE9uh4HUAmh4AeRVMRkMdNFPo9h3OhCDJLnAsMzjHIFOcixbkAOBeY+0uTOGdWqaBXBMfFOU9xLkT5x8c5LB5VnPOkNV4V54JvbJwLKjj3e48zzj3RK8WDQALjG1JdRQfZ7ytLYCiEbnuO/8WxKV/84TnBNnYHE5pVFReliqB6ZLQxdmT0NnfIs+GOjN5VOTK6e+yL97kv7nZffKQ8IUr0zrN+fM/Yxx91H9/jPv44gmrbCCcacRlSZQTVQSC9dgjMQkj5GoSkVvX9gVCGULu87jWD0E7Djp0FfO4YxSXf2E1G3OyLijmaPbAf5yXz6uxx4UX5oiCzXiea358v43U3Cu0itAuhLSKHwsIvinfQb5ItYEZbKKL5Fxc96tHCi/ixcGD/gWIVdXPM4n7mMYsev+3HBn2Wurjas586UEmAA2jE9miFliHryFdoth9Ceu/j4VMk8hMV7CtOiCf4fCse5+bb8KB8ux4JUV+grs4gVtayv5P8DZoHsch7wrnOIQxFkzYHKaHFA2vUguuTfIGW++GlUMyDRXDRBENpxSyCUjCcQ6MLkVzcmpUzGwwWTyX0IkKTI05XX5VGrYV6OLOeoQUcZHMNtNrLW33BLfmYqxZvrCpZgd+YIh89T92OXExeMVgv4qL7EEfsu/0Ha4cuuu/8V+YFf0Z69owEtFZKz+dcHxquD8tqnBwsI/YQGHr0flUsnuZbJhnRfAdDpGP0BPo804T37NAW/IkvhjzjJjRoGdDpUqYGOhbEzswyLQDTVta0p2sF+/fxs3wn4cmKiXqsJHateuSvIZJ2PPx5L9+hZ0ms5Qn3cwCrumX0pRl55A7MVMfDRw24Gtfwodx2ysOf8x6+z52XFbM0K5lPpZ3VJFUQUj+6etfGaoMu6vjNoT+2iZFUTlBiRDeYY86IW1YxDLGqxRGKM2pnHdxu75C4P3IHaoW52xjQDtV+Ae91DYPoxezF4r0FdKcKyq/s5cXIHFDHQnmKxOcDOXi+Pqvt0TZM0WX1XZrPCaoI3FLVORQcKlaBRf6L8i2KLz2hOcxU6tqdL5r7omOU7NOOkt3vKNl9CKYO2XyjjjD28Rfcx5qk6ghKBreIApQ54f+lsRN+96Em6Qk/gmlfmoSzS+PIuC/VSK+pY+KMC/diBVBaAZbCTicTgQMGP9F2KQj63NALoh62dvMcWARBwEgmuU8LZqb7xr2IDxtNvpvtK0CunmE4EJlYFFrRc+6HSqIkFEknOl7VjZX60I3QHORUTPOB3dIBUOweKDa3Su5E1kZpo5RUzEr9WrIwaX3QH5QJ0ICOd0AdPJBZDPes9rDugIDz6gyvBwHjolG2p0jGKMY8D9z/hGOJ6QpZO4xCFp6Xm6fFc+zuM/wp3dgidEM8njVxw3TR0I1FSsbpRiR041TCE1qwSgXEq/pyPluhBrOWCOwYmemanNEOOrWMzVQTrydkpY6LEjygPUcDrNJUl7YA0NBb3ytzXsO7zZzvaANpztEBCSt9yDD9M+oYHySVIXGwB/3s9DvsbckMExSu3FjMu7FYHBuLmo5FIsS2jj+FrPqTnxcqNm2M8lMhvM9oAUvhYh4xEH1iZJyel0s/lXyB6k5aoWiEmCs4eWh2kCHrJmaHnSOKr3IuX8waiC4AYqcaaO4QqNXFtHMFUvnCVBj0xmBQZxhcw8jzqPBxkRbwp1BLBGY94GNGCYMG8xPFYhmnWbFuMoKRjAKhXFfGC/HLvfYlw216+1Ljl6OYez5QU1fUyGreRfBW4gvu7oCNJg9ReB1fwiKjHmjdxNUtdiYWO69gOO4mDV/OYaLNsHYBBS5Qp+r1W+0dtGmVZpRJ0mVcaeMqaCNmpXJPXeKPSxrCU2ch75lOgYXjTOL5rigg4kK2clXLr+rhmM0QL/8Af4uVn2mcbtrs3DP8UwrcSWkGkTPUsrjxtir/pHYHgCCIlulkeaKFfsifOEZoi2OE4jE0Aqtirv5fq6QoGWN6wC7i79KeCEOwdNEWipXtkV4K99jjz1YpJqBUBVv+C6PBfwMFYzTXF0fGlOg7hoYsQwPGWRXHd5DeK5vkaTDxNGlTnqYH8PXs/eGMOpvwNAGjrageIGzswtLKJE+ToHDGBjMctKAbt0UH6OXNAQ2wZrQomLRKXQ4Bcj3dUcjQLRNUxCrMEoiVQGXFamtHlVTYIqVEZmohOkHAKAW84B3rFBVu0YRqUZUWrRIPuYoTCmDmCmC1YtitRbwwfVDACbNVo62qLq7MVtcxW2qTzjBbsWG20unM1rxhtn5sjNmSd2W2NCjMFoKpIniV2Rr7+AvuY01SZks+FhWpfNkwWzePMVvuQ01SZgvBtC9NwhbvgJlnUo0yW8uIm2S2AuymwGw1DuhMWkXbpaC8IwRlVZmtDgdkd4YxWcx9WtW13J3G04IZtUlmaxGRi/ZuvGW2fuxkmS3k3JzZmj8hs6XjHunJyfs8PEveKoDJrw1PKq+wYlLjFgcLwA2bTmnbvCx2gHkxV7avWJjYrqV8uzjPHtVil9E8/i7tWeo1RwtqKrWjpGtFSNdCOc04n148MqxX4FgvfrzPY8j0vRH2y5dtWIVqKWmaZMJsbEazwoRxeRsoT1aTumXEdDKazRi2nBVGLHBLmhKqZW0udR3xkrAStXnQrHlavtTcSF1+pvBZmQP7vAP76ijYgbVce6bGZ7BnJn70KjBY0bXSsF2rk+TLn6BaTDSoM4VqqeL4cYkWWJYqxYISbQWALE3JF1QJ32hBLlfZT52HDg0zJbrKgAo+euiNA8wWB5j5CQYU+Ajmy7FSwK5VKXMLzZ+AAV0FNzGPrdaJGVBglGNAA2VAg0xRyTGgVlm2yoAmowwoCI9hQANlQIEtC8CQhRJDQLemwGCSAV2gFEz4/KOZk0AW/CnUFgEzy4AuTmNAR2Zllf0MquxnUGU/A8N+JjRr5uXJcqAKx8050AV7qWSxwoEGFQ40INpsuq6C2181iKnTsQbUdRBf3Hw6AtQdWtHpaDY7i9NmXSbzdHTWRYxvs8A3mXm+zrxodOZtjjkLVS6Blqcx0DE1dU2Tpc9NuXmz9MVY+ri5yksLBizrBwtC/VY346V5Tps2FjnlVFy5GSsdS7PM0mhZabU2Zz1ytzQLjmKt3P4fzoy7fNPEE7NkdStZH3hjkvVbxkQ1N8k7uAdNUu7hZgTtZYyxL253X9zpvngrglayboT4Yx++zX2oSSrELz8MhciW0utYReHWUNpOhJJSot0oRefNUrCeqhy+pYt7uxSzz5SC+U4pjs9KEb267EZoriqknlch9YJ8qzL2Bda1RyeqLAplkBnT3IuK2oHyqrEPXf0D+wtBjHyOUuImHKAWLVMbGddEZp3yK2Pcgf15S0XWd8lm2RdWUYI1vY6ktsbayvPjOpkTWxsTX+0RsXWDheJ5lzKaw4XNJqWgRRg2/dRJrK3Mujcqs16cJrO2q62Uk686EfZWLgXFFtskn5h17doDgnzGdWy761iKHrmLkjwu2yDAjqcaUMuFr8koxp/6D2bWfVaav51S7jNRXvDfDhCNFaqpBZbGlMKKfAd8yxPDCMU0yx3enJFs46mS7ZoB95yVbOeQbOd6Wa6tkm1AXuxx0Aw1VXBViqhxdZZKWXa+w97l6+gYzVIh+/pZlZ9YSdO2UUHzVtQhS0huBM21qqC5R1v5vx4Lmrea67hVQXMvRaIImiPI931a0DmA8S1myhHOt+n4NWT6MGyRUntR3nrkIuVHIUfeJg7WHrUcuUatKXLkeEyOPAcgzGHSQVKaVoR3oOpAB1D1jAMtlYvUhMFL87ZMOCc9bmJBKSfd3FrRpoYh14hctX735zaTHrvtTLul3o/HZcfokzSaScUcyAO3ieaq2xkdat3OtO0SnOgNTarjl3ezN7n5rjs/wzVKvHKNOuyxTFs3TVfdNG2OTdMWxZims5vwSsDRw55B1oM2cLV5XkEgjbP4YxlMTZo5I0tqE2RuhWQmYnBwlVrP+ypCGNA/OylVnFBbA91DOSqRwQwBHVQQZZgNhuNp0FzJPOV2SsFlEtUc95SbUseZp9Gi5gD7OWrpLJ4xxlWEcdKXg3gh83I1hzMNC3dVswdKsR22WDmnpoP/jIN/a5xMivClKaDT84IZaUmFYCgJbArE5sYICbVk0wKc3kqN8pYrzY0LXLZWMQ2YDg6qbQyMbwXbYvgQvQyo5MWjeTndVvKSOvKyPJ28zD5yIcqjkJwsowczj1pyUqPZKZKTGcRNkBe9NTqyOVsS8tJR8rIE1FcmoUZZORQ1Jy+x5CWZJC8ZInkCAe4dmjsZeUm75TkCg5ybEpjZ4xIYJy/BAtRSTdMWCYvQNuKSrpoUNNKSfNbxzRXp0TYgrEhMdPZB1tl0W4bt2tBpiJ/RMjaqsbEvu/IoCVBMs/jT7dqSsA8t0J5tsDjSMTfqO7j7Xt2s1USEUhA/sfnStudycUfFBzqKNSdCaZQilJx2VEiJZsrA/VdEKG1wFHNQZFUBQJuasJcihEt5hkyn2SotYVgcYak5wsLhGW0trZQSFA1nyAvVDOz6ZqwEZUYlKEsO/tmm8AfFR+1qiALcGvFjzkHACE8FCbIpJEkFKNVIoUWzhhbVKlRIadIoEUrGiFBHaaCSogbAV3Pga9AM9gQA3xLAt0Qz7lCq4xBzySFmrLRUZSgzRoZSRc0VB5rZMdCsKmpmSprxV0rofNkDTpeh5LrFjamDbd2sIc68a5meV3e7KpUD6ba4OVeRoRTE2EZzFRlKblkV3QlXQAhiBFwpDB7lgi9N4EizxJGp/Z8b63+T+/8/Hz1PMKs8gcIsE4jNYUrGBIcomA0oGCs4tccn5W4jk0GYRC6j4UxkMxqG+ISglP44MQCYrSDLTXuogLQqF1CrcgFTJ6vjAixiWot2jamTsTNlMi5Rw0zGppl0nclJF8ssrURSJ69h0gHXZOL5OvFqoxNvc6xp6pQzZGnGLQ2Fr+SkpfPLnRW0KMXaBwNfwpcKedUjSkwwacucGZEGtZ3AZCtXZhsl6mlbVWCiaxMEJm2QDDBjqbbDmBDzK/Y8tW3lsrTiDvBXSfher7ISUceuaUA0t0sYOc6P3FF2NjYuS7QNM2G7WaSWH+WM2E4r+NNDbSyZEWWYEXXapqp7MOAwCzKLLWxD+WOdEb5ZpvzKMiVaFp2RNYqZCmxWdXXC9nRydRrTssAI+ZS6pamE9pJdmrZVlia/gu0+Co61hbRcalloOJO8K5gNKxQ7Mp1WBsoNA1bsWIk0Bs8RaR2a2c2HZkWHBpBrURN/Cl4giQDzuER6iVJgbsZd7zAYVk5ApBu+I9JOuKAgdUTaalpUiXQ4Nt1WKVUirRDN1YcUoNV00Jro/1QivQ1aFtmj3ril+FOYtQAxJdJL1JpGpAt/BCkrZNqvkGm/QqZ9JdMd1bE4aRoNAJ6YRq9Sq0qj/SqN9ok2w9pUPdfHo0SuBuw0QoMZpWypUjaMFsVKO5SypcehbMhWynB6V21G2pTEWqmCb72rDkp17f9Z8d4SnqfduSDoqhkG+MHR/UX3AlmBIjPnzq14iNupPjjIA6zLS164uvS8IqBgmH1aLiNBSxta8r92vd5FTv8fz5viUSogz3qW9Z51Ya3HIV9dQAVyCX1BQjidzdBwsb2U3aP3bZ2pir/2vXDaHVb8V95j1QvAepkvYtspmqQX/IqQYy8zcRFneYneFA7g7UfNvqGp3Axxv6YOkdivIrStQ8ydAG0jnjvit8WjUH3iXNozfrmzj+uVabEmsnktodaCNumFA/zoFfPC2w/9c5IvIuTT+xBqoATDWb0l7WHEjMcfwDMEnBN9OG9A2SfUp5+XokFy2Q1pukcLq8abOmn2Sb3P/vxHc2H8U+7CuKuivC+Ol7Hr4k+VWuz1KB3C/WydZz/nOv5d7skr7nq3W4eserkbjTB3u7/L86fdSVCXjHKx/uwav/F8sn6qcoBHDgL0DvgfT7m38Afths/nK4Ges7ySf19e2vYaBG4SCM4fCnQy3IQnji2kfUUoDI07S/7eIr6w9lrkkRkG76tHPTLIDT8ACN3o4xf+ZIKXkmf23B/x9LwPd/AT4WI2gELuXiwFehGlpvmI7+EfMtMIdzhfUDSkFQdvPKcPKbFtprawcUFwGK2KqbHvj1/xJ/9w7EsfuPBKDv+ov+usM95Az7zqxS9mzuDC2gd5wHDds0GNCXdKd79vOJBK9N/zwW5xtttuxb8/vnhIDaoAogcDaneZvu9UVAmNNccDRVL2+22edoyab6fw7YYK4AuBb3ON6R5m226SYPYnGMg8tNdi4UG5SCl9JUK7JHTtr90xRH+v0LKasug0mf5lh0D6clCvkWGpn3BY7mZw10fGhFoUmZ6/5+LhUIck+1M0bh0df57KqAbvKGVUR43I+yMgJWoI7RZJnX7/+JCkQZqlhVgPQq5AKWJjsyKKNhdypy3kPP+YBqvWyO7WKOKc/sdddVKFCs+OSs2Y9hhb8rUT2afRTbAnH8HrhuivedAfLrHhVoYJMkj+jaLFl4v3Cc587GN9MZo2U+JXtncIYA4HlGwMTdzOvcMrc3FHyO357r50g0IdcZ8iZwKuz1GHkTrE+Cf4qb3yPSb9IpiIO/tbVj//mfNWLpasg09ef4jHx6E2ueBVvTL+8F5ywSt7D/kwCkHeJT254Fv7tl72v3SJI57s/5ECQO27sEzIrfQqiC/R2btXH3v0sVtdxt0PBIQwFM+g/9oAnnQ0vIeDD2gQF2a/oMG3Yem5V8NyO+zTGr4L8fdoWK7iflzDn0D4mIY/hfBHNXwYNd2t4Q96BsdVhU6mBQhA3tDG6VJ/CF+cJcF75a6vq2tn2Uoqm77qmthFUC/bKa9wE4rKXH2Ja2oowU8qjWuUVO5/A9ZyQowm8JFHoHcRObEhfBaIA3Li8jpiQA/PZiKsC4LS6rXKkMMzVaqZPuhpJnE1p+TSbFIBABbcq78VNKeG7bTUpwIs5xQOHFxQLsT9JHsjFra8pqCmRvYXNypD9ONv4GVPY7PbkEcpH1JeiwXxzRJnYrPPaA6GwA/rQtnPtGRLji/KPnnjWJa/8Dz/lVi1xdoBBXqJ2z8/kLX7/EA5iPAZF7+2iF5N0Sugq8Cv1736WhjHRHT8aopfocYU/2Pv/GAXSfnVDzwKNv9AHeEjx3e1mUBR8Io8aOlMfkXBsZLSe4Z3bR6k2sDd2NdLdsIH4SswTxiOynu8ouA0ScdHkpTe6vke3zec4pVOrGiSpxZV1N8l78J0nQQLnOT+ppn+7HVlpqDqLC5w6+AdJhjuHcKEqUsofOL3K3vp73mO0z3ILERsColH2IF4U3bgB3ndKRrlyhNPZQhiLF94JLhRW+8DO+t4WX1WTz9Vx7zYCbivIi0Nn/FaSGixGMP2DMLDUI5au+SWW879lZ43aSoLEDNMa3av8lUwWPfnGsRiDWN8yvKG5/uwrag+LXFKI/hXWq/6jH4DJhiY5sOQRcV41SWex4ZjLbvH1f2Fmj0gMB/oQnYfItpublCgkwLjaycFBemffAMboZWY0mBnxS5HP0QRPdAh7CU3hutTjdL+iR941zVeOcVKENUU8DUFvHc6E8gAjz2F2Jj9//WekV2HXYs1OftdiHhG+BrNtasI8SBuICPUd/WKOiZpxOl5Iktadi08HUoBCUkmlFk0uTD++//1ODvnQ7V5U6pVE6zYTaslRM6AF5ij/G4UzSVS87vydirJMaprULNMSr8rbyGpzZ4L1d0VuAE18hgocfOzvxKUQvNzbT6Ajc+LaFobv1t1bPIAk0hffIeA5zH+V/czdgekO1Pd1kwAOk3Prn4maGD2Qobe4Nuafsu5PxKGPvYgzno6OZqm+KqHKVirnZfTPNAqsPdRFE6AuQFDSBNadlNkGCjPsG9/J5NIiM4Cf4FnF4sbAqscyB5QHhvvGYUX1tB0H8s6LM9lX0SqKTKwuljZl1xs9vfyfWTevixvgXn7B3mL5TDzTOWAhVF0ylKH70IwxMJ0WW+jtPFrp8i37x3gS+GPYZNi6MgwXu1mZXDRcCgRsv3QnusK79r8j0pN7sC8HQwwK5XJMHDg6AB7hSsLn3FfGQvfMAq7hUikTm8Kg1G/g6IjRVSaBxb1q5jQyHWZJdBBk0EBTYh0ZYzK9gtjbLqgMVzcOhZKr5SloEWTG7OLhoP0l32YcMOw406Cxb4AyGE3yrXqRrmmG2X40/ZS5WGFTqmW3QhyCECyfwK05N3EEz+vwseAMEw1IB7SKfLWC2/fQz/3xT98zvddfjG54FW9fd8v/z538RC81InbhWaYot12q/D429G27kLdntUxrOxTXIHM2dmaepfk4kL5aZ4/Ok99nad+9jn9FHGaaic8fM8e0Xl7IuNpR18B42l/OdV42tDz/E0sxN3pj5lxU+/ct/tFIK3DYjnwKXBecDXDoWqGm6Zk2K3pQfbmV7nIXUZOo5FV4vcIqdhrHk/zuAF59thbjRwEpV3cv3Z2cZWFHLOL+wu+Vz9Jq5DhD1qjkMjjoeJxo7JFAHmkMygL8aGYpuJn3ZmU/fyIFUh350Eaj5UhQr2u8pgL3i+4L0OCVSlQeSHqhTlKfNHClxJKwDnqt2LtOFRf5DGgypVIDQoJPJCWfcFZmVR+0atKC//mMUgL/3ZCWhhWpYXhSUoLr36s0kJvVFoYWmnhjR6zjdUlGeQKnP09Hn6PWSv6l+8tKS0TUBWpOwv7ZSD7Z/QXtYqFfX/Mwj55YmPfx3+3DTUzGv5832ehIjfjLFg7k101SfeKCHxYTPEriUN7JHQtglRG7jKRvhHiZQ/qigpga8RX1M5oeuGmFOyX3zCdgpUT9perE3ZM2rmAGSgHD1CeVlbBMAS43TINYZT9grk1TKwDFGT/YmnoLi0h0xIWUAKp0VvoeZRCgIU1ReAQBQh3/9DoSQJOKQLXXUd3BbfJhLp6Hx42NEgGPJG9O6vVeoY+W49YgTmCQaavZ9lJ+l8C8Hf+tRUr7rYqQyBrxo4n+I4AX3NpHL4Dix/zJuDIQdmlJtBBfGcqSD8axJ69LOA2xrv3F5Elfor3RexkbmrZFShzYGOgqIF2HCjqKoWj/zbwn3FVVQkhUcc76oHEbslwHUqROyvZHmsFsPGiovl2HFxlr3iPbHKoDvOHB/ZLZJcjU0qHvAFqUcu5VOixtBCau+sU80/2MFDAzsXroNtDEQwYpreWkd/brmZAcla0RpIJFRFXw/oQsR7jxOA/sBnG1oWhmlif/+rspgIRPbOLWMZl7XWNCHki2FqMRcaDl51r/V+7iekV4lXKo0DSpB+93sl5NF7FPKCOdrv6mTgM2EQhxtIdRtihdP4kDh1lwnY4AIOrJvwGHsKyuhxPoP1Wj5gzhyCgKlOIKFK54BUcGHBqhNTs7jdo+w8d8pW4ws7mjag0RhwDCici/FLD60MpCqrjsERLUXE3YkGFH/Qp2sS44v2+2lZ/mea82lhcR2M82EYbdaNx0NN0GEuT/JfzgyBtlcdefezRx25+fIjz7DJP0k+epz2UK9oGVf4nUItBag4/NIpZVg0OmO9s9D0V/apIfN/Hnnrd979l8I8X2z3I3r1DaFho55X91GoUBTRat1/evgtv2v2ZH/6fz3y6Hrj45JcxV7obHLoXW6EIa+ntAOvtgW7BTMlurxDLHgzRN3lGkQiswxVFjMdVRV0UsUDMNARixo/cOy5BSy1BS9XIAQWSSybPCDnkCV75OtavPfu1R3WjyIO5pwVgIsZGWTaCsVOS0cg+q92gSA2kmdjPlLH3VmLvl1gF7Af1LBtZbgxkQmiCctEIl3KtN7fjkCllHVTzldYabZHkDRhz4/Vn7zVFU7NSs/9AAK7nq7IEQ2kq2vexj+LfFy4ecupHkIrV6j13DIWSud3Zj3/y1PvTc2afPhyonBU5YDk1urLHz3r2NcGEGeizZQdfj3AEMCKdqdNGQE0ufwNdeVcAqstvd2NSMVwwqZrPuP3z1x+9+7VfefNXGaHvDGiGyRV+apAk5gk+9tc4M7RhZ/Ksf/eDTH1E4QwFf00aPptdj5q1aPjHmtPDONCReazRc7CEVyyoE5cFJITOej2jmGpL6/ZBUotqTIoqaJ5mKCU06F2Mva9ChaZ5qFIq7EjDiznjnyrRzsyhJ8/qiUc+oEkGfyIZ1RnhcNWQA7eIfG22/4I1sXxRp0VqYVOamuIXBADU4nik9HQbn/Vbl7XR6bsC1qmTG99tTAT9SGWiRQcYnAi72UYlIl6JaV4ccM0BVrO4yMmxGLcri1msIhhBDsTGhIq5kpio5K9N/Hdljzr8emRf9+x93/kveQPldw8w4flHHp11R0lEHNDByeWdgcyWefR6njwcPHiUXYaylc1t8WMmuwFwlc61OQ1YJUWEkLYvoWfoK9jUYb6sOoOmu5kep9juZiPdXXgE3eVxMZ4cbZ8joDs3pKj3uP++HEz7Iv6hmnLDSd/TzYPe3pshn2KdDXmXZmEI0T+Ay+IZA4kzC5T4A+AaTwu0kW8289pqMJin+434GHc5fQfixMK3WLEg3r13AAn4LYjeKL1GVsVJvSMPBf3wpdiszsOPMVW/HUiaNH6VuncYwcaXeJXo0hbqUpc5mwFcf2KbV3bVCJtrpl/9wy/HqXYepvhmHV2hEALNpTx0fg6jIS2vv/mhGNkkPeMHf2EkIj/HdMjHdY2dvJBkr0bvsS4TNamOaNSdvUZn+elQjTCTF2m787oU6Z9lq6s78YDM5pFIqQXK0KbcRG6o4eUsnPdxYR2Jr8lb0rfUZhYYm6hP0NCw1PXyNcEakVAdjzrPZYJn2oGaN1GXzE31ioF3kkYQ+dRBd1+LfjGxZABAcoK0Vfx092NDKAa1U53uHi0AwxfkHn6eiaUSTEcgLNM4oDn6bOigHNCg64npOogOMPxa67aaG6HAmaE6zkHrTt7CPZ7ptxRLdfVBzOhrqq+HZFwautiARD0/fUvo/FocdQbSnVlzUrPmXX1b0LeWWv2WwX6dUgJ54RaaG8xqI1jwDiwiiosxnCLmhEJcgm5wiOT0N4azkiYsowbo4Ll6ar1b1WDOKvduFyGkJpx12uv1mER8UtVlIclerzMy4No4p4oTAphsfgMSJB64LRWsolFv8/F7pxyJaTPPyusoHkFWg8hUVhiLFludwuwmFIRi4/7NJuqNiEr1Eym0+ywVZoh4LtJT7FC6wmOl7flhaY8IhUL33X6zBUB0JEBFBJqd4aelrRTWSAFUcwBSwKEGVBiSrxX9CCpyCRp5uIzsusgf1ciKI6qf9b3Y4sdudyoXUgAZRohTtKTUIQNOeAxf/NB+vsSb3XODkSX00Uw5leNknP/99BvKW1A7i9gIptCQuCpKlPv5leTVarJuZuv9AzKBMKdfIKGGwChW/NC9NKnhI48aykRiULDyXmM9k3nwFv2ya9bGDt5jNS4s5AGzkrmFBjZx2c+8QQdvd+kiCyJxp0dYK8V+qkqIppIRAwq2erAmxf1S+e2YAFIMyhTGMx6ys45i6SVFZBZiAMHb7OOr9WMjFesggAYZ6ZnGZO80I+BVJJKu8UYayVACpCalkdm78HnZqEfaouxX8PmJbAa/+w2TmnRf9kJIN/BndDr97Bd1m6OWw/VglTNPP1TFxOVMyrZW4kG43HmXP/VjXPIKwdNgtVNnKkAYaoCtkuBgkNcpRlqZkNmEWBHRA4SGcE0wPJL7OBnk0CCHA6dQnPkpBahRHXOLcRAM2WeioMlndvXpqq3aZ+u7grsO+6rG5pHa+pKVMlTVCdbqVutf5lxXqU0eoc4oe5OwQ/XpxdYeabEvQbF+WWxiC21ooXJ/tyH+K1IWpeQtPJKire435ZJviuwRMncYSdwWtE0zw3VcArk1n1HjZxklytdBiJ3P4cH+87WxaqBHrLUVAWY8Nw3+iLXr6JSGPOLPxWviAs2R5MwXTX8XxDZtEYvUORBfFnBBib2pWeXECSgtrjltTciBSGQk7n0gmze4DSU+aV8XT4ZSXEJtJOuw6wogcPQAxMje/08B4lRU1N1INMxIBBgVGYkGsjU0G0XCWGkL0fqQJ2QeC7y0u/0rxF8RNFJaeKhiPnYR6OZAJjICRVt34wm2OQE/TGpXU1uSqoUHWqYjZeRTUp42KS/iToConr657iVTXMHqSXe22dEBQGCxKlasgsyhhEyskFHHWgKZGJCJVcQgOK9OCe2U37d3PfubivfXJ+11fHrJiBdYjMQ/Kao4AP7vTw+B8dCl7tm61O3Tt736tsc2M3LN5CJWlWyGHMCR9H2HX3VIxXVQXJUFMPsxwyp8pLYm+bKbEaGrJ+nyGBvWEVGXMPeodlBC+R5NDUVIKC8kLzv1ZScJ85EpxwBMlYXa+BrczdXtMXX+uDQiYT6hiCzwkCDHtDDH+BPIkP2kTPSGxGLlH/FJq65GOTb7GRFpNuW417rH1VOfIhUkpVB95pQ5qKlq62KCPlShfijtMydT/MUtjhnNhHkqMQF93ihHdD37BTPCOuK65nMBd0iVOvdcKVgsrMUfJXhGdM+yUjmz6wecjNFaY9yXo2k5sIl4INSRL1BRc/rPaXtqDCGWD/LEZKOk8q3fUtxERtw08OSFQymEY7rXUJDwQ/l8gIahqzFqrx8xoYn5ismjAFvVMb1VEUtQy8XeprHOdSrV0g1PFEfwh/6MXqSoLrZKTAPrKglClLqRd6vGQFDJar3si2ddHEvowb73/XwnUIAtnJ+Fy/MRKwQJsxnzmaV/Eceg9MBWEpvbMMbAAB+8e9f1dxuRcti/H4IpgETmZKgYiQOg30Sv9foEMExdy6XvjuIGL7yBUd63LjVC68wH6KXbSZgLDUXfWi81U+S8QGMdw80sauYzLT/VTZC5mJxitejI6pBRZsQRmdAtxM1SVt3wZ3KBL8OGfx32gfqda/J5AWADsJrvd55lqvFSEZRQSHNu8671dhSebgvfIs9t3OsYpRk8IKSsA0yJdTrdFDKjeYpqDPqUMm0knxoCjuzNsieSMM2bJTWQ9dSiT1PRB8Y1DU5c/fRSpYa8s2tzPbjVpw68GTeJbdDtfmHepQUsT7N6QN3Eugypn65PtwKEA5UobuFjqI6RHbBeeGZKJhbFLA2HDFXiHPd0nA4Pzet6Rstg2IoVk7LAgvYVLrUkFgMT3Pt89t3Oat+veumlL/jwKRc9DY7cZ0FI5mEpcV6u2zEadDHIXSCjXi8nT2DUGhmWRTMmC9ntMgZzZsj/9uIhKAnjsV5NYxYGhhzzRMQCIhFwMoPDYXlslP7qI7oHddR/4cRFKIkM3U0obOZFz8Qjj8NXI2LtBHejPnbrO2NzNQoMl7sa9VFO4LjPffTWwF2M+qnXu4tRj6RSd1UKhO4tKAWkHM/JC00QSajKzdilpgHy19JnQ4HAE7dbul6HWp0n4b50zvheLHU5dVdjVbZ8OyK19B1eoHRj33/+vk99qvuXL/l/c2QbPdff9+WHP/6yvzr1KxdDXqqcL3O2qEQ2NGCjwGDrrqzGpn1h1ox3kko65eYxR/voYr0DqYR60cYs8UtmTLcckWB2Ak4MOsQDFyTv+W1p8ourykKjJ/V6RRv8SR4ihhd9sCk+eRzCvQUMbeH3dxP/XdZThsAMixBpvbN3RKUMTvnnRaJDoXYeHg2cAjJb20IopvSUQ8lQNfukpy74CHWNfmi6T8zJrf7OF/IEgoeyv/jinue2PaCImWgkqYrj/yw47mX/gid52UOCpWOo+LCi4g3wXxhMnrFbJdvpHDGWRoia9OwxUUeEoR4AK9cVG8RWbjQsvY3W1fi1XJuWUW6YPZ4elCBzU47TSEqjBmSlHbjcw/6Lf85CRQl7FONVTWRxun/Xut+AFxXptNShWKgTRRFdeVapEt8CbSTUVe4uFY/XmW51dkESiRDiuho6F+xLXapSVlWrOqtooarULgNttwxMWXN8rDnDfIZUZoly93KT2neIASXVDZSd6q04XBtQA++dITVlrZkZXQywFChPYm0wtjBV1aV9AmqeVIcBq9vE+X8t/aznNTfTMVsY1THbWToeBg5yWRaRVCMmVv5L9Q3yRIlXw+mf4XvxQdzEEamooP0Wl8Mz9S++uLHqFNAEhXPwXxE+bIgLgriUvUI+q7pkiuTOGbHi+nRnxBep3hZAgUbwQYgR/LwYcUc7rFYgql6hTCNMLWy6YEzpUX+sht7SGx9nZUL1wA16V1Ul/Orrj69K+CN+gIuh8TRpmLtdusaF8y0VOvSzuq0Q2CIl/NkiVml7XYShVmytY4tqkSvu7zwgTklFlh1lXzOSbC6Iv5g97hc3yxcH36BfaETeGM2Yx/J13tQC57TAphh2bPDX19uvXdSrEFWy8LqWYRI8Qiq9uW7aW0+km/YcrmhUqd5erQZ9HgJEZp1HPASdkuhXeB6fLFuQ/p1fXS8cxdZze2x83Ra1VoqGR/fwYH0jbA+hKA3hRqw3ECw+jKZLKkD2CCsBWe6smQ9+Fh+IQBNcYXanvoJSxwS3z7pRwyxPwKAtEP9k+wlmQvSoRDObtYTnlRr0RDaJi2VM8AiLUDfwSgHwHU7a5aIe9Ep04yrHtsjOIX6SCn/h0Z17DApZEo43fH2mr/cMN4u9chb/tJvFnsB7bBYfftwbk0H0xSFr/gSytipd+bkT0JVreBvQz0TC5BU+BLIe6sZCA7QQrrz/RH7t7869foATKxWqP1d1BNXNJu84OITMnGLMWvAyn3v8CA7kIfh6jfbTnw3CxGgITrklpJtuQG5TBgYSQt2CQyAe4I0VnMyxgC8SxGfcyKXtlpIYCKift565Z0Q9vnxCERgKCOp0BxNfbU9bsv+ls8joR7+oQCJ2WamRwffFSKOdNkbFMLHn6QpMquvHeaTor7ZlrgNN9DbEjEfA7/6l6pwZR0/Cd6UWrBtGYWALby+b60Ure/MbuVHv3oO5oV3+eR1aamU/OjUJQGfklFqLGM237lcjw0dwYh0dqlOi86cibz3R2csvoAp39vK40uTfeP0JaPIfBZA2vRzcrxPfrRXTrPzWxURWTHiqFxTo2Ic6gOBeH+rg98FOkahESiSTov0U8RkcpCYiA1JZJFEE5iCGFSd8dmOmd8jE0VLbGB6HFhU/OtQUCVbMiRDh2TOBDn5SitVKS6aMYKS2/mfwY6PUY0uMEYqtAZpUtBlKQzQNRKrGueHfiojf6mifyicjOcnqWB4hb+tYOiHbrOBnBxQlhZZvPpuqvs0ctcG25hl2Z2uFbBeMjuksHODte7L8+3u+PzPU9mZwxpNJJ0yM+CDiRtiYWGzyUqrqfAFGIzCjkd4e1UvFYX6G1wJc3TyxTS8aeG3q3sqyI3jDQNzbKVI87+sUFSOBRy8SW5XljUZxejez728/f/SCHb9z4d59v7bxxviBpT02cL45Tur0w2f1iNnCZ/UGPJopRiBVy6w0UxZWud6Vt0XueLBDSRlZbh/Q2KxXMPfPoGxIribhDW5HbPs/Ytp/90j7Dz99avsXf/Fb//yHFmjvvu/5kQ//w67vWbSB2UfRfrQQ7d+s3fx9o3+Y5SLq4p5LLtIeZFGCOKlIWlihycszbiiCR4M8S9FPgh1HPOah/YP9NkSKmcgV3YkJRaqxbfERWofly5W9ifsRdz19WCarDHDAe6kBV8H7+ViYlb9WMSVwjtp4ZkPOgkCXS5+hOSaopfBuQPOUrLOgjmYF3zgjRgmBfS/8ja/+8su/xDq1fKftvz+a6ymff727nuLES+5+Ct7GLqi8kDkE3YZUVfIF+CJU2c/irhfqh0H2BZRvWAYUUbXr4+tqz7F6yVnuTSb6CPFAq55cXocJs79BYVPvwOhNs82uwXzW94LpN7NFbv53U3nNCOVHIwxt5BjaaJKhdemSCoLxSKoAwA07mz1QMrMAb/ZFfVXa6TtmFrtX7A6Z2jtGNtKMQcnIgt1RMUiIOFVIwUP4OVHvn2Bksdl9EM2iQI9DkF0Pcf1RRrZyAb3PQzV632jd7t4VX7zsrYJuMr66g8bDanUkj+b+0l0nf4MtGLnB5m9yg80fv8EGmzYPjt5ge9vrqzfYDMMdK8MdgeWedo2NT1zi/SIXjoUm4Yyyco0tPN41tph8c1VNporeZkv0EeoDmPT21x/vGtsv6mj8oueH9hBMcUoxLZbTK3U6EeDB7VDbHpEy1Wo5WTiExvehB4BZcqmGWlTXDZNcHM/eofNeK8B3OtahvKLNLD8DBMJSJN1J5aUIrWVtez/8Ehx/7dHh5rF76B/M8VeknDgWdWkoWqEdyN6J2oW+RA7V0r1mn4x9b/bLKsYkFFXeShV4K2dvyZ3gkbQwSd9/8rjWLSVZv/CJn/9EbQquIY9Kqxy6/TzyMv7w4wyHbe8ZwTa3j6JYd1eCct3NUK7/ghdCvePri3i/dlzEey9SH385lXomgOmH6n7y/SfYT/7hKU1w5ivX+XxrKHj5zHXBy6PrSnfsx5zTGOmNdehy+y87U1JTePgI92skS40QfugdLvwFZy1KSlGuMo/7ihJG3gXE7ULzD8blIa5ma4ovZWchULihJp9KNJnKwwip6rFdk89QghxNahD/8UaghQzg3Fr7NXPmMs9SAga8RSkSUpWjztnb3qJjpHdTpLFoQav0IjELpMnw09Sj1z6/Qm5kD/DaZVqKtDbSVBGCJfei5HMj+m2L7B+WtznuO35qmAjZB3SBdLHGAUy/zs2VL1TlHW6h5dwG8mwY/hbVJemO+pZnEM1Cn/hA0RQGZYEbLBfaS2/ltjScTDfl27DIkFXrFBcp7QPYTnEsjweDDVVBRI4trHU8Y09HW9g4qUhcnX1W+4C+Wb2Lhkw+uWGyYHwwLsohErBhSXzMeGI5N8MYQYseVw3gxiahbD/iVjhDD66Zgr06YPI5Ybym42QIs9x4otGE8VA/mAbQRU2buVV96W1Fa/NtDtrbS4OfGW2lVEGND6DrriQN09PYpmZMzXCAxA9gMUuxAWDkyHC61pY8MwQ77D3VBF+mlmRrETykwhXOdkqtQitv4lZRsjopSqiJn7aOJdxnmE2tODTPSZ61PFeFTXEr4az+Ohc1EeVjllMxvyRPRFRNwqBYq+DGGekMiuYOMBDRKt3gilKbM1O6zV3pyKDNwDijhnS3cMjdm8g56yoL9bmzOuVQYPHuh+fFwVlTe9Hi4Z4JVEdKyAP5Byhbw95eQYPmwRD2tMHXXhX08Gc9InbfQxEtGduxRY7InCO5t/BGbuN3In6nZl6wkacg8hTJrNDhsZnVAQLmwfUacTqnfE4TEZMTytIYAiww4LPq6V48dKiFXM1ZfktkS7PfgqlkcMyInXuZ+zHmubqGlbhEXddq3DLEV8vWd6CKHpSGnApLYt4awHoaoCuhXS7y9DLyDBd5Zhl5lgjL8rO5NedwdU/gUXkCj90uJe6G865jSu3GIymeKNY58iU5aQBZehIOJYUO5lvRJ7hehB3yfIk4hsTt15OlmKax1nM2yPsW1hiiLRBRzks3n5THOvnpNIbLLmPWOcZIzADDBXkBsHDNvapwqCU4BU68JMywOY+qerRygImS+pdCeJGj5tcQ2sYfBC9GaDuHfAktc8iTEG6DdcUme5e2C2bmbXlZ1pdMXub0pSMvi/qS0lZ+2aYvvrws6MuqgEfpm486geJFS+Z3RKvaVbwQpXiZJbxSkVNLnoJPQKZZIoosynYIhVBOESNXcYoYO6YCNsCJJuePoG9xLn6eIlkHXnEe57VFt+gpJN+eQhL9Wa0kM5Xo5zvVa2BxilSiFe+QuLu42JHSdpBk2kmItqW1dX7l0gnrPrTItbRzEUcSd5SrqpRW41TJFNFOV5qgFZOUUIkjYcWiLiZK17ig1SuqsfW5vMXZkgdWPpk9Pcz4Xs1PFTHPZxU/Oh+IuYcfvEhewMVeyPi53eDn6VzJGQY/tz9G/LxQse7CEj/nOGqP4GePQxdIaAuHzpfQfImzSYmzjRJnn8rN2yY4u40Si5l4aVjMxMtT9cXHi0XgVdrKLz196crLFn2J5WVeXxbwYmfAYgWb4wlsXqxicxcvdh1bwEtbXnYq0mcGz08xeL4DGHAuIQ8xls7K8zxEXmRRITMzoHgao1aOwNPtfPAVVU+hHTIfkI6AZNrpZkeJuBGdR0/hwORcEUTEz/Fnys6RmZJq9efSRdWZIhmfRk+XyTdtpuCLHZMzpaMz5RTTBzNTduokIG2+mSk0MlN0ilBOdIKZsg2TYpudKdsxU7bThYhkpMNMCVJMjIAdZOMB7wrzmBW41beFZ8WCmRVncoFnmVmx8MhnRVadFVuUUmN10FnB6MgYrbR6i9BvpdW+hOYwA3TOGJn/EsUWtTO8WNTuyMs2R6hjS9x9eVl20yG29LxbwfPuBJ77VTxfreJ5KnhuSTfNGhSfqaC4HS5cjs1JUW2MrCu+nodkwdFPvfO/XFz9w7ADMXbSuYLAF1f/ios4UdBQqxOseQrZ2ClmGMy0sVij6H+KRf8dIwh7npJ24O3YQlErJ52i/xSEvetRI2wsOv4WYReARQu0BZHq27jlA2HBfW83PvDpSSCLFrm2MSKGeY6nkKBFIM4q/MobEswrOWMFQnFJWuEG1hfE8u1q3paXrsWyrfwSWyzDy6rBsgr6dCbQJ62iTyboM0kMJxd9t4JaIqakQ0dvFLIcHZ0cZNXdqIXsNuwCt1l/+9s18kl0Nj35RQX/4FbeK9fUM8KT6MkA0ooUtZTXaDd2F7vpifjIMJipiMjo1DV6gi4sutq2+UrvAYZYW/bD1OY0OHwSXqlr9M/b0/x4qPR2yWylMqhzT2YqLpYTyoxaqLOoGUBjP180zTzlqaZDQDnuP/qYwXhhrKeaDgEhL1muSSY4T8kZeQqZfxr/WC8bO5SDYcaHdNohTf1Nk1mqeOpchMB5SFI/Gk+hp+kOba8WoS/EL5xbXzItQQYYY80BuhjF5FrM1ZqumXeP76N10yQ4IBTYvetmCY5Qo+pm2rmDaRsuSvwjuz1oYDfgHGpWPJhWLmmqR0Hjv7Sr+5pQ9jVd7GswN55A59g90DkSBwmC8YTxKC2T/dLrH6Efg92Vo5i78PHXwXlBv2ImMBGTUkKS/P612PmP2uQjH6KXirFAH0LaF9gScAKChwiVEQ4R5q1xKc60iotkzkFCpIj5UNirVktb6DtKQdKIMDj9VsilM3stg/yKMwqtCQVISIWb1n5dQEFFDztM/yjy2hWxqDud8g30BVN4vHkNvuIaIyc1dz6gBVjeUcZNLGlh9qBqyerlra5eFMn0raVvoZFaGwGhLgFGfZaSiXtGuWfPudyNIzXyLRo0mdjDUY1mZ29+YILn7OVbZ4WPtaZhLv74fHcwb8KRF8hZAt2XFtX5KggioADAO37VWMXe2VccdmavuLkQp3l6vqsKHynEjhxLnf51PwCLtzB6PHJ3C9gfMsmFOOjFpiEealAPJXpEREH2tlcjBeI6iVfngqLeByEddqWqJuHZM9raURtgIso1wyCNvTpsPYk1jFRCcNXauAgAE6T5IsHNUGUk92rQyBaP75poSvgKh6CsW8tPtPyDPnLg6K7IUDrERtThdsgS0SFf+AEU21KpkVbuc8C/tAd8hRmvvG5UepEKabHRkgLI3M0qe1ErlItammgj++RUcxb5xx3VsCcKmd1bp8X29wjFUPoyxU45DkXFZvavguZUVW6/c1OzoKvOKuhXnFXQrGLzc8GZ/Bw15NmqkTbpURPW900Q1m71SL07caK+d5rJx4I/u5rJ6dqjtvuoR09VQouWGEL7cyd/luWPnJuGm5ybeuPnpjDN8NDouemDN1RPsvT8Rk6vwn8ju59fueF451Z/iVTWbA4eyU2k1pSLSK2Re0gQ+r5ELwS1rua3E91B+iQfC3pTLyF9AikU6rmhu4Z0tHoNafM6T95bU/8lL4RY/vH32fShqVecUFf2wddP3nD6sB4kPm/SlrDfB5lUXqFkFKBpqCNdnetgGPLAfEFB1dDwo5ruvz4x3VuV6Y6X4/BRH3n0fJTixej0btnp/b1VYx6PBURFaIAkPghyv+Sz+tVBeIScmkL7Z30/GLHAGUxa4g820bENMrXg42cfVQhaVk5taEhrIHH/uFwDwnwJ9W6ks3Ll89s6r9SJ2i4gu2aTJ0urlh9kH0P5pEnZ7+FF9eEWxmxB14yPJXOPs3IlqIAt3E5pNBcvRayGDOu4eALnnl0xxcLtj6yfu92ji6m79usW04lYgNGgzVOmL6aykoqyFdbG3xlfUTfXeP2rE2i8Yt10tX9HeZ8lKayaz8a+H33mj9yTX5+U5gju/SB5GASna4fhACTLmOzjoMEMufQvTnQv4di/xr2EY4/0XsIfjN5L+MOJewkHM+xAp95BOFp7lHcQPjftDgKqwm7zG+Yuwu9vfhfh306164++QVW7Pn5cDZtP6ML4TrVx4G2u3nVmcGL1rqOdUr+rJnr3atqljjir33XP46ffhetL/aMZlp87jI7XjV8Z0/HixBElLw5lf3JiJa8/fhRKXo+KB/jkY5GlfOqbspTHS5by075fubZD0+y9aUngBiYWmS7VJCH7M1VThejlaAe9gPMmtZ14t7xjkmSfwle4jQQ+5R6Or3iQZbdpxzoVA+Z9EjmjV6qADAwj8pWLhxWbyZHelMkDWwnUgxEzNLVFksC1oesDitbdx4MLEO25xTT33HXE6u7cV4ZCJ1mFocinxZqZqbrVjN4ZMlXjvlemEdstV/dpzhUFJuCfK9C68vIZfSESg5dwUCU0Da8eXu+zrwdDvH7WvKY/4wXq8MfB0+97zgyLWikUWc4EUF+wd90C8HMoTwAYbEzLp6AvYuOEhlXqIXepgDM0V4n6H5JZgpEYuM/vSJ/AfS7bpONVidD6K6xO+rBnLNEHcqHEbJwqndSLMJboSO0jveZ0rKboj0YdZs2iSFs5EhdXP3JyPkxdb4o11w/CveSRojHI/lJg1qSQQPptBKxyQekQRheozr62AJs6o5qTISktsyIk2bqyqRv1s6LASw/7sS5Wm1y168s00K0AppjS637U5/KyT4gkIbwguLy8RQzd+CmW86rm8uqVeLWiiMMVsShGgcrmGfPEPA80/bBw6v00OGqwgFL+VUMMqFthJp/qlWtmFFfurcS6IMQDbirgMOqtZvQ+25seHUSSflKFyEH/MYIkAEgiAUl9c5DUHztI0NYTweQn/cjB5GQhkvazEYikjxIioYFICIjUAREVURuIwLChBUjYb24KkBgACUcBElbuZmEzyI2EJRBh9wGY9ESA+eo0qniU4VGSGGm+D1i7m5rgBo9k9xvuLdLQYAqlw8IRyERF4xJjMGyjCId4z9aLUd9btoqG7ThdjsqqHsdAV9cl6kgRDSubvjs4fog1eegKGS+uxsWtDzC4SljX08s9r9p1f29l9SVvoM1dLzjM9XkTfmh0zde+QKrhi3o6nB56pqe+I4xD8QYvgECICwzLAmGl27Wrk1ZgUu0jv3Ervkv+feJicsErxU+8gerwcRCr3OX5PqMF1eTOqI8n3yD1ZZMkdmLxxwrlXAWMuGKgfZiFVDvuYpwMY1E1JhqjRaxIxd/7l7XN0YZXSYdyk7u2J9Z+PFMQozNjP7/LN6KNgmKeoxd8KeaF8xTlZWFrqcLK6l20cluAAVfIqHsZOzkpzP7WWv31xYoanmAiARVlDIxfMU9SPE1xLskcfwx2/kQuyZQz/pzvea/UzSWd5xNCfFSc4fxZw2qtG2Gx9rJLQzthr1BCZ8HAjYR2w0qh0LBd+tipj7PwQJqnux/8GsvecAlz0M8D3Vjf5IOpPt8/yE98ccjXgg9zSw9rmPPAzZmEOR15UDrS8USaPhF/un+zlD11D/RWrYyzaOW38xOfvM0/n/8kzHE2fhfnP4//NHwnh+/0Qaglr6/fa8Vv1SfSPXC4Gz7slKe3w0es28uGupeNMFaB2T3rjaVQWSUKZCxxK05MPEoyxQhFJIL/7EvVrWtQbl0DvOrmBVtX/q+6dQ2MbdIpV5MOzrqta9gffGXMOp8OHlqBBmdfLnet4Wa71r9/FLvW//NOvX1xMjvdpRbaMCow/IWfx7+/to7G7r8Y0ppLcdCaoejNdnNBZTcnlp48Ne+5wp9/Wl7/SE+AZA93KCN/qrD5wQ5gC16xpkLzG2GzgZ8PsmU/8NAjBppBPtwq4FPdLb9M7orErGAQdapECUY7teeU6DYBaWE1rV5ZnesVKzMUTOzrBhP7ummxirZmD/fE45y8An+zB8cFxW/1PG/62StgU+VbNBaQmhL7hamx91Ziv1LGHnOxah1UYj8ymde1MquR6+ijPs+94Q3jwp2d1QOenRMHPPtPeEP6e14onwXZjW94jPejq4KkV7/hUQiSfu7fQso6eMOklFUnw7/RQfCRNxxPvDpUW+8/fNEMnI3N8V6kJdcHo5en/O7xFUK/3K8VUR5DYNkSx0h1LUMvER47/iVCOOk6ai4RInxXJTzQMM4lpJQUHjRYe51enDdcsOmCyHAsgeqw2MrK2/w09l0BmG4+gwep3Y2z8gzZojVkwXkw3kL7hjZkWFGLWersFwSgWXNBcW5/MU/zGGrZIeULFNk7h4s0ixwRdYj/WL1lHhmWYP9zv2Zedpm7NIsLivM0h4QtlIF5zVesEey+9J/9LdE8LKYJfnaBC8v4mcOoLa31+dXcS1xE9EKZtgVpC0jjolpAYL2XuIFSbZEEF0Z2A3cXb8t6XFAHZdT7gwarOwMo/Nxqgcx6n9y+JZqhcK3YjjuJ1PfyHPqv6ERBKxxggytb1vIdNEtL+xG7kz85JdirHdOSKOKOTceHMKM5wtMZhhE+1OqzmMv+p8rFfjpVLvCdBvUp4YWW6FRzQTISd1F6a0/MyhPJdmKelnBljx/2yl6X5pC8BA3cBcmziEs7emVvkXKal2zzHIYZ12WZefjJaPsBDAK2yaeIBmRX5jHKS0iKglBBjNEvQEmcBYVZvkuetfx0BYWYo5nDiFPEPDRqnFt7uCn2kk9/+Eveww94BhjZGhBP8iS0q5qkRmnmwCfO9QnQov8/e9cR3jYSnWPHlCgvl7KIQpBieQOKYiflXuS1RW/f1GPuR9lp/nJJV3qOPuaoW3rvvd7Sk72l9957z/xv3gADE5Joebu1RZg3BAbEzP9PeT8eJ0BeQBEzISIfGPap+qYbtdlLI/dC/ah1aCNDjAOdbOTe8CXqSuSeAaXyafg/vhqhSeUpKhoHnn4KRjHV+AnUGObXXrLmhHxAM97nXQao+zgO5itwLsRVxOSMqIKHi/vUoILZnILtgX5OPC08rDirRfLBlJo2Ofuff5Bz9gytKUC5gJkplSZ5cKO+vk7/+bdzVKQp0lOd1vfTJoqkmflogPSAP8J/cTGtfdNvANC2AYs0Tj9G3QJH/ORb+1TFeSOa0ix5qj1CTh83kRwIGapAnu44GTweIXQ5QLt256W39UddBOR2qYAsBTekohCNGtrgzAvoW3Zo05lEDblmBHDma3OTrWrAxQHG7mH6o0DB/BJsz9oefD4eFXAA1AhQMz8SBASscsxg14AByViSgN8WrarL83MICFRX9Q2vGjD1TRevCkDJb6+rayaGlH836Lo+4neDbvAyRt0EKnXOX6+rW3jHgXsxdVuXWZGI0dvqpj7vNl3HCHiHS6pIVOE19MmEqMIyuqNAH9a+SCm6TWWiR/MD/cqhauqv1tOFtOim2qZbqpH0VzFpMDUISAKIucm7yAPdJEfYWZjv2M2fzNulJWqpKgc8bquaLvErlKagqlCoPKqhdLN9FXcHfaokaQzWFaTiAXl8nAItIIDRBQFcm0GBJo/kAsLxjLfO+rViPNJoosEi7hn18Rh/Jubc1XhXIGtINiG+dkac/Q+S7d6Ji+jz1b9fjGd8J3P7kclcjSeZIkfEJ/VpclSRU2YWX/33xbhvihwjc2AyV+NppsgB4SRc6RRZAfoq5OHgoV2AVx8uGH8OXwtCZhHNXKWQjyHV+FizL7WXJcqBAkQ5NHFo0japfQ2MxnwHo2IPZ/aIsvGCd9J4QYbcBuIFGWt3GWsbj2JNHz0ekDYBxdjXefuMxIKBIcLP1zUMOxqGdQ3DXhaGvdPBcJtI1UhpOLZVgzqqSXXVAhzx8KpCJeVRQwUaqBG1cLcMFCMHokGSHjjQnVLBjGnxTGA7QquNBbsTCvi4i8xXskDuUxG592hKAyTup7D29+OqPQe4KtKEdpEA9C1wiwAugDpi5AsGFyHPKMKfqQX8yIFSlaaMdMG9hVI1/Q736L7Olat/X6g1pleYSHmAr9LYcGhKk/wihUNZwM94FMgHfHUZwAc4BBThEFn4h4B/KPBP4Y5jiRp8bFCTj01q8bFF2wD5tqUDkQ/gKhwUtXFoUweHDtXp7r6Gaw/k6NE6rlunDRsieA0hgns4vI0uGEBXim7qVBEDtGojDTYQyrpNRHuaCXWQglPrGsFzzYkNzYm7p+cEPc2JDRVqPtQ0F0rUUQ1aV026K7yoUqgKOdzwMVgfwQ3P4YZPBdNtkye8iBxe2Ab1BQcDMpCWfMOyBN8AN2P62z79c/78S37or+7bI3pddLdFzG3sbM0eNdEYInGRizZIHJPNneaMCgMGJKHUhGYDSxfOtd+Pdmlg6DJzgSiPMxJYG6bwidPMeJGFdQVTn0VYC3SPQ7eE+FWB7qqgWzr1U6J8gwg/S9EmBVzWYdWpA6tD67DW6S6suxrsBLDPcfmc9mx44TWsFDoaYgxvpRxsNxnbnUdmDdXWiN7WiO6ZyYYAkxoatkU1wBEdK88hthFeraoafiH1zDwCD68KzlwiwFzCnT+4nbaAcSZgHLk4ky7YbcFB0p1K00n/m2mzKcmYX1y2zdBKkbSSz7XvLzkUbxNh8G2S4paD1aIerB41UHqD2rigTR1zwS26Rnc+L9Z/bDAiFme36A6VH6kyT39vqgJdRzDidbqBi+wclP3eRWV+PA7T5CNWqd8DtReJQ5t4YhMHKzz+qx5mcXSVdh4/0hAwzd7gmcI1CM5kvNTNN0x/pBvwJm3ziaH5MkaoR3dZowLQVCb2IZRkyRXpy9DuoVnrVHQvZ1ufynqtKM1foJqe+2hjTw20UdJcYWMKfxVSDAwcR2Y0q8qo7fORh1yMc3hozWqAAz3DzA7ZuAqPj88wpmE4x1CNxMR8doDPxmTGfj2s2VJg/RosfYGxfgaWHRmPHM15OhzjJDRAcmNYv8+/lL6ixwB+6Au6N+b2joxXxaxV8KGHD2NxNGCZwnjlzD5nTp3F4ZQpQEWksQzU/6mBIVm6GpLYSJ8GuN52UoGGvCrow3mwgBdsmFVuw21gXAPVpD3PqdB4SFY1cYzTgJfYETsIPB7aEAplqaoqAEYyuulbohjy0Dd5suaXGMstqhoPBYrFLVbM4i9K/A+erhUqSPHyaOJTOLH41Lezanw7AsSAkLrEL68HVEQnYe6df9Jny0l7FBg5xTOVlPUEUYh1sfYQqCo7o15SkalX6cstsR7GDe5sELSPy/UWvy8xyxr5LCtlWFYDu2zLLMOyksuy2gvHMoukjxTLGsIywnjReEhNtudkeBBK82okq1qGeFUhnr8k8WTnaGFGFTisJsQLmXg+inWI5y9PvPziT088LznJWyCeLSByCoikAM9+5lwXyXVRSti4wi1ClUXm1ixzQ/6RkDU4z5mieKSG8JbJ+hmJa7JgPushMMCDV2u7dMbjF4rHoC5jQ9h7NmyeMGxWlhk2L6ooQ74en1RhhnFtq+ZL1DTi5zmwUG/E2kCvmkxmm/qOPJcx8+uSyBwl8tELFHgiT4WHmHFzC5WlKwyoRqF2WuP1U9hV+HGpJh5smxtJ7QQQAx6Ds94+Rdpgv76p8PN7RvIK0MZV8kw2HgPPqn3W4uz2+PmlTUULacAwD9icF9m4PI80OOS+FaEGbjj/gi9k0QLf7HECJTJIQg1JAVdMFRfVVV3IFXpZXTZVfME4nqFCauVMV7EV3XZ+5lA9SF+kGBrXPN+fha6Ir0F90AX8lXtD0ISWhcMWy5n4Q+YtInpAw8M06M/joD8qmF0K1aZ5LYkC8Jo2nU0Nhq5WIBC22FmR1wv+end5Pfjg4qIe/LXff6Ie/M+OBvzHTvrdVA9GKaw7HEBsMHqwJC+myeSET4wk/O77Ign/9bKS8O8XjSSMXreJynnPJOEDKwmfScIHHzdJ+N08SfjgTBJ+wSXhA5GE0044NklN3mMk4XdPKwn/9cdEEhZX7tGScCVXUyhixBBJuHJKSfjJM0jCT55LEj7Mk4QPn0sS/p48Sfh7PlBJWLRgUYbPJOGPpCT85JSS8JPnkoQP8yThw+eShL8nTxL+njNJ+AWXhJ98NCThJ6eVhA/zJOHDM0n4TBJ+wSThlfdYEsaSK0g3J/iAJGG4p/Od3HBW5zu5res6dXJ/T1oKqi3j5D54dif376c3RnPkSMIHX2l9i1i0fO25fbNigekBcOLuVuc4AryCLNLmp4j5tewAfyLn9Z3z9Ad9OW8pnzjcGa4fHIsuUMP4wcEQFWVU4xVHNT5I3d+wjnF/yw8PWp8lUK6ZKe7pC7gHqJnn/T6/hPdbSrdOB5ReObF0695Naj7Z5iswt0qzKNWD+fHNAI4O7YPVgyNLM0ux5XWkjwnFzijWEIqlkjFswNdKxgepZAxrQTJeinU+eOGDF7mK8fk8xXh51uWXnsu6uJLDO8BYmBdRekJEbr5lpCv4OtR8/wTfM6KeETXVhIWeL+6gWFlmUDy92ruyqPaef0rtXTlK7T2fVXth56i95xfV3vOJ2nseZXNdLqq9nP2+qb1nau9/mujfov7/Jf1zXSWt8uqfWfzSdX1c0f9n1d61RbX3R05We7/l+1OF95uc9DcibdRelCKSglV7bfJimpQTnk3tzflSG+jI8ctFSPy+TfyaTfyMTXyPTRzaxBObOLiQaMWVRCuuiFasZV+ffNGKV4CTRP4NqZLVisEsiIvkPzQnR+nJNUNenzx8UBeteDPRirkCIQ/6ybamNZCHBWMP0lMVenAkWnHIxEo+q+OzYFErPkSptsj5d8BiDZYV2HRbU1aDVcOIyaqpy09OMr9k0gBF6qYAfT8etM2WLarKbAitYltSPgur0o+UHqFjYPG2+vQup7Y07PfD116II4Loa+7pU52CR+hxdS7vcurzrTy7yylGAFWwupaPXxryMSuRrsp9hmSXU2oKjw70z3y1HK1cjztteSeJDDTBO6WfEx1grO9cRcN1aJNfMYrrEMUqVH2I3K4+ZRv6k6uRy5DMELtEOJ6kiPeNIt5nRXyQ1vYwEcer1HfFcc8VxxuyyylEYujj+iD6OCqYWwC9c8DnhGgdo4+HFJPPp/k67Wt9PKIhle0up5196qFkuDAginv4EyS7nIbyVnuNdzkd8RGyMSrACJWeo4yH5JltTqGwYsOaVBkHzUR8HWU+Im5kjMeejMehPj11NdmdjaKMMj5IlfEq9o+EMt6EBrmVUcYxjPZEGTcUhKcY25xO8NXlMXyZnzBpNdm4MFHGjTWlQCrLM7p3XKOJeaB4RG0rco+dXUhxgkrUbyKb3En3JQUgL6BIvNdAPR5nC+k7BFP9PXM18ZEuQv/5KxbBkZ7x7qgwUTrtmI/GSI+TjVPjoq33fE0c1ZKegYoFfPi5u/vkAyRxAR5l2nE2TEXOiMbZDVM9O99BN1Kyq4xtO0D34E4zeTGk8VjWRBlp/DK1nDGxyXUliBNp3AcR0beEkMabPMf7cWjhQBAyfJshK7C0SyGgLRXHV3igupKOWVfT3Gtp7vU090aae1OSQOs2rWr9+5zZi1J/vTtWSGfwqYIZh9SuFdJ/YT2+i6P+QfZXjJCuREj/tXV1D0L6IV/YR6Xq/7u6zL5S+rw+3UXfcZ9L8kRI38WAtQkhfVOPbyzMbNE9VZLZ9hXl0VWuNp9KaPww2ewPLebs/Wfnwjj49vVMuyNmF7faoi52+dtizCJNOmt9H6kBpm2PkWpgxsipIeZqnIr1V+nor6Cok67uYQyNEbERG6PKBhmjTn1tDIxRZqNtjB6qR7rmsp2lxj73VUUjQIVsjKhOTF6YFI/J5+PM7sJWoxEVjQE5D4XQmIrYy2vHCi0TDXQaLRKTqRjv4c/cnLsSP3B2ePNpTnztDj1wdniL5C7m8pkVYHb4LubWE5O5Es8zxU2IT5rR3CkuMKTGlwblrUw5NsXtIXNkMlfimVNcASzWNroUpzggS2n2CPEwAFMHZO1Q15C1hHl7ibaQuUWbWcX9fqq4MzZfheL+KrD5mj7oMf91XewbGqINgeg15dF1gWjjOSH6hgHeGwlEY531GkN0S6de59SmTr3KqfUEtpUEtm8msH1Lf70Bw3ZAFQtOGG9acMJ4y4ITRizghHxGW8bosLFpjBIb68Zow7AkIAfQpQVAkwvoDgw7LLdhBGzMDO4jgfqOQH0CBOxRwMacanx8gMy3LRQiIUH8Ds1ojMSnWUqUDVh3aMKUwOdI8EkzlyAWukV6QPMjd20d4c/xZJllyFI399+jtzNk4TPfoU9jAuaTZY8mi2SpGrLsyFNYsswMD0bmAYQsI5cswhK8QnACWQbgxcCSpQGyNOgNZGrcWQV+Fwr8Og5Q4NdBDKyENzUx2kKMG7rAm0KM9rMT45JLjE3TX2OMMMTQiNSgNj32pvTiQ8COUzFIYGgDuZNJULLojmBYdFfZGKTddYkawggYFt09NkgY4UC9swD1sgv1ngt1hkJgO3CqCcpDB+W2uQJMhsiALdu5W8g+wOe5G7ei3QGNGe3lbNz6tv6QkWjux7CZk80tLqJeqCOwEQbsWAZMMpB9wP27IDczXBQS4gkDciB7eGrIirYrkG0DR227Kfe61dF3saJomFc1iO6hb7TwGvDOrWM+oh8iQKdHpGFt4NYhogYDqpT0r22zCCJFZTuqB2x0LM762ihZnMHoCc4cAFUXAFR3ARQxgBZ7xMXBPx1HbUfGvYc0X7ZmdXZxuZqVxYvU7AAr2wERMokaJvMe7dL9z4v1H3fn1nt0H5XU5aKUKtBdLJju0iu4yE4qs8q4Zz0jBUkcFngMVoRFNt2hy6J6o+Z7PFrvQvXuGxmgZFRvmalJE+BG4unHdrCobTgOiL0hZYgw0g7iKsS6X9qhQHXbKCNtVE2jkBob/3/Axgxe/mzjmC6dh7R4TiEfHyATIwCcQxD10SrgkR2vJuazX8NnIAWPZXPiYW5uPvsZfLZHGPRQSWkp9kUBfYGxDmBZask8bZHYpgsYmcJ/P72xvIDA/gJvnxWrwwKSccAO/7HUWMjeBHF7Ar9OiBf7/blD58wRZ87SZSAAiHQRaSz49H+o2Ey8UUBjXGc0IE9wWTPe2TaVLM9C6DWyLtanwv/DX8oIYIGMRjUjgRGeRDzrElCV8dvXtKFqMhTJQl4cwdsUAdlpQGDBLOhqhi9curfgtxc/wUml2zq11Zn67UNzqzSLKDR+e988/lN++6r120esZ7wEN4kzB7ZkeRj3WMzuUYn6qZitqJfPnHKGOVV8X7BnGeaUXeZUP3zmnDGnJ8zRBlHvIZVEBDPgrgqZND5VPUOmSMgULEemAHAPLNwjADCyZBIRLECpDpmC5cmUX3oumWJvkU6CUBlH0xNq5OSnRIs9MDckb5FxdVcpq9OaBJ7KK93CN+ovatQ9ImjUPpxHVDrj3wvCP1DOlZ5f4CHMW2YIu6hqGUIRn+Qxa4z0XJIlQCo9d9DP2ckiVoCwiczctCcSQY8CkZ7r1LPSM+q+LL1TSHWqOtJzxJ7iujh/bW4thZVIz/4+1RakZxbHAD2KyLfSs510F91Jt7xqY3WEjrNlvijHt7Aqt0sIT3COG4r0nN0z36LE1Z5vW9f2HV3Kba0933K05/AI7bmVas9NfN3ltWc/X3tuUdPRnv2s9jwV7TkEhWnqaM/NjJ8delvsPa09f/vuyzbS+OWvvKB150/VuvM51p2XiDP+65OV59921OZfctI/kSrPXEoaRnxSnPHjDzTOeOWkOOOVNM4Y6fw445W8OGNUgcQZQ1t9j+KM30WpXOSxccYiHbOO2TQ6ZgsCptM7tOUbk5HMlJLg5FiCkztpcPIWFCHRMUI87bYEJKPb6HFAMnL7Ri67yKEayiZFJ33+MOUmtczqtiYhyS2q5Ycks+p6uqjk7jFRyY0kKrm8dFTySKKSxydHJY+PjkoePU9Ucg1Wjdo5UckTyFa9rPY6gcND9C/GsOZDn4Vm2oYPZ6IjlKd4CnkiCFwBO3EqiD4uP0Y0whdy9YJ2U9qiCtTXikwmqEOSHJvAXPta3BYV7CtxRLjQExE2thfsoA7SCy6kFzD9Mao8FZ08zEFZNgR5hPQoiU4ewxybj3aQ3lk6OnmwGJ1cI6mDEQIuj33YGW6X/3RGna1QYNXZgNYwlBnfFMctlzEjKZusLsTZbl7c8uVM3PLkxLjlSSZuGfazxS1fSXv9q2nutTT3epp7I8296cQ414+SZn9iWWm2/ZQ0yz2oakiMM+JDGqqtz2u40mzFlWY3IM1i+FDEcaT3VCeRZit0lSvNM4pOkPjz0Vype38hfDaje23jVuu0DYVrnWdMSLc4NAqpLmtcSPVZ40KqiW4cKZ7JxTy5i6lvFrU+G01jVGGky10YLWPUqKGNrjHKMKwksIbqWZBmPVlbraV61YhqRq8KRJr1stJs5HpnZc2RlWaL8fRYaXaAP0Pr8t9zXLgeDWlqpNm9p+Uh7ylptpiRZqfWAT/MFDe10uzQKc7Pk2aLVpodONLs6jLSbEWWQ+5rljGoGtO2oWoH89pOGu95rDQ7hzQ7Bza1YgcF6lVd7Gsaov1Emq3QdYFo/zkh+poB3msJRHs66wFDdF2nXuXUhk7NOUUJbFUC29cT2L6Bny9h2HZJWXDCeN2CE8YbFpwwegJOamhDBNiYjQ2r08IgY2zBsCRoOYDuLAC65QI6ZkCLXrVFiSoxM7ivCtR3BOpTIGAg7oMhRXxkxf5NC4WqlWbfsg6DtzPSrEc7NM2XZoUgrjS7R8PjpNmTyDJzyWLY60EQz5CFz3zL6LWDfLIMaLpIljBPmi3mSbOry+hceWTpghddS5Y+yNKn15CpcZeRZslKswRiKF3EhibGlpVmEa0oxNh6dmJccomxYfprjBGGGBqRpJgEfZ0iTjUBO071QAJDGxFr2tSx6K7CsOgO2eim3XWH+pYRMJqWETBawggH6vEC1Msu1NdcqDMUfNuBUyQoDxyUJypnKs0Os527hezeEtLsIEeafdOVZgcGNkN681hpdnqUNIuAaBeye9y/A7nucJEnzeZB9vDUkBXZQSC7BRxt0QYyN4gy0mzfSLMtuoe+0cKrK9JsV6TZFqCzRi2WZpGOdVafAdVJ+tctkWbbVLajus9GbHHWSHXakI01wZkDoHABQDUXQFUGUE6PuDj4+0dJs9OlpNn8mhVpVmq2i9lol1rI1BVygjSLStrmotpLSLPLBi2zWNtCiLIj1qIt1lKxVmK2OmY5K3M3aZSnXN6hxGOlYm2UFc0rrsu7ZptppI0QzeSItf6Cy1uay3TyPMjFQ3F97yETY4INyUI7uS5vXJWGZI3M6DakPSQwPklIFkYWcXmnpdiQLH2BsQ5Wn93lnd44CckqIkCDnbqHEp3lurwlOMt5Czx1eUtElvd8Lm9fXN4RkFoRpEZUMRFPHYo/2Mjj+scy8rgEv4ozK7ZkeRivsVi7Rh1qpGJtm9bymVPOMCcUsShahjlllznhh8+cM+asCXO00aK1h9T5wAOK65/cgOKL9lX/NXylNeEbNRbF2jVqJQHFrdIZ/14Q/oFyrlj7Ag9hleV/PCMlVCuNE24ZsbYji4JUjonRz9nJItaEsKllZqtroimsOXHCax/dOOEYhqx6rFibjRMGzo8WawUly4i1JwQKv5OKtZP3JFD4HZqcJlB4kvG75wcKq/9n703g5Ciu+/Gp7p6enpk9etHuamGF/bqjkBWHtFw6MEg7QoBuCWEZ7FzY4ITPSs4HfDustMJWjGzkRHZ8Yv3NapSEO8H+4L/lU8LxIceXkh/4yiXf5OcLnEvGyP6973tV0z07owMh3yvYqepX16tXVa++9aq6CzI3tf1ff3w+K9n4FtxVzcG4NlrvTa+uMkZva/fktvYk4Krg/u8gfq3cB+3XZo4m/MgO7lhH7hLDxLdKuEGA0YBq9SJ397ve2IwscXM1LsTnPL3a742mnk3okZE0eu98VH2LKRzhnv9Ir/KP53kxLkeHY+BwfFzTT/o0oLGUDqFF9oZquY65Q32E6BJvACk8zcZDNpE6HeqQhg1Uf++Il4sP4P54jh3k7wvvYGKkF0u/4/WW2LgUfNttzZeCq7jcJdn48fSmbC9+HaJqgIaKRLPbs6u1nKQDkTTW9pz52Cji60X38TvR4FXy8MpsJnCwFFR/7BkvV7WSrZqUjw6Aa6rjN+Tu8e60niCNkHvkcjfnFIoJ84ad+SJHibDRAX7i9+DL1c3hEgo2TqAgbJF1j+YS/bntgrCeUSH+CzzqznRERV0JMxsUoTOGGHX8M7SBCqMYF+BUI4faT7kRh5ehPEQLQIsgygBOkIZo7VAv8DZIF9fGubFjGG3i74JBCpOIAYxETyJ2qSgCRzflmleplLX8bcb4TviU61dabR9dRm9iB2kuuioarZcdT/pYLPz7hP1pdozr+NqhfRgtDHhBZ4u3i1wwEBLjmp9DyDHzwC/i3vUd7e5dDxcf/fr1YEMabkh8Zi2UDk7cJLnr14OjXb8eMkmvWJc77NGBEE+cQByExW886vXrb9Lr1283GH5oAulAJe2DkRuFJS4Zyp05RDYBfEX4Qv6J34I8wL52P3ZK8Vt1vNvsRHnhsSSP4K90WadPJRAgf6Z0V+WBy47ssIbs2HMVa6zawYLq97RU+9CP+Ip9ZFdChEB64ZGZezsYkfv+pdiCXu0/wnkSDt9A8b9NWs4QMm0oIESWPiq10KToPsJsVH2hZNBWvRdUjjJaA/RZnTO4oL+UgjDiQAzIYEpF0+HBw0NqOPNGgdVhKUU4it+cUyipEb0Kf0emQzlBd6F26BYWT/zTW6RdU6Qw2rfzEyZKVoE2Kd7oKSpenen+FA3E/RHMQfjmBTqKIplFQYvJtzSiYJn6ZiY8YmU+L9YSpuEBMzGbeHmLgF3/T9KQAQ9xQzJhw2DKzboM5UKFXJ6EjAqqNzjmfZntFX8G8Ae6RCs2BgiLGwSmw++r4vNknEHxYair2I2Oqqbmrl6BOsYqMuAGRAwQ35WEDOCz2o6ZUsmBZHs447Dq13tK0/ikmcd//nh0c2TVVBomJa7mlkBOmEWNqctf4MdWzOwYwV4YmeUGVoofxpyU+FQAQhutjd0EzU6adoCF6uUl7PloWZWwBwkHkLBHgUrYsxLWImdyWWwxD8nbiK9ffEkKqjDxglFpypi7GlM4NmN8Szr8apBQfTyKUuCVLh9Ug1vQ8woA5N38F9sZFXHmc3qK43fZ0VrF+I0BxFVP9kDQUe2//FHMRhenp+AMS2hLm2bVJ2fJWAeID2o0vkPy8vU7I94o5MEuZhKP6yRaP9B+HNUe5Yx76JSNtpK9TPoXJp1SK7p69zHpAEj2uZ+fP5Z7no5Rj8VghqZlwuphTrFK3JOcmgvBAXD+G8TuAdgbRH3wfSvtonhnsRYAbkfpDLDNJFjmzYvT0xWGo2LY0cKAq8dfFBZm0HRXVfInOPDU+u7U19trehoXAZyG+qMc+dhSQKcL2vewv2uztrLZsxsl844cZkcehJhSlg1uSIpOiD1k5We4uMTQaTSAwyj2fbpTEEbGVnri4rrM1cI5Ggr9wRu1jdXNTOeWJOTXpdIoJiAP+XmNzcRTUBO5t+QZUl8YcOAMiiTlGO9pctr9NJUp8/tMYuf02uYkdKXSoA4FNpZUUJIcTzodfpwuIqLDHa/Z/6kXDf/hNxY5lwOcup9/qXNx5ClpkP/euSATyCO8BvrRXufq4SeSkGtPe/6DBz7s3CzkJTf6s19/6u4POldD0pRS4cyVdXCvc5Uvqw2cK5kRcRjZf8j74fnbPvIfT9z1YedK0o+9+8EPv+v7yULnclKh379u55Y1m9/0Eec6+o6+T586YZ5Y6FxHf8WVD/VvfOg5e53r6CvX499fL3Iu6FonNvZT2sLk2COff95FX/7mJc6VTL6z86zXf+ubz/uIc13mm37y7qu/fvonFzrX0R95/kPM3Jl7nevof3Mo7unpuWWRcx19mTD38b3OVboKntvX2IHr3HTm4dWtcz+3zhdM+tuH16VntAn8HToDZ+USmnn4c1yiZ+leLktCBofX2Ys4MCZHbQdN2c6BjPmMEqWaTZv4tRjDMoATUIiPHoe1LtkQGBTFO0inYSydpmOzatWCDqYhqojOlalZ75Flq6F8xEfH11k1tbWd44/gboRamWPMpjPpHDnnOadmMPRgu1RNj1PGHp/NdSMWt4zwQVQegrxtjiQNBcgag+8iENIzNC2soHJw3JNPwXl6SJYsociENLBjljA9ydemcwcPIYjUc7aD02EUYaHI5HA6dSYMB0APRSZhk76q0mwaQOVTrzFhAY+TJ18Z7LKPMNLSM5Ev8mT1gvzO5nzYaHgODGvnUM8yK+LpjXVwhEl1v08eZxxPYIZHeH9z+MOTw/uaww9ODu9tDv9uUzjTps31tEncsr5D2hnyJgOFjAeDvxWDsAzVrR7uHanLXLtnQgkjLxyZELXcjf7VTTHEJt2FFDM0FtzVPv7JYHoh/orw8ox2VAB7oFfFui1rNjJYIDNlNN6pi+FsyTlqvPaWDNTVWS0yUwajlobh4kcg6mJnSBGugL6zyc9El7drcIQcp3/n+2Y8HDPjskpKfDJnyegz+LNCTIIlO19W2HbxN+ZtTopLbn8H/t29CBjZH5H4WO3rgqaeRks++xn8i0auwzHKML4XIUmZfIp0bo/f8gZQIqyYJhrYj8Lb43cgYNeSV7982Q0f/e2LL6nv1qgUUJnbb9cEhbvd2vW6Qe76oWXm8UX1NLQ5HVp0nUV9xSd9RpDowR6EMzOtkEeVZYwMBS3vyZnoouOsYD0tNVcvorBOgatlnStZyldyl6vfpSPMPIUTT4n/7JA218SM6jJqgwe8TQYbL1gJyt+fpAx508IGR1mWeoN7rNnyVO77Zs/uJBBQ55HPQ10WFfE7waIs6/jhjfrAXgpu50jessETWxjufqoLw2c1FoZRauyadUPtlTdt4Fg/gzXiRS3GOSxDjmEGVavc9pNpGEKh7DfxnQ0LUG04bxm66xiWof/1mBvkJ4WqnFhw3stWdBYcOUiLBLsMU1cJlR91dRniMJHPc4aAVuM+5xdg9yRQZWDIxxLZlwmGechM0UWLdU3zVwDzqa3dWXsyTCK55IEa5VtK1VxakgdIzp743dZs4EsDqxSzym+A9etlXGGf+M8at2Adf1KNW/Edr7N22yAJGsy0rX57DuLP3Sq96VbjmZvNZvLkTQ+fLdZ+jETtBkreAh7M82N2fACcSSZvHyZv9Q3N84Y0dCaWrTmLtz+gzpASZ1Y/b0x0nLbB4Rc52+AX7nnkTAyNu9VaZk2Eug5ijZzZCpHGRy+JYEYVc+EjnJalf88j9/SJsbAU39NkKdS+DPFzV7aGvvhe7ccoBo/35Wx4XpMNr3U4n5ACur9FAQ1vzBQQHiYpoA08jmQ46hhyw5kMO1AJG2prXyTJ/Phvkbcb5AWYdiOY7ZigdjlfKqQ2TKOmDnECdZqtYH93PFYwu0uEVmtWaMPH3iXS1kBbJPzIzqRdogcQjqyewi7RWqjHB9ruEi22jGCu1c0S0IeaMR6CB3LBM/LB1XORRV4itpGMi8MU3RCyFtVjqfP2/Ko6n3ukwrL9nHYl1jSZzjIGjfJeN5S0F5n4fSCo3dV2cikdZhDOqaWb7wuqrMk3m3HDf3B9/itudq9s1nYYNtzbycZHfh21oOY0Pt5U85BzWpzlF9KQ2InS0pWDSUQBTNTyXL4TtpvK4puotCmpshNuSjpEZui6nYS0SRecOOmGM5DEOEAtUgzn+dsMu9V5/ha4HfP8V7JTmuffqM4NSrxW41yjSdbq01ING9GY8zVsWIlDGoWUOKBReJZcjF4bsxlLX++aBaQ+lp6yKZ3GIfy3nl/VpC5iQu/imPjvqsG097mdBUl3oDBKmiYeS/s2pf1M7UcaKpM8xvzIKTg+dVIfU3lXe2zzGCQ0amemCnu4IDPG5fRehU5jz++qQV9NrqigLxP7s6XHwB40nSl3o6Ew7/vCDSZ+KE2lRhk1IACF6VpVH3uVH5B+ilbjH6RiH5q2tuVBvAZqmyv+oB3XO4wqzibcY5rVROBwzxmFLJcCMre5IX/Z1vzEbccV7ZMS7S1fMj3P5MuMK+MeDMA3F6X3BnypcfnmkJ+9Td7m4njTK8f75rS+crz9wa2NV44xvLbgWd8j1iAZe9vgrepQna+fCt5y5mgSsbuP3TKeZ2VvGBvx6pZe0pEFdmaBXRrYnQXGWWCPBp6SBU7LAns1sC8L7M8Cp2vgQBZ4ahZ4mgYOZoEzssDTNfAZqNJZalp+JvznqJ/gn6X+xMaBcSG1ceD/LQYkvQkjBnw497d5iZecIe2PF8b09SC8DgcJs0i3wtHZRlr5d0bhnp3y5WVsVeS57kzWGsQ/IpfyaPwhnawaWaRnwSvZpGdD66K/SAOR2SidZQi/yTku/2S2faXpTNnLgGaaU3vpaJfvmYKpgjqQzIJzthzGnoPlPCXDVMSwOhcBW7zkPLhbveT8tmezL8DhrVlUIngmnGeH82yZRQWnEEXFpRcuHv+zsXQuHgr4idN5QplPc2n+VYMcciHNwx/7LyR+umowWUDnw8Z0Ec3mRIu7x5Jn0XluLTlj3wQ3wcU0nB0ZOXf3biZdQnOy9RgIC52FmA1QWGTvasph0WIBuMn8xYVkrttZsOI7C2xeeGc6goFw4WKA3O7XJPNAL7w/HV5y3g+efMerXv2VRXXOpwZqlFxIw/ywmIZpGNRL7UcyS3Qp123W/WPvP9zbLE1rdk0voAsapqgt5eyV7rKcSptNs7lt7oAdJf+SjHZPmgXdPZuptIguwQsVnINmli5pc8/eZRzQapNOL0f8K/RFaJnZIBn8+8aHxsfm+ZFSC83Ugo4Kmj1KS+iKVpN2uhSFPc6M0BL4WkzO6TJnfruAahyRFrMgOpxknWtF0zHx0e/8ZMXSBxc4F8T/ZK7pCo6RcGUPfOCh3h/d985Fzk0uqEX2qwEHYEMSmyAtgbDBVnKBk+fb1er3TBI5XkwL6QqN1KF96cuLnKtGXm0ziJIuV0GjDu1F1F6cBKFdwLxYEaELILuGQGbBFDuLRsQUO9e29QimTl4rcjE6TtYPJhw2y993Fj/PJ/7jkTNfRne6XN48Ph8PM2WOKaQrhLSSO9iqRgdbJXe8nmebchV602o1ni6hFcls24dXaj+bI2ZTluuWIgRrZUmzqSgBzLwIdYuejujWmyhoDldVKjUbunc2Z9WFl6tRRXweWSIhDXNB5ApHwbQ8mY0LmH/Gha8C5FhFI3ZUgZPlXPwaLkPlvkbxESDcbO4l6itCsts8zkR0Jc7RNj6aMQtvnotFnIr4TVZYaa8Raa/m3Ff6I2gHnXCc5ZtWyI3Tq6UdIIgtqBOiMLP2SuqiSOQiWsl8bIQVXUmzrKo4XJDhNMdKpfnjB9nRVM6sqJeEoInPo3LCPKP+50v9z7dCqXUhMjO0Egxp+Tl+5nDB51FRmUXbON3VzAx4g/eozMxxzMzJmFmpr+GvRGNxfbPDpcs5R5ppy0HWVofSbMzROYIdsCiy+WzpcvZwO9Ma1HONbfxn0YKrO9mQgDfotUdKK81WLAGJYTTofI6JAD8RXThGs+MPY+Jm3rlrsbZO+boVOMN0Lg1fP0h8SnrQKXD0PjhcR5Q9u3FjCxg6jy4EHOa5cJ2+c3n0wQ+9ov/Gk/lgf32nqWLoKP9oIOVdhtBoeh5Ek3D3YCZGABUI8xtH4pGDIFx3xF7dUWH+xpk/geXn2VE0B6NoDucWThpFVUBpFogWjIegZxsQKJhjOp8VTPnNbanqObxJnQzbplT2irKL7O1OWV7EUmPD7TCklbUYvvC9gKU9986Ux/Aozb8znb2q06Mz5WzobF1VYORt4NBkNgopJMNcgH5uIcs4HXYtkVVRRV08pxAn53kjXMsKFynjg8Xz6wGaep82aOo9OmiaAk1ToGkKNE2BpinQVPkFg6ZoCjS1Dv4p0FQ5KmiqnBho8kZ+vWBSPAWTpmDSFEyagklTMOlnDZOiKZg0BZN+Y2AS/uMq/ulT2Yp7s4VLbz8SXLrCgaMrTio4Co8Kji5pBUcLJ4OjRe3Bkc1h7UkCR4vz4OhSB44uboCji38u4GgtLTw2OLq8PThaiviXPR1wdFkbcLTsWOColoGjxQBHl54AOLqMiz6p4OgShpmXHQc4gihp6dMER8uawVHtZIAj7kCrtfvosOWTFz2YeZb72rWXo0vnMNNsC6O0NVejQ63MQZSnBU90Jm2FKC3KVRGdY4Xo5HGQHE/pOuEXMRNiwkdP4BB7UJRj0qhmaymZbg0wvbnP/OWlWqwdNDKly1uEq+x4Xs1KbZKsVyBTnOJAXYsWcqzU73XMAruraBbXzsuwB2r9LVdrD58GlVrTqBSKSkNertIWdQRSuzkOAhG4gMxbGCX6BXCUgYPVQAyrFa1w8IoGRF1xRIi6UyEq5qc5dhIati5ZN7ZuA7iGAlzRGMulaZB/2B64WsS7vAFcPcaCZY+eFm71CpMv4wYKaIdbowZu5Qhtcat3FNyqvB4bt7ZnpgW3RhluDSfhVoFFEGMxY4dTGYxfsMKXC6L0DLqiw/AD2Qe9wFrbCAUyDkMH4QKfkXCToYQVqPmKk4pkz+SheiUV4ayjK2ndHwzSOkay2TF3AIc2SJZODpC1zDow6wbbLAWx7QHsd9zgasavs5pHF+p3OseYwZlrBD+PXv2njF7x+Z5W+Bqgr1ALeo0cevXbodfoBNBrAPSqX5I4T1rhVxG5Fk4WcgVideh1CrlOIdcp5DqFXKeQ6xRy/ZVArsFvDHIdODHkOoVcp3OM/l8v5HpO4ZTfVNAanRBonQKtU6B1CrROgdYp0DoFWqdAa/BzA619JwZap0BrL14j/4WA1vCooDU8UdDKgg9/iS2tV00Grc9uAq2sUltQK2hNsBWUo+FWBAO4zrfAdYEDrgCzDrjOs8AV/f7BdN2ln5328MI3c8IGUl3HD5dyT18H6sXoLNp1k9kNxDrn/rEHD09zgtsC1DbC/+PiimzEtkWss2RYvdGOocmIdQ6mkfNG83gVWQFGtV7QdjkHgDyyIv+XLkV84FWHQc9rYNCRT+f/9OrDbyoGRVaoSf4vrVm9Zysx21YA3xxg+f7NzaNzJ1cDYPWbFqxCsPk/K5WOaxfXO/N/IH5bweq3BKw+/tiNl+T/WEGfbcHqY08ArEJr67wK/jHilYfP6MmcFFW2UBVROv65+1ML83+qTrWxIEWCzCxU/S0kBvy00kF7IkpDFvuOQxgHlBGLqeaAOMcC1tIF3r6zkrlVmu8UIuah2tjoBaxmn7U+WUMLaO5VyXq71pKuOi9bY+VgyfkWlqxshVarbBBm7OWN7re8FjbOVuLJA8CCLBnMmMaUvCoHZlafAJg57+jwSqcHFrMW3YSjzs8VvfLkF70c09TytvDJy+BTOgWffnPg0ylt4dOz6apfMvgEln72mKiHY8QNTAQgtobXzFBIxChtwc8LJc23KGnBSUdJdiifZ0HQ+XAH0MkkJwVK52bQqSjHL33m7fhR0hx0hTk5lIQHlvLxoqTzFCXNwhX/I3SmDMw1OdB0vgNNh/Za0FScBJAW0rkZjBrePRk0rcyDpsLxg6b1v/ygadHTBU1ToGnhLxloWt8eNK1vBk3PUdB0tQVN65tBE7fE+Y3udL5OIszy+Y1LtpJ1ttX16cqaaZi7mOcGJFnTgCRQ51RkxZnOGYQt6DggypbJEKUWQOtiDpQZGHPA+bTeYpNrGtjkmp8RNnGvgFzD8kifC3RikuVHRCgrJiGU+IgIhSfuF//sEYr/C0Uoy0Hj7OXdpeV5iPLck4xPuh0+uQb1vobW/2rjk/WCT9afKD7p4hidTfjkOQ6fXP3zxifBUfFJcEL4BNINMPv/3NDGsWHGY1MwYwpmTMGMKZjx9EwgeZixogEzis0wg8NW6duUditwNfuOC3Ag1knGHEpf5eirQPvFQY4Vecix4mcJOTqmIEeuAaoco/LLBjm8kwU5/Oqv5Dul0W/syfypQ05Th5ymDjlNHXKaOuQ0tUsX/saczB+cOuR0Yuj1NI5x6i/2ZL45WSfzveqvyVUEA0/7c3EDR/9c3NTn4qY+Fzf1ubipz8VNfS6u4xf8ubjK1OfiWgf/1OfiOhw4KrQDRx1PGRyB/zPkyvkzaAitMiTXPS2TgNBeRPb+chFX2YXj4ebAXf8VyM2gW3rk+i8bUS6wM2inEpwoja5My4O4ORVlVtjZ8hDLF+3UQV7S6QNvdKRdKLdDL1AN5T45dqJ5PqkzQCFfbRdtSrtxxRz8pU1pjHvmQmInZodDInUOxUp9LNbEj8aa5UFL/5KNfsDS98eLudDavniUOqDsAnQzKjAGGkt7uEgO7Zar6bpBLBDT4sUxxXI7Xay304XUSDXQfKEdSFE6relOO05DPm6nox7qbtxQF9A0eJI+ubq0D4RujIduiq+y93SX9cPHPEjjxd1JD1WSMlWTfgiR+el6Dudb5mQ9STf1u3y4/dHmAeTPjzI0+jjncc557WXImLPdxsQy9TCRc+2Xx36KUTpXc51E8qirVmU2p1PXOYXP/JgxhV49jMcP4bEGfUbTKWAmKYw/opdQAhxqj0hKFCbTcaUnYqQBwGWI+IPJdO4O/Rw6QJ1JmdXOIc6bBlADuccvGNVKMPcRmA9wfS3/yNAYQI04ZVncMnP/mFmWBOzGqEQA5rWhD9kOcdC66Aig74uz7oVe4/qX7Tqx7SocuN+6eyz9AZvTXTanCUt/u423w9K32Xhb5A5E3OrOna3rqXY2dBv0JttZm3tcFk36HgjsxJJX79XcZ7qpe1MSc5/r3ZRE3NWo98402IAOhzu8AzDTz3JEc35Mm/MmNICUqP2UThlLStxgMXVT3+CdmNxtF4ikk3A2JenKFNg76NHYZbTzQCOE+kepjLAqxehusXbyrLolrkcJ9UCnb+4/VeqE5JJOqohboaq4VdKLM0sk2iYNBDkWrer6bICr0Bu3FvIW7obUhjHrKICXWGlI4WaruNzjGHnMg0zppc1M8Z/baagIRodTbswR9c9Py1BX4h9KK1BK4qe0CmVV5NTl5/JP5eqbLir8jjxHeK7i+QzyKOT1YBqNxXtlFq1olbk0crSUWxw8lZEVlbiFyxRRmeFumUKqQHwR+hdPipGdvzrYHWZBscM39LF2TbqZ3w7q0KtEbXTG6IvHk1DHsB2/ZerUOJw3lxCyzCkEmO9Gh4g5w/ma/ZBmfwayL+CufZY551SEREI4Q2m0njNk30hahjOcVoSweFyFVKEIf+ADcpIiUS0WbXVSPbgCXdByylxk68GtA3nKGg1MMneo2iaWCM8ZNdxnqJNdvA9yrFIX6tDdXAdmvou6Bf6S0fX2VRxY4ky4t3eI+sC+v7uS81+Mr5e52u60xWxIAzK4OjUgD5elinMNgQgVzMPQ25QWcakq/GZTyqzewMHsrGWHQ5aqM1+Jw5rDkOZAShzQKLESI42C8xslj8uAsMjHGPZzWoHRHERk8BhBewTUCI6bgwtXYXiVqv/omfJ4y/W0KCeodQtm8ZIQpbIPa2BMXBE/sw4R/VuhYlLlMLRtlctj3G8GoSlwhqJSC3TQjmPMljHnl2uBmmqZ4CcRp4ySMj9V2GfzpArWHFRFWXYeKGMeKEt+acWaBCKYtLhQ5Fpt5FqhMClrXlThAF4XxHxPd8wE+AvsL9ipA/kR8rOnIEJZMbL+xp1gZXb4iQcggjyU5XG3GNPb0RHB3TGOCE13uF5gzGZuI561gRXGceP5B+54MpQ78c1mKqy/fxP8GMZKuPr+seqOk3klvY+ODZwEX6PWPsPSxG9cS/9Qdi29XyUOnnQt/Yc9UzrOS8kHGpeS38s3ixfAgr2NPLuEfMBeQl7CCJZLyO9BXPLlMnK5hdzDyP1o00XkGfMU2ioVURG5lLwIHjJG5H78G15UG9jI1WQ+Q0xEPkaTTj+elR/SdSC9+KK0NNfmwPx6evN3UW7+ZidEPHECOBIW/33u5vNS883n3dX4Y7ed+JXnH2+58nwgf+X5QMuV5yNSijaJIQMPi4GT3UhmA4R09GvJW29q1wuItR2bLyAecPeUv9rIVd0QWayojrsRtAy06abFwWvxFI3hMdqkUNedOyskHvsMtAq6phiJMb49mdblZm2uoRqI9fpvdBDi9qSidDAK9Hbz15w0HqBimlmIwMK+QhMP/NzKxAeN54/7Y07EGEqpb1m63I4B5Cjy52JQvDviyJ0t80Kl+1wSIhZq45wWo9zqv5TRSJ2VtcTpaB8H8KWOudvI6Aon7iBfIlJh4576RFpEDX3YBHzH/HoVYOEy6Ya+swjzxBuoXAMHEfAQYXgEVXhRVwyr+B9EgbAfQvE11690Rt64GeOl45jcgn5z4+7zCX/S3efbfHa5G2+Hy5kOkVGAjPoUG8J5fhpeVLgVcWA3GsVo3WfwhPpF9t7jrR5+t3gMb1+Oa4t9zD8f42jYpMTuQsTXKI/W9ghIJX9xQa465+BHC5ioNB758Ue3WaM4+Wf5N6Rl4WLL1tm1F7KYHJvKYXmBv4NzAIJZ8uVNX/nvAz/8yEXXsf+N3tDZZ95Gl13/4hdj1RNdVNhrsO8wkJY51FmDJ9i3xfCfGO39QuHGhRQNppX6LhRq/72wk2vAiW5/B/59eVGdypQTzCCa9QEri5mqAwKdL6ob0why8CCH+4xWlKr3U3B/47b5mSrvqgAEfh4m8cZfeR1gaYBszwL8ALJlILkZviHxjX3gjjrqf63mVYVsqXqWf028batCWp+amql0zGbaz+IvNbURMbKwNX//onpdmyj+ZzC3GxW/Ri8ef+y9jYvHd9iLxj8mhwMLaORHJbStFva/JGG4olwzqWqGe/5/l6FmsQ3P7bJIOzmTQy6Tud6ERnRWqkOLeFmoJOKY3l/Br8WhCHsj+g54oesN2pY8rUT8aQwt3Mv9ZjzukY1NA3uA9gb8Y5kgwg6JwB0n7Voifeazn61dh87a1eht8UgdwqxPULSnbmkzR+rXJQb33zM/V9ekGhRoi3uNTjYwUq8x6SBC62j/CD+Fze+34ReP1CeWnHPpjO98be5piyTqxBdu2cbtk3V0yrzXDzboO0Yo8143+KSXGgCapYPEbq2wfDD+19epouDB/xzyIbX17BTksv68iJfqaB5RZ746w3qv/6OGXU7yDbh+7Vafe9t/qX8+ex9T7zB7v6ve+wz7D6p/HzTDv6j/AdC/pP79oD+s/kfgP6D+L8L/GfXvQEn71b/XoI+r/wDi7FN1kJSVuQ4J2YYUZ4v3ICINZWXNbHBJDdZnZCwOiPdL8PaKdzuyirPyoozVQLxfUJ1Xbmi9z8hCtCwXx2Pe2O6nYh7gQB7lBdCHCTHP4iUdKNCP57BS1ulBdfdorsl3c5yqRtprNFJ0mYsZ2DkLAhhi5ZRgxQ12CkADdTkvUwC05kQwWEa6G80TSANj1aL4DYArSUGFTeX466x58PSW2xjMKDW+HXFU9yHkVsCcdwrNUuOvaQyWwZ8r/KnFmjNV4i9snRT2OWOCxiLQ3+AsoBQ2zUzhEWeml7HKS8sNpRe2nZtCaE44nMFAWqpBMCU8zLh8UJMGFCJVAb3DpSpqbkjGahjABkmWkrGypiD+oFQrZM4dwF9qDGMXN/GTiT8r6NMnTDzII/4cCJ05qfhWKoaMkwr51a8EASZ9w1goW8EYLcVCIwEONYOO1+gnAtILCjS0c0ToFj73HA3ocAjE6idjteMPoBtSEWwvp4A7wG4dnhnsiR/TKQzPMQUXFcCwh1FjajNG48cRqlnqBEXMW/z52xrU+D8lfdE+/Zc8+fbpv+UpZNgOfacTjNPDqQfvQfFioRGsGHTb+EMjTvWuHplASpl+0iLr5QwU4HHCPk5cXK8LQWZ3rbkOoIznA9pgdwAiTkwAAOoYtnJgso+p+LrUG0xLOm49Ow6HBY9Wl+x8WWHbxd+Yt1kao3QHFXcx9nrZmxeNfnvOP9D1arIFk7uTojbKBdIogJ9FXUwWG/zLvGOroBTObjc3qGvlBG3oFpjg7ah4qDBYn6i+x+N1sXSGxHP9gquMLuOwqs28oYwidDVvKY7LyMRhV9Exk5u6jIgp/kfIUJ4tndi9Hokhd27GAHSPNTaZ3alZ8uTdj//TqhesXUQNL09sS/5I/n2LJ2UW87H5Ahs26wzjpIbTNvM6hLKNNCpTcuAgy5DVqStpcCkgelB9T5MtoRl1Y47gcqTy8xMdQ3akJEXy2yIlWVzBHMXHxl+2kfz4xxgDwp/mECMHZFTUOQ1luUU6fL2jun4OkIFoln+SOviZteGzfmhYh+CP1yVOjww3WW7P8g+YNMyhGsP1xg8vciZEICKJjWlJcQ794YS3+PrOQrbQitDJdcVTsopPDYZkBPs0ej6VFE+X/ySt3I+1ZLzp/bLIgmGXyhs3CHGAiVWq1ifuAC5uJOZtt446ValjN4X8Ex+GuFxXF/srdumitPqOBvH5nfkICI7TjqZgQkHExdQnMM4DYCOZLKH0YQXlXcTI2aRKWJKVciJZZs2aw27wRU2zaJEbi0KZRPEwc7T2ge2YR0G30yikpEFvvCU/kYJu51H+z80KXwsDf9zcjMbM1n/alsjLIbht+wrzsIwq6hTKINrAjyEeHm3N8FccrXYXJrzc3AnVo9DrWvZMcGgRofFXblP+t23z1IKRsh1nKwoNQWNBYRHKDwU8PllFRiWsTzUXXVGACmh5iNFxm7VAxMPkUQ4CQn2lxryRswEZzBjOjlnOA9ctRsO97Ubjr2WHAGjFGVFnvjrD7DzEcYasS5rkGq0h/5KDX69C32KR2tWmklhBqXeCtQybYRVd66pjyWefNf5H75r4n0VuHhrhgeXVjFZelY0tBk2tZDsFmyUXbR/+2p+/6rKFAmkxzTco17kyC3Y+Po2KWO7vhFh3+joNa8456BjGP7Tk7TAuQ+PDSHdtGsK5Pi1h4gnZkEHqg0mTHTHnFHiXkAzURAR2CjwgjBpwquzEiFilkph1fIm1wHc5uNQ8wnOpQ01tXGpDJXtyG4NPM8BIDNWEhB0OgHS0RvxNrQZedCyMNqhfa1AP5qiPgmoFu/cWFRU/bvV1QGjADgTA38Bv5xrTzoLDjQeg9n/aWGf2BVVs6otlRlyf/4qbzVjrBoDOFrrN5iwGMWcd8MGKom4YsROlpStF7bgzkGn5TjY6JBXZUU2q7ISbEhnHASxInYS0SRecOOmGM5DEzH0PVnDY9thm2K1ieLDbwZss7JQwmMS5QYnXapxrNMlafVqqYSMac76GDStxSKOQEgc0iu7N+uhMPXroCZaQ7ubt/HQadTXt5ae9cgJAV1ekaeKxtG9T2s/UfqShMsljzI92G7cT+9o4AYDdf5hl9KweVdjDBZkxLqdXdv2pBw3WQ5HtqIEseckXK/+zGyh5OlPuRUPplG7XejEWsUqNMmpAAKPTtao+zxDxB6RzoNXww6nYh6at7YM9wjVX/AVEa9rbOKOQRcHE76IiMUB2/KXbjivalyXav2WHTIqTDpmUj/OQSaCHTPbRz/iMSaTUxyJ7xiSyZ0ws/Us23gFL3x/pGZPoF3jGxHNnTLyTfsaEV+pAHhZt9MES0XrG5GOF/BkTPLY9Y1J5CmdMvvg0zphcPOmIidaBmQ/0iMnYaMo/esQEFcIRE7hHP2Ji+8NB66IfgL4vyh8xifJHTLTHoKfoERPr7rH0B2xOd9mcJiz97TbeDkvfZuNtidwRk+hpHjGJTtIRE/S3fmgu9qQ8u57adMSkfMQjJmU+YhK2O2KCnpxyEx0ueMMMmIZJ/cR+sv6Y/bH1yxYbukQ/esOpNgPi1h+l/qdzEiWyJ1EiexIlOtZJlLuxuZ6dQkn8I26re7ltdfS59tvq4bG31ZnuIyX7IOkqUkqW7BlCWhRluz4nQsoYKTm3GLlVkFulkVuZB1BF+PA5Aytc5KJMcmLOgR/cBrp3xA30+Kgb6NVbntqGnnf0TUXUzkMDte4pBkfcU9x68ljQ9/6Uh3abisGv6abinWERq/cS/zUWfg+Uc6bS2s5wlGBrfJO+fkK8zJsI8bszTEsbauVlYMG+1vKjRXUegL6r0sgEumPtrhBWU4wQGIWqcCIc7rH4EuLpQrPYM1AhloQYY1R09fL5oTuN3aPn7FUHeXXUgxbclSOcsuQ/qsm3D//0B+z3dzHnfwnOrQ2WesifcDTHZ8MjtdvB9YK7zU+Llw/CzAZp4m8Zq1XF7r3gk/wF/l0hu8pxL2OltMQdg1nU0vihxA+73sG7fojHIRExJQJlT6iiSYpWq1QQv5tgkemWWl6Xdg8mRemg7GEZoE+W7OhHKUzrRVfspWmg4SBYJ5MxWVLEyOKUCa4sC6HeaJLXjex+0keS0p7dE09yBWsMyOQkF9et+HIOoeJLqbRxT+pPoLO4dAe4YTFgpqHe4Joxdg+wy1n+Y5gn6hPUwSWrWLWT3FVOSxiSJRZLUgRjEfNbRWt3w2EhalZS+U4sX6SGqIBIbcl3r9zzjD/7zj/yLmovF9MnUpnI9sMmuEf7CyBRqCr0lhtZ+CKHaZDUNKtBYCaLUefuyX3Xf5k9Qq3dfK53l7aJW7uFPBQcjn6952ENBizcOOLiYU0kQ30gCcjwAt8jMlgADLDjA5KaWkHM2IhLEozoM0DzYBAg8mwMpD5b4w9JfO9sECT+EGiexvAkBvKbr2WPuLKXatkjWvZ8zWuJlr1UghF9CWhS9lLNa4mmfrbGX6tlPxsEib8WNE9jeBKj+k/GRMd50OhgIX/SqA8HVA7qcRt74EiPnbNyy04eIZEePYpgcXFHj/r05FFFTh6V4q82HTuK/0XNHrodZ88KxV8TooeC8Pj13DEgr/kYUPVQJSiOGTkFkWlkjH3obQzHILfLXyBs8ap1u9a9Im+w9JniLes0DZWSZDbzJFS1wTo6b0ln/oucZ5Vr8ZY3MC95Kz1U2gQVNaDO1vkl7/3I9fsf/+PvsQF+vfx776JGTmr3T/0l0zc+1L/xoT9alFnsR27ft3vJaROG/1++aKK+q76LirsnEr+qwQf/bIQCLQT7Gz9Y8MRPFs/+Fpfs70o1D410/WD8DkSSqCqfgIIJ2Bauc1sP4e74O7IwLMX3wnXZ/Q9nx6OUSy7drrncHm9HhF2c3IdcrhtsYqhdwRzBQwgMyTIrsuDQCuhi3OZYOYIhYBXLI+MjAWZRYpobtrlBjWtQ09Kg5le0QStPtSnL2opwqexaMWxtxVBaMXz6rVgSycPMh9FeJdeIHsuLn5II0SLi4+BogzZt66O9zMupMDrVur9MrUuGImnftDqYyulHYo+0o1khcy5GbMJCnNK8U5p3amxOad6p1v15a97Wo+R/fCIn4L/RcgL+YCF3BJ6fWs7Av0hOiDDutxYTOEGqqgXrwA21ifEXaUI//ibyd69SwLTjRfOQC1aQnr4FwVQ5/q+HhiJ1Ajjgarhx4j6Iv4XMjnXCPjtR39d0oB4c2RP1a2UnDyVcLuMoEKugT4GuQ3QVkvAzXJwswkpU4pj4CeRHRkKMhlSrzzKeZqhLKOQK+WKTEBJhgYymnk3qkZFEVJDqVn/XBOO6n4iVHxeHxZq+T5rK/rY0BELCWR6CMFUgEBs8CA1dAjyJeSn1awNSxvs8Ez29d0raL/EG8iu89i+XlOL/27zE+zYej/o2SSn/NknJvU1SOvrbJGHjbZJSy9skJcQTJ4AjYfF3csvIsOVtku/q8na58dEonuzKcBRpUYE0tqPjNBH5MELEH96KPqUNzm0KozsLJ2FmsDNzYi+mfO+pvpiSHybfR+KT/yIKBn6uM3kqs6zb+ywkNoS/VIaTh7YDx3hfyllkgtpLsenze+ib6Oy1G9xWOYafNGq2pL/XGOOK25e9UkqmnShhYJLjDgPseAtwjgOvH+I4L3z2OC98epzX8IHAvsQDhY3sA5wBOkqwACc+YBgcRmdHC++q64mbx6X3ovQClwX7kdjdHLOv8YpFe5TKH1fRk4q+gN3cxGP3scoodiSstgl4pD3KOhLkWoG9cuQFIzDYg0HH3TlIIsKZx760jBlbpvTiBt0+pArsXnwGsYz9ByolHRRhJxbHltSI2MFOfRfMgNWa7pzA6aBOlNFJZhUaQbJPyjCiRaBHe6SMPbsxd5dwZjeRA1j1pEKRTeMLGWoNLqRkVAt+2/hmLGAx6AsShiw62PdqZ7cssGUSh/oaZsnGwXdYdf8Colzy2c/g338tqrOFc7TG/4/dFH9Gzk0F9vRFBgT83eADdumiKogQTgBVIBOMQyd2rwDaRMy7QMCYZw23LgjRrjSqTzAhqjM9in+o+54ZdpFDKeNcAano/1eJAm3tm8244b/qzbkTHWFey5Izo/ovZbBVe7Ri953sxx5LVN6Qh1UV1gK5J4q0bYX5Sl2adkK2ol7JLYpGBlMdOoRC7u8k552pgmaPZBaL7IYVlSSWahycdY46275kkXQxC8ovMhxls2zSrXmXUFip8UGWmAwk3wOHBUwBf5fqFPL5dxpq2CbzLumhPcJkWtVP7vRSnPQ5fc9b7EA8ua/LJP3UrTJAPE7dT30cQlWwgPA+JwwVhTWk91Ifx+t4zf5PvWj4D7+xyLnIs+UDVZxL2t/6hSmQp4M8gq2Rvc5VtkhCrj3t+Q8e+LBzs5CX3OjPfv2puz/oXIQgN5L/+CmVOvThP2V07JHPP++iL3/zEucKo9/Zedbrv/XN533EuZyH0Df95N1Xf/30Ty50rqM/8vyHTp0wZ+51rqP/zaG4p6fnlkXOdfRlAqw/vte5oFtOwZPF5Xudi7CWz2yhxn00uToPz9/2kf944q4PO1eSfuzdD374Xd9PFjrXsXH/up1b1mx+00ec6+g7+j7N1XhioXMd/RVXAvU/Z69zHX2lVOOvFzk3q84Acfsa2wudm556eHVrH+WW+YJJTzu8Lh1sEziDBvmDWsjNsyTncvTVhLSH19mO20ld3A0HuMWR23SaQdMlLZ16+HOGWqJ38ajwME4j7GrklQDe3a4ZUQIhdcnXMit6Jo/JN/FQerHVCh2y38/R2QPtIAqeilAcBWzBTCzgnyNl3MkZ66zylHI9xLnyD4W5Q0u3G8+Mh2OqajAq/byKCzJvEarGqGrEIMac6000bapm3kjYjOpU2oUtE32jJWLFbzRphBmTyhMppk1fi9UzLwEWlFRAfaqvzaGKYYacynJ7fIatLHnrmx3G1jE7DC2IHcaNZ7NTqp0NNCE+Yt8AfHI6AmmNgiAgz/i/MaFwrGEno/vC0O3cwj3y3u3U3u3U3m0f6j1p77b3BPZuC0n3pE3bvuZNW1R/R3/qwd3Wn/aztvKuG7SvTHxqUd3htQuOtn3bC2H1ntTt28t5hL4vQ2PxD3Ul0Epi4oYWan13/KY3IJuaXffXkKvBKueQ281Ug4aJfwRCKgYI3WWEQ4YliUVr+1WTzS+/akICu2r6PLShP5ZbyQR2hAdQJ8PsGCxYAnRq3g9GcfIiUCAfnmAnsAsZ+HQhA58uZAqykCnCPdiXhAhpLGhM/E4xK5W0Drukg3vxG0HMYeiG9/mD9ToOu5HPr0LVxQIR/1g/7BLk1jpf/xWB+Q7hh80IXyF//OTRIf4nfN/HHNZmBWoBtKqj0JenDu6uPnQQdEMExQFqgYTAQ6WsTZFWKBAe6vWk2iga05a2Sj3t2EUdGU/1O5JIptGgQXsB94zGsnAXZ1iWunGPYf6pQz75U40Po3Y8uyKiqPoszYSujsscr7OeVvhxWB93yeoX+bGPJEmZfQOY68UXI/T2VKNGjagQQ5d8CZVYOUHxykG+kszQqmFFkUPHqrJJ7ZeJ+MWdTupWQhksMKGCvo+agD9XkyrUDOdslUoXHrrkAQoEXS6UNlGNkl+YHzSm0YYHszakIgbdNezwGCO1GazVpf9SdvBeeh9+39+HrwrgkwhXiPXgkzidcEHDkDAsvv0gni3eA/AO2VFprHlhiEdjLMFfKjiLxCyPcNhZRuSu1MvM7iNZtwh5PKKxZPRaO8RPsvdDbA3f5/FwDMe9n+twFFNgrw7HWIdjhw5HNL0MznLL4PTt4CzLgNRmN6xsUm5ekCrcnevMEqClkWFb15U4uo++tOqS3+7SHytpNb8Dkfj5IT4Xs0HeSmaNaWrOahjLOElBTG0ws3K6FxQQvpa8WplX2kCvfHIepKUb8Vi6CScV5bhVQa2/BEuxPSTpY4wY/mk8B6PgCj02LdS2BFecsMnwtdufoslwwzHt+GqOTf341u0n0Yq/bftxmCcvylnUA2dRjzKL+g0wqL9++ySDOmp2IpbNVUfcEHgditBPOfEjO83bAcoCssrtBlx09N2A9rzrZsBLCnqcC1kWrBit1V+t76B5GsOzMfDUofF7NVaHtgPGJpYtOlgRKkk61InV6a1eYUyrWRecMc9SHPTOT93ehTPpKiVvsO0taDOinWqFePt2EC+1g4yMWIetpZjP0BH/DI3idwA/M0c31F55E3mjie2HBScZr1rCPXH7CtXnGNO6mSEVR3WBucBvwxcIJ/IQ/wWYUe8O9WZ8vwUAzWzW7u2BVZWz68kFboDEB73REj47MhCRRjRHQaBigg1Y4V8JOkC4DngM0Cc0voEcrRN0V3XIgQSf7ca/x8PTloAxolpIZWMa49V+rUwHrGZZUEEjS61N/JFbpaUSAz5EqJPb6k2/TG31lqyt3vob11YPH7Ot3v7L1FbvzNpq529cW329ta3+B3CzjSyJRW1GRZ7Qne/KpsCXpp6wgWJeSR4DgXhCxKfBN+SCN+aDJc9/KWR5qj4G9UBb6sXtiMMZ8Ue3OCK1i9nbErPR0tl0DclZKeq87sVbUVUN0NBmdHWCYKfeAnaCl2ZgBw+TwM6z2n24r3bjTRtO/Jt9R1v0P2GMubntV6xgV7zrja+W71TB//acf1vOf2gH/PdLT8I4Rflvw9Np+p2sL2nc/CvuB0DS0P3qRd/el3k/lHn3iPdvj5S9dzCL+qh4/65d1AfaEAXr1ViI+/6H30hNjGSiDxAbls14wAD6a1Fl1Z+adghEIysQedhM3koGdX+O+ojVPh8z0JF32qd9uSekeDBLkSGa2l1tqTvbUne0pW5tSz1UmERl2jeM7Vd55BTzJw8gEsdr9Sz0Voeu0YUbn5Lx4k8gBkvEjZ9tXia9AyZnXcJIgZTvRoIERWvnVMN0zcT3SICXtZVf4wKytvKztvJtW1HgpPgZwyV8xriaBSrHtvSdR6DvOAJ9a3s65NlK5zo3Tgx0hwZbspsj3pStsACRIuVK1fbL7rpXm7ei9pB01Xu1gxwuFOIkEJewkzCrMJyEpAE8CJlaoHBeYZidIj8SuwG7sbRN7TNvf+97gstr33lNI0fQg5p/eY2P+uRp+LBWLVhW+8lrm8gd7clx7RZqIc5AXK+FPNye3CGlbqwxe5NCemubR2vdy1rISQnOALJrLXwgieAQQodbQikp60eTXjFa+2qpJXhmUoEzhMRxS+hQoh9Ral/w2YnU5ILaJS1BF8jLof5NNdNcR6+2bRzWoZFlLW0937b10qQo7jVJN2nIDdyqN7C/m91rbGsvta3NBhh0+SRm9y52e9jdye4p9mzHNHa3sttbm4+dbFkY9mGB/6G0v4a7nUo3wflxaXmnob7afxWuSKa716CnCxRz0aBHnywtzVenVkCe+FbbWtmw/gMek3j6PXm61j5d2xR2gz4lfVUdNMkA9TWJqKvmvVzOe/B+A5U3pn1rmkTlU1983y1WzK/Ey+KcnoFK1BSNuRIANZ0GKMIZLewl9jMVidI+OGP2TBD1YbhoHdPptpZJP03P5AJ5cCI9DYQc8R5zfzPXFG1I+5j1/8fcVQC30hxpzZLWWkley5IlW7LcM8/vpwozJ4pTOb/KO+a7n6rqUNq8kP+q0Csnxwz+/Y6ZmSHMnBQdM0PB8V3BgS/XX/eOtZb0fjqKXdod2Onpnp6Znenu7aHsIr5dyub4fplB61IGhAeLCA8U4W0anCPMvxBIo6Ri/VXGZQ+AdrgC7UzQBlx8Wx8uos3JMxcC84ZYY3Cbs/HtUrtvVtv9m6BsDbXhe4t09EBHRkyo0EEGC3yJT+G3UssrNafmETJhofW5khkXAw2TcBEl6lRR/y4DsPxcfDPUt8h41JuwZ00RF9SBPCAo8t9nHJABn5om+x+kIUXPby1xYKNKxo8pGeDAg5NRxR9FFf+f+t/Cn6e+JeTzKvK/VEG+sYh8wyPfEOSBtZZRrN/wP4o1qplS9sLJr1bSWGydhHV+TcdVN/+x30/IvAXc9B2u01j+WyhqE51uZZ3g0+o6FcuawqelOk3L+sOnrekULmsVn9bQ6V3WNT4tw7bwGTV2TbpqCd88y+CFtEYIvMPo9jNne1hsFvFjjW4LaalrX3PrMKXlyMjlani1UZBPexwuj+KeWMa7FlroHF91xrTxFFGbrD8leJa6tHqaeKEK7qQYs/zTnhYcInR78KynBlc5lIg98KdRDEj0lOCzEBJh4OdxqK16i5Da11RvESAEtYX466yXlLe1qiM1on2tgmCEXqmhfTWlTaUqUQFJqAlEWNNxJ9xCKHrF0wJS9F76VF4a/IZffMZsMyEHU+ZvkApbHNE9vXjUbOkKGIka4jaA5lr7JUSpwE9JKekQIvQLV/UHBvAgWvC4+rTgkxSPFzxVGszIp7niDEhwv1MpexK7MbuIJWOgKJo5iu9BR1lEEb0FDpXX89/Wzs1wOMbuIyDWz/8FmnnlQCSU69JVj5Mre/zcySoPNNlr/hKDYrC/+fqv4q6NZ7yrt0ehSViD4Z8nc/Nns6+sbq0uaL+UaeDi+frfGdExTWR/oBrMdxjH10MnvfOooFqBwCsLZ8THR6geT/OfFgQ8HIryn9EWmm9xfiaGp4LrMJeMXguloB9hOvV8xOD6AeNSZvFB7aPHH8drmOMDCoZOHNV+lmgIG3cNYbWknyVBn5gCG7AGz3wa7IFYTnGTEQuDyP0p+WDOb+GnIYRtUkND6RSdCqFoSgFC9cmTYN1gOMGa8uyLi/jOJk96saodQb6hFHfuRz+LFtCwM1rEhWWhDIWcKJCqFk6tiVo5teDeZCrmVy3ByqWlZkjWgXZtXqRdFmmT8UXaF4uU51RgRUPtuQ6vRa3zCGtd139QWvDN309rb3b5DwAu9LaAXsFPcDM3w61Fcyj5D1D7B13rXKnJ/twDrV7+Pg/R1rnl0BcgmqGxiynl1PpBdubRhYRFWl2dK6pyxbdylv8c2ldjLs1/XmJp/gvzVJITJPJf1JSJQWerjLK/+7IHHGXfo85JtHe+x5RSuEczDPgqN3M4f4036+RXAU0fHd4cKAXaARR5fVyRxbcYP2cowFgLcTsqcH0lhbyH03dzqd7Nf1mmnD/YWusfm+vi9BF73uvwCKzY5rg0Cxfi9bz3MrmC+yH3NzQpfK2o17roPzIvZ7zXxZIqT01tgrRCBJCw1Qnucylvtaz4Rp78h64ExLWN7t4+zzY53RxKn4iu6IlF/FNXc2jFFgNPbYfqok9uc6yhMTi4UuPM6k8GaQTToog6cBXVQQ9b4yIZp6TUeCHzgHOwDQMEvBNQINICx1xAP5gq+z/XB59zFF/jWdluNo2i7bqs57Y9pqorxGwxvn35EKePvugGEF3zqv6OoGl3iGM1OwRA/CMatYOaCTLqogNv00ZhRwxhW7K73BBulyse0oix5JQ6B7tTjuFt36GtK6Bhhw9yH6MhqGf3QIr6VKIxdc7u5Ib4anP24+bs38zZC84+YbmdOA0t1QHhHd9ge2iwPTRYj5HvUg+Nxfftmd1jJLaF1IiR2WZcygakHeqwiv0X75ajFl9WbU1pZAZ6rEAzEP4oNwTJHHocqN5mqgdMoZK7fYHc7QvkLhOqZDbNwt/ZpbOvNGc/ah4R1QOlOgTVA6V6cE71gFHyVHfUu/KDEd0MM2GygSB6zt2RkJvTdoGHH4iTkak9OA/Tm1ATeR6WlaG7H4EETo+Uukip85x8rFnNyeAmnDRLnBx9bHEy+B/jZKCcrK3i5HqFk7SKQFzdmOjsgMYrlhkWh+bbswlT9UC05g/OZ0FFuOq2L3J627O5g0PxnYh6TuX6uUo7z+uOdu4aXmiD6CaMr32sM978DzEeRPc5xfV1k0pB5YXgNqf2kr7HhtwM+wz3Eu3Li3BEhkN4FzD8FKjiJbB3/hKI5i+BPdjlFlNxhIjW3K06CrvMz3KzFuxV2XUQAi49iXbRuHXaZZFQ+Wpl9MENrL9QldSpkqvOlKm1e5kncg8Sp4HQymC74g1v8AZ7OaMRbWNp7h2qXxaj4l0aTu2uvBZ6OBoYExsQzwXxrQdDfHAR8b5HHDSVvNkCLhzqwGR5iQBMTMB+YULiPmaZy4A8oL4Q0X04RARCxDqIUFtpELJMRFew3kNIeoLSpERsz1vfdYBbj/jWOZDiLnyeBnbmtGD8cUJ2cYxh6J1YR3uogJkjtLg3Ky3dZVq2Qcs29Zn8vtDClOyj7L6XpSS0WRJFTTtcRViTCXORdqzmImnKAHkqmnIidWZuxDMeRjmi23gwmmEZVHmPUIdGnOR2maTlec6OMfD03Xb2M8aOl8fvGP9nrXStkTVb7XUeHyF+/LQrs6I4qSOpknU2ZGS5nXZl2Nep7FOhtjntTTlXW9t3eLQveP+raODeqgYeUnNqsdJpLrQzrQPSOuXog7n3AhyrGv+1xqw8HNCI5y/x5S9nAla3grJKlq9F1CpBjgocwUmwhAYcakqo660pOAzfwKq1mLvm/0cTRLxVXrYiEGmuZSyWqg0B22i1xhtu6R4eVbwFVZxLJiPcf0jFwvoRc3SfZXTvCPZhSI6NiJouclE5JMYlTytV8QnF98h32ZKKIiNRQUiQ7gHb5LSg/2TLiHd8lEUyVe+LuZjQYTqO0MhVU5Ffr0cxkzzkHQ0QeIux5hzdoIpu4NFVaVmAW2pjPz4TvdUDxZ57zYICRlG3dX7udeynIoNZsjiOpERuwDWgGLd4GWXgpBtO4naP73Nr4l1jYsrPc43IvKcOAivXFBn95F44Mc3Y5s+2+cb9eZ1vn4cuJ870NiaBzJWbGOECZIPLcWKPWoACF8P8uzK0W7TBA932KQPlA9xSma53MOaP3JCfG+ITslIE+YmyF9nl33i5eeQ1n0sFcB+7Rzu0SWExRSSC2gG/K0PiCYDKQjRGLQL8Qi22hE1D64QAy6DXMWDFtLVdhgIi8IkS7TyXTrhEnS5RwLHTEwavprBzFhz770kijPyIHEaooy2vaunTGOi6cMpwkhuCBSmFd7tgCHYOKJwKpzVTE3cw4Hdol/WgeIsg1qMxgI9pQ4FvInHTv57KD32amqcOW2lNYtCBMU+ZRKZCKrkT+1zmNifpeOUAk/KLyHzuKdePMmsgjsSnCLCAXSjZQF3/OZIutKV+SPmWuliMUilAhnAnxqC3FrldsTQOpeGDKhIxYcFCAiJy7prb4zcc0qKiFN3tkStmzFOe6Etz5Kzs+Z4JturNnoixZgaREi6iZRVyhzMRj+jUgW4hWoXsF00Akd/SvANy/OkmVhJPdcIxwitMOV1cBhRL33DJDcYNecfSdZNzZSfQBery9CkllJzegO/gQAd1KOJMJY2DOShTSZ4nMMStOsKzkWgf8t8SJy+sEhAhTipugE32G8aY6inXqT/cA8LCQ0rxfrjKtxAC/FS9OaYUQ4CfUgIBfkp1CK/TpRmcATwOyZjIU0rFMOtREnoSh26T0NM4tC8h2HIRQnom2UiC70FwgKB+kdCV4Edq/hUkos78zSopY/znvjGNWfmJxCQAaO9WYWIAMn7+6zkzh8VxDAJTFcRHZcY7eM6Xs7pBZawuL2MKhAeE0O1BxOoAFagf4gkRxYtOSX13gCIXUCy8nZj8V4Gv1v5p/LxhXUdVTB8tiek/S21pvJhev7rwonqgICJ/mM5BDr/wMcVvGhMfl6YvBLOX3/1Sb9ZRbhfVypsi8V4kKQGZGRY+IXtZRg6iuYag8xWnKn5pmWDGqqPPGeJbnRKIb1Hm3NezQUc1fkmVAnIqnx1Swvtg+WLW1lF/pmcvXPySoM63irBUeJNlf1s3aeWr11CpVdPLxz01eBxC3sO3htXDt4YVMYRl3fM0MSYkw5dSaRRpHnyNKkz4K0VIZi+0t4QjlzB7vB+VOhhaA1kF0j9PwvUCp8nURCWV5L/wFeqqRQvEUr9LrkE9VQLkBryG0q8kfDC4N53c+zIdEq9Vi8sJ62Jg+8Oxb4OeWeetR7lE+IuDBkUT8UN8XxMQhuuFch5ov85INejqjNaXGT5apOx3gSYDVP77Xisp81gMKE/hELq1VnLKMOP8Q15T9BY5xbu0VRA4U64VB9Zooq52MSkgduhiFmTyE0d8eKUeWhkXyDiS6yuL/A8AmOrlw2VW7HNFIcwwJTfRXH3qldLwhavLGkZddKPHdrkppGfFclgiqMlxKF7+VRgK4u/Dh+EaJMSk8ofAQU8hfRSnPApDS1OChZSYaZXmpURDgoJ3bhWezy6TSJvau0ASdLq4oYNzeKRJg5UPUuXB2zRpfxFXELyELshfSBTvFrHa/dZLVR/YTXXtb3KckcHMLmpEtL2o/f7Nq+KPwEICG4fahz/Jld80zzNsLAvu00CJwVo+/yMgCh4kivgfI44gZrOPIDJfJeHEyrk17kf0PbX8wSmm2xFFk7/686/4d0Z7wMEA7I1IKopWWuHu81OYz7X40yjyszVRBP52NT/lfGRwz3gHG6OKOlBn4gjYQ+VRTRNFo6ga5XdlCFwoVPWGfG/60M7dedvXLZ278yAl3ruixBuCYA1rleVCnKT+qXR48e1IuiyFBTIi5KXX4F9FATYKSq99orqLK/D4K129gMYS4jROkl0Bltkp36KjSfRym2h9uo5u6gTwQ4YSLF1c6y1LW5iI1piMt8q80yQgZmOpCf0zkkVYOoWG75SaJ98sR5bhZZKIXtOmJeGCjcgnuPdAjwPSbOKJsqk/6oBiYqIS0KXb7YYNqeEt3t/VSzaO4+vJseFfVO5arWg6cQIIJjRMigq7BiR1qhI8aObW0IVAkWhwRMFUOBwxc/wK7Jg5JUFKRkZTUlpjoo3l9x0+vkU+3Bk1ZbvEgfDQtYf8BIeIAyElmAcS/Xa/XIGuM/qmkMNxAlyhp6J0ZkOVlNymPsQwBWN8baB+SLVc8glus1VTPnVlbScn3gQvn9Q+waf3mkEGIJQdLiQF1FhMMlzrQwRQhihnab1GKGcyUiGD9VP4WF+SWUfem+eHq/K7CgDWepCynrj+fEndo+79X0v9G3ZLVzfnBPeAbwXPvuKZUsBtsJxuFP9qUpMai0kBGgClH+TRMnSR+tST1qWuJ63vM8MVmb1szrse9U/cYE53n3pM9+AGNw6GF14wa5jWBhxLMcmt6Xd2kpdqXqR5sEDk1qUu6kd3fTH25dSZ2Z2JKAylmw55zGHJ0qLtAo4xRUaAsPS66j/anEL0LdajHrYMJWjjmobblH2CfOrd4FsmDQJqqaH9OSnJLpvhIuP5dnhwyuSaZppR/4D9OjznLsTi81gr4tpx1qrOSmCFR0TnRWopMogrMjVFBo3e9Gi0cLWh72dkqDlTIAFAU0CtmQIJFEgAILg1qFnIca8lOJdUASIVCTNJmNnEV5CLWIovSnh4kXDfmTVO+cV+4bp3OxQFCw9wQvbp3R5Ogid71CufpO4NjuF/C8EtKv9P9U/2r3dzewYZ44JmhI/WHfk6vs3dwnHrCe9BY7iK4VGF4bGGI2V4PGd4vMRwF5f03qmntIprl4X3RggnP1BocO1yCprXZlKMmnc9hyMaofaxxGlXOTz2HI59vSNhSMSEgrVAXhGOKQFvhYKRJsSAEdMIMGK0TW0SvqiVNLnwMkAprm00A78j1jMrL6JFrmnynMtu627Hj8twvMjHpQZbYOtWyVaUvBlbmVZxmBy/CB0fo7tdOmOliBmT8ZVJG8IkZqiuCSbRRFEXANRH+O0nBx/5yNXnSCUKl2ufU4QTeU9db14KfTVF9B0nBzgrcnXBrYPb7/zGZ5+Kh7Eex/d0XhtagqcYefxz8TQSX35kd+VTJWtpAzdH6+VrkPVXSLik1hvU4Ijbn9nLOshu0ZtKKTu0y0sRvl2mddgDJ3xm6BnbwLiwIA5/mYQTAGjOCjvmB/eJs5rTwu7QhqyWLV3iJNeaFeSwF2nPCvgnRGZbslvTgv+tjNcIdDOBoOV5p/ZWMtRB6SHEq4aG4EZAHcCBhpQCWDvE5alMTZvoMNMpjH8cp/M5LaH4wnQWS2dHqYxayDEoReXYbOl4jMrxqD6Z9Z+wrcRN8PULNzeqSJ9lmkJ2b3ldBwrRC1kcugUYrAJUcfVt2vK3M+h12SrRGv9uo8H9KlZ0KKTd4m2nJ2X3oZ7vBLdndCttndge3UK3n9hbUPIEjVpDo57cb7cwFEdq2MskVlYHId6MvP4AjSvxvnr+AIg3QjrPtoQBfN4CJeShAwR8ltAvyewJfYIKY5GVLQA63sF08ByLAYkFC7VION1WTjdpjK7Cc6sMPxKWx8Jy6uDgR162Tmn3qixX19X9kAxJ6BpP6ZaDb3zXfc8+PVnPRKqYveenzOYuL2AN/9bZospbKgbX49dsSjjkX3K9fn64br0iRNHdAbZ5FKCqpEBahOT6NZsSJxfEoVi7CNX9+dS2rtrkNbztkODqHKW0gEPOCKJBCiCrBaTG84+fGvyLoQbJRiTgp3jbGXA8EOnEVwXIGDgp2HXNwqUIXXUJRI+8wWwRgPOzmLbEWwc8VOhm41HolXyXyLOw7kXFV2aIPq2At2mUxZwwwSDhHWUA82Hez+bU0kjOVWwIORzl/slLBOLAlaHYETRkU9IQg/gAL35ziDbwdmg1tUMTv1atqdv8RJFHvCOaYnfUVT1Mj6ejfzGspOb7G/je5/tfyLctjAN0exu47XBqCoVfxHKfqWpAaMOOZc4aC34MHJh8n+DzXYbGuH+beamIxb22OnIpkNuzzA6RzKeqMxUruID2KIV6NPGHkkGQhy08Z9SRtvprVn9CG05l0117CpmeEV8S3sI4UifCcBitgnZFKMelWfg1MaHLbNCuKGwsjVW/cOKI6MQ6RuhSacewXlovXP4v9r4rvI3sWLPRBNCQwJnhXHF9x6Zm+J8WQVIEKQAESDBJIqQRKVqedba1nmDZN0O8YXRzmpnNedemqE0vm3POOee875vzvm1+utbnW39VNbsJgXK2b5I+sNPpE6r+U6dOVZ3ThFeVmbyWzuOlw0Mab4Tj6QIPc+ki5pQAvOqRi5cHRLReXzQaLcptpVK6NKRtLTQxx+KX0aDtaEUOEuh2BQ1iReF4N7Ti3dH/aOQhEzGNoO3Cs3lp+LNxKZJnLTF21uRw65kMqS0aWHnSRIzWUN4lL9tYQAuXh1r7pSEWsXyo9TswPVaSkleMZ9U3NV0b8fB0eF09d/8l5E9C/rS46ntCj/dDrO9H/n40ZLjchvKsVOSZiEKtddVDc9uokWYdbjdXtl5nO0s/CRLEjy9GUBPiYaF69JqvQv6Pd6jrozMd6nFWv4T101Y10Rki/jOsu236i5ZFUZBcXQnaKIUO2uhqIEfPK0zq9cANZfVGScmRoGaEEFjLLd/9uqJUV4B3eE2Vv4MqH1vxXaVhojXosgZdrUFdxfHnM4/jGgvKac7hah2A/FSx8WatYZ3J6UNcQ4ttbLGQNQuJCtFkRWGmbemejbSK8qycIU17+1ng6SJmdgzq+9KR00XEl1ulp4JnwsHTpcT5gS8ROlnlvvq4IZLPhk5bK9wm2vsCHMKoCB5t+Bj8GDkIoQJ8iKanQaif4afNarS/hviJDT9xhp+zMVR21hWlFRZOZBJEmgZhD+YPEQ/vq3ti6kyYUfZ25RW6X74kiKUJX0zY3qcATAmq/Oqo6l/zccU/sFlTvwwb7bArawlAckLMo4DRzOk/1nlged/ljOIFrEeHTzpFuPS0+J7iu5MVXwo1Z1vHSgqVAl6ASrH8XOQkSkQlSy3DS62Il15ekx5r0vsaIsbm/Z5zPRvzln2uATRk9nlvUPp+RFxJgIto4CXMTv1NdyRxjA7zdSabwryg5c8eh3XLZepvMY1ra3epo5SYbFr5FuVqCiSAdRXr8ndDCVMbRZcwCauoEFzYePxfSxK4Oh5kNYIs1mMRZPIUUN8j1h8ej8EZeWyVTFhdVhIpb3zkzz4iZf7mUQreBfSweHxEcpKEIhX+7KOwybsv2MM5ebRlDaQKlekAKxz9r2AByVmjv1JgG2vydwdb8vcqNuXvNTQen4svhusmRku+jfMEIbBqQDJ6VQr0qqGm1NoWamEH17BK2c8Mrhd/j/+L0nKSTSz+5H66gavYwHU+Zyr+dbpLZpNleb34Y2TdqjMkVxnZAVVlzDkRIzY+YA2biP6MqYLHJ1TeMipeJImVVYkyKzUDPqdtlcnyL0D2FyD7sweyMthO/AJifwGxP5uErIKwKRD824SXgPdSFuqdz+/VH1uIWLwkugw1D1ok6JCddQ0cHkjIGFPJqT9B40Yf9cM0EpbEvBIjTfPE3tHEJPr39fkQ1DnZLrGSuS0EzEbu3Q8Lg7d4WESTSJtHkzF/S+gzTHEZfV7NuqZPs0GIedglaOw/L2V10j4VX55Pp5x5oUmHwBKaSN47w6xvz6hBQfg9a3Njje/5vtDFIuZRldLkIAZDli9/5ckcaE9q5zaKtAd9zfsJzRRSRlPSapq0oSaKCh+8L23pRUeNQ4JKQSDOy3EybFiVX1CxkdCKmaDrmq++Q0P1XPFGlX0EHe2mMbt3pnQTuII0MMjPrlD1kxyJhKF/m5+mnjTS0tPkwDrzaCONPFHWzpAo2aA3rG0XQ426sdG6JbQODTOdhaoc/1VVWi3PexPGnSbU+vY2rc1y+H4qqyy0dZviQ2/px+WqhK+QErWThq97CHiM5vCLyGIQhxidsdmgJ6jWiPA/FVs1f5ccOVXsgTvzKoFnlMAT0lTE5Jh+ncL7qQTFswptdi3jb1dZ09P5ZA6BOb3bkPyYec1ZbfEdLUw8FgkQNqSUDTTQMkI7E8OqEzF2IiaY4FcSOCc3kV6e0rAQ2CtI7LzIbGaic5GqtzT2liasDLhpe5UN6LGNq4qMFiHRMkjYZ0BQY5cTklnH57zYJ9MdITRv8X10+GM8Ee/4xC/22RflmiX1B0k2yU7U0FNxKs4J8AxIFx1nIVIQGtB23YfS196tY0g2bVonAqpuHKlg+aRL641EZY1eu411Tp04AZbJel0T9O0tpqLRVWaohSyLuUV5X2zZ6AvoCNTVXZgqcvxcRFwZ+7tkvzN7Ryi3Q9qxrFrObEVcNcTClEQZnDA5YmVtZQxfYxkpQuzfPvCe7MtKWoy92caqiYIGToqhLSfLiMpAPQ9K9vCcDvPpKPsPbKZu3KgaN2rGjd5pycsSO8rZn2B/U+B3JKufyHFAvj6Vd5LIoDTKOwrU2ineNZ7kXe0U72pQXSTPsphbrSBHXW+A6g0t5V0Ek9qxmYwohoxTwrVVIfNP5EJWrn5ErxCdYg4fbqNSIHs8QvNM/PIQebys0Zwdzu1JvAG70eeNPiZf4ZX7VBg1X3oQ2urPeYn2y/dIYnQ1quFk1I3csxD0Vjnt3BpxPUQ+VKHj3dNMCCqgmqiqcqAG2BZFBmU4AfVEWroRWK6ciEsmxpy0Pi0IBdZFfS+BwdZ6m54Z8oM/SRINGYczb3ptBz3+JIHcbnIn+JCgjxbIxfuqf2KeutvsUIW0s2DMGs8/YRR3Uuf67jxmqV6hbyBRm4s50qTJp9wgJY0FN0aoLkJLjor6FpO0Mitkx5dj0P4oTkFnBtrDrzY/2l8GP9pn8qP7VH70n8KP7ml+9MmPuRF+fH7k35n86GNO+dF9kh9vf4X8eAnvltSmwFbc25j2uIAosQUcs5Lco7aDDn2/wczGzZN5CFqPnw8b46YRmGAz2PSmt7zz+HmsymTrz5cG8eM/WtIWl73FT5sAkBSxaf5NJUVPdNYBB2vl7+Cdt8WJLZfSMjQpk2K0NDRhArFS3Rb95SoKaqds51RqhBiUDx31qqaD70lvYHCoWfRsikGlLmgOPKM7VrC2jxsamXnwZnrT8fq5Eu/8mpI9+Yy4Lnn8iVy27tbRwbn3B+Lm2YPQJL7uqwJ0ExXJ8k3T0DuoHqAqAtp6yIOih8HtsWQCnbSS0pb5DUH45vEpBmTTSGcC6qB2CmycCRr0HoSXFSbhlhyqEm6igXzhshwqPxCukIdhR6dDYUUqszeRzS32sMJqv8xnPZmXPxAdoayAqfJI/bHMDh6S0xP1KvGDnvzdHo+ifPJeUU4mgiIZwgVF2BGAPIknG0POxlM+k3whzJ1M7yfcoh1bIdTcDkl9m13k6PGZo0gCz4FjtDBfxdRd7A0uCvTm2LvmOG/yiOUloxMiLFHHJ8Mko2RPHlbDsqu+Jb4yyT8S08racJkjlrRa89TA+TqrExakkuaD58Zc4qC34mrprBTHsyksqJZFPjXl1T7LR9MxavNDPi2jPzTdoWXqTMPUma6pM233dLUoJk/NdiBymO6yXPvwjiLiTVAvLOXJO6WwnelvWZXlnTRxJW7b5g/pqukHZB/1tjzBBoqPBKjGAQxTNlx1uirZUs1kW3O/qBfM6hU7jZWtwnMeMWvt9U1Y0bKHAKgs8sspLScY39PYPtqMHkPIesownxaSq+aRLH+FnHzn5ysn3/n6cnJqlJP8Nj9zL50wMHJ2MXvlWFO5omw4dNbNkhMZu9pjP9i6GjYoHvhW2uU7fWPprM18W2Ne2QiryuHuGA63nMNV43Dv1EQwRjdU0FDdfIOjgfNXFZQoZ27TjHnKXCTKtG2fOwmPUFNmI7u1aiNFbhflISmsbWkI7rjAv0U+CbqMa/NejPDdGOCT6CaJ3ixo9EtYHqZLLiv1FkcSkYseWZP2hA42mPXEKLp+QpKeN09Jgc6pGBjVfLB3GFqm21RtVtYw/6mHAqKJBipOU7cnKb6qIUEIkXO3Uozq0RX3AXJUz2PNVDJdCDsyqIa4oF+45xU9JY7WnzTmWJEuyARFGz94S1qdqa4au6968QRqGQ6brEHAoo5ZM6FZh7xZy0N0eMnVsh6/0zZHslTKwDahCaY0FU2mh9CCuWBc9CXUhhaCe5mT3mbRcBZWtToxq7MqxSf55FyaZpy1qvRMGFKlaMuUDD1aOjWgmPyM0TvRmxtybspyBZGDOnJN+UGm5xDFZ0dsOSTHqMqcjOr7nncWvlXKVR5lS4MZNBy6KhTR88k9qVfifFP6OYnndtW2OMTDHBblpCLJ+XYTcugpVUOfB3owSOgw77YlKfhk1kyaJDlp01WKQyVvleQlgRs5gfmwbk50DTJxg1eUx/BMqPXkT8WS8m+V/epfVeXqX5UzQamWrdw6Ran7wlDlo39g6vFrUtjHBDT8E/PPhMtvliuvfyb2aT+ms8CPefTRP0SV4Gnn4LlCmLMOvytWFtnFZ3gxZRCpUmKy2FkCpIqWAYTnI1xLE+Ubh5HTHGw5D03UtHmznZnnqj4qk38R2ipz1em0aHNDDoFUaNvGsIoxLDGGNSzEwNjG0S0md0cZlZBRMVaJ7tOMctvn34r2c9b8B7Lmf52whlf/Ibv6W7EzqsjEkTFOOY6YvGrzD4x1Z3MtE0KsS5zVpWFLU5ORvn4pY9c7iXCoDbv4X1W5gF/8h6ryruLIyvs6d7dpsyZ9MrLBWXVsjGyQkYkyMrZRIGNf+4SRyM4y5mZSs+pbShpzm9IAleZ67GlXDS1fNoaGDRiuMLgYjYd29xYGkgd2bTomYlHnYWlkA0RfH3CR794Qfm+O90wyH2b39l1WLwi42OrYRW0rE7XCgDpiEbUKWgVZ2xV+pvIpAPbRzgJmVKDMUxZwDrusWYUFHqbCioUusXkNRCTsfKhR7K9gWdQOzA+xcIgFco9kmWVEoL2ZaD6Ezjg9JMPgqsHPTv6Vn1ByJLARAW2t1qFrGjX/imbTVmbYaICaSqBcD4xzNW/V7Ru5qsf+8CQga3IVav55SAtJ8s5XOVEumaFLkZ5QbqR7dZlDFw3JpaFDTmggdoqrOTAfQ2vkTBUrWCD1ZtHGctbAxOnHPz4qVkdoED9JULNKmzXahQBiP8kVp0J183HSlVxvUhanV1B/ZplgFvN8Mg+7aVFW4yob2buxuH4Re6XLX7DSWV3HVFTDtubQV+mfxjOGW6u8DgFqiVliP1xCm4Rvgz3Dx012hdJZXeEXusI78RfqClM/Z7sCW/+zpCuwol9ZV4itK0TWFQj1pkJ9tCs0ja7eVTIIK9EZitodWgOTQyTWmga6UnJb9aguy+whkkE3w37NsJ98mdinRz0h35unsY8GaWRkGzf9X9VY81G4F0Hqb8ajkM5tAcXUmdetFxL02EqZW6A2AunEIJ2QwjXmbbU0CtayJjgFIx/Ss0o+SR4PAfCF+F4t10aKsFRWh7YHx5+GJQUBERMTMcmMsXcUqAZT9Z4bmw2orNiZtToJuzYfjQeAkDJNw5xNnVmlPTXPpiskU7xLPWgPN99Mzb9o2hCxp3sSRHm8yL8qpbGvHNlVVcljHbhMRFFskJXiEOVfpmAunLZqpMHpZUppYzAL+R3M0BfRRaxuxCpidQF3bKrrcetpT5uv74rh6ZxPL+nDsR1QXKuliYO+4I77gjUpEr6b+xLPslz8xCnLBX2zPe/NuZNXDh3UFHHatjQqeh6Neu56VAONXMepHn8D58e6XVA09Xd0F4sbd54pCc8Cznu6m7aXTKw+A248lpqjFzd9iZCtH7vyZ9OtR7YeNV3HeraOdN1indP0c6Wwb+x72SoUBmSA9KzfEA9pksc3a0ayGjEriXDD/sm6r7T/pnS1yUM1K7Rt9bVPumgpQp9IaSsalslXubNu3DkucbvtNZTR17yn/i6bGjYNQWHO3kqXrWJp50TvbhJMaVVEZbw7iMysN5sDJo0VMom55mbFNSdsRX+Y7epRQ0Wdb733uznIHDWc1YhZCAxnN3MPTZYNc8SYq8qc6xJlwZk3Zvk7mBlKz1VDhCDo+Sf9DuYoELip+4oggsbO9en9oMuLEXR0XPgMPzGpRsOJgjrBVZ0h7jz+yyU9/MXS4z9dEjvbzISHfchpnJ+W8lPlwri5nU0yUaELhsF3khQb8uf75FIuSrwofd/jiyVexbyK5Srm1QSvJuRqouAroeeFLpPJd6TBxZ/7UTz+weMoznan5Jtgdc09R+7eD1306ddKjEJoWqxAyFQaOSWhauhQnqDhxsnqSRxSBaAfRi3TxJ9IETe1WZjM29aZSXSX2BYW18wcNL3cEUrzDW1TckFPFy8GlTzIyZnH+vRCB/K0aGeRu+ZcU6nk41rBmjzN8coloTl7ErfgdcbZhMMqO9SSjlquRNZHils1QzZqbt5m0rQyqlGN1oGZVlyeeeSE1imbI0+rkslDFdJ8kqjJIULdqe/3AcGJUDELJFtjOrcxsaKjgBKC0LeBnFV069BSbjU9u+lR1uiIzmDEebPOjgBRSexjXMVc2hVfI8JnjLT0iKJFF1tcYrlgSJzT3h9WrPfaDJ8VxSWVTG4GWHBV57KpaTb5MKrwqcUWttiAeUSiOw+JK5qVWnUVaF9FWabykkt8QtXEqDwIzTGyrau17GFlWJBsafuLEGxtCrZuLtiaTxFp3Z9FIk1K+mpLtTa6lGqnxVn3bHHWLIoz/h2VaHNfvETrEuvdEYnWZco2li13BUJDJwMu2xpnyLZG6EGefgWyDQ1099G69SA0C2Kud3Zf73wNxBzFuDoiWqgUHRGdL1r6NUz6dVX6sU0n0q+qZKpps6q2WiGXfrVT0q+GtpGi94QgFNEknOycCMPaFxaGo6IwrBphOasutFGui0LSQexEsj31TFZWc8toaGhdee0izaSpjVURLktGS5LLosVXqIOLSixqrtuto2JR77X/uvOSrXhYA7CJ9eNHmQIL387i6DgFoClfn+HOsKN+Q4O3Aboo1n2Sb9LZpnhY4K0FFfCZZ3BZOpJOg67IbAbhTTWV/xpqvdKWYBPyl3HlMNxWKcrgUmrm4SDe5SuSLW6rPfISxei/KXHbDldVl26dkIYKcyS58JUfShepqF6RbGv3pUKHWLyfrlB87kksDy7jCmEhnV4e8CwMZWZWCMHZepSu2UYgzO3NmXRTYyqv0PnVwqLvPRoWkGL/zz4MqeQYaIpmKyQ/tRj1sUYpzbkaJjiTCMu4rMaCA7RF8TVgptyVJAVSLEOuemQUHuYrR5QEpLYuBFlFN8g45jJgtRh7lgdcLcjVIhZU/i3q+hfqY4UwtK2N8fsioGbTtsto45LJwmA+78SsKgq2RPLbCkAVUZpYI2xZZ6q+FV9bc5RuSTvCuregvGfA5UW+1meDEatnhBBRHLa8oRvYxg6uSoN/yieKue7xJUSitQhBtDRyqFKMHFK/8CbWEP1ZrjYp9IArjnpfY4sG5J6Shg1g9bXy12Q3IflB1tLcu57XjcU0beCy8KOsQ8/iNsXXLD0TWDGCGH/3Qoz5ED2Nv7uSZAV7Y+ILt54MErvtHRV92h7meJhDl4duNj1e0loJNg9wKXRYvdvsVYzYDA0coIOBgMQUrfcKE+/gNm7S+BHeh4OwiNvhFSn9lUGJP9m0pG+7LUo5B7hDgMwPg4b/fiZOfzHF7fut+x5L95XLwcRQ9vRVOwXXOvCTChpi3uM8cDTQBu9Hb5C4fUPebqtI5NmO2kh59j7SPPFl120qKof5eKbZFQfSyE1hiQ+oxr0xwypIJiTg2gWPDXCGomW5sornI8ZLwIIZunshyqI52T5JSk+6kH4O7yMjhByT3CDFGrOYtjjo3Lvxe54p/sLG2CCVHQ5F8tayUWpMmp1wFTth9SSAomejR40GOnZkVYZHKJRuaxRJuCbp3bhLjVdXxCyioQ0/NLy5qTzdwEY+9KOhM4CCsxcVkqxSx1VsM5HUCdd4sqOZqW0ogRTjzkO+2NR5Al+5yqyfIInGvSgx0Z0JH8Ac7qid9YN4LwRtH8IsVlXf/S+sF1p/VvopY9wf/3eTGe8ffN8w3JSDMHhfSLKM94fLPvB/yEL2r6hU29RR4N4zvlk6zTp/6+3wYTt8xA5bzogovUWKXsItgXQaCajDLN5P7/pHJSumuJuu6L5Ma8p4XDH/RJ+mOpPxK6yQEpv3sR8SrAWQV8wh4svZ+vnX08pMAAOVISd9B6trF1xRz7X0s6ec7kuyMjMANWoLH8v7Vcx+dcmWHAyoZYUDjszS63+cQktOpFPPG0R76Zz3tw0LkWsioiRYkFtUVOSWSha2raUdVEHG7px15ZDQIHgS2VYl6x9IOVXauDIknivYrRNz6sfeUStPt1nnMleuWZih2LyV6GKB9euZDX7OhOMmcBw+LiQI2JuRN1e8HclgN/fmS6nMMLeix7zUOtECq2fEmtwundyOs9t8klgWVvn/Wqy5WodDlwSEbobnOrfcjPlAx6gu+e+P5GL+vk1EuBdjdzQyWJVkU2U+/mjklZTZpHePsGITol+iQP/EI01+FD4CgY3MaB3jWw58C23r4tKeHubtUJEDOw3vaAT6QRrzgZxrQ4hrMwz8iOm8uoYmgE0ph012HA1UsWgXxDN8YfAjcpKttbnLauzKSuInXrZyLbADtokdF5Nu2ulRWLdMQ5TFwrA0T8hU/oImZII85oYq+zpi9jZWwe4mWTZ1fZJuZVVDwstXs6wfHmWZa9YqQAbH4HOe8fnWQzndHTwKqSWVx/Djqw812//1t4+PCunWdDEsjvh4E5tHD498l7otO4ZXs80+JqhiCVyo629RTFgCajUmyyLuVQogBTTRq0x0rC15dMRk2HyUbsrOpe/+m7DDGzN2fR12eH3mYQpdpQs9MAEMa3YQQIIjuQF7XFXCZn0EXZveoNfy7WM/brfwEcvbDlLW64/SN/Bh3H2YfvJYtfSpwT2mX8PH8Qkv47O6s+Ox3r+JPjdNvEcGr+CegJTCX/TeUMEg1NAPVSVZTSR3JXwK1XSXJNLZWs/EalNZTgzysIZPUahVEGtGiHgQCUpXRQ27NqquEYtNdtgecXTPXKNmQf+0nHz6jjpYargMrVmfV3usCMPy2X9mdXe0sMftcpJi8XQYSVqL1I19KplSX67Ic8Mty7dClbV44xGkx38Sd5W+PNjML92kkP7W9Ftk0HrhcAgVBsfpJ/Ax8NZ0dushWf83jm7+83/2z2SnzXXLhQfmwmuyiAeyP/2YnNy+QVT9rl2yOzU2r1HzNR0kNtnu4fW7avrC3itUaS8jZolY4dEGvDXIT2C1Vs8m0bOn1oKvIb1H4MvJpm66e4z0KH31dbKfBWoCHoWwuszsZR+hOP/0WgSrRfBafBSBqIm8Knp8CM1yZOS8haCzoEEF8hO74bcO6sP02w7Ct+NbZQQNC5L5+EHzig2aCxZhfuZoOf8NGy3nSaT5kdHyFr4N385hMhCGASv41pHR8k/FX63Rcnn8YOlSg7SzxTN2bUVTr1crBBGhSV7WkQiX3k/GxqrWYR3yE0it10+WiATJDI6oIuYcXnIg+0t6yWMgqQJmlSxZFXQaA3T/rMzgpfDX5T870sQPZH1LL+PsEq9Z17FU5ey2jNqfPU5ByUx1F5/Ux5N5B4X2xGO6F/WPJnt9xgdx6aHHLoxtLp6K1BXxmCI9FvPPq/qEQlYJNOvB0sUFrH6W9VR/LoQF3sBdXMbpjvHQzCVCI/d7Hk/9jt/IT0isHQVwLP2zMpj9eh0tsnEIduDogs1jrOmI7axwXTb/0KQ08Hu/6ZfrIKgn0tIUeFX+Q1j0ah0isKTPP1IyXczIRAJysPHludLUj2IwiJ/o1Xf5uiTC4Pjmt3/7H7jOwXJde/o9Fe3+PgaElrcl5bAGRQjwKSLhU8SEL2Nm1iFRMoWKDxAmnROWKMjTVr0qYzkVGXwae8TowJp/z5q/Rz8IJ2qj1AYrVxpTkRH6FWLZ4Rse2ygLgH+E8KTfZ9kJPohlwi+N8OGNeBIRPrIR16gHbcTlzLJwmblfxk0ebmKfh315TT3HH1CBsciCF/EKqfAK7lBu3HETxGmvu916kb30xexTYRf0JtWtJPtQxT+KJyq6iyyBahu6lnX8qAhGebDwLlqo/Ds0Zg+o8byNsoZDcb6aqEGcOZQPbxUj9vmaJa+hqi9I8qm/Rxtqeg70mxMIjFthvucKH4d9TVjAr8rzY6mfl8CR8+QJqxjK/KSZbCTHZQAof4/tW0M8nvMXY+2A4RyH9tNZRp4Dn/Bta7JmESqGw3OU2ec21KRayeJos7YZCS0qDeUT39ub9RVbw/rCmFiVG48/LK42KheLtuL2zfr/nyhXdZfe8o8b3cvphJGtnFkTsv+IzcNYtYmF1pHtqOgqgQmRuSihSk2nomAuJJrIpi3ZVzQKUcSY4PvPlEzynOOlnZ6XgEU3HPCMeQvalLryrHRyB1LgjNyWd2s8nNfgI5uVJIofnMe5hygb/ZKhzHnOW5L7ad1McsyKHfcsp9wkKqjTqizJhCdiwHsG5+Xvs6iJU+45/xRVBO6y/Bwm6c36qTGmy8nxpsvJgj9LeLqfV5x1JEFRHpIQrGiFECFnCA6cV0tmvr9R7qF62zJkTtKBmE+ZbFKk1D/iX3nR/ZAJYf0ukyynYDGI5eR7Av0fWXhK/qkZ3uOLFkQ05FOPWqn/4VK5ZH34J627SV558jTiCykrYJ2CcW0sTLUwgoV3CuFEFZqix3x+scSYLhOy7O16Q7J5f3avWs+IUKYR7+hISypqkeX6rrSftYpOIsaj4s66Jd2g9jk99S02/cqn4vV/Ov389Nult55l3/nxc9LqmD/d/boqZ+xPcq3ZRukE/1Di8BK8qHxPqjJIPRZywbktH15klVQYTPPsnFaLZ+d5NslX60JyXkzxYpIfpJqkG0T2fn4W+pGM5/Ds/XSKYH1evyU8eOctPMe14hd8NXY6fR/TVMK497lszD7zx/liL30XmTn9x99Kv/kPpi/c5ydfb+DX/EFZ8xzeg4niltpS+v8opTO44IvP04t412H6oq7tpnyP1amazuIZuxWAl/ixlEN+LDpgBnJI8aLoSpixpJcgL845thsF/8zkn32Uzvv8cFIdNAvS7RblPOay53fxsISLpmtP0muzLDflsMIkB+EK37oTWngmc+W0SbwXbGnVWwwnixnqFVZVAvN2l2To/dmwhnkpah0XpYf3JdOpg7CBbtjULWRcC5pH1WPDjj0ibAtbrhnxFGui9mx/rpTuuI+YHSVcdcxtYoc9r67Lk1HHjpner4nkvY6ZYFPEd3E4WrXiruE6KXqBEBwtafUNHjvYktJ8V4R0IC6rGwP7aMuGSvVpUp81ebeA6A4ivCDHA4MB3vOAIx8Gwk3fuGuJtu8IKd+5ICcX7sxwqL95wHP+pJAL8sq7MCC4ajKkHrypwkSSXEBFL24IGV8e4/q5hZVwQcXmLfQlTiDd82AEc7Wm+3jZd4Db58RApWm6/3jW9mbFXhbFILdKJ7fi7FZ8cmsiuzWxkTtnPdDg1niJfAsXKJEvUICuBH6iZkW9MOewhMEhpg3XIm/ztpelJ/NWLDem74cLYPDk9GEmqiNj2Q2dlog6N7Iksax1wi9inS4QgCxaPEB8sIvrRM911HW83BGjCq6gi6t7Mj/kNn2EeBo/CNdwVW7HaiYUSBmu5F7dcHVT+f/SGFzdxPSXhavrhivDK17E9JAFfWnoCsTWNbzEAxEeGcQuHPCcPynv2liIMcnPFYhdH4XY9S8AsesZxK5/VSA2EEeQf63XYXY1dKmBEFHEF0HVkjREn6OHvloBwm1QoX7OMDatHv1SuClHbidxldiQ2s3gOi66JzxUXP5dYyYVq/VtvETrwSCretiWBM/cOnEmT5rfZFsYvaffFmi7W29vvO+0HaiNtUlSOapv/NIp3/j2Wb7xOnUQFnvBfeG0GV6Q97fDFqmcXsh94Tek3gPoOW5w/r2NLeka3r7JZytxqVTiEjQgxqSSiO5f3Hi6O1kInzU7dxnvK8pvjUH5HsQgg2UnyL5gfRHr2HuKD31vPCb3CgRcpr6KZSXg7ikfOiG2gPknfeiTp7Qsmc5Sdl3QW6jbzdlQoYpMdedZ9YlPWQONr89LJo0QPY2v3xRizWQKz6t7/xLiM5mqLpLnJHstl2h+TkQiMf3T5F0FeBxHst7uoZVmVjuSpUSJ7LhmwsnxhZPv/CYcw2Nmfv60CigMimWHyd8xk+PH7x0zMzMzMzNfqP6q6Z1e7TqG7/gM2zMN1dXVRV09M30as2MoK0ZpjHVli7oYn0zcOhcokR2/afdJa77XO+hKnkhd6PMQm3fMvSdoBvjKqXA9gtut2xL1xr9mjF0ePrPe6IGZcj49joF8420u92Ve7pv6uc/ycnH+pub+h5f7ZneYPWSzPngaZwg+SeJzrXyHrMX7h+WzENTHsdrmOFbrjmM1ctZsA/wlN7guTxnCo8qbEzZP4sE6z9jgR4AbBvxWANYCLcU1zovPnyKI3UvT9+6u6X2NGWzakqZ67j9foHarX/uRRqsbroQEkXPtC+Ta7FNLi//cK/7r4eKNXvHvDxf/jld8ul9MODjXIfXgGiddptszO+B5lYz+qaaWjDu+2OD44qObhY5mtdxs2vztaIFzU2v4jwlNOMyGaP0wW3MDXzXc8DALbniHcIOS9g6fqbbaFQPFssGv8DUzXOFjfoVPjajwLr/C+wYqVC0VYJThSOnXmXlZeKF6AEmiUF6T8Mhrq4tBvc2gmbDu08wKhtZed/i9/scItG7zKzzMr6Bwt3pw39lI4cVeq8uHGn3Ik653NY02ukbDzCTLba/49CGYxzQgf7zNCewRQ5m+wP7xSlnIPHbNh7m55RWHK7h5dvei/O591wLv2V3Tv9KmnggJC9R8Y9EmADAYNArALYHPLQjvBpz8M6xdMChqP1fYJw3B1g33gDUAGvFmp83fN1IDrDfGE2qrs4paclxzmxu3VU1rZltYwTa62/ZZYS916N8wztTCyZ8t1R1tjEDwVy4JMAz0GrCy4diQf2C8rRmOhBbyQptUhRiFfJneHJhweFyw3g2dAkU17FXHnFviUQlX1CbNCzfUeRHfLlQb50vDJDjmAr7jS9UbLe4+ld4D7T2zYOTXP/nZh/9eB4GxEMfbchnKee3yOi7gvM+840O8OIa/CPp+SMLMISK+wZ52GGqHQJYHIyPS8Qi5Np7LAMSVVjpFHp2kG0Y4PNK2j69bFYa4kug/MF/GiQFsSUIkUpZ/GJgeqOHVSKJSKENfILzHDd00/wjqttJ/ERsz+iswOh0aUAZQsEI2Tya/RXaNoJBTv4tMbixuSsFPuZhadchO4+SmnuFeCeKxfINMjjNBDi3PGslnAN1W9aNtfLRifvc2Qftl7chs2Y+PqguW7VXoR6LmqZ2tr9t8Lf0fCR4SLgbl7qOa9QjcIaQXIIaHCByXPUClQLYvrZz2z8UBPjuJ0mMwtv/WpyCrZL76kQSkjrOn6EcYwOoL+UdvYuTEg3wbZyFwip8HuAJsGSdqGlxPdUlbhWxBRe6f+e5zWqfNzBlo5QhLSrKQtS+o2yhRRqXcA7CxwTDc6ZVpj1JKNT4IwjLiZcColxm82g7HCcP/Lid6RZdCFyfMKcYMTGrA19K4HGLI7aZ06RMwJeYLDhhxWkyL517MoPIJZYzr/TgLzGUXi/0pk4hdsFjMqtY4gMapg6dR9ag6tp0djszNMdBPtc4pcORwskH2YxaxyREBkTWERmMSlWA/6Ry+XUMxTS1oHgcSKK47rNZceuGF+KLOQTRZTNEB9ZOUY0ISUUcHyV5HQGsKS9PYjMKEuSOG9KC9wC39Y3hl8onqab4bo+l6aW9xPOsaGThqR9RhFuIGqsbxJJSACgUUdRTUsoKCdc0adFbrFQ8pqXdlAuoyiTfg8G5Oz9G5oxxhl0nOPJC4TswXsURYzsEV/rOWWiVBlP07rRGLy7Wy5Jp1A6Y5WotACrmgR0B8aZtL4y53/WaR/5LE2tEr0bUeCWdlaTkrJMyUhBGlQriApmpiWkXPkZBSnY1wkIQ0hfjHlFumraH9sC1Zv0Q+LnYTk84Q1VYjIKx2LVDdKsIFdfQVuzf2J7xkyP6UIed69ie8eDcWBx0YZ3KCSzyTAyGDX/stKJTG6HxqyOigl70yM72fvYH59EgDA7EeNjCfUQNzmzGBozV5PoxSGZ0pSiGycOy4RWesX8SPYR9VJiWgEN2BNBhK/ll1l9hM4ClukxntPP9cP78wzoviEnJe0LfbZsJh8wB3lqkYOFSupkXp5vjJFvArDBTiRxTZNLZsjB4vGkEW8+/JPIn2/ntlsD8nuVvSu4v1brMal7yMoOXl+pgyPg6qXuAKEx9nL+Da34Pml2fm69PIKOFeRTAj1fwK8iajPWzltLrNSKOQt4p0X0du7yP9sLacr03QgYI8LNSK2sDlScIE/lgTimQzdg4ggPrj0NcO7ouH70Dqwkvg5c+5QXNwUilmYQk/Nxmv6usGC8DJ+jr9XFPnXXWdJudjRr0l1NVdRstX+Ll8QQar0IoQu+5h0+5LitgxK0a7UAUOJaXhHaClHjQ72he6DkvoOxiLMcUCulxXhtjdYyM2X6Rq2Qusxe4DBWV0v9xAV3Y4OWG+mOiz130W3LzDuhZd3bSHolZ7fwSF8Kj0JmcugDgGrg24WhTUX4Nr7oOrvy9yzsrg3ATUOc4SJxHkKaCgAqxDcCVLhNW4EuGalqv79MUsoRxilvIFKlAkLagjIPLvC/MFjDwOPE0gdAGE7gf9/CKB0CUIowh615kaP0yPIDiumE0oFm1FMNolJon4AqrKJ/gn/6FooBFI/GgICe6dQjarRehCdqb/utuYcgx+H2YWhNsW8p9s02W6RQhNVC0veZ+o4bz8x4BfhBo6kRUUplijEpF6rZHGU4DQA5oV+EN/lgpQ+oXK5ZotZEpShb4O/PxudOA+ufxfvM13+VXpNy4/bla4/CePcvmrCxZ7++DtX2jMFrLsyhcBGchrBvMJr14IwTKG0kzzLfeIPKsVrdaQZrNaf1rrzyJD6k8LvbWGlRrpO4xpD8fT3ONNFkbBqqGtokvKUI9/5CqvwvMN+ZfU9ulyOJZlepFQUmOHNXMAtwL6nf+rF7AOznDtBISU5F8Wike6BojV4olAki79md2+ojONTnD7VZUNkBarHD8SlL7AmmQPx2P98WxVu6vj8NE3lzTmQVcKjNodDn+NTHxTZCbCwgJTFyvXypBiCuSaM0MZT6QoODzYx4p7RaAflBVOp1gdGFsLC1pkSglAhKLRtiC4gx6CRbkT1JMkRCJl+bc8ciUeudR9+bZO4fuNiZYhfxqWC/Kn3tyPc4S1v2jl4z9FwAIjOZaZGQ5woCehhrjN9QprMKGtkkqP0i4T+LuGOEn0aSS0casTNSCGQiSh97RRhEO0rThjRYL+UzEeycBKxL2wbV1cKYCnlpaY+totBcNuu0ZGK2KtKm9ICPdJbXxtSG1EvtqIVqgN9BIsq5snGsJpSTHgEm1isuZfB9Raa6Kp78laHSPn6uRLJLOtSYgEuDygr5zC/BsAtjuNpPRSAR+kV+TotclF+CXCZ4qQZ0MYV0VXBLfgW07KUOdDapg69mdQYOqJGggatl3QMNtd0BBD3beJ+s7QRFl/ouzQRPkk/C4a761S91gwHCSpdST1N03au9000dG/wUaG40L476/xYhVsFasiEa+qaKv3d4i2JYwVBlgYaHoUCcsxJiKCSEg5uAMHJuck0f1O8j1qBrVaI0GNRxpxHEaCPceo33iEuo2HsNdYWXEAA31yU14hCIXrNbKWUoyw7sckyjpOWf5xXOkEHMI/6AteY4BtE46/dcThq0JluWVoDn0bFjD1GwAauEIQQz0fiv2Ng/Mwv1YkSq3mrNrQnALV5iES+GfqkWj0KFKRC1XkEhW5wClXslDWUIMLC6XGGowuadLvG5Ptyj7NDtqn1ec6+/SW/3jEm0Ucf9LYW47uIMmLBElWtFVPjKnKHldbnFLqjJkCDBAHhqXIxJ69GYCZfJwcIuYszX/qmWPEpeR7frH4xGqWV/fN8h2DZvnOezHL61u1SlbBqkPq55VgZVxX3fkqvBS3mWyni4JmRcEUxD/bLGPSzxkztisK5rul4DXbhYJKs1hplijN2iNINYYHWEeSSi3/tdvV8kdim9V/T/AT9514j2DXbR8g2PXbd02wq42ReC/HKJkSOvpSvbq+a8h8jc2Zp6JBySXZSFG2+rYKIc3rlOr0AWRUPEoFTJzkZH42NvGuIVW72o+erx6KnvfuzSYGZHvVP58rzYL87p+lZdy6fc8tozKSp8YxqlqN32YCqONgyDyGoowhPNO8PNPdpoCifkzWfaY8phA12kdaqZJQiEKwEkrb2lC9Swii6rzVfTObku4wbsN40n82gW9U9n2rrwybzT4KYZxt3wqd6jsDACw87GAj0jQMGyTzPICfCa/dsP3nx2s3bv8Z8tpNv2G8dvOvFa8VIKzuiw7S9RhH1/u0qteDD/FI+lZw5WORfWD1hhGZ6eE8bGZFo/4tovgG5iYouEN+OB9jCNgnSR8imNcPpaAyF5LhH15gdqx7EMsgMd7zWHCTGEL61iIeX7ZL4bJZ6iwHS7XtexYvHSMX15XF99XyMd1XV7Pn8iTPLvReXXUvpWT+1Zhy4v/r58p2tZmtqYb3QnZM+KmRO3lA5bggWqbicZ4t7yylvSKrUSYuRolZLDryDSsK+KdXvQhtsZiz1ZbFYkLQiKp3tWTiT3eCW3Sbyxz7Q9jjmayWN3bkcDfM4AuLPCVL+YkBJojLgEIiBV0ugJh2uYwSCTC4bZkJOTuijDG3eAzTCOgiSxUJLg3Ag0L5rGr9bqflIQL1kQkFnoVReBhw1KzajA2Ycewygmw86gCDX8UZAQ+1V0xSwMC1n3mwLwafYdDeSKXjVLfA9GnJBA8UkoY/c4qPDloyOE537qBYr8jKbZGrXFj3YdlJHv0W9z7SKh4tJrUH+RCrjrGitQ49o3QeSgyZCg1EeVjAJciTcdIEqDnBdTv4zk8G9stkvtNTt+qfH62rZmmsxy9cnHrMDVe/sj86V96m6eoJl6OGpWmyZ8+V4N6n33SqWTrV3MRIHXvm009dvv7aVzJJP3/Z2XOcPP7y9XM1nG8t0xQAN70toeJj2+tRcfbsuWIGEZcAP4ameNd0rthPZ2L/6v7cazFbPQDJAd68yNFsuvc6X8zp6X7PUj5tK3Hw9YfVFIG4a5QouDyIxsHvPDENnUoL6hV5s6mZ1MwEBUWZTCvuIBeZyAAdRP2TTiKZ55hyyusRX/CQnXfYF5Zdd1vtvP0OmAiJDjlWoO6OcqhJPtTEomo+wCdt8MkEJZCKxJcK5ZNIP6V3L/i8eucOBa40AFOBXIoUeCinqfyhYmsbIK9at/NJ9SW9aqfgfoct177wdhBO/2I615ekW3QZkJDFrVgGJHTAJSX/XMzrV7VNs5cUBVkccrVWok00NdCUm1X7cxWVqqKPyqfW/SuO0VgLVl5bWS7JOsZx2zrKGSXkYq+yqMzZHVNXFdnk/xNuemHBZF5LnddV9YRaVArUpOmByfXLmODRpEgU2RgZEA/JqIwkZLGQ6vH4AEtf9C47HhxA8gEBjKnB8Ez2WxtBNa41Ct/GqiILS6toAnM/IXNfynPEEbIuVste2JEYk/U7irkjq2hqJ+iA24yePdpvkauCnDCxPqnBBzRzO8VzSnTAyPsa5B87LTEF42wFkMjJL4s6Msp0IrD+5wDjBnEcliBja7T7wmq1/lQIMTVt12kmaXwh/+GqKiJMiiVovA7w74BGidDoQC4QsA5crG2WVpzBFQ+QQOtnXFxkNKUmA62bpqifhdxwrrCKLXdkgMFwvZSwUZTNi83qcM1akcPyrkImtUVFl+hdbKYYS9/GDFo3706Yt/OzsTz778byrNqt2elwb9CXNCFPvU8UGWMr3EHTqlw8bfevSnIZucXIB3WX6As3JRjYC4dUmeXZGSumuI+mnpRoEHtK/B25uDvZ1LDwMhPRpsMGSmjLBJhiAtQAtl3OLMrp2y/j94v9SbCeISWrNlTaN/bTVtdczrBKxPLjXdtPJqQoJsVVLs0iSJOJjA4SWcepTLITFBcejX3K1fAAIQZHJuIsKRgxkJh8yxnC52Aa6zcvuxQ76Oqe5WLCvDxlIICKqet3rMykAuWhzaY7g0A5wSdbruqVcD1bIMso983KbqeoDbQCJ/7eKEmAzq7kcDD2EDqDcgERBr//6BHbbmoJG08SfEoVDFttfaTLVyHR3Ju83Lyf+zAvd3a+kSUCKTpQPk41JypEEyJEEKDReHgw2kPHAX4LLy43UjUJUk/KS1MwBOy2ol7fsoQToWm1rEl36Q1rAVOzCs4aKHM8BhkUYkvnbtrsQE31eGp2E32i6F8+iD7anjPIewp0HmrU0UJoCMLm7qItFx7cvx84vQ/BzvwJ3LaYA0mio4NvGTX6prAqNCw/MkgYXZELRSRzb95OKh4V1U5cjcpmh8EF7uLylaighajKUFWl2m++N1zgJgxzrQP0qdP2HwAbHEU7s79FUzZgtg5uZszDXkSz6PaVIJd2Ga764q4isAapZUHM9csZcarBFKyNaIaZYgffCIE0WGExfOsN6gIdlBXMy0NkJKXAOpS97pLBzaiiy6H8DqWuQKSEwR9CM3LjtOBMAe24BbrKQio9BxO9+oNLarLLsqPpfka69JTtjOtP50lIoAxU2Q3ahcIePe0Hy6frdU44VRh++1SFR5Y+hQSpQDxODj4xyMmg9EcG3Gl0AuvCJ3ilfN3GhDwrdJsta6tkMX2XtcEWW39CheAHUuvlpT31bvendW3faN7d+ktMDu71z/K1RVClnGNuKMMr/rtH4anH3sSP+FL4+3P64JRaSFzc1aWot9Ez6NT6ry6sXkRiNqAgyZJ5+g0UXPdKLakzK8NNn36Dwym5lmIY7+u0IhnckF3i64qH3Sti9MtN1neMdL2Rr1lYKeAaDnmOqAn8ObIN3OsgTiDYfK80xGDOnsMkmMYDuJLBrVt8+h+oG8BDKBAhRFBEcbqHu6sAb+RWwt7VruNkg2V4IG+ZmZtzwFdmZmb4vubKX3NNyow5SkrrPSwzN3HurszMzMzc5Pz+X7LltZ/LXG9AKxiNZkaaGY2ijM56r87OSCBo6nRaxTN/0dOefEhlwTPQCInkdEzebf328f7u/N8XMDfV0frdzAXp2sbSx919z4HL7vx6KszTb9X2oJCaGfjxITvpKA7GkduyxXfJb7Jh4Ffhdbndd5tv1+sebg79RMavTs+zVBql72R3p62Rj9DFCzzJBn6kQTJRBg/eieNJAyO1x8g6ARhWCYzUj8IQmrdD15xWGKxo69pab72amoEfK0DpB0Qt0ACVKeZCoKFInFrXi7ZMRVo2V2zZrFp2oaXjsest66wIgOqWIoCXKwJ4WQM4GgA4FPNwULed/okKK0sXrHv9FIdnb38S834e66xfwDrXM1j2f/dUBMtuZ+2/DpZxT4nGfd24FNxRohHb3IjGsl2dz8w2SP7cO6Zn6jn175SJhsklfwT4U+NFW7ZEWjZXbKk5Oxotq8sE3fkFgu545QNg4byDRQH7uJJsM5doOEAj4UVbtkRaNldsqQfQiZZVv91MxekTHK/Sg5CxjB9DH0jjl478xLn8CbOMGoVx1fTY8Vk/xi2tOJvYGlWzc2aKGsuL4LTMQ/MF+IIMNQIuCCWpRjrUxFy4juBQijbWrlCSWhnT8gPOcxzW+u7h+6GZ1XimCgo71K8ymV9uttSj0YqSJYv2kXCAvL8eEAqLZSjC9Pmpq/DPW4eBSAmfrF/AJ8v7+TONQ6ySwIXjVPoooucNC09OUeWzJlvvkh9BDCNAxsEHiaVPnXfiGiGKqzOQjIxfCV434Bl7Ys1tOGCNsyWrNcIaCsGyn+nryoX6jjtqtRDFVSVgFc7IANpkifMPGIMoHwNF169h1yviD6RyDR04xLfBL8S/FMzyG/12aNteVGUORlRmf0WVqVc0m2Hiv+WAubiYw9WONyUep41ndVq08o6qcPxFS488uU0vibCov5s5KSe2yhvQg5+KLXgjoH5CX4RS6CdEKt35xEPbrf7MG81h+r3zlzj1zTe2GwhUhfToWVdv/dq/7xoRpp/Ydfq8gbV4NgjTU75ubGpqOiYVIL3ulvzcgewgGdPb3zRws7kqds1jf2fnl0OLngw79IlB0mVGIrL57cBTrXdilk1aoB7RrCrAT4Vkr9nmBzPw7iKzMuro4UdRz4SQlyADrB2vuHEdM32gdzDHlIAv5BggD8/Bc0HofdgHl9Hi7DnvA/xv0dPhm06f64DpW2WD4TmQ//iqJw+88+20/jB9+9XX9V/4YXJEgCbDn1rDtRuoYU1OXb7Z+d0bH33uwPDHzMe5Oygb/LAU+eNhJiBVxR9Jjz50aP+VCUIE9dkP8M4rvQbgUsu2MUu0u2NhZrblGjgXrklAGpVoDlMuI4o8pOfH+r1+IXNZo2SXnRnQ/hCGBHvo09EBkDKZ2T2pRGNF7anxY7WiciSmsT7OB5hn86s3701RhSmNqD5/cloXPTXLuI3bFj3YXD7xdVfUEPHt+Xl4AigQNH9xCcCwI/bKJu0h14ak1Xrf4Umbi2kMbVBRf77KxUiUYkNsafMwA5ooTAZzYrPozraA3x1DDsSS7vDU1lcHFsIpO+1BXji9Lyf2u7xNniid47NFCnDWR4UJa1BGq7uDjsv6FGW559pzfkUpU0s0tj9v9BOBX83FGytvoNZ3KTIRMLGWYCLgCmaxXVXoUxhrZBUlsQb1LrrziIer+2amQsof3tObjXhptk9mwKB6Udw3bo+17koFIUWw9sojzvz3HR33p7bt8ccsuO6jKSV/yHe+Hd/b2/tMqkfJ5xv5fL+GcllDuQxCDK2IPbEE38OPlh5y32oOgyDwclE+u/8APmvmkGe7XLTJ7OnHNM9+DfsTJOCcR933HEBVB2AguV6jeJ74aTz3NM+935HnHnnuGZ4XUcZCvPISnzR9Nmvb5pAYB+knLu+7d9Uxtyr+B17Wda2jyXgKgN1Sgf2ntHRqJl00w9IsMoGjKEfIBWNldnd1FtJnd3dtV2cTZjTAauSJS1wEZA48jUkAM3KWtI1QVTBomd4UZcX1MTR26sudnUlLCdr3sDqA22UH0s4wYByaNRPsD3ynYI24oR9Hi/uGSYKHslAbivJPpALppmtfGAtu3JNioJK6RrqKecu+mJ644LozUic8fOVXxx5zY0pxburIvZU1UqACgOb2uar9vd6bAfTeJxdf9PiO21LUOWCpdAErrmDt2dw2CTZL9oGRjxw6+2bXZwELFfwqMjwu8csKAzxK6Bwllbb6kSmOh5xW0Zwoj85o6fQTbUvRPox18O+aq5cQg4wSyYSyGuc4pHWOQ2/07XRs1W9ntS39JsbouxKVblKVLFTLQzriuNFZVTARBRlJOCoF4Q8YPEwvu/ddPVt/trQSQJeKPNCktdNWAUWFckj1PPK9PJ23X3bTPJ1tTpy7428cCuqF6SbrkwWvBc05agjwTNvVKxi/lbtJB9iID+TLCLTkYPX+ot2aeyl7vKPj91hdXhcblypKttOChxpohcrRCKwqts1ugBEwGZvYYATu/rMHoX85Y+hjR2dK4eWmtsAX/VPVHa42j5V//N8O3wEprwUBQW6XqrpQd0aQkSgbZBnsclJTS/MhO5wkup/ekp6489XJl15zXIrWU+A8ldj/MiYPvePYXH/2QSY/Wk0zMwhVAORQHdT2Hrdt0SVG5/11fb32bb7V+t/DGJyKPtIqkFC0PvT0LWMVCUXrhNfv+ELgJmIkz710zBCSttpR5NGNoar16+JmA1xXHqu23NQtcV1jKJatXevVCb7qa4yvey07DqC57aKB3E3oPHWo64Awes/S5gWe9v5JoSa6vtW/gak1LrkpNUYyLr+4fdNjINm5Q2itbJ9rfKc9Nmq5LO4bxJxpP3Mgu9IY3+1JOix19DMGkhtvn3OzlW4d037WJYuPOHdMjx8fw84RkeoZK92ec3VnRJdGFn41TiAx2TtBOV7IOw7KaGrnyacJs7GWP06iDmpQnut3Wuc5DIosIZ299+d/rHLKYgfoirED9g4lPEFJosO4gWviBodIMWpAF5iwAVodwr5FB9Th3IeM0lWkhTQ0pk5i9CZQsK90dKAARcTQYakOEmgwo1SAwXcBGsBVlMA1UYLDGN2zoIv3kZCijrVwpUjHALDVIYJit94FQnD6is6SmIvVljp56v+LXtGHRI1L7pxwvKMV0oznn54ltlEq4po7ZuSQVNKn7QYY1XECz8v+iS17jCyZyCjZdNmlnmhc96RB7NOKcoU2+Akhl0buRbn00Z4pM7MFM2Ydu0Te9GL8DnOXghgM2fmjwzf6Dtq8zBmJJZDCmD5szSNX+mi1d5tpg5QIZMjlQD/phycNjNp3lb3gw3yy/6N3tPbfCj8qveSLC12531ZNnOU9/QPwbPaiEzVC+2TIzUCVGTtFupmJUmSCKMqycO+ZXhRIGa8GGY3j+eq9rf18gYXW/rl+vumGQt4GO0y5/CY37/dHvDkH2JpiIAvVJoV+KnlwYbrgo+m9AQCQjkpV8uvCdMGTow4pGibdSlGKH9gpiJfvFDh6p8A1Mhov7hT8AkeVWP/ejqobZtQone/x3N0yz935tZ67S88dHYq/MkGIoP1HUiQpzE6BKNkpEN7bTpwrIr8F5lpxprn5KjblL85lF6gG6vBwIn8vBktqpM0SL+PXytpd1Yn5BH6xuNcsfLv6ddKOvtaP8hvMyoiPFFP0hNsNzp3hT7G4HppgStKuUFI3v7SmJC0yb9coQGeK0ou9yfx9Cr1+k+mfaDaWvDUoRRTvLcmsKn2tKX31iq+71QnvB4bCD9CXNh/k2iYXqEuLD3LzQ7BKhwC+Va5dgRSRIc2vGleo0xSpA0yTgjiVEI509hTXFc8D04DBDLJcMTwTya6VbpJhO5ng/nOMvxj2qOWba2TN82570rL1eWDv4f9xZtVQtxNBeHFr6c/g7hXu7tKgOXOzs8metxJmNzc3OB0tNT0VfYH0BR20eH8ONFj3drJ5rr9c25HvG7364zkvfoMXdF/9/OChn2C++OfTHy5Lf67n/x/8g2678uOb3rvvorcuv+vaLz+977vv/3rvs4uG9fz5fSr3BBk3jhJQ0JBjBEJ2s4LB7sglwAlnsWICLNcQwTD6Yj5TVjk6YgytyDP4IilgBw4j5h6zeC2wDrmje6DIC+iGmDHbGCAyICSPriDBZIOO04KRDgtjoKTeIA62ICdiW45banNkVUMRisPWhTOAZLVxY4EOejkY6zLxGtHhnKunKUB7icvQRCwlScfARFPYolQKtoVqwTDgovfk7oGEWxJiD9ihDereBewwQS32zUu8xZKxkwRieyAJiPithGsPVl4hsAVY05B7tUHdIDPOTaCpcRS6RZhs26TMNnTqmlvvKjfm6K73hU4QU488gPWFOd1TT/e/xiOpd0fUjHlkOlRuP6YMfXS6kHd9vlnCoN0QU7FZS6ytMcSwmWtdl6YgGJSuifmdNVWZmg2BGZ0DKmnPkwxaKc6TFD1ltu3NMPW27QtMiTMtuIxt7dBYqHtMBSVQTd6VksGEQshxCmAD3GJCvIV2LQ3ilMBHTUfn30UoWGjyMjtkWfZAtVL7pqOcrafrH33uxUefbZ5/8YUXX3vxhacfvQEMWkdaHTdIGqV6WgGjBqGkOnzOepsl6ztuX/5Er+D5R1RtUUPMkc8ibJhs7sFTSjIeV16TrlSlBk00DWPoaH8IaU6Z/B5jqNbXWGnisXDFF1S2Li+qlkKW6R7r0uHOJsAM6/OJTcsAUIhjJ1H5yLNsI6gtjAPkCKqNbvQBFBiO/giGlWCY6lwdU2IFE8lQpptPbRGiptPpGbW1gHUpT2237mmCuD28wYti6DFRfXjkCUUKa1N9Fqy7j+uTWSV16Dcab3yh6lRmDElWyIxhGfc6Yh4PMmoXYFGsUQOAMQm7m7BQkAZFGDjYTShIw2IQl7C7VlJ6CYNG6cainGWWbgQWTMClTJgBDCwu/3p3eO73N/sUM+/EOYc53+SRf0aa0eGQX13nU3Sxjhy1O3mUvyrfR/+mBw0kCnrX/5M48NuAHukETXzyqM1h/lJ/tn1WUktSiP8bfbQ0+oBo9IkVQ/Bwk5gsmAZdI1P+Y7YPcDF+7T/zP2zbGWG+a5AogdW+skL9IHia9w2ERn+V+YOu654RzIMb1qx89BMTXN0jLmJCsBtbCMkh3guRhKXsf+YxEDfZtuDc2RbCWT+nJf7QCoHrIP5dzitjcQvRYpcd3e3+FhecpRE/f+6mdWEzwdNeG+KwZCJbMBNxxtJiX5tmotZ9706FF3MEefO+/uvJnp6KE5sJjSmufZ83twri5yC+08FobyKXYIQaeJbflxSsH4s480542w4uEcwsa95nukrgTMQlOwo63zcRL2Rzw8QvrRY4A/Eb7XPMvJsIyH6aM7d63thcB/HzT39tWttEnH11YM1Ks/mC/CURv+NQdKeykZho+M4ez5Kg64Pmn5ZmYddI9Ce7qpRLSND1+YLkn/nDd1IjYWs2abg0ebVgfQ7irFOdK+MaiOkTvlwlHacKPBbxhkehq3QaiGtyX6Lz1vfjY3Im4jpWzgvznxJeWFiajPE0uj6IM1prMvrriZVZnpG5q2Xp+iDeL+MiLF1PzBwBQz2FBXR9EOfoOUpZ1BFL7KufBBVI0X2BeGx4xVBgLaHqHmOvd0F6bM77jNRH7rRncQ0RmOurlK27SOAcxDlM3arP1YQtqw4O6xZggm0int0pga+oJj4WbW894reKPSZnIq7/JdJsfxXR1Vw08WWjDN1/iDdIHo29VkmI/nx9jWCP1g9x3szx3mkVhMnuAydZr8fokuj2F72b8aycsO18EPdX90z6+EPrk3RccaSM2Kg/M2ZLtPjYnDeI5H+3q2d1GRFoLszybZcUOAdxZo2T7L5SAjuvZlM0dYHWmDwWcZa45O8TJYSGofQ+z/MD9PiGeL/E9/03iwmR0hMLFP1X0vVFnKHQIpNbRNyKm7Uwnik/NtdB999w+epzDvHF/P2NWw5iWmNyScR5r5WCegliUCXOwvDMKrq+iAvJ8vujkMD4jbJOVUZrTM4bQI5f80BDK5yYXGhtYjx1GV1/xHm7NZyDC4jKVPP3ahtXaY3JYxGPVXq2rSSPsD+osG/t5TljcybijB6fpv4c4tUplaoNt1fT9UdccjIIL3lMGFuV25iPl9Aak+ug8S+59XzTQ+LNnB+1r6zWjc0lEWfGkeuP3idE4wLPWl2eS9cf9VkcRbEsIihgvVu0qdzYnNeP+KITbZvTiL3Hn/VcdF06NucgzlH+ZnI6iSDvDqpu/72OPSaPRf3vfK/oOCL179Vfc8d/xcbkTMSFzk+PcI0hukWvXl7NXMsekzPQ/FqEl+TfJjYm/gwx9F9D9xe6/u/sZE4gEZnI/XZZ/A0+JpdEfaajDO8a0a3zahp0LmKPyYVo/x9+Y3IOhbj3mXkzmfBeNirMsWImXR/EmSEmByVZ0DTUOdm8dfT6Cl2/as2qXXdAdaqZckGsDB0f4jrvvC03xcKB5wMWnFnj6OODRNaXb860jYc1w+wzp+avo/ePOCdmbmpoMlxZbdZw8wKdvw7qbXWnatJBeM2LHYP2i+n6oT6Zo/QxEy5pVulpz5oucF4f0t/bGzVv34eI6GkHLZVHz4+I8xqTvrIfwnPd1wlWlXT/MRCPvb3P7MNjEF9miU12oOPXQZzzUYwrlAvKfVEp/uK9mGAm4jqmllYq+fBqB1vDYtYKuj69SHwZ/pV/PYEe+yFZJmsOHR/iOvg4kxs4cNPNyhu3j14fIi4p5raxohB4295m2XPk6PgQ573eGPSegGGxu3rPVEfHd9SlXQMWFMGgsFz9eUqK7v9PyPlrxVXZ1CJQDVPfGpBE1ycWcabnVJvGYrj76HqNU9QEgTMRZ83L/n20BLxP7lmRrFCOCeJDPFvFTSuoFM7nDBtecKPHd0nU73b3SJdBxRWHnvcqdP68j//6TL9CXeNyOC+PrfN9Onr9hPjxM76z+8uhQyqyx3/W6P8fcf2tHv7eFTBpS9Dxmbaj9x+IC238lFVYCY3rPqQaagnT9UV9qNXMrAqOjcSarBkUpsdfxHk+WF9INThIHdTfcpIeX3gfkOsfc+MXSjWQ2pGu6682VeAcxHma6l4NNZAz29C0dI8cHT/iM/vLfx2rhSbZW2UnewdwQfyIs5qzte7XgVr2vCGZERk6fnT9dyPTD9SD4pdNDOnZxZig/ogLtXVnfK2HWQFPjs6TqsYF8xDPfui0NOwpKL6ZWt1bs4Su//t/3WQfQ/1EAwTp9s1/HfmdHt8RZ9jYyZU2wIeP2HzfhdL08YP4+z/HZyMs7U84PF2K7j8G4t/TaywcG+H6/IShuvDR60/E7c0OhxGNkMveYdCXOHp+RTxvuvO2uU3wsWB7QbuXmMB575D6tV7uL2yCLxP1d/+MlKHzQ5zB7RiYy4U8TIp7sZP+/8YiPrPwrJ0jFyrPDWTXucyi80NcUeXc/mIuWLAn5xhqLqT7G/H3LSseLWqGKB6rd323CJ0f4pUniv1PNMOZZ3ai9dIK9PiIbn9BNK+qGeJfiC3xlpSn+x/xWHXhzOUtYFpx5PrxQnk6/7fI8Vl5YOhSC1A6lmRfhgSdP+IM0zfslhZoPRovIjNFjC14zWqnI0B1/qvxP88VzhIamtF4+NBUNvufj3feAGYoeKkTJLvg6Z/XQgsa4u3+vJWhk9o8+nXEylLBBxOPv0z95xuKWv3tTX8+q3DX0I3gPTeC/3pedCFuLNbTjMDUVH6laH2jwLL1ReQcxgnchnlOO7yXgkZbr5kXrVi4xzWX9/O6KJjzzU5tf5MfdtpjHjf7JQU/A36sYNb74u3f2tY6NlBgU/nWRneIgVVGnFm4rYKCMK6KeXccC3P7XF6tXUiB8yU3y8Tw29gM7x9OJo8p+E0NBy9+HIAN7TgpG5zO31+kwnGtQm3sXiNXuTeOgikuLG/VCX/hS7h/Z9lGUDCdrSCz/+BN3MB8dsO4EAqMPur6UUx9vFbJicP2oWD+l5b8FVVBOE8uJTPclYIsI4sPXVwmZhCQUHnnIgU7QxI+zlvCxC8ZXMHyTlKgpdxu1C8RiH/091P/8RcFxIE54Ofti52pOfbJ/DAFqz/NOhv58hbebDHRnWdOAUNBQ3uoNxxLzbdX8jKkIErds8b1XSC+7OXv5fr7KPAvSdy66ZgP9szv0A3N7RRcmdidPekiE7vVeiVoF1AQmpzcNRxwC1M/dMblojrfd54eXGjlhUHiA716JQoG30nckd3BxNoudx7dJkuBlcgJuJR3C79++GvHm5UUKKWJOncMuWId7RJfo8T59SeOLY6Q0sJZL181XFtIwSOxqSddN/hiUyZ0J3rMpiCwpt47eK4LdlBBOyVrKgU5adn7zuxzw+blKon9PZmCvafTO8dt9sSUXuz9fXwcBbu/cy03tgViI/OPPBD5TcJE8wBNZpwnPhATbF32jQR7/T21fbuD8ZoUjQ1JAyQEyBks+S4chtu+mOSc2UtC0/pQ7feNJ/ChmB7V1+9ImLek/uGiRWF4T/KcErkuEpz3yiTtjPHAlqvO3pvYToKPw5qLjNkh+FJm+sRtr0gw916wMzDJBJeRH5ISe0bCkvBddhHrLuO3k/Vffm0kYVZ6MaPv8BZMztuGIVJPAnVksqao7S3MWGhZ36ZqEi5MuPuqo9YFa8CKHt8rJ0Fx9gwIGAnB2rnP+2VKSMjOuviknnUWk5ZZ3/KKIOEcz/ATe1kINq1tOOwBzs8n7oSQamggnrQu6uyDfBJ2xYW01rZ74Zttn957lUOCtfoMdnn7edxVL+qg7CMSvllc6t0+2xOfEWxZHX+fv/7z4YWT1EKwV9KP1+/IImFShI9C7p1L2HDF7ebZGSSIGi7t7DjMwtYa7mwTTiPhY/kifY8KVSx3u6nP6hQS1DhHZN8qh2I7pTLmHUsiIeZsmM3ubj9ctPVsfkcCCcn7KM0yFT/cw0gj+2o8CZkfZL3PH3DHJUtqVbfHkWBicvB8W30Ivmq5kav6PRKOLLrKTJ1pjJ1K2dtsdJeENcutCOphCF6nec02OpYE13xVr4zZf+HEqylnZvOnyRTnPMruMK6w+Cj2IIYEgxs8Q61WJu4eavDjCn/6qbbZ1SMS5/HT1r3vz/Cns6/4cnaTnvjp6wk7w/nTPm+NxJUXeeJVdpsPfuJPc5tFrWoiWRhYtus58Le/LGFffqvyJdxr3KdTc/nxOHLsDId7QzHlIsVxffxpI6dnaR2fjmKHdJ+u/8yPf/PThwpld2/gsxdrG0rz81XdoDmQ4xCCz6nfG+bNr4f4yCINdysmnlGxYvtifr1cjE++0G8OxfuCt0a8TCZByGe6uV0GCwuz9XlZkUrCo4/9RQq5/tjrWJnNPekkjLwri2TkHMX9tj6er5xFwlbrz6Zu3y5h68/NC8u8T4KblniShGgIXj4SNMX8EQlrxZ1881Is8Z6yuuwNuSSY5rMu/1jhhM/YX1mztYCE1B9flm/ZEozr67bHuLJJ2BNg+9yp2gMvEK4+PsAhQbo+SPZ31gmM1R/nGlRKwpNTYh1qTc7YihVdiw5XknB4+aHlE8u88KM9lpdsa0loUers8lzqi6nI7e6NaCBh3hOc2/gkCLdcpf1gQgsJTUpkpFItCzN5qDgn+iUJD81Oubg7uGPE8AUjx3Z+vlEBt+veuOIXP3MJR37/eanUBJ9b7IdlcM3CYt6T8PNl4+7ASyzcNsd/rTBJQkFm68GXJUb4r3l6efc+k6DzLVFrejwL1zDt8T/5g1//kAz1L8/s8R1WvwbPjpCg5mPi2EkG4bsn31XMnkRBXZu12POR01hT0R6W+FQK0u8E//zFDsJFxZ+bF8+m4OHULMVMl1NY5H6PtohFFIQOx1godwVgFxtGrNMk+cubijYG8tyxPY3G8gPSFNgt1lXPqjuMPX43OdRZgQL7RcFO6xztMAcW1Sq5gYKmx7VuC32Y+M8SS6MpQMGxnyNgmRGIX/YW3i23g4JdKWfUM6ex8EHvaSJeehQkCWslesSdxrzif7UuNKFgxnIdyeggV/yOW9X8LgZ//8FFLfpmAZiH8usJbx0o2OM4Lt1Uwx1jPBr3WeoUBRLaj4SlWlxx64hLKrcvU1A1bYdmvow3vvbu17nbPSng3tBgTMw5jX0D33fyLApOnIwy6C1zw9z2VvwyCKegP4gbOHsoEH/Fir+XFU/BldMrOu9k+uMDdgFyO7MoEJFM3YSXBGDSZjbkkgIKlD+llITKumO3Cxw3yJZRQHo0KqUc8cF0trmYn22goK9Ls7tgQwA+tzAyY/g1BVF1Qfs0vc9hL1jR14veUeBdy9hUNOkANvAfxFsFeBs7s00pTZmZGf+8BeNrvatQ25SZW4cTl5mZmRnDVGa2NykzMzMzc8eOxtfW9WXS5+PJzpmdOSPF/SRv03N6tdTXP51DOY7jOYETORWn5jScltNxep7jeV7gRV7Fq3kNr+V1vF7gBF4QBFFQCWpBI2gFnaAXOZEXBVEUVaJa1IhaUSfqVZyKVwkqUaVSqVUalValU+nVnJpXC2pRrVKr1Rq1Vq1T6zWchtcIGlGj0qg1Go1Wo9PotZyW1wpaUavSqrUarVar0+p1nI7XCTpRp9KpdRqdVqfT6fUgUQ/l9ZBaD7fpwdWsj77PwB6hRlO3sO5uDXnOaAweMCAwyNSP5zVGY+8IU1ejnfdjArTwc5fA3r1/MULgIIXp50FQ1P400Hphf+QKFwLn6ukzEDzfpXu4KTjtAaP1WmPq1i+wi8kaHN63KzwgtDoFx0ehNofjk02rQ+zVt5v1YSwNoQP/3wO1llNlRPhb6fSEWsXNeYxIi8tCqFXSIcOMY1++w9glHxs+XL10UFUyI84z9IwykBwR4mKG+q0mV0dV2j3okZms7BI6zW9qe9KoUoN5V8auJMN37J0/LtstsqPQ9PXVz7wn/8s2yJSnwDWCeYceunkp3H2Vwcct5ZY1/+0Cwd0yaoqRp+kr+m3L1474n2t6ouD/RpAt2Yft2Dp2BDEEr0l8FNOApAt3L6b5PI183uzeyvfhRlJgR9zWtbFm0qRj9wzciPn2/FeXrUoo86WKNPhkmXZvIf+kVR0f7OyXi1Q5Gb+0znQvoi1cvcHY3S3JXSlx2vTadcgSd1WUf6gXMSa8zCxm70vKndU2HtJuBnnIe8YMPTeZNHvqOaTrqzb2/G98W7w783CINDpHP7M35FdWT/+45VV6EpLUc7h2SGVya9rwQonrePItpU+cf7385MqTs5N2dVeTs9U/5p/d1EguXo4+e8GjK0kaU/jSoM4dyKwmDd+s216asPP/2rr/l7db3g8Mj57pxyn9Nt1pdmLneKVAnw/kfvn9SqclJ0JPxN9X7h5tdy2+eggpMubCiaCZZrKg45a1i1q5eRVZMq5Xs3cVvNqvKtL/VKvyXoWT43KaPuZJWRAZVdTn0+Zdz4e3OWzNX29VhkP3ipdW1m5L6NL1bZjSqDdv2tdnrrI04euE2xGxyvo8bb+vb9Kc6D8Mvs+XWk6qHAvJUSrXSTL/5Pbkrq0ekHqaIccz1rtMMkZ+/+LZfb3S6MD000nH1ebmT1c3eQz5v19ML6b2yKtcKtghteeT+orxbOHap8d3Ud4Va2/cFtZZuRN++ki5s7WJ9IxXHuccSxYNmebbMCKZxDcvEb99xSZS7/qZHIN2LiWl+KxVetwLUE5V3Odb8eV4c+61dWZOk7ZbLjXcYRqT0V0ZPiMi5VaSqCTXzX0tpoqf0rTbcb3GqFa+h6weMGmCgWwvPupyxPLu5H2k/7FMK8eTKsqZOhWKjSdnLkg1Ow4LJp0fFLs/7lw+Bc9HztaN0E8btTpqOxL63Q6hZ3xqb6fZigW9bPSaejab6DHaZr9M2Wm1yhThvdVWrlFf5Q1Rfftn7k3tBrAXnjzTvgHb+9ATs8bHbUYEty39YB+3tl7mDTcVn9L7Nj2sUdndt8uLNoFN+zf0daODBwgAEaACqAEsp3EADi1zjbE6gB7w/y64GoCaAIMLTgLIAOKC8wJ4A3xccL4AP0AtF1xtQB2AvwuuLqAeoL4LrgGgIaCRC64xoAmgqQuuGaA5oIULriWgFaC1C64NoC2gnQuuPaADoKMLzggIAAS64IIAwYCQ3/ie+7eucYQCwgDhgAiAyYmtTETbKEeXrzRZtNA6ipCjR6wjP7W5qT8LwTtzAzoB8gJwdAZ0AXSltbo5cN0BPQA9KdfLgesN6APoS7l+Dlx/wADAQMoNctJ/Q/4LNnLqhedWG+C1/JnNv0H3xHY9YucDqy39uv4dqyUdql2zWfc5p2xxCYW2Wa0yP+i5LS5s8SMbX2P/TRu/9cMBtBbqt9A4C73PgnWxDs2L9SxUj4XqtFBdFqrDlqfzjKc2HbeGXkCLfrtFP8ZRP/aLdbFv1GWvg/qoDtSHfWOf2Bf2ixbnCePwPuwH89nroh6sR3WgXtRji18WeU+m1sJY+bd47AvzYr9Yl+qw68K+UTfTn4XpD62FmR+8D/Nhn9iXvV+si/WoHtTLrif7+4A8+jEO/VgH+8G+MT/qw7o4Xzgf9vVkfr/t88F8PizM5wPXGXVgPayDfaMeh7o4X39t6L1eVK8yUZJ6fvKtF9u7qXnfqHbLxnxrb35/wjTSs2pLKalEQOv+5X2lKwfH56t0RzZr67b6FFC1iXnfxMxvZ71tbO4woUXAtmdGacpQ91o+JZpKntENrrWv5W8+WqFdptOqjhK1ZurHOLzPjHWxDual9SSqR6I6URfqkBYYm0wpGtpRutLGc2nLJm3M1KLfjBb91KIf82M/mB91SVgH9eF84Xxg39gn9oX9Uot+jMN5wHqYT8K6qAfrUR24PqjHbKnuLTz/4i9Ra2as9Fs89kXzYh3sE3WgLtSJutn+zEx/aNGPcXifPR+uL+rBfrEu1sN5Qb3MeqJFv92iH+PwPqyD6459Y37Uh3WpPtSFfWE/9r5pn+znw8x8PjAv6sB6WAd12fVgXZwvZr/zn43/VscLC+Mg/40OD8X5Ojf5b+a9tMJc/0s68jN1VIwOjvw76y8wdeowOsg/pKM4U6c+U6c9wzcm/8z6E6ZOCFOnB8MH/E06yjJ5OjJ1BjP8KIbvQf6e9fdn8gx0rjNiJsPPQR4D/qSOikydzs55yGymTjxhrhl+Bvlz69/UOQ+ZxORZydTZwfBbGT7yd+qo6hyn9FOcr5l+R+xmdJ5g6hxidKwlv2v9R7Rm6ixwzhOQyqzLJUbHbabOFUaH8gs6PJn1H+kcF7nFmS99xZnnXjL3v2PqPGN0nCDs+uP5BfcxeP7AfQieH3Afgeci3B/heRj3xXiewX0NnkdwX4LnSNxP4vkN93F43sF9D55vcJ+D5zDcj+F5DPdleL7CfRael3Df5PYLIx9gMKAA4/+Y1C9sV9Ot8hDR+96hTKfkXgk+iyo0vipvfXA2LHbvbblzr9irftUfyKPv5FeTDY/ltR8Lhr3VP5OHDWhQsXrSc/lLg5wPHskH5FzKjf5TjPvlL33b7ngcv1e21DxU7F2F3XIn3apqa+5b5NapS+43bL9Vbl8xJXrd9TVyrtQtGy8dXSyjjiGAoYBhgAjAcMdlB4wEjKLcaAduDGAsYBzlxjtwEwATAZMoN9mBmwKYCphGuekO3AzATMAsys124OYA5gLmUW6+A7cAsBCwiHKLHbglgKWAZZRb7sBFAqIA0ZSLceBiAXGAeMolOHCJgCRAMuVW/ESRnPBmRTrnBzwkO7wBGL8HyQrvADb+V/0eLvJ4UL8bE49+x4F+95+5P8i/5s/owu/+G34UhH6rL8Mv+NOzfhgrAasAq+lcr3Hg1gLWAdZTboMDtxGwCbCZclscuK2AbYDtlNsBOLE9Jf/HlYvlEme84LVU9ig15EVK5uXymNzeHmXGRMrzBhcN3JYQJUf8X9SuMe+i5cH5V9e+OShWDimTrc0B73i58LhAeCXKlddE7Rz3KlkuaRur5Ty2sU7OX2NdvhrrNsi1CnXoc9Jvi1x8f0947ZRnlfeHV6qc9n3uQbmFbZyV2X9PD4ZfrRmV81HN3NKHmh5lMhoOG3IYKm4sZMh6vpzBp6Bg4LP7GDRzWhlevuhhmDhhguHixKWGKZ7bDfpptw0V/PNKR4/Ul1YkJ0vwqZbTWec47c0GNNaRpmObHGYb56i9J/eESjE9nlqabi059nGTC2jRL0NeqpWxzPfpOwG7AGYXnAWgAFJccKmA3YA9Dlw6CvwZ8R1Ghh8sk2VAEIa2x38WbUvZTUij5KTtYQMWIl2CMYVNUlEUa0rYLR0m3e0kbWmwa0o3yPPde09/Ov0HRv5PBYCA3luYrHZnQE6cpxYy1C/sxKY2l98uhmF4xhjbdT/JaIgjxboIHfe5PDM1YoVAE8JflZga/JRv034id38qn/Wi6Fx0CJMMJa58OUzi/N0Y+lrx6qw2GwK0udKhzQmrw8j2ZtEzQ5eGofOMvTCK8crNiGw5gdsMNyp9NRAulWHpmhSuOeij+NWKdJn9fPj2iMVerXRrCxK8/jj9rl+Zcd8KIctTqIwwx2tgKS1xrszMrESj4xLvYqax3fosQlM+cuSiPTcmWXHKwAn/qiFk/jBFQECVEnNxHkf/gdfbHbiezEW6cBnljgUIf65jc4A8JzwKiZx6DpO79UhbPCVCbxSjBIdQ99UnX+0zF9Y0kOGjxvzFBUx3beZ6z3YWzdDBr62E1qPT8D4zC5e53rx070NF0RNxXWOSJhVTIH2VhMJ8FEwNEcOSQJ+lvNujyOXiS6jbQOIzbxKjzqNp9pLXel3cHieFqccAdlfl2f06DlvvHg7cs0BS/BO5K8zRfVVN1GEt5s4p5dVxT7ZsnAMz0mgVmYJ0RSPXVYdwmO7CRQtr4vuX4etXxWz7FNQ+B/ExZwfNheXs1BDGUv8FEg2v2aTbQMPlYJ7NlkU28DNvN5lSXKKG0DsJmnxKkcxdS/u0KKSatqI0cSEBE2wIWD6MztNbSbjnx/QvbSxfacw4x+fE1ldxx8oIF+sKRGTDeX4xEYHINrZ5+nE7PwDr345x/I8/uXtyC7teZ6EYaUtHTimnDjYzP88Rs5IllFRrIBv9jHzrU0x47MnI+ZOYsPQyhZsL+afIBNMHZ0GynRfGCcit+MDgy3GQPcD00DJ2V/xgol4n/7b68/BTAY96ZAkZFUreHj2UhB8iuqSdYxOuEDfTC6Wk6ywLzsdLTRkxMzf2Rp3B9dMMVEvP8ZfESgz/ektHYxCfQ8/z9uNhLqqe59h3V6ysNMgYHMPyS4k4hu9kz14jTlmqcV08lcwPwpxSnUf3Pm1URk1ltNgwVgk5ofBjE8tiz7Dv03CyXs2l2ycS9+V7uS7RzOnQSBLPdvF0wzoqRdqYeUGdzlW+PLB1ol7PCgPLERwJ8sNsvRyadrm4VY1DbbkaW3/fz+o9L1iy0R1R4TzkO52Z5PASGcGrWI5cS6JuLV89ijjaK8kKVx+myaRzzlmO4rJ4EiZt5MxbF45VB6Gwdy0jw7PxFAylXWU3DMjwdU80DvkrsGtazPn6AG7rn8c4dJDRgSdRNWwgWPsq9btPIpnyCaFGXcQ1F7DN/wZb/EMYNz6YsZ+r2Ol/l9qhVWidGctmKQ9sIsSxLs3gUVAa4wyyeNY2khX7ZfiW3EXt7AxEJsUSNF8ZuwAPhHXVGRM6mXU6sUy7nc/d73fYNn8CbvmmKB64Qq75eUboByDc0sUCg5O4qV5EO1EQsZniVBVspTO4kOKEVawuiSBKs5yPMRrEBYdSb+SEtG0DHiebcTqxnoFaTe7cjKNRXJVfAWL9NdiZOvB9VApy9ipYmOewbEgHl9409me3IxvSSJy/Cg4nuxhZKk7fbAGq309j8cNwLKb8jUa5MKuNvjAxOxz1OUm0xE5mjX00z/IiENUfy9Y/y5nT64HXiZEESe6lOHIDu9zf0vwNLq/cRGFNCrEO6XhUVvJ0+DTutypy8mIeBQmeBC6vodvyBsX+HcS3KFP/7yX0t2XypMGNM49mIF+bzO15OnD3EgkbQki2GImcYiKr/H2pEYzCI3YMXptvIjFBnroURfo+DBJU+5Og7EHee+xEIGYAPf/dHHEXZ/DoELJ6glg7qiMvFYhp1tdfeLrL327uhDlqo5qzlcOvl6PSKMEjRWPmWS/i8e4KVEpTydk5SDi3GLXzPVvqbzBr1zJsJjwjbdthdluvwNW8iYvrh7HWTJPpL1NQby1korsVlirvOaIUw7QHBdxU00AoJZyv918g0T2Lv53fIzPkidgIf04ZKLKm/AYzIy7y8NZzlC1FSOw1YnxNKT7ZT7hcm0ecZBYltw4i5LINJTNJZDDDb1ILbwQDmSRqxznDUxzNbqBmUB7Xecl4BS1kVPtP0nKu4eSyhpXy0awp3IJiTyavt1yg41EYo01PMVMnknALKybp38dfK4yymcPYUx/I44ZkcnZ0Ymo/nmGCrpy8F8+D3CesM1vO9P4xhO0t4LaALrkGixCo86JpSRmr5fp4VfIPn9sN8bZr4LJdFdXZqoSfL8Bz0wuc3xXRUjORdJ3fWCq1FLP9VjzL6sQ9uJh4JUvGmHxnqp4R1oVHkRv8wqdX7cz2LmHX2UUINRUx9PoU7i5vuTdYTIhQHt6W+3BNeEC5+1X09npRPN6F7soY5P5oJOlxOims4+2D0exLn8sHnx3sqzrOaHEFDkqJ4esQyjA5Ca4f8GBwMBvzJc1U+2rwb/VETqSnUXh+ANVoGVrdCwgt0qAq2pzE6CQqy8YwIUiRXRYLUTAP4mLFO17NTMN1eyx68lcYb1XGoOhK3nT0c1rXjbeBCnx5cZiBxBiafzxFadFjlLWt0ZplwpTqfzg4IEL/SheUp1axIfEwqy+eZOPsMuTN6sgtfoWo9Dkm707FOcyO+Vt2oL/+B37jx9KRNJ6B0k4WZir+0h98tiyjfvsOHE9fJli9mceSqVhvuswbi0zWBRRTpTeO+j3LUZxaz12pm8xSWMrm9tdUH7jAtY25rAnsw1xggA9/3SFotgZaCbNxDKnD7HMsh+ZrUfLpMutGh3NR/T4xr8fgPGo59g9a8DsWxbHfz9P7VINZwQ/xOrSSC5WzMLheR90yM97s08HxmxE/rzay/YUVXo7hpMcfwKzrFguOzcEw3YzN7kLMkg9Ee1kAQe8+8uHaC1b0GzBk/oWpY0so2nyc0L4FPM8rYmxRJbVb7rCsKJAjxjbMCtRF4a9QxlkfRf53L/wVJmOcM4Fj88/w529BRBe+50OtF4U6+czv+Eq3468fCM7B/vYCFofcJ8tblPB1dcjU2+L8pp5LodJEy4XhVCGL8PdETK7PZPWFEnYfssXXew5j09SI6jzNJPNPzGoVIumqPLt8TYmQXkdSbxyHGl9xrt4aCY3hv2peJ+DWTfZ+d0P71AEOpcbgqraNpTJbYeF3nuHJQIcZwzab0rTHH+D/OLgLuKbWPg7gzwCxiAl6bcUurmDj9ch/mGBN7EDFQFSM0SkbYVBuSIOI3QrYceAZ3TCwAYGLV5ptDEbDeZ+9nzrn+/n9T3dyVP9XUrX8vc7J9P93lTZ0U6RpbVnotkplv4nylao6g1keJipP9/29XFU/uf30soSqmgz50i5Aojp3fuF3PLXR8IybPjHSTpde+I5vvekdZq3oBFRjqf9b/zu+GKw/9UEpsdtck4Pvv+HS11kjLZJVFoh2H/qGP2oZLdkYSozGuUjUvuEZa6aPS7AnFoku5z/6in9OuR/D3UG8XX3PWu5XnDlT+GTPEmKOXcaKzi94dGW83avRqvzRwMP4L3iLVfaOE51KQI8CVl5f/wVzDUPf2P4gfp+0sqP1M64SHSygPxLzhOuKIz9jtwk/FUfjiW+ljJ3C+Yyv7Nmgt0dALNggq20sw5/t6oujjhPXGJtMDC/DYfyHtbM2El8tD84yLcN+6zXXMPOJRXPm/dtYiqtTXlZM1yXuNl9wLqIUf69aulHY3kH8IdbWrBRz5laVrP1BHC0Ll7RKcO5dN7FpCjG7Ytz9WAkOnFWTwb9D/P74jrqNErzU/8vMIVeJ5ZfXT28uwSP/Hj+x+Bxx0ljnTRtL8K5xKz//3ElszF697l4xPuD/et2cf1R54zpttWLc1z3G7I0Bsdx13h3rIpzcYVruO5RYFKHBEhdi4eDeQ0JpOxl+wJ55BoW4ccvIWz+/quwTMtanAC9IY4utU4glnwvzavPx+3LnBTPvE4v0FnLW52M1SULR9BBi+eRTro/y8CQP/6yDzsTG5qfPaeXh2uXPLYoPEYvXPzCwz8WcL1uj3Teo8tGvhd9y8MwCptjKiJh3jHpP5WAL7dvOruOIrVfExd7NxqKVpityWcS33u1aNDIbm3VHfNrWrCDdz3S56JiFSx+PVxvxVeV0oWdlJp4/8O5RTyoxKrM03JCJn07U8pj0WGU/OjApAxu/GW3tEKayhV3MxAysvL13b+9FYs490a4r6Rivmhz36hTxLffuD+1pOEUp9IvfqbLhrFzrNLxqWN6Td6bEBl17+cVi/JbzeAFrvioftKikxHixWWGk+xhiwWY6ZS/Gcf1lkw1YxBxO5LAVqXik+VaLjpY24h7T6LEp+LSNcIfyB/GtH9tsez5hL++9o2ZkEVsbGbhXfsSNswucvJKJBXPrM8Qf8NsJhlqsm8Rih1cbHrzHKby3nkmBxOjZK1bIO/yWls0KdFXZZH2b01tcvmjLspATxIIr53QOv8G/jswRfbAkrrldZWX+Gm8pW3xPB4hvndn6c8krXN7DdggyJLbO6nY3eIkXvWmZazyB2OBY9AadZJy41L+8bygxKjtztjcRv7LbpitVygFxXDeFlD/HxQnzD2n+R4wu/ddCP8XT7hseX1dGLNbjBNx+jCdE13o9FKustmTf1Ye4dHm2n1EiseCb7WH7+3il/q3oiniVbSwCre7i6vodiU+DiTljTvy2uI375m4zSvBU5c2+YoebeLxwWfCbMyrv2NG2OxYb9rTcl+5X2afk2OpILDIsLbKwIEZPgvvmXsePn8uzs01U7jHwXBSMHy9217eZ+//80LLx/tjcsWnOzHEqt6Sr67nhiOTRmhrDVJ7pPlzDGk/ond01tUZGLPJvl10Ap6aj6ZNuq7x6mVnlFVgY45PEPk4sSM+8WxwGRc+lVOcsVR4wOi0hDur1Q9VzG6XEo4p/JN2Gp8kFboIXxGKW5GDgfYjTir8zwYlY8IPjZ/UY3sSM8Av9R+W9sjNznsOeWOvhNSxicfSfaOckiP7k+oeV3wrIQPu3cudLUA/1Gqm4ToxMgn4tfA3FVn0nn1kRi/de2a/5FuKrDj8xnKPKzyxzKX8HRYZ2pucVLYCsJ21b+/QDqLk/vHMuVWXtTzlun+DcsBXnZgcRG9Qv1l+bAhr7DqWE71PlVfaLRmAITvi05M1sYk7ogjG2YoD6FqmfshlQ0nXfSxvTIC2ywnkgk9g4v+j87HSYu+my1pQI4u1ZD76rZ4ChqSyr1oaYvYTKqM6AoKt5tuYriAUedss/ZsIm48nTNg8nlpfOXRmWBd4yxaWGiibicTOLzmTDndXWiyYnEotOtnRzcuDhvs9Q56vKJyjFY3IhyHG4jLOXWNC5a15jLszZ/FQ035CY0622/FMelCrC9G+xiJHhpNagfJhIVcxM+N4ISMKysjxYAKLknCGzXhCL6ULbeYVgVBylWHiJ2Nr867LOQnDefE/60UqVb1iaklYEJub18dlLiWtK3rOCi6Fuh60RV5tYNFY8fHcJxH9nru2oawD0fqreWR0JeKHChGJMLAnTeW8vAZ2M1HJxDDHv8k27LxLoGzvjyRwnVb55yZXlpTAs9tUzxCU2n2GrHV0Ku01tGizmEwsKa5juUrBW64hgaRKfOv79yP4ymHe35vis2npAj0YPN/5QBs/fVLq+SiW2Xst2GPcZ0mdF2T6JIx7Xcm6262fYqzlWMdSd2Dixj/v1M2jpf6vI30NcY/RbuvgL2L3lshC7DqiDa0LPqnlTEa+3qiPjOjA7hMybcAjl9iVcG22vg3f3v11+yL9GPb+wbSji1cGWWbvsmvqPUi90qwcZYR0M6OzfMsfbi6azjg9FSXXAKq80P5UWSHemWU1BkjoYFWYRPwn8KNPOIc2MrA52/l07QUPgTQuiLusgdj3scB9uf5LxpPQabfsZo3qYeSVldi0Kps6M8qlmuPVQxmo7H6p2nhbdsNVFvHpwurGryL7fll6W693LCOvBT0N5My3Vh6pLNxhkEuvB5kThvLHePBrlQStTUg+TgjyHOQgEtMuE2Y2MrB5e9MSfmysOoRru3tBA7AZYsuWPZRk/gBIaho1Fxg3g0278tnEwkL7huEQTbW8AepmNHcYBVHbAGgPEawBnz1HtNjiI1nBXNjPCBthbsPrOeRRAV2vQ01FSA4zYXGNSjS7SgRO1/jAlDTAkgdlgj67Sa6+F9jOyBjDheUg8ffyonCO9UxC7EdRfV7uEmgZQHzw36CPjRnBRi968TcCnLgyV1jHcRlh4jPkp9xbSpXpUFXOhET6azI584sujtQPXdzDCRpA9OhE6UXCFNl0Y/YtJbIQVYQcCazhX6JN9FmT6VetvXNqwYqAsb7QZIHkjjDh4dc4TCKQ1k9aPQuwm2FO+L8accaJ6Oz8NRcZNMO7cgsCnqcGU++QoNtreBMbubr/yB69S5guVkxGvCSqe/ljtYiakdyzZPwmJmkDPJd1fDV+jN5ty56OkJjgCDKUxcJounfLiO1PSBK95Ir16U1/aTcNSysia4G6VTo2p5hnqoLZNBaPbDB9GTDXJ1TxA7c1/MsgYNcNkaobTFJY7Xfkx4ifDbYaE+ZdPsRl3+obNzZmI1wym3MuS9UwgxfnrSg8jbIaejPRI10EvilugUcYkNkPmAoV0DnOcXm9lVsaUNMO0plXSd8xZunr48W5G1gxWIxdGqZv50Dtd3vzL6LbA+DPvwk+kBVG/9/a2MUYt0JptHCIbPEHP/A9XMtwWcN7YQp8Cf7rrw65W5kILtNTslN/19qe+CmPI8m+Btus9IZp+jlTstFnTUFILaOiMO3Ft4BR9Y0P4L6akBRyacialel+jXDIHmhhZCwxeTXi+MvUataA79i/EbgX7Ax8ehV50piZ36Woj41Yoz+GdFqUFUJm67k0MtxW0BvdlrdDZR/+5UrkQ8VphnW7a1m8CPv3Et3IaErWCldVAuNDLifZTs/vBJLaC99FpWZP5wdTKjWfnIUkr7ExmXt5kXaWUonV/GFkrBBTuyC5D56nwzqdFjK4Uyk7/bcDx49O/cndUMEZSODFsYn4a8qRkf61RMFwpWD4NT3rEOFCjDgc2MBeksD9VluzYuZfWZm6OQiIpsHJHHg4R+NPrxt6vZhKl8MZg7VdN5Ebd5utNQBIpXLfaY92ttp3OJF9iIrkURtUtO7SOc4lWC/FQMroyGBIqW7moj0vnBP6ZgoxlsHuUo+KZTyAVvtRXyXBlsDbn+xczCKTstjzuZy7IwNktelKH2jHaLLPnX0Yog831rh2lF10p7981ZPnLYNFdr9jxrAv0zf9cJyGJDJKfFW+W+thTizJquhiZDA5c4bFWDDlPn7e26WB05VA+YpLFc+9Aep/H5XbGSA41L/szTvOj6LHa/QMMVw4HwwuWDuIoyndrkTriyaFgz39iP+RLNRQoyPonhwnOK1KrmXO0TbkWCyXJoXl23Qs+hNImn++xkEQOXQnm7r0XBdTAQHkvI5OD2O4bb4iGKx058HEkYrfBsZHn/L8IrlGHOv70MkZtIFs+cKIXx1M/Y7+S/W8bvNiux3NFsVTs7mlk/9cG0qrftT0DIdTsXXP6GWEbODqsqjRGodR+arUeSmqDqyx1gTs/hnp3c143U9IGtsEJTxf32NDoS2AHI2uD5oMP4zE/jLp3OUgLsRUw/eBAqJ0ggVJfe4ns/xWwBCc0pzNhlH8nzTBcBTgsXOhdz3Khfk6bp2QuKOCoFt/lUz+fov4JG41EClhgpkblqznQ+sd3j0ZJClCbqljiK7hOr9ox2MyUKEBRyTXxZq7Skc/fj0RyBWSZGW+3ZC7RibUefYxuO8TPPXzVHvnQ/CPPyPbfDmPevYNDTCi9x/aBFtreDim+QdN9+RHUtK6+UYjXDoVftTM/IgH1wWg/mf/tYPnw5d/xEE6vKfulgZLa4V8TF54d/xK1N++lkilph0V6mP2Pmgc17nUS2f7aIWlH8slz/GiqI3HxGMTugJmXxh9Z0W1LzQvaSPb/HbDWstKhjuVHHX8dUc9wO+BAwMv3p5kAqsZZg6z/HbBLkR6XLI6g69MuyBhhBzjM/0cxnBNHaTxM/cMkdsD6i9r4HRNOV81hj0WSDlh9ptL+hDiGrjWV6yJ5B0zaeWlkAD+KKt1cqYfYSlh+76S9jYY15TFnyF/IWAnDF88oLsaR9BZeRQvDVcL320OGOKgF0I93HZExF5SgdyJPpw7HUXrsurFIpASRLNEny/sqdd00Tx0lKUGshUcMM0ug6fEWk5FECfM2zuqb7xNNB3j8r4u7gIoq/f84foccpGtYeuhug7jPMtjd26uy/l3AWge3CGNsbOw8LmvXf9d2kPvocOwee7AYk7AVWR1d+T0PfOYczipw7+t8J0/H831ra5pevM20GvlMc3DSUmkI4Xvo6GOUpJHOXr+aBu6CBYP4qYrtpevggkh65Lerd25fhHUBJIrvqVfDgkF6kP7NysUvzJakmUvY3noTbEigG+Iacn5xrsH7xdKjfI89ENa5E+uL9TOnJsCJqXQg32vPNM8F+vHcjXa0H1ySQF7xPfdhsNGSdB+7Y3eoGtZH0FS+966BhTuS4L8ztbzU7AdiQfMevNnPpGz9b3bFu2GVkqTwvfhKWCgT289sGj7qMlwaTjP4nvx92GhBa48umj7rDfx1KO3ry/bmrWrx/BTiY3vp/y97mO1MJp1ne/RhsC6I6juWB/RuD+ujyP4zbK++G+zSjUjf/eHV8BWcHUz+XsT27PPgY8l02YakqjOFsBBCtT+yvfs5sCaaCl8XbNSvYcb3DVnP9/DhyBRi8r5+yPowvK8jmdaJ7eVfhPXxtHeOfOgoI9xfSW0L2J7+KzgykjjFRuo/WaC3s8uPLud7+x6w0Zq+T9g+6GgYrHor9jzB9vg7wEov8tfKYTHa7rBgR8/yvf5v4bwwEjTut9V3RsP69jSa7/lPhAUZ3RBS9DBlodlxxMqG7f2XwRtT6eymQX0q9sDftyPfveIdAFgbTo5re3n/ch0WnkoLeBegFtZ7EYs3tvOHmmCVgvThnQAHcz/prdSoXfCsKAA22pGIeNYNSIQN0WRIm66a0x3hlz50De8IfAFn2xP34Q1zeubCJalkC+8KFMJKVzI/vnLQp7mwzoZc/sg6A+tgbRTVjmsX9GgXrI4hU3h34CgsVImaCDG96ZrZD8UNl3mHAC6Npblvgh/3/gD3V5DSg6xL4IS+1dUEsm326jEXlLDajfTyYZ2CFLhbH1LT7aDn9K5waipt7hZ8AwsrxVHHX0X9NAbWtyH9ecdgMqy5K+7pEfF63mJYZ0UteddgE6x2pDnjVh80auFSR9LEOwfn4DILMu7PN0dHVsMFgVTrz7oHr81zF1q3J+uHSBv0xFSu1NjcQYCN9uT5CFOVXxyssqMJvIuggvVO1PNfU0G3wXBOGjmrZ52EXNjFhx6oLJm9tbjFmi5f0xTeTViIeXcfWn1swFeqDbBwVlzKOwoHYZWMzFaMjXc+Cytfim7HWFehGs5+I2bs+O47zzdwqQ2VeGfB9hm+nx0xnZLHDPKFjZ50xhzWXUiAI/2J5foz9ac6wWUysqi5wwAL1eKfj4fX/jbGPLekfXmXQQMbHGhpdlP+kGWwrkH8i3catsGlTWLYtPTrEw7DmjqxC+82XIGVb6Uj1n4jrtXAan/6dDXrOHyEPRR06ETv0bmu6OV1tyc1G1jXIRy+oCLfP1dkpGTAeQ5kH+889IcT7Wje2NzQtB9h4ZHUmXcfiuB3tjT84PnfCxfC6jdSbXMHAtY/Eh+emTCzoRz2URDHPNaFuAj3fyt6zPhs/faHsOqE6M47ESZY81yyyTrgt9YZnYcSk/R/5awbEQaXxtJfx9/pfjodFraLobwj0R9+2SD927mkMDkH1pwRU3lXohiWTOJUMdTCsAjOviot4J2JLbCDPXW9trj9IQobddJS3p240mLNXRf6PCR6dFUd5p2ei/89V3RY+tbkYw+r9kqWvEulgL3c6FSLDI+8IFh1SBzDO1Wx8MoX4pkK1/irHWDVSWk271Z1ghMNYu7gxvHD+sKZPvRb3rH6Bp5uQZcFik5tfoSzX4k+/7CulRoO9SRxW8fHXC2Gy+okPe9czYJVj8VTtjmNdDFcINDm7tU6WFgpJaYFrjm5DS5rEj+W8A4WfMokzRnzsMsrHayrEhXdWRfrHKy0JoYhaSEZBlhvkt7wTtYDeKcv2bytetimF3CtFX15mXWzPsCJjrRXyI3IRFv0Tvu/Er/jHS13WHgqvo8euuNWACwpyDXe1YqGVbXiRKvXHlvbw3onWsc7Wx1hY62YmtRvybK+sOqJmM+7W9/Cidak+mj+4I05cKolcR3IO1zw1UjyR8WymVcnwXpruoR3uebAJX40Z0iHr8NXwC9dyRbe6doAd3chD2a5v1v1N5zWjQ4ewrpdFfDDUNLJL3JZwilY2Ybu4R2vq7DmgZik2je0xgjr6sVU3vV6BpfKyD/nU6dXvocLfOnC+azzZYO+79I4ErC1oN1hN1gwiFl3WPcrEG4bQ0LcC9ffiYHfeZOaH3gHDD7lTSM8pn4I7AInWhAL3gUbAHd3p7suBOTPGAqr3YhiIuuEjYb1rsTZ6N/WqQB+nkQ+592w6bDOgyZWLPr10CLY4E7tqllHbB28S07WOF3KmbMDnhBM02+yrpgWZr3i9z6/p006DmtcaJUF64xdhvVOtNBzRODyaljZIF2MZ92xp/DKUBpcQntefg8nKmjYAd4hQ5+6fTK13/T8WbJHizXVaqq9wbpkQZh3D6br67ZmaOPhlWE0x4t1ykRYH0AiTA9yhveAhduSM++WfQkbEml5yd31SSPgU8EkbTvrmOXD2Ury6ZeAkPDJZitoKu+azYONbejRz/N9Vavh8Z2psox1zrbASjlZ9tPTI5P3w5rPyWvePTtq9gsx+N6zzo/0cJkXrWjuoMGJ4eRcX79q9VN4c3c6bxLropng2yKtKMs9GixHL10bRpbxTpoC1gWQrl3tIj6EwNnuVLmNddOS4JUh5En59ExTJiyYRG/eUesL6xol2eUtHZXfm21PFbyrNgrWuNHwlLk5YwtgYyIReGdtJqyKo1Z/L753bymsdCDjeXdtA9w/gMq0Y+sn7oY1tuReFO+wme1Okyu9tFkXzBbILd5luw2rY8nyHYYpcU9gox+1iGOdtvew0ptUJnWZnCV/i88vp9G826aABZNUPyCzdmIYLO9JbvZlHbe2sCGc+uxsbLjfEe6cTG8tZV23AbDYnYx2rbujzoZ3hZK7UazzNg7+Nos4Hbt/K2ISbIyi43j3bT4sD6G97Zsi5Gvhp31IRHMHDhaOSQ1FWz+4HoLlicSed+FOw6fCaeaCVaVdDPDqruSeknXiamCVLz3z5LZyQyOs9iJa3o2zbmzxu3Di+c/5x9GesCAjSbwjFwrrPen+KG//Oylmu1F33pXrBGvqJdMC6VP5QDg7kq5IYZ254fCnfLIgWX6yMh9WdqCTeHduCqx5LOYvXbe7oRQuiKLIgxz5T3/hiJClvzJFbm+weDdSkL0LFGTKUYLMWinI9Mz8PpzdG9g9f/hDdpXhwLb5oK01DtratjpwrhrV8ji71o/DwXZ7HIjnr92dvfZDvPYvzI44RO/MfvnnGats+QxF7Jo9quV+FrvPG9XynK3sygMYrq0CGB6jBZk7v2L5gj+nDM/n81N4joI/B/NdbL4V81rMvVrNj7eay0e3zD9rNb+OOb+vafVeLE2i+h8No6I/";
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
