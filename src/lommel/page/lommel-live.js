// Made by `make page` with ziglang==0.17.0; SHA-256 of the sources: a1b10c1816f39ca4aab47299a9ec00d2cc424973dd1d6dafb1fe1bca680efc0d
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
const wasmText = "eNq0V3Vg21b+fyRL9rMtX+Nd08utJ2u53ZiaUSlx5tKoaceYZm26JuUkZSfOmi7LmKkjxxkz3XWcjhmOxszMvKX5fd6TIru97c/fUyx935fxSSENrfMpIYTeYnXRGYTMEDksMiOEuwYM/0n1j+ZmEPxYLkezM7gi4N6h0DwLnKIAxbKanM1mfS6PgDtVGNywV0RgNUKx0w6tpaMDsJXzl/bHl88S2O4AApY89XhoR7OeH4ojjA22pTGAyfSYgAMEMKv5tbwSg3pDYwHofVa5p21nQfQUaaqlpbW88AWI1h+YEj6nUYrQ7IEhCPqOeAkM6O3EIyvfS80oOdPzW2MAaDGF5x7ON2b4yfCz4gcGdu/pU3xJz1Gm3dJm/Mwjg8VU5XwjxVwrNp+W893wSdkg1z5/kOvAOyxtrSgFUDeGbhtN03oNZSl46kDgYeCqIvguhz0l2SBtQSB+Li0NtCutkVywgPfFAIZ9ULGbATbk4bwi+LGC7muj2UBMbXx1Q5FqDf5TN46/Shl1awW2APmyHViaFmgB5EtiQHTfFXtOKw/Sr9PnpzHrGQg6AYp1r+CBPQauQ9vAGorazziWX7T2GUzfQ4Ex2q6Q7UCyyfyPyxpam+pbFzQsap2zsK1+UUvj0qbGZTvHZ85bOHNufVvT/Mb6YxvbSDg0b+H8+Y3zTHC1tDUuIBEfIWY3NM0jkl8Zy8cIicbitp34Q2JYQi1D2HY8HCKGLaQtrURZMjlssz+CQIgw4vbweLxc2HKEYQiseDmlnDOGnf8HpI01DGosWm55N1v+KQoDiYo/D0sQsBCDqIVHsGQ5MSzhL1i2rM0llRLwyL/EnZQLnLWFWfnXLcXfthIjtxb2NttuK5W17Ry5vdxByjJjx+13suAv33LLsrJhZtnOI8psKe1dBBu10zBbVIlR5btaWEBSxEZhVNjECEkhjbghpAAkRLlBbPWTiEYhpX+Pb/Tw75tsjN8nbnrH2s0eLmBnd7EH0l+55/Dh2vbI0SCNoUKMLvpiAxLICBOSkLEWhZ9S4enOSIq0qKCIxgYKBMMuG0cRuLGjxC/hKSF2FaUIHShrtCwf75YbRrWoFjWj07Ia+nYuq+WWtZdtZAzDsiiVcVqOSOFoXKol7HKowZ8ktlrQuhW36ATLKuPmLpZJJ05KJqnFOTcmT9k7maHj9tl3v9Ej9ud0at0IOc2eTuOb21bZASPjldZUtAPRCaDlXhMlzaRNIU/lkNWxlaJcHqgjIgdpHlsmxyogbonx0lZeUOSIc4jsoEWitll2MKfctCr3kfuMHFlWNtI6SDLGwHGIF0r8UFNaVfQwOy7ie9k2dw4/wjoyblt6TT5q8hHqz7AmH12fpMqWRMJsWm4DRvqprKqUcpgqiOpPMWNqVTzeYB0ztcyUlVRy1KbYPLbF4cvhRzLT0h7UaQ/4PmKmPSsetyT+hNVoWxJIZlnlcRqnlMa1AssQLJmcfWT9VIsee3gIDTuybFjluHFcR1uuNRlWUlXTcw7lEeONHZMGsYxSrDB23HQ7Dl3A5yT5kfVN9HDHy06zH6uwknyunGfV2FTY+0mpQgFe+8QszoZTRkfBcTmtckLZfCEWlI0ePWKE3GqUKbcaY5qWiSwmk1Jm4hkzg/pI2zwIE2bGTUpl+ZDn8Tq0VKNuYdXDlqijcRW3JLrTEQuPl/s5UZcqwlANAGZmSbhEyqVh0yKANXLkcHf4cAur2pI6jdbC5KKdJktYSmZgDLa1ha1EVTKZXDy+xRptIdYd9qGt0t7DmiZkHQxAJzyQ0AqAt0E9ociE6jTkQimAN0sM4WuDXo2Tqm+BBBc4fbalCmfj/ES3lpWVSVO5XNLlSrngWAoP9aOkGDXKE15Gy5d56TI9/bQYq8BFLMQ3ni5fYa30HKEqUYsmJzNVi8dbWFQZ2t1C0we58jTXiKpVW2Z3NxHUYVU17VWCgo4NOPzTbaO7Vk6USRqvk3yUcpTawzkqY6nj2upAUiwbrzZLt5GEMv1AIZXBcqTGqzPEfFe0H510lCgXQyhr6GkTI14XPTCh13F0NcUt0S5Muog+issQlKxmod3MHE13dnZaMkfSnS8fp59Eb/7rbc7xn+sf8Jgeeh5783S2WWh+4/yFLSsYkfVNC5ramhrmNa1sxES3LFw4n1xIw62NbfXzmo6d00Yu9jZLGxY0tpLLKV/UOptcQeXMJW31rY0zFy6Y1UpupFKxzGxqmTkPTLfTqAfWN7a0LGwhD9L4wgX1EAg4HqKxBY0NLfUQb2tpaG0jT9Oworc0NsycQ/5FI4rf5/0PDbc0zGpa0lq/cDZ5icZ9GfW6b5rZSF6mVqDlPSqOmbekhXxGI9qfhvmNLQ3kuqgxq3FR2xxyU1SjZzfNa2tsIXdEQz50dzT8E6MkTeUjdMz4seNqJk2orZ6Y2Wvy3ji+959aN236AQcuuZZeR08Szxr/NF4Qb4pXQ4+FLjO/NX8x37Hes1637pb3yBfki/J0ejY9l55Pj2fd7AR2IjuJnULPZBezS9llrI9dzq5g17Dr2PXsZnYru42tY3ewO9m9rJ+tZw+xh9kj7An2FHuaPcOeZc+x/7D/sufZy+xV9hp7i73N3mEfsA/ZR+wz9jn7gn3DvmXfsYvFJeJScWRe/Cg6jeOM1cYa4yzjbOMc4zzjcuMK40rjauMG40bjJuNm4z7jYeMR41HjceMD40PjI+MT44rQlaGrQteEPgp9HPok9FnoNvN28+/mOvMB80HzIfMR80XzJfNl81XzA/ND8yPzE/N4q9s6weqxPrM+t76wvrKuCV8bvi58Q3hd5I7InZG7I09Enow8FXkm8nrkjcibkbciP0Z+ivwc+TVysbxEXirz8rToGdEzo+dEz4ueH10bvTh6SfSq6DXRyPWnbZGPVZNEa2JZYkViZWJVIptoT3QkOnXTo/W7aGINTRxPE900cQJN9NDEiTTxK00M0MQGmrgymjgzJrcgrCZNtmLrnz+uh0yIESLTKOhu3j7RhSEh8kYKJlbjYGasyTHikAzR681cIUU0ftCeCjxNH7e8OUWjTG7MAsLAcH2bUpFevUixUKm59y7RNoMPabtj0X5a2+Omz1rKoghfztG3fSrSZ9lgAYPywWy+obaqu78gX7BM2sFytIPrH++AVnKvy2ureq5yBZxd7BqlYexV8IkeKZ1uTncmHKMiZUjlz71uSEuammwp10olQ4Fk2JcMV6QsJcnudSNaUnpkSLJSychvSYalzrWR3mCr7FigT455IRYclrelE04/taw5FQVTWBOhdYjqRNNPmhMrwCSgbnEq5pj6aTpSP4UTqaXdtRsG9bK7aju9lViTijghkBCN01MLGtE0usaNO1zhOYSUhGt3gNGHQ6Btws47sm4CSCfuAHQAQtYJOTbwYD/whmwqrgOMOoZjNacvWNjsGnNdK00RCNBWunofRBRxrBu6U9yJpNcjB3Nv6ElFokyFfgpCNzRfTbPKaC1JcVA0ZpDsBwRNhYCM+wT1cOLpTqq0uHY3XAnf4CZ61iifumvJ9BvWpEJwNtGTiqPVPMcmwYNoynAiKQ75CPBaf3qqUh/g4JzvG1f+wtNm+GwrqsMd29PNIepdjunEWt2wI6Ad/PEsmEJBUrhSCLg9ZWvmuBNpdzStHbnPHQIZOwXfU0Ixoq4TU6IWuHZEmwOgzFUocS4dXoeGgXa+wo1clc41u4g4jshr7yfQqkOP+6Fzx1B+pwxo1XZDdbAUWuFy0GMUMrRH3brAms6lwlFW2onwz9ePWiHVsA+zouLOFFMt7ITnYpoeXIY+VltAkxQ0NAIPBrMAERdd3ADTvBaNVRdjShnMqlvPGvSWt9YTdJhvw2Wq4Umvy3w9X5oFaCEFB4RePQ1G4ngIEXgKHjAMDv6lqvCPu4v8NpzG1Wkpu2ZXXQWencu7ikZSDLJDeuSelObSaCg12xNUKBwHy1YMCZmIXJG0aE4hDJURkFmUSCRLF0T+wCjLqQSnc5pPOe+QKQg7TR3a5lKV1X0qXArhY10SIzBDdE3SjkPmgm1wkC9Ot0MwHZui2hB4mu7qFM3pxFIlBJ4basHU1X1VisJBX4K1uWwrdvMLOM1dAp/hnt40QzrR5pDmdLYZEeyGIJCnNLyoAaMmpXPqJKmlTlGxjlzpRNS/Pq90UugEq940I2e0RCG1JUiPaZL2CVJ654fjRamzQoZ8VHmFFwz6B/luGomdzkVaucbSsMCmxJA/OJki0lGp481+AJvsiGyjAiXT/ajLRBSwPSEuXFUPNY1pmjJQSZ4epItRN8dQN+oYzTgvCR56SiiGxOGepNCSUCYVLzzLoYpAT6nQ/SI/CBk0R7O0g+Z4dotOLGR0rksrNajnDP6h3f1O/DGXYghwqC/7U+iNoc0g2CBRvPx3maNeHVjmYlekf3ru1NVCnZsi/cCrL27g+8UowFsffmCQT0Us+gDhWuebG2p3eL8/n2KZpWNX7PrFnh+PSyE2nCrqXQcZzNigqV6/BC6ZEqLkgFgIol/s+TNEu2tmIeAh35TbIelJvctRFBC8BaUESoWE5IbV2zZO2uyH6sLQvFc75Mr8r8wV69yiGwWkF5UOXCzAR33aDGGqS5y+F/pz0E+108hD9ZDLXLfAP/ZgUTR4VFfQ08NwGb0u6cU9ZUhVgMCfghsqYCKDK7P9g+EF6wZOuq+Q2XP6+91PPPvc+Hwhs+6Vay8d8UyyH+DxB20YkaeHVwP8NvEHrF6F9bNSnXdNH7ZwoDpmodcN9fqYclX6UKG3r5AKKd+V2xqDM6tXd4HawccCfg4DKii7QA/GOWFUZQWkovtDkKorMhBE9lz/zBjVvOpgzAcO+qkVwTdTytD690ALAeeIuR42pLFlwAaiTqhXK8ThWvCNIWOhfG/A4VNKndToUhfwWegQ8KnWsSZWBI2f9zLASmoTaCbroVaqY6vZmyMMWhQ6Execis2vTH4sTJpTM8eyevpW/ebkFWeI1Spk/tn8Z9WHoQzYeuvH/px69ZGgmftSBJ0MhkFv/TBIDo5xr/lKpQ70itm7kSD3uDCuLk/TNjWzj5tqVLk3a4tjfOOO5RApzpHwLTz34k0f9ecOj5GSEdPNUpJgAzHpc+Ht+/7aDGvJpfqDPFSiLfD4zbOv7nuQQJ+qQ2nxsC2Wo9cP+o2zr+5aTw6ucIy+FDLB1cQtTl96/9pBjgZyun02u2tNf0kt0cjr1KgZwQirqgvsg6FX9oKQavJ9rrHxYBZc0zHQKK5wRME1BpKu5YgBlzoWtFz2yPLnwmsfrC4MJBVTJjN9/BvDvnoA8/A6f/K8WRMfxXyCdyB60/LTNn948VPVh53tnlM55V/VA1/Sga+BFz+ff+GFF75UffZBar3n411rAK7jRvN5OGj25hHKRo1H5GuccXRZyUGoeupClwcY9TFDL3RFKaLkuFdhHqNYHKoewuHqN8s18ArRsFHhFmutlEEE5QCkaph5akxu9qX59+txHJNg+8ifCy5V3VSyh51Colu5fRk0B1fB5Ws1GvS1cIYrT5DmXg+ZV1tH+Cy9SiLf1xuo7bNVVwf+OTM39qJvEy/6/n+8KNhSqylVTp3g+l/lYC5Vjm2JckhAufcC/xdlrKS81SnqHRqlBUG5varfW/ou5un7X71gkAcD/jVei9RhiZOUEZ0Gh2xyJvYV9wiI4w1+wRqhpTInv/anzWY7563PJy5Th5zPuD5XKEIpitZUifBY3JKjmvTli5MkT2WcdjAcjt7pR0u9Zt5ZNMU7wOCGf0pqPAE6ffZXA/9hKV565NTtVdhUDb4NFOeT4AQfxPkCxz8hqH9QYuVwTOiBdgR8xFjrES9ggl/47N3/kJvVBL807YP7nsx8iNeqHu0Hnp+y94yvfgLBqfzyrDe32gBC5qz3G+z3+YbqfB667tX6s136YWX7XaVTNZ7RqzTkVaKBAaSGmcjHhFBvC/b7X2g4TUuD0+XMC52jTPn2mQN/Sf1UPQT04wTMHVShp7rC/3KHDg7hLzaobtAb6Fb9QKLMP0P3ibFND3+Q0FjaBV/mqUElo8HTOsXUklfTj/35Ilxd8gGCF0+apUSUSy12gdJAi40XiAXMFMxMBnSHKCQHkkrdEb8hSWq0JEkJzaLLiA8px78yO85r3i5ze6G/kFk78Pr07V+/QZVs/tq2m76++TYFLv7jFhseWXyPAh/65AKcw48DTKnjvqjjDy+774y+4QyE9klsaeU+q66pBve0cc/lZ8duUeACZ9+Hn56wToGDXeSsyikPKDCmj/P/AkyFikXYT38e8zZX16GHNG/LVbeb+HgpgCc/hOvFOau/l9bqmnrVdALW3v95F3wmhPelT1f97mipCg7NU2e22aFXtZT2UVC7RXtg+HyYeF8T+qz1ZTuVotIJv7DkKxA+B1cm/MNA7K1xDIp7bqVL3vxiikrMmNPn/H2r1ZerlB+U6YkfdP/jCtu+8BM+7Pn/aKxeDwMbKFp91g63PHzHbVB0GD21Yl7ofcX32EmHXfzeNqQG4D7bn/Tnv43m6/MbtR93cBYL7fWt798ziOQXY3UELl7wPwjNI5OjtrzyzHvyva4+pSn+4aiwpc/9Ebi9yV7UpUc63/t/1FwFdCTJka3KzKLObqkGnm/u5PNl1ZGZvUw17+346ZiZzS3DMupmZj1jZmZbo727hecxMx4zMzOjmfV88SMyU1Xqbq3G7J1tdVVmZGTEj0ionyWFFheQMFLulDNUfDNrw7XZIOWnNqKCjZ5eiSWQvGQaR2NwlTcZWwclhaFoHojYa5gIimwvAqwBoLC9CBgHtEJ5ADxAF8oD+gFHKm9z2otsOvqZ3ry5wU+0z8wzpBs2uOn6mSVcTCwPTkXsJlJ8QcoNko4lJ2mMYn8G6efgq1rtNLQQkgYo4noRkskXEEnDSBpGcjvrkHa84kXHGk1e33T8+D9hzuwnG1IEzkXH6HqRY/qL5Bgmr+gJvNqeKoYzBcUpiwMLXlHTzGmskV/qwaPxLXOHUGvnESnHfFc97Uz9ZPLIs1JMXGVPPGxOnq1LnrJBcHX3PUv9MkioLrE/nyrsANBaaKyUPtdN76ZJwy1EnK3JgcTh7Mm3OAXqzUx59VDY3gkHpzoN7k0Figz0l1OBe+veh56opWfElMPXsvWN9ZDAi0qI2RI9MxxeUCJ31r4heIB/5K9LTx+VbQs25Hjk7KMCqippTA8EPohxeogTWBMNQAyzdrqjWSXx9xoHNMl5CcELSowAI9tBWFpLguWqPMsQD6oBXHI2C5ZTEJwPZiFjv5epUGD9yO5rSHNnHH2I/EzIT5dOXeLtZRs0I09RcSmsJB/JTPJtZyxflab6mDCJH2ImUU+IlsRVozt/dZZU2UA5fowFTeeOoCNPgncnVZfWL2ALsgm5t+xBc5lvj4FCgaBi5mTOgh4uNRSqKek7mZK1CJWhjEG0YOABzCB4FJDdJiJrbfK1N9EdmYIXmL728Vzz1CdiJ9Il9VOpLknsKiW4z02iiOVRBOjWz4M4YZ/WL5Er8JbJPtbPP4SBXrb1S4+zpkuHmhQAwyQfNSXQJDpBzXLjGY0jkC7Px51cvoIvHzPQzWxa2hl8ENkpZUlHwmuXtylq0Lv3I6H+Xyj5GT1JmYHd6UkaPenbME5Yxcb2TcJz+s1WHq9fiolgZRP4xwXwsvpmiA/Kal/27CrHkJJPtY7zPxUP6ujpjA6gzDaJlKGqzbubLpvS0eYqU9oFmLWj3zwRgginZ+XhY+uBPXrc9/R2cE3lssggXfyd5HVJhx+sPEPDWHnZ9+Ew8PBN/u57/JEgtgRR5n2fTkhD8Ied3xzUfo9TtAu6ktZ7r39olixxTYVKLPaJq17qKsL2Fs7L9AhOJ51ClYoeuIp2C3A6toLT0qQtoLPexDUJ0Tkj5UDBigqXA9AmJxCDCThGlDNXwW83mHT3nmIVSLFL/drvO4Ig1D8jndLVz8qVy3tnvvelZ9d+t6H536+viwUKJZfQ0jhymdf+uj/5y6dfst6qIHvdiZ/28SnX40paUct7IVmSy7vsqtbcQ7/tGTScW7u5/QiF7OySe+jjXDPebCeb7ZKjJHvS29tlVLzv6VSx6ajxr0Nko60pMhTo97rq1Ga7b6OlomqjtW6JwmOJi93nJm6M7cmYdu6s4mNRxe+zClJQU+sN+o+3MtRrtUmtKzHldRDaxNWtLL4pxRux+MVcHMqfHcuf7Ms32gmZ9e6AWkWmyOCQcWO6t1437S6WTanpfh0MaARkO5cKObp+Srna5Jh0EbPtbCxiKIsQXpe60SlHnqSEgKWRT97BzU0chScE/ulg6M/jioHj+QFFv8+V4tGvy/WY8EF4mEfzVe+LOv79tGCTSsXfx4o/9xUV+XxLZ2jdJ59zAvM1VO4IHyZD76Zfx/eZK06vH77XE9cbFY8AcMh4q/dJvRfLJXWzgfFW2e9VmIq6RM7QIqaqA2ODB/3Uqe6NJUEKmcMpXTu1dhqH9sfWHSV38l0Q4zOqhA45mTKyv5mmZj3ywaVIuTQOpEuIQ9EwQ4f9fXJsk2eOKPO+i2k4iFRreFf2khhLoQT7pM973ZyQ9zi1h6y02UabO9IkgQQVgIzlc5s++UbPcTbe18mm/dNM45kI/sR/856MPoFzMsJM2NeMfUl+sJeKhP7wqKv/JgtC0/0Sztfk/PH1OF8TbifFMVkyOGHTXdo/ZTPDwyzUH+sfaIFq2e2wTL211b3DMgNCs39Yhr0wiGMccdFP0afCyRyWc7Xz0CvD40z891kfeuW9Qy88l7fZ4NAr40MvYK6AFJc4feoUIHcZmbxJHypodHz27J936bnnXcjH/nGX7Bjnnx5xR3rnURgHNZ6DCWVxrqSI3u30CvSlGp5ekS7ShKHHujLxYnh+BjoSmjcCraSZ04j9ILOhm7/tXanXvZDA9lVMWB/tJ03grF/SKpwXYwy86tef9kt0jIOBWd+GyYYnIB3PtS5GlQ5j9taLvofpSbDu+EH+9iieU8CTKwfFG1KcUov6dnThPblT2N1unsTutn4LbmaLXyPF96fN5Awr61JspUOD409GA5eGXfLXh5P9Dof4Cd41KPEj6Y5eXr8STZj1VWkhm96UhPgCMq0mqdbgUSbrRkHNCuqMo4F8DdZzXNCsvtIWay7F+26FS6dt2V377RPNdU3VXedKBw0khdO+Nqf7nN5Tu+7yrpyS0AcxE9GGOK9fxvhrtpNHRQGr8QMpgV301FUrrvjUiJyj6go1mTPRFzyDlGAlz1KGvvIuvYLQQVJBJSsgMxrNZsoLaaloL6bYgn/KQu8O0FxJ2iQxS7L/POqbGpRTfuSTZ4lXS4h+I03NsQCfIvgIvB50rRbwVABPATxDUzyBVz+XjyoUQJRzGb3msil2Wl0C2+o3oBN051+16flkyKdQqtEqdYpBouZq2qhZn1T0SW37pKJP9vkqzeCKQjxTxDOhQKbbrrXlDucqxHaEzUeMbRVjW/nYsoKytWI2+z9a4ff2DOwywlGMnQkhzlGSS7GZgm7mGnhJ95R2cA7xw+OqinL5FEqmgEKAoOIcBWraGvGSmo0gb125nT+p5I+R/Kk4f3oB/gU8UMfxMRtgM290ZBT4NecDa3C+tub0FMvLHQeWjj5NKCW9vcDqvQfW9AN7JwjxHCUZV7+ZfX+hiqlrWGFryAlnvAPGpTT/B8/z6DlVZeyPeJeJkZTP1KDjNB54p4fe5QANAx3iCGCGYZnL/VpbcOyhMPdj3ikBjYO/usKX+bevEBBRO1RATOSZd9GzKOmIkg4oZU73h/TpPc+673nScNZ9e8lkDgHw3pMX+q1Q96zfTcLlP8WrijkzurjvFdQvY4IF2et93XtELxk4vU+anM8SChIpMyU0DP85eWyjWdW/FaJLB11DJRC9LCrCXl3PdtUC3V5nSE6nqeWj17jDWKdATokhz/7daMKrnpHvZkOrRfyyNoXdreqZI6fcak5XmrrK9moqqScFrcDDnWwLqV38AdmWUyfy3vYv/Nl94Efa/fzJC9k3FL76H010bjrfOcjDOUAy17uhdQMhvQsEWPiKvUIAI9AJOhu4vxeMzC4Y5WRFKTE//ot/dp8IzPP+66/1HYYdLQANEJ0LTd/qWVh2xy7bBbuCrK72jB3MRC8wZxa8XdA1e0E33wVdTIijqX11muredKPC0Tv5lmGGeStu+WZNFuXwSwgjP5OQwjCTyIsJKLsO27hyKktw67dIqSxxhuABbxt3Qr6rsMikMic6FU53e6vhr+k0C9a6YC1EaXI8BA7qbF1zw25ElNPrUPlVeIv1oFP3SuoWq6TTvAQYEUuvwEunAOlczZ6RNGnKRIqJZR/GN52Uaa1+GuZcUpXIq/LaGZxpa360ZA2612Nc0rDpyiGIbkkkX4sGMt8d9iMKC8VBtoKZcBQwxPVwvWAJwVXdTddnqyS6L2Cgn/q1HoHORShhzVXw21j0OQ+dVvdtNX1bWZLjLK6KySaajBoUiMkukwdiI2aHxom1JnGePn4H9FrF/++PBZ3skAZFY1/06ZQo8/he4c8na60OWRu2Eyn9kFeKseYyh5VKHNus+/M/4reks+6f+YJ8+wWukWwkENU5Tm+Nkx3/0SGwVXclb/Bd+u9DAOy85Hx8naUe6LRkObEKZ6ma7igUYx6AZgqAyCLYRjbeed9NkVYHkFRC4yt9sKQAxQRDBKPrCL/qR276CDpjn56pbAiA8XUJ3IeP103xnU+bQljsbp0LSoCjPDgJ74MkkV3R4eGF/F8jWjiTV2OO4n16MweJijw/6IzD99c5g4S7wJlAix9PzyYkCARAQMADAgMkSqQb4FFyJFOAhe4SBoY83vf4gIiYYwgTsNQ8DrYthY1t5gpcLzAORjlv5O7GKTEuE+NKGFcOjStnjYNhYP4NTtYecAZGSKrshox0Puj60L4TsWvEDAGFCXddUglIGUMigtbXAS25dNuX9+xhGDDFzMV1l0oe8NQV2sUifHm9D2Z/CYcmo+9eNmb2CWnSG3YlJxdKUmqIwyykPyakFB7WSOmzCJoU9efQvCF7INLMBdQU37VTfAXX6Cr1OrAXAIZn0ZcSnVh3SJ+1t8GMz7ch6g4NoRp+3kRvChPAzGi39n34NRS2EdGM/4SEhv1t7jL6wvDLZb7AjR5nTNIdGUrVT4FWxEf5eQ/fEmZv751hFStqufWgoaxa0rhGrWIUOOKaIy9QOTgNbQ44Ia8MpClRz08f2HdadSmyembcoNm9kgdBJZqRpnui4IHE744VADVUYiU8ByUud2VQ74pLJGEvEokPgN0BOHqeGTb2o2maDhEf4p1EvJM+3maIt/lM8R42PBO8BQuBfQAJaVgMSgTTPl5Fx3PvdObdcTm8FOwpJY7E4r6povBBmH3F2dDHA6GLXZChFQaT6Y0wA+vYu/t2qfSk+KQ5jstDbSJ2+4aGacrZZi4Vb2WsLw59Nift7F+mnxMMvhQRkH3UV24/Af32H/OWpiQp1OAgvgtk5XIQegZvZe23YxaKRO6f9Bsi29NunX9BTui3Y6jgx4Lkm9jbq6b+lQOX1L/OF9//udUXt4CFKBja+/zPsb3P/5zb+3nD48tN71Wil6djUciDkV9dcmkgMj05SN1M4nMjtk1l3FPjC8/8Y+bXuHkbniDD46PwbJT5PznbaSS85/SgpAc16EGhB2G4MaAHPUS3Tn4x3Dr5+XPrBZoOcTN6sRW2uPQn+XckLydhec8Fpf6V/FaH11rVLa25AiL1s/1Dpu7uck2niMiVF/gvfvItV8jk6wZv8xfUlBs2JVfmS0brJNU2vhq7HC9/Xvjc0FQ7dNl7EfbnUA8J+S0KzKlFuExd3umr6F2PX6SZT+RCJeZ8NDnupq6g1/rtHJXZpf3f+Cq5KeT1qn8B6OaXiOd8wBM8MUmqjHXlS5e33XGlf5f1FL1qvWz7t9FPQtmbuwFzSacrZaK/r7xkyYteCtj8clfvOxmXO9l68PhEqy6x35jEX7vFF/aqa526+hHgAS66skvrv5Vt6dZyOopUUHymJHYEI7/JeIw3OdgdfqzUvZ1r0NmWS3mek9/aWG7WVvzYKY+lo2+fZHK4lbjKjehrnAUxmWNKV7GgK3GmA7kEl/is0q2hZlHhQjmpNaST1KHWeKAcl0BRwls7UVIJniVqIV06FsSHRXc3MGjRg/7pLnSMCh1USV+LtMDkqGWhQWash7abbVGz2PbxHYE7HoBbLgJ3FJSNpMux2FKKCBSVbjew0FgH6zUC1NqB1zbqDXCNIIcP1WtIsSoI4rMKBVSMDymrqKwKsJWObwU2//cpvgLrFYaD/AmAiq6uwPTjtD+rKScaT76YlCj5q4abwR+ykfHByVPWVBgCMHJKajipFUlDt/yBhpGrBHww0miH13ItU0FNZWUA0H2G+8zZhpwJ9kwMODIyREUDEjEgiQbYpkKlH00Yk6V0qJsKaPZ6lJ6oRdLrQqOL8BoICpSfHEy3PK3/TphJFY6gu/XLyWqXkdZmhBFPpTelqwAiJE0vzFU/ryCSLRq0KBEFO5JgtR2JKq5FOd8W4mMpigp8AWkr+qCBb6XfggUENRPl4mgTjMbbbUhyvNpaHkcl16KcW+SukgDkO7qs+l0akstjl+VMl6VomelyLKMmAAEhRxUrJGndmJJ64rzHE4HOeFe5nrSwNugRkyzk3ARYQkvJBnDodky/KUjlZCZ+yYL4DYdzDE6yS/ykNsTPOuwcG+VHW8vDRbhJnxyr/oBhxH3SHY9SHoklEhd/SKFCCXpD7zQWKE0tRp1GM1S2voKKUx7a3DDBDcuUIYdWIcP1JepR1GhW21iNYi1pZelrqL210D/U1mrog7KgN/HpKksvZBiEktHvuK8GUbBC+2Ez9/eBYjRsublXUuJpkNvX/4BKDEBXwhByT4p42mpSvF6gee5BgSXVMoAdYSarPLdruGvpNh6y2H8q0vGxuFPwa3prsKpnnZLDDn65/hqKHN4kb/MupWJHZ/PTtqDDA94Zqcc0BcFSYH6kKujiVZc9qOTsoS1cAtGrEHgu1lfhWQMRmbYjX9FaVIWbMTRUzcTPuhOUO+tHfUtscEp9Tliv9IFcD6pQvKiPsSSKN8iNOUIV0hSTDZ5uuDYjL8nHFlLUXtry8joJczKbNmoqNxHDCry5WHmjjs22ljTxczhSdYlRV4AM3QmkAL8ZE/DlkSaHkMb4WPLLP74K5O6SK2S8Vfga8+FHgRDIS6eQNPhB62VTRHfFEESnS+ZjW7QjYDsiVFtLuLJS2ylkX/ZtSDO3I5rWX0pHI/g/6MzjLcFhc61bQjovgReRgSMZp+miHXsklExhyx2mMR6fYtQERmHOgz5E1oRTjwmsnLgxn2+g7cRV8jej6IJL2oxalZTJslq2ZoV05+QQXRQuc4Q+diPNxGJO5Zg2mGvVt5Cd8hQhOYARStfLMqmiNPz1HS4DRGtkGAbTiF1j/yWjxG4LEybeqpBMtiE7peORJFPBDY/NNsxCMmUM6BgJnNGXkgRekl+p/8hSjqMjdVTfaI6po4HCwv5VyTyMYZYCQ0P9GwJIYcrNuMRpl/WmXP8He7iylQqJHjdC9ERrq0RvrGspKWUvYXAvUMk5YiJdZSQq/0QDBWOtVd3HNaDTW/ua8jBN+PQZaciM+LXp2XOYxm6XpaFsfPjnkUJZozRp3/pRpPnWJVu/kW6N0x2yW9/WTra+moYT/Xji1n5HNylu0idu3SV1dus7GqxoJa1oVDpWvpUKrX83bcZk29H1VgxEFlmSnJTVyOIPNvOTUpYXW99BHTQjXoogiQGzTlrPxKMqeIMOoBTKw4c8PO+z8PC6XT2s4GG1Fw8reDj6Dszk3yHD241uuIXTWEk6KGzxuGitXfKJsSSJMcJ79KMTFLoKV9WJlpSkzkNr8VR+tIPmdmmFM6Y7rrqEuqM7zp6PaYwFp2gUkjuk5iTaq66b0qxCCNb4sY8U4hd4xjpIItM6mnetZ05Q/Jh2ea2pZQpY7lKaB8Ofo1s+3eyn6wPIL5SJgLxqtp//ZF9xoj0AB4EpUnmy1yiTSuMOIOWd4UBPFqdt2Q9qOSeoBmlrPidp6w64/d85STEjI4pOf/tpd+CJbnSSqlRn4Od+d+Bwut4ekEgtE8p1s7w9xpdovwKYsNJEAAuBPgIoY8K4YgeOa2eM4wEeLGbhYJlgsHymuGKwmM/JYJnBdRW4UtpSFc2KM7h+HsfWPgwkDCzGf1mG2b4VQR/hS8MvXpLAPjy3QpGrrqcUuvgJ9BtuTzjBkYQRIzaqO0m7xiWEFaY0GSzxNhm/hhledKgnyo6x3rZC9V5Rjb2OlYVlYpEN5Vih4JwbXX9Ld/GVrTkttozQPgi1BmYYmEFG9NajJZgRoB7BDNzBKOZBneHFDY1T30pezZHWWvZj+XmJsb9SpMUx/CqKmsOa0Zqc9TgzYQuMS/xWgK4kSJpx6dJlL6cgYrB0SwPtjH9+wyU+8lCqREC7ZLGc1BrSSeoGpBmXQJH0LKXSd9lqVAvbwpL4sOwdWijeDQygu9AzKrKgSvpapAU2Ry0LDTIzxpttWbPY+PEdwTsewFsugteIMi7o02YiIrTZbmihcRaszxCiNh+4nUe9AS8DOXyoPoMUq4IgPqtQQMX4kDJFZSrgph3f7sDNtEYUcysYIPZI37GpEa2kX4xrM9+x2e7aZYI6HUmQFmGmeRuFX2HtyqbUzKELDIIuP583KvyyMpNuGGGBwvJ/TM9vOEG6ZfGRXPaUyoYtZoF1nPrBpj2nKrIAXLzQCnmjUAgiDfamJGS7lFvPp9J1j0r/J6HS/3dZ58eydbWATr9O6PRHCp1+2QI6XQ/pdDRrq3toZpfwZR9yKfPpo3M1kz70Nc6CnNuWBA9l3eghbbkCyQQ3DtdM1IoYSw/FpOnYS7cjMFIPaSu0k8rEjR1uQaZLSS0dRk2oraVDkdyzcTsUibVSKYJ9HfVuOspFxpTMo4vIrNnl7mYfWoTpIcG0XozpoRlMpZ0gSJiWbOiZgBTUkmJY307A/W3rtWLREurJIRJcgpioolKUWTSBzqgFRjABKmjNo8/LxfS5ivR5hmbiQ8keye+k9vhz0oMkHvLn6JdRx1D2DTGUS5IGfy4JHx+/MmZKyln+XCwIKCbbFmSeQJfhg1FYSo8Jswm9LhPpilok6GNPBPo/Dwh0dVV3nRDopHWGQJ+XKlUv17MwSrP5GZVI+15ajaMargqawIizJnG07Klb5vqSVch1EYZGMSMmo0YgGksT6RX1qOCqoAmkeJxlyqEmcVNa5WHg5PM7rKV97NBKhzJYyu0enJVaAUXSeTkOitpPfGMRk7yvV3qCY0ECmQ/t3LdQ51wjGSPUORXOhmQQuWpB5EJkkkWRk6qgaS5xTjGMKpCpnFbS10O4vpwhzlHi8w2DYMicI7WlZjfqHIkDoR3UOTASzJuxRrEVGIHZUH075g4G6rCazeHOr4vcOWQYhxLwL+DO/2U37vxfUSmzEVN+LpWiwJ1nnjvPUJAPuHNZ1tFuAXf+p4Uu8Dcd5/Hnegd/rj9n/Lm+CvHnYnPVlKxBWMCASoXw57gR0If8OcolRrvy57GPYlEfEk0bLOKA706ga9C00pgX1klMij6DTmrmM+ixOfoW0hOdLmLQK2HQS8RrwKBzr3ErxRQ6Og3jvJyl0DG5YCJ6SKTQeygIhT4LbxUp9MhWF5GcFgp94oYBleZAuk+hz4N81IN8qSsXcejKY5HLXGbJUuqRmaQiWpVRHlRO8OVUH/VZdOhyWVPwxEetIQFjS8qJNpNZAwIjN4HNlUOIZB3JI1s+koBjTGJ+lXkUpV42RRmqkjVSj6FTBLa8GKTPRIAYDTNnAh+2MwfWzGTOZJA5mcdOCV2udtDlH16q0nWNv/I3Q5pDjWZq1E+3aVfOkOalkOYCzwxrXkbgZmlzwKRQOUObI4AF7gUzsDr4grohbY7JU2jz9xdCmx8Uypw+VkPGLqLNx3NoswlIZiu0+Sw1RtRzgmTfWt369nYJJNnEk2R0k+JGSLIxkWRjMq7Gpm0ynySjwQ+STKyzDivzZBFJJqwXS7qSeeq9uyMDQAyf0wGcmcsB7sG9y3Z1T7jVPbgnRwIWpN4okHqWGDwkspJEUJi/uYgWG58SRlLCgsqzJxob6L2WlKTO44qt9PF1YdSWVzhXuuOG7m0kzN9XeMJcgzAnNZEw91w5fux3NhLmIokco6lzeUiY12vNPpkF6kCYW4z++nRzgK4PesLcioAQ5gcC0XsQDgJTJPHSXkPMhPnBxs5NWMNxX+KErfoRreZE1CBhzeckYd1BdyCwuphA9UO69MrT7uATnT25fZx0wB0EsXtQIlUTyvuaent0L2OyrYUwjwCWAv02gKVw0eUOHNfOGMeDcuiwcKQszR8pe8AVI8V8TkbKLK4ANZxCXDcD6udxYO3HKMKoYvBrGWP7Vzz0y4Et18yW75+oyFG3NrLlI8+WWzaqezKxWtmR/vw/tCke6IwiWy5WzLDl2rPlsEwsslIubDmcc3bIllu0F6HIlosZZscyZAPUNrDlZY8tvy6y5dJqwJbTbWDL31FoRfSZXsCY6wFjDq2a1IGdxFdG6ylT5lCoXUZfQplz905F0bLN4NNDWi0PXLhxuGYmVsRYeigmTXMv3Rrwmg9pVZ8Xyx1uuVspqqXHqArVtfQoonu2bociMVcqRbCvo95NR7nImHLb7nKO3eXudh9ahOohQbVejOqhGVR1nxnLoYa+zwSloJYUw/q2cIVIi95MLCpRTw6RYAkxUUWlKMvQBDqjFoHLuGwI1wB22BZa6NBvZNXQnQ6qq6haoimqvUPdIU83EYmM3SxvnLqwgavEScGDN+CjPkVeTnkUDCnyjIeoUORaGsp7qaWnyDN0bLFyW6HIK6oSinwEoZGrGoVCedd0B0V+IlUpbZJn/qRA/CtPh1OeFeoXh7+W+v/s/QugZEdVL4z3fvbu3t2n93n3nD4zs/aeSTJ5MkBIJiGQaRwwMSC5/vXKvZ/eG0zw8p0ZuAkiH1cCmZAAAwQdMUoSIunpgxoVNAjiUV4DokYFHRUwKl6jBoyCGhA1aAL/9Vuratfux5mZPFDulUlO79pVteuxatWqVatWrVWDSVJrQva6vKY3toFaensaF9yTgg1i3cyGHw4WIQzPiqMnjXnVK5/uJ2nFXACpi7CJFpCvNy78qimVj6gBK9+aUrlmrPU12/odr9Gys79SoYEpIK/teK3ajsVg3SNGY7P7EQPidnogBojO9XlplrFzLTGNv1aNpXqZFM/QMyr+H7AGBmHZQS2tjJiuVB8WMGp4xyC7Cd8aYyK3JJK56i2ANHv5zp+sD7K3vsncFtAQ7O2pTbz0tZ4vDnyc/b6qtcOO3Flse2Jvr/XawgOl74spzk7Krm5yX+3wYVXDtgrvMKIKy+W6MukVDv2EPGv3DI7fwDLCW46i0ru9QN13wReDp40ZNQN7ayLqSuM9EH+VehVEM5DnbM2R56CB9wo05Dv+6jN1fKX5AOtKXhdcF7jjo1TN2/qwbZ9+xQvQZO/4Dj5ca1CHOnLxBSIhqva5x/ACh4sz2d/bax15YHMdtRbzS9uB+/4o/a1n/cvPrD19uO+FP7b0K7/+aw98kM0CPv+sb77ljvZ3XlxaCLwLrjycscF7XvXLv/u7Z/zs04b7zvrqK3/z0DueAmODt9x48ZMf/NC7Ebzqnz7+y//5v+/C9/+/V105l/74jyDoQKAORgJn6G+YviHyQ165ycveApAW4W2yVhQhxxyRmOhIHgM4gMpXBLUxPppo7RVQqNXgH5zrgFDeBguU0Xoeq4ZdvJ5HqZbyIVjKUf5gxA1MgsDB8LKiARQ9JrdpGFV/Fc/Sn+Qb/vTugzDh0b+L45F+b5neP/xRDvYfwC/n/Px734rCmj3OdFRSBr+GFI5oplX88obr3F/9T1aEXUP80kAeXX1k+kj0URuQ+6LJeYfUlKx4ZPpI9FEbGQIXNLDTvqJh6Ouvb9JXxKOv8tS+/ob0Fb/jfZWUwd1lXwF98QhzG48sPZaeoq/4polvHmGX72E/WTBEn8cpxbcJe7DvRW99xuV/2P4LdnHl3bGe3uZ5wbWVaTIcMq5e+8nf/a8X/tFnGOc/d/uZb/jsZ/4rTxSZDK/8yru+8y+3/gbPoE8+/8NsY/MMGNb8yQdhZPN69m6jxj6d7cyIAmDppWonn/OKAwO1DOSMZAoqH+HmHKHI5r14ODiSvhltGyUDhe++K4IjReiSxSZn6Rjv8OJvc/v+hVv6//2nDy8d+PB/RkufLYX/BM9B5JEeS2jfJ/Yc+uBf/8udH2APL+96zwfe9nc5ZvY7v+32g8991Zu572g4YyybeE1/uik+VCL4UDm+e6LSn9bAkC6ehPfBKlOlR0rVOPPtRcDetapmXtX/FqBlXs7f+wIxk/aQz1uM/t13Gy8wJV28/YZQrcHpKlLSBhs4WCFC3B8Xvv35WFRGzccaD2EHf/mZW5b2XpX75N4GRWjDRwcMchjA4IeL01uMZW2098pKayhYZ6eDb3v7h7/pP/3N4jMG/MoOGup4wDPDdz77H7//6od2PAM570xu6LNHBXFjkTz8D5y68t43XP+kI4TUg//vB26XVJNy6v3FL96VIeWun3z4SCXl/iM/8e4PX/dPfdhSv6Z7ayXl4n/4g3/svvSTSDn83r97TSXljP/+y69o/ew7kXLvNdf8v5WUWz723V9+2YOvRErtFdv3VVKe/aWDl//1F54pKe8/tlhJ+dzrXrf9Ge+NJeXgX/3ZXpcS3vO85B2v+9BeAczC2yop3/bU97/iiv+6pikHL6+kRKf90/YfaYd7Kz4n8kSW5H02abjPfj4QBx+mEH4rLDS/uGntSJneYqRM7yVSpkMGKdOhiZTpI4CU6aOGlGkjjZTp2IGU6VilKRYPLXYKNFOz1YFuS8VhJZZXNWxLpd89YyfYobfa9R11YHK7WvKtcEnZ3uFD6h/2RWwu2eU+Ul6CHebOB6TyiDMBVC9TVxdsxz+g/HUrqMZnXzCxPsfeNi27N5n9trzmrhEL4a4Nh8w+UP02mMC/DStISHXX1uwndXOi1q/N7O/uHYqzTLauO0z3isf2s2u3fBG7Fk+86MImg74f+mP+zb4kOgB9OFNAKj848i0Smaa/GvjJdfG1fdkgYKdzqEs1WPA62CXO+3Zjm7Zg8QhiyEcc77iQkV8ky0OpsSx5o3yzwKIWPHmLGOHJ971jPHnPVscT6k0lZHDoC8IvvrjWNHrvHcw+mCn13L3rCoV9D/30F37/Od9zBY93U48LNbtS+eY64uocR83bilRxSI/QY4mk5iD7QZSDqEiinDFozQ4+WtNDpKdqFfk25snxQHxTM+ZtHL6WledNFxSxn3xNzaqPnZl9F1y24+y5Nzz4/eSCV/akUGoNcVxF6TAXD23Q+QJYsZ21cthGhb9qmMv5LPWWLLX0vOm2OvuHgAXnGXdy2T9prDsuPtvzSpuuHn5qxlOOqiJ6Yq50vzGfkP43GPcUZBuMIZu+LyimZA8qzgKXMh7uw791EG0wu+vbkZVUKaDw0DQ1PZumz/P8KX2oZa9+tSnuQrEH+Q5TXHYD4rGpI+mhr328EbGjHtlcu+8cbTfeN2/3PSPtfvum7XbF3zVaPN43L/5LI8W/4ySK3xgrfuO4UP/tavHvOYnij44Wj/fNi3/HSPHvP4ni7x4tHu+bF3/3SPEf3bT4M2sGIQ+/eqRwfT+G77KvGkL3poB38fB46UiP2ME3QqoicLTHM7Tnm6bQHgiyMEmjNQqVoGjEUR8RP1uJqK+Vi1kRma+aa1Xb746yIH+L81NoqJR4t9P0CkMZOpLliJPuZU0FnbV9u72fW/ynp9+PCijUbJpL8ngVQqISsMLnxoOQOMCEoG8CmADJdy9z09yyafI9b+96YfbSKJhLmV3T7bZGhJWaQsj1QNYOKVUbmZWjg4f3zTHjvhHMeDuynmhWjhaP982LP/ixkVm5afEv9+UkXuflWAX6frQ2UgOWVDH+fLupgaacdzN3nqIZhCeZ524zhVHqyHwdrRbvm/drY6Rf7z8JsN09WjzeNy/+EyPFf/Qkij82WjzeNy/+gZHiP3YSxd8zWjzeNy/+po9Xi//ESRR/72jxeN+8+DtHiv/0SRR//2jxeN+8+I+OFH/fSRT/wGjxeN+8+HtHiv/8psUHLGj+ryNsSFix4fvzMPWVvV5F1sY8OZt2hoFekCBZwFXlyMuuV18UFFZ9uwfGzZc6J0vPcEZnklkRWUvGXKKNefdXq/T75ZvwRm//4VdXeKPD12vsLSOxP2xib5ya98HD1dg3I/ZRc1df09ybsYcbI926ebwDF3r+aCW+VuJnXwaXpQmaqndIvBPWeO9IjT928jX+2vUnqDGr9T/PhWMHdgvypmdyE+SD3Fckrenps7iHuwktu8mzH/+e55jP3e6gpiabkl3+AyhYN4vEr1/Cq6qjqts5rLzIg5Ms54lPiDzO2NXCFlj53Rah4Yssyd50veKsz8Agjz30ZxuK7nza1v+l1/OUkaTstus1dueaJv0K7O5nb5VYjc/+UD5Eg35QD5B2axIm1HukPcAJYwD7dJ8XI4j19SFWutJzrEfCd+l+r8zum+y+Zvc1+23+CL8e79RgTTwp6sR4CA8BmoJdFEpjqml5On0ozn5c+4F9jirJwVFcqnOOPDRJlAv97G3I2PI2TaL4Gf5kwTE2szV8I5F3CHL0azjoP4w4bbKZ97fjYSxtobGqa/JwygUgBwoYoACriBOhuZEoW8QOjW/0vGCaeXBzrwr4L45ezBlgV08EF/iB4Wa6q5hGIVAssOMFFkptm6tR7SOKFXwjKw9Kw2nOxHb6XowQynHeb4oQWgvGAbm0hkI2Ysxxz2nbbsMgMEVqjQ05oLWBmLXCKLSGwhoGVlnSKnxo66x/T9X+NA5FVHwKxxaBrSDQCnSrjSwczn7vBmOFWk6g1G+Ia7w1AkLmhp7Ig6HO8SA/65f2sn+1VIlbWOrfVpu6WRsDaUB2ENU//qNXrduN3vAEo/fax7kVisfSjqzajvUTtOOn4SNpik98qR1Uwl6Mk4tiIQQTkRs+GYwYQyF3DBkBMIRQG+K/cggDO4QU6pn82w7JpkZvW8YG/SMBIWhShFpd1TEXu1/Q1KBXbNELtXL1Pr5o6dVGKbQunVQrO9bcA8UMU1QiNSgc8EBadgcatCJoqPZNvKpXgNuR+u8EqjtvqIJKce3fFVQ/fcOmoHJz7GdPHlThCKi8TUAVjINK1uRRUA1vqoJKJ4QBVvbvBKz1m44HrLcjFc7MlFklWaFlxfN0xYPR+guCu5CY3pA05Lif96XeK/lX/gyI72LS27CW0sttufjuxLe4ADg8opcGfd6Ae9SAI4oBnkxbbvFQ84FctWYTwKKBRZUfsMCOG3LZT6I54s4qLT2Xpf3WgaImr9g9qIsxLLZYZd2qW/hq6h1/CTQgzQIOzSCu4RYPHq1iqmc/hTrQStE+woWVLiTLCbAjmVYukMde42nJiOIRFmYZw9pQkznz3j2+GvhCqXorxywODev/7qGvQiYOiLTE5JjuAkBGG/2D3pq2WZsLqisNvhNZOMOUnX774TS8mgvD8wrzvNw89Twirdr69L5JHjOqk1SvJLBYPe9wZzKTg/ukpew2TzLPzDxrmhGWL3wxHFSHZL6Yo5TmYC9tvle0+lez0oLcAeDaYhFpx2s4hjiDgbggBZA+/luvWADwGi4DLbxZYoAbGrugH87QDC18dw+JcrE5tgJsH1lzn1uSwWBKoubLzvD35jN4cGNFbYBaMm7UoRR/l8LsQ3/vNWvSwpjiTRu3QKbqfAY1A2lmuZX5rMEdalmjRTN7fMBvlr9CzxVUC1z8gvSQa3hzvjDW+g7gx2OQ9dkWa56RRwvvg2xtLq/TPMrV63cHeUYZqOSMami0g5EvN2B96cF3Q1VWG+1ri6u1RZiZGT8A0vfJHUKe3na1fr7vMw2QgxxwTcKxq4Mb3Vs7FqkI9MzFW8tVEdJeB6nwSXpJBrUqH8fP9NfixJeLKMG1kTw9q6V2dNluAzC+h+C6XZgfdzjmZe8SpzV1Vq/IEyWUDeRJoBuNB9joXeKQUG7UZHchPyybXSKAWIU/DH5jnWbiCzTP483eQ9IjMN/Uoc6BIsseRkw+C/VzdHsWtXAONo2fe3rWBMgxws8NxcJU+TZA180+xMPDowz8fWaQo3EAl+HgPQYFl+ZiqINbPR7a9eyitv8AQ9VQ6ZroNXvU4ScjyAwewKssEB0y27pinrj18wSIWZd9HamdakCoGTRiRhoBXKCG6SJXyXyaFNH3dMmq6eZfbuhlX0Eu2//Ziikwecye7of5AuI5cL4fAm/xiMFHvn+Zq3r/sso6nMfJFJ6i56jJwBpSYiTCp+/lM8w5sZDHjQ1Q3bzWCgXRGYryDoN9nmYU3biNc+pcEWOsqjiAvN1+IDZPRPOyIwPmYcDwUcjgkE+S4XuFxDCEACYRRrGGqlLsDiY4gM01MPnQSMG4OeJ5j+UXUNSeUQysArssKJR9VbGJARty5CoSXc56/6M1+DwAjlZj97jIN5eR5CLfrZE8Qez2fy491khZgiN3ukJ+YkoFWLOvdSx/XTPLxCgS7nRFtYu7I1FHKmMA5DTuGPBDRXN/P9Nbpx5sxVFgbsPhSwSS4XCIEwKzkOl8bBrx7803lDJCUJH3y7vQlY9K8LYpp8lGUoz0FCeuYBlUHDtW2sdcaZ+Q4Fs3K00/TftSP7EDLgPL2jdTyj/X5K19b/rbXxz8868ffjqUp8oXvrHYFgZEVsQ62JWkL9XCUCC4wXeiJDAGQDrMZJRKM8qlGDgWHQNJgLFDTTAUeQYOQ4rKZ91CPOeCiQvO64K9gE+kC/liJXHqJ3NoLzdQBm0Bt10LDF7bDt4SLZWDt6iDV2kQ4G2qKhYRPCrB5WcVXVCbvEmLMh2bUhh1QPww+6xKNWYP93oZ06b0QhpxO7oH1vItJe1CYVsoM1dB35uvUEwZpQdgxqhaBxcvddDKzTxjUUs4UQtlmKpcVjlVs2Kp4gUe6N9jT/erBLxd5ZFNZD5zBFNtiZijeerR0nDAlGcBpS1Up4HsITJd4mfzDjd/FpA5JpDpPqtYFMh0ODYBrLvPwjuo0BKipSMdWlLo964slnt5B7URBzjWfGQA5oPSZRy3YXowuGhIHXzJrSvm+av5I/xAT+av7K1jKrpjMoQC1sZ5OmdNKHgBruSWGP38NmhgADfkGJhFEW2EaKiyr2qlSjsxa9pD/Ilq+i+pRn/CQw2VlXblUDGghNvhAO6CV/aGReLmlwtexbOrJYPlBAW/WI+x/8BfxS3awcARsnr/S/6auXST/ZJM5IAHV96HOXdYbInyYroBKuRsQqp/myJ9ll6vFdNXHN+2x5fEKb40J+ClWV3X1EFbBp7O/Fv4ia4fxrPBmit4eqzQws8J3hybwjuRQZrLOi0SBo9PYTlA2T/cID0Cuy9MQZ03HV7h43m7h6aq+DDSzskAKedZttlhe97EA6Kcuqx92kgu3ewx/FS7geb27/f5ErG2RzddYngzb2kbHpQWfEl3VLL+tnGVijhPSC2RO7SUQfABQuhGNagFQ+XZl6RHKKxo6XV95v60tKLB2VW0YPVR2phlbVNlAwXr/KqDgTzmT4NrMcOQvQdcvqdQlWXMjEpLR6PSUB0mAJgXgg04qJZxuBdjckCCx3C1hN0Uv5Dq2GRfwQ+uwr9aE5HvKh33y6kOaw2X6IMBpajmwxlanfixhx/AnQtrz1PQShF7ULOX/aMAJhSo31tjNRod+jO5L0qJ7vXzEE3XLuBzHThH06HYLE1RVGxqp/E8ZFDyRn0qEDzFPYt1kCFk/4xap6KL3L/XWZ6Ul4+GmO8Gh8fbhXCg03Zz1SEsIe6k5qtOrea4n2GJnTwpc5/9je+F09x86mS3GxMrqoa0VwXT5rgnVBnwZSYu4iwvNU5K+jV1Yq6KzxApqzMvVMAyUF+9QX4/tj3IYKREAUc+ZKREkTCS2YMiUAsh4Qk2ryXUWtAmNWisP5BYFd7+PLKbrgj5rDAdRWIrdbqfnG/yg30Vc3ooUf3w4TxVH6E8kJZ9+QbjohMNsg61PSy3erRUFRv9lcrYPuAHoRBkBz9toTsDMNbUJKaIUDR5MMiGlpvrp4GabtELp4kabonFagjmuxSNMaJQIAUWn7PE5mtZoeqVQwK1s6I7ytiI/Ul3ohOnAN4mpwAJ8ALV8V8pF02mnAIUiW5xQ9egia6EaFDoGuRElN/iMJxK154UQEDW5Qd24epYMzGynwDY8/PX684sKBdG8tIf8kMjmrPs/WC5RH5HJQIdEVL7djtxz7aaCmCCkYjl0kzMbE8gx1CcPdLFxO9vLGGBDXTfnKvcExCe3IOLR8XLUeLzsl9AjIgsI93i3L7MX95ut38Sv6ca/eYymqrRutFRr5pAYtRui+AuW4AE6X0e+89Vp8DgZPdd8vPvv+2Lf/gDT9/38Y/h3wMXZ6+5wWrNYMsuQrjs/GAPScxuqpXHIISw0AvstxRRLELDEZpgpqA9I+0BHGPxMF+CSQc3s+qx/sAa8j5bHQNmRR0shEhucb73fWvWJKQapCmPSS53HaBwo8Kw9lgX9XlUSz8aBtjfVU+WI3v+a9a+mvCpeYwH5XXE7skTkd+gN1OZky4IvePfQOhlywk2d0NkQ/2usFnuPkDYM/wWNwJJEZwLY+OdfdogSiRfiaS6JNyATvanCBlPi4WAcndhDCWSSt70CjjxRRHfKn8RGB+rGtalWArPXo0xFUqAghRlI8ygVU7nxwJF2By25BHskjbhKKuL0Ol+FxJnxO0CcpUhcmrWTvXbBHbu3ff5/7Sx7TWf+72LKcpuUMIiQnt1WpkVDe1KV0355L41+Hg4KEIR+vMGDLrZWHBhTy5U/V6cDEMDtwu2CAscnkeGpY7c+gDiTDM90VNswOWiedy/JWAcNIIJ10cF0Y0CoqiiKJC+wcdVUEs4jtVGaBF5YJeHBZe9CwP6wKIYehE3r8F07NHk3RQAyJdQAO/l3IB9Erobs3+vBIENexB6uObv4Q8ThAXi51YgTiHjGSD8nzb+ie8TTcJdyeL/fqPh9in38ejmekM5x+HLMefFlQu78Kbdf/GD/+v7nw5txzP/37effmbvCg57G3xB6BGqvQw8SENfNanX4SvFxhfZLyrtU12Y7L3mVCUQWZnEUQBBGQiF0HruMUtDNAEQlNzwfB3cracPAFjQZYAdw7va3z2LqzzLatg4NZD0I42mXRhmdd90bXWs6xWPyqgrqwp2AxOp+F8VDDFOyWmOzloqYpVlqIsxRzhk9XtPxPsXfh7lZ5OfH+Nnys8762tiFuOBcA3+2toc/DxvdWZw3M7PDj9v9lk4yc8BP2f5eYifc/w85sE+Vz7PwXu4tAWZBVhtF1EuxyxpJkQtc/BwJFV0kT9kIQPWOdGe9Sh2O0UEcQtKu7hyQbBRxwp2tJ73UEbgdgkoER8zvaYVTcs2ZM1bzX4ZT+0WrWa/grfK9x+V77coqLdMnT5AeLYZe8yjENXfHhVbWYbl0bKrHumZJt8Z0VZQx416seLukfZA6hbdB6hdQSKg4kb7PIJQdEAZ97ClDSzb79OmlweXaIJ+C4yYJ8mOufZ+ZFyRxI36GupCsCNCzjnNBlHnBzRbTWvOPqjFQ0D6sToQoe5WgWxKXGdK3MxEnJpMcPYYxKTiCvcwVrNdw2GxbQjBe6ZgylfQ5XuDnMEGIpxvR/z9YU6Y9Nyh67Bt3TDXpHMtn2ib+sgYDinfd8Pdv/mi3f/9vosrNzWJaDttxd9lvY3yxpzN8K17B8RNquRHCwdOfjPkCLlmyvlwT5GbSwavPmRh3T6PW2sijxpw9CpxbzZxrUrch03cgosrQZlOiWtW4j5i4hpT4pamfNudErc62T6deRwf6TTSvJCNY82qy5oFhKm79enpVZpsz5lUQXCapt7o2VSaXiz7EN0u/pnMUvdVWNRUkOKZEyFmdvRoBunSmPR/e6KKPa6Jps340UOlLuuC1tgSY8/kG6fJ+BFLLhQcKOzR+o/hq6n62fWHU/CghOcu8+yqhhn3CKsnBUBtFc3o7BJeEIvAt0ObVhz+b8iOUCEx8JWM38LP7C2HDLQdeP818tPR5b+iLMHMe0lWnq+bYjDwVDM9NwbBfdnmCShVg7EGU48RBYjHCch21p74PuYgLzHQjsUnNkXKUns4xLhFNWCiTb78VsEMVfKn0AgfoVQU44F13lOmDrwWCAGAriWLIF61EPdort3k2WP3Bz90Hb5CRtmw+XurChoi5sINMv18p3zur4KFExFW0VTz28ZFOUhQ2eIi1d5KN1va6YQfimDaX3GhjFNHcHrZp8GcqZnMWBpAXHwwWS5goedgcarldnWCfLu6uY/5L0LNiOs62QGD5GUUHUC7lW4DgFRf42rEnKke0NQFAHkgo5+3gcHgpjxpoziUlyajTwgtyPIA+FEoDtlaFFBdoY9+3op+5i3UdQlOouswbkVtJqV1PZhDj2VLH4kWjvRDZX22okRL+rKMYwO5GtVBQl32gwTMPr7KjgKY6p9ah1dJEGdy/GA6DLxGVVw0MbUDyBJXwZdToLM8kFne18s9NUV3TrQ+0NX9bNxXWUCAhNUCco+6ii7UqZrwlDAlv6qe8rinGF/v+5iM5U0ttMWxgd1CBFZYLWRJjpUFP1gwjR5lIFgNe6YiQejTXocrIT41nTUYirFvQtekbFgl8xSVIpTT6osnqDUshbVLemtUd2bkqx21IJdCtIRWzq+q4DtE+WOdAKE12xslin3/UghsTNuV2FKgzsErNm6C9NMxG9poXqek7phXOdOqbhNwNvejnzr1/vScWT6bK1j59m6ZapBuVq5Jws1ULXu/4GRTCePl5K4SbfBhSkzNwaBg45r3eLpTGRbxqI0OMN3YXnAVQ5ISgVKm1FB4Bv4YW7ihKSjlRrxi4ee++c9/4Gbmi5tGMqbLWVNuW26s54L6+3Sq7MnbeJyVz+BBeUelexkeC/lsf/Q8kK0JzQd7XUSIIyiag1hxYa1YFN9pqiZ1HcZ7HiMqVgYzWmAGeuRDGaAODuv5szWlFWCqAAiaIfcyuIPalVdqjaQNyN9YH/BLdFXbo0UVM8I8K/ZnGHeI+PinpOQh7MvMMyRynF6FAx7eOeDdHHlGxcrQOCiMjEm+R0F4s6cwPOQpEK9VIF6tQHyeAvGqcSA2H3cgxo8HGIePFI7fXoFjE3BsjsJRHcoCxwUxf64ZtnhXGDsW4GjN7QpLlgYy4+niIiwjVUMgZfjcvetvfSgohKrHG3J9OoSMYg/mDtZ/MIOQ+u3m8n0On7WmwvTsz7GZL+qoErHiVM+opCCG1mQyaIxsLhc0ph+smcimsAF5KsxY3rKObdW9qHjjcZ6qMYyMOjgBnwFdG9F+44GcASs3dPcQZ7BazYzec3TXClQMj32sMm0t/j4+QGGpETCWDnPG/tpoFj0WNzk7rjVZv6ZY63xoUIfztUQlBhNhTkWIG6oZ00/yuurXCdlWy20e+TxGAgjFtOEg+4BQLk+9nM6skSd33bHJrtvuxjKMqj7bASJJrdShOfATQLZOW1QROnAhhrbARRFPwA43RgqG4U48FjnTklp2qwCaFriSJa6vI+0FqtepfbU1FT0jDc0925w6pWhceVBAfPKNvLbEvU5ksdTj4SN/Xa29+cCKJXRmiTqYNACUDFoXMZxeLNg+LQrE4BJJeC0L8f4r1e45tK4g2Ktb3Y66nNzMMBzIL4dimEPV6eVotF+RjXRV4OApo6A2rcHALNO8dFUxLcMZaJsjKt9WBcFDk7vwVMFJmjIj0KKuKwkEIcEYpdyKjlnPR2/kLrtgF128rC1D6EE0swRtxgPCH9cr2QTF/LxaiJx9+mULbQr3ryf95dXVijIp3ViXZtOymhVThSpW4ukNGGRd8gYAkrKGZtzq0gRMVCV3i5TR8hEtZRZps1xOd5CLHOJZ+QwGATKjGTUjLjvcRCfaYbe/XQAFKWPAQhKoTBnDFNFtl349jVoiSQv47+uGYv7FY6WY36CYC1WKqdktwVwYJ5iFt+/sb1r93F+ct3Kx2Irxyr4d/dBwWOnmIqrwsr/TG2/kw5BXvmj0v4ShRg3+8KQL9FyBoqklBXKUpdyL5At9H/Ks4N+vCR1fBix0/m+ZpOPLXMmWCh3vPlI6vmUTOr5lko5vQWe2TNDxLUrHl22fuo8PHV+cRscXNqHji48bHV94RHR80QUXxun4Fpql5Qk6vjBJxxcfFR1fnKTji7QAOr5wAjrepYwWx+n4wteUjr/p8bz+Br0ODnvZn73RXnaDJC73yltw95YJuSfb5LFbcL/pe+E0fReCEH/N6ruoCET3Qe/w9PKyGJa+y5M7DtlACtMMg2qGt49kULMkvjVM0r/ZgzRBDyQDaETp1aLQfcFfw2J4/3IMmDTrvtpYsyT2nvHY/u7RqhaqNXU3rcjWsjCtkmQi0skLvp6uxS/W+pAEyLEdpAUIrKfP5DKwxphrX3JlnV/1Cb1RCeiF9NRdVSLPKGr9uiS8yAsmBVcVHSeRGfVfWp4nh2oDoXL2DjiH/e8yAxqwl74iwItDT6dW9YZGEl3nyy7Rkz+3W1wq9S+1Q/IQWdczxXsTPC0kQlDxFtk3VaDcWNJ1VtRoVSkFeovO3FXLEaW2LH3sQwAUmAKjQJiDDO7CQWFdbr7M8vNj/JybXoZZ2D3xlM7Vtz2lRlBxq14lIaPGks9LfL5gW5loK51MzviEKkDq+NSNtWYWUnUWkxiJnNaUJ7bLEHySslgqT4BSTZL9howrdHmxRzoaYE7cITg9T4vgQWayu6VJDS3o/UuuYGqg4KklItP7JZN+ZLO8v1ppneaQptFWiY9mK3FvNnGZi1N1nFKJG2DUFmW/qYc6EpX9lpCBlqh51TVXsjZRWwJ05B+3monufOX6AVYRoPYS/EnOC/DnxZ09HqEZEUpoQcZjaHWw3DDMM/JDQ1rfWtRSjWsMm9F3572aQWLsUStLJBeMLHlXO0i+7DaLLeroS8tZHBYr2W/bE1/iNOMerkeL/F+XizfXUJYArhVx+2W/HrIGetHd973y77MXDx8K+tFa9jGUBolxF190K2zHSl/vsMzL1bEedZUDTAx/uojiIdzXiKFp9qK2b4gVWfXTICkCUFCHioci13ILGGqto+V222yoRJuWB/BcAVRvGnVjAz2ZnTLgoerutNen6OhNzozpUwIze8nS91b6bM+bTvnwpQ9jKoHSuqpeqU6nI0LMqoTtrZ5Y8XjGP//hp/75hi/89K1HjRaEmKZwWx4T2LKXSjP+QC1noi/7xA3l3VFcuQuyv3qDOaDzrR3Yi9cfCsBMpqC73stYazagGloL0l5mosBcOaulv12PO7zXBOX1X+Hbu7b3emWvzSHnJtvMBOvRwQB6d9g5XUGiJYfro/1XSBPA15IPTsVoekfZ55VPwZFVBjjp9IQVtAj3oGMK4RZTiukTeDgPn0O3Hs6jG4A0vzb1ZClUm4t5qvePOdTSJvGJaYg9RU3bkM+4EjvIcWMAIe0GE/NYrqtgm6abkxhzUXKrG6tPc22LfS9fogW9bvtLJSCHDu40OyiWafn2YpknGXUHzkL8ex+el00Mt0SWygQ7a2m0R01u8cO1sIbJJoVvoZWHPyvOcCX+4fu8fEXU1AqMit6e5G84VxqKQvc1udcPczn3IA/Ji7TMOPBKxk/MJqSTD55JhWJU5z7N5TXJq53Ex9hT6zDhUlugd13llmuA23oSYoDaW4XObmMGhvN5NHMAz+9aExAGpryOKvc+3PB1F6f9C6Rrfo27ma/YObUiiFDtdGpibFdroAE1W21AbdljBNaMZCLRPn+eye8VUnw/Q6WjpWs39QWNkNpGi9crsz0zZp6+rgJCpjGr5ONi5DXcvZfIfdpV6iGKEa0a20PrrlF49P2cgamudxYApoKLeR9QZkg9fQKB7E1Cmlcxnb7ofSBdZIyoXV9S9Ka8OXvT12TD8Tduw9Gt7jc+d4L9xo/UM3uZJjEMnW/evVdwaCq5UdZp37eJOt495QRL9g5UUhJg2YqZtFRsX+eRtslM71h1FPK60kmc4QlBgGdHONwwBKHyBcACgtCmcAPXtTfyDm6JucW5ekeupA3zhjYsUEA2wzGYDJ9ZLyLVIs0XKTLG+CNQED2qr1KNzgAH77ez8UOgwBjV6CoGijpZXanGCihgQitKNXpmVnWpB6rRqEyg3hjVmOdvqCfYuwVI2TBUYws1kLxA0SjVqBmqsSBUI+beLuLoa5RqNEqq0VgrVpRqrIJWrIBqrFaohnostdO3rVQjrVKNFS0PN3lKqtEt+7dSoRo9e5W3N041eo5q9KZQjRVqCtVYMSf806lGz1CN3omoRm8a1Vg1Y9bQ162AkGnM1nGqsZVWp1CNVbTuGoWHUI0VNHK2IqGbpTna+j7RkaRVfbJN/TlzCZFCJROMh3k0QiAoSn91UyEAUwe96Hr7j1RM692MF9alwkPvvSJGje5pTlyPlWTdLf/sDVZpB2OLpqiaUqsAxXFKMQ9cDO1P9J6gr/QOfCb5cjXqhUQubzKdbNmt7J1lpBpl8vVzZMjDkjN0LG0ZGhgGayS1vDnvzEFBZBio2kfVkN82Y59L99Mgfbr/zX5HmMm/S5rGz2VJ8MLrgvLaxPmV24SQTdx+Pj8jNlFyfnV3G07ubjl+ZH+re+DQihRDxAkfUO8fXoYu6CHiqMrxs17+qujaVm1+6140BamBqgGMP5tkNhnb97PfRboWTeEaNpiXy53bCl42jWJ8/yABBZWWy8ZJry9gurnmtPRecbsSE+gOmNpyZZhFkyOS9iZ4d07rHigyoxMVqk7U6C2TJrZSMvS2Se56SYeaw3zW7cDm9DamMH/FPC+y6mN6Bo8Oy8nlilu5CA2psy538ErVLsbi3QZgddxLqEOBLjumKth5xO+3n89LEAhC4K6DUgYVutYBbpg0n0J0ZlFvbCzKecdipT8u2BGXseKKsBJJdahRLcmY5Mu2iIIJ9ihQOkUX7EZTbhl3dNvUREyXY44osF4+ahKu76ETKPmS22hRFPVx+1Du/RE/Oqy0jwdhsPh+sL6iBkmvwimRYwKzh8fKrGCycKM1Sc9+D5F6FDInaBCi9t0UWmZI3vfgPeH3RKklkP4WgbQcPoEAxjSPj/GdtM7g7oJ5r1nfJwf3Dosmn4mpR75IRp4i45K3cwSotHFEVWZrlvnS/amMZZ7gEeYNcHazg7xl75U2KNnf777I3ilN9VrS5YotuueR6D2V2DeXsVSJfbfGMukwNMjJ9VtHbk3fGQSwCT31rNBj4BYRyFP2OZVjsr2kpTzG8xDOwuV23iqIDC5FhKDwZ7kjQZz0gWxzSC6vJOX5YFaGSMhfDCzBja5SN7lkiWQK2psrcMWIazgJHruLxghJ8F0Qnokqby6oot5Errc0QftEEBZQE8iivjVFPVPFC4H86GBmXxSONQZKEJKTog6XN+Qjpkt4YUCZ4nSEE1x1cfKdCkTcVRcUCY1+Z126qK/rlSafEBo5GEjf6bO3mqrjY3h0oeAD8MYCRnrEWlMy+m7duKh/vFD1ZYPSgwwKgg5b9bMHzWcmQR9aTHir+3JKSdNb4oo8cVv1ZmSozPCwcOQImujPFw99muGIZghGlO2QoZa+EcrRsV09M3d1CLfWSgeIQwVmjFcd1kQ0aDkhpDofVTaowdCC0QI85PITNCazIWqWO/x5ItiCicz5tG0NsSTkZDlZzV67yf5A1vp/CGK3zoe2lQ+c9TW4GulsuwfrnMsD1nEuT69MTr0hmUcTtyfdUl+XZkiT5NodJHKD8hrjMG9gadTLv1BPnCJhKuP09iUYDJqITMl+eyk7+EGrGxQPsQrx7FofDMx9yc9fjERv35Pl3+dY/ui1ZH9rTdZ8HheQPn+WpZyI31ONfnMZTdVopZ16K3TiQqfeCdXI8RuhGmm/5yF1d2Fv9zwechVdBHqEn0fOSKy5iNXPKMo+qfbeaiZqj2TWWN22VjN/alpmjQUnH1YNW42xqqqjJ7cJrhX7WdIcvSttrkhXKK3WXXmTgVYyqXfPyZfJMMz+0EhzkXxvrdSMr2q8om3qHXQ9PTDhoCCw7QjxUF4NuK6V5UD3UCsU9K8Ps3t0ucOSAoE25gGqdkxcgMqydR4HH3WVKugZfsTwgrHB+GJAZdSHmLoWXR+hRZVrTcwH1FD+pT1++jji9w+ofV45HKvZk/ojxGV4lUtrFYMj2T9hnUl/zLWuVfjaPv9xbNyjbdebPB+SmFLUABN6JRJ6iptUu3KEOPERa6hWaAeVcUfdfvmpX35aREKWOHukVOw6vZ8+8T08U/5ZFEDTqTSleWyppJ2lPcQ8KC0i5iEwG69iTxKBOxEYIaaRC8ZY5ygYSY4trWUcA5YxFY0trVXOrv/CPFE71cYQ8yRpbWDOgMnrP/CvxsVa9icVkxkJLtBGej7U5NKaXK7rReL6BstIDaVO1dNTid3jIt9cRpJERtSkBISbvAMbuMcyGOZ1yao0S/0Uaodc1+scLR0D2UjlSqc7vFT9EhRhuh26u4sOGCoKNHY37e3rRilE/NgSBz5mD93Uegv0fHTQpAS1dPmQBJvWIk5iLeLYI7WmsYjT9/MZdKVNM+rPszUBqHQMSjqWGPUAFjQahjP7stvwUrvnroWDaAsfD/ZRj1ojsxhjCygN0iNQnI6vZ/8bH8LRVxOYjYFNhelXg0KA6rHyMKnOtpj18vPEFRC9yN6vKWduDuAB1yXQbPDnRYgBnMpT17J/VvmrqAap5cGgeqvBUZb/snc4SF8dBLhjVk4zGruXm5CYE59+ZyziO2KZKhwS9Ao4uHMN0qFFdZuF9KOLJnDMBu61gQc40L/ef6q3sehkAnUjE9DL6wuQa8qS1rQemdVgZ6t6ZC4cHGKxPey3n9sOMAmye/XWDrWyP1cKpHyWqQEf4NmCiR5ciCHdsNVTpzIEB82cnLh7PmGfphm6j2Xh6rfUyr1oA/X/6I08/xFvrdzHEp/9hXmJrT37n/ZDVW/w4KsMsq9dgOLdTUDRQUhWDF0kAnelpUbw07JIAZRcIp0s2DzgUk/8fRTzyRlvhJ95zYWcCZpiYBD5Vn2ivDWkxsqGYzODi0aXwCFpCgJ2G3GIuT1U8MuLMBwhewGu2VN60bh139J//qu3/Xzw+xddCbAxVl/IOTG62KYzAOXOiBpYKpIhCh1WWPle9peK4Wp3KQS4w2ovHdhr2X3CV/+950XXyv2XxdzH8+iiXBdj7AK3k70Z4M8jwy7+q9N0c0I9XTPLhPFArezvNT0FrctL3hFw2HD96QPgmIOiW1n4+267Ff9+8+JSZ/KCvYMhReXMHFJcVUMd3qHK8OGwEKM9UhSc9A6q3w/T72ZD93rWaq+X2oniKxoDFWRHCes8DK+qqXjfnU07Uz1gDdSyzr+VNf/BoePbYf+3sUr/UzccvxVb9PLdJ/HCkDz8u8aZkZd+0Y/q1wXG/Jta34dngdolbTW1wjPsmHeAy7q/dgBnATx9Zcn1xKAQHlgGxV2jIWMoI2WDqr/kECL74kFzW1Gozoa+Q8uBpuWboZjji85kSga9Um1c6zbi8oDJWCWHlLEqywz0kqmuesnkS0axSDonGh0dms2+/EZpCaBtwm2al1NHLDuuQGrxHXdTh39Nb6gHlP3BdXqRSjpibtfN9Y++CmqUs4ibLbWT+ndxLK+fuNfUAL19KUXPRlL6B1HTN0YjIv6LORxeG+pUwFIyZTmSxWZ0whfekdxXqh9gdDA4u3lf1B/lBSHRf1Zen2qzsjEiK1WZlp2iR9ksSFV5tWWM0rVKpQ2bcw87FJtRQgsDrkp8wfwYjVtXxowLZi7YccFZYHRKHZZX82NmWL1Jxio1MEqR83KQL02/YeGCW1xwRZj4paK3P1+lxXwrLeTbplaeOY1raT5tA6uzRKuYeluBIds2htCGnmVko61Qt0Es9Glnuck0AwHzUr6NlkQnQXBlUc6xud09oMESo9ocTr3zZdrCoS6HuvycH+JQtMOYtcJvW/hUfCZH+gqj9SBfoR4KXL61NLME8HTta40domaY9LOw3EmzTGubFyhHksH6MWUc0+CLm4iZoU72JkwlV1YxI2YtZzhXcgFYmlaJZ06yq1Z6KXZJ5c3iviL8F6OwKSjtjGUtlbf6N92/KHvtjpMoyj7rOHnQdzxwMlR/ZpGABBpFciTjPbTvajMM+EaRy+Osyjfs7kP5b4rLDUEsGwLYfeR3axC+3AUA7TWzpsRMrcd2AiBY+Bg2tZY4cPtSqd8j+4BOdR9Qd/uAxO4D6nYfwKFETKm7fQCklrIT6FxqWPYIjA40etoenNvOnJjTB2njuLyO7/Gt6SzNgPPX3q6Tn/0VviE1m4TIpMjcfXJtG+M+kjl+1sbbrYJeiOhg0nSq+wMvxaKA4vKsUp8D4v0CxDk9cwHWzg1HC07GCo6xH0rQBWfPOZUYJ9NqYD/UMDLt4wxABfx+CX75yOKdgV9deYyY8douq28JI+C8LwyuVexYqlpO/cQS3Bz9NVqEnlCEzaKegd6NZyIGi44tkQ9NjYYI+PKmnoFAox/aFpb04qCNi2tDVQCHMDNW+NbAz0yfA4r0uih0VOSacR+nYUjfe1Yvn5VSu5CWdgD6WZT+zWa3P2fL9/KQZiBXlVU0VO3ODh6LelwIVJqDmu46BXpoqhYvFyhCIEHmhDU5KbI4EwHQS/hkSEsaWcr1IiBSRPMY73ldS3W8UY87RDIx7gCpKTFOgNkBBnQo08E0dCzAmx6mYMebOBMbFEvz7DGYksmqHQUUFxkjGRg6cGsAXvY32gAeeosYr/YDJYUj15dVXFpGvQDHjZXrIN8LE8GT59QQKPmGHu5S7cPWiHwjVCsrdh4hL3nV469p7AQ2qF72ec0AA2QjxqjkVlXV5XYRr+d+tUoPuwc1+/7gInFq6E5b1GTa3aEXV/rvj4pH1et3uS/53spFOGx6HJAqauv4aFi+VRSHpLT1IjhCgUseFqGDYVjZHt0BMUn2R7qZJVjA0xcUEw6P5IFMoeqGhluHqOpe6dYXyMyYLnUE9BzshjIkm/WCPJw1REdMH/wj5J9cHwBnablu0cnXMMQ1Q9sVv+ocVntFnnZHw9oPhKrtDQWFtGWhtHdAoWkhmupRNKiab6B4pGkxdsm2aXUKMbP0TU+m0LqYWxdCOoot5hEKBxVIkldFvfX0OVAm3tQ3xr+8sbonVKItib6zLev2hY/wIgv2qNfie7FJiRvc9y/iqdv0YRHoPh0YRSEMZFAAAwBlnmOcRyyeSiqAf4HIiLJ/ELn02yGhCiumJp16kt6tq7L8XDWjeBE6afId2Q+rTEAdslV34AUgy39X9jQPTh8djLOHUb29iumP2eFATZjiKiPzUAwPu2uKC2rp6iiZ0EnkdO2goJJT5RdqlJMi+FDv4guXWUhOGZEdHa4PbkV5fiXLZHk+rA9qeZko6sIqDX6ewNIo5DBX9WuaCFM5ZxpmBk8AQKFhPAhZfxSeM/f3oO8Hjq3NyvW9n+SJYNwcWDOYdMwbiOPawLrwu1q3vYb0voSIeywr/HnlSgFw3DGQdQWhkCITSsAGein8Xb7VEKuIkuzvLDOBCdFS75kcfYtZhFprpSvNETUiTKsDWl8NTYQUUbwI5ByAwmIiW9WigUaWDQTYqt7635v9PYq2FxIiCuE7QO5pJqrM6D6FYIAX4wfwQTU2RuwXVOWFPFQcqHJiuXPOSr0Bz/NeofIMWVfMFIXoQgAOGIsIhT8hnNEC7dk4Ei4JZLfhF1tk5u9V8haMJgVKTS6fKv8NWdUfFsDwfKF5vlyp0CGPVONOLdIGEno2sRZc4M1NetJF3c9WGyqXgFIbQgYWD5TxADdbJalfVNBK/n4ign8At97nAEQxyf68IV2Va+X3C4eYlNwhitdazhJDSTNaU4tS1EKxuFgLURWfGfyDgL+tDm7wSZERFz+L8AvzOWrxdlsu6GDHCLYnu5TLmH3uNXrPF4gI69Gx8Wrgi+B0QW5+4x65WHnwqC5OFThbb/+BtdJ+1iI1pLGcwMVc2lsjtiQZ87leIL6gbnZG91Em+WafqcihJljsbdjEcHMLEAPrRfXLHaRr1My+JLNlUaK4kmJB0bZN8QHUiStgyte3eATK7a4OQfAya9qlBj48+0c9aHHoeVfsLV83qaVRg8120a/2RA/bg04UbOdKPyjESGT/hMKcEbEDyiBqfvLgt6OI1aIeP8ChCk8XwgLBj0DAAsjD7JSJhBf7f76+xLZQYeCpea2aYhvIrWBbUKJaULYgKcTwTvYgUgrli5VL9kQgT/X9ascT9t3VdhtFKsVsYuKF/5NCbsT/LHBon8L+MtQpL+mhdg+j6ck45lGFzFRxXRG7ZRC7DQS2SB0qUpvOwM6ZWVIVoQOH0NLsjjY7Q0NxH4f47zLe66gjpzld+ee5zfmCdJxDemC9CAmNTIBl6ZjexYcsEdIayO+XIAoKGRQwX/A/aWGNf7l5jOtr7t2jDmHXhZGhBQoFFiHNX9KjLqilEZlykidJXjWpSTD8NctgWjb6vKpIyolFCp9XmB1ieqJJ+u7gC42rMe+2y0hZNjf6dbrIJHEIUqOWThKoc5TTJNVd7wx5Ok0iSnWa6MQbnx8xhkCnR0AJxigorxGnHHYEPQ477C/J4z9F9TzQwQ0VRaUBUjoQVd0GaQbbuiI26AKpTV0NPWMFwZQBZBV/VBQtX3yXWuBp5Tg4i5QWCuJk/6KTQOlfCz0OoKCDgSjitRxoxo8ZsW+g1yNKx3odMBIBhqGNkHi6mkEoAgUjj1OKEJERQrOI/BG5WkSSVSJIMyD45opzPVLvdBhLiFPlOUNtebatvnvLXimu6+ApWZaeiMg7UkVj4zgNS0D2ryookXJic4dIux7pMOqRoAGyHVzr29ODz/e6LqPeGk8D1vU/eDFgeeDdP4pJpbaDPf4O3IUbrFi5cZlXgnqUGNrrTm3mtRNaUxNpcmcNe/r9eaaTs01NGV6MBeT8LamkRfWXFDE1gRExNTA9+U0XMlAwrJ8ABJaSQPb47QPc7VkWfT237UFZQH3Bxf2IXb6BnKaUcQcPyHwy5h7ndF0ad1KoY6bg1Bk4qkQcU6B31cBpeFUnZxjEnAcRAG+ZWZkgLrESKOUVjS+IV07zBeFP+ILwJ31BcLOrviDQYvB6x/cF4RtfEPq1+oJwnoq4gGun+4LwnS+IV99U9QURTvEF4Y37gggosS49sj+6oeoLAg0KXYMmuhKiQaFrkHOl8X8q+N7zxscEvuHrHyP4fud1Ar6fWk3OuM5/BRNr8zdTuofyqiodX6qtKSEJdNLLZrhCYmUBU7bspXmsK2zdaUUkeCTC/VNdLA8iIhNVHbAE6mcUwbbGzLiYjsZkLmaWZ94c/6GsgGIRWc7nTQpwbif20pRSGo4x6vsvKxYhxVzsBwd4/V8EY7Dch72uFIu/nB9i8Wib9XgL1fjiF+5qyQ2nQC5+uVe0IbB+5qsuDrnSOblvTnMHcl7vMS41hFdxF2ENoa0cWpbQNg4tSmg77k+9BCHikC+hHM2XUMHN2yGbuR1EwkXnO+Ul15dT5KXQl1PlZVVfTqN5ftmqL7vkZZu+nC4v2/XlDHnp6cuZoKLmftrpejkPOoq4pJafRWcqYPByNu3Cyzny8gQ6Ay+75eWJdBpenkTISMWTKZTnuXy5rHgK7ZaX8+gceZ6PyD38w1svoifR2XQWYi6gJ9ITELhQk2p0KqEZ9GQ69+HPeFwm0jkgmZ4ot9wu5xo+66EEJJxF59N5HJjc9uGLs/FznnyWFefzZ7YFIZ1HKIbLRzQKQO2naO1PoT0oW+u7Quu7gC5E3FMkjjtWKQwfmMIQbQvbicJq3BXtgXx4dfFEZDyLztbGI243N9MVVuNEyfMEzuMKk/UnNLceA70isgOLzg6aUwZiC+63bqEuIhnjOLLlq4xCdlWvXJvxvZqfltPEP+40meFKOv8Bpsk3psk3pkmQYlYEL86343Fp26PtmBLERWyjND/DTImMC5w1U+KMRz4lsuqU2AZUPpO28QzUKcG4SCTov4VD2yXUA8JJaBXorxOGm3K6oP/pFq+fhBeL1zvlZYedC/P8ssXOBbz07FzAy5lmLlSQfNcEkp9aRfLTKkiuaLBb8ZmxANHA75UKftvh2k1nYaQEzzTODHxokPV8JAuC/uG7v/vi6h+GHXjxRHqKYO/F1b9iDycKEmp1gjTnkY09axLfzZyxWKO4/2SD++eOoOv59GQUCKx1GPYkRVc74RT3p6ArPVp0PR2YebpF1zP6GUjSNkQyXhiqrvpcW/QS6JmUgiJa1NrBaBjy6OAJ6nMm0OY0YkpmqO8ujtoiyHR6SVXP4HJOFbQ6lc5QrNgtL7ssjs3zy+kWx/BymsGxCvLsnECeUyrIo6A7Z5IOKojOUWqngNmtUH5CSb+UbujYjUKWo886OcieCiCeaiG7A1LCHXQmIhkgGpnC0+6LC/5hcLENaZXkpLQAIM0JGWjmAfjt8lqdYYkNixs49jXsvxBQEVW0dzwEJfuSQIAo3Imo49MMvQeKC6l1PuGf9/fq4o1hhvpRvw5YQ70IC3mPs/HbKtZHJZi5ovXV+bnypPwpiq25IfX5+Tr58j1i2mQHNvg1Hd4aiMcqHqdqsae5VRF5dPmck9cAC6hkOoMfweiieeoISlB+lpKQFXk5W+moEA7G2DPtokmMtqe4RbPGC2CIp6x/xVNpt7xcROfI82mIfLrBHLdoXmwXzb0WVU5XgqNLFJfJNGXTJdGspHtG1tCL6GklybhwZEUM6ULNqwulqdGSuKfS0/Gdrnt0Me3F24X0lNECNBVkzhWwS+fBBZbanDtCZ57sCgCF0dQnaLQWcBILog8Rt9kAzqd/5XnxdeSp9DB4mW4GfRzEBgdUhqdiOU1Q0aMKwicEcZc46Z443Y3l/MM5eKsp+QrNWYL4HlPZUsj3bSF2cGJQFbejzkvd1eUQ29yKxNPo9/gUyLSlyCr6+Pjct31SeczPPQI/qBD6T/hBRVxY8YPaPQADgSLwv5rf1k7gFfVnP/kzn6yVXlFfWvGK+jNI4Uh+nOGcot54k3OKerJVOhepXF72GgVp9lo8JxyZQuaavQ5JY75MDyGulr7X93wIX4KK8CV0wheJDuEeNuI4BVUk44FadBiQIw+18Wi2/yykizBPhakV2UqAB8fyAzmtjDQUqYbcrmC5RWArCEwF6PGE5CrYRPQizmjlBJsC54x2iuRKAK7NrTZ1szYGVcHVCTQern/dmMaD/3hqPPy579VPFsd14Ir4eN5+45P39nsiX78oqF4acCwSinjUK5XEMrQ4cJRKqv59MfDq31cPrkfHP0ZT1KOvjjbEVJCTYR4AlOUj1AfgG8sNrOzjr3MzIz6ei18nWPsePanktAbE4DCUvPcaoTQH8Fq/Bl/nvq6GoG9AlaA87KE18VM7glBq+Klg0ZwqqP03TDyxbfP5N1ds23gXmvcF1SnIHhRICqrhttNdD+nNAIYhP+5HVmuVz5ODdgFFtfgvjRaP982L/9hI8Q+cRPEPjRaP982Lv3+k+Ac3LX5rzV5u4hl/UO6UIGSuLK3qLPuUuSzxiU9efwhF6H2JrTAzG+rH2W8eHPv0Us+ftDQED2O/pQ3L3oTK5BJpTbBHDQj9IGJHze1+q+cZCNxkbBNh4YP7FX7F7ayWgqCoUgntuGYRcOnHX4PLMFB5UNyrXkP5oVcf/xqKX0tnHSXr1y6sRWm6IJOhhWGC6sohlCHWKFVHTemnL80Tr12M/Lyiy+8e+a3hZ5cEz13bn5s+8aeGVUnrNRCY3el/3sT5ec063VL3xzakDLW8ZG9EqzR407hP9R8VV3avUgD6hqBqQb4Mzem+6JrYK0QgPULRzdmaLjEApypvSvslAiGOS3VQhNJpfg+jow8sG4gOTRTggdj0u3jETQ0KbsUTwAaZlLWxw49F39ci1XefFKm9yW7TYZX7zXrnpYKeN46i58ETo+dBh543/pui5+EToOdPY+WbQBB7Aupco+lhUSjsZYVNAMDkBp26si4CrGV1ioj/yrUsKP3Wh2ps4cfQqCIS7KZYGw7mwiBjhFpd1bEsY8AEw8bEdhnzddXy8UVLlysptH6efquOwkMtHUsXKpEaFA54IC17Cxq0Isihfsq86gp2C1L/nUD15q83UP3IcUF1M1KF6L0A7Nx0a7LG+qNuamTyi6sQeMqT3qIVaZWlaMmLj5dC2BKd7jyJniq1mON6w6nt7197zX7OVfX0qUmt0rUnWMQO38S5nteo7Ku6kBWV40fe+mTXa1+kETqzH12nbv0679QOoWtqX88Xljp7K3IhU2ZKPr9sUggXYVgptLcaiabO3oicZi3P/kQZ66d5PizUe2i2lK+cidJbQcrsx3VtWQOpRfGW3pKXfqcUfp90Ux3P3Cvh1TWAo+KNUtzd4WevBM8Sv3f4AE5BZYlkVY41+5cmsjjeW3ssq+PArY5H/sOtjsOJ1fGksOgZXjANGwItX0ljgQas6bA6lAgsSihfkzyWkftJN3I/9R9u5O58dCM3xrD+jKQ/d1OGlYQzXd0vbCuVHOwuYV11Mm7Ks9JjGdt3urH9uf9wY/vzj8vYvkvSv210bN1WRIYQA6teWZ8tA3sRfi4pqSz504f3MU/d97jh/cX/cMP73n9nous9lpH7FTdy7/sPN3Lvf1QjdzLM0wc3Z57Old5fJKzQ/tIG4G4ZZRIuyc1XdAR2Nc1IZ49lpD/sRvoj/+FG+le/tnN0VUavO3WOPvbF8zfcyN39H27kfvPRjVwTm53flti3eSwfEHCK/jNv33FigwLchg0u3EM8uuriPSRxgJ7Hqrje1yurKlTHC0XOWTS6XxcKHaZyYxt3U3Sptbrt5cmKYI84ZLdG8X2z6zlaSz/qRdBt9Xk8PWdM2CGLXILcM+0OdeHzLepd5BGeXfNM+mrWFG5ZUG8IVEDTPH7juCI2KBFThIc2rr8Hzeqfa2CkeZ1Ht9CCOui/HLmvVQ2Cin3dy09yztyPe0lwP+D2ks9b23wGdR/LDPo9N4N+/z/cDPqDRzeDLjnuONpRTPhUnHQkQ5zAfm0o4B+68bvnP9z4/dHXjEv5k825lPPdLZmr9ss8lQkqwd3CwKw5iY6IfdbwZwY7fCyD/b/dYP/Zf7jBvvfRDfZTjjfYkDNmUwZZB+voYxK33ecG6zP/4Qbrs19brvIslZROXxMf8zHi37iR+9x/uJH7/Nd25NT3evY1EpQ+4EbuC//hRu6Lj27knn7C1XCXf7SjzMxmlPKg/1hG7Z/cqP3zf7hRe/DRjdpTedScphf01wSgRuPOh1nDws/+RQu3Ek3T+JdNcyKKXP1jE7a+EfvRqbG7pkWuTkS6oeybbvXx6uNo76Dq0ZG2HTpz6qNL0ENBpsUGOH5M0l97VgKD1U+8rvWK4Lr4FRUrhsf4eDrSetRQFkyBobc3+xRhcG7iJ7QbbtRnMPAo4pQbfS74sI/w6fyEJR1EDzyOzlzwFm5ExY6SQBgeh4r6PvEHuPFPbIfTZNi5d9/n/xNif+9iikr/Mrwt5rrzBM9Dft5A3d6alg94Za+Vrjez1+GZY7v8YA0p9TXWay1a6rTnluBFRfsAlHEPSbYZgY8vt/A1pkOReBanIHs9ImCMFd8CQeoUwzZ41D8c6CVMBH0ERf99ntriVG8xEFMd+LusV/DIXCpb/JRxHT9hwbbzlvsezLsuAzuX+hxQfcF+QmEv74olxMVnFVuMYdd5uVrjKQxggCLjtmDSptkbBDgh9wyqod2KyVapK1+SZ61YwWTtET9a+aq/FwEYFdCt92q/ztfcaEm9oBI3p7QaNHDO05y5fykzy7fCDqiWlRXb8VgoiAGF0Gqey/XU1bzg5w7OGdLWfCduQuTbKMx30na06JSRa6oFVPhPxTXVHawzmJ9GOznAmvy76FTe/52OVw4BpLiMxq9MO4MD0KrHhYqd+dm0LT+H8vwJkKtIZ+bgMfAJJDr2zUCvE8wiDqZoNMY5E9xtriHtUO3r3XQ6K9ufkbPaPF8XODM/l87Jn8Ilvyo/j57I3XkSg+zJ+fl0br6HniK1LUNY8XAtqOUX0PllmNXfy/BTKSzDLKil8xEqnkbLeLKm/gNQzg/lZS/tkWcfkc/gn4dTDAU+pwvpAsR+E11ET0VgX5nMt1KKZ5Z5vgBd/r3UR+BCZNxLEV9rGPhc6hc9eho9HSlPo6fSRRyYlP7gE6ngIv0uKJ7O39nKnsnVSzl7CdEoQaJdG76J9qEC/fouH19Dyf8ZiLxYI4Nib7VITkUmLnnv1CJxRUG7ha+P+twt6chTEflUjQyKi6pFcu+Qib+8yBVpb5Ms47FM5+NxPu3BYw/wAfh+HryEnNePoRVPT8RdAMaHJ8nzSfRkefKtG3meS0+RJ99axATcTTt0xTiddgFxz8DjDDobj7PpTDzOpHP4nhCj6xNgz/gJdBa+4ytlo5dTT3GXU+3k8L8xOb4xOf4DTw5cSS1wJfVZeFyKxQKIjpuAOiFOx/cIJ3If62xMBXrWARS3k+tE6CzG4G/m+XAqz4vTHv2coPE5cQ5j/6kMh7MYBmdy/0/jvp9t5sUz6by8NmVu7AoYmStzo1aZG8vVuWFQ/iJaNvOiVpkXdkBDxQMMq6C0idcZV+I3kFtw+mee/bz7f+C9n7vYPounMRYUTyeeGEB4tcBon8UzOFHwS4sGJgrCauxFk1MEzeAkQqnlNHuqnS6ILdtHfXqqThfNrNG7THeeLtXamfJUrfpCKVIjR9F6F12I0sbRWlH3uNi9C49d9Exg9zMNdp8n2Hveo8Tyc+h0oB4ujzK+nYU3XI8/A1h6Gt5Oo7PxdjYjOwHZvxmffzM9y15oLXCh9WzwR0DpETw/VzD67ANca78GrGcc3MlF5PmTg70GMenJjLZJ/lQ8QVg545OAdrSbUfIJ3K1z8ycCQdH5nClCHjKiLjOing9msIKYyxXEDKcgocM/JcFVxHtqSU516Cz9rWIARyOV815wsmOGUdpjRmmXQB9Dh+czJ0cNYH2SHZWn0OkyVID8bnoC3vgKId7O5XHNMKzm+uvZ+kFOBZ3y4oJ/7PVX+LbO6RTawVfUQT0Y+iFtx42n7UT6UQ/WMp+gXHeoFEapCbvw/R3ccS0pypzGHkTs9LWXmN3moV/i667nwaQT2IEzML7n0RmG1D2R0/nxJH6cAZqIuCcjHegSomvMeqPb5yEbGr3bLAr50zTg50838yk3S5Cfm2UxyPsa8PNnyE174ExIu9Epvb9cXeHRkKK6zD8ZEdW1/imI2OUWfDSK55xZ9b9JEUwW7+IS2iUvlxoS+C2IvKxcw6qr/rPtqv8cm3yuNM2utt90Mss5KJpjES6lbylp1z7qV3BTOkz7NL8u97bWJ2qtl9Bl+FYXbHo2PQdv++jiKYVYelopZIdtui7gsvi7Nf5p44WATuoEcpTVTSDMldDMld0yJ3bbC/VnGPPxulWs4eeZuqSd3+eb5vuZNMzswo15Nbv4JE7YpQYD27hVfD5n4Sl0/n6ELuthYqgDwCfSIrXpfN6AH8B1aNqll75eIvwD8XVsfMCa73vWGEFl/5ovg+ioJ9fa8L3qZ57WEIEelpFqRF3JU47uX8eAQieYJnhKx4UYnI8Onk/PtGY1j26B/bYFOENeoEXI6biF1gQcjOPBNCb/wZQiP3Ex91vJh0XFbPq+nzoAzJLCZ8FIKVbJh21H+Igf2fgv7i9quvHH3USunwOy8Qfcse1XWQM3lrrYvD8Tj1a+BXI3hIotEl88k8nK/r6sOVs28udyTU+mhXyP1IaBo4BWmYrdEhwQiFlfJkfhXTS+/Qg9dyiBIj5S1KleMTH+8EJ+IarYWyj1PB8vSfFEBi9GHaOjfWeIB3rbXaatTnp/LxNbCKbo/JzxQoQWFwoxl1UCMwz8DUoelSbs4kwgd0rWuWwfaP9MQdVFnsDxQ8EabblakOR8RT7TjF0lsnG0dah1PoUcjSKWOYli2sNNhBXgoTHA7ynuhM7FP1et/QXeFLsswoBeAZuejNgnWzGgQ5EV6opcBXAvpSlbVJqyePLSlBXIiDoqVJmnRRGqdFWo0i2FKl0nVNlihCqwXz3/f7NQ5Rv7xm/sG78hVPnG5PjG5PiGUOUbQpVvCFW+IVT5hlAF3DJ1ejwwRrrSfVykK8x3Mw4s/ttLV74hXfmGdEXFKuTTVp4Az2JMWzICliceX8ByHm0ZF6LUeI1cpl3GGGdMtYrMJFxDREWQ4jajeITT5CiUTcpRllBEDsd23wo5ShvilDZtRZ6t1mh/RDPQDNF9evZVKNIoCDI1zJRCa2hBWpMNRL9Fk8NKclJNhl/8/sdqa65U634Srgv26mdNfLZv4rPVia8kOqtEqxuHUqnFxd+o6iesIqOKOCewWzXhvbkfHN9u1SX4WvXdD5QX3FcPiAUJ5zAUxg6zN6IpnXQi/ibEPzIDWMczG+CPmg0IrNmA1z7O9ktAbTCJ1MCjs2DyphP4ef6TOIYzyjr/BezV2d5naZSOWOGdNF6T0XgzylKjeoMYv7fHRX1/vyF+h0qPkUM41yjd9A3yBpdwZyyeU5sUoU8pHnCpjAQ1046YULw0RH3rbfRwgGrrFJk5WgT80iky++oPnF+zYhaDeKQSMbfvr9P8rx7+6t9zODjCrf8RtF6dmIJjDgY2zra1DEgPD3Pf8DwUFBEvZIG4MKrjj439zyvNWUA7KbgguDPmp7Z4QVyArhXwDKm11dWB2JFbLwjuQj5OScTJJWI2YoUC91tN7TeRvyMuzzrSyysLXqAjwVEOBMbfg9r5JdTCcQsgFws0r+SiQSElNEdzA+4l935Yjsfr964/FBSLyF3fKIL1Ab9Ffb/PyM+znDsWvYzTKHpp9rGquUPnaZGC9TzAYHXFyOK8cxi2JDuUBfMBB5EuA0mz3Bb5iEcTI0dLg6FFlw8NCl89QQ8HxTIgiYwtzZh3+Wtf3UNLGd3hcChQhL/tZUo5jxlXg0zZzXhzDmA9wBLNLRYuVXJb8Ue8BEblWXmHFvK6dRPVeaZkyxjimX49gu3OB3+sE+M8/04dwdKvLE8eTK5HTkV+byE1jhOujXg6+vyc5/fSPtgDnnMQJqQynOqGLGJzKi0lqauohIfsrTzMcd+jWLTo4vNkAXtI3DvFG+vA8/7T14pkY9+f/8DCz33zn/vs0ZE/4Z1t0cgeFvtjTf7gAf7Avqf8fl/lvQVpu3TOTcG8XdIEamywr3UVzcfGOw41qi69PXGRM1P5fjDUgRcPicUsS3vLoZPZ2KZZnvZlCc/nymcFk/jJSIoRCirOWDt4dMirjL9HGdboTMYz7N/FmJ9mf6bOcShUAIYA9AK/LaxhyOEsz8s+aBQFaU0Tkn2zf3P29be+5ZqnZR9CUj5HIVIYOwYehdCrzI7qNxS7OMUYrSnTmmChRrR45+A2f54fq+AK5tD4RX6cy6yCnh1YgNdpmX2MB9Qah22gArrldgVuHtYFJSwWuh55DAlAy5uEVhU+IGWt7MPSjTm2CpPHeOzJO5x0s4c0BV0X0bVcOxTc5VGXMvjL2c/upFovKlbWFNTZR1ASrPFnf47v5Kuih1m4qicBW33xmgR5Pdg0tGgbLSBlOy3hAcvpOW0tbfUTbztbB9aQtBPrOW9M7vVM4JgNHLWBuzyBz2o/4SV0ch7lp8BWNeC1k/K1POvDAFSRnwaKlp9qnDop0sQgEx3ecMATdSybBDrNBCx7y2kxtkixPSTJhO/L6DR5nkanii9JWn0OEkPsZzx5HMX3Ejqmj3sRgeOfUzgfncJFDzw0Z3QuKYqhbeJw3rO+Kq15+FNpFYCVvnXoVJzKxfJZRz+hQp9DfLvNfG2Z71UlY9tph1mL13NPizoNLaFVEH4pocgoQ2meAATlHalimXPQnSMmpwKPwpoOXpEKT2YoaSutgDncuSZjc9qJh7bgoZUxPTXPZEyLE41pcQqdcsLhLB7LME4fwtPsEJ6Gsk8rh7CgVTs3qEDn4/06a0/lBpvRjJVvCjCMDuovt1APyWO/r7dRQKdyxopL3oJJ5yEP6UjTccNcXjCT9w6ZsvP8dojfdAJj0tJO9B614tT5kCejvUTd7FcN7ziHTUuOx0KxguaDlNCWNf0234H3VYRICUIMggD8UwKwnXuVK6U7GayIySBEIQix7XgIsWoRYkee0almoq8+/hN9VTFk2+OIIYXBEMW+osSQVdoGEG+nVaBHB57RdlBnDUiPR6dEEerYqa6E36JKBlQR+g/o6awnne8MJu6ElHGqYIgWpRMc1IwBP3Wet9aK3M3s7nk++g/wllvQZeGY4AzXX8PeQoHP1wKyj8qaYWJ0SUqzX9OVVSPHV1fs2TPyX9D3vg/BrgHggxcj5iV9PoX2aRnUZpkSFtXDuLB71SaiGttKt5BjMZ4evWttrE8avTo9OptWSGtK1nRKXHMyjtlEZxP27WEAP8TBNJejo75x+2kfTrJm2GRyg5+Ny3rYkasNPtgNh7sBwg87Iv19tDL7A/zmobVrx6XtQqEb+374mT90T359ste6LL//YubZd+NaF9UYOBW/0NknpIxYudVLhKtVnZULAhbkQEJRogL3UFnNOgUqLgjAMKEjkW75MwqyT6LAC4LnmZO2QO8/Beo0LCEf/Hv2KaVFYvauSPDYq7eWTIZc4pK8AYx5Xh5rk8hn7L6VGrgc9jK44dww/dCeamhgg4OLeD8ToyU+5oBPSdXIhFZ+uRik4IrF3oVO6Yi8DatjsndIIWfYWM/+UOEk+bnF/loJQorXMd+0ElOFlp24vUpAQelhU9EkqFoOPr/m0CBck7tevIntH/T5Hj8qXuH4rIy3cSeS3cCw+SOxOf6g50MSYTD13jmLqmrJQ81r9e+Bjg9XdlD/PXjx+YGt1JHGqFTCUY/fGEGYZ59jklGBnEc+duOVDYcJ7tq7rsyx28u4THcMdTQE7FFlNxGBUEBwea/S/SD7Y+TTivse5lL2JwI6TuP+Ofj/xUw7us7DNbJr8azLpg9e9BqviEsLI37pRBzQFYfkDI217K8VmTE6h4MiERqN9acB7yFwD6v5IFbEcrOQt0SgIg6gA2pAFtGAdGJYhOVdMca7EYHBjOyEN4psvbxXdiLJQYLp8jxpaBFSCAHN7IA4dMSB7AgijwzyENmSfE4aks9Lo/KF/jF12DDLX8Peqq5xXB/WJP4xa1wHPWbRxxHK1gveInHuYSmuWOfS1H1tsYQlMMLZjMCDONilRFTC1MvfCi0ydHp46cq6v7XEKAh6LNsL38rUFp4Ek3E7VMmI+BEWuVUlK+AkeijdgRrYDqINudW2k1bzU4K98HBCK7RTFuUK88ALZleOwE6j5TyiJfEVv8SVyhp7GmeiCOnIeprAgXMlWFsTdSDa9+kUVhrr5buwJuOg9HQ6nXPLm54kKOjtsziDUzkF+fhBPhf/PBTPnmpIm5afZQYCjpzQBAwFWqHZqqNBp3EjWzfc/Zsv2v3f77vYPtE3U/Geb7JPnFCcXkb/qn0i+mxE7xXZkH0qeEhSrlh5/nuOfcA+Xcr3XR2c84Yt6++zT6SgNE5jOJxWHhZ/yD7RF3QfrUaYH/gPXfjEnkMf/Ot/ufMD9ild+Oi73vOBt/1d/nT7BOQQ/85vu/3gc1/15g/ap40/vPjbWwbevzzdPm38//efPrx04MP/+UP2aeOf/R349xMX2yfitQ9QPTh7opHXfvJ3/+uFf/SZp9mnFPK52898w2c/818/aJ+28Fd+5V3f+Zdbf+Pp9mnjP/n8D3PjzviQfdr4n3wwm52dvf5i+7Txl0rjfu1D9ukaeQ7xeHpmwtgnD+a3TrLbPBqfguubbyt2T0l8Iu0GKp7OA/c7XKNv4u2Tv/lWQgEPfxufSJ9DZxAKOoNY10c/q6SfQS2ZBrIFeBKjcJ1f0xDPs8Cp8/NMfmb8PIOfu/l5Nj+Jp10ushVhIp4ke49riuglPJ+d/ifIGut/zg0lUIRCzUb1P0+nOgvRSD7kYGaD81TX0HBYZMN8ltPIpvF7RtvBkujp/bl4SYqnQG30PBWpol1MazuGorH/MIowV2XfS09RtdFz84iPyRPMW0s6ao50oOQq7aDzORMgcm4/Q50dnMF1KJczuG1UUAi1UVK10UgbkCeUS3MiiqTllAi1V83QCLArzlXyfa7V10zApyRlA9zGwJ5+7wIhYSr2KniG2olWMNFULmahstgu0FaaeVYeyUFZvpUiFds2dOVrCpOFVvpWFHt95BwtHGZBaqLxYMv4QrbHz4jtzPMTArprKQHHdIhfYdT7RjyNPemAW4zwahG/WI+Yiog5mJejAOzHkMwpHPVSFNIP1vj0+zz/auH/ggPn+Qc0Jx9QreGY54UMkk+DU6X4gGFwG8odrupSvvuAHoDksTjPUefQWI60cqSpqmxDDAKgcWrjXM7/KVQD5uKXHK33uFZkUZhqv7rCMuLrHmxpP48S8HTfTgl4umdTInw4iudPG1IpyhdW+m/AfWj+SyQ/5JcyazzyKidwRSCtCbLP6Qe7/KtzQLVxnn8WPyAA5UeClfk8/yIE9XhyjwQ/j+C5Erwfwd0I4s469hwIPoTYnRI8iFiS4JcQuyrBBxHsSvAmZFiQ4CEEWwhCuG0sORyguqBp9nltqvYHiYjV01dt4JTYRhmjfHbCyGZR8K/CzVBQcW06Ko6jYFxBwciioKcoiGFWFIwcCjLyAWV0kA4gk8M6j6LpWAdxIHYkDtFCoTYlogUG0ULyFNEiRbQAiBaYjcgkogX6VcACpuMimqeIFqL8EyBaQEEV0TxpjVdFtODrENGCCqL97eOMaD978q4WwhFXC94mrhaCcVcL2NU8MOpq4QdvqLpaKI+jI2w1/52cLfzQDcdztnAYqY/SKcEP3zDulCCsOiUIT9IpwdWP1SmBN6pdEFrtgrd0Gr6c6IdyjOhdF/CfNU9SG9lZqzTl2SpN2adve/VtD7D0Npbd4HlBsEt20buwicY+jcFc3YZnOOK9IMCa91HMSuDEj+reVHeBsRMv67Wa+ILNP0p1R0tFHY+dRaK2auTsW3aJTQpQLOhhHaWntw2L1gUBoVxKh0VqCqcmxcOiKbKYrkYcKZpa5R5T44/pPp3MN0jFQwtuU3sw0G9TaiCmSU3E0JQSWlpCrCXYplFqS2hpCTHF00sAj8hdTqyQyB853lT5AqS7Xpry2M1MCF9gRxw/+wRg/a6wZwnNCEaiMTmaVwfc0EYAmTLyj3Ab4+wtaILioE/ZoBpTQyNVzq80/jYAW79PqTXxaWuzTzt5nUSaMCMLzoy0uJg1bQY9ei4G2ker6+jsy4FrlB0pWiOgiKmFpU7AewQjPhhSa72qENJCdGvAmFB++L2Kd+kdRVp2nrMUTUAgonS0G82BxkyHQFqBQDQOgeZxIICe5on0O59NZcQZJg3ApEGzJDCwl+jgsIpjYSK+CJ8l3Y6H+RyPqcwBwaYsb6rAJMajOzkt3euHroNNoRagmVKTWkeK+SHFIKJHioXh4DaaJ45YIA4XrXXg+ZBSnkxS7YDmjjCIeSDusLoquOY3CtwmRdJZVd+ABHQ0PS5Z+BfgVXrRpoAWuALpxQBDAxO5bW5MjAJ4bMZHJp4YmV0WvKPaMY0+AaohXsYB3wHgoXEwCfOLFPCJSmY7/T1ihijhTyKeRjOqLhgQBxKHBNLQ1kRDN58JIlPTsZ3VCrkdEeO/h5K7UvyRvIVnRqj0SJ7SYt5Qf/lQ8AMboNOau331mtAmRmSeCVTXicPPF0p8G2N9pIhvLTUVhAhHUKRB+sKRoj1kkDe1VxmK4QnESDA2wKMD2KI2UETznmCwA0w2RqmBIz0LlCJCJuA4AWoehwABWjqUF+WzOswMF2FkQh3PiDkWvfKItEXqkLyKLFBZHC3wL7AMStClKD7dYtauQFgPScAMFE4i5CaAdoOv0XJu1QVA1jEXe5vG8pJrWbPf8gOo2pWL8aDhdHpED+QW9AN6ZKKVeFv2VhShUeqLcmJF0JyaEdrWUFlTXkJTQftxXKoqbfyWJ5KSNxi5m4JJ9XIyBkpLfK0RW7Q8Ki1M62LmE/9d2StauqwLKCjliPQqrfSWeI2asuK0CdOD2lhZGXewVW+K4TiUHDHKFpE5Y2ui53b7rnoGWhI8XkOYcEiYQ5zsQbvqa6JC2b9F6wg4UFWh/JnNVSj/TVU5bz9BO978+Lcj43ZkY22iapt+/ARt+rXRNgUarfykVML4UZpt97M3IbXw9+2WszUlHGgtBG8/+qlT70/Pmf3gAMRFPDLkER4EHlY7FKD+BTz6iXYIqgCMTX1PGHh/b7BXoEph9pPCwteY2obAOuRTAsHnwjkmeNkJCtNPeCHU8vAnQFIvvTIpsEfWd488iORD8pQ9RmoRA9MpBPne974P/OEf/dm1f/K0KyGsopjxXxWyxKmvO5HFgzcoqEZbhrq0UF10he2JqF4pERmUk9Y2UZTXVWcL32vP3ImvQOeRqic+stw/FEce7z7CKrE7GpTEDmBmIUcAlCmXCawCfvnGrFvk7BxGFeWUO4p4UEhnZRtxBAsKSJ9/q5KkOgAMPlcKpPpgeEeRDPK6we/kSJFQfJUs7qC2e5gqtTxA6+4aBynU4+cQghj8Xdm7INjLGNTAkNT5XTkdaUCTI2Iw+shUEzaO81GI/fkGeofi+zeCsLg9Tap7mpYZ1qRo35bPyBWDVEYWJSGsXDoRJmzE0KD2ETBHIc1QxKEuWnobsmcmC7eo1GHOy+BRJ8qRCeHpFoqh+9Yzj7z2rTfGygs0lMJTtF5E6BM6nscAjEkBAKn86AMChrpmF0hx9gTZ62NsQJ6kisleeUcX8Oc0axn1YFB4Ohy6y9Y1C1s8DBvGeJAnSCaj92IaFKEoHXOUp9Cmhqw9nerwJVBrcwPkBnLsk0izTh1T7YLKljcbYUqRKaWWycQo/+8qlHnb159Q5o7jCmUGKpR578kDK6oC62htE2CFY8C6GEfwo7AaToeVhnUhBNxoGtzC/Qw60UqOhfQAchW4hceDG4CqsAH4Wgq+RB+hPgC39ePC7e2PQZh15OtamPUoO/UTE52Kqp2KTrJTVzymTgEhRzsV2U59j4/lEYo/Vj6monE9QdNlIZJGIIZ3wpb/ebqVng0pxMbrVmkyZ3cM0pViSfqReNwNRiiOv8kk8scpDg6UHhydRXeOzCJuO0ioCgX+fejNTx933hx8DPPm+gkUC6ooFpwkir38pFDsF09+MGGY2YzmkQ+/OpoymJongF6fG9AB58VedfBh3w3nr4wMp90hRbpH2mRA+/df+yKxl/S1Hdj3HXdg368D+22bmRdHUeihDOeXPs6TF6RuDePGzi/xsba0YjUcORfW0g/4QYi9gDV5jhEup9Fl7Vp5YEY6sXAszH+sIiVrgy+cFAU4moeQs3IqHuM0PFY5FD56DiCHwH6cvYkmrX4NXlG/1LumXMDL9SCfarJsdBAIFCPNa/bzVhhfmeOu+XwcifmN6vivnN+Jnd/ZXfhce5ZIwUXoGjTRlRANCqsNyt6lI/KFsCHbqOtCPZbA3+QOcVyDLwRUFae9lykgaxtF3Wlb5Fy/U9LLG+UbsRZlHf/nTZ7BThictwSKrVJJdTCkxnrRdiJkvUyUz1BbtQHzdvYLCkOwnZB8NddpBv8NWIY1cyvNlPuxIVhLx4q3oVq+kHd0/wkl164+MgoMK9aSUFfm1IwhmNm7UR2/BiwCLNp4dKnttkszR4pseAS9mynr4kjWtVsv5rgrA267aljAYlV7ooGp+2oOl/SGw3XKKBuga7PrlY0YOvAIMmNHm6pyG824IQJ6eDC0DuVZJM+vVfuCZJ/m16itoY4JtVzZeYtSIEFqRETOMhcKZgVTeGQEXGvV/Xv6Ds8LHRVwF1tVeAYV2+w9gHRftzgxVPoSTOkGU/3dsmBzuC+OGhqSXzzJZyRxZ1Fj6sKxSg29O+ahxATC2uwXpRoPe3MmWhfWQn40UGzsXBM8sbrPRtfM+uGV97BHj33SSWcGdq7hUwDax6d3SDe8qtI3FgRg3AQDc7qU2Oc2DH7k1Yd0q49az669nd8B8+yXUUWaftYLQAujaytauDqiLK8OlKDrAlEIqYjcBHTy4bzuYhOZlpHigJKUCgI0dMtYTlKzCY0pGfJDjssHFVwcHsGcjgdmY0rBRAZ8KrlAQPKYM0EvCicyHOFh8njiB+N/su6GuAXJA2UIhMSDExMZjnbUD5DkkzjeyAoRpHnQhpA9gtwuQCpERVpUWYz6HSzHBjfZrX672R1wXscmoDxfccNHbiO3zt6rRFr14T0Z2h/0vYBbLv4+Cv/CWgstVMcfsqqfXWu1PWPMK1Bpt25peIYhqzRQ1nDkxB7T40IgNOQCEQolouXrohWoRju35ZfQFi0QP+BJ7bf9mjyyDXMHn8v3tHxvs/JT55YEYCwr43dUtnHCyrQ9afrfMJC1qnsUdbjiG1EjYGbWdSQlinDkm6p8GR4ZcXVgogOW4BNOcMVj9qIOjM/jUzxeD3jeqxT/UB7Pxy7P9r/GzH7G0Rufdh18vZweJP+/tocyn/Gka3Hgh7bMvhZ5hMDIh4BNN5UCcAeG37M3XW9wJ/tBJQLp/3g0XPEHJrhisIKOLcbbGF/cn8YXF/jwauaB1x79Bgzsb2X/pW1Req5ZAnO2lN2tE8ecpfymospfeoGPC9lu7Ri9f70gEzuPlB5n6vgnRHxNUhDn6UVtDzmkKhVbgm3GTw0sIlKm3eSOGdBncWY8V7WSixQSmepWLRR1618c7dAbt4nwm75ejzK3bD3cuvKobsRS1csfF3r+qFjXVxj72cfwqSZoqoyQg3t66HE+cNALxCtynMAZcq88Zvh1d8ygAsLxo4/AB08+ccsJFTjPRKF2JhK2PGbu2nHwEbvsEfZdOe5YOG7vOBy3BwbXcwwuSHvJWftQNJnGTkfldjmm2th2+ZHWa+VEqvomP7oBC/eLA61QxzE2KqA6FFwtvAsl55v8uS441c1WiFLlEerD7aIxHupdF8WU2wvQ2sk99c88rtiha6G9+YWJphHOB5fm8EwO4I87pjp2gmOqN2F3bY0qYO0m394k58aZuYuWIXEPfs7dj8vsVqv1N9yNstD421KFDeRUR8MUKtqBpairwd8iAEsvmXbhHprcpMZY1/XOR1w0OLd4j6rb5ngU5uAgfbWHK5/jJ9Crl84krjkHapAPjlmOgIBKU6ofqVmYnQ+GfstdxSJH9gy981ScILYPAnPtv06aXCS4JofTiVi9M2Mvhs+aZt/kyfBjsaujmBSDhBB0UnTD3MdEgUlgbIoSKaOtDNaMKsBLSZ3qla8MpSTUwXig/gJbkzzDWGdy7xMKWKIz0cSwmJy5T9ghGdBG1IQdBb0tpqCJ8OOXoA0A08B6j3bbdavM0Vb6KqMWVRoHs0qUKqluSvNmsXeiWT4yyaiJUzpOt6d02FcE5e3Cuy4aSgdYAvjxp173vW8bsHuvfW/5xLOe9Y8z/+Mi7lVmqL7e3Ytg+817idL+d2JgcH6BPwanr+On6rKqVV5E0t1YultkKqzTh3bSdDlmsgOihC77BpUwz0KngRq66XTXyQurWqWs6lM/88mfmXLWgTwTsqpPIi+3jR+frDlp1ccxDbnR/B8+jRU1+61NJVUvfVG/9bWWU/3OceVUv6XE8tlVbqRq9iooT5uBlTLXHSbqEbMcH7sdhNsPKkjBAGktFed2vz3duR2gAQ71mcLFov6wWn9o12iQNFDYEJ+ULaBI4lANVo9NuDLXKseWtSxX9p2ePymvcyu4dWvN/WfcDcb8+wWjvgWd5O5RCnh/e4KVbVU52dYEI7u7ZGTD7Hfx8Qn41uN3Nzn57gLxqt3963/PCWjExbpqBrqmBpCBIAIhXbE1FJq5YiZprF/hYd/CaYdtZuZ+bY/cTmrmnreZuMZxy9NkNtewSKqf6Wl24TNwdXcLJTWUBmgH/Sfya393znyWqvxhSJ6rKKE7+kuFqCMzpxh7BXxjKPf4ERzI0YpAo/30ziBMjA7LJFeGZjnB0PSJAuRjcGVq7T9QzurTyln1feHgnnEj/B2fjzxqDhV35eXKUoRGyycUrQFWIJmqOHm10jZF7T9FeYp6Lb5iVSBd73ZFqJUpDHDeslp1RWhoasoIKDyF3+CPRT+A8RhcPRbrvEHeBsTAsqD5l+Yp6gWTlMfgDRSyoxfwm+tFS8W/stRqp9X6iQ/lzqkpHkF3rsogmItXkQ5GxIn1fuhUvcGLui3ZGzxP5WlY+Hm6OpH0EDzbvh3PeHPryO2/8dThVVZZ0mY5xlmGeVgx+ESBsIpe1fBVEQ3BVALjMGvWh4UP8A+KatHa7PTXo9gXCxLcIscSHgyFJ1SiArHgnT9yg4gFGV/vhIQw+98yd/oQNGhiqnzKQamKvAMUwsCA8ChKgX2zO8N0vbTXZoWvq/7Xn1/38E88TZRQ1KCcHKvtx+Vykc3h5lHeqGQcPzZo4nbihoMf1TeO2LcPDUZOAxRHpVVAUapIMkVZetJMwODi4biZgIFcF5CObKwjPDyiNi4wktn6pDgbXBZOXWX9VNBpE/qerrbqWtUKfAKQogb4shC2zPIM/aOOMgXWdktE/Iiqtrv4P3T29u+vHbrovvNflbfd0URL9hFppVljevSzpjt8ouBaTrOUHqFqzFD7mc9KT/O5ssCLj2Y/KXg96/JnbGBOM+jJwHoxS23iP+aH22XCl7h2G/4ve69Uhe4EszimGdzKgEEMMWU4hjuWEB4M7ZyK0zf6KucIKid2oTuxMzxxqGIAFQ1EyhF65mqb48d8xK1hHdJBQSbNghdPT9w0HzOZtpRAs+AlmDiUCzY5lAshRYAtSP4rpQjhxKGcaxh/om3ibK5N4Vr1DA4Om681tMUMbjBUDAUtGaKxVZqDuCPZvfh2eHyjH2jQIzHYOnp0EYIp/KtxVvX+TVhVX/0wf8CPArOsacPY3MaEjZCDjdH3+xt9iJNFYs/uqXGh1pEC2Q1wLBYVn8eqv9FcM2YsBuBuEcdoMkjXCLuoextILfeHRQBE9dkKiDPIoovWGHEyr3vYSEUM6kalEZg+8wNU723kIdXzwC6eIEq4/Ln76g1DdyisWCwx+rR2f1pEaoek2hQfi5LOGGkRBuB2P4TkDLQdFVnrKzXwWHgClCC6Ys4zcUBq4MiXCT6SmuTl/uThaguEZa3cQYPc+VRHU1I0MNUGuo+odSsYMuZp2ph9KviJuA5ZwWJq8jeiIYmS+a1/UCCv181hgJgb4uPGuI+jczWE2sZRcAKVXsZWAYQUWWUk9HBDjsmMZg35OnMa6Y2Ps4TT8sD9sCqd+vPjS6f+jVrxFydoxUcmJ9pBb3Km7R19P/SMykw7+KopM41jy5n24K/Wpk21g79e07l28CO1qZPtoF+ZbLT5ZDt88fCRTbav1q6ZmG1Y+Cdnmy7h2paJ2UZmtr1LZ1uVk/JLZ/EwNcelIe5rOOvQ0PFZF5ezLlYkie2si6bMuqO1zaZdPH3aASJSJqzi0WbTLrLTDrC0C3cjfbfn+WCGWWjm7XsFzNP+wI167FsrjRGtl+GLKuHL9lb5k6nB0m7XOq/G3h25h4pG76l62c+iJRjS7Aet9tD6EarJJ7oB4AjyFEs44bb1R6J654+o3oWbqN5546p30BZ5aFT17i/d5ttttyNM838n1bv7jrt//owu9CcNqm+A6lEJsT47IcTyq1qK/klqKV77WLV7w1GJn6+KsI/qk1cGoV2ENkCC0ef+9xnCre4KY+w13UwWhTuGs2iXAF3qQ/UhWNTlyATS7RoIltGiC4RVAG0XMzV6s7Cv4v3nVEW1auVuU1Et3EIAqzaX1T6+pVndIS5PzcSoxhqPM0r/Oy3dCCPw5Ym++OKUL36uF61cF7xiRJJ0LzY6VXnAhpMHyCbhHXhXaYAmyQ7iPQim+sXdY1+8331xt/vio/KFYXewWOvH94x9/DH38T3u40/Ix2Ch5UIkyhABEmGiJgitItRAqItQE6EFhKTKDKGWYD1CbYR2cgjPs/gpR0ozYLtKJZ3Oi4uMOgf2w/jhLKpcLeZenM/LECN9gWb354t43aW+T4PcN0aecDa1RBHNvgTON2nuxfyYO7BfrK3w+/x+qh8oliEPAb1Ypg4tguTlHfKBIr7lc+X2sxnVGo4ju3hQvkU6l6/0BVhoW0idtezvjTn9DOZJ5g+sUYoaxXydryphx5C/6CAonxYR+LcORaDQxiDUCsDiHxDihtZEnO4OIlNq09xa3usLWkhmzO4HUDWKlei8DZomicV8H7TAVb7qKq+jVndmCKP+aO8yP65dE7FOzVz6A2elDCu18HdpDxnVTm5dLClTuoYjRrlhP8PdnwN5NANbwH5WBlNTYmlrmxSJm/DKJyE6lIuN+IDm8Ams5BXbaVvFNHDUz5wN4e20dSSJACcMXuGbC+xzANkcLVmgpdUa0QCCma7K/ZRO5Y7PshZHKO6gJ+Wpn1aav9R47jJ+LFIH2aVNIQs4ognG6tgMg4sfc9YaPUwVioKJI7qk1uaXDRSrR6JE9dwnRXTSY9Y58g2olW8lh8fJmK2wGeC/TgQC/VaLvYrpVkN03mqI8hTD4DapQZl+k9CsdY612A/xx9xvU43O15Q8tGWuylxc6KtS4hYgIs7PyX9x3lC8nBMqwuBQm0v5rJKj+8fI0acdObrfkaP7EEwdvvv68YNjH3/effyg+/hL8rFeTlvSDw/dPPrhQ+5DSdIPb0Qw7UuTQF0OmGkn1UivacnE+Xu1e8tYnkBpmHD5PE4LfPAi9kfQdikIBhLEnMccmLJFDhgIR5TikF2pguxIjJpvdWBpGXNiTsV2KSJTYySElmUU+w+VJErpE9BNXtVCg8qHIzQHOXWC+JiU0gFQ4TlQYW4VzeHq6yiJlJKKjtYv4x7pjeLbPTwpwuh2pEN8Td1D5RwHSoYaBXB5z8FiFVPBEKx8FvEHAfMiK9tXzI9NLQzkK9dk/xZMUQTbLkYLA8Jzt3mSecKowiz+lJwtcuUZzQPjV2lRydmykLN5Wj4xOePH7R5DBk54HFmTmcmfT6dpmikbIWcZdbCFnMNFEZSHUaKYy5/DFNX5ajUeetxOyDi5EFIyJuHMkLElbS61HWmTsJK8WVC0WVq6VB1vwlwqjptaDuyzDuwzo2AH1nLtLUPRUloVilaBwTJ83BjqNkszk9TNn6BrM7lPi4+SrjHVqhA1ADCqAHCZlngCRgBgCwBsSa9Bxx0aLjo0bClN7ndw/CX46KE3DjA9B5jZMcCsCj7ifAxtwp9i14yU2aNZhsQ0PM23AigtmoGd3dk8gpgF3iCm5+XSt5IvGLWNlimyqDmH0VVUYgRlZCPE1EzMdstRqM3rCvxAeIApWw0WbRdsmQeGzJcYAro1FQZzYzCYZxj8L3ZQ/2jmJJAFf47F6NEc5mQLS/iy4fACsHXUGZ+Vu9WbQUB4IfVooC+ZejXQl5o4BCAc+5h5mW834qtAj1khuFdGA/JsD1F4HWdHIuupQLWYdOUEMFM7LfcyIHeThndzmGiz6TqDbclMiZhivRio6yCebj4dAepFWjbTcV5wLZ0261oyT0dnXcT41iEl/US+zrxodOZtjjnzVUYCzVfeAYuByqdyGOvTNU1QyE25WbP01XnpQ3ORB9gP9l0/mMd4cxPnzPAs65BRiGs9RPPOw1lB/K7Xzs3S5B/IOyAhYAPVhI1dGg0nvYC+LJi9KzWRRfavpTXAv/FHbr/40zRjA3MgpgMyohkb6iHUZRonTL450gnckY7IQp0WrEpnfOzGIY7hRGQoxTFhKY6JqObEMbIhCzavJdRa0KZRnVcW+3j75bBfvoiQr6LzKpf0qzqvmDSROMFSu/ihqNjrI5QH0rL7KjqveovSiU8gm54ioflzCLNOEtZ61FjEk9C2h5KqD3wS0FadYwyTg/X4WSEKqrt7QAmmUFipJFZ5bI1iqaQKX2zuFb6BwnfkMDNGUwxEnZIxzLepQMwrH6E+auSrLMzPvjChVqz3aCdA7M4uzzvpS7QVv5W19I0r8TJ0+XFvk3+dGdZRucUtYzz0TXhXHvoWx0PfjGBqNB/GvrjdfXGn++LtCFq5hRGRjH34DvehJqmIpPwwFFbDyhry2Eof8nopPkhK2USjlFw0VdBhGNtWKcdol5KPmVLe0SllIJkAEqHZquhgTj5S+cUC74zQ5ipfTk1qk0+zLy4WD1DKoUVmufcXS9R6cVE7oPoas6CktIQduJFmcA9ipMQqX7hL1glfNkYSrOn5UA3USXb0qvy84GQMNdB1LnBExtCgWTH3D4u0s32MpH5j5Qx5E1VIfJ5ihkpq0e3D84tryBbXkFjoYw3OHGTBSqgr7lo3YRFWeI09iOmIwNXmeYV5Xk4poIU/nZy1NTGJuEU9ni0Tv9fByaJwdIJaVUahZhgFJCJMhg2pGTaBTLhm2JFWySSsqEhEzZJRzXEJK8o31KpMgnPtLEyCYz0TA2Os/dxJYRD05WoOkwlfIQyChi8Hg2CVnbuWQegaZ5EO3k0H78YYvAHolOoGWnJ3Cvv6EQahB2oi0IsrkegzNXKf2gAoOFiyjAHFYwx6zzDoqFSwCmxCy1gxxtpstU66RsSATYq6spKZNy9a8PyRTLkX56uKVypx5IYjpfbivPvIZQWPQkCwKkbXHrWAoEbdKQKC5piAYBb0dtaeV7bdHkT9ZrSVti9woKsTvkZpORa1iligrmBPdDLPAtHiEbFAG5Bv0+zJiAVaKhaojYsF0CtpNhOlWRAhbhXNVsUCNdSiBRetilgAK29D72ozgcU4tqQ/5T0+IxTIu449jBw05oCu2IiJpR7Mb8cWz2srp2I9rWIztmw+2vLoqM0ydfEntEbctPL+RpCWFpSljWVyNSgeJzOQEtRUSqBEQ4RkLd0h6wjWnJQgLqUEKyNSAs2U0cqIlKCFTe6sqrP7GDOqc+mzIDR6XmzvVES0gCFxRKVWISogK9Ja2lIKCTSsQoIutoBdalohQVOFBAsO/O3Nwd8VOciCITopA4wfsw4CsTGGqpg+SYxURlCNFELUVUKkV3hmNydByRgJUvq3poRIzulrDnwxNcEOcEbrErhZigjyiphgwSHlslJRFRM0jZigiplbHGi6Y6CJFDPbIhiu46/c8GIlEwI5DVNVTLCMvXBMXUOZo7w1Ne+omEDYHsXN2RExAWMbzVbEBCuWKdDNXhWEC5QCV7YaPFoRfFF93BJHpvZ/dqz/dVqFiKD76GZkl1L8KcjaArBZXfrbDJdy6Y9p9rEs/Y3HfenXW6Qg55xWXf9rlfV/s6mqSigWLTmg6388dSqmU6biAsVmKtbNlEs3Wf9nK5GU5jVMOWCaTDtfp11tdNptjjN1nXBKlOw224kHOpTRoqwFbtuPOddwc66tPnspUTlBQ/LEIBnU1A+weKKFszpMYPmcnKDHTdCmigB2O/VUTqBrFeQELZARCEMTbZ3alLZygqDiIOBnQj5BD9jZ2PQbflCMIOgiqY3NEJEJHIYnlBjlmbXuh8lDsxrUGK7Dgm+yrmrwzmCwC4rNxgQ3n0OJuuIvn9UfD3xvnxr7Pv4x/HvgYnisFlWly3ik9n3hhX956BcfvO/pV0FgEIt9vNbG+h046aFUXFq3N9ZvL80d4qqfXEzDIM4gpNMpEjF4JD69RWcarRbv6jFxiDiQWG2urKIjdUUf49CvkTbopVz1QwG1Xwx7LhhRpyqrDjCL5qgGkW/Ulm621io6z4EMSi1dqA0SsTeffdXyVNDMZUQR66dMHGWYBQsYhIhwIE7Iv4rRIGOSRVGbCyp1ooZF4upVPhVVg8rba+4Hb+T6MF1MBHWy6xEF3Wl6dOIjXN88nkAjeiQCjeOLNJz46M4p4qPg3118VL0yHR1PtuGuTP+jF4p44lVGPRCUtzI1hQeL5JlB6en0gPL6qLoliLDxxFk/X8hwbEhwxE+ra9JP5KIM94eLOB+2Tu3iAfOidvGQC7MQLSiJE+kN/AiaVAKadGFK91OvUS0R4O1biwQszW4QBkpAonZbg88BqGlgDWPW3H2Xz3uBmoSyUpmg1IlULOM2iCbev5QGws+ukWxklAjFTC1kT6a3i6m+HwY8f/wqdpkIQdRlPWRLxrLVJrMdAO7JdSGQgXJahNm/CoZ52UN44uNPeEAvj9v01lfrJBr/5GFkzb6CX6QdLg2Bfj7w4ebf9jVyfh3rMHvzADd/Ci+RMMQfDMlTE/9qbYbq/V3QatgAgvPL3f4aqoc8XZKyjeul2RRkr75RGp79MmKozskHI3inkeADIZPKl+BmV10uwvGDq/O7NhFIjvJkHoZQl8WsuwFFFgGWCu6xSIu+HTcyMCluggVZtO+maC27ERkR37/JX5M0jT96vY0/OBL/ZonHDhWIy9Cocc+VR4MFD+Tdpf37MHJK7N01F3u4jL1oWuRuF/mRMnLntMjutM9bUyLLGG16nUf1MV08vf/fUmfvfwIdofzvIae7cFYa8PXxDXa7G8Yctz8A43j797T1WtPU/OFk/ufnoIXpH3j+6B3E2Lk17R8D5bUiGcZPhNCk+kMButylGEj541cJJV/VfDBYofkym681ko+xiAteAyt2+xevP8TFw3BBDCR+DXBT7yvf76l5lnv5icK6FwT3cBBnbT6G6/P2JeOXhzyKq1f2fimOoJMIYzFBVbjsaQ4ZG65B79sc8zBtVjFpsgMb+37jVzbeFD9wHl/rf7L8+4OLB8ZeycawzwAefIrbvF5xm0wueFWvjD+8l1zwyt5DfhGAFF3Sk6uVtW/pFT46Wdpc9kHTVRoh5qLCy8x4lqOJARZ7Gi8nb7p5muCF5BGezyNPvKrWstcqpQGRvBo1Phs4J1Pp2zX2peSr0ZvL9RtOU/N+5KnDZwAIDbnHy14nNKaumIsEawsJFBilt5xpJR9IpxeL8PW9Xp5oKbnjl9R2xbeX79khVKCmKZByOdYnd3sywqzk6GerxpV6gB6UB4huRaPI3WyrugRWq9FU056K0iaWxX233Yp/f8QcY5Oi9WH2emmGr0gi2p23A23EHZyHBf1GPPn9IJ6e+h47pEuNJy7434gS1F7XWXrnLNClKdXIrFAwaaT0qjUehVmQocWWtKGq+2prU2LvmYittz3TfN9YDki1yXI3VnPedKNWVNmK/LXn41SmMvl1ssrCLjQ4exO+WsGkPD3YfX5wi4+g7nuDQ/Ylw/ro6YuwJ/fbF6ycd/r6OS8pA19iu3ms0/5eToKJsE8bQy/3+GKT/n9872dvv/XWaz44YCOT73/9PW/5hd+//SJyQTDdx3wlGHfjiUmw4VfIxX1+hVx8iV/SO6IQC39YJX5Vffeza0d9McZldFpvddLaKbPP52I/KllqhPB7JKwqrxJUlVcE074kuskpOn6IwuWhrJygXU05JpkDnaQLIF06ej+IjwEoXFz8oRud93eGYRGUm419D/30F37/Od9zxcUU9pD4dsGHgX+giDYmSFw8QuLqjsTVqySu7khcfZTEheBImMTxEyQOw2kJ3IMgcPGJCByDnXsEMJdjAPYPt1wua3uyBTjs54G7F3Lw/9mbHb7R2lHLfliDYtovkJg3I0Y/xSyojmy1Nr0AA8DnsWpek6fHosb4Q2hJne40jKA5dBQlXMt+RJcvzOYuUNc5+MTyIWIAHZ88cJMx0OG82U5G56yjnuoNL72hJPe++em9yqDrXVHJl1OkQoEYfJvebTgkT5hnrW9gs38L3vl5GE9PNq+DSOUL4qiqiXCoytWR5WJxn9IHjcTenmmjYWFb8ADDrOEPH0LdLcPG+lVvERSwf6Omoax/zfe82ix/+F7591l+m6EI7GfewdjyM6N4gwUtQT7HEZ/gKmPngFU0T4Tgm3ophNKFHOxwxMBnRg8NKRrK9aID8Ei0QBGOB94RUUoc7r8j4hFCRijmSrzGgfFFXFaJe7PG8VTw34rHUZ+SI7cWTYQ3NLxIi9S8sjcQB3TVu9hXyk6Emio0EQNAxYLeMqls9IFewg6iyDv9YhHPpFiCo6+Amq5AdcgE3k1EzSpvAz+V7oc6uNzAb9CCaIXza/hS3jwwXE3Noi+biqxrDkXM65V1QVFK12jOOEqgzlouxw1rKAwL6QKjq2P70TiIO/Ad51Dog0bNA8Ziam81X0a82NxbhX6jmrAQmNUKWOZtYgMKeS6H27Q0pMV1oMIcqoMmIuq7/XPXH737dV9+61e44k1MXwQJDiDmUW2kyx1wA1sRjfqwjcI+ZDzXRRMxu03MR8qYnRMx3YmvWuMx+moQhyenncZv8ENMXfxNGi4Mn3Hbuz/7sVvf/dkvsbQg4deP3yrvEB5gIxIB8902Vt3uZzcfMmuUei/09WacWOCQw0414AUl+pG7iuB1lGVqiGFoZFTHbCbbuXulpJr4ggSnEjPijVNpNkVRiuWe1fZb3ogJw07az4ztSj/71I3GZ6q1YXksjoLSEaaBxm5HxTxVV1G/zUy6+mCJfRYo1hWZlQhDS055VxjiKpLK/UHr5H6o/Erd2ZpwMxTtGR5he8mGOP0y5w4pPLBRsG3axCyXl19MLsjOtBJQNwhQ3PRVV0fCkBPeVvOmzo6UPLUpHVGqt8qapQ2/lvBQOT/UhnSb8d+NkV+aRKvEUZqHepUKN6T4Xd0IGc8nFgyQleLRwSPLM2opCf0S9q4iD28Mh2MwMHZVTt87pJl1OF10O0fyK8JiVIqVBPr00tMilJ4WaClNwp8tRcCR3XCd5/bsBsyPqyk5aNyhL3Brx3FsTqa1waRUwEAhWnxgv42A7Y7Sigq54FU9pN4xXOeHT/wHkqJ6DAz/OXM3TECjjU3UAgOObeqi30KzIsWvC+FsCjlVUT+IpF6BBaVUCtlkCoum4cOSWDapjsr0/MXUoYu70nQll92iLfJhNLOyV8S4J0e4/WJ5ZYTM+zzrkB+jYzuGBQkin7P4eZZh7jm421KXY6HfYWMwzlCAu4/+jOv5efX5vNHDCconauxED3QjD0xSdr5/iSTdrUnKQDLxU08X35596vXCznBlRexiVE6CV9kJOsmtDLHqPFlndni5RE6DixRYz3THnq60+x6jR5B31IFQP8Oafk2R9UDhYIBEtTKLDl7nyANA5/loY+FWgdnBG8/p85oYgMmhrMfVYzVbeFux+FDMpBPL3YhrvhbN3Uqzt9L80FKCDbbk1zKO8FWQN8+rIC3Q4hHOxZHQKxXDLlkbg47RbtrTtlr2FgBMrDk4ypco5csz8hmM5PNU7//Y63Gb8h9BM/o/jHD/XvxKb3vZW5VSQs60kP3ljfLC8NbvEZ19SSN53ZKU/l+8AeWZ70pQ6Lc6liazfqkjrwn9Pz7ovs0MTvyFecssjf5fxmaWkcOQ7qq6dsfmh6U8Jqtsqc6t7LV2Uk3a4QE4JYYDxs+DwaRh9mm0TG+ik5f9ipqZraX/j+dNdU7nQbYU4GiNLVCL/MQa6F8VoSlCPRUsQSYKqH3sjfKpY6avD7xgmuFgw5L96I3OPJzzGRHJAUS5IT+7FkFigT1dBL5Nbd3bO5qj6ZIKVHlEVWC966xJ9h9Ddr1X6gPd9BVigkiuoZpNSqA3nFHWmigjyu8e5z9zlwTPXRN/SGi1FqJWwfsM+t2XogWlR81IlaMiNE59yYGmGRESjBgBzj43+Ta1iqhSGWTPI37a800Pm/ioyhmkPxioGdMJ/x96zAnUMMRUj1mzt6nkud/S3pQbKTK+PLIPWKAkel6EVFgSa2uJFImW7VpJlPCAnqEnVykaeUBNeOuA4Sc1ciLDCXqvHGuIRwdGSZUYBzYh0ARO0gS1/2iNArfwaFEbbG3bKKqhFaPeEnSv3mXcNjXr7rOFgTXrpK+jGKgN1RksJxLVslEdVC7W2blKbac6ZXUtwnIoIDKG59x43OsHuqskcQxgnDsP1T9AayOPSms2eVBC16yMtdwxCDDfJqaRAyuRC6xETu3byhXusjBOZrRwp7QuocC5K/9d2QMuDCgaVgV5GHVLu79172AoyLCxPijLOipluf0nRTb7XhEDIvDzewdXsh0MTJuhIZ7f2kfMS4o6/woHxu2l6f2c2kc1K1fp494f2mtcPt0MCHuM8xUiSN6w8I5IRRhcxVbfgWOkwv7ePLT8f1kGTGn9AxNyWSijI8NB9mGR/sSajyIHhTItIuDCUfsZjAFzoqKs8QzjM8hgJ0sPEYJb9/2Xf3jwI9tf/BMe9gRIZd+Gw+ynrfUN4pc7xNqGf9uQgnXusT2w8EZWXs57m+YcKlS+6jkzm8f8kQMHVR5O9DTAGMxRqeMvy1QP5WTL4SpF2a8godChgr0UniSisXqYbbdBk5nLqK+xQvp5/sd47uDYTDwYaiUfY9nB+5zQpmb3C7v3WtQZXDScqLUI79j3pYc/8fK/PvUzbBMtqiJzIUa6r+yZmLsvgl2W3RRzR93pxFytcjD5EZH7vMrzpy59qkAe8q5e10BVLV/AxpuDKtLSBXFB70gmpeOarFwh4bRh+1o/ehl56sjmQzeOro6P58r7/vGyr6meLx31XPFq1v63cFptaajbduwtkVi5BU32zAlBiI+VAcGAU8AFO/j+oOcHeoYmswymY1EJTtqtOByGSbDajQhEeYJs+EYqueFDuR/CJSngYygg+zh+KdgYgi2v2Hgst89MjDb07QUf/3h/aMjAu3DE5uuZXlX8qPWUu64HS/r1VC7Id7Kz0nXSQNZI30ht/6FMSTg/l8WieN+R04q1nRKrh/gnb8fmvq+vCi2GaN1h5Kh6KvgL3jQ1EwUIDrJUyQDLlAopKr1CBAWqHKBvQjIrUl6NlAmVXDY2CP0Pb7Al0ChVXkUTD/ssUUu1hwqzIXkvyEe0NihM7wsDFehXcM3TVN2mb3hTD858nEhwEiFwCwdwxXP06Owurwj09MfI5m/2NOE9npXMH8aHD9ZUFnyTZ4XBHpSEtdEKI+0Gvj3oZb8DKMrZXB4oy/Q/yRtDyvP8FwK+WmrFPa85jYv0NC5k34jiDPMqc9gHUqAHfCiiVZp4orByMOeBHta0x+A1R7n1l5uDsFBX/5au/rFlVlWSHfN3P66nYzv1zGpVZdsL/NDzDOPhmCR0fw1HGxL8ewRb7lgLggIUR+78LMT5mcr2TbWIykajtP1gnvAJujx65Kbt2YXeVg/N3g4gTMTeMhlbIS5R+nAoXkiCKVgGgnNcTAsspgXHw7RwM0wLTwbTdI4a/Dr2GgWjnP6G8FASKfzi/axz+qI+lGsQ0bLOKaJnKQqG3BK/iBj3SswLxzBPP4k2x7vJA+FHiHe+xTu3SXJ4h43W2xze+SN4Fz5CvPMpGsU7fwLvEDmBeVhPpqGfTrXHH/389IN+EMqRkCyev4/xzQMA7Zifh/L0VCEpwUtm1stYTfqKVLh6op44X1mjLr8Sy+Ymk6x8MvVwPeGBsUviReBsyhNI9eq1vg591TKH3VCFbhl1q6oaOl3PbhM/f4kyZ/e4lfIcbuBtb9XyTATLBZNyNSQXvArHknXi9uM4Mnk8OZ0/eM0Yp/MaT4zaWqwNdfceic0oczdHtva32Omje3F+hNmtyoXql8hpBDDyKoqMEHZVqXcnlRfnKt/aMn86d5FVN4yjvLC/8TvM9aO4EBlCcRUg7Xgr6lSFSt3oB1Bx2usZe5Lge25T7prwvVUv9d3V0VLlqeri7D+h/poe0p5ey8Q5zGuEmu2qqUSDEe773nnjM2rf1q4hyyr5JstOyeKXWS7HXjFIXyhwBdwZlnhIvxFW1ryISuvxocoSOB7hAFGG+OAKmPFWI9mkt6MtT78ZTc8s5MivaJBqTShAQmro0yhwAjsq1C1M/yoY1y3Y7ZBtmvoAK9ShMepIR5FMcEDFbohbRUjidupIQ6kUn0HHVK8L6M/qWnZEOQNxTGXMkZLcxERoVW6q8rYL934v6+FtoUzMRCZRJh4ADTYG4PS8nulSAcozFHzVA+RsvdRc7p8LyePbNVEET9lP4MVIO1qgsXJXDTtwnWGAqfWw+ZM6C8S0j+QvEjntXEM7KJEzUDUqLxbY7gANUc86cInivLUCT1WvqfD63iX8GT+Qq04ocE03cnIm5qtCt1I542JQ1sU0RRv7C4o0aN1PmY3IbrfVWOQfN8Fq2R8LIdg2LRZTUrX8do94wXUsagfDx4TlDl3PnaTm//X86W5zGdyyfKF1v6TiXlk6StcUG7qeGQGbLtk6M9x17KpMiDNUGvozode4bgKBnX81X6R1uq5EjDSCa+Z6gsqLkv1FQ09EkhFN3wJK9rgqIHPLmVdAashdJA5zKiaguPk1rm4o5tAB8vSlgReoCjSueVk/fhkXkd1pFcgEiYw5rVJCK/vlht0XopmqgCkHRpT25SKIfInSyWfb5T2Va/Drc4XciBEYj1IYYsvr1OS8ZsFkOEjj6msUvYxxyH+ZuP8PrsHpScyi82d45L3ztTfiWLvqBqo0kYV6raULlKszslvEZqOa5Z5MdGCqYC4HuESUFxhtqkzdLPb4AZZDH6TXJFdL57Y7ETrd34kTZwmtogyzxdaFjn+esJb9tJ2OmWi4ZsAUGQVt98hM+PNHdDHBm3oxwateTPBOdDHhumfrpYQRp251CvtfGb2P8DM3Tt5H8P7d7yP87I1T7yN40+4jvAN5a+nA9+PrSvWf3Q7IJbbLkZOKjxXpbWKoUyEK5G2BIsX7mHH1AIKYsOEahTKd6tewT+cq/tbZiaV4eagDja+j+J2vfcZ1r7kB+OYrvvmKb/Igdeeyyg9f8Q0hxTcJKb55pIRLsvX4UWLcO699mlezJpuVMkgfZHIYkbabLTgW+z/IuMo7b/x6NK7yczeevHGVn1ds/HEYV/l3wEXO8G+Ii/yJKvc9UlT8az/CZPXwd+0mYOoqMi4oL+srbccVdXeLGSIRlv6ucWeL5HKjA5YjMn6p4V+SZ1x3Le7OnQAM0YnBMB0EvM5u5Klzsxxgz8I/sPcuN+zFoYnTtFEfgsGG29lxcq6qKgAVBje1dhvyuj014x7cwF2EdyEBCkcBRHlQ3j0PKMRtwwlQn131+YQfQT910Wv4EarZKxYn8phx45jHjPD4HjN+0QtkiKfc3aydjp3JM+jQT8HW8U/ZTfjZtZpKf0OKoCVkji48VOlppEw+bjL5ag2IXc+raBaAlRzZtM/U/9/Yl+/RL6uXCMl7dPdgfvHG8XswXvUejHeS92Be9ahsVz+qFr/3xn9Ha9sjzlQ88QN/45gzlV+4cbozlRCtTI5njHvMY19ojXH/LJxTCDx0r66sox4p+0rfvT7x3khXqkt74p+2f51Mrpfx03/pNWal4Z9r/t/cNyauU6maLlUD2EUokeJ9//8l42LhCmydtuvWSYUJVUdJ/ev6xPB62TWaHwcj73kcG4sKvu9k2ot8J26ybS3Zkl2rt+koXPctIyPg6QicyGL6oyBYjyz3zb7fdFoWx/ySHvXVTeRH/TVzlE9SWF12yYnRtW6I5OcoPF5gx4a/y3qiydXAwKhOKBRL1ainMQEk8iQPhkBfBq0mzslRakXGKkM0ja0Y2TngYwr5wwQsT/YXwnxwSfisaFPID9WzaI/pWaCwosXtQzF2PU5eJmtGqIrIYen/tHrk+uEkUk8pEf9Z2LjLvG492FzrGCtr9ndoqt6XHXXLVETZ3yNNZXZ7sRc2d3Av4XNKgE1P+mNcxCvqVK+ojBvTCf6+3dEP3nfOV888ExfTS3ns9EsYIrp1LsQSqkNV12UGg7Qu5gCOFJvaAEhdG6ixnr31TaJFX97cNwf8eZPqXE556ngluJDynHbA9dxxKzX1nr2W9r2u+dytdarfMaQ69tZHTJEVTdTmkfU8ASZEehyJy8lAjgjn5iH5F4hCTmjuiYYKezAwI1oTDwV9cbG+c00nXvYABkNHId5gJImq8I5ODt5RFd71EXjXKZqAdyQSboZ3xSBAYwTezQq8EwvvZALeDdzUGIV3VIF3BHg3hlrNVHhHDO8IDNUUeDcY3nWesuLGPFWLgxQ4XejsCwq5/hfOwT5AUV3NvGRfRJIxKqgbjb0iUAYXBYhWzwcxDfaNnxjqsskp8KipZf4DylQTEcfcJfSKMmVNBdZxtiFJIZQqB2/kVVHis9uQSUZek96j+pEm9oFz9DNBIJNLFSO1ZxLf58Ps8htNsHqR/J/Vi/x7vyKFczrrTpPjQ6+ZouDnIOB0CGOnQxhP6hC6dEkFvXyElTC6QJaoHxzFB3oSEXBnPqyvsuEScbo1biKiPEiHQwiACWaldEw1cyhCKOgLkpAxZJO4WCRVeITmoIL8CX3BgBv3m4oV4j4S2TnETwpG9QUjJ4v8Ds+f5guj7+WhOcyyrDReEnGfnyII2Ejff+3GCX8ZX6+eB3/vMXkehIvqk/c86CxcXBN65oaZ48JCR0xUuVN5MjELVElQnweoyWzPeFUbDgh/NRwdDpnMWntZoZUYRidwcHJ0yoB9YEsdB+7d60K+zb3yitjOwQecKpG20BjyvOlHj3tRM8J1cTWvRwh/vhL+tLP5KaWkWuLtlRJB6g7jXbNpknAPt1S+eMfYFwP3hSbJF3dWvnj/2Bd3uS80Sb7YkC+Ei5UJ1JemlDQ1t8YBB9OjUahiVTVadOSilzInWCR9Iv5jqXfDTP66mtXX9uTNlmdMF+GSGYIHNdiiAFQzb+vqMCN1i++T5KV51hezzChGGpbPUQcDNo8Y6UG+oGZRm3rguajOV9D4YhnxXVpGVIIKkV9OjvpfulmCiL1fgyEHP61BwVe12LUmJMp5kMJs5/cl4r/LehYIMDgWq6UhGGoXJwuQYG0Rk/f5CiXUpezAmlivXOW/rZvYGdsmhr4CwnO6WXai7XnOlXRRCXd2D63qtVOfmLGTRuNWKraBsEEtNsESmAyj2JlUQ+kU0wp/Kbe5crTPHStQgM9ykmeW56m2BDyAfRY7iNMf/oJXwGdAy16ess9iJyoyX+35JvssTuHKi1PLhF+1z+I0JERI2MvXir58sX0Wu7ggroYk7YqV57/n2NPsszjdpX3f1cE5b9iy/lT7LM7QtOJMOpNDWrQyfPZZnGU/p4hDeEiw9dF3vecDb/u7/On2WZyN2E/sOfTBv/6XO59mn8U5+rl09J3fdvvB577qzR+0z+IJgDJSDi/+9paB9y9Pt89it035//7Th5cOfPg/f8g+iyfalGd/B/79xMX2WTxJUwCjJxP3qNJgbfK1n/zd/3rhH33mafZZnCsFfe72M9/w2c/81w/aZ/EUW8Urv/Ku7/zLrb/xdPsszrMpn3z+h7mhZ3zIPovzbcpPPpjNzs5ef7F9FntsyqXS0F/7kH0WF7gGR8Tj7RkEts/izIe/lZH8U15x4cPfVjyVttNTMRKn8mD9Dpfnm2z2WTzVZH/42/KLKKInEz6L+LNIP6ukn0qKmlJ1REBEErQjUiSjEqWoRCCy6JJTLuhC05GDGBXIDTyZYabd5mmGkCoDhtbkYwNGGB4yg0EG9GQATQasVAFiTkQlyHZW+04CsioAIsoZBMh0Jmc6UzNV0reBPIModkGmzgyoonLtiflQJdO5rzQ65418Xoi4eAsoDiy0bH2JnK1jq61a4thhJ5q+QGPxBUxbPo0LLqiFmwxqa5OeBkpzqrE6WGznnvLYXUQSuIi2ScJhk7CNIk2IYM5RF1vaqm3gbyKhaYGsNkLOuQlc9LZK9JdsdEQXYfBMNJYERHN9p5poWsU+cpW2whPmVudBoMmMcT/kIwV0MgTfilPe4ukgxELmL0bCWflePCjv07y6zhGi/wyG3zP6dXizupiecSCfLyvPu2Xz8pWyA/lW209dMJqg7NbtlV1juE00vyZQwFrTJ34AzovInMcM5YTf1OVuLCvB02DI+yWFzycARSHmvxiTVslHGT4sS1YXCP0IXiG20lhiZhKJh7wsZ2U8F5lccDjRHUvkyAR4UfSxNreltT4VwIlFAH7RAJ6avJRJrlgd4MPMrexuetRbo+U1rl8M3bKePpQE1AqmD44CIV1WclH4TohDap4YI+wb5lOcTaGe+FKYD+TKcbUTUc9A+jPo6cqAZlgoM5pF5Cw1EOnYkgo/srfC83Czl6wC167iaTw5dL/VpBlsNIx5yR7NC1dTrGhMwU3YyqPLD9lTJeJnZEFRQD056xS1b5jPKJYr6NKCuSPJmKU3VOEDTdzs5KfKs5afyYkwPiyF0JZ+JBhUCMOTL/Jwb6GVA9RV1JJh4xm4SrHzTaLDdabw8otggJARMgzjpSSq4FFBnBTTNolURLRJYFUUSenUPBKykADyWwDkLX1h49XDXJu6iGNuzroa0n52QVfKrhSmK4valS1opWHmugTwUyEgty2GjXbBk8LQ+cXRdyUg1Xa6NhZoT2HauAAWcIF0hAVxQRPWiiVq6JueU4oGC8yEWk5adrOzN2AnYtQJeXNid7GXyfUHMlpNPhpe4JaM7tP0wplHgXGAmQfW+6UqvKiehbk/k/5tGEXwmoAL9FWThJHWpQVqTfCoWHos1v39MU8vwUVTeNKmTOaI8CTzzMyzsh0UyS2MbKpR/gSXT0QGHIo0OJRNIQMR5h1CkeGmNINHBxYmYKWnZm4cWSO2bbNtaEksNeCyWAxG5EKvG9TiGDz247awWmCVesKyWEpZPJfaY8QZwG1Gd5t6zBjlM/3Eta1NM5QayfKVRbvH5XYQoWW4tlWkfWiJdCO7o+iogCAhHP1mvyrCstkjxdy+77/54rW/esJvkVyXmuUyOwOaHQxpjub4JnzHlzF4wJNhAWhGLkl19NC0U8rpIJKUMsoY6hxZB1DUDU86ersjqNWufvpwgMuFsLUlotRYtAgySrOPWv08IIWnYhFGK1xKDKxilm926M4UZPpiP5h6X9NXXNZrRi1+DayBHA2LmMMayNGjLtjPzn5dr6KJQco8rl7eiCgepD8dsPKG7oY/NrYbPup2w5oku+G7K/vnT499ccx9oUlqTUq+6EtxVDNTInuHiPqwgHvkqbsjXCuSqAc94rfAvD2At6rpt2BdkBX3ctx49grkxwoiFeHgVysr6qLSKIPjJCi4Uia+ZFUH0XpFSoDIiaE7MHfHH6/iJztQ+ICvD4d+mPNYOK+XE0GSm308xL9xo95IFzCQb7ro2oSApNm8ZROh5E4+V4UK1CRZVOY2PsHTX2wk0G/lP7neGPHfpAsX9A1XGXSAPj82QPe6AdIkGaD7K0N62FncesDkOIaFEh+d5x/9MYmarksbHNNUQvjeSvgBDaMBHy2DwaG3IOgst37oOvacL3H61S2V8J0ahrjyY1oC2n1UYxE87IIbErzbRNwNtk97jK7JDNQ7Hoc8BDGJYFtOX4AP5SyC2XK1nndB8HJN1qFqQfX5pRQYA41XV+4HGXz1lBdRSzGxQ9KiztT4hX0ZBooMggQYaYnChY6AAr0gcQWCeoPiu6rG/LK8ISmfRkqGIG6KWMX5BxCbiJagDqBuRaihabgUrXq1d6teLR+V5Qkel3OxOhv9NbzvLeciIhpuLsLLvetvsi5zCQxMdS4mkh8Ay+ugTleJemg8YnWsXt4yaRqvFAn5Z/i192FiOveUmJGREcg33azMeJxkdsqcRB03jcyqg75KO5syGNBHRb9HgQIj6x41jWF5Aa6CCQDYnf2mkM6Wtr9dTtYZtLuOdrdUHUThkmK4hSNXIpNsRmTcrQ50SYR3N/q6wDUPkCiFz4Dg4Fd7Z+mFWRy/+VXw+yKDdkcR47mnaBwpOqOroSQQ2xwfurUKaACbHhluh2R4TYaDwQBr3lAO0nClBE055JNwTYSB5LrQU6VL5pKGX1FlVisdCvRLJwytr3m4N5P9lt4uEiDjpzsg392xlLm3cUfpE7q24Y4Z3fVgwgnWxh3u6uZgWLkyPOA7qF4wqROkhyNd1btbddN4NfeIHwt6dSfLYzy6sPVDNdXaC4VQLEhoFbNNT79FeAt96Rr0pdUisNi/QBerdsM/44dCsUePv5PjXElowNAWl4tnF/sunMQmWAov4Ud8Ye1i4+W/arVTdcHT6h2joLxjFI9fpY/tVfpYjMJTCmxMRXg59Y5RIGdbI+Y6g/WhiC0Ap3P5kfQvZujsAXHBIXGiJkwSBXsCsC9o5gyZ9Sx5twShSn9WWcIuhNR+2Kp+0ELdHJcxJgLEv49ey5bUHVymb0oEzLNsNtya5AmcRWmxrhFm94g9YVl5iGqbWJeG0LxBdbTQLnz85sn1vzohx8AG7rKBoxzA0nYzP7FA3S5P/sTX572aHtyDZ3WxO2ZLuN8GHtRPMfvqsKxm1y+qaZusPTKKsz8wgOgffLXvPNrxthkR2uxz+ciWtN95KraZ3XuL31cr721+zyrvM/weunfhpCOrRapnC/2DlM+5M1QkM96CKeMUOF1A/mKeGnCcWvhizI6alOL8+RNovfZJvwvIZGjhrV3mAXLLiSke+/MFPcMIaEYpbxuPRaXDS1K0bPi71JRduk/L2LXTEn6LBNvULbLNXpSIFSO67FHPbldhCkPyrRBSy2iIPQIr/VjEg8UseCzRMh7LtAWPLdSFCIZFCaCDNE9z+GM95FmobXoUqHt25TRQlvZnUfsTSJMDo8PDrVT+AcRS7K/EV/bUJlCAKawp5FLILjOLeCxaayRLmN9LRhBzUO0+8uBdAQc+cxiqfI50sKy8rlPeW+lM3FvBpqxMnpmW3C6T29OSW2Vya1pyWianE8nULMOKO9nvqVncOk94p3b0AU8OWMORA1bPHbCqmpuyBQF5GyLoMJreESQeAOjIXhFbXEMtA9x4CtR0R7hxxORZYAMr9epZbel+GyNFdXtay+uVc3rs2QNaX9jQ7LfRmUF6rdgtkObgI4/RxhO08fRkt9qPcdpuI5IKBXdHw4EpoGoBrbx+JQtA+hLPm7qA1kCRQ0afjLwXuzaJPXKn5a6rpK6XXXtvE77e+CPydZH8+PgieY0XTj+cxnjooStTSg4gTL4+cSp/gPhH4HqgCKw2gh7X84wL9T37HakvRucNvNMvN71eqQF5riqX7+EkTL7nqgnn1QKS0bwuGrZyHxc2Ovs/QL6arzv4FSjG5ylQxVzt0xt/RVs907bg+LjoYDuX7c9n1YdERB0uDhOuTZ39UMSepxB0AHLZr9YuE/lzqErqS2C0l1VTvcvVUleE5ix2003oCkVaYU9U/Nwlw2J1f5FxBRkPz1byD6BGHF1IH4rt6CJPLtWLqBOL2dYOQBaEF6abeAF5B12LhUPOngstwe3UvWylFBxl8syEBHJLY2uIbxt1aIVW0UB+9vDMftfQcYaJesCr05YD0lIko7Q52koJ6qUOhL7cdo+yJ3g1pPN+AAx0ux9qvb5W66HaliFYADaKni2Lpsmi5zcv+lpXtKOWKFeA3yYwtTIoGJJMYcIxALK/X7VVFtV8kSdgzASgcZ5JhSujXVjBY4Uy1JMZB1B1HY1Mxxagq6v2SIJGJdQAqjSoyd/kTXPcDB0e/drXIR3FWv+RYW02gbVtYG1EbWBrVsHW9tcYW/1/X2w99uiwdZc/FVvDx4ytKHoqtoZfj9gabo6tSnov9bxXOhE8aLLnZmMRoeaQ8LA30QKjQo5uh04+P7UkQGpqSeFxS/rtwPMnrwYrQG8OZNerFwVuCarbXs1wqJrhppEM0LuEGQk1QNuypiUQ+56psXdOjb2lEnvUXei60atUfMibbNnLK+nXTiYfqCRfPZl8RSX5qsnkZzu/CS5yV+Wbsya/Wa0k02Ryq5KcTSbXKsnhKJidSJtvbQdWtc5tTbJPqpseqr2g7Rm+Qo8yIqeCK4cWpaUMVu51NpUDY1OZP1K9VGGV3tuMcCIEZm3E+lFsmSbxS126Y1UJdPUqvDqLGuYNKDk7k9FUb2tK3qhEN8nxfQTB949+6tT703Nmn852+/jAZY/RVm1UjXmAuMMaaNHO/thancBOFNOlUbWmNlN14Ka2F0esqeUzFcmCnoRwNqdlXWQ6NB2Z7RvZTx6UzaleXYM9ONSaKIZjP20cz7wTsLQX3GalCFGfmKt0W/xw+nKCOK8FMhABPHSGBV95SrFaM4BDJq4L9og5N7YPNKv1/Ikw1nnTLqfzIEnzplpdDJAPEUnl5Ke0mHoMno4lS3/D+uapA0ljKQOzU5bTO9X0jUhp9wq3vWo/lKFBe4fUIjscqfagQ3X9Groff4oUbKywVR7wRx3W8a+OVUrNylg1id9HxsoEj140wLhJU8aEOViv68r6ipury3pYBXr5fFXKI6eOLGSBPQVgsZzFB1R3+6JjFcmcjrg1yn/w+/+/+rufsT7kM0LsKyjJZ3FvVweoX89nzfFX39r1hXeZuuLmJTS/AamWrjJ1q13ddEJAwUAUK3DFrGyIdekzA2kszWf/W9dwPfxr4ScrUBVCidwpoDqvArrByuspsmLWSY9rmkGccb4H9gwNFnG5f4ZyVYs6wYOzImMLq0sNGHFJ2RVK4PUn1puOI53RAorR7sV6JTjOvny9vAdOqonu+mrTuQBlCMaGdKj6oXx08124kKLnA8cdpjwdK4JmXBhze2QMg4qjRZgIbU4IZvftZTx1DQZSNmFPFE0DfJwlpRnGj/T601u+0X9OWGrXEpMt0Sui0mxLUc8T7O/Zxtvea6wYr0IgFR6uB3Ka4IDUrO70U7282WR44BwXW+TntD24fgvW5NILKvIl2KZI1XmaOPWOiR8dFTNA1zZD0JPgrPkGkhMtCcF5gdzDC6ptki+iQaZJQtkQuhxMB6aspzUtMc+MM4KHAnhmpq5wzHrpIM3+SmjEoukUytgiBsAv5fYvws5KdqmNex7HpVBQei7SlO+a0SpYU7VLHeLHSrkgmovmXKOPv0t71vur9lE7nb3nNWN5MWd7HOhVPpilzGTswkldeFTlZSvyslfCXQC3Syt4rJAP+Ri3tPR9C0Z1C8rDstyUQxCEVqEvDKWxphIsA598q1oV3oaHKtRQsHeqt8CctSjuCqhOCAxs4LANHLSBB3wTuNcGjtnAUZ9WiQDGYi3fwXXt5BHdKnfK8NL3RbtsZ34KNfOdtINO6ddFKWkbh4BIqvVzKm0nEzyt70HvBp8p5nBCAVEjhJIMW1UIy+k0pwQkyIZ8mFaSL6dTK8ldKNgwcLFUAsxMUdESOG5ols1pbtYcNcwMn8Lzoi9WnLg9cydqC9rBhTa1LQwlZN/6HLNL2UlbsR1hPcuydTtP0LqvKbBSRXfiEd5p8N8MdlNrzbtaKn/n5T1uyw4LKeqiCkBuraqatZPfTSvnxpJ6qP8ULrtHbZ4MLQOoUwAo6rcu5TBhm0LURNQiUyvM8Q3cKazcpbuNycwuOFkG/Dp4nEJ1htmGl5+uAT8/I9iriFbChM5QECF4ugYNVGkXLdCygWgFXE1smJtGM6c/I6UptJrFSnXQFHBu4EYr5sl7msDK1YiXIq8OnOY7lXLNuVkraEXJG4ZOqxFUKOuSb0F2TpFYFzNeTo8DAN8p8jyFluW5LDJ0JVDAjUUOBpZW1fqHuPEBaK+1qMVxNwcieLgp0O0g6JZJC5XjE00mR8VTsxo1Ut1g5mfqh/lZnA3rU3E255q+QoGjzDM6q1yozqEziR9PcAvVqluotmyyUAGZsFCRn5MsVrPHWawa5CkJ7EwuVjNIw2bCLFazlW7OlIvVLJFZrGbcYkU0+1yk6WieQ1QuVk8YX6wySmUBIvwdf7FyeactVltoVTPq6pTn5aLFB4KMScA5Xb1yFzG5hBEoGrd/ZAmbmVzClkaWsHNHl7BduoStyhJWfE2XsCUqANzFbyxh/5cvYYtuCVv8d1nCCl3CCixhhSxhmPxYwmY2it20e2IJO4c6gN8T8PjGElZZwhz9cWvZZNJJL2qERY3ICDtmORggKOQ6b+oG+Lj7ps2XJLcWzeha1KGIZGWKdWX6P34LdYpuofixQufwAwiLxymPx4ZqJwd2Tt1QrciFg5x6do3qIsJetTlF1zDKETG5RvX4ATzA45RvbLq+FivWN1asb2y6zsFjJz0Bjx3/IdevvVINFig0ypCsneZVq7dpikH6UiVlO8rclZyOsGnd01a3nXiCBshzx/G3cAgazcv0SBR6xrHv+Lmfc62X9CUM51OlkeYav6jqXe7LO0zlJHryGoA2qplqhGDbXpTy1Op9IFakE6N+HBIn42jinkpZRYDSiOTRNcYK2dqGCjftGZpqv4hmr6rMFfGRoj6u+gtT0v5gAAtAdb4I48sRFMrySmXgPOa1AJJej/+eXkbbnL08dndx/JbnsuJqhVMhgqWc0YxSdcVGzxGuH5HxqOdFdIcYni8wvqlLYAcA8h+NABlxVEi3RNMtrUJEYWcgEpw0RGonDZHa1wYi7txyEjjpTogWviquA+9BlgK+d/QM7YvWxHX6raxa7e6fCd6ptb3cM9iq18Nw0B9YZXSrF6jH4tWD8OuDwIev64qB0VAbqAd5kWp6naWa1Lso6n91OxTUWi/TQwo0RT38eGwrJYDvcMdRxjDa7sEdT8k2hcYhRfbncj5bl1GqX9lDXvJE+c3quITQVvWJrfm9BlkTtbKaoFVqYj9AcZkUt78/CF5EYfaTOEuRRmPm8UNNskq1aqfe51y/YGz7RIJFqrTqow8AU+GRhgHJWC8N4rCGX4v6lQWjREBoNgc41nygh1r6SVmrHuhrWzJpavZu1IyulQad4/THw1CHwLOqzMeC8m4P1BQdQCNy9qcmArXsg+qDon+wcOrBdagHF6wdzD0Rc69R5dRbjXSZ23icTRYcoWj9XU4bOoA2NN+G2USBWi7VIHCLDdzJARyDXUsBtKNv9NQ+9oPmebcmB0fxrGpHb9gCjtnAveaTB/A86LSjMSSl5rqdZlfgRJ+QMVQr3HVoKqIrJE4WxF8X+UrMV/hNlAnE6QSkMig06HfKGzYZhz4WlG6+7g4q4wA6hJnA86CoObtSgNXdwZrWGSqOg2RTBCKG4av6zUU2p8/q9FwDRgDnB2ewEMHJVnbddudx6WDgdA48p3PgWZ2DqmpBAv5K/TBSar1Sp6AHqejr6DrbqDp7FcuesazjMU6L1fShr/YDoY5unMGJXm+bgcx1O8vJM9hRUEvaoi7VilTNLKWlALW1Jhk02caiIzNqi7YtyXmCs8QHfNk/djh4rwYzNK4GZWYhCnO6VZmXZuYLSrgWFTBLFMtsxEPcjbckhAFNJNQCXVDj9fye6u6Iyv0R+sLvc8R/pQmbFPeXU2vCRv29zzFjporo5rp4PGW6rBhrAHjWpqT38lXirRfUtVBmAos1XR4oYZKX1H4YNa3FmjrVS+EAN2qMi0xpmb+06r+L5sYOmqy3yrkqPLN86zSLNdtoK61CUX47bZ9isYamW6zJYUGgmGKxZgcStk+xWLPTWA7ZPsVizSkubcJizamaVpyGXQmKnrRYs8t+LsYw8JDgpMWa0xE7YbHmjONZrDlzU4s1Z21qsebsTS3WnONslzyBuEeuwdrkSYs1u6dbrHniphZrnrSpxZonb2qx5txNLdY8xTX4NCqmWKw5jy2orMD8yvlsWWU79Wg7RqKg86ZbrNmj2WFwZTt3/wmEz07jz07TzyrpBSlqomrOSoCUoN0q7dBIg1KceEoZsuiylbZyiDNZ5FD8wUP+O53/3MCTGWY6yzzNEFJlwNCara4Q/W/3FPM2ZABNBqxUASJ3iEqQUbXvqwKyKgBO4+q2ETKdx5nO00yV9BVZChbEbCEtMGs8brHG0NS8qQQ1h6G/ujiLXwDFSSilLWKxJh21TFPT9AUai69jr30BlGgoy2vUUb+/dIFIh4XG3OsXPdijKRibJbCdViThAZOwQqdpwmmp4W21pi3SDN1i9rRx5u088oVkFzRZ8nmmSA2c5m67pcLx2VKJUc1c9kF8iziqoJVKVBdRpwF3y6idiFqhYkwEtwXCly00Z/V928b8TSr8qqpssZjywnKleCoSzsqX8CCxP3IR9+YiGL3J6Kl00YHcl+ryRWlIvixNzLdID/IO1hksBs7Ija5CS2I6RvuXL1Cb+HGBtUyRw41aTaUEELvK4nEBzJdChBXDgzNgy/O14wRZY2sKPsoYcltoLDEziUQLVJazPJ6LTK7dXMTiWCJH4ha6XKqp0ay0tknqCQ3gTQx4qQsjN3XFZOnLPCxNiJGbbI0rp9RauKkZ4VSzauFmu7FwUyMOCQY3MYhN4x7GWLjpwsINHj7GN0XURUi/iC5U5q1FnjG00NArTkmRyllvqeDVP1iycQ1nZ9XOP2qoL3lltPo/CkurmmJMrcY25XXOaCp/qwZTAUermPq3ge80qSDWqFt1ZtUcg+ELdS6v9tD16tHHwMqkZURLYvf3Wy8qEt2INSihBvM897kL1khpHeAksEcwVA2/Q02wex5E6x4jPJxXyf3q79+P+1COE22puUxwgr7qZHqUSPMKYbIH5fWlDw3A/RuV0uwzeiM7pToq2fwDf+QDah0RL979V+F2XEMUEbM7BHLVxqPp6XNK50B5A5p6opiZp1W/217uy5zxHWaFlHBTjDkZgNbUFdgUXLi1BgMbIEENIFHdSQC8jaJVMTdsw3exJ+TWcEjhrUO5e7xR8ZAcsJjgf7DqOoYNm6G7MPlVD17N7+v+gn8olAtkkbHIwgliO5wfaJu1D6NOjYfVO/dUy26VXep1oTU7oTw5f529RewmBxw6IiGvIopomQt1YFPRJB2qaAiIIBQPj0i14hOck+PhoNIM5VOrookfirzEXUxz+x1sKb9rMw8FejN7/aEAYOD937dzBD+ep4/LrciiVM4OLND3Yt+D28w4FFLVTlhywXdlFilYFWgv7aHsuNy+XgxXESIl2CP3NSFoaUg9eVN3F2KEOFvT1bNwm0mRVTXNNXsoh3MteaBuSVCiOf9KkIxRblHdnhxxY9rc5DavLImKHBPiZKhi6jkYbAaUSrFFkzw5CKuhm3IQ5pHEPe+56HND9FqzPwVd0MuSHgM6pSTn/irImkqAsXu0+x8nO0X3+HMZJARdihZ8f1VFNyuakqRKusipPjIZFNiZaQQ1RVMX8IYTIfXHQBEvkrjD+uKiqSaLmtnfo82mwfgWTdYi9JwzIVtNbYoucAVFBEKVEQatLm8t3hT6sAo1aQ+KjN3nmNTsVB3jZBxLcjiEa7bQjEQD4Jc99F+rd0qv5QP2jdKvYTWZR6gxYtK64UxaNyZNWrt0SZXBQmOwRNn/tEWJQK7aDDXNHxLHA/XDFNeiXaMqmXWCeBzlOx1sSf4bJEO1PfscQsyKwic4mg+D1kdrwL0Iop89mxnHCnZRRHh2zTPB9XyZCY01uUXLz+yzUjo1APRGf4+Irc5FNq5Q82B0R611c+6XI/e1unzz7PcV4RLX62qXAQD91BnNrhpt8mvpv57Vqqvk7to6IwaQozmq1hzkcpv5Nb7oNQf6KTwGsu0juTIfq8xEx4RioF3eqF4BqeNWiBnFlkp5pqlBe0ZX3H3aRu/4QznObwPF2AeXiNFeo+f4M2jZjRruiCXczkv35xliX+3rkT3CN2h4TnProb0thZTJbOMAnxlVucDWyJfRItMm9aBhiVidM7fE/mPRZX7Z0LAY8lSmYStI43a2DfFaNr1CGSuGdnm0TEugXRpnD/H5MuBzkcaVYBsiVazlsZsbcCUotHEJf5XDd+2hdhrn9WO5sYwoOXCfzNGsyRiL3U0uoOjJ9kNfX62vzpRADBDHtAQulltqj+Tr2GGsoFiLAoiqHMkLOeoqfORI3tMjea96JB9MkyPhSP414EUQGpShw2XoYBl64EYburcMHStDPOT2aD5fE8uSO6pH8zv6vqxTO3Cmm++gwpw2n2JPm+vutLnujuaN1y2DRlR3xhBPsZuH3shxs+Ie1Z3Qqzdy3hyrycFMtgVqchBtweF8vWxQfbMG4b6RB2zB3gXyyhM3aP6EbVGzj3VtC8MJ2cvD+R16OF9wgm3djhO07msMrtRMAcpxrGpmhRnyuqk5j7VktXJ7CrbfFl4qUwT8Rs7hd/C7aer8WNIpaMNOLv0U6uQJzRhw7SyP6Ov2iB5bQEx7rPYrG5DOThzRZ9QFFAMcwt/g56dr6EY5j1dcczDRA3l0Cd2tm1N5B1zaRYu0xQB2ROUhY3i6Y3lTqBRSJCOjp+BzQzjaAlD90xRgrla8FZZouPZp7lOpp/k3a44YsTPIprUJamiVrnglUlqyi3SkarxUe+q+BU8x0J5YCpbykKjBTiVmHhSlschUFKU9UZT2RFHaG1OUToVXHoqNLUfm22a9anKyKkrjqYrSKFwVpRXquoa59axDHlSll0U9rcOjoarS/HjC6DqGx2plCZs3BepyBvQaWc5mj7OcNe1ylk0uZ12znDVLTWnXz265nM2Wy1m3upw5Tek6naNViC2SJxA/ksq6tkzt6eua9NktaS4jljRGDjqlknuV5jSjXdDynlnc+NOq7mFCvUqEW9sSPBK7xM2OLHHdySVuZWSJO3d0idulS9zqCZe4B15dLl1l6FgZOqqhk1oKV76GSxy34+RoNjfkG0vc1xBcqU4Ju8S51U0rzWMt9N9jdZvV1a27mcp0BgA+AY+d5dKmi9zL3RKnzXdLnKP+usRpPx/FEnfDtCXOjZ6rfHJ1Q4VTVzc07bGvbqbKSTq1061+09JHy5/QLhtd75wOtTFQLYTcXSI+zqZLV6vpOy63TGW6TJ1Dga5W/7fswKBGHav+dGL0px+fHdlODuycuiM7xS5gFBt9w7GtGSUuXhFy2jqmStRf0x3bN3Zs39ixfWPHdg4e0KbuohPf2L+pfjVqw0BgGXLV4s3iUFWjenxf5zLunMg4uddD7ZtpVx9v34fg5pz5DSWJKkPHyhADV5Yn7BaLhX7yXKFM82NXkQLG2URAUYfHkAozokBN+KGeD2I82vAtoJ4PcNhXAS0H1AQMYmkBMxqqmtjlyNSepwVM7YDmQdm1xrJEdXpgLc0YMzILpveUXoBiTLN4PiRjrYRIl1sgpV1ZJFAZbSNCi3St1D7kepoi5wcU0QL4AX6fvd55vLDKuWn6657nX6smgLLP36iqor412qLaH8Go9ocvLtWhrwph77F/vv5QDQDM/hZfk+fOMaFKr75/BT6hGP/ayCP1j1P91s1qZyJE3a3msVYWoBWifjecUjqx3w6vqnzsXB941vdMn/o/f+NBsa7/xutF7q/x2T/qKUDFQf0PwbPBhB8FywwpcAPrihJH3REjg01KSOPCy0xcxK8H+nBdjmPvq/ltzfifVBf1VfeTLVHu/tTPfPJn+ITbF8OX3kvVmzbxOWz/k0jhSH58ssamKtVlY/ZxsVAsXmuCk60zNHUmorZfUbxkpVCv/9IXcQHqr0C+iygofWVKNepPNjnffAW1cdGQdCY9PSkbj1AeSMt+By1d0RPRSNQ5kYa6rCaBczPRSbPfUr+Xr/XYsmlw7YR5UV9OiEVjQJ1sM3ZV9MZVZZxirGM4VbP+9qPsFnB54PlwppxBtR+B7vAIOuYUyNMRN/xB+iTPexV5p6snf7HQI3CTzvv8ZqHlla5d09d51q28Z45pLjc2iZlKAImZqHiYHVg5GJZIjDcoWhf1c1EctYr40k05GQy0HzIloiuLABZeQ4Lf8zXgUq8IjZ1CX7/nbqS/XDpvV810o8UfmHcgipi38+wVFPhX5HIj4IchLnB14+ngYeIZk2r64OFC2eoXRitASbEeWZNePpFo4Eloqk8pEtc3oXwlIHelIgsXnN7ojZjZc/4qjN/I0BiB1elnrRjulAbgRRR65RHiIA0ImuDBbVVUxbxoYYmss9YMUKPvfR+gFjgtizC9OQ7h2BRa1I7QxCY5hl7Mrv6e7K1GXf7Tv6t3LdTCd0j1TdTeu8aA9y6qo4hMDYTtxENUx8mqRkRipxbGsakBjQxoskR91h2/4hqoTltjcRQiV8SQRMh4hI3cOXWk9rxV1VtLrmvZq/jpAmFsJdlbAQuJzjVLLjct5BbEqoSIQ+gCj6wnDGvNnp9SHVXK3Vk9q6cixfCgF0ADpxutmx4sXbuokd2OOouIkLloUgSNN2wXtRVSUA7lAX7lKqSe7MfxzUq5vDZE78j1qYhQR7n7okg7Nq0rKYJqu79MzsrklgIZuGY1K4A39extahsC9dYlh6zsZkg0KpG7IeUnnKf8KsRXivwWVD4MnCrMi1A7UVcl8ufqiIEOANTUQHsAH+NfH8jTABzg8SqyhXITpHYEZSZi4OUWWIbLY3i0YFYbd6QyBSSaXZmQ4qyGW4WpGbu18tlM3nSm+/bqgJJACesRuCuBo3B/ShYFi36+I5a/EEag8zgJj+yEPxyXM97cE/Ivq8pKQo2d8IIMRgRY2wdg8Zbciikd3ZqzPtwrZfBgD9BeTzDMiOoaFXLnx1nE5uTD/2KSh8PCeXenZN9/+YcHP7L9xT8hnibLlyt760WEmKFzVHHHgOOGbgcjyUfuGDpW0yBo0D8Ur8GI3Ee/yHVmX9brEnx+EYsOBvlVDxfds/exCnyjtNr9vL3rRqkqdC4MuUAoeDXUIRhIvnrmEhBZnhiMZpvasqZA+CSdHbjWcSGyCrA/pi96uBPQAr61FHEd8KvlibH5BB2lBBdXxkpiIoBWYIlZRz0NTgDe6h2D/i7JBPcs8ZjRu4CxQhEQCyzsdjLWqKrYC28d4nHFEcFHZWggtLBOqvug+3DJ/ao1rPVw2ZILtg7ysBwa9cOSC8tAHpTP+F6gV1pD962aWQBZWKCW2NNfqqxSR2sj1mDdrZh2rVTg9MkT9SbV35RTp/4fvh4cKuKN9qbHFEiT7keS6m/KwliWWX5/7ppmR6pxmu9LtOp6opOlEVKvooLyCS9QFb1pS6yvfDi0IANl4uzCyZCRNrzg4x/vU5C9Ruh2SGEZeVWvcCAlF7yqx7LCKHstPpC1O+p/6ManQeMzJP8q62Iv4uj4ZWsYtDKvzelJTkObQrRNmc/Kgp3eXw/qQkmotlFAz7Nqy9KKNTGi3Mjd0Q/ed85XzzzzyuqlJ9f0oNJ0IS7ujib44pBHtdJPCtZx33SIm6S2LHLBq3rsWMe1heJ1hXAR2yxHh+o/EGwrl7PvyfLvH3A5lAKn6cn13HEr1YdSjZb2vchxh6NOIawwUsLYa4ocunbW+SpplAL6AISqVnJHOEKdBxCc2leLynlZFYLiFd4mEH38IQk5FkMycZBMRiCZViBZt5CsT0ASyFs/ASQTJvsjkGwwLAE/poVT4Jc4+AFu5OVMzrBba5IFHzTDUk7wUt0cQskZpGgUqrgzwaw91ZjmfQOuBq7QKBXIFn4PlJffOSAQ9C7TiQ9uVriGDc/3HFNOFeqlbpu8DZClClSNaCF05K2kTvd+CEtepnuLpLzA2ZLQql7+BXl9nRAkn4Jye+hooU9+lQb6rm9+ZZje+lCQXrfJvsbrw/A8P9grVhH24Aejf3Wf8aB3TeFpa3yb5XrO4rksXu8aNFw8Br5djNDq1gZigtej0VUa+aOAnD8NcuqASQGowHAgWCgvs2ZSePYGQ50DsOimj/e+hptLYflyVc+gTOhgJgR/A4xSZXDuGKbn1IxA6pCsKdgxSJ/IP92XTbf/DH30MUjpeQxFfJC9WbDUz/5JTVYrgynwNI4Q0a81KGHiCvx/9XzdmP9/TOgk0GTM0u3/S5EFGNZJEcG6+gUkTmZ3F0hrVLKBVjTWZO1hecU/o+Za2qn1h5A1ZV/V5XaOC8s+JkBOsrcJ6P/U96JJGZN041/cTYmatEwFTtKVES3ewGnxBpNavC5dUjFpTrp49Kqzlv0rsto9fS17SF+hBB7IfqKvWvqBbDmxn4uwnyOwVEK3Asms237o7qrTS70qj7hA1GvxCLFxEf9UAKWH7+A5QG68c7Pej2ZRpM7JkD0P+Kn7E6dX6zvM/m8YXDRBGuBrHwKpk3yZ9w9LZ0x3PEEx9yrcDXZV1W0McEEQL00v4OL7XYMOfv/tdrPv62bfx6z4qmKhE2cEkGXsxX4JbiUxFF9BFpA36bQOhGT2ldWyOIaURBqRpC80aEvoDR74SKAZKjzBCIGllj4gguM5DHBJE2UHLrBVlg7ZpG2j9aTfzC3tZ6aP3KSKHE9rQgEIAXt0b6xIREFl5xemfxaEjetiYcWc3MQr7RKAmZaiFLb8dvBzVoxiWhUgilFQ3VNKBr2vEuqla+HWIT/jfcE/Ypsm51W6oYNLk9xqfzck05nB4RuZMOZN4uAtb0DQCM5bVMejLcK9YBd51YsZBDn+MIerk+Ztw7xTNTXv4Y5OHvIzc9GpC+qeq0PZRtEegl/1aIYQqqG0IWrEXsDjB/Fd/uuNJJ24RR4CGbWPUMAfr1+AduCTWcTvylPN0KXZI9ReL9oshcIoykUdftFtD5xX6K4tpGaFu2iK75oi6z8NE8ndMvKg4f7nKvTzZVNmpQtmU+Y5yxO1dJF/3BSoZX8sM3DrtNh+15C/p3jehOMMdVrRcj4rbtBDezerz+av7K5OUFulvmRuHGAWM5dlqkhbNXIVvtsPxa2XLHduj5Yz9Vbvac+4/XPXH737dV9+61d46Eu/m7rDU55DBd0qKrc7Z3OgDTxWSare6RIHrlTnJ3Dyq0Z0MABWPlS+REfw/kXzvu6uoRV6oU2vzkEi4847dExCDmAs6/KEnwC6NPetozFfRgjUH63kQa22LSiLNkZIUAkHkrEqIFtO7w5Ckcc4oB3z3VqFXUAFmUIjbvcFk8WeikDBqwIgJM91WW9yqfETc5RDY/xvBHqlLJhS1TcqryGR/Q05LZP7Y67iAh2kkK8p26I3tOhY2MXqcVMZMGdB+wsGmUh6iuBIEa4bn4nhcLhumEbuJnmQqde0typ51q+1vxCbXYmo+pRqPCdHKpIjRbAut3QiCio1YG1FxSwwgeQMJ7pjQDohh+XzODkWK2KW6ueA/v5jRv9Q0T8R9EdInK/qLNBxzZPR2RCUsyHBKxPvTon9NaA9xZVDv6IhiCfGg5vHw3x7GltXzFfB7xjmN6ZhPoo2mI9KONCYhvm7DU+pl1W9NTBUWOk9vn7TQzT3Cpu2oJe9W+jLfb4XVCha6Pg58BvZTa+ZwnSpFDYa4ekix9NFkzydS0eq8nSPpArck+ysSfY3IbviFawj/aC+CrtGvuPtIlzy/SC+dmxdpPmCkq2DFhew2LB1kbJ1EepX1mMKW+dzq35Vyg3MIYUYiuIn+aNsXegWgJ/0Q5hewxnMY0JjYK0gMgKyOzxi8Pn4uBxPx2UgFk6mwWopdQ2nE241OBOfFPqGmxDusCTcIdA3nIa+93p++JhXOjlaG4cA51chufY0Bss+raeoFYQr1B7q9dyxHkbTeogiTQ9ROAeiaT18u+eFFQ4/VEyO7K5CDSeoY2YI0kJ03TdbFcTxHk9vc/qYyzFCkRD7IPshmQp2o1PuDAK8Ap3B5srV8erOQNlgPXBx+4R94KGP1SwT3T9q+aFQNwrwa4kWaKOzHzZSBeVsAeuJLcPh1/wH2DJ8Mgrawqy5DUPgCCrOwUOt3Ndxlh7jTNw4a8Zc7i+sCRqbmJhjyF0mrsFTv0mqc9JZkrST6uZA0iRBkLJHy+lvO2AiGyIHIS97GOQL24h+5l5Tfg21ImjI+f3txH+X9TQZDL2ceqo343c6r2x6qCg2PGZKkh8h54za0NfPkFMOTTrMD2yiOoPZiLMizlMmEzIfGcmjkzBTG1keBepgFx7YRMBzFtxqu++zI1afQA2OvUVnCT6BDyW4AuYwnDx6UpCjX5YDkCppDhnMhH7QU9tXDlpi+gLlzKGH+Ry4LLeNygK5hE0erHQg1yx5PPwHaGatHzNMPNhV2HPNGmVlRwc0p3oeY/YKsgqTicWoqvPRRpY2zSBqxqhtAzyADOCiFvkgwTTyQBfTVKFYVsZMbJSOjm+Utk2LBdHQjcvu6TslLOPYLGU/Or5JusNqnLDZLwWoh5l4UdXznSafVUnePZlMleSdk8kLleTuZHJSSW5Vk1OOrfTvk54XXWsUZyr8ODRxfOUvq86Kq2d0LjZWj8mC95VxVR2HWokLYMuFysdDfsj5f2WvMRweYVF3EQ7yWNgRCiYyyKfIlccUgTs3a2eMo808dv6Q0/Q9nhdeq47JMhAqJ1/W46qyT3tHJ66BBOcwhyygo/wY4iySX9xnRYT2VHZgkl0zD3lrocZpsENwObjZ3AukCfUkbvptJiKBKP3LXgzjtmqvIwIHXINVVFaiu2LUlyL6HfDj/trayJhAYdm96iE7DCJAxlskFUsryfqwkPMtUWhqyFmz1CMOr/PmmG3JOtUHIsZJKcxbDPA2F92iljJj7Q1jdYfitQ0uOCEtUOQraGqL2thHtSlVH65g5J7FsU0etNYzZcD+uy6SNQIR6LM2k0U/dNqpkoSiURXJhlOToMcmNE4V+tUIAnQ6tKgUZfW99G/9k1cqRB0TSoVFyLFOqZBrO4EaISrwrRqh//0VNcKv8j+PIx/kZ92pEd7xGqdG6Gp5RIqD+x9/lcHBa6apDALY2ZHXTKoMDhFXS/9X1R250wd9xjt+4k8evvnL937lqZiXvlH22xgWvDp1naxBQmrd0ZEPvuLC0jKZ8wLbMHsA8lssZ+5Ew3t8NWJuBdZM9AN4apGzK7AogjXZ9infoDZRQs1i+GcrtsJ6bENG2SqkCPmF/720l60jsr/LsHFe/0G7NnnKtHqkJzIZQqf7rfP9BYRYCAnhZKVhgcwBQNT2NDA9NUc3Ki9vUfXwQQpXwZ6v5041t3ZUIJ2+AHDexH6PTiphqEJgjjEW6mU/rR0GW+3wSCqxM7jwKqc7uvyStj77mcoO24yp2rzyrMyRP+grHbGsudW68lUFb+ycxYcxEZ+U7zCV4vTowesrp0fvz6NEXB42XqE4jR6Ivd2DC2IQJLZY0WdfjoNb2Uy4yAb6sgu5Wd455kKTJOL22xFM9Yu7xr54u/viLvfFOxDEDnbQVJHjwVjukyXY1EYSbJj1DlCvSvVlsQnECL+5th0j9uBcH43DsflBbw0lzq1l70A60ElxM2cYbeQt3TiL9kETCJz9LBKn8b7UGgzVGFvC+a0dqwwAtopilIJfbfPDUwNwM/zX4aKlBZQqp15kwsTiI62dOkZlqvBKC+HgKJADZV2Ci+fiGrvPARxQhNXjg1orSOGO3E/H4720LyCnevYl7X0ftsMQhYCkFU3hvJvZO9BxlCMW+Mp04UPEqbovM3u9PKq3AYYcuOah1Yd3m/K0YtQ11S2ZVKyDM4MsgAU2OqaOpnLzwEAPyQrsitUtiik7zz+Y0QxSZgDZkiXuoLJOPzMGuoEsZW35LA5iNrzc08FQyHMtWEcwQiiHwrVy1u+1T81JoV41+ge9HAPJUYFG6jrMYx5gzOcwP0fIeq18/y97v7dXzKsSkhbZBuIucDnc6TseXhAHy3c8XHj5om3F0Yvtk0JUXyxxA2DFV3vO84X7LJuXzhQt4K6YPexMsZ67BZ1w3JTHhYRGB6fj7Pf65KNS2kLLNAN+78D+X2IEeHgBd3S+6HEpf+vRFs7vX9Mzt4bAD4iud4XH8qzaXQvAooyL59pCmRwZ1fMOhRyP/sys0QKPwIve+ozL/7D9FxfbJy1yr4tFWqKlSVO/Uw39wozi8qSZX0RvKY38fsg+9coRIUVN+37APl2KMez7PvvUlAJNEki0LBdun8gwAXgpjLZwGh76X2na9wP2iU8nrADzp1NN/W5m6HczM7+bGfl1xl5XAOixRk6a+J1q4Hcz876bGffdzLTvZoZ9NV4BvzzFrG/v4W+dMg+2wGrtKhuk3Upd2gqDtMvUm2roFwUQskvmJVohfAajpUv6WSV9iyCZXJs72FRgoexii0QdbjrzzHo/8mAL2E2LpBkG8o1+f1dTe2UztzFfWFZgZBjzNIe/S4t6r8hU5XQ274xO3xnhBWZUsM/P69Z4VoppvxCTGoe2XUfkaiGg8gWZvT1tm4nW++djBE6OgnGDe8mUp3M15EmNb3IupSyk8KX0ZemIj0uWSnAdAUW/UfkkIaWOLMadUfJhxSWZNqUO++9oh1JAa2FW22TftI3aq9aNn/vhty+mH4/sc0rFWLE3Cg9rxF7RV2dFa7k941Xbkv1Qxe3zrr3DgfM2zYqnIc5wmgDBjFxIY8ERNUV6NLvW38vdCnSAcl/GdOYyDBTNicHRzQZtEpsf/SC6sWtWx86wLltGS3jAy7dAV27LJLDgOM/gQ/dR4EP3EeED4CaQKWaMsGweUtoZGCWY5QTcdfaFy1K1oBne207SXdOaDhZcrVfA4MBIPJsxA7k53PoMLId0LGS4hPaebuoYE+eZILU8j+E+EgvrBVSRCEb6jJGG/dEN6qzjS+YpyLfxWYjX92kbT+6eiCYFfjEqAg+MLnqCPz6sYL9E4e/wEhwT3HZZYDTRcuRV4ahCVbkpbrQBLtZ7NPoa5VKpkfvQNCHAGbUGa9oGNL9Z415cx6v2A/xRdbx9OL2Q3HgFbBSeJqqpr8t2dH3kAD9h2AVFBVdQuY7e2bfPYgl5bfSH7bNYBPntgr5wgORtabQaEG1XTVathrpCqfE1Apu3r9m/GvynYqWyeln/8DHeQ6mB5xIWqRj9ZAIQAhdsfXmn7KFAOaR63py2QuXLwV7MY9zn5l513ERG73x9lf1M4mxSA1WVQZZpNTPyUb48Npd0CmQ6BWgZGO84p759ViM/bJ8CagWkzhqBEYDoLG/jYlta6o1kmAyZ7o5kH/SqPJMWIFE517R/+F7AEfK2NjYL4gfEpyzvHAdCoYFQs9JTtEU51a7rOwZaUJ50A0E6R33M0RmV1IlzshkGiAPHONvtVuRDnkj5MJHQzcz2Ms/M+qSdlfX8aJQv6+TRSswUcsQSB0rONd2y5qoQI1SLnozSRN9CU8oGcs3KtqlT3sjxCaNznElPHeBLRxE99+3SOidpswKzWZqX5zxtw1WWbbQAoC0Yf2UQ22Z5y+1rEyWra0r4neRc9xTarFiWkd3kyf0u3WAEL30JtxPLO9ZNkC3dgpiT3DuoNchb1S0dpBgtiJ6NUVs99Pj0NO2widj+nhNqh+1y2mE/NX7wcaHnj2qH2QMIlRNqgqYaK+RVVTFXe6HawCgUXFx2PcQB6C1DQ4ViI0Ke5JEKeXyclV6KSnAKDVMl3E1RPcas55E7/ADDBUN4CwIDFh8TbgJPTbwt/aMk9SGx5z/cT7XPwJ3+uwt0KprFIGrrK5o3kWyDa5VtMJoEXW2V6Ov+traOWykwAyIKlck08VuYIX5iN9vELIFPB8cSt/i1jWKobXezMzSjNBRXFmGeHrvZ1vpQtrNFE3vZJrWre9m078tttAoz2rK8ue5lG0DdtB8KpjcozhNKBVPNTbkWh95ib9zArUDelCdhCu4r97e1O9aLDNaDBsUsBeqklVpHihZesuGRYTEnR5xwZOaVYheALCL+jnsAvxb8M6RZfWniZTDMW3qQBBTDKcXoAQp3DcWmmqOFG6/DIc0d4e9b+RyJ1mr10EuOOoq2Slfk/Ouhn/7C7z/ney7X8y83xscu5nOiCgpUdVdbo23wK1VQrQrrYm7dpWRUsUS/foRBcoFTMMEh0Nz6kBs4l7fMUZk2UkzYUw0FX9lT88Q42zlZjh4+GygV1tN1oL7P7iPylvrREz/reVKJd7nnKh/qFo1dDMDZh/1OxiDFMRRaNhjIFqGX101bZ/QWA481RqaIbt0Xftv/+tm/fN6nvu+qtg6TaUa9TMBEark3ZKm8tQiVw2TzjMyQVJxuuQwVjFBUJ884qsQd/aTKi/vSdsFb0UP2VUTYWndjUzm4pAC8QZV2PziNdk/E9ncZ6rmj1NHNCnuSiTsjnpPig9y6D3DwNqoDXjkDzX5RSbeejnn9QXBgTZZnqPC/F2nQXOBo8UuIp14KMCo0/Ey/x4fWI5qkpC+w2hXl+XKIkPwkooqjHtfyyGagyLgegEaSKjvZ66RC09PzxvSS1QbEB0606vyj74Xo+nugWS0mv1QAjHzv8fJYouxN/UmZc11lzmLdSk4dYxBw3sQIoomkOR6XNOMwRW1R89JjavMJd42ldUe9QtRfqGYEzXXjREcvvFoXMKrw5k8TMielkLkGxqZmlZLrnIKKBWDW72IgDz0l6xaoSy2dqeKLAkCrNPZfEvzE5dluKONCtdFYtNVVbJTa62K2Tkarby1y/NGP/FOIBf6X9MiQ9FPysg1EFBXbFngY7MPi/VWfixD0/GXJqYdL/KPvMC2DHkEvoiaqQvxTJukV3V2jec89zz8XId7E7uEd7B6NfTba8GwNX3Kef0l5QEj+yFGid3rtO86vfYeEgsvPDy7nWu6tcTX4dRV/HlH4dVEPIgq/LupGj6Pw6xoIrWjvAv7j5FuQjN/sV+wXdyIKv9mfXW+i3oMo/LqooxJ1tBp1DFH47W+IhJ+jYP7Xw69rkFj/xW8ZNXFEVtTcgDqOTUfMsGzfDTKj9MVQG3s66wuaqTorYItzbKiA3WXnYqgnuQJ5d6iNFzsCsAwzVrp1p+JrJR4YURgGyt6nZEHbLJwiSM7dN1TVhd+PPGn6TLRZ1a5Luy0iNPAUhnII2BJJPj+sB1GKJK6kgd/kBY46lceSoP33XqunRr66j8wDGwdNgeqZpN5g+13lyA35+jnPh6aI08GMjPsKlB2q2qWPh68eTROozGBxRWIiTo+lvUhNKPke1dzMVCtT9EopzD5S1cUMS13MUF5FTQC6mPyo6mLipQgpHtXFfCYPUWmgJerf/Q9mAYv0VDuCEp80VVuffRRVy4l1tNn9rV/9j6CM+fGw6kCnqtluW6vhsIhVhyE2bpNdKQq8jIzTa3WUBtXNq6/BRwu4pwMrHMGBUiUzNK5fMqM3mXCMaAOo5qziHA7fdVFv6B7WLOyJrh74PNdjX81sDE6YNSMZFv6mJ7mpKFXYVTUQ0fX049wpiyzsGVFaXWGBuoqXgapQVg5yJV4UqvQuGwCx6foaletrgPU1sMtcai5oCc5b/isyoswF7ozx/kEN5BYABWVVWlwixVGKDKUfJ+yeEmeUw0Jdmc1QeoorwvCyXHVUrCk2pk+jSpBu8jmeckosz9YT60BC1/LucVHAnlIFsltRQ1yd1FIMC2ewa0IQ8GtBAHfK5V2DextVvS1FKijMy9zPDgkJlfH3wdfc08A9nPoazK9AtIzKo+pb5nwj+/CNfAX5U0RqAbMDV5NPeB70NICVGHX4V5GPSxIHVJ/mXk+fd2lqcCeeVc/IA/v9hg3cbT65B8/7PecZWShYSxuWiDrUPY01IW1VbN8INMd7+Km95doRB1rKCNBXJe27grV9s39z9vW3vuWapxkn+KFmshByxzcKJv0o+wTyqlLD0WhQNSfCBbP9AqTVeM+o4DROkFOsYg2Hcdf6kI9MqN719Yo4K8Ac5T4Yx05dGU9Qhw2/omzJhg3kjqeNSfbCkIEvLOCPoFIlyu1vyYOqOhoF6Q0jV+wPzo1e9f59XWNQ3zHfXOVwheqrh9Qs+wSyasOwFFijC3/JlhI/6UrZkFK4nrIFFK6nH/I8ax8nKfyB0TPkKb5RmKtmGO8jhVO0Jb9iDuKI24lvlsW0siw8nCzcc1960wvfLMswfb4jAOT8ZUXkX1hb5ocH5b2IAiwuunKqAYT34xaP+Gnmn2Xj+CkCYbpXoBk5bbK5kvmiMHsIqekHfM+fXPicCyzV5wuthbl+KJSAoTDiKlUXLGz+kete3/rCX1UH710IVtELMHKiziNt9oWi8k8XP8vc4NeiwcL36JUupur4yfYzCXmRYm2ky6FVq5TsWXmZ3R/RQHTt8Vx7PG1PDe2pnURjdIuPkqysM9wEoj90CFG/6vnwcyXgUqxWouk7aVNg6XJodoOVCwC6ZOnlIbhFFH4T7cdiJdopQenNfVg1opJOXsVEu9ahMT1c13lTVqIUoSdpSLrHM0a2Tt/LlzTX0+9grJgiTYAg3fgE5KuCSlCMRCEPS2ViAcZBgG9MhPCXoT/j6MS9znW/MJuD+kMpP0sfjEWkG2ggdJ+zC8kOQcCLkDOjSMJXSLynqZflHYnN7gF+i1DhRz916v3pObNP/15AW4ZLEw0LMWjKOGCP1wRbIFvruogB1CFeqAq5CVcNh55IFj/xlEDWZFSuCM04GmgzWsiqRuxJT9ubomK1lmemgwGl0kXLmEgv+eU2TG+5a5NRYC7JdySnCGApsqZnkV8juybSnbLfaw9YYDzfiolnEOdwcFa61gJPDj1ymsHVmVvz2RT8GcXSSLSeIj714DQolOknYnaR5ig0tSozeC9O2SjjOE7qaGeyNwlfPkdzA5pdR97U6uNFaGnEADM6D/dXra2ZQVH+qy5pVrRCJlaH8Y/U2AujklsJv9PHZW7p6I1/+JZ+Hrg+K+DD4R15BEoqhUTZH0oh/guKGPNB7HPAqNfp3/VDH/nHXQ9cPLxKJl36K54XuvXFLS64RE3+bRwFe129TRcPXToq6waLUPW76HjfKQz1WlFgKj9yK+wZ3gqtOFgzpFALH4+3nyZsWzb0jPc9Yk+ozbUKVAi5fb6bnYcjBu7UKnH2x4COyMcjdHBd1rt4Ta3EAVNkO9y/R1Guvu+n7r/knK/CVh8GiOlOtO+2W/HvyxezP9Y7k1SvtmpbQnMJwy/tIEYlSYD9u3BNRvnTOsrYV90ph3Ocdqe/5siCJPLM2auC3UqCEghIOQ1927KXRz9GjwdieT7p1/OGXnO3NcoRTVNtTPODJzkFVX7woCj9y6TaKGbcJSxTw5dx++UBtHG3uN2I8PsAL8fH9LKUWt0YKZF4jtbJ218wlaDmZb0Cx5IElUrx4zCj3nqLmdtoRq+FUbxezOBIZYZSWOtoUII/fEn4FlPRw/lppodv+RwcXxzgm2Mb+bybD6p4EeYedERkbrS4vGIRnEYgZRdLOOaU9itVQq+ULLm+SRqZaB0bmChYBmZwQWcCYl1LopYx8ZcReyiiZRsbEFf6IFBrSYGHikaLNZu4TEPJbWjkaBMymxdY8MibUB0RNAUDhaaYOkgrqrTn4RoXy/sLohQ6LxvFIi0Oj5BPC0COhY3SLCZPriGQCYd4TWzhsKAvUOdSodKIBYMHVqRZdGWZ8HSrL4s/zTIq2MIeVBUbT0ZHhktnOepGijRlzjUlM3vaae0xDZlDA+ZoQW3WU426XN953BaQXOuROW/YQ/w2f9LuW+OWSqo98FscAEWVpU+xgIMQIx43G+arZsP8iyxj9btR2JRD3vBaSxvCkjYYGnDItztNfDui3+RZswB9P4+tWRef+I/NCtf1W5WZg/uyVv+gooE/1nxSfXGeYQ0Vp/RfLiRPr65SouZ4qE0xzaxR88CGqi90qHMAd7Pao+t0HomSFpSc+GMeclXPQAUxtfImZjmiUmUatXV59qdK90YkL7Dm2eF24Vpae22kK32/euycQROzstxjeust29hQtzl0g8Kq+mZbOBUQi4wpt3GO1lEjqcVcpTvtCufZpg4O//lHVfIE2BvFvB5ocjKToWExS3N8drzvu972V+fuvfQr/x+5IC9gM9nfSN45OINZI796t1WJn6uPv/zqB5/yvXe/jpeu+XVuybee+Zq957zr4YupvT4Y3LHvf/3V5a/9mVs+czFGoT0Yqv0hlOq+Q+8ybV6x+ffDSiuGJnT/xYP1TS/YRhhcdYxfABS6oBiEfo0f6bIXMFLruZGPo4AWr8U6PSDhJm+Yu0uBaqfBrcqJCzZUruUcXMOaetN4IODY9mXCuafky3logzO3FIepVXJmvIA3wKsKomvLLX+VUHMAeznazpg8XAdV28/9VTWkRJHs4v9E5MPxEI6ZB+jBHUMr01vdu17eVT1j7/qAOYCHPOMqPVShuhK9EcvGgR7h3VlnCI/vikLTB49CMMvADelGYKmTu56BpT9DET//Y5ef85Q3zf93ZmrichfW3SsXar3yyirFR7Q0nEVyMXW14lanULEf3eU/WPhNRy7gyijgnuErdRy8dW1Oos3xoOmX65FF+tF6HcI2iGqADOWtt4N+Sdt03XnQm+ovJOTV5n5OIgTusYGjNnCXDQw84eKVuuKYTFkhDY2RlGOepZexHv6ANxq6W6xCY7Jp1DJBS4kSqTIzTwEaFsOU0oErpWgNseAe84aUulhEDTxeqFLc5O0nIEDKZ7SxNgw8BARnYUUKb0qI9RAUd9ixs9kN6I4S6nEFnBmVJHcUJFKNmIF2aOcKzLCsEvY8IAH80CR837ZKa04FhGaY4Octq3mn21JlDh7wdHD07V5PR0jfjuFtYN8yfjlmX4hf7rUvu/nlAXttheLnuFUCTLsZ4Tj73yo40/fsz+RN0zJdGZoVXRdzT6cmGpjoVMLwiarrQEtXC9E21iFt4dq4miVRwTzJSzIs96vYTnUsd9TW3WpboWfeu3hPBvhiRn28jeozdVjDteAfnSzIEVm9xlHlH4WGwhrb70rDXTCVLrZFHZKLhYrRsNBxRQ+4CV1O4+gZEzOhXZUBuY4Zeyw8Ry0p/z3Pj422hSrCOcPbPgXCYoQqttE7x+r8KVB5mq9iLJBScePPSZ55o1jIuTIaDdeTJg8OfyEkUCzLblBzHWakaha8XALuZ1csdufBmBE8zxg8tptq3VMb65LpT3mh3YxJp/RGoShEcm/KbljNIemya22eGIXiBvm5WrZusCsrQ0+FTdQ77KlaQwu1ucpX6lqIVHuTERNKTu1cW4u6sTrzzyrlRaW+dfGeFEHVyXsZpuAnQYKNxTAYKgb8b7VguY7zIqLML6pjlY1x8IFnfNX+q91Q0syv1v5/PV2kNs9QtuLB6zCRXZ3P7+llXdOqwqdA1fKG3FS8HNEXv2L124fg5EeCETu68ajtLYgtsj+fZhzLWZV39rfqzv5WfdL+lkuXVED9EVcDzZTOWvnJX+ATZ2P1L50dLvXZYM4E6zgzL+/a78evlP7sNfxehJ9L1vazodo1/qNIXPegD1qUuJWJYKoruRRtkXYhri6zFI+wqLlj7nELrPXsvWoCLK9jhJA9r/Nz3AJr7I7gfsMLVS21qiIQa0frqDo0SgHGqQHemhRAdvpVVtcMYFRDPYmg5yFIZhM6Aixd7UI5QQogSiSOvf1SA3F1TD2G6n1VvYGo1BuI8KqWZqE3ECHC6Q3gpeCRHdUb+Facox/yzEF63L/PnlLGyBBKn6X5aLx2SzqVfba05hRvZs3pM/8RFAg+H8sxajlFB547wqlN4eRiWVcBfuA1jhfPUlWWXcBOsTGAg58uoKNGTvgLfx/VqqzbFTgWqogNWWvvFnB+fmlYZCeLpync/0tKikW7CVb1DqPdLQneIoBAEyhyRh8+jzGDwZyTyv23anBA+xDB3UTZKEB9WD3ziqBmZc71/uDicoOFA4lub0jhhlqI3Gcv1Q6rtl/Ws7+TquqwzBP2fQqx2qLmcwG24349LBisL9RTLakN1ILqhvu6QsLK71yuiHUVd+W+mq7SHDw20iv04xZv38efet33vm3w2YuH2i8j6/xNfi/bGnJb9cb8Apdlr75FWiKF2d8jlxJ6gDR7AO9mJaQEqK1rts6tFh79J0CrBHiM/VD2BfkCeI0BgI/w8MB5/p5K7/ZWeocxBfxUYE3hZb3z/H1StfYJJezOvmjKjCCGk6Zq6/4B8UqwduqxSaRYGzqtA03uVpJXJ5NbleSsmkwldPH7wuxL5hRz4I3qVzga5YxMTYkFVTs5BYu/GVewwIGsdbnvFCyePalgcVElee9kcq2SHE5YiXINfJtX3rjI/hGNcZ4qArhakMlkUjgWeKS+80IKiprJ5LlMz7S2DqgGwzpAI3yhfhjyUI3cUKiZCzkNBNXjAPJP+iC4MwrCa7HeVXblVRcjZTQ8MZS+GbjQDXdiCQMsZtb8E4toYmS1xl1VIW49+5zaxc5+Fs/hvr+/4F++8oxz/unigdiQPeLOP62Hhtuym5DzCE4zJy3FBgoC4//DzdAiqngCqSt8K00Tpj0Rj5reaH837adX7WeDxvvWOG7fGo+hb5H1zZEAGxLSDjnfHHVkqwMLPGDBWD/BrytOfF33FJsc6WuR9Iq6UAkOoE+TmHoo8pxdxcpCLIbDCtXPwzxBZb67KXJlEV9YyxwMPKpuJigWrfgIbPkufvgorWJtkNNRNEHK3Pf4DXQPdB7+JLoSIg4tSEh9riG0oKZ5ROzyEFfyMu4FtFvt4vpPKl/jD5VwLkzMNaG2OHePDxTxRu4Zcy6dERdiPsUYe3dnZ0QhQS8bDHP+qerBkMfFp7jlVW6hyKuYHfQ0YUjekX2/+MGr7v7C//hbPgf7Dvn3i04PQeSa63zCuXwAlh++V84cNXXvbUfX960MPP7/W3iN5us0IkDzq/aftRLyLBJ9lmv2j+CUcwJPbEOBvBRCT8fTXR1G2+JkOImTIUEKFd42gYo+4HJlb6RB0yrOIbM0OjpVc4jvU9UoZTmyUgVrwUH/Q9mbrRtX+LZ0fs9gDm/DOjrTo18KppkDumPYSU2hal1WMxch+hUceUQVDSvlwidlMM3AGCpTdlitnoWIEgOJeg3GhxlzILhxkBGqz2BvRAsTuCQKbf9sHTC28sBo0YbOBhZ2vkE06bpr0rCcsdAW8eYYpuXqI6blODZS03IYa6qr0TcxSCxbNNE4TyqifQ9nGp4ectUnzc1FMDaHksKKsbnIGptD4cLS3KGK2Lh03cDiJndgXO0x+U5rfPMWRBUDdKEYoKtbXf06hU5XH1swba5uckDAqKFboNA+3CYpIPWzk32h4rC2rsoukbUaph5Cnem5d6m32ut9r1lBDXdob87sv6wm7JWuHSii7F8kAiNiFXZX4RQVo6479TxRXeaG6tU31TY3xLoo5MWFKCu3rBmBRKJTLltgmdp47IwlEz8RCcne+DUZo+wb6dJf051wIMpp4gmoVPNF5HiMw8vrtycpT20rN2tdF73CivO9igo5ehjhsQf9hcj8ajmsADocoBC7pexBAAeDOrI9UV4+kb3DvRDkZ/foQAWq5pw3tFjIzc4VE8sLmiNPOWbXSExL1dsQ0+dqsbNdM0ltrhDxxYw1/cHtTVW7fGYj74zRD5Edx5RRNEJBOoaAOHCrfjX/AMDUMsYm8jnc9FPj6XMYunkeksqxpYqCXESHWzcH16uVi1FHcNA6yDuprSmjzhC33yv64TRL8xXLwJkc280heY5mZMgF0k0YNEPTFhj9x3u6yI1ZKkVjsPokIxK9uIirfZeNlyWgRcdV6oJX9goHR3JBXj60qo64AlsCC3xgP8iz7gvzZakyj/QbZVOKjrnJm5mPoqsrX3SpIy1Bmdoz4+W82ILx7VIGUC0DYsuIz3I1as9gXMjnaEs+EwDiywLpASA9xGCXLwMBJOA+Z0+DdRRG7mNCb0bJv6/rXpUXwZhmTsep4u6N47l96xhabq1HW6RVetjekUa4k6nq8XqMqmO9aTtWj5DYYnm8luUjtpYa3gbVK8JTqr2DsiPDyQrR1wXaIjYVZ3UWrfQjPlTpKcKv6kSapwD0biu3Z0XWirrYRlrBdfcIoV6fS4blUc6xRZJoBcZltu3PtyN0TU4EKwi43ZtTj0MhhwrGzx38txNrx5Tb6Kfw3fHLKSQ8sbpspR1oXBGpKCBkQkQIZxy+gvuxU/ohMcUpdArMV5xKktm+nsbt28btM5ckZynRAsUm3NUi09LwFRzOOH2FEuBmEUm+WNIul3wa3iv55ikyRwlAMZjz2cVxyVjc6UotobQAgYTs0ObotPwUlafIlfpT6PSqqSt+38XvFCPRxs6JpRklqihM/RWANNGp+SkEDLbahtvsVRPCoBRUABjaWe0Kl6n91d7wq1rvkS7m1Q6dVOPRWB421/xH3PKUtue49cdo81zZ7/e4L6GMUeQa70YOca4Tig0jnehVxjCUMYzLci7ncszIVsvh9WGynK/bMV5RBmAHdo87aCesGu+kLda59QoGvsEwWDogs29ebddTT821oNtc3qqq1ojWa8XEAGwiqi4lf6HzUNR5Ka7aHenIhScYW1Lb0jTHdQM2a7Kwgero6bJt6hLelqg0ZrmANrZpAbzdwoj0qVX6wW6RHgmMJKdlcjqRrLAzPAglBwzzQcyPMJVFPNwr4yb+nIyisCRreOclXzocjWouRTSHoUgM7VxTxsBUU6khleJy7v8G2IGq3YJF8IZXAP42znEKNNfjVZ7XtEXnLzrv0gyqzOPKkKBlYqWoU13DM7N+V4m8W78xSCXJpxmax+n1YiV50fIWevlb2b55NPcqaTMuxG3ckb1RFvsVu6iDcchJUZ5RbN5eDdxiKc48IMFzjJMQAsFf4L+tkEvJ+oL1AnuDLRjJHjY5crNvfFFRNF4lFkHvxKKhcNwegE7soBVF7W20M58p9d7n8cW2coIyAHAQPM+jPaOjK+siddyl9DF2YA7wAioDYLMAWHXCUQ9xPZl2xQ6N0wbKPKCVPJZmzKIZcxStSRfxnNXtTkSzEwtxsZYv0FaUuJXIzo4tJZJvmTYHAAlNDpF81fQ5cFZlDuQ5FOHxhUHUHEMxZ/F1poKvUxF1Ziqizn0NEHUOiDo3hqhKS6qIql0IpR8jiDqriFoYDJ11GAqmsigxdAcVBkNX+oyU/EcWQ8HzLKDwheNjqA70Vlpdy7crQLcYzmYL7aRZi6Hbv2YYulLB0FmDoTuAoTsRt1PjtIGqHT+bz0kzdug5BvoHNcMdFj1XpCaUMVLTKmJWiVAqUVHS8BJLF6ZhaV4m5xPJ0/eYtf5FssfUK8hmp6lnRToyO7lYfFIIbcABO8MXRamvE56f/ToPLTCadoqKx7ybkduYbMyIW5L5fgdL2ZrQdgsWigD00c0gzHxFVUgk1MN2fB4L73xliVOA7FTxxk50dmd1SqIguwVvN3D2rn+RaBV60xyU4UT1ebpNUzidC0FpXXvL07ZR3XXDs37exOOFeaqG1RvHOZRssj+Hik0h852Lke11VVwrB2z5TOmWeWZDmJ8iqwgk81lp0cyoEBf+WkaFuFXdJ4B9Dt47+afSvjZ1RIg7p9XlbXSpQlGoY4W4neMLcbH5Y+ebTojbpvamQtwOC3HbKWVut1YKb4c0qx/q+cFgQNm42+oj2LpVNom790KKO9nrGshuVsbzBS/vJOCRjcBjDvCo+tLJLDyy48Mjo+zk4ZExPOYqMuQOWbYmOTpEo9oTImXAL6UASsxgETdHQT2FG0GxGAdBjOJZ5SwAgRFkYjauAtJHDLj2vxng2hXAeVoJZdXTgPaRqRC0DVXjuYOCcQV4RPykOXsa4E2eBniU4Rxi/DSAwQG4XNkbadDUoWvxFIPW5JBH/TikwJ2ptSmqHKll5FcOSTF/q5iTUcc2vj3Z+Iza3Pj2psdrm6FaDX0bMJ0UgleqSRu97kbVHpk450VCNKC6jc84vun6QNEQNty4wKvBLZW6XBftVzE8TCHUQPcr/ZabWCqKx40mpdMvLphAtkt9liF3j9NmKD6w38Wfo/FtZ5mtirrl3Rluz0Df8E+r2HNpD+eB8xQ67QtlA0bbjEDrxbItrHprvDf0osqBuK9f6DFMdaith/4issdpVXIf60HGxJmd9yjO7MLJM7uwMktDO0vD489SbuzJn9mFcmZH0VRyH5M/Qu6jSXIfqs/NTci9XzmW1kyO3J8YHlEVHnruFFXgEVl4RMeHR0TRycMjwiWAER+2QZXcTz1B9FM9WauoKfzyxcMXjKiF/OtmaiFIOaFaCDKdvFrIv56kWsjNvteYVKzReZAU1uocTwf17iQSenuQZkxPxciREC6E41wNVhT5rzxXC6rnanV3rpZQiO7F5SVqV1nEle035eYNvRejFpdC5c99ONkTZTZfDiQLPXa0TlwbYoKVImSQRygPpJnjMrTcKpJOOSB7vhjk2NzmnzO8hUNqcx4Y6nlgJKgcubNSdxZYsfl32FP/vb7x5RKIn019yUXVAQ2sVV0wqh5SRdTtGS+oklcxhzznR1AVt13+iuW5EI+R+zZB+k3SNWPzSHU75TzQio6gZiUVuojVsYj0I0EAZj6YQlOLYJqmEZoeoqfegcJj9v6RU1LsFWNQjngq5YgdJf03oRzTtR+iR6H9AEuOFu3j42o/RNO0H2JMh5PTfqjSrhekf92MG2qh99oxG71R1YvT/WM+mT7tfDJpkkye+xA0e9y4L3ms/y2WPKuvJXtsqnYp2mWGvK41PThW0+ddTQ+6mr4kNWGScL9xKw6b3l3aLD1rTfKm3A/HASv2yC2q41HZjsxQAJ0CI7xJTg/o/IAQMpqYmYb1Xg048l3+Yb/IVISQUbpm0hJ4PBAF/D4aiy3ow0KPZ2kG4jQelJnSBDiJLfMGtXGs3cGM7Iwfhc2gW55pdruvp7hB3qxCTTtbgS9lKnZppkrLWxiDDkVT9JnnxKp2RHiSeWbmKcODm1PPRR3VvfEsLsAkeQKg4UJZnoIBVNCxpQ3uGSTq6HQDj3lIoK4SLawEJDtRb8nO1nsqsdTBNSkIf7iGFFVTyjF47IdjW0rVSi5qtMXy31W9fLZUEQAQG1yKyBlFcgRX665tAPcs1eXzK4s6PKzPI0LLqLYNLc8XAEA4mAL46DECq/lvCKzmvwOwFimGuWESoC1QRmDGs1+FFZ3sKzoJHA+/SLNHigVaKGP4qH12vdxY0ey+//IPD35k+4t/wuMmzwO4mHP3+6XY0BkygjRToOy2ZdxXd4Yv4k6aH5QxNH9kHUATqRjNjm44glrt6qczryfevu72X6CEOFF1pKbBB7R/gWb7XvZVdIzrRh5+FfM5svvH8q8+DKzPeIj+yu3HmXFPDKLXr62z7zxLakN3Qyicto1R7/4efEQzQ3XFNTwCxGPIXOOaUlRqgFA0RRenSKcVIWjRMjJE6RxTI7TM3JFP844hMzNGqngA8sQ5lTSy0C9Hx/1LVcuC/5bFlk4X5ThXOnO0BL81ciKyKPDfssZCZj8PkZf/elxBN1+lkL/0aVVatZVWqNdPRGCM0vLtXBtBMi0r/TZahX+SItT7leHhkCPxQvxyUF/0UPyBQF/ktPzegLZqBXD8kOdGk387mNBVWpWjyZzruzdwzm/GHScomvc9FQBfI70gaudciEicwVT3qAs3ByHNym1Pwa0uB7XvW/G2P9/GH27njpP0CN6ktq89yk75RBOdAtQeeb+I0H6i7UDX7ebwnDq0LKOyvQIwV4EUvwq8QUgPi8eLXUKxS7SgEEvE69yCQqzDeKJ+efgxQxm+y3RbL5W3YEalsHr426rbSvC2VOygHcN1ORTb6kjtKXohustHFXlb5MZAVNIOcGHtNk6hcfXwSHEqnTrMT3Pf7qCu4FlL1tpi+xrtpNNoB3JnR4pdtItpwumjWixcIol6AWc+lTOUJItOp9PLlyt76/jcfElHh04EaE0ryRZih4vmxqyCOK8KLE6pJJxijsmchkOT6tJe8csbyiGNlrjKXdmOglsgzjtkj7CjoqeoNWBfqAU1oN8onxf6XYKIHAUVJ1GCHjl1LUN3FvS7gf0N5l+UNhDmCPBRgr5EqhcURCKoTos0fYHS/gvXijOoi+7xmeGZ2G49C3zcZS/Jz1IL82dzavdAvoVmYWQ/hKudc8TYQP4ELLKc+io+nAASZDK0CcrarbMty5+o0yl/EsVUkImuFTlmnm9nXvFkzD3uwhRFnXMxEzmJEDiGAL49igC+ust95f5p+QOb+bAHEsowOwu0+In0RKjrPIWeRE9C4Dw6m5fVM3minMMU+An5vNJbAZizEJDitFFZPj6MFuK0aonBKma0urzJZeZvR6wGmVTpMBKG8V6dtB0mVXNMgGdE7JlByID5Q9u0TCUnKPS8khiQIS60qvXQdkQ41z6oE188hYgDNvNktlW0B3eOCGOp7ZG6t7r+aNXajq913bQVCMVzDY9t1AYytfsQf8iEaRt3JbT47waabVprTlIh9AsMsd5aEuk8548Jr1KmVkp5dRUg01lCZwkPom0gM6y4pr7I1MeSzE0GQwT/TznZHuMr7S+gtEJtRUZdmZ4si+aT7AqFlhj/UTltc+sSPVmaPN5rrBzbgc70xDyHjIy2o6lqGk8bBy6kbNsSZgAHfdM8z/g/Aznk58BTnmIrQMcfKYCeTKvGN6qdFvyxvJ9L56IpaB5apaDbblbWFdXmG1tYt6LJba7rAU/bcMy04S5tA25lSpc4I3BK1kmM6pJFukWwC4vUwaNDc3jMKQ8xTx7WZDaCJSI5uVbL1LBUil1msIivDVrOV8GTTpATAGo6RVLGQ0ifCSjDkSuzUSExbYyo4lvIwe2yLLRp1aQz8S2pTQZYKtgAFmL+b1UYIFhaIFHJ4UA3X7GUhlbyJS4rLFZQlHJLWtWqYptUSVLlebRqkYf1C5Bf66VwDItCeopkzZBVk7MyOVOGDhhB8NjHTeOecK1bBdFoabwhoWnI6nEa0n/h49GWVYDJtWUF5Cd05AeS0ZOET9s0K3n8QaS1k9ZuJ5ab61UitPUkiNA25RUxNfx8K9dE0k91PTlWl875nD/JV8QwTLgp1dlWoTp0AqoDMjNGeZTqrCAO+LtCC5X2dZH9/ypCpOy7kJo85IfPowiHeORZ7cpV8hgNN6UljnIgkJa0oSCaHSEQZPJlllSdq6QKNGsm365kgZgHlA0c4y887EBjlKvIz5MA5TmeXFV+vgQyhuOMkCWGGuWi3Goxfw+dpwNdnCfxEnkB5RrJJT2F/3sykvbQ+Sbn+Xi9gGPllQsHm4mVCPNxu3K/FHN26a5yfhk/bf/OE4AAattVlvAUbSaKJW5AUtgOaA22nHO1ezojtcs2AwdHN3xulunkOPFMS6VufDJK1RR/deeNTR+PR+jYktUxuqGEAYjtKzIRT5cnUZPLqeehEggtkMxs2Hqc2eBmwhPHZoJDdhrfyHLcVsn5ZIa8zpEn2jmyTeeANo/MXNh6nLmg8yClSHYD6mVZd7b6chgvGTSzIYJrXGp8hDXUeFvwsn7wkrxHKXXNSpj7KFS3ISI0WbGsFMFSEaaE3dEf9St7/WP2hYAN9mU3Rt5/lCt4xNCIIWRxPiQFTwQ6CCi4KZ8uIvCnyRkon5JzVhYtgvKqLOkphcX2cUmFQ1PFONsAW/J0lJusLCVyC+5E+yYLR6UnX/r2nHSa2+NTeyCZYt4+zn15DDNaC2BoVIGgE86N8GaNssUfFxJb1cu4L4Yo9GWAFzIvh/GSmZeDeFGrbDz7tlHvWXmIuYjtQWiOsY2FoGIVj0sK2OqZROs8BxfLpADCDV2Op+D+k/Oce5vrZp6X9BTPAkSAKcE/gyIobVdTg/b0ZVWWNdouS1pFDKReRHVHZ6C8A/Ovqvm/o8IflLsSgNmYjeRP0os879rS+lJIwR3ihW8wpAgipSvuGIpjBa/gRHdQO8yuFwHyu3H92HslYPN5X4+ZG2tUZ9kLopgG8Fts3u7HW9GonFuu60lCnepOSN4r8LXir3x2n4/fAZd+QKw5+jAzvCZ3N2vfhE+ormbj3gvjxBLz3b09vj3axhEx53b27dP0XwM/cM4s7nK2Ea2W5qetLwvAJXs1etr2xOAjHO1afxdy57h2enDIxxEcB3k4H1S6qy/340UVFXAIF+lF8UgtQLtzODSxy5oCt2MIIL2H8aFbzEsN+Q/oVdmbOQ5NIPTtZn8NDi7QaDUWdKef3YCWOiP0N+KV6X7ZXLQDzzD7F8jgtT0iwccJAvkwb8LF/isSCy3j11AFPvyEp/7xamqCS4yd8csPId1V+RpUiTTnE8TVpy0IebImpX8Qo4jy16W+Ie3FuXKsQ60jf2BjOMQNm9taBzZEv1VH6BrnbWRyrPT1teaUgwfZIDwsP11LgWjRFjEeVwyLOpCdg88bDvAZgldzMJTmGoOQFFdU1uqlC5NhRT2tDA8uYkukq7ZNr0MjTPgQwn2PHakF1004U3GeS16vn4jjBtVgUT8IeaD32MOKfxTMWfi1xYcH4KT4OemxRig+d5xx4we8yh1q2In5vKcn1/cOy5Pro3cgaLzp9MVm1OGBRG1iKXSgqWoatBI+qmEchN9cBoN7NDjiS+dY5av7K+EHNQyDaLfbILfmSBm818UekthbNE0d78jJu3Yt1W4+4Lop7boP75JNk7Soz1e+OLw+8kVwaH0TUKC5rjT5zM3p+z07pxnm95kXHstyTt+rcSCO3sSBYcEWuv6MM6B+mO8EPH4Xzw1PicC9nhKBCiW6y6uSooFXpUWHveMTo1tgc1A6u7l52JcbE7AvNM/nGVtbv3px7qzWqo1brmG0Z3m9NMyVxwBSXWzqU6y+e4o6KwBdjuh9b/rbXxz8868Pnv69F9aeTcHmywD7c0QyLInBpPvvehxzkQT/DME9EjyG4LkI4hgIVsQQ/Dxid0lwA8GdErwXQUJQzZKtSvAefNZVMpnHWmPmPl1wNbZcjYn7FHxuwAgh9guyN2B254naq0VxTG7yOh4vzxvVpZRJfeKWUn6D9YHGEVwVolh9qALASCp8t67W18k3rlar62qs62pwNuOU0uUqjTUYwTwOvBmqZs4Zfu19w/diLfWxiPoVj2aKSA/6ItvBF0rgFGxKSrTz6NaGh4I/72VvRM+N0WL93mzUkf5dhS4kxsYjrOGXFzE+mRiKFpyQoh3+qXLiPrA+QdGOvv14FO2YphLC91bCD2gYlOOjGpRZ8hOTFO2gxOlXt1TCd2oYM/hjKAFBbo3EKnFzwQ0J3q0RVYqGrln6NHDdVEqLd8mmSVrU7ZUvjo5+EWzI+3SKdqcrDZ/9x6JowgYCsysqfI7KwXjnOF2LHV2rA1Sx0rW60jVQtRMQMcwhhcaz/8+jZzcJPYvJGNJ8HvS8FIHggxkBIXFFXSlekZASuyPg/Clh+/yxoQ9vQkkV0jJKVjCfp5KVHzw+WVF3v4+RrBz62XL23P9TE2Rl487jkZW7NVWtqlfC9yOs0/f9ZTA4+NOTZOXByleHNV3CAw0DcT56pyMgEqvckQveJcGjGlElK+iaJRK3IFwhKzfhXbNpkhR1c+WLjdEvgrvkfTpZGbjS8Nk3yMo3yMrmZOWHppAVQSAE3oHAyZKVw8cnK5jP08jKDz9asnJLzAKGqPRXOU5SrjVT7Y5y4hy8jYPZm1Hfik4PSXTT4+WV2fHSyclx9cjcKPyx2RFeWPufDvGfV8X7S6pov+f4WL+X2wOLteIV8vCrBWZ7eF6h2ToddiuyPQGFAiK1NfXOaQVH1es/vaFB4yJ2bjhhihiFms/dpI2NoOCPkIfUR9Med4uliK35oovIBaGd2lU03CtY9gSG1bdL6O+Bb5cbP1AwuorQQ4i8RIIZh/YhhFboZEHfMVlG8Tsps7dcwWFZcI1i7VCQ3Sz4XO/z54cx3nmM4EEJJggekmADXdudN81GwK+K0/DWFAOY2AI0ruzpXqC5+V4g3nwvACy+qvCNIa8Qo3oLWoC3F+LnKlHGjFXItimZQTHXZj9qpljA307w8e5C9U9Eo2as73VOlyrzExTIc459AxFF+JtS2oFv/ZPYwFEOCFNsqN/t8uRCAn3eq+nBPXiOCCRsCffbwIPm00P49JbAOfeV2Pd7WtF78FRvwfgMK4SbcIdHVpqDIyvN1cefci+3JAAywd2WCMRCnJUIxEoElEirNQl+7nIzJwLNdoJFmpQrrmrbM4VVS3uWjDuGQqFkhkanhditM5UCSu+RhFvwm/3YGMlVs2tqe1m/LkvaJVT3CvKV4BobaxME9yyFUKRoZSJv8Uq48WbHq1ot0AzvqWbYGMmgDbD+jtGP0pnS3b6P+/7jBiH1Jtyn1J5kdsvr+AlxMJovTmu7RTSkcL2Iy3uG/PZWLEeDon6ltay/nt2KOy23Z7fjMSwSjoyHlKxTvWLtdQAJSY1n7dnftPq5vzhvhV3clDMY0c6Do/vmoYAVrM/zAfdIvaegNSGZusPJumO5hknxeN0h6g5t3Rdz813d9c3r7vtK/Nz11d/2YzVfqLYT/L3OE0R2KwBYBMS3rDzQm6wIQaoi3FbVW3as0r+L4cMP2vfQT3/h95/zPZczrW8gUbI2kdSFKyDQQMj/QRSR3MLSUq4PpVVmJCV8GaU35GKuMkZZQE4xaDY3ueCVvU2XFtBQHIZBRx3N2M3V2yJDTLY6WrOe3QZIv/UhJsvsrZ/475Je0cL8alH9W3CRO6YI49PC0VqWvQlmIIFl6rya/OwHESMuQj8X+JGT6R7j+06JswL5Jc4Lelwabgzh2AVvKSWGjdhp7gegAaRhrtgRAvHzCYc91amfUQJDTvxJS0NCHUCYEszdkBKQgQbxZ5Bfx9lv3mjs0lflf2pa85u++tXrvqquMx6yq0mT/AO4gjGyqmS3ATlW0KB74e1lxE5AW522yS0Ah5dwZYGfDPfSYJ+2M8Qzu6PIeH4hpXtHEcPC4EAMYhBHDyjlkSvPuGKOqdjROULtda4uJv5jTMjeKjNeziYOBsqmUyz1ugsZUiB+9vBlcLNqS9fXzbEW8LqmaKLOQioUKeFBPZmZ80/fmDmPaOb8n3lOeXMURXrN8ZX/5pM+KSd9WE762uSEt7M9b+mUzkPtez6jwMg7lChvkUwVCNRIKUkLbapn/wy8tgSBe5KgJ4G5fZmIPx9Fkw41D9CMQtif2DZTIHoFvlIbmaEAe0aZxADs7oKxSrbrAHtdrPYBGrilZULwx4IX4//FzdYT0KY5go3YFohSq0KU5i1RWgBRahmiNA+ihLtftGCI0gs3IUpz40TpwRGi1DREqTVBlK6WUh1REnA5utQq/Ui0jB+JR0GXfvDQI6JL36BLP+jBk9HjTZXIh8IYIHOj7EeofqI9XKIbuPQPw1BJztc9wQkNwWk9OoITKsH5U/SaUgFXCnAJyRFSU+VdAse74OJop+RZ/AMKv7rCT0lGpsSqVnhiw894hzppwjHLDcwmuZk5Szjmq9zMHAiHOMCfPwHhmB0nHH/22irh8B03cwLCETwabuYfGNFfwam73LZeJMk01XuVatHUCE9k9CAB09dDngncYgLYc4uo+loSOfiNnpb8oHnerclwlDkqU98wGR6wBR0zAQwOfKZKUz1p6jOu568ylg9gnb4nQMpNmqKNikzgwdAE7udA+gXfCye9ChhVkLe9dpqbu1BgOeJNL3Te9MJJb3ouXVLBODyCCsB9dNbgLRCZ1bFcRDyC+ipulGAc3R7y+koIMTUgWWcxqPze5+H3eWv7jdPEsOIxz4fHvK54hbEe8xRtYjxKj3nxhMc87lD2B+oxT30aIjt2ptyiEY951f3mV3wx79G4dmRdestrR9elVmVdKoVwRb0UwmGFUhlyZZGqywqG7xqlDM8uUEUD1xL5mcp6tPlSFZqlqm7WlXrF4ge243XMTV2IdPa38jYCSdEQYwoJmS+x2GCRS9wi54JcRIIGp+XqNpSWooVtyFhhAItzJGU6JZWFEDYHE7uMoYN4tKnFj8kFLaSwsqB92fPBrxqkJ7d2JBjhVZV833nH6CHT7XhXubcmybx8O4JpH4mo7R2oA0JKicgb1lNeQ+2rAF3It/x1RM3/1lPFhUSvcIZr4AvB5QXGOGRDziqAU76qWsnted3lYsHBgQVCXcFGLkPEoR7AzpZwsluU4Dt/DX8YxXqYqPZlKutn8ziO+lImFvDJh2eXmozJEDKJw8bsmHGS1tzlw/ayhhglZKroGtqsrKH4nlqyhi5oCOcvclm+hpnbxyCiBrHGkP2BbNM7ME5Wl8/6ZC/nn7hULucIpwNcwCu0rslxobrvI1/rifmRsB8IqSkD4oFJCqgukkuz+iYG9lBs4+8AiXCvee42TzLPbMzYXV9cccY576HEaEUd5lsR0vrroGYBPzBr1Wl+MctAmFW7FXXxo2lVh9V1c0AzEku+2K1oCphT1EUzHIPHfrG7OoMFUyu1xfIfG4Foo1xOqWjLcOtl2qFReSRtdS0MxNF/IIVcWQSwMTuLCC2p2sKa9ABnGiCVLeE2YK0v+98AZNXVNMFZMkz53SGcxUB2GldTSxbyCwThPPAISEXsFY4IIZ3BXlm7D4Y+eH2cUjnbLXiGyuYBFVHcPZ4WitiWNUCRvQ9tcxYvfEdkA0d6RfP4SjEFZj1QlTRW3WgFFCK9YnkjqFreCHR96zJ5Fd0mUIdRyxpchOOGuMx1NSrkT7Wq0Un1xGhqIgxqickN42dGTQJ5JURa2fuFtdLOwDas5gN9mw6J0EEiokh6yvBwEAiPKIROAIEqDLDMBmpT6rEAIg9A1V/ieRVnPKGz/KGuF5k1Iu/FuEhPHhw6wzZXF+0FdeCGKzFFSIkpsG+NJwd/BLoEavpHQgpCR03f7nv+NHeKVLP+Qj18B685Gnvj1NgHa9NiPz819t6psZ+YGnv31NiLpkXudpG3OZZsp262xenmrupm2wxiJXm1muyMwXFqeiEDyVovG/EEmf04qtIETVXDMN5+4wwyPdvzRj+t6aeGH/OQu/Yocz9Pm2Wd8SobCFFNIDoQpVdzCF/UxF1VruKT9815YL4gXa7ViW96g4eSS1fIgXKs4Cml5ADN8LMjVg9e+VBgYjZUeJjvSmfGgbyiE9ygAHOj6swYL1xJOOrM+CKGBW8PjFNfPt78kroE1aNAPf7gVrxdiICPSjZzXbz+2kfuuvj/Qe3OaB06hNVBPsYLGqvO3Dz++R59yfCSmZcuXrrycnaNsImgZwkN+D/PLfKXkgCW4KYo0wN2ah0NodI6moZFEtAXCg0Bg5f9jIwVtq93ivlITHBs73xsaHWq++higu0fHKvx82P8rCOdn4h/Dz8biuA4BwnWAJ+mzr0mOtIUNMXYYoFL7ZJrHA1hEyY0w6cy6eKxJGA7SlN8hJYMo1+CN4LOnWDQOzypP/sLd6VgJC37WSVCMlSFicYQA9k4aAjQ3qKFx76ira2WMooZeH/UT4qIZvAZrLa4ruQpcbxcg+Jn7omz/giuhiCZlOYyvPXENBVuxwOzDv8v1KSgp/wSYKSlAOQN7dA7ZAa3AIIWtW2n9+VtaW7eQsNb9Eiae/HXpLnJZs1NjcBEIXvW1wFk68eD7Fl5W5r79QPZeFPIUg0qBX2hq9nbMFfQtqv09swLuQU+REAJLjjB+yl5KJKZDS1QnRb4qs5Tquddp4nvNFpg2ah7aEf1nXvoKbFYJ3RRnKmpG+g7Rcsr/c2p/I3C9D6vsvrf740u/0KBHEvxKyqpAT2aGnt0aux7psbeOYWFAmCnxd43Nfae2tSWTY09OrWEc6dl3TWRszocgJSD8zCKA96Gx3JC4V07dWHAuonVMfs5WYChc4jIEJGZRuah6sFcPlXtKBKn5wHhuZsCLDU11azD8pKIw3cNd6HkI8pgaoRbPLUZuamYwqojxiyvicQ0cMvjUpbCwNyyuohoGldITTWTKCQEj/bz8xRT83vanjGca40mNvMZason6rZL744cyH5eqb+rVDYKYiudW8IcrBpJp7TvfV+eWhmaaXdhRHdNXS+aaC523NabpnQQzFry3JeI6HtGrC9QDIDPUM0cNuA3u8tcFVRDwlL+RVMnui/sirTVufNqUWsobaGm2dy3eWPWuYM3r3bBsMsp4ONMnmFbXDV5hpI2MXkG+ugKwiAkAKd69XTjKGM2o+bg1LC7Ay7SNKVCQIL0Q15o/YooM0u+MFyowAvMuydWmSHeFZvNuvjHQiYhvfwevcp7NX+hnlV9vbLqO2ZTdrGe3I/WCqSkuvAodVIR6PMRTRF6q9VTBGXjUPhqYxHSlYosXPDj7rlXj3vA0VQ99/7Sa4/vufdjgZ+xmpYSzWOeSg8+5gnHiuAG1qaaKIHF+8Xwd9+jOnaoOY8tY2HeQBuQJBgsZ39q+ECXOS2P2py1mAE/Z9BPvD57omYVq3A8cPYo3afQChz/SiXlDNqWYRGNK5a2esbNqI3HLM6412R2AhjCacu6O0f8ZEFLtTX5PEn00dHq8gVET7SiWNToj40WUixl7xK6t0wLZMMcokUTXqL5MrxIoQj9Z/Ex5+Fvjgxo8YiIrXUQqUMN2IVKjHFRRaQWIluUIos1j2XY2fT1QQSLzjEmxbRTk4qlc7y1wLf/gpJqoHnF9KLMljxWCk3+kVvV1nigE7nqH2DUwZeTawWGfQ5cnJyUWOZZyXWs6F4XdFPvyDFPHuc7uVYS9arb4dS1syU2iGKZj4kwUWiu8XTUUOsIYjq/UCMckE1C9ghsiq4sZno5J1NbuKY2zbDYSI28aJ1xCrEpqK0er7RcxzEIgH5KntlMVFfUT3peOLmlcs6wE+1ZgJkDoainvuThBsC3gjBJlEUpe7ducxFbdTTN3+eR3dlF2O6p6XylHLKB85PzNb/s1YyBfGzEWrqvTOThdple9h5lr8iv2sz/RUT+W1Gt956Aat3MwK1an8fWeFgE4sR+cEceomQ3UBAIInrUB8+VCrJgHdBYP0K1daH1o8aGaxVte+QbDNddTIDPOebIULf+z4FcYlNvAhvSJz0sQTwIoiT6kGPAwxoBjmZfXktfgNKm3gHyDRqpSUIArZzMvyxoAkECIkOpRRg/vPh4gWAxKaUi6VOlFiOEVrxjYn7tNfs5lxVWoZWa1HLCL/62w7LB65lXz76qZ1c/7Xv1k/MyIZ7ZnZeJsOJlwqv4mfDG/UzIDQP1M4H+uIkRoYaAYkUnjIs5R4lQq6s6lhkT2hkTUmxmDJJBMHx80VKfE1JoXVBPZ49PoZYeA6SRzh55hHhImpk9SvTqMqEmp9HJg+oboOqr2NTQR+YETYJifeKwvsK14WFxP0mL2uj3179av0cGlZ89Qtnsv861PLM3iiA6479Qws4iynzl2Fb12hsXBIfnCUBwx9U4KDo0D/dNQz2ahmAe3Hz2CTGiniLJuUYiD8ICY02jaGV/iEwUCxN6FbcX2aPsk4jNWyl0Tu5sijvX0LixPH3vkJrrXKenNyLa5OGyyQweVxWd/UUGRnzWnWIKrt0U8bUPLkZuVnpy/thYh8YMt/7lkDhw89fVaV8X9tuh3vOsYgEABIuTz9B83qFZuNqkDkQaxncJTOirYehEfLWCi1h0N+NXaZ6yNbRqRm0Vw/k9f8MBoZaJCjtxvnwIVDOT4EEEWwjqwUXIwZqucnOUZB8YOebLl8zdkaiY0Z5ydf3Wi2j2uQacFsgRzVUUCKtO4+dK/QZywat669hkHvIGtq6n8UHQktaVm7rg3LxmhCq0pNpAHRUEJdTA9wc97MYE5k2Mc+Y8zHP81dr3ee7lAQkeRvCFDgxXSfABC4ZEJQ61Pr/obMg+KMzfjKoWJK6Q0BVdzf4hyd7B4U0AxgdiBaCrthUtTKiDF0bqenYUuRVtMFXvD9maKQ92na2lXVN0eTDeef1Ihi9xhi3kErqiPxaKzlxYOsjpipvYXT6avazuGroGtTqMWG7ZH/WJMyNoNxqniGfR0OEfebJR8PMZEA4R0HV09yf9xO/h+fV9t8xqTcM8Ik4XfpGf4nsapTLLuSgsJ/xrckxsWM4YjkFQH1jORYp7RQe1KiAyftz+ueuP3v26L7/1VUCNEjwHI9hNn9GKCp8w6NmHBcaKuosGlVf0tKHLM3zDmdMRm1TDvEeJSCpWKYFAZatoZ4g5Pk92RYtM6sCaxLKxqiP2PRIbInYeseq0nwNCOLBnkuhiOzeJTXRDDoStUSyR8xxT0FoB3LDHrl/hjbcKRbj2W+bXyEJ8hrbbjR4TDRNUcNMybck+Ir2N4bTlznnAKhZPLbfMi5JbJkiRAplPDzJORsiY3KspWbItPPkGdR6HBm2zDUJIGxRog+q2QZ1HBqa6a1Xn0bZqq20VQiOtmq+AaeZkGhQ72MSbN2jGNWim0qAUrtm1JQhVzpY6VR+iSdVrc8sFIxdswPB7aba/4haVFaV6hail6D59iM1bg98zvA/yBkW0dCu2snMU6Po0gI9iTA2ZybwM9UMr1e/Sotn005wsp7VyXNwc4g9Ux1ehgR7obNHJVMRjyQGlCrAiJA9QzH4VQLtjmH3UyA5SkjuxQ8LKO7iD9zsmaQ6CzHuCXI2QBXlONaX11M1+DTmqLh+pRzl0WW6lJZqr0EgkzdHSEReD6pyzxiH/V0RgMKCsNxhwxyEZErU6xOL+bMI0rcU01HgI1sUNqrzgBdqCdm6w9C4jYF2gUCm2iKDiY8jyLOjxrFJGZqjs3u+nosgwX6/wSg2xqHK/sGzzRKCWfVAVn9VwWh7pzcsidvdksXt73lR5dd1c9cZzj16ovcsz70dt4JgN3OtutcqV0PfLkz/x9XnQXJ990Bu7PvuAyXinb0o6ZAO34NONikptYFVqD4W4hh86lVrTqsgE7rKBAQJhxRtoxHcr7fvBveSCV/bcQvoQtvXa48QUlOH1wtou9YFHIpyv3mlP7J12vbjN3pTJ00N0oCqCAJXf97L3mWyDaC03UqFzzY6zvP18ZnCJ2nrak0d47M31dvhHI/D3Wt1btRyAqBJ7exn7DherByAQTI3H9A+Ga9mtuiuJzbVWbdPlsiPQb759REU7YOxbK1n9kIz20ZH0WBjMAlEnBXGltDU00tbISVtjI22ty84v6XuUiLS1ITL/vIkakOQkrdBOHJO2zmCt7kyTtsZUV2lrSC1xhR+NSVvD6dJWKOetaWI+p46vCf6vwM7jMUezlFWlrQmEsghIFiVm9oqK0aGKFJ/mVPthBkg2278pMrYrfl2/ELdEuiOdEyI7T/w8OtpQeJcaElJAfjvjKQP+ncXLInw5gVLpqYnwJ1IoS2Ynej8qKUIOgLazaY5ZrAxzSCrmUHYGCM7xj3X9EuIkIoO3m4wa5o62Eso2ItvUQpaWdbOejksV09+xbkZFoKq0HS/i0m/S5ShyBRO5Nnc/OvWDk3JFig/DsQ9Pwi3pX01V7tfKpFDo2P4GSoWyudXN/kJp6DLZa2tb1wtqA7xDpbMCjRCd4xDkpAGKDotwtHBoNZ+o+HiseI9gUDICECMKTS1+C/0L81DUFACw2AIsoFhBVsRjlUcQT5+4AdFoA4oI+o1gtziAisahOyqMXkojcy7gyTPA05Gm3fuLhs1M3GYrMnTMwFsfCgDMpurvdMWGxoEi7RPHWVlBf+cauZeLoFoQZ18y27YYUwQHBbkqQMNW90Yeltxa9mZUD0oGKTw1N5weBK7gZ0dwY+wCZ2q4Ce6Af3SSiOihY+VnmdQF72izWtdcHyc8nXwh2GubMo+79t5LuAm0wE2aQ3twlgA9Y0zcELPWnFfaOluosyUVMkGB36J5AGWecDTjxBYddchXyNlu0VbhBT+02SK9yUOpKazWgcLbdhgbVfXxXdSgFJfCGtTBfR+snCCgDahfRKqFni/y61D1yRcgNpJjRhAalX5o5oQfmdEmXxHFSvHlhJ/dEHwUPKzC7XLjOpf1st902pa7OaV1gH0GQEK4pBpzUhrFQIVM/cPmnvrvE4qZCTKA1upoLAjq5y2M/AyGxHGDy8EEuwbnfT2agWRp2civGnvhO7oF31FVj54KTOVtKlgzY7BmWIFyWDm/CQ3Mwda3aAGkd7mSvGxHN8bouu5ww2f7il/F3P58XoBBsSC33M/TfupBZsZ1LljcAp3nwa8OOs2PIBa83mN5WEAy4xgaMKsNSFVbsKmCyaZcF3BsCIO0iKz/bB2CMf+6IcVj/nUdLIzIIhzmM1UIFaHxrztjSg7H/esGJ+lZN3SedUMKj+tZN3SObEt3ukZ7ezNvuqF0N2BKW5WtGme6M+pMt1im5UHFoe6MONSdGXeoy/2nGfBveWgc2jb1QKtNDdnNqJo0qMQBwX6VVWmepstzGHnUnMdINhXmlBOnbpa3rqBFplrRlmqq5jR6tlZGYLuyRRqmURK0FSeql12s4CIJmpeg3mm5HuRcPWpWspSwpSmAVrdlKKRYZfwzM2CVrezsz+fEX0fBYmlWdqEeEJ+dO+KR6I03YPE1XPlWDujsSMgXFx/XFIL9yFww4vNcwBzMKJXQvPqezFQnxvgHEfSfZ2iJp/58puVVPeg6hA4pAyM6Iyp1RzCYbaW2C7y08CjPDCgaOHvZFN46pAXl1UCrM52VGdozj8c8NWFEvqkeHykh0Vidw2OOfCj6+JTiLbWTdrWyJiTC8O674e7ffNHu/36fru+GymyjOi0P8+0l5t510VDD2rKCJyUpsRFdpJxCJ9PLC2pCRrGDM7zyWeKG5lWXVrwkwg0jtGGUREFlHrIF9c+SkbERfkn2W8q4gZlJeE0sfIZQpYkBct3o6fhzJ5XIreL9inwWj2/P56SkvKlDpQ4h+HcHOs6rL+0QkX0sdgDm0I+2sMZwYKeUsZ+A1IZCIGlmWI5DsYBxmWb+rNWTzEMGkbl/j8raunw3q9+gNKd8NA9yTC2MUksdHoi2yDJqXHY3gPJoBLdURcvXLdeoFGOWmvC3VLbMpnKvepAQccfQTkEkYCO1Ntalzdgp3kahUeKAkAoiqBlBbG6gD+wzje6olibayRRXvgalQn4l6yllmjMTsFIuKjj8amBazFxZtHp5huKJA6HjO16ua2Cqn8rhxAF4WYQ3H+CG7qCdEGlI7DgUYzTMQ0sWWqVUvqk0ALWHbixuhUWkzdmpWhWrwdiaa/kUlnbZDntF01yxJq6cW4Dd3MwdQggGQ4MG3ONEmS8Q2ALQGgxFbOaEWUcHIADDEVHXUFo54JxdGH0aqNY48wAexkY1NlQLrdHfXdo+9VkZYlKho/uiy8rLwiTv2HGIT6UeTGnpfsBXkSdCVuRJASZzMGIjGh8yyTH6FXjbD1FxBC23ExbzQi3GHPd3ENALD5Dumpjst5XH48if/eTPfLImB8yuQ9L8QPc5HvEfny//DOdDLfw449Je9jEUUDbw0bcu+7ge7H42aohan9mlxNWdykF/f1FX8NuzM5/8YZ4I0YnQhgYetQIqUW6eVhWG5CK0G3ws7VYPkzy9fLGRd/SaS8YuYfJZhG/08jk5NRfPnAuV8qCe9ax80cXAN1gdvhVjI2Cp4zyOIpyVzfNDqAFEH019GcBYx5B/nYqlC/Jd4hQyZrE6kLLYF+56+e/K3kN+0cAJKF9u1NIZOX/pCMoajPiutVd3I7ma7lzQRMbPeIwW4vs5yqTdHOZ+CpnXGmAuMcOr7l60zETLDFEmKXESXaRFIDjmjlaB4rUiirg4WNxwTQYkBKjigBivmzaYlnlcsBfAvBiDq1wGoSWcsLYoLWtTOX5rrBxwzbIOyHMevDZWGVE/1YPYhA8D8hQvLVV7S2X6JtXLjKI+yz8gLcUSccUsFb+DY1QoTy0nOheV6OEAljnR4tKPxpc8H7ecVfxmNS/JHz0YUA0MI5zzRtOKaFQCFY686lf3TJQIqwG3weOVXpLUbEcnC2f431ZExA8I5imUJ2zdMdVwFVeCjKng9ivN0KAm6reD9L8Ycy2HlWqC1NXIq1rBg6lY8plW1mDGsfCBMPyTuDyi6EW1jYKfgwIvR7jkOyOvPqoVpoIWe7M1RK9ci3D31NuQY1GARPcSQ7dFyOuqZjW2j/LJG9tHuWuf6oNf6BH5FVzxzT4q0Upyf3wfFWnCSe6mfLeb8sk/7m7KTyl2xKDcUA1x8uhW9MGAYtdcbcuRPJL+O0uMQKqJXgMkiWaS+O9lFu8k4BGPwCMREUEFHrGFR3x8eMQUnzw8YoZH4naXFJFFqeToEI3yJ/c9vli6GXIXDPd+7l5hlDcK258vcXN9N9lRzBBtEuwGxnHXYQZjKBOMCdvGevqDj7sWZWKuC57ui25vwNkq+pS/cwJ9yn8Ogvi6+rWbKRwGpSKj1w8OgBsQ76TEf3wyEenOQWR7dQhG9udJ5UzWIUPTBVNIoUd0eMmlUro+LJoO3mkF0qmDNC4sANJt8on/ruwhYjCEVQMLHlXnt+z6wt4hZ2kMoIolxjgGyguIs0uVW4WQIlSVPnn5583QOtfkTqO5Rcw+StwMvke1xYxo82DDyUsDlpAadWxdqOE5poaEwjUxJBrzJe9srLpsenXZhq2vXdbXlvogETR1tDg2byEO1WMRxHhQWpau98lEl9Dexk1PkVuMYvDa2ODTTSLWADBtovCX/lCwmS6zu6EcWJVkSBEj5lgdX6xx4WUmLuLXA31oouI60tX8xkFZryqKsIEqwrZ8qOl9ihlOj8Xr5OuxBSdSIJzoJ5FCoXKkrOkYqbb0H+iZgbh7Otk6Q60T7R3Vsmb9Sq//0hdB+JlHdiJEyF3RtZaTjqqutWd0rd0dfhyf6sNd1M0+IYeNevskEtYbaahLr5+PaWF/Ujnk27wgEA65vNSLIYwQgomSCB3CwNqkPFaTHja7VyqQ4FwVivVQ38PVKKwworuhe2vdBoHVi+zmrYEVu2F2bTGuS9WBUnVz0SU9r6pKKUilXa7cnp+8jJA6NU/ZhEBN8+Pjap73TFfz1L1MMqGO/P6T17EFeqqOraLapI4t8ug2yKnZKvIFinxOzfZ3R9VsLWmODWmOQJynKdyGOMUxeBbYY4oAlKKidhseT+025qigvF7eUu3bRB8hHpKWHTuu2u3vIfVRqp///rj6OTpTqp/jZUz9fO809fMCU5QRZe1R6KCrrq8OY1XXFy1RXd9H17NPPdKe7S57FmZ/iI+/Bj15flX88FhsRBShsRIhlkTA9PBHTnXazUnXiK5txIu8UOa7yoUDe92xvHEl9x3l6esT9oQOYBpgxsXMTghmmwSKMJH0Pftj1WMT4hordbm9HqRM+RauE8tpqnT8PL0WqndnSz+JkDVSBJ2Juh7L4YxQdvkJgjvV9qLxEtBSdQqBW0otsxMqsA0RChaAJIC+Qr5kLmFCbgBrs/kMRXlHDlA8assgI9k82AEYjGgZ07QzeMxQBzRUlT5DquMYXcWR6KW6Gfa1SjhXhNHVH7+qiCnjrVEb0gjp8xyF6oIR0TOinCkwKeokH9DMWpHuL4w6wQJOuHhLtYiMnf1r+ZKYgE3xuszC9q4Ao9jCFUtWajF7soJ+UoeTG9i4foVvFVyT97ifi/u5TPhHpzoKiPZD5A9Qb0N/qC2O1tYKA6ftNnJ//wfWNKopUbV+bN6JC/pq7TLx7hpK1qKgWThiSPD23F6xg+qaNSY0ckVfdgr7wlWlCq+eYmGNEo6kueeuEOESrwxPSu3LVmiGZ4AOAZ4duVBecD9UuOfRTmjk0jIOZ+bXsj/RmQt4oPguRbTjAAayAYV1KRaTeea4g60Hqi1jiB/QRVlLI2Wtbl7WtVMRB/cdFTsT7qc8CuW6cn6pc97tOT95Eki5cbVppYBlBsXNGJRT9oESA2hs/HXh2U4RBrFB24AIhDciPs/BMBrXLoHOzks975WG7wicFofpTRGhASHJw0MDPHvRMUQnQ/LRHB8lTWdMa+OM6RG4ofWvdVoMUfWC+l1+4W6fnAUguIsNVjVRtWky1cpYKOrcD/0UVXtG+6lmmT3ZtvczmBuKQOiJIjXgVIdpu2O1F/H9xn74Mkg3KZIr9zsldBaHump8EhXAHLIezBhaCR6ri2Xmz2WZSURVDrIybBzFoYuRQ1vyEOk5IspuAR5R9pNYNcALIBalGZsynPQXBonrsiDgYSzSBGoLRcPCDMrF6YASta/SEF31AM0gDnCs+UC3D/oRmheRVqx6dNw8JyM/vm/kF073jayWVaueZq8uYqF2ztPsFc7T7Msfs6fZL4yakoirZkYNFP9yqi3QutxSHTE2WnfGRuuTxkZduqQCkI+4GmByZ6385D5neJShkH3GGR6ty9iqYQGMe5L9uFoDFV1LNFDzqf4hrIzei2Ue/K2aGR3Bmchd3ho1Mxpy04ZScKROuJA9r/OTwlEzo7FTZvv5ZgTp/up1QUWP13O7S/WMNmbm8h3OzOWGM3P5HgSdhF/3fCw7BFKBvBsGifu0gI5lMlUx5SnmJVEujfsw1qecQVgaZq4h1KyUy1eNTQukHAr5K+b8UrahQ+nZNTZiXaMUdKRV0hnsvtTdFj4sPIgnJG8h15kayH+uHKi2sfxgTdKjTKliFcm71Qo+tfKYOsa4gXAtKFzl8ZawWwME7kZ2eSCLRqLUVr/+Umh+QjcK5+tz1NYTDWir0OwBZNwrDVpEC3blS31PZPld/tsil61XZFPKsD8o2saL1O3HnL/HtczJytYDc+DnNeTlv61c9Aq3Cl92lIYzp7BKW/uJsAcoLY+5mhlzXO3TdvK4nWsFvPzs5vsbRzFD8EL8cpd9yfhloC96zYOFytu0AnGPT4r6OOeWrb94xSfyRT2jZh3jWzf4ygrY8xGPGzzDqCe9mJHb5DU5LWZCrOwO+IbWc8pVfYWD2vdteNsvPuNj7viM9GgbrVC89ug6hWthE50C1B55v9AncBKxcN+0XefnPG2RUYkrAHMVoDyxvq0lo9hgvNguiu3SskIsybdwScsKsXnGE1Xn4McsLeipPvCxALVJZTq0A2whPKDcs3NPQN7O4yl6+HlO3EBSI2SUU4xnUTz8BY+Kh//Z037nhE2tzoRMOR0fOrWorxWkDIW2n04WnlOFiuwALPqeQUgSUO7gEOgRA+slcnNkB3n8KnDjADgrdCiiNjpyrp3crGSL970MTUTtoQaHsreIq4YdOEKiHaxxFKRGOkd1GRUQJc9ZPPlPPmw7VLZa2KRWt1shhcpA5BFelXFZg4K+85BRlf+l7/K8qGIKMNY1pK5GqqKzRbIfCDWEOAIktImhrJoHbIrqeOObETy79g5oq3/VuwavurTwI84+WzUcqBIRvMZ4VZMPMBwYI8IZDsQLrDmPGg68DFbv7raGA+P+7dZYVIwMoQy3msNROzvSjex+a0yUUB0/ggk7gn/1KOwI/h9n6++9acxSNvYd17zWc3zzUa/COPexiwZVFw6ZTcZXFVGvHn19oWa6whl3f57aDNSLwmK7KY/lmeR1IN+FQBGRLdyJZ91ao4+NNXrxIqC2BCGh0hszAAVPaXl+3mOcjMBN8M1j8U0qcjBxmRZBrS37O3xrstpPGzYH31ARzrZZsRieInpDols4PtaDBFJ3ZCU5EBuPvVIvaievg3pwu/+X1OlAkWZ/j6rFMVKRDWhm38efet33vm3wWa5jltLShvlQ9u8besI1TSds37de9qHfuG9bvJcPN+ayv5Pr3In2jmAqGoW55s9rDnAdCxtF26RczoxvQ6+KbnAP2zj5gHRA7o1u7HvFws9985//wI3VWovF4cD1tm1rYGWZ9mQ0znMdW01hDxpLUDyQvjHrxS0Zus9SWL0+UixRtv7WSo18hSxje8+F3yNxVLOwMWTAZ8Tvi0PbEbDqVq9MBgF7qLHBYdtdXLnrOhTI8Xdl7wXqR/EBYykLkS/gFeg19UuvyX3resgX7vdBb8z6HRy3ig89TznIh2SXoobvsg/caErEycuSGw/qoPmzoukxx8HsC6haeqfXfTKEfC4HZ2e+Cq4ksQ+ZEQj0PjwPcOBqBHDUxvh1tHYZWoqWc2f7SfYjBy1enLum0LA60uvZLyONIqShTw+9AXLF9wiW1oT8XoI9FATSwV4lrVYej4+w0Pd/84345l2Vb55XfnP56DfSB21ZTTekfrahLZDX/ifeMF4WlWV1x+vvd9WCFuvZ1lUIK0WGo0W++VEVqYAU1V5XIKh9dug1rqTdZUm7JkqCo8YIewXZ32dfulGKgNatJvZ/+QY07K16s11Tsi+a9a9mrfxPJy7UoSD7B+RNMQjemLXE2yesJU6LxeIImbJKoKdYf8bOUawofl73iW5H9qveyBfuVNrD3BADrs58IGI/PzX2Xher9gcl9hNTY++eWsL7p+a9ayKvl/2ourjzXScwlR0M/tX3E17o3OqNNXPUWlwRSVjJi9r81RtqpbGkPNZ5rvtfLGh5pEaki7otp2s3j2bnCJc+sP1HnrpCKpS1shbmGtqaJspPoA6baO1iYt/Vn4gFOnibQVzbR5RwR7p5l/z62Yx8USdkTpEZyp7YgEfEgQjneQiAKmpZHmFZ1L7Jbb7UVKvtaaKT/Je62pnQoZsxJXkDV3IzdNlCAVzaaL/S9J7Ar3hBohEXzkaopc6FK85/uQa9YuQJy2rsTnwJSHCe/10nk/cf7UnN8yCeykr/37DSEB5n1c2dzAgHKG4f4IG6VbWGnAaJr8WVGjLDUsFmsO/gyvb4qz/79KOin7TJzQUtm3znHFS1bMi9wuGoXmRI9CJDRUOJElfzEUrG7zLUySP+452Fl7o2T2tNLjgQQ6kqgm8U7u93/dBH/nHXd/09gw3KSrhPRpYe+en3TCctZBbN7J8wBiU39894Q71jZklretlabyeA0asSo9e1Ayh+ploPinJiubj/dm9NWTth9HRFfhA0Ia9zqm4IwPExasTZg8L9J9o27GVUFhriR24xJaVZOUx0jIe7Wct/HaTo0RC0HVNGNJzI6cYLaTg7ysBMQKAjdjr19uwRaq0/FORZKjXhAm0mEx5kYtbUapubQI1c7vzOGnN/xIHLetz+L1sOQny74ZFR254vcfZZBJk4ogpIgdq4Qe9OHrSvGcrWQ46Yb4mvSSu0RoGcNuWgTUBtkvYw5Hq47pHPaVOv1a3WS9VDV1hk2rK2ihBxVcJcSG5ytL2JTDXI1NHCWYnFnnhhTcSeMxtgu507BdgZaKlCf1tv2zJCCuzvr48DX0tbALRlxNA5WZxhA5B8LlZk48pCa0OpwyARBXU9RsNpT2Ztm2tY9ZR1P/py/LwU+AW+ILb9OJeDrm7cgI9B03aR2BKkRQgfF57zkmLxwtolUNzFucDV1xRt+D6X2juIpQVa7MFJOsKd/fCRHuM69F54Isv+RSeJVskDbrdCC4ZRjGGzqX1A5IVthpFa3UQXqJ39PbqsqrRfkhtFardRbxrIp4oLHdw3m1NcbCtmZqm5gYyCKlhDWpib3atr2b9q0FgTW0XodD88PyDMCMWXRPFF4AlbwBggRwHO5QuF2kMrMAX3WSxX40CaJmb7L1gVn1Dt6XaepRAAom42V5FTpzN6jvkIHLWTs1i0U2oBBc4AWxcEFByq6KqNLAegljrn5W6HIsWiE80yFq5DKwu3LBXtZxg79UoDll2zwdCvES23ODI7kecwEHMk3eyUY6FbhqyY0Z3DPHfdmkJawkMBMMPWgItMb5/O4W0Pfs4t0jUQA5mAqIFShBdlDvmG9IDc4Xixct82hUQ5leupgB2+5Yf5bCJ3htyZ5gY68ZBza+dVlqPrQqjrwpSNV8Nsutpm05UBEd2mC3NsHJFiRU2h+8ocYoKOvjb19cvmNRl9rY+8ooVmIVpV842fxAtzce/55PUs/0+kKi89HIfhdSGsv1WdVYX6qZjH0iGKzJyN7OYuMps7g/UhcnqyQ8+++BqNOZhBWeMOFXSJlxgQ6Ez82O/sm5WOIyCsCYkjqaKRWzIwRy+298ouprqYkXB3aWXNi9xXqXoBW8N9iKoHhWFZxNDdqB3XLFQd+4NiC1VXErCKlTyJURTrZ5IFJzNCgkH+D5jbw2179tFipIQIWI1QtTbyxqg9oGzqfeFOjxrruAPl+ohq8whnJ6P9jCByGOkkf1rpnSq9jXbSHatQnWagXZlVkrPypL+8k56pgsqCmJjFMl+68kkQkhNifhKvCy1AXg6mIB3MHnqtc3P4sB4JCjBUya+te5ERV/0gEquarNgwmbyvknzJZPKeSvJFk8lnVZJ3V5MprHi6eptXOq7JvoKGT9qloEBTjmOLwmU6KfsTFGrmk7A5cWcUhNdCkD52XMiwnbge4BxNcaEbTl0etyGMcO+f4HKwuifAMFJsefZgkmePKBgecdfpjg7HuPaAgkn+PFAQGGsQTpRYRBVLF3WFb6VpcqiWiFM3b7S/m/bTq/azQeN9axy3b43H0Df0hDxR3cE9VLId0u2Hp0ah68AC3L8Y7yd22ooTX9c9xY5M+lokfPAs85sD6NMkpt7le/F06yhOadRtfApVrVOHoMaiep0ivYGhqxvIL8clYIwSo1CHwoyqqOilZl9VwjNWhRoJj633lbpWE+lJUWyZqAImiqwbCPOpHqf4peeB7KCcetXRiHrphXS0uqIuO0W9i+apWod6GNGTk5Y2Vdfqin2cK5X0iCabLyxXEZT6DyppZdu4esNRwMyoVe7iVCMS7fSdBh9aD+1Jp+L03z3/OEaer39d9Sok9j5cjXYMXBKg7cxdk8dqT4WnkpPQmH0+HHhRddSn6dobxfRItovxiK59xEc5HAtZsdiR269tMCeCMk9C1QNWe0QjbYhU497ZIveBq7AtbO6vlraFo9K2cKwa9395Q6n0PFJv/cT1QnkILR/Vuo+Zeu/PPSOiR5EUVvTtYzS3qm+vwr2qyeFQShXA6qMGXZkbnL59rPr2kQyUHpEFVU3ozyBvLX3t43xZhxdLdIQCDlQv6fzQ645/SedRKtY/0fOm6+fChEx2syKsKuMaFP9cKwzldkFy7VRE1M1HaDhbnWAV7qrOr4mxur+ASQTiSg0+7UBMd834qKc6zmdAjyiE1Qtxufh9L8nxiu2CcVFcuTOE3SULCzYX4cEx7wvBU0A2YbSGcmD0yZ+4iQjInXK+nA85Ky0Y7WRoU75asQigV3BSts7ropqYn9VlSJWXY/K0SRSrSYqiU71+mE0149KcMOPSdA2cVWsEw5x/qudsNCPX7Wa1urwpJ2GV63Yz9rrdzPGv283gHlLRdNftmtTc9LrdDF+3a6bUmXr9MJMP3fXDzuT1wxnpf2f69cOqWtasZnLXD08Mj84IPGYBj04FHh0Lj87x4dGhzsnDo8PwmK0IYmdotnr9EJ9OcAxNQSZMlcEQLqWvwHGj0200oX17BxD7D/mcmS1y60W2tpWvom/qL2WjqG8+BarI3XHBmcco/AZebyb8nrHCb39U+O1eybcsWDbJgmVV4Xc2Lvz2Gb78xxRmpgrzKa3hDHKhT9rjTecWO1R36AobKBX23xuBikecalvdmWw1IxpwYVPGkVFqooV61Q9nN53BQJFgltquQVQfOljAq/mgfB3ReGXk0NW00pm8qd7FoMKkzOJGYZN3StFM63zZpgUEsh3CPELFJn24IdYyEorVlOYDKr7QO6JzIOHWpROw8NJxm4b3hl5UvbRtVjgsEsH4VW1Y+sAlkcmr2vEjv6odKDsGg2KjV5NDoQ1B9ap2xaxYeVGcwuPTBm7syV9NDvWqdjSVVsZjV7WjSVoZqvmLE1/VDjSTo5Unhkc0Ao/g3+zqelCZtyEFJ3NV27fX/Es3/sMXpKfLBpmsg051rwPW+X/APtfTv6/vZTeAC0ofd+c2KtLFtKjyea8+Pp836fBCGdHqTcjPImJzhxc3+17j5G4+FiFvt5x3Ed/dfKz4FvHHfYvgvPVB5f8hO647OSVuN+PWo+05ucoiYei13Lxh+fqYIsvX+9inov3k680EBYzuGjxq6J4wQgZ5hHhIWvaFG9yNxmDiRuO7FHz3ZEH9umDE0W2keYK9OEJG4zxcn6ur17hE9ihoqm4e9T+LPEVzJo7jmucHYWq1LQu7pUM4tUZ0zc3opnnnqRlhUddeNfnRiqaXYL7QI4dAkTA2cUVbY1w9xYwc0VPbVNBUCAF69mNvrEnpRJNkF6VN4jq1sBoK09ammuTymtJHmkvQRQhdC+SjMFVoVnqq2FjtpOumN9HNuNpN0zYoneae8Pd6u9rU2ZImeE7dE80XPQfXKU1MXKJGOB0RKcXVUM3OnYlz/iKgtNpxAMJBNNC8CfiBcgwS17OW7Ws6+k1auUbamjJSwdhIgYaI9r8SB9xXFVCTn90IStPyMZTN/vK3CNxCvZJiRMuvQQ4Uoa+vdR/EomandNPHQzK8TvRtFB5i3vDaa0bHtIFHpzqmqPt6nMEhbEGWTYxvcwoae+CWALuGHpxPwrtWrU6+0PHEh1PH3MRyKJNsmnus3TRTqTzFaYg8A0pc2ysYm2LGNpE0O9atEEVO6VaTMnPmr7U3q7XbT7NKt7TlIT6c1i3EhtqtWc2Glo83mGZc5eDKTPcCqk/vFhox3qNkkx6l0gSqa4/047EeJVN6lJgPp/YosT1CNu0/2jrZIy0D2yTtkVY/1iPt08QoKeinE5fZvIO5kSpQpRb0uIoddkT8Kr1Mq4OFUjjZ5Z+dKMWWzb/C6qtiSE0/SB31AhwnZk+6+eypVWfP+ETDpxOzRyuj2rTZ4+aUBUVtZPako4PC+auzx5CeIlXDVDxl3CE5ItwbesDUR3ckoaFMh0B4clSuR40m+vWIVpszAUVig9WXqwstS76anOsN8nEspCiEDTLPRj5TCbxcQOBBwhP3cTGe+i2gpOyhfJuLRElb4fYwfxzGak5b/9AQFdCSX126jEGpSJfLRGPV+8UoCUwVC+vUEFjkCZqjSzm4JDyi0TXXFhFPIYX2QzHJqmMqZbtV0FDExLEkJE13jaRUSvSQB6yaZmrmSSodCsbaYj/T7bzFkmRawa4j7gutxnzo4OW6OvHFSOO1TeHYR8HER6ZFoa0mGP1CGxqOdiXRroSVrgRjXUlGuxJMjpo/1pWg+oUy9ObDNL3bCyLBq8omBkgcaFhXXrWjGpE5ZNCDGqSFRd0iVYKYidqi3Ad/i1rXrJUIiGVQTe4D7+Q7rHA+7oI1RkpoY37zZ7r3qgtuRHiPGGt9ik1DVaw89ILgJHqiPQjRCF0HI2eQzp8Cr1AurBm+vwbGXclLUcdtLMzgiSbXKUJT8SmFI238c9+LXPsMt1+E4Pejvn+JREXE7y9jWrYm2gCqYBOz5aa+/6I81LZA+J29UchGiFxhaaiePFFJuwlpONYMK9rI+FrdjehkNodtzrVSbQK/QjKXqer6CHA5JnuTlI6+OQ/UaLl0QRnxGA0VkqBiZv02+0F8qdfg61K0XOctvUXGWp09v8N6rNsh26FYykZN34LjRzXZWFdLF+ol9YN+4MvpAuod3Q242QYpj7SzsiwovmjL48IntQglMYTsKMqBRu/JCzppKho8mkWBIgXVNJfbfLlKK5kIKbqFFXNKbnMK6I9XVNSrVY1XUMSVKlB+qdmls82KKxTwIP96ZSz9TT/wxOEkBW7PWIVdzhigB+Iwz1TXWYgTs0BGbQSlItQOemtc6+NwWA91A20GOuIyG7BiAFRNY3ou7YmvuYoGvyte+Nbrip4PWSpvgBdoS+PJBo42p0hGq0ItAJ6pIy0nFB4GfICqVhYq/jYurIXpHyRBKBKBvpcH/pRN/kwcRWNbfF+HUE/bbUP8idU3dOa/gCJ9rzO9iCpvQP7Y5jdBjKtILDLoxDQ1xO4ioP04HGtTNNEmPELTJvWa7TgBVe/RNJfblD/SYOEfAtsG95VSl8h1Vln/UR7INXa8p161p9o65YH0GE8PdbVSw8N47nJH7JhW1y0kJi7R5NaiHJflanDZQ6HPmJxRteeAhAOqr3kTe8Ss/XU9q7tlbOSbSKsJtSOTg+VPDtZx9/mjKBZqK/xRqIdVGZKyBJvjl+dEHn4F2q5ZvgK0AmvtlUtChBsZlDCRLUylJ0VsGQKISsXUemJ07kMSitByADWXa/3qOphiAuvaK3yMr4MbCB8jrL18h3kXgI+JRkpoW74lwOaxJbwtpKLcCqyEoEvcvk5qve7HuSFWvthc89RggHyd/pDvh3pP29fl1mfWAL5AuXq8emaIPLRVndAUIpIet9NLkgMv/aS6DnLjTcYiHs2qsY7lw9RRqGhiOcMLbphHfh6YerUVkbxFU1rhn1wrEiX9tivKEKZvrfB9gYKkgqYUGPBICwt/hK6GU9bLoo5apFt+bkTBalKHktwjLfK6TYusy5KuDm858Mu+Hx1vtNTyOUMnj+3IYTIBStwu8r/V6KbUgeRjkEOcNxrHx5Fx6jKPtsyNYXV3OD6GdlUpPIyhh/YF0j4FL/BbWhUcp1XBtFYx/m7SsoYdV+2ObgLTH/dYP418ZXyBSmYfohZKKnDDnJUPuVehsTyjAIwIMIcwlakFHmaNIWSstBkRCX8+yr7xeGMDIwwqBsZsm54tykzpL568+cdjtdL+43s++7EtU8w/Is+E/cd3c14G5a3v/mzLWX88/Lqq9Uer6xOpts8mbtb7d133IrEk87V1t/7Drzue3cc3I7WW/o9HYx3xR/Bt1ToieuPMI+Jt3D5if6rlR3z4GE0/YgSrpgpRpLVV+PcrSZuvg+qGOry2dV30CutXwHPXE1FTritoHllMwJG1toclkJntE651E//sMwrsRUNld4jKUwpwNxt5NDWH4uKukZg2x6xqTD8+IEvdmiaJOgLii476Pb9ObAChfJ86G3k27jptVjYks1QbcZ2WOddpgqCwiSA213VHSu3SPxqc5yrHNm9uhyxWNGlUidJFZHJLqYZFe1GYIlx2wVWNQZ6lWhMakw2hnqP6yWooZo4WnKsUmoVrA+toq4MMyr5BTDiDpi0xoo31VK0RWUU23bbAoFJNZX71XYgwVpWoa1mgDBi7zO/hy0YAVIdqmAESmp65xmVVP+8O3uSCV/W0Sc4vOwBj1O1Q9LlTWjJrW9K5ZmPzSxacTzwC78q34EH5CmUmoXfCKlZPsorVlAt9i3bdwNtXhd5iK4rv0QoP4pbhAMOY8csWWsXLFuTJ8hoesB26lM/TVjFhOE+zggsD4MKQ89fKl4EMNTCDEQePEiOdWUN0VVyH6qBmMqSVax8cPVu5fOXSOJ5mh+sYQW65R1ulVSoayqQRw1GnGLYFqNrXfe1YPSTm27eM17LliK2lhjfnQxkwmqz2Dpo9MpysEH1doq3qLlTn+bZ+BHNYOiVJp/oCILya59yebXL2XpfTu224YCgIsB12SIy9562SRNvAvxT78x0IXZPvpAUqUE9+Cm3nUMihU3kGncZ/u7C1VmIPNLfP4nS2dnQ5BYQnNt85nYbGFdYk1dUUlLaqruB+7JJ+SExxOp0OC0xnkGS2r2dy+wrVQYWz/jla1AK5+lp4tVy41PAVHM44fZs6yC9qks+XtMsln4b3Sr4FshyB0J6HF/KzcKtyLO5sCvoP1AB9Vbpljpdx8Mz8dBmnmti3Op3OZhtSMB+V8pvP72fxO/lItLHzgGdHvEZrYUdRGIgnnZGfTsBgrtuDC+zCCt12YlBOpVMBDO2sdoXL1P5qb9RulbWtdUq1QyfVeDSWh801/xG3PKUd+SI3mNFGBWLbcY9VxqjmGu9GDnGuE4oNI53Y7sZQyvHVCZB2n8sxI1sth1ewiXK+fsd4m8p0T+O3/DTahQ3hLtpqBXnb1FzwNuoar5C4wSZg7QAc6DaXR9Rx9y9nKxQI1sTUgZ6ZhzUSP0pV62MZ1dDaeWOpjFdurhuwWZOlF1RH76TZpnbx1qXUIucS2jhDS+DJlqoXvoQIKYVpUw3JtZHkVpncmkgWapYvmGVZDRmG+KmJOaI7sjfKKr5Nlt58p44bw2nB3gLcaqfNAm4BzvGj/lIhWUv8BxPBwmURKB5K3oq2bN+P9R+1jZNFHQiipbV8F1qhlt1OC4Dpp9E2HZyCduUdpU0w94svihLF8kyM6S6ID1lf8YmjYamoNJI/uqDNg8jPuxvWnRGUoe2I2y6IU5ymcdJAHUnaZix4z6EZvFauSRfxnDNXIGhuYik5FTadc5SY0047vlvLYdo6fZgKge02hfRpZigWSO9Vj41YMacDpONA/LfTjgXWJ3UMe/yx0C7lRPBZGIqvSF2FuH27aM6OxY6v2Vhsq4zFnBmL0zAWuxC3S+O0gTL7aC6fl2acppIr9A/WrU+zA7FNakIZIzURYoh2otSdeuNVQWSGY2mzWZMqQA0Pu6/YVs6D7ToPCkybXUhUK51YxjuMvYv8nHMQO40K0JmXHaA5ZgKREw1dzH2ADmADvEZ3BbiyW6t2YpG2wwroHOjb3AglQWd2qf3SXejHrhGH+AfLy9N/5Xn+ZpvwZxd+ed55OfmuBE3eW0neN5l8biV5z2TyrkryWdVk7CT1Bi6s/9j744jM1kr7JD/2OmeEt1JQOFpQ1cP22dXLOXaUUayRoIs7Pbt5Tb8yFzevi1/BluxfwR7A7B50EJQmTkr1yP5RPpclPca515NggtvVGmyITjVOtZ8F9YTLXpKjWffzgoWOYDVsG2Mcvhof6BgmLc8IT9ydwLmQieYZLrxdTMrJzQt3F0/hDxeEP4wJT5zk4Lvd/MQXRNPMdi5ySsY58Kz1dZ+RoosZZeAP58G/I7CARGrly9TOu+TB5KzpO7zf4rK7R0swo5qvsEW8vKcwUpYbe/Qt1IOdVO0LBs48Aa8a9QC6otd/MBCZ7Uy+Ssv5Vurm24K9hvb2bIWQE/Ok0wrwQoZPoJ5WQNsl4gvG0iooXYZP5ok4YDNPZNNG5D1pU4FeSVtQ+1atXSvU2tGUr33tvBO5GmZtt+HBtnlZqlesaqtW0SJ8w7ERTJnmZBuFL0xj8dUK56gbK7W8EnEdsxAtyNgQzi7wtbD2tbJ9OW3F21gTwdVs72N0My7By7lzaOQqSNBqPzDwKsqWFYwNHHxAGyf8HybPbvQTJkG5MA9LDYaZeqgtz6mnXKFDFCJ530E70BA0Dm0S0AoUkWVF9l7jJna3osGrAItpwVHTApIWSF84DyCLfhQAfWFBv9w/GKzl2K3j2aUt8txCTcbzgO2jYDUNjLrEZVZCwmlwMX0p1pK8h+3+xEQCdKbMRHT3sG8m7UEbeMAzgXu9coKt9ivzi1u/XdaNVZ5gPPPcJMvKSbYdYCAekbzHn24nqGAQxirjyTojeLCSF1xCrVhRK9CSTWvoCVZpTSQ1LVDPosk22m4qpNoYsoBFQr4M+TQ5K5MzIrRpK9qEQSARGte5sq2CUFRMtKNm2tHbrB39Fz5uTekBRNqUFUy5miUE2hQyTdkqaI5mevlKsBcAnD7LtlVmGR1/lgHM4zNNZ9kK4kAl1IA3NRhtE25DPSfq/d8x89RoNeYXMi/hLKKXL0Fjzu7eetR8rludcjupsHUAGzVPTIfFmPf2ci4sgP+inHJaQBe2g2j3ABlJZcciCvtiUYg4lmlJOIUWNCFfIAYAzSF5J82b3PN4PYVjNQ+2zVeDbh++TtlXxYPKLO0Jzs5qOTnNT9DVcp7pqM9Kdxbs6DvMw5hu3XRM3XhmbjzHhozGBgtxWyXnPM2bkc7sSG8rR9IzmI/6p4+ojmZKkbAuFMtEg6xAwzUOZ+IzBQ79rdWzQWDZ0g97PrwL9zs5M3Ejl8JcMHTBSJR3xBT0gQ2yea5g+7zDIoQLbh8csl91Dyu3+6/TG+4jJoOtuWAnNTR3lb5w8TpF+27cePJf/cNfXfi04b4fePnv/uiZb/G5klJqq1/CtsQg/dUkbF7nvQrdsGacYUbCHWGQWj9ezQN7QR78LsJd+MKFNwKjDqCHMHU8WnpNL5NzjP59Q/g6eBC/etm7md0OzhgmnhOwmuqAGZvFHB7uUvZJohrDan5AzdwHu0yYONw1YYwWf8ktUh+MLfVtUU2d8pWWpl+pNfG2SCj049Td1+RRZ5F50aFAJER461JHbldSxsL8znqZlzoVV8t69TWo1a5+uhHk+3IvHatvJ5/Rs4iDHv9xeuXSshxHwvBz5W4wi4ln1LQmo+KIebsZ2Pi82y86EC3LWHElGtqpoah0wN3KfhwgV7fsqzRzQaD54AKjekFVtx5t9JqrozY6nMmBDC7BFjOVDs9UOzwz3mFtjunzTN4Z6/PMaJ9xbb1yP5z73ME228FGepybHnOiAEQ7LihVc7rasOrdUiy1CIoj7IQmkPE4eFir4iFA2Soxh0yYhDq0SkxTVRXFoWr0ZHYtRjGvJl34+sW8SbxDpHhxMERiJv2dZhzyHjTh89Ck3IcWdTHVdTTd3997TdEwmRsU7vHfk/AzuCDYSNQ9yz3ro+5ZPoZ3dc+iSXIF/RMIpn1JFPojI78fv5cYP+PGDFqjz3GSr2iyuUOubQr/moJbRUMQuNcGjtnA0cRa1G4psWtjHUddPDZ+fw8EQA1ZUzJ+HmysSXhWtn916mAN13iqsxwEieRzEAG5lExzeCwckcMsCmhhgNAcFI/nqC5Wfi170eD217it8O7RNG/34m1g347h7bB9O4q3g02asVomM+jGosqR67z54gHh/UB/71rVIYvp912pCQxs4LANHLSBB5oWbDZwzAaONkXElq+g0i51WRaJ0E6EemYXOEurct9Tec+tFkz6ug3wU9ilArs5mhM2YBvNI08tqHACGIHmSK6t1JvMVe9nFXDO0wpa1cOjZ/eCiSRlCr+miskVtHjJzMu9eCHz8gBedivMGWyVlwFeyLwcxktmXg7ipaZDktEWnpWmu0vcampIT4Sx2UZzQBUJbwf/tlVIyTKy8eYBzM64OOVD3ONiG7IBeAYsUxCfz1P4c/75ZzCXWxHeymG8St0IT0INOJQvpiLeh4h4WdCHunjFZhMYu4UWwSQZxEstaJpmpilsmma6KXCaZs4pdJoy8agju5QO+fL0BWtjuPuz/g3begyhiONlPyFLWx0SXIKfMWYxqWbpwkb2k0imRuly4qtM5h+sUwMLxZfwPMjKJA/UAf7TAzo/IISsLVcNqy1XhEGHg3XYaG1A++Vm9JKJE+YGl/QeWHQ8rOENhG/S8F0IH5Lwef6NalA7VhzPflZaH1BSumhx/sp242dPETt/Zbucv7K9j9lf2evD0FPhYcW8dtMyf9OJJqzZE55dakJQphemsrcJkMWTy4K5LQsGEEqQuMGe5W1qVpx+4Guc/nD6goYYiBmpViyzYlo2bJhnfwBrnbDJk1BdPnHu905cIpezzukcbAGN9D4drmAZ1VGtJxavxNk9UhPzRvyZOPajBo4KxPSxVX5tlIxGC5rwcKmEXNkQvTzmOw0OjC8DRirIBoCOMEH2s29CNpMnu02TU0q0Wl6KYdIcMspWeZYHdiw7onfIuEJeL4gAqTbN3AH7KPCG1wLK8M+e4RAoWpNGeQVnQuwut1tA+m5qOnMBx4AK/rVAB7sRCJ0uk7N9MRGoZR8E2HJxI7rh5xHxin7UF10nnle3hBRMQSS4bBlwEsXsgg3PiEKHpYUNXwE49gr2PXSXcUO4/tYy8eBecsEre45HeYg11W7n/NhS92FLFeJeac3duGuAuu+xgftt4EEOCPPBT1CGT8iTP/H1eYsv6cFhPC3afei684NDvilhYAN3mU+O4nnMRxvu9qQNiH2p1nNAi7vCfHO5vmZaeUuzJhRUMRwFdEHapGf8e0soxq/7aOrnJeYYfrMfk9OIgPEgD/HYnUd6IWh1lN/UyMs1MgAd+/bqWZImH6gkX11N1mZkv4fhX8EJd2iQCYN5JP3PVevuVaP9anlPm569Xpqqru2+yDZxxSafJosdmHe8btQ630m69Pw4pSGjc8Z/AaO0j79rfcecNvImyO98lTlVpvSeTJnSwRhTerNjSgeOKb0dwVS/uGvsi7e7L+5yX7xD2dibx9hYpWgAg6TkaTYUouDmf9U62IxlTjvKnGbPLWbbNeVL50D7wgLad/kCd/KQh9M34VV17UbHEw0vI+9C3sUjybdwyr2ZpqxUKqNO3iMfvBu8G9McPPFpVmKd+23IT6sctMwtcxV4EJhbcCtEA4S2grndSi2wCq2SueVA6QNQKOx8VVNrO5NMnNbTlrygbr4DFU8hJzvBuWKtRmBgA4dt4KANPDBnAvfawDEbODpHRb6NduSncH2nQsRMpwLLWsqX7rQd1tfTAAllUxUKW1UiBVUAfp1kU+dGcu2kUyZztfqZAwwUGXAYcgoep9CpYHxONWzqsrKpKibTl2N4yczLvXghfeEuV9nUDIAqeTG8DUpeDG+HS14MbwcTWtIRopyNIvUAG+n2KdoZIJLiAI/3rSSYgNCgRAEM/lU9jP7osBfIiiN6ee6gHKk5zYN/xHq6N99ucIPFrgnq1DepjLZCKUjKv7LY1mOcQj0c2D5WC9qQ70KbUSYE5rQkyLt4kuXsKYvhuJR2oSPbaQZ/EHrQnHCoc7Qqz1VKIVNKqYfR6lGmbOpMuUy9kMVwd9zhVuG3FtvNy9695IJX9jRe9+EueFXvoYCnm/dS4NGBjfx0ni2Y9rjIL/o/+0v6sYa5BmHa6c7m0zCnCjGBni40Hoh9W3kIYt6CUdjOevzMLmgBaoGdOmqvPc/Awm5ldjfh4TiWraG+B9786kM1RYVsXai1y3K3ZnmwkuXtyIJw5lj3M5R1327GmElFybXTGcKTDxIEDVN+WF+UKz8oL2DLtzNbfmei3Lald3UsB+O8f8fw/h3L+0sA8qLsp6Q9EYwdbOw7+5tWP/cX561c7OygSTvXedho+6Cg7E7kxsvwAi7V5zEEnqENu7jQjSHmAeEulMyD9exWqMjent2Ox7DYRfiSdq0THXE4MWDM78vSQdtdCx4Sy5qnKLVvYf6xy9kzdemAd3Ueqf2MGGuMF9m/XF8KQaScogND3A2orZB+UszuPyBacx5HzVLGbyFsPu1x+BFWaLALkgtCteRMmn2OOi44luW9yhqzWFlJdjySQsnPt5SLyxYKsp+WASm4+dsZxrP8DC8IHsCTJ+P9eNIFwb2zOGpBx1ZUjtXTKx7sLIP11HAWnfZVPX11kwXkxIuDBu6ygYENHLaBg3y2JGsuau9CtWobQjsRsmvKjrE1pZhcT7BSnHg9Ofh4rieLSvF1PdGXw7qe6MsAL2Re7qquJw+opkfDLTtX6IsuSJfriy5Ve2WMsCekVYgj+bGfm5eA1l7ay+epS6u43lOq50EPDe+ncs25go2Bi9PWfI0T9ucr5ZqQL3PwgVmmWDhSMr6CT6WtnK04ZY2WOcTfb1V5ymm0QCZ4FsOKxz6vvffheeKn996HWUD7//hMM1aIPzyNztpU1HKa+Yyflc9aU5DrLDoNUpbTIGI5i3YivNNIXFoqcakcXZ0C5JeeQBjm86J0iuiS9UO3QALV85VUZURYfrBardKKWT15XuS78Lx3Nic8H5zNQZl43uAi6hZZrLbYaQJF7o541S1m6Ux3dyJTYjPHhU72Kd/Z8kTH7O4shzfbTEmRnPenFUJQVAjB8pRizi4ne1pOdj44lrlwFk+Qlp51YwU/Oz8LR9zauB0i0mwz5udnqRnmHejLV2BW+hq5JDaPBUxQCdMe+b6mU39Rpj5a0WX0BCOJqZ+7qb88NvVXvi6mflGd+kV16hfVqV889qm/Y/OpD53cUwy31wKHRvM4F0b3zYRtlcLQczafsVsZYuc8suk6BR3OqUzWc0Yn61n8AyTUfcw28HrbAGq0+hQc/jNwZQruKIWlV2C/Nd8nSJxz6WBuZqvKSlOD62eP4vpZ+dmqzpHKXC3xG0om3B5ONc695pTFTKhd5fTWKRLYVHyuDoaIqVF7QiyIRAnh0IgjTxefbQ+w5CVYZ1vYNKMlK/tKp3PhIW2vlEJkXny87HI2XSulUgQGyKXez6njVYGPYhNR2CyAo4P/KohO74FCJbAJLBoHny3Bizh0iYT2cGgfJXQGTvkUibKfUb7M1S93cLAJRaF8NpQV6h7GyEE09hOZGplomFiyktDt6UWed62IXQMSXyF3FBFFELhFkLDtvmNINRG0cWJFxpa9Fe1ILxGlTkgINoyEgGsBd/YevHbSPum9wuyYkD8VGZi8NUhdkI8D6Rd9L5wiUlEbVr9XUTZtm0BYhOhQaDoE/6ARTvBRfuSs+Nk7cKPpkgrsegQVQFLTgS2B30dm6xiTZbh41QPPkNTWu2hdh1AZwIm0KNuulfKQnWv7+y+/hvw149o21G/lnqDfv569r4rrDmkC4vS+r7qTqFVsBXj4LhPX2BmkUtknpCF68VSy5yE/SwcS2BZEVcPCx4f5vV9rmN/7SGD+56Mw/4uvF5j/5SOF+UBt+wTXAQp6JINQeSSjYT2S8bJ/ARhzXz0VXGSM7mfn++dy0DvfPwti/gvFTZoKDNXMTXAeUsRVaxHyttqHNyJ0L/zxq3ChfI2dZaEIO50/ZInlQXyTFZqxztQqm5op4pREKwuLCMrluDOPmuCRhokb0rAvA3A5CqQFl7iJA5f1jKt4JHi4KL5fbDv4SBD3Hu/0Q0+sH0VMlrDYBGgVqf2uAGVH3IGRXW9NdK4mopK1ZyAk3o2h0COO8tEoab6muf6hdRt8FnWEuw0UcRvjkHfFCSWDIhkaXytqd0A8ZyeVy41N8itvqTZYq4/7d9afpbZB0BYCU5jgZq8kExc/1BfGWp9fm0eofmRoS9P7mDH8s5JtSeMFYo/rah83talmT/o8PUmTwzX57a7D3AAGJfsYsBXgViMjfU8OCX21m7KLv8b9/ZdJMUH/YshFynLL9TTdjxM8L/d1mN1iqWHtexEc+V5U4en9k6oNe83L6Wi9lgEpgrHvcQRX6XjxuUMd/HyPH7CUW1UygAeQAav9BPkQkFTtA04zBtBCPOpHFJrkY+UcyAuGzah4FShQkYGNbaEOpyHmfNOF5AOJ1QCM4rkxDyPuLeFznPv14sLvE/HfZT2ZaBy/cw01w/YZJ6t70CLSW+mRXpUPYXCgqzaBFtTxWSbuzs5lykIICRewipBwAS0J7ZajvVid1pMnal7Z7yodVQs8WoOaxvLR0xppWEzcmLGoU01tnxRBLxeb0sQBjjUfKPHST7SNiValfgLDioJM/f98+H3x3xd+f++P3P+Jqouw+Ll759R1Mpa7LyMLcewW4nhyIXbpkoomPrJKQLqwGOsHP+cW5IBq2c+7BTkm51GKYizI7qoc1axxk1gzh6q0z3BJsALrkou4WEcjFp5A7Wf5EytwwI27U5Ui1QN5LOjBTwpGV+CKKdJ3eMz1oA3agkg7EZtlH0MW4JGQb1BObQ4qb8FJmXooD8SuhQl1CWuLOrZj4NylXIFWgO90zQvxqp2BYTCBCYyqiL9yeSlC63TM+ia6lBlsVvNVLprJ3YZ1Zh8hQygdk5aiGdqD7BeE1/ZH7VClez1ZJsB3e9m7kAUGlhSmdlaKAq9ZoPGm1kekiQlUN9RtIcYXD2mwwA1hmeI1607KQwTHIxxYu18+CsPQJRRoBWrDc7Se9JvR58x0GePuTLhpTShAQupywFqECSRKAcrwTN9ZZ04ihlmlipemcHMVEFWPVtIiQFtQOGQMsFtUeC7jAjJQPbvew6+/82MPf+Bjn37dDUc5GcwWH+sTGp1t4EOx8wIXToWPzdH9cmYQ4h7dLyuqQCEydhxHzBwHdmHMjlT8kCSqjV1VwY5csOGCTfiWxpGvaGMnFEENuzHIm+LEKg+q/jHyyKlhq70dwfvU+caI+s43IuqBPIeLzBubFYP8/WSTZrZcsC1OcVujzWwN8vaJmin02DJee/by8r634pewwoZElG6sjzjhoaoTHmpo2pGiQY1JdxkNqrlio5Px5YNBmyjH6alTk9k2ag8HqsDiZ7+C0XedLKIyL7kgxAaMYiqy9PWQI9iPSyyeIr9PAR9VjJuAwTgFG3kTSCND5h3XzglYS6BhFegOktQcUF3PhNRSB4XqxsaMijGVoz7SpKWQAKmdIE/NYj0B/r0RU/FVGFYviC7yj6NvteyPhVxvmxYLiqgXRXdP97OPhQp3HbP36sLkyP8e4zukvF3rO0EJiJZGehOXWVOOrdT7Lj9SU9agLm6ueP36pAcdbwjetYLLnruXjvz9pHqVwps2bdSkq16x4LnijVywiAZgiTBlws2qKZGyxFoKLO575E3ivjf1SgZuSigprCiDBfuetfzdL/29Z/4Uhz2Kh+ulX2X9aP2tOOF76fHFDe/7Wosb3vdIxA3vHxU3fODrRdzwwUcqbnieD7036fRGzul51edR3xcENfhKB8RSwIGNIxQYa1TANEaw3LfuOGtGtO6nhzwvqHBRgQILvVG+KaJATTTgNeEYaSSpppuffajKIfklh+TjVWceOCQfEY5Dwgu8T41ySBeDWzhqOaSg/wlLKwLlkALLIWUfLvmiYDO+6Oij4It2lBSlNUpRQHaUXPyfxzv9dTQDxTJrsD/GU/+qrtwPxs4HFMZDxULSKkAdJg15ImS/oWrAUHr217K78Ub+lPOJUG/Z+oTAvTZwzAaOemb+indjSFfG17xYVc5N/rvshwMbOGwDBz2qq03PDWarZLHkX/BHEBzVqbF/ymJ51C6WlAx0Sq3LCgGK8ZvolBKAiA81EBKTFC2hB4hra/epIfreMxVfggEu/MDuPuRnGRRXOkaPIp9VRXHiBFyqEOsnmMa4uZwidpFmTRsW+N6DaEovmvMAapcZkLg8mujhaNmjeUKFtxZd6g5oCUFaxi8fYeDKIyb1ghWWzNE8vjSKQG082tVbTHmnahM2pQZeGvqiQhs0VXuzUHYMW2muCY9Zbuu8npKMimlEzJNHxj2+4oD3skuVDsAc2vxY+QDiPHowJu5BDxJUHY/xHZ+Y4DumxXI5J8l3/No43/GMkkrsrLAYu6oshiZ3K8mrExyIa8HFhhrJo19f44lWKHHiLovOqJqiWeGIBVmbwkoc9sF+UNGITqq9wEHTb1lqCQ3GkDUY+3tkufA2mbi7ySM8yTwz8xRytzaq6+tjkUZDs982FjfNFdaAecOCfzBaaEdiwfeFIIKJXPyVgD8cOXkJ9sFoaMQNpaha297R1wxVi1MC4r/LILeJyAeHDSElEwM/b0hp2EVVHSU2hbqk1ciWtdCBT+X6LeZY3kr1SjC1KOHQLonldH6I2igk0zBXWpk5ECqlaFcqPW/yR3nTTqDMzIFMh1VNljCq5Y1x+tdCbyfHR0ahLQLpurF836L6hqVrg3IT4EOAYcxnFU3o4ouhYsCqtzGklN8rOwehIymamuJ4Uk2wCGy1xYE0t4j1sgMyh6QvCV4afJ0/b5iTAEMyIh5UO+Tv86OgXHYUDROM7sje+2A4+n53yAPoqVeD/t48qA5XKPZ/9wqPAiPYD4YYGfGZqUbMAxEoR2sUEj+RqgOmvvaE8VFbZyONHhsEBx9djtAWpU4CyHpvIw+pngfmdMAnrg8XCrZfs2GXl7Cy4kj9pNth4UeVllWb4oOQK2k0YKyld/sx7jsAgP6oeHYKfhQxiz52U0R4knlm5qm2rYE4ulJWHC1jW6nYgmN86WbLJev2vkYtwNHYnsIqSHU0e0SbtfyI2rfCncqlPbXtqn4i4ajaeKlI+RtR6ETJ/MaUCaUbVMSsBWB8nDklz8HyAJ+wA51K35c3Sjqj/lYVWtaSUFgq3jOojbI9NdO3hxHOooLrAqU8uv2sUEu1E4TbQ3rNdo+J6nKUmHnGcZyHgx0PVCH71Gucl3Cwl04nXH2HygFOEeLU63kQYUSMSHi5nPECyDoETqGkPNFTm+qYBH0ZFzTh9IAbo+2zp4t6DRhRevSorVMxcBMHcQ3iv0t7yl7iMJCaGzgQw1u18WjjJdy2WBubmsaG0sRB0ZKjsTqFGPBQG58Oi5R/jjAZCiA1F6NLM46GXacebfqnwTN/Q6lmHmJ0uAi1YI95eQRFl5ST4xoYf6eZ4W7aZJ8XJnimXyf++5Ze//lr2d9IFNjqgAvtwR69WibgGrvMlfEjM95VWnK+Zs7FGtRkvsYMmPIdHqwvlPfazptmrJl9/+2fMNOsC/p0C80ncEX/91Nc0T8YRI5Jd6aaLXpWVjAUOL5ggFvoCn/unKJEfR97NMf/TqwTyiGQp1yvHJkIiUBoIU/UzViDAuh7KJUgZJePmgDvvr+Mn/HRN33uH5S8JZI6LYVxCLO1CVrRtIRPncWOLZ/VhWfU2T74zDyQfoXT+3XX49evP/ydbz3j9Q/W9k72y6U8mn4pWfec3TiKHusW/JNfuy34A5tuwf/wxFvwT31jC65b8I+c1Bb8qH/8Lbi6IHVbcGyQsj897hbc7ZtPdsP9yLbXwfTt9bHHur1G15iAR//Xb6/D6vY6HNleDx7R9poM000nubkeTN1c0+je+qg/trd+YOre+oFHvbf+k6/53vq2kb3xwK+2gtay/13dGnvYGnc33Rqf7FY4zP7MboVpyk544NvO/mp1W4SR0Wb4k1sjb/T9Tq/vW30cmSRB/wq8j2yQOOkK0MSAfDFhV90gIa6IgARgxMD+mA2Sqkr40lLw6lE/EOPSHkXP3HSDdLSyQQqmbJB8s0EKdIPk9zuTGyTQDKmfwMPZDRLpcgo4BqPbI50scH0ydXtE03dH/3a7IXqMmyHvEW6GqLIXCk+8F3qsLMd9XzuW46Z/3Izl+OyJWY7PKMvxDZZjPUqwzwVtaej1cjs1jnknYDNeVeUx7mIe4/Ob8RjTGIsQM+JOL4/wHHh5PEYzdMJhDRI7BZ4+D3mUWDaDcTpvGjLiiahLDA1QnTzG9gl2A0FLTRqbshvKZLS1R1xQCNZCWI5cb6fnGacd9sQ6EoU8uZHfoxlqcUCZCmptGHYDhkfBZSyYWzGZMhDzptrWBIfRKTMgcYLDaIOwLdDcphzGwtid4Vla4C9xLYNSkBEcEB9C4yHYJFHdANFuIq0lDFuL4zAkh7xigSKKaOHKng7SYcTEFEtMTCHIbGhoSZWHgICL7656/Iwv4KE1PMXCFJ5iAS1WnsJIEDlOeYpj3ihPgfk+wVMg9tHyFH/zNecp3u75vuMpjlUlSGjA31oyNWUBCoxqOJ41FeLgUVnbk5KP8LO/Uz7CynqmsxvZWiUnt8aZIw+9V+gGY2pTPGMlB8/MPGuT6lCVV5q6/GPlVpFE37MugcUFRiR62Do1nZzHBGrGRXrcK+puHpe6vkE/OGA/pdEMWKz5U3glVA7giB/HupMSclfRwJyuGKarZSw8hlIjipTouDU+lX7wUir3OducOAPT8y5DJrOeuXrnOrBD/gG8KUOQ8TcdmsEExKScodkRhiCzDMGcYwga1FDr/jETCfUrbpkAuKGfG+SY1YnO6o7MapYYUmd8te/Y1b6jq32afsD3A8ED60WXm4oVyqj4qINXfMINipSgszuLXWq5JAOPKCSUs+HZxTM8gAuM2QPqbh7RLUT7aDXoQ61jDI7cPWZw5P3O4MjdzuDIR9XgCBJdHRHBus+B7B0QqZVN6XNA8h2ncnVd/Ryj36EdAuOyph9XK/GlI7Z/2RfUlIu576CSuU+t9LCJYCx7Zbl3fyUwzudwoJjH4bq8h5Luc17LjRZhHkFJ+hTYcbFW76eaq64b0/J4knlm5iktBrJiwNQafpI3pe9mkYzFAKH6uE7BILTbNbHgJCYVKYXaIuNkCuO2GT9eyOsFPwiXc6FfxKtaChkpaPdGvgijx4tr/eQl+ZLD+2Uu8ODFedfpM22B3WRwitAAZK1MWiD+44v/vX4HimLFqjjXQvlbKYWPr214ZGLbNtRKxPY0EWxdhPi7tMczYIO2HxkWOeVCFQizlWiVQgyM8pA4iDu4mBfoMdfgYxIV+Q50tofle6ctHXpZVOC+tsZQiKuppOY/tlF+ZbG1l6P+nDiQ007R8tZaaKfepCQs+DtsibQktC4kokJvKnAhO1FIzhEc4Fi0OJSLmAWuSWoJRUo7BAy0iEdiulhsH+R5/zquZ46bnQlAthanKNR2FiEGa6eWsI0Ib6hpm/EYfQok36dwjbsQH+KayqlcdS4ffK9eoeUKtkkFnbICWy7XdJrWJBXs0goAj11agXX7E2oyKshDJKNs4YsF9gG15C786VzzqcLjnMowEO89uxDFn5lY0tgzqKAdR/Izqcff5Wfxo3NNfjat4u0cygGgB+vfmz+BMWU3efkTBc1W6Jy1YoXvHMCNuErVgYIlXOfpiUCRJ3HgSZf2Nkag/ORBfi4ZqM5yoHugeAru7mfED4X5Tk09VWFzqoIktyA5l3IDkp0ACRDl3loJ9DZD5VwHdAPUgrjanDr8zvWFsA+QUaj1LWg1C1zxqZp7kzHGjWg0J9RkHQIkoyautI2lXw6tz+PwPRLOz5eEPRq/h4NHNf4CegLWkAsVcRYUzvlTBQyFFE0yp05R7yoLOMhJz+YrRqqnxym76RTsfggc4DaeFNvpTDQtKbYPi+XjnOGE/TqFOMNhSgFiVeULNEChOdvZsv7evMtVCf3AtHM2z0NahfEEENUQFji2CdQYlYp86JgFmFjDSsUZttO0BKjChZaybGXwyzxN6ZR8d9p/Vf9aurDHwNlFu2537vSK/Igrh7aMFJq3BWqn0SlMONBu1qaleBd3swhfys7B8qdwndf1X8XlruVPsH1B37Zq3w42gAGr4rCJRJmQ2riw/YSX0cI1aPJW6tIp9JRr3n0zCPuH3rwHcf1Q8AYPsp0C6hWnqas/heAW7sjygKndGcR/V/ao2pHRbjxhrNkXVZr9tBM3G4OCpj8BTbedeArafWmPY5422pmLTrozGJr8IV6Y+z435aXahHyNTqcE91KeSN5+rOWo9Wy2kyRjcaEsPhBGNIRrQTqMGUy0H4Ji3M0nziaFtM/gMhfO8Gs3Ewdrby5m1BqiPv4bm5lGe7Ff6sCWw0twCV1yFk+np9PMd/cq3VnAY8H2qufWMAwPmudTc6R5aI42jBY4rmivccH50+k0bTUD1DaTzuD1fwYLnEjHn34zRmANDYZ5ZniU5h81EMVf0SadWLCdCIm/Gu0EJ4ocuqdr7tmwxHQWfk4x8D8LbKbosYIa5Hhk+cWOgAj6YQbSxQO1e6LTWceg7VZ/fAqG16335SKKJjCKXWpAdooWawjQXrNubVr0xVz0dikcE2CXLGy94gy+Eb8Xk+HIcHD8OnG/EQOBP77dtkA42sZipI3IOL7LHnKl47sUDGc4koWGOJLF1Z9B26XFsI+ufS7Q+W0q0Uf1U8mSGYfTRAJo6jaTIW9rNVOnJXCJDJNir1p808CGfpVB8pBP7ZfKlEQzjrx3ykzURi2gNQuo/xHMPV/m3tfhrPNk1n39z7ca5lttdL6ldB6dDw5qD10A9upceiozSvSk/Il0KnNqO5kdfHK+nZ5EPoqR/UDetvw97tV19/jHEn5uuSC4G8/lC4KjCS1QS2wXi8AnBhBm+JkzDKXDseWcZ2irtPq7hXNG24kDgEAICKiYSrZshn2Soiiy5tjfR/l6+rDnRddRIC7OyFvDczfUZfYT/1zaw/ueIjyg3vfF6Xuo3tLq+zFI6jWM6kjFcaWARXevF+Gat+R9VlG/VFhTFEKJ5MUXRbQfCA2lLdkhcpCbCPD7wBcfY4kM5iwtsZPOthGFmnbrVZ6zwAH7hOZzXtN2VFTX7bhvtsxosbT0BCoi/zBFReS+MKzr5tOKwKjqyls39yE29xFhHBBnryRQfGkP5oEntvd5aDe/upXuIpQAYhCDBRTjQpc0XW7qaj65spDgkSCigVALQ91EKMNo4+Dm7WrWeIECRC+IUVWIh8ylz0C900moy6FQKmtQk9L3waKACP+zf5RtfnNsm9+8QJwZqJDh/jEhw6edkOF+J2S4T4UMSHT7/zqx8mlcFTLgYvouLaIKh6TsfqLdb5Tdbz1e3UfnWyfdfbRdZRyhlXFg3MvWO2HNNBlHPLKVDpyV5e+s6alCiVJ4Cpn3LEIpsScfv+qOTtYXWTh0qcBBqJx+YsUIBHtvzGYiI6iLRFSi5xKhhEMrLIFeTtI/eBaEJdbMt0i1m1Zv1B5bhUWrqnHXFhNbIuSY4eduyDpi7Kky8oTszVK0kc9xOQe7ItaYV7oPHy6U7i8SmiX+Yx510UguxGPsIopYJg+Siy4emYg8Ei1HXFStUJeWKcEfU62UJRdbjgxhz1okFyuAxwotGZG6grvJkouucW6+qJKLnngyVxtdW03p/C3X1MOZo8ZQwscHtCInA0WXLREVyz0unEPEgTZt5VoSU4vagOLc4iXdlkjzcvyScCE99frNhWxFIW2O4ADHosXcHUgullGQlNCDUTuAgebwSEwXiy18+tm/juuZEeHCiuyiE96+8utywTKHsg1dWkE0aurqrhbW5GCfKtHkBFvPBMmyq+0Rl93dvOztlbLJlt0lMmVvR9nbtWwyZSPZCC0iigH2JQgbcuiAqLChoCjfob5FKed1eFzQsFCCIaMd4vKUAzshaKgC5ZQB79VN32c4wBt/dpI6CyGA4sysdmOWu7G10o227cap1NZugA9FdxNN1m4gWUBkQNAjrhCs0HbUJC6DOpRoTS2tqcU1zR5/MGZR0+wmg7FF2l60sMlvixH3rNg1YFkPTN0LiHUwT1NA5mcAt/U/9Uq8HZyrl9rXJV32lhUvdT5ldj6dTtxT2Qu4GeTQ0sMcWCp9T5vCqKXypfz0TYvdxcVuUTNbRZcr4T/eB5zJ+wDi8JnYBxy/Psh0fPzxLqBF27k/zEuidp/LJYaKarsO8jOZMQ+o4CUJhnorbSEuGU8umsuU08NlOpNIp2KXdwRbpPcIdWkLj02Pn92pfHv3iLSWusy/bwf/zm1FudyBsNKBFo86SGUrSFMgtkKrw/HYtCSgaFJ9woNpiYRCLeEWLguxIG7UFloxm5a2aS3aqZsWrcpCbhk1gnKk4gxDQYU31DwOmex4kFECRe2p/W+b/rdPqv+KLfAwo7UpjshcaWrNO0EuFvNtgistU/MQ4B8KhfVpWe3bCdT2iMG23YOh4uoueaXBQPIi3JWYzGZIjIG3AeC3UsJPDU9vpwBVQcea/0wcmr/dwrSFB09idG1ZSEuxTWB6Kp0BqgX3DxCB0qJ2BRHh7A1YPpU/3JnvIJjY3Aori/kWYum4qiSpSzOzRqY0C3UUHjjZAjSF6vBTlyIsQ3YJaptFaHwJ0gWIIYvSLVWz1uvb6Y89NmduD6yfhDO3m38KPN+d+LXO3L78f7szt6l+tE7WbVvVeVbpm+vrzXvbZi7bTtJPW2dqFx+FuzZFQXXXNoFuwLT/69y1PWrc2hSzJv2zfV9pgPLYT41u5j6Kd93MaZJs5j6GYKpKZyF+arzrFfMsFDnnO6VhpL6UIriXPYwR4rswFR9GVxcxHi90PoyucD6MXv6YfRjdF8We1QB3hO9Y7ZE7MsKYMYN1iy93GDDe9/rZvzwefo2gpXAc30adR+3b6CceoW+jDNeUEpiT0UUtzv5Z+idb7RiPlvjbSsUhuz53myeZZ1bZF4ourFqlyqN+ImrudSh0IKT116EJEfFDF/1AlazbNKsrcdXVnbvDPCOx5D9HF0qAOUVdNMMxeOyHkoo4o1/TSm2x/MfTqo1yOaWyR+bWt9F7NCoPpK2uhRF4BIqkkCuLqMelzyJCS6q2sCY9KL0zCRsCP5XZQwBkCRrjnUnm/x3gdYx3pqvx88Kp3pmumPTO5FSOnu9V5VKRxuql3IwfHhoUEdQWVVUyIbUwC5c6aj0xEqSDc50I+PAVNJeD9Mj86hzfEO4LNzOE+yBqSz+bNlKZpk7Bo+zVA7X9Tn8DamIHoF+iihcvpBjE6gp9+y59+3Z9u1zfLtG3ffp2kawyeV1lTpjKEKQpO9akGNHPYwUksbaHtWY/Q/pFHAGDUAeKFMMdHID630vtbIzV/kiLUkAoFDWHNiz0xQQMkbhihk3zASsJU/AsdT1Mafb6Q1JC/xPuzUkH0UxtO7JcxNhIoTSH4uwNNuuC5JfovGNt8GTVO34A+y3eOrbB2Igm0hOIO+bcbJ3HyeMV+YIKeBb73iViH31ZNy485vO6zxaunLnYRfLBHS8YWVRILRWQ5b4rs0eLmEhKzA96tIV6KISZjlVaZS5n6x1G93xujbocU659xPbLy5cre+vIb4qlo8OhW9nweQjpkeqDP+QX2/ht2yW9yjmzj8nuU899BZfomPp1YZRzP6X5SuK83XmqhxZzQx3guShPFEo+pSL6S8i35xN1oZmiCOxE2agkRCHlIEJMRh3ONjKCha9M9LKOYibUbNlY8buk8LUjak5PG1KnTPZLoVRbJCo5I1+qr5OPR4IhSiC9V1OAybOh/S76tagAmM2omTyzmGvrXRxefyDnSwkRM9WIOlpQtxDVTVAVOBahFtG6b7eNXFFohZTKDoZ3X9qUbQIxD0GZHXNrqoSP7dWx2gHxGERHiH93rSuC1FWvvG7gO0P4hBbXhNo6eGvzzI4tQSsThT64QXXvDX84rLn5Mob/T0LyXGxTqPIjxDEZbcPiGZMOF39ylpjBRGg3BPEIiZHMBYTgWA1kFcE9ahtTx1j1x9VMJowsvhFjbaHlYHSWoFGErLrDHe2R6kpGlKIrqZW76GEDGlwkogovd0dIwyIx1Ptk1JNZUaxeWdR7OAjlCA5wrPlA8Nt8gp5Ll42NzVgIjsZ8WWO0Z+NRn7BRv/JaG3XvWBTTb8tv9tLDwYi5znjcXCdF2VenWZrS85z6iCmrujNlVZ80ZeXSJRWdfcTVoPWdtfKTgxhGc2eDatn1eFXev064lmANFlPdGLaiNdmV7ZeTKqlAInZJpWLkag2an+hAxcRVBHuedCkaYk1c6TwP8ChNXAUTJq5CbvnPo+XETBb2Csie1/lJ4aiJq9gpar/LEwO07lZKrD2sC0KZUykgSUPwCYvkiEVPoe3N78FpG/TcqSHBXf5hDyiGPsSoP3v1oUdv1LM+ennlW3Fd4y5P72vANLRRW9cVPpTeSWPRJO2EmKfNbjxk77LEm91lueHQfwDLnh+JAnBYkbvw7hhHAOIeuMVUFDvsqcXvQ3h6F2Cw5f7Ky0e11K8efX2hZrqCH9eLyfXgeYQCR8ziBdYsXhFnf/9aPMXOdf0CZleUZ8gT4cfEdgf37Vq12vpSx2NgKeM8QLzhvltmdREflukwoi168Tjd2vfxp173vW8bfPbiIYoVCzW8o7ztVvz7TXOZLsX0FdszHhacASWGJdww5itvuPs3X7T7v99n6tD99bde9qHfuG9bzLYEs797jZiRoQjz7BJt9UXa6nMpopa1JKFhtVOvrPouPMiTzUEEbH05fl6KJQSsY0TpeXJ60gAn26Qo+xdADHmuKgJef2XDFZSH2qgAFg/QHjWM/qUanJjdIZRbT7flY5WvtykVVyLKKxb1QSHBQzoOVdiqVYeITJHZPxknnatr2b9qUKYar5oIne6HMJMhcEgUDuhvBOZc4GwWiZrWg3Ur+wftmJYvE0cXJY44OH6N5c6JayzTYkEr9BLJjN63yn5Ubm7IDROX+DejBhZ9rUoPUywpCFSOxny4//0FjoFtUgKt+ZBjLzNxkWhLeIKBoCzCSXGYZBa2fBBjVMCXEHzZ/nvfX3AiMlzW638V3oo48iF+1i/tAeDYmr0bsBHqmQeb1xKaWlQCJg3XZgcs8t0vdw3kiwj5VK2lJkWCHp/uJ+eb/LnY21fqAnKitCbRh6M82XvQqhX1tRSJL3ykccOU3vjlYtNJs19E3lr6y74XX+dgZ1pnwaew5koVzCgWqilqUNs3Vqb1QFWZwwQMUyIHz0UMDJWiMT4UllDCrl+/joV3jivbhAQ6RInu4uu69mCstBP6mt2kXJwbN3S0bD4fZWMIUV1YGcLEDmF2PXBOe5ZIwUU40iBufqUrqtRUbVD2mRtOwsbJmw5NKrDAuMqIERVdxCzwvf06Aaim09Qus//UDE5ht7i+u8M4qvaShyo5vHdMcvgJJznUJCn30wiKpAZdx/QO19Ro50JRxyMrdLNdNCiGER3RbRc7PU09mUj1ymBLt8Zt3SjP6F2MjmJwpvc0ZoU/mUV/QTZgngADifd5oDRasCCvi2DbpMGU8TuUbnQTsoR2La8537uSqehKtqIhm90tXMky4BlC9M5f7JbdcEQdRdHlvEZbLJpSNMLjo//Iak7LasDcmmKuoTgNbMNEOoGZtcz+0/g0CLx6N19VN3ZQJjiAevdKc7ahHbtyPoDPyTg3K8RwxA5RabGX7aHyKTYUd6L5coOUttNOuCPz8wjZrUdCuaO1A2e3Un6D4CEsga6sFJjzEJcXSwM6jbPVcQNNxeLhUdAyvJDaxNAX8StrX2pq9KKhFYjLs11VNyUJJeLIbBcFuCXKUXh1zswguXImveSaVl0v0AP8zZwzcLxV4t+Bu9wRLVulsmXawUHtewNv+0UpscYdr0uPGrSDamuPslNbqD7RKUDtkfcLfQKlUKOydBrioA5RyKjUKgBzFUjxiXWNJsUG48XmKDYnUoglecElkULMOq3tIQvrp+C7rYr6NXAMBjGp1vbSKa77dhn7us82I9HNk8lcxen5Lm73LgUadFrxLM6AW7Uz4FZNwJHvklZjpuCBAfbFzIYyLvO0yKMGu1sq73Ws4ZmAS98zyLlLwHomhsjY51OFAbUHABhyAPbpBd6cUaTGZ9FZdKbRD8ZRKyjELH6EeEB4wTBvIYKfp1GqoewtQulDFTCCwGEPNselz+n5lZK5GsXci572I3BXdB/rWe39P3USZ7U3/SwI8wC/5qxWPcN/46z2G2e1j/2sVlFQz2on0A2Y9ijOar9xVvtDjcQXLU490hyjD5HmM9d/f3bs+i/elSXTJL3+i6DxMhD3kac83GEDN8r6OIJaN3x5id/gt+/31sqzXo4aKSM7LOKWujB99p60tWdFQd6sFjjxtcqUmflLlYilaGWLphmYactRZER4knlm5mmoVj95LuqoGrbCxJArqoHcKw9xNmkFsvB3m5HaN+3QLB5z1KG5q8q7Ik7dPpODSZ6aEkstsBdyXqgTpiUHk3jsz2cp0INJqSe0xfIfcMjq8M6CF5w1++yO8Ip8mz1xbctoFggpn19ZZD0uF8VkWka1bWh5Pi90XzWmI3qMwGr+GwKr+e8ALAj2wQEI0Bbg9oNzZL+KI/Lsf8vu29kjoAUQh3maL2OORyPm1HETu6/Bbl83AuWHz+dezwmUq+vA3Cj9mKO5Cv2YE7KNQjcl3TwcMUi3mBONKdRZ2zT4gPbP4zgqO4yOcd3Iw68H8Qp7VWJQUe2k6Y0WPYa3jMqftVS/4tql63z+tce1Hm+Fq8TonjFi9DFHjDSpJlfolRhNYxQbgqoJ4ZlJh4OqCnoTLY9AW/CIYNWurnZn6ngTGxKyD6oTbALEgsFJfzeO9ymTPTc6hTcjqE3Bb2YwEJPJ4VdRV4MqQrCwX1VOKhLJPEXCz4nBiTmux3RPstCc7ibnd/n7aP7s2iW4xjaPIviOv29IrCqfLylLtyzZwJR2QRKlsGILLYhP/pW8ZxzVJ3KAjCvbYEFXaJUWhVxy+wVAXYy49DECq4o6z0W6ngts4fwLB/SdQc5tRD4RpVhlTW6H3c/WFT5aUr6VFhkqPXPSsZXqo9taPSu0R1cZZmcmiNOjJWwlVoFNq6W1LABG9P2xvcUtRdgn6IqD5+0HkKpbW5JjE1wBEMs3SxhOUZl/oOb2taRQypdtH7bQMpT5vcp+eavs5urgEvKc8KzlhZaDraz0qo74sGZgrPDbavdyPBOKykaNEQMkJpMPGpSPJJFAAvgTKf5YrfJVC4h6vsrVLdod6SL1OGjajbf9+TIGnHqm+fzZ2tdFD3QYaVmJwmjtik9aaxe10hL/opJ6KfPWsMrCp1WzBDRaMpfyFFvszYIuGtwVzJG9EwDk7+V6deLAS6i2QGbHEpqhVz7kk2LrVJ/1DWEjsWNFLwS/pxCiQr13aT+o0J1rkWPHmrsdawMw1R5lOgl8dH6rtBbbWDQNWL21QsPEtryn8KOGgL8JsVF1t9qUzWuemZ1tnTK98dhUkxo7aAc1dbdao57ekzPzvqiv4Z0xYw1Re5Q0CGyobjes1amZ0hze5mhW32CbSw7IZ2DEp4Oh6lCAHpGosje1Y1bTS3tZR7cjbl4mzZPVN0IjiQNNoz1ljWjK2SIwqZTxN9mXrZ+MGBfyTZIvx0pXn6/abJCM33LIGE8zB05qGc9Em/O6i86zG6RvF/6fj7it1WaAU0XKYuKJmy+gLxo9YWv0HpiTpPOxDOsQCAVV2VVRF3NEcBc7gMpepK26w15vgxISsiWUICNy30rNW+WLUmlx4yK9eVEXhQWzYDE2AD5qyFjabkyLZm9B3yrS9fQHKi4tfDPVBEA61UQxzfgXjtW/sPE+HEKnrEaBqJ7hmF+tczteA+bJxTp59ukbpUfiisXLfuV64w3j//GmXY4MyNNbfNgWXVjrccjX63h6CW9BQj05vJaDU7j0+wV0q3oz7sE6sxl11gsL5M9Us9sdWfpVo88UDI8UVSd2dWftonv2vm//1/zL0p+sSFwmOLArU6/q4XVIDfw3yN4ixucG1NCQpB0pMw/F9/B60XSOBpHD1smFDXMevX0P/fQXfv8533PFxcOKBz85C2YE0CJlZ9R21+wgYuNJNiNhniOgS0ylHM1QWtQRa3U5BxjhkF9X1rIJ5+69yn37shvaX/rH/OanU0ru5cqemLjKUlyChFFf9Cif43OA2z93/dG7X/flt34F+LiJy8dk5BB1Xlb+fviSfME1NBHyjAQAHgx5mL0GnI/ZNyck858EDuv4pYQ56da+S37+/bd98Q/f8PTvLWQ993B9Jvut1yuzal5/G6+lLbkZPFaLJZF9KEA0DPICgDGADNCKWO5QzFDMERwoIbhkNb+a4sG/6GJEZ+QL5OWWObOlkIWg7V2YNpODCDwylZlQvkXPwYHdDXX6DRFgbD9nheUh4b7RFshVcNjFLdhwKsz8DzeTcO+tWGEMXId3WIodsnNyDIoBEUfygmuEy/df0LaHlqIHOPs3Z19/61uufxqxJ+sESPDhH3/ZB4/uOvT0qpX3hBZZlIudDzB/hStyWOqCVzIyx9hoLUCJcZbmkXkLj5jL3KhmxuVPVqGySkUwywwy1u5H3yx3uMqiXC6w8LvtzP9uVqzQ4yh7OGUnh29ctWNsQQBwsslH5dltVqsuzH17zOm7Y041dWs8pT/b3bilIPvXV5df6tGqz2Wr/0Flba2BebWwaPZD+BTFpX8eep1JC4miqOpJy8nTfshbC8MzeqKsVoNDHPiDCzDrlB55yuZGpbhG0B3plKpuIb+nLf7gOU3OQfGl30ITPfJAV//0BndwZ/pJnmh1I4taXgNx9m0zikjWdwW0gj3hcUtNF2y5n0a5kivXXHmSUqJnt3nD9qOJfvBWEn/sNSilBvpUXVLR8XbfNK5VsOQSUEBJMoFxQ0u3LD51xFJuTCl4DXVTPn64lggcwEXGTt0zBcXADWW9g01Nnem2EuGrnFH2mvForQpg8Zqp4nQf4zhRBbh56b4CTI+uG2athqdUxUyGmMuFPAKeA9mXFIrkAbKAqyrZVU1qft73Yz4XcMtsaVBWKsxDM+vVuqDsTnU8YjzkzNxpbtWgVKXH33hh/81+auQhFClHRoGMSSCHOfaFJJlj0Gyopar41oePrFBOnQ8o6yP6lXlc8luArtbuhryIVCES4ATCAYpmlBXZ6/Yt0vmr41blgoDAIWkhqosJlSo4aMnyBPGigpJxvKo1kJfdi5YBZzArpa1KeThMziPJodCPRnjPupVp6N0ViGyUZ+KHOX5Jso9hGNMyoiWx+/utF8mZPwQpYO8v62X33ahlIR3jfYCTAJeGKPTyDRV1se7vZzuwRXqZrH5NRpf9oybH1X+tJ1YwYEKWy1KFKExZ/m8wdEa0INDZUI2r7DOoHp626qhk8w/8kQ+odUTtyb5KXL5Q3fG41caj6alePU2xZ2tQbMxZe+iOKr8CB8EZqbS3uhYFYvIkVd1ye/WTUVXvJktbwSZbzzOBTWEuKLDn6Q1MeWGc685HrrdRtNzSSzZ810VDavFCHN46xAarugBTwNeI+qo+oWofOC7PbsdcxjDrQHvZjyOi8J1Soa40KpFJHqFmUTBVsyioahYFJ6NZ5FvNIn9cs8jjyAdHNYvedmhSsyj4d9csuuPQVM2iYIpmkQ7KpEugojY6dte/WqKlFNWkTF/AAzyduzXSNE+pF9ohJNwNOYhNWm1VS158wVl0qVQYTZ861cXRy6e4OFLKYdVywKr8tO/VJ7kLQz6K8i5eEQj2CJWMLA6gSl0EkAcLcxEAJeC4j/9KlAgsSqD9DiUi1BBQbJc9YYNEmw+1uqpjLnZ/HlqWCrKCQDEAtcJfnzDI+BIhHEufp9/Ktl3JdgSi3EIlyCePEA9JM9ggkDJ3AqaM/2thY39yjfTNLEPxgpIhoqDSL4q9C/zw+y3sRHUNVePAAQ4OfUEE0a3QxRBol63r7hvrT2DZwMoKkh4oTf0Tr/MhT8H+9d4lKFPPM1grtX/0IBD19oMCZ56sIYh9WFVVh2w8uxNVdco4nGtIHGDy41LZz548foQj+OFtgh/BOH6g/w+M4sfbR/CjhFMESP07YchPHBdDfhKpj3K6/9TEdA+r0z08yel+9UlM9+PSMG+UhoWWht3qBziLCScvV1iucCbw/Zpw71evFVAWlzY8ty0O7sAeAokdtlMdT4YBvmUJ+7e0ra/xn2ZQIAHsAhA22Z83rN3u5louH1Ck+VPcNKIw+xlBV5Bx8A0h3MFFGgmGEhit9stFaPezpgL3PUWC8K4EF2PjEhP7DsSO3HD4fc+LHViwvKEjsnPkTNDYNLw/Gc1QOeqORSMRj5pQAoRWMcJCCxcgEInA3gYiTuNiIPEMLfxQACrIY6zHXAyAHlNtDUusqlDhA+ymY0r0tlEAj4N+iJBcj2ilVoJclx2GtlVVOv9IPYm4sQ1qHhh4qtkWdLQGdFeH3HNDLgjshnr0I/dWJX8dxYPEogH8kbyzpEs1xYQIKBDL9VyKKmNUt4SLKYA6MQ1MCtLqprifk5FLP+TpLNQxUm8oBE1WjQms83jyBVvWbAvxAhhxNIDUClWXkvzRfvsmv+bO/ZY32ucaYu3wcIKBONogzakWYTNpvWTUbf819JoO39xZqHjz0X071Z/dRqf1wRt1KEX0ubz9eVM3a6lklK3jWtESnPGogeoaxo2V62K/Bu+TjC3fCnIC9dYXFW1xtqEQaEkftKhGPkMtVQrCO79hfaIGFoac5xLqzqhlhIs8r2VJEvo2CwzPaBaNKWYhMAN4QrZVu0azPdFepUbe4R+akeIypR7N/nWoPjENUOAF/EKesISJhlQ6QsnpAeI0hLhWKIQAncrQDrTa6Ntov7w85YrwJrU2VP12FvECwga6UMOnOklT3f/OXlqEIoigGrqArrBkT3ctpqg2pm6HPEqznxd01VPhogHthIja+yEv4KjmGq9relNecbdBszwkGI4WdTA78B0UopQ8UZp7jr7JnrqSCJlRK4cSkUdtnB/BeVSkBjSBj+6T7C4ldokjdr8M646OwvkOsyeonS/ULi4kPhaiF1bnSlz51pflwUeRUV4LNCdK58kO4pLoUgKNL1cfEgQrfHMJzSZZuhZWadr/+RP/Nf7I5cbQrb+k8kLDJupD11bXRV9TPE3Rr1B8JJ86ih2oCMLfbx2nWAdTqAStCfXop6xALFhoEQGGxLfloBTC1S8WKhjyhAiKbHHVkhTvsnfpFbp0zB8UhQ4FXxPIhhnoZNkAnMqa0+GYIgxfVB0+1UvW4UslR17Xa4YOdDETR04AzyS7Sd1fdgygxN6iGeqaW7UEgnauhWOjl5oh1+uROr1U7Fttqldtqlc21S+bCjRgsOIL5fYV1JCoGSc9EUGsZVZhnhKVnseoODAIGyIDsFaz1rU/WC30C5Og/YmqCC0UQhqBmo3ZUt9rjLI9OtohtgBRuS2JQUgu6fVlbyKCT9VT0qGLcXkuCSRGfRInvAKZfgX8ipWoxKem6kv5Stb51VeyDsxRsq4hiUsUvXWWacF1ktYwRj5bJJDSU6aw4CvAZHI6yLg2SPE1wXKQlg1KxxuUnHyDGqZBa2iQFpxQDKZFgQGTvCr9xotg1Fr6lM1u4xgtxiB795QbOW9v8sF2o9SYCnkuVzWmjr6z1Ji612hIfVT8JMpp0oakTj+NuxNpqluFQlT+AkKy6wDOLnAIruL1UHcm0QHc9zWqQLopSZDHk+WyAfN0TXGQk4vjKYIy+Ebehk3PGYsTMQRFih19fhNB0UxFipgeubWYofRWqNFCgZnalcSmJDbLxIzPWHEwSL4eMhe83bsTdCox0tQbffwe1Mv13oEiVLnLO+A85s5gDfI4UXvpbwiBUDnv/Z6W0C3ivkxOvKw+q6fffp5TocmKb3H8XX4bVPXqCtHXDjY5BA1gG5aAgbC3IlLxez0RKtwrVgu0deRn79FbZOr4O4Oq45ABkAlg/DP5ozucZaMrhSBjVNCjUnRZtklP400WPqLPDuE9zxRrtErtmhlazkMzqHq3O7OlzBxmn753yM1p8QnsbFkDzVbP86i1fse+Vyz83Df/+Q+8nQ/NZ83Z4jVPIxfk0/NZQPcS8syBTN/L3qd6EKZd6G42yH5RlpKMfBM9W/Es917dbnN7MmnuUOE1y9/OCpr8knw8QwHBcJEopiPHVTgq4mbay74YNuogNiAdP+JCsw18vS/9gf/Z8rhn8G8l00GMWdyWo5YZPgFXqmImtB6/2bmSVLxMUhO2WTcYzwt8x+ridxSZS++4w+Ii6h253WEUcB42iSpZruw9FBSxEGs9GxmtJxu8dbOPAuwbLxOX7CGhBy1gefbLZo8dbPBUQ6x2I9iPMy90RXPo4YTKm/VkBdKoYx5mB9a3z4f2FBfxH6tV43/lkI0/OhL/vjL+3OnF7JqI5mqZGlpG4qjnw52ilZb46jOTH5kel+oxr563eaBRUfVoJB5VXYfYEhmZ2TeMsUFPGG8ZqpY69E+m54kplqNvOWKleHAHBZKRauwxTVIHRST4hSUkoFDp/G1BDIPLvvqmcn5SLW+oNDWiEGfDC/KQuzNyfzqUMzVutvArPIt+DADFckhRRXUlLukFuSArKcTrb2W0qO+H/QaXvepyNej7Oe8lc92UxnoJMd0ooiH5rHDsYfGreCtBO8FkddUeG1IBj+wDaNYQqkuJa7MeC4kShZiCd98VEV4W+sbBe8rpvSI1gD4Cl6wDtIXBCmLEwdQEj6zzA4dULdZYCXAX/iocWjZx7tU0t+P6f14zCmtoip5UlCd8FFYP+N4QBDB8ETgeyd1uHfENiKLP80mNct3jXbCpKkymp9f9nZCu1rCIpPLN3V4e42tHVf3sgzI5gDjATs01qlVSU8eCVLe5wa+eq5dFd0EMoNeNGHBq/kc84RN+2Exu8zx/pzBE4Yah7luYujc31gtf/fthsBoUuAO8gKt5i01Jqinm0DUCwjdBHEb64hajD6GRx+9LTHXNlmKiuMv8vxhEmB/qPNXqRuwrjOMBnEdX5rVs3HA+9YD3ImVanj3uTDgOZBeuR1ENznhgzegXijSAV0REZEVK6SBvybBFeVsmQYuAMi7P0CwlMXcMhuKApLfyGpm60Uyra+SAx7oNLUbYX60ae7eK9HV5ExbbX89+SA1gUCA6+r5Zlv8IemIqWcyOylr18Y/hH3t+w5c1tL1JTucMiHTHcB2G5FCOfPdha3BFV7sihWaQv+/bNra95nP/icdNS/wSN79sB+BRxvMSk5a5oSOWYi4Opa1qVyn98bBuiVsg1uRHjI4l67mPZzcPHtmQ4jbmqJpbRIkMYhGCQ5KbQ7JY8+v9mFyhcqgRpDAAHNgxOAnz1LQgc1jVUeS6ZBSLDo9j5tqcjfA6vlyTg9hmKIXdb7xDM5A76wN1gSL38ZANR8+hjHpYsXwMpwpQzVMb9DryolTIS0k5LeUK4MY6inGuvYd5h2CHBeV55A+FszDJu/auM4sXaj/1Yoz9sva0odA7xDX3fft92TXfd8ZfP50bLEuIwgK8prYx2UDPWkxeGa8H2qWEWgcQPUCN1AZCD7R36vtMLUv3G9IVn/w7tGkUDBUrAzBaWA754PzhMPGNl8YYlNZ5Cj/ou+MJdaIpUCjqjlqtq/GXY17eQD1Dnrz+rcbnYqjuwPse/pjazfQz4r9LcacnlqvL3AToSYtfYXe/TtACphln1zYGxRzNDQc8a1SBLilrNoGGDXwZU2Tu1mKeH/NX9vBLHL6yWOiV93sG6wUi54fywJWgDx/8n/f99nf8KFuK+eaX/u6vPOu3f/FDrFqx89ZPPvXTM78B11/f8ZO33DDY8UnEbrno2f/62a/8PccW80f444WePueq94rmjtAc+ZWYYeHSK1n11lXWT+w1K3hBxaDNGtX6SJ0r54vGAY9sq2kBm7glQZE5ZhtmOHLmUkAW91fkztTMxpF8Xua1wpg09/Iw77rJOtfflc9woV2GLbjQtSIz3MI8t4nMDMq5NI4uZtCeRS6IlvHfcEhzx+2V8dHTkX60Ie9oUwsMF6OEcK1oWenp/0LPd2Yv8GMdDWd3Q2dUEzR11BBGepxPf/NEn77J972K3++q7Urh7kCq5QR9H3kc+mhtLfuIWThjhq1RVz544zl9peTi4BlfGAHcrwox10pRt7LBctjy0ZLi/5pqw2sXWuac0Vo1i53xUAo6aT/J3iS6Wp6YsaN69pfYRWrb+j/6Rj6HlITsNuTSppi013Fa9laJ9iQh+wtrGS77QT26fJPngwZYwW72LsCvULNaBozVpUBlW5yi2maVeCP99VRXiTtc5UCURcU57KU95kShXgLMH3MpS176c4m/cF1YJUNhqakZKeO9W9nwXRTCLhPpW1dPZWJ9S2RPQ/zmNN3quv/p821c5fu4iza/3oJEfpM5cWreYFL06KCJiH15iscevQV/Vt7Gg/IZPJK8g8eCuDmeNYK6TM2ZiHoibDmKClMeAYwSmodqsdVehNkT8CfEj0Vq4bFEKR4wHhyJ1sqyOqKYFRHoMkFBIgbIWUsZ7tM1xIRTI5bKpIXRJJBWijZ4pezy1AV2oOZFPHjG47FEC3gsoAOQXM5hTZrD1J7Po9T4xQD/Zox7zIOl0/vV1Q3NiqiSCgjX4HolFgzJtzjc6Qo32NVu9LhBtMIcDDXy+RYE2eLxpNiirUQBqEs1yKCsarYT88CMupws6Tg1dJyaOk6pjlNLx6ldGk/NaLkyPOIwg9puOGJAg6ckoNHEY4EaeEQ0q6cz0mgFu3hEWDIhQFkiFsqkqJKkD6jJTQW5017FGbSDPEMdCbPWCOq8lYvrzHDC9iJW9zlxvgRMGx2PGONRt+OxuOl4+LSodr031t2woMjxYVmUcnhYloxqsx2WOi0ZzVndDKlBod3FIjGqXdaTXRukFcK9ZO8W2h3qeXto94RUn9glujXkvbPNFrMtc8Zzkj967/5w4nbyasjhZep0WrU/ny0srzC8wtnaXUURo6l10SiArmcD6jZN9guSPQwKLSx+nS16gomkpl5llYNZvcqql5U6GKHORgFRGn6GuRPVYeXnLVGSz8l1sgwwTHCdlcM0iyP3AxvMTmysDznnHEZ8zthV6T8Rk83yDR2jIa1ULOOefam+BgX9AxzMLOWbp9DtlzXb/chWzbPgivj0eNoiv9wSW8qpMoMYstq6CA96qgEf4YosDgLgFgo3Brv6mXgC3kIhZJ1qIEmvyBqxXWgsH0EsTT1c6drKZcAR1TZF5QW9J1iXCboddWEGQ4+eFOg5bsKDjWSbz7S6hlbhpDNX+z5iNWcHqgEzQjqtMUhU4Kab9U3PcO6WtpLalKyB+1S/85go1FmjmarreS68BYm8cetBhuMhVCL+j3b0uzpSeJmh7TpOy7T1AKTztO0AkAW+YUSVfUtZI0p+IaoRnOGXq8uXAb+9vPpWBu8wTSLXJAa71L+KG4nbaV7M+eJ24A6qA9MKWgTwiBYsDAETgIk6cktXneIB4Kioe1ue4Zmw9LWfwcxPPicWTAU5kZJphhqnd/PEmMmiyB5KIWWndDA/hYibmYv1qhnawZ8Xul+QzTvNGj1iLc44HzKwOcWk7aykaRu033lip0sbjzaD/zplY8187LdYOV6uXuZzCoG6Xl1uCyC0TXJDt63QVev06qSm0A4UpygKJNyMDFz0KcMjeNeabXO0AbZV2g45S3RN4UNX+OdewqAUeBQM0hSz4PvKm9hjc81o1YuVhlMhoZBVken7fzrvE09+5qG/vhj7Yl82TZmQPN2lAeCOCHzoOmGRqkSBV1vcdZApg8IrOtb5aVBowR9Lr/EUT2wRk8O8qxMeVH8X7JuB08lX3HauvlHu1RiCG+sq2lqHN1h4ouvxYyccowPtAKczjO2RUAwkNwTXzxyiK2co/W5ZEnwWnT4WczbDjfl5UChJKaShq3S2ovlZeORKMbbIdGA6FQNtz8Gt9qpg+hQXxMEFbsZUYmh7X9T9t2NidQg+f7brmUNBZ9I5t9E5nORf0yuCYfGE2/Ld7tOdMuFzRhHK24ZoMe7bC6rK3gkFoK5O89soozPdHotmWMn6+4odPSwou4c439XsutObvY1mCYmMrh3Zj7XpCTSLfJmNmcU7aAaK2AkEvrKHhqkIBLpe0bN6k7NIiZgKF3fekWepWpqSFTKvV0AHe3rkybqmc/VWM1M5SaeCnR+Op4EtAb0DDSfhfGyFhvaIX8/h9u5C42UlUUcULN9B+hbaimUlp1WxkYYHcX5/PQf8ubnbDQE+VZey9xje4uzz/JvATdzk2Ak6ayKuARraMBvykBZxARbFlJ8sTMTMT8Sk4zHMj1i+5YGwE1xrhS/4C+XplX+VS6jrhUzp6m4r1J3js4sIj8uLWDVgPIoA7LzOu3znRL4qeG2Kr6oGBHa6luV4q6/nDbtu3C8H/kq8wQYleKwWKcei9EyMhiFUuZ4LOkepbAlnTCYsKH0PpjyU3M1uFHOlOBRyhBwChy7+mKwsTGuscpSjwkb4XVvEfVBahCu+S4tuDzcwu718EWYZEFjm5Hla2pBNzhHGPyPesySN9g6HzFg14ONQOG41tc5gAWXWKcgltXGQQXOcd1CgyMVBwdXieqkALcPuJ6PZvAMxij3TaBKORzhDCCtb0OKm2IiTVa66pFLWroxXKS/MG30YUxbKt6QjAy1avdojpTXcqaQbqns9tcUAuSaXDHxXDTS9yhpQWN7GydKbemlg8C3kZ4rwK/zrkpJXjioX1shTsbYuIYGel+8hv39jACOGp+MO2R7LH4ZueCLVsZBU4qyV4ym3Epi4Z+w164HDI5dbLglW+qzXGoqgP/BVstm/hwcvnqw5PlG1C4+q2l3WczNVljRdZwLeHUVaZF4n+FQxL7iIdRaDQRcoXLW0WNAULNA5hTJkTlWWzX3XfOc/veGq7/n8xcN1nFJAUjGDhzBpauQNlwD0uoJYLutzAIod/ZqKVS1/jRrRyBZyyajMWhT31nM56cOONzsAat8EY91iqfaBImDBhBpzEWnk/nwRqQvE8UvakmUZ5sNhad8Fb0H51k/zgObzLi3JOhfkHR0g/YbLUcUm4ea6/KpoqoWMJc+4ZDscBxXzu7SIfcYMHjPqPiWgDqeYuua0IBRj6y1PlLWmSsSgqEsVy/pRvZSqUP3K3mTdcxwA0JbxhFkgeTLhwVM28hlkoS3l2FTeawW9pyvBwaS639NbeR25itmRwS5m1EZdTB2pkvRdTtARDXgS4BNI269kIsh5gXscsChriBKOxKQn8OZyr1eZMI7k1vtUXVy2YI1At6mp4KFI7rlfgMaOzo46sKg+Bpmm0CMmp3jTW5uMRFFl96w4uWxxkic1ILcsTm8UJZc5jnGyZZCKAFEZQQQXlI1rAtmBUYDjXQH5UyzCrPCx74CTCIHDAbXyQA2KaGmi6m6vj9Mc0CdGX2Kd8H2P0XbDzxd5Tx/lXTQWWRaqop9YBOU4r2IwHPUFXgEjJGLWFW1ejo9meIi64Hm61IFwxAhN7GYgkvpCQdt5CgrsNosOSmHSFvO3S5IUoDguA7Xo+Oveo4uWq+jFl9J900EUgaz+mdx9zsu/2IxIi8xEoab2pzojZFsBgMSjFLAJPG5aJy4Z2p6VVob2/a9Lr33w/f/1Ly4e4qahonJL0XtxlF4tWnrliF60DhkyqA4tC8XpYpTxgt3oEtDCOqYWxIFttGVlvOeUss3bvXxdnLYtgVhWF4hXYEIBipgqQwGeUHjqAhpqwEUPPAT4SoOEhuhpZOQoQqQUAdMz71j22IBhHm/z/Z14E5tRLczeRZ2UGja6MMCTyiyOwcRgFseVWdwqF3UVxkF7DcuQXZQPh3q3exlK9HPcbh13szT3KpkSrNzeS4sWiwYIP3x8NNsPRz9Y1akJUMKBsgi1dLaBfi9CzAISC5lk3uXeQWKq5MjOItmaBlZyqRiPLjiZ1TJgtggoLfYjAyVZn1ZlVmutmZ5+bTapw6PYIyJwlw0MbAC9JckT2Dw2MAhsnkAbL2dW6Koswx2VDMyrSGBJ0CjLu6bn8wYvFMdoiTS0ZWJhU8Kwxa5rRTQcW9oUAePRRc2aOWREwhvMkTKkL+3t50Z0BapdAzWas6R9QYyNgfTVGCJM4naTvtyFFzIvA7xk5uUwXmr2JeCXvTYbXi63BeDlCjJF4+Vqc7ynJqcUYPMpYc+NuceitOaaCnsVhzArMOkpEMnBojkvb2IRpFnE9euAPICaZzj03b8hLunyrSz6LLbRtmG+nVobBREN81yxY86cOS8JUhazYm5uvjrP25WFDKxSZfeuYxXTgozXFp14EYZi2/og5/d+pqjrY4xmdOWeofkDIjJkcM+Lb+hYJaXxNB0jjPu+j3jGGUfu6f2eahMSF4S4p9Jw4NH0fC6oau/FpKopBb1ihzI83ZLFAdo4/oa2rxc77xjCe0ih9L1N6D3SCnGwGKshfH5NsIXwaAftZMNH46v+Mi4clsrSsN+JGR3TVu77q1926Qs/cspFTxuKCrsHSjmEp8FioFXmqLA90NoieAdP+AXqQbLEqXVBID7Fhpxbvb1daxzZBVIxx3e1SaQIy1+/Zu1vxcwrgRlSxwSgryoF0NMVK9ZYoAxchKHUkdGV4NuDQigPV5Qge1Pi0ilxjSlxIYx3YWXSGKRGdv//81+PqpOqOBlN1ZS8P/Ijpx/yQPVgRU9j5ZGQn/2dnE6HMDlIXvbruo3Udzkg/w3E5FEZF+x7svz7y4uzu5GEQyFzmFsrBbSwsxZOnXBXQFBh9/bH1FSY29pB7DiEhGOjaFZUqpvM0OK4F4cT2W+iVnw2KG2EM2zYu84fwwMnmsICkA27Szxnr577yyb5t/RT2GXTzpiPsfGPgJ4NoOe07qfaOQ+t7x98khgQ6X+49Vy1tPzRw68+xIkEMcL2l5znf7s2lTgGLt2y37ab85YC8nT/ChXpwtemFbtH1rA7fBBVY7hu19zE3sLan33skHXyxFwGciSlBmBFDQFg26kndv3BTdAw+EeMeP+vcSO6z7oJAFr/aOuywuup8oFIe+Wr/s34oIxtSQvAnnLWjYMaedGazd/i9USRCUr/ktT/izdUCuBaGHbuYwGOza3fKuA0pX/3q93HOvqqESHDaTUi/qkeNsVqbvgKZ8qubgBRp1Ct2ARcwcd1FNSwfwKVYGgMQD6TN839NjGLDd+jmNltmdnQ04KCV2juyejnTdKBEFkbNWF5KHsdquQUfu9JCk9FqICpqShcK2xhPVXHC9jo2YW5y6/ID7OPdWvgjDPuZw841Dggd5Wzd6AQ20yuXC9IitNCPQ3ShkG0B7FYwbpCqXL0rf727y+S7yOYwdEWZ9R2Lc4To9upg4szzaQnhcG6DKGQ/vaXvcQaEM/UBMGMuuKYpeZGPlce6eFs1a6hOv2xCNlnPi8X3/hEmdprYml1YVomagLSUNxiC6D8gE+JXs6vEpEvUCLX5K3LTDQaA3CpnjXuNGUXyP6AV1bwIfvkSFHWSmheWNYFXmjmOfeiwJkSmstugZ8v9A8NgHXSLvTQHm7XPD8Io7hunyifc/D3SE0azbTVnunYJyexKVNuuAo0TUsBVCNkoDaiZ2kehSRotPUsMgOeZoYamlH3nBMjDwGuZhCjCqGg84HSDnKfZYmDTzFNzOeMHTE8GNfVpWmXH7DUwQ9xcV2XM1LMigTWOCOmxNDTpODA2sbQ2Fu8nGnx3HoxV7GaXbHMWMYf3ksuyLcp/CJBeZf0iJ983avH74LTv6PX2UEX0ap4slVNMll/V7M6Y3ZXB3oJQA1FHbOuCNW6BeLUB6mX/Z5ScNGnxE93QFEpWx7IFxv7RC9347M4j0OfYSppY8z9+X/zvEmjQ7hVpTK1UE6y+of+hiGON70sZSy7+SCOv2/1yaAb8Qfj1kZ/OQw90dkOp9xr8CgwF4U+yktmlH1C+hSrTlUX6w44tFCOL1AjQl3rnfwh7o7eIlBPW9knZeFQT5LxpUXSgxiCIIoQV79ana6+Py3VfUo/UOZHv+qJNRG1N9nGF3H2h8ilwDfcQKj2seONqjgcNGzf7ugH7zvnq2eeeWWV3y9zjRj8zIMRM+4BNaB57TKDnVuH+jZfFXL8OaUVZcc7ipZrATXX1ftg0bwtuwMB3Frnzw1j8w8X456YawEMRUJR2wk/vte1mfuyrsZNW9Q8MtTyhq5tKVuVD1QBJRa7F6VYe0geUIfqAjddxwfG9g0GE1dB7hGIegpRd99CsUj/LuutwQtsaajkaFjeuxA9fE/7au5zhsCDQ/+bUdQcWnChCA0R/XcmekDekWHF18BB4SkhyzJeP+4KzQtBXGdfMojs7AtYvYOhihdgxRgiK7QHrZBuh7BBFmnthbGYBo1M78opbg4iLQZ6k5fmoVV+C5EkpeVwTcr15X4/Ga1DPCuassXdvF7454A/WgfsNQWoAy3hcuTQDiVJSwVYz2975hvOqu3K8SHD3A2LmIxKnwHn7eA4/wgjuIHBHcr7H+Od6euGnEZkwhPi3rBkseRmHxsyTX97od3kLUdiDoF8pgu+uCpJXuG90gz2wCsJkUgGfd51iZl78KOkFkoYZ7I/Qa0qWyIMOjhUXyS98BwJ8gTfkZ+2Jph2waoKFeqIrcCFXdierFdWkVqOj26GKi289DUoFKboQPangrGVbXJr6lZ/RtRXYVIR941kt65ihSYUFGbRh0NwqI9yWyo0VLHWvLDH6lm9lS9KC/Ol6XVUGlHZjak9e4iDjD08NTYkt3d5swXpF5YpVGo1MPPlSoe2uOCK9fHbw4er8mHPfrhCK6y8l0LjYHBHvow7jbqhayCdPxZwwpbRAQYmbr7lYO9GqufauAAUtJW8Df6ktpFvE5q7OiInWQaVdXVze2krvtrODxbLEM1zFQs5AzuPVEVCj5+36LxbGXIlNXPPYdtw8N49vlgHXpO6aQuXcUTjwAV79p5/BGFhZKQuWwfgkmn7IIdCJg3yNlTU14Rtm8XuXe9rl9d1cNHikmLFEWlEXF5scxEvKZZUv3OFtuk15km0wKQfFlu0Un609SS8qTfkFvJVu258Jd8id9/znGbKWXZl4bHujuQs2KfBN1+TF5y69v6X/kg3rPq9Ja/33ofn8x0GV4HzwFVB2UDxcmelosDaESqMM8NdyNijnZTz96JpBxXXWeFBd+SnQL8/r00RnJ6an0an5rtoFhacD+DbYkG2oD2VqPcAXo6Z8uku/pQLFYdwEJp1YHRBB/DhBt/m/6z38H3iDI4CDOVpFGl6JfE0a5p3XphMbsnpwHeRxhSwHjjNBx08HULXZ5MKT6dTqTZRE8dpM0yFkb0yexo7mvuMV5zBX52OwJn8w9Jg8Wx7Bp3J3/Lb1ZqRX4rTkBGBXZrxCpuEl8v1/vFkq5X8kSe+/YrT+FM67eHPeXQK/+SnGCsGdpkwvPzqparJi/GjVcDi2af9ZFL9y89AGibmOAYUscGBPfmcosLitM+NRH1RRN7FLNUVA5LcOz66WPxIBD82xw3ikr4W+JH8m+PHmRY/zqrgx5l01iPEj6mHF6dxCix94LkbGKTYIlPLh9wD1/L5uqiIkIBAKGPwkeofV1sT1NpFp6Dez/GEferP7Lms+lecir7yp6/61upfcTra9iAQcqJp0ndbIuF7MrnxK10yVnjsdXT1RSFHBHt5+PDcLfgihHYXcPF5sLQkiAYjbGr45bNAhNNkQbDvp6U8/1gwi4wYKOIMqFLH6wx79LCK+qw1EZ9OQZMwdfmZ8dPjz/uta4raS87woREopnXk5X3KtdLZ74M2D47wllnxbctoP3K4zchVzU1mWTc3biKj6mqv3TvhKpIvW2mC3u9J1fIgJn42kB0aDmVJFn2fJ+3YLSC/Pyg9beAKRbPUyXyQN5UzQ/FRsjHY9931D1//ppi9SVHb3YfDSrqxjjMUJxgdDqlV6q5QbST5KJIHg3JXPgCABoMjhWNOSIO6/0n/2vfCKRez9Q7WOnTtjGi74i5aFi/bPe/sWoTdBCyhRFi9WSbDGazeymi6pGJQHkEFEGB3YNDj7cisMz2iWvYT+qo2ViIVdqnBLLXEmbDvXYKslovEcY+xGBbqJ76K8FhSSHJrXrIhLpSdLB6h2hn21V20h+/gZgnCBxgG/SM0j3w1X4nssA1kbHqL8Rrub/X2dfraiPfxqixY2ZL5pc1kZzG5CKpuNtZxCesOWAUInD2XPCwnj7cGaMq2DXAWaTfehkecg7QICX9hE8rSdUulxNPu5nzy3W5OX3Q3py+6m5MXt5vzZRsWq08a2zDZaYkn3VibhzvJeCS4GuKqdktorMVQHbs5zyqYetIqs5vzMSW588loHTFxLaZsOYCvEWrhQDhWhy+7Ob27pECU3ZwvLRUYYjen39jdXIzdHBIrWg6Qn+w/MwBQGdJKlY4UoQO5CzKBMqPla0W2obIYV8t0g+TKVHBRiFLS0bHSTw+/Blgdli9X9YzwAuPidqCyAb9jOEz/0OMpP2oHjWqqpOBnf6/nvv0FY/491BhcClRYSaRhX1FFgEeEtP51pU5OhFK1SkztNVzI8dacG3jrlNurZOA/bCEC1WlxbnhCK8kkjtczbh5ylWSK+Kzg1RbQOIHD9p97/aR5qON/8fNTvniF3rK09z3VP53vblY+dW8nLSeytnff333u6AU7fuvCvft+ZeNN8QNLe2zg/L125xc+q4dzvGf1BuL3Iiz9XpRT/oK9g/S/+NjvT1gftp5dFWt1UFFGdpdSSNiW8tX4+G+L2aKgYq0XR1mD9N1eEKj+8ibnmIGOe+5P6J0hGFfOLuv2XLI+di6pZ5dT8+jhfR6pDwycJxu7LxSo24TszyA9GDvJ/K98dxh4ifnrKyjb2t2Kt0e54ObjK/Bnhz5rZlf2tzdKgaW2IvAf1ESLXvO8aaatxVwMP6DOa01aQyInghMhiSplRUilrH3UGkK8yszCfSICQTlUschRD+qiKE61qjA08G2fhHCeSCwaVMWi0YhYNIKkakQsGmJNwagcKZzKP9VHxKKJawvFViwaW7FoHYpCo2LR0SWL6lV/UN+LdCcYDddxlSGheIpYtM5i0Qi4EokURPDnBcoaqOEk3IasFpU3+p5ow3uFNwnArwHgcBTPRNkBLhkBXFqBQ90Crm4Bl+Cux3EBlwylbAe4BgUAV0r1KeBKHLgAJvIgysGusEkWWj7uInGClxob6UUTR2JjQISqKBNh2Blt/kcFo9isACALvwfSzu8cAMDsNVjgoPACJ6IQP/U4Uoh3Bjj/2ZxvzIMqK+g5cb1lC6tMIby2DR5Ppg+sWDSN6QsNo6NOXNSh1jSmL9RiKFKmTy9MT2P6gnGmT6wim7KvLEIwfaiFA8FUpk/ZzzyYwvQFk0xfmFcZLOu4ZZLLCka4rOBEmHHn44gZ/zPwsWpXDx+n67KBuZEee0aTERVqKII7KwbtN6uGsPBe1uPPaj/siwXk5/cOMOand3l+WOVAmCf0nPGL0Dnr1eMRXbsLMXwOg3lqhrjcIm3e1tC0NTT8g29CdbQ1RFtreMiIoigxsKd6sdEBbBZjqj+/x7IX2GYNJi0FW+PO2WcPTdl/OhUbt8GN3AY3mtzgunRJRZMeURXoDbca2f8K2RUTGTOy+/UV4I3Id5vcCEfbf6Ke1OzONtJ8QbmzBecMOZ3Z2Ua6s42Me46Qgik7W59bda+UGwgdl+ygjVx9dWc7Yoj4k8CLzZXgnFwFS7pRrMqjSd24uHoaU3fB5Li6ceJFMTH85fH150QIWR/coVCxJy5DitW93xiD+RyeycYdnnGOp253VGVs+PpRD3iQ30qi73wFVb3gteQz6GZBbRB7MMV08gGfmwCfElB8tNZvsMlgtUrso53qKY1C4IUvRB06THr3b9qRrHxbUwKK7moZqPIRlNNJs3vHvP38ub5vrVk9MsbSv0BcVfVqVfv6KWAHU9QvfRKdw96EYw0g9HA7/aLPZtSV7fcEMfET8tEhEET2loETKgEZIfCVaOV6+HVWlJX4T2cKLqtWOMYIPBCHdF+aB5W6ZCbUpa5QipYzsLqpK0S+CHUph4X5Ek2tC3OlJmc/WIm0SmW7MIlMO8UZ0KVKGpXRGmlLiJ9Y2lJH1YoasbYFijAYMolO0Q6qg8BOaw2vg4WAhTiAWid5l2U5g9ZVtKJjkP6G50WbmFVXCqR0Se+o6uDUhRJtqtOJUUjIB4Zlf42K1D8+SuNHlP2NIo4Wj5JUyySSV5AoppPoLUaqr163AiVJ5YVMMzNH6NErppiHx3U2deFSRP2P/iOjMuqK8HFoEG2TTqjZdHUGkH3eqrJQ5AzMV+vea4gGiED2OQGuR1IXPypCRRW74BEa7zXSwSR9v1faxGoZkt9J7T5XNrNQi9TbST6e31OEbY98LIsRHvDVFql4XScPCIHgmCHP+yvuE6P9DEUQISF6fa+TBiLF1rn2LOFA5E2fz7oGCAXTC8qn6cZZPwa6py/Uxntiyx8PqRhhhXJhPP+H59kWhGQWoxApPipPZDECk6+SdgXyCJTSb2Y49zMzogzQijszrQkFSEidUVlvSIFE9Q1ZDtMfbtVZ9PEKlcyGjpkaeCPsQvaj6oRJ/SqL5EpVOApfBMJo+AGopyFBdDlyX7HrLFGJj7CM7NSYVWQHCzjN9Tm8AZ2rmjJ5IvmD52G+Q0Oanwk/L1ErQTi2DBQxZAWXWSQLPft8Nn5FQhxJqZqpJCvNyXJfLcxeDgqJomSpEqdVYhogkotJeKzmfgq4Ik+EPKbIL6KLkkE9cJ7n75Jp6xSu4UVdqtLWXqtKzS91Zxu+nm2kTslb7aLmMlbSBtG0Vf1e0G8lHIFVzRDlJx/9eHmOrho0r7Hnp+8iQYnn8QM6Lfp2Oezq1NYsWKDXlv2DOrIKIHMLVPFWCsTPS+UifJyK11yop8HgDr7LHsQyp46jA5qRSpU380EYUZfzmqglq7VcU7E2Yyb7klHWa4xWia4vHMj+BZUo8J7NdSNS1kDcXYRWWctdwx9SyjZ73RFR3tFUBWuewdh2ajlWHZYA1T1bECHly4QehW5kAhkZjPaLC7EPfEFwC2fgimH7wFvL/tEYu+aEQ56WcNDTNFhl4hz/pDnO5A/zJp6HvbzlakATTCWgoQd457LB5i70wnUxR63bhnmLmjAv0FTmlpVCnIBATRhcXrV9C1YV9eylVvbPqFyu8YtCP5q5mx/wsrEH7tkRPj3YBaGphHaLwSQdlvN8dNXa3r4ZYSZZDJ9YNCfBH1koPIhqpljHq9nuFcHVPdEm2ljP5yrg5VftlV8VizQV/am5fsSNnVpp6OACrZJUaL7OmpnCqeglg2v43j1oY8O07MsKfRliEV4zCumUWrhUtWx06rZ1ls0r1bgPWwnEdIHH2kDFatWQ4fmhU09tu7gzSJ/HUaZmg9eIcGNIAZBGB1Nwq6btsnaOqYX2T01TWbs0ovClrdTGDGrTvJlBFEMbGb3V7/7F9DWuxP2riZvRSQ+CpV5+zSC76DdrdOWMNkoXmZA4FqGW/THi023TYsFUqD3K3dj2T4rmsa/DUXv2wKExL8O/4o1wKc5/ooeBUCeH9hKSUvjnFYFaxwxA4AJ3/qzJeyrJF00mn1VJ3l1NlipX16yTXoWUcigt1U9WIPmu7VxOpesfAA8/cYbsfCNB6JjLCatedAl0t1ozdPzsmrL3gM61axDx6IcBhXgP7SUipBb1XER07jt1PRuK2mffV9fGeh6l2ytODC4Beqv3Tfu8tGe8Q/qj3iG9tue8Q9pSUuVOWvzwlC8J4OhEJGziTZGC7AZsB/Ma9ocMOnUX2fJT24cakNi6Ohq1yf3JcMSnZFRhu0O5ao2AehGJdYWrY5X4FpNQh6+ZhCOKxrMRJcxcop6I4NDOuuzKm+rezjjralJsPWynYOUkRth7/VREGDHQsIFG+GDbKcT9kXRtv4qFOSrdXxi787E6B4tt8WNl80NzasEpF2w5shhOEjzrojIR+KELeAcE65WKtRMYVVTNac/VTgbSGK3TagGjamS5tNIZo+MIkwios6l1hsaxiicVx4hEX4xaewpoY8Nct55eBQUpVfVXdIv4r/TvGpf+XT3SbyuOf+s6jKY/cnARO2c5wry79r+c28+NR/kigwAostcKonlUN25a1XmhpTfOP+sdUSC2YSZnpm6ZsuO65vSFNccjFBviegAMbNJLJWpWLnAeodR7tK9TNdAPfb4edGEtxCv57q5RAwQ0cE6NwXbq7IqpIX64TXeD7CG93OFUosXFt68m3mMMFrv4ftiJ2Fqc0jrAkC2kAbH2g7/qwjF4U913h2Iynh3rlC6YfIxKA6m4OTuj13x4tdf+xqQFdKTS/s9+8mc+yf6i0K2GSWlh799A89Gg/s8gB7X6/DiD0aCjdPUrwu21dAeSVOvRzQ7AgQVW25wAu174ItFcaVgPQA2cmpWuXMUyDQk021JmESOMzogt78A4eW1RohBvCJTxlugDK/FXDRa1CV+rqAHwUzBNBaPOKMh3VfXGb/F7dvD1gndWrKeXPQA9yDWvR2KV7okvXWfI/rrcV0GDyNlvLcIy4XuwMLAPqWd81f6r3WDD//zV2neWLNSD14kujh54Q5LjLmFzGVhyPnAyZXBrc3HuHbnPK2watnVSDyoYLdCa4ftq7f/Xro1+TmH5HQPjZ5XRsExcyFE/aKKOaJQvQmE1/wTTgOlrfc+/1sLHv3U6dKY3pGbfH/pq7fyyxI4CSt2VjTQ12BxMmxeGUo4DjdGxwPqu50j4FGWY/gcGJKbjBlCBgQrg8KMBX1+O7BHEbkfTghGriLvw7qwikrXxr5cqwR7otZO6vWMb9AmKjWfqrjuvq2c6x+LWmcWNmKttaFvyJngBamh7i3SIBUtvI9egrd7inFhfND4dDo8g/hLOWDSP4NgngPU2DiUagugVodsksksptcZ1EmtVncTqRYoG+oHdvon69qMUqIk9eEpS7xUaf6U5s4LpsTpWx7oaPAVpEDV+YKLuHSKVnQJchVlB63lkjepk+pW7c/feemLN9vJJAP+VN1HurTk5SijSDGew8uBRfmdOHLD3cCFPmXGVtvn2lUI9jdQ9HO7q8c9uhph57+JnD7/v0bNEu8nm1tkiGPS57g6tpfBLRs1m7t1E9rfbHthYn23gZ2OnhifAb/JfKkxtE4MN37wt3rGoV0EUjf5p0yp91BaW3UTH1MEG5TPSrbyDx648qxbgjxfgipTc8qXCQsqScg2sMuowcnHP4TiCQ3uNg1tCU9XfjC4qekEvpVBr0JrbzG/3zKwlEkeCWLiZGxIhb0u951JTmYXZinYQNXlNzudczAx26VyclPnNUsAs8dcJVuBZGCRtAWwU6ZI+B8kjKhDbrR2hDiE1qDMsOnJkQR2xpGeVeRQ2AjUDm1juVuvXeaZAji02ZQwKohkuzkJ8xiIW4LWLWuAEWsbml+KBDvOadeKlAuR5XYQXEG7JalZmaxX2WKGFDQmieIPxTWodEYsC6n1vvpjCoulZxEWE1ALviCLBXanmdV1+FzFVU7QmVeR0Q2FqtGPxLDTOjZW2FeI0O29vfJyd+LOG9h5V26q68H/166e78D+xA4k3nMgLxNmeN/ppTT+tGT045K6VuV/7OHfXOfDuZ9UOv+4EHf6hYETr2h9xIO+Z1minQuF4o+cIB2O6r3HhZSYu4tcDfR50qDC0ruY3Duqi5k4iA9LzEx8nuJ9iDtXjMyqI/cG6ciIyMOv6SaRQqCws866Rbl4OoUNFCNgEJ1tnqHWivYbTD7VLActH+i99ERewJnyafBcht7C2OgTiexa7bPOVXIWLjHhfbzJjL64PJ/rPXo+Wrqgf3UjOQJGGuhSZ0oocgzdLb1Sm9QWMRsfdD3mgasq/1fRWvZf9iAIFbnm1FjDraBpefLwUaKI95bFnQ7qV98w4AxbdqxmjAakSkxWJQf0crlPlFPares56ekXKIhPGepv9Hzyq/ad/X9/LbpZOpzf7XmNSPoWvVV0e+GnGBmIUWf1luwtU1wVBt0nEOQJc7YSBM/4z217Ys3tIt71i5R3ipTtQRZGQCMBjSxrIVRZxZftNuSpfV3lARKHZ5OC4XlDICtKrGvm6n/GAFYk+QjwkLfv460Swr75hJao67L+D1Fr6htjna7SvctxkRfiiU73/qrUZHy7/y8vrsuPV+tGMli+8r8q2dOaOSKdIyZe2vKYt1zK0uYGWUY2zmWosFngGvf58vMj9SrPrkPnE4h889fK9NghiMOsCDMCKrTt6tOq8aim2vWK4RBeqGGU1xlreKL8SgUigEUrdU4pdJWg/SnC14ISaKUxqFFY8goc9/rFt1SZyZGAvzAXwPN8EHjiAonfU1KtxRQoBYDIhNeRP0As0R7qbt3BIDLcieQPNEu/C+LQlxjUTFquMlKGtb61BUJfIKQLDvWhjExFRW22uyEZbBC1G0NcqQVgHXJqMxmi3SqYmmpgq/DxAJpH+MCQErFbY6YvVR2sqKVDoNHIAKhgpCz3jhtaqDSVtaGJoQIzDWdtQ9AjnFi1KKcluRJyK+D0kWAaevPQY5NGbeFDvbOZA3boFV1EAPlRpbTTmOj0cc50eObfs/KkWHGCMfPlaHaYLdfANWUCEJQs6yZ2v9Ne8fqqv9COgedYbdwBRXSj0EaEI7KXzxh2beRARJpbav68759eMNzxwquPIL55pZwMECm9Ng9VNnSB1BYgKe/VjIWoEgicet0PrcRsC6P1AUNSpWj6mw0BV53E7Ham0PqXSxFS6VnHzjUr3F9IpIMyYV+1gLf1pMER6fT8wWx2MWli65/ANzHUJCO3oe5qKzCDPeBOeyVB1f79qNqEYsPF+ZWGPgDrVhV1sTShBjYxRFCnS1uQjLYC4qH5yKxi8rYduBfMqK5hXWcOC8TUMKPiAEd2GKrO7CZglmilYwkp2LxKGD62MUK+rPOaCte+B9j02cm1d4+SwQKVyGkpgLEW/hSKpwiGiWJUMAuSTR4iHpGVver1b2OoTC9sPPgZ+5vAEP9Oq8jOtCX5md8nPhNkP4+MT8S/fOe3Iq8LyqmYR1npYw3TnTyo8tKcnWr/j40b5okfd/R+a6H74Utd9vIx1/6nT2DnWOt3/KDi5QsCg+MoLYnb9qyVaGqFKLppFefdqFhkmzXJ8+CYnDV9FPAffR7jL0oaqnHy0oV3b0HfHbjJTyXbB4xLPTTnru1yu/vWvYLrLj6tFCK5E2m2TZKY3Z+I4FrtbWBI9Xt111njcR504+LzwdGbVVFtHtRG7Ego5tAD7fGsU6RL/owwP7mGEZJ3zQc1SLUUAPbABxTo9QJyGENeKFKWyNamX/OzHdEcSlvHc5TLxLUhsBaNpzIqWGW5BBmUym/1lPfSzbIXukW91ReD1NvdB3MeIGgYDD8nwVm2PLJdNvaOubCNquB6oRXJYUDZdWxYAik1KqtGE6ExO2Vw0RKOpex2FYVDCMDAwDCwMNYQ45TVrlSakptdFsy2jWI5yrRzlGrcPYzx1cHXcJ8a4rfZG8xjEwMDvdiQIvwZ80rgfRxyMk+5XrSi98hYJU6YQjjnX25BLD2sAFEZfGyk8RO7BmF7AgMcTx5YYJv0WLKRu1eTbXKiTNsFJDb6X12qjcI9JaE/oNATTB8rAPFdVBmVNPrumeRCSPCg4QC41iqdWI319XgqmPkh/M/TrbE/IWgitym9VDyw0l7BVv8qTXYAqWQHyWNGejTDi+YzpEtXB2qenmw09f2ua4+0/q4hrP1pzoxJSQ0tvVrW3KNKiYy3V41LhaGizcuRAF7iXC6NYrt4+pXiiPK0ErXedM+2vNL3vHb+SmqmkVpEIeahEUfmkO7MpSIBArpbJrqCBqOk4DTn5Vhy/t7XjgTRVc6QGXRrpA77vA5Wcj9Zo5AZG6IhEIJN2D0Iyac9FCJoqqmOKdfksCSu27VIdyp1yIeNi8ZWHn52undq6vI7J5eR0VMcTE0Ari7UmX2vyREdT0TvQCnVrgwo3q8fTesbgYesJtJ5Q6/G0nprWg+mitWCyHK+OmtYxNrB1hXnk/Mymfx4oxN3hS1yFOGisrjnGqSqGHSFUv49itFN8r5gJfpGEQ5nUexDmbgh9+13Rnzwqv+e6hiqo5X5eaBuKuYQn9jhaXV3rCrQuH6CJ7SijSh3lCFVuXpOvNY0Ob1lTqDVFWpOvNXlakw6v1qTDe/yaPK1pdIDLmgIDQq3J05pqWpMOMOrBAB+/lprWMjbEiQ5xXJHZf6KyEdo9Rd2qpresENYbXTKldJGrE1eht7OsGkai+gcSWpC1FKFE0BEhtHunqgsQ9jWciQJ+UHXUqVGu8XVsf+wdk0QMp9r+qDI6moCFL6BI64ilAgCSUI+s7asIydreldDVso6H/MxhPPAJa9ICtKZcNFKpUmzoppSoCrVCr47IOjUYug0FjnK61RPMX/K96GShWkMzIgVurMCtG6CGRrelBGqtBGqtBGqtBGrtuEANS6BGKinidGlIBeFjLbLuYFhWtVpW1dWqFrTltc0BiCgHOOGUcHCK+3abAe4ncCLvVUwsh2Ogq/DqUd9XXbxXweKDqG0JA0hxdgfaYF2fXKe1eHmsAikFOiQa0iHMRXys6xbhobBFSGFbupsVNRddx9ESuWin56kO0rFMvQamqYUsuE/zDKC8r+1LlbOLybfG6rRHukPx0aKS2yWVY2oB2QCfF3XRydMDbcsd1KtUBdrIdL4N7VJOuS7cJAZZwZgd0bb4Uima8C15XUwFwZOPypxEbd+J9/z03dE0/KagbC/CgaHBXQmHLwENXlC0yviBzZWim26udiIkU1M7q2ilmwVyzJxqUglRiAu4PoXQGIeVAZm6RqvBmKK3BrP716IqncTx1DqeKX1GyWpWVvUhNim9LlNTS14wnVAIo9pNixfJLkRJ1ZJPDjyFt1nJkwXXzWhkiDR7pXplvxmcHnQRJ6GM4x7vjj7O3UPjjco5MBnZlYS6VS4lz9GcCmWhenr9CNJW9yEl0oa6woWMrbrCYRKCN8Li0xXaF5qVbUFCGYcyYXyVXpS4Vee3UMgJuqJKBNWuSKHqUR4fcC+kKl/A0pXQS00tPvrpT9RzvAqeqacg4kcaKqaPa8kAv68lF3V+lwVV1PqlC4lFOuRQpNNQzZAiRToNGaQLaTPwFskjap7i3OPaWzQeSGe6mZaLCB4O7SDL1v5Z7AOKQmHVUc70S2EQ8PLmzCjXnBllD6zOpEhqJo4iFUiVsyYpZ01oZ02knALcveOh2x8J6fYngHOGAPOh7JkuLnoKGVWE0TGerXATwVNwHMGTfyLBkzeSoYjKYiVvUa+wmXpEi2MS1YpSeqa9rEv3EgmFBgqR9jwqex4hCfuLaX2XUspZ36gymWa/RGtVPrN/hR4GRspq+lpFIpClwFYNDD5LQgtC2xDKQNtKVhMbMrQDbRpjNTlWb8Y76qUKVf1E1nkZimepMin4Tmjd5ZHS4BDkRrkpoFGqBrEtfUt/PvSSScIHfkL5DV85qILrxmsgd4/73kug0Gj9HvnfKoIUNASya3XGr6y9MkY6EpIltlnIZNHJZrn/GEwLeNSwMtN6OPp05cdaflyWH1fKDzTLFC4Ni/1k2Xp2MkrkG0rkmzrwWmRZe1qZDvVLmHzWRa8FIFHrVLABpSA5if66JieWrilDjZBlqGNLfwg/CyVU4rRSRaBVBGUVQVlFQwtsKtELUVEd1jfy+tSClclJHbFKq2TqzzyHMFRSKMUT/0V5qPqsFDlEAQ2RJgLjsaw5zBEUq6v9BztLuuUsWdB5lEnELjkhQWinTnCZiNhbhoI1QX97yRaEpidFE37xoMvOgQRzKSlHL8kxgnpIGjhbJ0n6dn8aK6BDi+bqkJlZYUFfK0GfIFQipGVlwpKVCR0rM4GNAP0kzxErOtatXZXCdSKCUBANAk+uDToBLsSKC/UKLiS5NxUP1EXjJmjQ14MaPUiCjNdqulBNLVT4TjHHc8f4KhySi9WHcCLs7vyrJR29wW3P5vV2oJUaizkXdAbrdfaTqrCnHyOHlu7LKyrkM2G5DlJewu6k8qKXyCsX+tOLccP78zVzxTvo32vv3gXIEIq1D2lTdqee/48e/4/exP+p1z/im/j/591lvyP0G7ASNaHg6Ea577+Mx1NvKF0jPeZXsZ6b/T4uB2d/gF8ooPCE1pPdeyQGOXePxEBqedFIjKdj97xNjl4vEQ+X+oG6kFWpXzWmLi/QJdKrKNk7nffjsEiMXgKqqqsyRKRIGeKh34HzAF2t2uscuBu1RSrOoSm9A0+PGprPpEocpjcn8AMVmA0GHqH1m4pRtY6GFBcaokJQ13M5OKkCfGCpwVlqdbcJGrgwu8FNsXdkazJ57rCO6fRagbZTo62lZluZ91Jr6rouqFY6q4vLe5waUzUYpTdb75242TotFjNPz3Nn9IQ8e4eexH3S8/xpN12116LAgdxauwcYjMfqaF6kukE1Fc767j6qJu+uJJ87mbyzkryrmixVdqe1o+Uiv6yR1dtIKMz1+ZfOSOfE5ho4//AVAf+1rgteYTteBMIaHvT39/deUy62qt7SH3N4VyTGlxhSm4hqIZH70a+dXbv/nTccqokSWl8c790r71PnT3hM02BoSj7j0Yf1+JaiaFudOfaTl+Qz6i2jFmBFl694jqnFVI5ogRHrGrtoMbstQIuRtcio9ZJ8lqTBc7h5It/CT5XotW/ki1IHRMmeHFGqF8s20nGeMfsSXGuMxMDmh2FgEwkXkUQMaRFelPnDiNBh8cpaE2/KS+o6doFpk/qSnqdMTETNg7MOD3p5l+bQoS384A6v0AKkhz0uYDUwSnfijwSPblH75qkW5rfm22grHF/kJGI3UJgOlvFEKDE8Vq/yA7xRTpGqieURUr89L/C4JN8xpVjiIomLpnyrAGNFfIxRocoSS5QfoLmrAZbZNeM3LN9JO0jfwOJq3CnSjSVVvNxOO+GLjNtKpyCwFQ0mjSTappHbUqOZyZVuQT8qXjcCuPdgF2PFTtrOeYk4DDP1nICYLyDmAcSQZuWXQhNs1kyy6seatUYBPGtyBD+px5PpIQR7DLXrvq+I+f1BvC8Qgl/ioIhjauoGG57EVflTHN1G1KVYLN/v5F61brj7N1+0+7/fd7F9MkAspPd8k32ijaeU0b9qn9J0RO+FcYUP2SeK4KZKyhUrz3/PsQ/Yp0v5vquDc96wZf199qkpBek/fuOCv8g59T98ce0nf/e/XvhHn3mafUpDP3f7mW/47Gf+6wftE+BC/Cu/8q7v/Mutv/F0+7Txn3z+h7cMvDM+ZJ82/icfzGZnZ6+/2D5t/KXfgX+/9iH71HhtKfqnS9eH7BNpE77zpMc03p1P7Dn0wb/+lzs/YJ/y6Uff9Z4PvO3v8qfbp23GO7/t9oPPfdWbP2ifNv7w4m9zN/7l6fZp4/+///ThpQMf/s8fsk8b/2zpxk9cbJ+uO9uJx9czE8sr5+3D3zo57XhkPuUV2x7+tuLUyUR4c2AsRmm+ibJPzv6thG8f/jZUCskTcJGnMKEwotOI5FPa+vDveDSe22hnxEZ52dyDW8XKvGrdhneQo0NZ3+eM/IixUDtiGqskDvzwLjyy4nQxvIR5nJ8h7nqgnXumrhdn4cNPy4dnK+1F6T0K8GjzVzP4kntxdn4GxZxnF9aWc4wOuGoJnQW6+gRsSWbYCFy+m86mGXrCAezGmcZ28MqTspjnuLU849e4fzDgYIun7xO54CfRGfmT6cx8OdhrVoo23O0v80+hvhBBHHqIAzNZxuhRidrmNg6c4bmEOnlBWb6DWkzPn8TE/Mmg4v1X5TkVDIQdeURb8iVayWdpVWqDzE2dQu6k2TJ8Ci2VYaKoDDNhoVmEGJ1q8twK3NpGkbycSkvyPA2R51qvinoee4pQ2OIp1CVC4LwymebXijmbR+nqqXQaAiDFXCjWqYwL5fnFVBsJQKkuBybRE19I+V357LDHLcQE0LrmuHaUwxUgGiVItGvCU+g8VKBfk3xM2+hcxG2TuAG3qFoip0qmLp06vcSddIp2Cl/v5j5JNwhxJHF3cXUjJRIhE3/YdSU6709yaLiExxLN4jFr500OAUOuc4IK4SUK2iHPHbRFnltoRZ4rtCrPVeszZMbML5qX+YVHRi08WvQkPJ5ET6bda4yry31+LNMT8d0T6QnfrKJ1I6Q9p/9KvtLh1fy0nBn+f9SZ8Y2Z8Y2ZEaSYCMGL8/PxuBTLBLCcSziDQ4k4pWohjKnQQVlnc03nH0BxPCMk9ERG3z08IZ7AE2L3o58QND4hnpDnPBkKngg7eEJsoSdy33ebSTFHeR5PmRjzYMM3mRhRZWLMK/PN2BKZSTFbmRR2QOcNGhApPpt4nWIWuYHZgtA/8+zn3f8D7/3cxfZZbAcXuZW/VzZFZAz2WZzLiYJdWjLwUNBVY7uT84NI0JFQajnFyM4VxJbNAyOjcwXRDg+1N1sdUlNBWvMpUqJOk1GkrvHcpkmkVsQ9Lm7P4zFPc8DtOYPbueBu/ihx/AnYsz2BWpQBK5+MtyczjmfAyyfi7Ym0G2+7GdUJqL4Hn++h82URAKpDHvsk8EVA7jyrYPaKYPaTDnCtjH0txucFOoOLOFM89yla0hZG2iQnPEFTOeMOWuA+rmD/yN1azgugJzrPwJljyOQMliJfAqtZQcu4Sq8pNigYKQo6LHPUtzKAVJJSHTpLeqtjxtFIxbbxZMcMozRrRmke0Jehw3NuctQA1h12VBYA+QVaoUxGDm/MD+Ntmcc1w7C28AGTI/kAPtjonBcX/IMt96vW1IP4mXQOzRzIZ7BvZMjHtAts9i46HR/RGSUT/azcyC6KDjWM73GEQg61EBKrOU/iZ/RSOCLn8WUsaWK17yEM0QMOMFsHTIHFcr5QdVW+w7rKY1d93FtOgjvFOU4uaF52sCo2QIlMyLCjtcNKNeERipwj9vLYIgIf1OSddKRzOT9CjIw5nlt1laqZtTiXpyykWL/EW12AYdeNkpIjfKQO6gLq2iUayy/oiSbhDBY0Rbbwu20RdofPud3mvmuwCLN90+UZVEL84wVYG/VjkvGaUyESTrAFHGHNMRCCaS6KlhQJCXuog3p/1CLaPPBknnpWwSrFMCxjGNoiWevwUGScr5XnvCQUPN928PKwRUUN4jGcVrh+XvWmWWbsPbzAHdyBLKsCYRLJDsWyFun6vooW69Ig0h81C1Ms8qeW8LJchtrElXKJtqRt8q2M5am0eBvnPs3kBvTt/jGiORDgLqEqTGS7lecST1V+BZ8pqKuf5WYV2mxkXM4COc8FgSgj52lWJjMePJfxyKnAY4T+XoeJaq2PqflsY7d0pS8zewEPpsVMJDjLDLa4MxTLhUZzADVMkjYLTiMxqQuBaWCPIx7o7h+RlBY41zKSe/JZhiQnZbFa8lcj2An56opXjZLofduGSlWbEFLq7WIRAKoNgRoyUwKawINTV9sHkHjWLLetCCV1t6gBYfsBphIQn6aY+SH5EE7O4AFmyt/IM5gzoVSm/xzayIABcC7rceio0mQ2JziPsmmWxYaXFgtcBTdwd76Ix05rogdysAxWPEJISakhh9Q8ChAPGpRboiUMZstamLFPM02tUc5JCY+6+l0ks6gsTctBvkySZVoCpi2LhKCX86tE8BJQk+5hxNHUZI24lcuoF68194qGQ/lj3rpx7KJzUyQxS4ZW4Hm5ee41z916LtylTO2giZdjQA7qFF2BRDtpNNNWe6Zjn4yfEi/qNVFct0+Qc1mQe3IhpJ0vKrRh7RfQXl0rtoL+cB8X85qOhqp11Ev/nMT9N+JYA23R8sitAqbzBw7IcIk1KXGZ+EvJvZWWZISRKAX2AOYVFCbg3qL0QPIuYiYtqh27BuCoDHyXEWJto9h2W74dHbGNbNDM93E3pNSqU2vqe643phVEgdiwZ6R6CSzi5CTjLAcTHICmKHqhlvLcdKEufgsIn7fRDDWu6RENqWZt6mhD1b8mhLe8BKOx8FerKlft/kE5hJgTMsKUBmSl4HlzqUWnrj2k/i0etOO4i5j0CxFV/ULELlhXvxDH9/mwuV8I55uMPLkIHKvbsdIRV7J3aEJddrw+KKJJHxF/jr541065dInTnQdHT3f8z7sTHE0S7xJf0sOcGk4aAu19qD7Zkz6+sKfrwWWwraGHe+9U1wvklascuCPJnf2CXsXF4N3tFVHVSjJ/oi6NKRriJtxtw7HPquZRtPL0b5Mgu87jM7DKNZ6w2stDPzfay4dcLzVJenkjgql+cefoF8EA75uceh1GmpSmn6Xmljl5uLOLVpRjNByY4K69g4cC+Dqh+NJeUQdjyzrn18C0GygceMa82fdk/WipPpE5RkZrMmr1W5ACoWphXnysTaJpqIDHObMk5pGqSuz7/psvXvurJ/wWwT8Wrvd51tIoTztqyjqUijw2oKhqeAwadn0BGMw0viT7kppqx6gcRAUISHIRizmoOHsHaCWqwMSPy3QS43BYOlsi1G6Jb491O/hHbUCdSvTkoLsFItSyJ9wN43RRabrHCamlG6k6FCi915BcnGfQthWlaE2X5SSfwWNBzhQzquez4KghC8eCBxCDyGlojjIungFtQTk/zQZbsSArRkh47jZPMk/c6Hz5NUxGZ9XBpJ4pikJ1tl+juK1zxH/c1gT+N8ALLfIJvhBDXw4wxTw//KZRjIW4pQvoggy3NRVIdo1YAJiEaqZCNTW3WzLsnkqPWZXpoJogICXPUf0W1BLJ99gfBZQJA9IkiI+W8Hdpbz84YYq4qdopHFSgPZSWy8CCo4Ne3ysbqpBRmxtxdRnwxDeRyC45wH1uKT9UIzG71qDUrgfL6MAcj/+SlOiJZ1WKxEWM89Bl+ETd10nHmtonKImSx+RF1w5rqsysHbO4pjBLGeIyalfM4itJgUkK3ynbjhjGlqN+vVslb7v17SxrwIujLlI0DDQlE8tdF0HJCqHT/Z1MUzXENt+7ZeqeMkTQ0LlUXHApof1FUEXVYLpIrQ4cLZv6psfTnBgEYhz2sg+WxsNwapp7pVWxD5UJuVexgkC2Ob/ohd6rPCbVpVNTXUP90+H1DB920RRG2CRX94pFjB8hz6uiU5zCiIyo//MjEAvXoOikAFjVbFweIc6X73SlApOxi0HGP/2jYsdLdr73i24S6koKWdhNFO4n+9l7ZcU56gd1NPpVJ2Xcg79/kbXu8ZZ//usEOm6/5CzPVo18aF7RjXWGPn6Mv6Gg/9v/+p7QmfnYQAFFgLoi0PYuABAbHxwx67xDD0gBwXQSK0REiW63FAbyFQF9JLRaxu0U9VlkIn2s4oHICPCKK/AKKFLgyJ3G7Jd1tLVLQfYrFbMfav5qc/MX/+PRmL9437j5C25M1fwH3sYMYLyI0V/xVhk5g/eCWmL+p3/Lq16kHwbZ+1G+mQ/TTMCokS4KNzEBM2pt5AMnY21E7VAoljgzFNoxY4fii17oC+5N8RJXuTWgurPAB6wVwIe6GlECKkHdFbghlylVUbYOFIGEJxWGcRV3UUS5qqHqsdY6ekIREhvWko8W09C8ARAkqiII0CM3aFIYh2x63YVLAdzCisaTZPI004h3pO86aSMh73mVlOq7UgMe0bXiOJZCXinMiwweOtMyk1EiQHZbiPM1h29y4G1B8gddzb8gESA0XRPHa4n46dW8vsnLsBQC2D+mpgN/H1rQJ0dGHnBk5M3DjwqCHB0lI77KIeqOnuAjpScJCIDQkx/mjxksh354qPSknn14xGaQIeeR6sAYwz/ZR9zkxuuvVia3/7WY3B+dmNwPVCc33h755D7Mk1s+DLJfezwn968/gsmtY1ed3A+Uk/tyLrM6iUNz3TTUMdERyfkdzyK08wntz35DcqA0N4nSp/LMcRMFpQK+pVtyBsha4ZtPfTdH0N30WzxvE28fC2tjKpuITMZnnn+SEzh8ZBN4wpRStY+h7WNywj6imPQ9oZ8449wP1CrXTDFhX8gPvGbnB1dozPNI8anAdX0Ni1b15RpOKMSmB1dLni0wVweG3AkxKIIi4OlEiQG0Pomn6wFO7pYb5KlWnXdBPT6kCEwBs6MHcDyZHHhx3rCUAjs3iDzwd1kPN4Ox/6vjJzqwtiHseADl52AXt7VJIdxgNIj/ZLt5nSRc9eIDeDxbrOYcyN6h8KdEL2bLtQ/xjZtpt5sb6zDTHMCZ0i48UO6BDTFOLFIBnR3SO/IrrpeZMc3+WbaN4tA8KVqVRAg52keGxQxq2l10qEMzV/ZQETacbdiA73LizHA4LFrIs6toc3QLebgVUN6VGhgWdQMbPLrSOHD7HGge6LNfS8GIkBqYSZrRSH4EUuitjMtX1bmoMxPyDaw5HtZAHvA1w5qPv/7fG2u+8uqTwxolXlWsucQu6/34AJ7y+eoB7KSspROMVUz17HfQzU46Ef+7iE8/H/ies19wmK0X1u39Y2KB3wMh1aeIJcD9PxgKIOAFUde5Opi1Wn8D9o/55W5/DTUyECJJyjbQC+jwZ68W7Wgv+2XEAP/6ByNcrZLgAyG0uLF7ras6f13MgHRtIkg6yiMPnQGMsXZ8wu5hiFvCDxEncjex9t6EDqN9N0Vr2SeREfH9m/w1SdP4o9fb+IMj8W/WOaGSsRouYXLPuftq5/IW5N2l/fuwKcEDApSxh8vYi6ZF7naRHykjd06L7E77vDUlsozRptd5VC3a3BS5xfMwHCfZC2b46iaPn0xIDuIZw2dhAugdwmvIEkw81dqfuMgTjCviFyv+FRjAl6MAMDpI5hSOeikK6QdrfFZ8nn81KuoH7CnygOZk7JWLYS+kpP9pzBqKD+hVGEtXVtUz1u4DFInEKBY7enBMhTXZiuSQpmY7sZkgTxonbKfMN2c5NcbVFvWyJqXrdEvU04OnX3k98ILP4yaJ88QEFPPZlMAlnhTPnzakUpQPWpv9DciU5r9E8kPHVT0ekFeZnkUgrQmyz+kHu/yrc0C1gSHjRgC1E0rgrAOynEQLgYAm0foh+0Hw8wjuluD9CJ4lwRs9iHok+BBiSYIHEbuKoPp+60rwQQQXJHgTMmQSPIRggiBojWFQD2AG4vriMUwd16pQY3VJ0wZOxjbKGMXPhPHOYuMXw+nY6NBuOlaOYmNcwcbIYqOn2IgRV2yMHDYyHgJ7dLwOIJNDQI+iqQjI4yYK/Z7DuVAEmSXOBQbnGGSKc5HiXACcC8z9pUmcM6tU0CuC4+KcpzgXovwT4FxAQRXnPGmNV8W54Osb54IKzv3e44xzT/RK8SCQwHgFVbflQfb7yhIYCqHbnuN/8QdTvvj9c4Jt7A4mNKsqLkoVQfXIaGPsyOgd7pBnwx0ZvadyZHT32Bfvd1/c7b74aHlClOidZ/34nrGPP+Y+vsd9/AkE1bYRTjTiMqTKCKqDQHrtEJiFkPI1CEmt6vsDoQyhdnndawahnYYdOwv43DGKS76xm4y42RcXczR7gHUIoHUcYkIvvDhfFGTW60Tz+/NlvO5GoV2EdiG0ReRQWPhF8Q76TbIFzGgLRTT/kqJHPVp4MT8WDuw/UKyibo5Z3M88ZtHjt/3YoM9SF1d79lMHKglwRo7YHq3QMmQd+QrN9kNI7308fOMkSAX7ihNo0J58Kx7n5tvwoHy7HglRX6CuziBW1rK/l/wNmgexyHvCuc4hDEWTNgcpocUDa9SC65N8gZb74aX5qvo7Fk0wlFbMIigFF+yIDF2I5OLWrJzZYLDEL7M6sM4jQtthSduotVAPZ9YztMAH2aiBVnt5qy+4JR9z1eqHF5IV8RtT5KPnqduRi8krBuvFXHQf4oh9t39/7dBF953/qrzgz0jPnpGA1krp+ZzrQ8P1YVmNk4NlxB4CQ4/er4rF03zLJCOa72CIdIyeQJ9nmvCeHdqCP/HFkGc+PEEvAzpdytRAx4LYmVmmBWDaypr2dK1g/z5+lu8kPFkxUY+VxK5Vj/w1RNKOhz/n5Tv0LIm1POEVEGBVb5m+NCOP3IGZ6nj4qAFX4xo+lNtOefiz3sP3ufOyYpZmJfOptLOaBJQ2Jh99vWtjtUEXdfzm0B/bxEgqJygxohvMMWfELasYhljV4gjFGbWzDm63d0jcH7kDtcLcbQxoh2q/gPe6hkH0EvZi8b4CulMF5Vf28mJkDqhjoTxF4guAHEvErnU92sa9x0kfTrnyOUEVgVuqOoeCQ8UqsMh/cb5F8aUnNIeZSl2780VzX3SMkn3aUbL7HSW7D8HUIZtv1BHGPv68+1iTVB1ByeAWUYAyJ/w/P3bC7z7UJD3hRzDtS5NwdmlcWPelGuk1dQ7Y6aTdWwGUVoClsNPJROCAwU+0XQqCPjf0gqiHrd08BxZBEDCSSe7TgpnpvnEv4sNGk+9m+wqQq2cYDkQmFoVW9Jz7oZIoKUWSiY5XdWOlno8jNAc5FdN8YLd0ABS7B4rNrZI7kbVR2iglFbNSv5YsTFof9AdlAjSg4x1QBw9kFsM9qz2sOyDgvDrD60HAuGiU7SmSMYoxzwP3v+BYYrpC1g6jkIXn5eZp8Ry7+wx/Sje2CN0Qj2dN3DBdNHRjkZJxuhEJ3TiV8IQWrFIBJh8+LeezFWowa4nAjpGZrskZ7aBTy9hMNfF6QlbquCjBA9pzNMAqTXVpCwANvfW9OuclvNvM+Y42kOYcHZCw0ocM0z+jjvFBUhkSB3vQz06/w96WzDBB4cqNxbwbi8WxsajpWCRCbOv4U8guCCrMCxWbNkb5qRDeZ7SApXAxjxiIPjEyTs/LpZ9KvkB1J61QNELMFZw8NDvIkHUTs8POEcVXOZcvZg1EFwCxUw00dwjU1F9gBVL5wlQY9MZgUGcYXMPI86jwcZEW8KdQSwRmPXWCnjBoMD9RLJZxmhXrJiMYySgQynVlvBC/3GtfMtymty81fjmKuecDNXVFjazmXQRvJb7g7g7YaPIQhdfxJSyy6oHGTVzdYmdisfMKhuNu0vDlHCbaDGsXUOACdZRsKNFQewdtWqUZZZJ0GVfauAraiFmp3FOX+OOShvDUWch7plPMwiGTeL4rCoi4kK1c1fKrWIJXen/0D/C3WPmZxummzc49wz+lwJ2UZhA5Qy2LG++o8k9qdwAIgmiZTpYnWuiH/IljhLY4RigeQyOwKubq/7VKipIxpgfsIv4u7YkwBEsXbaFY2R7ppXCPPf5slWICSlWw5bsZDf47KBijub44MqZE3zE0ZBkaMM6qOL6D9F7ZJE+DiadJm/I0PYCvZ+8PMzXahKcJGG1F9QBhYxeWViZ5mgSFMzaY4aAF3bgtOkAvbw5ogDWjRcGkVepyCJDr6Y5Chm6ZoCJWYZZArAQqK1ZbO6qkwhYpJTJTC9EJAkYp4AXvWKeocIsmVIuqtGiVeMhVnFAAM1cAqxXDbi3ihemDAE6ZrRptVXVxZba6jtlSm3SG2YoNs5VOZ7bmDbP1I2PMFt6V7dEkZbYQTBXBq8zW2Mefdx9rkjJb8rGoSOXLhtm6eYzZch9qkjJbCKZ9aRK2eAfMPJNqlNlaRtwksxVgNwVmq3FAZ9Iq2i4F5R0hKKvKbHU4ILszjMli7tOqruXuNJ4WzKhNMluLiFy0d+Mts/UjJ81sIeemzNb8CZktHfdIT07e7+FZ8lYBTH5teFJ5hRWTGrc4WABu2HRK2+ZlsQPMi7myfcXCxHYt5dvFefaoFruM5vF3ac9SrzlaUFOpHSVdK0K6Fsppxvn04pFhvQLHevHj/R5Dpu+NsF++bMMqVEtJ0yQTZmMzmhUmjMvbQHmymtQtI6aT0WzGsOWsMGKBW9KUUC1rc6nriJeElajNg2bN0/Kl5kbq8jOFz8oc2Ocd2FdHwQ6s5dozNT6DPTPxo1eBwYqulYbtWp0kX/4E1WKiQZ0pVEsVx49LtMCyVCkWlGgrAGRpSr6gSvhGC3K5yn7qPHRomCnRVQZU8NFDbxxgtjjAzE8woMBHMF+OlQJ2rUqZW2j+BAzoKriJeWy1TsyAAqMcAxooAxpkikqWAXXKslUGNBllQEF4DAMaKAMKbFkAhiyUGAK6NQ0GEwzoAqVgwucfzZwEsuBPobYImFkGdHEKAzo6K6vsZ1BlP4Mq+xkY9jOhWTMvT5YDVThuzoEu2EslixUONKhwoAHRZtN1Fdz+qkFMnY41oK6D+OLm0xGg7tCKmY662VmcNusymaejsy5ifJsFvsnM83XmRaMzb3PMWahyCbQ8jYGOqSlLgC59bsrNm6UvxtLHzVVeWjBgWT9YEOq3uhkvzXPatLHIKafiys1Y6ViaZZdGZaWttTnjkbulWXAUa+X2/3hm3OWbJp6YJatbyfrAG5Os3zImqrkJ78o9SJJyDzcjaC9jjH1xu/viTvfF2xG0knUjxB/78B3uQ01SIX75YShEtpRex1YUntetcDxPSol2oxSdN0vBeqpy+JYu7u1SzD5TCuY7pTg+K0X06rIbobmqkHpehdQL8q3K2BdY1x6dqLIolEFmTHMvLmoHyqvGPnT1D+wvBDHyOUqJm3CAWrRMbWRcE5l1yq+McQf25y0VWd8lm2VfWEUJ1vQ6ktoaayvPj+tkTmxtTHy1R8TWDRaK513KaA4XNpuUghZh2PRTJ7G2MuveqMx6cZrM2q62Uk6+6kTYW7kUFFtsk3xi1rVrDwjyGdex7a5jKXrkLkryuGyDADueakAtF74moxh/6j+YWfdZaf52SrnPRHnBfztANFaophZYGlMKK/Id8C1PDCMU0yx3eHNGso2nSrZrBtxzVrKdQ7Kd62W5tkq2AXmxx0Ez1FTBVSmixtVZKmXZ+Q57l6+jYzRLhezrZ1V+YiVN20YFzVtRhywhuRE016qC5h5t5f96LGjeaq7jVgXNvRSJImiOIN/3aUHnAMa3mClHON+m49eQ6cOwRUrtxXnrkYuUH4UceZs4WHvUcuQatabIkeMxOfIcgDCHSQdJaVoR3oGqAx1A1TMOtFQuUhMGL83bMuGc9LiJBaWcdHNrRZsahlwjctX63Z/bTHrstjPtlno/Hpcdo0/SaCYVcyAP3Caaq25ndKh1O9O2S3CiNzSpjl/ezd7k5rvu/AzXKPHKNeqwxzJt3TRdddO0OTZNWxRjms5uwisBRw97BlkP2sDV5nkFgTTO4o9lMDVp5owsqU2QuRWSmYjBwVVqPe+rCGFA/+ykVHFCbQ10D+WoRAYzBHRQQZRhNhiOp0FzJfOU2ykFl0lUc9xTbkodZ55Gi5oD7OeopbN4xhhXEcZJXw7ihczL1RzOJKzcVc0eKMV22GLlnJoO/jMO/q1xMinCl6aATs8LZqQlFYKhJLApEJsbIyTUwqZFcHorNcpbrjQ3LnDZWsU0YDo4qLYxML4VbIvhQ/QyoJIXj+bldFvJS+rIy/J08jL7yIUoj0JysowezDxqyUmNZqdITmYQN0Fe9NboyOZsSchLR8nLElBfmYQaZeVQ1Ky8xJGXZJK8ZIjkCQS4d2juZOQl7ZbnCAxybkpgZo9LYJy8BAtQSzVNWyQsQtuIS7pqUtBIS/JZxzdXpEfbgLAiMdHZB1ln020ZtmtDpyF+RsvYqMbGvuzKoyRAMc3iT7drS8I+tEB7tsHiSMfcqO/g7nt1s1YTEUpBePLmS9ue68UdER/oKNacCKVRilBy2lEhJZopA/dfEaG0wVHMQZFVBQBtasJeihAu5RkynWartIRhcYSl5ggLh2e0tbRSSlA0nCEvVDOw65uxEpQZlaAsOfhnm8IfFB+1qyEKcGvEjzkHASM8FSTIppAkFaBUI4UWzRpaVKtQIaVJo0QoGSNCHaWBSooaAF/Nga9BM9gTAHxLAN8SzbhDqY5DzCWHmLHSUpWhzBgZShU1VxxoZsdAs6qomSlpxl8pofNlDzhdhpLrFjemDrZ1s4Y4865lel7d7apUDqTb4uZcRYZSEGMbzVVkKLllVXQnXAEhiBFwpTB4lAu+NIEjzRJHpvZ/bqz/Te7//3r0PMGs8gQKs0wgNocpGRMcomA2oGCs4NQen5S7jUwGYVK5jIQzyGY0LOITglL648QAYLaCLDftoQLSqlxArcoFbDZZlQsoEdNatGtMnYydKZNxiRpmMjbNpOtMTrpYZmklkjp5DZMOuCYTz9eJVxudeJtjTVOnnCFLM25pKHwlJy2dX+6soEUp1r4t1FK+VMirHlFigklb5syINKjtBCZbuTLbKFFP26oCE12bIDBpg2SAGUu1HcaEmF+x56ltK5elFXeAv0rC93qVlYg6dk0DorldwshxfuSOsrOxcVmibZgJ280itfwoZ8R2WsGfHmpjyYwow4yo0zZV3YMBh1mQWWxhG8of64zwzTLlV5Yp0bLojKxRzFRgs6qrE7anE6vTuJYFRsin1C1NJbSX7NK0rbI0+RVs91FwrC2k5VLLQsOZ5F3BbFih2JHptDJQbhiwYsdKpHXwQKTd0MxuPjQrOjSAXIua+FPwCpIAmMcl0kuUAnMz7nqHwbByAiLd8B2RdsIFBakl0k7Tokqkw7HptkqpEmmFaK4+pACtpoPWtP5PEult0LLIHvXGLcWfwqwFiCmRXqLWNCJd+CNIWSHTfoVM+xUy7SuZ7qiOxUnTaADwxDR6lVpVGu1XabRPtBnWpuq5Pq4SOSXTqREazChlS5WyYbQoVtqhlC09DmVDtlKG07tqM9KmJNZKFXzrXXVQqmv/r4r3lvA87c4FQVfNMMAPju4vuhfIChSZOXduxUPcTvXBQR5gXV7ywtWl5xUBBcPs03IZCVra0JL/lev1LnL6/3jeFI9SAXnWs6z3rAtrPQ756gIqkEvoCxLC6WyGhovtpexP9L6tM1XxN74XTrvDiv/Ke6x6AVgv80VsO0WT9IJfEXLsZSYu4iwv1ZvCAbz9qNk3NJWbIe7X1CES+1WEtnWIuROgbcRzR/y2eBSqT5xLe8Yvd/aHemVarIlsXkuotaBNeuFAf3DFvPD2Q/+c5IsI+fQ+hBoowXBWb0l7GDHj8QfwDAHnRB/OG1B2j/r081I0SC67IU33aGHVeFMnzf5I77O/4NFcGP/jiQvjqMLeF8fL2HXxp0ot9nqUDuF+ts6zn3Md/y735BV3vdutQ1a93I1GmLvd3+H50+4kqEtGuVh/do3feD5ZP1U5wKMHAXIH/NNT7i38Xrvh8/lKoOcsr+LfV5S2vQaBmwSC84cCnQw34YljC2lfEQpD486Sn1/EF9ZehzyYYeJ99ahHBrnhBwChG338wp9M8DLyzJ77o56e9+EOfiJczAZQyN2LpUAvotQ0HwXZRw6ZaYQ7nC8sGtKKgzee04eU2DZTW9i4IDiMVsXU2PdHr/zjfzz2xQ9eeCWHf9jfddYZb6RnXvWSlzBncGHtQzxguO7ZoMaEO6W73z8caCXy7wVgtzjbbbfi3x9dPKQGVQDRgwG1u0zfdyqqhMaa44EiKfv9Dk87Rs13UvhOQwXwhcC3ucZ0D7NtN0kw+1MMZB7aa7HwoFyklL4KoV0SuvZX7hiiv1doWU1ZdJpM/7JDIH05qNfIsNRPOCx3M7jrI2NCLYpMz3/54uFQhyT732jcOjr+PJVRDd5VyqiOGpH3R0FK1BDaLZI6/f7xIaSpNEsKsR6EXIFSxMZmRRRtLuROW8h5/jENVq2R3a1RxDn9T7jqtAoRnh2VmjHtMbbkayeyP0M3wZ58FK8bor/mQX+4xIZbGSbIIPk3ihZfLt4nOPPxj/fFaNpMiV/Z3iGAORxQsjE0cTv3Dq/MxR0ht+c7+9INCnXEfYqcCbg+Rx1G6hDjn+Cn9qpfNukXwUTc2d+0+rm/OG/lYsk6+NT1h3h8HGqTC17VK+MP7yUXvLL3kA+jEORd0pMLvrVv6WX36hJHPNn/MwWA2ndgmZBb6VUQX6Kzd68+9uhjt7qMux8ICGEonkH/dQE86Wh4Dwcf0CAuzH5eg+/A0nOvhuV22Kc1fBfi79GwXMX9hIY/ifAxDf8hwh/T8GHUdLeGP+QZHFcVOpkWIAB5QxunS/0hfHGWBO+Vu76urp1lK6ls+qprYhdBvWynvMJNKCpz9SWuqaEEP6U0rlFSuT8HrOWEGE3gI49A7yJyYkP4LBAH5MTldcSAHp7NRFgXBKXVa5Uhh2eqVDN9yNNM4mpOyaXZpAIALLhXfytoTg3badSnAiznFE44uKBciPtJ9iYsbHlNQU2N7C9vVIboR9/Iy57GZrchj1I+pLwOC+JbJc7EZn+hORgCP6gLZT/Tki05vij71I1jWf7S8/xXYdUWawcU6CVu//xA1u7zA+Ugwmdc/Loieg1Fr4SuAr9e95prYRwT0fFrKH6lGlP8z73zg10k5Vc/8CjY/AN1hI8c39FmAkXBK/OgpTP5lQXHSkrvGd61eZBqA3djXy/ZCR+Er8Q8YTgq7/HKgtOQLh9JUnqr53t833CKVzqxokmeWlRRf5e8C9N1EixwkvubZvqL15eZgqqzuMCtg3eYYLh3CBOmLqHwid+v7KW/4zlO9yCzELEpJB5hB+JN2YHv53WnaJQrTzyVIYixfOGR4EZtvQ/srONl9Vk9/VQd82In4L6KtDR8xmshocViDNuz50Zh9j61dsktt5z7qzxv0lQWIGaY1uwvla+Cwbr7NIjFGsb4lOUNz/dhW1F9WuKURvCvtF71Gf0GTDAwzYchi4rxqks8jw3HWnaPq/usmj0gMB/oQvZXiGi7uUGBTgqMr50UFKR//HVshFZiSoOdFbsc/RBF9ECHsJfcGK5PNUr7x37gXdd41RQrQVRTwNcU8N7pTCADPPYUYmP2/9d7RnYddi3W5Ox3IOIZ4Ws1164ixIO4gYxQ39Er6pikEafniSxp2bXwdCgFJCSZUGbR5ML47//X4+ycD9XmTalWTbBiN62WEDkDXmCO8jtRNJdIze/I26kkx6iuQc0yKf2OvIWkNnsuVHdX4AbUyGOgxM3PPi8ohebn2nwAG58X0bQ2fqfq2OQBJpG++A4Bz2P8r+5n7A5Id6a6rZkAdJqeXf1M0MDshQy9wbc1/ZZzfzQMfexBnPV0cjRN8VUPU7BWOy+neYAqdO+jKJwAcwOGkCa07KbIMFCeYd++KJNIiM4Cf4FnF4sbAqscyP5BeWy8ZxReWEPTfSzrsDyXfQmppsjA6mJl/+his3+S7yPz9s/yFpi3B+UtlsPMM5UDFkbRKUsdvgvBEAvTZb2N0savnSLfuneAL4U/hk2KoSPDeLWblcFFw6FEyPZDe64rvGvzl5Wa3IF5OxhgViqTYeDA0QH2ClcWPuO+Mha+YRR2C5FInd4UBqN+B0VHiqg0DyzqVzGhkeuYJaKDJoMCmhDpyhiV7RfGWLtgYri4dSyUXilLQYsmN2YXDQfpL/gw4YZhx50Ei30BkMNulGvVjXJNN8rwp+2lysMKnVItuxHkEIBk/wJoybuJJ35ehY8BYZhqQDykU+StF96+h376C7//nO+5/GJywat6+75X/n324iF4qRO3C80wRbvtVuHxt6Nt3YW6PatjWNmnuAKZs7M19S7JxYXy0zx/dJ76Ok/97K/1U8Rpqp3w8D17ROftiYynHX0ljKf9zVTjaUPP8zexEHenP2bGTb1z3+4XgbQOi+XAp8B5wdUMh6oZbpqSYbemB9lbX+0idxk5jUZWid8jpGKvfTzN4wbk2WNvNXIQlHZx/9bZxVUWcswu7s/6Xv0krUKG32+NQiKPh4rHjcoWAeSRzqAsxIdimoqfdWdS9u9GrEC6Ow/SeKwMEep1lcdc8H7BfRkSrEqBygtRL8xR4osWvpRQAs5RvxVrx6H6Io8ZqqhEalBI4IG07O+dlUnlF72qtPCBxyAt/MKEtDCsSgvDk5QWXv1YpYXeqLQwtNLCGz1mG6tLMsgVOPt7PPwes1b0L99bUlomoCpSdxb2y0D2MPqLWsXCvj9mYZ88sbHv47/bhpoZDX+B77NQkZtxFqydya6apHtFBD4spvhVxKE9EroWQSojd5lI3wjxsn/VFRXA1oiH1M5oeuGmFOwX3zidgpUT9heqE3ZM2rmAGYiDB1GeVlbBMAS43TINYZT9grk1TKwDFGRfsTR0l5aQaQkLKIHU6C30PEohwMKaInCIAoS7/+roSQJOKQLXXUd3BbfJhLp6Hx42NEgGPJG9O6vVeoY+W49YgTmCQaavZdlJ+t0B+Dv/2ooVd1uVIZA1Y8cTfEeAr7k0Dt+BxY95E3DkoOyoSeggvjMVpB8LYs9eFnAb4937i8gSP8X7InYyN7XsCpQ5sDFQ1EA7DhR1lcLRfx/4z7iqqoSQqOMd9UBit2S4DqXInZVsj7UC2Hhx0XwnDq6yV/6ybHKoDvOHB/ZLZJcjU0qHvAFqUcu5VOixtBCau+sU80928A1O4vHAddDtoQgGDNNby8jnt6sZkJwVrZFkQkXE1bA+RKzHODH4D2yGsXVhqCbW5786u6lARM/sIpZxWXtdI0KeCLYWY5Hx4GXnWv9XbmJ6hXiV8iiQNOmHr3dyHo1XMQ+oo92u/kUcBmyiEGPpDiPsUDp/EoeOMmE7HIDBVRN+Aw9hWV2OJ9B+u0fMmUMQUJUpRBSpXPAKDgw4NUJq9ttv1PYfOuQrcYWdzRtRaYw4BhRORPilhlcWbGOhxGGJlqLibsSCCj/oU7SJccX7fbWt/nLNebWxuI7GeLCNNupG46Cn6TCWJvkv5wdB2iqPvfrYo4/d/Pgw59llnqSfPE97KFe0Dar8L6AWg1QPP0wUs6waHDDf2eh7KvpVkfi+jz/1uu992+CfLrZ7kL17h9Cw0M4r+6nVKApotG6/vH0X3rT7L37wfz3z6Xrg4pNfxlzpbnDoXmyFIqyltwOstwdmC6Ylu71CjD2YRN/kGUUisA5XFDEeVxV1UcQCMdMQiBk/cu+4BC21BC1VIwcUSC6ZPCPkkCd45etYv/bs1x7VjSIP5p4WgIkYG2XZCMZOSUYju1+7QZEaSDOxnylj763Efk5jBbAf0rNsZLkx0AkhCcpFI1zKtd7ajkOmlHVQzVdZa7RFkjdgzI3Xn73XFE3NSs3+AwG4nutBiHIoTUX7Pv4x/Pv8xUNO/ShSsVr98h1DoWRud/ajnzr1/vSc2acPBypnRQ5YTo2u7PGznr0aRcKUArWzGyQcAYxIZ+q0EVCTy99AV94TgOry292YVAwXTKrmM27/3PVH737dl9/6FUboOwOaYXKFnxokiXmCj/01zgxt2Jk869/9IFMfUThDwV+Vhs9mN6JmLRr+seb0MA50ZB5r9Bws4RUL6sRlAQmhs17PKKba0rp9kNSiGpOiCpqnGUoJDXoPY+9rUKFpHqqUCjvS8GLO+KdKtDNz6MmzeuKRD2iSwZ9IRnVGOFw15MAtIl+b7b9wTSxf1GmRWtiUpqb4BQEAtTgeKT3dxmf91mVtdPqugHXq5MZ3GxNBP1KZaNEBBifCbrZRiYhXYpoXB1xzgNUsLnJyLMbtymIWqwhGkAOxMaFiriQmKvlrE/9d2aMOvx7Z1z1737f/a95A+d0DTHj+iUdn3VESEQd0cHJ5ZyCzZR69nicPBw8eZZehbGVzW/yYyV4LuErn2pwGrJIiQkjbl9Az9BVs6jBfNjqD2t1Mj1Nsd7OR7i48gu7yuBhPjrbPEdCdG1LUe9x/Xw6mfRH/UE254aTv6eZBb+/NkE+xzoa8S7MwhOgfwGXxjIHEmQVK/AFwjacF2sg3m3ltNRjM0/11+Bh3OX0H4sTCt1ixIN69dwAJ+C2I3ii9RlbFSb0jDwX98GXYrM7DjzFVvx1ImjR+lbp3GMHGF3mV6NIW6lKXOZsBXH9im1d21Qiba6Zf/cOvwKl2Hqb4Zh1doRACzaU8dH4OoyEtr7/1oRjZJD3jB39hJCI/zXTIx3WNnbyQZIfQe6zLRE2qIxp1Z6/XWX46VCPM5EXa7rwuRfpn2erqTjwgs3kkUmqBMrQpN5Ebang5C+d9XFhH4mvylvQttZkFxibqEzQ0LHW9fE2wRiRUx6POc5ngmXag5k3UJXNTvWLgnaQRRD510N03oF9MLBkAkJwgbRU/3f3YEIpB7VSnu0cLwPAFuYefZ2KpBNMRCMs0DmiOPhs6KAc06Hpiug6iAwy/1rqt5kYocGaojnPQupO3cI9n+i3FUl19EDP6murrG2VcGrrYgES9IH1b6PxaHHUG0p1Zc1Kz5l19W9C3llr9lsG+SSmBvHAL9QazsREseAcWEcXFGE4Rc0IhLuFuIERy+hvDWUkTllEDdPBcPbXerWowZ5V7t4sQUhPOOu31ekwiPqnqspBkb9IZGXBtnFPFCQFMNv8gEiQeuC0VrKJR7/Dxe6cciWkzz8rrKB5BVoPIVFYYixZbncLsh1AQio37N5uow4hK9RMptPssFWaIeC7SU+xQusJjpe35YWmPCIVC991+swVAdCRARQSaneGnpa0U1kgBVHMAUsChBlQYkq8VvRkVuQSN/JEysusib9bIiiOqn/K92OLHbncqF1IAGUaIU7Sk1CEDTngMX/zQfr7Em91zg5El9KWZOJXjZJz/3fnG8hbUziI2gik0JK6KEuV+fiV5tZqsm9l6/4BMIMzpF0qoITCKFT90L01q+MijhjKRGBSsvNdYz2QevEW//Jq1sYP3WI0LC3nArGRuoYFNXPbTb9TB2126yIJI3OkR1kqxn6oSoqlkxICCrR6sSXG/VH47JoAUgzKF8YyH7KyjWHpJEZmFGEDwNvv4av3YSMU6CKBBKj0zMdl7zQh4FYmka7yRRjKUAKlJaWT2S/i8bNQjbVG2gc9PZDP4l984qUn3JS+EdAN/RqfTz96l2xy1HK4Hq5x5+qEqJi5nUra1Eg/C5c67/Kkf45JXCJ4Gq506UwHCUANslQQHg7xOMdLKhMwmxIqIHiA0hGuC4ZHcx8kghwY5HDiF4sxPKUCN6phbjINgyP4iCpp8Zlefrtqqfba+K7jrsK9qbB6prS9ZKUNVnWCtbrX+Zc51ldrkEeqMsh8Vdqg+vdjaIy32pSjWL4tNbKENLVTu7zbEf0XKopS8hUdStNX9plzyTZE9QuYOI4nbgrZpZriOSyC35jNq/CyjRPk6CLHzOTzYf742Vg30iLW2IsCM56bBH7F2HZ3SkEf8uXhNXKA5kpz5ounvgtimLWKROgfiywIuKLE3NaucOAGlxTWnrQk5EImMxL0PZPMGt6HEJ+3r4slQikuojWQddl0BBI4egBjZ+/8pQJyKirobiYYZiQCjIiPRQLaGZqNIGCttIVof8oTMY4GXdrd/hfgrgkZKCw9VzMcuAt0cyERGoGjrbjzBNifgh0ntampLU6XwQMt0pIx8SsrTJuVF3AkQ1dO31r1kiitYPenONjs6AAgsVsWKVZA5lJCJFTLqWEsgEwMysYoYBOfVKaGd8vv2rmd/W/H++qS9jk8vGfECi5H4J0UVB8D//ekhMB661D1bl7p9+rZX3/bYZkaumVzEqpLNkAM4kr7v8KsPqbgOiquyAGY/ZliFj9bWJF/2FkTo6km6PMaGdUTUJcw9qh2UUL5HU0MREsoLyctOfdlJwnxkyjEAU2WhNr4Gd3N1e0ydt0gjEuYTisgCDwlyTAtzjLciQ3abTPSGxGLlH/FJq65GOTb7SbCmaoFl1brH1VOfIhUkpVB95pQ5qCmKPWqCPlShfijtMydT/MVbHTOaCfNUYgL6vFGO6Hr2szrCZsR1zecC7pAqde65UrBYWIs/SvCM6J5lpXJm1w84GaO1xrgvR9NyYBPxQKgjX6Ci5vSf0/bUGEIsH+SJyUZJ5Vu/pbiJjLhp4MkLh1IIx3SvoSDhh/L5AA1DV2PUXj9iQhPzZZNHAbaqY3q7Ipaglov9cY11rlOplm54ojiCP/Rn9CJFdbFVYhpYV0kQotSNvFs1BoJKVutlXzzr4lhCD/a97+U7gQJs4fwsXF6AWCFImM2Yzyz9izgGpQe2ktjchjEGBvjg3buuv9uIlMP+/RBMASQyJ0PFSBwA/SZ6rdcngGHqWi59bxQ3eOENjPK+dakRWmc+QC/dTsJcaCj61nqpmSLnBRrrGG5mUTOfafmpboLMxeQUq0VHVoeMMiOOyIRuIW6WsuqGP5MLfBk2/OuwD9TvXJPPCwAbgNV8v/MsrQajAEEJhTTnNu9ab0fh6bbwLfLcxr2OUZrBA0LKOsCUWKfTTSEzmqeoxqBPKdNG8qkh4MjeJnsiCdO8WVIDWU8t+jQVfWBc0+DE1U8vVWrIO7s214NbferAm3GT2Abd7hflXVrA8jSrB9RNrMuQ+un6dCtAOFCJ4hY+huoY2QHrhWemZGJRzNJwyFAlznFPx+nw0LyuZ7QMhq1YMSkLLGhf4VJLYjEwwb0vYN/trPb96pdd+sKPnHLR0+DIfRaEZB6WEufluh2jQReD3AUy6vVy8gRGrZFhWTRjspDdIWMwZ4b87y4egpIwHuvVNGZhYMgxT0QsIBIBJzM4HJbHRukvPaJ7UEf9F41fhNLI0N2EwmZe9Ew88jh8NSLWTnA36uO3vjs2V6PAcLmrUR/jBI777MduDdzFqMEb3MWoR1KpuyoFQndEqVc2xHPyQhNEEqpyM3apaR35a+mzoUDgidstXa9Drc6TcF86Z3wvlrqcuquxKlu+HZFa+i4vULqx779+zx/+YfevXvr/5sg2eq6/70sPf+Llf33qly+GvFQ5X+ZsUYlsaMBGgcHWXVmNTfvCrBnvJJV0ys1jjvbRxXoHUgn1oo1Z4pfMmG45IsHsBJwYdIgHLkjeC9rS5JdUlYVGT+r1ijb4kzxEDC/6YFN88jiEewsY2sLv7yb+u6ynDIEZFiHSemfv7SplcMo/LxYdCrXz8GjgFJDZ2hZCMaWnHEqGqtknPXXBR6hr9APTfWJObvV3vognEDyU/eUX9jy37QFFzEQjSVUcf1hwnP3T4Ule9lXB0jFUPKib4xvgvzCYPGO3SrbTOWIsjRA16dljoo4IQz0AVq4rNoit3GhYehutq/FruTYto9wwezw9KEHmphynkZRGDchKO3C5h/0X/5yFihL2KMarmsjidP+udf8gXlSk01KHYqFOFEV05VmlSnwLtJFQV7m7VDxeZ7rV2QVJJEKI62roXLAvdalKWVWt6qyihapSuwy03TIwZc3xseYM8xlSmSXK3ctNat8hBpRUN1B2qrficG1ADbx3htSUtWZmdDHAUqA8ibXB2MJUVZf2Cah5Uh0GrG4T5/+19DOe19xMx2xhVMdsZ+l4GDjIZVlEUo2YWPkv1TfIEyVeDad/hu/FB3ETR6SigvYbXA7P1L/8wsaqU0ATFM7Bf0X4sCEuCOJS9gr5rOqSKZI7Z8SK69OdEV+kelsABRrBByFG8PMSxB3tsFqBqHqFMo0wtbDpgjGlR/2xGnpLb3yclQnVAzfoXVWV8Po3Hl+V8If8ABdD42nSMHe7dI0L51sqdOindFshsEVK+FNFrNL2ughDrdhaxxbVIlfc33lAnJKKLDvKXo1GtYTT5i9mj/vFzfLFDeYLjcgboxnzWL7Om1rgnBbYFMOODf76Rvu1i3oNokoWXtcyTIJHSKU31037qRPppj2HKxpVqrdXq0Gff0JQWNd5xEPQKYl+hefxybIF6d/71fXCUWzrITT7abdFrZWi4dE9PFjfCNtDKEpDuBHrDQSLD6PpkgqQPcJKQJY7a+aDn8EHItAEV5j9rL6CUscEt8+6UcMsT8CgLRD/ZPsJZkL0qEQzm7WE55Ua9EQ2iYtlTPAIi1A38EoB8B1O2vWiXpx9UTeucmyL7BziJ6nwFx7ducegkCXheOPXZvp6z3Cz2Ctn8Z1vKGexJ/Aem8WHH/fGZBB9cciaP4GsrUpX3vGG49OVa3gb0M9EwuQVPgSyHurGQgO0EK68/0R+7e/OvX6AEysVqj9XdQTVzSbvODiEzJxizFrwMp97/AgO5CH4eo32058KwsRoCE65JaSbbkBuUwYGEsJQiXUIdPT5kX3aHAv4IkF8xo1c2m4piYGA+nnrmXtG1OPLJxSBoYCgTncw8dX2tCX7U51FRj/6xQUSsctKjQy+L0Ya7bQxKoaJPU9XYFJdP84jRX+1LXMdaKK3IWY8An73L1XnzHL0BL4rtWDdMAoDW3h72VwvWtmRN3Gj3rsHc0O7/E4dWmplb5maBKAzckqtRYzmW/erkeEjOLGODtUp0flTkbee6Ozl51CFO3t5XGny3W84AU3+gwDSpleA+3Xiu7VimpXfupjIiglP9YICHftQBxDc60Md/D7YKRKVSIlkUrSfIj6Dg9REZEAqiySKwBzEsOKEz27M9A6ZOFpqG8Pj0KLiR4eaIsGKOREiPHsm0MFPSrFaacmUEYzU1v8MfmyUemyJMUKxNUCTijZDaYimgUjVODf8WxHxWx3tU/lkJCdZHcsj5G0dSydkmxX87ICipNDyzWdT1beZozbY1jzD7mytkO2C0TGdhQO8fU+Wf//A92eG2t4Mzngy6YSJER9E3AgbE4tNXkpVnS/AaARmNNLbo3qpOMzP8FqAq5sntulFA6+qTOhZdgRvGIh7O0WK532domIk8OhFYquyvNEoTu9m9v3d545esOO3Lty771c23hQ/sLTHBs43x0mdfvisHjFb+KzegEczxQikapmVZsrCKte78rbIHQ92KCkjy+0DGpv1Cub+GZQNydUkvMHtiG3/R0377x5p/+GnT23/4s9985//wALt3fddP/SRf9z1XYs2MPso2o8Wov2btZu/b/QPs1xEXdxzyUXagyxKECcVSQsrNHl5xg1F8GiQZyn6SbDjiMc8tH+w34ZIMRO5ojsxoUg1ti0+QuuwfLmyN3E/4q6nD8tklQEOeC814Cp4Px8Ls/K3KqYEzlEbz2zIWRDocukzNMcEtRTeDWieknUW1NGs4BtnxCghsO9Fv/aVX3jFF1mnlu+0/Y9Hcz3l794wfj0FPLi7n4K3sQsqL2IOQbchVZV8Ab4IVfazuOtF+mGQ/T3KNywDiqja9fF1tedYveQs9yYTfYR4oFVPLq/DhNkDKGzqHRi9abbZNZjP+F4w/Wa2yM2/OJXXjFB+NMLQRo6hjSYZWpcuqSAYj6QKANyws9k/lMwswJt9SV+VdvqOmcXuFbtDpvaOkY00Y1AysmB3VAwSIk4VUvAQfk7U+ycYWWx2H0SzKNDjEGTXQ1x/hJGtXkDv81CN3jf6STQcXVN88bKfEnST8dUdNB5WqyN5NPeX7jr5G2zByA02f5MbbP74DTbYtHlw9Abbz7+heoPNMNyxMtwRWO5p19j4xCXeL3LhWGgSzigr19jC411ji8k3V9V0qshttkQfoT6ASXe94XjX2N6lo/Fznh/aQzDFKcW0WE6v1OlEgAe3Q217RMpUq+Vk4RAa34MeAGbJpRpqUV03THJxPHuPznutAN/pWIfyijaz/AwQCEuRdCeVlyK0lrXt/fBLcPy1R4ebx+6hfzTHX5Fy4ljUpaFohXYgey9qF/oSOVRL95p9Mva92S+qGJNQVHkrVeCtnL0ld4JH0sIk/cDJ41q3lGT97Cd/5pO1KbiGPCqtcuj2M8jL+MOPMxy2vX8E29w+imLdXQnKdTdDuf4LXwT1jq8t4n3guIj3QaQ+/nIq9UwA0w/V/eTRE+wnf/+UJjjzlet8vjUUvGLmuuAV0XWlO/ZjzmmM9MY6dLn9F5wpqSk8fIT7NZKlRgg/9C4X/ryzFiWlKFeZx31FCSPvAuJ2ofkH4/IQV7M1xZexsxAo3FCTTyWaTOVhhFT12K7JZyhBjiY1iP94I9BCBnBurf2aOXOZZykBA96iFAmpylHn7G1v0THSuynSWLSgVXqRmAXSZPhp6tFrn18hN7IHeO0yLUVaG2mqCMGSe1HyuRH9tkX2D8vbHPcdPzVMhOzDukC6WOMApl/n5uoXohoFt9BybiPybFishuqSdEd9yzOIZqFPfKBoCoOywA2WC+2lt3JbGk6mm/JtWGTIqnWKi5T2AWynOJbHg8GGqiAixxbWOp6xp6MtbJxUJK7OPqt9QN+s3kVDJp/cMFkwPhgX5RAJ2LAkPmY8sZybYYygRY+rBnBjk1C2H3ErnKEH10zBXh0w+ZwwXtNxMoRZbjzRaMJ4qB9MA+iips3cqr70tqK1+TYH7e2lwc+MtlKqoMYH0HVXkobpaWxTM6ZmOEDiB7CYpdgAMHJkOF1rS54Zgh32nmqCL1NLsrUIHlLhCmc7pVahlTdxqyhZnRQl1MRPW8eSY2fMplYcmuckz1qeq8KmuJVwVn+di5qI8jHLqZhfkiciqiZhUKxVcOOMdAZFcwcYiGiVbnCdUpuYKd3mrnRk0GZgnFFDuls45O5N5Jx1lYX63FmdciiweO/D8+LgrKm9aPFwzwSqIyXkgfwDlK1hb6+gQfNgCHva4GuvCnr4Mx4Ru++hiJaM7dgiR2TOkdxbeCO38TsRv1MzL9jIUxB5imYW6PDYzOoAAfPgeo04nVM+q4mIyQllaQwBFhjwWfV0Lx461EKu5iy/JbKl2W/BVDI4ZsTOvcz9GPNcXcNKXKKuazVuGeKrZes7UEUPSkNOhSUxbw1gPQ3QldAuF3l6GXmGizyzjDxLhGX52dyac7i6J/CoPIHHbpcSd8N51zGlduORFE8U6xz5kpw0gCw9CYeSQgfzregTXC/CDnm+RBxD4vbryVJM01jrORvkfQtrDNEWiCjnpZtPymOd/HQaw2WXMescYyRmgOGCvABYuOZeVTjUEpwCJ14SZticR1U9WjnAREn9SyG8yFHzawht4w+ClyC0nUO+hJY55EkIt8G6YpO9S9sFM/O2vCzrSyYvc/rSkZdFfUlpK79s0xdfXhb0ZVXAo/TNR51A8aIl8zuiVe0qXohSvMwSXqnIqSVPwScg0ywRRRZlO4RCKKeIkas4RYwdUwEb4EST80fQtzgXP0+RrAOvOI/z2qJb9BSSb08hif6MVpKZSvTzneo1sDhFKtGKd0jcXVzsSGk7SDLtJETb0to6v3LphHUfWuRa2rmII4k7ylVVSqtxqmSKaKcrTdCKSUqoxJGwYlEXE6VrXNDqFdXY+lze4mzJAyufzJ4eZnyv5qeKmOezih+dD8Tcww9eJC/gYi9k/Nxu8PN0ruQMg5/bHyN+XqhYd2GJn3MctUfws8ehCyS0hUPnS2i+xNmkxNlGibNP5eZtE5zdRonFTLw0LGbi5an64uPFIvAqbeWXnr505WWLvsTyMq8vC3ixM2Cxgs3xBDYvVrG5ixe7ji3gpS0vOxXpM4Pnpxg83wEMOJeQhxhLZ+V5HiIvsqiQmRlQPI1RK0fg6XY++Iqqp9AOmQ9IR0Ay7XSzo0TciM6jp3Bgcq4IIuLn+DNl58hMSbX6c+mi6kyRjE+jp8vkmzZT8MWOyZnS0ZlyiumDmSk7dRKQNt/MFBqZKTpFKCc6wUzZhkmxzc6U7Zgp2+lCRDLSYaYEKSZGwA6y8YB3hXnMCtzq28KzYsHMijO5wLPMrFh45LMiq86KLUqpsTrorGB0ZIxWWr1F6bfQal9Cc5gBOmeMzH+JYovaGV4sanfkZZsj1LEl7r68LLvpEFt63q3geXcCz/0qnq9W8TwVPLekm2YNis9UUNwOFy7H5qSoNkbWFV/Pk2Tg6B+++7svrv5h2IEYO+lcQeCLq3/FRZwoaCjVKdY8hWzsFDMMZtpYrFH0P8Wi/44RhD1PSbvi7chCUSsnnaL/FIS961EjbCw6/hZhF4BFC7QFkerbuOUDYcF9bzc+8OlJIIsWubYxIoZ5Lk+QoEUgzir8yhsSzCs5YwVCcUla4QbWF8Ty7WrelpeuxbKt/BJbLMPLqsGyCvp0JtAnraJPJugzSQwnF323gloipqRDR28UshwdnRxk1d2ohew27AK3WX/72zXySXQ2PfnFBf/gVt6r1tQzwpPoyQDSihS1lNdoN3YXu+mJ+MgwmKmIyOjUNXqCLiy62rb5Su8Bhlhb9sPU5jRx+AReqWv0z9vT/Hio9HbJbKUyqHNPZioulhPKjFqos6gZQGM/XzTNPOWppkNAOe4/+pjBeGGsp5oOASEvWa5JJjhPyRl5Cpl/Gv9YLxs7lINhxod02iFN/U2TWap46lyEwHlIUj8aT6Gn6Q5trxahL8QvnFtfMi1BBhhjjXl6MYrJtZirNV0z7x7fR+umSXBAKLB7180SHKFG1c20cwfTNlyU+Ed2e9DAbsA51Kx4MK1c0lSPgsZ/aVf3NaHsa7rY12BuPIHOsXugcyQOEgTjCeNRWib7hTc8Qj8GuytHMe/Gx18D5wX9ipnARExKAbu5Oddi5z9qk498iF4qxgJ9CGlfaEvACQgeIlRGOESYt8ZWnFkqLpI5BwmRIuZDYa9aLW2h7ygFSSPC4PSbIZfO7LUM8ivOKLQmFCAhFW5a+3UBBRU97DD9g8hrO7Fo5XTKN9AXTOHx5jX4imuMnNTc+YAWYHlHGTexpIXZg6olq5e3unpRJNO3lr6FRmptBIS6BBj1WUom7hnlnj3ncjeO1Mi3aNBkYg9HNZqdvfmBCZ6zl2+dFT7Wmoa5+OPz3cG8CUdeIGcJdF9aVOerIIhoY6Pf91RjFXtnX3HYmb3i5kKc5un5rip8pBA7cix1+td9HyzewujxyN0tYH/IJBfioJeYhnioQT2U6BERBdk7XoMUEdchXp0LinofhHTYlaqahGfPaGtHbYCJKNcMgzT26rD1JNYwUgnBVWvjIgBMkOaLBDdDlZHcq0EjWzy+a6Ip4SscgrJuLT/R8g/6yIGjuyJD6RAbUYfbIUtEh3zhB1BsS6VGWrnPAf/SHvAVZrzyulHpRSqkxUZLCiBzN6vsRa1QLmppoo3sk1PNWeQfd1RTy/5YZvfWabH9PUoxhL5MsVOOQ1Gxmf0roDlVldtv39Qs6KqzCvplZxU0q9j8XKia/Kwa8mzVSJv0qAnrhyYIa7d6pN6dOFHfO83kY8GfXc3kdO1R233Uo6cqoUVLDKH96ZM/y/JHzk3DTc5NvfFzU5hmeGj03PTBG6onWXp+I6dX4b+T3c8v33C8c6u/QiprNgeP5CZSa8pFpNbIPSQIfV+qF4JaV/Pbie4gfYqPBb2pl5A+iRQK9dzQXUP61eo1pM3rPHlvTf2Xvghi+cffZ9NHp15xQl3ZR94wecPp1/Qg8XmTtoT9Psik8golowBNQx3p6lwHw5AH5gsKKoaGH910//WJ6d6qTHe8HIeP+o1Hz0cpXoxO75ad3s+vGvN4LCAqQgMk8UGQ+yWf1a8OwiPk1BTaP+X7wYgFzmDSEn+wiY5tkKkFHz/7XYWgZeXUhoa0BhL3T8g1IMyXUO9GOitXPr+t80qdqO0Csms2ebK0avlBdgzlkyZlv4cX1YdbGLMFXTM+lsw9zsqVoAK2cDul0Vy8FLEaMqzj4gmce3bFFAu3P7J+7naPLqbu2q9bTCdiAUaDNk+ZvpjKSirKVlgbPz6+om6u8fr5E2i8Yt10tX9beZ8lKayaz8a+H37mD92TX5+U5gju/RB5GASna4fhACTLmOwToMEMufQvT3Qv4Q++9vcSUMkjvJfwidF7CZ+cuJdwMMMOdOodhKO1R3kH4bPT7iCgKuw2v27uIvz+5ncR/v1Uuz71dara9YfH1bC5RxfGd6uNA29z9a4zgxOrdx3tlPpdNdG7V9MudcRZ/a4/efz0u3B9qX80w/Jzh9HxuvHLYzpenDii5MWh7E9PrOT16Ueh5PWoeIA/eiyylD/+hizl8ZKl/ITvV67t0DR7b1oSuIGJRaaL4RIz06qmCtHL0Q56AedNajvxbnnHJMn+EF/hNhL4lHs4vuJBlt2mHetUDJj3SeSMXqkCMjCMyJcvHlZsJkd6UyYPbCUU6bWaoaktkgSuDV0fULTuPh5cgGjPLaa5564jVnfnvjIUOskqDEU+LVZnptGtZvTOkKka93yZRmy3XN2nOVcUmID3KdC68vIZfSESg5dwUCU0Da8eXv/Kvh4M8Xq/eU1/0gvU4Y+Dp9/3nBkWtVIospwJoL5w77oF4F+/wQIw2JiWT0FfxMYJDavUQ+5SAWdorhL1PyyzBCMxcJ/fkT6B+1y2ScerEqH1V1id9GHPWKIP5EKJ2ThVOqkXYSzRkdpHes3pWE3RH406zJpFkbZyJC6ufuTkfJi63hRrrh+Ce8kjRWOQ/Y3ArEkhgfTbCFjlgtIhjC5QnX1tATZ1RjUnQ1JaZkVIsnVlUzfqZ0WBlx72Y12sNrlq15dpoFsBTDGl1/2oz+VlnxRJQnhBcHl5ixi68VMs51XN5dUr8WpFEYcrYlGMApXNM+aJeR5o+mHh1PtpcNRgAaX8q4YYULfCTD7VK9fMKK7cW4l1QYgH3FTAYdRbzeh9tjc/Oogk/aQKkYP+YwRJAJBEApL65iCpP3aQoK0ngslb/MjB5GQhkvazEYikjxIioYFICIjUAREVURuIwLChBUjYb24KkBgACUcBElbuZmEzyI0UiyngrgCY9ESA+co0qniU4VGSGGm+D1i7m5rgBo9knzPcW6ShwRRKh4UjkImKxiXGYNhGEQ7xnq0Xo763bBUN23G6HJVVPY6Brq5L1JEiGlY2fXdw/BBr8tAVMl5cjYtbH2BwlbCup5d7XrXr/t7K6kveQJu7XnCY6/Mm/NDomq99gVTDF/V0OD30TE99RxiH4g1eAIEQFxg6z85aoGlXJ63ApNpHfuNWfIf8++TF5IJXip94A9Xh4yBWucvzfUYLqsmdUR9PvkHqyyZJ7MTijxXKuQoYccVA+zALqXbcxTgZxqJqTDRGi1iRir/3L2ubow2vkg7lJndtT6z9eKYgRmfGfn6Xb0QbBcU8Ry/4UswL5ynKy8LWUoWV1bto5bYAA66QUfcydnJSmH3BWv31xYoanmAiARVlDIxfMU9SPE1xLskcfwx2/kQuyZQz/qzvea/SzSWd5xNCfFSc4fxZw2qtG2Gx9rJLQrD2slNDZ8HAjYR2w0qh0LBd+tipj7PwQJqnux/8GsvecAlz0M8D3Vjf5IOpPt8/yE98ccjXgg9zSw9rmPPAzZmEOR15tPTD8kSaPhF/un+zlD11D/R2rYyzaOW38xOfvMM/n/8kzHE2fhfnP4//NHwnh+/0Qaglr6/fa8Vv1yfSPXC4Gz7slKe3w0es28uGupeNMFaB2T3rjaVQWSUKZCxxK05MPEoyxQhFJIL/7B+rW9eg3LoGeNXNC7au/F916xoY26RTriYdnHVb17A/+PKYdT4dPLQCDc7+udy1hpvtWv/pEe5a/8889fbFyex0l1pow6jA8Gd/Bv/+xjoau/9iSGsuxUFrhqI3280Fld2cWHry1LznCn/+aXn9AzkB0j3coYz8qcLmBzuALXjFmgrNb4TNBn4+yJb9wEOPGGgG+XCrgE91t/wyuSsSs4JB1KkSJRjt1J5TotsEpIXVtHplda5XrMxQMLGvG0zb103EKtqaPdwTj3PyCvzN/nVcUPx2z/Omn70CNlW+RWMBqSmxn58ae28l9stl7DEXq9ZBJfajk3ldK7MauY4+6vPc175xXLizs3rAs3PigGf/CW9If9eL5LMge90bH+P96Kog6dAbH4Ug6af/PaSs62+clLLqZPh3Ogh++xuPJ179CbVC9oMXzcDZ2BzvRVpyfTB6RcrvHl8h9Mv9WhHlMQSWLXGMVNcy9BLhseNfIoSTrqPmEiHCd1XCAw3jXEJKSeFBg7XX6SV5wwWbLogMxxKoDoutrLzNT2PfFYDp5jN4kNrdOCvPkC1aQxacB+MttG9oQ4YVtZilzn5BAJo1FxTn9hfzNI+hlh1SvkCRvXO4SLPIEVGH+I/VW+aRYQn2P/dr5mWXuUuzuKA4T3NI2EIZmNd8xRrB7kv/2d8SzYvFNOBnF7iwjJ85jNrSWp9fzb3ERUQvlGlbkLaANC6qBQTWe4kbKNUWSXBhZDdwd/G2rMcFdVBGvT9osLozgMLPrRbIrPfJ7VuiGQrXiu24k0h9L8+h/4pOFLTCATa4smUt30GztLQfsTv5k1OCvdoxLYki7th0fAgzmiM8nWEY4UOtPou57H+qXOynU+UC32lQnxJeaIlONRckI3EXpbf2xKw8kWwn5mkJV/b4Ya/sdWkOyUvQwF2QPIu4tKNX9hYpp3nJNs9hmHFdlpmHn4y2H8AgYJt8imhAdmUeo7yEpCgIFcQY/QKUxFlQmOW75FnLT1dQiDmaOYw4RcxDo8a5tYebYi/59Ie/6D38gGeAka0B8SRPQruqSWqUZg584lyfAC36/7N3HeFtI9E5dkyJ8nIpiygEKZY3oCh2Uu5FXlv09k095n6UneYvl3Sl5+hjjrql997rLT3ZW3rvvffM/+YNMDAhiZa3W1uEeUNgQMz8/5T343EC5AUUMRMi8oFhn6pvulGbvTRyL9SPWoc2MsQ40MlG7g1foq6J3BNQKp+G/+OrEZpUnqKiceDpp2AUU42fQI1hfu0la07IBzTjfd5lgLqP42C+AudCXEVMzogqeLi4Tw0qmM0p2B7o58TTwsOKs1okH0ypaZOz//kHOWfP0JoClAuYmVJpkgc36uvr9J9/O0dFmiI91Wl9P22iSJqZjwZID/gj/BcX09o3/QYAbRuwSOP0Y9QtcMRPvrVPVZw3oinNkqfaI+T0cRPJgZChCuTpjpPB4xFClwO0a3deelt/1EVAbpcKyFJwQyoK0aihDc68gL5lhzadSdSQa0YAZ742N9mqBlwcYOwepj8KFMwvwfas7cHn41EBB0CNADXzI0FAwCrHDHYNGJCMJQn4bdGqujw/h4BAdVXf8KoBU9908aoAlPz2urpmYkj5d4Ou6yN+N+gGL2PUTY1K5Pz1urqFdxy4F1O3dZkViRi9rW7q827TdYyAd7ikikQVXkOfTIgqLKM7CvRh7YuUottUJno0P9CvHKqm/mo9XUiLbqptuqUaSX8VkwZTg4AkgJibvIs80E1yhJ2F+Y7d/Mm8XVqilqpywOO2qukSv0JpCqoKhcqjGko321dxd9CnSpLGYF1BKh6Qx8cp0AICGF0QwLUZFGjySC4gHM9466xfK8YjjSYaLOKeUR+P8Wdizl2NdwWyhmQT4mtnxNn/INnunbiIPl/9+8V4xncytx+ZzNV4kilyRHxSnyZHFTllZvHVf1+M+6bIMTIHJnM1nmaKHBBOwpVOkRWgr0IeDh7aBXj14YLx5/C1IGQW0cxVCvkYUo2PNftSe1miHChAlEMThyZtk9rXwGjMdzAq9nBmjygbL3gnjRdkyG0gXpCxdpextvEo1vTR4wHB1FCMfZ23z0gsGBgi/Hxdw7CjYVjXMOxlYdg7HQy3iVSNlIZjWzWoo5pUVy3AEQ+vKlRSHjVUoIEaUQt3y0AxciAaJOmBA90pFcyYFs8EtiO02liwO6GAj7vIfCUL5D4VkXuPpjRA4n4Ka38/rtpzgKsiTWgXCUDfArcI4AKoI0a+YHAR8owi/JlawI8cKFVpykgX3FsoVdPvcI/u61y5+veFWmN6hYmUB/gqjQ2HpjTJL1I4lAX8jEeBfMBXlwF8gENAEQ6RhX8I+IcC/xTuOJaowccGNfnYpBYfW7QNkG9bOhD5AK7CQVEbhzZ1cOhQne7ua7j2QI4ereO6ddqwIYLXECK4h8Pb6IIBdKXopk4VMUCrNtJgA6Gs20S0p5lQByk4ta4RPNec2NCcuHt6TtDTnNhQoeZDTXOhRB3VoHXVpLvCiyqFqpDDDR+D9RHc8Bxu+FQw3TZ5wovI4YVtUF9wMCADack3LEvwDXAzpr/t0z/nz7/kh/7qvj2i10V3W8Tcxs7W7FETjSESF7log8Qx2dxpzqgwYEASSk1oNrB04Vz7/WiXBoYuMxeI8jgjgbVhCp84zYwXWVhXMPVZhLVA9zh0S4hfFeiuCrqlUz8lyjeI8LMUbVLAZR1WnTqwOrQOa53uwrqrwU4A+xyXz2nPhhdew0qhoyHG8FbKwXaTsd15ZNZQbY3obY3onplsCDCpoWFbVAMc0bHyHGIb4dWqquEXUs/MI/DwquDMJQLMJdz5g9tpCxhnAsaRizPpgt0WHCTdqTSd9L+ZNpuSjPnFZdsMrRRJK/lc+/6SQ/E2EQbfJiluOVgt6sHqUQOlN6iNC9rUMRfcomt05/Ni/ccGI2JxdovuUPmRKvP096Yq0HUEI16nG7jIzkHZ711U5sfjME0+YpX6PVB7kTi0iSc2cbDC47/qYRZHV2nn8SMNAdPsDZ4pXIPgTMZL3XzD9Ee6AW/SNp8Ymi9jhHp0lzUqAE1lYh9CSZZckb4M7R6atU5F93K29ams14rS/AWq6bmPNvbUQBslzRU2pvBXIQVg8HFkRrOqjNo+H3nIxTiHh9asBjjQM8zskI2r8Pj4DGMahnMM1UhMzGcH+GxMZuzXw5otBdavwdIXGOtnYNmR8cjRnKfDMU5CAyQ3hvX7/EvpK3oM4Ie+oHtjbu/IeFXMWgUfevgwFkcDlimMV87sc+bUWRxOmQJURBrLQP2fGhiSpashiY30aYDrbScVaMirgj6cBwt4wYZZ5TbcBsY1UE3a85wKjYdkVRPHOA14iR2xg8DjoQ2hUJaqqgJgJKObviWKIQ99kydrfomx3KKq8VCgWNxixSz+osT/4OlaoYIUL48mPoUTi099O6vGtyNADAipS/zyekBFdBLm3vknfbactEeBkVM8U0lZTxCFWBdrD4GqsjPqJRWZepW+3BLrYdzgzgZB+7hcb/H7ErOskc+yUoZlNbDLtswyLCu5LKu9cCyzSPpIsawhLCOMF42H1GR7ToYHoTSvRrKqZYhXFeL5SxJPdo4WZlSBw2pCvJCJ56NYh3j+8sTLL/70xPOSk7wF4tkCIqeASArw7GfOdZFcF6WEjSvcIlRZZG7NMjfkHwlZg/OcKYpHaghvmayfkbgmC+azHgIDPHi1tktnPH6heMzUBTaEvWfD5gnDZmWZYfOiijLk6/FJFWYY17ZqvkRNI36eAwv1RqwN9KrJZLap78hzGTO/LonMUSIfvUCBJ/JUeIgZN7dQWbrCgGoUaqc1Xj+FXYUfl2riwba5kdROADHgMTjr7VOkDfbrmwo/v2ckrwBtXCXPZOMx8KzaZy3Obo+fX9pUtJAGDPOAzXmRjcvzSIND7lsRauCG8y/4QhYt8M0eJ1AigyTUkBRwxVRxUV3VhVyhl9VlU8UXjOMZKqRWznQVW9Ft52cO1YP0RYqhcc3z/Vnoivga1AddwF+5NwRNaFk4bLGciT9k3iKiBzQ8TIP+PA76o4LZpVBtmteSKACvadPZ1GDoagUWwoKdFXm94K93l9eDDy4u6sFf+/0n6sH/7GjAf+yk3031YJTCusMBxAajB0vyYppMTvjESMLvvi+S8F8vKwn/ftFIwuh1m6ic90wSPjiThK0kfPBxk4TfzZOED15wSfhMEj5IJWHphGOT1OQ9RhJ+97SS8F9/XCRhceUeKQlXcjWFIkYMkYQrp5SEnzyDJPzkuSThwzxJ+PC5JOHvyZOEv+eDlIRFCxZl+KMpCZ9Jwk9OKQk/eS5J+DBPEj58Lkn4e/Ik4e95wSXhM0n4yUdDEn5yWkn4ME8SPnzBJOEzSfhMEl55jyVhLLmCdHOCD0gShns638kNZ3W+k9u6rlMn9/ekpaDaMk7ug2d3cv9+emM0R44kfPCV1reIRcvXnts3KxaYHgAn7m51jiPAK8gibX6KmF/LDvAncl7fOU9/0JfzlvKJw53h+sGx6AI1jB8cDFFRRjVecVTjg9T9DesY97f88KD1WQLlmpninr6Ae4Caed7v80t4v6V063RA6ZUTS0/cu7bmk22+AnOrNItSPZgf3wzg6NA+WD04sjSzFFteRzqj2MeEYg2hWCoZwwZ8rWR8kErGsBYl42VY54MXPniRqxifz1eMl2Vdbun5rIsrObwDjIV5EaUnROTmW0a6gq9LzfdL8D0j6hlRU01Y6PkCD4qVZQbF06u9K4tq7/mn1N6Vo9Te81m1F3aO2nt+Ue09n6i951E21+Wi2svZZ2rv+6b2/qeJ/i3q/1/SP9dV0iqv/pnFL13XxxX9f1btXVtUe3/kZLX3W74/VXi/yUl/I9JG7UUpVlIQtdcmL6ZJOeHZ1N6cL7WBjhy/XITE79vEr9nEz9jE99jEoU08sYmDC4lWXEm04opoxVr29ckXrXgFOEnk35AqWa0YzIK4SP5Dc3KUnlwz5PXJwwd10Yo3E62YKxDyoJ9sa1oDeVgw9iA9VaEHR6IVh0ys5LM6PgsWteJDlGqLnH8HW9BgWYFNtzVlNVg1jJismrr85CTzSyYNUKRuCtD340HbbNmiqsyG0Cq2JeWzsCr9SOkROgYWb6tP73JqS8N+P3zthTgiiL7mnj7VKXiEHlfn8i6nPt/Ks7ucYgRQBatr+filIR+zEumq3GdIdjmlpvDoQP/MV8vRyvW405Z3kshAE7xT+jnRAcb6zlU0XIc2+RWjuA5RrELVh8jt6lO2oT+5GrkMyQyxS4TjSYp43yjifVbEB2ltDxNxvEp9Vxz3XHG8IbucQiSGPq4Poo+jgrkF0DsHfE6I1jH6eEgx+Xyar9O+1scjGlLZ7nLa2aceSoYLA6K4hz9BsstpKG+113iX0xEfIRujAoxQ6TnKeEie2eYUCis2rEmVcdBMxNdR5iPiRsZ47Ml4HOrTU1eT3dkoyijjg1QZr2L/SCjjTWiQWxllHMNoz4iZQkF4irHN6QRfXR7Dl/kJk1aTjQszyrhYUwqksjyje8c1mpgHikfUtiL32NmFFCeoRP0mssmddF9SAPICisR7DdTjcbaQvkMw1d8zVxMf6SL0n79iERzpGe+OChOl0475aIz0ONk4NS7aes/XxFEt6RmoWMCHn7u7Tz5AEhfgUaYdZ8NU5IxonN0w1bPzHXQjJbvK2LYDdA/uNJMXQxqPZU2UkcYvU8sZE5tcV4I4kcZ9EBF9SwhpvMlzvB+HFg4EIcO3GbICS7sUAtpScXyFB6or6Zh1Nc29luZeT3NvpLk3JQm0btOq1r/Pmb0o9de7Y4V0Bp8qmHFI7Voh/RfW47s46h9kf8UI6UqE9F9bV/cgpB/yhX1Uqv6/q8vsK6XP69Nd9B33uSRPhPRdDFibENI39fjGwswW3VMlmW1fUR5d5WrzqYTGD5PN/tBizt5/di6Mg29fz7Q7YnZxqy3qYpe/LcYs0qSz1veRGmDa9hipBmaMnBpirsapWH+Vjv4Kijrp6h7G0BgRG7ExqmyQMerU18bAGGU22sbooXqkay7bWWrsc19VNAJUyMaI6sTkhUnxmHw+zuwubDUaUdEYkPNQCI2piL28dqzQMtFAp9EiMZmK8R7+zM25K/EDZ4c3n+bE1+7QA2eHt0juYi6fWQFmh+9ibj0xmSvxPFPchPikGc2d4gJDanxpUN7KlGNT3B4yRyZzJZ45xRXAYm2jS3GKA7KUZo8QDwMwdUDWDnUNWUuYt5doC5lbtJlV3O+nijtj81Uo7q8Cm6/pgx7zX9fFvqEh2hCIXlMeXReINp4Tom8Y4L2RQDTWWa8xRLd06nVOberUq5xaT2BbSWD7ZgLbt/TXGzBsB1Sx4ITxpgUnjLcsOGHEAk7IZ7RljA4bm8YosbFujDYMSwJyAF1aADS5gO7AsMNyG0bAxszgPhKo7wjUJ0DAHgVszKnGxwfIfNtCIRISxO/QjMZIfJqlRNmAdYcmTAl8jgSfNHMJYqFbpAc0P3LX1hH+HE+WWYYsdXP/PXo7QxY+8x36NCZgPln2aLJIlqohy448hSXLzPBgZB5AyDJyySIswSsEJ5BlAF4MLFkaIEuD3kCmxp1V4HehwK/jAAV+HcTASnhTE6MtxLihC7wpxGg/OzEuucTYNP01xghDDI1IDWrTY29KLz4E7DgVgwSGNpA7mQQli+4IhkV3lY1B2l2XqCGMgGHR3WODhBEO1DsLUC+7UO+5UGcoBLYDp5qgPHRQbpsrwGSIDNiynbuF7AN8nrtxK9od0JjRXs7GrW/rDxmJ5n4MmznZ3OIi6oU6AhthwI5lwCQD2QfcvwtyM8NFISGeMCAHsoenhqxouwLZNnDUtptyr1sdfRcrioZ5VYPoHvpGC68B79w65iP6IQJ0ekQa1gZuHSJqMKBKSf/aNosgUlS2o3rARsfirK+NksUZjJ7gzAFQdQFAdRdAEQNosUdcHPzTcdR2ZNx7SPNla1ZnF5erWVm8SM0OsLIdECGTqGEy79Eu3f+8WP9xd269R/dRSV0uSqkC3cWC6S69govspDKrjHvWM1KQxGGBx2BFWGTTHbosqjdqvsej9S5U776RAUpG9ZaZmjQBbiSefmwHi9qG44DYG1KGCCPtIK5CrPulHQpUt40y0kbVNAqpsfH/B2zM4OXPNo7p0nlIi+cU8vEBMjECwDkEUR+tAh7Z8WpiPvs1fAZS8Fg2Jx7m5uazn8Fne4RBD5WUlmJfFNAXGOsAlqWWzNMWiW26gJEp/PfTG/MLCOIv8PZZsTosIBkH7PAfS42F7E0Qtyfw64R4sd+fO3TOHHHmLF0GAoBIF5HGgk//h4rNxBsFNMZ1RgPyBJc1451tU8nyLBS9ButifSr8P+ZLsQAWyGhUMxIY4UnEsy4BVRm/fU0bqiZDkSzkxRG8TRGQnQYEFsyCrmb4wqV7C3578ROcVLqtU1udqd8+NLdKs4hC47f3zeM/5bevWr99xHrGS3CTOHNgS5aHcY/F7B6VqJ+K2Yp6+cwpZ5hTxfcFe5ZhTtllTvXDZ84Zc3rCHG0Q9R5SSUQwA+6qkEnjU9UzZIqETMFyZAoA98DCPQIAI0smEcEClOqQKViaTPml55Mp9hbpJAiVcTQ9oUZOfkq02ANzQ/IWGVd3lbI6rUngqbzSLXyj/qJG3SOCRu3DeUSlM/69IPwD5Vzp+QUewrxlhrCLqpYhFPFJHrPGSM8lWQKk0nMH/ZydLGIFCJvIzE17IhH0KBDpuU49Kz2j7svSO4VUp6ojPUfsKa6L89fm1lJYifTs71NtQXpmcQzQo4h8Kz3bSXfRnXTbF3lER+g4W+aLcnwLq3K7hPAE57ihSM/ZPfMtSlzt+bZ1bd/RpdzW2vMtR3sOj9CeW6n23MTXXV579vO15xY1He3Zz2rPU9GeQ1CYpo723Mz42aG3xd7T2vO3775sI41f/soLWnf+VK07n2PdeYk4478+WXn+bUdt/iUn/ROp8sylpGHEJ8UZP/5A44xXToozXknjjJHOjzNeyYszRhVInDG01fcozvhdlMpFHhtnLNIx65hNo2O2IGA6vUNbvjEZyUwpCU6OJTi5kwYnb0EREh0jxNNuS0Ayuo0eByQjt2/ksoscqqFsUnTS5w9TblLLrG5rEpLcolp+SDKrrqeLSu4eE5XcSKKSy0tHJY8kKnl8clTy+Oio5NHzRCXXYNWonROVPIFs1ctqrxM4PET/YgxrPvRZaKZt+HAmOkJ5iqeQJ4LAFbATp4Lo4/JjRCN8IVcvaDelLapAfa3IZII6JMmxCcy1r8VtUcG+EkeECz0RYWN7wQ7qIL3gQnoB0x+jylPRycM8lGVCkEdIj5Lo5DHMsfloB+mdpaOTB4vRyTWSOhgh4PLYh53hdvlPZ9TZCgVWnQ1oDUMZ+6ZM3HIZM5KyyepCnO3mxS1fzsQtT06MW55k4pZhP1vc8pW017+a5l5Lc6+nuTfS3JtOjHP9KGn2J5aVZttPSbPcg6qGxDgjPqSh2vq8hivNVlxpdgPSLIYPRRxHek91Emm2Qle50jyj6ASJPx/Nlbr3F8JnM7rXNm61TttQuNZ5xoR0i0OjkOqyxoVUnzUupJroxjmFmVzMk7uY+mZR67PRNEYVRrrchdEyRo0a2ugaowzDSgJrqJ4FadaTtdVaqleNqGb0qkCkWS8rzUaud1bWHFlpthhPj5VmB/gztC7/PceF69GQpkaa3XtaHvKekmaLGWl2ah3ww0xxUyvNDp3i/Dxptmil2YEjza4uI81W3OWQvGYZg6oxbRuqdjCv7aTxnsdKs3NIs3NgUyt2UKBe1cW+piHaT6TZCl0XiPafE6KvGeC9lkC0p7MeMETXdepVTm3o1JxTlMBWJbB9PYHtG/zzJYBtl5QFJ4zXLThhvGHBCaMn4KSGNkSAjdnYsDotDDLGFgxLgpYD6M4CoFsuoGMGtOhVW5SoEjOD+6pAfUegPgUCBuI+GFLER1bs37RQqFpp9i3rMHg7I816tEPTfGlWCOJKs3s0PE6aPYksM5cshr0eBPEMWfjMt4xeO8gny4Cmi2QJ86TZYp40u7qEzpVLli540bVk6YMsfXoNmRp3GWmWrDRLIIbSRWxoYmxZaRbRikKMrWcnxiWXGBumv8YYYYihEUmKSdDXKeJUE7DjVA8kMLQRsaZNHYvuKgyL7pCNbtpdd6hvGQGjaRkBoyWMcKAeL0C97EJ9zYU6Q8G3HThFgvLAQXmqcibS7DDbuVvI7i0hzQ5ypNk3XWl2YGAzpDePlWanR0mzCIh2IbvH/TuQ6w4XedJsHmQPTw1ZkR0EslvA0RZtIHODKCPN9o0026J76BstvLoizXZFmm0BOmvUYmkW6Vhn9RlQnaR/3RJptk1lO6r7bMQWZ41Upw3ZWBOcOQAKFwBUcwFUZQDl9IiLg79/lDQ7zZVml6tZkWalZruYjXaphUxdISdIs6ikbS6qvYQ0u2zQMou1LYQoO2It2mItFWslZqtjlrMyd5NGecrlHUo8VirWRlnRvOK6vGu2mUbaCNFMjljrL7i8pblMJ8+DXDwU1/ceMjEm2JAstJPr8sZVaUjWyIxuQ9pDAuOThGRhZBGXd1qKDcnSFxjrYPXZXd7JjdOQrCICNNipe+hGZ4nLW4KznLfAU5e3RGR5z+fy9sXlHQGpFUFqRBUT8dSh+IONPK5/LCOPS/CrOLNiS5aH8RqLtWvUoUYq1rZpLZ855QxzQhGLomWYU3aZE374zDljzpowRxstWntInQ88oLj+yQ0ovmhf9V/DV1oTvlFjUaxdo1YSUNwqnfHvBeEfKOeKtS/wEFZZ/sczUkK10jjhlhFrO7IoSOWYGP2cnSxiTQibWma2uiaawpoTJ7z20Y0TjmHIqseKtdk4YeD8aLFWUHKSWLtEoPA7qVg7eU8Chd+hyWkChScZv3t+oLBCnf8/e28CJ0d1nY/2raquru6epQbNSIMG7FMVhYxYRmMBWjBopsUAWliFZbCzYYMTfiM5P/CWhZFG2CSWQU5kZ8NYz7RaifGGt0de5AUkHC/yruSB9+TJO37ecFaZIPt/vnPu7aqeaa3Iewum761z93PPPfe7596qa2r7vvqDZaxk49txVzUH49povTe9eoUxelu7J7e1JwE3Bfd/B/Gr5D5ov7ZgMuFHdnDHOnKXGCa+U8INAowGVKsXuLvf9cZmZImbq3EhPufp1X5rMvVsQo+MpNF756PqX5vCYe75j/Qq/3ipF+NydDgGDsfHNf2kT4MaS+lgWmRvqJbrmLvUR4gu8QaRwtNsPGQTqdOlDmnYYPW3Dnu5+CDuj+fYQf6+8C4mRnqx9I47LbF5Kfhdd7VeCu7YpZdk48fTm7K9eBuiaoCGCkez27OrtRynA+E01vac+dQk4utF9/Hr0eFV8vDKbMZwVCmo/q9nvFzTSrZpUj4EANdUx9tz93h3W0+QRsg9crmbcwrFhOuGnfkiR4mw0YH6xO/Gl6tbwyUU1TiBgrBF1juZS/QaK4KwnlEhfq0+Ymc6oqKuhLkaFEEYQ4w6/hneQIVJjAvUVCOHKqfciaOrUR6iBaBFYGUAJ0hD9HaoF3gbpItr09zZMYw28XdQQQqTiAGMRE8idqkoDIeYcsurVMp6/i5jfMd8ysuVNNuHyOhN7CAt8QZVjvrZ8UTGYqm/T9ifZsc4wVeB9mG0MKgLhC3+C+ELBkJiXPdzCLnKvPNnce/6X7a7dz1ceeTr14MNabgh8blqoQg4cZfkrl8PjnT9ekievWJd7rCHACGeOIE4CIv/6ojXr/+1Xr9+j8HwQxeIAJVUBiM3CktcMpQ71xDZBPAV4Qv5J74beYhgS2p2SvHrdLzb7ER54bEkj6hf6ZJun0oggP9M6a3KA5cd2WEN3rHnWtZYtQMF1e9pqfb+H/IV+8iuhAiBSOHhK/d6VETu+5diC3q1/zjnSTh8A8V/j/ScIcnUKSBEFhmVVmhSiI9UNqq+QDJoq94LykcZrQFkVucMLuhvpCCMOBADMphS0XV48PCQGs68WWB1VEqRGsV/m1MoqRG9Cn9XpkM5QW+hdvB2Zk/849ulX1OkMCrb+QkTJStDWxRvdLyKV2a6P0EHsTyicmC+eb6OokhmUdBi8i2NKFitvgUJj1iZz4u1hGl4wEzMJl7eImDX/4M0ZMBD3JFM2DCUcrfqpxC4Ny9NQkYF1Ztd5X2Z7RV/BvAHukQrNgcIsxsEpsPvq+LzZJxB8WGoK9uNjKrW7q5ehjbGyjLgBkQMEN+VhAzgs9qOK6WcA8lKeJWC6lf7SnP4pJnHf/50dFtk1VQaJiVu5pZATphFzanLX+7Hls3sGMFeGJnlJlaKH8GclPhUAEKbrE3dCs1OmnaQmerlOez56FnlsAcOB+CwR4Fy2LMc1iIXcFlsMQ/J24ivX3xOCqow8bxJ6cqYRY0pHJsxviUdejlIaD4eRSnwShcH1dgt6HkFAPJe/ovtjIo4yzg9xfFOO1qrGL8xgLjqyb4lHmL9pz+J2ejC9BScYQltaXOs+uQsGesA8UGNxg3Jy9fvjHiT4Ae7mEk8bpNo/UDlOKo9xhn30SkbbSP7mfQlJp1SK7p2DzBpP0j2eS4/fzD3PA+jHovBDE3LhNXHNcUqcXdyai4EB8D5bwi7B6jeENqD71upiOKdxVoAuB2lp6HaTIJl3rwoPV1hOBqGHS0MuEb8WanCaTTPNZX8Ogee2tiV+np7TV/zIoD5aD/KkY8tBXS6oH0P+7s2a8ub3btQ8umyJVHjQYgpZfXQhqTomNhHln+Gi0sMzadBHEax79OdgjAyttH1CxsyV0vN0VGQB2/SdlYvVzq3JCG/IY1GMQF5yM9rbiaegpbIvSVPk/bCgANnSDgpx3jny2n3+cpTru/TiZ3Ta5uT0JVKQzoU2FhSQUlyPOl0+HG6iIgOdb1i30dfOPq7XxtzLgc4db/sYufiyFPSJP+Tc0EmkMd5DfTDPc7Vw08kITfMf94D+x90bhby4lv8kTtP3fU+52pImlIqNXNlHdjjXK2X1QbOlcyIOIzsP+T9yLKtD33riTc96FxJ+sF3PfDgG76XrHAuJxX6/et2bLlq82sfcq6jbx/4+Kl188QK5zr6H17z8NyNDz97j3Md/fL1+Pf3Y84FXdvExn5KZ1Vy6tFPP/eCz3/9IudKJt/ecdad3/j6cx9yrst804/edd1XT//ICuc6+qPPe5grd+Ye5zr6Gw/GfX19t48519FXS+U+tMe5SlfGc/8aO3Cdmy44dGUbCxYd+oxJf/3QuvSMNoG/QWfgrFxCCw59ikv0LN3LZUnI4NA6exEHxuSkFdCU7RzImM8oUarZtIlfizEsAzgBhfjocVjrkQ2BIVG8QzQfY2m+js2qVQs6mIapIjpXpma9R5athvIRHx1fZ9XU1naOP467EWpljjFCZ9I5cs5zUc1g6MF2qZoep4w9PpvrRixuGeGDqDwEedtckjgFyBqD7yIQ0tM0rVhBcXDck0/BeXpIliyhyIQ0sGOWMD3J16ZzBw/BiNRztoPTYRRhpsjkcDp1JwwHQA+FJ2GLvqrSCA2i8anXnLCAx8mTrwz22EcYaenpyBd5snpBfmdzPmw0PAeGtXOob7Vl8bzmOjjCpLrPJ48zjuuY4RE+tzX8kZnhA63hB2aG97eGf6clnGlzlnjaJW5Z3yX9DH6TgULGg8Hf2iFYhhpWD/ePN2Su3V1XwvgLxuuilnshX70Ug20iLqSYobngrg7wTwbTC/EXpC5Pa0cFsAd6Faw7e81GBgtkpkzG9+piOFtyThqvvSUDbXVWi8yUwailabj4IYi62BkWhKug72zyM9bl7RocIVfTd/i+mQ6nzLSskhKfzFky+gz+LBOTYGLHSwtbL/za0s1JceKe1+Hfm8eAkf1xjR/Gf64LmkYaTXzyE/gXjd+IY5Rh/FaEJGXyKdK5PX79q0GJsGKqN7EfhffE9yJg58TLX7b65g/8+oUXNXZpVAqozP23s07hLrd2vXGIRT+0lfnBWCMNbU4Hx260qK/4pM8IEhLsgTkL0gp5VOFT/p6g5d05E110jA1spKXW5kUUNihwrWyQT6V8I3e69l08zpWnsH5c9c8OaXNLzKQuozZ4wNtksPGClaD8/UHKkDctbHCU1ak3tNuaLU9l2Te7dyWBgDqPfB7qsqiId6KKuqzjJZk+sJeCeziSt3roxBaGbzzeheEzpRRdshm7Zt1Q+6NbN3Csn8Aa8YJZxjksQ45mBhWr3LaTaRhCoew38VuaFqDaaN4y9NajWIb+x+PaSH4oVPnEjPNeura74MhBWiTYZZh6hVD5UVeXIQ4T+TxnCGg17nN+AXZPAlUGhnwskX2ZYLgOmSm6aLGuaf0KYD61tTurJMMkkkseqFF+Vqmay6zkAZKzJ37Amg186WDlYtb4DbB+vZQb7BP/WeMWrONPqnErbrzK2m2DJGhWpn3z29Yg/tQrRZpeaTxzm9lMnrzp4ZO30I+RqN1AyVvAg6V+zI4PgDPD5O3D5K2+4aXesIYuwLI1Z/H2B9UZVuKC6qeNiY7RNjj6Qmcb/MxbHj0TQ+Ntai2zJkJdB7FGzmyFSONDSiKYUcVc+CinZe6/5dG3DIixsBTf32IpVFkG+1mUraEvfrvKMYrB4ztyNjyvxYY3azifmAJ65ywFNLoxU0B4mKGANvA4kuGoY8gNZzLsQCVsqF39Qknmx+9C3m6QF2DajWC2Y4La5XxpkNowjZo6xAnUabWCvftYrGB2lwi91qrQRo++S6S9gb5I+JGdGbtE/zfCkdVx7BJdDfWIhLN3iVbaimCu1c0S0IdbMR6CB3PBp+WDq89AFnmO2E4yLg5TdEPIWlSPqs7b11fU+ZLDFZbt57QrsabJdJYx6JTdbiipFJn4vSCo3dUKuZQOMwjnNEvM9wZV1uSbzbThP7g+/xU3u1c2a9sNG+7tZOMjv65aUHMaH2+qecg5LS70C2lI7ERp6ZqhJKIAJmp5Lt8H201l5a1U2pRU2Qk3JV3CM4huNyFt0gMnTnrhDCYxDlALF8Ol/lbDbnWpvwVu11L/j9gpLfVvUedmJd6gca7XJFfr0yoNG9eYyzRsVInDGoWUOKhReJZcCamN2Yylr3ctBFKfSk/ZlM7hEP5bz69qUg8xoX9lTPx37VDa/5zugqTbX5gkTRNPpQOb0rlMnYs0VCZ5jPmRU3B86qYBpvKu9tTmKXBo0s5MFfZwQWYK3wK+FkJjz++qQV9NrmigLxP7s0RiYA+ax5Q3o6Mw7/tSG0z8UJpKjTJqQAAK87SpPvYqHxQ5Ra/xD1KxD11b2/IAXgO13RU/ZMf1dmMVZx73mFY1ETjcc0Yhy6WAzG1uyF+2NT961zFF+5hE++vPmb6n82XGlWkPBuDbiiK9AV9qXL4t5Gdvk7e5ON3yyvHeRbNfOd72wB3ulWMZXlvwrO8Ra5CMva3wVnWoLtNPBW85czKJ2N3LbhnPC7M3jI14dUsv6coCu7PAHg3szQLjLLBPA0/JAudkgf0aOJAFzs0C52ngYBZ4ahY4XwOHssDTssDTNfBpaNJZalp+OvznqJ/gX6j+xMaBcSG1ceD/NQYk/QkjBnw499d5iZecIf2PF8b09SC8DgcOM0vvgKOzjfTyb0zCPTtdSMNsVeS57kzWGsQ/wpfyZLxHJ6tmFulZ8Eo26dnQupAX6SAyG0VYhvGbnOPyT0bsK01nyl4GNNOi2ksme3zPFEwV1MFkIZyz5TD2IiznKRmlIobVMxCwxUsWw73DS85tezb7PBzeWkglgqfuPNudZ8tCKjiFKCouPX/l9J9OpUvwUMBPnC4VyjJaQsuuHeKQ82kp/th/PvHTtUPJcjoXNqYLaIQTreydSp5Ji91a8rS9de6CC2k0OzLyjF27mHQRLcrWYyCscBZiNkBhkb2zJYexlQJwk2UrC8kSt7Ng2XcWqnn+fek4BsL5KwFye1+RLAW98J50dGLx95983R+//AtjDc6nBmqUnE+j/LCSRmkU1IvtRzJLdDG3beH9U+851D+Tm2J2Tc+j85qmqC3l7JXuspxKG6ER7pt7YUfJvySj4kkLobtHmEpjdBFeqOAcNLN0os09e5dwwGybdHop4l+mL0LLzAbO4N/X3j89tdSPlFpopRZ0VNDIJE3QZbNN2ukqFPYDrghNwDfL5Jyudua386jGEWklM6LLcda5ljVd9Q98+0drVz2w3Lkg/gfXmi7jGAk3dv97H+7/4dteP+bc5LxaZL8asB82JLEJ0gSYjWol5zl+3q1Wv6eT8PFCWkGXaaQulaXPjzlXjbzaZ2AlCeMmpA3tWdSenQSmncd1sSyCCCC7JkMWwhS7kMbFFLvE9vU4pk5eK3IxOk7WDyUcttDfexY/LyP+45GzTEZ3ukbePD4XDwtkjimka4V0OQvYFU0Bu0LueF1su/IKSNOVajydoLXJiJXhy1XOFonZlPm6pQjGWl7SCBUlgCsvTN2ipyN69SYKWsRNlUaNQPeOcFY9eLkaTcTnkSUS0nAtiFzhKJjWJCO4gPknXPgVgBxX0LgdVajJGi7+Ki5D+X6V4iNAuBGWEvUVwdmtHmciuhLnaJsfzViIN8/FIk5F/CZrLbevEm5fyblf7o+jH3TCcZZvWis3Tl8p/QBGbEGbEIUra6+kLgpHLqDLuR4bYUVX0kKrKg4VZDgtslyZ+fEDdzSVMyvqJSHo4sVUTrjOaP+50v5zLVNqPYjMFbocFdLyc/VZxAUvpqJWFn3jdFdrZVA3eI9YmUWuMouyylyur+Ffjs7i9maHS9dwjrTAloOsrQ6lEczROYIOWBQ542zpGvZwP9NVaOdVtvOfScuv62ZDAt6gV4mUXhpRLAGOYTTofI6JQPQ+nT9FI/FeTNxcdxYt1tYpX7cCZ5SeQaM3DRGfkh5yChzSB4fbiLJH3I0tUqHFdD7gMM+F6/SdyyMPftUr+DedLEP113ebKoaO1h8dpHWXITSZLgZrEhYPrsQ4oAJhfuNIPHIQhOuO2Ks7Kly/aa6fwPLFdhQtwihaxLmFM0ZRFVCaGaIF4yHo2woEisoxnc8KpvzmtjT1HN6kTkZtV2r1irKL7O1KmV/EXGPD7Si4lfUYvvC9nLm95L6Ux/AkLbsvHbmi26Mz5WzoiK4qMPI2cGgygkIKySgXoJ9byDJOR7OecE1UVhfPKcTJYm+cW1nhImV8MHt+OUBT/1MGTf0d0NQBTR3Q1AFNHdB0ZNBU+RmDpqgDmmYP/g5oqhwRNFVODDR5479cMCnuwKQOTOrApA5M6sCknzRMijowqQOTfmVgEv7jJv7J8WzF/ZWFS3cfDi5d5sDRZScVHIVHBEcXzQZHK2aCo7H24MjmcPVJAkcr8+DoYgeOLmyCowt/KuDoalpxdHB0aXtwtArxL3kq4OiSNuBo9dHAUS0DRysBji4+AXB0CRd9UsHRRQwzLzkGcARW0qqnCI5Wt4Kj2skARyxAV6r46LDlkxd9mHnW+CraayDSOcw0ojDK9uaVEKjLcxDlqcETmUlnQ5RZylURnasK0cmrQXIspeuEX8RMiAkfksAh9qAox6RJzdZSMt0aYHpzn/nLc7VYO2BkSpe3CK+w4/lKVmozeL0WmeIUB9patJDjcv1ex0JU9wpayK3zMuyBVn/DtdrDp0Gl1TQphaLR4JdrtEUdgbRukYNAZIHz2bMqSvQzqFEGDq4EYrhS0QoHr21C1LWHhag7FKJiflpkJ6FR65J1Y+s2gWsI4CqdsUa6BvmH7YGrRbxrmsDVYyxY9ugp4VavMPMybqCAdrg1auJWjtAWt3pHwK1a16Pj1vaVmYVbowy3hjNwq8AisLGYVYdTGYxfVIUvF0TpGXSFwPAD2Qe9wFr7CAUyDoOAcIFPS7jLUMJatHztSUWyZ/JQvYaKcNbRNbTud4ZoHSPZ7Jg7gEMbJEsnB8jayjow6wbbQgWx7QHst93gasWvC1tHF9p3Osc4jTPXCH4evfrHjV7x+Z7Z8DWArNAs9Bo59Oq3Q6/RCaDXAOhVvySxWHrhFxG5Fk4WcgVidei1g1w7yLWDXDvItYNcO8j1FwK5Br8yyHXwxJBrB7nO4xhzf7mQ6zmFU35VQWt0QqC1A1o7oLUDWjugtQNaO6C1A1qDnxpoHTgx0NoBrf14jfxnAlrDI4LW8ERBKzM+/Dm2tF47E7Q+qwW0QqXORK2gtcJWUI6AWxEM4LrMAtflDrgCzDrgutQCV8j9A+m6iz8555EVf8UJm0h1HT9czJK+DtQLISwquslIE7Euun/qgUNzHOO2ALWN8/+4uCIbsW0R60IZVq+xY2gmYl2EaWTxZB6vSlbpRJsL2i7lAJDH1+b/0lWID7zqMOjiJgYd/3j+T68+/LpiUGSFluT/0prVe7YRI7YB+OYA8/eNt00umdkMgNWvW7AKxub/LFe6bljZ6M7/gfhNBavfELD6g8dvuSj/xwr6bAtWH38CYBVaW+dV1B8jXuvwCT2Zk6LJFqoiStcXez+6Iv+n6lQ7C1wk8MxC1V9DYsBPyx30J6I0ebH3GJixXytiMdUiEBdZwFo6z9t7VrKkSsucQsQ8VJuaPI/V7DPXJ1fRclpybbLerrVEVJdma6wcLDnXwpLLZ0OrK2wQZuw1TfFbUwubZyvx5AFgMS8BJU1zSr4iB2auPAEws/jI8EqnB2azLTqPo87NFX35yS96DaapNW3hk5fBp7QDn3514NMpbeHTs+janzP4hCr95DFRH8eIm5gIQOwqXjNDIRGjtOU/LZS0zKKk5ScdJdmhvFhBkK7yBiFkkpMCpWdk0Kkoxy99rtuxo6RFEIVFOZSEB+bysaKkxYqSFuKK/3E6UwbmVTnQdK4DTQf3WNBUnAGQVtAzMhg1umsmaLo8D5oKxw6a1v/8g6axpwqaOqBpxc8ZaFrfHjStbwVNz1bQdJ0FTetbQRP3xLlNcTpXJxGu8rnNS7aSdbbX9emammmau7jOTUhyVROSQJ1TkRVnumhIbEFHhyhbZkKUWgCtizlQZmDMAefSeotNrm9ik+t/QtjEvQJyPfMjfQ7QiUnWHBahrJ2BUOLDIhSeuF/0k0co/s8UoawBjbOXd5fW5CHKc04yPul1+OR6tPt6Wv+LjU/WCz5Zf6L4pIdjdLfgk2c7fHLdTxufBEfEJ8EJ4RNwN8Ds/1NDG0eHGY93YEYHZnRgRgdmPDUTSB5mrG3CjGIrzOCwK/RtSrsVeCX7jglwINbJxhxCv8LRrwDtZwc51uYhx9qfJOTo6kCOXAdUOUbl5w1yeCcLcvjVX8h3SqPOyfzOIafOIafOIafOIafOIadf2V268FfmZP5Q55DTiaHX+Rzj1J/tyXxzsk7me9VfkqsIBp/y5+IGO5+L63wurvO5uM7n4jqfizvy5+K6fsafi6t0Phc3e/B3PhfX5cBRoR046jpucIT6nyFXzp9Bw+iVYbnuabUEhPYisveUi7jKLpwONwfu+q9Abgbd0ifXf9mIcoGdQT+V4ERpdE1aHsLNqSizws6Wh5m/6Kcu8pJuH3ijK+1BuV16gWoo98mxEy31SZ1BCvlqu2hT2osr5uAvbUpj3DMXEjsxOxwSqXMwVurjsSZ+LNYsD1j652z0/Za+L17Jhdb2xpPUBWUXQMyowBhoKu3jIjm0V66m6wWxQEyLV8YUy+10sd5OF1Iz1WDrhXYgRemcljvtOA35uJ2O+qi3eUNdQHPgSQbk6tIBEHoxHnopvtbe013WDx/zII1X9iZ9VEnKVE3mgolcn55nc75lTtaX9NJclw/3P/o8AP/5UYbGAOc8zTlffQky5my3MrFMfUzkXOfK41yKUTo3c51E8qinVuVqzqOecwqf+F/GFHr1MB7fj8ca9BnNo4ArSWH8sF5CCXCoEpGUKEzm4UpPxEgDgMsQ8YeSeSwOczl0kLqTMqudg5w3DUoLcI9fMKmN4NpHqHyA62v5R4bGoLRokMrilrn2j5vVScBujEYEqLx29EErEAesC0EAfW+ciRekxsmXFZ3YigoH7rPubkt/p83pTTanuqXfbeNtt/StNt4WuQMRt7qzsPUcr7BBbCBNKqwzJC6LJrIHAjux5NV/HctML/VuSmKWuf5NScSiRv33pcEGroPc4R2gMnOZj+jOD2p33ooOkBJVTumUqaTEHRZTLw0M3YfJ3YpAJELC2ZRElCmwd9Cjs8vo58FmCM2dpDLCqhRD3GIV8qy5JW5HCe2A0LfKT5W6wbmkmyriVqgqbpX04swSibZJA0GORau6PhngKvTmrYW8hbshtWFcdRTAS6w0pHCzVVzucYo8roNM6aXNTPGf022oiIqOptyZ4+pflpahrsQ/nFaglMRPaRXKqsipy8/hn8p1t15Q+A15jvBcxfMZ5FHI68E0moo/ILNoRZvMpZGjpdzjqFMZWVGJe7hMEZUZ7pYppArYF0G+eFKM7PzVxe4oM4odvqGPtWvSy/Xtoi69StRGZ4y+cjoJdQzb8Vumbo3DeXMJIfOcQoD5XghEzBku0+yHNfszkH0Bd+0zzzmnIjgSwhlOo/WcIfvG0zKc0bQihJXTyqQKRfhDPcAnKRLNYtZWZ7SDG9ADLaeVi2w7uHfAT1mjoZJcOzRtE3OE54wa7jPUyS7+J/CxSj1oQ29rG7jyPdQr8JeMrrev5cDSSgNp7xL1gX1/dyXnl4yvl7lacdpiNqQBGVydGpCHy1LFuZ5AhArmYehtSou4VBV+sykNcbNqIHepssMhq9RZpsRRzWFYcyAlDmqUWImRRsH5jZLHZYBZ5GMM+zmtwGgOLDJ4jKA9AmoGx63BhWsxvErVf/ZMeXrW9bQoJ6j1CmbxkhClQjNQSSauiJ/L5Iv+rVAxqXIY+rbK5THuN0PQFDhDUakFOminMWbLmPPLtUBNtUzwk4hTRgmsABX22TypgjUHVVGWnQfKmAfKkl9asSaBCCYtLhS5Vpu5VihMypoXVTiA1wUx39MdMwH+AvsLdupAfoT87CmIUFaMrL9xJ1iZHX7iAYggD2V5LBZTejs6Itg7xjVC/g7X84zZzH3EszawwjRuPH/vvU+Gcie+2UyF9fdvgh/DWAnX3T9V3X4yr6T3IdjASfA1W+0zLE385rX0H8yupferxMEzrqV/0DOlY7yUfLB5Kflb+WbxAqpgbyPPLiEftJeQlzCC5RLytyAu+XIZudxC7mHkfqjlIvKs8hTaJhWlIbiAt4g6ZBWR+/FvfmFtcCM3k+sZYiLyMZp0+vEs/5CuC+nFF6WlJTYHrq+nN38X5eZvdkLEEyeAI2Hxh3M3n5dabz7vrcYfuevErzzfN+vK88H8leeDs648H5dStEsMGXiYDZzsFjIbwKQjX0s++6Z2vYBY+7H1AuJBd0/5y41c1Q2WxYrqWIygZaBNN60M/gxP0RQeo00Kdd25s0Lisc9Aq0A0xUiM8e3JtC43a3ML1UCs139DQIj7k4oiYBTo7eavOHl1gIppqUKEKuwttNSBn2dX4n3G86f9KcdiDKXUt1W61I4B5Cj852JQvDviyMKWeaHSfS4JEQu1aU6LUW71X8popMHKWuJ0tY8D+NLA3G1kdIX1e8mXiFTYuLtRT4tooQ+bgO8qv14ZWLhExNB3FuGaAcSTUeUgAh4iDI9AxhDaimEVf1IUCPvBFF9z/UJ35E2bKV46Tskt6Lc17z6v+zPuPt/qkw8x3gaXMx0mowAZ7Sk2mfO8NLyg8ErEgd1oEqN1r8ET2hfZe4/v8PC7xWN4+zJcW+xj/vkgR8MmJXYXIr5GebK2W0Aq+SsLctU5Bz9WwESl8ciPP7DVGsXJP8u/OS1LLbbcMVJ7AUTMVlNrWF7ub+ccgGAmPr/pC/+1/98fuuBG9r/GGz77zLvokpte9CKseqILCnsM9h0G0zKHOmtwnX1bDP+J0d4vFG5ZQdFQWmnstIXi3wu6uQWc6J7X4d/nxxpUphxjhtCt77S8WKA6IND5oroxjcAHD3x4m9GGUvV+Cu5v3ja/QPldFYDAz6Mk3vhfXwVYGiDbswA/gGwZSG6Gb1h8U++9t4H236B5VcFbqp7lXx9vvUMhrU8t3VQ6ajftY/aXWvqIGFnYlr9nrNHQLor/DZXbhYZfrxePP/4PzYvHt9uLxj8ohwML6OTHJLStFvY/hzC5olwzqWqGu/8fl6FmsRXP7bJIuzmTgy6TJV5dIzor1cExXhYqiTim93fqR3Eowt6Ivh1e6HqDviVPGxF/6i7BYHyWCo+7ZWPTwB6g0oB/zBNEkPi7WXDSngmRmU9+snYjhLWnKW3xeAPMbNQp2t2wtAXjjRsTg/vvuT7X1aQZFGiPe00hGxxv1Jh0AKEN9H+En8Lm99jwC8cb9YlzLj7t219ZMn9MotY/c/tW7p9M0Cnz3jTUpG8fp8x749CTXmoAaFYNEbu1wpqh+MCrVFHw4H82+eDaenYKcll/nsWrdDSPq7NMnVG91/8xwy4n+Rpcv/ZKn6XtP9W/jL2Pq3eUvd9R79sM+w+ofy80w5fU/07QP6f+faA/ov5H4d+v/s/C/wn1b0dJ+9S/x6iMw78fcfaqOkjKWrkuCdmKFGeL9wAiDWdlLWjWkppVPy2r4qB4Pwdvv3i3Ias4Ky/KqhqI9zOq88pNrfdpWYiW5eJ4zBvb/FTMAxzIo7wA+igh5lm8pAMF+vEcVso6Pajunsx1+S6OU9VIe4xGii5xMQM7Z4EBw6ycEqy4UZ0C0EBDzssUAK05EQyWke5G8wTSxFi1KH414ApHEWZTOf4qNA8//fVdDGaUGt+DOKr7EPJKwJzXC81S469oDObBnyv8qcWaM1Xiz9wxI+xTxgTNRaC/wVlAKWyZmcLDzkwvZZWXlptKL2w7N4XQnHA4g8G0VANjSng47dIhTRpQiFQFSIdLVdTckIzVMIANkqwiY3lNQfw+aVbINXcAf5UxjF3cxE8m3i/o0ydMPMgj/mcQunNc8S1XDBnHFfKrXwgCTPqGsVC2gjFaioVGAhxqBoLXlBMB6QUFGiocEcTCZ8nRgC6HQKx+MlY7/jt0QyqM7ecUcAfZbcBzGnvi/9ApDM8xBRcUUGEPo8bUTpuM/xOhmqVOUMR1i//lriY1/m9JX7RP/yNPvn06KE8hw3boO51gnB5OPXgPiBcLjWDtkNvGHx53qvfK8TpSyvSTFlkvZ6AAj3X7WL+w0RCCzO7ach1AWZ3/X+2wewER63UAQB3Dlg9M9jEV35h6Q2lJx61nx+Go4NHqxI6XFrZe+LWlm6UzSvdScSdjr5f+1djkNxd9jG5Sky0quSspaqecJ50C+FnUxWSxWX+Zd2wTlMLZ7eIOdb2coA/dAhN1OyIeKgw16tV3e7wuFmFIPCcX3GSIjMWqLvOmMoogat4qHJeRicOuomMmt4iMsCl+BDyUZ0sndm9CYvCduzEA3WONTWZXaiaefPMP/uWK5189Rpn3pqGJ35N/3+BJmdl89HqhGjbrDOOkhtO21nUYZRvpVKbkwEGWIatTV9LQKkD0oPruvC1hBurGHMHlSOOXJTqG7EhJiuS3RUqyuII5io+Nv3Qj+fGPMAakfppDjByQUVHnNJTlFunw9U/q+jlABqJZHpU2+Jm14ZN+aKBD+I/XJU6PjLZYbs/y95s0zKEaw+3GDy9y6sIQ4cTGtKQ4h3637q28qbuQLbQiCLmueEpW8anBkIxgn6bkU0nxdPkP0sr9WEvGm94jiywYdqm8cYMQB5lYpWqjfi9wcTMxb7t1NahKXbso5J94y51cjBN1sb9ily5Kq69rEp/XnY+A4DjtagkmFASLbqOOcR4AG8lkCaUPKyjvIkbOJlXCkqyUY8lqa9YcdYMvaplFi9xZFMokiocFk7X3bsM8CrqdRsElDXrN7fmJFHQ7j/J/blb4Shj40+Y2dGa2/nN9SUWH4LbuLSzFMqqoUyiDaAM/hnh4pDXD33G02psw4eXmTqgehV43sKfOoUWExv96l9Z/61ZPLRgp23HuQKEhaDJxb/P5oYDHJ6tiY8b6VHPRFQWogJYHPSq2WQtEPEwe4yAg1D/SmLdwNiCjMoaz4yrngesWo+HeNqPxr2aHAGjFGVdnmTqj7DzMcYatS5rkem0h/5KDX38M2WKW2tWmklhBqbfOWobNsIquddUx8clnTv/eG+r/PebmoXEeWF7NaOOtstFi0NVKtlOwmbhg2+hX/vyPL1khkBbTfJNyoyuzYOfj+VTEcn8H2LrD12lYc85BxzD+L0veBuMyND6MdDekIZyb0hImnpANGaQ+mDTZEXNOgXcJyUBNRKhOgQeEUQNOlZ0YEatUErOOL7GW+y4Hl5pHeC51qKmNS22oZE9uY/BpBhiJoZqQsMMBkI7eiB/TZuBFx8Jkk/r1JvVAjvptUC1j99yurOLHO3wdEBqwHQHwN/HbM4xpZ8HhzhOg1sY6szeoYlNfLDPi+vxX3GymZm8A6Gyh22zOYhBz1gEfrCjqhhE7UVq6RtSOOwOZlu9jo0NSkR3VpMpOuCmRcRzAgtRNSJv0wImTXjiDScy178MKDtseWw27VQwPdruwyeJTCYNJnJuVeIPGuV6TXK1PqzRsXGMu07BRJQ5rFFLioEbRvVkfwtSnh55gCelt3c5P51BPy15+2i8nAHR1RZomnkoHNqVzmToXaahM8hjzo93G7ca+Nk4AYPcfZhk9q0cV9nBBZorL6Zddf+pDh/VRZAU1kCUv+WLlf1YTJc9jylvRUTql27VejEWsUqOMGhDA6Dxtqs8zRPwghEN6DT+cin3o2tpe2CNcd8WfR7SWvY0zClkUTPwuKhIDZMdfvOuYon1Jov1bdsikOOOQSfkYD5kEeshkL/2Ez5hESn08smdMInvGxNI/Z+Ptt/R9kZ4xiX6GZ0w8d8bEO+lnTHilDuRh0cYALBGzz5h8sJA/Y4LHtmdMKsdxxuQLT+GMyYUzjphoG7jygR4xmZpM+UePmKBBOGIC98hHTKw8HLAu5AD0vVH+iEmUP2KiEqOSgiMm1t1t6e+0Ob3J5lS39LttvO2WvtXG2xK5IybRUzxiEp2kIyaQt7nQXOxJeXY9teWISfmwR0zKfMQkbHfEBJKcchcdKnijDJhGSf3EfrL+mP2x9csWG0RiLqThVJsBce9P0tynchIlsidRInsSJTraSZQ3Z5vrOIWS+IfdVvdy2+qQufbb6uHRt9WZ7iMl+8DpKlJKluwZRloUZUWfEyFljJScW4zcKsit0sytzAOoIvXwOQPLXOSileTEnAM/uA1077Ab6PERN9Crtx/fhp535E1FtM5DB83eUwwOu6d4x8mrgr73p3Vot6kY/JJuKt4XFrF6L/Ffc+H3znLOVFrbEU4SbI2v1ddPiJd59RC/O8K0tKFWXo0q2NdafjjW4AHouyaN1yGOtTeFsJpihMAoVIUT4XCPxZdgTw+6xZ6BCrEkxBijomuXzw+9aewePWevOsCroz704M4c4ZSJb1WTbx768ffZ7+/kmv8lam5tsNRHft3RXD2bHmnddm4X3K1+Wrx0CGY2cBN/q1mtKnbvRz3JX+6/KWRXa9zPWCktsWBwFbU0fijxw87X8a4f4nFIREyJQNkdKmuSotUqFcTvJVhkeqWVN6a9Q0lRBJQ9zAPIZMmOfpTCtH6IYj/NAQ0HwbqZjMmSIkYWp9S5scyERrNLXjW+60lfTA27d9Wf5AbWGJDJSS5uW/FlHELFl1Bp4+7Ur0NYXLr93LEYMHPQbtSaMXYfsMtZ/uOYJxp16uKSla0qJG8qpyUMyRKzJSmiYhHXt4re7oXDTNSspPHdWL5IC9EA4drEd67Z/bQ//fY/8y5qPxczIFypZ/thdZZofzk4ClUFabmFmS98mANOzbEaBGayGG3unSm7/kvtEWoV8yXem7RP3Not5KHgcPSdnoc1GLBw84iLhzWRDPXBJCDDC3yPyGABMMiOD0hqagUxYyMuSTCinwaaB4MAkWdjIPXZGn9Y4ntngyDxh0HzNIYnMZDfMi173JW9Ssse17KXaV4TWvYqCUb0CdCk7FWa14SmfpbGv1rLfhYIEv9q0DyN4UmM6r8YEx3jQaMDhfxJowEcUPmqHrexB4702Dkrt+zkERLp0aMIFhd39GhATx5V5ORRKf5ay7Gj+P9Ts4fdjtOzQvHXheihIDx+I3cMyGs9BlQ9WAmKU0ZOQWQaGWMfehvDMcjt8hcIW7xq3a71rs0bLH2meKu7TVOlJJnNPAlVbbCOzlvSuf5FzrPKrXj9q7kueSs9VFqdihrQYOv8xD88dNO+H/z+d9kAv17+/cNYMye1+6f+xLyND8/d+PDvjWUW+/F79u6amF83/P+asXpjZ2MnFXfVE7+qwQf+dJwCLQT7G99f/sSPVo58g0v2d6aah0a6aSi+F5E0qvAnoKAO28KNbush3BV/WxaGpVjWuy67/+bseJRyyaV7NJd74m2IsJOT++DLjUMtFWpXMEfwEAJDssyKzDj0AkSM+xwrR1QIWMXWkfGRALMoMa0d29qhxnWomdWh5he0QyvH25Vl7UW4VHa9GM7uxVB6MXzqvVgSzsPMh9FeJdeJHvOLn5II0SLi4+DogzZ966O/zMuoMPnz1Lud3iVDkfRvWh1K5fQjsUf60ayVORcjNmEmdjRvR/N2xmZH83Z696eueWcdJf/9EzkB/81ZJ+APFHJH4PE08wz8C+WECON+azGBE6SqWrAO3FCrT79QE/rxY8jfvUoB044XLUUuWEF6+hYEU+X4vx4aitQJ4KBWo80T90H8LWR2tBP22Yn6gfyBejTMnai/WnbyUMKlMo4CsQr6FOg6RFchCT/DxckirEQljomfQH5kJMRoSLX6TONphrqEQq7gLzYJwRFmyGTq2aQeGUlEBWlu9TdNMK37iVj5cXFYrOn7pKnsb0tHICRc6CEIUwUCscGD0NAlkCeYl1K/Nihl/KNnoqf2Tkn7Jd5gfoXX/uWSUvzd1iXe/4/HI75NUsq/TVJyb5OUjvw2Sdh8m6Q0622SEuKJE4iDsPh7uWVkOOttku/r8naN8dEpnuzKcBTpUYE0VtBxmoh8GCHiB+9QyUOHc5/C6M7MSbgy2Jk5sRdTHj/eF1Pyw+QHSHzyX0TBwM8Jk6c8y8TeZyaxIfwlMpw89B1qjPelnEUmqL0Emz6/BdmEsNdudlvlGH7SqdmS/q3GGFfc3uyVUjLtWAkDkxx3GGTHW45zHHj9EMd54bPHeeHT47yGDwQOJB4obGQf5AwgKMFynPiAYXAUwo4e3tnQEzf/KdKL0gtcltiPYHdzlX2FVyzao1T+tLKelPUF7OYmHruPVyaxI2G1TcAj7THWkSDXCuyVIy8YgcFuDDoW5yCJCGceB9IyZmyZ0osbdPuQKrB71RvYwUiqVEq6KMJOLI4tqRGxi53GzuU+QILunMDpom6U0U3mCnSCZJ+UYUSLQI92Sxm7d2HuLuHMbiIHsBpJhSKbxhcy1BpccMmoFvym8c1UwGzQFyQMWXSw9+XObllgyyQO9TXNks2D77Dq/gVYOfHJT+Dff4412MI5WeP/p26NPyHnpgJ7+iIDAv4u1AN26aIqiBBOAFUgE0yGV3SvIBDbpBwgSTHPGu5dEKKdadSoMyFqMD2K/0v3PTPsIodSprkB0tD/qxIF2tu3mWnDf9Xbcic6wryWJWdG9V/CYKv2WMXuO9mPPZaovCEPqyqsBXJPFGnfSuUrDenaumxF/RF6lDsZlerSIRSyvJOcd6YKuj2SWSyyG1ZUkliqcXDWOepu+5JF0sNV0Poiw0k2yya9mncJhZWaH2SJyYDzfXCYwRTwd6lOIZ9/56CFbTLvEQntk0qmVf3kTj/FyYDT97zFDsST+7pMMpd6lQeIx6nn0gCHUBVVQPiAY4aywhrS+2mA43W9Yt9HXzj6u18bcy7ynPWBKs4lnTv7C1MgzwN5HFsje5yr1SIJuWH+8x7Y/6Bzs5AX3+KP3Hnqrvc5FyHIjeQ/fkqlDQP4Tys69einn3vB579+kXOlot/ecdad3/j6cx9yLuch9E0/etd1Xz39Iyuc6+iPPu/hU+vmzD3OdfQ3Hoz7+vpuH3Ouo68WYP2hPc4F3dYUdbK4fI9zETbrM1scGy2Y0ZxHlm196FtPvOlB50rSD77rgQff8L1khXNdNe5ft2PLVZtf+5BzHX37wMe5GU+scK6j/+E1QP3P3uNcR79cmvH3Y87NmjNI3L/GSqFz01MPXTlbRrlnPmPS+YfWpUNtAk+jIXxKjHPzLMm5HP1KQtpD66zgdlMPi+Eg9zhym0en0TxJS6ce+pShWdF7eFR4GKcRdjXySgDvbteMKIGQeuRrmRU9k8fkW3kovchqhS7Z7+fo7IF2EAVPRSiOArZg6sv553AZd3PGMqscX64HOVf+oTB3aOke45npcEpVDUaln1dxQeYtQtUYVY0YxJhzvXrLpmrmjaSaUYNKO7Flom+0RKz4jSaNMGNSuZ5i2vS1WD3zEmBBSQW0p/pnOVQxypBTq9wen2ErS976ZqeAw14lQAtih3Hj2eyUamcLmoCP2DcIn5yOQFqjIAjIMz6ICYVjjToevS0M3c4t3MPv3Xb2bjt7twNo94y92/4T2LstJL0zNm0HWjdt0fztc1MP7ta56VzWVt6NQ/aViY+ONRxeO+9I27f9YFb/Sd2+vZRH6D9maCz+d10JzCYxccMsamNXfPerkU3NrvtryNVglfO/bjdTDRomfhKEVAwQussIhwxzEovW9qsmm19+1YQEdtX0aWhDfyq3kgnsCA+gTkbZMViwBBBq3g9GcfIiUCAfnmAnsAsZ+HQhA58uZAqykCnCPTCQhAhpLmhMvFPMSiVtw04RcC/+WxBzGLrpfd5Qo4HDbuTzq1ANsUDEP9IPuwS5tc5Xf0FgvkP44QyEjwHMHXhkiP9h3/cxh7VZgVoAreoo9OWpi8XVhw6CboigOEAtkBB4qJS1K9IKBVKHRiOpNovGtKW90ki7dlJXVqfGvUkk02jQpD2fJaO5LNzJGZalbSwxXH/qkk/+VOMtbHzEmTxEFFWfpanr6rjM8bobaYUfR/Vxp6x+kR/7SJKU2TeIuV58MULvSTVq1IwKNvTIl1CJlRMUrxzkK8kMrRoWilx0rCqb1H6ZiF/c6aZeJZRRBSZUIPtoCernWlKFmuGcrVLpwUMPHkSBQORC6RPVKPmF+QFjmn14IOtDKmLQXc8OjzFSm8HVuvRfxQ7eSx/A73sG8FUBfBLhMrEefASnE85rGhJGxbcPxLPFux/eYTsqjTUvDOODOBL8uYKzSCz0CIedZUTuTL3M7D6eiUXI4xGdJaPX2iFu3+be4nAt/EePh2M47f1Uh6OYAvt1OMY6HLt0OKLrZXCWZw1O3w7OsgxI7XbDyibl7gWpwuLc4CoBWhoZtg1diUN89KVVl/wel/5oSav5HYjEzw/xJZgN8lYya0xTc1bTWMZJCmJqg5mV0z2/gPCryauVXzIp6JVPzoO0aiMeS7fKSUUctyqo9ZdgKbaHJH2MEcM/zedgErWCxKaF2pbgshM2Gb5q23GaDDcc1Y6v5tjUj+/cdhKt+HdtOwbz5AU5i3rgLOpRZlG/GQb1V2+bYVBHy07EsnnFYTcEtqEI+yknCthp3Q7QKiCr3G7ABe13A45cd90MeHFBj3Mhy4Jlo7X6q/UdNE9jeDYGnro0fr/G6tJ+wNjEskUHK0IlSZc6sTr91cuMmW3WRc24zlIc9M6P3d6FM+kqJW+w7S9oN6KfaoX4L0RxX2wHGRmxDltLMZ+hI/4ZnsTvIH4WTG6o/dGt5E0mVg4LjjNetYR74vYWqs82ZvZmhjQczQXmkvo6XyA1kYf4taiMev9SvVm9/xoAzWxW8fZQVeWzk+QCd0Dig97sCZ8dGYhII5qjIFAxwQas1F8JOkC4DXgMIBMa34CP1gl6qzrkQILPivFv8fC0JYhykt5W3pjmeLVfK9MBq1kWlNHIUlsTP/RK6anEoB7C1Jl99dc/T311d9ZXr/uV66tHjtpXr/956qs3ZH11769cX311dl/9N+BmG14Ss9pMCj+hO3dmU+BLUk+qgWL+iDwGAnFd2KfBN+eCN+aDJc8vFTTPTB+Dur8t9cJ2xNGM+MPbHZHaxeyfFbPZ09l0Dc5ZLuq87sWvRFM1QENb0dUJgp2/nwV2gpdkYAcPM8DOM9t9uK92y60bTvybfUda9D9hjLmt7VesYFd802teLt+pgv/unH9rzn9wO/z3iyRhnKL8v8XTfP1O1uc0bv4V9/0gaeg+9UK292be92fe3eJ9++Gy9w5kUR8T7zvaRX1nG6JgvRozce9/8xupidFM5AFsw7IZDxhAbxJVVv2xaYdANLICkUfMzK1kUPflqF+02ueDBjryLfZpb+4JKR7IUmSIpvamttQdbanb21LvaEs9WJhBZdrXjJWrPHKK+ZMHYImra/UsSKtD1xDh5qdkvPgTiFH7jsunutXLuLff5KxLGCng8tuQIEHRKpxqmK6Z+H4J8LK+8mtcQNZXftZXvu0rChwXP2G4hE8Y17JA+NievuMw9O2Hod/Rng5+zqZzm5snBnpDgy3ZzRFvylaYgUiRcqNq+2R3/f8w9xXgjSzHuuohjTWSNbZFXhmqe33wC9M6fCab78T7cui9dyGwZ8MkTzbk3Bt2TpjB8QkzMzNeZmZmZvog4OTWXzVtSZY3dHH3s5pmuouaqmuqg+LUPYsfFlH9ILDBYX4tt5GEhJOEy2q3sAlJAQYgzq1Rcqp2Cw5iThKHEYe58Kb4uVd/4qPRlcXfPnNcI4aVIryyYFOfyTw41iqiM8XXnzOV3Tw+Oy9uoJnMFTwbzGTf4vjsprRaFgzekZJO8bRR0Z55oWPrCAaobrbxgU0REEpvMVNKdk6dJv3gqPjj+kzxhm0guBQv5zOll1p1onR8wzexgsltijvPFN1GPg4NH1OYaRyD4nm70A5dcWaG15sVr7dsLOG9bJu05OHM1YdzvM3hvSpub1XcZgUMRN4y1yHidoHD13O4WNl2LHH4LA47xSZOsmVj2MUG//OuV+Bup/pjEHy1/n9ahrrFv9XuYfv+M+i+LMX8YxhHv1bfmkSnqKFO+Gq7Tg6sz3GfROqspO5fpe4/VfZwTdlupp3GDqg7RaL5IvgBsfegeklzpeteO0WqkLr5+2+oyPwEfCzO7/NCJZ16jKGSBVSfBpSKjVZhbI9z8ZLrInhKZRNEXXQXxdH1Kyxtj/qTdIlG/JJaA6FGfMfcm4aa0m3XBejZNLwdysbwPsuAupQB4MFRgAcK8DINDgHmv5BL5E2F+nnGZd8E7PAYsDMBG/WO4CniKNicve1CQN4QawymORvfztB9aZLuL8Nha6iE7x7Fows8MmJEBQ8yWOBLeiR+K+V9xWbffLdMmKY+N7LNrwGHIjwKEi1Ogv56g2r5ufhCoPfIeNCbsGdNkRbQATxqUODfbByAAZ94+fefiEMKyW/NcGBhEo13CxrgwLdGYwp+vKrwv/+/Cn4e+maAzyeB//gE8I2jwDc88A0BXqCWdxTqT/+nQo1mRpRdWXxqIo/V1klY52k6nnTzH/v9hIxbgE3ncEmO8t/DqzbR4VbWCT6vrkOxrCl8XqrDtKw/fN6cDuGyVvF5DR3eZV3j8zJsC+9Q+yNDxy3hmwcZvJDWCJEfMrr9zAuzg80i/vhEt4W81M2fd22Y0nJixeVqeLVQks+7BX5uwpJYpTsWp9A5vuqMaeF2cmzSvl1wJ3VptSleqIKzFGOU39wMthC7LLjTqeAqjiViD/w9FKMmul1wL8REGfhgjs3ruUVI8+f13CJADMcW4q+zXmE+r03tqBHtU7QKBugJGttQU9pUmpIjIIk1AQifdJwVtxACXrkZkIL36FPBBtaruviM2WZCLqbMPysNtjihe3rxqNnSFTAyEYO4ysm1yiVUqQKfoFLhIUjoF67qDwzVC9KA46rN4DqF4+6nhGBGPs0VZ0AC+1nF7DbsxmwaSoZAQTRjEH8MgnIUREgLHCq3899HklO/hlSR7ECtn/8bTuaVA5FgrktXvU7OS/zYPVzxDdlrfpKr4mp//YbnsWjjGe/q7SaiOGjV/PNkLvxs9tzprdXE6ZcyDVw8XP87I2dMhewP+L/hfOP4d8uJdO6UVCsReULpjPj4CNXjaf5hAcDXQ1H+EaXQeIvz9hieCp4Kc8noKTgU9D1Mh56fM/j9KeNSZvHp2jd278FrmN3TFAydOKq9l5wQNq4fitWSfJaE88QU0IA1eOZ7YA/EeooL9NgaF26MyEdznoU3EcM2qSExxh1ChVg0UrVPvbgNrBsMZ1hT3X0xDe92cZtH6rEj0DeUIvw1k39UKCBxZ/QVF1YvZXjJyQHSpIVTq1Arpxbcm4zE/KolULm0OhmSdaCdG78yX70yT8a/Mj/9SnVPBVY0ND8+w2tR6zDBp67ttwkFP/cWmvucy9+KenFui9on4BPYzIVga9G4lvytNP821zo81GR/7oE2L/8ejGTr0HLooUhmIHY5opxab2NnHh1oWEB171wxuMcElbP8Y0JfSeUfH8dJ7o3IP6E5hYGITfStf3jWN+1bb1SXJCqTP2Yq3dtNuQ54KDfjev4S82nxKdSmjw4vXCkFynYFWR9XYPEFxocNBehhIYKdEr9PoLAsIp2Rq0Pd/FMy0Pxeb66/a54qrh6x030q/AArtDl+mqULMSmvP0Z+wfOQpQyEFA8r4qsu+lrmtYv3d7HkylMjmyCvFLUjLHSCx7uUN1hWPCIXX9P5Xxza6J7twbbJ+WZLJCE6o/cU8Z86mAMVWzBWsItUl1PkeU41NAW3VmqSOfknXTOCQVFEi3AQtQi5muNXMs5JqXEl84BLsPlCDZgJ8EKkL+zyC/qZVCX13B48zVF8nsdiu9Q0Crbr8Om27TJWHUGmx/D25fObPiTQDaCw5rX85UHTniBO1ewQFeI/ktF8UDNBRh2I7TItlHaFa1iW4g4Twq1yw0NaYSg5p87RzohTmOMXqXcGOJw4WLJrIAR17TpQUU9KtEaLB2eZEM83B+8xB18xB3c/uGaWTpwHSi0C8UVPsHUQbB0E6zLwHeqCWBwub9t1BmJZUI0YmGWGpSIgnaBFPlj/2Dm5YPExU9QEkbnSXa00A+I3cUNGGbFbAOtlxnrAGCq6y1PoLk+hO4uootk0R/4dnDx4rjl4l/musB4o1iGwHijWg0OsBwySx3pRfSp/K6SbYSZMNlA/j7m7IujmtFzi4W/GycjUvjUP0wtgE3keVo1B3HeAAudHil2k2HlO3twcz8ngApw0M5xc+d/FyeA/jZOBcrJ2HCfbE5yk4xDEr1sjOjhNa8csLiyuyrcHBWP1zXDNvzWfBRThqlue5vSyZ/MirsJ3ouDZl9/7Ku5FjRyduH44RYPoAoyv/W9nvPlPYjyQ7nOO6+vWlIKJCcEtjexJnceGTIYNrvckbchEuEKGY5gLuH5MYGjGrh9OAtF4EliHNW45gvtDoebqpHuwi/hZJmvJvpTdImKApSvJDohbp1VWBFVTK4MPbmDVhaakTdVXLY4YW7ueeSTXoWcaCK5cbUd84A0+bS/KaIWWsSD3btQvElPiVRqO7KpMC125EFgGtnXKBfDetwJ8MA143wMOnCre9AALxxZhqDyDAAYmgX56QGIZs8xl1DygviDR+U6QCASJtiAhFtJAZBaJjkC9jphIguKkSCyPqe8WAVuXOFg8La+78AqNnBjjgv7HGdl0H0PX27OO1tEAM0dwcZ9TXDqzuCwDl2XqM/p9wYUx2cC7G16DktBShRQ17fA4xJqMmIuECYhPo6YMkKeiEWfS4rZb4REPvRzJZTwYbWMZ5OcRwYZWOMutMkqz45xdQ8fTue3gg8auzfbfNfw/aKVzjazZmm9z/wjxx0+7qiiKk7pkj4sOhgws02lVun2dKpkKlea0PuJST20ReKEveP8pELh7HIGH1BxZlloEU3SmNmpqUw4ZzL3v31gP759izLFXAhrx9yUe/GGQLbE/M/j9IyOrZPlGRG0ROAiKFXENjNiAY02JdbwNhTjRzT+P9fzk9X8n4M39i8jl8EtV+EMIs4+ZAHvnQ9VihPDtxsVY31fXBFjJ3NfbXQzL7dPvir1YBz8Dillq9/dcciPvc1G2K94Kk/GpAdQS/Iw8vQ+T/P0bbR3DZV2sFLk8RTkSMbge+y1xgCDwdowRht1IiLkiarz8N4CcY92a7ItS8adpsl8zxkxeF5t6L/nYdW9RCpJfxUEITVgqbtE4iKEJSymBJiylOrRA6QwvuIJbIBt0TykVC4ebSOw2YpqL2CbHNhATowiSmFzusyLRH0N0IFEx7e1I9OdqnquiM8i/IDxKGf6xkzljjrU1LgJU7b9PLkRc4rvdwIU5TPdE1ZaqRiuqCthRfyCX3oquS33HxRQIDwixy4KI9WqqmdrCE6LTEuWsfgQPjFxAsfC2MPlnBF5p/Xv4ecNKw0l9VzSj77qXHkp7fZeaL3udF0AQ3RlsUEShNW2V/OvGxLvVGTLh/Pi3n+nPR6sVmJpLUiRuQCQnILONsSRkd6UoQTLXGA5PxDuBH60TLJLqkDlDHNQpgR4E7xw6TTUQVONHqRQ1p/L9DiW8tJRPz2wd7WfqxHzaJLfOwYTWQXiTZX+Ujh0q3GLsvF1smG5xKrgFYt5VrsS9q9zaGDDEZSjZFKscMvxTaV8jKROnfVqnOP6TvNTFoLfEI5cwe7xDgrr4KQdaJfIfLPF6iWsZaqLbTfKPPgeWGf6FWNp3Cat/d3yFTMDzePsJnJEU66Pi/o/RLvEUNV0q2OQAh+icejUObMBArCYT8FfUn6LS+zCHcxy+ncOGVGW4fZx2AfynG2kOIs/gPcuwr/5K/gLJlirzP/ZqfhnPYtRyO45BvLWxfa4zzn+pUr3q0Z28P+LW5OYHydQJBIMCUlsuZt0AP7HDt8AZeIFhIFCwI79PKPM/Ebmeqx6uimJfqicrdSmdzBLJlVcCyXb1UubfWLQNxeeNLusSkTFxjJ7/NBraDJqQa4wkH8B9Jf4zhumqXCxznaqURYmigFFQOmZ3Xbz7qHvdOQ46THVpKBbf9CBckxrc5PPQ+2zA2Pl43bf+p4K23CB4E865ifRmyQmmc8Q7gXCSEo0JCN4xTXg4oBWRctW7LxFwOgjQpzi+olmDYx+kiQcv1ayNo7AC4Rlwgf50poi7jRFEmM54WDai5aK6irhcRWIwmcgRANgtKvuvgLNCaEgNQXKGLpau6arvEccFNgbJi/3g0Lymlv8ZAAXxEwX8z5GWaMFXX0kixlwZq0OFW4wt6X5Op8bZj8Uwwq9QVPzFnz7nqwz2gKMBuByRNBQdZ0EHyhUyhcjrmxT5CYIoAn87Wp5yOQpYMn6IDclEla+DfwToobicysMhgRwTyN+ZIWChUJWU8q3Yt3dnxo++aObOjG/xxs8e88Y/myDi5dGs1aUOIAzgzCIhBMWMLtiMN3SHCKkp6w+jlZnlVqjLrVCXW5iLN6z0xg/LqksmDrlUzyWbleliQvH9xI+N5OKVFTHZkCjdT67MAuG//lwm/DeYQ5PeqvPpFdWkae3X4nBxN+TTFJFRHTNMaXXYsKFiLPDfCfhKHaWNj5y1JNvovVvYCQlQBUegG4YhbmlTSPeOnfOWZ3NI4RRGnImk+La0yUGwo1e8F5DoZGfbtiUWciwvmpUeOEMFQkVawEQhRKP8cKu1pH69NdGRUS7lbUyVlqnZdal7Flm8ssXPl6hePAGOtKdtZ4a2k8FB/p5dmqytcTWwpPbI9fhD1WOr6xUPv3B1r7BLUg++uYbj5E1wSj999XvArHIsrguGBWw9FnCYgX3GPErmq8WEuBQLRq4JooDULhbiMmi7jytB0JxikLdFMVIh1OkgKpmSorKImbTV+QyWxWPSzoMxStoFQKTy36bEMjlt45C+EghCdfH8p5vaJUaAUY05vueAoJT3rhaEc9AMtIiFGq7jy4UgWuP1gCSrNhJt7h2g6132z0n2tJR79/eedjEC5hIEtSH0mwfh8KVzCDJWR0BN7fC/Wo9i7vBDPgnRAzZrDjtrMNlZA99Z9Ww9QJCOBS3RQB23R8L8aXMt7bi2LlJiE2Av+6GAEgl076PAz3ZYhem3jEuxkI0f7+Zkti5M5czHiIXMyOF42zWVePcf2RYHD2fcOeB9cJuDB0OExPX2QhGIjgX9pSOVLPB7nNmllvqmWiT+OzO0PSZdp7R9yoD5AEEqap4T1IGsDfm5IRxOVAYL18oZxir/rc2SR9SDuTQAgVynE7TEcjtCIoKREv54FmDFAVUv0RpakcqnWrFV3TS0ThCwXHWbqyZZdc9XsYBIptVEh86Te/xGnU5SIBtZW/erdM8CP5dmFEFjEJGDxDjqecOsPq0BXBeOuJ7kRoHCb4BdMAQ7Byxrwmkt1MwTDD3TbLV4mmifkOrSGipfowWtfAmZS16tpW4BVFT99Q405zt+yjxlFBkLaeQszsd03NHeyhFG5WMovOs+ty+DBZAjHYKfpl+RkQ3UUbgjEaGe3lrAQapaAUMBCoQ7MaYAa6knfUAnVQzqk0DEBEUnSRWRc+fdOi/vkBeV1UH/Orlym3nKCqJKE5BVku+ZYCdnZSKGmhlEFeJ+eZ+6cFuOVXWggliIDVL26SCYg5JjdurnLPUQp+tyDnZk4ckSiIIIZel5eDhSABolpeevVYeNJUW6kLaZIF3nLOlpEN2Ug2iniB5rE21PZbOJnYMMqInMFK3PzwwLEc3h9nLZqDQJgNlYWsIqMxLE0hHO2PepufdyyFGC0SGhFKRKK0IJNKIrzDDMZYKaTTxSNvWXjVBMjFQCvM6oWDFlG/6bkx/pJgu78VOTXcN/UbUOsqHM/qoWukLWKVK3LBB0FyNw0Labw0IQGMlpqhz2liyzAc9G0F5xToKcjIzmpDTHSBvLXRDbGpTDoVhThiCOhFtufshPcIw4ElKC1XxSec/Q4bnN4JtSrqcK8IszY0q3bahaS64IIunXLgtoHxpml1zjlg7XBaIUkjungscWtWt8frcZZKiEsq0jWQE1jmYZbvXbrKCKUc4nZ5qgnNFIBQ0+K4a7DJ0Ih7Y7Lg+PK+9oBWIv26HunuuPdXFdnmBfSP0bbU/VIocIdwHvBJx9hTOVxcRsvgH801lNahzNCkAAvP0tHq1i09inHrUOdTxqfV8YHlPYzca861J/zw3GePepy3gPbmTioHthmziHzcmAUym2KnPypauWpVoWaRlsgJm61EH7ENdHYq5jrbc9UcjhvYjpkPschrcWLZdwTSvzLuKQuqn/oDmFkC1eaG21DCWgcU3j85RdI84WGhxkQhBgSw2V56RCuyLDNOM52DqNJZFpphn1T7Nnlbtcj1R8mGpF3DpuO9ZRSVjhAZFxkVoCjKQVmJoCA6I3PRgt/NrQyxkZam5rJQGqpoBa21pJoJUEqARBg5qlXLhcVeeSyQqRi4xtydi2iW8gl40O/yji4TTiXpg1Tfm0XLjOOYdXqSdZL7ti/5yvJ8GTXepWT1LnRqT4fw/RHlX/9/WfzN/nmJ5BBlgMTLx5Ehf/FPMsFo6pJ7wHjuFxDI8mGB5rPFKGx2OGxzMMd3GF71m9J1mcKx2ZN0JKsKpdQetyD6G3LKAYLa96Dke0gtbXJE2ryuE1z+HYt7siDIkYUbBWgBeAY0rAW8FgRTNi1BHTCuqIQZtaEd6zlTT55dkK5XWl0Tb4zYZDgfIiOso1zR5z2fXOOX5cuuM0H2cIdoStvYqtePNCbGVcxWV5fE8IPnr3fOUOmSJmTMa/jNoQRmlDdQ5SRIWCLhVQH/Ev7Z3+uZ+76i7SiNbLrY8xkj2L647fgqymSP7Q3mnc1nr8i73Tl5196Z33xcdfl9PrOq4NLcFXkzx+X+pp5mN37Kp8LGgtLSBw1K6mwQVaRMZJtaSiBifcxra9SDvZxRroyn+RVnkpwsFF1IZFfsK39h6wPZoLS+L4sySeoILmdmnX+MEN4qLmqLQnaEF0XpZOcpZrbZfkoD2e3y5HtimF81LcGpX830p/jYA3Iwhcrti3l5ChRbw9xJbF0BDcCGgR9SxDigJYHsXVvWhNm/huVsh3ZkjT4ZiWUDw1nMUi7HgroxZKDN6iqm+2tD9GVX/0V9hLA9BHIxB4/cLNrUzs6GSYQnF3dl0HDCGFvMXooQ4+jtct4KVK+cu46rYoPGmO/y6lwSt0qe7wkorFF/f3KvGhrheCyzK6hHp7tksX02V79mK8uQei1kDUvVfYHrriiiodGMWJ1UGImZHXH8DxWLivOnwAyBtB3fY4QSGBAlPqDIca8GFQv0KzK/gJKAxFVlEAePwQ48FjLDokFizUIuH0vHK6SWsQFR5bpfuRsDwWltMirl7lZeuIVq+S5WpbHYBJl8S5/z5dfPqlP/L4O+/vtTM5jsxe+UGzvMoLWMN/bbZu9LbCwVPjJ7c5L5F0yH8JrB85DDj0V13XJ05iZKcgilsKRKNeIi9Cdv28TYmzS+JYrOJCdX9bvK2rlcccZj5kuDonKS3hHjeC6pAC7IVQU+Nuu6eCf8MpgmxKAn6KFckBpwM52nhegIKBkxc7rlm6FLGrXILzS1YZt0gqj0sMYeI7B/5idONxE0goh5IQ/R0aPrON5GZpaxnelfGhQIdhHXEAY37WUOfU0kTOTSwIOpxkWeXlAnHkzFDsexqyQWnI5ykBFgGiA6x5+9Ca2oeKl7nWyC1d25K786IRdkod1XN0qVH8mxnZHoef5rDP4Z/Jl2ai8VqmBQQnODcdWaiHf40LRcNAC3ZNxq81gQ+VMyRvFnheb2gN4avNo2Xb6a1IIidarnXL7JCdb6q2DGKdGtA6Dvf0SFCvCKxTAu0BF9SRd/y35f6+RNyRqHr4FAeDRjy7eHv/SF16w327bmQVoBw/zdKvjwkis0CrohCxtKb79z1HRHvWMUAnK/uidmVVdJF4LkclZ93FtFaWtg68r3CXINhwl9K/s3cd0Y0jSRZMiQBmpJmneW981WtFogWpSlA1QBIlqt10q111rffenVlaN97Peu/Nfc7rvTmtN8e+X9bf5/5abzb+jwBBUmK19131SDBhEpnxf0ZGRgSgPQoApRYoXj8Fo1m+ajK6prsppeJwhgBdrGQPtz+SEtGgG7rRBNT7pARXSMfvijXav/xfyj6VKSCS2iwc29eOvzsMEj1Wa8Q0182T7+qYWiNKix+VBKlnei2wbORAark+Y+sPZ3JNjs7Yvttm0+qpwIreS1zJ8xoJs+W0163evZYBnwz41JIguxPbOzHw+sSvT2ZIYz0hZoNFzFQtstWpJ8o3kkNmI7z8cdNGnb3n/SJJJJxfTYTxx7OF5iGbZSz6//JEFx5am+gSuvZlaB97VcloJuHP0HZ7BbfUlt0EcU00mWoQR9LIhAlWrTWY0mu11zHnjgHFkUluglBa6y5/F/2QUifBRygHLY8kxWG7/YQyzNiCCVowYQu2qJq/2nn0buJGvcwxdR2LiH5o5Hi3bsoxToeP7qbU6GONm9y0VMWYbA9JM/Zlsp5pQ2K22TGNo30deSYSUB2SbV84cyaS4OJ6cFfybDh5JtA4H3+B1Oka9/LzBkxeT52GDW7A9imIozRaJg9BWOWPiwMUWqAP2HQ3Ck07/jRoRvMK8icYf0LHn/Uc2nToFrWVHMx1kqg2jQqP7J9JmN1hjsPOWppB9070Es/heP4UKzJcmKG/dyEYBUq8RlwG5D6vWFhMciZ3sNNGu03eQSSbC/O3oqxW7gEpJest1zPki6AdIxwZLdKl5e1b8nvU3X4Qc4dtZHeKwwW+iAwX79+rnIxCpFjyji/5Il/aviUtWtK+gowxH4DXvNXNeUe+7hApdSX6Q6eDj0mCJ3zkqpRyj+zu/DOduzZHx/0tnLYj+8qWP/+deGy17PwLznFr7btgowxw2nuJW9KbKaKJ5WM51u8TCiZfZZeCJGMZglxycv5/A00ov5xkOUgWuF0kmR4VYZRUjn/7dy7yjBhbIxHpZSOlwI5v+/PfZfQTtoruFeHm2u/8FsQJEapW+PPfjfdj7wft4J4eesA6CBOqswFuYPa/Tw4kWzf7UwIPyk39fkge0O+H5X79/oiU5+8IV+MjpkYH/lL1DVBgbEQyeQ0X5JVLTmk9qNKSh+QjMobuRwWPLH7O/5ey3EYXFz+6vziRh+VEHsFxnsVvyl0r297Uyxc/yHgdOyC9yYgBSJOxRyJIMByUmfdL8mdmCv7OXMoPmBSvQsSEKiNYBZ35XMINtzffOJR9m7JvU1Yn2403EmPfZuzbSpYkrJSC/wp6KXnv7R7B6Nf3jM0uZATcq7YMLA94JBCc3XULXDxQjxwOrWm6AefGVLbOikQhCSipk6aa+zsq2ZbpHR6fCWxO9Es9Zu4LEVSj++7Eg9MvYnNNKjBtXyrE1A9lijSAI5mitGuWPt0GMdCJANLYfxT1qUF4uOhYeG+BlZdUCA4cSiXZ11xB1U9foUNB8d61tTGThH8sTpRa+5Lq3XSjzkPcX7/1yJ7An9T0PoqiFV5m44RuCr1HpefynKIEP5HhAydYzcKIziFlpTJQ3qnb7XhiTf4g1UYGj2YmE7d8eQ2c1nuLO1KMERlxmAYM787oBnGVacInBViS1H/0TLThvwO2wdVTJLx7kd22wbzaSRNP0vUzZhSbcIf17WrMYRubrGskzJXmOoupbp9Jtdd6vN0wdCqh9+1L8Dzr5mM0ViWRGu64krv4px5T0FdFKfm848eeYBikmj2PKk5DDDK6tBppldXMN/yTYM38sm6xVGwlUf5TwFco4A3tqgQgxr8V4+NUUy7RhAZDy/CdEJqW68meAnvcW54mrDx3qC3Xo5aNc9UA8UTvciKl1CZoBzGOXYjBhZjJRtS1DdfkVOmbO0wREbtEMv5eBjuObS2Sek+D9zRDYwR/QiFFB1r0cUxm1KBEbZTILe8ix5BTkdnA57rYFtMjFTR24XoZ4YMMYezxhV/w1Rf0mp3qB7JukZ3R0TN0Ke4p8YxIV51nkexsjWiPejxlytHNOaRbNh2DAak7R4ZyNB/S3JFR17DsPlam6fFqVHK8xROmvIpnxQQ5hmGhysXakn4s1jb7inAGmvCdaEPdPpuAVwb/BPA72A+p5B6C7HCvvAebjEtjUFAyApzhdAmEdngJrkFnihg8HdNHsj/uVSMP50EZmyooZX4b+HK6imAMbPVPNnmqzgj1jAj/bVupGxqpoZEbGu2y5sUdR0T28xhvJP5Iq/p8zwPgelfsEhd0u4odFGq+hF15Ebt8CbvcUnv7Khdryxf0qNsNQruhJnaJmNYO5jKCGjKkFLWxivnzvZLV0qdZkqQHx75V+sMFsYcVmXfqFxtzydv0Yc/4uT8JO8R2TLFjKttfz5LFVJCVNvhobBjPuQf+yw9jUp0ww2E+6yYeWYiJhRRGT66EHhKfqmTkw9NcCFRQlaQ0DuiArekOpHUq+YVzEUbAffWHhmSC7GnviwWlgLYw9hLxxBZ3IzIDPPDRU5IZcnL2za4dSYuPnqC7qxke2cxkKrUAxTu0P2UfttvujEraIbjk2es/Mom7qHt7d192YV7J1EhCn4sF0rTLS2GQAR8oIxBmi8CTQ1Vf45S680KOunTHiTQaIHQwpJm93Hg0LwKPZi0ek7viMb0LHpNlPKbAY28Fj6+u/FuLx1T2iMfkIh5feol43CMfQh9owA492li0SNDN7CnQXT3dH/2KnPp+xdzG1XwdIvX5e+LJZcsI2UA30PXKez46f4+MdbH1l4PTcP77A/Z403t8twUARBHM8q8oilZt1lNM1sT39Ce+pAFtLWrPpIJOClIzTWFDgkmdD+P2JorkS75zGDUqDOiHEaOqxemPFI/J6RmraG2JAaMusgb8QjhWuXZLHmOW5u0fLx53vj47wJ5fGNiR39DQJbaf73Xro1syknd8YwRv3n07VuDXHRpAj8tQq/xxs9BHkt6WVBW0jZCPLkYY3B8LEJjWngIIJPgI6NvnqhiRzSK9EmVLYJ2KnKwljbQfjU+QJvFJ3aSaemKPdlzXzfDj8T5gGB/icije0MY8tdGtLZ6SG2j2EzjW6rr8o2ojbJIwKbawHzcxwGO2vFBPwR9p9fvBy1nUL96HRDJTFukUriySh5QgF/lkc8h6PvUryQ/GvfnyfsM92sFuAsvtDNK31UXPHl85qibwGjBHK/hUU98lT51eVertYXTtYd3k2cuHbuMncggbn4Alp9lTejCNR276DnDJNr40vxWtwWMEcshm7ZsFLodoTjzQRloMHq/J0wC93S4vdvV2+LUjB7SygFOll06pDyvnqK0PcXRTpjOzHWozZ0ozZyZmzjQe6aqhJpdWO1LKCOGy3vrwgaLqTVmvkOLHTwzig5391jVZrykyN+IetPVDMaZ9QPhgt/UnnMjiISWqISCzAh2nTZcClrTTbdWtRbtglyUMGt7blOe+BLTa25uhoZueAkBd5MUd3ica7kWwP6EuLdLJWgLmy0KgCirr10tE8ifeqkj+xKuL5M4qkt+oLkvUPpgDmDhcqJ6IVUSFMJw5dLtAooOrufTPJ4/jCdQDriomuGZqkO7ayre+5JKTOCbCk0sQrh3h1BBulxaCQSbKspK2+QlmA8eXBkrSg1uZM4/gSkbQHvS1k2IkOcGWbte4nymo/TxLpn9atZSpdmZLauCk7DLU9v02irsB4IvoCkKvFiz6QzmaFYeuK7kLM4nqRc+sKVqVg01mrTpFj+ciab17FIWMlnJgaPnIU2exNtsmtVVZafFTTwuUSkoZukzdn0R+pTGTGBNHd7iU1ZMg+090y8hjbiYZH0JamVRj6O2LLvIqLYXD9kPGmCuKA12gsPOnX9Red6Yr8/hpF29I3vGwQguiXOOcdSVWW6JX5n2KDop43szzdxoLJGujjGwbPGGHZ8Fleia8MR7IkvpM8pml417HordadJzFMZsT0Jyx3j7rF+faNUPWmtKaMoRJ0eBJwRaeTiYXA88g7dxuLvW3GctDSZzUiVvKH+3sHLB4fcaWU/KiqczFKK/3urv0rUFv8hCWEhWUTl0qRWm7xX0DLd7AZ7cL4blftdGAeNyTa/pjqKfj6kp001KqcUqRxpSCjvvuW9Ibz1fNkEnWi7YYQx1SvCnECwGXvYBxcItBdEsycYdX0ufwbNB78idBz/z7TS89k2rpmc1OUdKz1XunoHU/OKN+9D/3dv59erPvUNLgK+Brw/Q376uX/0bwZb+8t0v82JepTM8kBXmanjz3geZow5cDIbLCb6CwYxRJoTFx210QJJW6I4ikK6gVGXHDNLKMYO0YmqppsLPp3HOpzcrEL5GGOpdBp2ux9UFQw6BtDLChAZYZYKWlGBA2zm4B6K4ClQGoIGOwexko933+fXKrh+Y/Ac1X5tCg9J9d6e8DgVoGcWWOI+ISgFWDLyF0a1HrlRDaErq2lPZ+i2xlrN/bwfUTmSLUOFxfSbUgXvjPlNgNnVn9WC9VGA1aMgWQJVbVwYAsAWRGIIPNAh18zRxI6X514HZaM/Wnew3cSjtAbc5ty6Eaa3+ETEqbMNxgcDUaZrb3STnFguRRW46pWuQ6rEhsgpjagZ9RLTwT37fHfdTMZ92+W66rVU3X6HVwVVt3qlYB2JKgqpakJcmazuCXulsCyC1puoQZKpR96AKsYY9YVTzAZifesNQldK+UBILdjznU/g05UrND9mdycCYHQA9i2UVGoF2ZsR5Q5zI7pOPguKPfuGPe2DRHJjYjSMNmnbmlkfu7Sip7SsNmA8mpgXo7MPRm3tj9G72ph/FwkZC5lmLubzmxlCQffMO5cYkKXYu0KrmV4TVBDRMptZaSU04sJbjE6Q7s59AcyKQqwwNIb1caOeo6mLn88OWzYroig3BRoOaVNm+0KwEJ/mPBcOqb28+TbuR6l7o8vQXzZxcn7Mo+juyL7bQsq8sam9i1YSaHErzRm8/V6L6tFxvKtK09mVL7F+GK8dYazymAnphDjMNDaSD4RjAybN7kUBisGwpvD4WfCM81FHbetEMBvX9DDAU09KUOhWBDIeFQINUrUn11KFQmVx8qHYUpdKSiTmbWwexMMutNKRO9c0M7aoJ7tpLopNtxPzfuZy+S+4ioZ8C9Wua+lMZ3E9vF5f+YueardF8kqV8ZLlLafAErlPaoWxszadHLPLaSr1A6M0pnkHDOutlKk2DedcElmPiU3jXyong8BcAfyvdmuTWySEtCHRtPjl+mJRQBGBPAmOyKwbtKVKMpo+eE2YjKhq1t1Tzt2mI0ngACyVTGOVs6o0lP0T1b3ICYwqOwg56Sx3+8sPiiWUOeP/XpmPT5Is8MimBPjpgZ9HnPdcBjImSxUVZvJ0n/d2JQC5etyDRYfkxJszx2RT+3ryAWMZHAMGIqgSHgkTukKnNHtew+ry0SOCW4vEQMx95pZlYtXByMBY88FsxTJTOt48N4refi80ueC8RmWx/NfZBXNyPJyTj2zTH3yKNJz/ZM6aDRcii4/RWsj/nOwWTn35BFJI997bsGilmUd/p5T9sL6QJjBnixR2GBXnnaHxGy58fu+/Pigd+1Z1OLYznunik9tlznonh2EG8ZfI9bg+ITAEBH1q+EGVzy8gFWpE8mdncC3eTW/LmvYqr+9NPtM7oVGnsS2xdd8BTJFExpyIYji0FPjw2d3xngNfg3tZdT1r3z7+hqvN8YFPfsquLIGlaM5nZ3BTIVqarKoC8ENrfebk+YIpAymYXmdjU0p7DKdNa94SOXIYNv7Te6O8gCNVjVqFtIkM5u7h64LEsLxFioyoLrmmWBlbfs6kcZOdORa46I5Pw9F+MOFihQujF8BRIJc+emjH7U+o0MOgQubIWfUavRcUJSZ/IwV4gPnf/tgJu/Hpz/6UD9bFc2PO1Df4b+56D/SRQuW9vZIlOGCMEg+U5PlRP9+jEtamGAwuDHzq8OUAooBS0FlDZQ2tDSxkKsBJEXhEy2f0I7vPjxOIrnP3gexfpwSv8mzYmF54DunTiRKeJamUlIKssViJ1Joz8hqFxG0CdSunMynechDUUkSEbPNPinWsRdbZYm8yUbzBS6aWxLi6u6AE3bB0LhvoFvSguIdKFwOuyTnBw8tKeNI9Gji34W3WvBNWqlbl7rvcnvxXzlmtCCPZl78EaX+YTjGAPqkLOWG5FbK7cbmyNbcnNvm79ouGpRrbYBlQ5dn3nmBNvUrZHfSyMTm1S0+xBRZWkTrVTf6BOCC2FoHkj2hja3gTjkLEBBkPqcyNFE9w4d9l7T9V1Puk4nCAZL6Lu1PgOEmtjnuKGFtIf+jAiOIdPSM4qumQLiI5YHxsQ9jv54w0avrfDRULmXmsndAAdu6lw3M80WHyYVHmVuYY0O7EuitvMMvIJbqd6iQnsZdRn1JR7xiampUT0Qq0t024StbOXGbEGzFc3zUGwNFNukV2zVXVTa5A2k0vROL7dWa2QCrbaszibr1Vm1qM7wvarR9p6/RpuA65MVjTbBmY0cWe0kQsnFgOu2co1uK2MrevQl6DYpZXJL6ic/GqsFNdeuH+ujV0DNQY0zEFHLcDEQMXre2q807Teh9kOf5tovpZhydiulMNNe++VL2i+XxkTRXlCEQ6kVydFcGebPQxmuqEKavi27mS30UcuLStJJ7EKyt+Sarkx7z2gs2VaUTaW5NrW5KpHrMcih1nLN8isY4IIRK7nbdscytKz3/P+5u464tpIn/SQkCxAO8xcTZZuvmyHYQ/BYCCMRJIERxnFyJkyeMWzOOecsifPmvHviuPm0+X7Z28bb5svm+qr6PSSszfn/8w93v1bn/rqqu6u6+g9XLtuNhzKAChY7R/EC1pzdYqvjAWjMnSLNy5+WGxq8DdA9ZN02+UadbYuHKQZNKYGPJYMzMpF0GzQnuxm4L9Cj8m/nqreh6jlMtoG5Q7etVJTKpVyZu9vpOpNIttjW88hxktHfS6kJD1uqXt1MuoYL5khyYZIv9dNcqM5JtoMHUqFDTB/4WZLPpujy4ArmCAuZ9PIDfe6h7My6VHCqR75sRkGY2xcUfUV1Kuco/JrHdDBg7qbgsXXcdl5ydDyKZitUuSnNw+oyqTT3ahjgTsLN4IoeFtzGNVn4GjA9LZR4wGMG8rUgX0D75OaIdgF7G1W9HFNywsc4ExNYGZC6FK6m5GsaU6R/4vL+C9djXWpo1aX+dhE4WVjSFanfuNFCZzLvnJ2qKNhykl/VAWcQ+Zw1wq51epWthLs1LV8F2m4xtCDTNODaR3zXZ0k1VvurEJEczoeGLmEZK1iVBv9t2Cgma49/jybaPCGIedUcyvZoDgGLqKCM6Ji3TbpmwFxAffxWyQQkTLuGDWD1tfJrYllI/lCLov3aSd1YzHPGuEz9KJ7QY9gm+RpTQxiz1iE2vk0pdNJF/9L41iXKLJp99AurjyqJbYeJSoH/JE85CNMSnVK8Pb6qtRJs3sa4e57V2+asosammxCwPo+bAhJbaN2RQbyLbdzi4Ye7h9tuGtvuvpR+v5Hi352iu2FbTneV7i+mpNgMbukiyqymuwdmmtGNSeZ3JVuqWap+8Pen/Qukxy9KHa6KpzHwUN4M0CMMXoPgKyiqfb7ALeJpHRy8iIVGjkcflvqaUkv6VvT4lL67HI5cuJFNyRmnYczqNLtuHktOp8Q88Fob2D4cF+xBicZrDbHagI015i1XVnE4oioFTM+h1HRRrOgZbWpUCtldCWO4x/NT6YgRN8Xpw4pP+3nyo/31Hznb/eeW+uqvrJBLSaoZ66k+cVbcKlbc9US3YsEYyyDP7jjHbZ3c20N+WRVM3JrED+e+XAzrZZlpCitJaA2K4RTdL2HpZFWACd0cdMmBkWWXZfNYxTIjSZ2wRs+KZqbHRjlIMbFcMaUnZ/ySJKvM+pEuUZUY7UyUiu4ljOGuHsG+jEkIzl7BHTqvYgrXdUX8B6we5o9lJlML/u//2KjKi2Ji2m2II+O8JT0zgxfdXFgavGpK/VeU7lWUT+yfDW+yLIrzq1/nqua8Zs7rHI8HuCo3IzuuilegSZ1XkPtNdvY4NgXtPhK8uzG8KDH8GxKHMd7ws2rZqayYwBWTalDxPDLOMMtK6jgwHFsuh7IDh5E5REwc37rf8dmiA9WbIZ4byY5NHKbCIm/gj/WI6qvwHQcMssZvnky5NKfcuF1UaHBt5rbJz9FofBVJnXiEFEwaehf8s2EqLplinXBe0o8pBtUxKUFKj9i2eZ27ij/O9HiWU9rvsok+3Bmi4gs918HU8w4gHeo67c6ZKkA6zOHsv3jS3UWp5ZuFGcCD2YUSpli/BTu5f9ZIagXouLcwDodmUVLOhnbkGvUTHQAplRlaG7RG/NQ68dxWfcSfBKeS4HQczF9yloVV/g+7a65nyq7EDgTN6cUrdQlM8wflbCUdf/tJPiYPbPtCa46l0/rEurS2BdBbR6eSeGbj325h1rZR7yj4d440esu9DoHN8VEM+GqYDKYQV8J4U51Jc7LicCIxRPXWt32aP4hfG0Jc23HCl9tKWW/eOLApGVfhZFL1FtORQbrIBI0vF098Q+dtVqPecYuPJLZyTR0EZgaPV1Ar5m25RcvURbEGDUuLI1aSBBaRERJNHS70F5HmbGMVLDQXZ5PXX3w1rhpy/NyNs2634syZtfqjRgf8nT7+Xm2Lt944ct6iys8I7m5bs/2zX+u0uuKVUQWAFn+uoNJqt4Kdu6q5bjc2ETLgIjWvWgZQJZmwCFwL+Ups3DUFwAMaaZeROtqSoxajoXLkK2L79OlfgTm7RfuuwZydYtvDjPSrwwgwrJkjgASZvAG7X1VcJX8KXZXQoL0TA7RvWRBet7zNkbL2j/y7eA1vt/17HV3bX2jsM34Zb2EnlPEDahuyo+EbuEGzi+9zgGfxvoCUDEFWyy6LhhvEDcryeHjgxpF1H+CMr7OLuMcjR6fznA45MUinjA9I1LJIa0aI6AgFFXxKdnVjuGVi8TlO2AXiaN8Eqnbu/qF4PrxTZMRBzEFrdoNfTVaEyvycP2NqU801aWQn11N8kxy1afq96bAB9VxlZ1me4pblW6E6tHj3CDLj38Pb2r/Bkc78SGBBMv2B/1jY1lMirVNy0PGf4E0waFSDjPFYWjpMK9+l0hfVYI4ISD4lPH65tfG7v/M7a0d9YuswqsPYb9L47jqR90N1QsIbFMpcU9sSRrUnE8X9uh6qoXmPi+U5pFknzKrLurHBKAv0yvl4ez7Wc8u8DL/PySGeipr27cC3/C6fSdACNYK47Hy9wHYzcDHubEMtnNXChVq8AUdkRaEq6rZhWfZy10043V81smowtegfNvIP/cG2O8RD4bJcHaI/Y71ijHXKdNf/WY46+b/GUSfZSZOnOOomDnBIVuoIVYdZPOzhqDzR+a/iqDP9GWqgLOw7u5Zj31q0bRZ5vkFEaJSbyq0w/oADqwS+gkXIn0BqMZ9cPnGSGQKiejBn8BKHw5/ST7psv3c6l/Nxlcy2I1A6binc97HPqUZbT2H26Wc6/sSeTR2LlUmC3zr6gY4HqTdXy3hPfx45mcLQmdjxFVT0P422UwyMXqh8B7CcK9zl7wllxlvYw16nc+T3jdxuBv4+lqhhm0PWHXzxTA2/qyWqd/E25tA7MdreaxSYs1PsXPih7+FzU77lgArSxyi3vysYjTCGBjpKPXax24En5+i+6O6i7qdlKxuf95lvUkapHmmph3YuZIj289o9F+PuMZZZ11tcb6DRSD8yj9+G0ECJhEZn46OPfqKmLFTn9vtK8EN6NBRMVnvvAQBeWeAHHPsPiAK7Es2sOX3m6GSNbQSandMSKzvhUOFDNAnHhrX0fWtpk8IUbulOdyxYq1S/GvR2VZdCPMyCsgfeVB7fMUxwX/MsjUQHZm3wYi9qY4k47HT8Ij5q4VMylpolxKdtwslX8REWH2EUhN8iO1NRyBkln1W62DsCR7algnaO0w84mVGumsfLmCHUfYTX+DZbhNeX0oOQTJfSmfh8ZI7Nm8MGnQ1s0dmSZCr/fkmJ0zRbPo377P/7uEsadTccpPTqDljQJVKES/GDIgUN5PIvF7/09BvpgazZuw3vzA36TPK+HB1TUuM5W3iSz44uBum/howqdXFrndNjfeaQOdzsvnfAZBad912ZQKJf+C2etvghUPpPCFL7hvkOmbG18HAICeIgLU42/lHUX4YJClbRZfjwiZjD42UGZD7XrO+QxA2FhGkdRTfEpUZvllHIgb8wtTVZs3BZmwFD5A9DS3ownE20gUPbrAtNtw6ZRIL4BflZu4n7VB+Nm/W/f1kEhlzsTNu94S/I//VAxmwOZ77K+j3jB6zbMuHgI/lHxSFTddCNjtaR7cjqXYcBoe/gUyK0PayzqSvSQNhGJe+CdOlCY4Dpz6aMyg3x07zDNIxiZxz0MW9Bm/au/JZKQiAFFiVY0g7SGTYVKt0l5RQ/GMZQGxnrv9xD2YMNW5QDn7eDRWZFkvHPiRZHkEVeje+SwAzJMeRZDMv/5zAoosXz4VXOCLQbfR4jlMn9bZ8D2JH+B7AjXVI5GdOtpOJaR3YoMg/ZEaxo1iCiWpRDGNbz2C4rTYmc7essQ+YkE4j5ZDhMipT8K/b6nD3CSAjr05S0iSm5qKHRz3WU4iRKNskTeL0vrlFYHOve5H86lUkFm9U23ZhXEt1HTOBZAZsU1M5jYVzxKVgY0qUUleWBep9HmlLUTDPyztmuAZLNgzjsTPJgT4bnja0W8+1ZsWbyf5TKpGlmW6qrneAGrI4ZwiuLbMfsjljtM1rxqMEiQjVUxMXlogUEuxEZVa8KWSDb8tmOPegkVYkfdCLRSLZwdpKg/yGtelNZzQ+pWG9q4DhWmBrCUGDv9CK7W2Qp39v2LMmyyLY75uHTT+1O+yhfT9nbeVGi3x9120FOqTnh8+o1g6jJlx2B5H979LHRr0t97TnSiK8aku5K80/tlp8RH+mGfGu2kR/gf6Ss/AQ/sp/rldaqfEk+eKbAHy+ySkr0Rukb0mrRN0zfCJPmpT/4cYEfI3w8boRCq7N8YE6fNzmPcwf+AiclX4HjjuBrcZ43+wvh7rwfPcAoF7a0Wi8m9Ys/z4QL/gl2/+jPf61/8if9Uwd8OHsd3/6TckPdPYOBbgPoUvqfpHwRhWAqwF/EE4f+kt7EJx9Lqwjcj+GsBTngMp+5OeST+w5FiONxiS/xFy3qOCThs2EOT3RJ00aOj/xk2JePqDhtSsjLtPjT3Ko8QecqLtr+ZYQythk8QWeWUbbdHFPdcfM4GwverrHznlKNTNrRet4A5q4rp2Fwid2wcOzKmJSiFnFRKNkNyfTCtltCyVWoMBPsi9I8VkBkJ8CximqAI70oCxyX/y7lV4JEX42wrwbMVbBCCpPXy+TIY8UEJWvCYWooOtuaP0G2e92KW0ONPVogBE+XdH2X7vOoSmnBhoVviIBxvWHP7Sydjehj77MmTwuI7iDCU+JuGwzwzBeSw6MhoxnMrF2lOCKCZ5qCeAp3ipzLG9v0808KKUiSJ9AguAZl6bD9BUo0JUoBWf1Yl2682UdQt4lZV1D2sIkbotXhm0F1xATjfgs3g72+LW62lGv4rb8fM0u6aMY6JxKUSoLScVA6CRqIgwaWElF6rBay2Z/zbKJAzlMgo5h1fFxoVmVmQ7iKxiFGDdfkK0nbMzKTGZSWgNEDVwBVXUcPY5YU2ZCtm+W6avvUBVIzeYfHWacCAcii86jzhzpqRE8NeV0XrLgKzyNKWG3KnptGFQlxn/5Ct4ZVSvX0eFYgZbiSsLzhakPH/3IfXG1g9D+Eq5rhyvCKSxjlpvvfiS5HbK3hMh0iPDKIFbbFz2+Wt9YXYozy2QKx2mmI1f4ViNViiNX+SyDWENlc/HahwWzVlcjNiSjii6CalzhEX0APJesChFtqKOe8YWxU9S9SboOuGP9YJTakdkXUcDHoLbhsoH9rzCRrtb6FyzyRacRVd8sS4exmIvofMXnVsgx0U1+CuBYkrc2+km75OaLJIe3Ss6bJMN6jybD8z2ky5LnWYrEF01zgfEFB0i+7KnvZF040F9al3g2oH+s801hGVaZGaN/IuWw6lUrxwiCQxoh2EYX1WP+Xhf/S8UmzEwH/lqJ8sw/Km6i7CDOhQ7awiWksovkvaDw0+2Oy2dWBM1yXY0Y7sN6j8UCITWHyUY2HkZ7VZJ3ndNJzGoS8BY65LLcCXO6cUw2GC9ZAG9fHJJMJF/1L4/oZl9ZMLuAxVcYYR7r/oMaiqfOSvZZLNJ/fPKuY3kANGd0Za+I6exvn2T4duFq8oK0y0WhsgFy+9ctoJaqKXUgTE4sA3fpO/0TeVYC5cSRrdc9Io90ZacfrdbLJ2nHNhJODMB9MGB8z8/O32tznDcPGa4fJ75jJ8WNmZmZmZqZjDNVf/4zUWskxfMdnUPc0VFdXF3X1SD3GV40K54Wkzf404a7jDd759cn7qx0vLLe7qnEN9+8+3pT+SVD6e8PS3whKcf85S39maukPTC39lqD095tLsCHH9ZWduCnyLRYfbeX7LD4xvGRbBaa+pd+Pbun3zS39AP4frRHwn3qwGfKSCTyqfHQb+kVKmMaLdvgw4E4B/yEAs4K1yOOm3fxththzdP3Lg3V9vnPjXVvWlfeFawatW8PWr3Zs7rQREpxtcCyQa0dILVZ/UVD9ZZPV1wfVnzVZ/dKg+vKwWin3jlaD1Nk1Tgxd+Ct7kA9K0fAGei+O3KjQdGbp6aNNEYtazWr6/I/RA3fc1/BfF7t4kmXR+xW+5gbNjbjhFR7c8CfGDSTtkyFT7fYbJootRtjgf9xkg78JG/zDlAZ/EDb4k7EGfFEHzbDziKpfccu2SUPzCJIksX0BJiCvr24B9XaAZsa63+M2MDRH3ReO+i1T0Ho8bPCKsAHh7g7g/ulICm8Jet0x0ekvAun6s1Gn65tOE8zETXxQffkEzHNGID+4pxHYU8LCCYH9vI2ykAXsmk9ycyuojjdw8+LBRfnPj1wL/MXBun4puwYiZCxQ841HnwjAYPwkArdEY9yykxdUfx0sYzQuah9V2BdNwm5VXV4cjU5fpVyc/9VUDXCtc4FQe64qWlULdvGvr7pU0yzsGiv4ke72Q1Y4TB365YqztHC/a4u6o4sZGP7kkgjT4I3updOwU/6X99XLFxe+ZjgxWthXFa0pxCjWbPpI5OLJecHSj+gUEdV4UJ1zY4nXWZqqrrAsvq4ua+vjSnX9cumUBOfs1CfNUm+0dPjURo84eubByL/61h88+TN7CBbGuMRY61Cv+5xf0Qot+6ff+wvdSMO3BH3/zkLvMaLg0aEOGHNAIKuTsRlxPkau629UAOZ2k07tgE42jCIcn+q759e9CifayPQfmC/TxBlsJDESq8v/Hpgey5Bz2yJYqMNYIHzADXNp/g9o20q/3mzM9N/34XIwyA6gYIVsWVz+Cju1g0JOwyEye/B4KA0/crG06vAezw5cvcKDEsRT+QaZGs4EOVifjSRfAcy1qg/s0Qs082f2GNo/0227XUfphYTRur8b49hJQuoX63xX8zb+qeAh42JQ7nnUrKfgCeG/CPE+ROu07gxKgR0fa5sL0KaK8IOiqD0Hc/t2vsRaJcvVByx4dZ6/hD+vAVZfyf/2YUXOvM3f0SIEavFxRlOBI/uEpqEZqa7pUshWKHJfp0//wjZdZc6IjdvYfoqHrP0PXUyLSJJyZ+CwR2E0d5SmA0klZSyxxbdvy0hRLzN4wD2NKcbfXvYHxZzETUwxlw5WYBMDzF5m7apK7TdfXzmvlMC9+jOaFgvm5Rdb0PiCsoP8UVoE5vKrxdGSWXQvWi0WqTWOkVnp4T1jXkKotrOnUbwlBfoPrWsKXCydXGdnVKs4+GkDkW2CTjMWwVA/6Rp93CYdmV9hmQYdpFMPWG277aab8FtJx8mmYl6OqV+EnTGSmDo6zs5/ItlWeFnAAR0WrLk8ilcoRk2YoAOvzH58fEGfZmShDgN4XMK7zSaO1m3pKQtpB6pxe1sNoGIDJT2CWieo4XUERGcrczqlpD6pimROSXydQupreg3XTnKEaDZp4bGibTqa6Vg05hrk8F+11GYLuBzda03ZiG637dliM2FZku0IukgTIIlEs36UdU32wN8ZC7/+sn36rnV7QMJF24YuGgkzkrAtqREukvmamJ7oNSSUlKsRj5NQ5hErmW+2dNvkKBzV8oBOZpvX8WcUIm01gse0a5HpVgoX1NF/+cOxP/GtE/anjLU0sD/xLQexOBjANSYnujUwORAy+LXvgEIZGZ1/mzA6GOWwzMzgI29g/n2qgYFYTxqY/6CBedy5qKG1BD4MqYzBiFKMIlwu7zGY6hf4MQo2t0WJJMZwIA2mkv8n3SU1E3gJ32WOg+f/NSwvXONFaY00XtA7u67fYHNGc0utGTg0rhZM6eb4yFbwaQwU48MU2QKOdxwvjm1DFvMP2TqZ9v4qMtgXiT2t8ekWPu2gcclLJfIK8+eUnfOg6g2uMfF5fqe2fg81/xllt75nThId1QSzTc1PkA87jrBb0+pxZ51iPVbiGZA9Ps/GUW25XJugYw15WKgNrYHLW4wJwrkm+ogD6iWAAOpvwFj7dCydfgOSGy+Dl//QgyzBHbRYhTV8POyCpr8yXgFO5g8lLI3a/EHdZlTyN47eEtry5NVrDh93rNhkCa2IUxxhjvr9BxE7Z8NsV6qoQYk0fBK05BXC032h+7GFflKxmCEW0OXcGeIkUI3YcpHSshfYiz0PCsrxHQIHXdnT5ILloj9kr+etNOsO61rMgQX56gjt/SkSw6PiQ65cAHGMmj7galNQXwaueR5yX1XkWpTBuYmkd54XTdqQp0iiCrBOsFxXc1uRM+FasNzzhmKWSA4xSzWDBtK2HtIzEPmHjfkiRR5X2drZcgShe3JYXiQQugRhFEPvflfjh+UxBGeJWZ9YdIlg+4CYJOYLUJX39SN/yjTQFCSenkBCR5dYzWoRN+E9N/wi4ww5Bp+vcCvGbSv5h/Zwm+4RQjNVq1veNzP0lz8D+EXM0IntoLDEjEq06bW2GU8BQmeMduAv/0gqQBsXKldbtlBoSRWHOvC/D6IDj8jl/9/HQ5efSn/k8uNhg8t/8TSXv9q5OjgCb/8m53aJV1e+iMRBXjOYT3j1RgiVMdRmLPc6Iso8G3prwW6LbL/A9ososPYLRm+28NYi/T3nupPxtOaVLw+j4Gloq/atZcyLPbXJL+Cdj/z/aPu4He7YNr1IJKmxw545glsB/a7/6QW8BM5w7QTEkuT/bxRvcw/QocUzgRRu/ZXd3sGVxiB4fCdlA6TFLieMBKU/5l1yiPPx4Xx20+5yHiH67taReeBOQVF7ssGfkYn3msy0sbHA0nXItZgSfFnLa2Fs82kThQYP9bE6gyLiTwUbp0uHDoyvhQU9MlICEKFo2BcEb6DHYFEdBO0siS1BXf6+gFwJyRW4L+/nEv6pc+11yB/DclG+/5FhnCOu/UVvP+tURCowVuKVmeEAR7zjNsZjzhz2YKStkYqXpJcJ/F0nmiR8Qwt9mt0JDYiTGEkcvIHVxvXo3pyxIsH4qRmPZGwn0nwV3zdxpQieWlpi6Wu3FAy7514yLMSaKm9CCI9IbbxrQm20Q7XR3qA2MEq0TjfPNESjJemGIdqkZM3fDai11kTX0JP1nKOWcvEtktllEiMBLmcMlVOcvwfADqaRSC8K+Di92g29bmgi/Bbhc0Wsq2GMS9E1wS30UZMy5npYC1fH/hwqXL1QY0HDbhM0zA4WNMRUj2yhPjCxUD5cKD+xUCEJP4jOh6vUAxaMx0nqG5KGhybdgx6acPa/5ttO40L4H+7xOhRsilWRmFdVdOn9ncC+grnCABsDLUwjYTmjREQQCakGd+DA5JokPBuV0KNWUFsZCRp5pG2Nw2DU6hz6jafQbTxBvcbKmwMY8W1W+wpHbFzPyFoqHYR1/8airLOS5X+LHBfgBHzoWPAaIxybaPytZw4fVUCMFwDj+svMgMlfd2DgCkEMej7SCQ8OXob19SZRtJqLtKG5RNTmMRL6Z/BIGD1qU+RiilxCkYsa5SoeyhpqcGWlZKzBcUuTvte57ED2aXHcPm29sbFPv/Utr/pNE8fde4f2VqM7SPIiQZIVXeqJGarsWdriVNLGmBFghDgwLEVm9uw3AVjJp8kJZs7SfM/ekTlGXMp+qbFjPjHN8tahWb5375hZvm/vgc3yta1aJVOw6pD6y0qwMvLV3HIV34bHzI7eTUGrolAK4p8fbWPSf3Fu5kAUzA9KwYdJQdKsQ5olpFl3Cqlm8FLvVFLR8j+yl5a/bbaZ/nuCj87QiQ8I9ug4wR57DoLd45zFezVGqZTg7Et6dUPXUPkahzNvR4dSa7Kpouz5bSFBmtep1OkZ4igeJQGLJrm4j4xNvH8ier41jJ5vnYieD57LJkbiB9XX3WjdovyBvR9By/jg3kO2jGSkUI1jVrUaf9xFUMfRhHmMTRlDeBZ0e8bTpkjaw5hs8wP0HYnRonuqtyaJxKgEK6G2y470LiGI1Hlbh2Y2FZ4wPoT5pF/notCoHPlRXxmPDvskhnH2Qyt0aegMALDxcAMbkaZJ2CBZ4AF8RHjt8Y8ir+39SPLaN32K8drLP6l4rSBhcS46TtdzGro+r1X9KvgQr6/vBle+HsXHVr82pTA9WaetrOjo3yKK72BuokIH1Bf5MYdIfZL0xYZ5/VIKGmulOP0YlFHPNy9tOSQueHcLbpJCSH+76Myu+7V43a311qO12vb9QDwo201c1zbf99jPJP9itXijLvLiyuAXq7nbJFn+RSy56P9rl8putUOtKcN7sTom+tbIUzqhctYQLVPzOK+273GlgyKrURatRo1bLXr262QS6ceg+gn0xWbOV7tWi76h0a7+oGULf3kjuMXcKJvjfAhnPJuq9et7wGoNK/jjRZ6Kl/zCCAukdUAhsYo5rYCYzmmdJAww1McyfbsVpOxgbfHKpjPQRZYSCa2NwING+axqfUavFSAC9ZEZBX4AswgwSGWm2oEDmFmcMoJsOusIk9+sBZFOdVBskkiBc5xlsC8mn2HSwUxt4JRHYHyzMsHLh8LwZy6d06OWTU7T/fukw5x4eyxyyoVvfjJ4k85+V/Mdrc06WyzqAPJhVh1zRW9OPZN0GUqMhYAGorwi0hqU2TylD2r2tW0Pv+CUgf0yW+/00t3884GXVIsyM9AvZ1x6zoP3/Pxwdk19VxaqN92BFl4WxF+9VIJ7v/fhS93ape5hRercK7/30vUH7vt5Jem/3n71kiZvvOPapRrOO9ZlHoBHo62h4eu716Lh4tVLxRZEXCJ8OJnXU9Ol4iiuxNHVC3XUYrE6A8kxo3XhpXs8e10ulnhv4w+QT7skDn6hY6u0QdxtJAqyx8ks+F0XZkSn0oN6ZNr6F1drZoKCksyWFU+Qi8xkQI6T4R02bVvnjuSS1zPe+eL9T/ofL+eax2r/E0/CRFh0qGEFmdtXTnTJJ7p4NM3H+KQLPulLAqlIQqkgn7T5I4nPgc8v7t9H4KQBmArkIlLgoVzm89earW2A4Lux+99SZ+UX9hvuT/py+48/AcLxL5bz2lJ4RJcBCdvcmmVAIsfcWurHLbp/pW1avLUoxOP6su0WbZL5sa7arTpam1CqiiEq//CSb8AFKdvBytsrrzVZzzXc9hLJFSWU4qyyqNzVPVc3NdnU//1meWHBbF1LruvmekE9GkU0afxKWv0FVfBoUiREtoMCiIcVVM4S8dhIDXR+gMUv2pe9AA4ghYAAxtVgdCWHvZ2h2qk1ij52qCILL5ulj7Xv29qX9s5xG0W30LIXfirG4sOBOjqQJ5ocBANon+mrJ0etalOQEyY2JDX4QLY8IZ0lEh0w8qEG+Zpey0zBLKyAJnanzypnJhkXAvt/DTBeZ47DGmRsG4cvPJsNl8KIybRbp5mlnZv0jzaliCgp1qDxesC/BxolRqNjpU+wDbgO+6xtuF2tM0YCts+0ushkniYDvUdd0T6LteOSPhDbPvitP6VdKjgoypbNZvW0Za3IYXk3o1C6pqJLGx2m0YxlaGPGrVvwZMzb+8hYnqMPYnk2H9Ts9HQ06Evp2xvy/SJTbI07ZIHKJdB230CS28w9Zj6uu6gv6iXBxH58QpV5XZ2ZYl7HGLWzGgax583fscwzyQ0jFl5XIvp00kAZbZUA80qAGsCeO5RFNf3d2/U71+Ei+MCQiqcNtf4j++mre+9QWCVi+Z0D208lpCkm4mpZtwrSZCaj40TmPMkk+0Fx49FOSLkaHiB0wJGJOUsEYwYSi++1AHxuTOPD7uWcdBrodM9yM2FBGRkIoDoyFw5MZqJABWir6c4gUI3giy83D0q4ni2QZZr75u2009QGeoETP3OaJEBnV3btm3oIvXG5gAiD3z/wqj0Pt4yNNwl8SgqGr3a/uimnkLD04aA0H5a+IihdXB7JkoAUPSifRjUnFKK+CREEaDoeAYzuxEWP78CXuUdStQmk3mRfsIIhULcV7YaWJe7HrtXyLj2gN8wKpWYVXTVW1/AYZNCIzcHrZfNjLenx1Oxm+oTo3zGOPvpeM857BLoMNVrTgjQEYfMm02VmBPerxu5lRLAzf5P2LZZAkvbp0Tscjb4rPIVG5ccmCaNrckFEsuZbupuIRyW1E1ejsqPBYGeTuWMjKuhhqjKmqqT91menFc2CYa05wZA63fAFsPFZdDP/abRkY2br+OGKBdhTNIu5oRLU2jmFS1+8aQisQWrbEGv7cos51WAK1UayRZlinz4YgRis8Ji+Dya1k5Pyhnl5gs2kNFgnqtddKrgtVHQ5lN+JMmcQJVHwJ8gWPtRacEsB7bgLuspDKgMHE6OGk0tqstu2YzT8FhsyULZbmvG4TkYCMlDlr+MQhD192Y+3Swm4JpoSRtg/pfDY1qewIJUSD8nxF0a5ONR+wIE7HRewrnxTUKv5LhbkB+LmsGV7laymf+B9tMvXPysj8AOl9bOlv/SZ5k/rvqHRfKb1JVgcPuPP+n1FVKVa4h4s4zu/fSDxpec+rK/4SvxZS3xxihYSmafnpD24PjDo0vq2OVi9tsBsmIIUL+57H5To/p9nTV1YOe36vQ82OCX3SQfG+342FIcH8Wuax3tdg6KDcbXLtT1nQ1+veRVWibRFg7xG1Az+kvgR3PshTiDY8qB0omCuXsIiuJEH8Cx3VwHYuLG0La3kOFGwDP//nqwyMzfngMvMzMzNldtQmTG5vktKsg7LzE2cu5SZmZmZm5zf9+3aK9nPZW4UWC3Mzs7M7szsrDdHAlyq7fKNlBmAISS5QwgkwC9lUDivzsxIIGhqtRvhmb/oaU8+pLLgGWiERHIqJm83f/v4QHf+8wXMTbU1fzc8L13bWPrYu+/Zb8kdXk8Fefqt2OoXUsO+Fx8xk5bkYBy5TZt+l/wmG/heBV6X2mXnuXa67uHGwEtkvMr0HIulUfpOdhfaGvkIXbzAk6zvRRokEyXw4J1YjqthpHDFlAAMowhG6kdhCMXbkWtOLQxWtHRtobZedU3fixWgDACiEmiAyoS5EGgoEqvadqItU5GWjWVbNsqWXWhpOex6sxojAqCyKQTwclkALysAnQDAoeiHg7rttE9kWNm1wbrXT7Z49vYnMe/nsc74BayzHY3lwHdPRbDsttb462AZd6Ro3NeN694tKRqxTbRoLNnV/sxMQ+TPvb09U86ufadENHQu+SPAnyon2rIp0rKxbEvF2Q60rCwRdOsXCLrllA6AhXMOhQL2cTnZZi7RsIBGwom2bIq0bCzbUg2gHS0rfruZitMnOF6lBuHGMl4MfSCNPyryE+fyJ/QyqhXGVdNix2W9GLe04mxiKlT1zpkuqi8tgtMyB80X4AsyVAm4IJSkKteiJubCdTiHEtpYO0FJKmVMyw84z3Jo87uH7Y1mRn2vDApb1K9uMr/cbKZGoxQlSxbsJ+EAeR81IBSGZSjC9Pmpq/DPW4eBSBGfjF/AJ8P5+TONQ6xwgQvHKfVRRM9rFp6UospnTbbeMT+CGEaAjIMOFIufMueEVQIUV2YgGRmvHLxuwNP2xKpbcsAKZ8OtVAgrKATLfqat5c7Xf+xRKwUorigCK3FGBtAmS6x/wBhE6Rgoul4Vu14WH5DK1bXhEN+6vxD/YjBLr//boW06UZU5FFGZA2VVplrRTIaJ/5YD5uKiD1dbzuR4nDae0W7QyjuqzPEXJT3uSS1qSYRF/d3wxJzYPG9AD30qNuUtieoJPBG4Qj0BUun2Jx7aeuVn3mgM0u+dv8gpb76x9aAvK6Q7Zly9xWv/f9eYIP3ETtPm9I2Fs36Qnvx1fUNDw9EpH+m1NuPXHcj2kzG1/U0DN5urYNc89ndufjk06MmwQ48YJG1mJCKb3xY81VorZpikBeoRzYoC/FRA9uptfjAD7zYyy6OOHn4U9UwAefEzwNpywo3rmO4DvYM5ugR8IccAeXQWngtC76MeuIwWZ816H+B/i54O22jabPtO2zzrj86C/MdXPGnwnW+nDgTp26++buDCD5NjfDQZ/dQYrV5XDmtS6vKNz+/eoPOcwdGPmY9zd1A2+GVI8seDjE+qij+SHv3o0PwrE4QIqrMf4J1TfA3ApYZpYpYod8fAzGzJ1XEuXJOANErRHFVyqRV5QM+P9fu8QuaSWskuOezT/hCaBLuq09E+kNKZ2d2oRGOh9lT4sVqoHKXb1s/5APNsbvnmvCkqMKUR1edvTuvQUzO027hV6MHm8omvu6KGiGfOzcMTQIGg+YdLAIYdsVc2bA24NiSN5vsOS5pcTGNog4rq66tcjEQJG2JLm4cZ0ERiMpQTG0d3tgX87hhyIJZ0h6c0vzo4H07ZKQ/ywmn9ObH35S3uCa51XDakAGd9VJiwBmWUujvw2KxHUXZ3W2PWryhlconG9ueNXsL3Krl4Y+X15fruikwETKzJnwC4gllsVxF4FMYqt4KSWIV6F915+MOV/cOpgPKH9/TGY16a6ZPpMKheFPedu+vqd6X8gCJYfeXhZ/z/HW33p7bq8XrnXevRlJQ/5Fvf/qevr++ZVI+Uzzfy+V4V5bKKcukHGFqIPbEE34OPFh+x32oMfN93clE+2/8APivmkGc7XrThzOnHFM9+DfsTJOCsR933HEBV+mAguV4leZ74aTx3FM+d35HnDnnuaJ6HKGMhXn6RTxo+m7FVY0CM/fQTl/ffu2LvrZL/vpO1baOTjKcAmE1l2H9yU7ti0kXTDcUiHTiKcoRc0FZmd1d7IX1Wd9fWNSZhRgOsWp64xEVA5sDTmAtgWs6SphaqMgYt0xuhLFwfA22nvtzenjSkoH0Pq324XabvmhkGjAO9ZoL9vmcVrBE78OJocd8oSfBQFmpDUv6JlO/a6eoXxoEb96QYqKSucW3JvCVfTE+Yd63pqeMfvvKrY46+MSU5N2W1PaQ1UqACgOb2vKr1vb6bAfTeJxde8Li221LUOWCpawNWXMLarbFlImyW7AOrPXLIzBtfnwUsVPAqyPC4iz9G4OORQmdJqTTlr0w4HnJaRnOiPDq9qd1LtCxG+zDWxs81Vy4ihhglchPSapzl4OZZDrnRM9OxFb+d0bL4mxijZ7uodJOsZKBaHtLhx3ZkZcEEFGRcwpEpCL/P4GF6yT3u6tnis8WlANpU5L4irZk2CihKlAOq59Xey9N5myU3ytPZ5MS5O/7GIaBekG4wPpn3WtCco4YAD5u2WsH4I91NOsBafCBfWqBdDlbtL5rNuZeyx1kqfo/V5XWxQbGiZDsleKiBVqgcjcDKYlPvBmgBc2MT6rTA3X/WEPQvZwx97OhMKbzc1OJ7YmCKvO/V5LHyj//d5lkg5bUgoLwZOFTmN033My7KhlgGu5zUVNJ88LYniu6nN6Mnbn110qXXHJui9eRbTyX2uYzJQ+44JjeQfZDJj1aSzERSBkAOUUFt53HTFLjjOO+vqyvHb/OM5n8fyuBU9HGNAglF80NP3zJOklA0j3/9ji8EbmdG8pxLe0eQNOWOIo9ujFSsUxPXG+Cq8ji55SZvlOvqpVg2d61dI/iqrna+7rXsuQDNbRcF5G5C56lDVQeEUXuWJi/7NPdJCjnR1Q36dUytcslNqV6XcfmFzZseA8nOGUFraftc41mtsbFLZXE3IeZM6xmD2eV6PbsnabHUUk8vJDfeOuvGy93a23rmJQuPOae3x4v3qhv44z3jXLvnHNUZ0aWRhT/1F5KY7J2gLCfgHQclNDXz5FOE2UDJHydRGzUoz/VbzXMcCkWWcK099uF/FbNKYgfoirED9g4lPF5KosW4ga3jBge7YuygKtBhA7Q6mH2LNqjD2Q8eq6q4BtLQmCqJ0etAwV6upQIFKCKGFktVkECBGSsDDJ4N0AAuowS2jhIcyuieAV28pwspalsdV4q0DQJbFSIIu3UuEILTV7QXxVyMltRJU/5X9EIfEjUuuXP8cZZSSNOff3qG2FKqiGvumJ5DUkqfshtgVMcJPC/7JzRhYyk6kVGy0ZKLPVG/1olD2KcVpQpt6BNCLo7ci1Lpoz1TYmYLZsw4ZpG86cX4HeYuBdEfMfNHh2/0LLR5mTMSSyCFMX3oqkcs99FK7zbSBikSyIDLgXrSD08cHLvXCrvDh/lkn0fvaB64FX5UetEX57ty780bOMt7Bgbh2exOJ2qM8smQm4Eq03aKa2cmuCLjR1F2C/eeqUWBlHGqkFF/AV+dt5WfL7DQmj/Xz9fdUMhbYIdJl1/n5v3+iDdnAVtdDGSh2lyhnnIeXJAu+GhqbwAAXEumyvl1QbrgyVGHhIZJt1SU4gd2CuKlOwWW2imwtYzGw52CX+CoEuvf21G1g4wcpfU9nrtd4rlbv9Zzt+m5o0PxVyYIETT/SIokhd4pEEU7BcJ524pzReSPwFwLZ5qdr2JS/uJcdoGqLw8PJ/L3YrCkyjVZ4mS8ard6J3liPoE/LO7TC99OXo1rRl9rx3p14coYAyKT1YTbGc6d5k9YXAtNMDlplimpmds1JicNMm+nKEBrstSLfcn8fQp9XoPun2jWF73VSUUU7yvKrCh+rSp+dcLXnWuE8wND4RfQd00+yDV1LlB3DT7IzQ/BKB4C+Fa+dhlSRIY0t2xcpk5DpA4wTQriVEQ40tmRXJc893UDBjPIcsnwTCS72rWTDNu5Ce4/x/iHYY9qvtla1hznticNU50Hdh7+L2dWDXU7EYQXt5b+DO5e4e4uDZozNzub7HkrYXZzc4PT0VLTU9EXSF/QQYv350CDdW8nm+f6y7Ud+b7Rqz+e8+I3eEH31c8PHvoJ5ot/Pv3hsvTnev7/wT/otis/vum9+y566/K7rv3y0/u++/6v9z67aFjPn9+nck+QceMoAQUNOUYgZDcrGOyOXAKccBYrJsByDREMoy/mM2WVoyPG0Io8gy+SAnbgMGLuMYvXAuuQO7oHiryAbogZs40BIgNC8ugKEkw26DgtGOmwMAZK6g3iYAtyIrbluKU2R1Y1FKE4bF04A0hWGzcW6KCXg7EuE68RHc65epoCtJe4DE3EUpJ0DEw0hS1KpWBbqBYMAy56T+4eSLglIfaAHdqg7l3ADhPUYt+8xFssGTtJILYHkoCI30q49mDlFQJbgDUNuVcb1A0y49wEmhpHoVuEybZNymxDp6659a5yY47uel/oBDH1yANYX5jTPfV0/2s8knp3RM2YR6ZD5fZjytBHpwt51+ebJQzaDTEVm7XE2hpDDJu51nVpCoJB6ZqY31lTlanZEJjROaCS9jzJoJXiPEnRU2bb3gxTb9u+wJQ404LL2NYOjYW6x1RQAtXkXSkZTCiEHKcANsAtJsRbaNfSIE4JfNR0dP5dhIKFJi+zQ5ZlD1QrtW86ytl6uv7R51589Nnm+RdfePG1F194+tEbwKB1pNVxg6RRqqcVMGoQSqrD56y3WbK+4/blT/QKnn9E1RY1xBz5LMKGyeYePKUk43HlNelKVWrQRNMwho72h5DmlMnvMYZqfY2VJh4LV3xBZevyomopZJnusS4d7mwCzLA+n9i0DACFOHYSlY88yzaC2sI4QI6g2uhGH0CB4eiPYFgJhqnO1TElVjCRDGW6+dQWIWo6nZ5RWwtYl/LUduueJojbwxu8KIYeE9WHR55QpLA21WfBuvu4PplVUod+o/HGF6pOZcaQZIXMGJZxryPm8SCjdgEWxRo1ABiTsLsJCwVpUISBg92EgjQsBnEJu2slpZcwaJRuLMpZZulGYMEEXMqEGcDA4vKvd4fnfn+zTzHzTpxzmPNNHvlnpBkdDvnVdT5FF+vIUbuTR/mr8n30b3rQQKKgd/0/iQO/DeiRTtDEJ4/aHOYv9WfbZyW1JIX4v9FHS6MPiEafWDEEDzeJyYJp0DUy5T9m+wAX49f+M//Dtp0R5rsGiRJY7Ssr1A+Cp3nfQGj0V5k/6LruGcE8uGHNykc/McHVPeIiJgS7sYWQHOK9EElYyv5nHgNxk20Lzp1tIZz1c1riD60QuA7i3+W8Mha3EC122dHd7m9xwVka8fPnbloXNhM87bUhDksmsgUzEWcsLfa1aSZq3ffuVHgxR5A37+u/nuzpqTixmdCY4tr3eXOrIH4O4jsdjPYmcglGqIFn+X1JwfqxiDPvhLft4BLBzLLmfaarBM5EXLKjoPN9E/FCNjdM/NJqgTMQv9E+x8y7iYDspzlzq+eNzXUQP//016a1TcTZVwfWrDSbL8hfEvE7DkV3KhuJiYbv7PEsCbo+aP5paRZ2jUR/sqtKuYQEXZ8vSP6ZP3wnNRK2ZpOGS5NXC9bnIM461bkyroGYPuHLVdJxqsBjEW94FLpKp4G4JvclOm99Pz4mZyKuY+W8MP8p4YWFpckYT6PrgzijtSajv55YmeUZmbtalq4P4v0yLsLS9cTMETDUU1hA1wdxjp6jlEUdscS++klQgRTdF4jHhlcMBdYSqu4x9noXpMfmvM9IfeROexbXEIG5vkrZuosEzkGcw9St+lxN2LLq4LBuASbYJuLZnRL4imriY9H21iN+q9hjcibi+l8izfZXEV3NRRNfNsrQ/Yd4g+TR2GuVhOjP19cI9mj9EOfNHO+dVkGY7D5wkvV6jC6Jbn/RuxnPygnbzgdxf3XPpI8/tD5JxxVHyoiN+jNjtkSLj815g0j+d7t6VpcRgebCLN92SYFzEGfWOMnuKyWw82o2RVMXaI3JYxFniUv+PlFCaBhK7/M8P0CPb4j3S3zff7OYECk9sUDRfyVdX8QZCi0yuUXErbhZC+OZ8mNzHXT/DZevPucQX8zf37jlIKY1JpdEnPdaKaiXIAZV4iwMz6yi64u4kCy/PwoJjN8o61RltMbkvAHk+DUPNLTCicmF1ibGU5fR9Uect1vDObiAqEw1f6+2cZXWmDwW8VilZ9tK8gj7gwr71l6eMzZnIs7o8WnqzyFenVKp2nB7NV1/xCUng/CSx4SxVbmN+XgJrTG5Dhr/klvPNz0k3sz5UfvKat3YXBJxZhy5/uh9QjQu8KzV5bl0/VGfxVEUyyKCAta7RZvKjc15/YgvOtG2OY3Ye/xZz0XXpWNzDuIc5W8mp5MI8u6g6vbf69hj8ljU/873io4jUv9e/TV3/FdsTM5EXOj89AjXGKJb9Orl1cy17DE5A82vRXhJ/m1iY+LPEEP/NXR/oev/zk7mBBKRidxvl8Xf4GNySdRnOsrwrhHdOq+mQeci9phciPb/4Tcm51CIe5+ZN5MJ72WjwhwrZtL1QZwZYnJQkgVNQ52TzVtHr6/Q9avWrNp1B1SnmikXxMrQ8SGu887bclMsHHg+YMGZNY4+PkhkffnmTNt4WDPMPnNq/jp6/4hzYuamhibDldVmDTcv0PnroN5Wd6omHYTXvNgxaL+Yrh/qkzlKHzPhkmaVnvas6QLn9SH9vb1R8/Z9iIiedtBSefT8iDivMekr+yE8132dYFVJ9x8D8djb+8w+PAbxZZbYZAc6fh3EOR/FuEK5oNwXleIv3osJZiKuY2pppZIPr3awNSxmraDr04vEl+Ff+dcT6LEfkmWy5tDxIa6DjzO5gQM33ay8cfvo9SHikmJuGysKgbftbZY9R46OD3He641B7wkYFrur90x1dHxHXdo1YEERDArL1Z+npOj+/4Scv1ZclU0tAtUw9a0BSXR9YhFnek61aSyGu4+u1zhFTRA4E3HWvOzfR0vA++SeFckK5ZggPsSzVdy0gkrhfM6w4QU3enyXRP1ud490GVRcceh5r0Lnz/v4r8/0K9Q1Lofz8tg636ej10+IHz/jO7u/HDqkInv8Z43+/xHX3+rh710Bk7YEHZ9pO3r/gbjQxk9ZhZXQuO5DqqGWMF1f1Idazcyq4NhIrMmaQWF6/EWc54P1hVSDg9RB/S0n6fGF9wG5/jE3fqFUA6kd6br+alMFzkGcp6nu1VADObMNTUv3yNHxIz6zv/zXsVpokr1VdrJ3ABfEjzirOVvrfh2oZc8bkhmRoeNH1383Mv1APSh+2cSQnl2MCeqPuFBbd8bXepgV8OToPKlqXDAP8eyHTkvDnoLim6nVvTVL6Pq//9dN9jHUTzRAkG7f/NeR3+nxHXGGjZ1caQN8+IjN910oTR8/iL//c3w2wtL+hMPTpej+YyD+Pb3GwrERrs9PGKoLH73+RNze7HAY0Qi57B0GfYmj51fE86Y7b5vbBB8Lthe0e4kJnPcOqV/r5f7CJvgyUX/3z0gZOj/EGdyOgblcyMOkuBc76f9vLOIzC8/aOXKh8txAdp3LLDo/xBVVzu0v5oIFe3KOoeZCur8Rf9+y4tGiZojisXrXd4vQ+SFeeaLY/0QznHlmJ1ovrUCPj+j2F0Tzqpoh/oXYEm9Jebr/EY9VF85c3gKmFUeuHy+Up/N/ixyflQeGLrUApWNJ9mVI0PkjzjB9w25pgdaj8SIyU8TYgtesdjoCVOe/Gv/zXOEsoaEZjYcPTWWz//l45w1ghoKXOkGyC57+eS20oCHe7s9bGTqpzaNfR6wsFXww8fjL1H++oajV397057MKdw3dCN5zI/iv50UX4sZiPc0ITE3lV4rWNwosW19EzmGcwG2Y57TDeylotPWaedGKhXtcc3k/r4uCOd/s1PY3+WGnPeZxs19S8DPgxwpmvS/e/q1trWMDBTaVb210hxhYZcSZhdsqKAjjqph3x7Ewt8/l1dqFFDhfcrNMDL+NzfD+4WTymILf1HDw4scB2NCOk7LB6fz9RSoc1yrUxu41cpV74yiY4sLyVp3wF76E+3eWbQQF09kKMvsP3sQNzGc3jAuhwOijrh/F1MdrlZw4bB8K5n9pyV9RFYTz5FIyw10pyDKy+NDFZWIGAQmVdy5SsDMk4eO8JUz8ksEVLO8kBVrK7Ub9EoH4R38/9R9/UUAcmAN+3r7YmZpjn8wPU7D606yzkS9v4c0WE9155hQwFDS0h3rDsdR8eyUvQwqi1D1rXN8F4ste/l6uv48C/5LErZuO+WDP/A7d0NxOwZWJ3dmTLjKxW61XgnYBBaHJyV3DAbcw9UNnXC6q833n6cGFVl4YJD7Qq1eiYPCdxB3ZHUys7XLn0W2yFFiJnIBLebfw64e/drxZSYFSmqhzx5Ar1tEu8TVKnF9/4tjiCCktnPXyVcO1hRQ8Ept60nWDLzZlQneix2wKAmvqvYPnumAHFbRTsqZSkJOWve/MPjdsXq6S2N+TKdh7Or1z3GZPTOnF3t/Hx1Gw+zvXcmNbIDYy/8gDkd8kTDQP0GTGeeIDMcHWZd9IsNffU9u3OxivSdHYkDRAQoCcwZLvwmG47YtJzpm9JDStD9V+33gCH4rpUX39joR5S+ofLloUhvckzymR6yLBea9M0s4YD2y56uy9ie0k+DisuciYHYIvZaZP3PaKBHPvBTsDk0xwGfkhKbFnJCwJ32UXse4yfjtZ/+XXRhJmpRcz+g5vweS8bRgi9SRQRyZritrewoyFlvVtqibhwoS7rzpqXbAGrOjxvXISFGfPgICREKyd+7xfpoSE7KyLT+pZZzFpmfUtrwgSzvEMP7GXhWDT2obDHuD8fOJOCKmGBuJJ66LOPsgnYVdcSGttuxe+2fbpvVc5JFirz2CXt5/HXfWiDso+IuGbxaXe7bM98RnBltXx9/nrPx9eOEktBHsl/Xj9jiwSJkX4KOTeuYQNV9xunp1Bgqjh0s6OwyxsreHONuE0Ej6WL9L3qFDFcreb+qxOIUGNc0T2rXIotlMqY96xJBJizobZ7O72w0Vbz+Z3JJCQvI/SLFPxwz2MNLKvxpOQ+UHW+/wBd1yypFZ1exwJJiYHz7fVh+Crlhu5qt8j4ciiq8zUmcbYqZS9zUZ3SViz3IqgHobgdZrXbKNjSXDNV/XKmP0XTryacmY2f5pMcc6j7A7jCouPYg9iSDC4wTPUamXi7qEGP67wp59qm109InEeP23d+/4Mfzr7ii9nN+mJn76esDOcP+3z1khceZEnXmW3+eAn/jS3WdSqJpKFgWW7ngN/+8sS9uW3Kl/CvcZ9OjWXH48jx85wuDcUUy5SHNfHnzZyepbW8ekodkj36frP/Pg3P32oUHb3Bj57sbahND9f1Q2aAzkOIfic+r1h3vx6iI8s0nC3YuIZFSu2L+bXy8X45Av95lC8L3hrxMtkEoR8ppvbZbCwMFuflxWpJDz62F+kkOuPvY6V2dyTTsLIu7JIRs5R3G/r4/nKWSRstf5s6vbtErb+3LywzPskuGmJJ0mIhuDlI0FTzB+RsFbcyTcvxRLvKavL3pBLgmk+6/KPFU74jP2VNVsLSEj98WX5li3BuL5ue4wrm4Q9AbbPnao98ALh6uMDHBKk64Nkf2edwFj9ca5BpSQ8OSXWodbkjK1Y0bXocCUJh5cfWj6xzAs/2mN5ybaWhBalzi7Ppb6Yitzu3ogGEuY9wbmNT4Jwy1XaDya0kNCkREYq1bIwk4eKc6JfkvDQ7JSLu4M7RgxfMHJs5+cbFXC77o0rfvEzl3Dk95+XSk3wucV+WAbXLCzmPQk/XzbuDrzEwm1z/NcKkyQUZLYefFlihP+ap5d37zMJOt8StabHs3AN0x7/kz/49Q/JUP/yzB7fYfVr8OwICWo+Jo6dZBC+e/JdxexJFNS1WYs9HzmNNRXtYYlPpSD9TvDPX+wgXFT8uXnxbAoeTs1SzHQ5hUXu92iLWERB6HCMhXJXAHaxYcQ6TZK/vKloYyDPHdvTaCw/IE2B3WJd9ay6w9jjd5NDnRUosF8U7LTO0Q5zYFGtkhsoaHpc67bQh4n/LLE0mgIUHPs5ApYZgfhlb+Hdcjso2JVyRj1zGgsf9J4m4qVHQZKwVqJH3GnMK/5X60ITCmYs15GMDnLF77hVze9i8PcfXNSibxaAeSi/nvDWgYI9juPSTTXcMcajcZ+lTlEgof1IWKrFFbeOuKRy+zIFVdN2aObLeONr736du92TAu4NDcbEnNPYN/B9J8+i4MTJKIPeMjfMbW/FL4NwCvqDuIGzhwLxV6z4e1nxFFw5vaLzTqY/PmAXILcziwIRydRNeEkAJm1mQy4poED5U0pJqKw7drvAcYNsGQWkR6NSyhEfTGebi/nZBgr6ujS7CzYE4HMLIzOGX1MQVRe0T9P7HPaCFX296B0F3rWMTUWTDmAD/0G8VYC3sTPblNKUmZnxz1swvta7CrVNmbl1OHGZmZmZMUxlZnuTMjMzMzN37Gh8bV1fJn0+nuyc2ZkzUtxP8jY9p1dLff3TOZTjOJ4TOJFTcWpOw2k5HafnOZ7nBV7kVbya1/BaXsfrBU7gBUEQBZWgFjSCVtAJepETeVEQRVElqkWNqBV1ol7FqXiVoBJVKpVapVFpVTqVXs2pebWgFtUqtVqtUWvVOrVew2l4jaARNSqNWqPRaDU6jV7LaXmtoBW1Kq1aq9FqtTqtXsfpeJ2gE3UqnVqn0Wl1Op1eDxL1UF4PqfVwmx5czfro+wzsEWo0dQvr7taQ54zG4AEDAoNM/XheYzT2jjB1Ndp5PyZACz93Cezd+xcjBA5SmH4eBEXtTwOtF/ZHrnAhcK6ePgPB8126h5uC0x4wWq81pm79AruYrMHhfbvCA0KrU3B8FGpzOD7ZtDrEXn27WR/G0hA68P89UGs5VUaEv5VOT6hV3JzHiLS4LIRaJR0yzDj25TuMXfKx4cPVSwdVJTPiPEPPKAPJESEuZqjfanJ1VKXdgx6ZycouodP8prYnjSo1mHdl7EoyfMfe+eOy3SI7Ck1fX/3Me/K/bINMeQpcI5h36KGbl8LdVxl83FJuWfPfLhDcLaOmGHmavqLftnztiP+5picK/m8E2ZJ92I6tY0cQQ/CaxEcxDUi6cPdims/TyOfN7q18H24kBXbEbV0bayZNOnbPwI2Yb89/ddmqhDJfqkiDT5Zp9xbyT1rV8cHOfrlIlZPxS+tM9yLawtUbjN3dktyVEqdNr12HLHFXRfmHehFjwsvMYva+pNxZbeMh7WaQh7xnzNBzk0mzp55Dur5qY8//xrfFuzMPh0ijc/Qze0N+ZfX0j1tepSchST2Ha4dUJremDS+UuI4n31L6xPnXy0+uPDk7aVd3NTlb/WP+2U2N5OLl6LMXPLqSpDGFLw3q3IHMatLwzbrtpQk7/6+t+395u+X9wPDomX6c0m/TnWYndo5XCvT5QO6X3690WnIi9ET8feXu0XbX4quHkCJjLpwImmkmCzpuWbuolZtXkSXjejV7V8Gr/aoi/U+1Ku9VODkup+ljnpQFkVFFfT5t3vV8eJvD1vz1VmU4dK94aWXttoQuXd+GKY1686Z9feYqSxO+TrgdEausz9P2+/omzYn+w+D7fKnlpMqxkBylcp0k809uT+7a6gGppxlyPGO9yyRj5Pcvnt3XK40OTD+ddFxtbv50dZPHkP/7xfRiao+8yqWCHVJ7PqmvGM8Wrn16fBflXbH2xm1hnZU74aePlDtbm0jPeOVxzrFk0ZBpvg0jkkl88xLx21dsIvWun8kxaOdSUorPWqXHvQDlVMV9vhVfjjfnXltn5jRpu+VSwx2mMRndleEzIlJuJYlKct3c12Kq+ClNux3Xa4xq5XvI6gGTJhjI9uKjLkcs707eR/ofy7RyPKminKlTodh4cuaCVLPjsGDS+UGx++PO5VPwfORs3Qj9tFGro7Yjod/tEHrGp/Z2mq1Y0MtGr6lns4keo232y5SdVqtMEd5bbeUa9VXeENW3f+be1G4Ae+HJM+0bsL0PPTFrfNxmRHDb0g/2cWvrZd5wU/EpvW/TwxqV3X27vGgT2LR/Q183OniAABABKoAawHIaB+DQMtcYqwPoAf/vgqsBqAkwuOAkgAwgLjgvgDfAxwXnC/AD1HLB1QbUAfi74OoC6gHqu+AaABoCGrngGgOaAJq64JoBmgNauOBaAloBWrvg2gDaAtq54NoDOgA6uuCMgABAoAsuCBAMCPmN77l/6xpHKCAMEA6IAJic2MpEtI1ydPlKk0ULraMIOXrEOvJTm5v6sxC8MzegEyAvAEdnQBdAV1qrmwPXHdAD0JNyvRy43oA+gL6U6+fA9QcMAAyk3CAn/Tfkv2Ajp154brUBXsuf2fwbdE9s1yN2PrDa0q/r37Fa0qHaNZt1n3PKFpdQaJvVKvODntviwhY/svE19t+08Vs/HEBroX4LjbPQ+yxYF+vQvFjPQvVYqE4L1WWhOmx5Os94atNxa+gFtOi3W/RjHPVjv1gX+0Zd9jqoj+pAfdg39ol9Yb9ocZ4wDu/DfjCfvS7qwXpUB+pFPbb4ZZH3ZGotjJV/i8e+MC/2i3WpDrsu7Bt1M/1ZmP7QWpj5wfswH/aJfdn7xbpYj+pBvex6sr8PyKMf49CPdbAf7Bvzoz6si/OF82FfT+b32z4fzOfDwnw+cJ1RB9bDOtg36nGoi/P114be60X1KhMlqecn33qxvZua941qt2zMt/bm9ydMIz2rtpSSSgS07l/eV7pycHy+Sndks7Zuq08BVZuY903M/HbW28bmDhNaBGx7ZpSmDHWv5VOiqeQZ3eBa+1r+5qMV2mU6reooUWumfozD+8xYF+tgXlpPonokqhN1oQ5pgbHJlKKhHaUrbTyXtmzSxkwt+s1o0U8t+jE/9oP5UZeEdVAfzhfOB/aNfWJf2C+16Mc4nAesh/kkrIt6sB7VgeuDesyW6t7C8y/+ErVmxkq/xWNfNC/WwT5RB+pCnaib7c/M9IcW/RiH99nz4fqiHuwX62I9nBfUy6wnWvTbLfoxDu/DOrju2DfmR31Yl+pDXdgX9mPvm/bJfj7MzOcD86IOrId1UJddD9bF+WL2O//Z+G91vLAwDvLf6PBQnK9zk/9m3ksrzPW/pCM/U0fF6ODIv7P+AlOnDqOD/EM6ijN16jN12jN8Y/LPrD9h6oQwdXowfMDfpKMsk6cjU2cww49i+B7k71l/fybPQOc6I2Yy/BzkMeBP6qjI1OnsnIfMZurEE+aa4WeQP7f+TZ3zkElMnpVMnR0Mv5XhI3+njqrOcUo/xfma6XfEbkbnCabOIUbHWvK71n9Ea6bOAuc8AanMulxidNxm6lxhdCi/oMOTWf+RznGRW5z50lecee4lc/87ps4zRscJwq4/nl9wH4PnD9yH4PkB9xF4LsL9EZ6HcV+M5xnc1+B5BPcleI7E/SSe33Afh+cd3Pfg+Qb3OXgOw/0YnsdwX4bnK9xn4XkJ901uvzDyAQYDCjD+j0n9wnY13SoPEb3vHcp0Su6V4LOoQuOr8tYHZ8Ni996WO/eKvepX/YE8+k5+NdnwWF77sWDYW/0zediABhWrJz2XvzTI+eCRfEDOpdzoP8W4X/7St+2Ox/F7ZUvNQ8XeVdgtd9KtqrbmvkVunbrkfsP2W+X2FVOi111fI+dK3bLx0tHFMuoYAhgKGAaIAAx3XHbASMAoyo124MYAxgLGUW68AzcBMBEwiXKTHbgpgKmAaZSb7sDNAMwEzKLcbAduDmAuYB7l5jtwCwALAYsot9iBWwJYClhGueUOXCQgChBNuRgHLhYQB4inXIIDlwhIAiRTbsVPFMkJb1akc37AQ7LDG4Dxe5Cs8A5g43/V7+Eijwf1uzHx6Hcc6Hf/mfuD/Gv+jC787r/hR0Hot/oy/II/PeuHsRKwCrCazvUaB24tYB1gPeU2OHAbAZsAmym3xYHbCtgG2E65HYAT21Pyf1y5WC5xxgteS2WPUkNepGReLo/J7e1RZkykPG9w0cBtCVFyxP9F7RrzLloenH917ZuDYuWQMtnaHPCOlwuPC4RXolx5TdTOca+S5ZK2sVrOYxvr5Pw11uWrsW6DXKtQhz4n/bbIxff3hNdOeVZ5f3ilymnf5x6UW9jGWZn99/Rg+NWaUTkf1cwtfajpUSaj4bAhh6HixkKGrOfLGXwKCgY+u49BM6eV4eWLHoaJEyYYLk5capjiud2gn3bbUME/r3T0SH1pRXKyBJ9qOZ11jtPebEBjHWk6tslhtnGO2ntyT6gU0+OppenWkmMfN7mAFv0y5KVaGct8n74TsAtgdsFZAAogxQWXCtgN2OPApaPAnxHfYWT4wTJZBgRhaHv8Z9G2lN2ENEpO2h42YCHSJRhT2CQVRbGmhN3SYdLdTtKWBrumdIM837339KfTf2Dk/1QACOi9hclqdwbkxHlqIUP9wk5sanP57WIYhmeMsV33k4yGOFKsi9Bxn8szUyNWCDQh/FWJqcFP+TbtJ3L3p/JZL4rORYcwyVDiypfDJM7fjaGvFa/OarMhQJsrHdqcsDqMbG8WPTN0aRg6z9gLoxiv3IzIlhO4zXCj0lcD4VIZlq5J4ZqDPopfrUiX2c+Hb49Y7NVKt7YgweuP0+/6lRn3rRCyPIXKCHO8BpbSEufKzMxKNDou8S5mGtutzyI05SNHLtpzY5IVpwyc8K8aQuYPUwQEVCkxF+dx9B94vd2B68lcpAuXUe5YgPDnOjYHyHPCo5DIqecwuVuPtMVTIvRGMUpwCHVfffLVPnNhTQMZPmrMX1zAdNdmrvdsZ9EMHfzaSmg9Og3vM7NwmevNS/c+VBQ9Edc1JmlSMQXSV0kozEfB1BAxLAn0Wcq7PYpcLr6Eug0kPvMmMeo8mmYvea3Xxe1xUph6DGB3VZ7dr+Ow9e7hwD0LJMU/kbvCHN1X1UQd1mLunFJeHfdky8Y5MCONVpEpSFc0cl11CIfpLly0sCa+fxm+flXMtk9B7XMQH3N20FxYzk4NYSz1XyDR8JpNug00XA7m2WxZZAM/83aTKcUlagi9k6DJpxTJ3LW0T4tCqmkrShMXEjDBhoDlw+g8vZWEe35M/9LG8pXGjHN8Tmx9FXesjHCxrkBENpznFxMRiGxjm6cft/MDsP7tGMf/+JO7J7ew63UWipG2dOSUcupgM/PzHDErWUJJtQay0c/Itz7FhMeejJw/iQlLL1O4uZB/ikwwfXAWJNt5YZyA3IoPDL4cB9kDTA8tY3fFDybqdfJvqz8PPxXwqEeWkFGh5O3RQ0n4IaJL2jk24QpxM71QSrrOsuB8vNSUETNzY2/UGVw/zUC19Bx/SazE8K+3dDQG8Tn0PG8/Huai6nmOfXfFykqDjMExLL+UiGP4TvbsNeKUpRrXxVPJ/CDMKdV5dO/TRmXUVEaLDWOVkBMKPzaxLPYM+z4NJ+vVXLp9InFfvpfrEs2cDo0k8WwXTzeso1KkjZkX1Olc5csDWyfq9awwsBzBkSA/zNbLoWmXi1vVONSWq7H19/2s3vOCJRvdERXOQ77TmUkOL5ERvIrlyLUk6tby1aOIo72SrHD1YZpMOuec5Sguiydh0kbOvHXhWHUQCnvXMjI8G0/BUNpVdsOADF/3ROOQvwK7psWcrw/gtv55jEMHGR14ElXDBoK1r1K/+ySSKZ8QatRFXHMB2/xvsMU/hHHjgxn7uYqd/nepHVqF1pmxbJbywCZCHOvSDB4FpTHOIItnbSNZsV+Gb8ld1M7OQGRSLEHzlbEL8EBYV50xoZNZpxPLtNv53P1+h23zJ+CWb4rigSvkmp9nhH4Awi1dLDA4iZvqRbQTBRGbKU5VwVY6gwspTljF6pIIojTL+RijQVxwKPVGTkjbNuBxshmnE+sZqNXkzs04GsVV+RUg1l+DnakD30elIGevgoV5DsuGdHDpTWN/djuyIY3E+avgcLKLkaXi9M0WoPr9NBY/DMdiyt9olAuz2ugLE7PDUZ+TREvsZNbYR/MsLwJR/bFs/bOcOb0eeJ0YSZDkXoojN7DL/S3N3+Dyyk0U1qQQ65COR2UlT4dP436rIicv5lGQ4Eng8hq6LW9Q7N9BfIsy9f9eQn9bJk8a3DjzaAbytcncnqcDdy+RsCGEZIuRyCkmssrflxrBKDxix+C1+SYSE+SpS1Gk78MgQbU/Ccoe5L3HTgRiBtDz380Rd3EGjw4hqyeItaM68lKBmGZ9/YWnu/zt5k6YozaqOVs5/Ho5Ko0SPFI0Zp71Ih7vrkClNJWcnYOEc4tRO9+zpf4Gs3Ytw2bCM9K2HWa39QpczZu4uH4Ya800mf4yBfXWQia6W2Gp8p4jSjFMe1DATTUNhFLC+Xr/BRLds/jb+T0yQ56IjfDnlIEia8pvMDPiIg9vPUfZUoTEXiPG15Tik/2Ey7V5xElmUXLrIEIu21Ayk0QGM/wmtfBGMJBJonacMzzF0ewGagblcZ2XjFfQQka1/yQt5xpOLmtYKR/NmsItKPZk8nrLBToehTHa9BQzdSIJt7Bikv59/LXCKJs5jD31gTxuSCZnRyem9uMZJujKyXvxPMh9wjqz5UzvH0PY3gJuC+iSa7AIgTovmpaUsVquj1cl//C53RBvuwYu21VRna1K+PkCPDe9wPldES01E0nX+Y2lUksx22/Fs6xO3IOLiVeyZIzJd6bqGWFdeBS5wS98etXObO8Sdp1dhFBTEUOvT+Hu8pZ7g8WECOXhbbkP14QHlLtfRW+vF8XjXeiujEHuj0aSHqeTwjrePhjNvvS5fPDZwb6q44wWV+CglBi+DqEMk5Pg+gEPBgezMV/STLWvBv9WT+REehqF5wdQjZah1b2A0CINqqLNSYxOorJsDBOCFNllsRAF8yAuVrzj1cw0XLfHoid/hfFWZQyKruRNRz+ndd14G6jAlxeHGUiMofnHU5QWPUZZ2xqtWSZMqf6HgwMi9K90QXlqFRsSD7P64kk2zi5D3qyO3OJXiEqfY/LuVJzD7Ji/ZQf663/gN34sHUnjGSjtZGGm4i/9wWfLMuq378Dx9GWC1Zt5LJmK9abLvLHIZF1AMVV646jfsxzFqfXclbrJLIWlbG5/TfWBC1zbmMuawD7MBQb48NcdgmZroJUwG8eQOsw+x3JovhYlny6zbnQ4F9XvE/N6DM6jlmP/oAW/Y1Ec+/08vU81mBX8EK9DK7lQOQuD63XULTPjzT4dHL8Z8fNqI9tfWOHlGE56/AHMum6x4NgcDNPN2OwuxCz5QLSXBRD07iMfrr1gRb8BQ+ZfmDq2hKLNxwntW8DzvCLGFlVSu+UOy4oCOWJsw6xAXRT+CmWc9VHkf/fCX2EyxjkTODb/DH/+FkR04Xs+1HpRqJPP/I6vdDv++oHgHOxvL2BxyH2yvEUJX1eHTL0tzm/quRQqTbRcGE4Vsgh/T8Tk+kxWXyhh9yFbfL3nMDZNjajO00wy/8SsViGSrsqzy9eUCOl1JPXGcajxFefqrZHQGP6r5nUCbt1k73c3tE8d4FBqDK5q21gqsxUWfucZngx0mDFssylNe/wB/q+LO4yGYv0DOD4LIgCihLYCJFaqqBnPqirdKqVuqlRuhSJZbokqFipUWUVJtyh1U1VUFWqmWaEksaRSKVsVgAUEMf9n6umce/4vOjOf85uxNvNyfl8+21diTybP3ekMD8KU+T/3lryWl4bOYh09tt2JvY5rtseR9YSoL9PZ6427tk1L+ygtaJ/6HWCiurCI0jf0uEYbv1BdaEz9cVvgGzr93oCyV2cvwKTLdb/ovqH3H9Ed928FdKil47rc13TF3SLVhbdYC0V/rn9NP1Czc1iQCI2NDpHIvaYnzp4wOi0IWiQ6WJL5in5rcum0mzv0MvlVc9xe0YWmCVdXOUDz/Qtm9FbRejVn/e/osfPMoctnq+jFnk/ct/T2ACwzzun4vCrazSbxnm81dG62U3frS/qjaN1z8gG0IGFu2cmXdKjh286/zkKnUwYm/Jf0oVXzdVYJoYXzZZ8bK+mX/vVlpzZDS3mOY5Mq6RMRlz+bLYCOfXekyLmSjp6nNJuxhhZZWH1qrKBrqdvvJ2hC97lOCkiuoN98nLogoasbOi/V16WC5lt+LJ9TDZ0iS5K0SujijFCxMwWt9X70pVQJHW8mLYi4AJ272b1ugQR2FapMFWOh2w/Om9BcTqtOHjO2LAA622DXHwvK6ZWjnV6+XQHN0yLmXiyj18bcnWsxk503zlWXK6MH+0a53OOy9++2uuD1gr7V7fwuagS0KFmBIy6lE4Y91ie0dcHPj1tlxS2lGxerpr99xTryqEHkc3pSvpbYi4KWvCx99rmEzn23a5LpJWiRji1/XgktJ0l7MeEodLvx1t2Zz2ijPTFF63ZB81y3Bag9oz9Pv7GwbD20eN6/3KBiml+1JCVsPjvXu5vw+ilt+pwp87SDFmzCc/Gn9EL187t2j4b2mnEmNeMJLXJynlHMgU7PWWmv+oR26Ut+uLS5E95vGrL/7yK64soYuZGvWD9O2FtTSFsP5WT2P4LGKpfbzC+kr41V22N0hXU0GZ9dQPPu6XkFn2C90P/02AK657yHx8B+aP5F0cpDj2l6lvGZO1uh08P68rryaaonIfrsCtY2ZsVe+fQs5WdXc5yhud89IsrE9H3+lUkca3Y+vLAGF9NTXEpPho2CFi4iKQ+aPvOj0pjLgebzTyrPeESrui5Z2N3SAd3vnGJA0du8E9x7qqHTq5f69j+k94V7aE8sgvay44bVPKAbzZ/v3HcLWmhZXyDOo+8b2qhxzkGLg+/M/zeXpgT392bHQ2PX73CO5tD3SZlZ/G7WjvM6dsK9f/vF045ugRYeCtDYcI/+sNFClLccWnr+o6frXXpx5ZSLGgA63W/JW4c79Lt+reDDNtBeRX1h3Nu0/b0WS54hNHdTynyNW3TW1Jh3gyOgsUq/7QNZ9B3/pZptPe0A4+/+4+i7G3RZmvV6pa/Q2IGvLeQ1evwlm81zK6HFOvy481dow5TP+y6LWcs5rI69TFdMfxJtlwUtfO27IegS7aSbnvL+LGvvhfGeGXRtvXvWtSPQ/FFbviw8Tw9aLrVL28vOm6PEwefoMQnTjtzzY+3u3vFnKm3T33KpbQ3ryPJNxElaZFPxYuFCaOzqkUHL4/SVG+1Pnjiy7ufutT9CX5kSputt+XO+ftqYGNr17yYL09GsWx7L64TSybf0lBSUWZuGqSh40YYD5t/HSWXQopguWSDY2fTXY6PzrIlpLjWHgO3pyGytzdDCx4UZZSfAixtteK8ZO4/Ty087A+p1E+WLG9ugtcuqs8+Da7eehwpvQos5knXxl8AZtbMXDHdCC6v50Z5XwL3TI6MTZ7L2kPlZ3ACrUr1UpBxoccq3lF3ZIOXh7m+cklYAU4hfelbcBvKJ+1Q7j0Njjoc/2N4FZZ6DPtc9ocUeh9Yo3QdnP264amPBzv2mhbzLAS9s/J13dLYA2AlaOudaHpALu3wh4BFr9YdPQx+CAOUZAeaHobn1U3TnUEBh9XoqaTU7/xhkP5IGR9IeOtwzh+YnThrlKwagvqUtuqcZYNnHow4syAf5J9/vGiqE5pW82GH+GFj+cVDNJBl6WdG/b+QLgI2zrOizN7SWA15QWwAOxz7zdZ0BLdzjP/1BIfiDZzx+kQp0e4Wl04kiEC7rPNDwvgl6tOkLvyfgAuFlb5wFLfJp6eM/BZdXvwR1UezcsEc8qhgc/ltFxveAFvautGosBhaLromsbaD5fXLTHz4DFZ0ndNM50JiNUevhEjAWf2+a9qYRYBKO5/J1z4Ho1lNFs5vQYrLU16oU2JWd6rQ9AO3l+mpabynYtehi2wNPdj5/KpX/Aji61p99MhVaWp7LOVIG6tx97dzUoUUGYpU/y8HZN8wx97oGgOWO09muIQH7sNK0MhpackIjN0gCNAoevROfhhYcPOdfJQGDBhOvWuxk54scDk2vAMqpd65jbtCuE33VUyrAn87eDQutoYWlUqavAnjJdSdzlKC3bn6zcU0lsMqQbjb7XA+wTD0VXl4luHGvZvedR9Bec7SCR78Ej81O+V49Az26JcB890vgoWTQOSIMmpc16PbqJVDTff2+ZBW01O5L25Qq4H/fjYNp1QF83ezE7XLhePLdJfIYrw64rMdcm+ijeGhVkjq2rA7kXHp98HLEMfxG4NIRmKAOLDZb6d/04y/8pmbtMJNQB4Y01iy2CN9HkkWbR2DZdYDzrsZ1a3482ZvvaYJJ6oD2iYVnjUA07tyr2MzI6sCKyZ8NFYThpPDUQQ1Mqx64h6kE+TB7cZ1G3x+MXT0wPUSZf8aO4H7akbWMWz2o5HTsSJTbQYr+8dXEBPVg5z8rXwT98CWnFYcPMAn1IFqh51z+o0i87jF3mMmqB95bSq0MwgUk9gy0MuX1wOjwXuVgoZAMMTRvZGT14Gb/2QBL8VG8IeMfBUyrATgs/ra8MiIOT7A5YYDxGkBkF+9+43A8+c/fDkrYsgZATvP2p+k4/EncbC4maAC79mp3edOHSYWwnmYmoQF4PCcu7MDiyFoFcgKW3QBGLpI61mL7yfixat+Y8gagmMbMD8JiyTnHEn8wsgbgKNgj2RsZjT/dOGCCaTUC+bu1IYnOcXje3vm6GK8RhMilLFoqjMADR7TVMW6NwHYT87Y9PIGs0ME/MoGN4IGj+cmrUQJSPX5eN5PQCGSZWxLHCg+RzrYpH5isRjDjxNp4Kf8Q6TO4EH5/9vk9k69cBvDl/3RwsfZGMHJdrMVVEE8qZc/TxrSawKp3q0+7Mjvxgd6HIzBeExgdMCn+2qMjeJjxKS1sWRPghYV+KBmOxV1te4wxQRN4f62aCHFJIN0d1hhhoiagE/I4Ro4+Ri5ydrPGspvARsDgCkPbyAqTm2+Y8iZwVyDSqXeOIkMVlrcxsiaQ8VFD6qzkh69T937PaDaDvJHjHIuV1uIeJVeHGbtmYIxP3GnCCSNrHiS/ZdyaQZr1wa1aTBj5j/c5U0zQDJzdDkrmMfE4X/9QP5PQDPoLHp/cPbwPd3uuUMlkNYPCSZ1tFsxmcp6nSyVT3gzGN81qy2G2k7Uqm/sYWTPwVLU9Je8SSa4IufeJ0WwBY/xykrbkH8a/eAx0MHYtoPUJ76hseAtp+pWuYdxawK4FLeRWEEN+z1vZygS2gBbpivaM8Bj8VcJp+PdvAR3H+48qRf+Np443G49ltwAFjdFbjg1tJf+Zn/SBKW8BwU1PjR6FH8NDCoeaGFkLGI5Nu+H06Bg+qS9VH9NqBUFr8zIT9+/Cjb9rqmO8VvDuqWCbKD8OL9QMa2LcWoHa8OqiGRqryW+HamwxQSuYq5m/5LUwgrwaVTMeE7UCT8+hpIR9O8loOf9qJqsVhP81vsg44gjutGC7FSZpBStuMbfPcWLxHtHcb4ysFcSVuj+pxHbgSb3XXjCabaBy22QuPzqC/FDs/p6xawNblMeW5GN7cZn+7E7GrQ0sv5aUnckE49ob4huYwDaw5pHs1t+9HqQ6c04bE7UBTrHqhqPCGHKuwaVaJqsN3OPOeaWEheLnI3QMMUkbOO65yqtPbhlZCDcxsfY2oF03bf1c/gFS7uieHkZTBhQTZU72g27k0/hvJhhPBv7U/rvzemQ8njQ1qodxk4E5T99UuYB43H/xlR9MoAzsCk0x6pbbRLoU9n9iEmRgUf3u7or9u/HwL1L495cB+4x9qWM4geS5r7uNMIkM3LpetqgtMgi3L5B+Z2QysPaQgDNDcQe5w8u7m9FsB+9GGi28ER5Prt5zsIuxawfS2z8KtkWcIg3Ufwwxbu1gXdLzqcP0KTxqyQt5TNAOnq/6Ko7GovCG553w+WsHhrtmPKplAkjvd2ocLLsdNJvX3YwAiaTjy4scTNIOvqe5hg3sF+JDQ+8GGFk7EPu/Figq7CZPDj1QxbQ6wCbVgJgq4TF8ffe3AcauA8imD20ZoM/ib1NfqWPLOsDNZTqC3VgqnvrneE1M0AHaPn753D90FDdfafGDSegAfwfPquFhifganNDBsjtALEdeGBZxGs85Z9XHlHcA3yNp16b0e5NYVXw3I+sAzesun6UjTuAXDx5Ww7Q6wYR1Q4n+wjRcfs4BeYzXCRzotObHzAk8ppdkGLdOEGxrG17PCcHfjrfqYQI7wV9qESEPf0Tg+MwTepioE0xykcNL5IJJ3c1/6mHZnUBuXKdDlPA4Oct9uJkp7wSdNW6O4UwsefJGrirW3gmKXHjLljMHyKzPewYZzS5w1nJDbBAWSUZsvD7M2HWBUTk5YD2TSK7y/VcNW9YFqKjDE6IikvHx3we1MUEXKH2lXvgAE+J5dmvg/38XWH759uSzIImcXflBAcvuAp8cQwT+EQdwj2e3e5jyLmCvQ2vNlNuDj76b3cTIukC2+y2fgIgUvDtryihMqxuYHhizcUafL251eIEBxusGc5bXBNdxovHNd5PrGbdusDbudu42Jg6X7lKAz383WNn5+MwtcTJZnx8oYxK6QbD1zE4V/hlc4fKjb0xWN5i3X53OYZLIjxZaBpikGxB+NUFbxKfJz87tmlh7NzBacUA1LuIUXrGoRgfT6gHTL/oEeSt44XssFPUxXg9QmTKxrIw+SS4WvG9h3HrAm/OKisFyceSVlRtlTGAP0NnyTKOOPoPraNUZYKIeIJJlRRaFx+LHnZ/JY9k9QKxGj1R2SSPJMQuNMUkPsFpgNmgdmULG7cmtZ2Q9QGFbqzAnPIlcT7B76KiPEetEzDXYNeCejYxV48Nv4V66GDnUkqJDqj7UlCOLTQgrdk+9FhmrJr/MXJNyXPbbJHnwBNxbZ5Cr7aiMyd0+OzXr0efZUAXsHvs4ZLEuoVjedDDKDpnnSLmze+0AWYxRP0rfTKPckGPtiA52z30jslSecA24dstUgCyxoBzZvXchMvaBxIyvO+aJfvsLHvpzD/63W0kvSYjK3lvIfC7hwO7F5yNj6fj0g8wmv0pkkTk1i92T/4wslaMaChJjDnUhrzallo6Fe/MKDeh+B8JwRMWNSr3f1iTCX8A9ejNk8XhKMjvPZPF0ZIkVca8E7tUvQNZaQJDr0gy6PZC9JhBZiXDPfity4RQqOcP+bUkYMjaRyvWGe/fxyEJrClsdelFyBhl+34kX2D18ZEsHYmDM6weKj5Dvziai58C9/HJkiS212Ed5g58UeRmXGhEK9/Q7kC0tCQ0bS8mwXOMvZxtRJ9m9fT1kqSLVb3d1RYEZMr8H/+MJ3OOfgcw1IG6mbJyU64qMqVDP2b3+tchbzYjxgSGpH/yRJdMpa3bPfz8yxqEyJu756pDw25MJBSW495+OfNGRimNWLHl4G9lzGrGug+0AIOeaE0W5i8bsfI2MtZDH2C5AA7LEgJDrGnF0wwAyX59YwnYC1JrQ9T1kb+6x1j0myFIVwsIWdgN4yNXWxPqR84XPZiO3G1Jn2I7An8heqoTupu74P3yRYx2Jy2xXIAyZq00ctc1fMXwYWaxEVP6AnYFzyLlWVG7gtPHfspEFk4hItjtQgIy9xYUW+Ezm1W9/xTMq2Q4BssiG8u2aULd4EHmZPiHKgV0CjeZfrrIjrsSlbi/jIgt0iEWGsFPggLxgCVG/IGdUzHxkR0fqZ7dgDTKWgvsVdVjt2I4sGUksYzsGEcjCj/jthRadR44jixUoebZrcAlZoE75BKbmSHORReoEw3YOSpHT5YjA810F22qRQ8dRucawe9D5e65FNd52+ctSqeWX+dqU9GcHAVmqSrRtGXhrNBmZr0LZsV0EPrJEgxo1NBC6YCWyjxPxXAI7Cb7IWobU/fzYuMy9vyyct5pyYLsJCWjuakjVFi734GcgY8/xJLajkIPM5xBx+gG2ms+Rue24TiHsKtQie3Xhs66tWzeqC1mkRJFsZ2FEK/p+KsRAsfKkFWORpaOoA/Gwu2CHbGlMyF8oaSqeg5zOIRJ/dhiQsVr8fN2mhpDtv+fy1FK2yyBErlajRF5M0PpkZHE3fpPtNFxBFjG4WfTM1/seIQsb8Xlst+ElMreHpBWNtryqRxYYUy2psOPwA1lPn9qwf4y/r3bbL7uqEvUZsOtgjlzGJzzb9Gc5zELeqkbcZTsPy5B5KtTWAF9TJ29k7Bs5l+0+7EHuG0GZ57zYHZaALOgiG352IJAl3/CvJfsOduchG+oT6lthF6IceVkPrndg9IWrX5H5T3BdthMxgCxsI5Vc7hv9oyn75dgBcnMe7EaYIYtsqF3BH1yfzUTGruKmbEdiGXJ7Nzk0NzZsig+ysAR3ZLsSe5HJATwKN5WrTkT2qiKPsZ2Jy8hqqpT2q+PTH1DIUjGZxHYnXv6y8KMW1TbR2v9tI5rPacP//72iR+TaAUNVZP4dUp7tUukjG+hQUXKz9LaOR+Y/wLeznSob5BQZXvJQ27ZqBjL/KRnHdqvmIPOqcd+VvcEblyIDQ2ot27FagxwjRyWPwzVGeiN7deCG32HXSoBsOoqYnBk8qWovcnojKWE7V4eQ+XV48QifXuo4cihG/exenUPGUkie07gzT68gpzP4j1i2g4VcPEDGb/86r0OMLH6L67vCLlYpMleRqF7vNHFWNbJkgOxiO1lfkK+PJf69Urvxkgy5QYFqr4TdrEFknjq1aOIbS96IDvQ8deDr2I6WLjLWgvdbb7j23gSZ1CdesV0ta2R+A75foVMvczqyRINqZDtbs5GlDbijvduJ5KXI/GY8iO1urUXmKRK1BUErL/ogO8oT2u5shwu5ypJIe5h8sCocWaJInWC7XPHIsUaUz/oZq81PIbdrE5fZTlcGsqsW8eWQbt/pLGSnBdTK9bDb9RD5qykxx8gy2a4YmTuSus12vKqQhV9we/7dDfVSZHET7sh2vVqRRRzi+wvHmPx+5NCxVMJR2PlS6vzlpMmESWbotEc6yFg17vIBdr/GIU+dREzUDbvwYRJy3xii/i+2A4ZcPIay0IsaHDcPmSdHyLFdsOXIrrpUdplJ0IENyAIdQn8/7IT5I0u0CU2p8VSNUOQ2e8KZ7YbFIIv1KN7DxF0PEpGrdSmVWtgRO4ecrUyc0ajwib+GvG8CNfMd7IrlIsNecb/hbqfwImShFvVWDnbGKpHh8xA2asu4k7XI3G6y3BZ2x1qQU0ypCbHUH5X9yDx9yuw+2yHr+uXpUyjVS22tU/R+WVgroHLfwC7ZeDR3nUBdaMyclWuLnGJG+RjAThmOLDEhLAa++GxaiIzVkJpst2wVcjWPyov9eMF+C3LxBMLpKuyYBSF7cYnhnSYTzSN+W59yZLtmR5ClI6kC56Cx/FTk4LkUNx12zi4jc5WJ5B0tdMQ9ZKEz0cl2zwp+W4ZP+NQ695sEOd2Aevizg4bMMydKlxrVClqQ/3WljoTDLtoAcg1OPUz3LZig3P3LuWZEMttJ00cWmxDz56tYDE5E9tKluFdgN80eOWUi0ZwXAwYAMjaAj2E7akuRxb0kp/LybK7nb6tS+mxXzQ9ZqEOZOxz2CQhFlvIIjO2sHUTmT6YUso5/+pSEzFUjgtnuWgbyMhOKkxvQtP8WsnAE8cmK7bD9ti41Jd8g16XstzHiPdtlq0EW2BAnr1VHTm5GlhpRcpNhp60fmTuGyLefF+Gi3IN+f2XKmu226SNjA2TTctCw3wxZ+Q/i3VLYcZuKXG1OGV7v7f48G3nuFOp9Euy6LUfGXQl/7cYPAi/kbFPioxXsvAUir3UhNAo/v7cIR5ZaUYFs9+0osvJEarEqY6H8D3LLEsLiZwcOGSsku/dkDmo/QFbmEapsF+4ZcrE5BY6dFs2rRk6dT3ziwk5cPTJ/LFXSXMPN6EUWGBC5bDdOsfeX+8yJUd9f1FmPQsY4hD3bkTNFloyi7lmNMf7g8Ns6lC7blZuDLGwiB46Rw3nuyF6W1CkH2JnbhDwcRBybovw0PwiZO4MKZ7tzkcjCOjwo6dytbhFyqBWF8iD0//UXaMxF8jJSWbVarm8bxukbh3G4fhhHkYtxJNDsuTk8r4bn7OVf4ZGDXtj+/aKtInrRdsR/Xjjn+/26TuW/16EX21XRC/Hsz3aFP/sr+tk7odXRS/Sa8B/7+wTAOXvdHnj08vt1fgieb/X7dU8mPLIBDO3/BDD0/DGOLntEyxfsPenofnZejO7RZ+9B82w4z0TzBjQ3+M+86D9zZf9f89H/mb9Gc/a8/j+fhWFr+P8DX6iPuQ==";
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
