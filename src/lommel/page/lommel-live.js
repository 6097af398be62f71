// Made by `make page` with ziglang==0.17.0; SHA-256 of the sources: c5bcbccfc14b6955b3014785de683dbc1c8f7a872fc2a3745b9dd2fd29dc89b1
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
const CAMERA = {"focal_length": 0.035, "wavelength": 5.4e-07, "pixel": 4e-06, "foci": [1.35, 1.8], "between": [1.2, 2.0], "read": 3.0, "offset": 100.0, "stops": [16.0, 11.0, 8.0, 5.6], "height": 240, "width": 320, "blurs": 25, "largest": 6.0, "sizes": [1520, 2144, 2784, 3548, 666]};
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
const floats = new Float32Array(buffer, 0, 39 + around + rank);
const steps = floats.subarray(30 + around, 39 + around);
const sizes = floats.subarray(39 + around);
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
const wasmText = "eNq0Vndg28a5vwUC5JEEazG1XLUuiKh52cvK8pKo0Cuua9lZ3bJqy7HkLcmbEhXLUdV0Z8tdFJWdlz3fcOQ9svfee+82U9b73QECaTf58x1I4O5b9/vWAaShdTElhNAbrS46h5A5IodB5oRw1xPDf1L9p7k5BH+Wy9HsHK4YuHcoMs+CpjggsaxmZ7NZT8pn4E5BwU2tFRNUTVDitENb6ejA3Mr5w8ej9bMEe3eAgJ0883hooFkPh5IIY4FlqQ8QMj0h0DDDNKvls74TCo6hqZjodVbB03tnwfQMaa6ltbW+8BWIth9sJXxJo5SgxYONoOgD8QIY8NuJx1bYS7dReqaHW1O0Ae5h4z7N28zwg+FHxXcM4t7T5/iaHlCmYelt/MgjgsVQ5fxNirFWYj4v58PwWdkg1oG8H+sAHYberaiFqS4MXTaap+0aaqfgqR0BwgCqYviQw56RbBC2wBE/lpaetCurkVwwQPfVMA37UyVuBtSQR/OS4PsKvm+NZgM1tfDNDXuqLfhPv3D0KBXUpRXshZmv24GheYEVzHxNNIiuu2LNaeNB+HX4/DBmvQ2CSoBhXSt4YI2G69B7YAx77Uccw09a+xym76FgM9quiO0gsqn826saWpvqW5c0LGtdsLStfllL48qmxlXHxOcuWjp3YX1b0+LG+rMa20g4tGjp4sWNi0xItbQ1LiERnyDmNzQtIpL/I9YbIyQai9t24luJEQk1DGHb8XCIGLaQtrQSZcnkiAO+DQYhwojbI+PxcmHLUYYhMOLllHLOGFb+D0QbYwTMWLTc8m62/E4UGyQqvjsiQSBCDKIGHsGQ5cSwxPCQtmV9T1IpMR/9/biTckGzDjQrf3CQ+I+DxehDhH3oYYdJmDrckUfII6UsM4464mgLcPlBB5WVjTDLjhlVZktpHyvYmKNH2KJKjCk/zsIAkcI1ij2FTYyQFNKIG0IKzIQoN4it/hLOKKL07/F9Hv59v8XXKXzDHeN4e6TAPieIExH9ypNGjtR7jx4L1jgqxNgiFhszgYAwIQkZb1HglIpOj0FMpEUFhTc2SGAYdtkECseNoyT+Cc8IsasohesgWWNl+US33DCqRbWoGZuW1bB3TFktt6yTbSNjGJZFqYzTcuAH0LhUQ9jlMIOfJLYasHowt+gkyyrj5rGWSSdPSSapxTk3pk47JZmhE6b/cMbYUT/idGbdKDnLnk3j37OtslNHxyutmagGogNAy70aSppJm0KfyuFdx1eKcnma9oicrmVsmRyvJnFLTJS2QkERI86hcqRWidpm2RmcctOqnC6njx5dVjbaOl0yxiBxpudK/MemtKroT+y4iJ9s29z56c+sn8dtS4+pv5j6M/UzrKm/rE9StZdEwGxabmOO8FNZVSnlCJUQVZ5izsyqeLzB+tXMMlNWUsmRm2Lx2BYHlp/+nJmWRlCnEfDpYq49Lx63JH7CarQtCSKzrPI4jVNK49qAZQiWTM7/ef1Mi5710xAKdnTZiMoJE7j2tlxbMqykyqYHDukRE42jkgaxjFKqMI7afzkBVcAXJPnP65voTx0vOs2+r8JK8oVykVVjU2HPkFK5ArrGxCzORlJGxwC4nFU5qWyxEEvKxo4dNUoePMaUB49LmpaJKCaTUmbiGTNDpW2ejv4y4+Y+5VSHgtL1qwrYEnU0rpyWRJc5HOHxcj8g6lIZGE4Appl5EnhIuTRsWpxgjB490h050sKotqSOobU0uezoqRI7JTPYDFvrHQ4WVclkcvnEFmusBUePnE5bpX2iNUvIOrWBJYBAwiomvA3mCUUYVJkhEMoA0KwwhG8NdjVNKt9AhBQkfbGVimbj7ESplpWVSVNBLilxZVxwDEWH+TFSjBnjKa+i5au8aJmefVr0FVRJLPg3ka5eY631gFAVqGVTk5mq5RMtDKo2OsFCxQex8izXiKp1B2VPMOHUT6pq2qsEBR8LSPgH1j53bZyoLWm8TvIxCqig9kiO1GCbDoTEsjtyli4gCUv6gSyq3coRFy/JUPFxaBCddIwoF8Mka/hpEyNeFz0tocfZdD3FLdEuTLqM7sJlCErWs9DxZo6mOzs7LZkj6c6nztZPohePeosL/OfmrZ7Q9sewNv/IDggtbly8tGUNI7K+aUlTW1PDoqa1jejllqVLF5NeGm5tbKtf1HTWgjbyV2+xsmFJYyu5lPJlrfPJZVTOXdFW39o4d+mSea3kOiqVyNymlrmLIHQLjXrT+saWlqUtZCuNL11SD4VAYhuNLWlsaKmHeltLQ2sbuYeGFb+lsWHuAvIgjSh5X/ZhGm5pmNe0orV+6XzyBI37Ouo93zS3kTxJrcDKK1T8atGKFvIOjWg8DYsbWxrIFVFjXuOytgXkmqgmz29a1NbYQm6NhvzZHdHw54ySNJU76biJ4yfUTJlUWz05c/LUU3Bw/2hm3azZp5624mp6Df2NuM94wHhMPC+eDu0K/d382PzCfMF6yXraul3eIR+Wj8g/0vPphfRiuoGdw7pZD/sN+x39E/sL+xv7OyuwfnYpu5Jdza5h17Mb2U3sNnY7u4P9L7uTDbBtbDvbwfawu9k97F52H7ufPcweYY+yJ9nT7Bn2AnuRvcReY6+zN9g77F32HvuIfcw+YX8RfxV/Ez//h/hUDIlO42yjy/izcZ5xvnGh0W9calxmXGH8p3GtcZ1xvbHJ2G7sMHYau43XjNeNN4y3jEtDl4UuD10ZeiP0Zuit0Duhm8ybzVvM28wt5lZzm7nDfNx8wnzSfNp8zXzdfMN8y9xgnWN1W7+23rLett6x3rMuC18eviJ8VfjmyC2RWyO3R3ZGdkV2R+6KPBV5OvJM5NnIJ5F/Rv4V+SxyieyVG+Vf5bnR30V/H/1T9Lzo+dGLopdEe6P90cuikfM+cntj1STRmliVWJNYm1iXyCbaEx2JTl30KP0umthAE+fQRDdN/JomemjiNzTxJU18RRODNFGIJs6NyQMJq0mTg9nmx87uIZNihMg0Enq8t050oUmIvI5CiNU46Blraow4JEP0eCFXSBFNH7Jngk7TZ69uTtEok/uKgDE4Ut+mVaTXL1MiVGrpU0qszeHD1u5YNkNb22P6oqUiivHBAn2bXpE+z4YIBBQGs/na2qrugYJ83DJpB8vRDq7/vANWySaX11b1XOEKgF3uGqVunFzwmR4rnW5OdyYcoyJlSIVnkxvSmqZmWwpaqWYo0Az7muGKlKU02SY3ojWlx4YmK9WMfJ1mWOpYG+m9toqOBf7UmOdiwWF5Wzrh9D2rmlNRCIU1E1aHuU40fbc5uQJCAuaWp2KOqZ+mI/VTOJFa2l27d0gPu6u20xuJDamIEwIL3jg9teARzaMb3LjDFZ1DSWm4dgcE/XkIvP3EeUfWTYDoxB1MHUyh64QcG3SIn3ZtNhXXDkYdw7Ga05csbXaNha6VpnAEZCtdPR0eRRzr2u4UdyLpzYjBwmt7UpEoU67/Dq4bWq6mWUW0lqQ4OJoyRGaAQFMhEOM+Qz2ceLqTKiuu3Q0o4WvdRM8Gham7lsy+dkMqBLCJnlQcpeYBmwIE0ZThRFIc+hHQtf30TGU+oAGcj40rvEDaDMy24jrcsT3bHKre5ZhOrNUNOwLWIR/PQigUBIUrg5i3p2wtHHci7Y7mtSP2uTOhY6eAPSWUIPI6OSVqQWuHtzk1wXYVSp1Lh9ehYGCdr3EjV6RzzS48jsPz2i0EVrXrcd917hgKd8qAVb1vqA47hda4HPwYhQ7tUbcuiKZzqXCUlVYi8Pn2kSuEGvtjW1HxXymmStgJL0Q3bVuFOsZSzaao2XALbAt6ASouqrgBW/NaFFZdjClj2FbdejZ4ZYqxmaDC/D1cpgqe9LnMt/OBWYAVAmwO69PdYCTOgRIBUi3zwdDQ96sKt/1PUd4GaFydltrX7KqrwLNzdVdxkxSD7rAdeRKluTQKSvX2JOUKx8FyMENAJiNWJC2aU3BDRQRsFiUSwdIJkZ8yynIqwOmcllPgHTINbqepQ9tcqqI6vcKlUD7LJTGCbYjOSdpxyEKIDQ3x5el2KKZj01QZgk7TXZ2iOZ1YqZQgc20thLq6r0hRAPQ1WJvLDmY3PI7T3CXADHh60QztRJtDmtPZZnhwPJxAnNJAUQNBzUrn1ElSS52iYe25sgmvv3pM2aSwCVG9aEbMaIlBakuwdmuWxgQtvfLd8bzUUSHDGFVcgYLB/hA/XhOx0rFIK2gsjR3YtBjiB5ApIh0VOt7sO7Dfisg2KpAyXY86TURNjiDEBVT1UN2YpikDmeTpIboceXMMdaOO0YzzkuChu4SiSRzuaQqtCWNSyQJZDlkEeVqFrhf5esigOZqlHTTHswd2YiCiC11aqae6z4AP5e5X4me5FIODw3U5kEJtDC+GGhTmkst/lznq1YFhLndF+vMHfr9eqHNTpLc+88RePiNGMb1px9YhPhO+6AOEa5sv7K098rWBfIplVo5fc9z7J701IQXfcKqodx100GNDpnr9EkAyJVTJqbEQVN8/6QuodtfMg8PD2BTskPS0XuFIisfAgFECo0JCc+/6wxqnHPBpdWG436sdcnn+K+aK290ijALCi0wHEAvAqE+bYUp1CehNsJ+DfapBIw7Vw5C5LoHbTmRRFHhUZ9Czw3AZfS7pwz1lSJWAAE/BDRXQkcGVOWJbeMntg+feWcicNPu17rvuf2BivpC5/emr/z7qvuQApuecvndUnv60GtNPEt/C6FNUPyrVedf05xYOVMcs9LmhPp9SrlIfKvT1F1IhhV3B1hScWX26CtQKGAv4OwykIO0CNRjnhFEVFbCK8IdnKq+IQODZAwNzY1TLqoMxHwD0QyuCb6aUoe2fiBICzRELPWpIU8tADVSdUJ82iMO14G+GiIXyfYGEzykFqcmlEPBZ6BDIqdKxJlcEhZ/3IsBKchNYJpthVqpjq9nrIzRaFDYTf/49Fl8x+ZYwaU71HMvq7lv3tZ1X7CFWq4j5+/PvVv8EafCWGJ8N5NSrjwTF3J8iqGQIDHnj0yFyRox7xVeqdZqXzL59FLknhXZ1eZq2qZ7dY6pW5V6vLY/xfSuWQ6XYR8Lf4YEnrn9zIPfTGClpMV0sJQE24JM+F1668wfN2C25Un+Qh0qsBYhfOP/K/m0E9lQeSpOHZTEdfb7Tz59/ZddmckaFY/SnEAmuOm55+u9bNg5xFJDT7YvZXRsGSnKJQr5dtZoRtLDKusA6aHq1X+BSTb7fNfZtzIJrOgYKxRWOKLjGYNK1HDHoUseClX/sXP1AeOO26sJgUgllMrMnPj/iw63oh+f43RfNm7wL/QnZwej1q//wvR3L76n+yfnuBZXTHqoe/IAOfgS6+OLi3t7eJ6vPP12NV326aw0COm40nwdAsy8PV/YpPCKf5YyjykoOQlVTvS4PKOpjhva6ooRQetwrN3+lRByqHsLh6j/PNfAK0XOjwi3mWhmDCtKBmcph5p5xufl/z79Wj+OYBMud3y24VFVTyRr7FBLdCvY/YDm4Ci7fqMngbwQYrpAgzH0eMa+WjvBF+pRGvr8vMNtvq6oO8Dlz90XRvx+K/v8fFAVbajOlxqkTXP9uHMKlxrEsMQ4NGPde4A9RxkrSW52i+tDYNyGk18v6ptJ3MU9veeaSIR40+Ed4LVKHJc5Vm+gwOGS/M7G/uIZDHG/wSzYIrZX57bPfOWC+c9HmfOISdcj5gptzheIsRVGaKhCeiFtyVJP+fLGT5O8Zpx0Mh6N3+tFS1Mw7i6Z5Bxhg+KekphOQ0+d/OPgIS/HSI6fu5ML+ZvBtoCTvhiTkoM6XOP4JQf2DEiOHY0I3tCOAEW2tW7yADn783VceITeoDn5y1ut33p15A69V3dpbH5t2ypwPPwfDqfzgvBcO3gtG5rzXGuzX+N7qfB62Nmn72S79sLIDrrKpCs/oUxbyKtCgYKaamcjdQqi3BfvmLzScpqXO6XTmhY5RpvyIzGlfpj6vHp4M4ATMnV6hu7rC/3KHDQ7l9/eqatAL2Fb1QKLMP0Onx9j+hz9YKCwNwde5Z0jp6OkfOsXMklfTZwP54ry65AMEL540S4kol1rtEmWBFgsvUAuEKYSZDPgOUUQOIpW6Ir5Gk9RoTZISWkSnER9Sjn9ljlrUfHjmlsJAIbNx8LnZRzx3rUrZ4o1t1390w81quvzbB+7dufx/1XT725fgHN6DaUod90Ub33rKfXnstX+Ca2/HVlZOX3dVNaRnTXggPz92o5oucX64495Jt6vpUBc5r3LaVjWN6eP8UUxToWISZujPY97m6jz0kObDuKp2Ex8vBcjkh2l9OGf199JGnVMvm04g2vdv74J3hfC+9Om6b2wtlcHhfurMNjv0ipbSOgpyt+xENJ8/J97XhD5rfd1OZai0w3tLvgKBObgy4U8HYy9OYDDccxNd8cL701Rgxv1xwa0Hr79Uhfz0TE/89C17FLV96dt8xGOPaKoeO0ANDK0/78gbd9xxMwz9hP6+YlHoNSW3+9yf/PXVQ/+PmquAjiQ5spVQ1NUt9cDzzZ18vqwyw5q9TGUYPx0tHDOYW4Zl1M3MesbMzLZGe2ceMzMeMzMzmlnPFz8iM7tK3a3VmL2zra7KjIyM+BEJ9bOk5Hy6/L5Tnnjz255pPrDRSz/jaC62bPWb/vU9Xwb40VdnsdRt+g1h/tP773Gblz/jPRuEOWZpRQ8c9Njppf+DpGVkX3KUh/TG8dDibBJGyh13lopvZG24thuk/PhGVLDR0SuxBJLnT+JoDK7yJmNrv6QwFM0DEXsNG0GR7UWANQAUthcB44BWKA+AB+iivEc/4EjlTUZ7kU1HP9WNmxv8RPvULEW6YYOr1k8u4WJieXBKYjeR4gtSrpd0LDlSMYrdGaSbgy9rjDPQQkhaoIjrRUgm30AkLSNpGclp1iHteMWLjtWGvL7hyJF/wpzZTTakCJyLjtH1IsfMN8kxTF7RE3g1nSr6MwXFKY0DC15R09QZrJHf6sGj8S1zh1BrZxIpx3zXeNLa8ePJI89KMXGVPvbe9thppuApGwRXe9dT9UdAQrVJ9QGlsQNAa6GxFH2umdzekIZXEHG2JgcS904f/wqnQb3ZCa8eGts74eB0a8C96UCRgf5yOnBv7cfQE7X0jJh2+FqufGPTJ/CiEmK2RM8MhxeV8F1VvSl4gH/kr1MnDsm2BRtyPHJ2UQFVldS2AwIfxDjTxwmsiQEgllk709Kskvh7gwOa5MyE4AUlRoCR7SAsq4oEi1V5liEe1AC45DQWLCYgOO/PQrb6EaZCgfVD2+8hza119CHyMyE/nZq4xNvLNhhGnqLiFKwkH8lM8m17LF+mlDksTOKnmEk0I6IlcVWb1l+dKlVVoBw/x4K2dQfRkSfB22O6VePnsAXpiNxb9qC51LfHQKFAUDFzMqeyHpRaCtWE9B1TZC1CZSljEC0YuA8zCB4FZLeJyFZVcssb6I5MwZtLt3w01zzxsdiJtMn4iVSXJNUqJbjPTaKI5VEE6I6fBXHCXo1fIFfgLZM9rJ9/CAO9XI1feIQ13a+vSQMwTPJRUwJNohPULDee0TgA6fJs3MnlS/jyET3dzKYpiqySyE4oS1oSXru0UahB796PhPp/ruRn9EQxA7vdExU96dowTFjFxvQm4Tn9xkoer1+IiWBlE/jHBfCS8Y0Q75WNfdnTywxDSj7lOs7/dDyoo6czOoCyUxIpRVWTtTdcMqGjzVWmtHMwa4e+byQEEU7PinsfXg/s0aN+uLODq0uXRgbpvIvI64IOP1h5ioax8pIfxWHgvW/wdz/sjwSxJYgyH/tyQhqCP+z8Zq/2h52mXdDltN57/X2zZImrS1RisU9c+UJXErav4LxUB3E66TSqdPTAlbRbgNOxFV34Jk0OneNNXJMQnTNSDuSsKHcZAK0zAjGYgGNEOXMV/HaCybTvy1eBFLvUrf3RgwjC+JelU7r6FblyWefM96707NrtNjT/+/V1sUCj5HxaGgcu9drf8Cd/+eTz1xsdZK85+ks+PsV6XElLankKkiW5tE2vaOwdzTueQsO5qTanj1DIzja5oznCNcPNZrTZLDlKsse9s1lGxceeTBWbjhr/OkQ2mjFFhgL9flce32z2bDRUVG40lVui8FTExe5xIzfE9mRIO3dW8bmo4vdZBSkYU+sN+o+3MtRruUmtSzHlDRDaxNUrWXxTijdi8fO5OJQ/PZY/3pdvNCMy670BtZJMkcEh48a2b79m0p4nm1Lb/joY0AjINJdyObp+QrFaZ5h0EbNpNuYxlHkIr1NucNyRJ4oQqGjkk3dwcxNH4QmBfyIY+gFcMXA8P6Do97lSPPp1uR4SPggP82i+6mNRx7+fEGyUVPx9rPhzX1GSz69oLa375HNGYL6Oyh3hw2To7c0b+D51+Yn1e5/y2PVaxyMAHDK+0vuk34/lkrrZwHgrqx/RmIraRM7QIqa6BWODB33ldPvmgiCFzL0VXTu9dgKH9ofXHSV3cjHE+IwqoUNOpoyq31TKrkc+uBApp+JAOp84FAMzTNjfJ4c3eeaIMh87j4aDSDWWd2UviLEUSrBL+rzfzQl5h1N7wEqTbjSZI00SSFAByFg+t+mSb/QcV8X7cbJZ/Wlq8EwEf+K/eU9GX8A5GWEm7GvKviQ/0UlFQr9/1NV9kwWhaT+M8zU5f3wjzteE28HTJdR2TthMq7qnbLZ/mIX6w50DLVAtOx6W6bc3pnNYZkFodg/LDJ/4O4sjLvop+nQ4mcNyrrcfeqV4nIn/vupDr6xz6IXn8ibtHXqlfOgFzDWQ4hJnjh8H5C4lkzfpQwW1ic+e3fMuM/e8C/nYPe7iHeOC0yPuyGw/CuOgxnMwoSzOkBQxO51egb7U/dMr0kWaMPRYVype9M/PKJdZ80aglQxzGrEfZDZ083d1O+p1NyRw9TImrA91kyZw1i9oNM6LMQZe9utP+jAd42Bgjl+FyYYnIBPPtc5DlQlj9pXn/jDTk2Dd8YP87VA8x4EnV/aKN6RYUYvxq9GF9+RmYXe7eQy72/HbcDNb/DopvjttJmdYWaewlQ4NjjweDZwKu+Rbh5P9Fof4Cd41KPAjaQ9dOn4pmjDrq1Uum15FQnwBmcaQVGPxKJO2g6BmBXXW0UC+Cus5LmhWX2nyNacuwHrk1KQp2qsvGBmuq8v2Glc4aCApnPY1Gd1n9J7aNZe2xYSEPomZiDbE2fhFjL9hO3lU5LAaP5AS2EVPXLni8i8NyDmqLlGTOht9wTNIAVbyVG3pK2vVZYQOkgoqWQGZURs2U15IU6I9n2AL/qUKereB5grSJolZkP1nUt/UoJjwI588S7xWQvQbStnDAT5N8BF4HegaI+DpAJ4GeJameAJv/CQ+qtAAUc5lzJpLJ9hptQlsG78JnaA7/6pNxydLPoVSg1bKaQaJmutJrWd90tEnPfVJR5+qZ2uVwhWNeCrEM6FAqqlrTbHNuRKxHWDzEWNbxtiWPrasoGgqMZv9H6zwe3sWdvEP5YbOhhBnKMmk2E5AN3MNvKR7SjsZri7H46qOctkESiaAQoCg4gwFetJY8ZKaDSBfuWKaP0ryx0r+lJw/nQB/EA/UcXzMBtjOGx0pBX7N+cBanK+tOTPB8nLTgaWjTxtKSW8nsGb3gbXdwN4MQjxHScaN38q+P1fH1LWssLHkhLPeAesU71PF8yx6TlUp+yPepWIk5TM1aDmNe96ZvncZQMNAhzgCmGJYZnK/1uQceyjM/Jh3WkDj4K+u8GV2wQoBEbVDBcREnnkXM4uSiSiZgFLqTHdIn9j1rPu+x/Vn3XcWTOYQAO8/do7fCrVP+90kXP5TvCqZM6OLu15G/TImWJC93je8T/SSgZO7qOQsltCQUMyU0DD85+SRtWFV/5aLLiO6tiuB6CVREfbqZrarBuh2OkNyOkMtH77GHcY6DXJKDHn670YTXvaUbCcbGiPilzQKdje6Y46ccus5XRnqKt2tqaSeFDQCD3cyFdI7+AOyLaNO5L3tD/7ZXeCHaj9w7Bz4xoWv/UcbnZvMdw7ycA6QzPWub11PyOwAARa+fLcQwAh0gs567u8GI7sDRhlZUUjMj3zoz+4SgXnWf/212TnsvgWgAaJzoelaPQvLztilO2CXk9XlrrGDmegF5syCtwO6djfoZjugiwlxMKleq5TpTDc6HL2TbylmmLfjlm/WZFEOv4Qw8DMJKQwzibyYgLJrsI0rJrIEN36LpGSJswQPeNu4E/JdhUVGyZzodDzdna6Gv2ZUGqx1wVqI0uR4ABzUaWbMDdsBUU5vQOV34S3W/U6fkowbrJLO8BJgRUxdhpdOAdIZhj0jadKUihQTyz6Mb+GtMdYwzLmkKpFX5Y2zONM2/GjJGkynx7ikYdOVQRDdkki2Fg1kvjvsRzQWiv1sBTPhKGCIx/31giUEV317Mz5NJ9F9AQP9jF/vEWhdhBLWXAG/LVN889BpTNdW27WVJTnO4qqYbKPJqEGBmOxSeSC2YrZvDBbZJs7Tx++C3krz/3tjQSs7pF7R0Bd9WRFlHt8r/ECy1piQtWE7oeiHvFKMNZc5LCVxbNL2z/+I35JO23/mC/Ltg1wj2Ugg6tOd2Rom2/6jQ+BK3468wXfhvw8AsDOTs/B1qr6nM5LlxCqcqsd0R6EY8gC0EwBEFsE2svHme26ItDqApBIaX+r+kgIUEwwRjK6D/Kofuekj6Gz15FSnfQCsr+OtDny8ZoLvbFLnwmK361xQABztwUl4HySJ7PIWDy/k/xrRwqm8GnMI79PbOUiU5Pl+Zx2+b+UsEu5sZwMtfkSdRkgQCICAgAcEFkgUSDfAo+VIJgcL3SYMDHm859ERETbHEiZgqXkcTC2FjU3qclwvMA5GOW/kzsZpMS4V4woYV/SNK2aNg2Fg/i1O1u5xEkZIquyEjHTe6/rAnqOxa8QMAYUJt1vSCUgZSyKC1q2Ally66eWduhh6TDFzcd39JA946grtYhG+vN77s7+EQ53Sdycb0+oxKukMu4KTCyWKGuIwC+mPCUnBwzFS+lSCRqH+dJo3ZA9EmrmAmuJ77DRfwTW6Ul4H9gLA8FT60qIT6w7pq6pXwYyvtyH6Jg2hGn7eRG8aE8DMaK+qj+HXUNhGRDP+ExIa9jeZS+kLwy+T+QI3ZpgySXewLzV+ArQiPtrPe/iWMHt7bw6rWFHDrXsNZdWSxmPUakaBI2448gKVg9PQ5oAT8spCmhL1LHXPrtO6VcjqmXGDZqck94JKNCNNd0LBPYnfHWoAaqmkkvDsl7jcjkG9HS6RhJ1IJD4A1TbA0fPMsKk+q5SKiM/BO4l4J128bR9v+5Xi3W94MngLFgJ7DxLSsBiUCGb1aB0dz7zTqXfHZfBSsKeUONgtjqaKwnth9mVnYx/3ZF1wgYdWHEy2M8IsrGPv7toq6UnzSXMclweaxNstDS3TlLPNnBJvZawvDn06J+2qv1RfEwy+FRGQfdR3Tp+AfvuPeUtTkBRqcBDfBrJyOQg9hbey1QWYhSKR+yfdhsh21a7zL8gJ/XYYFfxYkHwve3vFxL9y4JLxr/PFj31t9cUtYC4K+vY++2ts77O/5vZ+vfD4ttN7hejl6VgU8mDkV5ecCkSmJwepm1F8bsS2qYh7anzhmX/I/Bo3b8ITZHh8FJ6NMv8XZjuNhPecHrT0oHs9aPQgDDcGdK+H6Naxb4Zbx75+bj3H0CFuSi+2whanfoF/R/JSEpb3XFDqX8lvjH+tFa+42csgMn66f8g07S2uajURufIC/3mPf8VlMvm63tv8OTXlhnXBldmSNSZRpoqvxi7Hyw8InxuaGocuOy/Cvhz1kJDfosCcmodL5bLWXEHvenyIZj6RC5WY89HkiJu4nF7rr+aoTO/X/Y2vAk1Z3qz6F4BufIF4zgc8wRObKG0rV7xweeqOK/y7rMfpVevlqnsb/SSUvbkbZC50ukIm+rvKS5a86CnA5pe78Z5jcbmTrQePT7Rqk+q2Sfy1W3xhr7rW6isfAh7g3MtbNf5b2ZZuLatBpILiMyWxIxj5dcpjvM7A7vBjpenuXL3OpljKsoz8NrbiZk3Jj51sZzO4YJTK4VbiSjegr2EaxGSOKVzJgq7AmQ7kElzis0q3lppFhQvlpNaSTlKHWuuBclwCRYls7VhJKXgWqIV04VgQHxbd2cCgxfT6p7vQMSpMUCV9LdICk6OWhQbZoenbbqeidrHtw5sCd9gDt1gE7iAoG0iXQ7GlEJFVtncnsNDYBOsNAtRUPa+rqDfANYAcPlRvIMWqIIjPKhRQMT6krKSyMsBWOL4V2Pzfp/gOrFcYDvInAEq6ugzTjzP+rKYYGTz5YlKi5C9rbgZ/yEbGBydPaV1iCMDICanhpNYkDd3yBxoGrhTwwUhzOzrPqpgKqstKBgDdp7hPXVWTM8GekQVHRoboaEAiBiTRgKouUelHE8ZkIR2augSanR6lJ2qRdLow6CK8BoIC7ScH2y5Pxn8nzKQOR9Dt+qVktUtJaz3AiKfSG9QqgAhJ0wlz2c0riKSLBi1KRMG2JFhtBqKKa1HOt7n4WIiiHF9AuhJ90MC30m8uAoyajXJxtAlGw2kbkhyuNhWPo4JrUc4tMldKALJtXZbdLi3JZbHLYqbLQrTMdDmUUROAgJCjihWSrNyQknrkvMcjgc56V7metLA26BGTKsi5EbCEloIN4NBtm34VSOVkJn7Jgvj1h3MMTrJD/Lg2xq9y2DnW2o+2hoeLcJM+OVb9AcOA+6Q7HqU8EgskLv6QQokS9IbeaSxQmlYYdQbNUNn4CipWPLS5YYIblilCDq1Chut5TKGoNqy2rgyKjaRVRV997U0F/X1tjYE+KAt6E5+usvRChkEoGP2W+6oRhUpoP2zm/j5QjJYtt6ckBT/ko/34H1CJAegKGELuSRFPW7XC6wWG5x4U0Hj3A9gRZrLKc7uau5Zu4yFL9U+5Gh6OOwW/pjcWq3raaj7skJfrr6LI4U3yJmsVFTs6m580OR0e8M5IP6LOCZYc8yNVQRevuuxBKWcPTe4SiF7BgUexuQLPGojIpBn4iqZCVbgZQkNZj/ysO0K5q/yob4gNVtTniPVKH8j1oArFi/oYSqJ4g9yQI1QiTTHZ4OmGa1PyknxsIEXtpS0vr6MwJ7Npg7p0IzEsx5uLpTfq8GxrSRM/hyNVlxh1DcjQnUAK8OshAV8crDMIGYyPJb/84ytH7i65XMZbia8hH37kCIG8dApJix+0XtZ5dFcMQXTaZD62eTMAtgNCtakIV1ZatRrZl/4g0sxti2blL6WjAfzvdSZ4++CwuZVbQjovgReRgSMZZ+iiGXoktExhyy1PYxifYtQIRmHOgz5E1oZTjxGsHLkhn2+g7ciV8jej6IJLmpRaFZTJslo2doV0Z+QQXeQudYQ+diP1qMKcyjGtMdfq7yc75SlCcgAjlK6XZVJFafjrO1wGiNbIMAymAbvG/ktGid0VTBh5q0IyVTXZKR0PJJlybnh4tmEakillQIdI4JS+tCTwkvxK/WeWMhwd6UPmentYHwoUFvavmvzwU64Chpb6twSQxpSbcokzLu1Muf4P9nBlIxUSPW6E6InWRoveWNdQUspewuJeoJJzxES6SklU/okGCsZao9vPG0BntvbUxb1pwqfPgEfDgF+bnj2HqatpmQplw3t/ACmU1tqQ9q2fQZpvnb/1G2prqLbJbv1gM9r6bhpO9OOxW3sd3SjcqMdu3UK5auvCGitaQSsalQ61b6VD699V9ZBsO7TeiIHIoookR0U5qPCXmvlJKc3yrQupg3rASxFLuhzPXPpkPCqDN+gASqE8fMjDM78KD6/Z0cMSHpa78bCEh4MLMZNfKMPbDa57BaexlnTQ2OJx0Vqz5BNjSRJjgPfoB0cpdCWuyqMNKVHOQ1vhqfxQC83N0gpnTHtEtwl1R3ecPZ8zGAtO0ygkd0jNMbTXbTuhWYUQHOPHHlKIX+AZmiCJTGtp3q08c4LiRzTLa/VYpoDlVtE8GP4c3fKJei9d70N+oUwE5FWzvfwn+/KjzT44CEyRyqPdRplUWrcPKe8sB3q0OG2LblCLOUG1SFv7NUlbt8/tvWikMCMjis5ccMLte6wbHKMq3Vr4udftu7dab/ZJpJYJ5XG9PB3jS7RfAUxYaSKAuUAfAZQxYV2+Dce1k8ZxHw8Wu3CwjDBYvlJcMVjs12SwzOC6yriWx6gKs+J2XL+OY2sPBhIGFuO/LMNsz4qgj/Cp8IuXJLAHz61Q5MprKYXOewz9httjjnIkYcSAjWqP0a5xCWGFKXUKS7xN1q9hlhcd6omyY2imVujOK6qx16GuYJlYVIVyrFBwzg2ufUV73uWNPSG2DNA+CDUWZliYQUZ01qMlmBGgHsAM3MEo5kGd5cUNjZVvJa/mSGsj+7HszMRWH81Vfhi/iqLnsGa0JqcdzkzYAusSvxWgKwmSYVxatezlNEQslm5pYJz1z2+4xEceSrUIGJcslpNaSzpJXY804xIokp6lVPouGoNqYVtYEh+WvUkLxbueAXQXekZFGlRJX4u0wOaoZaFBdsZ4O5W1i40f3hS8wx68xSJ4rSjjgh5txiVCm+2EFhqnwfoUIWqynttZ1BvwspDDh+pTSLEqCOKzCgVUjA8p01SmA27G8e023GxjRTG3ggFij/Qdm1rRSvrFuCb1Hdtp1y4V1OlIgrQIM83bKPwKa1vUhWEOXWAQdPn5vNbhl5WZdMMICxSW/2N6fsMJ0i2Nj+Syp9RV2GLmWMepH2zaM6oiC8DFC62Q1RqFINJgryKhqlXcej6VbjpU+j8Jlf6/yyY7nK7rBXT6NUKnP1To9EsW0OmmT6ejWVPe0TC7hK/qAfdjPn1whmHSh76GaZBzU0nwUJUbPKApViCZ4MbhmolaEWPpvpg0HXrpZgBG6gFNiXZSmbihwy3IdCkZS4dRE2rH0qFI7tq4bYrEWqkUwa6O8U46ikXGFMyji8is2cXOZh9YhOkBwXS8GNMDM5hKO0GQMC3Y0JMCyaslxbC+GYH7m+qtxKIl1JNDJLgEMVGFUiqr0AQ6oxYYwQSooDWPPi8W0+c60ucpmokPBXskv5Pa4c9JD5K4z5+jX0YdQ9k3xFAuSFr4cyR8fPxKmSkpZvlzsSCgmEwtSIVA98MHo7CQHhNmEzpdJtIVtUjQx64I9H/uEej6ivYaIdBJ6wyBPi9Vyk6up2GUpvMzKpH2nbQaRjVcFTXlLmdN4mjRUbfM9QWrkOs8DI18RkxGjUA0lCbSK+pRwVVBE0jxOMsUfU3iprTKwsDJ5nc4lvaxw0o6lMFSTHtwldQKKJLOy3FQjP3ENxQxyfvxSkdwKEgg86Gd+xbqnGskY4Q6p8LZkPQiVy6KnI9MsihyUuU1zSfOKYZRBTKV00r6egDXFzPEOUp8vmEQ9JlzpLbU7ESdI3EgtI06B0aCeT00KK4ERmDWV98MuYOeOqxmc7jzayJ3DhnGoQD8C7jzf9mJO/9XVMpsxJSfU1wUufPUc+cpCrIedy7LOtot4M7/NDc5/qbjPP7cbOPPzdeMPzdXcPxRbK+YkDUICxhQqRD+HDcCep8/R7nEaEf+PPaRL+pDolkFizjgOxPoBjStNOaFdRSTosugk5r5DHpsjr6F9ESnixj0Uhj0AvHqMejca9xKMYWOTsM4L2YpdEwumIgeECn0DgpCoc/CW0YKPbLVeSSnhUIfuX5ApTmQ7lLo8yAfdCBfaotFHLr2WGQyl1VkKfXITFIerUopD0on+HKqD7osOnS5tM554qPWkICxBeVEk8qsAYGBG8Hm0iFEso5kkS0fSMB5TA4YHlKHUi+rUIaqZI3UY+jkgS3Pe+kzEiAG/cwZwYdp5sCamcwZ9TIn9dhpocv1Nrr800ulWjf4K38zpDnUGKZG/XSr2mKGNC+ENBd4ZljzIgI3S5sDJo3KGdocAcxxL5iB1cEX1PVpc0yeQpt/PBfafL9Q5vSpeAhUi2jz4RzabASSuRLafJYaI+o5QbJvrW5d0CyBJBt5koxuFG6EJBsSSTYk48bYtI3mk2Q0+EGSiXWVw8o8WkSSCevFkq5gnnr37sgAEMPndABn5nGAu3Hvkh3dE251F+7JkUAFUm8QSL2KGDwkspZE0Ji/uYgWG58SVlKiApVXHa2rQO81pEQ5jyu20kfWhVFbXuFcaY9Yuq8iYf6x3BPmBoQ5qYmEuefK8WOvqyJhLpLIMZo6l/uE+Xit3iOzwDgQ5hVG//hEvY+u93vCvBIBIcz3BaJ3PxwEpkjipd2GmAnz/XU1N2Etx32JE7bsRrScE1GLhLVfk4R1+92+wOpiAjUPaNXlJ9z+x7rq2PQ4aZ/bD2J3v0RqTCjvqcfT0b2MyXYshHkEsBDopwAWwkUX23BcO2kc98uhw8KRsjR/pOwCV4wU+zUZKbO4AtRwCnHNDKhfx4G1F6MIo4rBH8sY27vioV8ObLlhtnzvSEeOuqkiWz7wbHnFRrWPJ1YrPdid//s2xQOdgbDl0YoZttx4thyWiUWVlAtbDudc1WfLK7QXociWixl22zIUDwurwJYXHbb8msiWS6seWw4lni1/V2400WdmAWNueow5tBpSB3YSXymtp0yZQ6FxKX0JZc7dOx1FiyaFTw9ojDxw4cbhmplYEWPpvpg0zbx0Y8FrPqDRXV4sc7iVbrloLD1GVageS48iumvrtikSc6VSBLs6xjvpKBYZU0ztLubYXexs94FFqB4QVMeLUT0wg6rpMmMZ1ND3SaHk1ZJiWN/kLhdp0ZuKRQXqySESLCAmqlBKZSmaQGfUInBZl/bh6sEO20ILE/sNrBq6M0F1GVVLNEW1d6g94OkmIpGxm+WNUxs2cKU4KXjwBnzQpciLCY+CPkWe8hAVitxIQ3kvtfAUecpTHFbuSijykqqEIh9AaODKWqNQ3jXdRpEfVVod1v/P3r8ASnZVdcJ4nWedqlN169x39a3b3euc7iSdJw2EpBMC6cIGEwOS8a8jM5/ORBMcvtsNkyDyMRJIhwRoXtpi1CREUl0XNQpoEMSLvBpFjQraKo/oMGPQgEFQw0MNmsB//dba++xTj9vdeaDMSCe3zj5777Mfa6+99tprr73Wy8dNCjgrT0/zhCpkN6uNU/U0VbMmZK/La3pjG6ilt6dxwT0p2CDWTWz44WARwvCsOHrSmJe/7Kl+klbMBZC6CJtoAfl648KvmlL5TTVg5VtTKteMtb5mW7/jlVp29tdGaKAF5LUdr1LbsRisu8VobHYfYkDcTg/EANG5Pi/NMnauJabx16qxVC+T4hl6RsX//dbAICw7qKWVEdOV6sMCRg1vH2Svx7fGmMjNiWSuegsgzV6+8yfrg+ymN5jbAhpSe3uwiZe+yvPFgY+z31e1dtiRO4ttT+zttV5VeKD0fTHF2UnZ1U3uqx0+rGrYVuEdRlRhuVxXJr3CoZ+QZ+2ewfEbWEZ4y1FUeqcXqPsu+GLwtDGjZmBvSURdabwH4q9Sr4JoBvKcrTnyHDTwXoGGfMdffaaOrzQfYF3J64LrAnd8lKp5Wx+27dOveQGa7B3fwYdrDepQRy6+QCRE1T73GF7gcHEm+3t7rSMPbK6j1mJ+aTtw35+lv/+Mf/6ltacO9z3vp5d+43d++/4PsFnAHzjr22++vf29F5cWAu+EKw9nbPDul7/nj/7ojLc+ZbjvrK+/7PcOve1JMDZ4840XP/GBD74Twav+8aPv+Y//dRe+//+9/Mq59Gd/EkEHAnUwEjhDf8P0tZEf8spNXnYYIC3CW2WtKEKOuVVioiN5DOAAKl8Dasv4aKK1V0ChVoN/cK4DQnkrLFBG63msGnbxeh6lWsoHYSlH+YMRNzAJAgfDy4oGUPSY3KZhVP0tPEt/kq/9X3cdhAmP/p0cj/R7yvT+4Q9zsH8/fjnnF979JhTW7HGmo5Iy+G2kcEQzreKXN1zn/up/siLsGuKXBvLo6iPTR6KP2oDcF03OO6SmZMUj00eij9rIELiggZ32FQ1DX39nk74iHn2Vp/b1d6Wv+B3vq6QM7ir7CuiLR5hbeWTpkfdU+4pvmvjmYXb5bvaTBUP0eZxSfKuwB/ue/6anXf7J9l+yiyvv9vX0Vs8Lrq1Mk+GQcfXaj//Rf77wzz7DOP/528587Wc/8595oshkeNnX3vG9f7X1d3kGffwHPsQ2Ns+AYc2ffwBGNq9n7zZq7NPZzowoAJZeqnbyOa84MFDLQM5IpqDyEW7OEYps3ouHgyPpG9G2UTJQ+O67IjhShC5ZbHKWjvEOL/4Bt++fuaX/33/40NKBD/1HtPSZUvjP8RxEHumxhPZ9bM+hD3zun+94P3t4ece73v/mv8sxs9/+XbcdfPbL38h9R8MZY9nEa/qLTfGhEsGHyvHdE5X+tAaGdPEkvBdWmSo9UqrGmW8rAvauVTXzqv63AC3zcv7e54qZtAd93mL077rLeIEp6eJtN4RqDU5XEUsbysDBChHi/rjwbT+ARWXUfKzxEHbwPU/fsrT3qtwn9zYoQhs+OmCQwwAGP1yc3mIsa6O9V1ZaQ8E6Ox1881s+9G3/4W8WnzbgV3bQUMcDnhm+95n/8CNXP7jjach5R3JDnz0qiBuL5KEvc+rKu197/ROOEFIP/r/vv01STcqp9xW/dmeGlDt//qEjlZT7jvzcOz903T/2YUv9mu4tlZSLv/yn/9B90ceRcvjdf/fKSsoZ//U9L2299e1Iueeaa/7fSsrNH/n+r774gZchpfbS7fsqKc/8ysHLP/fFp0vK+44tVlI+/+pXb3/au2NJOfjXf7HXpYR3Pyd526s/uFcAs/DmSsp3Pfl9L73iP69pysHLKynRaf+4/Sfb4d6Kz4k8kSV5n00a7rOfD8TBhymE3woLzS9tWjtSprcYKdN7iZTpkEHKdGgiZfoIIGX6qCFl+kgjZTp2IGUaVmmKxUOLnQLN1Gx1oNtScViJ5VUN21Lpd8/YCXborXZ9Rx2Y3KaWfCtcUrZ3+KD6h30+m0t2uY+Ul2CHufMBqTziTADVy9TVBdvx9yt/3Qqq8dkXTazPsbdOy+5NZr81r7lrxEK4a8Mhsw9UvxUm8G/FChJS3bU1+3ndnKj1azP7u3uH4iyTresO073isf3s2s1fwq7FEy+6sMmg74f+nH+zr4gOQB/OFJDKD478GYlM098K/OS6+Nq+bBCw0znUpRoseB3sEud9S2zucrN4BDHkI453XMjIL5LlwdRYlrxRvlmA/IefvEWM8OT73jGevGer4wn1phIyOPQF4RdfXGsavfd2Zh/MlHr23nWFwr4Hf/GLf/KsH7yCx7upx4WaXal8cx1xdY6j5q1FqjikR+ixRFJzkP0YykFUJFHOGLRmBx+t6SHSU7WKfCvz5HggvqkZ8zYOX8vK86YLithPvqZm1cfOzL4LLttx9txrH/gRcsEre1IotYY4rqJ0mIuHNuh8AazYzlo5bKPCXzXM5XyWekuWWnredFud/UPAgvOMO7nsHzXWHRef7XmlTVcPPzXjKUdVET0xV7rfmE9I/wuMewqyDcaQTd8XFFOyBxRngUsZD/fh3z+INpjd9W3ISqoUUHhompqeTdPneP6UPtSy619hirtQ7EG+zRSXvQLx2NSR9NDXPt6A2FGPbK7dd4y2G++bt/vukXa/ZdN2u+LvHC0e75sX/5WR4t92EsVvjBW/cVyo/0G1+HedRPFHR4vH++bFv22k+PedRPF3jRaP982Lv2uk+A9vWvyZNYOQh18xUri+H8N32dcNoXtDwLt4eLx0pEfs4BshVRE42uMZ2vNtU2gPBFmYpNEahUpQNOKoj4i3ViLqa+ViVkTmq+Za1fa7oyzI3+L8FBoqJd7tNL3CUIaOZDnipHtZU0Fnbd9u75cX//Gp96ECCjWb5pI8XoWQqASs8LnxICQOMCHomwAmQPJdy9w0t2yafM/Zu16YvTQK5lJm13S7rRFhpaYQcj2QtUNK1UZm5ejg4X1zzLh3BDPegqwnmpWjxeN98+IPfmRkVm5a/Et8OYnXeTlWgb4frY3UgCVVjD/fZmqgKefdzJ2naAbhSea520xhlDoyX0erxfvm/doY6df7TgJsd40Wj/fNi//YSPEfPonij40Wj/fNi79/pPiPnETxd48Wj/fNi3/9R6vFf+wkir9ntHi8b178HSPFf+okir9vtHi8b178h0eKv/ckir9/tHi8b178PSPFf2HT4gMWNP/nETYkrNjw/RWY+speoyJrY56cTTvDQC9IkCzgqnLkZderLwoKq77dA+PmS52TpWc4ozPJrIisJWMu0ca8+ytU+v2STXijt/zEKyq80eHrNfbmkdifMLE3Ts37wOFq7BsR+4i5q29o7s3Yw42Rbt003oELPX+0El8r8bMHwGVpgqbqHRLvhDXeM1LjT598jR++/gQ1ZrX+F7hw7MBuRt70TG6CfJD7iqQ1e/rsZ7e9Hi17vWc//mPPMZ+73UFNTTYlu/z7UbBuFolfv4JXVUdVt3NYeZEHJ1nOE58QeZyxq4UtsPK7LULDF1mSveF6xVmfgUEee+jPNhTd+bSt/+uv4SkjSdmt12vszjVN+g3Y3c/eJLEan31SPkSDfkwPkHZrEibUu6Q9wAljAPt0nxcjiPX1IVa60nOsR8J36H6vzO6b7L5m9zX7rf4Ivx7v1GBNPCnqxHgQDwGagl0USmOqaXk6fSjOflb7gX2OKsnBUVyqc448NEmUC/3szcjY8jZNovhp/mTBMTazNXwjkbcLcvRrOOg/jDhtspn3t+FhLG2hsapr8lDKBSAHChigAKuIE6G5kShbxA6Nb/S8YJp5cHOvCvgvjl7MGWBXTwQX+IHhZrqrmEYhUCyw4wUWSm2bq1HtI4oVfCMrD0rDac7EdvpujBDKcd5vihBaC8YBubSGQjZizHHPattuwyAwRWqNDTmgtYGYtcIotIbCGgZWWdIqfGjrrH9P1f40DkVUfArHFoGtINAKdKuNLBzOjt1grFDLCZT6DXGNt0ZAyNzQE3kw1Dke4Gf90l72z5YqcQtL/dtqUzdrYyANyL6O7x/70XN1V0dveILRe9Vj3ArFY2lHVm3H+gna8YvwkTTFJ77UDiphL8bJRbEQgonIDZ8MRoyhkDuGjAAYQqgN8V85hIEdQgr1TP5nD8mmRm9bxgb9IwEhaFKEWl3VMRe7X9DUoFds0Qu1cvU+vmjp1UYptC6dVCs71twDxYApVyI1KBzwQFr2ZjRoRdBQ7Zt4Va8Ab0LqvxGofuGGKqgU1/5NQXXHDZuCys2xt548qMIRUHmbgCoYB5WsyaOgevPrq6AyE0KBlf0bAev21x8PWAOkwpmZMqskK7SseJ6ueDBaf0FwJxLTG5KGHPfzvtR7Gf/KnwHxnUx6G9ZSerktF9+d+BYXAIdH9NKgzxtwjxpwRDHAk2nLzR5qPpCr1mwCWDSwqPIDFthxQy77eTRH3FmlpeeytN86UNTkFbsHdTGGxRarrFt1C19NveMvgQakWcChGcQ13OzBo1VM9ewXUAdaKdpHuLDShWQ5AXYk08oF8thrPC0ZUTzCwixjWBtqMmfevcdXA18oVW/lmMWhYf3fPfh1yMQBkZaYHNNdAMhoo3/QW9M2a3NBdaXBdyALZ5iy028/lIZXc2F4XmGel5unnkekVVuf3rfJY0Z1kuqVBBar5x3uTGZycJ+0lN3mSeaZmWdNM8LyhS+Gg+qQzBdzlNIc7KXN882z/tWstCB3ALi2WETa8RqOIc5gIC5IAaSP/9IrFgC8hstAC29EjOKGxC7ohzM0Qwvf30OiXGyOrQDbR9bc55ZkMJiSqPmyM/y9+Qwe3FhRG6CWjBt1KMXfpTD70N97zZq0MKZ408YtkKk6n0HNQJpZbmU+a3CHWtZo0cweH/Cb5a/QcwXVAhe/ID3kGt6YL4y1vgP48Rhk/YO0lmfk0cJ7IVuby+s0j3L1+t1BnlEGKjmjGhrtYOTLDVhfevD9UJXVRvva4mptEWZmxg+A9L1yh5Cnt12tf8D3mQbIQQ64JuHY1cGN7q0di1QEeubireWqCGmvg1T4JL0kg1qVj+Nn+ttx4stFlODaSJ6e1VI7umy3ARjfQ3DdLsyPOxzzsneI05o6q1fkiRLKBvIk0I3GA2z0LnFIKDdqsjuRH5bNLhFArMIfBr+xTjPxBZrn8GbvX6RHYL6pQ50DRZY9iJh8Furn6PYsaqnhEv9q7ulZEyDHCD83FAtT5dsAXTf7EA8PjzLw95lBjsYBXIaD9xgUXJqLoQ5u9Xho1zOL2v4DDFVDpWui1+xRh5+MIDN4AK+yQHTIbOuKeeLWzxMgZl32daR2qgGhZtCIGWkEcIEapotcJfNpUkTf0yWrppt/uaGXPYRctv+zFVNg8pg93Q/zBcRz4Hw/BN7iEYOPfN8yV/W+ZZV1OI+TKTxFz1GTgTWkxEiET9/LZ5hzYiGPGxugunmtFQqiMxTlHQb7PM0ounEb59S5IsZYVXEAebv9QGyeiOZlRwbMw4Dho5DBIZ8kw3cLiWEIAUwijGINVaXYHUxwAJtrYPKhkYJxc8TzHssvoKg9oxhYBXZZUCj7mmITAzbkyFUkupz1/odr8HkAHK3G7nGRbywjyUW+UyN5gtjt/1x6rJGyBEfudIX8xJQKsGZf61j+umaWiVEk3OmKahd3R6KOVMYAyGncMeCHiub+fqa3Tj3YiqPA3IbDlwgkw+EQJwRmIdP52DTi35tuKGWEoCLvk3ehKx+W4K1TTpONpBjpKU5cwTKoOHastI+40j4mwTdtVpp+mvalfmIHXAaWtW+nlH+uyVv73vC3vzb4p985/FQoT5UvfGOxLQyIrIh1sCtJX6qFoUBwg29HSWAMgHSYySiVZpRLMXAsOgaSAGOHmmAo8gwchhSVz7qFeM4FExec1wV7AZ9IF/LFSuLUT+bQXm6gDNoCbrsWGLy2HbwlWioHb1EHr9IgwNtUVSwieFSCy88ouqA2eZMWZTo2pTDqgPhh9lmVaswe7vUypk3phTTidnQPrOVbStqFwrZQZq6CvjtfoZgySg/AjFG1Di5e6qCVmzBjuZZwohbKMFW5rHKqZsVSxQs80L/Hnu5XCXi7yiObyHzmCKbaEjFH89SjpeGAKc8CSluoTgPZQ2S6xM/mHW7+LCBzTCDTfUaxKJDpcGwCWHefgXdQoSVES0c6tKTQ711ZLPfyDmojDnCs+cgAzAelyzhuw/RgcNGQOviSW1fM81fzR/iBnsxf2VvHVHTHZAgFrI3zVM6aUPBcXMktMfoH2qCBAdyQY2AWRbQRoqHKvqqVKu3ErGkP8Seq6b+kGv0JDzVUVtqVQ8WAEm6HA7gLXtkbFombXy54Fc+ulgyWExT8Wj3G/gN/FbdoBwNHyOr9r/hr5tJN9usykQMeXHkf5txhsSXKi+kGqJCzCan+bYr0GXq9VkxfcXzbHl8Sp/jSnICXZnVdUwdtGXg682/mJ7p+GM8Ga67g6bFCCz8neHNsCu9ABmku67RIGDw+heUAZV+6QXoEdl+YgjpvOrzCx/M2D01V8WGknZMBUs6zbLPD9ryJB0Q5dVn7tJFcutlj+Kl2A83t3+fzJWJtj266xPBm3tI2PCAt+IruqGT9beMqFXGekFoid2gpg+ADhNCNalALhsqzL0uPUFjR0uv6zP1paUWDs6toweqjtDHL2qbKBgrW+VUHA3nMnwbXYoYheze4fE+hKsuYGZWWjkaloTpMADAvBBtwUC3jcA/G5IAEj+FqCbspfh7Vscm+gh9chX+1JiLfVTrul1Md1hou0QcDSlHNhzO0OvFjDz+AOxfWnqOglSL2oGYv+4oAJhSo31Nby/5Bh/5M7otSonv8PETTtQv4XAfO0XQoNktTFBWb2mk8DxmUvFGfCgRPcc9iHWQI2T+i1qnoIvfvdZYn5eWjIea7weHxdiEc6LTdXHUIS4g7qfmaU6s5/mdYhiZOytxnf+N74TQ3nzrZ7cbEiqoh7VXBtDnuCVUGfJmJizjLi4yTkn5NnZir4jNEyurMCxWwDNRXb5A/gm0PMhgpUcCRDxopUSSMZPZPIlALIeEJNq8l1FrQJjVorD+QWBXe/jyym64I+awwHUViK3W6n5xv8oN9FXN6KFH98OE8VR+hPJCWPXCDcdGJBlmH2h6WWz1aqoqNPou8tfT9fhAKQXbw0xa6MwBjTU1iighFkweDbGi5uX4aqOkWvXCaqOGWWKyGYL5L0RgjCgVSYPE5S2y+lhWqXjkkUDsruqOMjdifdCc6cQrgbXIKkAAvUB3/lXLRZMopQJHoFjd0DZroSogGha5BTkT5HQ7DqXTtSQEEZF1+YBeujjUTI/sJgD2/cr3uzIJyYSQv/XE/NKI5y94Plkvkd1Qi0BEhtW+3E/dsq6kAJhiJWC7NxMz2BHIMBQN7upj4/Y0lLLCB7ptzlXsCwpN7cPGoeDlKfE72q4gRkWWkW5zblvnL2+z2T+L3VKPfWEZTNVo3OupVE0iM2m0R3GULkCC912P/ueoUGJzsvkt+5X23fumTP/rUfR/9CP7df3F24w1WawZbdhHCZecHe0hidlOtPAYhhIVeYL+liGIRGo7QBDMF7RlpD+AYi4f5Ekw6uJlVj/UH1pD3meoYMCvqYCFEcovzvR9esyYh1SBNeUxyuesAhRsVhrXHuqjPoVr64TDA/q56shzZ81+z9tWET81jPCivI3ZPnkB+I72Zypx0Qegd/wZCL1tOsLkbIhvqd4XNcvcBwp7ht7gRSIrgXBgb7+x/GkSJ5CuRVJeEG9DJPoWQ8bRYCCh3F8ZQIqnkTa+AE18U8a3yF4HxsaphXYql8Ox6jKlQAhSkKBthBq1yOj8WKMLmsCWPYJe0CUdZXYRO97uQOCNuF5CrDJFTs3aq3yawc+++L/yHjW2v/PwfX0xR9golLCK0V6eVWdHQrnTVlE/uW4OPh4MiFKE/b8Cgm40FF/bkQtXvxckwNHC7YIuwwOF5ZFjqyK0PIM400xM9xQZcLprH/ZsDxkEjmHB9VBDdICCKKooC6Wt9XAW1hONYbYQWkQd2eVhw2bswoPcviqEXcfMaTMceTd5NAYB8CQXwXs4N2CehuzD79yIo2LAHoYdq/h7+MEFYIH5uBeIUMp4Bwv9h4x/5PtEk3JUs/vnrDLdPuY9HN9cbyjkOX445L65c2IWv3/2XP/Y/fuSp0HY88/99y+ln9q7gsLfBF4QeptrLwIM09OWTeh2+Umx8kf2a0j7VhcnebU5VApGVSRwFEJSBUAit5x6zNAQJCkHJDc/XwV16+gCABV0G2DG8q/3ds7jKs6yGjVMDSX++0bQLQ6b7pmsrY320XvGojLqyqmA3MJGK/1XBEOOUnOborKUiVlmGuhhzhENWv3dFvH/h51F+Nvn5EX6m/Lw/XGO8FMsYX+AtThvH7Pyc4edNPsvX+DngZ8bPQ/yc5ecxD3a58jkO3s2lzAv2Y5Vd4NAdHLOomRC1xMHDkVSxjPy8RHexvvXvrIM+xW6HiCBuP2nXtlwQ3FHHynVnPV9BGYHbHaBEfLzS92iLpmUbstb1svfgqd2iXvYbeKt8/2H5vqsg7k6dNkD0lfP8Yx6FqP62qFhl2ZVHS656pGeafEdEq0wVua3FFnd/tAcSt+A+QO0KEgEVN9rnkYOCA8q4my1sYLl+rza9PLDUJuBbYMIcSXbMsfchI3cK0K6voS4EOyLcnNVsEHG+X7PVtObsA6b4jIW+IFjvqzvq35kSNzMlrj0Rp6YSnB0GMaW4hXsYq7mu4bDYOoTAPVMw5VvQ5XuCnMEG4ptvQ/x9Yb5dFvr+xnXYrm6Y69Gk5RNtVd8YwyHRvhvu+r3n7/6v915cuaFJ22kbreLvst5GeVPOZvjOvQPiJlXyo4UDJ7cZcoRcL+V8uJ/IzSWDVx+0sG6dx601kUcNOFYqcW80cfNlnANbOiWuWYn7kIlrTIlbnPLt8pS43mRbdJZxfKRTRvNC/o11qS7rEihC3a1BT63SXXuWpEqA07TxRs+f0vRi2WvolvB/y4x0X4VFTYUlnjn1YYZGj1+QLo1J/9ATdesJbTOSO/eHSn3VBa2xJQadyTeOkfEj1looOFDY4/OfwldTdbDrD6XgMwnPXebZVS0y7hFWSAqAxip+0Zkk/B4I/XdDY1ac+m/Iro9q2U8fMtB14PyXyE+rS/qIAgQz5CXJ+AHd6IIpp5rpqTHy7cvWTUCnWok1mG+MKEA8TjW2s0bEDzNXeImBbix+rilSNtnDwcTPqFZLtMmX3wngG8V9Co1AEYpCMR5Yuz1l1MA/YZILkFGyCtdVs3CP5tpNnj1Kf+CD1+ErZJRNmL+3qnQB0ZXcCtPPd8rn/irYMhFLFU1jUlu9h4O8lC0uUumtdrOlnU74oQil/RW3yDhJBPeW/U8wXGr6MpYGEBcfTJYLWOjZVpxquV2dEN+trutj/otQM+K6Th7AIHkxRQfQbqXJACDV17gaMVGqhy51AUAeyOjnbWAsOCRP2ihO4qXJ6BNCCyD9Aj8KxclaiwKqK/TFpAn6mbdQ1yU4Xa7DYBW1mUzW9bANPZZteiSaNdIPld/ZihIt6QEZxwZyNaqDhLrsBwkYeHyVfRDAVJ/TOrxKcjiT4/HSYeA1qiKgiakcQD64Cl6bAp3Vgczqvl7YqSm6c6L1a64uZeO+7u8DJKwWkGXUVRyhjtKET4R5+FX1fsc9xfh6P8xkK29qoS2ODey2ILACaCFDclQs+MHCZvQoA4Fq2HMSCUJH9jpc8/Cp6Sy8wHxPNkDXpGxYGvMUlSKU0+qLd6c1LHO1S3prVHem4asdtSCXQrSEVs6vqrR7BOWPdQKE1WxZlAj2/UshhDFtV+JKgTr8rtitCdJPxWw8o3mdkrZjXuWcqsr647ztpz5x6n3pObN83lawQu1dMtUgsaxcfYTrqFr2XsHJpvKsl5O7HrTBByQxNQeDgg1m3u3p7mNYxKN2N8BIY8vAVQxJSgRKmVJD4Qf4Y2zLhqaglBvx0oVf/vZP/+hNzOs2jbRLl6+m3KDcWM8F9ffpVNmTt/E4K5/Bg/KOSuwyPBby2f7oGR9bCJoP9rqIEMdKNAdR4cJasSj+0FT16TqM9zxGVCwHZrTALPHIhzJAHRzA82drSivAMAEQNEPuZXA7tSuv1BpJG5C/sT7gl+iqtkeLKjqEyVXsuTDuENvxT0nJQ9iMmWdI5DiRCgc8vHPAuznyjNqUoXFQAhmVZo+B8CZPYXjIUyBeq0C8WoH4HAXiVeNAbD7mQIwfCzAOHy4cv7sCxybg2ByFozqJBY4LYv5yM2zxTi+u7PRq5U7PsTCQA08XAWEZqRr3KMPn7l1/04NBIVQ93pAr0SHkDnswd7D+g/mDJG83l+9z+Kw1FZBn/wsb9KKOKhErjvKMmgliaE0mg8bIhnFBY/rBmolsChuQc2dl42id1arLUPGw47xPYxgZdXCqPQO6NqLRxgM5A9Zt6O4WzmC1mhm9u+iuCqhoHXtTZdJa/H18gMLylH8sHSaK/bXRLHrUbXJ2ytbgsF+x1vnFoA7na4maCybCnIoFN1TbpZ/kddWZE7Kt1tg88nmMBBCKacNB9j6hXJ56Lp1ZI0/ur2MDXbfdjWUYVSW2A0SSWqlDc+AngGydtqgXdOAWDG2B2yGegB1uDAoWY5x4LHKmJbXWVgE0LXAlS1xfR9oLVK9T+2pr/nlGGpp7tjl1StG4UvhPfJqNvLbEvU4MsdTj4SN/XS24+cCKJXRmiTqYNACUDFoXMZxeLNg+LQrE4OZIeC0L8f7L1JY5NKkgrKtbfY26nMbMMBzIL4dimEN96SVotF+Rd3RVmOApo6B2qsHALNO8dFUxLcO5ZpsjKt9WhbtDk7vwVGlJmjIj0KKuKwkEIcEYpdyKjlnPR2/ZLrtgF128rC1DKOKWJWgoHhD+uF7JJijm59VC5DzTL1toU7h/Pekvr65WPEnpxro0m5bVVJgqSbFiTm/AIOuSNwCQlDU041aXJmCiKrlbpIyWj2gps0ib5XK6gzyDKOIZ+QwGAUKgGbEmrTvaRCfaYbefXQAFKWPAQhKoTBnDFNFtl34njVoiHQv475uGYv7vR0sxv0UxF6oUU7NbgrkwTjALb9/Z37b6+b88b+Visf/ilX07+sHhsNLNRVThZX+nt9jIh3GufNHodAlDjRr84UkX6LkCRftKCuQoS7kXyRf6PuRZwb/fEDq+DFjo/N8ySceXuZItFTrefbh0fMsmdHzLJB3fgs5smaDjW5SOL9s+dR8bOr44jY4vbELHFx8zOr7wsOj4ogsujNPxLTRLyxN0fGGSji8+Ijq+OEnHF2kBdHzhBHS8SxktjtPxhW8oHX/DY3mlDboaHPay//k6e4ENkrfcK2+2fapMyD3ZJo/dbPs93wun6bAQBPRrVodFRSC6D3qbpxeSxVj0nZ7cW8gGUphmGFQzvGUkg5oa8a2xkf5NHqQJesgYQMtJrwuF7gv+GlbA+5djwKRZ99bGmiWxd4/H9nePVrVQram7aUW2loVplSQTkU5e8I296r5Y62NvL4dr2P8jsJ4+ncvAqmEuZ8nFcn7VJ7Q7JaDXxlN3oYg8o07125LwfC+YFEVVNJFECtR/UXnqG6qlgsoJOSAX9r/PDFHAvvSKAC8O4Zzy02sbSXSdL/s+T/7c/m+p1JLUDslDpFdPFx9L8IeQCInEW2TfVM1xY0lXTlF2VdURaBc6o1QtR2baspixpX/QVAqMml8OwrYLx3l1uZ8yy8+P8HNuehlmqfbEnzlX3/aUvkARrXrhg4yyST4v8fmCbWWirXRSNuO5qQDxWqBF1m1ZSNWlS2JkbFpTntguQ5RJyjSphACqL0n2OzKu0LjFrudoACy/XbB0nhbBVcxkvytNamhB71tyBVMDBU8tEZneJ5n0I5vlfdVK6zSHNI22qnY0W4l7o4nLXJwqzZSq1gCjtii7S49lJCr7PZnYLVHGqmuuZG2itgToyD9ufRIN98olAawLQO0leH2cF+DPi9N5PEIzIpTQgozH0GpKuWGYZ+SHHrO+tailetEYNqOVzrsvg8TYdVYWPS4YWfKudpB82T8WW9Qdl5azOCxWst+XEcK9TU4zTtx6tMj/dbl4c1lkCeBaEedc9ush64kX3X0/JP8+e/HwwaAfrWV/gNIgA+7ii26FkVjp602Tebng1aOu8nSJ4TgXUTzE9RoxNM1e1PYNscaqFhlkPwAK6lCBT+RabgFDrXW03G6EDZVo0/IA/iWA6k2jFGygJ7NTBjxUDZv2+oQm3bSZMX1KYGYvWYrdSp/pedMpH770YfIkUFpX1f7U6XREiFmVsL3JE1sbT/unT37in2744i/ectToKogBCbeJMYEte6k0tg/Ucob0sj+9obzhiYtxQfZXr5UTKsfDPXDx+oMB2MMUdNd7Meu2BlRDa0Hay0wUmIthtfQP6nGHd4+gvP5LfXsj9h6v7LU5ptxk45hgPToYQDsOe6ErSHTZcMmz/1I0QThV8sF7GH3sKLtPOQ8cQmWAk05P2CqLcFs5phDOK6WYPoEr8/A5NODh4rkBSPNrU8+KQrWMmKd6S5hDLW0Sn3mG2CXUtA35jCuxgxw3BhC7bjAxj+VSCTZeut2IMRc1tzib+hTXttj38iVa0Euxv14CcujgTrMD5u+XbyuWeZLxlt/ZcX/3Q/OyLeGWyFKZYK8sjfaoyS1+qBbWMNmk8C208tBnxWWtxD90r5eviDJZgVHRO478DedKQ1G7voY5/TCXkwzykLxIy4wDL2P8xGxCOvngglTMRXXu01xe07zaSXyMXbIME66eBXojVe6iBn0ohbgbwHLy5awrZmAhn0MzB/D8vjUBYWDK66gK7kMNX/dl2r9AuubXuJv5ip1TK4II1U6nNsZ0tQYaULPVBtSWXUNgjT0mEu3z55n8XiHF9zNUOlq6dlNf0AipbbR4vdjaM2Pm6esqIGQas0o+ri9ew917odx6XaUeohjRqrE9tO4ahUffzxmY6iBnAWAquJj3AmWG1NMnEMje96N5Fbzpi97a0UXGCM/1JUVvyvutr/+GbCE+67YQ3eoO4q9PsIP4yXpmr7wkhqHzzbv3Ug5NJTfKOu37LlGau7ucYMnegco+AixbMZOWioXqPNI2mekdq5ZBXlc6iVM5IQjwvwi3GIYgVL4AWEAQ2hRu4FL1Rt7BXS63OFdvspW0Yd7QhgUKyGY4BsPeM+tFpLqe+SJFxmR+BAqih+9VqtEZ4Cj9NjZRCBQYoxpdg4FbwNYo1VgBBUxoRalGz8yqLvVANRqVCdQboxrz/A31BHu3ACkbhmpsoQaSFygapRo1QzUWhGrE3NtFHGaNUo1GSTUaa8WKUo1V0IoVUI3VCtVQv6J2+raVaqRVqrGi5eG+TUk1umX/VipUo2cv3PbGqUbPUY3eFKqxQk2hGivmzH461egZqtE7EdXoTaMaq2bMGvq6FRAyjdk6TjW20uoUqrGK1l2j8BCqsYJGzlZkbrM0R1vfK5qMtKpPtnw/Z64KUqhkgvEwj0YIBEXpb226rWfqoNdRb/vJigG8m/DC2lB46O1UxKhpPM2JS6ySrPvfX7rBquFgbNEUVTRqFaA4Ts3l/ouho4neEzSO3orPJF+upreQyOVNppMtu5W9rYxU00m+fo4MeVhyho6lLUMDw2CNpLr77aXRJggBA1XkqJrb26ZWtMy+GqRP97/ZR4WZ/LukabxRlgQvvC4oLzecX7nzB2nDbefzM2JDIudXd7fh5O6W40f2t7oHDq2QMESc8AH1/uFlaG4eIo6qHCjrFa2KRmzVMrfuRVOQGigPwESzSWbDrn0/+0Oka9EUrmGDebncjK3gZdOor/cPElBQablsnPSSAaaba05Lb/+2KzGB7oCpLRd7Wdg4IjtvgnfntO6BIjNaTqFqOY3eBWliKyVD75pkL4F0qDnMZ90ObE7vTArzV8zzIqueoGfw6LDkWy6ilYvQkDrrclOuVNZiLN5tAFbH7YE6VOCyP1JF6Tzi99vO5yUIBCFwlzYpgxJc6wA3TJpPITqzqPcqFuUEY7HSHxfsiGNXcRhYiaQ6FKOWZEzyZVtEwQR7FCidogt2oyl3gTu6bWoipssxRxRYLxk13Nb30AmUfMmttCjq9LgjKLfziB8dVq3HgzBYfItXX1GDpFfhlIjg3+zhsTIrmCzcaE3Ss2OI1MONOUGDELXvptAyQ/K+B+8JvydKLUNchhRIy3ESCGBM8/gY30nrDO4umPea9VBycO+waPIpl/rNi2TkKTKOcztHgEobR1TBtWaZL92fyljmCR5h3gBnNzvIW/b2Z4OS/f3u8+3Nz1QvD12u2KJ7HoneU4l9YxlLldh3aiyTDkODnKS+deSW9O1BAMvNU0//PAZuEYE8ZX+jkkm2arSUx3gewum23KFbBZHB1YUQFP4sd8iHszuQbQ7JFZOkPPHLyhAJ+YuBJbh3VWoSlyyRTEF7vwQOE3FZJsFjd9EYIQm+C8J/UOXNBVV4m8gllCZonwjCAmoCWdQDpihcqnghkB8dzOzvhGONgRKE5KSowzEN+YjpEl4YUKY4HeEEF1KcfKcCEXchBUVC/97ZgC7q63rxyCeERkT96dt99ilTdU8MvysUvB8+U8BIj9hUSkbfrbMV9WIXqgZsUPp5QUHQSqt+9oD5zCToQ4sJb3FfTitpektckSdsq95fDJUZHhaOHEFv/AfUj55kuFUzBCPqc8hQS18H9ebYrp6Zu+CDu2Wlm8KhAjPGqw5rIjqxnBBSnQ8fG9RgaMG0AB5yRQk6kNmbULPctM8TwRZMZM6nbWuIvR8ny8lq9nJM9iey1n85iN06H9pW3n/WN+ACo7PAHqzj1gqwjnN5erFx6j3GPHJ3HCeW+ro0Q5okl+MgkRuUlw2HeQNLo17RhcLhFAlTGad3JMFg0ERkSvbbS9kND1rdoHiIVYhn1/pgYG41fuFiJHr7nij/Ps/yR68l+1trWOYLuCb0hbMs5UT8nmr0G8toqkYr7dS7mxPXLvXmpkaO39vUSPs9D6m7sXqb5/GQq+gi0EP5PHKmXM11qX5GUfYxtcpWM1F7JLPG6ra1mvnj0zJrLDj5sGp+aoxVVa07uQ9wrVi5kubojWZzkblCabXuypsOtJBJvSFOvkyGYfYJI81F8j21Ute9qsOKtqkPz/X0wIQbgcC2I8RDeTXgulaWA91DqVDRvz7MPqnLHZYUCLQxD1C1Y+ICVJat8zj4qKtUKs/wI+YRjKXEFwAqo56+1AHo+ggtqlxCYj6ghvIv7fHTx6G9f0Ct6MrhWM2evR8hLsOrXC2rmAXJvoR1Jv1p17pW4Wv7/MeucY+4XW/wfEhiSlEDDN2VSOgpblLtyhHixIemodqKHVTGHXX75ad++WkRCVmCvTSlYtfpLfKJ7+E/8i+iALpLpcHLY0sl7SytFuZBabcwD4HZeBWrjwjcgcAIMY1cMBYPzcFIcmxpLXCMsYypaGxprXJ2/efliVqTNuaSJ0lrA3MGTF7//n8xjtCyP68YtkhwzTXS86Eml9bkcl0vEtc32C9qKHWqnp5K7B4X+cYykiQyoiYlINzkHdjAzZTBMK9rVqFZ6k1QO+S6Xudo6RjIRioXL93hpWqMoAjT7dDdNHTAUFGgtY5p7kg3SiHiR5Y48BF76KY2VqC5o4MmJag9ygcl2LR2axJrt8YeqTWN3Zq+n8+gK22aUa+brQlApWNQ0rHEqAewc9EwnNlX3YaX2j13eRtEW/h4sI961BqZxVi2gGiQHoHidHw9+1/4EO64msBsDGwqTL+a/QFUj5WHSXW2mKxXlCcudeh1837NcOZ6AA+4LoFmgz8X/5TBVJ66ln1Z5a+i7KP2AYPqPQVHWf7T3uEgfUUQ4JZYOc1o7PZsQmL0e/qtr4hveWWqQkjQK+DgzjVIhxbVuRXSjy6awDEbuMcG7udA/3r/yd7GopMJ1I1MQK+YL0CuKUta0/pNVrOareqRuXBwiMX2sN9+djvAJMj+Qu/hUCu7RymQ8lmmBnyAZwuGdHDFhXTDVk+dEhDcKHNy4m7uhH2aZo4+loWr31Jb9KLf0/+z1/H8R7y1RR9LfPZp8xJbq/O/6Ieq3uDBoxhkX7sAxbuagKKDkKwYukgE7pJKjeBNZZECqK1EOlmwecA1nfiHKeaTM94IP/2aCzkTdL/AIPLd90R5a0iNlQ3HZgZXhy6B29AUBOxW4hBze6jgPYsw7yB7Aa7ZU3rRuGXf0n/86zf/SvAnF10JsDFWX8g5MbrYpjMA5RaImkEqkiEKHVZY+V72l4rhah0pBLjDai8d2GvZXwlf/feeF10rN1oWcx/Po4tyAYyxC9xO9kaAP48Mu/gvTndNhXpuzSwTxgO1sr/X9BS0Li95R8Bhw0GnD4BjDoq2ZOHvu/UW/Pu9i0styAv2DoYUlTNzSHFVsXR4u6q3h8NCTOtIUXClO6h+P0y/n83R27NWvSBqJ4qvaAxUkB0lbOgwvKoG3X13Nu0M6oA1UPs3/1o2928/dDxr6f9atuN//objt2KLXqf7OF4Ykof/yLgc8tIv+VH9usAYaVMb+bD/X7ukrQZReIYd8w5wWffVDuAsgKevLLmemP3BA8ugOFU0ZAxlpGz29NcdQmRfOmjuHwrV2dB3aDnQtHwzFHN80ZlMyaApqo1r3UooD5jMq+SQMlZlmYGmMdVV05h8ySh2Q+dEo6NDs9k/vE5aAmibcJvm5dQRy44rkFp8I93U4V/TG+oBZX9wnVyN0o6Y+3Jz/aMvh2LkLOJmS+2k/p0cy+snbio1QG9fRNEzkZT+adT0jWmHiP9iDofXhjoVsJRMWY5ksRmd8IV3JPeV6gcYHQzObt4X9Ud5QUj0n5HXp1qWbIzISlWmZafoUTbeUVVHbRnTca1SacPm3MNuv2aU0MLMqhJfMD9Gh9aVMeOCmQt2XHAWGJ1Sh+XV/JgZVu+GsUoNDEfkvBzkS9PvTLjgFhdcESZ+qejtz1dpMd9KC/m2qZVnTodamk/bwOos0Sqm3lZgyLaNIfSbZxnZaCvUbRALDdlZbjLNQMC8lG+jJdFJEFxZlHNsbncPaLDEqDaHU+98mbZwqMuhLj/nhzgU7TBmrfDbFj4Vn8mRvsJoPchXqIcCl28pjSEBPF37WmO3pRkm/Szsa9Is09rmBcqRZLBRTBnHNPgqJmJmqJO9AVPJlVXMiPHJGc6VXACWplXimZPsqi1dil1SeVe4rwj/pShsCko7k1ZL5b38Tfcvyl674ySKss84Th70HQ+cDNWfXiQggUY1HMl4D+27WvYCvlHk8jjb7w3dfVj+m+JyQxDLhgDWGfndmm0vdwFAe82sKTFT67GdAAgWPoblqyUO3LZU6vfIPqBT3QfU3T4gsfuAut0HcCgRg+duHwCppewEOpcalj0CowONnrYHF7QzJ+b0Qdo4Lq/je3xrOksz4Py1t+vkZ5/FN6TGjRCZFJm7Ia5tY9xHMsfP2njdKtgrDh1Mmk51f+ClWBRQXJ5V6nNA/GsB4pyeuQBr54ajBSdjBcfYDyXogrO6nJYxuh9qYD/UMDLt4wxABfx+CX75yOCdhV9deYyY8douqz8TRsB5Xxhcq9ixVLVv+rElOCO6Dy1CTyjCZlHPQO/CMxGzQseWyIemRkMEfHlTz0Cgow9tC0t6cdDGxbWhKoBDmBkrfGvgZ6bPAUV6XRQ6KnLNuI/TMKTvPaOXz0qpXUhLOwD9LEr/drPbn7Ple3lIM5CryioaqnZnB49FPS4EKs1BTXedAj00VbuUCxQhkCBzwpqcFFmciQDoJXwypCWNLOV6ERAponmM97yupTreqMcdIpkYd4DUlBgnwOwAAzqU6WAaOhbgTQ9TsONNnNEMiqV59hhMyWTVMgKKi4zZCwwduDUAL/ucNoCH3iLGK/xASeHIhWQVl5ZRz8VxY+WCxw/BkO/kOTUESr6hh7tU+7A1It8I1U6KnUfIS171+GsaO4ENqpd9XjPATNiIySi5J1V1jF3E67lfrdLD7kGNsz+wSJwautMWNWx2V+jFlf77o+JR9c1d7kt+qHK1DZseB6SK2jo+GpZvFcUhKW29CI5Q4JKHRehgGFa2R7dDTJL9mW5mCXbq9AXFhMMjeSBTqLqh4dYhqrpXuuW5MjOmSx0BPQe7oQzJZr0gD2cN0RHTB/8I+SfXB8BZWq5bdPI1DHHN0HbFr7pw1V6Rp93RsPYDoWp7Q0EhbVko7R1QaFqIpnoUDaoGGSgeaVqMXbJtWp1CzCx905MptC7m1oWQjmKLeYTCQQWS5FVRbz19FpSJN/Vg8Y+vq+4JlWhLou8swLp94cO8moI96rX4XixH4k72fYt46jZ9WAS6TwdGUQiTFxTgSn+Z5xjnEbukkgrgXyAyouzvRS79FkiowopBSKeepLflqiw/V80oXoROmnx79hMqE1C3adUdeAHI8t+VPc2D00cH4+yrqN5ervTHLGugJkxxlZF5KIaH3TXFBbV0dWdM6CRyunZQUMmp8gs1nUkRPJ138YXLLCSnjMiODtcHt6A8v5JlsjwfNgK1vEwUdWFnBj+PW8v+EjnM5fuaJsL4zZmGmcETAFBoGD8/1muE54zyPeD7gWNrs3J97yd5Ihg3B9YMhhfzBuK4NrAu/K42aK8hvS8h4h7LCn9BuVIAHHcMZF1BKKTIhBKwgV4Kr5RvMsQqoiT7W8tMYEK01MclR99sFqHWWunwckSNCNPqgNZXQxMhRRRb/zkHoLCYyFa1aKCRZQMBtqpP/Xdnf4ei7YWEiEJY+Jebl4kqM7pPIRjgxfjv8UE1Nkbs/aryQh4qDlQ5sdw5Z6XegOd5L1V5hqwrZopCdCEAB4xFhMKfEM5ogfZr2U/hkkD20/jFFpn5e5W8BaNJgVKTy6fKf0NW9YcNLzyfZ54vUSp0yCPVuFO7sYGEnkmsBRd4c5P+blH3M9UqyiWg1IaQgcUDZTzAzVZJ6hcVtJK/n4jgH8Ct9zkAUUyyP29IV+Wi+H3CISYld4jitZazxPTRjNbUohS1UCyO0EKuCmcGXxLwt9UNDT4pMuLiZxF+Xj5HLd5uywUd7BjB9mSXchmzz75Gb+4CEWHjOTa+B3wRnC7IXW7cDBe7DR7VxfUBZ+vtP7BWWsRapIY0lhO4mEt7a8R2H2M+1wvEY9NNzjQ+yiTf7DMVOdSoir3fmhhubgFiYL16frmDdI2a2ZdltixKFFdSLCjatik+gDpxBUz5+haPQLnd1SEIXmyNtdTAh2df0YMWh553xt7ydZNaGjWx0g79ak/0sD3oRMHCrfSDQoxE9g8ozJkFO6AMouYnD941ilht4vEDHKrwdCFsCrweAhZAHoakTCR8zf8jilRsCxUGnhrMqim2gdwKtgUlqgVlC5JCTOlk/4SUQvli5ZI9EchTfb9a3YQVdrXGRpFKMZuYeOF/p5Ab8d8LHNqnsJIMdcpLeqjdw2h6Mo55VCEzVVxXxG4ZxG4DgS1Sh4rUpjOwXGaWVEXowCG0NLujzc7QUNzHIf67jPc66m5pTlf+eW5zviAd55AeWC9CQiMTYFk6prfrIUuEtAby+yWIgkIGBQwS/HdaWOPfPMSl6zX37lGHsOvCyNAChQKLkOYv6VEX1NKITDnJkySvmtQkmPKaZTAtG31eVSTlxCKFZyrMDjEm0SR9d/CFxtWYD9plpCybO/o6XWSSOASpUUsnCdQ5ymmS6q53hjydJhGlOk104o3PjxhDoNMjoARjFJQXg1MOO4Iehx32auTxn6J6Hujghoqi0gApHYiqzn00g21dERt0gdSmruaYsYJgygCyij8qipYvvk9t6rRyHJxFSgsFcbKv6iRQ+tdCjwMo6GAgingtB5rxY0YsFuj1iNL9XQeMRIBhaCMk/qhmEIpAwcjjlCJEZITQLCJ/Uq4WkWSVCNIMCL6x4gKP1IccxhLiVHnOUFuebavv3rJXius6eEKWtSci8o5U0di4N8MSkP2zCkqknNjcIdKuRzqMeiRogGwH13rg9OCZva7LqLfG04B1/Q9eDFgeeOdP5XM6e+fJ4+/AXbjBipUbl3klqEeJob3u1GZeO6E1NZEmd9awp9+fZzo529SU4cVYQM7fkkpaVH9hEVMTGBFTA9OT33QhAwXD+glAYCkJZI/fPsDdnmXR17PbHpQF1GNb3I/YMRvIaUoZd/CAzCdjwHFO16VxV4I6ZgpOnYGjSsQxBXpXDZyGV3VFhkHMeRAB8JaZlQniEiuBUl7ReGx42TSPDf6ExwZ/0mMDN7vqsQEtBq93fI8NvvHYoF+rxwbnT4gLuHa6xwbfeWz4mm4vnLeNCY8N3rjHhoAS63gju/uGqscGNCh0DZroSogGha5BzuHF/6ngu/PRge/Nr3mU4PvoqwV8v7CanHGd/1Im1uZvpnTi5FVVOr5SW1NCEsik181whcTKAqZs2YvyWFfYutOKSPBIhPunutgSREQGVR1lCcQbKIJtjZlxMR2NyVzMLM+8Of5DWQHFIrKcz5sU4NxOLKAppTQcY9T3X1wsQoq52A8O8Pq/CMZguQ8LXCkWfzk/xOLRNuvxFqrxxS/c1ZIbToFc/HKvaENgvcFXHRFypXNy35zmDuS83mNcagiv4i7CGkJbObQsoW0cWpTQdtyfeiFCxCFfQjmaL6GCm7dDNnM7iISLznfKS64vp8hLoS+nysuqvpxG8/yyVV92ycs2fTldXrbryxny0tOXM0FFzf200/VyHnQUcUktP4vOVMDg5WzahZdz5OVxdAZedsvL4+k0vDyBkJGKJ1Ioz3P5clnxJNotL+fROfI8H5F7+Ie3XkRPoLPpLMRcQI+nxyFwoSbV6FRCM+iJdO5Dn/G4TKRzQDI9Xm65Xc41fNZDCUg4i86n8zgwue3DF2fj5zz5LCvO589sC0I6j1AMl49oFIDaT9Han0R7ULbWd4XWdwFdiLgnSRx3rFIYPjCFIdoWthOF1bgr2gP58Ori8ch4Fp2tjUfcbm6mK6zGiZLncZzHFSbrT2huPQZ6RWQHFp0dNKcMxBbcb91CXUQyxnFky1cZheyqXrY243s1Py2niX/caTLDlXS+NU2+NU3+HUyTIMWsCF6Qb8fj0rZH2zEliIvYRml+hpkSGRc4a6bEGQ9/SmTVKbENqHwmbeMZqFOCcZFI0H8Lh7ZLqAeEk9Aq0F8nDDfldEH/0y1ePwEvFq93yssOOxfm+WWLnQt46dm5gJczzVyoIPmuCSQ/tYrkp1WQXNFgt+IzYwGigd8rFfy2w7WbzsJICZ5pnBn40CDr+UgWBP3kO7//4uofhh148Xh6kmDvxdW/Yg8nChJKdYo055GNPWsS382csVijuP9Eg/vnjqDr+fREFAisdRj2BEVXO+EU96egKz1SdD0dmHm6Rdcz+hlI0jZEMl4Yqq76XFv0EuiZlIIiWtTawWgY8ujgCepzJtDmNGJKZqjvLo7aIsh0eklVz+ByThW0OpXOUKzYLS+7LI7N88vpFsfwcprBsQry7JxAnlMqyKOgO2eSDiqIzlFqp4DZrVB+XEm/lG7o2I1ClqPPOjnIngognmohuwNSwh10JiIZIBqZwh/uCwr+YXCxVWiV5KS0ACDNCRlo5gH47fJanWGJDYsbOPY17D9PoAJVtLc9CCX7kkCAKNyBqOPTDL0HigupdT7hn/f36uKNYYb6Ub8OWEO9CAt5j7Px2yrWRyWYuaL11fm58qT8SYqtuSH1+fk6+fI9YtpkBzb4NR3eGojHKh6narGnuVUReXT5nJPXAAuoZDqDH8HoonnqCEpQfpaSkBV5OVvpqBAOxtgz7aJJjLanuEWzxgtgiKesf8WTabe8XETnyPMpiHyqwRy3aF5sF829FlVOV4KjSxSXyTRl0yXRrKR7RtbQi+gpJcm4cGRFDOlCzasLpa3RkLgn01Pxna57dDHtxduF9KTRAjQVZM4VsEvnwQWW2pw7Qmee6AoAhdHUx2m0FnASC6IPEbfZAM6nf+158XXkqfQweLFuBn0cxAYHVIanYjlNUNGjCsInBHGXOOmeuMaN5fzDuWGrKfkKzVmCeAhT2VK4ln0d+2YnBlVxO+q81F1dDrHNrUg8jX6PT4FMW4qsoo+Pz33bJ5XH/PLD8FYKof+Et1LEhRVvpd0DMBAoAv+r+W3tBL5L3/rxX/p4rfRd+qKK79JfQgpH8uMM57r04Oud69KTrdI5MuXysuu5BDxfgeeEu1HIXLMbkDTmcfRGxNXSd/ueD+FLUBG+hE74ItEhnLhGHKegimQ8UIsOA3LkoTYezfafgXQR5qkwtSJbCfDgWH4gp5WRhiLVkNsVLLcIbAWBqQA9npBcBZuIXsRlrJxgU+Bcxk6RXAnAtbnVpm7WxqAquDqBxsPBV49pPPiPpcbDp32vfrI4rgNXxMfzyRufvE/eE3nkRUH10oBjkVDEo16pJJahxYGjVFL1wouBVy+8enA9Ov4xmqJ+d3W0IaaCnAzzAKAsH6E+AN9YbmBlH3m1mxnx8RzxOsHaD+pJJac1IAaH6eO91wilOYDX+jXCQPi6GoK+AVWC8rCH1sSb7AhCqeGngkVzqqD2XzDxxLbNF95YsW3jXWjeF1SnIHtAICmohttOdz6oNwMYhvy4D1mtVT5PDtoFFNXivzJaPN43L/4jI8XffxLFPzhaPN43L/6+keIf2LT4rTV7uYln/NfliZC5srSqs+wT5rLExz5+/SEUofcltsLMbKgfZ793cOzTSz1/0tIQfIT9vjYse73YefcxVQR71IDQGxA7akD3Oz3PQOD1xjYRFj44VMEr385qKQiKKpXQjmsWAZd+/A24DAOVB8W96jWUH3vF8a+h+LV01lGyfu3CWpSmCzIZWhgmqK68GmWINUrVUVP66UvzxA8XIz+v6PK7R35r+NklwXPX9uemT/ypYVXSeg0EZnf6HzdxUV6zbrTUSbENKUMtL9lr0SoNvm7c8/lPiTO6lysAfUNQtSBfhuZ0X3RN7BUikB6h6OZsTZcYgFOVN6X9EoEQx6U6KELpNL+H0dEHlg1EhyYK8EBs+n084qYGgFvxRGGDTMra2OHHou9rkep9T4rU3mS36LDK/Wa981JBzxtH0fPgidHzoEPPG/9V0fPHT4Cev4iVbwJB7Amoc3amh0WhsJcVNgEAkxt06nC6CLCW1Ski/ivXsqD0Lq++uLOfQqOKSLCbYm04mAuDjBFqdVXHsowBEwwbE9tlzNdVy8cXLV2upND6efqtuvMOtXQsXahEalA44IG07KfRoBVBDvU85lVXsJ9B6r8RqH7imw1UbzwuqH4SqUL0ngt2bro1WWP9UTc1MvnF+Qd830lv0Yq0ylK05MXHSyFsiU53nkRPllrMcb3h1Pb3r71mP+eq+urUpFbpnBMsYqfWZ2WNQ8z/6kJWVI4feeuTHdS+SCN0Zj+yTt38Td6pHULX1L4e7j7AaTlyIVNmSj6/bFIIp19YKbS3Gommzt6InErE+JKQMtZP8XxYqPek2ShfOROlt4KU2W26tqyB1KJ4S2/JS79XCr9XuqmuZO6R8OoawFHxLykO7PCzV4JniSc7fAA3n7JEsirHmv1LE1kc76k9mtXxdrc6Dv7drY5HJlfHk8Gip3nBNGwItHwljQUasKbD6lAisCihfE3yaEbu59zI/fy/u5H7hUc0cuMM6y9K+rM3ZVhJONPV/cK2UsnB7hLWVSfjpjwrPZqxfZsb27f/uxvbX35MxvZOSf+u0bF1WxEZQgys+ll9pgzsRfi5pKSy5E8d3kc/dd/phvdd/+6G99f+jYmu92hG7j1u5H7j393IvfcRjdzJME/v35x5Old6f5GwQvtLG4C7ZZRJuCQ3X9ER2NU0I509mpE+6kb6Q//uRvo3v7FzdFVGrzt1jj76xfN33Mj97r+7kbvrkY1cE5ud35fYN3ssHxBwiv4zb99xYoMC3IYNTtlDPLrqtD0kcWmex6q43tcrqypUxwtFzv0zul8XCh2mcmMbd1N0qbW67eXJimCPuFi3RvF9s+s5Wks/7EXQbfV5PD1nTNghi1yC3DPtDnXh8y3qXeQRnl3zTPpq1hRuWVBvCFRA0zx+47giNigRU4SHNq6/B83qn6swMnmdj7bQgjrovwS5r1UNgop93ctPcs7ch3tJcD/g9pLPWdt8BnUfzQw65mbQH/+7m0F/8shm0CXHHUc7igmfipOOZIgT2G8MBfyEG79P/rsbv7sfk+3Dn59ga3iJbBj2yQ5it+wd9HBDzzYg19l87xA+mrH9X25s//e/u7H9i0c2tk86HgcKsWI2hfPUwTr6qKRrf+UG695/d4P1mW8sE3mWCkanL4GP+tTwc27k/ubf3ch9/hs7cuo8PfsGyUX/3o3c/f/uRu6Lj2zknnrCLfou/2hHeZfNKOVB/9GM2j+4UfvHf3ej9k+PbNSezKPmFLugriYANQp2PqwYFn72VS3cMiGm8S+e5jMUufrHJkx7I/bDU2N3TYtcnYh0Q9k33erj1cdJ3tfNSZ62HSpy6pJL0ENBpsUGOG1M0t9+RgL71I+/rvXS4Lr4pRWjhcf4NDrSetQuFix/obc3+RRhcF7PTygz3KjPYOBRxCk3+lzwYR/h0/kJwzmIHngcnbngzdyIitkkQFgcDBX1feL+b+Mf2eymybBz774v/AfE/vHFFJXuZHgXzHXnCZ6H/LyBur01LR/wyl4pXW9mr8Izx+74gRpS6musxlq01EfPzcHzi/YB6N6+WrLNCHx8uXSvMR2KxDU4BdkhRMD2Kr4FgtQphinwqH840DuXCPoIirr7PLXFh95iIJY58HdZr+CRuVR29CkO/VPxOby/WO57sOa6DOxc6nNA1QP7CYW9vCuGDxefUWwxdlzn5SaNpzCAvYmM24JJm2avEeCE3DNognYrFlqlrnxJnrViBZO1R/xo5av+XgRgQ0B32qv9Ot9qoyV1ekrcnNJI0MD5SnPW/aXMLN8Ks59aVlZsx2OhIACKQ6t5LrdRV/OCnzs4Z0hb8524+JBvozDfSdvRolNGbqUW0Ng/FbdSd7CKYH4a7eQAK+7volN5u3c6XjkEkOLuGb8y7QwOQIke9yd25mfTtvwcyvPHiRgFnZmDg8DHkajUNwO9PTCLOFie0RjnO3C3uXW0Q5Wtd9PprFt/Rs5a8nw74Mz8XDonfxKX/PL8PHo8d+cJDLIn5ufTufkeepLUtgzZxEO1oJZfQOeXYdZ2L8NPprAMs1yWzkeoeAot48mK+fdDFz+Ul720R559RD6Nfx5KMRT4nC6kCxD7bXQRPRmBfWUyX0Ipnl7m+SJU9/dSH4ELkXEvRXyLYeBzqV/y6Cn0VKQ8hZ5MF3FgUtiDT6SCi/S7oHgqf2crezpXL+XsJUSjBIl2bfg22ocK9Os7fXwNnf6nIfJijQyKvdUiORWZuOS9U4vEjQTtFr4+6nO3pCNPRuSTNTIoLqoWyb1DJv7yIlekvTyyjMcynY/H+bQHjz3AB+D7eXAKcl4/hhI8PR6q/4wPT5DnE+iJ8uRLNvI8l54kT76kiAm4m3boinE67QLinoHHGXQ2HmfTmXicSefwtSBG18fBfPHj6Cx8xzfIRu+inuLuotrJ4f87nhzfmhzfmhy4gVrgBuoz8LgUiwUQHRf/dEKcju8RTuT61dmYCvSMAyhuJ9eJ0FmMwd/O8+FUnhenPfI5QeNz4hzG/lMZDmcxDM7k/p/GfT/bzIun03l5bcrc2BUwMlfmRq0yN5arc8Og/EW0bOZFrTIv7ICGigcyrEBpE68zrsRvILfg9C898zn3/ei7P3+xfRZPYSwonko8MYDwanDRPouncaLglxYNTBSE1diLJqcImsFJhFLLafZkO10QW7aP+vRknS6aWaN3me48Vaq1M+XJWvWFUqRGjqL1LroQpY2jtaLucbF7Fx676OnA7qcb7D5PsPe8R4jl59DpQD3cFWV8OwtvuA1/BrD0NLydRmfj7WxGdgKyfzs+/3Z6hr2/WuD+6tngj4DSI3h+rmD02Qe41n4NWM84uJOLyPMnBnsNYtITGW2T/Ml4grByxicA7Wg3o+TjuFvn5o8HgqLzOVOEPGREXWZEPR/MYAUxlyuIGU5BQod/SoKriPfkkpzq0Fn6W8UAjkYq573gZMcMo7THjNIuQF+GDs+nT44awPoEOypPotNlqAD53fQ4vPGNQbydy+OaYVjNbdez9YOcCjrlBQX/2NuucGWd0ym0g2+kg3ow9EPajgtO24n0ox6MYz5Oue5QKYxSE/bY+4e40lpSlDmNPYjY6WsvMbvNQ7/Et1vPgwUnsANnYHzPozMMqXs8p/PjCfw4AzQRcU9EOtAlRNeY9Ua3z0M2NHq3WRTyp2jAz59q5lNuliA/N8tikPc14OdPw8V6wZmQdqNTel25usKjIUV1mX8iIqpr/ZMQscst+GgUzzmz6n+bIpgs3sUltEteLjUk8DsQeVm5hlVX/WfaVf9ZNvlcaZpdbb/tZJZzUDTHIlxK31HSrn3Ur+CmdJj2aX5d7m2tj9daL6HL8K0u2PRMehbe9tHFUwqx9LRSyA7bdF3AZfF3a/xTxgsBndQJ5Cirm0CYK6GZK7tlTuy29+fPMNbidatYw8/TdUk7v88Xy/czaZjZhQvyamXxCZywS+0DtnGJ+HzOwlPo/P0IXdbDxFB/f4+nRWrT+bwBP4Dbz7RL73i9UPgH4tvX+IAV3fesMYLK/jVfBtFRx6214bvVrTytIQI9tJHWZrq6/Uf3r2NAoRNMEzyl40IMzkcHz6enWyuaR7fAXNsCfB8v0CLkdNxCa/ENtvBgCRN/bDmRn7iH+53kw4BiNn3fTx0AZknhs2CkFKvkw5QjXMKPbPwX9xc13fjjKiLXzwHZ+APu2ParrIEbS11s3p+ORyvfArkbQsUWiS+ezmRlf1/WnC0b+bO5pifSQr5HasPAUUCrTMVuDg4IxKzrkqNwJhrfdoSePZRAER8p6lSvWBR/aCG/EFXsLZR6no+XpHg8gxejjtHRvjPEA73cLtNWJ72/l4ktBFN0fs54IUKLC4WYyyqBGQb+BiWPShN2cSaQOyXrXLYPtH+6oOoiT+D4wWCNtlwtSHK+Ip9pxq4S2Tja+s86n0JEcxHLnEQx7eEmwujv0Njb9xR3QufRn6vW/gJvil0WYUCvgE1PROwTrRjQocgKdUWuAriX0pQtKk1ZPHlpygpkRB0VqszToghVuipU6ZZCla4TqmwxQhWYq57/v1mo8q1947f2jd8SqnxrcnxrcnxLqPItocq3hCrfEqp8S6gCbpk6PR4YI13pPibSFea7GQcWvyVd+ZZ05V9fuqJiFfJpK0+AZzCmLRkBy+OPL2A5j7aMC1FqvEYu0y5jezOmWkVmEq4hoiJIcZtRPMJpchTKJuUoS7Ithh+774QcpQ1xSpu2Is9Wa6M/ohlohug+PfsaNFUUBJnaYUqhNbQgrckGot+iyWElOakmww1+/yO1NVeq9TYJTwV79bMmPts38dnqxFcSnVWjH9DoilKLxt+g6iesIqOKOCcwUzXhrLkfHN9M1SX4WtXbD5T32VcPiMEI5x8Utg2z16IpnXQi/nWIf5j2ro5jJcAftRIQWCsBr3qMzZWA2mASqT1HZ7Dk9Sdw6/w/4xi+J+v8F7ATZ3t9pVH6XYUz0nhNRuMnUJba0BvE+L0tLur7+w1xM1Q6iBzCl0bplW+QN7iEO2JxlNqkCH1K8YAHZU2AVXbEhOKUIepb56KHA1Rbp8jM0SLgl06R2Vd/4NyYFbMYxCOViLl9n0vzv37o63/P4eAIfJ+j9eqzFBxzMLBxtq1lQHp4mPuG56GgiHghC8RjUR1/bNt/XmnOAtpJwQXBHTE/tcUL4vFzrYAjSK2trv7CjtxyQXAn8nFKIj4tEbMRKxS432pZv4n8HfFw1pFeXlnwAh0JjnIgMO4d1KwvoRaOWwC5WKB5JRcNCimhOZobcC+598NyPF6zd/3BoFhE7vpGEawP+C3q+31Gfp7l3LHoxZxG0YuyP6haN3SOFSlYzwMMVldsKs47/2BLskNZMB9wEOkykDTLbZGPeDQxcrQ0GFp0+eCg8NXx83BQLAOSyNjSjHmXv/bVG7SU0R0Oh4CiuNdeppTzmHE1yJT9JN6cv1cPsERzi4VLldxW3A8vgVF5Rt6hhbxuvUJ1ni7ZMoZ4pl+PYLtzuR/rxDjPv0NHsHQjy5MHk+vhU5E/XkiNn4RrI56OPj/n+b00B3a/5/yBCakMp3odi9h6SktJ6ioq4SF7Ew9z3PcoFi26+DxZwB4Ub07xxjrwvP/UtSLZ2PfpH1345W//tM8OHPkT3tkWjexBMTfW5A/u5w/se8rv91beW5C2S+fcFMzbJU2gxga7VlfRfGyc4VCj6sHbE484M5XvB0MdeHGIWMyytLccOpmNbZrlaV+W8ANc+axgEj8ZSTFCQcX3agePDnmV8fcowxqdyXiG/TsZ89Psf6svHAoVgCEAvcBvC2sYcvjG87L3G0VBWtOEZN/s35x9/S0/c81Tsg8gKZ+jECmMHQOPQuhVZh/Ubyh2cYoxWlOmNcEgjWjxzsFL/jw/VsEVzKHxi/w4l1kFPTuwAK/TMrsUD6g1DttABXTL7QrcPKwLSlgsdD3yGBKAljcJrSp8QMpa2VHpxhwbgcljPPbkHU66yUOagq6L6FquHQru9KhLGdzj7GfvUa3nFytrCursQygJxveze/CdfFX0MAtX9SRgqy9OkiCvB5uGFm2jBaRspyU8YCg9p62laX7ibWfrwBqSdmI9543JPZ4JHLOBozZwpyfwWe0nvIROzqP8FJimBrx2Ur6WZ33Yeyry00DR8lONDydFmhhkosMbDjiejmWTQKeZgGVvOS3GFim2hySZ8H0ZnSbP0+hUcR1Jq89CYoj9jCePo/heQsf0cQ8icPxzCuejU7jogYfmjM4lRTG0TfzLe9Y1pbUGfyqtArDStw6dilO5WD7r6CdU6HOIb7eZry3zvapkbDvtMGvxeu5pUaehJbQqhB8lFBllKM0DQKS8Iw7Lqv64c8TkVOBRWEvBK1LhyQwlbaUVMIc712RsTjvx0BY8tDKmp+aZjGlxojEtTqFTTjicxaMZxulDeJodwtNQ9mnlEBa0aucGFeh8vF9n7ancYDOasfJNAYbRQf0lFuoheezm9VYK6FTOWPHAWzDpPOQhHWk6bpjLC2by3i5Tdp7fDvGbTmBMWtqJ3qNWnDof8mS0l6ib/abhHeewacnxWChW0HyQEtqypt/mO/C+ihApQYhBEIB/SgC2c69ypXQngxUxGYQoBCG2HQ8hVi1C7MgzOtVM9NXHfqKvKoZsewwxpDAYothXlBiyStsA4u20CvTowBHaDuqsAenx6JQoQh071ZXwW1TJgCpC/wE9nfWk853BxJ2QMk4VDNGidIKDmjHgp87z1lqRu5ndPc9H/wHecgu6LBwTfN/6a9hbKPD5WkD2W7JmmBhdktLsw7qyauT46oo9e0b+c/veDyPYNQB84GLEvLDPp9A+LYPaLFPConrYEnav2kRUY1vpFnIsxtOjd62N9UmjV6dHZ9MKaU3Jmk6Ja07GMZvoTMC+JQzgdjiY5mF01BVuP+3DJ9YMW0hu8LNxWQ87cjW5BzPh8C5A+GG/o3+MVmZ/gt88tGbsuLRdKHRj3088/cfvzq9P9loP5fddzDz7blzrohoDp+IGOvtTKSNWbvUS4WpVZ+WCgAU5kFCUqMA9VFazToGKCwIwTOhIpFv+jILsYyjwguA55qQt0PtPgfoIS8gH/559XGmRWLkrEjz26q0lkyGXuCRvAGOek8faJPIZu2+hBi6HvRheNzdMP7SnGhrY4OAi3s/EaImPOeBTUrUpoZVfLvYnuGIxb6FTOiJvw+qY7B1SyBk21rNPKJwkP7fYXytBSPE65ptWYqrQshO3VwkoKB1qKpoEVUPB59ccGoRrcteLN7H9gz5f20fFKxyflfE27gSyG9gxf1gmxh/wfEgiDKbeM2dRVQ136HX4/t3Q8eHKDuq/By4+P7CVOtIYlUo46uAbIwhr7HNMMiqQ88jHbryy4TDBXXvXlTl2exmX6fahjoaAParsJiIQCggu71G6H2R/hnxacd/DXMr+XEDHadw/B/+/nGlH13m4RnYtnnXZ9MFpXuOlcWlQxC99hgO64n+cobGW3afIjNE5HBSJ0GisPw04C4E3WM0HsSKWm4W8JQIV8fccUAOyiAakE8MiLO+KMd6NCAxmZCe8UWTr5b2yE0kOEkyX50hDi5BCCGhmB8ShIw5kRxB5ZJCHyJbkc9KQfF4alS/0j6l/hln+GuZVdY3j+rAm8Y+ucbJhJxZ9HKFsveAtEuceluKKdS5NvdUWS1gCI5zNCDyIg11KRCVMnfqt0CJDp4eXrqz7W0uMgqDHsr1wpUxt4UkwGbdDlYyIH2GRW1WyAj6hh9IdqIHtINqQW207aTU/JdgLhya0QjtlUa4wD7xgduUI7DRaziNaEtfwS1yprLGncSaKkI6spwkcOFeCtTVRf6F9n05hpbFevgtrMg5KT6fTObe86UmCgt4+izM4lVOQjx/kc/HPQfHsmIa0aflZZiDgtwlNwFBoK5CtOhp0GjeydcNdv/f83f/13ovtE30zFe/5NvvECcXpZfRv2Seiz0b0XpEN2aeChyTlipUfeNex99unS/nhq4NzXrtl/b32iRSUxmkMh9PKw+IP2if6gu6j1QjzA/+hCx/bc+gDn/vnO95vn9KFD7/jXe9/89/lT7VPQA7xb/+u2w4+++Vv/IB92vjDi3+wZeD981Pt08b/f//hQ0sHPvQfP2ifNv6Z34N/P3exfWo8+gDVg7MnGnntx//oP1/4Z595in1KIZ+/7czXfvYz//kD9mkLf9nX3vG9f7X1d59qnzb+4z/wIW7cGR+0Txv/8w9ks7Oz119snzb+Umncb3/QPl0jzyEeT89MGPvkwfzOSXabR+MT8HTzXcXuKYmPp91AxdN54P6Qa/RNvH3yN99JKOCh7+IT6XPoDEJBZxDr+uhnlfQzqCXTQLYAT2AUrvNrGuJ5Fjh1fp7Jz4yfZ/BzNz/P5ifxtMtFtiJMxBNk73FNEb2Q57PT/wRZY/3PuaEEilCo2aj+5+lUZyEayYcczGxwnuoaGg6LbJjPchrZNH7PaDtYEj29PxcvSfEkqI2epyJVtItpbcdQNHYXRhHmqux76UmqNnpuHvExeYJ5a0lHzZEOlFylHXQ+ZwJEzu1nqLODM7gO5XIGt40KCqE2Sqo2GmkD8oRyaU5EkbScEqH2qhkaAXbFuUq+z7X6mgn4lKRsgNsY2NPvXSAkTMVeDkdQO9EKJprKxSxUFtsF2kozz8gjOSjLt1KkYtuGrnxNYbLQSt+KYq+PnF+FwyxITTQebBlfyPb4GbFZeX5CQHctJeCYDuGVDU3fiKcxHx1wixFeLeIX6BFTETEH8xIUgP0YkjmFo16EQvrBGp9+n+dfLfxfcOA8/4Dm5AOqNRzzPI9B8ilwqhQfMAxuQ7nDVV3Kdx/QA5A8Fl856gsay5FWjjRVlW2IQQA0Tk2ay/k/hWqvXNyQo/Ue14osClPtV1dYRnzdg+ns51ACnu67KQFP90xKhA9H8fxpQypF+cJKfw7ch+a/RPJDfimzxiOvcgJXBNKaIPsb/WCXf3UOqDbO88/iBwSg/EiwMp/nX4SgHk/ukeAXEDxXgvchuBtB3FnHngPBBxG7U4IHEUsS/ApiVyX4AIJdCb4eGRYkeAjBFoIQbhtLDgeoLmiafV6biv5oImL19FUbOCW2UcYon50wslkU/OtwOgo6XJuOiqMoGFdQMLIo6CkKYpgVBSOHgox8QBkdpAPI5LDOo2g61kEciB2JQ7RQqE2JaIFBtJA8RbRIES0AogVmIzKJaIF+FbCA6biI5imihSj/BIgWUFBFNE9a41URLfgmRLSggmhfeIwR7a0n71khHPGs4G3iWSEY96yAXc39o54V3nBD1bNCeRwdYav5b+Rb4cduOJ5vhR9H6iP0QXD4hnEfBGHVB0F4kj4Irn60Pgi8Ue2C0GoX/Eyn4cuJfijHiN51Af9Z8yS1kZ21SlOeqdKUffq2V9/2AEtvZdkNnhcEu2QXvQubaOzTGMzVbXiGI94LAqx5H8asBE7cpHtT3QXGTrys12riCzb/KNUdLRV1PHYWidiq0bNv2SU2KUCxoId1lJ7eOixaFwSEcikdFqkpnJoUD4umyGK6GnGkaGqVe0yNP6X7dDLfIBUPLbhN7cFAv02pgZgmNRFDU0poaQmxlmCbRqktoaUlxBRPLwE8Inc5sUIif+R4U+ULkO56acpjNzMhfIFBQLEHKADrd4U9S2hGMBKNydG8OuCGNgLIlJF/hNsYZz+NJigO+pQNqjE1bSTk/ErjbwWw9fuUWhOftjb7tJPXSaQJM7LgzEiLi1nTZtCjZ2OgfbS6js6+BLhG2ZGiNQKKmFpY6gS8RzDigyG11qsKIS1EtwaMCeWHP6R4l95epGXnOUvRBAQiSke70RxozHQIpBUIROMQaB4HAuhpnki/89lURpxh0gBMGjRLAgN7iQ42HDkWVh2L8BnS7XiYz/GYyhwQbMrypgpMYjy6k9PSvX7wOtgUagGaKTWpdaSYH1IMInqkWBgObqV54ogF4nDRWgeeDynlySTVDmjuCIOYB+J2q6uCa36jwG1SJJ1V9Q1IQEfT45KFfy5epRdtCmiBK5BeDDA0sIjb5sbEKIDHZnxk4omR2WXBO6od0+gToBriZRzwHQAeGgeTML9IAZ+oZLbT3yNmiBL+JOJpNKPqggFxIHFIIA1tTTR085kgMjUd21mtkNsRMf57KLkrxR/JW3hmhEqP5Ckt5g11jw8FP7ABOq2521evCW1iROaZQHWdOPx8nsS3MdZHiviWUlNBiHAERRqkLxwp2kMGeVN7laEYnkCMBGMDPDqALWoDRTTvCQY7wGRjlBo40rNAqURgAo4ToOZxCBCgpUN5UT6rw8xwEUYm1PGMmGPRK49IW6QOyavIApXF0QL/EsugBF2K4tPPmLUrENZDEjADhZMIuQmg3crJoZybdQGQdczF3qKxvORa1uz3/QCqduViPGg4nR7RA7kZ/YAemWgl3prdiiI0Sl1PTqwImlMzQtsaKmvKS2gqaD+OS1Wljd/yRFLyBiN3UzCpXk7GQGmJrzVii5ZHpUFpXcx84r8re0VLl3UBBaUckV6lld4cr1FTVpw2YXpQGysr4w626k0xHIeSI0bZIjJnbE303G7fVc9AS4KDawgTDglziJM9aFd9Q1Qo+zdrHQEHqiqUv7i5CuW/qirnm07Qjjc+9u3IuB3ZWJuo2qbbTtCm3x5tU6DRyk9KJYwfpZV2P3sDUgt/3245W1PCgdZC8PZTnzj1vvSc2Q8MhLjAAUMe4UHgYbVDAepfwKOfaIegCsDY1PeEgff3BnsFqhRmPycsfI2pbQis03wgEHwunGOCl52gMP2YF0ItD38CJHXKK5MCe2R998iDSD4kT9ljpBYxMJ1CkO99733/J//sL679n0+5EsIqihn/VSFLfPi6E1k8eIOCarRlWhcKlUVX2Z6I6pUSkUE5aW0TRXlddbbwvfbMnfgKdB6ueuLDy/3jceTx7iOsErujQUnsAGYWcgRAmXKZwCrgl2/MukXOzmFUUU65vYgHhXRWthFHsKCA9Pm3KEmqA8Dgc6VAqg+GtxfJIK8b/E6OFAnFV8niDmq7h6lSywO07qpxkEI9fg4hiMHflb0Lgr2MQQ0MSZ3fldORBjQ5Igajj0w1YeM4H4XYn2+gdyi+fyMIi9vTpLqnaZlhTYr2rfmMXDFIZWRREsLKpRNhwkYMDWofAXMU0gxFHOqipbcie2aycItKHea8DB51ohyZEJ5uoRi6bzrzyKvedGOsvEBDKTxF60WEPqHjeQzAmBQAkMqP3i9gqGt2gRRnT5C9PsYG5EmqmOyVd3QBf06zllEPBoWnw6G7bF2zsMXDsGGMB3mCZDJ6L6ZBEYrSMUd5Cm1qyNrTqQ5fArU2N0BuIMc+iTTr1DHVLqhsebMRphSZUmqZTIzy/6ZCmZ/95hPKvPm4QpnbVSjz7pMHVlQF1tHaJsAKx4B1MY7gR2F1ZDqsNKwLIeBG0+AW7mfQiVZyLKQHkKvALTwe3ABUhQ3A11LwJfoI9QG4DY8Lt/VHIcwafFMLsx5hp94y0amo2qnoJDt1xaPqFBBytFOR7dQP+lgeofhj5WMqGtcTNF0WImkEYngnbPmfp1rp2ZBCbLxukSZzdscgXSmWpB+Og91ghOL4m0wif5zi4EDpgdFZ9Asjs4jbDhKqQoF/G3pzx/HmDaw+P+J5c3ACxYIqigUniWIvOSkU+7WTH0wYZjajeeRDr4imDKbmCaDX5wZ0wHmxVx18yHfD+Z6R4bQ7pEj3SJsMaP++a58v9pK+sQP7G8cd2PcqQfyuzcyLoyj0UIbzKx/lyQtSt4ZxY1+X+FhbWrEajpwLa+n7/SDEXsCaPMcIl9PosnatPDAjnVg4FuY/VpGStcEXTooCHM1DyFk5FY9xGh6rHAofPQuQQ2A/zt5Ek1a/Bq+oX+pdUy7gJXqQTzVZNjoIBAYj9TX7ZSuMr8xx13w+jsT8RnX8V87vxM7v7FfwufYskYKL0DVooishGhRWG5TdqSPyxbAh26jrQj2WwN/kDnFcgy8EVBWnvRcrIGsbRd1pW+Rcv1PSyxvlG7EWZR3/502ewU4YnLcEiq1SSXUwpMZ60XYiZL1MlM9QW7UB83b2DoUh2E5IvprrNIP/BizDmrmFZsr92BCspWPF21AtX8g7uv+EkmtXHxkFhhVrSagrc2rGEMzsV1EdvwYsAizaeHSp7bZLM0eKbHgEvZsp6+JI1rVbL+a4KwNuu2pYwGJVe6KBqftqDpf0hsN1yigboGuz65WNGDrwMDJjR5uqchvNuCECengwtA7lWSTPr1X7gmSf5teoraGOCbVc2XmLUiBBakREzjIXCmYFUzhgBFxr1f17+jbPCx0VcBdbVXgGFdvsnYB0X7c4MVT6EkzpBlP93bJgc7gvjhoakl8cx2ckcWdRY+rCsUoNvTvmocQEwtrsXVKNh705E60LayE/Gig2dq4JHl/dZ6NrZv3wynvYo8c+6aQzAzvX8CkA7ePT26UbXlXpGwsCMG6CgTldSuxzGwY/+YpDutVHrWfX3oJ3hnm2gSrS9LNeAFoYXVvRwtURZXl1oAQ9NI46ZMvmJqCTD+d1F5vItIwUB5SkVBCgoVvGcpKaTWhMyZAfclw+qODi8AjmdDwwG1MKJjLIp8gFApLHnAl6UTiR4QgPk8cTPxj/nXU3xC1IHihDICQenJjKcKSjfoAkn8TxRlaIIM2DNoTsEeR2AVJVVISiymLUzWA5NrjJbvTb7e6A8zo2AeX5ihs+chu5dfZrSqRVH96Tof0x3wu45eLvo/AvrLXQQnX8Iav62bVW2zPGvAKVduuWhmcYskoDZQ1HTuwxPS4EQkMuEKFQIlq+LlqBarRzW96NtmiB+AFPar/t1+SR/bq5g8/le1q+t1n5qXNLAjC6yiA5C1DSCSrT9qTpf8FA1qruUdThim9EjYCZWdeRlCjCkW+q8mV4ZMTVgYkOWIJPOMEVj9mLOjA+j03xeD3geS9X/EN5PB+7PNs/h5n9tKM3PuU6+Ho5PUj+f20PZT7tCdfiwA9tmX0V8giBkQ8Bm24qBeAODL9nb7je4E72Y0oE0v/2SLji901wxWAFHVuMtzG+uD+NLy7w4dXMA6898g0Y2N+R/RdqV3quWQJztpT9rk4cc5Zyl6LKX3mBjwvZbu0YvX+9IBM7j5QeZ+r4J0R8TVIQ5+lFbQ85pCoVW4Jtxk8NLCJSpt3kjhnQZ3FmPFe1kosUEpnqVi0UdetOHO3QG7eJ8Ju+Xo8yt2w93LryqG7EUtXLHxd6/qhY11cY+9kf4FNN0FQZIQf39NBjfOCgF4hX5DiBM+Reeczw2+6YQQWE40cfgQ+efOKWEypwnolC7UwkbHnM3LXj4CN22SPsu3LcsXDc3nE4bg8MrucYXJD2krP2oWgyjZ2Oyu1yTLWx7fLDrdfKiUT1TX90AxbuFwdaoY5jbFRAdSi4WngXSs43+XNdcKqbrVBKxSPUh9tFYzzUmS6KKbcXoLWTe+pfekyxQ9dCe/MLE00jnA8uzeGZHMAfd0z1Ryc4pnoDdtfWqALWbvLtTXJunJm7aBkS9+Dn3P24zG61Wn/H3SgLjb8tVdhATvUrTKGiHViKuhr8LQKw9JJpF+6hyU1qjHVd73zERYNzi/eoum2OR2EODtJXe7jyOX4CvXrpTOKac6AG+eCY5QgIqDSl+pGahdn5QOi33FUscmTP0DtPxQli+yAw1/7rpMlFgmtyOJ2I1Rkz9mL4rGn2TZ4MPxa7OopJMUgIQSdFN8x9TBSYBMamKJEy2spgzagCvJTUqV75ylBKQh2MB+ovsDXJM4x1Jvc+oYAlOhNNDIvJmfuEHZIBbURN2FHQ22IKmgg/fgnaADANrLNot123yhxtpa8yalGlcTCrRKmS6qY0bxZ7J5rlI5OMmjil43R7Sod9RVDeLrzzoqF0gCWAH33ydT/05gG799r3Mx97xjP+Yea/XcS9ygzV17t7EWy/eS9U2v92DAzOL/gP4PR1/FRdVrXKi0i6G0t3i0yFdfrQTpoux0x2QJTQZd+gEuZZ6DRQQzed7jx5YVWrlFV94pc+/ktTzjqQZ0JW9XHk5bbx4+M1J636CKYhN5r/w6exoma/tamk6kXP77e+0XKqjx5XTvV7ulN7ZpUbqZq9CsrTZmClzHWHiXrELMfHbgfh9oMKUjBAWkvFud3vT3duB2iAQ326cLGoP6zWH9o1GiQNFDbEJ2ULKJI4VIPVYxOuzLXKsWUty5V9r+dPyuvcCm69WHP/GXeDMf9+wahvQSe5e4QC3t+fYGVbVU62NcHI7i4Z2TD7Q3x8fL71BN1NTr67QLxqdz/3bzkBjbhYV81A19QAMhCNQAgrtoZCM1fMJI31KzzsWzjtsM3M3G/skdtJzdzzNhPXOG55mszmGhZJ9TM9zS58Bq7ubqGkhtIA7aD/eH7t786Zz1KVPwzJsxUldEd/qRB1ZOYUY6+AbwzlHj+CAzlaEWi0n94RhInRYZnkytAsJxiaPlGAfAyuTK39B8pZ/U/lrPq+cHBPuxH+js9HHjWHirvycmUpkkbjE4rWACuQTFWcvFppm6L2p1Ceol6Lr1gVSNe7XRFqZQoDnLesVl0RGpqaMgIKT+E3+GPRD2A8BlePxTpvkLchYmAsaP6leYp6wSTlMXgDhezoBfzmetFS8a8stdpptX7iUys7PDXFI+jOVRkEc/Eq0sGIOLHeD52qt+NFsSV7reepPA0LP09XJ5Iegmfbt+Npb2wdue13nzy8yipL2izHOMswDysGnygQVtGrGr4qoiGYSmAcZs36sPAB/kFRLVqbnf5OFPtiQYJb5FjCg6HyhEJUIBa84ydvELEg4+sdkBBm/0vmTh+CBk1MlU85KFWRd4BCGBhQHkUosG92Z5iul/barPB11f/49HUP/dxTRAlFDcrJsdp+XC4X2RxuHuWNSsbxY4MmbiduOPhRfeOIffvgYOQ0QHFUWgUUpYokU5SlJ80EDC4ejpsJGMh1AenIxjrCwyNq4wIjma1PirPBZeHUVdZPBZ02oe/paquuVa3AJwApaoAvC2HLLM/QP+ooU2Btt0TEj6hqu4v/Q2dv+5HaoYvuPf/ledsdTbRkH5FWmjWmRz9rusMnCq7lNEvpEarGDLWf+az0NJ8rC7z4aPbzgtezLn/GBuY0g54MrBez1Cb+Y364XSZ8hWu34f+090pV6E4wi2Oawa0MGMQQU4ZjuGMJ4cHQzqk4fZ2vco6gcmIXuhM7wxOHKgZQ0UCkHKFnrrY5fsxH3BrWIR0UZNIsePH0xE3zMZNpSwk0C16CiUO5YJNDuRBSBNiC5L9SihBOHMq5hvEn2ibO5toUrlXP4OCw+VpDW8zgBkPFUNCSIRpbpTmIO5L9Bb4dHt/oBxr0sAy2jhxdhGAKPzvOqv71Jqyqr36Y3+9HgVnWtGFsbmPCRsjBxuj7fY0+xMkisWf31LhQ60iB7AY4FouKz2PV32iuGTMWA3C3iGM0GaRrhF3UPQ2klvvDIgCi+mwFxBlk0UVrjDiZ1z1spCIGdaPSCEyf+QGq9zbykOp5YBdPECVc/tx99YahOxRWLJYYfVq7Py0itUNSbYqPRUlnjLQIA3CbH0JyBtqOiqz1lRp4LDwBShBdMeeZOCA1cOTLBB9JTfJyf/JwtQXCslbuoEHufKqjKSkamGoD3UfUugUMGfM0bcw+FfxEXIesYDE1+RvRkETJ/NY/KJDX6+YwQMwN8XFj3MfRuRpCbeMoOIFKL2OrAEKKrDISerghx2RGs4Z8nTmN9MbHWMJpeeB+WJVO3XN86dS/Uis+fYJW/ObkRDvoTc60vaPvh55WmWkHXz5lpnFsOdMe+K3atKl28HdqOtcO/mZt6mQ76FcmG20+2Q5fPHx4k+3rtWsmZhsW/snZpku4tmVitpGZbe/Q2VblpPzSWTxMzXFpiPtGzjo0dGzWxeWsixVJYjvroimz7mhts2kXT592gIiUCat4tNm0i+y0Ayztwt1I3+l5PphhFpp5+14K87Q/eqMe+9ZKY0TrZfiiSviyvVX+ZGqwtNu1zquxd3vuoaLRe6pe9la0BEOa/ZjVHlo/QjX5RDcAHEGeYgkn3Lr+cFTv/BHVu3AT1TtvXPUO2iIPjqre/aXbfLvtdoRp/m+kevdXx90/36sL/bdAddKgekRCrM9MCLH8qpaif5Jaitc+Wu3ecFTi56si7CP65GVBaBehDZBg9Ln/w4Zwq7vCGHtNN5NF4Y7hLNolQJf6UH0IFnU5MoF0uwaCZbToAmEVQNvFTI3eLOyreP9ZVVGtWrnbVFQLtxDAqs1ltY9taVZ3iMtTMzGqscbjjNL/Vks3wgh8eaIvvjjli1/uRSvXBS8dkSTdg41OVR6w4eQBskl4G95VGqBJsoN4F4KpfnHX2Bfvc1/c5b74sHxh2B0s1vrx3WMff8R9fLf7+GPyMVhouRCJMkSARJioCUKrCDUQ6iLURGgBIakyQ6glWI9QG6GdHMLzLH7KkdIM2K5SSafzgiKjzoH9MH44iypXi7kX5PMyxEhfoNn9+SJed6nv0yD3jZEnnE0tUUSzL4TzTZp7AT/mDuwXayv8Pr+f6geKZchDQC+WqUOLIHl5h3ygiG/5XLn9bEa1huPILh6Ub5HO5St9ARbaFlJnLfs7Y04/g3mS+QNrlKJGMV/nq0rYMeQvOgjKp0UE/q1DESi0MQi1ArD4B4S4oTURp7uDyJTaNLeW9/qCFpIZs/vvUTWKlei8LTQNicV8H7TAVb7qKq+jVndmCKP+aO8yP65dE7FOzVz6A2elDCu18HdpDxnVTm5dLClTuiZHjLhhP8PdnwN5NANbwH5WBlNTYmlrmxSJm/DKJyE6lIuN+IDm8Ams5BXbaVvFNHDUz5wN4e20dSSJACcMXuGbC+xzANkcLVmgpdUa0QCCma7K/ZRO5Y7PshZHKO6gJ+Wpn1aav9R47jJ+LFIH2aVNIQs4ognG6tgMg4sfc9YaPUwVioKJI7qk1uaXDRSrR6JE9dwnRXTSY9Y58g2olW8lh8fJmK2wGeC/TgQC/VaLvYrpVkN03mqI8hTD4DapQZl+k9CsdY612A/xx9xvU43O15Q8tGWuylxc6KtS4hYgIs7PyX9B3lC8nBMqwuBQm0v5rJKj+8bI0accObrPkaN7EUwdvvv68QNjH3/BffyA+/gr8rFeTlvSDw/dNPrhg+5DSdIPb0Qw7UuTQF0OmGkn1UivacnE+Xu1e8tYnkBpmHD5PE4LfPAi9kfQdikIBhLEnMccmLJFDhgIR5TikF2pguxIjJpvdWBpGXNiTsV2KSJTYySElmUU+w+WJErpE9BNXtVCg8qHIzQHOXWC+JiU0gFQ4TlQYW4VzeHq6yiJlJKKjtSv4x7pjeLbPDwpwuh2pEN8Td1D5RwHSoYaBXB5z8FiFVPBEKx8FvEHAfMiK9tXzI9NLQzky9Zk/xZMUQTbLkYLA8Jzt3mSecKowiz+lJwtcuUZzQPjV2lRydmykLN5Wj4xOePHbR5DRpzwOLKGmcmfT6dpmikbIWcZdbCFnMNFEZSHUaKYy5/DFNX5ajUeetxOyDi5EFIyJuHMkLElbS61HWmTsJK8WVC0WVq6VB1vwlwqjptaDuyzDuwzo2AH1nLtLUPRUloVilaBwTJ83BjqNkszk9TNn6BrM7lPi4+QrjHVqhA1ADCqAHCZlngCRgBgCwBsoddCxx0aLjo0bClN7ndw/CX46KE3DjA9B5jZMcCsCj7ifAxtwp9i14yU2aNZhsQ0PM23AigtmoGd3dk8gpgF3iCm5+XSt5IvGLWNlimyqDmH0VVUYgRlZCPE1EzMdstRqM3rCvxAeIApWw0WbRdsmQeGzJcYAro1FQZzYzCYZxj8D3ZQ/0jmJJAFf47F6NEc5mQLS/iy4fACsHXUGZ+Vu9WbQUB4IfVooC+ZejXQl5o4BCAc+5h5mW834qtAj1khuFdGA/JsD1F4HWdHIuupQLWYsHIqMFM7LfcyIHeThndzmGiz6TqDbclMiZhivRio6yCebj4dAepFWjbTcV5wLZ0261oyT0dnXcT41iEl/US+zrxodOZtjjnzVUYCzVfeAYuByqdyGOvTNU1QyE25WbP01bH0cXORB9gP9l0/mMd4cxPnzPAs65BRiGs9RPPOw1lB/K7Xzs3S5B/IOyAhYAPVhI1dGg0nvYC+LJi9KzUlC/avpTXAv/FHbr/40zRjA3MgpgMyohkb6iHUZRonTL450gnckY7IQp0WrEpnfOzGIY7hRGQoxTFhKY5hAuHEMbIhCzavJdRa0KZRnVcW+3j75bBfvoiQr6LzKpf0qzqvmDSROMFSu/ihqNjrI5QH0oxMRnVe9RalE59ANj1FQvNpCLNOEtZ61FjEk9C2h5KqD3wS0FadYwyTg/X4WSEKqrt7QAmmUFipJFZ5bI1iqaQKX2zuFb6BwnfkMDNGUwxEnZIxzLepQMwrH6E+auSrLMzP7p9QK9Z7tBMgdmeX5530JdqK38pa+rqVeBm6/Li3yb/ODOuo3OLmMR769XhXHvpmx0PfhGBqNB/GvrjNfXGH++ItCFq5hRGRjH34NvehJqmIpPwwFFbDyhry2Eof8nopPkhK2USjlFw0VdBhGNtWKcdol5KPmVLe0SllIJkAEqHZquhgTj5S+cUC74zQ5ipfTk1qk0+zLygWD1DKoUVmufcXS9R6QVE7oPoas6CktIQduJFmcA9ipMQqX7hT1glfNkYSrOn5UA3USXb0qvy84GQMNdB1LnBExtCgWTH3D4u0s32MpH5j5Qx5E1VIfJ5ihkpq0e3D84tryBbXkFjoY02cOWDBSqgr7lo3YRFWeI09iOmIwNXmeYV5Xk4poIU/nZy1NTGJuEU9ni0Tv9fByaJwdIJaVUahZhgFJCJMhg2pGTaBTLhm2JFWySSsqEhEzZJRzXEJK8o31KpMgnPtLEyCYz0TA2Os/dxJYRD05WoOkwlfIQyChi8Hg2CVnbuWQegaZ5EO3k0H78YYvAHolOoGWnJ3Cvv6EQahB2oi0IsrkegzNXKf2gAoOFiyjAHFYwx6zzDoqFSwCmxCy1gxxtpstU66RsSATYq6spKZNy9a8PyRTLkX5KuKVypx5IYjpfaCvPvwZQWPQECwKkbXHrGAoEbdKQKC5piAYBb0dtaeV7bdHkT9ZrSVti9woKsTvkZpORa1iligrmBPdDLPAtHiEbFAG5Bv0+zJiAVaKhaojYsF0CtpNhOlWRAhbhXNVsUCNdSiBRetilgAK29D72ozgcU4tqQ/5T0+IxTIu449jBw05oCu2IiJpR7Mb8cWz2srp2I9rWIztmw+2vLIqM0ydfEntEbctPL+RpCWFpSljWVyNSgeJzOQEtRUSqBEQ4RkLd0h6wjWnJQgLqUEKyNSAs2U0cqIlKCFTe6sqrP7GDOqc+mzIDR6XmzvVES0gCFxRKVWISogK9Ja2lIKCTSsQoIutoBdalohQVOFBAsO/O3Nwd8VOciCITopA4wfsw4CsTGGqpg+SYxURlCNFELUVUKkV3hmNydByRgJUvq3JoRIz+lrDnwxNcEOcEbrErhZigjyiphgwSHlslJRFRM0jZigiplbHGi6Y6CJFDPbIhiu46/c8GIlEwI5DVNVTLCMvXBMXUOZo7w1Pe+ImEDYHsXN2RExAWMbzVbEBCuWKdDNXhWEC5QCV7YaPFoRfFF93BJHpvZ/dqz/dVqFiKD7yGZkl1L8KcjaArBZXfrbDJdy6Y9p9tEs/Y3HfOnXW6Qg55xWXf9rlfV/s6mqSigWLTmg6388dSqmU6biAsVmKtbNlEs3Wf9nK5GU5jVMOWCaTDtfp11tdNptjjN1nXBKlOw224kHOpTRoqwFbtuPOddwc66tPnspUTlBQ/LEIBnU1A+weKKFszpMYPmcnKDHTdCmigB2O/VUTqBrFeQELZARCEMTbZ3alLZygqDiIOCXQj5BD9jZ2PQbflCMIOgiqY3NEJEJHIYnlBjlmbXuh8hDsxrUGK7Dgm+yrmrwzmCwC4rNxgQ3n0OJuuKvntEfD/xQnxr7PvoR/Lv/YvFYDVWly3ik9n3xeX916NceuPepV0FgEIt9vNbG+u046aFUXFq3N9ZvK80d4qqfXEzDIM4gpNMpEjF4JD69RWcarRbv6jFxiDiQWG2urKIjdUUf49CvkTboRVz1gwG1XwB7LhhRpyqrDjCL5qgGkW/Ulm6y1io6z4IMSi1dqA0SsTeffc3yVNDMZUQR66dMHGWYBQsAQo5wIE7Iv4rRIGOSRVGbCyp1ooZF4upVPhVVg8rba+5fR32YLiaCOtnBG4Ef3Cx6ZOIjXN88nkAjejgCjeOLNJz46BemiI+Cf3PxUfXKdHQ82Ya7Mv0PXijiiZcb9UBQ3srUFB4skmcGpafTA8rro+qWIMLGE2f9fCHDsSHBET+trkk/kYsy3B8u4nzYOrWLB8yL2sUDF2ZFtKAkTqQ38CNoUglo0oUp3Y+/UrVEgLdvKhKwNLtBGCgBidptDT4HoKaBNYxZc/ddvuAFahLKSmWCUidSsYzbIJp4Xy0NhJ9dI9nIKBGKmVrInkxvF1N9Pwx4/uxV+3HBhuqX9ZAtGctWm8x2ALiH60JCBsppEWb/LBjmZf+CJz7+mAf08qD19wqdROOfPIis2UP4Rdrh0hDoJwIfbv6t/mfk/DrWYfbmHm7+FF4iYYjfF5KnJv7V2gzV+7ug1bABBOeXu/w1VA95uiRlG9dLsynIrr9RGp69BzFU5+T7Q/FOg+A9IZPKF+JmV10uwvGDq/O7NhFIjvJkHoZQl8WsewWKLAIsFdxjkRZ9N25kYFI8CB05tO/BcC27ARkR33+9vyZpGn/0eht/cCT+jRKPHSoQl6FR454rj0YebPQCv9EevQcpsRdNi9ztIj9URu6cFtmd9nlrSmQZo42s8/g9qiumf/2vqZ3334F4UPP3kLO8WuZM9fr4BvvaDWN42x+ARbztB9t6gWlq/nAy/w/koHrpn3r+6G3D2Dkw7R8DjbXCF8ZEhNCk+oMButylGOj3s1cJzV7VfDBNofkym681ko/xhQteA9N125euP8TFw0RBDHS9EVioN5Pv89QQyz14cmHdC4K7EeRTNR/D9QX7kvHLgx7F1ct5vx5H0D6EWZigKkb2NIeMDdegN2uOeZggq5ge2YGNfb/7GxtviO8/jy/wP1H+/enFA2OZZGPYZwAPPsFtXq84SCYXvKpXxh/eSy54Ze9BvwhAdC7pySXK2nf0Ch+dLK0r+6De2NkZw1DhZWY8y9HEAIvljJeQN90QTfA88gjP55An/lNr2SuVpoAcXo0anwmck6n03Rr7IvLVvM3l+g2nqSE/8uDTSgGEhtztZa8SalJXzEWCtXoEWovSW86Ikg+k0ytE+PoeL0+0lNxxRmql4rvL9+zVqECNUCDlcqxE7p5khFnJ0c9U3Sr19Twojwrd2kWRu8NWdf6r9qGppj0V9UwsgPtuvQX//ox5wyZF68PskDTDVyQRPc7bgDbi+M3D0n0jnvx+EE9PvYwd0kXFE2f7r0UJapnrLL1dFugilGpkViiYNFJ61RqPwizI0GJL2lDVvbW1KbF3T8TW255pvm9sBKTaZLkFqzlfd6NWVNl0fM7zcf5Smfw6WWUJFxqcvR5frWBSnh7sPj+42UdQd7jBIX1RLuUBz7zUsCzaF6yRd/j6OS8eA19iu3ms0/4eToIxsE8Zky53+2J9/r/90Gdvu+WWaz4wYHOS73vN3T/zq39y20XkgmCvj/lKMO7CE5Ngw6+Qi3v9Crn4Cr+kt0chlviwSvyqmu1n1476YnbLaK/e4uSyU2afz8V+WLLUCOF3aViUWzUoyq0Ipn1JdJNTtPkQhWtCWTlBu5pyTDIHOkkXQLp09N6AjwGoFNbAbnR+3hmGRVBuK/Y9+Itf/JNn/eAVF1PYQ+JbBB8G/oEi2pggcfEIias7Elevkri6I3H1URIH9j1kEsdPkDgMpyVwD4DAxScicAx27hHAXI4BGD3cZ7ms7Qmzf9jPA3cD5OD/szf78RutxbTssATViF8gMT+BGP0Us6A6stXaKJQCQP1i1bEmTw9AjZmH0JI63VMYkXLoKAqYIl2+MJu7QF3nyhPLh2z4dXzywE3GQIfzJ81kdJu6X62nepdL7yLJDW9+ei+3bmmikgOnSLf/MTg0vcXwgDxhiLW+gW39oYjf+XkQT0+2qYcjlSSIS6omwqGqUUeWX8XNSR80Ert4po2GWW3BRlbIpOYQ6m4ZhtWv+oWggD0ZNQ1l/Rzf6GqzpOGH5N9n+W2GIjCaeQdjy8+M4g0WqQT5HEd8jKuMnatV0TERgm/qpRDqFXKEwxEDfy37CTSkaCh/iw7A99ACRTgIuC2ilDjcvy3iEUJGqOBKvMaBxUVcpnGaT+N4KvhvwuOoT8mRW4omwhsaXqRFal7ZG4irueqt6ytlz0FNEY+oqZ9iQe+TVLb0gl5gB1HkHX6xiGdSLMGlV0BNV6C6XgLvJkJllayBn0r3Q/Fb7to3aEH0v/k1fBFvExiupmbRjE1FqjWHIub1crqgKKVrNGdcIlBnLZeDhTUUhoV0gdHVMfhoHAQb+I5zKPRBo+YBYzGqt5ovI16s661Ck1GNVQjMagVs8Dax1YTklsNtWhrS4jpQYQ7VQecQ9d32+euP3vXqr77pa1zxJkYuggRHDfOoNtLlDriBTcd41EUTMbtNzIfKmJ0TMd2Jr1rjMfKqWAIULPcXr/VDzFP8TdojDJ926zs/+5Fb3vnZr7AQIOHXj94i75AJYNcRAc3d7lS96Wc/ecgsSOqU0NcLb2JYQ84w1S4XdONHriCCsVH+qCH2npFR/a2ZbOfulZJq4uIRbEnMWDZOktnCRClte0bbb3kjlgk7aT8zJin97OM3Gleo1jTlsTgKSv+WBhq7HcnyVAtF3TEzneqD//VZTlhXzFWKC+U3ZVRhX6tIKtcCre/6oTIndWdCwk1HtGd4hM0gG0r0Hs4dUnhgo2CTs4lZGy+/mFyQfWQlIGWQi7i5qh6MhPsmvK3mTZ0KKXlqKjqiVC+LNUvTfC1hmHJ+qGnoNiO7GyO/tHRWiaM0D/WGFC4+8bvxDqQOTSwYIALFo4NHlmfUUnr5ZTRWxNyN4XAMBsZcyul7hzSzDl+KbptIfkUGjEqxbEBNXnpahNLTAi2lSfizAQj4pxuu80Se3YBVcbUQB0U69AXe6jiOrcS0NphuChgoRIsP7LcRMMlRGkchF7yqh9Tbh+v88In/QD9UPYHhP2eufJkDfl0BZRnHaUxd1FZoVoTzdaGSTaGdKsEHRdSbrSCLSg6bTE7RNHxYUsYm1VGZHquYOnQlVwKutLFbtEXsi2ZWNoYY9+QIt18MqozQdJ9nHfJjdGzHsPpAknMWP88ynDwHd1vqciz0O2zjxd3/d9fMn3Y9P68+n3d1OBj5WI1944Fu5IFJys73L5GkuzRJuUUmfurA4ruzP3mN8C5cWRG7GBWK4FW2fU4gK0OsqkzWRx1eLpFD3iJlrAcBsocm7b7H6BHkHfUL1M+wgF9TZD1QONgVUWXLooPXOfIA0Hk+sVi4RWB28MZz+rwABuBoKOtx9Vi6Ft5cLD4YM+nE2jbica9Fc7fQ7C00P7SUYIMN9LWMf3uVz83zkkcLtHiEc3Ek1EXFXkvWxqBjtJv2EK2W/TQAJkYaHOVLlPLlGfkMRvJ5qvd/+jW4JPkVUML+TyDcvwe/0tte9iallBAqLWR/eaO8MLz1e0RnX9ZIXrckpf+Xr0V55rsSFPqtjqXJrF/qyGtC/88Pum8zgxOfNm+ZpdH/w5jCMkIX0i1U127P/LAUvmSV/dO5lY3VTqpJOzwAp8RwwPg5sIM0zP4nWqYXzMnLfkOtx9bS/8fzpvqc8yBICnBixoalRVhi7e6vQhYqoZ5KkSDqBNTuep186jjn6wMvmGYP2PBfN93orL45VxCRnCuUu++zaxHEE9jARWDS1IS9vXo5mi6pQJWHVQXWu86aZP8pZNfroj7QDa8qE4jkdqnZkQR6cRllrYmOofzucW4xd0nw3DVxc4RWayFq7LvPoN99KVpQOsqMVOcpQuPURRxompEXwTYR4Oxzk29RY4cqgkH2POKnPbb0sGOPqpxB+mOBWiedcOuhp5dADUNM9fQ0e7MKlPst7U25ayLjoiN7nwVKosdASIWBsLaWSJEoz66VRAkPqA96ckOikQfUhBMO2HNS2yUynKD3yp6GeHRga1SJcWATAk3gJE1Qs47W1m8Ljxa1wcO2jf4ZWjHqBEE35l3GbVOzbjVbGFizTvo6ioGaRp3BciJRLRvVQeVidJ2r1Haqr1XXIiyHAiJjT86Nxz1+oFtIEnv/xmfzUM3+tzbyqDRSkwcldM3KWMsdgwCrbGLxOLDit8CK39RsrdzMLgvjZEYLd/jqEgocp/LflT3gwoCiYVVqh1G3tPs79w6Gggwb64OyrKNSlttsUmSz74XMTwK/sndwJZu3wLQZGuL5nX3EvLCo869wYNxemt7PqX1Ua3GVPu798b3Gk9NNgLDHOF8hguQNC+8IKpLBVWz1HThGKuzvzUPL/5dlwELWl5mQy0IZHRkOsqMi6ok1H0UOCmVaRMCFo/Yz2PjlREVZ4/DFZ5DB/JWeGAS37PtPX37gN7e/4Oc87AmQyi4Lh9kvWqMaxC83ixEN/9YhBevcY3s64Y2svJz3Vs05VKh83XPWM4/5I6cLqhOcqOjf2MFREeOGTPVQDqwcrlKUvQcJhQ4VzKDwJBFF1MNskg0KylxGfY31zM/zP8JzB6dh4phQK/mIv5b9hpPQ1Ox+YfdeizqDi4YTtRbh7fu+8tDHXvK5Uz/Dps6iKjIXYnv7yp6JuesimFvZTTF31B1FzNUq540fEiHPyz1/6tKneuEhb+F1DVSN8QXssjmo8itdEBf06mNS+qPJyhUSvhi2r/WjF5On/mk+cOPI6viYrrzvHS/7muph0lHPFa/W6n8Ph9CWhrptx94SiZVb0GTPHAeE+FgZEAw4BVywg++PeX6gB2Yyy2ARFpXgAN3KvmFvBKvdiPSTJ8iGb0SQGz509iFJkgL+AAVkH8EvBRtDsOUV043l9pmJ0Ya+PfejH+0PDRl4B87TfD3Aq8oatZ5y1/VASb+ezAX5TlBWekQayBrpGxHtl8uUhPNzWSx39yuWxRwZKLF6iH/ydmzuh/uqp2KI1u1GaKpHgL/qTdMeUYDg1Ep1B7hHasyh2itEUKBn/vomJLMi0tVImVDJZWOD0P/QBhv4jFLlVTTxsM/is1R7qDAbkvfcfEQZg8L03jBQ6X0F1zxN1W36hjf1lMzH8QMnEQI3cwA3N0fPye70ikCPeowg/iZPE97lWTH8YXz4QE0Fv6/3rOTXg+6vNlphpN3Atwe97KOAohzE5YGyTP+dvDGkPM9/HuCrpVa87pqjt0iP3kJ2eSg+Lq8yJ3sgBXqahyJapeUmCiuncB7oYU17DF5zlFt/iTn1CnX1b+nqH1tmVcXWMX/3s3oUtlMPqFZVkL3ADz28MI6LSUL31XCOIcG/R7DlzrAgKEBx5A7LQhyWqSDfVIuobDRK2w/mCZ+gy6Pna9qeXeht9YTsLQDCROzNk7EV4hKlD4XiXCSYgmUgOMfFtMBiWnA8TAs3w7TwZDBN56jBrz8CfilMroai1YJems9wI+ZY7fl96MwgomV9TkTPUBQMuSV+ETHulZgXjmGefhJtjncTp78PF+98i3duk+TwDhutNzu880fwLnyYeOdTNIp3/gTeIXIC87CeTEM/nWqPPfr56Qf8IJTzH1k8/xjjmwcA2jE/D+XpqZ5RgpfMrJexWuoVqXD1+DxxLrBGPXklls1NJln5ZOpJepKSLfjYReBsyuNGdda1vg411DKH3VCFbhnVVdXZL13PflLc9yXKnN3tVspzuIG3vknLMxEsF0zK1ZBc8CqcQdaJ24+zx+Sx5HT+5JVjnM4rPbFVa7E21N17JKagzJUb2dr/jJ0+uhfnR5jdrFyofomcRgAjr6KfCGFXlXp3UnlxHvCtifKnchdZT8P4vwv7G3/IXD+KC5EhFA8A0o5bUafqSepGP4A+017PmIkE33OLcteE763WqO9uhJb6TVXPZf8B9df0RPb0WiY+X14p1GxXTSUajHA//PYbn1b7rnYNWVbJN1l2Sha/zHI59opB+jyBK+DOsMRD+o2wsuZFVBqFD1WWwPEIB4gyxAc3u4wTGskmvR1tefrtaHpmIUd+RTFUa0IBElL7nUYvE9hRoW5h+tfBuCLBbods03QFWE8OjVH/OIpkggMqdkPcKkISt1NHGrqi+Ayqo3oLQH9W17KBcgbib8pYGSW5YInQqlxA3Y9zI4ov6+FtoUzMRCZRJh4ADTZ23fRwnulSAcpzRPBVT4uzIV5EP65/LiSP65oogqfsLXgx0o4WaKxcQcMOXGcYYGodZ/6czgKx2CP5i0SONtfQDkrkwFNtxYthtdtBQ9RhDjydOCeswFNVYiq8vncJf8YP5KoTClyTjZyeifmqp22onHoOlHUxTdHG/oIiDVr382YjstttNRb5x02wWvbnQgi2TYvFlFSVvt0jzm0di9rh4QNhebOu505S8/96/nRvuAxuWb7QuneruFeWjtLjxK/remYEbLpk68xwt6yrMiHOUGnoL4Ve47oJBHZu03yR1um6EjHSCK6ZWwcqL0r2Fw09EUlGFHgL6M7jBoDMLWc1Aakhd5E4zKmYgOK913iwoZhDB8jTlwZeoBfQuObF/fjFXET2C1ZbTJDIWMkqJbSyX27YfSGaqdqWcmBEaV/ud8iXKJ18NkneU7kGvz5byI3YdvEohX21vE5NzmsWTIaDNK6+RtGLGYf8F4tX/+AanJ7ELDp/mkfe2191I86wq96dSstXqNcasEC5OiO7RWw2qlnuyUQHpgrmcoBLRHmBUZ3K1Htijx9gOfRBevtxtfRZuxOh0/2dOHGW0CrK0C22Wej453Fr2R12OmaizpoJpmAUtN0jM+HTD+u+gTf1voFXvW/gnei+wXXP1LsGI77a6hT2vzZ6zeAXb5y8ZuD9m18z+KUbp14z8KZdM3gr8tbSge/H15W6PrsdkEtslyMnFR8r0tvEUKdCFMjbAkWK9zHj6gEEMWGhRSPTqX4Nu2qu4m+dfVOK84Y60Pg6it/+qqdd98obgG++4puv+CYPUi8tq/zwFd8QUnyTkOKbR0q4JFuPHyXGvf3ap3g1a4lZKYP0QSaHEWm72YJjsf+DbKa87cZvRpspb7/x5G2m/LJi48/CZsq/AS5yhn9FXORPVJPv4aLi5/wIk9XD37WbgKmryLigvKyvtB03z93lZIhEWPq7xp0tksuNwleOyPhFhn9JnnbdtbgSdwIwRCcGw3QQ8Dq7kafOe3KAPQv/wIy7XJwXPyVO00ZdAwYbbmfHybmqqgBUGNzUmmPI6/bUjHtwA3cRToMEKBwFEOVBeaU8oBCXCCdAfXbVlRN+BP3U867hR6hm71OcyBHGjWOOMMLjO8L4NS+QIZ5yJbN2OnYmT6NDvwATxr9gN+Fn12oq/Q0pgpaQObrwUKWnkTL5uMnkq5Ef9iivolkAVnJk0z5Tt35jX75Tv6zeDSTvkV16edeN45devOqlF+8kL728/BGZpH5ELf61G//tjGiP+kjxxL37jWM+Ut5x43QfKSFamRzPxvaYI77Q2th+K3xOCDx0r66sox4p+0rfvT7x3khXqkt74na2f51Mrhfz03/RNWal4Z9r/t/cN5arU6maLlW71kUokeJU//8l4znhCmydtuvWSYUJVf9H/ev6xPB68TXIrwcj73oMG4sKfvhk2ot8J26ybS3Zkl2rt+koXPcdIyPg6QicyBD6IyBYDy/3Tb7fdFoWx/ySHvXV++OH/TVzlE9SWF12yYlRrG6I5OcoHFlgx4a/y3qiydXAwKhOKBRL1Vansewj8iQP9j1fDK0mzslRahzGKkM0jQkY2TngYwr5wwQsT/ZpYT64JHxWtCnkh+pZtMf0LFBY0eL2oRi7HicvljUjVK3jsHRrWj1y/VASqQOUiP8sbNwdXbceHEfFOCM/+1s0Va/BjnpbKqLs75CmMru92Aubq7WX8DklwKYn/TFu3RV1qlf0w41FBH/f7ujH7j3n62eeifvmpTx2+o0LEd06z2AJ1aGq6zKDQVqXW/5Hik2v9qeuDdRYz256g6jMlxfyzQF/3qQ6l1OeOl4JLqQ8px1wPbffQk29Pq+l/ZBrPndrneq3D6mOvfURU2RFE7V5ZD1PgAmRHkfizjGQI8K5eUj+BaKQE5pLoaHCHgzMiNbEg0FfPKfvXNOJl/09BkNHId5gJImq8I5ODt5RFd71EXjXKZqAdyQSboZ35Z5/YwTezQq8EwvvZALeDVzLGIV3VIF3BHg3hlrNVHhHDO8IDNUUeDcY3nWesuKdPFVDghQ4XejsfoVc/4vnYB+gqK7WW7IvIsnYCtSNxl4RKIOLAkSr54OYBvvGTwx12eQUOMrUMr+EMtXywzF3t7yiTFlTgXWcbUhSCKXKwet4VZT47FZkkpHXpHcZ/UiNvf8c/UwQyORSxUjtmcT3P/FK940mWL1I/s/qRf69X5HCOZ11p8nxgVdOUfBzEHA6hLHTIYwndQhduqSCXj7MShhdIEvUDz6ID/QkIuDOHNVX2XCJON3aLBFRHqTDIQTABGtROqaaORQhFPQFScgYsklcLJIqPEJzUEH+hL5gwI27S7FCvEIiO4f4ScGovmDkZJHf4/nTXFz0vTw0h1mWlcZLIl7xUwQBG+n7h2+cdIPxTepQ8NijcigIz9Mn71DQGa64JvTMdTLHhYWOmKhyp/JkYu2nkqCuDFCT2Z7xqjYcEP5qODocMpm1ZrBCKzGMTuC35INTBuz9W+o4cO9eF/LV7ZWXxnYO3u9UibSFxj7n63/quLcyI9wNV6t5hPAXKuFPOVOeUkqqJd5WKRGk7jDeNZsmCfdwc+WLt419MXBfSJJ+cUfli/eNfXGn+0KS9IsN+UK4WJlAfWlKSVNza/NvMD0ahSpWVaNFRy56EXOCRdIn4j+WejfM5K+rtXxtT95secYiEW6UIXhQgy05UID/BZSupklDcWmSvCjP+mJtGcVIw/I56mDA5hEjPcgX1NppUw88F9WnChpfLCO+S8uISlAh8svJUf8rN0kQsfdpMOTgpzQo+KqGuNaERDnHUJjt/L5E/HdZzwIBdsRiNSAE++viOwESrC1iyT5foYS6lB1YE6OUq/y3dRPzYdvEfldAeE63tk60Pc+5ki4q4c7uoVW9Y+oTM3bSaFxBxTYQpqXF1FcCS2AUO0tpKJ1iWuEv5TZXjva5YwUK8FlO8szyPNWWgAewz2IHcfpDX/QKuAJo2ctT9lnsREXmqz3fZp/FKVx5cWqZ8Fv2WZyGhAgJe/la0Vcvts9iFxfE1ZCkXbHyA+869hT7LE53aT98dXDOa7esP9k+izM0rTiTzuSQFq0Mn30WZ9nPKeIQHhJsffgd73r/m/8uf6p9Fmcj9mN7Dn3gc/98x1PsszhHP5eOvv27bjv47Je/8QP2WTwOUEbK4cU/2DLw/vmp9lnstin/33/40NKBD/3HD9pn8Xib8szvwb+fu9g+iydoCmD0ROIeVRqsTb7243/0ny/8s888xT6Lc6Wgz9925ms/+5n//AH7LJ5kq3jZ197xvX+19Xefap/FeTbl4z/wIW7oGR+0z+J8m/LzD2Szs7PXX2yfxR6bcqk09Lc/aJ/FBa7BEfF4ewaB7bM486HvZCT/hFdc+NB3FU+m7fRkjMSpPFh/yOX5Jpt9Fk822R/6rvwiiuiJhM8i/izSzyrpp5KiplQdERCRBO2IFMmoRCkqEYgsuuSUC7rQdOQgRgVyA09mmGm3eZohpMqAoTX52IARhofMYJABPRlAkwErVYCYE1EJsp3VvpOArAqAiHIGATKdyZnO1EyV9G0gzyCKXZCpMwOqqFx7YhVUyXTuK43OeSOfFyIu3gKKA3MsW18oZ+vYaquWOHbYiaYv0Fh8AYuVT+GCC2rhJoOa0KSngNKcaowJFtu5pzx2F5EELqJtknDYJGyjSBMiWGnUxZa2ahv4m0hoWiCrjZBzbgIXva0S/RUbHdFFGDwTjSUB0VzfqSaaVrGPXKWtcHC51TkGaDJj3A/5SAGdDMG34pS3eCoIsZD5i5FwVr4XD8r7NK8ecYToP43h97R+HU6qLqanHcjny8rzbtm8fKXsQL7V9lMXjCYou/VmZdcYbhPNrwkUsNb0iR+A8yIy5zFDOeE39aQby0rwFNjnfmHh8wlAUYhVL8akVfJRhg+DkdUFQj+Cs4etNJaYmUTiIS/LWRnPRSYX/Eh0xxI5MgFeFH2szW1prU8FcGIRgF80gKcmL2WSK1a/9rBeK7ubHvXWaHmN6xf7taynDyUBX83SgqNASJeVXBS+E+KQWh3GCPuG+RQfUqgnvhRWAblyXO1E1NOQ/jR6qjKgGRbKjGYROUsNRDq2pMKP7K3wPNzsJavAtat4Ck8O3W81aQYbDWM1skfzwtUUKxpTcBO28ujyQ/ZUibgPWVAUUAfNOkXtG+YziuUKurRg7kgyZukNVbg2E+85PL/wrOVncqLYFEYhtKUfCQYVwvDkizzcW2jlAHUVtWTYeAauUuxcjuhwnSm8/CIYIGSEDMM4H4kqeFQQJ8W0TSIVEW0SWBVFUjo1j4QsJID8FgB5S1/YeHUc16Yu4pibsx6EtJ9d0JWyK4XpyqJ2ZQtaaZi5LgH8VAjIbYthel3wpDB0fnH0XQlItZ2ujQXaU5g2LoAFXCAdYUFc0IS1Yoka+qbnlKLBAuuflpOW3ezsDdiJGHVC3pzYXexlcv2BjFaTj4YXuCWj+zS9cOZRYPxa5oF1aqkKL6pnYe7PpH8bRhGcIeACfdXSYKR1aYFaExwllo6IdX9/zNNLcNEUnrQpkzkiPMk8M/OsbAdFcgvbmWprP8HlE5EBhyINDmVTyECELYdQZLgpzeDRgTkJmOSpmRtH1jZt22wbWhJLDXgiFusQudDrBrU4Bo/9uC2shlWlnrAsllIWz6X2GHEGcJvR3aYeM0b5TD9xbWvTDKVGsnxl0e5xuSiGA+lo25y0Dy2RbmS3Fx0VECSEo9/sN0VYNnukmNv3IzddvPbXj/t9kutSs1xmZ0CzgyHN0RzfhO/4Mgb3ezIsAM3IJamOHpp2SjkdRJJSRhlDnSPrAIp610lHb3cEtdrVTx0OcLkQhrVElBqLFkFGafZbVj8PSOGpWITRCpcSA6uY5ZsdurPwmL7AD6be1/QVl/WaUYtfA2sNR8Mi5rDWcPSoC2axs9/Wq2hiZzKPq5c3IooH6S8GrLyhu+GPjO2Gj7rdsCTpbviuyv75U2NfHHNfaJKajpIv+lIc1cyUyN4moj4s4B556sUI14ok6gGP+C0wb/fjrWrnLVgXZMW9HDeevQL5sYJIRTj41cqKuqg0yuA4CQqulImLWNVBtM6OEiByYugObNvxx6v4yQ4UPuDrw08f5jwWzuvlRJDkZh8P8e/cqDfSBQzkmy66NiEgaTZv2UQouZPPVaECtT8WlbmNq+/01xoJ9Fv5T643Rvw36ZkFfcNVBh2gL4wN0D1ugCRJB+i+ypAedua17jc5jmGhxEfn+Ud/WqKm69IGxzSVEL6nEr4fYW3Ah8tgcOhnEHQGWT94HTvElzj96uZK+A4NQ1z5ES0B7T6qsQgedsENCd5lIu4C2yc91q5hBuodj0MegphEakgOL8CHchbBGrmayrsgeAkFbqhaUH1+EQXGGuPVlftBBl895UXUUkzskLSoMzV+Xl+GgSKDIAFGWqJwoSOgQC9IXIGg3qD4vqrlvixvSMqnkJIhiJsiVnH+fsQmoiWoA6hbEWpoGi5Fq17t76peLR+V5Qkel3OxOhv9NbzvLeciIhpuLsJ5vetvsi5zCQxMdS4myC8Ay+ugTleJemg8YmKsXt4yaRpnEwn5Z/i192JiOq+TmJGREcg33azMeJxkdsqcRB2vH5lVB32VdjZlMKCPin6PAgW20z1qGnvxAlwFEwCwO7tLSGdL298uJ+sM2l1Hu1uqDqJwSTHcwpErkUk2IzLuVge6JMK7G31d4JoHSJTCZ0Bw8Ku9s/TCLI7f/nK4c5FBu72I8dxTNI4UndHVUBKITYkP3VoFNIBNjwy3QzK8JsPBYIA1bygHabhSgqYc8km4JsJAcl3oqdIlc0nDr6gyq5UOBfqlE/bT1zzcm8l+T28XCZDx0x2Q7+5YytzbuL109VzbcMeM7now4QRr43Z3dXMwrFwZHvAdVC+Y1AnSw5Gu6t2tumm8mnvEjwW9upPlMR5d2PqhmmrthUIoFiS0itmmp98ivIW+dA360mAk9VTsD9DFqjnwz/ihUOzR4+/kOFcSGrCqxeXi2cW+CyexCZbCS/gRX1i72Djvr5roVF3wtHrHKCjvGMXjV+lje5U+FlvvlAIbUxFeTr1jFMjZ1ohtzmB9KGILwOlcfiT9ixk6e0BccEicqAmTRMGeAOwLmjlDZj1L3o2gqNKfVZawCyG1H7aqH7RQN8dljIkA8R+j17IldQeX6RsSAfMsWwO3JnkCZyharGuE2SfFeLCsPES1TYxGQ2jeoDpaaBc+fvPk+l+dkGNgA3fawFEOYGm7iZ9YoG6TJ3/i6/MeTQ/uxrO62B2zJdxnAw+YTw/h05v9Nbt+UU3bZO2RUZz9iQFE/+ArfOeojrfNiNBmn8tHtqT9zlMxxOzeW/y+Wnlv83tWeZ/h99C9CycdWS1SPVvoH6R8zp2hIpnxFkwZp8CXAvIX89SAP9TCF8t11KQU589/itZrn/S7gEyGFt7aZR4gt5yY4rE/X9AzjIBmlPK28VhUOrwkRcuGv0tN2aX7tIxdOy3ht0iwTd0i2+xFiVgxosse9ex2FaYwJN8KIbWMhtgjsNKPRTxYzILHEi3jsUxb8NhCXYhgurQAOkjzNIc/1kOehdqmR4F6XVdOA2Vpfxa1P4E0OTA6PNxK5R9ALMX+SnxlT20CBZjCmkIuhewys4jHorVGsoT5vWQEMQfVyCMP3hXwyzOHocrnSAfLyus65b2VzsS9FWzKyuSZacntMrk9LblVJremJadlcjqRTE0Nl7iTHVMbuHWe8E7t6P2eHLCGIwesnjtgVTU3ZQsC8jZE0GE0vSNIPADQkb0itriGWga48RSo6Y5w44jJs8AGVurVs9rSqzZGiur2tJbXK+fL2LMHtL6wodnvozOD9FqxWyDNwUceo40naOPpyW61H+O03UYkFQrujoYDU0DVAlp5/UoWgPSFnjd1Aa2BIoeMPhl5L3BtEuPjTstdV0ldL7v23iZcuPFH5Osi+ZHxRfIaL5x+OI3x0ENXppQcQJh8feJU/gDxj8D1QBFYbQQ9rucZF+p79lGpL0bnDbzTrza9XqkBea4ql+/hJEy+Z6u95tUCktG8Lhq2ch8XBjn7P0q+mq87+DUoxucpUMVc7dMbf0VbHc624M+46GA7l+3PZ9U1REQdLg4Trk2d/VDEnqcQdABy2a/XLhP5c6hK6ktgtJdVU73L1VJXhOZbKNZN6ApFWmFPVPzcJcNidX+RcQUZD89W8g+gRhxdSB+K7dxFTC7Vi6gTi9nWDkAWhBemm3gBeQddi4VDzp4NLcHt1L1spRQcZfLMhARyS2NriG8bdWiFVtFAfvbwzP7Q0HGGiTq2q9OWA9JSJKO0OdpKCeqlDoS+3HaPssd5NaTzfgAMdLsfar2+Vuuh2pYhWAA2ip4ti6bJouc3L/paV7SjlihXgN8mMLUyKBiSTGHCMQCyv1+1VRbVfJEnYMwEoHGeSYUro11YwWOFMtSTGb9OdR2NTMcWoKur9kiCRiXUAKo0qMnf5E1z3AwdHv3a1yEdxVr/4WFtNoG1bWBtRG1ga1bB1vY3GFv9f1ts/aNHhq27/KnYGj56bEXR07A1/GbE1nBzbFXSe6nnvcyJ4EGTPTcbiwg1h4SHvYkWGBVydDt08vmpJQFSU0sKj1vSHwSeP3k1WAF6UyC7Xr0ocHNQ3fZqhkPVDK8fyQC9S5iRUAO0LWtaArHvmhp7x9TYmyuxH3QXum70KhUf8iZb9pJK+rWTyQcqyVdPJl9RSb5qMvmZzkmCi9xV+easyW9WK8k0mdyqJGeTybVKcjgKZifS5lvbgVWtc1uT7GPqfYdqz217hq/Qo4zIqeDKoUVpKYOVe51N5cDYVOaPVC9VWKV3NyOcCIFZG7F+FFumSdxNl15WVQJdvQqvPqCGeQNKzs5kNNXbmpI3KtFNcnwfQfD9U5849b70nNmnst0+PnDZY7RVG1VjHiDusAZatLM/s1YnsBPFdGlUranNVP2yqe3FEWtq+UxFsqAnIZzNaVkXmQ5NR2b7RvbzB2VzqlfXYA8OtSaK4dhPGy8zbwcs7QW3WSlC1CfmKt0W95q+nCDOa4EMRAAPnWHBV55SrNYM4GeJ64I9Ys6N7QPNaj1/Lox13rTL6TxI0rypVhcD5ENEUjn5KS2mHhMHxsjS37COeOpA0ljKwOyU5fQONX0jUtq9wm2v2g9laNDeIbXIDkeqPehQXb+G7senkIKNFbbKA/6owzr+1bFKqVkZqybx+8hYmeDRiwYYN2nKmDAH63VdWV/xXnVZD6tAL5+vSnnk1JGFLLCnACyWs/iA6m5fdKwimdMRtxb4D/7I/1d/59PWh3xGiH0FJfks7u3qAPXr+aw5/upbu75wJVNX3LyE5jcg1dJVpm61q5tOCCgYiGIFrpiVDbEufWYgjaX57H/pGq6Hfy38ZAWqQiiROwVU51VAN1h5PUVWzDrpcU0ziI/Nd8GeocEiLvd/o1zVok7w4KzI2MLqUgNGXFJ2hRK4+In1puNIZ7SAYrR7sV4JjjO+eYb3wEk10V1fbToXoAzB2JAOVT+Uj26+DxdS9HzguMOUp2NF0IwLY26PjGFQ8Z8IE6HNCcHsvr2Mp67BQMom7ImiaYCPs6Q0w/iRXn96yzf6zwlL7VpisiV6aVSabSnqeYL9Pdt423uNFeNVCKTAQ3vgThMckJrVnX6qlzebDA+c42KL/Ky2B1dkwZpcekFFvgTbFKk6TxOn3jHxo6NiBujaZgh6Epw130ByoiUhOC+Qe2hBtU3yRTTINEkoG0KXg+nAlPW0piXmmXFG8GAAh8vUFY5ZLx2k2WeFRiyaTqGMLWIA/FJu/yLsrGSX2rjncFwKBaVnI035rhmtgjVVu9QhfqyUC6K5aM41+vi7tGedumoftdPZO185lhdztseBXuWDWcpMxi58z4VHVV62Ii97JdwFcLu0gscK+ZCPcUtLl7ZgVLegPCzLTTkEQWgV+sJQGmsqwTLwybeqVeFteKhCDQV7pzoBzFmL4s6A6oTAwAYO28BBG7jfN4F7bOCYDRz1aZUIYCzW8h1c104e0a1ypwwvfV+0y3bmp1Az30k76JR+XZSStnEIiKRaP6fSdjLB0/oe9G7wmWIOJxQQNUIoybBVhbCcTnNKQIJsyIdpJflyOrWS3IWCDQMXSyXAzBQVLYHjhmbZnOZmzVHDzHAVPC/6YsWJ2zN3oragHVxoU9vCUEL2rc8yu5SdtBXbEdazLFu388St+8YBK1V0Jx7hnQb/zWA3tda8q6Xyd17e47bssJCiLqoA5Naqqlk7+d20cm4sqYf6T+Gye9TmydAygDoFgKJ+61IOE7YpRE1ELYJa8RzfwJ3Cyl26W5nM7ILvZMCvg8cpVGeYbXj56Rrw8zOCvSWiKUzoDAURgqdr0ECVdtECLRuIVsDVxIa5aTRz+jNamkCrWaxUB00B5wZutGKevKcJrFyNeCny6sBpvlMp15ybtYJWlLxh6LQaQYWyLnwrZOcUiXUx4+X0OADwnSLPU2hZnsuQoSuBEtxY5GBgaVWtf4gbH4D2WotaHHdTIIKH1we6HQTdMmmhcnyiyeSoeGpWo0aqG8z8TP0wP4uzYX0qzuZc01cocJR5RmeVC9U5dCbx43FuoVp1C9WWTRYqIBMWKvJzksVq9jiLVYM8JYGdycVqBmnYTJjFarbSzZlysZolMovVjFusiGafjTQdzXOIysXqceOLVUapLECEv+MvVi7vtMVqC61qRl2d8rxctPhAkDEJOKerV+4iJpcwAkXj9o8sYTOTS9jSyBJ27ugStkuXsFVZwopv6BK2RAWAu/itJez/8iVs0S1hi/8mS1ihS1iBJayQJQyTH0vYzEaxm3ZPLGHnUAfwexwe31rCKkuYoz9uLZtIOvlFjbCoERlhxywHAwSFXOdN3QAfd9+0+ZLk1qIZXYs6FJGsTLGuTP/Hb6FO0S0UP1boHDwYYfE45bHYUO3kwM6pG6oVuXCQU8+uUV1E2Ks2p+gaRjkiJteoHh6MB3ic8q1N1zdixfrWivWtTdc5eOykx+Gx49/l+rUX1cgChUYZkrXTvNrqNU0xSF+qpGxHmbuS0xE2rXva6rYTT9AAee44/hYOQaN5mR6JQs948R0/93Ou9ZK+hOF8qjTSXOMXVb3LfXmHqZxET14D0EY1U40QbNuLUp5avQ/EinRi1I9D4mQcTXyyUlYRoDQieXSNsUK2tqHCTXuGptovotmrKnNFfKSoj6v+wpS0PxjAAlCdL8L4cgSFsrxSGTiPeS2ApNfjv6eW0TZnL4/dXRy/5bmsuFrhVIhgKWc0o1RdsdFzhOtHZDzqeRHdIYbnc40j6hLYAYB89wiQEUeFdEs03dIqRBR2BiLBSUOkdtIQqX1jIOLOLSeBk+6EaOHr4jrwbmQp4HtHz9C+ZE1cp9/JqtXu/pngnVrbyz2DrXo9DAf9gVVGt3qBeixePQi/Pgh8OLauGBgNtYF6kBepptdZqkm9i6L+17dDQa31Yj2kQFPUw4/HtlICOAp3HGUMo+0e3PGUbFNoHFJk98j5bF1GqX5lD3nJE+U3q+MSQlsVLvnufCWyJmplNUGr1MR+gOIyKW5/fxA8n8Ls53GWIo3GzOOHmmSVatVOvc+53mFs+0SCRaq06qMPAFPhkYYByVgvDeKwhl+L+pUFo0RAaDYHONZ8oIda+klZqx7oa1syaWr2q6gZXSsNOsfpz4ahDoFnVZmPBeXdHqgpOoBG5OxPTQRq2fvVB0X/YOHUg+tQDy4eTKExIeZeIz31rhjpMrfxOJssOELR+rucNnQAbWi+DbOJArVcqkHgZhu4gwM4BruWAmhH3+ipfewHzPMuTQ6O4lnVjt6wBRyzgXvMJ/fjedBpR2NISs11O82uwIk+IWOoVrjr0FREV0icLIi/LvKVmK/wmygTiNMJSGVQaNDvlDdsMg59JCjdfN0VVMYBdAgzgedBUXN2pQCru4I1rTNUHAfJpghEDMNX9ZuLbE6f1em5BowAzg/OYCGCk63suu3O49LBwOkceE7nwLM6B1XVggT8lfphpNR6pU5BD1LR19F1tlF19iqWPWNZx2OcFqvpQ1/tB0Id3TiDE73eNgOZ63aWk2ewo6CWtEVdqhWpmllKSwFqa00yaLKNRUdm1BZtW5LzBGeJ9/uyf+xw8B4NZmhcDcrMQhTmdKsyL83MF5RwLSpgliiW2YiHuBtvISQDmkioBbqgxuv5PdXdEZX7I/SF3+eI/0oTNinuL6fWhI06d59jxkwV0c118XjKdFkx1gDwrE1J7+WrxFsvqGuhzAQWa7o8UMIkL6n9MGpaizV1qpfCAW7UGBeZ0jJ/adV/F82NHTRZb5VzVXhm+dZpFmu20VZahaL8dto+xWINTbdYk8OCQDHFYs0OJGyfYrFmp7Ecsn2KxZpTXNqExZpTNa04DbsSFD1psWaX/VyMYeAhwUmLNacjdsJizRnHs1hz5qYWa87a1GLN2ZtarDnH2S55HHGPXIO1yZMWa3ZPt1jz+E0t1jxhU4s1T9zUYs25m1qseZJr8GlUTLFYcx5bUFmB+ZXz2bLKdurRdoxEQedNt1izB9nV4Mp27v7jCJ+dxp+dpp9V0gtS1ETVnJUAKUG7VdqhkQalOPGUMmTRZStt5RBnssih+IOH/Hc6/7mBJzPMdJZ5miGkyoChNVtdIfrf7inmbcgAmgxYqQJE7hCVIKNq31cFZFUAnMbVbSNkOo8znaeZKukrshQsiNlCWmDWeNxijaGpeVMJag5Df3VxFr9ACQh9SlvEYk06apmmpukLNBZfx177AijRUJbXqKN+f+kCkQ4LjbnHL3qwR1MwNktgO61Iwv0mYYVO04TTUsPbak1bpBm6xexp48zbeeQLyS5osuTzTJEaOM3ddkuF47OlEqOaueyD+BZxVEErlaguok4D7pZROxG1QsWYCG4LhC9baM7q+7aN+ZtU+FVV2WIx5YXlSvFkJJyVL+FBYn/kIu7NRTB6k9GT6aIDuS/V5YvSkHxZmphvkR7kHawzWAyckRtdhZbEdIz2L1+gNvHjAmuZIocbtZpKCSB2lcXjApgvhQgrhgdnwJbna8cJssbWFHyUMeS20FhiZhKJFqgsZ3k8F5lcu7mIxbFEjsQtdLlUU6NZaW2T1BMawJsY8FIXRm7qisnSl3lYmhAjN9kaV06ptXBTM8KpZtXCzXZj4aZGHBIMbmIQm8Y9jLFw04WFGzx8jG+KqIuQfhFdqMxbizxjaKGhV5ySIpWz3lLBq3+wZOMazs6qnX/UUF/yymj1fwqWVjXFmFqNbcqrndFU/lYNpgKOVjH1bwMfmlROrFG36syqOQbDF+pcXu2h69WjPwArk5YRLYnd3289v0h0I9aghBrM8/yVu2CNlNYBTgJ7BEPV8DvUBLvnQbTuMcLDeZXcr/6R/bgP5TjRlprLBCfoq06mR4k0rxAme1BeX/rgANy/USnN7tUb2SnVUcnmH/gjH1DriHjx7r8ct+MaooiY3S6QqzYeTU+fVToHyhvQ1BPFzDyt+t32cl/mjO8wK6SEm2LMyQC0pq7ApuDCrTUY2AAJagCJ6k4C4G0UrYq5YRu+kz0ht4ZDCm8Zyt3jjYqH5IDFBP+NVdcxbNgM3YnJr3rwan5f9xf8Q6FcIIuMRRZOENvh/EDbrH0YdWo8rN65p1p2s+xSrwut2Qnlyfnr7LDYTQ44dKuEvIooomUu1IFNRZN0qKIhIIJQPDwi1YpPcE6Oh4NKM5RPrYomfjzyEncxze13sKX8vs08FOjN7PUHA4CB93/fzRH8eI4+Lrcii1I5O7BA34t9D24z41BIVTthyQXflVmkYFWgvbSHsuNy+3oxXEWIlGCP3NeEoKUh9eRN3V2IEeJsTVfPwm0mRVbVNNfsoRzOteSBuiVBieb8K0EyRrlFdXtyxI1pc5PbvLIkKnJMiJOhiqnnYLAZUCrFFk3y5CCshm7KQZhHEvecZ6PPDdFrzT4FuqCXJT0GdEpJzv1VkDWVAGP3aPc/TnYq3cv+lwwSgi5FC/7rqopuVjQlSZV0kVN9ZDIosDPTCGqKpi7gDSdC6o+BIl4kcYf1BUVTTRY1s79Dm02D8S2arEXoOWdCtpraFF3gCooIhCojDFpd3lp8fejDKtSkPSgydp9jUrNTdYyTcSzJ4RCu2UIzEg2AX/bQ96l3Sq/lA/aN0q9hNZlHqDFi0rrhTFo3Jk1au3RJlcFCY7BE2f+0RYlArtoMNc0fEscD9cMU16JdoyqZdYJ4HOU7HWxJ/hySodqe/Q1CzIrCJziaD4PWR2vAvQiinz2bGccKdlFEeHbNM8H1fJkJjTW5RcvP7DNSOjUA9EZ/j4itzkU2rlDzYHRHrXVz7pcg97W6fPPs9xXhEtfrapcBAP3UGc2uGm3ya+m/nNWqq+Tu2jojBpCjOarWHORym/mVvug1B/opPAay7SO5Mh+rzETHhGKgXd6oXgGp41aIGcWWSnmmqUF7RlfcfdpG7/hDOc5vA8XYB5eI0V6p5/gzaNmNGu6IJdzOi/bnGWJf4euRPcI3aHhOc+uhvS2FlMls4wCfGVW5wNbIl9Ei0yb1oGGJWJ0zt8T+Y9FlftnQMMiYYqZhK0jjdrYN8Vo2vUIZK4Z2ebRMS6BdGmcP8fky4LORxpVgGyJVrOWxmxtwJSi0cQl/lcN37aF2Guf1Y7mxjCg5cJ/M0azJGIvdTS6g6Mn2Q19foa/OlEAMEMe0BC6WW2qP5OvYYaygWIsCiKocyQs56ip85Eje0yN5r3okH0yTI+FI/pXgRRAalKHDZehgGbr/Rhu6pwwdK0M85PZoPl8Ty5I7qkfzO/q+rFM7cKab76DCnDafYk+b6+60ue6O5o3XLYNGVHfGEE+xm4feyHGz4h7VndCrN3LeHKvJwUy2BWpyEG3B4Xy9bFB9swbhvpEHbMHeBfLKEzdo/oRtUbOPdW0LwwnZy8P5HXo4X3CCbd2OE7fuGwmu1EwBynGsamaFGfK6qTmPtWS1cnsKtt8WXipTBPxGzuF38Ltp6vxY0ilow04u/RTq5AnNGHDtLI/o6/aIHltATHus9isbkM5OHNFn1AUUAxzC3+Dnp2voRjmPV1xzMNEDeXQJ3a2bU3kHXNpFi7TFAHZE5SFjeLpjeVOoFFIkI6On4HNDONoCUP3TFGCuVrwVlmi49mnuU6mn+TdrjhixM8imtQlquCq1eCVSWrKLdKRqvFR76r4FTzHQnlgKlvKQqMFOJWYeFKWxyFQUpT1RlPZEUdobU5ROhVceio0tR+bbZr1qcrIqSuOpitIoXBWlFeq6hrn1rEMeVKWXRT2tw6OhqtL8eNzoOobHamUJm9cCzXIG9BpZzmaPs5w17XKWTS5nXbOcNUtNadfPbrmczZbLWbe6nDlN6Tqdo1WILZLHET+Syrq2TO3p65r02S1pLiOWNEYOOqWSe5XmNKNd0PKeWdz406ruYUI9F1FZ2xI8ErvEzY4scd3JJW5lZIk7d3SJ26VL3OoJl7j7X1EuXWXoWBk6qqGTWgpXvoFLHLfj5Gg2N+RbS9w3EFypTgm7xLnVTSvNYy3032J1m9XVrbuZynQGAD4Oj53l0qaL3EvcEqfNd0ucUn+3xGk/H8ESd8O0Jc6Nnqt8YnVDhdNXNzTt0a9upspJOrXTrX5T00fKn9AuG13vnA61MVAthNxdIj7OpktXq+k7LrdMZbpMnUOBrlb/t+zAoEYdq/50YvSnH5sd2U4O7Jy6IzvFLmAUG33Dsa0ZJS5eEXLaOqZK1N/asX1rx/atHds3dMd2Dh7Qpu6iE9/av6l+NWrDQGAZctXizeJQVaN6fF/nMu6cyDi510Ptm2lXH2/fh+DmnPkNJYkqQ8dsCORZlifsFouFfvJsoUzzY1eRAsbZREBRh8eQCjOiQE34oZ4PYjza8C2gng9w2FcBLQfUBAxiaQEzGqqa2OXI1J6nBUztgOZB2bXGskTj9EANmVgzMgum95RegGJMs3g+JGOthEiXWyClXVkkUBltI0KLdK3UPuR6miLnBxTRAvgBfp+93nm8sMq5afo7nudfqyaAss/fqKqivjXaotofwaj2hy8u1aGvCmHvsX+6/lANAMy+gK/Jc+eYUKVX378Cn1CMf23kkfrHqX7rZrUzEaLuVvNYKwvQClG/G04pndhvh1dVPnauDzzre6ZPfXYWL9b1X3e9yP01PvuKngJUHNT/ODwbTPhRsMyQAjewrihx1B0xMtikhDQuvMzERfx6oA/X5Tj2vprf1oz/SXVRX3U/2RLl7k/80sd/iU+4fTF86b1IvWkTn8P2P44UjuTHx2tsqlJdNmYfEQvF4rUmONk6Q1NnImr7FcVLVgr1+i96Pheg/grku4iC0lemVKP+ZJPzzVdQGxcNSWfS05Oy8QjxkLTso2jpip6IRqLOiTTUZTUJnJuJTpr9HuJq6as8tmwaXDthXtSXE2LRGFAn24xdFb1xVRmnGOsYTtWsv/0o+xlweeD5cKacQbUfge7wCDrmFMjTETf8QfoEz3s5eaerJ3+x0CNwk877/Gah5ZWuXdNXe9atvGeOaS43NomZSgCJmah4mB1YORiWSIw3KFoX9XNRHLWK+NJNORkMtB8yJaIriwAWXkOC3/M14FKvCI2dQl+/526k7ymdtxvNdNXiD8w7EEXM23n2Cgr8K3K5EfDDEBe4uvF08DDxjEk1ffBwoWz1C4MKtKRYj6xJL59INPAkNNWnFInrm1C+EpC7UpGFC05v9EbM7Dl/FcZvZGiMwOr0s1YMd0oD8CIKvfIIcZAGBE3w4LYqqmJetLBE1teyW4Aafe+HAbXAaVmE6U1xCMem0KJ2hCY2yTH0Ynb192RvMuryn/ojvWuhFr5Dqm+i9t41Brx3UR1FZGogbCceojpOVjUiEju1MI5NDWhkQJMl6rPu+BXXQHXaGoujELkihiRCxiNs5M6pI7XnrareWnJdy17FTxcIYyvJbgUsJDrXLLnctJBbEKsSIg6hCzyynjCsNXt+SnVUKXdn9ayeihTDg14ADZxutG56sHTtokb2JtRZRITMRZMiaLxhu6itkIJ4vUVyl6uQerLb8M1Kubw2RO/I9amIUEe5+6JIOzatKymCaru/TM7K5JYCGbhmNSuAN/XsZ9U2BOqtSw5Z2c2QaFQid0PKTzhP+VWIrxT5Lah8GDhVmBehdqKuSuTP1hEDHQCoqYH2AD7Gvz6QpwE4wONVZAvlJkjtCMpMxMDLLbAMl8fwaMGsNu5IZQpINLsyIcVZDbcKUzN2a+UzmbzpTPft1QElgRLWI3BXAkfh/pQsChb9fEcsfzWMQOdxEh7ZCX84Lme8uSfkX1aVlYQaO+EFGYwIsLYPwOItuQVTOrolZ324l8ngwR6gvZ5gmBHVNSrkzo+ziM3Jh//ZJA+HhfPuTsm+//TlB35z+wt+TjxNli9X9taLCDFD56ji9gHHDd0ORpKP3D50rKZB0KB/KF6DEbkPf4nrzB7Q6xJ8fhGLDgb5VQ8X3bP3sQp8o7Ta/Zy960apKnQuDLlAKHg11CEYSL565hIQWZ4YjGab2rKmQPgknR241nEhsgqwP6YvebgT0AK+tRRxHfCr5Ymx+QQdpQQXV8ZKYiKAVmCJWUc9DU4A3uodg/4uZBL3LPGY0buAsUIREAss2+0E1qiq2PNuGeJxxRHBR2VoILSwTqr7oPtwyf3yNaz1cNmSC7YO8rAcGvXDkgvLQB6Uz/heoFdaQ/etmlkAWVigltjTX6+sUkdrI9Zg3a2Ydq1U4PTJE/Um1d+UU6f+J18DDhXxRnvTYwqkSfchSfQ3dWEsyyy/P3dNsyPVOM33JVp1PdHJ0gipV1FB+ZgXqIretCXWVz4cWpCBMnF24WTISBue+9GP9inIbhS6HVJYRl7VKxxIyQWv6rGsMMpeiQ9k7Y76H7zxKdD4DMm/yrrYizg6fvEaBq3Ma3N6ktPQphBtU+azsmCn99WDulASqm0U0POs2rK0Yk2MKDdyd/Rj957z9TPPvLJ66ck1Pag0XYiLu6MJvjjkUa30k4J13Dcd4iapLYtc8KoeO9ZxbaF4XSFcxDbL0aH6DwTbyuXse6L8+zIuh1LgND25nttvofpQqtHSfgg5bnfUKYQVRkoYe02RQ9fOOl8ljVJAH4BQ1UruCEeo8wCCU/tqUTkvq0JQvMLbBKKPPSQhx2JIJg6SyQgk0wok6xaS9QlIAnnrJ4BkwmR/BJINhiXgl1J9CvwSBz/Ajbwc5Ix3a02y4INmWMoJXqqbQyg5gxSNQhV3Jpi1pxrTPAPXb8EVGqUC2cLvgfLyOwcEgt5lOvHBzQrXsOH5nmPKqUK91G2TtwGyVIGqdicPHXkrqdM9H8SSl+neIikvcLYktKqXf0FeXyUEyaeg3B46WuiTX6WBvuubXxmmNz0YpNdtsq/x+jA8zw/2ilWEPfjB6F/dZzzoXVN42hrfZrmes3gui9e7Bg0Xj4FvESO0urWBmOAQGl2lkT8FyPnTIKcOmBSACgwHgoXyMmsmhWevMdQ5AItu+njPK7m5FJYvV/UMyoQOZkLwN8AoVQbn9mF6Ts0IpF4tawp2DNIn8k/3ZdPtP00ffQxSeh5DER9krxMs9bN/UJPVymAKPI0jRPRrDUqYuAL/nz1fN+b/HxM6CTQZs3T7/yJkAYZ1UkSwrn4BiZPZ3QXSGpVsoBWNNVl7WF7xj6i5lnZq/SFkTdnXdLmd48KyjwiQk+zNAvr/5XvRpIxJuvFVd1OiJi1TgZN0ZUSLN3BavMGkFq9Ll1RMmpMuHr3qrGX/jKx2T1/L/kVfoQQeyH6ir1r6gWw5sZ+LsJ8jsFRCtwLJrNt+6O6q00u9Ko+4QNRr8QixcRH/VAClh+/gOUBuvHOz3otmUaTOyZA9D/ip+xOnV+s7zP4vGFw0QRrgax8CqZN8mfcPSmdMdzxBMfcq3A12VdVtDHBBEC9NL+Di+12DDn7/LXaz7+tm38es+JpioRNnBJBl7MV+CW4lMRQPIQvIm3RaB0Iy+8pqWRxDSiKNSNLnGbQl9AYPfCTQDBWeYITAUksfEMHxCDO4pImyAxfYKkuHbNK20XrSb+eW9jPTR25SRY6nNaEAhIA9ujdWJKKgsvML078IwsZ1sbBiTm7ilXYJwExLUQpbfjv4eStGMa0KEMUoqO4pJYPeVwn10rVw65Cf8b7gH7BNk/Mq3dDBpUlutb8bkunM4PCNTBjzJnHw5tciaATnLarj0RbhXrCLvOrFDIIcf5jD1Unz1mHeqZqa93BHJw/5mbno1AV1z9WhbKNoD8GvejRDCNVQ2hA1Yi/g8YP4Lv/1RpJO3CIPgYzaRyjgj9cvQDvwySzid+WpZujS7BFqrxdtlkJhFOWiDr/otgfOK3TXFlKzwl00xXdNkfWfgonkbhl50HD/dE0ifdmUWemC2ZR5zvJELV3kHzcFatmfywzcOi223zXk70meN+E4Q51WtJzPilfoob2b1WfzV3ZXJ6itUl8yNw4wi5nLMlWkrRq5Ct/ph+LWS5Y7t0fLmXqr97Sn3fb564/e9eqvvulrPPSl303d4SnPoYJuFZXbnbM50AYeqyRV73SJA1eq8xM4+XUjOhgAKx8sX6IjeP+SeV9319AKvdCmV+cgkXHnHTomIQcwlnV5wk8AXZr71tGYLyME6o9W8qBW2xaURRsjJKiEA8lYFZAtp3cFochjHNCO+W6twi6ggkyhEbf7gsliT0Wg4FUBEJLnuqw3udT4iTnKoTH+NwK9UhZMqeprldeQyP6GnJbJ/TFXcYEOUsjXlG3RG1p0LOxi9bipDJizoP0Fg0wkPUVwpAjXjc/EcDhcN0wjd5M8yNRr2luVPOvX2l+IzcQbeH1KNZ6TIxXJkSJYl1s6EQWVGrC2omIWmEByhhPdMSCdkMPyeZwcixUxS/XLQH//UaN/qOifCPojJM5XdRbouObJ6GwIytmQ4JWJd6fE/hrQnuLKoV/REMQT48HN42G+PY2tK+ar4HcM8xvTMB9FG8xHJRxoTMP83Yan1Muq3hoYKqz0Hl+/6SGae4VNW9DL3in05V7fCyoULXT8HPiN7HWvnMJ0qRQ2GuHpIsfTRZM8nUtHqvJ0D6cK3JPsrEn21yO74hWsI71BX4VdI9/xdhEu+b4fXzu2LtJ8QcnWQYsLWGzYukjZugj1K+sxha3zuVW/KeUG5pBCDEXxk/xRti50C8DP+yFMr+EM5lGhMbBWEBkB2R0eMfh8fFyOp+MyEAsn02C1lLqG0wm3GpyJTwp9w00Id1gS7hDoG05D33s8P3zUK50crY1DgPOrkFx7GoNln9ZT1ArCFWoP9XruWA+jaT1EkaaHKJwD0bQevsXzwgqHHyomR3ZXoYYT1DEzBGkhuu6brQrieI+ntzl9zOUYoUiIfZD9mEwFu9EpdwYBXoHOYHPl6nh1Z6BssB64uH3CPvDQx2qWie4ftfxQqBsF+LVEC7TR2WGVKhjOFrCe2DL8+Cv/HWwZPh4FbWHW3IYhcAQV5+ChVu7rOEuPcSZunDVjLvcX1gSNTUzMMeQuE9fgqd8k1TnpLEnaSXVzIGmSIEjZo+X0tx0wkQ2Rg5CXPQjyhW1EP3OvKb+GWhE05Pz+duK/y3qaDIZeTj3Vm/HbnFc2PVQUGx4zJcmPkHNGbejrZ8gphyYd5gc2UZ3BbMRZEecpkwmZj4zk0UmYqY0sjwJ1sAsPbCLgOQtutd332RGrT6AGx35aZwk+gQ8luALmMJw8elKQo1+WA5AqaQ4ZzIR+wFPbVw5aYvoC5cyhh/kcuCy3jcoCuYRNHqx0INcseTz8B2hmrR8zTDzYVdhzzRplZUcHNKd6HmP2CrIKk4nFqKrz0UaWNs0gasaobQM8gAzgohb5IME08kAX01ShWFbGTGyUjo5vlLZNiwXR0I3L7uk7JSzj2CxlN41vkm63Gids9ksB6mEmXlT1fKfJZ1WSd08mUyV552TyQiW5O5mcVJJb1eSUYyv9+7jnRdcaxZkKPw5NHF/5y6qz4uoZnYuN1WOy4H1lXFXHoVbiAthyofLxkB9y/l/ZawyHR6i+XoSDPBZ2hIKJDPIpcuUxReDOzdoZ42gzj50/5DR9l+eF16pjsgyEysmX9biq7NPe0YlrIME5zCEL6Cg/hjiL5Bf3WRGhPZUdmGTXzEPeWqhxGuwQXA5uNvcCaUI9iZt+q4lIIEr/qhfDuK3a64jAAddgFZWV6K4Y9aWIfgf8uK+2NjImUFh2r3rIDoMIkPEWScXSSrI+LOR8SxSaGnLWLPWIw+u8OWZbsk71gYhxUgrzFgO8zUW3qKXMWHvDWN2heG2DC05ICxT5Cpraojb2UW1K1YcrGLlncGyTB631dBmw/6qLZI1ABPqszWTRD512qiShaFRFsuHUJOixCY1ThX41ggCdDi0qRVl9L/1b/+SVClHHhFJhEXKsUyrk2k6gRogKfKtG6P9IRY3w6/zP48gH+Fl3aoRvfqVTI3S1PCzFwf2Pvcrg7a+cpjIIYGeDV06qDB5BXC39H1V35E4f9Glv+7n/+dBNX73na0/GvPSNst/GsODVqetkDRJS646OfPAVF5aWyZwX2IbZ30N+i+XMnWh4j61GzC3Amol+AE8tcnYFFkWwJts+5RvUJkqoWQz/bMVWWI9tyChbhRQhv/C/l/ayISL7uwwb5/UfsGuTp0yrR3oikyF0ut86319AiIWQEE5WGhbIHABEbU8D01NzdKPy8hZVDx+kcBXs+XruVHNrRwXS6XMB503s9+ikEoYqBOYYY6Fedod2GGy1wyOpxM7gwquc7ujyS9r67BcrO2wzpmrzyrMyR/6gr3TEsuZW68pXFbyxcxYfxkR8MnyHVorTI3bm6E6P3pdHibg8bLxUcRo9EHu7BxfEIEhssaLPvhwHt7CZcJEN9GUXcpO8c8yFJknE7bchmOoXd4598Rb3xZ3ui7chiB3soKkix4Ox3CdLsKmNJNgw6x2gXpXqy2ITiBF+c207RuzBuT4ah2Pzg94aSpxby96KdKCT4mbOMNrIW7pxFu2DJhA4+yUkTuN9qTUYqjG2hPNbO1YZAGwVxSgFv9rmh6cG4Gb4r8NFSwsoVU69yISJxUdaO3WMylThlRbCwVEgB8q6BBfPxTV2nwM4oAirxwe1VpDCHbmfjsd7aV9ATvXsy9r7PmyHIQoBSSuawnk3s7ei4yhHLPCV6cKHiFN1X2b2enlUbwMMOXDNQ6sP7zblacWoa6pbMqlYB2cGWQALbHRMHU3l5oGBHpIV2BWrWxRTdp5/MKMZpMwAsiVL3EFlnX5mDHQDWcra8lkcxGx4uaeDoZDnWrCOYIRQDoVr5azfa5+ak0K9avRlvRwDyVGBRuo6zGMeYMznMD9HyHqtfP9Pe3+oV8yrEpIW2QbiLnA53OnbH1oQB8u3P1R4+aJtxdGL7ZNCVF8scQNgxVd7zvOF+yybl84ULeCumD3sTLGeuwWdcNyUx4WERgen4+z3+uSjUtpCyzQDfu/A/l9nBHhoAXd0vuRxKX/r0RbO71/TM7eGwA+IrneFx/Ks2l0LwKKMi+faQpkcGdXzDoUcj/7MrNECj8Dz3/S0yz/Z/suL7ZMWudfFIi3R0qSp36mGfmFGcXnSzC+it5RGfj9on3rliJCipn3fb58uxRj2fa99akqBJgkkWpYLt09kmAC8FEZbOA0P/a807ft++8SnE1aA+dOppn43M/S7mZnfzYz8OmOvKwD0RCPHTfxONfC7mXnfzYz7bmbadzPDvhqvgF+eYta399B3TpkHW2C1dpUN0m6lLm2FQdpl6k019IsCCNkl8xKtED6D0dIl/aySvkWQTK7NHWwqsFB2sUWiDjedeWa9H3mwBeymRdIMA/lGv7+zqb2ymduYLywrMDKMeZrD36VFvVdkqnI6m3dGp++M8AIzKtjn53VrPCvFtF+ISY1D264jcrUQUPmizN6ets1E6/3zMQInR8G4wb2k5Zm5GvKkxjc5l1IWUvhS+rJ0xMclSyW4joCi36h8kpBSRxbjzij5sOKSTJtSh/13tEMpoLUwq22yb9pG7VXrxs//xFsW049G9jmlYqzYG4WHNWKv6KuzorXcnvGqbcl+vOL2edfe4cB5m2bF0xBnOE2AYEYupLHgiJoiPZpd6+/lbgU6QLkvYzpzGQaK5sTg6GaDNonNj3wQ3dg1q2NnWJctoyXc7+VboCu3ZRJYcJxn8KH7CPCh+7DwAXATyBQzRlg2DyntDIwSzHIC7jr7ymWJWtAM720n6a5pTQcLrtYrYHBgJJ7NmIHcHG59BpZDOhYyXEJ7Tzd1jInzTJAansdyH4mF9QKqSAQjfcZIw/7oBnXW8SXzFOTb+CzE6/u0jSd3T0STAr8YFYEHRhc9wR8fVrBfqPB3eAmOCW67LDCaaDnyqnBUoarcFDfaABfrPRp9jXKp1Mh9aJoQ4IxagzVtA5rfrHEvruNV+37+qDrePpxeSG68AjYGnhrV1NdlO7o+coCfMOyCooIrqFxH7+jbZ7GEvDb6Q/ZZLIL8dkFfOEDytjRaDYi2qyarVkNdodT4GoHN29fsXw3+U7FSWb2sf/gY76HUwHMJi1SMfjIBCIELtr68U/ZQoBxSPW9OW6Hy5WAv5jHuc3OvOm4io3e+vsp+JnE2qYGqyiDLtJoZ+ShfHptLOgUynQK0DIx3nFPfPquRH7JPAbUCUmeNwAhAdJa3cbEtLfVGMkyGTHdHsg96eZ5JC5ConGvaP3wP4Ah5WxubBfED4lOWd44DodBAqFnpKdqinGrX9R0DLShPuoEgnaM+5uiMSurEOdkMA2QcHI7tdivyIU+kfJhI6GZme5lnZn3Szsp6fjTKl3XyaCVmCjliiQMl55puWXNViBGqRU9GaaJvoSllA7lmZdvUKW/k+ITROc6kpw7wpaOInvt2aZ2TtFmB2SzNy3OetuEqyzZaANAWjL8yiG2zvOX2tYmS1TUl/E5yrnsKbVYsy8hu8uR+l24wghe9kNuJ5R3rJsiWbkHMSe7t1BrkreqWDlKMFkTPatTWHHp8akI7bFpsf88JtcN2Oe2wnx8/+LjQ80e1w+wBhMoJNUFTjRXyqqqYq71QbWAUCi4uOwhxAHrL0FCh2IiQJ3m4Qh4fZ6WXohKcQsNUCXdTVI8x63nkDt/PcMEQ3ozAgMXHhJvAUxNvTf8sSX1I7PkP91PtM3Cn/+4CnYpmMYja+ormTSTb4FplG4wmQVdbJfq6v2V7RHUxqeCJQmUyTfwWZoif2M02MUvg08GxxC1+baMYatvd7AzNKA3FlUWYp8dutrU+lO1s0cRetknt6l427ftyG63CjLYsb6572QZQN+2HgukNivOEUsFUc1OuxaHD9sYN3ArkTXkSpuC+cn9bu329yGA9aFDMUqBOWql1pGjhJRseGRZzcsQJR2ZeKXYByCLi77gH8GvBP0Oa1ZcmXgbDvKUHSUAxnFKMHqBw11BsqjlauPE6HNLcEf6+lc+RaK1WD73kqKNoq3RFzr8e/MUv/smzfvByPf9yY3zsYj4nqqBAVXe1NdoGv1IF1aqwLubWXUpGFUv060cYJBc4BRMcAs2tD7mBc3nLHJVpI8WEPdVQ8JU9NU+Ms52T5ejhs4FSYT1dB+r77D4ib6kfPfGznieVeJd7rvKhbtHYxQCcfdjvZAxSHEOhZYOBbBF6ed20dUZvMfBYY2SK6JZ94Xf9j7f+1XM+8cNXtXWYTDPqZQImUsu9IUvlrUWoHCabZ2SGpOJ0y2WoYISiOnnGUSXu6CdVXtyXtgveih6yryLC1nplbNzBJQXgDaq0+4EJ2j0ttr/LUM8dpY5uVtiTTNwZ8ZwUH+TWfYCDt1Ed8MoZaPYuJd16Oub1B8GBNVmeocL/a0iD5gJHi19CPPVSgFGh4Wf6gz60HtEkJX1BqV1hz5dDhOQnEVUc9biWRzYDRcb1ADSSVNnJXicVmp6eN6aXrDYg3neiVecffC9E198FzWox+aUCYOR7l5fHEmVv6k/KnOsic1brVnLqGIOA8yZGEE0kzfG4pBmHKWqLmpceU5tPuGssrTvqFaL+QjUjaK4bJzp64dW6gFGFN3+akDkphcw1MDY1q5Rc5xRULACzfhcDeegpWbdAXWrpTBVfFABapbH/kuAnLs92QxkXqo3Goq2uYqPUXhezdTJafWuR489+8h9DLPDv1iND0k/Jy34dEUXFtgUeBvuweH/d5yIEPTckpx4u8Q/e1bQMegS9iJqoCvFPmaRXdHeN5j33PP9chHgTu4d3sHs09plowzM1fMl5/iXlASH5I0eJ3um17zm/9j0SCi4/P7ica7mnhmr411X8BUTh10U9gCj8uqgbPY7Cr2sgtKK9C/iPk29GMn6z99gv7kAUfrP/fb2Jehei8OuijkrU0WrUMUTht78hEn6qiflfD7+uQWL9F79l1MQRWVFzA+o4Nh0xw7J9P8iM0hdDbezprC9opuqsgC3OsaEC9it2LoZ6kiuQd4faeLEjAMswY6Vbdyq+VuKBEYVhoOw3lCxom4VTBMn53Ruq6sLvRZ40fTrarGrXpd0WERp4CkM5BGyJJJ8f1oMoRRJX0sBv8wJHncpjSdD+e67VUyNf3UfmgY2DpkD1TFJvsP2RcuSGfP2y50NTxOlgRsZ9BcoOVe3Sx8NXj6YJVGawuCIxEafH0l6kJpT8oGpuZqqVKXqlFGYfqupihqUuZiivoiYAXUx+VHUx8VKEFI/qYj6dh6g00BL17/qyWcAiPdWOoMQnTdXWZ7+FquXEOtrs/tZv/ntQxvxoWHWgU9Vst61FGKXEqsMQG7fJrhQFXkbG6bU6SoPq5tXX4KMF3NOBFY7gQKmSGRrXL5nRm0w4RrQBVHNWcQ6H77qoN3QPaxb2RFcPfJ7rsa9mNgYnzJqRDAt/05PcVJQq7KoaiOh6ynHu9EUW9owora6wQF3Fy0BVKCsHuRIvClV6lw2A2HR9jcr1NcD6GthlLjUXtATnLf8VGVHmAnfGeP+gBnILgIKyKi0ukeIoRYbSjxN2T4kzymGhrsxmKD3FFWF4Wa46KtYUG9OnUSVIN/kcTzkltr/nJHQgoWv5u+OigD2lCmS3ooa4OqmlGBbOYNeEIOC3gwDulMu7Bvc0qnpbilRQmJe5n71aSKiMvw++5u4G7uHU12B+BaJlVB5V3zLnG9mHb+QryJ8iUguYHbiafMLzoKcBrMSow7+KfFySOKD6NPd4+rxTU4M78Kx6Rh7Y7zds4C7zyd143uc5z8hCwVrasETUoe5urAlpq2L7RqA53sVP7S3XjjjQUkaAvipp3xms7Zv9m7Ovv+VnrnmKcYIf2kwKIXd8o2DSj7I/RV5VajgaDarmRLhgtl+AtBrvGRWcxglyilWs4TDuWh/ykQnVu75eEWcFmKPcB+PYqSvjCeqw4VeULdmwgdzxtDHJXhgy8IUFfCMqVaLc/o48qKqjUZDeMHLF/uDc6FXvP9Y1BvUd881VDleovnpIzbI/RVZtGJYCa3Thr9hS4sdcKRtSCtdTtoDC9fSDnmft4ySFPzB6hjzFNwpz1QzjfaRwirbkV8xBHHE78c2ymFaWhYeThXvuS2964ZtlGaY/4AgAOX9ZEfkX1pb54UF5L6IAi4uunGoA4X24xSN+mvln2Th+ikCY/kKgGTltsrmS+aIw+xekpu/3PX9y4XMusFSfL7QW5vqhUAKGwoirVF2wsPlHrnt86wt/VR28dyFYRS/AyIk6j7TZF4rKP138LHODX4UGC9+jV7qYquMn288k5PmKtZEuh1atUrJn5WV2f0QD0bXHc+3xtD01tKd2Eo3RLT5KsrLOcBOI/tghRP2W58PPlYBLsVqJpu+kTYGly6HZDVYuAOiSpZeHxC0i+E20H4uVaKcEpTf3YdWISjp5FRPtWofG9HBd501ZiVKEnqQh6W7PGNk6fS9f0lxPv4exYoo0AYJ04xOQrwoqQTEShTwslYkFGF8Heo2JEP4q9GccnbjHue4XZnNQfzDlZ+mDsYh0Aw2E7nN2IdkhCHgRcmYUSfgKiXc39bK8I7HZJ9EAESr81CdOvS89Z/apPwRoy3BpomEhBk0ZB+zxmmALZGtdVzGAOMQLVSE34arh0BPJ4ieeEsiajMoVoRlHA21GC1nViD3paXtTVKzW8sx0MKBUumgZE+klv9yK6S13bTIKzCX5juQUASxF1vQs8mtk10Wa45l7zAGLGs83YuIZxDkcnJWutcCTQ4+cZnB15pZ8NgV/RjEaKa2niE89OA0KZfqJmF2kOQpNrcoM3oNTNso4jpM62pnsDcKXz9HcgGbXkTe1+ngRWhoxwIzOw31Va2tmUJT/qkuaFa2QxpphvFuNvTAquZXwe31c5paO3vjJn+nngeuzAj4c3p5HoKRSSJR9Qgrxn1vEmA9inwNGvU7/vh//zX/Ydf/Fw6tk0qW/4XmhW1/c4oJL1OTfylGw19XbdPHQpaOybrAIVb+LjvedwlCvFQWm8iO3wJ7hLdCKgzVDCrXw8Xj7acK2ZUPPeN8j9oTaXKtAhZDb57vZeThi4E6tEmd/BuiIfDxCB9dlvYvX1EocMEW2w/27FeXq+37hvkvO+Tps9WGAmO5E+269Bf++ejH7Y70jSfVqq7YlNJcw/NIOYlSSBNi/C9dklP+njjL2VXfI4Ryn3eGvObIgiTxzxJx0rZqgBAJSTkPftuzl0Y/R44FYnk/69byh19xtjXJE01Qb0/zgSU5BlR88KEr/Mqk2ihl3CcvU8FXcfrkfbdwtbjci/N7Py/Ef6WUptboxUiLxHK2Tt79gKkHNy3oFjiUJKpXix2FGvfUWM7fSjF4Lo3i9mMGRygylsNbRoAR/+JLwLaaih/PTTA/f8jk4vjjAN8c28nk3H1TxIsw96IjI3GhxecUiOI1Ayi6WcMwp7VeqhF4pWXJ9kzQy0To2MFGwDMzggs4ExLqWRC1j4i8j9lBEyzY2IK70AaDWkgIPFY0WazZxmYaSW9HI0SZkNi+w4OE3oToiaAoGCk0xdZBWVGnPQzUulvcXRCl0XjaKRVocHiGfFoAcCxulWUyeXEMgU19cyXsgyx4tUEfO/juIBYMHVqRZdGWZ8HSrL4s/zTIq2MIeUBUbT0ZHhktnOeqWFDRlzjUlM3vaae0xDZlDA+ZoQW3WU426XN953BaQXOuROW/YQ/w2f9LuW+OWSqo98FscAEWVpU+xgIMQIx43G+arZsP8iyxj9UdR2JRD3vBaSxvCkjYYGnDItztNfDui3+RZswB9P4+tWRef+I/NCtf1W5WZg/uyVv+gooE/1nxSfXGeYQ0Vp/RfIiRPr65SouZ4qE0xzaxR88CGqi90qHMAd7Pao+t0HomSFpSc+GMeclXPQAUxtfImZjmiUmUatXV59imleyOSF1jz7KBdfC2tvTbSlb5fPXbOoIlZWe4xvfWWbWyo2xy6QWFVfbMtnAqIRcaU2zhH66iR1GKu0p12hfNsUweH//yjKnkC7I1iXg80OZnJ0LCYpTk+O973fW/+63P3Xvq1/49ckBewmexvJO8cnMGskV+926rEz9XHX379A0/6obtezUvX/Dq35DvPfOXec97x0MXUXh8Mbt/3P/768lf90s2fuRij0B4M1f4QSnXfoXeZNq/Y/PthpRVDE7rv4sH6phdsIwyuOsYvAApdUAxCv9KPdNkLGKn13MjHUUCL12KdHpBwkzfM3aVAtdPgVuXEBRsq13IOrmFNvWk8EHBsm/dKcpPQl/PQBmduKQ5Tq+TMeAFvgFcVRNeWW/4qoeYA9nK0nTF5uA6qtp/7q2pIiSLZxf+5yIfjIRwzD9CD24dWpre6d728q3rG3vUBcwAPesZVeqhCdSV6I5aNAz3Cu6POEB7fFYWmDx6FYJYFN9CNwFIndz0DS3+GIn7lpy8/50lvmP+vzNTE5S6su1cu1HrllVWKj2hpOIvkYupqxa1OoWI/ust/sPCbjlzAlVHAPcOX6Th469qcRJvjQdMv1yOL9MP1OoRtENUAGcpbbwf9krbpuvOAN9VfSMirzX2cRAjcbQNHbeBOGxh4wsUrdcUxmbJCGhojKcc8Sy9jPfwBbzR0t1iFxmTTqGWClhIlUmVmngI0LIYppQNXStEaYsE95g0pdbGIGni8UKW4ydtPQICUz2hjbRh4CAjOwooU3pQQ6yEo7rBjZ7Mb0B0l1OMKODMqSe4oSKQaMQPt0M4VmGFZJex5QAL4oUn4vm2V1pwKCM0wwc9bVvNOt6XKHNzv6eDo2z2ejpC+HcPbwL5l/HLMvhC/3GNfdvPL/fbaCsXPcqsEmHYzwnH2v3S3re/Z/5Y3Tct0ZWhWdF3MPZ2aaGCiUwnDJ6quAy1dLUTbWIe0hWvjapZEBfMkL8mw3K9iO9Wx3FFbd6ttAz197+I9GeCLGfXxNqrP1GEN14J/dLIgR2T1GkeVfxQaCmtsvysNd8FUutgWdUguFipGw0LHFT3gJnQ5jaNnTMyEdlUG5Dpm7LHwHLWk/I89PzbaFqoI5wxv+xQIixGq2EbvHKvzp0Dlab6KsUBKxY0/J3nmjWIl58JoNFxPmjw4/IWQQLEsu0HNdZiRqlnwcgm4n12x2J0HY0bwPGPw2G6qdU9trEumv+CFdjMmndIbhaIQyb0pu2E1h6TLrrV5YhSKG+Tnatm6wa6sDD0VNlHvsKdqDS3U5ipfqWshUu1NRkwoObVzbS3qxurMP6mUF5X61sV7UgRVJ+9lmIKfBwk2FsNgqBjwv8WC5TrOi4gyv6iOVTbGwfuf9nX7r3ZDSTO/Xvv/9XSR2jxD2YoHrsNEdnX+QE8v65pWFT4FqpY3RFOhT6kvfsXqtw/ByU8GI3Z041HbWxBbZPdMM47lrMo7+1t1Z3+rPml/y6VLKqD+sKuBZkpnrfzk0/jE2Vj9S2eHS302mDPBOs7My7v2+/ErpT9zDb8X4eeStf1sqHaN/ygS1z3ogxYlbmUimOpKLkVbpF2Iq8ssxSMsau6Ye9wCaz37NTUBltcxQsie1/k5boE1dkdwv+uFqpZaVRGItaN1VB0apQDj1ABvTQogO/06q2sGMKqhnkTQ8xAkswkdAZaudqGcIAUQJRLH3n6pgbg6ph5D9a+qegNRqTcQ4VUtzUJvIEKE0xvAS8EjO6o38J04Rz/kmYP0uH+vPaWMkSGUPkvz0XjtlnQq+0xpzSnezJrTvf8eFAi+EMsxajlFB547wqlN4eRiWVcBfuA1jhfPUlWWXcBOsTGAg58uoKNGTvgLfx/VqqzbFTgWqogNWWvvZnB+fmlYZCeLpync/+tKikW7CVb1DqPdLQneLIBAEyhyRh8+jzGDwZyTyv0FNTigfYjgbqJsFKA+rJ55RVCzMud6f3pxucHCgUS3N6RwQy1E7rOXaodV2y/r2d9KVXVY5gn7PoVYbVHzuQDbcb8eFgzW5+mpltQGakF1w31doWHhdy5XxLqKu3JvTVdpDh4b6RX6cbO376NPvu6H3jz47MVD7ZeRdf4ev5dtDbmtemN+gcuyV98iLZHC7O+QSwk9QJr9Pd7NSkgJUFvXbJ1bLTz6j4NWCfAY+6HsfnwheI0BgI/w8MB5/p5K7/ZWeocxBfxUYE3hZb3z/H1StfYJJezOvmjKjCCGk6Zq676EeCVYO/XYJFKsDZ3WgSZ3K8mrk8mtSnJWTaYSuvh9XvZlc4o58Eb1KxyNckampsSCqp2cgsXnxhUscCBrXe47BYtnTipYXFRJ3juZXKskhxNWolwD3+yVNy6yr6AxzlNFAFcLMplMCscCj9R3XkhBUTOZPJfp6dbWAdVgWAdopF/AD0MeqpEbCjVzIaeBoHocQP5JHwR3REF4Lda7yq686mKkjIYnhtI3Axe64U4sYYDFzJp/ZBFNjKzWuKsqxK1nnxdizNpDeA73/f0F//y1p53zjxcPxIbsEXf+aT003Jq9HjmP4DRz0lJsoCAw/j/cDC2iiieQusK30jRh2hPxqOmN9nfTfnrVfjZovG+N4/at8Sj6FlnfHAmwISHtkPPNUUe2OrDAAxaM9RP8uuLEN3VPscmRvhZJr6gLleAA+jSJqYciz9lVrCzEYjisUP08zBNU5rubIlcW8YW1zMHAo+pmgmLRio/Alu/ih4/SKtYGOR1FE6TMfY/fQPdA5+FPoish4tACQupzTUILappHxC4PciUv5l5Au9Uurv+g8jX+UAnnwsRcE2qLc/f4QBFv5J4x59IZcSHmU4yxd3d2RhQS9LLBMOefqh4Mec+Vza+sqrqFIq9idtDThCF5R/b92geuuuuL/+1v+Rzse+Tfrzk9BJFrrvMJ5/IBWH74ITlz1NS9tx5d37cy8Pj/7+A1mq/TiADNr9p/1krIs0j0Wa7ZP4JTzgk8sQ0F8lIIPR1Pd3UYbYuT4SROhgQpVHjrBCr6gMuVvZEGTas4h8zS6OhUzSG+V1WjlOXIShWsBQf9D2ZvtG5c4dvS+T2DObwN6+hMj34pmGYO6PZhJzWFqnVZzVyE6Fdw5GFVNKyUC5+UwTQDY6hM2WG1ehYiSgwk6jUYH2bMgeDGQUaoPoO9ES1M4JIotP2jdcDYygOjRRs6G1jY+QbRpOuuScNyxkJbxJtjmJarj5iW49hITcthrKmuRt/EILFs0UTjPKmI9j2caXh6yFWfNDcXwdgcSgorxuYia2wOhQtLc7sqYuPSdQOLm9yBcbXH5Dut8c1bEFUM0IVigK5udfXrFDpdfWzBtLm6yQEBo4ZugUL7cJukgNTPTnZ/xWFtXZVdIms1TD2EOtNzd6q32ut9r1lBDXdob87sH1AT9krXDhRR9lWJwIhYhd1VOEXFqOtOPU9Ul7mhevVNtc0NsS4KeUEhysota0YgkeiUyxZYpjYeO2PJxE9EQrI3fk3GKPtGuvTXdCcciHKaeAIq1XwROR7j8PL67UnKU9vKzVrXRS+14nyvokKOHkZ47EF/ITK/Wg4rgA4HKMRuKfsnAAeDOrI9UV4+wd4Bd1z6YuYXAxWomnPe0GIhNztXTCwvaI485ZhdIzEtqLdpTJ+rxc52zSS1uULEFzPW9Ae3N1Xt8pmNvDNGP0R2HFNG0QgF6RgC4sCt+tX8AwBTyxibyOdw00+Np89h6OZ5SCrHlioKchEdbt0cXK9WLkYdwUHrIO+ktqaMOkPcfq/oh9MszVcsA2dybDeH5DmakSEXSDdh0AxNW2D0H+/pIjdmqRSNweqTjEj0giKu9l02XpaAFh1XqQte2SscHMkFefnQqjriCmwJLPCB/SDPui/Ml6XKPNJvlE0pOuYmb2Y+iq6ufNGlDloiZWrPjJfzYgvGt0sZQLUMiC0jPsvVqD2DcSGfoy35TACILwukB4D0EINdvgwEkID7nD0N1lEYuY8JvRkl/76ue1VeBGOaOR2nirs3juf2rWNoubUebZFW6WF7RxrhTqaqx+sxqo71pu1YPUJii+XxWpaP2FpqeBtUrwhPqfZ2yo4MJytEXxdoi9hUnNVZtNKP+FClpwi/qhNpngLQu63cnhVZK+piG2kF190jhHp9LhmWRznHFkmiFRiX2bY/347QNTkRrCDgdm9OPQ6FHCoYP3fw306sHVNuo5/Cd8cvp5DwxOqylXagcUWkooCQCREhnHH4Cu7HTumHxBSn0CkwX3EqSWb7ehq3bxu3z1ySnKVECxSbcFeLTEvDV3A44/QVSoCbRST5Ykm7XPJpeK/km6fIHCUAxWDOZxfHJWNxpyu1hNICBBKyQ5uj0/JTVJ4iV+pPodOrpq74fRe/U4xEGzsnlmZAVLUw9VcA0kSn5qcQMNhqG26zV00Ig1JQAWBoZ7UrXKb2V3vDr2q9R7qYVzt0Uo1HY3nYXPMfdstT2p7j1h+jzbNlv9/jvoQyRpFrvBs5xLlOKDaMdKJXGcNQxjAuy7mcyzEjWy2H14eJcr55x3hFGYAd2D3uoJ2waryTtljn1isY+AbDYOmAzL55tV1PPTXXgm5zeauqWiNarxUTA7CJqLqU/IXOQ1Hnpbhqd6QjF55gbEltS9Mc1w3YrMnCBqqjp8u2qUt4W6LSmOUC2timBfB2CyPSp1bpB7tFeiQwkpyWyelEssLO8CCUHDDMBzE/wlQW8XCvjJv4czKKwpKs4Z2XfOlwNKq5FNEchiIxtHPNMAZaTaWGVIrLuf8bYAeqdgsWwRteAfjbOMcp0FyPV3le0xadv+i8SzOoMo8rQ4KWiZWiTnUNz8z6XSXybv3GIJUkn2ZoHqfXi5XkRctb6OVvZfvm0dyrpM24ELdxe/Y6WexX7KIOxiEnRXlGsXl7NXCLpTjzgATPMU5CCAR/gf+2Qi4l6wvWC+wNtmAke9jkyM2+8UVF0XiVWAS9E4uGwnF7ADqxg1YUtbfRznym1HufxxfbygnKAMBB8DyP9oyOrqyL1HGX0sfYgTnAC6gMgM0CYNUJRz3E9WTaFTs0Thso84BW8liaMYtmzFG0Jl3Ec1a3OxHNTizExVq+QFtR4lYiOzu2lEi+ZdocACQ0OUTyVdPnwFmVOZDnUITHFwZRcwzFnMXXmQq+TkXUmamIOvcNQNQ5IOrcGKIqLakiqnYhlH6MIOqsImphMHTWYSiYyqLE0B1UGAxd6TNS8h9ZDAXPs4DCF46PoTrQW2l1Ld+uAN1iOJsttJNmLYZu/4Zh6EoFQ2cNhu4Ahu5E3E6N0waqdvxsPifN2KHnGOgf1Ax3WPRckZpQxkhNq4hZJUKpREVJw0ssXZiGpXmZnE8kT99j1voXyR5TryDrTtOcFenI7ORi8UkB2iAH7AxfFKW+Tnh+9us8tMBo2ikqHvNuRm5jsjEjbknm+x0sZWtC2y1YKALQRzeDMPMVVSGRUA/b8XksvPOVJU4BslPFGzvR2Z3VKYmC7Ba83cDZu/5FolXoTXNQhhPV5+g2TeF0LgSlde0tT9tGddcNz/p5E4/n5akaVm8c51Cyyf4cKjaFzHcuRrbXVXGtHLDlM6Vb5pkNYX6KrCKQzGelRTOjQlz4axkV4lZ1nwD2OXjv5J9K+9rUESHunFaXt9GlCkWhjhXido4vxMXmj51vOiFum9qbCnE7LMRtp5S53VopvB3SrH6o5weDAWXjbquPYOtW2STu3gsp7mSvayC7WRnPF7y8k4BHNgKPOcCj6ksns/DIjg+PjLKTh0fG8JiryJA7ZNma5OgQjWpPiJQBv5QCKDGDRdwcBfUUbgTFYhwEMYpnlbMABEaQidm4KkgfLuDa/2qAa1cA52kllFVPA9pHpkLQNlSN5w4KxhXgEfGT5uxpgDd5GuBRhnOI8dMABgfgcmVvpEFTh67FUwxak0Me9eOQAnem1qaocqSWkV85JMX8rWJORh3b+PZk4zNqc+Pbmx2vbYpqNfRtwHRSCF6pJm30uhtVe2TinBcJ0YDqNj7j+KbrA0VD2HDjAq8Gt1Tqcl20X8XwMIVQA92v9FtuYqkoHjealE6/oGAC2S71WYbcPU6bofjAfhd/jsa3nWW2KuqWd2e4PQN9wz+tYs+lPZwHzlPotC+UDRhtMwKtF8i2sOqt8Z7QiyoH4r5+occw1aG2HvqLyB6nVcl9rAcZE2d23iM4swsnz+zCyiwN7SwNjz9LubEnf2YXypkdRVPJfUz+CLmPJsl9qD43NyH3fuVYWjM5cn9ieERVeOi5U1SBR2ThER0fHhFFJw+PCJcARnzYBlVyP/UE0U/1ZK2ipvCei4fPHVEL+efN1EKQcmK1EGQ6abWQfz5JtZCbfK8xqVij8yAprNU5ng7q3Ukk9PYgzZieipEjIVwIx7karCjyX3muFlTP1eruXC2hEN2Ly0vUrrKIK9tvys0bei9GLS6Fyp/7cLInymy+HEgWeuxonbg2xAQrRcggjxAPSTPHZWi5VSSdckD2A2KQY3Obf87wFg6pzXlgqOeBkaBy5M5K3VlgxebfYU/99/rGl0sgfjb1JRdVBzSwVnXBqHpIFVG3Z7ygSl7FHPKcH0FV3Hb5K5bnQjxG7tsE6bdJ14zNI9XtlPNAKzqCmpVU6CJWxyLS3wwCMPPBFJpaBNM0jdD0ED31DhQes/cPn5JirxiDcsRTKUfsKOm/EuWYpv0QPQLtB1hytGgfH1f7IZqm/RBjOpyc9kOVdj03/VwzbqiF3mvHbPRGVS9O9435ZPqU88mkSTJ57kXQ7HHjvuSx/rdY8qy+luyxqdqlaJcZ8rrW9MBYTV9wNT3gavqK1IRJwv3GrThsendps/SsNZGLFCHsTIXYI7eojkdlOzJDAXQKjPAmOT2g8wNCyGhiZhrWezXgyHf5h/0iUxFCRumaSUvg8UAU8PtoLLagDwo9nqUZiNN4UGZKE+Aktswb1MaxdgczsjN+FDaDbnmm2e2+nuIGebMKNe1sBb6UqdilmSotb2EMOhRN0WeeE6vaEeFJ5pmZpwwPbk49G3VU98azuACT5AmAhgtleQoGUEHHlja4Z5Coo9MNPOYhgbpKtLASkOxEvSU7W++pxFIH16Qg/OEaUlRNKcfgsR+ObSlVK7mo0RbLf1f18tlSRQBAbHApImcUyRFcrbu2AdyzVJfPryzq8LA+jwgto9o2tDxfAADhYArgo0cJrOa/IrCa/wbAWqSYYNpAgLZAGYEZz34TVnSyh3QSOB5+kWaPFAu0UMbwUfvsermxotl9/+nLD/zm9hf8nMdNngdwMefu80uxoTNkBGmmQNlty7iv7gxfxJ00PyhjaP7IOoAmUjGaHd1wBLXa1U9lXk+8fd3lP1cJcaLqSE2DD2j/As32vexr6BjXjTz8KuZzZPeP5V99GFif8RD9lduPM+OeGESvX1tn33mW1IbuhlA4bRuj3v09+IhmhuqKa3gEiMeQucY1pajUAKFoii5OkU4rQtCiZWSI0jmmRmiZuSOf5h1DZmaMVPEA5IlzKmlkoV+OjvuXqpYF/y2LLZ0uynGudOZoCX5r5ERkUeC/ZY2FzH4eIi//9biCbr5KIX/p06q0aiutUK+fQGAspeXbuTaCZFpW+m20Cv8kRaj3K8PDIUfihfjloL7oofj9gbzoafk9AW3VCuD4Ic+NJv92MKGrtCpHkznXd0/gnN+MO05QNO97KgC+RnpB1M65EJE4g6nuURduDkKalduegltdDmrft+Jtf76NP9zOHSfpEbxJbV97hJ3yiSY6Bag9/H4Rof1E24Gu283hOXVoWUZlewVgrgIpfhV4g5AeFo8Xu4Ril2hBIZaI17kFhViH8UT98vBjhjJ8l+m2XipvwYxKYfXwt1W3leBtqdhBO4brcii21ZHaU/RCdJePKvK2yI2BqKQd4MLabZxC4+rhkeJUOnWYn+a+3UFdwbOWrLXF9jXaSafRDuTOjhS7aBfThNNHtVi4RBL1As58KmcoSRadTqeXL1f21vG5+ZKODp0I0JpWki3EDhfNjVkFcV4VWJxSSTjFHJM5DYcm1aW94pc3lEMaLXGVu7IdBbdAnHfIHmFHRU9Ra8C+UAtqQL9RPi/0uwQROQoqTqIEPXLqWobuLOh3A/sbzL8obSDMEcFHBH2NhBcUjURQnBZp+gKl/eetFWdQF93jM8Mzsd16Bvi4y16Yn6UW5s/m1O6BfAvNwsh+CFc754ixgfxxWGQ59eV8OAEkyGRoE5S1W2dblj9ep1P+BIqpIBNdK3LMPN/OvOKJmHvchSmKOudiJnISIXAMAXx7FAF8daf7yv3T8gc282EPJJRhdhZo8ePp8VDXeRI9gZ6AwHl0Ni+rZ/JEOYcp8OPyeaW3AjBnISDFaaOyfHwYLcRp1RKDVcxodXmTy8zfjlgNMqnSYSQM4z06aTtMquaYAM+I2DODkAHzh7ZpmUpOUOh5JTEgQ1xoVeuh7Yhwrn1QJ754EhEHbObJbKtoD+4cEcZS2yN1b3X90aq1Hd/oumkrEIrnGh7bqA1kavch/pAJ0zbuSmjx3ww027TWnKRC6BcYYr21JNJ5zh8TXrVMqZTy6ipAprOEzhIeRNtAZlhxTX2RqY8lmZsMhgj+n3KyPcZX2l9AaYXaioy6Mj1RFs0n2BUKLTH+o3La5tYleqI0ebzXWDm2A53p8XkOGRltR1PVNJ42DlxI2bYlzAAO+qZ5nvF/BnLIz4GnPMVWgI4/UgA9kVaNb1Q7LfhjeT+XzkVT0Dy0SkG33aysK6rNN7awbkWT21zX/Z624Zhpw53aBtzKlC5xRuCUrJMY1SWLdItgFxapg0eH5vCYUx5injysyWwES0Rycq2WqWGpFLvMYBFfG7Scr4InnSAnANR0iqSMh5A+E1CGI1dmo0Ji2hhRxbeQg9tlWWjTqkln4ltSmwywVLABLMT836owQLC0QKKSw4FuvmIpDa3kS1xWWKygKOWWtKpVxTapkqTK82jVIg/rFyC/1kvhGBaF9CTJmiGrJmdlcqYMHTCC4LGPm8Y94Vq3CqLR0nhDQtOQ1eM0pP+8x6ItqwCTa8sKyE/oyA8koycJn7ZpVvLYg0hrJ63dTiw316tEaOtJEKFtyitiavj5Vq6JpJ/qenKsLp3zOX+Sr4hhmHBTqrOtQnXoBFQHZGaM8ijVWUEc8HeFFirt6yL7/1WESNl3ITV5yA+fRxEO8ciz2pWr5DEabkpLHOVAIC1pQ0E0O0IgyOTLLKk6F6RKadZMvl3JAjEPKBs4xl942IHGKFeRnycBynM8uar8fAlkDMcZIUsMNcpFudVi/h46Twe6OE/iJfICyjWSS3oS//dEJO2h803O8/F6AcfKKxcONhMrEebjduV+Kebs2l3h/DJ+2v6dJwAB1LarLOFJ2kwUS9yApLAd0BpsOedq93RGapdtBg6ObvjcLNPJceKZlkrd+GSUqin+6s4bmz4ej9CxJatjdEMJAxDbV2Qini5PoCaXU89DJRBaIJnZsPU4s8HNhMe7mTCG7DS+keW4rZLziQx5nSOPt3Nkm84BbR6ZubD1OHNB50FKkewG1Muy7mz15TBeMmhmQwTXuNT4CGuo8bbgxf3ghXmPUuqalTD3UahuQ0RosmJZKYKlIkwJu6M/6lf2+sfsCwEb7MtujLz/CFfwiKERQ8jifEgKngh0EFBwUz5dROBPkzNQPiXnrCxaBOVVWdJTCovt45IKh6aKcbYBtuTpKDdZWUrkFtyJ9k0WjkpPvvTtOek0t8en9kAyxbx9jPvyKGa0FsDQqAJBJ5wb4c0aZYs/LiS2qpdxXwxR6MsAL2ReDuMlMy8H8aJW2Xj2baPeM/IQcxHbg9AcYxsLQcUqHpcUsNUzidZ5zlwsSAGEG7ocT8H9J+Y59zbXzTwv6SmeBYgAU4J/AkVQ2q6mBu3py6osa7RdlrSKGEi9iOqOzkB5B+ZfVfN/R4U/KHclALMxG8mfpBd53rWl9aWQgtvFC99gSBFESlfcPhTHCl7Bie6gdpgdhPn69J24fuy9DLD5gq/HzI01qkP2wlFMA/gtNm/34a1oVM4t1/UkoU51JyTvFfha8Vc+u9fH74BLPyDWHH2YGV6Tu5u1b8MnVFezce+GcWKJ+f7eHr882sYRcV5z9u3T9F8CP3DOLO50thGtluanrC8LwCW7Hj1te2LwEY52rb8LuXNcOz045OMIjoM8nA8o3dWX+4QiI7scwkV6UTxSC9DuHA5N7LKmwG0YAkjvYXzoZvNSQ/4DelX2Jo5DEwh9u8lfg4MLNFqNBd3hZ69AS50R+hvwynS/bC7agWeYfRUyeG2PSPBxgkA+zJtwsf+MxELL+DCqwIcf89Q/Xk1NcImxM375MaS7Km9ElUhzPkFcfdqCkCdrUvoHMYoonyv1DWkvzpVjHWod+QMbwyFu2NzaOrAh+q06Qtc4byOTY6Wvr8QrQ5gH2SA8LD9dS4Fo0RYxHlcMizojO4LPGQ7wGYJXczCU5hqDkBRXVNbqpQuTYUU9rQwPLmJLpKu2Ta9CI0z41Qj3PXakFlw34UzFeS45pJ+I4wbVYFE/CHmg99jDin8UzFn4tcWHB+Ck+FnpsUYoPnecceP7vcodatiJ+YKnJ9f3DMuT66O3I2i86fTFZtThgURtYil0oKlqGrQSPoqwHoTfVAaDuzU44kvnWOWr+yrhBzQMg2i32SC35kgZvMfFHpLYmzVNHO/oybt2LdVu3u+6Ke26V96RTZO0qC9Uvji8PvJFcGh9E1Cgua40+czN6fs8O6cZ5veaFx7Lck7fo3Egjt7EgWHBFrr+wlOLrTDfCXj8EZ4bnhKBezwlAhVKdKdXJUUDr0qLDnvHJ0Y3w+agdHZz87AvMSZgn2eezzG2tn7r4txZrVUbt1zDaM/yemmYK48BpLrY1KdYffcUdVYAuhzR+97wt782+KffGTz1hy6sPZOCzZcB9ueIZFgSg0n3P/I45iIJ/gWCeyR4DMFzEcQxEKyIIfgFxO6S4AaCOyV4D4KEoJolW5Xg3fisq2Qyj7XGzH264GpsuRoT9yn43IARQuwXZK/B7M4TtVeL4pjc5HU8XpI3qkspk/rELaX8BusDjSO4KkQxfKgqgJFU+G5dra+Tb1ytVtfVWNfV4GzGKaXLVRprMIJ5HHgzVM2cM/zae4fvxlrqYxH1Kx7NFJEe8FW2gy+EwCnYlJRo59GtDQ8Ff8HLXoueG6PF+r3ZqCP9+wpdSIyNR1jDLy9ifDwxFC04IUU7/AvlxL1/fYKiHX3L8SjaMU0lhO+phO9HWCnHhzUos+TnJinaQYnTr26uhO/QMGbwR1ACgtwajRXi5oIbErxLI6oUDV2z9GnguqmUVt6RTZO0qNsqXxwd/SLYkPfpFO0OVxo++/dF0YQNBGZXVPgclYPxznG6Fju6VgeoYqVrdaVroGonIGKYQwqNZ/6fR89eJ/QsJmNI8znQ81IEgg9mBITEFXWleEVCSuyOgPOnhO3zx4Y+vB4lVUjLKFnBfJ5KVt5wfLKi7n4fJVk59NZy9tz3CxNkZeOO45GVuzRVrapXwvchrNP3fWUwOPiLk2TlgcpXhzVdwgMNA3E+fIcjIBor3JEL3inBoxpRJSvomiUSNyNcISuvl3dk0yQt6qbKFxujXwR3yvt0sjJwpeGzb5GVb5GVzcnKj00hK4JACLwNgZMlKz9+XLKC+TyVrBx+pGTl5pgFDFHpr3KcpFxrptrt5cQ5eCsHs59AfSs6PSTRTY+XVGbHiyYnx9Ujc6Pwx2ZHeGHtvzvEf04V7y+pov2e42P9Xm4PLNaKV8jDrxCY7eF5hWbrdNityPY4FAqI1NbUO6cVHFWv//SGBo2L2LnhhCliFGo+d5M2NoKCP0MeUh9Ne9wtliK25osuIheEdmpX0XCvYNnjGFbfLaG/B75dbvxAwegqQg8i8hIJZhzahxBaoZMFfcdkGcXvpMzecgWHZcE1irVDQfaTgs/1Pn9+GOOdxwgelGCC4CEJNtC13XnTbAT8qjgNb00xgIktQOPKnu4FmpvvBeLN9wLA4qsK3xjyCjGqN6MFeHsefq4SZcxYhWybkhkUc212k5liAX87wce7C9U/F42asb7HOV2qzE9QIM859g1EFOFvSmkHvvVPYgNHOSBMsaF+t8mTCwn0eY+mB3fjOSKQsCXcZwMPmE8P4dObA+fcV2Lf52lF78JTvQXjM6wQbsIdHllpDo6sNFcff8q9xJIAyAR3WyIQK3EWIhArEVAirdYk+LnLzZwINNsJFmlSrriqbc8UVi3tWTLuGAqFkhkanRZit85UCii9SxJuxm/2U2MkV82uqe3l8mstaZdQ3SvIV4JrbKxNENyzFEKRopWJvNkr4cabHa9qtUAzvKuaYWMkgzbA+jtGP0pnSnf5Pu77jxuE1JtwH1d7ktnPvJqfEAej+eK0tltEQwrXi7i8Z8hvb8JyNCjqV1rL+uvZG3Gn5bbsp/AYFglHxkNK1qlesfY6gISkxrP27G9b/fxfnrfCLm7KGYxo58HRffNgwArW5/mAe6TeU9CakEzd4WTdsVzDpHi87hB1h7bui7n5ru765nX3fSV+7vrqH/ixmi9U2wn+XucJIrsZACwC4ltWHuhNVoQgVRFuq+otO1bp38Xw4Qfte/AXv/gnz/rBy5nWN5AoWZtI6sIVEGgg5P8gikhuYWkp14fSKjOSEr6M0htyMVcZoywgpxg0m5tc8MrepksLaCgOw6Cjjmbs5uptkSEmWx2tWc9+EpB+04NMltlbP/HfJb2ihfnVovp34CJ3TBHGp4WjtSx7A8xAAsvUeTX52Y8hRlyEfj7wIyfTPcb3nRJnBfIrnBf0uDTcGMKxC95SSgwbsdPcD0ADSMNcsSME4ucTDnuqUz+jBIac+JOWhoQ6gDAlmLshJSADDeLPIL+Os7tuNHbpq/I/Na35bV//+nVfV9cZD9rVpEn+AVzBGFlVsluAHCto0D3w9jJiJ6CtTtvkFoDDS7iywE+Ge2mwT9sZ4pndXmQ8v5DSvb2IYWFwIAYxiKMHlPLIlWdcMcdU7OgcofY6VxcT/zEmZLfKjJeziYOBsukUS73uQoYUiJ89fBncrNrS9XVzrAW8rimaqLOQCkVKeFBPZub8w8OaOd+aOf9nnlPeFEWRXnN82b/6pE/KSR+Wk742OeHtbM9bOqXzUPuezygw8g4lylskUwUCNVJK0kKb6tk/Aq8tQeCeJOhJYG5fJuLPR9GkQ80DNKMQ9ie2zRSIXoGv1AYzVMCeUSYxALu7YKyS7TrAXherfYAGbmmZEPyx4MX4f3Gz9QS0aY5gI7YFotSqEKV5S5QWQJRahijNgyjh7hctGKL0vE2I0tw4UfqnEaLUNESpNUGUrpZSHVEScDm61Cr9SLSMH4lHQJfecOhh0aVv0aUf8+DJ6LGmSuRDYQyQuVH2I1Q/0R4u0Q1c+skwVJLzTU9wQkNwWo+M4IRKcD6FXlMq4EoFXCA5QmqqvEvgeBdcHO2UPIt/QOFXV/gpyciUWNUKT2z4Ge9QJ004ZrmB2SQ3M2cJx3yVm5kD4RAH+PMnIByz44Tjf7+qSjh8x82cgHAEj4Sb+TIj+ks5dZfb1oskmaZ6r1ItmhrhiYweJGD6esgzgZtNAHtuEVVfSyIHv9HTkh8wz7s0GY4yR2XqGybD/bagYyaAwYHPVGmqJ0192vX8VcbyAazTdwdIeb2maKMiE3ggNIH7OJB+0ffCSa8CRhXkZ181zc1dKLAc8aYXOm964aQ3PZcuqWAcHkYF4D7gRy97MzKrYznuS3a7voobJRhHt4e8vhJCTA1I1lkMKr/3evh9ztp+4zQxrHjM8+ExryteYazHPEWbGI/SY1484TGPO5T9iXrMU5+GyI6dKbdoxGNedb/5NV/MezSuHVmXfvpVo+tSq7IulUK4ol4K4bBCqQy5skjVZQXDd41ShmcXqKKBa4n8TGU92nypCs1SVTfrSr1i8QPb8Trmpi5EOvtbeRuBpGiIMYWEzJdYbLDIJW6Rc0EuIkGD03J1G0pL0cI2ZKwwgMU5kjKdkspCCJuDiV3G0EE82tTix+SCFlJYWdC+6vngVw3Sk1s7Eozwqkq+77h99JDpNryr3FuTZF6+BcG0j0TU9jbUASGlROQN6ymvofZVgC7kW/46ouZ/6aniQqJXOMM18IXg8gJjHLIhZxXAKV9VreT2vO5yseDgwAKhrmAjlyHiUA9gZ0s42c8owXf+Gj4ZxXqYqPZlKutn8ziO+lImFvDJh2eXmozJEDKJw8bsj4yTtOYuH7aXNcQoIVNF19BmZQ3F99SSNXRBQzh/kcvyNczcPgYRNYg1huxPZJvegXGyunzWJ3s5/8SlcjlHOB3gAl6hdU2OC9V9H/laT8yPhP1ASE0ZEA9MUkB1kVya1TcxsIdiG38HSIR7zXO3eZJ5ZmPG7vriijPOeQ8lRivqMN+KkNZfBzUL+IFZq07zi1kGwqzaraiLH02rOqyumwOakVjyxW5FU8Ccoi6a4Rg89ovd1RksmFqpLZb/2AhEG+VySkVbhlsv0w6NyiNpq2thII7+AynkyiKAjdlZRGhJ1RbWpAc40wCpbAm3AWt92f8CIKuupgnOkmHK73bhLAay07iaWrKQXyAI54FHQCpir3BECOkM9srafTD0wevjlMrZbsEzVDYPqIji7va0UMS2rAGK7DfQNmfxwndENnCkVzSPrxRTYNYDVUlj1Y1WQCHSK5Y3gqrljUDXty6TV9FtAnUYtazBRThuiMtcV6NC/lSrGp1UT4ymJsKglpjcMH5m1CSQV0Kklb1XWCvtDGzDaj7Qt+mQCB0kIoqkpwwPB4HwiELoBBCowgDLbKA2pR4NIPIAVP2FnldxxhM6yx/qepFZI/JegIv05MGhM2xzddFeUAduuBJThJSYAvvWeHLwR6BLoKZ3CykIHTV9i+/509wpUs36C/XwnXrNQeyNU2MfqE2L/cLU2Humxn5sauxdU2Mvmha520Xe4liynbLZVqebu6qbbTOIleTVarIzBsep6YUMJGu9bMQTZHYbqtIETVXDMN5+4wwyPdvzRj+t6aeGH/OQu/YIcz9Hm2Wd8SobCFFNIDoQpVdzCF/UxF1VruKT9+15YL4gXa7ViW96g4eSS1fIgXKs4Cml5ADN8LOB1YNXPhSYmB1ReJjvSmfGgbyiE9ygAHOj6swYL1xJOOrM+CKGBW8PjFNfPt78iroE1aNAPf7gVqwLEfBRyWaui4eveviui/8f1O6M1qFDWB3kY7ygserMzeOfH9SXDC+ZeenipSsvZ9cImwh6htCA//PcIn8lCWAJbooyPWCn1tEQKq2jaVgkAX2h0BAweNkvylhh+3qHmI/EBMf2zseGVqe6jy4m2P7BsRo/P8LPOtL5ifh38bOhCI5zkGAN8Gnq3GuiI01BU4wtFrjULrnG0RD52e1CM3wqky4eSwK2ozTFR2jJMPoleCPo3AkGvc2T+rO/dFcKRtKyX1IiJENVmGgMMZCNg4YA7S1aeOwr2tJqLaOYgfdH/aSIaAafwWqL60qeEsfLNSh+5p4464/gakgkk2guw1tPTFPhdjww6/D/Qk0KesovAUZaCkDe0A69VWZwCyBoUdt2el/elubmLTS8RQ+nuRd/Q5qbbNbc1AhMFLJnfRNAtn48yJ6Vt6W53zyQjTeFLNWgUtAXupq9GXMFbbtKb888j1vgQwSU4IITvJ+ShyKZ2dAC1WmBr+o8pXredZr4NqMFlo26h3ZU37mHnhKLdUIXxZmauoH+BdHySn9vKn+jML3Xq6z+93mjy79QIMdSvEclNaBHU2OPTo1919TYO6awUADstNh7p8beXZvasqmxR6eWcO60rLsmclaHA5BycB5GccDb8FhOKLxrpy4MWDexOmZvlwUYOoeIDBGZaWQeqh7M5VPVjiJxeh4QnrspwFJTU806LC+JOHzXcBdKPqIMpka4xVObkZuKKaw6YszymkhMA7c8LmUpDMwtq4uIpnGF1FQziUJC8Gj/QJ5iav5g27OGc43RxGY+Q035RN126d2RA9kvK/V3lcpGQWylc0uYg1Uj6ZT2vR/OUytDM+0ujOiuqetFE83Fjtt605QOgllLnv1CEX3PiPUFigHwGaqZwwb8Zr9irgqqIWEp/6KpE90XdkXa6tx5tag1lLZQ02zu27wx69zOm1e7YNjlFPBxJs+wLa6aPENJm5g8A310BWEQEoBTvXq6cZQxm1FzcGrY3QEXaZpSISBB+kEvtH5FjIdZXxguVOAF5t0Tq8wQ74rNZl38YyGTkF7+oF7lvZq/UM+qvl5Z9R2zKbtYT+5HawVSUl14lDqpCPQHEE0ReqvVUwRl41D4amMR0pWKLFzwY+65V497wNFUPfe++1XH99z7kcDPWE1LieYxT6UHH/GEY0VwA2tTTZTA4v1i+LvvUR071JzHlrEwb6ANSBIMlrM/NXygy5yWR23OWsyAnzPoJ16fPVGzilU4Hjh7lO5TaAWOf6WScgZty7CIxhVLWz3jZtTGYxZn3GsyOwEM4bRl3Z0jfrKgpdqafJ4k+uhodfkCoidaUSxq9EdGCymWsjuF7i3TAtkwh2jRhJdovgwvUihC/1l8zHn4myMDWjwiYmsdROpQA3ahEmNcVBGphcgWpchizWMZdjZ9TRDBonOMSTHl1KRq6RxvLfDt71BSDTSvmF6U2ZLHSqHJP3KL2hoPdCJX/QOMOvhycq3AsM+Bi5OTEss8K7mOFd3rgm7qHTnmyeN8J9dKol51O5y6drbEBlEs8zERJgrNNZ6OGmodQUznF2qEA7JJyB6BTdGVxUwv52RqC9fUphkWG6mRF60zTiE2BbXV45WW6zgGAdBPyTObieqK+nHPCye3VM4ZdqI9CzBzIBT11Jc83AD4VhAmibIoZb+q21zEVh1N8/d5ZHd2EbZ7ajpfKYds4PzkfM0vezVjIB8bsZbuKxN5uF2ml71T2Svyqzbz34XIfy2q9WsnoFo3MXCr1uexNR4WgTixH9yehyjZDRQEgoge9cFzpYIsWAc01o9QbV1o/aix4VpF2x75BsN1FxPgc445MtSt/7Mgl9jUm8CvS5/0sATxIIiS6EOOAQ9rBDiafXktfS5Km3oHyDdopCYJAbRyMm8ImkCQgMhQahHGDy8+XiBYTEqpSPpkqcUIoRXvmJhfe81+zmWFVWilJrWc8Iu/7bBs8Hrm1bOv6dnVL/pe/eS8TIhndudlIqx4mfAqfia8cT8TcsNA/UygP25iRKghoFjRCeNizlEi1OqqjmXGhHbGhBSbGYNkEAwfX7TU54QUWhfU09njU6ilxwBppLNHHiEekmZmjxK9ukyoyWl08qD6Fqj6KjY19JE5QZOgWJ84rK9wbXhY3E/Sojb6/cFX6PfIoPKzhymb/Ze5lmf2RhFEZ/wXSthZRJmvHNuqXnvjguDwPAEI7rgaB0WH5uG+aahH0xDMg5vP/lSMqKdIcq6RyIOwwFjTKFrZJ5CJYmFCr+L2InuUfQyxeSuFzskdTXHnGho3lqfvHVJznev09EZEmzxcNpnB46qis7/IwIjPulNMwbXXR3ztg4uRm5WenD821qExw61/CSQO3Px1ddrXhf12qPc8o1gAAMHi5DM0n3doFq42qQORhvFdAhP6ahg6EV+t4CIW3c34VZqnbA2tmlFbxez8Ht9wQKhlosJOnC8fAtXMJHgQwRaCenARcrCmq9wcJdn7Ro758iVzdyQqZrSnXF2/9XyafbYBpwVyRHMVBcKq0/i5Ur+BXPCq3jo2mYe80pXVU/ggaEnryk1dcG5eM0IVWlJtoI4KghJq4PuDHnZjAvMmxjlzHuY5/mrt+zz38oAEDyP4PAeGqyR4vwVDohKHWp9fdDZk7xfmb0ZVCxJXSOiKrmb/gGTv4PAmAOMDsQLQVduKFibU4RcgdT37IHIr2mCq3heyNVMe7DpbS7um6BKLDq4fyfAVzrCFXEJX9MdC0ZkLSwc5XXETu8tHs5fVXUPXoFaHEcst+6M+cWYE7UbjFPEsGjr8I082Cn4+A8IhArqO7P60n/g9PL++7+ZZrWmYR8Tpwi/yU3xPo1RmOReF5YR/TY6JDcsZwzEI6gPLuUhxr+igVgVExo/bPn/90bte/dU3vRyoUYLnYAS76TNaUeETBj07KjBW1F00qLyipw1dnuEbzpyO2KQa5j1KRFKxSgkEKltFO0PM8XmyK1pkUgfWJJaNVR2x75LYELHziFWn/RwQwoE9k0QX27lJbKIbciBsjWKJnOeYgtYK4IY9dv0ab7xVKMK13zy/RhbiM7TdbvSYaJiggpuWaUv2IeltDKctd8wDVrF4arl5XpTcMkGKFMh8epAhmUPG5F5NyZJt4ck3qPMYNGibbRBC2qBAG1S3Deo8PDDVXas6j7RVW22rEBpp1XwFTDMn06DYwSbevEEzrkEzlQalcM2uLUGocrbUqfoQTapem1suGLlgA4bfS7P9FbeorCjVK0QtRffpQ2zeGvye4X2QNyiipVuwlZ2jQNenAXwUY2rITOZlqB9aqX6XFs2mn+ZkOa2V4+LmEH+gOr4KDfRAZ4tOpiIeSw4oVYAVIXmAYvabANrtw+y3jOwgJbkTOySsvIPbeb9jkuYgyLw7yNUIWZDnVFNaT93sw8hRdflIPcqhy3ILLdFchUYiaY6WjrgYVOecNQ75vyICgwFlvcGAOw7JkKjVIRb3ZxOmaS2moeoh2CxuUOUFL9AG2rkh1LuMAusChUqxRQQVH0OWZ0GPZ5UyMkNl936/EEWG+XqpV2qIRZX7hWWbJwK17P2q+KyG0/JIb14Wsbsni93bc6bKq+vmqjeee/RC7Z2eeT9qA8ds4B53q1WuhL5PnvyJr8+D5vrsA97Y9dn7TcY7fFPSIRu4GZ9uVFRqA6tSeyjENfzQqdSaVkUmcKcNDBAIK95AI75bad8P7iUXvLLnFtIHsa3XHiemoAyvF9Z2qQ88EuF89U57Yu+068Vt9qZMnh6iA1URBKj8vqe6TTDKF63lRip0rtlxlrefzwwuUVtPe/IIj7253g7/cAT+Xqu7VcsBiCqxbypj3+Zi5QAEsbXxmP7BcC27WXclsbnWqm26XHYE+s13j6hoB4x9ayWrH5LRPjqSHguDWSDqpCCulLaGRtoaOWlrbKStddn5JX2PEpG2NkTmnzdRA5KcpBXaiWPS1hms1Z1p0taY6iptDaklrvCjMWlrOF3aCuW8NU3M59TxNcH/Fdh5POZolrKqtDWBUBYByaLEzF5RMTpUkeLTnGo/zADJZvuvj4ztit/WL8Qtke5I54TIzhM/j442FN6lhoQUkN/OeMqAf2fxsghfTqBUemoi/IkUypLZid6PSoqQA6DtbJpjFivDHJKKOZSdAYJz/GNdv4Q4icjg7SajhrmjrYSyjcg2tZClZd2sp+NSxfQPrZtREagqbceLuPSbdDmKXMFErs3dj0794KRckeLDcOzDk3BL+tdTlfu1MikUOra/g1KhbG51s79YGrpM9tra1vWC2gDvUOmsQCNE5zgEOWmAosMiHC0cWs0nKj4eK94jGJSMAMSIQlOL30L/wjwUNQUALLYACyhWkBXxWOURxNMnbkA02oAign4j2C0OoKJx6I4Ko5fSyJwLePIM8HSkaff+omEzE7fZigwdM/CmBwMAs6n6O12xoXGgSPvEcVZW0N+5Ru7lIqgWxNmXzbYtxhTBQUGuCtCw1b2RhyW3lr0R1YOSQQpPzQ2nB4Er+NmtuDF2gTM13AR3wD86SUT00LHys0zqgne0Wa1rro8Tnk6+EOy1TZnHXXvvhdwEWuAmzaE9OEuAnjEmbohZa84rbZ0t1NmSCpmgwG/RPIAyTziacWKLjjrkK+Rst2ir8IIf0myV3uSh1BRW60DhbTuMjar6+C5qUIpLYQ3q4L4PVk4Q0AbULyLVQs8X+XWo+uQLEBvJMSMIjUo/NHPCj8xok6+IYqX4csLPbgg+Ch5W4Xa5cZ3LetldTttyN6e0DrDPAEgIl1RjTkqjGKiQqX/Y3FP/fUIxM0UG0FoZjQVB/byFkZ/BkDhucDmYYNfgvK9HM5AsLRv5VWMvfEe34Duq6tFTgam8TQVrZgzWDCtQDivnN6GBOdj6Fi2A9C5Xkpft6MYYXdcdbvhsX/GrmNufzwswKBbklvt52k89yMy4zgWLW6DzPPjVQaf5EcSC13ssDwtIZhxDA2a1AakUWjRVMNmU6wKODWGQFpH1n61DMOZfN6R4zL+ug4URWYTDfKYKoSI0/nVnTMnhuH/d4CQ964bOs25I4XE964bOkW3pTtdob2/mTTeU7gZMaauyVeNMd0ad6RbLtDyoONSdEYe6M+MOdbn/NAP+LQ+NQ9umHmi1qSG7GVWTBpU4INivsirN03R5DiOPmvMYyabCnHLi1M3y1hW0yFQr2lJN1ZxGz9bKCGxXtkjDNEqCtuJE9bKLFVwkQfMS1Dst1wOcq0fNSpYStjQF0Oq2DIUUq4x/ZgasspWd/fmc+OsoWCzNyi7UA+Kzc0c8Er3xBiy+hivfygGdHQn54uLjmgLYL5kLRnyeC5iDGaUSmlffk5nqxBj/IIL+8wwt8dSfz7S8qgddh9AhZWBEZ0Sl7ggGs63UdoGXFh7lmQFFA2cvm8JbhrSgvBpodaazMkN75vGYpyaMyDfV4yMlJBqrc3jMkQ9FH59SvKV20q5W1oREGN59N9z1e8/f/V/vNeu7UpltVKflYb69xNw7LxpqWFtW8KQkJTaii5RT6GR6eUFNyCh2cIaXPUPc0Lz80oqXRLhhhDaMkiiozEO2oP5ZMjI2wi/Jfk8ZNzAzCa+Jhc8QqjQxQK4bPR1/7qQSuVW8X5HP4vHd+ZyUlDd1qNQhBP/uQMd59aUdIrKPxQ7AHPrRFtYYDuyUMvYTkNpQCCTNDMtxKBYwLtPMn7V6knnIIDL371FZW5fvZvUblOaUj+ZBjqmFUWqpwwPRFllGjcvuBlAejeCWqmj5uuUalWLMUhP+lsqW2VTuVQ8SIu4Y2imIBGyk1sa6tBk7xVspNEocEFJBBDUjiM0N9IF9ptEd1dJEO5niytegVMivZD2lTHNmAlbKRQWHXw1Mi5kri1Yvz1A8cSB0fMdLdA1M5VM9nDgAL4vw5qO4gR20EyINiR2HYoyGeWjJQquUyjeVBqD20I3FLbCItDk7VatiNRhbcy2fwtIu22GvaJor1sSVcwuwm5u5XQjBYGjQgHucKPMFAlsAWoOhiM2cMOvoAARgOCLqGkorB5yzC6NPA9Uaz5fJw9ioxoZqoTX6u0vbpz4rQ0wqdHSff1l5WZjkHTsO8anUgykt3Q/4KvJEyIo8KcBkDkZsRONDJjlGvwJv+yEqjqDldsJinqfFmOP+DgJ64QHSXROT/b7yeBz51o//0sdrcsDsOiTND3Sf4xH/8fnyL3E+1MKPMy7tZX+AAsoGPvLWZR/Rg93PRg1R6zO7lLi6Uzno7y/qCn57duaTP8wTIToR2tDAo1ZAJcrN06rCkFyEdoOPpd3qYZKnly828o5ec8nYJUw+i/CNXj4np+bimXOhUh7Us56RL7oY+Aarw7dibAQsdZzHUYSzsnl+CDWA6KOpLwMY6xjyr1OxdEG+S5yKjBlWB1IW+8JdL/9d2XvQLxo4AeXLjVo6I+evH0FZgxHftfbqbiRX050Lmsj4GY/RQnw/R5m0m8PcTyHzWgPMJWZ41d2LlplomSHKJCVOoou0CATH3NEqULxWRBEXB4sbrsmAhABVHBDjddMG0zKPC/YCmBdjcJXLILSEE9YWpWVtKsdvjZUDrlnWAXnOg9fGKiPqp3oQm/BhQJ7ipaVqb6lM36R6mVHUZ/kHpKVYIq6YpeK3c4wK5anlROeiEj0cwDInWlz60fiK5+OWs4rfrOYl+aMHA6qBYYRz3mhaEY1KoMKRV/3q7okSYTXgVni80kuSmu3oZOEM/1uLiPgBwTyF8oStO6YaruJKkDEV3H6lGRrURP12kP4nY67lsFJNkLoaeVUreDAVSz7TyhrMOBY+EIZ/EpdHFL2otlHwc1Dg5QiXfEfk1Ue1wlTQYm+2huiVaxHunnobciwKkOheYui2CHld1azG9lE+eWP7KHftU33wCz0iv4IrvtlHJVpJ7o/voyJNOMndlO92Uz75x91N+SnFjhiUG6ohTh7dij4YUOyaq205kkfSf2eJEUg10WuAJJFMGv9DzOKdBDziEXgkIiKowCO28IiPD4+Y4pOHR8zwSNzukiKyKJUcHaJR/uS+xxdLN0PuguHez90rjPJGYfvzFW6u7yY7ihmiTYLdwDjuOsxgDGWCMWHbWE9/7DHXokzMdcHTfdHtDThbRZ/yoyfQp/ynIIivq1+7mcJhUCoyev3gALgB8U5K/McnE5HuHES2V4dgZH+eVM5kHTI0XTCFFHpEh5dcKqXrw6Lp4J1WIJ06SOPCAiDdJp/478oeIgZDWDWw4FF1fsuuL+wdcpbGAKpYYoxjILyAOrtUuVUoUgTXkpCXf94MrXNN7jSaW8Tso8TN4HtUW8yINg82nLw0YAmpUcfWhRqeZWpIKFwTQ6IxX/LOxqrLpleXbdj62mV9bakPEkFTR4tj8xbiUD0WQYwHpWXpep9MdAntbdz0FLnFKAavjQ0+3SRiDQDTJgp/6Y8Hm+kyuxvKgVVJhhQxYo7V8cUaF15m4iJ+PdCHJiquI13NbxyU9aqiCBuoImzLh5reJ5jh9Fi8Tr4eW3AiBcKJfhwpFCpHypqOkWpL/4meGYi7p5OtM9Q60d5RLWvWr/T6L3o+hJ95ZCdChNwVXWs56ajqWntG19rd4cfxqT7cRd3sT+WwUW+fRMJ6Iw116fXzMS3sjymHfKsXBMIhl5d6MYQRQjBREqFDGFiblMdq0sNm90oFEpyrQrEe6nu4GoUVRnQ3dG+t2yCwepHdvDWwYjfMri3Gdak6UKpuLrqk51VVKQWptMvV2/MTlxFSUfN0mxCoaX5kXM3zk9PVPHUvk0yoI7/v5HVsgZ6qY6uoNqljizy6DXJqtop8gSKfU7P9w1E1W0uaY0OaIxDnaQq3IU5xDJ4F9pgiAKWoqN2Gx1O7jTkqKK+Xt1T7NtFHiIekZX90XLXbY0h9hOrnfzyufo7OlOrneBlTP987Tf28wBRlRFl7BDroquurw1jV9UVLVNf3kfXs4w+3Z7vLnoXZJ/DxN6AnP1AVPzwaGxFFaKxEiCURMD38kVOddnPSNaJrG/F8L5T5rnLhwF53LG9cyX1Hefr6hD2hA5gGmHExsxOC2SaBIkwkfc/+TPXYhLjGSl1uqwcpU76F68RymiodP0evherd2dJPImSNFEFnoq7HcjgjlF1+guBOtb1ovAS0VJ1C4JZSy+yECmxDhIIFIAmgr5AvmUuYkBvA2mw+Q1HekQMUj9oyyEg2D3YABiNaxjTtDB4z1AENVaXPkOo4RldxJHqpboZ9rRLOFWF09WevKmLKeGvUhjRC+jxHobpgRPSMKGcKTIo6yQc0s1ak+wujTrCAEy7eUi0iY2f/Wr4kJmBTvC6zsL0rwCi2cMWSlVrMnqygn9Th5AY2rl/jWwXX5D3u5+J+LhP+0amOAqL9EPkD1NvQH2qLo7W1wsBpu43c3//RNY1qSlStH5t34oK+XrtMvLuGkrUoaBaOGBK8PbtX7KC6Zo0JjVzRl53CvnBVqcKrp1hYo4Qjae7ZK0S4xCvDk1L7shWa4RmgQ4BnRy6UF9wPFe55tBMaubSMw5n5tezPdeYCHii+SxHtOICBbEBhXYrFZJ457mDrgWrLGOIHdFHW0khZq5uXde1UxMF9R8XOhPspj0K5rpxf6px3e85PngRSblxtWilgmUFxMwbllH2gxAAaG39deLZThEFs0DYgAuGNiM9zMIzGtUugs/NSz3uZ4TsCp8VhelNEaEBI8vDQAM9edAzRyZB8NMdHSdMZ09o4Y3oEbmj9a50WQ1S9oH6nX7jbJ2cBCO5ig1VNVG2aTLUyFoo690M/RdWe0X6qWWZPtu39DOaGIhB6okgNONVh2u5Y7fl8v7EfvhjSTYrkyv1OCZ3Foa4an0QFMIesBzOGVoLH6mKZuUeWmURU5SArw8ZRHLoYObQlD5GeI6LsFuARZT+PVQO8AGJRmrEpw0mfNkhclwUBD2ORJlBbKBoWZlAuTgeUqH2VhuiqB2gGcYBjzQe6fdCP0LyItGLVo+PmORn58X0jP2+6b2S1rFr1NHt1EQu1c55mr3CeZl/yqD3NfnHUlERcNTNqoPiXU22B1uWW6oix0bozNlqfNDbq0iUVgHzY1QCTO2vlJ3/lDI8yFLJ7neHRuoytGhbAuCfZbWoNVHQt0UDNp/qHsDJ6D5Z58LdqZnQEZyJ3eWvUzGjITTsiBUfqhAvZ8zo/KRw1Mxo7ZbZfaUaQ7q9eF1T0eD23u1TPaGNmLt/mzFxuODOX70LQSfh1z8eyQyAVyLthkLhPC+hYJlMVU55iXhLl0rgPY33KGYSlYeYaQs1KuXzV2LRAyqGQv2LOL2UbOpSeXWMj1jVKQUdaJZ3B7kvdbeHDwoN4QvIWcp2pgfznyoFqG8sP1iQ9ypQqVpG8W63gUyuPqWOMGwjXgsKtPF4JuzVA4G5klweyaCRKbfXrL4LmJ3SjcL4+R2090YC2Cs0eQMa90qBFtGBXvtT3RJbf5b8tctl6RTalDPuDom28SN1+zPl7XMucrGw9MAd+XkNe/tvKRa9wq/BlR2k4cwqrtLWfCHuA0vKYq5kxx9U+bSeP27lWwMvPbr6/cRQzBC/EL3fal4xfBvqi1zxYqLxNKxD3+KSoj3Nu2fqLV3wiX9QzatYxvnWDr6yAPR/xuMEzjHrSixm5TV6T02ImxMrugG9oPatc1Vc4qH3fhrf94jM+5o7PSI+20QrFa4+sU7gWNtEpQO3h9wt9AicRC/dN23V+ztMWGZW4AjBXgRQP69taMooNxovtotguLSvEknwLl7SsEJtnPFF1Dn7M0oKe6gMfC1CbVKZDO8AWwgPKPTP3BOTtPJ6ih5/nxA0kNUJGOcV4FsVDX/SoeOifPO13TtjU6kzIlNPxoVOL+lpBylBo++lk4TlVqMgOwKLvGYQkAeUODoEeMbBeKDdHdpDHrwI3DoCzQociaqMj59rJzUq2eN/L0ETUHmpwKPtpcdWwA0dItIM1joLUSOeoLqMCouQ5iyf/wYdth8pWC5vU6nYrpFAZiDzCqzIua1DQdx4yqvK/9B2eF1VMAca6htTVSFV0tkj2A6GGEEeAhDYxlFXzgE1RHW98O4Jn194GbfWve9fgVZcWfsTZZ6qGA+PScGCMVzX5AMOBMSKc4UC8wJrzqOHAy2D17i5rODDu32aNRcXIEMpwqzkctbMj3cj+2hoTJVTHj2DCjuBnH4Edwf/jbP29O41Zysa+45rXeo5vPupVGOc+dtGg6sIhs8n4qiLq1aOvz9NMVzjj7s9Rm4F6UVhsN+WxPJO8DuS7ECgisoU78Kxba/SxsUYvXgTUliAkVHpjBqDgKS3PL3iMkxG4Cb55LL5JRQ4mLtMiqLVlf4tvTVb7acPm4Bsqwtk2KxbDU0RvSHQLx8d6kEDqjqwkB2LjsVfqRe3kdVAPbvf/ujodKNLs71C1OEYqsgHN7Pvok6/7oTcPPst1zFJa2jAfyv59Q0+4pumE7fvOyz74u/dui/fy4cZc9rdynTvR3hFMRaMw1/x5zQGuY2GjaJuUy5nxbehV0Q3uYRsnHyIdwL3RjX0vXfjlb//0j95YrbVYHA5cb9u2BlaWaU9G4zzXsdUU9qCxBMUD6RuzXtySofsshdXrI8USZetvqtTIV8gytvdc+D0SRzULG0MGfEb8vji0HQGrbvXKZBCwhxobHLbdxZW7rkOBHH9X9p6rfhT/3ljKQuRzeQV6Zf3Sa3Lfuh7yhft9wBuzfgfHreJDz1MO8kHZpajhu+x9N5oScfKy5MaDOmj+rGh6zHEwux9VS+/0uk+GkM/l4OzMV8GVJPYhMwKB3ofnAQ5cjQCO2hi/jtYuQ0vRcu5sP8l+8qDFi3PXFBpWR3o9ew/SKEIa+vTgayFXfJdgaU3I7yXYQ0EgHexV0mrl8fgIC33/916Hb95R+eY55TeXj34jfdCW1XRD6mcb2gJ57X/steNlUVlWd7z+flctaLGebV2EsFpkOFrkGx9RkQpIUe11BYLaZ69+pStpd1nSromS4Kgxwl5B9vfZl2+UIqB1q4n999yAhr1Jb7ZrSvZFs/7VrJX/6cSFOhRkX0LeFIPgjVlLvG2atcSJWCyOKlOGBHqK9WfsHMWK4ud1n+h2ZL/ljXzhTqU9zA0x4OrMByL2C1Nj73Gxan9QYj82NfauqSW8b2reOyfyetlN6uLOd53AVHYw+BffT3ihc6s31sxRa3FFJGElL2rzV2+olcaS8ljnue5/saDlkRqRLuq2nK7dPJqdI1z6wPYfeeoKqVDWylqYa2hrmig/gTpsorWLiX1XfyIW6OBtBnFtH1HCHenmXfLrZzPyRZ2QOUVmKHtiAx4RByKc5yEAqqhleYRlUfsmt/lSrda0p4lO8l/qamdCh27GlOQNXMnN0GULBXBpo/1K07sDv+IFiUZcOBuhljoXrjj/5Rr0ipEnLKuxO/FlIMF5/vedTN6v2JOa50A8lZX+v2GlITzOqps7mREOUNw+wAN1q2oNOQ0SX4srNWSGpYLNYN/Ble3x19/61KOin7TJzQUtm3x1Duq0bMi9wuGoXmRI9CJDRUOJElfzEUrG7zLUySP+452Fl7o2T2tNLjgQQ6kqgm8U7u/3/fhv/sOu7/t7BhuUlXCfjCw98tMfnE5ayCya2T9gDEpu7h/xhnrHzJLW9LK13k4Ao1clRq9uB1D8TLUeFOXEcnH/Ld6asnbC6OmK/E+gCXmdU3VDAI6PUSPO/km4/0Tbhr2MykJD/MgtpqQ0K4eJjvFwN2thhgApejQEbceUEQ0ncrrxQhrOjjIwExDoiJ1OvT17hFrrDwZ5lkpNuECbyYQHmZg1tdrmJlAjlzu/s8bcH3Hgsh63/4HSx0fRlJLANdnzJc4+iyATR1QBKVAbN+jdyYP2NUPZesgR8y3xNWmF1iiQ06YctAmoTdIehFwP1z3yOW3qtbrVepF66AqLTFvWVhEirkqYC8lNjrY3kakGmTpaOCux2BMvrInYc2YDbLdzpwA7Ay1V6G/rbVtGSIH9ffVx4GtpC4C2jBg6J4szbACSz8WKbFxZaG0odRgkoqCux2g47cmsbXMNq56y7kdfgp8XAb/AF8S2H+dy0NWNG/AxaNouEluCtAjh48KzXlgsXli7BIq7OBe4+pqiDd/nUnsHsbRAiz04SUe4sx8+0mNch94LT2TZV3WSaJU84HYrtGAYxRg2m9oHRF7YZhip1U10gdrZ36HLqkr7FblRpHYb9aaBfKq40MF9sznFxbZiZpaaG8goqII1pIW52b26lv2zBo01sVWETvfD8wPCjFB8SRRfBJ6wBYwBchTgXL5QqD20AlNwn8VyNQ6kaWK2v8Oq+IRqT7fzDIUAEHWzuYqcOp3Rc8xH4KidnMWinVILKHAG2LogoOBQRVdtZDkAtdQ5L3c7FCkWnWiWsXAdWlm4ZaloP8PYqVcasOyaDYZ+jWi5xZHZiTyHgZgj6WanHAvdMmTFjO4c5rnr1hTSEh4KgBm2Blxkevt0Dm978HNuka6BGMgERA2UIrwoc8g3pAfkDseLlfu2KSTKqVxPBezwLT/MZxO5M+TONDfQiYecWzuvshxdF0JdF6ZsvBpm09U2m64MiOg2XZhj44gUK2oK3VfmEBN09LWprw+Y12T0tT7yihaahWhVzTd+HC/Mxb3r49ez/D+Rqrz0cByG14Ww/lZ1VhXqp2oeS4YoMnM2spu7yGzuDNaHyOnJDj374is15mAGZY3bVdAlXmJAoDPxY7+zb1Y6joCwJiSOpIpGbsnAHL3Y3iu7mOpiRsLdpZU1L3JfpeoFbA33IaoeFIZlEUN3o3Zcs1B17A+KLVRdScAqVvIkRlGsn0kWnMwICQb5P2BuD7ft2UeLkRIiYDVC1drIG6P2gLKp94U7PWqs4w6U6yOqzSOcnYz2M4LIYaST/Gmld6r0NtpJd6xCdZqBdmVWSc7Kk/7yTnqmCioLYmIWy3zpyieREE6I+Um8LrQAeTmYgnQw+5dXOTeHD+qRoABDlfzauhcZcdUPIrGqyYoNk8n7KsmXTCbvqSRfNJl8ViV5dzWZwoqnqzd7peOa7CE0fNIuBQWachxbFC7TSdmfoFAzn4TNiTuiILwWgvSx40KG7cT1AOdoigvdcOryuA1hhHv/CJeD1T0BhpFiy7MHkzx7RMHwiLtOd3Q4xrUHFEzy54GCwFiDcKLEIqpYuqgrfCtNk0O1RJy6eaP93bSfXrWfDRrvW+O4fWs8ir6hJ+SJ6g7uoZLtkG4/PDUKXQcW4P7FeD+x01ac+KbuqezI0Nci4YNnmd8cQJ8mMfVO34unW0dxSqNu41Ooap06BDUW1esU6Q0MXd1AfjkuAWOUGIU6FGZURUUvNfuaEp6xKtRIeGy9r9S1mkhPimLLRBUwUWTdQJhP9TjFLz0PZF+XCupoRL30QjpaXVGXnaLeRfNUrUM9jOjJSUubqmt1xT7OlUp6RJPNF5arCEr9B5W0sm1cveEoYGbUKndxqhGJdvpOgw+th/akU3H6r55/HCPPB19dvQqJvQ9Xox0Dl6TQNuaukeHatcJTyUlozD4fDrxo2qhXde2NYnok28V4RNc+4qMcjoWsWOzI7Tdt0BNBmSeh6gGrPaKRNkSqce9skfvAVdgWNvdXS9vCkbUtDM5cXCXdUCo9j9RbP3G9UB5Cy0e17mOm3vtzz4joUSSFFX37GM2t6turcK9qcjiUUgWw+qhBV+YGp28fq759JAOlR2RBVRP6XuStpa96jC/r8GKJjlDAgeolnR979XEv6TxSxfrHe950/VyYkMl+UhFWlXENin++FYZyuyC5dioi6uYjNJytTrAKd1Xn18RY3V/AJAJxpQafdiCmu2Z81FMd5zOgRxTC6oW4XPzhF+Z4xXbBuCiu3BnC7pKFBZuL8OCY93ngKSCbMFpDOTD65E/cRATkTjlfwoeclRaMdjK0KV+vWATQKzgpW+d1UU3Mz+oypMrLMXnaJIrVJEXRqV4/zKaacWlOmHFpugbOqjWCYc4/1XM2mpHrdrNaXd6Uk7DKdbsZe91u5vjX7WZwD6louut2TWpuet1uhq/bNVPqTL1+mMmH7vphZ/L64Yz0vzP9+mFVLWtWM7nrhyeGR2cEHrOAR6cCj46FR+f48OhQ5+Th0WF4zFYEsTM0W71+iE8nOIamIBOmymAIl9JX4LjR6Taa0L69A4j9h3zOzBa59SJb28pX0Tf1l7JR1DefAlXk7rjgzKMUfgOvNxN+z1jhtz8q/Hav5FsWLJtkwbKq8DsbF377DF/+YwozU4H5tNZwBrnQJ+3xpnOLHao7dIUNlAr7741AxSNOta3uTLaaEQ24sCnjyCg10UK96oezm85goEgwS23XIKoPHSzg1XxQvo5ovDJy6Gpa6UzeVO9iUGFSZnGjsMk7pWimdb5s0wIC2Q5hHqFikz7cEGsZCcVqSvPvVXyhd0TnQMKtSydg4aXjNg3vCb2oemnbrHBYJILxq9qw9IFLIpNXteOHf1U7UHYMBsVGryaHQhuCylXtqlmx8qI4hcenDdzYk7+aHOpV7WgqrYzHrmpHk7QyVPMXJ76qHVA0nVZuDo9oBB7Bv9rV9aAyb0MKTuaqtm+v+Zdu/IfPTU+XDTJZB53qXges83+Dfa6n/nDfy14BLih9zJ3bqEgX06LK511/fD5v0uGFMqLVm5CfQcTmDi9u8r3Gyd18LELebjnvIn7l5qPzLeKP+xbBeesDyv9Ddlx3ckrcbsatR9tzcpVFwtBruXnD8vUxRZav97FPRfvJ15sJChjdNXjU0D1hhAzyCPGQtOz+G9yNxmDiRuOdCr67s6B+XTDi6DbSPMFeHCGjcR6uz9XVa1wiexQ0VTeP+p9FnqI5E8dxzfODMLXaloXd0iGcWiO65mZ007zz1IywqGuvmvxoRdNLMF/okUOgSBibuKKtMa6eYkaO6KltKmgqhAA9+7E31qR0okmyi9ImcZ1aWE0LQ2tTTXJ5TekjzSXoIoSuBfJRmCo0Kz1VbKx20nXTm+hmXO2maRuUTnNP+Hu9XW3qbEkTPKfuieaLnoPrlCYmLlEjnI6IlFKtwWXnzsQ5fxFQWu04AOEgGmjeBPxAOQaJ61nL9jUd/SatXCNtTRmpYGykQENE+1+JA+6rCqjJz24ApWn5GMpmf/k7BG6hXkkxouUbkQNF6Osr3QexqNkp3fTxkAyvEn0bgYeaN7z2mtExbeDRqY4p6r4eZ3AIW5BlE+PbnILGHrglwK5BGR6T8K5Vq5MvdDzx4dQxN7EcyiSb5h5rN81UKk9xGiLPgJJK2x3GppixTSTNjnUrRJFTutWkzJz5a+3Nau3206zSLW15iA+ndQuxoXZrVrOh5eMNphlXObgy072A6tO7hUaM9yjZpEepNIHq2iP9eKxHyZQeJebDqT1KbI+QTfuPtk72SMvANkl7pNWP9Uj7NDFKCvrpxGU272BupAJUrQU9rmKHHRG/Si/T6mChFE52+WfHSnFl86+w+qoYUtMPUke9AMeJ2ZNuPntq1dkzPtHw6cTs0cqoNm32uDllQVEbmT3p6KBw/ursMaSnSNUwFU8Zd0iOCPeGHjD10R1JaCjTq0F4clSuR40m+hCi1eZMQJHYYPXl6kLLkq8m53qNfBwLKQphg8yzkU9XAi8XEHiQ8MR9XIynfgsoKXso3+YiUdJWuD3Mn4exmtPWPzREBbTkV5cuY1Aq0uUy0Vj1fjFKAlPFwjo1BBZ5guboUg4uCY9odM21RcRTSKH9UEyyyphq2W4VNBQxcSwJSdNdIymVEj3kAaummZp5kkqHgrG22M90O2+xJJlWsOuI+0KrMR86eLmuTnwx0nhtUzj2UTDxkWlRaKsJRr/QhoajXUm0K2GlK8FYV5LRrgSTo+aPdSWofqEMvfkwTe/ygkjwqrKJARIHGtaVV+2oRmQOGfSgBmlhUbdIlSBmorYo98HfotY1ayUCYhlUk/vAO/kOK5yPu2CNkRLamN/8me696oIbEd4jxlqfYtNQFSsPvSA4iZ5oD0I0QtfByBmk86fAK5QLa4bvr4FxV/JS1HEbCzN4osl1itBUfErhSBs/7XuRa5/h9osQ/H7U9y+RqIj4/cVMy9ZEG0AVbGK23NT3n5+H2haCQbnXCtkIkSssDdWTJyppr0MajjXDijYyvlZ3IzqZzWGbc61Um8CvkMxlqro+AlyOyV4vpaNvzgM1Wi5dUEY8RkOFJKiYWb/N3oAv9Rp8XYqW67ylt8hYq7Pnd1iPdTtkOxRL2ajpO3D8qCYb62rpQr2kfsAPfDldQL2juwE32yDlkXZWlgXFF215XPikFqEkhpAdRTnQ6D15RSdJRYNHsyhQpKCa5nKbL1dpJRMhRbewYk7JbU4B/fGKinq1qvEKirhSBcovNbt0tllxhQIe5F+vjKW/5weeOJykwO0Zq7DLGQP0QBzmmeo6C3FiFsiojaBUhNpBb41rfRwO66FugGZoR1xmA1YMgKppTM+lPfE1V9Hgd8UL33hdsedDSuUt8AJtaTzZwNHmFMloVagFwDN1pOWEwsOAD1DVykLF38aFtTD90yQIRSLQ9/LAn7LJn4mjaGyL7+sQ6mm7bYg/sfqGzvwXUKTvdaYXUeUNyB/b/CaIcRWJRQadmKaG2F0EtB+HY22KJtqER2japF6zHSeg6j2a5nKb8kcaLPxDYNvgvlLqErnOKus/ygONN9b11Kv2VFunPJAe4+mhrqlUeRjPXe6IHdPquoXExCWa3FqU47JcDS57KPQZkzOq9hyQcED1NW9ij5i1v65ndbeMjXwTaTWhdmRysPzJwTruPn8UxUJthT8K9bAqQ1KWYHP88pzIw69A2zXLV4BWYK29ckmIcCODEiayhan0pIgtQwBRqZhaT4zOfUhCEVoOoOZyrV9dB1NMYF17hY/xdXAD4WOEtZfvMO8C8DHRSAlty7cE2Dy2hLeFVJRbgZUQdInb10mt1/04N8TKF5trnhoMkK/TH/f9UO9p+7rc+mAN2BcoV49XzwyRh7aqE5pCRNLjdnpJcuCln1TXQW68yVjEo1k11rF8mDoKFU0sZ3jBDfPIzwOt17QikrdoSiv8k2tFoqTfdkUZwvRNFb4vUJBU0JQCAx5pYeGP0NVwynpZ1FGLdMvPjShYTepQknukRV63aZF1WdLV4S0H3uP70fFGSy2fM3Ty2I4cJhOgxO0i/zuNbkodSD4GOcR5o3F8HBmnLvNoy6pj6HaH42NoV5XCwxh6aF8g7VPwAr+lVcFxWhVMaxXj7yYta9hx1e7oJjD9WY/108hXxheoZPYhaqGkAjfMWfmQexUayzMKwIgAcwhTmVrgYdYYQsZKmxGR8Oej7BuPNzYwwqBiYMy26ZmizJT+2smbfzxWK+0/vuuzH9kyxfwj8kzYf3wn52VQ3vLOz7ac9ccff3XV+qPV9YlU22cTN+v9O697vliS+ca6Wz/86uPZffwJpNbS//ZIrCO+Ed9WrSOiN848It7G7SP2p1p+xIeP0vQjRrBqqhBFWluFf7+StPk6qG6ow2tb10UvtX4FPHc9ETXluoLmkcUEHFlre1gCmdk+4Vo38c8+o8BeNFR2h6g8pQB3s5FHU3MoLu4aiWlzzKrG9OMDstStaZKoIyC+6Kjf8+vEBhDK96mzkWfjrtNmZUMyS7UR12mZc50mCAqbCGJzXXek1C79o8F5rnJs8+Z2yGJFk0aVKF1EJreUali0F4UpwmUXXNUY5FmqNaEx2RDqOaqfrIZi5mjBuUqhWbg2sI62Osig7BvEhDNo2hIj2lhP1RqRVWTTbQsMKtVU5lffhQhjVYm6lgXKgLHL/B6+eARAdaiGGSCh6ZlrXFb18+7gTS54VU+b5PyyAzBG3Q5FnzulJbO2JZ1rNja/ZMH5xCPwrnwLHpSvUGYSeiesYvUkq1hNudDD2nUDb18VeoutKL5HKzRLW4YDDGPGL1toFS9bkCfLa3jAduhSPk9bxYThPM0KLgyAC0POXytfBjLUwAxGHDxKjHRmDdFVcR2qg5rJkFaufXD0bOXylUvjeJodrmMEueUebZVWqWgok0YMR51i2Bagal/3tWP1kJhv3zJey5YjtpYa3pwPZcBostrbafbIcLJC9HWJtqq7UJ3n2/oRzGHplCSd6guA8Gqec3u2ydl7XU7vtuGCoSDAdtghMfaet0oSbQP/UuzPdyB0Tb6TFqhAPfkptJ1DIYdO5Rl0Gv/twtZaiT3Q3D6L09na0eUUEJ7YfOd0GhpXWJNUV1NQ2qq6gvuxS/ohMcXpdDosMJ1Bktm+nsntK1QHFc7652hRC+Tqa+HVcuFSw1dwOOP0beogv6hJPl/SLpd8Gt4r+RbIcgRCex5ayM/CrcqxuLMp6N9fA/RV6ZY5XsbBM/PTZZxqYt/qdDqbbUjBfFTKbz6/n8Xv5CPRxs4Dnh31Gi2FHUVhIJ50Rn46AYO5bg8usAsrdNuJQTmVTgUwtLPaFS5T+6u9UbtV1rbWKdUOnVTj0VgeNtf8h93ylHbki9xgRhsViG3HPVYZo5prvBs5xLlOyNiPdmK7G0Mpx1cnQNp9LseMbLUcXsEmyvnmHeNtKtM9jd/y02gXNoS7aKsV5G1Tc8HbqGu8QuIGm4C1A3Cg21weUcfdv5ytUCBYE1MHemYe1kj8KFWtj2VUQ2vnjaUyXrm5bsBmTZZeUB29k2ab2sVbl1KLnEto4wwtgSdbql74EiKkFKZNNSTXRpJbZXJrIlmoWb5glmU1ZBjipybmiG7PXier+DZZevOdOm4MpwV7C3CrnTYLuAU4x4/6i4RkLfEfTAQLl0WgeCh5K9qyfT/Wf9Q2ThZ1IIiW1vJdaIVadjstAKafRtt0cAralXeUNsHcL74oShTLMzGmuyA+ZH3FJ46GpaLSSP7ogjYPIj/vblh3RlCGtiNuuyBOcZrGSQN1JGmbseA9h2bwWrkmXcRzzlyBoLmJpeRU2HTOUWJOO+34bi2Haev0YSoEttsU0qeZoVggvVc9NmLFnA6QjgPx3047Flif1DHs8cdCu5QTwWdhKL4idRXi9u2iOTsWO75hY7GtMhZzZixOw1jsQtwujZMG6uyjuXxemnGaSq7QP1i3Ps0OxDapCWWM1ESIIdqJUnfqjVcFkRmOpc1mTaoANTzsvmJbOQ+26zwoMG12IVGtdGIZ7zD2LvJzzkHsNCpAZ158gOaYCURONHQx9wE6gA3wGt0V4MpurdqJRdoOK6BzoG9zI5QEndml9kt3oR+7RhziHywvT/+15/mbbcKfWfjleefl5LsSNHlvJXnfZPK5leQ9k8m7KslnVZOxk9QbuLD+Y++PIzJbK+2T/NSrKwb7XUHhaEFVD9tnVy/n2FFGsUaCLu707OY1/dpc3Lwufilbsn8pewCze9BBUJo4KdUj+0f5XJb0GOceT4IJbldrsCE61TjVfgbUEy57YY5m3ccLFjqC1bBtjHH4anygY5i0PCM8cXcC50Immme48HYxKSc3L9xdPIU/XBD+MCY8cZKD73bzE18QTTPbucgpGefAs9bXfUaKLmaUgT+cB/+OwAISqZUvUzvvkgeTs6bv8H6Ly+4eLcGMar7CFvHynsJIWW7s0bdQD3ZStS8YOPMEvGrUA+iKXv+BQGS2M/kqLedbqZtvC/Ya2tuzFUJOzJNOK8ALGT6BeloBbZeILxpLq6B0GT6ZJ+KAzTyRTRuR96RNBXolbUHtW7V2rVBrR1O+8bXzTuRqmLXdxg/Y5mWpXrGqrVpFi/ANx0YwZZqTbRS+MI3FVyuco26s1PJKxHXMimgBY0M4u8DXwtrXyvbltFXfRpoIrmZ7H6ObcQlezp1DI1dBglb7gYFXUbasYGzg4P3aOOH/MHl2o58wCcqFeVhqMMzUQ215Tj3lCh2iEMn7DtqBhqBxaJOAVqCILCuy9xo3sbsVDV4FWEwLjpoWkLRA+sJ5AFn0owDoCwv65f7BYC3Hbh3PLm2R5xZqMp4HbB8Fq2lg1CUusxISToOL6UuxluQ9bPcnJhKgM2UmoruHfTNpD9rA/Z4J3OOVE2y1X5lf3Prtsm6s8gTjmecmWVZOsu0AA/GI5D3+dDtBBYMwVhlP1hnBg5W84BJqxYpagZZsWkNPsUpqIqlpgXoWTbbRdlMh1caQBSwS8mXIp8lZmZwRoU1b0SYMAonQuM6VbRWEomKiHTXTjt5m7eg/7zFrSg8g0qasYMrVLCHQppBpylZBczTTy1eCvQDg9Fm2rTLL6PizDGAen2k6y1YQByqhBrypwWibcBvqOVHv/46Zp0arMb+QeQlnEb18CRpzdvfWo+az3eqU20mFrQPYqHliOizGvLeXc2EB/BfllNMCurAdRLsHyEgqOxZR2BeLQsSxTEvCKbSgCfkCMQBoDsk7ad7knsfrKRyrebBtvhp0+/B1yr4qHlRmaU9wdlbLyWl+gq6W80xHfVa6s2BH32EexnTrpmPqxjMbG083ZDQ2WIjbKjnnad6MdGZHels5kp7BfNQ/fUR1NFOKhHWhWCYaZAUarnE4E58pcOhvrZ4NAsuWfsjz4V2438mZiRu5FOaCoQtGorwjpqAPbJDNcwXb5x0WIVxw++CQ/ap7WLndf53ecB8xGWzNBTupobmr9MWL1ynad+PGE//6y3994VOG+370JX/0U2f+jM+VlFJb/RK2JQbpbyVh8zrv5eiGNeMMMxLuCIPU+vFqHtgL8uB3Ee7CFy68ERh1AD2EqePR0mt6mZxj9O8dwtfBA/jVy97N7E3gjGHiOQGrqQ6YsVnM4eEuZZ8kqjGs5gfUzH2wy4SJw10Txmjxl9wi9cHYUt8W1dQpX2lp+pVaE2+LhEI/Tt19TR51FpkXHQpEQoS3LnXkdiVlLMzvrJd5qVNxtaxXX4Na7eqnGkG+L/fSsfp28hk9izjo8R+nVy4ty3EkDD9X7gazmHhGTWsyKo6Yt5uBjc+7/KID0bKMFVeioZ0aikoH3K3sNoBc3bKv0swFgeaDC4zqBVXderTRa66O2uhwJgcyuARbzFQ6PFPt8Mx4h01ztM8zeWeszzOjfca19cr9cO5zB9tsBxvpcW56zIkCEO24oFTN6WrDqndLsdQiKI6wE5pAxuPgYa2KhwBlq8QcMmES6tAqMU1VVRSHqtGT2bUYxbyadOGbF/Mm8Q6R4sXBEImZ9A+bcch70ITPQ5NyH1rUxVTX0XR/f+81RcNkblC4x39Xws/ggmAjUfcsd6+Pumf5CN7VPYsmyRX0jyGY9iVR6I+M/H78XmL8jBszaI0+x0m+osnmDrm2KfxrCm4VDUHgHhs4ZgNHE2tRu6XEro11HHXx2Pj9PRAANWRNyfh5sLEm4VnZ/tWpgzVc46nOchAkks9BBORSMs3hsXBEDrMooIUBQnNQPJ6julj5texFg9tf47bCu0fTvN2Dt4F9O4a3w/btKN4ONmnGapnMoBuLKkeu8+aLB4T3A/29a1WHLKbfd6YmMLCBwzZw0Abub1qw2cAxGzjaFBFbvoJKu9RlWSRCOxHqmV3gLK3KfU/lPbdaMOnrNsBPYZcK7OZoTtiAbTSPPLWgwglgBJojubZSbzJXvZ9VwDlPK2hVD4+e3QsmkpQp/JoqJlfQ4iUzL/fghczL/XjZrTBnsFVeBngh83IYL5l5OYiXmg5JRlt4VpruLnGrqSE9EcZmG80BVSS8HfzbViEly8jGmwcwO+PilA9yj4ttyAbgGbBMQXw+T+HP+eefwFxuRXgrh/EqdSM8CTXgUL6YingfIuJlQR/q4hWbTWDsFloEk2QQL7WgaZqZprBpmummwGmaOafQacrEo47sUjrky9MXrI3h7s/6N2zrMYQijpe9RZa2OiS4BD9jzGJSzdKFjeznkEyN0uXE15nMP1CnBhaKr+B5kJVJ7q8D/KcHdH5ACFlbrhpWW64Igw4H67DR2oD2y03oJRMnzA0u6V2w6HhYwxsIv17DdyJ8SMLn+TeqQe1YcTz7JWl9QEnposX5K9uNnz1F7PyV7XL+yvY+an9lrwlDT4WHFfPaTcv8TSeasGZPeHapCUGZXpjKflaALJ5cFsxtWTCAUILEDfYsb1Oz4vQDX+P0h9MXNMRAzEi1YpkV07Jhwzz7E1jrhE2ehOryiXO/d+ISuZx1TudgC2ik9+lwBcuojmo9MT8SVpiRmpg34s/EsR81cFQgpo+t8mujZDRa0ISHSyXkyobo5THfaXBgfBkwUkF2O6AjTJD97NuQzeTJbtHklBKtlpdimDSHjLJVnuWBHcsGeoeMK+T1ggiQatPM7bCPAm94LaAM/+wZDoGiNWmUV3AmxO5yuwWk76amMxdwDKjgXwt0sBuB0OkyOdsXE4Fa9n6ALRc3oht+HhGv6Ed90XXieXVzSMEURILLlgEnUcwu2PCMKHRYWtjwFYBjr2DfQ3caN4TrbyoTD+4lF7yy53iUB1lT7TbOjy11H7ZUIe6V1tyFuwao+24buM8GHuCAMB/8BGX4mDz5E1+fN/uSHhzG06LdB687PzjkmxIGNnCn+eQonsd8tOEuT9qA2BdpPQe0uCvMN5fra6aVtzRrQkEVw1FAF6RNesa/N4di/BpmB+AhArXhN/spOY0IGA/yEI/deaQXglZH+U2NvFwjA9Cx766eJWnygUry1dVkbUZ2DMO/ghPu0CATBvNI+h+r1t2rRvvV8p42PTskTVXXdl9im7hik0+TxQ7MW189ap3vJF16fpTSkNE547+AUdrH37W+Y04beRPkd77KnCpTenemTOlgjCm9yTGlA8eU3oZgql/cOfbFW9wXd7ov3qZs7E1jbKxSNIBBUvI0OyJEwc3/qnWwGcucdpQ5zZ5dzLZrypfOgfaFBbTv8gXu5CEPp2/Cq+rajY4nGl5G3oW8i0eSb+GUezJNWalURp28Rz54N3g3pjl44tOsxDr325CfVjlomVvmKvAgMLfgVogGCG0Fc7uVWmAVWiVzy4HSB6BQ2PmqptZ2Jpk4racteUHdfAcqnkJOdoJzxVqNwMAGDtvAQRu4f84E7rGBYzZwdI6KfBvtyE/h+k6FiJlOBZa1lC/daTusr6cBEsqmKhS2qkQKqgD8Osmmzo3k2kmnTOZq9TMHGCgy4DDkFDxOoVPB+Jxq2NRlZVNVTKYvx/CSmZd78EL6wl2usqkZAFXyYngblLwY3g6XvBjeDia0pCNEORtF6gls0O1TtDNAJMUBHu9bSDABoUGJAhj8q3oY/dFhL5AVR/Ty3EE5UnOaB/+I9XRvvt3gBotdE9Spb1IZbYVSkJR/ZbGtxziFejiwfawWtCHfhTajTAjMaUmQd/Eky9lTFsNxKe1CR7bTDP4g9KA54VDnaFWeq5RCppRSD6PVo0zZ1JlymXoei+Fuv92twm8qtpuXvXvJBa/sabzuw13wqt6DAU8370XAowMb+ek8WzDtcZFf9H/2l/RjDXMNwrTTnc2nYU4VYgI9XWg8EPu28hDEvAWjsJ31+Jld0ALUAjt11F57noGF3crsbsLDcSxbQ333v/EVh2qKCtlQqLXLcpdmeaCSZR1ZEM4c636Gsu7bzRgzqSi5djpDePJBgqBhyg/ri3LlB+UFbPl2ZsvvSJTbtvSujuVgnPfvGN6/Y3n/jrYN/o+lPRGMHWzsO/vbVj//l+etXOzsoEk713nYaPugoOwXkBsvwwu4VJ/HEHiGNuziQjeGmAeEu1AyD9azN0JF9rbsp/AYFrsIX9KudaIjDicGjPl9WTpou2vBg2JZ8xSl9i3MP3Y5e6YuHfCuziO1nxFjjfEi++r1pRBEyik6MMTdgNoK6SfF7P4DojXncdQsZfwWwubTHocfYYUGuyC5IFRLzqTZZ6njgmNZ3qusMYuVlWTHwymU/HxLubhsoSC7Qwak4OZvZxjP8jO8ILgfT56M9+FJFwT3zOKoBR1bUTlWT694sLMM1lPDWXTaV/X01U0WkBMvDhq40wYGNnDYBg7y2ZKsuai9C9WqbQjtRMiuKTvG1pRicj3BSnHi9eTgY7meLCrF1/VEXw7reqIvA7yQebmzup7cr5oeDbfsXKEvuiBdri+6VO2VMcKekFYhjuTHfm5eAlp7aS+fpy6t4npPqZ4HPTS8n8o15wo2Bi5OW/M1Ttifr5RrQr7MwftnmWLhSMn4Cj6VtnK24pQ1WuYQf79V5Smn0QKZ4FkMKx77vPbuh+aJn967H2IB7f/jM81YIf7wNDprU1HLaeYzflY+a01BrrPoNEhZToOI5SzaifBOI3FpVSQuenR1CpBfegJhmM+L0imiS9YP3QIJVM9XUpURYfnBarVKK2b15HmR78Lzntmc8HxgNgdl4nmDi6hbZLHaYqcJFLk74lW3mKUz3d2JTInNHBc62ad8Z8sTHbO7shzebDMlRXLen1YIQVEhBMtTijm7nOxpOdn54Fjmwlk8QVp61o0V/Oz8LBxxa+N2iEizzZifn6VmmHegL1+DWelr5JLYPBYwQSVMe+T7hk79RZn6aEWX0ROMJKZ+7qb+8tjUX/mmmPpFdeoX1alfVKd+8ein/o7Npz50ck8x3F4LHBrN41wY3TcTtlUKQ8/ZfMZuZYid8/Cm6xR0OKcyWc8Znaxn8Q+QUPcx28DrbQOo0epTcPjPwJUpuKMUll6B/dZ8nyBxzqWDuZmtKitNDa6fPYrrZ+VnqzpHKnO1xG8omXB7ONU495pTFjOhdpXTW6dIYFPxuToYIqZG7QmxIBIlhEMjjjxdfLbdz5KXYJ1tYdOMlqzsK53OhYe0vVIKkXnx8bLL2XStlEoRGCCXeh+njlcFPopNRGGzAI4O/qsgOr0bCpXAJrBoHHymBC/i0CUS2sOhfZTQGTjlUyTKflH5Mle/3MHBJhSF8tlQVqh7GCMH0diPZWpkomFiyUpCt6cXed61InYNSHyF3F5EFEHgFkHCtvv2IdVE0MaJFRlbdivakV4iSp2QEGwYCQHXAu7sXXjtpH3Se4XZHwn5MyIDzVuD1AX5OJB+yffCKSIVtWF1rKJs2jaBsAjRodB0CP5BI5zgo/zIWfGzd+BG0yUV2PUwKoCkpgNbAn+MzNYxJstw9RUHniGprXfRug6hMoATaVG2XSvlITvX9vdfcg35a8a1bajfyj1Bv389e18V1x3SBMTpfV91J1Gr2Arw8F0mrrEzSKWyP5WG6MVTyZ6H/CwdSGBbEFUNCx8f5n/xDYY5Kjh5mN8zCvNPf7PA/C8fLswHatsnuA5Q0CMZhMojGQ3rkYyXfRVgzH31VHCRMbqfne+fy0HvfP8siPkvFDdpKjBUMzfBeUgRV61FyNtqH96I0L3wZ6/ChfI1dpaFIux0/qAllgfxTVZoxjpTq2xqpohTEq0sLCIol+POPGqCRxombkjDvgzA5SiQFlziJg5c1jOu4pHg4aL4frHt4CNB3Hu83Q89sX4UMVnCYhOgVaT2uwKUHXEHRna9NdG5mohK1p4mIXg3hkKPOMpHo6T5mub6h9Zt8FnUEe42UMRtjEPeFSeUDIpkaHytqN0B8ZydVC43NsmvvKXaYK0+7t9Rf4baBkFbCExhgpu9kkxc/FBfGGt9fm0eofqRoS1N72PG8M9KtiWN54o9rqt93NSmmj3p8/QkTQ7X5Le7DnMDGJTsD4CtALcaGel7ckjoq92UXfw17u+/WIoJ+hdDLlKWW66n6X6c4Hm5r8PsFksNa9+L4MgPoQpP759UbdhrXk5H67UMSBGMfY8juErHi8/t6uDnB/2ApdyqkgE8gAxY7SfIh4Ckah9wmjGAFuJRP6LQJB8r50BeMGxGxatAgYoMbGwLdTgNMeebLiQfSKwGYBTPjXkYcW8Jn+PcrxcUfp+I/y7ryUTj+J1rqBm2zzhZ3YMWkd5Kj/SqfAiDA121CbSgjs8ycXd2LlMWkhC4gFUJgQtoSWi3HO3F6rSePFHzyv5Q6aha4NEa1DSWj57WSMNi4saMRZ1qavukCHq52JQmDnCs+UCJl36ibUy0KvUTGFYUZOr/58Pvi/+28Pt7f+T+T1RdhMXP3dumrpOx3H0ZWYhjtxDHkwuxS5dUNPFhVgLq1FkzH7zdLcgB1bJfdgtyTM6jFMVYkN1VOapZ4yaxZg5VaZ/hkmAF1iUXcbGORiw8gdrP8idW4IAb9wuqFKkeyGNBD35SUF2BR0yRvs1jrgdt0BZE2onYLPsYsgCPhHyDcmpzUHkLTsrUQ3kgdi1MqEtYW9SxHQPnV5Qr0Arwna55IV61MzAMJjCBURXxVy4vRWidjlnfRJcyg81qvspFM7nbsM7sI2QIpWPSUjRDe5C9Q3htf9QOVbrXk2UCfLeX3YksMLCkMLWzUhR4zQKNN7U+Ik1MoLqhbgsxvnhIgwVuCMsUr1l3Uh4iOB7hwNr98lEYhi6hQCtQG56j9aTfjj5npssYd2fCTWtCARJSlwPWIkwgUQpQhmf69jpzEjHMKlW8NIWbq4CoerSSFgHagsIhY4D9jArPZVxABqpn13v49Q9/+qH3f+RTr77hKCeD2eJjfUKjs1/Hh2LnBS6cCh+bo/vkzCDEPboNRRUoRMaO44iZ48AujNmRih+SRLWxqyrYkQs2XLAJ39I48hVt7IQiqGE3BnlTnFjlQdU/Rh45NWy1tyN4nzrfGFHf+UZEPZDncJF5Y7NikL+fbNLMlgu2xSlua7SZrUHePlEzhR5bxmvPXl7e91b8ElbYkIjSjfURJzxUdcJDDU07UjSoMekuo0E1V2x0Mr58MGgT5Tg9dWoy20bt4UAVWPzsPRh918kiKvOSC7LYACimIktfDzmC/bjE4iny+xTwUcW4CRiMU7CRN4E0MmTece2cgLUEGlaB7iBJzQHV9UxILXVQqG5szKioqRzjI01aCgmQ2gny1CzW4+DfGzEVX4Vh9YLoIv84+lbL/lzI9bZpsaCIelF093Q/+1iocNcx+zVdmBz532N8h5S3a30nKAHR0khv4jJryrGVet/hR2rKGtTFzRWvX5/0oOMNwbtWcNlz99KRv59Ur1J406aNmnTVKxY8V7yRCxbRACwRpky4WTUlUpZYS4HFfY+8Sdz3pl7JwE0JJYUVZbBg3zOWv/9Ff/z0X+CwR/FwvfSrrB+tvwknfC86vrjhN77R4obfeDjihveOihve980ibnj/wxU3PMeH3pt0eiPn9Lzq86jvC4IafKUDYingwMYRCow1KmAaI1juW3ecNSNa99NDnhdUuKhAgYXeKN8UUaAmGvCacIw0klTTzc8+UOWQ/JJD8vGqMw8cko8IxyHhBd6nRjmki8EtHLUcUtD/mKUVgXJIgeWQsqMlXxRsxhd98BHwRTtKitIapSggO0ou/s/jnT4XzUCxzBrsj/HUv6or94Ox8wGF8VCxkLQKUIdJQ54I2e+oGjCUnv217HfxRv6U84lQb9n6hMA9NnDMBo56Zv6Kd2NIV8bXvNionGv+O+2HAxs4bAMHPaqrTc8NZqtkseRf8EcQHNWpsX/KYnnULpaUDHRKrcsKAYpxFzqlBCDCoQaHxCRFS+gB4trafWqIvvdMxZdggAs/sLsP+VkGxZWO0aPIZ1VRnDgBlypg/USmMW4up4hdpFnThgW+9yCa0ovmPIDaZQYkLo8mejha9mieUOEtRZe6A1pCkJbxy0cYuPKISb1ghSVzNI8vjSJQG4929RZT3qnahE2pgZeGvqjQBk3V3iyUHcNWmmvCY5bbOq+nJKNiGhHz5JFxj6844L34UqUDMIc2P1Y+gDiPHoyJe9CDBFXHY3zHxyb4jmmxXM5J8h0fHuc7nlZSiZ0VFmNXlcXQ5G4leXWCA3EtuNhQI3n062s80QolTtxl0RlVUzQrHLEga1NYicM+2A8qGtFJtRc4aPo9Sy2hwRiyBmN/jywX3iYTdzd5hCeZZ2aeQu7WRnV9fSzSaGj2+8biprnCGjBvWPAPRgvtSCz4vhhEMJGLvxLwhyMnL8E+GA2NuKEUVWvbO/qaoWpxSkD8dxnkNhH54LAhpGRi4OcNKQ27qKqjxKZQl7Qa2bIWOvCpXL/FHMtbqV4JphYlHNolsZzOD1EbhWQa5korMwdCpRTtSqXnTf4ob9oJlJk5kOmwqskSRrW8MU7/Wujt5PjIKLRFIF03lu9bVN+wdG1QbgJ8CDCM+ayiCV18MVQMWPU2hpTye2XnIHQkRVNTHE+qCRaBrbY4kOYWsV52QOaQ9CXBS4Ov8+cNcxJgSEbEg2qH/L1+FJTLjqJhgtEd2XsfDEff7wp5AD31atDfmwfV4QrF/u9e4VFgBPuBECMjPjPViHkgAuVojULiJ1J1wNTXnjA+autspNFjg+Dgo8sR2qLUSQBZ723kIdXzwJwO+MT14ULB9ms27PISVlYcqZ90Oyz8qNKyalN8EHIljQaMtfQuP8Z9BwDQHxXPTsGPImbRx26KCE8yz8w81bY1EEdXyoqjZWwrFVtwjC/dbLlk3d7XqAU4GttTWAWpjmaPaLOWH1H7FrhTubSntl3VTyQcVRsvFSl/IwqdKJnfmDKhdIOKmLUAjI8zp+RZWB7gE3agU+mH80ZJZ9TfqkLLWhIKS8V7BrVRtqdm+pYwwllUcF2glEe3nxVqqXaCcHtIr9nuMVFdjhIzzziO83Cw44EqZB9/pfMSDvbS6YSr71A5wClCnHo9ByKMiBEJL5czXgBZh8AplJQnempTHZOgL+OCJpwecGNs+/R0Ua8BI0qPHrV1KgZu4iCuQfx3aU/ZSxwGUnMDB2J4qzYebbyE2xZrY1PT2FCaOChacjRWpxADHmrj02GR8s8RJkMBpOZidGnG0bDr1KNN/zR45m8o1cxDjA4XoRbsMS+PoOiScnJcA+PvNDPcTZvsC8IEz/TrxH/f0ev/wFr2NxIFtjrgQnuwR6+WCbjGLnNl/MiMd5WWnK+Zc7EGNZmvMQOmfIcH6wvlvbbzphlrZt9/+yfMNOuCPt1C8wlc0f/dFFf0DwSRY9KdqWaLnpUVDAWOLxjgFrrCnzunKFHfxx7N8b8T64RyCOQp1ytHJkIiEFrIE3Uz1qAA+h5KJQjZ5aMmwLvvr+KnffgNn/+ykrdEUqelMA5htjZBK5qW8Kmz2LHls7rwjDrbB5+ZB9KvcHq/7nzs+vXJP/zOM17zQG3vZL9cyiPpl5J1z9mNo+jRbsE/9o3bgt+/6Rb8Eyfegn/8W1tw3YL/5kltwY/6x9+CqwtStwXHBin71HG34G7ffLIb7oe3vQ6mb6+PPdrtNbrGBDz6v357HVa31+HI9nrwsLbXZJhuOsnN9WDq5ppG99ZH/bG99f1T99b3P+K99Z9/w/fWt47sjQd+tRW0lv2v6tbYw9a4u+nW+GS3wmH2v+1WmKbshAe+7exvVbdFGBlthj+5NfJG3+/w+r7Vx5FJEvSvwPvIBomTrgBNDMiHCbvqBkniighIAEYM7I/ZIKmqhC8tBa8e9QMxLu1R9PRNN0hHKxukYMoGyTcbpEA3SH6/M7lBAs2Q+gk8nN0gkS6ngGMwuj3SyQLXJ1O3RzR9d/SvtxuiR7kZ8h7mZogqe6HwxHuhR8ty/NU3juV4/T9sxnJ85sQsx73fYjmU5ViPEuxzQVsaer3cTo1j3gnYjJdXeYw7mcf4/GY8xjTGIsSMuMPLIzwHXh6P0QydcFiDxE6Bp89DHiWWzWCczpuGjHgi6hJDA1Qnj7F9gt1A0FKTxqbshjIZbe0RFxSCtRCWI9fb6XnGaYc9sY5EIU9u5PdohlocUKaCWhuG3YDhUXAZC+ZWTKYMxLyptjXBYXTKDEic4DDaIGwLNLcph7Ewdmd4lhb4S1zLoBRkBAfEh9B4CDZJVDdAtJtIawnD1uI4DMkhr1igiCJauLKng3QYMTHFEhNTCDIbGlpS5SEg4OK7qx4/4wt4aA1PsTCFp1hAi5WnMBJEjlOe4pg3ylNgvk/wFIh9pDzF577hPMVbPN93PMWxqgQJDfiCJVNTFqDAqIbjWVMhDh6VtT0p+Qg/+1vlI6ysZzq7ka1VcnJrnDny0HupbjCmNsUzVnLwzMyzNqEOVX2lqcs/Vm4VSfQ96xJYXGBEooetU9PJeUygZlykx72i7uZxqesb9IMD9lMazYDFmj+FV0LlAI74caw7KSF3FQ3M6YphulrGwmMoNaJIiY5b41PpBy+lcp+zzYkzMD3vMmQy65mrd64DO+Qf0DcwBBl/06EZTEBMyhmaHWEIMssQzDmGoEENte4fM5GwfsWVCYAb+rlBjlmd6KzuyKxmiSF1xlf7jl3tO7rap+n7fT8QPLBedLmpWKGMio86eMUn3KBICTq7s9illksy8IhCQjkbnl08wwO4wJj9vbqbR3QL0T5aDfpQ6xiDI3eNGRx5nzM4cpczOPJhNTiCRFdHRLDucyB7G0RqZVP6HJB8x6lcXVc/y+h3aIfAuKzpx9VKfOmI7V92v5pyMfcdVDL3iZUeNhGMZS8r9+4vA8b5HA4U8zhcl/dQ0n3Oa7nRIswjKEmfAjsu1ur9VHPVdWNaHk8yz8w8a8aFNR6hWsNP8qb03SySsRggVB/XKRiEdrsmFpzEpCKlUFtknExh3Dbjx/N4veAH4XIu9It4VUshIwXt3sgXYfR4ca2fvDBfcni/zAUevDjvOn2mLbCbDE4RGoCslUkLxH988b/X70BRrFgV51oofyul8PG1DY9MbNuGWonYniaCrYsQf5f2eAZs0PYjwyKnXKgCYbYSrVKIgVEeEgdxBxfzAj3mGnxMoiLfgc72sHzvtKVDL4sK3NfWGApxNZXU/Mc2yq8stvZy1J8TB3LaKVreWgvt1JuUhAV/hy2RloTWhURU6E0FLmQnCsk5ggMcixaHchGzwDVJLaFIaYeAgRbxSEwXi+2DPO9fx/XMcbMzAcjW4hSF2s4ixGDt1BK2EeENNW0zHqNPgeT7FK5xF+JDXFM5lavO5YMf0iu0XME2qaBjK3Dlbi1O05qkgl1aAeCxSyuwbn9CTUYFeYhklC18scA+oJbchT+daz5VeJxTGQbivWcXovgzE0saewYVtONIfib1+Lv8LH50rsnPplW8nUM5APRA/YfyxzGm7CYvf7yg2Qqds1as8J0DuBFXqTpQsITrPD0eKPIEDjzh0t7GCJSfOMjPJQPVWQ50DxRPwt39jPihMN+pqacqbE5VkOQWJOdSbkCyEyABotxTK4HeZqic64BugFoQV5tTh9+5vhD2ATIKtb4FrWaBKz5Vc28yxrgRjeaEmqxDgGTUxJW2sfTLofV5HL5bwvn5krBH4/dw8KjGX0CPwxpyoSLOgsI5f7KAoZCiSebUKepdZQEHOenZfMVI9fQ4ZTedgt0PgQPcxpNiO52JpiXF9mGxfJwznLBfpxBnOEwpQKyqfIEGKDRnO1vW3513uSqhH5h2zuZ5SKswngCiGsICxzaBGqNSkQ8dswATa1ipOMN2mpYAVbjQUpatDH6Zpymdku9O+y/vX0sX9hg4u2jXbc6dXpEfceXQlpFC87ZA7TQ6hQkH2s3atBTv4m4W4YvYOVj+JK7zuv7Ludy1/HG2L+jbVu3bwQYwYFUcNpEoE1IbF7Yf92JauAZN3kpdOoWedM07bwJh/+Ab9yCuHwre4EG2U0C94jR19acQ3MIdWR4wtTuD+O/KHlU7MtqNx401+6JKs59y4mZjUND0x6HpthNPQrsv7XHMU0Y7c9FJdwZDkz/IC3Pf56a8SJuQr9HplOBeyuPJ24+1HLWezXaSZCwulMUHwoiGcC1IhzGDifZDUIy7+cTZpJD2GVzmwhl+7SbiYO2NxYxaQ9THf2Ez02gv9ksd2HJ4IS6hS87iqfRUmvn+XqU7C3gs2F713BqG4UHzfGqONA/N0YbRAscV7TUuOH8qnaatZoDaZtIZvP7PYIET6fhTb8IIrKHBMM8Mj9L8owai+CvapBMLthMh8VejneBEkUP3dM09G5aYzsLPKQb+Z4HNFD1WUIMcjyy/2BEQoJ/MQLp4oHZPdDrrGLTd6o9PwfC69b5cRNEERrFLDchOMcUqAdpr1q1Ni76Yi94uhWMC7JKFrVecwTfi92IyHBkOjl8n7jdiIPDHt9sWCEfbWIy0ERnHd9lDrnR8l4LhDEey0BBHsrj6M2i7tBj20bXPBTq/TSX6qH4qWTLjcJpIAE3dZjLkba1m6rQELpFWk9urFt82sKHfYpA86FP7RTIl0Ywj754yE7VRC2jNAup/GHPPl7n3TTjrPJl13/zzrYb5VhudbymdR+eDg9pDF4C9OpeezIwSPSF/PJ3KnNpOZgefmG+nJ5CPYmQ/kLctf497dd09/rGEn1suCO7Cc/mC4GhCC9QS28Ui8IkBhBl+5gxD6XBsOecZ2iqt/n7hnNF24gAgEAICKqaSLZthn6Qoiqw59vdSvp4+5HnRdRSIizPy1vDcDXWZ/cQ/l/bwvqcID6j3fXH6Hqq3tPp+DJJ6DaM6UnFcKWDR3etFuOYteZ9R1C8V1hSFUCJ58UUR7QdCQ2lLdogc5CYC/D7wxcdYIoM5S0vspLNtRKGm3XqV5yxwwD6h+ZzXtB0V1XU77pstM1osLT2BisiXpqiI3BuGdd18WhEYuesXdnMfYnMfEcYBcfZKAsWX9mAeeGJ7n4d286tb6S5CCSAGMVhAMS50SdPlpq7k0ysLCR4JIhoItTDUTYQyjDYObt6iZo0XKED0ghhVhXjIXPoM1DudhLocCqWyBjUpfS8sCojwP/uKbPObY9v85gXizECFDPeNCRk+5YQM9zkhw70qZECi2//XiZVP46qQARfTd2kRVTgkZfcT7X6j7H7rseo+Ot866e6j7SrjCK2MA+Nett4Ja6bJOOKRrXTgrCx/b01PFUqUwlPIvGcRSok9+fhVd3SyvsjCoUsFDkLl9BMrRiDYe2M2ExlBXSSiEj2XCCUcWmEJ9HKS/sGzICyxZr5Fqt20eqP22CosWlWNu7aY2BIhxww/d0PWEWNPlZEnZG+Woo18jss52BWxxrzSffhwoXR/kdAs8R/zqItGciEeYxdRxDJ5kFx08chE5JFoOeKiaoW6tEwJ/phqpSy52HJkCHvWIrlYATxWaMmI1BXcTZZcdI1z80WVXPTUk7nY6NpqSudvuaYezhw1hhI+PqAVORkoumyJqFjuceEcIg60aSvXkpha1AYU5xYv6bZEmpfjl4QL6anXby5kKwppcwQHOBYt5u5AcrGMgqSEHozaAQw0h0diulhs4dPP/nVcz4wIF1ZkF53w9pVflwuWOZRt6NIKolFTV3e1sCYH+1SJJifYeiZIll1tj7js7uZlb6+UTbbsLpEpezvK3q5lkykbyUZoEVEMsC9B2JBDB0SFDQVF+Q71LUo5r8PjgoaFEgwZ7RCXpxzYCUFDFSinDHivbvo+wwHe+LOT1FkIARRnZrUbs9yNrZVutG03TqW2dgN8KLqbaLJ2A8kCIgOCHnGFYIW2oyZxGdShRGtqaU0trmn2+IMxi5pmNxmMLdL2ooVNfluMuGfFrgHLemDqXkCsg3maAjI/A7it/6lX4u3gXL3Uvi7psreseKnzKbPz6XTinspewM0gh5Ye5sBS6XvaFEYtlS/lp29a7C4udoua2Sq6XAn/8T7gTN4HEIfPxD7g+PVBpuPjj3cBLdrO/WFeErX7XC4xVFTbdZCfyYx5QAUvSTDUW2kLccl4ctFcppweLtOZRDoVu7wj2CK9R6hLW3hsevzsTuXbu0ektdRl/n07+HduK8rlDoSVDrR41EEqW0GaArEVWh2Ox6YlAUWT6hMeTEskFGoJt3BZiAVxo7bQitm0tE1r0U7dtGhVFnLLqBGUI1VnGAIqvKHmcchkx4MM6sGMmtr/tul/+6T6r9iiHmZQm+KIzJWm1rwT5GIx3ya40jI1DwH+oVBYn5bVvp1AbY8YbNs9GCqu7pJXGgwkL8JdiclshsQYeBsAfisl/NTw9HYKUBV0rPnPxKH52y1MW3jwJEbXloW0FNsEpqfSGaBacP8AESgtalcQEc7egOVT+cOd+Q6Cic2tsLKYb6GdFKtKkro0M2tkSrNQR+GBky1AU6gOP3UpwjJkl6C2WYTGlyBdgBiyKN1SNWu9vp3+9KNz5nb/+kk4c7vpF8Dz3YFf68ztgf/bnblN9aN1sm7bqs6zSt9c32ze2zZz2XaSfto6U7v4CNy1KQqqu7YJdAOm/V/nru0R49ammDXpn+2HSwOUx35hdDP3YXnHZk6TdDP3EQRTVToL8VPjXa+YZ6GodL7jDCP1pRTBvexBjBDfhan4MLq6iPF4nvNhdIXzYfSSR+3D6N4o9qwGuCN8x2oP35ERxowZrJt9ucOA8b7Hz776WPg1gpbCcXwbdR6xb6Ofe5i+jTJcU0pgTkYXtTj7R+mfbLVjPFribysVh+z63G2eZJ5ZZV8ourBqlSqP+omoudeh0IGQ1l+HJkTED130A1WybtOsrsRVV3fuDvOMxJL/LF0oAeYUddEMx+CxH0oq4ox+TSu1xfIfT6s2yuWUyh6ZW99G79GoPJC2uhZG4BEokkKuLKIelz6LCC2p2sKa9KD0ziRsCPxUZv8CQJagMd6ZZP7fDl7HeGe6Gj/Pm+qd6YpJ70xO5egHvKpcKtJYvZSb8cNDgyKC2qKqSiakFmbhUketJ0aCdHCuEwEfHkJzOUgPz6/O8Q3hPm8zQ7j/hNrSz6aNVKapU/Aoe3V/bb/T34Ca2AHol6jixfMoBrG6Qt++T9++W98u17dL9G2fvl0kq0xeV5kTpjIEacqONSlG9HNYAUms7WGt2c+Qfj5HwCDUgSLFcAcHoP73IjsbY7U/0qIUEApFzaENC30xAUMkrphh03zASsIUPEtdD1OaHTokJfQ/5t6cdBDN1LYjy0WMjRRKcyjOXmOzLkh+ic471gZPVr3jB7Df7K1jG4yNaCI9gbhjzs3WeZw8XpEvqIBnse9dIvbRl3XjwmM+r/ts4cqZi10kH9zxgpFFhdRSAVnuuzJ7tIiJpMT8oEdbqIdCmOlYpVXmcrbebnTP59aoyzHl2kdsv7x8ubK3jvymWDo6HLqVDZ+HkB6pPviDfrGN37Zd0qucM/uY7D713FdwiY6pXxdGOfdTmq8kztudp3poMTfUAZ6L8kSh5FMqor+EfHs+UReaKYrATpSNSkIUUg4ixGTU4WwjI1j4ykQv6yhmQs2WjRW/SwpfO6Lm9LQhdcpkvxRKtUWikjPypfo6+XgkGKIE0ns1BZg8E9rvol+LChizgZrJ04u5tt7F4fUHcr6UEDFTjaijBXULUd0EVYFjEWoRrftu28gVhVZIqexgePelTdkmEPMQlNkxt6ZK+Ly94v4fEI9BdIT4d9e6Ikhd9crrBr4zhE9ocU2orYO3Ns/s2BK0MlHogxtU997wh8Oamy9m+P88JM/FNoUqP0Ick9E2LJ4x6XDxJ2fBDKaEdkMQLyEYyVxACI7VQFYR3KO2MXWMVX9czWTCyOJrMdYWWg5GZ+Wh9futO9zRHqmuZEQpupJauYseNqDBRSKq8HJ3hDQsEkO9T0Y9mRXF6pVFvYeDUI7gAMeaDwS/zSfouXTZ2NiMheBozAMaoz0bj/qYjXrPq2zUPWNRTL8tv9lLDwcj5jrjcXOdFGVfm2ZpSs9z6iOmrOrOlFV90pSVS5dUdPZhV4PWd9bKT77uzFqFVMsOHirNWtUJ1xKswWKqG8NWtCa7sv1yUiUVSMQuqVSMXK1B8xMdqJi4imDPky5FQ6yJK53nAR6liatgwsRVyC3/ZbScmMnCXgHZ8zo/KRw1cRU7Re13eGKA1t1KibWHdUEocyoFJGkIPmGRHLHoKbS9+YM4bYOeOzUkuMs/7AHF0IcY9WfXH3rkRj3ro5dXvhPXNe709L4GTEMbtXVd4UPpnTQWTdJOiHna7IZD9i5LvNldllcc+ndg2fM3owAcVuQuvDvGEYC4G24xFcUOe2rx+xCe3gUYbLm/8pJRLfWrR1+fp5mu4Mf1YnI9eA6hwBGzeIE1i1fE2d+9Ck+xc12/gNkV5RnyRPgxsd3BfbtWrba+yPEYWMo4DxBvuO/mWV3Eh2U6jGiLXjxOt/Z99MnX/dCbB5+9eIhixUIN7yhvvQX/fs9cpksxfcX2jIcFZ0CJYQk3jPnKG+76vefv/q/3ah1mf/2dl33wd+/dFrMtwexvXylmZCjCPLtEW32RtvpciqhlLUloWO3UK6u+Cw/yZHMQAVtfgp8XYQkB6xhRep6cnjTAyTYpyr4KiCHPVUXA669suILyUBsVwOIB2qOG0b9SgxOz24Vy6+m2fKzy9Tal6kpEeMWiPigkeEjHoQpbteoQkSky+wfjpHN1LftnCepUw6rJodP9EGYyBA6JwgH9jcCcC5zNIlHTerBuZV/Sjmn5MnF0UeKIg+PXWO6Ydo1lIha0Qi+RzOh9q+wmubkhN0xc4t+MGlj0tSo9TLGkIFA5GvPh/o8UOAa2SQm05kOOvczERaIt4QkGgrIIJ8VhklnY8kGMUQFfQvBl++/9SMGJyHBZr/91eCviyAf5Wb+0B4Bja/argI1QzzzYvJbQ1KISMGm4Njtgke9+uWsgX0TIp2otNSkS9Ph0Pznf5M/F3r5SF5ATpTWJPhzlyd6JVq2or6VIfOEjjRum9MYvF5tOmr0LeWvpe3wvvs7BzrTOgk9hzZUqmFEsVFPUoLZvrEzrgaoyhwkYpkQOnosYGCpFY3woLKGEXb9+HQvvHFe2CQl0iBLdxdd17cFYaSf0NXudcnHluKGjrvl8lI0hRHVhZQgTO4TZQeCc9iyRgotwpEHc/EpXVKmp2qDs3htOwsbJ6w9NKrDAuMqIERVdxCzwvf06Aaim09Qus//YDE5ht7i+u8M4qvaShyo5vGdMcvgxJznUJCn3UwiKpAZdx/QO19Ro50JRxyMrdLNdNCiGER3RbRc7PU09mUj1ymBLt8Zt3SjP6F2MjmJwpvc0ZoU/mUV/QTZgngADifd5oDRasCCvi2DbpMGU8TuUbnQTsoR2La8537uSqehKtqIhm90tXMky4BlC9M5f7JbdcEQdRdHlvEZbLJpSNMLjo//Iak7LasDcmmKuoTgNbMNEOoGZtcz+0/g0CLx6N19VN3ZQJjiAevdKc7ahHbtyPoDPyTg3K8RwxA5RabGX7aHyKTYUd6L5coOUttNOuCPz8wjZrUdCuaO1A2e3Un6D4CEsga6sFJjzEJcXSwM6jbPVcQNNxeLhUdAyvJDaxNAX8StrX2pq9KKhFYjLs11VNyUJJeLIbBcFuCXKUXh1zswguXImveSaVl0v0AP8zZwzcLxV4t+Bu9wRLVulsmXawUHtewNv+0UpscYdr0uPGrSDamuPsFNbqD7RKUDt4fcLfQKlUKOydBrioA5RyKjUKgBzFUjxiXWNJsUG48XmKDYnUoglecElkULMOq3tIQvrp+C7rYr6NXAMBjGp1vbSKa77dhn7us80I9HNk8lcxen5Lm73LgUadFrxLM6AW7Uz4FZNwJHvklZjpuCBAfbFzIYyLvO0yKMGu1sq73Ws4ZmAS98zyLlLwHomhsjY51OFAbUHABhyAPbpBd6cUaTGZ9FZdKbRD8ZRKyjELH6EeEB4wTBvIYKfp1GqoeynhdKHKmAEgcMebI5Ln9PzKyVzNYq5Fz3tR+Cu6D7as9r7fuEkzmpf/1YQ5sFb3VmteoZ/9Ge13zqr/dZZraKgntVOoBsw7VtntY/grPbHG4kvWpx6pDlGHyLNZ67/vnXs+i/elSXTJL3+i6DxMhD3kac83GEDN8r6OIJaN3x5id/gt+/z1sqzXo4aKSP7cRG31IXps/ekrT0rCvJmtcCJr1WmzMxfqkQsRStbNM3ATFuOIiPCk8wzM09DtfrJs1FH1bAVJoZcUQ3kXnmIs0krkIW/24zUvmmHZvGYow7NXVXeFXHq9pkcTPLUlFhqgb2Q80KdMC05mMRjfz5LgR5MSj2hLZb/gENWh3cWvOCs2Wd3hFfMZ/uJa1tGs0BI+fzKIutxuSgm0zKqbUPL83mh+6oxHdGjBFbzXxFYzX8DYEGwDw5AgLYAtx+cI/tNHJFn/0t2384eAS2AOMzTfBlzPBoxp46b2H2NT6HZCJQf/gD3ek6gXF0H5kbpxxzNVejHnJBtFLop6ebhiEG6xZxoTKHO2qbBB7R/HsdR2Y+jY1w38vDr1yE1gr0qMaiodtL0Rosew1tG5S9aql9x7dJ1Pv/a41qPt8JVYnT3GDH6iCNGmlSTK/RKjKYxig1B1YTwzKTDQVUFvYmWR6AteESwaldXuzN1vIkNCdkH1Qk2AWLB4KS/G8f7lMmeG53CmxHUpuA3MxiIyeTwq6irQRUlWNivCicViWSeIuHnxODEHNdjuidZaE53k/O7/H00f3btElxjm0cRfMffNyRWlc+XlKVblmxgSrsgiVJYsYUWxCf/St4zjuoTOUDGlW2woCu0SotCLrn9AqAuRlz6GIFVRZ3nIl3PBbZw/oUD+s4g5zYin4hSrLImt8PuZ+sKHy0p30qLDJWeOenYSvXRba2eFdqjqwyzMxPE6dESthKrwKbV0loWACP6/tje4pYi7BN0xcHz9gNI1a0tybEJrgCI5ZslDKeozN9fc/taUijly7YPW2gZyvxeZb+8VXZzdXAJeU541vJCy5GtLHpVR3xYMzBW+G21ezmeCUVlo8aIARKTyQcNykeSSCAB/IkUf6xW+aoFRD1f5eoW7Y50kXocNO3G2/58GQNOPdN8/mztm6IHOoy0rERhtHbFJ621i1ppiX9RSb2UeWtYZeHTqlkCGi2ZS3mKLfZmQRcN7grmyN4JAPL3cr06ceAlVFqgs2MJzdArH/JJsXWqz/qGsJHYsaIXgt9TCFGh3ru0H1TozrXIsWPN3Y61AZhqjzKdBD46v1Vai20smgas3lqhYWJb3lP4UUPA34TYqLpbbcrmNc/MzrZOmd54bKpJjR20g5q6W61RT+/JmXlf1Nfwzpixhqg9ShoENlS3G9bq1ExpDm9zNKtvsM0lB+QzMOLTwVB1KECPSFTZm9oxq+mlvayj2xE3L5PmyeoboZHEgabVnjJGNOVsEZhUyvib7MvWT0aMC/kmyZdjpavPV202SMZ/5pAxnmYOnNQynok253UXnWc3SN8t/D8fcVurzQJOFSnDxBM3X0BfNHrC1ug9MCdJ52MZ1iEQCqqyq6Iu5ojgLnYAlb1IW3W7vd4GJSRkSyhBRuS+hZq3yBel0uLGRXrzoi4KC2bBYmwAfNSQsbTdmBbNfhp9q0jX0x+tuLTwzVQTAOlUE8U04184Vv/CxvtwCJ2yGgWieoZjfrXO7XgNmCcX6+TZ/7xReiSuWLzsN6433jD+H2/a5ciAPL3Fh23RhbUeh3y9jqeX8BYk1JPDazk4hUu/d6Bb1ZtxD9SZzaizXlggf6aa3e7I0q8afaZgeKSoOrGrO2sX3bP3ffe/5F+V/mRF4jLBgV2ZelUPr0Nq4L9BdliMzw2ooSFJO1JmHorv4fWi6RwNIoetkwsb5jx6+x78xS/+ybN+8IqLhxUPfnIWzAigRcrOqO2u2UHExpNsRsI8R0CXmEo5mqG0qCPW6nIOMMIhv66sZRPO3XuV+/bFN7S/8g/5TU+llNzLlT0xcZWluAQJo77oUT7H5wC3ff76o3e9+qtv+hrwcROXj8nIIeq8rPz98IX5gmtoIuQZCQJ4mqUwuxGcj9k3JyTznwQO6/ilhDnp1r5LfuV9t37pk6996g8Vsp57uD6T/c5rlFk1r7+L19KW3Aweq8WSyD4UIBoGeQHAGEAGaEUsdyhmKOYIDpQQXLKaX03x4F90MaIz8gXycsuc2VLIQtD2LkybyUEEHpnKTCjfoufgwO6GOv2GCDC2n7PC8pBw32gL5Co47OIWbDgVZv6Hm0m491asMAauwzssxQ7ZOTkGxYCII3nuNcLl+89t20NL0QOc/Zuzr7/lZ65/CrEn6wRI8KGfffEHju469NSqlfeEFlmUi50PMH+FK3JY6oJXMjLH2GgtQIlxluaReQuPmMvcqGbG5U9WobJKRTDLDDLW7kffLne4yqJcLrDwu+3M/35WrNDjKHs4ZSeHb1y1Y2xBAHCyyUfl2S1Wqy7MfXvM6btjTjV1azylP9PduKUg++dXlF/q0arPZav/QWVtrYF5tbBo9kP4FMWlnw69zqSFRFFU9aTl5Gk/5K2F4Rk9UVarwSEO/MEFmHVKjjx1c6NSXCPojnRKVbeQP9gWf/CcJueg+NJvoYkeeaCrn7rBHdyZfpInWt3IopbXQJx924wikvVdAa1gT3jcUtMFW+7/lHKRK9dceZJSome3ecP2o4l+8FYSf+w1KKUG+lRdUtHxdt80rlWw5BJQQEkygXFDS7csPnXEUm5MKXgNdVM+friWCBzARcZO3TMFxcANZb2DTU2d6bYS4aucUfaa8WitCmDxmqnidB/jOFEFuHnpvgJMj64bZq2mRnarYiZDzOVCHgHPgezLCkXyAFnAVZXsqiY1v+D7MZ8LuGW2NCgrFeahmfVqXVB2pzoeMR5yZu40t2pQqtLjb7yw/2Y/NfIQipQjo0DGJJDDHPtCkswxaDbUUlV868NHViinzgeE9VH9yjwu+S1AV2t3Q15EqhAJcALhAEUzyorsdfsW6fzVcatyQUDgkLQQ1cWEShUctGR5gnhRQck4XtUayMv+Ai0DzmBWSluV8nCYnEeSQ6EfjfCedSvT0LsrENkoz8QPc/ySZH+AYUzLiJbE7u+3ni9n/hCkgL2/rJf91Y1aFtIx3gc4CXBpiEIv31BRF+v+frYDW6SXyerXZHTZP2pyXP3XemIFAyZkuSxViMKU5f8GQ2dECwKdDdW4yu5F9fC0VUclm3/gj3xArSNqT/bl4vKF6o7HrTYeTU/16mmKPVuDYmPO2kN3VPkVOAjOSKW91bUoEJMnqeqW26ufjKp6N1naCjbZep4JbApzQYE9T29gygvjXHc+cr2NouWWXrLhOy8aUosX4vCWITZY1QWYAr5G1Ff1CVX7wHF59ibMZQyzDrSX3YaIwndKhbrSqEQmeZiaRcFUzaKgqlkUnIxmkW81i/xxzSKPIx8Y1Sz62UOTmkXBv7lm0ZsPTdUsCqZoFumgTLoEKmqjY3fwFRItpagmZfpcHuDp3K2RpnlKvdAOIeFuyEFs0mqrWvLiC86iS6XCaPrkqS6OXjLFxZFSDquWA1blF32vPsldGPJRlHfxikCwR6hkZHEAVeoigDxYmIsAKAHHffxXokRgUQLtdygRoYaAYrvsCRsk2nyo1VUdc7H789CyVJAVBIoBqBX++oRBxpcI4Vj6PP1Wtu1KtiMQ5RYqQT55hHhImsEGgZS5EzBl/F8FG/uTa6RvZhmKF5QMEQWVflHsXeCH329hJ6prqBoHDnBw6AsiiG4FFkNFu2you2+sP4FlAysrSHqgNPVPvM6HPAX713uXoEw9z2Ct1P7Rg0DU2w4KnHmyhiD2YVVVHbLx7BdQVaeMw7mGxAEmPyuVvfXk8SMcwQ9vE/wIxvED/b9/FD/WR/CjhFMESP0bYchbjoshP4fURzjdf35iuofV6R6e5HS/+qSm+3FomDdKw0JLw27xA5zFhJOXKyxXOBP4fk2496vXCiiLSxue3RYHd2APgcQO26mOJ8MA37KE/Tva1tf4HQwKJIBdAMIm+/OGtdvdXMvlA4o0P48tDG1nvyjoCjIOviGEO7hII8FQAqPVfrkI7X7JVOC+p0gQ3pXgYmxcYmLfitiRGw5/4nmxAwuWN3REdo6cCRqbhvcnoxkqR92xaCTiURNKgNAqRlho4QIEIhHY2wClxVwMJJ6hhR8KQAV5jPWYiwHQY6qtYYlVFSp8gN10TIneNgrgcdAPEZLrEa3USpDrssPQtqpK55+pJxE3tkHNAwNPNduCjtaA7uqQe27IBYHdUI9+5N6q5K+jeJBYNIA/kreVdKmmmBABBWK5nktRZYzqlnAxBVAnpoFJQVrdFPd2Gbn0g57OQh0j9YZC0GTVmMA6jydfsGXNthAvgBFHA0itUHUpyR/tt2/ya+7cb3mjfa4h1g4PJxiIow3SnGoRNpPWS0bd9l9Cr+nwzZ2Fijcf3bdT/ZltdFofvFGHUkSfy9ufN3WzlkpG2TquFS3BGY8aqK5h3Fi5LvZr8D7J2PKdICdQb31+0RZnGwqBlvRBi2rkM9RSpSC88xvWJ2pgYch5LqHujFpGuMjzWpYkoW+zwPCMZtGYYhYCM4AnZFu1azTbE+1VauQd/qEZKS5T6tHsX4fqE9MABV7AL+QJS5hoSKUjlJweIE5DiGuFQgjQqQztQKuNvo32y8tTrghvUmtD1W9nES8gbKALNXyqkzTV/e/spUUoggiqoQvoCkv2dNdiimpj6nbIozT7ZUFXPRUuGtBOiKi9H/ICjmqu8bqmN+UVdxs0y0OC4WhRB7MD30EhSskTpbnn6JvsqSuJkBm1cigRedTG+RGcR0VqQBP46D7JfkWJXeKI3Xtg3dFRON9h9gS184XaxYXEx0L0wupciSvf+rI8+CgyymuB5kTpPNlBXBKzlNQpcfUhQbDCN5fQbJKla2GVpv2fP/Ff6Y9cbgzd+ksqLzRsoj50bXVd9DXF0xT9CsVH8qmj2IGKIPz91nGKdTCFStCaUI9+ygrEgoUWEWBIfFsOSiFc/WKhgiFPiKDIFlctSfEuu1Ov0KVj/qAodCj4ykA2zEAnywbgVNacDscUYfii6vCpXrIOXyo58rpeM3Sgi5k4cgJ4JtlN6v6yYwAl9hbNUNfcqiUQtHMtHBu91Ay5Xo/U6aVi32pTvWpTvbKpftlUoAGDFV8ot6+ghkTNOOmJCGItswrzlKj0PEbFgUHYEBmAtZq1rv3BamG+0ATtT1RFaKEQ0gjUbMyW+l5jlO3R0Q6xBYjKbUkMQnJJry97ExF8qp6SDl2My3NJIDHqkzjhFcj0K+BXrEQlPjVVX8pXss6vvpJ1YI6SdQ1JXKLorbNMC66TtIYx8pkigZSeMoUFXwEmk9NBxrVBiq8JloO0bFA63qDk5BvUMA1aQ4O04IRiMC0KDJjkVek3XgSj1tInbXYbx2gxBtmvTrmR85YmH2w3So2pkOdyVWPq6NtLjal7jIbUh8VPopwmbUjq9NO4O5CmulUoROUvICS7DuDsAofgKl4PdWcSHcB9X6MKpJuSBHk8WS4bME/XFAc5uTieIiiDb+Rt2PScsTgRQ1Ck2NHnNxEUzVSkiOmRW4oZSm+BGi0UmKldSWxKYrNMzPiMFQeD5Oshc8HbvTtApxIjTb3Rx+9BvVzvHShClbu8Dc5j7gjWII8TtZf+hhAIlfPe52kJ3SLuy+TEy+ozevrtFzgVmqz4Fsff5bdBVa+uEH3tYJND0AC2YQkYCHsrIhW/xxOhwj1qtUBaR372Tr1Fpo6/M6g6DhkAmQDGP5M/ut1ZNrpSCDJGBT0qRZdlm8xpvGbhI/rs1XjPM8UarVK7ZoaW89AMqt7tzmwpM4fZp+8dcnNafAI7W9ZAs9XzPGqt377vpQu//O2f/tG38KH5rDlbvOYp5IJ8ej4L6F5CnjmQ6XvZe1UPwrQL3c0G2btkKcnIN9GzFc9yv6bbbW5PJs0dKrxm+dtZQZN3y8czFBAMF4liOnJchaMibqa97Ithow5iA9LxIy40+3V8vS/90f/e8rhn8G8l00GMWdyao5YZPgFXqmImtB6/2bmSVLxMUhO2WTcYzwt8x+ritxeZS++4w+Ii6h25zWEUcB42iSpZruw9GBSxEGs9GxmtJxu8abOPAuwbLxOX7CGhBy1gebZh9tjBBk81xGo3gv0480JXNIceTqi8WU9WII065mF2YH37QmhPcRH/kVo1/j2HbPzRkfjfKOPPnV7MrolorpapoWUkjno+3ClaaYmvPjP5kelxqR7z6nmbBxoVVY9G4lHVdYgtkZGZfcMYG/SE8ZahaqlD/2R6nphiOfqWI1aKB7dTIBmpxh7TJHVQRIJfWEICCpXO3xrEMLjsq28q5yfV8oZKUyMKcTa8IA+5OyP3p0M5U+NmC7/Cs+inAFAshxRVVFfikl6QC7KSQrz+JkaL+n7Yb3DZqy5Xg76f814y101prJcQ040iGpLPCsceFr+KtxK0E0xWV+2xIRXwyN6HZg2hupS4NuuxkChRiCl4910R4WWhbxy8p5zeK1ID6CNwyTpAWxisIEYcTE3wyDo/cEjVYo2VAHfhr8KhZRPnXk1zO67/6ZpRWENT9KSiPOGjsHrA99oggOGLwPFI7nbriG9AFH2eT2qU627vgk1VYTI9ve7vhHS1hkUklW/u8vIYXzuq6mfvl8kBxAF2aq5RrZKaOhakus0NfvVcvSy6C2IAvW7EgFPzP+IJn/DDZnKb5/k7hSEKNwx138LUvbmxXvjq3w+D1aDAHeAFXM1hm5JUU8yhawSEb4I4jPTFLUYfQCOP35eY6potxURxl/l/LYgwP9R5qtWN2FcYxwM4j67Ma9m44Xzqfu/5yrQ8c9yZcBzILlyPohqc8cCa0S8UaQCviIjIipTSgbjq5PLytkyCFgFlXJ6hWUpi7hgMxQFJb+E1MnWjmVbXyAGPdRtajLC/WjX2bhXp6/ImLLa/nv24GsCgQHT0fbMs/xn0xFSymH1Q1qqPfgT/2PMbvqyh7U1yOmdApNuH6zAkJ+Xgu6PW4IqudkUKzSB/33dtbHvl5/8Dj5uW+BVuftkOwKOM5yUmLXNDRyzFXBxKW9WuUvqzYd0St0CsyY8YHUvWcx/Pbh48vCHFbcxRNbeIEhnEIgSHJDeHZLHm1/swuULlUCNIYQA4sGNwEuapaUHmsKqjyHXJKBYdHsfMtTkb4XV8uSYHsc1QCrvPeIdmIHfWB+oCRe7jIRuOnkMZ9bBi+RhOFaCapzbodeRFqZCXknJayhXAjXUU41x7D/MOwQ4LyvPIHwpnYZJ37V1nFi/UfurFGPtl7SlDoXeIa+777nuza374jM89lRssS4jCArymtjHZQM9aTF4ZrwfapYRaBxA9QI3UBkIPtHfq+0wtS/cb0hWf/Nu1aRQMFSsDMFpYDvng/KEw8Y2XxhiU1nkKP+i74wl1oilQKOqOWq2r8ZdjXt5APUOevP4txudiqO7A+x7+mNrN9DPiv0txpyeWq8vcBNGThl9hd78OaCGmGWfXNgbFHM0NBzxrVIEuKWs2gYYNfBVTZO6WYp4f81f28EscvrJY6JX3ewbrxTyih/LAlaAPHfzv9/7B9/wUW4r59hf90W884w9+7YOsWrHzlo8/+VMzvwvXX9/z8zffMNjxccRuueiZ//LZr/09xxbzR/jjhZ4+56r3iuaO0Bz5lZhh4dIrWfXWVdZP7DUreEHFoM0a1fpInSvni8YBj2yraQGbuCVBkTlmG2Y4cuZSQBb3V+TO1MzGkXxe5rXCmDT38jDvusk619+Vz3ChXYYtuNC1IjPcwjy3icwMyrk0ji5m0J5FLoiW8d9wSHPH7ZXx0dORfrQh72hTCwwXo4RwrWhZ6en/Qs93Zi/wYx0NZx+GzqgmaOqoIYz0OJ/+9ok+fYPvexW/31XblcLdgVTLCfo+8jj04dpa9iGzcMYMW6OufPDGc/pKycXBM74wArjfFGKulaJuZYPlsOW3Sor/YdWG1y60zDmjtWoWO+OhFHTSfpK9QXS1PDFjR/XsL7GL1Lb1f+p1fA4pCdmtyKVNMWmv5rTsTRLtSUL2aWsZLvsxPbp8g+eDBljBbvZ2wK9Qs1oGjNWlQGVbnKLaZpV4I/31VFeJO1zlQJRFxTnspT3mRKFeAswfcylLXvrLib9wXVglQ2GpqRkp471b2fBdFMIuE+lbV09lYn1LZE9D/OY03eq6/+nzbVzl+7iLNr/egkR+kzlxat5gUvTooImIfXmKxx69BX9W3saD8hk8kryDx4K4OZ41grpMzZmIeiJsOYoKUx4BjBKah2qx1V6E2RPwJ8SPRWrhsUQpHjAeHInWyrI6opgVEegyQUEiBshZS1ndpyPEhFMjlsqkhdEkkFaKNnil7PLUBXag5kU8eMbjsUQLeCygA5BczmFNmsPUns+j1PjFAP9mjHvMg6XT+9XVDc2KqJIKCNfgeiUWDMm3ONzpCjfY1W70uEG0whwMNfL5lgiy4fGk2KKtRAGoSzXIoKxqthPzwIy6nCzpODV0nJo6TqmOU0vHqV0aT81ouTI84jCD2m44YkCDpySg0cRjgRp4RDSrpzPSaAG7ekRYMiFAWSIWyqSokqQPqMlNBbnTXsUZtIM8Qx0Js9YI6ryVi+vMcML2Ilb3OXG+BEwbHY8Y41G347G46Xj40q8hxRvrblhQ5PiwLEo5PCxLRrXZDkudllRz1myG1KDQ7mKRGNUu68muDdIK4V6yXxHaHep5e2j3hFSf2CW6NeTds80Wsy1zxnOSP3rv/nDidvJqyOHF6nRatT+fKSyvMLzC2dpdRRGjqXXRKICuZwPqNk32C5I9CAotLH6dLXqCiaSmXmWVg1m9yqqXlToYoc5GAVEafoa5E9Vh5ectUZLPyXWyDDBMcJ2VwzSLI/cDG8xObKwPOeccRnzO2FXpPx6TzfINHaMhrVQs4559pb4GBf0DHMws5Zun0O2XNdt9yFbNs+CK+NR42iK/3Bxbyqkygxiy2roID3qqAR/hiiwOAuAWCjcGu/qZeALeQiFknWogSa/IGrFdaCwfQSxNPVzp2splwBHVNkXlBb0nWJcJuh11YQZDj54U6DluwoONZJvPtLqGVuGkM1f7PmI1ZweqATNCOq0xSFTgppv1Tc9w7pa2ktqUrIH7VL/zmCjUWaOZqut5LrwFibxx60GG4yFUIv6PdvS7OlJ4maHtOk7LtPUApPO07QCQBb5hRJV9S1kjSn4eqhGc4Zery5cBv72k+lYGbzdNItckBrvUv4obidtpXsz54nbgDqoD0wpaBPCIFiwMAROAiTpyS1ed4gHgqKh7a57hmbD0tZ/BzE8+JxZMBTmRkmmGGqd388SYyaLIHkohZad0MD+FiJuZi/WqGdrBnxe6X5DNO80aPWItzjgfMrA5xaTtrKRpG7TfeWKnSxuPNoP/OmVjzXzst1g5Xq5ech6BQF2vLrcFENomuaHbVuiqdXp1UlNoB4pTFAUSbkYGLvqU4RG8a822OdoA2ypth5wluqbwoSv8cy9hUAo8CgZpilnww+VN7LG5ZrTqxUrDqZBQyKrI9P0/nPexJz790Ocuxr7Yl01TJiRPd2kAuCMCH7xOWKQqUeDVFncdZMqg8IqOdX4aFFrwx9JrPMUTW8TkMO/qhAfV3wX7ZuB08hW3natvlHs1huDGuoq21uENFp7oevzYCcfoQDvA6QxjeyQUA8kNwfUzh+jKGUq/W5YEn0Wnj8WczXBjfh4USlIKaegqna1ofhYeuVKMLTIdmE7FQNtzcKu9Kpg+xQVxcIGbMZUY2t4Xdf/tmFgdgs+f7XrmUNCZdM6tdA4n+df0imBYPO7WfLf7dKdM+JxRhPK2IVqM+/aCqrJ3QgGoq9P8VsroTLfHohlWsv7hYkcPC8ruIc53Nbvu9GZvpVniRKBrR/ZjbXoczSJfZmNm8Q6agSJ20k6YzUHDVAQCXa/oGb3JWaRETIWLO2/Ps1QtTckKmdcroIM9PfJkXdO5eouZqZykU8HOD8fTwJaA3oGGk3A+tkJDe8Sv53B7d6HxspKoIwqW7yB9C23FspLTqthIw4M4v7+eA/7c3O2GAJ+qS9mdhrc4+zz/9eAmXu/YCTprIq4BGtowG/KQFnEBFsWUnyxMxMxPxKTjMcyPWL7l/rATXGuFL/gL5emVf5VLqOuFTOnqbivUneMziwiPy4tYNWA8igDsvM67fOdEvip4bYqvqgYEdrqW5Xirr+cNu27cJwf+SrzBBiV4rBYpx6L0TIyGIVS5ngs6R6lsCWdMJiwofQ+mPJTczW4Uc6U4FHKEHAKHLv6YrCxMa6xylKPCRvhdW8R9UFqEK75Li24PNzC7vXwRZhkQWObkeVrakE3OEcY/I96zJI32DofMWDXg41A4bjW1zmABZdYpyCW1cZBBc5x3UKDIxUHB1eJ6qQAtw+4no9m8AzGKPdNoEo5HOEMIK1vQ4qbYiJNVrrqkUtaujFcpL8wbfRhTFsq3pCMDLVq92iOlNdyppBuqezy1xQC5JpcMfFcNNL3KGlBY3sbJ0tf30sDgW8jPFOGX+tclJa8cVS6skadibV1CAj0v30N+/8YARgxPxx2yPZY/DN3wRKpjIanEWSvHU24lMHFP22vWA4dHLrdcEqz0Wa81FEF/4Ktks383D148WXN8omoXHlG1u6znZqosabrOBLw7irTIvE7wqWJecBHrLAaDLlC4ammxoKlYIHMKZcicqiyb+6753n987VU/+IWLh+s4pYCkYgYPYdLUyBsuAeh1BbFc1ucAFDv6NStWVf4aNaKRLeSSUZm1KO6t53LShx1vdgDUvgnGusVS7QNFwIIJNeYi0sj9+SJSF4jjl7QlyzLMh8PSvgvegvKtn+YBzeddWpJ1Lsg7OkD6DZejik3CzXX5VdFUCxlLnnHJdjgOKuZ3aRH7jBk8ZtR9SkAdTjF1zWlBKMbWW54oa02ViEFRlyqW9aN6KVWh+pW9ybrnOACgLeMJs0DyZMKDp2zkM8hCW8qxqbzXCnpPV4KDSXWfp7fyOnIVsyODXcyojbqYOlIl6bucoCMa8CTAJ5C2X8lEkPMC9zhgUdYQJRyJSU/gzeUerzJhHMmt96m6uGzBGoFuU1PBQ5Hcc78AjR2dHXVgUX0MMk2hR0xO8aa3NhmJosruWXFy2eIkT2pAblmc3ihKLnMc42TLIBUBohhBCS4oG9cEsgOjAMc7A/KnWIRZ4WPfAScRAocDauWBGhTR0kTV3V4fpzmgT4y+xDrh+x6j7YafL/KePsq7aCyyLFRFP7EIynFexWA46gu8AkZIxKwr2rwEH83wEHXB83SpA+GIEZrYzUAk9YWCtvMUFNhtFh2UwqQt5m+XJClAcVwGatHx171HFy1X0YsvpfumgygCWf0zufucl39lM4IWmYlCTe1PdUbItgIAiUcpYBN43LROXDK0PSutDO37H5de+8D7/vNfXjzETUNF5Zai9+IovVq09MoRvWgdMmRQHVoWitPFKOMFu9EloIV1TA3EEdtoy8p4zyllm7d7+bo4bVsCsawuEC/FhAIUMVWGAjyh8NQFNNSAix54CPCVBgkN0dPIyFGESCkCpmfeseyxAcM83ub7O/EmNqNamL2LOik1bHRhgCeVWRyDicEsjiuzuFUu6iqMg/YaliG7KB8O9W73MpTo57jdOu5mae5VMiVYub0XFS0WDRB++Photh+OfrCqUxOghANlEWrpbAP9XoSYBSQWMsm8y72DxFTJkZ1FsjUNrORSMR5dcDKrZcBsEVBa7EcGSrI+rcqs1lozPf3abFKHR7FHROBOGxjYAHpLkieweWxgENg8gTZezqzQVVmGOyoZmFeRwJKgUZZ3Tc/nDV4ojtESaWjLxMKmhGGLXdeKaDi2tCkCxqOLmjVzyIiEN5gjZUhf2tvPjegKVLsGajRnSfuCGBsD6asxRJjE7SZ9uRMvZF4GeMnMy2G81OxLwC97bTa8XG4LwMsVZIrGy9XmeE9NTinA5lPCnhtzj0VpzTUV9ioOYVZg0lMgkoNFc17exCJIs4jr1wF5ADXPcOi7f0Nc0uVbWfRZbKNtw3w7tTYKIhrmuWLHnDlzXhKkLGbF3Nx8dZ63KwsZWKXK7l3HKqYFGa8tOvEiDMW29UHO7/1MUdfHGM3oyj1D8wdEZMjgnhff0LFKSuNpOkYY932/6RlnHLmn93uqTUhcEOKeSsOBR9PzuaCqvReTqqYU9IodyvB0SxYHaOP4G9q+Xuy8fQjvIYXS9zah90grxMFirIbw+TXBFsKjHbSTDR+Nr/rLuHBYKkvDfidmdExbue+vePGlz/vNUy56ylBU2D1QyiE8DRYDrTJHhe2B1hbBO3jCL1APkiVOrQsC8Sk25Nzq7e1a48gukIo5vqtNIkVY/vo1a38rZl4JzJA6JgB9VSmAnq5YscYCZeAiDKWOjK4E3x4UQnm4ogTZmxKXTolrTIkLYbwLK5PGIDWy+/9f+WZUnVTFyWiqpuRdUcBH7hWnj9WjFTmP1UdCfva3cj4dwuggedlv60ZS3+WI/HcQk0dlXLDvifLvry7OfhdJfCwE6YPdsB+DEiXFFaeUAp4NpqACvY2iXtGWrjOvKnDL7kJZ+HJQ2v7mPrPXnD+HZ01kYcHGht39nbNXzvN18/t7+insrWkTzcdrIBfC9QHtpnUqlSZh4sMfzhPEMEj/Q61nqwXlDx9+xSFOJIgHtr/wPP85XMC9gBKFII7Z79tNd0vBc7p/FUAq6qdXWXF6ZA227/KfV1RjuG7X3MTertqf/cEh67wJ3APnSErNvop6QSIav/yzygz566E58BWMY/9zuOncZ3soAFr/aOuywuupUoGesuOr/k34oIzNpAVgOznrBmrSw3f7QcYLBcpWVWVN6//la6tFhGtcFQPQlSAQKr8IXREAoCT273qFKyLRFNV4wLBajYd/rIdNsYobvtSZqqsbgNQpVCs1AYXZR3Q01HB/ApVfaARA/pI3zf01MXsN36KYuW2ZudDDggJXaO7B6OdN0gERWRo1YVkoezWq5BR+70kKTzWoeMEUlF4bbGG9VMcK2MjZhbfLr8gPs451a8CMM+5nDzfUOEB1QPitKMQ2kyvXC5DilFBPe7RhEN1B7FWwLlCqHHurv/1HiuSHCWZutMUZtV2L88Tobuog48wy6UlhsB5DKKS//cUvtAbCMzUxMKOuNmapuZHPlUd2ODu1a6Sup1hk7DOfl4ttfGJM7TWxpLowLRM1AWkoZrGFT37AZ0Qv51eJYEKfyDV46xITjcYAXKpniTtN2QWy3++VFXzQPjlSlLESmheWdIEXknnOvShwpoTmsp+BRWb0Dw2A9dEu9MweateYzIdRXLdPlM85+HukJo1m2mrPdOyTk9hUKTdcBZampQCqESJQG9GzNI9CEjTaeg6ZAc8yQw3NqHvKiZGHgFYyqNGEUND5QGnnuM+ywsEnmDbmc8ZOGB6M6+qytMsPWOLgh7iwrssZKGZFAmubESUb0MOk4MDaxtDYU7ycCfLcejFXsYpdsbxYxh/eSy7ItyX8IkF5l/SIn3ydq8fvgtMf1evqoI9oVTzZqiaZrH+oWZ2xuqsDVfJXQ1B/ZF0NqvUKxKmPUS87ppRc9CXx0x1QVMqOB7rk7BO9243P4rwNfYYppI0x9+b/xfMmjQrh1pTKzEI5qeof+huGON70MpRabhNbJ9kfW30x6D78ybg10feEoSc62eGUewseBeYi0Id59YyyP5U+xaoz1cX6Aw4sFFqMGhHqWu/jD3J39JaAetLKPiYLiHqKjC8tkh7EDARRg7jy1ep0Cf5Fqe7j+oEyN/pVT6yFqD3JNr6Is08gl3WSEuMRqv3reKMq7gYN27c7+rF7z/n6mWdeWeXny1wjBj3zYMRMe0ANaFa7zGDX1qGezVeBHP9NaUWZ8fai5VpAzXX1Llg0b81uRgC30vlzw7Z8+WLcA3MtgCFIKGI74cYPuTZzX9bVeGmLmkeGWt7QtS1lq/GBKpjEYteiFFsPyQPqUF3gpuv5wNi2wWDiqscnBaKeQtTdp1As0r/Lemvw8loaIjkalvcqRM/e076a+5oh8ODQ/2YUNYcSXChCQ0T/nYkekHdkWPElcFB4RsiqjFePO0PzQhDH2ZcMIjn7gr3TwVDFB7BSDJEU2oNWSLdD2BiLtPbCWESDxqV35RQ3BpEWA73IS/PQKreFSJLScrge5fpyv5+M1iGeE03Z4k5eL/RzwB+tA/aYAtSBlnA5ciiHkqSlAqwfaHvmG86q7crxIcPcDYuYhEpv8cLgOkefVnXniGDLup9GCSUWifUbXA0iX/aE6q9MZ1uNYt5v21vbpDXj+k3/azAkdc1GHqbi4K7vvXBDN4ohDol93DfegOqmJWP72ABq+s7ZZoO3Kg1zeOQzvWm81HtZxTWpX6IPFwJuEIbxwemS2jRhLMzuVvIFZoWUzJ3LD8iGobcHgrd7LfszZNK1J8RDrCDAzSSWsl2qluWpWlaNeTb480tUPaJxIPtzwf2muc4/qrWaumDLBdugNQ0GBE5XZI/PjxDCiDpsY86iH4fghh91iFK2HpIYf+z78gW1Kbuo5+BLlZKn1pdW9nBqBR9CJGNFT00UyZ1f3qJBZgYqjUqt3ma+XOnGFhdcsZ6Be/hwVT7s2Q9XaIVV/lLoKQxuz5dxE1K3gQ2k88cCblhAOpB7hPtyOZjGkeq5NhTABW0lb4M/qW3k2wTOqyPSlWXA09XN7aWt+Go7P1iYQzTPVSzk0OyMlIXUQ+stOptXhlxJzdyO2DYcvHuP3OifWZO6aQuXcUTjwFt71jpABBFjZNykbh1AF4+2D3JYS6ZB3oILDZwumD2/3vK2ZtNjaOv2rDs/HdtFu3R8Ld9SIkhEdcgJu4onM5M51bmElNSbZsG+yEXcgxp3qWLKIsHpYTErshOoqMr1tClf7shznKKL47ud/HcKGG4Sxo3FcblnxoF7uIqOcsyUQk7Jd6II0cuoFYEaTVBQPtTg2/if9R661+OiA5oBUHdSoOmVxJ3WtO68MpE74LMvP02m2wJ1GazPntrz08Rb4WlU26TS0+hUqk3UxnHaFFNpoJX63LRTHvqMV+zir05DoOAfluhewUm7qOBP+eVyzccvxU7kQ+AUzbfXJuFlt14hntLonUKRyBP/fPItf/N5j3L+yXNjiUCWAmf2tCcv1RG2g7snz3SMZyHWpp1w/AhFN1rQUQxzD6PDCafw36l2REMZ0SmtO5XzIX+I1gN8m47oqXZET5kyoqeMjihXfRr/7ZARDY8zojzq8D+56YjuwGhP1HbaJiMKt5UyovzVDgROr47o6W5EkQ8DiXwInOpGFEluRAFHYDqaPvjN6l9x6si4nkY5yvg8z5gn/9Key6p/xQ5uNgp4+XdW/4pdqOcBj4G+U/DPlkDITyYVv4DvGJ4UhLm7gCGvwKUwgnXFH2srw6ccXib4WfAzI1+X7NY1Re2FZzDxOUMNx8jLe5VnozPeC10VHFAts1rXFnNp3LjnmINTiDm7RcSqmXt4ZHnpVKYJTaeQFrm92UA2GTg3JFmrfEbfMWmTX3H4jGqTfrNUHHyAd0btoawFG4N931//0PVviNnlEbXcpS1cZ95YxwrlBH3DIaWlggV5I8lHkTwYlFvLweBI4ZZB0qDy7+nnfC+ccnFY7wjdDl0wI3qtuDOWGWf75p1di8CEwFIHFquQZQqcwepVjKZLKsD6MCqAgLUDgxMDZNY5EVEtO6KvagMkUmGNGnRSS5EJ+4Yl5YhCHEcYi1ahfuKrCIolXSS3uiUb4kLlDUPnL1/dGXv4LhPf9pkYrrwbzSNfGEzJDm7R2JwW4yrc3+rt4PRVEe9DVZmtsqXwS5u+zqJvEVTdQKyD07wdt9YDZ28kD0v099YATdl2AM4itcXb8Ihz4BUh4S9tQlm6bgmUzNjdiE++243oi+5G9EV3I/LidiO+bCNi9ZliGyY7BfH0GmvzcGcWjwRXF1zVbtrHWgzVsRvxrAKkJ60yuxFfdiO8WRipQ5l5U7YcEItckzgQjtXhy25E79YoEGU34ktLBYbYjeg3djcSYzeCxMopPPb/+88MAFSGtNKVI0XoQO6CTGLMaPlakW2o3JhyZVYHyZWp4KIQpaSjY6WfHn4lsDosX67qmc03xsXtoGQDeftwmH7S4yk/aqeLanqI7md/p+eS/QVjnjzUGFxaU1hJpPEVjSoCPCKk9a8rdUYilKpVYmqv4cKIt+bclFun0V4lA/+BWQ1U58K5iQmtJI44Xs9gechVEifin4IXKkDjBA7Ff+k1k+aLjv/FW6d88VK9BWjvI+qO03d7qCfv7aTlRNb27vu7zx+9YMfvX7h3329svCG+f2mPDZy/1+4xwmf0cM70jN5A/DKEpV+GcspfsHeQ/icf+8oJ67jW86hirQ4qysjephQSto98NY79+2JWJ6hYk8WRzCB9pxcEcmi12TlboOOe+xN6UQjGlbO1uj03q4+dm+nZ2tQ8ericR+qjAeedxi4JBbpZzz6FPevYSdt/5rutwEvMX19B2dbuVrwRygUsH19h63zos2Z2ZV+4UQp02nQJ8OigKXrN86aZXhZzJvyAuqk1uQyJkmzThSSqlBAhlRL2UWsI8SBzCp+WjTfKoYrFiHpQF0VmqlWFeYFv+ySE80RivaAq1otGxHoRJC0jYr0QawpG5UjhVNKpPiLWS1xbKLZivdiK9epQZBkV640uWVSv+iv6IaQ7wV64DilKQvEUsV6dxXoRcCWS/bbgz3OVNVDDPritVy0qb/Q90db2Cm8SgN8AwEEOxETZAS4ZAVxagUPdAq5uAZfgLsJxAZcMpWwHuAYFAFdK9SngShy4ACaCoKsJ5aUmWWj5uCvDCV5qbHgXTRzpjAERqoxMhGEHs/nvFYywqSCALPweSDu/cwAAs9c0gYPCC5yIQvzCY0gh3h7g/GJzvjEPqqyg58TNli2sMoXwKjZ4LJk+sGLRNKYvNIyOOhlRh0/TmL5Qi6FImT690DuN6QvGmT6x2mvKvrIIwfShFg4EU5k+ZT/zYArTF0wyfWFeZbCsY5FJLisY4bKCE2HGHY8hZtwYeMGknVZrWjf7q0NTdldua+q2b5HbvkWT2zeXLqmYCA+rCjB9HdX9uBfZFc7c7+wz+gpeIzL2SpVlUqv5cDe4JjcA9uN3t1h9lIiz8LNnbX//2mvWDImKtJya3KrHvg58I0XSIMRFuq+L0D6BeG3Kvs7nVv+F+s8SKibZQRm4edV93YiZ2I97fngcFSUnHMeCZtRj8mhScymuSr3rLpgcV3NJfNwlhrs6vnaTuNSpQ3MJzJWVbA8pVudrY+zVsxiPjbMy47pMnaKo4s+bXzPqnwwSWkn0nSeXqo+ylnwGDRsodWEHogdB5AM+rwd8SkAVbD+pwQZd1Wasj3aqHysKgTe+kDRooOjNrGkHavJtTckHuqtloMqHUU4nzf7XmC+W/63vW2tWG4ix+C8QV1WcWdW+fgLYwfTkKx9H58CZc6wAAokCiC/5bORaUEBPFwL8hHxcAwSRnVXgRCqCwhSsSbSu+fw6K6om/KczCVcJK/xSBA6AQ7ory4NKXTIT6lJXKEXLWUPd1BUiX4S6lL8IMSmn10UBCC+YjpgCU6UyHYF+G4HpCITpwORWNmOkLSF+YmlLHVUrasTaFr1YHq5JdIp2UB1kflpreBUoBCzEAdQ6uXIve+C1dQ2pnBCnhzyxlWPPiEIjaVIL3ipWIl8GJfssvpIRkbwiDvprxQL9GJn1wD+UV/EFBHvP/IA4SqZFJ5WXopQZ6SxLxU9T/1M1dYjB6PDhf2DUQ3FQb0NJPNFtUz5nVQModAa5071m7mIuZvdJHz2SIvhRkWzp3h+P0Lj4kKYl6cuwt3KGd4zRb22tGrvZX/ER5+/nZGQV2tH3OqnuF9V68DOoprs4Wc4QcQ3GBffLse0ye9NCPwbWpM+TkSBPDJbjIRUjrPKGQt2ba5elBRyPcMBRqAf1JkLTwSl6kk0gM9rL9NsB6cwCmvyKzyatCQVISD3uWJcvgUT1DXUL06+kccyqcmo7rlz+B96IQDW76VBZTYunpE/S+FU9YC5EK0eG4QCr6ThE5C/VR7uYJu5nYvAdzIsFq3ipqPNJNmIyANIo6sKiYgKLirkPYbmxx7lT0WiVQlVWCqc7quc1NiQ8L9LPnkkBHpcbSZB1DAItSHWhrqrEqpJn/DFKy3MDrsvl4jSXAA0kPUNX9yG4pOHjsZoL7faQJ0QeU+TfA26SofChXXeev0vmlVNSzZuIQFXSyGspQBdfNCFCT51urNqIVL9z0oYiVtYBZjiSQIFPvj1wrouiCPrxkhxdBVUC/WQvON9HAebWc/jB3ftuvKEHAc7jLVgo6fvZ/erUB7Og8PW+qxSInxfJpeAEjMVZDFBZzu/Dd9k/YVEp2urDsS2VOmG3r7NaqZstWQ0zasWmGe3si6gcZhtGqxQTpgeyr6rpTBloJXYLsgrgHleEu7ruSvKQUrZf6k4ioMPpwJp3YHg4tfyjDovQqmfmNbUqfdijwI2MLyOD0X5BUYeB1AuCmzkDV8w/h7217Esq+iFOOORpCQc9TVP1+uzLmuNMLjlvUcAhLsLVgCbYSurkH9hfsCZ0NtTLp0VzCOXlADeSb+XgbqNmswduppWeoL2wrb4LQjYJ7YYiaaCgPc+/WdLVlvBNnpgc7aJpie3BV9C+ifYU/sZ63pw0/oU2Xt0Tp4GcYVbVW6rb56aiLjXXjzi4623zmbxlvVvgGkZmsJxTMbFmqTV89x70JzIt+weFnAyP8Zv6TJ0OC5eqFqhOu1hnyJyQYJhM02W6CxzUBipGipV7dYuIaaN3t9wxVY3HQBfMNdVL9zHgOhCCF3Vpl7Pk2kL7p6b50lxpRFEzJ3XA/tje+QlEK1hGT7/7R9PXpBL3TyaurRMWxEa9lZrBddFv1Gim6aU8PV3ExCsX51r254hPt02LxXKudvV2Y3s4KcLFDgnKptnfHhrzlvom8CVTPMeTh4FQZ232MoWuGXsKLFK64l1EgTuk1OSzKsm7q8lS5uqa9SaqoECkbEvROIWC7xrH5VT69n6wsxOHic6JC6RPeWhcCrSAHcodGiJ7dk05XXT/2jXs9fXDgEK8h9Z0HVKLei6yGved+sgMRX+t76sPVj2Y0J0GhM24Vxmpm0D7vLRn3Nj5o27svLbn3NjZUlKlCC1dpZQa+In4FMe1UMyr7Ou6U8dWiUGnfu1gB8z0oQYstT5ZRo0HfzwccX4XWfDpFoDbjoC6O4iVGauDhH+HSajDKUbCEUXjmYiSlS1RlynwvGV9C+VN9cNlvAo1KbaugFOwY4jRu73yqe72Y+BZA43wcZpHIRTh07X9ZvMdU7q/MAayY/ViFNvix8rmh+bUglMu2HJVMay5e9aXXiLwQxfwDgjWKxVrJzCqqJrTnq2dDKQxWqdVZ0TVyHJppTPGXg3ubqPOptYZGg8QnlQcIxJ9Mfq5qS6YjHvWJaWgIBoQA+OaKI3qpSPKuHRE6ZF+W/FQWtdhNP0RCXbsvHooX2zbj5vMKTce5ct2HKDIXoEtOI5JjT9J9bJmCYpzJHl7FIgRi8mZqTuO7Lg+BH30XI/Hxdix8n+KTSBYav8qcK5r1M2tr1M10A99vudwYS3EK/nu0kQDFDJw3lfBE+rsiqkhDoNNd4PsAfRFByKTLYn4IvbVFjUDDqqc2VedNKrFKa0DDNlCGhBrP/irLjwYN9XPcCi2rdkDSOkrxseoNJCKK34zel+Bl3Ptb0xaQEcq7b/147/0cXZsg241TEoL2+AGmo8G9X8JOajV58cZjAYdpav/jGYqp8LVjdQjRAXgAL+nbU6AXc97vqgwNKyrkgaOT0qfk2JCgwSabSmziBFGZ8TocGC8UbYoUYg3BMp4S/QBXxL/YrCoTfhad92An4JpKhh1RuFMV3Qw1E979qDinZVwqdY6oAcR4ENIrNI9cfrpLG5fl/u69xGB6y1FWCb8IBYGdnbztK/bf7UbbPifvl773pJHeuA6VcrAUaCy0hXf8uK/7v0nUwa3NhcvxJH7vMKHcXok9aCC0QKtvbCv1/5/7dro5xSW3+GEWSAQWS4t5KgfM1G3apQv8lO1UwMbZumrfM+/1sLHv2U6dKY3pGbfH/y6HBhriR0FlPpVGmlqsDmYNi8MpRwPGiNjgfVdDxTwKcow/Q8MSEzHDaACAxXA4d31xBqyZOkr/5Wa1vfUnChcjDU+x5lwO3iU3y8XfX/ycIXFXcTzybevFJrzj90I43YL/+weXGDfu/jZw+97yut62GrBVpsWgfRL8giPvdZ27iWjhuT2Ttt4o0orRLdejMA4xRXFn0ZfLXqkIFpyjSeFt0rWg2irny0Ujf5p0yp91BaW3UTH1OQ85TPSrbyDx648qxbgjxfgipTc8qXCQsqScg2sMuocuQA9hyl1Du01Lh+FvKkHBqVeeqUlpVBr0JrbzNj1DHoQiWstrBC87OJuDLXUnyQ1dVWaregjUJOJfz7nYnCJrsXFSZnfLgXMEn+dgNTPwkRfC2CjSNeOOchVUIFYM+wADSENoc6w6IiYmDpiW8qqDyhsBGoGNrHcRtSv80yBHFtsyhgURDNcnIX4jEUswGsXtbDktIwVHMUDHea10q1NIOr1Su0XEG4J2SyztQorym2B80UUc7LfpvbCQH1Q77vzxZTmcZ7CRYTUEiYlUJ/2onBLdfldhDZ5itakipxuKEyNdiyegca5sTILBM9Ju2O48TF2a81anXtUUaTq1PprJ3Bqvbld9FedyC762Z43+mlNPzWHSh5y12zufzUv3je85vgd/vHg5D33g7Wa8NyPuNB57uf51edBx6Fp62p+WzuBH/9PMCvkGT/+4JGcH/+PI4VC5ZWcH/8bX+P8+G9W58Py6t9/0fO5gLXH3rf/K18zzbc/6lJkGnPv/2rEPULn3T/+mnHn3d0Dznk3Xsacd++d5ry74M+uZoxeewQevE+vbOdlwlj/i/+NR7X/1B/ue9lh6XR6k+81Ts6Ve4H9unPlHlZcuTtH7t64I3eIaB7U/ZXYPYYc43ZUAYVJnGPGljSQqyziyvabcoWbDnXjGVFouGkckaoIhMtHOVUdYGWcPWBFoo8QD0nLPvJq57M9mPDZ/lGk1tLXxuww0Xu5u1Bf2eXrVO+/fG3GhxPs8rqnbK20fjSj5QuTpUIUnbkjYhAy5Ctwp9y2DD0H0TKqcTZTjfefT6PXnI8XuTtk2FuZTyxnwNNeV5U9AjIZpzgqfVMHzdKq86ql2PZCtG4WqhhlNcZa3ii/Us/sGqHUPaXYVYL2owRXCySETGFSIxr3CD6n+Me2VZvIkcGlxhh8AF/MTeCBAyh6R001dV+kkDQlE+Ip/gS9QHOkuyx8DVIY2ldvVrH428SnLTE3l/D+faQMbX1rjbNA5B+B7LCIH7ZBImqrlQLZ0cmO3kiUWiUI64BLk9EY7VYRyEQTU4WfB8gk0h+GhIDVStV8itHg2NzsVug0cgAqGCkLPeOG1qoNJW1oYmhADLUd21D0CBLwFqWUZAdlYYrkFgUSdpcSivQYJJub+BTubOZS2DrKlT2nfqgXIMecCYdjzoQj56iYP9WCA4yRL1+rC2GhDr4hC4iwZEEnufMefP1rpnoPPgKaZ/3TBpAJhUIfERI/8s4/bWzmQUSYWGoRuu7cwcYw3J6oVhW/eKadDRAovDUNVjd1gtQVICpV1I+FqBEInvigDa0PWkg69wNBUadqVpgOA1WdD9p0pNL6lEoTU+laxfEtKt1fSKeAMGN+ZoO19BfBEOnV1cBsdTBqYWmw3rcwR1Ie2tH3NBWZQZ7xJjyToer+ftUmQTFg4/3Kwh4BdaoLu9zOVoIaGTMCUqStyUdaALlE/eRWMPgfDt0K5lVWMK+yhgXjaxhQ8H4jIwxVOHRIlvgINQQUO0fjwvChlRHqdZXHXLD2PdC+x0aAqmucSKVV/KOhBGew+i1U1xQOERaAFipBPnmEeEha9prXuIWtPrGwvfZR8DOvn+BnWlV+pjXBz+wu+ZkwewM+PhH/8r3TDk8qLK/qtmOth3248qDjx1A2BVZMr/U7Pm6UL3rE3X/dRPfDF7nu42Ws+0+exs7xAf/+R8DJFQIGxVdeELODr5BoaYRqRGgW5d2rWWSYNMvx4ZucNHwV8Rx8H+YuSxuqAtnRhnZtQ98Zu8lMJdsFHyQ8N+VQ6XK5bNS/AgumuCdv6M0C+1/pabw5E8exWKrBkujx6q6zxuM+6sRRD+k6s2p6YUw1wLoSCjm0AMtWaxTpEv8TDA/uYYRk6/TbUi1FAJwMKMVSf98aQlwrUpTK1qRe8rM36o4kLOO5y2XiTyKxFYymMStaZrgJGZTJbPaX9XTJshW6R/4pVwRef9p9EPcxoobBwEMy/Iy2x09J3cAwxirbiBquB2qRSKXLpmvLAkCxSUk1mhCdyXGOi25CLcC9jsIwKGEYGBgGFoYaQpzymrVKE1LT66KpaqTlKNfKUa5x+zDG0wZXx31yjNtqgS+PQQwM/G5GgvBrwCeNuwVxMNe3PxdtWL1kEwlTphCOOdetyKWnAgAKo6+NFB4i92A7IGDA44nzMQyTfgsWUrdq8m2u1Ema4KQGP8Rrdd/TDTi3wR4FaSjicVMGRoy2dVJZk8+uSR4NIQ8KDpBLzUipvTVfn5eCqQ/S3wv9OqtPWYt5Vfmt1QZSZTwxBKdcRwxVm1AgjxXtmQgjng8zLkEYfunkGK2hBz1Nc476FxVx7YdrblRCamjpTS3Y13ojLTrWUj0uFa43NitHTg6Be7kwiuXq7VOKJ8rTStB61znT/krT+97xK6mZSmoViZCHShSVT7ozm4ME+OJqmegKGoiajtOQk2/F8XtbOx5IUzXkZ9Clkd7v+z5QyXktjEa04kNHJAKZtHskhEl7LkJQiYgEcbAunyVhxbZdCLP6nCjJXyzeo/Cz07VTW5fXMbmcnI7qeGICaGWx1uRrTR6XiAcqDLRC3dqgws3q8bSeUXiU9QRaT6j1eFpPTevBdNFaMFmOV0dN6xgb2LrCPHKeF9NPBw7ievgSVyEOGqtrjnEziGFHCNXvoxjtFG8EZoJfJOFQJvUehLkbQt/+qLaGC8Lye65rqIBabwSFtqGYS3hij6PV1bWuQOvyAZrYjjKq1FGOUOXmNfla0+jwljWFWlOkNflak6c16fBqTTq8x6/J05pGB7isKTAg1Jo8rammNWGAtR4M8PFrqWktY0Oc6BDHFZn9xyobod2Tej2qdhpqGOOY65SSRa5OXIWae7Ln/YkedEtoAWuphBKgo4TQ7p0IqX3TgDOJQhZVR50a5Rpfx/bH6vUnYmrQ9gf0TbbbScsX1XGtI5YKAEhCPbK2r0oIa3tXQlfLOh7yM4e5rcetSQvQmnLRSKVKsTqZUqLmuRR6dUTWqcHQbShwrMKPs7P3674XnSxUa2hGpMCNFbh1A9TQKFGUQK2VQK2VQK2VQK0dF6hhCdRIJUWcLg2pIHysRdYdDMuqVsuqulrVgra8tjkAEeUAJ5wSDk5hs2UzwP1c4EeG4ijowjHQVXj1qO+r0tfLccdc9IOEAaQ4exPaYJ0BXKe1eHmsAikFukg00CHMRXys6xbhobBFSGFbOmAUfQpdx9ESufyk56kO0rFMvQamqYUsuE/zDGDMUduXKmcXk2/d42iPdIfio0Ult0sqx9QCstvweVEX5S97oK3cQX2EqoSnB3S+De1STrku3CQGWcGY/ay2xZdK0YTvyOtiUAoGn1TmBGlY6MR7fvrOaBp+U1C2F+HA0OCuhMMXggYvKFpl/MDmStFNN1c7JYSpqZ1VtNLNAjlmTlV2hCjEBZwBQmiMw8qATF2j1WBM0VuD2f1rUZVO4nhqHU+XPqNkNcRY0+k4vfS6TE0tecF0QiGMajctXiS7ECVVSz458BTeZiVPFlw3o5Eh0uyV6m6/CX3nLuIklHHcY93Rx7h7aLxRXgYmI7uSULfKpeQ5mlOhLFRPrx9B2uo+pETaUFe4kLFVVzhMQvBGWHy6QvtCs7ItSCjjUCaMr9KLErfq/BYKOUFXVImg2hUpVH0s4wPuhVTlC1i6EnqRqcVHP/3Jeo5TwdP1FEQ8q0KX8TEtGeD3teSizu+yoJqrKwCKRTrkUKTTUM2QIkU6DRmkC2kz8BbJw2qe4txj2ls0HkhnupmWiwgeDu0gy9b+WewDikIz0lHO9CthEPDy5gyP1pzhUQ+szqRIaiaOIhVIlbMmKWdNaGdNpJwCHCDjodsfCen2J+jvVJ5gd9kzXVz0FDKqCKNjPFvhJoKn4DiCJ/9EgidvJEMRlcVK3qJeYTP1iBbHJKoVpfRMe1mX7iUSCg0UIu15VPY8QhL2F9P6LqWUs75RZTLNfonWqnxm/wo9DIyU1fS1ikQgS4GtGhh8loQWQNsklIG2lawmNmRoB9o0xmpyrN5GdtRLFar6iazzMhTPUK1F8J15g+pYoYWTArlRbgpolIrmv7vM8Cuhl0wSPvATym/4ykHBTipeA7nvyffWoP9rPYH43ymCFDQEsmt1T62svTJGOhKSJbZZyGTRyWa5/xhMC3jUsDLTejj6dOXHWn5clh9Xyg80yxQuDYv9ZNl6djJK5BtK5Js68FpkWXtamQ71S5h81kWvBSBReziwOqMgOYn+uiYnlq4pQ42QZahjS38IPwslVOK0UkWgVQRlFUFZRUMLbCrRC1FRHbaW8vrUgpXJSR2xSqtk6i88hzBUUijFE//5sHil9wIdooCGSBOB8bKsOcwBTtX1zr2dJd1ylizoPMokYhdOSCS0Uye4TETsLUPBmqC/vWQLQtOToglPUVCa5kCCuZSUo5fIDXE9JA2cdYUkfYs/jRXQoUVzdcjMrLCgr5WgTxAqEdKyMmHJyoSOlZnARoB+kueIFR3rqm5PQeE6EUEoGJIaedUGnQAXYsWFegUXktybigfqtGw6Gshl5fIgCTJeq+lCNbUK4DvFHM8d46twCGDCxeugcvFabXfodV97Np/7AdJVaqz3W9EZrNfZUBX29GPk0NJ9eUWFfCYs9w6qF6/xgutjoxevL8Z14C/Yi9d8FdTe4gqQIRQLC9Km7C16/l85/p+4dr3+mod97fr/vIvPt4c+7F1PKji6Ue77L+bx1Ksw10iP+VUsbmZ/jCui2Z/gFwooPKH1ZPeTEoOcu0diILW8aCTG07F7ziZHr5eozzf5QJ0qqtSvGlOXF+gS6Z2H7G3OH2hYJEYvAVXVVRkiUqQM8dDvwHmArlYtBA7c3cwiFXeplN6Op0cNzWdSJQ7TmxP4gQrMBgOP0HoSxKha1xyKCw1RIajruVz/Y7U1gc9d/CxtQ7qrlw1cvdzgptjblnLEbC9TUqr69tpOG61WUW1l3ousGdq6oFrpvikuLwxqTNVEjd6RvGfaHcmJWMw8Pc+d0RPy7A49ifu45/nT7kxqr0WBA7m1dg8wGI/V0bxIdYNqKpz13cVHTd5dST53MnlnJXlXNVmq7E5rR8tFPqCR1WsvKMz1+dfPSOdg5Uk4//ClAf+1rgteajteBMIaHuQL8HuvKRdbVW/pG6cQFpeLxHjfQWoTUS0kcj/6tbNr9739hkM1UULriyOqe+R96vwJj2kajP/IZ2pUIG8pirb1/nU/eSEMfeO+by3Aii5f8RxTG40c0QIj1jVGCWI2H48WI2uRUeuF+SxJg+dgAEa+hWcX0WvfyBe1jjyGDf++9evWRjrOM2ZfiPtzkZj0OwqTfki4iCRiSIvwK8ofRoQOi5/CmvgXXVJnigtMm9S76jxlYpZnHpx1eNDLuzSHDm3hB3d4hRYgPexxAauBUbrDvegIj25R+/ap1p+35ttoK4y65yRiN1CYDpbxRCgxfLiu8gO8UU6RqonlEVK/Oy/wuCTfMaVY4iKJi6Z8qwBjRbzyUKHKEkuUH6C5qwGW2TXjaQfW0EnfwOJq3CnSjSVVvNxOO9lDDtpKpyCwFQ0mjSTappHbUqOZyZVuQT8qFuUDmK5npzzFTtrOeYk4DCvTnICYLyLmfsSQZuWXwiZo1kyy6seatUYBfM1xBD+px5PpQQR7DLXrfriI+f0BvC8Qgl/hoIhjauoYFr51VflTXD9G1KVYTFnv5F61brjr956/+7/ee7F9MkAspPd8m32ijaeU0b9ln9J0RO/Fff4P2ieK4KZKyhUrP/CuY++3T5fyw1cH57x2y/p77VNTCtJ//MYFf4lz6n/44tqP/9F/vvDPPvMU+5SGfv62M1/72c/85w/YJ8CF+Jd97R3f+1dbf/ep9mnjP/4DH9oy8M74oH3a+J9/IJudnb3+Yvu08Zd+D/799gftU+O1peifLl0ftE+kTXibkh7TeHc+tufQBz73z3e83z7l0w+/413vf/Pf5U+1T9uMt3/XbQef/fI3fsA+bfzhxT/gbvzzU+3Txv9//+FDSwc+9B8/aJ82/pnSjZ+72D5dd7bD9LlnJpZXztuHvnOaofuHPuEV2x76ruLUKYlsmh+ozKX5Jso+Oft3Er596LtQKSRPwEWewoTCiE4jkk9p60N/6NF4bqOdERvl5X4mVHQVK/OqdaTbQY4OZX2fM/IjxkLtiGmskjjww7vwyIrTxUoP5nF+BiZ6Au3cM3W9OAsffko+PFtpL0rvUYBHm7+awZfci7PzMyjmPLuwtpxjdMBVS+gs0NXHYUsyw4a38t10Ns3Q4w5gN840toNXnpTFPMet5Rm/xv2DAQdbPH0fzwU/gc7In0hnwnW6WSnacEC9zD+Feg8DceghDsxkGaNHJWoN2Lg0FTcCnbygLN9BLabnT2Bi/kRQ8f7L85wKcRYR0ZZ8iVbyWVqV2iBzUzdqO2m2DJ9CS2WYKCrDTFhoFiFGp5o8twK3tlEkL6fSkjxPQ+S51g+ZnseyEwPEPom6RAicVybTPNugL/N80bhnQACkmAvFOpVxoTy/mGojASjV5cAkeuILKb8rnx32uIWYAFrXHNeOcrgCRKMEiXZNeBKdhwr0a5KPaRudi7htEjfgFlVL5FTJ1KVTp5YIxxLaKXy9m/sk3SDEkcTdydWNlEiETPxh15XoPJvIoeESHks0i8esnTc5BAy5zgkqhJcoaIc8d9AWeW6hFXmu0Ko8V62fgRkzv2he5hceGbXwaNET8HgCPZF2rzGuLvf5sUyPx3ePp8d9u4rWjZD2nP7L+EqHV/PTcmb4/15nxrdmxrdmRpBiIgQvyM/H41IsE8ByLuEMDiW4eZO3EMZU6KCss7mm8w+gOJ4REno8o+8enhCP4wmx+5FPCBqfEI/Lc54MBU+EHTwhttDjue+7zaSYozyPp0yMebDhm0yMqDIx5pX5ZmyJzKSYrUwKO6DzBg2IFJ9NvE4xi9zAbEHoX3rmc+770Xd//mL7LLaDi9zK3wubojIG+yzO5UTBLilZ8RDoqrHdyflBJOhIKLWcYmTnCmLL5oGR0bmCaIeH2putDqmpIK35FClRp8koUsMLD00itSLucXF7Ho95eIzChFLczgV380eI44/Dnu1x1KIMWPlEvD2RcTwDXj4eb4+n3XjbzahOQPU9+HwPnW8WAToL8tgngC8CcudZBbNXBLOfcIBrZexrMT4vMD4vMz5vCfYatKQtjLRJTvKsiZP9HbTAfVzB/pG7tZwXQE90noEzx5DJGSxFvgRWs4KWcZVeU2xQMFIUdFjmqG9lAKkkpTp0lvRWx4yjkYpt48mOGUZp1ozSvEAfQ4fn3OSoAaw77KgsAPILtEKZjBzemB/G2zKPa4ZhbeEDJkf6wZl0Fp3zgoJ/sOV++Zr63D2TzqGZA/kM9o0M+Zh2gc1mZ0r4iM4omehn5EZ2UcD1nXrrRSjkUEtCMM/yBH5GL4LrXh5fxpImVvsewhA94ACzdcAUWCznC1XnvvAl1cNon0E7uLecBAdlc5xc0LzsYFVsgBKZkGFHa4eVasIjFDlH7OWxRQQ+qMk76Ujncn6EGBlzPLfqKlUza3EuT1lIz9Ud+dUUYNh1o6TkCB+pl6mAunaJxvILeqJJOIMFTZEt/G5bhN3hc263ue8aLMJs33R5BpUQJ1cB1kb9mGS85lSIhBNsAUdYcwyEYJqLoiVFQsIe6qDeH7WIpt7tqWcVrFIMwzKGoS2StQ4PRcb5WnnOS0LB820HLw9bVNQgPnZphevnVW+KMb9a76EF7uAOZFkVCJNIdiiWtUjX91W0WJcGkf5QLJYjFvlTS3hZLkNt4kq5RFvSNvlWxvJUWryVc59mcgP6dv8Y0RwIcJdQFSay3crDF5jyK/hMQV39LDer0GYj43IWyHkuCEQZOU+zMpnx4LmMR04FHiP09zpMVGvmSk0W13S+rvRlZi/gwbSYiUQe88OHz/BYLjSaA6hhkrRZcBpd57/UE4FpYI8j7u/uH5GUFjjXMpJ78lmGJCdlsZpJzevGxK+6mVSjJHrftqFS1SaElHq7WASAakOghsyUgCbAKKjaPoDEs6bctkUoqbtFDQjbDzCVgPg0xcwPyYdwcgYPMFP+hjg4nKVUpv8c2siAAXAu63HoqNJktls3j7JpFh66iwX1yrg7X8RjZ95QxSTIwTJY8QghJaWGHFLzKEA8aFBuiZame/PWaao6hdOcjqsby0Uyi8rStBzkyyRZpiVGDH7UxOM4v0oELwE16Z6KEOFvn7iVy6gXrzX3ioZD+WPeun7ronNTJDFLhlbgebl57jXP3Xou3KVMDW6JFVtALoAnckBi0tc44yfiJzyUg5zLgtyTCyHtfBENkjY3AO3VtWIr6A/3cTGv6WioWkcdxELIFXH/jTjWQFu0PHKrgOk86AIyXGJNSlwm/lJyb6UlGWEkSoE9gHlFJydczSk9kLyLmEmLajCtoXAEA99lhFjbKLbdmm9HR2wjGzTzw9wNKbXqsJX6nuuNaQVRIHbDGaleCIs4Ock4y8EEB6Apil6oSTY3XaiL3wLC5200Q41rekRDqlmbOtpQ9ckH4S0vwWjsWt4lVblq9w/KIcSckBGmNCArBc+bSy06de0h9e/zoB3HRP+kLf6oaos/dsG62uI/vp39zW3xO29I5MlF4FgdHZWuf5K9QxPqskvhQRFN2uX/NPriXTvl0iVOdx4YPd3xv+BOcDRJLPp/RQ9zajhpCLT3ofocTvr4wp6uB5fBtoYe7r1dzd2TV65y4I4kd/bLehUXg3eXV0TOk4ucmOGyCPo7xE24W4djn1XNo2jl6d8mQQZz2tdVrvGE1V4e+uXRXj7oeqlJ0ssbEUz1iztGvwgG8j791Osw0qQ0/Sw1t8zJgwkWtKIco9KR/a69gwcD+JdQD+5gbFnn/BoYXAaFE2+4zb4n60dL9YnMMTJak1Gr34IUCFUL8+JjbRJNQwU8zpklMY9UVWLfj9x08dpfP+73CR55cL3PsyYtedpRU9ahVOSxAUVVw2NipFcABnuAL8y+rAa7MSoHUQECklzEYg4qzt4KWokqMPHjMp3E0zOWzpYItVviT2HdDv5RG1BD/j056G6BCLXsCXfDuHlTmu5xQmrpRkoRIkuPIiQX5xm0bUUpWtNlOcln8FiQM8WM6vksOGrIwrHgAcQgchqao4yLZ0BbUM5PNX6+ICtGSHjuNk8yT9zofMk1TEZn1aWdnimKQnW2X6O4rXPEf9zWBD4PwAst8gm+EEPjhBxnZ/DURDEW4pYuoAsy3Oi98LV2jVgAmIRqpkI1NbdbMuyeSo9ZlemgmiAgJc9S/RbUEsn32B8FlAkD0iSIj5bwd2lvPzhhirip2ikcVKA9lJbLwIKjg17fKxuqkFGbG3F1GfDEX4zILjnAfW4pP1QjMbvWoNSuB8vowByP/5KU6IkvR4rELYfzCaR8otnXScea2icoiZLH5EXXDmuqzKwds7imMEsZ4jJq68IXuhtsMEnhO2XbERPLOOpXJ+z6tlvfzrIGvDjqIkXDQFMysdx1EZSsEDrd38k0VUNsNbxbpu4pQ0Tw8CtOf5TQvgNUUTWYLlKrA0fLpr7hsTQnBoEYh73sN0rjYTg1zb3Sqth7y4Tcq1hBINucX/NC7+Uek+rSjaJxCHE6/Czhwy6awgib5OrQrYjxI+R5VXSKUxiREfV/fgQwpSwUnRQAq5qNyyPE+fqd8Y5fY11A9aN/VOx4yc73PtFNInEQLwu7icL9ZD/7VVlxjvpBHY1++UkZ9+Dvn2+te/zMP30O9veyd6rRi3EjH5pXdGOdoY+f5m8o6P/Bv7wrdGY+3oUCigB1ReJjGADQnXpCMeu8Qw9IAcF0EisEz2bdbikM5CsC+khotYzbKeqzyET6WMUDkRHgFVfgFVCkwJE7jdmv6Whrl4Ls3RWzH2r+anPzF//tkZi/+PVx8xfcmKr5D7yNGcB4PqO/4q0ycgbvBbXE/E//5pc/Xz8Msg2Ub+bDNBMwaqSLwk1MwIxaG3nPyVgbUTsUiiXODIV2zNih+JIX+oJ7Uzx3VW4NqO4s8AFrBfChrkaUgEpQdwVuGHP2XfDf6pIg1mtV/VXcRRHlqoaqx1oz3AlFSGxYSz5aTEPzBkCQqIogQI/coElhnGDpdRcuBXALKxpPksnTTCMesr7vpI2EvOvlUqrvSg14RNeK41gKeZkwLzJ46EzLTEaJANltIc7XHL7JgbcFyR90Nf+CRIDQdE0cryXqGVTy+iYvw1IIYP+Ymg78E2hBnxwZud+RkTcOPywI8r5RMuKrHKLu6Ak+UnqSgAAIPfkJ/pjBcugnhkpP6tn7R2wGGXIeqQ6MMfyTfcBNbrx+sDK5/W/E5D46Mbnvr05uvD38yX2YJ7d8GGQfeiwn928+jMmtY1ed3PeXk/tyLrM6iUNz3TTUMdERyfkdzyK08wntz35LcqA0N4nSJ/PMcRMFpQK+pSNkBsha4ZtPfTdH0N30OzxvE78RC2tjKpuITMZnnn+SEzg86Qk83ZRStY+h7WNywj6imPRdIZtTjEqBX61yzRQT9nn8wGt2fnCFxjyHFJ8KXNeXsGpVX67hhEJsenC15JkCc3Uap55x9kkRcKmhxABan8TT9QA8vpQb5KlWnXdBPT6kCEwBs6MHcDyZHHhB3rCUAjs3iDzwd1kPN4Ox/6vjJzqwtiHseADlZ3hSoiaF8LfQIP6T7eZ1knDVCw7g8UyxmnMge5vCnxK9mC3XPsQbZ6bdbm6sq8ObVF3gpCj3wIYYJxapgM4O6R35FWevzJhm/yjbRnG7kxStSiKEHO0jw2IGNe0uOtShmSt7qAgbzjaMjXc5cWY4HBYt5NlVtDm6hTzcCijvSg0Mi7qBDR5daRy4fQ40D/S97C7BiJAamEma0Uh+BFLorYzL1zBRKXBmQo6HNd/CGsgDvmFY83uv+bfGmodecXJYo8SrijWX2GW9Hx/AUz5fPYCdlLV0grGKqZ79PrrZSSfi/wDx6ScC33P2Cw6y9cK6vX9MLPC7J6T6FLEEuP/7QgFEHpGv61wdzFqtvwH7x/xyl7+GGhkIkSRlG+hF4cFipWhHe9l7EAP869+vlqoQvCeEFjd2r3VV56+LGZCuTQRJR3nkoTOAMdaOY3YPQ+rhS8SJcgWLNXVxGQvtezDkex7IiPj+6/01SdP4o9fb+IMj8epmqKaSsRouYXLP1dQHeardvwvt0VHS2IumRe52kR8qI3dOi+xO+7w1JbKM0UbWefwsgrw+csvkYfjisVfJ8NXrPX4yyTiIZwwfdQngdAivIcsq8TR2/QJMTOBWEfPUVPkXt+QlKAAsDZI5haNehEL6wRqfCp/nX42K+gF7DzygORlP5QrY8yjpfwrzg+IDeunFUpBVdba0+wBFIhuKxWJe7qkfXit8Q5oa6MS2gTxpnDCYOrOsjVQYvkXrPa5VSteJJf3qFp5+5fUKD1ahZHvy3ZSANj6TErhPk+L504ZUivJBVbPPgSBp/kskP7RZ1bcBeZWJWATSmiD7G/1gl391Dqg2MGTcCCBxwl/eXRMLOYkWAlFMovVDyoPgFxDcLcH7EDxLgjd6EOpI8EHEkgQPInYVQfUX1pXgAwguSPD1yJBJ8BCCCYKgKoYVPYC5houKH8Ekca0KNVYXL23gZGyjjFH8TBjvLDZ+KZyOjQ7tpmPlKDbGFWyMLDZ6io0YccXGyGEj4yGwR8frADI5BPQomoqAPG6iuu85nAtFZFniXGBwjkGmOBcpzgXAucDcVJrEObMeBb0iOC7OeYpzIco/Ps5hmajinCet8ao4F3xz41xQwbmPPsY493ivFAQCCYwXSHUKHWR/aBZ/pRC6wTn+F3805Ys/OSfYxo5fwnL99IV9c4dDG2OHQ29zxzkb7nDoXZXDobvGvnif++Iu98WHy7OgRG8368d3j338Effx3e7jjyGoVoxwdhGXIVU7UG0D0guGwCyElINBSGpVLx8IZQi1y4tdMwjtNIzXWcDnjlFR8o2FZMTNvqCYo9kD+3EyMq9uHRdekC8KMuvFofn9+TJed6PQLkK7ENoiEics8aJiB00m2exltIUimn9h0aMeLbyAHwsH9h8oVlE3xyzuZ26y6PHbfmzFZ6mLSzz7qQPlA7h6RmyPVmgZUo18hWb7IeT0Ph4+RSIpURG+4oT4fM+34nFuvg0Pyrfr4Q/1Berq9mFlLfs7yd+geRCLvCc86hzCUClpc5ASWjywRi04OckXaLkfXgoVPNj+Fp0vlFbMIigFww00uhDJFa1ZOZ3BYPFUQi8iNDnidPVKaRRYqIfT6Rla4CNr1ECrvbzVF9ySj7lq9bsqMhR4iCny0ZPT7cjF5BWD9QIuug/Bw77bfqR26KJ7z395XvBnpKfMSEBrpfR8zvWh4fqwrGbIwRxit4ChR+9XxbZpvmWS5cx3MEQ6RiOgzzNNuMwObcGfeF3IM25Cg5YBnS5laopjQSzKLNMCMG1lTXu6VrAnHz/LdxKerIKoB0hiwapH/hoiacdDn/fyHXpqxPqccDQHsKoDRl+akUfuaEy1OXzUgEtwDR9qbKc89FnvoXvdyVgxS7OS+VTaWU1SVSD1mKu3aqze56KO3xz6Y5sYSeUEdUV0g3njjLhlFRMQq1ocoTijYNbBPfYOiaMjd3RWmFuMAe1QPRfwXtcwiF7I/ireW0BLqqD8yl5ejMwBdSGUp0h8LpCD5+sz2h5twxRdVi+l+ZygisAtVe1CwaFiFVjkvyDfovjSE5rDTKWu3fmiuRk6Rsk+5SjZfY6S3Ytg6pDNN4oHYx9/wX2sSap4oGRwi6g6mbP8Xxk7y3cfapKe5SOY9qVJOKU0Lov7Uo30mjomzjhrL1YApRVgKSxyMhE4YPATbZeCoLkNDSDqYRM3z4FFEASMZJL7tGBmum8cifiwxuS72b4C5OoZhgORiUWhFT3RfrAkSkqRZKLjVR1WqbfcCM1BTsU0H9gtHQDF7oFic6vk9mNtlDZKScWs1K8lC5PWB/1BmQAN6HgH1MEDmcVwz2oP6w4IOJnO8HoQMC4aZXuKZIxizPPA/Q+4kJiuerXDqF7hebl5WjzHPj7Dn9KNLUI3xLdZE3dJFw3dWKRknG5EQjdOJTyh76pUQPynL+ezFWowa4nAjpGZrskZ7aBTy9hMde56QlbquBLBA9pzNMCqR3VpCwANDfW9OuclvNvM+Y42kOYcHZCw0ocM0z+jjvE2UhkSB3vQz06/w36VzDBBtcqNxbwbi8WxsajpWCRCbOv4U8iq5/h5oWLTxig/FWL6jBawFC7mEQPRJ0bG6Xm59FPJF6jupBWKRoi5gpOHZgcZsm5idtg5ovgqJ/DFrIHoAiB2qoHmDoFaXYw4VyCVL0yFQW8MBnWGwTWMPI8IHxdpAX8KtURg1gM+ZpQwaDA/USyWcZoVOyYjGMkoEMrFZLwQv9xjXzLcm7cvNX45irnnAzV1RY2sjl0EvyS+4O4OWGPyEIXX8SUsMoqA1iFc3WJnYrHzCobjbtLw5Rwm2gxrF1DgAnWq/r3VskGbVmlGmSRdxpU2roI2YlYq99Ql/rikITx1FvKe6RRYOM4kPu6KAsIsZCtXtfyqHg7UDPHyD/C3WPmZxummzc49wz+lwJ2UZhA5Qy2LG2+r8k9qYQAIgmiZTpYnWuiH/IljhLY4RigeQyOwKuaS/7VKipIxpgfsIv4u7YkwBEsXbaFY2B7tpXCPPf5slWICSlWw5fsZDf4rKBijub44MqZE3zE0ZBkaMM6qIr6D9AbZJE+DiadJm/I0PYCvZ28KMzXahKcJGG1FyQBhYwGWViZ5mgSFMzaY4aAF3bgtOkAvbw5ogDWjRcGkVepyCJDr6Y5Chm6ZoAxWYZZArAQqK1YvO6qkwuooJTJTC9H+AUYJ4BXvWHuocIsmlIiqtGiVeMhVnFAAM1cAqxXDbi3ihemDAE6ZrRptVcVwZba6jtky1ueU2YoNs5VOZ7bmDbP1k2PMFt6V7dEkZbYQTBXBq8zW2MdfcB9rkjJb8rEoQ+XLhtm6aYzZch9qkjJbCKZ9aRK2eAfMPJNqlNlaRtwksxVgNwVmq3FAZ9Iq2i4F5R0hKKvKbHU4ILszjMli7tOqruXu3J0WzKhNMluLiFy0t+Ats/WTJ8tsIefmzNb8CZktHfdIz0je5+FZ8lYBjHtteFJ5hRWTGrc4WABu2HRK2+ZlsQPMi7myfcXCxHYt5XvEefaIFruM5vF3ac9SrzlaUKOoHSVdK0K6Fsppxvn0ipFhvQLHevHjfR5Dpu+NsF++bMMqVEtJ0yQTZmMzmhUmjMvbkPKwmtQtI6aT0WzGsOWsMGKBW9KUUC1rc6nriJeElajNg2bN0/Kl5u7p8tOFz8oc2Ocd2FdHwQ6s5dozNTODPTPxo1eBwYpZK5XtWp0kX/4E1WKiQZ0pVEtVxI9LtMCyVCkW1GUrAGRpSr6g6vZG33G5yn7qPHRomCnRFQZU8dFDbxxgtjjAzE8woMBHMF+OlQJ2rUqZW2j+BAzoKriJeWy1TsyAAqMcAxooAxpkikqOAbVqsVUGNBllQEF4DAMaKAMKbFkAhiyUGAK6NQUGkwzoAqVgwucfyZwEsuBPobYImFkGdHEaAzoyK6vsZ1BlP4Mq+xkY9jOhWTMvT5YDVThuzoEu2OsjixUONKhwoAHRZtN1Fdz+qkFMnY41oK6D+OLm0xGg7tCKTkez2VmcNusymaejsy5ifJsFvsnM83XmRaMzb3PMWahyCbQ8jYGOqSlLgFv6dMrNm6UvxtLHzVVeWjBgWT9YEOq3uhkvzXPatLHIKafiys1Y6ViaZZZGy0qrXTnre7ulWXDoauX2/3Bm3OU7JZ4YIKtbyfrAG5Os3zwmqnm9vIN70CTlHm5C0F67GPviNvfFHe6LtyBoJetGiD/24dvch5qkQvzyw1CIbCm9jq0oPK9b4XielBLtRik6b5aC9VTl8C1d3NulmH2mFMx3SnF8Voro1Tk3QnNVIfW8CqkX5FuVsS+wVj06UWVRKIPMmOZeUNQOlJeKfWjlH9hfCGLkc5QSN+EAtWiZ2si4JjLrlF8Z4w7sz1sqsr5TNsu+sIoSrOnFI7Uq1laeHxfHnNjaGPNqj4itGywUz7uU0RyuZjYpBS3CsOmnVsTmZNa9UZn14jSZtV1tpZx81Ymwt3IpKLbYJvnEgGvXHhDkM65j213HUvTIXYnkcdkGAXY81VRaLnxNRjH+1FMws+6z0vztlHKfifKC/3aAaKxQTW2tNKYUVuQ74EWeGEYoplnu8OaMZBtPlWzXDLjnrGQ7h2Q712txbZVsA/JieYNmqKmCq1JEjUuyVMqy8x321l5Hx2iWCtnXz6r8xEqato0KmreiDllCciNorlUFzT3ayv/1WNC81Vy8rQqaeykSRdAcQb7v04LOAYxvMVOOcL5Nx68h04dhi5TaC/LWwxcpPwI58jZxpfaI5cg1ak2RI8djcuQ5AGEOkw6S0rQivANVBzqAqmccaKlcpCYMXpq3ZcI56XETC0o56ebWijY1DLlG5Kr1sD+3mfTYbWfaLfVzPC47Rp+k0Uwq5kAeuE00V93O6FDrdqZtl+BE72JSHb+8m329m++68zNco8Qr16jDHsu0ddN01U3T5tg0bVGMaTq7Ca8EHD3sGWQ9aANXm+cVBNI4iz+WwdSkmTOypDZB5lZIZiIGB5em9byvIoQB/bOTUsUJtTXQPZSjEhnMENBBBVGG2WA4ngbNlcxTbqcUnCNRzXFPuSl1nHkaLWoOsJ+jls7iGWNGRRgnfTmIFzIvV3M4k7ByVzV7oBTbYYuVc2o6+M84+LfGyaQIX5oCOj0vmJGWVAiGksCmQGxujJBQSzYtwOmt1Cjvs9LcuMBlaxXTgOngoNrGlPhWsC2GD9Frf0pePJqX020lL6kjL8vTycvswxeiPALJyTJ6MPOIJSc1mp0iOZlB3AR50fuhI5uzJSEvHSUvS0B9ZRJqlJVDUbPyEkdekknykiGSJxDg3qG5k5GXtFueIzDIuSmBmT0ugXHyEixALdUpbZGwCG0jLumq8UAjLclnHd9ckR5tA8KKxERnH2SdTbdl2K4NnYb4GS1joxobS7Irj5AAxTSLP92uLQn70ALt2QbbIh1zd76DW+7VzVpNRCgF4cmbL217rld0RHygo1hzIpRGKULJaUeFlGimDNx/RYTSBkcxB5VVFQC0qQnLKEK4lGfIdJqt0hKGxRGWmiMsHJ7R1tJKKUHRcIa8UM3Arm/GSlBmVIKy5OCfbQp/UHzUriYnwK0RP+YcBIzwVJAgm0KSVIBSjRRaNGtoUa1ChZQmjRKhZIwIdZQGKilqAHw1B74GzWBPAPAtAXxLNOMOpToOMZccYsZKS1WGMmNkKFXUXHGgmR0DzaqiZqakGX+lhM6XPeB0GUquW9yYOtjWzRrizLuW6Xl1t6tSOZBui5tzFRlKQYxtNFeRoeSWVdGdcAWEIEbAlcLgUS740gSONEscmdr/ubH+N7n//+OR8wSzyhMozDKB2BymZExwfYLZgIKxglN7fFLuNjIZhEnkMhrO1E6ITlgOE9TPHyMGALMVZLlpDxWQVuUCalUuYOpkdVyARUxru64xdTJ2pkzGJWqYydg0k64zOelimaWVSOrkNUw64JpMPF8nXm104m2ONU2dcoYszbilofCVnLR0frmzghalWPtgykv4UiGvekSJCSZtmTMj0qC2E5hs5cpso0Q9basKTHRtgsCkDZIBZizVdhhjYX7Fcqe2rVyWVtwB/ioJ3+tVViLq2DUNiOZ2CSPH+ZE7ys7GxmWJtmEmbDeL1PIjnBHbaQV/eqiNJTOiDDOiTttUdQ+mGmZBZrGFbSh/rDPCN8uUX1mmRMuiM7JGMVOhm1WsTtieTqxO41oWGCGfUrc0ldBeskvTtsrS5Few3UfBsbaQlkstCw1nkncFs2GFYkem08pAuWHAih0rkcbgKZF2QzO7+dCs6NAAci1q4k/BCyQRYB6XSC9RCszNuOsdBsPKCYh0w3dE2gkXFKSWSDtNiyqRDsem2yqlSqQVorl6iwK0mg5aE/2fSqS3Qcsie8QbtxR/CrMWIKZEeola04h04Y8gZYVM+xUy7VfItK9kuqM6FidNowHAE9PoVWpVabRfpdE+0WZYm6qP+rhK5JRMp0ZoMKOULVXKhtGiWGmHUrb0OJQN2UoZTu+qzUibklgrVfCtH9VBqa79Pyp+WsLztDsXBF01uACPN7q/6F4gK1Bk5ty5FV9wO9XbBnmAdXmdC5eUnlMEFAyz/ynXjmqQNcPQxPV66zj9fzxviu+ogDzrQ9Z7xoW1Hod8dfYUyHXzBQnhdDZDw8XKUvZJvVnrjFL8je+F026r4r/yxqpe9dVrexFbSdEkvcpXhBx7mYmLOMuL9E5wAL8+auANTeVmiKM1dX3EHhShbR1i7gRoG/HcEQ8tHoXq/ebSnvHAnf2pXo4WuyGb1xJqLWiTXjjQH1wmL7z90D8n+SJCPr0PoaZIMJzV+9AeRsz49gE8Q8A50Yfz+5N9TL33eSkaJNfakKZ7tLBqpqmTZh/Xm+vPfSRXwz8xcTUcVdib4XgZuxj+ZKnFXo/SIdzPdnj2c67j39qevMyut7h1yKrXuNEIc4v7ezx/2p0Edb4oV+jPrvEbzyfrkSoHeOQgQG973z3l3sIftxs+n68Ees7ycv59aWnFaxC4SSA4fyjQyfB6PHFsIe0rQmFo3FnyDxTxhbVXSx7MMPhZPeqRQW5Y/EfoRh+/8BwTvJg8s+f+sKfnfbhtnwgXswEUcjdgKdCLKDXNR3zj/pCZRrit+byiIa04eOM5fUiJbTO1hY0LgsNoVUyNfX/2sj//h2Nf+sCFV3L4J/xdZ53xOnr6VS98IXMGF9Y+yAOGi50Nakw4TrrrfcOBViL/ngt2i7Pdegv+/dnFQ2pQBRA9mEq70/R9p6JKaOw2HiiSst9v87Rj1Hw7hW83VABfCHyba0z3MNt2kwSzP8NA5qG9AAtfyUVK6csR2iWha3/j9iH6e4WW1ZRFp8n0L3s1SF8O6jUyLPUTDstdDO76yJhQiyLT8/dcPBzqkGR/jsato+PPURnV4B2ljOqoEXl/GKRETZ7dLKnTbxofQppIs7QQ6yvIFShFbGxWRNHmQu6whZznH9Ng1e7YXRpFnNP/mKtOqxDh2VGpGdMeY0u+diL7n+gm2JMP43VD9Nc86A+X2HALwwQZJP9G0eJrxPsEZz760b6YR5sp8SvbOwQwhwNKNoYmbufe4ZW5OB7k9nxvX7pBoY64T5Ez9tbnqMNIHWL8E/zUXv4ek34RjMGd/W2rn//L81YulqyDT1x/iMfHoTa54FW9Mv7wXnLBK3sP+jD/QN4lPbnKW/uOXvYpXeKIJ/t/pABQ+x4sE3L/vAriS3T27tXHHn3sVudw9wEBIQzFM+i/OlCfOQjv4eD9GsSF2S9o8G1Yeu6RsN4O+5SG70T83RLWq7gf0/DHET6m4U8i/BENH0ZNd2n4g57BcVWhk2kBApA3tHG61B/CF2dJ8B656+vq2lm2ksqmr7omdhHUy3bKK7weRWWuvsQ1NZTgJ5TGNUoq978AazkhRhP4yCPQu4ic2BA+C8QBOXFNHTGgh2czEdYFQWn1WmXI4YMq1Uwf9DSTOJVTcmk2qQAAC+7VswqaU8N2GvWpAMu5fxMOLigX4n6SvQELW15TUFMj+8sblSH6qdfxsqex2a3Io5QPKa/GgvgmiTOx2ac1B0Pgx3Sh7GdasiXHF2Ufv3Esy195nv9yrNpi14ACva7tnx/I2n1+oBxE+LSLX11Er6ToZdBV4NfrXnktzGAiOn4lxS9Ts4n/sXd+sIuk/OoHHgWbf6Au75Hje9pMoCh4WR60dCa/rOBYSek9zbs2D1Jt4G7s6yU74YPwZZgnDEflPV5WcBrS5SNJSm/xfI/vG07xPyf2MslT2ynq2ZJ3YbpOggVOcn/TTP/7NWWmoOoWLnDr4O0mGO4dwlipSyh84vcre+kfeo7TPcgsRGwKiUfYgXhTduBHeN0pGuXKE09lCGIsX3gkuFFb7wM763hZfUZPP1UXvNgJuK8iLQ2f8VpIaLGYvfbsuVGYvVftWnLLLef+cs+bNIoFiBmmNfsL5atgmu4eDWKxhtk9ZXnD831YUVTvlTilEfwr7VR9Wr8BEwxM82GyomKm6hLPYxOxlt3j6v5SDRwQmA90IfsrRLTd3KBAJwXG104KCtI//yY2NysxpWnOigWOfogieqBD2EtuDNenmp/9cz/wrmu8fIo9IKop4GsKeO90JpABHnsKsSb7/+s9LbsOuxZrXPZ7EPG08FWaa1cR4kHcQEao7+kVdUzSiNPzRJa07Fr4NJQCEpJMKLNocmH89//rcXbOh2rzplSrxlaxm1abh5wBLzA8+b0omkuk5vfk7VSSY1TXoGaZlH5P3kJSm30UqmMrcANqzjFQ4uZn9wEjpPm5Nh/AxudFNK2N36s6NnmASaQvvkPA8xj/q/sZuwPSnaluayYAnaZnVz8TNDB7IUNv8G1Nv+XcHw5DH3sQZyedHE1TfNXDFKzVzp9pHmgV2PsoCifA3IAhpAktuykyDJRn2Le/k0kkRGeBv8Czi8UNgVUOZH+vPDbeMwovrKHpPpZ12JjL7keqKTKwuljZF11s9iX5PjJvX5a3wLx9Rd5iOcw8UzlgYRSdstThOxEMsTBd1tsorfnaKfKdewf4Uvhj2KQYOjKMV7tZGVw0HEqEbD+057rCuzb/g1KT2zFvBwPMSmUyDBw4OsBe4crCZ9xXxsI3jMJuIRKp05vCYNRvp+hIEZWGgEX9KiY0ch2zRHTQZFBAEyJdGaOy/cIYaxdMDBe3joXSK2UpaNHkxuyi4SD9VR/G2jDsuJNgsS8ActiNcq26Ua7pRhmes71UeVihU6plN4IcApDsHwEteTfxxM+r8DEgDFMNiId0irz1wtv34C9+8U+e9YOXX0wueFVv3w/Jv8/y/oABeuJ2oRmmaLfdKjz+drStu1C3Z3UMK/sUVyBzdram3iW5OEt+iuePzlNf56mffUY/RZym2gkPL7NHdN6eyEza0ZfBTNpnp5pJG3qev4ktuDv8MYNt6of7Nr8IpHVYLAc+Bc7frWY4VM3w+ikZdmt6kN36Che5y8hpNLJK/B4mFXvVY2kINyDPHnurkYOgtID7OWcBV1nIMQu4b/W9+knafwx/xJp/RB4PFY+bjy0CyCOd6ViID8UIFT/rznjs34zYe3R3HqTxWBki1Osqj7ng/YL7MiRYlQKVF6JeGJ7EFy18KaEEnKN+K3aNQ/U6HjNUUYnUoJDAA2nZ5509SeUXvaq08AuPQlr4txPSwrAqLQxPUlp49aOVFnqj0sLQSgtv9JhtrC7JIFfg7O/28HvM2su/fG9JaZmAqkjd2dIvA9lX0V/UKrb0/TFb+uSJNX0f/9061Mxo+HN9n4WK3IyzYNdMdtUk3Ssi8GExxS8nDu2R0LUIUhm5y0T6RoiX/ZOuqAC2RjygFkXTCzelYO943XQKVk7YX61O2DFp5wJmIA4eRHlaWQXDEOB2yzSEUfYLhtUwsQ5QkP2zpaG7tIRMS1hACaTmbaHnUQoBFtYUgUMUINz9v4yeJOCUInDddXRXcJtMqKv34WFDg2TAE9m7s1qtZ+iz9X0VmCMYZPpGlp2k3x+Av/Ovrdhrt1UZAlkzFjvBdwT4mkvj8O1Y/Jg3AUcOyo6ahA7iO1NB+pEg9uxlAbcx3r2/iCzxU7wvYidzUxuuQJkDGwNFDbTjQFFXKRz914H/tKuqSgiJuthRXyN2S4brUIrcWcn2WHt/jRcUzbfj4Cp72Xtkk0N1GDo8sF8iuxyZUjrkDVCLWs55Qo+lhdDcXaeYf7IHgQJ2Ll4H3R6KYKowvaWM/IF2NQOSs6I1kkyoiLga1oeI9RgnBv+BzTC2LgzVxHr3V7c2FYjomV3EMi5rr2tEyBPBqmIsMh687Fzr/8brmV4hXqU8CiRN+onrnZxH41XMA+pot6t/GYcB7FHzWLrDCDuUznPEoaNM2A4HYHDVWN/AQ1hWl+MJtN/iEXPmEARUZQoRRSoXvIIDA06NkJr97uu0/YcO+UpcYVHzRlQaI44BhRMRfqnh9cEUBdVxWKKlqLgbsaDCD/gUbWZG0Vcr6i/RnFcb2+pojAfbaKMOMw56mg5jaZL/cn4QpK3y2KuPPfrYzY8PcZ5d5kn6yXO0h3JF26DK/wBqMUjN4YdGMcuqwQHznY2+p6JfFYnv++iTr/uhNw/+8WK7B9m7dwgNC+28sp9ajaKARuv2y9t34et3/+WP/Y+nP1UPXHzyy5gr3Q0O3YutUIS19DaA9bbAbMG0ZLdXiGUPhujXe0aRCKzDFUWMx1VFXRSxQMw0BGLGj9w7LkFLLUFL1cgBBZJLJs8IOeQJXvk61q89+7VHdaPIg7mnBWAixkZZNoJZU5LRyO7VblCkBtJM7KfL2HsqsX+tsQLYD+pZNrLcGOiE0AThohEu5VpvaschU8o6qObLrd3ZIskbMObG68/ea4qmZqVm//4AXM9DsgRDaSra99GP4N8XLh5y6oeRitXqPbcPhZK53dlPfeLU+9JzZp86HKicFTlgIzW6ssfPevY1wYQZ6LNlX5dwBDAinanTRkBNLn8DXXlXAKrLb3dhUjFcMKmaT7vt89cfvevVX33T1xih7whohskVfmqQJOYJPvbXODO0YWfyrH/XA0x9ROEMBX9dGj6bHXytdlMOueCjUw7jQEfmsUbPwRJesaDuWhaQEDo79Yxiqi2t2wdJLaoxKaqgeZqhlNCgdzH2Xo8KTfNQpVTYkYYXc8YTVaKdmUNPntET33tAkwyeQzKqM8LhqiEHbhb52mz/eWti+aJOi9TCpjQ1xS8IAKjF8Ujp6TY+67cua6PTdwasUyc3vtuYCPqRykSLDjA4EXazjUpEvBLTvLjamgOsZnGRk2MxblcWs1hFMIIciI0JFXMlMVHJX5v478oedfj1yL7u2fu++1/yBsrvHmDC8488OuuOkog4oIOTyzsCmS3z6PU8eTh48Ci7DGUrm9vix0z2CsBVOtfmNGCVFBFC2r6EnqGvYFOH+bLqDJruZnqcYrubjXR34WF0l8fF+Gy0fY6A7tyQot7j/vtyMO2L+Idqyg0nfU83D3p7b4Z8inU25F2ahSFE/wAui2cMJM4sUOIPgGs8LdBGvtnMa6vBYJ7uNwAOuMvpOxAnFr7FigXx7r0DSMBvRvRG6R+yKk7qHXkw6IcvxmZ1Hh6LqfrtQNKk8avUvd0INr7Eq0SXtlCXuszZDODkE9u8sqtG2Fwz/eoffilOtfMwxTfr6AqFEGgu5aHzaBgNaXn9TQ/GyCbpGT/4CyMR+UWmQz6ua+zkhSS7Eb3HukzUpDqiUXf2Sp3lp0M1wkxepO3O61Kkf5atru7EAzKbRyKlFihDm3ITuaGGl7Nw3seFdSS+Jm9J31KbWWBsot4/Q8NS18vXBGtEQnU86jyXCT5oB2reRJ0vN9X/Bd5JGkHkUwfdfRX6xcSSAQDJCdJW8dPdjw2hmM5Odbp7tAAMX5B7+HkGSyUyHYGwTOOA5uizoYNyQIOuJ6brIDrA8Gutg2puhAJnhuo4B607eQv3eKbfUizV1Qcxo6+pvr5axqWhiw1I1HPTN4fOg8VRZwrdGTAnNWDe1bcFfWupfW8Z7ENKCeSFW6g3mI2NYME7sIgoLsZwipgTCnEJusEhktPfGG5JmrCMGqCD5+qp9W5Vgzmr3LtdhJCacNZpr9djEvE+VZeFJHuNzsiAa+OcKk4IYLL5tUiQeOC2VLCKRr3Nx+8dciSmzTwrr6N4BFkNIlNZYSxabHUKs9ehIBQb928yUa9HVCqfaKHdZ6gwQ8RzkZ5ih9IVHittzxukPSIUCt13+80WANGRABURaHaGn5a2UlgjBVDNAUgBhxpQYUi+VvRjqMglaOSPl5FdF3lYIysup37B92KLH7vdqVxIAWQYIU7RklKHDDjhMXzxQ/v5Em/2yRuMLKEvzcSpHCfj/O8trytvQe0sYiOYQkPiqihR7udXklerybqZrfcPyATCnH6ehBoCo1jxQ/fSpIaPPGooE4lBwcp7jfVB5sEv9EuuWRs7eI/VuLCQB8xK5hYa2MRlP/c6HbzdpTMsiMSdHmGtFPupKiGaSkYMKNjqwZoU90vlt2MCSDEoUxgfeMjOOoqlPxSRWYgBBG+zj6/Wj41UrIMAGmSkZxqT/aoZAa8ikXSNN9JIhhIgNSmNzN6Jz8tGPdwWZe/C5yeyGfxrr5vUpPuKF0K6gT+j0+lnb9dtjloO14NVzjz9UBUTlzMp21qJB+Fy513+1I9xySsET4PVTt2mAGGoAbZKgoNBXqcYaWVCZhNiRUQPEBrCCcHwSO7jZJBDgxyumkJx26cUoEZ1zC3GQTBkfxkFTT6zq09XbdU+Wy8V3HXYVzU2j9TWl6yUoapOsFa3Wv8y57pKbfIIdUbZTwjHXJ9ebO3hFvsiFOuXxSa20IYWKvd3G+KpImVRSt7CIyna6mhTLvmmyB4hc4eRxG1B2zQzXMclkFvyGTV+llGifB2E2PkcHuwpXxurBnrEWlsRYMZz0+B5WLuOTmnII/5c/CMu0BxJznzR9HdBbNMWsUidA/FaAWeT2JuaVU7cfdLimtPWhByIREbi3geyeYODUOKT9nXxWSjFJdRGsg67rgACRw9AjOz9/xQgTkVF3Y1Ew4xEgFGRkWggW0OzUSSMlbYQrQ95QuaxwEu7279CPBNBI6WFhyrmYxeBbg5kIiNQtHU3nmCbE/DDpHY1taWpUnigZTpSRj4l5WmT8iLuBIjq6ZvqXjLF6auedGebHR0ABBarYsUqyBxKyMQKGXWhJZCJAZlYRQyC8+p+0E75fXvXs7+t+Hl9wl7Hp5eMeCGLETyRoooD4P/+/BAYD13qnqlL3T5926tve2wzI9dMLmJVyWbIARxJ33v4FYdUXAfFVVkAszcaVuHDtTXJl/0kInT1JF0eY8M6IuoS5h7VDkoo36OpoQgJ5YXkZae+7CRhPjLlGICpslAbr4K7ubo9ps6bpBEJ8wlFZIGHBDmmhTnGn0KG7KdlojckFiv/iPdZdSrKsdnPgzVVCyyr1hGunvoUqSApheodp8xBTVHsURP0oQr1Q2mfOZniL37GMaOZME8lJqDPG+WIrmdvNSOsI65rPhdwu1Spc8+VgsXCWvxRgmdE9ywrlTO7fsDJGK01xn05mpYDm4gHQl32AhU1p/+stqfGEGL5IE9MNkoq3/otxU1kxE0DT144lEI4pnsNBQk/lM8HaBi6GgN7/RoTmpgHTB4F2KqO6c2KWIJaLvYWjXVOUqmWbniiOII/9Gf0IkV1sVViGlinSBCi1I28WzUGgkpW609ffOjiWEIP9r0f4juBAmzh/CxcnotYIUiYzZjPLP2LOAalB7aS2NyGMQYG+ODdu66/24iUw/59EEwJSDAnQ8VIHAD9Nnqt1yeAYepELn13FDd44Q2M8r51qRFatz1AL91OwlxoKPrWeqmZIufvGesYbmZRM59p+alugszF5BSrRUdWh4wyI47IhG4hbpay6oY/kwt8GTb867AP1O9ck88LABuA1Xy/8wytBqMAQQmFNOc271pvR+HptvAt8tzGvY5RmsEDQso6wJRY99JNJTOSp6jGoE8p00byqSHgyG6VPZGEad4sqYGspxZ9moo+MK5pcOLqp5YqNeSdXZvrwYE+deC3uElsg2738/MuLWB5mtUD6ibWZUj9dH26BSAcqERxCx9DdYzsgPXCM1MysShmaThkqBLnuLvjdHhoXtczWgbDVqyYlAUWtK9wqSWxGJjg3ueyl3ZW+37Fiy993m+ectFT4LJ9FoRkHpYS5+W6HaNBF4PcBTLq9XLyBEatkWFZNGOykL1JxmDODPnfXTwEJWE81qtpzMLAkGOeiFhAJAJOZnA4LI+N0l9/WPegjvrPH78IpZGhuwmFzbzomXjkcfhqRKyd4G7UR295Z2yuRoHhclejPsIJHPfZj9wSuItRt73WXYx6OJW6q1IgdD+r1Ct7M56TF5ogklCVm7FLTbcjfy19JhQIPHGwpet1qNV5Eu5L54yXxVKXU3c1VmXLtyNSS9/hBUo39v3nH/zkJ7t//aL/N0e20XP9fV956GMv+dypX70Y8lLlfJmzRSWyoQEbBQZbd2U1Nu0Ls2a8k1TSKTePOdpHF+sdSCXUXzZmiV8yY7rliASzE3Bi0CEeuCB5z21Lk19YVRYaPanXK9rgT/IQMbzog03xyeMQ7i1gaAu/v5v477KeMgRmWIRI6529gUoZnPLPC0SHQu08PBI4BWS2toVQTOkph5KhavZJT13wYeoa/eh075eTW/2dz+cJBA9lf/XFPc9ue0ARM9FIUhXHvyo47mX/jCd52b8Ilo6h4oOKijfAU2EwecZulWync8RYGiFq0rPHRF0OhnoArFxXbBBbudGw9CtaV+PXcm1aRrlh9nh6UILMTTlOIymNGpCVduBcD/sv/jkLFSXsUYxXNZHF6f5d634tXlSk01KHYqFOFEV04Vm1SnwLtJFQV7m7VHxbZ7rV2QVJJEKI62roXLAvda1KWFWt6qyihapSuwy03TIwZc3xseYM8xlSmSXK3ctNat8uBpRUN1B2qrfgcG1ADbx3htSUtWZmdDHAUqA8ibXB2MJUVef1Cah5Uh0GrG4T5/+19DOe19xMx2xhVMdsZ+liGDjIZVlEUo2YWPkv1TfIEyVeDad/hu/F23ATR6Sigva7XA7P1L/64saqU0ATFM4jcGD4sCEuCOJS9gr5rOqSKZI7t8OK69PdDl+kelsABRrBByFG8PNCxB3tsFqBqHqFMo0wtbDpgjGlR/yxGnpLb3yMlQnV1zboXVWV8KHXHl+V8Mf9ABdD42nSMHe7dI0L51sqdOgXdFshsEVK+AtFrNL2ughDrdhaxxbVIlfc33lA3I+KLDvKvmYk2VwQfzF73C9uki++br7QiLwxmjGP5eu8qQXOaYFNMezY4K8Pvk6/rkRdj6iShde1DJPgYVLpzXXT1k+km/YsrmhUqd5erQZ9PoIOm3Ue8RB0SqJf4Xl8smxB+vd+db1wFNv6As1+zm1Ra6VoeHQPD9Y3wvYQitIQbsR6A8Hiw2i6pAJkD7MSkOXOmvng5/GBCDTBFWa/oK+g1DHBwbNu1DDLEzBoC8Q/2X6CmRA9KtHMZi3heaUGPZFN4mIZEzzCItQNvFIAfIeTdrmoB70S3bjKsS2yc4ifpMJf+G7nHoNCloTjdd+Y6es9zc1ir5zFb3Gz2BN4j83iw495YzKIvjhkzZ9A1lalK3ecgK5cw9uAfiYSJq/wIZD1UDcWGqCFcOX9x/Nrf3fu9QOcWKlQ/dmqI6huNnnHwSFk5hRj1oKX+dzjR3AgD8HXa7Sf/kIQJkZDcMotId10A3KbMjCQEOoWHALxAG+s4GSOBXyRID7tRi5tt5TEQED9vPXMPSPq8eUTisBQQFCnO5j4anvakn1KZ5HRj35BgUTsslIjg++LkUY7bYyKYWLP0xWYVNeP80jRX23LXAea6G2IGY+A3/1L1Q2zHD2B70otWDeMwsAW3l4214tWdusbuFHv3oO5oV3+RR1aamWHpyYB6IycUmsRo/nW/Wpk+AhOrKNDdUp0/lTkrSc6e/klVOHOXh5Tmvzh156AJv9pAGnTS8H9OvHdWjHNym9dTGTFhKd6QYGOfagDCO71wQ5+H+gUiUqkRDIp2k8Rn8FBaiIyIJVFEkVgDmJYccJnN2Z6h0wcLbWN4XFoUfGjQ02RYMWcCBGePRPo4CelWK20ZMoIRmrrfwY/Nko9tsQYodgaoElFm6E0RNNApGqcG/6tiPitjvapfDKSk6yO5RHyto6lE7LNCn52QFFSaPnms6nq28xRG2xrnmF3tlbIdsHomM7CAd6+J8q/L/P9maG2N4Mznkw6YWLEBxE3wsbEYpOXUlXnCzAagRmN9LaoXioO8zO8FuDq5oltetHAqyoTepYdwRsG4p5OkeJ5b6eoGAk8epHYqixvNIrTu5l9f/f5oxfs+P0L9+77jY03xPcv7bGB881xUqcfPqNHzBY+ozfg0UwxAqlaZqWZsrDK9a68LXLHgx1Kyshy+4DGZr2CuX8GZUNyNQlvcDti2/9h0/67Rtp/+KlT27/4y9/+6R9doL37vu/Hf/Mfdn3fog3MPoL2o4Vo/2bt5u8b/cMsF1Fn9lxykfYgixLESUXSwgpNXp5xQxE8GuRZin4S7DjiMQ/tH+y3IVLM8NN1JyYUqca2xUdoHZYvV/Ym7kfc+dRhmawywAHvpQZcBe/nY2FWPqdiSuActfHMhpwFgS6XPkNzTFBL4d2A5ilZZ0EdzQq+cUaMEgL7nv/bX/vVl36JdWr5Ttt/eyTXU/7mtePXU8CDu/speBu7oPJ85hB0G1JVyRfgi1BlP4u7nq8fBtnnUb5hGVBE1a6Pr6s9x+olZ7k3megjxAOtemJ5HSbMvoDCpt6B0Ztmm12D+YzvBdNvZovc/O+m8poRyo9GGNrIMbTRJEPr0iUVBOPkq1DwG3Y2+/uSmQV4s/v1VWmn75hZ7F6xO2Rq7xjZSDMGJSMLdkfFICHiVCEFD+HnRL1/gpHFZvef0CwK9DgE2fUQ1x9hZKsX0Ps8VKP3jYZ296744mXrgm4yvrqDxsNqdSSP5P7SnSd/gy0YucHmb3KDzR+/wQabNg+M3mB762urN9gMwx0rwx2B5Z52jY1PXOL9IheOhSbhjLJyjS083jW2mHxzVU2nitxmS/QR6gOY9LbXHu8a29t1NH7Z80N7CKY4pZgWy+mVOp0I8OB2qG2PSJlqtZwsHELjB9EDwCy5VEMtquuGSS6OZ3fqvNcK8J2OdSivaDPLzwCBsBRJd1J5KUJrWdveD78Ex197dLh57B78B3P8FSknjkVdGopWaAeyX0XtQl8ih2rpXrNPxr43e4eKMQlFlbdSBd7K2VtyJ3gkLUzS9588rnVLSdZbP/5LH69NwTXkUWmVQ7dfQl7GH36c4bBtYwTb3D6KYt1dCcp1N0O5/vOeD/WObyzivee4iPcbSH3s5VTqmQCmH6r7yfedYD/5J6c0wZmvXOfzraHgpTPXBS+NrivdsR9zTmOkN9ahy22/6kxJTeHhI9yvkSw1QvjBd7jwF5y1KClFuco87itKGHkXELcLzT8Yl4e4mq0pvpidhUDhhpp8KtFkKg8jpKrHdk0+QwlyNKlB/McbgRYygHNr7dfMmcs8SwkY8BalSEhVjjpnb3uLjpHeTZHGogWt0ovELJAmw09Tj177/Aq5kT3Aa5dpKdLaSFNFCJbci5LPjei3LbJ/WN7muO/4qWEiZO/XBdLFGgcw/To3V78Q1Si4hZZzG8izxfA3VJekO+pbnkE0C33iA0VTGJQFbrBcaC+9ldvScDLdlG/DIkNWrVNcpLQPYDvFsTweDDZUBRE5trDW8Yw9HW1h46QicXX2We0D+mb1Lhoy+eSGyYLxwbgoh0jAhiXxMeOJ5dwMYwQtelw1gBubhLL9iFvhDD24Zgr26oDJ54Txmo6TIcxy44lGE8ZD/WAaQBc1beZW9aW3Fa3Ntzloby8Nfma0lVIFNT6ArruSNExPY5uaMTXDARI/gMUsxQaAkSPD6Vpb8swQ7LD3VBN8mVqSrUXwkApXONsptQqtvIlbRcnqpCihJn7aOpZwn2E2teLQPCd51vJcFTbFrYSz+utc1ESUj1lOxfySPBFRNQmDYq2CG2ekMyiaO8BARKt0g+uU2sRM6TZ3pSODNgPjjBrS3cIhd28i56yrLNTnzuqUQ4HFux+aFwdnTe1Fi4d7JlAdKSEP5B+gbA17ewUNmgdD2NMGX3tV0EOf8YjYfQ9FtGRsxxY5InOO5N7CG7mN34n4nZp5wUaegshTNLNAh8dmVgcImAfXa8TpnPJZTURMTihLYwiwwIDPqqd78dChFnI1Z/ktkS3NfgumksExI3buZe7HmOfqGlbiEnVdq3HLEF8tW9+BKnpQGnIqLIl5awDraYCuhHa5yNPLyDNc5Jll5FkiLMvP5tacw9U9jkflcTx2u5S4G867jim1G4+keLxY58iX5KQBZOkJOJQUOphvRZ/gehF2yPMl4hgSt19PlGKaxlrP2SDvW1hjiLZARDkv3XxCHuvkp9MYLruMWecYIzEDDBfkBcDCNfeqwqGW4BQ48ZIww+Y8qurRygEmSupfCuFFjppfQ2gbfxC8EKHtHPIltMwhT0K4DdYVm+xd2i6YmbflZVlfMnmZ05eOvCzqS0pb+WWbvvjysqAvqwIepW8+6gSKFy2Z3xGtalfxQpTiZZbwSkVOLXkKPgGZZokosijbIRRCOUWMXMUpYuyYCtgAJ5qcP4K+xbn4eZJkHXjFeZzXFt2iJ5F8ewpJ9Ge0ksxUop/vVK+BxSlSiVa8Q+Lu5GJHSttBkmknIdqW1tb5lUsnrPvQItfSzkUcSdxRrqpSWo1TJVNEO11pglZMUkIljoQVi7qYKF3jglavqMbW5/IWZ0seWPlE9vQw43s1P1XEPJ9V/Oh8IOYefvAieQEXeyHj53aDn6dzJWcY/Nz+KPHzQsW6C0v8nOOoPYKfPQ5dIKEtHDpfQvMlziYlzjZKnH0yN2+b4Ow2Sixm4qVhMRMvT9YXHy8WgVdpK7/09KUrL1v0JZaXeX1ZwIudAYsVbI4nsHmxis1dvNh1bAEvbXnZqUifGTw/xeD5DmDAuYQ8xFg6K8/zEHmRRYXMzIDiKYxaOQJPtfPBV1Q9hXbIfEA6ApJpp5sdJeJGdB49iQOTc0UQET/Hnyk7R2ZKqtWfSxdVZ4pkfAo9VSbftJmCL3ZMzpSOzpRTTB/MTNmpk4C0+Wam0MhM0SlCOdEJZso2TIptdqZsx0zZThcikpEOMyVIMTECdpCNB7wrzGNW4FbfFp4VC2ZWnMkFnmVmxcLDnxVZdVZsUUqN1UFnBaMjY7TS6i1Cv5VW+xKawwzQOWNk/ksUW9TO8GJRuyMv2xyhji1x9+Vl2U2H2NLzbgXPuxN47lfxfLWK56nguSXdNGtQfKaC4na4cDk2J0W1MbKu+HqeJANHP/nO77+4+odhB2LspHMFgS+u/hUXcaKgoVYnWPMksrFTzDCYaWOxRtH/FIv+O0YQ9jwl7cDbsYWiVk46Rf8pCHvnI0bYWHT8LcIuAIsWaAsi1bdxywfCgvvebnzg0xNAFi1ybWNEDPMcTyFBi0CcVfiVNySYV3LGCoTikrTCDawviOXb1bwtL12LZVv5JbZYhpdVg2UV9OlMoE9aRZ9M0GeSGE4u+m4FtURMSYeO3ihkOTo6Ociqu1EL2W3YBW6z/va3a+QT6Gx64gsK/sGtvJevqWeEJ9ATAaQVKWopr9Fu7C520+PxkWEwUxGR0alr9DhdWHS1bfOV3gMMsbbsh6nNaeLwCbxS1+ift6f58VDp7ZLZSmVQ557MVFwsJ5QZtVBnUTOAxn6+aJp5ylNNh4By3H/0MYPxwlhPNR0CQl6yXJNMcJ6SM/IUMv8U/rFeNnYoB8OMD+m0Q5r6myazVPHUuQiB85CkfjSeRE/RHdpeLUJfiF84t75kWoIMMMaaA3Qxism1mKs1XTPvHt9H66ZJcEAosHvXzRIcoUbVzbRzB9M2XJT4R3Z70MBuwDnUrHgwrVzSVI+Cxn9pV/c1oexrutjXYG48js6xe6BzJA4SBOMJ4xFaJvvl1z5MPwa7K0cxv4KPvwHOC/oVM4GJmJQSkuT3r8XOf9QmH/kQvVSMBfoQ0j7PloATEDxEqIxwiDBvjUtxplVcJHMOEiJFzIfCXrVa2kLfUQqSRoTB6bdDLp3ZaxnkV5xRaE0oQEIq3LT26wIKKnrYYfqnkdeuiEXd6ZRvoC+YwuPNa/AV1xg5qbnzAS3A8o4ybmJJC7N/Ui1ZvbzV1Ysimb619C00UmsjINQlwKjPUjJxzyj37DmXu3GkRr5FgyYTeziq0ezszQ9M8Jy9fOus8LHWNMzFH5/vDuZNOPICOUug+9KiOl8FQQQUAHjHrxqr2Dv7isPO7BU3F+I0T893VeEjhdiRY6nTv+6HYfEWRo9H7m4B+0MmuRAHvdA0xEMN6qFEj4goyN76SqRAXCfx6lxQ1PsgpMOuVNUkPHtGWztqA0xEuWYYpLFXh60nsYaRSgiuWhsXAWCCNF8kuBmqjOReDRrZ4vFdE00JX+EQlHVr+YmWf9BHDhzdFRlKh9iIOtwOWSI65As/gGJbKjXSyn0O+Jf2gK8w45XXjUovUiEtNlpSAJm7WWUvaoVyUUsTbWSfnGrOIv+4o5pa9ucyu7dOi+3vEYqh9GWKnXIciorN7HeD5lRVbr97U7Ogq84q6APOKmhWsfm54Ex+jhrybNVIm/SICet7Jwhrt3qk3p04Ud87zeRjwZ9dzeR07RHbfdSjpyqhRUsMof3Fkz/L8kfOTcNNzk298XNTmGZ4cPTc9J9uqJ5kyfmNHpiG/0Z2Px+44XjnVp9FKms2Bw/nJlJrykWk1sg9JAh9X6QXglpX89uJ7iB9go8FvamXkD6OFAr13NBdQ/pg9RrS5nWevLem/oueD7H8Y++z6ejUK06oK/vAaydvOH1IDxKfM2lL2O+DTCqvUDIK0DTUka7OdTAMeWC+oKBiaPiRTfffnJjurcp0x8tx+KjfeuR8lOLF6PRu2en9A1VjHo8GREVogCQ+CHK/5LP61UF4mJyaQvsXfD8YscAZTFriDzbRsQ0yteDjZ3+gELSsnNrQkNZA4v4xuQaE+RLq3Uhn5crnt3VeqRO1XUB2zSZPllYtP8g+gvJJk7KP4kX14RbGbEHXjI8lc4+zciWogC3cTmk0Fy9FrIYM67h4AueeXTHFwu2PrJ+73aOLqbv26xbTiViA0aDNk6YvprKSirIV1sbfG19RN9d4ve8EGq9YN13t31XeZ0kKq+azse8nnv7jd+fXJ6U5gns+SB4GwenaYTgAyTIm+1PQYIZc+lcnupfwR9/wewmo5OHeSzg2ei/hjyfuJRzMsAOdegfhaO0R3kH4zLQ7CKgKu81vmrsIf7j5XYR/O9WuP/kmVe360+Nq2HxMF8Z3qo0Db3P1rjODE6t3He2U+l010btX0y51xFn9rk8+dvpduL7UP5ph+bnd6Hjd+NUxHS9OHFHy4lD2ZydW8rr7ESh5PSIe4OOPRpbyiW/JUh4rWcrP+X7l2g5Ns/emJYEbmFhkulSThOx/q5oqRC9HO+gFnDep7cS75B2TJPsEvsJtJPApd3N8xYMsu0071qkYMO+TyBm9UgVkYBiRr148rNhMjvSmTB7YSqAejJihqS2SBK4NXR9QtO4+HlyAaM8tprnnriNWd+e+MhQ6ySoMRT4tVmem0a1m9M6QqRr3AzKN2G65uk9zrigwAe9RoHXl5dP6QiQGL+GgSmgaXj28/pV9PRji9V7zmv68F6jDHwdPv+85MyxqpVBkORNAfd7edQvAz7zWAjDYmJZPQV/ExgkNq9RD7lIBZ2iuEvU/JLMEIzFwn9+ePo77XLZJx6sSofVXWJ30Ic9Yog/kQonZOFU6qRdhLNGR2kd6zelYTdEfjTrMmkWRtnIkLq5+5OR8mLreFGuuH4R7ySNFY5B9VmDWpJBA+m0ErHJB6RBGF6jOvrYAmzqjmpMhKS2zIiTZurKpG/WzosBLD/uxLlabXLXryzTQrQCmmNLrftTn8rKPiSQhvCC4vLxFDN34KZbzquby6pV4taKIwxWxKEaByuYZ88Q8DzT9sHDq/TQ4arCAUv5VQwyoW2Amn+qVa2YUV+6txLogxANuKuAw6q1m9D7bGx8ZRJJ+UoXIQf9RgiQASCIBSX1zkNQfPUjQ1hPB5Gf8yMHkZCGS9rMRiKSPECKhgUgIiNQBERVRG4jAsKEFSNhvbgqQGAAJRwESVu5mYTPIjRSLKeCuAJj0RID52jSqeJThUZIYab4PWLubmuAGj2R/bbi3SEODKZQOC0cgExWNS4zBsI0iHOI9Wy9GfW/ZKhq243Q5Kqt6HANdXZeoI0U0rGz6buf4IdbkoStkvLgaF7c+wOAqYV1PL/e8atf9vZXVl7yBNne94DDX5034odE1X/sCqYYP9XRxeuiZnvqOMA7FG7wAAiEuMHSenbVA065OWoFJtY/8xq34Hvn38YvJBa8UP/EGqsPHQKxyp+f7jBZUkzujPp58g9SXTZLYicUfK5RzFTDiioH2YRZS7biLcTKMRdWYaIwWsSIVf++zHFOPNrxKOpSb3LU9sfbjmYIYnRn7+V2+EW0UFPMsveBLMS+cpygvC1tLFVZW76KV2wIMuEJG3cvYyUlh9rfW6q8vVtTwBBMJqChjYPyKeZLiaYpzSeb4Y7DzJ3JJppzxZ33Pe7luLuk8nxDio+IM588aVmvdCIu1l10SgrWXnRo6CwZuJLQbVgqFhu3Sx059nIUH0jzd/eDXWPaGS5iDfh7oxvr1Ppjq8/2D/MQXh3wt+DC39LCGOQ/cnEmY05FHSz8sT6TpE/Gn+zdJ2VP3QG/RyjiLVn4bP/HJ2/zz+U/CHGfjd3H+8/hPw3dw+A5fCDXy+vq9VvwWfSLdA4e74cNOeXobfMS6vWyoe9kIYxWY3bPeWAqVVaJAxhK34sTEoyRTjFBEIvjPvljdugbl1jXAq25esHXl/6pb18DYJp1yNengrNu6hv3BV8es8+ngoRVocPblctcabrZr/dIj2LX+n3fq7YuT2ekutdCGUYHhW38J//7GOhq772JIay7FQWuGojfbzQWV3ZxYevLUvOcKf/4pef0TOQHSPdyhjPypwuYHOoAteMWaCs1vhM0Gfj7Alv3AQ48YaAb5cKuAT3W3/DK5KxKzgkHUqRIlGO3UnlOi2wSkhdW0emV1rleszFAwsa8bTNnXTcYatNU93OOPc/IK/M3+aVxQ/BbP86afvQI2Vb5FYwGpKbFfmBp7TyX2gTL2mItV66AS++HJvK6VWY1cRx/xee4rXjcu3NlZPeDZOXHAs/+EN6S/7/nyWZDd8LpHeT+6Kki68XWPQJD0i/8WUtbbXzcpZdXJ8G90EDx43fHEq0fU1vuPXTQDZ2NzvBdpyfXB6KUpv3t8hdDX/Zr0Ko8hsGyJY6S6lqGXCI8d/xIhnHQdNZcIEb6zEh5oGOcSUkoKDxqsvU4vzBsu2HRBZDiWQHVYbGXlbX4a+64ATDefwYPU7sZZeYZs0Rqy4DwYb6F9QxsyrKjFLHX2CwLQrLmgOLe/mKd5DLXskPIFiuydw0WaRY6IOsR/rN4yjwxLsP+5XzMvu8xdmsUFxXmaQ8IWysC85ivWCHZf+s/+lmheLKYBP7vAhWX8zGHUltb6/GruJS4ieqFM24K0BaRxUS0gsN5L3ECptkiCCyO7gbuTt2U9LqiDMur9QYPVnQEUfm61QGa9T27fEs1QuFZsx51E6nt5Dv1XdKKgFQ6wwZUta/kOmqWl/YjdyZ+cEuzVjmlJFHHHpuNDmNEc4ekMwwgfavVZzGX/U+ViP50qF/hOg/qU8EJLdKq5IBmJuyi9tSdm5YlkOzFPS7iyxw97Za9Lc0heggbuguRZxKUdvbK3+P9n7zri20a+89+OKVNeLmURAAlSLA+gKJJik3uR1yt6+27aMfej7DT/cklXeo4+5qhbeu+93tKTvaX33nvP+968AQYmJNPydmuLMG8IDIiZ75vyPjwOReTJaR4F8jOuNWEe/lykzgM0ApbJPXkDMhQeo7wiSVFwKsiP0ft4SZwdhRejgRw/FQ2lKswmFxW0OBUkKi+gyv7/XID3gYb/849n/ufvJTxPJCsAT84p0iDzEWFMrmCeWJmTLLYD5PFzCBNC8oFhn2pvuFGb/TRyr8qP2oA2so1xoJuN3Nt+gXomck9ByZjf/h8/GqFJ9SkqjAOPn0JQTHV5gmgM82svWnNCPqAZ78suA9R7GAfzFTgX4hpickZUwcPFA2pSwWxOIfaQnxNPCw8rzmqTfjCllk3O/ucf9Jw9Q2sKUC5gZkqlSR7caMDX8Z9/O0NFmiI95TTfj00USTPz0RDpoXyE/+JiWvvSbwigbQMWaZx+jLoFjuTJN/ephvNGNKUZTtBvjJwBbqI58v5rgTzuOAU8HiF0OUC79ualt/ijHgJye1RAVgQ3ZERVNGrVBmeeQ9+yQxvOJGpbakYBZ762NNl5BlwcYOzeTn8UKGC4se1Z24PPx6MCDoAaAWrmR4KAgPMSM9gTMEgy1iTgt0nno0v8RJf5xlf4hlcMmAami48KQMlvr0VXTQyp/G7QNT7id4OuyzImugFUcs5fr0U38Y6D9GLRLS6zohGjt6IbfN4tuoYR8LaUVNGowqvokwlRhWV0RwEfVr8oiugWlYkezA/4lcOoxV+tz4W06Ua0RTejZtJfxcRgakqHBRBLk/fYFLppjrKzMN+xmz+Zt0tL1I5qEvC4FdW5xK+ImIJRhaqRR3UpXbavku5gQJUkjcG6glQ8JE+OU6AFBBBdUPhvMyhg8mguIBzPZOusXyvGI0YTDRdxL6iPx/gzMeeej3ctZIVkE5JrZyTZ/6DZ7p2kiIFc/fvFeCZ3Mrcfmczz8SRT5IjkpAFNjipyKsySq/++GA9MkWNkDk3m+XiaKXJIOEmuTIusAH0V8nDw0C7Aqw8XjD9fkX2ZahLNXKOqHKtUl2PdvtRe1igHChDl0MKhRVsU7TMwmvMdjIp9nNknysYL3k7jBQVy64gXFKzdEaytP4iZPjweEJuAYuxz3r4gsSAwlPDzNYZhl2HYYBj2szDsnwyGW0T8eBHDsRM1qcuP04jagCMePqpQKfKoGQUM1JDacjcXiqED0SBJDx3oTqlgxrR4prAdodXGit0JBXLcReZLWSAPqIjcuzSlIRIvp7D29+OaPQe4KtKEdgV1OHFiQb5rgDoS5CsGFyEvKMKfqQX8yIFSjaaCdMW9hVIt/Q536WXO1at/X6k1ppeESHmAr/GnctKUJvlFKoeygJ/JKJAP+NoygA9wCCjEIbTwrwL+VYV/CnccS9SUY5NacmxRW45t2gLItywdiHwAN8Ihog4OHeri0KUG3dlnuPZBjj6t4bo1WrchglcRIriHw1voggF0LuEGp4oYoKMO0mADoaxbRLTHTGiAFJJaYwTPmRPrzIk7J+cEPc6J9ajKfKgzF0rMiSat8bPfUV7UqBoVcrjhY7A+ghueww2fCqbbJk95ETq8sA3qKw6GZCBt84VlCb4BbsH0t3365/z5l/zQX71sj+h10d0WdW4jszV7ZKIJROKiKVqQOCabO80ZFYYCSEKpCc2Gli6Sa78f7dLQ0GXmAlEfZyS3tUyRE6eZ8SIL6wqmPguwVugei24N8asB3TVFt3bqJ0T5OhF+lqJDEXDZgNWgLqwurcFaozuw7jDYCWCf4/I57dnwwqtYKXQZYgLvKHKw3RJsdx+YNVSHEb3FiO6byYYCk5oM22I0xBEdq8whthBeHdUYflXqm3kEHj4qOHOJAHMJd/7gdtoKxpmCceTiTLtgtwWHSXeqTaf9b6bNpqRjfnHZNkMrhdpKvtS+v+RQvEWEwbdFkbQcrDb1YfWpidKb1MEF3CGZC27SVbr9eTH/0WBEWZzdpNtUfiA/o1LhmueAVwQjXqPruMjOQcXvXYzMj8dhmnzEKvV7oPYicWgTj2ziYEXG/6iPWRxdoZ2HDxgCptmbMlO4CsGZcAv5JRrpj7gBb9CWnFg1X8YI9egu61QAmsokPoSSLrlCvgztXjVrnQr3crb1qcxrRW1+7sd47sPGXjRko8RcEWMKfxVSAIYcR2Y0q+mo7ctRhlyMc3hoZjXAgZ5hpkO2XIXHx2cY0zCcy1At/Y58doDPxmTGfh7WtBSxfg0WX2Csn4FlR8YjR3OZDsc4CQ2Q3BjW78svpa/wGCAPfY57Y2nv0HhVZK0iH8pCOlZHA5YpglfJHEjm1FkcToUCVEQay0D+LxoKyZzVkMZG+jSU67WTChjyUYEPZ8ECWbBhVrklbgNZ3dWS9jwTVY2H5DwTxzgNZIkdioPAk6FNQ6GEqlEFwEhGN74liiEPfZOna36NsdykmvFQoFjcYsUs/sLE/+BxrVBBi9dHU5/CE4tPfTvnjW9HgRgQUhfl5fWAitJJyL3zT/psPWmPjyKneKaSsp4gqmJdzB6CqCbOqBeiUOrV9uWWWPfjpnQ2CNrH5bzF7wvCsmY+y0oZltXBLtsyy7Cs5LKs/tyxzCLpI8WyprKMMF4071NL7DkZHlS1eRnJUT1DvJoSz1+SeLpztDKjBhzWEuJVhXg+inWI5y9PvPziT048LznJWyCeLSB0Cgi1AM9+5lwX6nVhSti4Ii1ClUXm1i1zq/IjIatwngtF8UhN5a2Q9TMS12TBfNZnLpMHr9ZW6bni8SmPQV3BhrL3CcPm6bBZWWbYvBCFGfL15aSKMExqO2q9QC0jfp4BC3kj1iZ61WQy2+I7ylzGzK9LKnOUyEcvUJCJPBXuY8YtLVTWrjCgOqe+ch+vn8KuwY9LdfVg29xQayeAGPAQnPX2KWRD/PpS4fCu+6LSoI1r5JlsPAaelX3W6uz25Pm1TVULaYohD9iaF8W4NA8ZHHrfilIDN5x/wReKaIFv9jCBEgmSpIa0gMumiovRFS7kMr0YXTJVfE4cz6JCsnLGVWxFt52fOYzupS9SbBvXvNxfhK5QrkF90Dn81XtD0ISWhcOmyJn4Q+YtIrpH24dp0J8nQX9UMLsURhvmtSQKwGvacDY12M5oBQphxc6Kvl7w17vL68EHFxb14K/9/ifqwf/saMB/7KTfTfVgKQW6wwHEBtGDbfJCmkxO+MRIwu++L5LwXy8rCf9+USRh6XVbqJz3TBI+sJLwqSR88HGThN/Nk4QPTiXh51wSPlBJOO2EY5Nk8h4jCb97Ukn4rz8mkrC6co+WhCu5mkIRI4ZKwpUTSsKPnkISfvRMkvBhniR8+EyS8PfkScLf84FKwqoFqzJ8Kgl/JCXhRyeUhB89kyR8mCcJHz6TJPw9eZLw95xKws+5JPzooyEJPzqpJHyYJwkfnkrCp5LwcyYJr7zHkjCWXEG6OcEHJAnDPZ3v5Iaz+mgnN1zXqZP7e9JSUG0ZJ/fB0zu5fz+9MZojRxI++ErrW8Si5WvP7JsVC0wPgFN3d3RGIsAryCI2P6Xm14oD/JGeN3DO4w8Get5SPnG4M1w/OBZdoIb4wYUhUZhRjVcc1fgg4/4+OMb9rT88aH2WQDkzU93T57gUUDPX+312Ce+3lm6dDii98sTSE/eurflkm69AbuVkUaoHy+ObARwd2gerB4eWZpZiy+tIpxT7mFCsqRRLJWPYgK+VjA8ykvHBgmS8FOt88MIHL3IV47N5ivHyrMsvPZd1cSWHd4CxMi+k9ISQnPyUkang61LzfRN8T4l6StRUE1Z6PseDYmWZQfHkau/Kotp79jG1d+UotfdsVu2FnaP2nl1Ue88mau9ZlC11uaj2Svb7pvaeqr3/aaJ/i/z/C/xzXSVWeflnFr90jY8r/H9W7V1dVHt/5Mlq77d8f6rwfpOT/kZJi9orpaikYNVeTV5Ik3rC06m9OV9qHR05frkIid+3iV+ziZ+xie+xiUObeGQTB+cSrbiSaMUV1YpZ9vXJV614BThJ5N8qVbJaMZgFcZH8++bkMD25LuTFII8PGqoVbyRasVQg5EE/2da0DvKIYOxBeqpBDw5VK64KsZLPGvgsWNSKD1GqLXL+HWJBgxUFNt3WVNTgqGnE5KjF5ScnmV8yaYIiDVMA308GbbNlS1QTNlStYluKfBFWtR8pPUDHIOJt7fFdTm1p2O9Hrj0Xc4UhQ+7pU4OCB+hxOVd2OfXlVp7ucoqeB8xQXcvHLw35mJVoV+U+Q7LLKbWURwf8M19tRyvncaej7ySRgSZ4F/FzogOM+c41NFyXNuQVo7gBUaxCtfvI7fEpW3xq6thMh2SB2EXC8UmK+MAo4gNRxIdpbW8n4niNBq447rnieFN3OYVIDH2cD6qPo4KlBdA7B3JOFa1j9PEqxeTLaT6nfdbHQ9qmst3ltLtPfZQMFwZEcQ9/gmSX06q+1V6XXU5HcoRsLBUgHbznKONV8sw2p1BYsWFNqoyDZiq+jjIfkTQyxmMegHWsvOi6mnRnozCjjA9TZbyG/SOhjLegQW5mlHEMo31Vxg0F4SnGNqcTfHV9DF/nJ0JaJpsUpsq4saYUaGV5RvfmOp+YB4pH1LEi99jZhRQnRIn6TWSTO+m+pADkORSJ9xqoL+NsIX2HYMrfM1cTH3ER/OevRARHeia7o8JE6fxHPhojPU42To2LWu/5mrhUS3oGKhbwkefu7ZMPkMQFeJRpx9kwFTkjGmc3TPV0viPdCLoMdQDoAN0X977kxZDGY10TZaTxS9R2xsSW1JUiTqVxH0RE31KFNN6SOd6PQwsHgpDh2wxdgaVdCgFtqTi+IgPV5XTMupLmXk1zr6W519PcG5oEWrfoPOvfZ8xelPz1blshXcAXFcw4FO1aIf0X1uI7OPIPsr9khPRIhfRfW4vuQkg/lAsHqFT+v8dlDqKIzxvQHfQdL0tJngrpuxiwNiCkb/D4JsLMJt2NSjrbvhx5dEWqzacSGr+abPaHFnP2/rNzYRx8+3qm3RGzh1ttUg+7/G0KZpEmzlrbR2qIadtDpJqYMUpqG3M1ScX8Vbr8FSLqpqt7GNvGCMWIjVETg4zRoAEbQ2OUxegYo4/q0a65bGepsS99VdEIUFUxRtQgIS9Misfky3Fmd2GrE6s1xoCch0JoTEVGd7xjhZYJA51Gi8QUKsZ7+DM3567E95wd3nyak1y7Q/ecHd5Cexe5fGYFmB25i7n1xGSuxPNMcROSk2Y0d4oLhNT40kJ5K1OOTXF7yByZzJV45hRXAIvZRpeSFifIipg9SjwMwNQFWbvUM2QtYd5eok1kbtJGVnF/OVXcBZuvQHF/Bdh8lQ885r/Gxb7OEG0qRK/yTa4pRJvPCNHXDfBeTyAac9arAtFNTr0mqQ1OvSKptQS2lQS2bySwfZO/3lBgO6SKglOMNxScYryp4BQjVnBCPqNNY3TF2DBGSYw1Y3TEUBKQA+jSAqDJBXQXhh2WOzACMWYG96FCfUehPgEC9igQY051Od5D5lsWCqGSIH6bZjRG4h1LibIB6w5NhBL4HAk5aZYhiEK3SPdofuSurSP8OZ4sswxZGub+e/RWhixy5tv0jhAwnyx7NFkkS82QZUefwpJlZngwkgewZBm5ZFGWyCsEx5NlCF4MLVmaIEuTXkcm484q8LtQ4NdwgAK/BmJgJbzBxOgoMa5zgTeUGJ2nJ8ZFlxgb0l/LGGGIwYhkUJsee0N78W3ATlIxSGBoA7lTSFCy6A7FUHTXxBim3XXJdvFlMRTdfTFIGeFAvbsA9bIL9b4LdYFCYDtwqivKqw7KbXMFmAyRAVu2c7eQvYfPczduRbsDGjPay9m49S3+UJBo7iewmZPNLS6iXqmjsFEG7FgGTDKQvSf9uyI3M1wUEuIpA3Ige3hiyKq2q5DtAEcduyn3mtXRd7GiaJpXNYjuom+08BrKzq1jHKUfIkCnT8SwNnDrEjEukCol/WsHiyCBVtmO6oEYXYuzARslxZkYfcWZA6DaAoAaLoBCAdBij7g4+KfjqO3IpPfQ5svWLGcXl6tZXbxozQ6xsh0SIZOoaTLv0i69/Hkx/3F3buW3m1BJPSkqigp0BwumO/QSLrKTyqwy7lnPSEEThwUZgyPCIptu0yVVvVHzfRmtd6F6D4wMUBLV287UtAlwI/X0YztY1DYcByTekDJEGG0HdRVi3a/tUKCGbZQRGzXTKBSNjf8/EGMmXv5s40iXLkNaPKeqHO8hEyMAnEMQ9dEqwiMdrybms1/DZyCFjGVzkmFubj77GXy2Rxj0UElpKfZFAb7AWAewLLV0nrZIbNMFjEzhv5/eWF5AUH+Bty+K1WEByTgQh/9Ya6wq3gR1ewp+0xAv8ftLhy6ZI8mcpctAABDpItJY8PF/qNhMvFFAY7lONCBPcVk33tkOlSzPqtBrdF3Mp4r/R76UCGCBjkZ1I4ERnkQ96xpQlfHb19mI6joU6UJeHcFbFALZaUBgwSzo6oYvUrq34LdXP8GTSrd1qtXp+O2rcisni6hq/Pa+efzH/PY167cPRc94AW4SZw5syXI/7ouY3acSDVIxO6J+PnPKGebU8H3BnmWYU3aZU/vwmXPKnL4yhw2i/n0qWRFMwF1TMjE+o0aGTKGSKViOTAHgHli4hwBgaMmkIliAUh0yBUuTKb/0fDLF3iKdFKE6jqYn1MnJT4kWe2BulbxFxjVcpaxBqxp4qq90K99osKhR94mgUftwHlHpOeHfKf9AOVd6fo6HMG+ZIexCVM8QiuQkT1hjpOeSLgFS6bmLfk4ni7IChE1k5qZ9lQj6FKj03OC0Ss+o+7L2TlVqcCqVnkPxFDfU+Wtz6ymsVHr296m+ID1DHBPoUUi+lZ7tpLvoTrpr2lyqI3SdLfNVOb6JVbldQniKc9xQpWd3z/wUJa72fMu6tm9zKbdYe77paM/VI7Tndqo9t/B1l9ee/XztuU0tR3v2s9rzVLXnKihMU0d7brl+dtHbYu9x7fnbd1+0kcYvfuU51p0/jXXnM6I7LxFn/NdPVp5/21Gbf8lJ/0SqPEspaRjxk+KMH36gccYrT4ozXnHijFeOijNeyYszRhVonDG01fcozvhdlCpFHhtnrNKx6Jgto2O2IWA6vUNHvzEZySyKNDg51uDkbhqcvAlFSHWMKp52SwOS0W30JSAZuQMjl12QUI1Ik1YnffYw5Ra1zeq2riHJbarnhySL6nqyqOTeMVHJzSQqubx0VPJIjqq9Hh+VPD46Knn0LFHJdVh16uREJU8gW/Wz2usEDg/VvwTDzIeBCM20BR/OhCOUp3gKfSIIXIE4cSqIPi4/RDTCF0r1gnZTYkUe6mtFJxPUJU2OTWCufS1ukwr2lTgiXOipCBvbC3ZQB+kF59ILhP4YVR6LTt7OQVk2BHmE9CiJTh7DHJuPdpDeWTo6ebgYnVwnrYMRAi6PfdiZ3C7/6USdrVBg1dmAVjGUiW9K4pb5wHwvm6wexNleXtzypUzc8uSJccuTTNwy7KeLW76c9vpX0tyrae61NPd6mnvDiXFuHCXN/sSy0mznMWlWetCoqTHOiA9pRh0+r+lKsxVXml2HNIvhIyKJI70bdRNptkJXpNI8o+gEiT+/ImszNRfCZ7O61xZutUZbULjWZMaEdFtCo5DqicaF1EA0LqRa6MaRkplcLJO7mAZmUeuL0TJGDUa63IXRNkadmmz0jFEWQyWBVVTPgjTr6dpqNdWrRlQ3elWg0qyXlWZD1zura46sNFuMp8dKs0P82bYu/z3HhevRNk2NNLv3uDzkPSbNFjPS7NQ64LczxU2tNLvtFOfnSbNFK80OHWn2/DLSbEWXQ+5rljGoGtOWoWoX89puGu95rDQ7hzQ7BzZZsYMC9QoX+ypDdJBIsxW6phAdPCNEXzXAezWBaJ+z7glE1zj1iqTWOTWXFCWwjRLYvpbA9nX5+RLAtkeRglOM1xScYryu4BSjr+CkJhsqwMZirKsqJQYZY1MMJUHbAXR3AdBtF9CxAFr1qk1KVImZwX1Nob6jUJ8CAUN1H2xTKEdR7N+wUKhZafZN6zB4KyPNeozgab40qwRxpdk92j5emj2eLLMMWYS9HgTxDFnkzDeNXjvMJ8uQpotkqeZJs8U8afb8EjpXLll64EXPkmUAsgzoVWQy7jLSLKk0KxqWvDW4zsTYtNIsohWVGJtPT4yLLjHWpb+WMcIQgxFJkZBgwCmSVAuwk1QfJDC0UbGmQ12L7poYiu6qGL20u+7aLr4shqJ7VYy2MsKBerwA9bIL9VUX6gIF33bgFCrKAwflqcqZSLPb2c7dQnZvCWl2mCPNvuFKs0MDm21641hpdnqUNIuAaBeye9K/A7nucJEnzeZB9vDEkFXZQSG7CRxt0joyGRsZaXZgpNk23UXfaOHVU2m2p9JsG9BZpbZIs0jHnDUQQHWT/nVTpdkOle2o7osRW5w1U522Ksaq4swBUHUBQHUXQDUB0EKPmDf4+0dJs9NcaXa5mlVpVmu2h9loj9rI5Ap5gjSLStqSojpLSLPLBi2LWNuWEOVUrEVbrKZircZsdWU5a+du2iiPubyrGo+VirVhVjSvuC7vum2mERtVaaZUrPUXXN62uaSTl0Eu3lbX9x4yMSZoSBbayXV5y1VpSNbIjG7bJAMfxicNycLIoi7vtBQbksUXGOvg/NO7vNMbJyFZxX0Jn4MrUKOzXJe3Bmc5b4GnLm+NyPKezeXtq8s7BFIritSQKibiqUvxBxt53PhYRh6X4FdxZsWWLPfjVRFrV/EGairWdmg1nznlDHOqKhaFyzCn7DKn+uEz55Q5q8ocNtq0ep+6H3hAceOTG1B8wb7qv4qvtKp8o+aiWLtK7SSguF16Tvh3yj9QzhVrn+MhrLL8j2ekhGqnccJtI9Z2dVGQyjEx+jmdLMqaEDa1zWx1VTWFVSdOePWjGyccw9BVTyrWunHCwPnRYq2iZHmx9shA4bdTsXbyngQKv02TkwQKTzJ+9/xA4f9n7z3g5CiuPOCu7p6enp0NvWh3tWiF/bpPx60I0loIBQzSthCgLCEsg30JG3zHbyXfD5x9rLTCJshG9gl/+Dssc2Y1ujPZ6ecgnCTuHOQsB5wuydn+nOCijJHve//3qqd7dkYBIecV7FT1q/Tq1auqf72q7oohc5Pu/9ZjC3iQjbbirmoOxrXRem96dbUxelu7K7e1xz5XBfd/+9FNch+0l84YifmRHdyxjtwlholulnCDAKMB1ep52d3vemMzssTN1bgQn/N00z8ZSVyb0CUjafTe+bD6RuMc4Z7/UK/yj+a7ES5Hh2PgcHxc00/61K+xlA6hhfaGarmOuV19hOgSrx8pXM3GRTahOu3qkIb1V//kiJeL9+P+eI7tF+8Lb2diqBdL3/FaS6xfCn7LrY2Xgqu4skuy8ePqTdlutA1RNUBDRaL57dnVtCBpXyQta3s3HR1BfL3oPtqJBq+Si1dmc4GDJb/6c9e4haqVbdWkfCgArqmOthfu8e6wHj8JkXuY5W7Odkox84ad+RJHCbHRAX6id+LL1Y3hEgo2TqAgbJF1jRQSvc6qIKxn5ESvx6PuTIdU0pUws0EhlDFAr+OfwY3kjKBfgFONHKieciMOLUd5iOaDFkKUPhw/CdDagV7gbZAuSse4sSMYbaIfgkEK4pABjESPQ3apJAKHmnLNq1TOW/5WY7xM+FTUK6m2B5XRm9hBmuf2qx71sOOKjkXCv0fYn2bHZIqvCu3BaGHAC5QtuhVykY4Qm6z5OYQyZt7x67h3/W9a3bseLDn69ev+xiTYGHvMWiAKTtwkhevX/aNdvx6Qa69YlzvsoUCIJ44PR8KiHUe9fv02vX59p0H3QxOIApVVB8OsF5a5ZAzuzCGy8eErwRfwT3Q78hDFltTslKM3an+32cnghceyPIK/8kUdHpVBgPyZ0lWVBy47tN0asmPPZTxipQcdHd+TcvrBn/EV+8iujAi+aOGRmftbMCL3/Uuxjl7tP8x5Eg7fYOD/f6XlDCHT+gCEyKKjUgtNCvURZsPqCySDlsO7o3KU3upDZ3XO4ILeIAWhx4Hok8GUiqbDg4uHxHDm9QKrQ1KKcBT9P4UBJTEyrsLfno+hnKDLSQ/dwOKJfnGDtGuCFEZ1uzhhomQVaMPAGz7ZgVdmur9GA7E+gjkI3zxfe1EosyhoEXmWRuQvV9+MmHuszOelNGYaHjATs4mXtwjY9f4qCRjwEDckEzYOJNys+ikEbs2L44BRQfWajHlPZnvFnz78vi7RSvUOwuIGgenwezrwudLPMPChq6vYjfSqxuauXoI6Rioy4AZE9BE/KwkZwGdHO2ZKJQeS1fAq+dVvdZen8Ekzl/+8sfD60A5TSRCXuZpbfTlhFtanLm+hF1kxs2MEe6FnVupYKfoi5qTYIwcIbSQdvQ4jO2nafhaqW5Sw66FlVcIuJOxDwi75KmHXSliLnMFlscU8IHcTvn7xFSmojYlzR6Qpo/+9ARSOzRjfkp54FUioPh5lUOCVLg6qsevoeQUA8i7+i+yMijgLOD1F0d/Z3lpF/40AxHWc7Iagw/S/vBHMRucnp+AMS2BLm2KHT86SsQ4QH4bR6C2Sl6ffGXFHIA92MZO4XCcZ9X3V4zD9PmfcTadsspXsYdK/MOmUtJTVu5dJB0Cyz338/JHC81T0eiwGczQtE1Y3c4pV4p741EIIDoDz3wB2D8DeAOqD71upiuKdxdQH3A6T6WCbSbDMmxclpykMR8Wwo4UOV4u+LCxMp6lZVckb58BTa7sTT2+v6a5fBDAN9Uc58rEln04TtO9if9dmbWWzZzdKPk22JFLuhJhSlg9sjEuZELvJys9wcbGhadSPwyj2fbpTEEbGVnr8/JrM1cI5Ggr64I7YxupipgtLEvJqUmkU45OL/Nz6ZuIpqIncW/I0qS8MOHAGRJJyjHeanHafpjJlfp9O7JyWbomDrFQa0K7AxpI2lCTHk06DH6eLiOhw+6v3f+KFQ3/+7cWZywHZcL/gwszFkae4Tv6nzAWZQB7mNdDP9mauHn4iCbly2vPefeBDmZuHvPhab9ZrT939gczVkCShRDjLyjq4N3MtXzoaZK5kRsRhZP8h7y8t2PbhHzx+z4cyV5J+5J3v/tBbfhIvylxOKvQH19+5de2WN3w4czP6jt5PnTpuHl+UuRn95Zc+3Lfp4WfvzdyMvmoD/v3D4sxVOurExn5KmpgcfeRzzz3va9+5IHMlkx/eeeZrv/ud5344c7PMN//inZd/67SPL8rcjP7I8x5m5s7Ym7kZ/a2Hou7u7hsWZ25GXy7MfXRv5ipdBc/ta2zHzdxkxuE1zXM/t86XTfKHh9cnp7cI/CM6HWflYppx+LNcomvpbiFLQgaH19uLONAnR6yCJmznQMZ8RokSm01z/DRCt/Th+BTgo8dB2ikbAgMy8A7QNPSlado3q3ZY0M40SG0y5srUrPfIstVQPuKj/evMVG1tZ3vDuBshrXCMWXQGnS3nPGenBl0Ptksd6XHK2OWzuVmPxS0jfBCVuyBvmyNJfQDkEYPvIhDS0zQtrKBycNyVT8G5ekiWLKHEhMS3fZYwPcnXpgsHDyGIxM1sB6fBKMJCkcnhNOqIGQ6AHohMgobxqkqzqB+VT9z6hAU8Tq58ZbDTPsJIS09HvsiThxfkdxbnw0bDs2FYO5u6l1sRT62vg0NMqvs9cjnjaBwzPML7GsO/NDG8tzH84MTwnsbwHzWEM23KPFebJFvWt0s7Q95kMCDjweBv5QAsQzU7DvcM12Su3TOuhOEXDI/LsNwF/eqiCGITdSHFDPUFd7WXf3KY7kRfF16e1ooKYA/0Kli3ec1GBgtkpoxEb9bFcL7kHDFua0sG6mqtFkVTxtyRuuHiEIi62BkUhKug7yzyctEV7RococDp2z3PjAWjZkxWSbFH5kzpfQZ/Voixv/TOlzrbzv/2/C1xaenON+HfvYuBkb1hjR9Er9cFTS0Jl37m0/gXDl+FY5RBdD9C4gp5FOrcHt3+OlBCrJjG69iPgp3RHQjYtfRVL1t+zT/+4fkX1HZrVPKpwu23a5yC3dna9aoBVv3AMvPY4loS2JwOLb7Kor7SEx4jSGiwC+HMSNrIpTY+5e8KWt5TMNGFx1nBWlJurF5IQY38rJY18qhcrOSurH4XDjPzFIw/Kf7zQ9pcEzOiy6iNLvA2GWy8YCUof3+VMORNnI0ZZXniDuyxZstTWffNnt2xL6DOJY+7uiwqop1gUZZ1/LBDH9hL/k6O5C4fOLGFYe3JLgyfWV8Yhomxa9aN6Suu28ixfglrxPOajHNYhhzLDCpWue0n0zCEQtlvorfWLUDpUNEydPcxLEP/6zI3yE8KVTmx4NyXruxwMrKflAh2GaauFio/6uoywGEij+cMAa0m+5yfj90TXwcDQx6WyJ5MMMxDboouWaxrGr8CWExt7c6qyTCJFJL7apRvKlVzaUruIzl7ondYs4EnDaxSzCu/Edavl3KFPeI/a9yCdfwJNW5Fb3mNtdv6sV9npmX1W3MQfeYW0aZbjGuuN1vIlTc9PHJnehEStewoBQu4P9+L2PEAcCaYvD2YvNU3ON8d1NAZWLYWLN5evzqDSpxR/Zwx4XHaBodemNkGv3zfI2ega9yj1jJrItR1EI/Iua0QaTxoCexwoZgLH+G0LP37HrmvV4yF5ejeBkuh6jLEz6psDX3RfarHKAaP9xdseG6jDa+pO5/QAPRA0wA0tCkfgPAwYQDayP1IuqP2oaw7k2EHQ8LGdN0LJZkXPYi8s07uwLQbwmzHBLXLeVIhtWEaMXWo46vTaAV72/FYwewuEVqtcUAbOvYukbYG2iLmR3Ym7BK9HeHI6knsEq3D8Pj2lrtESywjrLl2swT0wUaMh+D+QvD0YnD1GciiKBHbSCaLwxTdELIW1WMO5635leF83pEKy/dzWpWYajKdZQwa5d1ZV1ItMtF7QVC7q1VyKR1mEM6pSc33+VUeybeYMcN/cD3+K23JXtlMdxg23NvJxkN+7amfZiM+3lRzkXNSmuk5SUDshEn50oE4JB8manmu3A3bTduS66i8Oa6yE2yO20VmUN0OQtq4E04Ud8HpjyMcoBYpBvO9bYbd6nxvK9z2+d4r2CnP965V5xolXqlxrtAk6/RpmYYNa8wFGjakxEGNQkrs1yg8Sy6B1kZsxtLXu2YCqY8mp2xOpnAI/23gVzWpk5jQsyQi/rtsIOl5Tocj6Q44I6RpotGkd3PSx9Q+pKEKyWPEj5yC41MH9TKVd7VHt4xCQiN2ZmpjDxdkRvEt4MugNPb8rhr01eSKCnoysT9LNAb2oKlMuRcNhXnfE24w8WPQVGqYU30CUJiqVfWwV/mQ6ClaDT+cin1o2nTru/EaqG2u6P22X+8wduAs4h7TOEz4Ge453clzcZC5zQ35y7bmR289rmgfk2hv/KrpfjpfZtw25sIAfH1JtNfnS40r1wf87G52t5TGGl453je7+ZXj7e++sf7KMbrXVjzre8QaJH1vG7xV7aoL9FPBW88YiUN297FbwfPM/A1jI17d0ovb88COPLBTA7vywCgP7NbAU/LAKXlgjwb25oF9eeBUDezPA0/NA6dp4EAeOD0PPE0Dn4Yqnamm5afDf7b6Cf6Z6o9tHBgXEhsH/j9gQNITM2LAh3P/kJd48enS/nhhTF8PwutwkDCL9EY4OttIK//RCNyzkpk0yFZFnuvO4FGD+EfkUhmJPqCTVT2L5Ex4JZvkLIy60BdpIDKbRFkG8RufneUfz7KvNJ0hexkYmWanLxnp9FzjmCqo/fFMOGfJYezZWM5TPEQldKtnIGCrG8+Be6Mbn9PybPZcHN6aSWWCZzzz7Mg8W2eSkw2IMsQl5y4Zu2k0mYcHBz9RMl8oC2geLbhsgEPOpfn4Y/+5xE+XDcQL6RzYmM6jWZxoSddo/Eyak60lp+8b5yY4n4byIyPP2L2bSRfQ7Hw9BsKizELMBigssnc15LB4iQDceMESJ56X7SxY8Z0JNs+9OxlGRzh3CUBu16vj+aA7DyVDS+f89Ik3vfJVX19c43xSUMP4XBrihyU0REOgXmg/klmmC7luMx8cfehwT6M0rdk1mUtz66aorZX8le6KnEqbRbO4be6CHaX4koyqJ83E2D2LqbSYLsALFZyDZpYsbXHP3kUc0GyTTi5G/Ev0RWiZ2SAZ/Pv2B8dG53uhUp1GqqO9gmaN0FK6pNmknSxDYY8xI7QUviaTc7I8M7/NpZQj0hIWRHsm2cy1omkf/8cf/mLlsncvzFwQ/5O5pks4RsyVPfD+h3t+9sCbF2duPDcN7VcDDsCGJDZBWgphg614bibPO9Tq93QSOZ5Pi+gSjdSuuvS1xZmbG3nnEkRJIrilUofWImotToLQ5jIvVkRQAWRXF8hMmGJn0rCYYufZth7G1MlrRS5G+8mGgZjDZnr7zuTnBcR/3HMWSO9OVsibx+fgYYbMMU6yUkirWMFW1xVstdzxOsc25Wpo0xo1ni6llfEsq8OrVM9mi9mU5bq1BMFaWdIsKkkAMy9C3aqnI7r0JgqazVWVSs3C2DuLs+rEy9WoIj6PLJGQhrkgygpHwbQinoULmH/Jha8G5FhNw7ZXgZMVXPxaLkPlvlbxESDcLNYS9ZUg2W0uZyJjJc7R1j+aMRNvnotFnEr4jVdaaa8Vaa/h3Fd5w2gHnXAyyzetlBun10g7QBBbUSdEYWbtldQlkch5tIr52AQrupJm2qHisCPdabaVSuPHD/KjqZxZSS8JQRPPoUrMPKP+50j9z7FCSTsRmRlaBYa0/AI/s7ngOVRSZtE22djVyAx4g/eozMzOmJmdM7NKX8Nfhcbi+uaHS1dwjjTDloOs7RhKszBHFwi2w6LIxrOlK9jD7UxrUc+1tvGfSQsv72BDgr5BD42UVpqlWAISQ2/Q+RwTgYz7dO4ozYo+iImbeWfV4tE64etW4AzRM2jo6gHiU9ID2QAO7YPDdUTZs+o3toChOXQu4DDPhev1ncujd34dV/BvLF4A9jd0mCq6jvKPBlLepQuNJHMgmpjVg5kYBlQgzG8ciXsOgnDdEXt1R4X5G2P+BJbPsb1oNnrRbM4tmNCLqoDSLBAtGA9+9zYgUDDHdD4rmPCb21LVs3mTOh7SprTslWQX2d2dsLyIpcaG2yFIK28xfOF7IUt73t0J9+ERWnB3Mmt1h0tnyNnQWbqqQM/byKHxLBTixENcgH5uIc84GcpbIquiirp0thPFc9xhrmUbFyn9g8XzuwGaep4yaOqZBE2ToGkSNE2CpknQdHTQ1PZrBk3hJGhq7vyToKntqKCp7cRAkzv8uwWTokmYNAmTJmHSJEyahEm/bJgUTsKkSZj0ewOT8B9X8a+fzFbc7RYu3XEkuHRJBo4uOangKDgqOLqgGRwtmgiOFrcGRzaHdScJHC0pgqMLM3B0fh0cnf8rAUfraNGxwdHFrcHRMsS/6KmAo4tagKPlxwJHaQ6OlgAcXXgC4OgiLvqkgqMLGGZedBzgCKKkZU8RHC1vBEfpyQBHrEBrVH202/LJi27MPCs8Ve0VUOkCZpplYZS25hoo1KoCRHlq8ERm0iaI0jy4KqLLWCE6eRzEx1O6TvglzISY8KEJHGIPinJMGtFsLSUfW31Mb9ln/opSLaUHjUzp8hbhatuf1/CgNkHWK5EpTnGgriULOVbp9zpmgt3VNJNr5+bYA7X+blZrF58GlVrTiBSKSkNettIZ6vCldrMzCEQWOJ/VxCjRr4GjHBysAWJYo2iFg1fWIerKI0LUOxWiYn6abSehIeuSdSPr1oFrIMAVjbFCmgb5B62Bq0W8K+rA1WUsWHHpKeFW15l4GTdQQCvcGtZxK0doiVvdo+BW5fXYuLUlM824NcxxazABtwosghhLOTucyqD/ghW+XBCl59AVCsMPZB/0AmttIxTIOAwKwgU+LeYmQwkrUfOVJxXJnsFd9VIqwVlPl9L6Pxug9Yxk82PuAA4tkCydHCBrmc3AbNbZZiqIbQ1gf5h1rkb8OrOxd6F+p3GM6Zy5RvCK6NV70ugVn+9phq8+dIWa0GuYoVevFXoNTwC9+kCv+iWJOdIKv43I1TlZyBWINUOvk8h1ErlOItdJ5DqJXCeR628FcvV/b5Br/4kh10nkOpVj9P1uIdeznVN+X0FreEKgdRK0ToLWSdA6CVonQeskaJ0Erf6vDLT2nhhonQStPXiN/NcCWoOjgtbgREErCz74Dba0XjYRtD6rAbTykNqEWkFrhK2gHAW3IhjAdYEFrgsz4AowmwHX+Ra4Qu/fnay/8DNTvrTodk5YR6rr+eFC1vT1oJ4PZVHVjWfVEevsB0fffXhKJritQG3D/D8ursh7bEvEOlO61W22D01ErLMxjcwZKeJVySpZ2uKCtos5AOThlcW/ZBniA69mGHROHYMOf6r4p1cffkcxKLJCTYp/SWrHPVuJWbYC+OYAy/et14/Mm1gNgNXvWLAKwRb/rFTar1xS6yj+gfg9BavfFbD62KPXXlD84wH6LAtWH30cYBWjts6r4B89Xnn4tJ7MSVBlC1URpf2fuz6xqPinw6k2FqRIkJmFqn+AxICfVjpoT0Spy2LfcQjjgDJiMdVsEGdbwFqe6+47M55XpQXZgIh5KB0dmcvD7DM3xGtpIc27LN5g11qiqvPzNVYBlpxjYcmqZmi12gZhxl5RV78VaVA/W4knlwEWZAkoaepT8uoCmFlzAmBmztHhlU4PLGZbdBFHnVMoetXJL3oFpqkVLeGTm8OnZBI+/f7Ap1Nawqdn0WW/YfAJLP3yMVE3x4jqmAhAbC2vmTEgEaO0hb8qlLTAoqSFJx0l2a48x4Kgc+D2Q8kkJwVKz8ihU0mOX3rM2/GjpNlQhdkFlIQHlvLxoqQ5ipJm4or/YTpDOubaAmg6JwNNh/Za0FSaAJAW0TNyGDW0eyJoWlUETc7xg6YNv/mgafFTBU2ToGnRbxho2tAaNG1oBE3PVtB0uQVNGxpBE7fEOXV1OkcnEWb5nPolW/F62+r6dGlq6uYu5rkOSdbWIQmGcyrxwJnMHhBb0LEhytaJECX1MepiDpQZGHPAObTBYpMr6tjkil8SNsleAbmC5ZE8B+jExCuOiFBWTkAo0RERCk/cL/rlIxTv14pQVoDG2cu7SyuKEOU5JxmfdGX45ArU+wra8NuNTzYIPtlwovikk2N0NOCTZ2f45PJfNT7xj4pP/BPCJ5Cuj9n/V4Y2jg0zHp2EGZMwYxJmTMKMp2YCKcKMlXWYUWqEGRy2Wt+mtFuBa9h3XIADsU425hD66oy+GrRfH+RYWYQcK3+ZkKN9EnIUGqDKMdp+0yCHe7Igh1f9rXynNJw8mT95yGnykNPkIafJQ06Th5x+b3fpgt+bk/kDk4ecTgy9TuMYp/56T+abk3Uy363+jlxF0P+UPxfXf/TPxU1+Lm7yc3GTn4ub/Fzc5Ofi2n/Nn4trm/xcXHPnn/xcXHsGjpxW4Kj9SYMj8H+6XDl/Og2iVQbluqflEhDYi8geqpRwlV0wFmzxs+u/fLkZdGu3XP9lI8oFdgbtVIYTJuGlSWUg9vUeyjZ2tj7M8kU7tZMbd3jAG+1JJ8pt1wtUA7lPjp1wvkfq9FPAV9uFm5MuXDEHf3lzEuGeuYDYidjhkFCdQ5FSH4008fcjzfKgpX/VRj9g6fujJVxoui8aoXYMdj7UjBzGQKNJNxfJoV1yNV0XiA4xLVoSUSS300V6O11A9VT9jRfagRQmUxrutOM05OF2OuqmrvoNdT5NgSfulatLe0HoQn/oougye093RT98zJ00WtIVd1NbXKFq3AchMj+dz+Z8K5ysO+6iviwfbn+0uQ/586N0jV7OeYxzXncRMuZstzGxQt1M5Fz75LGPIi4dVV0vkVzqTKvM5lTqPNv59M8ZU+jVw3j8IB5TjGc0lXxmkoLoQ3oJJcChakRcpiCeiis9ESPxAS4DxB+Ip7I69HFoP3XEFR52DnHe1C81wD1+/ohWgrkPwbyP62v5R7pGv9SonyriVpj7R83y2Gc3QiV8MK8NfcgqxEHrQhFA3xfl6gWtyfTLqk5kVYUD91t3j6W/w+Z0j81p3NLvsPF2WPo2G2+r3IGIW91Z2TqfrLJBbaBNVlkbNS6PJroHAjuR5NVzOetMF3VtjiPWuZ7NcciqRj13J/5G5kHu8PbBTB/LEc35EW3O69AAUqLqKZ0yGpe5wSLqot6BuzG5WxUIRUk4m7KoMvn2Dno0dgXt3F8Pob4RqiCsShHULVIlz6tb5nqUUQ8ofaP+VKkDkos7qE3cNqqKWyW9OLNMMtokviDHkh26PuPjKvT6rYW8hbsxsWHMOgrgJVYSULDFDlzZ4yi5zINM6eUtTPGe02GoBEaHEm7MYfUvSCoYrsQ/mLRhUBI/JVUMViVOXXkO/7Rdft15zh/Jc4jnKp5PJ5cCXg8m4Wj0YZlF27TKXBpltIRbHDxVkBWVuYUrFFKF4W6FAmqD+ELoF0+KoZ2/2tkdYkGxwzf08egadzG/7dSuV4na6IzRl4zFgfZh238r1KFxOG8uIWCZUwAw3wWFiDjDBZr9oGZ/OrJ3cNc+y5xzKkEiAZzBJNzAGbJvOKnAGUrahLBkTIXURiH+wAfkJEWiWiza6oR6cAU6Mcopc6GtB7cO5ClrNDDJ3KFqm1kiPGekuM9QJ7toL+RYpU7UoauxDinuR+0S+EtG19uXcWCZM2Ftb5fhA/v+2ZWc/2I8vczVqtNWszHxyeDqVJ9cXJYqzhUEIoZg7obu5qSES1XhN5sTZvUaDmZnHTscskydBUoc0hwGNQdSYr9GiZQYahSc3yi7XAaERR76sFcYFRjNQUQGjyFGD5/qwVFjsHMZule5+nnXVMaarqdFOX7aJZjFjQOUipGByjJxhfxcIU/G3zYqxVUOQ9tWuTzG/WYAIwXOULSlvnbaMfTZCub8SuqrqZYJXhxyyjCGFaCNfTZPasOag6ooy84DFcwDFckvabMmgRAmLS4UuVbrubZREFc0L2rjAF4XRHxPd8QE+B32O3bqQH6E/OwpiEBWjDx+406wCjv8xB0QQS7KclktRvV2dESwd4xrhOIdrnON2cJtxLM2sMIYbjx//11PBHInvtlCzoYHN8OPbqyEyx8cre44mVfSe1Bs4CT46rX2GJbGXv1a+n35tfRelTh4wrX0H3JN+TgvJe+vX0p+P98s7oAFext5fgl5v72EvIweLJeQ34e45Mll5HILuYue+3DDReQ58xTYKpWkIriAtwQeckbkfvxrXpj2b+JqMp8BJiIPvUmnH9fKD+nakV58YVKeZ3Ngfl29+bskN3+zEyCeOL44CIv+sXDzebnx5vOuavRPt574lecfabryvL945Xl/05Xnw1KKNAmUCR4WAye7lsxGCOno15I339SuFxBrOzZeQNyf3VP+KiNXdUNkkaI6ViOMMhhNNy/xb8ZTOIrHcLNC3ezcmRO77DMYVaCaYiRG/3ZlWpebtbmGaiDW67+hIMTtSSVRMPL1dvNXnzQeMMQ0shCChX1OAw/83MzEB4zrjXmjmYjRlRLPsnSx7QPIUeTPxaD47IgjK1vuxZDucUmI6KRjnBa93I5/CaORGg/WEqe9dRzAlxrmbiO9Kxi/izyJSM6mPbXxpIQaerAJeBnzG1SAzkWihl5mEU4NIJ70qgwi4CFE9/ClD6Gu6FbRJ2QAYT+E4mmuX+8I3TEzykvHUbkF/fr63efj3oS7z7d55EGNt8PlTAfJKEBGfUp14TwvCc5zbkEc2I1G0Fv3GTyhfqG99/hGF79bXYa3L8O1xR7mn49wNGxSYnch5GuUR9I9AlLJW+LIVecc/H0HE5XGIy96eJs1ipN3pndNUhEutt44K30BVMyyqRxWFno7OAcgmKVf2/z1/z7wHx8+7yr23+YOnnXGrXTR1S96EVY94XnOXoN9h/6kwqGZNXicfVsN/4nR3nOcaxdROJC01XbZQvHvBR1cA060803497XFNapQQTADaNZ3WFnM0DHA1/miuikJIQcXcnjAaEWp+iD5D9Zvm5+h8q4KQODnIRJv9LXXAJb6yPZMwA8gWwaSW+AbFN/o+++qof5Xal5VyJaqZ3pXRLfcqJDWo4ZmKh+zmfaz+MsNbUSMLGzNH1pcq2kTRV8Hc7tR8Sv04vFH31O/eHyHvWj8I3I40EEjf19CW47C3lcRpleUSyZVzXDPe7MMNYtteG6VRdLBmRzKMpnnjmvEzEp1aDEvC5VEHNP9e/WjOBRhb0TfAS/GeoO2JVcrEX0SXQv3ct+Oxz2ysWlgD1BtwD+WCSLskAisOEnnUtGZz3wmvQrK2lnXtmi4BmHWxincU7O0GcO1q2KD+++Zn8tTqQb52uJuXcn6h2spkw4itIb2D/HjbHnIhp8/XBtfevaF03/4zXnTFkvU8S/fsI3bJ1d0yr1XD9TpO4Yp91418ISbGACaZQPEbuqsGIj+5TU6UHDnfzZ5kNoGdhy5rL8o4mXam4fVWaDOkN7r/33DLif5NlwvvcVjbfsv9S9g76PqHWLvj9T7gGH/QfXvw8jwL+p/B+hfVf9+0L+k/kfgP6D+r8D/afXvQEn71b/XQMfVfwBx9ulwEFeUuXYJ2YYUZ4n3ICIN5mXNqHNJddan5yz2i/er8PaIdzuyivLywpxVX7xf1jGvUh/1PiUL0YpcHI95Y7uXiHmAA7mXO6APEWKeyUs6UDA+ns2Dsk4POnaPFJp8N8epaqS9RiOFF2UxfTtnQQCDPDjFWHGDHQdooCbnZRxAa04Eg2Wou9E8gdQxVhpGrwNciR0VNlWib/LIg6c33spgRqnRTsTRsQ8htwDmvFlolhp9Q2OwDF6v8CeNNGdqix65cULYZ43x64tAb2NmAaWgYWYKjjgzvZSHvKRSH/SClnNTgJETDmfQn5RTCKaMh+kXD2hSnwKkcqAdWaqS5oZkPAwD2CDJMjJW1uRHH5BqBcx5BvCXGcPYJZv4yUSfFvTpESYe5BF9BoSOglQ8KxVDJpMKedWv+z4mfcNYKF/B2PWChUYCHFIDxavriYB0R4GGKkcItfBYczSgPUMgdnwydnT8CcaGRATbwyng9rNbg2c6e6Kf6hSG54j88xww7KLXmHT6SPQoQjVLnaCIeYs+e2udGv2HpC/Zp/+UJ88+/Zc8BQzbMd7pBJONw4kL70HxYqHhrxzItvEHh7Ohd83wOFLK9JOUeFzOQQEex+3j+Pm1mhBkdteaawfKef6cNthdgIjj4wCA2oetHJjsYSq+KnEHkrL2W9f2wyHBo9Wld77U2Xb+t+dvkcYo30WlXYy9Xnr74pHvzf4kXa0mWzC5Oy5po8yVRgH8LOlislTnX+YdWwWlcHa7uUGzVo7RhtkCE7wdFQ85A7Xx6rtcXheLMsRuphdcZahMhlVt5vXBKISquctwXEYmDruKjpjcoDIipugAZCjPlk7sXo3EkDs3ow+6yyM2md2JWfrEvY99YfXz1y2mupcntqV/If++y5Myi/nYfIENm3WOcRLDaRt5HUTZRhqVKQVwkGfIw2lW0sAyQHS/+q4GW0Ij6sYcweVI5RfE2odsT4lL5LVESrK4gjmKj42/dBN50ePoA8Kf5hAhB2RU0jkNZWWLdPh6RnT97CMDGVk+L3XwcmvDZ7zA8BiCP16XZOPIUIPl9kzvgEmCAqoxXG/88CJnXAQiktiUlBXn0J+Pu0uu7nDyhVYIJdcVT9kOfGowJCPYp675VFY8XfmrpO1BrCWjzQ/JIguGXaps2ijEfiZWqVobvwu4uJ6Yt93aa1Sl9t0U8E/0BMSVqbrYX7FLFybVN9WJz+soRkBwlLQ3BBMKgkW3No5+7gMbyWSJQR9WUN5FDDObVBlLsnJBJMutWXMo63xhwyxa4saiQCZRPMwYSd+/HfMo6JhGrZQ06LYbihMp6HYe5f+yWeGbge+NmevRmPn6L2tLKmUIbts+Zz6WUSWdQhlEG/jRxYOjrRn+nqOl92DCK8ydGHoUel3JnnEOLSE0+tqtyv+2ba5aMBK249yIQgPQZOLe7vGDg8cnqmJjxvpUc9EVBaiAlodcKrVYC4TcTb7PQUCor9CY13I2IIMZw9kxy0XgutVouLvdaPx17BAArTjD6ixQZ4idhznOoHVJk1yhNeRfyuDXK6FbLFK72lQSD1B2UuFRppIaRde66lj6mWeO/cVbxv9ncTYPDXPHclOjldfBxhaDprZknYLN0vO2D33z9a+8aJFAWkzzdcpVWZmOnY+nUQnL/Tsh1js9nYY15wJ0DKLHLHk7jMsY8WGkuzIJ4FydlDHxBGzIIPXBpMmOmHMc3iUkg2EiBDsOdwijBpwqOxEiVqksZh1PYi30shyy1NzDC6kDTW2y1IbK9uQ2Op9mgJ4YqAkJOxwA6WiN6NtaDbzo6IzUqd+oUw8WqN8D1Qp27w0qKn680dMOoQE7EAB/Hb89w5hWFhxuPAC1L7Swzuzzq9jUF8uMuB7/lbaY0eYNAJ0tdJstsxhEnLXPBytKumHETpiUL5VhJzsDmVTuZqND3CY7qnGVnWBzLP3YhwWpg5A27oQTxV1w+uOIue/GCg7bHtsMu1XuHnDbscniURmdSZxrlHilxrlCk6zTp2UaNqwxF2jYkBIHNQopsV+j6N6sB2Xq1kNPsIR0NW7nJ1Oos2EvP+mREwC6uiJNE40mvZuTPqb2IQ1VSB4jfrTbuB3Y18YJAOz+wyyjZ/WojT1ckBnlcnpk15+60WDdFFpF9WXJS55Y+Z9VR8lTmXI/GkqndLvWi7CIVWqYU30CGJ2qVfV4hogeEuVAq/EPUrEPTZvugz0ia67oEURr2Ns43cmjCLq2UZEYIDv6yq3HFe2rEu3f8kMmpQmHTCrHecjE10Mm++iXfMYkVOqjoT1jEtozJpb+VRvvgKXvD/WMSfhrPGPiZmdM3JN+xoRX6kAeFm30whLRfMbkI07xjAkeW54xaXsSZ0y+/BTOmJw/4YiJ1oGZ9/WIyehIwj96xAQVwhETuEc/YmL14aB1oQeg7wuLR0zC4hET1Rhoih4xse4eS3+Hzekem9O4pd9h4+2w9G023tYwO2ISPsUjJuFJOmICfevDyMWehGfXUxuOmFSOeMSkwkdMglZHTKDJCTfRYccdYsA0ROon9pP1R+yPrF+22KASfdCGU20GxK0/Qn1P5SRKaE+ihPYkSniskyj3YnM9P4USe0fcVncL2+rQudbb6sGxt9WZ7iEl+yDpKlJKluwZRFoUZVWfEyFlhJScW4Tc2pBbWz23CnegNuHD4wyscJGLMsmJOQd+yDbQ3SNuoEdH3UCv3vDkNvTco28qonYuGqh5T9E/4p7ijSePBX3vT3lotano/45uKt4dlLB6L/NffeH3jkrBVJreGYwQbI236esnxMu88QC/dwZJeWNaWQ4W7GstP1tc4w7oZVUaHoc6pvcEsJqih8AoVIUT4nCPxZcQTyeaxZ6BCrAkRB+jUlYvjx+6kih7dDN71UFeHXWjBXcVCKcs/UE1/t7h//sp+71dzPkbwLm1wVI3eeMZLeOz7pHa7eB6wd3mJaWLB2BmgzTxt5yHVcXuPeCTvIXePQG7ynEPY6WkzIrBLGpp/FDmh11v4l0/xOOQkJgSgrInUNHEJTuqtCF+F8Ei0yW1vCrpGohLoqDsYRlAJ8u296MUpvVAFXtoCmg4CNbBZEyWFDKyOGWcK8tCqNWb5DXDu5/wkKS8Z/f4E1zBlAGZnOTiupVexiFUegmVN+1JvHEoS5buADcsOswU1BtcM8buBnY503sU80RtnNq5ZBWrKsk9laSMLllmscQlMBYyv1W0dhccFqJmJZXvwPJFaogKiNSW/ujSPU+76Yef513UHi6mV6Qynu+HjbNGewshUQxV0JZrWfgihymQ1BQ7gsBMFqHOXRN113upPUKtaj7PvUfbJFu7BdwVMhz9WtfFGgxYuH7ExcWaSLp6f+yT4QW+S2SwAOhnxwMkNakjZmzEJQlG9OmguTAIELk2BlKfpfEHJb57FggSfxA0V2O4EgP5LdCyh7Oyl2nZw1r2As1rqZa9TIIRfSloUvYyzWuppn6Wxl+nZT8LBIm/DjRXY7gSo/oFY8LjPGh00CmeNOrFAZV/1+M29sCRHjvnwS0/eYREevQohMUlO3rUqyeP2uTkUTk62HDsKPpnNXvodpw9KxR9Q4guCsLjNwvHgNzGY0DVQ21+adTIKYh8REbfx7iN7ugXdvkdwhavWrfTrpVFg6XHFHd5h6kPKXFuM48DHTZ4jC5a0pn/EudZ5Vrc/jrmpWilx5A2TiUNqLF1ful7Pnz1/sf+8sdsgN8g/96zuJ6T2v0Tb+nUTQ/3bXr4LxbnFvvhnft2L502bvj/FYvHa7tqu6i0ezz2qhp88KZh8rUQ7G/8dOHjv1gy67tcsrcr0Tw00tUD0R2IpFFFPj7547AtXJVtPQS7ox/KwrAcyXo3y+5/ODvupVxyeafmsjPajgi7OLkHuVw10MBQq4I5gosQGJJlVmTBoRWgYtzmWDmCIWAVyyPjIwFmYWwaG7axQU3WoKapQc1vaYO2PdmmrGgrwqVK1opBcysG0orBU2/FskgeZj709ipljeiyvPgpDhEtJD4OjjZo0bYe2su8jJyRydb9TWpdMhRK+ybVgUROPxJ7pB3NSsy50mNjFuLkyDs58k72zcmR91fdupMjb/NR8r88kRPw32o6AX/QKRyB56emM/AvlBMijPutxQSOn+jQgnXgxnR87IWa0Iu+jfyzVylg2nHD+cgFK0hX34Jgqhz/10NDoTo+HHA1VD9x70ffQWbHOmGfn6jvbThQD47sifp1spOHEi6WfuSLVdAjX9chugqJ+RkuThZhJSpxTPQz5EdGQoyGVKvPNK5mqEso5Ar5YpMQEmGBjCSuTeqSkUTkSHWrf2z8Md1PxMqPi8NiTd8nTWR/WxoCIcFMF0GYKhCIDR6EBlkCeYJ5KfHSfinjfa4Jn/I7JS2WeP3FFV7rl0vK0Q8al3jfxeNR3yYpF98mKWdvk5SP/jZJUH+bpNz0NkkZ8cTx4UhY9P8VlpFB09skP9Tl7QrjoVFc2ZXhKNKiAmmsouM0EXkwQkQfvBE6pQ3ObQqjOwsnZmawM3NiL6b86Mm+mFLsJj9G4pP/Igo6fkGZXJVZrvYeC4kN4S+R7uSi7YRjN23PLDJ++hJs+vwJdBPKnl6TbZWj+0mj5kv6+40xWXH78ldKybQSJQxMctyhnx13Ic5x4PVDHOeFzx7nhU+P8xo+ENgbu6Cwkb2fM4Ci+Atx4gOGwSEoO1p4V01P3Dwq2ovSHS5L7Eewu2XMvtotlexRKm9MRU8qege7ubHL7qNtI9iRsKONzz3t+zxGgpw67JUjL+iB/h50OlZnPw4JZx57kwpmbJnSSxt1+5DaYPfiM4gV7D9QOW6nEDuxOLakRsR2dmq7YAasprpzAqedOlBGB5nVaATJPq7AiBaCHu6RMvbsxtxdxpndWA5g1eI2Cm0aT8gY1uBCSkZHwe8Zz4z6LAZ9QcKQRQf7XpXZLR22TOJQX90sWT/4Dqvu30CUSz/zafz7r8U1tnCOpPz/6HXRp+TclG9PX+RAwNsNPmCXLukAEcDxMRTIBJPjFd0r8MU2KQdIEsyzhlsXhHBXEtbGmRDWmB5Gj+m+Z45d5FDKGFdAKvp3baGvrX29GTP8V72+cKIjKI6ylJlRvZcw2Eq/32b3nezHHstU2ViEVW08ChSeKNS2FebbatK047IV9QpuUTQymGrXLhSwvpOcd6Y2NHsos1hoN6yoLLF0xMFZ57Cj5UsWcSezoPwiwxE2y8ZdmncZhZXrH2SJyEDy3XBYwOTzd6lOIY9/p6CGLTLvFA3tFiaTqn5yp4eiuDcb73mLHYin8HWZuI+6VAaIx6n7qJdDqAoWEN6bCUNFYQ3pPdTL8dpfvf8TLxz6828vzlzk2fSBKs4l6Wv+whTIU0EextbI3sxVtkhCrpz2vHcf+FDm5iEvvtab9dpTd38gcxGC3Ej+46dE6tCr/4HR0Uc+99zzvvadCzJXGP3hnWe+9rvfee6HM5fzEPrmX7zz8m+d9vFFmZvRH3new6eOmzP2Zm5Gf+uhqLu7+4bFmZvRlwuw/ujezAXdcgqeLC7fm7kIa/rMFmrcSxOr86UF2z78g8fv+VDmStKPvPPdH3rLT+JFmZux8eD6O7eu3fKGD2duRt/R+ymuxuOLMjejv/xSoP5n783cjL5KqvEPizM3r04/cfsaq4WZm5x6eE2zjnLLfNkk0w6vTwZaBE6nAf6gFnJzLSlzOfoaQtrD663idlAnq2E/tzhym0rTaaqkpVMPf9ZQU/RO7hUu+mmIXY3iIIB3t1Mjg0BAnfK1zDY9k8fk67grvciOCu2y38/R2YPRQQZ4KmHgcLAFM76Qf46UcQdnLLPKk8v1EOfKPxQUDi3tNK4ZC0Z1qEGv9IpDnJ97SxhqjA6N6MSYc93xhk3V3BsKm2GNyruwZaJvtIRxiYwmDTFjUmU8wbTpabF65sXHgpIc1Kd6cwFVDDHkVJZb4zNsZclb3+w4OOxVBrQgdhg3nsVOOT0LaEJ8xL5++OR0BNIaBUFAntF/YULhWEOZjB4IgmznFu7k3u3k3u2R9257Ue8Je7c9J7B368RdEzZtexs3bVH9HX2JC3dbX9JHfeReNWBfmfjE4lqG1+Yebfu2B8LqOanbtxdzD31fjsai/9CVQDOJiRubqLXd0W2vQzapXfenyNVglfO/2W6mGjRMdAiERAwQussIhwxLEovW1qsmm19x1YQEdtX0OYyG3mhhJePbHu5jOBlix2DB4kOpeT8YxcmLQL58eIId3y5k4NOFDHy6kHFkIVOCe7A3DhBSX9CYaKeYlcpah12i4G60A8QChq57nzdQq+GwG3n8KlRNLBDR4/phF7+w1vnWbwnMzxB+0IjwFfJHPz86xP+Y53mYw1qsQC2A1uEo8OSpndXVwxiEsSHEwAGqQ0LgrlLRpkjayBcearW4Wi8a05a2Si1p30XtOU+1u+JQplG/Tns+a0Z9WbiLM6xI3VhjmH9ql0/+VKMnUDueXRFRhvo8zbiujiscr6OWtPHjkD7uktUv8mMfSZIK+/ox14svQujORKOG9agQQ6d8CZV4cMLAKwf5yjJD6wgrAznGWB1sEvtlIn5xp4O6lFABC0xog+6jJuAvq0kVwwznbAeVTjx0ygMGEKhcIG2iI0pxYX7QmHobHszbkErodFeww32M1GawTpf+y9jBe+m9+H2oF18VwCcRLhHrwcdxOmFu3ZAwJL79IJ4l3gPwDtpeaax5YRAfxJHgrzqZRWKmSzjsLD1yV+LmZvfhXC0C7o9oLOm91g5xOH8/xNbwfS53x2DM/ZV2RzEF9mh3jLQ7tmt3RNNL56w0dU7Pds6KdEhtdsODTcLNC1Ibq3ONWQK0NNJta7oSh/roS6tZ8p1Z+mMlrRZ3IGKv2MXnYTYoWsnUmGbNWXVjGSdxxNQGMyune76D8HXkppWXjAh65ZPzIC3bhMfydTipKMetHLX+EizF9pCkhz5i+Kf+7I+AK2hs4qRb/UtO2GR40/YnaTLceEw7vppjEy+6eftJtOLfsv04zJPnFSzqfmZRD3OL+jUwqL9m+wSDOmp2IpbN1UfcENiGIuynnMhnp3E7QFlAVoXdgPOOvhvQmnfdDHixo8e5kKVjxahWf2t9B83VGK6Ngad2jd+jsdq1HdA3sWzRzopQSdKuTqROT/USY5rNuuCMeZbiMO78Itu7yEy6SikabHscbUa0U+pEt24H8ULbyciIddhaivkMHfHP4Ah++/EzY2Rj+orryB2JrR46mWTcahn3xO1zqs82pnkzAxWX6gJzgd+6zxdO5CF6PZhR79+oN+f7jQBoZouqtwtWVc6ZJjvcALEHer0lPHakIyKNjByOQMUYG7DCvxK0g3Ad8OhDJzS+gRyt43dVtcuBBJ9V4z/h7mlLkMFJW1tkY+r91X6tTDusZumooJGl1ib60C3SUrEBHyLUiW11229SW92et9Ubf+/a6ovHbKu//U1qq515W735966tvtncVv8DuNlClsSiNiMiT4ydf5dPgS9JXGEDxbyCXAYC0biIT4OvKQRvKgZLnv/iaJ75eAzqgZbU81sRh3Iiz5mWSK1i9jTFrLd0Pl1DclaKOq+70atRVQ3Q0AZ0daJgZ1cT2PFfkoMdPEwAO89s9eG+9NrrNp74N/uOtuh/3BhzfcuvWMGueM9tr5LvVMF/R8G/reA/tAP+B0WT0E9R/t/iaZp+J+urGrf4ivsBkDR0v3qh2/ty7wdz7x7xvu1I2bsH86jfF+/bW0V9RwuiYL2Uhbjvf/iN1NhoJngQsWHZjAd0oL+Xoaz6f6YVAtHICkS+ZCZuJYO6v0D9kh19PmIwRr7VPu0rPCHFu/MUOaJJ72lJvbMldUdL6o0tqYecCVSmfdtYvSoip4g/eQCRZLxWz4S2ZugaKlz/lIwbfRQxWCJZ/9nm5tI7YArWJfQUSPkeJIhRtCqnGqZTE90rAW7eVl7KBeRt5eVt5dm2Ij+T4qcNl/Bpk9XMFzm2pt95BPqOI9BvbE2HPJvpXOf6iYGuwGBLdkvIm7JtLECkSLhS6X7ZXXfT+SvTh0VV71MFOew4UeyLS9hJmOkMxQFpAHdCpjoUzHeG2CnxI7HrsxtJ26SfvuM97/IvTn/46nqOoPupe3H6+KsaaPiwVuovT39xcwO5vTU5Sm+gJuJ0xHWbyEOtye1S6qaU2ZsQ0pNuGUm7ljeR4zKcfmTXXHh/HMIhhA41hVJc0Y8mvXwk/Ua5KXhG3AZnEImjptDBWD+i1Lrgs2Kpydz0gqagufJyqHddahrr6KbbxmAdGl7e1NYLbFsvi0viXhF32ca+hlv1GvZ3sXuFbe1ltrXZAAOVjyN272G3m9072T3Fnu2Ywu6N7PakC7CTLQvDXizwP5j0pbjbqXwdnJ+XV3QY6k3/y7kknpq9Bj1VoFgWDePoE+VlxeqkDvLEt9rWyYb1n3GfxNOfyNOV9unKhrBr9CnurWqnifupt0FEnan7MjnvwfsNVNmU9K5tEJVHvdEDN1gxvwIvi3N6BiphQzTmSgDUVOqnUM5opbxbz1QkSnrhjNozQdSL7qJ1TKbaWsZ9NDWXC+TBifQ0EHLEe8x9jVxTuDHpZdb/f+auArqRJMkqi1RSSXIJbEuWbEVmu4feMC7vaofc7y0zM8p1g573lvq8e8zgcR8zMy0z8z46ZoYHx0y+ufgRVVLZUg8ddj+rEiMjMrIiIaIiKTmOb4+SOb5fZtC7lADh/kmE+4rwgPozhPnPB9KoqVh/lXHJ/aDtL0E7EbQBF9/W+yfR5uRd5wPzulhjcJ+z8e1Cv3fL/f5NULb62vGrJ+lYBR0JMaFCBxks8CU+hd9Kra/UHJqHyYQTvc+N7HI10DCpLqDeKaP+XQZgudwoOw/qa2QK1BuwZ40RF9SBPCAo8t9nHJABn3j5999IQ4yR31wgo10m48eUDHDggcko44+qiv9P/U/hz6JvAfm0jPw7SsjXTyJfL5CvC/LAWuso1u/5b8UazUwpuWXy7lIaH1tHfpWn6bDs5j8s9hMit4CbzuEqxtJfQVUbqbjVdUKeVlVRrGuKPC1WMa3rjzytpiJc1yp5Wl3Fu65r8rQE28JHVdg16bIlfOMogRfSCiHwEaPbz5TtYbFZxB9rdJtIi13rNrcCU1qOjFyqhlftjIq0K/FzKY/EPN6z0EKn+KozpPb1ojZZud57jLq0eoR4ofJeRCGk/CMe4e0gdLH3mBu8J3EoEnvgZ1EISHS99zwJ4TDwVRxqqd7Cp9ZtqrfwEILaQvx1VnPKW9rUnhrRvkVBMEJv0NC2mtLG0pSogCTUACKs6XgR3EIoetkjPFL07rjB28Z6VRefIdtMyMWU6bulwSZHdE8vHjWbugJGooa4D6C51nHJgkzwU1JyOoQI/cJV/YEBPIgWPJ70CO9pisdNN0iHGfk0V5wBCe4vUsquZTdmx7FkDBRFM0fxExgoJ1HEaIFD5ZX0V3VwMxyOsfsIHOunfwfNvHIgUMp16SrXyeUjfu5klV802Wu+nUEx2F9521fx0EaZwtXbpXJw0KwU5cmcv2zyleWt1THtlzINXJyt/50RHdNEDVd8MpxuHP/uOBmdexlVMgTekDkjPj589Xia/pQgUMChIP1p7aH5FudnQngqOAtzyeAtUAoWb5iKni8Y/H7GuJhZfGPlvv1beQ2zfyN5QyeOap8nGsL6i4ewWtLPkqBPjIENWIMyz4I9EJ9TnOeNrXDm9pSKYMqz8CMQwjaprqF4ikGFUDAlD6Hq5FpYNxhOsCa/++I4vruTa79I1Y4g31CMJ4+jn0EPaNgZreL8vFKCSk4USGULp+ZErZyacG8yFfOrpmDl4lwzJOtAW5tXaeVVWmSKKq3jVfJ7KrCiodZch9ek5izCWteVH5QefP/3U+39Lv0BwIXeFtBL+Alu5ny4NWkOJf0Bav2ga86UmuzP3aPWDNSrEG3OLIdeg2iCzs6mlFLzB9mZRw8nLNLr6lxRlStFLyfpz6J/Nebi9OckFqc/P08luUEi/QVNmRgMttJb9pdfdr9v2feocxIdnZ8w+SncZQwDvsrNHM6fYWadvBvQtOjw/EDJ0wGgyGtxRRbfYvycIQ/vmo/HXobfN5DPezidm3P1bvoOETm/vVZb3zdn4fRR9rxn4RFYsU3x08icj+l5fKf8gvs+jzd0qfpagde6gHfFiVZ6mQslVUpNbYS0TA4gYavj3eNi3mpZ8Y08+XddCYhrG929vco2ON3syJgIzuiNRfynrubQi00GHtsOVUWf3OJYXWNwcKXGmeU/eUkDmBYF1IGrqA5GWI2rJJwSU/0W5gHnYBsGCJgTUCHQCvtcQT+Yysc/twefcxTexlLZdhtG0XY91nPbVaaqJ8SsMb7r8iHOOsai6+Pomlf1l3gNu0Ecq9ghAOI/okHLqxgvoR4G8IDamR0xhIFk97gj3CY3PKQRY8kpVQ72phzDbN+htTOgYeOoa7fQEbRqxyBFfSrRFnWOXsQd8dXm6MfN0b+ao5uOnrLYT5yGnuqA8E7RYWN02JiJZ5ADmEKjs/g52LVjRmIgpAaMzIBxyTuQNqjDKva3v0SuWryz3JvSyQx0X4EmIPxSN2SSEboSVA+Y6j5TqOQOjpE7KJO7SKiSyZSd+Hd06ugrzdGPmodFdV+p9kF1X6nuz6ju02BGdUe9Kz8Q0Q0/ESYbHETPuTsSclMaZCh8f5wMTOWBeRifh5pgxkNtDMN9DyRweqDUBUpdwckrzHJOeufhpFng5Oj/Fye9/zZOesrJyjJOrpQ4ScsIxK/bIjq6kbaWLDMsLs23RxOm6v5oTR+Yz4KKcNUNjnN6ULC5g0vxnRz1HMrvC5V2luuONl48PNYHwXkYX/n/znjz38R4EL3OKW5dN6nklSYE153aUzqPDbkbthnuKdqWiXBEhkOYCxh+DFQxCYxnk0AwnwTGsMvNpnCEKL25WXYUdprLcrdm7FXZdRACLqsS7aFzq7TJR0L51MrogxtYf6EpaVNPrjpTptaOk4LIMU6c+kIrg+2JN7z+e+zphEY0wNK8cKh+WoyKN2k4tZsyLaziamAVbGNKBfG1B0K8fxzx9QJx0JTzZg24cKgDk+UFAiCYgP0JgcRjzDKXAblP60JE76EQ4QkRKyBCbaVByCIRPcF6jJCMBKVJiRjMe991xMkm8aNzo1R3/hM0sFGm5RKPE5Lj7xhevQPraIwGmDlCi3u/0tJbpGUAWga0zuSvCy1MyTbqbpOvsYi6OVHUsMNlhDWYMBfowGqcJE0ZIKWCKSdSZ9eNWOLhLUd0gILBLpZBpXmEOjTiJLfJJC3KObuFF0/ntqOfMXZr8f3dwv+jZlyrJ41ma4XfDx9/XNrlWUEYVZFUyjoaMrI0ok157auUjylf+5zGU84tvdyuI/0L3r8bHby6rIOH1JharHQaJ/qZVgBphVKMwbTwAhyqGv8txiy9HNCI5y/x5S93Apa3grJKlq9F1CpBrgocwUmwhPocakioV1hTcBi+gbGeL18E+DfGC3irvGhFIKe5lrFYaNYHbKPNmsJwS/fwaOL9aGJ2Mhng+UN6LKwfMQf3WEb3Em8bhuTYiKjpIleVS2Jc9IhcFR9R+FL5LltSUWUkKggJ0kvBNrkt6D/YMuIj9/GRTNn7YiomdBDHATq5bCryS9UgZJKHvKMBAh8w1szQ9croegW6elrm4RHbsHg/I31UPcWeR80JBYyibqtc7q3spyKBWbI4jqRIHsDVoxCPcBFlxQkbTuJ+D+9xNfGuMTH557mG6pOQRyAOrFxDzugnL4MT04Rt/myLHzyeV/jxKgw5cabXnngiK7siLwGkzfU4cZWa+rV5h/jvzNCuUZtfdLtOCSjv4xGLuN7AO7/nhlxuiE/I8iPIp8peZJP/tha7R6b5VBqA+9gxbVCX/GyKSAC1A/7ODIkFAOWVaAutCPBjrdgcNg2tEwIsg17BCyumra085BGBTxTp4Dl1wDWqdIo8jh0eMHg1hZ2zYL/4niTAmx+QwxvqaK1QtazTFtB1/pThROcEC1IKX+K8IdjZJ38qnNZMTdzAC7/Bs9YXyyyC2CptAfgWtRV4F4ndYnrKP/RpaJ46bKWaxKADY54yiUyFNPIi7HOZ25yk7ysHmJS3I/Pxh9w+6tRAHIlPEWABu1Cynrr+cyRDaE39kPIjdqEYpZKHDOFOiJfeWuT2xNLYl473ykiEhAULCYjAudvcmGc4pAVZfnQ3JpftMk9Z0OfmyEk+8gsm2LI3eyLGmhlESrgcLesht7+rxyMiOjAsRKuQvN14OPJbkDsgp7jdxErioQocI7yCyOnhp0+hjA0XnWPckLcvQzeaKTuBLlCX0ocUUXR4Dr6DPX2pfTnOVNI4mIIyPckrCPTxKL/hyUi0D+mvipMXVgnIIU4sboBN8svGmPIt13FxuQcOC3coxvzwJH74OMCP1ZtjTCEO8GOKcIAfUxWH1/GCBGcAVyIZgjymWAyzLpXQtRy6SEKP4NC2hGDLRQjpnWQjCX4Cwb4EP4NgT4JfqBRTkBx1pu/TkzLGf+4b05iln0hMPIAu3CpMDECGT3wbZ6awOA5BYKwH8UGe8RGW+XJXN6gM1eVlSJ7wgBC62AtYHaAH6jtSAkfxolNS3x2gyHkUCm8nJn0X8NXWn8XlDes6ysf0wcIx/fPUlqZ0TP/rFRTKY+TJkT9M53AOf+Jjil8xJtzPTV8IZi+//qWFWUe+XVQrbwrEe5GkeGR2sfDx2csychBNNQSdrzpVyZeWESRWFWPOED+qFOH4FnVmvp4NBqopllQxIMfy2SFFvA+WL2ZtFe0nevfC8S8JqvwoHZYKb5LkL6omLn316iu1anp55Q3elQgVHr41rB6+NayIISzrnkeIMSEZ/smVRoHmwdeowoS/UoREeqG/JRy4iNmj4YqrgqEVkJUh/VUSrma4TaYiKqko/fmvUFctWiGU9l10G9RTOUDuwNtQ+w2EDwbH08nL7tRX4i1qcTlhXQxsfzj2bdAzq9y61EXCX1w0KJqIH+JnTUAYbhfKeaD9ViPNYKgzWl9m+GqRfNx5mgxQ6W/mWkmVYyGgXM8hDGtt5JBhhulnC03RB+QW79xWQeBMuVVcWKOJutqFUEBsx4V8kMkl9vjySr20MsyQsSe/b8jS3wJgquaF86wwz1WFMMOU3EhztdQbpOMzV5U1jLroxojtcVfIyArlskRQk3K71fQr8SqIv48iDNcgPoTKbwMHvYX0Uk65VF8tpHgnUkKmVbqXIg0pCrlzK38mXSaBdnXuAknR6eGBAc7hkSb1lxakUsGLNGn7JK4geAFdkH8iUbxbhGr3W81VfWA3VXW8yXVGBpJd1Ijoe1H7/Uuhit8DCwlsHOoYfprLv2meZ9hQFtyH3sxEr5L+DhAFDyJF/HcRRxDS7POIzFdJnHzl3Br3CzpPLX5wCnE7omDyp3/0Ff/GaPc56IG9AUlDwVIr3G0uBXmu1R9BQSGtiQLwt6f5Mecjg0fGR9gYVdSBKokDYC8qj3IaFI2iapS/M0PgQr6qN+R70wd3784Hv27h3p0HqPGJJTXe43k1rFUWK3GS+qfS14sfezJkyc+QESAvvg3+VRRgPaP4tqequ7gMxd/gqhk0ljhO4yTZFWCZHfMj2JsEd9lI29N1dEMFwA8ZirB0cc0PLGxhAqoxGR8QudMgIGZDaQnjM5BFWDyFhu+QGgffLFeWYTKJRK9p45xwwUbOJ3j0QI8D0mxUEGXj4qoDComJikCXbrfr1qd6YfH+gZW4tR+erfHWzeO/YN/Pd65WtJ24BQRCDYJR4VeAqIor4IINbg3DCFSJFkeUTJnDNTP7d2PXzCkRUhIymhJTjQk3luc8fICLfLg0asiWiQP+jmsNuQSHiAM+RZAF3AlAOV+FRkyCyeSCHA+/0FdRvGt9PS25SP2IQQyLXxm0H7IUfopLmxXlVFtWdwYte3dNKk8p0jsND+vjJiU7J5I8qp9MMtzmgwSQh2iFz+s1QitMRCxEsIbKdakryawl78zz/WX5bQWATQ6173U9HF0euHa+i+p9LbV1w/ISBiUdwlQD2xKWbcUyJo97YDHdKPblpCbVTyZ5IB+1H6Aorcxjc+LjZZQVmf6SzK6u2NrUBc1dah+47pzmbkGz632t4w75WlSl9ouHrn3jNdfc/fiXqGhgdCncpRBOGADqhc4fCgyu2KIWZMyQ90S2Veo4n+TSkMqOQqAWeq2COMZ7wuRThep4MOJU13HZwq9tJiS+9uYgPGohYQ7DUxiewpA14iIYqWRbAsz6XAKSqCk//MYft0Bdgofzl5TSTVmXmtzP5PPPgetQ54XQj7M0l07RPZ1w5cMHN37hC0963DnhCJJfMixYgy7GbaSHrlOqtXKJFyP6kYMbcU/e8ordGy9+0Tc+9pD52aMOx1dzXtg12FBJ8RdSVxPv2rPr8pmG7VMDjwFF+eu/QSE/ccKKcxOqc8Rt7totHXVjfaguO6R1iOGQtmiEr/4jvi/xiPX/zs+Iw18m4QgAGruZJS64SZzVmGbW0oasFPo05CTX3M2IUchcazeDbzZktiS7Oc2mnFRDHwSgmwkELU84tI4Mhah9Clw1dIqHGnm6kN4WF4S0vSsahNM+SzIbFeNwIhb+iFOrGIoRBRKklo7CQEYhaiXURI5BLapIkJooZHSYGejj/WSmCcGSGg/Bt5i03AWlkzc5OUR2Z3FOA4Xwm8JHQV3AqNgL9ajuIu35i3FmJctEOs1/F9GF9+rb6lBJh8WHDg/y4UOdYhBcnJCj7oFoGS4+sGPUPECnVtCpB/fabiNI6IJiRJtCLuZGAz2WvKBxKd5PmhUA8UZIt12OkE+zHsghs0RAbgfqLCWzI/QJKoxFkvcA6PgI08FyB7IFAo2aJJxuKacbRBgqNbK6ZxGWB8JyCuk0hVN3ekrrT5KpeoQZfKSHZrRK7UMa3/iNH7vnsdw+mkx+7qdMd5OnbcN/K2xLUthoeWfDN3cl7PNfdLY6u1a0Wto+6roIC1zy0FCUIS1AcvU2GxMnZ8ShUAcIVYubeW1V9Wg1iCokuCpHKc7gijDAoQh5OKUCpPoT92/ANfJ1kiWYx6V4we1x3JN92Vd5yOg7qdhzjczFCD3JRTh04aV1kwCcy9qWXmxcxbf5usy6FGOSnxJ5DGZ7NHxmF9FHZLaSSF2sDSZ4RXgt7cFwklfyKTU1knITbRKiIYBrLJOJA2dk5qS6LMfqYgrs7bK4Njvog8ICp6IWOOLRpzl13afKTuwjwRTrwp6eQK+yMPp7w+o5fr6Hn+v8/GOx6mccoNVo47HBqTFUHQHveKd69kttuyUSa0vwA/A6jKrx+5/sfWd8G8mxJzAIAwncXe4T3761qRX/PSJIiiAFgAAJJkmEtCRFy3vOts4bLPtliA67L6fdvZzvbIq6nHPOOeecvl/O9+3yp2f9fPWvquEMIVDO9kvSj5jU06Hq39XVVdU9v7WISzz+xuJn1CCY+unKiUb1zwRhh9oka+Yt0vifCDO0SJgdwz7HFKOqk5cZxLw3fh2ff5uK36Py+UqN1gwNLi7YvM3dBBG1rchMjFahSf5MHKbjPwiZZ/GCmqoDLpll9SgBII43qdBl9+A+437bBuFVZSavJHO4dHjIaatwPJnnYTZZwKwSgFc9cvHKgIjW64tGowW5rVRKFoe0KoQmZln8EhqcNS/LQUJ8rqJBrCgc74ZWtDP6H43MWRzR/NPOPZuThj8dFQvyrCVDeE0Ou0+lSG3RtMSTJiK0hvIuednGPFq4MtTaLw6xgKVDrR/d9PKmJCWvNJKPb2q6NqLh6cCieub4iMmfmPxpcb1rSY/3Q6TvF/z9wpCBQuvKs2LGM3Mms9ZVD0pso0aadbjRVtl6ne2p+zhIED26WIAaTw5z1aO/cAXyf7wrUR+d6UqM0vrFrJ+2qonOENGfZt1tu1O0zH9McnXFXV0MHbTRVRd2zytM6vXArTT1RlHJEaNmhBBYyy3f97eiVFeAd3gdyXUHVT624rtKw1hr0GUNuqyBoJ1y/wupr2WVBWU052C1BkD+ZERD2qxVrDE5vSeraLGNLRayasEgoTBRUZhpW7pnI62iPCunSNPefhZ4uoiYHcOZvnzkdFHgy63iE8FTcvB0KXG+/8uETlq5rz1uiOSzodPWCreJ9r4AhzDKg0cbPgY/Rg5CKAcfoulJEOqn+GmzGu2vI34iw0+U4udsDJWddXlphfkTmQSRpoEWhLlDRMP7apidPBNmlL1deYWG5y8LYknMF2O29wkAU4Iqvzqq+Nd8XPFPC9ZUkWajHXZlLQGIT4h5FDCaeR0Vs/OX913OKF7AenT4pJOHS0+L7ym+O2nxxVBztnWspFDJ4QWo5MvPRE6sRFSy1FK81PJ46WU16bEmva8jYop1Vsxzrqdj3pLPNICGTBHvDYrfhwJjqHERDVzCzORfdxM6x+gwV2eyScwJWv7McVizXCb/BtO4tnaXOkqRyaaUb4VMTYGE7q1gTX7XlTC1UXQJk7CCCsGF9Uf/pSghe+NBViPIIj3mQSZPAfW6YO3B8RickcdWyZjVZSWR8MYH/8xDUuZvHCXgXUAPC8dHJCdJKFLhzzwMG7z7vD2clUeb1kCqUKkOsMzR/yrmEZ81+isFtrAqv9vYlN9r2JDf62g8OhddDDdMjBZ9A9sSIbBiQDJ6VXL0qqGm1NoSamEb17FC2c8MbuT/Hv1npeUEm5j/k/vJOq5hHTf4nKn463SXzCbK8nr+jzFFK86QTGVkB1SVMeNEhMj4gFVsoPCnTRU8PqHyplHxIkmsrIqVWYmZLjlpq0yUf/pA9ucg+3OQlcG29NMJsT+H2J8TsgrCpkDwbxJeAt7LaZBrNr9XT1QuVuuy6DLUPGiRoCtqxjVweAgVo+skp36Jxo0+6odJQVgSyRWNNM0Te0cTE+jf1+dDUOdkuyS0120hYDZy736YH7zJwwKaRNocmox2WkSfAVpL6PNqxjV9mg1CxMMOQWP/eVm2z+fP83wq4cxLskyqWEQT8bummfXtaTUoCL9nbG6skQ2fCV0sYA5VKU0OYi5k+fIrT2ZBe1I7s1EkPfA17ydqppAympJW0yQNNVFU+ODdSUsvOmocElQKAnFejhNh3ar8vIqNmDbMGF3XfPUdmqln8zeq7CPoaDeN2L1TpZvAFaSB4U12haqfZEgkDP2r5DT1JAUtPYkPrDOPNtLIU0jbGWIlG/SGte1iqFE3Nlq36NRomOksVOX4L6vSanneKxl3mlDr21u0Ncvh+6isstDWbYoPvaWf1aoSvkJK1E4avubBrxGawy8hi0EUInTGZoMeNXRa+P5kZNX8nXLkVLEH7kmqBJ5WApekqYjIMd2X3/uphAOzCm12LeNvV1nT0/lkBoFZvduQ/Jh5zVlt7qsWSo9EAoR1KWUdDbSM0M7EsOJEjJyIMUrcH55zchPp5Ul1iMNeQWzneWYzE52LVL2lkbc0ZmXA7aqrbECPbVxRZLQIiZZBomZe5hq7nJDMOj7nxT6Z7giheYvvo8M/jaTIvrMf+eyLcs2S+oM4nWTHauipOBVnBXgGpIuOs1BQEBrQdtyD0tferWNIOm1aIwKqbhypYOmkS+uNWGWNXruNdVZdOAGWyVpdE/T5lqWi0VVmqLks87kVsr7YstEX0BGoq/vPVOT4+QJxZezvkv3O7G2h3DZpx7JqGbMVcdUQCVNiZXDM5IiUtZUxfI1kpAiR7/ruPdkD6luMOtjCiomCBk6KoS0nzYjKQD0Lx/TAhA7z6Sj7D2ymbtyoGjdqxo3eacnLEjvK2R9nf1PgdySrH89wQL4+kXeSyKA0yjsK1Nop3jUe513tFO9qUF0kyzKfWy0nR11vgOoNLeVdASa1IzMZUQwZp4RrK0LmH8+ErFz9sF6hcIo5fLiFSo7s0QjNU/HLQ8EjBY3m7HBuT+IN2I0+b/Qx8RKv3KfCeOHiG6Gt/pxLtF++UxKjS29I4WTULbhnIeitctLZHXE9FHyoQse7p5kQVEA1UVXlQA2wLYoMynAC6rG0dCOwXDkRl0yEWWl9khMKrIv6XgLDTPU2PTPkB/8kSWHICIQ502s76PFPEsjtJvfADjH6aIFcvG+u1TnqbjNDFdLOgjGr2/64UdxJnem7c5iheoW+gURtLuZIkyafcoMUNQrWGKG6CC05KupbTNJKrZAdD0Sn/RHvHDoz0B5+rfnR/gr40T6TH90n8qP/BH50T/OjT37MjvDjCyP/zuRHH7PKj+7j/Hjrq+THJbxDUpsCW3FvYyLGOCnZQtdnJLnHqwYd+n61mY2bJ/MQtB49G9bHTSNQYjPY9Ka3vPPoWazIZOvPFQfRoz9S1BaXvcVPmgCQFJFp/k0lRU901gEHa+Xv4O23xIUtl9IyNCmTIrQOmWUJkVLdljtlKgpqp2znVGpIDJEPHfWqJoNPJTcxONQsejbFoFIXNAee0R0rWNvHTY1JO3g9ueV4/XyRd3550Z58VlyXPP54Jlt36ujg3HsCcfP0QWgSX/dVAbqFimT5umnoHVQPUBUBbT3kjbyHwe2xZAKdtJLSFjgNQfhm0SkGZNNIpwPqoHYKrJ8JGvTeCC8qTMIuatyH4LJGMIUrcqh8f7hKHoZtnQ6FZanMXimdW+xhmdV+kc96Mi9/Q3SEsgKmyiP1xzI7eIhPT9SrxA968rs1HkXZ5L2inIwFRTKEC4qwLQB5HE82hpyNp2wm+XyYPZnel9yiHVkh1NwOSX2bXWTo8ZmjSALPgWO0MF/F1F3sDS4K9GbZu2Y5b/JYzUWjEwpYpI5PhklG8Z48rIYlV32LfGWCP7XDhLXhAi8sarXmqIHzdVYnzEslzQfPLYnEQW/F1ZIZKY5nk5hXLYt8asqrfZaPpmPU5od8WkZ/aLpDy9SZhqkzXVNn2u7palFMnprtQOQw3WWZ9uEdRcSboF5YypO3i2Er1d/SKss7SexK3JbNH5IV0w/IPuptWYJ15B8JUI0DGCZsuOp0VbKlmsq25n5eL5jRK3YaLduE5xwi1trrG7OiZQ8BUFnkl5NaTjC+J5F9rlZeqtE/QYb5tJBcNY9k+avk5Ns/Wzn59jeWk5OjnORXyZl78YSBBWcXs1eONZUryoZDZ90MOZGyqz32U5UrYZ3igW8lXb7TN5bO2My3NeaV9bCiHO6O4XDLOVw1DvdOTQQjdEMFDdXN1zkapPzlQFPImNs0Y54yF7EybcvnTsIj1JTZSG+tZCOF2UV5iHNR/Q3BHZc2t8gnQZdxbc6LEb4bA3wS3STRmzmNfhFLw2TRZaXe4kgictEja5Ke0MEGs54YRddOSNLz5ikp0DkVA6OaD/YOQ8t0m6rNyhrmP/VAQDQZieY0dXuS4qsaYoRQcO5W8lE9utY4QI7qeayZSqZLAEcG1RDl9Av3vKKnxNH6k8YcK5J5maBo4wdvSqtT1dW+ja+hVqilOGyyBgELOmZNh2Yd8mYtC9HhJdcJevxO2xzJUikDW0kTTGoqmkwPoQVzqazoS6gNLZT2Cie9zbzhLKxYEDWrsyLFx9nkXJpmnLWq9EwYUqVoy5SMgyiHu9Id5WeE3one3JBzU5bdacywe9eU30j1HKL47Igth+QYVZmTUX3f807Dt4qZyqNsaTCDhkNXhSJ6Prkn9Yqcb0o/J/HcrtoWh3iYxYKcVCQ5325CDj2laujzQA8GCR3m3LYkBZ/MmkmTOCNtskJxqOStkrwkcCMjMB/W1YluQSZu8CpkMTwltZ78yUhS/s2yX/3Lqlz9y3IqKNWylVmnKHWfH6p89E/rPHpFCvuwgIY/EX9KLr9Zrrz+2cin/ZhKAz/m0Ef/EFWCp52B5yphzjr8zkhZZBef5cWkQaRKicliZwiQKloGEJ6PcC2JlW8cRk5zsOU8NFHT5s12ap6r+qhM/hXQVpmrTqcFmxtyCKRC2zaGVYxhsTGsYSEGxjaObhG5O8qomIyKsEJ0n2aU2z7/ZmE/Y82/J2v+5wlrePXv06u/GTmj8kwcGeOU44jIqzZ/YKw7m2upEGJdorQuDVuUF4/09cspu96OhUNt2MX/rMoF/OLf82LSL4gs7+u6r0ebNemTkQ3OqiNjZIOMjJWRkY0CKfvaJ4xEepYyN5WaVd9Mz5jblAaoNOdRJ7K0LPpiGTRswHCFwcVoNLS7uxhIHtix6ZiIRZ2HJWZGCH0+0OWNe0P4vVm7R8l8mN7bd1k9L+BiqyMXta1U1AoD6ohE1CpoFWRtV/iZyqcA2Ec7DZhRgTJHWcA57JJmFeZ5mAzLFrrE5jVQIGHnQo1ifxlLonZgboj5Q8yTeyTLDCMC7c1Y8yF0xukhKQZXDH528i/9hJIjho0IaGu1Dl3TqPn3A5uoskgbDVBTCZTpgVGm5q24fSNT9dgfHgdkTa5CzT+MZyFJ3vkqJ8olM3Qp0hPKjXSvLnPooiG5NHTICQ1ETnE1B2ZjaI2cqWIZ86TeDNpYShsYO/3446NidYQG0eMENau0WaNTL0PkJ6niNFJdHydTJdeblMbp5dSfGSaYwRyfzMFuWpTVuMoW7N1IXL+IvNLlL1rptK5jKqphW7Poq/RPomnDrVVehwC1xCyyHy6iTcK3wZ7h4ya7QvHnusJZXeHt6It1hcmfsV2Brf9p0RVY0a+2K0TWFQrWFQj1pkJ9tCs0ja7eVVIIK9EZitodWgPjQ8TWmga6UnJb9aguy+yhIINuiv2aYT/+CrFPj3pMvjdPYx8N0sjINm76v6Kx5qNwz4PU34xGIZ3ZAvKpU69bL8TosZUyt0BtBNKxQTomhWvM22ppFKylTXAKFnxITyv5OHk8BMCXIHu1XBvJw1JZHdoeHH8alhQERExExMTTxt5RoBpM1XtubCZQrWJn1uok7Np8NB4AQso0DXM2dWaV9tQ8myyTTNEO9aA93Ho9Mf+iaUPEnq7GLmTxIv+ymES+cmRHVSWPdeAyEUWxQVaKQyHbk5+56LSVkQanlykljcEM5O9gmr6ILiJ1I1YRqQu4Y1Ndj1tPetp8fVcMT+d8ekkfju394FotTRz0BXfcF6xJEfPdzJd4luXix09ZLuib7Xlvzpy8cuigpojTtiWFvOfRqOeuRzXQyHWU6PFXc36sG6UUJv+Wrt+/eeepovAs4Lynu2W7aETqM+CWS4k5enHLlwjZ+rGrfybZfGirUZM1rKWrSNcs1jlJPl8M+8a+F61CYUAGSM/61dGQJnl8m2YkaxHTkgg37J+s+0r6r0tXmzikWcHsB3jOJ120FKFPpLQVDUvkq9xZM+4cF7nR8CrK6Gvek3+bTQ0bhqAwa28lS1axpHOidzcJpqQqojLaGRTMrDeTASaJFDKxueZmxDVHI15/mO5nUENFnW+997g5yBw1nNWIWQgMZzdzD02WDXPEmKvKnOsSZcGZN2b4dzA9lJ6rhghB0LOP+x3MUSBwU/cVQQSNnevT+0GXFyPo6LjwGX5sUo2GEwV1jGs6Q9x+9JeKevgLxUd/qih2tumSh33IaZSdFrNT5cK4uZ1NMlGhC4bBd5IU6/LzGbmUiyIvip95dLHIq4hXkVxFvCrxqiRXpZyvhJ4Xukwm3pYG5//cj+LxDx5HcbY7Jdv+p2vuOXL3fuiiT79WbBQyv1yN+Zn8l1MSqoYO5QkabpysnsQhVQD1w9AyTfyJFHFTm4XJvGWdmUR3iW1hcc3UQdPLHKE039A2JRf0dPFiUMmCnJx5rE8vdCBP83YWuWvONZVKPq7lrMlTHK9cEpqzJ3YLXmecTTissEMt6qjlSmR9pLgVM2Sj5uZtJk0qoxrVaB2YacXlmUdOaJ3SOfKUKpk8VCHNJ4maOpLSnfoeHxCcCBWzQLI1pnMbEys6CighCH0byFlFtw4tZlbTs5teSBtdoDMYUdassyNAVBL7GFcxl3bF14jwGSMtPaJowcUWl1jOGxJntfeHZeu9NsNnRXFZJZObAeZd1bliappNPkgVe2qxhS02YA4F0Z2HxBXNSq26CrSvoSxTecklPqFqYlQehOYY2dbVWvawPMxJtqT9JQi2NgVbNxNszSeItO5PI5EmJX2tpVobXUq10+Kse7Y4a+bFGX9HJdrsly7RusR6d0SidZmyjSXLXYHQ0MmAy7bGGbKtEXqQp1+FbEMD3X20dt8IzZyY653d1ztfBzFHMa6OiBYqeUdE50uWfg2Tfl2VfmzTifSrKplq2qyqrVbIpF/tlPSroW2k6D0mCEU0CSc7J8Kw9sWF4agoDCtGWM6qc22U67yQNBA7kXw3MZOV1cwyGhpaV16bSHNpamNVAVcko0XJZcHiK9TBRSUWNdft1lCxqPfaf9m+ZCseVgFsYO34YarAwjezODpOAGjKV6e5J+ao39DgbYDOi3Wf5Jt0tike5nlrXgV86hlcko6k06CrMptBeF1N5b+cWq+0JdiE/EVcPQy3VYoyuJSaeTiIdviKZIvbao+8TDH6r4vctMNV1cXdE9JQYS5ILnzlB5MFKqpXJdvafanQIRbuJ8sUn3sSy4MruEpYSKeXBzwLQ5mZ5UJwNh8mq7YNCHN7fTrZ0JjKq3R+tbDguy6GeSTY/zMPQiI5Bpqi2QrJTy1GfaxSSnOuhhJnEmEJV9RYcIC2KL4GzIR7kiRAgiXIVY+MwoNs5YiSgNTWhSAr6AYZx1wGGKwMSFnAlTzWfUxU/i3o+hfqY7kwtM318fsioGbTtito47LJwmA+79isKgq2WPLbDEAVhSS2RtiyzkR9K7625ijZlHaENW9Bec+Ay4tsrc86I1bPCCGiOGx5Q9exhW1ckwb/pE8UM93jy4hEaxGCaGnkUCUfOaR+4Q2sovBnuNok1wOuOurT3eAbkHtKGjaA1dfKX5e9hOQPspbm3o2sbiymaQOXhR+lHXoGtym+ZuiZwLIRxPi7FyLMhcKT+LsjSZaxNya+cPPxILHb3lHRp+1hlodZdHnoptPjRa2VYPMAl0OH1bvNXsWIzdDAAToYCEhM0XqXMPEObuMWjR/h3TgIC7gdXpLSXxoU5Y9bDvZtnzkp5wB3CJC5YdDw389Gyc+juH2Pdd9j6b5yOSgNZTdTs1MwOlI2jtcQ8x7ngaOBNngPeoPY7RvydltFIs+21UbKs3eT5rEvu25TUTnMxjPNLj+QFtwUFvuAatwbM6yCZEIMrl3w2ABnKFqWK6t4vsB4CVgwQ3cvFNJoTmkfk9KTLqSfxbvJCCHHhO2jz4ovJC0OOvdu/u6n8n9hfWyQyrYMRXxrySg1Js12uIbtsHISQNGz0aNGAx07sirDIxRKtjSKJFyX9G7cpcarK2IW0NCGHxre3FSerGM9G/rR0BlAztmLCklWqeMatphI6oTrPNnWzNQ2FEOKcechX2zqPIGvXGPWj5FE416UmOhOh/diFnfUzvo+vAuCtvdjBiuq7/5n1gutPyP9lDHuj/6byYz3DD4zDLfkIAzeF5Is4T3hig/877eQ/asq1TZ0FLiX7khGs87ffCt8wA4ftMOmM6KQ7JKil7ErkE4KAuowg/fQu/4hyYop7ibLuivTqjIeV80/0aepzmT8MiukxOZ97IcYqwHkFXMo8OV0/fyrSWU6gIHKkJO+g9W1C66o51r6mVNO90VZmRmAGrWFD2f9KmK/umxLDgbUssIBR2bp9T9GoSUn0qnnDKK9ZNb727qFyDVRoCSYl1tUVOSWSha2raUdVEHG7px25RDTIHgS2VYl69+Qcqq0caVIPJezW8fm1I+8o1aebLPOZK5cszBDsXkr0cU869czG/ysCccN4Dh8REgQsDctby57O+LBTubNl1KZYWZFj3ipdaIFVs+INbnNC7sdpbf5JLYsrPL/JV9ztQ6HLgmICp3xrnPLzYgPdIzqkv/+SC7m7ttEhNsPdkcjg1VJNlXmIw9HXkmYTXL3CMs2Ifr5CvSPPtTkR+GDENjIjNYxvunAt9C2Li7v6WHODhU5sNPwjkagHyQRH8i5NoS4NsPAD6vOa2toAtiUcthgx9FAFYt2QTTNFwY/LCfpWpu7rMbOsVRg9GUr1wI7YFvYcTHphp0ehTXLNBTSWBiW5gmZyl/QhEyQxdxQZV9DxN7GKtjdOM2mrk+SzbRqiHn5cpr1g6M0c81aBcjgGHzOMz7ffCCnO4OHIbGk8hh+fPmBZvs//9bxUS7dqi6GxREfb2Dj6MGR71G3acfwcrrZR4kqlsCFuv4mxYQloFaTbKT72xcBJIAmepmJjrUlD4+YDBsPJeVv/k3v+Buww2vTdn0Ddnh1+kECXaULPTABDGt2EECCI7kBe1xVwkZ9BF0b3qBXsj34P2K38EHL2w5S1qsPk9fwAdx9kHzsWLX0ycE9pl/FR/BRL+Nzuq/jsd6/hT63TLxHBi/jnoCUwl/03lDBINTQD1UlWU0kdyV8HNVkhyTS2VrPxGpTWU4M8rCKj1OoVRBpRijwIBKUrooadmxUXSUWm+ywPeLonrlGzYL+CTn5xB11sNRwBVqzPq/2WBGG5bP/zOjuaGGP2+XE+eLpMJK0Fqkb+VQyob5ckeeGW5ZvhSpr8dpDSI//GO4qfe3AmV+yQSH9Hcm3y6D1/OEQKgyOk4/iw+CtqfTWA7L+rx/d+mf/9J/KPptrlgsPzIXXZBEPZH/yYTm5fZOo+p07ZHdibF6l5ms6SGSy3cPrd9T0hb2XqNJeQcQSsWxHDnirkD+B1Wo9nUTPnFoLvorkHoEvJ8Tob7p+jOQoeflVsp8FagI5krC6zOxFH6E4//RaBKtF8Fp8CIGoKXhV9PgAmuXIyLmLoLOgQQXyJ3bD7xjUh8l3HoTvwnfICBrmJfPxg+ZVGzTnLcL8zNFy7ps2Ws6RSHMjo+UuvhPfxWEyEIYBy/iOkdHyT0Zfq9Fyafxg6VKDtLPFM3ZtRateTysEEaFJXtSRCJffQ8ZGqtZhDfInkFqrnywRCZIZHFF5zDm85ED2F/WSx0BSBcwoWdIq6DQG6P4ZmcFL4a/Kf3ak0venfUsvo/QSr1jXsVTl9LaM2p87TkDJTHUXH9PHE1kHhfbEY7oX9UeTvTrtg7j00GMXxjYXT0TqinhMkByL+edlE6W7PnbPeLB0fgGrn6U91S6piAKv4S6u4HTHeGDmEqGR+z2PJ3/Tr+Hm+atHARxL/4wMZr9KR4t0HIIdOLpg4xirOmI7K1yXzT6xJw389Lf8Ih0E9URamgAvy38Ii16uQwSW9PmHQTPd0VVWH8JgED3Wg+8yqSTC4PjWd33X77/BgXFNe/U9FeP+PgaEkdc74RAGRQPwcXL94+S/L1lm1iFWkoSKDQYuiWOWKChzJfPlIyot+AT2iMeBNfWeNXWPPg9OykYpC1auOKYiI7TKxa3Dtjb2ERUAf4TIpNXnCPj3YYlQSwr4wHo0gQI+uB7VqPOsR+XUinCFuV/BLR5uYZ+HfXlNvcTvVeGwwIIX8BKp8BLuUEbccXPDaQ+73XqBPfKF9INIF/QmVas43Y7/H0aliu4YS1Da5q1lHSsqgkceLJSL1ij/2obN/Ws8b6OsoU+cm8Zq/GYO5cPdfHQ+X7PkNVT1BUk++XdoL03OgT5yAoExKsz3XO4TmK8IC/jtbH4S8gsSJHKePGEVQ5kfbpJN4xjyj/KnVMEm85Nz/mKknS2c4zB+OsuC58AnfFubbFmEiuHwHOXzuXU1n1bSmNm0bUZCi0BD+cTP9np92darPj8mLuXmow+IW42KxIKtrn29/v9K5aruyFv+MaN7OSkZ2cqp5SD9j8i8iVWbRGgd2Y6KrggoiXxFEVVqNRUFcy5RKZ2ipN8KyEUMo8T3nyqalDnHSzs9L8GJbiTgGfMWtCl15Vnx5A6kwGm5Le/WeDhvgUY6A4kVPziPcw9QNvrFQ5nfnLck95O6md+YFTvuWQ64CVRQpwVZkglPxFgne8nL79OoiQPuGf/gTgHcT/kZTNBz9ZNjzJQT482UEznflfB0P6s460iCojwkIVjRCiFCzhAcOK9Wy2wvo8wb9ZZlyJykAzGfMtmkSKl/0L9loXsfE8L69RlZOsFiEMnJpwJ9HWkoSvZBDd7jixYwRJdqGqFS/0PFctH68E9Yd5O8suRJgS8krIB1CsawsTDVuAgW3smFDlVodh7zkbki47dMyGpv5w3J5j3pvWo9JUKZBrujI+Z7SmMs13ek/axV4SQ6vJDfRbeom9E+o6e+naZf+bS7/k+mnp16q/jm0+w7P5Z+piLSna6rcsb+JNeabSEp8YcSh5fgReVTicog9U7IBeexfHiRVVJhMMWzc1otnp3n2QRfrQvJeTHJiwl+dmeCLg/Z5/lplNh/n8HT95NJgvVZ/WLq4O038QzXhV/wldfJ1H1MUeFKvhXyDdDb03+ML/aS58jMqT/2ZvJtfyB5/j4/bHkTv/wPyPrm8E6U8ttnS+n/vZhM44IvNOde4IfJC7qOm/I9UgdqMoOn7FYALvHDu4f8JG7ANOSQ4AXRizBtSS9DXpx1bDdyvpiJP/MwmfO54IQ6Y+al2y3IecQlzs/xsIiLpldP0EOzJDflsMwkB+Eq37oTWlIVd9u0SbznbRnVmwwdixjWFVZUAvN2l2To/Zmwijkpag0XpYf3JdPJg7CObtjQ7WJc45lD1ePAjj36axObrgXxFKui4mx9vphsuz+YHSVcc8xtYJs9r65LkVHHtpnZr4vkvYHpYNPB5zgcrVhx13GDFL1ACI6WtPIajx1sSmm+A0IyEPfUTcltSvJZV6k+ReqzJu8QEN1BAc/L8cBggHe+wZEPA+Gmb9K1SDt3AQnfuSAnF+5Mc6i/dcBz/kkhF+SV5zAguGoypB68rsJEklxARS9uChlfHOPm2cVyuKBicxd9iQlI9jzwwNyqyT5e9N3e9jkJUGma7D+asX1YsZdGLMit4smtKL0VndwqpbdK65kj1oMKdsdL5F1coES+QAG6HKakfcvqcTmHRQwOMWW4Fnmbtb0sPZm3IrkxdT9cAAMlpw5TUV0wlt3UKYiocyPLD8taJ3wr63SBAGTR4u3hgx3cIHpuoK7j5bYYUHAVXVzbk7kgt+QjxJPojXAd1+gTUpOgQMpwJffqhqtbyv9LY3B1C1NfEa5uGK4Mr3gBU0MW9OWhKxBb13GJByK8YBC7cMBz+WN518dCjEl+pkDsxijEbnwRiN1IIXbjawKxgTh9/JukDrNroUsNhIgivgiqlqQh+hw99MsKEG6DCvUzhrEp9d4Xwy0ef6P4e4gNqd00buCie71DxeXfdWZSsVrfxiVaCgZp1cMWP9ize+I4njAfyZYwek+/I9B2F97eeD9pO1Aba5OkclQ/+OVTfvCts/zgdeogLPaC+71pH7wg72+FTVI5uZD5vW9KvQfQc9zkXHsLm9I1vH0TT1eiYrHI5WZAhAklEV29uPlk17EQPm125h7eV5TvjkH5HsT4giUnyD52sYA17D3BX743HpN7OQIuUV/FkhJw55S/nBCbx9zj/vKJU1qWTGcpuy7oLdTt5kyoUEWmuvO0+r8nrYHG12clk0YoPImv3xIizWQSz6or/zKiM5mq7pBnJHstl2jmV66I6Vu4gbLOGPXlHVIbz7B9yrgbbhQx795Uun21XKdX/5+8qwCP41jS2z200sxqR2QrlhzXzAvnMdP3fBOO4ZiZz59Wfp8VBsWyw5wc853jY3jMzMzMzMwcqr9qeqdXu44Cj2PYnmmorq4u6uqZ6XKaJ1IX+jzE5n1y72mZAb5yKlwPGnbrtkS98c8bY1eHT+Y2eiygnMKNw+5eea3Lfb6X+6p+7pO9XD1lELn/7uW+2h3ZDdmsj9fFKWn/JLG4Vn5A1uL9I8FZCOpDJ21z6KR1h04aOVGzAf6cy12Xjx3Co8qbcwQfzYN1nrHBjwA3DPi1AKwFWoprnIqd/4sgdgdN37pe0/sZM9i0pU3ldHO+QO1Wv/ZfGq1uuBISRMm1L5Brl08tLf51r/i3h4t3eMU/P1z8M17xSX4x4XhQh9RDapx0mW5P6YDnVTL6ZzdaMu6QVoNDWo9vFjqa1XKzafPXowVOh6zh/01owmE2ROsbbc0NfNVww40W3PAG4QYl7c0+U+2zawaKZYNf4fNmuML7/QofHlHhzX6Ftw9UqFoqwCjDwbkvN4uy8EL1AJJEobwS4ZHXVmeBertAM2Hd/zdrGFp7PeD3+u8j0LrWr3CjX0Hh7vPgvrGRwrO8VucNNXq3J11vahrtcI2GmUmW217xSUMwH9qA/PZ+J7DHDGX6AvvLa2Uh89g1H+bmllccruHmufVF+c13Xwu8Zb2mv6VNPRESFqj5xqJNAGAwaBSAW4IBbtmjh8n/MaxdMChqP1DYjx6Cjb1yPeQdjXhj0+ZvG6kBthnjCbXVWUUtOZS2zY3bqqY1sy2sYBvdbfuscBd16O8wztTC6a4t1R16TjLwVy4JMAz0GrCy4diQfyy2rRmOhBby8ppUhRiFfJleFZhweFyw3g2dAkU17FUP3V3isQhX1CbNC7fXeRHfLlU7FkvDJHjoHr7jS9UbLe4+ld4D7T2zYORX/PNTjv65DgJjYX2OIsp57fJyLuC8j77x3bw4hr8I+r5LwswhIr7Bne0w1A6BLA9GRqTjEXLt2M0AxJVWOkUenaQbRjg81rYfUbcqDHEl0X9gvowTA9iShJKgLH83MN2k4dVIolIoQ18gvMcN3TR/D+q20j8RGzP6iy86HRpQBlCwQrZIJr9KdoigkFO/i0xuLG5KwU+5mFp1yE7j5Kae4V4J4rF8g0yOM0EOLc8ayWcA3VbFyu3KVn7rfkH7+e3I7N3Ax9IFq/ZC9CNR89TO1ddtvpb+jwUPCReDcvdVzXoM7sguybm3crY3lz1QpUC2Kq2cac7FAT4xidKHYmz/pU88Vsli9W0JSOEcf/ngAlh9KX/vlYwcPEicsS+BU/w80BVgezhR0+B6qkvaKmRLKnJ/zHcf1zptZs5AKy8slbDZkLVPqNsoUUal3AOxscEw3DmVaY9SSjU+CMIy4mXAqJcZvNoOxwnD/yonekWXQhcnzCnGDExqwNfSuBxXyO2mdOkTMCUWCw4YcVrMiOdezFJLDmDH9QbOAnPZ5WIjZRKxC5aLOdUah9E4dZbqYzXH4YN3ODI3z0A/3Dq9WGCgyXbZj1nGJkcERDYTGo1JVIL9pNP5djPFNLWkeRxIoLjusNp8zhln4Os5h9NkMUWH1U9NjglJRB0dLnsdAW0uLM0Usb4Z7Y4T0kP1Arf0j+GV4XPUXBPnqM7US3vbK2LaLANH7Yg6zELcQNX44KH7ljoKalVBwbpmDToLesVDSupdmYC6TOLtOJ6Y09N17ihH2GWSMzcR14n5IpYIy+m4wn/WUtMSRNnYaY1YXG6RJdecGzDN0xYEUsgFPQLiS9tcGnd56LeI/BcitoxeiW7xSDgnS8s5IWGmJIwoFcIFNFUT0yp6joSU6myEgySkKcQ/ptwybTNtwLZk/cL4uNhNTDpDVFuNgLDatUB0qwoX1NFn7V2xP+HZQ/anDDnXsz/hWetYHHRgnMkJzvZMDoQMfu2XoVAao/OhYaODXu6Kmel9/w3Mh0caGIj1sIH5iBqYa40JHK3J82GUyuhMUQqRhQPoLTpj/SJ+DPuoMikBhegOpMFQ8o+qu8RmAk9sm8xo5/nH+vmFcV4Ul5Dzgr7SNhMOmwe6c0vFwKFyNSNKN8dPtoRfYaAQP6LIZrBlY/Qo0QiymH9N5km09+8rg/06yd2K3p2ld7vUuOQlE3lJrx9axg+Hqhe4wsQPt3u49teh+eX5+PrkMUq4VxHMSDW/grzSaA/7OK2uNdIo5K0i3deR2/tKP6wtF2sTtEmQh4VaUxu4/JMwgT/WhCLZjJ0HCKD+d+jrAPfFw3cgdeEl8PKnXK45OJUUs7CCnyuNV/XlgwXgZH11fr6p8+a6TpPzfqPeEurqLqPlK/yctySDVWhFiF33sGn3aUXsoWtGu1QFDiWl4c2gpR4qO9oXuhRL6JsZizHFArpcV4bY3WMjtlikatkLrMXuCwVldL/cQFd2OHnkYjHRZ6/7Lrl5h3UturppD0Wt9v4YCsWjCrRFvARxDFwbcLUoqN8G19wXV79f5JyVwbkJqPNwS5xEkKeAggqwjpArLBEW5ArCNSNX9+2LWUI5xCzlC1SgSFpQR0DkXxfmCxh5HG6aQOgCCN03+vlFAqFjlH5b0bvU1PhhegTBccVsQrFoK4LRITFJxBdQVT7BP/k3RQONQOJbQ0hw7xSyWS1CF7Iz/VfbxpRj8HujWRJuW8q/s1+X6RYhNFG1vOT9Rw3n5d8G/CLU0ImsoDDFGpWI1GuNNJ4ChB7YrMBv+H4qQOkXKpdrtpApSRX6OvDj6+jAu+Xyf/Ja3+VXpd+4/LhZ4/I/ZpTLX+1Z7t0Nb/8MY/aSZVe+CMhAXjOYT3j1QgiWMZRmmm+5R+RZrWilhjab0/ozWn9OMlB/RuitNazUSN9oTHs4nuYeb7IwClYNbRWdXYZ61CNXeTGeb8g/pbZPl8OxLNOLhJIaO6yZA7gV0O/8X72ArXCGaycgpCT/tFA80jVArBZPBJJ06c/s9hmdaXSC28+qbIC0WOX4kaD0mdYkd3I81h/PPrW7Og4ffXN2Yx50pcCo3ezw18jEF0VmIiwsMHWxcq0MKaZArjkzlPFEioLDg32suFcE+vFY4XSK1YGxtbCgRaaUAEQoGm0LgtfQIR8ZOkE9SUIkUpZ/ySNX4pFL3Zcv6xS+w5hoFfKnYbkg/5er+nGOsPYXrXzopwhYYCTHMjPDAQ701NMQt7leYQ0mtFVS6bHZZQJ/1xAniT6NhDZudaIGxFCIJPSeNopwYLYVZ6xI0H8qxiMZWIm4l7OtiysF8NTSElNfu6Vg2H0Xy2hFrFXlDQnh3VIbnxtSG5GvNqI1agO9BKvq5omGcFpSDLhEm5is+ecBtdaaaOp7slbH2FLdLAoBHUgSIgEuD+wrpzD/AoCtp5GUXirgg/SKHL12ugi/RPhMEfJsCOOq6IrgFnzLSRnqfEgNU8f+DApMPVEDQcO2Cxpm6wUNMdS7N1FfGZoo60+UHZoon4RfReO7qNR9FgwHSWodSf1Nk/a6myY6+lfayHBcCP/9NV6sgq1iVSTiVRVt9f6O0LaEscIACwPNjCJhOcZERBAJKQd34MDknCS630m+R82gFjQS1HikEcdh0Gv1UPUbj1G38Qj2GisrDmCgT27K6wKhcL1G1lKKEdZ9n0RZxynL348rnYAj+Ad9wWsMsG3C8beOOHyqAkK8mxDWb74Cpr7vr4GrDtna86HY3zh4PObXikSp1ZxTG5pToNo8RAL/TD0SjR5FKnKhilyiIhc45UoWyhpqcGmp1FiD0SVN+g1jskPZp7lB+7Sw29mn1/77X7xGxPE7jb3l6A6SvEiQZEVb9cSYquxxtcUppc6YKcAAcWBYikzs2WsAmMnHyRFiztL8u545RlxKvt0Xi0+sZnmhb5a/N2iWb74Ds7ytVatkFaw6pP74EqyM66q7WIXn4DaT7XRR0KwomIL4Z5tlTPpxY8YORcF8XQruv04oqDSLlWaJ0qw9glRjeIB1JKnU8l98nVr+SGyz+u8JfuK+E+8R7JLrBgh26XWHJthFxki8l2OUTAkdfaleXd81ZL7G5sy/okHJJdlIUbb6ZgohzeuU6vSBZFQ8SgVMnORkvj828ZYhVbvgR88XhqLnvTuyiQHZXvXHu6VZkN/6/bSMt90Fy6iM5KlxjKpW49eaAOo4GDKPoShjCM8ML890tymgqB+TdZ8kjylEjfaxVqokFKIQrITStjZU7xKCqDpvoW9mU9Idxn3gq/SPTeAblbu/1VeGzWYfhTDOtm+FTvCdAQAWHnawEWkahg2SeR7A94XXLrvuB8drl1/3feS1K6776eK1K3+ieK1QwmJfdJCuD3V0vW+regX4EI+k7wNX/i2yN1WvHJGZHs3DZlY06t8iim9gboKCO+SH8zGGgH2S9HGCef1QCipzIRn+6ZVBx7oHsQwS4z2PBTeJIaSvK+LxVbsSrpqVzmqwUtu+J/PSMXJxXVl8XyQfzn1JNbebJ3luqfeSqnsOJYsvwZQT/982X7arXWxNNbwXsmPCT43cwgMqxwXRMhWP8zR5ZyntFVmNMnExSsxy0ZHvVVHAP73q2WiLxZyt9i4XE4JGVL25JRN/khPcottc5tgfwh7PZLW6oyMHuWEGn1XkKVnKHxVggrgMKCRS0OUCiGmXyyjRAEO9LTMh50SUMeYWj2EaAV1kqSLBpQF4UCifVa2f7bQ8RKA+MqHAkzEKD4OUxqpd2IAZxy4jyMajDjD4ac4IeKi9YpICBq79LIJ9MfjMGzRGKh2nugWmT0smeKCQNPyZU3x80JLBcXrwAMV6RVZui1zlwrqPyE7y6Pe695GmebSY1B7kQ6w6xorWOvSM0kUoMWQqNBDlxoBLkCfjpAlQc4LrdvBNnwzsl8l8pyfs0z/f3lrN0ViPX7g44aGXX/Si/uhceZtmqn84DzUszZA9bb4E9z7hyhPMygnmSkbqYac84YTVyy55EZP0E+eeNs/J35+3bb6G8+VVmgLgprcVVPzb9jZUnDttvphFxCXAj6Ep3jWdLzboTGysHsC9FnPVA5Ec1syLHsOme6+Lxbye5Pdk5dO2EgdfeligCMTdrETB5eE0Dn7niWnoVFpQr8ibTc2kZiYoKMpkWnEHuchEBuhw6p9qEsk8x5RTXo94z+MO3myfVXbdbXXwppthIiQ65FiBugfKoSb5UBOLqvkAn7TBJxOUQCoSXyqUTyL9bN4d4POSgwcUuNIATAVyKVLgoZym8uvF1jZAXrz14D/Vl/Tig4L7zbbc8qybQDj9i+ncVpJu0WVAQha3YhmQ0GFnl/xzFq9f1TbNnV0UZHGg1RaJNtHUQFNuVm3kKipVRR+VD2/9UxyZsQWsvKWyXJJ1jOO2rZQzSsjFXmVRmdM6pq4qssn/J9z0woLJvJY6r9P1hFpUCtSk6eHI9cuY4NGkSBTZGBkQD8mojCRksZDq8fgAS1/qLjseHEDyAQGMqcHwTPZbG0E1rjUK38aqIgtL0zSBuZ+QuS/lOeIIWWepZS/sSIzJ+h3F3JFVNLUTdMBtRs8ebVjmqiAnTKxPavABzd5E8bwSHTDyvgb5w05LTME4WwEkcsrLso6MMp0IrP85wLhdHIcVyNhm7b6wWq0/FUJMTdt1mkkan8F/uKqKCJNiBRqvA/w7oFEiNNqkNCqsAxdrm5U1523FAyTQ+hkXFxlNqclA66Yp6mchN5wvrGLLHRlgMFwvJWwUZYtiszpcs1bksLzTyKS2qOhSeodpFGPp25hB6+bdCfN2vj+WZ+M6lmd6XbPT4d6gL2nidACcKDLGVriDZlS5eNruT4XkOnKLkQ/qLtUX9ZRgYM8aUmWWZ2esmOI+mnpSokHsKfF35OK2ZGfDwqtMRJsOGyihLRNgiglQA9h/HrMop284l98v9ifBeoaUrNhQbd/YT1tdfB7DKhHLjw9tP5mQopgUV7k0yyBNJjI6SGQdpzLJQVBceDT2KVfDA4QYHJmIs6RgxEBi8i1ngM+FaazfvOxS7KCre5aLCfPylIEAKqau37EykwqUhzab7gwC5QSfbDndK+F6tkCWUe6bld1OURtoBU78uVGSAJ1dyUFg7CF0BuUCIgx+//Zf7L+yJWw8SfApVTBste8vXb4KieZe6eXm/dwbvdy5xUaWCKToQPk41ZyoEE2IEEGARuPhwWgPHf33Zby43EjVJEg9KS9NwRCw24p6fcsSToSm1bImPaQ3rAVMzSo4daDM8RhkUIhdd67TZgdqqsdTs5voE0X/vEH00fb0Qd5ToItQozUtlIYgbO4u2nrRwP39gZP6EOzM/4HbFvMgSXR88GWjRt8UVoWG5UcGCaMrcqGIZO7N20nFo6LaiatR2eUw2OMuzluLClqIqgxVVar95nvDBW7CMNc6QJ86bf8BsMFRtDN7L5qyAbN1n2bGGuxVNItuXwlyaZfhqi/uKgJrkFoWxFy/nBWnGkzB2ohmmSkO8I0QSIMVFsO33qD26KCsYF4eISMpBdaR7HWXDG5WFV0O5XckdQUiJQz+CJrVm1oLzhbQjnuhqyyk0nMw0as/uKQmuyw7mu5npUtP2c66/nSehATKQJXdji6GYRfWI618pl7nhFOF4bdPVXhk6VNIkEqIZ+g+jwpyMij9tgF3Gp3AuvAfvFK+bmNCnhy6zZYtVbKcvtnaYK+tP6FC8AOp9YLSntA/sb51Sd9o3tb6TUyO3uPP6iVFUKWcYy4vw/P/q0fhCQ+7kh/xpfDn5/XBKbWQuLi1S1Fvh2fQqfWfXVi9iGA2REGSJfOEyym49EVaUmdWhps+4XKHU3IJxTDel2pFMrghu8LXFQ+7V8Tol5ts6xjpegdfs7BSwDX6pv6ElsCfJ9vAvRTiBIIt9kpDDOa0eUyCaTyACxjc1uUn/MLt3F0FeCO3Evaudh0nGyzDA3nLzNycA74yMzPD9zVX/pprUmbMUVJa72GZuYlzd2VmZmbmJuf3/5Itr/1c5noDWsFoNDPSzGgURZsBGEKSO4RAAvzSBoX36uyMBIKmTqdVPPMXPe3Jh1QWPAONkEhOx+Td1m8f7+/O/30Bc1Mdrd/NXJCubSx93N33HLjszq+nwjz9Vm0PCqmZgR8fspOO4mAcuS1bfJf8JhsGfhVel9t9t/l2ve7h5tBPZPzq9DxLpVH6TnZ32hr5CF28wJNs4EcaJBNl8OCdOJ40MFJ7jKwTgGGVwEj9KAyheTt0zWmFwYq2rq311qupGfixApR+QNQCDVCZYi4EGorEqXW9aMtUpGVzxZbNqmUXWjoeu96yzooAqG4pAni5IoCXNYCjAYBDMQ8Hddvpn6iwsnTButdPcXj29icx7+exzvoFrHM9g2X/d09FsOx21v7rYBn3lGjc140LwB0lGrHNjWgs29X5zGyD5M+9Y3qmnlP/TplomFzyR4A/NV60ZUukZXPFlpqzo9GyukzQnV8g6I5XPgAWzjtYFLCPK8k2c4mGAzQSXrRlS6Rlc8WWegCdaFn1281UnD7B8So9CBnL+DH0gTR+6chPnMufMMuoURhXTY8dn/Vj3NKKs4mtUTU7Z6aosbwITss8NF+AL8hQI+CCUJJqpENNzIXrCA6laGPtCiWplTEtP+A8x2Gt7x6+H5pZjWeooLBD/SqT+eVmSz0arShZsmgfCQfI++sBobBYhiJMn5+6Cv+8dRiIlPDJ+gV8sryfP9M4xCoJXDhOpY8iet6w8OQUVT5rsvUu+RHEMAJkHHyQWPrUeSeuEaK4OgPJyPiV4HUDnrEn1tyGA9Y4W7JaI6yhECz7mb6uXKjvuKNWC1FcVQJW4YwMoE2WOP+AMYjyMVB0/Rp2vSL+QCrX0IFDfBv8QvxLwSy/0W+Htu1FVeZgRGX2V1SZekWzGSb+Ww6Yi4s5XO14U+Jx2nhWp0Ur76gKx1+09MiT2/SSCIv6u5mTcmKrvAE9+KnYgjcC6if0RSiFfkKk0p1PPLTd6s+80Rym3zt/iVPffGO7gUBVSI+edfXWr/37rhFh+oldp88bWItngzA95evGpqamY1IB0utuyc8dyA6SMb39TQM3m6ti1zz2d1Z+ObToybBDnxgkXWYkIpvfDjzVeidm2aQF6hHNqgL8VEj2mm1+MAPvLjIro44efhT1TAh5CTLA2vGKG9cx0wd6B3NMCfhCjgHy8Bw8F4Teh31wGS3OnvM+wP8WPR2+6fS5Dpi+VTYYngP5j6968sA7307rD9O3X31d/4UfJkcEaDL8qTVcu4Ea1uTU5Zud373x0ecODH/MfJy7g7LBD0uRPx5mAlJV/JH06EOH9l+ZIERQn/0A77zSawAutWwbs0S7OxZmZluugXPhmgSkUYnmsJZLo8hDen6s3+sXMpc1SnbZmQHtD2FIsIc+HR0AKZOZ3ZNKNFbUnho/VisqR+W29XE+wDybX715b4oqTGlE9fmT07roqVnGbdy26MHm8omvu6KGiG/Pz8MTQIGg+YtLAIYdsVc2aQ+5NiSt1vsOT9pcTGNJwYr681UuRqIUG2JLm4cZ0ERhMpgTm0V3tgX87hhyIJZ0h6e2vjqwEE7ZaQ/ywul9ObHf5W3yROkcny1SgLM+KkxYgzJa3R10XNanKMs9157zK0qZWqKx/Xmjnwj8ai7eWHkDtb5LkYmAibUEEwFXMIvtqkKfwlgjqyiJNah30Z1HPFzdNzMVUv7wnt5sxEuzfTIDBtWL4r5xe6x1VyoIKYK1Vx5x5r/v6Lg/tW2PP2bBdR9NKflDvvPt+N7e3mdSPUo+38jn+zWUyxrKZRBiaEXsiSX4Hn609JD7VnMYBIGXi/LZ/QfwWTOHPNvlok1mTz+mefZr2J8gAec86r7nAKo6AAPJ9RrF88RP47mnee79jjz3yHOvyHODMhbilZf4pOmzWds2h8Q4SD9xed+9q465VfE/8LKuax1NxlMA7JYK7D+lpVMz6aIZlmaRCRxFOUIuGCuzu6uzkD67u2u7OpswowFWI09c4iIgc+BpTAKYkbOkbYSqgkHL9KYoK66PobFTX+7sTFpK0L6H1QHcLjuQdoYB49CsmWB/4DsFa8QN/Tha3DdMEjyUhdpQlH8iFUg3XfvCWHDjnhQDldQ10lXMW/bF9MQF152ROuHhK7869pgbU4pzU0furayRAhUANLfPVe3v9d4MoPc+ufiix3fclqLOAUulC1hxBWvP5rZJsFmyD4x85NDZN7s+C1io4FeR4XGJX1YY4FFC5yiptNWPTHE85LSK5kR5dEZLp59oW4r2YayDf9dcvYQYZJRIJpTVOMchrXMceqNvp2Orfjurbek3MUbflah0k6pkoVoe0hHHjc6qgokoyEjCUSkIf8DgYXrZve/q2fqzpZUAulTkgSatnbYKKCqUQ6rnke/l6bz9spvm6Wxz4twdf+NQUC9MN1mfLHgtaM5RQ4Bn2q5ewfit3E06wEZ8IF9GoCUHq/cX7dbcS9njHR2/x+ryuti4VFGynRY81EArVI5GYFWxbXYDjIDJ2MQGI3D3nz0I/csZQx87OlMKLze1Bb7on6rucLV5rPzj/3b4Dkh5LQgIcrtU1YW6M4KMRNkgy2CXk5pamg/Z4STR/fSW9MSdr06+9JrjUrSeAuepxP6XMXnoHcfm+rMPMvnRaoqZSKoAyKE6qO09btuiS4zO++v6eu3bfKv1v4cxOBV9pFUgoWh96OlbxioSitYJr9/xhcBNxEiee+mYISRttaPIoxtDVevXxc0GuK48Vm25qVviusZQLFu71qsTfNXXGF/3WnYcQHPbRQO5m9B56lDXAWH0nqXNCzzt/ZNCTXR9g38DU2tcclNqjGRcfnH7psdAsnOH0FrZPtf4Tnts1HJZ3DeIOdN+5kB2pTG+25N0WOroZwwkN94+52Yr3Tqm/axLFh9x7pgePz6GnSMi1TNWuj3n6s6ILo0s/GocT2Kyd4JyvJB3HJTR1M6TTxNmYy1/nEQd1KA81++0znMYFFlCOnvvz/9O5ZTFDtAVYwfsHUp4gpJEh3ED18QNDpFi1IAuMGEDtDqEfYsOqMO5Dxmlq0gLaWhMncToTaBgX+noQAGKiKHDUh0k0GBGqQCD7wI0gKsogWuiBIcxumdBF+8jIUUda+FKkY4BYKtDBMVuvQuE4PQVnSUxF6stdfLU/xe9og+JGpfcOeF4RyukGc8/PUtso1TENXfMyCGppE/bDTCq4wSel/0TW/YYWTKRUbLpsks90bjuSYPYpxXlCm3wE0IujdyLcumjPVNmZgtmzDp2ibzpxfgd5i4FMRiy80eHb/QdtHmZMxJLIIUxfdiaR6700WrvNtMGKRHIkMuBftIPTxoYte8qe8GH+WT/R+9o7b8VflR6yRcXunK/rZo4y3v6B+DZ7EUnaoT2yZCbgSozdop0MxOlyARRlGXh3jO9KJAyXg0yGsfx1Xtb+/kCC639c/180w2FvA12mHL5TW7e7494cw6wNcVAFqpNCv1U8uDCdMFH03sDACAdlarg16F2wZOjDikaJt1KUYof2CmIl+8UOHqnwDUyGi/uFPwCR5VY/96Oqhtm1Cid7/Hc3TLP3fm1nrtLzx0dir8yQYig/UdSJCnMToEo2SkQ3ttOnCsivwXmWnGmufkqNuUvzmUXqAbq8HAify8GS2qkzRIv49fK2l3VifkEfrG41yx8u/p10o6+1o/yG8zKiI8UU/SE2w3OneFPsbgemmBK0q5QUje/tKYkLTJv1yhAZ4rSi73J/H0KvX6T6Z9oNpa8NShFFO8tyawqfa0pffWKr7vVCe8HhsIP0Jc2H+TaJheoS4sPcvNDsEqHAL5Vrl2BFJEhza8aV6jTFKkDTJOCOJUQjnT2FNcVzwPTgMEMslwxPBPJrpVukmE7meD+c4y/GPao5ZtrZM3zbnvSsvV5YO9/nFk1sDRFEB7cUvJq3D3C3V0SdKtvt2d36h85umdv3+FkpMTkROQBklfhkuJ5FSRYxvTO/u7vvbNp+b7W029/OOXJT/CM/qOf7tz7E8wHf7/7/Xnyx3L+787f6boL377qtdvOeun8my798N3bPvviz9feO2u9nN+/zeSBIOPKkwDFDnJKQMh+a2DtdsgL4IRbtWICLNeYwDIGEthSNjl5YoytyjOEIilge/Yh5gHz7KWwHrmnW6DIBXBFzJhdipAYECSgL0gwudilacaQfcIUScwLxNEVZCF25bihNic2SyhKsVgrZwTNauVHBozdfLDOZ+Ilon05V09bgE4mLksTsZZEDoJJFjAmrRRsiGXGsOBTCORvAcENKXEA7NFFc+sMto+gFvvqOd5iydhrAqndIwqifgvh0oOFVwlcAe5onQezwq5BZtw2kabGU+xnobi2kcwu9uaSa28qN/bArg+4mRFlQF6DC4VZbqmn25/jkcyrI3aMeWTaW+4wSoYh+a6Q90O+WsOgnXWSYrOUuHPWEsNqO9e1NgXBonZNzW+sqerUrAjs6D1QSXs76aCV4jxIKVBm114N0+DaocCUOGXGZWxrh8ZCPaAUlEg1eV9KBhMqIacpgotwjY3pGtppaa1OAiF1dGD+fYKChTbPs0OOdQ9Mq7VvesrZBbr83seevPfR5vEnn3jyuSefePjeK8Ci89SZQwapQ61eZ4CxA6WkOnzeBZc16xuun/9Ub+Dxe0xtUUPMiU8gbJhcHiCQiI7HhZfIhabUoEm2YYw97Q5BtpIpnGQM1foSp008GK74gsnO51nVUsw63WNdOtxxAphheT5xMg8AxTT2GlVIvNVtBLOBcQ05gWmTH0MEA5ZT2I/hNBimOlcHldjARDqUcvXRLWLq6Fh6xs45wLqUR7db9lQgbfZt8KxYDyhUH+5/QtHCOqnPgnX3cXkyq6Qew6rDK5+oOpMZo+gK2THO415HLOD/jNoFWBRr1ABgTMLuJiwUpEERBg52EwrSsBjEJeyulZRewqBRurEoZ5mlG4EFE3ApE2YAA4vLv94dnvv9zT7FzDtxzmHON3nkn5FmdDjkV9f5FF2sI0ftTh7lr8r30b/pQQOJgt71/yQO/DagRzpBE588anOYv9SfbZ+V1JIU4v9GHy2NPiAafWLFEDzcJCYLpkHXyJT/mO0DXIxf+8/8D9t2RpjvGiRKYLWvrFA/CJ7mfQOh0V9l/qDrumcE8+CGNSsf/cQEV/eIi5gQ7MYWQnKI90IkYSn7n3kMxE22LTh3toVw1s9piT+0QuA6iH+X88pY3EK02GVHd7u/xQVnacTPn7tpXdhM8LTXhjgsmcgWzEScsbTY16aZqHXfu1PhxRxB3ryv/3qyp6fixGZCY4pr3+fNrYL4OYjvdDDam8glGKEGnuX3JQXrxyLOvBPetoNLBDPLmveZrhI4E3HJjoLO903EC9ncMPFLqwXOQPxG+xwz7yYCsp/mzK2eNzbXQfz801+b1jYRZ18dWLPSbL4gf0nE7zgU3alsJCYavrPHsyTo+qD5p6VZ2DUS/cmuKuUSEnR9viD5Z/7wndRI2JpNGi5NXi1Yn4M461TnyrgGYvqEL1dJx6kCj0W84VHoKp0G4prcl+i89f34mJyJuI6V88L8p4QXFpYmYzyNrg/ijNaajP56YmWWZ2Tualm6Poj3y7gIS9cTM0fAUE9hAV0fxDl6jlIWdcQS++onQQVSdF8gHhteMRRYS6i6x9jrXZAem/M+I/WRO+1ZXEME5voqZesuEjgHcQ5Tt+pzNWHLqoPDugWYYJuIZ3dK4CuqiY9F21uP+K1ij8mZiOt/iTTbX0V0NRdNfNkoQ/cf4g2SR2OvVRKiP19fI9ij9UOcN3O8d1oFYbL7wEnW6zG6JLr9Re9mPCsnbDsfxP3VPZM+/tD6JB1XHCkjNurPjNkSLT425w0i+d/t6lldRgSaC7N82yUFzkGcWeMku6+UwM6r2RRNXaA1Jo9FnCUu+ftECaFhKL3P8/wAPb4h3i/xff/NYkKk9MQCRf+VdH0RZyi0yOQWEbfiZi2MZ8qPzXXQ/TdcvvqcQ3wxf3/jloOY1phcEnHea6WgXoIYVImzMDyziq4v4kKy/P4oJDB+o6xTldEak/MGkOPXPNDQCicmF1qbGE9dRtcfcd5uDefgAqIy1fy92sZVWmPyWMRjlZ5tK8kj7A8q7Ft7ec7YnIk4o8enqT+HeHVKpWrD7dV0/RGXnAzCSx4TxlblNubjJbTG5Dpo/EtuPd/0kHgz50ftK6t1Y3NJxJlx5Pqj9wnRuMCzVpfn0vVHfRZHUSyLCApY7xZtKjc25/UjvuhE2+Y0Yu/xZz0XXZeOzTmIc5S/mZxOIsi7g6rbf69jj8ljUf873ys6jkj9e/XX3PFfsTE5E3Gh89MjXGOIbtGrl1cz17LH5Aw0vxbhJfm3iY2JP0MM/dfQ/YWu/zs7mRNIRCZyv10Wf4OPySVRn+kow7tGdOu8mgadi9hjciHa/4ffmJxDIe59Zt5MJryXjQpzrJhJ1wdxZojJQUkWNA11TjZvHb2+QtevWrNq1x1QnWqmXBArQ8eHuM47b8tNsXDg+YAFZ9Y4+vggkfXlmzNt42HNMPvMqfnr6P0jzomZmxqaDFdWmzXcvEDnr4N6W92pmnQQXvNix6D9Yrp+qE/mKH3MhEuaVXras6YLnNeH9Pf2Rs3b9yEietpBS+XR8yPivMakr+yH8Fz3dYJVJd1/DMRjb+8z+/AYxJdZYpMd6Ph1EOd8FOMK5YJyX1SKv3gvJpiJuI6ppZVKPrzawdawmLWCrk8vEl+Gf+VfT6DHfkiWyZpDx4e4Dj7O5AYO3HSz8sbto9eHiEuKuW2sKATetrdZ9hw5Oj7Eea83Br0nYFjsrt4z1dHxHXVp14AFRTAoLFd/npKi+/8Tcv5acVU2tQhUw9S3BiTR9YlFnOk51aaxGO4+ul7jFDVB4EzEWfOyfx8tAe+Te1YkK5RjgvgQz1Zx0woqhfM5w4YX3OjxXRL1u9090mVQccWh570KnT/v478+069Q17gczstj63yfjl4/IX78jO/s/nLokIrs8Z81+v9HXH+rh793BUzaEnR8pu3o/QfiQhs/ZRVWQuO6D6mGWsJ0fVEfajUzq4JjI7EmawaF6fEXcZ4P1hdSDQ5SB/W3nKTHF94H5PrH3PiFUg2kdqTr+qtNFTgHcZ6muldDDeTMNjQt3SNHx4/4zP7yX8dqoUn2VtnJ3gFcED/irOZsrft1oJY9b0hmRIaOH13/3cj0A/Wg+GUTQ3p2MSaoP+JCbd0ZX+thVsCTo/OkqnHBPMSzHzotDXsKim+mVvfWLKHr//5fN9nHUD/RAEG6ffNfR36nx3fEGTZ2cqUN8OEjNt93oTR9/CD+/s/x2QhL+xMOT5ei+4+B+Pf0GgvHRrg+P2GoLnz0+hNxe7PDYUQj5LJ3GPQljp5fEc+b7rxtbhN8LNhe0O4lJnDeO6R+rZf7C5vgy0T93T8jZej8EGdwOwbmciEPk+Je7KT/v7GIzyw8a+fIhcpzA9l1LrPo/BBXVDm3v5gLFuzJOYaaC+n+Rvx9y4pHi5ohisfqXd8tQueHeOWJYv8TzXDmmZ1ovbQCPT6i218QzatqhvgXYku8JeXp/kc8Vl04c3kLmFYcuX68UJ7O/y1yfFYeGLrUApSOJdmXIUHnjzjD9A27pQVaj8aLyEwRYwtes9rpCFCd/2r8z3OFs4SGZjQePjSVzf7n4503gBkKXuoEyS54+ue10IKGeLs/b2XopDaPfh2xslTwwcTjL1P/+YaiVn9705/PKtw1dCN4z43gv54XXYgbi/U0IzA1lV8pWt8osGx9ETmHcQK3YZ7TDu+loNHWa+ZFKxbucc3l/bwuCuZ8s1Pb3+SHnfaYx81+ScHPgB8rmPW+ePu3trWODRTYVL610R1iYJURZxZuq6AgjKti3h3Hwtw+l1drF1LgfMnNMjH8NjbD+4eTyWMKflPDwYsfB2BDO07KBqfz9xepcFyrUBu718hV7o2jYIoLy1t1wl/4Eu7fWbYRFExnK8jsP3gTNzCf3TAuhAKjj7p+FFMfr1Vy4rB9KJj/pSV/RVUQzpNLyQx3pSDLyOJDF5eJGQQkVN65SMHOkISP85Yw8UsGV7C8kxRoKbcb9UsE4h/9/dR//EUBcWAO+Hn7Ymdqjn0yP0zB6k+zzka+vIU3W0x055lTwFDQ0B7qDcdS8+2VvAwpiFL3rHF9F4gve/l7uf4+CvxLErduOuaDPfM7dENzOwVXJnZnT7rIxG61XgnaBRSEJid3DQfcwtQPnXG5qM73nacHF1p5YZD4QK9eiYLBdxJ3ZHcwsbbLnUe3yVJgJXICLuXdwq8f/trxZiUFSmmizh1DrlhHu8TXKHF+/YljiyOktHDWy1cN1xZS8Ehs6knXDb7YlAndiR6zKQisqfcOnuuCHVTQTsmaSkFOWva+M/vcsHm5SmJ/T6Zg7+n0znGbPTGlF3t/Hx9Hwe7vXMuNbYHYyPwjD0R+kzDRPECTGeeJD8QEW5d9I8Fef09t3+5gvCZFY0PSAAkBcgZLvguH4bYvJjln9pLQtD5U+33jCXwopkf19TsS5i2pf7hoURjekzynRK6LBOe9Mkk7Yzyw5aqz9ya2k+DjsOYiY3YIvpSZPnHbKxLMvRfsDEwywWXkh6TEnpGwJHyXXcS6y/jtZP2XXxtJmJVezOg7vAWT87ZhiNSTQB2ZrClqewszFlrWt6mahAsT7r7qqHXBGrCix/fKSVCcPQMCRkKwdu7zfpkSErKzLj6pZ53FpGXWt7wiSDjHM/zEXhaCTWsbDnuA8/OJOyGkGhqIJ62LOvsgn4RdcSGtte1e+Gbbp/de5ZBgrT6DXd5+HnfVizoo+4iEbxaXerfP9sRnBFtWx9/nr/98eOEktRDslfTj9TuySJgU4aOQe+cSNlxxu3l2Bgmihks7Ow6zsLWGO9uE00j4WL5I36NCFcvdbuqzOoUENc4R2bfKodhOqYx5x5JIiDkbZrO72w8XbT2b35FAQvI+SrNMxQ/3MNLIvhpPQuYHWe/zB9xxyZJa1e1xJJiYHDzfVh+Cr1pu5Kp+j4Qji64yU2caY6dS9jYb3SVhzXIrgnoYgtdpXrONjiXBNV/VK2P2XzjxasqZ2fxpMsU5j7I7jCssPoo9iCHB4AbPUKuVibuHGvy4wp9+qm129YjEefy0de/7M/zp7Cu+nN2kJ376esLOcP60z1sjceVFnniV3eaDn/jT3GZRq5pIFgaW7XoO/O0vS9iX36p8Cfca9+nUXH48jhw7w+HeUEy5SHFcH3/ayOlZWseno9gh3afrP/Pj3/z0oULZ3Rv47MXahtL8fFU3aA7kOITgc+r3hnnz6yE+skjD3YqJZ1Ss2L6YXy8X45Mv9JtD8b7grREvk0kQ8plubpfBwsJsfV5WpJLw6GN/kUKuP/Y6VmZzTzoJI+/KIhk5R3G/rY/nK2eRsNX6s6nbt0vY+nPzwjLvk+CmJZ4kIRqCl48ETTF/RMJacSffvBRLvKesLntDLgmm+azLP1Y44TP2V9ZsLSAh9ceX5Vu2BOP6uu0xrmwS9gTYPneq9sALhKuPD3BIkK4Pkv2ddQJj9ce5BpWS8OSUWIdakzO2YkXXosOVJBxefmj5xDIv/GiP5SXbWhJalDq7PJf6Yipyu3sjGkiY9wTnNj4Jwi1XaT+Y0EJCkxIZqVTLwkweKs6JfknCQ7NTLu4O7hgxfMHIsZ2fb1TA7bo3rvjFz1zCkd9/Xio1wecW+2EZXLOwmPck/HzZuDvwEgu3zfFfK0ySUJDZevBliRH+a55e3r3PJOh8S9SaHs/CNUx7/E/+4Nc/JEP9yzN7fIfVr8GzIySo+Zg4dpJB+O7JdxWzJ1FQ12Yt9nzkNNZUtIclPpWC9DvBP3+xg3BR8efmxbMpeDg1SzHT5RQWud+jLWIRBaHDMRbKXQHYxYYR6zRJ/vKmoo2BPHdsT6Ox/IA0BXaLddWz6g5jj99NDnVWoMB+UbDTOkc7zIFFtUpuoKDpca3bQh8m/rPE0mgKUHDs5whYZgTil72Fd8vtoGBXyhn1zGksfNB7moiXHgVJwlqJHnGnMa/4X60LTSiYsVxHMjrIFb/jVjW/i8Hff3BRi75ZAOah/HrCWwcK9jiOSzfVcMcYj8Z9ljpFgYT2I2GpFlfcOuKSyu3LFFRN26GZL+ONr737de52Twq4NzQYE3NOY9/A9508i4ITJ6MMesvcMLe9Fb8MwinoD+IGzh4KxF+x4u9lxVNw5fSKzjuZ/viAXYDcziwKRCRTN+ElAZi0mQ25pIAC5U8pJaGy7tjtAscNsmUUkB6NSilHfDCdbS7mZxso6OvS7C7YEIDPLYzMGH5NQVRd0D5N73PYC1b09aJ3FHjXMjYVTTqADfwH8VYB3sbObFNKU2Zmxj9vwfha7yrUNmXm1uHEZWZmZsYwlZntTcrMzMzM3LGj8bV1fZn0+Xiyc2ZnzkhxP8nb9JxeLfX1T+dQjuN4TuBETsWpOQ2n5XScnud4nhd4kVfxal7Da3kdrxc4gRcEQRRUglrQCFpBJ+hFTuRFQRRFlagWNaJW1Il6FafiVYJKVKlUapVGpVXpVHo1p+bVglpUq9RqtUatVevUeg2n4TWCRtSoNGqNRqPV6DR6LafltYJW1Kq0aq1Gq9XqtHodp+N1gk7UqXRqnUan1el0ej1I1EN5PaTWw216cDXro+8zsEeo0dQtrLtbQ54zGoMHDAgMMvXjeY3R2DvC1NVo5/2YAC383CWwd+9fjBA4SGH6eRAUtT8NtF7YH7nChcC5evoMBM936R5uCk57wGi91pi69QvsYrIGh/ftCg8IrU7B8VGozeH4ZNPqEHv17WZ9GEtD6MD/90Ct5VQZEf5WOj2hVnFzHiPS4rIQapV0yDDj2JfvMHbJx4YPVy8dVJXMiPMMPaMMJEeEuJihfqvJ1VGVdg96ZCYru4RO85vanjSq1GDelbEryfAde+ePy3aL7Cg0fX31M+/J/7INMuUpcI1g3qGHbl4Kd19l8HFLuWXNf7tAcLeMmmLkafqKftvytSP+55qeKPi/EWRL9mE7to4dQQzBaxIfxTQg6cLdi2k+TyOfN7u38n24kRTYEbd1bayZNOnYPQM3Yr49/9VlqxLKfKkiDT5Zpt1byD9pVccHO/vlIlVOxi+tM92LaAtXbzB2d0tyV0qcNr12HbLEXRXlH+pFjAkvM4vZ+5JyZ7WNh7SbQR7ynjFDz00mzZ56Dun6qo09/xvfFu/OPBwijc7Rz+wN+ZXV0z9ueZWehCT1HK4dUpncmja8UOI6nnxL6RPnXy8/ufLk7KRd3dXkbPWP+Wc3NZKLl6PPXvDoSpLGFL40qHMHMqtJwzfrtpcm7Py/tu7/5e2W9wPDo2f6cUq/TXeandg5XinQ5wO5X36/0mnJidAT8feVu0fbXYuvHkKKjLlwImimmSzouGXtolZuXkWWjOvV7F0Fr/arivQ/1aq8V+HkuJymj3lSFkRGFfX5tHnX8+FtDlvz11uV4dC94qWVtdsSunR9G6Y06s2b9vWZqyxN+DrhdkSssj5P2+/rmzQn+g+D7/OllpMqx0JylMp1ksw/uT25a6sHpJ5myPGM9S6TjJHfv3h2X680OjD9dNJxtbn509VNHkP+7xfTi6k98iqXCnZI7fmkvmI8W7j26fFdlHfF2hu3hXVW7oSfPlLubG0iPeOVxznHkkVDpvk2jEgm8c1LxG9fsYnUu34mx6CdS0kpPmuVHvcClFMV9/lWfDnenHttnZnTpO2WSw13mMZkdFeGz4hIuZUkKsl1c1+LqeKnNO12XK8xqpXvIasHTJpgINuLj7ocsbw7eR/pfyzTyvGkinKmToVi48mZC1LNjsOCSecHxe6PO5dPwfORs3Uj9NNGrY7ajoR+t0PoGZ/a22m2YkEvG72mns0meoy22S9TdlqtMkV4b7WVa9RXeUNU3/6Ze1O7AeyFJ8+0b8D2PvTErPFxmxHBbUs/2MetrZd5w03Fp/S+TQ9rVHb37fKiTWDT/g193ejgAQJABKgAagDLaRyAQ8tcY6wOoAf8vwuuBqAmwOCCkwAygLjgvADeAB8XnC/AD1DLBVcbUAfg74KrC6gHqO+CawBoCGjkgmsMaAJo6oJrBmgOaOGCawloBWjtgmsDaAto54JrD+gA6OiCMwICAIEuuCBAMCDkN77n/q1rHKGAMEA4IAJgcmIrE9E2ytHlK00WLbSOIuToEevIT21u6s9C8M7cgE6AvAAcnQFdAF1prW4OXHdAD0BPyvVy4HoD+gD6Uq6fA9cfMAAwkHKDnPTfkP+CjZx64bnVBngtf2bzb9A9sV2P2PnAaku/rn/HakmHatds1n3OKVtcQqFtVqvMD3puiwtb/MjG19h/08Zv/XAArYX6LTTOQu+zYF2sQ/NiPQvVY6E6LVSXheqw5ek846lNx62hF9Ci327Rj3HUj/1iXewbddnroD6qA/Vh39gn9oX9osV5wji8D/vBfPa6qAfrUR2oF/XY4pdF3pOptTBW/i0e+8K82C/WpTrsurBv1M30Z2H6Q2th5gfvw3zYJ/Zl7xfrYj2qB/Wy68n+PiCPfoxDP9bBfrBvzI/6sC7OF86HfT2Z32/7fDCfDwvz+cB1Rh1YD+tg36gH6zrM118beq8X1atMlKSen3zrxfZuat43qt2yMd/am9+fMI30rNpSSioR0Lp/eV/pysHx+Srdkc3auq0+BVRtYt43MfPbWW8bmztMaBGw7ZlRmjLUvZZPiaaSZ3SDa+1r+ZuPVmiX6bSqo0StmfoxDu8zY12sg3lpPYnqkahO1IU6pAXGJlOKhnaUrrTxXNqySRszteg3o0U/tejH/NgP5kddEtZBfThfOB/YN/aJfWG/1KIf43AesB7mk7Au6sF6VAeuD+oxW6p7C8+/+EvUmhkr/RaPfdG8WAf7RB2oC3WibrY/M9MfWvRjHN5nz4fri3qwX6yL9XBeUC+znmjRb7foxzi8D+vgumPfmB/1YV2qD3VhX9iPvW/aJ/v5MDOfD8yLOrAe1kFddj1YF+eL2e/8Z+O/1fHCwjjIf6PDQ3G+zk3+m3kvrTDX/5KO/EwdFaODI//O+gtMnTqMDvIP6SjO1KnP1GnP8I3JP7P+hKkTwtTpwfABf5OOskyejkydwQw/iuF7kL9n/f2ZPAOd64yYyfBzkMeAP6mjIlOns3MeMpupE0+Ya4afQf7c+jd1zkMmMXlWMnV2MPxWho/8nTqqOscp/RTna6bfEbsZnSeYOocYHWvJ71r/Ea2ZOguc8wSkMutyidFxm6lzhdGh/IIOT2b9RzrHRW5x5ktfcea5l8z975g6zxgdJwi7/nh+wX0Mnj9wH4LnB9xH4LkI90d4HsZ9MZ5ncF+D5xHcl+A5EveTeH7DfRyed3Dfg+cb3OfgOQz3Y3gew30Znq9wn4XnJdw3uf3CyAcYDCjA+D8m9Qvb1XSrPET0vnco0ym5V4LPogqNr8pbH5wNi917W+7cK/aqX/UH8ug7+dVkw2N57ceCYW/1z+RhAxpUrJ70XP7SIOeDR/IBOZdyo/8U4375S9+2Ox7H75UtNQ8Ve1dht9xJt6ramvsWuXXqkvsN22+V21dMiV53fY2cK3XLxktHF8uoYwhgKGAYIAIw3HHZASMBoyg32oEbAxgLGEe58Q7cBMBEwCTKTXbgpgCmAqZRbroDNwMwEzCLcrMduDmAuYB5lJvvwC0ALAQsotxiB24JYClgGeWWO3CRgChANOViHLhYQBwgnnIJDlwiIAmQTLkVP1EkJ7xZkc75AQ/JDm8Axu9BssI7gI3/Vb+Hizwe1O/GxKMfh6Pf/WfuD/Kv+TO68Lv/hh8Fod/qy/AL/vSsH8ZKwCrAajrXaxy4tYB1gPWU2+DAbQRsAmym3BYHbitgG2A75XYATmxPyf9x5WK5xBkveC2VPUoNeZGSebk8Jre3R5kxkfK8wUUDtyVEyRH/F7VrzLtoeXD+1bVvDoqVQ8pka3PAO14uPC4QXoly5TVRO8e9SpZL2sZqOY9trJPz11iXr8a6DXKtQh36nPTbIhff3xNeO+VZ5f3hlSqnfZ97UG5hG2dl9t/Tg+FXa0blfFQzt/ShpkeZjIbDhhyGihsLGbKeL2fwKSgY+Ow+Bs2cVoaXL3oYJk6YYLg4calhiud2g37abUMF/7zS0SP1pRXJyRJ8quV01jlOe7MBjXWk6dgmh9nGOWrvyT2hUkyPp5amW0uOfdzkAlr0y5CXamUs8336TsAugNkFZwEogBQXXCpgN2CPA5eOAn9GfIeRAWxGCnfA6B8Mk1VAEIYWhj+Dxpaym5BGyUnbFxuwEOmSnMImqSiKNSXslg4Tg26cpC0Ndk3pBrmefjr9913HdI0Hg/ISPLOUpWFRF7Z1efxxLhqjkybYrf9FZmMyD22K0fWYx3MzY1YKNiPyTZlpEc/4Pv0X8nem8UU/nq7F+zHNVObi1wOkLfDCKMia16d02Biqw8VOHY5aH0CuL5vemXo0Dp9h3FkBJqi0ILr1KO4z3akK0kSkTJZlax9y2dEApW/WZMju4eP3xyzxb6NHR4iIDUcYcPvGzDvWCFsdR3WUBf6Dy2hNdmNWVhWaned5nzidHTanEJ76iYPnHLg62Zrjhs6EVA8j+6cZgoJqlFpI8CThT/zf7cTtWB4yRcupcCpE5Es9W0IVOOpbRNy005jeakDG8hmx+gIICA2jEWRAgfoXzq5tJDNQnQVLCpnh1sKV3h0snqlLcHspbYemE3ByNq7zAnjl0Y+qkh8Seibcn1xCocwlUosKUDQzQhwrwgKX8d5biQsl59GwhbTnAaTFn0HL/BVv9Lu5MV4aM99B7C8p4PUmGbuAXvbetkRK4jN5Ky3Qe11D/AFt5s0t4/URP7Zumgsz02kTnYpMZRNX1IZxnOHKOUsbUgaWExRczRyHh6h/CedT7k5aiirYpSmClcFLJBvfsFmvkcYLETyfI4dc2BfebTajpFQd4feSNAeWIZW3jo7p8Ug3b0N50iJCJ9oSumIEXSe2kXo7mBlf21mxyoTxTi9IaqjmprUxrjaViMrF8OJcGoJx7Wz3C+ZGQSg2fxzmyJ9/cevYVjzfZKMUZ0dnbhnH97WwIN8J89KllNZoIpfwnAKb40x84sfoBZOZuOwCRVuK+LfYFLO7p0Cqg5cmqciv/MjQq/GQM8iMqHK8Kn8ySb+L/9pCuPe5kMe9ckQKRJHvrY+yyD3ElnZweOJFkmf5o3z/CssjCvBXV0Hc3B2f+JO4fZ6JWtlp/pZchdHf7+hsCudL1BnefTrAObUzHP7hhrW1JplDY1lxPg2nmF14+xhz3EqdKxKPyPoownG1+fTs1kFVYBpjxEewWtgZxZ+bWZ50kt2fR5L9eh49gXF4rPDhimQLJ6LiSDvVzbON66kSbWfWWQ26Vgdx186ZBn1rDK1GcTA8GPMN8mjZ5+FePR71Feps+98e1ni/ZOkmD8RE8lHocmGy4ytkhS5hNXodaXp1fPMt5lCfFCvdApkum8FpF3lKylNInbyJk+9cOVwTjqLPOkbH5OAnFEWHqhcMyvLNOwHHgpXYNy/hTEMoNwzOYBI1xJiwY6gZNRKhc4kGr2NIPfyMcJMeEloL2R5yla0hkYyfEMG4L9XsCrlF3fBqtE+OY4u0L7axEtiUZfI4PJ3xhtk8bx/Nyj2yfH/QTd2cTEQnJxG+QAX7UF9E9DQYGzWF9bpJTL9RwK0fN9m+YCLuBWYo7b1InsUZRhmEItLazULDY7irnUMnTQjxWRJUF26jK6KIktTVrCmNJV6rgk+JmiRHRNFg7IyMXSO+x1pwPrqBwTotbl5LpklCjd8B4gO12Js58kPgIfIOqlha5LJ8WBfXvnT25HQgF9lEcogqjse6GV0mQf8cQWo+TGfJvRgsp/6DZoUIa4y/MiknBo2592lNmsJahwSe58ciZjCObX9VMLfPF/+jowmX8qEkbiOeHu9o+Q4XVm2mqPYhSY4Z+FZV8WzkdO60KXHsXD6FqX6Erailx+oqJSGdpLSq0PDfeQy2Z/G00Z2Tj2eiUPeAG/N14dZ5UjdG8sByNPJKaawOCaJWKB7fpLH4b7mG5EQF6h8q0f9xiPC6X4TnDPHBdxeCiYPoh3hx0EOCoUPDyOkLYeOkgYJ0GGbZ337j6Rb/uHsQ7aSDWu42DrxZgWqTJI+VTJhvs5gnXpWolj0id9cQMVxHYNcHtjZcZbbncmwnPid9+wG8bFbiZtHMuQ0jWGeuxYxXD9FoK2KShzVWqh84qJzI9LuFXFPXRPhhDN/uvESyZzb/uHxAdtgP8VEhHDdUYm3FVWbFnuPe9ReoWImS1mfMhNoyAnOecqEun2SpbEqv70PYdTvK5lLIYk7w5FbeCoUxWcye00bHOZTTSO2QAm7zH+AfvgiBjl+k517G2XUtqxQSWFu0FaXeLN5sPUvn42jGmB1nlm4cMZbWTDa4Q4h2NOWzRuDdEMaTxgfk7uzCzGECI4TcOHY7hbt5T1lvvoIZA2OJ9inkhqAeeYaLEaz3p3lpOWvk+3ld+i9fOowIsG/kgn01NTlqxJwpxG/zS1zeF9NaO4kM3T9YJr0M8z3WPM/uwiOihBRlK8aa/mCavjE2RYeQH/rK59cdzAkoxfPUYoSbixl+cxwP13fcHiohUjifAKvduKXepcLjEvo+/pRMcKWnKhH5P5u4/ySDh6zn3d0x7M6Yx8fAneyuPsIYCUX2SYsT5BjFCHlJruz1ZWgoB4ulLdQEafJfzSSOZqRTdGYQtQRZ2jwKiSrWpDrBgrSE+1SVj2ViuBKelotQtAjnXOV7Xs9Kx21HEvoKF5lgXc6Q2Credg5wQs+dd2GKfH15gMG0RFp+PkN58RNUdGzQnm3K1Jp/2TcoysAqV1SmVbMx7QBrzh1j05xyFMzrySt5jZjMaaZ4PcIl2p4FW3disOEnwRPG0Xl/AoNlXSzKUvqtP/liVU7Djp04nbhAhEYLT6QeYbP5Am8ts1gfWkK1/ngavFegNK2BW9LXmK24jC0db6jZe5bLm/JYG9aPheAgH/++SfgcTbRT5+AUWY/5lyT2L9Cm9PMF1o+J4ZzGHRLfjMVFYAUOd1sJPhzP4f+doe+ZJrMj7uG/fxVnq2ZjeKWe+uXmvN2ti9N3Y35damLHS2v8nWLISNmLefd1Fh6ei1GGOVs8hJmtEIbO8lDC33/i4+WXrBwwZNjiK9PGlVK85QhR/Qt5kV/MuOIq6rbeZHlxGAdNbJkdpofi31GMtzmEwv/8CVGcgknuRA4vOMlff4STUPSBj3X+FOkWsKDzGz1Ov38gIheHGwtZEnmH7AAxYtbXI9tgh8vbBs5HyZAgH41zpRwiP9IwvTKLNWdL8dpvR1DAXMalqxPfdYLJFp+Z3SbM/UsKeAaZESuznvt9yexves3pBhskNUf+rnmF0OvX8Pnhjs7xvex/lIib+naWyW6DRT94jh+DneaM2GJG8/8puAu4prY/AOBngFjEBP3bPuziCTY+r/yGCdbEDlQMRMUYnbIRBuVGl4jdCthx4YxuGNiAwMMnzTYGo+H+z25/P6fz09degMjBUf1fSfXx93onU/ISxGzsocjb2rLIbbXKfpPlq1TxDGZ7mKg8w/f3ClX8qR1nlidW12bKl3UDEtW784u+47+aDM+66RMj7Qzpxe/41pu+EdaKLkC1lvq/9b/jS8H6fz0oI3abZ3Lo/Tdc9jp7tEWKygLRnsPf8Ecto6WbQonRBBeJ2jc8c+2MCYn2xCLRlYJHX/HPafdjuTuJd6jvXcf9irNmCZ/sXUrMsctc2fUFj61KsHs1VhX+aPBhwhe81Spn58kuJaBHAavCNnzBXMPQN7Y/iN8nr+ps+4yrRYcK6Y/EPOH6kqjP2G3ST8WxBOJbqeOncT7jq3s36u0VEAs2yuqayvFnu4aS6BPEtcYmkyPKcTj/Yd3sTcTXKoKzTcux3wbNtcwCYtHc+f82leGa1JeVM3SJe8wXno8sw9+rl20SdnQSf4izNSvDnHnVpet+EMfIIiRtEpx3101smkrMrpxwP06CA2fXZvLvEL8/sbN+kwQv8/8ya9g1YvmVDTNaSvHovydOLjlPnDzeefOmUrx7wqrPP3cRG7PXrL9Xgg/6v14/9x9VeNN6bbUS3N8zzuyNAbHcdf4d62Kc0mla4TucWBSpwRIXYeHQvsNCaQcpP2DvfIMi3LR19K2fX1X2CRnvU4gXprPF1qnEks9F+XUF+H2F88JZ94lFeos4GwqwmiSxeEYIsXzqaddH+XiKh3/2IWdiY/Mz57Xycd2K5xYlh4nFGx4Y2OdhzpdtMe4bVeFjXwu/5eJZhUyJlREx7zj1nsrFFtq3nV0nEFuvjI+7m4NFq0xX5rGIb73bvXh0Djbrify0vUVB0s9yueSYjcseT1Qb9VXlDKFnVRZeMPjuUW8aMSq3NNyYhZ9O1vKY8lhlPzowORMbvxlr7RCusoVd7ORMrLy9b1/fJWLOPdHuqxkYr54a/+o08S33ng8d6ThVKfRL2KWy4ew863S8ekT+k3emxAbd+/glYvyW83gha4EqfMiiihLjJWZFUe7jiAVb6NR9GMcPlE81YBFzOFEjVqbh0ebbLDpb24l7TWPGp+IzNsKdyh/Et35st+39hL28942ZmU1sbWTgXvURN80pdPJKIRbMa8gUf8BvJxlqsW4Six1ebXzwHqfy3nomBxKjZ69YIe/wW1o2O9BVZZMN7U5vccXirctDThILrp7XOfIG/zo6V/TBkrj2drWV+Wu8tXzJPR0gvnV228+lr3BFL9shyJDYOrvH3eAlXvymdZ7xJGKD4zEbdVJw0jL/iv7hxKj87Lm+JPzKbruuVCkHxHHdHFLxHJckLjis+R8xuvxfK/0UT79veGJ9ObFYjxNw+zGeFFPn9VCsstrS/dce4rIVOX5GScSCb7ZH7O/jVfq3YioTVLaxCLS6i2sadiY9DSbmjDv52+I27p+33SjRUxXe4it2uIknCpcHvzmr8s6d7XvisGFv633pAZV9So+vicIiw7JiCwti9CS4f14YfvxcnpNjonKvgefiYPx4ibu+zTyVnxxePtEfmzs2z501QeXWDHU9NxyZMlZTY4TKs9xHaljjSX1zuv+qlRGL/DtkF8Gp+VjGlNsqr1luVnUVFsX6JLNPEAsysu6WhEPxcynVNZsYBYxNT4yHBv1Q9bwmKfGYkh/Jt+FpSqGb4AWxmCU5FHgf4rUS7kxyIhb84PhZPYY3saP8Qv9ReZ/s7NznsDfOemQti1gc8yfGORliPrn+YRW0kfHR/q3c9RLUQ71GK8KIkUnQr0WvocSq/9QzK2LxvqsHNN9CQvWRJ4ZzidHZ5S4V76DY0M70gqKVjPeU7euefgA194d3zqeprP0p1+0TnB+x8vycIGKDhiX661JBY//h1Ij9qvBq+8WjMAQnflr6Zg4xJ3ThOFsxQEOr1E/ZAig5zPfypnRIj6p0HswiNi4ovjAnA+ZtvqI1LZJ4R/aD7+qZYGgqy66zIWYvpTJrMiHoWr6t+UpigYfdio9ZsNl46vQtI4nlZfNWhWeDt0xxubGymXjCrOKzOXBnjfXiqUnEolOtPZxceLj/M9T7qsInKcXj8iDIcaSMs49Y0LV7flMezN3yVLTAkJjTo7biUz6UKcL1b7GIkeGUtqACmExVzkr83gRIwrKyPFQIopTcYbNfEIvpItv5RWBUEq1YdJnY2vzr8q4icN5yT/rRShW+cVlqejGYmDck5Cwjri19zwougfqdtkZcbWLRePHIPaWQ8J25vrO+EdD7v/TO6UjACxUllmBiSbjOe3sJ6GSmVYhjiXlXbtp9kUD/+JlP5jqpwrcsvbqiDEbEvXqGuMTmM221Y8pgj6lNo8UCYkFRLdNTBtZqnZEsTeLTJ74fPVAO8+/Wnphd1wDo0diRxh/K4fmbKtdXacTW69gOEz5Dxuxo2yfxxBNaz89x/Qz7NMcrhrsTGyf1c79+Bi39b5UFe4lrjX5Ll3wBu7dcFmLXA3Vobeg5NW8q8vU2dWRcD2aHkXkzDqHcvkRoox318O7+tysP+dep5xe3D0e8etg6e7dd88Ax6oVuzRAjrIdBnQNb53p70XT2ieEouR5YFVXmp9MD6a50q2lIUg9jwi0SpoAfZdo1rIWR1cOuv+smaQi8aUH0FR3EboCd7iPtTzGelF6T7QBj1ACzrqbOqUPB1NkxPjUMtwHKWe0XQtUu0KIbtrqI1wBON3YX2w/Y0svzvPsYYQP4aShvpqf5UPUZBkNMUgPYnCyaP96bR6N8aGNKG2BKkOcIB4GAdpk0p4mRNcCL3oTz88QhVOPdGxqI3QhLt/6xLOcHUELD8PHIuBF8OozfNg0F0jccl2qiHY1AL7exwziAyglYa4B4jeDsOabDBgfRGu7KFkbYCPsK19y5gALoGg16BkpuhFFbak1q0CU6cLLWH6a0EYYlMhvt0TV63fXQAUbWCCY8D4mnjx+Ve7RvGmI3gfrrGpdQ0wDqg+dGfWTcBC5qMVu2C/jUxeHSeobbBIuOMz/l3kK6TI+qZi42wUeTOVFPfHm0duCGTkbYBLJHJ0MnC67SpotifjFJTbAy/GBgLecqfarfgrRfNX/j00eUAGV5o90AyZtg1KFrc59AIK2ZvGEMYjfD3or9seaME9XX9Wk4Mm6GCecXBj5NC6bcp0az0Y5mMHZ3+1UwdI0yX6ScinjNUPn0xxoXMyG9c+mBKUjUDHouGf5q+Dq9xZS7ACU3w1FgKI3BM3TZtBffmdJmeM0T6TWY+tJuGpZSRtYMd6t1ak01z1KHtG0qGd0W+DDqL5M8zYPUvoInQ4xRC0ylZjpNY7nTVR8jfzLcFkhccOU0m3Gnb9jcnIV4LWDKvSLZwARSnP9d7WWELdCbmRHlOuRFcQs1ypmkFshaqJDOZU7QG6zMypnSFpjevFr6jjlH14w80cPIWsBq9KJodTMfepfLm38Z3VaYePZdxMn0IOr3vr52xqgV2nKMQ2RDJ+lZ/+EqhtsKzpta6dPgT3d/2N3GXGyF1tpd8rve/tRXYSwZ/1ZoD+sN0fRzpOKmz56OkltBQ2fCyeuDp+kbGyN+MaWt4NCcOyXN+zrlkjXYzMhaYeha4vNVadephT1x/0PsNrA/+OFR6CVnamq3rjYyboOKXN4ZUXoAlaXr3sxw20BraH/2Sp399J+rVYsQrw3W66Zv+ybg0098q6YjURtYWQ1GCL2caD81ux9MUht4H5uePZUfTK3adG4+krTBrhTm5U3WNUopWv+HkbVBQNHOnHJ0gYroelrM6Eqh/MzfBhw/Pv0rb2clYySFkyMmF6QjT0r2v7UKhisFy6cRyY8YB2rMkcBG5qIUDqTJUhy79tHazM0xSCQFVt7oIyECf3r9+Ps1TJIU3his+6qJ3KjbfL1JSCKFMKu91j1qO+gs+uNwJJfCmPrlh9dzLtNqIR5KRlcGw0Jlqxb3c+ncwD/TkLEM9oxxVDzzCaQilvkqGa4M1uV+/2IGgZTd1scDzEUZOLvFTOlUO06bZfX+ywhlsKXBtbPskivl/buWjL8MFt/1ipvIukjf/M91CpLIIOVZyRapjz21OLO2m5HJ4OBVHmvlsAv0BWubTkZXDhWjplg89w6k93tc6WCM5FD7ciDzDD+aHq89MMhw5XAoonDZEI6mfLcVqyOeHAr3/if2Q75UY6GCzD85THJemVbDnKdtKrRYKFkOLXPqX/AhlDb5fI+FJHLoTjR377skoAYHK/oYmRzEdt94wzRc6ajBj6MRux2Ojz7v/0VwnTrc+aePMWoH2YrBk304gfoZ95Xsv+3wYocezxXFUXF7ppP9rx2k1b/regdDqDm75w4wwnZwdFhdZYxCqQPUGj2U3A7XWOoCd34s9e7m/B6mtB1sgxOfLum1odGXwE5G1g4thx4mYH44de9KkBZiK2DGocFQO0Eipb7uMtn/FbAUJ7ZkMOGUfxfNMFwFOCxa5N3AcqF+Tp+vZC4q4JgW3+XTAJ+i/gkfi0QKWGimRhWoOdD6J/aMRckKUPtLsdRXEEav3jnUwpQqQFHFNfFmrtFRz9+PRnIFZJsZ77BkLtNJdR79jG4HJMw7cs0e+dD8o8/I+u+Ace/ewWEmlN5r+0AL7eiAVN+gGb78SGp6d/8YxOuAoq/aWR+RgPpgdID0fwdYPnz5dwJE0GvLf2mg5A7418SFZ8e/TO3Lf6lkSjtgsR5m/6PmQU14nUzWXwck70w5dZ4fQ3UmLRmH2J0w6/LEoyt7bKn5QZvI/t8J6yyrHOpZftSJ15ENDLcTDga8fH+GCaBqnTXI/O+E3YqM+BRxJN2QflHGCDvBYcE/ipGceErjYdofJqkTNlzSxu+YCLp6Lns8knTCmrNV9ifFsXSdqVwXyTthyq7LowP40VTZlio9xFbCinun7G00rCmPucP+h4yVMHLJzJISHEVv5VW2MlwlfL89bJiDWgD9ePdRGXNRCXon83XqcTylx64fj0RKEMmSfLK9r1FhpvnqKFkJYi08aoRZIk1PtJiKJEqYv2l2/wKfGPr/XdwFVFTp/8fxO+QgXcPSQ3cbxH2Wwe7eXpX17wLWOrhFGGNjY+dxWbv+u7aD3EeHY/fYg8WYhK3I6ujK73ngM+dwVoF7X+c7eTqe73t2kbam6cXbTKuRzzQHJy2VhhC+h44+Rkka6ez1q2ngLlgwiJ+q2F66Di6IpEd+u3rn9kVYF0Ci+J56NSwYpAfp36xc/MJsSZq5hO2tN8GGBLohriHnF+cavF8sPcr32ANhnTuxvlg/c2oCnJhKB/K99kzzXKAfz91oR/vBJQnkFd9zHwYbLUn3sTt2h6phfQRN5XvvGli4Iwn+O1PLS81+IBY078Gb/UzK1v9mV7wbVilJCt+Lr4SFMrH9zKbhoy7DpeE0g+/J34eNFrT26KLps97AX4fSvr5sb96qFs9PIT62l/7/sofZzmTSebZHHwbrgqi+Y3lA7/awPorsP8P26rvBLt2I9N0fXg1fwdnB5O9FbM8+Dz6WTJdtSKo6UwgLIVT7I9u7nwNroqnwdcFG/RqYfd+Q9XwPH45MISbv64esD8P7OpJpndhe/kVYH09758iHjjLC/ZXUtoDt6b+CIyOJU2yk/pMFeju7/OhyvrfvARut6fuE7YOOhsGqt2LPE2yPvwOs9CJ/rRwWo+0OC3b0LN/r/xbOCyNB435bfWc0rG9Po/me/0RYkNENIUUPUxaaHUesbNjefxm8MZXObhrUp2IP/H078t0r3gGAteHkuLaX9y/XYeGptIB3AWphvRexeGM7f6gJVilIH94JcDD3k95KjdoFz4oCYKMdiYhn3YBE2BBNhrTpqjndEX7pQ9fwjsAXcLY9cR/eMKdnLlySSrbwrkAhrHQl8+MrB32aC+tsyOWPrDOwDtZGUe24dkGPdsHqGDKFdweOwkKVqIkQ05uumf1Q3HCZdwjg0lia+yb4ce8PcH8FKT3IugRO6FtdTSDbZq8ec0EJq91ILx/WKUiBu/UhNd0Oek7vCqem0uZuwTewsFIcdfxV1E9jYH0b0p93DCbDmrvinh4Rr+cthnVW1JJ3DTbBakeaM271QaMWLnUkTbxzcA4usyDj/nxzdGQ1XBBItf6se/DaPHehdXuyfoi0QU9M5UqNzR0E2GhPno8wVfnFwSo7msC7CCpY70Q9/zUVdBsM56SRs3rWSciFXXzogcqS2VuLW6zp8jVN4d2EhZh396HVxwZ8pdoAC2fFpbyjcBBWychsxdh457Ow8qXodox1Farh7Ddixo7vvvN8A5faUIl3Fmyf4fvZEdMpecwgX9joSWfMYd2FBDjSn1iuP1N/qhNcJiOLmjsMsFAt/vl4eO1vY8xzS9qXdxk0sMGBlmY35Q9ZBusaxL94p2EbXNokhk1Lvz7hMKypE7vwbsMVWPlWOmLtN+JaDaz2p09Xs47DR9hDQYdO9B6d64peXnd7UrOBdR3C4Qsq8v1zRUZKBpznQPbxzkN/ONGO5o3NDU37ERYeSZ1596EIfmdLww+e/71wIax+I9U2dyBg/SPx4ZkJMxvKYR8FccxjXYiLcP+3oseMz9ZvfwirTojuvBNhgjXPJZusA35rndF5KDFJ/1fOuhFhcGks/XX8ne6n02FhuxjKOxL94ZcN0r+dSwqTc2DNGTGVdyWKYckkThVDLQyL4Oyr0gLemdgCO9hT12uL2x+isFEnLeXdiSst1tx1oc9DokdX1WHe6bn433NFh6VvTT72sGqvZMm7VArYy41OtcjwyAuCVYfEMbxTFQuvfCGeqXCNv9oBVp2UZvNuVSc40SDmDm4cP6wvnOlDv+Udq2/g6RZ0WaDo1OZHOPuV6PMP61qp4VBPErd1fMzVYrisTtLzztUsWPVYPGWb00gXwwUCbe5erYOFlVJiWuCak9vgsibxYwnvYMGnTNKcMQ+7vNLBuipR0Z11sc7BSmtiGJIWkmGA9SbpDe9kPYB3+pLN26qHbXoB11rRl5dZN+sDnOhIe4XciEy0Re+0/yvxO97RcoeFp+L76KE7bgXAkoJc412taFhVK060eu2xtT2sd6J1vLPVETbWiqlJ/ZYs6wurnoj5vLv1LZxoTaqP5g/emAOnWhLXgbzDBV+NJH9ULJt5dRKst6ZLeJdrDlziR3OGdPg6fAX80pVs4Z2uDXB3F/Jglvu7VX/Dad3o4CGs21UBPwwlnfwilyWcgpVt6B7e8boKax6ISap9Q2uMsK5eTOVdr2dwqYz8cz51euV7uMCXLpzPOl826PsujSMBWwvaHXaDBYOYdYd1vwLhtjEkxL1w/Z0Y+J03qfmBd8DgU940wmPqh8AucKIFseBdsAFwd3e660JA/oyhsNqNKCayTthoWO9KnI3+bZ0K4OdJ5HPeDZsO6zxoYsWiXw8tgg3u1K6adcTWwbvkZI3TpZw5O+AJwTT9JuuKaWHWK37v83vapOOwxoVWWbDO2GVY70QLPUcELq+GlQ3SxXjWHXsKrwylwSW05+X3cKKChh3gHTL0qdsnU/tNz58le7RYU62m2husSxaEefdgur5ua4Y2Hl4ZRnO8WKdMhPUBJML0IGd4D1i4LTnzbtmXsCGRlpfcXZ80Aj4VTNK2s45ZPpytJJ9+CQgJn2y2gqbyrtk82NiGHv0831e1Gh7fmSrLWOdsC6yUk2U/PT0yeT+s+Zy85t2zo2a/EIPvPev8SA+XedGK5g4anBhOzvX1q1Y/hTd3p/MmsS6aCb4t0oqy3KPBcvTStWFkGe+kKWBdAOna1S7iQwic7U6V21g3LQleGUKelE/PNGXCgkn05h21vrCuUZJd3tJR+b3Z9lTBu2qjYI0bDU+ZmzO2ADYmEoF31mbCqjhq9ffie/eWwkoHMp531zbA/QOoTDu2fuJuWGNL7kXxDpvZ7jS50kubdcFsgdziXbbbsDqWLN9hmBL3BDb6UYs41ml7Dyu9SWVSl8lZ8rf4/HIazbttClgwSfUDMmsnhsHynuRmX9ZxawsbwqnPzsaG+x3hzsn01lLWdRsAi93JaNe6O+pseFcouRvFOm/j4G+ziNOx+7ciJsHGKDqOd9/mw/IQ2tu+KUK+Fn7ah0Q0d+Bg4ZjUULT1g+shWJ5I7HkX7jR8KpxmLlhV2sUAr+5K7ilZJ64GVvnSM09uKzc0wmovouXdOOvGFr8LJ57/nH8c7QkLMpLEO3KhsN6T7o/y9r+TYrYbdedduU6wpl4yLZA+lQ+EsyPpihTWmRsOf8onC5LlJyvzYWUHOol356bAmsdi/tJ1uxtK4YIoijzIkf/0F44IWforU+T2Bot3IwXZu0BBphwlyKyVgkzPzO/D2b2B3fOHP2RXGQ5smw/aWuOgrW2rA+eqUS2Ps2v9OBxst8eBeP7a3dlrP8Rr/8LsiEP0zuyXf56xypbPUMSu2aNa7mex+7xRLc/Zyq48gOHaKoDhMVqQufMrli/4c8rwfD4/heco8Bw+38XmWzGvxdyr1fx4q7l8dMv8s1bz65jz+5pW78XSJKr/Ab59JBQ=";
const depthText = "eNqtWgV8FDnbH1uXbrcu1J1SatSgW8PhcHc54HC3g7JY8SscLsfhztHi3OEuRYpLC3WXdZ+dfJm270t/tJTvhfsnmckkT5InmUwe2d2xc103BEHiG0kJCLI4rjY/KxHe4mFKoJ/rymFaLEFqERedOloSnVrQprbuQSICpB0QRJS4/0hY4vUBSklF85etq8cvj781Y3jib+n8hJvpbySu2fMk0scJsV2W20VNq+4SM/je5UjrcmPkbKR18M1dj8L6jT8ZsFf8MnL4TI8wpbtl3PxVJ2IVvf08y3a7HPIHW04Mu7n10qRS0PrpbdmyYo8L1xwCbEpl1e4oWHt6jPRjicfhckZZcUxw3s5nD0aniJIyem+ZMwpDMQRDERhQgCK1ACigU80NPtZdIAnAAFoLHMUwsI7FYDEZTIJJEAycIDACwzEMVtT2BWhQZmCmSLOZJEkTaTKaTAaj0WAw6PWQ4PshuInQHENgcEAcXnCcTjh9J7C6iMNAA8UgHcDoWVAAmAEFKDglABCUjvTcEZROCD07pO4Z0Fe6CYCBomcCJ0KZNchkS5GFEAYBTCKhSCSyFInEdLC0rLmIxBawBNYIIY1QIIQ3C0tLaxsHp/g9l3u4eXj5+AcEBgUHB4cENfdxteWZyt5eO5Y6f0yvzkkdfho6LeXPc0/y1YSls5d/UMvg0JbBLQIDfH08PUS3JL8jxY/P/7l27rgBnWPDA9yb2YqFAh6XzWGzOSwY2FyuQGht6+IZFJHYffjUxVtP3P6ktw3vP3fn9XOXKuRymUKuVKg1WgNpxgguT2zj6OrhF9AyOLxVRESr8JDgQH9PN2c7sQWXiSFmg16rVikVcoVcLv+hV7UU9RTYC8UctpTMUhUrqrQ66cXXAgWmI8kuZwuFBhbFZEvdl8YbisVAZi1jk8luKUnaUitKblPFMW2YinwG+JypCTDW3591FZ8hXYB8FQDGJoGTyPdDuvh/bVHHOoCQSkHd9JCa2HAFGsz5M9tzVwLkewG8s0EjpY2hEbKEa/rv2CdoDeTSRU133yRTcLW/H5/P+8VxMNH3L877xZ/P+7oyOl//vK+f/+K8T4DnfdK3znv/QduitN5zYoYu3BB5K0QV2fV6QCiL0IQNSdkUtNp2WuT0QbbhpraPJVYZeyR7Nj+RHDu2TTJUMrarc9cBv84HGxf13/PqdtlC8CpZzzl+vhPzxfxX529IH2iCp9y3QqiWHQtHoODnwGGGSz+D8XHbwdJr7WSd2rz6a5S9JnPQETDYNHL3Mev4XrLyjPOaKB9RQZt2fYTyyUE7/wGZeRXdWqz+OSYILEn6eOro9LbWorjfgwsiU4cutqBI+jykAL35MATDMIIgoDjgsDkcHo/HFfD4EAIBnXjwSoO+C/hCITilVMBQA4VKpVAr1Sp4Lql1Op1BD0WE2QwAisKjnGAwmAwWi8lis+ABB085Lpv721wOh35gM+kKSEBAqYMC0qTTqBTwiFMpazrSa/U6vU6rrwk6GLQarUYtNskVkEShUCmVKjhsLVSQGblSpdWTCMpkcrhcmnehAAYLC6HIQiSCJ7ultfUPHYOzlhgpqqYDWq7WfrifJSsMdcIIQAJIB+oCBSsJ9o1QMy13ayQUhiB0ru6C0I90FczURbSOEga63PjniGo4OY1GByWv2UzVVAHKoJWVF+Xl5BWWVWv0JHyTAApog0GrU6tUSpm8qqqioqS0sNDOCojYCKmHa6fRaPUGE0kBlH7XDLjy8AIjTqAYLRzNZE00wyxA6Gk84npsjgpt6e/r4epga8lnYgZFaVbGtfSjxy49eP3kfOrkYT/P234+s0SHCawdXbx8AluEhUfHxrfv1LPf8HGqnJUifygmQyIiolrHxERHBge4WTNUOffStswb2TEi0L9lfN9p6/+6X6jnO/m0DI+OoWnCQ4NaBPh5eZ4fcHR5dEhzP08XZwc7ewc3/zYDVj+PfzxyvyDI0/bg6V3XnqZ0uxJ0Z2HPVl5O1taWNnaOrl7+LcNbJ3XpM3jMpx39WWwmg8BRhKJIk8kIl41CCLbAyt7V0z+wZVAw7NjVXixkM1DKTML9SpqAGa41RkAd6Ic2ydlSscBBKGIypYLb2lxllZGUIv+QRTo5SWWXG7kWXB6DJbxcHennj5a+uiMNT32fiXgG9NrwROrmanyYIZYVkx8rMbsIadEr22q2ETfPLMsRy2CGXB45+qOlESUN0ov7/Ss4JMG8I9VddyoT6IzajoWfECWXZODGz+cvjP8bpMngm/hqYxPR9BnfJAys7xyVxg9Jecz83+7h/YtvuibUxrpCUC9AfGYN/M+CetqGhlME/18sWgoakH97+eumIbndFFXTq055ZTc9TpPs+L5rWFyj/yNmo95AAphFv/bxmZOXIHVocpDGCf5l/eLGF/rFjUb0i73/qn5xauqjqD9TJsakVp6I/EcBIl28tGE7h68KX77gQciLi46RbX6PDXs0Y7LkfOxqScSJ7RLFinYSBzxdMq7tVYnFnP3R46bsm3MORLq/UDrldfsDPFirWbLkyNVe7fdoJPHjBp8NlVud51m9J2W/rAQXNgnbjHqd7v0MaK9dOBb+IPWlGXshGteTmX0jfsRpHibS3IksBAu6nR7aOfNimsXqa5UH82+DymOpPTmjhgEr1Sh7djvWx2yPOzlXI3//cAZcmGRYuHBy4QnrkpRr0dv7+I9dETUnUbUGm344E5wMGMVLtFmnBmWJz2Z3jAdpyVjx0V+dZ/S5Ou0K+AW9PunCpsNb1o2JdO04tZnT+w9ZWVnvP7x9+/pl5pOMe7ev/3Pp/PmLtzKLMeeIrv2GDe7Xs1Nim8iQlgF+vl6enp4enl4+vi1ahEfHte92clNxeaVcoVRrINQalVxWWZT/7tm9S2lHj6Zde1Fq4tm4uHt4ebq7uTRzcnCwtbEWi4UWPA6bQOHWnOzv5ebsZGdva2/v6Oru1zIyodug8XMWL104Opbz8ujaRdKUTXtO/X336avsnMKi4rKS4sKCj1lvMjPu37l9N9iftsLkMllVZWV5WVlJaVFZSWWVhuS5dZiduqRXAI9SVJcWFxUWFxeXlpdXVsmqFXK1SqczITjXsvQXsZDHYKDAbNLr1HJZWWlBbk52bpGc6Z7Uv3uYLVCWlcABK6rkKo2WluwIxmTzxfbu/uEJnSdxiiqqlBod1MZAzWeGQ+kGhSKlL8/6UKTniO0c7Gyg/clhEChFGnUauayipDDnU/anAhm2ei7y/eh2i40BUGOkUwg9NhwaaoB8Hp/DQow6qK9BTcZEa560JkOb/zCgGEDMZoPW4IAjpBmCpBNJ1iQKYAw230Io5DIwYCZNsMwEKyABDCb4bDQZSRMmThvJrmlMjwwAncwUaYK+Cr0JEBy+kMdjEQSKglqgAEVxmjWo7/LRons+BsgpSrtTYETgHa4ZA2cQGEpBJcJEAlDLLgppYDUErfIBkjSSiN/eRSvW79x79OTp9PS04wf3bP89dcP2tNfC/juvXjx68enFBaHq+8d3bd20bcefew4c2Ltn5+bUFOn8ucmrj2Ty+95fT3yqVmuU8qrKaplKrdMoKvJev3indu0xfmjHtr26BjErc3PySypkMlk13EdV5eWF2U8ubJ+a4ByUcdzHIn/prFG92sdLkroOX7DvlfXIvzlJ8VmyyTPWHM0wbvcCqzdYB/Nuz/QrPrtu+vD+ffqPnjR/6aKRvjfCD/R55Wviubp7+TUPjUr4adCkxdvPvVQI3Jzk0ksn0hxvTl3Wd0vatHeEAJQ8Pr118ZSh3dq2Dm3hA78Sr5D2E3Z20LO72Hh4+3p5ePkGhid0Hz596bptxxX7lRnPds3SThFFTFxlF3Jr26rkqaN6tosObu7r6e5kjcs+ZFkeP33u7lnXXn16d+0QG97Cy8XRzsbJJSCqy9Apc34OeT0we8OmkvHlHeanLBjbPaa5i72NlZ2Ti09gaHQbiSQ62FuMlP+QjmZXWEARXGh5SPW3qou1agyTMp9X5cqqSepSsVBob2nBJI5Ps70H9DxAHJZaZKJlHITItZa+WH5X2TbCPW9l0LzWgqsP3ruTK9xacZlOXiVKaVmGXFkWsD+ELEhQl6IZ0qOMhMwipbNUnsdVYyRmnqWo4KowEjVLL9/gaAgTjixvG2ni6QkSHLee8aaag6DUMmnbCwSJm5GX0iflFoWYCWVfDAiQmU0E5b1PLs2r1DApS0m2z9uPlBF0S/8efakOEzeD71W5ABBWI01VNw3c3Hj5Nzuor2V+rXWT06CwxsvripqcxY9pmST+nx4RGJpasC/9SXVlTb6gpl7i58b07atjfdYP66EpE6JBHw2YHnngW/uqCbYXLYG13zlpTFxlRuqjzsWMADNtCJrMFEI/w9IGc6Ioo0DZmH8LVlLmOkFEFyCNgiJMjS0YihFMhrZAhrMYOIY2tpQ0jXHK+q+uNQXR5Ff9L/nP6lJD/1luw99LYN2/+XvJmxdDo7XmAzE9Fz6LXPGHIdLvIdbqEXY1PIpXETaWNzbS0S4tjDVWFtuiHVfikRwg6extIxkx0Uky0N5Pcl9sIxnWdt7402d2M+aBWTaPHM6+63QDxI82yB58SkwVjpePXbXzdaDIt0fvlVW2EVGxAeBx6PqVorbTmIPA7z7Uijb+xzKxclP/Mz7TD/TyZA9PnKD99L6ZGBxYcj3+DQEGu425Yu/r1XHWxckTx14f1eLRe4Atft+HfaCz9Fj7wGve6w8Dw+t5Uc0Zpzb2GM3NkS6YGn5i3djqKwV2pXeXXEaWph+b9Otu3GvHMWBZ/M+U7JsH2Ev9HF+fAVuvDrU5GfMMIWJ2lVd86N4jibzjPZF7rd/cLaBvM92fqVOuWfFF83V7jJwbCrd7tikVb7v/vluUEBJYdTl5xBjN4xNA/WT0TTePe50m51hfTDFe3BF0fPbCIN/ALoCrqwq6ErTvYLldypbs5KGOIObNascD24/dPu7icH8xmIJt6fGX055LEdT9nUntHcisMUmr2iw+DYwe2cOHbjDdOLEkJyc3N4+OBXl5n96/enjr4qmDO9YvXbg+q+elJ8eX/jKgS3yYn5MVn8PhW9jYOzu7uHsGhEq6DR43YWLguhc5pZUypQrqsAyeUCTkoAZ5cc7LGzsGuEUuK/SLT0qQxERFhAb7e7s1c7CxsRSLoKaNmtTVFaWVHqPbNHexEfGh/4bJ4VvSmmxcl4GzdxfF/9avtX7RCaxr8u60q/efv88rqVKotVqVsiL31bXDqfMnz916vV+XI1eefyqqqFSoNHoDrfVpSYRn6xMcwDC297SOiAt2FUH1VwcDVKeViqrKkvw3d9N3rF23L5MjCtHKFCroJZNXlxUV5BcU5udnPb166Leluwzvbo6YVZJ2KP3Om/zScqjd5xcWl9Mat16lNVlKfr2qwAqvz+ge6iRkoAgKNXAul8VEKK2y5OOz29kz+z4oPnr0wu1nb/NK5FoTQAEgTSTCsPFrN3Htn5vHCA6F3rzzptyAsAQiWwe4kK5uri5QI2JVnB3B1u9JF7+aG8bXVpeUQIZyCwpLKmUanRnj2nqFton1rDiuZyPfj+G7oLMWAThUgjEcAoM3DDFrKj5cPCrv2TfEnsugAK1lU2YaJEmr7Awmly8Wc9SVBXIOT8BmMWt+uIPtoR4tENtZ87VP/jhYZevk0sxByMGx/4geDGcKrJxc3Zz4qqxHT5+OsNLI1TqS9hPTujQOIzBpqvMep11pv2+0G5BXViqgw9NUYwGYTHqtVmtmu0b/1C2EPPQmyVNslMtUGgPkqM7xCc0jFSnusK7f8dU35AwOm0mgSM3YCIViBEcAPcBCLqYry/lligY6hTlMHKl1ztIXjGBxCW1RvtBbaFRq9LQnAq91RqAUBd3SGpJt49o8yvvdpkFKlMNlw1khgIKAFxSHG5UNFNUkn4XSA6IUSncNCRC4bEYSIYT2zuySl+XVCCXgsgkEmM2Qa1hH+xwZ0FGNGmSVMgPGt+CzUboNXQcB+WLxhAKqMr+Sstpkrxlb2GHtpQ8qtpNfcJCPNVnw+PqlUxvHjveYenPD/JSRq05eufMsV8d38fHztOdocm9s7adfyHgT3kU1Of9dokOxGmMRGEWaAJMvYhkr83LeZ56a1OqSGLkrdkw6kFVekvOx2MQW8RgYwBlsNlJ6ZdOGv9K2VHZRrX2yrd/aYCGGEVyRja2NvVfM2JOxE949HezyasyvXaZYGYVr3sxv7+doBa1mARtj8ALmhk+Zv2zQPFaZIGiIOS6mhZuzvZNni9ifhk9PPVviNuKALEric/n+vv7CORM+ZR6e39Hi7ZEVU0f0kLT0cXHzCopN9H4+dxLC79Xx0tIU2fZ2zfhwwSkzyhBYOfp2v3w8pSRLH1SVIL16p4uHelyws42IDV8TgjN5DpLfFP84vvl14DJbjtN0la0bv+TvVQNCRdrCdy9fZMtEbdcVhnV6dyUu4ud9NsZoZvoQJ+XbjHsPXuTrbGPG73hssHVEMxb6Zh1Y9kP2Bed9BdMCHgG4tCRDW65TIYhU96GqEO4Q6nIJV2xvIWTiN8dWvBaTLBS5LH2r12hhxvuD9PLtPIOdRY5jSrtYZ1aJorQVmto+x0bl6X6OKT3lVcrLfi/N8Lv2iovYui3rlt41TMYt8N8gvSMXMXCdx/lZD9+yERYmFb201OJqnMQpzLyQ985Ojasx+ICalzgOMoiMOIWbCQpIs06IiwDCMGIkBoqkD1MG8spVXCPDhFvZHdG25SiqODgwocUW0l23Ew3FOIeCzui/m0W+d+IXIWKSBO8DC2TNGJZFOAclMaxYuvPR0NxSPttgRF3+7pyRPlKgxjBgQN5K358UPw/nqFELA2ra0+EqFJqZdiK9Ab0x34S3TLO7rnXH5YyjQdPXzN52axrzLW6l2xPQa7P09JthjNeopaHdJfD9hs701Aa0TbevT2NR/fVfPBH6428KTONX2f2mrYPoOV+fMhy7yeVACcPX1fUv2iINdHLMTJc02gEFmzfG9GcalPphV/xXrKNvmHe0p6eJN/n5qU4WfTExFPmqFfqNn8/pxk0Q1O+ygfFH19WrhuEza/XNvq8tBlIv12CZ6g8IavJfEtTmGy7mV+zp+pUzN0IR1ShdzafRaI8URdHGE4YlL61jvOHyohj6he/+Cy5xnsKMoY0YWGweLisqN3O5DLyRaig9DEYE52qpRr5kWs6bDdDhCtBaNGagoYBpMNcr+W97nMGy4FyQWXGYBNawGgFmhMkwmIb+QY/U4CXSa0WLezrXwKhG68q+37b70i7j9LwVNa3gxJlhoxTrsnsWlS+JGZVzoLvYsGLV3EEs6zWtlu9asiJYVAjGx558cwb71MJg+Vdi5h+Tu47N+W2eIExR/OhOLD/gTaVgDKfT9tyK/AV608yHW1MdHVIDN9t1OLlLtLeYMe1S67O2l4kprjvOzQ7gbG6NX2D8MbVDUI9CK2JqdufhmeOm5t+Kert0ffTHKc2iuzVzdtMOeXC++31LXlSPu08Yt7kPZ7DAxUdXk4c5flrXufuZ58+Mq4bwjaDvirQ9C9kjF4hDxr2YeOPIh1+Tg2WJP0VH5xw4V8hevOiCxe7BjlnZCx/8MoB3P07oKIl6uO/q+V4DsvLjJ42fPqldd5dF2T2QrPTtKbOqLg79qPHaNHjyO9VP26d2VnXLf39BUo6OSh4+8I+YsaWrz5xZ1vdWG02fIwmd2ttwJLHsqT8tW8upFHeqmMBrm0wOXpMwbvnqgNf0m6EoE4UDg5nBxAHUkOkXRpho/ZgAGKI1MXG90ogzcALHEGBkAIo0mJksFp9h0FMMxAAVb9qbgJO0N8KkUhvNLBtLgiLNtB5sIikSB4BC2AJCJVMoTFwR/Z8uQGvCmBmOTepNPFuOQa1WyAwEm8vnslkMM16z2UmlxsKObYKqs1GrNgAMqvYkgMAYuLaStLYiSL0R6p8kHINCa7YoBUW4vBoRi5km+lc4hCLrft6EGQ6hVZsJFoOeBETtBTKsY/ARqBbTNQicRt2mpygGpjRZCgwyNWCymBjkB/xnZ+M4qaPYHIweg5ZD/wfPABEM";
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
