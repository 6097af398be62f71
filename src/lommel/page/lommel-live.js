// Made by `make page` with ziglang==0.17.0; SHA-256 of the sources: 41e6dc3b4add00b827abdc9b110b912850e98c77f4438637da9c8cbd9849fb06
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
const wasmText = "eNq0dgd828b59i0QII8kWIup5ap1QURNs5eV5SVRoVeWd3crq7YcS96SvClRsRxV3a2dtrGzKCp77/H74sh7ZO+99947kfU9d4AgKuO3/wcSeO8dz73rDiC1TQspIYReZ7XTWYTMEjkMMiukHoow/CfVf5qbRfBnuRzNzuJKgHurYvMseEoCFstqcTab9bR8Ae5UcXDDXAnB1QylTls1SmsraCvnD98fbZ8lWLsVDKzkweOhHc16fiiNMCaYFscAJdNTAg8UyKzW1/bKDPCG5oLQ86xyT6+dhdAD0lJLW2t74RsQH99fSviaRjFDqwcLwZAEJnAkkLcQT6x8L15G2Zme35oDQplpPvd4/mKGnww/K35gUPeevsS39Bxlyi1/GS/zyGCQKtD+IkGulZovy/lu+KJskOtA38914B2GXm3ACqRuDK9tIPNwDbVS8AQfBIanEASkQMIeSDZIWxCIn0tLEy0KNZILBvi+GciwTyp1M+CGPJ5XBD9WyH00mg3M1MSH649UI/hPv3EwBivq1grWAuXbtmJoWYACyrfEBvH6zm8gHzxIv06fn8ast0DQCQDWvYIH5thwrd4aflSK8HzG8IvWgv5Q91CwGG1RzBYw2UT+wxW1TfU1TYtqlzTNW9xcs6Sxbnl93Yqj4rMXLJ49v6a5fmFdzel1zSQcWrB44cK6BSa0GpvrFpGIzxBza+sXEMnzsU0xQqKxuG0nfpAYklDDELYdD4eIYQtpSytRkkwO2e+HEBAijLg9NB4vFbYcZhgCI15KKeeMYeb/wLQxhgDGoqWWd7Plj6JYIFH24yEJAhViEDXwCIYsJYYl/IGVLesnkkoJevhP407KBc/a3yz/2QHi5weK4QcJ++BDDpFqtUMdeZg8XMoS44jDjrTgLz/ggJKSIWbJUcNKbCntowUbceQQW1SIEaXHWBhgUsRGsaiwiRGSQhpxQ0gBSohSg9jqLxGNYkr/Hh/08O/fmHyXwffcMY61hwqsc5w4HukvP2HoUL328JEQjaJCjBzwxQYlkBEmJCGjLQo/peLTo5AUaVFBEY0NFgSGXTKGInDjCIl/wgMhdgWlCB0sa6QsHeuWGkalqBRVI9OyEnhHlVRzyzrRNjKGYVmUyjgthf9wNC7VEHYpYPCTxFYDqAdyi46zrBJuHm2ZdPyEZJJanHNj4qSTkhk65uRTTh057DROJ08ZJqfa02j8J7ZVMn14vNyajHYgOgG01GuipJm0Keyp7F91dLkolTN0RGSm1rFlcrQi4pYYK23lBUWOOIfJ4dokapslv+CUm1b5yfLk4cNLSoZbMyVjDBq/9EKJ/8qUVgX9tR0X8RNtmzu/+a31u7ht6THx9xN/q36GNfEPNUmq1pJImE1LbdBIP5UV5VIOUQVR/SlmTa6Ix2utP04uMWU5lRy1GWge2+Lw5Te/Y6alPZiiPeAni9n2nHjckvgJq862JJjMskrjNE4pjWsAyxAsmZz7u5rJFj39NyE07PCSIeVjxnAdbalGMqykqqbnHMojxhpHJA1iGcVcYRzxzekYdAGfl+S/q6mnv3G87DT4sQoryefLBVaVTYV9qpQqFPC1T8zibChldAQcl1PLx5UsFGJRyciRw4bJA0eY8sBRSdMykcVkUspMPGNmqLTNmdhfZtwc1E5T0FC6f1UDW2IKjaugJdFtjkB4vNRPiLpUBfoLADIzR8IfUioNmw4QGMOHD3WHDrUwKi2pc2gtTi45cqLESskMFsPSeoUDRUUymVw6ttEaaSHQw0+mTdI+3poq5BQsAEx4IIEKgjcDnlCkQbUZEqEA4M0yQ/howNU8qWIDE1rQ9NWWK56NwxOtWlJSIk3lclGLK3DBMRQf8COkGDHCM15BS1d42TI9fDoQq8BFLMQ3lq5cZa32HKEqUUsmJjMVS8daGFQtdJyFjg9y5SFXiYo1B2SPMxHUryuqWioEhRwTaPgH1qC7BidqSRqfIvkI5aig9lCO0mCZVqTEsltzlm4gCST9QBXVaqXIi1dkmPh+aCfa6AhRKvpZVv/TJkZ8SnRGQo8z6FqKW6JFmHQJ3Y3LEJSsZaFjzRxNt7W1WTJH0m1PnqGfRE8e8SZn+c8t2zylHY9ibv6T7RdaWLdwceMqRmRN/aL65vraBfWr64gQjYsXLyQbabiprrlmQf3p85rJud5kee2iuiZyIeVLmuaSi6icvay5pqlu9uJFc5rI1VQqldn1jbMXQOlGGvXImrrGxsWNZDuNL15UA4NAYweNLaqrbayBeXNjbVMzuYeGlbyxrnb2PPIgjSh9X/dhGm6snVO/rKlm8VzyBI37NupFXz+7jjxJrQDlFSr+uGBZI3mHRrQ/tQvrGmvJpVFjTt2S5nnkyqhmz61f0FzXSG6Ohnzqtmj4C0ZJmspddNTY0WOqJoyrrhyfOXHiSTi4T5s8Zeq06TOWXU6voH8R9xkPGI+J58XToT2hC8yPza/MF6yXrKetW+Vt8mH5iPwn3UD/Q/9Hz2Qd7E/sz+wv7G/03+xcdj67gHWzC9lF7DJ2BbuSXcuuZzewW9it7Da2mfWwLWwH28l2sTvZ3ewedi+7j93PHmaPsEfZk+xp9gx7gb3IXmKvsdfZG+wd9i57j33EPmafsHPFeeJ88bu8+Fy0GWcYa411xnpjg3GW8V/jQuMi42LjUuMq42rjGuNa4w5jp7HL2G3sNV4zXjfeMN4yLgpdHLokdFnojdCbobdC74RuMG80bzJvMbeZ280d5i7zcfMJ80nzafM183XzDfMt80yrw/qT1Wm9Zb1tvWO9Z10cviR8afjy8I2RmyI3R26N7I7sieyN3BV5KvJ05JnIs5FPIp9GPot8EdkoN8lz5Hnyr9G/R/8R/Xd0Q/Ss6P+iG6ObohdGL45G/v25uylWSRJNiRWJVYnViTWJbKIl0Zpo002P1m+niXU0cSZNdNDEn2iikyb+TBNf00QvTeyjie5o4q8xuT9hVWlyINvy6BmdZFyMEJlGQY/15ol2bBIir6ZQYlUO9ow1MUYckiF6PJ8rpIjm99mTwafpM1Y2pGiUycEqEPQO1bdJZem1S5QKlVr7pCK0Wbwf7dYlp2q0vaavOkgFgvfn6dvJZen1NlSgoHwwG66qrujoKcjHLJO2shxt5frPW4FKNru8uqLzElfA2aWuURzGiQVf6InS6YZ0W8IxylKGVP5sdkPa0tRiS7lWbBkKLMO+ZbgsZSlLttmNaEvpiWHJii0j32UZljrXRnqfrbJjQT4x5oVYcFjelk44ffeKhlQUSmEtBGq/1Imm7zLHl0FJAG5pKuaY+mk6Uj+FE6mmHdX7+vSw26vbvJFYl4o4IYgQjdNZDRnRMrrOjTtc8bkygoVrt0LRp0OQfUOdt2bdBJhO3AHpgIStE3Js8KE+46psKq4DjDqGYzWkz17c4BrzXStNEQjYVrryZEQUcayrOlLciaS3IAfzr+pMRaJMhf43hG5ovaoGldFqkuKQaE4fORUMmgqBGfcF6uHE021Uobh2B1wJX+UmOtcpnzqqybSr1qVCcDbRmYqj1TzHJsCDaMpwIikO+4jmAz89WcEHPDjn+8aVv/C0AT7bSupwx/awOUy9yzGdWJMbdgTQoR/PQikUJIUrQNAtKVspw6NIi6NlLch97pewsVPwPSWUIuo6PiWqwWtBtDkQarkyZc6lw6egYYDOV7mRS9K5BhcRxxF59VYCVB163A+dO4byO2UAVa8bmoKVQqtcDnmMwoZ2qls7VNO5VDjKijsR/vn4qBVSjfWxrCi7LcVUCzvh+dhN21egjzFV1ARF9W+B7cFegImLLq7F0rwajTUlxhQYllW3znVem2JsIegwfw2XqYYnXS7zcd43C0AhBQeCLr0bjMSZMCLwFDpQ6Ov7aUXh5v83oG/DaVxtllrXbJ9ShmfbyvaBRVIMtv048gRKc2k0lNrb41QoHAfLgQwJGY9ckbRoSCEMlRGIWZRIJEsXRH7GKMupBKdzWk8575BJCDtNHdrsUpXVk8tcCuPTXRIjWIbomqQdh8yHWl8fX5pugWE6Nkm1Ifg03d4mGtKJ5coIOldVQ6m945IUhYO+BWt22YHs2sdwmrsEPsM9PWmAdaLZIQ3pbAMiOBZBIE9peFEFRS1K59RJUk2dANiLXGEi6q8fVZgUmFDVkwbkjBYBUltCtEeLtE+w0jM/HC9KnRXS76PKK7xgwO/jx2omZjoXaeUaS2MFNimG/MHJFJGOSh1v8AP4xozIZipQMt2PukxEEYcR4sJV9VC7MU1TBirJ0310KermGOpGHaMhJWCEh9olFJvE4Z6l0JYAk0oXnuVQRbAnlel+ka+FDJqjWdpKczy7fxsGMjrfpeWa1PsM/qHd/U78PJdiCLC/L3tS6I3+SR/UlEVw+e8yR706MMylrkh/cf/f1wp1bor0tqcf38dPjVGQ1+/c1scnIxZ9gHCN+fy+6sNf7cmnWGb56FXHvHfCm2NSiA2ninrXwQZ7rM9Ur18Cl0wJUzI9FoLpeyd8CdOOqjkIuN835XZIelYvcxTFE2AAlABUSFjuW3tI3YT9Pqss9O/3SodcnP+aueIWd8CNAtKLSgcuFvIAZ3LA6coipzcDPwd8qp1GHir7Xea6BW4+nkXR4FFdQQ+H4TK6XNKFe8qQqgCBPwU3VMCODK7MYdvDi27p/csdhcwJ017tuPO++8fmC5lbnrr8/GH3JntAnjlz37A8/U0lyI8TP8DoUlw/K5V51/RpCweqYxa63FCXzylVpQ8VuroLqZDyXbmtOTizunQXqBl8LODvMLCCsgv0YJwTRlVWIBpwv59SdUUGgsju75kdo1pXHYz5wEE/tSL4ZkoZGv94tBB4jpjvcUOaWwJuYOqEujQgDteCvxgyFsp3BRq+ZLCTYBe7gM9Ch0BPtY41vixo/LyXAVZUmwCZbAGsVMdWg7ePsNGiwEys/zsmXzP5pjBpTu05ltW7b8137ryBPcSqFTN/X/6dyl+jDJh64/OenHr1kaCZu1MEnQyFPm981kd+EeNe8xVbzfCK2TXIkHta2K4uT9NmtWf3mmqrcm+vLY3xwR3LYTKwj4S/wv2PX/NGT+43MTIgMnSzFCXYQEz6XHjxjp81YLXkcv1BHipCCzx+fsOl3dsJ8FQdiouH6UA5uvygn9twafsW8osyx+hOIRNc7bil6fO3burjaCCnw1ez29f1FNUSjXyL2mpGsIVV1QXmwaZX6wUhVeW7XWPwxiy4pmOgUVzhiIJr9CZdyxG9LnUsoFywa+X94U3bKwu9SaWUyUwb+9yQD7ZhPzzL7/rvnPG7sT+h2xu9ZuU/frJz6d2Vv97gnlU+6cHK3vdp74fgiy//t3HjxicqN8xU4xWf71q9cB03ms/DQbMrj1AGNR6Rz3DG0WVFB6HqqY0uDzjqY4ZudEXAGHzcqzD/qFQcqh7C4eo/xzXKIFO0UeYO1FqBwQTlAKVqmLl7VG7u+flXa3Ack2C668cFl6puKppjnUKiQ7l9AZCDq+DyTZoN+SY4w5UnSHOXx8yrqSN8lS5lke/uCmC7bdXVgX/O7MFedH/Di+7/Gy8KttQwxeDUCa5vg0O5GBzTInBYANx7gT9IGSsqb2WK6kNjcEHIRq/qm4vfxTy99emz+3iwwT/Ea5E6LPEXtYj3eUq+cSZ2D8wREMcb/Ox1Qltl/vrMj/ab6/x3Sz6xUR1yvuKWXGGASlG0pkqEp+IWHdWkOz+wk+TfGaetDIejd/rRYq+ZdxZN8g4wuOGfkppPwE5v+KD3YZbixUfOlBML34TBt4HSvAua0IM5X+T4JwTFseOPHI4JvaEdAR+xrfUWL2AHP/bOyw+Ta9UOfmLqa3fclXm9Jw82BNsenXTSrA++gMApf3/98wfugyCz/tVa+1W+rzKfB9ZmjZ9t1w8r2+MqTNV4RpdCyKtEgwNKbWYi9wih3hbs+7/QcJoOrixykRc6R5nSwzIzvkp9UdlP9OAEzM0s07u6zP9yBwaH8Xv7VDfoCbBVP5Ao88/Qk2Psm4c/RGgs7YJvc3efstHkP9rE5KJX0+c9+QG6sugDBC+eNEuJKJfa7GwgBGZQCMwCZQplJgO5QxSTg0ml7ojvsCRV2pKkhFbRZcSHlONfmSMWNByaubHQU8hs6n122mHPXqVKtnBT8zUfXnuDIpf+cP99u5bersgdb52Nc3gvyJQ67gcwfvCk+9LIq/6F0N6KLS8/ec1lldCeOub+/NzYdYpc5Jyy855xtyiyr52sL5+0TZGxmWo8AjIVGijCqfrzmDe7ug6dpOEQrrrddEL5AnTy/bwunLP6e2mTrqlXTSdQ7frWu+AdIbwvfbrme7eWqmD/fmrLNjj0ksbiPgpqt+R4bD6fJt7XhD5rfds2BVS8wzcWfQXC5+DKhD/rjb0whgG483q67Pn3JqnEjPrnvJsOXHuhSvnMTGd85ta9ituy+C0+5NGHNVePneAGQGvXH37dzltvANCv6d/LFoReVXp7/vLrc185mFSBPPmwv/z45yP5lvyg9uMOzmKhvb7+1dv7VPKDWB2Bixf8D0Lzd8kRB1z879vzyLk6pWk1mV5mS1/7DWh7O3tJu97S+a5+i9FQVi3X5QiwuzWaokUe4F35/0/NV0BHkhxpV0JRV7dUA8///CefL6uOzOzFs3fLMH46ZmZzy7CMuplZj8zMbM9q727hecyMx8zMzGhmPV98EZnZVepurcbsnW11VWZkZMQXkVBflhQVnOrplVgCyQuncTQGV3mTsXNYUhiKFoGIvYaNoMj2IsAaAArbi4BxQCuUB8ADdFHeox9wpPI2o73ItqOf6obtU/xE+8wsRbphg6s2zyzhYmJ5cEpiN5HiS1JukHQsOVExiv0ZpJ+Dr2qNM9BCSFqgiOtlSCZfQCQtI2kZyVnWIe14xYuONYa8vu7EiX/EnNlPNqQInIuO0fUyx8wXyTFMXtETeDWbKoYzBcUpjQMLXlHT1BmskV/qwaPxLXOHUGvnESnHfFc97Wz9ZPLIs1JMXKVPvL/dOtsUPGWD4Orufpb+JZBQXVL9nNLYAaC10FiKPldN72BIw41EnG3IgcT90yff6DSoNzvl1UNjeyccnO4MuDcdKDLQX04H7q17H3qilp4R0w5fq5VvbIYEXlRCzJbomePwohK+q6o3BA/wj/x16vQx2bZgQ45Hzj4qoKqSxvZA4IMYZ4Y4gTUxAMQya2c6mlUSf29wQJOclxC8oMQIMLIdhGVVkWCxLs8yxIMaAJeczYLFFATng1nIVt/DVCiwfmT3VaS5s44+RH4m5KdTU5d4e9kGw8hTVJyCleQjmUm+7Y7lq5Qyx4VJ/BAziWZCtCSuGtP5q7OkqgqU48dY0HbuKDryJHi3pTtVv4AtSCfk3qoHzaW+PQYKBYKKmZM5C3q41FKopqRvS5G1CJWljEG0YOAhzCB4FJDdJiJbVclXX0d3ZApeXfrqx3PNU5+InUiX1E+luiSp1inBfW4SRSyPIkC3fh7ECXtVv0SuwFsmB1g//xAGerWqX3qCNT1oqEkDMEzyUVMCTaIT1Cw3ntM4AunyfNzJ5Sv48jED3cymKYqskshOKUs6Et64uFWoQe/ej4T6f6HkZ/REMQO72xMVPenbME5YxanZTcJz+g2VPF6/FBPB2jbwjwvgRfUNEB+U1b7s2WWGISWfchPnfzoe1NHTGR1A2RmJlKKqzbrrLprS0eY6U9o5mLVj3zQRgginZ8X9j28G9uhx393bwTWlSyODdMF3kNcFHX6w8hQNY+VF34vDwPtf5+++2x8JYksQZd736YQ0BH/Y+e1B7Xc7TbugS2m99/qHZskS15SoxGKfuPKlriRsb+S8VEdxOuk0qnT0wJW0W4DTsRWcliZtDp31Nq5JiM4ZKQdyVpS7DIA2GYEYTMAxopy5Cn57wWS69+TrQIpd6td+71EEof5p6ZSufkauXNY78707Pbv2uw3N/25zUyzQKLmQlsaRS7321/3xXzz9ws1WB9mrTv6Uj0+xGVfSklreBcmSXNyll7X2TuZtz6Dh3Fbbs0coZGeX3Mmc4JrxdjvZblccJdmT3t6uouJ9T6eKbUeNfw0ip9qaIkOBfq8rr99uD5xqqag81VZuhcJTERd7wE3cGNuTMe3cWcXHoorfYxWkoKbWp+g/3spQr+U2tS7FlNdBaBtXN7H4thSfisUv5uJQ/uxY/mRffqqdkFnvDqiVZIoMDhk3tnvrVdPuAtmU2u7XwIBGQGa5lMvR9VOK9SbDpIuYzbIxj6HMQ3idcqPrHXmiCIGKRj55Bze3cRSeEPing6E/hysGjucHFP0eV4pHvybXY8IH4WEezVe9L+r4t9OCjZKKv4sVf+YrSvL5xs7Suk8+ZwTma6jcET5Mht7BvI7vU5ef3rz/XZ642eh4BIBDxpu8T/q9WC6pm1MYb2X1PRpTUZfIGVrEVHfM2HS6UU53bywIUsjcX9G10xuncWh/fNNRciffCTE+o0rokJMpo+o3lLKbkQ8uRMqpOJAuJA7FwAwT9vfJ8W2eOaLM+y6g4SBSreVd2UtiLIUS7JM+73ULQt7j1B6y1qan2syRJgkkqABkLJ/b9Mk3eo6r4n2dbFd/kho8E8Gf+G/Rk9EncE5GmAn7mrIvyQ/0UpHQHx519d9kQWi6X8T5mpw/vh7na8LtKByTJYMTNtOp/imbHR5mof5470ALVMueh2X6ra3pHZZZEJr9wzLDJ/7O4oiLfoo+HU7msJzr3YdeKR5n4r/P+tAr6x164bm8TQeHXikfegFzDaS4xJnrrwfkLiWTt+lDBY2Jz5798y6z8LwL+dg/7uId45LTI+7I7D4K46DGczChLM6VFDF7nV6BvtTD0yvSRZow9FhXKl4Mz88ol1nzqUArGeY0Yj/IbOjm7+r21Ot+SODqVUxYH+snTeCsX9JqnBdjDLzq1572i3SMg4FZ34zJhicgE8+1LkCVCWP2pvt9N9OTYN3xg/ztUTzXA0+uHBSfkmJFLepb0IX35DZhd7u9hd1t/RbczBe/RorvSZvJOVbWKWylQ4MTT0YDp8Iu+WvDyX6HQ/wE7xoU+JF0xy6uX4kmzPpqlcumV5EQX0CmNSTVWjzKpN0oqFlDnXU0kK/Aeo4LmtXX2nzDKbzvljs1bYvuym+bGK5ryu4qVzhoICmc9rUZ3Wf0ntpVF3fFlIQ+iJmINsRZ/TLG37CdPCpyWI0fSAnsoqeuXHP5p0bkHFWXqEmdjb7gGaQAK3mWtvSVdeoSQgdJBZWsgMxoDJspL6Qp0Z5PsQX/VAW9u0BzBWmTxCzI/vOob2pQTPmRT54lXi0h+nWl7PEAnyb4CLwedK0R8HQATwM8S1M8gVc/nY8qNECUcxmz4dIpdlpdAtvqN6ATdOdften5ZMmnUGrQSjnNIFFzPW30vE86+qRnPunoU/V8rVK4ohFPhXgmFEg1c60tdjlXIrYjbD5ibMsY29LHlhUUbSVms/+jNX5vz8Iu/qHc2NkQ4gwlmRTbKehmroGXdE9pJ8PV5Xhc1VEum0LJFFAIEFScoUBPWyteUrMR5CtXzPJHSf5YyZ+S86cX4J/HA3UcH/MBtotGR0qB33A+sBbnaxvOTLG83Hpg6ejThlLS2wus2X9gbT+wt4EQz1GScfWb2fcX6pi6lhW2lpxw1jtgnZJ9KnueRc+pKmV/xLtUjKR8pgYdp/HAOzP0LgNoGOgQRwBTDMtM7jfanGMPhZkf804LaBz89TW+zL5tjYCI2qECYiwvvIuZR8lElExAKXWmP6RP73vWfc+ThrPu2wsmcwiA927d12+Fumf9ThIu/zFelcyZ0cXdL6F+GRMsyF7v694jesnA6d1Ucj5LaEgoZkpoGP5T8tjGsKp/zUWXEV27lUD0oqhIkSIz31ULdHudITmdoZaP3uAOY50GOSWGPPt3ogmveka2lw2tEfGLWgW7W90zR0659YKuDHWV7tdUUk8KWoGHO5kJ6T38AdmWUSfy3vbP/+nd4Ifqfm7rvvCNC1/9DzY6N13sHOThHCBZ6N3QuoGQ2QMCLHz5fiGAEegEnQ3c3w9Gdg+MMrKikJif+IU/vVsE5nn/+Vdm77D7FoAGiC6Epm/1PCx7Y5fugV1OVpf7xg5mohexcwDe3uja/aCb7YEuJsTRtHq1UqY33ehw9E6+pZhh3opbvtmQRTn8EsLIzySkMMwk8mICyq7CNq6YyhLc+i2SkiXOEjzgbeNOyHcVFhklc6LT8XR3thr+qlFpsNYFayFKk+MRcFBnm5obdiOinF6Hyq/AW6yHnb5LUrdYJZ3hJcCKmLoEL50CpHMNe0bSpCkVKSaWfRjftCXTWv00zLmkKpFX5Y2zONM2/GjJGkyvx7ikYdOVQRDdkki2EQ1kvjvsRzQWisNsBTPhKGCI6+F6wRKCq76Dqc/WSXRfwEA/9Ws9Ap2LUMKay+C3ZYpvETqt6dtq+7ayJMdZXBWTbTQZNSgQk10qD8RWzPaNwSLbxHn6+B3QW2n+/2As6GSHNCga+6JPK6LM43uFP5dstCZkbdhOKPohrxRjzWUOS0kc27T7sz/kt6TT7p/4gnz7ea6RbCQQ9TnO7IyTXf/RIXClb0/e4Lvw30cA2HnJ+fg6S9/bGclyYhXO0jXdUSjGPADtFACRRbCNbLztgesirQ4gqYTGl3qwpADFBEMEo+sov+pHbvoIOls9PdXpEADr63irAx+vmuI7mza5sNjdJhcUAEd7cBLeB0kiu7zDwwv5v0G0cCqvxhzD+/R2ARIleX7YWYfvr3EWCfcNzgZa/IQ6m5AgEAABAQ8ILJAokG6AR8uRTA4WuksYGPL4wOMjImyOJUzAUvM4mFkKG9vU5bheYhyMct7IvY3TYlwqxhUwrhgaV8wbB8PA/FucrN3rDIyQVNkLGel80PWRAydj14gZAgoTbr+iE5AylkQEra8BWnLpZpd37mPoMeWZC3UPkjzgqSu0i0X48nofzP4SDk1K371sTKsnqKQ37ApOLpQoaojDLKQ/JiQFD2uk9FkEjUL9OTRvyB6INHMBNcV37TRfwTW6Ul4H9gLA8Cz60qIT6w7pq6qbYcbn2xB9q4ZQDT9vojeNCWButFfV+/BrKGwjohn/CQkN+9vMpfSF4ZfJfIEbM06ZpDs6lKqfAq2Ij/bzHr4lzN7e28IqVtRy60FDWbWkcY1azShwxA1HXqBycBraHHBCXllIU6Ker+7dd1p3Clk9N27Q7C7JfaASzUjTnVFwb+J3xxqAWiqpJDyHJS63Z1BvzyHkdjESiQ9AtRtw6Xk4bKqPKqUi4gvwTiLeSR9vO8TbfqZ4DxueCd6ChcA+gIQ0LAclglk9XkfHM+906t1xmbjMjLjLjvaLo6mi8D6YfdnZ2Me9WRdc4KEVB5PtjTAL69i7u3dKetJ80hzH5ZE28XZLQ8s05Xwzp8RbGevLQ58uSLvqL9TnBIMvRQRkH/X/Z09Av/VHvKUpSAo1OIjvAlm5GoSewVvZ6tswC0Ui94/7DZHtqtvkX5AT+u04KvixIPlG9vayqX/lwCX1r/HF931u9cUtYC4KhvY+/3Ns7/M/9/Z+vvD4ctN7mejl6VgU8mDkV5ecCkSmJwepm0l8bsS2qYh7anzhmX/M/Bo3b8MTZHh8FJ6NMv8n5juNhPeCHrT0oAc9aPQgDDcG9KCH6NbWF8Otrc+fWy8wdIib0outsMWpn+DfkbyYhOU9F5T6V/JbE15r1Te29hKI1M/2D5mmu90VnSYiV17gv+DJN14ik68bvM2fU1Nu2BRcma1YYxJlqvhq7Gq8/Dnhc0NT49Bl70XYn0U9JOS3KDCn5uFSuawzl9G7Hr9AM5/IhUrM+Whywk1dTq/1VwtUpg/q/8ZXwU0hb9b9C0A3vEQ85wOe4IlNlLaVK166OnPHFf5d1uvpVevVqn8b/SSUvbmnYC7pdIVM9Hfnlyxl0VOAzS939YGtuNzJ1oPHJ1p1SfX1Sfy1W3xhr7rR6csfAR7gfpd2qv4b2ZburKpRpILiMyWxIxj5TcpjvMnA7vBjpenvXL3OtljJsoz8NrbiZm3Jj51sZzv6tkkqh1uJK92IvsZpEJM5pnAlC7oCZzqQS3CJzzrdWmoWFS6Vk1pLOkkdaq0HynEJFCWytWMlpeBZoBbShWNBfFh0bwODFjPon+5Cx6gwQZX0tUwLTI5alhpkx2Zou52J2uW2j28N3PEA3GIZuKOgbCRdjsWWQkTW2d69wEJjE6w3CFBbDbyugt4I1why+FC9gRSrgiA+61BAxfiQspLKygBb4fhWYPN/n+L/Yb3CcJA/AVDS1SWYfpzxZzXFxODJF5MSJX/ZcDP4QzYyPjh5SpsSQwBGTkkNJ7UmaeiWP9AwcqWAD0aa29F5VsVUUFNWMgDoPsV96qqGnAn2TCw4MjJERwMSMSCJBlRNiUo/mjAmC+nQNCXQ7PUoPVGLpNeFQRfhNRAUaD852G51Wv+tMJM6HEF3mxeT1S4lrc0II55Kr1PrACIkTS/MZT+vIJIuG7QoEQW7kmC9HYkqrkU53+biYyGKcmk4cpXogwa+lX5zEWDUbJSLo00wGs/akOR4va14HBVci3JukblSApDt6rLsd2lJLotdFnNdFqJlrsuxjJoABIQcVayRZOXGlNQT5z2eCHTWu8r1pIW1QY+YVEHOTYAltBRsAIdu1/SrQConc/FLlsRvOJxjcJI94se1MX6Vw86x0X60tTxchJv0ybHuDxhG3Cfd8SjlkVggcfGHFEqUoDf0TmOB0rTCqDNohsrWV1Cx4qHNDRPcsEwRcmgdMlzPYwpFjWG1TWVQbCStKvoaam8r6B9qaw30QVnQm/h0laUXMgxCweh33FeDKFRC+2Ez93eBYrRsub1LUuBpkNvXf49KDEBXwBByT4p42moUXi8wPPdQAca7H8COMJNVnts13LV0Gw9Zqn/M1fh43Cn4Nb21WNXTTsthB79cfwVFDm+St1mnqNjR2fy0zenwgHdG+jFNTrDkmB+pCrp41WUPSjl7aHOXQPQyDjyKzWV41kBEpu3IV7QVqsLNGBrKZuJn3QnKXeVHfUtssKI+J6xX+kCuB1UoXtbHWBLFG+TGHKESaYrJBk83XJuSl+RjCylqz21leZ2EOZlNGzWlm4hhOd5cLL1Rx+dbS5r4ORypusKoa0Am3QFSgN+MCfjiaJNByGB8rPjlH185cnfF5TLeSnyN+fAjRwjkpVNIWvyg9bLJo7tiCKLTJYuxzdsRsB0Rqm1FuLLSqtPIvvRbkWZuVzQrfykdjeD/oDPB2weHza3cCtJ5BbyIDBzJOEMX7dgjoWUKW+0wjfH4FKMmMApzHvQhsjacekxg5cSN+XwDbSeulL8ZRRdc0qbUqqBMltWytWukOyOH6CJ3qSP0sRtpJhXmVI5pg7lWfzPZKU8RkgMYoXS9KpMqSsNf3+EyQLRBhmEwjdg19l8ySuyuYMLEWxWSqWrITul4JMmUc8Pj8w3TkEwpAzpGAqf0pSWBV+RX6j+ykuHoSB8z19rj+ligsLB/1TIPY5gpYGipf0sAaUy5KZc449LelOv/YA9XtlIh0UMjjp5obbXojXUtJaXsJSzuBSo5R0ykq5RE5Z9ooGBstLr7uAF0ZudAU9yfJnz6jHg0jPi16flzmKaalalQNr7/zyGF0kYb0r7zI0jznQt3fl3tjNUu2Z1vbSc7X0nDiX48ceegoxuFG/XEndspV+18e4MVraAVjUrH2rfSofXvqGZMth3bbMVAZFFFkpOiHFX4U838pJRm+c63UwfNiJcilnQ5nrn0mXhUBm/QAZRCefiQh+d9Fh5etaeHJTws9+NhCQ9H346Z/NtleLvRNTdyGmtJB40tHhdttCs+MVYkMUZ4j350kkJX4qo82ZIS5Ty0FZ7Kj3XQ3K6sccZ0J3SXUHd0x9nzMYOx4DSNQnKH1Gyhve66Kc0qhGCNHwdIIX6BZ2yCJDKto3m38swJih/Trm40tUwBq52ieTD8ObrV081Buj6E/EKZCMirZgf5T/blJ9tDcBCYIpUn+40yqbTuEFLeWQ70ZHnaFv2gFguCapG29nOStu6QO/gdE4UZGVF05ttOu0NPdKMtqtKdhZ8H3aH7q832kERqlVCum9XZGF+h/QpgwkoTAcwF+gigjAnr8l04bpwxjod4sNilg2WCwfKZ4orBYj8ng2UO13XGtdyiKsyKu3H9PI6tAxhIGFiM/6oMswNrgj7Cp8IvXpLAATy3QpErr6YUuuAJ9BtuTzjJkYQRIzaq26Jd4wrCClOaFJZ4m6xfwywvOtQTZcfYzKzQvVdUY69jXcEysagK5Vih4JwbXX1jd8GlrT0ttozQPgi1FmZYmEFG9NajFZgRoB7BDNzBKOZBneXFDY2VbyWv5khrI/ux7LzEVr+cq/w4fhVFL2DNaE1Oe5yZsAXWJX4rQFcSJMO4dGrVy2mIWCzd0sA465/fcImPPJRqETAuWS4ntZZ0kroBacYlUCQ9S6n0XbQG1cK2sCQ+LHurFop3AwPoLvSMijSokr6WaYHNUctSg+yc8XYma5cbP741eMcDeItl8FpRxgUD2oxLhDbbCy00ToP1KULUZgO3s6A34mUhhw/Vp5BiVRDEZx0KqBgfUqapTAfcjOPbXbjZ1opibgUDxJ7YtzS1opX0i3Ft6ju2s65dKqjTkQRpEWaat1H4FdauaArDHLrAIOjy83mjwy8rg3TjERYoLP/H9PyGE6RbGh/JZU+pq7DFzLGOUz/YtGdURRaAixdaIWs0CkGkwV5FQlWnuPViKt30qPR/FCr9f1ZNdjzd1Evo9KuETn+k0OkXLaHTzZBOR7O2vJNhdglf1UMexHz66FzDpA99jdMg52aS4KEqN3pIW6xBMsGNwzUTtSwm0kMxaTr20u0IjNRD2hLtpDJxY4dbIdNRUkuHURNqa+lQJPdt3C5FYq1UimBfR72XjmKZMYXw6Cwyb3axt9lHlmF6RDCtl2N6ZA5TaScIEqYFG3pGIHm1pBjWtxNwfzO9lVi0gnpyiARXICaqqBRlFZpAZ9QCI5gAFbQW0efFcvpcR/o8RTPxoWCP5HdSe/w56UESD/lz9MuoYyj7hhjKBUkLf46Ej49fKTMlxTx/LhYEFJOZBakQ6H74YBQW0mPCbEKvy0S6ohYJ+tgXgf5PAwJdX9ZdJQQ6aZ0j0BelStnL9TSM0nRxRiXSvpdW46iGq6Km3OWsSRwteupWub5gFXKdh6GRz4nJqBGIxtJEekU9KrgqaAIpHmeZYqhJ3JRWWRg42eIOa2kfO6ykQxksxawHV0mtgCLpvBoHRe0nvrGISd7Xaz3BsSCBzId27luoc66RjBHqnArnQzKIXLk4cjEyybLISZXXtJg4pxhGFchUTivp6yFcX8wR5yjx+YZBMGTOkdpSsxd1jsSB0C7qHBgJ5s3YoLgSGIHZUH075g4G6rCaLeDOr4rcOWQYhwLwL+HO/3kv7vxfUCmzEVN+TnFR5M5Tz52nKMgG3Lks62i3hDv/k9zk+JuOi/hzs4s/N58z/txcxvFHsb1sStYgLGBApUL4c7kB6EP+HOUSoz3589hHvqwPiWYVLOKA702gG9C03FgW1klMij6DTmoWM+ixOfoW0hOdLmPQS2HQC8RrwKBzr3ErxRQ6Og3jvJin0DG5YCJ6SKTQeygIhT4Pbxkp9MhW55GcFgp94oYBleZAuk+hL4J81IN8pSuWcejaY5HJXFaRpdQjM0l5tCqlPCid4MupPuqz6NDl0ibniY9aQwLGFpQTbSqzBgRGbgKbS4cQyTqSRbZ8JAHnMTlieEgdSr2sQhmqkg1Sj6GTB7Y8H6TPRIAYDTNnAh9mmQNr5jJnMsic1GOnhS7Xu+jyD6+UatPgr/zNkeZQY5ga9dOt6oo50rwQ0lzgmWPNiwjcPG0OmDQq52hzBDDHvWAGVgdfUDekzTF5Cm3+/lxo88NCmdOn4iFQLaPNxwtoswlI5kpo83lqjKjnBMm+s77zbe0KSLKJJ8noRuFGSLIxkWRjMq7Gpm2ymCSjwQ+STKyrHFbmyTKSTFgvlnQF89T7d0cGgBi+oAM4s5AD3Id7F+3pnnCr+3BPjgQqkHqjQOpVxOAhkbUkgsb8zUW02PiUsJISFai86mRTBXqvJSXKeVyxlT6xKYza6hrnSnfC0n0VCfP35Z4wNyDMSU0kzD1Xjh8HXRUJc5FEjtHUuTokzOuN5oDMAnUgzCuM/vp0c4iuD3vCvBIBIcwPBaL3MBwEpkjilf2GmAnzw021MGEtx32FE7bsR7RcEFGLhLWfk4R1h92hwOpiAjUP6dSlp93hJ7pqa3acdMgdBrF7WCJVE8oHmno2ulcx2dZCmEcAC4F+BmAhXHSxC8eNM8bxsBw6LB0pK4tHyj5wxUixn5ORMo8rQA2nEFfNgfp5HFgHMYowqhj8WsbYwTUP/Wpgyw2z5QcnOnLUbRXZ8pFnyys2qnsysVrp0f78P7QpHuiMhC2PVsyx5caz5bBMLKqkXNhyOOeqIVteob0IRbZczLC7lqF4WFgFtrzoseVXRbZcWg3YcijxbPk7cqOJPjNLGHMzYMyh1ZA6sJP4Smk9ZcocCo1L6Usoc+7e6ShatCl8ekhr5IELNw7XzMSymEgPxaRp5qVbC17zIa3u82KZw610y0W19BhVobqWHkV039btUiTmSqUI9nXUe+kolhlTzOwuFthd7G33kWWoHhFU6+WoHplD1fSZsQxq6PuMUPJqSTGsb3OXi7ToTcWiAvXkEAkWEBNVVIqyFE2gU7REuKxLh3ANYIdtoYWJ/QZWDd2ZoLqMqiWaoto71B3xdBORyNjN8sapCxu4UpwUPHgDPupT5MWUR8GQIk95iApFbqShvJdaeIo85SkOK3clFHlJVUKRjyA0cmWjUSjvmu6iyE8qrY7r/2PvXwAlu6o6YbzOs07Vqbp17rv61u3udU53ks6TBkLSCYF0YYOJAcn415GZz5mJJjh8txsmQeRjJJAOCdBA0BajJiGS6rqoUUGDIF7k1SBqVNBWeURlxogBo6AGRA2awH/91tr77FOP2915oMxIJ7fOPnvvsx9rr7322muvvdYrx00KOCtPz/CEKmS3qI1T9TRVsyZkr8tremMbqKW3p3HBPSnYINbNbPjhYBHC8Kw4etKYV77i6X6SVswFkLoIm2gB+Xrjwq+aUvmwGrDyrSmVa8ZaX7Ot3/FqLTv7SyM00ALy2o7XqO1YDNY9YjQ2ux8xIG6nB2KA6Fyfl2YZO9cS0/hr1Viql0nxDD2j4v9+a2AQlh3U0sqI6Ur1YQGjhncMspvwrTEmcksimaveAkizl+/8yfog+/E3mtsCGlJ7e7CJl77G88WBj7PfV7V22JE7i21P7O21XlN4oPR9McXZSdnVTe6rHT6sathW4R1GVGG5XFcmvcKhn5Bn7Z7B8RtYRnjLUVR6pxeo+y74YvC0MaNmYG9NRF1pvAfir1KvgmgG8pytOfIcNPBegYZ8x199to6vNB9gXcnrguuAu3yUqnlbH7bt0696AZrsHd/Bh2sN6lBHLr5AJETVPvcYXuBwcSb7O3utIw9srqPWYn5pO3DfH6e/86x//vm1pw/3veAnln7tN3/jgQ+wWcDvPetbb7mj/d0XlxYC74IrD2ds8J5Xvuf3f/+MX3jacN9ZX3vFbx9621NgbPCWGy9+8oMffCeCV/3jx97zH//bLnz//3vllXPpT/0Ygg4E6mAkcIb+hunrIz/klZu87EcB0iK8TdaKIuSYN0tMdCSPARxA5atAbRkfTbT2CihENfoPznVAKG+DBcpoPY9Vwy5ez6NUS/kgLOUofzDiBiZB4GB4WdEAih6T2zSMqr+OZ+lP8vX/6+6DMOHRvwvxnH5vmd4//BEO9h/AL+f8wrvfjMKaPc50VFIGv4EUjmimVfzyhuvcX/1PVoRdQ/zSQB5dfWT6SPRRG5D7osl5h9REVnlk+kj0URsZAhc0sNO+omHo629u0lfEo6/y1L7+lvQVv+N9lZTB3WVfAX3xCHMbjyw9+p5qX/FNE988wi7fw36yYIg+j1OKbxP2YN8L3/yMyz/V/gy7uPLuWE9v87zg2so0GQ4ZV6/9xO//5wv/+LOM85+//czXf+6z/5knikyGV3z1Hd/9F1t/i2fQJ773Q2xj8wwY1vyZB2Fk83r2bqPGPp3tzIgCYOmlaief84oDA7UM5IxkCiof4eYcocjmvXg4OJK+CW0bJQOF774rgiNF6JLFJmfpGO/w4u9y+/6ZW/r//YcPLR340H9ES58thf80z0HkkR5LaN/H9xz6wF/9853vZw8v73jX+9/ytzlm9tu/4/aDz33lm7jvaDhjLJt4TX+uKT5UIvhQOb57otKf1sCQLp6E98EqU6VHStU48+1FwN61qmZe1f8WoGVezt/7fDGT9pDPW4z+3XcbLzAlXbz9hlCtwekqYmlDGThYIULcHxe+/XuxqIyajzUewg6+55lblvZelfvk3gZFaMNHBwxyGMDgh4vTW4xlbbT3ykprKFhnp4NveeuHvuU//PXiMwb8yg4a6njAM8N3P/sffvDqh3Y8AznvTG7os0cFcWORPPz3nLry7tdf/6QjhNSD/+/7b5dUk3Lq/cWv3JUh5a6fefhIJeX+Iz/9zg9d94992FK/pntrJeXiv/+jf+i+5BNIOfzuv311JeWM//ael7d+4e1Iufeaa/7fSsotH/0vX3npg69ASu3l2/dVUp795YOX/9UXnykp7zu2WEn5/Gtfu/0Z744l5eBf/tlelxLe87zkba/94F4BzMJbKinf8dT3vfyK/7ymKQcvr6REp/3j9h9rh3srPifyRJbkfTZpuM9+PhAHH6YQfissNL+0ae1Imd5ipEzvJVKmQwYp06GJlOkjgJTpo4aU6SONlOnYgZRpWKUpFg8tdgo0U7PVgW5LxWElllc1bEul3z1jJ9iht9r1HXVgcrta8q1wSdne4UPqH/aFbC7Z5T5SXoId5s4HpPKIMwFUL1NXF2zHP6D8dSuoxmdfNLE+x942Lbs3mf22vOauEQvhrg2HzD5Q/TaYwL8NK0hIddfW7Gd0c6LWr83s7+4dirNMtq47TPeKx/aza7d8CbsWT7zowiaDvh/6E/7Nviw6AH04U0AqPzjyJyUyTX898JPr4mv7skHATudQl2qw4HWwS5z3rbG5y83iEcSQjzjecSEjv0iWh1JjWfJG+WYB8h9+8hYxwpPve8d48p6tjifUm0rI4NAXhF98ca1p9N47mH0wU+q5e9cVCvse+rkv/uFzvu8KHu+mHhdqdqXyzXXE1TmOmrcVqeKQHqHHEknNQfbDKAdRkUQ5Y9CaXflopIdIT9Uq8m3Mk+OB+KZmzNs4fC0rz5suKGI/+ZqaVR87M/suuGzH2XOvf/AHyQWv7Emh1BriuIrSYS4e2qDzBbBiO2vlsI0Kf9Uwl/NZ6i1Zaul502119g8BC84z7uSyf9RYd1x8tueVNl09/NSMpxxVRfTEXOl+Yz4h/a9i3BPINhhDNn1fUEzJHlScBS5lPNyHf+cg2mB217cjK6lSQOGhaWp6Nk2f5/lT+lDLXvUqU9yFYg/ybaa47AbEY1NH0kNf+3gjYkc9srl23znabrxv3u57Rtr91k3b7Yq/a7R4vG9e/JdHin/bSRS/MVb8xnGh/rvV4t91EsUfHS0e75sX/7aR4t93EsXfPVo83jcv/u6R4j+yafFn1gxCHn7VSOH6fgzfZV8zhO6NAe/i4fHSkR6xg2+EVEXgaI9naM+3TKE9EGRhkkZrFCpB0YijPiJ+oRJRXysXsyIyXzXXqrbfHWVB/hbnp9BQKfFup+kVhjJ0JMsRJ93Lmgo6a/t2e7+4+I9Pvx8VUKjZNJfk8SqERCVghc+NByFxgAlB3wQwAZLvXuamuWXT5Hve3vXC7KVRMJcyu6bbbY0IKzWFkOuBrB1SqjYyK0cHD++bY8Z9I5jxVmQ90awcLR7vmxd/8KMjs3LT4l/my0m8zsuxCvT9aG2kBiypYvz5dlMDTTnvZu48RTMITzLP3WYKo9SR+TpaLd4379fGSL/edxJgu3u0eLxvXvzHR4r/yEkUf2y0eLxvXvwDI8V/9CSKv2e0eLxvXvxNH6sW//GTKP7e0eLxvnnxd44U/+mTKP7+0eLxvnnxHxkp/r6TKP6B0eLxvnnx944U/4VNiw9Y0PyfR9iQsGLD95dg6it7nYqsjXlyNu0MA70gQbKAq8qRl12vvigorPp2D4ybL3VOlp7hjM4ksyKyloy5RBvz7q9S6ffLNuGN3vqjr6rwRoev19hbRmJ/1MTeODXvg4ersW9C7KPnrr6euTdjDzdGunXzeAcu9PzRSnytxM++Ai5LEzRV75B4J6zx3pEaf+Lka/yN609QY1brf4ELxw7sFuRNz+QmyAe5r0has6fPfvZTN6FlN3n24z/wHPO52x3U1GRTsst/AAXrZpH49ct4VXVUdTuHlRd5cJLlPPEJkccZu1rYAiu/2yI0fJEl2RuvV5z1GRjksYf+bEPRnU/b+r/6Op4ykpTddr3G7lzTpF+D3f3szRKr8dmn5EM06If1AGm3JmFCvUvaA5wwBrBP93kxglhfH2KlKz3HeiR8h+73yuy+ye5rdl+z3+aP8OvxTg3WxJOiToyH8BCgKdhFoTSmmpan04fi7Ke0H9jnqJIcHMWlOufIQ5NEudDP3oKMLW/TJIqf4U8WHGMzW8M3EnmHIEe/hoP+w4jTJpt5fzsextIWGqu6Jg+nXAByoIABCrCKOBGaG4myRezQ+EbPC6aZBzf3qoD/4ujFnAF29URwgR8Ybqa7imkUAsUCO15godS2uRrVPqJYwTey8qA0nOZMbKfvxgihHOf9pgihtWAckEtrKGQjxhz3nLbtNgwCU6TW2JADWhuIWSuMQmsorGFglSWtwoe2zvr3VO1P41BExadwbBHYCgKtQLfayMLh7A9uMFao5QRK/Ya4xlsjIGRu6Ik8GOocD/Kzfmkv+xdLlbiFpf5ttambtTGQBmQHUf3jP3qu7uroDU8weq95nFuheCztyKrtWD9BO34OPpKm+MSX2kEl7MU4uSgWQjARueGTwYgxFHLHkBEAQwi1If4rhzCwQ0ihnsm/5ZBsavS2ZWzQPxIQgiZFqNVVHXOx+wVNDXrFFr1QK1fv44uWXm2UQuvSSbWyY809UMwwRSVSg8IBD6Rld6BBK4KGat/Eq3oFuB2p/0aguvOGKqgU1/5NQfVzN2wKKjfHfuHkQRWOgMrbBFTBOKhkTR4F1R03VUFlJoQCK/s3AtbgpuMB6whS4cxMmVWSFVpWPE9XPBitvyC4C4npDUlDjvt5X+q9gn/lz4D4Lia9DWspvdyWi+9OfIsLgMMjemnQ5w24Rw04ohjgybTlFg81H8hVazYBLBpYVPkBC+y4IZf9DJoj7qzS0nNZ2m8dKGryit2DuhjDYotV1q26ha+m3vGXQAPSLODQDOIabvHg0SqmevazqAOtFO0jXFjpQrKcADuSaeUCeew1npaMKB5hYZYxrA01mTPv3uOrgS+UqrdyzOLQsP7vHvoaZOKASEtMjukuAGS00T/orWmbtbmgutLgO5GFM0zZ6bcfTsOruTA8rzDPy81TzyPSqq1P71vkMaM6SfVKAovV8w53JjM5uE9aym7zJPPMzLOmGWH5whfDQXVI5os5SmkO9tLm+eZZ/2pWWpA7AFxbLCLteA3HEGcwEBekANLHf+0VCwBew2WghTdJDHBDYxf0wxmaoYX/0kOiXGyOrQDbR9bc55ZkMJiSqPmyM/y9+Qwe3FhRG6CWjBt1KMXfpTD70N97zZq0MKZ408YtkKk6n0HNQJpZbmU+a3CHWtZo0cweH/Cb5a/QcwXVAhe/ID3kGt6UL4y1vgP48Rhk/YO0lmfk0cJ7IVuby+s0j3L1+t1BnlEGKjmjGhrtYOTLDVhfevBfoCqrjfa1xdXaIszMjB8A6XvlDiFPb7taf6/vMw2QgxxwTcKxq4Mb3Vs7FqkI9MzFW8tVEdJeB6nwSXpJBrUqH8fP9DfixJeLKMG1kTw9q6V2dNluAzC+h+C6XZgfdzjmZe8QpzV1Vq/IEyWUDeRJoBuNB9joXeKQUG7UZHchPyybXSKAWIU/DH5jnWbiCzTP483eQ9IjMN/Uoc6BIsseRkw+C/VzdHsWtXAONo2fe3rWBMgxws8NxcJU+TZA180+xMPDowz8fWaQo3EAl+HgPQYFl+ZiqINbPR7a9eyitv8AQ9VQ6ZroNXvU4ScjyAwewKssEB0y27pinrj18wSIWZd9HamdakCoGTRiRhoBXKCG6SJXyXyaFNH3dMmq6eZfbuhlX0Uu2//Ziikwecye7of5AuI5cL4fAm/xiMFHvm+Zq3rfsso6nMfJFJ6i56jJwBpSYiTCp+/lM8w5sZDHjQ1Q3bzWCgXRGYryDoN9nmYU3biNc+pcEWOsqjiAvN1+IDZPRPOyIwPmYcDwUcjgkE+S4buFxDCEACYRRrGGqlLsDiY4gM01MPnQSMG4OeJ5j+UXUNSeUQysArssKJR9TbGJARty5CoSXc56/yM1+DwAjlZj97jIN5WR5CLfqZE8Qez2fy491khZgiN3ukJ+YkoFWLOvdSx/XTPLxCgS7nRFtYu7I1FHKmMA5DTuGPBDRXN/P9Nbpx5sxVFgbsPhSwSS4XCIEwKzkOl8bBrx7803lDJCUJH3ybvQlY9I8LYpp8lGUoz0FCeuYBlUHDtW2kddaR+X4Js3K00/TftSP7EDLgPL2rdSyj/X5K19b/ybXxn8028efjqUp8oXvrHYFgZEVsQ62JWkL9XCUCC4wbejJDAGQDrMZJRKM8qlGDgWHQNJgLFDTTAUeQYOQ4rKZ91CPOeCiQvO64K9gE+kC/liJXHqJ3NoLzdQBm0Bt10LDF7bDt4SLZWDt6iDV2kQ4G2qKhYRPCrB5WcVXVCbvEmLMh2bUhh1QPww+6xKNWYP93oZ06b0QhpxO7oH1vItJe1CYVsoM1dB352vUEwZpQdgxqhaBxcvddDKzZixXEs4UQtlmKpcVjlVs2Kp4gUe6N9jT/erBLxd5ZFNZD5zBFNtiZijeerR0nDAlGcBpS1Up4HsITJd4mfzDjd/FpA5JpDpPqtYFMh0ODYBrLvPwjuo0BKipSMdWlLo964slnt5B7URBzjWfGQA5oPSZRy3YXowuGhIHXzJrSvm+av5I/xAT+av7K1jKrpjMoQC1sZ5OmdNKHg+ruSWGP29bdDAAG7IMTCLItoI0VBlX9VKlXZi1rSH+BPV9F9Sjf6EhxoqK+3KoWJACbfDAdwFr+wNi8TNLxe8imdXSwbLCQp+pR5j/4G/ilu0g4EjZPX+l/01c+km+1WZyAEPrrwPc+6w2BLlxXQDVMjZhFT/NkX6LL1eK6avOL5tjy+JU3xpTsBLs7quqYO2DDyd+bfwE10/jGeDNVfw9FihhZ8TvDk2hXcigzSXdVokDB6fwnKAsr+/QXoEdl+YgjpvOrzCx/N2D01V8WGknZMBUs6zbLPD9ryJB0Q5dVn7tJFcutlj+Kl2A83t3+/zJWJtj266xPBm3tI2PCgt+LLuqGT9beMqFXGekFoid2gpg+ADhNCNalALhsqzL0uPUFjR0uv6zP1paUWDs6toweqjtDHL2qbKBgrW+VUHA3nMnwbXYoYhew+4fE+hKsuYGZWWjkaloRgmBTAvBBtwUC3jcC/G5IAEj+FqCbspfgHVscm+gh9chX+1JiLfVTrul1Md1hou0QcDSlHNhzO0OvFjDz+AOxfWnqeglSL2oGYv+wcBTChQv7fGajQ69GdyX5QS3evnIZqOLujnOnCOpkOxWZqiqNhEp/V5yKDkjfpUIHiKexbrIEPI/gm1TkUXuX+vszwpLx8NMd8NDo+3C+FAp+3mqkNYQtxJzdecWs1xP8MSO3lS5j77a98Lp7n51MluNyZWVA1prwqmzXFPqDLgy0xcxFleYpyU9GvqxFwVnyFSVmdeqIBloL56g/xBbHuQwUiJAo58yEiJImEkswdFoBZCwhNsXkuotaBNatBYfyCxKrz9eWQ3XRHyWWE6isRW6nQ/Od/kB/sq5vRQovrhw3mqPkJ5IC37yg3GRScaZB1qe1hu9WipKjb6S5Wxvd8PQiHIDn7aQncGYKypSUwRoWjyYJANLTfXTwM13aIXThM13BKL1RDMdykaY0ShQAosPmeJzdeyQtUrhwRqZ0V3lLER+5PuRCdOAbxNTgES4AWq479SLppMOQUoEt3ihq5BE10J0aDQNciJKL/NYTiVrj0pgICsyw/swtWxZmJkPwGw55eu151ZUC6M5KU/4odGNGfZ+8FyifyOSgQ6IqT27Xbinm01FcAEIxHLpZmY2Z5AjqFgYE8XE7+/sYQFNtB9c65yT0B4cg8uHhUvR4nPy34ZMSKyjHSLc/syf3m73f5J/J5q9JvKaKpG60ZHvWoCiVG7LYK7bAESpPd57D9XnQKDk913yS+977YvfeqHnr7vYx/Fvwcuzl59g9WawZZdhHDZ+cEekpjdVCuPQUjCoBfYbymiWISGIzTBTEF7RtoDOMbiYb4Ekw5uZtVj/YE15H22OgbMijpYCJHc4nzvB9asSUg1SFMek1zuOkDhRoVh7bEu6vOoln4kDLC/q54sR/b816x9NeFT8xgPyuuI3ZMnIr9Bb6YyJ10Qese/gdDLlhNs7obIhvpdYbPcfYCwZ/gtbgSSIjgXxsY7+7RBlEi+Ekl1SbgBnex/IWQ8LRYCyt2FMZRIKnnTK+DEF0V8q/xFYHysaliXYik8exXGVCgBClKUjTCDVjmdHwsUYXPYkkewS9qEo6wuQqf7XUicEbcLyFWGyKlZO9VvE9i5d98X/sPGtld//g8upii7QQmLCO3VaWVWNLQrXTXlk/vW4OPhoAhF6M8bMOhmY8GFPblQ9XtxMgwN3C7YIixweB4Zljpy6wOIM830RE+xAZeL5nH/loBx0AgmXB8VRDcKiKKKokD6eh9XQS3hOFYboUXkgV0eFlz2LgzoA4ti6EXcvAbTsUeTd1MAIF9CAbyXcwP2SehuzP69EgQ27EHo4Zq/hz9MEBaIn1uBOIWMZ4Dwf9j4R75PNAl3JYt/+gbD7VPu49HN9YZyjsOXY86LKxd24U27P/PD//MHnw5txzP/37eefmbvCg57G3xB6BGqvQw8SENfOanX4SvFxhfZryjtU12Y7N3mVCUQWZnEUQBBGQiF0HruMUtDNAEQlNzwfB3cracPAFjQZYAdw7va3z2LqzzLatg4NZD0w42mXRhmdd90bXWs6xWPyqgrqwp2AxOp+F8VDDFOyWmOzloqYpVlqIsxRzhk9XtXxPsXfh7lZ5OfH+Vnys8762tiFuOBcA3+2toc/AJvdWZw3M7PDj9v9tfyjJ8Dfs7y8xA/5/h5zIN9rnyeg/dwaQsyC7DaLqJcjlnSTIha5uDhSKroIn/IQgasc6I961HsdooI4haUdnHlgmCjjhXsaD3voYzA7RJQIj5mek0rmpZtyJq3mr0HT+0WrWa/hrfK9x+R77coqLdMnT5AeLYZe8yjENXfHhVbWYbl0bKrHumZJt8Z0VZQx416seLukfZA6hbdB6hdQSKg4kb7PIJQdEAZ98DSBi/b79WmlweXaIJ+C4yYJ8mOufY+ZFyRxI36GupCsCNCzjnNBlHn+zVbTWvOPqDFQ0D60ToQoe5WgWxKXGdK3MxEnJpMcPYYxKTiCvcwVrNdw2GxbQjBe6ZgylfQ5XuDnMEGIpxvR/z9YU6Y9Nyh67Bt3TDXpHMtn2ib+sgYDinfd8Pdv/3C3f/tvosrNzWJaDttxd9lvY3yxpzN8O17B8RNquRHCwdOfjPkCLlmyvn4niKaSwavPmhh3T6PW2sijxpw9CpxbzJxrUrch0zcgosrQZlOiWtW4j5s4hpT4pamfNudErc62T6deRwf6TTSvJCNY82qy5oFhKm79enpVZpsz5lUQXCapt7o2VSaXiz7EN0u/pnMUvdVWNRUkOKZEyFmdvRoBunSmPR/e6KKPaGJRnIf/1Cpy7qgNbbE2DP5xmkyfsSSCwUHCnu0/hP4aqp+dv3hFDwo4bnLPLuqYcY9wupJAVBbRTM6u4QXxCLwndCmFYf/G7IjVEgMfCXjt/Az+8lDBtoOvP8S+eno8l9RlmDmvSQr36ubYjDwVDM9NwbBfdnmCShVg7EGU48RBYjHCch21p74AeYgLzHQjsUnNkXKUns4xLhFNWCiTb78dsEMVfKn0AgfoVQU44F13lOmDrwWCAGAriWLIF61EPdort3k2WP3Bz94Hb5CRtmw+XurChoQc+kNMvl8p3zur4KFExFW0TTmt9XTOEhQ2eIi1d5KN1va6YQfimDaX3GhjFNHcHrZp8GcqZnMWBpAXHwwWS5goedgcarldnWCfKe6uY/5L0LNiOs62QGD5KUUHUC7lW4DgFRf42rEnKke0NQFAHkgo5+3gcHgpjxpoziUlyajTwgtYHkQ+FEoDtlaFFAd0Nd+3op+5i3UdQlOouswbkVtJqV1PZhDj2VLH4kWjvRDZX22okRL+oqMYwO5GtVBQl32gwTMPr7KjgKY6p9ah1dJEGdy/GA6DLzGhLioOrUDyBJXwZdToLM8kFne18s9NUV3TrQ+0NX9bNxXWUCAhNUCco+6ii7UqZrwlDAlv6qe8tBTHl/vB5iM5U0ttMWxgd1CBFZYLWRJjpUFP1gwjR5lIFgNe6YiQejTXocrIT41nTUYmPrJjqBrUjasknmKShHKafXFE9QalsLaJb01qjsz8tWOWpBLIVpCK+dXVfAdovyxToDQmu2NEsW+fykENqbtSmwpUOfgFRs3QfrpmA1tNK9TUnfMq5xpVbcJOJv78U+een96ziyfzRWsfHu3TDVINyvXJOFmqpa9T3CyqYTxcnJXiTb4MCWm5mBQsHHNezzdqQyLeNRGB5hubC+4iiFJiUApU2ooPAN/jC3c0BSUciNevvCL3/rnP3Qz88VNIxnT5awpty031nNB/X06VfbkbTzOymfwoLyj0r0Mj4V8tj96HsjWhOaDvS4ixBEUzUGsuLBWLIrvNFWTug7jPY8RFSuDGS0wAz3yoQxQB4f1/Nma0gowVQAEzZB7GdxB7cortUbSBuRvrA/4Jbqq7dGiihlhnhX7M4w7RHz8U1LyEPZl5hkSOU6vwgEP7xzwbo48o2JlaBwURsYk36MgvNlTGB7yFIjXKhCvViA+T4F41TgQm487EOPHA4zDRwrH76zAsQk4NkfhqA5lgeOCmL/YDFu8K4wdC3C0Vu4KHUsDmfF0cRGWkaohkDJ87t71Nz8UFELV4w25Ph1CRrEHcwfrP5hBSP12c/k+h89aU2F69r+xmS/qqBKx4lTPqKQghtZkMmiMbC4XNKYfrJnIprABeSrMWN6yjm3Vvah443GeqjGMjDo4AZ8BXRvRfuOBnAErN3T3EGewWs2M3nN01wpUDI99rDJtLf4+PkBhqREwlg5zxv7aaBZzLK45O641Wb+mWOt8aFCH87VEJQYTYU5FiBuqGdNP8rrq1wnZVsttHvk8RgIIxbThIHu/UC5PvZzOrJEnd92xya7b7sYyjKo+2wEiSa3UoTnwE0C2TltUETpwIYa2wEURT8AON0YKhuFOPBY505JadqsAmha4kiWuryPtBarXqX21NRU9Iw3NPducOqVoXHlQQHzyjby2xL1OZLHU4+Ejf12tvfnAiiV0Zok6mDQAlAxaFzGcXizYPi0KxOASSXgtC/H+K9TuObSuINirW92OupzczDAcyC+HYphD1ellaLRfkY10VeDgKaOgNq3BwCzTvHRVMS3DGWibIyrfVgXBQ5O78FTBSZoyI9CirisJBCHBGKXcio5Zz0dv5C67YBddvKwtQ+hBNLMEbcYDwh/XK9kExfy8WoicffplC20K968n/R1SbEWZlG6sS7NpWc2KqUIVK/H0BgyyLnkDAElZQzNudWkCJqqSu0XKaPmIljKLtFkupzvIRQ7xrHwGgwCZ0YyaEZcdbqIT7bDb3y6AgpQxYCEJVKaMYYrotku/mUYtkaQF/PcNQzH/7LFSzG9SzIUqxdTslmAujBPMwtt39resfv4z561cLLZivLJvRz84HFa6uYgqvOxv9cYb+TDklS8a/S9hqFGDPzzpAj1XoGhqSYEcZSn3IvlC34c8K/j360LHlwELnf9bJun4MleypULHu4+Ujm/ZhI5vmaTjW9CZLRN0fIvS8WXbp+7jQ8cXp9HxhU3o+OLjRscXHhEdX3TBhXE6voVmaXmCji9M0vHFR0XHFyfp+CItgI4vnICOdymjxXE6vvB1peNvfDyvv0Gvg8Ne9uk32MtukMTlXnkL7n+VCbkn2+SxW3C/7XvhNH0XghB/zeq7qAhE90Fv8/TyshiWvsuTOw7ZQArTDINqhreOZFCzJL41TNK/2YM0QQ8kA2hE6dWi0H3BX8NieP9yDJg0677aWLMk9p7x2P7u0aoWqjV1N63I1rIwrZJkItLJC76RrsUv1vqQBMixHaQFCKynz+QysMaYa19yZZ1f9Qm9UQnohfTUXVUizyhq/aYkvNALJgVXFR0nkRn1X1KeJ4dqA6Fy9g44h/3vMQMasJe+IsCLQ0+nVvX6RhJd58su0ZM/t1tcKvUvtUPyEFnXM8V7EzwtJEJQ8RbZN1Wg3FjSdVbUaFUpBXqLztxVyxGltix97EMAFJgCo0CYgwzuwkFhXW6+zPLzo/ycm16GWdg98ZTO1bc9pUZQcateJSGjxpLPS3y+YFuZaCudTM74hCpA6vjUjbVmFlJ1FpMYiZzWlCe2yxB8krJYKk+AUk2S/ZaMK3R5sUc6GmBO3CE4PU+L4EFmsrulSQ0t6H1LrmBqoOCpJSLT+ySTfmSzvK9aaZ3mkKbRVomPZitxbzJxmYtTdZxSiRtg1BZlv62HOhKV/Y6QgZaoedU1V7I2UVsCdOQft5qJ7nzl+gFWEaD2EvxJzgvw58WdPR6hGRFKaEHGY2h1sNwwzDPyQ0Na31rUUo1rDJvRd+e9mkFi7FErSyQXjCx5VztIvuw2iy3q6EvLWRwWK9nv2hNf4jTjHq5Hi/xfl4s311CWAK4Vcftlvx6yBnrR3ff98u9zFw8fCvrRWvZRlAaJcRdfdCtsx0pf77DMy9WxHnWVA0wMf7qI4iHc14ihafaitm+IFVn10yApAlBQh4qHItdyCxhqraPldttsqESblgfwXAFUbxp1YwM9mZ0y4KHq7rTXJ3X0psyM6VMCM3vJ0vdW+mzPm0758KUPYyqB0rqqXqlOpyNCzKqE7c2eWPF4xj996pP/dMMXf+7Wo0YLQkxTuC2PCWzZS6UZf6CWM9GXffyG8u4ortwF2X2vl/Msx/E9ePH6QwGYyRR013spa80GVENrQdrLTBSYK2e19HfrcYf3mqC8/st9e9f2Xq/stTnk3GSbmWA9OhhA7w47pytItORwfbT/cmkC+FrywakYTe8o+yvlU3BklQFOOj1hBS3CPeiYQrjFlGL6BB7Ow+fQrYfz6AYgza9NPVkK1eZinur9Yw61tEl8YhpiT1HTNuQzrsQOctwYQEi7wcQ8lusq2Kbp5iSWuYjc6sbq01zbYt/Ll2hBr9v+agnIoYM7zQ6KZVq+vVjmSUbdgbMQ/+6H52UTwy2RpTLBzloa7VGTW/xwLazJZEPhW2jl4c+JM1yJf/g+L18RNbUCo6K3J/kbzpWGotB9Te71w1zOPchD8iItMw68gvETswnp5INnUqEY1blPc3lN80on8TH21DpMuNQW6F1XueUa4LaehBig9lahs9uYgeF8Hs0cwPN71gSEgSmvo8q9Dzd83cVp/wLpml/jbuYrdk6tCCJUO53aGNPVGmhAzVYbUFv2GIE1I5lItM+fZ/J7hRTfz1DpaOnaTX1BI6S20eL1ymzPjJmnr6uAkGnMKvm4GHkNd+/Fcp92lXqIYkSrxvbQumsUHn0/Z2Cq650FgKngYt4LlBlST59AIHuTkOZVTKcveh9IFxkjateXFL0pb87e9HXZcPyl23B0q/uN+0+w3/ixemYv0ySGofPNu/dyDk0lN8o67fsOUce7p5xgyd6BSkoCLFsxk5aK7es80jaZ6R2rjkJeVzqJMzwhCPDsCIcbhiBUvgBYQBDaFG7guvZG3sEtMbc4V+/IlbRh3tCGBQrIZjgGk+Ez60WkWqT5IkXGGH8ECqJH9VWq0Rng4P12Nn4IFBijGl3FQFEnqyvVWAEFTGhFqUbPzKou9UA1GpUJ1BujGvP8DfUEe7cAKRuGamyhBpIXKBqlGjVDNRaEasTc20UcfY1SjUZJNRprxYpSjVXQihVQjdUK1VCPpXb6tpVqpFWqsaLl4SZPSTW6Zf9WKlSjZ6/y9sapRs9Rjd4UqrFCTaEaK+aEfzrV6Bmq0TsR1ehNoxqrZswa+roVEDKN2TpONbbS6hSqsYrWXaPwEKqxgkbOViR0szRHW98rOpK0qk+2qT9nLiFSqGSC8TCPRggERemvbyoEYOqgF11v/7GKab2b8cK6VHjovVfEqNE9zYnrsZKsu+VfuMEq7WBs0RRVU2oVoDhOKeaBi6H9id4T9JXehs8kX65GvZDI5U2mky27lb29jFSjTL5+jgx5WHKGjqUtQwPDYI2kupvzpTkoiAwDVfuoGvLbpva5zL4apE/3v9nvCTP5t0nT+LksCV54XVBemzi/cpsQsonbz+dnxCZKzq/ubsPJ3S3Hj+xvdQ8cWpFiiDjhA+r9w8vQBT1EHFU5ftbLXxVd26rNb92LpiA1UDWA8WeTzCZj+372+0jXoilcwwbzcrlzW8HLplGM7x8koKDSctk46fUFTDfXnJbeK25XYgLdAVNbrgyzaHJE0t4E785p3QNFZnSiQtWJGr1l0sRWSobeNcleL+lQc5jPuh3YnN7GFOavmOdFVn1Mz+DRYTm5XHErF6EhddblDl6p2sVYvNsArI57CXUo0GXHVAU7j/j99vN5CQJBCNx1UMqgQtc6wA2T5lOIzizqjY1FOe9YrPTHBTviMlZcEVYiqQ41qiUZk3zZFlEwwR4FSqfogt1oyi3jjm6bmojpcswRBdbLRk3C9T10AiVfchstiqI+bh/KvT/iRwdK+/wgDBbfD9ZX1CDpVTglckxg9vBYmRVMFm60JunZHyBSj0LmBA1C1L6bQssMyfsevCf8nii1BNLfIpCWwycQwJjm8TG+k9YZ3F0w7zXr++Tg3mHR5DMx9cgXychTZFzydo4AlTaOqMpszTJfuj+VscwTPMK8Ac5udpC37L3SBiX7+90X2julqV5LulyxRfc8Er2nEvumMpYqse/UWCYdhgY5uX7ryK3p24MANqGnnhV6DNwiAnnKPq9yTLaXtJTHeB7CWbjczlsFkcGliBAU/ix3JIiTPpBtDsnllaQ8H8zKEAn5i4EluNFV6iaXLJFMQXtzBa4YcQ0nwWN30RghCb4LwjNR5c0FVdSbyPWWJmifCMICagJZ1LemqmeKeCGQHx3M7O+EY42BEoTkpKjD5Q35iOkSXhhQpjgd4QRXXZx8pwIRd9UFRUKj31mXLurreqXJJ4RGDgbSt/vsrabq+BgeXSh4P7yxgJEesdaUjL6rGxfrtC9Ufdmg9CCDgqDDVv3sQfOZSdCHFhPe6r6cVtLUlrgiT9xWvRkZKjM8LBw5gib696qHPsnwZs0QjCjbIUMtfQOUo2O7embu6hBurZUOEIcKzBivOqyJaNByQkh1PqpsUIOhBaMFeMjlJ2hMZrejZrnDnyeCLZjInE/b1hBLQk6Wk9XstZvsj2St//sgdut8aFv5wFlfh6uRzrZ7sI77MMA6zuXplcmpNyTzyN2enFjq69IMaZJcu4NEblBeYxzmDSyNevkX6olTJExlnN6+BINBE5Ep2W8vZQc/aHWD4iFWIZ5d64OBuS/5hYuR6O17svz7PMsfvZbsb63Jmi/gAtIXzrKUE/F7qtFvKqOpGq20U2+FTlzo1DuhGjl+I1Qj7fc8pO4u7O2ex0OuootAj/DzyBmJNRex+hlF2SfU3lvNRO2RzBqr29Zq5k9Oy6yx4OTDqmGrMVZVdfTkNsG1Yj9LmqN3pc0V6Qql1borbzrQSiblVjj5MhmG2aeMNBfJ99ZKzfiqxivapt5B19MDEw4KAtuOEA/l1YDrWlkOdA+lQkX/+jC7R5c7LCkQaGMeoGrHxAWoLFvncfBRV6mCnuFHDC8YG4wvAlRGfYipa9H1EVpUudbEfEAN5V/a46ePI37/gNrnlcOxmj2pP0Jchle5tFYxOJL9PdaZ9Cdc61qFr+3zH7/GPep2vdHzIYkpRQ0woVcioae4SbUrR4gTH7GGaoV2UBl31O2Xn/rlp0UkZAmW2JSKXaf30ye+h2fKP4sCaDqVpjSPLZW0s7SHmAelRcQ8BGbjVexJInAnAiPENHLBWHw/ByPJsaW1jGPAMqaisaW1ytn1X5AnaqfaGGKeJK0NzBkwef0H/sW4WMv+tGIyI8EF2kjPh5pcWpPLdb1IXN9gGamh1Kl6eiqxe1zkm8pIksiImpSAcJN3YAP3WAbDvK5ZhWapn0LtkOt6naOlYyAbqVzpdIeXql+CIky3Q3d30QFDRYHW7qa5fd0ohYgfXeLAR+2hm1pvgZ6PDpqUoJYuH5Jg01rESaxFHHuk1jQWcfp+PoOutGlG/Xm2JgCVjkFJxxKjHsCCRsNwZl9xG15q99y1cBBt4ePBPupRa2QWY9kCokF6BIrT8fXsf+NDOPpqArMxsKkw/WpQCFA9Vh4m1dkWs15+nrgCohfZ+zXlzM0BPOC6BJoN/lw8XwZTeWp2iaXyV1ENUsuDQfVWg6Ms/2nvcJC+Kghwx6ycZjR2LzchMSc+/c5YxHfEMlU4JOgVcHDnGqRDi+o2C+lHF03gmA3cawMPcKB/vf9Ub2PRyQTqRiagl9cXINeUJa1pPTKrwc5W9chcODjEYnvYbz+3HWASZPfqrR1qZX+uFEj5LFMDPsCzBRM9uBBDumGrp05lCA6aOTlx93zCPk0zdB/LwtVvqZV70Qbq//EbeP4j3lq5jyU++4x5ia09+5/zQ1Vv8OCrDLKvXYDi3U1A0UFIVgxdJAJ3paVG8NOySAGUXCKdLNg84FJP/AMU88kZb4Sfec2FnAmaYmAQ+VZ9orw1pMbKhmMzg4tGl8AhaQoCdhtxiLk9VPCeRRiOkL0A1+wpvWjcum/pP/7lW34p+MOLrgTYGKsv5JwYXWzTGYByZ0QNLBXJEIUOK6x8L/sLxXC1uxQC3GG1lw7stew+4av/zvOia+X+y2Lu43l0Ua6LMXaB28neBPDnkWEX/8VpuqlQz62ZZcJ4oFb295qegtblJe8IOGy4/vQBcMxB0a0s/H233Yp/v31xqTN5wd7BkKJyZg4prqqhDu9QZfhwWIjRHikKTnoH1e+H6X9hQ/d61mqvl9qJ4isaAxVkRwnrPAyvqql4351NO1M9YA3Uss6/ljX/waHj22H/17FK/7M3HL8VW/Ty3SfwwpA8/PvGmZGXfsmP6tcFxvybWt+HZ4HaJW01tcIz7Jh3gMu6v3YAZwE8fWXJ9cSgEB5YBsVdoyFjKCNlg6q/6hAi+9JBc1tRqM6GvkPLgablm6GY44vOZEoGvVJtXOs2QnnAZF4lh5SxKssM9JKprnrJ5EtGsUg6JxodHZrN/vEN0hJA24TbNC+njlh2XIHU4jvupg7/mt5QDyj7g+v0IpV0xNyum+sffSXUKGcRN1tqJ/Xv4lheP3GvqQF6+xKKno2k9I+ipm+MRkT8F3M4vDbUqYClZMpyJIvN6IQvvCO5r1Q/wOhgcHbzvqg/ygtCov+svD7VZmVjRFaqMi07RY+yWZCq8mrLGKVrlUobNucedig2o4QWBlyV+IL5MRq3rowZF8xcsOOCs8DolDosr+bHzLB6k4xVamCUIuflIF+afsPCBbe44Iow8UtFb3++Sov5VlrIt02tPHMa19J82gZWZ4lWMfW2AkO2bQyhDT3LyEZboW6DWOjTznKTaQYC5qV8Gy2JToLgyqKcY3O7e0CDJUa1OZx658u0hUNdDnX5OT/EoWiHMWuF37bwqfhMjvQVRutBvkI9FLh8a2lmCeDp2tcaO0TNMOlnYbmTZpnWNi9QjiSD9WPKOKbBFzcRM0Od7I2YSq6sYkbMWs5wruQCsDStEs+cZFet9FLsksqbxX1F+C9FYVNQ2hnLWipv9W+6f1H22h0nUZR9znHyoO944GSo/swiAQk0iuRIxnto39VmGPCNIpfHWZVv6O7D8t8UlxuCWDYEsPvI79YgfLkLANprZk2JmVqP7QRAsPAxbGotceD2pVK/R/YBneo+oO72AYndB9TtPoBDiZhSd/sASC1lJ9C51LDsERgdaPS0PTi3nTkxpw/SxnF5Hd/jW9NZmgHnr71dJz/7S3xDajYJkUmRufvk2jbGfSRz/KyN162CvRDRwaTpVPcHXopFAcXlWaU+B8T7BYhzeuYCrJ0bjhacjBUcYz+UoAvOnnMqMU6m1cB+qGFk2scZgAr4/RL88pHFOwO/uvIYMeO1XVZ/MoyA874wuFaxY6lqOfXjS3Bz9FdoEXpCETaLegZ6N56JGCw6tkQ+NDUaIuDLm3oGAo1+aFtY0ouDNi6uDVUBHMLMWOFbAz8zfQ4o0uui0FGRa8Z9nIYhfe9ZvXxWSu1CWtoB6GdR+rea3f6cLd/LQ5qBXFVW0VC1Ozt4LOpxIVBpDmq66xTooalavFygCIEEmRPW5KTI4kwEQC/hkyEtaWQp14uASBHNY7zndS3V8UY97hDJxLgDpKbEOAFmBxjQoUwH09CxAG96mIIdb+JMbFAszbPHYEomq3YUUFxkjGRg6MCtAXjZX2sDeOgtYrzKD5QUjlxfVnFpGfV8HDdWroN8P0wET55TQ6DkG3q4S7UPWyPyjVCtrNh5hLzkVY+/prET2KB62Rc0AwyQjRijkltVVZfbRbye+9UqPewe1Oz7g4vEqaE7bVGTaXeHXlzpvz8qHlWv3+W+5PsrF+Gw6XFAqqit46Nh+VZRHJLS1ovgCAUueViEDoZhZXt0B8Qk2R/rZpZgAU9fUEw4PJIHMoWqGxpuHaKqe6Vbny8zY7rUEdBzsBvKkGzWC/Jw1hAdMX3wj5B/cn0AnKXlukUnX8MQ1wxtV/yqc1jtFXnaHQ1rPxCqtjcUFNKWhdLeAYWmhWiqR9Ggar6B4pGmxdgl26bVKcTM0jc9mULrYm5dCOkotphHKBxUIEleFfXW0+dAmXhT3xj/9IbqnlCJtiT6zras2xc+woss2KNei+/FJiVucN+/iKdu04dFoPt0YBSFMJBBAQwAlHmOcR6xeCqpAP4FIiPKHhC59FshoQorpiadepLerauy/Fw1o3gROmnyHdmPqkxAHbJVd+AFIMt/V/Y0D04fHYyzf0b19iqmP2aHAzVhiquMzEMxPOyuKS6opaujZEInkdO1g4JKTpVfqFFOiuBDvYsvXGYhOWVEdnS4PrgV5fmVLJPl+bA+qOVloqgLqzT4eQJLo5DDXNWvaSJM5ZxpmBk8AQCFhvEgZP1ReM7c34O+Hzi2NivX936SJ4Jxc2DNYNIxbyCOawPrwu9q3fYa0vsSIu6xrPAXlCsFwHHHQNYVhEKKTCgBG+il8Hf5ZkOsIkqyv7XMBCZES71ncvQtZhFqrZWuNEfUiDCtDmh9NTQRUkTxIpBzAAqLiWxViwYaWTYQYKt663939nco2l5IiCiE7wC5p5moMqP7FIIBXowfwAfV2BixX1SVF/JQcaDKieXOOSv1BjzPe7nKM2RdMVMUogsBOGAsIhT+hHBGC7RnB6W4JJD9JH6xRWb+XiVvwWhSoNTk8qny35BV/WEBDM8XmOfLlAod8kg17tQibSChZxNrwQXe3KQnXdT9bLWhcgkotSFkYPFAGQ9ws1WS+iUFreTvJyL4B3DrfQ5AFJPszxvSVblWfr9wiEnJHaJ4reUsMZQ0ozW1KEUtFIuLtZCrwpnB3wv42+rgBp8UGXHxswi/IJ+jFm+35YIOdoxge7JLuYzZ516j93yBiLAeHRuvBr4IThfk5jfukYuVB4/q4lSBs/X2H1gr7WctUkMaywlczKW9NWJLkjGf6wXiC+pmZ3QfZZJv9pmKHGqCxd6GTQw3twAxsF5Uv9xBukbN7MsyWxYliispFhRt2xQfQJ24AqZ8fYtHoNzu6hAEL7WmXWrgw7N/0IMWh553xd7ydZNaGjXYbBf9ak/0sD3oRMF2rvSDQoxE9o8ozBkRO6AMouYnD347ilgt6vEDHKrwdCEsELwRAhZAHmanTCS82P/T9SW2hQoDT81r1RTbQG4F24IS1YKyBUkhhneyB5FSKF+sXLInAnmq71c7nrDvrrbbKFIpZhMTL/wfFHIj/keBQ/sU9pehTnlJD7V7GE1PxjGPKmSmiuuK2C2D2G0gsEXqUJHadAZ2zsySqggdOISWZne02Rkaivs4xH+X8V5HHTnN6co/z23OF6TjHNID60VIaGQCLEvH9C4+ZImQ1kB+vwRRUMiggPmC/0ELa/ybh7iivebePeoQdl0YGVqgUGAR0vwlPeqCWhqRKSd5kuRVk5oEw1+zDKZlo8+riqScWKTweYXZIaYnmqTvDr7QuBrzbruMlGVzo1+ni0wShyA1aukkgTpHOU1S3fXOkKfTJKJUp4lOvPH5EWMIdHoElGCMgvIaccphR9DjsMP+kjz+U1TPAx3cUFFUGiClA1HVbZBmsK0rYoMukNrU1dAzVhBMGUBW8UdF0fLF96gFnlaOg7NIaaEgTvbPOgmU/rXQ4wAKOhiIIl7LgWb8mFH7BnI9onSs1wEjEWAY2giJp6sZhCJQMPI4pQgRGSE0i8gfk6tFJFklgjQDgm+qONcj9U6HsYQ4VZ4z1JZn2+q7t+yV4roOnpJl6YmIvCNVNDaO07AEZP+ighIpJzZ3iLTrkQ6jORJUINvBtb49Pfh8r+sy6q3xNGBd/4MXA5YH3vnjmFRqO9jj78BduMGKlRuXeSWoR4mhve7UZl47oTU1kSZ31rCn359nOjnb1JThxVhAzt+SSlpUf3ERUxMYEVMD05PfdCEDBcP6CUBgKQlkj98+wN2eZdHXc9selAXUF1zcj9jlG8hpShl38IDMJ2PucU7XpXEnhTpmCk6dgaNKxDEFelcNnIZXdXKGQcx5EAHwlpmVCeISK4FSXtH4gnjFNF8Q/oQvCH/SFwQ3u+oLAi0Gr3d8XxC++oLQr40vCOepiAu4drovCN/5gviabi+cH48JXxDeuC+IgBLr0iP74xuqviDQoNA1aKIrIRoUugY5Vxr/p4LvHY8NfHe87jGC7/deK+D72dXkjOv8lzOxNn8zpXsor6rS8eXamhKSQCa9boYrJFYWMGXLXpLHusLWnVZEgkci3D/VxfIgIjKo6ihLIH5GEWxrzIyL6WhM5mJmeebN8R/KCigWkeV83qQA53ZiL00ppeEYo77/0mIRUszFfnCA1/9FMAbLfdjrSrH4y/khFo+2WY+3UI0vfuGultxwCuTil3tFGwLrZ77q4pArnZP75jR3IOf1HuNSQ3gVdxHWENrKoWUJbePQooS24/7UixEiDvkSytF8CRXcvB2ymdtBJFx0vlNecn05RV4KfTlVXlb15TSa55et+rJLXrbpy+nysl1fzpCXnr6cCSpq7qedrpfzoKOIS2r5WXSmAgYvZ9MuvJwjL0+gM/CyW16eSKfh5UmEjFQ8mUJ5nsuXy4qn0G55OY/Okef5iNzDP7z1InoSnU1nIeYCeiI9AYELNalGpxKaQU+mcx/+rMdlIp0DkumJcsvtcq7hcx5KQMJZdD6dx4HJbR++OBs/58lnWXE+f2ZbENJ5hGK4fESjANR+itb+FNqDsrW+K7S+C+hCxD1F4rhjlcLwgSkM0bawnSisxl3RHsiHVxdPRMaz6GxtPOJ2czNdYTVOlDxP4DyuMFl/QnPrMdArIjuw6OygOWUgtuB+6xbqIpIxjiNbvsooZFf1irUZ36v5aTlN/ONOkxmupPPvYJp8c5p8c5oEKWZF8KJ8Ox6Xtj3ajilBXMQ2SvMzzJTIuMBZMyXOeORTIqtOiW1A5TNpG89AnRKMi0SC/ls4tF1CPSCchFaB/jphuCmnC/qfbvH6SXixeL1TXnbYuTDPL1vsXMBLz84FvJxp5kIFyXdNIPmpVSQ/rYLkiga7FZ8ZCxAN/F6p4Lcdrt10lowU8EzjzMCHBlnPR7Ig6Kfe+V8urv5h2IEXT6SnCPZeXP0r9nCiIKFUp0hzHtnYsybx3cwZizWK+082uH/uCLqeT09GgcBah2FPUnS1E05xfwq60qNF19OBmadbdD2jn4EkbUMk44Wh6qrPtUUvgZ5JKSiiRa0djIYhjw6eoD5nAm1OI6Zkhvru4qgtgkynl1T1DC7nVEGrU+kMxYrd8rLL4tg8v5xucQwvpxkcqyDPzgnkOaWCPAq6cybpoILoHKV2CpjdCuUnlPRL6YaO3ShkOfqsk4PsqQDiqRayOyAl3EFnIpIBopEpPO2+qOAfBhfbkFZJTkoLANKckIFmHoDfLq/VGZbYsLiBY1/D/gsEKlBFe9tDULIvCQSIwp2IOj7N0HuguJBa5xP+eX+vLt4YZqgf9euANdSLsJD3OBu/rWJ9VIKZK1pfnZ8rT8qfotiaG1Kfn6+TL98jpk12YINf0+GtgXis4nGqFnuaWxWRR5fPOXkNsIBKpjP4EYwumqeOoATlZykJWZGXs5WOCuFgjD3TLprEaHuKWzRrvACG8sT6VzyVdsvLRXSOPJ+GyKcbzHGL5sV20dxrUeV0JTi6RHGZTFM2XRLNSrpnZA29iJ5WkowLR1bEkC7UvGah1BotiXsqPR3f6bpHF9NevF1ITxktQFNB5lwBu3QeXGCpzbkjdObJrgBQGE19gkZrASexIPoQcZsN4Hz6l54XX0eeSg+Dl+pm0MdBbHBAZXgqltMEFT2qIHxCEHeJk+6J091Yzj+cg7eakq/QnCWI7zGVLYVr2cGbUJUTg4q4HXVe6q4uh9jmViSeRr/Hp0CmLUVW0cfH577tk8pjfvER+EGF0H/CDyriwoof1O4BGAgUgf/V/LZ2Aq+ov/CJn/9ErfSK+pKKV9SfRwpH8uMM5xT1+pucU9STrdK5SOXyslcpSLMb8JxwZAqZa3YjksZ8mb4acbX03b7nQ/gSVIQvoRO+SHQI97ARxymoIhkP1KLDgBx5qI1Hs/1nIV2EeSpMrchWAjw4lh/IaWWkoUg15HYFyy0CW0FgKkCPJyRXwSaiF3FGKyfYFDhntFMkVwJwbW61qZu1MagKrk6g8XD9a8c0HvzHU+Phz32vfrI4rgNXxMfz9hufvLffE/n6RUH10oBjkVDEo16pJJahxYGjVFL174uBV/++enA9Ov4xmqIefXW0IaaCnAzzAKAsH6E+AN9YbmBlH3utmxnx8Vz8OsHa9+lJJac1IAaHoeS91wilOYDX+jXCQPi6GoK+AVWC8rCH1sRP7QhCqeGngkVzqqD2XzHxxLbNF95UsW3jXWjeF1SnIHtQICmohttOdz2kNwMYhvy4H1mtVT5PDtoFFNXivzxaPN43L/6jI8U/cBLFPzRaPN43L/7+keIf3LT4rTV7uYln/EG5U4KQubK0qrPsk+ayxMc/cf0hFKH3JbbCzGyoH2e/fXDs00s9f9LSEDyM/Y42LHsjKpNLpDXBHjUg9MOIHTW3++2eZyBwk7FNhIUP7lf4FbezWgqCokoltOOSRcGlH38dLsNA5UFxr3oN5UdedfxrKH4tnXWUrF+7sBal6YJMhhaGCaorh1CGWKNUHTWln740T7x2MfLzii6/e+S3hp9dEjx3bX9u+sSfGlYlrddAYHan/3ET5+c163RL3R/bkDLU8pK9Aa3S4E3jPtV/XFzZvVIB6BuCqgX5MjSn+6JrYq8QgfQIRTdna7rEAJyqvCntlwiEOC7VQRFKp/k9jI4+sGwgOjRRgAdi0+/hETc1KLiBJwobZFLWxg4/Fn1fi1TffVKk9ia7TYdV7jfrnZcKet44ip4HT4yeBx163vivip6HT4CeP4eVbwJB7Amoc42mh0WhsJcVNgEAkxt06sq6CLCW1Ski/ivXsqD0W69evrOfQKOKSLCbYm04mAuDjBFqdVXHsowBEwwbE9tlzNdVy8cXLV2upND6efqtOgoPtXQsXahEalA44IG07CfRoBVBDvVT5lVXsFuQ+m8Eqjd9o4Hqx44LqpuRKkTv+WDnpluTNdYfdVMjk19chcBTnvQWrUirLEVLXny8FMKW6HTnSfRUqcUc1xtObX//2mv2c66qp09NapWuPcEidmp9Vvw5xPyvLmRF5fiRtz7Z9doXaYTO7EfXqVu/wTu1Q+ia2tfD3Qe4Q0cuZMpMyeeXTQrhIgwrhfZWI9HU2RuR06zl2Z8qY/00z4eFek+ajfKVM1F6K0iZ/ZSuLWsgtSje0lvy0u+Wwu+TbqrjmXslvLoGcFS8UYq7O/zsleBZ4vcOH8ApqCyRrMqxZv/SRBbHe2uPZXUcuNXxyL+71XE4uTqeDBY9wwumYUOg5StpLNCANR1WhxKBRQnla5LHMnI/40buZ//djdydj27kxhjWn5f0527KsJJwpqv7hW2lkoPdJayrTsZNeVZ6LGP7dje2v/jvbmx/6XEZ23dI+neMjq3bisgQYmDVK+uzZWAvws8lJZUlf/rwPuap+y43vL/y72543/1vTHS9xzJyv+ZG7r3/7kbufY9q5E6GefrA5szTudL7i4QV2l/aANwto0zCJbn5io7ArqYZ6eyxjPSH3Eh/+N/dSP/613eOrsrodafO0ce+eP6WG7m7/92N3G8/upFrYrPzuxL7Fo/lAwJO0X/m7TtObFCA27DBhXuIR1ddvIckDtDzWBXX+3plVYXqeKHIOYtG9+tCocNUbmzjbooutVa3vTxZEewRh+zWKL5vdj1Ha+lHvAi6rT6Pp+eMCTtkkUuQe6bdoS58vkW9izzCs2ueSV/NmsItC+oNgQpomsdvHFfEBiViivDQxvX3oFn9cw2MNK/z6BZaUAf9lyH3tapBULGve/lJzpn7cS8J7gfcXvJ5a5vPoO5jmUF/4GbQH/67m0F/9Ohm0CXHHUc7igmfipOOZIgT2K8PBfyUG797/t2N3x8/LtuHPz3B1vAS2TDskx3Ebtk76OGGnm1ArrP53iF8LGP7v93Y/tm/u7G999GN7VOOx4FCrJhN4Tx1sI4+JunafW6wPvvvbrA+9/VlIs9SwejUJfCxnxr+tRu5z/+7G7kvfH1HTl2tZ18nuegDbuS++O9u5L706Ebu6Sfcou/yj3aUd9mMUh70H8uo/aMbtX/6dzdqDz66UXsqj5pT7BLtOgDUKNj5sGJY+Nk/a+GWCTGNf+k0n6HI1T82YdobsR+ZGrtrWuTqRKQbyr7pVh+vPk7yDqraHGnboSKnLrkEPRRkWmyA08Yk/Y1nJbBP/cTrWi8ProtfXjFaeIxPoyOtR+1iwfIXenuzTxEG5yZ+QpnhRn0GA48iTrnR54IP+wifzk8YzkH0wOPozAVv4UZUzCYBwuJgqKjvE/d/G//IZjdNhp17933hPyD2Dy6mqHQnw7tgrjtP8Dzk5w3U7a1p+YBX9hrpejN7LZ45dscP1pBSX2M11qKlPnpuCV5YtA9A9/aQZJsR+Phy6V5jOhSJI3EKstchArZX8S0QpE4xTIFH/cOB3rlE0EdQ1N3nqS0+9BYDscyBv8t6BY/MpbKjT3Hon4rP4f3Fct+DNddlYOdSnwOqHthPKOzlXTF8uPisYoux4zovN2k8hQHsTWTcFkzaNHu9ACfknkETtFux0Cp15UvyrBUrmKw94kcrX/X3IgAbArrTXu3X+VYbLanTU+LmlEaCBs5XmrPuL2Vm+VaY/dSysmI7HgsFMaAQWs1zuY26mhf83ME5Q9qa78TFh3wbhflO2o4WnTJyK7WAxv6puJW6g1UE89NoJwdYcX8XncrbvdPxyiGAFHfP+JVpZ3AASvS4P7EzP5u25edQnj8BYhTpzBwcBD6BRKW+GejtgVnEwfKMxjjfgbvNraMdqmy9m05n3fozctaS59sBZ+bn0jn5U7jkV+bn0RO5O09ikD05P5/OzffQU6S2ZcgmHq4FtfwCOr8Ms7Z7GX4qhWWY5bJ0PkLF02gZT1bMfwC6+KG87KU98uwj8hn883CKocDndCFdgNhvoYvoqQjsK5P5EkrxzDLPF6G6v5f6CFyIjHsp4lsMA59L/ZJHT6OnI+Vp9FS6iAOTwh58IhVcpN8FxdP5O1vZM7l6KWcvIRolSLRrw7fQPlSgX9/l42vo9D8DkRdrZFDsrRbJqcjEJe+dWiRuJGi38PVRn7slHXkqIp+qkUFxUbVI7h0y8ZcXuSLt5ZFlPJbpfDzOpz147AE+AN/Pg1OQ8/oxlODpiVD9Z3x4kjyfRE+WJ1+ykee59BR58iVFTMDdtENXjNNpFxD3DDzOoLPxOJvOxONMOoevBTG6PgHmi59AZ+E7vkE2ehf1FHcX1U4O/5uT45uT49/x5MAN1AI3UJ+Fx6VYLIDouPinE+J0fI9wItevzsZUoGcdQHE7uU6EzmIM/laeD6fyvDjt0c8JGp8T5zD2n8pwOIthcCb3/zTu+9lmXjyTzstrU+bGroCRuTI3apW5sVydGwblL6JlMy9qlXlhBzRUPJBhBUqbeJ1xJX4DuQWnf/7Zz7v/h979+Yvts3gaY0HxdOKJAYRXg4v2WTyDEwW/tGhgoiCsxl40OUXQDE4ilFpOs6fa6YLYsn3Up6fqdNHMGr3LdOfpUq2dKU/Vqi+UIjVyFK130YUobQytFXWPj9278NhFzwR2P9Ng93mCvec9Siw/h04H6uGuKOPbWXjDbfgzgKWn4e00OhtvZzOyE5D9W/H5t9Kz7P3VAvdXzwZ/BJQewfNzBaPPPsC19mvAesbBnVxEnj852GsQk57MaJvkT8UThJUzPgloR7sZJZ/A3To3fyIQFJ3PmSLkISPqMiPq+WAGK4i5XEHMcAoSKv45ElxFvKeW5FSHztLfKgZwNFI57wUnO2YYpT1mlHYJ9DF0eD5zctQA1ifZUXkKnS5DBcjvpifgjW8M4u1cHtcMw2puu56tH+RU0CkvKvjH3naFK+ucTqEdfCMd1IOhH9J2XHDaTqQf9WAc8wnKdYdKYZSasMfe38OV1pKizGnsQcROX3uJ2W0e+iW+3XoeLDiBHTgD43senWFI3RM5nR9P4scZoImIezLSgS4husasN7p9HrKh0bvNopA/TQN+/nQzn3KzBPm5WRaDvK8BP3+GXKwHzoS0G53S68rVFR4NKarL/JMRUV3rn4KIXW7BR6N4zplV/1sUwWTxLi6hXfJyqSGB34bIy8o1rLrqP9uu+s+xyedK0+xq+y0ns5yDojkW4VL6tpJ27aN+BTelw7RP8+tyb2t9otZ6CV2Gb3XBpmfTc/C2jy6eUoilp5VCdtim6wIui79b4582XgjopE4gR1ndBMJcCc1c2S1zYre9P3+GsRavW8Uafp6pS9r5fb5Yvp9Jw8wuXJBXK4tP4oRdah+wjUvE53MWnkLn70fosh4mhvr7eyItUpvO5w34Adx+pl16x+vFwj8Q377GB6zovmeNEVT2r/kyiI46bq0N361u5WkNEeihjbQ209XtP7p/HQMKnWCa4CkdF2JwPjp4Pj3TWtE8ugXm2hbg+3iBFiGn4xZai2+whQdLmPwHy4n8xD3cbycfBhSz6ft+6gAwSwqfBSOlWCUfphzhEn5k47+4v6jpxh9XEbl+DsjGH3DHtl9lDdxY6mLz/kw8WvkWyN0QKrZIfPFMJiv7+7LmbNnIn8s1PZkW8j1SGwaOAlplKnZLcEAgZl2XHIUz0fj2I/TcoQSK+EhRp3rFovjDC/mFqGJvodTzfLwkxRMZvBh1jI72nSEe6OV2mbY66f29TGwhmKLzc8YLEVpcKMRcVgnMMPA3KHlUmrCLM4HcKVnnsn2g/TMFVRd5AscPBWu05WpBkvMV+UwzdpXIxtHWf9b5FCKai1jmJIppDzcRRn+Hxt6+p7gTOo/+XLX2F3hT7LIIA3oFbHoyYp9sxYAORVaoK3IVwL2UpmxRacriyUtTViAj6qhQZZ4WRajSVaFKtxSqdJ1QZYsRqsBc9fw3hSrf3Dd+c9/4TaHKNyfH/82T45tClW8KVb4pVPmmUOWbQhVwy9Tp8cAY6Ur3cZGuMN/NOLD4TenKN6Ur//rSFRWrkE9beQI8izFtyQhYnnh8Act5tGVciFLjNXKZdhnbmzHVKjKTcA0RFUGK24ziEU6To1A2KUdZkm0x/Nh9O+QobYhT2rQVebZaG/0RzahmCPbp2degSKMgyNQOUwqtoQVpTTYQ/RZNDivJSTUZbvD7H62tuVKtt0l4KtirnzXx2b6Jz1YnvpLorBKtXhucUksZf6Oqn7CKjCrinMBM1YSz5n5wfDNVl+BrVW8/UN5nXz0gBiOcf1DYNszegKZ00on4mxD/yOxdHc9KgD9qJSCwVgJe8zibKwG1wSRSe47OYMkbT+DW+U/jGL4n6/wXsBNne32lUfpdhTPSeE1G400oS23oDWL83h4X9f39hrgZKh1EDuFLo/TKN8gbXMKdsThKbVKEPqV4wIOyJsAqO2JCccoQ9a1z0cMBqq1TZOZoEfBLp8jsqz9wbsyKWQzikUrE3L6/SvO/fPhrf8fh4Ai3/sfQevVZCo45GNg429YyID08zH3D81BQRLyQBeKxqI4/tu0/rzRnAe2k4ILgzpif2uIF8fi5VsARpNZWV39hR269ILgL+TglEZ+WiNmIFQrcb7Ws30T+jng460gvryx4gY4ERzkQGPcOataXUAvHLYBcLNC8kosGhZTQHM0NuJfc+2E5Hq/bu/5QUCwid32jCNYH/Bb1/T4jP89y7lj0Uk6j6CXZR6vWDZ1jRQrW8wCD1RWbivPOP9iS7FAWzAccRLoMJM1yW+QjHk2MHC0NhhZdPjgofHX8PBwUy4AkMrY0Y97lr331Bi1ldIfDIaAo7rWXKeU8ZlwNMmU34835e/UASzS3WLhUyW3F/fASGJVn5R1ayOvWK1TnmZItY4hn+vUItjuX+7FOjPP8O3UESzeyPHkwuR45FfmDhdT4Sbg24uno83Oe30tzYA94zh+YkMpwqtexiK2ntJSkrqISHrI38zDHfY9i0aKLz5MF7CHx5hRvrAPP+09fK5KNfX/+Qwu/+K1/7rMDR/6Ed7ZFI3tYzI01+YMH+AP7nvL7fZX3FqTt0jk3BfN2SROoscGu1VU0HxtnONSoevD2xCPOTOX7wVAHXhwiFrMs7S2HTmZjm2Z52pclfC9XPiuYxE9GUoxQUPG92sGjQ15l/D3KsEZnMp5h/y7G/DT7M/WFQ6ECMASgF/htYQ1DDt94XvYBoyhIa5qQ7Jv967Ovv/Unr3la9kEk5XMUIoWxY+BRCL3K7Kh+Q7GLU4zRmjKtCQZpRIt3Dl7y5/mxCq5gDo1f5Me5zCro2YEFeJ2W2aV4QK1x2AYqoFtuV+DmYV1QwmKh65HHkAC0vEloVeEDUtbKPiTdmGMjMHmMx568w0k3e0hT0HURXcu1Q8FdHnUpg3uc/ew9qvXCYmVNQZ19GCXB+H725/hOvip6mIWrehKw1RcnSZDXg01Di7bRAlK20xIeMJSe09bSND/xtrN1YA1JO7Ge88bkXs8EjtnAURu4yxP4rPYTXkIn51F+CkxTA147KV/Lsz7sPRX5aaBo+anGh5MiTQwy0eENBxxPx7JJoNNMwLK3nBZjixTbQ5JM+L6MTpPnaXSquI6k1ecgMcR+xpPHUXwvoWP6uBcROP45hfPRKVz0wENzRueSohjaJv7lPeua0lqDP5VWAVjpW4dOxalcLJ919BMq9DnEt9vM15b5XlUytp12mLV4Pfe0qNPQEloF4ZcSiowylOYJQFDekSqWOX/cOWJyKvAorKXgFanwZIaSttIKmMOdazI2p514aAseWhnTU/NMxrQ40ZgWp9ApJxzO4rEM4/QhPM0O4Wko+7RyCAtatXODCnQ+3q+z9lRusBnNWPmmAMPooP4yC/WQPHbzehsFdCpnrHjgLZh0HvKQrmkYN8zlBTN575ApO89vh/hNJzAmLe1E71ErTp0PeTLaS9TNft3wjnPYtOR4LBQraD5ICW1Z02/zHXhfRYiUIMQgCMA/JQDbuVe5UrqTwYqYDEIUghDbjocQqxYhduQZnWom+urjP9FXFUO2PY4YUhgMUewrSgxZpW0A8XZaBXp04AhtB3XWgPR4dEoUoY6d6kr4LapkQBWh/4CeznrS+c5g4k5IGacKhmhROsFBzRjwU+d5a63I3czunuej/wBvuQVdFo4Jvm/9NewtFPh8LSD7iKwZJkaXpDT7DV1ZNXJ8dcWePSP/+X3vBxDsGgA+eDFiXtznU2iflkFtlilhUT1sCbtXbSKqsa10CzkW4+nRu9bG+qTRq9Ojs2mFtKZkTafENSfjmE10JmDfGgZwOxxM8zA66gq3n/bhE2uGLSQ3+Nm4rIcduZrcg5lweBcg/LDf0T9EK7M/wm8eWjN2XNouFLqx70ef+SP35Ncne62H8vsvZp59N651UY2BU3EDnX1cyoiVW71EuFrVWbkgYEEOJBQlKnAPldWsU6DiggAMEzoS6ZY/oyD7BAq8IHieOWkL9P5ToD7CEvLBv2efVFokVu6KBI+9emvJZMglLskbwJjn5bE2iXzG7lupgcthL4XXzQ3TD+2phgY2OLiI9zMxWuJjDviUVG1KaOWXi/0JrljMW+iUjsjbsDome4cUcoaN9exTCifJzy3210oQUryO+WYq0Sq07MTtVQIKSoeaiiZB1VDw+TWHBuGa3PXiTWz/oM/X9lHxCsdnZbyNO5HsBnbMH4mJ8Qc9H5IIg6n3zllUVcMdeh2+fw90fLiyg/rvwYvPD2yljjRGpRKOOvjGCMIa+xyTjArkPPKxG69sOExw1951ZY7dXsZlumOooyFgjyq7iQiEAoLLe5XuB9mfIJ9W3Pcwl7I/FdBxGvfPwf8zM+3oOg/XyK7Fs45NnzjNa7w8Lg2K+KXPcEBX/I8zNNayv1JkxugcDopEaDTWnwachcAbrOaDWBHLzULeEoGK+HsOqAFZRAPSiWERlnfFGO9GBAYzshPeKLL18l7ZiSQHCabL86ShRUghBDSzA+LQEQeyI4g8MshDZEvyOWlIPi+Nyhf6x9Q/wyx/DfOqusZxfViT+MescR30mEUfRyhbL3iLxLmHpbhinUtTb7XFEpbACGczAg/iYJcSUQlTp34rtMjQ6eGlK+v+1hKjIOixbC9cKVNbeBJMxu1QJSPiR1jkVpWsgE/ooXQHamA7iDbkVttOWs1PCfbCoQmt0E5ZlCvMAy+YXTkCO42W84iWxDX8Elcqa+xpnIkipCPraQIHzpVgbU3UX2jfp1NYaayX78KajIPS0+l0zi1vepKgoLfP4gxO5RTk4wf5XPzzUDw7piFtWn6WGQj4bUITMBTaCmSrjgadxo1s3XD3b79w93+772L7RN9MxXu+xT5xQnF6Gf3r9onosxG9V2RD9qngIUm5YuV733Xs/fbpUn7g6uCc129Zf699IgWlcRrD4bTysPiD9om+oPtoNYfxwH/owsf3HPrAX/3zne+3T+nCR97xrve/5W/zp9snIIf4t3/H7Qef+8o3fcA+bfzhxd/dMvD++en2aeP/v//woaUDH/qPH7RPG//s78K/n77YPhGvfYDqwdkTjbz2E7//ny/8488+zT6lkM/ffubrP/fZ//wB+7SFv+Kr7/juv9j6W0+3Txv/ie/9EDfujA/ap43/mQez2dnZ6y+2Txt/qTTuNz5on66R5xCPp2cmjH3yYH77JLvNo/FJeLr5jmL3lMQn0m6g4uk8cL/HNfom3j75m28nFPDwd/CJ9Dl0BqGgM4h1ffSzSvoZ1JJpIFuAJzEK1/k1DfE8C5w6P8/kZ8bPM/i5m59n85N42uUiWxEm4kmy97imiF7M89npf4Kssf7n3FACRSjUbFT/83SqsxCN5EMOZjY4T3UNDYdFNsxnOY1sGr9ntB0siZ7en4uXpHgK1EbPU5Eq2sW0tmMoGrsLo0jmKva99BRVGz03j/iYPMG8taSj5kgHSq7SDjqfMwEi5/Yz1NnBGVyHcjmD20YFhVAbJVUbjbQBeUK5NCeiSFpOiVB71QyNALviXCXf51p9zQR8SlI2wG0M7On3LhASpmKvhCOonWgFE03lYhYqi+0CbaWZZ+WRHJTlWylSsW1DV76mMFlopW9FsddHzq/CYRakJhoPtowvZHv8jNisPD8hoLuWEnBMh/gVNrxvxNOYjw64xQivFvGL9IipiJiDeRkKwH4MyZzCUS9BIf1gjU+/z/OvFv4vOHCef0Bz8gHVGo55XsAg+TQ4VYoPGAa3odzhqi7luw/oAUgei68c9QWN5UgrR5qqyjbEIAAapybN5fyfQrFXrm7I0XqPa0UWhan2qwuWUb7uwXT28ygBT/edlICnezYl4MOleP60IZWifGGl/xrch+a/RPJDfimzxiOvcgJXBNKaIPu8frDLvzoHVBvn+WfxAwJQfiRYmc/zL0JQjyf3SPALCJ4rwfsR3I0g7qxjz4HgQ4jdKcGDiCUJfhmxqxJ8EMGuBG9ChgUJHkKwhSCE28aSwwGqC5pmX9Cmoj+aiFg9fdUGToltlDHKZyeMbBYF/zKcjoIO16aj4igKxhUUjCwKeoqCGGZFwcihICMfUEYH6QAyOazzKJqOdRAHYkfiEC0UalMiWmAQLSRPES1SRAuAaIHZiEwiWqBfBSxgOi6ieYpoIco/AaIFFFQRzZPWeFVEC74BES2oINrfPM6I9gsn71khHPGs4G3iWSEY96yAXc0Do54VfviGqmeF8jg6wlbz38i3wo/ccDzfCoeR+ih9EPzoDeM+CMKqD4LwJH0QXP1YfRB4o9oFodUu+MlOw5cT/VCOEb3rAv6z5klqIztrlaY8W6Up+/Rtr77tAZbexrIbPC8Idskuehc20dinMZir2/AMR7wXBFjzPoJZCZz4cd2b6i4wduJlvVYTX7D5R6nuaKmo47GzSMRWjZ59yy6xSQGKBT2so/T0tmHRuiAglEvpsEhN4dSkeFg0RRbT1YgjRVOr3GNq/Andp5P5Bql4aMFtag8G+m1KDcQ0qYkYmlJCS0uItQTbNEptCS0tIaZ4egngEbnLiRUS+SPHmypfgHTXS1Meu5kJ4QsMAoo9QAFYvyvsWUIzgpFoTI7m1QE3tBFApoz8I9zGOPtJNEFx0KdsUI2paSMh51cafxuArd+n1Jr4tLXZp528TiJNmJEFZ0ZaXMyaNoMePRcD7aPVdXT2ZcA1yo4UrRFQxNTCUifgPYIRHwyptV5VCGkhujVgTCg//H7Fu/SOIi07z1mKJiAQUTrajeZAY6ZDIK1AIBqHQPM4EEBP80T6nc+mMuIMkwZg0qBZEhjYS3Sw4cixsOpYhM+SbsfDfI7HVOaAYFOWN1VgEuPRnZyW7vWD18GmUAvQTKlJrSPF/JBiENEjxcJwcBvNE0csEIeL1jrwfEgpTyapdkBzRxjEPBB3WF0VXPMbBW6TIumsqm9AAjqaHpcs/PPxKr1oU0ALXIH0YoChgUXcNjcmRgE8NuMjE0+MzC4L3lHtmEafANUQL+OA7wDw0DiYhPlFCvhEJbOd/h4xQ5TwJxFPoxlVFwyIA4lDAmloa6Khm88Ekanp2M5qhdyOiPHfQ8ldKf5I3sIzI1R6JE9pMW+oe3wo+IEN0GnN3b56TWgTIzLPBKrrxOHnCyS+jbE+UsS3lpoKQoQjKNIgfeFI0R4yyJvaqwzF8ARiJBgb4NEBbFEbKKJ5TzDYASYbo9TAkZ4FSiUCE3CcADWPQ4AALR3Ki/JZHWaGizAyoY5nxByLXnlE2iJ1SF5FFqgsjhb4GSyDEnQpik+3mLUrENZDEjADhZMIuQmg3eBrtJxbdQGQdczF3qaxvORa1ux3/ACqduViPGg4nR7RA7kF/YAemWgl3pa9GUVolLqenFgRNKdmhLY1VNaUl9BU0H4cl6pKG7/liaTkDUbupmBSvZyMgdISX2vEFi2PSoPSupj5xH9X9oqWLusCCko5Ir1KK70lXqOmrDhtwvSgNlZWxh1s1ZtiOA4lR4yyRWTO2Jroud2+q56BlgQH1xAmHBLmECd70K76uqhQ9m/ROgIOVFUof35zFcp/VVXO20/Qjjc9/u3IuB3ZWJuo2qafOkGbfmO0TYFGKz8plTB+lFba/eyNSC38fbvlbE0JB1oLwduPf/LU+9NzZj8wAHERBwx5hAeBh9UOBah/AY9+oh2CKgBjU98TBt7fG+wVqFKY/Yyw8DWmtiGwDvmUQPC5cI4JXnaCwvTjXgi1PPwJkNQpr0wK7JH13SMPIvmQPGWPkVrEwHQKQb73vff9n/rjP7v2T592JYRVFDP+q0KW+PB1J7J48AYF1WjLUJcWqouusD0R1SslIoNy0tomivK66mzhe+2ZO/EV6DxS9cRHlvtH4sjj3UdYJXZHg5LYAcws5AiAMuUygVXAL9+YdYucncOoopxyRxEPCumsbCOOYEEB6fNvVZJUB4DB50qBVB8M7yiSQV43+J0cKRKKr5LFHdR2D1Ollgdo3V3jIIV6/BxCEIO/K3sXBHsZgxoYkjq/K6cjDWhyRAxGH5lqwsZxPgqxP99A71B8/0YQFrenSXVP0zLDmhTt2/IZuWKQysiiJISVSyfChI0YGtQ+AuYopBmKONRFS29D9sxk4RaVOsx5GTzqRDkyITzdQjF033zmkde8+cZYeYGGUniK1osIfULH8xiAMSkAIJUfvV/AUJfsCinOniB7fYwNyJNUMdkr7+gC/pxmLaMeDApPh0N32bpmYYuHYcMYD/IEyWT0XkyDIhSlY47yFNrUkLWnUx2+BGptboDcQI59EmnWqWOqXVDZ8mYjTCkypdQymRjl/02FMm/5xhPK3HFcocxAhTLvPnlgRVVgHa1tAqxwDFgX4wh+FFbD6bDSsC6EgBtNg1u4n0EnWsmxkB5ArgK38HhwA1AVNgBfS8GX6CPEQ+G2fly4vfUxCLOOfIMLsx5Vp356olNRtVPRSXbqisfUKSDkaKci26nv87E8QvHHysdUNK4naLosRNIIxPBO2PI/T7fSsyGF2HjdKk3m7I5BulIsST8SB7vBCMXxN5lE/jjFwYHSg6Oz6M6RWcRtBwlVocC/Db35uePOm4OPYd5cP4FiQRXFgpNEsZedFIr9yskPJgwzm9E88qFXRVMGU/ME0OtzAzrgvNirDj7ku+H8tZHhtDukSPdImwxo//5rXyj2kr6+A/ve4w7s+3Rgv2Mz8+IoCj2U4fzyx3jygtStYdzY1yU+1pZWrIYj58Ja+n4/CLEXsCbPMcLlNLqsXSsPzEgnFo6F+Y9VpGRt8IWTogBH8xByVk7FY5yGxyqHwkfPAeQQ2I+zN9Gk1a/BK+qXeteUC3iZHuRTTZaNDgKBwUh9zX7JCuMrc9w1n48jMb9RHf+V8zux8zu7C59rzxIpuAhdgya6EqJBYbVB2Tt0RL4YNmQbdV2IYwn9m9whjmvwhYCq4rT3UgVkbaOoO22LnOt3Snp5o3wj1qKs4/+8yTPYCYPzlkCxVSqpDobUWC/aToSsl4nyGWqrNmDezn5ZYQi2E5Kv5jrN4L8By7BmbqWZcj82BGvpWPE2VMsX8o7uP6Hk2tVHRoFhxVoS6sqcmjEEM3snquPXgEWARRuPLrXddmnmSJENj6B3M2VdHMm6duvFHHdlwG1XDQtYrGpPNDB1X83hkt5wuE4ZZQN0bXa9shFDBx5BZuxoU1Vuoxk3REAPD4bWoTyL5Pm1al+Q7NP8GrU11DGhlis7b1EKJEiNiMhZ5kLBrGAKB4yAa626f0/f5nmhowLuYqsKz6Bim70LkO7rFieGSl+CKd1gqr9bFmwO98VRQ0Pyi+P4jCTuLGpMXThWqaF3xzyUmEBYm/2KVONhb85E68JayI8Gio2da4InVvfZ6JpZP7zyHvbosU866czAzjV8CkD7+PQO6YZXVfrGggCMm2BgTpcS+9yGwY+96pBu9VHr2bW34p1hnr0HVaTp57wAtDC6tqKFqyPK8upACXpoHHXIls1NQCcfzusuNpFpGSkOKEmpIEBDt4zlJDWb0JiSIT/kuHxQwcXhEczpeGA2phRMZJBPkQsEJI85E/SicCLDER4mjyd+MP4H626IW5A8UIZASDw4MZHhaEf9AEk+ieONrBBBmgdtCNkjyO0CpEJUpEWVxaibwXJscJPd6Lfb3QHndWwCyvMVN3zkNnLr7N1KpFUf3pOh/WHfC7jl4u+j8C+stdBCdfwhq/rZtVbbM8a8ApV265aGZxiySgNlDUdO7DE9LgRCQy4QoVAiWr4uWoFqtHNbfhVt0QLxA57UftuvySPbMHfwuXxPy/c2Kz91bkkAxrIyfkdlGyesTNuTpv8VA1mrukdRhyu+ETUCZmZdR1KiCEe+qcqX4ZERVwcmOmAJPuEEVzxmL+rA+Dw+xeP1gOe9UvEP5fF87PJs/yvM7GccvfFp18HXy+lB8v9reyjzGU+6Fgd+aMvsa5BHCIx8CNh0UykAd2D4PXvj9QZ3sh9WIpD+90fDFb9/gisGK+jYYryN8cX9aXxxgQ+vZh547dFvwMD+juy/ULvSc80SmLOl7G4zcfQs5bcVVf7CC3xcyHZrx+j96wWZ2Hmk9DhTxz8h4mtIkThPL2p7yCFVqdgSbDN+amARkTLtJnfMgD6LM+O5qpVcpJDIVLdqoahbd+Joh964TYTf9PV6lLll6+HWlUd1I5aqXv640PNHxbq+wtjPPopPNUFTZYQc3NNDj/OBg14gXpHjBM6Qe+Uxw2+6YwYVEI4ffQQ+ePKJW06owHkmCrUzkbDlMXPXjoOP2GWPsu/CccfCcXvH4bg9MLieY3BB2kvO2oeiyTR2Oiq3yzHVxrbLj7ReKycS1Tf90Q1YuF8caIU6jrFRAdWh4GrhXSg53+TPdcGpbrZCKRWPUB9uF43xUGe6KKbcXoDWTu6pf/5xxQ5dC+3NL0w0jXA+uDSHZ3IAf9wx1bETHFO9Ebtra1QBazf59iY5N87MXbQMiXvwc+5+XGa3Wq2/5W6UhcbflipsIKf6FaZQ0Q4sRV0N/hYBWHrJtAv30OQmNca6rnc+4qLBucV7VN02x6MwBwfpqz1c+Rw/gV69dCZxzTlQg3xwzHIEBFSaUv1IzcLsfCD0W+4qFjmyZ+idJ+IEtX0QmGv/ddLkIsE1OZxOxOqMGXsxfNY0+yZPhh+LXR3FpBgkhKCTohvmPiYKTAJjU5RIGW1lsGZUAV5K6lSvfGUoJaEOxgP1F9ia5BnGOpN7n1DAEp2JJobF5Mx9wg7JgDaiJuwo6G0xBU2EH78EbQCYBtZZtNuuW2WOttJXGbWo0jiYVaJUSXVTmjeLvRPN8pFJRk2c0nG6PaXDviIobxfeddFQOsASwI899brvf8uA3Xvt+8mPP+tZ/zDz3y/iXmWG6uvdvQi237wXK+1/OwYG5xf4Y3D6On6qLqta5UUk3Y2lu0Wmwjp9aCdNl2MmOyBK6LJvUAnzLHQaqKGbTnedvLCqVcqqPvnzn/j5KWcdyDMhq/oE8nLb+PGJmpNWfQzTkBvN/+HTWFGz39pUUvWSF/ZbX2851e8dV071O0osn13lRqpmr4LytBlYKXPdYaIeMcvxsdtBuP2gghQMkNZScW73u9Od2wEa4FCfCS5W6g+r9Yd2jQZJA4UN8UnZAookDtVg9diEK3OtcmxZy3Jl3+35k/I6t4JbL9bcf8bdYMy/XzDqW9BJ7h6lgPd3J1jZVpWTbU0wsrtLRjbMfh8fn4BvPX53k5PvLhCv2t2/+recgEZcrKtmoGtqABkIIhDSFVtDoZkrZpLG+hUe9i2cdthmZu7X98jtpGbueZuJaxy3PE1mcw2LpPqZnmYXPgNXd7dQUkNpgHbQfyK/9nfnzGepyh+G5LmKErqjv1SIOjJzirFXwDeGco8fwYEcrQg02k/vDMLE6LBMcmVolhMMTZ8oQD4GV6bW/gPlrD6tnFXfFw7uGTfC3/H5yKPmUHFXXq4sRWi0fELRGmAFkqmKk1crbVPU/l8oT1GvxVesCqTr3a4ItTKFAc5bVquuCA1NTRkBhafwG/yx6AcwHoOrx2KdN8jbEDEwFjT/0jxFvWCS8hi8gUJ29AJ+c71oqfhXllrttFo/8amV/ejUFI9Ed84xCPbiVaSDEXFivR86VW/Hi2JL9nrPU3kaFn6erk4kPQTPtm/HM97UOnL7bz11eJVVlrRZjnGWYR5WDD5RIKyiVzV8VURDMJXAOMya9WHhA/yDolq0Njv9zSj2xYIEt8ixhAfDkif090IseOeP3SBiQcbXOyEhzP63zJ0+BA2amCqfclCqIu8AhWJgADyKUmDf7M4wXS/ttVnh66r/+efXPfzTTxMlFDUoJ8dq+3G5XGRzuHmUNyoZx48NmriduOHgR/WNI/btg4OR0wDFUWkVUJQqkkxRlp40EzC4eDhuJmAg1wWkIxvrCA+PqI0LjGS2PinOBpeFU1dZPxV02oS+p6utula1Ap8ApKgBviyELbM8Q/+oo0yBtd0SET+iqu0u/g+dvf0Ha4cuuu/8V+ZtdzTRkn1EWmnWmB79rOkOnyi4ltMspUeoGjPUfuaz0tN8rizw4qPZzwhez7r8GRuY0wx6MrBezFKb+I/54XaZ8GWu3Yb/094rVaE7wSyOaQa3MmAQQ0wZjuGOJYQHQzun4vQNvso5gsqJXehO7AxPHKoYQEUDkXKEnrna5vgxH3FrWId0UJBJs+DF0xM3zcdMpi0l0Cx4CSYO5YJNDuVCSBFgC5L/SilCOHEo5xrGn2ibOJtrU7hWPYODw+ZrDW0xgxsMFUNBS4ZobJXmIO5Idi++HR7f6Aca9IgMto4cXYRgCv9ynFW9fxNW1Vc/zO/3o8Asa9owNrcxYSPkYGP0/f5GH+Jkkdize2pcqHWkQHYDHItFxeex6m8014wZiwG4W8QxmgzSNcIu6t4GUsv9YREAUX22AuIMsuiiNUaczOseNlIRg7pRaQSmz/wA1XsbeUj1PLCLJ4gSLn/uvnrD0B0KKxZLjD6t3Z8WkdohqTbFx6KkM0ZahAG43Q8hOQNtR0XW+koNPBaeACWIrpjzTByQGjjyZYKPpCZ5uT95uNoCYVkrd9Agdz7V0ZQUDUy1ge4jat0Khox5mjZmnwp+Iq5DVrCYmvyNaEiiZH7rHxTI63VzGCDmhvi4Me7j6FwNobZxFJxApZexVQAhRVYZCT3ckGMyo1lDvs6cRnrj4yzhtDxwP6xKp/78+NKpf6VWfOYErfjw5EQ76E3OtL2j74eeUZlpB185ZaZxbDnTHvz12rSpdvA3azrXDn64NnWyHfQrk402n2yHLx4+ssn2tdo1E7MNC//kbNMlXNsyMdvIzLZ36GyrclJ+6Swepua4NMR9HWcdGjo+6+Jy1sWKJLGdddGUWXe0ttm0i6dPO0BEyoRVPNps2kV22gGWduFupO/0PB/MMAvNvH0vh3naH7pRj31rpTGi9TJ8USV82d4qfzI1WNrtWufV2Lsj91DR6D1VL/sFtARDmv2w1R5aP0I1+UQ3ABxBnmIJJ9y2/khU7/wR1btwE9U7b1z1DtoiD42q3v2F23y77XaEaf5vpHp333H3z5/Vhf6boDppUD0qIdbnJoRYflVL0T9JLcVrH6t2bzgq8fNVEfZRffKKILSL0AZIMPrc/wFDuNVdYYy9ppvJonDHcBbtEqBLfag+BIu6HJlAul0DwTJadAFYBaHtYqZGbxb2Vbz/nKqoVq3cbSqqhVsIYNVmstrHuzSrO8TlqZkY1VjjcUbpf6ulG2EEvjzRF1+a8sUv9qKV64KXj0iS7sVGpyoP2HDyANkkvA3vKg3QJNlBvAvBVL+4e+yL97kv7nZffES+MOwOFmv9+J6xjz/qPr7Hffxx+RgstFyIRBkiQCJM1AShVYQaCHURaiK0gJBUmSHUEqxHqI3QTg7heRY/5UhpBmxXqaTTeVGRUefAfhg/nEWVq8Xci/J5GWKkL9Ds/nwRr7vU92mQ+8bIE86mliii2RfD+SbNvYgfcwf2i7UVfp/fT/UDxTLkIaAXy9ShRZC8vEM+UMS3fK7cfjajWsNxZBcPyrdI5/KVvgALbQups5b9nTGnn8E8yfyBNUpRo5iv81Ul7BjyFx0E5dMiAv/WoQgU2hiEWgFY/ANC3NCaiNPdQWRKbZpby3t9QQvJjNn9AKpGsRKdt0HTJLGY74MWuMpXXeV11OrODGHUH+1d5se1ayLWqZlLf+CslGGlFv4u7SGj2smtiyVlStdwxCg37Ge4+3Mgj2ZgC9jPymBqSixtbZMicRNe+SREh3KxER/QHD6BlbxiO22rmAaO+pmzIbydto4kEeCEwSt8c4F9DiCboyULtLRaIxpAMNNVuZ/SqdzxWdbiCMUd9KQ89dNK85caz13Gj0XqILu0KWQBRzTBWB2bYXDxY85ao4epQlEwcUSX1Nr8soFi9UiUqJ77pIhOesw6R74BtfKt5PA4GbMVNgP814lAoN9qsVcx3WqIzlsNUZ5iGNwmNSjTbxKatc6xFvsh/4H7barR+ZqSh7bMVZmLC31VStwCRMT5OfkvyhuKl3NCRRgcanMpn1VydP8YOfq0I0f3O3J0H4Kpw3dfP35w7OMvuI8fdB9/WT7Wy2lL+uGhm0c/fMh9qEny4Y0Ipn1pEqjLATPtpBrpNS2ZOH+vdm8ZyxMoDRMun8dpgQ9exP4I2i4FwUCCmPOYA1O2yAED4YhSHLIrVZAdiVHzrQ4sLWNOzKnYLkVkaoyE0LKMYv+hkkQpfQK6yataaFD5cITmIKdOEB+TUjoAKjwHKsytojlcfR0lkVJS0dH6ZdwjvVF8u4cnRRjdjnSIr6l7qJzjQMlQowAu7zlYrGIqGIKVzyL+IGBeZGX7ivmxqYWBfMWa7N+CKYpg28VoYUB47jZPMk8YVZjFn5KzRa48o3lg/CotKjlbFnI2T8snJmf8uN1jyIgTHkfWMDP58+k0TTNlI+Qsow62kHO4KILyMEoUc/lzmKI6X63GQ4/bCRknF0JKxiScGTK2pM2ltiNtElaSNwuKNktLl6rjTZhLxXFTy4F91oF9ZhTswFquvWUoWkqrQtEqMFiGjxtD3WZpZpK6+RN0bSb3afFR0jWmWhWiBgBGFQAu0xJPwAgAbAGALek16LhDw0WHhi2lyf0Ojr8EHz30xgGm5wAzOwaYVcFHnI+hTfhT7JqRMns0y5CYhqf5VgClRTOwszubRxCzwBvE9Lxc+lbyBaO20TJFFjXnMLqKSoygjGyEmJqJ2W45CrV5XYEfCA8wZavBou2CLfPAkPkSQ0C3psJgbgwG8wyD/8kO6h/NnASy4M+xGD2aw5xsYQlfNhxeALaOOuOzcrd6MwgIL6QeDfQlU68G+lIThwCEYx8zL/PtRnwV6DErBPfKaECe7SEKr+PsSGQ9FagWE1ZOBWZqp+VeBuRu0vBuDhNtNl1nsC2ZKRFTrBcDdR3E082nI0C9SMtmOs4LrqXTZl1L5unorIsY3zqkpJ/I15kXjc68zTFnvspIoPnKO2AxUPlUDmN9uqYJCrkpN2uWvjqWPm4u8gD7wb7rB/MYb27inBmeZR0yCnGth2jeeTgriN/12rlZmvwDeQckBGygmrCxS6PhpBfQlwWzd6WmZMH+tbQG+Nf+yO0Xf5pmbGAOxHRARjRjQz2EukzjhMk3RzqBO9IRWajTglXpjI/dOMQxnIgMpTgmLMUxTCCcOEY2ZMHmtYRaC9o0qvPKYh9vvxz2yxcR8lV0XuWSflXnFZMmEidYahc/FBV7fYR4SFp2X0XnVW9ROvEJZNNTJDR/DmHWScJajxqLeBLa9lBS9YFPAtqqc4xhcrAePytEQXV3DyjBFAorlcQqj61RLJVU4YvNvcI3UPiOHGbGaIqBqFMyhvk2FYh55SPUR418lYX52Rcn1Ir1Hu0EiN3Z5XknfYm24reylr5hJV6GLj/ubfKvM8M6Kre4ZYyHvgnvykPf4njomxFMjebD2Be3uy/udF+8FUErtzAikrEP3+Y+1CQVkZQfhsJqWFlDHlvpQ14vxQdJKZtolJKLpgo6DGPbKuUY7VLyMVPKOzqlDCQTQCI0WxUdzMlHKr9Y4J0R2lzly6lJbfJp9kXF4gFKObTILPf+YolaLypqB1RfYxaUlJawAzfSDO5BjJRY5Qt3yTrhy8ZIgjU9H6qBOsmOXpWfF5yMoQa6zgWOyBgaNCvm/mGRdraPkdRvrJwhb6IKic9TmaFILbp9eH5xDdniGhILfayJMwcsWAl1xV3rJizCCq+xBzEdEbjaPK8wz8spBbTwp5OztiYmEbeox7Nl4vc6OFkUjk5Qq8oo1AyjgESEybAhNcMmkAnXDDvSKpmEFRWJqFkyqjkuYUX5hlqVSXCunYVJcKxnYmCMtZ87KQyCvlzNYTLhK4RB0PDlYBCssnPXMghd4yzSwbvp4N0YgzcAnVLdQEvuTmFfP8Ig9EBNBHpxJRJ9pkbuUxsABQdLljGgeIxB7xkGHZUKVoFNaBkrxlibrdZJ14gYsEkRV1Y68+ZFC54/kin3onxV8UoljtxwpNRelHcfuazgUQgIVsXo2qMWENSoO0VA0BwTEMyC3s7a88q224Oo34y20vYFDnR1wtcoLceiVhEL1BXsiU7mWSBaPCIWaAPybZo9GbFAS8UCtXGxAHolzWaiNAsixK2i2apYoIZatOCiVRELYOVt6F1tJrAYx5b0p7zHZ4QCedexh5GDxhzQFRsxsdSD+e3Y4nlt5VSsp1VsxpbNR1seHbVZpi7+hNaIm1be3wjS0oKytLFMrgbF42QGUoKaSgmUaIiQrKU7ZB3BmpMSxKWUYGVESqCZMloZkRK0sMmdVXV2H2NGdS59FoRGz4vtnYqIFjAkjqjUKkQFZEVaS1tKIYGGVUjQxRawS00rJGiqkGDBgb+9Ofi7IgdZMEQnZYDxY9ZBIDbGUBXTJ4mRygiqkUKIukqI9ArP7OYkKBkjQUr/1pQQyTl9zYEvpibYAc5oXQI3SxFBXhETLDikXFYqqmKCphETVDFziwNNdww0kWJmWwTDdfyVG16sZEIgp2GqigmWsReOqWsoc5S3pucdERMI26O4OTsiJmBso9mKmGDFMgW62auCcIFS4MpWg0crgi+qj1viyNT+z471v06rEBF0H92M7FKKPwVZWwA2q0t/m+FSLv0xzT6Wpb/xuC/9eosU5JzTqut/rbL+bzZVVQnFoiUHdP2Pp07FdMpUXKDYTMW6mXLpJuv/bCWS0ryGKQdMk2nn67SrjU67zXGmrhNOiZLdZjvxQIcyWpS1wG37Mecabs611WcvJSonaEieGCSDmvoBFk+0cFaHCSyfkxP0uAnaVBHAbqeeygl0rYKcoAUyAmFooq1Tm9JWThBUHAT8fMgn6AE7G5t+ww+KEQRdJLWxGSIygcPwhBKjPLPW/RB5aFaDGsN1WPBN1lUN3hkMdkGx2Zjg5nMoUVf8xbP644Hv71Nj38c+in8PXAyP1aKqdBmP1L4vvuAvDv3Kg/c9/SoIDGKxj9faWL8DJz2Uikvr9sb67aW5Q1z1k4tpGMQZhHQ6RSIGj8Snt+hMo9XiXT0mDhEHEqvNlVV0pK7oYxz6NdIGvYSrfiig9otgzwUj6lRl1QFm0RzVIPKN2tLN1lpF5zmQQamlC7VBIvbms69ZngqauYwoYv2UiaMMs2ABgxARDsQJ+VcxGmRMsihqc0GlTtSwSFy9yqeialB5e8394I1cH6aLiaBOdj2ioDtNj058hOubxxNoRI9EoHF8kYYTH905RXwU/JuLj6pXpqPjyTbclel/8EIRT7zSqAeC8lampvBgkTwzKD2dHlBeH1W3BBE2njjr5wsZjg0JjvhpdU36iVyU4f5wEefD1qldPGBe1C4euDArogUlcSK9gR9Bk0pAky5M6X7y1aolArx9c5GApdkNwkAJSNRua/A5ADUNrGHMmrvv8gUvUJNQVioTlDqRimXcBtHE++fSQPjZNZKNjBKhmKmF7Mn0djHV98OA509dxS4TIYi6rIdsyVi22mS2A8A9uS4EMlBOizD7F8EwL3sIT3z8cQ/o5UHr71U6icY/eRhZs6/iF2mHS0OgXwh8uPm3fY2cX8c6zN48wM2fwkskDPEHQ/LUxL9am6F6fxe0GjaA4Pxyt7+G6iFPl6Rs43ppNgXZq26UhmfvQQzVOflgJN5pEHwgZFL5YtzsqstFOH5wdX7XJgLJUZ7MwxDqsph1N6DIIsBSwT0WadF34kYGJsVNsCCL9t0UrWU3IiPi+zf5a5Km8Uevt/EHR+LfJPHYoQJxGRo17rnyaLDggby7tH8fQk6JvbvmYg+XsRdNi9ztIj9cRu6cFtmd9nlrSmQZo02v86g+poun9/9r6uz9D6AjlP895HQXzkoDvj6+wW53w5jj9gdgHG//vrZea5qaP5zM/705aGH6R54/egcxdm5N+8dAea1IhvETITSp/lCALncpBlL+1FVCyVc1HwxWaL7M5muN5GMs4oLXwIrd/qXrD3HxMFwQA4lfDdzU+8r3e2qe5V48ubDuBcE9CPJZm4/h+oJ9yfjlIY/i6pW9X40j6CTCWExQFS57mkPGhmvQ+zbHPEybVUya7MDGvt/6tY03xg+cx9f6nyz//ujigbFXsjHsM4AHn+Q2r1fcJpMLXtUr4w/vJRe8sveQXwQgRZf05Gpl7dt6hY9OljaXfdB07PeMuajwMjOe5WhigMWexsvIm26eJngBeYTn88gTr6q17DVKaUAkr0aNzwbOyVT6To19Cflq9OZy/YbT1LwfeerwGQBCQ+7xstcKjakr5iLB2kICBUbpLWdayQfS6cUifH2vlydaSu74JbVd8Z3le3YIFahpCqRcjvXJ3Z6MMCs5+tmqcaUeoAfuALFc0ShyN9uqLoHVajTVtKeitIllcd9tt+LfHzPH2KRofZi9TprhK5KIduftQBtxB+dhQb8RT34/iKenvscO6VLjiQv+N6AEtdd1lt45C3RpSjUyKxRMGim9ao1HYRZkaLElbajqvtralNh7JmLrbc803zeWA1JtstyN1Zw33agVVbYif+X5OJWpTH6drLKwCw3O3oivVjApTw92nx/c4iOo+97gkH3JsD568qLsyf32BSvnnb5+zkvKwJfYbh7rtL+Xk2Ai7NPG0Ms9vtik/+/f/7nbb731mg8M2Mjk+153z0/+8h/efhG5IJjuY74SjLvxxCTY8Cvk4j6/Qi6+zC/pHVGIhT+sEr+qvvvZtaO+GOMyOq23OmntlNnnc7EfkSw1QvhdElaVVwmqyiuCaV8S3eQUHT9E4fJQVk7QrqYck8yBTtIFkC4dvR/GxwAULi7+yI3O+zvDsAjKzca+h37ui3/4nO+74mIKe0h8q+DDwD9QRBsTJC4eIXF1R+LqVRJXdySuPkriQnAkTOL4CRKH4bQE7kEQuPhEBI7Bzj0CmMsxAPuHWy6XtT3ZAhz288DdCzn4/+zNDt9o7ahlPypBNe0XSMybEINPdRZUR7ZaG4VSAKhfrJrX5OmxqDH+EFpSpzsNI2gOHUUJ17If0+ULs7kL1HUOPrF8qBhAxicP3GQMdDhvtpPROeuop3rDS28oyb1vfnqvNOh6V1Ty5RSpUCAG36Z3Gw7JE+ZZ6xvY7N+Cd34extOTzesgUvmCOKpqIhyqcnVkuVjcp/SZRmJfD9poWNgWPMAwa/ijh1B3y7CxftVbBAXs36hpKOtf8T2vNssfvl/+fY7fZigC+5l3MLb8zCjeYEFLkM9xxMe5ytg5YBXNEyH4pl4KoXQhBzscMfCZ0UNDioZyvegAPBItUITjgbdFlBKH+2+LeISQEYq5iNc4YXwRl1Xi3qRxPBX8N+Nx1KfkyK1FE+ENDS/SIjWv7A3EAV31LvaVshOhpgpNxABQsaC3TCobfaCXsIMo8k6/WMQzKZbg6CugpitQHTIJ7wZRs8rbwE+l+6EOLjfwG7QgWuH8Gr6ENw8MV1Oz6MumIuuaQxHzemVdUJTSNZozjhKos5bLccMaCsNCusDo6th+NA7iDnzHORT6oFHzgLGY2lvNlxEvNvdWod+oJiwEZrUClnmb2IBCnsvhNi0NaXEdqDCH6qCJiPpu//z1R+9+7Vfe/FWueBPTF0GCA4h5VBvpcgfcwFZEoz5ko7APGc910UTMbhPz4TJm50RMd+Kr1niMvhrE4clpp/Hr/RBTF3+ThgvDZ9z2zs999NZ3fu7LLC1I+PVjt8o7hAfYiETAfLeNVbf72c2HzBql3gt9vRknFjjksFMNeEGJfuSuIngdZZkaYhgaGdUxm8l27l4pqSa+IMGpxIx441SaTVGUYrlntf2WN2LCsJP2M2O70s8+eaPxmWptWB6Lo6B0hGmgsdtRMU/VVdRvM5OuPlhinwWKdUVmJcLQklPeFYa4iqRyf9A6uR8qv1J3tibcDEV7hkfYXrIhTu/h3CGFBzYKtk2bmOXy8ovJBdmZVgLqBgGKm77q6kgYcsLbat7U2ZGSpzalI0r1VlmztOHXEh4q54fakG4z/rsx8kuTaJU4SvNQr1LhhhS/qxsh4/nEggGyUjw6eGR5Ri0loV/G3lXk4Y3hcAwGxq7K6XuHNLMOp4tu50h+RViMSrGSQJ9eelqE0tMCLaVJ+LOlCDiyG67z3J7dgPlxNSUHjTv0BW7tOI7NybQ2mJQKGChEiw/stxGw3VFaUSEXvKqH1DuG6/zwif9AUlSPgeE/Z+6GCWi0sYlaYMCxTV30W2hWpPh1IZxNIacq6geR1CuwoJRKIZtMYdE0fFgSyybVUZmev2gdZnFXmq7kslu0RT6MZlb2ihj35Ai3XyyvjJB5n2cd8mN0bMewIEHkcxY/zzLMPQd3W+pyLPQ7bAzGGQpw99GfcT0/rz6fN3o4Qfl4jZ3ogW7kgUnKzvcvkaS7NUkZSCZ+6uniO7M/ep2wM1xZEbsYlZPgVXaCTnIrQ6w6T9aZHV4ukdPgImWsBwGypyvtvsfoEeQddSDUz7CmX1NkPVA4GCBRrcyig9c58gDQeT7aWLhVYHbwxnP6vCYGYHIo63H1WM0W3lIsPhQz6cRyN+Kar0Vzt9LsrTQ/tJRggy35tYwjfBXkzfMqSAu0eIRzcST0SsWwS9bGoGO0m/a0rZb9JAAm1hwc5UuU8uUZ+QxG8nmq93/idbhN+Q+gGf0fRbh/L36lt73szUopIWdayP7iRnlheOv3iM6+rJG8bklK/zOvR3nmuxIU+q2OpcmsX+rIa0L/Tw66bzODE58xb5ml0f/T2MwychjSXVXX7tj8sJTHZJUt1bmVvdZOqkk7PACnxHDA+HkwmDTMPo2W6U108rJfUzOztfT/8bypzuk8yJYCHK2xBWqRn1gD/asQmkqop4IlyEQBtd9+g3zqmOnrAy+YZjjYsGQ/fqMzD+d8RkRyAFFuyM+uRZBYYE8XgW9TW/f2juZouqQCVR5RFVjvOmuS/SeQXe+V+kA3vKqYIJJrqGaTEugNZ5S1JsqI8rvH+c/cJcFz18QfElqthahV8D6DfvelaEHpUTNS5agIjVNfcqBpRoQEI0aAs89Nvk2tIqpUBtnziJ/2fNPDJj6qcgbpDwdqxnTC/4cecwI1DDHVY9bsLSp57re0N+VGiowvj+z9FiiJnhchFZbE2loiRaJlu1YSJTygZ+jJVYpGHlAT3jpg+EmNnMhwgt4rxxri0YFRUiXGgU0INIGTNEHtP1qjwC08WtQGW9s2impoxai3BN2rdxm3Tc26+2xhYM066esoBmpDdQbLiUS1bFQHlYt1dq5S26lOWV2LsBwKiIzhOTce9/qB7ipJHAMY585D9Q/Q2sij0ppNHpTQNStjLXcMAsy3iWnkwErkAiuRU/u2coW7LIyTGS3cKa1LKHDuyn9X9oALA4qGVUEeRt3S7m/fOxgKMmysD8qyjkpZbv9Jkc2+F2JACfzS3sGVbAcD02ZoiOe39xHz4qLOv8KBcXtpej+n9lHNylX6uPdH9hqXTzcDwh7jfIUIkjcsvCNSEQZXsdV34BipsL83Dy3/X5YBU1p/z4RcFsroyHCQfUikP7Hmo8hBoUyLCLhw1H4GY8CcqChrPMP4DDLYydJDhODWff/p7x/88PYX/bSHPQFS2bfhMPs5a32D+OVWsbbh3zakYJ17bA8svJGVl/PepjmHCpWvec7M5jF/5MBBlYcTPQ0wBnNU6vgemeqhnGw5XKUo+zUkFDpUsJfCk0Q0Vg+z7TZoMnMZ9TVWSD/P/yjPHRybiQdDreSj/lr2Xie0qdn9wu69FnUGFw0nai3CO/Z9+eGPv+yvTv0s20SLqshciJHuK3sm5u6LYJdlN8XcUXc6MVerHEx+WOQ+r/T8qUufKpCHvKvXNVBVyxd4442girR0QVzQO5JJ6bgmK1dIOG3YvtaPXkqeOrL54I0jq+PjuvK+b7zsa6rnS0c9V7yatf8dnFZbGuq2HXtLJFZuQZM9c0IQ4mNlQDDgFHDBDr4/7PmBnKHpLIPpWFSCk3YrDodhEqx2IwJRniAbvpFKbvhQ7odwSQr4KArIPoZfCjaGYMsrNh7L7TMTow19e/7HPtYfGjLwDhyx+XqmVxU/aj3lruvBkn49lQvyneysdJ00kDXSN1Lbvy9TEs7PZbEo3nfktGJtp8TqIf7J27G5H+irQoshWncYOaqeCv6yN03NRAGCgyxVMujX1OrDSK8QQYEqB+ibkMyKlFcjZUIll40NQv9DG2wJNEqVV9HEwz5L1FLtocJsSN7z8xGtDQrT+8JABfoVXPM0VbfpG97UgzMfJxKcRAjcwgFc8Rw9OrvLKwI9/TGy+Zs9TXiXZyXzh/HhgzWVBd/kWWGwByVhbbTCSLuBbw962e8BinI2lwfKMv0P8saQ8jz/BYCvllpxz2tO4yI9jQvZN6I4w7zKHPaBFOgBH4polSaeKKwczHmghzXtMXjNUW79ZeYgLNTVv6Wrf2yZVZVkx/zdT+np2E49s1pV2fYCP/Q8w3g4JgndX8PRhgT/DsGWO9aCoADFkTs/C3F+ZmT7Wi2istEobT+YJ3yCLo8euWl7dqG31UOztwIIE7G3TMZWiEuUPhyKF5JgCpaB4BwX0wKLacHxMC3cDNPCk8E0naMGv469WsEop78hPJRECr94P+ucvrAP5RpEtKxziuhZioIht8QvIsa9EvPCMczTT6LN8W7iQPiR4p1v8c5tkhzeYaP1Fod3/gjehY8Q73yKRvHOn8A7RE5gHtaTaeinU+3xRz8//YAfhHIkJIvnH2J88wBAO+bnoTw9VUhK8JKZ9TJWk74iFa6eqCfOV9aoy6/EsrnJJCufTD1cT1KyBR+7CJxNeQKpXr3W16GvWuawG6rQLaO6qjpDp+vZzeLnL1Hm7B63Up7DDbztzVqeiWC5YFKuhuSCV+FYsk7cfhxHJo8np/NHrx7jdF7tiVFbi7Wh7t4jsRll7ubI1v4WO310L86PMLtVuVD9EjmNAEZeRZERwq4q9e6k8uJc5Vtb5k/nLrLqhnGUF/Y3fo+5fhQXIkMorgKkHW9GnapQqRv9ACpOez1jTxJ8z23KXRO+t+qlvrs6Wqo8VV2c/QfUX9ND2tNrmTiHebVQs101lWgwwv3A2298Ru072jVkWSXfZNkpWfwyy+XYKwbpCwSugDvDEg/pN8LKmhdRaT0+VFkCxyMcIMoQH1wBM95qJJv0drTl6bei6ZmFHPkVDVKtCQVISA19GgVOYEeFuoXpXwbjugW7HbJNUx9ghTo0Rh3pKJIJDqjYDXGrCEncTh1pKJXiM+iY6nUB/Vldy44oZyCOqYw5UpKbmAityk1V3nbh3u9lPbwtlImZyCTKxAOgwcYAnJ7XM10qQHmGgq96gJytl5rL/XMheXyrJorgKftpvBhpRws0Vu6qYQeuMwwwtR42f0ZngZj2kfxFIqeda2gHJXIGqkblxQLbHaAh6lkHLlGct1bgqeo1FV7fu4Q/4wdy1QkFrslGTs/EfFXoVipnXAzKupimaGN/QZEGrftZsxHZ7bYai/zjJlgt+xMhBNumxWJKqpbf7hEvuI5F7WD4mLDcoeu5k9T8v54/3W0ug1uWL7TuV1XcK0tH6ZpiQ9czI2DTJVtnhruOXZUJcYZKQ38+9BrXTSCw86/mi7RO15WIkUZwzVxPUHlRsr9o6IlIMqLpW0DJHlcFZG458wpIDbmLxGFOxQQUN7/G1Q3FHDpAnr408AJVgcY1L+3HL+UisjutApkgkTGnVUpoZb/csPtCNFMVMOXAiNK+XASRL1E6+Wy7vKdyDX59rpAbMQLjUQpDbHmdmpzXLJgMB2lcfY2ilzIO+S8V9//BNTg9iVl0/gyPvLe/5kYca1fdQJUmslCvtXSBcnVGdovYbFSz3JOJDkwVzOUAl4jyAqNNlambxR4/wHLog/Sa5Grp3HYnQqf7O3HiLKFVlKFbbLPQ8c8T1rKfs9MxEw3XTDAFo6DtHpkJf/6ILiZ4Uy8meNWLCd6JLiZc92y9lDDi1K1OYf+ro/cRfv7GyfsI3r/5fYRfuHHqfQRv2n2EtyFvLR34fnxdqf6zuwSyw3Y5clLxsSK9TQx1KkSBvC1QpHgfM64eQBATNlyjUKZT/Rr26VzF3zo7sRQvD3Wg8XUUv/01z7ju1TcA33zFN1/xTR6k7lxW+eErviGk+CYhxTePlHBJth4/Sox7+7VP82rWZLNSBumDTA4j0nazBcdi/wcZV3n7jd+IxlV+8caTN67yS4qNPwXjKv8GuMgZ/hVxkT9R5b5Hiop/5UeYrB7+rt0ETF1FxgXlZX2l7bii7m4xQyTC0t817myRXG50wHJExi8x/EvyjOuuxd25E4AhOjEYpoOA19mNPHVulgPsWfgH9t7lhr04NHGaNupDMNhwOztOzlVVBaDC4KbWbkNet6dm3IMbuIvwLiRA4SiAKA/Ku+cBhbhtOAHqs6s+n/Aj6Kcueg0/QjV7xeJEHjNuHPOYER7fY8aveIEM8ZS7m7XTsTN5Bh36Wdg6/lm7CT+7VlPpb0gRtITM0YWHKj2NlMnHTSZfrQGx63kVzQKwkiOb9pn6/xv78l36ZfUSIXmP7h7Mr9w4fg/Gq96D8U7yHswrH43t6kfX4nff+G9nbXvUmYonfuBvHHOm8ss3TnemEqKVyfGMcY957AutMe5fgHMKgYfu1ZV11CNlX+m71yfeG+lKdWlP/NP2r5PJ9VJ++i+5xqw0/HPN/5v7xsR1KlXTpWoAuwglUrzv/79kXCxcga3T9sucCexyZgVyY6lPDK+XXqP5cTDyrsexsajgB06mvch34ibb1pIt2bV6m47Cdd82MgKejsCJLKY/CoL1yHLf7PtNp2VxzC/pUV/dRH7EXzNH+SSF1WWXnBhd64ZIfo7C4wV2bPi7rCeaXA0MjOqEQrFUjXoaE0AiT/JgCPSl0GrinBylVmSsMkTT2IqRnQM+ppA/TMDyZJ8R5oNLwmdFm0J+qJ5Fe0zPAoUVLW4firHrcfJSWTNCVUQOS/+n1SPXDyWRekqJ+M/Cxl3mdevBcbSOM/Kzv0VT9b7sqFumIsr+Dmkqs9uLvbC5g3sJn1MCbHrSH+MiXlGnekVl3JhO8Pftjn74vnO+duaZuJheymOnX8IQ0a1zIZZQHaq6LjMYpHUxB3Ck2NQGQOraQI317MffKFr05c19c8CfN6nO5ZSnjleCCynPaQdczx23UlPv2Wtp3++az91ap/odQ6pjb33EFFnRRG0eWc8TYEKkx5G4nAzkiHBuHpJ/gSjkhOaeaKiwBwMzojXxUNAXF+s713TiZQ9gMHQU4g1GkqgK7+jk4B1V4V0fgXedogl4RyLhZnhXDAI0RuDdrMA7sfBOJuDdwE2NUXhHFXhHgHdjqNVMhXfE8I7AUE2Bd4PhXecpK27MU7U4SIHThc6+qJDrf/Ec7AMU1dXMS/YlJBmjgrrR2CsCZXBRgGj1fBDTYN/4iaEum5wCj5pa5t+jTDURccxdQq8oU9ZUYB1nG5IUQqly8AZeFSU+uw2ZZOQ16V2qH2liHzhHPxMEMrlUMVJ7JvF9Pswuv9EEqxfJ/1m9yL/zK1I4p7PuNDk++OopCn4OAk6HMHY6hPGkDqFLl1TQy0dYCaMLZIn6wVF8oCcRAXfmQ/oqGy4Rp1vjJiLKg3Q4hACYYFZKx1QzhyKEgr4gCRlDNomLRVKFR2gOKsif0BcMuHG/rVgh7iORnUP8pGBUXzByssjv8vxpvjD6Xh6awyzLSuMlEff5KYKAjfT9N26c9JfxDep58A8em+dBuKg+ac+DzsLFNaFnbpg5Lix0xESVO5UnE7NAlQT1eYCazPaMV7XhgPBXw9HhkMmstZcVWolhdAIHJ0enDNj7t9Rx4N69LuTb3Csvj+0cfMCpEmkLjSHPm378uBc1I1wXV/N6hPAXKuFPO5ufUkqqJd5eKRGk7jDeNZsmCfdwS+WLt419MXBfSJJ+cWfli/eNfXGX+0KS9IsN+UK4WJlAfWlKSVNzaxxwMD0ahSpWVaNFRy56CXOCRdIn4j+WejfM5K+rWX1tT95secZ0ES6ZIXhQgy05UICjBpSuNkxD8X2SvCTP+mKWGcVIw/I56mDA5hEjPcgX1CxqUw88F9X5ChpfLCO+S8uISlAh8svJUf/LN0sQsfdrMOTgpzUo+KoWu9aERDkPUpjt/L5E/HdZzwIBBsditTQEQ+3iZAESrC1i8j5foYS6lB1YE+uVq/y3dRM7Y9vE0FdAeE43y060Pc+5ki4q4c7uoVW9duoTM3bSaNxKxTYQNqjFJlgCk2EUO5NqKJ1iWuEv5TZXjva5YwUK8FlO8szyPEVLlAewz2IHcfrDX/QK+Axo2ctT9lnsREXmqz3fYp/FKVx5cWqZ8Ov2WZyGhAgJe/la0Vcuts9iFxfE1ZCkXbHyve869jT7LE53aT9wdXDO67esP9U+izM0rTiTzuSQFq0Mn30WZ9nPKeIQHhJsfeQd73r/W/42f7p9Fmcj9uN7Dn3gr/75zqfZZ3GOfi4dfft33H7wua980wfss3gCoIyUw4u/u2Xg/fPT7bPYbVP+v//woaUDH/qPH7TP4ok25dnfhX8/fbF9Fk/SFMDoycQ9qjRYm3ztJ37/P1/4x599mn0W50pBn7/9zNd/7rP/+QP2WTzFVvGKr77ju/9i62893T6L82zKJ773Q9zQMz5on8X5NuVnHsxmZ2evv9g+iz025VJp6G980D6LC1yDI+Lx9gwC22dx5sPfzkj+Sa+48OHvKJ5K2+mpGIlTebB+j8vzTTb7LJ5qsj/8HflFFNGTCZ9F/Fmkn1XSTyVFTak6IiAiCdoRKZJRiVJUIhBZdMkpF3Sh6chBjArkBp7MMNNu8zRDSJUBQ2vysQEjDA+ZwSADejKAJgNWqgAxJ6ISZDurfScBWRUAEeUMAmQ6kzOdqZkq6dtAnkEUuyBTZwZUUbn2xHyokuncVxqd80Y+L0RcvAUUBxZatr5Yztax1VYtceywE01foLH4AqYtn8YFF9TCTQa1tUlPA6U51VgdLLZzT3nsLiIJXETbJOGwSdhGkSZEMOeoiy1t1TbwN5HQtEBWGyHn3AQuelsl+ss2OqKLMHgmGksCorm+U000rWIfuUpb4Qlzq/Mg0GTGuB/ykQI6GYJvxSlv8XQQYiHzFyPhrHwvHpT3aV5d5wjRfwbD7xn9OrxZXUzPOJDPl5Xn3bJ5+UrZgXyr7acuGE1Qduv2yq4x3CaaXxMoYK3pEz8A50VkzmOGcsJv6nI3lpXgaTDk/eLC5xOAohDzX4xJq+SjDB+WJasLhH4ErxBbaSwxM4nEQ16WszKei0wuOJzojiVyZAK8KPpYm9vSWp8K4MQiAL9oAE9NXsokV6wO8GHmVnY3Peqt0fIa1y+GbllPH0oCagXTB0eBkC4ruSh8J8QhNU+MEfYN8ynOplBPfCnMB3LluNqJqGcg/Rn0dGVAMyyUGc0icpYaiHRsSYUf2VvhebjZS1aBa1fxNJ4cut9q0gw2Gsa8ZI/mhaspVjSm4CZs5dHlh+ypEvEzsqAooJ6cdYraN8xnFMsVdGnB3JFkzJIbqvCBpm528lPlWcvP5EQxPoxCaEs/EgwqhOHJF3m4t9DKAeoqasmw8Qxcpdj5JtHhOlN4+UUwQMgIGYbxUhJV8KggToppm0QqItoksCqKpHRqHglZSAD5LQDylr6w8ephrk1dxDE3Z10NaT+7oCtlVwrTlUXtyha00jBzXQL4qRCQ2xbDRrvgSWHo/OLouxKQajtdGwu0pzBtXAALuEA6woK4oAlrxRI19E3PKUWDBWZCLSctu9nZG7ATMeqEvDmxu9jL5PoDGa0mHw0vcEtG92l64cyjwDjAzAPr/VIVXlTPwtyfSf8mjCJ4TcAF+qpJwkjr0gK1JnhULD0W6/7+mKeX4KIpPGlTJnNEeJJ5ZuZZ2Q6K5BZGNtUof4LLJyIDDkUaHMqmkIEI8w6hyHBTmsGjAwsTsNJTMzeOrBHbttk2tCSWGnBZLAYjcqHXDWpxDB77cVtYLbBKPWFZLKUsnkvtMeIM4Daju009ZozymX7i2tamGUqNZPnKot3jclEMB9LRtjlpH1oi3cjuKDoqIEgIR7/Zr4uwbPZIMbfvB2++eO0vn/A7JNelZrnMzoBmB0Oaozm+Cd/xZQwe8GRYAJqRS1IdPTTtlHI6iCSljDKGOkfWARR1w5OO3u4IarWrnz4c4HIhbG2JKDUWLYKM0uwjVj8PSOGpWITRCpcSA6uY5ZsdujMFmb7ID6be1/QVl/WaUYtfA2sgR8Mi5rAGcvSoC/azs9/Uq2hikDKPq5c3IooH6c8FrLyhu+GPju2Gj7rdsCTpbvjuyv7502NfHHNfaJJak5Iv+lIc1cyUyN4moj4s4B556u4I14ok6kGP+C0wbw/grWr6LVgHssrdVTeevQL5sYJIRTj41cqKuqg0yuA4CQqulIkvWdVBtF6REiByYugOzN3xx6v4yQ4UPuDrw6Ef5jwWzuvlRJDkZh8P8W/dqDfSBQzkmy66NiEgaTZv2UQouZPPVaECNUkWlbmNT/D0VxoJ9Fv5T643Rvw36cIFfcNVBh2gL4wN0L1ugCRJB+j+ypAedha3HjA5jmGhxEfn+Ud/QqKm69IGxzSVEL63En5Aw2jAR8pgcOgnEXSWWz94HXvO1zj56pZK+E4NQ1z5US0B7T6qsQgedsENCd5tIu4G26c9lq5hBuodj0MegphEsC2nL8CHchbBbLlaz7sgeBkFbqhaUH1+CQXGQOPVlftBBl895UXUUkzskLSoMzV+QV+GgSKDIAFGWqJwoSOgQC9IXIGg3qD4nqoxvyxvSMqnkZIhiJsiVnH+AcQmoiWoA6hbEWpoGi5Fq17t3apXy0dleYLH5VyszkZ/De97y7mIiIabi/By7/qbrMtcAgNTnYuJ5AfA8jqo01WiHhqPWB2rl7dMmsYrRUL+GX7tvZiYzj0lZmRkBPJNNyszHieZnTInUcdNI7PqoK/SzqYMBvRR0e9RoMDIukdNY1hegKtgAgB2Z78tpLOl7W+Xk3UG7a6j3S1VB1G4pBhu4ciVyCSbERl3qwNdEuHdjb4ucM0DJErhMyA4+NXeWXphFsdvfSX8vsig3VHEeO4pGkeKzuhqKAnENseHbq0CGsCmR4bbIRlek+FgMMCaN5SDNFwpQVMO+SRcE2EguS70VOmSuaThV1SZ1UqHAv3SCUPrax7uzWS/o7eLBMj46Q7Id3csZe5t3FH6hK5tuGNGdz2YcIK1cYe7ujkYVq4MD/gOqhdM6gTp4UhX9e5W3TRezT3ix4Je3cnyGI8ubP1QTbX2QiEUCxJaxWzT028R3kJfugZ9aTCSeir2UXSxajf8s34oFHv0+Ds5zpWEBgxtcbl4drHvwklsgqXwEn7EF9YuNl7+q1Y7VRc8rd4xCso7RvH4VfrYXqWPxSg8pcDGVISXU+8YBXK2NWKuM1gfitgCcDqXH0n/YobOHhAXHBInasIkUbAnAPuCZs6QWc+Sd0sQqvRnlSXsQkjth63qBy3UzXEZYyJA/IfotWxJ3cFl+sZEwDzLZsOtSZ7AWZQW6xphdo/YE5aVh6i2iXVpCM0bVEcL7cLHb55c/6sTcgxs4C4bOMoBLG038xML1O3y5E98fd6r6cE9eFYXu2O2hPtt4EH9FLOvDstqdv2imrbJ2iOjOPsjA4j+wVf5zqMdb5sRoc0+l49sSfudp2Kb2b23+H218t7m96zyPsPvoXsXTjqyWqR6ttA/SPmcO0NFMuMtmDJOgdMF5C/mqQHHqYUvxuyoSSnOnz+O1muf9LuATIYW3tplHiC3nJjisT9f0DOMgGaU8rbxWFQ6vCRFy4a/S03Zpfu0jF07LeG3SLBN3SLb7EWJWDGiyx717HYVpjAk3wohtYyG2COw0o9FPFjMgscSLeOxTFvw2EJdiGC6tAA6SPM0hz/WQ56F2qZHgbpnV04DZWl/FrU/gTQ5MDo83ErlH0Asxf5KfGVPbQIFmMKaQi6F7DKziMeitUayhPm9ZAQxB9XuIw/eFXDgM4ehyudIB8vK6zrlvZXOxL0VbMrK5Jlpye0yuT0tuVUmt6Ylp2VyOpFMTQ2XuJP9gZrFrfOEd2pH7/fkgDUcOWD13AGrqrkpWxCQtyGCDqPpHUHiAYCO7BWxxTXUMsCNp0BNd4QbR0yeBTawUq+e1ZbutzFSVLentbxeOafHnj2g9YUNzX4XnRmk14rdAmkOPvIYbTxBG09Pdqv9GKftNiKpUHB3NByYAqoW0MrrV7IApC/2vKkLaA0UOWT0ych7kWuT2CN3Wu66Sup62bX3NuHrjT8iXxfJj40vktd44fTDaYyHHroypeQAwuTrE6fyB4h/BK4HisBqI+hxPc+4UN+z35P6YnTewDv9StPrlRqQ56py+R5OwuR7rppwXi0gGc3romEr93Fho7P/Q+Sr+bqDX4VifJ4CVczVPr3xV7TVM20Ljo+LDrZz2f58Vn1IRNTh4jDh2tTZD0XseQpBByCX/VrtMpE/h6qkvgRGe1k11btcLXVFaL6FYt2ErlCkFfZExc9dMixW9xcZV5Dx8Gwl/wBqxNGF9KHYzl3E5FK9iDqxmG3tAGRBeGG6iReQd9C1WDjk7LnQEtxO3ctWSsFRJs9MSCC3NLaG+LZRh1ZoFQ3kZw/P7PcNHWeYqAe8Om05IC1FMkqbo62UoF7qQOjLbfcoe4JXQzrvB8BAt/uh1utrtR6qbRmCBWCj6NmyaJosen7zoq91RTtqiXIF+G0CUyuDgiHJFCYcAyD7+1VbZVHNF3kCxkwAGueZVLgy2oUVPFYoQz2ZcQBV19HIMLYKurpqjyRoVEINoEqDmvxN3jTHzdDh0a99HdJRrPUfGdZmE1jbBtZG1Aa2ZhVsbX+dsdX/t8XWY48OW3f5U7E1fOzYiqKnYWv4jYit4ebYqqT3Us97hRPBgyZ7bjYWEWoOCQ97Ey0wKuTodujk81NLAqSmlhQet6TfDTx/8mqwAvTmQHa9elHglqC67dUMh6oZbhrJAL1LmJFQA7Qta1oCse+aGnvn1NhbKrFH3YWuG71KxYe8yZa9rJJ+7WTygUry1ZPJV1SSr5pMfrbzm+Aid1W+OWvym9VKMk0mtyrJ2WRyrZIcjoLZibT51nZgVevc1iT7hLrpodrz257hK/QoI3IquHJoUVrKYOVeZ1M5MDaV+SPVSxVW6d3NCCdCYNZGrB/FlmkSv9SlO1aVQFevwquzqGHegJKzMxlN9bam5I1KdJMc30cQfP/4J0+9Pz1n9ulst48PXPYYbdVG1ZgHiDusgRbt7E+s1QnsRDFdGlVrajNVB25qe3HEmlo+U5Es6EkIZ3Na1kWmQ9OR2b6R/cxB2Zzq1TXYg0OtiWI49tPG8czbAUt7wW1WihD1iblKt8UPpy8niPNaIAMRwENnWPCVpxSrNQM4ZOK6YI+Yc2P7QLNaz58KY5037XI6D5I0b6rVxQD5EJFUTn5Ki6nHxNMxsvQ3rG+eOpA0ljIwO2U5vVNN34iUdq9w26v2QwyNtHdILbLDkWoPOlTXr6H78b+Qgo0VtsoD/qjDOv7VsUqpWRmrJvH7yFiZ4NGLBhg3acqYMAfrdV1ZX3FzdVkPq0Avn69KeeTUkYUssKcALJaz+IDqbl90rCKZ0xG3RvkP/uD/V3/nM9aHfEaIfQUl+Szu7eoA9ev5rDn+6lu7vvAuU1fcvITmNyDV0lWmbrWrm04IKBiIYgWumJUNsS59ZiCNpfnsf+sarod/LfxkBapCKJE7BVTnVUA3WHk9RVbMOulxTTOIM853wZ6hwSIu989QrmpRJ3hwVmRsYXWpASMuKbtCCbz+xHrTcaQzWkAx2r1YrwTH2Veul/fASTXRXV9tOhegDMHYkA5VP5SPbr4HF1L0fOC4w5SnY0XQjAtjbo+MYVBxtAgToc0Jwey+vYynrsFAyibsiaJpgI+zpDTD+JFef3rLN/rPCUvtWmKyJXp5VJptKep5gv0923jbe40V41UIpMJDeuBOExyQmtWdfqqXN5sMD5zjYov8nLYH12/Bmlx6QUW+BNsUqTpPE6feMfGjo2IG6NpmCHoSnDXfQHKiJSE4L5B7eEG1TfJFNMg0SSgbQpeD6cCU9bSmJeaZcUbwUADPzNQVjlkvHaTZXwqNWDSdQhlbxAD4pdz+RdhZyS61cc/juBQKSs9FmvJdM1oFa6p2qUP8WCkXRHPRnGv08Xdpz3p/1T5qp7N3vXosL+ZsjwO9ygezlJmMXTipC4+qvGxFXvZKuAvgdmkFjxXyIR/jlpa+b8GobkF5WJabcgiC0Cr0haE01lSCZeCTb1WrwtvwUIUaCvZO9RaYsxbFXQHVCYGBDRy2gYM28IBvAvfawDEbOOrTKhHAWKzlO7iunTyiW+VOGV76vmiX7cxPoWa+k3bQKf26KCVt4xAQSbV+TqXtZIKn9T3o3eAzxRxOKCBqhFCSYasKYTmd5pSABNmQD9NK8uV0aiW5CwUbBi6WSoCZKSpaAscNzbI5zc2ao4aZ4VN4XvTFihO3Z+5EbUE7uNCmtoWhhOxbn2N2KTtpK7YjrGdZtm7niVv39QNWquhOPMI7Df6bwW5qrXlXS+XvvLzHbdlhIUVdVAHIrVVVs3byu2nl3FhSD/WfwmX3qM2ToWUAdQoARf3WpRwmbFOImohaZGqFOb6BO4WVu3S3MZnZBSfLgF8Hj1OozjDb8PLTNeDnZwR7FdFKmNAZCiIET9eggSrtogVaNhCtgKuJDXPTaOb0Z6Q0hVazWKkOmgLODdxoxTx5TxNYuRrxUuTVgdN8p1KuOTdrBa0oecPQaTWCCmVd8i3IzikS62LGy+lxAOA7RZ6n0LI8l0WGrgQKuLHIwcDSqlr/EDc+AO21FrU47uZABA83BbodBN0yaaFyfKLJ5Kh4alajRqobzPxM/TA/i7NhfSrO5lzTVyhwlHlGZ5UL1Tl0JvHjCW6hWnUL1ZZNFiogExYq8nOSxWr2OItVgzwlgZ3JxWoGadhMmMVqttLNmXKxmiUyi9WMW6yIZp+LNB3Nc4jKxeoJ44tVRqksQIS/4y9WLu+0xWoLrWpGXZ3yvFy0+ECQMQk4p6tX7iImlzACReP2jyxhM5NL2NLIEnbu6BK2S5ewVVnCiq/rErZEBYC7+H/5EvbNJWzRLWGL/yZLWKFLWIElrJAlDJMfS9jMRrGbdk8sYedQB/B7Ah6VJeybS5ijPxNrmUs6+UWNsKgRGWHHLAcDBIVc503dAB9337T5kuTWohldizoUkaxMsa5M/8dvoU7RLRQ/VugcPBhh8Tjl8dhQ7eTAzqkbqhW5cJBTz65RXUTYqzan6BpGOSIm16geHowHeJzyzU3XN1esr8eK9c1N1zl47KQn4LHj3+X6tRfVyAKFRhmStdO82uo1TTFIX6qkbEeZu5LTETate9rqthNP0AB57jj+Fg5Bo3mZHolCzzj2HT/3c671kr6E4XyqNNJc4xdVvct9eYepnERPXgPQRjVTjRBs24tSnlq9D8SKdGLUj0PiZBxN3FMpqwhQGpE8usZYIVvbUOGmPUNT7RfR7FWVuSI+UtTHVX9hStofDGABqM4XYXw5gkJZXqkMnMe8FkDS6/Hf08tom7OXx+4ujt/yXFZcrXAqRLCUM5pRqq7Y6DnC9SMyHvW8iO4Qw/P5xjd1CewAQP7jESAjjgrplmi6pVWIKOwMRIKThkjtpCFS+/pAxJ1bTgIn3QnRwtfEdeA9yFLA946eoX3JmrhOv51Vq939M8E7tbaXewZb9XoYDvoDq4xu9QL1WLx6EH59EPjwdV0xMBpqA/UgL1JNr7NUk3oXRf2vbYeCWuulekiBpqiHH49tpQTwHe44yhhG2z244ynZptA4pMj+XM5n6zJK9St7yEueKL9ZHZcQ2qo+sTW/VyNrolZWE7RKTewHKC6T4vb3B8ELKcx+Bmcp0mjMPH6oSVapVu3U+5zrl41tn0iwSJVWffQBYCo80jAgGeulQRzW8GtRv7JglAgIzeYAx5oP9FBLPylr1QN9bUsmTc3eiZrRtdKgc5z+VBjqEHhWlflYUN7tgZqiA2hEzv7URKCWfUB9UPQPFk49uA714IK1g7knYu41qpx6q5EucxuPs8mCIxStv8tpQwfQhubbMJsoUMulGgRusYE7OYBjsGspgHb0jZ7ax37QPO/W5OAonlXt6A1bwDEbuNd88gCeB512NIak1Fy30+wKnOgTMoZqhbsOTUV0hcTJgvjrIl+J+Qq/iTKBOJ2AVAaFBv1OecMm49BHg9LN191BZRxAhzATeB4UNWdXCrC6O1jTOkPFcZBsikDEMHxVv7nI5vRZnZ5rwAjg/OAMFiI42cqu2+48Lh0MnM6B53QOPKtzUFUtSMBfqR9GSq1X6hT0IBV9HV1nG1Vnr2LZM5Z1PMZpsZo+9NV+INTRjTM40ettM5C5bmc5eQY7CmpJW9SlWpGqmaW0FKC21iSDJttYdGRGbdG2JTlPcJb4gC/7xw4H79VghsbVoMwsRGFOtyrz0sx8QQnXogJmiWKZjXiIu/GWhDCgiYRaoAtqvJ7fU90dUbk/Ql/4fY74rzRhk+L+cmpN2Ki/9zlmzFQR3VwXj6dMlxVjDQDP2pT0Xr5KvPWCuhbKTGCxpssDJUzyktoPo6a1WFOneikc4EaNcZEpLfOXVv130dzYQZP1VjlXhWeWb51msWYbbaVVKMpvp+1TLNbQdIs1OSwIFFMs1uxAwvYpFmt2Gssh26dYrDnFpU1YrDlV04rTsCtB0ZMWa3bZz2EMQx4SnLRYczpiJyzWnHE8izVnbmqx5qxNLdacvanFmnOc7ZInEPfINVibPGmxZvd0izVP3NRizZM2tVjz5E0t1py7qcWap7gGn0bFFIs157EFlRWYXzmfLatspx5tx0gUdN50izV7kF0Nrmzn7j+B8Nlp/Nlp+lklvSBFTVTNWQmQErRbpR0aaVCKE08pQxZdttJWDnEmixyKP3jIf6fznxt4MsNMZ5mnGUKqDBhas9UVov/tnmLehgygyYCVKkDkDlEJMqr2fVVAVgXAaVzdNkKm8zjTeZqpkr4iS8GCmC2kBWaNxy3WGJqaN5Wg5jD0Vxdn8QugOAmltEUs1qSjlmlqmr5AY/F17LUvgBINZXmNOur3ly4Q6bDQmHv9ogd7NAVjswS204okPGASVug0TTgtNbyt1rRFmqFbzJ5pnL6dR76Q7IImSz7PFKmB09xtt1Q4PlsqMaqZyz6IbxFHFbRSieoi6jTgbhm1E1ErVIyJ4LZA+LKF5qy+b9uYv0mFX1WVLRZTXliuFE9Fwln5Eh4k9kcu4t5cBKM3GT2VLjqQ+1JdvigNyZelifkW6UHewTqDxcAZudFVaElMx2j/8gVqEz8usJYpcrhRq6mUAGJXWTwugPlSiLBieHAGbHm+dpwga2xNwUcZQ24LjSVmJpFogcpylsdzkcm1m4tYHEvkSNxCl0s1NZqV1jZJPaEBvIkBL3Vh5KaumCx9mYelCTFyk61x5ZRaCzc1I5xqVi3cbDcWbmrEIcHgJgaxadzDGAs3XVi4wcPH+KaIugjpF9GFyry1yDOGFhp6xSkpUjnrLRW8+gdLNq7h7Kza+UcN9SWvjFb/x2FpVVOMqdXYprzWGU3lb9VgKuBoFVP/JvCdJhXEGnWrzqyaYzB8oc7l1R66Xj36KFiZtIxoSez+fuuFRaIbsQYl1GCe5z53wRoprQOcBPYIhqrhd6gJds+DaN1jhIfzKrlf/YP7cR/KcaItNZcJTtBXnUyPEmleIUz2oLy+9MEBuH+jUpp9Vm9kp1RHJZt/4I98QK0j4sW7/0rcjmuIImJ2h0Cu2ng0PX1O6Rwob4iOHxQz87Tqd9vLfZkzvsOskBJuijEnA9CaugKbggu31mBgAySoASSqOwmAt1G0KuaGbfgu9oTcGg4pvHUod483Kh6SAxYT/HdWXcewYTN0Fya/6sGr+X3dX/APhXKBLDIWWThBbIfzA22z9mHUqfGweueeatmtsku9LrRmJ5Qn56+zHxW7yQGH3iwhryKKaJkLdWBT0SQdqmgIiCAUD49IteITnJPj4aDSDOVTq6KJH4m8xF1Mc/sdbCm/ZzMPBXoze/2hAGDg/d93cgQ/nqePy63IolTODizQ92Lfg9vMOBRS1U5YcsF3ZRYpWBVoL+2h7Ljcvl4MVxEiJdgj9zUhaGlIPXlTdxdihDhb09WzcJtJkVU1zTV7KIdzLXmgbklQojn/SpCMUW5R3Z4ccWPa3OQ2ryyJihwT4mSoYuo5GGwGlEqxRZM8OQiroZtyEOaRxD3vuehzQ/Ras/8FuqCXJT0GdEpJzv1VkDWVAGP3aPc/TnaK7vHnGCQJuhQt+P6qim5WNCVJlXSRU31kMiiwM9MIaoqmLuANJ0Lqj4EiXiRxh/VFRVNNFjWzv0ObTYPxLZqsReg5Z0K2mtoUXeAKigiEKiMMWl3eWrwp9GEVatIeFBm7zzGp2ak6xsk4luRwCNdsoRmJBsAve+i/Uu+UXssH7BulX8NqMo9QY8SkdcOZtG5MmrR26ZKKwUIDZImy/2mLEoFctRlqmj8kjgfqhymuRbtGVTLrBPE4ync62JL810iGanv2eYSYFYVPcDQfBq2P1oB7EUQ/ezYzjhXsoojw7Jpnguv5MhMaa3KLlp/Z56R0agDojf4eEVudi2xcoebB6I5a6+bcL0Pua3X55tnvK8IlrtfVLgMA+qkzml012uTX0n85q1VXyd21dUYMIEdzVK05yOU286t90WsO9FN4DGTbR3JlPlaZiY4JxUC7vFG9AlLHrRAzii2V8kxTg/aMrrj7tI3e8YdynN8GirEPLhGjvVrP8WfQshs13BFLuJ2X7M8zxL7K1yN7hG/Q8Jzm1kN7Wwopk9nmA3wwqnKBrZEvo0WmTepBwxKxOmduif3Hosv8sqFhMeSpTMNWkMbtbBvitWx6hTJWDO3yaJmWQLs0zh7i82XA5yKNK8E2RKpYy2M3N+BKUGjjEv4qh+/aQ+00zuvHcmMZUXLgPpmjWZMxFrubXEDRk+2Hvr5KX50pgRggjmkJXCy31B7J17HDWEGxFgUQVTmSF3LUVfjIkbynR/Je9Ug+mCZHwpH8q8GLIDQoQ4fL0MEy9MCNNnRvGTpWhnjI7dF8viaWJXdUj+Z39H1Zp3bgTDffQYU5bT7FnjbX3Wlz3R3NG69bBo2o7owhnmI3D72R42bFPao7oVdv5Lw5VpODmWwL1OQg2oLD+XrZoPpmDcJ9Iw/Ygr0L5JUnbtD8CduiZh/r2haGE7KXh/M79HC+4ATbuh0nbt3XE1ypmQKU41jVzAoz5HVTcx5ryWrl9hRsvy28VKYI+I2cw+/gd9PU+bGkU9CGnVz6KdTJE5ox4NpZHtHX7RE9toCY9ljtVzYgnZ04os+oCygGOIS/wc9P19CNch6vuOZgogfy6BK6Wzen8g64tIsWaYsB7IjKQ8bwdMfyplAppEhGRk/B54ZwtAWg+qcpwFyteCss0XDt09ynUk/zb9YcMWJnkE1rE9TQKl3xSqS0ZBfpSNV4qfbUfQueYqA9sRQs5SFRg51KzDwoSmORqShKe6Io7YmitDemKJ0KrzwUG1uOzLfNetXkZFWUxlMVpVG4Kkor1HUNc+tZhzyoSi+LelqHR0NVpfnxhNF1DI/VyhI2rwWa5QzoNbKczR5nOWva5SybXM66ZjlrlprSrp/dcjmbLZezbnU5c5rSdTpHqxBbJE8gfiSVdW2Z2tPXNemzW9JcRixpjBx0SiX3Ks1pRrug5T2zuPGnVd3DhHouorK2JXgkdombHVniupNL3MrIEnfu6BK3S5e41RMucQ+8qly6ytCxMnRUQye1FK58HZc4bsfJ0WxuyDeXuK8juFKdEnaJc6ubVprHWui/xeo2q6tbdzOV6QwAfAIeO8ulTRe5l7klTpvvljhH/XWJ034+iiXuhmlLnBs9V/nk6oYKp65uaNpjX91MlZN0aqdb/aamj5Q/oV02ut45HWpjoFoIubtEfJxNl65W03dcbpnKdJk6hwJdrf5v2YFBjTpW/enE6E8/PjuynRzYOXVHdopdwCg2+oZjWzNKXLwi5LR1TJWov647tm/u2L65Y/vmju0cPKBN3UUnvrl/U/1q1IaBwDLkqsWbxaGqRvX4vs5l3DmZcWKvh9o30a4+7r4Pwc058xtKElWGjpUhBq4sT9gtFgv95LlCmebHriIFjLOJgKIOjyEVZkSBmvBDPR/EeLThW0A9H+CwrwJaDqgJGMTSAmY0VDWxy5GpPU8LmNoBzYOya41lier0wFqaMWZkFkzvKb0AxZhm8XxIxloJkS63QEq7skigMtpGhBbpWql9yPU0Rc4PKKIF8AP8Pnu983hhlXPT9Dc9z79WTQBlX7hRVUV9a7RFtT+CUe0PX1yqQ18Vwt5j/3T9oRoAmP0NvibPnWNClV59/wp8QjH+tZFH6h+n+q2b1c5EiLpbzWOtLEArRP1uOKV0Yr8dXlX52Lk+8KzvmT71f+nGg2Jd/w3Xi9xf47N/0FOAioP6H4Fngwk/CpYZUuAG1hUljrojRgablJDGhZeZuIhfD/ThuhzH3lfz25rxP6ku6qvuJ1ui3P3Jn//Ez/MJty+GL72XqDdt4nPY/ieQwpH8+ESNTVWqy8bsY2KhWLzWBCdbZ2jqTERtv6J4yUqhXv8lL+QC1F+BfBdRUPrKlGrUn2xyvvkKauOiIelMenooWx6hPJCW/R5auqInopGocyINdVlNAudmopNmv6N+L1/jsWXT4NoJ86K+nBCLxoA62WbsquiNq8o4xVjHcKpm/e1H2S3g8sDz4Uw5g2o/At3hEXTMKZCnI274g/RJnvdK8k5XT/5ioUfgJp33+c1Cyytdu6av9axbec8c01xubBIzlQASM1HxMDuwcjAskRhvULQu6ueiOGoV8aWbcjIYaD9kSkRXFgEsvIYEv+drwKVeERo7hb5+z91I31M6b1fNdKPFH5h3IIqYt/PsFRT4V+RyI+CHIS5wdePp4GHiGZNq+uDhQtnqF0YrQEmxHlmTXj6RaOBJaKpPKRLXN6F8JSB3pSILF5ze6I2Y2XP+KozfyNAYgdXpZ60Y7pQG4EUUeuUR4iANCJrgwW1VVMW8aGGJrLPWDFCj7/0AoBY4LYswvTkO4dgUWtSO0MQmOYZezK7+nuzNRl3+07+vdy3UwndI9U3U3rvGgPcuqqOITA2E7cRDVMfJqkZEYqcWxrGpAY0MaLJEfdYdv+IaqE5bY3EUIlfEkETIeISN3Dl1pPa8VdVbS65r2av46QJhbCXZmwELic41Sy43LeQWxKqEiEPoAo+sJwxrzZ6fUh1Vyt1ZPaunIsXwoBdAA6cbrZseLF27qJHdjjqLiJC5aFIEjTdsF7UVUlAO5QF+5Sqknuyn8M1Kubw2RO/I9amIUEe5+6JIOzatKymCaru/TM7K5JYCGbhmNSuAN/XsLWobAvXWJYes7GZINCqRuyHlJ5yn/CrEV4r8FlQ+DJwqzItQO1FXJfLn6oiBDgDU1EB7AB/jXx/I0wAc4PEqsoVyE6R2BGUmYuDlFliGy2N4tGBWG3ekMgUkml2ZkOKshluFqRm7tfLZTN50pvv26oCSQAnrEbgrgaNwf0oWBYt+viOWvxxGoPM4CY/shD8clzPe3BPyL6vKSkKNnfCCDEYEWNsHYPGW3IopHd2asz7cK2TwYA/QXk8wzIjqGhVy58dZxObkw/9skofDwnl3p2Tff/r7Bz+8/UU/LZ4my5cre+tFhJihc1Rxx4Djhm4HI8lH7hg6VtMgaNA/FK/BiNxHvsR1Zl/R6xJ8fhGLDgb5VQ8X3bP3sQp8o7Ta/by960apKnQuDLlAKHg11CEYSL565hIQWZ4YjGab2rKmQPgknR241nEhsgqwP6YvebgT0AK+tRRxHfCr5Ymx+QQdpQQXV8ZKYiKAVmCJWUc9DU4A3uodg/4uyQT3LPGY0buAsUIREAss7HYy1qiq2AtuHeJxxRHBR2VoILSwTqr7oPtwyf3KNaz1cNmSC7YO8rAcGvXDkgvLQB6Uz/heoFdaQ/etmlkAWVigltjTX62sUkdrI9Zg3a2Ydq1U4PTJE/Um1d+UU6f+p14HDhXxRnvTYwqkSfcjSfU3ZWEsyyy/P3dNsyPVOM33JVp1PdHJ0gipV1FB+bgXqIretCXWVz4cWpCBMnF24WTISBue/7GP9SnIXi10O6SwjLyqVziQkgte1WNZYZS9Bh/I2h31P3jj06DxGZJ/lXWxF3F0/NI1DFqZ1+b0JKehTSHapsxnZcFO768HdaEkVNsooOdZtWVpxZoYUW7k7uiH7zvna2eeeWX10pNrelBpuhAXd0cTfHHIo1rpJwXruG86xE1SWxa54FU9dqzj2kLxukK4iG2Wo0P1Hwi2lcvZ92T59/e4HEqB0/Tkeu64lepDrUZK+37kuMNRpxBWGClh7DVFDl0763yVNEoBfQBCVSu5IxyhzgMITu2rReW8rApB8QpvE4g+/pCEHIshmThIJiOQTCuQrFtI1icgCeStnwCSCZP9EUg2GJaAX0r1KfBLHPwAN/JyJmfYrTXJgg+aYSkneKluDqHkDFI0ClXcmWDWnmpM8wxcvwlXaJQKZAu/B8rL7xwQCHqX6cQHNytcw4bne44ppwr1UrdN3gbIUgWqRrQQOvJWUqd7P4glL9O9RVJe4GxJaFUv/4K8vlYIkk9BuT10tNAnv0oDfdc3vzJMb34oSK/bZF/j9WF4nh/sFasIe/CD0b+6z3jQu6bwtDW+zXI9Z/FcFq93DRouHgPfKkZodWsDMcHr0OgqjfxxQM6fBjl1wKQAVGA4ECyUl1kzKTx7vaHOAVh008d7X83NpbB8uapnUCZ0MBOCvwFGqTI4dwzTc2pGIHVI1hTsGKRP5J/uy6bbf4Y++hik9DyGIj7IbhIs9bN/VJPVymAKPI0jRPRrDUqYuAL/nz1fN+b/HxM6CTQZs3T7/xJkAYZ1UkSwrn4BiZPZ3QXSGpVsoBWNNVl7WF7xT6i5lnZq/SFkTdnXdLmd48KyjwqQk+wtAvr/5XvRpIxJuvHP7qZETVqmAifpyogWb+C0eINJLV6XLqmYNCddPHrVWcv+BVntnr6WPaSvUAIPZD/RVy39QLac2M9F2M8RWCqhW4Fk1m0/dHfV6aVelUdcIOq1eITYuIh/KoDSw3fwHCA33rlZ70OzKFLnZMieB/zU/YnTq/UdZv9XDC6aIA3wtQ+B1Em+zPuHpTOmO56gmHsV7ga7quo2BrggiJemF3Dx/a5BB7//VrvZ93Wz72NWfE2x0IkzAsgy9mK/BLeSGIqvIgvIm3ZaBkIy+8pqWRxDSiKNSNIXGLQl9AYPfCTQDBWeYITAUksfEMHxCDO4pImyAxfYKkuHbNK20XrSb+WW9jPTR25SRY6nNaEAhIA9ujdWJKKgsvML0z8LwsZ1sbBiTm7ilXYJwExLUQpbfjv4eStGMa0KEMUoqO4pJYPeVwnl0rVy65Cf8b7gH7BNk/Mq3dDBpUlutb8bkunM4PCNTBjzJnHwltcjaATnLarj0RbhXrCLvOrFDIIcf5jD1UnztmHeqZqa93BHJw/5mbno1AV1z9WhbKNoD8GvejRDCNVQ2hA1Yi/g8YP4Lv/1RpJO3CIPgYzaRyjgj9cvQDvwySzid+WpZujS7BFqrxdtlkJhFOWiDr/otgfOK3TXFlKzwl00xXdNkfWfhonkbhl50HD/85pE+rIps9IFsynznOWJWrrIP24K1LI/kRm4dVpsv2vI31M8b8JxhjqtaDmfFTfoob2b1WfzV3ZXJ6itUl8yNw4wi5nLMlWkrRq5Ct/ph+LWS5Y7t0fLmXqr97Rn3P7564/e/dqvvPmrPPSl303d4SnPoYJuFZXbnbM50AYeqyRV73SJA1eq8xM4+TUjOhgAKx8qX6IjeP+SeV9319AKvdCmV+cgkXHnHTomIQcwlnV5wk8AXZr71tGYLyME6o9W8qBW2xaURRsjJKiEA8lYFZAtp3cHochjHNCO+W6twi6ggkyhEbf7gsliT0Wg4FUBEJLnuqw3udT4iTnKoTH+NwK9UhZMqeoblNeQyP6GnJbJ/TFXcYEOUsjXlG3RG1p0LOxi9bipDJizoP0Fg0wkPUVwpAjXjc/EcDhcN0wjd5M8yNRr2luVPOvX2l+IzcQbeH1KNZ6TIxXJkSJYl1s6EQWVGrC2omIWmEByhhPdMSCdkMPyeZwcixUxS/WLQH//MaN/qOifCPojJM5XdRbouObJ6GwIytmQ4JWJd6fE/hrQnuLKoV/REMQT48HN42G+PY2tK+ar4HcM8xvTMB9FG8xHJRxoTMP83Yan1Muq3hoYKqz0Hl+/6SGae4VNW9DL3in05T7fCyoULXT8HPiN7KZXT2G6VAobjfB0kePpokmezqUjVXm6R1IF7kl21iT7G5Fd8QrWkX5YXpVdI9/xdhEu+X4AXzu2LtJ8QcnWQYsLWGzYukjZugj1K+sxha3zuVW/LuUG5pBCDEXxk/xRti50C8DP+CFMr+EM5jGhMbBWEBkB2R0eMfh8fFyOp+MyEAsn02C1lLqG0wm3GpyJTwp9w00Id1gS7hDoG05D33s9P3zMK50crY1DgPOrkFx7GoNln9ZT1ArCFWoP9XruWA+jaT1EkaaHKJwD0bQevtXzwgqHHyomR3ZXoYYT1DEzBGkhuu6brQrieI+ntzl9zOUYoUiIfZD9iEwFu9EpdwYBXoHOYHPl6nh1Z6BssB64uH3CPvDQx2qWie4ftfxQqBsF+LVEC7TR2Y+qVMFwtoD1xJbh8Kv/HWwZPhEFbWHW3IYhcAQV5+ChVu7rOEuPcSZunDVjLvcX1gSNTUzMMeQuE9fgqd8k1TnpLEnaSXVzIGmSIEjZo+X0tx0wkQ2Rg5CXPQzyhW1EP3OvKb+GWhE05Pz+duK/y3qaLAw9Tj3Vm/HbnVc2PVQUGx4zJcmPkHNGbejrZ8gphyYd5gc2UZ3BbMRZEecpkwmZj4zk0UmYqY0sjwJ1sCse2CDgOQtutd332RGrT6AGx35SZwk+gQ8luALmMJw8elKQo1+WA5AqaQ4ZzIR+0FPbVw5aYvoC5cyhh/kcuCy3jcoCuYRNHqx0INcseTz8B2hmrR8zTDzYVdhzzRplZUcHNKd6HmP2CrIKk4nFqKrz0UaWNs0gasaobQM8gAzgYizyBZQaeaCLaapQLCtjJjZKR8c3StumxYJo6MZl9/SdEpZxbJayHx/fJN1hNU7Y7JcC1MNMvKjq+U6Tz6ok755MpkryzsnkhUpydzI5qSS3qskpx1b69wnPi641ijMVfhyaOL7yl1VnxdUzOhcbq8dkwfvKuKqOQ63EBWHLQeXjIT/k/L+y1xgOj1B9vQgHeSzsCAUTGeRT5MpjisCdm7UzxtFmHjt/yGn6Ls8Lr1XHZBkIlZMv63FV2ae9oxPXQIJzmEMW0FF+DHEWyS/usyJCeyo7MMmumYe8tVDjNNghuBzcbO4F0oR6Ejf9NhORQJT+FS+GcVu11xGBA67BKior0V0x6ksR/Q74cX9tbWRMoLDsXvWQHQYRIOMtkoqllWR9WMj5lig0NeSsWeoRh9d5c8y2ZJ3qAxHjpBTmLQZ4m4tuUUuZsfaGsbpD8doGF5yQFijyFTS1RW3so9qUqg9XMHLP4tgmD1rrmTJg/00XyRqBCPRZm8miHzrtVElC0aiKZMOpSdBjExqnCv1qBAE6HVpUirL6Xvo3/skrFaKOCaXCIuRYp1TItZ1AjRAV+FaN0P/Bihrh1/ifx5EP8rPu1AjveLVTI3S1PCLFwf2Pv8rg4NXTVAYB7OzIqydVBoeIq6X/s+qO3OmDPuNtP/2nD9/8lXu/+lTMS98o+20MC16duk7WICG17ujIB19xYWmZzHmBbZg9APktljN3ouE9vhoxtwJrJvoBPLXI2RVYFMGabPuUb1CbKKFmMfyzFVthPbYho2wVUoT8wv9e2svWEdnfZdg4r/+gXZs8ZVo90hOZDKHT/db5/gJCLISEcLLSsEDmACBqexqYnpqjG5WXt6h6+CCFq2DP13Onmls7KpBOnw84b2K/RyeVMFQhMMcYC/Wyn9MOg612eCSV2BlceJXTHV1+SVuf/Xxlh23GVG1eeVbmyB/0lY5Y1txqXfmqgjd2zuLDmIhPhu/QSnF69OD1ldOj9+VRIi4PGy9XnEYPxN7uwQUxCBJbrOizL8fBrWwmXGQDfdmF3CzvHHOhSRJx++0IpvrFXWNfvNV9cZf74m0IYgc7aKrI8WAs98kSbGojCTbMegeoV6X6stgEYoTfXNuOEXtwri+NoyZbn1tDiXNr2duQDnRS3MwZRht5SzfOon3QBAJnv4DEabwvtQZDNcaWcH5rxyoDgK2iGKXgV9v88NQA3Az/dbhoaQGlyqkXmTCx+Ehrp45RmSq80kI4OArkQFmX4OK5uMbucwAHFGH1+KDWClK4I/fT8Xgv7QvIqZ59WXvfh+0wRCEgaUVTOO9m9jZ0HOWIBb4yXfgQcaruy8xeL4/qbYAhB655aPXh3aY8rRh1TXVLJhXr4MwgC2CBjY6po6ncPDDQQ7ICu2J1i2LKzvMPZjSDlBlAtmSJO6is08+MgW4gS1lbPouDmA0v93QwFPJcC9YRjBDKoXCtnPV77VNzUqhXjf5eL8dAclSgkboO85gHGPM5zM8Rsl4r3//T3u/vFfOqhKRFtoG4C1wOd/qOhxfEwfIdDxdevmhbcfRi+6QQ1RdL3ABY8dWe83zhPsvmpTNFC7grZg87U6znbkEnHDflcSGh0cHpOPu9PvmolLbQMs2A3zuw/1cZAR5ewB2dL3lcyt94tIXz+9f0zK0h8AOi613hsTyrdtcCsCjj4rm2UCZHRvW8QyHHoz8za7TAI/DCNz/j8k+1P3OxfdIi97pYpCVamjT1O9XQL8woLk+a+UX0ltLI7wftU68cEVLUtO/77dOlGMO+77VPTSnQJIFEy3Lh9okME4CXwmgLp+Gh/5Wmfd9vn/h0wgowfzrV1O9mhn43M/O7mZFfZ+x1BYCeaOS4id+pBn43M++7mXHfzUz7bmbYV+MV8MtTzPr2Hv72KfNgC6zWrrJB2q3Upa0wSLtMvamGflEAIbtkXqIVwmcwWrqkn1XStwiSybW5g00FFsoutkjU4aYzz6z3Iw+2gN20SJphIN/o93c1tVc2cxvzhWUFRoYxT3P4u7So94pMVU5n887o9J0RXmBGBfv8vG6NZ6WY9gsxqXFo23VErhYCKl+U2dvTtplovX8+RuDkKBg3uJe0PDNXQ57U+CbnUspCCl9KX5aO+LhkqQTXEVD0G5VPElLqyGLcGSUfVlySaVPqsP+OdigFtBZmtU32TduovWrd+Pkffeti+rHIPqdUjBV7o/CwRuwVfXVWtJbbM161LdmPVNw+79o7HDhv06x4GuIMpwkQzMiFNBYcUVOkR7Nr/b3crUAHKPdlTGcuw0DRnBgc3WzQJrH50Q+iG7tmdewM67JltIQHvHwLdOW2TAILjvMMPnQfBT50HxE+AG4CmWLGCMvmIaWdgVGCWU7AXWdfuCxVC5rhve0k3TWt6WDB1XoFDA6MxLMZM5Cbw63PwHJIx0KGS2jv6aaOMXGeCVLD81juI7GwXkAViWCkzxhp2B/doM46vmSegnwbn4V4fZ+28eTuiWhS4BejIvDA6KIn+OPDCvaLFf4OL8ExwW2XBUYTLUdeFY4qVJWb4kYb4GK9R6OvUS6VGrkPTRMCnFFrsKZtQPObNe7FdbxqP8AfVcfbh9MLyY1XwEbhaaKa+rpsR9dHDvAThl1QVHAFlevonX37LJaQ10Z/yD6LRZDfLugLB0jelkarAdF21WTVaqgrlBpfI7B5+5r9q8F/KlYqq5f1Dx/jPZQaeC5hkYrRTyYAIXDB1pd3yh4KlEOq581pK1S+HOzFPMZ9bu5Vx01k9M7XV9nPJM4mNVBVGWSZVjMjH+XLY3NJp0CmU4CWgfGOc+rbZzXyQ/YpoFZA6qwRGAGIzvI2Lralpd5IhsmQ6e5I9kGvzDNpARKVc037h+8FHCFva2OzIH5AfMryznEgFBoINSs9RVuUU+26vmOgBeVJNxCkc9THHJ1RSZ04J5thgIyDw7HdbkU+5ImUDxMJ3cxsL/PMrE/aWVnPj0b5sk4ercRMIUcscaDkXNMta64KMUK16MkoTfQtNKVsINesbJs65Y0cnzA6x5n01AG+dBTRc98urXOSNiswm6V5ec7TNlxl2UYLANqC8VcGsW2Wt9y+NlGyuqaE30nOdU+hzYplGdlNntzv0g1G8JIXczuxvGPdBNnSLYg5yb2DWoO8Vd3SQYrRgujZGLXVQ49PT2qHTYnt7zmhdtgupx32s+MHHxd6/qh2mD2AUDmhJmiqsUJeVRVztReqDYxCwcVl10McgN4yNFQoNiLkSR6pkMfHWemlqASn0DBVwt0U1WPMeh65ww8wXDCEtyAwYPEx4Sbw1MTb0j9OUh8Se/7D/VT7DNzpv7tAp6JZDKK2vqJ5E8k2uFbZBqNJ0NVWib7ub2vruJUiZkCgUJlME7+FGeIndrNNzBL4dHAscYtf2yiG2nY3O0MzSkNxZRHm6bGbba0PZTtbNLGXbVK7updN+77cRqswoy3Lm+tetgHUTfuhYHqD4jyhVDDV3JRrcehH7Y0buBXIm/IkTMF95f62dsd6kcF60KCYpUCdtFLrSNHCSzY8Mizm5IgTjsy8UuwCkEXE33EP4NeCf4Y0qy9NvAyGeUsPkoBiOKUYPUDhrqHYVHO0cON1OKS5I/x9K58j0VqtHnrJUUfRVumKnH899HNf/MPnfN/lev7lxvjYxXxOVEGBqu5qa7QNfqUKqlVhXcytu5SMKpbo148wSC5wCiY4BJpbH3ID5/KWOSrTRooJe6qh4Ct7ap4YZzsny9HDZwOlwnq6DtT32X1E3lI/euJnPU8q8S73XOVD3aKxiwE4+7DfyRikOIZCywYD2SL08rpp64zeYuCxxsgU0a37wu/4n7/wF8/75A9c1dZhMs2olwmYSC33hiyVtxahcphsnpEZkorTLZehghGK6uQZR5W4o59UeXFf2i54K3rIvooIW+uVsXEHlxSAN6jS7gen0e6J2P4uQz13lDq6WWFPMnFnxHNSfJBb9wEO3kZ1wCtnoNmvKOnW0zGvPwgOrMnyDBX+dyMNmgscLX4J8dRLAUaFhp/p9/nQekSTlPQFpXaFPV8OEZKfRFRx1ONaHtkMFBnXA9BIUmUne51UaHp63phestqAeP+JVp1/8L0QXX8XNKvF5JcKgJHvXV4eS5S9qT8pc66rzFmsW8mpYwwCzpsYQTSRNMfjkmYcpqgtal56TG0+4a6xtO6oV4j6C9WMoLlunOjohVfrAkYV3vxpQuakFDLXwNjUrFJynVNQsQDM+l0M5KGnZN0CdamlM1V8UQBolcb+S4KfuDzbDWVcqDYai7a6io1Se13M1slo9a1Fjj/+sX8MscD/qh4Zkn5KXraBiKJi2wIPg31YvL/mcxGCnu+RnHq4xD94V9My6BH0ImqiKsQ/ZZJe0d01mvfc8/xzEeJN7B7ewe7R2GejDc/W8CXn+ZeUB4TkjxwleqfXvuv82ndJKLj8/OByruXeGqrhX1fxFxCFXxf1IKLw66Ju9DgKv66B0Ir2LuA/Tr4FyfjNfs1+cSei8Jv92fUm6l2Iwq+LOipRR6tRxxCF3/6GSPipJuZ/Pfy6Bon1X/yWURNHZEXNDajj2HTEDMv2X0BmlL4YamNPZ31BM1VnBWxxjg0VsLvsXAz1JFcg7w618WJHAJZhxkq37lR8rcQDIwrDQNl7lSxom4VTBMm5+4aquvD7kCdNn4k2q9p1abdFhAaewlAOAVsiyeeH9SBKkcSVNPBbvMBRp/JYErT/3mv11MhX95F5YOOgKVA9k9QbbL+vHLkhX7/o+dAUcTqYkXFfgbJDVbv08fDVo2kClRksrkhMxOmxtBepCSXfp5qbmWplil4phdmHq7qYYamLGcqrqAlAF5MfVV1MvBQhxaO6mM/kISoNtET9u//eLGCRnmpHUOKTpmrrs4+gajmxjja7v/Xr/x6UMT8WVh3oVDXbbWsRRimx6jDExm2yK0WBl5Fxeq2O0qC6efU1+GgB93RghSM4UKpkhsb1S2b0JhOOEW0A1ZxVnMPhuy7qDd3DmoU90dUDn+d67KuZjcEJs2Ykw8Lf9CQ3FaUKu6oGIrqefpw7ZZGFPSNKqyssUFfxMlAVyspBrsSLQpXeZQMgNl1fo3J9DbC+BnaZS80FLcF5y39FRpS5wJ0x3j+ogdwCoKCsSotLpDhKkaH044TdU+KMclioK7MZSk9xRRhelquOijXFxvRpVAnSTT7HU06J7e85CR1I6FrePS4K2FOqQHYraoirk1qKYeEMdk0IAn4jCOBOubxrcG+jqrelSCUK85j72SEhoTL+Pviaexq4h1Nfg/kViJZReVR9y5xvZB++ka8gf4pILWB24GryCc+DngawEqMO/yrycUnigOrT3Ovp8y5NDe7Es+oZeWC/37CBu80n9+B5v+c8IwsFa2nDElGHuqexJqStiu0bgeZ4Fz+1t1w74kBLGQH6qqR9V7C2b/avz77+1p+85mnGCX5oMymE3PGNgkk/yj6OvKrUcDQaVM2JcMFsvwBpNd4zKjiNE+QUq1jDYdy1PuQjE6p3fb0izgowR7kPxrFTF+Mp1GHDryhbsmEDueNpY5K9MGTgCwv4Y6hUiXL72/Kgqo5GQXrDyBX7g3OjV73/UNcY1HfMN1c5XKH66iE1yz6OrNowLAXW6MJfsKXET7hSNqQUrqdsAYXr6Qc9z9rHSQp/YPQMeYpvFOaqGcb7SOEUbcmvmIM44nbim2UxrSwLDycL99yX3vTCN8syTL/XEQBy/rIi8i+sLfPDg/JeRAEWF1051QDC+3CLR/w088+ycfwUgTDdK9CMnDbZXMl8UZg9hNT0/b7nTy58zgWW6vOF1sJcPxRKwFAYcZWqCxY2/8h1r2994a+qg/cuBKvoBRg5UeeRNvtCUfmni59lbvBr0GDhe/RKF1N1/GT7mYS8ULE20uXQqlVK9qy8zO6PaCC69niuPZ62p4b21E6iMbrFR0lW1hluAtEfOYSoX/d8+LkScClWK9H0nbQpsHQ5NLvBygUAXbL08hDcIgq/ifZjsRLtlKD05j6sGlFJJ69iol3r0Jgeruu8KStRitCTNCTd4xkjW6fv5Uua6+l3MVZMkSZAkG58AvJVQSUoRqKQh6UysQDjIMA3JkL4i9CfcXTiXue6X5jNQf2hlJ+lD8Yi0g00ELrP2YVkhyDgRciZUSThKyTe09TL8o7EZvcAv0Wo8OOfPPX+9JzZp38/oC3DpYmGhRg0ZRywx2uCLZCtdV3FAOIQL1SF3ISrhkNPJIufeEogazIqV4RmHA20GS1kVSP2pKftTVGxWssz08GAUumiZUykl/xyG6a33LXJKDCX5DuSUwSwFFnTs8ivkV0T6U7Z7zUHLGo834iJZxDncHBWutYCTw49cprB1Zlb89kU/BnF0ki0niI+9eA0KJTpJ2J2keYo1FoNM3gvTtko4zhO6mhnsjcKXz5HcwOaXUfe1OrjRWhpxAAzOg/3V62tmUFR/qsuaVa0QhprhvGP1dgLo5JbCb/bx2Vu6eiNn/rJfh64Pivgw+EdeQRKKoVE2aekEP/5RYz5IPY5YNTr9O/5kQ//w64HLh5eJZMu/TXPC9364hYXXKIm/zaOgr2u3qaLhy4dlXWDRaj6XXS87xSGeq0oMJUfuRX2DG+FVhysGVKohY/H208Tti0besb7HrEn1OZaBSqE3D7fzc7DEQN3apU4+xNAR+TjETq4LutdvKZW4oApsh3u36MoV9/3s/dfcs7XYKsPA8R0J9p3263495WL2R/rnUmqV1u1LaG5hOGXdhCjkiTA/l24JqP8aR1l7KvulMM5TrvTX3NkQRJ55uxVwW4lQQkEpJyGvm3Zy6Mfo8cDsTyf9Ot5Q6+52xrliKapNqb5wZOcgio/eFCU/mVSbRQz7hKWqeEruP3yANq4W9xuRPh9gJfjY3pZSq1ujJRIPEfr5O0vmEpQ87JegWNJgkql+HGYUW+9xcxtNKPXwiheL2ZwpDJDKax1NCjBH74kfIup6OH8NNPDt3wOji8O8M2xjXzezQdVvAhzDzoiMjdaXF6xCE4jkLKLJRxzSvuVKqFXSpZc3ySNTLSODUwULAMzuKAzAbGuJVHLmPjLiD0U0bKNDYgrfRCotaTAQ0WjxZpNXKah5DY0crQJmc0LLHjkTaiOCJqCgUJTTB2kFVXa83CNi+X9BVEKnZeNYpEWh0fIpwUgx8JGaRaTJ9cQyNQXV/IeyLJHC9SRs/8OYsHggRVpFl1ZJjzd6sviT7OMCrawB1XFxpPRkeHSWY66JQVNmXNNycyedlp7TEPm0IA5WlCb9VSjLtd3HrcFJNd6ZM4b9hC/zZ+0+9a4pZJqD/wWB0BRZelTLOAgxIjHzYb5qtkw/yLLWP1+FDblkDe81tKGsKQNhgYc8u1OE9+O6Dd51ixA389ja9bFJ/5js8J1/VZl5uC+Sqt/zT7hjzWfVF+cZ1hDxSn9lwnJ06urlKg5HmpTTDNr1DywoeoLHeocwN2s9ug6nUeipAUlJ/6Yh1zVM1BBTK28iVmOqFSZRm1dnv0vpXsjkhdY8+xwu3Atrb020pW+Xz12zqCJWVnuMb31lm1sqNscukFhVX2zLZwKiEXGlNs4R+uokdRirtKddoXzbFMHh//8oyp5AuyNYl4PNDmZydCwmKU5Pjve9z1v+ctz91761f+PXJAXsJnsryXvHJzBrJFfvduqxM/Vx19+7QNP+f67X8tL1/w6t+Tbz3z13nPe8fDF1F4fDO7Y9z//8vLX/Pwtn70Yo9AeDNX+EEp136F3mTav2Pz7YaUVQxO6/+LB+qYXbCMMrjrGLwAKXVAMQr/aj3TZCxip9dzIx1FAi9dinR6QcJM3zN2lQLXT4FblxAUbKtdyDq5hTb1pPBBwbJv3SnKT0Jfz0AZnbikOU6vkzHgBbwivCoTSllv+KqHmAPZytJ0xebgOqraf+6tqSIki2cX/qciH4yEcMw/QgzuGVqa3une9vKt6xt71AXMAD3nGVXqoQnUleiOWjQM9wruzzhAe3xWFpg8ehWCWBTfQjcBSJ3c9A0t/hiJ+6ScuP+cpb5z/b8zUxOUurLtXLtR65ZVVio9oaTiL5GLqasWtTqFiP7rLf7Dwm45cwJVRwD3DV+g4eOvanESb40HTL9cji/Qj9TqEbRDVABnKW28H/ZK26brzoDfVX0jIq839nEQI3GMDR23gLhsYeMLFK3XFMZmyQhoaIynHPEsvYz38AW80dLdYhcZk06hlgpYSJVJlZp4CNCyGKaUDV0rRGmLBPeYNKXWxiBp4vFCluMnbT0CAlM9oY20YeAgIzsKKFN6UEOshKO6wY2ezG9AdJdTjCjgzKknuKEikGjED7dDOFZhhWSXseUAC+KFJ+L5tldacCgjNMMHPW1bzTrelyhw84Ong6Nu9no6Qvh3D28C+ZfxyzL4Qv9xrX3bzywP22grFz3GrBJh2M8Jx9r9VcKbv2Z/Jm6ZlujI0K7ou5p5OTTQw0amE4RNV14GWrhaibaxD2sK1cTVLooJ5kpdkWO5XsZ3qWO6orbvVtoGevnfxngzwxYz6eBvVZ+qwhmvBPzpZkCOyeo2jyj8KDYU1tt+VhrtgKl1sizokFwsVo2GBcdUecBO6nMbRMyZmQrsqA3IdM/ZYeI5aUv4Hnh8bbQtVhHOGt30KhMUIVWyjd47V+VOg8jRfxVggpeLGn5M880axkHNlNBquJ00eHP5CSKBYlt2g5jrMSNUseLkE3M+uWOzOgzEjeJ4xeGw31bqnNtYl05/1QrsZk07pjUJRiOTelN2wmkPSZdfaPDEKxQ3yc7Vs3WBXVoaeCpuod9hTtYYWanOVr9S1EKn2JiMmlJzaubYWdWN15p9UyotKfeviPSmCqpP3MkzBz4AEG4thMFQM+N9qwXId50VEmV9Uxyob4+D9z/ia/Ve7oaSZX6v9/3q6SG2eoWzFg9dhIrs6v7enl3VNqwqfAlXLG6Kp0KfUF79i9duH4OTHghE7uvGo7S2ILbI/n2Ycy1mVd/a36s7+Vn3S/pZLl1RA/RFXA82Uzlr5yWfwibOx+hfODpf6bDBngnWcmZd37ffjV0p/9hp+L8LPJWv72VDtGv9RJK570ActStzKRDDVlVyKtki7EFeXWYpHWNTcMfe4BdZ69m41AZbXMULIntf5OW6BNXZHcL/lhaqWWlURiLWjdVQdGqUA49QAb00KIDv9GqtrBjCqoZ5E0PMQJLMJHQGWrnZFOQEFECUSx95+qYG4OqYeQ/W+qt5AVOoNRHhVS7PQG4gQ4fQG8FLwyI7qDXw7ztEPeeYgPe7fZ08pY2QIpc/SfDReuyWdyj5XWnOKN7Pm9Nl/DwoEX4jlGLWcogPPHeHUpnBysayrAD/wGseLZ6kqyy5gp9gYwMFPF9BRIyf8hb+PalXW7QocC1XEhqy1dws4P780LLKTxdMU7v9VJcWi3QSreofR7pYEbxFAoAkUOaMPX8CYwWDOSeX+GzU4oH2I4G6ibBSgPqyeeUVQszLnen90cbnBwoFEtzekcEMtRO6zl2qHVdsv69nfSlV1WOYJ+z6FWG1R87kA23G/HhYM1hfoqZbUBmpBdcN9XSFh5XcuV8S6irtyX01XaQ4eG+kV+nGLt+9jT73u+98y+NzFQ+2XkXX+Nr+XbQ25rXpjfoHLslffIi2RwuzvkEsJPUCaPYB3sxJSAtTWNVvnVguP/hOgVQI8xn4o+6J8AbzGAMBHeHjgPH9PpXd7K73DmAJ+KrCm8LLeef4+qVr7hBJ2Z18yZUYQw0lTtXV/j3glWDv12CRSrA2d1oEmdyvJq5PJrUpyVk2mErr4fUH2ZXOKOfBG9SscjXJGpqbEgqqdnILFX48rWOBA1rrcdwoWz55UsLiokrx3MrlWSQ4nrES5Br7FK29cZP+AxjhPFYF4qsBkMikcCzxS33khBUXNZPJcpmdaWwdUg2EdoBG+UD8MeahGbijUzIWcBoLqcQD5J30Q3BkF4bVY7yq78qqLkTIanhhK3wxc6IY7sYQBFjNr/pFFNDGyWuOuqhC3nn1e7WJnv4DncN/fXfDPX33GOf948UBsyB5x55/WQ8Nt2U3IeQSnmZOWYgMFgfH/4WZoEVU8gdQVvpWmCdOeiEdNb7S/m/bTq/azQeN9axy3b43H0LfI+uZIgA0JaYecb446stWBBR6wYKyf4NcVJ76he4pNjvS1SHpFXagEB9CnSUw9FHnOrmJlIRbDYYXq52GeoDLf3RS5sogvrGUOBh5VNxMUi1Z8BLZ8Fz98lFaxNsjpKJogZe57/Aa6BzoPfxJdCRGHFhBSn2sSWlDTPCJ2eYgreSn3AtqtdnH9R5Wv8YdKOBcm5ppQW5y7xweKeCP3jDmXzogLMZ9ijL27szOikKCXDYY5/1T1YMh7vmx+ZVXVLRR5FbODniYMyTuy71c+cNXdX/zvf8PnYN8l/37F6SGIXHOdTziXD8Dyw/fLmaOm7r3t6Pq+lYHH/38br9F8nUYEaH7V/rNWQp5Fos9xzf4RnHJO4IltKJCXQujpeLqrw2hbnAwncTIkSKHC2yZQ0QdcruyNNGhaxTlklkZHp2oO8b2qGqUsR1aqYC046H8we5N14wrfls7vGczhbVhHZ3r0S8E0c0B3DDupKVSty2rmIkS/giOPqKJhpVz4pAymGRhDZcoOq9WzEFFiIFGvwfgwYw4ENw4yQvUZ7I1oYQKXRKHtn6wDxlYeGC3a0NnAws43iCZdd00aljMW2iLeHMO0XH3EtBzHRmpaDmNNdTX6JgaJZYsmGudJRbTv4UzD00Ou+qS5uQjG5lBSWDE2F1ljcyhcWJo7VBEbl64bWNzkDoyrPSbfaY1v3oKoYoAuFAN0daurX6fQ6errFgzN1U0OCBg1dAsU2ofbJAWkfnayL1Yc1tZV2SWyVsPUQ6gzPfcO9VZ7ve81HWpUDu3Nmf1X1IS90rUDRZT9s0RgRKzC7iqcomLUdaeeJ6rL3FC9+qba5oZYF4W8qBBl5ZY1I5BIdMplCyxTG4+dsWTiJyJVsjd6TcYo+0a69Nd0JxyIcpp4AirVfBE5HuPw8vrtScpT28rNWtdFL7fifK+iQo4eRnjsQX8hMr9aDiuADgcoxG4pexDAwaCObE+Ul09k73AvBPnZPTpQgao55w0tFnKzc8XE8oLmyFOO2TUS01L1NsT0uVrsbNdMUpsrRHwxY01/cHtT1S6f2cg7Y/RDZMcxZRSNUJCOISAO3KpfzT8AMLWMsYl8Djf91Hj6HIZunoekcmypoiAX0eHWzcH1auVi1BEctA7yTmpryqgzxO33in44zdJ8xTJwJsd2c0ieoxkZcoF0EwbN0LQFRv/xni5yY5ZK0RisPsmIRC8q4mrfZeNlCWjRcZW64JW9wsGRXJCXD62qI67AlsACH9gP8qz7wnxZqswj/UbZlKJjbvJm5qPo6soXXepIS1Cm9sx4OS+2YHy7lAFUy4DYMuKzXI3aMxgX8jnaks8EgPiyQHoASA8x2OXLQAAJuM/Z02AdhZH7mNCbUfLv67pX5UUwppnTcaq4e+N4bt86hpZb69EWaZUetnekEe5kqnq8HqPqWG/ajtUjJLZYHq9l+YitpYa3QfWK8JRq76DsyHCyQvR1gbaITcVZnUUr/YgPVXqK8Ks6keYpAL3byu1ZkbWiLraRVnDdPUKo1+eSYXmUc2yRJFqBcZlt+/PtCF2TE8EKAm735tTjUMihgvFzB//txNox5Tb6KXx3/HIKCU+sLltpBxpXRCoKCJkQEcIZh6/gfuyUfkhMcQqdAvMVp5Jktq+ncfu2cfvMJclZSrRAsQl3tci0NHwFhzNOX6EEuFlEki+WtMsln4b3Sr55isxRAlAM5nx2cVwyFne6UksoLUAgITu0OTotP0XlKXKl/hQ6vWrqit938TvFSLSxc2JpRokqClN/BSBNdGp+CgGDrbbhNnvVhDAoBRUAhnZWu8Jlan+1N/yq1nuki3m1QyfVeDSWh801/xG3PKXtOW79Mdo8V/b7Pe5LKGMUuca7kUOc64SM/WgnepUxDGUM47Kcy7kcM7LVcnh9mCjnG3eMV5QB2IHd4w7aCavGO2mLdW69goFvMAyWDsjsm1fb9dRTcy3oNpe3qqo1ovVaMTEAm4iqS8lf6DwUdV6Kq3ZHOnLhCcaW1LY0zXHdgM2aLGygOnq6bJu6hLclKo1ZLqCNbVoAb7cwIn1qlX6wW6RHAiPJaZmcTiQr7AwPQskBw3wQ8yNMZREP98q4iT8noygsyRreecmXDkejmksRzWEoEkM71wxjoNVUakiluJz7vwF2oGq3YBG84RWAv41znALN9XiV5zVt0fmLzrs0gyrzuDIkaJlYKepU1/DMrN9VIu/WbwxSSfJphuZxer1YSV60vIVe/la2bx7NvUrajAtxG3dkb5DFfsUu6mAcclKUZxSbt1cDt1iKMw9I8BzjJIRA8Bf4byvkUrK+YL3A3mALRrKHTY7c7BtfVBSNV4lF0DuxaCgctwegEztoRVF7G+3MZ0q993l8sa2coAwAHATP82jP6OjKukgddyl9jB2YA7yAygDYLABWnXDUQ1xPpl2xQ+OkgToPaCWPpRmzaMYcRWvSRTxndbsT0ezEQlys5Qu0FSVuJbKzY0uJ5FumzQFAQpNDJF81fQ6cVZkDeQ5FeHxhEDXHUMxZfJ2p4OtURJ2ZiqhzXwdEnQOizo0hqtKSKqJqF0LpxwiiziqiFgZDZx2GgqksSgzdQYXB0JU+IyX/kcVQ8DwLKHzh+BiqA72VVtfy7QrQLYaz2UI7adZi6PavG4auVDB01mDoDmDoTsTt1DhtoGrHz+Zz0owdeo6B/kHNcIdFzxWpCWWM1LSKmFUilEpUlDS8xNKFaVial8n5RPL0PWatf5HsMfUKstlp6lmRjsxOLhafFEIbcMDO8EVR6uuE52e/zkMLjKadouIx72bkNiYbM+KWZL7fwVK2JrTdgoUiAH10MwgzX1EVEgn1sB2fx8I7X1niFCA7VbyxE53dWZ2SKMhuwdsNnL3rXyRahd40B2U4UX2ebtMUTudCUFrX3vK0bVR33fCsnzfxeEGeqmH1xnEOJZvsz6FiU8h852Jke10V18oBWz5TumWe2RDmp8gqAsl8Vlo0MyrEhb+WUSFuVfcJYJ+D907+qbSvTR0R4s5pdXkbXapQFOpYIW7n+EJcbP7Y+aYT4rapvakQt8NC3HZKmdutlcLbIc3qh3p+MBhQNu62+gi2bpVN4u69kOJO9roGspuV8XzByzsJeGQj8JgDPKq+dDILj+z48MgoO3l4ZAyPuYoMuUOWrUmODtGo9oRIGfBLKYASM1jEzVFQT+FGUCzmgyCgeFY5C0BgBJmYjauA9BEDrv2vBrh2BXCeVkJZ9TSgfWQqBG1D1XjuoGBcAR4RP2nOngZ4k6cBHmU4hxg/DWBwAC5X9kYaNHXoWjzFoDU55FE/DilwZ2ptiipHahn5lUNSzN8q5mTUsY1vTzY+ozY3vr3Z8dqmqFZD3wZMJ4XglWrSRq+7UbVHJs55kRANqG7jM45vuj5QNIQNNy7wanBLpS7XRftVDA9TCDXQ/Uq/cRNLRfFyo0np9IsKJpDtUp9lyN3jtBmKD+x38edofNtZZquibnl3htszwJv+0yr2XNrDeeA8hU77QtmA0TYj0HqRbAur3hrvDb2ociDu6xd6DFMdauuhv4jscVqV3Md6kDFxZuc9ijO7cPLMLqzM0tDO0vD4s5Qbe/JndqGc2VE0ldzH5I+Q+2iS3Ifqc3MTcu9XjqU1kyP3J4ZHVIWHnjtFFXhEFh7R8eERUXTy8IhwCWDEh21QJfdTTxD9VE/WKmoK77l4+PwRtZB/2UwtBCknVgtBppNWC/mXk1QLudn3GpOKNToPksJanePpoN6dREJvD9KM6akYORLChXCcq8GKIv+V52pB9Vyt7s7VEgrRvbi8RO0qi7iy/abcvGHvxcSQTip/7sPJniiz+XIgWeixo3Xi2hATrBQhgzxCeSDNHJeh5VaRdMoB2feKQY7Nbf45w1s4pDbngaGeB0aCypE7K3VngRWbf4c99d/rG18ugfjZ1JdcVB3QwFrVBaPqIVVE3Z7xgip5FXPIc34EVXHb5a9YngvxGLlvE6TfIl0zNo9Ut1POA63oCGpWUqGLWB2LSD8cBGDmgyk0tQimaRqh6SF66h0oPGbvHzklxV4xBuWIp1KO2FHSfyXKMU37IXoU2g+w5GjRPj6u9kM0TfshxnQ4Oe2HKu16fvpXzbihFnqvHbPRG1W9ON0/5pPp084nkybJ5LkPQbPHjfuSx/rfYsmz+lqyx6Zql6JdZsjrWtODYzV9wdX0oKvpy1ITJgn3G7fisOndpc3Ss9ZELlKEsDMVYo/cojoele3IDAXQKTDCm+T0gM4PCCGjiZlpWO/VgCPf5R/2i0xFCBmlayYtgccDUcDvo7HYgj4s9HiWZiBO40GZKU2Ak9gyb1Abx9odzMjO+FHYDLrlmWa3+3qKG+TNKtS0sxX4UqZil2aqtLyFMehQNEWfeU6sakeEJ5lnZp4yPLg59VzUUd0bz+ICTJInABoulOUpGEAFHVva4J5Boo5ON/CYhwTqKtHCSkCyE/WW7Gy9pxJLHVyTgvCHa0hRNaUcg8d+OLalVK3kokZbLP9d1ctnSxUBALHBpYicUSRHcLXu2gZwz1JdPr+yqMPD+jwitIxq29DyfAEAhIMpgI8eI7Ca/4rAav4bAGuRYpgbJgHaAmUEZjz7dVjRyb6qk8Dx8Is0e6RYoIUyho/aZ9fLjRXN7vtPf//gh7e/6Kc9bvI8gIs5d79fig2dISNIMwXKblvGfXVn+CLupPlBGUPzR9YBNJGK0ezohiOo1a5+OvN64u3rbv/5SogTVUdqGnxA+xdotu9lX0PHuG7k4VcxnyO7fyz/6sPA+oyH6K/cfpwZ98Qgev3aOvvOs6Q2dDeEwmnbGPXu78FHNDNUV1zDI0A8hsw1rilFpQYIRVN0cYp0WhGCFi0jQ5TOMTVCy8wd+TTvGDIzY6SKByBPnFNJIwv9cnTcv1S1LPhvWWzpdFGOc6UzR0vwWyMnIosC/y1rLGT28xB5+a/HFXTzVQr5S59WpVVbaYV6/UQExigt3861ESTTstJvo1X4JylCvV8ZHg45Ei/ELwf1RQ/FHwjkRU/L7w1oq1YAxw95bjT5t4MJXaVVOZrMKYYxGuM/YdJxgqJ531MB8DXSC6J2zoWIxBlMdY+6cHMQ0qzc9hTc6nJQ+74Vb/vzbfzhdu44SY/gTWr72qPslE800SlA7ZH3iwjtJ9oOdN1uDs+pQ8syKtsrAHMVSPGrwBuE9LB4vNglFLtECwqxRLzOLSjEOown6peHHzOU4btMt/VSeQtmVAqrh7+tuq0Eb0vFDtoxXJdDsa2O1J6iF6K7fFSRt0VuDEQl7QAX1m7jFBpXD48Up9Kpw/w09+0O6gqetWStLbav0U46jXYgd3ak2EW7mCacPqrFwiWSqBdw5lM5Q0my6HQ6vXy5sreOz82XdHToRIDWtJJsIXa4aG7MKojzqsDilErCKeaYzGk4NKku7RW/vKEe0kiJq9yV7Si4BeK8Q/YIOyp6ilqD7gtRUAP6jfJ5od8liMhRUHESJeiRU9cydGdBvxvY32D+RWkDYY4AHyXoayS8oGgkguK0SNMXKO2/YK04g7roHp8Znont1rPAx1324vwstTB/Nqd2D+RbaBZG9kO42jlHjA3kT8Aiy6mv5MMJIEEmQ5ugrN0627L8iTqd8idRTAWZ6FqRY+b5duYVT8bc4y5MUdQ5FzORkwiBYwjg26MI4Ku73Ffun5Y/sJkPeyChDLOzQIufSE+Eus5T6En0JATOo7N5WT2TJ8o5TIGfkM8rvRWAOQsBKU4bleXjw2ghTquWGKxiRqvLm1xm/nbEapBJlQ4jYRjv1UnbYVI1xwR4RsSeGYQMmD+0TctUcoJCzyuJARniQqtaD21HhHPtgzrxxVOIOGAzT2ZbRXtw54gwltoeqXur649Wre34etdNW4FQPNfw2EZtIFO7D/GHTJi2cVdCi/9moNmmteYkFUK/wBDrrSWRznP+mPAqZWqllFdXATKdJXSW8CDaBjLDimvqi0x9LMncZDBE8P+Uk+0xvtL+Akor1FZk1JXpybJoPsmuUGiJ8R+V0za3LtGTpcnjvcbKsR3oTE/Mc8jIaDuaqqbxtHHgQsq2LWEGcNA3zfOM/zOQQ34OPOUptgJ0/JEC6Mm0anyj2mnBH8v7uXQumoLmoVUKuu1mZV1Rbb6xhXUrmtzmuh7wtA3HTBvu0jbgVqZ0iTMCp2SdxKguWaRbBLuwSB08OjSHx5zyEPPkYU1mI1gikpNrtUwNS6XYZQaL+Nqg5XwVPOkEOQGgplMkZTyE9GnAMBy5MhsVEtPGiCq+hRzcLstCm1ZNOhPfktpkgKWCDWAh5v9WhQGCpQUSlRwOdPMVS2loJV/issJiBUUpt6RVrSq2SZUkVZ5HqxZ5WL8A+bVeCsewKKSnSNYMWTU5K5MzZeiAEQSPfdw07gnXulUQjZbGGxKahqwepyH9FzwebVkFmFxbVkB+Qkd+IBk9Sfi0TbOSxx9EWjtp7XZiubleJUJbT4IIbVNeEVPDz7dyTST9VNeTY3XpnM/5k3xFDMOEm1KdbRWqQyegOiAzY5RHqc4K4oC/K7RQaV8X2f+vIkTKvgupyUN++DyKcIhHntWuXCWP0XBTWuIoBwJpSRsKotkRAkEmX2ZJ1blKqkCzZvLtShaIeUDZwDH+wsMONEa5ivw8CVCe48lV5edLIGM4zghZYqhRLsqtFvP30Hk60MV5Ei+RF1CukVzSU/i/JyNpD51vcp6P1ws4Vl65cLCZWIkwH7cr90sxZ9fuCueX8dP27zwBCKC2XWUJT9FmoljiBiSF7YDWYMs5V7unM1K7bDNwcHTD52aZTo4Tz7RU6sYno1RN8Vd33tj08XiEji1ZHaMbShiA2L4iE/F0eRI1uZx6HiqB0ALJzIatx5kNbiY8cWwmOGSn8Y0sx22VnE9myOsceaKdI9t0DmjzyMyFrceZCzoPUopkN6BelnVnqy+H8ZJBMxsiuMalxkdYQ423BS/tBy/Oe5RS16yEuY9CdRsiQpMVy0oRLBVhStgd/VG/stc/Zl8I2GBfdmPk/Ue5gkcMjRhCFudDUvBEoIOAgpvy6SICf5qcgfIpOWdl0SIor8qSnlJYbB+XVDg0VYyzDbAlT0e5ycpSIrfgTrRvsnBUevKlb89Jp7k9PrUHkinm7ePcl8cwo7UAhkYVCDrh3Ahv1ihb/HEhsVW9jPtiiEJfBngh83IYL5l5OYgXtcrGs28b9Z6Vh5iL2B6E5hjbWAgqVvG4pICtnkm0znNwsUwKINzQ5XgK7j85z7m3uW7meUlP8SyYCIAS/BMogtJ2NTVoT19WZVmj7bKkVcRA6kVUd3QGyjsw/6qa/zsq/EG5KwGYjdlI/iS9yPOuLa0vhRTcIV74BkOKIFK64o6hOFbwCk50B7XD7HoRIL8T14+9VwA2X/D1mLmxRnWWvSCKaQC/xebtfrwVjcq55bqeJNSp7oTkvQJfK/7KZ/f5+B1w6QfEmqMPM8Nrcnez9i34hOpqNu7dME4sMf+lt8e3R9s4Iubczr59mv5L4AfOmcVdzjai1dL8tPVlAbhkr0JP254YfISjXevvQu4c104PDvl8BIcgD+eDSnf15X6hyMguh3CRXhSP1AK0O4dDE7usKXA7hgDSexgfusW81JD/gF6VvZnj0ARC32721+DgAo1WY0F3+tkNaKkzQn8jXpnul81FO/AMs3+GDF7bIxJ8nCCQD/MmXOy/ILHQMn4DVeDDj3vqH6+mJrjE2Bm//AjSXZWvRpVIcz5BXH3agpAna1L6BzGKKH9V6hvSXpwrxzrUOvIHNoZD3LC5rXVgQ/RbdYSucd5GJsdKX19jTjl4kA3Cw/LTtRSIFm0R43HFsKgzsiP4vOEAnyF4NQdDaa4xCElxRWWtXrowGVbU08rw4CK2RLpq2/RaNMKEDyHc99iRWnDdhDMV57nkdfqJOG5QDRb1g5AHeo89rPhHwZyFX1t8eABOip+THmuE4nPHGTd+wKvcoYadmC94enJ977A8uT56B4LGm05fbEYdHkjUJpZCB5qqpkEr4aMaxkH4zWUwuEeDI750jlW+ur8SflDDMIh2uw1ya46UwXtd7CGJvUXT1PGOnLxr11Lt5gOum9Ku+/Cu2TRJivpC5YvD6yNfBIfWNwEFmutKk8/cnL7fs3OaYX6feeGxLOf0vRoH4uhNHBgWbKHrzzgD6of5TsDj9/Hc8JQI3OspEahQoru8KikaeFVadNg7PjG6BTYHpbObm4d9mTEB+wLzfJ6xtfXrF+fOaq3auOUaRnuW10vDXHkMINXFpj7F6runqLMC0OWI3vfGv/mVwT/95uDp339h7dkUbL4MsD9HJMOSGEy6/77HMRdJ8M8Q3CPBYwieiyCOgWBFDMEvIHaXBDcQ3CnBexEkBNUs2aoE78FnXSWTeaw1Zu7TBVdjy9WYuE/B5waMEGK/IHs9ZneeqL1aFMfkJq/j8bK8UV1KmdQnbinlN1gfaBzBVSGK1YcqAIykwnfran2dfONqtbquxrquBmczTildrtJYgxHM46g3Q2jmnOHX3jt8N9ZSH4uoX/Fopoj0oK+yHXwhBE7BpqREO49ubXgo+Ate9gb03Bgt1u/NRh3p31PoQmJsPMIafnkR4xOJoWjBCSna4Z8tJ+4D6xMU7ehbj0fRjmkqIXxvJfyAhkE5PqJBmSU/PUnRDmqcfHVLJXynhjGDP4oSEOTWaKwQNxfckODdGlGlaOiapU8D102ltHjXbJokRd1e+eLo6BfBhrxPp2h3utLw2b8viiZsIDC7osLnqByMd47TtdjRtTpAFStdqytdA1U7ARHDHFJoPPv/PHp2k9CzmIwhzedBz0sRCD6YERASV9SV4hUJKbE7As6fErbPHxv68EaUVCEto2QF83kqWfnh45MVdff7GMnKoV8oZ8/9PztBVjbuPB5ZuVtT1ap6JXy/hjF931cGg4M/N0lWHqx8dVjSNTzQMBDnI3c6AiKxyh254F0SPKoRVbKCrlkicQvCFbJyE941myZJUTdXvtgY/SK4S96nk5WBKw2fbU5WvklWvklWfmQKWREEQuBtCJwsWTl8fLKC+TyNrPzooyUrt8QsYIhKf5XjJOVaM9XuKCfOwds4mL0J9a3I9NBENz1eVpkdL5mcHFePzI3CH5sd4YW1/+EQ/3lVvL+kivZ7jo/1e7k9sFgrXiEPv0pgtofnFZqt02G3ItsTUCggUltT75xWcFS9/tMbGjQuYueGE6aIUaj53E3a2AgK/hh5SH007XG3WIrYmi+6iFwQ2qldRcO9gmVPYFh9p4T+Dvh2ufEDBaOrCD2EyEskmHFoH0JohU4W9B2TZRS/kzJ7yxUclgXXKNYOBdnNgs/1Pn9+GOOdxwgelGCC4CEJNtC13XnTbAT8qjgNb00xgIktQOPKnu4FmpvvBeLN9wLA4qsK3xjyCjGqt6AFeHsBfq4SZcxYhWybkhkUc23242aKBfztBB/vLlT/dDRqxvpe53SpMj9BgTzn2DcQUYS/KaUd+NY/iQ0c5YAwxYb63S5PLiTQ572aHtyD54hAwpZwvw08aD49hE9vCZxzX4l9n6cVvUuf8BaMz7BCuAl3eGSlOTiy0lx9/Cn3MksCIBPcbYlArMRZiECsRECJtFqT4OcuN3Mi0GwnWKRJueKqtj1TWLW0Z8m4YygUSmZodFqI3TpTKaD0Lkm4Bb/ZT4yRXDW7praXy6+1pF1Cda8g3xBctbE2QXDPUghFilYm8havhBtvdryq1QLN8K5qho2RDNoA6+8Y/SidKd3t+7jvP24QUm/CfVLtSWa3vJafEAej+eK0tltEQwrXi7i8Z8hvb8ZyNCjqV1rL+uvZj+FOy+3ZT+AxLBKOjIeUrFO9Yu11AAlJjWft2d+y+vnPnLfCLm7KGYxo58HRffNQwArW5/mAe6TeU9CakEzd4WTdsVzDpHi87hB1h7bui7n5ru765nX3fSV+7vrq7/qxmi9U2wn+XucJIrsVACwC4ltWHuhNVoQgVRFuq+otO1bp38Xw4Qfte+jnvviHz/m+y5nWN5AoWZtI6sIVEGgg5P8gikhuYWkp14fSKjOSEr6M0htyMVcZoywgpxg0m5tc8MrepksLaCgOw6Cjjmbs5uptkSEmWx2tWc9uBqTf/BCTZfbWT/x3Sa9oYX61qP5tuMgdU4TxaeFoLcveCDOQwDJ1Xk1+9sOIERehnw/8yMl0j/F9p8RZgfwy5wU9Lg03hnDsgreUEsNG7DT3A9AA0jBX7AiB+PmEw57q1M8ogSEn/qSlIaEOIEwJ5m5ICchAg/gzyK/j7LdvNHbpq/I/Na35LV/72nVfU9cZD9nVpEn+AVzBGFlVstuAHCto0L3w9jJiJ6CtTtvkFoDDS7iywE+Ge2mwT9sZ4pndUWQ8v5DSvaOIYWFwIAYxiKMHlPLIlWdcMcdU7OgcofY6VxcT/zEmZG+WGS9nEwcDZdMplnrdhQwpED97+DK4WbWl6+vmWAt4XVM0UWchFYqU8KCezMz5x2/OnEc2c/6PPKe8OYoiveb4in/1SZ+Ukz4sJ31tcsLb2Z63dErnofY9n1Fg5B1KlLdIpgoEaqSUpIU21bN/Al5bgsA9SdCTwNy+TMSfj6JJh5oHaEYh7E9smykQvQJfqA1mqII9o0xiAHZ3wVgl23WAvS5W+wAN3NIyIfhjwYvx/+Jm6wlo0xzBRmwLRKlVIUrzligtgCi1DFGaB1HC3S9aMETpBZsQpblxovTgCFFqGqLUmiBKV0upjigJuBxdapV+JFrGj8SjoEs/fOibdOkR0aUf9uDJ6PGmSuRDYQyQuVH2I1Q/0R4u0Q1c+qkwVJLzDU9wQkNwWo+O4IRKcP4Xek2pgCsVcIHkCKmp8i6B411wcbRT8iz+AYVfXeGnJCNTYlUrPLHhZ7xDnTThmOUGZpPczJwlHPNVbmYOhEMc4M+fgHDMjhOOP3tNlXD4jps5AeEIHg038/eM6C/n1F1uWy+SZJrqvUq1aGqEJzJ6kIDp6yHPBG4xAey5RVR9LYkc/EZPS37QPO/WZDjKHJWpb5gMD9iCjpkABgc+U6WpnjT1GdfzVxnLB7BO3xMg5SZN0UZFJvBgaAL3cyD9ou+Fk14FjCrIW14zzc1dKLAc8aYXOm964aQ3PZcuqWAcHkEF4D7gRy+7A5nVsVxEPIL6Km6UYBzdHvL6SggxNSBZZzGo/N7n4fd5a/uN08Sw4jHPh8e8rniFsR7zFG1iPEqPefGExzzuUPZH6jFPfRoiO3am3KIRj3nV/eZXfTHv0bh2ZF36ydeMrkutyrpUCuGKeimEwwqlMuTKIlWXFQzfNUoZnl2gigauJfIzlfVo86UqNEtV3awr9YrFD2zH65ibuhDp7G/lbQSSoiHGFBIyX2KxwSKXuEXOBbmIBA1Oy9VtKC1FC9uQscIAFudIynRKKgshbA4mdhlDB/FoU4sfkwtaSGFlQfuK54NfNUhPbu1IMMKrKvm+847RQ6bb8a5yb02SeflWBNM+ElHb21AHhJQSkTesp7yG2lcBupBv+euImv+1p4oLiV7hDNfAF4LLC4xxyIacVQCnfFW1ktvzusvFgoMDC4S6go1chohDPYCdLeFktyjBd/4aPhXFepio9mUq62fzOI76UiYW8MmHZ5eajMkQMonDxuyYcZLW3OXD9rKGGCVkquga2qysofieWrKGLmgI5y9yWb6GmdvHIEoNsMaQ/ZFs0zswTlaXz/pkL+efuFQu5winA1zAK7SuyXGhuu8jX+uJ+ZGwHwipKQPigUkKqC6SS7P6Jgb2UGzj7wCJcK957jZPMs9szNhdX1xxxjnvocRoRR3mWxHS+uugZgE/MGvVaX4xy0CYVbsVdfGjaVWH1XVzQDMSS77YrWgKmFPURTMcg8d+sbs6gwVTKy2LpTYbgWijXE6paMtw62XaoVF5JG11LQzE0X8ghVxZBLAxO4sILanawpr0AGcaIJUt4TZgrS/73wBk1dU0wVkyTPndIZzFQHYaV1NLFvILBOE88AhIRewVjgghncFeWbsPhj54fZxSOdsteIbK5gEVUdw9nhaK2JY1QJG9F21zFi98R2QDR3pF8/hKMQVmPVCVNFbdaAUUIr1ieSOoWt4IdH3rMnkV3SZQh1HLGlyE44a4zHU1KuRPtarRSfXEaGoiDGqJyQ3jZ0ZNAnklRFrZ+4S10s7ANqzmA32bDonQQSKiSHrK8HAQCI8ohE4AgSoMsMwGalPqsQAiD0DVX+x5FWc8obP8oa4XmTUi70W4SE8eHDrDNlcX7QV14IYrMUVIiSmwb40nB38EugRq+sdCCkJHTd/qe/40d4pUs/5CPXwHrzkae+PU2Adr02K/MDX23qmxH58ae/fU2IumRe52kbc5lmynbrbF6eau6mbbDGIlebWa7IzBcWp6IQPJWi8b8QSZ/RSq0gRNVcMw3n7jDDI92/NGP63pp4Yf85C79ihzP0+bZZ3xKhsIUU0gOhClV3MIX9TEXVWu4pP3rXlgviBdrtWJb3qDh5JLV8iBcqzgKaXkAM3wsyNWD175UGBiNlR4mO9KZ8aBvKIT3KAAc6PqzBgvXEk46sz4IoYFbw+MU18+3vyyugTVo0A9/uBWvFWIgI9KNnNdvP6aR+66+P9B7c5oHTqE1UE+xgsaq87cPP75Pn3J8JKZly5euvJydo2wiaBnCQ34P88t8peTAJbgpijTA3ZqHQ2h0jqahkUS0BcKDQGDl/28jBW2r3eK+UhMcGzvfGxodar76GKC7R8cq/Hzo/ysI52fiH8XPxuK4DgHCdYAn6bOvSY60hQ0xdhigUvtkmscDWETJjTDpzLp4rEkYDtKU3yElgyjX4I3gs6dYNDbPKk/+4y7UjCSlv2CEiEZqsJEY4iBbBw0BGhv0cJjX9HWVksZxQy8P+onRUQz+AxWW1xX8pQ4Xq5B8TP3xFl/BFdDIplEcxneemKaCrfjgVmH/xdqUtBTfgkw0lIA8oZ26G0yg1sAQYvattP78rY0N2+h4S16JM29+OvS3GSz5qZGYKKQPesbALL140H2rLwtzf3GgWy8KWSpBpWCvtDV7C2YK2jbVXp75gXcAh8ioAQXnOD9lDwUycyGFqhOC3xV5ynV867TxLcbLbBs1D20o/rOPfSUWKwTuijO1NQN9J2i5ZX+9lT+RmF6n1dZ/e/3Rpd/oUCOpfg1ldSAHk2NPTo19l1TY++cxkIBsFNi75sae09tasumxh6dWsK507LumshZHQ5AysF5GMUBb8NjOaHwrp26MGDdxOqY/aIswNA5RGSIyEwj81D1YC6fqnYUidPzgPDcTQGWmppq1mF5ScThu4a7UPIRZTA1wi2e2ozcVExh1RFjltdEYhq45XEpS2FgblldRDSNK6SmmkkUEoJH+3vzFFPz+9qeNZxrjCY28xlqyifqtkvvjhzIfkmpv6tUNgpiK51bwhysGkmntO/9QJ5aGZppd2FEd01dL5poLnbc1pumdBDMWvLcF4voe0asL1AMgM9QzRw24De7y1wVVEPCUv5FUye6L+yKtNW582pRayhtoabZ3Ld5Y9a5gzevdsGwyyng40yeYVtcNXmGkjYxeQb66ArCICQAp3r1dOMoYzaj5uDUsLsDLtI0pUJAgvSDXmj9iigzS74wXKjAC8y7J1aZId4Vm826+MdCJiG9/D69yns1f6GeVX29suo7ZlN2sZ7cj9YKpKS68Ch1UhHo9yKaIvRWq6cIysah8NXGIqQrFVm44Mfdc68e94CjqXru/dXXHN9z70cDP2M1LSWaxzyVHnzUE44VwQ2sTTVRAov3i+Hvvkd17FBzHlvGwryBNiBJMFjO/tTwgS5zWh61OWsxA37OoJ94ffZEzSpW4Xjg7FG6T6EVOP6VSsoZtC3DIhpXLG31jJtRG49ZnHGvyewEMITTlnV3jvjJgpZqa/J5kuijo9XlC4ieaEWxqNEfHS2kWMreIXRvmRbIhjlEiya8RPNleJFCEfrP4mPOw98cGdDiERFb6yBShxqwC5UY46KKSC1EtihFFmsey7Cz6euCCBadY0yKKacmVUvneGuBb/9lJdVA84rpRZkteawUmvwjt6qt8UAnctU/wKiDLyfXCgz7HLg4OSmxzLOS61jRvS7opt6RY548zndyrSTqVbfDqWtnS2wQxTIfE2Gi0Fzj6aih1hHEdH6hRjggm4TsEdgUXVnM9HJOprZwTW2aYbGRGnnROuMUYlNQWz1eabmOYxAA/ZQ8s5morqif8LxwckvlnGEn2rMAMwdCUU99ycMNgG8FYZIoi1L2Tt3mIrbqaJq/zyO7s4uw3VPT+Uo5ZAPnJ+drftmrGQP52Ii1dF+ZyMPtMr3sXcpekV+1mf8riPzXolrvPgHVupmBW7U+j63xsAjEif3gjjxEyW6gIBBE9KgPnisVZME6oLF+hGrrQutHjQ3XKtr2yDcYrruYAJ9zzJGhbv2fA7nEpt4ENqRPeliCeBBESfQhx4CHNQIczb68lj4fpU29A+QbNFKThABaOZnfI2gCQQIiQ6lFGD+8+HiBYDEppSLpU6UWI4RWvGNifu01+zmXFVahlZrUcsIv/rbDssHrmVfPvqZnVz/ne/WT8zIhntmdl4mw4mXCq/iZ8Mb9TMgNA/Uzgf64iRGhhoBiRSeMizlHiVCrqzqWGRPaGRNSbGYMkkEwfHzRUp8TUmhdUE9nj0+hlh4DpJHOHnmEeEiamT1K9OoyoSan0cmD6pug6qvY1NBH5gRNgmJ94rC+wrXhYXE/SYva6PfXv0q/RwaVnz1C2ey/zLU8szeKIDrjv1DCziLKfOXYVvXaGxcEh+cJQHDH1TgoOjQP901DPZqGYB7cfPZxMaKeIsm5RiIPwgJjTaNoZZ9CJoqFCb2K24vsUfYJxOatFDondzaxEFJo3FievndIzXWu09MbEW3ycNlkBo+ris7+IgMjPutOMQXXbor42gcXIzcrPTl/bKxDY4Zb/zJIHLj56+q0rwv77VDveVaxAACCxclnaD7v0CxcbVIHIg3juwQm9NUwdCK+WsFFLLqb8as0T9kaWjWjtorZ+T2+4YBQy0SFnThfPgSqmUnwIIItBPXgIuRgTVe5OUqy948c8+VL5u5IVMxoT7m6fuuFNPtcA04L5IjmKgqEVafxc6V+A7ngVb11bDIPeaUrq6fxQdCS1pWbuuDcvGaEKrSk2kAdFQQl1MD3Bz3sxgTmTYxz5jzMc/zV2vd57uUBCR5G8AUODFdJ8AELhkQlDrU+v+hsyD4gzN+MqhYkrpDQFV3N/kHJ3sHhTQDGB2IFoKu2FS1MqMMvQOp6dhS5FW0wVe8P2ZopD3adraVdU3R5MN5+/UiGL3OGLeQSuqI/ForOXFg6yOmKm9hdPpq9rO4auga1OoxYbtkf9YkzI2g3GqeIZ9HQ4R95slHw8xkQDhHQdWT3p/3E7+H59X23zGpNwzwiThd+kZ/iexqlMsu5KCwn/GtyTGxYzhiOQVAfWM5FintFB7UqIDJ+3P7564/e/dqvvPmVQI0SPAcj2E2f0YoKnzDo2YcExoq6iwaVV/S0ocszfMOZ0xGbVMO8R4lIKlYpgUBlq2hniDk+T3ZFi0zqwJrEsrGqI/ZdEhsidh6x6rSfA0I4sGeS6GI7N4lNdEMOhK1RLJHzHFPQWgHcsMeuX+WNtwpFuPZb5tfIQnyGttuNHhMNE1Rw0zJtyT4svY3htOXOecAqFk8tt8yLklsmSJECmU8PMiRzyJjcqylZsi08+QZ1HocGbbMNQkgbFGiD6rZBnUcGprprVefRtmqrbRVCI62ar4Bp5mQaFDvYxJs3aMY1aKbSoBSu2bUlCFXOljpVH6JJ1WtzywUjF2zA8Htptr/iFpUVpXqFqKXoPn2IzVuD3zO8D/IGRbR0K7aycxTo+jSAj2JMDZnJvAz1QyvV79Ki2fTTnCyntXJc3BziD1THV6GBHuhs0clUxGPJAaUKsCIkD1DMfh1Au2OYfcTIDlKSO7FDwso7uIP3OyZpDoLMe4JcjZAFeU41pfXUzX4DOaouH6lHOXRZbqUlmqvQSCTN0dIRF4PqnLPGIf9XRGAwoKw3GHDHIRkStTrE4v5swjStxTRUPQSbxQ2qvOAF2kA7N4R6l1FgXaBQKbaIoOJjyPIs6PGsUkZmqOze72ejyDBfL/dKDbGocr+wbPNEoJZ9QBWf1XBaHunNyyJ292Sxe3veVHl13Vz1xnOPXqi9yzPvR23gmA3c6261ypXQ98mTP/H1edBcn33QG7s++4DJeKdvSjpkA7fg042KSm1gVWoPhbiGHzqVWtOqyATusoEBAmHFG2jEdyvt+8G95IJX9txC+hC29drjxBSU4fXC2i71gUcinK/eaU/snXa9uM3elMnTQ3SgKoIAld/3sveabINoLTdSoXPNjrO8/XxmcInaetqTR3jszfV2+Eci8Pda3Zu1HICoEnt7Gfs2F4sDEImtjcf0D4Zr2a26K4nNtVZt0+WyI9BvvnNERTtg7FsrWf2QjPbRkfRYGMwCUScFcaW0NTTS1shJW2Mjba3Lzi/pe5SItLUhMv+8iRqQ5CSt0E4ck7bOYK3uTJO2xlRXaWtILXGFH41JW8Pp0lYo561pYj6njq8J/q/AzuMxR7OUVaWtCYSyCEgWJWb2iorRoYoUn+ZU+2EGSDbbvykytit+U78Qt0S6I50TIjtP/Dw62lB4lxoSUkB+O+MpA/6dxcsifDmBUumpifAnUihLZid6PyopQg6AtrNpjlmsDHNIKuZQdgYIzvGPdf0S4iQig7ebjBrmjrYSyjYi29RClpZ1s56OSxXT37NuRkWgqrQdL+LSb9LlKHIFE7k2dz869YOTckWKD8OxD0/CLelfTlXu18qkUOjY/hZKhbK51c3+YmnoMtlra1vXC2oDvEOlswKNEJ3jEOSkAYoOi3C0cGg1n6j4eKx4j2BQMgIQIwpNLX4L/QvzUNQUALDYAiygWEFWxGOVRxBPn7gB0WgDigj6jWC3OICKRqE7LoxeSiNzLuDJM8DTkabd+4uGzUzcZisydMzAmx8KAMym6u90xYbGgSLtE8dZWUF/5xq5l4ugWhBnXzbbthhTBAcFuSpAw1b3Rh6W3Fr2JlQPSgYpPDU3nB4EruBnb8aNsQucqeEmuAP+0UkiooeOlZ9lUhe8o81qXXN9nPB08oVgr23KPO7aey/mJtACN2kO7cFZAvSMMXFDzFpzXmnrbKHOllTIBAV+i+YBlHnC0YwTW3TUIV8hZ7tFW4UX/NBmi/QmD6WmsFoHCm/bYWxU1cd3UYNSXAprUAf3fbBygoA2oH4RqRZ6vsivQ9UnX4DYSI4ZQWhU+qGZE35kRpt8RRQrxZcTfnZD8FHwsAq3y43rXNbLfttpW+7mlNYB9hkACeGSasxJaRQDFTL1D5t76r9PKGamyABaK6OxIKiftzDyMxgSxw0uBxPsGpz39WgGkqVlI79q7IXv6BZ8R1U9eiowlbepYM2MwZphBcph5fwmNDAHW9+iBZDe5Urysh3dGKPrusMNn+0rfhVz+/N5AQbFgtxyP0/7qQeZGde5YHELdJ4HvzroND+CWPB6j+VhAcmMY2jArDYglUKLpgomm3JdwLEhDNIisv6zdQjG/OuGFI/513WwMCKLcJjPVCFUhMa/7owpORz3rxucpGfd0HnWDSk8rmfd0DmyLd3pGu3tzbzphtLdgCltVbZqnOnOqDPdYpmWBxWHujPiUHdm3KEu959mwL/loXFo29QDrTY1ZDejatKgEgcE+1VWpXmaLs9h5FFzHiPZVJhTTpy6Wd66ghaZakVbqqma0+jZWhmB7coWaZhGSdBWnKhedrGCiyRoXoJ6p+V6kHP1qFnJUsKWpgBa3ZahkGKV8c/MgFW2srM/nxN/HQWLpVnZhXpAfHbuiEeiN96Axddw5Vs5oLMjIV9cfFxTCPYjc8GIz3MBczCjVELz6nsyU50Y4x9E0H+eoSWe+vOZllf1oOsQOqQMjOiMqNQdwWC2ldou8NLCozwzoGjg7GVTeOuQFpRXA63OdFZmaM88HvPUhBH5pnp8pIREY3UOjznyoejjU4q31E7a1cqakAjDu++Gu3/7hbv/231mfVcqs43qtDzMt5eYe9dFQw1rywqelKTERnSRcgqdTC8vqAkZxQ7O8IpniRuaV15a8ZIIN4zQhlESBZV5yBbUP0tGxkb4JdnvKOMGZibhNbHwGUKVJgbIdaOn48+dVCK3ivcr8lk8vjOfk5Lypg6VOoTg3x3oOK++tENE9rHYAZhDP9rCGsOBnVLGfgJSGwqBpJlhOQ7FAsZlmvmzVk8yDxlE5v49Kmvr8t2sfoPSnPLRPMgxtTBKLXV4INoiy6hx2d0AyqMR3FIVLV+3XKNSjFlqwt9S2TKbyr3qQULEHUM7BZGAjdTaWJc2Y6d4G4VGiQNCKoigZgSxuYE+sM80uqNammgnU1z5GpQK+ZWsp5RpzkzASrmo4PCrgWkxc2XR6uUZiicOhI7veJmugal8qocTB+BlEd58FDewg3ZCpCGx41CM0TAPLVlolVL5ptIA1B66sbgVFpE2Z6dqVawGY2uu5VNY2mU77BVNc8WauHJuAXZzM3cIIRgMDRpwjxNlvkBgC0BrMBSxmRNmHR2AAAxHRF1DaeWAc3Zh9GmgWuP5MnkYG9XYUC20Rn93afvUZ2WISYWO7gsvKy8Lk7xjxyE+lXowpaX7AV9FnghZkScFmMzBiI1ofMgkx+hX4G0/RMURtNxOWMwLtBhz3N9BQC88QLprYrLfVR6PI3/hEz//iZocMLsOSfMD3ed4xH98vvzzyMe18OOMS3vZR1FA2cBH37rsY3qw+7moIWp9ZpcSV3cqB/39RV3Bb8/OfPKHeSJEJ0IbGnjUCqhEuXlaVRiSi9Bu8LG0Wz1M8vTyxUbe0WsuGbuEyWcRvtHL5+TUXDxzLlTKg3rWs/JFFwPfYHX4VoyNgKWO8ziKcFY2zw+hBhB9NPVlAGMdQ/51KpYuyHeJU5Exw+pAymJfuOvlvyt7D/lFAyegfLlRS2fk/NUjKGsw4rvWXt2N5Gq6c0ETGT/jMVqI7+cok3ZzmPspZF5rgLnEDK+6e9EyEy0zRJmkxEl0kRaB4Jg7WgWK14oo4uJgccM1GZAQoIoDYrxu2mBa5nHBXgDzYgyuchmElnDC2qK0rE3l+K2xcsA1yzogz3nw2lhlRP1UD2ITPgzIU7y0VO0tlembVC8zivos/4C0FEvEFbNU/A6OUaE8tZzoXFSihwNY5kSLSz8aX/Z83HJW8ZvVvCR/9GBANTCMcM4bTSuiUQlUOPKqX90zUSKsBtwGj1d6SVKzHZ0snOF/WxERPyCYp1CesHXHVMNVXAkypoLbrzRDg5qo3w7S/2TMtRxWqglSVyOvagUPpmLJZ1pZgxnHwgfC8E/i8oiiF9U2Cn4OCrwc4ZLvjLz6qFaYClrszdYQvXItwt1Tb0OORQES3UsM3RYhr6ua1dg+yidvbB/lrn2qD36hR+RXcMU3+6hEK8n98X1UpAknuZvy3W7KJ/+4uyk/pdgRg3JDNcTJo1vRBwOKXXO1LUfySPrvLDECqSZ6DZAkkknjv59ZvJOARzwCj0REBBV4xBYe8fHhEVN88vCIGR6J211SRBalkqNDNMqf3Pf4YulmyF0w3Pu5e4VR3ihsf77MzfXdZEcxQ7RJsBsYx12HGYyhTDAmbBvr6Q8/7lqUibkueLovur0BZ6voU/7eCfQp/ykI4uvq126mcBiUioxePzgAbkC8kxL/8clEpDsHke3VIRjZnyeVM1mHDE0XTCGFHtHhJZdK6fqwaDp4pxVIpw7SuLAASLfJJ/67soeIwRBWDSx4VJ3fsusLe4ecpTGAKpYY4xgoLyDOLlVuFYoUwbUk5OWfN0PrXJM7jeYWMfsocTP4HtUWM6LNgw0nLw1YQmrUsXWhhueYGhIK18SQaMyXvLOx6rLp1WUbtr52WV9b6oNE0NTR4ti8hThUj0UQ40FpWbreJxNdQnsbNz1FbjGKwWtjg083iVgDwLSJwl/6I8FmuszuhnJgVZIhRYyYY3V8scaFl5m4iF8P9KGJiutIV/MbB2W9qijCBqoI2/KhpvdJZjg9Fq+Tr8cWnEiBcKKfQAqFypGypmOk2tJ/pGcG4u7pZOsMtU60d1TLmvUrvf5LXgjhZx7ZiRAhd0XXWk46qrrWntG1dnf4cXyqD3dRN/u4HDbq7ZNIWG+koS69fj6mhf0J5ZBv84JAOOTyUi+GMEIIJkoidAgDa5PyWE162OxeqUCCc1Uo1kN9D1ejsMKI7oburXUbBFYvspu3Blbshtm1xbguVQdK1c1Fl/S8qiqlIJV2uXJ7fvIyQipqnm4TAjXNj42red4zXc1T9zLJhDry+05exxboqTq2imqTOrbIo9sgp2aryBco8jk1298fVbO1pDk2pDkCcZ6mcBviFMfgWWCPKQJQiorabXg8tduYo4LyenlLtW8TfYR4SFp27Lhqt3+A1Eepfv6H4+rn6Eypfo6XMfXzvdPUzwtMUUaUtUehg666vjqMVV1ftER1fR9dzz75SHu2u+xZmH0KH38devK9VfHDY7ERUYTGSoRYEgHTwx851Wk3J10jurYRL/RCme8qFw7sdcfyxpXcd5Snr0/YEzqAaYAZFzM7IZhtEijCRNL37E9Uj02Ia6zU5fZ6kDLlW7hOLKep0vHz9Fqo3p0t/SRC1kgRdCbqeiyHM0LZ5ScI7lTbi8ZLQEvVKQRuKbXMTqjANkQoWACSAPoK+ZK5hAm5AazN5jMU5R05QPGoLYOMZPNgB2AwomVM087gMUMd0FBV+gypjmN0FUeil+pm2Ncq4VwRRld/6qoipoy3Rm1II6TPcxSqC0ZEz4hypsCkqJN8QDNrRbq/MOoECzjh4i3VIjJ29q/lS2ICNsXrMgvbuwKMYgtXLFmpxezJCvpJHU5uYOP6Vb5VcE3e434u7ucy4R+d6igg2g+RP0C9Df2htjhaWysMnLbbyP39H1rTqKZE1fqxeScu6Gu1y8S7ayhZi4Jm4Yghwdtze8UOqmvWmNDIFX3ZKewLV5UqvHqKhTVKOJLmnrtChEu8MjwptS9boRmeAToEeHbkQnnB/VDhnkc7oZFLyzicmV/L/lRnLuCB4rsU0Y4DGMgGFNalWEzmmeMOth6otowhfkAXZS2NlLW6eVnXTkUc3HdU7Ey4n/IolOvK+aXOebfn/ORJIOXG1aaVApYZFDdjUE7ZB0oMoLHx14VnO0UYxAZtAyIQ3oj4PAfDaFy7BDo7L/W8Vxi+I3BaHKY3RYQGhCQPDw3w7EXHEJ0MyUdzfJQ0nTGtjTOmR+CG1r/WaTFE1Qvqd/mFu31yFoDgLjZY1UTVpslUK2OhqHM/9FNU7Rntp5pl9mTb3s9gbigCoSeK1IBTHabtjtVeyPcb++FLId2kSK7c75TQWRzqqvFJVABzyHowY2gleKwulpk/l2UmEVU5yMqwcRSHLkYObclDpOeIKLsFeETZz2DVAC+AWJRmbMpw0mcMEtdlQcDDWKQJ1BaKhoUZlIvTASVqX6UhuuoBmkEc4FjzgW4f9CM0LyKtWPXouHlORn5838gvmO4bWS2rVj3NXl3EQu2cp9krnKfZlz1mT7NfHDUlEVfNjBoo/sVUW6B1uaU6Ymy07oyN1ieNjbp0SQUgH3E1wOTOWvnJfc7wKEMh+6wzPFqXsVXDAhj3JPsptQYqupZooOZT/UNYGb0Xyzz4WzUzOoIzkbu8NWpmNOSmDaXgSJ1wIXte5yeFo2ZGY6fM9kvNCNL91euCih6v53aX6hltzMzl25yZyw1n5vJdCDoJv+75WHYIpAJ5NwwS92kBHctkqmLKU8xLolwa92GsTzmDsDTMXEOoWSmXrxqbFkg5FPJXzPmlbEOH0rNrbMS6RinoSKukM9h9qbstfFh4EE9I3kKuMzWQ/1w5UG1j+cGapEeZUsUqknerFXxq5TF1jHED4VpQuJXHK2G3BgjcjezyQBaNRKmtfv0l0PyEbhTO1+eorSca0Fah2QPIuFcatIgW7MqX+p7I8rv8t0UuW6/IppRhf1C0jRep2485f49rmZOVrQfmwM9ryMt/W7noFW4VvuwoDWdOYZW29hNhD1BaHnM1M+a42qft5HE71wp4+dnN9zeOYobghfjlLvuS8ctAX/SaBwuVt2kF4h6fFPVxzi1bf/GKT+SLekbNOsa3bvCVFbDnIx43eIZRT3oxI7fJa3JazIRY2R3wDa3nlKv6Cge179vwtl98xsfc8Rnp0TZaoXjtUXaqQzMTnQLUHnm/0CdwErFw37Rd5+c8bZFRiSsAcxVI8bC+rSWj2GC82C6K7dKyQizJt3BJywqxecYTVefgxywt6Kk+8LEAtUllOrQDbCE8oNyzc09A3s7jKXr4eU7cQFIjZJRTjGdRPPxFj4qH/8nTfueETa3OhEw5HR86taivFaQMhbafThaeU4WK7AAs+p5BSBJQ7uAQ6BED68Vyc2QHefwqcOMAOCt0KKI2OnKundysZIv3vQxNRO2hBoeynxRXDTtwhEQ7WOMoSI10juoyKiBKnrN48h982HaobLWwSa1ut0IKlYHII7wq47IGBX3nIaMq/0vf4XlRxRRgrGtIXY1URWeLZD8QaghxBEhoE0NZNQ/YFNXxxrcieHbtbdBW/5p3DV51aeFHnH2uajgwLg0HxnhVkw8wHBgjwhkOxAusOY8aDrwMVu/utoYD4/7t1lhUjAyhDLeaw1E7O9KN7H5rTJSkOgbHhB3Bv3wUdgT/j7P19+40Zikb+45rXus5vvmoV2Gc+9hFg6oLh8wm46uKqFePvr5AM13hjLs/T20G6kVhsd2Ux/JM8jqQ70KgiMgW7sSzbq3Rx8YavXgRUFuCkFDpjRmAgqe0PL/gMU5G4CZexg/4JhU5mLhMi6DWlv0tvjVZ7acNm4NvqAhn26xYDE8RvSHRLRwf60ECqTuykhyIjcdeqRe1k9dBPbjd/6vqdKBIs79D1eIYqcgGNLPvY0+97vvfMvgc1zFLaWnDfCj79w094ZqmE7bv2y/74G/dty3ey4cbc9nfynXuRHtHMBWNwlzz5zUHuI6FjaJtUi5nxrehV0U3uIdtnHyIdAD3Rjf2vXzhF7/1z3/oxmqtxeJw4HrbtjWwskx7MhrnuY6tprAHjSUoHkjfmPXilgzdZymsXh8plihbf3OlRr5ClrG958LvkTiqWdgYMuAz4vfFoe0IWHWrVyaDgD3U2OCw7S6u3HUdCuT4u7L3fPWj+ICxlIXI5/MK9Or6pdfkvnU95Av3+6A3Zv0OjlvFh56nHORDsktRw3fZ+280JeLkZcmNB3XQ/FnR9JjjYPZFVC290+s+GUI+l4OzM18FV5LYh8wIBHofngc4cDUCOGpj/DpauwwtRcu5s/0k+7GDFi/OXVNoWB3p9ew9SKMIaejTQ6+HXPFdgqU1Ib+XYA8FgXSwV0mrlcfjIyz0/d9+A755R+Wb55XfXD76jfRBW1bTDamfbWgL5LX/8dePl0VlWd3x+vtdtaDFerZ1FcJKkeFokW96VEUqIEW11xUIap8derUraXdZ0q6JkuCoMcJeQfb32ZdvlCKgdauJ/ffcgIa9WW+2a0r2JbP+1ayV/+nEhToUZH+PvCkGwRuzlnj7NGuJE7FYHFWmDAn0FOvP2DmKFcUv6D7R7ch+3Rv5wp1Ke5gbYsDVmQ9E7Bemxt7rYtX+oMR+fGrs3VNLeN/UvHdN5PWyH1cXd77rBKayg8G/+H7CC51bvbFmjlqLKyIJK3lRm796Q600lpTHOs91/4sFLY/UiHRRt+V07ebR7Bzh0ge2/8hTV0iFslbWwlxDW9NE+QnUYROtXUzsu/oTsUAHbzOIa/uIEu5IN++SXz+bkS/qhMwpMkPZExvwiDgQ4TwPAVBFLcsjLIvaN7nNl2q1pj1NdJL/Ulc7Ezp0M6Ykb+BKboYuWyiASxvtV5reE/gVL0g04sLZCLXUuXDF+S/XoFeMPGFZjd2JLwMJzvO/52Ty/oM9qXkexFNZ6f8bVhrC46y6uZMZ4QDF7QM8ULeq1pDTIPG1uFJDZlgq2Az2HVzZHn/tF55+VPSTNrm5oGWTr85BnZYNuVc4HNWLDIleZKhoKFHiaj5Cyfhdhjp5xH+8s/BS1+ZprckFB2IoVUXwjcL9/Z4f+fA/7Pqev2OwQVkJ98nI0iM//b7ppIXMopn9I8ag5Ob+CW+od8wsaU0vW+vtBDB6VWL02nYAxc9U60FRTiwX99/qrSlrJ4yersgPgibkdU7VDQE4PkaNOHtQuP9E24a9jMpCQ/zILaakNCuHiY7xcDdrYYYAKXo0BG3HlBENJ3K68UIazo4yMBMQ6IidTr09e4Ra6w8FeZZKTbhAm8mEB5mYNbXa5iZQI5c7v7PG3B9x4LIet/8rpY+PoiklgWuy50ucfRZBEEeuAlKgNm7Qu5MH7WuGsvWQI+Zb4mvSCq1RIKdNOWgTUJukPQy5Hq575HPa1Gt1q/US9dAVFpm2rK0iRFyVMBeSmxxtbyJTDTJ1tHBWYrEnXlgTsefMBthu504BdgZaqtDf1tu2jJAC+/vr48DX0hYAbRkxdE4WZ9gAJJ+LFdm4stDaUOowSERBXY/RcNqTWdvmGlY9Zd2Pvgw/LwF+gS+IbT/O5aCrGzfgY9C0XSS2BGkRwseF57y4WLywdgkUd3EucPU1RRu+z6X2DmJpgRZ7cJKOcGc/fKTHuA69F57Isn/WSaJV8oDbrdCCYRRj2GxqHxB5YZthpFY30QVqZ3+HLqsq7ZflRpHabdSbBvKp4kIH983mFBfbiplZam4go6AK1pAW5mb36lr2Lxo01sRWETrdD88PCDNC8SVRfBF4whYwBshRgHP5QqH20ApMwX0Wy9U4kKaJ2f7LVsUnVHu6nWcpBICom81V5NTpjJ5jPgJH7eQsFu2UWkCBM8DWBQEFhyq6aiPLAailznm526FIsehEs4yF69DKwi1LRfsZxk690oBl12ww9GtEyy2OzE7kOQzEHEk3O+VY6JYhK2Z05zDPXbemkJbwUADMsDXgItPbp3N424Ofc4t0DcRAJiBqoBThRZlDviE9IHc4Xqzct00hUU7leipgh2/5YT6byJ0hd6a5gU485NzaeZXl6LoQ6rowZePVMJuuttl0ZUBEt+nCHBtHpFhRU+i+MoeYoKOvTX39inlNRl/rI69ooVmIVtV84yfwwlzcuz5xPcv/E6nKSw/HYXhdCOtvVWdVoX6q5rFkiCIzZyO7uYvM5s5gfYicnuzQsy+9WmMOZlDWuEMFXeIlBgQ6Ez/2O/tmpeMICGtC4kiqaOSWDMzRi+29soupLmYk3F1aWfMi91WqXsDWcB+i6kFhWBYxdDdqxzULVcf+oNhC1ZUErGIlT2IUxfqZZMHJjJBgkP8D5vZw2559tBgpIQJWI1Stjbwxag8om3pfuNOjxjruQLk+oto8wtnJaD8jiBxGOsmfVnqnSm+jnXTHKlSnGWhXZpXkrDzpL++kZ6qgsiAmZrHMl658EgnhhJifxOtCC5CXgylIB7OHXuPcHD6sR4ICDFXya+teZMRVP4jEqiYrNkwm76skXzKZvKeSfNFk8lmV5N3VZAornq7e4pWOa7KvouGTdiko0JTj2KJwmU7K/gSFmvkkbE7cGQXhtRCkjx0XMmwnrgc4R1Nc6IZTl8dtCCPc+0e4HKzuCTCMFFuePZjk2SMKhkfcdbqjwzGuPaBgkj8PFATGGoQTJRZRxdJFXeFbaZocqiXi1M0b7e+m/fSq/WzQeN8ax+1b4zH0DT0hT1R3cA+VbId0++GpUeg6sAD3L8b7iZ224sQ3dE+xI5O+FgkfPMv85gD6NImpd/lePN06ilMadRufQlXr1CGosahep0hvYOjqBvLLcQkYo8Qo1KEwoyoqeqnZ15TwjFWhRsJj632lrtVEelIUWyaqgIki6wbCfKrHKX7peSA7KKdedTSiXnohHa2uqMtOUe+iearWoR5G9OSkpU3VtbpiH+dKIT2qyeYLy1UEpf6DSlrZNq7ecBQwM2qVuzjViEQ7fafBh9ZDe9KpOP03zz+OkefrX1u9Com9D1ejHQOXpNA25q6R4dq1wlPJSWjMPh8OvGjaqFd17Y1ieiTbxXhE1z7ioxyOhaxY7MjtN23QE0GZJ6HqAas9opE2RKpx72yR+8BV2BY291dL28JRaVs4Vo37v7ihVHoeqbd+4nqhPISWj2rdx0y99+eeEdGjSAor+vYxmlvVt1fhXtXkcCilCmD1UYOuzA1O3z5WfftIBkqPyIKqJvRnkbeWvuZxvqzDiyU6QgEHqpd0fuS1x7+k8ygV65/oedP1c2FCJrtZEVaVcQ2Kf74VhnK7ILl2KiLq5iM0nK1OsAp3VefXxFjdX8AkAnGlBp92IKa7ZnzUUx3nM6BHFMLqhbhc/IEX53jFdsG4KK7cGcLukoUFm4vw4Jj3BeApIJswWkM5MPrkT9xEBOROOV/Gh5yVFox2MrQpX6tYBNArOClb53VRTczP6jKkyssxedokitUkRdGpXj/MpppxaU6YcWm6Bs6qNYJhzj/Vczaaket2s1pd3pSTsMp1uxl73W7m+NftZnAPqWi663ZNam563W6Gr9s1U+pMvX6YyYfu+mFn8vrhjPS/M/36YVUta1YzueuHJ4ZHZwQes4BHpwKPjoVH5/jw6FDn5OHRYXjMVgSxMzRbvX6ITyc4hqYgE6bKYAiX0lfguNHpNprQvr0DiP2HfM7MFrn1IlvbylfRN/WXslHUN58CVeTuuODMYxR+A683E37PWOG3Pyr8dq/kWxYsm2TBsqrwOxsXfvsMX/5jCjNThfmU1nAGudAn7fGmc4sdqjt0hQ2UCvvvjUDFI061re5MtpoRDbiwKePIKDXRQr3qh7ObzmCgSDBLbdcgqg8dLODVfFC+jmi8MnLoalrpTN5U72JQYVJmcaOwyTulaKZ1vmzTAgLZDmEeoWKTPtwQaxkJxWpK8wEVX+gd0TmQcOvSCVh46bhNw3tDL6pe2jYrHBaJYPyqNix94JLI5FXt+JFf1Q6UHYNBsdGryaHQhqByVbtqVqy8KE7h8WkDN/bkryaHelU7mkor47Gr2tEkrQzV/MWJr2oHmsnRyhPDIxqBR/CvdnU9qMzbkIKTuart22v+pRv/4fPT02WDTNZBp7rXAev832Gf6+k/0PeyG8AFpY+7cxsV6WJaVPm8Vx2fz5t0eKGMaPUm5OcQsbnDi5t9r3FyNx+LkLdbzruIX7n56HyL+OO+RXDe+qDy/5Ad152cErebcevR9pxcZZEw9Fpu3rB8fUyR5et97FPRfvL1ZoICRncNHjV0TxghgzxCPCQt++IN7kZjMHGj8R0KvnuyoH5dMOLoNtI8wV4cIaNxHq7P1dVrXCJ7FDRVN4/6n0WeojkTx3HN84MwtdqWhd3SIZxaI7rmZnTTvPPUjLCoa6+a/GhF00swX+iRQ6BIGJu4oq0xrp5iRo7oqW0qaCqEAD37sTfWpHSiSbKL0iZxnVpYTQtDa1NNcnlN6SPNJegihK4F8lGYKjQrPVVsrHbSddOb6GZc7aZpG5ROc0/4e71dbepsSRM8p+6J5oueg+uUJiYuUSOcjoiUUq3BZefOxDl/EVBa7TgA4SAaaN4E/EA5BonrWcv2NR39Jq1cI21NGalgbKRAQ0T7X4iD3lcFqMnPbgSlafkYymZ/+dsEbqFeSTGi5VcjB4rQ19e4D2JVsxO66eMhGV4r+jYCDzVveO01o2PawKNTHVPUfT3O4BC2IMsmxrc5BY09cEuAXYMyPCbhXatWJ1/oeOLDqWNuYjmUSTbNPdZumqlUnuI0RJ4BJZW2O4xNMWObSJod61aIIqd0q0mZOfPX2pvV2u2nWaVb2vIQH07rFmJD7dasZkPLxxtMM65ycGWmewHVp3cLjRjvUbJJj1JpAtW1R/rxWI+SKT1KzIdTe5TYHiGb9h9tneyRloFtkvZIqx/rkfZpYpQU9NOJy2zewdxIBahaC3pcxQ47In6VXqbVwUIpnOzyz46V4srmX2H1VTFEkZVSR70Ax4nZk24+e2rV2TM+0fDpxOzRyqg2bfa4OWVBURuZPenooHD+6uwxpKdI1TAVTxl3SI4I94YeMPXRHUloKNMhEJ4cletRo4l+HaLV5kxAkdhg9eXqQsuSrybner18HAspCmGDzLORz1QCLxcQeJDwxH1cjKd+Cygpeyjf5iJR0la4PcyfhLGa09Y/NEQFtORXly5jUCrS5TLRWPV+MUoCU8XCOjUEFnmC5uhSDi4Jj2h0zbVFxJOksPxQTLLqmErZbhU0FDFxLAlJ010jKZUSPeQBq6aZmnmSSoeCsbbYz3Q7b7EkmVaw64j7QqsxHzp4ua5OfDHSeG1TOPZRMPGRaVFoqwlGv9CGhqNdSbQrYaUrwVhXktGuBJOj5o91Jah+oQy9+TBN7/aCSPCqsokBEgca1pVX7ahGZA4Z9KAGaWFRt0iVIGaitij3wd+i1jVrJQJiGVST+8A7+Q4rnI+7YI2REtqY3/yZ7r3qghsR3iPGWp9i01AVKw+9IDiJnmgPQjRC18HIGaTzp8ArlAtrhu+vgXFX8lLUcRsLM3iiyXWK0FR8SuFIG//c9yLXPsPtFyH4/ajvXyJREfH7S5mWrYk2gCrYxGy5qe+/MA+1LQSDcm8QshEiV1gaqidPVNJuQhqONcOKNjK+VncjOpnNYZtzrVSbwK+QzGWquj4CXI7J3iilo2/OAzVaLl1QRjxGQ4UkqJhZv81+GF/qNfi6FC3XeUtvkbGtTs/vsB7rdsh2KJayUdO34fhRTTbW1dKFekn9gB/4crqAekd3A262Qcoj7awsC4ov2vK48EktQkkMITuKcqDRe/KCTpqKBo9mUaBIQTXN5TZfrtJKJkKKbmHFnJLbnAL64xUV9WpV4xUUcaUKlF9qdulss+IKBTzIv14ZS3/bDzxxOEmB2zNWYZczBuiBOMwz1XUW4sQskFEbQakItYPeGtf6OBzWQ90AzdCOuMwGrBgAVdOYnkt74muuosHvihe+9bpizoeUylvgBdrSeLKBo80pktGqUAuAZ+pIywmFhwEfoKqVhYq/jQtrYfpHSRCKRKDv5YE/ZZM/E0fR2Bbf1yHU03bbEH9i9Q2d+S+gSN/rTC+iyhuQP7b5TSTGVQSLDDoxTQ2xuwhoPw7H2hRNtAmP0LRJvWY7TkDVezTN5TbljzRY+IfAtcF+pdQlcp1V1n+UBxpvrOupV+2ptk55ID3G00NdrdTwMJ673BE7ptV1C4mJSzS5tSjHZbkaXPZQ6DMmZ1TtOSDhgOpr3sQeMWt/Xc/qbhkb+SbSakLtyORg+RODdfx9/iiKhdoKfxTqYVWGpCzB5vjlOZGHX4G2a5avAK3AWnvlkhDhRgYlTGQLU+lJEVuGAKJSMbWeGJ37kIQitBxAzeVav7oOppjAuvYKH+Pr4AbCxwhrL99h3gXgY6KREtqWbwmweWwJbwupKLcCKyHoErevk1qv+3FuiJUvNtc8NRggX6c/4vuh3tP2dbn1wRqwL1CuHq+eGSIPbVUnNIWIpMft9JLkwEs/qa6D3HiTsYhHs2qsY/kwdRQqmljO8IIb5pGfB1qvaUUkb9GUVvgn14pESb/tijKE6ZsrfF+gIKmgKQUGPNLCwh+hq+GU9bKooxbplp8bUbCa1KEk90iLvG7TIuuypKvDWw68x/ej442WWj5n6OSxHTlMJkCJ20X+txvdlDqQfAxyiPNG4/g4Mk5d5tGWuTGs7g7Hx9CuKoWHMfTQvkDap+AFfkurguO0KpjWKsbfTVrWsOOq3dFNYPpTHuunka+ML1DJ7EPUQkkFbpiz8iH3KlTLMwaAEQHmEKaCWvDDrDGEjJU2IyLhz0fZNx5vbGCEQcXAmG3Ts0WZKf2Vkzf/eKxW2n981+c+umWK+UfkmbD/+E7Oy6C89Z2faznrj4dfW7X+aHV9ItX22cTNev+u614olmS+vu7Wf/S1x7P7+Cak1tL//misI/4Yvq1aR0RvnHlEvI3bR+xPtfyIDx+j6UeMYNVUIYq0tgr/biVp83VQ3VCH17aui15u/Qp47noiasp1Bc0jiwk4stb2sAQys33CtW7in31Ggb1oqOwOUXlKAe5mI4+m5lBc3DUS0+aYVY3pxwdkqVtDkqpHSHzRUb/n14kNIJTvU2cjz8Zdp83KhmSWaiOu0zLnOk0QFDYRxOa67kipXfpHg/Nc5djmze2QxYomjSpRuohMbinVsGgvClOEyy64qjHIs1RrQmOyIdRzVD9ZDcXM0YJzlUKzcG1gHW11kEHZN4gJZ9C0JUa0sZ6qNSKryKbbFhhUqqnMr74LEcaqEnUtC5QBY5f5PXzpCIDqUA0zQELTM9e4rOrn3cGbXPCqnjbJ+WUHYIy6HYo+d0pLZm1LOtdsbH7JgvOJR+Bd+RY8KF+hzCT0TljF6klWsZpyoT+qXTfw9lWht9iK4nu0QrO0ZTjAMGb8soVW8bIFebK8hgdshy7l87RVTBjO06zgwgC4MOT8tfJlIEMNzGDEwaPESGfWEF0V16E6qJkMaeXaB0fPVi5fuTSOp9nhOkaQW+7RVmmVioYyacRw1CmGbQGq9nVfO1YPifn2LeO1bDlia6nhzflQBowmq72DZo8MJytEX5doq7oL1Xm+rR/BHJZOSdKpvgAIr+Y5t2ebnL3X5fRuGy4YCgJshx0SY+95qyTRNvAvxf58B0LX5DtpgQrUk59C2zkUcuhUnkGn8d8ubK1B7BXN7bM4na0dXU4B4YnNd06noXGFNUl1NQWlraoruB+7pB8SU5xOp8MC0xkkme3rmdy+QnVQ4ax/jha1QK6+Fl4tFy41fAWHM07fpg7yi5rk8yXtcsmn4b2Sb4EsRyC05+GF/CzcqhyLO5uC/gM1QF+VbpnjZRw8Mz9dxqkm9q1Op7PZhhTMR6X85vP7WfxOPhJt7Dzg2VGv0VLYURQG4kln5KcTMJjr9uACu7BCt50YlFPpVABDO6td4TK1v9obtVtlbWudUu3QSTUejeVhc81/xC1PaUe+yA1mtFGB2Ha5x4oxqrnGu5FDnOuEjP1oJ7a7MZRyfHUCpN3ncszIVsvhFWyinG/cMd6mMt3T+C0/jXZhQ7iLtlpB3jY1F7yNusYrJG6wCVg7AAe6zeURddz9y9kKBYI1MeNAT+dhjcSPUtX6WEY1tHbeWCrjlZvrBmzWZOkF1dE7abapXbx1KbXIuYQ2ztASeLKl6oUvIUJKYdpUQ3JtJLlVJrcmkoWa5QtmWVZDhiF+amKO6I7sDbKKb5OlN9+p48ZwWrC3ALfaabOAW4Bz/Ki/REjWEv/BRLBwWQSKh5K3oi3b92P9R23jZFEHgmhpLd+FVqhlt9MCYPpptE0Hp6BdeUdpE8z94ouiRLE8E2O6C+JD1ld84mhYKiqN5I8uaPMg8vPuhnVnBGVoO+K2C+IUp2mcNlBGkrYZC95zaAavlWvSRTznzBUImptYSk6FTeccJea0047v1nKYtk4fpkJgu00hfZoZigXSe9VjI1bM6QDpOBD/7bRjgfVJHcMefyy0SzkRfBaG4ivSrEJbaRfN2bHY8XUbi22VsZgzY3EaxmIX4nZpnDZQZh/N5fPSjNNUcoX+wbr1aXYgtklNKGOkJkIM0U6UulNvvCqIzHAsbTZrUgWo4WH3FdvKebBd50GBabMLiWqlE8t4h7F3kZ9zDmKnUQE689IDNMdMIHKioYu5D9ABbIDX6K4AV3Zr1U4s0nZYAZ0DfZsboSTozC61X7oL/dg14hD/YHl5+i89z99sE/7swi/POy8n35WgyXsryfsmk8+tJO+ZTN5VST6rmoydpN7AhfUfe38ckdlaaZ/kJ17rjPBWCgpHC6p62D67ejnHjjKKNRJ0cadnN6/pV+fi5nXxy9mS/cvZA5jdgw6C0sRJqR7ZP8rnsqTHOPd6Ekz0djWCDdGpxqn2s6CecNmLczTrfl6w0BGshm1jjMNX4wMdw6TlGeGJuxM4FzLRPMOFt4tJObl54e7iKfzhgvCHMeGJkxx8t5uf+IJomtnORU7JOAeetb7uM1J0MaMM/OE8+HcEFpBIrXyZ2nmXPJicNX2H91tcdvdoCWZU8xW2iJf3FEbKcmOPvoV6sJOqfcHAmSfgVaMeQFf0+g8GIrOdyVdpOd9K3XxbsNfQ3p6tEHJinnRaAV7I8AnU0wpou0R80VhaBaXL8Mk8EQds5ols2oi8J20q0CtpC2rfqrVrhVo7mvL1r513IlfDrO02fsA2L0v1ilVt1SpahG84NoIp05xso/CFaSy+WuEcdWOlllcirmNWRAsYG8LZBb4W1r5Wti+nrfo20kRwNdv7GN2MS/By7hwauQoStNoPDLyKsmUFYwMHH9DGCf+HybMb/YRJUC7Mw1KDYaYeastz6ilX6BCFSN530A40BI1DmwS0AkVkWZG917iJ3a1o8CrAYlpw1LSApAXSF84DyKIfBUBfWNAv9w8Gazl263h2aYs8t1CT8Txg+yhYTQOjLnGZlZBwGlxMX4q1JO9huz8xkQCdKTMR3T3sm0l70AYe8EzgXq+cYKv9yvzi1m+XdWOVJxjPPDfJsnKSbQcYiEck7/Gn2wkqGISxyniyzggerOQFl1ArVtQKtGTTGnqCVVoTSU0L1LNoso22mwqpNoYsYJGQL0M+Tc7K5IwIbdqKNmEQSITGda5sqyAUFRPtqJl29DZrR/8Fj1tTegCRNmUFU65mCYE2hUxTtgqao5levhLsBQCnz7JtlVlGx59lAPP4TNNZtoI4UAk14E0NRtuE21DPiXr/d8w8NVqN+YXMSziL6OVL0Jizu7ceNZ/rVqfcTipsHcBGzRPTYTHmvb2cCwvgvyinnBbQhe0g2j1ARlLZsYjCvlgUIo5lWhJOoQVNyBeIAUBzSN5J8yb3PF5P4VjNg23z1aDbh69T9lXxoDJLe4Kzs1pOTvMTdLWcZzrqs9KdBTv6DvMwpls3HVM3ntnYeLoho7HBQtxWyTlP82akMzvS28qR9Azmo/7pI6qjmVIkrAvFMtEgK9BwjcOZ+EyBQ39r9WwQWLb0Q54P78L9Ts5M3MilMBcMXTAS5R0xBX1gg2yeK9g+77AI4YLbB4fsV93Dyu3+6/SG+4jJYGsu2EkNzV2lL168TtG+Gzee/Jd//5cXPm2474de9vs/fuZP+lxJKbXVL2FbYpD+ehI2r/NeiW5YM84wI+GOMEitH6/mgb0gD34X4S584cIbgVEH0EOYOh4tvaaXyTlG/74hfB08iF+97N3MbgdnDBPPCVhNdcCMzWIOD3cp+yRRjWE1P6Bm7oNdJkwc7powjxa+5BapD8aW+raopk75SkvTr9SaeFskFPpx6u5r8qizyLzoUCASIrx1qSO3KyljYX5nvcxLnYqrZb36GtRqVz/dCPJ9uZeO1beTz+hZxEGP/zi9cmlZjiNh+LlyN5jFxDNqWpNRccS83QxsfN7tFx2IlmWsuBIN7dRQVDrgbmU/BZCrW/ZVmrkg0HxwgVG9oKpbjzZ6zdVRGx3O5EAGl2CLmUqHZ6odnhnvsGmO9nkm74z1eWa0z7i2Xrkfzn3uYJstsHE9zk2POVEAIh1XlKo5XW1Y9W4plloExRF2QhPIeBw8rFXxEKBslZhDJkxCHVolpqmqiuJQNXoyuxajmFeTLnzjYt4k3iFSvDgYIjGT/l4zDnkPmvB5aFLuQ4u6mOo6mu7v772maJjMDQr3+O9K+BlcEGwk6p7lnvVR9ywfxbu6Z9EkuYL+cQTTviQK/ZGR34/fS4yfcWMGrdHnOMlXNNncIdc2hX9Nwa2iIQjcawPHbOBoYi1qt5TYtbGOoy4eG7+/BwKghqwpGT8PNtYkPCvbvzp1sIZrPNVZDoJE8jmIgFxKpjk8Fo7IYRYFtDBAaA6Kx3NUFyu/lr1ocPtr3FZ492iat3vxNrBvx/B22L4dxdvBJs1YLZMZdGNR5ch13nzxgPB+oL93reqQxfT7rtQEBjZw2AYO2sADTQs2GzhmA0ebImLLV1Bpl7osi0RoJ0I9swucpVW576m851YLJn3dBvgp7FKB3RzNCRuwjeaRpxZUOAGMQHMk11bqTeaq97MKOOdpBa3q4dGze8FEkjKFX1PF5ApavGTm5V68kHl5AC+7FeYMtsrLAC9kXg7jJTMvB/FS0yHJaAvPStPdJW41NaQnwthsozmgioS3g3/bKqRkGdl48wBmZ1yc8kHucbEN2QA8A5YpiM/nKfw5//wTmMutCG/lMF6lboQnoQYcyhdTEe9DRLws6ENdvGKzCYzdQotgkgzipRY0TTPTFDZNM90UOE0z5xQ6TZl41JFdSod8efqCtTHc/Vn/hm09hlDE8bKflqWtDgkuwc8Ys5hUs3RhI/sZJFOjdDnxNSbzD9apgYXiy3geZGWSB+oA/+kBnR8QQtaWq4bVlivCoMPBOmy0NqD9cjN6ycQJc4NLehcsOh7W8AbCN2n4LoQPSfg8/0Y1qB0rjme/IK0PKCldtDh/Zbvxs6eInb+yXc5f2d7H7K/sdWHoqfCwYl67aZm/6UQT1uwJzy41ISjTC1PZWwTI4sllwdyWBQMIJUjcYM/yNjUrTj/wNU5/OH1BQwzEjFQrllkxLRs2zLM/grVO2ORJqC6fOPd7Jy6Ry1nndA62gEZ6nw5XsIzqqNYTi1fi7B6piXkj/kwc+1EDRwVi+tgqvzZKRqMFTXi4VEKubIheHvOdBgfGlwEjFWQDQEeYIPvZtyCbyZPdpskpJVotL8UwaQ4ZZas8ywM7lh3RO2RcIa8XRIBUm2bugH0UeMNrAWX4Z89wCBStSaO8gjMhdpfbLSB9NzWduYBjQAX/WqCD3QiETpfJ2b6YCNSyDwBsubgR3fDziHhFP+qLrhPPq1tCCqYgEly2DDiJYnbBhmdEocPSwoavABx7Bfseusu4IVx/c5l4cC+54JU9x6M8xJpqt3N+bKn7sKUKca+05m7cNUDd99jA/TbwIAeE+eAnKMPH5cmf+Pq8xZf04DCeFu0+eN35wSHflDCwgbvMJ0fxPOajDXd7aIPEvkTrOaDFXWG+uVxfM628pVkTCqoYjgK6IG3SM/69JRTj13009QsScwy/2U/IaUTAeJCHeOzOI70QtDrKb2rk5RoZgI59Z/UsSZMPVJKvriZrM7I/wPCv4IQ7NMiEwTyS/seqdfeq0X61vKdNz14nTVXXdl9im7hik0+S1Q7M2147ap3vJF16fozSkNE547+AUdrH37W+Y04beRPkd77KnCpTek+mTOlgjCm92TGlA8eU3o5gql/cNfbFW90Xd7kv3qZs7M1jbKxSNIBBUvI0GwpRcPO/ah1sxjKnHWVOs+cWs+2a8qVzoH1hAe27fIE7ecjD6Zvwqrp2o+OJhpeRdyHv4pHkWzjl3kxTViqVUSfvkQ/eDd6NaQ6e+DQrsc79NuSnVQ5a5pa5CjwIzC24FaIBQlvB3G6lFliFVsnccqD0ASgUdr6qqbWdSSZO62lLXlA334GKp5CTneBcsVYjMLCBwzZw0AYemDOBe23gmA0cnaMi30Y78lO4vlMhYqZTgWUt5Ut32g7r62mAhLKpCoWtKpGCKgC/TrKpcyO5dtIpk7la/cwBBooMOAw5BY9T6FQwPqcaNnVZ2VQVk+nLMbxk5uVevJC+cJerbGoGQJW8GN4GJS+WAWQlL4a3gwkt6QhRzkaReoCNdPsU7QwQSXGAx/tWEkxAaFCiAAb/qh5Gf3TYC2TFEb08d1CO1JzmwT9iPd2bbze4wWLXBHXqm1RGW6EUJOVfWWzrMU6hHg5sH6sFbch3oc0oEwJzWhLkXTzJcvaUxXBcSrvQke00gz8IPWhOONQ5WpXnKqWQKaXUw2j1KFM2daZcpl7AYrg77nCr8JuL7eZl715ywSt7Gq/7cBe8qvdQwNPNewnw6MBGfjrPFkx7XOQX/Z/9Jf1Yw1yDMO10Z/NpmFOFmEBPFxoPxL6tPAQxb8EobGc9fmYXtAC1wE4dtdeeZ2BhtzK7m/BwHMvWUN8Db3rVoZqiQrYu1NpluVuzPFjJ8lZkQThzrPsZyrpvN2PMpKLk2ukM4ckHCYKGKT+sL8qVH5QXsOXbmS2/M1Fu29K7OpaDcd6/Y3j/juX9JQB5Ufaz0p4Ixg429p39Lauf/8x5Kxc7O2jSznUeNto+KCi7E7nxMryAS/V5DIFnaMMuLnRjiHlAuAsl82A9+zGoyN6e/QQew2IX4UvatU50xOHEgDG/L0sHbXcteEgsa56i1L6F+ccuZ8/UpQPe1Xmk9jNirDFeZP98fSkEkXKKDgxxN6C2QvpJMbv/gGjNeRw1Sxm/hbD5tMfhR1ihwS5ILgjVkjNp9jnquOBYlvcqa8xiZSXZ8UgKJT/fUi4uWyjIfk4GpODmb2cYz/IzvCB4gJ+YjPfjSRcE987iqAUdW1E5Vk+veLCzDNZTw1l02lf19NVNFpATLw4auMsGBjZw2AYO8tmSrLmovQvVqm0I7UTIrik7xtaUYnI9wUpx4vXk4OO5niwqxdf1RF8O63qiLwO8kHm5q7qePKCaHg237FyhL7ogXa4vulTtlTHCnpBWIY7kx35uXgJae2kvn6cureJ6T6meBz00vJ/KNecKNgYuTlvzNU7Yn6+Ua0K+zMEHZpli4UjJ+Ao+lbZytuKUNVrmEH+/VeUpp9ECmeBZDCse+7z27ofniZ/eux9mAe3/4zPNWCH+8DQ6a1NRy2nmM35WPmtNQa6z6DRIWU6DiOUs2onwTiNxaVUkLnp0dQqQX3oCYZjPi9IpokvWD90CCVTPV1KVEWH5wWq1Sitm9eR5ke/C897ZnPB8cDYHZeJ5g4uoW2Sx2mKnCRS5O+JVt5ilM93diUyJzRwXOtmnfGfLEx2zu7Mc3mwzJUVy3p9WCEFRIQTLU4o5u5zsaTnZ+eBY5sJZPEFaetaNFfzs/CwccWvjdohIs82Yn5+lZph3oC9fhVnpa+SS2DwWMEElTHvk+7pO/UWZ+mhFl9ETjCSmfu6m/vLY1F/5hpj6RXXqF9WpX1SnfvHYp/6Ozac+dHJPMdxeCxwazeNcGN03E7ZVCkPP2XzGbmWInfPIpusUdDinMlnPGZ2sZ/EPkFD3MdvA620DqNHqU3D4z8CVKbijFJZegf3WfJ8gcc6lg7mZrSorTQ2unz2K62flZ6s6RypztcRvKJlwezjVOPeaUxYzoXaV01unSGBT8bk6GCKmRu0JsSASJYRDI448XXy2PcCSl2CdbWHTjJas7CudzoWHtL1SCpF58fGyy9l0rZRKERggl3o/p45XBT6KTURhswCODv6rIDq9BwqVwCawaBx8tgQv4tAlEtrDoX2U0Bk45VMkyn5e+TJXv9zBwSYUhfLZUFaoexgjB9HYj2dqZKJhYslKQrenF3netSJ2DUh8hdxRRBRB4BZBwrb7jiHVRNDGiRUZW/ZmtCO9RJQ6ISHYMBICrgXc2bvw2kn7pPcKs2NC/ozIQPPWIHVBPg6kX/K9cIpIRW1Y/UFF2bRtAmERokOh6RD8g0Y4wUf5kbPiZ+/AjaZLKrDrEVQASU0HtgT+EJmtY0yW4eorDjxDUlvvonUdQmUAJ9KibLtWykN2ru3vv+wa8teMa9tQv5V7gn7/eva+Kq47pAmI0/u+6k6iVrEV4OG7TFxjZ5BKZR+XhujFU8meh/wsHUhgWxBVDQsfH+b3fr1hfu8jgfmfj8L8M98oMP+LRwrzgdr2Ca4DFPRIBqHySEbDeiTjZf8MMOa+eiq4yBjdz873z+Wgd75/FsT8F4qbNBUYqpmb4DxJgavWIuRttQ9vROhe+FNX4UL5GjvLQhF2On/QEsuD+CYrNGOdqVU2NVPEKYlWFhYRlMtxZx41wSMNEzekYV8G4HIUSAsucRMHLusZV/FI8HBRfL/YdvCRIO493u6Hnlg/ipgsYbEJ0CpS+10Byo64AyO73proXE1EJWvPkBC8G0OhRxzlo1HSfE1z/UPrNvgs6gh3GyjiNsYh74oTSgZFMjS+VtTugHjOTiqXG5vkV95SbbBWH/fvrD9LbYOgLQSmMMHNXkkmLn6oL4y1Pr82j1D9yNCWpvcxY/hnJduSxvPFHtfVPm5qU82e9Hl6kiaHa/LbXYe5AQxK9lFgK8CtRkb6nhwS+mo3ZRd/jfv7L5Vigv7FkIuU5ZbrabofJ3he7uswu8VSw9r3Ijjy/ajC0/snVRv2mpfT0XotA1IEY9/jCK7S8eJzhzr4+T4/YCm3qmQADyADVvsJ8iEgqdoHnGYMoIV41I8oNMnHyjmQFwybUfEqUKAiAxvbQh1OQ8z5pgvJBxKrARjFc2MeRtxbwuc49+tFhd8n4r/LejLROH7nGmqG7TNOVvegRaS30iO9Kh/C4EBXbQItqOOzTNydncuUhRASLmAVIeECWhLaLUd7sTqtJ0/UvLLfVzqqFni0BjWN5aOnNdKwmLgxY1Gnmto+KYJeLjaliQMcaz5Q4qWfaBsTrUr9BIYVBZn6//nw+9K/Lfz+zh+5/xNVF2Hxc/f2qetkLHdfRhbi2C3E8eRC7NIlFU18hJWAOnXWzAe/6BbkgGrZL7kFOSbnUYpiLMjuqhzVrHGTWDOHqrTPcEmwAuuSi7hYRyMWnkDtZ/kTK3DAjbtTlSLVA3ks6MFPCqor8Igp0rd5zPWgDdqCSDsRm2UfQxbgkZBvUE5tDipvwUmZeigPxK6FCXUJa4s6tmPg3KVcgVaA73TNC/GqnYFhMIEJjKqIv3J5KULrdMz6JrqUGWxW81UumsndhnVmHyFDKB2TlqIZ2oPsl4XX9kftUKV7PVkmwHd72TuQBQaWFKZ2VooCr1mg8abWR6SJCVQ31G0hxhcPabDADWGZ4jXrTspDBMcjHFi7Xz4Kw9AlFGgFasNztJ70W9HnzHQZ4+5MuGlNKEBC6nLAWoQJJEoByvBM315nTiKGWaWKl6ZwcxUQVY8W0qJAW1A4ZAywW1R4LuMCMlA9u97Dr7/3Ew+//6Offu0NRzkZzBYf6xManW3gQ7HzAhdOhY/N0f1yZhDiHt17FFWgEBk7jiNmjgO7MGZHKn5IEtXGrqpgRy7YcMEmfEvjyFe0sROKoIbdGORNcWKVB1X/GHnk1LDV3o7gfep8Y0R95xsR9UCew0Xmjc2KQf5+skkzWy7YFqe4rdFmtgZ5+0TNFHpsGa89e3l531vxS1hhQyJKN9ZHnPBQ1QkPNTTtSNGgxqS7jAbVXLHRyfjywaBNlOP01KnJbBu1hwNVYPGzX8Pou04WUZmXXJDFBkAxFVn6esgR7MclFk+R36eAjyrGTcBgnIKNvAmkkSHzjmvnBKwl0LAKdAdJag6ormdCaqmDQuPGRkdFTeUYH2nSUkiA1E6Qp2axngD/3oip+CoMqxdEF/nH0bda9idCrrdNiwVF1Iuiu6f72cdChbuO2bt1YXLkf4/xHVLervWdoARESyO9icusKcdW6n2HH6kpa1AXN1e8fn3Sg443BO9awWXP3UtH/n5SvUrhTZs2atJVr1jwXPFGLlhEA7BEmDLhZtWUSFliLQUW9z3yJnHfm3olAzcllBRWlMGCfc9a/i8v+YNn/iyHPYqH66VfZf1o/c044XvJ8cUN7/16ixve+0jEDe8bFTe8/xtF3PCBRypueJ4PvTfp9EbO6XnV51HfFwQ1+EoHxFLAgY0jFBhrVMA0RrDct+44a0a07qeHPC+ocFGBAgu9Ub4pokBNNOA14RhpJKmmm599sMoh+SWH5ONVZx44JB8RjkPCC7xPjXJIF4NbOGo5pKD/cUsrAuWQAsshZR8q+aJgM77o6KPgi3aUFKU1SlFAdpRc/J/HO/1VNAPFMmuwP9Yn/qqu3A/GzgcUxkPFQtIqQB0mDXkiZL+lasBQevbXsrvxRv6U84lQb9n6hMC9NnDMBo56Zv6Kd2NIV8bXvFhVzk3+u+yHAxs4bAMHPaqrTc8NZqtkseRf8EcQHNWpsX/KYnnULpaUDHRKrcsKAYrx2+iUEoAIhxocEpMULaEHiGtr96kh+t4zFV+CAS78wO4+5GcZFFc6Ro8in1VFceIEXKoQ6yeYxri5nCJ2kWZNGxb43oNoSi+a8wBqlxmQuDya6OFo2aN5QoW3Fl3qDmgJQVrGLx9h4MojJvWCFZbM0Ty+NIpAbTza1VtMeadqEzalBl4a+qJCGzRVe7NQdgxbaa4Jj1lu67yekoyKaUTMk0fGPb7igPfSS5UOwBza/Fj5AOI8ejAm7kEPElQdj/EdH5/Gd0zEcjknyXf8xjjf8YySSuyssBi7qiyGJncryasTHIhrwcWGGsmjX1/jiVYoceIui86omqJZ4YgFWZvCShz2wX5Q0YhOqr3AQdPvWGoJDcaQNRj7e2S58DaZuLvJIzzJPDPzFHK3Nqrr62ORRkOz3zUWN80V1oB5w4J/MFpoR2LB98Uggolc/JWAPxw5eQn2wWhoxA2lqFrb3tHXDFWLUwLiv8sgt4nIB4cNISUTAz9vSGnYRVUdJTaFuqTVyJa10IFP5fot5ljeSvVKMLUo4dAuieV0fojaKCTTMFdamTkQKqVoVyo9b/JHedNOoMzMgUyHVU2WMKrljXH610JvJ8dHRqEtAum6sXzfovqGpWuDchPgQ4BhzGcVTejii6FiwKq3MaSU3ys7B6EjKZqa4nhSTbAIbLXFgTS3iPWyAzKHpC8JXhp8nT9vmJMAQzIiHlQ75O/1o6BcdhQNE4zuyN77YDj6fnfIA+ipV4P+3jyoDlco9n/3Co8CI9gPhhgZ8ZmpRswDEShHaxQSP5GqA6a+9oTxUVtnI40eGwQHH12O0BalTgLIem8jD6meB+Z0wCeuDxcKtl+zYZeXsLLiSP2k22HhR5WWVZvig5AraTRgrKV3+zHuOwCA/qh4dgp+FDGLPnZTRHiSeWbmqbatgTi6UlYcLWNbqdiCY3zpZssl6/a+Ri3A0diewipIdTR7RJu1/Ijat8KdyqU9te2qfiLhqNp4qUj5G1HoRMn8xpQJpRtUxKwFYHycOSXPwfIAn7ADnUo/kDdKOqP+VhVa1pJQWCreM6iNsj0107eGEc6igusCpTy6/axQS7UThNtDes12j4nqcpSYecZxnIeDHQ9UIfvkq52XcLCXTidcfYfKAU4R4tTreRBhRIxIeLmc8QLIOgROoaQ80VOb6pgEfRkXNOH0gBtj26eni3oNGFF69KitUzFwEwdxDeK/S3vKXuIwkJobOBDDW7XxaOMl3LZYG5uaxobSxEHRkqOxOoUY8FAbnw6LlH+OMBkKIDUXo0szjoZdpx5t+qfBM39DqWYeYnS4CLVgj3l5BEWXlJPjGhh/p5nhbtpkXxAmeKZfJ/77tl7/e9eyv5YosNUBF9qDPXq1TMA1dpkr40dmvKu05HzNnIs1qMl8jRkw5Ts8WF8o77WdN81YM/v+2z9hplkX9OkWmk/giv7vpriifzCIHJPuTDVb9KysYChwfMEAt9AV/tw5RYn6PvZojv+dWCeUQyBPuV45MhESgdBCnqibsQYF0PdQKkHILh81Ad59fxE/4yNv/PzfK3lLJHVaCuMQZmsTtKJpCZ86ix1bPqsLz6izffCZeSD9Cqf3667Hr1+f+r1vP+N1D9b2TvbLpTyafilZ95zdOIoe6xb8E1+/LfgDm27BP3XiLfgnv7kF1y34h09qC37UP/4WXF2Qui04NkjZ/zruFtztm09+w/1IttfB9O31sce6vUbXmIBH/9dvr8Pq9joc2V4PHtH2mgzTTSe5uR5M3VzT6N76qD+2t35g6t76gUe9t/7Tr/ve+raRvfHAr7aC1rL/Xd0ae9gadzfdGp/sVjjM/sxuhWnKTnjg287+enVbhJHRZviTWyNv9P1Or+9bfRyZJEH/CryPbJA46QrQxIB8mLCrbpAkroiABGDEwP6YDZKqSvjSUvDqUT8Q49IeRc/cdIN0tLJBCqZskHyzQQp0g+T3O5MbJNAMqZ/Aw9kNEulyCjgGo9sjnSxwfTJ1e0TTd0f/ersheoybIe8RboaoshcKT7wXeqwsx31fP5bjpn/YjOX43IlZjs8qy/FNlmM9SrDPBW1p6PVyOzWOeSdgM15Z5THuYh7jC5vxGNMYixAz4k4vj/AceHk8RjN0wmENEjsFnj4PeZRYNoNxOm8aMuKJqEsMDVCdPMb2CXYDQUtNGpuyG8pktLVHXFAI1kJYjlxvp+cZpx32xDoShTy5kd+jGWpxQJkKam0YdgOGR8FlLJhbMZkyEPOm2tYEh9EpMyBxgsNog7At0NymHMbC2J3hWVrgL3Etg1KQERwQH0LjIdgkUd0A0W4irSUMW4vjMCSHvGKBIopo4cqeDtJhxMQUS0xMIchsaGhJlYeAgIvvrnr8jC/goTU8xcIUnmIBLVaewkgQOU55imPeKE/h5rvjKTT2UfIUf/115yne6vm+4ymOVSVIaMDfWDI1ZQEKjGo4njUV4uBRWduTko/ws79VPsLKeqazG9laJSe3xpkjD72X6wZjalM8YyUHz8w8axPqUNVXmrr8Y+VWkUTfsy6BxQVGJHrYOjWdnMcEasZFetwr6m4el7q+QT84YD+l0QxYrPlTeCVUDuCIH8e6kxJyV9HAnK4YpqtlLDyGUiOKlOi4NT6VfvBSKvc525w4A9PzLkMms565euc6sEP+AX0DQ5DxNx2awQTEpJyh2RGGILMMwZxjCBrUUOv+MRMJ61dcmQC4oZ8b5JjVic7qjsxqlhhSZ3y179jVvqOrfZq+3/cDwQPrRZebihXKqPiog1d8wg2KlKCzO4tdarkkA48oJJSz4dnFMzyAC4zZA+puHtEtRPtoNehDrWMMjtw9ZnDkfc7gyN3O4MhH1OAIEl0dEcG6z4HsbRCplU3pc0DyHadydV39HKPfoR0C47KmH1cr8aUjtn/ZF9WUi7nvoJK5T670sIlgLHtFuXd/BTDO53CgmMfhuryHku5zXsuNFmEeQUn6FNhxsVbvp5qrrhvT8niSeWbmKS0GsmLA1Bp+kjel72aRjMUAofq4TsEgtNs1seAkJhUphdoi42QK47YZP17A6wU/CJdzoV/Eq1oKGSlo90a+CKPHi2v95MX5ksP7ZS7w4MV51+kzbYHdZHCK0ABkrUxaIP7ji/+9fgeKYsWqONdC+VsphY+vbXhkYts21ErE9jQRbF2E+Lu0xzNgg7YfGRY55UIVCLOVaJVCDIzykDiIO7iYF+gx1+BjEhX5DnS2h+V7py0dellU4L62xlCIq6mk5j+2UX5lsbWXo/6cOJDTTtHy1lpop96kJCz4O2yJtCS0LiSiQm8qcCE7UUjOERzgWLQ4lIuYBa5JaglFSjsEDLSIR2K6WGwf5Hn/Oq5njpudCUC2Fqco1HYWIQZrp5awjQhvqGmb8Rh9CiTfp3CNuxAf4prKqVx1Lh98v16h5Qq2SQUdW4Erd2txmtYkFezSCgCPXVqBdfsTajIqyEMko2zhiwX2AbXkLvzpXPOpwuOcyjAQ7z27EMWfmVjS2DOooB1H8jOpx9/lZ/Gjc01+Nq3i7RzKAaAH69+fP4ExZTd5+RMFzVbonLVihe8cwI24StWBgiVc5+mJQJEnceBJl/Y2RqD85EF+LhmoznKge6B4Cu7uZ8QPhflOTT1VYXOqgiS3IDmXcgOSnQAJEOXeWgn0NkPlXAd0A9SCuNqcOvzO9YWwD5BRqPUtaDULXPGpmnuTMcaNaDQn1GQdAiSjJq60jaVfDq3P4/A9Es7Pl4Q9Gr+Hg0c1/gJ6AtaQCxVxFhTO+VMFDIUUTTKnTlHvKgs4yEnP5itGqqfHKbvpFOx+CBzgNp4U2+lMNC0ptg+L5eOc4YT9OoU4w2FKAWJV5Qs0QKE529my/u68y1UJ/cC0czbPQ1qF8QQQ1RAWOLYJ1BiVinzomAWYWMNKxRm207QEqMKFlrJsZfDLPE3plHx32n9l/1q6sMfA2UW7bnfu9Ir8iCuHtowUmrcFaqfRKUw40G7WpqV4F3ezCF/CzsHyp3Cd1/VfyeWu5U+wfUHftmrfDjaAAavisIlEmZDauLD9hJfSwjVo8lbq0in0lGveeTMI+wfftAdx/VDwBg+ynQLqFaepqz+F4BbuyPKAqd0ZxH9X9qjakdFuPGGs2RdVmv20Ezcbg4KmPwFNt514Ctp9aY9jnjbamYtOujMYmvwhXpj7PjflJdqEfI1OpwT3Up5I3n6s5aj1bLaTJGNxoSw+EEY0hGtBOowZTLQfgmLczSfOJoW0z+AyF87wazcTB2tvKmbUGqI+/iubmUZ7sV/qwJbDi+USOnIWT6en08x/6VW6s4DHgu1Vz61hGB40z6fmSPPQHG0YLXBc0V7jgvOn02naagaobSadwev/DBY4kY4//WaMwBoaDPPM8CjNP2ogir+iTTqxYDsREn812glOFDl0T9fcs2GJ6Sz8nGLgfxbYTNFjBTXI8cjyix0BEfTDDKSLB2r3RKezjkHbrf74FAyvW+/LRRRNYBS71IDsFFOsEqC9Zt3atOiLuejtUjgmwC5Z2HrFGXwjfi8mw5Hh4Ph14n4jBgJ/fLttgXC0jcVIG5FxfJc95ErHdykYznAkCw1xJIurP4O2S4thH137XKDz21Sij+qnkiUzDqeJBNDUbSZD3tZqpk5L4BJpNbm9avEtAxv6dQbJQz61XyJTEs048u4pM1EbtYDWLKD+RzD3fJl734CzzpNZ940/32qYb7XR+ZbSeXQ+OKg9dAHYq3Ppqcwo0ZPyJ9KpzKntZHbwyfl2ehL5KEb2A3nb8ve4V9fd4x9L+LnlguBuPJcvCI4mtEAtsV0sAp8YQJjhZ84wlA7HlnOeoa3S6v8inDPaThwABEJAQMVUsmUz7JMURZE1x/5eytfThz0vuo4CcXFG3hqeu6Eus5/459Ie3vcU4QH1vi9O30P1llbfj0FSr2FURyqOKwUsunu9CNe8Je+zivqlwpqiEEqQV74oov1AaChtyQ6Rg9xEgN8HvvgYS2QwZ2mJnXS2jSjUtFuv8pwFDtgnNJ/zmrajorpux32zZUaLpaUnUBH5+ykqIveFYV03n1YERlVX3rq5D7G5jwjjgDh7JYHiS3swDzyxvc9Du/nVrXQXoQQQgxgsoBgXuqTpclNX8umVhQSPBBENhFoY6iZCGUYbBzdvVbPGCxQgekGMqkI8ZC59BuqdTkJdDoVSWYOalL4XFgVE+J/9g2zzm2Pb/OYF4sxAhQz3jwkZPu2EDPc7IcN9KmRAotv/14mVT+OqkAEX03dpEVU4JGX3E+1+o+x+6/HqPjrfOunuo+0q4witjAPjXrbeCWumyTjika104Kwsf3dNTxVKlMJTyLxnEUqJPfn4VXd0sr7IwqFLBQ5C5fQTK0Yg2HtjNhMZQV0kohI9lwglHFphCfRykv7BsyAssWa+RardtHqj9tgqLFpVjbu2mNgSIccMP3dD1hFjT5WRJ2RvlqKNfI7LOdgVsca80n34cKF0f5HQLPEf86iLRnIhHmMXUcQyeZBcdPHIROSRaDniomqFurRMCf6YaqUsudhyZAh71iK5WAE8VmjJiNQV3E2WXHSNc/NFlVz0xJO52ujaakrnb7mmHs4cNYYSPj6gFTkZKLpsiahY7nHhHCIOtGkr15KYWtQGFOcWL+m2RJqX45eEC+mp128uZCsKaXMEBzgWLebuQHKxjIKkhB6M2gEMNIdHYrpYbOHTz/51XM+MCBdWZBed8PaVX5cLljmUbejSCqJRU1d3tbAmB/tUiSYn2HomSJZdbY+47O7mZW+vlE227C6RKXs7yt6uZZMpG8lGaBFRDLAvQdiQQwdEhQ0FRfkO9S1KOa/D44KGhRIMGe0Ql6cc2AlBQxUopwx4r276PsMB3vizk9RZCAEUZ2a1G7Pcja2VbrRtN06ltnYDfCi6m2iydgPJAiIDgh5xhWCFtqMmcRnUoURramlNLa5p9viDMYuaZjcZjC3S9qKFTX5bjLhnxa4By3pg6l5BLIN5mgIyPwO4rf+pV+Lt4Fy91L4u6bK3rHip8ymz8+l04p7KXsDNIIeWHubAUul72hRGLZUv5advWuwuLnaLmtkqulwJ//E+4EzeBxCHz8Q+4Pj1Qabj4493AS3azv1hXhK1+1wuMVRU23WQn8mMeUAFL0kw1FtpC6FkfnLRXKacHi7TmUQ6Fbu8I9givUeoS1t4bHr87E7l27tHpLXUZf59O/h3bivK5Q6ElQ60eNRBKltBmgKxFVodjsemJQFFk+oTHkxLJBRqCbdwWYgFcaO20IrZtLRNa9FO3bRoVRZyy6gRlCMVZxgKKryh5nHIZMeDDOrBjJra/7bpf/uk+q/YAg8zWpviiMyVpta8E+RiMd8muNIyNQ8B/qFQWJ+W1b6dQG2PGGzbPRgqru6SVxoMJC/CXYnJbIbEGHgbAH4rJfzU8PR2ClAVdKz5z8Sh+dstTFv8wCRG15aFtBTbBKan0hmgWnD/ABEoLWpXEBHO3oDlU/nDnfkOgonNrbCymG+hnRSrSpK6NDNrZEqzUEfhgZMtQFOoDj91KcIyZJegtlmExpcgXYAYsijdUjVrvb6d/sRjc+b2wPpJOHO7+WfB892JX+vM7Sv/tztzm+pH62TdtlWdZ5W+ub7RvLdt5rLtJP20daZ08VG5a1MUVHdtE+gGTPu/zl3bo8atTTFr0j/bD5QGKI/97Ohm7iPyjs2cJulm7qMIpqp0FuKnxrteMc9CkXO+UxpG6kspgnvZwxghvgtT8WF0dRHj8QLnw+gK58PoZY/Zh9F9UexZDXBH+I7VHrkjIx4zMFi3+HKHAeN9r5/98+Ph1whaCsfxbdR51L6NfvoR+jbKcE0pgTkZXdTi7J+kf7LVjvFoib+tVByy63O3eZJ5ZpV9oejCqlWqPOonouZeh0IHQlp/HZoQET900Q9UybpNs7oSV13duTvMMxJL/nN0oQSYU9RFMxyDx34oqYgz+jWttCyW2jyt2iiXUyp7ZG59G71Ho/JA2upaGIFHoEgKubKIelz6LCK0pGoLa9KD0juTsCHwU5k9BECWoDHemWT+3wFex3hnuho/L5jqnemKSe9MTuXoe72qXCrSWL2Um/HDQ4MigtqiqkompBZm4VJHrSdGgnRwrhMBH76K5nKQHplfneMbwn3BZoZwH0Rt6efSRirT1Cl4lL16oLbf6W9ATewA9EtU8eIFFINYXaFv36Nv36lvl+vbJfq2T98uklUmr6vMCVMZgjRlx5oUI/p5rIAk1vaw1uxnSL+QI2AQ6kCRYriDA1D/e4mdjbHaH2lRCgiFoubQhoW+mIAhElfMsGk+YCVhCp6lrocpzV53SErof9y9OekgmqltR5aLGBsplOZQnL3eZl2Q/BKdd6wNnqx6xw9gv8VbxzYYG9FEegJxx5ybrfM4ebwiX1ABz2Lfu0Tsoy/rxoXHfF732cKVMxe7SD644wUjiwqppQKy3Hdl9mgRE0mJ+UGPtlAPhTDTsUqrzOVsvcPons+tUZdjyrWP2H55+XJlbx35TbF0dDh0Kxs+DyE9Un3wh/xiG79tu6RXOWf2Mdl96rmv4BIdU78ujHLupzRfSZy3O0/10GJuqAM8F+WJQsmnVER/Cfn2fKIuNFMUgZ0oG5WEKKQcRIjJqMPZRkaw8JWJXtZRzISaLRsrfpcUvnZEzelpQ+qUyX4plGqLRCVn5Ev1dfLxSDBECaT3agoweTa030W/FhUwZgM1k2cWc229i8PrD+R8KSFiphpRRwvqFqK6CaoCxyLUIlr3nbaRKwqtkFLZwfDuS5uyTSDmISizY25NlfCxvTpWOyAeg+gI8e+udUWQuuqV1w18Zwif0OKaUFsHb22e2bElaGWi0Ac3qO694Q+HNTdfyvD/GUiei20KVX6EOCajbVg8Y9Lh4k/OghlMCe2GIF5CMJK5gBAcq4GsIrhHbWPqGKv+uJrJhJHFN2CsLbQcjM7KQ+v3W3e4oz1SXcmIUnQltXIXPWxAg4tEVOHl7ghpWCSGep+MejIritUri3oPB6EcwQGONR8IfptP0HPpsrGxGQvB0ZivaIz2bDzq4zbq115jo+4di+o/UPKbvfRwMGKuMx4310lR9rVplqb0PKc+Ysqq7kxZ1SdNWbl0SUVnH3E1aH1nrfzkIIbR3NmgWna9voL3rxOuJViDxVQ3hq1oTXZl++WkSiqQiF1SqRi5WoPmJzpQMXEVwZ4nXYqGWBNXOs8DPEoTV8GEiauQW/5LaDkxk4W9ArLndX5SOGriKnaK2u/wxACtu5USaw/rglDmVApI0hB8wiI5YtFTaHvz+3DaBj13akhwl3/YA4qhDzHqz1516NEb9ayPXl75dlzXuMvT+xowDW3U1nWFD6V30lg0STsh5mmzGw/ZuyzxZndZbjj078Cy54ejABxW5C68O8YRgLgHbjEVxQ57avH7EJ7eBRhsub/yslEt9atHX1+gma7gx/Vicj14HqHAEbN4gTWLV8TZ370GT7FzXb+A2RXlGfJE+DGx3cF9u1attr7E8RhYyjgPEG+475ZZXcSHZTqMaItePE639n3sqdd9/1sGn7t4iGLFQg3vKG+7Ff9+21ymSzF9xfaMhwVnQIlhCTeM+cob7v7tF+7+b/dpHWZ//e2XffC37tsWsy3B7G9fLWZkKMI8u0RbfZG2+lyKqGUtSWhY7dQrq74LD/JkcxABW1+Gn5dgCQHrGFF6npyeNMDJNinK/hkQQ56rioDXX9lwBeWhNiqAxQO0Rw2jf7kGJ2Z3COXW0235WOXrbUrFlYjyikV9UEjwkI5DFbZq1SEiU2T2j8ZJ5+pa9i8alKmGVZNDp/shzGQIHBKFA/obgTkXOJtFoqb1YN3K/l47puXLxNFFiSMOjl9juXPaNZaJWNAKvUQyo/etsh+Xmxtyw8Ql/vWogUVfq9LDFEsKApWjMR/u/2CBY2CblEBrPuTYy0xcJNoSnmAgKItwUhwmmYUtH8QYFfAlBF+2/94PFpyIDJf1+l+DtyKOfIif9Ut7ADi2Zu8EbIR65sHmtYSmFpWAScO12QGLfPfLXQP5IkI+VWupSZGgx6f7yfkmfy729pW6gJworUn04ShP9i60akV9LUXiCx9p3DClN3652HTS7FeQt5a+x/fi6xzsTOss+BTWXKmCGcVCNUUNavvGyrQeqCpzmIBhSuTguYiBoVI0xofCEkrY9evXsfDOcWWbkECHKNFdfF3XHoyVdkJfs5uUiyvHDR11zeejbAwhqgsrQ5jYIcyuB85pzxIpuAhHGsTNr3RFlZqqDco+e8NJ2Dh546FJBRYYVxkxoqKLmAW+t18nANV0mtpl9h+bwSnsFtd3dxhH1V7yUCWH945JDj/uJIeaJOV+GkGR1KDrmN7hmhrtXCjqeGSFbraLBsUwoiO67WKnp6knE6leGWzp1ritG+UZvYvRUQzO9J7GrPAns+gvyAbME2Ag8T4PlEYLFuR1EWybNJgyfofSjW5CltCu5TXne1cyFV3JVjRks7uFK1kGPEOI3vmL3bIbjqijKLqc12iLRVOKRnh89B9ZzWlZDZhbU8w1FKeBbZhIJzCzltl/Gp8GgVfv5qvqxg7KBAdQ715pzja0Y1fOB/A5GedmhRiO2CEqLfayPVQ+xYbiTjRfbpDSdtoJd2R+HiG79Ugod7R24OxWym8QPIQl0JWVAnMe4vJiaUCncbY6bqCpWDw8ClqGF1KbGPoifmXtS02NXjS0AnF5tqvqpiShRByZ7aIAt0Q5Cq/OmRkkV86kl1zTqusFeoC/mXMGjrdK/DtwlzuiZatUtkw7OKh9b+Btvygl1rjjdelRg3ZQbe1RdmoL1Sc6Bag98n6hT6AUalSWTkMc1CEKGZVaBWCuAik+sa7RpNhgvNgcxeZECrEkL7gkUohZp7U9ZGH9FHy3VVG/Bo7BICbV2l46xXXfLmNf99lmJLp5MpmrOD3fxe3epUCDTiuexRlwq3YG3KoJOPJd0mrMFDwwwL6Y2VDGZZ4WedRgd0vlvY41PBNw6XsGOXcJWM/EEBn7fKowoPYAAEMOwD69wJszitT4LDqLzjT6wThqBYWYxY8QDwgvGOYtRPDzNEo1lP2kUPpQBYwgcNiDzXHpc3p+pWSuRjH3oqf9CNwV3cd6Vnv/z57EWe1NvwDCPMCvOatVz/DfPKv95lntYz+rVRTUs9oJdAOmffOs9lGc1f5II/FFi1OPNMfoQ6T5zPXfXxi7/ot3Zck0Sa//Imi8DMR95CkPd9jAjbI+jqDWDV9e4jf47fu9tfKsl6NGysgOi7ilLkyfvSdt7VlRkDerBU58rTJlZv5SJWIpWtmiaQZm2nIUGRGeZJ6ZeRqq1U+eizqqhq0wMeSKaiD3ykOcTVqBLPzdZqT2TTs0i8ccdWjuqvKuiFO3z+RgkqemxFIL7IWcF+qEacnBJB7781kK9GBS6gnLYqkDHLI6vLPgBWfNPrsjvGI+209c2zKaBULK51cWWY/LRTGZllFtG1qezwvdV43piB4jsJr/isBq/hsAC4J9cAACtAW4/eAc2a/jiDz737L7dvYIaAHEYZ7my5jj0Yg5ddzE7muw29eNQPnh93Kv5wTK1XVgbpR+zNFchX7MCdlGoZuSbh6OGKRbzInGFOqsbRp8QPvncRyVHUbHuG7k4deDeIW9KjGoqHbS9EaLHsNbRuXPWqpfce3SdT7/2uNaj7fCVWJ0zxgx+qgjRppUkyv0SoymMYoNQdWE8Mykw0FVBb2JlkegLXhEsGpXV7szdbyJDQnZB9UJNgFiweCkvxvH+5TJnhudwpsR1KbgNzMYiMnk8Kuoq0EVIVjYryonFYlkniLh58TgxBzXY7onWWhOd5Pzu/x9NH927RJcY5tHEXzH3zckVpXPl5SlW5ZsYEq7IIlSWLGFFsQn/0reM47qExyz4Mq2sKArtEqLQi65/QKgLkZc+hiBVUWd5yJdzwW2cP6FA/rOIOc2Ip+IUqyyJrfD7mfrCh8tKd9KiwyVnjnp2Er10W2tnhXao6sMszMTxOnRErYSq8Cm1dJaFgAj+v7Y3uKWIuwTdMXB8/YDSNWtLcmxiVwBgOWbJQynqMw/UHP7WlIo5cu2D1toGcr8XmW/vFV2c3VwCXlOeNbyQsvBVlZ6VUd8WFMYG/httXs5nglFZaPGiAESk8kHDcpHkkggAfyJFH+sVvmqBUQ9X+XqFu2OdJF6HDTtxtv+fBkDTj3TfP5s7RuiBzqMtKxEYbR2xSettYtaaQm/XEm9lHlrWGXh06pZAhotmUt5ii32ZkEXDe4K5sjeCQDy93K9OnHgJVRbILNjCc3QKx/ySbF1qs/6hrCR2LGiF4LfUwhRod67tB9U6M61yLFjzd2OtQGYao8ynQQ+Or9VWottLJoGrN5aoWFiW95T+FFDwN+E2Ki6W23K5jXPzM62TpneeGyqSY0dtIOaulutUU/vyZl5X9TX8M6YsYaoPUoaBDZUtxvW6tRMaQ5vczSrb7DNJQfkMzDi08FQdShAj0hU2ZvaMavppb2so9sRNy+T5snqG6GRxIGm1Z4yRjTlbBGYVMr4m+zL1k9GjAv5JsmXY6Wrz1dtNkjGbzlkjKeZAye1jGeizXndRefZDdJ3Cv/PR9zWarOAU0XKMPHEzRfQF42esDV6D8xJ0vlYhnUIhIKq7KqoizkiuIsdQGUv0lbdYa+3QQkJ2RJKkBG5b6XmrfJFqbS4cZHevKiLwoJZsBgbAB81ZCxtN6ZFs59E3yrS9fSHKi4tfDPVBEA61UQxzfgXjtW/sPE+HEKnrEaBqJ7hmF+tczteA+bJxTp59ukbpUfiisXLfu164w3j//GmXY4MyNNbfNgWXVjrccjX63h6CW9BQj05vJaDU7j0+2V0q3oz7sE6sxl11gsL5M9Us9sdWfpVo88UDI8UVSd2dWftonv2vu/8l/wr0p+sSFwmOLArU6/q4XVIDfw3yH5UjM8NqKEhSTtSZh6K7+H1oukcDSKHrZMLG+Y8evse+rkv/uFzvu+Ki4cVD35yFswIoEXKzqjtrtlBxMaTbEbCPEdAl8AfOpoltKgj1upyDjDCIb+urGUTzt17lfv2pTe0v/wP+c1Pp5Tcy5U9MXGVpbgECaO+6FE+x+cAt3/++qN3v/Yrb/4q8HETl4/JyCHqvKz8/fDF+YJraALyLAkCeJqlMHs1OB+zb05I5j8JHNbxSwlz0q19l/zS+2770qde//TvL2Q993B9Jvut1ymzal7vxmtpS24Gj9ViSWQfChANg7wAYAwgA7QiljsUMzhtIA6UEFyyml9N8eBfdDGiM/IF8nLLnNlSyELQ9i5Mm8lBBB6Zykwo36Ln4MDuhjr9hggwtp+zwvKQcN9oC+QqOOziFmw4FWb+h5tJuPdWrDAGrsM7LMUO2Tk5BsWAiCN5/jXC5fvPb9tDS9EDnP3rs6+/9SevfxqxJ+sESPChn3rpB47uOvT0qpX3hBZZlIudDzB/hStyWOqCVzIyx9hoLUCJcZbmkXkLj5jL3KhmxuVPVqGySkUwywwy1u5H3yp3uMqiXC6w8LvtzP8vrFihx1H2cMpODt+4asfYggDgZJOPyrPbrFZdmPv2mNN3x5xq6tZ4Sn+2u3FLQfYvryq/1KNVn8tW/4PK2loD82ph0eyH8CmKS/889DqTFhJFUdWTlpMn/dC3FoZn9ERZrQaHOPAHF2DWKTny1M2NSnGNoDvSKVXdQn5fW/zBc5qcg+JLv4UmeuSBrv6vG9zBnekneaLVjSxqeQ3E2bfNKCJZ3xXQCvaExy01XbDlflrKRa5cc+VJSome3eYN248m+sFbSfyx16CUGuhTdUlFx9t907hWwZJLQAElyQTGDS3dsvjUEUu5MaXgNdRN+fjhWiJwABcZO3XPFBQDN5T1DjY17UzXSoSvckbZa8ajtSqAxWumitN9jONEFeDmpfsKMD26bpi1mhrZmxUzGWIuF/IIeA5kX1YokgfIAq6qZFc1qfkF34/5XMAts6VBWakwD82sV+uCujuV8YjxkDNzp7lVg1KVHn/jhf03+6mRh1CkHBkFMiaBHObYF5JkjkGzoZaq4lsfPrJCOXU+IKyP6lfmcclvAbpauxvyIlKFSIATCAcomlFWZK/bt0jnr45blQsCAoekhaguJlSq4KAlyxPEiwpKxvGq1kBedi9aBpzBrJS2KuXhMDmPJIdCPxrhPetWpqF3VyCyUZ6JH+b4Jck+imFMy4iWxO7vt14oZ/4QpIC9v6yX3XejloV0jPcBTgJcGqLQyzdU1MW6v5/twBbpZbL6NRld9o+aHFf/tZ5YwYAJWS5LFaIwZfm/wdAZ0YJAZ0M1rrLPonp42qqjks0/8Ec+oNYRtSf7SnH5QnXH41Ybj6anevU0xZ6tQbExZ+2hO6r8ChwEZ6TS3upaFIjJk1R1y+3VT0ZVvZssbQWbbD3PBDaFuaDAnqc3MOWFca47H7neRtFySy/Z8F0XDanFC3F46xAbrOoCTAFfI+qr+oSqfeC4PLsdcxnDrAPtZT+FiMJ3SoW60qhEJnmEmkXBVM2ioKpZFJyMZpFvNYv8cc0ijyMfHNUsesuhSc2i4N9cs+iOQ1M1i4IpmkU6KJMugYra6Nhd/yqJllJUkzJ9Pg/wdO7WSNM8pV5oh5BwN+QgNmm1VS158QVn0aVSYTR96lQXRy+b4uJIKYdVywGr8nO+V5/kLgz5KMq7eEUg2CNUMrI4gCp1EUAeLMxFAJSA4z7+K1EisCiB9juUiFBDQLFd9oQNEm0+1OqqjrnY/XloWSrICgLFANQKf33CIONLhHAsfZ5+K9t2JdsRiHILlSCfPEI8JM1gg0DK3AmYMv6vgY39yTXSN7MMxQtKhoiCSr8o9i7ww++3sBPVNVSNAwc4OPQFEUS3Aouhol22rrtvrD+BZQMrK0h6oDT1T7zOhzwF+9d7l6BMPc9grdT+0YNA1NsPCpx5soYg9mFVVR2y8exOVNUp43CuIXGAyU9JZb9w8vgRjuCHtwl+BOP4gf4/MIofbx3BjxJOESD1b4QhP31cDPkZpD7K6f6zE9M9rE738CSn+9UnNd2PQ8O8URoWWhp2qx/gLCacvFxhucKZwPdrwr1fvVZAWVza8Ny2OLgDewgkdthOdTwZBviWJezf1ra+xn+OQYEEsAtA2GR/3rB2u5truXxAkebnsYWh7eznBV1BxsE3hHAHF2kkGEpgtNovF6HdL5gK3PcUCcK7ElyMjUtM7NsQO3LD4Q89L3ZgwfKGjsjOkTNBY9Pw/mQ0Q+WoOxaNRDxqQgkQWsUICy1cgEAkAnsboLSYi4HEM7TwQwGoII+xHnMxAHpMtTUssapChQ+wm44p0dtGATwO+iFCcj2ilVoJcl12GNpWVen8Y/Uk4sY2qHlg4KlmW9DRGtBdHXLPDbkgsBvq0Y/cW5X8dRQPEosG8Efy9pIu1RQTIqBALNdzKaqMUd0SLqYA6sQ0MClIq5viflFGLv2gp7NQx0i9oRA0WTUmsM7jyRdsWbMtxAtgxNEAUitUXUryR/vtm/yaO/db3mifa4i1w8MJBuJogzSnWoTNpPWSUbf9l9BrOnxzZ6HizUf37VR/dhud1gdv1KEU0efy9udN3aylklG2jmtFS3DGowaqaxg3Vq6L/Rq8TzK2fDvICdRbX1i0xdmGQqAlfdCiGvkMtVQpCO/8hvWJGlgYcp5LqDujlhEu8ryWJUno2ywwPKNZNKaYhcAM4AnZVu0azfZEe5UaeYd/aEaKy5R6NPvXofrENECBF/ALecISJhpS6QglpweI0xDiWqEQAnQqQzvQaqNvo/3y8pQrwpvU2lD121nECwgb6EINn+okTXX/O3tpEYoggmroArrCkj3dtZii2pi6HfIozX5J0FVPhYsGtBMiau+HvICjmmu8rulNecXdBs3ykGA4WtTB7MB3UIhS8kRp7jn6JnvqSiJkRq0cSkQetXF+BOdRkRrQBD66T7K7lNgljti9B9YdHYXzHWZPUDtfqF1cSHwsRC+szpW48q0vy4OPIqO8FmhOlM6THcQlMUtJnRJXHxIEK3xzCc0mWboWVmna//kT/9X+yOXG0K2/pPJCwybqQ9dW10VfUzxN0a9QfCSfOoodqAjC328dp1gHU6gErQn16KesQCxYaBEBhsS35aAUwtUvFioY8oQIimxx1ZIU77J36BW6dMwfFIUOBV8dyIYZ6GTZAJzKmtPhmCIMX1QdPtVL1uFLJUde12uGDnQxE0dOAM8ku0ndX3YMoMTeohnqmlu1BIJ2roVjo5eaIdfrkTq9VOxbbapXbapXNtUvmwo0YLDiC+X2FdSQqBknPRFBrGVWYZ4SlZ7HqDgwCBsiA7BWs9a1P1gtzBeaoP2JqggtFEIagZqN2VLfa4yyPTraIbYAUbktiUFILun1ZW8igk/VU9Khi3F5LgkkRn0SJ7wCmX4F/IqVqMSnpupL+UrW+dVXsg7MUbKuIYlLFL11lmnBdZLWMEY+WySQ0lOmsOArwGRyOsi4NkjxNcFykJYNSscblJx8gxqmQWtokBacUAymRYEBk7wq/caLYNRa+pTNbuMYLcYge+eUGzlvbfLBdqPUmAp5Llc1po6+vdSYutdoSH1E/CTKadKGpE4/jbsTaapbhUJU/gJCsusAzi5wCK7i9VB3JtEB3Pc1qkC6KUmQx5PlsgHzdE1xkJOL4ymCMvhG3oZNzxmLEzEERYodfX4TQdFMRYqYHrm1mKH0VqjRQoGZ2pXEpiQ2y8SMz1hxMEi+HjIXvN27E3QqMdLUG338HtTL9d6BIlS5y9vgPObOYA3yOFF76W8IgVA57/2eltAt4r5MTrysPqun336BU6HJim9x/F1+G1T16grR1w42OQQNYBuWgIGwtyJS8Xs9ESrcq1YLpHXkZ+/SW2Tq+DuDquOQAZAJYPwz+aM7nGWjK4UgY1TQo1J0WbbJnMZrFj6izw7hPc8Ua7RK7ZoZWs5DM6h6tzuzpcwcZp++d8jNafEJ7GxZA81Wz/OotX7Hvpcv/OK3/vkPvZUPzWfN2eI1TyMX5NPzWUD3EvLMgUzfy96rehCmXehuNsh+RZaSjHwTPVvxLPdu3W5zezJp7lDhNcvfzgqa/Kp8PEMBwXCRKKYjx1U4KuJm2su+GDbqIDYgHT/iQrMNfL0v/aH/0fK4Z/BvJdNBjFnclqOWGT4BV6piJrQev9m5klS8TFITtlk3GM8LfMfq4ncUmUvvuMPiIuodud1hFHAeNokqWa7sPRQUsRBrPRsZrScbvHmzjwLsGy8Tl+whoQctYHn2HrPHDjZ4qiFWuxHsx5kXuqI59HBC5c16sgJp1DEPswPr2xdCe4qL+I/WqvG/dsjGHx2Jf28Zf+70YnZNRHO1TA0tI3HU8+FO0UpLfPWZyY9Mj0v1mFfP2zzQqKh6NBKPqq5DbImMzOwbxtigJ4y3DFVLHfon0/PEFMvRtxyxUjy4gwLJSDX2mCapgyIS/MISElCodP62IIbBZV99Uzk/qZY3VJoaUYiz4QV5yN0ZuT8dypkaN1v4FZ5FPwGAYjmkqKK6Epf0glyQlRTi9TczWtT3w36Dy151uRr0/Zz3krluSmO9hJhuFNGQfFY49rD4VbyVoJ1gsrpqjw2pgEf2fjRrCNWlxLVZj4VEiUJMwbvviggvC33j4D3l9F6RGkAfgUvWAdrCYAUx4mBqgkfW+YFDqhZrrAS4C38VDi2bOPdqmttx/T+vGYU1NEVPKsoTPgqrB3yvDwIYvggcj+Rut474BkTR5/mkRrnu8S7YVBUm09Pr/k5IV2tYRFL55m4vj/G1o6p+9gGZHEAcYKfmGtUqqaljQarb3OBXz9XLorsgBtDrRgw4Nf8jnvAJP2wmt3mev1MYonDDUPctTN2bG+uFr/79MFgNCsqRwl4ACk6aklRTzKFrBIRvgjiM9KUMZB9EI4/fl5jqmi3FRHGX+X8liDA/1Hmq1Y3YVxjHAziPrsxr2bjhfOoB74XKtDx73JlwHMguXI+iGpzxwJrRLxRpQP9+iciKlNKBuOrk8vK2TIIWAWVcnqFZSmLuGAzFAUlv5TUydaOZVtfIAY91G1qMsL9aNfZuFenr8iYstr+e/YgawKBAdPR9syz/MfTEVLKYHZW16mMfxT/2/IYva2h7k5zOGRDpjuE6DMmhHPnuQ9bgiq52RQrNIH/fd2xse/Xn/wOPm5b4ZW5+2Q7Ao4znJSYtc0NHLMVcHEpb1a5S+lNh3RK3QKzJjxgdS9ZzH89uHjyyIcVtzFE1t4gSGcQiBIckN4dksebX+zG5QuVQI0hhADiwY3AS5qlpQeawqqPIdckoFh0ex8y1ORvhdXy5JgexzVAKu994h2Ygd9YH6gJF7uMhG46eQxn1sGL5GE4VoJqnNuh15EWpkJeSclrKFcCNdRTjXHsP8w7BDgvK88gfCmdhknftXWcWL9R+6sUY+2XtaUOhd4hr7vvO+7JrfuCMv3o6N1iWEIUFeE1tY7KBnrWYvDJeD7RLCbUOIHqAGqkNhB5o79T3mVqW7jekKz75d2jTKBgqVgZgtLAc8sH5w2HiGy+NMSit8xR+0HfHE+pEU6BQ1B21WlfjL8e8vIF6hjx5/VuNz8VQ3YH3PfwxtZvpZ8R/l+JOTyxXl7kJoicNv8Lufp2gBUwzzq5tDIo5mhsOeNaoAl1S1mwCDRv4CqbI3K3FPD/mr+zhlzh8ZbHQK+/3DNaLeUQP5YErQR86+D/u+93v+nG2FPOtL/n9X3vW7/7KB1m1Yuetn3jqp2d+C66/vutnbrlhsOMTiN1y0bP/5XNf/TuOLeaP8McLPX3OVe8VzR2hOfIrMcPCpVey6q2rrJ/Ya1bwgopBmzWq9ZE6V84XjQMe2VbTAjZxS4Iic8w2zHDkzKWALO6vyJ2pmY0j+bzMa4Uxae7lYd51k3Wuvyuf4UK7DFtwoWtFZriFeW4TmRmUc2kcXcygPYtcEC3jv+GQ5o7bK+OjpyP9aEPe0aYWGC5GCeFa0bLS0/+Fnu/MXuDHOhrOfgM6o5qgqaOGMNLjfPqbJ/r0jb7vVfx+V21XCncHUi0n6PvI49BHamvZh83CGTNsjbrywRvP6Sslh4Nn+cII4H5diLlWirqVDZbDlo+UFP83VBteu9Ay54zWqlnsjIdS0En7SfZG0dXyxIwd1bO/wC5S29b/8TfwOaQkZLchlzbFpL2W07I3S7QnCdlnrGW47If16PKNng8aYAW72S8CfoWa1TJgrC4FKtviFNU2q8Qb6a+nukrc4SoHoiwqzmEv7TEnCvUSYP6YS1ny0l9M/IXrwioZCktNzUgZ793Khu+iEHaZSN+6eioT61siexriN6fpVtf9T59v4yrfx120+fUWJPKbzIlT8waTokcHTUTsy1M89ugt+LPyNh6Uz+CR5B08FsTN8awR1GVqzkTUE2HLUVSY8ghglNA8VIut9iLMnoA/IX4sUguPJUrxgPHgSLRWltURxayIQJcJChIxQM5aynCfriEmnBqxVCYtjCaBtFK0wStll6cusAM1L+LBMx6PJVrAYwEdgORyDmvSHKb2fB6lxi8G+Ddj3GMeLJ3er65uaFZElVRAuAbXK7FgSL7F4U5XuMGudqPHDaIV5mCokc+3RJANjyfFFm0lCkBdqkEGZVWznZgHZtT1ZEnGqaHj1NRxSnWcWjpO7dJ4akbLleERhxnUdsMRAxo8JQGNJh4L1MAjolk9nZFGK9jFI8KSCQHKErFQJkWVJH1ATW4qyJ32Ks6gHeQZ6kiYtUZQ561cXGeGE7YXsbrPifMlYNroeMQYj7odj8VNx8OXfg0p3lh3w4Iix4dlUcrhYVkyqs12WOq0pJqzZjOkBoV2F4vEqHZZT3ZtkFYI95LdJbQ71PP20O4JqT6xS3RryLtnmy1mW+aM5yR/9N794cTt5NWQw0vV6bRqfz5bWF5heIWztbuKIkZT66JRAF3PBtRtmuwXJHsYFFpY/Dpb9AQTSU29yioHs3qVVS8rdTBCnY0CojT8DHMnqsPKz1uiJJ+T62QZYJjgOiuHaRZH7gc2mJ3YWB9yzjmM+Jyxq9J/Iiab5Rs6RkNaqVjGPftyfQ0K+gc4mFnKN0+h2y9rtvuRrZpnwRXx6fG0RX65JbaUU2UGMWS1dREe9FQDPsIVWRwEwC0Ubgx29TPxBLyFQsg61UCSXpE1YrvQWD6CWJp6uNK1lcuAI6ptisoLek+wLhN0O+rCDIYePSnQc9yEBxvJNp9pdQ2twklnrvZ9xGrODqmGR4l0WmOQqMBNN+ubnuHcLW0ltSlZA/epfucxUaizRjNV1/NceAsSeePWgwzHQ6hE/B/t6Hd1pPAyQ9t1nJZp6wFI52nbASALfMOIKvuWskaU/AJUIzjDL1eXLwN+e1n1rQzeYZpErkkMdql/FTcSt9O8mPPF7cAdVAemFbQI4BEtWBgCJgATdeSWrjrFA8BRUfe2PMMzYelrP4OZn3xOLJgKciIl0ww1Tu/miTGTRZE9lELKTulgfgoRNzMX61UztIM/L3S/IJt3mjV6xFqccT5kYHOKSdtZSdM2aL/zxE6XNh5tBv91ysaa+dhvsXK8XL3M5xQCdb263BZAaJvkhm5boavW6dVJTaEdKE5RFEi4GRm46FOGR/CuNdvmaANsq7QdcpbomsKHrvDPvYRBKfAoGKQpZsEPlDexx+aa0aoXKw2nQkIhqyLT9/9w3sef/MxDf3Ux9sW+bJoyIXm6SwPAHRH44HXCIlWJAq+2uOsgUwaFV3Ss89Og0II/ll7jKZ7YIiaHeVcnPKj+Ltg3A6eTr7jtXH2j3KsxBDfWVbS1Dm+w8ETX48dOOEYH2gFOZxjbI6EYSG4Irp85RFfOUPrdsiT4LDp9LOZshhvz86BQklJIQ1fpbEXzs/DIlWJskenAdCoG2p6DW+1VwfQpLoiDC9yMqcTQ9r6o+2/HxOoQfP5s1zOHgs6kc26jczjJv6ZXBMPiCbflu92nO2XC54wilLcN0WLctxdUlb0TCkBdnea3UUZnuj0WzbCS9Q8UO3pYUHYPcb6r2XWnN3sbzRInAl07sh9r0xNoFvkyGzOLd9AMFLETCHxlDw1TEQh0vaJn9SZnkRIxFS7uvCPPUrU0JStkXq+ADvb0yJN1TefqrWamcpJOBTs/HE8DWwJ6BxpOwvnYCg3tEb+ew+3dhcbLSqKOKFi+g/QttBXLSk6rYiMND+L8/noO+HNztxsCfKouZe8wvMXZ5/k3gZu4ybETdNZEXAM0tGE25CEt4gIsiik/WZiImZ+IScdjmB+xfMsDYSe41gpf8BfK0yv/KpdQ1wuZ0tXdVqg7x2cXER6XF7FqwHgUAdh5nXf5zol8VfDaFF9VDQjsdC3L8VZfzxt23bhfDvyVeIMNSvBYLVKORemZGA1DqHI9F3SOUtkSzphMWFD6Hkx5KLmb3SjmSnEo5Ag5BA5d/DFZWZjWWOUoR4WN8Lu2iPugtAhXfJcW3R5uYHZ7+SLMMiCwzMnztLQhm5wjjH9GvGdJGu0dDpmxasDHoXDcamqdwQLKrFOQS2rjIIPmOO+gQJGLg4KrxfVSAVqG3U9Gs3kHYhR7ptEkHI9whhBWtqDFTbERJ6tcdUmlrF0Zr1JemDf6MKYslG9JRwZatHq1R0pruFNJN1T3emqLAXJNLhn4rhpoepU1oLC8jZOlN/XSwOBbyM8U4Zf71yUlrxxVLqyRp2JtXUICPS/fQ37/xgBGDE/HHbI9lj8M3fBEqmMhqcRZK8dTbiUwcc/Ya9YDh0cut1wSrPRZrzUUQX/gq2Szfw8PXjxZc3yiahceVbW7rOdmqixpus4EvDuKtMi8TvCpYl5wEessBoMuULhqabGgqVggcwplyJyqLJv7rvnuf3z9Vd/3hYuH6zilgKRiBg9h0tTIGy4B6HUFsVzW5wAUO/o1K1ZV/ho1opEt5JJRmbUo7q3nctKHHW92ANS+Cca6xVLtA0XAggk15iLSyP35IlIXiOOXtCXLMsyHw9K+C96C8q2f5gHN511aknUuyDs6QPoNl6OKTcLNdflV0VQLGUueccl2OA4q5ndpEfuMGTxm1H1KQB1OMXXNaUEoxtZbnihrTZWIQVGXKpb1o3opVaH6lb3Juuc4AKAt4wmzQPJkwiNPbOQzyEJbyrGpvNcKek9XgoNJdb+nt/I6chWzI4NdzKiNupg6UiXpu5ygIxrwJMAnkLZfyUSQ8wL3OGBR1hAlHIlJT+DN5V6vMmEcya33qbq4bMEagW5TU8FDkdxzvwCNHZ0ddWBRfQwyTaFHTE7xprc2GYmiyu5ZcXLZ4iRPakBuWZzeKEoucxzjZMsgFQGiGEEJLigb1wSyA6MAx7sC8qdYhFnhY98BJxEChwNq5YEaFNHSRNXdXh+nOaBPjL7EOuH7HqPthp8v8p4+yrtoLLIsVEU/sQjKcV7FYDjqC7wCRkjErCvavAwfzfAQdcHzdKkD4YgRmtjNQCT1hYK28xQU2G0WHZTCpC3mb5ckKUBxXAZq0fHXvUcXLVfRiy+l+6aDKAJZ/TO5+5yXf2UzghaZiUJN7U91Rsi2AgCJRylgE3jctE5cMrQ9K60M7fufl1774Pv+82cuHuKmoaJyS9F7cZReLVp65YhetA4ZMqgOLQvF6WKU8YLd6BLQwjqmFsSBbbRlZbznlLLN2718XZy2LYFYVheIl2NCAYqYKkMBnlB46gIaasBFDzwE+EqDhIboaWTkKEKkFAHTM+9Y9tiAYR5v8/2deBObUS3M3kWdlBo2ujDAk8osjsHEYBbHlVncKhd1FcZBew3LkF2UD4d6t3sZSvRz3G4dd7M09yqZEqzc3kuKFosGCD98fDTbD0c/WNWpCVDCgbIItXS2gX4vQswCEguZZN7l3kFiquTIziLZmgZWcqkYjy44mdUyYLYIKC32IwMlWZ9WZVZrrZmefm02qcOj2CMicJcNDGwAvSXJE9g8NjAIbJ5AGy9nVuiqLMMdlQzMq0hgSdAoy7um5/MGLxTHaIk0tGViYVPCsMWua0U0HFvaFAHj0UXNmjlkRMIbzJEypC/t7edGdAWqXQM1mrOkfUGMjYH01RgiTOJ2k77chRcyLwO8ZOblMF5q9iXgl702G14utwXg5QoyRePlanO8pyanFGDzKWHPjbnHorTmmgp7FYcwKzDpKRDJwaI5L29iEaRZxPXrgDyAmmc49N2/IS7p8q0s+iy20bZhvp1aGwURDfNcsWPOnDkvCVIWs2Jubr46z9uVhQysUmX3rmMV04KM1xadeBGGYtv6IOf3fqao62OMZnTlnqH5AyIyZHDPi2/oWCWl8TQdI4z7vg97xhlH7un9nmoTEheEuKfScODR9HwuqGrvxaSqKQW9YocyPN2SxQHaOP6Gtq8XO+8YwntIofS9Teg90gpxsBirIXx+TbCF8GgH7WTDR+Or/jIuHJbK0rDfiRkd01bu+6teeukLPnzKRU8bigq7B0o5hKfBYqBV5qiwPdDaIngHT/gF6kGyxKl1QSA+xYacW729XWsc2QVSMcd3tUmkCMtfv2btb8XMK4EZUscEoK8qBdDTFSvWWKAMXISh1JHRleDbg0IoD1eUIHtT4tIpcY0pcSGMd2Fl0hikRnb//0vfiKqTqjgZTdWUvDsK+Mi94vSxerSi57HySMjP/lbOp0MYHSQv+03dSOq7HJH/FmLyqIwL9j1Z/v3FxdndSOJjIUgf7Ib9GJQoKa44pRTwbDAFFehtFPWKtnSdeVWBW/bbKAtfDkrb39xn9przJ/CsiSws2Niwu79z9sp5vm5+f0c/hb01baL5GBv6SLg+oN20TqXSJEx8+MN5khgG6X+o9Vy1oPyRw686xIkE8cD2F5/nP48LuA9QohDEMftdu+luKXhO968CSEX99CorTo+swfZd/guKagzX7Zqb2NtV+7OPHrLOm8A9cI6k1OyrqBckovHLP6vMkN8EzYF/wDj2/wo3nfuscwCg9Y+2Liu8nioV6Ck7vurfjA/K2ExaALaTs26gJj18tx9kvFCgbFVV1rT+Z15fLSJc46oYgK4EgVD5ReiKAAAlsX/3q1wRiaaoxgOG1Wo8/GM9bIpV3PDlzlRd3QCkTqFaqQkozD6mo6GG+xOo/EIjAPKXvGnur4nZa/gWxcxty8yFHhYUuEJzD0Y/b5IOiMjSqAnLQtlrUSWn8HtPUniqQcVLTUHh2mAL66U6VsBGzi68XX5Ffph1rFsDZpxxP3u4ocYBqgPCb0MhtplcuV6AFKeEetqjDYPoDmKvgnWBUuXYW/3tP1gkP0Awc6MtzqjtWpwnRndTBxlnlklPCoP1GEIh/e0vfbE1EJ6piYEZdbUxS82NfK48ssPZqV0jsZ7qImOf+bxcbOMTY2qviSXVhWmZqAlIQzGLLXzyAz4jejm/SgQT+kSuwVuXmGg0BuBSPUvcacoukP0Br6zgg/bJkaKMldC8sKQLvJDMc+5FgTMlNJfdAj9e6B8aAOujXeiZPdyuMZkPo7hunyifc/D3SE0azbTVnunYJyexqVJuuAosTUsBVCNEoDaiZ2kehSRotPUcMgOeZYYamlH3lBMjDwGtZFCjCaGg84HSznGfZYWDTzJtzOeMnTA8GNfVZWmXH7DEwQ9xYV2XM1DMigTWNiNKNqCHScGBtY2hsad4ORPkufVirmIVu2J5sYw/vJdckG9L+EWC8i7pET/5OleP3wWnf0+vq4M+olXxZKuaZLL+vmZ1xuquDlTJXw1BHbOuBtV6BeLUx6iX/YFSctGXxE93QFEpOx7okrNP9G43PofzNvQZppA2xtyb/1fPmzQqhFtTKjML5aSqf+ivGeJ408tQarlNbJ1kf2j1xaD78Efj1kTfE4ae6GSHU+4teBSYi0Af4dUzyj4ufYpVZ6qL9QccWCi0GDUi1LXexx/i7ugtAfWklX1CFhD1FBlfWiQ9iBkIogZx5avV6RL8c1LdJ/UDZW70q55YC1F7kph4FGefQi7rJCXGI1T71/FGVdwNGrZvd/TD953ztTPPvLLKz5e5Rgx65sGImfaAGtCsdpnBrq1DPZuvAjn+m9KKMuMdRcu1gJrr6l2waN6W3YoAbqXz54Zt+fuLcQ/MtQCGIKGInZYx3+/azH1ZV+OlLWoeGWp5Q9e2lK3GB6pgEotdi1JsPSQPqEN1gZuu5wNj2waDiase9whEPYWou0+hWKR/l/XW4OW1NERyNCzvVYievad9Nfc1Q+DBof/NKGoOJbhQhIaI/lsTPSDvyLDiS+Cg8IyQVRmvHneF5oUgjrMvGURy9gV7p4Ohig9gpRgiKbQHrZBuh7AxFmnthbGIBo1L78opbgwiLQZ6kZfmoVVuC5EkpeVwPcr15X4/Ga1DPCeassWdvF7o54A/WgfsMQWoAy3hcuRQDiVJSwVY39v2zDecVduV40OGuRsWMQmV3uqFwXWOPq3qzhHBlnU/jRJKLBLrN7gaRL71LqWWAouYwzHvt+2tbdKacf2m/1UYkrpmIw9TcXDX9168oRvFEIfEPu4bb0B105KxfWwANX3nbLPBW5WGOTzymd40Xu69ouKa1C/RhwsBNwjD+OB0SW2aMBZmfwzMVGkUKZk7lx+QDUNvDwRv91r2J8ika0+Ih1hBgJtJLGW7VC3LU7WsGvNs8OeXqHpE40D2p4L7TXOdf1RrNXXBlgu2QWsaDAicrsgenx8hhBF12MacRT8OwQ0/6hClbD0kMf7Y9+ULalN2Uc/BlyolT60vrezh1Ao+hEjGip6aKJI7v7xFg8wMVBqVWr3NfLnSjS0uuGI9A/fw4ap82LMfrtAKq/yl0FMY3JEv4yakbgMbSOePBdywgHQg9wj35XIwjSPVc20ogAvaSt4Gf1LbyLcJnFdHpCvLgKerm9tLW/HVdn6wMIdonqtYyKHZGSkLqYfWW3Q2rwy5kpq5HbFtOHj3HrnRP7MmddMWLuOIxoG39qx1gAgixsi4Sd06gC4ebR/ksJZMg7wFFxo4XTB7fr3lbc2mx9DW7Vl3fjq2i3bp+Gq+pUSQiOqQE3YVT2Ymc6pzCSmpN82CfZGLuAc17lLFlEWC08NiVmQnUFGV62lTvtyR5zhFF8d3O/nvFDDcJIwbi+Nyz4wD93AVHeWYKYWcku9EEaKXUSsCNZqgoHy4wbfxP+c9fJ/HRQc0A6DupEDTK4k7rWndeWUid8BnX36aTLcF6jJYnzu156eJt8LTqLZJpafRqVSbqI3jtCmm0kAr9blppzz8Wa/YxV+dhkDBPyzRvYKTdlHBn/LL5ZqPX4qdyIfAKZpvr03Cy269Qjyl0TuFIpEn/vnkW/7m8x7l/JPnxhKBLAXO7GlPXqojbAd3T57pGM9CrE074fgRim60oKMY5h5GhxNO4b9T7YiGMqJTWncq50P+EK0H+DYd0VPtiJ4yZURPGR1Rrvo0/tshIxoeZ0R51OF/ctMR3YHRnqjttE1GFG4rZUT5qx0InF4d0dPdiCIfBhL5EDjVjSiS3IgCjsB0NH3w4epfcerIuJ5GOcr4PM+Yp/78nsuqf8UONJsLeOW3V/+KXajnQY+BvlPwz5ZAyE8mFb+A7xieFIS5u4Ahr8ClMIJ1xR9rK8OnHF4m+FnwMyNfl+zWNUXtxWcw8TlDDcfIy3uVZ6Mz3gtdFRxQLbNa1xZzady455iDU4g5u0XEqpl7eGR56VSmCU2nkBa5vdlANhk4NyRZq3xG3zFpk19x+Ixqk36zVBx8kHdG7aGsBRuDff+l/qHr3xizyyNquUtbuM68sY4Vygn6hkNKSwUL8kaSjyJ5MCi3loPBkcItg6RB5d/Tv/K9cMrFYb0jNIAumBG9VtwZy4yzffPOrkVgQmCpA4tVyDIFzmD1KkbTJRVgfQQVQMDagcGJI8iscyKiWjbUV7UBEqmwRg06qaXIhH3DknJEIY4jjEWrUD/xVQTFki6SW92SDXGh8oah85ev7ow9fJeJb/tMDFf+MZpHvjCYkh3corE5LcZVuL/V28HpayLeh6oyW2VL4Zc2fZ1F3yKouoFYB6d5B26tB87eSB6W6O+tAZqy7QCcRWqLt+ER58ArQsJnbEJZum4JlMzY3YhPvtuN6IvuRvRFdyPy4nYjvmwjYvWZYhsmOwXx9Bpr83BnFo8EVxdc1W7ax1oM1bEb8awCpCetMrsRX3YjvFkYqUOZeVO2HBCLXJM4EI7V4ctuRO/WKBBlN+JLSwWG2I3oN3Y3EmM3gsTKKTz2//vPDABUhrTSlSNF6EDugkxizGj5WpFtqNyYqpbpBsmVqeCiEKWko2Olnx5+NbA6LF+u6pnNN8bF7aBkA3nHcJh+yuMpP2qni2p6iO5nf6fnkv0FY5481BhcWlNYSaTxFY0qAjwipPWvK3VGIpSqVWJqr+HCiLfm3JRbp9FeJQP/gVkNVOfCuYkJrSSOOF7PYHnIVRIn4p+CFypA4wQOxX/hdZPmi47/xdumfPFyvQVo7yPqjtN3e6in7u2k5UTW9u77288fvWDH71y4d9+vbbwxfmBpjw2cv9fuMcJn9XDO9KzeQPwyhKVfhnLKX7B3kP4nH/vKCeu41vOoYq0OKsrI3q4UEraPfDWO/btiVieoWJPFkcwgfacXBHJotdk5W6DjnvsTelEIxpWztbo9N6uPnZvp2drUPHq4nEfqowHnncYuCQW6Wc/+F/asYydt/5nvtgIvMX99BWVbu1vxRigXsHx8ha3zoc+Z2ZX9zY1SoNOmS4BHB03Ra543zfSymDPhB9RNrcllSJRkmy4kUaWECKmUsI9aQ4gHmVP4jGy8UQ5VLEbUg7ooMlOtKswLfNsnIZwnEusFVbFeNCLWiyBpGRHrhVhTMCpHCqeSTvURsV7i2kKxFevFVqxXhyLLqFhvdMmietVf0fcj3Qn2wnVIURKKp4j16izWi4Arkey3BX+er6yBGvbBbb1qUXmj74m2tld4kwD8OgAOciAmyg5wyQjg0goc6hZwdQu4BHcRjgu4ZChlO8A1KAC4UqpPAVfiwAUwEQRdTSgvNclCy8ddGU7wUmPDu2jiSGcMiFBlZCIMO5jNf69gJAaaALLweyDt/M4BAMxe0wQOCi9wIgrxs48jhXh7gPOLzfnGPKiygp4TN1u2sMoUwqvY4PFk+sCKRdOYvtAwOupkRB0+TWP6Qi2GImX69ELvNKYvGGf6xGqvKfvKIgTTh1o4EExl+pT9zIMpTF8wyfSFeZXBso5FJrmsYITLCk6EGXc+jphxY+AFk3ZarWnd7L5DU3ZXbmvqtm+R275Fk9s3ly6pmAiPqAowfR3V/fgssiucud/Z5/QVvEZk7JUqy6RW8+FucE1uAOzH726x+igRZ+Fnz9r+/rXXrBkSFWk5NblVj30d+EaKpEGIi3RfF6F9AvHalH2dz62+V/1nCRWT7KAM3Lzqvm7ETOwnPD88joqSE45jQTPqMXk0qbkUV6XedRdMjqu5JD7uEsNdHV+7SVzq1KG5BObKSraHFKvztTH26jmMx8ZZmXFdpk5RVPHnjteN+ieDhFYSfefJpeqjrCWfQcMGSl3YgehBEPmAz02ATwmogu0nNdigq9qM9dFO9WNFIfDGF5IGDRS9mTXtQE2+rSn5QHe1DFT5CMrppNn/HvPF8mf6vrVmtYEYi+9FXFVxZlX7+klgB9OTL38CnQNnzrEGEHo0mX7JZyPXggJ6uhDgJ+TjGiCI7KwCJ1IRFKZgTaJ1zefXWVE14T+dSbhKWOGXInAAHNJdWR5U6pKZUJe6Qilazhrqpq4Q+SLUpfxFiEk5vS4KQHjBdMQUaJWG6Qj02whMRyBMBya3shkjbQnxE0tb6qhaUSPWtujF8nBNolO0g+og89Naw6tAIWAhDqDWyZV72QOvrWtI5YQ4PeSJrRx7RhQaSZNa8FaxEvkyKNlf4isZEckr4qD7FQv0Y2TWA/9QXsUXEOw98wPiKJkWnVReilJmpLMsFT9N/U/X1CEGo8NH/oFRD8VBvQ0l8US3TflrqxpAoTPIne41cxdzMfsr6aNHUgQ/KpIt3fvjERoXH9K0JH0F9lbO8I4x+q2tVWM3+ys+4vz9nIysQjv6XifV/aJaD34W1XQXJ8sZIq7BuOB+ObZdZm9a6MfAmvQFMhLkicFyPKRihFXeUKh7c+mytoDjEQ4QxfWg3kRoOjhFT7IJZEZ7mX4rIJ1ZQJNf8dmkNaEACanHHevyJZCovqFuYfrlNI5ZVU5tx5XL/8AbEahmP36orKbFU9InafyqHjAXopUjw3CA1XQcIvKX6qNdTBP3MzH4DubFglW8VNT5JBsxGQBpFHVhUTGBRcXch7Dc2OPcqWi0SqEqK4XTHdXzGhsSnhfpZ8+mAI/LjSTIOgaBFqS6UFdVYlXJM/4YpeW5AdflcnGaS4AGkp6hq/sQXNLw8VjNhXZ7yBMijynyAcBNMhQ+tOvO83fJvHJKqnkTEVIVGnktBejiSyZE6KnTjVUbkep3TtpQxMo6wAxHEijwybcHznVRFEE/Xpajq6BKoJ/sBed7KMDceh4/uHvfiTf0IMB5vAULJX0/+6I69cEsKHy97yoF4uclcik4AWNxFgNUlvP78V32IBaVoq0+HNtSqRN2+zqrlbrZktUwo1ZsmtHOvoTKYbZhtEoxYXog+2c1nSkDrcRuQVYB3OOKcFfXXUkeUsr2S91JBHQ4HVjzDgwPp5Z/1GERWvXsvKZWpQ97FLiR8WVkMNovKuowkHpBcAtn4Ir557C3lv29in6IEw55WsJBT9NUvT77suY4k0vOWxRwiItwNaAJtpI6+Qf2F6wJnQ318mnRHEJ5OcCN5Ns4uNuo2eyBm2mlJ2gvbKvvgpBNQruhSBooaM/zb5F0tSV8sycmR7toWmJ78A9o30R7Cn9jPW9OGv9CG6/uidNAzjCr6i3V7XNTUZea60cc3PW2+Uzest4tcA0jM1jOqZhYs9QavnsP+hOZlv2jQk6Gx/hNfbZOh4VLVQtUp12sM2ROSDBMpuky3QUOagMVI8XKvbpFxLTRu1vumKrGY6AL5prqpfsYcB0IwYu6tMtZcm2h/VPTfGmuNKKomZM6YH9s7/wEohUso6ff/ZPpa1KJe9DEtXXCgtiot1IzuC76TRrNNL2Up6eLmHjl4lzL/gTx6bZpsVjO1a7ebmwPJ0W42CFB2TT720Nj3lLfDL5kiud48jAQ6qzNXqbQNWNPgUVKV7yLKHCHlJp8ViV5dzVZylxds95EFRSIlG0pGqdQ8F3juJxK394PdnbiMNE5cYH0KQ+NS4EWsEO5Q0Nkz64pp4vuX7uGvb5+GFCI99CarkNqUc9FVuO+Ux+Zoeiv9X31waoHE7rTgLAZ9yojdRNon5f2jBs7f9SNndf2nBs7W0qqFKGlq5RSAz8Rn+K4Fop5lR18nezUsVVi0Klfu5af2j7UgKXWJ8uo8eBPhCPO7yILPt0CcNsRUHcHsTJjdZDwbzMJdTjFSDiiaDwbUbKyJeoyBZ63rG+hvKl+uIxXoSbF1hVwCnYMMXq3Vz7V3X4MPGugET5O8yiEIny6tt9svmNK9xfGQHasXoxiW/xY2fzQnFpwygVbriqGNXfP+tJLBH7oAt4BwXqlYu0ERhVVc9pztZOBNEbrtOqMqBpZLq10xtirwd1t1NnUOkPjAcKTimNEoi9GPzfVBZNxz7qkFBREA2JgXBOlUb10RBmXjig90m8rHkrrOoymPyLBjp1XD+GLXftfxu3nxqN82Y4DFNkNgmge1Y0/SfWyZgmKcyR5RxSIEYvJmak7juy4PgR99FyPx8XYsfJ/ik0gWGr/KnCua9TNra9TNdAPfb7ncGEtxCv57tJEAxQycN5XwRPq7IqpIQ6DTXeD7Cvoiw5EJlsS8UXsqy1qBhxUObN/dtKoFqe0DjBkC2lArP3gr7rwYNxUP8Oh2LZmDyClrxgfo9JAKq74zeh9BV7Otb8xaQEdqbT/C5/4+U+wYxt0q2FSWtgGN9B8NKj/88hBrT4/zmA06Chd/Rc0UzkVrm6kHiEqAAf4PW1zAux6wQtFhaFhXZU0cHxS+pwUExok0GxLmUWMMDojRocD442yRYlCvCFQxluiD/iSeMhgUZvwte66AT8F01Qw6ozCma7qYIif9uxhxTsr4VKtdUAPIsCvIrFK98Tpp7O4fV3u695HBK63FmGZ8H1YGNjZzTO+Zv/VbrDhf/pa7btLHunB61QpA0eBykpXfMuL/7r3n0wZ3NpcvBBH7vMKH8bpkdSDCkYLtPbCvlb7/7Vro59TWH6HM2mBQGS5tJCjfthEvVmjfJGfqp0a2DBLX+N7/rUWPv6t06EzvSE1+/7Q1+TAWEvsKKDUr9JIU4PNwbR5YSjleNAYGQus73qggE9Rhul/YEBiOm4AFRioAA7vrifWkCVLX/mv1LS+t+ZE4WKs8XnOhNvBo/x+uej7k4crLO4ink++faXQnH/sRphvt+Bn9+AC+97Fzx5+31Ne18NWC7batAikX5JHeOy1tnMvGTUkt3faxhtVWiG69WIEximuKP40+mrRIwXRkms8KbxVsh5EW/1soWj0T5tW6aO2sOwmOqYm5ymfkW7lHTx25Vm1AH+8AFek5JYvFRZSlpRrYJVR58gF6DlMqXNor3H5KORNPTAo9dIrLSmFWoPW3GbGrmfQg0hca2GF4GUXd2Oopf4kqamr0mxFH4GaTPzzOReDS3QtLk7K/FYpYJb46wSkfhYm+loAG0W6dsxBroIKxJphB2gIaQh1hkVHxMTUEdtSqj5gYSNQM7CJ5Taifp1nCuTYYlPGoCCa4eIsxGcsYgFeu6iFJadlrOAoHugwr5VubQJVrxdqv4BwS8hmma1VWFFuC5wvopiT/Ra1Fwbqg3rfnS+mNI/zFC4ipJYwKYH6tBeFW6rL7yK0yVO0JlXkdENharRj8Sw0zo2VWSB4Ttodw42Ps1tr1urco4oiVafWXzuBU+vN7aK/9kR20c/2vNFPa/qpOVTykLtmc/+refG+8XXH7/CPBCfvuR+s1YTnfsSFznM/z68+DzoOTVtX89vaCfz4f5JZIc/48QeP5Pz4fwIpFCqv5Pz4v/p1zo//5nU+Aq/+/Ze8kAtYe/x9+7/mddN8+6MuRaYx9/6HEPconXcfft248+7uAee8Gy9jzrv3TnPeXfBnVzNGrz0KD96nV7bzMmGs/8X/zqPaf/oP9L3sR6XT6c2+1zg5V+4F9uvOlXtYceXuHLl7447cIaJ5SPdXYvcYcow7UAUUJnGOGVvSQK6yiCvbb8oVbjrUjWdEoeGmcUSqIhAuH+VUdYCFccYwI4M8QjwkLfvYa53P9mDCZ/vvIbWWvj5mh4neK92F+souX6d6/5VrMz6cYJfXPWVrpfWjGS1fmCwVoujMHRGDkCFfgTvltmXoOYiWUY2zmWq8/3wGve58vMjdIcPeynxiOQOe9rqq7BGQyTjFUembOmiWVp1XLcW2F6J1s1DFKKsx1vJG+ZV6ZtcIpe4pxa4StB8luFogIWQKkxrRuEfwOcU/tq3aRI4MLjXG4AP4Ym4CDxxA0Ttqqqn7IoWkKZkQT/En6AWaI91l4WuQwtC+erOKxd8mPm2JubmE9+8jZWjrW2ucBSL/CGSHRfywDRJRW60UyI5OdvRGotQqQVgHXJqMxmi3ikAmmpgq/DxAJpH+MCQErFaq5lOMBsfmZrdCp5EDUMFIWegZN7RWbShpQxNDA2Ko7diGokeQgLcopSS7HnEUyS0KJOwuJRTpMUg2N/Ep3NnMpbB1lCt7Tv1QL0COORMOx5wJR85RMX+qBQcYI1++VhfCQh18QxYQYcmCTnLnPfhVr5vqPfgIaJ71TxtAJhQKfURI/Mg7/7SxmQcRYWKpRei6cwcbw3B7olpV/OKZdjZAoPDWNFjd1AlSV4CoVFE/FqJGIHjigza0Pmgh6dwPBEWdqllhOgxUdT5o05FK61MqTUylaxXHt6h0fyGdAsKM+ZkN1tKfA0OkV1cDs9XBqIWlwXrfwhxJeWhH39NUZAZ5xpvwTIaq+/tVmwTFgI33Kwt7BNSpLuxyO1sJamTMCEiRtiYfaQHkEvWTW8Hgfzh0K5hXWcG8yhoWjK9hQMEHjIwwVOHQ62SJh/4TljDnaFwYPrQyQr2u8pgL1r4H2vfYCFB1jROptIp/NJTgDFa/heqawiHCAtBCJcgnjxAPScte/zq3sNUnFrY3PAZ+5o0T/Eyrys+0JviZ3SU/E2Y/jI9PxL9897TDkwrLq7rtWOthH6486PgRlE2BFdNr/Y6PG+WLHnX3b5rofvgS1328jHX/qdPYOT7g3/8oOLlCwKD4ygtidv2rJFoaoRoRmkV592oWGSbNcnz4JicNX0U8B99HuMvShqpAdrShXdvQd8ZuMlPJdsEHCc9NOVS6XC4b9a/AginuyRt6s8D+V3oab87EcSyWarAkery666zxuI86cdRDus6sml4YUw2wroRCDi3AstUaRbrEv4nhwT2MkGydfluqpQigJwOgWOrvW0OIa0WKUtma1Et+9mO6IwnLeO5ymXgzElvBaBqzomWGH0cGZTKb/WU9XbJshe6Rf8IVgdefdB/EfYyoYTDwkAy3aHv8lNQNDGOsso2o4XqgFolUumy6tiwAFJuUVKMJ0Zkc57joJtQC3OsoDIMShoGBYWBhqCHEKa9ZqzQhNb0umqpGWo5yrRzlGrcPYzxtcHXcJ8e4rRb48hjEwMDvViQIvwZ80rjbEAdzfftz0YbVSzaRMGUK4ZhzvRm59FQAQGH0tZHCQ+QebAcEADw/cT6GYdJvwULqVk2+zYU6aROc1OD7ea3ue7oB5zbYoyANRTxuysCI0bZOKmvy2TXJoyHkQcEBcqkZKbW35uvzUjD1QfrboV9n9SlrMa8qv1VtIKuMJ4bglOuIoWoTCuSxoj0bYcTzYcYlCMMvnRyjNfSgp2nOUf+sIq79SM2NSkgNLb2pBftab6RFx1qqx6XC9cZm5cjJIXAvF0axXL19SvFEeVoJWu86Z9pfaXrfO34lNVNJrSIR8rQSoPJJd2ZzkABfXC0TXUEDUdNxGnLyrTh+b2vHA2mqhvwMujTSB3zfd6gEr4XRiFZ86IhEIJN2j4Qwac9FCCoRkSAO1uWzJKzYtgthVp8TJfmLxXsUfna6dmrr8joml5PTUR1PTACtLNaafK3J4xLxQIWBVqhbG1S4WT2e1jMKj7KeQOsJtR5P66lpPZguWgsmy/HqqGkdYwNbV5hHzvNi+ueBg7gevsRViIPG6ppj3Axi2BFC9fsoRjvFG4GZ4BdJOJRJvQdh7obQt9+vrckFYfye6xoqoNYbQaFtKOYSntjjaHV1rSvQunyAJrajjCp1lCNUuXlNvtY0OrxlTaHWFGlNvtbkaU06vFqTDu/xa/K0ptEBLmsKDAi1Jk9rqmlNGGCtBwN8/FpqWsvYECc6xHFFZv/xykZo96Rej6qdhhrGOOYypXSRqxNXoeae7Hl/ogfdElrAWiqhBOgoIbR7J0Jq3zTgTKKQRdVRp0a5xtex/bF6/YmYGrT9AX2T7XbS8kV1XOuIpQIAklCPrO2rCMna3pXQ1bKOh/zMYW7rCWvSArSmXDRSqVKsTqaUqHkuhV4dkXVqMHQbChyr8OPs7P2q70UnC9UamhEpcGMFbt0ANTRKFCVQayVQayVQayVQa8cFalgCNVJJEadLQyoIH2uRdQfDsqrVsqquVrWgLa9tDkBEOcAJp4SDU/4k3AxwPx34kaE4CrpwDHQVXj3q+6r09UrcMRf9IGEAKc5uRxusM4DrtBYvj1UgpUCHREM6hLmIj3XdIjwUtggpbEsHjKJPoes4WiKXn/Q81UE6lqnXwDS1kAX3aZ4BjDlq+1Ll7GLyrXsc7ZHuUHy0qOR2SeWYWkD2U/i8qIvylx5oW+6gPkJVwtMDOt+GdimnXBduEoOsYMzeom3xpVI04dvyuhiUgsEnlTlBGhY68Z6fvjOaht8UlO1FODA0uCvh8MWgwQuKVhk/sLlSdNPN1U4JYWpqZxWtMOUdJlvbsrEQhbiAM0AIjXFYGZCpa7QajCl6azC7fy2q0kkcT63jmdJnlKyGGGs6HaeXXpepqSUvaCcMhFHtpsWLZBeipGrJJweewtus5MmC62Y0MkSavVLd7Teh79xFnIQyjnu8O/o4dw+NN8rLwGRkVxLqVrmUPEdzKpSF6un1I0hb3YeUSBvqChcytuoKh0kI3giLT1doX2hWtgUJZRzKlPEVelHiVp3fQiEn6IoqEVS7IoWqj2V8wL2QqnwBS1dCLzG1+OinP1nPcSp4pp6CiGdV6DI+riUD/L6WXNT5XRZUc3UFQLFIhxyKdBqqGVKkSKchg3QhbQbeInlEzVOce1x7i8YD6Uw303IRwcOhHWTZ2j+LfUBRaEY6ypl+OQwCXt6c4dGaMzzqgdWZFEnNxFGkAqly1iTlrAntrImUU4ADZDx0+yMh3f4E/Z3KE+wue6aLi55CRhVhdIxnK9xE8BQcR/Dkn0jw5I1kKKKyWMlb1Ctsph7R4phEtaKUnmkv69K9REKhgUKkPY/KnkdIwv5iWt+llHLWN6pMptkv0VqVz+xfoYeBkbKavlaRCGQpsFUDg8+S0AJom4Qy0LaS1cSGDO1Am8ZYTY7V28iOeqlCVT+RdV6G4lmqtQi+M29QHSu0cFIgN8pNAY1S0fx3lxl+KfSSScIHfkL5DV85KNhJxWsg9z353hr0f60nEP/bRZCChkB2re6plbVXxkhHQrLENguZLDrZLPcfg2kBjxpWZloPR5+u/FjLj8vy40r5gWaZwqVhsZ8sW89ORol8Q4l8UwdeiyxrTyvToX4Jk8+66LUAJGoPB1ZnFCQn0V/X5MTSNWWoEbIMdWzpD+FnoYRKnFaqCLSKoKwiKKtoaIFNJXohKqrD1lJen1qwMjmpI1ZplUz9mecQhkoKpXjivxAWr/ReoEMU0BBpIjAey5rDHEGxut65t7OkW86SBZ1HmUTswgmJhHbqBJeJiL1lKFgT9LeXbEFoelI04SkKStMcSDCXknL0ErkhroekgbOukKRv9aexAjq0aK4OmZkVFvS1EvQJQiVCWlYmLFmZ0LEyE9gI0E/yHLGiY13V7SkoXCciCAVDUiOv2qAT4EKsuFCv4EKSe1PxQJ2WTUcDuaxcHiRBxms1XaimVgF8p5jjuWN8FQ4BTLh4HVQuXqvtDr3ua8/mcz9AukqN9X4rOoP1OltXhT39GDm0dF9euUKcCcu9g+rFa7zg+tjoxeuLcR34C/biNV8Ftbe4AmQIxcKCtCn7aT3/rxz/T1y7fuvrHvG16//zLj7fEfqwdz2p4OhGue+/lMdTr8JcIz3mV7G4mf0hrohmf4RfKKDwhNaT3XskBjl3j8RAannRSIynY/e8TY5eLxGfb/qBOlVUqV81pi4v0CXSOw/Z250/0LBIjF4CqqqrMkSkSBniod+B8wBdrVoIHLi7mUUq7lIpvQNPjxomn6ZKHKY3J/ADFZgNBh6h9SSIUbWuORQXGqJCUNdzuf7Ha2sCn7v5WdqGdFcvG7h6ucFNsbct5YjZXqakVPXttZ02Wq2i2sq8l1gztHVBtdJ9U1xeGNSYqokavSN577Q7khOxmHl6njujJ+TZz+lJ3Cc8z592Z1J7LQocyK21e4DBeKyO5kWqG1RT4azvLj5q8u5K8rmTyTsrybuqyVJld1o7Wi7yKxpZvfaCwlyff/WMdA5WnoTzD18e8F/ruuDltuNFIKzhQb4Av/eacrFV9Za+cQphcblIjPcdpDYR1UIi96NfO7t2/9tvOFQTJbS+OKK6V96nzp/wmKbB+I98pkYF8paiaFvvX/eTF8PQN+771gKs6PIVzzG10cgRLTBiXWOUIGbz8WgxshYZtV6cz5I0eA4GYORbeHYRvfaNfFHryGPY8O9bv25tpOM8Y/bFuD8XiUm/D8GkHxIuIokY0iL8ivKHEaHD4qewJv5Fl9SZ4gLTJvWuOk+ZmOWZB2cdHvTyLs2hQ1v4wR1eoQVID3tcwGpglO5wLzrCo1vUvnWq9eet+TbaCqPuOYnYDRSmg2U8EUoMH66r/ABvlFOkamJ5hNTvzAs8Lsl3TCmWuEjioinfKsBYEa88VKiyxBLlB2juaoBlds142oE1dNI3sLgad4p0Y0kVL7fTTvaQg7bSKQhsRYNJI4m2aeS21GhmcqVb0I+KRfkApuvZKU+xk7ZzXiIOw8o0JyDmi4h5ADGkWfmlsAmaNZOs+rFmrVEAX3McwU/q8WR6CMEeQ+26Hyhifn8Q7wuE4Jc5KOKYmjqGhW9dVf4U148RdSkWU9Y7uVetG+7+7Rfu/m/3XWyfDBAL6T3fYp9o4yll9K/bpzQd0Xtxn/+D9okiuKmScsXK977r2Pvt06X8wNXBOa/fsv5e+9SUgvQfv3HBX+Kc+h++uPYTv/+fL/zjzz7NPqWhn7/9zNd/7rP/+QP2CXAh/hVffcd3/8XW33q6fdr4T3zvh7YMvDM+aJ82/mcezGZnZ6+/2D5t/KXfhX+/8UH71HhtKfqnS9cH7RNpE96mpMc03p2P7zn0gb/65zvfb5/y6Ufe8a73v+Vv86fbp23G27/j9oPPfeWbPmCfNv7w4u9yN/756fZp4/+///ChpQMf+o8ftE8b/2zpxk9fbJ+uO9th+twzE8sr5+3D3z7N0P3Dn/SKbQ9/R3HqlEQ2zQ9U5tJ8E2WfnP3bCd8+/B2oFJIn4CJPYUJhRKcRyae09eHf82g8t9HOiI3ycj8TKrqKlXnVOtLtIEeHsr7PGfkRY6F2xDRWSRz44V14ZMXpYqUH8zg/AxM9gXbumbpenIUPPy0fnq20F6X3KMCjzV/N4Evuxdn5GRRznl1YW85RHXCjJXQW6OoTsCWZYcNb+W46m2boCQewG2ca28ErT8pinuPW8oxf4/7BgIMtnr5P5IKfRGfkT6Yz4TrdrBRtOKBe5p9CvYeBOPQQB2ayjNGjErUGbFyaihuBTl5Qlu+gFtPzJzExfzKoeP+VeU6FOIuIaEu+RCv5LK1KbZC5qRu1nTRbhk+hpTJMFJVhJiw0ixCjU02eW4Fb2yiSl1NpSZ6nIfJc64dMz2PZiQFin0JdIgTOK5Npnm3Ql3m+aNwzIABSzIVincq4UJ5fTLWRAJTqcmASPfGFlN+Vzw573EJMAK1rjmtHOVwBolGCRLsmPIXOQwX6NcnHtI3ORdw2iRtwi6olcqpk6tKpU0uEYwntFL7ezX2SbhDiSOLu4upGSiRCJv6w60p0nk3k0HAJjyWaxWPWzpscAoZc5wQVwksUtEOeO2iLPLfQijxXaFWeq9bPwIyZXzQv8wuPjFp4tOhJeDyJnky71xhXl/v8WKYn4rsn0hO+VUXrRkh7Tv8VfKXDq/lpOTP8f68z45sz45szI0gxEYIX5efjcSmWCWA5l3AGhxLcvMlbCGMqdFDW2VzT+QdQHM8ICT2R0XcPT4gn8ITY/egnBI1PiCfkOU+GgifCDp4QW+iJ3PfdZlLMUZ7HUybGPNjwTSZGVJkY88p8M7ZEZlLMViaFHdB5gwZEis8mXqeYRW5gtiD0zz/7eff/0Ls/f7F9FtvBRW7l75VNERmDfRbncqJgl5YMPBR01dju5PwgEnQklFpOMbJzBbFl88DI6FxBtMND7c1Wh9RUkNZ8ipSo02QUqeGFhyaRWhH3uLg9j8c8PEZhQilu54K7+aPE8Sdgz/YEalEGrHwy3p7MOJ4BL5+ItyfSbrztZlQnoPoefL6HzjeLAJ0FeeyTwBcBufOsgtkrgtlPOsC1Mva1GJ8XGJ+XGZ+3BHsNWtIWRtokJ3nWxMn+DlrgPq5g/8jdWs4LoCc6z8CZY8jkDJYiXwKrWUHLuEqvKTYoGCkKOixz1LcygFSSUh06S3qrY8bRSMW28WTHDKM0a0ZpXqCPocNzbnLUANYddlQWAPkFWqFMRg5vzA/jbZnHNcOwtvABkyP94Ew6i855UcE/2HK/ck197p5J59DMgXwG+0aGfEy7wGazMyV8RGeUTPSzciO7KOD6Tr31IhRyqCUhmGd5Ej+jl8B1L48vY0kTq30PYYgecIDZOmAKLJbzhapzX/iS6mG0z6Ad3FtOgoOyOU4uaF52sCo2QIlMyLCjtcNKNeERipwj9vLYIgIf1OSddKRzOT9CjIw5nlt1laqZtTiXpyyk5+qO/GoKMOy6UVJyhI/Uy1RAXbtEY/kFPdEknMGCpsgWfrctwu7wObfb3HcNFmG2b7o8g0qIk6sAa6N+TDJecypEwgm2gCOsOQZCMM1F0ZIiIWEPdVDvj1pEU+/21LMKVimGYRnD0BbJWoeHIuN8rTznJaHg+baDl4ctKmoQH7u0wvXzqjfFmF+t9/ACd3AHsqwKhEkkOxTLWqTr+yparEuDSH8oFssRi/ypJbwsl6E2caVcoi1pm3wrY3kqLd7GuU8zuQF9u3+MaA4EuEuoChPZbuXhC0z5FXymoK5+lptVaLORcTkL5DwXBKKMnKdZmcz8wFzGI6cCjxH6ex0mqjVzpSaLazpfV/oysxfwYFrMRCKP+eHDZ3gsFxrNAdQwSdosOI2u81/uicA0sMcRD3T3j0hKC5xrGck9+SxDkpOyWM2k5nVj4lfdTKpREr1v21CpahNCSr1dLAJAtSFQQ2ZKQBNgFFRtH0DiWVNu2yKU1N2iBoTtB5hKQHyaYuaH5EM4OYMHmCl/QxwczlIq038ObWTAADiX9Th0VGky262bR9k0Cw/dxYJ6ZdydL+KxM2+oYhLkYBmseISQklJDDql5FCAeNCi3REvTvXnrNFWdwmlOx9WN5SKZRWVpWg7yZZIs0xIwDV4r4XGcXyWCl4CadE9FiPC3T9zKZdSL15p7RcOh/DFvXb910bkpkpglQyvwvNw895rnbj0X7lKmBrfEii0gF8ATOSAx6Wuc8RPxEx7KQc5lQe7JhZB2vogGSZsbgPbqWrEV9If7uJjXdDRUraMOYiHkirj/RhxroC1aHrlVwHQedAEZLrEmJS4Tfym5t9KSjDASpcAewLyikxOu5pQeSN5FzKRFNZjWAByVge8yQqxtFNtuy7ejI7aRDZr5Ae6GlFp12Ep9z/XGtIIoELvhjFQvhkWcnGSc5WCCA9AURS/UJJubLtTFbwHh8zaaocY1PaIh1axNHW2o+uSD8JaXYDR2Le+Sqly1+wflEGJOyAhTGpCVgufNpRaduvaQ+nd40I5jon/SFn9UtcUfu2BdbfEf387+5rb4nTck8uQicKyOjkrXP8neoQl12aXwoIgm7fL/OfriXTvl0iVOdx4cPd3xv+BOcDRJLPp/WQ9zajhpCLT3ofocTvr4wp6uB5fBtoYe7r1dzd2TV65y4I4kd/ZLehUXg3e3V0TOk4ucmOGyCPo7xE2424Zjn1XNo2jl6d8kQQZz2tdVrvGE1V4e+sXRXj7keilJ2ssbEUz1iztHvwgG8j791OuwpKE0/Sw1t8zFYtiPoBXlGJWO7HftHTwUwL+EenAHY8s659fA4DIonHjDbfY9WT9aqk9kjpHRmoxa/RakQKhamBcfa5NoGirgcc4siXmkqhL7fvDmi9f+8gm/Q/DIg+t9njVpydOOmrIOpSKPDSiqGh4TI70CMNgDfHH2ZTXYjVE5iAoQkOQiFnNQcfY20EpUgYkfl+kknp6xdLZEqN0SfwrrdvCP2oAa8u/JQXcLRKhlT7gbxs2b0nSPE1JLN1KKEFl6FCG5OM+gbStK0Zouy0k+g8eCnClmVM9nwVFDFo4FDyAGkdPQHGVcPAPagnJ+qvHzBVkxQsJzt3mSeeJG58uuYTI6qy7t9ExRFKqz/RrFbZ0j/uO2JvB5AF5okU/whRgaJ+Q4O4OnJoqxELd0AV2Q4Ubvha+1a8QCwCRUMxWqqbndkmH3VHrMqkwH1QQBKXmO6reglki+x/4ooEwYkCZBfLSEv0t7+8EJU8RN1U7hoALtobRcBhYcHfT6XtlQhYza3Iiry4An/mJEdskB7nNL+aEaidm1BqV2PVhGB+Z4/JekRE98OVIkbjmcTyDlE82+TjrW1D5BSZQ8Ji+6dlhTZWbtmMU1hVnKEJdRWxe+0N1gg0kK3ynbjphYxlG/OmHXt936dpY14MVRFykaBpqSieWui6BkhdDp/k6mqRpiq+HdMnVPGSKCh19x+qOE9pdBFVWD6SK1OnC0bOobH09zYhCIcdjL3lsaD8Opae6VVsXeVybkXsUKAtnm/IoXeq/0mFSXbhSNQ4jT4WcJH3bRFEbYJFeHbkWMHyHPq6JTnMKIjKj/8yMQU8qg6KQAWNVsXB4hztfvjHf8GusCqh/9o2LHS3a+94tuEomDeFnYTRTuJ/vZO2XFOeoHdTT6lSdl3IO/f6G17vGT//RXCXTc3qVGL8aNfGhe0Y11hj5+gr+hoP+7//Ku0Jn5+BUUUASoKxIfwwCA7tQTilnnHXpACgimk1gheDbrdkthIF8R0EdCq2XcTlGfRSbSxyoeiIwAr7gCr4AiBY7caczeraOtXQqyX62Y/VDzV5ubv/jvj8b8xca4+QtuTNX8B97GDGC8kNFf8VYZOYP3glpi/qd/yytfqB8G2XtQvpkP00zAqJEuCjcxATNqbeTXTsbaiNqhUCxxZii0Y8YOxZe80Bfcm+K5q3JrQHVngQ9YK4APdTWiBFSCuitww5iz74L/VpcEsV6r6q/iLoooVzVUPdaa4U4oQmLDWvLRYhqaNwCCRFUEAXrkBk0K4wRLr7twKYBbWNF4kkyeZhrxkPU9J20k5F2vlFJ9V2rAI7pWHMdSyCuEeZHBQ2daZjJKBMhuC3G+5vBNDrwtSP6gq/kXJAKEpmvieC0Rz6Ca1zd5GZZCAPvH1HTgH0IL+uTIyAOOjLxp+BFBkPePkhFf5RB1R0/wkdKTBARA6MmP8scMlkM/OlR6Us8+MGIzyJDzSHVgjOGf7INucuP1aGVy+1+Pyf2hicn9QHVy4+2RT+7DPLnlwyD78OM5uX/9EUxuHbvq5H6gnNyXc5nVSRya66ahjomOSM7veBahnU9of/YRyYHS3CRKn8ozx00UlAr4lo6QGSBrhW8+9d0cQXfTb/O8TfxGLKyNqGxqZDI+8/yTnMDhSU/g6aaUqn0MbR+TE/YRxaTvCtmcYlQK/GqVa6aYsC/gB16z84MrNOZ5pPhU4Lq+hFWr+nINJxRi04OrJc8WmKvTOPWMs0+KgEsNJQbQ+iSergfg8aXcIE+16rwL6vEhRWAKmB09gOPJ5MCL8oalFNi5QeSBv8t6uBmM/V8dP9GBtQ1hxwMoP8OTEjUphL+FBvGfbDevk4SrXnQAj2eL1ZwD2dsU/pToxWy59iHeODPtdnNjXR3epOoCJ0W5BzbEOLFIBXR2SO/Irzh7ZcY0+yfZNorbnaRoVRIh5GgfGRYzqGl30aEOzVzZQ0XYcLZhbLzLiTPD4bBoIc+uos3RLeThVkB5V2pgWNQNbPDoSuPA7XOgeaDvZb8tGBFSAzNJMxrJj0BKeotx+RomKgXOTMhxsOabWAN5wNcPa37ndf/WWPPVV50c1ijxqmLNJXZZ78cH8JTPVw9gJ2UtnWCsYqpnv4tudtKJ+I8iPv1C4HvOfsFhtl5Yt/ePiQV+D4RUnyKWAPf/YCiAyCPydZ2rg1mr9Tdg/5hf7vbXUCMDIZKkbAO9KDxYrBTtaC97D2KAf/2DEa5WSfCBEFrc2L3WVZ2/LmZAujYRJB3lkYfOAMZYO/7A7mFIPXyJOJG7ibX3JnQY7bsp4nseyIj4/k3+mqRp/NHrbfzBkXh1M1RTyVgNlzC559x9tXN5C/Lu0v59yJTgAQHK2MNl7EXTIne7yA+XkTunRXanfd6aElnGaNPrPKoWbW6K3OJ5GB567AUzfHWTx08mJAfxjOG5LgH0DuE1ZAkmnsbaX4DpCowr4hcp/hUYwJehADA6SOYUjnoJCukHa3xWfJ5/NSrqB+xT8IDmZOyVi2EvoKT/acwaig/oVRhLV1bVBdPuAxSJxCgWO3q5p955rUgOaWq2E5sJ8qRxwnbqfLOWU2EOF633uFYpXaab9qtbePqV1ys82IqSTct3UgKK+WxK4FRNiudPG1Ipygetzf4aZErzXyL5oeOqHg/Iq0zPIpDWBNnn9YNd/tU5oNrgIUMjgNoJf3lPTezmJFoIBDSJ1g/ZD4JfQHC3BO9H8CwJ3uhB1CPBhxBLEjyI2FUE1YtYV4IPIrggwZuQIZPgIQQTBEFrDIN6ADMQ1xc/hqnjWhVqrC5p2sDJ2EYZo/iZMN5ZbPxSOB0bHdpNx8pRbIwr2BhZbPQUGzHiio2Rw0bGQ2CPjtcBZHII6FE0FQF53ESh33M4F4ogs8S5wOAcg0xxLlKcC4Bzgbm/NIlzZpUKekVwXJzzFOdClH98nMPiUcU5T1rjVXEu+MbGuaCCc7/3OOPcE71SPAgkML4h1VV0kP2+sgSGQui25/hfHJvyxR+eE2xjdzChWVVxUaoIqkdGG2NHRm9zhzwb7sjoXZUjo7vHvnif++Ju98VHyhOiRO8868f3jH38UffxPe7jjyOoto1wohGXIVVGUB0E0muHwCyElK9BSGpV3x8IZQi1y+teMwjtNOzYWcDnjlFc8o3dZMTNvqiYo9kD+3FeMq/OHhdelC8KMut1ovn9+TJed6PQLkK7ENoicigs/KJ4B/0m2QJmtIUimn9x0aMeLbyIHwsH9h8oVlE3xyzuZx6z6PHbfmzQZ6mLqz37qQOVBDiARmyPVmgZso58hWb7IaT3Ph4+RSo/EcG+4oR4gs+34nFuvg0PyrfrkRD1BerqDGJlLfs7yd+geRCLvCec6xzCUDRpc5ASWjywRi24PskXaLkfXgrFPFgEF00wlFbMIigFwzk0uhDJxa1ZObPBYPFUQi8iNDnidPVVadRaqIcz6xlawEE210CrvbzVF9ySj7lq9cYqkhX4jSny0fPU7cjF5BWD9SIuug9xxL7bf7B26KL7zn9lXvBnpGfPSEBrpfR8zvWh4fqwrMbJwTJiD4GhR+9XxeJpvmWSEc13MEQ6Rk+gzzNNeM8ObcGf+GLIM25Cg5YBnS5laqBjQezMLNMCMG1lTXu6VrB/Hz/LdxKerJiox0pi16pH/hoiacfDn/fyHXqWxFqecD8HsKpbRl+akUfuwEx1PHzUgKtxDR/Kbac8/Dnv4fvceVkxS7OS+VTaWU1SBSH1o6t3baw26KKO3xz6Y5sYSeUEJUZ0gznmjLhlFcMQq1ocoTijdtbB7fYOifsjd6BWmLuNAe1Q7RfwXtcwiF7MXizeW0B3qqD8yl5ejMwBdSyUp0h8PpCD5+uz2h5twxRdVt+l+ZygisAtVZ1DwaFiFVjkvyjfovjSE5rDTKWu3fmiuS86Rsk+7SjZ/Y6S3Ydg6pDNN+oIYx9/wX2sSaqOoGRwiyhAmRP+Xxo74XcfapKe8COY9qVJOLs0joz7Uo30mjomzrhwL1YApRVgKex0MhE4YPATbZeCoM8NvSDqYWs3z4FFEASMZJL7tGBmum/ci/iw0eS72b4C5OoZhgORiUWhFT3nfqgkSkqRZKLjVd1YqQ/dCM1BTsU0H9gtHQDF7oFic6vkTmRtlDZKScWs1K8lC5PWB/1BmQAN6HgH1MEDmcVwz2oP6w4IOK/O8HoQMC4aZXuKZIxizPPA/U84lpiukLXDKGThebl5WjzH7j7Dn9KNLUI3xONZEzdMFw3dWKRknG5EQjdOJTyhBatUQLyqL+ezFWowa4nAjpGZrskZ7aBTy9hMNfF6QlbquCjBA9pzNMAqTXVpCwANvfW9Muc1vNvM+Y42kOYcHZCw0ocM0z+jjvFBUhkSB3vQz06/w96WzDBB4cqNxbwbi8WxsajpWCRCbOv4U8iqP/l5oWLTxig/FcL7jBawFC7mEQPRJ0bG6Xm59FPJF6jupBWKRoi5gpOHZgcZsm5idtg5ovgq5/LFrIHoAiB2qoHmDoFaXUw7VyCVL0yFQW8MBnWGwTWMPI8KHxdpAX8KtURg1gM+ZpQwaDA/USyWcZoV6yYjGMkoEMp1ZbwQv9xrXzLcprcvNX45irnnAzV1RY2s5l0EbyW+4O4O2GjyEIXX8SUsMuqB1k1c3WJnYrHzCobjbtLw5Rwm2gxrF1DgAnWqXr/V3kGbVmlGmSRdxpU2roI2YlYq99Ql/rikITx1FvKe6RRYOM4knu+KAiIuZCtXtfyqHo7ZDPHyD/C3WPmZxummzc49wz+lwJ2UZhA5Qy2LG2+r8k9qdwAIItGYTpYnWuiH/IljhLY4RigeQyOwKubq/7VKipIxpgfsIv4u7YkwBEsXbaFY2B7tpXCPPf5slWICSlWw5b8wGvw3UDBGc31xZEyJvmNoyDI0YJxVcXwH6b2ySZ4GE0+TNuVpegBfz94fzqizCU8TMNqK6gHCxi4srUzyNAkKZ2www0ELunFbdIBe3hzQAGtGi4JJq9TlECDX0x2FDN0yQUWswiyBWAlUVqy2dlRJhS1SSmSmFqITBIwSwCvesU5R4RZNqBZVadEq8ZCrOKEAZq4AViuG3VrEC9MHAZwyWzXaquriymx1HbOlNukMsxUbZiudzmzNG2brx8aYLbwr26NJymwhmCqCV5mtsY+/4D7WJGW25GNRkcqXDbN18xiz5T7UJGW2EEz70iRs8Q6YeSbVKLO1jLhJZivAbgrMVuOAzqRVtF0KyjtCUFaV2epwQHZnGJPF3KdVXcvdaTwtmFGbZLYWEblo78ZbZuvHTprZQs5Nma35EzJbOu6Rnpy8z8Oz5K0CmPza8KTyCismNW5xsADcsOmUts3LYgeYF3Nl+4qFie1ayreL8+xRLXYZzePv0p6lXnO0oKZSO0q6VoR0LZTTjPPpxSPDegWO9eLH+zyGTN8bYb982YZVqJaSpkkmzMZmNCtMGJe3gfJkNalbRkwno9mMYctZYcQCt6QpoVrW5lLXES8JK1GbB82ap+VLzY3U5WcKn5U5sM87sK+Ogh1Yy7VnanwGe2biR68CgxWzVirbtTpJvvwJqsVEgzpTqJYqjh+XaIFlqVIsKNFWAMjSlHxBlfCNFuRylf3UeejQMFOiKwyo4qOH3jjAbHGAmZ9gQIGPYL4cKwXsWpUyt9D8CRjQVXAT89hqnZgBBUY5BjRQBjTIFJUcA2qVZasMaDLKgILwGAY0UAYU2LIADFkoMQR0axoMJhjQBUrBhM8/mjkJZMGfQm0RMLMM6OI0BnRkVlbZz6DKfgZV9jMw7GdCs2ZeniwHqnDcnANdsJdKFiscaFDhQAOizabrKrj9VYOYOh1rQF0H8cXNpyNA3aEVMx11s7M4bdZlMk9HZ13E+DYLfJOZ5+vMi0Zn3uaYs1DlEmh5GgMdU1OWALf06ZSbN0tfjKWPm6u8tGDAsn6wINRvdTNemue0aWORU07FlZux0rE0yyyNlpVWa3PWI3dLs+Ao1srt/+HMuMs3TTwxS1a3kvWBNyZZv2VMVHMT3oV70CTlHm5G0F7GGPvidvfFne6LtyJoJetGiD/24dvch5qkQvzyw1CIbCm9jq0oPK9b4XielBLtRik6b5aC9VTl8C1d3NulmH2mFMx3SnF8Voro1WU3QnNVIfW8CqkX5FuVsS+wrj06UWVRKIPMmOZeVNQOlFeNfejqH9hfCGLkc5QSN+EAtWiZ2si4JjLrlF8Z4w7sz1sqsr5LNsu+sIoSrOl1JLU11laeH9fJnNjamPhqj4itGywUz7uU0RwubDYpBS3CsOmnVsTmZNa9UZn14jSZtV1tpZx81Ymwt3IpKLbYJvnErGvXHhDkM65j213HUvTIXZTkcdkGAXY81YBaLnxNRjH+1H8ws+6z0vztlHKfifKC/3aAaKxQTS2wNKYUVuQ74FueGEYoplnu8OaMZBtPlWzXDLjnrGQ7h2Q718tybZVsA/Jij4NmqKmCq1JEjauzVMqy8x32Ll9Hx2iWCtnXz6r8xEqato0KmreiDllCciNorlUFzT3ayv/1WNC81VzHrQqaeykSRdAcQb7v04LOAYxvMVOOcL5Nx68h04dhi5Tai/LWIxcpPwo58jZxsPao5cg1ak2RI8djcuQ5AGEOkw6S0rQivANVBzqAqmccaKlcpCYMXpq3ZcI56XETC0o56ebWijY1DLlG5Kr1uz+3mfTYbWfaLfV+PC47Rp+k0Uwq5kAeuE00V93O6FDrdqZtl+BEb2hSHb+8m73JzXfd+RmuUeKVa9Rhj2Xaumm66qZpc2yatijGNJ3dhFcCjh72DLIetIGrzfMKAmmcxR/LYGrSzBlZUpsgcyskMxGDg6vUet5XEcKA/tlJqeKE2hroHspRiQxmCOiggijDbDAcT4PmSuYpt1MKLpOo5rin3JQ6zjyNFjUH2M9RS2fxjDGuIoyTvhzEC5mXqzmcSVi5q5o9UIrtsMXKOTUd/Gcc/FvjZFKEL00BnZ4XzEhLKgRDSWBTIDY3RkiohU2L4PRWapS3XGluXOCytYppwHRwUG1jYHwr2BbDh+hlQCUvHs3r6baQl9SRl+Xp5GX2kQtRHoXkZBk9mHnUkpMazU6RnMwgboK86K3Rkc3ZkpCXjpKXJaC+Mgk1ysqhqFl5iSMvySR5yRDJEwhw79DcychL2i3PERjk3JTAzB6XwDh5CRaglmqatkhYhLYRl3TVpKCRluSzjm+uSI+2AWFFYqKzD7LOptsybNeGTkP8jJaxUY2NfdmVR0mAYprFn27XloR9aIH2bIPFkY65Ud/B3ffqZq0mIpSC+InNl7Y914s7Ij7QUaw5EUqjFKHktKNCSjRTBu6/IkJpg6OYgyKrCgDa1IS9FCFcyjNkOs1WaQnD4ghLzREWDs9oa2mllKBoOENeqGZg1zdjJSgzKkFZcvDPNoU/KD5qV0MU4NaIH3MOAkZ4KkiQTSFJKkCpRgotmjW0qFahQkqTRolQMkaEOkoDlRQ1AL6aA1+DZrAnAPiWAL4lmnGHUh2HmEsOMWOlpSpDmTEylCpqrjjQzI6BZlVRM1PSjL9SQufLHnC6DCXXLW5MHWzrZg1x5l3L9Ly621WpHEi3xc25igylIMY2mqvIUHLLquhOuAJCECPgSmHwKBd8aQJHmiWOTO3/3Fj/m9z///noeYJZ5QkUZplAbA5TMiY4RMFsQMFYwak9Pil3G5kMwiRyGQ1nIpvRMMQnBKX0x4kBwGwFWW7aQwWkVbmAWpULmDpZHRdgEdNatGtMnYydKZNxiRpmMjbNpOtMTrpYZmklkjp5DZMOuCYTz9eJVxudeJtjTdNMOSVLM25pKHwlJy03v/SsoEUp1j4Y+BK+VMirHlFigklb5syINKjtBCZbuTLbKFFP26oCE12bIDBpg2SAGUu1HcaEmF+x56ltK5elFXeAv0rC93qVlYg6dk0DorldwshxfuSOsrOxcVmibZgJ280itfwoZ8R2WsGfHmpjyYwow4yo0zZV3YMBh1mQWWxhG8of64zwzTLlV5Yp0bLojKxRzFRgs6qrE7ank6vTmJYFRsin1C1NJbSX7NK0rbI0+RVs91FwrC2k5VLLQsOZ5F3BbFih2JHptDJQbhiwYsdKpDF4jkjr0MxuPjQrOjSAXIua+FPwAkkEmMcl0kuUAnMz7nqHwbByAiLd8B2RdsIFBakj0lbTokqkw7HptkqpEmmFaK4+pACtpoPWtP5PEult0LLIHvXGLcWfwqwFiCmRXqLWNCJd+CNIWSHTfoVM+xUy7SuZ7qiOxUnTaADwxDR6lVpVGu1XabRPtBnWpuq5Pq4SOSXTqREazChlS5WyYbQoVtqhlC09DmVDtlKG07tqM9KmJNZKFXzrXXVQqmv/z4r3lvA87c4FQVfNMMAPju4vuhfIChSZOXduxUPcTvXBQR5gXV7ywtWl5xUBBcPs03IZCVra0JL/tev1LnL6/3jeFI9SAXnWs6z3rAtrPQ756gIqkEvoCxLC6WyGhovtpewevW/rTFX8te+F0+6w4r/yHqteANbLfBHbTtEkveBXhBx7mYmLOMtL9KZwAG8/avYNTeVmiPs1dYjEfhWhbR1i7gRoG/HcEb8tHoXqE+fSnvHLnX1cr0yLNZHNawm1FrRJLxzgR6+YF95+6J+TfBEhn96HUAMlGM7qLWkPI2Y8/gCeIeCc6MN5A8o+oT79vBQNkstuSNM9Wlg13tRJs0/qffbnP5oL459yF8ZdFeV9cbyMXRd/qtRir0fpEO5n6zz7Odfx73JPXnHXu906ZNXL3WiEudv9XZ4/7U6CumSUi/Vn1/iN55P1U5UDPHIQoHfA/3jKvYU/aDd8Pl8J9Jzllfz78tK21yBwk0Bw/lCgk+EmPHFsIe0rQmFo3Fny9xbxhbXXSh7MMHhfPeqRQW74AUDoRh+/8CcTvJQ8s+f+iKfnfbiDnwgXswEUcvdiKdCLKDXNR3wP/5CZRrjD+YKiIa04eOM5fUiJbTO1hY0LgsNoVUyNfX/8ij/5h2Nf+sCFV3L4R/1dZ53xBnrmVS9+MXMGF9Y+yAOG654Naky4U7r7fcOBViL/ng92i7Pddiv+/fHFQ2pQBRA9GFC7y/R9p6JKaKw5HiiSst9v87Rj1Hw7hW83VABfCHyba0z3MNt2kwSzP8FA5qG9FgsPykVK6SsR2iWha3/tjiH6e4WW1ZRFp8n0LzsE0peDeo0MS/2Ew3I3g7s+MibUosj0/D0XD4c6JNmfonHr6PjzVEY1eEcpozpqRN4fASlRQ2i3SOr0+8eHNA3SLCnEehByBUoRG5sVUbS5kDttIef5xzRYtUZ2t0YR5/Q/7qrTKkR4dlRqxrTH2JKvncg+jW6CPfkIXjdEf82D/nCJDbcyTJBB8m8ULb5cvE9w5mMf64vRtJkSv7K9QwBzOKBkY2jidu4dXpmLO0Juz3f3pRsU6oj7FDkTcH2OOozUIcY/wU/tle8x6RfBRNzZ37L6+c+ct3KxZB188vpDPD4OtckFr+qV8Yf3kgte2XvIh1EI8i7pyQXf2rf1sv+lSxzxZP+PFABq34VlQm6lV0F8ic7evfrYo4/d6jLufiAghKF4Bv3XBvCko+E9HHxAg7gw+wUNvg1Lz70S1tthn9bwXYi/R8J6FffjGv4Ewsc0/CmEP6rhw6jpbg1/0DM4rip0Mi1AAPKGNk6X+kP44iwJ3it3fV1dO8tWUtn0VdfELoJ62U55hZtQVObqS1xTQwl+Umlco6Ry/xuwlhNiNIGPPAK9i8iJDeGzQByQE5fXEQN6eDYTYV0QlFavVYYcnqlSzfRBTzOJqzkll2aTCgCw4F79raA5NWynUZ8KsJxTOOHggnIh7ifZG7Gw5TUFNTWyv7hRGaIffwMvexqb3YY8SvmQ8losiG+WOBObfUZzMAR+WBfKfqYlW3J8UfbJG8ey/IXn+a/Eqi3WDijQS9z++YGs3ecHykGEz7j4tUX0aopeAV0Ffr3u1dfCOCai41dT/Ao1pvgfe+cHu0jKr37gUbD5B+oIHzm+q80EioJX5EFLZ/IrCo6VlN4zvGvzINUG7sa+XrITPghfgXnCcFTe4xUFpyFdPpKk9FbP9/i+4RSvdGJFkzy1qKL+LnkXpuskWOAk9zfN9GevKzMFVWdxgVsH7zDBcO8QJkxdQuETv1/ZS3/Pc5zuQWYhYlNIPMIOxJuyAz/I607RKFeeeCpDEGP5wiPBjdp6H9hZx8vqs3r6qTrmxU7AfRVpafiM10JCi8UYtmcQHoZy1Nolt9xy7q/0vElTWYCYYVqze5WvgsG6P9cgFmsY41OWNzzfh21F9WmJUxrBv9J61Wf0GzDBwDQfhiwqxqsu8Tw2HGvZPa7uL9TsAYH5QBey+xDRdnODAp0UGF87KShI/+Qb2AitxJQGOyt2OfohiuiBDmEvuTFcn2qU9k/8wLuu8copVoKopoCvKeC905lABnjsKcTG7P+v94zsOuxarMnZ70LEM8LXaK5dRYgHcQMZob6rV9QxSSNOzxNZ0rJr4elQCkhIMqHMosmF8d//r8fZOR+qzZtSrZpgxW5aLSFyBrzAHOV3o2gukZrflbdTSY5RXYOaZVL6XXkLSW32XKjursANqJHHQImbn/2VoBSan2vzAWx8XkTT2vjdqmOTB5hE+uI7BDyP8b+6n7E7IN2Z6rZmAtBpenb1M0EDsxcy9Abf1vRbzv2RMPSxB3HW08nRNMVXPUzBWu28nOaBVoG9j6JwAswNGEKa0LKbIsNAeYZ9+zuZREJ0FvgLPLtY3BBY5UD2gPLYeM8ovLCGpvtY1mF5LvsiUk2RgdXFyr7kYrO/l+8j8/ZleQvM2z/IWyyHmWcqByyMolOWOnwXgiEWpst6G6WNXztFvn3vAF8KfwybFENHhvFqNyuDi4ZDiZDth/ZcV3jX5n9UanIH5u1ggFmpTIaBA0cH2CtcWfiM+8pY+IZR2C1EInV6UxiM+h0UHSmi0jywqF/FhEauY5aIDpoMCmhCpCtjVLZfGGPtgonh4taxUHqlLAUtmtyYXTQcpL/sw4Qbhh13Eiz2BUAOu1GuVTfKNd0ow5+2lyoPK3RKtexGkEMAkv0ToCXvJp74eRU+BoRhqgHxkE6Rt154+x76uS/+4XO+7/KLyQWv6u37fvn3uYuH4KVO3C40wxTttluFx9+OtnUX6vasjmFln+IKZM7O1tS7JBcXyk/z/NF56us89bPP6aeI01Q74eF79ojO2xMZTzv6ChhP+8upxtOGnudvYiHuTn/MjJt6577dLwJpHRbLgU+B84KrGQ5VM9w0JcNuTQ+yN7/KRe4ychqNrBK/R0jFXvN4mscNyLPH3mrkICjt4v61s4urLOSYXdxf8L36SVqFDH/QGoVEHg8VjxuVLQLII51BWYgPxTQVP+vOpOznR6xAujsP0nisDBHqdZXHXPB+wX0MiaxKgcoLUS/MUeKLFr6UUALOUb8Va8eh+iKPAVWuRGpQSOCBtOwLzsqk8oteVVr4N49BWvi3E9LCsCotDE9SWnj1Y5UWeqPSwtBKC2/0mG2sLskgV+Ds7/Hwe8xa0b98b0lpmYCqSN1Z2C8D2T+jv6hVLOz7Yxb2yRMb+z7+u22omdHw5/s+CxW5GWfB2pnsqkm6V0Tgw2KKX0kc2iOhaxGkMnKXifSNEC97UFdUAFsjvqJ2RtMLN6Vgv/yG6RSsnLC/XJ2wY9LOBcxAHDyI8rSyCoYhwO2WaQij7BfMrWFiHaAg+xdLQ3dpCZmWsIASSI3eQs+jFAIsrCkChyhAuPuHRk8ScEoRuO46uiu4TSbU1fvwsKFBMuCJ7N1ZrdYz9Nl6xArMEQwyfT3LTtL/EoC/86+tWHG3VRkCWTN2PMF3BPiaS+PwHVj8mDcBRw7KLjWBDuI7U0H60SD27GUBtzHevb+ILPFTvC9iJ3NTy65AmQMbA0UNtONAUVcpHP23gf+Mq6pKCIk63lEPJHZLhutQitxZyfZYK4CNFxXNt+PgKnvFe2STQ3WYPzywXyK7HJlSOuQNUItazqVCj6WF0Nxdp5h/soeBAnYuXgfdHopgwDC9tYz83nY1A5KzojWSTKiIuBrWh4j1GCcG/4HNMLYuDNXE+vxXZzcViOiZXcQyLmuva0TIE8HWYiwyHrzsXOv/2k1MrxCvUh4Fkib96PVOzqPxKuYBdbTb1c/EYcAmCjGW7jDCDqXzJ3HoKBO2wwEYXDXhN/AQltXleALtt3rEnDkEAVWZQkSRygWv4MCAUyOkZne/Qdt/6JCvxBV2Nm9EpTHiGFA4EeGXGl4fSlFQHYclWoqKuxELKvygT9EmxhXv99W2+ss059XG4joa48E22qgbjYOepsNYmuS/nB8Eaas89upjjz528+NDnGeXeZJ+8jztoVzRNqjyP4FaDFJz+KFRzLJqcMB8Z6PvqehXReL7PvbU677/LYN/vNjuQfbuHULDQjuv7KdWoyig0br98vZdeNPuz/zw/3zm0/XAxSe/jLnS3eDQvdgKRVhLbwdYbw/MFkxLdnuFGHswib7JM4pEYB2uKGI8rirqoogFYqYhEDN+5N5xCVpqCVqqRg4okFwyeUbIIU/wytexfu3Zrz2qG0UezD0tABMxNsqyEYydkoxG9lntBkVqIM3EfqaMvbcSe7/EKmA/qGfZyHJjIBNCE5SLRriUa725HYdMKeugmq+01miLJG/AmBuvP3uvKZqalZr9BwJwPV+VJRhKU9G+j30U/75w8ZBTP4JUrFbvuWMolMztzn78k6fen54z+/ThQOWsyAHLqdGVPX7Ws68JJsxAny07+HqEI4AR6UydNgJqcvkb6Mq7AlBdfrsbk4rhgknVfMbtn7/+6N2v/cqbv8oIfWdAMyDp/FODJDFP8LG/xpmhDTuTZ/27H2TqIwpnKPhr0vDZ7HrUrEXDP9acHsaBjsxjjZ6DJbxiQZ24LCAhdNbrGcVUW1q3D5JaVGNSVEHzNEMpoUHvYux9FSo0zUOVUmFHGl7MGf9UiXZmDj15Vk888gFNMvgTyajOCIerhhy4ReRrs/0XrInlizotUgub0tQUvyAAoBbHI6Wn2/is37qsjU7fFbBOndz4bmMi6EcqEy06wOBE2M02KhHxSkzzWP5oDrCaxUVOjsW4XVnMYhXBCHIgNiZUzJXERCV/beK/K3vU4dcj+7pn7/vOf8kbKL97gAnPP/LorDtKIuKADk4u7wxktsyj1/Pk4eDBo+wylK1sbosfM9kNgKt0rs1pwCopIoS0fQk9Q1/Bpg7zZdUZNN3N9DjFdjcb6e7CI+guj4vx5Gj7HAHduSFFvcf99+Vg2hfxD9WUG076nm4e9PbeDPkU62zIuzQLQ4j+AVwWzxhInFmgxB8A13haoI18s5nXVoPBPN1vxMe4y+k7ECcWvsWKBfHuvQNIwG9B9EbpNbIqTuodeSjohy/FZnUefoyp+u1A0qTxq9S9wwg2vsSrRJe2UJe6zNkM4PoT27yyq0bYXDP96h9+OU618zDFN+voCoUQaC7lofNzGA1pef3ND8XIJukZP/gLIxH5OaZDPq5r7OSFJHs1eo91mahJdUSj7uw1OstPh2qEmbxI253XpUj/LFtd3YkHZDaPREotUIY25SZyQw0vZ+G8jwvrSHxN3pK+pTazwNhEfYKGhqWul68J1oiE6njUeS4TPNMO1LyJumRuqlcMvJM0gsinDrr7WvSLiSUDAJITpK3ip7sfG0IxqJ3qdPdoARi+IPfw80wslWA6AmGZxgHN0WdDB+WABl1PTNdBdIDh11q31dwIBc4M1XEOWnfyFu7xTL+lWKqrD2JGX1N9PSTj0tDFBiTq+elbQufX4qgzkO7MmpOaNe/q24K+tdTqtwz265QSyAu3UG8wGxvBgndgEVFcjOEUMScU4hJ0g0Mkp78xnJU0YRk1QAfP1VPr3aoGc1a5d7sIITXhrNNer8ck4pOqLgtJ9nqdkQHXxjlVnBDAZPMbkCDxwG2pYBWNepuP3zvlSEybeVZeR/EIshpEprLCWLTY6hRmN6EgFBv3bzZRb0RUqp9Iod1nqTBDxHORnmKH0hUeK23PD0t7RCgUuu/2my0AoiMBKiLQ7Aw/LW2lsEYKoJoDkAIONaDCkHyt6EdQkUvQyMNlZNdF/qhGVhxR/azvxRY/drtTuZACyDBCnKIlpQ4ZcMJj+OKH9vMl3uyeG4wsoS/NxKkcJ+P876ffUN6C2lnERjCFhsRVUaLcz68kr1aTdTNb7x+QCYQ5/QIJNQRGseKH7qVJDR951FAmEoOClfca65nMg7fol12zNnbwHqtxYSEPmJXMLTSwict+5g06eLtLF1kQiTs9wlop9lNVQjSVjBhQsNWDNSnul8pvxwSQYlCmMJ7xkJ11FEsvKSKzEAMI3mYfX60fG6lYBwE0yEjPNCZ7pxkBryKRdI030kiGEiA1KY3M3oXPy0Y90hZlv4LPT2Qz+N1vmNSk+7IXQrqBP6PT6We/qNsctRyuB6ucefqhKiYuZ1K2tRIPwuXOu/ypH+OSVwieBqudOlMBwlADbJUEB4O8TjHSyoTMJsSKiB4gNIRrguGR3MfJIIcGORw4heLMTylAjeqYW4yDYMg+EwVNPrOrT1dt1T5b3xXcddhXNTaP1NaXrJShqk6wVrda/zLnukpt8gh1RtmbhB2qTy+29kiLfQmK9ctiE1toQwuV+7sN8V+Rsiglb+GRFG11vymXfFNkj5C5w0jitqBtmhmu4xLIrfmMGj/LKFG+DkLsfA4P9p+vjVUDPWKtrQgw47lp8EesXUenNOQRfy5eExdojiRnvmj6uyC2aYtYpM6B+LKAC0rsTc0qJ05AaXHNaWtCDkQiI3HvA9m8wW0o8Un7ungylOISaiNZh11XAIGjByBG9v5/ChCnoqLuRqJhRiLAqMhINJCtodkoEsZKW4jWhzwh81jgpd3tXyH+iqCR0sJDFfOxi0A3BzKRESjauhtPsM0J+GFSu5ra0lQpPNAyHSkjn5LytEl5EXcCRPX0zXUvmeIKVk+6s82ODgACi1WxYhVkDiVkYoWMOtYSyMSATKwiBsF5dUpop/y+vevZ31S8vz5pr+PTS0a8kMUI/klRxQHwf396CIyHLnXP1qVun77t1bc9tpmRayYXsapkM+QAjqTvO/yqQyqug+KqLIDZjxlW4SO1NcmX3YwIXT1Jl8fYsI6IuoS5R7WDEsr3aGooQkJ5IXnZqS87SZiPTDkGYKos1MbX4G6ubo+p88elEUl/F4iUAk8S5JgW5hh/Ahmyn5SJ3pBYrPwjPmnV1SjHZj8D1lQtsKxa97h66lOkgqQUqs+cMgc1RbFHTdCHKtQPpX3mZIq/uMUxo5kwTyUmoM8b5YiuZ79gRlhHXNd8LuAOqVLnnisFi4W1+GMInoruWVYqZ3b9gJMxWmuM+3I0LQc2EQ+EOvIFKmpO/zltT40hxPJBnphslFS+9VuKm8iImwaevHAohXBM9xoKEn4onw/QMHQ1Ru31IyY0MV8xeRRgqzqmtypiCWq52Ns01rlOpVq64YniCP7Qn9GLFNXFVolpYF0lQYhSN/Ju1RgIKlmtl33xrItjCT3Y976f7wQKsIXzs3B5PmKFIGE2Yz6z9C/iGJQe2EpicxvGGBjgg3fvuv5uI1IO+/dDMCUgwZwMFSNxAPSb6LVenwCGqWu59N1R3OCFNzDK+9alRmid+QC9dDsJc6Gh6FvrpWaKnBdorGO4mUXNfKblp7oJMheTU6wWHVkdMsqMOCITuoW4WcqqG/5MLvBl2PCvwz5Qv3NNPi8AbABW8/3Os7QajAIEJRTSnNu8a70dhafbwrfIcxv3OkZpBg8IKesAU2KdTjeFzGieohqDPqVMG8mnhoAje7PsiSRM82ZJDWQ9tejTVPSBcU2DE1c/vVSpIe/s2lwPbvWpA2/GTWIbdLtfmHdpAcvTrB5QN7EuQ+qn69OtAOFAJYpb+BiqY2QHrBeemZKJRTFLwyFDlTjHPR2nw0Pzup7RMhi2YsWkLLCgfYVLLYnFwAT3Pp99t7Pa96teeukLPnzKRU+DI/dZEJJ5WEqcl+t2jAZdDHIXyKjXy8kTGLVGhmXRjMlCdruMwZwZ8r+9eAhKwnisV9OYhYEhxzwRsYBIBJzM4HBYHhulv/qI7kEd9V84fhFKI0N3EwqbedEz8cjj8NWIWDvB3aiP3frO2FyNAsPlrkZ9lBM47nMfvTVwF6N+6vXuYtQjqdRdlQKhewtKASnHc/JCE0QSqnIzdqlpgPy19NlQIPDE7Zau16FW50m4L50zvhdLXU7d1ViVLd+OSC19hxco3dj3n7/vU5/q/uVL/t8c2UbP9fd9+eGPv+yvTv3KxZCXKufLnC0qkQ0N2Cgw2Lorq7FpX5g1452kkk65eczRPrpY70AqoV60MUv8khnTLUckmJ2AE4MO8cAFyXt+W5r84qqy0OhJvV7RBn+Sh4jhRR9sik8eh3BvAUNb+P3dxH+X9ZQhMMMiRFrv7B1RKYNT/nmR6FConYdHA6eAzNa2EIopPeVQMlTNPumpCz5CXaMfmu4Tc3Krv/OFPIHgoewvvrjnuW0PKGImGkmq4vg/C4572b/gSV72kGDpGCo+rKh4A/wXBpNn7FbJdjpHjKURoiY9e0zUEWGoB8DKdcUGsZUbDUtvo3U1fi3XpmWUG2aPpwclyNyU4zSS0qgBWWkHLvew/+Kfs1BRwh7FeFUTWZzu37XuN+BFRTotdSgW6kRRRBeeVavEt0AbCXWVu0vF43WmW51dkEQihLiuhs4F+1LXqoRV1arOKlqoKrXLQNstA1PWHB9rzjCfIZVZoty93KT2HWJASXUDZad6Kw7XBtTAe2dITVlrZkYXAywFypNYG4wtTFV1aZ+AmifVYcDqNnH+X0s/63nNzXTMFkZ1zHaWjoeBg1yWRSTViImV/1J9gzxR4tVw+mf4XnwQN3FEKipov8Xl8Ez9iy9urDoFNEHhHPxXhA8b4oIgLmWvkM+qLpkiuXNGrLg+3RnxRaq3BVCgEXwQYgQ/L0bc0Q6rFYiqVyjTCFMLmy4YU3rUH6uht/TGx1mZUD1wg95VVQm/+vrjqxL+iB/gYmg8TRrmbpeuceF8S4UO/axuKwS2SAl/tohV2l4XYagVW+vYolrkivs7D4hTUpFlR9nXjCSbC+IvZo/7xc3yxcE36BcakTdGM+axfJ03tcA5LbAphh0b/PX19msX9SpElSy8rmWYBI+QSm+um/bWE+mmPYcrGlWqt1erQZ+HAJFZ5xEPQack+hWexyfLFqR/51fXC0ex9dweG1+3Ra2VouHRPTxY3wjbQyhKQ7gR6w0Eiw+j6ZIKkD3CSkCWO2vmg5/FByLQBFeY3amvoNQxwe2zbtQwyxMwaAvEP9l+gpkQPSrRzGYt4XmlBj2RTeJiGRM8wiLUDbxSAHyHk3a5qAe9Et24yrEtsnOIn6TCX3h05x6nFDnC8Yavz/T1nuFmsVfO4p92s9gTeI/N4sOPe2MyiL44ZM2fQNZWpSs/dwK6cg1vA/qZSJi8wodA1kPdWGiAFsKV95/Ir/3dudcPcGKlQvXnqo6gutnkHQeHkJlTjFkLXuZzjx/BgTwEX6/RfvqzQZgYDcEpt4R00w3IbcrAQEKoW3AIxAO8sYKTORbwRYL4jBu5tN1SEgMB9fPWM/eMqMeXTygCQwFBne5g4qvtaUv2v3QWGf3oFxVIxC4rNTL4vhhptNPGqBgm9jxdgUl1/TiPFP3Vtsx1oInehpjxCPjdv1SdM+PoSfiu1IJ1wygMbOHtZXO9aGVvfiM36t17MDe0yz+vQ0ut7EenJgHojJxSaxGj+db9amT4CE6so0N1SnT+VOStJzp7+QVU4c5eHlea/BuvPwFN/qMA0qaXg/t14ru1YpqV37qYyIoJT/WCAh37UAcQ3OtDHfw+2CkSlUiJZFK0nyI+g4PURGRAKoskisAcxLDihM9uzPQOmThaahvD49Ci4keHmiLBijkRIjx7JtDBT0qxWmnJlBGM1Nb/DH5slHpsiTFCsTVAk4o2Q2mIpoFI1Tg3/FsR8Vsd7VP5ZCQnWR3LI+RtHUsnZJsV/OyAoqTQ8s1nU9W3maM22NY8w+5srZDtgtExnYUDvH1Pln9/z/dnhtreDM54MumEiREfRNwIGxOLTV5KVZ0vwGgEZjTS26N6qTjMz/BagKubJ7bpRQOvTd1bWXYEbxiIeztFiud9naJiJPDoRWKrsrzRKE7vZvb97eePXrDjdy7cu+/XNt4YP7C0xwbON8dJnX74rB4xW/is3oBHM8UIpGqZlWbKwirXu/K2yB0PdigpI8vtAxqb9Qrm/hmUDcnVJLzB7Yht/0dM++8eaf/hp09t/+Ivfuuf/9AC7d33PT/y4X/Y9T2LNjD7KNqPFqL9m7Wbv2/0D7NcRF3cc8lF2oMsShAnFUkLKzR5ecYNRfBokGcp+kmw44jHPLR/sN+GSDETuaI7MaFINbYtPkLrsHy5sjdxP+Kupw/LZJUBDngvNeAqeD8fC7Py1yqmBM5RG89syFkQ6HLpMzTHBLUU3g1onpJ1FtTRrOAbZ8QoIbDvhb/x1V9++ZdYp5bvtP33R3M95fOvd9dTnHjJ3U/B29gFlRcyh6DbkKpKvgBfhCr7Wdz1Qv0wyL6A8g3LgCKqdn18Xe05Vi85y73JRB8hHmjVk8vrMGH2Nyhs6h0YvWm22TWYz/peMP1mtsjN/24qrxmh/GiEoY0cQxtNMrQuXVJBME6+CgW/YWezB0pmFuDNvqivSjt9x8xi94rdIVN7x8hGmjEoGVmwOyoGCRGnCil4CD8n6v0TjCw2uw+iWRTocQiy6yGuP8rIVi6g93moRu8brdvdu+KLl71V0E3GV3fQeFitjuTR3F+66+RvsAUjN9j8TW6w+eM32GDT5sHRG2xve331BpthuGNluCOw3NOusfGJS7xf5MKx0CScUVausYXHu8YWk2+uqulUkdtsiT5CfQCT3v76411j+0UdjV/0/NAegilOKabFcnqlTicCPLgdatsjUqZaLScLh9D4PvQAMEsu1VCL6rphkovj2Tt03msF+E7HOpRXtJnlZ4BAWIqkO6m8FKG1rG3vh1+C4689Otw8dg/9gzn+ipQTx6IuDUUrtAPZO1G70JfIoVq61+yTse/NflnFmISiylupAm/l7C25EzySFibp+08e17qlJOsXPvHzn6hNwTXkUWmVQ7efR17GH36c4bDtPSPY5vZRFOvuSlCuuxnK9V/wQqh3fH0R79eOi3jvRerjL6dSzwQw/VDdT77/BPvJPzylCc585Tqfbw0FL5+5Lnh5dF3pjv2YcxojvbEOXW7/ZWdKagoPH+F+jWSpEcIPvcOFv+CsRUkpylXmcV9Rwsi7gLhdaP7BuDzE1WxN8aXsLAQKN9TkU4kmU3kYIVU9tmvyGUqQo0kN4j/eCLSQAZxba79mzlzmWUrAgLcoRUKqctQ5e9tbdIz0boo0Fi1olV4kZoE0GX6aevTa51fIjewBXrtMS5HWRpoqQrDkXpR8bkS/bZH9w/I2x33HTw0TIfuALpAu1jiA6de5ufqFqEbBLbSc24g8Gxarobok3VHf8gyiWegTHyiawqAscIPlQnvprdyWhpPppnwbFhmyap3iIqV9ANspjuXxYLChKojIsYW1jmfs6WgLGycViauzz2of0Derd9GQySc3TBaMD8ZFOUQCNiyJjxlPLOdmGCNo0eOqAdzYJJTtR9wKZ+jBNVOwVwdMPieM13ScDGGWG080mjAe6gfTALqoaTO3qi+9rWhtvs1Be3tp8DOjrZQqqPEBdN2VpGF6GtvUjKkZDpD4ASxmKTYAjBwZTtfakmeGYIe9p5rgy9SSbC2Ch1S4wtlOqVVo5U3cKkpWJ0UJNfHT1rGE+wyzqRWH5jnJs5bnqrApbiWc1V/noiaifMxyKuaX5ImIqkkYFGsV3DgjnUHR3AEGIlqlG1yn1CZmSre5Kx0ZtBkYZ9SQ7hYOuXsTOWddZaE+d1anHAos3v3wvDg4a2ovWjzcM4HqSAl5IP8AZWvY2yto0DwYwp42+Nqrgh7+rEfE7nsooiVjO7bIEZlzJPcW3sht/E7E79TMCzbyFESeopkFOjw2szpAwDy4XiM6BSmf00TE5ISyNIYACwz4rHq6Fw8daiFXc5bfEtnS7LdgKhkcM2LnXuZ+jHmurmElLlHXtRq3DPHVsvUdqKIHpSGnwpKYtwawngboSmiXizy9jDzDRZ5ZRp4lwrL8bG7NOVzdE3hUnsBjt0uJu+G865hSu/FIiieKdY58SU4aQJaehENJoYP5VvQJrhdhhzxfIo4hcfv1ZCmmaaz1nA3yvoU1hmgLRJTz0s0n5bFOfjqN4bLLmHWOMRIzwHBBXgAsXHOvKhxqCU6BEy8JM2zOo6oerRxgoqT+pRBe5Kj5NYS28QfBixHaziFfQssc8iSE22Bdscnepe2CmXlbXpb1JZOXOX3pyMuivqS0lV+26YsvLwv6sirgUfrmo06geNGS+R3RqnYVL0QpXmYJr1Tk1JKn4BOQaZaIIouyHUIhlFPEyFWcIsaOqYANcKLJ+SPoW5yLn6dI1oFXnMd5bdEtegrJt6eQRH9WK8lMJfr5TvUaWJwilWjFOyTuLi52pLQdJJl2EqJtaW2dX7l0wroPLXIt7VzEkcQd5aoqpdWISDJFtNOVJmjFJCVU4khYsaiLidI1Lmj1impsfS5vcbbkgZVPZk8PM75X81NFzPNZxY/OB2Lu4QcvkhdwsRcyfm43+Hk6V3KGwc/tjxE/L1Ssu7DEzzmO2iP42ePQBRLawqHzJTRf4mxS4myjxNmncvO2Cc5uo8RiJl4aFjPx8lR98fFiEXiVtvJLT1+68rJFX2J5mdeXBbzYGbBYweZ4ApsXq9jcxYtdxxbw0paXnYr0mcHzUwye7wAGnEvIQ4yls/I8D5EXWVTIzAwonsaolSPwdDsffEXVU2iHzAekIyCZdrrZUSJuROfRUzgwOVcEEfFz/Jmyc2SmpFr9uXRRdaZIxqfR02XyTZsp+GLH5Ezp6Ew5xfTBzJSdOglIm29mCo3MFJ0ilBOdYKZsw6TYZmfKdsyU7XQhIhnpMFOCFBMjYAfZeMC7wjxmBW71beFZsWBmxZlc4FlmViw88lmRVWfFFqXUWB10VjA6MkYrrd4i9FtptS+hOcwAnTNG5r9EsUXtDC8WtTvyss0R6tgSd19elt10iC0971bwvDuB534Vz1ereJ4KnlvSTbMGxWcqKG6HC5djc1JUGyPriq/nSTJw9FPv/C8XV/8w7ECMnXSuIPDF1b/iIk4UNNTqgDWMtTZ2ihkGM20s1ij6n2LRf8cIwp6npB14O7ZQ1MpJp+g/BWHvetQIG4uOv0XYBWDRAm1BpPo2bvlAWHDf240PfHoSyKJFrm2MiGGe4ykkaBGIswq/8oYE80rOWIFQXJJWuIH1BbF8u5q35aVrsWwrv8QWy/CyarCsgj6dCfRJq+iTCfpMEsPJRd+toJaIKenQ0RuFLEdHJwdZdTdqIbsNu8Bt1t/+do18Ep1NT35RwT+4lffKNfWM8CR6MoC0IkUt5TXajd3FbnoiPjIMZioiMjp1jZ6gC4uutm2+0nuAIdaW/TC1OQ0On4RX6hr98/Y0Px4qvV0yW6kM6tyTmYqL5YQyoxbqLGoG0NjPF00zT3mq6RBQjvuPPmYwXhjrqaZDQMhLlmuSCc5TckaeQuafxj/Wy8YO5WCY8SGddkhTf9NkliqeOhchcB6S1I/GU+hpukPbq0XoC/EL59aXTEuQAcZYc4AuRjG5FnO1pmvm3eP7aN00CQ4IBXbvulmCI9Soupl27mDahosS/8huDxrYDTiHmhUPppVLmupR0Pgv7eq+JpR9TRf7GsyNJ9A5dg90jsRBgmA8YTxKy2S/9PpH6Mdgd+Uo5i58/HVwXtCvmAlMxKSUkCS/fy12/qM2+ciH6KViLNCHkPYFtgScgOAhQmWEQ4R5a1yKM63iIplzkBApYj4U9qrV0hb6jlKQNCIMTr8VcunMXssgv+KMQmtCARJS4aa1XxdQUNHDDtM/irx2RSzqTqd8A33BFB5vXoOvuMbISc2dD2gBlneUcRNLWpg9qFqyenmrqxdFMn1r6VtopNZGQKhLgFGfpWTinlHu2XMud+NIjXyLBk0m9nBUo9nZmx+Y4Dl7+dZZ4WOtaZiLPz7fHcybcOQFcpZA96VFdb4KgggoAPCOXzVWsXf2FYed2StuLsRpnp7vqsJHCrEjx1Knf90PwOItjB6P3N0C9odMciEOerFpiIca1EOJHhFRkL3t1UgRcR3i1bmgqPdBSIddqapJePaMtnbUBpiIcs0wSGOvDltPYg0jlRBctTYuAsAEab5IcDNUGcm9GjSyxeO7JpoSvsIhKOvW8hMt/6CPHDi6KzKUDrERdbgdskR0yBd+AMW2VGqklfsc8C/tAV9hxiuvG5VepEJabLSkADJ3s8pe1ArlopYm2sg+OdWcRf5xRzXsiUJm99Zpsf09QjGUvkyxU45DUbGZ/augOVWV2+/c1CzoqrMK+hVnFTSr2PxccCY/Rw15tmqkTXrUhPV9E4S1Wz1S706cqO+dZvKx4M+uZnK69qjtPurRU5XQoiWG0P7cyZ9l+SPnpuEm56be+LkpTDM8NHpu+uAN1ZMsOb/RA9Pw38ju51duON651V8ilTWbg0dyE6k15SJSa+QeEoS+L9ELQa2r+e1Ed5A+yceC3tRLSJ9ACoV6buiuIR2tXkPavM6T99bUf8kLIZZ//H02fWjqFSfUlX3w9ZM3nD6sB4nPm7Ql7PdBJpVXKBkFaBrqSFfnOhiGPDBfUFA1NPyopvuvT0z3VmW64+U4fNRHHj0fpXgxOr1bdnp/b9WYx2MBUREaIIkPgtwv+ax+dRAeIaem0P5Z3w9GLHAGk5b4g010bINMLfj42UcVgpaVUxsa0hpI3D8u14AwX0K9G+msXPn8ts4rdaK2C8iu2eTJ0qrlB9nHUD5pUvZ7eFF9uIUxW9A142PJ3OOsXAkqYAu3UxrNxUsRqyHDOi6ewLlnV0yxcPsj6+du9+hi6q79usV0IhZgNGjzlOmLqaykomyFtfF3xlfUzTVe/+oEGq9YN13t31HeZ0kKq+azse9Hn/kj9+TXJ6U5gns/SB4GwenaYTgAyTIm+zhoMEMu/YsT3Us49q9xL+HYI72X8Aej9xL+cOJewsEMO9CpdxCO1h7lHYTPTbuDgKqw2/yGuYvw+5vfRfi3U+36o29Q1a6PH1fD5hO6ML5TbRx4m6t3nRmcWL3raKfU76qJ3r2adqkjzup33fP46Xfh+lL/aIbl5w6j43XjV8Z0vDhxRMmLQ9mfnFjJ648fhZLXo+IBPvlYZCmf+qYs5fGSpfy071eu7dA0e29aEriBiUWmSzVJyP5M1VQhejnaQS/gvEltJ94t75gk2afwFW4jgU+5h+MrHmTZbdqxTsWAeZ9EzuiVKiADw4h85eJhxWZypDdl8sBWAvVgxAxNbZEkcG3o+oCidffx4AJEe24xzT13HbG6O/eVodBJVmEo8mmxOjONbjWjd4ZM1bjvlWnEdsvVfZpzRYEJ+OcKtK68fEZfiMTgJRxUCU3Dq4fX++zrwRCvnzWv6c94gTr8cfD0+54zw6JWCkWWMwHUF+xdtwD8HMoTAAYb0/Ip6IvYOKFhlXrIXSrgDM1Vov6HZJZgJAbu8zvSJ3CfyzbpeFUitP4Kq5M+7BlL9IFcKDEbp0on9SKMJTpS+0ivOR2rKfqjUYdZsyjSVo7ExdWPnJwPU9ebYs31g3AveaRoDLK/FJg1KSSQfhsBq1xQOoTRBaqzry3Aps6o5mRISsusCEm2rmzqRv2sKPDSw36si9UmV+36Mg10K4AppvS6H/W5vOwTIkkILwguL28RQzd+iuW8qrm8eiVerSjicEUsilGgsnnGPDHPA00/LJx6Pw2OGiyglH/VEAPqVpjJp3rlmhnFlXsrsS4I8YCbCjiMeqsZvc/2pkcHkaSfVCFy0H+MIAkAkkhAUt8cJPXHDhK09UQw+Uk/cjA5WYik/WwEIumjhEhoIBICInVAREXUBiIwbGgBEvabmwIkBkDCUYCElbtZ2AxyI2EJRNh9ACY9EWC+Oo0qHmV4lCRGmu8D1u6mJrjBI9n9hnuLNDSYQumwcAQyUdG4xBgM2yjCId6z9WLU95atomE7TpejsqrHMdDVdYk6UkTDyqbvDo4fYk0eukLGi6txcesDDK4S1vX0cs+rdt3fW1l9yRtoc9cLDnN93oQfGl3ztS+QavhQTxenh57pqe8I41C8wQsgEOICQ+fZWQs07eqkFZhU+8hv3Irvkn+fuJhc8ErxE2+gOnwcxCp3eb7PaEE1uTPq48k3SH3ZJImdWPyxQjlXASOuGGgfZiHVjrsYJ8NYVI2JxmgRK1Lx9z7LMfVow6ukQ7nJXdsTaz+eKYjRmbGf3+Ub0UZBMc/RC74U88J5ivKysLVUYWX1Llq5LcCAK2TUvYydnBRmf2ut/vpiRQ1PMJGAijIGxq+YJymepjiXZI4/Bjt/Ipdkyhl/zve8V+rmks7zCSE+Ks5w/qxhtdaNsFh72SUhWHvZqaGzYOBGQrthpVBo2C597NTHWXggzdPdD36NZW+4hDno54FurG/ywVSf7x/kJ7445GvBh7mlhzXMeeDmTMKcjjxa+mF5Ik2fiD/dv1nKnroHeqtWxlm08tv5iU/e5p/PfxLmOBu/i/Ofx38avpPDd/pCqJHX1++14rfqE+keONwNH3bK09vhI9btZUPdy0YYq8DsnvXGUqisEgUylrgVJyYeJZlihCISwX/2perWNSi3rgFedfOCrSv/V926BsY26ZSrSQdn3dY17A++MmadTwcPrUCDsy+Xu9Zws13r3z+KXev/eafevjiZne5SC20YFRj+ws/j319bR2P3XwxpzaU4aM1Q9Ga7uaCymxNLT56a91zhzz8tr38kJ0C6hzuUkT9V2PxgB7AFr1hTofmNsNnAzwfZsh946BEDzSAfbhXwqe6WXyZ3RWJWMIg6VaIEo53ac0p0m4C0sJpWr6zO9YqVGQom9nWDiX3dtFiDtrqHe+JxTl6Bv9mD44Lit3qeN/3sFbCp8i0aC0hNif3C1Nh7K7FfKWOPuVi1DiqxH5nM61qZ1ch19FGf597whnHhzs7qAc/OiQOe/Se8If09L5TPguzGNzzG+9FVQdKr3/AoBEk/928hZR28YVLKqpPh3+gg+MgbjideHaqt9x++aAbOxuZ4L9KS64PRy1N+9/gKoV/u14oojyGwbIljpLqWoZcIjx3/EiGcdB01lwgRvqsSHmgY5xJSSgoPGqy9Ti/OGy7YdEFkOJZAdVhsZeVtfhr7rgBMN5/Bg9Tuxll5hmzRGrLgPBhvoX1DGzKsqMUsdfYLAtCsuaA4t7+Yp3kMteyQ8gWK7J3DRZpFjog6xH+s3jKPDEuw/7lfMy+7zF2axQXFeZpDwhbKwLzmK9YIdl/6z/6WaF4spgE/u8CFZfzMYdSW1vr8au4lLiJ6oUzbgrQFpHFRLSCw3kvcQKm2SIILI7uBu4u3ZT0uqIMy6v1Bg9WdARR+brVAZr1Pbt8SzVC4VmzHnUTqe3kO/Vd0oqAVDrDBlS1r+Q6apaX9iN3Jn5wS7NWOaUkUccem40OY0Rzh6QzDCB9q9VnMZf9T5WI/nSoX+E6D+pTwQkt0qrkgGYm7KL21J2bliWQ7MU9LuLLHD3tlr0tzSF6CBu6C5FnEpR29srdIOc1LtnkOw4zrssw8/GS0/QAGAdvkU0QDsivzGOUlJEVBqCDG6BegJM6CwizfJc9afrqCQszRzGHEKWIeGjXOrT3cFHvJpz/8Je/hBzwDjGwNiCd5EtpVTVKjNHPgE+f6BGjRIuK4H5gJsL8LHF6gZaSVtzZPczf3lrirKzgbOQPrwI7Rm3tnpOie3NxTpGScP+PhhfxMDKnpxRzjwXywV7GYtkgP8rPwemNmX8+mBaBmsSZeBuiUFxeL/RjChWIZd3LOpDl0rthFqxSpcwp5Px395N5Cwopc28gknENbbfAJD3/R5Nmr05oWUS7QTEuls6ehG+3i7/jnnzxK6ByEz+Ew18evKJJ/JOl0hE+XJPxfJA76SjeA0HYAEzrLJQO2wCPp+c41Wka+M+kcLvmBssWI2SWVaIzov/7/2btu+DaS72zJAgno8AeP2AgQ4c2CIAAiUTlQJxG6fI6l+1KSk35unOnsUqVLds4559g529c555xdufJ8b97szgpLEaIuixe48wa7s9iZ75vwvn2YEnm642TweITQ5QDt2l9U39Uf9RGQ26cSshTckIpCNGpogzMvoG/Zoy1nErXLNSOAM1+bm2xdAy4JMHbvZj8KFGi4aduztgefj0clHAA1AtTMjwQBAescM9g3YEAykSTgt03r6tLiHAIC1RV9wysGTEPTxasSUPKnG+qqiSHl3w26po/43aDrvIxRNzQqkfOvG+om3nHgXkzd0mXWJWL0lrqhz7tF1zAC3uaS6hJVeBV9MiGqsIbuKNCHytcoRbeoRvRocahfOVRt/dUGupAO3VA7dFO10v4qIQ2mFndYADE3eR95oJvkCDtLiz27+ZN5u7RKHRVxwOOOaugSv0lpCqo6hcqjBko321dxdzCkeprGYF1HKhmRx8cZ0AICGF0QwLUZFGjyIFcgnMx566w/KCdjjSYaLeOeUZ9M8Gdqzl1P9gWyhmRT4mvnxNn/JdnunbiIIV/9l+Vkzncytx+bzPVkmityTHzSkKbHFTljZvHV/1lOhqbICTJHJnM9meWKHBFOwpVOkXWgr04eDh7aBXj14YLxF2vwzlPE0cwRhXwMqcHHhn2pvSZRDhQgyqGNQ5t2SD3QwGgt9jAqDnDmgCgfL3g7ixdkyG0iXpCxdoextvko0fTR4wHB1FBMfJ33gJFYMjBE+PmGhmFPw7CpYTjIw3BwOhjuEKkGKQ3HrmpRT7WpqTqAIx5e1amqPGqpQAM1pg7fzYVi7EA0SNMjB7ozKpkxLZkLbMdotYlgd0oBH/eR+VoeyEMqI/cuzWiExL0M1v6DJLLnAFdlmtI+ow4nTi3I9w1Qx4x8weAy5BlF+DOzgB87UIpoxkgX3FsoRdl3uEv3dK5c/ZdCrQm9xkQqAnxEE8OhGU2LixQO5QE/51GgGPDRKoAPcAgoxiG28A8B/1Dgn8Edxyq1+NiiNh/b1OFjh3YA8h1LByIfwFU4KOri0KUeDj1q0p0HGq4DkGNAG7hugzZtiOBVhAge4PAuumAAXSm6oVNlDNCqizTYQCjrFhEdaCY0QQpObWgELzQnNjUn7pyeE/Q0JzZVqPnQ0Fyoak60aEO16Y7wIqJQlQq44WOwPoYbnsMNn0qm2yZPeBE7vLAN6gsORmQgLfmGZSm+GdzA9A984Zf949f9zL/cs0f0uuhuyzy3kdmaPWqiMUSSMhdtkDghmzsrGBVGDEhCqSnNRpYunGu/H+3TyNBl7gJRHmdsYC1M4RNnufEiD+s6pj7LsBboPgvdEuIXAd2RoFs69VOifJMIP0vRJQVcNmE1qQerRxuwNugOrDsa7ASwL3D5gg5kJKCrWCn0NMQY3ko52G4ztnuPzBqqqxG9oxE9MJMNASa1NGzLaoQjOlaeQ+wgvFpFGn4hDcw8Ag+vSs5cIsBcwp0/uJ22gHEuYBy7OJMu2G3BUdqdStNJ/5trsxnJmF9etc3QSrG0ks+17684FO8QYfBtk+KWg9WhAawBtVB6i7q4oEs9c8FNukq3vyLRfyQYkRdnN+k21R6pGk9/b6gSXUMw4jW6jovsHJT93mVlfjwO0+RjVqk/BrUXiSObeGITh2s8/qsBZnF0hfYeP9IQMM3e4pnCVQjOZLzU7bdMf6Qb8Abt8Imh+TJGqEd32aAS0FQj9iFUZckV68vQ7qFZ69R1L2dbn2p6rSjNX6KGnvto40CNtFHVXGFjBn8VUgAGH8dmNItk1Pb5yEMuxjk8tGY1wIGeYS5DNl+Fx8dnGNMwnGOoRmJqPjvEZxMyY78e1qQUtv4Alr7AWL8Gy46Mx47mCU8VcRIaIL0xrL/kX0pf02MAP/QF3Rtze8fGq2LWKvjQw4eJOBqwTGG8cuaQM2fO4nDGFKAy0lgG6v/UiEnmrIYkNtKnEV8vnVSgIa9K+nAeLOAFG2aVO3AbGNdAlLbnORUaD8m6Jo5xGvASO2YHgcdDm4RCMVVVHcBIRzd9SxRDHvomT9b8EmO5TZHxUKBY3GLNLP7i1P/g6VqhkhQvjyY+hROLz3w768a3I0AMCKlX+eX1gMroJMy9i0/6UjnpgAIjp3imkvKeIAqxLtYeAhWxM+oVFZt6lb7cEuth0uLOBkH7uFxv8fsKs6xVzLJqjmUNsMu2zCosq7osa7x0LLNI+kSxrCUsI4wXrYfUZntBhgehNK9GsmrkiBcJ8fwViSc7RwszIuAwSokXMvF8FOsQz1+deMXFn554XnqSt0Q8W0DsFBBLAZ79zLkuluvijLBJnVuE6svMbVjmhvwjIRU4z5mieKSW8JbJ+kWpa7JkPhsgMMCDV2un+lLx+IzHoC5jQ9h7wrB5NmzWVxk2L6o4R74Bn1RnhnFtq/Yr1Dbi5zmwUG/E2kKvmk5m2/qOPJcx8+uqyBxV8tELlHgiT6WHmHFzC9WkKwyoQaF2WuP1U9gR/LjUEA+2zY2ldgKIAY/BWe8Bxdpgvz5XOLzrPqs0aOOIPJONx8Czap+1OLs9fn5pU9FCWjDMA7YXZTYuLWINDrlvXaiBGy6+6qtZtMA3e5xCiQySUENSwGVTxWV1RRdymT6nLpkqvmAcz1AhtXKmq9iKbnu/dqTuZy9S7BrXPN+fha6Yr0F90AX8lXtD0ISWhcM2y5n4Q+YtIrpPu0dZ0J/HQX9UMrsUqi3zWhIF4DVtOZsa7Oa0AoGwYGdNXi/41/3V9eDDi8t68Lf/5Il68P86GvDfOun3Mz2YS4HucAixwejBkryYJdMTPjOS8PsfiiT8r6tKwn9ZNpIwet02KucDk4QPzyRhKwkfftok4feLJOHDM0n4JZeEDzNJWDrhxCQ1eZ8hCb9/Wkn4Xz8lkrC4co+XhOuFmkIZI4ZIwvVTSsJPnkMSfvJCkvBRkSR89EKS8I8VScI/9pFKwqIFizJ8Jgl/IiXhJ6eUhJ+8kCR8VCQJH72QJPxjRZLwj51Jwi+5JPzkkyEJPzmtJHxUJAkfnUnCZ5LwSyYJr33AkjCWXEG2OcFHJAnDPV3s5BZndbGTG65rx8n9Y1kpqLack/vw+Z3cf5ndGM1RIAkffrP1LWLR8u3nHpgVC0wPgBN3tzrHEeB1ZJE2P0/Mb2cH+BM5b+icpz8Yynkr+cThznD94Fh0gRrGDw6GqDinGq85qvFhzv19+Az3t/zwoPVZAuWameKevoB7gJpF3u/zK3i/pXTrdEDp9RNLT927tubTbb4CvpWTRZkezI9vBnB0aB+tHhxbmlmKra4jfUoodkaxllAsk4xhA75WMj7MScaHS5LxSqzzwQsfvChUjM8XKcars6649ELWJfUC3gHGwryYshNicvMtI13B16Hmhyb4nhH1jKiZJiz0fIkHxfoqg+Lp1d61ZbX3/FNq79pxau/5vNoLu0DtPb+s9p5P1d7zKJvrclnt5ewPTe09U3v/z0T/lvX/r+if66pqlVf/zOLXb+jjmv4/r/ZWltXenztZ7f0+nCIK7/c46e/mNNReU4pICqL22uTFLCknPJ/aW/ClNtGR45eLkPhLm/gDm/g1m/gxmziyiSc2cXgh1YrrqVZcF61Yy74++aIVrwEnqfwbUj2vFYNZEBfJf2hOjrOTG0xeDPL4oCla8VaqFXMFQh70021NGyAPC8YepKcIenAsWnHIxEo/a+KzYFkrPkKptsjFD8FiDZYV2GxbU1aDVcuIyaqty09PMr9k0gJFmqYAfT8etM2WLSpiNoRWsa0qn4VV6Ueqj9AxsHgbPb3LqS0N+/3wtReSmCD6mnv61KTgEXpcncu7nPp8K092OUXPA2aIruXjl4Z8zEqkq3KfId3llNrCo0P9M18dRyvX405X3kkiA03wTunnRAeY6DtHaLgebfErRkkTolidoofI7etTdqA/uRq5DMkMsVcJx5MU8aFRxIesiI+y2t5NxfGIhq447rnieEt2OYVIDH1cH0QfRwVzC6B3DvicEK1j9PGQEvL5NF+nfa2Px7RLNbvLae8BDVAyXBgQxT38CdJdTkN5q73Bu5yO+QjZGBVghErPUcZD8sw2p1BYsWFNpoyDZiK+jnMfETcyxmNPxuNQn+64mmRnozinjI8yZTzC/pFQxtvQILdzyjiG0YERM4WC8BRjm9Mpvro8hi/zEyatJhsXZpRxsWYUSGV5RvdOGjQ1D5SMqWtF7omzCylOUKn6TWSTe9m+pADkBRSJ9xpowONsKXuHYKa/Z6EmPtZF6D//wiI40nPeHRUmSqc989EE6Um6cWpSlnov1sS5WrIzULGADz93/wH5AElSgkeZ9pwNU5Ezpkl+w1RP5jvcjaDLEAeADNADuNNMXgJpPJE1UU4av0QdZ0xsc10J4kQa90FE9C0hpPE2z/F+EVo4EIQM32bICizrUghoy8TxNR6oLmdj1pUs92qWey3LvZ7l3pAk0LpD61r/Pmf2otRf77YV0hl8qmTGIbVvhfTf2kju4Kh/kP01I6QrEdL/YEPdhZB+xBcOUan6/74uc6iUPm9Id9B33OOSPBHS9zFgbUFI39LjGwsz23RXVWW2fVl5dIWrzacqGj9MN/tDizl7/9m5MA6+vJ6Z7ojZx622qY9d/rYZs0iTztp4gNQI07bHSLUwY+TULuZqnEr0V+npr6Col63uYewaI2YjMUbEBhmjSUNtjIxRY6NrjAGqR7rmGpWERz73VWUjQIVsjKlJTF6YlEzI5+Pc7sLWoDGVjQE5D4XQhMoa3cmeFVqmGug0XiYmUzE5wJ+FOXctue/s8ObTgvjaPbrv7PAWy13M5XMrwOzxXcytpyZzLVnkipsSnzSnhVNcYEiNLw3KW5lyYoo7QObYZK4lc6e4ElisbXQpTnFAltLsEeJhAKYeyNqjviFrFfP2Km0jc5u28or7vUxxZ2y+DsX9dWDzDX3QY/6buti3NERbAtGryqNrAtHWC0L0LQO8t1KIJjrrDYbotk69yaktnXqdUxspbOspbN9OYfuO/nojhu2I6gJONt4WcLLxjoCTjUTACfmMto3RY2PLGFU2NozRZUNIQA6gq0uAJhfQPRh2WO7CCNiYG9zHAvU9gfoUCDiggI0FNfh4H5nvWijEQoLkPZrTBIkvsJSoGbDu0ZQpgc+R4JPmOYIIdMt0nxbH7to6xp9nk2WeI0vT3P+A3s2Rhc98j76ACVhMlgOaLpMlMmTZk6ewZJkbHozNAwhZxi5ZhCV4heAEsozAi5ElSwtkadFbyNS4swr8PhT4DRygwG+AGFgJb2lidIUY13WBN4QY3ecnxqsuMbZMf40xwhBDI1KD2vTYW9KL7wJ2nEpAAkMbyJ1MgqpFd8yGoDtiY5R111VqCSPYEHQP2CBhhAP13hLUay7UBy7UGQqB7cCpISgPHZTb5gowGSIDtnznbiF7H58XbtyKdgc05nRQsHHru/pDRiLfz8BmQTa3vIx6oY7ARhiwZxkwzUH2PvfvgtzccFFKiScMKIDs0akhK9quQLYLHHXtptwbVkffx4qiZV7VILqLvtHCa8Q7t05w5H6IAJ0BkYa1gVuPiFoMqGrav3bNIogU1eyoHrDRszgbaqMqOGNjIDhzABQtAajpAihmAC33iMuDfzaO2o6Mew9pvnzN6uzyajUrixep2RFWtiMiZBK1TOZd2qd7X5HoP+7OrXfpHiqpz0UpVaI7WDDdoddwkZ1U5pVxz3pGSpI4KvEYrAiLbLpNl0T1Rs0PeLTeh+o9NDJA1ajeMlOTJsCNxNOP7WBR23AcEHtDahBhpB3EVYh1v7RDiZq2UcbaiEyjkJoY/3/Axhxe/nzjmC6dh7RkQSEf7yMTIwCcQxD10SrMIxmvpuazP8BnIAWPZQviYW5hPvs1fHZAGPRQSVkp9kUBfYGxDmFZask8bZnYpgsYm8L/MruxvIDA/gLvAStWRyUkk4Ad/hOpsZC9CeL2BH6dEC/2+3OHzpljzpxny0AAEOky0ljw6f/UJO+LoIAmuM5oQJ7gsmG8s12qWp6FotdgXaxPhf/HfCkWwAIZjRpGAiM8iXjWJaAq57dvaEM1ZCiShbw4gncoBrKzgMCSWdA1DF+4dG/Jby9+gpNKt3Uq1en47UO+lZNFFBq/vW8e/ym/fWT99jHrGa/ATeLMgS1ZHiYDFrMHVKVhJmYrGhQzp5ZjToTvC/aswpyay5zo42fOGXMGwhxtEA0eUlVEMAPuSMik8amaOTLFQqZgNTIFgHtg4R4DgLElk4hgAUp1yBSsTKbi0ovJlHjLdBKEyjiandAgJz8jWuKBuSF5y4xrukpZkyoSeCqvdAvfaLisUQ+IoFH7cB5R9Yx/Lwn/QDlXen6JhzBvlSHsomrkCEV8ksesMdJzVZYAmfTcQz8nk0VeAcImMnPTgUgEAwpEem7SQKRnrvua9E4hNSlypOeYPcVNcf7a3EYGK5Ge/QfUWJKeWRwD9CgmP5WeZdJddifdkTSX6Ag9Z8t8UY5vYlVulxCe4Bw3FOk5v2e+oCSnPd+yru3bupRbWnu+6WjP4THacyfTntv4uqtrz36x9tyhtqM9+3nteSbacwgK08zRntuun531tsR7Wnv+wf3P2Ujjz33zBa07f77Wnc+x7rxCnPG/nqw8/6mjNv+Ok/6lTHnmUrIw4pPijB9/pHHGayfFGa9lccZIF8cZrxXFGaMKJM4Y2uoHFGf8PkrlIp8ZZyzSMeuYbaNjdiBgOr1DV74xGclMKQlOTiQ4uZcFJ29DERIdI8TT7khAMrqNAQckI3do5LKLHKqhbFJ00hcPU25Tx6xuGxKS3KFGcUgyq66ni0ruPyMquZVGJddWjkoeS1Ty5OSo5MnxUcnjF4lKbsBqULcgKnkK2WqQ116ncHiI/sUY1nwYstBMO/DhTHWE8gxPIU8EgStgJ04d0ce1x4hG+GquXtBuRttUh/pal8kE9UiSExOYa1+L26aSfSWOCBd6IsIm9oI91EF2wYXsAqY/RpWnopN3C1CWD0EeIz1Oo5MnMCfmoz2k91aOTh4tRyc3SOpgjIDLZz7sHLcrfjqjztYpsOpsQBUMZcY3xXHLNcxIaiarD3G2XxS3fCkXtzw9MW55motbhv18ccuXs17/SpZ7Ncu9luVez3JvODHOzeOk2V9aVZrtPiXNcg+qWhLjjPiQlurq81quNFt3pdlNSLMYPhRxHOld1Uul2Tpd4UrzjKITpP78Oq/NxFwOn83pXju41QbtQOHa4BkT0h0OjUKqzxoXUkPWuJBqoxtHimdyCU/uEhqaRa3PRtsYEYxsuQujY4wGtbTRN0aNDZEEKqieJWnWk7VVJdOrxtQwelUg0qyXl2Zj1zsra468NFtOZs+UZkf4s2td/geOC9ejXeJr9+jgaXnIe0qaLeek2Zl1wO/miptZaXbXKc4vkmbLVpodOdLs+irSbN1dDslrlgmomtCOoWoP89peFu/5TGl2AWl2AWxqxQ4K1Ou62Dc0RIepNFunawLR4QtC9A0DvDdSiA501n2G6IZOvc6pTZ1acIpS2KoUtm+msH2Lf74EsO2TEnCy8aaAk423BJxsDASc1NKGCLAJG5uiSrFBxthmQ0jQcQDdWwJ0xwV0woAWvWqbUlVibnAfCdT3BOozIGAk7oNdivnIiv3bFgqRlWbfsQ6Dd3PSrEd7NCuWZoUgrjR7QLvPkmZPIsvcJYthrwdBPEcWPvMdo9eOiskyotkyWcIiabZcJM2ur6BzFZKlD170LVmGIMuQ3kCmxl1OmiUrzRKIoXQRm5oY21aaRbSiEGP7+YnxqkuMTdNfY4wwxNCIJMUkGOoUcaoN2HFqABIY2ohY06WeRXfEhqA7ZKOfddc9Ggoj2GgLI9joCCMcqCdLUK+5UK+4UGco+LYDp1hQHjgoT1XOTJrdzXfuFrIHK0izowJp9m1Xmh0Z2OzS28+UZmfHSbMIiHYhe8D9O5DrDhdF0mwRZI9ODVmRHQSy28DRNm0ic5MoJ80OjTTbobvoGy28+iLN9kWa7QA6FeqwNIt0orOGDKhe2r9uizTbpZod1X02EouzVqbThmxUBGcOgMIlADVcAEUMoKUesWjw94+TZmcrSrNFNSvSrNRsH7PRPnWQqSvkBGkWlbTDRXVXkGZXDVpmsbaDEGVHrEVbVDKxVmK2emY5K3M3aZSnXN6hxGNlYm2cF83rrsu7Ic3ELu8QzeSItf6Sy1uay3TyPMglu+L6PkAmxgQJyUI7uS5vXOWEZI3N6LZLPPBhfJKQLIws4vLOSrEhWfoCYx2uP7/LO7txGpJVRoAGO3WP3OgscXlLcJbzFnjm8paILO/FXN6+uLxjILUuSI2pbiKeepR8tJHHzU9l5HEVfhVnVmzJ8jCpsFhboR61MrG2S5Vi5tRyzAlFLIpXYU7NZU748TPnjDkVYY42OlR5SL2PPKC4+dkNKL5oX/Wv4CtVhG/UWhZrK9RJA4o71TP+vST8A+VcsfYlHsLqq/94RkaoThYn3DFibU8WBZkck6Cfk8kirwlhU8fMViuiKVScOOHKJzdOOIEhqx5XrM3ihIHz48VaQcnqYu2xgcLvZWLt9AMJFH6PpqcJFJ7m/O7FgcLq/9n7Dvg4juvu23J7e3coCxEAIYKy324YBWwgTFEkKEsEjoIkdlKUaclOk0K5/EAq7h0kKFeqJbRTJeuzjock6l/k/FyoSspxt2UzcXca3ZXPTXIaLYvO9/7vzdztAUewyvUoHWb2TX/z5s1/3szugOdO6ePfeHKQlWx0Le6q5mBcG633phfXO47e1u7Kbe2xz03B/d9+9Ha5D9orzRmN+ZEd3LGO3CWGE71Dwh0EOBpQLJ5n737XG5uRJW6uxoX4nKdb+p3RxDUJXXIkjd47Hxb/zMkc5Z7/UK/yj5a5ES5Hh+PA4fi4pp/0qUdjKR1MC80N1XIdc4v6SKIjXg9SuJqNi2xCdVrUIQ3rKf7OUS8X78H98RzbT98X3sLEUC+Wvvl6Q6xeCr77hvpLwS279JJs/HH1pmw3ug5RNUBDhaO127OLpRSnfeE01vac+dgo4utF99G70eFFcvHKbI3hqJJf/InruKmm5UzTpHwIAK6pjm5K3ePdajx+EiL30ObuLMxkY64bduazHCXERgfqE/0dvlxdHy6hqMZJFIQtsvbRVKI/MiII6xlloj/WR+xMh5TVlTBXg0IIY4BRx3/6tlFmFOMCNdXIgcopd+LAapSHaD5oIVjpw/GTAL0d6AXeDtJFpXHu7AhGm+h7qCAFccgARqLHIbuUFYZDTLnlRcrVev4Gx/Es8yktV9JsDyKjN7GDtNTtUTnqZMcVGYuk/h5hf5odxwq+CrQHo4WDukDYohuFLxgIsWO7n0PIVua+n8e963sa3bserJz++nV/WxJsiz2uWiACzpkFqevX/emuXw/INVesyx32ECDEE8cXB2HRO6e9fv1dev36LY4MP3dYBSinMhjaUZjjkqHcuYbIxocvC1/Af6I/Qx4i2JKanVz05zreTXaivPCYk0fUL3dRq0c5EMB/prQX5YHLDs2wBu/YcxlrrNKhjOr3JFd66Md8xT6yyyGCL1J49Mr9JSoi9/1LsRm92n+Y8yQcvoHi/wvpOYckU6uAEFlkVFqhSSE+Utmw+CLJoKF6zygfZbT6kFmdM7igP5GCMOJA9MnBlIquw4OLh8ThzKsFFgekFKlR9KcphZI4olfhb6npUE7QnikdvpbZE/3vtdKvicyXKtvpCRMlK0PrFG94oopXZro3ooNYHlE5MN/5Ax1FocyioEXkGRqRv1p9c2IesTKfZ0sx0/CAmZhNvLxFwK73h0nAgIe4I5mwrTfhbl2NcqFCLo4DRgXFl9rKezLbK/704fd1iZatDhBmNwhMh99TxefKOBPFF0LtSDQZVfXdXbwEbYyUZcANiOgjvi0JGcBntB1XSjkHkpHwIvnFb3TkZvBJM5d/3nj4ptCoqSSIc9zMXb6cMAurU5e33IsMm9lxBHthZOarWCn6POak2KMMENpoaewV0OykaXuYqW6aw66HnlUOu+CwDw675CuHXcNhLXIOl8UW84Dc7fj6xZeloAITl4xKV0Ysakzh2IzxDekI5CRG8/EoSoFXujioxm5GzysAkLfzLzIzKuIMcnqKoveY0VrE+I0AxFVPdix1Ees/vVHMRucnZ+AMS2BKm2HUJ2fp8g+Iz6cguk3y8vQ7I+4o+MEuZhKX2yRa31c5DkuPc8YddMZ208hOJv0zk84oZW27u5h0ECTz3M3PH049z8Sox2KwiqZ1wurgmmKVuC8+MxWCA+D868XuAarXi/bg+1YqonhnseQDbofJbFSbSbDMO69MzlIYjoZhRwsDrhJ9Saowm2bappJX5sAzKxOJp7fXdFQvApiF9qMc+diST2cJ2nexv2uyNrzZN4GSeUcOsyMPQkwpq3u3xVnLxA4y/HO4uNihWdSDwyjmfbozEEaOaXT5/IrM1VJzdBTkwR01ndXOlU4tScirSKNRjE8u8nOrm4lnoCVyb8mzpL0w4MDpFU7KMd5Zctp9lvKU6/tsYues0s44sKVSrw4FNpYUUJIcTzoLfpwuIqIjLW/5+CeuGfj9bw5ZlwOsuh+80Lo48hRXyX9vXZAJ5GFeA/14v3X18BNJyJWzrnrfwYetWwt51cu9/uvPnHjQuhqSJJRIzWxZh/ZbV+tltIF1JTMiDiPzD3l/fnD3I//+1B0PW1eSfvi973v4PT+IV1iXkwr93s237tq4812PWNfS93R96syy89QK61r66y59tHv7o8/fb11LX7cF//56yLpKR5vY2E/JlEqOfeGzLzzvK9+6wLqSyXdvnX/9t7/1wkesazPf8dP3Xv6Nsz62wrqW/oWrHuXKzdtvXUv/m8NRR0fHtUPWtfTVUrmP7Lcu6Jbx3L+OGbjWTeYc2TB17ufe+aKT/OaRzcnZDQJ/i87GWbmY5hz5DJfoGrqbypKQwZHN5iIOjMlRI6AJ2zmQMZ9RokSzaRC/FGFY+nB8CvDR46DUJhsCvaJ4e2kWxtIsHZtFVQtmMPVRQXSuTM16j+xcURjxPB1f80tqa1voDeNuhFKeY/TTPFoo5zwXlRwMPdguVdPjlLHLZ3PtiMUtI3wQlYcgb5tLEqsAWWPwXQRCepamFSsoDo678ik4Vw/JkiFkmZD4ZswSpif52nTq4CEYkbjWdnAWjCLMFJkczqLWmOEA6IHwJKjTV0Xqpx40PnGrExbwOLnylcE28wgjLT0b+SJPVi/IbwHnw0bDhTCsLaSO1YbFM6vr4BCT6sc9cjnjqIwZHuHd9eGfnxzeVR9+aHJ4Z3349+rCmTZjqatdYpf1LdLP4Dc5UMh4cPBb2wvLUMXo4c7hisy1+8pKGH7RcFnUcjvkq50isE3EhRQzVBfcxS7+U4PpmeirUpdnNaIC2AO9CtadumYjBwtkpoxGt+piuLbkHHXcxpYMtNVaLWqmDEYtVcPFj0HUxU6fIlwBfQvIq7EubdfgCKma/q3nOePBmDMuq6TYI2e+jD4HP8PE2B+59TWZ3ed/c9nOODtyy834d+cQMLI3LPGx2tcFTSUJRx77NP6Fw1txjDKI7kZInCePQp3boz+7CZQQK6ZyFftRcEt0MwL2jrz5tatf+qHfPP+CyoRGJZ/y3H97yxRM2LXr1l4W/cBU5smhShKYnA4PbTWoL/u0xwgSEuyCOXOSArlUWM3IUNDyvpSJLjzOBlaSXH3zQgoq5NtWVsijXLqRe237LhzmylNQPqH61w5pc0ucUV1GbXOBt8nBxgtWgvL7w4Qhb5LZZimrE7d3nzFbnsmy7+ybiH0BdS55PNRlURG9G1WUZR0/vFMf2Ev+LRzJXd17cgvDiRNdGD63ujAME8esWbeVXv+KbRzrGVgjnjfFOIdlyLHMoGKVu/F0GoZQKPud6PaqBag0kLYM3XEMy9D/uFwbyQ+FKp+Yce5r1rZmLNlPsgS7DFPXC5UfdXUZ4DCRx3OGgFbHfs7Px+6Jr8rAIQ9LZE8mGK5DzRSdNVjXqf8KYDq1sTurJMMkkkruq1F+Sqmay5TkPpKzJ3qvMRt40sHKxVrjt8H69RpusEf8M8YtWMefVuNWdNt1xm7rx361Mo2b37AG0WfeIdL0Dsfl2xt3kitvenjkzvUiJGo0UNIWcH+ZF7HjAeBMMnl7MHmrr2+Z26ehc7BsTVm8vR51+pQ4p/hZxwmP0zY4cI21DX7xri/Mw9C4U61lxkSo6yDWyNZWqGk8SEkIM6qYC7/AaZn7d33hri4xFuaiu+oshSrLYD+LsjH0RXdbOfZjPN6TsuG59Ta8KcP5pBTQvVMU0MD2mgLCwyQFtI3HkQ5HGUN2OJPDDlTCttKmaySZF/1f5G0HeQam3RBmOyaoXc6TBqkN0xFThzq+OvVWsL89HiuY2SVCr9UrtIFj7xJpb6AvYn5kZ9Iu0X0IR1YnsEu0Cerxvoa7RCtNRTDX6mYJ6H31GA/BPang2eng4nOQRZojppMcG4cpuiFkLKrHVOeN6yvqfOnRCkvv50wtsYRkdpZx0Cnvt0NJpciJPgiC2l2NkEvpMINwTlPE/IBfZE2+0xl3+AfX4192p31ls7THYcO9mWw85NdS8ktW4+NNNRc5J9m5XiYJiJ0wyV3aG4fkw0Qtz/nbYbsprHwF5XbERXaCHXGL8Ayi20pIG7fBieJ2OD1xhAPUwsVgmbfbYbe4zNsFt2WZ93p2csu8l6vzUiVeqXGu0CSb9GmVhg1rzEENG1Bin0YhJfZoFJ4lV0JqIzZj6etdc4HUx5IzdiQzOIR/W/hVTWojJnSujIh/l/UmnS9ozUi6g5lR0jTRWNK1I+lmajfSUJ7kMeJHTsHxqZW6mMq72mM7x8ChUTMzFdjDBTljXE7nZRAac35XDfpqckUDPZnYnycSA3vQTKbciY7CvO9JbTDxQ2kqNaxRfQJQmKlN9bBX+YDIKXqN/yAV+9C1pV3vw2ugpruiB8243uMYxZnGPU69mvAt7jk7U8slg8xNbshftjU/esNxRfuYRPuzLzsdz+bLjAvjLgzAb8qK9Pp8qXH+TQE/uzvcndnxuleODyya+srxje97q33lWIbXLjzre8QaJGNvN7xFHaqD+qngXfNG45DdA+zm8Ty39oaxI17d0otbaoGttcA2DWyvBUa1wA4NPKMWOKMW2KmBXbXA7lrgTA3sqQWeWQucpYG9tcDZtcCzNPBZaNJ8NS0/G/6F6if456o/NnFgXEhMHPh/gwFJZ8yIAR/O/U1e4sVnS//jhTF9PQivw4HDzNK3wtHZRnr5t0bhLkjmUh9bFXmum8dag/iP8CU/Gj2kk1U1i2Q+vJJNsgBaF/IiHUTOdhGWPvyNF9r8437zStM82cuAZlpUevVom+c6GacIak88F84COYy9CMt5igcoi2H1HATscuPFcN/qxuc0PJu9BIe35lKO4Clbzx7r2TWXMlYhiopLzl05/raxZCkeMqL7kmVCGaSlNHhZL4ecS8vwY/+5xE+X9cbL6RzYmM6jfk60sn0sfi4ttmvJ2QfK3AXn00DtyMhzJiaYdAEtqq3HQFhhLcRsgMIie29dDkMrBeDGgysz8VK7s2DYNx/VPPf2ZBgD4dyVALntb4mXgZ65PxkYWfzDp29+w5u/OlThfEqghvG5NMAPK2mABkC90HwkM0cXctvm3jt2/5HOem4as2uyhJZUTVG78rVXuvNyKq2f+rlvboMdJf2SjIonzYXu7mcqDdEFeKGCc9DMkpEG9+xdxAFTbdLJxYh/ib4ILTMbOIN/33xofGyZFyo1U0/N6Kig/lEaoUummrSTVSjsSa4IjcA3xeScrLbmtyVU4oi0khnRYjlrXcOalvKHvvvTtavet9y6IP4H15ou4RgxN/bgA492/viedw9ZN15SCs1XAw7ChiQ2QRoBs1GteInl51+q1e/ZJHw8n1bQJRqpRWXpK0PWtUZe9BlYScK4EWlDYxY1ZieBaUu4LoZFEAFkV2XIXJhi59KwmGKXmr4extTJa0UuRsfJlt6Yw+Z6B+bz8yDxj0fOoIzuZI28eXwOHubIHJNJ1gppHQvY+qqArZc7XhebrlwPadqgxtMRWhv3Gxlep3K2SMymzNddWTDW8JL6KSsBXHlh6i49HdGuN1HQIm6qNKofurefs2rDy9VoIj6PLJGQhmtBZAtHwbQm7scFzM9w4esBOdbTsBlVqMkaLn4jl6F836j4CBCun6VEfVlwdrfLmYiuxDna6kcz5uLNc7GIUxZ/47WG2xuF2xs493XeMPpBJxxr+aa1cuP0BukHMGIX2oQoXFlzJXVWOHIereN6bIcVXUlzjao4kpHhtMhwZfLHD+zRVM4sq5eEoIsXUz7mOqP950j7zzFMKbUhMldoHSqk5afqs4gLXkxZrSz6xuqu+sqgbvBOW5lFtjKLapVZp6/hr0NncXtrh0vXcI40x5SDrI0OpX7M0SmCGbAosv5s6Rr2cD/TRrRzo+n859Lyy1vZkIA36FUipZf6FUuAYxgNOp9jIhC9T+eOUX/0ME/cqDuLFmvrhK9bgTNAz6GBq3uJT0n3WgUO6WMHbUTZ/fbGFqnQYjoXcJjnws36zuX0gx96Rf+Nx4Oo/pZWp4iho/VHB2ndZQiNJovBmpjFgysxDKhAmN84Eo8cBOG6I/bqjgrXb5zrJ7B8sRlFizCKFnFuwaRRVASUZoZowXjwO3YDgaJyTOezggm/uS1NXcib1PGAdqWpXlZ2kd2JhPlFzDU23A6AW6keW0gDy5nbS29PeAyP0uDtSf/6VpfmydnQfl1VYORt49C4H4Vk4gEuQD+3UMs4GbA9UWuisjq7MBPFi91hbmWBi5Txwez51QBNnacMmjqnB01N0NQETU3Q1ARNTdBU+DmDprAJmqYO/iZoKkwLmgonB5rc4V8tmBQ90zCpCZOaMKkJk5owqQmTwiZMasKkXxuYhP+4iW88ka24PzVw6S+PBpcuseDoktMKjoJpwdEFU8HRisngaKgxODI5bDpN4GhlGhxdaMHR+VVwdP7PBBxtohXHBkcXNwZHqxD/olMBRxc1AEerjwWOSjVwtBLg6MKTAEcXcdGnFRxdQEN00XGAI7CSVp0iOFpdD45KpwMcsQBtUPHRYcsnLzow86zxVLTXQKRTmKnfwCjtzQ0QqHUpiHJq8ERm0qkQZYpyVURnq0J0+moQH0/pOuFnMRNiwockcIg5KMoxaVSzVUpKt/qY3uxn/tJczZYOOTKly1uE68143sBKbRKv1yJTnOJAW7MGcqzT73XMRXXX01xunWuxh7b627bVLj4NKq2mUSkUjQa/TKMt6vCldYssBCIDnBdMqSjRz6FGNXCwAYhhg6IVDl5bhahrjwpRb1WIivlpkZmEBoxLxo2MWwWugQBXdMYa6RrkHzQGrgbxrqkCV5exYN6lU8KtbmbyZdxAAY1wa1jFrRyhIW51p8GtWtdj49bpKpPCrWENtwaTcKvAIrAxW6sOp3IwflEVvlwQpVvoqgLDD2Qe7AXW6CMUyDhMBGQuPSvmLkMJa9HytacVyc7joXopZeFspktp8+/10mZGsrVj7gAODZAsnR4gayprwawdbHMVxDYGsN+1g6sev86tH11o31kcYzZnrhG8NHr1Thi94vM9U+GrD1mhKeg1tOjVa4Rew5NArz7Qq35JYrH0wi8jcs2cLuQKxGrRaxO5NpFrE7k2kWsTuTaR6y8FcvV/bZBrTxO5nhxynckxun+1kOvCzBm/rqA1bILWJmhtgtYmaG2C1iZobYLWkwKt/s8MtHY1QevJgdZOvEb+cwGtwbSgNThZ0MqMD36BLa2XTQatz6sDrVCpk1EraHWwFZTpcCuCAVwHDXBdboErwKwFrssMcIXcvy/ZfOFjMz6/4k85YRWpbuaHC1nSN4MKpLpIRTfuryLWRfeOve/IDMu4XUBtw/y/XFxhR2xjxDpXhtU7zRiajFgXYRpZPJrGq5JVMtLggraLOQDk4bXpX7IK8YFXLQZdXMWgw59K//Tqw28pBkVWaEn6l5SM3jON6DcNwDcHmL9/86bRpZObAbD6LQNWwdj0z3Cl5cqVldb0D8TvKFj9toDVJ594+QXpHyvoBQasPvEUwCq0ts6rqD9GvNbh03oyJ0GTDVRFlJZ/av/EivRP1al2FrhI4JmBqr+BxICfhjvoT0Sp8uLAcTDjoFbEYKpFIC4ygDW3xD0wP15apEGrEDEPlcZGl7Cafe6WeCMtp6WXxVvMWktEdVl1jZWGJecYWLJuKrRab4IwY6+pit+aUlA9W4knFwALvGQw41Sn5PUpMLPhJMDM4unhlU4PzGZTdBpHnZMqet3pL3oNpqk1DeGTW4NPSRM+/frApzMawqfn0WW/YPAJVXrmMVEHx4iqmAhAbCOvmaGQiFHa8p8VSho0KGn5aUdJZigvNiDoHLg9EDLJSYHSc2rQKSvHLz2u2/GjpEUQhUUplIQH5vLxoqTFipLm4or/YZonA3NjCjSdY0HT4f0GNGUnAaQV9JwajBqYmAya1qVBU+b4QdOWX3zQNNQETacKmlb8goGmLY1B05Z60PR8BU2XG9C0pR40cU+cUxWnc3QS4SqfU71kK95sel2fLi05VXMX17kKSTZWIQnUOWVZcSaLemELOg6IsmsyRCn50LqYA2UGxhxwDm0x2OSKKja54hnCJvYVkCuYH8kLgE6ceM1REcraSQglOipC4Yn7lc88QvF+rghlDWicvby7tCYNUV5wmvFJu8UnV6DdV9CWX258skXwyZaTxSdtHKO1Dp883+KTy3/W+MSfFp/4J4VPwF0fs//PDG0cG2Y80YQZTZjRhBlNmHFqJpA0zFhbhRnZepjBYev1bUqzFbiBfccFOBDrdGMOoa+39PWg/fwgx9o05Fj7TEKOlibkSHVAkWMUftEgh3u6IIdX/KV8pzRsnsxvHnJqHnJqHnJqHnJqHnL6td2lC35tTub3Ng85nRx6ncUxzvz5nsx3TtfJfLf4K3IVQc8pfy6uZ/rPxTU/F9f8XFzzc3HNz8U1PxfX8nP+XFyh+bm4qYO/+bm4FguOMo3AUcsJgyPU/2y5cv5s6kOv9Ml1T6slIDAXkd2fz+Iqu2A82Onb6798uRl0V4dc/2UiygV2DvopBydMwkuTfC9uTkWZBXZ2Pcr8RT+1kBu3esAbLUkbym3RC1QDuU+OnXCZR+r0UMBX24U7knZcMQd/bkcS4Z65gNiJ2OGQUJ3DkVKfiDTx45FmecjQv2yiHzT0j0crudDSgWiUWqDsfIgZZRgDjSUdXCSHtsvVdO0gZohp0cqIIrmdLtLb6QKqpuqpv9AOpDCZUXenHachD7fTUQe1V2+o82kGPHGXXF3aBUI7xkM7RZeZe7rz+uFjHqTRyva4gwpxnopxN5jI9Wl7Pueb52QdcTt123y4/9HnPvjPjzI0ujjncc5500XImLPdzcQ8dTCRc+2Wx26KuHQ0dbNEcqmtVORqzqS2hZlP/4QxhV49jMeH8FiCPqOZ5HMlKYge0UsoAQ5VIuIcBfFMXOmJGIkPcBkgfm88k8Whm0N7qDXOs9o5zHlTD1og9/j5o9oIrn2Iyvu4vpb/yNDokRb1UF7cPNf+CWd17LMboRG+ijHljGCERhBCCILSD0Qp8YLUWPlS0YmMqHDgx427z9DvMzndYXIqG/pfmnh7DH23ibdL7kDEre4sbG0nKmwQG0iTCmu9xKWiieyBwE4keXVezjLTTu074ohlrnNHHLKoUeftib+N6yB3ePuoTDfzEd35Ye3OV6ADpESVUzpjLM5xh0XUTl29t2NyNyIQipBwNjkRZfLNHfTo7Dz6uacaQt2jlEdYkSKIW2SF3DY3x+3IoR0Q+nr5KVIrOBe3UkHcAhXFLZJenJkj0TaJL8gxa1TXYz6uQq/eWshbuNsSE8ZVRwG8xEoCCnYaxWUfx8jlOsiUntvJFO8FrQ5lUdGBhDtzWP2DSR7qSvx9SQFKSfyUFKGsspw6/wL+U7j8FedlfkueQzwX8Xw2uRTwejAJx6L9MosWtMlcGllawj2OOuWRFeW4h/MUUp7hbp4CKoB9IeSLJ8XQzF8t7A4wo9jhG/pYu8btXN8WatGrRE10xugrx+NAx7AZv3lq1TicN5cQMM8pAJhvh0BEnOGgZt+n2Z+N7DO4a595zjllwZEATl8SbuEM2Tec5OEMJAUhrBxXJhUoxA/1AJ+kSDSLWVuc1A5uQBu0nFYuNO3g3gE/ZY2GSnLt0LQdzBGeM0q4z1Anu+gA+FikNrShvb4NXPk2ahf4S46uty/jwBxnwtLeIuoD+/72Ss5/djy9zNWI0y5nW+KTg6tTfXJxWao4VxCIUME8DN0dSRaXqsLv7EgC3Kzqy12q7HDIKnUGlTigOfRpDqTEHo0SKTHUKDi/kXO5DDCLPIxhL6UVGM2BRQ4eQ2gPn6rBUX1w5jIMr1zxH1wnPz7lelqU45faBbO4cYBSoRkoJxNXyM958kT/FigbFzkMfVvk8hj3O73QFDhDUSj5OmjHMWbzmPPzJV9NtUzw4pBThjGsAAX2mTypgDUHFVGWmQfymAfykl9SMCaBECYtLhS5Fqu5FiiI85oXFTiA1wXRkaIXMQH+DPszZupAfoT8zCmIQFaMrL9xJ1ieHX7iAYggF2W5LBZjejs6Itg7xhGh7g7XJY6zk/uIZ21ghXHceP7AbU8Hcie+s5MyW+7dAT+GsRIuv3esuOd0XknvQbCBk+CrttpjWBp71WvpH61dS+8ViYMnXUv/sOvkjvNS8p7qpeR3883iGVRBbyNPXULeYy4hz2EEyyXkdyEueXIZudxC7mLkfqjuIvJa5SkwTcqiIXIpeVbrYCsi9+O/9JpSz3ZuJtczwETkYTTp9OMa/iFdC9KLL0xyS00OXF9Xb/7Oys3f7ASIJ44vDsKiv0/dfJ6rv/m8vRh9+IaTv/L8I1OuPO9JX3neM+XK82EpRboEwgQPs4GTvZycbWDS9NeST72pXS8g1n6sv4C4x95T/mZHruoGyyJFdSxG0DLQpjtW+m/HUziGx3CHQl177iwTu+xzoFUgmmIkxvh2ZVqXm7W5hWog1uu/ISDE/UlZETDy9Xbzt5y2OkDF1FchRBUOZOrqwM9TK/Gg43rj3phlMYZS4pkqXWzGAHIU/nMxKN4ecWRhs15V6R6XhIiZ0jinxSg3+i9hNFJhZS1xWhrHAXypYO52ZHQF5dvIk4iU2b6vUk6yaKEHm4BnK79FGZi5SMTQsxZhnnh95atvIQIeQgwPX8YQ2ophFX1SFAj7wRRPc/1qa+iOO2O8dByTW9DfVL37vOxNuvt8t0cexPhGuJxpHzkKkNGebJU5VyXBeZl3IA7sRqMYrQccPKF9obn3+K2iJ3e5DG9fi2uLPcw/H+Zo2KTE7kLI1yiPlvYJSCVvZUauOufgxzOYqDQeedGHdhujOHnzvZcmeanFrrf2l17EbLLV1Brml3t7OAcgmJGv7Pjqfx380SPnbWX/O92+BfNuoIuufuUrseoJz8vsd7Dv0JPkOdRag8vs2+XwT4z2Xibz8hUU9iaFyl5TKP69qJVbwIluuRn/vjJUoTylGNOLbr3P8GKO6gBf54vi9iQEH1zw4R5HG0rFe8m/t3rb/Bzld1EAAj8PkHijr14HWOoj2/mAH0C2DCR3wtcnvrEHbqug/VdqXkXwlorzvSui3W9VSOtRXTfljtlNH2f25+r6iBhZmJbfP1SpaBdF/4TKTaDhV+jF40+8v3rx+B5z0fiH5XBgBp38uIQ21MLelzUMV5RLJkXNcN8HbIaaxW48N8oiaeVMDttMlrpljWitVIeHeFmoJOKY7l+pH8WhCHMj+h54oesd9C252ojoUxhauJf7T/G4TzY2HdgDVBrwj3mCCBJ/HwtO0jYiMvPYY6WtENa2qrRFwxUws1KmcF/F0OYMV7bGDu6/5/pcXpJmkK897laFrGe4UmLSIYRW0P8h/mR23m/Czx+ulEcWXjj7u19fOmtIopa/eO1u7p+aoFPNe3Vvlb5nmGrerb1Pu4kDQLOql9gtZdb0Rv9ynSoKHvzPJw9c28JORi7rT7N4lY7mYXUG1RnQe/0fd9jlJN+E65Xe4bG0/af6B9n7hHoH2Ps99d7jsP+Q+g9AM/yz+u8D/cvq/zjon1f/F+A/qP4vwf9p9e9BSR9X/35HZRz+g4hzQNVBnNfKtUjIbqRYIN5DiNRXK2tOtZZUrfrsWhV7xPtleDvFeyOyimrlhbWq+uL9ouq8fFXrfVoWonm5OB7zxo1eIuYBDuRRngF9gBBzPi/pQIF+XMhKWacH1d2jqS6f4DhFjbTf0UjhRTamb+YsMKCPlVOMFTeqkwEaqMh5mQygNSeCwTLU3WieQKoYqxRGNwGucBRhNuWjb7DmwdOf3cBgRqnRLYijug8h7wDMebfQDDX6usZgHvyRwp9SpDlTIfriWyeFfcZx/Ooi0NtmLaAU1M1MwVFnptewykvyVaUXNJybAmhOOJxBT5IrgTE5PMy+uFeT+hQgVQbSYVNlNTckYzUMYIMkq8gxvCY/elCaFXDNLcBf5TiMXezET070mKBPjzDxII/oMyC0prjiGa445FiukFf8qu9j0ncYC9VWMGa9YKCRAIeSA8GryomA9IwCDRWOEGLhseRoQItFIEY/OUY7/hC6IRHGdnIKuD3sVuCZzZ7oCZ3C8ByRf14GFXYxapzS7NHoSYRqljpBEdct+uwNVWr0H5I+a57+U5488/Rf8hQwbIe+0wnG6uHEhfeQeLHQ8Nf22m38vmGrejcMl5FSpp8ky3q5BgrwWDaP5fMrFSHI7K4t1wFUq/NB7bDbABHLZQBAHcOGD0z2MBVvTdzeJKfj1jXjcEDwaHHk1tdkdp//zWU7pTNyt1F2L2Ov1/zp0Oh3Fn2SrlaTLSo5EWe1U5ZIpwB+ZnUxma3WX+YdbYKhcHYT3KG2l2P0oV1gom7T4qFMb6Vc/DuX18UiDLFr5YKbDJExWNVmXlVGIUTNXYXjMjJxmFV0xOQ6kRE2Rf8AHsqzoRO7VyMx+M7d6IPussYmZyJxRp6+88l/XP8Hm4ao5r26d+TF8u/bPCkzm49dL1TDZF3DOInDaevr2oeyHelUpqTBQTVDVqe2pN5VgOh+8e/qbAn1qBtzBJcjjR+MdQyZkRJnyWuIlGRxBXMUHxt/zXbyop9gDEj9NIcIOSCjrM5pKMsu0uHrHNX1s48MRLP8o7TBq1kbHvMCh3UIfrwusXpkoM5yO9876CRBCtU43G784UVOWRginNie5BTn0O+X3ZVXt2ZqC60QQq4rnpxRfGowJEewT1XyKad4Ov+HSeFerCWjHffLIguGXcpv3ybEHiYWqVgp3wZcXE3M224tFSpSywQF/Cc6AnZZURf7K3bpwqR4c5V4VWs6AoKjpKUumFAQcTGVMsa5D2wkkyWUPqygvIsYWptUDkuyXIolq41Zc8AOvrBuFs1yZ1Egkyge5oyWHrgR8yjoZhoFlzTondemJ1LQzTzK/9lZ4euB7407b0Jn1tZ/ti8paxHc7gOZZVhGZXUKZRDtwI8hHky3Zvgrjla6AxNeau6E6lHodSV7yhyaRWj01Ru0/rt3u2rBSNiO81YUGoDGjMIilB8yeHy6KDZmrE81F11RgApoedilbIO1QMjD5HEOAkJ9vcZ8OWcDMirjcHZc5TRw3eVouHujo/E3sUMAtOIMqzOozgA7j3KcPuOSJrlCW8h/ycKvN0C2mKVmtakkVlDqLbOWYTOsomtddYw89tzxF7+n/N9Ddh4a5oHllhxtvFE2tphw1JB1CnZGzrtx4Ot/9IaLVgikxTRfpWy1ZWbMfDyLslju3wq23uphGrY5p6BjEP3IkG+EcRkaH0a6K5MAztVJDhNPwIYMUh9MmuyIOSfDu4TkQE2EqE6GB4SjBpwiOxEiFiknZh1PYi33bA42NY/wVOpAUzs2tUM5c3Ibg08zwEgM1ISEHQ6AdPRG9C1tBl50zIxWqV+vUg+lqI+Dahi7/1plFT++1dMBoQF7EAB/Fb89x3EaWXC48wDUPtfAOnPAL2JTXywz4nr8y+50xqZuAOhsodts1mIQcdY+H6zI6oYRO2GSu1TUjj0DmeRvZ6NDXJAd1bjITrAjlnHsw4LUSkgbt8GJ4nY4PXHEte/ACg7bHrsddos8POC2YJPFoxwGkzgvVeKVGucKTbJJn1Zp2LDGHNSwASX2aRRSYo9G0b1ZD8LUoYeeYAlpr9/OT2ZQW91eftKpJwBkdUWaJhpLunYk3UztRhrKkzxG/Gi2cVuxr40TANj9h1lGz+pRgT1ckDPG5XTKrj91oMM6KDSC6suSlzyx8j+vipJnMuVudJRO6WatF2ERq9SwRvUJYHSmNtXjGSJ6AMIhvYY/nIp96NrSAdgjbHdFX0S0ur2NszO1KJj4bVQkBsiOvnzDcUX7ikT719ohk+ykQyb54zxk4ushkwP0DJ8xCZX6RGjOmITmjImhf9nEO2joHw/1jEn4czxj4tozJu5pP2PCK3UgD4M2umCJmHrG5MOZ9BkTPDY8Y1I4gTMmXzqFMybnTzpiom3gyvt6xGRsNOE/esQEDcIRE7jTHzEx8nDIuJAD0A+E6SMmYfqIiUqMSgqOmBh3n6HfZ3K6w+RUNvS/NPH2GPpuE29XaI+YhKd4xCQ8TUdMIG/d0FzsSXh2PbPuiEn+qEdM8nzEJGh0xASSnHAXHcm4AwyYBkj9xH4y/oj9kfHLFhtEohvScKbJgLj3R6n7VE6ihOYkSmhOooTHOolyp91c11MosXfUbXU3ta0OmWu8rR4ce1ud6R5Ssg+cLiKlZMmePqRFUUb0ORFSRkjJuUXIrYDcCtXc8jyAClIPjzNQ5iIXU0lOzDnwg91Ad4+6gR5Nu4FevPbENvTc6TcV0ToXHTR1T9E/6p7iW09fFex7f6hDo01F/1d0U/H2IIvVe45/1YXfffmUqbR0azBKsDW+S18/IV7mlQP8vTVIcttK+dWognmt5cdDFR6Anm3ScBniWLojgNUUIwRGoSKcEId7DL4Ee9rQLeYMVIAlIcYYZW27PH5oTyL76Fp71SFeHXWgB/emCGeM/Hsx/s6R//0h+729XPM/Qc2NDZY6yCtbmq1n1SOt28PtgrvbS7IX98LMBm7it5rVqmL3TtSTvOXeHQG7WuNOxkpJjgWDq6il8UOOH/bezLt+iMchITElBGVfoKyJs0arFBC/nWCRaZdWbk3ae+OsCCh7mAeQyZwZ/SiFaZ0QxU6aARoOgrUyGZMlhYwszihzY5kJlWqXXDc88bSHJLl9E+WnuYElBmRykovbln0th1D21ZTbvi/xyhAWm+4gdywGzAy0G7WmNuoAdpnvPYF5olKmFi4ZbLVCckc+yWFI5pgtcRYVC7m+RfR2OxxmomYljW/F8kVaiAYI10a+d+m+Z73tu//Au6idXEyXcKVc2w8rs0R7y8FRqCpIy8uZ+cKHGeDUDKNBYCaL0Ob2ybLrvcYcoVYxX+reoX1i124BDwWLo693XazBgIWrR1xcrIlkqPfEPjm8wHeJHCwAetjxAEmdUkbM2IhLEozos0FzOb5H5JoYSL1A4/dJfHcBCBK/DzRXY7gSA/kNatnDtuxVWvawlj2oeY1o2askGNFHQJOyV2leI5r6eRp/k5b9PBAk/ibQXI3hSoziPzpOeJwHjQ5l0ieNunBA5ZAetzEHjvTYOSs3e/JIE+nRoxAWF3v0qEtPHhXk5FEu+lrdsaPon9XsYbbj9KxQ9HUhuigIj99IHQNy648BFQ8X/OyYI6cgahoZYx96G8PRT+3yZwhbvGrdLrWvTRssPaa4q1udqkqJazbzOFC1wTo6bUnn+mc5zyK34s9u4rqkrfRQaWXKakCFrfMj73/k6o8/+ZLvswF+i/x7/1A1J7X7J97IzO2Pdm9/9MVDNYv98C0HJkZmlR3+f81QubK3speyE+XYK2rwobcNk6+FYH/jh8uf+unK/m9zyd7eBHnYSFf3RjcjkkRV/vjkl2Fb2Gq3HoKJ6LuyMMxFst612f03Z8ejlEvO3aK53BLdiAh7ObkHvmztratQo4I5gosQGJJlVmTGoRcgYtznWDmiQsAqpo6MjwSYhbFT37H1HerYDnWmdKjzS9qhhRPtyrz2IlzK214MpvZiIL0YnHov5oTzMPNhtBfJdqLL/OKnOES0kPg4OPqgQd966C/ntZQZbfbuL1LvkkOh9G9S7E3k9COxR/rRWYs5V0ZszExsat6m5m2Ozabm/Vn3blPzTj1K/pKTOQH/zSkn4A9l0kfg8TTpDPw1ckKEcb+xmMDxE1UtWAduK5XHr9GEXvQt5G9fpYBpxw2XIResIF19C4KpevxfDg2F6vhwUKuB6ol7P/o2Mpv+hH36RH1X+kA9GmZP1G+SnTyUcLGMI1+sgh75ug7RVUjMz3BxsggrUYnjRE8hP3IkxNGQYvG5jqsZ6hIKuYK/2CQER5gho4lrkrrkSCLKSHOLv+3447qfiJUfF4fFmr5Pmsj+tnQEQoK5LoIwVSAQGzwIDWwCeYJ5KfFKPVLGB10nPOV3Shos8XrSK7zGL5fkov9Xv8T7Dh6nfZskl36bJGffJslN/zZJUH2bJDflbZIc4onji4Ow6LupZWQw5W2S7+nydo3joVNc2ZXhKNKjAmmMoOM0EXkwQkQPv1UlDx3OfQqjOzMn5spgZ+bkXkz5/om+mJIeJj9A4tP/IgoGfkqYXOVZTew9ZhIbwl8tw8lF36HGeF/KWmT80qux6fM7kE0Ie+mldqscw086tbakv9txHFvcgdorpeQ0YiUMTHLcoYcddznOceD1Qxznhc8c54VPj/M6fCCwK3ZBYSN7D2cAQfGX48QHDIMDEHb08N6Knrh5UqQXpWe4LLEfwe5mK/sWN5s1R6m8cWU9Kesz2M2NXXafKIxiR8JoG59H2uOsI0EuZdgrR14wAv19GHQszn4cEs48diV5zNgypWe36fYhFWD34jOIeew/UC5uoRA7sTi2pEbEFnYqe5d7AAm6cwKnhVpRRis569EJkn2chxEtBD3cJ2Xsm8DcncOZ3VgOYFXiAoUmjSdkqDW44JKjWvA7jueM+cwGfUHCIYMODrzZ2i0zbJnEob6qWbJ68B1W3T8GK0ce+zT+/edQhS2coyX+f+wV0afl3JRvTl/UgIA3gXrALp1VBRHA8aEKZIKx6MTuFfhim5QDJEkINMy9C0K4NwkrZSaEFaaH0Y9037OGXeRQyjg3QBr6fwqhr739Jmfc4V/xTakTHUFay5I1o3qvZrBVerxg9p3Mxx5zlN+WhlUF1gKpJwq1b6XyhYp0bVm2ol7PPYpORqVadAgFLO8k552pgG4PZRYLzYYV5SSWahycdQ5bG75kEbdxFbS+yHCUzbJxu+adQ2G56gdZInLA+Q44zGDy+btUZ5DHf2eghQ0ybxMJ7ZBKJkX95E4nRXGX1fe8xQ7Ek/q6TNxN7coDxOPU3dTFIVREFRDeZZmhrDCG9E7q4ngtb/n4J64Z+P1vDlkXeU75QBXnknRP/cIUyDNBHsbWyH7rarVIQq6cddX7Dj5s3VrIq17u9V9/5sSD1kUIciP5j58SaUMX/tOKjn3hsy887yvfusC6UtHv3jr/+m9/64WPWJfzEPqOn7738m+c9bEV1rX0L1z16JllZ95+61r63xyOOjo6rh2yrqWvFmD9kf3WBd3UFHUyuHy/dRE25TNbaHEXTW7O5wd3P/LvT93xsHUl6Yff+76H3/ODeIV1bTXu3Xzrro073/WIdS19T9enuBlPrbCupb/uUqD+5++3rqWvk2b89ZB1a83pIe5fx0ihdZMzj2yYKqPcM190kllHNie9DQJnUy8+Jca5uYZkXY6+gZD2yGYjuK3UxmLYwz2O3GbSbJopaenMI59xaEr0Nh4VLsZpiF2NtBLAu9slR5RAQG3ytcyCnslj8it4KL3SaIUW2e/n6OyBdhAFT1kojgy2YMrL+c/RMm7ljGVWObFcD3Ou/IeC1KGlWxzXGQ/GVNVgVHppFefXvFmoGkdVIwYx5ly3XLepWvOGUs2wQrm92DLRN1pCVvyOJg0xY1K+nGDa9LRYPfPiY0FJGbSn+PYUqhhgyKlVbozPsJUlb32zw9g6YoehBbHDuHEBO7nSAqAJ8RH7euDD6QhJ6ygIAvKM/gsTCscasDy6Jwjszi3co+/dNvdum3u3XWj3pL3bzpPYu83E7ZM2bbvqN23R/D3diQt3d3fSzdrK3dprXpn4xFDF4rUl023fdoJZnad1+/ZiHqEfrKGx6Ee6EphKYuK2KdTKRPSum5BNyaz7S8jVwSrnsN3NVIOGE/0YhEQMELrLCIcc5iQWrY1XTSa/9KoJCcyq6bPQht5YaiXjmxHuQ50MsONgweJDqHk/GMXJi0C+fHiCHd8sZODThQx8upDJyEImC/dQVxwgpLqgcaJ3i1kpp23YKwLuRu8EMYWhq96reisVHHYjj1+FqogFIvqJftjFT611vvFLAvMtwg/qEb5C/ujp6SH+Rz3PwxzWYAVqALSqo8CTpxYWVw86CLohhOIANUNC4KGS165ICuRLHSqVuFgtGtOW9koladlLLbU6VW6LQ5lG/SrtD1gyqsvCvZxhXtrGEsP1pxb55E8xOoLWYXbliKLqa2nKujrOc7zWSlLgxwF93CurX+THPpIkefb1YK4XX4TQWxKNGlajgg1t8iVUYuUkihcH+XIyQ6uGFUUOHavKJjFfJuIXd1qpXQl5VIEJBcg+WoL62ZYUoWY4Z6NU2vDQhgdRIBC5QPpENUp6YX7Icap9eKjWh5TFoLuCHR5jpDaDTbr0X8UO3kvvwt/7u/BVAXwS4RKxHnzs/5N3FeCNJFe6q7sltdWS3bYlWbYMr2q8lAtnvh2H0zf5dj2XpePA0vF8kjJfJvHeLTsw33LI8YSZmZkZj5mZmdnZe/973VbLktcXppnPqqpX9KCquvq96lc4nXB4V5Fwb4l9FsC7I6rnv8/OZqXJ1AtnwyEO4vrZ8Cqi5/iEw84yI1/m/IHa/WGFjzN4PkJYMnszPcQXB9+HZBS+x+fpWN70v67TUVSBDZ2OiU7Hmk5HiF4m58TI5AyyyTkhE1LFbnixcSxegKo8nHmOGmwtDZUxc/RNHMNHP1rNqz8/r39Q1bhogbBBcYqfi6dBUUuWKdNUnbWrLOMqnqjaoGblej8KLRsO1aQTG13ZvfLJeYDW+0hWTuKkohy38lT7S9AUZ4ckA8wRwz+76bALrDBinccOkc7/slWGN93xJaoMewfq8VUd64Lk5ju+ilr8W9DYQerJBxQ06mGuUY8GGvXjUKjfdsewQl0o+3I0mxfuaxC4FV2oKydOcjBsDlAU0FTBGvCA8daAA3AXY8ATPD3OxYGMOj3OpQCZXYD5WsLPSiBV0/INLVWDHCSW4LVFJytypUpNg0SDRny+MaNqXWDGOEt3WHfuzG0XuUpXIUWFbcNTMUJOqZfcAQLjo8pZVaEz/aop5jN0xD9nd/Hbxs9qt5defZL8rs3GoZdzxo8ruCfuo178Q8aMGjOEcJDLkVDwzWOhYCKJ5OlARqPP0OgA79PGxxdaOrx9oKp8zkeyxwKwAeC7kgg4kImIOhCvfoXrWRhgBX8F6ARhGpAMMSa0vAEfsyCcinXKAYRYNowvNbkmWX05iLSVN2Z3vmbeynTCapOeMhpNKjXJh28WSVkDPISpe2W19c0kq9MDWT37O05Wv3qgrJ77zSSrFwxk9cLvOFn9yais/t0YfxwvyYMLROEn1s4XDx6BG84XNNDN1fiyzkteKuzT7OOF7H4xW9r8XW/Qpq7HgP7iWOiDxgHvPQD+15NyII0r2RgpuSvpweManMu4qM91PzkFUjVDfoZ3V1/uZuflI5udcGOw2UFiz2bngeMc96WPO9k72Gffl/PS/9/GmOvGerGCXvG1z3yy+KlC/LmF+C2F+H8+A/E3yUjCPEX/z0FqQf1k/SbKDru/+kWANPezGsXY/ugg+sFB9L0SffN+zft/OCj6lxJ9y7iibx0DlL0e/LJ89N/5i1RrpBFNgG14bUYCE+hVspTFd5pxOxAtrBuRXzXDpmSFfrYA/bVs9fmkwRr5miz10UFKarxzUEOGtkJfOxb6wrHQZ4yFnhoL/U9vD5Rhf2qycVXcOSXs8gAsyXGNvwujVRc5HcK7rmT85NMowRzJ588t/oB7v2gK2iXMFHD5dahg0bUOTlVMpyZ5vWT4A1kFKXcwkFUwkFWQyYrCnIs/a7iHnzU5ZaHwcTz8hfvAn7EP/NR4OPg5Cmead08MTJUNTLI3RmyUrTIDUcMxUelnxbrup0cekX5MhuobdIDseF5iQwkJloRzvHvbMmkGT0KGelQ+4t2bgxInicOQw0Rkk/7sc9/19vC89G+eMmgRy0oanJfyUZ8iDI610vBY+sWbhsC18eAkfRKNABdR1h8B33s8uCa99lNGb09OI72xm06NVGjYCoI2mhvtvG0jBITce4/kkp1Qp0k/003/qDKSvWqrCM5G5WQk92yrTpTGd3x3K5QcTh88knVYPg4NTqZmmEY/vWUT2qGHHRuR9Vom63VbkvCRdoo05zhL9TjHpzh8ZCbt9Uzaa+RhyFuWOoa4nebwhRzOZGc7Zjk8xWEjXYMlW14Mm3jB/6BrpbjbqXISwf9UvqduqJn+q3e+ncs/g56TrVheDOvo/1bWi+SkHtqEr7ZLxGB9Oc9JpC6V1JVZ6sqhvOOass1YJ41tU3OIRZOp/9Ny3oMqfZrou+bFRVbBLJC88UkZm6/Gx+Jcnzcq0VAxxko2UHPUpkjOaKXGthiKSq6J4PrsTBA1MV2URjeXUWlbNFfkS9jlSnoaCC3iO+bWMNYU9VwTqMfD+DYoHuB7yoC7FAPh9l6E24rwPLV3EU4N7ExaU7G+xbj4LtAOxqAdC9poF9/WB3vRZnDPBcC8KqcxmOd8+HaE77NFvj8DxtZAGd/cS0cTdMTEhAodZLDBl3QXfiu1vlKzbb5cIQxznzvpcTXQkAZ7UaKZIuovNGiWy5X2Q71FJke9hvOsEdKCuiL/wgz5lxoHZCCnmom/ijREGPn1EQlMF8l4rZIBCRxMRhF/VFX83/i1wp+XvhHkkyLy7ywgX92LfDVHvirIK9aoo1i/96uKNbrpUnxe+p4CjNXW5aDCj+nSwM3/QDnvyboF3PQZrstY8uuoasu63Oo+IYNVdCnWPUUGi3SZ1v1HBpvQJVz3Khmsqsu77msyWMww7wEeuyYdt4Wv7cTwQuoRIh81+vqZpGYDL4v4Y4tuHbDITZ5wU3yUFolFl+jBq+k+5bB74+fuPBKzdMPCCp3wV50cTJ8rZpOpc/0HqUurNfFC5V9KJazya2v+OmLn+A864l/AsTJLCS5rSmiJzvUfiZgoA3+cY5Nqtwho8oTaLXzEYLYQf52VjPJJ7WpDD9Fer00wQldrbFWP0kbSlZiAJFYDImzpuBRuIRS9/ppPit7jjvDW4FfzzWeJz0zIxZTJe6XDOif0nV48atZ1BwygxpgHsFzruIQqFfgpKRkdQoR+4ar+wNC8EA08LljzL1E8Hn5EGGbk01xxBiS4X6qUHWY3ZsNYMgaKohmg+EkMlL0oYrTAofJU8hs6uLkdTqXlDaj1k3+FZV4lEArlunXV6+TyET9wD5feKe+a7+SmuNlfe9ItPLRRJnf1dndRHNS9vDyZ/cvGNw+/WhWsXyo0SHF3/++M2JhSPbgSkGG4cfy77jwkNvrk9RG5uu+M+PgI1ONp8iZBIG+HwuTNyqHBK86bS/BUcAOOS4bXwyiYzzBden7W4PezxkUs4qPenZvn8x5m8yj5HSeOah8pFsLqZR2cWtLPkmBPjIANRIMyP4DzQKyn2GfGepy52qU8mvBTeA0xvCZVNRZ1MagQC7uq9qmkh3G6wTDAmuzui2F8e+nhx6rZEeQbihDyOHoLOKBxZ7SKC7JKMSo5MSAVTzjVUz3lVId7k64cv6oLVi7KLEOyD7QTgyqTWZVJMnmVyeEq2T0VMabO5MCGV6f6boKtrlOvEA5+4GU08QGXvBztwm6L1gv4CW5mP9zqNGgleTlNvsLVd42a7M/d1+7l348jWd89OfSTSMZgdr9LCdVfwc48GtCwgOu5c0X//AKX4+Styl+kXJS8TVJR8vYBlOQGieQdCkkNBlthlv39qbucZS9W5yQ6Oj9pMi3cPbgN+Co3g3b+Ak/W9D1oTYt29m+UfB0AirwWV2TxLcZbDfmYawGCjT5+r6agn4b6bM7Mu8m7ZMn53dbE3Ka5AU4f5Z33BngEVmwT/NT6LsDjeeWk/EL6AY83sFR9rcBrXfi/ca5nvNKVBCqlurYMWF8UkDir41/FYg5OWvGNnP6v7gTEtY2+vf24rTHcrMuYCI/pjUX8p67mwMU6ji3YGaqIPXmSU1VNwcGVHs4s/skkDXG0KKQZuIqawQib4CoxQyKqnscy4By8hqEFPBNQIdQKm1xBP5jKxj/3B59zVDrBq7KdrRlF2zXYzm2bTFVDiGkxvnPyIc4cxqJrQ3XNu/q7+TW7QJzybAcN4j+S4aTvGT+mBgbwPE337SK3MC/ZDWaEW+KOO7TIWDKkwtFGl1N42s9Q6xhoWNiZtctgBDXtCkhRn0q0TDM7lzIjbjU7rzM7/212Hr5z0SifGAZOzYDwmZxhK2DYChjWZOQb1ASzOJzv2RVGYl5IDRmZecYlYyAt0Ayb2N9xuVy1eHKIm2AyN7qpjcYg/O6uA5I5dm9QPc9Ut5lCJXd+iNz5IXJHCVUya2bPv51DOzebndeYL4vqtlIdgOq2Ut3epbrNKOVUz6h35YOIrgWxCNlAET2Q7qKQm9B8H4XvSpKh8Q6WYbQPNeGuDLUzDPcNkMDwUKkLlbpckvcy4yXp7yNJMyLJxW8uSfpfNUn6KklvnCSnCpKkcQTi1y0T7Ryl5THbDItL8+1OylTdFa3JwXIWVESqbn5Y0vO5mGdwKb4TVc+2/D5GaU89crRwWWeIB+E+gve+2QVvvkqCB9FzDHFz+pJKfuGB4Ga79pA+xzrMhlVu9xCtyoNwkQzH8Czg9vEAQzd2ZfchEA4eAis4l9vviiNEcHOp6CjsDC7LbO2zV2U3gxhwaUqyAeZWaIlVQtmjldGHNLD/QlfSp2quZrpMrV2JcyJXoHFqC63cbEO84bXfa8+IaZHmsTXPHaqfIYeKl6jTtUvyWGjiamAsbEA8EcRbByHeHkZ8LkccNGWyaQEXjs3gyPIIAViYBPvhBYnHmGUpo+U2zQkRjS+FCF+ImAIRelYahIwS0RCsVxCTkaA0KRHzA+67GeDWJA5mjkp1FzxMIwsDWjD/GBAPzzFMvS3raAUdsHCEFvcBpaUxSss8aJmnOSZ/TmhhSlZRdzXXpZRpNiOKarYzjrAaE+ZCEQLiw6SpAKRU2GUgzfTcIq94mOVIzqNg2MM2qPAcoRlaZJBbYpJG1zm7jImnz7adNxu7PDp/l/F/px5NVONafXKK50eAPy7tsqywVK4IeJC102FkmU9LMu0rlI2pQHlOK13OVW7nAx78hezfAwY3xzG4Q7Wu5VGLYIjPNIWWpijBGExyL8AlNeNfb8zYywGNeP4SX/5yJ2DxVVB2yfK1iJ5K4MBPF+EkWGJtjtUk1shPU3AcvoHVajFwzf9Pxg/5VXn0FIFocy1jMdJtgLaNdmvyg1v6Do8uPogudjWTIcJXqlpYP2IOr7KM7t38VRwkx4uIHl3kqnJJjCuvZab4MpWukO+yBYoqi2KCkChdAbHJbUFf5JMRH72TVTJF74uJHKHDchyCycWjIr9SCUtMcoffaIDAB401u+j6RXT9HF3VlvkIIlvK52dZg4qv2POoGTbAKOpcgMs9kf1UxDiWLI4jqSwBcPWphKA0ijJw0hdOYr6XrnIT4l0jNdnnuUZ03l0HhZWriY4+vbJr6xwc79pJDng8T3Hw4xhy4kxvOvVlrZzFDJdGprkeA5tURytwMcx/xzq2RdM80e0cxaC8jSCS5XoBc37DdbhcB5+QZSrIi+VdZIn/lkfZI4/5RDqA+9gVWqBZCvpdJEKYHfB3rEO8AFBWiZbRizQ+1IvN2qaOdUKA5aanMGFDcG8yi/lEkBOVdfAc2uIaFTpEPqe2t7h5PQo7EMFm/j1JiJkfksMMddTKTS1ztAx0XdDldsqnBQtSCi93fgfibFPQFUlrpgIXMOEX+Kl1ozxFkGrSMhpfpmltfBbA2fzxlH3oU9M8ddhKE5KCDYxlyiQyFdLJpXWPQccB0vnKESblHch86Db3jzoTII7EpwiwwLlQsr66/nMkQ6ilfkg5iPhbKD1LgwyRTgmT3lrkNuSkcSCM94tIlAgbFpImQudOuBV+wgEW9jPV3Qq5fo9lygt9dhw5zkZ+LgRb9GZPlG5CQKSEi2pZldxBT9QjunRgWIhVIX6H8aHyG1l3QE5+u4kV4LYuOEZkhSWngZ82lWRsuPJpxg15mzJ0ywNjJ9DlMlJ6G18SbZ+G72BfJ3Ug6kwljaMJKFNNXk5ggKA4w+NFsT4kvy5OXtgkIEqcSNwAm/hXjTHFW66j/HIPKAvXOeDl/wIOAijwI/HmyEEJCvwI3wyucVCB8joaWcG5gXsDjIU8okgOZt1dYoc5drbE1ji2KjGc5SLE9E6yRYl+EtG2RD+LaEOiP+vljyBRdSYfUE0Z4z/wjWnM2E8kUh9N524VUg4arGh/EmcmOHEsFoJIFfFhlvFRXvPlrm5R0avLSx5OIgNC7Bw/ZHOAKtTXpQRU8WJTUt8doMjx/BfZpiZ5D/DV3n+Ayxu2dRTV9OGImv6RepamoKb/TQ+FshT5ovLH0TnRww9/TPFrxpQ2s6MvhGMvv/WU/FhH9rqop7wpFO9FAvHJ9LDxCdjLMnKQTDQGm686Vcm2lmWsWBWMOUMc8MIF9S3q7Pp6NhioJt9SRWg5ks8OqXyeOHgiYyvoP9a7F4a/JKhwUFCWimzi+O8qJip89RootXr08t5H/Hsjlnv41rh6+Na4Ioa47HvW5DAhGf7JjEah5sHXqLYJf6WIyeoFfks8dGUWj8Y9V4FAPZDVB/zHJV7p4zYZT0xS5eTtN6mrFq1Qkv5d+QTMU1mDzMATqH01A8rpSje98qROiev1xGXKthic/eHUc2Fn1nXr7q4s8sVFg2KJeCWHE9KE4X5hnAfaTzTSDYY6o3XK8NUi2bjzFYymkt9Rq2S2jpXQyrkcw7DWTra5zVLy+dxS9EG5xTs7qyDtdLlXXFijQN3tYlFAat2VWJHJJTb48kq9tLLUR8aG/F7dT35XxnUlK5xllbJcNQhzm5Jb1lwtdbUwvu8qsodRF90YsQ1mhYysklyWCGoS7reS3IKpAH8feVxcgwRYVH4POOgtpHdnyN11agHiD0PEw4mwl8oaUxQy51bB7uqShsrqzAWSotNAgAHO8UUFtccWpELBsxW0uhdXEDyCLsgfBqp3i5Ke+61kpj6Imyo63uQ6I4OVXcyI4L2Y/f4bnBeGQ4QEMXZ0DF/ism+aBxmyNQrSbX/3iJ6X/D4QhQzKivgfII0oVrOfRWKwS2LwvQencX9Wn1OjH5xiuV2kMP3zP7npfxjtNkd9iDck6Sgcewp3lUthPdfqaxTmqzVRCPk2ND/ifGTwyPgoH0YVc6CuxCGwh8ljCAZDo5ga5e9YB7hQoOaNwfemB9678+E7Ru7dOaDGp8bUeK/vT2CvMlqJQeqfSqcXBxsyZCnoIyNEXnQC/lW0wWqfohMXq7u4Popf7Sp9WCyhTmOQvBVgmx1xEG6k4eNtWfvTfXRNF4BXGipj6+LqHxx5hQlpgsn4kKw7NQJitiQ9YXyGsgmLurDwbVNt65lyZRkeJmWxa9ooI1ywEf0Ejx7YcUCaLedE2Si/6oBKxESVQZe+bldtQNX8xPvTGuXpzfINJX51q2wG2VurFUsnbgDBgoZFUdv2gKQuVYIH9dwEhhAoEguOGJj6DlfMbD4Bb8wMKQMSk1FIRBNMtLFBGuLjW+TDnVFNXpc4Eqy7yQ6X4BhxJKAy1gFmANDNdqBTjL7py+U4Pn5hp6KoZwPVlJytPsSwBGN+TaN/aLUucrN1T6XUkJ2dfHfqPz71LsrhTdZFyXtyvL4H5FN1L8hwn//PBrIYJayr1wQlTEQkRLB1yjWoIWC2kDcH+cG4/IaoSp7lWtCwbrnGaTuHTLyf2Da1brctYcMQrWYUxYh8Jn8UbkZpL4/S7gvt4wivHkx4dFdUB2NJxpTBQ2MCS1WbUxEWrgn9dk7yIs0LNc9THs3nPLpdm5+/PWfV5R3uYC4Dt6jN6SbqcG/8Us5qNruQYTSMi5vjyDMexqxOPfjWlCFc4vmozvY48HQcqghSXRECjLV66q0rhMpg/qSk8ZU0c5EmqcoBGEBVHdtl/NqauFrraW0fmo6e1vS1pq81fRkuto4Nprbh6sOtJFi6oNUAbkpbbZg2cORyVXw0mCMqR6CElnrSUo9rgFFZDZo7jRQYh2iDsv/b+k9eCC+vGx4I6NngxKZHC/K5+SRFj3XMCcaZakC9BrwGnGMgnKmBUkN18Kuj8RBUG+qAaiG2ljMMaHKxjKhL9cZT6rBk9qzBATdYhnGAO4Z6cTa3DFIHnS7lggppER0vq6CWVFDLuaA6eb+LwuKQaYSggLfiWqI6pCXILyqggzZK3GyVA7DFS/0L62GtHI9pUKore3qQIBv+fRVJOCwGpxEqivJyOScAyeiAzcU5wjA01aJWLtHGaaSohZr7SZRpFefDwSMwcDFZJjPHphSyTGL+ZdJK6gKT5G6cMFXUpQGaR/wjW0d/9mcveIh0ou1y7wOKcLvttmsNamEqRkh+dOso7l0cX7Fx9JxLn/7gbfHW1eL0iqobOpZwylWKP4YaCnz8hl2Wz36spWkEjqayR8ohmgFgFScgUo+qnHBn9OyZuqCdpUFTtgUztMyPdQ7O1Ivxynz/5g6fJ3FBnzh+SuJlNFDr9e0CFzyDOKvW7dspOiQ7T0urDHL1Xp8c9vWTvT7PWcmclOx6t99lkCxHIehmAkELL0S4r2IGtSegqjQ0AWn4NIN2FjGKfFrsia+cDk+7mi0X1qYg9ZAmXYqQoJJEaVIHe0kGO2rFJCuQQS3Kp6VOxTCbivll1NIBXtEQCL75JsgtFTS5oolGdmt0jwQKMQpZtdhAG55tq+p3Xjl/DjSt8tpBHbm1qv0sXdcdKumw+DDrnlrZAp8PgnNiOpsaW7ZFZ9E5W/Ys1NwCUz0wdetZtlELY1rKDskyUYNnaAALnm3VQONYvC/YLQDijZBuG5yggHY5kLXccQFyWzj0rWS2hD5BhbGIMw6Ajo8yHQ3Knk5QLJNIelIlXaMFDBWPpmT6kYi8JCInWCpneDHq0vIFxcsSZUrSCjW36ayjT//4VQ/e3pqKRUMXf/KNZnaJN4OG/6b4dFJ+6s+/oXTdrMQD/ivfUNm9qLZSUEjoThuvTOSjq3IfsBDgygkbEYP7xLGSDhGq5Hc924paZifw/ALAVThJUR/OLUOo2ciH3hMtVb9784j/r4aqJJt6n0vxK5zPaV/e9G/xkdF2UrHhan0XIXaBK0ONxy9rdULjXBbLlni+gLcH3bjfnUclQkk8CHtIdHysh+Ra33ox6srpqBSTxOs5H0dx+d0wobomEu5iWsjhpMfCch5x5FhHbPJV2eBX5XC533NeajDdvPxMl6dnumCL5knvZi+Wd/uPhl28aTTUptHk5ehfDRt8OXwvh3Mc/ql8J8I4wE42jWCBoRGebiHrULpqTaBpuyxr1rLgh8arOKaP3xcahnL4XPN/7H1XeBvZsWajCaAhkZrhXHHnjk2N+J8WQVIEKQAESDBJIqQRKVqedba1nmDZN0N0GN2cZmZz3rUpatPL5pxzzjnv++a8b5uf7ujzrb+qmt2EQDnbN0kf0d2nT59Q9Z86darqdH9OTcyZ57ec1ti4mSDsUCt3zfyPGlEWY4Y2LrOM2Qe+ElR1OTyDhGmjd4b61874hTNfAddoH9Nw9cgsAe54iqnDx2a0tgZN8mfiIFMzQcg8hxfV+RFw0Wz1hykAceVKgy55TMCzHglQJ7yqLOTVdA4XDw5oCBGOp/M8zKYLmFUC8KpLLl7uE9F6fcFotCDJSqV0cUA7VWhgltUvoU47zLIcZBxeQZ1YUTjeDc14Z/g/6nn4QUyDYqtwb046/kxciuReUwyHNTncOpchtUljJU8aiNEcyLPkZQvzaOLyQFu/OMAClg60fQz8kCclK3nF2FB9UvO1EA9OhqqN5660hPxJyJ8md1CP6fF+iPX5yJ+PBgw9W1eelYo8E1Gora56mGsLNdKszVe3lW3U2VuanwQJ4scXIqg57qDQPHqgVyD/Rzun9dapzuk4a1/C9mmvGmgPEP8Ztt1eoIumRSSQXB0JgCiFNlroaFBE1xtM6nXBl7NqQknJkaBmhBBYS5K/SbqiVFeAt3kdy3UbVd626jtKw0Rb0GELOtqCcRXHX8y8d6usKKc5p6s1APKnio13axVrzE5/3Cqa7GOTlaxaeFGIJioKM+1L53SkVZRn5QxpOtpPA08HMYtjgNxXjpwOIj7cLD0VPGMOng4lzg98hdDJGvf1xw2RfDp0WtrgFtHeI3AERkXwaMdH4MfIQQgV4EM0PQ1CvQw/LTaj9Q3ET2z4iTP8nI6hsrOuKK0wfyyTINI00CY1d4B4cF9N/ZOnwoyytyOP0JXxFUEsTfhgwv4+BWBKUOVXW1X/ms8r/rHKmvo42GmHXVlrAJJjYh4GDBfO5Y96jsp7LmcUL2A72rzTLsKlq9V3Fd/trPpSqDnb2lZTqBTwAlSK9eciJ1EiKllqGV5qRbx085Z02ZLuNxAxtuT3ksezOW/J1xpAXVaf9/ql70fEqHxcQB0XMTP5N90pwzk6zI0z2yTmBC1/9iisWSmTf4t5XFu7Sx2lxGxTyrcoV1MgwaArWJPfdSVMbRhdwiSsoEJwYf3xfy1JEOhokNUIsliPRZDJXUD9eFh7eDQCZ+SxNTJhc9lIpEz48J99RMr8zcMUTAX0sHB0SHKShCIV/uyjsMHUF+zmrNzatA5Shcp0gGXO/lcwj+S02V8psIVV+d3GpvxexYb8XkP98Zn4QrhuYrTkr0QeIwRWDEhGr0qBXjXUlFpbQi1s4xpWKPtZwPXi3+P/orScYBeLf5KeruMq1nGd95mLv053KWyiLI8X/xiltuIMyVVGDkBVGXNOxIiND1jFBqI/Y6rg0TGVN42KF0hiZVWizErNGM5lW2Wi/LMHsr8A2V+ArEy2Yz+bEPsLiP0FIasgbAgE/zbhJeC9lIVN5+t79W0Wov8uiS5DzYMWCTo3Z1wDhwXl0b/AknpjNG70MH6QRsKSmFdipGkc2zsamEDvvt4fgDon+yVWMreFgMVI2v0w33+ThwU0iLQ5NBg/t4geQ/6W0OPVjGv6NBuEmIcdgsb+81J2+uxR8eX5VMqVFxr0GS6igeQ90yz69rQaFITfM7Y21liZz4UOFjCHqtQmBzEYsn75lTuzoD2pldso0i74mI8TNVNIHQ3Jq3nSupooKrzx3rSpF201DgkqBYE4K8eJsG5NfkHFRkIrZoKOa776DA3Vs8WEKscI2jpMYw7vTOkmcAVpYMCcXaHqJzkSCUP/zj1NPWmktafJvg3m4U4aeaKsnyFRskETrG8XQo26sdG6KbQOdTOdhaoc/1VVei33u2PGnQbU+vYWrc1y+H4qq6y0eZviQ5P0Q21VwldIidpxx9c8nDpGY/BlFNGPQ4z2yGLQpYZOC9+fiq2Zv0uOXCp2wbfcKoGnlcBj0lXE5Jh+6cHHqQSYswktDi3jb0dZ09X1ZA6BWU2tS3ksvOastliJJsYeiwQI61LLOupoGqGdiWHFiRg7EROM8YsDXJObSC9PaogF7BEkdl5kNgvRtUjVexp7TxM2BnwBepUd6LKPK4qMJiHRNEjYJzVQ45ATktnA57rYF9NtITST+Dza/GNsDlN84Rf76otyzbL6jSRbZCdq6Kk4FWcFeAakC46zECkIDWg77kPp6ejWOSRbNq0RAVU3jlSwdDykNSFRWaPXbmOdVSdOgBWyNq4ZevYUc9HoKivUQpHF0qJ8LDZt9gV0BuroG40qcnwnIq6M/R2y35m9LZTbJu1YVy1ntiKuGmJhSqIMTpgdsbK2MoKvscwUIfbvCPhI9i0aTcaxbGHFREEdx9XQlpMVRGVgPA/w9VCXNstpK/v3baVu3KgaN2rGje5Jycsa28rZn+B4U+C3paifyHFAvj6Vd5LJoDTMOwrU2gne1Z/kXe0E72pQXSQvslharSBHXW+A6g1N5V0Ek9qxmYwohoxTwrUVIfNP5EJWrn5ErxCdYA5vbqFSIHs8RPNM/PIQeeyp05wDzuxJTIAl9JjQw8TLvHKfCiPQSw9CS/05F2m/fLdkRofekOh41o3csxA0qZy2bw25HiKfqtD24WkmBBVQDVRVOVADbJMigzKcgHoiL90IrFdOxCUTY1Z6nxaEAtuivpfAwGVNpmeG/OCfZIkGDG2ZM722jS7/JIMkN/hW9ZCghybIxfuqf2KOutvMQIW0s2DEfsk/YRR3Uuf67hxmqF6hZyBRm4s50qTLJ9wgJY2rVkaYLkJLjor6JrM0Mytk27c20P4ovkFnBlqDrzc/Wl8FP1qn8qPzVH70nsKPzkl+9MiP2SF+fHHo36n86GFW+dF5kh9vfY38uIh3SW5TYCvubUy73IyT2GaIGcnuEdBBp77fYGbjxvE6BM3Hz4X1UcsIjLEb7HrDe95+/BxWZLH150v9+PEfLWmPy97jpy0ASIrYNP+GkqIrOmufk7Xyt//2W+LElkvpGRqUSTGaGpowhlipbhvochUFtRO2cyo1QgzKh7Z6VdP+Z9Ib6B9oEV1bYlCpC1oCz+iOFazt4YZGOe6/kd50vL5TYsqvKdmdz4vrksefyGXrzjjaOPO+QNw8sx8axNd9VYBuoiJFvmEaehvVfVRFQNsIeVD0MLg9lkygk1Zy2pa5AQjfPD7FgGwa6XTAOKidAuunggbdB+ElhUm4hRrfbHFJY+PCZTlUfiBcIQ/Dti6HwrI0ZncsW1vsYpnNfon3urIufyA6QlkBU+WR+mOZAzwkJxfqVeIHXfndGo2ifPFeUU4mgiKZwgVF2BaAPIknm0NOx1O+knwhzB4v78fcoh1bJdTcDkh9W13k6PGVo0gCL4FztDBfxdRd7PYvCPRmObpmuW7y6N9FoxMiLFLHJ8OkoGRXblbDkqu+JT4ywR+JD2VruGUQi9qsOWrgfJzNCfPSSPPB8yVX4qC36mrpjFTHs0nMq5ZFPjXk0R7rR8MxautD3i2jNzDdoWnqTN3UmY6pMy33dDUpJk+sdiBymO6yXPvwgSLiTVAvLOXJ26WwlelvWZPlmTRxJW7L1g/piukHZB/1tjzDOoq3BKjGAQxSdlx1uirZUs1kW2OvqBfM6BUHjdZtwnMOMVvt7U3Y0LKHAKgs8stJrScY39PYPoCMLkPIusowXxaSq+aRLH+NnHz75ysn3/7mcnJymJP8zj1LLx0zMHJ2sXjlWEO5omw4cNbNkBMZu1ojP366EtYpHvhU2uEzPWPpjK18myMeWQ8ryuHOCA43ncNV43D3xEIwRidUUFfdfJ2zgfNXFZQoZ27DjHnKXCTKtC1fOwmPUFNmI0tayWcKs4vykBT2idQFd9ws3ySfBF3GtTmvRvhuDPBFdINEbxQ0+kUsDdJFl5WaxJlE5KJH1qRdoYNNZl0xiq4dk6Tr3VNSoH0iBkY1H+wehKbpNlVbldXNf+qhgGigjorT1O1Jiq9qSBBC5NytFKN6dPd6gBzV81gzlUw3lQ5NqiEu6BfueUVXiaPtJ405V6TzskDRzvfflF5nqquGw6tePIZahsMGWxCwoHPWdGiMQ56s5SE6vOTOU4/faZkjWRplYBvTDJOaiybTA2jF3Hwt+hJqAwvBvcxFb6NoOAsrFp3P5qxI9Um+OJeuGWetKV0ThlQpWrIkQ5eWTovKVetU91hvrsu5KcsVRA7qyDXlB5meQxSfHrHlkByhKnMxqs972Vn4VilXeZQtdRZQd+iqUETXF/ekXonrTRnnJJ7bVVviEA+zWJCTimTn0w3IoatUDT0e6MEgocOc25ak4uNVM2mS5KRNVygOlbxVkpcErucE5s1xdaJbkIkbvKI8hmdMrSd/Kpacf6vsV/+qKlf/qpwJSrVs5dYpSt0XBiof/WNNj1+Vyj4qoOFPzJ8xl9+sVx7/fOzLfkxlgR9z6KF3gCrB08rBc4UwZxt+V6wssovP82LSIFKlxGS1MwRIFU0DCM+HuJYmyjdOIyc52HQemqhpMbGVmeeqPiuTfxFaKnPV6bRga0NOgVRoW8awijEsMYbVLcTA2MbZLSZ3hxmVkFExVojuk4xy2+ffivZy1vwHsuZ/HbOGV/8hu/pbsTOqyMShOU45jpi8avEHxrrTuZYJIbYlztpSt22eydBYv5Sx6+1EONSCXfyvqlzAL/4DLyZ54cjysa5vimmxJT0yss5VdWyMrJORiTIytlkgY1/rmJHIzjLmZlKz6q9nNOY2pAMqzXnUhSwti74FC3WbMFxhcDEaDyz1FvpSBnZsOSZiUddhqZkRQk9vcMPs7gCeNss0k8wHWdqey+p5ARd7HbuobWaiVhgwjlhErYJWQdZyhZ+5fAmAPbSygBkVKHOUBVzDLmlRYZ6HybBsoUvsXh0RCTsXahT7y1gStQNzA8wfYJ7cI1lmGBFoTyZaDqEzSg/JMLhi8LOTf+UnlBwJbEZAS5t14JpGzb9I2bBdOzYboKYSKNcD41zNW3H7Rq7qcTw8CciaXIWaf2rRQpJ88FWOlUsW6FKkK5QbGl4dltBBXUqp65QT6oid4moOzOfQGjlTxTLmSb0ZtLCUdTBx+vHHZ8XqEA3iJwlqVmmzRrsQQOwnmeI01NxsnnQl17uUxekV1J8ZZpjBHO/MwRItympUYyN7NhbXL2JvdPlLNjpr64iGatjWLHoq/dN42nBrjdcpQC0xixyHi2iR8C1wZPi8yaFQ+oWhcNpQeDv+UkNh8ufsUGDvf1YMBTb0ax0KsQ2FyIYCod5QqA8PhYbR1YdKBmElOkNROwPrYHKAxHpTR0dqbqke1WGdXUQy6WbYrxn2k68S+/SoJ+R74yT2USeNjGyjlv8rGms+DPciSP3JeBjSuS2gmDvzunVDgi57WQtd1IYgnRikE1K4xrKtlUbBWtYFp2CUTeneyCfJ4yEAvqndm+XaSBGWyurQ8uD4k7CkICBiYiImmTb2DgPVYKrec2MzgWoNO7VVx2HX5qPxABBSpmGYs6Uzm7Sr5tl0mWSKd6gH7eLmG6n5F00bIvZ0f3+Ux4v8q1Ia+86RHVWVPNaB20QUxQZZqQ5R/pUHlsJlq0YanNymlNb7M5C//Wn6IjqI1Y1YRawu4LYtdT1uPe1q9/VZMTyd8eUlfTj2NhHXamnioC+47b5gzYqEz+a+xNMsFz9xwnJB32zXR3Pu5JVDGzVFnPYtjYqeR6Oeux7VQCPXcarH38D1sb56J5r8O/pGiBt3zpWEZwFnPd9Ney9LrD4DvsQrNUcvbvoWIds/duXPppuPbD9quoa1bB/pmsU6p+k7pbBn7HvJGhT6ZICMrN8QD2iSx7drQbIbMauJcMPe8b6vtPeGDLWJA5oVzH6A533RRUsRekRKS9GwRL5Kyppx56jEV1evooyelj35d9nVsGEICrP2VLpkDUvbx3p3g2BKqyIq451+ZGa9mRwwaayQScw1NyOuORrxeoPsDRk1VNT51n2fm4PMUcNVjZiFwHB2M/fQZFk3R4y5qsy5LlEWXHljhn/70wMZuWaIiB4/96TfwRwFAjd1XxFE0Ni5Hr0fdHkxgo6OC1/hJybVaDhRUCe4qivE7cd/uaSHv1h6/KdLYmebHvOwDzmN89NSfqpcGLW2s0UmKnTBMPhOsmJdfj4nl3JR4kXpc48vlHgV8yqWq5hXY7wak6uxgq+Enhe6TCbelg4X/9yP4vEPHkdxujslf6FUx9xz5O790EGPfq3EKGR+uRrLM/kvpyRUDW3KE9TdOFk9jkOqAOqHoWWa+BMp4qY2C5N5ywYzie4S28LiGpmDpps7Qmm+oW1KLujp4kW/kgc5OfPYnm5oQ+4W7SySas41lUo+rxWsyVOcr1wSmrMncQtee5RNOKxwQC3qrOVK5PhQdStmyEbNzdvMmlaGNarhNrDQisszj5zQNmVr5ClVMnmoQrpPEjU4Rag79X0+ITgRKmaBZG9M5zYmVnQWUEIQ+jaRs4luHVrMraandz3KOh3RGYw479bpESAqiX2Oq5hLu+J7RHiPkZYeUbTgYotbLOcNibM6+sOyjV5b4bOhuKSSyc0A867qXDY1zRYfpIrdtdjCJjswh0h05wFxRbNSc1wF2tdRlqm85BafUDUxKjdCY4Rs62gru1geFCRb2voyBFuLgq2TC7bGU0Ra52eRSJOavt5SrYUOpdpJcdY5XZw1iuKMv8MSbfbLl2gdYr0zJNE6zNnCkpWuQKjrYsBlW/0U2VYPXcjdr0G2oY7OHpq3HoRGQcx1Tx/r7W+AmKMYV0dEE5WiI6L9ZUu/ukm/jko/9ulY+lWVTDXtVtV2K+TSr3ZC+tXQMlJ0nxCEIppCgvaxMKx9aWE4LArDihGWq+pCH+W6KCQNxE4kfz+dycpqbhkNdW0rr12kmTS1uSrCZSloUUpZsPgKdXBRiUXNdbs1VCzqvfZfty/ajodVABtYO3qUKbDw11kcHqUANOdr03zL6rDf0ODtgC6KdVvkm3S2JR7mmTSvAj7zDC7JQNJl0BVZzSC8oabyX0OtV/oSbEH+Eq4chNsqRRlcSs087Mc7fESKxW21R16iGP03Jb62w1XVxVvHpKHCHEkpfOSH0gUqqlek2Np9adABFu6nyxSfuxLLg8u4QljIoJcbPAsDWZkVQnA2H6Wr9iIQlvbGdLqhMZVX6PxqYsHf4xnmkWLvzz4MqZQYaIpmL6Q8tRj1sEopzbUaxriSCEu4rMaCfbRE8TVgpnwrSQqkWIJcdckoPMx3jigJSG3dCLKCTogwbzLAYeVAygOu5uVqAfMq/xZ0/wv1sUIY2ub66PcioGbLtsto4ZLJwmA+78SsKgq2RMrbDEAVUZpYJ2xbZ6q+Fd9bc5huSj/CmvegvGvA5UW+12edEaunhBBRHDa9o+vYwjauSod/yheKue7xFUSiNQlBNDVyqFKMHFK/8AZWEf1Z7jYpjIArjvrs+wJ1SJqShh1g87Xx1+RtQvIH2Utz73reNlbTsInLwo+yAT2D2xRfM/RMYNkIYvzdDTHmQvQ0/u5IlmXsjogv3HwySOy2D1T0aHuY5WEWHR462fJ4UVsl2NzHpdBm825zVDFiM9Sxjzb6AhJTtN4jTLyD27hJ40d4L/bDAm6Hl6X2l/sl/t2ZDj17c6HUs487BMjcIGj47+fj9BdT3L7Phu+RDF+57I8N5P24tFPo9gd+nkBDzLtcBw4H2uB96PYTt2/I0y0ViTzbVhspz95Lmie+7bqFio01n8+0uOJEGrkpLPEJ1bg3YloFyYQE3LvgsQHOUDStVDbxbMR4CVgwQ2c3RFk0J/snWelJF9LP4r1khJBjgi9Isc4spE1OOvdu/J5zxb+wPjJIZVumIj61ZJQakWc7XMV2WDkOoOja7FGjgY4DWZXhIQqlWxpFEq5JfjfuUuPVHTELqGvHDwxvbipP17GeT/2o6wqg4OxFhSSrjOMqtiQT24RrPNnWwtQ2lECqcechH2zoOoGPXGXRT5BE416UmOhMh/djFnfUzvoBvAeCtg9iBiuq7/4XtgvNPyvjlDHuj/+7yYz39T83CDflIAzeE5Is4X3hsk/8H7SQ/Ssq1TZ0Frh3zl88TrPO33orfMgOH7bDpjMiSm+RopdwSyCdRgLqMIP30bv+ESmKOe6my/peplVlPK6Yf6JHU53J+GU2SInNdOyFBKsB5BVLiPhwtn/+tbQyHcBAZchJz8Hq2gV31HMv/cwJp/ui7MwMQI3awkfzcRVzXF2yLQd9allhnzOzjPofp9CSExnUcwbRbjrr423dQuQaiCgJ5pkkiookqWRh35o6QBVkHM7ZUA4JDYLHkW1Vsv6B1FOljStD4pmC3Toxp37sA7XydJt1LnPlmpUZis1biQ7m2b6u2eBnTThuAEfhY0KCgN1peXLZ+5H0d3JvvtTKAnMresxLbRMtsHpGrEkyLyw5zpJ5J7EirPH/tdhytQ6HDgmICp3xrnNLYswbOkd1yH+/JRdz920hwhdbdoYjg1VJNlXmY4+GHklZTHr3EMu2IPolCvSPP9Lsh+HDENjIitYxvunAt9C2Di7t6mHODhU5cNAwRSPQ99OYN+RcO0Jcm2HgR1TntT00AexKOWxw4GigikW7IJ7mA/0fkZNsr81dNmNHdhI/8bDVa4EdsJfYcTPphp0ehjUrNERZLAxr84yeiw9oRmbIY26osq8h5mhjEyw1yYoZ1zvpZtY0JLx8JSv64WFWuBatAqR/BN7nGe9vPpTTnf6jkFpWuQ0/vvJQi/1ff/vosJBvVTfD4pC3N7Bx+PDQ31K3acfwSvayjzGqWAIX6vqbFBOWgVpNupF9MaEEIAU00yvMdKQ9eXTIbNh4JDl/x29/19+EHV6ftuvrsMNr0w9T6C5d6IEZYFizgwASnMkN2KOaEjbGh9C14R16Nf+qw8csCR+2su0gdb32KH0dH8Ldh+knjlRLn+zfY/5VfAwf9zq+oG92PNL0m+jxpYn3yOBl3BOQUviL3hsq6IcaeqGqJKuJ5K6ET6Ka7pBEulrrmlhtKMuJQR5W8UkKtQpiLQgRDyJB6aqoYcdm1VViscEB2yWO7plr1Czon5KTT91RB0sNl6Et6/Fqlw1hWD7Hz4y+HS3s8nU5SbF6Oowkr0Xqxr6UTKkvV+S+4Zb1W6XKWrz+CDLiP4G7Sl87cOWXblBIf2f6HTJpvXAwgAqDo/Tj+CiYNJUlPSTr/8bhzX/+z/6ZvGlzzUrhgaXwmizigexPPyont28QVb9rh+xOjc2r1HxNB4lNtnt4/Y6avrD7MlXay4hZI5btyAlvFfInsFodzxbRMyf2gq8ivUfgywkx+tuvHSE9TF95jexnhZpBjiSsbjN7yWcorj+9FcFaEbwVH0EgaiJvih4fQoscmjlvIegqqF+B/Ind8Dv744P0u/bDd+M7ZQYN81L46Enzik2a8xZhfupsOfctmy3nSKS5odnyFr4L381pMhCGAcv4zqHZ8k/FX6/Zcmn0ZOlSg7SzzTN2bVWrXk8rBBGhWV7SmQiX3kfGxqrWYQ3yJ5BaGz/eIhKkMDiiiphzeMmB7C/pJY+BpAqYUbJkTdBlDND5s7KCl8pfk/8cSGM/kI0tvYyzS7xqQ8dylbNkmbW/cJSCkpnqLj6htyfyAQodiUd0L+qPZntt2idxGaFHLoxtLZ6K1BXxmCI9EvPPKyZK/R3OmPFg6eIGVj/LRqpdUhEFXsddXMbJgfHQzCVCI/d7Hk3+jt/IzzGsHgZwLv2zMpn9ep0tsnkIduDsgo0jrOqM7axwXTb/aKN08LPf9st1EtQT6WkKvCL/ISx6ZRwisGTMP1IyXcjIRAJysvHtudLVj6Dfj58Y1Xf5uGRC/+jmd3/3H7jOyXJNR/o9Fe3+PPqElvcl5bQGRQjwSSLhk8SEb2Nm0SFRMoWKTxAmnRPWKMjTXr0iczkVGXwKu8Ro37p/z7q/Sz8IF2rD1AYbVxrRkCH6FWLZ4S88tlkWAH+E8KTfFzgIPoAlwi+N8KH1eAIRPrwe16gHrcflzLJwmaVfxk0ebmKPhz15TD3H71eBscCKF/AyqfAy7lBu3HETxEmvuyW9yFH6YvbZrfOaSHUryT768I/isYq+RZZAtRe6lnX+qAhGebDwLlqo/JsuZg+o8byFsoZDcb2aqEGcJZQPbhUj9vmYZa+hqg9I9sm/Rxtqegb0mxMIjFthuWcKH1p9VVjAL7Tzw6NflMCRs+QJmxjK/DyYvEiO2wBQ/oy9t4Z4POMPxjoAwxlO7SeLjLwE3uHT2mUrIlQMh2cos8+sq0m1ksXRZn0zElpUGsrHvrc3xpdtD+sLI2JVbjz+EB3tolws2I7bN8b//1i5qm/pLf+40b2cjhnZypk1IfuP2DyMVVtYaBvZj4ruEhgTmYsSqtR0KgrmQqaxbNmSfZGiEEWMMT5/rmSS5wwv7fSsBCy64YBnLFvQptSVe6XjFEiF05Isz9Z4OGvBR7oqSRQ/OIszD1E2+iUDWfOctSz303EzybEoDtzTnHITqGCcVmXJJjwRA945nJXfZ1ATp9yz/lmnCHzL8rOYoDfrp0aYLidGmy4nCv4s4ele3nC2kQRFeUBCsKEVQoScIThwVi2Z+fuNcg/VW1YgS5IBxHLKZJMiZfzD/sUUfR8yIazfOJLtFKwGsZx8JtD/kYWn5J9tYRoftCCiAe961Mr4Hy6VSzaGf9KGm5SVZ08jPpCyATYoGNfGyqiFKViYUggnqtAUPeJThiXGdJmQ5WjXBCnmfVladTwjQplGvMNDramoRZbHd6T/bFV0HDEeFd+sW9IX1D6rp/6KTb/ypfj4P516buqt0pvPcOz8+Bnpdcw/fft1Vc44nuRai43SMf5Q4vASvKh8JlUZpB4LueDaljcvsEkqDKZ4dkabxbOzPJvgo+NCcl5M8mKCH3eaoBvk3CB9BmMcv8/imfvpJMH6nH6Xt//2m3iWe8XP+27sdOo+pqiE8YsA8mL26T/OB7vp82Tm1B9/M/32P5i+cJ+fT72BX/MHZc9zeDfGiq/Ultr/RymdxnnffJ5ewPMH6Yu6t5vyPVanajqDc5YUgIv8sMYBP7wcMA05pHhRdCVMW9ZLkAdnHdv1gn9m4s8+Sud8fTihDpp5GXYLch5z2/PzPCzigunaE/TaLEmiHJaZZT9c4VN3QhPnMldOi8R7wbZWvclwspihXmFFJTCTOyRD98+GVcxJVWu4ICO8J4VO7od1dMKGvkLGtaA5VD027Mgjwjax6ZoRT7Eqas/WO6V0233EHCjhqmNuA9sceeO6PRnj2DbT+zWRvNcxHWyJ+DynoxWr7hquk6LnCcHhmlZe57GNTanN34qQ9sVldaNvr6NfV6k+ReqzJe8SEN1BhBfkuG8wwLsfcOZDX7jpL+5apO07QspnzsvJ+TvTnOpv7vOcf1LJeXnkefQJrppMqftvqDCRLOdR0YsbQsaXRrh+bmE5nFexeQs9iRNIdz0YwVyt6R5e8jfA7XFhoNI03Xs8Y+9mxW4WxSBJpeOkOEuKj5PGsqSx9dw564EGt0ZL5Fs4T4l8ngJ0OUxJ/5bVC3MGi+gfYMpwLfI273tZRjKTYkmYuh/Og8GTUweZqI6MZTd0WSLq3NCWxLK2Cb+IbTpPALJq8QDxxg6uEz3XMa7z5bYYVXAFHVzdlfUhX9NHiKfxg3ANV+knUjOhQMpwJWnjhqubyv+LI3B1E1NfFa6uG64Mr3gRUwNW9JWhKxBb13CRByI8Moid3+e5/LG+ayMhxiw/VyB2fRhi178ExK5nELv+dYFYXxxB/uVbh9nV0KEGQkQRXwRVU/IQfY4e+moFCLdBhfpZw9iUevRL4SaP8jqJq8SGtG4a13HBPeGh4vLvGgupWKtv4yKtB/2s6WFLMpy7dexMnjC/yZYwele/LdByt97uaN9pK1AbaylJz5lv/NIJ3/jWab7xceogrPa8+8JpMzwvz2+FTVI5PZ/7wm9Iu/vQc9zg+nsLmzI0vH8Tz1TiUqnELWhAjAklEd2/uPF0d7IQPut27jLeU5TfGoHyXYhBBktOkD3B+gLWsPsUH/ruaEzuFgi4RH0VS0rAnRM+dEJsHnNP+tAnTmhZspyl7DqvSRi3xJlQoYpMdecZ9YlPWgeNr89JIfUQPY2v3xZiLWQSz6l7/xLiU5mqLpJnpXitl2h+VkQiMX1T4PjT5F0FdBxH0t7uoZVmVjuSpUSJ7LhmLpzjCyfv/E84sf0zM/9+WvmeFQbFssPkd8zk+Gc+ZmZmZmbGcFJf1fROr3Ydwzs+w/ZMQ3V1dVFXz0yHsmKUxlhXtqiL8cnErXOBEtnxm3aftOZ7vYOu5InUhT4PsXnH3HuCZoCvnArX46zdui1Rb/wbxtjl4fPfjR4+KWe940jFN9/icl/h5b6ln/scLxdnWWruv3i5b3UHw0M260OccR7fMyQ+18p3ylq8f/A8C0F9tKltjja17mhTI+e2NsBfdp3r8tQhPKq8Oa3yZB6s84wNfgS4YcBvB2At0FJc4+z1/FmC2P00ff+emj7ImMGmLW0qR8DxBWq3+rUfb7S64UpIEDnXvkCuTT61tPiPveI/Hy7e4BX/9nDxb3jFZ/jFhENoHVKPqHHSZbo9S95nUMnonxBqybijgA2OAj6mWehoVsvNps3fyS14Tq2D/6TQhMNsiNaPsTU38FXDDY+x4IZ3CTcoae/ymWqbXTFQLBv8Ct8wwxU+4Vf4zIgK7/ErfGCgQtVSAUYZjmd+g5mXhReqB5AkCuU1CY+8troQ1NsEmgnr/o9ZwdDa606/138ZgdYtfoXH+BUU7jYP7rsbKbzQa3XpUKOPeNL1nqbRBtdomJlkue0VnzEE89gG5O3bncAeOZTpC+zvr5SFzGPXfJibW15xuIKbZ/csyu/dfy3wvj01/TNt6omQsEDNNxZtAgCDQaMA3BJ46Ms2YMDJ38PaBYOi9lOFffIQbN1wD1gDoBFvdtr8AyM1wHnGeEJtdVZRS44+bnPjtqppzWwLK9hGd9s+K+yjDv0LxplaOHGzpbpDT+MG/solAYaBXgNWNhwb8g9ft8pwUkpGXmiTqhCjkC/TGwMTDo8L1ruhU6Cohr3q2M0lHpVwRW3SvHB9nRfx7UK1Yb40TIJjt/AdX6reaHH3qfQeaO+ZBSO/8ZnPPeK35HzNkCNEJZehnNcub+ACzvvcuz7Ci2P4i6DvRyTMHCLiG+xth6F2CGR5MDIiHY+Qa8NmBiCutNIp8ugk3TDC4VG2fULdqjDElUT/gfkyTgxgSxIikbL8o8D0YA2vRhKVQhn6AuE9buim+cdQt5X+g9iY0V+B0enQgDKAghWyeTL5TbJrBIWc+l1kcmNxUwp+ysXUqkN2Gic39Qz3ShCP5RtkcpwJcmh51kg+A+i2qtu289GK+b3bBe1XtCOz9QA+qi5YtlegH4map3a2vm7ztfR/FHhIuBiUe6Bq1iNxR3ZBTleWE+S57KEqBbJ9aeXkfC4O8NlJlB6Lsf27PgVZJfPVbRKQOt6eqh9hAKsv5B+/gZETD/IdnIXAKX4e6gqwZZyoaXA91SVtFbIFFbm/57svaJ02M2eglSMsKclC1r6kbqNEGZVyD8XGBsNwp1emPUop1fggCMuIlwGjXmbwajscJwz/vZzoFV0KXZwwpxgzMKkBX0vjcoght5vSpU/AlJgvOGDEaTEtnnsxQy055h/XB3AWmMsuFgdSJhG7YLGYVa1xEI1TB0+j6lF1bDs7HJmbY6CfaZ1b4KjfZL3sxyxikyMCImsIjcYkKsF+0rl8u4ZimlrQPA4kUFx3WK25+Pzz8UWdQ2iymKKD6icpx4Qkoo4Okb2OgNYUlqaxGYUJc0cM6UF7gVv6x/DK5BPV03w3RtP10t72ipjWyMBRGwe+2gVuoGocT0IJqFBAUUdBLSsoWNesQWe1XvGQknpXJqAuk3g9DsLm9FydO8oRdpnkzIOJ68R8EUuE5Vxc4T9rqVUSRDmw0xqxuFwrS65ZN2Cao7UIpJALegTEl7a5NO5y928W+S9JrB29El3rkXBWlpazQsJMSRhRKoQLaKomplX0HAkp1dkIB0lIU4h/TLll2ho6ANuSuhlF42I3MekMUW01AsJq1wLVrRAuUUdfs/tif8KLhuxPGXKuZ3/CC/dgcdCBcSYnuMgzORAy+LXfgUJpjM5nho0OetkXM9P7yRuYz440MBDrYQPzOTUwtxgTOFqT58MoldGZohQiC8d9W3TG+kX8GPZRZVICCtEdSIOh5J9Xd4nNBJ7iNpnRzvMv9PML47woLiHnBX23bSYcNg91Z5mKgUPlalqUbo6fbAG/wkAhfkSRTWPLxujxohFkMf+BzJNo779WBvtjkrslvbtQ7zapcclLJvKCXh9bxsdD1QtcYeLj7Rau/QPR/Hhmvj6NjBLuVQQzUs2vIG8w2sM2TqtbjDQKeatI93Xk9oHSD2vL+doEHSzIw0KtqA1cniFM4I81oUg2Y+cAAqg/BX3t5L54+A6kLrwEXv686zQHJ5ViFpbwc4Pxqr5hsACcrK/TzzV13lPXaXI+YdRbQl3dZbR8hZ9LF2SwCq0IseseNu2+oogdu2K0C1XgUFIa3gVa6kGzo32ha7CEvouxGFMsoMt1ZYjdPTZi80Wqlr3AWuyBUFBG98sNdGWHkxPni4k+ez1wwc07rGvR1U17KGq190dSKB5VoC3iBYhj4NqAq0VB/Tm45oG4+usi56wMzk1AneMtcRJBngIKKsA6FFeyRFiNKxGuabl6YF/MEsohZilfoAJF0oI6AiL/oTBfwMjjwNMEQhdA6H7Uzy8SCB2j9OeK3jWmxg/TIwiOK2YTikVbEYx2i0kivoCq8gn+yX8sGmgEErcNIcG9U4iTkkMXsjP9193GlGPw+xizINy2kN+xXZfpFiE0UbW85H26hvPy2wG/CDV0IisoTLFGJSL1WiONpwChhzYr8Ef/JBWg9AuVyzVbyJSkCn0d+MU96MD9cvm/fIvv8qvSb1x+3Kxw+U8Z5fJXWxZ7++Htn2/MVrLsyhcBGchrBvMJr14IwTKG0kzzLfeIPKsVrdaQZrNaf1rrzyJD6k8LvbWGlRrpu4xpD8fT3ONNFkbBqqGtoovKUI9/5CqvwfMN+VfU9ulyOJZlepFQUmOHNXMAtwL6nf+rF7AOznDtBISU5F8Vike6BojV4olAki79md2+pjONTnD7dZENdCqrHD8SlL7ImmQvx2P98WxTu6vj8NE3FzXmQVcKjNpdDn+NTHxbZCbCwgJTFyvXypBiCuSaM0MZT6QoODzYx4p7RaAflBVOp1gdGFsLC1pkSglAhKLRtiC4gx6CRbkT1JMklARl+Xc8ciVKLs99+a5O4QeNiZYhfxqWC/Jn39iPc4QqLWTl4z9FwAIjOZaZGQ5woCehhrjN9QprMKGtkkqP0i4T+LuGOEn0aSS0casTNSCGQiSh97RRhEO0rThjRYL+UzEeycBKxL2wbV1cKYCnlpaY+totBcNuv0pGK2KtKm9ICPdLbXxjSG1EvtqIVqgN9BIsq5snGsJpSTHgEm1isubfBNRaa6Kp78laHSPnyuRrJLOtSYgEuDy0r5zC/FsAtieNpPRyAu7TK3L02ugi/BLhM0XIsyGMq6IrglvwLSdlqPMhNUwd+zMoMPVEDQQN2y5omO0paIih7t9EfW9ooqw/UXZoonwSfh+N91Gp+ywYDpLUOpL6mybtPW6a6OjfZCPDcSH899d4sQq2ilWRiFdVtNX7O1TbEsYKAywMND2KhOUYExFBJE4R3IEDk3OS6H4n+R41g1qtkaDGI404DoNeq2PVbzxS3cZD2WusrDiAgT65Ka8QhML1GllLKUZY9xMSZR2nLP8krnQCDuUf9AWvMcC2CcffOuLwVaGy3DI0h74NC5j6DQANXCGIoZ4Pxf7GwaMwv1YlSqzmrNrQnALV5iES9c/gkWj0KFKRC1XkEhW5wClXslDWUIMLC6XGGowuadIfGpPtzj7NDtqn1ZudfXrbvzzurSKOdzT2lqM7SPIiQZIVbdUTY6qyx9UWp5Q6Y6YAA8SBYSkysWdvBWAmHyeHijlL8zs9c4y4lHzPLxafWM3y6r5ZvmvQLN99P2b5vFatklWw6pD6o0qwMq6r7nwVXozbTLbTRUGzomAK4p9tljHpF4wZ2x0F8z1S8KodQkGlWaw0S5Rm7RGkGsMDrCNJpZb/6h1q+SOxzeq/J/iJ+068R7BrdgwQ7NoduyfYlcZIvJdjlEwJHX2pXl3fNWS+xubMs9Gg5JJspChbfVuFkOZ1SnX6UDIqHqUCJk5yMj8Zm3jPkKpd7UfPVw9Fz3v3ZxMDsr3q7zdLsyC/9ydpGbft2GvLqIzkq3GMqlbjt5gA6jgYMo+hKGMIzzQvz3S3KaDIxWT7nymPKUSN9lFWqiQUohCshNK2NlTvEoKoOm9138ympDuM2zGe9O9N4BuV/d/qK8Nms49CGGfbt0Kn+c6AAAYPO9iINA3DBsk8D+AnwmvX7fjp8dr1O36CvHbDrxiv3fhLxWuFEhb7ooN0PdbR9YGt6o3gQzySvg1c+WRkH1y9aURmegQPm1nRqH+LKL6BuQkK7pAfzscYAvZJ0kcK5vVDKajMhWT4hxeYHesexDJIjPc8FtwkhpC+vYjHl+1SuGyWOsvBUm37nsNLx8jFdWXxfaV8TPe11exmnuTZhd5rq+7FlMy/FlNO/P+8ubJdbWJrquG9kB0Tfmrkbh5QOS6Ilql4nOfIO0tpr8hqlImLUWIWi458w4oC/ulVL0FbLOZstXWxmBA0ouo9LZn4M5zgFt3mMsf+EPZ4JqvlDR053A0z+OIiT8lSflKACeIyoJBIQZcLIKZdLqNEAgxuW2ZCzo4oY8wtHsM0ArrIUkWCSwPwoFA+q1q/2Wl5iEB9ZEKB52AUHgYpjVWbsAEzjl1GkI1HHWDwqzgj4KH2ikkKGLj2Mw/2xeAzb9AYqXSc6haYPi2Z4IFC0vBnTvExQUsGx+munRTrFVm5LXKVC+s+LDvJo9/q3kdaxaPFpPYgH2LVMVa01qFnlM5DiWkmoIEojwm4BHkyTpoANSe4bgff+cnAfpnMd3raNv1z27pqlsZ6/MLFacded+Wr+6Nz5W2arp52KWpYmiZ7zlwJ7v3fG04zS6eZGxip487639OWr7361UzSL15yzhwnT730vLkazneWaQqAm96WUPHJ7fNQcfacuWIGEZcAP4ameNd0rjhAZ+LA6iHcazFbPRTJQd68yNFsuvc6X8zp6X7PUT5tK3Hw9YfVFIG4a5QouDyExsHvPDENnUoL6hV5s6mZ1MwEBUWZTCvuIBeZyAAdQv2TTiKZ55hyyusRb3nkrrvsi8uuu6123XoXTIREhxwrUHdnOdQkH2piUTUf4JM2+GSCEkhF4kuF8kmkn9K7H3xeu2unAlcagKlALkUKPJTTVP5osbUNkNes2/WM+pJes0twv8uWa198KwinfzGd55WkW3QZkJDFrVgGJHTQRSX/XMjrV7VNsxcVBVkccrVWok00NdCUm1UHchWVqqKPymfW/SOO0VgLVl5bWS7JOsZx2zrKGSXkYq+yqMw5HVNXFdnk/xNuemHBZF5LnddV9YRaVArUpOmByfXLmODRpEgU2RgZEA/JqIwkZLGQ6vH4AEtf9C47HhxA8gEBjKnB8Ez2WxtBNa41Ct/GqiILS6toAnM/IXNfynPEEbIuVMte2JEYk/U7irkjq2hqJ+iA24yePTpgkauCnDCxPqnBBzRzK8VzSnTAyPsa5G87LTEF42wFkMjJL4s6Msp0IrD+5wDjenEcliBja7T7wmq1/lQIMTVt12kmaXw+/+GqKiJMiiVovA7w74BGidDoYJpQsA5crG2WVpzBFQ+QQOtnXFxkNKUmA62bpqifhdxwrrCKLXdkgMFwvZSwUZTNi83qcM1akcPyrkImtUVFl9I7TKMYS9/GDFo3706Yt/OTsTwH7sHyrNqj2elwb9CXNCFPvU8UGWMr3EHTqlw8bfePSnIZucXIB3WX6As3JRjYi4dUmeXZGSumuI+mnpRoEHtK/B25uDfZ2LDwMhPRpsMGSmjLBJhiAtQAtl/KLMrpOy/h94v9SbCeISWrNlTaN/bTVlddyrBKxPLj3dtPJqQoJsVVLs0iSJOJjA4SWcepTLILFBcejX3K1fAAIQZHJuIsKRgxkJh8yxngc2Ea6zcvuxQ76Oqe5WLCvDxlIICKqet3rMykAuWhzaY7g0A5wSdbruqVcD1bIMso983KbqeoDbQCJ/7WKEmAzq7kcDD2EDqDcgERBr/f9rjtN7SEjScJPqUKhq22Pd7lq5Bo7g1ebt7PfYyXOzvfyBKBFB0oH6eaExWiCQiRCNBoPDwY7aHjAL+DF5cbqZoEqSfx0pQYAnZbUa9vWcKJ0LRa1qS79Ya1gKlZBWcPlDkegwwKsaVzN212oKZ6PDW7iT5R9C8dRB9tzx3kPQU6DzXqaCE0BGFzd9GWCw/uXw+c3odgZ/40blvMgSTRMcF3jBp9U1gVGpYfGSSMrsiFIpK5N28nFY+KaieuRmWTw2CLu7h0JSpoIaoyVFWp9pvvDRe4CcNc6wB96rQHHwDzR9HO7K/RlA2YrQc0M+ZhL6JZdPtKkEu7DFd9cVcRWIPUsiDm+uWMONVgCtZGNMNMsZNvhEAarLAYvvUGtUUHZQXz8lAZSSmwDmOvu2RwM6rocii/w6grEClh8IfSjNw4LThTQDtuha6ykErPwUSv/uCSmuyy7Gi6n5EuPWU74/rTeRISKANVdr12obBHT/sD5NP1OiecKgy/farCI0ufQoJUQjxDDzgpyMmg9DYD7jQ6gXXh07xSvm5jQp4Tus2WtVWymL7H2mCrrT+hQvADqfXK0p52r/vTurpvNO9t/SkmR+/xZ/nqIqhSzjHXleFl/96j8LTjbuBHfCn87Tl9cEotJC7u6VLU2+AZdGr9WxdWLyKYDVGQZMn873UUXPNqLakzK8NN//c6h1NyNcUw3tdoRTK4IbvE1xUPu1fE6JebnNcx0vUGvmZhpYBrOOQ5oibw58g2cK+BOIFg873SEIM5Zw6TYBoP4HIGt27xPu6uAryRWwl7V7uOkw2W4YG8ZWZuzgFfmZmZ4fuaK3/NNSkz5igprfewzNzEubsyMzMzc5Pz+3/Jltd+LnO9Aa1gNJoZaWY0inL5ptoMwBCS3CEEEuCXNii8V2dnJBA0dTqt4pm/6GlPPqSy4BlohERyOibvtn77eH93/u8LmJvqaP1u5oJ0bWPp4+6+58Bld349Febpt2p7UEjNDPz4kJ10FAfjyG3Z4rvkN1m4flV4XW733ebb9bqHm0M/kfGr0/MslUbpO9ndaWvkI3TxAk+ygR9pkEyUwYN34njSwEjtMbJOAIZVAiP1ozCE5u3QNacVBivaurbWW6+mZuDHClD6AVELNEBlirkQaCgSp9b1oi1TkZbNFVs2q5ZdaOl47HrLOisCoLqlCODligBe1gCOBgAOxTwc1G2nf6LCytIF614/xeHZ25/EvJ/HOusXsM71DJb93z0VwbLbWfuvg2XcU6JxXzcuBXeUaMQ2N6KxbFfnM7MNkj/3jumZek79O2WiYXLJHwH+1HjRli2Rls0VW2rOjkbL6jJBd36BoDte+QBYOO9gUcA+riTbzCUaDtBIeNGWLZGWzRVb6gF0omXVbzdTcfoEx6v0IGQs48fQB9L4pSM/cS5/wiyjRmFcNT12fNaPcUsrzia2RtXsnJmixvIiOC3z0HwBviBDjYALQkmqkQ41MReuIziUoo21K5SkVsa0/IDzHIe1vnv4fmhmNZ6pgsIO9atM5pebLfVotKJkyaJ9JBwg768HhMJiGYowfX7qKvzz1mEgUsIn6xfwyfJ+/kzjEKskcOE4lT6K6HnDwpNTVPmsyda75EcQwwiQcfBBYulT5524Roji6gwkI+NXgtcNeMaeWHMbDljjbMlqjbCGQrDsZ/q6cqG+445aLURxVQlYhTMygDZZ4vwDxiDKx0DR9WvY9Yr4A6lcQwcO8W3wC/EvBbP8Rr8d2rYXVZmDEZXZX1Fl6hXNZpj4bzlgLi7mcLXjTYnHaeNZnRatvKMqHH/R0iNPbtNLIizq72ZOyomt8gb04KdiC94IqJ/QF6EU+gmRSnc+8dB2qz/zRnOYfu/8JU59843tBgJVIT161tVbv/bvu0aE6Sd2nT5vYC2eDcL0lK8bm5qajkkFSK+7JT93IDtIxvT2Nw3cbK6KXfPY39n55dCiJ8MOfWKQdJmRiGx+O/BU652YZZMWqEc0qwrwUyHZa7b5wQy8u8isjDp6+FHUMyHkJcgAa8crblzHTB/oHcwxJeALOQbIw3PwXBB6H/bBZbQ4e877AP9b9HT4ptPnOmD6VtlgeA7kP77qyQPvfDutP0zffvV1/Rd+mBwRoMnwp9Zw7QZqWJNTl292fvfGR587MPwx83HuDsoGPyxF/niYCUhV8UfSow8d2n9lghBBffYDvPNKrwG41LJtzBLt7liYmW25Bs6FaxKQRiWaw5TLiCIP6fmxfq9fyFzWKNllZwa0P4QhwR76dHQApExmdk8q0VhRe2r8WK2oHIlprI/zAebZ/OrNe1NUYUojqs+fnNZFT80ybuO2RQ82l0983RU1RHx7fh6eAAoEzV9cAjDsiL2ySXvItSFptd53eNLmYhpDG1TUn69yMRKl2BBb2jzMgCbAhNaY2Cy6sy3gd8eQA7GkOzy19dWBhXDKTnuQF07vy4n9Lm+TJ0rn+GyRApz1UWHCGpTR6u6g47I+RVnuufacX1HK1BKN7c8b/UTgV3PxxsobqPVdikwETKwlmAi4gllsVxX6FMYaWUVJrEG9i+484uHqvpmpkPKH9/RmI16a7ZMZMKheFPeN22Otu1JBSBGsvfKIM/99R8f9qW17/DELrvtoSskf8p1vx/f29j6T6lHy+UY+36+hXNZQLoMQQytiTyzB9/CjpYfct5rDIAi8XJTP7j+Az5o55NkuF20ye/oxzbNfw/4ECTjnUfc9B1DVARhIrtconid+Gs89zXPvd+S5R557hudFlLEQr7zEJ02fzdq2OSTGQfqJy/vuXXXMrYr/gZd1XetoMp4CYLdUYP8pLZ2aSRfNsDSLTOAoyhFywViZ3V2dhfTZ3V3b1dmEGQ2wGnniEhcBmQNPYxLAjJwlbSNUFQxapjdFWXF9DI2d+nJnZ9JSgvY9rA7gdtmBtDMMGIdmzQT7A98pWCNu6MfR4r5hkuChLNSGovwTqUC66doXxoIb96QYqKSuka5i3rIvpicuuO6M1AkPX/nVscfcmFKcmzpyb2WNFKgAoLl9rmp/r/dmAL33ycUXPb7jthR1DlgqXcCKK1h7NrdNgs2SfWDkI4fOvtn1WcBCBb+KDI9L/LLCAI8SOkdJpa1+ZIrjIadVNCfKozNaOv1E21K0D2Md/Lvm6iXEIKNEMqGsxjkOaZ3j0Bt9Ox1b9dtZbUu/iTH6rkSlm1QlC9XykI44bnRWFUxEQUYSjkpB+AMGD9PL7n1Xz9afLa0E0KUiDzRp7bRVQFGhHFI9j3wvT+ftl900T2ebE+fu+BuHgnphusn6ZMFrQXOOGgI803b1CsZv5W7SATbiA/kyAi05WL2/aLfmXsoe7+j4PVaX18XGpYqS7bTgoQZaoXI0AquKbbMbYARMxiY2GIG7/+xB6F/OGPrY0ZlSeLmpLfBF/1R1h6vNY+Uf/7fDd0DKa0FAkNulqi7UnRFkJMoGWQa7nNTU0nzIDieJ7qe3pCfufHXypdccl6L1FDhPJfa/jMlD7zg21599kMmPVtPMDEIVADlUB7W9x21bdInReX9dX699m2+1/vcwBqeij7QKJBStDz19y1hFQtE64fU7vhC4iRjJcy8dM4SkrXYUeXRjqGr9urjZANeVx6otN3VLXNcYimVr13p1gq/6GuPrXsuOA2huu2ggdxM6Tx3qOiCM3rO0eYGnvX9SqImub/VvYGqNS25KjZGMyy9u3/QYSHbuEFor2+ca32mPjVoui/sGMWfazxzIrjTGd3uSDksd/YyB5Mbb59xspVvHtJ91yeIjzh3T48fHsHNEpHrGSrfnXN0Z0aWRhV+NE0hM9k5QjhfyjoMymtp58mnCbKzlj5OogxqU5/qd1nkOgyJLSGfv/fkfq5yy2AG6YuyAvUMJT1CS6DBu4Jq4wSFSjBrQBSZsgFaHsG/RAXU49yGjdBVpIQ2NqZMYvQkU7CsdHShAETF0WKqDBBrMKBVg8F2ABnAVJXBNlOAwRvcs6OJ9JKSoYy1cKdIxAGx1iKDYrXeBEJy+orMk5mK1pU6e+v+iV/QhUeOSOycc72iFNOP5p2eJbZSKuOaOGTkklfRpuwFGdZzA87J/YsseI0smMko2XXapJxrXPWkQ+7SiXKENfkLIpZF7US59tGfKzGzBjFnHLpE3vRi/w9ylIAZDdv7o8I2+gzYvc0ZiCaQwpg9b88iVPlrt3WbaICUCGXI50E/64UkDo/ZdZS/4MJ/s/+gdrf23wo9KL/niQlfut1UTZ3lP/wA8m73oRI3QPhlyM1Blxk6RbmaiFJkgirIs3HumFwVSxqtBRuN4vnpvaz9fYKG1f66fb7qhkLfBDlMuv8nN+/0Rb84BtqYYyEK1SaGfSh5cmC74aHpvAACko1IV/DrULnhy1CFFw6RbKUrxAzsF8fKdAkfvFLhGRuPFnYJf4KgS69/bUXXDjBql8z2eu1vmuTu/1nN36bmjQ/FXJggRtP9IiiSF2SkQJTsFwnvbiXNF5LfAXCvONDdfxab8xbnsAtVAHR5O5O/FYEmNtFniZfxaWburOjGfwC8W95qFb1e/TtrR1/pRfoNZGfGRYoqecLvBuTP8KRbXQxNMSdoVSurml9aUpEXm7RoF6ExRerE3mb9PoddvMv0TzcaStwaliOK9JZlVpa81pa9e8XW3OuH9wFD4AfrS5oNc2+QCdWnxQW5+CFbpEMC3yrUrkCIypPlV4wp1miJ1gGlSEKcSwpHOnuK64nlgGjCYQZYrhmci2bXSTTJsJxPcf47xV0L+j1OrBpqlCMKDa0hejdvzF+HuLgl61bfTuzv1jxzds7uHQ0ZKTE5EHiB5Fe4RnldBgmXQO3PP/fyuXb7vbA1cqM/O2rdrF1zw4fennV6OB77gy29Oe+QDPKt778dbNn/BvPPXm19fIL/X5//e8hvtvOT1a1+68ZxnL9p7xbtv3vjRJ3+89NY5q/r87RtN7gkyLj0JULSQUwJC9i8aWLk1eQGc8EXVYgJkgpigZQwk8CJlk5Mnxtjo6xkCZQMZt/Z5zD3m2UrdeuSOrgdPIoBLYsbsUoTEgCABvSeGyUWbptmH7HsxRRLzNHF0WwRC7EjMSE1ObGoqGqJqa8wIWtXSDwwY7fykdT4T14w2NVfLNrE5mbxamoi1JXKQm9QCxqSdgpFYZh8t+BQC+etBcCQNHAA7dNHcMDvbBKjN3jbniyMxdlpAarZEnahdDVhnUONqADcSWFrl3izRLpAZX1xEmhaeYje/KK5ZSGYXO3P5jr3/37QHTr3HcfYoPfIKXMCO5Pry7KYneSDzwoCWMQ9Mm3aHQTL0yVvwruvzNk2D1qskA2+Gbl3bEsPyxdLXeSgILerUVH1PKVW3ZknQDt4DjcQvTrpo5ga4h1KgzK7ZBlPvmh484Ugy+2VsyoSGvA16FIgpUine+9TAhBqQ0xTBRdjexrSd1g2t1EggJEsH1t8lSBGwzfPukGPFgWm094uOcnaBrrrjwUfueGDx0CMPP/LkIw/fd8fV0KLzZM0hi2RRu2cNMFrQkFSWz7vgsla9e9d8UrmBh243ZUQLYk58AmnD5HIPgUR0PS65XC4xaciL1C4YY0en5kFelEzhJHMo2pc7HeLB7jhNYLLzeRY1FLNu91BAh2sngBkqnziZF4BiGjrNKiR+UdEIZoRhBTmBaZIfQgQDLaew34fTZJgq2A9ssYGJdCll29E1YrJ0LDmjdQ6wgPLoehWnAmnch+BZsOpRqDzcTyjaWCeFBQv2sZJZCeoxLC1e83CRmcwYRSHUDnFe97JiAS2p/oYOM3GQ2ixLHROBUXl9XEnjwCxq6CNIXASsTFdAzIRNT6K+R7gJjJ7qT0ubH4g2v1j9x6hdQEWxtnEAtwm7m7BQkAZFGHiwm1CQhrWIS9hdKym9hEGjdGNRzjJLN7IsmIBLmTBDCRaXj3t3OPc93yn25Du/8+55nv90MAQPN4lpgjHoGJqEhIR8gauxG/5d/mXnnjCzvX1EEazzlpnQA4KneYMwYexXntvnvPEVwTyyef2aZ78wwdU94sLGBJvbSEgM8d8Ix61g/7uMgbjxzsWXLjYSjnpZjbHHVgtcG/Efsh5pyxqJRpvMyA7Xj7jgLI345Ut3rfIbCL7WhiC75VPYgoWIM1YUeh9tIKpdD+yRfzNf0Df/+3+e6O6uMKWBUJ/u3N2/rUlQPwfxPXaGB+J5BCNY3730sYRgfjTizAehzbt5RCCzpOGgyVqBMxGXaM1r+1xPvJHJDhG7tk7gDMTvtMw39awnIPNl1oLKheNzbcQvv/y9dUM9cfHd4fVrTBcJ+pdA/IFdwYNyLjHF4JMtniFO54P2n5JibsMlehKdlUvFxel8BpD+0396T+US1qZTh4sT1wnmcxBnnWtbE1NHzJo8cJO0nyHwaMTrngWv1a4jbskOROZs6sHH5UzEtS0dl+S+JDywkBRpo5l0PogzmqrSemqJNRnu4dnrZOh8EO+RdhKSqiXmjICBrvxiOh/EObr2kuY1xHLbyhcBeZL0foF4dGjZkH81oeIaZat7RWp8zu9H8pE9715YRfhneytm6iwVOAdxDlOnor+SsGbVwHGdPEzwn4hntonjqyuJrwW7mk74rGWPy5mI6w2Emx6qINobCqa85UoLnIF4ncTJ6FvlhMiv97cI9lh+iPPnTPJMKSOM9x0+y3o/TpdA/3/pp9mvSgnrticxf3XMobc/NJ+E0wojJcQWvTlR2yPFxuf8PqT/h+2d60oIfzMhlneLhMA5iDOrHGQOFhPYZdWjBTMWa47LoxFniUn8OVNEqBtIHXS/3Esf3xDvEf9x6G4hIVx8ZrGC7xo6X8QZ8o3S2QXEvZi5S2KZcuNzbcRZdddvvuYQA2af79yzE9Ucl0sgzn+vGNBFEH3KMeYGF9bS+SI+QWZ0/8gnsNEdZaOKtOa4nN+LbL9m/gaWODEt38rYaMZKOn/E+fvUHQPziPJks8+qW9ZqjsujEY9WfLWzKIewPSJ/cMP1+eNzJuKMTq/6nizi3Tnlis3319H5Iy4xDYSWPyeMLEuPmk0S1xyXa6P1L7/3eutT4sP8n9XvLDeOzyUQZ8aQm04+JkRi/C9aXl9A54/6XI6CaAYR4LfJJdJEdnzO70F86ZnmbSnEgdOvOq86rxifcxDnKA0an08gyId9Krv+bGSPy6NR/zvXIzKGSP573ffsSd+xcTkT8QmXZ4U5RxEdIjevr2NuYI/LGWh/jULLc+8TW+J/BRn4rhe4Njr/T2Yix58Ij+cNXhf7gI/LJVCfYy/Nv0V0aL+bCW1L2ePyCYj/329czqEQ97ywcA4TPstEhNiXzaHzQZwZZHxEggX1Q23TzJrGrq/Q+RXr1+59ACozTJXyoqXp+hDX/uRpsTUaDr/uNefMnUhvHyQyX64h3ToW1g+zL5xbRK9/JuKcqAXJwYlwY51p3d0rdP/aqDfXnKtKBaH1b3b32S6j80N9Gkfxazpc06jQ1Zo7S+D8bmT/3sXVuP8YwiJnHrFQGjs/Is7nJnxnP4XXOu/jLMvp/Y+BePT9g6ZfnoPYSgtsmh1dvzbinK+ivAnZoNQdkeQr1oUJFiKubWJhqZwL73az1c3nrqbz6ULqS/Mt/+sFdNoOyTBZ8+n6ENfGJxrfwYGXalrK3TV2fYi4hKjLlrJ84O/8mGHLkaXrQ5z/fkvAZwKGRR/qvlIZO76jLuXst7gA+oRkay9TkvT+/w05f62+KZNcACohajv8Euh8ohFnus84yi2Eh89uVzlETBY4E3HWwsw/J4vA8+z+1YnypZigPsQzlV00A4rhctawwRUX+vgugfrDjk6pEii7Ydf5WZnun//1P5/jk69jVAqX5bCN3i/Hrp8QP33Be15PKbRKhnf6zh1b/4jr7XDz9SyDqdsDTs+xHrv/QHzClm8Z+eXA3fgl2UBTiM4X9aEmU9MKODUSbby+T4g+/iLO98K6gyrBTvKI3vaz9PGF/wW5/jEzeqNYBcmtqTq+qjMEzkGcr6HmUVcFWfMMTIr3y9L1Iz6np/T3qWqol7lXcrarFxfUjzirIVPzcQ2oZi4ckh6RputH538amXW4FhQGtjKk5hVigvwRn9Dckfa9Fub6vTi5ULISFyxDPPOpw4qQl6DwYUZlV9VyOv/P/7nxQYbamToI0Ole9D78B318R5xx1Ea2uA6+fMUWeS+RorcfxD//s31yYUVP3PFZkvT+x0D8R2qVuT0Xbi+KG6oJHbv+RNzW9HgIwYVs9m797vix8yviObMcdy6oh695u/JaPEQFzv+E5Nd0vSe/Hgam6O37FS5N94c4g9fau4AHOZgk72obvX6jEZ+Tf9HGngfll3oza5zm0v0hrqB86VAhD8zZ07IMNJYInIH458bVz5Y2QASf1bWpQ5juD/HyM4W+ZxrgwisbkVopefr4iP7/4kh+RQPEvhFd7ikhR+//iEerCaWvagSTshO3T+fL0f1/RLbP8sND1xqB0rYgu9PE6f4RZ5h8YDc2QtPJWGHp6aJswWtWG20Bqo2+Gv/nucJFQl0jEg8dmsFm//vxzgfADAQvdQJkFr/857XQ4rpYm3/eytBNbRv7OmJNseCDiecDM/79hqJab1f9P59VuKrrhPFfG8L/nxediDvLdDXCMFXl30magxRYNL0Jn884gx9lXtIK7aKAa+0x56olC3e75fR5YTsF8wdtVA/V+2Dn3RbyMt9S8Mvv52pmrTfeMti8wb6OgqPlH4/qDDGw8rALS3aWURDCUzbriGFhLv2llVr5FDhec7GID72Pzfb86WD8nII/1HDgsud+2NDuszKBqRRww+VPa+ZrYY+4PKWuGAqmO7E8VSb/hS/n/Z1hHUbBLLa89KEjd3F9s3l1E4MoMPyq40Mx9fBqRQcO24uCRQONuasrAnC+bFJ6qDMFGYbmX9p5TEzfL678wVUK9gTFfV24nIlf07+B5ZylQFOpxbBH3B//6uuj9vMvCojD88HH0xu7UHXqm9lxCtZ9m3sx/O09vMF8iivfjAKGvLrWUFcolpxrq+hhQEGEmnuV8yd/fOXbP6v0DlLgWxS/Y+spL+yVz7E7GrsouDGlI3PqVSZ2r+lGwF6gIDgxsX3Y7x6mduyC01W1Ud9zvm+JpQcG8U90axUp6Psk/kBmNxNrvt52cqcMBZbCZ+Bazj389vHvrR/WUKCYIuLYOuSMtbaIf48QG82fOLUsTFITZ719V3drCQXPRGecdd7sjU2f3BHvNo8C/6paz8AFTtgRea2kjBkUZKVkHrxw0AVbmK0o+vc0Cg6cT22buM0dU3xz4M/piRTs+8Gz2NLsj40sOvFE+A8JU8z8NJgx7nhvVKBVySAJtnr7q7v3BeJVSeqbE3pJ8JPVX/5DKAS3fjPVMb2LhPpNwVqfuWfwoahOlfefSFi4vPbp0qUheGfi/CLZdhIcD0gn7Ilyw1apzDsQ30KCl936q4x5QfgKZuqUne9IMPNcvMc/wRiXlhuSFH1FwvLQvTZhG6/j9xP13n7nkjA3tZDRfXw7Jut5lCFcSwJ1YpqGiPU9zGjCyu6tlSRcmfzwXWu1E1aHFTx/VEqCwrzZ4DcShLXwXvdIF5GQmXH1RS3rIiYlvanxHUHCJb7BN/bKIGxm83DIE3y0n5gzE1SC/fGEjREXn+SSsDcmqKm6xQPfZv3y0bssEqzUZrNLWy7jzroRR2SekTBofq1r1zx3fHagRWXs49H5r4eXTFUNwt5JPd+0O4OEqWFe8tkPrmHDZfcb5qWRIGKwoq31OAvbYLCnWSiFhK+lS/XcylSw7F0mXuuSSFDlnJD5qBSM7ZFMW3gqgYSoiyFH93X44CJNF3Nb40hIPEhplCj74G6G6pk3Y0lI/yLjefmwKy5RVK2yK4YEY+Mjl5trg/C1qwyd1R6RcGLpTWbyHCPsXNKBBsOHJKxfZUlQT4PwGo1b1pHRJDjnqnikzfsLJ95NvzBvdEwmOeZQNsdx+WUnsSdRJOjf4RtoNjFx12D9nzdGxy+1TG+eEL+Mn7fq+nxhdJx5w5uzj3THz9+O2xM6Ovb6aCimtNQdr7DZduTb6JjXIGJZFc7CwKJF1y6ahJVxB3OblK7hHhO/nVswWo89x8ZguCsYUypQmNg9OjZ0eJXS+u0kdkzn5ab+0fq3vXwqX/LwDj5vmZaB1Gi/Kps1erPsgvD5tQdCPEfzEBtZqu5qycTTylbvWjaal5PR2Td6DcF4d+COsLeJJEzwmmVmk8bCQqy93pYlk/Dsa0+BfLYv9j5aeltnKgkjn0rCGVkncZ8dzxcpZZCww6rfxGXwGrbp0sKQ9MckuGiKJYiLBOGlIwHTzZ6RsEHMwTsnyQLvLKnJ3JxNgkku6/rP1Q747EPlVTvySEj+ObBq+/ZAXE+nJcqZTcJ+P+vXDpVueJ5Q5eleDglStQEyfzLOYKyeGOeAYhJenBNtVa13xFavbl96vJyE46uOrZpS4oGf7LS4Zl1NQqNiW7v7Cm9MWXZfV1gdCQtf4DzuiwDcYq3Wk8mNJNQrkuGK1SzM+KnC/Mi3JDw1PefkaueKEcNXDO1bRvuN8Ltf88EZv9rPI+zbSfBQrgq8tMwHS+OZhkR9JuHXW+4+/2ss3DrLd4MQSUJeetORt0WG+O+FujmP+knQHozXnBXLwtVNOn3P/hzNPyhNbeCVLb7b8nffxRESVL2M7dvIAHzftIcKmVMpqGm2En09ch6rL9jPEptBQeqDwF+/2QG4iNhrs8J5FDydkaGQ7nQOCz/k1hy2lILg4ShzpXY/7GrdiFWKBAWpJiJcf74rtp9rJNcrRYHNMh21jJrj2PNP04Id5SmwXRrosNHeBrNjUU0Smymof17tssSLif8qsjCcDhSc+jUCFmn++HVPoX2yuynYm3RBLX0mC+/znCnsoUtBgpBmvFvMecwj9nfTEmMKZq/SlogMcMYfuFQsamdQkBpY0Khn6oe5Kb2f/NGOgv32E1NN1F0xxrOJ/ZLnKBDXeiYk2eiMW4VdU75/nYKKmbs1cqU98Q0Pvy/Y5U4B7446Y0rWeWwQvD/JsSg4czZCv6vEBXM5UPZbP5SCngCe/7whf/wdK/ZRRiwFN86vbnuQ7ov32vjJ7smgQFgieSte5IdJmR4ll+dRoPQtqShYxhW7n2e/WaaEAtKNq5h0wgvT3ulkdrGOgu52jY68zX74gvzwtOH3FETUBBzU8LyEvWFF3i74RIFnNWNrwdTDWO8Zf5nC/v8RbxXgbeRMNKU0ZWZmuFz+BePfelehtikztw4nLjMzMzOGqcxsb1JmZmZm5o5djc/W+Zj0+Xmy82Zn3khxP8nb/HQO5TiO5wRO5FScmtNwWk7H6XmO53mBF3kVr+Y1vJbX8XqBE3hBEERBJagFjaAVdIJe5EReFERRVIlqUSNqRZ2oV3EqXiWoRJVKpVZpVFqVTqVXc2peLahFtUqtVmvUWrVOrddwGl4jaESNSqPWaDRajU6j13JaXitoRa1Kq9ZqtFqtTqvXcTpeJ+hEnUqn1ml0Wp1Op9eDRD2U10NqPdymB1eTXvpe/buFGU1dwru61ec5ozGkX7+gYFMfntcYjT0jTZ2Ndt6fCdDCz52Cevb8xQiBgxSmnwdBUfvTQOuF/ZErXAicq6fPQPB8p64RppDvDxit1xpTlz5BnUzW4IjeneEBodUpOD4KtTkcn2xaHWKP3l2sD2NpCB34/x6otZwoI8LfSqcn1CpuzmPY97gshFolHTLMOPLpK4wd8pGhQ9WLB1Ql0+K9wk4p/ckhIT52sP9KcnlEpZ0DHpjJ8k5hU/wntyUNKtWbc2n0cjJ02+65Y7LdINsKTV3reeot+THbAFOeAlcI5h184PqFCPcVBl+31BvW/DcLhHTJqClGHqev6L8lXxsScKbxsYI/DiObsg/Ztnn0MGIIWZX0ILYeSRfhXkzzcQr5uNG9hd/99aTAtvjNq+PMpFH7rhm4YXPt+S8vWZFY5lMVaeDxMm1eQ/4JK9rf294nF6lyPGFxraneRFvYs97onc3JbSlpytSatcgid1V0QJg3MSY+zyxm703KndY2HNRmGrnPe8UOPjORNHnsNajzi1b2/K/8mr05dX+QNDJHH7MP5FdWTn2/6UV6Eprcfah2UGVyY8rQQklrePIltVd8QJ385NKj0xN2dFWT057v889sbCTnL8acPufRmSSPKnxhQMd2ZEaj+q/WbC1N2Pl/ad3/y1stb/tHxEz355Q+G241ObZ9rFKg1ztyt/xepcOiY2HHEu4qtw+3uZLgGUqKjDp3LHi6mcxrv2n1ghZu3kUWjenR5E0F77YrivQ90aK8d+GU+Jym93lS50VFF/X9sHHH06GtDlrz11mR4cCd4qWV1VsSO3V+Ha406Mmb9vSarSxO/DzuZmScsjZP669rGzUl+ncD7/KllpIqR0JzlMp1nMw9vjWlc4t7pI5m0NGMdS6SjFFfP3l1Xas02Df1ZPJRtbnp45WNHkL+r+fTi2nd8ioXCrZL6/6ormI8XbjmybGdlDfF2hq3hHdUbkWcPFTudE0iPeGVhzlHkwWDpvjVj0whCU1LJGxdtoHUuXoqx4Dti0kpPmuVbncClRMV9/hVfD7WnHt1relTpK2WC/W3mUZldFeGTotMvZEsKim1c1+JreKvNO5yVK8xqpWvoSv7TRhnIFuLj7gYubQreRsVcCTT8rGkinKqVoViY8mpc1L19kNCSMd7xe6OOZNPwfORs3Uj9NNGrY7a9oR+t0PoGZ/am99txYLeNnpVHZtN8hhps58mbbdaZZLw1morV6ur8oGo3n0z96R2Hdhzj55oX4HteeCRWePrNi2S25J+oK9ba2/zuuuKb+k9G+5Xq+zu1+lZq6DGfev7udHBAwSACFAB1ACW0zgAh5a5xlgdQA/4vwuuGqA6wOCCkwAygLjgvAE+AF8XnB/AH1DDBVcTUAsQ4IKrDagDqOuCqweoD2jggmsIaARo7IJrAmgKaOaCaw5oAWjpgmsFaA1o44JrC2gHaO+CMwICAUEuuGBACCD0t77n/o1rHGGAcEAEIBJgcmIrE9E2ytHlK00WzLeOIuTwIevIT21u6s9C8M7cgA6AvAAcHQGdAJ1prS4OXFdAN0B3yvVw4HoCegF6U66PA9cX0A/Qn3IDnPRfk/+CjZp87qnVBnovfWLzr9M9sl0P235Ptj2VrXvLakm7H67YrPusE7a4xEJbrFaZG/zUFhe+8IGNr7b3uo3f/G4fWgv1W2ichd5nwbpYh+bFehaqx0J1WqguC9Vhy9Nx2mObjhuDz6FFv92iH+OoH/vFutg36rLXQX1UB+rDvrFP7Av7RYvzhHF4H/aD+ex1UQ/WozpQL+qxxS+JuiNTa2Gs/Fs89oV5sV+sS3XYdWHfqJvpz8L0h9bCzA/eh/mwT+zL3i/WxXpUD+pl15P9fUAe/RiHfqyD/WDfmB/1YV2cL5wP+3oyv9/2+WA+Hxbm84HrjDqwHtZx7Bv1YF2cr7809N7PPKuMl6TuH/zqxPVsbN4zos2SUV/amt8eMw33qtpcSi4R2LJveT/p0v6x+Srdks3a2i0+BFZtZN4zPvPrGa8bmtuNaxa45YlRmjTYvYZvicaSV0y9K21rBJgPV2iT6aSqvUStmfoxDu8zY12sg3lpPYnqkahO1IU6pHnGRpOKhrWXLrXyWty8USszteg3o0U/tejH/NgP5kddEtZBfThfOB/YN/aJfWG/1KIf43AesB7mk7Au6sF6VAeuD+oxWzx9hKefAiRqzYyVfovHvjAv9ot1qQ7UhTpRN9ufmekPLfoxDu+z58P1RT3YL9bFejgvqJdZT7Tot1v0Yxzeh3Vw3bFvzI/6sC7Vh7rs/WI/2Dftk/18mJnPB+ZFHVgP66Auux6si/PF7nf+2/Ff6XhmYRzkv9HhoThf5yb/zbyXVpjrf0lHfqaOitHBkX9n/QWmTi1GB/mHdBRn6tRl6rRl+Ibkn1l/wtQJZep0Y/jAv0lHWSZPe6bOQIYfwfDdyN+z/gFMnv7OdYZNZ/hZyGPAn9RRkanT0TkPmcnUSSDMNcNPI39u/Rs75yETmDzLmTrbGH4zw0f9Th1VneOUPorzNdPvsJ2MzmNMnQOMjtXkd63/sJZMnXnOeQLTmHW5wOi4ydS5xOhQfkGHF7P+w53jojY586UvOfPcc+b+N0ydJ4yOY4Rdfzy/4D4Gzx+4D8HzA+4j8FyE+yM8D+O+GM8zuK/B8wjuS/AciftJPL/hPg7PO7jvwfMN7nPwHIb7MTyP4b4Mz1e4z8LzEu6b3H5h5AMMBBRg/O+T+4TvaLxZHiT63DmQ6YTcI9F3QYWGl+XN906Hx+2+KXfsEXfZ3/OePPJWfjVZ91Be/b5g+Gv9E3lIv3oVPZOfyp/q5bz3QN4n51Ku9Z1k3Ct/6t1628OE3bKl+oFibyrslDvoVvyw6q5Fbpm26G79tpvlthVTY9ZcXSXnStu0/sLhhTLqGAQYDBgCiAQMdVx2wHDACMqNdOBGAUYDxlBurAM3DjAeMIFyEx24SYDJgCmUm+rATQNMB8yg3EwHbhZgNmAO5eY6cPMA8wELKLfQgVsEWAxYQrmlDlwUIBoQQ7lYBy4OEA9IoFyiA5cESAakUG7ZTxTJCW9WpHN+wEOywxuA8XuQrPAOYON/1e/hIo8H9bsx8eh3HOh3/5n7nfxr/owu/O6/4UdB6Lf6MvyCPz3rh7EcsAKwks71KgduNWANYC3l1jlw6wEbABspt8mB2wzYAthKuW2AY1tT879fvlAuccobXotlj1KDnqVmXiqPyu3jUWZUlDxnYNGgLYnRcuT/oneMehMjD8y/sub1AXFyaJlsrfb5JMiFxwTBK0muvCp6+5gXKXJJ21gp57GNNXL+amvyVVuzTq5RqF2v4/6b5OJ7u8NruzyjfAC80uTv3+ful5vZxmmZ/fd0f8Tl6tE5H1TPLb2r7lEmo+GgIYeh4vpChqxnyxl8CwoGPruvQTOrheH5s26G8ePGGc6PX2yY5LXVoJ9y01AhIK90+FBdaVlKigSfajmddY6/v9mAxjq+69gih9vGGWrvyN2hUmy3x5bGm0uOftjoHFr0y5CXamUs8336dsAOgNkFZwEogFQXXBpgJ2CXA5eOAn9GfIWRAWxGCnfAN4bJKiAIQwvDn0FjS9lNSKPkpO2LDViIdElOYZNUFMWaEnZLh4lBN07Slga7pnSDXE8/nf5D+65jusaDQXkJnlnK0rCoC9u6PP44F43RSRPs1v8iszGZhzbF6HrM47mZMSsFmxH5psy0iGd8n/4L+TvT+KIfT9fi/ZhmKnPx6wHSFnhhFGTN61M6bAzV4WKnDketDyDXl03vTD0ah88w7qwAE1RaEN16FPeZ7lQFaSJSJsuytQ+57GiA0jdrMmT38PH7Y5b4t9GjI0TEhiMMuH1j5h1rhK2OozrKAv/BZbQmuzErqwrNzvO8T5zODptTCE/9xMFzDlydbM1xQ2dCqoeR/dMMQUE1Si0keJLwJ/7vduJ2LA+ZouVUOBUi8qWeLaEKHPUtIm7aaUxvNSBj+YxYfQEEhIbRCDKgQP0LZ9c2khmozoIlhcxwa+FK7w4Wz9QluL2UtkPTCTg5G9d5Abzy6EdVyQ8JPRPuTy6hUOYSqUUFKJoZIY4VYYHLeO+txIWS82jYQtrzANLiz6Bl/oo3+t3cGC+Nme8g9pcU8HqTjF1AL3tvWyIl8Zm8lRbova4h/oA28+aW8fqIH1s3zYWZ6bSJTkWmsokrasM4znDlnKUNKQPLCQquZo7DQ9S/hPMpdyctRRXs0hTByuAlko1v2KzXSOOFCJ7PkUMu7AvvNptRUqqO8HtJmgPLkMpbR8f0eKSbt6E8aRGhE20JXTGCrhPbSL0dzIyv7axYZcJ4pxckNVRz09oYV5tKROVieHEuDcG4drb7BXOjIBSbPw5z5M+/uHVsK55vslGKs6Mzt4zj+1pYkO+EeelSSms0kUt4ToHNcSY+8WP0gslMXHaBoi1F/FtsitndUyDVwUuTVORXfmTo1XjIGWRGVDlelT+ZpN/Ff20h3PtcyONeOSIFosj31kdZ5B5iSzs4PPEiybP8Ub5/heURBfirqyBu7o5P/EncPs9Erew0f0uuwujvd3Q2hfMl6gzvPh3gnNoZDv9ww9pak8yhsaw4n4ZTzC68fYw5bqXOFYlHZH0U4bjafHp266AqMI0x4iNYLeyM4s/NLE86ye7PI8l+PY+ewDg8VvhwRbKFE1FxpJ3q5tnG9VSJtjPrrAZdq4O4a+dMg741hlajOBgejPkGebTs83CvHo/6CnW2/W8Pa7xfsnSTB2Ii+Sh0uTDZ8RWyQpewGr2ONL06vvkWc6hPipVugUyXzeC0izwl5SmkTt7EyXeuHK4JR9FnHaNjcvATiqJD1QsGZfnmnYBjwUrsm5dwpiGUGwZnMIkaYkzYMdSMGonQuUSD1zGkHn5GuEkPCa2FbA+5ytaQSMZPiGDcl2p2hdyibng12ifHsUXaF9tYCWzKMnkcns54w2yet49m5R5Zvj/opm5OJqKTkwhfoIJ9qC8iehqMjZrCet0kpt8o4NaPm2xfMBH3AjOU9l4kz+IMowxCEWntZqHhMdzVzqGTJoT4LAmqC7fRFVFESepq1pTGEq9VwadETZIjomgwdkbGrhHfYy04H93AYJ0WN68l0yShxu8A8YFa7M0c+SHwEHkHVSwtclk+rItrXzp7cjqQi2wiOUQVx2PdjC6ToH+OIDUfprPkXgyWU/9Bs0KENcZfmZQTg8bc+7QmTWGtQwLP82MRMxjHtr8qmNvni//R0YRL+VAStxFPj3e0fIcLqzZTVPuQJMcMfKuqeDZyOnfalDh2Lp/CVD/CVtTSY3WVkpBOUlpVaPjvPAbbs3ja6M7JxzNRqHvAjfm6cOs8qRsjeWA5GnmlNFaHBFErFI9v0lj8t1xDcqIC9Q+V6P84RHjdL8JzhvjguwvBxEH0Q7w46CHB0KFh5PSFsHHSQEE6DLPsb7/xdIt/3D2IdtJBLXcbB96sQLVJksdKJsy3WcwTr0pUyx6Ru2uIGK4jsOsDWxuuMttzObYTn5O+/QBeNitxs2jm3IYRrDPXYsarh2i0FTHJwxor1Q8cVE5k+t1CrqlrIvwwhm93XiLZM5t/XD4gO+yH+KgQjhsqsbbiKrNiz3Hv+gtUrERJ6zNmQm0ZgTlPuVCXT7JUNqXX9yHsuh1lcylkMSd4citvhcKYLGbPaaPjHMpppHZIAbf5D/APX4RAxy/Scy/j7LqWVQoJrC3ailJvFm+2nqXzcTRjzI4zSzeOGEtrJhvcIUQ7mvJZI/BuCONJ4wNyd3Zh5jCBEUJuHLudwt28p6w3X8GMgbFE+xRyQ1CPPMPFCNb707y0nDXy/bwu/ZcvHUYE2Ddywb6amhw1Ys4U4rf5JS7vi2mtnUSG7h8sk16G+R5rnmd34RFRQoqyFWNNfzBN3xibokPID33l8+sO5gSU4nlqMcLNxQy/OY6H6ztuD5UQKZxPgNVu3FLvUuFxCX0ff0omuNJTlYj8n03cf5LBQ9bz7u4YdmfM42PgTnZXH2GMhCL7pMUJcoxihLwkV/b6MjSUg8XSFmqCNPmvZhJHM9IpOjOIWoIsbR6FRBVrUp1gQVrCfarKxzIxXAlPy0UoWoRzrvI9r2el47YjCX2Fi0ywLmdIbBVvOwc4oefOuzBFvr48wGBaIi0/n6G8+AkqOjZozzZlas2/7BsUZWCVKyrTqtmYdoA1546xaU45Cub15JW8RkzmNFO8HuESbc+CrTsx2PCT4Anj6Lw/gcGyLhZlKf3Wn3yxKqdhx06cTlwgQqOFJ1KPsNl8gbeWWawPLaFafzwN3itQmtbALelrzFZcxpaON9TsPcvlTXmsDevHQnCQj3/fJHyOJtqpc3CKrMf8SxL7F2hT+vkC68fEcE7jDolvxuIisAKHu60EH47n8P/O0PdMk9kR9/Dfv4qzVbMxvFJP/XJz3u7Wxem7Mb8uNbHjpTX+TjFkpOzFvPs6Cw/PxSjDnC0ewsxWCENneSjh7z/x8fJLVg4YMmzxlWnjSinecoSo/oW8yC9mXHEVdVtvsrw4jIMmtswO00Px7yjG2xxC4X/+hChOwSR3IocXnOSvP8JJKPrAxzp/inQLWND5jR6n3z8QkYvDjYUsibxDdoAYMevrkW2ww+VtA+ejZEiQj8a5Ug6RH2mYXpnFmrOleO23IyhgLuPS1YnvOsFki8/MbhPm/iUFPIPMiJVZz/2+ZPY3veZ0gw2SmiN/17xC6PVr+PxwR+f4XvY/SsRNfTvLZLfBoh88x4/BTnNGbDGj+f8U3AVcU9sfAPAzQCxigv5tH3bxBBufV37DBGtiByoGomKMTtkIg3KjS8RuBey4cEY3DGxA4OGTZhuD0XD/Z7e/n9P56WsvQOTgqP6vpPr4e72TKXkJYjb2UORtbVnktlplv8nyVap4BrM9TFSe4ft7hSr+1I4zyxOrazPly7oBierd+UXf8V9Nhmfd9ImRdob04nd8603fCGtFF6BaS/3f+t/xpWD9vx6UEbvNMzn0/hsue5092iJFZYFoz+Fv+KOW0dJNocRogotE7RueuXbGhER7YpHoSsGjr/jntPux3J3EO9T3ruN+xVmzhE/2LiXm2GWu7PqCx1Yl2L0aqwp/NPgw4QveapWz82SXEtCjgFVhG75grmHoG9sfxO+TV3W2fcbVokOF9EdinnB9SdRn7Dbpp+JYAvGt1PHTOJ/x1b0b9fYKiAUbZXVN5fizXUNJ9AniWmOTyRHlOJz/sG72JuJrFcHZpuXYb4PmWmYBsWju/H+bynBN6svKGbrEPeYLz0eW4e/VyzYJOzqJP8TZmpVhzrzq0nU/iGNkEZI2Cc676yY2TSVmV064HyfBgbNrM/l3iN+f2Fm/SYKX+X+ZNewasfzKhhktpXj03xMnl5wnTh7vvHlTKd49YdXnn7uIjdlr1t8rwQf9X6+f+48qvGm9tloJ7u8ZZ/bGgFjuOv+OdTFO6TSt8B1OLIrUYImLsHBo32GhtIOUH7B3vkERbto6+tbPryr7hIz3KcQL09li61Riyeei/LoC/L7CeeGs+8QivUWcDQVYTZJYPCOEWD71tOujfDzFwz/7kDOxsfmZ81r5uG7Fc4uSw8TiDQ8M7PMw58u2GPeNqvCxr4XfcvGsQqbEyoiYd5x6T+ViC+3bzq4TiK1XxsfdzcGiVaYr81jEt97tXjw6B5v1RH7a3qIg6We5XHLMxmWPJ6qN+qpyhtCzKgsvGHz3qDeNGJVbGm7Mwk8na3lMeayyHx2YnImN34y1dghX2cIudnImVt7et6/vEjHnnmj31QyMV0+Nf3Wa+JZ7z4eOdJyqFPol7FLZcHaedTpePSL/yTtTYoPuffwSMX7LebyQtUAVPmRRRYnxErOiKPdxxIItdOo+jOMHyqcasIg5nKgRK9PwaPNtFp2t7cS9pjHjU/EZG+FO5Q/iWz+22/Z+wl7e+8bMzCa2NjJwr/qIm+YUOnmlEAvmNWSKP+C3kwy1WDeJxQ6vNj54j1N5bz2TA4nRs1eskHf4LS2bHeiqssmGdqe3uGLx1uUhJ4kFV8/rHHmDfx2dK/pgSVx7u9rK/DXeWr7kng4Q3zq77efSV7iil+0QZEhsnd3jbvASL37TOs94ErHB8ZiNOik4aZl/Rf9wYlR+9lxfEn5lt11XqpQD4rhuDql4jksSFxzW/I8YXf6vlX6Kp983PLG+nFisxwm4/RhPiqnzeihWWW3p/msPcdmKHD+jJGLBN9sj9vfxKv1bMZUJKttYBFrdxTUNO5OeBhNzxp38bXEb98/bbpToqQpv8RU73MQThcuD35xVeefO9j1x2LC39b70gMo+pcfXRGGRYVmxhQUxehLcPy8MP34uz8kxUbnXwHNxMH68xF3fZp7KTw4vn+iPzR2b586aoHJrhrqeG45MGaupMULlWe4jNazxpL453X/VyohF/h2yi+DUfCxjym2V1yw3q7oKi2J9ktkniAUZWXdLwqH4uZTqmk2MAsamJ8ZDg36oel6TlHhMyY/k2/A0pdBN8IJYzJIcCrwP8VoJdyY5EQt+cPysHsOb2FF+of+ovE92du5z2BtnPbKWRSyO+RPjnAwxn1z/sArayPho/1buegnqoV6jFWHEyCTo16LXUGLVf+qZFbF439UDmm8hofrIE8O5xOjscpeKd1BsaGd6QdFKxnvK9nVPP4Ca+8M759NU1v6U6/YJzo9YeX5OELFBwxL9damgsf9wasR+VXi1/eJRGIITPy19M4eYE7pwnK0YoKFV6qdsAZQc5nt5UzqkR1U6D2YRGxcUX5iTAfM2X9GaFkm8I/vBd/VMMDSVZdfZELOXUpk1mRB0Ld/WfCWxwMNuxccs2Gw8dfqWkcTysnmrwrPBW6a43FjZTDxhVvHZHLizxnrx1CRi0anWHk4uPNz/Gep9VeGTlOJxeRDkOFLG2Ucs6No9vykP5m55KlpgSMzpUVvxKR/KFOH6t1jEyHBKW1ABTKYqZyV+bwIkYVlZHioEUUrusNkviMV0ke38IjAqiVYsukxsbf51eVcROG+5J/1opQrfuCw1vRhMzBsScpYR15a+ZwWXQP1OWyOuNrFovHjknlJI+M5c31nfCOj9X3rndCTghYoSSzCxJFznvb0EdDLTKsSxxLwrN+2+SKB//Mwnc51U4VuWXl1RBiPiXj1DXGLzmbbaMWWwx9Sm0WIBsaColukpA2u1zkiWJvHpE9+PHiiH+XdrT8yuawD0aOxI4w/l8PxNleurNGLrdWyHCZ8hY3a07ZN44gmt5+e4foZ9muMVw92JjZP6uV8/g5b+t8qCvcS1Rr+lS76A3VsuC7HrgTq0NvScmjcV+XqbOjKuB7PDyLwZh1BuXyK00Y56eHf/25WH/OvU84vbhyNePWydvduueeAY9UK3ZogR1sOgzoGtc729aDr7xHCUXA+siirz0+mBdFe61TQkqYcx4RYJU8CPMu0a1sLI6mHX33WTNATetCD6ig5iN8BO95H2pxhPSq/JdoAxaoBZV1Pn1KFg6uwYnxqG2wDlrPYLoWoXaNENW13EawCnG7uL7Qds6eV53n2MsAH8NJQ309N8qPoMgyEmqQFsThbNH+/No1E+tDGlDTAlyHOEg0BAu0ya08TIGuBFb8L5eeIQqvHuDQ3EboSlW/9YlvMDKKFh+Hhk3Ag+HcZvm4YC6RuOSzXRjkagl9vYYRxA5QSsNUC8RnD2HNNhg4NoDXdlCyNshH2Fa+5cQAF0jQY9AyU3wqgttSY16BIdOFnrD1PaCMMSmY326Bq97nroACNrBBOeh8TTx4/KPdo3DbGbQP11jUuoaQD1wXOjPjJuAhe1mC3bBXzq4nBpPcNtgkXHmZ9ybyFdpkdVMxeb4KPJnKgnvjxaO3BDJyNsAtmjk6GTBVdp00Uxv5ikJlgZfjCwlnOVPtVvQdqvmr/x6SNKgLK80W6A5E0w6tC1uU8gkNZM3jAGsZthb8X+WHPGierr+jQcGTfDhPMLA5+mBVPuU6PZaEczGLu7/SoYukaZL1JORbxmqHz6Y42LmZDeufTAFCRqBj2XDH81fJ3eYspdgJKb4SgwlMbgGbps2ovvTGkzvOaJ9BpMfWk3DUspI2uGu9U6taaaZ6lD2jaVjG4LfBj1l0me5kFqX8GTIcaoBaZSM52msdzpqo+RPxluCyQuuHKazbjTN2xuzkK8FjDlXpFsYAIpzv+u9jLCFujNzIhyHfKiuIUa5UxSC2QtVEjnMifoDVZm5UxpC0xvXi19x5yja0ae6GFkLWA1elG0upkPvcvlzb+MbitMPPsu4mR6EPV7X187Y9QKbTnGIbKhk/Ss/3AVw20F502t9Gnwp7s/7G5jLrZCa+0u+V1vf+qrMJaMfyu0h/WGaPo5UnHTZ09Hya2goTPh5PXB0/SNjRG/mNJWcGjOnZLmfZ1yyRpsZmStMHQt8fmqtOvUwp64/yF2G9gf/PAo9JIzNbVbVxsZt0FFLu+MKD2AytJ1b2a4baA1tD97pc5++s/VqkWI1wbrddO3fRPw6Se+VdORqA2srAYjhF5OtJ+a3Q8mqQ28j03PnsoPplZtOjcfSdpgVwrz8ibrGqUUrf/DyNogoGhnTjm6QEV0PS1mdKVQfuZvA44fn/6Vt7OSMZLCyRGTC9KRJyX731oFw5WC5dOI5EeMAzXmSGAjc1EKB9JkKY5d+2ht5uYYJJICK2/0kRCBP71+/P0aJkkKbwzWfdVEbtRtvt4kJJFCmNVe6x61HXQW/XE4kkthTP3yw+s5l2m1EA8loyuDYaGyVYv7uXRu4J9pyFgGe8Y4Kp75BFIRy3yVDFcG63K/fzGDQMpu6+MB5qIMnN1ipnSqHafNsnr/ZYQy2NLg2ll2yZXy/l1Lxl8Gi+96xU1kXaRv/uc6BUlkkPKsZIvUx55anFnbzchkcPAqj7Vy2AX6grVNJ6Mrh4pRUyyeewfS+z2udDBGcqh9OZB5hh9Nj9ceGGS4cjgUUbhsCEdTvtuK1RFPDoV7/xP7IV+qsVBB5p8cJjmvTKthztM2FVoslCyHljn1L/gQSpt8vsdCEjl0J5q7910SUIODFX2MTA5iu2+8YRqudNTgx9GI3Q7HR5/3/yK4Th3u/NPHGLWDbMXgyT6cQP2M+0r233Z4sUOP54riqLg908n+1w7S6t91vYMh1JzdcwcYYTs4OqyuMkah1AFqjR5KbodrLHWBOz+Wendzfg9T2g62wYlPl/Ta0OhLYCcja4eWQw8TMD+cunclSAuxFTDj0GConSCRUl93mez/CliKE1symHDKv4tmGK4CHBYt8m5guVA/p89XMhcVcEyL7/JpgE9R/4SPRSIFLDRTowrUHGj9E3vGomQFqP2lWOorCKNX7xxqYUoVoKjimngz1+io5+9HI7kCss2Md1gyl+mkOo9+RrcDEuYduWaPfGj+0Wdk/XfAuHfv4DATSu+1faCFdnRAqm/QDF9+JDW9u38M4nVA0VftrI9IQH0wOkD6vwMsH778OwEi6LXlvzRQcgf8a+LCs+Nfpvblv1QypR2wWA+z/1HzoCa8TibrrwOSd6acOs+PoTqTloxD7E6YdXni0ZU9ttT8oE1k/++EdZZVDvUsP+rE68gGhtsJBwNevj/DBFC1zhpk/nfCbkVGfIo4km5IvyhjhJ3gsOAfxUhOPKXxMO0Pk9QJGy5p43dMBF09lz0eSTphzdkq+5PiWLrOVK6L5J0wZdfl0QH8aKpsS5UeYithxb1T9jYa1pTH3GH/Q8ZKGLlkZkkJjqK38ipbGa4Svt8eNsxBLYB+vPuojLmoBL2T+Tr1OJ7SY9ePRyIliGRJPtne16gw03x1lKwEsRYeNcIskaYnWkxFEiXM3zS7f4FPDP3/Lu4CKqr0/+P4HXKQrmHpobsN4j7LYHdvr8r6dwFrHdwijLGxsfO4rF3/XdtB7qPDsXvswWJMwlZkdXTl9zzwmXM4q8C9r/OdPB3P9z27SFvT9OJtptXIZ5qDk5ZKQwjfQ0cfoySNdPb61TRwFywYxE9VbC9dBxdE0iO/Xb1z+yKsCyBRfE+9GhYM0oP0b1YufmG2JM1cwvbWm2BDAt0Q15Dzi3MN3i+WHuV77IGwzp1YX6yfOTUBTkylA/lee6Z5LtCP5260o/3gkgTyiu+5D4ONlqT72B27Q9WwPoKm8r13DSzckQT/nanlpWY/EAua9+DNfiZl63+zK94Nq5Qkhe/FV8JCmdh+ZtPwUZfh0nCawffk78NGC1p7dNH0WW/gr0NpX1+2N29Vi+enEB/bS/9/2cNsZzLpPNujD4N1QVTfsTygd3tYH0X2n2F79d1gl25E+u4Pr4av4Oxg8vcitmefBx9Lpss2JFWdKYSFEKr9ke3dz4E10VT4umCjfg3Mvm/Ier6HD0emEJP39UPWh+F9Hcm0Tmwv/yKsj6e9c+RDRxnh/kpqW8D29F/BkZHEKTZS/8kCvZ1dfnQ539v3gI3W9H3C9kFHw2DVW7HnCbbH3wFWepG/Vg6L0XaHBTt6lu/1fwvnhZGgcb+tvjMa1ren0XzPfyIsyOiGkKKHKQvNjiNWNmzvvwzemEpnNw3qU7EH/r4d+e4V7wDA2nByXNvL+5frsPBUWsC7ALWw3otYvLGdP9QEqxSkD+8EOJj7SW+lRu2CZ0UBsNGORMSzbkAibIgmQ9p01ZzuCL/0oWt4R+ALONueuA9vmNMzFy5JJVt4V6AQVrqS+fGVgz7NhXU25PJH1hlYB2ujqHZcu6BHu2B1DJnCuwNHYaFK1ESI6U3XzH4obrjMOwRwaSzNfRP8uPcHuL+ClB5kXQIn9K2uJpBts1ePuaCE1W6klw/rFKTA3fqQmm4HPad3hVNTaXO34BtYWCmOOv4q6qcxsL4N6c87BpNhzV1xT4+I1/MWwzorasm7BptgtSPNGbf6oFELlzqSJt45OAeXWZBxf745OrIaLgikWn/WPXhtnrvQuj1ZP0TaoCemcqXG5g4CbLQnz0eYqvziYJUdTeBdBBWsd6Ke/5oKug2Gc9LIWT3rJOTCLj70QGXJ7K3FLdZ0+Zqm8G7CQsy7+9DqYwO+Um2AhbPiUt5ROAirZGS2Ymy881lY+VJ0O8a6CtVw9hsxY8d333m+gUttqMQ7C7bP8P3siOmUPGaQL2z0pDPmsO5CAhzpTyzXn6k/1Qkuk5FFzR0GWKgW/3w8vPa3Mea5Je3Luwwa2OBAS7Ob8ocsg3UN4l+807ANLm0Sw6alX59wGNbUiV14t+EKrHwrHbH2G3GtBlb706erWcfhI+yhoEMneo/OdUUvr7s9qdnAug7h8AUV+f65IiMlA85zIPt456E/nGhH88bmhqb9CAuPpM68+1AEv7Ol4QfP/164EFa/kWqbOxCw/pH48MyEmQ3lsI+COOaxLsRFuP9b0WPGZ+u3P4RVJ0R33okwwZrnkk3WAb+1zug8lJik/ytn3YgwuDSW/jr+TvfT6bCwXQzlHYn+8MsG6d/OJYXJObDmjJjKuxLFsGQSp4qhFoZFcPZVaQHvTGyBHeyp67XF7Q9R2KiTlvLuxJUWa+660Och0aOr6jDv9Fz877miw9K3Jh97WLVXsuRdKgXs5UanWmR45AXBqkPiGN6pioVXvhDPVLjGX+0Aq05Ks3m3qhOcaBBzBzeOH9YXzvSh3/KO1TfwdAu6LFB0avMjnP1K9PmHda3UcKgnids6PuZqMVxWJ+l552oWrHosnrLNaaSL4QKBNnev1sHCSikxLXDNyW1wWZP4sYR3sOBTJmnOmIddXulgXZWo6M66WOdgpTUxDEkLyTDAepP0hneyHsA7fcnmbdXDNr2Aa63oy8usm/UBTnSkvUJuRCbaonfa/5X4He9oucPCU/F99NAdtwJgSUGu8a5WNKyqFSdavfbY2h7WO9E63tnqCBtrxdSkfkuW9YVVT8R83t36Fk60JtVH8wdvzIFTLYnrQN7hgq9Gkj8qls28OgnWW9MlvMs1By7xozlDOnwdvgJ+6Uq28E7XBri7C3kwy/3dqr/htG508BDW7aqAH4aSTn6RyxJOwco2dA/veF2FNQ/EJNW+oTVGWFcvpvKu1zO4VEb+OZ86vfI9XOBLF85nnS8b9H2XxpGArQXtDrvBgkHMusO6X4Fw2xgS4l64/k4M/M6b1PzAO2DwKW8a4TH1Q2AXONGCWPAu2AC4uzvddSEgf8ZQWO1GFBNZJ2w0rHclzkb/tk4F8PMk8jnvhk2HdR40sWLRr4cWwQZ3alfNOmLr4F1yssbpUs6cHfCEYJp+k3XFtDDrFb/3+T1t0nFY40KrLFhn7DKsd6KFniMCl1fDygbpYjzrjj2FV4bS4BLa8/J7OFFBww7wDhn61O2Tqf2m58+SPVqsqVZT7Q3WJQvCvHswXV+3NUMbD68MozlerFMmwvoAEmF6kDO8Byzclpx5t+xL2JBIy0vurk8aAZ8KJmnbWccsH85Wkk+/BISETzZbQVN512webGxDj36e76taDY/vTJVlrHO2BVbKybKfnh6ZvB/WfE5e8+7ZUbNfiMH3nnV+pIfLvGhFcwcNTgwn5/r6Vaufwpu703mTWBfNBN8WaUVZ7tFgOXrp2jCyjHfSFLAugHTtahfxIQTOdqfKbayblgSvDCFPyqdnmjJhwSR6845aX1jXKMkub+mo/N5se6rgXbVRsMaNhqfMzRlbABsTicA7azNhVRy1+nvxvXtLYaUDGc+7axvg/gFUph1bP3E3rLEl96J4h81sd5pc6aXNumC2QG7xLtttWB1Llu8wTIl7Ahv9qEUc67S9h5XepDKpy+Qs+Vt8fjmN5t02BSyYpPoBmbUTw2B5T3KzL+u4tYUN4dRnZ2PD/Y5w52R6aynrug2Axe5ktGvdHXU2vCuU3I1inbdx8LdZxOnY/VsRk2BjFB3Hu2/zYXkI7W3fFCFfCz/tQyKaO3CwcExqKNr6wfUQLE8k9rwLdxo+FU4zF6wq7WKAV3cl95SsE1cDq3zpmSe3lRsaYbUX0fJunHVji9+FE89/zj+O9oQFGUniHblQWO9J90d5+99JMduNuvOuXCdYUy+ZFkifygfC2ZF0RQrrzA2HP+WTBcnyk5X5sLIDncS7c1NgzWMxf+m63Q2lcEEURR7kyH/6C0eELP2VKXJ7g8W7kYLsXaAgU44SZNZKQaZn5vfh7N7A7vnDH7KrDAe2zQdtrXHQ1rbVgXPVqJbH2bV+HA622+NAPH/t7uy1H+K1f2F2xCF6Z/bLP89YZctnKGLX7FEt97PYfd6oludsZVcewHBtFcDwGC3I3PkVyxf8OWV4Pp+fwnMUeA6f72LzrZjXYu7Van681Vw+umX+Wav5dcz5fU2r92JpEtX/AP0fjCw=";
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
